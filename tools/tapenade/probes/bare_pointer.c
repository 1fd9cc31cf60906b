/* bare pointer as a parameter */
#include "probe.h"

static double sum(int n, const double *a)
{
  int i;
  double s;

  s = 0.0;
  for (i = 0; i < n; ++i) s += a[i] * a[i];
  return s;
}

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = sum(t->n, x) * x[i];
}
