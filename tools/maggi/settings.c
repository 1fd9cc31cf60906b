/* Parameters on the command line. */
#include "settings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"
#include "nearest.h"
#include "options.h"

int settings_init(settings *s, int argc)
{
  s->number = 0;
  s->entry = calloc((size_t)argc + 1, sizeof *s->entry);
  if (s->entry) return 0;
  message_fail(STATUS_FAILED, "out of memory");
  return -1;
}

void settings_free(settings *s)
{
  free(s->entry);
  s->entry = NULL;
  s->number = 0;
}

int settings_add(settings *s, char *text)
{
  setting *e = &s->entry[s->number];
  char *equals = strchr(text, '=');
  char option[256];
  int i;

  if (!equals || equals == text) {
    message_fail(STATUS_USAGE, "--set: \"%s\" is not of the form PATH=VALUE", text);
    return -1;
  }
  *equals = '\0';
  e->path = text;
  e->text = equals + 1;
  for (i = 0; i < s->number; ++i)
    if (strcmp(s->entry[i].path, e->path) == 0) {
      message_fail(STATUS_USAGE, "--set: %s is set twice", e->path);
      return -1;
    }
  snprintf(option, sizeof option, "--set %s", e->path);
  if (options_number(option, e->text, &e->value)) return -1;
  ++s->number;
  return 0;
}

static int unknown_path(const maggi_model *m, const char *path)
{
  maggi_model_info info;
  nearest n;
  int i;

  maggi_model_get_info(m, &info);
  nearest_init(&n, path);
  for (i = 0; i < info.parameters; ++i) nearest_offer(&n, maggi_parameter_path(m, i));
  return message_fail(STATUS_USAGE, "--set: no parameter \"%s\" in model %s%s", path, info.name,
                      nearest_hint(&n));
}

int settings_apply(const settings *s, const maggi_model *m, maggi_data *d)
{
  const setting *e;
  const char *reason;
  maggi_status status;
  int i, index;

  for (i = 0; i < s->number; ++i) {
    e = &s->entry[i];
    index = maggi_parameter_find(m, e->path);
    if (index < 0) return unknown_path(m, e->path);
    status = maggi_data_set_parameter(d, index, e->value);
    if (status == MAGGI_OK) continue;
    reason = maggi_data_message(d);
    return message_fail(STATUS_USAGE, "--set %s=%s: %s", e->path, e->text,
                        reason[0] ? reason : maggi_status_text(status));
  }
  return STATUS_DONE;
}
