/* local pointer */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;
  const double *a;

  a = x;
  for (i = 0; i < t->n; ++i) y[i] = a[i] * a[0];
}
