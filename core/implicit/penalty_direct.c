/* Direct differentiation of a step of the penalty formulation: the implicit function theorem on its
 * equation and on its projections, a factorisation each for all parameters.
 *
 *   E z_b = h^2/4 w_b      w_b with z held, z' and z'' moved by what the step began with
 *   B z'_b = w_b           of the velocity projection with z' held, and so on for accelerations */
#include <string.h>

#include "penalty.h"

enum { W = MAGGI_NDIR };

/* rows of coordinates that are not guided: solution of the equations with f times `w` on the
 * right */
static void solve(maggi_penalty_derivative *x, const maggi_factor *factor, double f,
                  const double *w, double *out)
{
  const int *q = x->s->matrix->pattern->q;
  int i, c, n = x->s->n;

  for (c = 0; c < W; ++c)
    for (i = 0; i < n; ++i) x->column[c * n + i] = f * w[q[i] * W + c];
  maggi_factor_solve(factor, W, x->column);
  for (c = 0; c < W; ++c)
    for (i = 0; i < n; ++i) out[q[i] * W + c] = x->column[c * n + i];
}

/* z' and z'' of the trapezoidal rule for positions q and the start of a strip */
static void trapezoid(const maggi_penalty_derivative *x, const maggi_direct *direct, size_t at,
                      double h, const double *q, double *v, double *a)
{
  const maggi_direct_state *start = &direct->at[MAGGI_START];
  const double *q0 = start->q + at, *v0 = start->v + at, *a0 = start->a + at;
  int i;

  for (i = 0; i < x->s->d->t.nq * W; ++i) {
    v[i] = 2.0 / h * (q[i] - q0[i]) - v0[i];
    a[i] = 4.0 / (h * h) * (q[i] - q0[i]) - 4.0 / h * v0[i] - a0[i];
  }
}

static void clear_rows(const maggi_penalty_derivative *x, double *rows)
{
  const maggi_topo *t = &x->s->d->t;

  memset(rows, 0, (size_t)t->nq * W * sizeof(double));
}

/* positions of a strip */
static void find_positions(maggi_penalty_derivative *x, const maggi_direct *direct, size_t at,
                           double h)
{
  maggi_companion *s = &x->D->strip;
  double *q = s->q;

  s->q = x->work;
  s->v = s->q + x->s->d->t.nq * W;
  s->a = s->v + x->s->d->t.nq * W;
  clear_rows(x, s->q);
  trapezoid(x, direct, at, h, s->q, s->v, s->a);
  maggi_strip_balance(x->D, x->s->options.penalty);
  memcpy(q, s->q, (size_t)x->s->d->t.nq * W * sizeof(double)); /* guided ones */
  solve(x, x->exact, 0.25 * h * h, s->w, q);
}

/* tangent of a projection, of `before` to `now`: multipliers are f times y */
static void project(maggi_penalty_derivative *x, maggi_rest *rest, double f, const double *y,
                    const double *before, double *now)
{
  const maggi_topo *t = &x->s->d->t;
  int i, c;

  for (i = 0; i < t->nq; ++i)
    for (c = 0; c < W; ++c) rest->strip.a[i * W + c] = t->qguide[i] < 0 ? -before[i * W + c] : 0.0;
  for (i = 0; i < t->nrow * W; ++i) rest->strip.lambda[i] = f * y[i];
  maggi_strip_rest(x->D, rest);
  solve(x, x->s->projection, 1.0, rest->strip.w, now);
}

/* velocities and accelerations of a strip */
static void find_motion(maggi_penalty_derivative *x, const maggi_direct *direct, size_t at,
                        double h)
{
  maggi_companion *s = &x->D->strip;
  double f = 0.25 * h * h * x->s->options.penalty;
  double *v = x->work, *a = v + x->s->d->t.nq * W;

  maggi_strip_positions(x->D);
  trapezoid(x, direct, at, h, s->q, v, a);
  if (x->s->d->t.nrow == 0) {
    memcpy(s->v, v, (size_t)x->s->d->t.nq * W * sizeof(double));
    memcpy(s->a, a, (size_t)x->s->d->t.nq * W * sizeof(double));
    maggi_strip_gamma(x->D); /* guided ones */
    return;
  }
  maggi_rest_choose(x->D, &x->velocity);
  maggi_rest_choose(x->D, &x->acceleration);
  clear_rows(x, s->v);
  clear_rows(x, s->a);
  maggi_strip_rates(x->D);
  project(x, &x->velocity, f, s->rate, v, s->v);
  maggi_strip_gamma(x->D);
  project(x, &x->acceleration, -f, s->gama, a, s->a);
}

maggi_status maggi_penalty_direct_step(maggi_penalty_derivative *x, maggi_direct *direct, double h)
{
  maggi_data *d = direct->d;
  maggi_direct_state *now = &direct->at[MAGGI_PRESENT], *start = &direct->at[MAGGI_START];
  size_t bytes = direct->nx * sizeof(double);
  maggi_status status = maggi_penalty_step(x->s, h);
  double time = d->time;
  int first;

  if (status != MAGGI_OK) return status;
  memcpy(start->q, now->q, bytes);
  memcpy(start->v, now->v, bytes);
  memcpy(start->a, now->a, bytes);
  status = maggi_penalty_differentiate_equation(x, h, time);
  for (first = 0; first < direct->n && status == MAGGI_OK; first += W) {
    maggi_direct_choose(direct, first);
    find_positions(x, direct, (size_t)(first / W) * direct->strip, h);
  }
  if (status == MAGGI_OK) status = maggi_penalty_differentiate_projections(x, h, time);
  for (first = 0; first < direct->n && status == MAGGI_OK; first += W) {
    maggi_direct_choose(direct, first);
    find_motion(x, direct, (size_t)(first / W) * direct->strip, h);
  }
  maggi_evaluate_given(d, time);
  return status;
}
