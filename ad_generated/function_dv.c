/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/function.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

void maggi_spline_constants_dv(const maggi_topo *t, const double p[restrict t->np],
                               const double pd[restrict t->np][MAGGI_NDIR],
                               double spline0[restrict t->nspline][3],
                               double spline0d[restrict t->nspline][3][MAGGI_NDIR], int nbdirs)
{
  int i, k, k2, nd;
  double e0, e0_2, e1, e1_2, h0, h0_2, h0_2inv, h0inv, h1, h1_2, h1_2inv, h1inv, p_iik, p_iik2,
      p_ik, p_ik2, t2, t3, w, w2, w2inv, winv;

  (void)nbdirs;
  for (i = 0; i < t->nfun; ++i) {
    if (t->funkind[i] == MAGGI_FUNCTION_SPLINE) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        spline0d[t->funspline[i]][1][nd] = 0.0;
        spline0d[t->funspline[i]][2][nd] = 0.0;
      }
      for (k = 1; k < t->funn[i] - 1; ++k) {
        p_ik = p[t->funadr[i] + k];
        h0 = p_ik - p[t->funadr[i] + k - 1];
        h1 = p[t->funadr[i] + k + 1] - p_ik;
        p_iik = p[t->funadr[i] + t->funn[i] + k];
        e0 = (p_iik - p[t->funadr[i] + t->funn[i] + k - 1]) / h0;
        h0inv = 1.0 / h0;
        e1 = (p[t->funadr[i] + t->funn[i] + k + 1] - p_iik) / h1;
        h1inv = 1.0 / h1;
        w = 2.0 * (h0 + h1) - h0 * spline0[t->funspline[i] + k - 1][2];
        t2 = spline0[t->funspline[i] + k][1];
        winv = 1.0 / w;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double e0d, e1d, h0d, h1d, p_iikd, p_ikd, t2d, wd;

          p_ikd = pd[t->funadr[i] + k][nd];
          h0d = p_ikd - pd[t->funadr[i] + k - 1][nd];
          h1d = pd[t->funadr[i] + k + 1][nd] - p_ikd;
          p_iikd = pd[t->funadr[i] + t->funn[i] + k][nd];
          e0d = (p_iikd - pd[t->funadr[i] + t->funn[i] + k - 1][nd] - e0 * h0d) * h0inv;
          e1d = (pd[t->funadr[i] + t->funn[i] + k + 1][nd] - p_iikd - e1 * h1d) * h1inv;
          wd = 2.0 * (h0d + h1d) - (h0d * spline0[t->funspline[i] + k - 1][2] + h0 *
              spline0d[t->funspline[i] + k - 1][2][nd]);
          t2d = (6.0 * (e1d - e0d) - (h0d * spline0[t->funspline[i] + k - 1][1] + h0 *
              spline0d[t->funspline[i] + k - 1][1][nd]) - t2 * wd) * winv;
          spline0d[t->funspline[i] + k][1][nd] = t2d;
          spline0d[t->funspline[i] + k][2][nd] = (h1d - spline0[t->funspline[i] + k][2] * wd) *
              winv;
        }
      }
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        spline0d[t->funspline[i]][0][nd] = 0.0;
        spline0d[t->funspline[i] + t->funn[i] - 1][0][nd] = 0.0;
      }
      for (k = t->funn[i] - 2; k > 0; --k) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          spline0d[t->funspline[i] + k][0][nd] = spline0d[t->funspline[i] + k][1][nd] -
              (spline0d[t->funspline[i] + k][2][nd] * spline0[t->funspline[i] + k + 1][0] +
              spline0[t->funspline[i] + k][2] * spline0d[t->funspline[i] + k + 1][0][nd]);
        }
      }
    }
  }
  for (i = 0; i < t->nroad; ++i) {
    if (t->roadkind[i] == MAGGI_ROAD_PROFILE) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        spline0d[t->roadspline[i]][1][nd] = 0.0;
        spline0d[t->roadspline[i]][2][nd] = 0.0;
      }
      for (k2 = 1; k2 < t->roadn[i] - 1; ++k2) {
        p_ik2 = p[t->roadadr[i] + k2];
        h0_2 = p_ik2 - p[t->roadadr[i] + k2 - 1];
        h1_2 = p[t->roadadr[i] + k2 + 1] - p_ik2;
        p_iik2 = p[t->roadadr[i] + t->roadn[i] + k2];
        e0_2 = (p_iik2 - p[t->roadadr[i] + t->roadn[i] + k2 - 1]) / h0_2;
        h0_2inv = 1.0 / h0_2;
        e1_2 = (p[t->roadadr[i] + t->roadn[i] + k2 + 1] - p_iik2) / h1_2;
        h1_2inv = 1.0 / h1_2;
        w2 = 2.0 * (h0_2 + h1_2) - h0_2 * spline0[t->roadspline[i] + k2 - 1][2];
        t3 = spline0[t->roadspline[i] + k2][1];
        w2inv = 1.0 / w2;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double e0_2d, e1_2d, h0_2d, h1_2d, p_iik2d, p_ik2d, t3d, w2d;

          p_ik2d = pd[t->roadadr[i] + k2][nd];
          h0_2d = p_ik2d - pd[t->roadadr[i] + k2 - 1][nd];
          h1_2d = pd[t->roadadr[i] + k2 + 1][nd] - p_ik2d;
          p_iik2d = pd[t->roadadr[i] + t->roadn[i] + k2][nd];
          e0_2d = (p_iik2d - pd[t->roadadr[i] + t->roadn[i] + k2 - 1][nd] - e0_2 * h0_2d) * h0_2inv;
          e1_2d = (pd[t->roadadr[i] + t->roadn[i] + k2 + 1][nd] - p_iik2d - e1_2 * h1_2d) * h1_2inv;
          w2d = 2.0 * (h0_2d + h1_2d) - (h0_2d * spline0[t->roadspline[i] + k2 - 1][2] + h0_2 *
              spline0d[t->roadspline[i] + k2 - 1][2][nd]);
          t3d = (6.0 * (e1_2d - e0_2d) - (h0_2d * spline0[t->roadspline[i] + k2 - 1][1] + h0_2 *
              spline0d[t->roadspline[i] + k2 - 1][1][nd]) - t3 * w2d) * w2inv;
          spline0d[t->roadspline[i] + k2][1][nd] = t3d;
          spline0d[t->roadspline[i] + k2][2][nd] = (h1_2d - spline0[t->roadspline[i] + k2][2] * w2d)
              * w2inv;
        }
      }
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        spline0d[t->roadspline[i]][0][nd] = 0.0;
        spline0d[t->roadspline[i] + t->roadn[i] - 1][0][nd] = 0.0;
      }
      for (k2 = t->roadn[i] - 2; k2 > 0; --k2) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          spline0d[t->roadspline[i] + k2][0][nd] = spline0d[t->roadspline[i] + k2][1][nd] -
              (spline0d[t->roadspline[i] + k2][2][nd] * spline0[t->roadspline[i] + k2 + 1][0] +
              spline0[t->roadspline[i] + k2][2] * spline0d[t->roadspline[i] + k2 + 1][0][nd]);
        }
      }
    }
  }
}

