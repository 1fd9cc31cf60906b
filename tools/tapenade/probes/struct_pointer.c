/* structure with a pointer to real numbers */
#include "probe.h"

typedef struct view {
  const double *a;
} view;

static double first(const view *w, int i)
{
  return w->a[i] * w->a[0];
}

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int i;
  view w;

  w.a = x;
  for (i = 0; i < t->n; ++i) y[i] = first(&w, i);
}
