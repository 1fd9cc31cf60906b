/* if on values */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    if (MAGGI_RE(x[i]) < 0.5)
      y[i] = x[i] * x[i];
    else
      y[i] = sin(x[i]);
  }
}
