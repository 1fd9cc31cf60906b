/* maggi_gradient for a study, with its parameters shared out among threads. */
#ifndef TOOL_GRADIENTS_H
#define TOOL_GRADIENTS_H

#include "study.h"

typedef struct gradients {
  maggi_gradient_options options; /* asked for, and found (steps, recomputed, kept) */
  int threads;                    /* asked for; found: those that had parameters    */
  double *value;                  /* (objectives)                                   */
  double *gradient;               /* (objectives x parameters)                      */
  double *relevance;              /* (parameters), or NULL: not wanted              */
  int *coordinate;                /* (parameters), or NULL                          */
  double wall;                    /* best of a few if they are short [s]            */
} gradients;

/* Compute it: exit status, after a message when it is neither STATUS_DONE nor STATUS_INTERRUPTED.
 * The numbers do not depend on the number of threads. */
int gradients_run(gradients *g, const study *s);

#endif
