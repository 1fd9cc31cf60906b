/* Computing what verify compares. */
#include "verify_work.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"
#include "stopwatch.h"

#define DIRECT_MAX       24   /* parameters of the direct method */
#define DIFFERENCE_MAX   5    /* of differences                  */
#define DIFFERENCE_LIMIT 1e-6 /* at the best perturbation        */
#define ONE_SIDED_LIMIT  1e-4

static const maggi_method difference_method[3] = {
    MAGGI_METHOD_DIFFERENCE, MAGGI_METHOD_FORWARD_DIFFERENCE, MAGGI_METHOD_BACKWARD_DIFFERENCE};

double verify_perturbation(int k)
{
  return pow(10.0, -2 - k);
}

static int pick(work *w, int n, maggi_design **design)
{
  study *s = w->v->study;

  return parameters_pick(&s->parameters, s->data, n, w->v->order, design);
}

/* Reference, order of the parameters, designs of the first of them: exit status. */
static int begin(work *w, int ndirect, int ndifference)
{
  verify *v = w->v;
  study *s = v->study;
  maggi_gradient_options o = work_ask(w, MAGGI_METHOD_ADJOINT);
  trial *t = &v->trial[TRIAL_ADJOINT];
  maggi_status status;
  int result;

  status = study_simulate(s, &v->simulation_wall);
  if (status == MAGGI_OK)
    status = work_attempt(w, TRIAL_ADJOINT, &o, s->parameters.design, s->parameters.number, 0.0);
  if (status == MAGGI_OK && t->failure[0])
    return message_fail(STATUS_FAILED, "%s: %s", s->want->model, t->failure);
  if (status != MAGGI_OK) return study_fail(s, s->data, status);
  memcpy(v->value, w->value, (size_t)s->objectives.number * sizeof *v->value);
  if (verify_sizes(v)) return message_fail(STATUS_FAILED, "out of memory");
  work_judge(v, TRIAL_ADJOINT);
  result = pick(w, ndirect, &w->direct);
  return result == STATUS_DONE ? pick(w, ndifference, &w->difference) : result;
}

static maggi_status try_snapshots(work *w)
{
  maggi_gradient_options o = work_ask(w, MAGGI_METHOD_ADJOINT);
  verify *v = w->v;
  trial *t = &v->trial[TRIAL_SNAPSHOTS];
  maggi_status status;

  o.snapshots = VERIFY_SNAPSHOTS;
  status = work_attempt(w, TRIAL_SNAPSHOTS, &o, v->study->parameters.design,
                        v->study->parameters.number, 0.0);
  v->steps = o.steps;
  v->recomputed = o.recomputed;
  work_judge(v, TRIAL_SNAPSHOTS);
  if (memcmp(t->gradient, v->trial[TRIAL_ADJOINT].gradient, work_count(v) * sizeof *t->gradient) !=
      0)
    t->pass = 0;
  return status;
}

static maggi_status try_direct(work *w, int n)
{
  maggi_gradient_options o = work_ask(w, MAGGI_METHOD_DIRECT);
  maggi_status status = work_attempt(w, TRIAL_DIRECT, &o, w->direct, n, w->v->limit);

  work_judge(w->v, TRIAL_DIRECT);
  return status;
}

/* Both adjoints with half the step: if they go to the same gradient, they are no further from each
 * other than both have moved, or little. */
static maggi_status try_half(work *w)
{
  verify *v = w->v;
  const maggi_design *design = v->study->parameters.design;
  int n = v->study->parameters.number;
  maggi_gradient_options o = work_ask(w, MAGGI_METHOD_ADJOINT);
  trial *t = &v->trial[TRIAL_CONTINUOUS];
  maggi_status status;

  o.step /= 2.0;
  status = work_compute(w, &o, design, n, w->half);
  ++w->done;
  if (status != MAGGI_OK) return status;
  v->truncation = verify_distance(v, v->trial[TRIAL_ADJOINT].gradient, w->half, n, NULL);
  o.method = MAGGI_METHOD_CONTINUOUS_ADJOINT;
  status = work_compute(w, &o, design, n, w->other);
  ++w->done;
  if (status != MAGGI_OK) return status;
  v->half_error = verify_distance(v, w->other, w->half, n, NULL);
  if (v->half_error > 0.0) v->order_seen = log2(t->error / v->half_error);
  t->limit = 2.0 * (v->truncation + verify_distance(v, t->gradient, w->other, n, NULL));
  return MAGGI_OK;
}

