/* --objective: names to objectives. */
#ifndef TOOL_OBJECTIVES_H
#define TOOL_OBJECTIVES_H

#include <maggi/maggi.h>

#include "names.h"

typedef struct objectives {
  maggi_objective **objective; /* (number) */
  int number;
} objectives;

/* Of each name: one declared in the model, or TYPE(SIGNAL).  Exit status, after a message when it is
 * not STATUS_DONE; objectives_free in either case. */
int objectives_create(objectives *o, const maggi_model *m, const names *list);
void objectives_free(objectives *o);

#endif
