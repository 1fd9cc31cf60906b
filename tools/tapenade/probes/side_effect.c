/* side effect in an index */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i, k;

  k = 0;
  for (i = 0; i < t->n; ++i) y[i] = x[k++] * x[0];
}
