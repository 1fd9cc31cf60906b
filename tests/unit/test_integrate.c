/* core/dynamics/integrate.c, evaluate.c: order and exactness of steps, steps that are refused, what
 * happens when the solution leaves the numbers. */
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include "fixture.h"

/* g / l = 4 rad^2/s^2, released from rest at `phi0` */
static maggi_model *pendulum(double phi0)
{
  return test_model(
      "gravity: [0, 0, -8]\n"
      "bodies: [{name: p, mass: 1, cog: [0, 0, -2], joint: {type: revolute, point: [0, 0, 0],"
      " axis: [1, 0, 0], position: %.17g}}]\n",
      phi0);
}

/* sin(phi/2) = k sn(K - w t, k), k = sin(phi0/2) */
static double exact(double phi0, double t)
{
  double k = sin(0.5 * phi0), sn, cn, dn;

  gsl_sf_elljac_e(gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE) - 2.0 * t, k * k, &sn, &cn, &dn);
  return 2.0 * asin(k * sn);
}

/* largest error of the angle in 3 s */
static double error(const maggi_model *m, double phi0, double h)
{
  maggi_data *d = test_start(m);
  double e = 0.0;

  while (maggi_get_time(d) < 3.0) {
    test_step(d, h, 1);
    e = fmax(e, fabs(test_get(d).q[0] - exact(phi0, maggi_get_time(d))));
  }
  maggi_data_free(d);
  return e;
}

static void test_order(void)
{
  maggi_model *m = pendulum(2.0);
  double e1 = error(m, 2.0, 0.01), e2 = error(m, 2.0, 0.005), e3 = error(m, 2.0, 0.0025);

  CHECK(e1 > 1e-9);
  CHECK_NEAR(e1 / e2, 16.0, 0.06, 0.0);
  CHECK_NEAR(e2 / e3, 16.0, 0.03, 0.0);
  CHECK_NEAR(error(m, 2.0, 1e-3), 0.0, 0.0, 1e-11);
  maggi_model_free(m);
}

/* z' = -c z of a slide has the stability polynomial of the method: one step multiplies
 * the velocity by 1 - x + x^2/2 - x^3/6 + x^4/24 */
static void test_polynomial(void)
{
  maggi_model *m = test_model(
      "gravity: [0, 0, 0]\n"
      "bodies: [{name: b, mass: 2, joint: {type: prismatic, axis: [1, 0, 0], velocity: 1}}]\n"
      "joint_springs: [{name: d, coordinate: b, damping: 6}]\n");
  maggi_data *d = test_start(m);
  double x = 3.0 * 0.1;

  test_step(d, 0.1, 1);
  CHECK_NEAR(test_get(d).v[0], 1.0 - x * (1.0 - x / 2.0 * (1.0 - x / 3.0 * (1.0 - x / 4.0))), 1e-15,
             0.0);
  CHECK_NEAR(test_get(d).q[0], 0.1 * (1.0 - x / 2.0 * (1.0 - x / 3.0 * (1.0 - x / 4.0))), 1e-15,
             0.0);
  CHECK_NEAR(test_get(d).a[0], -3.0 * test_get(d).v[0], 1e-15, 0.0);
  CHECK(test_loops(d).evaluations == 5); /* one at the reset, four a step */
  test_free(d, m);
}

/* a load and a guide that depend on time: stages are at t, t + h/2, t + h, so that a cubic comes
 * out exactly; also after a start at another time */
static void test_time(void)
{
  maggi_model *m =
      test_model("gravity: [0, 0, 0]\n"
                 "bodies: [{name: b, mass: 2, joint: {type: prismatic, axis: [1, 0, 0]}}]\n"
                 "functions: [{name: f, type: polynomial, coefficients: [1, 0, 6, 0]}]\n"
                 "forces: [{name: f, type: joint, coordinate: b, effort: 2, function: f}]\n");
  maggi_data *d = test_start(m);
  double q = 0.0, v = 0.0;

  test_step(d, 0.5, 4); /* a = 1 + 6 t^2, v = t + 2 t^3, q = t^2/2 + t^4/2 */
  CHECK_NEAR(maggi_get_time(d), 2.0, 0.0, 0.0);
  CHECK_NEAR(test_get(d).v[0], 18.0, 1e-15, 0.0);
  CHECK_NEAR(test_get(d).q[0], 10.0, 1e-14, 0.0);
  CHECK_NEAR(test_get(d).a[0], 25.0, 1e-15, 0.0);
  CHECK(maggi_data_set_state(d, -1.0, &q, &v) == MAGGI_OK);
  CHECK_NEAR(test_get(d).a[0], 7.0, 1e-15, 0.0);
  test_step(d, 0.5, 2);
  CHECK_NEAR(test_get(d).v[0], 3.0, 1e-14, 0.0);
  test_free(d, m);
}

