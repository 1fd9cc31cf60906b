/* core/kernel/function.c: values, derivatives, continuity; the spline against GSL. */
#include <gsl/gsl_interp.h>

#include "data.h"
#include "fixture.h"

enum { CONSTANT, POLYNOMIAL, SINE, STEP, KNOTS, SPLINE, LINE, RAMP, FUNCTIONS };
enum { POINTS = 7 };

static const double times[POINTS] = {-1.0, -0.25, 0.0, 0.7, 1.9, 2.0, 4.5};
static const double values[POINTS] = {0.3, -2.0, 1.5, 1.5, 0.2, 3.0, -0.7};

static maggi_model *model(void)
{
  return test_model(
      "bodies:\n"
      "- {name: b, mass: 1, inertia: {xx: 1, yy: 1, zz: 1}, joint: {type: revolute,"
      " point: [0, 0, 0], axis: [1, 0, 0]}}\n"
      "functions:\n"
      "- {name: constant, type: constant, value: -3.25}\n"
      "- {name: polynomial, type: polynomial, coefficients: [2, -1, 0.5, 3, -0.25]}\n"
      "- {name: sine, type: sine, amplitude: 1.5, omega: 2.5, phase: 0.4, offset: -0.2}\n"
      "- {name: step, type: step, t0: 0.5, t1: 2.5, y0: -1, y1: 3}\n"
      "- {name: knots, type: knots, times: [-1, -0.25, 0, 0.7, 1.9, 2, 4.5],"
      " values: [0.3, -2, 1.5, 1.5, 0.2, 3, -0.7]}\n"
      "- {name: spline, type: spline, times: [-1, -0.25, 0, 0.7, 1.9, 2, 4.5],"
      " values: [0.3, -2, 1.5, 1.5, 0.2, 3, -0.7]}\n"
      "- {name: line, type: spline, times: [1, 3], values: [2, -4]}\n"
      "- {name: ramp, type: ramp, t0: 0.5, t1: 2.5, y0: -1, rate: 3}\n");
}

static const double *at(maggi_data *d, int function, double time)
{
  maggi_evaluate_positions(d, time);
  return d->fun[function];
}

/* central difference of order 8 of column k */
static double difference(maggi_data *d, int function, int k, double time, double h)
{
  static const double c[4] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  double s = 0.0;
  int i;

  for (i = 0; i < 4; ++i)
    s += c[i] * (at(d, function, time + (i + 1) * h)[k] - at(d, function, time - (i + 1) * h)[k]);
  return s / h;
}

/* a time that is not within 4 h of a point where a piece begins */
static int is_inside(int function, double time, double h)
{
  static const double ends[] = {0.5, 2.5, 1.0, 3.0};
  int i;

  for (i = 0; i < POINTS; ++i)
    if (function >= KNOTS && fabs(time - times[i]) <= 4.0 * h) return 0;
  for (i = 0; i < 4; ++i)
    if (function >= STEP && fabs(time - ends[i]) <= 4.0 * h) return 0;
  return 1;
}

/* pieces are polynomials of degree 6 at most, for which order 8 is exact: round-off, 1e-15 / h; the
 * sine has h^8 omega^9 / 630 besides, 6e-13 */
static void test_derivatives(maggi_data *d)
{
  const double h = 0.01;
  double time, f1, f2;
  int i, k;

  for (i = 0; i < FUNCTIONS; ++i) {
    for (k = -100; k < 300; ++k) {
      time = 0.01931 * k;
      if (!is_inside(i, time, h)) continue;
      f1 = at(d, i, time)[1];
      f2 = at(d, i, time)[2];
      CHECK_NEAR(difference(d, i, 0, time, h), f1, 2e-12, 2e-12);
      CHECK_NEAR(difference(d, i, 1, time, h), f2, 1e-11, 1e-11);
    }
  }
}

static void test_values(maggi_data *d)
{
  double time, x;
  int k;

  for (k = -20; k < 60; ++k) {
    time = 0.1 * k;
    CHECK_NEAR(at(d, CONSTANT, time)[0], -3.25, 0.0, 0.0);
    CHECK_NEAR(at(d, CONSTANT, time)[1], 0.0, 0.0, 0.0);
    CHECK_NEAR(at(d, POLYNOMIAL, time)[0],
               2.0 + time * (-1.0 + time * (0.5 + time * (3.0 - 0.25 * time))), 1e-14, 1e-13);
    CHECK_NEAR(at(d, SINE, time)[0], -0.2 + 1.5 * sin(2.5 * time + 0.4), 1e-15, 1e-15);
    x = (time - 0.5) / 2.0;
    x = x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x;
    CHECK_NEAR(at(d, STEP, time)[0], -1.0 + 4.0 * (pow(x, 3) * (10.0 - 15.0 * x + 6.0 * x * x)),
               1e-14, 1e-14);
    CHECK_NEAR(at(d, LINE, time)[0], 2.0 - 3.0 * (time - 1.0), 1e-14, 1e-14);
    CHECK_NEAR(at(d, LINE, time)[1], -3.0, 1e-15, 0.0);
    CHECK_NEAR(at(d, LINE, time)[2], 0.0, 0.0, 0.0);
  }
  /* half way a step is half way up, with slope 15/8 of the mean one */
  CHECK_NEAR(at(d, STEP, 1.5)[0], 1.0, 1e-15, 0.0);
  /* a ramp: where it begins, in the middle of its rise, and as if it had begun there */
  CHECK_NEAR(at(d, RAMP, 0.5)[0], -1.0, 0.0, 0.0);
  CHECK_NEAR(at(d, RAMP, 1.5)[0], -1.0 + 3.0 * 2.0 / 16.0 * (2.5 - 1.5 + 0.25), 1e-15, 0.0);
  CHECK_NEAR(at(d, RAMP, 1.5)[1], 1.5, 1e-15, 0.0);
  CHECK_NEAR(at(d, RAMP, nextafter(2.5, 0.0))[0], 2.0, 1e-14, 0.0);
  CHECK_NEAR(at(d, RAMP, 2.5)[0], 2.0, 1e-15, 0.0);
  CHECK_NEAR(at(d, RAMP, 7.5)[0], 17.0, 1e-15, 0.0);
  CHECK_NEAR(at(d, RAMP, 7.5)[1], 3.0, 0.0, 0.0);
  CHECK_NEAR(at(d, STEP, 1.5)[1], 15.0 / 8.0 * 4.0 / 2.0, 1e-15, 0.0);
  for (k = 0; k < POINTS; ++k) {
    CHECK_NEAR(at(d, KNOTS, times[k])[0], values[k], 1e-15, 0.0);
    CHECK_NEAR(at(d, KNOTS, times[k])[1], 0.0, 0.0, 1e-14);
    CHECK_NEAR(at(d, SPLINE, times[k])[0], values[k], 1e-14, 1e-15);
  }
  CHECK_NEAR(at(d, KNOTS, -50.0)[0], values[0], 0.0, 0.0);
  CHECK_NEAR(at(d, KNOTS, 50.0)[0], values[POINTS - 1], 0.0, 0.0);
}

