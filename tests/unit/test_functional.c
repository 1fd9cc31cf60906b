/* core/study/term.c, functional.c: objectives of analytic signals: values, order, derivatives. */
#include <float.h>

#include "fixture.h"
#include "functional.h"
#include "term.h"

enum { SAMPLES_MAX = 4001 };

static maggi_grid grid(double time, double step)
{
  maggi_grid g;

  CHECK(maggi_grid_init(&g, time, step) == MAGGI_OK);
  return g;
}

static maggi_term term(maggi_objective_type type)
{
  maggi_term f;

  memset(&f, 0, sizeof f);
  f.type = type;
  f.sharpness = 20.0;
  f.from = f.to = NAN;
  return f;
}

/* of a slope, the other signal; of a term that is none, what must not matter */
static double against(const maggi_term *f, long k)
{
  return f->type == MAGGI_OBJECTIVE_SLOPE ? sin(0.37 * (double)k) + 0.1 * (double)k : NAN;
}

static double pass(maggi_term *f, const maggi_grid *g, const double *s)
{
  long k;

  maggi_term_begin(f, g);
  for (k = 0; k <= g->steps; ++k) maggi_term_push(f, k, s[k], against(f, k));
  maggi_term_end(f);
  return f->value;
}

static double of(maggi_objective_type type, const maggi_grid *g, const double *s)
{
  maggi_term f = term(type);

  return pass(&f, g, s);
}

static void sample(double (*f)(double t), const maggi_grid *g, double *s)
{
  long k;

  for (k = 0; k <= g->steps; ++k) s[k] = f(maggi_grid_time(g, k));
}

static double wave(double t)
{
  return 0.3 + cos(3.0 * t) + 0.5 * t;
}

/* ---------------------------------------------------------------------------------------- values */

static double fast(double t)
{
  return 0.3 + cos(9.0 * t) + 0.5 * t + t * t;
}

/* int of fast, fast^2 and fast^4 over [0, 2] by Simpson's rule */
static double integral(int power)
{
  double sum = 0.0;
  int i, n = 40000;

  for (i = 0; i <= n; ++i)
    sum += pow(fast(2.0 * i / n), power) * (i == 0 || i == n ? 1.0 : i % 2 ? 4.0 : 2.0);
  return sum * 2.0 / n / 3.0;
}

/* each with its exact value, at two steps: order 6 */
static void test_integrals(void)
{
  static const maggi_objective_type type[] = {
      MAGGI_OBJECTIVE_INTEGRAL, MAGGI_OBJECTIVE_INTEGRAL_SQUARE,
      MAGGI_OBJECTIVE_MEAN,     MAGGI_OBJECTIVE_MEAN_SQUARE,
      MAGGI_OBJECTIVE_RMS,      MAGGI_OBJECTIVE_RMQ,
      MAGGI_OBJECTIVE_VDV};
  double I1 = integral(1), I2 = integral(2), I4 = integral(4), s[SAMPLES_MAX], error[3], order;
  double exact[] = {I1, I2, I1 / 2.0, I2 / 2.0, sqrt(I2 / 2.0), pow(I4 / 2.0, 0.25), pow(I4, 0.25)};
  maggi_grid g;
  int i, j;

  CHECK_NEAR(I1, 0.6 + sin(18.0) / 9.0 + 1.0 + 8.0 / 3.0, 1e-13, 0.0);
  for (i = 0; i < 7; ++i) {
    for (j = 0; j < 3; ++j) {
      g = grid(2.0, 0.04 / (1 << j));
      sample(fast, &g, s);
      error[j] = fabs(of(type[i], &g, s) - exact[i]);
    }
    order = log2(error[1] / error[2]);
    CHECK(order > 5.7 && order < 6.5);
    CHECK(error[0] < 1e-3 * exact[i] && error[2] > 1e-11 * exact[i]);
    g = grid(2.0, 0.0006); /* with a shorter last step */
    CHECK(!g.is_multiple);
    sample(fast, &g, s);
    CHECK_NEAR(of(type[i], &g, s), exact[i], 1e-13, 0.0);
  }
}

