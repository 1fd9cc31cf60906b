/* bench-differentiation [MODEL ..] [--rounds N] [--profile] [--markdown] [--csv FILE]
 *
 * Derivatives of one evaluation of the equations of motion, by maggi and by others on the same
 * kernel, as ratios to the time of the evaluation.  All are first checked against maggi's; the
 * program fails if they differ.
 *
 * In each round the tasks of all methods follow one another, each with plain evaluations beside it:
 * a ratio is the median of those of the rounds, +- the quarter of them on either side.  Times are
 * CPU time of this thread. */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "apart.h"
#include "cases.h"
#include "data.h"
#include "methods.h"
#include "table.h"
#include "timing.h"

static const method *const methods[] = {
    &method_maggi,       &method_maggi_once,
#ifdef BENCH_ADOLC
    &method_adolc,       &method_adolc_retaping,
#endif
#ifdef BENCH_CPPAD
    &method_cppad,       &method_cppad_retaping,
#endif
#ifdef BENCH_EIGEN
    &method_eigen,
#endif
    &method_differences,
};
enum { NMETHOD = sizeof methods / sizeof methods[0] };

/* what is not in this build, and how to have it */
static const char *const absent[] = {
#ifndef BENCH_ADOLC
    "ADOL-C is not here: apt-get install libadolc-dev, and configure again",
#endif
#ifndef BENCH_CPPAD
    "CppAD is not here: .venv/bin/pip install cmeel-cppad, and configure again",
#endif
#ifndef BENCH_EIGEN
    "Eigen is not here: apt-get install libeigen3-dev, and configure again",
#endif
    NULL};

enum { TASK_DIRECTIONS, TASK_DIRECTION, TASK_GRADIENT, TASK_HESSIAN, NTASK };

/* ratios that issue 3 asks for: first, then */
static const struct task {
  const char *name;
  double target, then;
} tasks[NTASK] = {
    {"35 directions", 15.0, 12.0},
    {"one direction", 2.5, 2.5},
    {"gradient", 4.0, 2.5},
    {"Hessian-vector", 12.0, 8.0},
};

static const char *const models[] = {
#ifdef MAGGI_BENCH_YAML
    "spatial-four-bar",
    "chain-30",
#endif
    "multiple-four-bar:1x15",
    "multiple-four-bar:7x15",
};
enum { NMODEL = sizeof models / sizeof models[0] };

static const double sample_seconds = 0.2e-3; /* at least */
static const double task_seconds = 2.0;  /* all rounds of a task, if they leave enough of them */
static const double warm_seconds = 5e-3; /* a shorter call comes once more before its sample */
enum { ROUNDS = 101, ROUNDS_LEAST = 7, ROUNDS_MOST = 1001 };

typedef struct options {
  int markdown, profile, rounds;
  FILE *csv;
} options;

/* one method, one task, one model */
typedef struct cell {
  int batch; /* calls a sample */
  int every; /* rounds from one sample to the next */
  int warm;  /* whether a call comes before a sample */
  int nsample;
  double ratio[ROUNDS_MOST], us[ROUNDS_MOST];
} cell;

typedef struct bench {
  bench_case c;
  problem of;
  void *m[NMETHOD];
  int *q;
  double *x;             /* point */
  double *xds, *xd, *yb; /* seeds */
  double *result[NTASK]; /* of maggi */
  double *other;         /* of another method */
  cell cell[NMETHOD][NTASK];
} bench;

static bench b;

/* ---------------------------------------------------------------------------- problem */

/* between -1 and 1 */
static double noise(unsigned *seed)
{
  *seed = *seed * 1664525u + 1013904223u;
  return (double)(*seed >> 8) / (double)(1u << 23) - 1.0;
}

static int offered(const method *m, int task)
{
  return (task == TASK_DIRECTIONS && m->directions) || (task == TASK_DIRECTION && m->direction) ||
         (task == TASK_GRADIENT && m->gradient) || (task == TASK_HESSIAN && m->hessian);
}

