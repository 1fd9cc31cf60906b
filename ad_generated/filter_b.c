/* Adjoint of core/kernel/filter.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "adStack.h"

void maggi_filter_rates_b(const maggi_topo *t, const double p[restrict t->np],
                          double pb[restrict t->np], const double sensor[restrict t->nsensor][3],
                          double sensorb[restrict t->nsensor][3],
                          const double y[restrict t->nstate], double yb[restrict t->nstate],
                          double yrate[restrict t->nstate], double yrateb[restrict t->nstate])
{
  int adr, i, k, n2;
  double high, highb, lowb, t2, t2b, t3, t3b, t4, t4b, t5, t5b, tb10, tb11, tb12, tb13, tb14, tb2,
      tb3, tb4, tb5, tb6, tb7, tb8, tb9, u2b, u3b, ub, w, w2, w2b, w3, w3b, w4, w4b, w5, w5b, w6,
      w6b, w7, w7b, wb;

  (void)sensor;
  t2 = 0.0;
  t3 = 0.0;
  t4 = 0.0;
  t5 = 0.0;
  w3 = 0.0;
  w4 = 0.0;
  w5 = 0.0;
  for (i = t->nfilter - 1; i >= 0; --i) {
    adr = t->filteradr[i];
    k = t->filterstate[i];
    w = 6.283185307179586476925286766559 * p[adr];
    high = yrate[k + 1];
    w2 = 6.283185307179586476925286766559 * p[adr + 1];
    n2 = k + 4;
    if (t->filterf4[i] >= 0) {
      w3 = 6.283185307179586476925286766559 * p[adr + 1];
      w4 = 6.283185307179586476925286766559 * p[t->filterf4[i]];
      t2 = w4 / p[t->filterf4[i] + 1];
      pushInteger4(n2);
      n2 = n2 + 2;
    }
    if (t->filterf5[i] >= 0) {
      pushInteger4(adr);
      adr = t->filterf5[i];
      w5 = 6.283185307179586476925286766559 * p[adr + 2];
      t5 = w5 / p[adr + 3];
    }
    t5b = 0.0;
    u2b = 0.0;
    w5b = 0.0;
    if (t->filterf5[i] >= 0) {
      tb13 = yrateb[n2 + 1];
      yrateb[n2 + 1] = 0.0;
      u2b += tb13;
      tb14 = tb13 * y[n2];
      w5b -= tb14 * w5;
      w5b -= tb14 * w5;
      yb[n2] -= tb13 * (w5 * w5);
      t5b -= tb13 * y[n2 + 1];
      yb[n2 + 1] -= tb13 * t5;
      tb12 = t5b / p[adr + 3];
      w5b += tb12;
      pb[adr + 3] -= tb12 * t5;
      /* what the sections before its step pass on */
      if (t->filterf4[i] >= 0) {
        w6 = 6.283185307179586476925286766559 * p[t->filterf4[i]];
        if (t->filterf3[i] >= 0) {
          t3 = 6.283185307179586476925286766559 * p[t->filterf3[i]];
          t4 = w6 * w6 / t3;
        }
        u3b = u2b;
        u2b = 0.0;
        t3b = 0.0;
        t4b = 0.0;
        w6b = 0.0;
        if (t->filterf3[i] >= 0) {
          t4b += u3b * y[t->filterstate[i] + 5];
          yb[t->filterstate[i] + 5] += u3b * t4;
          tb10 = t4b / t3;
          w6b += tb10 * w6;
          w6b += tb10 * w6;
          t3b -= tb10 * t4;
          pb[t->filterf3[i]] += t3b * 6.283185307179586476925286766559;
        }
        tb9 = u3b * y[t->filterstate[i] + 4];
        w6b += tb9 * w6;
        w6b += tb9 * w6;
        yb[t->filterstate[i] + 4] += u3b * (w6 * w6);
        u3b = 0.0;
        /* what its transition passes on; adr3: address of f_3, -1 if that is infinite */
        pb[t->filterf4[i]] += w6b * 6.283185307179586476925286766559;
      } else {
        w7 = 6.283185307179586476925286766559 * p[t->filteradr[i] + 1];
        tb11 = u2b * y[t->filterstate[i] + 2];
        w7b = tb11 * w7;
        w7b += tb11 * w7;
        yb[t->filterstate[i] + 2] += u2b * (w7 * w7);
        u2b = 0.0;
        /* what the low pass of the filter with states from k on passes on */
        pb[t->filteradr[i] + 1] += w7b * 6.283185307179586476925286766559;
      }
      pb[adr + 2] += w5b * 6.283185307179586476925286766559;
      yb[n2 + 1] += yrateb[n2];
      yrateb[n2] = 0.0;
      popInteger4(&adr);
    }
    lowb = 0.0;
    t2b = 0.0;
    w3b = 0.0;
    w4b = 0.0;
    if (t->filterf4[i] >= 0) {
      popInteger4(&n2);
      tb7 = yrateb[n2 + 1];
      yrateb[n2 + 1] = 0.0;
      lowb += tb7;
      tb8 = tb7 * y[n2];
      w4b -= tb8 * w4;
      w4b -= tb8 * w4;
      yb[n2] -= tb7 * (w4 * w4);
      t2b -= tb7 * y[n2 + 1];
      yb[n2 + 1] -= tb7 * t2;
      tb6 = t2b / p[t->filterf4[i] + 1];
      w4b += tb6;
      pb[t->filterf4[i] + 1] -= tb6 * t2;
      pb[t->filterf4[i]] += w4b * 6.283185307179586476925286766559;
      yb[n2 + 1] += yrateb[n2];
      yrateb[n2] = 0.0;
      tb5 = lowb * y[k + 2];
      w3b += tb5 * w3;
      w3b += tb5 * w3;
      yb[k + 2] += lowb * (w3 * w3);
      /* what the low pass of the filter with states from k on passes on */
      pb[adr + 1] += w3b * 6.283185307179586476925286766559;
    }
    tb3 = yrateb[k + 3];
    yrateb[k + 3] = 0.0;
    pb[t->filtergain[i]] += tb3 * high;
    highb = tb3 * p[t->filtergain[i]];
    tb4 = tb3 * y[k + 2];
    w2b = -(tb4 * w2);
    w2b -= tb4 * w2;
    yb[k + 2] -= tb3 * (w2 * w2);
    w2b -= tb3 * y[k + 3] / (1.0 / 1.4142135623730950488016887242097);
    yb[k + 3] -= tb3 * (w2 / (1.0 / 1.4142135623730950488016887242097));
    pb[adr + 1] += w2b * 6.283185307179586476925286766559;
    yb[k + 3] += yrateb[k + 2];
    yrateb[k + 2] = 0.0;
    highb += yrateb[k + 1];
    yrateb[k + 1] = 0.0;
    yb[k + 1] += yrateb[k];
    yrateb[k] = 0.0;
    ub = highb;
    tb2 = highb * y[k];
    wb = -(tb2 * w);
    wb -= tb2 * w;
    yb[k] -= highb * (w * w);
    wb -= highb * y[k + 1] / (1.0 / 1.4142135623730950488016887242097);
    yb[k + 1] -= highb * (w / (1.0 / 1.4142135623730950488016887242097));
    pb[adr] += wb * 6.283185307179586476925286766559;
    sensorb[t->filtersensor[i]][t->filtercolumn[i]] += ub;
  }
}

