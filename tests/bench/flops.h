/* Flops of one evaluation, from the integers of a model and its plan. */
#ifndef BENCH_FLOPS_H
#define BENCH_FLOPS_H

#include "staged.h"
#include "topo.h"

/* Flops of each kernel function of STAGED_LIST: + - * / sqrt sin cos as 1 each.  The kernel works
 * on blocks of MAGGI_WIDTH columns; width 1 counts only the columns that a row has, which is what
 * the mathematics needs, width MAGGI_WIDTH what the processor executes.  chol: factors of the islands
 * in the present position. */
void flops_derive(const maggi_topo *t, const double *chol, int width, long flops[STAGED_COUNT]);

#endif
