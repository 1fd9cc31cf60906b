/* Summary of a simulation for eyes and for programs. */
#include "summary.h"

#include <math.h>

#include "json.h"
#include "plan.h"

#define STATE_LINES_MAX 12 /* coordinates whose final state is printed as text */

static double us_per_evaluation(const run *r)
{
  return r->evaluations > 0 ? 1e6 * r->wall / (double)r->evaluations : NAN;
}

static int is_coloured(maggi_jacobian way)
{
  return way == MAGGI_JACOBIAN_DIFFERENCE_COLOURED || way == MAGGI_JACOBIAN_TANGENT_COLOURED;
}

static void print_loops(const run *r, FILE *out)
{
  const maggi_model_info *info = &r->rows->info;

  if (info->loops == 0) return;
  fprintf(out, "loops         %d with %d equations of rank %d, largest violation %.2g\n",
          info->loops, info->loop_equations, r->loops.rank, r->violation_max);
  fprintf(out, "singularity   smallest pivot ratio %.3g at t = %.6g s\n", r->pivot_ratio_min,
          r->pivot_ratio_time);
  fprintf(out, "corrections   %ld changes of coordinates, %ld projections\n", r->loops.changes,
          r->loops.projections);
}

static void print_formulation(const run *r, FILE *out)
{
  const maggi_penalty_options *o = &r->formulation->options;
  maggi_penalty_state state;

  if (!r->penalty) return;
  maggi_penalty_get_state(r->penalty, &state);
  fprintf(out, "formulation   penalty %.3g, %ld Newton iterations\n", o->penalty, state.iterations);
  fprintf(out, "Jacobians     %ld, %s, %d nonzeros, %d %s\n", state.jacobians,
          maggi_jacobian_name(o->jacobian), state.nonzeros, state.colours,
          is_coloured(o->jacobian) ? "colours" : "columns");
}

static void print_state(const run *r, FILE *out)
{
  const rows *w = r->rows;
  int i, is_angle;

  if (w->info.coordinates > STATE_LINES_MAX) {
    fprintf(out, "final state   of %d coordinates: see --json or --out\n", w->info.coordinates);
    return;
  }
  for (i = 0; i < w->info.coordinates; ++i) {
    is_angle = maggi_coordinate_is_angle(w->model, i);
    fprintf(out, "%-13s %-16s q = %14.9g %-3s  v = %14.9g %s\n", i == 0 ? "final state" : "",
            maggi_coordinate_name(w->model, i), w->q[i], is_angle ? "rad" : "m", w->v[i],
            is_angle ? "rad/s" : "m/s");
  }
}

void summary_text(const run *r, const char *out_name, FILE *out)
{
  const maggi_model_info *info = &r->rows->info;

  maggi_get_coordinates(r->data, r->rows->q, r->rows->v, NULL);
  fprintf(out, "model         %s: %d bodies, %d coordinates, %d degrees of freedom\n", info->name,
          info->bodies, info->coordinates, r->loops.dof);
  if (r->interrupted)
    fprintf(out, "interrupted   at t = %.6g s, after %ld of %ld steps\n", maggi_get_time(r->data),
            r->done, r->grid.steps);
  fprintf(out, "simulated     %.6g s in %ld steps of %.6g s\n", maggi_get_time(r->data), r->done,
          r->grid.step);
  fprintf(out, "computed in   %.3g s", r->wall);
  if (r->evaluations > 0)
    fprintf(out, ", %.3g us for each of %ld evaluations", us_per_evaluation(r), r->evaluations);
  putc('\n', out);
  print_formulation(r, out);
  print_loops(r, out);
  fprintf(out, "energy drift  %.2g (kinetic %.6g J, potential %.6g J, work %.6g J at the end)\n",
          run_energy_drift(r), r->energy.kinetic, r->energy.potential, r->energy.work);
  if (out_name)
    fprintf(out, "written       %ld rows to %s\n", r->rows->table.rows, r->rows->table.name);
  if (r->values) values_text(r->values, out);
  print_state(r, out);
}

static void json_state(json *j, const char *key, const rows *w, const double *value)
{
  int i;

  json_open_object(j, key);
  for (i = 0; i < w->info.coordinates; ++i)
    json_number(j, maggi_coordinate_name(w->model, i), value[i]);
  json_close_object(j);
}

static void json_formulation(json *j, const run *r)
{
  const maggi_penalty_options *o = &r->formulation->options;
  maggi_penalty_state state;

  json_string(j, "formulation", r->penalty ? "penalty" : "maggi");
  if (!r->penalty) return;
  maggi_penalty_get_state(r->penalty, &state);
  json_number(j, "penalty", o->penalty);
  json_number(j, "newton_tolerance", o->tolerance);
  json_integer(j, "newton_iterations", state.iterations);
  json_string(j, "jacobian", maggi_jacobian_name(o->jacobian));
  json_integer(j, "jacobians", state.jacobians);
  json_integer(j, "nonzeros", state.nonzeros);
  json_integer(j, "colours", state.colours);
}

void summary_members(const run *r, const char *out_name, json *j)
{
  const maggi_model_info *info = &r->rows->info;

  maggi_get_coordinates(r->data, r->rows->q, r->rows->v, NULL);
  json_string(j, "model", info->name);
  json_integer(j, "bodies", info->bodies);
  json_integer(j, "coordinates", info->coordinates);
  json_integer(j, "dof", r->loops.dof);
  json_integer(j, "loop_equations", info->loop_equations);
  json_integer(j, "rank", r->loops.rank);
  json_number(j, "time", maggi_get_time(r->data));
  json_number(j, "step", r->grid.step);
  json_number(j, "last_step", plan_last_step(&r->grid));
  json_integer(j, "steps", r->done);
  json_formulation(j, r);
  json_integer(j, "evaluations", r->evaluations);
  json_number(j, "wall_s", r->wall);
  json_number(j, "us_per_evaluation", us_per_evaluation(r));
  json_number(j, "max_loop_violation", r->violation_max);
  json_number(j, "min_pivot_ratio", info->loops > 0 ? r->pivot_ratio_min : NAN);
  json_number(j, "min_pivot_time", info->loops > 0 ? r->pivot_ratio_time : NAN);
  json_integer(j, "changes_of_coordinates", r->loops.changes);
  json_integer(j, "projections", r->loops.projections);
  json_number(j, "energy_drift", run_energy_drift(r));
  json_boolean(j, "interrupted", r->interrupted);
  json_string(j, "out", out_name);
  json_integer(j, "rows", r->rows->table.rows);
  json_state(j, "q", r->rows, r->rows->q);
  json_state(j, "v", r->rows, r->rows->v);
  if (r->values) values_json(r->values, j);
}

void summary_json(const run *r, const char *out_name, FILE *out)
{
  json j;

  json_init(&j, out);
  json_open_object(&j, NULL);
  summary_members(r, out_name, &j);
  json_close_object(&j);
}
