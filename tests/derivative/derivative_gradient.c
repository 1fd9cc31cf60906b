/* Gradients of objectives of whole simulations, maggi_gradient, against the complex step of simulation
 * and objective (replay.h):
 *
 *   adjoint  with respect to all parameters, along directions, also along one in which every entry of the
 *            gradient counts as much; the same to the last bit from few snapshots
 *   direct   with respect to design parameters that move all entries together
 *
 * Objectives are evaluated here once more, with complex numbers. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "aim.h"
#include "course.h"
#include "replay.h"

enum { LANES = 2, OBJECTIVES = 12, SNAPSHOTS = 4 };

/* as in derivative_simulation.c */
#define ROUNDOFF 1e-12
#define DIVERGED 3e-11

typedef struct study {
  const course *c;
  const maggi_model *m;
  maggi_data *d;
  mech_random random;
  maggi_grid grid;
  long steps;   /* until round-off of the simulation has grown */
  double grown; /* so far */
  int np, nsignal, naim;
  aim aim[OBJECTIVES];
  double *x[LANES];
  reference_number *value[LANES]; /* of all signals over time */
  double *gradient;               /* naim x np */
} study;

static void *room(long n, size_t size)
{
  void *a = calloc((size_t)n + 1, size);

  if (!a) abort();
  return a;
}

static void near(const study *s, const char *what, const char *of, double residual, double limit)
{
  residual *= ROUNDOFF / s->c->precision / s->grown;
  if (!report_near(s->c->seed, what, residual, limit))
    fprintf(stderr, "  %s: %s\n", s->c->name, of);
}

static int succeeds(const study *s, const char *what, maggi_status status, const char *message)
{
  if (report_true(s->c->seed, what, status == MAGGI_OK)) return 1;
  fprintf(stderr, "  %s: %s\n", s->c->name, message);
  return 0;
}

/* --------------------------------------------------------------------------- complex simulations */

/* of the real simulation from the complex one, of positions and velocities relative to the largest */
static double distance(const study *s, replay *r, const reference_number *z)
{
  int n = s->m->ncoordinate, i, k;
  double *x = room(2 * n, sizeof *x), error[2] = {0.0}, size[2] = {1.0, 1.0};

  maggi_get_coordinates(replay_data(r), x, x + n, NULL);
  for (i = 0; i < 2 * n; ++i) {
    k = i / n;
    size[k] = fmax(size[k], fabs(x[i]));
    error[k] = fmax(error[k], fabs(x[i] - (double)creall(z[3 * (i % n) + k])));
  }
  free(x);
  return fmax(error[0] / size[0], error[1] / size[1]);
}

/* values over time; fewer steps where the motion diverges or fails; NULL when it is not replayed */
static reference_number *simulate(study *s, const double *x)
{
  reference_number *values, *z;
  replay *r = replay_create(s->d, x);
  double margin, error;
  long k;

  if (!r) return NULL;
  values = room((s->steps + 1) * s->nsignal, sizeof *values);
  for (k = 0; k <= s->steps; ++k) {
    z = values + k * s->nsignal;
    replay_values(r, z);
    course_segments(replay_data(r), &margin);
    error = distance(s, r, z) / s->c->precision;
    if (error > DIVERGED || margin <= COURSE_KNEE) {
      s->steps = k - 1;
      continue;
    }
    s->grown = fmax(s->grown, error);
    if (k < s->steps) {
      if (replay_step(r, maggi_grid_time(&s->grid, k + 1) - maggi_grid_time(&s->grid, k)) !=
          MAGGI_OK)
        s->steps = k;
    }
  }
  replay_free(r);
  return values;
}

static reference_number outcome(const study *s, const aim *a, const reference_number *values)
{
  trace whole = {s->c->step, s->steps, s->nsignal, values};

  return aim_outcome(a, &whole);
}

/* ---------------------------------------------------------------------------------------- choices */

static double product(void *context, double t, int n, const double *signals, double *gradient)
{
  (void)context, (void)t, (void)n;
  gradient[0] = signals[1];
  gradient[1] = signals[0];
  return signals[0] * signals[1];
}

