/* core/sensitivity: derivatives of one evaluation, on every model of models/ and on one with all kinds of
 * joints, loops and elements, at states of a simulation and at positions where the loops are open.
 *
 *   tangent     against centred differences of maggi_evaluate at two steps
 *   strips      against tangents
 *   adjoint     against tangents, by the dot product
 *   second      against centred differences of the adjoint, and by symmetry */
#include <dirent.h>

#include "derivative.h"
#include "fixture.h"

enum { STEPS = 20, DIRECTIONS = 35 };

/* what an evaluation starts from */
typedef struct point {
  const maggi_model *m;
  maggi_data *d;
  maggi_derivative *D;
  int n, np; /* coordinates, parameters */
  double time;
  double *q, *vcol, *p; /* internal order */
} point;

/* directions and gradients, or many directions side by side */
typedef struct input {
  double *q, *v, *p;
} input;

typedef struct output {
  double *v, *a;
} output;

static double *vector(int n)
{
  double *x = calloc((size_t)n + 1, sizeof *x);

  if (!x) exit(1);
  return x;
}

static input new_input(const point *s, int columns)
{
  return (input){vector(s->n * columns), vector(s->n * columns), vector(s->np * columns)};
}

static output new_output(const point *s, int columns)
{
  return (output){vector(s->n * columns), vector(s->n * columns)};
}

static void free_input(input x)
{
  free(x.q);
  free(x.v);
  free(x.p);
}

static void free_output(output y)
{
  free(y.v);
  free(y.a);
}

static double norm(int n, const double *x)
{
  double s = 0.0;
  int i;

  for (i = 0; i < n; ++i) s += x[i] * x[i];
  return sqrt(s);
}

/* |x - reference| over |reference|, or alone when that is zero */
static double error_of(int n, const double *x, const double *reference)
{
  double s = 0.0, size = norm(n, reference);
  int i;

  for (i = 0; i < n; ++i) s += (x[i] - reference[i]) * (x[i] - reference[i]);
  return size > 0.0 ? sqrt(s) / size : sqrt(s);
}

/* a direction along which each parameter moves in proportion to its size */
static void random_input(const point *s, unsigned long long *seed, input x)
{
  int i;

  for (i = 0; i < s->n; ++i) {
    x.q[i] = random11(seed);
    x.v[i] = random11(seed);
  }
  for (i = 0; i < s->np; ++i) x.p[i] = random11(seed) * (s->p[i] == 0.0 ? 0.1 : fabs(s->p[i]));
}

static void random_output(const point *s, unsigned long long *seed, output y)
{
  int i;

  for (i = 0; i < s->n; ++i) {
    y.v[i] = random11(seed);
    y.a[i] = random11(seed);
  }
}

static void new_point(point *s, const maggi_model *m, maggi_data *d)
{
  maggi_model_info info;

  maggi_model_get_info(m, &info);
  *s = (point){.m = m, .d = d, .n = info.coordinates, .np = info.parameters, .time = d->time};
  s->q = vector(s->n);
  s->vcol = vector(s->n);
  s->p = vector(s->np);
  memcpy(s->q, d->q, (size_t)s->n * sizeof(double));
  memcpy(s->vcol, d->vcol, (size_t)d->t.ncol * sizeof(double));
  memcpy(s->p, d->p, (size_t)s->np * sizeof(double));
  if (!CHECK(maggi_derivative_create(d, 20, &s->D) == MAGGI_OK)) exit(1);
}

static void free_point(point *s)
{
  free(s->q);
  free(s->vcol);
  free(s->p);
  maggi_derivative_free(s->D);
}

/* evaluation at the point plus h x */
static void move(point *s, double h, input x)
{
  maggi_data *d = s->d;
  int i, k;

  for (i = 0; i < s->n; ++i) {
    k = s->m->coordinate[i].q;
    d->q[k] = s->q[k] + h * x.q[i];
    if (d->t.col[k] >= 0) d->vcol[d->t.col[k]] = s->vcol[d->t.col[k]] + h * x.v[i];
  }
  for (i = 0; i < s->np; ++i) d->p[i] = s->p[i] + h * x.p[i];
  maggi_constants(d);
  maggi_evaluate(d, s->time);
  CHECK(maggi_linearise_at(s->D, s->time) == MAGGI_OK);
}

