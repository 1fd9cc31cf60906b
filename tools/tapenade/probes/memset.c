/* memset of active data */
#include "probe.h"

void *memset(void *to, int c, unsigned long size);

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;
  double a[4];

  memset(a, 0, sizeof a);
  for (i = 0; i < t->n; ++i) a[i] += x[i] * x[0];
  for (i = 0; i < t->n; ++i) y[i] = a[i];
}
