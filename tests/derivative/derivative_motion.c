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

#include "derivative.h"
#include "property/mechanism.h"
#include "property/vector.h"
#include "reference.h"
#include "sample.h"

/* more columns than one strip has, and not a multiple of it */
enum { COLUMNS = 2 * MAGGI_NDIR + 3 };

/* Near a singular position derivatives depend much on the last digits of the state: beside 1e-11 of its
 * size a derivative may be wrong by 1e-15 of its change per relative change of the state, measured with
 * a small one. */
#define TREMOR 1e-6
#define SHARE  1e-4

typedef struct motion {
  const char *name; /* for messages */
  uint64_t seed;
  maggi_data *d;
  maggi_derivative *D;
  double time;
  mech_random random;
  int nq, np, nx, ny;
} motion;

/* ------------------------------------------------------------------------------------- vectors */

static double *numbers(int n)
{
  double *a = calloc((size_t)n + 1, sizeof *a);

  if (!a) abort();
  return a;
}

/* a direction of everything, parameters in their own size */
static double *direction(motion *m)
{
  double *x = numbers(m->nx), size;
  int i;

  for (i = 0; i < m->nx; ++i) x[i] = mech_uniform(&m->random, -1.0, 1.0);
  for (i = 0; i < m->np; ++i) {
    size = fabs(m->d->p[i]);
    x[2 * m->nq + i] *= size > 0.0 ? size : 0.1;
  }
  return x;
}

static double *weights(motion *m)
{
  double *y = numbers(m->ny);
  int i;

  for (i = 0; i < m->ny; ++i) y[i] = mech_uniform(&m->random, -1.0, 1.0);
  return y;
}

static double dot(int n, const double *a, const double *b, double *terms)
{
  double sum = 0.0;
  int i;

  for (i = 0; i < n; ++i) {
    sum += a[i] * b[i];
    *terms += fabs(a[i] * b[i]);
  }
  return sum;
}

/* largest difference, relative to the largest number of b; not a number if one of a is not */
static double distance(int n, const double *a, const double *b, const double *shaken)
{
  double error = 0.0, size = 0.0, change = 0.0;
  int i;

  for (i = 0; i < n; ++i) {
    if (!isfinite(a[i])) return NAN;
    error = fmax(error, fabs(a[i] - b[i]));
    size = fmax(size, fabs(b[i]));
    if (shaken) change = fmax(change, fabs(shaken[i] - b[i]));
  }
  return error > 0.0 ? error / (size + SHARE * change / TREMOR) : 0.0;
}

/* velocities and accelerations each */
static double distance2(const motion *m, const double *a, const double *b, const double *shaken)
{
  double v = distance(m->nq, a, b, shaken);
  double w = distance(m->nq, a + m->nq, b + m->nq, shaken ? shaken + m->nq : NULL);

  return v > w || isnan(v) ? v : w;
}

static void near(const motion *m, const char *what, double residual, double limit)
{
  if (!report_near(m->seed, what, residual, limit)) fprintf(stderr, "  %s\n", m->name);
}

static void near_sum(const motion *m, const char *what, double left, double right, double terms,
                     double limit)
{
  double error = fabs(left - right);

  near(m, what, error > 0.0 ? error / terms : error, limit);
}

/* -------------------------------------------------------------------------------- complex step */

/* derivative of y along x, at the state of the simulation moved by `move` along `to` */
static void complex_step(const motion *m, const double *x, long double move, const double *to,
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
  for (i = 0; i < m->ny; ++i) {
    out = reference_motion_array(z, i < n ? "v" : "a");
    k = d->m->coordinate[i % n].q;
    yd[i] = cimagl(out[k]) / REFERENCE_STEP;
  }
  reference_motion_free(z);
}

static double *complex_jvp(const motion *m, const double *x, double move, const double *to)
{
  double *yd = numbers(m->ny);
  long double *exact = calloc((size_t)m->ny + 1, sizeof *exact);
  int i;

  if (!exact) abort();
  complex_step(m, x, move, to, exact);
  for (i = 0; i < m->ny; ++i) yd[i] = (double)exact[i];
  free(exact);
  return yd;
}

