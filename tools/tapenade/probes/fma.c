/* fma, a b + c */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = x[i] * fma(x[i], x[0], 1.0);
}
