/* One model in all ways: Jacobians at states of a simulation, then simulations.
 *
 * Ways follow one another in each round, each with tangents by colours beside it: a ratio is the median of those of
 * the rounds, +- the quarter of them on either side.  A way that is slow takes fewer steps; its time is that of
 * these times the Jacobians of the whole simulation over theirs. */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cases.h"
#include "simulation.h"
#include "suites.h"
#include "table.h"
#include "timing.h"

enum { WAYS_MOST = 8, STATES = 8, STEPS_LEAST = 2 };
static const double state_step = 1e-2; /* of the simulation whose states these are */
static const double steps_of[] = {1e-3, 1e-2, 2e-2};
enum { NSTEP = sizeof steps_of / sizeof steps_of[0] };
static const double check_seconds = 4.0;   /* no more states after so many */
static const double sample_seconds = 1e-3; /* at least */
static const double run_seconds = 4.0;     /* a shortened simulation */
static const double row_seconds = 12.0;    /* all rounds of a row, if they leave enough of them */

typedef struct cell {
  simulation x;
  int batch, states; /* Jacobians a sample, states that were compared */
  double differs;
  series jacobian; /* seconds */
  course course;
  double apart; /* from tangents by colours at the end */
  series run;   /* seconds */
} cell;

typedef struct bench {
  bench_case c;
  const thesis_case *thesis;
  int n, bodies; /* ways that can be had */
  tape *recorded;
  double *states, *value;
  cell cell[WAYS_MOST];
} bench;

static bench b;

static size_t entries(void)
{
  const maggi_pattern *pattern = b.cell[reference].x.s->jacobian->pattern;

  return (size_t)pattern->J.coladr[pattern->J.ncol];
}

/* -------------------------------------------------------------------------------- Jacobians */

static const double *state(int k)
{
  return b.states + (size_t)k * simulation_state_size(&b.cell[reference].x);
}

/* largest difference from the reference relative to the largest entry, of derivatives by z and by z' apart */
static double difference(const double *value)
{
  double largest, most, worst = 0.0;
  size_t half = entries() / 2, i, k;

  for (k = 0; k < 2; ++k) {
    largest = most = 0.0;
    for (i = k * half; i < (k + 1) * half; ++i) {
      if (!isfinite(value[i]) || !isfinite(b.value[i])) return INFINITY;
      largest = fmax(largest, fabs(b.value[i]));
      most = fmax(most, fabs(value[i] - b.value[i]));
    }
    if (largest > 0.0) worst = fmax(worst, most / largest);
  }
  return worst;
}

static int check(void)
{
  double begin;
  int i, k, wrong = 0;
  cell *c;

  for (i = 0; i < b.n; ++i) {
    c = &b.cell[i];
    c->differs = 0.0;
    begin = cpu_seconds();
    for (k = 0; k < STATES && (k == 0 || cpu_seconds() - begin < check_seconds); ++k) {
      memcpy(b.value, simulation_jacobian(&b.cell[reference].x, state(k)),
             entries() * sizeof(double));
      c->differs = fmax(c->differs, difference(simulation_jacobian(&c->x, state(k))));
    }
    c->states = k;
    if (c->differs <= c->x.of->tolerance) continue;
    fprintf(stderr, "bench-derivatives: %s: %s differs by %.0e\n", b.c.name, c->x.of->name,
            c->differs);
    wrong = 1;
  }
  return wrong;
}

static double jacobian_seconds(cell *c, int n)
{
  double begin = cpu_seconds();
  int i;

  for (i = 0; i < n; ++i) simulation_jacobian(&c->x, state(i % STATES));
  return cpu_seconds() - begin;
}

