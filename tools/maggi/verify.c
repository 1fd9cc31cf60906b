/* maggi verify: the proof that the gradients of a model are right. */
#include <stdio.h>
#include <string.h>

#include <maggi/maggi.h>

#include "commands.h"
#include "interrupt.h"
#include "message.h"
#include "options.h"
#include "plan.h"
#include "script.h"
#include "study.h"
#include "verify.h"

typedef struct request {
  study_request study;
  double limit;
} request;

enum { LIMIT = STUDY_OPTIONS };

static const option_def verify_options[] = {
    STUDY_OPTION_LIST, [LIMIT] = {"--limit", OPTION_VALUE, "an error"}, {NULL, OPTION_FLAG, NULL}};

#define LIMIT_DEFAULT 1e-10

/* Objectives for a model that declares none. */
static int propose(study *s)
{
  char position[512], velocity[512];
  const char *name;
  int i;

  for (i = 0; i + 1 < s->info.coordinates && maggi_coordinate_is_guided(s->model, i); ++i)
    ;
  name = maggi_coordinate_name(s->model, i);
  snprintf(position, sizeof position, "integral_square(%s.q)", name ? name : "");
  snprintf(velocity, sizeof velocity, "terminal(%s.v)", name ? name : "");
  if ((name && names_add(&s->objective_names, position, strlen(position))) ||
      (name && names_add(&s->objective_names, velocity, strlen(velocity))) ||
      names_add(&s->objective_names, "rms(energy.kinetic)", strlen("rms(energy.kinetic)")))
    return message_fail(STATUS_FAILED, "out of memory");
  return STATUS_DONE;
}

static int draw(const verify *v, const char *out)
{
  FILE *input = script_input(&script_plot);

  if (!input) return STATUS_FAILED;
  verify_json(v, input);
  return script_draw(&script_plot, input, out);
}

static int verify_study(study *s, const request *want)
{
  const char *plot = want->study.plot;
  verify v;
  int status;

  memset(&v, 0, sizeof v);
  v.study = s;
  v.limit = want->limit;
  status = study_output(s, plot);
  if (status == STATUS_DONE && plot) status = script_check(&script_plot, plot);
  interrupt_catch();
  if (status == STATUS_DONE) status = verify_run(&v);
  if (status == STATUS_DONE && plot) status = draw(&v, plot);
  if (status == STATUS_DONE) {
    plan_note(&s->grid);
    (want->study.json ? verify_json : verify_text)(&v, stdout);
    if (!v.pass) status = STATUS_FAILED;
  }
  verify_free(&v);
  return status;
}

static int verify_model(const request *want)
{
  study s;
  int status;

  status = study_open(&s, &want->study, propose);
  if (status == STATUS_DONE) status = verify_study(&s, want);
  study_close(&s);
  return status;
}

static int take(request *r, options *o, int id)
{
  if (id == LIMIT) return options_positive("--limit", o->value, &r->limit);
  return study_take(&r->study, o, id);
}

int command_verify(int argc, char **argv)
{
  request want;
  options o;
  int id, status = STATUS_DONE;

  memset(&want, 0, sizeof want);
  want.limit = LIMIT_DEFAULT;
  if (settings_init(&want.study.set, argc)) return STATUS_FAILED;
  options_init(&o, verify_options, argc, argv);
  while ((id = options_next(&o)) != OPTIONS_END) {
    if (id == OPTIONS_HELP) {
      fputs(help_text("verify"), stdout);
      break;
    }
    if (take(&want, &o, id)) {
      status = STATUS_USAGE;
      break;
    }
  }
  if (id == OPTIONS_END)
    status = want.study.model ? verify_model(&want)
                              : message_fail(STATUS_USAGE, "verify: no MODEL given");
  settings_free(&want.study.set);
  return status;
}
