/* goto */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i = 0;

again:
  y[i] = x[i] * x[0];
  if (++i < t->n) goto again;
}