static maggi_status try_continuous(work *w)
{
  verify *v = w->v;
  maggi_gradient_options o = work_ask(w, MAGGI_METHOD_CONTINUOUS_ADJOINT);
  trial *t = &v->trial[TRIAL_CONTINUOUS];
  maggi_status status;

  v->half_error = v->order_seen = v->truncation = NAN;
  status = work_attempt(w, TRIAL_CONTINUOUS, &o, v->study->parameters.design,
                        v->study->parameters.number, 0.0);
  work_judge(v, TRIAL_CONTINUOUS);
  if (status == MAGGI_OK && t->failure[0] == '\0') status = try_half(w);
  if (work_is_end(status)) return status;
  if (status != MAGGI_OK) work_note_failure(t, v->study->data, status);
  t->limit = fmax(t->limit, v->limit);
  work_judge(v, TRIAL_CONTINUOUS);
  return MAGGI_OK;
}

/* One kind of difference with all perturbations. */
static maggi_status try_difference(work *w, int kind, int n)
{
  verify *v = w->v;
  trial_kind name = (trial_kind)(TRIAL_DIFFERENCE + kind);
  trial *t = &v->trial[name];
  maggi_gradient_options o = work_ask(w, difference_method[kind]);
  double *error = v->perturbation_error[kind], begin;
  maggi_status status;
  int k;

  t->parameters = n;
  t->limit = kind == 0 ? DIFFERENCE_LIMIT : ONE_SIDED_LIMIT;
  t->wall = INFINITY;
  v->best[kind] = -1;
  for (k = 0; k < VERIFY_PERTURBATIONS; ++k) {
    o.perturbation = verify_perturbation(k);
    begin = stopwatch_now();
    status = work_compute(w, &o, w->difference, n, w->other);
    ++w->done;
    if (work_is_end(status)) return status;
    error[k] = verify_distance(v, w->other, v->trial[TRIAL_ADJOINT].gradient, n, NULL);
    if (status != MAGGI_OK || isnan(error[k])) continue;
    t->wall = fmin(t->wall, stopwatch_now() - begin);
    if (v->best[kind] >= 0 && !(error[k] < error[v->best[kind]])) continue;
    v->best[kind] = k;
    memcpy(t->gradient, w->other, work_count(v) * sizeof *t->gradient);
  }
  if (v->best[kind] < 0)
    snprintf(t->failure, sizeof t->failure, "no perturbation gives a simulation");
  work_judge(v, name);
  return MAGGI_OK;
}

/* Exit status. */
static int try_all(work *w)
{
  verify *v = w->v;
  int number = v->study->parameters.number, kind;
  int ndirect = number < DIRECT_MAX ? number : DIRECT_MAX;
  int ndifference = number < DIFFERENCE_MAX ? number : DIFFERENCE_MAX;
  maggi_status status;
  int result;

  result = begin(w, ndirect, ndifference);
  if (result != STATUS_DONE) return result;
  status = try_snapshots(w);
  if (status == MAGGI_OK) status = try_direct(w, ndirect);
  if (status == MAGGI_OK) status = try_continuous(w);
  for (kind = 0; kind < 3 && status == MAGGI_OK; ++kind)
    status = try_difference(w, kind, ndifference);
  if (status != MAGGI_OK) return study_fail(v->study, v->study->data, status);
  for (v->pass = 1, kind = 0; kind < TRIAL_COUNT; ++kind) v->pass &= v->trial[kind].pass;
  return STATUS_DONE;
}

int verify_run(verify *v)
{
  work w;
  int failed = work_init(&w, v), status;

  progress_begin(&w.progress, 1);
  status = failed ? message_fail(STATUS_FAILED, "out of memory") : try_all(&w);
  progress_end(&w.progress);
  work_free(&w);
  return status;
}

void verify_free(verify *v)
{
  int i;

  for (i = 0; i < TRIAL_COUNT; ++i) free(v->trial[i].gradient);
  free(v->order);
  free(v->scale);
  free(v->size);
  free(v->value);
}
