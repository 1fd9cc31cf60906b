/* core/kernel/reaction.c: joint reactions and multipliers, against statics and Newton's law. */
#include "fixture.h"

enum { BODIES = 8 };

static const double g = 9.81;

static void reactions(maggi_data *d, double w[BODIES][6])
{
  maggi_get_reactions(d, &w[0][0]);
}

static void check_wrench(const double w[6], double fx, double fy, double fz, double mx, double my,
                         double mz)
{
  double expected[6] = {fx, fy, fz, mx, my, mz};
  int k;

  for (k = 0; k < 6; ++k) CHECK_NEAR(w[k], expected[k], 1e-13, 1e-13);
}

/* three bars hang at rest: each joint carries what is below, without a moment */
static void test_hanging(void)
{
  maggi_model *m =
      test_model("bodies:\n"
                 "- {name: b1, mass: 1, bar: {from: [0, 0, 0], to: [0, 0, -1]},"
                 " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0]}}\n"
                 "- {name: b2, parent: b1, mass: 2, bar: {from: [0, 0, -1], to: [0, 0, -3]},"
                 " joint: {type: revolute, point: [0, 0, -1], axis: [0, 1, 0]}}\n"
                 "- {name: b3, parent: b2, mass: 4, bar: {from: [0, 0, -3], to: [0, 0, -3.5]},"
                 " joint: {type: spherical, point: [0, 0, -3]}, point_masses: [{name: p, mass: 0.5,"
                 " point: [0, 0, -3.5]}]}\n");
  maggi_data *d = test_data(m);
  double w[BODIES][6];

  /* a thin bar does not resist a turn about itself; the spherical joint here allows it */
  CHECK(maggi_data_reset(d) == MAGGI_E_MASS);
  test_free(d, m);
  m = test_model(
      "bodies:\n"
      "- {name: b1, mass: 1, bar: {from: [0, 0, 0], to: [0, 0, -1]},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0]}}\n"
      "- {name: b2, parent: b1, mass: 2, bar: {from: [0, 0, -1], to: [0, 0, -3]},"
      " joint: {type: revolute, point: [0, 0, -1], axis: [0, 1, 0]}}\n"
      "- {name: b3, parent: b2, mass: 4, cog: [0, 0, -3.25], inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: spherical, point: [0, 0, -3]}, point_masses: [{name: p, mass: 0.5,"
      " point: [0, 0, -3.5]}]}\n");
  d = test_start(m);
  reactions(d, w);
  check_wrench(w[0], 0, 0, 7.5 * g, 0, 0, 0);
  check_wrench(w[1], 0, 0, 6.5 * g, 0, 0, 0);
  check_wrench(w[2], 0, 0, 4.5 * g, 0, 0, 0);
  test_free(d, m);
}

/* a cantilever of two bars welded together, with a load at its end: shear and bending moments */
static void test_cantilever(void)
{
  maggi_model *m =
      test_model("bodies:\n"
                 "- {name: b1, mass: 2, bar: {from: [0, 0, 0], to: [3, 0, 0]},"
                 " joint: {type: fixed, point: [0, 0, 0]}}\n"
                 "- {name: b2, parent: b1, mass: 1, bar: {from: [3, 0, 0], to: [5, 0, 0]},"
                 " joint: {type: fixed, point: [3, 0, 0]}}\n"
                 "forces:\n"
                 "- {name: f, type: force, body: b2, point: [5, 0, 0], value: [0, 7, -10]}\n"
                 "- {name: t, type: torque, body: b2, value: [4, 0, 0]}\n");
  maggi_data *d = test_start(m);
  double w[BODIES][6];

  CHECK(test_loops(d).dof == 0);
  reactions(d, w);
  /* M = - sum r x F, r from the joint */
  check_wrench(w[1], 0, -7, g + 10, -4, -(1 * g + 2 * 10), -2 * 7);
  check_wrench(w[0], 0, -7, 3 * g + 10, -4, -(1.5 * 2 * g + 4 * g + 5 * 10), -5 * 7);
  test_free(d, m);
}

/* a beam hinged on the left, hung from a rod on the right: the rod pulls with half the weight and
 * the share of the load; tension is positive.  A rod with mass hangs half its weight at each end.
 * */
