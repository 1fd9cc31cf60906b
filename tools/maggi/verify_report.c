/* What verify found, for eyes and for programs. */
#include <math.h>
#include <string.h>

#include "json.h"
#include "message.h"
#include "verify.h"

/* Whether the trial is compared with another one: it has not failed. */
static int is_there(const trial *t)
{
  return t->failure[0] == '\0';
}

/* Relative difference of two trials by the parameters that both have. */
static double pair(const verify *v, int a, int b)
{
  const trial *x = &v->trial[a], *y = &v->trial[b];
  int n = x->parameters < y->parameters ? x->parameters : y->parameters;

  if (!is_there(x) || !is_there(y)) return NAN;
  return verify_distance(v, x->gradient, y->gradient, n, NULL);
}

/* ------------------------------------------------------------------------------ text */

static void print_head(const verify *v, FILE *out)
{
  const study *s = v->study;
  int i;

  fprintf(out, "model         %s: %d bodies, %d coordinates\n", s->info.name, s->info.bodies,
          s->info.coordinates);
  fprintf(out, "simulation    %.6g s in %ld steps of %.6g s, computed in %.3g s\n", s->grid.time,
          s->grid.steps, s->grid.step, v->simulation_wall);
  for (i = 0; i < s->objectives.number; ++i)
    fprintf(out, "%-13s %s = %.10g %s\n", i == 0 ? "objectives" : "", s->objective_names.name[i],
            v->value[i], maggi_objective_unit(s->objectives.objective[i]));
  fprintf(out, "parameters    %d", s->parameters.number);
  if (v->trial[TRIAL_DIFFERENCE].parameters < s->parameters.number)
    fprintf(out, "; direct with the %d, differences with the %d most relevant",
            v->trial[TRIAL_DIRECT].parameters, v->trial[TRIAL_DIFFERENCE].parameters);
  putc('\n', out);
}

static void print_trials(const verify *v, FILE *out)
{
  const trial *t;
  int i;

  fprintf(out, "\n%-21s %10s  %9s  %9s  %11s\n", "against the adjoint", "parameters", "error",
          "limit", "simulations");
  for (i = 0; i < TRIAL_COUNT; ++i) {
    t = &v->trial[i];
    fprintf(out, "%-21s %10d  ", t->name, t->parameters);
    if (!is_there(t)) {
      fprintf(out, "%s: FAIL\n", t->failure);
    } else if (i == TRIAL_ADJOINT) {
      fprintf(out, "%9s  %9s  %11.3g\n", "", "", t->wall / v->simulation_wall);
    } else {
      fprintf(out, "%9.2g  %9.2g  %11.3g  %s", t->error, t->limit, t->wall / v->simulation_wall,
              t->pass ? "pass" : "FAIL");
      if (!t->pass) fprintf(out, " (%s)", v->study->objective_names.name[t->objective]);
      putc('\n', out);
    }
  }
  fprintf(out, "\nsnapshots     %d: %ld steps computed again for %ld, %s\n", VERIFY_SNAPSHOTS,
          v->recomputed, v->steps,
          v->trial[TRIAL_SNAPSHOTS].pass ? "the same to the last bit" : "not the same numbers");
  fprintf(out,
          "continuous    error %.2g with half the step, order %.2f; the step itself costs %.2g\n",
          v->half_error, v->order_seen, v->truncation);
}

static void print_perturbations(const verify *v, FILE *out)
{
  int i, k;

  fprintf(out, "\n%-21s %9s  %9s  %9s\n", "perturbation", "centred", "forward", "backward");
  for (k = 0; k < VERIFY_PERTURBATIONS; ++k) {
    fprintf(out, "%-20.0e", verify_perturbation(k));
    for (i = 0; i < 3; ++i) fprintf(out, "  %9.2g", v->perturbation_error[i][k]);
    putc('\n', out);
  }
}

