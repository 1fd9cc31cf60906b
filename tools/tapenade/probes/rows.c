/* rows of an array of two dimensions */
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
  double A[3][3];

  for (k = 0; k < 3; ++k) {
    A[0][k] = sin(x[k]);
    A[1][k] = x[k] * x[3];
  }
  cross(A[0], A[1], A[2]);
  for (k = 0; k < 3; ++k) y[k] = A[2][k];
  y[3] = x[3];
}
