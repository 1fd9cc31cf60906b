/* Where an evaluation goes, function by function. */
#include "profile.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "table.h"
#include "timing.h"

const char *const profile_function[] = {
#define X(function, stage) #function,
    STAGED_LIST(X)
#undef X
};

#ifdef BENCH_STAGED

enum { PROFILE_SAMPLES = 101, PROFILE_ROUNDS = 7, PROFILE_STAGES = 8 };

static const char *const function_stage[] = {
#define X(function, stage) stage,
    STAGED_LIST(X)
#undef X
};
static const char *const stage_name[PROFILE_STAGES] = {
    "positions", "loops", "velocities", "wheels", "inertias", "mass matrix", "solve", "outside"};

/* microseconds of each function in one evaluation, the median of many */
static void profile_times(const bench_case *c, double us[STAGED_COUNT])
{
  static double sample[STAGED_COUNT][PROFILE_ROUNDS * PROFILE_SAMPLES];
  double overhead = staged_overhead(), rate = staged_rate();
  staged s;
  int i, k, n = PROFILE_ROUNDS * PROFILE_SAMPLES;

  for (k = 0; k < n; ++k) {
    memset(&s, 0, sizeof s);
    staged_timed(c->d, c->time, &s);
    for (i = 0; i < STAGED_COUNT; ++i)
      sample[i][k] = 1e6 / rate * ((double)s.ticks[i] - overhead * (double)s.calls[i]);
  }
  for (i = 0; i < STAGED_COUNT; ++i) {
    sort_samples(n, sample[i]);
    us[i] = fmax(0.0, quantile(n, sample[i], 0.5));
  }
}

static void profile_row(table *t, const char *name, double us, double all, long flops,
                        long executed)
{
  table_row(t);
  table_cell(t, "%s", name);
  table_cell(t, "%.3f", us);
  table_cell(t, "%.1f", 100.0 * us / all);
  table_cell(t, "%ld", flops);
  table_cell(t, "%ld", executed);
  table_cell(t, "%.2f", us > 0.0 ? 1e-3 * (double)flops / us : 0.0);
}

void profile(int markdown, bench_case *c)
{
  static table t;
  bench_flops counts;
  char text[128];
  double us[STAGED_COUNT], all = 0.0, part;
  long flops, executed;
  int i, k;

  case_count(c, &counts);
  profile_times(c, us);
  for (i = 0; i < STAGED_COUNT; ++i) all += us[i];
  snprintf(text, sizeof text, "%.63s: where one evaluation goes", c->name);
  printf("%s%s\n\n", markdown ? "## " : "", text);
  table_begin(&t, "stage|us|%|flops|executed|GFlop/s");
  for (k = 0; k < PROFILE_STAGES; ++k) {
    part = 0.0;
    flops = 0;
    executed = 0;
    for (i = 0; i < STAGED_COUNT; ++i) {
      if (strcmp(function_stage[i], stage_name[k]) == 0) {
        part += us[i];
        flops += counts.needed[i];
        executed += counts.executed[i];
      }
    }
    profile_row(&t, stage_name[k], part, all, flops, executed);
    for (i = 0; i < STAGED_COUNT; ++i) {
      if (strcmp(function_stage[i], stage_name[k]) == 0 && us[i] > 0.0) {
        snprintf(text, sizeof text, "  %s", profile_function[i]);
        profile_row(&t, text, us[i], all, counts.needed[i], counts.executed[i]);
      }
    }
  }
  profile_row(&t, "sum", all, all, c->flops, c->executed);
  table_print(&t, markdown);
}

#else

void profile(int markdown, bench_case *c)
{
  (void)markdown;
  printf("%s: no profile in this build (tests/bench/CMakeLists.txt)\n\n", c->name);
}

#endif
