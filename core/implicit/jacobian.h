/* J = [dQ/dz dQ/dz'] of the forces of the open chain, in the ways that [1] chapter 4 compares. */
#ifndef MAGGI_JACOBIAN_H
#define MAGGI_JACOBIAN_H

#include "colour.h"
#include "derivative.h"
#include "pattern.h"

typedef struct maggi_force_jacobian maggi_force_jacobian;
struct maggi_force_jacobian {
  maggi_data *d;
  maggi_derivative *D; /* of tangents and adjoints, NULL for differences */
  void (*compute)(maggi_force_jacobian *j, double time); /* the way; bench-derivatives has more */
  maggi_pattern *pattern;
  maggi_colouring *colouring; /* of the columns of J; NULL: one column at a time */
  double *value;              /* (entries) in the order of pattern->J */
  double *ahead;              /* (n) forces at the first of two points */
  double *product;            /* (n x MAGGI_NDIR) of J with directions, then 2 nq of work */
  int *next;                  /* (2 n) */
};

/* status MAGGI_OK, MAGGI_E_MEMORY; free(NULL) does nothing */
maggi_status maggi_force_jacobian_create(maggi_data *d, maggi_jacobian way,
                                         maggi_force_jacobian **jacobian);
void maggi_force_jacobian_free(maggi_force_jacobian *j);
/* J at positions d->q and velocities d->v, which are as they were after it; the evaluation in d is
 * that of forces without accelerations */
void maggi_force_jacobian_compute(maggi_force_jacobian *j, double time);

#endif
