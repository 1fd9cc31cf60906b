/* core/dynamics/choose.c, plan.c: rank of known mechanisms; change of the independent coordinates
 * while mechanisms pass positions where the chosen ones fail. */
#include "fixture.h"

/* ----------------------------------------------------------------------------------------- rank */

typedef struct mechanism {
  const char *name;
  int equations, rank, dof;
  const char *text;
} mechanism;

#define BODY "mass: 1, inertia: {xx: 1, yy: 1, zz: 1}"
#define REVOLUTE(x, y, z, ax, ay, az)                                                              \
  "joint: {type: revolute, point: [" #x ", " #y ", " #z "], axis: [" #ax ", " #ay ", " #az "]}"

static const mechanism mechanisms[] = {
    {"planar four-bar", 6, 2, 1,
     "bodies:\n"
     "- {name: a, " BODY ", " REVOLUTE(
         0, 0, 0, 0, 0, 1) "}\n"
                           "- {name: b, parent: a, " BODY ", " REVOLUTE(
                               0, 1, 0, 0, 0, 1) "}\n"
                                                 "- {name: c, " BODY ", " REVOLUTE(
                                                     2, 0, 0, 0, 0,
                                                     1) "}\n"
                                                        "loops: [{name: l, type: revolute, body_a: "
                                                        "b, body_b: c, point: [2.3, 1.5, 0],"
                                                        " axis: [0, 0, 1]}]\n"},
    {"spherical four-bar", 6, 2, 1, /* all axes through the origin */
     "bodies:\n"
     "- {name: a, " BODY
     ", " REVOLUTE(0, 0, 0, 0, 0, 1) "}\n"
                                     "- {name: b, parent: a, " BODY ", " REVOLUTE(
                                         0, 0, 0, 0, 0.6,
                                         1) "}\n"
                                            "- {name: c, " BODY ", " REVOLUTE(
                                                0, 0, 0, 1, 0,
                                                0.2) "}\n"
                                                     "loops: [{name: l, type: revolute, body_a: b, "
                                                     "body_b: c, point: [0.4, 1, 0.6],"
                                                     " axis: [0.4, 1, 0.6]}]\n"},
    {"Bennett", 6, 2, 1, /* skew, twists and lengths in proportion: a / sin(alpha) alike */
     "bodies:\n"
     "- {name: a, " BODY ", " REVOLUTE(
         0, 0, 0, 0, 0,
         1) "}\n"
            "- {name: b, parent: a, " BODY ", joint: {type: revolute, point: [%s], axis: [%s]}}\n"
            "- {name: c, " BODY ", joint: {type: revolute, point: [%s], axis: [%s]}}\n"
            "loops: [{name: l, type: revolute, body_a: b, body_b: c, point: [%s], axis: [%s]}]\n"},
    {"Bricard", 6, 4, 1,
     "bodies:\n"
     "- {name: l1, " BODY ", " REVOLUTE(
         0, 0, 0, 0, 1, 0) "}\n"
                           "- {name: l2, parent: l1, " BODY ", " REVOLUTE(
                               1, 0, 0, 0, 0,
                               1) "}\n"
                                  "- {name: l3, parent: l2, " BODY ", " REVOLUTE(
                                      1, -1, 0, 1, 0,
                                      0) "}\n"
                                         "- {name: l4, parent: l3, " BODY ", " REVOLUTE(
                                             1, -1, 1, 0, 1,
                                             0) "}\n"
                                                "- {name: l5, parent: l4, " BODY ", " REVOLUTE(
                                                    0, -1, 1, 0, 0,
                                                    1) "}\n"
                                                       "loops: [{name: l, type: revolute, body_a: "
                                                       "l5, body_b: ground, point: [0, 0, 1],"
                                                       " axis: [1, 0, 0]}]\n"},
    {"RSSR by a rod", 1, 1, 1,
     "bodies:\n"
     "- {name: a, " BODY
     ", " REVOLUTE(0, 0, 0, 0, 0, 1) "}\n"
                                     "- {name: c, " BODY
                                     ", " REVOLUTE(2, 0, 0, 0, 1,
                                                   1) "}\n"
                                                      "rods: [{name: r, body_a: a, body_b: c, "
                                                      "point_a: [0, 1, 0], point_b: [2, 1, 1]}]\n"},
    {"RSSR by a spherical joint, the coupler turns about itself", 3, 3, 2,
     "bodies:\n"
     "- {name: a, " BODY ", " REVOLUTE(
         0, 0, 0, 0, 0,
         1) "}\n"
            "- {name: b, parent: a, " BODY ", joint: {type: spherical, point: [0, 1, 0]}}\n"
            "- {name: c, " BODY ", " REVOLUTE(
                2, 0, 0, 0, 1,
                1) "}\n"
                   "loops: [{name: l, type: spherical, body_a: b, body_b: c, point: [2, 1, 1]}]\n"},
    {"slider-crank by a cylindrical cut", 4, 2, 1,
     "bodies:\n"
     "- {name: a, " BODY
     ", " REVOLUTE(0, 0, 0, 0, 0, 1) "}\n"
                                     "- {name: b, parent: a, " BODY ", " REVOLUTE(
                                         0, 1, 0, 0, 0,
                                         1) "}\n"
                                            "- {name: c, parent: b, " BODY ", " REVOLUTE(
                                                2, 0, 0, 0, 0,
                                                1) "}\n"
                                                   "loops: [{name: l, type: cylindrical, body_a: "
                                                   "c, body_b: ground, point: [2, 0, 0],"
                                                   " axis: [1, 0, 0]}]\n"},
    {"slider-crank by a prismatic cut", 5, 2, 1,
     "bodies:\n"
     "- {name: a, " BODY
     ", " REVOLUTE(0, 0, 0, 0, 0, 1) "}\n"
                                     "- {name: b, parent: a, " BODY ", " REVOLUTE(
                                         0, 1, 0, 0, 0,
                                         1) "}\n"
                                            "- {name: c, parent: b, " BODY ", " REVOLUTE(
                                                2, 0, 0, 0, 0,
                                                1) "}\n"
                                                   "loops: [{name: l, type: prismatic, body_a: c, "
                                                   "body_b: ground, point: [2, 0, 0],"
                                                   " axis: [1, 0, 0]}]\n"},
    {"a free body in each cut", 22, 22, 8, /* 5 * 6 - (3 + 5 + 4 + 4 + 5) - 1 = 8 */
     "bodies:\n"
     "- {name: a, " BODY ", joint: {type: free, point: [0, 0, 0]}}\n"
     "- {name: b, " BODY ", joint: {type: free, point: [0, 0, 0]}}\n"
     "- {name: c, " BODY ", joint: {type: free, point: [0, 0, 0]}}\n"
     "- {name: d, " BODY ", joint: {type: free, point: [0, 0, 0]}}\n"
     "- {name: e, " BODY ", joint: {type: free, point: [0, 0, 0]}}\n"
     "loops:\n"
     "- {name: l1, type: spherical, body_a: a, body_b: ground, point: [1, 2, 3]}\n"
     "- {name: l2, type: universal, body_a: b, body_b: ground, point: [1, 2, 3],"
     " axis_a: [1, 0, 0], axis_b: [1, 1, 0]}\n"
     "- {name: l3, type: cylindrical, body_a: c, body_b: ground, point: [1, 2, 3],"
     " axis: [1, 2, 0]}\n"
     "- {name: l4, type: prismatic, body_a: d, body_b: ground, point: [1, 2, 3], axis: [1, 2, 3]}\n"
     "- {name: l5, type: prismatic, body_a: e, body_b: a, point: [1, 2, 3], axis: [0, 1, 3]}\n"
     "rods: [{name: r, body_a: a, body_b: b, point_a: [2, 2, 3], point_b: [3, 3, 3]}]\n"},
    {"a free body held by a revolute", 6, 5, 1,
     "bodies: [{name: a, " BODY ", joint: {type: free, point: [0, 0, 0]}}]\n"
     "loops: [{name: l, type: revolute, body_a: a, body_b: ground, point: [1, 2, 3],"
     " axis: [3, 2, 1]}]\n"},
    {"the same twice", 12, 5, 1,
     "bodies: [{name: a, " BODY ", joint: {type: free, point: [0, 0, 0]}}]\n"
     "loops:\n"
     "- {name: l, type: revolute, body_a: a, body_b: ground, point: [1, 2, 3], axis: [3, 2, 1]}\n"
     "- {name: m, type: revolute, body_a: a, body_b: ground, point: [1, 2, 3], axis: [3, 2, 1]}\n"},
    {"platform on six legs, a structure", 6, 6, 0,
     "bodies: [{name: a, " BODY ", joint: {type: free, point: [0, 0, 1]}}]\n"
     "rods:\n"
     "- {name: r1, body_a: a, body_b: ground, point_a: [1, 0, 1], point_b: [2, 1, 0]}\n"
     "- {name: r2, body_a: a, body_b: ground, point_a: [1, 0, 1], point_b: [2, -1, 0]}\n"
     "- {name: r3, body_a: a, body_b: ground, point_a: [-0.5, 0.8, 1], point_b: [-2, 1, 0]}\n"
     "- {name: r4, body_a: a, body_b: ground, point_a: [-0.5, 0.8, 1], point_b: [-0.2, 2, 0]}\n"
     "- {name: r5, body_a: a, body_b: ground, point_a: [-0.5, -0.8, 1], point_b: [-0.2, -2, 0]}\n"
     "- {name: r6, body_a: a, body_b: ground, point_a: [-0.5, -0.8, 1], point_b: [-2, -1, 0]}\n"},
    {"parallelogram with a third crank: redundant", 12, 3, 1,
     "bodies:\n"
     "- {name: a, " BODY ", " REVOLUTE(
         0, 0, 0, 0, 0,
         1) "}\n"
            "- {name: b, parent: a, " BODY ", " REVOLUTE(
                0, 1, 0, 0, 0,
                1) "}\n"
                   "- {name: c, " BODY
                   ", " REVOLUTE(1, 0, 0, 0, 0,
                                 1) "}\n"
                                    "- {name: d, " BODY
                                    ", " REVOLUTE(
                                        2, 0, 0, 0, 0,
                                        1) "}\n"
                                           "loops:\n"
                                           "- {name: l, type: revolute, body_a: b, body_b: c, "
                                           "point: [1, 1, 0], axis: [0, 0, 1]}\n"
                                           "- {name: m, type: revolute, body_a: b, body_b: d, "
                                           "point: [2, 1, 0], axis: [0, 0, 1]}\n"},
};
enum { MECHANISMS = sizeof mechanisms / sizeof *mechanisms };

