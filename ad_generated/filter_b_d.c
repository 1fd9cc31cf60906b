/* Tangent of the adjoint of core/kernel/filter.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "adStack.h"

void maggi_filter_rates_b_d(const maggi_topo *t, const double p[restrict t->np],
                            const double pd[restrict t->np], double pb[restrict t->np],
                            double pbd[restrict t->np], const double sensor[restrict t->nsensor][3],
                            const double sensord[restrict t->nsensor][3],
                            double sensorb[restrict t->nsensor][3],
                            double sensorbd[restrict t->nsensor][3],
                            const double y[restrict t->nstate], const double yd[restrict t->nstate],
                            double yb[restrict t->nstate], double ybd[restrict t->nstate],
                            double yrate[restrict t->nstate], double yrated[restrict t->nstate],
                            double yrateb[restrict t->nstate], double yratebd[restrict t->nstate])
{
  int adr, i, k, n2;
  double high, highb, highbd, highd, lowb, lowbd, t2, t2b, t2bd, t2d, t3, t3b, t3bd, t3d, t4, t4b,
      t4bd, t4d, t5, t5b, t5bd, t5d, tb10, tb10d, tb11, tb11d, tb12, tb12d, tb13, tb13d, tb14,
      tb14d, tb2, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d,
      u2b, u2bd, u3b, u3bd, ub, ubd, w, w2, w2b, w2bd, w2d, w3, w3b, w3bd, w3d, w4, w4b, w4bd, w4d,
      w5, w5b, w5bd, w5d, w6, w6b, w6bd, w6d, w7, w7b, w7bd, w7d, wb, wbd, wd;

  (void)sensor;
  (void)sensord;
  t2 = 0.0;
  t2d = 0.0;
  t3 = 0.0;
  t3d = 0.0;
  t4 = 0.0;
  t4d = 0.0;
  t5 = 0.0;
  t5d = 0.0;
  w3 = 0.0;
  w3d = 0.0;
  w4 = 0.0;
  w4d = 0.0;
  w5 = 0.0;
  w5d = 0.0;
  for (i = t->nfilter - 1; i >= 0; --i) {
    adr = t->filteradr[i];
    k = t->filterstate[i];
    w = 6.283185307179586476925286766559 * p[adr];
    wd = 6.283185307179586476925286766559 * pd[adr];
    high = yrate[k + 1];
    highd = yrated[k + 1];
    w2 = 6.283185307179586476925286766559 * p[adr + 1];
    w2d = 6.283185307179586476925286766559 * pd[adr + 1];
    n2 = k + 4;
    if (t->filterf4[i] >= 0) {
      w3 = 6.283185307179586476925286766559 * p[adr + 1];
      w3d = 6.283185307179586476925286766559 * pd[adr + 1];
      w4 = 6.283185307179586476925286766559 * p[t->filterf4[i]];
      w4d = 6.283185307179586476925286766559 * pd[t->filterf4[i]];
      t2 = w4 / p[t->filterf4[i] + 1];
      t2d = (w4d - t2 * pd[t->filterf4[i] + 1]) * (1.0 / p[t->filterf4[i] + 1]);
      pushInteger4(n2);
      n2 = n2 + 2;
    }
    if (t->filterf5[i] >= 0) {
      pushInteger4(adr);
      adr = t->filterf5[i];
      w5 = 6.283185307179586476925286766559 * p[adr + 2];
      w5d = 6.283185307179586476925286766559 * pd[adr + 2];
      t5 = w5 / p[adr + 3];
      t5d = (w5d - t5 * pd[adr + 3]) * (1.0 / p[adr + 3]);
    }
    t5b = 0.0;
    t5bd = 0.0;
    u2b = 0.0;
    u2bd = 0.0;
    w5b = 0.0;
    w5bd = 0.0;
    if (t->filterf5[i] >= 0) {
      tb13 = yrateb[n2 + 1];
      tb13d = yratebd[n2 + 1];
      yrateb[n2 + 1] = 0.0;
      yratebd[n2 + 1] = 0.0;
      u2b += tb13;
      u2bd += tb13d;
      tb14 = tb13 * y[n2];
      tb14d = tb13d * y[n2] + tb13 * yd[n2];
      w5b -= tb14 * w5;
      w5bd -= tb14d * w5 + tb14 * w5d;
      w5b -= tb14 * w5;
      w5bd -= tb14d * w5 + tb14 * w5d;
      yb[n2] -= tb13 * (w5 * w5);
      ybd[n2] -= tb13d * (w5 * w5) + tb13 * (w5d * w5 + w5 * w5d);
      t5b -= tb13 * y[n2 + 1];
      t5bd -= tb13d * y[n2 + 1] + tb13 * yd[n2 + 1];
      yb[n2 + 1] -= tb13 * t5;
      ybd[n2 + 1] -= tb13d * t5 + tb13 * t5d;
      tb12 = t5b / p[adr + 3];
      tb12d = (t5bd - tb12 * pd[adr + 3]) * (1.0 / p[adr + 3]);
      w5b += tb12;
      w5bd += tb12d;
      pb[adr + 3] -= tb12 * t5;
      pbd[adr + 3] -= tb12d * t5 + tb12 * t5d;
      /* what the sections before its step pass on */
      if (t->filterf4[i] >= 0) {
        w6 = 6.283185307179586476925286766559 * p[t->filterf4[i]];
        w6d = 6.283185307179586476925286766559 * pd[t->filterf4[i]];
        if (t->filterf3[i] >= 0) {
          t3 = 6.283185307179586476925286766559 * p[t->filterf3[i]];
          t3d = 6.283185307179586476925286766559 * pd[t->filterf3[i]];
          t4 = w6 * w6 / t3;
          t4d = (w6d * w6 + w6 * w6d - t4 * t3d) * (1.0 / t3);
        }
        u3b = u2b;
        u3bd = u2bd;
        u2b = 0.0;
        u2bd = 0.0;
        t3b = 0.0;
        t3bd = 0.0;
        t4b = 0.0;
        t4bd = 0.0;
        w6b = 0.0;
        w6bd = 0.0;
        if (t->filterf3[i] >= 0) {
          t4b += u3b * y[t->filterstate[i] + 5];
          t4bd += u3bd * y[t->filterstate[i] + 5] + u3b * yd[t->filterstate[i] + 5];
          yb[t->filterstate[i] + 5] += u3b * t4;
          ybd[t->filterstate[i] + 5] += u3bd * t4 + u3b * t4d;
          tb10 = t4b / t3;
          tb10d = (t4bd - tb10 * t3d) * (1.0 / t3);
          w6b += tb10 * w6;
          w6bd += tb10d * w6 + tb10 * w6d;
          w6b += tb10 * w6;
          w6bd += tb10d * w6 + tb10 * w6d;
          t3b -= tb10 * t4;
          t3bd -= tb10d * t4 + tb10 * t4d;
          pb[t->filterf3[i]] += t3b * 6.283185307179586476925286766559;
          pbd[t->filterf3[i]] += t3bd * 6.283185307179586476925286766559;
        }
        tb9 = u3b * y[t->filterstate[i] + 4];
        tb9d = u3bd * y[t->filterstate[i] + 4] + u3b * yd[t->filterstate[i] + 4];
        w6b += tb9 * w6;
        w6bd += tb9d * w6 + tb9 * w6d;
        w6b += tb9 * w6;
        w6bd += tb9d * w6 + tb9 * w6d;
        yb[t->filterstate[i] + 4] += u3b * (w6 * w6);
        ybd[t->filterstate[i] + 4] += u3bd * (w6 * w6) + u3b * (w6d * w6 + w6 * w6d);
        u3b = 0.0;
        u3bd = 0.0;
        pb[t->filterf4[i]] += w6b * 6.283185307179586476925286766559;
        /* what its transition passes on; adr3: address of f_3, -1 if that is infinite */
        pbd[t->filterf4[i]] += w6bd * 6.283185307179586476925286766559;
      } else {
        w7 = 6.283185307179586476925286766559 * p[t->filteradr[i] + 1];
        w7d = 6.283185307179586476925286766559 * pd[t->filteradr[i] + 1];
        tb11 = u2b * y[t->filterstate[i] + 2];
        tb11d = u2bd * y[t->filterstate[i] + 2] + u2b * yd[t->filterstate[i] + 2];
        w7b = tb11 * w7;
        w7bd = tb11d * w7 + tb11 * w7d;
        w7b += tb11 * w7;
        w7bd += tb11d * w7 + tb11 * w7d;
        yb[t->filterstate[i] + 2] += u2b * (w7 * w7);
        ybd[t->filterstate[i] + 2] += u2bd * (w7 * w7) + u2b * (w7d * w7 + w7 * w7d);
        u2b = 0.0;
        u2bd = 0.0;
        pb[t->filteradr[i] + 1] += w7b * 6.283185307179586476925286766559;
        /* what the low pass of the filter with states from k on passes on */
        pbd[t->filteradr[i] + 1] += w7bd * 6.283185307179586476925286766559;
      }
      pb[adr + 2] += w5b * 6.283185307179586476925286766559;
      pbd[adr + 2] += w5bd * 6.283185307179586476925286766559;
      yb[n2 + 1] += yrateb[n2];
      ybd[n2 + 1] += yratebd[n2];
      yrateb[n2] = 0.0;
      yratebd[n2] = 0.0;
      popInteger4(&adr);
    }
    lowb = 0.0;
    lowbd = 0.0;
    t2b = 0.0;
    t2bd = 0.0;
    w3b = 0.0;
    w3bd = 0.0;
    w4b = 0.0;
    w4bd = 0.0;
    if (t->filterf4[i] >= 0) {
      popInteger4(&n2);
      tb7 = yrateb[n2 + 1];
      tb7d = yratebd[n2 + 1];
      yrateb[n2 + 1] = 0.0;
      yratebd[n2 + 1] = 0.0;
      lowb += tb7;
      lowbd += tb7d;
      tb8 = tb7 * y[n2];
      tb8d = tb7d * y[n2] + tb7 * yd[n2];
      w4b -= tb8 * w4;
      w4bd -= tb8d * w4 + tb8 * w4d;
      w4b -= tb8 * w4;
      w4bd -= tb8d * w4 + tb8 * w4d;
      yb[n2] -= tb7 * (w4 * w4);
      ybd[n2] -= tb7d * (w4 * w4) + tb7 * (w4d * w4 + w4 * w4d);
      t2b -= tb7 * y[n2 + 1];
      t2bd -= tb7d * y[n2 + 1] + tb7 * yd[n2 + 1];
      yb[n2 + 1] -= tb7 * t2;
      ybd[n2 + 1] -= tb7d * t2 + tb7 * t2d;
      tb6 = t2b / p[t->filterf4[i] + 1];
      tb6d = (t2bd - tb6 * pd[t->filterf4[i] + 1]) * (1.0 / p[t->filterf4[i] + 1]);
      w4b += tb6;
      w4bd += tb6d;
      pb[t->filterf4[i] + 1] -= tb6 * t2;
      pbd[t->filterf4[i] + 1] -= tb6d * t2 + tb6 * t2d;
      pb[t->filterf4[i]] += w4b * 6.283185307179586476925286766559;
      pbd[t->filterf4[i]] += w4bd * 6.283185307179586476925286766559;
      yb[n2 + 1] += yrateb[n2];
      ybd[n2 + 1] += yratebd[n2];
      yrateb[n2] = 0.0;
      yratebd[n2] = 0.0;
      tb5 = lowb * y[k + 2];
      tb5d = lowbd * y[k + 2] + lowb * yd[k + 2];
      w3b += tb5 * w3;
      w3bd += tb5d * w3 + tb5 * w3d;
      w3b += tb5 * w3;
      w3bd += tb5d * w3 + tb5 * w3d;
      yb[k + 2] += lowb * (w3 * w3);
      ybd[k + 2] += lowbd * (w3 * w3) + lowb * (w3d * w3 + w3 * w3d);
      pb[adr + 1] += w3b * 6.283185307179586476925286766559;
      /* what the low pass of the filter with states from k on passes on */
      pbd[adr + 1] += w3bd * 6.283185307179586476925286766559;
    }
    tb3 = yrateb[k + 3];
    tb3d = yratebd[k + 3];
    yrateb[k + 3] = 0.0;
    yratebd[k + 3] = 0.0;
    pb[t->filtergain[i]] += tb3 * high;
    pbd[t->filtergain[i]] += tb3d * high + tb3 * highd;
    highb = tb3 * p[t->filtergain[i]];
    highbd = tb3d * p[t->filtergain[i]] + tb3 * pd[t->filtergain[i]];
    tb4 = tb3 * y[k + 2];
    tb4d = tb3d * y[k + 2] + tb3 * yd[k + 2];
    w2b = -(tb4 * w2);
    w2bd = -(tb4d * w2 + tb4 * w2d);
    w2b -= tb4 * w2;
    w2bd -= tb4d * w2 + tb4 * w2d;
    yb[k + 2] -= tb3 * (w2 * w2);
    ybd[k + 2] -= tb3d * (w2 * w2) + tb3 * (w2d * w2 + w2 * w2d);
    w2b -= tb3 * y[k + 3] / (1.0 / 1.4142135623730950488016887242097);
    w2bd -= (tb3d * y[k + 3] + tb3 * yd[k + 3]) / (1.0 / 1.4142135623730950488016887242097);
    yb[k + 3] -= tb3 * (w2 / (1.0 / 1.4142135623730950488016887242097));
    ybd[k + 3] -= tb3d * (w2 / (1.0 / 1.4142135623730950488016887242097)) + tb3 * (w2d / (1.0 /
        1.4142135623730950488016887242097));
    pb[adr + 1] += w2b * 6.283185307179586476925286766559;
    pbd[adr + 1] += w2bd * 6.283185307179586476925286766559;
    yb[k + 3] += yrateb[k + 2];
    ybd[k + 3] += yratebd[k + 2];
    yrateb[k + 2] = 0.0;
    yratebd[k + 2] = 0.0;
    highb += yrateb[k + 1];
    highbd += yratebd[k + 1];
    yrateb[k + 1] = 0.0;
    yratebd[k + 1] = 0.0;
    yb[k + 1] += yrateb[k];
    ybd[k + 1] += yratebd[k];
    yrateb[k] = 0.0;
    yratebd[k] = 0.0;
    ub = highb;
    ubd = highbd;
    tb2 = highb * y[k];
    tb2d = highbd * y[k] + highb * yd[k];
    wb = -(tb2 * w);
    wbd = -(tb2d * w + tb2 * wd);
    wb -= tb2 * w;
    wbd -= tb2d * w + tb2 * wd;
    yb[k] -= highb * (w * w);
    ybd[k] -= highbd * (w * w) + highb * (wd * w + w * wd);
    wb -= highb * y[k + 1] / (1.0 / 1.4142135623730950488016887242097);
    wbd -= (highbd * y[k + 1] + highb * yd[k + 1]) / (1.0 / 1.4142135623730950488016887242097);
    yb[k + 1] -= highb * (w / (1.0 / 1.4142135623730950488016887242097));
    ybd[k + 1] -= highbd * (w / (1.0 / 1.4142135623730950488016887242097)) + highb * (wd / (1.0 /
        1.4142135623730950488016887242097));
    pb[adr] += wb * 6.283185307179586476925286766559;
    pbd[adr] += wbd * 6.283185307179586476925286766559;
    sensorb[t->filtersensor[i]][t->filtercolumn[i]] += ub;
    sensorbd[t->filtersensor[i]][t->filtercolumn[i]] += ubd;
  }
}

