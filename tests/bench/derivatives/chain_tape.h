/* Forces Q(z, z') of the open chain on a tape of ADOL-C, recorded once. */
#ifndef BENCH_CHAIN_TAPE_H
#define BENCH_CHAIN_TAPE_H

#include "topo.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct chain_tape chain_tape;

/* of a model without functions of time, where it stands: coordinates in internal order */
typedef struct chain_state {
  const maggi_topo *t;
  int originadr;
  const double *p, *q, *v;
  int n;           /* coordinates that are not guided */
  const int *free; /* (n) */
} chain_state;

chain_tape *tape_record(const chain_state *at);
void tape_free(chain_tape *of); /* NULL: nothing */
long tape_operations(const chain_tape *of);
/* product (n x directions) of J with `seed` (2n x directions), forward mode, at x = (z, z') of coordinates that
 * are not guided; in as many sweeps as are fastest */
void tape_product(chain_tape *of, const double *x, int directions, const double *seed,
                  double *product);

#ifdef __cplusplus
}
#endif

#endif