/* Bennett's linkage: a closed chain of four skew axes, lengths a and b, twists alpha and beta with
 * sin(alpha) / a = sin(beta) / b.  Place of the joints from the Denavit-Hartenberg chain at angle
 * theta1, theta2 by tan(theta1/2) tan(theta2/2) = sin((beta+alpha)/2) / sin((beta-alpha)/2). */
static void bennett(char joints[6][128])
{
  const double a = 1.0, b = 1.4, alpha = 0.6, beta = asin(b / a * sin(alpha));
  const double t1 = 1.1, t2 = 2.0 * atan(sin(0.5 * (beta + alpha)) / sin(0.5 * (beta - alpha)) /
                                         tan(0.5 * t1));
  const double theta[4] = {t1, t2, -t1, -t2}, length[4] = {a, b, a, b};
  const double twist[4] = {alpha, beta, alpha, beta};
  double p[3] = {0}, x[3] = {1, 0, 0}, z[3] = {0, 0, 1}, w[3];
  int i, k;

  /* turn x about z by theta, go along x, turn z about x by the twist */
  for (i = 0; i < 4; ++i) {
    turn3(z, theta[i], x, w);
    memcpy(x, w, sizeof x);
    for (k = 0; k < 3; ++k) p[k] += length[i] * x[k];
    turn3(x, twist[i], z, w);
    memcpy(z, w, sizeof z);
    if (i == 3) break;
    /* of the three moving joints the first two belong to bodies b and c of the text, in the order
     * b, loop, c: ground - a - b - loop - c - ground */
    k = i == 0 ? 0 : i == 1 ? 4 : 2;
    snprintf(joints[k], 128, "%.17g, %.17g, %.17g", p[0], p[1], p[2]);
    snprintf(joints[k + 1], 128, "%.17g, %.17g, %.17g", z[0], z[1], z[2]);
  }
  for (k = 0; k < 3; ++k) CHECK_NEAR(p[k], 0.0, 0.0, 1e-15); /* it closes */
  CHECK_NEAR(z[2], 1.0, 1e-15, 0.0);
}

