/* bench [SUITE] [--profile] [--markdown] [--csv FILE]
 *
 *   four-bar           one evaluation of the right-hand side of the small four-bar models
 *   multiple-four-bar  of 1x15, 4x15, 7x15
 *   scaling            cost against the number of four-bars side by side and of rows
 *   accuracy           five seconds of 1x15: CPU time and end error against the step
 *   threads            independent simulations on one and two threads
 *   flops              those of tests/bench/flops.c against those executed; fails if they differ
 *   all                all shipped models and all of the above (default)
 *
 * --profile takes the evaluations apart by kernel function.  For peers.py, one line on stdout each:
 *
 *   evaluation MODEL   microseconds of one evaluation: median, quartiles, flops
 *   step MODEL H N     microseconds of a quarter of a step, N steps from the start
 *   run H              five seconds of 1x15: CPU seconds, end error
 *   state MODEL T H    names, q, v, a at time T, as JSON
 *
 * Times are CPU time of this thread, medians over many batches; +- is the quarter of the samples on
 * either side of the median. */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cases.h"
#include "kernel.h"
#include "profile.h"
#include "table.h"
#include "timing.h"

enum { ROUNDS = 5, SAMPLES = 21, MODELS_MAX = 56 };

/* targets of issue 2; limits, with the flops they follow from when no zero is multiplied; MuJoCo
 * 4.0 as it was measured for that issue: one shared core of 2.5 GHz, AVX-512 */
static const struct known {
  const char *model;
  double target, limit_low, limit_high, least_flops, mujoco_low, mujoco_high;
} known[] = {
    {"spatial-four-bar", 0.9, 0.5, 0.8, 2100, 3.4, 6.4},
    {"chain-30", 8.0, 2.5, 6.0, 33000, 12.0, 16.0},
    {"multiple-four-bar:1x15", 12.0, 8.0, 11.0, 50000, 48.0, 90.0},
    {"multiple-four-bar:4x15", 42.0, 30.0, 38.0, 181000, 455.0, 665.0},
    {"multiple-four-bar:7x15", 70.0, 50.0, 65.0, 312000, 727.0, 1254.0},
};
enum { NKNOWN = sizeof known / sizeof known[0] };

/* the same for five seconds of 1x15 */
static const double error_at = 3e-7; /* where MuJoCo needs 0.23 s */
static const double mujoco_seconds = 0.23;
static const double exponent_target = 1.1;

static const double steps[] = {0.02, 0.01, 0.008, 0.005, 0.004, 0.002, 0.001};
enum { NSTEP = sizeof steps / sizeof steps[0] };

/* thesis, table 4.5 b, the best of its methods: seconds and drift of energy in percent */
static const struct thesis_run {
  double step, seconds, percent;
} thesis[] = {{0.02, 2.23, 0.057}, {0.01, 3.78, 0.015}, {0.001, 36.49, 0.000}};
enum { NTHESIS = sizeof thesis / sizeof thesis[0] };

typedef struct options {
  int markdown, profile;
  FILE *csv;
} options;

/* ---------------------------------------------------------------------------- output */

static void heading(const options *o, const char *text)
{
  printf("%s%s\n\n", o->markdown ? "## " : "", text);
}

static void print_machine(const options *o)
{
  const char *bullet = o->markdown ? "- " : "";
  char model[256];
  double mhz;
  int processors;

  machine(sizeof model, model, &mhz, &processors);
  printf("%smachine   %s, %.0f MHz (measured: %.0f), %d processors\n", bullet, model, mhz,
         clock_mhz(), processors);
  printf("%scompiler  %s\n", bullet, MAGGI_BENCH_COMPILER);
  printf("%sflags     %s (kernel)\n", bullet, MAGGI_BENCH_FLAGS);
  printf("%smaggi     %s\n\n", bullet, MAGGI_VERSION);
}

static void csv_head(FILE *csv)
{
  if (csv)
    fprintf(csv, "suite,case,ny,nz,coordinates,dof,us,us_low,us_high,flops,executed,step_s,cpu_s,"
                 "drift,error_rad\n");
}

