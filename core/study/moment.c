/* Sums of w (x - origin)^n, and what they are with another origin. */
#include "moment.h"

#include <math.h>

void maggi_moments_push(maggi_moments *m, double weight, double x)
{
  double product = 1.0;
  int n;

  if (isnan(m->origin)) m->origin = x;
  for (n = 0; n <= m->power; ++n) {
    if (n == m->power || m->can_shift) m->sum[n] += weight * product;
    product *= x - m->origin;
  }
}

/* (x - a)^n = sum of binomial(n, j) (x - b)^j (b - a)^(n - j), highest sums first */
void maggi_moments_shift(maggi_moments *m, double origin)
{
  double by = m->origin - origin, total, binomial, product;
  int n, j;

  for (n = m->power; n >= 0; --n) {
    total = 0.0;
    binomial = product = 1.0;
    for (j = n; j >= 0; --j) {
      total += binomial * product * m->sum[j];
      product *= by;
      binomial *= (double)j / (n - j + 1);
    }
    m->sum[n] = total;
  }
  m->origin = origin;
}
