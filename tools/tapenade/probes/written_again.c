/* element written again */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = sin(x[i]);
    y[i] = y[i] * x[0];
  }
}
