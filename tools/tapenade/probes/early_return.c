/* early return */
#include "probe.h"

static double positive(double a)
{
  if (a < 0.0) return 0.0;
  return a * a;
}

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = positive(x[i]);
}
