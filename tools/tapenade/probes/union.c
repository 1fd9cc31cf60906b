/* union */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;
  union bits {
    double a;
    long b;
  } u;

  for (i = 0; i < t->n; ++i) {
    u.a = x[i];
    y[i] = u.a * u.a;
  }
}
