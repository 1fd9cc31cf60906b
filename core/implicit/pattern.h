/* Which entries of J = [dQ/dz dQ/dz'] can be nonzero.  FORMULATION 8.
 *
 * Q(z, z') are the generalised forces of the open chain with all joint accelerations zero, inertia
 * forces and elements.  Entry (i, j), the same ones in both blocks, from the topology alone:
 *
 *   bodies         i carries j or j carries i, or i = j
 *   rods, springs  i moves one end and j the other, relative to the lowest body that carries both
 *   loads          i moves the body that takes the reaction and j the one that is loaded, relative
 *                  to the lowest body that carries both; not of torques in global axes, which
 *                  follow no body
 *   controllers    j moves the point whose speed they keep, i is a coordinate on which they act
 *   springs on two coordinates
 *                  i is one of them and j the other
 *
 * What a parameter could switch on counts, and no joint is asked whether an entry vanishes for it.
 * All entries of the mass matrix are among these.  Guided coordinates have no row and no column. */
#ifndef MAGGI_PATTERN_H
#define MAGGI_PATTERN_H

#include "maggi/maggi.h"
#include "sparsity.h"
#include "topo.h"

typedef struct maggi_pattern {
  maggi_sparsity J; /* n x 2n: columns of z, then of z' */
  int n;            /* coordinates that are not guided */
  int *q;           /* (n) their internal numbers, rising */
  int *index;       /* (nq) the inverse, -1 if guided */
} maggi_pattern;

/* MAGGI_OK, MAGGI_E_MEMORY */
maggi_status maggi_pattern_create(const maggi_topo *t, maggi_pattern **pattern);
void maggi_pattern_free(maggi_pattern *pattern);

#endif