/* largest third derivative of a quintic step, 60 |y1 - y0| / h^3, on both sides of a knot */
static double third(int k)
{
  double left = 0.0, right = 0.0;

  if (k > 0) left = fabs(values[k] - values[k - 1]) / pow(times[k] - times[k - 1], 3);
  if (k < POINTS - 1) right = fabs(values[k + 1] - values[k]) / pow(times[k + 1] - times[k], 3);
  return 60.0 * fmax(left, right);
}

/* value and both derivatives one number before a knot and one after; what is continuous differs by
 * its slope times the two units in the last place of time */
static void test_continuity(maggi_data *d)
{
  static const double ends[] = {0.5, 2.5};
  double before[3], after[3], time, abs;
  int i, k, j, n;

  for (i = STEP; i <= SPLINE; ++i) {
    n = i == STEP ? 2 : POINTS;
    for (k = 0; k < n; ++k) {
      time = i == STEP ? ends[k] : times[k];
      memcpy(before, at(d, i, nextafter(time, -INFINITY)), sizeof before);
      memcpy(after, at(d, i, nextafter(time, INFINITY)), sizeof after);
      for (j = 0; j < 3; ++j) {
        abs = j == 2 && i == KNOTS ? 2.0 * third(k) * (nextafter(time, INFINITY) - time) : 0.0;
        CHECK_NEAR(before[j], after[j], 1e-13, 1e-12 + abs);
      }
    }
  }
}

static void test_spline(maggi_data *d)
{
  gsl_interp *s = gsl_interp_alloc(gsl_interp_cspline, POINTS);
  gsl_interp_accel *a = gsl_interp_accel_alloc();
  double time, first, last;
  int k;

  gsl_interp_init(s, times, values, POINTS);
  for (k = 0; k <= 550; ++k) {
    time = -1.0 + 0.01 * k;
    time = time > 4.5 ? 4.5 : time;
    CHECK_NEAR(at(d, SPLINE, time)[0], gsl_interp_eval(s, times, values, time, a), 1e-12, 1e-14);
    CHECK_NEAR(at(d, SPLINE, time)[1], gsl_interp_eval_deriv(s, times, values, time, a), 1e-12,
               1e-12);
    CHECK_NEAR(at(d, SPLINE, time)[2], gsl_interp_eval_deriv2(s, times, values, time, a), 1e-12,
               1e-11);
  }
  /* straight lines outside */
  first = gsl_interp_eval_deriv(s, times, values, times[0], a);
  last = gsl_interp_eval_deriv(s, times, values, times[POINTS - 1], a);
  CHECK_NEAR(at(d, SPLINE, -3.0)[0], values[0] - 2.0 * first, 1e-13, 0.0);
  CHECK_NEAR(at(d, SPLINE, -3.0)[1], first, 1e-13, 0.0);
  CHECK_NEAR(at(d, SPLINE, 6.5)[0], values[POINTS - 1] + 2.0 * last, 1e-13, 0.0);
  CHECK_NEAR(at(d, SPLINE, 6.5)[1], last, 1e-13, 0.0);
  CHECK_NEAR(at(d, SPLINE, -3.0)[2], 0.0, 0.0, 0.0);
  CHECK_NEAR(at(d, SPLINE, 6.5)[2], 0.0, 0.0, 0.0);
  gsl_interp_free(s);
  gsl_interp_accel_free(a);
}

/* a changed point reaches the spline at the next reset */
static void test_parameter(const maggi_model *m, maggi_data *d)
{
  CHECK(test_set(m, d, "functions.spline.values.4", 2.25));
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK_NEAR(at(d, SPLINE, times[3])[0], 2.25, 1e-14, 0.0);
  CHECK_NEAR(at(d, SPLINE, nextafter(times[3], 0.0))[2], at(d, SPLINE, times[3])[2], 1e-12, 0.0);
}

int main(void)
{
  maggi_model *m = model();
  maggi_data *d = test_start(m);

  test_values(d);
  test_derivatives(d);
  test_continuity(d);
  test_spline(d);
  test_parameter(m, d);
  test_free(d, m);
  return check_done();
}
