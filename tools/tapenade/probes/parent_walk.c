/* walk up a table of parents */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i, k;

  for (i = 0; i < t->n; ++i) {
    y[i] = x[i];
    for (k = t->parent[i]; k < t->n; k = t->parent[k]) y[i] += x[i] * x[k];
  }
}