static void csv_case(FILE *csv, const char *suite, const bench_case *c)
{
  if (csv)
    fprintf(csv, "%s,%s,%d,%d,%d,%d,%.9g,%.9g,%.9g,%ld,%ld,,,,\n", suite, c->name, c->ny, c->nz,
            c->coordinates, c->dof, c->us, c->low, c->high, c->flops, c->executed);
}

static void csv_run(FILE *csv, const bench_run *r)
{
  if (csv)
    fprintf(csv, "accuracy,multiple-four-bar:1x15,1,15,45,15,,,,,,%.9g,%.9g,%.9g,%.9g\n", r->step,
            r->cpu, r->drift, r->error);
}

static void cell_us(table *t, double us)
{
  table_cell(t, us < 10.0 ? "%.3f" : us < 1000.0 ? "%.1f" : "%.0f", us);
}

static void cells_flops(table *t, const bench_case *c)
{
  table_cell(t, "%ld", c->flops);
  if (c->executed > 0)
    table_cell(t, "%ld", c->executed);
  else
    table_cell(t, "-");
  table_cell(t, "%.2f", 1e-3 * (double)c->flops / c->us);
}

static void print_evaluations(const options *o, int n, const bench_case cases[])
{
  static table t;
  const bench_case *c;
  int i, k;

  table_begin(&t, "model|coordinates|dof|us|+- %|flops|executed|GFlop/s|target us|limit us|"
                  "limit flops|MuJoCo us");
  for (i = 0; i < n; ++i) {
    c = &cases[i];
    table_row(&t);
    table_cell(&t, "%s", c->name);
    table_cell(&t, "%d", c->coordinates);
    table_cell(&t, "%d", c->dof);
    cell_us(&t, c->us);
    table_cell(&t, "%.0f", 50.0 * (c->high - c->low) / c->us);
    cells_flops(&t, c);
    for (k = 0; k < NKNOWN && strcmp(known[k].model, c->name) != 0; ++k) continue;
    if (k < NKNOWN) {
      table_cell(&t, "%g %s", known[k].target, c->us <= known[k].target ? "met" : "missed");
      table_cell(&t, "%g-%g", known[k].limit_low, known[k].limit_high);
      table_cell(&t, "%g", known[k].least_flops);
      table_cell(&t, "%g-%g", known[k].mujoco_low, known[k].mujoco_high);
    }
  }
  table_print(&t, o->markdown);
  printf("flops: + - * / sqrt sin cos as 1 each, of the columns that a row has; GFlop/s of these;\n"
         "executed: with what fills blocks of %d columns\n\n",
         MAGGI_WIDTH);
}

/* --------------------------------------------------------------------------- suites */

static bench_case cases[MODELS_MAX];

/* open, measure and count what the names say; returns how many there are in `cases` */
static int measure(int n, char names[][CASE_NAME], int samples)
{
  bench_flops counts;
  int i, opened = 0;

  for (i = 0; i < n; ++i) {
    if (case_open(&cases[opened], names[i]))
      ++opened;
    else
      case_close(&cases[opened]);
  }
  cases_measure(opened, cases, ROUNDS, samples);
  for (i = 0; i < opened; ++i) case_count(&cases[i], &counts);
  return opened;
}

static void close_cases(int n)
{
  int i;

  for (i = 0; i < n; ++i) case_close(&cases[i]);
}

static void suite_evaluations(const options *o, const char *suite)
{
  char names[MODELS_MAX][CASE_NAME];
  int i, n = 0, several = strcmp(suite, "multiple-four-bar") == 0;
  int all = strcmp(suite, "all") == 0;

  if (!several) n = shipped_models(MODELS_MAX - 3, names);
  if (!several && !all) {
    int kept = 0;
    for (i = 0; i < n; ++i)
      if ((strstr(names[i], "four-bar") && !strstr(names[i], "n-four")) ||
          strcmp(names[i], "rssr") == 0)
        memmove(names[kept++], names[i], CASE_NAME);
    n = kept;
  }
  if (several || all) {
    snprintf(names[n++], CASE_NAME, "multiple-four-bar:1x15");
    snprintf(names[n++], CASE_NAME, "multiple-four-bar:4x15");
    snprintf(names[n++], CASE_NAME, "multiple-four-bar:7x15");
  }
  heading(o, "One evaluation of the right-hand side");
  n = measure(n, names, SAMPLES);
  print_evaluations(o, n, cases);
  for (i = 0; i < n; ++i) csv_case(o->csv, "evaluation", &cases[i]);
  for (i = 0; o->profile && i < n; ++i) profile(o->markdown, &cases[i]);
  close_cases(n);
}

