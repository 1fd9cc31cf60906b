/* bench-coach [evaluation] [lane-change] [turn] [--quick] [--markdown]      all three, if none is named
 *
 * The coach against the thesis: an evaluation by stage with its flops; the double lane change and the turn
 * as factors of real time, with sensitivities by the 35 parameters of Table 5.5 and the gradient by all
 * of p; ADOL-C on the same kernel as in Tables 5.2 and 5.7.  --quick: two seconds of the lane change.
 *
 * Times are CPU time of this thread, the least of a few runs; a number of simulations is the ratio to the
 * plain simulation (maggi_data_reset and maggi_step) measured just before.  Ways that are slow and take
 * the same time every step are timed over fewer steps, and their time is scaled; gradients of so many
 * steps are compared with direct differentiation.  The thesis integrates without closing loops again. */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "apart.h"
#include "cases.h"
#include "data.h"
#include "profile.h"
#include "table.h"
#include "timing.h"
#include "ways.h"

static const double evaluation_target = 10.0; /* us, issue 6 */
static const double paced_seconds = 2.0;
static const double long_seconds = 20.0; /* a way that takes longer runs once */
enum { ROUNDS = 5, SAMPLES = 21, RUNS = 3, STEPS_LEAST = 8, MOVING_STEPS = 1000 };

/* Table 5.5; models/coach/relevance.yaml */
static const char *const design[PARAMETERS] = {
    "left_triangle_z",
    "bodywork_mass",
    "bodywork_inertia_xx",
    "bodywork_inertia_yy",
    "bodywork_inertia_zz",
    "support_mass",
    "support_inertia_xx",
    "support_inertia_yy",
    "support_inertia_zz",
    "bodywork_cog_x",
    "bodywork_cog_y",
    "bodywork_cog_z",
    "rod_1_mass",
    "rod_2_mass",
    "left_triangle_x",
    "left_triangle_y",
    "right_triangle_x",
    "right_triangle_y",
    "right_triangle_z",
    "rear_left_wheel_y",
    "rear_right_wheel_y",
    "front_left_wheel_y",
    "front_right_wheel_y",
    "rear_left_wheels_inertia_xx",
    "rear_left_wheels_inertia_yy",
    "rear_left_wheels_inertia_zz",
    "rear_right_wheels_inertia_xx",
    "rear_right_wheels_inertia_yy",
    "rear_right_wheels_inertia_zz",
    "front_left_axis_x",
    "front_left_axis_y",
    "front_left_axis_z",
    "front_right_axis_x",
    "front_right_axis_y",
    "front_right_axis_z",
};

/* thesis: seconds for the sensitivities of 2 s, with ADOL-C (Table 5.7) */
static const struct row {
  const way *way;
  int n, turn_only;
  const char *target, *thesis;
} rows[] = {
    {&way_direct, 1, 0, "", ""},
    {&way_direct, 18, 0, "", ""},
    {&way_direct, PARAMETERS, 0, "real time >= 1", "0.025 of real time"},
    {&way_adjoint, ALL, 0, "simulations <= 5", ""},
    {&way_continuous, ALL, 0, "", ""},
    {&way_differences, PARAMETERS, 0, "", ""},
    {&way_jacobian, PARAMETERS, 1, "", ""},
#ifdef BENCH_ADOLC
    {&way_adolc, PARAMETERS, 1, "", "48.8 s"},
    {&way_adolc_unsolved, PARAMETERS, 1, "", "81.7 s"},
    {&way_adolc_jacobian, PARAMETERS, 1, "", ""},
#endif
};
enum { NROW = sizeof rows / sizeof rows[0] };

typedef struct options {
  int markdown, quick;
} options;

static bench_case c;
static study of;

static int fail(const char *what, const char *why)
{
  complain(what, why);
  return 1;
}

static int open_case(const char *model)
{
  char path[1024];

  snprintf(path, sizeof path, "%s/%s.yaml", strchr(model, '/') ? MAGGI_MODELS_DIR : BENCH_COACH_DIR,
           model);
  if (!case_open(&c, path)) return 0;
  snprintf(c.name, sizeof c.name, "%s", model);
  return 1;
}

/* --------------------------------------------------------------------------- evaluation */

/* the mechanism and gravity alone, as other programs have it: nothing that exerts forces */
static void strip(maggi_data *d)
{
  maggi_topo *t = &d->t;

  t->nwheel = t->nspring = t->njspring = t->nforce = t->nspeed = t->ndriver = 0;
}