/* what an objective may be made of: first signal, number, stride */
static int pick(study *s, int first, int n, int stride)
{
  int signal, i, attempt;
  double size, change, largest = 0.0;
  long k;

  if (n == 0) return -1;
  for (k = 0; k <= s->steps; ++k)
    for (i = 0; i < n; ++i)
      largest = fmax(largest, fabsl(cimagl(s->value[0][k * s->nsignal + first + i * stride])));
  for (attempt = 0; attempt < 40; ++attempt) {
    signal = first + mech_integer(&s->random, n) * stride;
    size = change = 0.0;
    for (k = 0; k <= s->steps; ++k) {
      size = fmax(size, fabsl(creall(s->value[0][k * s->nsignal + signal])));
      change = fmax(change, fabsl(cimagl(s->value[0][k * s->nsignal + signal])));
    }
    if (size > 1e-6 && change > 1e-2 * largest &&
        maggi_signal_find(s->m, maggi_signal_name(s->m, signal)) == signal)
      return signal;
  }
  return -1;
}

/* so much that a difference of two of its values in the window has digits, and its derivative too */
static int varies(const study *s, const maggi_objective_def *d, int signal)
{
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, x[2];
  long k;
  int i;

  for (k = 0; k <= s->steps; ++k) {
    if (k * s->c->step < d->from || k * s->c->step > d->to) continue;
    x[0] = (double)creall(s->value[0][k * s->nsignal + signal]);
    x[1] = (double)cimagl(s->value[0][k * s->nsignal + signal]);
    for (i = 0; i < 2; ++i) {
      low[i] = fmin(low[i], x[i]);
      high[i] = fmax(high[i], x[i]);
    }
  }
  for (i = 0; i < 2; ++i)
    if (!(high[i] - low[i] > 0.02 * fmax(fabs(low[i]), fabs(high[i])))) return 0;
  return 1;
}

/* in a part of the time, relative to one of its ends */
static void choose_window(study *s, maggi_objective_def *d, int signal)
{
  double T = s->steps * s->c->step;

  if (d->type != MAGGI_OBJECTIVE_TERMINAL) d->from = mech_uniform(&s->random, 0.0, 0.4) * T;
  d->to = mech_uniform(&s->random, 0.6, 1.0) * T;
  if ((d->type == MAGGI_OBJECTIVE_NORM || d->type == MAGGI_OBJECTIVE_MEAN ||
       d->type == MAGGI_OBJECTIVE_VDV) &&
      varies(s, d, signal))
    d->reference = (maggi_reference_type)(1 + mech_integer(&s->random, 2));
}

static void add_aim(study *s, maggi_objective_type type, int signal, int other, int has_window)
{
  aim *a = &s->aim[s->naim];
  char message[300];
  double largest = 0.0, mean = 0.0;
  long k;
  int i;

  if (signal < 0) return;
  ++s->naim;
  a->signal[0] = signal;
  a->signal[1] = other;
  for (i = 0; i < 2; ++i) a->name[i] = maggi_signal_name(s->m, a->signal[i]);
  maggi_objective_def_init(&a->def);
  a->def.name = maggi_objective_type_name(type);
  a->def.type = type;
  a->def.signal = a->name[0];
  if (has_window) choose_window(s, &a->def, signal);
  if (type == MAGGI_OBJECTIVE_SLOPE) {
    if (!varies(s, &a->def, other)) {
      --s->naim;
      return;
    }
    a->def.against = a->name[1];
  } else if (other >= 0) {
    a->def.signal = NULL;
    a->def.nsignal = 2;
    a->def.signals = a->name;
    a->def.function = product;
  } else {
    a->def.target = mech_uniform(&s->random, -0.1, 0.1);
  }
  for (k = 0; k <= s->steps; ++k)
    largest = fmax(largest, fabsl(creall(s->value[0][k * s->nsignal + signal])));
  for (k = 0; k <= s->steps; ++k)
    mean += (double)creall(s->value[0][k * s->nsignal + signal]) / (double)(s->steps + 1);
  if (type == MAGGI_OBJECTIVE_VIOLATION)
    a->def.target = mean - 0.1 * largest; /* above it at times */
  if (type == MAGGI_OBJECTIVE_SMOOTH_MAXIMUM) a->def.sharpness = 3.0 / largest;
  if (type == MAGGI_OBJECTIVE_VALUE || type == MAGGI_OBJECTIVE_LEAST_SQUARES) {
    a->def.number = AIM_TIMES;
    a->def.times = a->times;
    if (type == MAGGI_OBJECTIVE_LEAST_SQUARES) a->def.values = a->values;
    for (i = 0; i < AIM_TIMES; ++i) {
      a->times[i] = s->steps * s->c->step * (i + mech_uniform(&s->random, 0.1, 0.9)) / AIM_TIMES;
      a->values[i] = mech_uniform(&s->random, 0.0, largest);
    }
  }
  succeeds(s, "the objective is accepted",
           maggi_objective_create(s->m, &a->def, &a->objective, message, sizeof message), message);
}

