/* a call changes its argument */
#include "probe.h"

static void scale(double f, double r[3])
{
  int k;

  for (k = 0; k < 3; ++k) r[k] = f * r[k];
}

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int k;
  double r[3];

  for (k = 0; k < 3; ++k) r[k] = sin(x[k]);
  scale(x[3], r);
  for (k = 0; k < 3; ++k) y[k] = r[k];
  y[3] = x[3];
}
