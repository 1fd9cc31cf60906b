/* integers that index */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  y[t->n - 1] = x[t->n - 1] * x[0];
  for (i = t->n - 2; i >= 0; --i) y[i] = y[t->parent[i]] * x[t->kind[i]];
}
