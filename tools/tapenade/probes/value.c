/* helper with a value */
#include "probe.h"

static double scaled(double a, double b)
{
  return a * b + a;
}

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = scaled(x[i], x[0]);
}