static const double steps[4] = {-1.0, 1.0, -2.0, 2.0};

/* centred difference of order 4 from values at these steps */
static void combine(int n, double *const x[4], double h, double *result)
{
  int i;

  for (i = 0; i < n; ++i)
    result[i] = (8.0 * (x[1][i] - x[0][i]) - (x[3][i] - x[2][i])) / (12.0 * h);
}

static void differences(point *s, double h, input x, output result)
{
  output y[4];
  int i;

  for (i = 0; i < 4; ++i) {
    y[i] = new_output(s, 1);
    move(s, steps[i] * h, x);
    maggi_get_coordinates(s->d, NULL, y[i].v, y[i].a);
  }
  combine(s->n, (double *[]){y[0].v, y[1].v, y[2].v, y[3].v}, h, result.v);
  combine(s->n, (double *[]){y[0].a, y[1].a, y[2].a, y[3].a}, h, result.a);
  for (i = 0; i < 4; ++i) free_output(y[i]);
  move(s, 0.0, x);
}

/* error h^4 at the large step, round-off / h at the small one */
static void test_tangent(point *s, unsigned long long *seed)
{
  const double h = 1e-4;
  input x = new_input(s, 1);
  output y = new_output(s, 1), large = new_output(s, 1), small = new_output(s, 1);

  random_input(s, seed, x);
  maggi_motion_jvp(s->D, x.q, x.v, x.p, y.v, y.a);
  differences(s, h, x, large);
  differences(s, 0.25 * h, x, small);
  CHECK(norm(s->n, y.a) > 0.0);
  CHECK_NEAR(error_of(s->n, large.v, y.v), 0.0, 0.0, 1e-7);
  CHECK_NEAR(error_of(s->n, large.a, y.a), 0.0, 0.0, 1e-7);
  CHECK_NEAR(error_of(s->n, small.v, y.v), 0.0, 0.0, 1e-9);
  CHECK_NEAR(error_of(s->n, small.a, y.a), 0.0, 0.0, 5e-9);
  free_input(x);
  free_output(y);
  free_output(large);
  free_output(small);
}

static void test_strips(point *s, unsigned long long *seed)
{
  input x = new_input(s, 1), X = new_input(s, DIRECTIONS);
  output y = new_output(s, 1), Y = new_output(s, DIRECTIONS);
  double *v = vector(s->n), *a = vector(s->n);
  int i, k;

  for (i = 0; i < s->n * DIRECTIONS; ++i) {
    X.q[i] = random11(seed);
    X.v[i] = random11(seed);
  }
  for (i = 0; i < s->np * DIRECTIONS; ++i) X.p[i] = random11(seed);
  maggi_motion_jac(s->D, DIRECTIONS, X.q, X.v, X.p, Y.v, Y.a);
  for (k = 0; k < DIRECTIONS; ++k) {
    for (i = 0; i < s->n; ++i) {
      x.q[i] = X.q[i * DIRECTIONS + k];
      x.v[i] = X.v[i * DIRECTIONS + k];
      v[i] = Y.v[i * DIRECTIONS + k];
      a[i] = Y.a[i * DIRECTIONS + k];
    }
    for (i = 0; i < s->np; ++i) x.p[i] = X.p[i * DIRECTIONS + k];
    maggi_motion_jvp(s->D, x.q, x.v, x.p, y.v, y.a);
    CHECK_NEAR(error_of(s->n, v, y.v), 0.0, 0.0, 1e-12);
    CHECK_NEAR(error_of(s->n, a, y.a), 0.0, 0.0, 1e-12);
  }
  free(v);
  free(a);
  free_input(x);
  free_input(X);
  free_output(y);
  free_output(Y);
}

/* x.g with its size, the sum of the absolute terms */
static double product(const point *s, input x, input g, double *size)
{
  double sum = 0.0;
  int i;

  *size = 0.0;
  for (i = 0; i < s->n; ++i) {
    sum += x.q[i] * g.q[i] + x.v[i] * g.v[i];
    *size += fabs(x.q[i] * g.q[i]) + fabs(x.v[i] * g.v[i]);
  }
  for (i = 0; i < s->np; ++i) {
    sum += x.p[i] * g.p[i];
    *size += fabs(x.p[i] * g.p[i]);
  }
  return sum;
}

