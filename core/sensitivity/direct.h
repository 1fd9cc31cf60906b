/* State sensitivities at work: tangents in strips of MAGGI_NDIR, (strips x nq x MAGGI_NDIR), of states of
 * filters (strips x nstate x MAGGI_NDIR). */
#ifndef MAGGI_DIRECT_H
#define MAGGI_DIRECT_H

#include "derivative.h"
#include "design.h"

/* tangents at a node, all strips */
typedef struct maggi_direct_state {
  double *q, *v, *a, *y, *yrate;
} maggi_direct_state;

struct maggi_direct {
  maggi_follower follower; /* first: the two addresses are one */
  maggi_data *d;
  maggi_derivative *D;
  const maggi_design *design;
  int n;                   /* directions */
  size_t strip, nx;        /* numbers of one strip, of all */
  size_t filter_strip, ny; /* of states of filters */
  unsigned need;           /* of rates of filters */
  double *memory;
  maggi_direct_state at[MAGGI_PLACES];
  double *qsum, *vsum, *ysum; /* sums of slopes */
};

/* D->strip: the strip that begins with direction `first`, its state at the present node */
void maggi_direct_choose(maggi_direct *s, int first);

#endif