static void test_ranks(void)
{
  char joints[6][128];
  maggi_model *m;
  maggi_data *d;
  maggi_loop_state s;
  maggi_model_info info;
  int i;

  bennett(joints);
  for (i = 0; i < MECHANISMS; ++i) {
    m = test_model(mechanisms[i].text, joints[0], joints[1], joints[2], joints[3], joints[4],
                   joints[5]);
    d = test_start(m);
    maggi_model_get_info(m, &info);
    s = test_loops(d);
    if (!CHECK(info.loop_equations == mechanisms[i].equations && s.rank == mechanisms[i].rank &&
               s.dof == mechanisms[i].dof))
      fprintf(stderr, "  %s: %d equations, rank %d, dof %d\n", mechanisms[i].name,
              info.loop_equations, s.rank, s.dof);
    test_step(d, 1e-3, 100);
    CHECK(test_loops(d).violation < 1e-9);
    CHECK(test_loops(d).rank == mechanisms[i].rank);
    test_free(d, m);
  }
}

/* ------------------------------------------------------------------------------- dead points */

static maggi_model *slider_crank(const char *crank, const char *slider)
{
  return test_model(
      "gravity: [0, 0, 0]\n"
      "bodies:\n"
      "- {name: crank, mass: 1, cog: [0.05, 0.1, 0], inertia: {xx: 9, yy: 9, zz: 0.2},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]%s}}\n"
      "- {name: rod, parent: crank, mass: 0.5, bar: {from: [0, 0.3, 0], to: [%.17g, 0, 0]},"
      " joint: {type: revolute, point: [0, 0.3, 0], axis: [0, 0, 1]}}\n"
      "- {name: slider, mass: 0.7, joint: {type: prismatic, axis: [1, 0, 0]%s}}\n"
      "loops: [{name: pin, type: revolute, body_a: rod, body_b: slider, point: [%.17g, 0, 0],"
      " axis: [0, 0, 1]}]\n",
      crank, sqrt(1.0 - 0.09), slider, sqrt(1.0 - 0.09));
}