static void print_pairs(const verify *v, FILE *out)
{
  static const char *const heading[TRIAL_COUNT] = {"adjoint", "snapshots", "direct",  "continuous",
                                                   "centred", "forward",   "backward"};
  int i, k;

  fprintf(out, "\n%-21s", "each with each other");
  for (i = 0; i + 1 < TRIAL_COUNT; ++i) fprintf(out, " %10s", heading[i]);
  putc('\n', out);
  for (i = 1; i < TRIAL_COUNT; ++i) {
    fprintf(out, "%-21s", v->trial[i].name);
    for (k = 0; k < i; ++k) fprintf(out, " %10.2g", pair(v, i, k));
    putc('\n', out);
  }
}

void verify_text(const verify *v, FILE *out)
{
  print_head(v, out);
  print_trials(v, out);
  print_perturbations(v, out);
  print_pairs(v, out);
  fprintf(out, "\n%s\n", v->pass ? "all pass" : "FAIL");
}

/* ------------------------------------------------------------------------------ JSON */

static void json_trials(json *j, const verify *v)
{
  const trial *t;
  int i;

  json_open_array(j, "methods");
  for (i = 0; i < TRIAL_COUNT; ++i) {
    t = &v->trial[i];
    json_open_object(j, NULL);
    json_string(j, "method", t->name);
    json_integer(j, "parameters", t->parameters);
    json_number(j, "error", is_there(t) ? t->error : NAN);
    json_number(j, "limit", t->limit);
    json_string(j, "objective", v->study->objective_names.name[t->objective]);
    json_number(j, "wall_s", t->wall);
    json_number(j, "ratio", t->wall / v->simulation_wall);
    json_string(j, "failure", is_there(t) ? NULL : t->failure);
    json_boolean(j, "pass", t->pass);
    json_close_object(j);
  }
  json_close_array(j);
}

static void json_perturbations(json *j, const verify *v)
{
  int i, k;

  json_open_object(j, "perturbations");
  json_open_array(j, "perturbation");
  for (k = 0; k < VERIFY_PERTURBATIONS; ++k) json_number(j, NULL, verify_perturbation(k));
  json_close_array(j);
  for (i = 0; i < 3; ++i) {
    json_open_array(j, v->trial[TRIAL_DIFFERENCE + i].name);
    for (k = 0; k < VERIFY_PERTURBATIONS; ++k) json_number(j, NULL, v->perturbation_error[i][k]);
    json_close_array(j);
  }
  json_close_object(j);
}

static void json_pairs(json *j, const verify *v)
{
  int i, k;

  json_open_array(j, "pairs");
  for (i = 1; i < TRIAL_COUNT; ++i)
    for (k = 0; k < i; ++k) {
      json_open_object(j, NULL);
      json_string(j, "a", v->trial[i].name);
      json_string(j, "b", v->trial[k].name);
      json_number(j, "error", pair(v, i, k));
      json_close_object(j);
    }
  json_close_array(j);
}

void verify_json(const verify *v, FILE *out)
{
  const study *s = v->study;
  json j;
  int i;

  json_init(&j, out);
  json_open_object(&j, NULL);
  json_string(&j, "model", s->info.name);
  json_number(&j, "time", s->grid.time);
  json_number(&j, "step", s->grid.step);
  json_integer(&j, "steps", s->grid.steps);
  json_number(&j, "simulation_wall_s", v->simulation_wall);
  json_open_object(&j, "objectives");
  for (i = 0; i < s->objectives.number; ++i)
    json_number(&j, s->objective_names.name[i], v->value[i]);
  json_close_object(&j);
  json_integer(&j, "parameters", s->parameters.number);
  json_trials(&j, v);
  json_integer(&j, "recomputed", v->recomputed);
  json_open_object(&j, "continuous");
  json_number(&j, "half_step_error", v->half_error);
  json_number(&j, "order", v->order_seen);
  json_number(&j, "truncation", v->truncation);
  json_close_object(&j);
  json_perturbations(&j, v);
  json_pairs(&j, v);
  json_boolean(&j, "pass", v->pass);
  json_close_object(&j);
}
