/* core/sensitivity/direct.c: state sensitivities against exact solutions and differences of whole
 * simulations, what they need and when they end. */
#include "data.h"
#include "fixture.h"

static maggi_design *design_of(const maggi_data *d, const char *pattern)
{
  char message[256];
  maggi_design *g = NULL;

  if (maggi_design_create(d, &g) != MAGGI_OK) exit(1);
  if (maggi_design_select(g, pattern, message, sizeof message) != MAGGI_OK) {
    fprintf(stderr, "%s\n", message);
    exit(1);
  }
  return g;
}

static maggi_direct *direct_of(maggi_data *d, const maggi_design *g)
{
  maggi_direct *s = NULL;

  CHECK(maggi_direct_create(d, g, &s) == MAGGI_OK);
  CHECK(maggi_direct_reset(s) == MAGGI_OK);
  return s;
}

static void step(maggi_direct *s, double h, int n)
{
  int i;

  for (i = 0; i < n; ++i) CHECK(maggi_direct_step(s, h) == MAGGI_OK);
}

/* A slide under a constant force: z = z0 + z0' t + f t^2 / (2 m), which the method has exactly. */
static void test_exact(void)
{
  maggi_model *m = test_model(
      "gravity: [0, 0, 0]\n"
      "bodies: [{name: b, mass: 2, joint: {type: prismatic, axis: [1, 0, 0], position: 0.5,"
      " velocity: 1.5}}]\n"
      "forces: [{name: f, type: joint, coordinate: b, effort: 3}]\n");
  static const char *const path[] = {"bodies.b.mass", "bodies.b.joint.position",
                                     "bodies.b.joint.velocity", "forces.f.value"};
  maggi_data *d = test_data(m);
  maggi_design *g = NULL;
  maggi_direct *s;
  char message[128];
  double q[4], v[4], a[4], t;
  int i;

  CHECK(maggi_design_create(d, &g) == MAGGI_OK);
  for (i = 0; i < 4; ++i)
    CHECK(maggi_design_select(g, path[i], message, sizeof message) == MAGGI_OK);
  s = direct_of(d, g);
  step(s, 0.1, 7);
  t = maggi_get_time(d);
  maggi_direct_get_coordinates(s, q, v, a);
  CHECK_NEAR(q[0], -0.5 * 3.0 / 4.0 * t * t, 1e-14, 0.0);
  CHECK_NEAR(q[1], 1.0, 1e-15, 0.0);
  CHECK_NEAR(q[2], t, 1e-14, 0.0);
  CHECK_NEAR(q[3], 0.25 * t * t, 1e-14, 0.0);
  CHECK_NEAR(v[0], -0.75 * t, 1e-14, 0.0);
  CHECK_NEAR(v[2], 1.0, 1e-15, 0.0);
  CHECK_NEAR(v[3], 0.5 * t, 1e-14, 0.0);
  CHECK_NEAR(a[0], -0.75, 1e-14, 0.0);
  CHECK_NEAR(a[3], 0.5, 1e-14, 0.0);
  CHECK(v[1] == 0.0 && a[1] == 0.0 && a[2] == 0.0);
  maggi_direct_free(s);
  maggi_design_free(g);
  test_free(d, m);
}

/* crank and follower of unequal lengths; the given position is that of a coordinate that the given
 * velocity makes dependent */
static maggi_model *four_bar(const char *crank, const char *follower)
{
  return test_model(
      "bodies:\n"
      "  - {name: crank, mass: 1, cog: [0, 0.1, -0.5], inertia: {xx: 0.1, yy: 0.1}, joint: {type:"
      " revolute, point: [0, 0, 0], axis: [1, 0, 0]%s}}\n"
      "  - {name: coupler, parent: crank, mass: 2, bar: {from: [0, 0, -1], to: [0, 1.3, -1.1]},"
      " joint: {type: revolute, point: [0, 0, -1], axis: [1, 0, 0]}}\n"
      "  - {name: follower, mass: 1, bar: {from: [0, 1.2, 0], to: [0, 1.3, -1.1]}, joint: {type:"
      " revolute, point: [0, 1.2, 0], axis: [1, 0, 0]%s}}\n"
      "loops: [{name: end, type: spherical, body_a: coupler, body_b: follower, point_a: [0, 1.3, "
      "-1.1],"
      " point_b: [0, 1.32, -1.08]}]\n"
      "springs: [{name: s, body_a: coupler, body_b: ground, point_a: [0, 0.7, -1], point_b: [0.1, "
      "0.9,"
      " -2], stiffness: 30, free_length: 0.5, damping: 1}]\n"
      "sensors: [{name: end, type: acceleration, body: follower, point: [0, 1.3, -1.1]}]\n",
      crank, follower);
}