/* wave' = -3 sin(3t) + 1/2: extrema at 3t = asin(1/6) + 2 pi k, pi - asin(1/6) + 2 pi k */
static void test_extrema(void)
{
  double a = asin(1.0 / 6.0), top = (a + 2.0 * acos(-1.0)) / 3.0, low = (acos(-1.0) - a) / 3.0;
  double s[SAMPLES_MAX], error[3];
  maggi_grid g;
  maggi_term f;
  int j;

  for (j = 0; j < 3; ++j) {
    g = grid(2.5, 0.1 / (1 << j));
    sample(wave, &g, s);
    error[j] = fabs(of(MAGGI_OBJECTIVE_MAXIMUM, &g, s) - wave(top));
    CHECK_NEAR(of(MAGGI_OBJECTIVE_MINIMUM, &g, s), wave(low), 0.0, 1e-5);
    CHECK_NEAR(of(MAGGI_OBJECTIVE_PEAK, &g, s), wave(top), 0.0, 1e-5);
  }
  CHECK(error[0] > error[1] * 16.0 && error[1] > error[2] * 16.0); /* at least of order 4 to 6 */
  g = grid(2.5, 0.001);
  sample(wave, &g, s);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MAXIMUM, &g, s), wave(top), 1e-15, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MINIMUM, &g, s), wave(low), 1e-14, 0.0);
  f = term(MAGGI_OBJECTIVE_PEAK); /* of the other sign, from a target */
  f.target = 3.0;
  CHECK_NEAR(pass(&f, &g, s), 3.0 - wave(low), 1e-15, 0.0);
  f = term(MAGGI_OBJECTIVE_MAXIMUM);
  f.target = 3.0;
  CHECK_NEAR(pass(&f, &g, s), wave(top) - 3.0, 1e-14, 0.0);
  /* at both ends, where the signal rises or falls */
  g = grid(0.7, 0.01);
  sample(wave, &g, s);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MINIMUM, &g, s), wave(0.7), 1e-15, 0.0);
  CHECK(wave(top) > wave(0.0));
}

static void test_values(void)
{
  static const double times[] = {0.0, 0.123, 0.5, 0.50001, 1.99, 2.0};
  double s[SAMPLES_MAX], sum = 0.0, square = 0.0, values[6];
  maggi_grid g = grid(2.0, 0.001);
  maggi_term f = term(MAGGI_OBJECTIVE_VALUE);
  double residual[6];
  char why[100];
  int i;

  sample(wave, &g, s);
  for (i = 0; i < 6; ++i) {
    values[i] = wave(times[i]) - 0.1 * i;
    sum += wave(times[i]) - 0.2;
    square += pow(0.1 * i - 0.2, 2);
  }
  f.number = 6;
  f.times = times;
  f.target = 0.2;
  CHECK_NEAR(pass(&f, &g, s), sum, 1e-14, 0.0);
  f.type = MAGGI_OBJECTIVE_LEAST_SQUARES;
  f.values = values;
  f.residual = residual;
  CHECK_NEAR(pass(&f, &g, s), square / 6.0, 1e-13, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_TERMINAL, &g, s), wave(2.0), 1e-15, 0.0);
  CHECK(maggi_term_reached(&f, &g, why, sizeof why));
  g = grid(1.999, 0.001);
  CHECK(!maggi_term_reached(&f, &g, why, sizeof why));
}

/* log(int exp(k s) dt/T)/k of huge k s, and near the maximum when k is large */
static void test_smooth(void)
{
  double s[SAMPLES_MAX];
  maggi_grid g = grid(2.0, 0.001);
  maggi_term f = term(MAGGI_OBJECTIVE_SMOOTH_MAXIMUM);
  long k;

  for (k = 0; k <= g.steps; ++k) s[k] = 5.0;
  CHECK_NEAR(pass(&f, &g, s), 5.0, 1e-14, 0.0);
  for (k = 0; k <= g.steps; ++k) s[k] = 1e5 * wave(maggi_grid_time(&g, k));
  f.sharpness = 1.0;
  CHECK_NEAR(pass(&f, &g, s), of(MAGGI_OBJECTIVE_MAXIMUM, &g, s), 1e-3, 0.0);
  for (k = 0; k <= g.steps; ++k) s[k] = -1e5 + k; /* always rising: rescaled each time */
  CHECK_NEAR(pass(&f, &g, s), -1e5 + 2000.0 + log(0.001 / 2.0 / (1.0 - exp(-1.0))), 1e-5, 0.0);
  /* int_0^T exp(k t) dt/T = (exp(k T) - 1)/(k T) */
  f.sharpness = 3.0;
  for (k = 0; k <= g.steps; ++k) s[k] = maggi_grid_time(&g, k);
  CHECK_NEAR(pass(&f, &g, s), log((exp(6.0) - 1.0) / 6.0) / 3.0, 1e-13, 0.0);
}

/* ----------------------------------------------------------------------------------- derivatives */

static const double record_times[] = {0.03, 0.11, 0.2}, record_values[] = {1.0, -0.5, 0.7};