/* (v, a).w of the tangent is x.g of the adjoint */
static void test_adjoint(point *s, unsigned long long *seed)
{
  input x = new_input(s, 1), g = new_input(s, 1);
  output y = new_output(s, 1), w = new_output(s, 1);
  double left = 0.0, right, size;
  int i;

  random_input(s, seed, x);
  random_output(s, seed, w);
  maggi_motion_jvp(s->D, x.q, x.v, x.p, y.v, y.a);
  maggi_motion_vjp(s->D, w.v, w.a, g.q, g.v, g.p);
  for (i = 0; i < s->n; ++i) left += y.v[i] * w.v[i] + y.a[i] * w.a[i];
  right = product(s, x, g, &size);
  CHECK(size > 0.0);
  CHECK_NEAR(left, right, 0.0, 1e-13 * size);
  free_input(x);
  free_input(g);
  free_output(y);
  free_output(w);
}

/* change of the gradient for the weights w along x */
static void gradient_differences(point *s, double h, output w, input x, input result)
{
  input g[4];
  int i;

  for (i = 0; i < 4; ++i) {
    g[i] = new_input(s, 1);
    move(s, steps[i] * h, x);
    maggi_motion_vjp(s->D, w.v, w.a, g[i].q, g[i].v, g[i].p);
  }
  combine(s->n, (double *[]){g[0].q, g[1].q, g[2].q, g[3].q}, h, result.q);
  combine(s->n, (double *[]){g[0].v, g[1].v, g[2].v, g[3].v}, h, result.v);
  combine(s->np, (double *[]){g[0].p, g[1].p, g[2].p, g[3].p}, h, result.p);
  for (i = 0; i < 4; ++i) free_input(g[i]);
  move(s, 0.0, x);
}

/* one of two differences is near H; g is the gradient, for the round-off of differences */
static void check_second(int n, const double *large, const double *small, const double *H,
                         const double *g)
{
  double size = norm(n, H) > 0.0 ? norm(n, H) : 1.0;
  double error = fmin(error_of(n, large, H), error_of(n, small, H)) * size;

  CHECK_NEAR(error, 0.0, 0.0, 1e-7 * norm(n, H) + 1e-10 * norm(n, g));
}

static void test_second(point *s, unsigned long long *seed)
{
  const double h = 1e-4;
  input x = new_input(s, 1), y = new_input(s, 1), Hx = new_input(s, 1), Hy = new_input(s, 1);
  input large = new_input(s, 1), small = new_input(s, 1), g = new_input(s, 1);
  output w = new_output(s, 1);
  double left, right, size, largest;

  random_input(s, seed, x);
  random_input(s, seed, y);
  random_output(s, seed, w);
  maggi_motion_hvp(s->D, w.v, w.a, x.q, x.v, x.p, Hx.q, Hx.v, Hx.p);
  maggi_motion_hvp(s->D, w.v, w.a, y.q, y.v, y.p, Hy.q, Hy.v, Hy.p);
  left = product(s, x, Hy, &size);
  largest = size;
  right = product(s, y, Hx, &size);
  largest = fmax(largest, size);
  CHECK(largest > 0.0);
  CHECK_NEAR(left, right, 0.0, 5e-13 * largest);

  maggi_motion_vjp(s->D, w.v, w.a, g.q, g.v, g.p);
  gradient_differences(s, h, w, x, large);
  gradient_differences(s, 0.1 * h, w, x, small);
  check_second(s->n, large.q, small.q, Hx.q, g.q);
  check_second(s->n, large.v, small.v, Hx.v, g.v);
  check_second(s->np, large.p, small.p, Hx.p, g.p);
  free_input(x);
  free_input(y);
  free_input(Hx);
  free_input(Hy);
  free_input(large);
  free_input(small);
  free_input(g);
  free_output(w);
}

static void test_all(point *s, unsigned long long *seed)
{
  test_tangent(s, seed);
  test_strips(s, seed);
  test_adjoint(s, seed);
  test_second(s, seed);
}