static void test_beam(double mass)
{
  maggi_model *m = test_model(
      "bodies:\n"
      "- {name: beam, mass: 6, bar: {from: [0, 0, 0], to: [4, 0, 0]},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 1, 0]}}\n"
      "rods: [{name: rod, body_a: beam, body_b: ground, point_a: [4, 0, 0], point_b: [4, 0, 2],"
      " mass: %.17g}]\n"
      "forces: [{name: f, type: force, body: beam, point: [1, 0, 0], value: [0, 0, -20]}]\n",
      mass);
  maggi_data *d = test_start(m);
  double w[BODIES][6], lambda;

  CHECK(test_loops(d).dof == 0);
  reactions(d, w);
  maggi_get_multipliers(d, &lambda);
  CHECK_NEAR(lambda, 3 * g + 5 + 0.5 * mass * g, 1e-14, 0.0);
  check_wrench(w[0], 0, 0, 3 * g + 15, 0, 0, 0);
  test_free(d, m);
}

/* a strut pushes: compression is negative */
static void test_strut(void)
{
  maggi_model *m = test_model("bodies:\n"
                              "- {name: beam, mass: 6, bar: {from: [0, 0, 0], to: [4, 0, 0]},"
                              " joint: {type: revolute, point: [0, 0, 0], axis: [0, 1, 0]}}\n"
                              "rods: [{name: rod, body_a: ground, body_b: beam, point_a: [1, 0, "
                              "-3], point_b: [4, 0, 0]}]\n");
  maggi_data *d = test_start(m);
  double w[BODIES][6], lambda;

  reactions(d, w);
  maggi_get_multipliers(d, &lambda);
  CHECK_NEAR(lambda, -3 * g * sqrt(2.0), 1e-14, 0.0);
  check_wrench(w[0], -3 * g, 0, 3 * g, 0, 0, 0);
  test_free(d, m);
}

/* a beam leans on a slope, which takes a force along its normal alone */
static void test_slope(void)
{
  maggi_model *m = test_model("bodies:\n"
                              "- {name: beam, mass: 6, bar: {from: [0, 0, 0], to: [4, 0, 0]},"
                              " joint: {type: revolute, point: [0, 0, 0], axis: [0, 1, 0]}}\n"
                              "loops: [{name: pad, type: point_plane, body_a: beam, body_b: ground,"
                              " point: [4, 0, 0], axis: [2, 0, 2]}]\n");
  maggi_data *d = test_start(m);
  double w[BODIES][6], lambda;

  reactions(d, w);
  maggi_get_multipliers(d, &lambda);
  CHECK_NEAR(lambda, -3 * g * sqrt(2.0), 1e-14, 0.0);
  check_wrench(w[0], -3 * g, 0, 3 * g, 0, 0, 0);
  test_free(d, m);
}

/* a table of three legs, welded to the ground by one and loosely standing on the others: the
 * forces of cut joints of each kind on what is welded; multipliers of points are forces on body_b
 * */
static void test_cuts(void)
{
  static const char *const cut[] = {
      "{name: l, type: spherical, body_a: arm, body_b: ground, point: [4, 0, 0]}",
      "{name: l, type: revolute, body_a: arm, body_b: ground, point: [4, 0, 0], axis: [0, 1, 0]}",
      "{name: l, type: universal, body_a: arm, body_b: ground, point: [4, 0, 0],"
      " axis_a: [0, 1, 0], axis_b: [0, 0, 1]}",
      "{name: l, type: cylindrical, body_a: arm, body_b: ground, point: [4, 0, 0],"
      " axis: [1, 0, 0]}",
      "{name: l, type: prismatic, body_a: arm, body_b: ground, point: [4, 0, 0],"
      " axis: [1, 0, 0]}",
  };
  maggi_model *m;
  maggi_data *d;
  double w[BODIES][6], lambda[6];
  int i;

  for (i = 0; i < 5; ++i) {
    m = test_model(
        "bodies:\n"
        "- {name: arm, mass: 6, bar: {from: [0, 0, 0], to: [4, 0, 0]},"
        " joint: {type: revolute, point: [0, 0, 0], axis: [0, 1, 0]}}\n"
        "forces: [{name: f, type: force, body: arm, point: [1, 0, 0], value: [0, 0, -20]}]\n"
        "loops: [%s]\n",
        cut[i]);
    d = test_start(m);
    CHECK(test_loops(d).dof == 0 && test_loops(d).rank == 1);
    reactions(d, w);
    maggi_get_multipliers(d, lambda);
    CHECK_NEAR(w[0][0], 0.0, 0.0, 1e-13);
    CHECK_NEAR(w[0][4], 0.0, 0.0, 1e-13);
    if (i <= 2 && i != 1) { /* only forces through the point: statics of a beam on two supports */
      check_wrench(w[0], 0, 0, 3 * g + 15, 0, 0, 0);
      CHECK_NEAR(lambda[2], -(3 * g + 5), 1e-14, 0.0);
    }
    test_free(d, m);
  }
}