/* three coordinates of d are those of e; they are returned */
static test_state check_same(const maggi_data *d, const maggi_data *e)
{
  test_state s = test_get(d), r = test_get(e);
  int k;

  for (k = 0; k < 3; ++k) {
    CHECK_NEAR(s.q[k], r.q[k], 0.0, 1e-6);
    CHECK_NEAR(s.v[k], r.v[k], 0.0, 1e-5);
  }
  return s;
}

/* the slider leads, over several turns of the crank: at each dead point the crank has to take over.
 * The motion is that of the same mechanism led by its crank with a fine step, and the slider stays
 * where the rod's branch puts it. */
static void test_slider_crank(void)
{
  maggi_model *m = slider_crank("", ", velocity: 1.2"), *fine;
  maggi_data *d = test_start(m), *e;
  test_state s;
  char velocity[64];
  double theta, x0 = sqrt(0.91), turned = 0.0;
  int i;

  CHECK(maggi_coordinate_is_independent(d, 2) && !maggi_coordinate_is_independent(d, 0));
  CHECK(test_get(d).v[2] == 1.2);
  snprintf(velocity, sizeof velocity, ", velocity: %.17g", test_get(d).v[0]);
  fine = slider_crank(velocity, "");
  e = test_start(fine);
  CHECK(maggi_coordinate_is_independent(e, 0));
  for (i = 0; i < 400; ++i) {
    test_step(d, 1e-3, 10);
    test_step(e, 2e-4, 50);
    s = check_same(d, e);
    theta = acos(0.0) + s.q[0];
    CHECK_NEAR(s.q[2] + x0, 0.3 * cos(theta) + sqrt(1.0 - pow(0.3 * sin(theta), 2)), 0.0, 1e-9);
    CHECK(s.v[0] < 0.0); /* the crank never turns back */
    turned = -s.q[0];
  }
  CHECK(turned > 12.0); /* two turns at least */
  CHECK(test_loops(d).changes > 0);
  CHECK_NEAR(test_energy(d), test_energy(e), 1e-7, 0.0);
  test_free(d, m);
  test_free(e, fine);
}

/* quick-return: a lever about (0, 0) is driven by a block that the crank about (0, 1) carries
 * along it; the lever leads and turns back twice in each turn of the crank */
