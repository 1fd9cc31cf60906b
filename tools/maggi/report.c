/* Results of a sensitivity analysis as numbers, JSON and CSV; as text: report_text.c. */
#include "report.h"

#include <math.h>
#include <stdlib.h>

#include "ranking.h"
#include "unit.h"

/* Largest |b dJ/db| first; parameters that are 0 after the others, by |dJ/db|. */
static int sort(report *r, double *weight)
{
  const study *s = r->study;
  const double *gradient = r->gradients->gradient;
  int n = s->parameters.number, i, k, failed = 0;

  for (i = 0; i < s->objectives.number && !failed; ++i, gradient += n) {
    for (k = 0; k < n; ++k) weight[k] = maggi_design_value(s->parameters.design, k) * gradient[k];
    failed = ranking(n, weight, gradient, r->order + (size_t)i * (size_t)n);
  }
  if (!failed && r->gradients->relevance)
    failed = ranking(n, r->gradients->relevance, NULL, r->relevant);
  return failed;
}

int report_init(report *r)
{
  size_t n = (size_t)r->study->parameters.number, nobjective = (size_t)r->study->objectives.number;
  double *weight = calloc(n, sizeof *weight);
  int failed;

  r->order = calloc(n * nobjective, sizeof *r->order);
  r->relevant = calloc(n, sizeof *r->relevant);
  failed = !weight || !r->order || !r->relevant || sort(r, weight);
  free(weight);
  return failed ? -1 : 0;
}

void report_free(report *r)
{
  free(r->order);
  free(r->relevant);
}

double report_normalised(const report *r, int objective, int parameter)
{
  int n = r->study->parameters.number;
  double b = maggi_design_value(r->study->parameters.design, parameter);
  double x = b / r->gradients->value[objective] *
             r->gradients->gradient[(size_t)objective * (size_t)n + (size_t)parameter];

  return b != 0.0 && isfinite(x) ? x : NAN;
}

const char *report_unit(const report *r, int objective, int parameter, char *text)
{
  return unit_quotient(maggi_objective_unit(r->study->objectives.objective[objective]),
                       maggi_design_unit(r->study->parameters.design, parameter), text);
}

const char *report_relevance_unit(const report *r, int parameter, char *text)
{
  int coordinate = r->gradients->coordinate[parameter];

  return unit_quotient(maggi_coordinate_is_angle(r->study->model, coordinate) ? "rad" : "m",
                       maggi_design_unit(r->study->parameters.design, parameter), text);
}

/* ------------------------------------------------------------------------------ JSON */

/* {parameter: number} for the numbers of all parameters. */
static void json_numbers(json *j, const report *r, const char *key,
                         double (*number)(const report *r, int objective, int parameter),
                         int objective)
{
  int k;

  json_open_object(j, key);
  for (k = 0; k < r->study->parameters.number; ++k)
    json_number(j, maggi_design_name(r->study->parameters.design, k), number(r, objective, k));
  json_close_object(j);
}

static double gradient(const report *r, int objective, int parameter)
{
  size_t n = (size_t)r->study->parameters.number;

  return r->gradients->gradient[(size_t)objective * n + (size_t)parameter];
}

static double nominal(const report *r, int objective, int parameter)
{
  (void)objective;
  return maggi_design_value(r->study->parameters.design, parameter);
}

static void json_objective(json *j, const report *r, int objective)
{
  const maggi_design *design = r->study->parameters.design;
  int n = r->study->parameters.number, k;
  char unit[UNIT_MAX];

  json_string(j, "objective", r->study->objective_names.name[objective]);
  json_number(j, "value", r->gradients->value[objective]);
  json_string(j, "unit", maggi_objective_unit(r->study->objectives.objective[objective]));
  json_numbers(j, r, "gradient", gradient, objective);
  json_open_object(j, "units");
  for (k = 0; k < n; ++k)
    json_string(j, maggi_design_name(design, k), report_unit(r, objective, k, unit));
  json_close_object(j);
  json_numbers(j, r, "normalised", report_normalised, objective);
  json_open_array(j, "ranking");
  for (k = 0; k < n; ++k)
    json_string(j, NULL,
                maggi_design_name(design, r->order[(size_t)objective * (size_t)n + (size_t)k]));
  json_close_array(j);
}

