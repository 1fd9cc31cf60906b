/* core/dynamics/assemble.c: loops that are open in the file, prescribed positions and velocities,
 * what cannot be closed. */
#include "fixture.h"

/* crank 1 m along x, coupler 2 m drawn at the angle `beta`, follower 1.5 m upwards, ground 2 m; the
 * coupler's end is not where the follower's is; with further keys in the joints of the three */
static maggi_model *four_bar(double beta, const char *crank, const char *coupler,
                             const char *follower)
{
  return test_model(
      "bodies:\n"
      "- {name: crank, mass: 1, bar: {from: [0, 0, 0], to: [1, 0, 0]},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]%s}}\n"
      "- {name: coupler, parent: crank, mass: 1, bar: {from: [1, 0, 0], to: [%.17g, %.17g, 0]},"
      " joint: {type: revolute, point: [1, 0, 0], axis: [0, 0, 1]%s}}\n"
      "- {name: follower, mass: 1, bar: {from: [2, 0, 0], to: [2, 1.5, 0]},"
      " joint: {type: revolute, point: [2, 0, 0], axis: [0, 0, 1]%s}}\n"
      "loops:\n"
      "- {name: knot, type: revolute, body_a: coupler, body_b: follower,"
      " point_a: [%.17g, %.17g, 0], point_b: [2, 1.5, 0], axis_a: [0, 0, 1], axis_b: [0, 0, 2]}\n",
      crank, 1.0 + 2.0 * cos(beta), 2.0 * sin(beta), coupler, follower, 1.0 + 2.0 * cos(beta),
      2.0 * sin(beta));
}

enum { DRAWN = 1 };

static maggi_model *open_four_bar(const char *crank, const char *coupler, const char *follower)
{
  return four_bar(DRAWN, crank, coupler, follower);
}

/* whether the three angles close the loop, by trigonometry */
static void check_closed(const maggi_data *d)
{
  test_state s = test_get(d);
  double a = s.q[0], b = DRAWN + s.q[0] + s.q[1], c = acos(0.0) + s.q[2];

  CHECK_NEAR(cos(a) + 2.0 * cos(b), 2.0 + 1.5 * cos(c), 0.0, 2e-15);
  CHECK_NEAR(sin(a) + 2.0 * sin(b), 1.5 * sin(c), 0.0, 2e-15);
  /* and its derivative */
  CHECK_NEAR(-sin(a) * s.v[0] - 2.0 * sin(b) * (s.v[0] + s.v[1]), -1.5 * sin(c) * s.v[2], 0.0,
             1e-14);
  CHECK_NEAR(cos(a) * s.v[0] + 2.0 * cos(b) * (s.v[0] + s.v[1]), 1.5 * cos(c) * s.v[2], 0.0, 1e-14);
}

static void test_close(void)
{
  maggi_model *m;
  maggi_data *d;
  test_state s;
  double ex, ey, l, b, c;
  char coupler[64], follower[64];
  int i;

  m = open_four_bar("", "", "");
  d = test_start(m);
  check_closed(d);
  CHECK(test_loops(d).violation < 1e-14);
  test_step(d, 1e-3, 100);
  test_free(d, m);

  /* given positions and velocities are honoured to the bit, guesses only lead to a branch */
  m = open_four_bar(", position: 0.7, velocity: 3.3", "", "");
  d = test_start(m);
  s = test_get(d);
  CHECK(s.q[0] == 0.7 && s.v[0] == 3.3);
  check_closed(d);
  test_free(d, m);
  m = open_four_bar("", "", ", position: 0.3, velocity: -2.1");
  d = test_start(m);
  s = test_get(d);
  CHECK(s.q[2] == 0.3 && s.v[2] == -2.1);
  check_closed(d);
  test_free(d, m);

  /* guesses near one of the two branches lead to it: the triangle crank end, knot, follower pivot
   * */
  ex = 2.0 - cos(0.4);
  ey = -sin(0.4);
  l = hypot(ex, ey);
  for (i = 0; i < 2; ++i) {
    b = atan2(ey, ex) + (i ? 1.0 : -1.0) * acos((l * l + 4.0 - 1.5 * 1.5) / (4.0 * l));
    c = atan2(2.0 * sin(b) - ey, 2.0 * cos(b) - ex);
    snprintf(coupler, sizeof coupler, ", guess: %.17g", b - 0.4 - DRAWN + 0.3);
    snprintf(follower, sizeof follower, ", guess: %.17g", c - acos(0.0) - 0.2);
    m = open_four_bar(", position: 0.4", coupler, follower);
    d = test_start(m);
    s = test_get(d);
    CHECK(s.q[0] == 0.4);
    check_closed(d);
    CHECK_NEAR(s.q[1], b - 0.4 - DRAWN, 0.0, 1e-13);
    CHECK_NEAR(s.q[2], c - acos(0.0), 0.0, 1e-13);
    test_free(d, m);
  }
}

/* the position of one coordinate and the velocity of another: the first is at rest or not, as the
 * second wants */
