/* Functions of time with their first and second derivatives: fun = (s, s', s''). */
#include "kernel.h"
#include "maggi/maggi.h"

/* natural cubic spline through (t_k, y_k): second derivatives m_k from the tridiagonal system
 *   h_{k-1} m_{k-1} + 2 (h_{k-1} + h_k) m_k + h_k m_{k+1} = 6 (e_k - e_{k-1}),  e = slope of a piece
 * by elimination, m = 0 at the ends.  Columns of s: m, and what the elimination needs. */
static void spline(int np, const double p[np], int adr, int n, int row, int nspline,
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

void maggi_spline_constants(const maggi_topo *t, const double p[t->np],
                            double spline0[t->nspline][3])
{
  int i;

  for (i = 0; i < t->nfun; ++i)
    if (t->funkind[i] == MAGGI_FUNCTION_SPLINE)
      spline(t->np, p, t->funadr[i], t->funn[i], t->funspline[i], t->nspline, spline0);
}

/* sum_k c_k t^k */
static void polynomial(int np, const double p[np], int adr, int n, double time, double f[3])
{
  int k;

  f[0] = p[adr];
  f[1] = 0.0;
  f[2] = 0.0;
  for (k = 1; k < n; ++k) {
    f[0] += p[adr + k] * pow(time, k);
    f[1] += p[adr + k] * k * pow(time, k - 1);
    if (k > 1) f[2] += p[adr + k] * k * (k - 1) * pow(time, k - 2);
  }
}

/* y0 + (y1 - y0) (10 x^3 - 15 x^4 + 6 x^5), x = (t - t0) / (t1 - t0) */
static void quintic(double time, double t0, double t1, double y0, double y1, double f[3])
{
  double h, x;

  if (MAGGI_RE(time) <= MAGGI_RE(t0)) {
    f[0] = y0;
    f[1] = 0.0;
    f[2] = 0.0;
  } else if (MAGGI_RE(time) >= MAGGI_RE(t1)) {
    f[0] = y1;
    f[1] = 0.0;
    f[2] = 0.0;
  } else {
    h = t1 - t0;
    x = (time - t0) / h;
    f[0] = y0 + (y1 - y0) * x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
    f[1] = (y1 - y0) / h * 30.0 * x * x * (1.0 + x * (-2.0 + x));
    f[2] = (y1 - y0) / (h * h) * 60.0 * x * (1.0 + x * (-3.0 + 2.0 * x));
  }
}

/* piece k with t_k <= time < t_{k+1}; -1 before the first, n - 1 after the last */
static int piece(int np, const double p[np], int adr, int n, double time)
{
  int k;

  for (k = -1; k < n - 1; ++k)
    if (MAGGI_RE(time) < MAGGI_RE(p[adr + k + 1])) return k;
  return n - 1;
}

static void knots(int np, const double p[np], int adr, int n, double time, double f[3])
{
  int k;

  k = piece(np, p, adr, n, time);
  if (k < 0) k = 0;
  if (k > n - 2) k = n - 2;
  quintic(time, p[adr + k], p[adr + k + 1], p[adr + n + k], p[adr + n + k + 1], f);
}

static void spline_value(int np, const double p[np], int adr, int n, int madr, int nspline,
                         const double m[nspline][3], double time, double f[3])
{
  int k;
  double h, a, c, e, slope;

  k = piece(np, p, adr, n, time);
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

static void sine(double amplitude, double omega, double phase, double offset, double time,
                 double f[3])
{
  double s, c;

  s = sin(omega * time + phase);
  c = cos(omega * time + phase);
  f[0] = offset + amplitude * s;
  f[1] = amplitude * omega * c;
  f[2] = -amplitude * omega * omega * s;
}

/* of one function */
static void value(int kind, int np, const double p[np], int k, int n, int madr, int nspline,
                  const double m[nspline][3], double time, double f[3])
{
  if (kind == MAGGI_FUNCTION_CONSTANT) {
    f[0] = p[k];
    f[1] = 0.0;
    f[2] = 0.0;
  } else if (kind == MAGGI_FUNCTION_POLYNOMIAL) {
    polynomial(np, p, k, n, time, f);
  } else if (kind == MAGGI_FUNCTION_SINE) {
    sine(p[k], p[k + 1], p[k + 2], p[k + 3], time, f);
  } else if (kind == MAGGI_FUNCTION_STEP) {
    quintic(time, p[k], p[k + 1], p[k + 2], p[k + 3], f);
  } else if (kind == MAGGI_FUNCTION_KNOTS) {
    knots(np, p, k, n, time, f);
  } else {
    spline_value(np, p, k, n, madr, nspline, m, time, f);
  }
}

void maggi_functions(const maggi_topo *t, const double p[t->np],
                     const double spline0[t->nspline][3], double time, double fun[t->nfun][3])
{
  int i;
  double moves;
  double f[3];

  for (i = 0; i < t->nfun; ++i) {
    moves = t->funheld[i] ? 0.0 : 1.0;
    value(t->funkind[i], t->np, p, t->funadr[i], t->funn[i], t->funspline[i], t->nspline, spline0,
          time, f);
    fun[i][0] = f[0];
    fun[i][1] = moves * f[1];
    fun[i][2] = moves * f[2];
  }
}
