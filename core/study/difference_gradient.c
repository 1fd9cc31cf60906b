/* Gradients by differences of whole simulations.  [1] 5.2 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study.h"

typedef struct work {
  maggi_study *s;
  double *p, *direction; /* (np) */
  double *value;         /* at the other point (n) */
  int simulations, done;
} work;

/* objectives at the parameters moved by `step` along the direction of parameter j, into value */
static maggi_status simulate(work *w, int j, double step, double *value)
{
  maggi_study *s = w->s;
  char reason[sizeof s->d->message];
  maggi_status status;
  int i;

  s->share = 1.0 / w->simulations;
  s->begin = w->done++ * s->share;
  for (i = 0; i < s->d->t.np; ++i) s->d->p[i] = w->p[i] + step * w->direction[i];
  status = maggi_study_simulate(s);
  memcpy(value, s->value, (size_t)s->n * sizeof(double));
  if (status == MAGGI_OK || status == MAGGI_E_STOPPED || step == 0.0) return status;
  memcpy(reason, s->d->message, sizeof reason);
  return maggi_data_fail(s->d, status, "with \"%s\" moved by %.3g: %s",
                         maggi_design_name(s->design, j), step, reason);
}

static maggi_status differentiate(work *w, const double *middle, int j)
{
  maggi_study *s = w->s;
  maggi_method method = s->options->method;
  double h = fabs(maggi_design_value(s->design, j)), ahead, behind, *other;
  maggi_status status;
  int i, n = maggi_design_number(s->design);

  h = s->options->perturbation * (h > 0.0 ? h : 1.0);
  ahead = method == MAGGI_METHOD_BACKWARD_DIFFERENCE ? 0.0 : h;
  behind = method == MAGGI_METHOD_FORWARD_DIFFERENCE ? 0.0 : -h;
  maggi_design_directions(s->design, j, 1, 1, w->direction);
  memcpy(w->value, middle, (size_t)s->n * sizeof(double));
  other = w->value + s->n;
  memcpy(other, middle, (size_t)s->n * sizeof(double));
  status = ahead != 0.0 ? simulate(w, j, ahead, w->value) : MAGGI_OK;
  if (status == MAGGI_OK && behind != 0.0) status = simulate(w, j, behind, other);
  for (i = 0; i < s->n && status == MAGGI_OK; ++i)
    s->gradient[i * n + j] = (w->value[i] - other[i]) / (ahead - behind);
  return status;
}

/* The independent coordinates of the initial position are those of the middle: a choice between equals must
 * not change with the last digits. */
static maggi_status hold_start(maggi_data *d)
{
  maggi_status status = maggi_data_reset(d);

  if (status == MAGGI_OK) maggi_hold_choice(d);
  return status;
}

static maggi_status run(work *w)
{
  maggi_study *s = w->s;
  int j, n = maggi_design_number(s->design);
  double *middle = w->value + 2 * s->n;
  maggi_status status;

  w->simulations = 1 + n * (s->options->method == MAGGI_METHOD_DIFFERENCE ? 2 : 1);
  status = simulate(w, 0, 0.0, middle);
  if (status == MAGGI_OK) status = maggi_study_differentiable(s);
  if (status == MAGGI_OK) status = hold_start(s->d);
  for (j = 0; j < n && status == MAGGI_OK; ++j) status = differentiate(w, middle, j);
  memcpy(s->value, middle, (size_t)s->n * sizeof(double));
  return status;
}

maggi_status maggi_gradient_difference(maggi_study *s)
{
  size_t bytes = (size_t)s->d->t.np * sizeof(double), flags = (size_t)s->d->t.nq * sizeof(int);
  work w = {.s = s};
  maggi_status status;
  int *given;

  w.p = malloc(2 * bytes + 1);
  w.value = calloc(3 * (size_t)s->n + 1, sizeof(double));
  given = malloc(2 * flags + 1);
  if (w.p && w.value && given) {
    memcpy(given, s->d->position_given, flags);
    memcpy(given + s->d->t.nq, s->d->velocity_given, flags);
    w.direction = w.p + s->d->t.np;
    memcpy(w.p, s->d->p, bytes);
    memset(w.direction, 0, bytes);
    status = run(&w);
    memcpy(s->d->p, w.p, bytes);
    memcpy(s->d->position_given, given, flags);
    memcpy(s->d->velocity_given, given + s->d->t.nq, flags);
  } else {
    status = maggi_data_fail(s->d, MAGGI_E_MEMORY, "out of memory");
  }
  free(given);
  free(w.p);
  free(w.value);
  return status;
}
