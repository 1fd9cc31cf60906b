/* core/sensitivity/equilibrium*.c, core/model/compile_start.c, the rolling start: positions that are
 * known, what is held, the search from far away, errors, small motions, gradients. */
#include "data.h"
#include "equilibrium.h"
#include "fixture.h"

/* a mass on a spring over a guided base: z = -m g / k below where the spring is drawn, plus the base */
static void test_spring(void)
{
  maggi_model *m = test_model(
      "start: {equilibrium: true}\n"
      "bodies:\n"
      "  - {name: base, joint: {type: prismatic, axis: [0, 0, 1], motion: lift}}\n"
      "  - {name: mass, parent: base, mass: 3, joint: {type: prismatic, axis: [0, 0, 1], velocity: "
      "2}}\n"
      "springs:\n"
      "  - {name: s, body_a: mass, body_b: base, point_a: [0, 0, 1], point_b: [0, 0, 0],\n"
      "     stiffness: 600, free_length: 1.1, damping: 7}\n"
      "functions:\n"
      "  - {name: lift, type: sine, amplitude: 0.2, omega: 3, phase: 0.5, offset: 0.1}\n");
  maggi_data *d = test_start(m);
  test_state s = test_get(d);
  double force, length, a_q, a_v, mass, shape[2], z = 0.1 - 3.0 * 9.81 / 600.0;
  maggi_equilibrium_state state;
  int coordinate;

  CHECK_NEAR(s.q[1], z, 1e-15, 1e-15);
  CHECK_NEAR(s.q[0], 0.1 + 0.2 * sin(0.5), 1e-15, 1e-15);
  CHECK_NEAR(s.v[0], 0.6 * cos(0.5), 1e-15, 1e-15);
  CHECK_NEAR(s.v[1], 2.0, 0.0, 0.0);
  CHECK(maggi_get_equilibrium(d, &state) == MAGGI_OK);
  CHECK(state.coordinates == 1 && state.iterations > 0 && state.damped == 0);
  CHECK(state.residual < 1e-12);
  CHECK(maggi_equilibrium_get_springs(d, &length, &force) == MAGGI_OK);
  CHECK_NEAR(length, 1.0 + z, 1e-15, 1e-15);
  CHECK_NEAR(force, -3.0 * 9.81, 1e-13, 1e-13);
  CHECK(maggi_equilibrium_motions(d, 1e-6, &coordinate, &a_q, &a_v, &mass, shape) == MAGGI_OK);
  CHECK(coordinate == 1);
  CHECK_NEAR(a_q, -200.0, 1e-12, 1e-12);
  CHECK_NEAR(a_v, -7.0 / 3.0, 1e-12, 1e-12);
  CHECK_NEAR(mass, 3.0, 1e-14, 1e-14);
  CHECK_NEAR(shape[0], 0.0, 0.0, 0.0);
  CHECK_NEAR(shape[1], 1.0, 0.0, 0.0);
  test_free(d, m);
}

/* c1 = 6 in rebound, c3 = 2 in compression, at an equilibrium from which neither moves */
static void test_slopes(void)
{
  maggi_model *m =
      test_model("start: {equilibrium: true}\n"
                 "bodies: [{name: mass, mass: 2, joint: {type: prismatic, axis: [0, 0, 1]}}]\n"
                 "springs:\n"
                 "  - name: s\n"
                 "    body_a: mass\n"
                 "    body_b: ground\n"
                 "    point_a: [0, 0, 1]\n"
                 "    point_b: [0, 0, 0]\n"
                 "    stiffness: 600\n"
                 "    slopes: {c1: 6, c2: 1, c3: 2, c4: 1, v11: 0.1, v22: -0.1}\n");
  maggi_data *d = test_start(m);
  double a_v;

  CHECK(maggi_equilibrium_motions(d, 1e-6, NULL, NULL, &a_v, NULL, NULL) == MAGGI_OK);
  CHECK_NEAR(a_v, -2.0, 1e-12, 1e-12);
  test_free(d, m);
}