static maggi_term full_term(maggi_objective_type type, double *residual)
{
  maggi_term f = term(type);

  f.target = type == MAGGI_OBJECTIVE_PEAK ? 3.0 : 0.07; /* a peak below it */
  f.sharpness = 4.0;
  if (type == MAGGI_OBJECTIVE_VALUE || type == MAGGI_OBJECTIVE_LEAST_SQUARES) {
    f.number = 3;
    f.times = record_times;
    f.values = record_values;
    f.residual = residual;
  }
  return f;
}

/* each sample in turn, by two differences that leave an error of order 4 */
static void check_weights(maggi_objective_type type, const maggi_grid *g, double *s)
{
  double residual[3], weight[64], value[4], scale = 0.0, keep, by_r;
  double h = type >= MAGGI_OBJECTIVE_MAXIMUM && type <= MAGGI_OBJECTIVE_PEAK ? 1e-6 : 1e-3;
  maggi_term f = full_term(type, residual), other = f;
  static const double shift[] = {-2.0, -1.0, 1.0, 2.0};
  long k;
  int i;

  pass(&f, g, s);
  CHECK(maggi_term_no_derivative(&f) == NULL);
  for (k = 0; k <= g->steps; ++k) {
    weight[k] = maggi_term_weight(&f, k, s[k], against(&f, k), &by_r);
    scale = fmax(scale, fabs(weight[k]));
  }
  CHECK(scale > 0.0);
  for (k = 0; k <= g->steps; ++k) {
    keep = s[k];
    for (i = 0; i < 4; ++i) {
      s[k] = keep + shift[i] * h;
      other = full_term(type, residual);
      value[i] = pass(&other, g, s);
    }
    s[k] = keep;
    CHECK_NEAR(weight[k], (8.0 * (value[2] - value[1]) - (value[3] - value[0])) / (12.0 * h), 0.0,
               1e-9 * scale);
  }
}

static void test_weights(void)
{
  double s[64];
  maggi_grid g;
  int type, n, last;

  for (type = 0; type < MAGGI_OBJECTIVE_TYPE_COUNT; ++type) {
    if (type == MAGGI_OBJECTIVE_SUM) continue;
    for (n = 1; n <= 25; n = n < 8 ? n + 1 : n + 17) {
      for (last = 0; last < 4; ++last) { /* last steps: as the others, 0.2, 0.5 and 0.8 of them */
        g = last && n > 1 ? grid(0.2, 0.2 / (n - 1.1 + 0.3 * last)) : grid(0.2, 0.2 / n);
        CHECK(g.steps == n);
        sample(wave, &g, s);
        check_weights((maggi_objective_type)type, &g, s);
      }
    }
  }
}

/* What is linear is equal to the sum of weights times samples, to the last digits; what is
 * homogeneous of degree p has p times itself (Euler). */
static void test_identities(void)
{
  static const double degree[] = {1.0, 2.0, 1.0, 2.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  double s[SAMPLES_MAX], sum, by_r;
  maggi_grid g = grid(2.0, 0.0006);
  maggi_term f;
  long k;
  int type;

  sample(wave, &g, s);
  for (type = 0; type < 10; ++type) {
    f = term((maggi_objective_type)type);
    pass(&f, &g, s);
    sum = 0.0;
    for (k = g.steps; k >= 0; --k)
      sum += maggi_term_weight(&f, k, s[k], against(&f, k), &by_r) * s[k];
    CHECK_NEAR(sum, degree[type] * f.value, 1e-13, 0.0);
  }
  f = term(MAGGI_OBJECTIVE_SMOOTH_MAXIMUM); /* a shift of the signal is one of it */
  pass(&f, &g, s);
  for (k = 0, sum = 0.0; k <= g.steps; ++k)
    sum += maggi_term_weight(&f, k, s[k], against(&f, k), &by_r);
  CHECK_NEAR(sum, 1.0, 1e-13, 0.0);
}

/* position and derivative of a maximum: d/dz of c - (t - z)^2 + b t is b, that of its place by the samples
 * goes around it alone */
static void test_place(void)
{
  double s[SAMPLES_MAX], w, sum = 0.0, first = 0.0, direction = 0.0, by_r;
  maggi_grid g = grid(1.0, 0.01);
  maggi_term f = term(MAGGI_OBJECTIVE_MAXIMUM);
  long k;
  int any = 0;

  for (k = 0; k <= g.steps; ++k) s[k] = 2.0 - pow(maggi_grid_time(&g, k) - 0.4567, 2);
  CHECK_NEAR(pass(&f, &g, s), 2.0, 1e-15, 0.0);
  for (k = 0; k <= g.steps; ++k) {
    w = maggi_term_weight(&f, k, s[k], against(&f, k), &by_r);
    any += w != 0.0;
    sum += w;
    first += w * maggi_grid_time(&g, k);
    direction += w * 2.0 * (maggi_grid_time(&g, k) - 0.4567);
  }
  CHECK(any == 6);
  CHECK_NEAR(sum, 1.0, 1e-14, 0.0);
  CHECK_NEAR(first, 0.4567, 0.0, 1e-11);  /* the position */
  CHECK_NEAR(direction, 0.0, 0.0, 1e-11); /* by z: none, the maximum moves along */
}

/* one sample, no time */
static void test_one(void)
{
  maggi_grid g = {0.0, 0.1, 0, 1};
  double s = 3.0;

  CHECK(of(MAGGI_OBJECTIVE_INTEGRAL, &g, &s) == 0.0);
  CHECK(of(MAGGI_OBJECTIVE_MEAN, &g, &s) == 3.0);
  CHECK(of(MAGGI_OBJECTIVE_RMS, &g, &s) == 3.0);
  CHECK(of(MAGGI_OBJECTIVE_MAXIMUM, &g, &s) == 3.0);
  CHECK(of(MAGGI_OBJECTIVE_MINIMUM, &g, &s) == 3.0);
  CHECK(of(MAGGI_OBJECTIVE_TERMINAL, &g, &s) == 3.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_SMOOTH_MAXIMUM, &g, &s), 3.0, 1e-15, 0.0);
}

