/* core/study/window.c, slope.c, term.c: parts of a simulation, references, norm, violation and slope. */
#include "fixture.h"
#include "functional.h"
#include "term.h"

enum { SAMPLES_MAX = 2001 };

static maggi_grid grid(double time, double step)
{
  maggi_grid g;

  CHECK(maggi_grid_init(&g, time, step) == MAGGI_OK);
  return g;
}

static maggi_term term(maggi_objective_type type, double from, double to)
{
  maggi_term f;

  memset(&f, 0, sizeof f);
  f.type = type;
  f.sharpness = 5.0;
  f.from = from;
  f.to = to;
  return f;
}

static double pass(maggi_term *f, const maggi_grid *g, const double *s, const double *r)
{
  long k;

  maggi_term_begin(f, g);
  for (k = 0; k <= g->steps; ++k) maggi_term_push(f, k, s[k], r[k]);
  maggi_term_end(f);
  return f->value;
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

static double other(double t)
{
  return sin(2.0 * t) - 0.4 * t;
}

/* int of f(wave, other) from a to b, by Gauss's rule on many pieces */
typedef double (*integrand)(double s, double r);

static double integral(integrand f, double a, double b)
{
  static const double point[] = {0.11270166537925831, 0.5, 0.88729833462074169};
  static const double share[] = {5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0};
  double sum = 0.0, t, h = (b - a) / 2000;
  int i, j;

  for (i = 0; i < 2000; ++i)
    for (j = 0; j < 3; ++j) {
      t = a + (i + point[j]) * h;
      sum += share[j] * h * f(wave(t), other(t));
    }
  return sum;
}

static double one(double s, double r)
{
  (void)r;
  return s;
}
static double two(double s, double r)
{
  (void)r;
  return s * s;
}
static double four(double s, double r)
{
  (void)r;
  return s * s * s * s;
}
static double smooth(double s, double r)
{
  (void)r;
  return exp(5.0 * s);
}
static double only_r(double s, double r)
{
  (void)s;
  return r;
}
static double square_r(double s, double r)
{
  (void)s;
  return r * r;
}
static double both(double s, double r)
{
  return s * r;
}
static double end;
static double less_two(double s, double r)
{
  (void)r;
  return (s - end) * (s - end);
}
static double less_four(double s, double r)
{
  return less_two(s, r) * less_two(s, r);
}

static double s[SAMPLES_MAX], r[SAMPLES_MAX];

static double of(maggi_objective_type type, maggi_reference_type reference, double a, double b,
                 const maggi_grid *g)
{
  maggi_term f = term(type, a, b);

  f.reference = reference;
  return pass(&f, g, s, r);
}

/* a window anywhere, its ends on samples, between them, at the ends of the simulation */
static void check_values(double a, double b, const maggi_grid *g)
{
  double T = b - a, I1 = integral(one, a, b), I2 = integral(two, a, b), I4 = integral(four, a, b);
  double R1 = integral(only_r, a, b), R2 = integral(square_r, a, b), RS = integral(both, a, b);

  CHECK_NEAR(of(MAGGI_OBJECTIVE_INTEGRAL, 0, a, b, g), I1, 1e-12, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_INTEGRAL_SQUARE, 0, a, b, g), I2, 1e-12, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MEAN, 0, a, b, g), I1 / T, 1e-12, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MEAN_SQUARE, 0, a, b, g), I2 / T, 1e-12, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_RMS, 0, a, b, g), sqrt(I2 / T), 1e-12, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_NORM, 0, a, b, g), sqrt(I2), 1e-12, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_RMQ, 0, a, b, g), pow(I4 / T, 0.25), 1e-12, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_VDV, 0, a, b, g), pow(I4, 0.25), 1e-12, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_SMOOTH_MAXIMUM, 0, a, b, g), log(integral(smooth, a, b) / T) / 5.0,
             1e-11, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_TERMINAL, 0, NAN, b, g), wave(b), 1e-13, 1e-15);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_SLOPE, 0, a, b, g), (T * RS - R1 * I1) / (T * R2 - R1 * R1), 1e-9,
             0.0);
  end = wave(b);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_NORM, MAGGI_REFERENCE_FINAL, a, b, g),
             sqrt(integral(less_two, a, b)), 1e-11, 1e-13);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_VDV, MAGGI_REFERENCE_FINAL, a, b, g),
             pow(integral(less_four, a, b), 0.25), 1e-9, 3e-8); /* few samples: the rule's */
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MEAN, MAGGI_REFERENCE_FINAL, a, b, g), I1 / T - end, 1e-11, 0.0);
  end = wave(a);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MEAN_SQUARE, MAGGI_REFERENCE_INITIAL, a, b, g),
             integral(less_two, a, b) / T, 1e-11, 1e-14);
}

