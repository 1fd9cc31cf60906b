/* core/kernel/driver.c: projection on a path against a spline computed another way, and a vehicle that
 * follows a line, a lane change and a circle. */
#include "data.h"
#include "fixture.h"

enum { POINTS = 12 };

static void put(const maggi_model *m, maggi_data *d, const char *key, int k, double value)
{
  char path[80];

  snprintf(path, sizeof path, "drivers.driver.%s.%d", key, k + 1);
  CHECK(test_set(m, d, path, value));
}

/* ------------------------------------------------------------------------------------- projection */

/* second derivatives of the natural spline by Gauss's elimination of the full system */
static void solve(const double *s, const double *y, double *m)
{
  double A[POINTS][POINTS + 1] = {{0}}, f;
  int i, j, k;

  A[0][0] = A[POINTS - 1][POINTS - 1] = 1.0;
  for (k = 1; k < POINTS - 1; ++k) {
    A[k][k - 1] = s[k] - s[k - 1];
    A[k][k] = 2.0 * (s[k + 1] - s[k - 1]);
    A[k][k + 1] = s[k + 1] - s[k];
    A[k][POINTS] =
        6.0 * ((y[k + 1] - y[k]) / (s[k + 1] - s[k]) - (y[k] - y[k - 1]) / (s[k] - s[k - 1]));
  }
  for (i = 0; i < POINTS; ++i)
    for (k = i + 1; k < POINTS; ++k) {
      f = A[k][i] / A[i][i];
      for (j = i; j <= POINTS; ++j) A[k][j] -= f * A[i][j];
    }
  for (i = POINTS - 1; i >= 0; --i) {
    m[i] = A[i][POINTS];
    for (j = i + 1; j < POINTS; ++j) m[i] -= A[i][j] * m[j];
    m[i] /= A[i][i];
  }
}

/* value and slope at u in Hermite's form: slopes at the knots from the second derivatives */
static void at(const double *s, const double *y, const double *m, double u, double f[2])
{
  double h, x, d0, d1, e;
  int k = 0;

  while (k < POINTS - 2 && u > s[k + 1]) ++k;
  h = s[k + 1] - s[k];
  x = (u - s[k]) / h;
  e = (y[k + 1] - y[k]) / h;
  d0 = e - h / 6.0 * (2.0 * m[k] + m[k + 1]);
  d1 = e + h / 6.0 * (m[k] + 2.0 * m[k + 1]);
  if (x < 0.0 || x > 1.0) {
    f[1] = x < 0.0 ? d0 : d1;
    f[0] = x < 0.0 ? y[k] + d0 * (u - s[k]) : y[k + 1] + d1 * (u - s[k + 1]);
    return;
  }
  f[0] = y[k] + x * x * (3.0 - 2.0 * x) * (y[k + 1] - y[k]) +
         h * x * (1.0 - x) * ((1.0 - x) * d0 - x * d1);
  f[1] = 6.0 * x * (1.0 - x) * e + (1.0 - x) * (1.0 - 3.0 * x) * d0 + x * (3.0 * x - 2.0) * d1;
}

/* orthogonal to round-off, and as far as the error says; along the path and beyond its ends */
static void test_projection(void)
{
  maggi_model *m = test_file("path-follower.yaml");
  maggi_data *d = test_start(m);
  const maggi_topo *t = &d->t;
  const double *x = d->p + t->driverpath[0], *y = x + POINTS, zero[3] = {0};
  double s[POINTS], mx[POINTS], my[POINTS], fx[2], fy[2], r[3] = {0}, driver[4], torque[1], dx, dy;
  unsigned long long seed = 3;
  int i, k;

  CHECK(t->drivern[0] == POINTS);
  s[0] = 0.0;
  for (k = 1; k < POINTS; ++k) s[k] = s[k - 1] + hypot(x[k] - x[k - 1], y[k] - y[k - 1]);
  solve(s, x, mx);
  solve(s, y, my);
  for (k = 0; k < POINTS; ++k) {
    CHECK_NEAR(d->path0[k][MAGGI_PATH_X], mx[k], 1e-12, 1e-15);
    CHECK_NEAR(d->path0[k][MAGGI_PATH_Y], my[k], 1e-12, 1e-15);
  }
  for (i = 0; i < 500; ++i) {
    r[0] = 50.0 + 70.0 * random11(&seed);
    r[1] = 1.75 + 6.0 * random11(&seed);
    maggi_driver(t->driveradr[0], t->driverpath[0], 1, POINTS, 0, t->np, d->p, t->npath0,
                 (void *)d->path0, r, zero, 0.0, 0.0, driver, torque);
    at(s, x, mx, driver[1], fx);
    at(s, y, my, driver[1], fy);
    dx = fx[0] - r[0];
    dy = fy[0] - r[1];
    CHECK_NEAR(dx * fx[1] + dy * fy[1], 0.0, 0.0, 1e-12);
    CHECK_NEAR(fabs(driver[0]), hypot(dx, dy), 1e-11, 1e-12);
    CHECK((driver[0] > 0.0) == (dy > 0.0));
  }
  test_free(d, m);
}

/* ---------------------------------------------------------------------------------------- following */

/* largest lateral error of the front axle's point ahead from a time on, in a simulation of 8 s */
static double largest(maggi_data *d, double from)
{
  double worst = 0.0;
  int i;

  for (i = 1; i <= 4000; ++i) {
    test_step(d, 2e-3, 1);
    if (2e-3 * i > from) worst = fmax(worst, fabs(d->driver[0][0]));
  }
  return worst;
}

/* from 0.5 m beside it */
static void test_line(void)
{
  maggi_model *m = test_file("path-follower.yaml");
  maggi_data *d = test_data(m);
  int k;

  for (k = 0; k < POINTS; ++k) put(m, d, "y", k, 0.0);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK_NEAR(d->driver[0][0], -0.5, 0.01, 0.0);
  CHECK(largest(d, 6.0) < 2e-3);
  CHECK_NEAR(d->speed[0][2], 12.0, 0.01, 0.0);
  test_free(d, m);
}

static void test_lane_change(void)
{
  maggi_model *m = test_file("path-follower.yaml");
  maggi_data *d = test_data(m);

  CHECK(test_set(m, d, "bodies.chassis.joint.position.2", 0.0));
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK(largest(d, 0.0) < 0.3);
  CHECK_NEAR(d->driver[0][0], 0.0, 0.0, 0.01);
  test_free(d, m);
}

/* of 50 m to the left at 10 m/s: the steady error is what the feedforward leaves over */
static void test_circle(void)
{
  maggi_model *m = test_file("path-follower.yaml");
  maggi_data *d = test_data(m);
  int k;

  for (k = 0; k < POINTS; ++k) {
    put(m, d, "x", k, 50.0 * sin(0.2 * k));
    put(m, d, "y", k, 50.0 - 50.0 * cos(0.2 * k));
    put(m, d, "speeds", k, 10.0);
  }
  CHECK(test_set(m, d, "bodies.chassis.joint.position.2", 0.0));
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK(largest(d, 2.0) < 0.06);
  CHECK_NEAR(d->driver[0][1], 1.5 + 7.0 + 80.0, 0.01, 0.0);
  test_free(d, m);
}

int main(void)
{
  test_projection();
  test_line();
  test_lane_change();
  test_circle();
  return check_done();
}
