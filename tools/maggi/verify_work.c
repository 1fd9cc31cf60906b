/* Gradients for verify. */
#include "verify_work.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "interrupt.h"
#include "stopwatch.h"

int work_init(work *w, verify *v)
{
  static const char *const name[TRIAL_COUNT] = {"adjoint",
                                                "adjoint, 10 snapshots",
                                                "direct",
                                                "continuous-adjoint",
                                                "difference",
                                                "forward-difference",
                                                "backward-difference"};
  size_t n = (size_t)v->study->parameters.number, nobjective = (size_t)v->study->objectives.number;
  int i, failed;

  memset(w, 0, sizeof *w);
  w->v = v;
  v->order = calloc(n, sizeof *v->order);
  v->scale = calloc(n, sizeof *v->scale);
  v->size = calloc(nobjective, sizeof *v->size);
  v->value = calloc(nobjective, sizeof *v->value);
  w->raw = calloc(n * nobjective, sizeof *w->raw);
  w->other = calloc(n * nobjective, sizeof *w->other);
  w->half = calloc(n * nobjective, sizeof *w->half);
  w->value = calloc(nobjective, sizeof *w->value);
  failed = !v->order || !v->scale || !v->size || !v->value || !w->raw || !w->other || !w->half ||
           !w->value;
  for (i = 0; i < TRIAL_COUNT; ++i) {
    v->trial[i].name = name[i];
    v->trial[i].gradient = calloc(n * nobjective, sizeof *v->trial[i].gradient);
    failed = failed || !v->trial[i].gradient;
  }
  return failed ? -1 : 0;
}

void work_free(work *w)
{
  maggi_design_free(w->direct);
  maggi_design_free(w->difference);
  free(w->raw);
  free(w->other);
  free(w->half);
  free(w->value);
}

size_t work_count(const verify *v)
{
  return (size_t)v->study->objectives.number * (size_t)v->study->parameters.number;
}

static int watch(void *context, double part)
{
  work *w = context;

  progress_part(&w->progress, stopwatch_now(), (w->done + part) / WORK_GRADIENTS);
  return interrupt_seen();
}

maggi_gradient_options work_ask(work *w, maggi_method method)
{
  maggi_gradient_options o;

  maggi_gradient_options_init(&o);
  o.time = w->v->study->grid.time;
  o.step = w->v->study->grid.step;
  o.method = method;
  o.progress = watch;
  o.context = w;
  return o;
}

maggi_status work_compute(work *w, maggi_gradient_options *o, const maggi_design *design, int n,
                          double *gradient)
{
  verify *v = w->v;
  study *s = v->study;
  int is_picked = design != s->parameters.design, i, k;
  size_t number = (size_t)s->parameters.number;
  maggi_status status;

  status = maggi_gradient(s->data, design, s->objectives.number, s->objectives.objective, o,
                          w->value, w->raw);
  for (i = 0; i < s->objectives.number; ++i) {
    for (k = 0; k < s->parameters.number; ++k) gradient[(size_t)i * number + (size_t)k] = NAN;
    for (k = 0; k < n && status == MAGGI_OK; ++k)
      gradient[(size_t)i * number + (size_t)(is_picked ? v->order[k] : k)] = w->raw[i * n + k];
  }
  return status;
}

int work_is_end(maggi_status status)
{
  return status == MAGGI_E_STOPPED || status == MAGGI_E_MEMORY;
}

void work_note_failure(trial *t, const maggi_data *d, maggi_status status)
{
  const char *reason = maggi_data_message(d);

  snprintf(t->failure, sizeof t->failure, "%s", reason[0] ? reason : maggi_status_text(status));
}

maggi_status work_attempt(work *w, trial_kind kind, maggi_gradient_options *o,
                          const maggi_design *design, int n, double limit)
{
  trial *t = &w->v->trial[kind];
  maggi_status status = MAGGI_OK;
  stopwatch clock;

  t->parameters = n;
  t->limit = limit;
  for (stopwatch_start(&clock); status == MAGGI_OK && stopwatch_again(&clock);
       stopwatch_lap(&clock))
    status = work_compute(w, o, design, n, t->gradient);
  ++w->done;
  t->wall = clock.best;
  if (status == MAGGI_OK || work_is_end(status)) return status;
  work_note_failure(t, w->v->study->data, status);
  return MAGGI_OK;
}

void work_judge(verify *v, trial_kind kind)
{
  trial *t = &v->trial[kind];

  t->error = verify_distance(v, t->gradient, v->trial[TRIAL_ADJOINT].gradient, t->parameters,
                             &t->objective);
  t->pass = t->failure[0] == '\0' && t->error <= t->limit;
}
