/* core/kernel/energy.c: each kind of energy for itself, and their sum along a motion with
 * everything that does work. */
#include "fixture.h"

static maggi_energy energy(maggi_data *d)
{
  maggi_energy e;

  maggi_get_energy(d, &e);
  return e;
}

static void set(maggi_data *d, const double *q, const double *v)
{
  CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
}

/* T = m v^2/2 + J w^2/2, V = - m g . r from the global origin, far from which the model stands */
static void test_body(void)
{
  maggi_model *m =
      test_model("gravity: [1, -2, -9]\n"
                 "bodies:\n"
                 "- {name: b, mass: 2, cog: [100, 51, 20], inertia: {xx: 0.3, yy: 0.4, zz: 0.5},"
                 " joint: {type: free, point: [100, 50, 20]}}\n");
  maggi_data *d = test_start(m);
  double q[6] = {0.5, -1, 2, 0, 0, 0}, v[6] = {1, 2, 3, 0, 0, 0};

  CHECK_NEAR(energy(d).potential, -2.0 * (1.0 * 100 - 2.0 * 51 - 9.0 * 20), 1e-15, 0.0);
  CHECK_NEAR(energy(d).kinetic, 0.0, 0.0, 0.0);
  set(d, q, v);
  CHECK_NEAR(energy(d).potential, -2.0 * (1.0 * 102 - 2.0 * 50 - 9.0 * 20.5), 1e-14, 0.0);
  CHECK_NEAR(energy(d).kinetic, 14.0, 1e-15, 0.0);
  v[0] = v[1] = v[2] = 0.0;
  v[5] = 0.7; /* about x, the centre of gravity 1 m off */
  set(d, q, v);
  CHECK_NEAR(energy(d).kinetic, 0.5 * (0.3 + 2.0) * 0.49, 1e-14, 0.0);
  test_free(d, m);
}

/* a rod's T = m/6 (va^2 + va.vb + vb^2) and half its weight at each end; point masses at two
 * sliders and the rod between them is inclined */
static void test_rod(void)
{
  maggi_model *m =
      test_model("gravity: [0, 0, -10]\n"
                 "bodies:\n"
                 "- {name: a, mass: 1, joint: {type: prismatic, axis: [1, 0, 0], velocity: 2}}\n"
                 "- {name: b, mass: 1, joint: {type: prismatic, axis: [0, 0, 1]}}\n"
                 "rods: [{name: r, body_a: a, body_b: b, point_a: [3, 0, 0], point_b: [0, 0, 4],"
                 " mass: 0.9}]\n");
  maggi_data *d = test_start(m);

  /* 3*2 + 4*vb = 0 */
  CHECK_NEAR(test_get(d).v[1], -1.5, 1e-15, 0.0);
  CHECK_NEAR(energy(d).kinetic, 0.5 * (4.0 + 2.25) + 0.9 / 6.0 * (4.0 + 0.0 + 2.25), 1e-14, 0.0);
  CHECK_NEAR(energy(d).potential, 0.9 * 10.0 * 2.0, 1e-14, 0.0);
  test_free(d, m);
}