static void print_scaling(const options *o, const char *suite, int n, int by_width)
{
  static table t;
  double x[MODELS_MAX], y[MODELS_MAX], work[MODELS_MAX];
  double slope, late;
  int i, begin = 0;

  table_begin(&t, "model|coordinates|dof|us|+- %|flops|executed|GFlop/s|ns a coordinate");
  for (i = 0; i < n; ++i) {
    table_row(&t);
    table_cell(&t, "%dx%d", cases[i].ny, cases[i].nz);
    table_cell(&t, "%d", cases[i].coordinates);
    table_cell(&t, "%d", cases[i].dof);
    cell_us(&t, cases[i].us);
    table_cell(&t, "%.0f", 50.0 * (cases[i].high - cases[i].low) / cases[i].us);
    cells_flops(&t, &cases[i]);
    table_cell(&t, "%.0f", 1e3 * cases[i].us / cases[i].coordinates);
    csv_case(o->csv, suite, &cases[i]);
    x[i] = by_width ? cases[i].ny : cases[i].nz;
    y[i] = cases[i].us;
    work[i] = (double)cases[i].flops;
    if (x[i] < 7.0) begin = i + 1;
  }
  table_print(&t, o->markdown);
  slope = log_slope(n, x, y);
  late = log_slope(n - begin, x + begin, y + begin);
  printf("exponent in %s: %.2f over all, %.2f from 7 on; of the flops %.2f and %.2f",
         by_width ? "n_y" : "n_z", slope, late, log_slope(n, x, work),
         log_slope(n - begin, x + begin, work + begin));
  if (by_width)
    printf(" (target at most %g: %s)", exponent_target,
           slope <= exponent_target ? "met" : "missed");
  printf("\n\n");
}

/* n cases that `format` makes of the sizes */
static void scale(const options *o, const char *title, const char *id, const char *format,
                  const int *sizes, int n, int by_width)
{
  char names[MODELS_MAX][CASE_NAME];
  int i;

  for (i = 0; i < n; ++i) snprintf(names[i], CASE_NAME, format, sizes[i]);
  heading(o, title);
  n = measure(n, names, SAMPLES / 2);
  print_scaling(o, id, n, by_width);
  close_cases(n);
}

static void suite_scaling(const options *o)
{
  static const int ny[] = {1, 2, 4, 7, 10, 15, 22, 33, 50, 70, 100};
  static const int nz[] = {1, 2, 4, 7, 10, 15, 22, 30, 40, 50, 60};

  scale(o, "Cost against the number of four-bars side by side", "scaling-ny",
        "multiple-four-bar:%dx15", ny, sizeof ny / sizeof ny[0], 1);
  scale(o, "Cost against the number of rows, each with a degree of freedom", "scaling-nz",
        "multiple-four-bar:1x%d", nz, sizeof nz / sizeof nz[0], 0);
}

/* CPU time where the error falls below `error_at`, on the straight line in logarithms */
static double seconds_at(const bench_run r[NSTEP])
{
  double w;
  int i;

  for (i = NSTEP - 1; i > 0 && r[i].error <= error_at; --i) {
    if (!(r[i - 1].error <= error_at)) {
      if (isnan(r[i - 1].error)) return r[i].cpu;
      w = log(error_at / r[i].error) / log(r[i - 1].error / r[i].error);
      return exp((1.0 - w) * log(r[i].cpu) + w * log(r[i - 1].cpu));
    }
  }
  return r[i].error <= error_at ? r[i].cpu : NAN;
}

