/* const local in a block */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    const double a = x[i] * x[0];
    y[i] = a * a;
  }
}
