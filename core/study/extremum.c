/* Maximum of a polynomial of degree 5 on an interval between two of its nodes. */
#include "extremum.h"

#include <float.h>
#include <math.h>

#include "quadrature.h"

enum { PROBES = 8, ITERATIONS_MAX = 100 };

/* Newton's form: coefficient j multiplies prod (u - u_k), k < j */
typedef struct polynomial {
  int n;
  const double *u;
  double c[MAGGI_STENCIL];
} polynomial;

static void interpolate(polynomial *p, const double *f)
{
  int j, k;

  for (j = 0; j < p->n; ++j) p->c[j] = f[j];
  for (k = 1; k < p->n; ++k)
    for (j = p->n - 1; j >= k; --j) p->c[j] = (p->c[j] - p->c[j - 1]) / (p->u[j] - p->u[j - k]);
}

/* value, first and second derivative */
static void evaluate(const polynomial *p, double u, double y[3])
{
  int j;

  y[0] = y[1] = y[2] = 0.0;
  for (j = p->n - 1; j >= 0; --j) {
    y[2] = y[2] * (u - p->u[j]) + 2.0 * y[1];
    y[1] = y[1] * (u - p->u[j]) + y[0];
    y[0] = y[0] * (u - p->u[j]) + p->c[j];
  }
}

/* Zero of the derivative between low, where it is positive, and high: Newton's method, bisection where
 * that leaves the bracket. */
static double stationary(const polynomial *p, double low, double high)
{
  double y[3], u = 0.5 * (low + high), step;
  int i;

  for (i = 0; i < ITERATIONS_MAX; ++i) {
    evaluate(p, u, y);
    if (y[1] == 0.0) break;
    if (y[1] > 0.0)
      low = u;
    else
      high = u;
    step = y[2] < 0.0 ? u - y[1] / y[2] : high;
    if (!(step > low && step < high)) step = 0.5 * (low + high);
    if (fabs(step - u) <= 2.0 * DBL_EPSILON * fabs(u)) break;
    u = step;
  }
  return u;
}

double maggi_local_maximum(int n, const double *u, const double *f, double a, double b,
                           double *where)
{
  polynomial p = {.n = n, .u = u};
  double y[3], best, x, spacing = (b - a) / PROBES;
  int i;

  interpolate(&p, f);
  *where = a;
  evaluate(&p, a, y);
  best = y[0];
  for (i = 1; i <= PROBES; ++i) {
    x = i == PROBES ? b : a + i * spacing;
    evaluate(&p, x, y);
    if (!(y[0] > best)) continue;
    best = y[0];
    *where = x;
  }
  evaluate(&p, *where, y);
  if (y[1] > 0.0 && *where < b)
    *where = stationary(&p, *where, fmin(*where + spacing, b));
  else if (y[1] < 0.0 && *where > a)
    *where = stationary(&p, fmax(*where - spacing, a), *where);
  evaluate(&p, *where, y);
  return y[0];
}