static void test_values(void)
{
  static const double step[] = {0.002, 0.00193};
  maggi_grid g;
  int i;

  for (i = 0; i < 2; ++i) {
    g = grid(2.0, step[i]);
    sample(wave, &g, s);
    sample(other, &g, r);
    check_values(0.3137, 1.87153, &g);
    check_values(0.4, 1.2, &g);
    check_values(0.0, 1.2345, &g);
    check_values(0.7654, 2.0, &g);
    check_values(0.0, 2.0, &g);
    check_values(0.10005, 0.10785, &g); /* few samples long */
  }
}

/* the polynomial itself: int t^n of windows down to parts of one interval, grids of few samples */
static void test_exact(void)
{
  maggi_grid g;
  double a, b;
  long k;
  int steps, n, i;

  for (steps = 1; steps < 40; steps = steps < 8 ? steps + 1 : steps + 9) {
    g = grid(1.0, steps == 17 ? 0.0601 : 1.0 / steps);
    for (i = 0; i < 60; ++i) {
      a = fmod(0.618034 * i, 1.0);
      b = a + (1.0 - a) * fmod(0.41421356 * i + 0.01, 1.0);
      if (i % 7 == 0) b = 1.0;
      if (i % 5 == 0) a = 0.0;
      n = steps < 5 ? steps : 5;
      for (k = 0; k <= g.steps; ++k) s[k] = pow(maggi_grid_time(&g, k), n);
      CHECK_NEAR(of(MAGGI_OBJECTIVE_INTEGRAL, 0, a, b, &g),
                 (pow(b, n + 1) - pow(a, n + 1)) / (n + 1), 0.0, 1e-14);
      CHECK_NEAR(of(MAGGI_OBJECTIVE_TERMINAL, 0, NAN, b, &g), pow(b, n), 0.0, 1e-14);
      CHECK_NEAR(of(MAGGI_OBJECTIVE_MAXIMUM, 0, a, b, &g), pow(b, n), 0.0, 1e-14);
      CHECK_NEAR(of(MAGGI_OBJECTIVE_MINIMUM, 0, a, b, &g), pow(a, n), 0.0, 1e-14);
    }
  }
}

/* between the ends, at them, on a sample, outside of the larger ones elsewhere */
static void test_extrema(void)
{
  double a = asin(1.0 / 6.0), top = (a + 2.0 * acos(-1.0)) / 3.0, low = (acos(-1.0) - a) / 3.0;
  maggi_grid g = grid(3.0, 0.002);

  sample(wave, &g, s);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MAXIMUM, 0, 1.5, 3.0, &g), wave(top), 1e-14, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MAXIMUM, 0, 1.5, 2.0003, &g), wave(2.0003), 1e-14, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MAXIMUM, 0, 1.5, 2.0, &g), wave(2.0), 1e-14, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MAXIMUM, 0, 2.5, 2.9, &g), wave(2.5), 1e-14, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MAXIMUM, 0, 2.5001, 2.9, &g), wave(2.5001), 1e-14, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MINIMUM, 0, 0.5, 1.5, &g), wave(low), 1e-13, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_PEAK, 0, 0.9, 1.1, &g), -wave(low), 1e-13, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_PEAK, 0, 0.9, 2.2, &g), wave(top), 1e-13, 0.0);
  CHECK_NEAR(of(MAGGI_OBJECTIVE_MAXIMUM, 0, 2.5001, 2.5003, &g), wave(2.5001), 1e-14, 0.0);
}

/* int max(0, t - 0.3)^2 = 0.7^3/3; nothing below */
static void test_violation(void)
{
  maggi_grid g = grid(1.0, 0.001);
  maggi_term f = term(MAGGI_OBJECTIVE_VIOLATION, NAN, NAN);
  long k;
  double by_r;

  for (k = 0; k <= g.steps; ++k) s[k] = maggi_grid_time(&g, k);
  f.target = 0.3;
  CHECK_NEAR(pass(&f, &g, s, r), pow(0.7, 3) / 3.0, 1e-8, 0.0);
  f.from = 0.5;
  CHECK_NEAR(pass(&f, &g, s, r), (pow(0.7, 3) - pow(0.2, 3)) / 3.0, 1e-13, 0.0);
  f.from = NAN;
  f.target = 2.0;
  CHECK(pass(&f, &g, s, r) == 0.0);
  CHECK(maggi_term_no_derivative(&f) == NULL &&
        maggi_term_weight(&f, 500, s[500], 0.0, &by_r) == 0.0);
}

/* ----------------------------------------------------------------------------------- derivatives */