/* ---------------------------------------------------------------------------------- in motion */

/* R-U-S-R four-bar in space, opened at the spherical joint, or at the universal one (then the
 * coupler hangs on the follower by the spherical joint), or at the follower's pivot: 3, 4 and 5
 * independent equations.  The same mechanism, so the same motion and the same forces in all
 * joints. */
#define CRANK                                                                                      \
  "- {name: crank, mass: 1, cog: [0, 0.1, 0.3], inertia: {xx: 0.1, yy: 0.1, zz: 0.1},"             \
  " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0], velocity: 3}}\n"
#define COUPLER  "mass: 0.8, cog: [0.5, 0.6, 0.5], inertia: {xx: 0.2, yy: 0.1, zz: 0.2}"
#define FOLLOWER "mass: 1.2, cog: [1, 1, 0.2], inertia: {xx: 0.2, yy: 0.2, zz: 0.1}"
static const char *const cuts[] = {
    "bodies:\n" CRANK "- {name: coupler, parent: crank, " COUPLER
    ", joint: {type: universal, point: [0, 0, 0.4], axis: [1, 0, 0], axis2: [0, 1, 0]}}\n"
    "- {name: follower, " FOLLOWER
    ", joint: {type: revolute, point: [1, 1, -0.5], axis: [0, 1, 0.2]}}\n"
    "loops: [{name: l, type: spherical, body_a: coupler, body_b: follower,"
    " point: [1, 1, 0.6]}]\n",
    "bodies:\n" CRANK "- {name: follower, " FOLLOWER
    ", joint: {type: revolute, point: [1, 1, -0.5], axis: [0, 1, 0.2]}}\n"
    "- {name: coupler, parent: follower, " COUPLER
    ", joint: {type: spherical, point: [1, 1, 0.6]}}\n"
    "loops: [{name: l, type: universal, body_a: crank, body_b: coupler, point: [0, 0, 0.4],"
    " axis_a: [1, 0, 0], axis_b: [0, 1, 0]}]\n",
    "bodies:\n" CRANK "- {name: coupler, parent: crank, " COUPLER
    ", joint: {type: universal, point: [0, 0, 0.4], axis: [1, 0, 0], axis2: [0, 1, 0]}}\n"
    "- {name: follower, parent: coupler, " FOLLOWER
    ", joint: {type: spherical, point: [1, 1, 0.6]}}\n"
    "loops: [{name: l, type: revolute, body_a: follower, body_b: ground, point: [1, 1, -0.5],"
    " axis: [0, 1, 0.2]}]\n",
};
static const char sensors[] =
    "sensors:\n"
    "- {name: a1, type: acceleration, body: crank, point: [0, 0.1, 0.3]}\n"
    "- {name: a2, type: acceleration, body: coupler, point: [0.5, 0.6, 0.5]}\n"
    "- {name: a3, type: acceleration, body: follower, point: [1, 1, 0.2]}\n";

