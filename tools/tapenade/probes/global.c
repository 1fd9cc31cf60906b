/* variable outside of functions */
#include "probe.h"

static double last;

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  last = x[0];
  for (i = 0; i < t->n; ++i) y[i] = last * x[i];
}