static void choose_aims(study *s)
{
  int n = s->m->ncoordinate, energy = 3 * n, wrench = energy + 3, w = 6 * s->m->nbody;
  int sensors = s->m->ncolumn, at = wrench + w, velocity;

  velocity = pick(s, 1, n, 3);
  add_aim(s, MAGGI_OBJECTIVE_INTEGRAL_SQUARE, velocity, -1, 0);
  add_aim(s, MAGGI_OBJECTIVE_RMS, pick(s, 2, n, 3), -1, 0);
  add_aim(s, MAGGI_OBJECTIVE_TERMINAL, pick(s, energy, 3, 1), -1, 0);
  add_aim(s, MAGGI_OBJECTIVE_MEAN, pick(s, wrench, w, 1), -1, 0);
  add_aim(s, MAGGI_OBJECTIVE_VDV, pick(s, at, sensors, 1), -1, 0);
  add_aim(s, MAGGI_OBJECTIVE_SMOOTH_MAXIMUM, pick(s, at, sensors, 1), -1, 0);
  add_aim(s, mech_integer(&s->random, 2) ? MAGGI_OBJECTIVE_VALUE : MAGGI_OBJECTIVE_LEAST_SQUARES,
          pick(s, 0, n, 3), -1, 0);
  if (velocity >= 0) add_aim(s, MAGGI_OBJECTIVE_INTEGRAL, pick(s, wrench, w, 1), velocity, 0);
  add_aim(s, MAGGI_OBJECTIVE_NORM, pick(s, at, sensors, 1), -1, 1);
  add_aim(s, mech_integer(&s->random, 2) ? MAGGI_OBJECTIVE_TERMINAL : MAGGI_OBJECTIVE_MEAN,
          pick(s, 2, n, 3), -1, 1);
  add_aim(s, mech_integer(&s->random, 2) ? MAGGI_OBJECTIVE_VDV : MAGGI_OBJECTIVE_VIOLATION,
          pick(s, 1, n, 3), -1, 1);
  if (velocity >= 0) add_aim(s, MAGGI_OBJECTIVE_SLOPE, pick(s, 2, n, 3), velocity, 1);
}

/* ----------------------------------------------------------------------------------------- checks */

static int gradient(study *s, const maggi_design *design, maggi_method method, int snapshots,
                    double *value, double *g)
{
  maggi_objective *objective[OBJECTIVES];
  maggi_gradient_options options;
  int i;

  maggi_gradient_options_init(&options);
  options.time = s->steps * s->c->step;
  options.step = s->c->step;
  options.method = method;
  options.snapshots = snapshots;
  for (i = 0; i < s->naim; ++i) objective[i] = s->aim[i].objective;
  return succeeds(s, "a gradient is computed",
                  maggi_gradient(s->d, design, s->naim, objective, &options, value, g),
                  maggi_data_message(s->d));
}

static double slope(reference_number z)
{
  return (double)(cimagl(z) / REFERENCE_STEP);
}

static double along(const study *s, const double *g, const double *x, double *terms)
{
  double sum = 0.0;
  int i;

  *terms = 0.0;
  for (i = 0; i < s->np; ++i) {
    sum += g[i] * x[i];
    *terms += fabs(g[i] * x[i]);
  }
  return sum;
}

/* every entry of the gradient counts as much */
static void check_balanced(study *s, const aim *a, const double *g)
{
  double *x = room(s->np, sizeof *x), most = 0.0, terms, sum, size;
  reference_number *values;
  long steps = s->steps;
  int i;

  for (i = 0; i < s->np; ++i) {
    size = fabs(s->d->p[i]) > 0.0 ? fabs(s->d->p[i]) : 0.1;
    x[i] = s->x[0][i] == 0.0 ? 0.0 : g[i] * size;
    most = fmax(most, fabs(x[i]));
  }
  for (i = 0; i < s->np; ++i)
    x[i] = fabs(x[i]) > 1e-6 * most ? (mech_integer(&s->random, 2) ? 1.0 : -1.0) / g[i] : 0.0;
  values = simulate(s, x);
  sum = along(s, g, x, &terms);
  report_true(s->c->seed, "the gradient is not zero", terms > 0.0);
  if (!report_true(s->c->seed, "the same complex simulation", values && s->steps == steps))
    fprintf(stderr, "  %s: %s\n", s->c->name, a->def.name);
  else
    near(s, "adjoint, entries of all sizes", a->def.name,
         fabs(sum - slope(outcome(s, a, values))) / terms, 1e-10);
  s->steps = steps;
  free(values);
  free(x);
}

