/* Tangent of core/kernel/filter.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

void maggi_filter_rates_d(const maggi_topo *t, const double p[restrict t->np],
                          const double pd[restrict t->np],
                          const double sensor[restrict t->nsensor][3],
                          const double sensord[restrict t->nsensor][3],
                          const double y[restrict t->nstate], const double yd[restrict t->nstate],
                          double yrate[restrict t->nstate], double yrated[restrict t->nstate])
{
  int adr, i, k, n2;
  double high, highd, inv, inv2, lowd, t2, t2d, t3, t3d, t3inv, t4, t4d, t5, t5d, u2d, u3d, ud, w,
      w2, w2d, w3, w3d, w4, w4d, w5, w5d, w6, w6d, w7, w7d, wd;

  (void)sensor;
  for (i = 0; i < t->nfilter; ++i) {
    adr = t->filteradr[i];
    k = t->filterstate[i];
    ud = sensord[t->filtersensor[i]][t->filtercolumn[i]];
    w = 6.283185307179586476925286766559 * p[adr];
    wd = 6.283185307179586476925286766559 * pd[adr];
    high = yrate[k + 1];
    highd = ud - ((wd * w + w * wd) * y[k] + w * w * yd[k]) - (wd / (1.0 /
        1.4142135623730950488016887242097) * y[k + 1] + w / (1.0 /
        1.4142135623730950488016887242097) * yd[k + 1]);
    yrated[k] = yd[k + 1];
    yrated[k + 1] = highd;
    yrated[k + 2] = yd[k + 3];
    w2 = 6.283185307179586476925286766559 * p[adr + 1];
    w2d = 6.283185307179586476925286766559 * pd[adr + 1];
    yrated[k + 3] = pd[t->filtergain[i]] * high + p[t->filtergain[i]] * highd - ((w2d * w2 + w2 *
        w2d) * y[k + 2] + w2 * w2 * yd[k + 2]) - (w2d / (1.0 / 1.4142135623730950488016887242097) *
        y[k + 3] + w2 / (1.0 / 1.4142135623730950488016887242097) * yd[k + 3]);
    n2 = k + 4;
    if (t->filterf4[i] >= 0) {
      w3 = 6.283185307179586476925286766559 * p[adr + 1];
      /* what the low pass of the filter with states from k on passes on */
      w3d = 6.283185307179586476925286766559 * pd[adr + 1];
      lowd = (w3d * w3 + w3 * w3d) * y[k + 2] + w3 * w3 * yd[k + 2];
      yrated[n2] = yd[n2 + 1];
      w4 = 6.283185307179586476925286766559 * p[t->filterf4[i]];
      w4d = 6.283185307179586476925286766559 * pd[t->filterf4[i]];
      t2 = w4 / p[t->filterf4[i] + 1];
      inv = 1.0 / p[t->filterf4[i] + 1];
      t2d = (w4d - t2 * pd[t->filterf4[i] + 1]) * inv;
      yrated[n2 + 1] = lowd - ((w4d * w4 + w4 * w4d) * y[n2] + w4 * w4 * yd[n2]) - (t2d * y[n2 + 1]
          + t2 * yd[n2 + 1]);
      n2 = n2 + 2;
    }
    if (t->filterf5[i] >= 0) {
      adr = t->filterf5[i];
      yrated[n2] = yd[n2 + 1];
      w5 = 6.283185307179586476925286766559 * p[adr + 2];
      w5d = 6.283185307179586476925286766559 * pd[adr + 2];
      /* what the sections before its step pass on */
      if (t->filterf4[i] >= 0) {
        w6 = 6.283185307179586476925286766559 * p[t->filterf4[i]];
        /* what its transition passes on; adr3: address of f_3, -1 if that is infinite */
        w6d = 6.283185307179586476925286766559 * pd[t->filterf4[i]];
        u3d = (w6d * w6 + w6 * w6d) * y[t->filterstate[i] + 4] + w6 * w6 * yd[t->filterstate[i] +
            4];
        if (t->filterf3[i] >= 0) {
          t3 = 6.283185307179586476925286766559 * p[t->filterf3[i]];
          t3d = 6.283185307179586476925286766559 * pd[t->filterf3[i]];
          t4 = w6 * w6 / t3;
          t3inv = 1.0 / t3;
          t4d = (w6d * w6 + w6 * w6d - t4 * t3d) * t3inv;
          u3d += t4d * y[t->filterstate[i] + 5] + t4 * yd[t->filterstate[i] + 5];
        }
        u2d = u3d;
      } else {
        w7 = 6.283185307179586476925286766559 * p[t->filteradr[i] + 1];
        /* what the low pass of the filter with states from k on passes on */
        w7d = 6.283185307179586476925286766559 * pd[t->filteradr[i] + 1];
        u2d = (w7d * w7 + w7 * w7d) * y[t->filterstate[i] + 2] + w7 * w7 * yd[t->filterstate[i] +
            2];
      }
      t5 = w5 / p[adr + 3];
      inv2 = 1.0 / p[adr + 3];
      t5d = (w5d - t5 * pd[adr + 3]) * inv2;
      yrated[n2 + 1] = u2d - ((w5d * w5 + w5 * w5d) * y[n2] + w5 * w5 * yd[n2]) - (t5d * y[n2 + 1] +
          t5 * yd[n2 + 1]);
    }
  }
}

