/* an output is an input */
#include "probe.h"

static void cross(const double a[3], const double b[3], double r[3])
{
  r[0] = a[1] * b[2] - a[2] * b[1];
  r[1] = a[2] * b[0] - a[0] * b[2];
  r[2] = a[0] * b[1] - a[1] * b[0];
}

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  int k;
  double a[3], b[3], r[3];

  for (k = 0; k < 3; ++k) {
    a[k] = sin(x[k]);
    b[k] = x[k] * x[3];
  }
  cross(a, b, r);
  cross(a, r, r);
  for (k = 0; k < 3; ++k) y[k] = r[k];
  y[3] = x[3];
}
