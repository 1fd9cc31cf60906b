/* Tables of a model, and its lines of the CSV files. */
#include "model.h"

#include <math.h>
#include <string.h>

size_t model_entries(const bench *b)
{
  const maggi_pattern *pattern = b->cell[reference].x.s->jacobian->pattern;

  return (size_t)pattern->J.coladr[pattern->J.ncol];
}

/* of the whole simulation over that of the steps that were taken */
static double scale(const bench *b, const cell *c)
{
  return (double)b->cell[reference].course.jacobians / (double)c->course.jacobians;
}

void print_jacobians(const bench *b, const options *o)
{
  static table t;
  const cell *c;
  int i;

  table_begin(&t, "Jacobian by|directions|us|ratio|+- %|samples|states|differs|at most");
  for (i = 0; i < b->n; ++i) {
    c = &b->cell[i];
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

void begin_simulations(table *t)
{
  table_begin(t, "simulation with|step ms|s|thesis|ratio|+- %|us a Jacobian|Jacobians|thesis|"
                 "iterations|drift %|thesis|apart|steps|samples");
}

void print_simulations(const bench *b, table *t, double h)
{
  const thesis_run *thesis = thesis_find_run(b->thesis, h);
  const course *whole = &b->cell[reference].course;
  const cell *c;
  int i, column;

  for (i = 0; i < b->n; ++i) {
    c = &b->cell[i];
    column = c->x.of->column;
    table_row(t);
    table_cell(t, "%s", c->x.of->name);
    table_cell(t, "%g", 1e3 * h);
    table_cell(t, "%.4g", scale(b, c) * series_value(&c->run, 0.5));
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

static void write_quartiles(FILE *csv, const series *s, double unit)
{
  fprintf(csv, ",%.9g,%.9g,%.9g", unit * series_value(s, 0.5), unit * series_value(s, 0.25),
          unit * series_value(s, 0.75));
}

static void write_or_not(FILE *csv, int is_there, double x)
{
  if (is_there && !isnan(x))
    fprintf(csv, ",%.9g", x);
  else
    fprintf(csv, ",");
}

void write_simulations(const bench *b, FILE *csv, double h)
{
  const thesis_run *thesis = thesis_find_run(b->thesis, h);
  const course *whole = &b->cell[reference].course;
  const cell *c;
  int i, k, column;

  for (i = 0; i < b->n; ++i) {
    c = &b->cell[i];
    column = c->x.of->column;
    fprintf(csv, "derivatives,%s,%d,%d,%d,%g,%s,%d", b->c.name, b->bodies,
            simulation_coordinates(&c->x), (int)model_entries(b), h, c->x.of->name,
            simulation_directions(&c->x));
    write_quartiles(csv, &c->run, scale(b, c));
    fprintf(csv, ",%.9g,%d,%ld,%ld", series_ratio(&c->run, 0.5), c->course.steps,
            c->course.jacobians, c->course.iterations);
    write_or_not(csv, c->course.steps == whole->steps, 100.0 * c->course.drift);
    fprintf(csv, ",%.2g", c->apart);
    write_quartiles(csv, &c->jacobian, 1e6);
    fprintf(csv, ",%.9g,%.2g", series_ratio(&c->jacobian, 0.5), c->differs);
    for (k = 0; k < THESIS_PLATFORMS; ++k)
      write_or_not(csv, thesis && column >= 0,
                   thesis && column >= 0 ? thesis->seconds[k][column] : 0.0);
    write_or_not(csv, thesis != NULL, thesis ? thesis->jacobians : 0.0);
    write_or_not(csv, thesis != NULL, thesis ? thesis->drift : 0.0);
    fprintf(csv, ",,,,,,,,\n");
  }
}

void write_pattern(const bench *b, FILE *file)
{
  const maggi_force_jacobian *j = b->cell[reference].x.s->jacobian;
  const maggi_sparsity *J = &j->pattern->J;
  int c, k;

  for (c = 0; c < J->ncol; ++c)
    for (k = J->coladr[c]; k < J->coladr[c + 1]; ++k)
      fprintf(file, "%s,%d,%d,%d,%d\n", b->c.name, j->pattern->n, J->row[k], c,
              j->colouring->colour[c]);
}

void print_head(const bench *b, const options *o)
{
  const cell *r = &b->cell[reference];
  int n = simulation_coordinates(&r->x);

  printf("%s%s: %d bodies, %d degrees of freedom; J %d x %d, %d nonzeros, %d colours",
         o->markdown ? "## " : "", b->c.name, b->bodies, b->c.dof, n, 2 * n, (int)model_entries(b),
         simulation_directions(&r->x));
  if (b->thesis)
    printf(" (thesis: %d x %d, %d, %d)", b->thesis->dependents, b->thesis->independents,
           b->thesis->nonzeros, b->thesis->colours);
  if (b->recorded) printf("; tape of %ld operations", tape_operations(b->recorded));
  printf("\n\n");
}

/* of issue 5, for the largest array of the thesis */
static void print_target(const char *what, double ratio, double target)
{
  printf("%s / tangent-coloured %.1f: at least %g %s\n", what, ratio, target,
         ratio >= target ? "met" : "missed");
}

int has_targets(const bench *b)
{
  return strcmp(b->c.name, "multiple-four-bar:7x15") == 0;
}

void print_jacobian_targets(const bench *b)
{
  print_target("a Jacobian, difference", series_ratio(&b->cell[0].jacobian, 0.5), 15.0);
  if (b->n > nlibrary)
    print_target("a Jacobian, adolc-sparse", series_ratio(&b->cell[b->n - 1].jacobian, 0.5), 10.0);
  printf("\n");
}

void print_simulation_target(double h, double ratio)
{
  printf("steps of %g ms: ", 1e3 * h);
  print_target("simulation, difference", ratio, 8.0);
}
