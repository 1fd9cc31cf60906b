/* Derivatives of the equations of motion, maggi_motion_.., on every mechanism:
 *
 *   at the state of a simulation and, with other parameters, velocities and time, away from where the
 *   loops are closed
 *
 *   jvp   against complex step of one evaluation
 *   jac   each column against jvp
 *   vjp   y_.y' = x_.x', also along a direction in which every entry of the gradient counts as much
 *   hvp   w.H u against differences of complex steps, which lose nothing to cancellation at first order;
 *         symmetry u.H w = w.H u
 *
 * x = (q, v, p) and y = (v, a), coordinates in the order of the user.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "property/vector.h"
#include "reference.h"
#include "state.h"

/* more columns than one strip has, and not a multiple of it */
enum { COLUMNS = 2 * MAGGI_NDIR + 3 };

/* velocities and accelerations each */
static double distance2(const state *m, const double *a, const double *b, const double *shaken)
{
  int n = m->nq;
  double v = state_distance(n, a, b, shaken);
  double w = state_distance(n, a + n, b + n, shaken ? shaken + n : NULL);

  return v > w || isnan(v) ? v : w;
}

static int inputs_of(const state *m)
{
  return 2 * m->nq + m->np;
}

static int outputs_of(const state *m)
{
  return 2 * m->nq;
}

/* -------------------------------------------------------------------------------- complex step */

/* derivative of y along x, at the state of the simulation moved by `move` along `to` */
static void complex_step(const state *m, const double *x, long double move, const double *to,
                         long double *yd)
{
  const maggi_data *d = m->d;
  const maggi_topo *t = &d->t;
  reference_motion *z = reference_motion_create(t, d->m->originadr);
  reference_number *q = reference_motion_array(z, "q"), *vcol = reference_motion_array(z, "vcol");
  reference_number *p = reference_motion_array(z, "p"), *out;
  int i, k, c, n = m->nq;

  for (i = 0; i < n; ++i) {
    k = d->m->coordinate[i].q;
    c = t->col[k];
    q[k] = d->q[k] + move * to[i] + _Complex_I * REFERENCE_STEP * x[i];
    if (c >= 0 && c < t->nind)
      vcol[c] = d->vcol[c] + move * to[n + i] + _Complex_I * REFERENCE_STEP * x[n + i];
  }
  for (i = 0; i < m->np; ++i)
    p[i] = d->p[i] + move * to[2 * n + i] + _Complex_I * REFERENCE_STEP * x[2 * n + i];
  reference_motion_evaluate(z, m->time);
  for (i = 0; i < outputs_of(m); ++i) {
    out = reference_motion_array(z, i < n ? "v" : "a");
    k = d->m->coordinate[i % n].q;
    yd[i] = cimagl(out[k]) / REFERENCE_STEP;
  }
  reference_motion_free(z);
}

static double *complex_jvp(const state *m, const double *x, double move, const double *to)
{
  double *yd = state_numbers(outputs_of(m));
  long double *exact = calloc((size_t)outputs_of(m) + 1, sizeof *exact);
  int i;

  if (!exact) abort();
  complex_step(m, x, move, to, exact);
  for (i = 0; i < outputs_of(m); ++i) yd[i] = (double)exact[i];
  free(exact);
  return yd;
}

/* w.y' at the moved state */
static long double moved_slope(const state *m, const double *w, const double *x, long double move,
                               const double *to)
{
  long double *yd = calloc((size_t)outputs_of(m) + 1, sizeof *yd), sum = 0.0L;
  int i;

  if (!yd) abort();
  complex_step(m, x, move, to, yd);
  for (i = 0; i < outputs_of(m); ++i) sum += w[i] * yd[i];
  free(yd);
  return sum;
}

/* Its derivative along `to` by central differences of decreasing steps, extrapolated to zero; of these
 * the one that agrees best with its neighbours.  C. J. F. Ridders, Advances in Engineering Software 4
 * (1982) 75. */
static double complex_bend(const state *m, const double *w, const double *x, const double *to)
{
  enum { STEPS = 8 };
  long double table[STEPS][STEPS], h = 1e-3L, factor, error, least = INFINITY, best = 0.0L;
  int i, k;

  for (i = 0; i < STEPS; ++i, h /= 4.0L) {
    table[i][0] = (moved_slope(m, w, x, h, to) - moved_slope(m, w, x, -h, to)) / (2.0L * h);
    for (k = 1, factor = 16.0L; k <= i; ++k, factor *= 16.0L) {
      table[i][k] = table[i][k - 1] + (table[i][k - 1] - table[i - 1][k - 1]) / (factor - 1.0L);
      error = fmaxl(fabsl(table[i][k] - table[i][k - 1]), fabsl(table[i][k] - table[i - 1][k - 1]));
      if (error > least) continue;
      least = error;
      best = table[i][k];
    }
  }
  return (double)best;
}

/* --------------------------------------------------------------------------------------- checks */

static double *jvp(const state *m, const double *x)
{
  double *y = state_numbers(outputs_of(m));

  maggi_motion_jvp(m->D, x, x + m->nq, x + 2 * m->nq, y, y + m->nq);
  return y;
}

static double *vjp(const state *m, const double *w)
{
  double *g = state_numbers(inputs_of(m));

  maggi_motion_vjp(m->D, w, w + m->nq, g, g + m->nq, g + 2 * m->nq);
  return g;
}

static double *hvp(const state *m, const double *w, const double *u)
{
  double *g = state_numbers(inputs_of(m));
  int n = m->nq;

  maggi_motion_hvp(m->D, w, w + n, u, u + n, u + 2 * n, g, g + n, g + 2 * n);
  return g;
}

