/* Direct differentiation of a step of the penalty formulation: the implicit function theorem on its
 * equation and on its projections, a factorisation each for all parameters.  From a guess:
 *
 *   z_b  = guess + E^-1 h^2/4 w_b   w_b with z', z'' that the guess and the start of the step give
 *   z'_b = guess + B^-1 w_b         w_b of the velocity projection, so on for accelerations
 *
 * The guess nearly keeps the loops closed.  Without it alpha times what a parameter opens them by,
 * a large number, would have to cancel. */
#include <string.h>

#include "penalty.h"

enum { W = MAGGI_NDIR };

/* solution of the equations with f times `w` on the right, added to the rows of coordinates that
 * are not guided */
static void correct(maggi_penalty_derivative *x, const maggi_factor *factor, double f,
                    const double *w, double *rows)
{
  const int *q = x->s->matrix->pattern->q;
  int i, c, n = x->s->n;

  for (c = 0; c < W; ++c)
    for (i = 0; i < n; ++i) x->column[c * n + i] = f * w[q[i] * W + c];
  maggi_factor_solve(factor, W, x->column);
  for (c = 0; c < W; ++c)
    for (i = 0; i < n; ++i) rows[q[i] * W + c] += x->column[c * n + i];
}

/* positions h after the start of a strip, if accelerations stayed as they are */
static void guess(const maggi_penalty_derivative *x, const maggi_direct *direct, size_t at,
                  double h, double *q)
{
  const maggi_direct_state *start = &direct->at[MAGGI_START];
  const double *q0 = start->q + at, *v0 = start->v + at, *a0 = start->a + at;
  int i;

  for (i = 0; i < x->s->d->t.nq * W; ++i) q[i] = q0[i] + h * (v0[i] + 0.5 * h * a0[i]);
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

static size_t bytes_of_rows(const maggi_penalty_derivative *x)
{
  return (size_t)x->s->d->t.nq * W * sizeof(double);
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
  guess(x, direct, at, h, s->q);
  trapezoid(x, direct, at, h, s->q, s->v, s->a);
  maggi_strip_balance(x->D, x->s->options.penalty);
  memcpy(q, s->q, bytes_of_rows(x));
  correct(x, x->exact, 0.25 * h * h, s->w, q);
}

/* tangent of a projection of what `rows` hold: multipliers are f times y */
static void project(maggi_penalty_derivative *x, maggi_rest *rest, double f, const double *y,
                    double *rows)
{
  int i;

  for (i = 0; i < x->s->d->t.nrow * W; ++i) rest->strip.lambda[i] = f * y[i];
  maggi_strip_rest(x->D, rest);
  correct(x, x->s->projection, 1.0, rest->strip.w, rows);
}

/* velocities and accelerations of a strip */
static void find_motion(maggi_penalty_derivative *x, const maggi_direct *direct, size_t at,
                        double h)
{
  maggi_companion *s = &x->D->strip;
  double f = 0.25 * h * h * x->s->options.penalty;

  maggi_strip_positions(x->D);
  trapezoid(x, direct, at, h, s->q, s->v, s->a);
  if (x->s->d->t.nrow == 0) {
    maggi_strip_gamma(x->D); /* guided ones */
    return;
  }
  maggi_rest_choose(x->D, &x->velocity);
  maggi_rest_choose(x->D, &x->acceleration);
  maggi_strip_rates(x->D);
  project(x, &x->velocity, f, s->rate, s->v);
  maggi_strip_gamma(x->D);
  project(x, &x->acceleration, -f, s->gama, s->a);
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