static void time_jacobians(int rounds)
{
  cell *c, *r = &b.cell[reference];
  double passed, one;
  int i, round;

  for (i = 0; i < b.n; ++i) {
    c = &b.cell[i];
    c->batch = 1;
    while ((passed = jacobian_seconds(c, c->batch)) < sample_seconds) c->batch *= 2;
    series_begin(&c->jacobian, rounds, passed, row_seconds);
  }
  for (round = 0; round < rounds; ++round) {
    for (i = 0; i < b.n; ++i) {
      c = &b.cell[i];
      if (round % c->jacobian.every != 0) continue;
      passed = jacobian_seconds(r, r->batch) / r->batch;
      one = jacobian_seconds(c, c->batch) / c->batch;
      series_add(&c->jacobian, one, one / passed);
    }
  }
  for (i = 0; i < b.n; ++i) series_end(&b.cell[i].jacobian);
}

/* ------------------------------------------------------------------------------ simulations */

/* steps that a way takes: all, or what it does in its time, from the times of its Jacobians */
static int pace(const cell *c, const course *whole)
{
  const cell *r = &b.cell[reference];
  double more = series_value(&c->jacobian, 0.5) - series_value(&r->jacobian, 0.5);
  double seconds = whole->seconds + fmax(more, 0.0) * (double)whole->jacobians;
  int steps = whole->steps;

  if (c != r && seconds > run_seconds) steps = (int)(steps * run_seconds / seconds);
  if (steps < STEPS_LEAST) steps = STEPS_LEAST;
  return steps < whole->steps ? steps : whole->steps;
}

/* counts, drift, and how far it is from the reference */
static int follow(cell *c, double h, const course *whole)
{
  cell *r = &b.cell[reference];
  course same;
  int i, steps = pace(c, whole);

  if (!simulation_follow(&c->x, h, steps, &c->course, 0, NULL)) return 0;
  c->apart = 0.0;
  if (c == r) return 1;
  if (!simulation_run(&r->x, h, steps, &same)) return 0;
  for (i = 0; i < c->x.d->t.nq; ++i) c->apart = fmax(c->apart, fabs(c->x.d->q[i] - r->x.d->q[i]));
  return 1;
}

static int time_simulations(double h, int rounds)
{
  cell *c, *r = &b.cell[reference];
  course run, beside;
  int i, round;

  for (i = 0; i < b.n; ++i)
    series_begin(&b.cell[i].run, rounds, b.cell[i].course.seconds, row_seconds);
  for (round = 0; round < rounds; ++round) {
    for (i = 0; i < b.n; ++i) {
      c = &b.cell[i];
      if (round % c->run.every != 0) continue;
      if (!simulation_run(&c->x, h, c->course.steps, &run)) return 0;
      beside = run;
      if (c != r && !simulation_run(&r->x, h, c->course.steps, &beside)) return 0;
      series_add(&c->run, run.seconds, run.seconds / beside.seconds);
    }
  }
  for (i = 0; i < b.n; ++i) series_end(&b.cell[i].run);
  return 1;
}

static int simulate(double h, const options *o)
{
  course whole;
  int i;

  if (!simulation_follow(&b.cell[reference].x, h, (int)(o->time / h + 0.5), &whole, 0, NULL))
    return 0;
  for (i = 0; i < b.n; ++i)
    if (!follow(&b.cell[i], h, &whole)) return 0;
  return time_simulations(h, o->rounds);
}

/* of the whole simulation over that of the steps that were taken */
static double scale(const cell *c)
{
  return (double)b.cell[reference].course.jacobians / (double)c->course.jacobians;
}

/* ----------------------------------------------------------------------------------- output */

static void print_jacobians(const options *o)
{
  static table t;
  const cell *c;
  int i;

  table_begin(&t, "Jacobian by|directions|us|ratio|+- %|samples|states|differs|at most");
  for (i = 0; i < b.n; ++i) {
    c = &b.cell[i];
    table_row(&t);
    table_cell(&t, "%s", c->x.of->name);
    table_cell(&t, "%d", simulation_directions(&c->x));
    table_cell(&t, "%.4g", 1e6 * series_value(&c->jacobian, 0.5));
    table_cell(&t, "%.2f", series_ratio(&c->jacobian, 0.5));
    table_cell(&t, "%.0f", series_spread(&c->jacobian));
    table_cell(&t, "%d", c->jacobian.n);
    table_cell(&t, "%d", c->states);
    table_cell(&t, "%.0e", c->differs);
    table_cell(&t, "%.0e", c->x.of->tolerance);
  }
  table_print(&t, o->markdown);
}