static void call(int k, int task, double *result)
{
  const method *m = methods[k];

  if (task == TASK_DIRECTIONS)
    m->directions(b.m[k], b.xds, result);
  else if (task == TASK_DIRECTION)
    m->direction(b.m[k], b.xd, result);
  else if (task == TASK_GRADIENT)
    m->gradient(b.m[k], b.yb, result);
  else
    m->hessian(b.m[k], b.yb, b.xd, result);
}

static int result_size(int task)
{
  if (task == TASK_DIRECTIONS) return b.of.ny * DIRECTIONS;
  return task == TASK_DIRECTION ? b.of.ny : b.of.nx;
}

static void out_of_memory(void)
{
  fprintf(stderr, "bench-differentiation: out of memory\n");
  exit(1);
}

static double *numbers(int n)
{
  double *a = calloc((size_t)n + 1, sizeof *a);

  if (!a) out_of_memory();
  return a;
}

static void open_problem(void)
{
  maggi_data *d = b.c.d;
  const maggi_topo *t = &d->t;
  unsigned seed = 1;
  int i, k, n = t->nq, nx = 2 * n + t->np, ny = 2 * n;

  b.x = numbers(nx);
  b.xds = numbers(nx * DIRECTIONS);
  b.xd = numbers(nx);
  b.yb = numbers(ny);
  b.other = numbers(nx > ny * DIRECTIONS ? nx : ny * DIRECTIONS);
  b.q = calloc((size_t)n + 1, sizeof *b.q);
  if (!b.q) out_of_memory();
  for (i = 0; i < n; ++i) b.q[i] = d->m->coordinate[i].q;
  maggi_get_coordinates(d, b.x, b.x + n, NULL);
  memcpy(b.x + 2 * n, d->p, (size_t)t->np * sizeof(double));
  for (i = 0; i < nx; ++i) {
    b.xd[i] = noise(&seed) * fmax(1.0, fabs(b.x[i]));
    for (k = 0; k < DIRECTIONS; ++k)
      b.xds[i * DIRECTIONS + k] = noise(&seed) * fmax(1.0, fabs(b.x[i]));
  }
  for (i = 0; i < ny; ++i) b.yb[i] = noise(&seed);
  b.of = (problem){d, t, d->m->originadr, b.q, b.c.time, nx, ny, b.x};
  for (k = 0; k < NTASK; ++k) b.result[k] = numbers(result_size(k));
  for (k = 0; k < NMETHOD; ++k) {
    b.m[k] = methods[k]->open(&b.of);
    if (!b.m[k]) {
      fprintf(stderr, "bench-differentiation: %s cannot be opened\n", methods[k]->name);
      exit(1);
    }
  }
}

static void close_problem(void)
{
  int k;

  for (k = 0; k < NMETHOD; ++k) methods[k]->close(b.m[k]);
  for (k = 0; k < NTASK; ++k) free(b.result[k]);
  free(b.q);
  free(b.x);
  free(b.xds);
  free(b.xd);
  free(b.yb);
  free(b.other);
}

/* ------------------------------------------------------------------------------ check */

/* largest difference of n numbers relative to the largest of them */
static double differ(int n, const double *x, const double *y)
{
  double largest = 0.0, most = 0.0;
  int i;

  for (i = 0; i < n; ++i) {
    if (!isfinite(x[i]) || !isfinite(y[i])) return INFINITY;
    largest = fmax(largest, fabs(y[i]));
    most = fmax(most, fabs(x[i] - y[i]));
  }
  return largest > 0.0 ? most / largest : most;
}

/* the largest of velocities and accelerations, or of positions, velocities and parameters, apart */
static double difference(int task, const double *x, const double *y)
{
  int n = b.of.t->nq, half = result_size(task) / 2;

  if (task == TASK_DIRECTIONS || task == TASK_DIRECTION)
    return fmax(differ(half, x, y), differ(half, x + half, y + half));
  return fmax(fmax(differ(n, x, y), differ(n, x + n, y + n)),
              differ(b.of.t->np, x + 2 * n, y + 2 * n));
}

