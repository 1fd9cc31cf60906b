/* core/dynamics/data.c, and the states of assemble.c: parameters with their limits, tolerance,
 * set_state, what is left after a failure. */
#include "fixture.h"

static maggi_model *four_bar(void)
{
  return test_model(
      "bodies:\n"
      "- {name: crank, mass: 1, bar: {from: [0, 0, 0], to: [0, 0, -1]},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0], velocity: -1}}\n"
      "- {name: coupler, parent: crank, mass: 1, bar: {from: [0, 0, -1], to: [0, 1.2, -1.3]},"
      " joint: {type: revolute, point: [0, 0, -1], axis: [1, 0, 0]}}\n"
      "- {name: follower, mass: 1, bar: {from: [0, 1.2, 0], to: [0, 1.2, -1.3]},"
      " joint: {type: revolute, point: [0, 1.2, 0], axis: [1, 0, 0]}}\n"
      "loops: [{name: l, type: revolute, body_a: coupler, body_b: follower, point: [0, 1.2, -1.3],"
      " axis: [1, 0, 0]}]\n"
      "sensors: [{name: s, type: position, body: coupler, point: [0, 1.2, -1.3]}]\n");
}

static void refused(maggi_data *d, int index, double value, maggi_status status, const char *text)
{
  double before = maggi_data_get_parameter(d, index);

  CHECK(maggi_data_set_parameter(d, index, value) == status);
  CHECK_TEXT(maggi_data_message(d), text);
  if (status != MAGGI_E_NAME) CHECK(maggi_data_get_parameter(d, index) == before);
}

static void test_parameters(void)
{
  maggi_model *m = test_model(
      "bodies:\n"
      "- {name: b, mass: 1, inertia: {xx: 1, yy: 1, zz: 1}, joint: {type: revolute,"
      " point: [0, 0, 0], axis: [1, 0, 0]}, point_masses: [{name: p, mass: 1, point: [0, 1, 0]}]}\n"
      "- {name: c, mass: 1, joint: {type: prismatic, axis: [0, 0, 1]}}\n"
      "springs:\n"
      "- {name: s, body_a: b, body_b: c, point_a: [0, 1, 0], point_b: [0, 0, 0], free_length: 1,"
      " slopes: {c1: 1, c2: 1, c3: 1, c4: 1, v11: 1, v22: -1}}\n"
      "rods:\n"
      "- {name: r, body_a: b, body_b: c, point_a: [0, 1, 0], point_b: [0, 0, 0], length: 1}\n"
      "functions:\n"
      "- {name: f, type: step, t0: 0, t1: 1, y0: 0, y1: 1}\n"
      "- {name: g, type: spline, times: [0, 1, 2], values: [0, 1, 2]}\n");
  maggi_data *d = test_data(m), *e = test_data(m);
  int mass = maggi_parameter_find(m, "bodies.b.mass");

#define INDEX(path) maggi_parameter_find(m, path)
  refused(d, -1, 1.0, MAGGI_E_NAME, "no parameter has the index -1");
  refused(d, 9999, 1.0, MAGGI_E_NAME, "no parameter has the index 9999");
  CHECK(isnan(maggi_data_get_parameter(d, -1)) && isnan(maggi_data_get_parameter(d, 9999)));
  refused(d, mass, NAN, MAGGI_E_VALUE, "bodies.b.mass must be finite (nan)");
  refused(d, mass, INFINITY, MAGGI_E_VALUE, "bodies.b.mass must be finite (inf)");
  refused(d, mass, -1.0, MAGGI_E_VALUE, "bodies.b.mass must not be negative (-1)");
  refused(d, INDEX("bodies.b.inertia.yy"), -1.0, MAGGI_E_VALUE,
          "bodies.b.inertia.yy must not be negative (-1)");
  refused(d, INDEX("bodies.b.point_masses.p.mass"), -1.0, MAGGI_E_VALUE,
          "bodies.b.point_masses.p.mass must not be negative (-1)");
  refused(d, INDEX("rods.r.mass"), -1.0, MAGGI_E_VALUE, "rods.r.mass must not be negative (-1)");
  refused(d, INDEX("rods.r.length"), 0.0, MAGGI_E_VALUE, "rods.r.length must be positive (0)");
  refused(d, INDEX("springs.s.free_length"), -1.0, MAGGI_E_VALUE,
          "springs.s.free_length must not be negative (-1)");
  /* the same that the builder refuses */
  CHECK(maggi_data_set_parameter(d, INDEX("springs.s.v11"), -0.5) == MAGGI_E_VALUE);
  CHECK(maggi_data_set_parameter(d, INDEX("springs.s.v22"), 0.5) == MAGGI_E_VALUE);

  CHECK(maggi_data_set_parameter(d, mass, 0.0) == MAGGI_OK);
  CHECK(maggi_data_set_parameter(d, mass, 3.5) == MAGGI_OK);
  CHECK(maggi_data_get_parameter(d, mass) == 3.5);
  /* not of the model, nor of other simulations */
  CHECK(maggi_parameter_default(m, mass) == 1.0);
  CHECK(maggi_data_get_parameter(e, mass) == 1.0);
  maggi_data_free(e);
  test_free(d, m);
}