/* Pendula drawn level, where Newton cannot begin: hanging after a damped run, the held one stays. */
static void test_far(void)
{
  static const char format[] =
      "start: {equilibrium: true, hold: [%s]}\n"
      "bodies:\n"
      "  - {name: a, mass: 1, cog: [1, 0, 0], joint: {type: revolute, point: [0, 0, 0], "
      "axis: [0, 1, 0], position: %g}}\n"
      "  - {name: b, parent: a, mass: 2, cog: [2, 0, 0],\n"
      "     joint: {type: revolute, point: [1, 0, 0], axis: [0, 1, 0]}}\n";
  maggi_equilibrium_state state;
  maggi_model *m = test_model(format, "", 0.0);
  maggi_data *d = test_start(m);
  test_state s = test_get(d);

  CHECK_NEAR(s.q[0], 0.5 * M_PI, 1e-14, 1e-14);
  CHECK_NEAR(s.q[1], 0.0, 1e-14, 1e-14);
  CHECK(maggi_get_equilibrium(d, &state) == MAGGI_OK);
  CHECK(state.damped > 0);
  test_free(d, m);
  m = test_model(format, "a", 0.3);
  d = test_start(m);
  s = test_get(d);
  CHECK_NEAR(s.q[0], 0.3, 0.0, 0.0);
  CHECK_NEAR(s.q[1], 0.5 * M_PI - 0.3, 1e-14, 1e-14);
  CHECK(test_set(m, d, "bodies.a.joint.position", -0.4));
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  s = test_get(d);
  CHECK_NEAR(s.q[0], -0.4, 0.0, 0.0);
  CHECK_NEAR(s.q[1], 0.5 * M_PI + 0.4, 1e-14, 1e-14);
  test_free(d, m);
}

/* one line of text for a start that cannot be */
static void fails(const char *bodies, const char *text)
{
  maggi_model *m = test_model("start: {equilibrium: true}\n%s", bodies);
  maggi_data *d = test_data(m);
  maggi_equilibrium_state state;

  CHECK(maggi_data_reset(d) == MAGGI_E_ASSEMBLY);
  CHECK_TEXT(maggi_data_message(d), text);
  CHECK(maggi_get_equilibrium(d, &state) == MAGGI_E_MODEL);
  test_free(d, m);
}

static void test_errors(void)
{
  fails("bodies: [{name: stone, mass: 1, joint: {type: prismatic, axis: [0, 0, 1]}}]\n",
        "static equilibrium: not found, \"stone\" still accelerates by -9.81 m/s^2");
  fails("bodies: [{name: puck, mass: 1, joint: {type: prismatic, axis: [0, 1, 0]}}]\n",
        "static equilibrium: nothing holds \"puck\"; name it in start.hold");
}

/* ------------------------------------------------------------------------------------- the vehicle */

/* accelerations of all but what is held vanish with the start's own velocities taken away; wheels carry
 * the weight, less what a sloping road takes */
static void test_vehicle(void)
{
  maggi_model *m = test_file("sprung-frame.yaml");
  maggi_data *d = test_start(m);
  double load[4], sum = 0.0, values[TEST_COLUMNS_MAX];
  maggi_equilibrium_state state;
  int i, kappa = -1;

  CHECK(maggi_get_equilibrium(d, &state) == MAGGI_OK);
  CHECK(state.coordinates == 7 && state.residual < 1e-10);
  CHECK(maggi_equilibrium_get_wheels(d, load) == MAGGI_OK);
  for (i = 0; i < 4; ++i) sum += load[i];
  CHECK_NEAR(sum / sqrt(1.0 + 1e-4), 4834.0 * 9.81, 1e-3, 0.0);
  CHECK_NEAR(test_loops(d).violation, 0.0, 0.0, 1e-14);
  maggi_get_sensors(d, values);
  for (i = 0; maggi_sensor_column_name(m, i); ++i)
    if (strcmp(maggi_sensor_column_name(m, i), "slip.kappa") == 0) kappa = i;
  if (CHECK(kappa >= 0)) CHECK_NEAR(values[kappa], 0.0, 0.0, 1e-15);
  CHECK_TEXT(maggi_wheel_name(m, 0), "fl");
  CHECK_TEXT(maggi_spring_name(m, 1), "rear_l");
  CHECK(!maggi_wheel_name(m, 4) && !maggi_spring_name(m, 4));
  test_free(d, m);
}

/* q, v of the start with parameter i moved by h, after one another */
static void start_moved(maggi_data *d, int i, double h, double *x)
{
  double b = maggi_data_get_parameter(d, i);

  maggi_data_set_parameter(d, i, b + h);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  maggi_get_coordinates(d, x, x + TEST_COORDINATES_MAX, NULL);
  maggi_data_set_parameter(d, i, b);
}

