/* Gradients by direct differentiation: samples and their tangents, then weights on them.  Where all of
 * these are too many for the memory, the objectives are simulated first and weights are at hand. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study.h"

typedef struct work {
  maggi_study *s;
  maggi_direct *direct;
  maggi_penalty_derivative *implicit; /* of the penalty formulation, or NULL */
  int n;                              /* design parameters */
  size_t row;                         /* numbers of a sample and its tangents */
  double *tangents;                   /* a row, or all of them */
  int is_stored;
  double *q;         /* (coordinates x n) */
  double *relevance; /* (n) */
} work;

/* what a sample and its tangents add to the gradients */
static void add(work *w, long k, const double *row)
{
  maggi_study *s = w->s;
  const double *weight, *tangent;
  const int *signal;
  int i, c, j, m;

  memcpy(s->sample, row, (size_t)s->nsignal * sizeof(double));
  for (i = 0; i < s->n; ++i) {
    m = maggi_study_weights(s, i, k, &signal, &weight);
    for (c = 0; c < m; ++c) {
      tangent = row + s->nsignal + (size_t)(s->first[i] + c) * (size_t)w->n;
      for (j = 0; j < w->n; ++j) s->gradient[i * w->n + j] += weight[c] * tangent[j];
    }
  }
}

/* largest sensitivity of a position by each parameter, [1] 5.45 */
static void look_at_relevance(work *w)
{
  const maggi_gradient_options *o = w->s->options;
  int i, j;

  if (!o->relevance && !o->coordinate) return;
  maggi_direct_get_coordinates(w->direct, w->q, NULL, NULL);
  for (i = 0; i < w->s->d->m->ncoordinate; ++i) {
    for (j = 0; j < w->n; ++j) {
      if (!(fabs(w->q[i * w->n + j]) > w->relevance[j])) continue;
      w->relevance[j] = fabs(w->q[i * w->n + j]);
      if (o->coordinate) o->coordinate[j] = i;
    }
  }
}

static void take_sample(work *w, long k)
{
  maggi_study *s = w->s;
  double *row = w->tangents + (w->is_stored ? (size_t)k * w->row : 0);

  if (w->is_stored)
    maggi_study_push(s, k);
  else
    maggi_get_signals(s->d, s->nsignal, s->signal, s->sample);
  memcpy(row, s->sample, (size_t)s->nsignal * sizeof(double));
  maggi_direct_get_signals(w->direct, s->nsignal, s->signal, row + s->nsignal);
  if (!w->is_stored) add(w, k, row);
  look_at_relevance(w);
}

static maggi_status step(work *w, long k)
{
  double h = maggi_study_step(w->s, k);

  return w->implicit ? maggi_penalty_direct_step(w->implicit, w->direct, h)
                     : maggi_direct_step(w->direct, h);
}

static maggi_status simulate(work *w)
{
  maggi_study *s = w->s;
  maggi_status status;
  long k;

  status = maggi_direct_reset(w->direct);
  if (status == MAGGI_OK && w->is_stored) status = maggi_study_begin(s);
  if (status != MAGGI_OK) return status;
  take_sample(w, 0);
  for (k = 0; k < s->grid.steps && status == MAGGI_OK; ++k) {
    status = step(w, k);
    if (status != MAGGI_OK) return status;
    take_sample(w, k + 1);
    status = maggi_study_progress(s, (double)(k + 1) / (double)s->grid.steps);
  }
  return status;
}

static maggi_status run(work *w)
{
  maggi_study *s = w->s;
  maggi_status status = MAGGI_OK;
  long k;

  if (!w->is_stored) {
    s->share = 0.1;
    status = maggi_study_simulate(s);
    if (status == MAGGI_OK) status = maggi_study_differentiable(s);
    s->begin = 0.1;
    s->share = 0.9;
  }
  if (status == MAGGI_OK) status = simulate(w);
  if (status != MAGGI_OK || !w->is_stored) return status;
  status = maggi_study_end(s);
  if (status == MAGGI_OK) status = maggi_study_differentiable(s);
  for (k = 0; k <= s->grid.steps && status == MAGGI_OK; ++k)
    add(w, k, w->tangents + (size_t)k * w->row);
  return status;
}

maggi_status maggi_gradient_direct(maggi_study *s)
{
  maggi_status status = MAGGI_E_MEMORY;
  size_t all;
  work w = {.s = s, .n = maggi_design_number(s->design)};

  w.row = (size_t)s->nsignal * ((size_t)w.n + 1);
  all = w.row * (size_t)(s->grid.steps + 1);
  w.is_stored = all <= s->options->memory / sizeof(double);
  w.tangents = malloc((w.is_stored ? all : w.row) * sizeof(double) + 1);
  w.q = malloc((size_t)s->d->m->ncoordinate * (size_t)w.n * sizeof(double) + 1);
  w.relevance = calloc((size_t)w.n + 1, sizeof(double));
  if (w.tangents && w.q && w.relevance) status = maggi_direct_create(s->d, s->design, &w.direct);
  if (status == MAGGI_OK && s->penalty)
    status = maggi_penalty_derivative_create(s->penalty, w.direct->D, &w.implicit);
  if (status == MAGGI_OK) {
    memset(s->gradient, 0, (size_t)s->n * (size_t)w.n * sizeof(double));
    if (s->options->coordinate) memset(s->options->coordinate, 0, (size_t)w.n * sizeof(int));
    status = run(&w);
    if (s->options->relevance)
      memcpy(s->options->relevance, w.relevance, (size_t)w.n * sizeof(double));
  } else {
    maggi_data_fail(s->d, status, "out of memory");
  }
  maggi_penalty_derivative_free(w.implicit);
  maggi_direct_free(w.direct);
  free(w.tangents);
  free(w.q);
  free(w.relevance);
  return status;
}
