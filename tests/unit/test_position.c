/* core/kernel/position.c, velocity.c, sensor.c: kinematics of each joint against rotations by
 * quaternions; velocities and accelerations against differences of positions.
 *
 * The body with the joint hangs on a base that turns about a skew axis, so that parents move. */
#include "fixture.h"

enum { PRISMATIC, REVOLUTE };

typedef struct axis {
  int kind;
  double point[3], axis[3];
} axis;

typedef struct joint {
  const char *text; /* of the joint in the file */
  int n;
  axis chain[6];
} joint;

/* axes as written, in the initial position; P has its point anywhere */
#define P                                                                                          \
  {                                                                                                \
    0.3, -0.2, 0.5                                                                                 \
  }
static const joint joints[] = {
    {"type: revolute, axis: [1, -2, 0.5]", 1, {{REVOLUTE, P, {1, -2, 0.5}}}},
    {"type: prismatic, axis: [0.6, 0, 0.8]", 1, {{PRISMATIC, P, {0.6, 0, 0.8}}}},
    {"type: cylindrical, axis: [0, 0.6, 0.8]",
     2,
     {{PRISMATIC, P, {0, 0.6, 0.8}}, {REVOLUTE, P, {0, 0.6, 0.8}}}},
    {"type: universal, axis: [1, 1, 0], axis2: [0.2, -1, 3]",
     2,
     {{REVOLUTE, P, {1, 1, 0}}, {REVOLUTE, P, {0.2, -1, 3}}}},
    /* axis x axis2 = (0.6, 0, 0.8) x (0.8, 0, -0.6) = (0, 1, 0) */
    {"type: planar, axis: [0.6, 0, 0.8], axis2: [0.8, 0, -0.6]",
     3,
     {{PRISMATIC, P, {0.8, 0, -0.6}}, {PRISMATIC, P, {0, 1, 0}}, {REVOLUTE, P, {0.6, 0, 0.8}}}},
    {"type: spherical",
     3,
     {{REVOLUTE, P, {0, 0, 1}}, {REVOLUTE, P, {0, 1, 0}}, {REVOLUTE, P, {1, 0, 0}}}},
    {"type: free",
     6,
     {{PRISMATIC, P, {0, 0, 1}},
      {PRISMATIC, P, {0, 1, 0}},
      {PRISMATIC, P, {1, 0, 0}},
      {REVOLUTE, P, {0, 0, 1}},
      {REVOLUTE, P, {0, 1, 0}},
      {REVOLUTE, P, {1, 0, 0}}}},
    {"type: fixed", 0, {{0}}},
};
enum { JOINTS = sizeof joints / sizeof *joints };

static const axis base = {REVOLUTE, {0.1, 0.4, -0.3}, {0.3, 1, 2}};
static const double points[3][3] = {{0.9, 0.1, -0.4}, {-0.3, 0.8, 0.2}, {0.3, -0.2, 0.5}};

/* motion of coordinate i: offset + amplitude sin(omega t + phase) */
static const double amplitude[7] = {0.7, 0.9, -0.6, 1.1, 0.5, 0.8, -1.2};
static const double omega[7] = {1.0, 1.7, 2.3, 0.9, 1.3, 2.1, 1.1};

static maggi_model *model(const joint *j, int guided)
{
  char motion[256] = "", text[4096];
  int i, n = 0;

  for (i = 0; guided && i < j->n; ++i)
    n += snprintf(motion + n, sizeof motion - (size_t)n, i ? ", f%d" : ", motions: [f%d", i + 1);
  if (n && j->n == 1)
    snprintf(motion, sizeof motion, ", motion: f1");
  else if (n)
    snprintf(motion + n, sizeof motion - (size_t)n, "]");
  n = 0;
  for (i = 0; i < 7; ++i)
    n += snprintf(text + n, sizeof text - (size_t)n,
                  "- {name: f%d, type: sine, amplitude: %.17g, omega: %.17g, phase: 0.3,"
                  " offset: 0.2}\n",
                  i, amplitude[i], omega[i]);
  return test_model(
      "bodies:\n"
      "- {name: base, mass: 1, inertia: {xx: 1, yy: 1, zz: 1}, joint: {type: revolute,"
      " point: [0.1, 0.4, -0.3], axis: [0.3, 1, 2]%s}}\n"
      "- {name: body, parent: base, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {point: [0.3, -0.2, 0.5], %s%s}}\n"
      "functions:\n%s"
      "sensors:\n"
      "- {name: r0, type: position, body: body, point: [0.9, 0.1, -0.4]}\n"
      "- {name: r1, type: position, body: body, point: [-0.3, 0.8, 0.2]}\n"
      "- {name: r2, type: position, body: body, point: [0.3, -0.2, 0.5]}\n"
      "- {name: v0, type: velocity, body: body, point: [0.9, 0.1, -0.4]}\n"
      "- {name: v1, type: velocity, body: body, point: [-0.3, 0.8, 0.2]}\n"
      "- {name: v2, type: velocity, body: body, point: [0.3, -0.2, 0.5]}\n"
      "- {name: a0, type: acceleration, body: body, point: [0.9, 0.1, -0.4]}\n"
      "- {name: a1, type: acceleration, body: body, point: [-0.3, 0.8, 0.2]}\n"
      "- {name: a2, type: acceleration, body: body, point: [0.3, -0.2, 0.5]}\n",
      guided ? ", motion: f0" : "", j->text, motion, text);
}

/* a point moved by one joint about its place in the initial position */
static void move(const axis *a, double z, double x[3])
{
  double e[3], w[3];
  int k;

  for (k = 0; k < 3; ++k) e[k] = x[k] - a->point[k];
  if (a->kind == REVOLUTE) turn3(a->axis, z, e, w);
  for (k = 0; k < 3; ++k)
    x[k] = a->kind == REVOLUTE ? a->point[k] + w[k] : x[k] + z * a->axis[k] / norm3(a->axis);
}

