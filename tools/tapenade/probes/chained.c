/* assignment in an expression */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;
  double a, b;

  for (i = 0; i < t->n; ++i) {
    a = b = x[i];
    y[i] = a * b;
  }
}