static maggi_model *quick_return(const char *crank, const char *lever)
{
  return test_model(
      "gravity: [0, 0, 0]\n"
      "bodies:\n"
      "- {name: lever, mass: 1, bar: {from: [0, 0, 0], to: [0.8, 2, 0]},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]%s}}\n"
      "- {name: block, parent: lever, mass: 0.1, cog: [0.4, 1, 0], inertia: {xx: 1, yy: 1, zz: "
      "0.01},"
      " joint: {type: prismatic, axis: [0.4, 1, 0]}}\n"
      "- {name: crank, mass: 2, cog: [0, 1, 0], inertia: {xx: 9, yy: 9, zz: 0.5},"
      " joint: {type: revolute, point: [0, 1, 0], axis: [0, 0, 1]%s}}\n"
      "loops: [{name: pin, type: revolute, body_a: block, body_b: crank, point: [0.4, 1, 0],"
      " axis: [0, 0, 1]}]\n",
      lever, crank);
}

static void test_quick_return(void)
{
  maggi_model *m = quick_return("", ", velocity: -0.5"), *fine;
  maggi_data *d = test_start(m), *e;
  test_state s;
  char velocity[64];
  double theta;
  int i, back = 0;

  CHECK(maggi_coordinate_is_independent(d, 0));
  snprintf(velocity, sizeof velocity, ", velocity: %.17g", test_get(d).v[2]);
  fine = quick_return(velocity, "");
  e = test_start(fine);
  for (i = 0; i < 400; ++i) {
    test_step(d, 1e-3, 20);
    test_step(e, 2e-4, 100);
    s = check_same(d, e);
    theta = s.q[2]; /* pin at (0.4 cos, 1 + 0.4 sin); block on the ray from the origin, in front */
    CHECK_NEAR(hypot(0.4, 1.0) + s.q[1], hypot(0.4 * cos(theta), 1.0 + 0.4 * sin(theta)), 0.0,
               1e-9);
    CHECK_NEAR(atan2(1.0, 0.4) + s.q[0], atan2(1.0 + 0.4 * sin(theta), 0.4 * cos(theta)), 0.0,
               1e-9);
    back += s.v[0] > 0.0;
  }
  CHECK(fabs(s.q[2]) > 7.0);
  CHECK(back > 50 && back < 350);
  CHECK(test_loops(d).changes > 0);
  test_free(d, m);
  test_free(e, fine);
}

/* a parallelogram through its flat position, which no choice of coordinates avoids: it stays one,
 * and says that it is there */
static void test_flat(void)
{
  maggi_model *m =
      test_model("gravity: [0, 0, 0]\n"
                 "bodies:\n"
                 "- {name: a, mass: 1, bar: {from: [0, 0, 0], to: [0, 1, 0]},"
                 " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1], velocity: 1.3}}\n"
                 "- {name: b, parent: a, mass: 1, bar: {from: [0, 1, 0], to: [2, 1, 0]},"
                 " joint: {type: revolute, point: [0, 1, 0], axis: [0, 0, 1]}}\n"
                 "- {name: c, mass: 1, bar: {from: [2, 0, 0], to: [2, 1, 0]},"
                 " joint: {type: revolute, point: [2, 0, 0], axis: [0, 0, 1]}}\n"
                 "loops: [{name: l, type: revolute, body_a: b, body_b: c, point: [2, 1, 0],"
                 " axis: [0, 0, 1]}]\n");
  maggi_data *d = test_start(m);
  test_state s;
  double smallest = 1.0;
  int i;

  for (i = 0; i < 10000; ++i) {
    test_step(d, 1e-3, 1);
    smallest = fmin(smallest, test_loops(d).pivot_ratio);
    if (i % 100) continue;
    s = test_get(d);
    /* no force: uniform turning, cranks parallel, coupler level */
    CHECK_NEAR(s.q[0], 1.3e-3 * (i + 1), 0.0, 1e-7);
    CHECK_NEAR(s.q[2], s.q[0], 0.0, 1e-7);
    CHECK_NEAR(s.q[1], -s.q[0], 0.0, 1e-7);
  }
  CHECK(smallest < 0.01);
  test_free(d, m);
}

int main(void)
{
  test_ranks();
  test_slider_crank();
  test_quick_return();
  test_flat();
  return check_done();
}
