/* Objectives of a simulation and their gradients: the simulation, then the method that is asked for. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study.h"

static const char *const method_words[] = {"direct",
                                           "adjoint",
                                           "continuous-adjoint",
                                           "difference",
                                           "forward-difference",
                                           "backward-difference"};

const char *maggi_method_name(maggi_method method)
{
  return (int)method >= 0 && method < MAGGI_METHOD_COUNT ? method_words[method] : NULL;
}

int maggi_method_find(const char *name)
{
  int i;

  for (i = 0; i < MAGGI_METHOD_COUNT; ++i)
    if (strcmp(method_words[i], name) == 0) return i;
  return -1;
}

void maggi_gradient_options_init(maggi_gradient_options *options)
{
  memset(options, 0, sizeof *options);
  options->method = MAGGI_METHOD_ADJOINT;
  options->perturbation = 1e-6;
  options->memory = (size_t)1 << 30;
}

/* ---------------------------------------------------------------------------- one simulation */

double maggi_study_step(const maggi_study *s, long k)
{
  return maggi_grid_time(&s->grid, k + 1) - maggi_grid_time(&s->grid, k);
}

maggi_status maggi_study_advance(maggi_study *s, long k)
{
  double h = maggi_study_step(s, k);

  return s->penalty ? maggi_penalty_step(s->penalty, h) : maggi_step(s->d, h);
}

maggi_status maggi_study_progress(maggi_study *s, double done)
{
  const maggi_gradient_options *o = s->options;

  if (!o->progress || !o->progress(o->context, s->begin + s->share * done)) return MAGGI_OK;
  return maggi_data_fail(s->d, MAGGI_E_STOPPED, "stopped by the caller");
}

maggi_status maggi_study_begin(maggi_study *s)
{
  maggi_status status = MAGGI_OK;
  int i;

  for (i = 0; i < s->n && status == MAGGI_OK; ++i)
    status = maggi_objective_begin(s->objective[i], &s->grid, s->d->message, sizeof s->d->message);
  return status;
}

void maggi_study_push(maggi_study *s, long k)
{
  int i;

  maggi_get_signals(s->d, s->nsignal, s->signal, s->sample);
  for (i = 0; i < s->n; ++i) maggi_objective_push(s->objective[i], k, s->sample + s->first[i]);
}

maggi_status maggi_study_end(maggi_study *s)
{
  maggi_status status = MAGGI_OK;
  int i;

  for (i = 0; i < s->n && status == MAGGI_OK; ++i)
    status =
        maggi_objective_end(s->objective[i], &s->value[i], s->d->message, sizeof s->d->message);
  return status;
}

maggi_status maggi_study_simulate(maggi_study *s)
{
  maggi_status status;
  long k;

  status = maggi_data_reset(s->d);
  if (status == MAGGI_OK) status = maggi_study_begin(s);
  if (status != MAGGI_OK) return status;
  maggi_study_push(s, 0);
  for (k = 0; k < s->grid.steps && status == MAGGI_OK; ++k) {
    status = maggi_study_advance(s, k);
    if (status != MAGGI_OK) return status;
    maggi_study_push(s, k + 1);
    status = maggi_study_progress(s, (double)(k + 1) / (double)s->grid.steps);
  }
  return status == MAGGI_OK ? maggi_study_end(s) : status;
}

int maggi_study_weights(maggi_study *s, int i, long k, const int **signal, const double **weight)
{
  *signal = s->signal + s->first[i];
  *weight = s->weight + s->first[i];
  if (!maggi_objective_weights(s->objective[i], k, s->sample + s->first[i],
                               s->weight + s->first[i]))
    return 0;
  return s->first[i + 1] - s->first[i];
}

maggi_status maggi_study_differentiable(maggi_study *s)
{
  maggi_status status = MAGGI_OK;
  int i;

  for (i = 0; i < s->n && status == MAGGI_OK; ++i)
    status = maggi_objective_differentiable(s->objective[i], s->d->message, sizeof s->d->message);
  return status;
}

