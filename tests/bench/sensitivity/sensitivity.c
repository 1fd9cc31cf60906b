/* bench-sensitivity [MODEL ..] [--rounds N] [--steps N] [--markdown] [--csv FILE]
 *
 * The gradient of int q_1^2 dt of a short simulation with respect to numbers of the model, in several
 * ways, as ratios to the time of the plain simulation: maggi_data_reset and maggi_step.  All are first
 * checked against the adjoint; the program fails if they differ.
 *
 * In each round the ways follow one another, each with plain simulations beside it: a ratio is the
 * median of those of the rounds, +- the quarter of them on either side.  Times are CPU time of this
 * thread, with several threads wall time.  Ways that integrate without a reset and are slow take
 * fewer steps, and their time is scaled. */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "apart.h"
#include "cases.h"
#include "data.h"
#include "table.h"
#include "timing.h"
#include "ways.h"

/* ratios that issue 4 asks for; differences are 2 simulations a parameter by definition */
static const struct row {
  const way *way;
  int n;
  double target; /* 0: none */
} rows[] = {
    {&way_direct, 1, 0.0},
    {&way_direct, 5, 0.0},
    {&way_direct, 18, 0.0},
    {&way_direct, PARAMETERS, 15.0},
    {&way_threads, PARAMETERS, 0.0},
    {&way_adjoint, ALL, 5.0},
    {&way_continuous, ALL, 0.0},
    {&way_jacobian, PARAMETERS, 0.0},
    {&way_forward, PARAMETERS, 0.0},
    {&way_differences, 1, 0.0},
    {&way_differences, 5, 0.0},
    {&way_differences, 18, 0.0},
    {&way_differences, PARAMETERS, 0.0},
#ifdef BENCH_ADOLC
    {&way_adolc, 1, 0.0},
    {&way_adolc, 5, 0.0},
    {&way_adolc, 18, 0.0},
    {&way_adolc, PARAMETERS, 0.0},
    {&way_adolc_unsolved, PARAMETERS, 0.0},
    {&way_adolc_jacobian, PARAMETERS, 0.0},
#endif
};
enum { NROW = sizeof rows / sizeof rows[0] };

static const char *const models[] = {
#ifdef MAGGI_BENCH_YAML
    "spatial-four-bar",       "chain-30",
#endif
    "multiple-four-bar:1x15", "multiple-four-bar:4x15",
    "multiple-four-bar:7x15",
};
enum { NMODEL = sizeof models / sizeof models[0] };

static const double step = 1e-3;
static const double sample_seconds = 1e-3; /* at least */
static const double paced_seconds = 1.0;   /* for a sample of a slow way, if a few steps fit */
static const double row_seconds = 4.0;     /* all rounds of a row, if they leave enough of them */
static const double influence = 1e-6; /* least gradient of a parameter relative to the largest */
enum { STEPS = 200, STEPS_MOST = 100000, STEPS_LEAST = 8 };
enum { ROUNDS = 31, ROUNDS_LEAST = 5, ROUNDS_MOST = 301 };

typedef struct options {
  int markdown, rounds, steps;
  FILE *csv;
} options;

typedef struct cell {
  void *self;
  int steps;
  int batch; /* calls a sample */
  int every; /* rounds from one sample to the next */
  int nsample;
  double differs;
  double ratio[ROUNDS_MOST], ms[ROUNDS_MOST];
} cell;

typedef struct bench {
  bench_case c;
  study of;
  char name[256];
  int steps, np;
  int parameter[PARAMETERS];
  double *all, *gradient; /* np + PARAMETERS */
  cell cell[NROW];
} bench;

static bench b;

/* ------------------------------------------------------------------------------ study */

static int fail(const char *what, const char *why)
{
  complain(what, why);
  return 1;
}

/* spread over the entries of p that matter to the objective, and over all where those are too few: the cost
 * is the same */
static int choose_parameters(void)
{
  int *list = malloc((size_t)b.np * sizeof *list);
  double largest = 0.0;
  int i, n = 0;

  for (i = 0; i < b.np; ++i) largest = fmax(largest, fabs(b.all[i]));
  for (i = 0; i < b.np && list; ++i)
    if (fabs(b.all[i]) > influence * largest) list[n++] = i;
  for (i = 0; i < b.np && list && n < PARAMETERS; ++i)
    if (!(fabs(b.all[i]) > influence * largest)) list[n++] = i;
  for (i = 0; i < PARAMETERS && n >= PARAMETERS; ++i) b.parameter[i] = list[i * n / PARAMETERS];
  free(list);
  return n < PARAMETERS;
}

