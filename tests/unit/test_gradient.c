/* core/study/ *gradient.c, core/sensitivity/{tape,reversal,discrete}.c: the methods against each other,
 * snapshots, memory, what cannot be done. */
#include "checkpoint.h"
#include "data.h"
#include "fixture.h"

enum { OBJECTIVES = 4, PARAMETERS_MAX = 400 };

typedef struct study {
  maggi_model *m;
  maggi_data *d;
  maggi_design *design;
  maggi_objective *objective[OBJECTIVES];
  maggi_gradient_options options;
  int n; /* design parameters */
  double value[OBJECTIVES], gradient[OBJECTIVES * PARAMETERS_MAX];
} study;

static study begin(maggi_model *m, const char *parameters, double time, double step)
{
  static const char *const signal[] = {"rms(energy.kinetic)", "terminal(%s.q)", "maximum(%s.v)",
                                       "mean(%s.a)"};
  study s = {.m = m, .d = test_data(m)};
  char text[128], message[256];
  int i;

  maggi_gradient_options_init(&s.options);
  s.options.time = time;
  s.options.step = step;
  CHECK(maggi_design_create(s.d, &s.design) == MAGGI_OK);
  CHECK(maggi_design_select(s.design, parameters, message, sizeof message) == MAGGI_OK);
  s.n = maggi_design_number(s.design);
  if (!CHECK(s.n > 0 && s.n <= PARAMETERS_MAX)) exit(1);
  for (i = 0; i < OBJECTIVES; ++i) {
    snprintf(text, sizeof text, signal[i], maggi_coordinate_name(m, test_coordinates(m) - 1));
    CHECK(maggi_objective_named(m, text, &s.objective[i], message, sizeof message) == MAGGI_OK);
  }
  return s;
}

static void end(study *s)
{
  int i;

  for (i = 0; i < OBJECTIVES; ++i) maggi_objective_free(s->objective[i]);
  maggi_design_free(s->design);
  test_free(s->d, s->m);
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

/* largest distance of two gradients of one objective, parameters in their size */
static double distance(const study *s, const double *a, const double *b)
{
  double error = 0.0, size = 0.0, scale;
  int i;

  for (i = 0; i < s->n; ++i) {
    scale = fabs(maggi_design_value(s->design, i));
    scale = scale > 0.0 ? scale : 1.0;
    if (!isfinite(a[i])) return NAN;
    error = fmax(error, scale * fabs(a[i] - b[i]));
    size = fmax(size, scale * fabs(b[i]));
  }
  CHECK(size > 0.0);
  return error / size;
}

/* ------------------------------------------------------------------------- methods and snapshots */

static void check_model(maggi_model *m, const char *parameters, double time, double step,
                        double limit)
{
  study s = begin(m, parameters, time, step);
  size_t bytes = (size_t)(OBJECTIVES * s.n) * sizeof(double);
  double direct[OBJECTIVES * PARAMETERS_MAX], value[OBJECTIVES];
  static const int snapshots[] = {1, 2, 5, 1000};
  long l;
  int i;

  must_run(&s, MAGGI_METHOD_DIRECT);
  memcpy(direct, s.gradient, bytes);
  memcpy(value, s.value, sizeof value);

  /* without room for the samples: one simulation before */
  s.options.memory = 64;
  must_run(&s, MAGGI_METHOD_DIRECT);
  CHECK(memcmp(direct, s.gradient, bytes) == 0);
  CHECK(memcmp(value, s.value, sizeof value) == 0);
  maggi_gradient_options_init(&s.options);
  s.options.time = time;
  s.options.step = step;

  must_run(&s, MAGGI_METHOD_ADJOINT);
  CHECK(memcmp(value, s.value, sizeof value) == 0);
  for (i = 0; i < OBJECTIVES; ++i)
    CHECK_NEAR(distance(&s, s.gradient + i * s.n, direct + i * s.n), 0.0, 0.0, limit);
  memcpy(direct, s.gradient, bytes);
  l = s.options.steps;
  for (i = 0; i < 4; ++i) {
    if (snapshots[i] == 1 && l > 300) continue;
    s.options.snapshots = snapshots[i];
    must_run(&s, MAGGI_METHOD_ADJOINT);
    CHECK(memcmp(direct, s.gradient, bytes) == 0);
    CHECK(memcmp(value, s.value, sizeof value) == 0);
    CHECK(s.options.recomputed == maggi_schedule_cost(l, snapshots[i]) - (l - 1));
    CHECK(s.options.kept <= snapshots[i]);
  }
  /* as many as there is room for */
  s.options.snapshots = 0;
  s.options.memory = 7 * maggi_snapshot_size(&s.d->t);
  must_run(&s, MAGGI_METHOD_ADJOINT);
  CHECK(memcmp(direct, s.gradient, bytes) == 0);
  CHECK(s.options.kept == 7);
  end(&s);
}

/* ------------------------------------------------------------------------------------ differences */

static void test_differences(void)
{
  study s = begin(test_file("double-pendulum.yaml"), "bodies.bar1.*", 0.5, 0.01);
  double adjoint[OBJECTIVES * PARAMETERS_MAX], error[3];
  int i, method;

  must_run(&s, MAGGI_METHOD_ADJOINT);
  memcpy(adjoint, s.gradient, sizeof adjoint);
  for (i = 0; i < OBJECTIVES; ++i) {
    for (method = 0; method < 3; ++method) {
      s.options.perturbation = 1e-5;
      must_run(&s, MAGGI_METHOD_DIFFERENCE + method);
      error[method] = distance(&s, s.gradient + i * s.n, adjoint + i * s.n);
    }
    CHECK(error[0] < 1e-8);
    CHECK(error[1] > 10.0 * error[0] && error[1] < 1e-3);
    /* one over, one under by the same */
    CHECK_NEAR(error[2], error[1], 0.02, 0.0);
  }
  /* parameters are as they were */
  for (i = 0; i < s.d->t.np; ++i) CHECK(s.d->p[i] == maggi_parameter_default(s.m, i));
  end(&s);
}

/* --------------------------------------------------------------------------------- what goes wrong */

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
  study s = begin(test_file("four-bar.yaml"), "bodies.crank.mass", 0.2, 0.01);
  double last;
  int method;

  for (method = 0; method < MAGGI_METHOD_COUNT; ++method) {
    last = 0.0;
    s.options.context = &last;
    s.options.progress = stop_at_half;
    CHECK(run(&s, (maggi_method)method) == MAGGI_E_STOPPED);
    CHECK(last > 0.5 && last < 0.7);
    s.options.progress = look;
    must_run(&s, (maggi_method)method);
    CHECK_NEAR(last, 1.0, 1e-12, 0.0);
  }
  end(&s);
}