/* -------------------------------------------------------------------------------- the function */

static int list_signals(maggi_study *s)
{
  const int *signal;
  int i, n;

  s->first = calloc((size_t)s->n + 1, sizeof *s->first);
  if (!s->first) return 0;
  for (i = 0; i < s->n; ++i)
    s->first[i + 1] = s->first[i] + maggi_objective_signals(s->objective[i], &signal);
  s->nsignal = s->first[s->n];
  s->signal = calloc((size_t)s->nsignal + 1, sizeof *s->signal);
  s->sample = calloc((size_t)s->nsignal + 1, sizeof *s->sample);
  s->weight = calloc((size_t)s->nsignal + 1, sizeof *s->weight);
  if (!s->signal || !s->sample || !s->weight) return 0;
  for (i = 0; i < s->n; ++i) {
    n = maggi_objective_signals(s->objective[i], &signal);
    memcpy(s->signal + s->first[i], signal, (size_t)n * sizeof *signal);
  }
  return 1;
}

static maggi_status run_method(maggi_study *s)
{
  s->share = 1.0;
  if (!s->gradient) return maggi_study_simulate(s);
  switch (s->options->method) {
  case MAGGI_METHOD_DIRECT:
    return maggi_gradient_direct(s);
  case MAGGI_METHOD_ADJOINT:
    return s->penalty ? maggi_gradient_penalty_adjoint(s) : maggi_gradient_adjoint(s);
  case MAGGI_METHOD_CONTINUOUS_ADJOINT:
    return maggi_gradient_adjoint(s);
  default:
    return maggi_gradient_difference(s);
  }
}

/* derivatives are those of the solution of Newton's method, which must be one */
static maggi_status choose_formulation(maggi_study *s)
{
  maggi_penalty_options o;

  if (!s->options->penalty) return MAGGI_OK;
  if (s->options->method == MAGGI_METHOD_CONTINUOUS_ADJOINT)
    return maggi_data_fail(s->d, MAGGI_E_VALUE,
                           "the continuous adjoint method has no penalty formulation");
  o = *s->options->penalty;
  o.tolerance = fmin(o.tolerance, 1e-12);
  return maggi_penalty_create(s->d, &o, &s->penalty);
}

static maggi_status check_options(maggi_study *s)
{
  const maggi_gradient_options *o = s->options;

  if ((int)o->method < 0 || o->method >= MAGGI_METHOD_COUNT)
    return maggi_data_fail(s->d, MAGGI_E_VALUE, "method %d does not exist", (int)o->method);
  if (!isfinite(o->perturbation) || !(o->perturbation > 0.0))
    return maggi_data_fail(s->d, MAGGI_E_VALUE, "the perturbation must be positive");
  if (o->snapshots < 0)
    return maggi_data_fail(s->d, MAGGI_E_VALUE, "the number of snapshots must not be negative");
  if (maggi_grid_init(&s->grid, o->time, o->step) != MAGGI_OK)
    return maggi_data_fail(s->d, MAGGI_E_VALUE,
                           "time and step must be positive, with at most 1e9 steps");
  return MAGGI_OK;
}

maggi_status maggi_gradient(maggi_data *d, const maggi_design *design, int nobjective,
                            maggi_objective *const *objective, maggi_gradient_options *options,
                            double *value, double *gradient)
{
  maggi_study s = {.d = d,
                   .design = design,
                   .n = nobjective,
                   .objective = objective,
                   .options = options,
                   .value = value,
                   .gradient = gradient};
  maggi_status status = check_options(&s);

  if (status != MAGGI_OK) return status;
  options->steps = s.grid.steps;
  options->recomputed = options->kept = 0;
  status = choose_formulation(&s);
  if (status == MAGGI_OK && !list_signals(&s))
    status = maggi_data_fail(d, MAGGI_E_MEMORY, "out of memory");
  if (status == MAGGI_OK) status = run_method(&s);
  maggi_penalty_free(s.penalty);
  free(s.first);
  free(s.signal);
  free(s.sample);
  free(s.weight);
  return status;
}
