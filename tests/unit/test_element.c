/* core/kernel/element.c: forces of springs, dampers, loads and drag, seen in the acceleration of
 * bodies whose masses are known, and their balance of action and reaction. */
#include "data.h"
#include "fixture.h"

static test_state at(maggi_data *d, const double *q, const double *v)
{
  CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
  return test_get(d);
}

/* ------------------------------------------------------------------------------------- dampers */

/* 1 kg on a slide along x, tied to the ground 2 m behind: tension F gives a = -F */
static maggi_model *slide(const char *spring)
{
  return test_model(
      "gravity: [0, 0, 0]\n"
      "bodies: [{name: b, mass: 1, joint: {type: prismatic, axis: [1, 0, 0]}}]\n"
      "springs: [{name: s, body_a: b, body_b: ground, point_a: [2, 0, 0], point_b: [0, 0, 0], "
      "%s}]\n",
      spring);
}

static double tension(maggi_data *d, double q, double v)
{
  return -at(d, &q, &v).a[0];
}

/* F = int_0^v c(v) dv with the four slopes */
static double damper(double v)
{
  if (v >= 0.5) return 10.0 * 0.5 + 3.0 * (v - 0.5);
  if (v >= 0.0) return 10.0 * v;
  if (v >= -0.25) return 20.0 * v;
  return 20.0 * -0.25 + 7.0 * (v + 0.25);
}

/* slopes to the left and right of the knots; a line has the same slope at all steps */
static void test_slopes(void)
{
  static const double knots[] = {-0.25, 0.0, 0.5};
  static const double slopes[] = {7.0, 20.0, 10.0, 3.0};
  maggi_model *m = slide("slopes: {c1: 10, c2: 3, c3: 20, c4: 7, v11: 0.5, v22: -0.25}");
  maggi_data *d = test_start(m);
  double v, f, h;
  int i, k;

  for (i = -100; i <= 100; ++i)
    CHECK_NEAR(tension(d, 0.3, 0.0123 * i), damper(0.0123 * i), 1e-14, 1e-15);
  for (i = 0; i < 3; ++i) {
    v = knots[i];
    f = tension(d, 0.0, v);
    for (k = 2; k < 8; ++k) {
      h = ldexp(1.0, -k - 1);
      CHECK_NEAR((f - tension(d, 0.0, v - h)) / h, slopes[i], 1e-12, 0.0);
      CHECK_NEAR((tension(d, 0.0, v + h) - f) / h, slopes[i + 1], 1e-12, 0.0);
    }
    /* continuous: the numbers next to the knot give what is next to its force */
    CHECK_NEAR(tension(d, 0.0, nextafter(v, -9.0)), f, 1e-15, 1e-20);
    CHECK_NEAR(tension(d, 0.0, nextafter(v, 9.0)), f, 1e-15, 1e-20);
  }
  test_free(d, m);

  /* one slope everywhere is a linear damper; both kinds add */
  m = slide("damping: 2, slopes: {c1: 3, c2: 3, c3: 3, c4: 3, v11: 0.1, v22: -0.2}");
  d = test_start(m);
  for (i = -10; i <= 10; ++i) CHECK_NEAR(tension(d, 0.1, 0.1 * i), 0.5 * i, 1e-14, 1e-15);
  test_free(d, m);
}

/* ------------------------------------------------------------------------------------- springs */

static void test_springs(void)
{
  maggi_model *m = slide("stiffness: 50, free_length: 1.7, damping: 4");
  maggi_data *d = test_start(m);

  CHECK_NEAR(tension(d, 0.0, 0.0), 50.0 * 0.3, 1e-14, 0.0);
  CHECK_NEAR(tension(d, -0.3, 0.0), 0.0, 0.0, 1e-13);
  CHECK_NEAR(tension(d, -0.8, 0.5), 50.0 * -0.5 + 4.0 * 0.5, 1e-14, 0.0);
  test_free(d, m);

  /* the preload is the force in the drawing, whatever the stiffness */
  m = slide("stiffness: 50, preload: -6");
  d = test_start(m);
  CHECK_NEAR(tension(d, 0.0, 0.0), -6.0, 1e-15, 0.0);
  CHECK_NEAR(tension(d, 0.2, 0.0), -6.0 + 10.0, 1e-14, 0.0);
  /* and a length as drawn follows the points when these are parameters: 3 m now */
  CHECK(test_set(m, d, "springs.s.point_a.x", 3.0));
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK_NEAR(-test_get(d).a[0], -6.0, 1e-15, 0.0);
  test_free(d, m);

  m = slide("stiffness: 50, preload: 0");
  d = test_start(m);
  CHECK_NEAR(tension(d, 0.0, 0.0), 0.0, 0.0, 0.0);
  test_free(d, m);
}

