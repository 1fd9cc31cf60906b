/* What the commands equilibrium and modes share: the command line, a model in static equilibrium. */
#include "standstill.h"

#include <stdio.h>
#include <string.h>

#include "commands.h"
#include "message.h"
#include "models.h"
#include "options.h"

enum { SET, JSON };

static const option_def standstill_options[] = {[SET] = {"--set", OPTION_LIST, "PATH=VALUE"},
                                                [JSON] = {"--json", OPTION_FLAG, NULL},
                                                {NULL, OPTION_FLAG, NULL}};

/* One option or argument: 0, or -1 after a message. */
static int take(standstill *s, options *o, int id)
{
  switch (id) {
  case OPTIONS_ARGUMENT:
    return options_argument(o, "MODEL", &s->spec);
  case SET:
    return settings_add(&s->set, o->value);
  case JSON:
    s->json = 1;
    return 0;
  default: /* OPTIONS_WRONG */
    return -1;
  }
}

static int find(standstill *s)
{
  maggi_status status = maggi_data_reset(s->data);
  const char *reason = maggi_data_message(s->data);

  if (status != MAGGI_OK)
    return message_fail(STATUS_FAILED, "%s: %s", s->spec,
                        reason[0] ? reason : maggi_status_text(status));
  if (maggi_get_equilibrium(s->data, &s->state) != MAGGI_OK)
    return message_fail(STATUS_FAILED, "%s: the model does not say start: {equilibrium: true}",
                        s->spec);
  return STATUS_DONE;
}

static int open_and_show(standstill *s, int (*show)(const standstill *s))
{
  char path[MODELS_PATH_MAX];
  int status = models_open(s->spec, &s->model, path);

  if (status != STATUS_DONE) return status;
  maggi_model_get_info(s->model, &s->info);
  if (maggi_data_create(s->model, &s->data) != MAGGI_OK)
    status = message_fail(STATUS_FAILED, "%s: out of memory", s->spec);
  else
    status = settings_apply(&s->set, s->model, s->data);
  if (status == STATUS_DONE) status = find(s);
  if (status == STATUS_DONE) status = show(s);
  maggi_data_free(s->data);
  maggi_model_free(s->model);
  return status;
}

int standstill_run(int argc, char **argv, int (*show)(const standstill *s))
{
  standstill s;
  options o;
  int id, status = STATUS_DONE;

  memset(&s, 0, sizeof s);
  if (settings_init(&s.set, argc)) return STATUS_FAILED;
  options_init(&o, standstill_options, argc, argv);
  while ((id = options_next(&o)) != OPTIONS_END) {
    if (id == OPTIONS_HELP) {
      fputs(help_text(argv[0]), stdout);
      break;
    }
    if (take(&s, &o, id)) {
      status = STATUS_USAGE;
      break;
    }
  }
  if (id == OPTIONS_END && !s.spec)
    status = message_fail(STATUS_USAGE, "%s: no MODEL given", argv[0]);
  if (id == OPTIONS_END && s.spec) status = open_and_show(&s, show);
  settings_free(&s.set);
  return status;
}
