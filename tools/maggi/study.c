/* A model with objectives and design parameters. */
#include "study.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "interrupt.h"
#include "message.h"
#include "plan.h"
#include "stopwatch.h"
#include "table.h"

int study_take(study_request *r, options *o, int id)
{
  switch (id) {
  case OPTIONS_ARGUMENT:
    return options_argument(o, "MODEL", &r->model);
  case STUDY_OBJECTIVE:
    r->objectives = o->value;
    return 0;
  case STUDY_PARAMETERS:
    r->parameters = o->value;
    return 0;
  case STUDY_TIME:
    return options_positive("--time", o->value, &r->time);
  case STUDY_STEP:
    return options_positive("--step", o->value, &r->step);
  case STUDY_SET:
    return settings_add(&r->set, o->value);
  case STUDY_TOLERANCE:
    return options_positive("--tolerance", o->value, &r->tolerance);
  case STUDY_PLOT:
    return options_file("--plot", o->value, &r->plot);
  case STUDY_JSON:
    r->json = 1;
    return 0;
  default: /* OPTIONS_WRONG */
    return -1;
  }
}

int study_data(const study *s, maggi_data **data)
{
  int status;

  if (maggi_data_create(s->model, data) != MAGGI_OK)
    return message_fail(STATUS_FAILED, "%s: out of memory", s->want->model);
  status = formulation_tolerance(&s->want->formulation, *data, s->want->tolerance);
  return status == STATUS_DONE ? settings_apply(&s->want->set, s->model, *data) : status;
}

/* All names that `name` gives for 0, 1, .. */
static int add_declared(names *list, const maggi_model *m,
                        const char *(*name)(const maggi_model *m, int index))
{
  const char *text;
  int i;

  for (i = 0; (text = name(m, i)) != NULL; ++i)
    if (names_add(list, text, strlen(text))) return message_fail(STATUS_FAILED, "out of memory");
  return STATUS_DONE;
}

static int choose_objectives(study *s, int (*propose)(study *s))
{
  names *list = &s->objective_names;
  int status;

  if (s->want->objectives)
    status = names_split(list, "--objective", s->want->objectives);
  else
    status = add_declared(list, s->model, maggi_model_objective);
  if (status == STATUS_DONE && list->number == 0) {
    if (!propose)
      return message_fail(STATUS_USAGE,
                          "%s: the model declares no objective; give one, as in --objective "
                          "\"rms(%s)\"",
                          s->want->model, maggi_signal_name(s->model, 0));
    status = propose(s);
  }
  return status == STATUS_DONE ? objectives_create(&s->objectives, s->model, list) : status;
}

static int choose_parameters(study *s)
{
  const char *list = s->want->parameters;
  int status;

  if (!list && !maggi_model_design(s->model, 0)) list = "all";
  status = list ? names_split(&s->items, "--parameters", list)
                : add_declared(&s->items, s->model, maggi_model_design);
  if (status == STATUS_DONE)
    status = parameters_create(&s->parameters, s->model, s->data, &s->items);
  if (status == STATUS_DONE && s->parameters.number == 0)
    status = message_fail(STATUS_FAILED, "%s: the model has no parameters", s->want->model);
  return status;
}

int study_open(study *s, const study_request *want, int (*propose)(study *s))
{
  int status;

  memset(s, 0, sizeof *s);
  s->want = want;
  status = models_open(want->model, &s->model, s->path);
  if (status != STATUS_DONE) return status;
  maggi_model_get_info(s->model, &s->info);
  status = plan_grid(&s->info, want->time, want->step, &s->grid);
  if (status == STATUS_DONE) status = study_data(s, &s->data);
  if (status == STATUS_DONE) status = choose_objectives(s, propose);
  if (status == STATUS_DONE) status = choose_parameters(s);
  return status;
}

void study_close(study *s)
{
  objectives_free(&s->objectives);
  parameters_free(&s->parameters);
  names_free(&s->objective_names);
  names_free(&s->items);
  maggi_data_free(s->data);
  maggi_model_free(s->model);
}

int study_output(const study *s, const char *name)
{
  if (name && table_is_same_file(name, s->path))
    return message_fail(STATUS_FAILED, "%s: is the model file", name);
  return STATUS_DONE;
}

static maggi_status simulate_once(const study *s, maggi_penalty *penalty)
{
  maggi_status status = formulation_reset(s->data, penalty);
  double t = 0.0, next;
  long k;

  for (k = 0; k < s->grid.steps && status == MAGGI_OK; ++k) {
    if (interrupt_seen()) return MAGGI_E_STOPPED;
    next = maggi_grid_time(&s->grid, k + 1);
    status = formulation_step(s->data, penalty, next - t);
    t = next;
  }
  return status;
}

maggi_status study_simulate(const study *s, double *seconds)
{
  maggi_penalty *penalty;
  maggi_status status = formulation_create(&s->want->formulation, s->data, &penalty);
  stopwatch w;

  for (stopwatch_start(&w); status == MAGGI_OK && stopwatch_again(&w); stopwatch_lap(&w))
    status = simulate_once(s, penalty);
  *seconds = w.best;
  maggi_penalty_free(penalty);
  return status;
}

int study_fail(const study *s, const maggi_data *d, maggi_status status)
{
  const char *reason = maggi_data_message(d);

  if (status == MAGGI_E_STOPPED) return STATUS_INTERRUPTED;
  return message_fail(STATUS_FAILED, "%s: %s", s->want->model,
                      reason[0] ? reason : maggi_status_text(status));
}