void maggi_functions_dv(const maggi_topo *t, const double p[restrict t->np],
                        const double pd[restrict t->np][MAGGI_NDIR],
                        const double spline0[restrict t->nspline][3],
                        const double spline0d[restrict t->nspline][3][MAGGI_NDIR], double time,
                        double fun[restrict t->nfun][3],
                        double fund[restrict t->nfun][3][MAGGI_NDIR], int nbdirs)
{
  int i, is_k2, is_k2_2, is_k2_3, is_k2_4, k, k2, k3, nd;
  double a, c, c2, c3, c4, e, h, h2, h2inv, h3, h3inv, h4, h4_2, h4_2inv, h4_3, h4_3inv, h4inv,
      hinv, moves, p_i, p_i1, p_i2, p_i2_2, p_i3, p_i3_2, p_i3_3, p_i3_4, p_i4, p_i5, p_ii, p_ii1,
      p_iii1, p_iik2, p_iik21, p_iik3, p_ik2, p_ik3, p_ik31, s, slope, slope2, spline0_ik30,
      spline0_ik310, t10, t11, t11inv, t12, t13, t14, t15, t16, t17, t17inv, t18, t19, t19inv, t2,
      t20, t21, t3, t4, t5, t6, t7, t8, t8inv, t9, x, x2, x3;
  double f0d[MAGGI_NDIR], f1d[MAGGI_NDIR], f2d[MAGGI_NDIR], h3d[MAGGI_NDIR], x3d[MAGGI_NDIR];

  (void)fun;
  (void)nbdirs;
  for (i = 0; i < t->nfun; ++i) {
    moves = t->funheld[i] ? 0.0 : 1.0;
    /* of one function */
    if (t->funkind[i] == MAGGI_FUNCTION_CONSTANT) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        f0d[nd] = pd[t->funadr[i]][nd];
        f1d[nd] = 0.0;
        f2d[nd] = 0.0;
      }
    } else if (t->funkind[i] == MAGGI_FUNCTION_POLYNOMIAL) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        /* sum_k c_k t^k */
        f0d[nd] = pd[t->funadr[i]][nd];
        f1d[nd] = 0.0;
        f2d[nd] = 0.0;
      }
      for (k = 1; k < t->funn[i]; ++k) {
        t2 = pow(time, k);
        t3 = pow(time, k - 1);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_ikd;

          p_ikd = pd[t->funadr[i] + k][nd];
          f0d[nd] += p_ikd * t2;
          f1d[nd] += p_ikd * k * t3;
        }
        if (k > 1) {
          t4 = pow(time, k - 2);
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            f2d[nd] += pd[t->funadr[i] + k][nd] * k * (k - 1) * t4;
          }
        }
      }
    } else if (t->funkind[i] == MAGGI_FUNCTION_SINE) {
      p_i1 = p[t->funadr[i] + 1];
      p_i2 = p[t->funadr[i] + 2];
      t5 = p_i1 * time + p_i2;
      s = sin(t5);
      c3 = cos(t5);
      t6 = p_i1 * time + p_i2;
      c = cos(t6);
      c4 = -sin(t6);
      p_i = p[t->funadr[i]];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double cd, p_i1d, p_i2d, p_id, sd, t5d, t6d;

        p_i1d = pd[t->funadr[i] + 1][nd];
        p_i2d = pd[t->funadr[i] + 2][nd];
        t5d = p_i1d * time + p_i2d;
        sd = c3 * t5d;
        t6d = p_i1d * time + p_i2d;
        cd = c4 * t6d;
        p_id = pd[t->funadr[i]][nd];
        f0d[nd] = pd[t->funadr[i] + 3][nd] + (p_id * s + p_i * sd);
        f1d[nd] = (p_id * p_i1 + p_i * p_i1d) * c + p_i * p_i1 * cd;
        f2d[nd] = ((-(p_id * p_i1) - p_i * p_i1d) * p_i1 + -p_i * p_i1 * p_i1d) * s + -p_i * p_i1 *
            p_i1 * sd;
      }
    } else if (t->funkind[i] == MAGGI_FUNCTION_STEP) {
      /* y0 + (y1 - y0) (10 x^3 - 15 x^4 + 6 x^5), x = (t - t0) / (t1 - t0) */
      if (MAGGI_RE(time) <= MAGGI_RE(p[t->funadr[i]])) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          f0d[nd] = pd[t->funadr[i] + 2][nd];
          f1d[nd] = 0.0;
          f2d[nd] = 0.0;
        }
      } else if (MAGGI_RE(time) >= MAGGI_RE(p[t->funadr[i] + 1])) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          f0d[nd] = pd[t->funadr[i] + 3][nd];
          f1d[nd] = 0.0;
          f2d[nd] = 0.0;
        }
      } else {
        p_i3 = p[t->funadr[i]];
        h = p[t->funadr[i] + 1] - p_i3;
        x = (time - p_i3) / h;
        hinv = 1.0 / h;
        p_i2_2 = p[t->funadr[i] + 2];
        p_i3_2 = p[t->funadr[i] + 3];
        t7 = (p_i3_2 - p_i2_2) / h;
        t8 = h * h;
        t9 = (p_i3_2 - p_i2_2) / t8;
        t8inv = 1.0 / t8;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double hd, p_i2_2d, p_i3_2d, p_i3d, t7d, t8d, t9d, xd;

          p_i3d = pd[t->funadr[i]][nd];
          hd = pd[t->funadr[i] + 1][nd] - p_i3d;
          xd = (-p_i3d - x * hd) * hinv;
          p_i2_2d = pd[t->funadr[i] + 2][nd];
          p_i3_2d = pd[t->funadr[i] + 3][nd];
          f0d[nd] = p_i2_2d + (((((p_i3_2d - p_i2_2d) * x + (p_i3_2 - p_i2_2) * xd) * x + (p_i3_2 -
              p_i2_2) * x * xd) * x + (p_i3_2 - p_i2_2) * x * x * xd) * (10.0 + x * (-15.0 + 6.0 *
              x)) + (p_i3_2 - p_i2_2) * x * x * x * (xd * (-15.0 + 6.0 * x) + x * (6.0 * xd)));
          t7d = (p_i3_2d - p_i2_2d - t7 * hd) * hinv;
          f1d[nd] = ((t7d * 30.0 * x + t7 * 30.0 * xd) * x + t7 * 30.0 * x * xd) * (1.0 + x * (-2.0
              + x)) + t7 * 30.0 * x * x * (xd * (-2.0 + x) + x * xd);
          t8d = hd * h + h * hd;
          t9d = (p_i3_2d - p_i2_2d - t9 * t8d) * t8inv;
          f2d[nd] = (t9d * 60.0 * x + t9 * 60.0 * xd) * (1.0 + x * (-3.0 + 2.0 * x)) + t9 * 60.0 * x
              * (xd * (-3.0 + 2.0 * x) + x * (2.0 * xd));
        }
      }
    } else if (t->funkind[i] == MAGGI_FUNCTION_KNOTS) {
      k2 = maggi_piece(t->np, p, t->funadr[i], t->funn[i], time);
      is_k2 = k2 < 0;
      if (is_k2) {
        k2 = 0;
      }
      is_k2_2 = k2 > t->funn[i] - 2;
      if (is_k2_2) {
        k2 = t->funn[i] - 2;
      }
      is_k2_3 = MAGGI_RE(time) <= MAGGI_RE(p[t->funadr[i] + k2]);
      /* y0 + (y1 - y0) (10 x^3 - 15 x^4 + 6 x^5), x = (t - t0) / (t1 - t0) */
      if (is_k2_3) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          f0d[nd] = pd[t->funadr[i] + t->funn[i] + k2][nd];
          f1d[nd] = 0.0;
          f2d[nd] = 0.0;
        }
      } else {
        is_k2_4 = MAGGI_RE(time) >= MAGGI_RE(p[t->funadr[i] + k2 + 1]);
        if (is_k2_4) {
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            f0d[nd] = pd[t->funadr[i] + t->funn[i] + k2 + 1][nd];
            f1d[nd] = 0.0;
            f2d[nd] = 0.0;
          }
        } else {
          p_ik2 = p[t->funadr[i] + k2];
          h2 = p[t->funadr[i] + k2 + 1] - p_ik2;
          x2 = (time - p_ik2) / h2;
          h2inv = 1.0 / h2;
          p_iik2 = p[t->funadr[i] + t->funn[i] + k2];
          p_iik21 = p[t->funadr[i] + t->funn[i] + k2 + 1];
          t10 = (p_iik21 - p_iik2) / h2;
          t11 = h2 * h2;
          t12 = (p_iik21 - p_iik2) / t11;
          t11inv = 1.0 / t11;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double h2d, p_iik21d, p_iik2d, p_ik2d, t10d, t11d, t12d, x2d;

            p_ik2d = pd[t->funadr[i] + k2][nd];
            h2d = pd[t->funadr[i] + k2 + 1][nd] - p_ik2d;
            x2d = (-p_ik2d - x2 * h2d) * h2inv;
            p_iik2d = pd[t->funadr[i] + t->funn[i] + k2][nd];
            p_iik21d = pd[t->funadr[i] + t->funn[i] + k2 + 1][nd];
            f0d[nd] = p_iik2d + (((((p_iik21d - p_iik2d) * x2 + (p_iik21 - p_iik2) * x2d) * x2 +
                (p_iik21 - p_iik2) * x2 * x2d) * x2 + (p_iik21 - p_iik2) * x2 * x2 * x2d) * (10.0 +
                x2 * (-15.0 + 6.0 * x2)) + (p_iik21 - p_iik2) * x2 * x2 * x2 * (x2d * (-15.0 + 6.0 *
                x2) + x2 * (6.0 * x2d)));
            t10d = (p_iik21d - p_iik2d - t10 * h2d) * h2inv;
            f1d[nd] = ((t10d * 30.0 * x2 + t10 * 30.0 * x2d) * x2 + t10 * 30.0 * x2 * x2d) * (1.0 +
                x2 * (-2.0 + x2)) + t10 * 30.0 * x2 * x2 * (x2d * (-2.0 + x2) + x2 * x2d);
            t11d = h2d * h2 + h2 * h2d;
            t12d = (p_iik21d - p_iik2d - t12 * t11d) * t11inv;
            f2d[nd] = (t12d * 60.0 * x2 + t12 * 60.0 * x2d) * (1.0 + x2 * (-3.0 + 2.0 * x2)) + t12 *
                60.0 * x2 * (x2d * (-3.0 + 2.0 * x2) + x2 * (2.0 * x2d));
          }
        }
      }
    } else if (t->funkind[i] == MAGGI_FUNCTION_RAMP) {
      p_i4 = p[t->funadr[i]];
      h3 = p[t->funadr[i] + 1] - p_i4;
      x3 = (time - p_i4) / h3;
      h3inv = 1.0 / h3;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_i4d;

        p_i4d = pd[t->funadr[i]][nd];
        /* y0, then its rate rises as a quintic step, h x^4 (5/2 - 3 x + x^2), then it is straight */
        h3d[nd] = pd[t->funadr[i] + 1][nd] - p_i4d;
        x3d[nd] = (-p_i4d - x3 * h3d[nd]) * h3inv;
      }
      if (MAGGI_RE(time) <= MAGGI_RE(p[t->funadr[i]])) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          f0d[nd] = pd[t->funadr[i] + 2][nd];
          f1d[nd] = 0.0;
          f2d[nd] = 0.0;
        }
      } else if (MAGGI_RE(time) >= MAGGI_RE(p[t->funadr[i] + 1])) {
        p_i3_3 = p[t->funadr[i] + 3];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_i3_3d;

          p_i3_3d = pd[t->funadr[i] + 3][nd];
          f0d[nd] = pd[t->funadr[i] + 2][nd] + (p_i3_3d * (time - 0.5 * (p[t->funadr[i]] +
              p[t->funadr[i] + 1])) - p_i3_3 * (0.5 * (pd[t->funadr[i]][nd] + pd[t->funadr[i] +
              1][nd])));
          f1d[nd] = p_i3_3d;
          f2d[nd] = 0.0;
        }
      } else {
        p_i3_4 = p[t->funadr[i] + 3];
        t13 = p_i3_4 / h3;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_i3_4d, t13d;

          p_i3_4d = pd[t->funadr[i] + 3][nd];
          f0d[nd] = pd[t->funadr[i] + 2][nd] + ((((((p_i3_4d * h3 + p_i3_4 * h3d[nd]) * x3 + p_i3_4
              * h3 * x3d[nd]) * x3 + p_i3_4 * h3 * x3 * x3d[nd]) * x3 + p_i3_4 * h3 * x3 * x3 *
              x3d[nd]) * x3 + p_i3_4 * h3 * x3 * x3 * x3 * x3d[nd]) * (2.5 + x3 * (-3.0 + x3)) +
              p_i3_4 * h3 * x3 * x3 * x3 * x3 * (x3d[nd] * (-3.0 + x3) + x3 * x3d[nd]));
          f1d[nd] = (((p_i3_4d * x3 + p_i3_4 * x3d[nd]) * x3 + p_i3_4 * x3 * x3d[nd]) * x3 + p_i3_4
              * x3 * x3 * x3d[nd]) * (10.0 + x3 * (-15.0 + 6.0 * x3)) + p_i3_4 * x3 * x3 * x3 *
              (x3d[nd] * (-15.0 + 6.0 * x3) + x3 * (6.0 * x3d[nd]));
          t13d = (p_i3_4d - t13 * h3d[nd]) * h3inv;
          f2d[nd] = ((t13d * 30.0 * x3 + t13 * 30.0 * x3d[nd]) * x3 + t13 * 30.0 * x3 * x3d[nd]) *
              (1.0 + x3 * (-2.0 + x3)) + t13 * 30.0 * x3 * x3 * (x3d[nd] * (-2.0 + x3) + x3 *
              x3d[nd]);
        }
      }
    } else {
      k3 = maggi_piece(t->np, p, t->funadr[i], t->funn[i], time);
      if (k3 < 0) {
        p_i5 = p[t->funadr[i]];
        h4 = p[t->funadr[i] + 1] - p_i5;
        p_ii = p[t->funadr[i] + t->funn[i]];
        t14 = (p[t->funadr[i] + t->funn[i] + 1] - p_ii) / h4;
        h4inv = 1.0 / h4;
        slope = t14 - h4 / 6.0 * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] +
            1][0]);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double h4d, p_i5d, p_iid, sloped, t14d;

          p_i5d = pd[t->funadr[i]][nd];
          h4d = pd[t->funadr[i] + 1][nd] - p_i5d;
          p_iid = pd[t->funadr[i] + t->funn[i]][nd];
          t14d = (pd[t->funadr[i] + t->funn[i] + 1][nd] - p_iid - t14 * h4d) * h4inv;
          sloped = t14d - (h4d / 6.0 * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i]
              + 1][0]) + h4 / 6.0 * (2.0 * spline0d[t->funspline[i]][0][nd] +
              spline0d[t->funspline[i] + 1][0][nd]));
          f0d[nd] = p_iid + (sloped * (time - p_i5) - slope * p_i5d);
          f1d[nd] = sloped;
          f2d[nd] = 0.0;
        }
      } else if (k3 > t->funn[i] - 2) {
        p_ii1 = p[t->funadr[i] + t->funn[i] - 1];
        h4_2 = p_ii1 - p[t->funadr[i] + t->funn[i] - 2];
        p_iii1 = p[t->funadr[i] + t->funn[i] + t->funn[i] - 1];
        t15 = (p_iii1 - p[t->funadr[i] + t->funn[i] + t->funn[i] - 2]) / h4_2;
        h4_2inv = 1.0 / h4_2;
        slope2 = t15 + h4_2 / 6.0 * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double h4_2d, p_ii1d, p_iii1d, slope2d, t15d;

          p_ii1d = pd[t->funadr[i] + t->funn[i] - 1][nd];
          h4_2d = p_ii1d - pd[t->funadr[i] + t->funn[i] - 2][nd];
          p_iii1d = pd[t->funadr[i] + t->funn[i] + t->funn[i] - 1][nd];
          t15d = (p_iii1d - pd[t->funadr[i] + t->funn[i] + t->funn[i] - 2][nd] - t15 * h4_2d) *
              h4_2inv;
          slope2d = t15d + (h4_2d / 6.0 * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
              spline0[t->funspline[i] + t->funn[i] - 1][0]) + h4_2 / 6.0 * (spline0d[t->funspline[i]
              + t->funn[i] - 2][0][nd] + 2.0 * spline0d[t->funspline[i] + t->funn[i] - 1][0][nd]));
          f0d[nd] = p_iii1d + (slope2d * (time - p_ii1) - slope2 * p_ii1d);
          f1d[nd] = slope2d;
          f2d[nd] = 0.0;
        }
      } else {
        p_ik31 = p[t->funadr[i] + k3 + 1];
        p_ik3 = p[t->funadr[i] + k3];
        h4_3 = p_ik31 - p_ik3;
        a = p_ik31 - time;
        c2 = time - p_ik3;
        p_iik3 = p[t->funadr[i] + t->funn[i] + k3];
        t16 = (p[t->funadr[i] + t->funn[i] + k3 + 1] - p_iik3) / h4_3;
        h4_3inv = 1.0 / h4_3;
        spline0_ik310 = spline0[t->funspline[i] + k3 + 1][0];
        spline0_ik30 = spline0[t->funspline[i] + k3][0];
        e = t16 - h4_3 / 6.0 * (spline0_ik310 - spline0_ik30);
        t17 = 6.0 * h4_3;
        t18 = (spline0_ik30 * a * a * a + spline0_ik310 * c2 * c2 * c2) / t17;
        t17inv = 1.0 / t17;
        t19 = 2.0 * h4_3;
        t20 = (spline0_ik310 * c2 * c2 - spline0_ik30 * a * a) / t19;
        t19inv = 1.0 / t19;
        t21 = (spline0_ik30 * a + spline0_ik310 * c2) / h4_3;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double ad, c2d, ed, h4_3d, p_iik3d, p_ik31d, p_ik3d, spline0_ik30d, spline0_ik310d, t16d,
              t17d, t18d, t19d, t20d, t21d;

          p_ik31d = pd[t->funadr[i] + k3 + 1][nd];
          p_ik3d = pd[t->funadr[i] + k3][nd];
          h4_3d = p_ik31d - p_ik3d;
          ad = p_ik31d;
          c2d = -p_ik3d;
          p_iik3d = pd[t->funadr[i] + t->funn[i] + k3][nd];
          t16d = (pd[t->funadr[i] + t->funn[i] + k3 + 1][nd] - p_iik3d - t16 * h4_3d) * h4_3inv;
          spline0_ik310d = spline0d[t->funspline[i] + k3 + 1][0][nd];
          spline0_ik30d = spline0d[t->funspline[i] + k3][0][nd];
          ed = t16d - (h4_3d / 6.0 * (spline0_ik310 - spline0_ik30) + h4_3 / 6.0 * (spline0_ik310d -
              spline0_ik30d));
          t17d = 6.0 * h4_3d;
          t18d = (((spline0_ik30d * a + spline0_ik30 * ad) * a + spline0_ik30 * a * ad) * a +
              spline0_ik30 * a * a * ad + (((spline0_ik310d * c2 + spline0_ik310 * c2d) * c2 +
              spline0_ik310 * c2 * c2d) * c2 + spline0_ik310 * c2 * c2 * c2d) - t18 * t17d) *
              t17inv;
          f0d[nd] = t18d + p_iik3d - ((spline0_ik30d * h4_3 + spline0_ik30 * h4_3d) * h4_3 +
              spline0_ik30 * h4_3 * h4_3d) / 6.0 + (ed * c2 + e * c2d);
          t19d = 2.0 * h4_3d;
          t20d = ((spline0_ik310d * c2 + spline0_ik310 * c2d) * c2 + spline0_ik310 * c2 * c2d -
              ((spline0_ik30d * a + spline0_ik30 * ad) * a + spline0_ik30 * a * ad) - t20 * t19d) *
              t19inv;
          f1d[nd] = t20d + ed;
          t21d = (spline0_ik30d * a + spline0_ik30 * ad + (spline0_ik310d * c2 + spline0_ik310 *
              c2d) - t21 * h4_3d) * h4_3inv;
          f2d[nd] = t21d;
        }
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      fund[i][0][nd] = f0d[nd];
      fund[i][1][nd] = moves * f1d[nd];
      fund[i][2][nd] = moves * f2d[nd];
    }
  }
}