/* in space: the force has the direction of the line, the rate is the projection on it */
static void test_direction(void)
{
  maggi_model *m = test_model(
      "gravity: [0, 0, 0]\n"
      "bodies: [{name: b, mass: 2, cog: [1, 2, 2], inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: free, point: [1, 2, 2]}}]\n"
      "springs: [{name: s, body_a: ground, body_b: b, point_a: [0, 0, 0], point_b: [1, 2, 2],"
      " stiffness: 10, free_length: 2.5, damping: 3}]\n");
  maggi_data *d = test_start(m);
  double q[6] = {0}, v[6] = {0.4, -0.5, 0.6, 0, 0, 0}, rate, F;
  test_state s = at(d, q, v);

  rate = (2.0 * 0.4 - 2.0 * 0.5 + 1.0 * 0.6) / 3.0;
  F = 10.0 * 0.5 + 3.0 * rate;
  CHECK_NEAR(s.a[2], -F / 2.0 * 1.0 / 3.0, 1e-14, 0.0); /* coordinates: z, y, x */
  CHECK_NEAR(s.a[1], -F / 2.0 * 2.0 / 3.0, 1e-14, 0.0);
  CHECK_NEAR(s.a[0], -F / 2.0 * 2.0 / 3.0, 1e-14, 0.0);
  CHECK_NEAR(s.a[3], 0.0, 0.0, 1e-14);
  test_free(d, m);
}

/* torsion between two flywheels of 2 and 3 kg m^2, and a spring on one coordinate */
static void test_torsion(void)
{
  maggi_model *m = test_model(
      "bodies:\n"
      "- {name: a, mass: 1, inertia: {xx: 2, yy: 1, zz: 1},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0]}}\n"
      "- {name: b, mass: 1, inertia: {xx: 3, yy: 2, zz: 2},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0]}}\n"
      "joint_springs:\n"
      "- {name: s, coordinate: a, coordinate2: b, stiffness: 7, damping: 0.5, rest: 0.1,"
      " preload: 0.3}\n"
      "- {name: t, coordinate: b, stiffness: 4, damping: 0.2, rest: -0.3, preload: 1}\n");
  maggi_data *d = test_start(m);
  double q[2] = {0.4, -0.2}, v[2] = {1.5, -1}, s, t;
  test_state state = at(d, q, v);

  s = -7.0 * (0.6 - 0.1) - 0.5 * 2.5 - 0.3;
  t = -4.0 * (-0.2 + 0.3) + 0.2 - 1.0;
  CHECK_NEAR(state.a[0], s / 2.0, 1e-14, 0.0);
  CHECK_NEAR(state.a[1], (t - s) / 3.0, 1e-14, 0.0);
  test_free(d, m);
}

/* --------------------------------------------------------------------------------------- loads */

/* two free bodies in space with every kind of load and spring between them */
static maggi_model *free_bodies(void)
{
  return test_model(
      "gravity: [0, 0, 0]\n"
      "bodies:\n"
      "- {name: a, mass: 2, cog: [1, 0, 0], inertia: {xx: 0.5, yy: 0.7, zz: 0.9, xy: 0.05},"
      " joint: {type: free, point: [1, 0, 0]}}\n"
      "- {name: b, mass: 3, cog: [0, 2, 1], inertia: {xx: 0.8, yy: 0.6, zz: 1, xz: -0.1},"
      " joint: {type: free, point: [0, 2, 1]}}\n"
      "springs: [{name: s, body_a: a, body_b: b, point_a: [1.2, 0.3, 0], point_b: [0, 1.5, 0.8],"
      " stiffness: 40, free_length: 1, damping: 2,"
      " slopes: {c1: 1, c2: 2, c3: 3, c4: 4, v11: 0.1, v22: -0.1}}]\n"
      "functions: [{name: f, type: polynomial, coefficients: [0.5, 2]}]\n"
      "forces:\n"
      "- {name: f1, type: force, body: a, reaction: b, point: [1.5, 0.2, 0.3], value: [3, -2, 1],"
      " function: f}\n"
      "- {name: f2, type: force_body, body: b, reaction: a, point: [0.1, 2, 1.4],"
      " value: [1, 2, -3]}\n"
      "- {name: f3, type: torque, body: a, reaction: b, value: [0.5, 1, -2]}\n"
      "- {name: f4, type: torque_body, body: b, reaction: a, value: [1, -0.5, 0.7]}\n"
      "- {name: f5, type: drag, body: a, reaction: b, point: [1, 0.5, 0], density: 2,"
      " coefficient: 1, area: 3, low_speed: 0.1, wind: [1, 2, 3], function: f}\n");
}

