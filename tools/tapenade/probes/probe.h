/* What the probes share: integers, and the function that each of them defines. */
#ifndef PROBE_H
#define PROBE_H

#include <math.h>

/* as in core/kernel/kernel.h */
#ifndef MAGGI_RE
#define MAGGI_RE(x) (x)
#endif

typedef struct topo {
  int n;       /* 4 */
  int *parent; /* of 0 .. n - 1, larger, at most n */
  int *kind;   /* 0, 1, 2, .. */
} topo;

void probe(const topo *t, const double x[t->n], double y[t->n]);

#endif