/* at the present state of d, then with all coordinates moved so that the loops stand open */
static void test_state_of(const maggi_model *m, maggi_data *d, unsigned long long *seed)
{
  point s;
  input x;
  int i;

  new_point(&s, m, d);
  x = new_input(&s, 1);
  CHECK(maggi_linearise(s.D) == MAGGI_OK);
  test_all(&s, seed);
  for (i = 0; i < s.n; ++i) {
    s.q[i] += 1e-2 * random11(seed);
    s.vcol[i] += 0.3 * random11(seed);
  }
  move(&s, 0.0, x);
  CHECK(d->t.ndep == 0 || maggi_violation(d) > 1e-6);
  test_all(&s, seed);
  free_input(x);
  free_point(&s);
}

static void test_model_of(maggi_model *m, double h)
{
  unsigned long long seed = 5;
  maggi_data *d = test_start(m);

  test_state_of(m, d, &seed);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  test_step(d, h, STEPS);
  test_state_of(m, d, &seed);
  test_free(d, m);
}

static void test_files(void)
{
  maggi_model_info info;
  maggi_model *m;
  struct dirent *entry;
  DIR *folder = opendir(MAGGI_MODELS_DIR);
  size_t length;
  long failed;
  int n = 0;

  while (CHECK(folder) && (entry = readdir(folder))) {
    length = strlen(entry->d_name);
    if (length < 5 || strcmp(entry->d_name + length - 5, ".yaml") != 0) continue;
    m = test_file(entry->d_name);
    maggi_model_get_info(m, &info);
    failed = check_failed;
    test_model_of(m, info.simulation.step > 0.0 ? info.simulation.step : 1e-3);
    if (check_failed > failed) fprintf(stderr, "in %s\n", entry->d_name);
    ++n;
  }
  closedir(folder);
  CHECK(n > 10);
}

/* ------------------------------------------------------------------------- all kinds of things */

static const char *const loops[] = {
    "{name: l, type: spherical, body_a: a3, body_b: b3, point: [0.5, 1, 0.2]}",
    "{name: l, type: revolute, body_a: a3, body_b: b3, point: [0.5, 1, 0.2], axis: [1, 2, -1]}",
    "{name: l, type: universal, body_a: a3, body_b: b3, point: [0.5, 1, 0.2],"
    " axis_a: [1, 2, -1], axis_b: [0.3, -1, 0.2]}",
    "{name: l, type: cylindrical, body_a: a3, body_b: b3, point: [0.5, 1, 0.2], axis: [1, 2, -1]}",
    "{name: l, type: prismatic, body_a: a3, body_b: b3, point: [0.5, 1, 0.2], axis: [1, 2, -1]}",
};
enum { LOOPS = sizeof loops / sizeof *loops };

/* A guided cart carries everything; on a turning arm a loop between two branches, one of which a rod
 * with mass ties to the ground; a guided fan. */
