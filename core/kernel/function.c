/* Functions of time with their first and second derivatives: fun = (s, s', s''). */
#include "kernel.h"
#include "maggi/maggi.h"

void maggi_spline_constants(const maggi_topo *t, const double p[t->np],
                            double spline0[t->nspline][3])
{
  int i;

  for (i = 0; i < t->nfun; ++i)
    if (t->funkind[i] == MAGGI_FUNCTION_SPLINE)
      maggi_spline(t->np, p, t->funadr[i], t->funn[i], t->funspline[i], t->nspline, spline0);
  for (i = 0; i < t->nroad; ++i)
    if (t->roadkind[i] == MAGGI_ROAD_PROFILE)
      maggi_spline(t->np, p, t->roadadr[i], t->roadn[i], t->roadspline[i], t->nspline, spline0);
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

/* y0, then its rate rises as a quintic step, h x^4 (5/2 - 3 x + x^2), then it is straight */
static void ramp(double time, double t0, double t1, double y0, double rate, double f[3])
{
  double h, x;

  h = t1 - t0;
  x = (time - t0) / h;
  if (MAGGI_RE(time) <= MAGGI_RE(t0)) {
    f[0] = y0;
    f[1] = 0.0;
    f[2] = 0.0;
  } else if (MAGGI_RE(time) >= MAGGI_RE(t1)) {
    f[0] = y0 + rate * (time - 0.5 * (t0 + t1));
    f[1] = rate;
    f[2] = 0.0;
  } else {
    f[0] = y0 + rate * h * x * x * x * x * (2.5 + x * (-3.0 + x));
    f[1] = rate * x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
    f[2] = rate / h * 30.0 * x * x * (1.0 + x * (-2.0 + x));
  }
}

static void knots(int np, const double p[np], int adr, int n, double time, double f[3])
{
  int k;

  k = maggi_piece(np, p, adr, n, time);
  if (k < 0) k = 0;
  if (k > n - 2) k = n - 2;
  quintic(time, p[adr + k], p[adr + k + 1], p[adr + n + k], p[adr + n + k + 1], f);
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
  } else if (kind == MAGGI_FUNCTION_RAMP) {
    ramp(time, p[k], p[k + 1], p[k + 2], p[k + 3], f);
  } else {
    maggi_spline_value(np, p, k, n, madr, nspline, m, time, f);
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
