/* core/kernel/control.c: controllers of speed against motions in closed form, and what a file may say. */
#include "data.h"
#include "fixture.h"

/* 2 kg on a slide along x that drives itself */
static maggi_model *slide(const char *law, double velocity, const char *more)
{
  return test_model("gravity: [0, 0, 0]\n"
                    "bodies: [{name: b, mass: 2, joint: {type: prismatic, axis: [1, 0, 0], "
                    "velocity: %g}}]\n"
                    "functions: [{name: twice, type: constant, value: 2}]\n"
                    "forces: [{name: f, type: %s, body: b, point: [0, 0, 0], coordinates: [b], "
                    "speed: 5, gain: 0.5, torque: 3, low_speed: 1.0e-6%s}]\n",
                    velocity, law, more);
}

static double speed_after(const char *law, double velocity, const char *more, double time)
{
  maggi_model *m = slide(law, velocity, more);
  maggi_data *d = test_start(m);
  double v;

  test_step(d, 1e-3, (int)(1000.0 * time + 0.5));
  v = test_get(d).v[0];
  test_free(d, m);
  return v;
}

/* e' = -k e |e| and e' = -k e, k = gain torque / mass = 0.75, from below and from above */
static void test_laws(void)
{
  double k = 0.75, t = 0.8;

  CHECK_NEAR(speed_after("speed_controller", 2.0, "", t), 5.0 - 3.0 / (1.0 + 3.0 * k * t), 1e-9,
             0.0);
  CHECK_NEAR(speed_after("speed_controller", 9.0, "", t), 5.0 + 4.0 / (1.0 + 4.0 * k * t), 1e-9,
             0.0);
  CHECK_NEAR(speed_after("speed_controller", 2.0, ", function: twice", t),
             10.0 - 8.0 / (1.0 + 8.0 * k * t), 1e-9, 0.0);
  CHECK_NEAR(speed_after("speed_controller_linear", 2.0, "", t), 5.0 - 3.0 * exp(-k * t), 1e-9,
             0.0);
  CHECK_NEAR(speed_after("speed_controller_linear", 9.0, "", t), 5.0 + 4.0 * exp(-k * t), 1e-9,
             0.0);
  CHECK_NEAR(speed_after("speed_controller", 5.0, "", t), 5.0, 1e-12, 0.0);
}

/* the speed of a point, low_speed as at rest; the same torque on each of several coordinates */
static void test_two(void)
{
  maggi_model *m =
      test_model("gravity: [0, 0, 0]\n"
                 "bodies:\n"
                 "- {name: a, mass: 1, inertia: {xx: 2, yy: 2, zz: 2}, joint: {type: revolute, "
                 "point: [0, 0, 0], axis: [0, 0, 1], velocity: 1.5}}\n"
                 "- {name: b, mass: 1, inertia: {xx: 4, yy: 4, zz: 4}, joint: {type: revolute, "
                 "point: [0, 0, 0], axis: [0, 0, 1]}}\n"
                 "- {name: c, mass: 1, inertia: {xx: 8, yy: 8, zz: 8}, joint: {type: revolute, "
                 "point: [0, 0, 0], axis: [0, 0, 1]}}\n"
                 "forces: [{name: f, type: speed_controller, body: a, point: [0, 4, 3], "
                 "coordinates: [b, c], speed: 8, gain: 3, torque: 0.1, low_speed: 2.5}]\n");
  maggi_data *d = test_start(m);
  test_state s = test_get(d);
  double e = 8.0 - hypot(4.0 * 1.5, 2.5), power;

  CHECK_NEAR(s.a[0], 0.0, 0.0, 1e-15);
  CHECK_NEAR(s.a[1], 0.3 * e * e / 4.0, 1e-14, 0.0);
  CHECK_NEAR(s.a[2], 0.3 * e * e / 8.0, 1e-14, 0.0);
  CHECK_NEAR(d->speed[0][0], e, 1e-14, 0.0);
  s.v[1] = 2.0;
  s.v[2] = -3.0;
  power = 0.3 * e * e * (2.0 - 3.0);
  CHECK(maggi_data_set_state(d, 0.0, s.q, s.v) == MAGGI_OK);
  CHECK_NEAR(d->power[0], power, 1e-14, 0.0);
  d->t.speedheld[0] = 1;
  CHECK(maggi_data_set_state(d, 0.0, s.q, s.v) == MAGGI_OK);
  CHECK_NEAR(test_get(d).a[1], 0.0, 0.0, 0.0);
  CHECK_NEAR(d->power[0], 0.0, 0.0, 0.0);
  d->t.speedheld[0] = 0;
  test_free(d, m);
}

int main(void)
{
  test_laws();
  test_two();
  return check_done();
}
