/* Values of objectives. */
#include "values.h"

#include <stdlib.h>
#include <string.h>

#include "interrupt.h"
#include "message.h"
#include "names.h"

static int stop(void *context, double part)
{
  (void)context;
  (void)part;
  return interrupt_seen();
}

/* the declared objectives by name */
static int create(values *v, const maggi_model *m)
{
  names declared = {NULL, 0};
  const char *name;
  int i, status = STATUS_DONE;

  for (i = 0; (name = maggi_model_objective(m, i)) != NULL && status == STATUS_DONE; ++i)
    if (names_add(&declared, name, strlen(name)))
      status = message_fail(STATUS_FAILED, "out of memory");
  if (status == STATUS_DONE) status = objectives_create(&v->list, m, &declared);
  names_free(&declared);
  return status;
}

static int evaluate(values *v, maggi_data *d, const formulation *f, const maggi_grid *grid,
                    const char *name, int must)
{
  maggi_gradient_options options;
  maggi_status status;
  const char *reason;

  maggi_gradient_options_init(&options);
  options.time = grid->time;
  options.step = grid->step;
  options.penalty = f->is_penalty ? &f->options : NULL;
  options.progress = stop;
  status = maggi_gradient(d, NULL, v->list.number, v->list.objective, &options, v->value, NULL);
  if (status == MAGGI_OK) return STATUS_DONE;
  if (status == MAGGI_E_STOPPED) return STATUS_INTERRUPTED;
  reason = maggi_data_message(d);
  if (!reason[0]) reason = maggi_status_text(status);
  if (must) return message_fail(STATUS_FAILED, "%s: %s", name, reason);
  message_note("%s: no values of objectives: %s", name, reason);
  free(v->value);
  v->value = NULL;
  return STATUS_DONE;
}

int values_compute(values *v, const maggi_model *m, const settings *set, const formulation *f,
                   double tolerance, const maggi_grid *grid, const char *name, int must)
{
  maggi_data *d = NULL;
  int status = create(v, m);

  if (status != STATUS_DONE || v->list.number == 0) return status;
  v->value = calloc((size_t)v->list.number, sizeof *v->value);
  if (!v->value || maggi_data_create(m, &d) != MAGGI_OK)
    return message_fail(STATUS_FAILED, "%s: out of memory", name);
  status = formulation_tolerance(f, d, tolerance);
  if (status == STATUS_DONE) status = settings_apply(set, m, d);
  if (status == STATUS_DONE) status = evaluate(v, d, f, grid, name, must);
  maggi_data_free(d);
  return status;
}

void values_free(values *v)
{
  objectives_free(&v->list);
  free(v->value);
  v->value = NULL;
}

void values_text(const values *v, FILE *out)
{
  int i;

  for (i = 0; v->value && i < v->list.number; ++i)
    fprintf(out, "%-13s %-30s %14.9g %s\n", i == 0 ? "objectives" : "",
            maggi_objective_name(v->list.objective[i]), v->value[i],
            maggi_objective_unit(v->list.objective[i]));
}

void values_json(const values *v, json *j)
{
  int i;

  json_open_array(j, "objectives");
  for (i = 0; v->value && i < v->list.number; ++i) {
    json_open_object(j, NULL);
    json_string(j, "name", maggi_objective_name(v->list.objective[i]));
    json_number(j, "value", v->value[i]);
    json_string(j, "unit", maggi_objective_unit(v->list.objective[i]));
    json_close_object(j);
  }
  json_close_array(j);
}
