/* One model in all ways: Jacobians at states of a simulation, then simulations.
 *
 * Ways follow one another in each round, each with tangents by colours beside it: a ratio is the median of those of
 * the rounds, +- the quarter of them on either side.  A way that is slow takes fewer steps; its time is that of
 * these times the Jacobians of the whole simulation over theirs. */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model.h"
#include "timing.h"

enum { STATES = 8, STEPS_LEAST = 2 };
static const double state_step = 1e-2; /* of the simulation whose states these are */
static const double steps_of[] = {1e-3, 1e-2, 2e-2};
enum { NSTEP = sizeof steps_of / sizeof steps_of[0] };
static const double check_seconds = 4.0;   /* no more states after so many */
static const double sample_seconds = 1e-3; /* at least */
static const double run_seconds = 4.0;     /* a shortened simulation */
static const double row_seconds = 12.0;    /* all rounds of a row, if they leave enough of them */

static bench b;

/* -------------------------------------------------------------------------------- Jacobians */

static const double *state(int k)
{
  return b.states + (size_t)k * simulation_state_size(&b.cell[reference].x);
}

/* largest difference from the reference relative to the largest entry, of derivatives by z and by z' apart */
static double difference(const double *value)
{
  double largest, most, worst = 0.0;
  size_t half = model_entries(&b) / 2, i, k;

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
             model_entries(&b) * sizeof(double));
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
  b.value = calloc(model_entries(&b) + 1, sizeof(double));
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
  print_head(&b, o);
  i = (int)(o->time / state_step + 0.5);
  if (!simulation_follow(&b.cell[reference].x, state_step, i, &c, STATES, b.states)) return 0;
  if (check()) return 0;
  time_jacobians(o->rounds);
  print_jacobians(&b, o);
  if (has_targets(&b)) print_jacobian_targets(&b);
  fflush(stdout);
  begin_simulations(&t);
  for (i = 0; i < NSTEP; ++i) {
    if (!simulate(steps_of[i], o)) return 0;
    print_simulations(&b, &t, steps_of[i]);
    if (o->csv) write_simulations(&b, o->csv, steps_of[i]);
    ratio[i] = series_ratio(&b.cell[0].run, 0.5);
  }
  table_print(&t, o->markdown);
  for (i = 0; i < NSTEP && has_targets(&b); ++i) print_simulation_target(steps_of[i], ratio[i]);
  if (has_targets(&b)) printf("\n");
  if (o->pattern) write_pattern(&b, o->pattern);
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