/* what the limits of single parameters do not see fails at the reset, with a message; the next good
 * reset works again */
static void test_bad_reset(void)
{
  maggi_model *m = four_bar();
  maggi_data *d = test_data(m);

  CHECK(test_set(m, d, "bodies.crank.joint.axis.x", 0.0));
  CHECK(maggi_data_reset(d) == MAGGI_E_VALUE);
  CHECK(maggi_data_message(d)[0] != '\0');
  CHECK(maggi_step(d, 1e-3) == MAGGI_E_MODEL);
  CHECK(!maggi_coordinate_is_independent(d, 0));
  CHECK(test_set(m, d, "bodies.crank.joint.axis.x", 2.0));
  CHECK(test_set(m, d, "loops.l.axis.x", 0.0));
  CHECK(maggi_data_reset(d) == MAGGI_E_VALUE);
  CHECK(test_set(m, d, "loops.l.axis.x", 1.0));
  CHECK(test_set(m, d, "loops.l.point.y", 9.0));
  CHECK(maggi_data_reset(d) ==
        MAGGI_OK); /* both sides share the point: longer bars, still closed */
  CHECK(test_set(m, d, "loops.l.point.y", 1.2));
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK_TEXT(maggi_data_message(d), "");
  CHECK(maggi_step(d, 1e-3) == MAGGI_OK);
  CHECK_NEAR(test_get(d).q[0], -1e-3, 1e-2, 0.0);
  test_free(d, m);
}

/* the same start after whatever has happened */
static void test_repeat(void)
{
  maggi_model *m = four_bar();
  maggi_data *d = test_start(m), *e = test_start(m);
  test_state first, s;

  test_step(d, 1e-3, 500);
  first = test_get(d);
  CHECK(maggi_step(e, NAN) == MAGGI_E_VALUE);
  test_step(e, 1e-2, 77);
  CHECK(test_set(m, e, "bodies.crank.mass", 7.0));
  CHECK(maggi_data_reset(e) == MAGGI_OK);
  test_step(e, 1e-2, 33);
  CHECK(test_set(m, e, "bodies.crank.mass", 1.0));
  CHECK(maggi_data_reset(e) == MAGGI_OK);
  CHECK(maggi_get_time(e) == 0.0);
  test_step(e, 1e-3, 500);
  s = test_get(e);
  CHECK(memcmp(&s, &first, sizeof s) == 0);
  maggi_data_free(e);
  test_free(d, m);
}

/* dependents follow, independents stay as they are, in position and velocity */
static void test_set_state(void)
{
  maggi_model *m = four_bar();
  maggi_data *d = test_start(m);
  test_state s;
  double q[3], v[3], x[3];
  int i, n, free_one;

  for (n = 0; n < 40; ++n) {
    for (i = 0; i < 3; ++i) {
      q[i] = 0.05 * n * (i == 1 ? -1.0 : 1.0) * 0.5;
      v[i] = 0.3 + 0.1 * i;
    }
    CHECK(maggi_data_set_state(d, 2.5, q, v) == MAGGI_OK);
    CHECK(maggi_get_time(d) == 2.5);
    s = test_get(d);
    CHECK(test_loops(d).violation < 1e-14);
    free_one = 0;
    for (i = 0; i < 3; ++i) {
      if (!maggi_coordinate_is_independent(d, i)) continue;
      ++free_one;
      CHECK(s.q[i] == q[i]);
      CHECK(s.v[i] == v[i]);
    }
    CHECK(free_one == 1);
    /* velocities fit: the follower's end moves as the coupler's; in the plane
     * (y, z) -> x' = w (-z, y) about (0, 1.2, 0) */
    maggi_get_sensors(d, x);
    CHECK_NEAR(hypot(x[1] - 1.2, x[2]), 1.3, 1e-14, 0.0);
  }
  /* its own state is a fixed point */
  s = test_get(d);
  CHECK(maggi_data_set_state(d, 0.0, s.q, s.v) == MAGGI_OK);
  for (i = 0; i < 3; ++i) {
    CHECK_NEAR(test_get(d).q[i], s.q[i], 0.0, 1e-14);
    CHECK_NEAR(test_get(d).v[i], s.v[i], 0.0, 1e-13);
    CHECK_NEAR(test_get(d).a[i], s.a[i], 0.0, 1e-12);
  }
  /* the simulation goes on from there */
  CHECK(maggi_step(d, 1e-3) == MAGGI_OK);

  q[1] = NAN;
  CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_E_VALUE);
  CHECK_TEXT(maggi_data_message(d), "the state of \"coupler\" must be finite");
  CHECK(maggi_step(d, 1e-3) == MAGGI_E_MODEL);
  q[1] = 0.0;
  v[2] = INFINITY;
  CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_E_VALUE);
  v[2] = 0.0;
  CHECK(maggi_data_set_state(d, NAN, q, v) == MAGGI_E_VALUE);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK(maggi_step(d, 1e-3) == MAGGI_OK);
  test_free(d, m);
}