static int open_study(void)
{
  const maggi_model *m = b.c.m;
  char message[256];
  void *self;
  int ok, i;

  snprintf(b.name, sizeof b.name, "integral_square(%s.q)", maggi_coordinate_name(m, 0));
  if (maggi_objective_named(m, b.name, &b.of.objective, message, sizeof message) != MAGGI_OK)
    return fail(b.c.name, message);
  b.np = b.c.d->t.np;
  b.of.m = m;
  b.of.d = b.c.d;
  b.of.name = b.name;
  b.of.step = step;
  b.of.first = m->coordinate[0].q;
  b.of.parameter = b.parameter;
  b.all = calloc((size_t)b.np, sizeof(double));
  b.gradient = calloc((size_t)b.np + PARAMETERS, sizeof(double));
  self = b.all && b.gradient ? way_adjoint.open(&b.of, ALL) : NULL;
  if (!self) return fail(b.c.name, "the adjoint cannot be opened");
  ok = way_adjoint.gradient(self, b.steps, b.all);
  way_adjoint.close(self);
  if (!ok) return 1;
  if (choose_parameters()) return fail(b.c.name, "has too few parameters");
  for (i = 0; i < NROW; ++i) {
    b.cell[i].self = rows[i].way->open(&b.of, rows[i].n);
    if (!b.cell[i].self) return fail(rows[i].way->name, "cannot be opened");
  }
  return 0;
}

static void close_study(void)
{
  int i;

  for (i = 0; i < NROW; ++i)
    if (b.cell[i].self) rows[i].way->close(b.cell[i].self);
  maggi_objective_free(b.of.objective);
  free(b.all);
  free(b.gradient);
}

/* ------------------------------------------------------------------------------ check */

/* largest difference from the adjoint relative to the largest entry, with the steps of the row */
static double difference(const struct row *row, const cell *c)
{
  double largest = 0.0, most = 0.0, y;
  void *self = way_adjoint.open(&b.of, ALL);
  int i, n = row->n == ALL ? b.np : row->n, ok;

  if (!self) return INFINITY;
  ok = way_adjoint.gradient(self, c->steps, b.all);
  way_adjoint.close(self);
  if (!ok || !row->way->gradient(c->self, c->steps, b.gradient)) return INFINITY;
  for (i = 0; i < n; ++i) {
    y = b.all[row->n == ALL ? i : b.parameter[i]];
    if (!isfinite(b.gradient[i]) || !isfinite(y)) return INFINITY;
    largest = fmax(largest, fabs(y));
    most = fmax(most, fabs(b.gradient[i] - y));
  }
  return most / largest;
}

static int check(void)
{
  int i, ok, wrong = 0;

  for (i = 0; i < NROW; ++i) {
    b.cell[i].differs = difference(&rows[i], &b.cell[i]);
    ok = b.cell[i].differs <= rows[i].way->tolerance;
    if (!ok)
      fprintf(stderr, "bench-sensitivity: %s: %s with %d parameters differs by %.0e\n", b.c.name,
              rows[i].way->name, rows[i].n, b.cell[i].differs);
    wrong = wrong || !ok;
  }
  return wrong;
}

/* ----------------------------------------------------------------------------- timing */

static double seconds(int is_parallel)
{
  return is_parallel ? wall_seconds() : cpu_seconds();
}

static double plain_seconds(int n, int is_parallel)
{
  double begin = seconds(is_parallel);
  int i, k;

  for (i = 0; i < n; ++i) {
    maggi_data_reset(b.of.d);
    for (k = 0; k < b.steps; ++k) maggi_step(b.of.d, step);
  }
  return seconds(is_parallel) - begin;
}

static double way_seconds(const struct row *row, const cell *c, int steps, int n)
{
  double begin = seconds(row->way->is_parallel);
  int i;

  for (i = 0; i < n; ++i) row->way->gradient(c->self, steps, b.gradient);
  return seconds(row->way->is_parallel) - begin;
}

static int plain_batch(void)
{
  int n = 1;

  while (n < 1 << 20 && plain_seconds(n, 0) < sample_seconds) n *= 2;
  return n;
}