/* largest error of centred differences against the derivatives x, and size of these */
static double compare(maggi_data *d, int i, double h, const double *x, double *size)
{
  static double ahead[2 * TEST_COORDINATES_MAX], behind[2 * TEST_COORDINATES_MAX];
  double error = 0.0;
  int k;

  start_moved(d, i, h, ahead);
  start_moved(d, i, -h, behind);
  for (k = 0; k < 2 * TEST_COORDINATES_MAX; ++k) {
    *size = fmax(*size, fabs(x[k]));
    error = fmax(error, fabs((ahead[k] - behind[k]) / (2.0 * h) - x[k]));
  }
  return error;
}

/* the start by a parameter, against differences at two steps */
static void check_start(const maggi_model *m, const char *path)
{
  maggi_data *d = test_data(m);
  double x[2 * TEST_COORDINATES_MAX] = {0.0}, size = 0.0, h, coarse, fine;
  int i = maggi_parameter_find(m, path);
  maggi_design *design;
  maggi_direct *direct;
  char message[300];

  h = maggi_data_get_parameter(d, i);
  h = 1e-3 * (h != 0.0 ? fabs(h) : 1.0);
  CHECK(maggi_design_create(d, &design) == MAGGI_OK);
  CHECK(maggi_design_select(design, path, message, sizeof message) == MAGGI_OK);
  CHECK(maggi_direct_create(d, design, &direct) == MAGGI_OK);
  CHECK(maggi_direct_reset(direct) == MAGGI_OK);
  maggi_direct_get_coordinates(direct, x, x + TEST_COORDINATES_MAX, NULL);
  coarse = compare(d, i, h, x, &size);
  fine = compare(d, i, 0.5 * h, x, &size);
  check_true(path, 0, "the start moves", size > 0.0);
  check_true(path, 0, "differences are near", fine < 1e-4 * size);
  check_true(path, 0, "with the square of the step", fine < 0.3 * coarse || fine < 1e-7 * size);
  maggi_direct_free(direct);
  maggi_design_free(design);
  maggi_data_free(d);
}

static void test_derivatives(void)
{
  static const char *const path[] = {"gravity.z",
                                     "bodies.chassis.cog.x",
                                     "bodies.chassis.mass",
                                     "bodies.chassis.joint.position.4",
                                     "bodies.chassis.joint.velocity.3",
                                     "bodies.carrier_fl.joint.axis.x",
                                     "rods.pushrod_l.point_a.z",
                                     "springs.rear_r.preload",
                                     "springs.front_l.free_length",
                                     "tyres.truck.vertical_stiffness",
                                     "tyres.truck.freff",
                                     "functions.steering.offset"};
  maggi_model *m = test_file("sprung-frame.yaml");
  size_t i;

  for (i = 0; i < sizeof path / sizeof *path; ++i) check_start(m, path[i]);
  maggi_model_free(m);
}

/* gradients of a short run: direct and adjoint, of both formulations */
static void test_gradient(int is_penalty)
{
  enum { PARAMETERS = 459 };
  static double direct[PARAMETERS], adjoint[PARAMETERS];
  maggi_model *m = test_file("sprung-frame.yaml");
  maggi_data *d = test_data(m);
  maggi_design *design;
  maggi_objective *objective;
  maggi_gradient_options options;
  maggi_penalty_options penalty;
  char message[300];
  double value, scale, size = 0.0, error = 0.0;
  int i, n;

  maggi_penalty_options_init(&penalty);
  maggi_gradient_options_init(&options);
  options.time = 0.02;
  options.step = 1e-3;
  options.penalty = is_penalty ? &penalty : NULL;
  CHECK(maggi_design_create(d, &design) == MAGGI_OK);
  CHECK(maggi_design_select(design, "all", message, sizeof message) == MAGGI_OK);
  n = maggi_design_number(design);
  CHECK(maggi_objective_named(m, "terminal(wheel_rr.v)", &objective, message, sizeof message) ==
        MAGGI_OK);
  if (CHECK(n == PARAMETERS)) {
    options.method = MAGGI_METHOD_DIRECT;
    CHECK(maggi_gradient(d, design, 1, &objective, &options, &value, direct) == MAGGI_OK);
    options.method = MAGGI_METHOD_ADJOINT;
    CHECK(maggi_gradient(d, design, 1, &objective, &options, &value, adjoint) == MAGGI_OK);
  }
  for (i = 0; i < n; ++i) {
    scale = fabs(maggi_design_value(design, i));
    scale = scale > 0.0 ? scale : 1.0;
    size = fmax(size, scale * fabs(adjoint[i]));
    error = fmax(error, scale * fabs(direct[i] - adjoint[i]));
  }
  CHECK(size > 1.0);
  CHECK_NEAR(error / size, 0.0, 0.0, 1e-10);
  maggi_objective_free(objective);
  maggi_design_free(design);
  test_free(d, m);
}