/* where a root is of zero there is no derivative, elsewhere of zero there is */
static void test_zero(void)
{
  double s[11] = {0.0};
  maggi_grid g = grid(1.0, 0.1);
  maggi_term f;
  int type, has;

  for (type = 0; type < MAGGI_OBJECTIVE_VALUE; ++type) {
    f = term((maggi_objective_type)type);
    CHECK_NEAR(pass(&f, &g, s), 0.0, 0.0, 1e-16);
    has = type != MAGGI_OBJECTIVE_RMS && type != MAGGI_OBJECTIVE_RMQ &&
          type != MAGGI_OBJECTIVE_VDV && type != MAGGI_OBJECTIVE_PEAK;
    CHECK((maggi_term_no_derivative(&f) == NULL) == has);
  }
}

/* ------------------------------------------------------------------------------------ objectives */

/* g = a^2 b + t */
static double product(void *context, double t, int n, const double *s, double *gradient)
{
  CHECK(n == 2 && *(int *)context == 5);
  gradient[0] = 2.0 * s[0] * s[1];
  gradient[1] = s[0] * s[0];
  return s[0] * s[0] * s[1] + t;
}

static const char *const product_signals[] = {"b.v", "b.q"};

static maggi_model *model(void)
{
  return test_model(
      "bodies: [{name: b, mass: 1, joint: {type: prismatic, axis: [0, 0, 1]}}]\n"
      "objectives:\n"
      "  - {name: area, type: integral, signal: b.q, target: 1}\n"
      "  - {name: size, type: rms, signal: b.v}\n"
      "  - {name: all, type: sum, terms: [area, size, late, none], weights: [2, -3, 1, 0]}\n"
      "  - {name: late, type: value, signal: b.q, times: [0.5, 1]}\n"
      "  - {name: none, type: rms, signal: b.a}\n");
}

static maggi_objective *named(const maggi_model *m, const char *name)
{
  maggi_objective *o;
  char text[200] = "";

  if (!check_true(__FILE__, __LINE__, name,
                  maggi_objective_named(m, name, &o, text, sizeof text) == MAGGI_OK)) {
    fprintf(stderr, "%s\n", text);
    exit(1);
  }
  return o;
}

/* samples of b.q = sin t, b.v = 2 + t, b.a = 0 for the signals of an objective */
static void samples(const maggi_model *m, const maggi_objective *o, double t, double *s)
{
  const int *signal;
  int i, n = maggi_objective_signals(o, &signal);

  for (i = 0; i < n; ++i) {
    const char *name = maggi_signal_name(m, signal[i]);

    s[i] = strcmp(name, "b.q") == 0 ? sin(t) : strcmp(name, "b.v") == 0 ? 2.0 + t : 0.0;
  }
}

static double run(const maggi_model *m, maggi_objective *o, const maggi_grid *g)
{
  double s[4], value = NAN;
  char text[200];
  long k;

  CHECK(maggi_objective_begin(o, g, text, sizeof text) == MAGGI_OK);
  for (k = 0; k <= g->steps; ++k) {
    samples(m, o, maggi_grid_time(g, k), s);
    maggi_objective_push(o, k, s);
  }
  CHECK(maggi_objective_end(o, &value, text, sizeof text) == MAGGI_OK);
  return value;
}