static void test_refusals(void)
{
  study s = begin(test_file("four-bar.yaml"), "bodies.crank.mass", 0.2, 0.01);
  char message[256];
  int method;

  s.options.step = 0.0;
  CHECK(run(&s, MAGGI_METHOD_ADJOINT) == MAGGI_E_VALUE);
  CHECK_TEXT(maggi_data_message(s.d), "time and step must be positive, with at most 1e9 steps");
  s.options.step = 0.01;
  s.options.perturbation = 0.0;
  CHECK(run(&s, MAGGI_METHOD_DIFFERENCE) == MAGGI_E_VALUE);
  CHECK_TEXT(maggi_data_message(s.d), "the perturbation must be positive");
  s.options.perturbation = 1e-6;
  s.options.snapshots = -1;
  CHECK(run(&s, MAGGI_METHOD_ADJOINT) == MAGGI_E_VALUE);
  s.options.snapshots = 0;
  CHECK(run(&s, MAGGI_METHOD_COUNT) == MAGGI_E_VALUE);
  /* the second angle of the universal joint stays zero: a root of zero */
  maggi_objective_free(s.objective[0]);
  CHECK(maggi_objective_named(s.m, "rms(coupler.2.q)", &s.objective[0], message, sizeof message) ==
        MAGGI_OK);
  for (method = 0; method < MAGGI_METHOD_COUNT; ++method) {
    CHECK(run(&s, (maggi_method)method) == MAGGI_E_VALUE);
    CHECK_TEXT(maggi_data_message(s.d),
               "objective \"rms(coupler.2.q)\": the root of zero has no derivative");
  }
  end(&s);
}

int main(void)
{
  maggi_model *m;

  check_model(test_file("pendulum.yaml"), "all", 0.4, 0.01, 1e-12);
  check_model(test_file("double-pendulum.yaml"), "all", 1.0, 0.01, 1e-12);
  check_model(test_file("four-bar.yaml"), "all", 1.005, 0.01, 1e-12);
  check_model(test_file("triple-pendulum-closed.yaml"), "all", 0.8, 0.004, 1e-12);
  check_model(test_file("rssr.yaml"), "all", 1.0, 0.004, 1e-12);
  /* through positions in which a row lies flat: pivots of 1e-3, twice inverted, take digits */
  CHECK(maggi_model_multiple_four_bar(1, 15, &m) == MAGGI_OK);
  check_model(m, "bodies.v_1_*", 1.53, 0.003, 2e-8);
  test_differences();
  test_progress();
  test_refusals();
  return check_done();
}
