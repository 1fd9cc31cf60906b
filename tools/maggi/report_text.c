/* Results of a sensitivity analysis for eyes. */
#include <math.h>
#include <string.h>

#include "report.h"
#include "unit.h"

#define ROWS_MAX 35 /* of a table, unless all are wanted */

/* Widths of the columns of text. */
typedef struct widths {
  int name, unit, gradient_unit;
} widths;

static void widen(int *width, const char *text)
{
  int n = (int)strlen(text);

  if (n > *width) *width = n;
}

/* Rows that are shown. */
static int shown(const report *r)
{
  int n = r->study->parameters.number;

  return r->all_rows || n <= ROWS_MAX ? n : ROWS_MAX;
}

static void print_rest(const report *r, FILE *out)
{
  int rest = r->study->parameters.number - shown(r);

  if (rest > 0) fprintf(out, "      and %d more (--all-rows)\n", rest);
}

static void measure(const report *r, int objective, const int *order, widths *w)
{
  const maggi_design *design = r->study->parameters.design;
  char unit[UNIT_MAX];
  int i;

  w->name = (int)strlen("parameter");
  w->unit = w->gradient_unit = 1;
  for (i = 0; i < shown(r); ++i) {
    widen(&w->name, maggi_design_name(design, order[i]));
    widen(&w->unit, maggi_design_unit(design, order[i]));
    widen(&w->gradient_unit, objective < 0 ? report_relevance_unit(r, order[i], unit)
                                           : report_unit(r, objective, order[i], unit));
  }
}

/* J: value of the objective. */
static void print_row(const report *r, int objective, double J, int rank, int k, const widths *w,
                      FILE *out)
{
  const maggi_design *design = r->study->parameters.design;
  double b = maggi_design_value(design, k), x = report_normalised(r, objective, k);
  double gradient =
      r->gradients->gradient[(size_t)objective * (size_t)r->study->parameters.number + (size_t)k];
  char unit[UNIT_MAX];

  fprintf(out, "%4d  %-*s  %12.6g %-*s  %13.6g %-*s  ", rank + 1, w->name,
          maggi_design_name(design, k), b, w->unit, maggi_design_unit(design, k), gradient,
          w->gradient_unit, report_unit(r, objective, k, unit));
  if (b == 0.0)
    fprintf(out, "%11s\n", "-");
  else
    fprintf(out, "%11.5g\n", J == 0.0 ? b * gradient : x);
}

static void print_objective(const report *r, int objective, FILE *out)
{
  int n = r->study->parameters.number, i, zeros = 0;
  const int *order = r->order + (size_t)objective * (size_t)n;
  double J = r->gradients->value[objective];
  const char *unit = maggi_objective_unit(r->study->objectives.objective[objective]);
  widths w;

  measure(r, objective, order, &w);
  fprintf(out, "\nobjective     %s = %.10g %s\n", r->study->objective_names.name[objective], J,
          unit);
  fprintf(out, "      %-*s  %12s %-*s  %13s %-*s  %11s\n", w.name, "parameter", "b", w.unit, "",
          "dJ/db", w.gradient_unit, "", J == 0.0 ? "b dJ/db" : "b/J dJ/db");
  for (i = 0; i < shown(r); ++i) {
    print_row(r, objective, J, i, order[i], &w, out);
    zeros += maggi_design_value(r->study->parameters.design, order[i]) == 0.0;
  }
  print_rest(r, out);
  if (J == 0.0) fprintf(out, "      J is 0: b dJ/db instead of b/J dJ/db, in %s\n", unit);
  if (zeros > 0) fputs("      - : b is 0; these follow the others, by |dJ/db|\n", out);
}

static void print_relevance(const report *r, FILE *out)
{
  const maggi_design *design = r->study->parameters.design;
  char unit[UNIT_MAX];
  widths w;
  int i, k;

  measure(r, -1, r->relevant, &w);
  fputs("\nrelevance     largest |dq/db| of a coordinate over time\n", out);
  for (i = 0; i < shown(r); ++i) {
    k = r->relevant[i];
    fprintf(out, "%4d  %-*s  %12.6g %-*s  %s\n", i + 1, w.name, maggi_design_name(design, k),
            r->gradients->relevance[k], w.gradient_unit, report_relevance_unit(r, k, unit),
            maggi_coordinate_name(r->study->model, r->gradients->coordinate[k]));
  }
  print_rest(r, out);
}

static int is_difference(maggi_method method)
{
  return method == MAGGI_METHOD_DIFFERENCE || method == MAGGI_METHOD_FORWARD_DIFFERENCE ||
         method == MAGGI_METHOD_BACKWARD_DIFFERENCE;
}

static void print_cost(const report *r, FILE *out)
{
  const gradients *g = r->gradients;
  const maggi_gradient_options *o = &g->options;

  fprintf(out, "\nmethod        %s, %d parameters", maggi_method_name(o->method),
          r->study->parameters.number);
  if (is_difference(o->method)) fprintf(out, ", perturbation %.3g", o->perturbation);
  if (g->threads > 1) fprintf(out, ", %d threads", g->threads);
  if (o->penalty)
    fprintf(out, "\nformulation   penalty %.3g, Jacobians by %s", o->penalty->penalty,
            maggi_jacobian_name(o->penalty->jacobian));
  fprintf(out, "\nsimulation    %.6g s in %ld steps of %.6g s\n", r->study->grid.time, o->steps,
          r->study->grid.step);
  fprintf(out, "computed in   %.3g s, %.3g times the %.3g s of a simulation\n", g->wall,
          g->wall / r->simulation_wall, r->simulation_wall);
  if (o->kept > 0 && !o->penalty)
    fprintf(out, "snapshots     %ld kept, %ld steps computed again\n", o->kept, o->recomputed);
}

void report_text(const report *r, FILE *out)
{
  const maggi_model_info *info = &r->study->info;
  int i;

  fprintf(out, "model         %s: %d bodies, %d coordinates\n", info->name, info->bodies,
          info->coordinates);
  for (i = 0; i < r->study->objectives.number; ++i) print_objective(r, i, out);
  if (r->gradients->relevance) print_relevance(r, out);
  print_cost(r, out);
}
