/* evaluate.c with hooks; see staged.h. */
#define _POSIX_C_SOURCE 200809L

#include "staged.h"

#include <string.h>
#include <time.h>

#include "data.h"

static staged *into;
static int present;

#ifdef BENCH_COUNT

/* what count.awk increments, and where it keeps a register meanwhile */
long bench_flops[FLOP_COUNT];
long bench_register;
static long before[FLOP_COUNT];

static void charge(void)
{
  int k;

  for (k = 0; k < FLOP_COUNT; ++k) {
    into->flops[present][k] += bench_flops[k] - before[k];
    before[k] = bench_flops[k];
  }
}

#else

static long long before;

static long long ticks(void)
{
#if defined(__x86_64__) && defined(__GNUC__)
  return (long long)__builtin_ia32_rdtsc();
#else
  struct timespec at;

  clock_gettime(CLOCK_MONOTONIC, &at);
  return at.tv_sec * 1000000000LL + at.tv_nsec;
#endif
}

static void charge(void)
{
  long long now = ticks();

  into->ticks[present] += now - before;
  before = now;
}

#endif

static void enter(int function)
{
  charge();
  present = function;
  ++into->calls[function];
}

/* a macro is not expanded again inside itself, so the call remains */
#define HOOK(function, ...)            (enter(STAGED_##function), function(__VA_ARGS__))
#define maggi_functions(...)           HOOK(maggi_functions, __VA_ARGS__)
#define maggi_positions(...)           HOOK(maggi_positions, __VA_ARGS__)
#define maggi_points(...)              HOOK(maggi_points, __VA_ARGS__)
#define maggi_directions(...)          HOOK(maggi_directions, __VA_ARGS__)
#define maggi_loop_residual(...)       HOOK(maggi_loop_residual, __VA_ARGS__)
#define maggi_loop_entries(...)        HOOK(maggi_loop_entries, __VA_ARGS__)
#define maggi_island_factors(...)      HOOK(maggi_island_factors, __VA_ARGS__)
#define maggi_island_columns(...)      HOOK(maggi_island_columns, __VA_ARGS__)
#define maggi_loop_gamma(...)          HOOK(maggi_loop_gamma, __VA_ARGS__)
#define maggi_island_vector(...)       HOOK(maggi_island_vector, __VA_ARGS__)
#define maggi_velocities(...)          HOOK(maggi_velocities, __VA_ARGS__)
#define maggi_point_velocities(...)    HOOK(maggi_point_velocities, __VA_ARGS__)
#define maggi_point_accelerations(...) HOOK(maggi_point_accelerations, __VA_ARGS__)
#define maggi_accelerations(...)       HOOK(maggi_accelerations, __VA_ARGS__)
#define maggi_wheel_forces(...)        HOOK(maggi_wheel_forces, __VA_ARGS__)
#define maggi_element_forces(...)      HOOK(maggi_element_forces, __VA_ARGS__)
#define maggi_control_forces(...)      HOOK(maggi_control_forces, __VA_ARGS__)
#define maggi_body_inertias(...)       HOOK(maggi_body_inertias, __VA_ARGS__)
#define maggi_inertia_forces(...)      HOOK(maggi_inertia_forces, __VA_ARGS__)
#define maggi_rod_forces(...)          HOOK(maggi_rod_forces, __VA_ARGS__)
#define maggi_accumulate(...)          HOOK(maggi_accumulate, __VA_ARGS__)
#define maggi_composite_inertias(...)  HOOK(maggi_composite_inertias, __VA_ARGS__)
#define maggi_mass_matrix(...)         HOOK(maggi_mass_matrix, __VA_ARGS__)
#define maggi_reduced_mass(...)        HOOK(maggi_reduced_mass, __VA_ARGS__)
#define maggi_generalised_forces(...)  HOOK(maggi_generalised_forces, __VA_ARGS__)
#define maggi_reduced_force(...)       HOOK(maggi_reduced_force, __VA_ARGS__)
#define maggi_factor_mass(...)         HOOK(maggi_factor_mass, __VA_ARGS__)
#define maggi_solve_mass(...)          HOOK(maggi_solve_mass, __VA_ARGS__)
#define maggi_expand(...)              HOOK(maggi_expand, __VA_ARGS__)
#define maggi_drives(...)              HOOK(maggi_drives, __VA_ARGS__)

#include "evaluate.c"

static void run(maggi_data *d, double time, staged *s)
{
  into = s;
  present = STAGED_outside;
  charge();
  maggi_evaluate(d, time);
  charge();
}

#ifdef BENCH_COUNT

void staged_counted(maggi_data *d, double time, staged *s)
{
  memset(bench_flops, 0, sizeof bench_flops);
  memset(before, 0, sizeof before);
  run(d, time, s);
}

#else

void staged_timed(maggi_data *d, double time, staged *s)
{
  before = ticks();
  run(d, time, s);
}

double staged_overhead(void)
{
  static staged s;
  long long best = -1, begin;
  int i, k;

  into = &s;
  before = ticks();
  for (k = 0; k < 20; ++k) {
    begin = ticks();
    for (i = 0; i < 1000; ++i) enter(STAGED_outside);
    if (best < 0 || ticks() - begin < best) best = ticks() - begin;
  }
  return (double)best / 1000.0;
}

double staged_rate(void)
{
  struct timespec a, b;
  long long from, to;
  double passed;

  clock_gettime(CLOCK_MONOTONIC, &a);
  from = ticks();
  do {
    clock_gettime(CLOCK_MONOTONIC, &b);
    passed = (double)(b.tv_sec - a.tv_sec) + 1e-9 * (double)(b.tv_nsec - a.tv_nsec);
  } while (passed < 0.02);
  to = ticks();
  return (double)(to - from) / passed;
}

#endif