static int evaluation(const options *o, const char *model, int stripped)
{
  bench_flops flops;
  int i;

  if (!open_case(model)) return 1;
  for (i = 0; i < MOVING_STEPS; ++i)
    if (maggi_step(c.d, 1e-3) != MAGGI_OK) return fail(model, maggi_data_message(c.d));
  c.time = maggi_get_time(c.d);
  if (stripped) {
    strip(c.d);
    snprintf(c.name, sizeof c.name, "%s, gravity only", model);
  }
  cases_measure(1, &c, ROUNDS, SAMPLES);
  case_count(&c, &flops);
  printf("%s: %.2f us an evaluation (quartiles %.2f, %.2f), %ld flops, %ld executed", c.name, c.us,
         c.low, c.high, c.flops, c.executed);
  if (stripped)
    printf("; MuJoCo 4.0 19.5-23 us\n\n");
  else
    printf("; at most %g %s; thesis 85.6 us, Adams 830-3250 us\n\n", evaluation_target,
           c.us <= evaluation_target ? "met" : "missed");
  profile(o->markdown, &c);
  case_close(&c);
  return 0;
}

static int turn(const void *o, const char *model)
{
  return evaluation(o, model, 0);
}

static int gravity(const void *o, const char *model)
{
  return evaluation(o, model, 1);
}

/* --------------------------------------------------------------------------- manoeuvres */

static double least(double a, double b)
{
  return a < b ? a : b;
}

static double plain_seconds(int steps)
{
  double begin = cpu_seconds();
  int k;

  maggi_data_reset(of.d);
  for (k = 0; k < steps; ++k) maggi_step(of.d, of.step);
  return cpu_seconds() - begin;
}

/* seconds for all steps, the least of RUNS; INFINITY on failure */
static double way_seconds(const struct row *row, void *self, int steps, double *gradient,
                          int *taken)
{
  double begin, seconds, best = INFINITY, one;
  int i, n = steps;

  if (row->way->is_paced) {
    begin = cpu_seconds();
    if (!row->way->gradient(self, 1, gradient)) return INFINITY;
    one = cpu_seconds() - begin;
    n = (int)least(steps, paced_seconds / one);
    if (n < STEPS_LEAST) n = STEPS_LEAST;
  }
  *taken = n;
  for (i = 0; i < RUNS; ++i) {
    begin = cpu_seconds();
    if (!row->way->gradient(self, n, gradient)) return INFINITY;
    seconds = (cpu_seconds() - begin) * steps / n;
    best = least(best, seconds);
    if (seconds > long_seconds && !row->way->is_paced) break;
  }
  return best;
}

/* largest difference from direct differentiation, relative to the largest entry */
static double difference(int n, int steps, const double *gradient)
{
  double right[PARAMETERS], largest = 0.0, most = 0.0;
  void *self = way_direct.open(&of, n);
  int i, ok;

  if (!self) return INFINITY;
  ok = way_direct.gradient(self, steps, right);
  way_direct.close(self);
  for (i = 0; i < n && ok; ++i) {
    largest = fmax(largest, fabs(right[i]));
    most = fmax(most, fabs(gradient[i] - right[i]));
  }
  return ok ? most / largest : INFINITY;
}

/* of the tapes as in Table 5.2 */
static void print_tapes(int markdown, int n, const tape_size size[], const double seconds[],
                        const char *const name[])
{
  static table t;
  int i;

  table_begin(&t, "tape, 35 parameters|independents|dependents|operations|locations|values|s");
  for (i = 0; i < n; ++i) {
    table_row(&t);
    table_cell(&t, "%s", name[i]);
    table_cell(&t, "%ld", size[i].independents);
    table_cell(&t, "%ld", size[i].dependents);
    table_cell(&t, "%ld", size[i].operations);
    table_cell(&t, "%ld", size[i].locations);
    table_cell(&t, "%ld", size[i].values);
    table_cell(&t, "%.1f", seconds[i]);
  }
  table_row(&t);
  table_cell(&t, "thesis 1, 3, 4: 83.1, 195.5, 189.5 s");
  table_cell(&t, "88");
  table_cell(&t, "52");
  table_cell(&t, "143078");
  table_cell(&t, "370803");
  table_cell(&t, "35631");
  table_cell(&t, "83.1");
  table_row(&t);
  table_cell(&t, "thesis 2, without solve");
  table_cell(&t, "88");
  table_cell(&t, "377");
  table_cell(&t, "146311");
  table_cell(&t, "381042");
  table_cell(&t, "35630");
  table_cell(&t, "85.6");
  table_print(&t, markdown);
}

