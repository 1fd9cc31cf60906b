/* core/kernel/sensor.c, core/model/compile_sensors.c: what sensors show.  (Points and their rates along
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

/* the centre of gravity follows the parameters of the body, and point masses do not count */
static void test_cog(void)
{
  maggi_model *m =
      test_model("bodies:\n"
                 "- {name: block, mass: 1, cog: [1, 2, 3], inertia: {xx: 1, yy: 1, zz: 1},"
                 " joint: {type: revolute, point: [1, 2, 0], axis: [1, 0, 0], velocity: 2},"
                 " point_masses: [{name: p, mass: 9, point: [7, 7, 7]}]}\n"
                 "- {name: bar, mass: 1, bar: {from: [0, 0, 0], to: [0, 4, 6]},"
                 " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0]}}\n"
                 "- {name: hollow, parent: bar, joint: {type: fixed}}\n"
                 "sensors:\n"
                 "- {name: a, type: position, body: block}\n"
                 "- {name: b, type: velocity, body: block}\n"
                 "- {name: c, type: acceleration, body: block}\n"
                 "- {name: d, type: position, body: bar}\n"
                 "- {name: e, type: position, body: hollow}\n"
                 "- {name: f, type: position, body: bar, point: [0, 0, 0]}\n");
  maggi_data *d = test_start(m);
  double s[18];

  CHECK(maggi_parameter_find(m, "sensors.a.point.x") < 0);
  CHECK(maggi_parameter_find(m, "sensors.f.point.x") >= 0);
  maggi_get_sensors(d, s);
  CHECK(s[0] == 1.0 && s[1] == 2.0 && s[2] == 3.0);
  CHECK_NEAR(s[4], -6.0, 1e-15, 0.0);
  CHECK_NEAR(s[8], -12.0, 1e-14, 0.0);
  CHECK(s[9] == 0.0 && s[10] == 2.0 && s[11] == 3.0);
  CHECK(s[12] == 0.0 && s[13] == 0.0 && s[14] == 0.0);
  maggi_data_set_parameter(d, maggi_parameter_find(m, "bodies.block.cog.z"), 5.0);
  maggi_data_set_parameter(d, maggi_parameter_find(m, "bodies.bar.bar.to.y"), 8.0);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  maggi_get_sensors(d, s);
  CHECK(s[2] == 5.0 && s[10] == 4.0 && s[11] == 3.0);
  CHECK_NEAR(s[4], -10.0, 1e-15, 0.0);
  test_free(d, m);
}

/* rates of a free body's coordinates 4 to 6 are those of yaw, pitch and roll; its angular velocity is
 * the sum of their turns, each about the axis that it has */
static void test_rates(void)
{
  static const char *const column[] = {"r.roll_rate", "r.pitch_rate", "r.yaw_rate",
                                       "w.x",         "w.y",          "w.z"};
  maggi_model *m = test_model("bodies: [{name: b, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
                              " joint: {type: free, point: [1, 2, 3]}}]\n"
                              "sensors:\n"
                              "- {name: r, type: angle_rates, body: b}\n"
                              "- {name: w, type: angular_velocity, body: b}\n");
  maggi_data *d = test_start(m);
  double q[6] = {0}, v[6] = {0}, s[6], limit;
  unsigned long long seed = 5;
  int i, k;

  for (i = 0; i < 6; ++i) CHECK_TEXT(maggi_sensor_column_name(m, i), column[i]);
  for (i = 0; i < 6; ++i) CHECK_TEXT(maggi_sensor_column_unit(m, i), "rad/s");
  for (i = 0; i < 200; ++i) {
    for (k = 3; k < 6; ++k) {
      q[k] = 3.0 * random11(&seed);
      v[k] = random11(&seed);
    }
    q[4] *= 0.5;
    CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
    maggi_get_sensors(d, s);
    limit = 4e-15 / (cos(q[4]) * cos(q[4]));
    CHECK_NEAR(s[0], v[5], 0.0, limit);
    CHECK_NEAR(s[1], v[4], 0.0, limit);
    CHECK_NEAR(s[2], v[3], 0.0, limit);
    CHECK_NEAR(s[3], -sin(q[3]) * v[4] + cos(q[3]) * cos(q[4]) * v[5], 0.0, 2e-15);
    CHECK_NEAR(s[4], cos(q[3]) * v[4] + sin(q[3]) * cos(q[4]) * v[5], 0.0, 2e-15);
    CHECK_NEAR(s[5], v[3] - sin(q[4]) * v[5], 0.0, 2e-15);
  }
  test_free(d, m);
}

