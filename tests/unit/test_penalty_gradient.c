/* core/implicit/penalty_*.c, core/study/penalty_gradient.c: gradients of the penalty formulation,
 * direct against adjoint, against differences of runs that are converged further, and against the
 * Maggi formulation as the step goes to zero. */
#include "machine.h"

enum { OBJECTIVES = 6, PARAMETERS_MAX = 400 };

typedef struct study {
  maggi_model *m;
  maggi_data *d;
  maggi_design *design;
  maggi_objective *objective[OBJECTIVES];
  maggi_gradient_options options;
  maggi_penalty_options penalty;
  int n; /* design parameters */
  double value[OBJECTIVES], gradient[OBJECTIVES * PARAMETERS_MAX];
} study;

/* objectives of the energy, of the last coordinate, of the first joint's force along an axis, and
 * of a coordinate that is guided, if there is one of that name */
static study *begin(maggi_model *m, char axis, const char *parameters, double time, double step)
{
  static const char *const text[OBJECTIVES] = {"rms(energy.kinetic)", "terminal(%s.q)",
                                               "maximum(%s.v)",       "mean(%s.a)",
                                               "rms(%s.f%c)",         "mean_square(%s)"};
  study *s = calloc(1, sizeof *s);
  const char *name;
  char line[128], message[256];
  int i;

  if (!s) exit(1);
  s->m = m;
  s->d = test_data(m);
  maggi_gradient_options_init(&s->options);
  maggi_penalty_options_init(&s->penalty);
  s->options.time = time;
  s->options.step = step;
  s->options.penalty = &s->penalty;
  CHECK(maggi_design_create(s->d, &s->design) == MAGGI_OK);
  CHECK(maggi_design_select(s->design, parameters, message, sizeof message) == MAGGI_OK);
  s->n = maggi_design_number(s->design);
  if (!CHECK(s->n > 0 && s->n <= PARAMETERS_MAX)) exit(1);
  for (i = 0; i < OBJECTIVES; ++i) {
    name = maggi_coordinate_name(m, test_coordinates(m) - 1);
    if (i == 4) name = maggi_body_name(m, 0);
    if (i == 5) name = maggi_coordinate_find(m, "arm") >= 0 ? "arm.a" : "energy.total";
    snprintf(line, sizeof line, text[i], name, axis);
    CHECK(maggi_objective_named(m, line, &s->objective[i], message, sizeof message) == MAGGI_OK);
  }
  return s;
}

static void end(study *s)
{
  int i;

  for (i = 0; i < OBJECTIVES; ++i) maggi_objective_free(s->objective[i]);
  maggi_design_free(s->design);
  test_free(s->d, s->m);
  free(s);
}

static maggi_status run(study *s, maggi_method method)
{
  s->options.method = method;
  return maggi_gradient(s->d, s->design, OBJECTIVES, s->objective, &s->options, s->value,
                        s->gradient);
}

static void must_run(study *s, maggi_method method)
{
  if (!CHECK(run(s, method) == MAGGI_OK)) fprintf(stderr, "%s\n", maggi_data_message(s->d));
}

/* largest distance of two gradients of objective i, parameters in their size */
static double distance(const study *s, int i, const double *a, const double *b)
{
  double error = 0.0, size = 0.0, scale;
  int j;

  a += i * s->n;
  b += i * s->n;
  for (j = 0; j < s->n; ++j) {
    scale = fabs(maggi_design_value(s->design, j));
    scale = scale > 0.0 ? scale : 1.0;
    if (!isfinite(a[j])) return NAN;
    error = fmax(error, scale * fabs(a[j] - b[j]));
    size = fmax(size, scale * fabs(b[j]));
  }
  CHECK(size > 0.0);
  return error / size;
}

static void check_distance(const char *name, const study *s, const double *a, const double *b,
                           double limit)
{
  double x;
  int i;

  for (i = 0; i < OBJECTIVES; ++i) {
    x = distance(s, i, a, b);
    if (!CHECK_NEAR(x, 0.0, 0.0, limit)) fprintf(stderr, "  %s: objective %d\n", name, i);
  }
}

/* --------------------------------------------------------------------------- direct and adjoint */

