/* Forces Q(z, z') of the open chain on a tape of ADOL-C, recorded once. */
#ifndef BENCH_TAPE_H
#define BENCH_TAPE_H

#include "topo.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tape tape;

/* of a model without functions of time, where it stands: coordinates in internal order */
typedef struct chain_state {
  const maggi_topo *t;
  int originadr;
  const double *p, *q, *v;
  int n;           /* coordinates that are not guided */
  const int *free; /* (n) */
} chain_state;

tape *tape_record(const chain_state *at);
void tape_free(tape *of); /* NULL: nothing */
long tape_operations(const tape *of);
/* product (n x directions) of J with `seed` (2n x directions), forward mode, at x = (z, z') of coordinates that
 * are not guided; as many directions a sweep as fit into memory */
void tape_product(tape *of, const double *x, int directions, const double *seed, double *product);

#ifdef __cplusplus
}
#endif

#endif
