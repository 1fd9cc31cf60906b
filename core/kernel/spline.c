/* Natural cubic splines, of functions of time and of roads. */
#include "kernel.h"

/* natural cubic spline through (t_k, y_k): second derivatives m_k from the tridiagonal system
 *   h_{k-1} m_{k-1} + 2 (h_{k-1} + h_k) m_k + h_k m_{k+1} = 6 (e_k - e_{k-1}),  e = slope of a piece
 * by elimination, m = 0 at the ends.  Columns of s: m, and what the elimination needs. */
void maggi_spline(int np, const double p[np], int adr, int n, int row, int nspline,
                  double s[nspline][3])
{
  int k;
  double h0, h1, e0, e1, w;

  s[row][1] = 0.0;
  s[row][2] = 0.0;
  for (k = 1; k < n - 1; ++k) {
    h0 = p[adr + k] - p[adr + k - 1];
    h1 = p[adr + k + 1] - p[adr + k];
    e0 = (p[adr + n + k] - p[adr + n + k - 1]) / h0;
    e1 = (p[adr + n + k + 1] - p[adr + n + k]) / h1;
    w = 2.0 * (h0 + h1) - h0 * s[row + k - 1][2];
    s[row + k][1] = (6.0 * (e1 - e0) - h0 * s[row + k - 1][1]) / w;
    s[row + k][2] = h1 / w;
  }
  s[row][0] = 0.0;
  s[row + n - 1][0] = 0.0;
  for (k = n - 2; k > 0; --k) s[row + k][0] = s[row + k][1] - s[row + k][2] * s[row + k + 1][0];
}

/* piece k with t_k <= x < t_{k+1}; -1 before the first, n - 1 after the last */
int maggi_piece(int np, const double p[np], int adr, int n, double x)
{
  int k, low, high, middle;

  low = -1;
  high = n;
  for (k = 0; k < n; ++k) {
    if (high - low < 2) return low;
    middle = (low + high) / 2;
    if (MAGGI_RE(x) < MAGGI_RE(p[adr + middle]))
      high = middle;
    else
      low = middle;
  }
  return low;
}

void maggi_spline_value(int np, const double p[np], int adr, int n, int madr, int nspline,
                        const double m[nspline][3], double time, double f[3])
{
  int k;
  double h, a, c, e, slope;

  k = maggi_piece(np, p, adr, n, time);
  if (k < 0) {
    h = p[adr + 1] - p[adr];
    slope = (p[adr + n + 1] - p[adr + n]) / h - h / 6.0 * (2.0 * m[madr][0] + m[madr + 1][0]);
    f[0] = p[adr + n] + slope * (time - p[adr]);
    f[1] = slope;
    f[2] = 0.0;
  } else if (k > n - 2) {
    h = p[adr + n - 1] - p[adr + n - 2];
    slope = (p[adr + n + n - 1] - p[adr + n + n - 2]) / h +
            h / 6.0 * (m[madr + n - 2][0] + 2.0 * m[madr + n - 1][0]);
    f[0] = p[adr + n + n - 1] + slope * (time - p[adr + n - 1]);
    f[1] = slope;
    f[2] = 0.0;
  } else {
    h = p[adr + k + 1] - p[adr + k];
    a = p[adr + k + 1] - time;
    c = time - p[adr + k];
    e = (p[adr + n + k + 1] - p[adr + n + k]) / h - h / 6.0 * (m[madr + k + 1][0] - m[madr + k][0]);
    f[0] = (m[madr + k][0] * a * a * a + m[madr + k + 1][0] * c * c * c) / (6.0 * h) +
           p[adr + n + k] - m[madr + k][0] * h * h / 6.0 + e * c;
    f[1] = (m[madr + k + 1][0] * c * c - m[madr + k][0] * a * a) / (2.0 * h) + e;
    f[2] = (m[madr + k][0] * a + m[madr + k + 1][0] * c) / h;
  }
}
