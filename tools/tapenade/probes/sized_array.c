/* arrays that say how long they are */
#include "probe.h"

static void square(int n, const double a[n], double r[n])
{
  int i;

  for (i = 0; i < n; ++i) r[i] = a[i] * a[i];
}

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  square(t->n, x, y);
}
