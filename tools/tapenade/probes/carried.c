/* local carried through a loop */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;
  double a;

  a = x[0];
  for (i = 0; i < t->n; ++i) {
    a = sin(a) * x[i];
    y[i] = a * a;
  }
}