/* the same in space with several loops, where the choice of the coordinates has more room */
static void test_set_state_spatial(void)
{
  maggi_model *m = test_model(
      "bodies:\n"
      "- {name: a, mass: 1.1, cog: [0.2, 0.1, 0.4], inertia: {xx: 0.2, yy: 0.3, zz: 0.25},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0.3, 0]}}\n"
      "- {name: b, parent: a, mass: 0.7, cog: [0, 0.9, 0.2], inertia: {xx: 0.1, yy: 0.1, zz: 0.1},"
      " joint: {type: universal, point: [0, 0.5, 0.3], axis: [0, 0.2, 1], axis2: [1, 0, 0]}}\n"
      "- {name: c, parent: b, mass: 0.4, cog: [0.3, 1.2, 0.1], inertia: {xx: 0.1, yy: 0.1, zz: "
      "0.1},"
      " joint: {type: spherical, point: [0.1, 1, 0.2]}}\n"
      "- {name: e, parent: a, mass: 0.9, bar: {from: [0.5, 0, 0], to: [1, 0.8, 0.3]},"
      " joint: {type: revolute, point: [0.5, 0, 0], axis: [0, 0.1, 1]}}\n"
      "- {name: f, mass: 1.4, cog: [1.5, 0.5, 0], inertia: {xx: 0.3, yy: 0.3, zz: 0.4},"
      " joint: {type: planar, point: [1.5, 0.5, 0], axis: [0, 0, 1]}}\n"
      "- {name: h, parent: f, mass: 0.5, bar: {from: [2, 0.5, 0.1], to: [2, 1.5, 0.4]},"
      " joint: {type: cylindrical, point: [2, 0.5, 0.1], axis: [0, 0.2, 1]}}\n"
      "loops:\n"
      "- {name: l1, type: spherical, body_a: c, body_b: f, point: [1.1, 1.1, 0.1]}\n"
      "- {name: l2, type: cylindrical, body_a: e, body_b: h, point: [1.6, 1, 0.3],"
      " axis: [1, 0.3, 0.1]}\n");
  maggi_data *d = test_start(m);
  test_state s;
  double q[12] = {0}, v[12];
  unsigned long long seed = 9;
  int i, n, count;

  CHECK(test_coordinates(m) == 12 && test_loops(d).dof == 5);
  for (n = 0; n < 20; ++n) {
    for (i = 0; i < 12; ++i) {
      q[i] = 0.15 * random11(&seed);
      v[i] = random11(&seed);
    }
    CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
    s = test_get(d);
    count = 0;
    for (i = 0; i < 12; ++i) {
      if (!maggi_coordinate_is_independent(d, i)) continue;
      ++count;
      CHECK(s.q[i] == q[i]); /* "loops are closed by moving the dependent coordinates" */
      CHECK(s.v[i] == v[i]);
    }
    CHECK(count == 5);
  }
  test_free(d, m);
}

