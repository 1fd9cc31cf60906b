/* Derivatives of signals (results.h) on every mechanism, as functions of (q, v_i, p) by an evaluation and
 * of (q, v, a, p) with velocities and accelerations given, where these do not close the loops:
 *
 *   strip    against complex step
 *   adjoint  y_.y' = x_.x' with the tangents of the strip; against complex step along a direction in
 *            which every entry of the gradient counts as much
 *
 * of coordinates and energies, of reactions, of one sensor and of all signals, each with what it needs.
 * Directions differ from one to the next, so that tangents which are left from before are wrong.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"
#include "results.h"
#include "state.h"

enum { W = MAGGI_NDIR };

typedef struct probe {
  state *s;
  int is_given;
  int nrate; /* numbers of coordinates before the parameters: q, v or q, v, a */
  int n;     /* signals */
  int *signal;
  unsigned need;
} probe;

/* -------------------------------------------------------------------------------- complex step */

/* the state of the simulation moved by `move` along `to`, with a step along x */
static reference_motion *moved(const probe *o, const double *x, long double move, const double *to)
{
  const maggi_data *d = o->s->d;
  reference_motion *z = reference_motion_create(&d->t, d->m->originadr);
  reference_number *q = reference_motion_array(z, "q"), *v = reference_motion_array(z, "v");
  reference_number *a = reference_motion_array(z, "a"), *vcol = reference_motion_array(z, "vcol");
  reference_number *p = reference_motion_array(z, "p"), step[3] = {0.0L};
  reference_number *y = reference_motion_array(z, "y");
  int i, j, k, c, nq = o->s->nq;

  for (i = 0; i < d->t.nstate; ++i) y[i] = d->y[i]; /* moved by whole simulations alone */
  for (i = 0; i < nq; ++i) {
    k = d->m->coordinate[i].q;
    c = d->t.col[k];
    for (j = 0; j < 3 && j * nq < o->nrate; ++j)
      step[j] = move * to[j * nq + i] + _Complex_I * REFERENCE_STEP * x[j * nq + i];
    q[k] = d->q[k] + step[0];
    if (o->is_given) {
      v[k] = d->v[k] + step[1];
      a[k] = d->a[k] + step[2];
    } else if (c >= 0 && c < d->t.nind) {
      vcol[c] = d->vcol[c] + step[1];
    }
  }
  for (i = 0; i < o->s->np; ++i)
    p[i] = d->p[i] + move * to[o->nrate + i] + _Complex_I * REFERENCE_STEP * x[o->nrate + i];
  if (o->is_given)
    reference_motion_given(z, o->s->time);
  else
    reference_motion_evaluate(z, o->s->time);
  return z;
}

/* derivatives of the signals along x */
static double *complex_step(const probe *o, const double *x, double move, const double *to)
{
  static const char *const array[] = {
      [MAGGI_SIGNAL_POSITION] = "q",     [MAGGI_SIGNAL_VELOCITY] = "v",
      [MAGGI_SIGNAL_ACCELERATION] = "a", [MAGGI_SIGNAL_WRENCH] = "wrench",
      [MAGGI_SIGNAL_SENSOR] = "sensor",  [MAGGI_SIGNAL_FILTER] = "weighted"};
  reference_motion *z = moved(o, x, move, to);
  reference_number energy[3], value;
  maggi_signal_place place;
  double *yd = state_numbers(o->n);
  int i;

  reference_motion_energy(z, energy);
  energy[2] = energy[0] + energy[1];
  for (i = 0; i < o->n; ++i) {
    place = maggi_signal_at(o->s->d->m, o->signal[i]);
    if (place.kind >= MAGGI_SIGNAL_KINETIC && place.kind <= MAGGI_SIGNAL_TOTAL)
      value = energy[place.kind - MAGGI_SIGNAL_KINETIC];
    else
      value = reference_motion_array(z, array[place.kind])[place.index];
    yd[i] = (double)(cimagl(value) / REFERENCE_STEP);
  }
  reference_motion_free(z);
  return yd;
}

/* ------------------------------------------------------------------------------------- compared */

/* positions, velocities, accelerations, energies, forces */
enum { LEVELS = 5 };

static int level_of(const probe *o, int i)
{
  const char *unit = maggi_signal_unit(o->s->d->m, o->signal[i]);

  if (*unit == 'J') return 3;
  if (*unit == 'N') return 4;
  return strstr(unit, "/s^2") ? 2 : strstr(unit, "/s") ? 1 : 0;
}

/* what nothing moves: the rate of a rod, sensors of bodies that do not turn, .. */
#define STILL 1e-9

static double largest(int n, const double *a)
{
  double size = 0.0;
  int i;

  for (i = 0; i < n; ++i) size = fmax(size, fabs(a[i]));
  return size;
}

