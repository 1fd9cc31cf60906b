/* The ways to the Jacobian of the forces of the open chain against each other, at random states of
 * a simulation after its reset. */
#ifndef MAGGI_TEST_JACOBIAN_WAYS_H
#define MAGGI_TEST_JACOBIAN_WAYS_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "chain.h"
#include "jacobian.h"

typedef struct jacobian_findings {
  int is_same;       /* coordinates, velocities as they were, forces those of the state */
  double size;       /* largest entry by tangents */
  double exact;      /* largest distance of tangents by colours and adjoints from them .. */
  double difference; /* and of differences, relative to the largest entry */
} jacobian_findings;

static inline void jacobian_ways_state(maggi_data *d, unsigned long long *seed)
{
  int i;

  for (i = 0; i < 2 * d->t.nq; ++i) {
    *seed = *seed * 6364136223846793005ull + 1442695040888963407ull;
    (i < d->t.nq ? d->q : d->v - d->t.nq)[i] = (double)(*seed >> 11) * 0x1p-52 - 1.0;
  }
}

static inline double jacobian_ways_distance(const maggi_force_jacobian *a,
                                            const maggi_force_jacobian *b)
{
  double worst = 0.0, x;
  int k;

  for (k = 0; k < a->pattern->J.coladr[a->pattern->J.ncol]; ++k) {
    x = fabs(a->value[k] - b->value[k]);
    if (!(x <= worst)) worst = x;
  }
  return worst;
}

/* an entry of state, 2 nq of positions and velocities, then nq of forces */
static inline void jacobian_ways_keep(maggi_data *d, double time, double *kept)
{
  size_t bytes = (size_t)d->t.nq * sizeof *kept;

  maggi_chain_forces(d, time);
  memcpy(kept, d->q, bytes);
  memcpy(kept + d->t.nq, d->v, bytes);
  memcpy(kept + 2 * d->t.nq, d->w, bytes);
}

static inline jacobian_findings jacobian_ways_examine(maggi_data *d, int states,
                                                      unsigned long long seed)
{
  maggi_force_jacobian *j[MAGGI_JACOBIAN_COUNT];
  jacobian_findings f = {.is_same = 1};
  size_t numbers = 3 * (size_t)d->t.nq;
  double *kept = malloc((2 * numbers + 1) * sizeof *kept), *now = kept + numbers, time, x;
  int way, k, state;

  for (way = 0; way < MAGGI_JACOBIAN_COUNT; ++way)
    if (maggi_force_jacobian_create(d, (maggi_jacobian)way, &j[way]) != MAGGI_OK) abort();
  for (state = 0; state < states; ++state) {
    time = 0.3 * state;
    jacobian_ways_state(d, &seed);
    jacobian_ways_keep(d, time, kept);
    for (way = 0; way < MAGGI_JACOBIAN_COUNT; ++way) {
      maggi_force_jacobian_compute(j[way], time);
      memcpy(now, d->w, (size_t)d->t.nq * sizeof *now);
      f.is_same = f.is_same && memcmp(now, kept + 2 * d->t.nq, numbers / 3 * sizeof *now) == 0;
      jacobian_ways_keep(d, time, now);
      f.is_same = f.is_same && memcmp(now, kept, numbers * sizeof *now) == 0;
    }
    f.size = 0.0;
    for (k = 0; k < j[MAGGI_JACOBIAN_TANGENT]->pattern->J.coladr[j[0]->pattern->J.ncol]; ++k)
      f.size = fmax(f.size, fabs(j[MAGGI_JACOBIAN_TANGENT]->value[k]));
    for (way = 0; way < MAGGI_JACOBIAN_COUNT && f.size > 0.0; ++way) {
      x = jacobian_ways_distance(j[way], j[MAGGI_JACOBIAN_TANGENT]) / f.size;
      if (way == MAGGI_JACOBIAN_DIFFERENCE || way == MAGGI_JACOBIAN_DIFFERENCE_COLOURED)
        f.difference = x <= f.difference ? f.difference : x;
      else
        f.exact = x <= f.exact ? f.exact : x;
    }
  }
  for (way = 0; way < MAGGI_JACOBIAN_COUNT; ++way) maggi_force_jacobian_free(j[way]);
  free(kept);
  return f;
}

#endif