/* by each sample of both signals, by differences */
static void check_weights(const maggi_term *of, const maggi_grid *g)
{
  static const double shift[] = {-2.0, -1.0, 1.0, 2.0};
  double by_s[64], by_r[64], *by[2] = {by_s, by_r}, *signal[2] = {s, r}, value[4], keep,
                             scale = 0.0;
  double h = of->type >= MAGGI_OBJECTIVE_MAXIMUM && of->type <= MAGGI_OBJECTIVE_PEAK ? 1e-6 : 1e-3;
  maggi_term f = *of;
  long k;
  int i, j;

  CHECK(isfinite(pass(&f, g, s, r)));
  CHECK(maggi_term_no_derivative(&f) == NULL);
  for (k = 0; k <= g->steps; ++k) {
    by_r[k] = 0.0;
    by_s[k] = maggi_term_weight(&f, k, s[k], r[k], &by_r[k]);
    scale = fmax(scale, fmax(fabs(by_s[k]), fabs(by_r[k])));
  }
  CHECK(scale > 0.0);
  for (j = 0; j < 2; ++j) {
    for (k = 0; k <= g->steps; ++k) {
      keep = signal[j][k];
      for (i = 0; i < 4; ++i) {
        signal[j][k] = keep + shift[i] * h;
        f = *of;
        value[i] = pass(&f, g, s, r);
      }
      signal[j][k] = keep;
      CHECK_NEAR(by[j][k], (8.0 * (value[2] - value[1]) - (value[3] - value[0])) / (12.0 * h), 0.0,
                 3e-9 * scale);
    }
  }
}

static void test_weights(void)
{
  static const double window[][2] = {{NAN, 0.331}, {0.152, NAN}, {0.2, 0.4}, {0.1234, 0.51}};
  maggi_term f;
  maggi_grid g;
  int type, reference, w, last;

  for (last = 0; last < 3; ++last) {
    g = grid(0.6, last == 0 ? 0.02 : last == 1 ? 0.0207 : 0.0199);
    sample(wave, &g, s);
    sample(other, &g, r);
    for (type = 0; type < MAGGI_OBJECTIVE_TYPE_COUNT; ++type) {
      for (w = 0; w < 4; ++w) {
        if (type >= MAGGI_OBJECTIVE_VALUE && type <= MAGGI_OBJECTIVE_SUM &&
            type != MAGGI_OBJECTIVE_TERMINAL)
          continue;
        for (reference = 0; reference < MAGGI_REFERENCE_TYPE_COUNT; ++reference) {
          f = term((maggi_objective_type)type, window[w][0], window[w][1]);
          f.target = 0.07;
          f.reference = (maggi_reference_type)reference;
          if (reference && type > MAGGI_OBJECTIVE_VDV && type != MAGGI_OBJECTIVE_NORM) continue;
          check_weights(&f, &g);
        }
      }
    }
  }
}

/* what no window reaches has no weight */
static void test_outside(void)
{
  maggi_grid g = grid(2.0, 0.01);
  maggi_term f = term(MAGGI_OBJECTIVE_NORM, 0.505, 0.995);
  double by_r;
  long k;

  sample(wave, &g, s);
  pass(&f, &g, s, r);
  for (k = 0; k <= g.steps; ++k)
    CHECK((maggi_term_weight(&f, k, s[k], r[k], &by_r) != 0.0) == (k >= 48 && k <= 102));
  for (k = 60; k <= 90; ++k)
    CHECK_NEAR(maggi_term_weight(&f, k, s[k], r[k], &by_r), 0.01 * s[k] / f.value, 1e-15, 0.0);
}

/* ------------------------------------------------------------------------------------ objectives */

static const char text[] =
    "bodies: [{name: b, mass: 1, joint: {type: prismatic, axis: [0, 0, 1]}},\n"
    "  {name: c, mass: 1, joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0]}}]\n"
    "objectives:\n"
    "  - {name: late, type: norm, signal: b.v, from: 2, reference: final}\n"
    "  - {name: long, type: mean, signal: b.v, from: 0.5, to: 3}\n"
    "  - {name: end, type: terminal, signal: b.v, to: 3}\n"
    "  - {name: gain, type: slope, signal: c.q, against: b.a}\n"
    "  - {name: rate, type: slope, signal: c.q, against: c.v, from: 0.1, to: 0.9}\n"
    "  - {name: ratio, type: slope, signal: c.q, against: c.q}\n"
    "  - {name: fill, type: slope, signal: b.v, against: c.q}\n"
    "  - {name: over, type: violation, signal: b.v, target: 1}\n"
    "  - {name: all, type: sum, terms: [gain, over], weights: [2, 1]}\n";

static maggi_objective *named(const maggi_model *m, const char *name)
{
  maggi_objective *o = NULL;
  char message[200] = "";

  CHECK(maggi_objective_named(m, name, &o, message, sizeof message) == MAGGI_OK);
  CHECK_TEXT(message, "");
  return o;
}

