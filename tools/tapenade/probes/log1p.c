/* log1p, log(1 + x) */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = x[i] * log1p(x[i]);
}