/* derivatives of every method against those of maggi; 1 if they are not the same */
static int check(const options *o)
{
  static table t;
  double e;
  int k, task, wrong = 0;

  for (task = 0; task < NTASK; ++task) call(0, task, b.result[task]);
  table_begin(&t, "differs from maggi|35 directions|one direction|gradient|Hessian-vector|at most");
  for (k = 1; k < NMETHOD; ++k) {
    table_row(&t);
    table_cell(&t, "%s", methods[k]->name);
    for (task = 0; task < NTASK; ++task) {
      if (!offered(methods[k], task)) {
        table_cell(&t, "-");
        continue;
      }
      call(k, task, b.other);
      e = difference(task, b.other, b.result[task]);
      table_cell(&t, "%.0e%s", e, e <= methods[k]->tolerance ? "" : " WRONG");
      wrong = wrong || !(e <= methods[k]->tolerance);
    }
    table_cell(&t, "%.0e", methods[k]->tolerance);
  }
  table_print(&t, o->markdown);
  return wrong;
}

/* ----------------------------------------------------------------------------- timing */

static double evaluation_seconds(int n)
{
  double begin = cpu_seconds();
  int i;

  for (i = 0; i < n; ++i) maggi_evaluate(b.of.d, b.of.time);
  return cpu_seconds() - begin;
}

static double call_seconds(int k, int task, int n)
{
  double begin = cpu_seconds();
  int i;

  for (i = 0; i < n; ++i) call(k, task, b.other);
  return cpu_seconds() - begin;
}

static int evaluation_batch(void)
{
  int n = 1;

  while (n < 1 << 20 && evaluation_seconds(n) < sample_seconds) n *= 2;
  return n;
}

static void prepare(int k, int task, int rounds)
{
  cell *c = &b.cell[k][task];
  double seconds;

  memset(c, 0, sizeof *c);
  c->batch = 1;
  while (c->batch < 1 << 20 && call_seconds(k, task, c->batch) < sample_seconds) c->batch *= 2;
  seconds = call_seconds(k, task, c->batch);
  c->warm = seconds < warm_seconds;
  c->every = 1 + (int)(rounds * seconds / task_seconds);
  if (c->every > rounds / ROUNDS_LEAST) c->every = rounds / ROUNDS_LEAST;
  if (c->every < 1) c->every = 1;
}

/* caches as they are after the same thing */
static void sample(int k, int task, int batch)
{
  cell *c = &b.cell[k][task];
  double plain, us;

  evaluation_seconds(1 + batch / 4);
  plain = 1e6 * evaluation_seconds(batch) / batch;
  if (c->warm) call(k, task, b.other);
  us = 1e6 * call_seconds(k, task, c->batch) / c->batch;
  c->us[c->nsample] = us;
  c->ratio[c->nsample] = us / plain;
  ++c->nsample;
}

/* returns microseconds of the plain evaluation */
static double measure(int rounds)
{
  static double plain[ROUNDS_MOST];
  int batch = evaluation_batch();
  int k, task, round;

  for (k = 0; k < NMETHOD; ++k)
    for (task = 0; task < NTASK; ++task)
      if (offered(methods[k], task)) prepare(k, task, rounds);
  for (round = 0; round < rounds; ++round) {
    plain[round] = 1e6 * evaluation_seconds(batch) / batch;
    for (k = 0; k < NMETHOD; ++k)
      for (task = 0; task < NTASK; ++task)
        if (offered(methods[k], task) && round % b.cell[k][task].every == 0) sample(k, task, batch);
  }
  for (k = 0; k < NMETHOD; ++k) {
    for (task = 0; task < NTASK; ++task) {
      sort_samples(b.cell[k][task].nsample, b.cell[k][task].ratio);
      sort_samples(b.cell[k][task].nsample, b.cell[k][task].us);
    }
  }
  sort_samples(rounds, plain);
  return quantile(rounds, plain, 0.5);
}