/* momentum and angular momentum about the origin do not change: the moments of all forces add to
 * nothing; each force for itself is in test_loads */
static void test_reaction(void)
{
  maggi_model *m = free_bodies();
  maggi_data *d = test_start(m);
  double q[12], v[12], sum, size;
  unsigned long long seed = 41;
  int n, i, k;

  for (n = 0; n < 20; ++n) {
    for (i = 0; i < 12; ++i) {
      q[i] = random11(&seed);
      v[i] = random11(&seed);
    }
    CHECK(maggi_data_set_state(d, 0.3, q, v) == MAGGI_OK);
    for (k = 0; k < 6; ++k) {
      sum = size = 0.0;
      for (i = 0; i < d->t.nbody; ++i) {
        sum += d->Q[i][k];
        size += fabs(d->Q[i][k]);
      }
      CHECK(size > 0.1);
      CHECK_NEAR(sum / size, 0.0, 0.0, 1e-13);        /* loads of a body cancel in size */
      CHECK_NEAR(d->Q[d->t.nbody][k], 0.0, 0.0, 0.0); /* nothing goes to the ground */
    }
  }
  test_free(d, m);
}

/* one load on a free body of 2 kg, turned by a quarter about z: acceleration and angular
 * acceleration; without `reaction` the ground takes it */
static void check_load(const char *load, double ax, double ay, double az, double turn)
{
  maggi_model *m =
      test_model("gravity: [0, 0, 0]\n"
                 "bodies: [{name: b, mass: 2, cog: [1, 1, 1], inertia: {xx: 0.5, yy: 0.5, zz: 0.5},"
                 " joint: {type: free, point: [1, 1, 1]}}]\n"
                 "functions: [{name: f, type: polynomial, coefficients: [0.5, 2]}]\n"
                 "forces: [{name: l, body: b, %s}]\n",
                 load);
  maggi_data *d = test_start(m);
  double q[6] = {0, 0, 0, acos(0.0), 0, 0}, v[6] = {0};
  test_state s;

  CHECK(maggi_data_set_state(d, 1.0, q, v) == MAGGI_OK);
  s = test_get(d);
  CHECK_NEAR(s.a[2], ax, 1e-14, 1e-14);
  CHECK_NEAR(s.a[1], ay, 1e-14, 1e-14);
  CHECK_NEAR(s.a[0], az, 1e-14, 1e-14);
  CHECK_NEAR(s.a[3], turn, 1e-14, 1e-14);
  test_free(d, m);
}

static void test_loads(void)
{
  /* the point [2, 1, 1] stands at [1, 2, 1] after the turn, the arm is [0, 1, 0] */
  check_load("type: force, point: [2, 1, 1], value: [3, 4, 5]", 1.5, 2.0, 2.5, -3.0 / 0.5);
  check_load("type: force, point: [2, 1, 1], value: [3, 4, 5], function: f", 3.75, 5.0, 6.25,
             -7.5 / 0.5);
  /* in body axes x is y now, and y is minus x */
  check_load("type: force_body, point: [2, 1, 1], value: [3, 4, 5]", -2.0, 1.5, 2.5, 4.0 / 0.5);
  check_load("type: torque, value: [0, 0, 3]", 0.0, 0.0, 0.0, 6.0);
  check_load("type: torque_body, value: [0, 0, 3], function: f", 0.0, 0.0, 0.0, 15.0);
}

