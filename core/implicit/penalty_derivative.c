/* What derivatives of a step of the penalty formulation share: the exact derivative of its equation
 * at the solution, and its projections.
 *
 *   F(z, history, p) = - h^2/4 w(z, z', z'', alpha Phi) = 0
 *   E = dF/dz with z' and z'' of the trapezoidal rule
 *
 * by tangents of w along sums of columns without a common row. */
#include <stdlib.h>
#include <string.h>

#include "penalty.h"

enum { W = MAGGI_NDIR };

/* E in the order of the places of the matrices; d has been evaluated with z' and z'' of the
 * trapezoidal rule */
static void differentiate(maggi_penalty_derivative *x, double h)
{
  maggi_companion *s = &x->D->strip;
  const maggi_penalty *penalty = x->s;
  const maggi_sparsity *a = &penalty->matrix->places;
  const int *q = penalty->matrix->pattern->q;
  size_t bytes = (size_t)penalty->d->t.nq * W * sizeof(double);
  int first, end, k, i, c, n = penalty->n;

  maggi_place_constants(s, &penalty->d->t, x->still);
  s->q = x->work;
  s->v = s->q + penalty->d->t.nq * W;
  s->a = s->v + penalty->d->t.nq * W;
  for (first = 0; first < x->colouring->ncolour; first = end) {
    end = first + W < x->colouring->ncolour ? first + W : x->colouring->ncolour;
    memset(s->q, 0, bytes);
    memset(s->v, 0, bytes);
    memset(s->a, 0, bytes);
    for (k = first; k < end; ++k) {
      for (i = x->colouring->colouradr[k]; i < x->colouring->colouradr[k + 1]; ++i) {
        c = q[x->colouring->column[i]] * W + k - first;
        s->q[c] = 1.0;
        s->v[c] = 2.0 / h;
        s->a[c] = 4.0 / (h * h);
      }
    }
    maggi_strip_balance(x->D, penalty->options.penalty);
    for (i = 0; i < n; ++i)
      for (k = first; k < end; ++k)
        x->product[i * (end - first) + k - first] = -0.25 * h * h * s->w[q[i] * W + k - first];
    maggi_colour_recover(a, x->colouring, first, end, x->product, x->value);
  }
}

/* what a projection has changed, and the multipliers of what it has left */
static void load(maggi_penalty_derivative *x, maggi_rest *rest, double h, const double *now,
                 const double *before, double sign, const double *rest_of_loops)
{
  const maggi_topo *t = &x->s->d->t;
  int i;

  for (i = 0; i < t->nq; ++i) rest->data.a[i] = t->qguide[i] < 0 ? now[i] - before[i] : 0.0;
  for (i = 0; i < t->nrow; ++i)
    rest->data.lambda[i] = sign * 0.25 * h * h * x->s->options.penalty * rest_of_loops[i];
  maggi_rest_evaluate(rest);
}

maggi_status maggi_penalty_differentiate_equation(maggi_penalty_derivative *x, double h,
                                                  double time)
{
  maggi_penalty *s = x->s;
  maggi_data *d = s->d;
  size_t bytes = (size_t)d->t.nq * sizeof(double);

  x->D->time = time;
  memcpy(x->v, d->v, bytes);
  memcpy(x->a, d->a, bytes);
  maggi_penalty_trapezoid(s, h, d->v, d->a);
  maggi_chain_evaluate(d, time, s->options.penalty);
  memcpy(s->vs, d->v, bytes);
  memcpy(s->as, d->a, bytes);
  differentiate(x, h);
  if (maggi_factor_compute(x->exact, x->value)) return MAGGI_OK;
  return maggi_data_fail(d, MAGGI_E_MASS, "t = %.6g s: the motion has no derivative", time);
}

maggi_status maggi_penalty_differentiate_projections(maggi_penalty_derivative *x, double h,
                                                     double time)
{
  maggi_penalty *s = x->s;
  maggi_data *d = s->d;
  const maggi_topo *t = &d->t;
  size_t bytes = (size_t)t->nq * sizeof(double);

  memcpy(d->v, x->v, bytes);
  memcpy(d->a, x->a, bytes);
  maggi_chain_evaluate(d, time, s->options.penalty);
  if (t->nrow == 0) return MAGGI_OK;
  maggi_tangent_matrix_project(s->matrix, h, s->options.penalty);
  if (!maggi_factor_compute(s->projection, s->matrix->projection))
    return maggi_data_fail(d, MAGGI_E_MASS, "t = %.6g s: the mass matrix is singular", time);
  maggi_chain_rates(d);
  maggi_chain_gamma(d);
  load(x, &x->velocity, h, d->v, s->vs, 1.0, d->rate);
  load(x, &x->acceleration, h, d->a, s->as, -1.0, d->gama);
  return MAGGI_OK;
}

/* -------------------------------------------------------------------------------------- memory */

maggi_status maggi_penalty_derivative_create(maggi_penalty *s, maggi_derivative *D,
                                             maggi_penalty_derivative **derivative)
{
  maggi_penalty_derivative *x = calloc(1, sizeof *x);
  const maggi_sparsity *a = &s->matrix->places;
  size_t n = (size_t)s->n;
  maggi_status status;

  *derivative = NULL;
  if (!x) return MAGGI_E_MEMORY;
  x->s = s;
  x->D = D;
  status = maggi_colouring_create(a, MAGGI_COLOUR_BEST, &x->colouring);
  if (status == MAGGI_OK) status = maggi_factor_create(a, &x->exact);
  if (status == MAGGI_OK) status = maggi_rest_create(s->d, D, &x->velocity);
  if (status == MAGGI_OK) status = maggi_rest_create(s->d, D, &x->acceleration);
  x->value = malloc(((size_t)a->coladr[a->ncol] + 1) * sizeof(double));
  x->product = malloc((n * W + 1) * sizeof(double));
  x->column = malloc((n * W + 1) * sizeof(double));
  x->work = aligned_alloc(64, (3 * (size_t)s->d->t.nq + 1) * W * sizeof(double));
  x->still = aligned_alloc(64, (D->strip.nconstants + W) * sizeof(double));
  x->v = calloc(2 * (size_t)s->d->t.nq + 1, sizeof(double));
  if (x->still) memset(x->still, 0, D->strip.nconstants * sizeof(double));
  if (x->v) x->a = x->v + s->d->t.nq;
  if (!x->value || !x->product || !x->column || !x->work || !x->still || !x->v)
    status = MAGGI_E_MEMORY;
  if (status != MAGGI_OK) {
    maggi_penalty_derivative_free(x);
    return status;
  }
  *derivative = x;
  return MAGGI_OK;
}

void maggi_penalty_derivative_free(maggi_penalty_derivative *x)
{
  if (!x) return;
  maggi_colouring_free(x->colouring);
  maggi_factor_free(x->exact);
  maggi_rest_free(&x->velocity);
  maggi_rest_free(&x->acceleration);
  free(x->value);
  free(x->product);
  free(x->column);
  free(x->work);
  free(x->still);
  free(x->v);
  free(x);
}