/* columns of the coordinates' state and a sensor by each parameter against differences, at the start and
 * later */
static void test_differences(const char *crank, const char *follower)
{
  static const char *const path[] = {"loops.end.point_b.y",
                                     "bodies.crank.joint.point.z",
                                     "bodies.follower.joint.velocity",
                                     "bodies.crank.joint.velocity",
                                     "bodies.follower.joint.position",
                                     "bodies.crank.joint.position",
                                     "springs.s.stiffness",
                                     "bodies.crank.cog.y"};
  enum { N = sizeof path / sizeof *path, X = 10 };
  maggi_model *m = four_bar(crank, follower);
  maggi_data *d = test_data(m), *other = test_data(m);
  maggi_design *g = NULL;
  maggi_direct *s;
  char message[128];
  double x[X * N], ahead[X], behind[X], value, b[N], e;
  int signal = maggi_signal_find(m, "end.y"), i, k, pass;

  CHECK(maggi_design_create(d, &g) == MAGGI_OK);
  for (i = 0; i < N; ++i) {
    CHECK(maggi_design_select(g, path[i], message, sizeof message) == MAGGI_OK);
    b[i] = maggi_design_value(g, i);
  }
  s = direct_of(d, g);
  CHECK(maggi_data_reset(other) == MAGGI_OK);
  maggi_hold_choice(other);
  for (pass = 0; pass < 2; ++pass) {
    maggi_direct_get_coordinates(s, x, x + 3 * N, x + 6 * N);
    maggi_direct_get_signals(s, 1, &signal, x + 9 * N);
    for (i = 0; i < N; ++i) {
      value = b[i];
      for (k = 0; k < 2; ++k) {
        b[i] = value + (k == 0 ? 1e-5 : -1e-5);
        CHECK(maggi_design_set(g, other, b) == MAGGI_OK);
        CHECK(maggi_data_reset(other) == MAGGI_OK);
        if (pass > 0) test_step(other, 0.01, 30);
        maggi_get_coordinates(other, k ? behind : ahead, (k ? behind : ahead) + 3,
                              (k ? behind : ahead) + 6);
        maggi_get_signals(other, 1, &signal, (k ? behind : ahead) + 9);
      }
      b[i] = value;
      for (k = 0; k < X; ++k) {
        e = (ahead[k] - behind[k]) / 2e-5;
        if (!CHECK_NEAR(x[k * N + i], e, 1e-7, 1e-7))
          fprintf(stderr, "  %s%s%s\n", path[i], crank, follower);
      }
    }
    step(s, 0.01, 30);
  }
  maggi_direct_free(s);
  maggi_design_free(g);
  maggi_data_free(other);
  test_free(d, m);
}

static void test_end(void)
{
  maggi_model *m = four_bar("", ", velocity: 1");
  maggi_data *d = test_data(m);
  maggi_design *g = design_of(d, "springs.*");
  maggi_direct *s = NULL;
  test_state plain, followed;

  CHECK(maggi_direct_create(d, g, &s) == MAGGI_OK);
  CHECK(maggi_direct_step(s, 0.01) == MAGGI_E_MODEL);
  CHECK_TEXT(maggi_data_message(d), "sensitivities need a reset before a step");
  CHECK(maggi_direct_reset(s) == MAGGI_OK);
  step(s, 0.01, 20);
  followed = test_get(d);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK(maggi_direct_step(s, 0.01) == MAGGI_E_MODEL);
  /* the motion does not depend on who looks */
  test_step(d, 0.01, 20);
  plain = test_get(d);
  CHECK(memcmp(&plain, &followed, sizeof plain) == 0);
  maggi_direct_free(s);
  test_step(d, 0.01, 2);
  maggi_direct_free(NULL);
  maggi_design_free(g);
  test_free(d, m);
}

int main(void)
{
  test_exact();
  test_differences("", "");
  test_differences(", velocity: -1", "");
  test_differences(", velocity: -1", ", position: 0.2");
  test_differences(", position: 0.1", ", velocity: 0.7");
  test_end();
  return check_done();
}