void maggi_filter_outputs_b_d(const maggi_topo *t, const double p[restrict t->np],
                              const double pd[restrict t->np], double pb[restrict t->np],
                              double pbd[restrict t->np], const double y[restrict t->nstate],
                              const double yd[restrict t->nstate], double yb[restrict t->nstate],
                              double ybd[restrict t->nstate], double output[restrict t->nfilter],
                              double outputd[restrict t->nfilter],
                              double outputb[restrict t->nfilter],
                              double outputbd[restrict t->nfilter])
{
  int adr, i, n2;
  double t2, t2b, t2bd, t2d, t3, t3b, t3bd, t3d, t4, t4b, t4bd, t4d, t5, t5b, t5bd, t5d, tb2, tb2d,
      tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d, u2b, u2bd, u3b,
      u3bd, ub, ubd, w, w2, w2b, w2bd, w2d, w5, w5b, w5bd, w5d, w6, w6b, w6bd, w6d, wb, wbd, wd;

  (void)output;
  (void)outputd;
  t2 = 0.0;
  t2d = 0.0;
  t3 = 0.0;
  t3d = 0.0;
  for (i = t->nfilter - 1; i >= 0; --i) {
    ub = 0.0;
    ubd = 0.0;
    if (t->filterf5[i] >= 0) {
      adr = t->filterf5[i];
      n2 = t->filterstate[i] + (t->filterf4[i] >= 0 ? 6 : 4);
      w5 = 6.283185307179586476925286766559 * p[adr];
      w5d = 6.283185307179586476925286766559 * pd[adr];
      w6 = 6.283185307179586476925286766559 * p[adr + 2];
      w6d = 6.283185307179586476925286766559 * pd[adr + 2];
      t4 = w5 / p[adr + 1];
      t4d = (w5d - t4 * pd[adr + 1]) * (1.0 / p[adr + 1]);
      t5 = w6 / p[adr + 3];
      t5d = (w6d - t5 * pd[adr + 3]) * (1.0 / p[adr + 3]);
      tb7 = outputb[i];
      tb7d = outputbd[i];
      outputb[i] = 0.0;
      outputbd[i] = 0.0;
      ub += tb7;
      ubd += tb7d;
      tb8 = tb7 * y[n2];
      tb8d = tb7d * y[n2] + tb7 * yd[n2];
      w5b = tb8 * w5;
      w5bd = tb8d * w5 + tb8 * w5d;
      w5b += tb8 * w5;
      w5bd += tb8d * w5 + tb8 * w5d;
      w6b = -(tb8 * w6);
      w6bd = -(tb8d * w6 + tb8 * w6d);
      w6b -= tb8 * w6;
      w6bd -= tb8d * w6 + tb8 * w6d;
      yb[n2] += tb7 * (w5 * w5 - w6 * w6);
      ybd[n2] += tb7d * (w5 * w5 - w6 * w6) + tb7 * (w5d * w5 + w5 * w5d - (w6d * w6 + w6 * w6d));
      tb9 = tb7 * y[n2 + 1];
      tb9d = tb7d * y[n2 + 1] + tb7 * yd[n2 + 1];
      t4b = tb9;
      t4bd = tb9d;
      t5b = -tb9;
      t5bd = -tb9d;
      yb[n2 + 1] += tb7 * (t4 - t5);
      ybd[n2 + 1] += tb7d * (t4 - t5) + tb7 * (t4d - t5d);
      tb6 = t5b / p[adr + 3];
      tb6d = (t5bd - tb6 * pd[adr + 3]) * (1.0 / p[adr + 3]);
      w6b += tb6;
      w6bd += tb6d;
      pb[adr + 3] -= tb6 * t5;
      pbd[adr + 3] -= tb6d * t5 + tb6 * t5d;
      tb5 = t4b / p[adr + 1];
      tb5d = (t4bd - tb5 * pd[adr + 1]) * (1.0 / p[adr + 1]);
      w5b += tb5;
      w5bd += tb5d;
      pb[adr + 1] -= tb5 * t4;
      pbd[adr + 1] -= tb5d * t4 + tb5 * t4d;
      pb[adr + 2] += w6b * 6.283185307179586476925286766559;
      pbd[adr + 2] += w6bd * 6.283185307179586476925286766559;
      pb[adr] += w5b * 6.283185307179586476925286766559;
      pbd[adr] += w5bd * 6.283185307179586476925286766559;
    } else {
      ub += outputb[i];
      ubd += outputbd[i];
      outputb[i] = 0.0;
      outputbd[i] = 0.0;
    }
    u2b = ub;
    u2bd = ubd;
    /* what the sections before its step pass on */
    if (t->filterf4[i] >= 0) {
      w = 6.283185307179586476925286766559 * p[t->filterf4[i]];
      wd = 6.283185307179586476925286766559 * pd[t->filterf4[i]];
      if (t->filterf3[i] >= 0) {
        t2 = 6.283185307179586476925286766559 * p[t->filterf3[i]];
        t2d = 6.283185307179586476925286766559 * pd[t->filterf3[i]];
        t3 = w * w / t2;
        t3d = (wd * w + w * wd - t3 * t2d) * (1.0 / t2);
      }
      u3b = u2b;
      u3bd = u2bd;
      u2b = 0.0;
      u2bd = 0.0;
      t2b = 0.0;
      t2bd = 0.0;
      t3b = 0.0;
      t3bd = 0.0;
      wb = 0.0;
      wbd = 0.0;
      if (t->filterf3[i] >= 0) {
        t3b += u3b * y[t->filterstate[i] + 5];
        t3bd += u3bd * y[t->filterstate[i] + 5] + u3b * yd[t->filterstate[i] + 5];
        yb[t->filterstate[i] + 5] += u3b * t3;
        ybd[t->filterstate[i] + 5] += u3bd * t3 + u3b * t3d;
        tb3 = t3b / t2;
        tb3d = (t3bd - tb3 * t2d) * (1.0 / t2);
        wb += tb3 * w;
        wbd += tb3d * w + tb3 * wd;
        wb += tb3 * w;
        wbd += tb3d * w + tb3 * wd;
        t2b -= tb3 * t3;
        t2bd -= tb3d * t3 + tb3 * t3d;
        pb[t->filterf3[i]] += t2b * 6.283185307179586476925286766559;
        pbd[t->filterf3[i]] += t2bd * 6.283185307179586476925286766559;
      }
      tb2 = u3b * y[t->filterstate[i] + 4];
      tb2d = u3bd * y[t->filterstate[i] + 4] + u3b * yd[t->filterstate[i] + 4];
      wb += tb2 * w;
      wbd += tb2d * w + tb2 * wd;
      wb += tb2 * w;
      wbd += tb2d * w + tb2 * wd;
      yb[t->filterstate[i] + 4] += u3b * (w * w);
      ybd[t->filterstate[i] + 4] += u3bd * (w * w) + u3b * (wd * w + w * wd);
      u3b = 0.0;
      u3bd = 0.0;
      pb[t->filterf4[i]] += wb * 6.283185307179586476925286766559;
      /* what its transition passes on; adr3: address of f_3, -1 if that is infinite */
      pbd[t->filterf4[i]] += wbd * 6.283185307179586476925286766559;
    } else {
      w2 = 6.283185307179586476925286766559 * p[t->filteradr[i] + 1];
      w2d = 6.283185307179586476925286766559 * pd[t->filteradr[i] + 1];
      tb4 = u2b * y[t->filterstate[i] + 2];
      tb4d = u2bd * y[t->filterstate[i] + 2] + u2b * yd[t->filterstate[i] + 2];
      w2b = tb4 * w2;
      w2bd = tb4d * w2 + tb4 * w2d;
      w2b += tb4 * w2;
      w2bd += tb4d * w2 + tb4 * w2d;
      yb[t->filterstate[i] + 2] += u2b * (w2 * w2);
      ybd[t->filterstate[i] + 2] += u2bd * (w2 * w2) + u2b * (w2d * w2 + w2 * w2d);
      u2b = 0.0;
      u2bd = 0.0;
      pb[t->filteradr[i] + 1] += w2b * 6.283185307179586476925286766559;
      /* what the low pass of the filter with states from k on passes on */
      pbd[t->filteradr[i] + 1] += w2bd * 6.283185307179586476925286766559;
    }
  }
}