/* k (l - l0)^2/2; with a preload F0 also F0 (l - l_file), zero as drawn; torsion likewise */
static void test_springs(void)
{
  maggi_model *m =
      test_model("gravity: [0, 0, 0]\n"
                 "bodies:\n"
                 "- {name: a, mass: 1, joint: {type: prismatic, axis: [1, 0, 0]}}\n"
                 "- {name: b, mass: 1, joint: {type: prismatic, axis: [1, 0, 0]}}\n"
                 "springs:\n"
                 "- {name: s, body_a: a, body_b: ground, point_a: [2, 0, 0], point_b: [0, 1, 0],"
                 " stiffness: 30, free_length: 1.7}\n"
                 "- {name: p, body_a: b, body_b: ground, point_a: [2, 0, 0], point_b: [0, 1, 0],"
                 " stiffness: 20, preload: 5}\n"
                 "joint_springs:\n"
                 "- {name: j, coordinate: a, coordinate2: b, stiffness: 7, rest: 0.1, preload: 3}\n"
                 "- {name: k, coordinate: b, stiffness: 11, rest: -0.2}\n");
  maggi_data *d = test_start(m);
  double q[2] = {0.4, -0.3}, v[2] = {0}, l = sqrt(5.0), la = sqrt(1.0 + 2.4 * 2.4);
  double lb = sqrt(1.0 + 1.7 * 1.7);

  CHECK_NEAR(energy(d).potential, 15.0 * pow(l - 1.7, 2) + 0.5 * 7.0 * 0.01 + 0.5 * 11.0 * 0.04,
             1e-14, 0.0);
  set(d, q, v);
  CHECK_NEAR(energy(d).potential,
             15.0 * pow(la - 1.7, 2) + 10.0 * pow(lb - l, 2) + 5.0 * (lb - l) +
                 3.5 * pow(0.7 - 0.1, 2) + 3.0 * 0.7 + 5.5 * pow(-0.3 + 0.2, 2),
             1e-14, 0.0);
  test_free(d, m);
}

/* constant force on a slider: work = force times way; damper on a coasting slider: all of T */
static void test_work(void)
{
  maggi_model *m =
      test_model("gravity: [0, 0, 0]\n"
                 "bodies:\n"
                 "- {name: a, mass: 2, joint: {type: prismatic, axis: [1, 0, 0]}}\n"
                 "- {name: b, mass: 2, joint: {type: prismatic, axis: [1, 0, 0], velocity: 3}}\n"
                 "- {name: c, mass: 2, joint: {type: prismatic, axis: [1, 0, 0], motion: x}}\n"
                 "joint_springs: [{name: damper, coordinate: b, damping: 40}]\n"
                 "functions: [{name: x, type: polynomial, coefficients: [0, 0, 0.5]}]\n"
                 "forces:\n"
                 "- {name: f, type: force, body: a, point: [0, 0, 0], value: [6, 1, 1]}\n");
  maggi_data *d = test_start(m);
  maggi_energy e;

  test_step(d, 1e-3, 2000);
  e = energy(d);
  /* a: 6 N over 3/2 t^2 = 6 m;  b: -9 J;  c: from rest to 2 m/s, 4 J */
  CHECK_NEAR(test_get(d).q[0], 6.0, 1e-12, 0.0); /* round-off of 2000 steps */
  CHECK_NEAR(e.work, 36.0 - 9.0 + 4.0, 1e-6, 0.0);
  CHECK_NEAR(e.kinetic, 36.0 + 4.0, 1e-6, 0.0);
  test_free(d, m);
}

/* a spatial mechanism with a loop, rods, springs, dampers, loads of all kinds and a guide: the
 * balance is off by h^4, so that half the step leaves 1/16 */
static double balance(const maggi_model *m, double h, double *scale)
{
  maggi_data *d = test_start(m);
  double e0 = test_energy(d), off;

  test_step(d, h, (int)(2.0 / h + 0.5));
  off = test_energy(d) - e0;
  *scale = fabs(energy(d).work);
  maggi_data_free(d);
  return off;
}