static void test_four_bar(void)
{
  static const double mass[3] = {1.0, 0.8, 1.2};
  maggi_model *m[3];
  maggi_data *d[3];
  double w[3][BODIES][6], lambda[3][6], s[3][9], total;
  int i, k, n, crank, coupler, follower;

  for (i = 0; i < 3; ++i) {
    m[i] = test_model("%s%s", cuts[i], sensors);
    d[i] = test_start(m[i]);
    CHECK(maggi_data_set_tolerance(d[i], 1e-14) == MAGGI_OK);
    CHECK(test_loops(d[i]).dof == 1);
  }
  CHECK(test_loops(d[0]).rank == 3 && test_loops(d[1]).rank == 4 && test_loops(d[2]).rank == 5);
  for (n = 0; n < 10; ++n) {
    for (i = 0; i < 3; ++i) {
      reactions(d[i], w[i]);
      maggi_get_multipliers(d[i], lambda[i]);
      maggi_get_sensors(d[i], s[i]);
    }
    for (i = 1; i < 3; ++i)
      for (k = 0; k < 9; ++k) CHECK_NEAR(s[i][k], s[0][k], 1e-11, 1e-10);
    crank = maggi_body_find(m[0], "crank");
    coupler = maggi_body_find(m[0], "coupler");
    follower = maggi_body_find(m[0], "follower");
    /* crank pivot: force and moment from each of the three */
    for (i = 1; i < 3; ++i)
      for (k = 0; k < 6; ++k)
        CHECK_NEAR(w[i][maggi_body_find(m[i], "crank")][k], w[0][crank][k], 1e-10, 1e-9);
    /* follower pivot: a joint in two, what the loop exerts in the third; spherical joint: a loop in
     * the first, where the multiplier is the force on body_b, the follower; a joint in the others
     * */
    for (k = 0; k < 6; ++k)
      CHECK_NEAR(w[1][maggi_body_find(m[1], "follower")][k], w[0][follower][k], 1e-10, 1e-9);
    for (k = 0; k < 3; ++k) {
      CHECK_NEAR(lambda[2][k], -w[0][follower][k], 1e-10, 1e-9);
      CHECK_NEAR(w[2][maggi_body_find(m[2], "follower")][k], lambda[0][k], 1e-10, 1e-9);
      CHECK_NEAR(w[1][maggi_body_find(m[1], "coupler")][k], -lambda[0][k], 1e-10, 1e-9);
      CHECK_NEAR(lambda[1][k], w[0][coupler][k], 1e-10, 1e-9);
      /* Newton for all: the pivots carry sum of m (a - g) */
      total = w[0][crank][k] + w[0][follower][k];
      for (i = 0; i < 3; ++i) total -= mass[i] * (s[0][3 * i + k] + (k == 2 ? g : 0.0));
      CHECK_NEAR(total, 0.0, 0.0, 1e-10);
    }
    /* no drive and no friction: no moment about the axes */
    CHECK_NEAR(w[0][crank][3], 0.0, 0.0, 1e-11);
    CHECK_NEAR(w[0][follower][4] + 0.2 * w[0][follower][5], 0.0, 0.0, 1e-11);
    for (i = 0; i < 3; ++i) test_step(d[i], 1e-4, 200);
  }
  for (i = 0; i < 3; ++i) test_free(d[i], m[i]);
}

/* springs, drives and loads on a joint are part of what the parent exerts through it */
static void test_joint_efforts(void)
{
  maggi_model *m =
      test_model("gravity: [0, 0, 0]\n"
                 "bodies:\n"
                 "- {name: a, mass: 2, inertia: {xx: 3, yy: 1, zz: 3}, joint: {type: revolute,"
                 " point: [0, 0, 0], axis: [1, 0, 0], position: 0.2, velocity: 1}}\n"
                 "- {name: b, mass: 2, inertia: {xx: 3, yy: 1, zz: 3}, joint: {type: revolute,"
                 " point: [5, 0, 0], axis: [1, 0, 0], motion: f}}\n"
                 "functions: [{name: f, type: polynomial, coefficients: [0, 0, 2]}]\n"
                 "joint_springs: [{name: s, coordinate: a, stiffness: 10, damping: 1}]\n"
                 "forces: [{name: l, type: joint, coordinate: a, effort: 0.5}]\n");
  maggi_data *d = test_start(m);
  double w[BODIES][6];

  reactions(d, w);
  check_wrench(w[0], 0, 0, 0, -10 * 0.2 - 1 + 0.5, 0, 0);
  check_wrench(w[1], 0, 0, 0, 3 * 4, 0, 0);
  test_free(d, m);
}

/* a beam on three equal supports that are redundant: the share of smallest norm is the same for
 * the two rods at its end */
static void test_redundant(void)
{
  maggi_model *m = test_model(
      "bodies:\n"
      "- {name: beam, mass: 6, bar: {from: [0, 0, 0], to: [4, 0, 0]},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 1, 0]}}\n"
      "rods:\n"
      "- {name: r1, body_a: beam, body_b: ground, point_a: [4, 0, 0], point_b: [4, 0, 2]}\n"
      "- {name: r2, body_a: beam, body_b: ground, point_a: [4, 0, 0], point_b: [4, 0, 1]}\n");
  maggi_data *d = test_start(m);
  double w[BODIES][6], lambda[2];

  CHECK(test_loops(d).rank == 1);
  reactions(d, w);
  maggi_get_multipliers(d, lambda);
  check_wrench(w[0], 0, 0, 3 * g, 0, 0, 0);
  CHECK_NEAR(lambda[0] + lambda[1], 3 * g, 1e-14, 0.0);
  CHECK_NEAR(lambda[0], lambda[1], 1e-14, 0.0);
  test_free(d, m);
}

int main(void)
{
  test_hanging();
  test_cantilever();
  test_beam(0.0);
  test_beam(1.5);
  test_strut();
  test_slope();
  test_cuts();
  test_four_bar();
  test_joint_efforts();
  test_redundant();
  return check_done();
}
