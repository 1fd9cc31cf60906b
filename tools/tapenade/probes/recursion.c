/* recursion */
#include "probe.h"

static double power(double a, int n)
{
  double r;

  r = 1.0;
  if (n > 0) r = a * power(a, n - 1);
  return r;
}

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = power(x[i], 3);
}