static void check_adjoint(study *s)
{
  double *value = room(s->naim, sizeof *value), *again = room(s->naim * s->np, sizeof *again);
  double sum, terms;
  reference_number exact;
  maggi_design *all;
  char message[300];
  int i, lane, ok;

  if (maggi_design_create(s->d, &all) != MAGGI_OK) abort();
  ok = succeeds(s, "all parameters", maggi_design_select(all, "all", message, sizeof message),
                message) &&
       gradient(s, all, MAGGI_METHOD_ADJOINT, 0, value, s->gradient) &&
       gradient(s, all, MAGGI_METHOD_ADJOINT, SNAPSHOTS, value, again);
  if (ok)
    report_true(s->c->seed, "adjoint: the same from few snapshots",
                memcmp(again, s->gradient, (size_t)(s->naim * s->np) * sizeof *again) == 0);
  for (i = 0; i < s->np && ok; ++i)
    ok = report_true(s->c->seed, "all parameters are those of p, in order",
                     strcmp(maggi_design_name(all, i), maggi_parameter_path(s->m, i)) == 0);
  for (i = 0; i < s->naim && ok; ++i) {
    exact = outcome(s, &s->aim[i], s->value[0]);
    near(s, "values of objectives", s->aim[i].def.name,
         fabs(value[i] - (double)creall(exact)) / (1e-3 + fabs(value[i])), 1e-9);
    for (lane = 0; lane < LANES; ++lane) {
      sum = along(s, s->gradient + i * s->np, s->x[lane], &terms);
      exact = outcome(s, &s->aim[i], s->value[lane]);
      near(s, "adjoint", s->aim[i].def.name, fabs(sum - slope(exact)) / terms, 1e-10);
    }
  }
  if (ok) {
    i = mech_integer(&s->random, s->naim);
    check_balanced(s, &s->aim[i], s->gradient + i * s->np);
  }
  maggi_design_free(all);
  free(value);
  free(again);
}

static void check_direct(study *s)
{
  maggi_design *design = course_design(s->c, LANES, s->x);
  double value[OBJECTIVES], g[OBJECTIVES * LANES], terms;
  int i, lane;

  if (gradient(s, design, MAGGI_METHOD_DIRECT, 0, value, g)) {
    for (i = 0; i < s->naim * LANES; ++i) {
      lane = i % LANES;
      along(s, s->gradient + i / LANES * s->np, s->x[lane], &terms);
      near(s, "direct", s->aim[i / LANES].def.name,
           fabs(g[i] - slope(outcome(s, &s->aim[i / LANES], s->value[lane]))) / terms, 1e-10);
    }
  }
  maggi_design_free(design);
}

static void check_course(const course *c)
{
  study s = {.c = c, .m = c->data->m, .random = {c->seed + 2000}, .grown = ROUNDOFF};
  int lane, i;

  s.d = replay_copy(c->data);
  s.np = s.d->t.np;
  s.nsignal = maggi_signal_number(s.m);
  s.steps = c->steps;
  if (maggi_grid_init(&s.grid, c->steps * c->step, c->step) != MAGGI_OK) abort();
  for (lane = 0; lane < LANES; ++lane) {
    s.x[lane] = course_direction(c, &s.random);
    s.value[lane] = simulate(&s, s.x[lane]);
  }
  if (!s.value[0] || s.steps < AIM_SAMPLES) {
    report_count("not replayed");
  } else {
    choose_aims(&s);
    s.gradient = room(s.naim * s.np, sizeof *s.gradient);
    report_true(c->seed, "there are objectives", s.naim > 2);
    check_adjoint(&s);
    check_direct(&s);
  }
  for (lane = 0; lane < LANES; ++lane) {
    free(s.x[lane]);
    free(s.value[lane]);
  }
  for (i = 0; i < s.naim; ++i) maggi_objective_free(s.aim[i].objective);
  free(s.gradient);
  maggi_data_free(s.d);
}

int main(int argc, char **argv)
{
  report_options options = {1, 112, 0};

  if (!report_parse(argc, argv, &options)) return 2;
  course_each(&options, check_course);
  return report_done("derivative_gradient");
}
