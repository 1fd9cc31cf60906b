/* memory allocated */
#include "probe.h"

void *malloc(unsigned long size);
void free(void *p);

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;
  double *a = malloc(t->n * sizeof *a);

  for (i = 0; i < t->n; ++i) a[i] = x[i] * x[i];
  for (i = 0; i < t->n; ++i) y[i] = a[i] * x[0];
  free(a);
}
