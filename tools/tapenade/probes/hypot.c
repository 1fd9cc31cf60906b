/* hypot, length of two sides */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = x[i] * hypot(x[i], 1.5);
}