/* there and back: RK4 is not symmetric, the way back misses the start by h^5 a step */
static void test_back(void)
{
  maggi_model *m = test_model(
      "bodies:\n"
      "- {name: crank, mass: 1, bar: {from: [0, 0, 0], to: [0, 0, -1]},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0], velocity: -2}}\n"
      "- {name: coupler, parent: crank, mass: 1, bar: {from: [0, 0, -1], to: [0, 1.2, -1.3]},"
      " joint: {type: revolute, point: [0, 0, -1], axis: [1, 0, 0]}}\n"
      "- {name: follower, mass: 1, bar: {from: [0, 1.2, 0], to: [0, 1.2, -1.3]},"
      " joint: {type: revolute, point: [0, 1.2, 0], axis: [1, 0, 0]}}\n"
      "loops: [{name: l, type: revolute, body_a: coupler, body_b: follower, point: [0, 1.2, -1.3],"
      " axis: [1, 0, 0]}]\n");
  maggi_data *d = test_start(m);
  double e[2], e0 = test_energy(d);
  maggi_energy energy;
  int i, k;

  for (i = 0; i < 2; ++i) {
    CHECK(maggi_data_reset(d) == MAGGI_OK);
    test_step(d, i ? 5e-3 : 1e-2, i ? 200 : 100);
    CHECK(fabs(test_get(d).q[0]) > 1e-2);
    test_step(d, i ? -5e-3 : -1e-2, i ? 200 : 100);
    CHECK_NEAR(maggi_get_time(d), 0.0, 0.0, 1e-14);
    e[i] = 0.0;
    for (k = 0; k < 3; ++k) e[i] += fabs(test_get(d).q[k]);
    CHECK_NEAR(test_energy(d), e0, 1e-7, 0.0);
    maggi_get_energy(d, &energy);
    CHECK_NEAR(energy.work, 0.0, 0.0, 1e-12);
  }
  CHECK(e[0] > 1e-12 && e[0] < 1e-6);
  CHECK(e[1] < e[0] / 12.0);
  test_free(d, m);
}

static void test_refused(void)
{
  static const double bad[] = {0.0, -0.0, NAN, INFINITY, -INFINITY};
  maggi_model *m = pendulum(1.0);
  maggi_data *d = test_data(m);
  test_state before, after;
  double time;
  int i;

  CHECK(maggi_step(d, 1e-3) == MAGGI_E_MODEL);
  CHECK_TEXT(maggi_data_message(d), "a step needs a successful reset before it");
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  test_step(d, 0.01, 3);
  before = test_get(d);
  time = maggi_get_time(d);
  for (i = 0; i < 5; ++i) {
    CHECK(maggi_step(d, bad[i]) == MAGGI_E_VALUE);
    CHECK_TEXT(maggi_data_message(d), "the step must be finite and not zero");
    after = test_get(d);
    CHECK(memcmp(&before, &after, sizeof before) == 0 && maggi_get_time(d) == time);
  }
  /* a refused step does not end the simulation */
  CHECK(maggi_step(d, 0.01) == MAGGI_OK);
  test_free(d, m);
}

/* a step far beyond stability: the failure says so and leaves no finite lie; a reset heals it */
static void test_not_finite(void)
{
  maggi_model *m = test_model(
      "gravity: [0, 0, 0]\n"
      "bodies: [{name: b, mass: 1, joint: {type: prismatic, axis: [1, 0, 0], velocity: 1}}]\n"
      "joint_springs: [{name: s, coordinate: b, stiffness: 1e6}]\n");
  maggi_data *d = test_start(m);
  maggi_status status = MAGGI_OK;
  int i;

  for (i = 0; i < 1000 && status == MAGGI_OK; ++i) status = maggi_step(d, 1.0);
  CHECK(status == MAGGI_E_NOT_FINITE);
  CHECK(strstr(maggi_data_message(d), "is the step too large?") != NULL);
  CHECK(strstr(maggi_data_message(d), "\"b\"") != NULL);
  CHECK(maggi_step(d, 1e-3) == MAGGI_E_MODEL);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  test_step(d, 1e-4, 1);
  CHECK_NEAR(test_get(d).q[0], sin(0.1) / 1e3, 1e-6, 0.0);
  test_free(d, m);
}

/* a body that nothing resists: the message names it */
static void test_massless(void)
{
  maggi_model *m =
      test_model("bodies:\n"
                 "- {name: heavy, mass: 1, joint: {type: prismatic, axis: [1, 0, 0]}}\n"
                 "- {name: empty, parent: heavy, joint: {type: revolute, point: [0, 0, 0], axis: "
                 "[1, 0, 0]}}\n");
  maggi_data *d = test_data(m);

  CHECK(maggi_data_reset(d) == MAGGI_E_MASS);
  CHECK(strstr(maggi_data_message(d), "nothing resists \"empty\"") != NULL);
  CHECK(test_set(m, d, "bodies.empty.inertia.xx", 1.0));
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  test_free(d, m);
}

int main(void)
{
  test_order();
  test_polynomial();
  test_time();
  test_back();
  test_refused();
  test_not_finite();
  test_massless();
  return check_done();
}