static void test_units(void)
{
  static const char *const pair[][2] = {{"late", "(m/s) s^(1/2)"},   {"gain", "rad/(m/s^2)"},
                                        {"rate", "rad/(rad/s)"},     {"ratio", "-"},
                                        {"fill", "m/s/rad"},         {"over", "(m/s)^2 s"},
                                        {"norm(c.q)", "rad s^(1/2)"}};
  maggi_model *m = test_model("%s", text);
  maggi_objective *o;
  const int *signal;
  int i;

  for (i = 0; i < 7; ++i) {
    o = named(m, pair[i][0]);
    CHECK_TEXT(maggi_objective_unit(o), pair[i][1]);
    maggi_objective_free(o);
  }
  o = named(m, "gain");
  CHECK(maggi_objective_signals(o, &signal) == 2);
  CHECK_TEXT(maggi_signal_name(m, signal[0]), "c.q");
  CHECK_TEXT(maggi_signal_name(m, signal[1]), "b.a");
  maggi_objective_free(o);
  maggi_model_free(m);
}

/* of a sum: 2 slope + violation, each by its own signals */
static void test_sum(void)
{
  maggi_model *m = test_model("%s", text);
  maggi_objective *o = named(m, "all");
  maggi_grid g = grid(1.0, 0.1);
  double x[3], w[3], value;
  char message[200];
  const int *signal;
  long k;

  CHECK(maggi_objective_signals(o, &signal) == 3);
  CHECK(maggi_objective_begin(o, &g, message, sizeof message) == MAGGI_OK);
  for (k = 0; k <= g.steps; ++k) {
    x[1] = maggi_grid_time(&g, k);
    x[0] = 3.0 * x[1] + 5.0;
    x[2] = 2.0;
    maggi_objective_push(o, k, x);
  }
  CHECK(maggi_objective_end(o, &value, message, sizeof message) == MAGGI_OK);
  CHECK_NEAR(value, 2.0 * 3.0 + 1.0, 1e-14, 0.0);
  x[0] = 8.0, x[1] = 1.0;
  CHECK(maggi_objective_weights(o, 10, x, w));
  CHECK(w[0] > 0.0);
  CHECK_NEAR(w[1], -3.0 * w[0], 1e-14, 0.0);
  CHECK(w[2] > 0.0);
  maggi_objective_free(o);
  maggi_model_free(m);
}

static void check_begin(const maggi_model *m, const char *name, double time, const char *said)
{
  maggi_objective *o = named(m, name);
  maggi_grid g = grid(time, 0.1);
  char message[200] = "";

  CHECK(maggi_objective_begin(o, &g, message, sizeof message) ==
        (*said ? MAGGI_E_VALUE : MAGGI_OK));
  CHECK_TEXT(message, said);
  maggi_objective_free(o);
}

static void test_reached(void)
{
  maggi_model *m = test_model("%s", text);

  check_begin(m, "late", 2.5, "");
  check_begin(m, "late", 2.0,
              "objective \"late\": the simulation ends at 2 s, its window begins at 2 s");
  check_begin(m, "long", 3.0, "");
  check_begin(m, "long", 2.9, "objective \"long\": the simulation ends at 2.9 s, before 3 s");
  check_begin(m, "end", 2.9, "objective \"end\": the simulation ends at 2.9 s, before 3 s");
  maggi_model_free(m);
}

/* a slope needs a signal that changes; no derivative of a norm of zero */
static void test_refused(void)
{
  maggi_model *m = test_model("%s", text);
  maggi_objective *o = named(m, "gain"), *norm = named(m, "norm(b.v)");
  maggi_grid g = grid(1.0, 0.1);
  double x[2] = {0.0, 0.7}, value;
  char message[200];
  long k;

  maggi_objective_begin(o, &g, message, sizeof message);
  maggi_objective_begin(norm, &g, message, sizeof message);
  for (k = 0; k <= g.steps; ++k) {
    x[0] = (double)k;
    maggi_objective_push(o, k, x);
    x[0] = 0.0;
    maggi_objective_push(norm, k, x);
  }
  CHECK(maggi_objective_end(o, &value, message, sizeof message) == MAGGI_E_VALUE);
  CHECK_TEXT(message, "objective \"gain\": the signal that it is against does not change");
  CHECK(maggi_objective_end(norm, &value, message, sizeof message) == MAGGI_OK && value == 0.0);
  CHECK(maggi_objective_differentiable(norm, message, sizeof message) == MAGGI_E_VALUE);
  CHECK_TEXT(message, "objective \"norm(b.v)\": the root of zero has no derivative");
  maggi_objective_free(o);
  maggi_objective_free(norm);
  maggi_model_free(m);
}

int main(void)
{
  test_values();
  test_exact();
  test_extrema();
  test_violation();
  test_weights();
  test_outside();
  test_units();
  test_sum();
  test_reached();
  test_refused();
  return check_done();
}