/* w.y' at the moved state */
static long double moved_slope(const motion *m, const double *w, const double *x, long double move,
                               const double *to)
{
  long double *yd = calloc((size_t)m->ny + 1, sizeof *yd), sum = 0.0L;
  int i;

  if (!yd) abort();
  complex_step(m, x, move, to, yd);
  for (i = 0; i < m->ny; ++i) sum += w[i] * yd[i];
  free(yd);
  return sum;
}

/* Its derivative along `to` by central differences of decreasing steps, extrapolated to zero; of these
 * the one that agrees best with its neighbours.  C. J. F. Ridders, Advances in Engineering Software 4
 * (1982) 75. */
static double complex_bend(const motion *m, const double *w, const double *x, const double *to)
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

static double *jvp(const motion *m, const double *x)
{
  double *y = numbers(m->ny);

  maggi_motion_jvp(m->D, x, x + m->nq, x + 2 * m->nq, y, y + m->nq);
  return y;
}

static double *vjp(const motion *m, const double *w)
{
  double *g = numbers(m->nx);

  maggi_motion_vjp(m->D, w, w + m->nq, g, g + m->nq, g + 2 * m->nq);
  return g;
}

static double *hvp(const motion *m, const double *w, const double *u)
{
  double *g = numbers(m->nx);
  int n = m->nq;

  maggi_motion_hvp(m->D, w, w + n, u, u + n, u + 2 * n, g, g + n, g + 2 * n);
  return g;
}

static void check_against_complex(motion *m, const char *what, const double *x, const double *y)
{
  double *right, *shaken, *to = direction(m);

  right = complex_jvp(m, x, 0.0, to);
  shaken = complex_jvp(m, x, TREMOR, to);
  near(m, what, distance2(m, y, right, shaken), 1e-11);
  free(right);
  free(shaken);
  free(to);
}

static void check_jvp(motion *m)
{
  double *x = direction(m), *y = jvp(m, x);

  check_against_complex(m, "jvp", x, y);
  /* nothing of that is left */
  memset(x + 2 * m->nq, 0, (size_t)m->np * sizeof *x);
  maggi_motion_jvp(m->D, x, x + m->nq, NULL, y, y + m->nq);
  check_against_complex(m, "jvp, parameters at rest", x, y);
  free(x);
  free(y);
}

static void check_jac(motion *m)
{
  double *columns = numbers(m->nx * COLUMNS), *J = numbers(m->ny * COLUMNS), *x, *y;
  double *column = numbers(m->ny);
  int i, c, n = m->nq * COLUMNS;

  for (c = 0; c < COLUMNS; ++c) {
    x = direction(m);
    for (i = 0; i < m->nx; ++i) columns[i * COLUMNS + c] = x[i];
    free(x);
  }
  maggi_motion_jac(m->D, COLUMNS, columns, columns + n, columns + 2 * n, J, J + n);
  x = numbers(m->nx);
  for (c = 0; c < COLUMNS; ++c) {
    for (i = 0; i < m->nx; ++i) x[i] = columns[i * COLUMNS + c];
    for (i = 0; i < m->ny; ++i) column[i] = J[i * COLUMNS + c];
    y = jvp(m, x);
    near(m, "jac, columns against jvp", distance2(m, column, y, NULL), 1e-11);
    free(y);
  }
  free(columns);
  free(J);
  free(x);
  free(column);
}

/* every entry of the gradient g counts as much along x, where it is not zero */
static double *balanced(motion *m, const double *g)
{
  double *x = direction(m), most = 0.0;
  int i;

  for (i = 0; i < m->nx; ++i) most = fmax(most, fabs(g[i] * x[i]));
  for (i = 0; i < m->nx; ++i)
    x[i] = fabs(g[i] * x[i]) > 1e-6 * most ? (x[i] > 0.0 ? 1.0 : -1.0) / g[i] : 0.0;
  return x;
}

