/* Objectives that a model declares, by a simulation of their own. */
#ifndef TOOL_VALUES_H
#define TOOL_VALUES_H

#include <maggi/maggi.h>

#include "formulation.h"
#include "json.h"
#include "objectives.h"
#include "settings.h"

typedef struct values {
  objectives list;
  double *value;
} values;

/* Simulate again and evaluate them: exit status, after a message that begins with `name` when it is
 * not STATUS_DONE; values_free in either case, with v zeroed before.  What has no value is a note
 * unless must, and then there are none. */
int values_compute(values *v, const maggi_model *m, const settings *set, const formulation *f,
                   double tolerance, const maggi_grid *grid, const char *name, int must);
void values_free(values *v);

/* One line each; a member "objectives" of the open object. */
void values_text(const values *v, FILE *out);
void values_json(const values *v, json *j);

#endif
