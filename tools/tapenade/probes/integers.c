/* a passive structure of integers behind a pointer */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = t->kind[i] * x[i] * x[i];
}