static maggi_model *machine(int loop)
{
  return test_model(
      "bodies:\n"
      "- {name: cart, mass: 2, joint: {type: prismatic, axis: [1, 0.2, 0], motion: sway}}\n"
      "- {name: a1, parent: cart, mass: 1, cog: [0.1, 0.2, 0], inertia: {xx: 1, yy: 2, zz: 1.5},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0.2, 0], velocity: 1.3}}\n"
      "- {name: a2, parent: a1, mass: 1, inertia: {xx: 1, yy: 1, zz: 1, xy: 0.1},"
      " joint: {type: prismatic, point: [0, 0.3, 0], axis: [0.5, 1, 1]}}\n"
      "- {name: a3, parent: a2, mass: 1, cog: [0.3, 0.8, 0.1], inertia: {xx: 1, yy: 2, zz: 1},"
      " joint: {type: spherical, point: [0.2, 0.6, 0.1]}}\n"
      "- {name: b1, parent: a1, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: universal, point: [1, 0, 0], axis: [0, 1, 0.4], axis2: [1, 0, 1]}}\n"
      "- {name: b2, parent: b1, mass: 1, bar: {from: [1, 0.3, 0], to: [0.8, 0.6, 0.1]},"
      " joint: {type: revolute, point: [1, 0.3, 0], axis: [0.1, 0.4, 1]}}\n"
      "- {name: b3, parent: b2, mass: 1, inertia: {xx: 1, yy: 1, zz: 1, yz: -0.2},"
      " joint: {type: cylindrical, point: [0.8, 0.6, 0.1], axis: [1, -1, 0.3]}}\n"
      "- {name: fan, parent: a1, mass: 0.5, cog: [0.4, 0.1, 0.3], inertia: {xx: 0.1, yy: 0.2,"
      " zz: 0.3}, joint: {type: revolute, point: [0.4, 0, 0.3], axis: [0, 0.3, 1], motion: turn},"
      " point_masses: [{name: tip, mass: 0.2, point: [0.6, 0, 0.4]}]}\n"
      "- {name: plate, parent: cart, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: planar, point: [0, -1, 0], axis: [0, 1, 0.1], axis2: [1, 0, 0]}}\n"
      "- {name: weight, parent: plate, mass: 0.3, cog: [0, -1.2, 0], joint: {type: fixed}}\n"
      "loops:\n- %s\n"
      "rods:\n"
      "- {name: tie, body_a: b2, body_b: ground, point_a: [0.9, 0.5, 0], point_b: [2, 1, 0.3],"
      " mass: 0.7, length: 1.25}\n"
      "- {name: link, body_a: plate, body_b: fan, point_a: [0, -1, 0.2], point_b: [0.4, 0, 0.5],"
      " mass: 0.4}\n"
      "springs:\n"
      "- {name: s, body_a: a3, body_b: ground, point_a: [0.5, 1, 0.2], point_b: [0, 3, 0],"
      " stiffness: 20, free_length: 1, damping: 2, slopes: {c1: 4, c2: 5, c3: 6, c4: 7, v11: 0.1,"
      " v22: -0.1}}\n"
      "- {name: t, body_a: plate, body_b: b3, point_a: [0, -1, 0], point_b: [0.5, 1, 0.2],"
      " stiffness: 10, preload: 4}\n"
      "joint_springs:\n"
      "- {name: a, coordinate: a1, stiffness: 1, damping: 2, rest: 3, preload: 4}\n"
      "- {name: b, coordinate: plate.1, coordinate2: plate.2, stiffness: 5, damping: 0.1}\n"
      "functions:\n"
      "- {name: sway, type: sine, amplitude: 0.1, omega: 2, phase: 3, offset: -0.014112}\n"
      "- {name: turn, type: spline, times: [-1, -0.3, 0.4, 1], values: [-3, 0, 1, 2]}\n"
      "- {name: gust, type: knots, times: [-0.5, 0.4, 1], values: [1, 3, 2]}\n"
      "- {name: ramp, type: polynomial, coefficients: [1, 2, 3]}\n"
      "forces:\n"
      "- {name: f, type: force, body: a3, point: [0.5, 1, 0.2], value: [4, 5, 6], function: gust}\n"
      "- {name: g, type: force_body, body: b3, reaction: plate, point: [1, 1, 0],"
      " value: [1, -2, 3]}\n"
      "- {name: h, type: torque_body, body: fan, reaction: a1, value: [1, 2, 3], function: ramp}\n"
      "- {name: i, type: joint, coordinate: plate.3, effort: 3, function: gust}\n",
      loops[loop]);
}

static void test_machines(void)
{
  long failed;
  int i;

  for (i = 0; i < LOOPS; ++i) {
    failed = check_failed;
    test_model_of(machine(i), 1e-3);
    if (check_failed > failed) fprintf(stderr, "in loop %d\n", i);
  }
}

/* ------------------------------------------------------------------------------- the interface */