/* steps of a call: all of them, or what a slow way does in its time */
static void pace(const struct row *row, cell *c)
{
  double one;

  c->steps = b.steps;
  if (!row->way->is_paced) return;
  way_seconds(row, c, 1, 1);
  one = way_seconds(row, c, 1, 1);
  if (one * b.steps > paced_seconds) c->steps = (int)(paced_seconds / one);
  if (c->steps < STEPS_LEAST) c->steps = STEPS_LEAST;
  if (c->steps > b.steps) c->steps = b.steps;
}

static void prepare(const struct row *row, cell *c, int rounds)
{
  double passed;

  c->nsample = 0;
  c->batch = 1;
  while ((passed = way_seconds(row, c, c->steps, c->batch)) < sample_seconds && c->batch < 1 << 20)
    c->batch *= 2;
  c->every = 1 + (int)(rounds * passed / row_seconds);
  if (c->every > rounds / ROUNDS_LEAST) c->every = rounds / ROUNDS_LEAST;
  if (c->every < 1) c->every = 1;
}

static void sample(const struct row *row, cell *c, int batch)
{
  double plain = 1e3 * plain_seconds(batch, row->way->is_parallel) / batch;
  double ms = 1e3 * way_seconds(row, c, c->steps, c->batch) / c->batch * b.steps / c->steps;

  c->ms[c->nsample] = ms;
  c->ratio[c->nsample] = ms / plain;
  ++c->nsample;
}

/* returns milliseconds of the plain simulation */
static double measure(int rounds)
{
  static double plain[ROUNDS_MOST];
  int batch = plain_batch();
  int i, round;

  for (i = 0; i < NROW; ++i) prepare(&rows[i], &b.cell[i], rounds);
  for (round = 0; round < rounds; ++round) {
    plain[round] = 1e3 * plain_seconds(batch, 0) / batch;
    for (i = 0; i < NROW; ++i)
      if (round % b.cell[i].every == 0) sample(&rows[i], &b.cell[i], batch);
  }
  for (i = 0; i < NROW; ++i) {
    sort_samples(b.cell[i].nsample, b.cell[i].ratio);
    sort_samples(b.cell[i].nsample, b.cell[i].ms);
  }
  sort_samples(rounds, plain);
  return quantile(rounds, plain, 0.5);
}

/* ----------------------------------------------------------------------------- output */

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
  printf("%sstrips    %d directions (MAGGI_DIRECTIONS)\n", bullet, MAGGI_NDIR);
  printf("%smaggi     %s\n", bullet, MAGGI_VERSION);
#ifdef BENCH_ADOLC
  printf(
      "%sADOL-C    its sparse_jac needs ColPack, which packages leave out: Jacobians are dense\n",
      bullet);
#else
  printf("%sADOL-C is not here: apt-get install libadolc-dev, and configure again\n", bullet);
#endif
  printf("\n");
}

static double ratio_at(const cell *c, double at)
{
  return quantile(c->nsample, c->ratio, at);
}

static void print_results(const options *o)
{
  static table t;
  const cell *c;
  double ratio, ms;
  int i, n;

  table_begin(&t, "way|parameters|ratio|+- %|ms|steps|samples|differs|at most");
  for (i = 0; i < NROW; ++i) {
    c = &b.cell[i];
    n = rows[i].n == ALL ? b.np : rows[i].n;
    ratio = ratio_at(c, 0.5);
    ms = quantile(c->nsample, c->ms, 0.5);
    table_row(&t);
    table_cell(&t, "%s", rows[i].way->name);
    table_cell(&t, "%d", n);
    table_cell(&t, ratio < 100.0 ? "%.2f" : "%.0f", ratio);
    table_cell(&t, "%.0f", 50.0 * (ratio_at(c, 0.75) - ratio_at(c, 0.25)) / ratio);
    table_cell(&t, ms < 10.0 ? "%.3f" : ms < 1000.0 ? "%.1f" : "%.0f", ms);
    table_cell(&t, "%d", c->steps);
    table_cell(&t, "%d", c->nsample);
    table_cell(&t, "%.0e", c->differs);
    table_cell(&t, "%.0e", rows[i].way->tolerance);
  }
  table_print(&t, o->markdown);
}