static void check_methods(const char *name, maggi_model *m, char axis, double time, double step,
                          double alpha)
{
  study *s = begin(m, axis, "all", time, step);
  size_t bytes = (size_t)(OBJECTIVES * s->n) * sizeof(double);
  static double direct[OBJECTIVES * PARAMETERS_MAX];
  double value[OBJECTIVES];

  s->penalty.penalty = alpha;
  must_run(s, MAGGI_METHOD_DIRECT);
  memcpy(direct, s->gradient, bytes);
  memcpy(value, s->value, sizeof value);

  /* without room for the samples: one simulation before */
  s->options.memory = 64;
  must_run(s, MAGGI_METHOD_DIRECT);
  CHECK(memcmp(direct, s->gradient, bytes) == 0);
  CHECK(memcmp(value, s->value, sizeof value) == 0);
  CHECK(run(s, MAGGI_METHOD_ADJOINT) == MAGGI_E_MEMORY);
  CHECK_TEXT(maggi_data_message(s->d),
             "the states of the simulation do not fit into the memory allowed");

  s->options.memory = (size_t)1 << 30;
  must_run(s, MAGGI_METHOD_ADJOINT);
  CHECK(memcmp(value, s->value, sizeof value) == 0);
  CHECK(s->options.kept == s->options.steps && s->options.recomputed == 0);
  check_distance(name, s, s->gradient, direct, 1e-10);
  memcpy(direct, s->gradient, bytes);
  must_run(s, MAGGI_METHOD_ADJOINT);
  CHECK(memcmp(direct, s->gradient, bytes) == 0);

  /* the last objective alone, which needs no forces */
  s->options.method = MAGGI_METHOD_DIRECT;
  CHECK(maggi_gradient(s->d, s->design, 1, s->objective + OBJECTIVES - 1, &s->options, s->value,
                       s->gradient + (OBJECTIVES - 1) * s->n) == MAGGI_OK);
  check_distance(name, s, s->gradient, direct, 1e-10);
  end(s);
}

/* ---------------------------------------------------------------------------------- differences */

/* differences of three steps, extrapolated twice */
static void check_differences(const char *name, maggi_model *m, const char *parameters, double time,
                              double step)
{
  static const double weight[] = {1.0 / 45.0, -20.0 / 45.0, 64.0 / 45.0};
  static double adjoint[OBJECTIVES * PARAMETERS_MAX], difference[OBJECTIVES * PARAMETERS_MAX];
  study *s = begin(m, 'z', parameters, time, step);
  int i, k, n = OBJECTIVES * s->n;

  s->penalty.penalty = 1e7;
  s->penalty.tolerance = 1e-13;
  must_run(s, MAGGI_METHOD_ADJOINT);
  memcpy(adjoint, s->gradient, (size_t)n * sizeof(double));
  memset(difference, 0, (size_t)n * sizeof(double));
  for (k = 0; k < 3; ++k) {
    s->options.perturbation = 1e-3 / (1 << k);
    must_run(s, MAGGI_METHOD_DIFFERENCE);
    for (i = 0; i < n; ++i) difference[i] += weight[k] * s->gradient[i];
  }
  check_distance(name, s, adjoint, difference, 1e-8);
  end(s);
}

/* ---------------------------------------------------------------- against the Maggi formulation */

static void check_order(const char *name, maggi_model *m, double time, double step)
{
  static double x[4][OBJECTIVES * PARAMETERS_MAX];
  study *s = begin(m, 'z', "all", time, step);
  size_t bytes = (size_t)(OBJECTIVES * s->n) * sizeof(double);
  double e[3];
  int i, k;

  s->penalty.penalty = 1e11;
  for (k = 0; k < 4; ++k) {
    s->options.penalty = k < 3 ? &s->penalty : NULL;
    s->options.step = step / (1 << (k < 3 ? k : 4));
    must_run(s, MAGGI_METHOD_ADJOINT);
    memcpy(x[k], s->gradient, bytes);
  }
  for (i = 0; i < OBJECTIVES; ++i) {
    for (k = 0; k < 3; ++k) e[k] = distance(s, i, x[k], x[3]);
    if (check_scale() == 0.0)
      printf("%s: objective %d: error %.3g, ratios %.3f %.3f\n", name, i, e[0], e[0] / e[1],
             e[1] / e[2]);
    if (e[0] < 1e-9) continue; /* of a function of time */
    if (!CHECK(e[1] / e[2] > 3.9 && e[1] / e[2] < 4.1 && e[2] < 1e-3))
      fprintf(stderr, "  %s: objective %d: %.3g %.3g %.3g\n", name, i, e[0], e[1], e[2]);
  }
  end(s);
}

/* ------------------------------------------------------------------------------ what goes wrong */

static int stop_at_half(void *context, double part)
{
  double *last = context;

  CHECK(part >= *last && part <= 1.0 + 1e-12);
  *last = part;
  return part > 0.5;
}

static int look(void *context, double part)
{
  *(double *)context = part;
  return 0;
}

static void test_progress(void)
{
  static const maggi_method method[] = {MAGGI_METHOD_DIRECT, MAGGI_METHOD_ADJOINT,
                                        MAGGI_METHOD_DIFFERENCE};
  study *s = begin(test_file("four-bar.yaml"), 'z', "bodies.crank.mass", 0.2, 0.01);
  double last;
  int i;

  for (i = 0; i < 3; ++i) {
    last = 0.0;
    s->options.context = &last;
    s->options.progress = stop_at_half;
    CHECK(run(s, method[i]) == MAGGI_E_STOPPED);
    CHECK(last > 0.5 && last < 0.7);
    s->options.progress = look;
    must_run(s, method[i]);
    CHECK_NEAR(last, 1.0, 1e-12, 0.0);
  }
  end(s);
}

