/* structure by value */
#include "probe.h"

typedef struct pair {
  double u, v;
} pair;

static double product(pair w)
{
  return w.u * w.v;
}

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;
  pair w;

  for (i = 0; i < t->n; ++i) {
    w.u = x[i];
    w.v = x[0];
    y[i] = product(w);
  }
}
