/* memcpy of active data */
#include "probe.h"

void *memcpy(void *to, const void *from, unsigned long size);

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;
  double a[4];

  memcpy(a, x, sizeof a);
  for (i = 0; i < t->n; ++i) y[i] = a[i] * a[0];
}
