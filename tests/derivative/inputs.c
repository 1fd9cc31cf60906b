#include "inputs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "property/vector.h"

void inputs_real(inputs *in, const maggi_data *d)
{
  memset(in, 0, sizeof *in);
  in->t = &d->t;
  in->d = d;
}

void inputs_random(inputs *in, const maggi_topo *t, uint64_t seed)
{
  memset(in, 0, sizeof *in);
  in->t = t;
  in->random.state = seed;
}

void inputs_free(inputs *in)
{
  int i;

  for (i = 0; i < in->number; ++i) free(in->input[i].x);
  in->number = 0;
}

/* --------------------------------------------------------------------------- a real evaluation */

static const double *array_of(const maggi_data *d, const char *name)
{
  if (strcmp(name, "time") == 0) return &d->time;
  if (strcmp(name, "origin") == 0) return d->origin;
  if (strcmp(name, "power") == 0) return d->power;
#define X(field, rows, cols, text)                                                                 \
  if (strcmp(name, #field) == 0) return (const double *)d->field;
  MAGGI_DATA_LIST(X)
#undef X
#define X(field, size, text)                                                                       \
  if (strcmp(name, #field) == 0) return d->field;
  MAGGI_DATA_VECTORS(X)
#undef X
  return NULL;
}

/* ------------------------------------------------------------------------------ random numbers */

static void fill(inputs *in, int n, double low, double high, double *x)
{
  int i;

  for (i = 0; i < n; ++i) x[i] = mech_uniform(&in->random, low, high);
}

/* away from zero, with either sign */
static void fill_signed(inputs *in, int n, double *x)
{
  int i;

  for (i = 0; i < n; ++i)
    x[i] = (mech_integer(&in->random, 2) ? 1.0 : -1.0) * mech_uniform(&in->random, 0.2, 1.5);
}

/* number of ascending times of a function */
static int times_of(const maggi_topo *t, int fun)
{
  if (t->funkind[fun] == MAGGI_FUNCTION_STEP || t->funkind[fun] == MAGGI_FUNCTION_RAMP) return 2;
  if (t->funkind[fun] == MAGGI_FUNCTION_KNOTS || t->funkind[fun] == MAGGI_FUNCTION_SPLINE)
    return t->funn[fun];
  return 0;
}

/* away from where what the formula divides by is zero: friction, stiffness, weights of pure slip; every
 * other curvature is more than the 1 at which it is kept, on either side of no slip */
static void random_tyre(inputs *in, double *p)
{
  static const int positive[] = {MAGGI_TYRE_FNOMIN,
                                 MAGGI_TYRE_UNLOADED_RADIUS,
                                 MAGGI_TYRE_VERTICAL_STIFFNESS,
                                 MAGGI_TYRE_LONGVL,
                                 MAGGI_TYRE_VXLOW,
                                 MAGGI_TYRE_LOW_SPEED,
                                 MAGGI_TYRE_LFZO,
                                 MAGGI_TYRE_PDX1,
                                 MAGGI_TYRE_PDY1,
                                 MAGGI_TYRE_PKY2};
  static const int small[] = {MAGGI_TYRE_PDX2, MAGGI_TYRE_PDX3, MAGGI_TYRE_PDY2, MAGGI_TYRE_PDY3,
                              MAGGI_TYRE_PKX3, MAGGI_TYRE_PKY3, MAGGI_TYRE_QSY4, MAGGI_TYRE_PHX2,
                              MAGGI_TYRE_PHY2, MAGGI_TYRE_PVX2, MAGGI_TYRE_PVY2, MAGGI_TYRE_PVY4,
                              MAGGI_TYRE_PEX2, MAGGI_TYRE_PEX3, MAGGI_TYRE_PEY2, MAGGI_TYRE_QEZ2,
                              MAGGI_TYRE_QEZ3, MAGGI_TYRE_RHX1, MAGGI_TYRE_RHY1, MAGGI_TYRE_RHY2};
  int i;

  for (i = 0; i < (int)(sizeof positive / sizeof *positive); ++i)
    p[positive[i]] = mech_uniform(&in->random, 0.5, 1.5);
  for (i = 0; i < (int)(sizeof small / sizeof *small); ++i)
    p[small[i]] = mech_uniform(&in->random, -0.02, 0.02);
  p[MAGGI_TYRE_LEX] = mech_uniform(&in->random, 0.8, 1.2);
  p[MAGGI_TYRE_LEY] = mech_uniform(&in->random, 0.8, 1.2);
  p[MAGGI_TYRE_PEX1] = mech_uniform(&in->random, -1.0, 3.0);
  p[MAGGI_TYRE_PEY1] = mech_uniform(&in->random, -1.0, 3.0);
  p[MAGGI_TYRE_PEX4] = mech_uniform(&in->random, -0.3, 0.3);
  p[MAGGI_TYRE_PEY3] = mech_uniform(&in->random, -0.3, 0.3);
  p[MAGGI_TYRE_RCX1] = mech_uniform(&in->random, 0.2, 0.9);
  p[MAGGI_TYRE_RCY1] = mech_uniform(&in->random, 0.2, 0.9);
  p[MAGGI_TYRE_LOW_CAMBER] = mech_uniform(&in->random, 0.03, 0.3);
}

/* a path that bends little, of which the point ahead comes near to every piece and beyond the ends */
static void random_driver(inputs *in, int i, double *p)
{
  const maggi_topo *t = in->t;
  int n = t->drivern[i], k;
  double *a = p + t->driveradr[i], *x = p + t->driverpath[i];

  a[MAGGI_DRIVER_PREVIEW] = mech_uniform(&in->random, 0.1, 0.5);
  a[MAGGI_DRIVER_LIMIT] = mech_uniform(&in->random, 0.5, 1.5);
  for (k = 0; k < n; ++k) {
    x[k] = 1.6 * (k + mech_uniform(&in->random, -0.2, 0.2)) / (n - 1) - 0.8;
    x[n + k] = mech_uniform(&in->random, -0.1, 0.1) / (n * n);
  }
}

static void random_paths(inputs *in, double *x)
{
  const maggi_topo *t = in->t;
  double *row = x;
  int i, k;

  for (i = 0; i < t->ndriver; ++i) {
    for (k = 0; k < t->drivern[i]; ++k, row += 8) {
      fill(in, 8, -0.1, 0.1, row);
      row[MAGGI_PATH_S] = 1.6 * (k + mech_uniform(&in->random, -0.2, 0.2)) / (t->drivern[i] - 1);
    }
  }
}

/* bumps of which a wheel near the origin meets all parts */
static void random_road(inputs *in, int road, double *p)
{
  const maggi_topo *t = in->t;
  int k, n = t->roadn[road];

  if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
    p[MAGGI_BUMPS_RADIUS] = mech_uniform(&in->random, 0.6, 1.0);
    p[MAGGI_BUMPS_HEIGHT] = mech_uniform(&in->random, 0.1, 0.3);
    p[MAGGI_BUMPS_FIRST] = mech_uniform(&in->random, -2.0, 0.0);
    p[MAGGI_BUMPS_SPACING] = mech_uniform(&in->random, 1.5, 2.5);
    p[MAGGI_BUMPS_FILLET] = mech_uniform(&in->random, 0.2, 0.4);
  } else if (t->roadkind[road] == MAGGI_ROAD_PROFILE) {
    for (k = 0; k < n; ++k) {
      p[k] = (1.4 * k + mech_uniform(&in->random, -0.3, 0.3)) / n - 0.7;
      p[n + k] = mech_uniform(&in->random, -0.1, 0.1);
    }
  } else {
    p[0] = mech_uniform(&in->random, -0.3, 0.3);
    if (t->roadkind[road] == MAGGI_ROAD_SINE) p[1] = mech_uniform(&in->random, 2.0, 6.0);
  }
}

static void random_parameters(inputs *in, double *p)
{
  const maggi_topo *t = in->t;
  int i, k;

  fill_signed(in, t->np, p);
  for (i = 0; i < t->nfun; ++i)
    for (k = 0; k < times_of(t, i); ++k)
      p[t->funadr[i] + k] = 0.4 * k + mech_uniform(&in->random, 0.0, 0.2);
  for (i = 0; i < t->nspring; ++i) {
    if (!t->springslopes[i]) continue;
    k = t->springadr[i] + MAGGI_SPRING_SLOPES;
    p[k + 4] = mech_uniform(&in->random, 0.3, 0.5);
    p[k + 5] = -mech_uniform(&in->random, 0.3, 0.5);
  }
  for (i = 0; i < t->ntyre; ++i) random_tyre(in, p + t->tyreadr[i]);
  for (i = 0; i < t->nwheel; ++i) {
    fill(in, 3, -0.2, 0.2, p + t->wheelaxis[i]);
    p[t->wheelaxis[i] + 1] = 1.0;
  }
  for (i = 0; i < t->ndriver; ++i) random_driver(in, i, p);
  for (i = 0; i < t->nroad; ++i) random_road(in, i, p + t->roadadr[i]);
}

/* away from where an angle of a sensor jumps by a turn, and from where its rate grows without bound */
static void random_rotations(inputs *in, int n, double *A)
{
  const maggi_topo *t = in->t;
  double *a;
  int i, k;

  fill(in, n, -1.0, 1.0, A);
  for (i = 0; i < t->nwheel; ++i) { /* upright: a wheel that lies on the road touches it nowhere */
    a = A + 9 * t->wheelbody[i];
    fill(in, 9, -0.3, 0.3, a);
    for (k = 0; k < 9; k += 4) a[k] += 1.0;
  }
  for (i = 0; i < t->nsensor; ++i) {
    a = A + 9 * t->sensorbody[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      while (a[8] < 0.0 && fabs(a[7]) < INPUTS_MARGIN) fill(in, 1, -1.0, 1.0, a + 7);
      while (a[0] < 0.0 && fabs(a[3]) < INPUTS_MARGIN) fill(in, 1, -1.0, 1.0, a + 3);
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES ||
               (t->sensorkind[i] >= MAGGI_SENSOR_SIDESLIP &&
                t->sensorkind[i] <= MAGGI_SENSOR_LEVEL_ACCELERATION)) {
      while (hypot(a[0], a[3]) < 0.3) fill(in, 1, -1.0, 1.0, a + 3);
    }
  }
}

static int is_at_bend(const maggi_topo *t, const double *p, double time)
{
  int i, k;

  for (i = 0; i < t->nfun; ++i)
    for (k = 0; k < times_of(t, i); ++k)
      if (fabs(time - p[t->funadr[i] + k]) < 0.5 * INPUTS_MARGIN) return 1;
  return 0;
}

/* before, between or after the times of the functions */
static double random_time(inputs *in)
{
  const double *p = inputs_get(in, "p", in->t->np);
  double time;
  int attempt = 0;

  do time = mech_uniform(&in->random, -0.5, 2.5);
  while (is_at_bend(in->t, p, time) && ++attempt < 1000);
  return time;
}

static int is_near(double x, double kink)
{
  return fabs(x - kink) < 1e-6;
}

/* Rates of springs with four slopes, by a change of the velocity of one end along the spring: random
 * ones in one zone after the other, real ones only away from a kink. */
static void choose_zones(inputs *in, double *rv)
{
  static const double share[] = {2.0, 0.5, -0.5, -2.0};
  const maggi_topo *t = in->t;
  const double *p = inputs_get(in, "p", t->np), *r = inputs_get(in, "r", 3 * t->npoint), *slopes;
  double e[3], ev[3], length, rate, limit, *va;
  int i, zone, first = mech_integer(&in->random, 4);

  for (i = 0; i < t->nspring; ++i) {
    if (!t->springslopes[i]) continue;
    slopes = p + t->springadr[i] + MAGGI_SPRING_SLOPES;
    va = rv + 3 * t->springpa[i];
    v3_axpy(r + 3 * t->springpa[i], -1.0, r + 3 * t->springpb[i], e);
    v3_axpy(va, -1.0, rv + 3 * t->springpb[i], ev);
    length = v3_norm(e);
    rate = v3_dot(e, ev) / length;
    if (in->d && !is_near(rate, 0.0) && !is_near(rate, slopes[4]) && !is_near(rate, slopes[5]))
      continue;
    zone = (first + i) % 4;
    limit = fmax(fabs(slopes[zone < 2 ? 4 : 5]), 0.1);
    v3_axpy(va, (share[zone] * limit - rate) / length, e, va);
  }
}

/* of each wheel */
static void random_slips(inputs *in, double *x)
{
  int i;

  for (i = 0; i < in->t->nwheel; ++i, x += MAGGI_SLIP_NUMBERS) {
    fill(in, MAGGI_SLIP_NUMBERS, 0.3, 1.5, x);
    fill(in, 2, -0.3, 0.3, x + MAGGI_SLIP_KAPPA);
    fill(in, 1, -0.2, 0.2, x + MAGGI_SLIP_GAMMA);
    fill(in, 1, -1.0, 1.0, x + MAGGI_SLIP_VX);
  }
}

/* forces of wheels with load or without */
static void random_grip(inputs *in, double *x)
{
  const maggi_topo *t = in->t;
  const double *p = inputs_get(in, "p", t->np);
  int i;

  fill(in, 6 * t->nwheel, -1.0, 1.0, x);
  for (i = 0; i < t->nwheel; ++i)
    x[6 * i + 2] = mech_integer(&in->random, 4)
                       ? mech_uniform(&in->random, 0.3, 1.5) *
                             fabs(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FNOMIN])
                       : 0.0;
}

static void random_argument(inputs *in, const char *name, int n, double *x)
{
  if (strcmp(name, "p") == 0)
    random_parameters(in, x);
  else if (strcmp(name, "time") == 0)
    x[0] = random_time(in);
  else if (strcmp(name, "A") == 0)
    random_rotations(in, n, x);
  else if (strcmp(name, "path0") == 0)
    random_paths(in, x);
  else if (strcmp(name, "slip") == 0)
    random_slips(in, x);
  else if (strcmp(name, "grip") == 0)
    random_grip(in, x);
  else if (strcmp(name, "prim0") == 0 || strcmp(name, "spring0") == 0)
    fill(in, n, 0.5, 1.5, x);
  else
    fill(in, n, -1.0, 1.0, x);
}

const double *inputs_get(inputs *in, const char *name, int n)
{
  const double *from = NULL;
  double *x;
  int i;

  for (i = 0; i < in->number; ++i)
    if (strcmp(in->input[i].name, name) == 0 && in->input[i].n == n) return in->input[i].x;
  if (in->d && !(from = array_of(in->d, name))) return NULL;
  x = malloc(((size_t)n + 1) * sizeof *x);
  if (!x || in->number == INPUTS_MAX) abort();
  if (from)
    memcpy(x, from, (size_t)n * sizeof *x);
  else
    random_argument(in, name, n, x);
  if (strcmp(name, "rv") == 0) choose_zones(in, x);
  in->input[in->number].name = name;
  in->input[in->number].n = n;
  in->input[in->number].x = x;
  ++in->number;
  return x;
}
