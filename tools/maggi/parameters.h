/* --parameters: items to design parameters.
 *
 *   GLOB                                         declared design parameters, else entries of p
 *   all                                          every entry of p
 *   NAME=TERM{+TERM}[:NOMINAL[:LOWER:UPPER[:UNIT]]]   one of its own; TERM is [FACTOR*]PATH
 */
#ifndef TOOL_PARAMETERS_H
#define TOOL_PARAMETERS_H

#include <maggi/maggi.h>

#include "names.h"

typedef struct parameters {
  const maggi_model *model;
  maggi_design *design;
  int number;
  const char **item; /* that defined the parameter, or NULL when its name is enough   (number) */
} parameters;

/* Exit status, after a message when it is not STATUS_DONE; parameters_free in either case.  The names
 * in the list must stay. */
int parameters_create(parameters *p, const maggi_model *m, const maggi_data *d, const names *list);
void parameters_free(parameters *p);

/* A design of n of them, by index; the same. */
int parameters_pick(const parameters *p, const maggi_data *d, int n, const int *index,
                    maggi_design **design);

#endif
