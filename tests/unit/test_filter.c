/* core/kernel/filter.c, core/model/compile_filters.c: weightings against their transfer functions and published
 * tables; states that are integrated with the motion. */
#include <complex.h>
#undef I

#include "data.h"
#include "fixture.h"

enum { ORDER = 8, NUMBERS = 10 };
#define PI 3.14159265358979323846

static const char *name_of(int i)
{
  return maggi_weighting_type_name((maggi_weighting_type)i);
}

/* a mass on a guide along z with its acceleration weighted by the filter */
static maggi_model *shaken(double amplitude, double omega, const char *filter)
{
  return test_model(
      "gravity: [0, 0, -9.81]\n"
      "functions:\n"
      "  - {name: shake, type: sine, amplitude: %.17g, omega: %.17g}\n"
      "bodies:\n"
      "  - name: mass\n"
      "    joint: {type: prismatic, point: [0, 0, 0], axis: [0, 0, 1], motion: shake}\n"
      "    mass: 3\n"
      "sensors:\n"
      "  - {name: acc, type: acceleration, body: mass, point: [0.1, 0, 0]}\n"
      "filters:\n"
      "  - {name: w, signal: acc.z, %s}\n",
      amplitude, omega, filter);
}

static maggi_data *weighted_by(int weighting)
{
  char filter[40];

  snprintf(filter, sizeof filter, "weighting: %s", name_of(weighting));
  return test_start(shaken(1.0, 1.0, filter));
}

static void end(maggi_data *d)
{
  const maggi_model *m = d->m;

  maggi_data_free(d);
  maggi_model_free((maggi_model *)m);
}

/* ------------------------------------------------------------------------------------- systems */

typedef struct linear {
  int n;
  double A[ORDER][ORDER], B[ORDER], C[ORDER];
} linear;

static linear linear_of(const maggi_data *d)
{
  linear s = {.n = d->t.nstate};
  double y[ORDER] = {0.0}, rate[ORDER], out[1], sensor[1][3] = {{0.0, 0.0, 1.0}};
  int i, k;

  maggi_filter_rates(&d->t, d->p, (void *)sensor, y, s.B);
  sensor[0][2] = 0.0;
  for (k = 0; k < s.n; ++k) {
    y[k] = 1.0;
    maggi_filter_rates(&d->t, d->p, (void *)sensor, y, rate);
    maggi_filter_outputs(&d->t, d->p, y, out);
    y[k] = 0.0;
    for (i = 0; i < s.n; ++i) s.A[i][k] = rate[i];
    s.C[k] = out[0];
  }
  return s;
}

/* C (i w - A)^-1 B by elimination with pivots */
static double complex response(const linear *s, double w)
{
  double complex M[ORDER][ORDER + 1], x, sum = 0.0;
  int i, j, k, p, n = s->n;

  for (i = 0; i < n; ++i) {
    for (j = 0; j < n; ++j) M[i][j] = (i == j ? w * _Complex_I : 0.0) - s->A[i][j];
    M[i][n] = s->B[i];
  }
  for (k = 0; k < n; ++k) {
    for (p = k, i = k + 1; i < n; ++i)
      if (cabs(M[i][k]) > cabs(M[p][k])) p = i;
    for (j = k; j <= n; ++j) {
      x = M[k][j];
      M[k][j] = M[p][j];
      M[p][j] = x;
    }
    for (i = 0; i < n; ++i) {
      if (i == k) continue;
      x = M[i][k] / M[k][k];
      for (j = k; j <= n; ++j) M[i][j] -= x * M[k][j];
    }
  }
  for (i = 0; i < n; ++i) sum += s->C[i] * M[i][n] / M[i][i];
  return sum;
}

/* f1 f2 f3 f4 q4 f5 q5 f6 q6 gain */
static double complex formula(const double x[NUMBERS], double frequency)
{
  double complex s = frequency * _Complex_I, h;

  h = s * s / (s * s + sqrt(2.0) * x[0] * s + x[0] * x[0]);
  h *= x[1] * x[1] / (s * s + sqrt(2.0) * x[1] * s + x[1] * x[1]);
  if (isfinite(x[3]))
    h *= (1.0 + (isfinite(x[2]) ? s / x[2] : 0.0)) * x[3] * x[3] /
         (s * s + x[3] / x[4] * s + x[3] * x[3]);
  if (isfinite(x[5]))
    h *= (s * s + x[5] / x[6] * s + x[5] * x[5]) / (s * s + x[7] / x[8] * s + x[7] * x[7]);
  return x[9] * h;
}

/* ------------------------------------------------------------------------------- published data */

static FILE *open_csv(const char *file)
{
  char path[512], line[200];
  FILE *f;

  snprintf(path, sizeof path, "%s/iso2631/%s", MAGGI_REFERENCES_DIR, file);
  f = fopen(path, "r");
  if (!CHECK(f && fgets(line, sizeof line, f))) exit(1);
  return f;
}

