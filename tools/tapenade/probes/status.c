/* status code returned beside outputs */
#include "probe.h"

static int solve(double a, double r[1])
{
  if (a == 0.0) return 1;
  r[0] = 1.0 / a;
  return 0;
}

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i, status;
  double r[1];

  for (i = 0; i < t->n; ++i) {
    status = solve(2.0 + x[i], r);
    y[i] = status ? 0.0 : r[0];
  }
}
