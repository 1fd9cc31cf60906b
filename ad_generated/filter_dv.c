/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/filter.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

void maggi_filter_rates_dv(const maggi_topo *t, const double p[restrict t->np],
                           const double pd[restrict t->np][MAGGI_NDIR],
                           const double sensor[restrict t->nsensor][3],
                           const double sensord[restrict t->nsensor][3][MAGGI_NDIR],
                           const double y[restrict t->nstate],
                           const double yd[restrict t->nstate][MAGGI_NDIR],
                           double yrate[restrict t->nstate],
                           double yrated[restrict t->nstate][MAGGI_NDIR], int nbdirs)
{
  int adr, i, k, n2, nd;
  double high, inv, inv2, t2, t3, t3inv, t4, t5, w, w2, w3, w4, w5, w6, w7;
  double u2d[MAGGI_NDIR], u3d[MAGGI_NDIR], w5d[MAGGI_NDIR], w6d[MAGGI_NDIR];

  (void)sensor;
  (void)nbdirs;
  for (i = 0; i < t->nfilter; ++i) {
    adr = t->filteradr[i];
    k = t->filterstate[i];
    w = 6.283185307179586476925286766559 * p[adr];
    high = yrate[k + 1];
    w2 = 6.283185307179586476925286766559 * p[adr + 1];
    n2 = k + 4;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double highd, ud, w2d, wd;

      ud = sensord[t->filtersensor[i]][t->filtercolumn[i]][nd];
      wd = 6.283185307179586476925286766559 * pd[adr][nd];
      highd = ud - ((wd * w + w * wd) * y[k] + w * w * yd[k][nd]) - (wd / (1.0 /
          1.4142135623730950488016887242097) * y[k + 1] + w / (1.0 /
          1.4142135623730950488016887242097) * yd[k + 1][nd]);
      yrated[k][nd] = yd[k + 1][nd];
      yrated[k + 1][nd] = highd;
      yrated[k + 2][nd] = yd[k + 3][nd];
      w2d = 6.283185307179586476925286766559 * pd[adr + 1][nd];
      yrated[k + 3][nd] = pd[t->filtergain[i]][nd] * high + p[t->filtergain[i]] * highd - ((w2d * w2
          + w2 * w2d) * y[k + 2] + w2 * w2 * yd[k + 2][nd]) - (w2d / (1.0 /
          1.4142135623730950488016887242097) * y[k + 3] + w2 / (1.0 /
          1.4142135623730950488016887242097) * yd[k + 3][nd]);
    }
    if (t->filterf4[i] >= 0) {
      w3 = 6.283185307179586476925286766559 * p[adr + 1];
      w4 = 6.283185307179586476925286766559 * p[t->filterf4[i]];
      t2 = w4 / p[t->filterf4[i] + 1];
      inv = 1.0 / p[t->filterf4[i] + 1];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double lowd, t2d, w3d, w4d;

        /* what the low pass of the filter with states from k on passes on */
        w3d = 6.283185307179586476925286766559 * pd[adr + 1][nd];
        lowd = (w3d * w3 + w3 * w3d) * y[k + 2] + w3 * w3 * yd[k + 2][nd];
        yrated[n2][nd] = yd[n2 + 1][nd];
        w4d = 6.283185307179586476925286766559 * pd[t->filterf4[i]][nd];
        t2d = (w4d - t2 * pd[t->filterf4[i] + 1][nd]) * inv;
        yrated[n2 + 1][nd] = lowd - ((w4d * w4 + w4 * w4d) * y[n2] + w4 * w4 * yd[n2][nd]) - (t2d *
            y[n2 + 1] + t2 * yd[n2 + 1][nd]);
      }
      n2 = n2 + 2;
    }
    if (t->filterf5[i] >= 0) {
      adr = t->filterf5[i];
      w5 = 6.283185307179586476925286766559 * p[adr + 2];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        yrated[n2][nd] = yd[n2 + 1][nd];
        w5d[nd] = 6.283185307179586476925286766559 * pd[adr + 2][nd];
      }
      /* what the sections before its step pass on */
      if (t->filterf4[i] >= 0) {
        w6 = 6.283185307179586476925286766559 * p[t->filterf4[i]];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          /* what its transition passes on; adr3: address of f_3, -1 if that is infinite */
          w6d[nd] = 6.283185307179586476925286766559 * pd[t->filterf4[i]][nd];
          u3d[nd] = (w6d[nd] * w6 + w6 * w6d[nd]) * y[t->filterstate[i] + 4] + w6 * w6 *
              yd[t->filterstate[i] + 4][nd];
        }
        if (t->filterf3[i] >= 0) {
          t3 = 6.283185307179586476925286766559 * p[t->filterf3[i]];
          t4 = w6 * w6 / t3;
          t3inv = 1.0 / t3;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double t3d, t4d;

            t3d = 6.283185307179586476925286766559 * pd[t->filterf3[i]][nd];
            t4d = (w6d[nd] * w6 + w6 * w6d[nd] - t4 * t3d) * t3inv;
            u3d[nd] += t4d * y[t->filterstate[i] + 5] + t4 * yd[t->filterstate[i] + 5][nd];
          }
        }
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          u2d[nd] = u3d[nd];
        }
      } else {
        w7 = 6.283185307179586476925286766559 * p[t->filteradr[i] + 1];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double w7d;

          /* what the low pass of the filter with states from k on passes on */
          w7d = 6.283185307179586476925286766559 * pd[t->filteradr[i] + 1][nd];
          u2d[nd] = (w7d * w7 + w7 * w7d) * y[t->filterstate[i] + 2] + w7 * w7 *
              yd[t->filterstate[i] + 2][nd];
        }
      }
      t5 = w5 / p[adr + 3];
      inv2 = 1.0 / p[adr + 3];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t5d;

        t5d = (w5d[nd] - t5 * pd[adr + 3][nd]) * inv2;
        yrated[n2 + 1][nd] = u2d[nd] - ((w5d[nd] * w5 + w5 * w5d[nd]) * y[n2] + w5 * w5 *
            yd[n2][nd]) - (t5d * y[n2 + 1] + t5 * yd[n2 + 1][nd]);
      }
    }
  }
}