static void check_vjp(motion *m)
{
  double *w = weights(m), *g = vjp(m, w), *x = direction(m), *y = jvp(m, x), *right;
  double left, terms = 0.0;

  left = dot(m->ny, w, y, &terms);
  near_sum(m, "vjp against jvp", left, dot(m->nx, g, x, &terms), terms, 1e-11);
  free(x);
  free(y);
  x = balanced(m, g);
  right = complex_jvp(m, x, 0.0, x);
  terms = 0.0;
  left = dot(m->ny, w, right, &terms);
  near_sum(m, "vjp, entries of all sizes", left, dot(m->nx, g, x, &terms), terms, 1e-11);
  report_true(m->seed, "the gradient is not zero", terms > 0.0);
  free(w);
  free(g);
  free(x);
  free(right);
}

/* where a damper or a function of time has a kink, derivatives jump */
static int is_near_kink(const motion *m)
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
    n = t->funkind[i] == MAGGI_FUNCTION_STEP ? 2 : t->funn[i];
    if (t->funkind[i] < MAGGI_FUNCTION_STEP) continue;
    for (k = 0; k < n; ++k)
      if (fabs(m->time - d->p[t->funadr[i] + k]) < 1e-3) return 1;
  }
  return 0;
}

static void check_hvp(motion *m)
{
  double *w = weights(m), *u = direction(m), *x = direction(m), *hu = hvp(m, w, u);
  double *hx = hvp(m, w, x), left, right, terms = 0.0;

  left = dot(m->nx, x, hu, &terms);
  right = dot(m->nx, u, hx, &terms);
  near_sum(m, "hvp, symmetry", left, right, terms, 1e-11);
  report_true(m->seed, "the second derivative is not zero", terms > 0.0);
  if (is_near_kink(m)) {
    report_count("hvp not against differences: near a kink");
  } else {
    terms = 0.0;
    left = dot(m->nx, x, hu, &terms);
    near_sum(m, "hvp", left, complex_bend(m, w, x, u), terms, 1e-11);
  }
  free(w);
  free(u);
  free(x);
  free(hu);
  free(hx);
}

static void check_state(motion *m)
{
  check_jvp(m);
  check_jac(m);
  check_vjp(m);
  check_hvp(m);
}

/* another time, other parameters and velocities; positions that do not close the loops */
static void move_away(motion *m)
{
  maggi_data *d = m->d;
  int i;

  if (d->t.nguide == 0) m->time = mech_uniform(&m->random, -0.2, 1.2);
  for (i = 0; i < m->np; ++i) d->p[i] *= mech_uniform(&m->random, 0.98, 1.02);
  for (i = 0; i < m->nq; ++i) d->q[i] += mech_uniform(&m->random, -0.05, 0.05);
  for (i = 0; i < d->t.nind; ++i) d->vcol[i] += mech_uniform(&m->random, -1.0, 1.0);
  maggi_constants(d);
  maggi_evaluate(d, m->time);
}

static void check_sample(const sample *s)
{
  motion m = {s->name, s->seed, s->data, NULL, s->data->time, {s->seed}, 0, 0, 0, 0};
  int ok;

  m.nq = s->data->m->ncoordinate;
  m.np = s->data->t.np;
  m.nx = 2 * m.nq + m.np;
  m.ny = 2 * m.nq;
  ok = maggi_derivative_create(s->data, (int)(s->seed % 3) * 12, &m.D) == MAGGI_OK;
  if (!report_true(s->seed, "workspace", ok)) return;
  if (report_true(s->seed, "linearise", maggi_linearise(m.D) == MAGGI_OK)) check_state(&m);
  move_away(&m);
  if (maggi_is_singular(s->data))
    report_count("away from closed loops: singular");
  else if (report_true(s->seed, "linearise", maggi_linearise_at(m.D, m.time) == MAGGI_OK))
    check_state(&m);
  maggi_derivative_free(m.D);
}

int main(int argc, char **argv)
{
  report_options options = {1, 300, 0};

  if (!report_parse(argc, argv, &options)) return 2;
  sample_each(&options, check_sample);
  return report_done("derivative_motion");
}