static double numbers[MAGGI_WEIGHTING_TYPE_COUNT][NUMBERS];
static linear system_of[MAGGI_WEIGHTING_TYPE_COUNT];

/* the parameters as published; the transfer function of the states is theirs */
static void test_transfer(void)
{
  FILE *f = open_csv("parameters.csv");
  char line[200], *s;
  maggi_data *d;
  maggi_filter_def def;
  double frequency;
  double complex h;
  int i, k, n = 0;

  for (; fgets(line, sizeof line, f); ++n) {
    s = strchr(line, ',');
    *s++ = '\0';
    i = maggi_weighting_type_find(line);
    if (!CHECK(i >= 0)) continue;
    for (k = 0; k < NUMBERS; ++k, s += *s == ',') numbers[i][k] = strtod(s, &s);
    maggi_filter_def_init(&def);
    maggi_filter_def_weighting(&def, (maggi_weighting_type)i);
    const double own[NUMBERS] = {def.f1, def.f2, def.f3, def.f4, def.q4,
                                 def.f5, def.q5, def.f6, def.q6, def.gain};
    CHECK(memcmp(own, numbers[i], sizeof own) == 0);
    d = weighted_by(i);
    CHECK(d->t.nstate == 4 + 2 * !!isfinite(def.f4) + 2 * !!isfinite(def.f5));
    system_of[i] = linear_of(d);
    for (frequency = 0.01; frequency < 1000.0; frequency *= 1.21) {
      h = formula(numbers[i], frequency);
      CHECK(cabs(response(&system_of[i], 2.0 * PI * frequency) - h) < 1e-12 * cabs(h));
    }
    end(d);
  }
  CHECK(n == MAGGI_WEIGHTING_TYPE_COUNT);
  fclose(f);
}

/* the matrices that another program has made */
static void test_matrices(void)
{
  FILE *f = open_csv("statespace.csv");
  linear rest[MAGGI_WEIGHTING_TYPE_COUNT];
  char weighting[8], matrix;
  double value, *x, size = 0.0;
  int i, row, column, n = 0;

  memcpy(rest, system_of, sizeof rest);
  while (fscanf(f, "%7[^,],%c,%d,%d,%lf\n", weighting, &matrix, &row, &column, &value) == 5) {
    i = maggi_weighting_type_find(weighting);
    if (!CHECK(i >= 0)) continue;
    x = matrix == 'A'   ? &rest[i].A[row][column]
        : matrix == 'B' ? &rest[i].B[row]
                        : &rest[i].C[column];
    CHECK_NEAR(*x, value, 1e-14, 0.0);
    *x = 0.0;
    ++n;
  }
  CHECK(n > 100);
  for (i = 0; i < MAGGI_WEIGHTING_TYPE_COUNT; ++i) /* the others are zero there */
    for (row = 0; row < ORDER; ++row) {
      size += fabs(rest[i].B[row]) + fabs(rest[i].C[row]);
      for (column = 0; column < ORDER; ++column) size += fabs(rest[i].A[row][column]);
    }
  CHECK(size == 0.0);
  fclose(f);
}

static double weight(int weighting, double frequency)
{
  return cabs(response(&system_of[weighting], 2.0 * PI * frequency));
}

/* half of the last digit of a printed number, which ends with a comma */
static double half_digit(const char *text)
{
  const char *end = strchr(text, ','), *point = strchr(text, '.');

  return 0.5 * pow(10.0, point && point < end ? (double)(point + 1 - end) : 0.0);
}

/* third-octave bands as in ISO 2631-1, where they are rounded to fewer digits than that within these, and reference values of ISO 8041 */
static void test_tables(void)
{
  static const double within[MAGGI_WEIGHTING_TYPE_COUNT] = {[MAGGI_WEIGHTING_WK] = 0.0028,
                                                            [MAGGI_WEIGHTING_WD] = 0.01,
                                                            [MAGGI_WEIGHTING_WF] = 0.0064,
                                                            [MAGGI_WEIGHTING_WC] = 0.002};
  static const struct {
    int weighting;
    double value;
  } reference[] = {{MAGGI_WEIGHTING_WB, 0.8126}, {MAGGI_WEIGHTING_WC, 0.5145},
                   {MAGGI_WEIGHTING_WD, 0.1261}, {MAGGI_WEIGHTING_WE, 0.06287},
                   {MAGGI_WEIGHTING_WJ, 1.019},  {MAGGI_WEIGHTING_WK, 0.7718}};
  FILE *f = open_csv("weightings.csv");
  char line[200], *s;
  double band, nominal, table, exact, at_nominal, half;
  int i, rows = 0, tabled = 0, is_misprint;
  size_t k;

  while (fgets(line, sizeof line, f)) {
    s = strchr(line, ',');
    *s++ = '\0';
    i = maggi_weighting_type_find(line);
    if (!CHECK(i >= 0)) continue;
    band = strtod(s, &s);
    nominal = strtod(s + 1, &s);
    strtod(s + 1, &s); /* the exact frequency, rounded */
    table = s[1] == ',' ? NAN : strtod(s + 1, NULL);
    half = half_digit(s + 1);
    s = strchr(s + 1, ',');
    exact = strtod(s + 1, &s);
    at_nominal = strtod(s + 1, &s);
    CHECK_NEAR(1000.0 * weight(i, pow(10.0, band / 10.0)), exact, 1e-9, 0.5001e-4);
    CHECK_NEAR(1000.0 * weight(i, nominal), at_nominal, 1e-9, 0.5001e-4);
    is_misprint = i == MAGGI_WEIGHTING_WD && nominal == 10.0;
    ++rows;
    if (isnan(table) || is_misprint || within[i] == 0.0) continue;
    ++tabled;
    CHECK_NEAR(1000.0 * weight(i, nominal), table, 0.0, fmax(within[i] * table, half));
  }
  CHECK(rows > 300 && tabled > 80);
  fclose(f);
  for (k = 0; k < sizeof reference / sizeof *reference; ++k)
    CHECK_NEAR(weight(reference[k].weighting, 100.0 / (2.0 * PI)), reference[k].value, 5e-4, 0.0);
}