void maggi_filter_outputs_d(const maggi_topo *t, const double p[restrict t->np],
                            const double pd[restrict t->np], const double y[restrict t->nstate],
                            const double yd[restrict t->nstate], double output[restrict t->nfilter],
                            double outputd[restrict t->nfilter])
{
  int adr, i, n2;
  double inv, inv2, t2, t2d, t2inv, t3, t3d, t4, t4d, t5, t5d, u2d, u3d, ud, w, w2, w2d, w5, w5d,
      w6, w6d, wd;

  (void)output;
  for (i = 0; i < t->nfilter; ++i) {
    /* what the sections before its step pass on */
    if (t->filterf4[i] >= 0) {
      w = 6.283185307179586476925286766559 * p[t->filterf4[i]];
      /* what its transition passes on; adr3: address of f_3, -1 if that is infinite */
      wd = 6.283185307179586476925286766559 * pd[t->filterf4[i]];
      u3d = (wd * w + w * wd) * y[t->filterstate[i] + 4] + w * w * yd[t->filterstate[i] + 4];
      if (t->filterf3[i] >= 0) {
        t2 = 6.283185307179586476925286766559 * p[t->filterf3[i]];
        t2d = 6.283185307179586476925286766559 * pd[t->filterf3[i]];
        t3 = w * w / t2;
        t2inv = 1.0 / t2;
        t3d = (wd * w + w * wd - t3 * t2d) * t2inv;
        u3d += t3d * y[t->filterstate[i] + 5] + t3 * yd[t->filterstate[i] + 5];
      }
      u2d = u3d;
    } else {
      w2 = 6.283185307179586476925286766559 * p[t->filteradr[i] + 1];
      /* what the low pass of the filter with states from k on passes on */
      w2d = 6.283185307179586476925286766559 * pd[t->filteradr[i] + 1];
      u2d = (w2d * w2 + w2 * w2d) * y[t->filterstate[i] + 2] + w2 * w2 * yd[t->filterstate[i] + 2];
    }
    ud = u2d;
    if (t->filterf5[i] >= 0) {
      adr = t->filterf5[i];
      n2 = t->filterstate[i] + (t->filterf4[i] >= 0 ? 6 : 4);
      w5 = 6.283185307179586476925286766559 * p[adr];
      w5d = 6.283185307179586476925286766559 * pd[adr];
      w6 = 6.283185307179586476925286766559 * p[adr + 2];
      w6d = 6.283185307179586476925286766559 * pd[adr + 2];
      t4 = w5 / p[adr + 1];
      inv = 1.0 / p[adr + 1];
      t4d = (w5d - t4 * pd[adr + 1]) * inv;
      t5 = w6 / p[adr + 3];
      inv2 = 1.0 / p[adr + 3];
      t5d = (w6d - t5 * pd[adr + 3]) * inv2;
      outputd[i] = ud + ((w5d * w5 + w5 * w5d - (w6d * w6 + w6 * w6d)) * y[n2] + (w5 * w5 - w6 * w6)
          * yd[n2]) + ((t4d - t5d) * y[n2 + 1] + (t4 - t5) * yd[n2 + 1]);
    } else {
      outputd[i] = ud;
    }
  }
}
