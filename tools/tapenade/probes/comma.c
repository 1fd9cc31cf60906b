/* comma operator */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = x[i], y[i] = a * a;
  }
}
