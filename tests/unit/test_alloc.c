/* After maggi_data_reset nothing is allocated or freed any more, also when the independent
 * coordinates change; nor by derivatives after maggi_derivative_create, nor by steps of the penalty
 * formulation after the first.  The allocator of the C library is replaced by one that counts and
 * passes on (glibc). */
#include "fixture.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)

int main(void)
{
  puts("skipped: the allocator is the sanitizer's, or not glibc's");
  return CHECK_SKIPPED;
}

#else

#include <errno.h>

/* glibc's own names */
extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t n, size_t size);
extern void *__libc_realloc(void *p, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);
extern void __libc_free(void *p);

static volatile long calls;

void *malloc(size_t size)
{
  ++calls;
  return __libc_malloc(size);
}

void *calloc(size_t n, size_t size)
{
  ++calls;
  return __libc_calloc(n, size);
}

void *realloc(void *p, size_t size)
{
  ++calls;
  return __libc_realloc(p, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
  ++calls;
  return __libc_memalign(alignment, size);
}

void *memalign(size_t alignment, size_t size);
void *memalign(size_t alignment, size_t size)
{
  ++calls;
  return __libc_memalign(alignment, size);
}

int posix_memalign(void **p, size_t alignment, size_t size)
{
  ++calls;
  *p = __libc_memalign(alignment, size);
  return *p ? 0 : ENOMEM;
}

void free(void *p)
{
  ++calls;
  __libc_free(p);
}

enum { DIRECTIONS = 9, PARAMETERS_MAX = 2048 };

/* calls of the allocator in 2000 steps with everything asked after each */
static long count(maggi_model *m, maggi_data *d, double h)
{
  static double q[64], v[64], a[64], w[64 * 6], s[64], lambda[256], drives[64];
  static double X[64 * DIRECTIONS], V[64 * DIRECTIONS], A[64 * DIRECTIONS];
  static double P[PARAMETERS_MAX * DIRECTIONS], p[PARAMETERS_MAX];
  maggi_derivative *D;
  maggi_energy e;
  long before;
  int i, failed = 0;

  if (!CHECK(maggi_derivative_create(d, DIRECTIONS, &D) == MAGGI_OK)) exit(1);
  before = calls;

  for (i = 0; i < 2000; ++i) {
    failed += maggi_step(d, h) != MAGGI_OK;
    maggi_get_coordinates(d, q, v, a);
    maggi_get_sensors(d, s);
    maggi_get_reactions(d, w);
    maggi_get_multipliers(d, lambda);
    maggi_get_drives(d, drives);
    maggi_get_energy(d, &e);
    failed += maggi_linearise(D) != MAGGI_OK;
    maggi_motion_jvp(D, q, v, P, v, a);
    maggi_motion_jac(D, DIRECTIONS, X, X, P, V, A);
    maggi_motion_vjp(D, v, a, v, a, p);
    maggi_motion_hvp(D, v, a, q, v, P, v, a, p);
  }
  before = calls - before;
  maggi_derivative_free(D);
  CHECK(failed == 0);
  CHECK(test_coordinates(m) <= 64);
  CHECK(maggi_parameter_path(m, PARAMETERS_MAX) == NULL);
  return before;
}

static void check(const char *name, maggi_model *m, double h, int changes)
{
  maggi_data *d = test_start(m);
  long n = count(m, d, h);

  if (!CHECK(n == 0))
    fprintf(stderr, "  %s: %ld calls, %ld changes\n", name, n, test_loops(d).changes);
  CHECK(!changes || test_loops(d).changes > 0);
  test_free(d, m);
}

/* steps with sensitivities */
static void check_direct(const char *name, maggi_model *m, double h)
{
  maggi_data *d = test_start(m);
  maggi_design *g = NULL;
  maggi_direct *direct = NULL;
  int signal[] = {0, maggi_signal_find(m, "energy.total"), maggi_signal_number(m) - 1};
  double *x;
  char message[256];
  long before;
  int i, failed = 0;

  CHECK(maggi_design_create(d, &g) == MAGGI_OK);
  CHECK(maggi_design_select(g, "all", message, sizeof message) == MAGGI_OK);
  CHECK(maggi_direct_create(d, g, &direct) == MAGGI_OK && maggi_direct_reset(direct) == MAGGI_OK);
  x = calloc(3 * (size_t)maggi_design_number(g), sizeof *x);
  before = calls;
  for (i = 0; i < 100; ++i) {
    failed += maggi_direct_step(direct, h) != MAGGI_OK;
    maggi_direct_get_signals(direct, 3, signal, x);
  }
  if (!CHECK(calls == before)) fprintf(stderr, "  %s: direct, %ld calls\n", name, calls - before);
  maggi_direct_free(direct);

  CHECK(failed == 0);
  free(x);
  maggi_design_free(g);
  test_free(d, m);
}

/* steps of the penalty formulation after the first */
static void check_penalty(const char *name, maggi_model *m, double h)
{
  maggi_data *d = test_data(m);
  maggi_penalty_options options;
  maggi_penalty *s;
  long before;
  int i, way, failed = 0;

  maggi_penalty_options_init(&options);
  for (way = 0; way < MAGGI_JACOBIAN_COUNT; ++way) {
    options.jacobian = (maggi_jacobian)way;
    if (!CHECK(maggi_penalty_create(d, &options, &s) == MAGGI_OK)) exit(1);
    CHECK(maggi_penalty_reset(s) == MAGGI_OK);
    CHECK(maggi_penalty_step(s, h) == MAGGI_OK);
    before = calls;
    for (i = 0; i < 200; ++i) failed += maggi_penalty_step(s, h) != MAGGI_OK;
    if (!CHECK(calls == before))
      fprintf(stderr, "  %s: %s, %ld calls\n", name, maggi_jacobian_name(options.jacobian),
              calls - before);
    maggi_penalty_free(s);
  }
  CHECK(failed == 0);
  test_free(d, m);
}

int main(void)
{
  maggi_model *m;
  long before = calls;

  free(malloc(1000));
  CHECK(calls == before + 2); /* the count counts */

  check("four-bar", test_file("four-bar.yaml"), 1e-3, 0);
  check("bricard", test_file("bricard.yaml"), 1e-3, 0);
  check("rssr", test_file("rssr.yaml"), 1e-3, 0);
  check("n-four-bar-2", test_file("n-four-bar-2.yaml"), 5e-3, 0); /* singular positions */
  check("andrews", test_file("andrews.yaml"), 2e-5, 0);

  check_direct("four-bar", test_file("four-bar.yaml"), 1e-3);
  check_direct("bricard", test_file("bricard.yaml"), 1e-3);
  check_direct("chain-30", test_file("chain-30.yaml"), 1e-3);

  /* implicit: dense and sparse factors, through the singular positions of the hanging array */
  check_penalty("four-bar", test_file("four-bar.yaml"), 1e-2);
  check_penalty("bricard", test_file("bricard.yaml"), 1e-3);
  check_penalty("chain-30", test_file("chain-30.yaml"), 1e-3);
  CHECK(maggi_model_multiple_four_bar(1, 15, &m) == MAGGI_OK);
  check_penalty("multiple-four-bar:1x15", m, 2e-2);

  /* 5 s with the singular positions of the hanging array */
  CHECK(maggi_model_multiple_four_bar(2, 5, &m) == MAGGI_OK);
  check("multiple-four-bar:2x5", m, 2.5e-3, 0);

  /* the slider leads, at each dead point the crank takes over */
  m = test_model(
      "gravity: [0, 0, 0]\n"
      "bodies:\n"
      "- {name: crank, mass: 1, cog: [0.05, 0.1, 0], inertia: {xx: 9, yy: 9, zz: 0.2},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]}}\n"
      "- {name: rod, parent: crank, mass: 0.5, bar: {from: [0, 0.3, 0], to: [0.9539392014169456, 0,"
      " 0]}, joint: {type: revolute, point: [0, 0.3, 0], axis: [0, 0, 1]}}\n"
      "- {name: slider, mass: 0.7, joint: {type: prismatic, axis: [1, 0, 0], velocity: 1.2}}\n"
      "loops: [{name: pin, type: revolute, body_a: rod, body_b: slider,"
      " point: [0.9539392014169456, 0, 0], axis: [0, 0, 1]}]\n");
  check("slider-crank", m, 2e-3, 1);

  /* several loops of which each changes its coordinates at its own time */
  m = test_model(
      "gravity: [0, 0, 0]\n"
      "bodies:\n"
      "- {name: crank, mass: 1, cog: [0.05, 0.1, 0], inertia: {xx: 9, yy: 9, zz: 2},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]}}\n"
      "- {name: rod1, parent: crank, mass: 0.5, cog: [0.3, 0.2, 0], inertia: {xx: 1, yy: 1,"
      " zz: 0.1}, joint: {type: revolute, point: [0, 0.3, 0], axis: [0, 0, 1]}}\n"
      "- {name: rod2, parent: crank, mass: 0.5, cog: [0.2, 0.5, 0], inertia: {xx: 1, yy: 1,"
      " zz: 0.1}, joint: {type: revolute, point: [0.25, 0.1, 0], axis: [0, 0, 1]}}\n"
      "- {name: slider1, mass: 0.7, joint: {type: prismatic, axis: [1, 0, 0], velocity: 1.2}}\n"
      "- {name: slider2, mass: 0.7, joint: {type: prismatic, axis: [0, 1, 0]}}\n"
      "loops:\n"
      "- {name: pin1, type: revolute, body_a: rod1, body_b: slider1, point: [1, 0, 0],"
      " axis: [0, 0, 1]}\n"
      "- {name: pin2, type: revolute, body_a: rod2, body_b: slider2, point: [0, 1.2, 0],"
      " axis: [0, 0, 1]}\n");
  check("two sliders", m, 2e-3, 1);
  return check_done();
}

#endif