static void write_results(FILE *csv, double plain)
{
  maggi_model_info info;
  const cell *c;
  int i;

  maggi_model_get_info(b.c.m, &info);
  for (i = 0; i < NROW; ++i) {
    c = &b.cell[i];
    fprintf(csv, "sensitivity,%s,%d,\"%s\",%d,%.9g,%.9g,%.9g,%.9g,%.9g,%g,%.2g\n", b.c.name,
            info.bodies, rows[i].way->name, rows[i].n == ALL ? b.np : rows[i].n, ratio_at(c, 0.5),
            ratio_at(c, 0.25), ratio_at(c, 0.75), quantile(c->nsample, c->ms, 0.5), plain,
            rows[i].target, c->differs);
  }
}

/* the thesis' Table 5.2 */
static void print_tapes(const options *o)
{
  static table t;
  tape_size size;
  int i;

  table_begin(&t, "tape|parameters|independents|dependents|operations|locations|values|ratio");
  for (i = 0; i < NROW; ++i) {
    if (!rows[i].way->size || rows[i].n != PARAMETERS) continue;
    rows[i].way->size(b.cell[i].self, &size);
    table_row(&t);
    table_cell(&t, "%s", rows[i].way->name);
    table_cell(&t, "%d", rows[i].n);
    table_cell(&t, "%ld", size.independents);
    table_cell(&t, "%ld", size.dependents);
    table_cell(&t, "%ld", size.operations);
    table_cell(&t, "%ld", size.locations);
    table_cell(&t, "%ld", size.values);
    table_cell(&t, "%.1f", ratio_at(&b.cell[i], 0.5));
  }
  if (t.rows > 1) table_print(&t, o->markdown);
}

static void print_targets(void)
{
  const char *before = "";
  double ratio;
  int i;

  for (i = 0; i < NROW; ++i) {
    if (rows[i].target == 0.0) continue;
    ratio = ratio_at(&b.cell[i], 0.5);
    printf("%s%s, %d parameters %.2f: at most %g %s", before, rows[i].way->name,
           rows[i].n == ALL ? b.np : rows[i].n, ratio, rows[i].target,
           ratio <= rows[i].target ? "met" : "missed");
    before = "; ";
  }
  printf("\n\n");
}

static int run_study(const options *o)
{
  double plain;
  int i;

  if (open_study()) return 1;
  printf("%s%s: %d coordinates, %d degrees of freedom, %d parameters, %s\n\n",
         o->markdown ? "## " : "", b.c.name, b.c.coordinates, b.c.dof, b.np, b.name);
  for (i = 0; i < NROW; ++i) pace(&rows[i], &b.cell[i]);
  if (check()) return 1;
  plain = measure(o->rounds);
  print_results(o);
  print_tapes(o);
  printf("one simulation: %.3f ms, %d steps of %g s\n", plain, b.steps, step);
  print_targets();
  if (o->csv) write_results(o->csv, plain);
  return 0;
}

static int run(const void *of, const char *model)
{
  const options *o = of;
  int wrong;

  if (!case_open(&b.c, model)) return 1;
  b.steps = o->steps;
  wrong = run_study(o);
  close_study();
  case_close(&b.c);
  return wrong;
}

/* ------------------------------------------------------------------------------- main */

static int usage(void)
{
  fprintf(stderr, "usage: bench-sensitivity [MODEL ..] [--rounds N] [--steps N] [--markdown] "
                  "[--csv FILE]\n");
  return 2;
}

int main(int argc, char **argv)
{
  options o = {0, ROUNDS, STEPS, NULL};
  const char *chosen[NMODEL];
  int i, n = 0, wrong = 0;

  for (i = 1; i < argc; ++i) {
    if (strcmp(argv[i], "--markdown") == 0) {
      o.markdown = 1;
    } else if (strcmp(argv[i], "--rounds") == 0 && i + 1 < argc) {
      o.rounds = atoi(argv[++i]);
      if (o.rounds < 1 || o.rounds > ROUNDS_MOST) return usage();
    } else if (strcmp(argv[i], "--steps") == 0 && i + 1 < argc) {
      o.steps = atoi(argv[++i]);
      if (o.steps < STEPS_LEAST || o.steps > STEPS_MOST) return usage();
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
    fprintf(o.csv, "suite,case,bodies,method,parameters,ratio,ratio_low,ratio_high,ms,plain_ms,"
                   "target,differs\n");
  print_machine(&o);
  for (i = 0; i < n; ++i) wrong = run_apart(run, &o, chosen[i]) || wrong;
  return wrong || (o.csv && fclose(o.csv) != 0);
}