/* microseconds of the parts of maggi's derivatives, and ratios to plain evaluations beside them */
static void measure_parts(int rounds, double us[NPART], double ratio[NPART])
{
  static double times[NPART][ROUNDS_MOST], ratios[NPART][ROUNDS_MOST];
  int batch = evaluation_batch();
  double begin, plain;
  int i, part, round;

  for (round = 0; round < rounds; ++round) {
    for (part = 0; part < NPART; ++part) {
      plain = evaluation_seconds(batch) / batch;
      begin = cpu_seconds();
      for (i = 0; i < batch; ++i) maggi_part(b.m[0], part, b.xds, b.xd, b.yb, b.other);
      times[part][round] = 1e6 * (cpu_seconds() - begin) / batch;
      ratios[part][round] = 1e-6 * times[part][round] / plain;
    }
  }
  for (part = 0; part < NPART; ++part) {
    sort_samples(rounds, times[part]);
    sort_samples(rounds, ratios[part]);
    us[part] = quantile(rounds, times[part], 0.5);
    ratio[part] = quantile(rounds, ratios[part], 0.5);
  }
}

/* ----------------------------------------------------------------------------- output */

static void print_machine(const options *o)
{
  const char *bullet = o->markdown ? "- " : "";
  char model[256];
  double mhz;
  int i, processors;

  machine(sizeof model, model, &mhz, &processors);
  printf("%smachine   %s, %.0f MHz (measured: %.0f), %d processors\n", bullet, model, mhz,
         clock_mhz(), processors);
  printf("%scompiler  %s\n", bullet, MAGGI_BENCH_COMPILER);
  printf("%sflags     %s (kernel)\n", bullet, MAGGI_BENCH_FLAGS);
  printf("%sstrips    %d directions (MAGGI_DIRECTIONS)\n", bullet, MAGGI_NDIR);
  printf("%smaggi     %s\n", bullet, MAGGI_VERSION);
  for (i = 0; absent[i]; ++i) printf("%s%s\n", bullet, absent[i]);
  printf("\n");
}

static void cell_us(table *t, double us)
{
  table_cell(t, us < 10.0 ? "%.3f" : us < 1000.0 ? "%.1f" : "%.0f", us);
}

static void print_results(const options *o, double plain)
{
  static table t;
  const cell *c;
  double ratio, low, high;
  int k, task;

  table_begin(&t, "method|35 directions|+- %|us|one direction|+- %|us|gradient|+- %|us|"
                  "Hessian-vector|+- %|us");
  for (k = 0; k < NMETHOD; ++k) {
    table_row(&t);
    table_cell(&t, "%s", methods[k]->name);
    for (task = 0; task < NTASK; ++task) {
      c = &b.cell[k][task];
      if (!offered(methods[k], task)) {
        table_cell(&t, "-");
        table_cell(&t, "");
        table_cell(&t, "");
        continue;
      }
      ratio = quantile(c->nsample, c->ratio, 0.5);
      low = quantile(c->nsample, c->ratio, 0.25);
      high = quantile(c->nsample, c->ratio, 0.75);
      table_cell(&t, ratio < 100.0 ? "%.2f" : "%.0f", ratio);
      table_cell(&t, "%.0f", 50.0 * (high - low) / ratio);
      cell_us(&t, quantile(c->nsample, c->us, 0.5));
      if (o->csv)
        fprintf(o->csv, "differentiation,%s,\"%s\",%s,%.9g,%.9g,%.9g,%.9g,%.9g,%g,%g\n", b.c.name,
                methods[k]->name, tasks[task].name, ratio, low, high,
                quantile(c->nsample, c->us, 0.5), plain, tasks[task].target, tasks[task].then);
    }
  }
  table_print(&t, o->markdown);
}