/* a torque of 6 N m on 2 kg m^2 about a tilted axis; gravity does not show */
static void test_angular_acceleration(void)
{
  maggi_model *m = test_model("bodies: [{name: b, mass: 1, inertia: {xx: 2, yy: 2, zz: 2},"
                              " joint: {type: revolute, point: [0, 0, 0], axis: [0, 3, 4]}}]\n"
                              "forces: [{name: f, type: joint, coordinate: b, effort: 6}]\n"
                              "sensors:\n"
                              "- {name: a, type: angular_acceleration, body: b}\n"
                              "- {name: g, type: angular_acceleration, body: ground}\n");
  maggi_data *d = test_start(m);
  static const double expected[6] = {0.0, 1.8, 2.4, 0.0, 0.0, 0.0};
  double s[6];
  int i;

  CHECK_TEXT(maggi_sensor_column_name(m, 0), "a.x");
  CHECK_TEXT(maggi_sensor_column_unit(m, 0), "rad/s^2");
  maggi_get_sensors(d, s);
  for (i = 0; i < 6; ++i) CHECK_NEAR(s[i], expected[i], 1e-15, 1e-15);
  test_free(d, m);
}

/* two sliders; every zone of the four slopes; a spring between two coordinates */
static void test_springs(void)
{
  static const char *const column[] = {"e1.length", "e1.rate",  "e1.force", "e2.length",
                                       "e2.rate",   "e2.force", "e3.value", "e3.rate",
                                       "e3.torque", "e4.value", "e4.rate",  "e4.torque"};
  static const char *const unit[] = {"m", "m/s", "N", "m",   "m/s",   "N",
                                     "m", "m/s", "N", "rad", "rad/s", "N m"};
  maggi_model *m =
      test_model("gravity: [0, 0, 0]\n"
                 "bodies:\n"
                 "- {name: x, mass: 1, joint: {type: prismatic, axis: [1, 0, 0]}}\n"
                 "- {name: y, parent: x, mass: 1, joint: {type: prismatic, axis: [1, 0, 0]}}\n"
                 "- {name: t, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
                 " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0]}}\n"
                 "springs:\n"
                 "- {name: other, body_a: x, body_b: y, point_a: [0, 1, 0], point_b: [0, 2, 0]}\n"
                 "- {name: s, body_a: ground, body_b: x, point_a: [0, 0, 0], point_b: [2, 0, 0], "
                 "stiffness: 10,"
                 " free_length: 1.5, damping: 1,"
                 " slopes: {c1: 2, c2: 3, c3: 4, c4: 5, v11: 1, v22: -2}}\n"
                 "- {name: p, body_a: ground, body_b: x, point_a: [0, 0, 0], point_b: [2, 0, 0], "
                 "stiffness: 10,"
                 " preload: 7}\n"
                 "joint_springs:\n"
                 "- {name: l, coordinate: x, coordinate2: y, stiffness: 3, damping: 2, rest: 0.25, "
                 "preload: 1}\n"
                 "- {name: k, coordinate: t, stiffness: 3, damping: 2}\n"
                 "sensors:\n"
                 "- {name: e1, type: spring, element: s}\n"
                 "- {name: e2, type: spring, element: p}\n"
                 "- {name: e3, type: joint_spring, element: l}\n"
                 "- {name: e4, type: joint_spring, element: k}\n");
  maggi_data *d = test_start(m);
  static const double rate[4] = {3, 0.5, -1, -3}, slope[4] = {8, 1, -4, -13};
  double q[3] = {1, 0.5, 0.2}, v[3] = {0, 0.5, -1}, s[12];
  int i;

  for (i = 0; i < 12; ++i) CHECK_TEXT(maggi_sensor_column_name(m, i), column[i]);
  for (i = 0; i < 12; ++i) CHECK_TEXT(maggi_sensor_column_unit(m, i), unit[i]);
  for (i = 0; i < 4; ++i) {
    v[0] = rate[i];
    CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
    maggi_get_sensors(d, s);
    CHECK_NEAR(s[0], 3.0, 1e-15, 0.0);
    CHECK_NEAR(s[1], rate[i], 1e-15, 0.0);
    CHECK_NEAR(s[2], 15.0 + rate[i] + slope[i], 1e-15, 0.0);
    CHECK_NEAR(s[5], 17.0, 1e-15, 0.0);
    CHECK_NEAR(s[6], 0.5, 1e-15, 0.0);
    CHECK_NEAR(s[7], rate[i] - 0.5, 1e-15, 0.0);
    CHECK_NEAR(s[8], -3.0 * 0.25 - 2.0 * (rate[i] - 0.5) - 1.0, 1e-15, 0.0);
    CHECK_NEAR(s[9], 0.2, 1e-15, 0.0);
    CHECK_NEAR(s[11], -0.6 + 2.0, 1e-15, 0.0);
  }
  test_free(d, m);
}