static void test_position_and_velocity(void)
{
  maggi_model *m = open_four_bar("", ", position: -0.9", ", velocity: 1.7");
  maggi_data *d = test_data(m);

  if (CHECK(maggi_data_reset(d) == MAGGI_OK)) {
    CHECK(test_get(d).q[1] == -0.9 && test_get(d).v[2] == 1.7);
    check_closed(d);
  } else {
    fprintf(stderr, "  %s\n", maggi_data_message(d));
  }
  test_free(d, m);
}

/* drawn further away, but a solution is there for all of these: crank at 0.7, coupler drawn around
 * */
static void test_far(void)
{
  maggi_model *m;
  maggi_data *d;
  int i, closed = 0;

  for (i = 0; i < 60; ++i) {
    m = four_bar(0.1 * i, ", position: 0.7", "", "");
    d = test_data(m);
    closed += maggi_data_reset(d) == MAGGI_OK;
    test_free(d, m);
  }
  if (!CHECK(closed == 60)) fprintf(stderr, "  %d of 60 closed\n", closed);
}

/* set as a parameter, a position or velocity becomes a given one */
static void test_set_given(void)
{
  maggi_model *m = open_four_bar("", "", "");
  maggi_data *d = test_start(m);

  CHECK(test_set(m, d, "bodies.crank.joint.position", 0.55));
  CHECK(test_set(m, d, "bodies.crank.joint.velocity", -4.5));
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK(test_get(d).q[0] == 0.55 && test_get(d).v[0] == -4.5);
  check_closed(d);
  test_free(d, m);
}

static void cannot_close(maggi_model *m, const char *begin)
{
  maggi_data *d = test_data(m);
  const char *message;

  CHECK(maggi_data_reset(d) == MAGGI_E_ASSEMBLY);
  message = maggi_data_message(d);
  if (!CHECK(strncmp(message, begin, strlen(begin)) == 0)) fprintf(stderr, "  %s\n", message);
  CHECK(maggi_step(d, 1e-3) == MAGGI_E_MODEL);
  test_free(d, m);
}

static void test_impossible(void)
{
  cannot_close(test_model("bodies:\n"
                          "- {name: a, mass: 1, bar: {from: [0, 0, 0], to: [1, 0, 0]},"
                          " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]}}\n"
                          "loops:\n"
                          "- {name: fine, type: spherical, body_a: a, body_b: ground,"
                          " point: [0, 0, 3]}\n"
                          "- {name: far, type: spherical, body_a: a, body_b: ground,"
                          " point_a: [1, 0, 0], point_b: [0, 5, 0]}\n"),
               "loop \"far\" cannot be closed in the initial position: ");
  cannot_close(test_model("bodies:\n"
                          "- {name: a, mass: 1, bar: {from: [0, 0, 0], to: [1, 0, 0]},"
                          " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]}}\n"
                          "rods: [{name: short, body_a: a, body_b: ground, point_a: [1, 0, 0],"
                          " point_b: [3, 0, 0], length: 0.5}]\n"),
               "rod \"short\" cannot be closed in the initial position: ");
  /* two prescribed positions that contradict each other */
  cannot_close(open_four_bar(", position: 0.3", "", ", position: 1.2"),
               "loop \"knot\" cannot be closed in the initial position: ");
  /* a guide that leads out of reach at the start */
  cannot_close(test_model("bodies:\n"
                          "- {name: a, mass: 1, joint: {type: prismatic, axis: [1, 0, 0],"
                          " motion: f}}\n"
                          "- {name: b, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
                          " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]}}\n"
                          "functions: [{name: f, type: constant, value: 9}]\n"
                          "rods: [{name: r, body_a: a, body_b: b, point_a: [2, 0, 0],"
                          " point_b: [1, 0, 0]}]\n"),
               "rod \"r\" cannot be closed in the initial position: ");
}

static void test_velocities(void)
{
  maggi_model *m = open_four_bar(", velocity: 1", "", ", velocity: 1");
  maggi_data *d = test_data(m);
  test_state s;
  char text[64];

  CHECK(maggi_data_reset(d) == MAGGI_E_ASSEMBLY);
  CHECK(strstr(maggi_data_message(d), "contradicts the others, which make it ") != NULL);
  CHECK(strstr(maggi_data_message(d), "the velocity 1 of \"") != NULL);
  CHECK(maggi_step(d, 1e-3) == MAGGI_E_MODEL);
  test_free(d, m);

  /* two that agree are welcome */
  m = open_four_bar(", position: 0.3, velocity: 1", "", "");
  d = test_start(m);
  s = test_get(d);
  test_free(d, m);
  snprintf(text, sizeof text, ", velocity: %.17g", s.v[2]);
  m = open_four_bar(", position: 0.3, velocity: 1", "", text);
  d = test_start(m);
  CHECK_NEAR(test_get(d).v[0], 1.0, 1e-14, 0.0);
  CHECK_NEAR(test_get(d).v[2], s.v[2], 1e-14, 0.0);
  CHECK_NEAR(test_get(d).v[1], s.v[1], 1e-13, 0.0);
  test_free(d, m);
}