static void test_refusals(void)
{
  study *s = begin(test_file("four-bar.yaml"), 'z', "bodies.crank.mass", 0.2, 0.01);
  static const maggi_method method[] = {MAGGI_METHOD_DIRECT, MAGGI_METHOD_ADJOINT};
  char message[256];
  int i;

  CHECK(run(s, MAGGI_METHOD_CONTINUOUS_ADJOINT) == MAGGI_E_VALUE);
  CHECK_TEXT(maggi_data_message(s->d), "the continuous adjoint method has no penalty formulation");
  s->penalty.penalty = -1.0;
  CHECK(run(s, MAGGI_METHOD_DIRECT) == MAGGI_E_VALUE);
  CHECK_TEXT(maggi_data_message(s->d), "the penalty must be positive");
  maggi_penalty_options_init(&s->penalty);
  s->options.time = 20.0;
  s->options.step = 4.0;
  for (i = 0; i < 2; ++i) {
    CHECK(run(s, method[i]) == MAGGI_E_NOT_FINITE);
    CHECK(strstr(maggi_data_message(s->d), "is the step too large?") != NULL);
  }
  s->options.time = 0.2;
  s->options.step = 0.01;
  /* the second angle of the universal joint stays zero: a root of zero */
  maggi_objective_free(s->objective[0]);
  CHECK(maggi_objective_named(s->m, "rms(coupler.2.q)", &s->objective[0], message,
                              sizeof message) == MAGGI_OK);
  for (i = 0; i < 2; ++i) {
    CHECK(run(s, method[i]) == MAGGI_E_VALUE);
    CHECK_TEXT(maggi_data_message(s->d),
               "objective \"rms(coupler.2.q)\": the root of zero has no derivative");
  }
  end(s);
}

int main(void)
{
  static const char closed[] = "triple-pendulum-closed.yaml";
  maggi_model *m;

  check_methods("pendulum", test_file("pendulum.yaml"), 'y', 0.4, 0.01, 1e9);
  check_methods("double-pendulum", test_file("double-pendulum.yaml"), 'z', 1.0, 0.01, 1e9);
  check_methods("four-bar", test_file("four-bar.yaml"), 'z', 1.005, 0.01, 1e9);
  check_methods("rssr", test_file("rssr.yaml"), 'z', 1.0, 0.01, 1e9);
  check_methods("andrews", test_file("andrews.yaml"), 'y', 0.01, 1e-4, 1e9);
  check_methods("machine", machine_model(), 'z', 1.0, 0.01, 1e9);
  m = test_model(
      "bodies:\n"
      "- {name: arm, mass: 1, joint: {type: prismatic, axis: [0, 1, 0], motion: f}}\n"
      "- {name: bob, parent: arm, mass: 2, cog: [0, 0.2, -0.4], inertia: {xx: 0.1, yy: 0.1},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0]}}\n"
      "functions: [{name: f, type: sine, amplitude: 0.2, omega: 4, phase: 0.3, offset: 0}]\n");
  check_methods("cart", m, 'z', 1.0, 0.01, 1e9);
  /* redundant loops, which geometry opens: derivatives are as large as alpha */
  check_methods("triple-pendulum-closed", test_file(closed), 'z', 0.8, 0.01, 1e8);
  check_methods("bricard", test_file("bricard.yaml"), 'z', 0.8, 0.01, 1e8);
  CHECK(maggi_model_multiple_four_bar(1, 5, &m) == MAGGI_OK);
  check_methods("array", m, 'z', 1.0, 0.02, 1e8);

  check_differences("double-pendulum", test_file("double-pendulum.yaml"), "bodies.bar1.*", 0.5,
                    0.02);
  check_differences("four-bar", test_file("four-bar.yaml"), "bodies.*", 0.5, 0.02);
  check_differences("triple-pendulum-closed", test_file(closed), "bodies.bar3.*", 0.5, 0.02);
  check_differences("rssr", test_file("rssr.yaml"), "rods.*", 0.5, 0.02);
  check_differences("machine", machine_model(), "all", 0.3, 0.01);

  check_order("double-pendulum", test_file("double-pendulum.yaml"), 0.5, 0.01);
  check_order("four-bar", test_file("four-bar.yaml"), 0.5, 0.01);
  check_order("triple-pendulum-closed", test_file(closed), 0.5, 0.005);
  check_order("rssr", test_file("rssr.yaml"), 0.5, 0.01);
  check_order("machine", machine_model(), 0.3, 0.005);

  test_progress();
  test_refusals();
  return check_done();
}