static void cell_or_dash(table *t, int is_there, const char *format, double x)
{
  if (is_there && !isnan(x))
    table_cell(t, format, x);
  else
    table_cell(t, "-");
}

static void print_simulations(table *t, double h)
{
  const thesis_run *thesis = thesis_find_run(b.thesis, h);
  const course *whole = &b.cell[reference].course;
  const cell *c;
  int i, column;

  for (i = 0; i < b.n; ++i) {
    c = &b.cell[i];
    column = c->x.of->column;
    table_row(t);
    table_cell(t, "%s", c->x.of->name);
    table_cell(t, "%g", 1e3 * h);
    table_cell(t, "%.4g", scale(c) * series_value(&c->run, 0.5));
    cell_or_dash(t, thesis && column >= 0, "%.2f",
                 thesis && column >= 0 ? thesis->seconds[THESIS_GCC_2][column] : 0.0);
    table_cell(t, "%.2f", series_ratio(&c->run, 0.5));
    table_cell(t, "%.0f", series_spread(&c->run));
    table_cell(t, "%.4g", 1e6 * series_value(&c->jacobian, 0.5));
    table_cell(t, "%ld", c->course.jacobians);
    cell_or_dash(t, thesis != NULL, "%.0f", thesis ? thesis->jacobians : 0.0);
    table_cell(t, "%ld", c->course.iterations);
    cell_or_dash(t, c->course.steps == whole->steps, "%+.4f", 100.0 * c->course.drift);
    cell_or_dash(t, thesis != NULL, "%+.3f", thesis ? thesis->drift : 0.0);
    table_cell(t, "%.0e", c->apart);
    table_cell(t, "%d of %d", c->course.steps, whole->steps);
    table_cell(t, "%d", c->run.n);
  }
}

static void write_simulations(FILE *csv, double h)
{
  const thesis_run *thesis = thesis_find_run(b.thesis, h);
  const cell *c;
  int i, k;

  for (i = 0; i < b.n; ++i) {
    c = &b.cell[i];
    fprintf(csv, "derivatives,%s,%d,%d,%d,%g,%s,%d", b.c.name, b.bodies,
            simulation_coordinates(&c->x), (int)entries(), h, c->x.of->name,
            simulation_directions(&c->x));
    for (k = 2; k <= 4; ++k)
      fprintf(csv, ",%.9g", scale(c) * series_value(&c->run, k == 2 ? 0.5 : k == 3 ? 0.25 : 0.75));
    fprintf(csv, ",%.9g,%d,%ld,%ld,%.9g,%.2g", series_ratio(&c->run, 0.5), c->course.steps,
            c->course.jacobians, c->course.iterations, 100.0 * c->course.drift, c->apart);
    for (k = 2; k <= 4; ++k)
      fprintf(csv, ",%.9g", 1e6 * series_value(&c->jacobian, k == 2 ? 0.5 : k == 3 ? 0.25 : 0.75));
    fprintf(csv, ",%.9g,%.2g", series_ratio(&c->jacobian, 0.5), c->differs);
    for (k = 0; k < THESIS_PLATFORMS; ++k)
      if (thesis && c->x.of->column >= 0)
        fprintf(csv, ",%g", thesis->seconds[k][c->x.of->column]);
      else
        fprintf(csv, ",");
    if (thesis)
      fprintf(csv, ",%d,%g", thesis->jacobians, thesis->drift);
    else
      fprintf(csv, ",,");
    fprintf(csv, ",,,,,,,,\n");
  }
}

/* places of J with their colours */
static void write_pattern(FILE *file)
{
  const maggi_force_jacobian *j = b.cell[reference].x.s->jacobian;
  const maggi_sparsity *J = &j->pattern->J;
  int c, k;

  for (c = 0; c < J->ncol; ++c)
    for (k = J->coladr[c]; k < J->coladr[c + 1]; ++k)
      fprintf(file, "%s,%d,%d,%d,%d\n", b.c.name, j->pattern->n, J->row[k], c,
              j->colouring->colour[c]);
}

