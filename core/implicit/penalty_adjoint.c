/* Adjoint of a step of the penalty formulation: the equations of penalty_direct.c from the last to
 * the first.  Each is solved twice, the second time for what the first solution leaves: loops are
 * stiff, and the factors alone lose digits with alpha h^2. */
#include <string.h>

#include "penalty.h"

enum { PASSES = 2 };

/* weights of w: f times the solution of the transposed equations with the adjoints of the
 * coordinates that are not guided */
static void solve_transposed(maggi_penalty_derivative *x, const maggi_factor *factor, double f,
                             const double *bar, double *w)
{
  const int *q = x->s->matrix->pattern->q;
  int i, n = x->s->n;

  for (i = 0; i < n; ++i) x->column[i] = bar[q[i]];
  maggi_factor_solve_transposed(factor, 1, x->column);
  memset(w, 0, (size_t)x->s->d->t.nq * sizeof(double));
  for (i = 0; i < n; ++i) w[q[i]] = f * x->column[i];
}

/* back through a projection with adjoints `bar` of its result: added, adjoints of what it projects,
 * and of s->rate or s->gama, of which multipliers are f times as large */
static void go_before(maggi_penalty_derivative *x, maggi_rest *rest, double f, const double *bar,
                      double *before, double *y)
{
  const maggi_topo *t = &x->s->d->t;
  int i;

  maggi_rest_clear(rest);
  solve_transposed(x, x->s->projection, 1.0, bar, rest->adjoint.w);
  maggi_adjoint_rest(x->D, rest);
  for (i = 0; i < t->nq; ++i) before[i] -= t->qguide[i] < 0 ? rest->adjoint.a[i] : 0.0;
  for (i = 0; i < t->nrow; ++i) y[i] += f * rest->adjoint.lambda[i];
}

/* of coordinates that are not guided: to `bar` */
static void take(const maggi_topo *t, double *rows, double *bar)
{
  int i;

  for (i = 0; i < t->nq; ++i) {
    if (t->qguide[i] >= 0) continue;
    bar[i] += rows[i];
    rows[i] = 0.0;
  }
}

/* adjoints of velocities and accelerations of the trapezoidal rule in `v` and `a`, of positions
 * added to lane->q */
static void go_before_projections(maggi_penalty_derivative *x, maggi_reversal *r, maggi_lane *lane,
                                  double h, double *v, double *a)
{
  const maggi_topo *t = &x->s->d->t;
  const maggi_companion *s = &x->D->adjoint;
  double f = 0.25 * h * h * x->s->options.penalty;
  size_t bytes = (size_t)t->nq * sizeof(double);
  int i, pass;

  if (t->nrow == 0) {
    memcpy(v, lane->v, bytes);
    memcpy(a, lane->a, bytes);
    return;
  }
  maggi_reversal_choose(r, lane, x->s->d->zero, x->s->d->zero);
  maggi_rest_choose(x->D, &x->velocity);
  maggi_rest_choose(x->D, &x->acceleration);
  for (pass = 0; pass < PASSES; ++pass) {
    go_before(x, &x->acceleration, -f, lane->a, a, s->gama);
    maggi_adjoint_gamma(x->D);
    take(t, x->acceleration.adjoint.a, lane->a); /* what the solution leaves */
    take(t, s->a, lane->a);
  }
  take(t, s->v, lane->v);
  for (pass = 0; pass < PASSES; ++pass) {
    go_before(x, &x->velocity, f, lane->v, v, s->rate);
    maggi_adjoint_rates_of(x->D);
    take(t, x->velocity.adjoint.a, lane->v);
    take(t, s->v, lane->v);
  }
  maggi_adjoint_positions(x->D);
  for (i = 0; i < t->nq; ++i) lane->q[i] += s->q[i];
}

/* adjoints of the end of a lane become those of the start, from those of the trapezoidal rule */
static void go_before_equation(maggi_penalty_derivative *x, maggi_reversal *r, maggi_lane *lane,
                               double h, double *v, double *a)
{
  const maggi_topo *t = &x->s->d->t;
  const maggi_companion *s = &x->D->adjoint;
  int i, pass;

  for (i = 0; i < t->nq; ++i) lane->q[i] += 2.0 / h * v[i] + 4.0 / (h * h) * a[i];
  for (pass = 0; pass < PASSES; ++pass) {
    maggi_reversal_choose(r, lane, x->s->d->zero, x->s->d->zero);
    solve_transposed(x, x->exact, 0.25 * h * h, lane->q, s->w);
    maggi_adjoint_balance(x->D, x->s->options.penalty);
    for (i = 0; i < t->nq; ++i) {
      v[i] += s->v[i];
      a[i] += s->a[i];
      lane->q[i] += 2.0 / h * s->v[i] + 4.0 / (h * h) * s->a[i];
    }
    maggi_adjoint_positions(x->D);
    for (i = 0; i < t->nq; ++i) lane->q[i] += s->q[i];
  }
  for (i = 0; i < t->nq; ++i) {
    if (t->qguide[i] >= 0) v[i] = a[i] = 0.0;
    lane->q[i] = -2.0 / h * v[i] - 4.0 / (h * h) * a[i];
    lane->v[i] = -v[i] - 4.0 / h * a[i];
    lane->a[i] = -a[i];
  }
}

maggi_status maggi_penalty_adjoint_step(maggi_penalty_derivative *x, maggi_reversal *r, double h,
                                        double time)
{
  maggi_data *d = x->s->d;
  size_t bytes = (size_t)d->t.nq * sizeof(double);
  maggi_lane *lane;
  maggi_status status = maggi_penalty_differentiate_equation(x, h, time);

  if (status == MAGGI_OK) status = maggi_penalty_differentiate_projections(x, h, time);
  for (lane = r->lane; lane < r->lane + r->n && status == MAGGI_OK; ++lane)
    go_before_projections(x, r, lane, h, lane->v0, lane->a0);
  if (status != MAGGI_OK) return status;
  memcpy(d->v, x->s->vs, bytes);
  memcpy(d->a, x->s->as, bytes);
  maggi_chain_evaluate(d, time, x->s->options.penalty);
  for (lane = r->lane; lane < r->lane + r->n; ++lane) {
    go_before_equation(x, r, lane, h, lane->v0, lane->a0);
    memset(lane->v0, 0, bytes);
    memset(lane->a0, 0, bytes);
  }
  return MAGGI_OK;
}