static void suite_accuracy(const options *o)
{
  static table t;
  bench_run r[NSTEP];
  bench_case c;
  maggi_status status;
  double cpu[NSTEP][ROUNDS], at;
  int i, k;

  if (!case_open(&c, "multiple-four-bar:1x15")) return;
  for (k = 0; k < ROUNDS; ++k) {
    for (i = 0; i < NSTEP; ++i) {
      status = run_array(c.d, steps[i], &r[i]);
      if (status != MAGGI_OK && k == 0)
        printf("step %g s: %s\n", steps[i], maggi_data_message(c.d));
      cpu[i][k] = r[i].cpu;
    }
  }
  heading(o, "Five seconds of 1x15");
  table_begin(&t, "step ms|CPU s|evaluations|projections|energy drift|end error rad|"
                  "thesis s|thesis drift");
  for (i = 0; i < NSTEP; ++i) {
    if (!isnan(r[i].cpu)) {
      sort_samples(ROUNDS, cpu[i]);
      r[i].cpu = quantile(ROUNDS, cpu[i], 0.5);
    }
    run_energy(c.d, steps[i], &r[i]);
    table_row(&t);
    table_cell(&t, "%g", 1e3 * r[i].step);
    table_cell(&t, "%.4f", r[i].cpu);
    table_cell(&t, "%ld", r[i].evaluations);
    table_cell(&t, "%ld", r[i].projections);
    table_cell(&t, "%.1e", r[i].drift);
    table_cell(&t, "%.1e", r[i].error);
    for (k = 0; k < NTHESIS; ++k) {
      if (thesis[k].step == steps[i]) {
        table_cell(&t, "%.2f", thesis[k].seconds);
        table_cell(&t, "-%.3f %%", thesis[k].percent);
      }
    }
    csv_run(o->csv, &r[i]);
  }
  table_print(&t, o->markdown);
  at = seconds_at(r);
  printf("at an end error of %g rad: %.4f s\n", error_at, at);
  printf("MuJoCo as measured for issue 2: %g s, ratio %.2f (target at most 0.33); on this machine: "
         "bench-peers\n\n",
         mujoco_seconds, at / mujoco_seconds);
  case_close(&c);
}

/* -------------------------------------------------------------------------- threads */

enum { THREADS = 2, THREAD_ROUNDS = 9, THREAD_STEPS = 1000 };

typedef struct worker {
  const maggi_model *m;
  atomic_int *waiting;
  double cpu, begin, end; /* seconds */
  maggi_status status;
} worker;

static void *work(void *argument)
{
  worker *w = argument;
  maggi_data *d = NULL;
  double cpu;
  int i;

  w->status = maggi_data_create(w->m, &d);
  if (w->status == MAGGI_OK) w->status = maggi_data_reset(d);
  /* a sleeping barrier would wake both threads on one processor */
  atomic_fetch_sub(w->waiting, 1);
  while (atomic_load(w->waiting) > 0) continue;
  w->begin = wall_seconds();
  cpu = cpu_seconds();
  for (i = 0; i < THREAD_STEPS && w->status == MAGGI_OK; ++i) w->status = maggi_step(d, 1e-3);
  w->cpu = cpu_seconds() - cpu;
  w->end = wall_seconds();
  maggi_data_free(d);
  return NULL;
}

/* n simulations at once: simulations a second by wall clock, and by the CPU time of the slowest */
static int together(const maggi_model *m, int n, double *wall, double *cpu)
{
  worker w[THREADS];
  pthread_t thread[THREADS];
  atomic_int waiting = n;
  double begin = INFINITY, end = 0.0, longest = 0.0;
  int i, ok = 1;

  for (i = 0; i < n; ++i) {
    w[i].m = m;
    w[i].waiting = &waiting;
    if (pthread_create(&thread[i], NULL, work, &w[i]) != 0) {
      fprintf(stderr, "bench: a thread cannot be created\n");
      exit(1);
    }
  }
  for (i = 0; i < n; ++i) {
    pthread_join(thread[i], NULL);
    begin = fmin(begin, w[i].begin);
    end = fmax(end, w[i].end);
    longest = fmax(longest, w[i].cpu);
    ok = ok && w[i].status == MAGGI_OK;
  }
  *wall = n / (end - begin);
  *cpu = n / longest;
  return ok;
}