/* the last joint moves first: x = base(chain_1(.. chain_n(x0))) */
static void place(const joint *j, const double *q, const double x0[3], double x[3])
{
  int i;

  memcpy(x, x0, 3 * sizeof *x);
  for (i = j->n - 1; i >= 0; --i) move(&j->chain[i], q[i + 1], x);
  move(&base, q[0], x);
}

static void check_points(const joint *j, const double *q, maggi_data *d)
{
  double s[27], x[3];
  int i, k;

  maggi_get_sensors(d, s);
  for (i = 0; i < 3; ++i) {
    place(j, q, points[i], x);
    for (k = 0; k < 3; ++k) CHECK_NEAR(s[3 * i + k], x[k], 1e-15, 3e-15);
  }
}

static void test_place(const joint *j)
{
  maggi_model *m = model(j, 0);
  maggi_data *d = test_start(m);
  double q[7], v[7] = {0};
  unsigned long long seed = 7;
  int i, k;

  CHECK(test_coordinates(m) == j->n + 1);
  for (i = 0; i < 20; ++i) {
    for (k = 0; k <= j->n; ++k) q[k] = 3.0 * random11(&seed);
    CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
    check_points(j, q, d);
  }
  test_free(d, m);
}

/* sensors at a time; positions by guides */
static void sense(maggi_data *d, double time, double s[27])
{
  double zero[7] = {0};

  CHECK(maggi_data_set_state(d, time, zero, zero) == MAGGI_OK);
  maggi_get_sensors(d, s);
}

/* first and second central differences at steps h and h/2: the error falls by 4, and what is left
 * after extrapolation is of order h^4, 1e-8 */
static void test_rates(const joint *j)
{
  const double h = 0.01;
  maggi_model *m = model(j, 1);
  maggi_data *d = test_start(m);
  test_state state;
  double q[7], s[27], l[27], r[27], l2[27], r2[27], v1, v2, a1, a2, time;
  double e1 = 0.0, e2 = 0.0, f1 = 0.0, f2 = 0.0;
  int i, k, n;

  CHECK(test_loops(d).dof == 0);
  for (n = 0; n < 10; ++n) {
    time = 0.37 * n;
    sense(d, time - h, l);
    sense(d, time + h, r);
    sense(d, time - 0.5 * h, l2);
    sense(d, time + 0.5 * h, r2);
    sense(d, time, s);
    state = test_get(d);
    for (k = 0; k <= j->n; ++k) {
      q[k] = 0.2 + amplitude[k] * sin(omega[k] * time + 0.3);
      CHECK_NEAR(state.q[k], q[k], 0.0, 2e-15);
      CHECK_NEAR(state.v[k], amplitude[k] * omega[k] * cos(omega[k] * time + 0.3), 1e-14, 0.0);
      CHECK_NEAR(state.a[k], -omega[k] * omega[k] * (q[k] - 0.2), 1e-14, 1e-15);
    }
    check_points(j, q, d);
    for (i = 0; i < 9; ++i) {
      v1 = (r[i] - l[i]) / (2.0 * h);
      v2 = (r2[i] - l2[i]) / h;
      a1 = (r[i] - 2.0 * s[i] + l[i]) / (h * h);
      a2 = (r2[i] - 2.0 * s[i] + l2[i]) / (0.25 * h * h);
      e1 += fabs(v1 - s[9 + i]);
      e2 += fabs(v2 - s[9 + i]);
      f1 += fabs(a1 - s[18 + i]);
      f2 += fabs(a2 - s[18 + i]);
      CHECK_NEAR((4.0 * v2 - v1) / 3.0, s[9 + i], 0.0, 1e-6);
      CHECK_NEAR((4.0 * a2 - a1) / 3.0, s[18 + i], 0.0, 1e-5);
    }
  }
  CHECK(e1 > 1e-6 && f1 > 1e-6);
  CHECK_NEAR(e1 / e2, 4.0, 0.01, 0.0);
  CHECK_NEAR(f1 / f2, 4.0, 0.01, 0.0);
  test_free(d, m);
}

/* without axis2 the plane has directions of the library's choice: across the axis and each other,
 * and the second is the axis times the first */
static void test_planar_default(void)
{
  static const double n[3] = {2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0};
  maggi_model *m =
      test_model("bodies:\n"
                 "- {name: b, mass: 1, inertia: {xx: 1, yy: 1, zz: 1}, joint: {type: planar,"
                 " point: [0, 0, 0], axis: [2, -1, 2]}}\n"
                 "sensors:\n"
                 "- {name: r, type: position, body: b, point: [0, 0, 0]}\n");
  maggi_data *d = test_start(m);
  double q[3] = {1.0, 0.0, 0.3}, v[3] = {0}, e1[3], e2[3], c[3];
  int k;

  CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
  maggi_get_sensors(d, e1);
  q[0] = 0.0;
  q[1] = 1.0;
  CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
  maggi_get_sensors(d, e2);
  CHECK_NEAR(dot3(e1, e1), 1.0, 1e-15, 0.0);
  CHECK_NEAR(dot3(e1, n), 0.0, 0.0, 1e-15);
  cross3(n, e1, c);
  for (k = 0; k < 3; ++k) CHECK_NEAR(e2[k], c[k], 0.0, 1e-15);
  test_free(d, m);
}

int main(void)
{
  int i;

  for (i = 0; i < JOINTS; ++i) {
    test_place(&joints[i]);
    test_rates(&joints[i]);
  }
  test_planar_default();
  return check_done();
}