static void print_targets(double ratio, const struct task *task)
{
  printf("%s %.2f: at most %g %s", task->name, ratio, task->target,
         ratio <= task->target ? "met" : "missed");
  if (task->then < task->target)
    printf(", then %g %s", task->then, ratio <= task->then ? "met" : "missed");
}

static void print_parts(const options *o)
{
  static const char *const names[] = {
#define X(part, name) name,
      PART_LIST(X)
#undef X
  };
  static table t;
  double us[NPART], ratio[NPART];
  int part;

  measure_parts(o->rounds, us, ratio);
  table_begin(&t, "part of maggi|ratio|us");
  for (part = 0; part < NPART; ++part) {
    table_row(&t);
    table_cell(&t, "%s", names[part]);
    table_cell(&t, "%.2f", ratio[part]);
    cell_us(&t, us[part]);
  }
  table_print(&t, o->markdown);
}

static int run(const void *of, const char *model)
{
  const options *o = of;
  double plain;
  int task, wrong;

  if (!case_open(&b.c, model)) return 1;
  open_problem();
  printf("%s%s: %d inputs (q %d, v %d, p %d), %d outputs (v, a)\n\n", o->markdown ? "## " : "",
         b.c.name, b.of.t->nq + b.of.t->nind + b.of.t->np, b.of.t->nq, b.of.t->nind, b.of.t->np,
         b.of.ny);
  wrong = check(o);
  if (wrong) {
    fprintf(stderr, "bench-differentiation: %s: derivatives differ\n", b.c.name);
  } else {
    plain = measure(o->rounds);
    print_results(o, plain);
    printf("one evaluation: %.3f us\n", plain);
    for (task = 0; task < NTASK; ++task) {
      print_targets(quantile(b.cell[0][task].nsample, b.cell[0][task].ratio, 0.5), &tasks[task]);
      printf("%s", task < NTASK - 1 ? "; " : "\n\n");
    }
    if (o->profile) print_parts(o);
  }
  close_problem();
  case_close(&b.c);
  return wrong;
}

/* ------------------------------------------------------------------------------- main */

static int usage(void)
{
  fprintf(stderr, "usage: bench-differentiation [MODEL ..] [--rounds N] [--profile] "
                  "[--markdown] [--csv FILE]\n");
  return 2;
}

int main(int argc, char **argv)
{
  options o = {0, 0, ROUNDS, NULL};
  const char *chosen[NMODEL];
  int i, n = 0, wrong = 0;

  for (i = 1; i < argc; ++i) {
    if (strcmp(argv[i], "--markdown") == 0) {
      o.markdown = 1;
    } else if (strcmp(argv[i], "--profile") == 0) {
      o.profile = 1;
    } else if (strcmp(argv[i], "--rounds") == 0 && i + 1 < argc) {
      o.rounds = atoi(argv[++i]);
      if (o.rounds < 1 || o.rounds > ROUNDS_MOST) return usage();
    } else if (strcmp(argv[i], "--csv") == 0 && i + 1 < argc && !o.csv) {
      o.csv = fopen(argv[++i], "w");
      if (!o.csv) {
        perror(argv[i]);
        return 1;
      }
    } else if (argv[i][0] != '-' && n < NMODEL) {
      chosen[n++] = argv[i];
    } else {
      return usage();
    }
  }
  for (i = 0; n == 0 && i < NMODEL; ++i) chosen[i] = models[i];
  if (n == 0) n = NMODEL;
  if (o.csv)
    fprintf(o.csv, "suite,case,method,task,ratio,ratio_low,ratio_high,us,plain_us,target,then\n");
  print_machine(&o);
  for (i = 0; i < n; ++i) wrong = run_apart(run, &o, chosen[i]) || wrong;
  return wrong || (o.csv && fclose(o.csv) != 0);
}