static int compare(const options *o, int steps, const char *model)
{
  static table t;
  tape_size size[NROW];
  double tape_seconds[NROW], plain, seconds, time = steps * of.step;
  const char *tape_name[NROW];
  double *gradient = calloc((size_t)c.d->t.np + PARAMETERS, sizeof(double));
  void *self;
  int i, k, taken = steps, ntape = 0, is_turn = strstr(model, "turn") != NULL, wrong = !gradient;

  table_begin(&t, "way|parameters|s|simulations|real time|differs|target|thesis");
  plain = INFINITY;
  for (k = 0; k < RUNS; ++k) plain = least(plain, plain_seconds(steps));
  table_row(&t);
  table_cell(&t, "simulation");
  table_cell(&t, "-");
  table_cell(&t, "%.3f", plain);
  table_cell(&t, "1");
  table_cell(&t, "%.1f", time / plain);
  table_cell(&t, "-");
  table_cell(&t, "real time >= 15");
  table_cell(&t, "2.9 (0.694 s for 2 s)");
  for (i = 0; i < NROW && !wrong; ++i) {
    if (rows[i].turn_only && !is_turn) continue;
    self = rows[i].way->open(&of, rows[i].n);
    if (!self) return fail(rows[i].way->name, "cannot be opened");
    seconds = way_seconds(&rows[i], self, steps, gradient, &taken);
    for (k = 0; k < RUNS; ++k) plain = least(plain, plain_seconds(steps));
    if (rows[i].way->size) {
      rows[i].way->size(self, &size[ntape]);
      tape_name[ntape] = rows[i].way->name;
      tape_seconds[ntape++] = seconds;
    }
    rows[i].way->close(self);
    wrong = !isfinite(seconds);
    table_row(&t);
    table_cell(&t, "%s", rows[i].way->name);
    table_cell(&t, "%d", rows[i].n == ALL ? c.d->t.np : rows[i].n);
    table_cell(&t, "%.3f", seconds);
    table_cell(&t, "%.2f", seconds / plain);
    table_cell(&t, "%.3f", time / seconds);
    if (rows[i].n == ALL || rows[i].way == &way_direct)
      table_cell(&t, "-");
    else
      table_cell(&t, "%.0e", difference(rows[i].n, taken, gradient));
    table_cell(&t, "%s", rows[i].target);
    table_cell(&t, "%s", rows[i].thesis);
  }
  printf("%s%s: %g s at %g ms, %d parameters\n\n", o->markdown ? "## " : "", model, time,
         1e3 * of.step, c.d->t.np);
  table_print(&t, o->markdown);
  if (ntape > 0) print_tapes(o->markdown, ntape, size, tape_seconds, tape_name);
#ifndef BENCH_ADOLC
  if (is_turn) printf("ADOL-C is not here: apt-get install libadolc-dev, and configure again\n\n");
#endif
  free(gradient);
  return wrong;
}

static int manoeuvre(const void *options_of, const char *model)
{
  const options *o = options_of;
  maggi_model_info info;
  char message[256];
  static char name[256];
  int wrong;

  if (!open_case(model)) return 1;
  maggi_model_get_info(c.m, &info);
  snprintf(name, sizeof name, "integral_square(%s.q)", maggi_coordinate_name(c.m, 0));
  of = (study){.m = c.m, .d = c.d, .name = name, .step = 1e-3, .design = design};
  of.first = c.m->coordinate[0].q;
  if (maggi_objective_named(c.m, name, &of.objective, message, sizeof message) != MAGGI_OK)
    return fail(model, message);
  wrong = compare(o, (int)((o->quick ? 2.0 : info.simulation.time) / of.step + 0.5), model);
  maggi_objective_free(of.objective);
  case_close(&c);
  return wrong;
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

int main(int argc, char **argv)
{
  options o = {0, 0};
  int i, part[3] = {0, 0, 0}, wrong = 0;

  for (i = 1; i < argc; ++i) {
    if (strcmp(argv[i], "--markdown") == 0) {
      o.markdown = 1;
    } else if (strcmp(argv[i], "--quick") == 0) {
      o.quick = 1;
    } else if (strcmp(argv[i], "evaluation") == 0) {
      part[0] = 1;
    } else if (strcmp(argv[i], "lane-change") == 0) {
      part[1] = 1;
    } else if (strcmp(argv[i], "turn") == 0) {
      part[2] = 1;
    } else {
      fprintf(stderr,
              "usage: bench-coach [evaluation] [lane-change] [turn] [--quick] [--markdown]\n");
      return 2;
    }
  }
  print_machine(&o);
  if (!part[0] && !part[1] && !part[2]) part[0] = part[1] = part[2] = 1;
  if (part[0]) {
    wrong = run_apart(turn, &o, "coach/turn");
    wrong = run_apart(turn, &o, "coach/double-lane-change") || wrong;
    wrong = run_apart(gravity, &o, "coach/turn") || wrong;
  }
  if (part[1]) wrong = run_apart(manoeuvre, &o, "lane-change") || wrong;
  if (part[2]) wrong = run_apart(manoeuvre, &o, "coach/turn") || wrong;
  return wrong;
}
