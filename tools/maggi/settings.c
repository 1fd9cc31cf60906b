/* Parameters on the command line. */
#include "settings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"
#include "nearest.h"
#include "options.h"
#include "sheet.h"

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

static int unknown_name(const maggi_model *m, const char *name)
{
  maggi_model_info info;
  nearest n;
  int i;

  maggi_model_get_info(m, &info);
  nearest_init(&n, name);
  for (i = 0; i < info.parameters; ++i) nearest_offer(&n, maggi_parameter_path(m, i));
  for (i = 0; maggi_model_design(m, i); ++i) nearest_offer(&n, maggi_model_design(m, i));
  return message_fail(STATUS_USAGE, "--set: no parameter \"%s\" in model %s%s", name, info.name,
                      nearest_hint(&n));
}

static int is_design(const maggi_model *m, const char *name)
{
  int i;

  for (i = 0; maggi_model_design(m, i); ++i)
    if (strcmp(maggi_model_design(m, i), name) == 0) return 1;
  return 0;
}

static int fail_data(const setting *e, const maggi_data *d, maggi_status status)
{
  const char *reason = maggi_data_message(d);

  return message_fail(status == MAGGI_E_MEMORY ? STATUS_FAILED : STATUS_USAGE, "--set %s=%s: %s",
                      e->path, e->text, reason[0] ? reason : maggi_status_text(status));
}

static int out_of_memory(void)
{
  return message_fail(STATUS_FAILED, "out of memory");
}

/* Add the design parameter of a setting and set it, and those before, to their values. */
static int set_design(const setting *e, maggi_data *d, maggi_design *design, double *values)
{
  char text[256];
  maggi_status status;

  status = maggi_design_select(design, e->path, text, sizeof text);
  if (status == MAGGI_E_MEMORY) return out_of_memory();
  if (status != MAGGI_OK) return message_fail(STATUS_USAGE, "--set %s: %s", e->path, text);
  values[maggi_design_number(design) - 1] = e->value;
  status = maggi_design_set(design, d, values);
  return status == MAGGI_OK ? STATUS_DONE : fail_data(e, d, status);
}

/* Those settings that are design parameters. */
static int apply_design(const settings *s, const maggi_model *m, maggi_data *d)
{
  maggi_design *design = NULL;
  double *values = calloc((size_t)s->number + 1, sizeof *values);
  int i, status = STATUS_DONE;

  if (!values || maggi_design_create(d, &design) != MAGGI_OK) status = out_of_memory();
  for (i = 0; i < s->number && status == STATUS_DONE; ++i)
    if (is_design(m, s->entry[i].path)) status = set_design(&s->entry[i], d, design, values);
  maggi_design_free(design);
  free(values);
  return status;
}

/* Sets all entries that a glob stands for; *number: how many. */
static int set_glob(const setting *e, const maggi_model *m, maggi_data *d, int *number)
{
  const char *path;
  maggi_status status;
  int i;

  *number = 0;
  for (i = 0; (path = maggi_parameter_path(m, i)) != NULL; ++i) {
    if (!sheet_wants(path, e->path)) continue;
    status = maggi_data_set_parameter(d, i, e->value);
    if (status != MAGGI_OK) return fail_data(e, d, status);
    ++*number;
  }
  return STATUS_DONE;
}

int settings_apply(const settings *s, const maggi_model *m, maggi_data *d)
{
  int i, status, number, designs = 0;

  for (i = 0; i < s->number; ++i) {
    if (is_design(m, s->entry[i].path)) {
      ++designs;
      continue;
    }
    status = set_glob(&s->entry[i], m, d, &number);
    if (status != STATUS_DONE) return status;
    if (number == 0) return unknown_name(m, s->entry[i].path);
  }
  return designs ? apply_design(s, m, d) : STATUS_DONE;
}