static void test_balance(void)
{
  maggi_model *m = test_model(
      "gravity: [0.2, -0.5, -9.81]\n"
      "bodies:\n"
      "- {name: crank, mass: 1, cog: [0, 0.1, 0.2], inertia: {xx: 0.1, yy: 0.1, zz: 0.1},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0], velocity: 4}}\n"
      "- {name: coupler, parent: crank, mass: 0.8, cog: [0.5, 0.5, 0.5], inertia: {xx: 0.2, yy: "
      "0.2,"
      " zz: 0.2},"
      " joint: {type: universal, point: [0, 0, 0.4], axis: [1, 0, 0], axis2: [0, 1, 0]}}\n"
      "- {name: rocker, mass: 1.2, bar: {from: [1, 1, -0.5], to: [1, 1, 0.6]},"
      " joint: {type: revolute, point: [1, 1, -0.5], axis: [0, 1, 0.2]}}\n"
      "- {name: flap, parent: rocker, mass: 0.5, cog: [1, 1.5, 0], inertia: {xx: 0.1, yy: 0.1,"
      " zz: 0.1}, joint: {type: cylindrical, point: [1, 1.2, 0], axis: [1, 0, 1]}}\n"
      "- {name: drum, mass: 2, cog: [2, 0, 0.1], inertia: {xx: 0.2, yy: 0.2, zz: 0.2},"
      " joint: {type: revolute, point: [2, 0, 0], axis: [0, 1, 0], motion: turn}}\n"
      "loops: [{name: l, type: spherical, body_a: coupler, body_b: rocker, point: [1, 1, 0.6]}]\n"
      "rods: [{name: r, body_a: flap, body_b: drum, point_a: [1, 1.5, 0.2], point_b: [2, 0.3, 0.2],"
      " mass: 0.6}]\n"
      "springs:\n"
      "- {name: s, body_a: crank, body_b: rocker, point_a: [0, 0, 0.4], point_b: [1, 1, 0],"
      " stiffness: 30, preload: 2, damping: 3}\n"
      "- {name: u, body_a: flap, body_b: ground, point_a: [1, 1.5, 0], point_b: [1, 3, 0],"
      " stiffness: 30, free_length: 1.2, slopes: {c1: 3, c2: 3, c3: 3, c4: 3, v11: 1, v22: -1}}\n"
      "joint_springs:\n"
      "- {name: j, coordinate: crank, coordinate2: rocker, stiffness: 2, damping: 0.3, rest: 0.1}\n"
      "- {name: k, coordinate: flap.1, stiffness: 20, damping: 0.5}\n"
      "functions:\n"
      "- {name: turn, type: sine, amplitude: 0.4, omega: 2}\n"
      "- {name: f, type: sine, amplitude: 1, omega: 5, offset: 0.3}\n"
      "forces:\n"
      "- {name: f1, type: force, body: flap, point: [1, 1.5, 0.3], value: [1, 2, 3], function: f}\n"
      "- {name: f2, type: force_body, body: coupler, reaction: flap, point: [1, 1, 0.6],"
      " value: [1, 2, 3]}\n"
      "- {name: f3, type: torque, body: rocker, value: [0.1, 0.5, 0], function: f}\n"
      "- {name: f4, type: torque_body, body: crank, reaction: flap, value: [0.5, 0, 1]}\n"
      "- {name: f5, type: joint, coordinate: flap.2, effort: 0.7, function: f}\n"
      "- {name: f6, type: drag, body: flap, point: [1, 1.5, 0.3], density: 1.2, coefficient: 0.8,"
      " area: 0.5, low_speed: 0.5, wind: [1, 2, -1], function: f}\n"
      "- {name: f7, type: drag, body: rocker, reaction: crank, point: [1, 1, 0.6], density: 1.2,"
      " coefficient: 1, area: 0.5, low_speed: 1}\n"
      "- {name: f8, type: speed_controller, body: flap, point: [1, 1.5, 0.3], coordinates: [crank,"
      " flap.2], speed: 4, gain: 0.1, torque: 2, low_speed: 0.5, function: f}\n"
      "- {name: f9, type: speed_controller_linear, body: rocker, point: [1, 1, 0.6],"
      " coordinates: [rocker], speed: 2, gain: 0.5, torque: 2, low_speed: 0.5}\n");
  double scale, off1 = balance(m, 4e-3, &scale), off2 = balance(m, 2e-3, &scale);
  double off3 = balance(m, 1e-3, &scale);

  CHECK(scale > 1.0);
  CHECK(fabs(off1) > 1e-11);
  CHECK_NEAR(off1 / off2, 16.0, 0.3, 0.0);
  CHECK_NEAR(off3, 0.0, 0.0, 1e-6);
  maggi_model_free(m);
}

int main(void)
{
  test_body();
  test_rod();
  test_springs();
  test_work();
  test_balance();
  return check_done();
}
