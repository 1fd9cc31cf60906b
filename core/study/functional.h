/* Objectives of a simulation, sample by sample: see maggi.h for what they are.
 *
 * A simulation on a grid has samples s(t_k) of its signals, k = 0 .. grid->steps.  An objective is a
 * function of all of them that is computed in two passes: forward, where every sample is pushed in order,
 * and then, in any order, the weights dJ/ds(t_k).  Samples are not stored: memory does not depend on
 * their number.
 */
#ifndef MAGGI_FUNCTIONAL_H
#define MAGGI_FUNCTIONAL_H

#include "maggi/maggi.h"

/* Start of a pass.  MAGGI_OK; MAGGI_E_VALUE for a time that the simulation does not reach. */
maggi_status maggi_objective_begin(maggi_objective *o, const maggi_grid *grid, char *message,
                                   size_t n);
/* Sample k of its signals, in the order of maggi_objective_signals. */
void maggi_objective_push(maggi_objective *o, long k, const double *s);
/* After the last sample.  MAGGI_OK; MAGGI_E_VALUE when the value is not finite. */
maggi_status maggi_objective_end(maggi_objective *o, double *value, char *message, size_t n);

/* After the end: whether it has a derivative there.  MAGGI_OK; MAGGI_E_VALUE for a root of zero. */
maggi_status maggi_objective_differentiable(const maggi_objective *o, char *message, size_t n);
/* After the end: gradient by sample k, whose values are s.  False when all of it is zero; then
 * weight is not set. */
int maggi_objective_weights(const maggi_objective *o, long k, const double *s, double *weight);

#endif
