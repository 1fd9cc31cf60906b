/* What the tests in C share: models from YAML text, state by name, rotations computed another way
 * than in the library, random numbers with a seed. */
#ifndef MAGGI_TEST_FIXTURE_H
#define MAGGI_TEST_FIXTURE_H

#include <stdarg.h>

#include "check.h"
#include "load.h"
#include "maggi/maggi.h"

/* ---------------------------------------------------------------------------------- model, data */

/* model of the text of a file without its first lines; a wrong one ends the program */
static inline maggi_model *test_model(const char *format, ...)
{
  static char text[1 << 16];
  char message[512];
  maggi_model *m;
  int n = snprintf(text, sizeof text, "format: maggi\nversion: 1\nname: test\n");
  va_list args;

  va_start(args, format);
  n += vsnprintf(text + n, sizeof text - (size_t)n, format, args);
  va_end(args);
  if (n >= (int)sizeof text ||
      maggi_model_load_memory("test", text, (size_t)n, &m, message, sizeof message) != MAGGI_OK) {
    fprintf(stderr, "%s\n%s\n", message, text);
    exit(1);
  }
  return m;
}

/* a model that ships, NAME.yaml; a missing one ends the program */
static inline maggi_model *test_file(const char *file)
{
  char path[512], message[512] = "";
  maggi_model *m;

  snprintf(path, sizeof path, "%s/%s", MAGGI_MODELS_DIR, file);
  if (!CHECK(maggi_model_load(path, &m, message, sizeof message) == MAGGI_OK)) {
    fprintf(stderr, "%s\n", message);
    exit(1);
  }
  return m;
}

static inline maggi_data *test_data(const maggi_model *m)
{
  maggi_data *d;

  if (maggi_data_create(m, &d) != MAGGI_OK) exit(1);
  return d;
}

/* data after a reset that succeeds */
static inline maggi_data *test_start(const maggi_model *m)
{
  maggi_data *d = test_data(m);

  if (!check_true("reset", 0, "maggi_data_reset", maggi_data_reset(d) == MAGGI_OK)) {
    fprintf(stderr, "%s\n", maggi_data_message(d));
    exit(1);
  }
  return d;
}

static inline void test_free(maggi_data *d, maggi_model *m)
{
  maggi_data_free(d);
  maggi_model_free(m);
}

static inline void test_step(maggi_data *d, double h, int n)
{
  int i;

  for (i = 0; i < n; ++i) {
    if (maggi_step(d, h) == MAGGI_OK) continue;
    check_true("step", i, maggi_data_message(d), 0);
    return;
  }
}

static inline int test_coordinates(const maggi_model *m)
{
  maggi_model_info info;

  maggi_model_get_info(m, &info);
  return info.coordinates;
}

enum { TEST_COORDINATES_MAX = 64, TEST_COLUMNS_MAX = 64 };

typedef struct test_state {
  double q[TEST_COORDINATES_MAX], v[TEST_COORDINATES_MAX], a[TEST_COORDINATES_MAX];
} test_state;

static inline test_state test_get(const maggi_data *d)
{
  test_state s;

  memset(&s, 0, sizeof s);
  maggi_get_coordinates(d, s.q, s.v, s.a);
  return s;
}

static inline double test_energy(maggi_data *d)
{
  maggi_energy e;

  maggi_get_energy(d, &e);
  return e.kinetic + e.potential - e.work;
}

static inline maggi_loop_state test_loops(const maggi_data *d)
{
  maggi_loop_state s;

  maggi_get_loop_state(d, &s);
  return s;
}

static inline int test_set(const maggi_model *m, maggi_data *d, const char *path, double value)
{
  return maggi_data_set_parameter(d, maggi_parameter_find(m, path), value) == MAGGI_OK;
}

/* --------------------------------------------------------------------------------------- vectors
 * */

static inline double dot3(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross3(const double a[3], const double b[3], double c[3])
{
  double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2];

  c[2] = a[0] * b[1] - a[1] * b[0];
  c[0] = x;
  c[1] = y;
}

static inline double norm3(const double a[3])
{
  return sqrt(dot3(a, a));
}

/* v turned by the angle about the axis: quaternion product s v s*, v + 2 s (u x v) + 2 u x (u x v)
 * */
static inline void turn3(const double axis[3], double angle, const double v[3], double w[3])
{
  double s = sin(0.5 * angle) / norm3(axis), c = cos(0.5 * angle), u[3], a[3], b[3];
  int k;

  for (k = 0; k < 3; ++k) u[k] = s * axis[k];
  cross3(u, v, a);
  cross3(u, a, b);
  for (k = 0; k < 3; ++k) w[k] = v[k] + 2.0 * (c * a[k] + b[k]);
}

/* ---------------------------------------------------------------------------------------- random
 * */

/* in [0, 1), splitmix64 */
static inline double random01(unsigned long long *seed)
{
  unsigned long long z = *seed += 0x9E3779B97F4A7C15ull;

  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* in [-1, 1) */
static inline double random11(unsigned long long *seed)
{
  return 2.0 * random01(seed) - 1.0;
}

#endif
