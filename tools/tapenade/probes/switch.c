/* switch with break in every case */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    switch (t->kind[i]) {
    case 0:
      y[i] = x[i] * x[i];
      break;
    case 1:
      y[i] = sin(x[i]);
      break;
    default:
      y[i] = x[i];
      break;
    }
  }
}