/* in space: a loop of each kind drawn open, closed by the free coordinates of two arms */
static void test_space(void)
{
  static const char *const loops[] = {
      "{name: l, type: spherical, body_a: a2, body_b: b2, point_a: [0.5, 1, 0.2],"
      " point_b: [0.6, 0.9, 0.4]}",
      "{name: l, type: revolute, body_a: a2, body_b: b2, point_a: [0.5, 1, 0.2],"
      " point_b: [0.6, 0.9, 0.4], axis_a: [1, 2, 0], axis_b: [1, 2, 0.5]}",
      "{name: l, type: cylindrical, body_a: a2, body_b: b2, point_a: [0.5, 1, 0.2],"
      " point_b: [0.6, 0.9, 0.4], axis_a: [1, 2, 0], axis_b: [1, 2, 0.5]}",
      "{name: l, type: prismatic, body_a: a2, body_b: b2, point_a: [0.5, 1, 0.2],"
      " point_b: [0.6, 0.9, 0.4], axis_a: [1, 2, 0], axis_b: [1, 2, 0.5]}",
  };
  maggi_model *m;
  maggi_data *d;
  double s[12], e[3], c[3], u[3], w[3];
  int i, k;

  for (i = 0; i < 4; ++i) {
    m = test_model(
        "bodies:\n"
        "- {name: a1, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
        " joint: {type: universal, point: [0, 0, 0], axis: [1, 0, 0], axis2: [0, 0, 1]}}\n"
        "- {name: a2, parent: a1, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
        " joint: {type: cylindrical, point: [0, 0.5, 0], axis: [0, 1, 0.2]}}\n"
        "- {name: b1, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
        " joint: {type: spherical, point: [1, 0, 0]}}\n"
        "- {name: b2, parent: b1, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
        " joint: {type: spherical, point: [0.8, 0.5, 0.2]}}\n"
        "loops: [%s]\n"
        "sensors:\n"
        "- {name: a, type: position, body: a2, point: [0.5, 1, 0.2]}\n"
        "- {name: b, type: position, body: b2, point: [0.6, 0.9, 0.4]}\n"
        "- {name: ua, type: position, body: a2, point: [1.5, 3, 0.2]}\n"
        "- {name: ub, type: position, body: b2, point: [1.6, 2.9, 0.9]}\n",
        loops[i]);
    d = test_start(m);
    maggi_get_sensors(d, s);
    for (k = 0; k < 3; ++k) {
      e[k] = s[k] - s[3 + k];
      u[k] = s[6 + k] - s[k];
      w[k] = s[9 + k] - s[3 + k];
    }
    if (i < 2) /* points coincide */
      CHECK_NEAR(norm3(e), 0.0, 0.0, 5e-15);
    cross3(u, w, c);
    if (i > 0) /* axes are parallel, and as unit vectors equal */
      CHECK_NEAR(norm3(c), 0.0, 0.0, 5e-14);
    if (i == 1) CHECK(dot3(u, w) > 0.0);
    cross3(e, w, c);
    if (i > 1) /* on one line */
      CHECK_NEAR(norm3(c), 0.0, 0.0, 5e-14);
    test_step(d, 1e-3, 50);
    test_free(d, m);
  }
}

/* a mechanism that runs into its end: a rod of 1 m pulled by a guide until it is straight and
 * beyond */
static void test_lockup(void)
{
  maggi_model *m = test_model(
      "gravity: [0, 0, 0]\n"
      "bodies:\n"
      "- {name: a, mass: 1, joint: {type: prismatic, axis: [1, 0, 0], motion: f}}\n"
      "- {name: b, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]}}\n"
      "functions: [{name: f, type: polynomial, coefficients: [0, 1]}]\n"
      "rods: [{name: tie, body_a: a, body_b: b, point_a: [1, 0, 0], point_b: [0, 1, 0]}]\n");
  maggi_data *d = test_start(m);
  maggi_status status = MAGGI_OK;
  double limit = sqrt(2.0), time = 0.0; /* a's end at 1 + t, at most 1 + sqrt 2 from b's pivot */

  while (status == MAGGI_OK && time < 3.0) {
    time = maggi_get_time(d);
    status = maggi_step(d, 1e-3);
  }
  CHECK(status == MAGGI_E_LOCKUP);
  CHECK(strncmp(maggi_data_message(d), "t = 1.41", 8) == 0);
  CHECK(strstr(maggi_data_message(d), "the mechanism locks up") != NULL &&
        strstr(maggi_data_message(d), ": rod \"tie\"") != NULL);
  CHECK_NEAR(time, limit, 0.0, 2e-3);
  CHECK(maggi_step(d, 1e-3) == MAGGI_E_MODEL);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  test_step(d, 1e-3, 100);
  test_free(d, m);
}

int main(void)
{
  test_close();
  test_position_and_velocity();
  test_far();
  test_set_given();
  test_impossible();
  test_velocities();
  test_space();
  test_lockup();
  return check_done();
}
