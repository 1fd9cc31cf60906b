/* array initialiser with computed values */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  double a[3] = {x[0] * x[1], -x[2], 0.0};
  int k;

  for (k = 0; k < 3; ++k) y[k] = a[k] * a[0];
  y[3] = x[3];
}