void maggi_filter_outputs_dv(const maggi_topo *t, const double p[restrict t->np],
                             const double pd[restrict t->np][MAGGI_NDIR],
                             const double y[restrict t->nstate],
                             const double yd[restrict t->nstate][MAGGI_NDIR],
                             double output[restrict t->nfilter],
                             double outputd[restrict t->nfilter][MAGGI_NDIR], int nbdirs)
{
  int adr, i, n2, nd;
  double inv, inv2, t2, t2inv, t3, t4, t5, w, w2, w5, w6;
  double u2d[MAGGI_NDIR], u3d[MAGGI_NDIR], ud[MAGGI_NDIR], wd[MAGGI_NDIR];

  (void)output;
  (void)nbdirs;
  for (i = 0; i < t->nfilter; ++i) {
    /* what the sections before its step pass on */
    if (t->filterf4[i] >= 0) {
      w = 6.283185307179586476925286766559 * p[t->filterf4[i]];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        /* what its transition passes on; adr3: address of f_3, -1 if that is infinite */
        wd[nd] = 6.283185307179586476925286766559 * pd[t->filterf4[i]][nd];
        u3d[nd] = (wd[nd] * w + w * wd[nd]) * y[t->filterstate[i] + 4] + w * w *
            yd[t->filterstate[i] + 4][nd];
      }
      if (t->filterf3[i] >= 0) {
        t2 = 6.283185307179586476925286766559 * p[t->filterf3[i]];
        t3 = w * w / t2;
        t2inv = 1.0 / t2;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t2d, t3d;

          t2d = 6.283185307179586476925286766559 * pd[t->filterf3[i]][nd];
          t3d = (wd[nd] * w + w * wd[nd] - t3 * t2d) * t2inv;
          u3d[nd] += t3d * y[t->filterstate[i] + 5] + t3 * yd[t->filterstate[i] + 5][nd];
        }
      }
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        u2d[nd] = u3d[nd];
      }
    } else {
      w2 = 6.283185307179586476925286766559 * p[t->filteradr[i] + 1];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double w2d;

        /* what the low pass of the filter with states from k on passes on */
        w2d = 6.283185307179586476925286766559 * pd[t->filteradr[i] + 1][nd];
        u2d[nd] = (w2d * w2 + w2 * w2d) * y[t->filterstate[i] + 2] + w2 * w2 * yd[t->filterstate[i]
            + 2][nd];
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      ud[nd] = u2d[nd];
    }
    if (t->filterf5[i] >= 0) {
      adr = t->filterf5[i];
      n2 = t->filterstate[i] + (t->filterf4[i] >= 0 ? 6 : 4);
      w5 = 6.283185307179586476925286766559 * p[adr];
      w6 = 6.283185307179586476925286766559 * p[adr + 2];
      t4 = w5 / p[adr + 1];
      inv = 1.0 / p[adr + 1];
      t5 = w6 / p[adr + 3];
      inv2 = 1.0 / p[adr + 3];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t4d, t5d, w5d, w6d;

        w5d = 6.283185307179586476925286766559 * pd[adr][nd];
        w6d = 6.283185307179586476925286766559 * pd[adr + 2][nd];
        t4d = (w5d - t4 * pd[adr + 1][nd]) * inv;
        t5d = (w6d - t5 * pd[adr + 3][nd]) * inv2;
        outputd[i][nd] = ud[nd] + ((w5d * w5 + w5 * w5d - (w6d * w6 + w6 * w6d)) * y[n2] + (w5 * w5
            - w6 * w6) * yd[n2][nd]) + ((t4d - t5d) * y[n2 + 1] + (t4 - t5) * yd[n2 + 1][nd]);
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        outputd[i][nd] = ud[nd];
      }
    }
  }
}