/* Largest of the distances in each level between columns of strips.  All columns of a level have one size:
 * a direction along which the terms of a derivative cancel does not make them smaller. */
static double distance(const probe *o, const double *a, const double *b, const double *shaken)
{
  int level, i, n, all = o->n * W;
  double *part = state_numbers(3 * all), worst = 0.0, error;

  for (level = 0; level < LEVELS; ++level) {
    for (i = n = 0; i < all; ++i) {
      if (level_of(o, i / W) != level) continue;
      part[n] = a[i];
      part[all + n] = b[i];
      part[2 * all + n++] = shaken[i];
    }
    if (largest(n, part + all) > STILL)
      error = state_distance(n, part, part + all, part + 2 * all);
    else
      error = largest(n, part);
    worst = worst > error || isnan(worst) ? worst : error;
  }
  free(part);
  return worst;
}

/* random weights by which each level counts as much in a sum with y */
static double *weights(const probe *o, const double *y)
{
  double *w = state_weights(o->s, o->n), size[LEVELS] = {0.0};
  int i;

  for (i = 0; i < o->n; ++i) size[level_of(o, i)] = fmax(size[level_of(o, i)], fabs(y[i]));
  for (i = 0; i < o->n; ++i)
    if (size[level_of(o, i)] > STILL) w[i] /= size[level_of(o, i)];
  return w;
}

/* ---------------------------------------------------------------------------------- derivatives */

/* tangents of the signals along W directions, the columns of x */
static double *strip(const probe *o, const double *x)
{
  maggi_derivative *D = o->s->D;
  double *to[3] = {D->strip.q, D->strip.v, D->strip.a}, *y = state_numbers(o->n * W);
  int i, j, k, nq = o->s->nq;

  maggi_parameters_jac(D, W, W, x + o->nrate * W);
  for (i = 0; i < nq; ++i) {
    k = D->d->m->coordinate[i].q;
    for (j = 0; j < 3 && j * nq < o->nrate; ++j)
      memcpy(to[j] + k * W, x + (j * nq + i) * W, W * sizeof(double));
  }
  if (!o->is_given) maggi_strip_motion(D);
  maggi_strip_given(D, o->need);
  maggi_signals_strip(D, o->n, o->signal, y);
  return y;
}

static double *adjoint(const probe *o, const double *w)
{
  maggi_derivative *D = o->s->D;
  const maggi_topo *t = &D->d->t;
  double *from[3] = {D->adjoint.q, D->adjoint.v, D->adjoint.a};
  double *g = state_numbers(o->nrate + o->s->np);
  int i, j, k, nq = o->s->nq, is_independent;

  maggi_parameters_clear(D);
  maggi_companion_clear(&D->adjoint);
  maggi_signals_seed(D, o->n, o->signal, w);
  if (o->is_given) {
    maggi_adjoint_given(D, o->need);
  } else {
    maggi_adjoint_results(D, o->need);
    maggi_adjoint_motion(D);
  }
  for (i = 0; i < nq; ++i) {
    k = D->d->m->coordinate[i].q;
    is_independent = t->col[k] >= 0 && t->col[k] < t->nind;
    for (j = 0; j < 3 && j * nq < o->nrate; ++j)
      if (j == 0 || o->is_given || is_independent) g[j * nq + i] = from[j][k];
  }
  maggi_parameters_vjp(D, g + o->nrate);
  return g;
}

/* --------------------------------------------------------------------------------------- checks */

/* every W-th number of the columns of a strip */
static void column(int n, const double *columns, int c, double *x)
{
  int i;

  for (i = 0; i < n; ++i) x[i] = columns[i * W + c];
}

/* derivatives along the columns, as a strip has them */
static double *complex_steps(const probe *o, const double *columns, double move, const double *to)
{
  int nx = o->nrate + o->s->np, i, c;
  double *all = state_numbers(o->n * W), *x = state_numbers(nx), *y;

  for (c = 0; c < W; ++c) {
    column(nx, columns, c, x);
    y = complex_step(o, x, move, to);
    for (i = 0; i < o->n; ++i) all[i * W + c] = y[i];
    free(y);
  }
  free(x);
  return all;
}

/* whether anything moves the signals */
static int check_strip(const probe *o, const double *columns, const double *strips)
{
  double *to = state_direction(o->s, o->nrate), *right, *shaken;
  int moves;

  right = complex_steps(o, columns, 0.0, to);
  shaken = complex_steps(o, columns, STATE_TREMOR, to);
  moves = largest(o->n * W, right) > STILL;
  state_near(o->s, o->is_given ? "strip, given" : "strip", distance(o, strips, right, shaken),
             1e-11);
  free(to);
  free(right);
  free(shaken);
  return moves;
}