void maggi_filter_outputs_b(const maggi_topo *t, const double p[restrict t->np],
                            double pb[restrict t->np], const double y[restrict t->nstate],
                            double yb[restrict t->nstate], double output[restrict t->nfilter],
                            double outputb[restrict t->nfilter])
{
  int adr, i, n2;
  double t2, t2b, t3, t3b, t4, t4b, t5, t5b, tb2, tb3, tb4, tb5, tb6, tb7, tb8, tb9, u2b, u3b, ub,
      w, w2, w2b, w5, w5b, w6, w6b, wb;

  (void)output;
  t2 = 0.0;
  t3 = 0.0;
  for (i = t->nfilter - 1; i >= 0; --i) {
    ub = 0.0;
    if (t->filterf5[i] >= 0) {
      adr = t->filterf5[i];
      n2 = t->filterstate[i] + (t->filterf4[i] >= 0 ? 6 : 4);
      w5 = 6.283185307179586476925286766559 * p[adr];
      w6 = 6.283185307179586476925286766559 * p[adr + 2];
      t4 = w5 / p[adr + 1];
      t5 = w6 / p[adr + 3];
      tb7 = outputb[i];
      outputb[i] = 0.0;
      ub += tb7;
      tb8 = tb7 * y[n2];
      w5b = tb8 * w5;
      w5b += tb8 * w5;
      w6b = -(tb8 * w6);
      w6b -= tb8 * w6;
      yb[n2] += tb7 * (w5 * w5 - w6 * w6);
      tb9 = tb7 * y[n2 + 1];
      t4b = tb9;
      t5b = -tb9;
      yb[n2 + 1] += tb7 * (t4 - t5);
      tb6 = t5b / p[adr + 3];
      w6b += tb6;
      pb[adr + 3] -= tb6 * t5;
      tb5 = t4b / p[adr + 1];
      w5b += tb5;
      pb[adr + 1] -= tb5 * t4;
      pb[adr + 2] += w6b * 6.283185307179586476925286766559;
      pb[adr] += w5b * 6.283185307179586476925286766559;
    } else {
      ub += outputb[i];
      outputb[i] = 0.0;
    }
    u2b = ub;
    /* what the sections before its step pass on */
    if (t->filterf4[i] >= 0) {
      w = 6.283185307179586476925286766559 * p[t->filterf4[i]];
      if (t->filterf3[i] >= 0) {
        t2 = 6.283185307179586476925286766559 * p[t->filterf3[i]];
        t3 = w * w / t2;
      }
      u3b = u2b;
      u2b = 0.0;
      t2b = 0.0;
      t3b = 0.0;
      wb = 0.0;
      if (t->filterf3[i] >= 0) {
        t3b += u3b * y[t->filterstate[i] + 5];
        yb[t->filterstate[i] + 5] += u3b * t3;
        tb3 = t3b / t2;
        wb += tb3 * w;
        wb += tb3 * w;
        t2b -= tb3 * t3;
        pb[t->filterf3[i]] += t2b * 6.283185307179586476925286766559;
      }
      tb2 = u3b * y[t->filterstate[i] + 4];
      wb += tb2 * w;
      wb += tb2 * w;
      yb[t->filterstate[i] + 4] += u3b * (w * w);
      u3b = 0.0;
      /* what its transition passes on; adr3: address of f_3, -1 if that is infinite */
      pb[t->filterf4[i]] += wb * 6.283185307179586476925286766559;
    } else {
      w2 = 6.283185307179586476925286766559 * p[t->filteradr[i] + 1];
      tb4 = u2b * y[t->filterstate[i] + 2];
      w2b = tb4 * w2;
      w2b += tb4 * w2;
      yb[t->filterstate[i] + 2] += u2b * (w2 * w2);
      u2b = 0.0;
      /* what the low pass of the filter with states from k on passes on */
      pb[t->filteradr[i] + 1] += w2b * 6.283185307179586476925286766559;
    }
  }
}