static void test_sum(void)
{
  maggi_model *m = model();
  maggi_grid g = grid(1.0, 0.01);
  maggi_objective *o = named(m, "all");
  double rms = sqrt((27.0 - 8.0) / 3.0), s[4], w[4];
  const int *signal;
  char text[200];
  long k;

  CHECK_NEAR(run(m, o, &g), 2.0 * (1.0 - cos(1.0) - 1.0) - 3.0 * rms + sin(0.5) + sin(1.0), 1e-13,
             0.0);
  CHECK(maggi_objective_signals(o, &signal) == 3);
  CHECK_TEXT(maggi_objective_unit(o), "-");
  /* of the terms with a weight; that of no signal has none */
  CHECK(maggi_objective_differentiable(o, text, sizeof text) == MAGGI_OK);
  for (k = 7; k < 44; ++k) {
    samples(m, o, 0.01 * (double)k, s);
    CHECK(maggi_objective_weights(o, k, s, w));
    CHECK_NEAR(w[0], 2.0 * 0.01, 1e-15, 0.0); /* b.q */
    CHECK_NEAR(w[1], -3.0 * 0.01 * (2.0 + 0.01 * (double)k) / rms, 1e-13, 0.0);
    CHECK(w[2] == 0.0);
  }
  maggi_objective_free(o);
  o = named(m, "none");
  CHECK(run(m, o, &g) == 0.0);
  CHECK(maggi_objective_differentiable(o, text, sizeof text) == MAGGI_E_VALUE);
  CHECK_TEXT(text, "objective \"none\": the root of zero has no derivative");
  maggi_objective_free(o);
  o = named(m, "late");
  g = grid(0.8, 0.01);
  CHECK(maggi_objective_begin(o, &g, text, sizeof text) == MAGGI_E_VALUE);
  CHECK_TEXT(text, "objective \"late\": the simulation ends at 0.8 s, before 1 s");
  /* a sample far from the times has no weight, those of a terminal value neither */
  g = grid(1.0, 0.01);
  run(m, o, &g);
  s[0] = 1.0;
  CHECK(!maggi_objective_weights(o, 30, s, w) && maggi_objective_weights(o, 50, s, w));
  CHECK(w[0] == 1.0);
  maggi_objective_free(o);
  maggi_model_free(m);
}

static void test_function(void)
{
  maggi_model *m = model();
  maggi_grid g = grid(1.0, 0.01);
  maggi_objective_def def;
  maggi_objective *o;
  int context = 5;
  double s[2], w[2], t = 0.3;
  char text[200];

  maggi_objective_def_init(&def);
  def.name = "product";
  def.type = MAGGI_OBJECTIVE_INTEGRAL;
  def.function = product;
  def.context = &context;
  def.nsignal = 2;
  def.signals = product_signals;
  CHECK(maggi_objective_create(m, &def, &o, text, sizeof text) == MAGGI_OK);
  /* int (2 + t)^2 sin t + t = [-(t^2 + 4t + 2) cos t + (2t + 4) sin t] + 1/2 */
  CHECK_NEAR(run(m, o, &g), -7.0 * cos(1.0) + 6.0 * sin(1.0) + 2.0 + 0.5, 1e-12, 0.0);
  samples(m, o, t, s);
  CHECK(maggi_objective_weights(o, 30, s, w));
  CHECK_NEAR(w[0], 0.01 * 2.0 * 2.3 * sin(t), 1e-14, 0.0);
  CHECK_NEAR(w[1], 0.01 * 2.3 * 2.3, 1e-14, 0.0);
  maggi_objective_free(o);
  maggi_model_free(m);
}

/* no number, no value */
static void test_not_finite(void)
{
  maggi_model *m = model();
  maggi_objective *o = named(m, "area");
  maggi_grid g = grid(1.0, 0.5);
  double s[3] = {1.0, NAN, 1.0}, value;
  char text[200];
  long k;

  CHECK(maggi_objective_begin(o, &g, text, sizeof text) == MAGGI_OK);
  for (k = 0; k <= 2; ++k) maggi_objective_push(o, k, &s[k]);
  CHECK(maggi_objective_end(o, &value, text, sizeof text) == MAGGI_E_VALUE);
  CHECK_TEXT(text, "objective \"area\": its value is not finite");
  maggi_objective_free(o);
  maggi_model_free(m);
}

int main(void)
{
  test_integrals();
  test_extrema();
  test_values();
  test_smooth();
  test_weights();
  test_identities();
  test_place();
  test_one();
  test_zero();
  test_sum();
  test_function();
  test_not_finite();
  return check_done();
}