static void check_against_complex(state *m, const char *what, const double *x, const double *y)
{
  double *right, *shaken, *to = state_direction(m, 2 * m->nq);

  right = complex_jvp(m, x, 0.0, to);
  shaken = complex_jvp(m, x, STATE_TREMOR, to);
  state_near(m, what, distance2(m, y, right, shaken), 1e-11);
  free(right);
  free(shaken);
  free(to);
}

static void check_jvp(state *m)
{
  double *x = state_direction(m, 2 * m->nq), *y = jvp(m, x);

  check_against_complex(m, "jvp", x, y);
  /* nothing of that is left */
  memset(x + 2 * m->nq, 0, (size_t)m->np * sizeof *x);
  maggi_motion_jvp(m->D, x, x + m->nq, NULL, y, y + m->nq);
  check_against_complex(m, "jvp, parameters at rest", x, y);
  free(x);
  free(y);
}

static void check_jac(state *m)
{
  double *columns = state_numbers(inputs_of(m) * COLUMNS),
         *J = state_numbers(outputs_of(m) * COLUMNS), *x, *y;
  double *column = state_numbers(outputs_of(m));
  int i, c, n = m->nq * COLUMNS;

  for (c = 0; c < COLUMNS; ++c) {
    x = state_direction(m, 2 * m->nq);
    for (i = 0; i < inputs_of(m); ++i) columns[i * COLUMNS + c] = x[i];
    free(x);
  }
  maggi_motion_jac(m->D, COLUMNS, columns, columns + n, columns + 2 * n, J, J + n);
  x = state_numbers(inputs_of(m));
  for (c = 0; c < COLUMNS; ++c) {
    for (i = 0; i < inputs_of(m); ++i) x[i] = columns[i * COLUMNS + c];
    for (i = 0; i < outputs_of(m); ++i) column[i] = J[i * COLUMNS + c];
    y = jvp(m, x);
    state_near(m, "jac, columns against jvp", distance2(m, column, y, NULL), 1e-11);
    free(y);
  }
  free(columns);
  free(J);
  free(x);
  free(column);
}

static void check_vjp(state *m)
{
  double *w = state_weights(m, outputs_of(m)), *g = vjp(m, w), *x = state_direction(m, 2 * m->nq),
         *y = jvp(m, x), *right;
  double left, terms = 0.0;

  left = state_dot(outputs_of(m), w, y, &terms);
  state_near_sum(m, "vjp against jvp", left, state_dot(inputs_of(m), g, x, &terms), terms, 1e-11);
  free(x);
  free(y);
  x = state_balanced(m, 2 * m->nq, g);
  right = complex_jvp(m, x, 0.0, x);
  terms = 0.0;
  left = state_dot(outputs_of(m), w, right, &terms);
  state_near_sum(m, "vjp, entries of all sizes", left, state_dot(inputs_of(m), g, x, &terms), terms,
                 1e-11);
  report_true(m->seed, "the gradient is not zero", terms > 0.0);
  free(w);
  free(g);
  free(x);
  free(right);
}

/* where a damper or a function of time has a kink, derivatives jump */
static int is_near_kink(const state *m)
{
  const maggi_data *d = m->d;
  const maggi_topo *t = &d->t;
  double e[3], ev[3], rate, length;
  int i, k, n;

  for (i = 0; i < t->nspring; ++i) {
    if (!t->springslopes[i]) continue;
    v3_axpy(d->r[t->springpa[i]], -1.0, d->r[t->springpb[i]], e);
    v3_axpy(d->rv[t->springpa[i]], -1.0, d->rv[t->springpb[i]], ev);
    length = v3_norm(e);
    rate = v3_dot(e, ev) / length;
    k = t->springadr[i] + MAGGI_SPRING_SLOPES;
    if (fabs(rate) < 0.02 || fabs(rate - d->p[k + 4]) < 0.02 || fabs(rate - d->p[k + 5]) < 0.02)
      return 1;
  }
  for (i = 0; i < t->nfun; ++i) {
    n = t->funkind[i] == MAGGI_FUNCTION_STEP || t->funkind[i] == MAGGI_FUNCTION_RAMP ? 2
                                                                                     : t->funn[i];
    if (t->funkind[i] < MAGGI_FUNCTION_STEP) continue;
    for (k = 0; k < n; ++k)
      if (fabs(m->time - d->p[t->funadr[i] + k]) < 1e-3) return 1;
  }
  return 0;
}

static void check_hvp(state *m)
{
  double *w = state_weights(m, outputs_of(m)), *u = state_direction(m, 2 * m->nq),
         *x = state_direction(m, 2 * m->nq), *hu = hvp(m, w, u);
  double *hx = hvp(m, w, x), left, right, terms = 0.0;

  left = state_dot(inputs_of(m), x, hu, &terms);
  right = state_dot(inputs_of(m), u, hx, &terms);
  state_near_sum(m, "hvp, symmetry", left, right, terms, 1e-11);
  report_true(m->seed, "the second derivative is not zero", terms > 0.0);
  if (is_near_kink(m)) {
    report_count("hvp not against differences: near a kink");
  } else {
    terms = 0.0;
    left = state_dot(inputs_of(m), x, hu, &terms);
    state_near_sum(m, "hvp", left, complex_bend(m, w, x, u), terms, 1e-11);
  }
  free(w);
  free(u);
  free(x);
  free(hu);
  free(hx);
}

static void check(state *m)
{
  check_jvp(m);
  check_jac(m);
  check_vjp(m);
  check_hvp(m);
}

int main(int argc, char **argv)
{
  report_options options = {1, 300, 0};

  if (!report_parse(argc, argv, &options)) return 2;
  state_each(&options, check);
  return report_done("derivative_motion");
}