static void print_head(const options *o)
{
  const cell *r = &b.cell[reference];
  int n = simulation_coordinates(&r->x);

  printf("%s%s: %d bodies, %d degrees of freedom; J %d x %d, %d nonzeros, %d colours",
         o->markdown ? "## " : "", b.c.name, b.bodies, b.c.dof, n, 2 * n, (int)entries(),
         simulation_directions(&r->x));
  if (b.thesis)
    printf(" (thesis: %d x %d, %d, %d)", b.thesis->dependents, b.thesis->independents,
           b.thesis->nonzeros, b.thesis->colours);
  if (b.recorded) printf("; tape of %ld operations", tape_operations(b.recorded));
  printf("\n\n");
}

/* of issue 5, for the largest array of the thesis */
static void print_target(const char *what, double ratio, double target)
{
  printf("%s / tangent-coloured %.1f: at least %g %s\n", what, ratio, target,
         ratio >= target ? "met" : "missed");
}

static int has_targets(void)
{
  return strcmp(b.c.name, "multiple-four-bar:7x15") == 0;
}

static void print_jacobian_targets(void)
{
  print_target("a Jacobian, difference", series_ratio(&b.cell[0].jacobian, 0.5), 15.0);
  if (b.n > nlibrary)
    print_target("a Jacobian, adolc-sparse", series_ratio(&b.cell[b.n - 1].jacobian, 0.5), 10.0);
  printf("\n");
}

/* ------------------------------------------------------------------------------------ model */

static int open_ways(void)
{
  maggi_model_info info;
  int i;

  maggi_model_get_info(b.c.m, &info);
  b.bodies = info.bodies;
  b.thesis = thesis_find(b.c.name);
  for (i = 0; i < nway; ++i) {
    if (i == nlibrary && !(b.recorded = simulation_record(&b.cell[0].x))) break;
    b.n = i + 1;
    if (!simulation_open(&b.cell[i].x, &ways[i], b.c.m, b.recorded)) return 0;
  }
  b.states = calloc(STATES * simulation_state_size(&b.cell[0].x), sizeof(double));
  b.value = calloc(entries() + 1, sizeof(double));
  return (b.states && b.value) || complain(b.c.name, "out of memory");
}

static void close_ways(void)
{
  int i;

  for (i = 0; i < b.n; ++i) simulation_close(&b.cell[i].x);
  tape_free(b.recorded);
  free(b.states);
  free(b.value);
}

static int measure(const options *o)
{
  static table t;
  course c;
  double ratio[NSTEP];
  int i;

  if (!open_ways()) return 0;
  print_head(o);
  i = (int)(o->time / state_step + 0.5);
  if (!simulation_follow(&b.cell[reference].x, state_step, i, &c, STATES, b.states)) return 0;
  if (check()) return 0;
  time_jacobians(o->rounds);
  print_jacobians(o);
  if (has_targets()) print_jacobian_targets();
  fflush(stdout);
  table_begin(&t, "simulation with|step ms|s|thesis|ratio|+- %|us a Jacobian|Jacobians|thesis|"
                  "iterations|drift %|thesis|apart|steps|samples");
  for (i = 0; i < NSTEP; ++i) {
    if (!simulate(steps_of[i], o)) return 0;
    print_simulations(&t, steps_of[i]);
    if (o->csv) write_simulations(o->csv, steps_of[i]);
    ratio[i] = series_ratio(&b.cell[0].run, 0.5);
  }
  table_print(&t, o->markdown);
  for (i = 0; i < NSTEP && has_targets(); ++i) {
    printf("steps of %g ms: ", 1e3 * steps_of[i]);
    print_target("simulation, difference", ratio[i], 8.0);
  }
  printf("\n");
  if (o->pattern) write_pattern(o->pattern);
  return 1;
}

int run_model(const options *o, const char *model)
{
  int ok;

  if (!case_open(&b.c, model)) return 1;
  ok = measure(o);
  close_ways();
  case_close(&b.c);
  return !ok;
}
