/* core/kernel/sensor.c, core/dynamics/output.c: what sensors show.  (Points and their rates along
 * all kinds of joints: test_position.c.) */
#include "fixture.h"

/* a free body's coordinates 4 to 6 are yaw, pitch and roll, in their ranges */
static void test_angles(void)
{
  maggi_model *m = test_model("bodies: [{name: b, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
                              " joint: {type: free, point: [1, 2, 3]}}]\n"
                              "sensors: [{name: s, type: angles, body: b}]\n");
  maggi_data *d = test_start(m);
  double q[6] = {0}, v[6] = {0}, s[3], pi = acos(-1.0);
  unsigned long long seed = 3;
  int i;

  CHECK_TEXT(maggi_sensor_column_name(m, 0), "s.roll");
  CHECK_TEXT(maggi_sensor_column_name(m, 1), "s.pitch");
  CHECK_TEXT(maggi_sensor_column_name(m, 2), "s.yaw");
  CHECK_TEXT(maggi_sensor_column_unit(m, 2), "rad");
  maggi_get_sensors(d, s);
  CHECK(s[0] == 0.0 && s[1] == 0.0 && s[2] == 0.0);
  for (i = 0; i < 200; ++i) {
    q[3] = pi * random11(&seed);
    q[4] = 0.499 * pi * random11(&seed);
    q[5] = pi * random11(&seed);
    CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
    maggi_get_sensors(d, s);
    /* near a pitch of a quarter roll and yaw are hard to tell apart: 1e-15 / cos(pitch) */
    CHECK_NEAR(s[0], q[5], 0.0, 2e-15 / cos(q[4]));
    CHECK_NEAR(s[1], q[4], 0.0, 2e-15);
    CHECK_NEAR(s[2], q[3], 0.0, 2e-15 / cos(q[4]));
  }
  /* beyond a turn the angle is the one in the range */
  q[3] = 2.0 * pi + 0.5;
  q[4] = q[5] = 0.0;
  CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
  maggi_get_sensors(d, s);
  CHECK_NEAR(s[2], 0.5, 1e-14, 0.0);
  test_free(d, m);
}

/* exactly at the quarter the angles stay numbers, and their rotation is that of the body */
static void test_gimbal(void)
{
  maggi_model *m = test_model("bodies: [{name: b, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
                              " joint: {type: revolute, point: [0, 0, 0], axis: [0, 1, 0]}}]\n"
                              "sensors: [{name: s, type: angles, body: b}]\n");
  maggi_data *d = test_start(m);
  double q = acos(0.0), v = 0.0, s[3];

  CHECK(maggi_data_set_state(d, 0.0, &q, &v) == MAGGI_OK);
  maggi_get_sensors(d, s);
  CHECK_NEAR(s[1], q, 1e-15, 0.0);
  CHECK(isfinite(s[0]) && isfinite(s[2]));
  test_free(d, m);
}

/* an accelerometer here is a motion sensor: 0 at rest, gravity in free fall, w^2 r inwards; places
 * are in the global frame although the dynamics rides with the base */
static void test_points(void)
{
  maggi_model *m = test_model(
      "gravity: [1, 2, -9]\n"
      "bodies:\n"
      "- {name: fixed, mass: 1, joint: {type: fixed}}\n"
      "- {name: falling, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: free, point: [10, 0, 0], velocities: [3, 2, 1, null, null, null]}}\n"
      "- {name: wheel, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1], velocity: 3}}\n"
      "sensors:\n"
      "- {name: a1, type: acceleration, body: fixed, point: [1, 1, 1]}\n"
      "- {name: a2, type: acceleration, body: falling, point: [10, 0, 0]}\n"
      "- {name: a3, type: acceleration, body: wheel, point: [2, 0, 5]}\n"
      "- {name: v3, type: velocity, body: wheel, point: [2, 0, 5]}\n"
      "- {name: r2, type: position, body: falling, point: [10, 1, 2]}\n"
      "- {name: v2, type: velocity, body: falling, point: [10, 1, 2]}\n"
      "- {name: ground, type: position, body: ground, point: [4, 5, 6]}\n");
  maggi_data *d = test_start(m);
  static const double expected[21] = {0, 0,  0, 1, 2, -9, -18, 0, 0, 0, 6,
                                      0, 10, 1, 2, 1, 2,  3,   4, 5, 6};
  double s[21];
  int i;

  maggi_get_sensors(d, s);
  /* the falling body is 10 m from P: its inertia there is 100 times its own, and so is round-off */
  for (i = 0; i < 21; ++i) CHECK_NEAR(s[i], expected[i], i >= 3 && i < 6 ? 1e-13 : 4e-15, 1e-15);
  test_step(d, 0.01, 100);
  maggi_get_sensors(d, s);
  CHECK_NEAR(s[12], 10.0 + 1.0 + 0.5, 1e-14, 0.0);
  CHECK_NEAR(s[13], 1.0 + 2.0 + 1.0, 1e-14, 0.0);
  CHECK_NEAR(s[14], 2.0 + 3.0 - 4.5, 1e-13, 0.0);
  CHECK_NEAR(s[15], 2.0, 1e-13, 0.0);
  test_free(d, m);
}

/* a model whose base slides: the reference rides with it, the sensors do not show that */
static void test_base(void)
{
  maggi_model *m =
      test_model("gravity: [0, 0, -9.81]\n"
                 "bodies:\n"
                 "- {name: car, mass: 1, inertia: {xx: 1, yy: 1, zz: 1}, joint: {type: free,"
                 " point: [0, 0, 0], velocities: [null, null, 30, null, null, null]}}\n"
                 "- {name: wheel, parent: car, mass: 0.1, inertia: {xx: 0.1, yy: 0.1, zz: 0.1},"
                 " joint: {type: revolute, point: [1, 1, 0], axis: [0, 1, 0], velocity: 5}}\n"
                 "sensors:\n"
                 "- {name: r, type: position, body: wheel, point: [1, 1, 0]}\n"
                 "- {name: v, type: velocity, body: wheel, point: [1, 1, 0]}\n"
                 "- {name: g, type: position, body: ground, point: [1, 2, 3]}\n");
  maggi_data *d = test_start(m);
  double q[7] = {0, 0, 1e5, 0, 0, 0, 0}, v[7] = {0, 0, 30, 0, 0, 0, 5}, s[9];

  CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
  maggi_get_sensors(d, s);
  CHECK_NEAR(s[0], 100001.0, 1e-15, 0.0);
  CHECK_NEAR(s[1], 1.0, 1e-15, 0.0);
  CHECK_NEAR(s[3], 30.0, 1e-15, 0.0);
  CHECK_NEAR(s[6], 1.0, 0.0, 2e-11); /* round-off of 1e5 m */
  CHECK_NEAR(s[8], 3.0, 0.0, 0.0);
  test_free(d, m);
}

int main(void)
{
  test_angles();
  test_gimbal();
  test_points();
  test_base();
  return check_done();
}