/* a wheel with its centre at [0, 0, 0.5] on a joint; NULL when that is refused, with the text of it */
static maggi_model *unicycle(const char *joint, char *message, size_t n)
{
  char text[2000];
  maggi_model *m;

  snprintf(text, sizeof text,
           "format: maggi\nversion: 1\nname: test\nstart: {rolling: true}\n"
           "bodies:\n"
           "  - {name: sledge, mass: 1, joint: {type: prismatic, axis: [1, 0, 0]}}\n"
           "  - {name: wheel, parent: sledge, mass: 1, inertia: {xx: 1, yy: 1, zz: 1}, joint: %s}\n"
           "tyres: [{name: t, file: tyres/pac2002_315_80R22_5.tir}]\n"
           "roads: [{name: r, type: flat}]\n"
           "wheels:\n"
           "  - {name: w, body: wheel, carrier: sledge, tyre: t, road: r, side: left, point: [0, "
           "0, 0.5]}\n",
           joint);
  maggi_model_load_memory(MAGGI_MODELS_DIR "/test", text, strlen(text), &m, message, n);
  return m;
}

static void test_rolling_errors(void)
{
  char message[512];
  maggi_model *m = unicycle("{type: prismatic, axis: [0, 1, 0]}", message, sizeof message);
  maggi_data *d;

  if (CHECK(!m))
    CHECK_TEXT(
        message + strlen(MAGGI_MODELS_DIR "/"),
        "test:11: wheels.w: a wheel that starts rolling needs a body that turns on its carrier "
        "by a revolute joint");
  m = unicycle("{type: revolute, point: [0, 0, 0.6], axis: [0, 1, 0]}", message, sizeof message);
  if (!CHECK(m)) return;
  d = test_data(m);
  CHECK(maggi_data_reset(d) == MAGGI_E_ASSEMBLY);
  CHECK_TEXT(maggi_data_message(d),
             "\"wheel\" cannot start rolling: the centre of a wheel on it is not on its axis");
  test_free(d, m);
}

/* ---------------------------------------------------------------------------------------- factors */

static void test_dense(void)
{
  static const double a[9] = {1e-3, 2e-3, 0.0, 3e5, -1e5, 4e5, 0.0, 7.0, 1.0};
  static const double singular[9] = {1.0, 2.0, 0.0, 2.0, 4.0, 1e3, 0.0, 0.0, 1.0};
  double x[3] = {1.0, -2.0, 3.0}, y[3] = {0.0}, z[3] = {0.0};
  maggi_dense f;
  int i, k;

  CHECK(maggi_dense_create(&f, 3));
  CHECK(maggi_dense_factor(&f, 3, a));
  for (i = 0; i < 3; ++i)
    for (k = 0; k < 3; ++k) {
      y[i] += a[3 * i + k] * x[k];
      z[k] += a[3 * i + k] * x[i];
    }
  maggi_dense_solve(&f, y);
  maggi_dense_solve_transposed(&f, z);
  for (i = 0; i < 3; ++i) {
    CHECK_NEAR(y[i], x[i], 1e-14, 1e-14);
    CHECK_NEAR(z[i], x[i], 1e-6, 0.0);
  }
  CHECK(!maggi_dense_factor(&f, 3, singular));
  CHECK_NEAR(f.work[0], -2.0 * f.work[1], 1e-15, 1e-15);
  maggi_dense_free(&f);
}

int main(void)
{
  test_spring();
  test_slopes();
  test_far();
  test_errors();
  test_vehicle();
  test_derivatives();
  test_gradient(0);
  test_gradient(1);
  test_rolling_errors();
  test_dense();
  return check_done();
}
