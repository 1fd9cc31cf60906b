/* Frequency weightings of vibration as filters y' = A y + B s, w = C y of a column s of a sensor.
 *
 *   H = gain H_h H_l H_t H_s,  w_k = 2 pi f_k,  q_1 = q_2 = 1/sqrt(2)      ISO 8041-1, ISO 2631-1 annex A
 *
 *   H_h = s^2 / (s^2 + w_1/q_1 s + w_1^2)                                 high pass
 *   H_l = w_2^2 / (s^2 + w_2/q_2 s + w_2^2)                               low pass
 *   H_t = w_4^2 (1 + s/w_3) / (s^2 + w_4/q_4 s + w_4^2)                   transition, 1 if f_4 is infinite
 *   H_s = (s^2 + w_5/q_5 s + w_5^2) / (s^2 + w_6/q_6 s + w_6^2)           upward step, 1 if f_5 is
 *
 * A section has the states (y, y') of y'' + w/q y' + w^2 y = u with the section before it as u; what it
 * passes on is a sum of u, y and y'.  Nothing goes back: filters do not act on the mechanism. */
#include "kernel.h"

#define TWO_PI      6.283185307179586476925286766559
#define BUTTERWORTH 1.4142135623730950488016887242097

/* y'' of a section */
static double bend(double w, double q, double u, int nstate, const double y[nstate], int k)
{
  return u - w * w * y[k] - w / q * y[k + 1];
}

/* what the low pass of the filter with states from k on passes on */
static double low_pass(int adr, int np, const double p[np], int nstate, const double y[nstate],
                       int k)
{
  double w;

  w = TWO_PI * p[adr + 1];
  return w * w * y[k + 2];
}

/* what its transition passes on; adr3: address of f_3, -1 if that is infinite */
static double transition(int adr3, int adr4, int np, const double p[np], int nstate,
                         const double y[nstate], int k)
{
  double w, u;

  w = TWO_PI * p[adr4];
  u = w * w * y[k];
  if (adr3 >= 0) u += w * w / (TWO_PI * p[adr3]) * y[k + 1];
  return u;
}

/* what the sections before its step pass on */
static double before_step(const maggi_topo *t, int i, int np, const double p[np], int nstate,
                          const double y[nstate])
{
  double u;

  if (t->filterf4[i] >= 0)
    u = transition(t->filterf3[i], t->filterf4[i], np, p, nstate, y, t->filterstate[i] + 4);
  else
    u = low_pass(t->filteradr[i], np, p, nstate, y, t->filterstate[i]);
  return u;
}

void maggi_filter_rates(const maggi_topo *t, const double p[t->np],
                        const double sensor[t->nsensor][3], const double y[t->nstate],
                        double yrate[t->nstate])
{
  int i, k, n, adr;
  double u, high, low;

  for (i = 0; i < t->nfilter; ++i) {
    adr = t->filteradr[i];
    k = t->filterstate[i];
    u = sensor[t->filtersensor[i]][t->filtercolumn[i]];
    high = bend(TWO_PI * p[adr], 1.0 / BUTTERWORTH, u, t->nstate, y, k);
    yrate[k] = y[k + 1];
    yrate[k + 1] = high;
    yrate[k + 2] = y[k + 3];
    yrate[k + 3] = bend(TWO_PI * p[adr + 1], 1.0 / BUTTERWORTH, p[t->filtergain[i]] * high,
                        t->nstate, y, k + 2);
    n = k + 4;
    if (t->filterf4[i] >= 0) {
      low = low_pass(adr, t->np, p, t->nstate, y, k);
      yrate[n] = y[n + 1];
      yrate[n + 1] = bend(TWO_PI * p[t->filterf4[i]], p[t->filterf4[i] + 1], low, t->nstate, y, n);
      n = n + 2;
    }
    if (t->filterf5[i] >= 0) {
      adr = t->filterf5[i];
      yrate[n] = y[n + 1];
      yrate[n + 1] = bend(TWO_PI * p[adr + 2], p[adr + 3],
                          before_step(t, i, t->np, p, t->nstate, y), t->nstate, y, n);
    }
  }
}

void maggi_filter_outputs(const maggi_topo *t, const double p[t->np], const double y[t->nstate],
                          double output[t->nfilter])
{
  int i, n, adr;
  double u, w5, w6;

  for (i = 0; i < t->nfilter; ++i) {
    u = before_step(t, i, t->np, p, t->nstate, y);
    if (t->filterf5[i] >= 0) {
      adr = t->filterf5[i];
      n = t->filterstate[i] + (t->filterf4[i] >= 0 ? 6 : 4);
      w5 = TWO_PI * p[adr];
      w6 = TWO_PI * p[adr + 2];
      output[i] = u + (w5 * w5 - w6 * w6) * y[n] + (w5 / p[adr + 1] - w6 / p[adr + 3]) * y[n + 1];
    } else {
      output[i] = u;
    }
  }
}