/* guided coordinates and velocities of dependent ones are no inputs */
static void test_inputs(void)
{
  maggi_model *m = machine(1);
  maggi_data *d = test_start(m);
  unsigned long long seed = 3;
  input x, y, g;
  output a, b;
  point s;
  int i, ignored_q, ignored_v, count = 0;

  new_point(&s, m, d);
  CHECK(maggi_linearise(s.D) == MAGGI_OK);
  x = new_input(&s, 1);
  y = new_input(&s, 1);
  g = new_input(&s, 1);
  a = new_output(&s, 1);
  b = new_output(&s, 1);
  random_input(&s, &seed, x);
  memcpy(y.p, x.p, (size_t)s.np * sizeof(double));
  for (i = 0; i < s.n; ++i) {
    ignored_q = maggi_coordinate_is_guided(m, i);
    ignored_v = !maggi_coordinate_is_independent(d, i);
    y.q[i] = ignored_q ? 10.0 : x.q[i];
    y.v[i] = ignored_v ? 10.0 : x.v[i];
    count += ignored_q + ignored_v;
  }
  CHECK(count > 4);
  maggi_motion_jvp(s.D, x.q, x.v, x.p, a.v, a.a);
  maggi_motion_jvp(s.D, y.q, y.v, y.p, b.v, b.a);
  CHECK(memcmp(a.v, b.v, (size_t)s.n * sizeof(double)) == 0);
  CHECK(memcmp(a.a, b.a, (size_t)s.n * sizeof(double)) == 0);
  random_output(&s, &seed, a);
  maggi_motion_hvp(s.D, a.v, a.a, y.q, y.v, y.p, g.q, g.v, g.p);
  maggi_motion_vjp(s.D, a.v, a.a, y.q, y.v, y.p);
  for (i = 0; i < s.n; ++i) {
    if (maggi_coordinate_is_guided(m, i)) CHECK(y.q[i] == 0.0 && g.q[i] == 0.0);
    if (!maggi_coordinate_is_independent(d, i)) CHECK(y.v[i] == 0.0 && g.v[i] == 0.0);
  }
  i = maggi_parameter_find(m, "bodies.a1.joint.velocity");
  CHECK(i >= 0 && y.p[i] == 0.0 && g.p[i] == 0.0);
  free_input(x);
  free_input(y);
  free_input(g);
  free_output(a);
  free_output(b);
  free_point(&s);
  test_free(d, m);
}

/* what is NULL counts as zero, or is not wanted; outputs may be the inputs */
static void test_null(void)
{
  maggi_model *m = machine(2);
  maggi_data *d = test_start(m);
  unsigned long long seed = 4;
  input x, z, g;
  output a, b;
  point s;
  size_t bytes;

  new_point(&s, m, d);
  bytes = (size_t)s.n * sizeof(double);
  CHECK(maggi_linearise(s.D) == MAGGI_OK);
  x = new_input(&s, 1);
  z = new_input(&s, 1); /* zeros */
  g = new_input(&s, 1);
  a = new_output(&s, 1);
  b = new_output(&s, 1);
  random_input(&s, &seed, x);

  maggi_motion_jvp(s.D, x.q, z.v, z.p, a.v, a.a);
  maggi_motion_jvp(s.D, x.q, NULL, NULL, NULL, b.a);
  CHECK(memcmp(a.a, b.a, bytes) == 0);
  maggi_motion_jac(s.D, 1, x.q, NULL, NULL, b.v, NULL);
  CHECK_NEAR(error_of(s.n, b.v, a.v), 0.0, 0.0, 1e-13);
  maggi_motion_jvp(s.D, z.q, z.v, x.p, a.v, a.a);
  maggi_motion_jac(s.D, 1, NULL, NULL, x.p, NULL, b.a);
  CHECK_NEAR(error_of(s.n, b.a, a.a), 0.0, 0.0, 1e-13);
  maggi_motion_jvp(s.D, NULL, x.v, NULL, a.v, a.a);
  maggi_motion_jac(s.D, 1, z.q, x.v, z.p, b.v, b.a);
  CHECK_NEAR(error_of(s.n, b.a, a.a), 0.0, 0.0, 1e-13);
  maggi_motion_jac(s.D, 0, NULL, NULL, NULL, NULL, NULL);

  random_output(&s, &seed, a);
  maggi_motion_vjp(s.D, z.v, a.a, x.q, x.v, x.p);
  maggi_motion_vjp(s.D, NULL, a.a, NULL, NULL, g.p);
  CHECK(memcmp(x.p, g.p, (size_t)s.np * sizeof(double)) == 0);
  maggi_motion_vjp(s.D, NULL, a.a, g.q, NULL, NULL);
  CHECK(memcmp(x.q, g.q, bytes) == 0);

  random_input(&s, &seed, x);
  maggi_motion_hvp(s.D, z.v, a.a, x.q, z.v, z.p, g.q, g.v, g.p);
  maggi_motion_hvp(s.D, NULL, a.a, x.q, NULL, NULL, NULL, z.v, NULL);
  CHECK(memcmp(g.v, z.v, bytes) == 0);
  memset(z.v, 0, bytes);
  maggi_motion_hvp(s.D, NULL, a.a, x.q, z.v, z.p, x.q, z.v, z.p);
  CHECK(memcmp(x.q, g.q, bytes) == 0);
  CHECK(memcmp(z.v, g.v, bytes) == 0);
  CHECK(memcmp(z.p, g.p, (size_t)s.np * sizeof(double)) == 0);
  free_input(x);
  free_input(z);
  free_input(g);
  free_output(a);
  free_output(b);
  free_point(&s);
  test_free(d, m);
}