static void suite_threads(const options *o)
{
  double wall[2][THREAD_ROUNDS], cpu[2][THREAD_ROUNDS], best[2] = {0.0, 0.0};
  double w[2], c[2];
  maggi_model *m;
  int k, n;

  if (maggi_model_multiple_four_bar(1, 15, &m) != MAGGI_OK) return;
  heading(o, "Independent simulations: one second of 1x15 by 1 ms, one model shared");
  for (k = 0; k < THREAD_ROUNDS; ++k) {
    for (n = 1; n <= THREADS; ++n) {
      if (!together(m, n, &wall[n - 1][k], &cpu[n - 1][k])) printf("a simulation failed\n");
      best[n - 1] = fmax(best[n - 1], wall[n - 1][k]);
    }
  }
  for (n = 0; n < THREADS; ++n) {
    sort_samples(THREAD_ROUNDS, wall[n]);
    sort_samples(THREAD_ROUNDS, cpu[n]);
    w[n] = quantile(THREAD_ROUNDS, wall[n], 0.5);
    c[n] = quantile(THREAD_ROUNDS, cpu[n], 0.5);
  }
  printf("simulations/s by wall clock: 1 thread %.1f, 2 threads %.1f, ratio %.2f (best %.2f)\n",
         w[0], w[1], w[1] / w[0], best[1] / best[0]);
  printf("simulations/s by CPU time:   1 thread %.1f, 2 threads %.1f, ratio %.2f (whatever else "
         "runs)\n\n",
         c[0], c[1], c[1] / c[0]);
  maggi_model_free(m);
}

/* ---------------------------------------------------------------------------- flops */

static const double flops_tolerance = 0.03;

/* flops from topology and plan against those that are executed; 1 if they differ too much */
static int suite_flops(const options *o)
{
  static table t;
  static bench_case c;
  char names[MODELS_MAX][CASE_NAME];
  bench_flops f;
  double differ;
  int i, k, n = shipped_models(MODELS_MAX - 7, names), wrong = 0;

  snprintf(names[n++], CASE_NAME, "multiple-four-bar:1x15");
  snprintf(names[n++], CASE_NAME, "multiple-four-bar:4x15");
  snprintf(names[n++], CASE_NAME, "multiple-four-bar:3x9");
  snprintf(names[n++], CASE_NAME, "multiple-four-bar:2x20");
#ifdef MAGGI_BENCH_YAML
  snprintf(names[n++], CASE_NAME, "coach/turn");
  snprintf(names[n++], CASE_NAME, "coach/double-lane-change");
  snprintf(names[n++], CASE_NAME, "coach/bumps");
#endif
  table_begin(&t, "model|needed|by blocks|executed|differ %|where");
  for (k = 0; k < n; ++k) {
    if (!case_open(&c, names[k])) return 1;
    case_count(&c, &f);
    differ = c.executed > 0 ? (double)(c.blocks - c.executed) / (double)c.executed : 0.0;
    wrong = wrong || fabs(differ) > flops_tolerance;
    table_row(&t);
    table_cell(&t, "%s", c.name);
    table_cell(&t, "%ld", c.flops);
    table_cell(&t, "%ld", c.blocks);
    table_cell(&t, "%ld", c.executed);
    table_cell(&t, "%.2f", 100.0 * differ);
    for (i = 0; i < STAGED_COUNT && (c.executed == 0 || f.blocks[i] == f.executed[i]); ++i)
      continue;
    if (i < STAGED_COUNT)
      table_cell(&t, "%s %ld", profile_function[i], f.blocks[i] - f.executed[i]);
    case_close(&c);
  }
  heading(o, "Flops of one evaluation");
  table_print(&t, o->markdown);
  return wrong;
}

/* ------------------------------------------------------------------------ for peers */

static int one_evaluation(const char *spec)
{
  static bench_case c;
  bench_flops counts;

  if (!case_open(&c, spec)) return 1;
  cases_measure(1, &c, 1, SAMPLES);
  case_count(&c, &counts);
  printf("%.9g %.9g %.9g %ld\n", c.us, c.low, c.high, c.flops);
  case_close(&c);
  return 0;
}

static int quarter_step(const char *spec, double h, int n)
{
  static bench_case c;
  maggi_status status = MAGGI_OK;
  double begin;
  int i;

  if (!case_open(&c, spec)) return 1;
  status = maggi_data_reset(c.d);
  begin = cpu_seconds();
  for (i = 0; i < n && status == MAGGI_OK; ++i) status = maggi_step(c.d, h);
  printf("%.9g\n", 1e6 * (cpu_seconds() - begin) / (4.0 * n));
  case_close(&c);
  return status != MAGGI_OK;
}