static void test_joint_load(void)
{
  maggi_model *m =
      test_model("gravity: [0, 0, 0]\n"
                 "bodies:\n"
                 "- {name: a, mass: 2, joint: {type: prismatic, axis: [0, 3, 4]}}\n"
                 "- {name: b, mass: 1, inertia: {xx: 3, yy: 3, zz: 3},"
                 " joint: {type: cylindrical, point: [0, 0, 0], axis: [1, 1, 1]}}\n"
                 "functions: [{name: f, type: constant, value: -2}]\n"
                 "forces:\n"
                 "- {name: l, type: joint, coordinate: a, effort: 5}\n"
                 "- {name: n, type: joint, coordinate: b.2, effort: 6, function: f}\n");
  maggi_data *d = test_start(m);
  test_state s = test_get(d);

  CHECK_NEAR(s.a[0], 2.5, 1e-15, 0.0);
  CHECK_NEAR(s.a[1], 0.0, 0.0, 1e-15);
  CHECK_NEAR(s.a[2], -4.0, 1e-14, 0.0);
  test_free(d, m);
}

/* ---------------------------------------------------------------------------------------- drag */

/* at rest in the wind of 5 m/s: 0.2 |u| u, where the other loads act in test_loads */
static void test_wind(void)
{
#define AIR                                                                                        \
  "type: drag, point: [2, 1, 1], density: 2, coefficient: 0.5, area: 0.4, low_speed: 1e-9, "       \
  "wind: [3, 0, -4]"
  check_load(AIR, 1.5, 0.0, -2.0, -3.0 / 0.5);
  check_load(AIR ", function: f", 3.75, 0.0, -5.0, -7.5 / 0.5);
#undef AIR
}

/* the velocity is that of the point, by the turn of the body too; at rest in the air the force is
 * zero and its slope is that of low_speed.  3 kg/m of air, arm 0.5 m, inertia 2 kg m^2 */
static void test_drag_of_a_point(void)
{
  maggi_model *m =
      test_model("gravity: [0, 0, 0]\n"
                 "bodies: [{name: b, mass: 1, inertia: {xx: 2, yy: 2, zz: 2},"
                 " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]}}]\n"
                 "forces: [{name: air, type: drag, body: b, point: [0.5, 0, 0], density: 1,"
                 " coefficient: 2, area: 3, low_speed: 3}]\n");
  maggi_data *d = test_start(m);
  double q = 0.7, v = 8.0;

  CHECK_NEAR(at(d, &q, &v).a[0], -3.0 * 5.0 * 4.0 * 0.5 / 2.0, 1e-14, 0.0); /* 3^2 + 4^2 = 5^2 */
  v = -8.0;
  CHECK_NEAR(at(d, &q, &v).a[0], 3.0 * 5.0 * 4.0 * 0.5 / 2.0, 1e-14, 0.0);
  v = 0.0;
  CHECK_NEAR(at(d, &q, &v).a[0], 0.0, 0.0, 0.0);
  v = 1e-9;
  CHECK_NEAR(at(d, &q, &v).a[0] / v, -3.0 * 3.0 * 0.5 * 0.5 / 2.0, 1e-14, 0.0);
  test_free(d, m);
}

/* a body falls from rest: v = vt tanh(g t/vt), vt^2 = 2 m g / (density coefficient area); what it
 * loses goes into the air, T + V = work.  Errors: h^4, and (low_speed / vt)^2 */
static void test_fall(void)
{
  const double g = 9.81, vt = sqrt(2.0 * 3.0 * g / (1.2 * 0.5 * 0.8)), h = 2e-3;
  maggi_model *m =
      test_model("bodies: [{name: b, mass: 3, joint: {type: prismatic, axis: [0, 0, -1]}}]\n"
                 "forces: [{name: air, type: drag, body: b, point: [1, 2, 3], density: 1.2,"
                 " coefficient: 0.5, area: 0.8, low_speed: 1e-6}]\n");
  maggi_data *d = test_start(m);
  maggi_energy e;
  double t, v;
  int i;

  for (i = 1; i <= 10; ++i) {
    test_step(d, h, 150);
    t = 150.0 * h * i;
    v = vt * tanh(g * t / vt);
    CHECK_NEAR(test_get(d).v[0], v, 1e-11, 0.0);
    CHECK_NEAR(test_get(d).q[0], vt * vt / g * log(cosh(g * t / vt)), 1e-11, 0.0);
    maggi_get_energy(d, &e);
    CHECK_NEAR(e.work, 0.5 * 3.0 * v * v - 3.0 * g * test_get(d).q[0], 1e-9, 0.0);
  }
  CHECK_NEAR(test_get(d).v[0], vt, 0.01, 0.0);
  test_free(d, m);
}

int main(void)
{
  test_slopes();
  test_springs();
  test_direction();
  test_torsion();
  test_reaction();
  test_loads();
  test_joint_load();
  test_wind();
  test_drag_of_a_point();
  test_fall();
  return check_done();
}
