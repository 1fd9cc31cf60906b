/* while loop */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;

  i = 0;
  while (i < t->n) {
    y[i] = x[i] * x[0];
    i += 1;
  }
}