/* weights on slides hang at rods; there is a loop too, and the sensors come in another order */
static void test_rods(void)
{
  maggi_model *m = test_model(
      "bodies:\n"
      "- {name: a, mass: 2, joint: {type: prismatic, axis: [0, 0, 1]}}\n"
      "- {name: b, mass: 3, joint: {type: prismatic, axis: [0, 0, 1]}}\n"
      "- {name: c, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: free, point: [9, 0, 0]}}\n"
      "loops: [{name: l, type: revolute, body_a: c, body_b: ground, point: [9, 0, 0],"
      " axis: [0, 0, 1]}]\n"
      "rods:\n"
      "- {name: one, body_a: a, body_b: ground, point_a: [0, 0, 0], point_b: [0, 0, 4]}\n"
      "- {name: two, body_a: b, body_b: ground, point_a: [1, 0, 0], point_b: [1, 0, 5]}\n"
      "sensors:\n"
      "- {name: s, type: rod, element: two}\n"
      "- {name: r, type: rod, element: one}\n");
  maggi_data *d = test_start(m);
  double s[6];

  CHECK_TEXT(maggi_sensor_column_name(m, 0), "s.length");
  CHECK_TEXT(maggi_sensor_column_name(m, 1), "s.rate");
  CHECK_TEXT(maggi_sensor_column_name(m, 2), "s.force");
  CHECK_TEXT(maggi_sensor_column_unit(m, 2), "N");
  maggi_get_sensors(d, s);
  CHECK_NEAR(s[0], 5.0, 1e-15, 0.0);
  CHECK_NEAR(s[1], 0.0, 0.0, 1e-15);
  CHECK_NEAR(s[2], 3.0 * 9.81, 1e-14, 0.0);
  CHECK_NEAR(s[3], 4.0, 1e-15, 0.0);
  CHECK_NEAR(s[5], 2.0 * 9.81, 1e-14, 0.0);
  test_free(d, m);
}

int main(void)
{
  test_cog();
  test_rates();
  test_angular_acceleration();
  test_springs();
  test_rods();
  test_angles();
  test_gimbal();
  test_points();
  test_base();
  return check_done();
}