/* w.y' along x at the state moved by `move` along `to` */
static double moved_slope(const probe *o, const double *w, const double *x, double move,
                          const double *to, double *terms)
{
  double *y = complex_step(o, x, move, to), slope = state_dot(o->n, w, y, terms);

  free(y);
  return slope;
}

static void check_balanced(const probe *o, const double *w, const double *g)
{
  double *x = state_balanced(o->s, o->nrate, g), *to = state_direction(o->s, o->nrate);
  double left, right, shaken, unused = 0.0, terms = 0.0;

  left = moved_slope(o, w, x, 0.0, to, &terms);
  shaken = moved_slope(o, w, x, STATE_TREMOR, to, &unused);
  right = state_dot(o->nrate + o->s->np, g, x, &terms);
  report_true(o->s->seed, "the gradient is not zero", terms > 0.0);
  terms += STATE_SHARE * fabs(shaken - left) / STATE_TREMOR;
  state_near_sum(
      o->s, o->is_given ? "adjoint, given, entries of all sizes" : "adjoint, entries of all sizes",
      left, right, terms, 1e-11);
  free(x);
  free(to);
}

/* with the tangents y, the columns of strips, along the columns */
static void check_adjoint(const probe *o, const double *columns, const double *strips, double *y)
{
  int nx = o->nrate + o->s->np, c;
  double *x = state_numbers(nx), *w = weights(o, y), *g = adjoint(o, w), left, terms;

  for (c = 0; c < W; ++c) {
    column(nx, columns, c, x);
    column(o->n, strips, c, y);
    terms = 0.0;
    left = state_dot(o->n, w, y, &terms);
    state_near_sum(o->s, o->is_given ? "adjoint against strip, given" : "adjoint against strip",
                   left, state_dot(nx, g, x, &terms), terms, 1e-11);
  }
  check_balanced(o, w, g);
  free(x);
  free(w);
  free(g);
}

static void check_probe(const probe *o)
{
  int nx = o->nrate + o->s->np, i, c;
  double *columns = state_numbers(nx * W), *x, *y, *strips;

  for (c = 0; c < W; ++c) {
    x = state_direction(o->s, o->nrate);
    for (i = 0; i < nx; ++i) columns[i * W + c] = x[i];
    free(x);
  }
  strips = strip(o, columns);
  y = state_numbers(o->n);
  column(o->n, strips, W - 1, y);
  if (check_strip(o, columns, strips)) check_adjoint(o, columns, strips, y);
  free(columns);
  free(strips);
  free(y);
}

static void check_signals(probe *o, int first, int n)
{
  int i;

  o->n = n;
  for (i = 0; i < n; ++i) o->signal[i] = first + i;
  o->need = maggi_signals_need(o->s->d->m, n, o->signal);
  if (n > 0) check_probe(o);
}

/* all columns of a sensor, of which the first one is signal `first` */
static void check_sensor(probe *o, int first, int sensor)
{
  const maggi_model *m = o->s->d->m;
  int i = 0, n = 0;

  while (m->sensorplace[i] / 3 != sensor) ++i;
  while (i + n < m->ncolumn && m->sensorplace[i + n] / 3 == sensor) ++n;
  check_signals(o, first + i, n);
}

static void check_all(state *s, int is_given)
{
  const maggi_model *m = s->d->m;
  int number = maggi_signal_number(m), begin = 3 * m->ncoordinate + 3, end = begin + 6 * m->nbody;
  probe o = {s, is_given, is_given ? 3 * s->nq : 2 * s->nq, 0, NULL, 0};

  o.signal = calloc((size_t)number, sizeof *o.signal);
  if (!o.signal) abort();
  check_signals(&o, 0, begin);
  check_signals(&o, begin, end - begin);
  if (m->topo.nsensor > 0) check_sensor(&o, end, mech_integer(&s->random, m->topo.nsensor));
  check_signals(&o, 0, number);
  free(o.signal);
}

static void check(state *s)
{
  maggi_data *d = s->d;
  int i;

  check_all(s, 0);
  for (i = 0; i < s->nq; ++i) {
    d->v[i] += mech_uniform(&s->random, -0.5, 0.5);
    d->a[i] += mech_uniform(&s->random, -0.5, 0.5);
  }
  maggi_evaluate_given(d, s->time);
  if (report_true(s->seed, "linearise", maggi_linearise_at(s->D, s->time) == MAGGI_OK))
    check_all(s, 1);
}

int main(int argc, char **argv)
{
  report_options options = {1, 300, 0};

  if (!report_parse(argc, argv, &options)) return 2;
  state_each(&options, check);
  return report_done("derivative_results");
}