static void json_relevance(json *j, const report *r)
{
  char unit[UNIT_MAX];
  int i, k;

  json_open_object(j, "relevance");
  for (i = 0; i < r->study->parameters.number; ++i) {
    k = r->relevant[i];
    json_open_object(j, maggi_design_name(r->study->parameters.design, k));
    json_number(j, "value", r->gradients->relevance[k]);
    json_string(j, "unit", report_relevance_unit(r, k, unit));
    json_string(j, "coordinate",
                maggi_coordinate_name(r->study->model, r->gradients->coordinate[k]));
    json_close_object(j);
  }
  json_close_object(j);
}

static void json_cost(json *j, const report *r)
{
  const maggi_gradient_options *o = &r->gradients->options;

  json_string(j, "method", maggi_method_name(o->method));
  json_string(j, "formulation", o->penalty ? "penalty" : "maggi");
  if (o->penalty) {
    json_number(j, "penalty", o->penalty->penalty);
    json_string(j, "jacobian", maggi_jacobian_name(o->penalty->jacobian));
  }
  json_integer(j, "parameters", r->study->parameters.number);
  json_number(j, "time", r->study->grid.time);
  json_number(j, "step", r->study->grid.step);
  json_integer(j, "steps", o->steps);
  json_integer(j, "recomputed", o->recomputed);
  json_integer(j, "kept", o->kept);
  json_integer(j, "threads", r->gradients->threads);
  json_number(j, "wall_s", r->gradients->wall);
  json_number(j, "simulation_wall_s", r->simulation_wall);
  json_number(j, "ratio", r->gradients->wall / r->simulation_wall);
}

void report_json(const report *r, FILE *out)
{
  json j;
  int i;

  json_init(&j, out);
  json_open_object(&j, NULL);
  json_string(&j, "model", r->study->info.name);
  if (r->study->objectives.number == 1) {
    json_objective(&j, r, 0);
  } else {
    json_open_array(&j, "objectives");
    for (i = 0; i < r->study->objectives.number; ++i) {
      json_open_object(&j, NULL);
      json_objective(&j, r, i);
      json_close_object(&j);
    }
    json_close_array(&j);
  }
  json_numbers(&j, r, "nominal", nominal, 0);
  if (r->gradients->relevance) json_relevance(&j, r);
  json_cost(&j, r);
  json_close_object(&j);
}

/* ------------------------------------------------------------------------------ CSV */

static void csv_header(const report *r, table *t)
{
  static const char *const title[] = {"objective", "rank",     "parameter",     "nominal",
                                      "unit",      "gradient", "gradient_unit", "normalised"};
  size_t i;

  for (i = 0; i < sizeof title / sizeof title[0]; ++i) table_title(t, title[i], NULL);
  if (r->gradients->relevance) {
    table_title(t, "relevance", NULL);
    table_title(t, "relevance_unit", NULL);
    table_title(t, "coordinate", NULL);
  }
  table_end_header(t);
}

static void csv_row(const report *r, table *t, int objective, int rank)
{
  const maggi_design *design = r->study->parameters.design;
  int n = r->study->parameters.number, k = r->order[(size_t)objective * (size_t)n + (size_t)rank];
  char unit[UNIT_MAX];

  table_text(t, r->study->objective_names.name[objective]);
  table_number(t, rank + 1);
  table_text(t, maggi_design_name(design, k));
  table_number(t, maggi_design_value(design, k));
  table_text(t, maggi_design_unit(design, k));
  table_number(t, gradient(r, objective, k));
  table_text(t, report_unit(r, objective, k, unit));
  table_number(t, report_normalised(r, objective, k));
  if (r->gradients->relevance) {
    table_number(t, r->gradients->relevance[k]);
    table_text(t, report_relevance_unit(r, k, unit));
    table_text(t, maggi_coordinate_name(r->study->model, r->gradients->coordinate[k]));
  }
  table_end_row(t);
}

void report_csv(const report *r, table *t)
{
  int i, k;

  csv_header(r, t);
  for (i = 0; i < r->study->objectives.number; ++i)
    for (k = 0; k < r->study->parameters.number; ++k) csv_row(r, t, i, k);
}
