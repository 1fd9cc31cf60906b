/* loops with bounds from the integers */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i, k;

  for (i = 0; i < t->n; ++i) {
    y[i] = x[i];
    for (k = 0; k < t->kind[i]; ++k) y[i] += x[i] * x[k];
  }
}