static int one_run(double h)
{
  static bench_case c;
  bench_run r;
  maggi_status status;

  if (!case_open(&c, "multiple-four-bar:1x15")) return 1;
  status = run_array(c.d, h, &r);
  printf("%.9g %.9g\n", r.cpu, r.error);
  case_close(&c);
  return status != MAGGI_OK;
}

static void print_array(const char *name, int n, const double x[], const char *end)
{
  int i;

  printf("\"%s\": [", name);
  for (i = 0; i < n; ++i) printf("%s%.17g", i ? ", " : "", x[i]);
  printf("]%s", end);
}

static int state(const char *spec, double time, double h)
{
  static bench_case c;
  maggi_status status;
  double *x;
  int i, n, steps_to = (int)(time / h + 0.5);

  if (!case_open(&c, spec)) return 1;
  n = c.coordinates;
  x = calloc((size_t)n, 3 * sizeof *x);
  if (!x) return 1;
  status = maggi_data_reset(c.d);
  for (i = 0; i < steps_to && status == MAGGI_OK; ++i) status = maggi_step(c.d, h);
  maggi_get_coordinates(c.d, x, x + n, x + 2 * n);
  printf("{\"time\": %.17g, \"names\": [", maggi_get_time(c.d));
  for (i = 0; i < n; ++i) printf("%s\"%s\"", i ? ", " : "", maggi_coordinate_name(c.m, i));
  printf("], ");
  print_array("q", n, x, ", ");
  print_array("v", n, x + n, ", ");
  print_array("a", n, x + 2 * n, "}\n");
  free(x);
  case_close(&c);
  return status != MAGGI_OK;
}

/* ----------------------------------------------------------------------------- main */

static const char *const suites[] = {"four-bar", "multiple-four-bar", "scaling",
                                     "accuracy", "threads",           "all"};
enum { NSUITE = sizeof suites / sizeof suites[0] };

static int usage(void)
{
  fprintf(stderr, "usage: bench [four-bar|multiple-four-bar|scaling|accuracy|threads|flops|all] "
                  "[--profile] [--markdown] [--csv FILE]\n");
  return 2;
}

int main(int argc, char **argv)
{
  options o = {0, 0, NULL};
  const char *suite = "all";
  int i, all;

  if (argc == 3 && strcmp(argv[1], "evaluation") == 0) return one_evaluation(argv[2]);
  if (argc == 5 && strcmp(argv[1], "step") == 0)
    return quarter_step(argv[2], atof(argv[3]), atoi(argv[4]));
  if (argc == 3 && strcmp(argv[1], "run") == 0) return one_run(atof(argv[2]));
  if (argc == 5 && strcmp(argv[1], "state") == 0)
    return state(argv[2], atof(argv[3]), atof(argv[4]));

  for (i = 1; i < argc; ++i) {
    if (strcmp(argv[i], "--markdown") == 0) {
      o.markdown = 1;
    } else if (strcmp(argv[i], "--profile") == 0) {
      o.profile = 1;
    } else if (strcmp(argv[i], "--csv") == 0 && i + 1 < argc && !o.csv) {
      o.csv = fopen(argv[++i], "w");
      if (!o.csv) {
        perror(argv[i]);
        return 1;
      }
    } else if (argv[i][0] != '-') {
      suite = argv[i];
    } else {
      return usage();
    }
  }
  all = strcmp(suite, "all") == 0;
  if (strcmp(suite, "flops") == 0) return suite_flops(&o);
  for (i = 0; i < NSUITE && strcmp(suite, suites[i]) != 0; ++i) continue;
  if (i == NSUITE) return usage();
  csv_head(o.csv);
  print_machine(&o);
  if (all || strstr(suite, "four-bar")) suite_evaluations(&o, suite);
  if (all || strcmp(suite, "scaling") == 0) suite_scaling(&o);
  if (all || strcmp(suite, "accuracy") == 0) suite_accuracy(&o);
  if (all || strcmp(suite, "threads") == 0) suite_threads(&o);
  return o.csv && fclose(o.csv) != 0;
}