/* ---------------------------------------------------------------------------------- simulations */

/* root mean square of n samples */
static double rms(maggi_data *d, double h, int n)
{
  double value, sum = 0.0;
  int i;

  for (i = 0; i < n; ++i) {
    CHECK(maggi_step(d, h) == MAGGI_OK);
    maggi_get_filters(d, &value);
    sum += value * value;
  }
  return sqrt(sum / n);
}

/* a guided sine of 4 Hz: what is left of it after the start is W(4 Hz) times as large */
static double error_at(double h)
{
  const double omega = 8.0 * PI, amplitude = 0.003;
  maggi_data *d = test_start(shaken(amplitude, omega, "weighting: Wk"));
  double value, expected = weight(MAGGI_WEIGHTING_WK, 4.0) * amplitude * omega * omega / sqrt(2.0);

  test_step(d, h, (int)lround(15.0 / h));
  value = rms(d, h, (int)lround(2.0 / h));
  end(d);
  return value / expected - 1.0;
}

static void test_sine(void)
{
  double error = fabs(error_at(0.001)), half = fabs(error_at(0.0005));

  CHECK(error < 1e-6);
  CHECK(half < 1e-7);
  CHECK(half < error / 12.0);
}

/* numbers, inf as a word or left out */
static void test_numbers(void)
{
  const double own[NUMBERS] = {0.5, 60.0, INFINITY, 9.0, 0.7, INFINITY, NAN, INFINITY, NAN, 1.5};
  maggi_data *d = test_start(shaken(1.0, 1.0,
                                    "f1: 0.5, f2: 60, f3: inf, f4: 9, q4: 0.7, f5: inf, "
                                    "gain: 1.5"));
  linear s = linear_of(d);
  double complex h = formula(own, 7.0);

  CHECK(s.n == 6);
  CHECK(cabs(response(&s, 14.0 * PI) - h) < 1e-12 * cabs(h));
  CHECK(maggi_parameter_find(d->m, "filters.w.f3") < 0);
  CHECK(maggi_parameter_find(d->m, "filters.w.gain") >= 0);
  CHECK(maggi_data_set_parameter(d, maggi_parameter_find(d->m, "filters.w.q4"), 0.0) ==
        MAGGI_E_VALUE);
  CHECK_TEXT(maggi_filter_column_name(d->m, 0), "w.weighted");
  CHECK_TEXT(maggi_filter_column_unit(d->m, 0), "m/s^2");
  CHECK(maggi_signal_find(d->m, "w.weighted") == maggi_signal_number(d->m) - 1);
  end(d);
}

/* a reset puts filters to rest, and they leave the motion alone */
static void test_rest(void)
{
  maggi_model *m = test_file("seat-shaker.yaml");
  maggi_data *d = test_start(m), *alone = test_start(m);
  double x[12], y[12], w[5];
  int i;

  maggi_get_filters(d, w);
  for (i = 0; i < 5; ++i) CHECK(w[i] == 0.0);
  alone->t.nfilter = alone->t.nstate = 0;
  test_step(d, 0.001, 300);
  test_step(alone, 0.001, 300);
  maggi_get_coordinates(d, x, x + 4, x + 8);
  maggi_get_coordinates(alone, y, y + 4, y + 8);
  CHECK(memcmp(x, y, sizeof x) == 0);
  maggi_get_filters(d, w);
  for (i = 0; i < 5; ++i) CHECK(w[i] != 0.0);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  maggi_get_filters(d, w);
  for (i = 0; i < 5; ++i) CHECK(w[i] == 0.0);
  maggi_data_free(d);
  maggi_data_free(alone);
  maggi_model_free(m);
}

int main(void)
{
  test_transfer();
  test_matrices();
  test_tables();
  test_sine();
  test_numbers();
  test_rest();
  return check_done();
}