/* derivatives need a state; a workspace made before it serves as well, and after a new choice of the
 * independent coordinates */
static void test_life(void)
{
  maggi_model *m = test_model(
      "gravity: [0, 0, 0]\n"
      "bodies:\n"
      "- {name: crank, mass: 1, cog: [0.05, 0.1, 0], inertia: {xx: 9, yy: 9, zz: 0.2},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]}}\n"
      "- {name: rod, parent: crank, mass: 0.5, bar: {from: [0, 0.3, 0], to: [0.9539392014169456, 0,"
      " 0]}, joint: {type: revolute, point: [0, 0.3, 0], axis: [0, 0, 1]}}\n"
      "- {name: slider, mass: 0.7, joint: {type: prismatic, axis: [1, 0, 0], velocity: 1.2}}\n"
      "loops: [{name: pin, type: revolute, body_a: rod, body_b: slider,"
      " point: [0.9539392014169456, 0, 0], axis: [0, 0, 1]}]\n");
  maggi_data *d = test_data(m);
  unsigned long long seed = 8;
  maggi_derivative *D;
  double q[3] = {1.0, 0.5, 0.2}, v[3], a[3], v2[3], a2[3];
  long changes;
  point s;
  int k;

  maggi_derivative_free(NULL);
  CHECK(maggi_derivative_create(d, 0, &D) == MAGGI_OK);
  CHECK(maggi_linearise(D) == MAGGI_E_MODEL);
  CHECK(*maggi_data_message(d));
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  for (k = 0; k < 2; ++k) {
    CHECK(maggi_linearise(D) == MAGGI_OK);
    maggi_motion_jvp(D, q, q, NULL, v, a);
    new_point(&s, m, d);
    CHECK(maggi_linearise(s.D) == MAGGI_OK);
    maggi_motion_jvp(s.D, q, q, NULL, v2, a2);
    CHECK(memcmp(v, v2, sizeof v) == 0 && memcmp(a, a2, sizeof a) == 0);
    test_all(&s, &seed);
    free_point(&s);
    changes = test_loops(d).changes;
    while (k == 0 && test_loops(d).changes == changes) test_step(d, 2e-3, 1);
  }
  maggi_derivative_free(D);
  test_free(d, m);
}

/* A step that ends near a singular position is interpolated; its derivatives are those of an
 * evaluation there. */
static void test_singular(void)
{
  maggi_model *m = test_file("n-four-bar-2.yaml");
  maggi_data *d = test_start(m);
  unsigned long long seed = 9;
  point s;
  double h;
  int i;

  for (h = 0.018; h < 0.05 && !d->is_ahead; h += 0.001) {
    CHECK(maggi_data_reset(d) == MAGGI_OK);
    for (i = 0; i < 1000 && !d->is_ahead; ++i) test_step(d, h, 1);
  }
  CHECK(d->is_ahead);
  new_point(&s, m, d);
  CHECK(maggi_linearise(s.D) == MAGGI_OK);
  CHECK(d->is_ahead);
  test_adjoint(&s, &seed);
  test_step(d, 5e-3, 20);
  CHECK(test_loops(d).violation < 1e-9);
  free_point(&s);
  test_free(d, m);
}

int main(void)
{
  test_files();
  test_machines();
  test_inputs();
  test_null();
  test_life();
  test_singular();
  return check_done();
}