/* a tighter tolerance keeps the loops tighter closed; nonsense is refused and changes nothing */
static void test_tolerance(void)
{
  maggi_model *m = four_bar();
  maggi_data *d = test_start(m);
  double tolerance, worst;
  long before = 0;
  int i;

  CHECK(maggi_data_set_tolerance(d, 0.0) == MAGGI_E_VALUE);
  CHECK(maggi_data_set_tolerance(d, -1.0) == MAGGI_E_VALUE);
  CHECK(maggi_data_set_tolerance(d, NAN) == MAGGI_E_VALUE);
  CHECK(maggi_data_set_tolerance(d, INFINITY) == MAGGI_E_VALUE);
  CHECK(maggi_data_message(d)[0] != '\0');
  CHECK(maggi_step(d, 0.01) == MAGGI_OK);
  for (tolerance = 1e-6; tolerance > 1e-15; tolerance *= 1e-2) {
    CHECK(maggi_data_set_tolerance(d, tolerance) == MAGGI_OK);
    CHECK(maggi_data_reset(d) == MAGGI_OK);
    worst = 0.0;
    for (i = 0; i < 200; ++i) {
      test_step(d, 0.01, 1);
      worst = fmax(worst, test_loops(d).violation);
    }
    CHECK(worst > 0.0 && worst <= tolerance);
    CHECK(test_loops(d).projections >= before);
    before = test_loops(d).projections;
  }
  CHECK(before >= 200);
  test_free(d, m);
}

/* a model of fixed bodies only, one of guides only, a structure without freedom, loops of bodies
 * that no free coordinate moves: nothing to solve, and nothing wrong */
static void test_edges(void)
{
  static const char *const models[] = {
      "bodies: [{name: b, mass: 1, joint: {type: fixed}}]\n",
      "bodies: [{name: b, mass: 1, joint: {type: prismatic, axis: [0, 0, 1], motion: f}}]\n"
      "functions: [{name: f, type: constant, value: 0.5}]\n",
      "bodies:\n"
      "- {name: b, mass: 1, joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0]}}\n"
      "loops: [{name: l, type: spherical, body_a: b, body_b: ground, point: [0, 1, 0]}]\n",
      "bodies: [{name: b, mass: 1, joint: {type: fixed}}]\n"
      "loops: [{name: l, type: revolute, body_a: b, body_b: ground, point: [0, 1, 0],"
      " axis: [1, 1, 1]}]\n"
      "rods: [{name: r, body_a: b, body_b: ground, point_a: [0, 1, 0], point_b: [1, 0, 0],"
      " mass: 1}]\n",
      "bodies: [{name: b, mass: 1, joint: {type: prismatic, axis: [0, 0, 1], motion: f}}]\n"
      "functions: [{name: f, type: constant, value: 0}]\n"
      "loops: [{name: l, type: spherical, body_a: b, body_b: ground, point: [0, 1, 0]}]\n",
  };
  double w[6], lambda[16], drives[4];
  maggi_model *m;
  maggi_data *d;
  int i;

  for (i = 0; i < 5; ++i) {
    m = test_model("%s", models[i]);
    d = test_start(m);
    CHECK(test_loops(d).dof == 0);
    test_step(d, 0.1, 3);
    maggi_get_reactions(d, w);
    maggi_get_multipliers(d, lambda);
    maggi_get_drives(d, drives);
    if (i < 2) CHECK_NEAR(w[2], 9.81, 1e-15, 0.0);
    if (i == 1) CHECK_NEAR(drives[0], 9.81, 1e-15, 0.0);
    CHECK_NEAR(test_energy(d), i == 1 ? 0.5 * 9.81 : 0.0, 1e-14, 1e-14);
    test_free(d, m);
  }
}

/* before a reset: numbers, no crash */
static void test_early(void)
{
  maggi_model *m = four_bar();
  maggi_data *d = test_data(m);
  double w[18], s[3], lambda[6], drives[3];
  maggi_energy e;

  CHECK_TEXT(maggi_data_message(d), "");
  CHECK(maggi_step(d, 1e-3) == MAGGI_E_MODEL);
  CHECK_TEXT(maggi_data_message(d), "a step needs a successful reset before it");
  CHECK(maggi_get_time(d) == 0.0);
  maggi_get_reactions(d, w);
  maggi_get_sensors(d, s);
  maggi_get_multipliers(d, lambda);
  maggi_get_drives(d, drives);
  maggi_get_energy(d, &e);
  CHECK(!maggi_coordinate_is_independent(d, 0));
  CHECK(test_loops(d).evaluations == 0);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  maggi_get_sensors(d, s);
  CHECK_NEAR(s[2], -1.3, 1e-15, 0.0); /* not what the call before the reset has left */
  test_free(d, m);
}

int main(void)
{
  test_parameters();
  test_bad_reset();
  test_repeat();
  test_set_state();
  test_set_state_spatial();
  test_tolerance();
  test_edges();
  test_early();
  return check_done();
}
