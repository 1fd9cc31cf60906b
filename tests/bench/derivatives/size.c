/* Cost of a step of the penalty formulation against the number of bodies: 15 rows of more and more four-bars. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cases.h"
#include "simulation.h"
#include "suites.h"
#include "table.h"
#include "timing.h"

static const int ny[] = {1, 2, 4, 7, 10, 20, 40, 60};
enum { NSIZE = sizeof ny / sizeof ny[0], LATE = 3, STEPS = 25 };
static const double h = 1e-2;
static const double sample_seconds = 1e-3;

/* what a step is made of */
enum { PART_JACOBIAN, PART_MATRIX, PART_FACTOR, PART_SOLVE, PART_FORCE, PART_END, NPART };

typedef struct size {
  bench_case c;
  int bodies;
  simulation x;
  course course;
  series step;        /* seconds */
  double part[NPART]; /* seconds a step */
} size;

static size sizes[NSIZE];

/* ------------------------------------------------------------------------------------ parts */

static void compute_jacobian(maggi_penalty *s)
{
  maggi_force_jacobian_compute(s->jacobian, s->d->time);
}

static void project_matrix(maggi_penalty *s)
{
  maggi_tangent_matrix_project(s->matrix, h, s->options.penalty);
}

static void newton_matrix(maggi_penalty *s)
{
  maggi_tangent_matrix_newton(s->matrix, h, s->jacobian->value);
}

static void factor(maggi_penalty *s)
{
  maggi_factor_compute(s->newton, s->matrix->newton);
}

static void solve(maggi_penalty *s)
{
  memset(s->x, 0, (size_t)s->n * sizeof(double));
  maggi_factor_solve(s->newton, 1, s->x);
}

static void forces(maggi_penalty *s)
{
  maggi_chain_evaluate(s->d, s->d->time, s->options.penalty);
}

static void end(maggi_penalty *s)
{
  maggi_evaluate_given(s->d, s->d->time);
}

static double seconds_of(void (*part)(maggi_penalty *), maggi_penalty *s)
{
  double begin, passed;
  int i, n = 1;

  part(s);
  for (;; n *= 2) {
    begin = cpu_seconds();
    for (i = 0; i < n; ++i) part(s);
    passed = cpu_seconds() - begin;
    if (passed >= sample_seconds) return passed / n;
  }
}

/* at the state at the end of a run: what each call takes, times the calls of a step */
static void take_apart(size *z)
{
  maggi_penalty *s = z->x.s;
  double steps = z->course.steps, iterations = (double)z->course.iterations / steps;
  double jacobians = (double)z->course.jacobians / steps, *part = z->part;

  part[PART_JACOBIAN] = jacobians * seconds_of(compute_jacobian, s);
  part[PART_MATRIX] = (iterations + 1.0) * seconds_of(project_matrix, s) +
                      iterations * seconds_of(newton_matrix, s);
  part[PART_FACTOR] = (iterations + 1.0) * seconds_of(factor, s);
  part[PART_SOLVE] = (iterations + 2.0) * seconds_of(solve, s);
  part[PART_FORCE] = (iterations - jacobians + 4.0) * seconds_of(forces, s);
  part[PART_END] = seconds_of(end, s);
}

/* ----------------------------------------------------------------------------------- output */

static void print_sizes(const options *o)
{
  static table t;
  const size *z;
  double bodies[NSIZE], step[NSIZE];
  int i, k;

  table_begin(&t, "four-bars|bodies|n|us a step|a body|Jacobian|matrices|factors|solves|forces|"
                  "end|iterations a step|nonzeros");
  for (i = 0; i < NSIZE; ++i) {
    z = &sizes[i];
    bodies[i] = z->bodies;
    step[i] = series_value(&z->step, 0.5);
    table_row(&t);
    table_cell(&t, "%dx15", ny[i]);
    table_cell(&t, "%d", z->bodies);
    table_cell(&t, "%d", simulation_coordinates(&z->x));
    table_cell(&t, "%.1f", 1e6 * step[i]);
    table_cell(&t, "%.3f", 1e6 * step[i] / bodies[i]);
    for (k = 0; k < NPART; ++k) table_cell(&t, "%.1f", 1e6 * z->part[k]);
    table_cell(&t, "%.2f", (double)z->course.iterations / z->course.steps);
    table_cell(&t, "%d", z->x.s->state.nonzeros);
  }
  printf("%scost of a step of %g ms against the number of bodies\n\n", o->markdown ? "## " : "",
         1e3 * h);
  table_print(&t, o->markdown);
  printf("exponent over bodies %.2f, from %dx15 on %.2f\n\n", log_slope(NSIZE, bodies, step),
         ny[LATE], log_slope(NSIZE - LATE, bodies + LATE, step + LATE));
}

static void write_sizes(FILE *csv)
{
  const size *z;
  int i, k;

  for (i = 0; i < NSIZE; ++i) {
    z = &sizes[i];
    fprintf(csv, "size,%s,%d,%d,%d,%g,%s,%d,,,,,%d,%ld,%ld,,,%.9g,,,,,,,,,%.9g", z->c.name,
            z->bodies, simulation_coordinates(&z->x), z->x.s->state.nonzeros, h, z->x.of->name,
            simulation_directions(&z->x), z->course.steps, z->course.jacobians,
            z->course.iterations, 1e6 * z->part[PART_JACOBIAN], 1e6 * series_value(&z->step, 0.5));
    for (k = PART_MATRIX; k < NPART; ++k) fprintf(csv, ",%.9g", 1e6 * z->part[k]);
    fprintf(csv, ",,\n");
  }
}

/* ------------------------------------------------------------------------------------- size */

static int open_size(size *z, int n)
{
  maggi_model_info info;
  char name[CASE_NAME];

  snprintf(name, sizeof name, "multiple-four-bar:%dx15", n);
  if (!case_open(&z->c, name)) return 0;
  maggi_model_get_info(z->c.m, &info);
  z->bodies = info.bodies;
  return simulation_open(&z->x, &ways[reference], z->c.m, NULL);
}

static int measure(int rounds)
{
  size *z;
  int i, round;

  for (round = 0; round < rounds; ++round) {
    for (i = 0; i < NSIZE; ++i) {
      z = &sizes[i];
      if (!simulation_run(&z->x, h, STEPS, &z->course)) return 0;
      series_add(&z->step, z->course.seconds / STEPS, 1.0);
    }
  }
  for (i = 0; i < NSIZE; ++i) {
    series_end(&sizes[i].step);
    take_apart(&sizes[i]);
  }
  return 1;
}

int run_size(const options *o)
{
  int i, ok = 1;

  for (i = 0; i < NSIZE && ok; ++i) ok = open_size(&sizes[i], ny[i]);
  ok = ok && measure(o->rounds);
  if (ok) print_sizes(o);
  if (ok && o->csv) write_sizes(o->csv);
  for (i = 0; i < NSIZE; ++i) {
    if (sizes[i].x.d) simulation_close(&sizes[i].x);
    case_close(&sizes[i].c);
  }
  return !ok;
}
