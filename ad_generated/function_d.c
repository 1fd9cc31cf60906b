/* Tangent of core/kernel/function.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

static int piece_nodiff(int np, const double p[np], int adr, int n, double time)
{
  int k;

  for (k = -1; k < n - 1; ++k)
    if (MAGGI_RE(time) < MAGGI_RE(p[adr + k + 1])) return k;
  return n - 1;
}

void maggi_spline_constants_d(const maggi_topo *t, const double p[restrict t->np],
                              const double pd[restrict t->np],
                              double spline0[restrict t->nspline][3],
                              double spline0d[restrict t->nspline][3])
{
  int i, k;
  double e0, e0d, e1, e1d, h0, h0d, h0inv, h1, h1d, h1inv, p_iik, p_iikd, p_ik, p_ikd, t2, t2d, w,
      wd, winv;

  for (i = 0; i < t->nfun; ++i) {
    if (t->funkind[i] == MAGGI_FUNCTION_SPLINE) {
      /* natural cubic spline through (t_k, y_k): second derivatives m_k from the tridiagonal system
       *   h_{k-1} m_{k-1} + 2 (h_{k-1} + h_k) m_k + h_k m_{k+1} = 6 (e_k - e_{k-1}),  e = slope of a piece
       * by elimination, m = 0 at the ends.  Columns of s: m, and what the elimination needs. */
      spline0d[t->funspline[i]][1] = 0.0;
      spline0d[t->funspline[i]][2] = 0.0;
      for (k = 1; k < t->funn[i] - 1; ++k) {
        p_ik = p[t->funadr[i] + k];
        p_ikd = pd[t->funadr[i] + k];
        h0 = p_ik - p[t->funadr[i] + k - 1];
        h0d = p_ikd - pd[t->funadr[i] + k - 1];
        h1 = p[t->funadr[i] + k + 1] - p_ik;
        h1d = pd[t->funadr[i] + k + 1] - p_ikd;
        p_iik = p[t->funadr[i] + t->funn[i] + k];
        p_iikd = pd[t->funadr[i] + t->funn[i] + k];
        e0 = (p_iik - p[t->funadr[i] + t->funn[i] + k - 1]) / h0;
        h0inv = 1.0 / h0;
        e0d = (p_iikd - pd[t->funadr[i] + t->funn[i] + k - 1] - e0 * h0d) * h0inv;
        e1 = (p[t->funadr[i] + t->funn[i] + k + 1] - p_iik) / h1;
        h1inv = 1.0 / h1;
        e1d = (pd[t->funadr[i] + t->funn[i] + k + 1] - p_iikd - e1 * h1d) * h1inv;
        w = 2.0 * (h0 + h1) - h0 * spline0[t->funspline[i] + k - 1][2];
        wd = 2.0 * (h0d + h1d) - (h0d * spline0[t->funspline[i] + k - 1][2] + h0 *
            spline0d[t->funspline[i] + k - 1][2]);
        t2 = spline0[t->funspline[i] + k][1];
        winv = 1.0 / w;
        t2d = (6.0 * (e1d - e0d) - (h0d * spline0[t->funspline[i] + k - 1][1] + h0 *
            spline0d[t->funspline[i] + k - 1][1]) - t2 * wd) * winv;
        spline0d[t->funspline[i] + k][1] = t2d;
        spline0d[t->funspline[i] + k][2] = (h1d - spline0[t->funspline[i] + k][2] * wd) * winv;
      }
      spline0d[t->funspline[i]][0] = 0.0;
      spline0d[t->funspline[i] + t->funn[i] - 1][0] = 0.0;
      for (k = t->funn[i] - 2; k > 0; --k) {
        spline0d[t->funspline[i] + k][0] = spline0d[t->funspline[i] + k][1] -
            (spline0d[t->funspline[i] + k][2] * spline0[t->funspline[i] + k + 1][0] +
            spline0[t->funspline[i] + k][2] * spline0d[t->funspline[i] + k + 1][0]);
      }
    }
  }
}

void maggi_functions_d(const maggi_topo *t, const double p[restrict t->np],
                       const double pd[restrict t->np],
                       const double spline0[restrict t->nspline][3],
                       const double spline0d[restrict t->nspline][3], double time,
                       double fun[restrict t->nfun][3], double fund[restrict t->nfun][3])
{
  int i, is_k3, is_k3_2, is_k3_3, is_k3_4, k, k2, k3, k4;
  double a, ad, c, c2, c2d, c3, c4, cd, e, ed, h, h2, h2d, h2inv, h3, h3_2, h3_2d, h3_2inv, h3_3,
      h3_3d, h3_3inv, h3d, h3inv, hd, hinv, p_k, p_k1, p_k1d, p_k2, p_k2_2, p_k2_2d, p_k2d, p_k3,
      p_k3_2, p_k3_2d, p_k3d, p_k4, p_k4d, p_kd, p_ki, p_ki1, p_ki1d, p_kid, p_kii1, p_kii1d,
      p_kik3, p_kik31, p_kik31d, p_kik3d, p_kik4, p_kik4d, p_kk2d, p_kk3, p_kk3d, p_kk4, p_kk41,
      p_kk41d, p_kk4d, s, sd, slope, slope2, slope2d, sloped, spline0_ik40, spline0_ik40d,
      spline0_ik410, spline0_ik410d, t10, t10d, t11, t11d, t11inv, t12, t12d, t13, t13d, t14, t14d,
      t15, t15d, t16, t16d, t16inv, t17, t17d, t18, t18d, t18inv, t19, t19d, t2, t20, t20d, t3, t4,
      t5, t5d, t6, t6d, t7, t7d, t8, t8d, t8inv, t9, t9d, x, x2, x2d, xd;

  (void)fun;
  for (i = 0; i < t->nfun; ++i) {
    k = t->funadr[i];
    if (t->funkind[i] == MAGGI_FUNCTION_CONSTANT) {
      fund[i][0] = pd[k];
      fund[i][1] = 0.0;
      fund[i][2] = 0.0;
    } else if (t->funkind[i] == MAGGI_FUNCTION_POLYNOMIAL) {
      /* sum_k c_k t^k */
      fund[i][0] = pd[k];
      fund[i][1] = 0.0;
      fund[i][2] = 0.0;
      for (k2 = 1; k2 < t->funn[i]; ++k2) {
        t2 = pow(time, k2);
        p_kk2d = pd[k + k2];
        fund[i][0] += p_kk2d * t2;
        t3 = pow(time, k2 - 1);
        fund[i][1] += p_kk2d * k2 * t3;
        if (k2 > 1) {
          t4 = pow(time, k2 - 2);
          fund[i][2] += pd[k + k2] * k2 * (k2 - 1) * t4;
        }
      }
    } else if (t->funkind[i] == MAGGI_FUNCTION_SINE) {
      p_k1 = p[k + 1];
      p_k1d = pd[k + 1];
      p_k2 = p[k + 2];
      p_k2d = pd[k + 2];
      t5 = p_k1 * time + p_k2;
      t5d = p_k1d * time + p_k2d;
      s = sin(t5);
      c3 = cos(t5);
      sd = c3 * t5d;
      t6 = p_k1 * time + p_k2;
      t6d = p_k1d * time + p_k2d;
      c = cos(t6);
      c4 = -sin(t6);
      cd = c4 * t6d;
      p_k = p[k];
      p_kd = pd[k];
      fund[i][0] = pd[k + 3] + (p_kd * s + p_k * sd);
      fund[i][1] = (p_kd * p_k1 + p_k * p_k1d) * c + p_k * p_k1 * cd;
      fund[i][2] = ((-(p_kd * p_k1) - p_k * p_k1d) * p_k1 + -p_k * p_k1 * p_k1d) * s + -p_k * p_k1 *
          p_k1 * sd;
    } else if (t->funkind[i] == MAGGI_FUNCTION_STEP) {
      /* y0 + (y1 - y0) (10 x^3 - 15 x^4 + 6 x^5), x = (t - t0) / (t1 - t0) */
      if (MAGGI_RE(time) <= MAGGI_RE(p[k])) {
        fund[i][0] = pd[k + 2];
        fund[i][1] = 0.0;
        fund[i][2] = 0.0;
      } else if (MAGGI_RE(time) >= MAGGI_RE(p[k + 1])) {
        fund[i][0] = pd[k + 3];
        fund[i][1] = 0.0;
        fund[i][2] = 0.0;
      } else {
        p_k3 = p[k];
        p_k3d = pd[k];
        h = p[k + 1] - p_k3;
        hd = pd[k + 1] - p_k3d;
        x = (time - p_k3) / h;
        hinv = 1.0 / h;
        xd = (-p_k3d - x * hd) * hinv;
        p_k2_2 = p[k + 2];
        p_k2_2d = pd[k + 2];
        p_k3_2 = p[k + 3];
        p_k3_2d = pd[k + 3];
        fund[i][0] = p_k2_2d + (((((p_k3_2d - p_k2_2d) * x + (p_k3_2 - p_k2_2) * xd) * x + (p_k3_2 -
            p_k2_2) * x * xd) * x + (p_k3_2 - p_k2_2) * x * x * xd) * (10.0 + x * (-15.0 + 6.0 * x))
            + (p_k3_2 - p_k2_2) * x * x * x * (xd * (-15.0 + 6.0 * x) + x * (6.0 * xd)));
        t7 = (p_k3_2 - p_k2_2) / h;
        t7d = (p_k3_2d - p_k2_2d - t7 * hd) * hinv;
        fund[i][1] = ((t7d * 30.0 * x + t7 * 30.0 * xd) * x + t7 * 30.0 * x * xd) * (1.0 + x * (-2.0
            + x)) + t7 * 30.0 * x * x * (xd * (-2.0 + x) + x * xd);
        t8 = h * h;
        t8d = hd * h + h * hd;
        t9 = (p_k3_2 - p_k2_2) / t8;
        t8inv = 1.0 / t8;
        t9d = (p_k3_2d - p_k2_2d - t9 * t8d) * t8inv;
        fund[i][2] = (t9d * 60.0 * x + t9 * 60.0 * xd) * (1.0 + x * (-3.0 + 2.0 * x)) + t9 * 60.0 *
            x * (xd * (-3.0 + 2.0 * x) + x * (2.0 * xd));
      }
    } else if (t->funkind[i] == MAGGI_FUNCTION_KNOTS) {
      k3 = piece_nodiff(t->np, p, k, t->funn[i], time);
      is_k3 = k3 < 0;
      if (is_k3) {
        k3 = 0;
      }
      is_k3_2 = k3 > t->funn[i] - 2;
      if (is_k3_2) {
        k3 = t->funn[i] - 2;
      }
      is_k3_3 = MAGGI_RE(time) <= MAGGI_RE(p[k + k3]);
      /* y0 + (y1 - y0) (10 x^3 - 15 x^4 + 6 x^5), x = (t - t0) / (t1 - t0) */
      if (is_k3_3) {
        fund[i][0] = pd[k + t->funn[i] + k3];
        fund[i][1] = 0.0;
        fund[i][2] = 0.0;
      } else {
        is_k3_4 = MAGGI_RE(time) >= MAGGI_RE(p[k + k3 + 1]);
        if (is_k3_4) {
          fund[i][0] = pd[k + t->funn[i] + k3 + 1];
          fund[i][1] = 0.0;
          fund[i][2] = 0.0;
        } else {
          p_kk3 = p[k + k3];
          p_kk3d = pd[k + k3];
          h2 = p[k + k3 + 1] - p_kk3;
          h2d = pd[k + k3 + 1] - p_kk3d;
          x2 = (time - p_kk3) / h2;
          h2inv = 1.0 / h2;
          x2d = (-p_kk3d - x2 * h2d) * h2inv;
          p_kik3 = p[k + t->funn[i] + k3];
          p_kik3d = pd[k + t->funn[i] + k3];
          p_kik31 = p[k + t->funn[i] + k3 + 1];
          p_kik31d = pd[k + t->funn[i] + k3 + 1];
          fund[i][0] = p_kik3d + (((((p_kik31d - p_kik3d) * x2 + (p_kik31 - p_kik3) * x2d) * x2 +
              (p_kik31 - p_kik3) * x2 * x2d) * x2 + (p_kik31 - p_kik3) * x2 * x2 * x2d) * (10.0 + x2
              * (-15.0 + 6.0 * x2)) + (p_kik31 - p_kik3) * x2 * x2 * x2 * (x2d * (-15.0 + 6.0 * x2)
              + x2 * (6.0 * x2d)));
          t10 = (p_kik31 - p_kik3) / h2;
          t10d = (p_kik31d - p_kik3d - t10 * h2d) * h2inv;
          fund[i][1] = ((t10d * 30.0 * x2 + t10 * 30.0 * x2d) * x2 + t10 * 30.0 * x2 * x2d) * (1.0 +
              x2 * (-2.0 + x2)) + t10 * 30.0 * x2 * x2 * (x2d * (-2.0 + x2) + x2 * x2d);
          t11 = h2 * h2;
          t11d = h2d * h2 + h2 * h2d;
          t12 = (p_kik31 - p_kik3) / t11;
          t11inv = 1.0 / t11;
          t12d = (p_kik31d - p_kik3d - t12 * t11d) * t11inv;
          fund[i][2] = (t12d * 60.0 * x2 + t12 * 60.0 * x2d) * (1.0 + x2 * (-3.0 + 2.0 * x2)) + t12
              * 60.0 * x2 * (x2d * (-3.0 + 2.0 * x2) + x2 * (2.0 * x2d));
        }
      }
    } else {
      k4 = piece_nodiff(t->np, p, k, t->funn[i], time);
      if (k4 < 0) {
        p_k4 = p[k];
        p_k4d = pd[k];
        h3 = p[k + 1] - p_k4;
        h3d = pd[k + 1] - p_k4d;
        p_ki = p[k + t->funn[i]];
        p_kid = pd[k + t->funn[i]];
        t13 = (p[k + t->funn[i] + 1] - p_ki) / h3;
        h3inv = 1.0 / h3;
        t13d = (pd[k + t->funn[i] + 1] - p_kid - t13 * h3d) * h3inv;
        slope = t13 - h3 / 6.0 * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] +
            1][0]);
        sloped = t13d - (h3d / 6.0 * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] +
            1][0]) + h3 / 6.0 * (2.0 * spline0d[t->funspline[i]][0] + spline0d[t->funspline[i] +
            1][0]));
        fund[i][0] = p_kid + (sloped * (time - p_k4) - slope * p_k4d);
        fund[i][1] = sloped;
        fund[i][2] = 0.0;
      } else if (k4 > t->funn[i] - 2) {
        p_ki1 = p[k + t->funn[i] - 1];
        p_ki1d = pd[k + t->funn[i] - 1];
        h3_2 = p_ki1 - p[k + t->funn[i] - 2];
        h3_2d = p_ki1d - pd[k + t->funn[i] - 2];
        p_kii1 = p[k + t->funn[i] + t->funn[i] - 1];
        p_kii1d = pd[k + t->funn[i] + t->funn[i] - 1];
        t14 = (p_kii1 - p[k + t->funn[i] + t->funn[i] - 2]) / h3_2;
        h3_2inv = 1.0 / h3_2;
        t14d = (p_kii1d - pd[k + t->funn[i] + t->funn[i] - 2] - t14 * h3_2d) * h3_2inv;
        slope2 = t14 + h3_2 / 6.0 * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]);
        slope2d = t14d + (h3_2d / 6.0 * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]) + h3_2 / 6.0 * (spline0d[t->funspline[i] +
            t->funn[i] - 2][0] + 2.0 * spline0d[t->funspline[i] + t->funn[i] - 1][0]));
        fund[i][0] = p_kii1d + (slope2d * (time - p_ki1) - slope2 * p_ki1d);
        fund[i][1] = slope2d;
        fund[i][2] = 0.0;
      } else {
        p_kk41 = p[k + k4 + 1];
        p_kk41d = pd[k + k4 + 1];
        p_kk4 = p[k + k4];
        p_kk4d = pd[k + k4];
        h3_3 = p_kk41 - p_kk4;
        h3_3d = p_kk41d - p_kk4d;
        a = p_kk41 - time;
        ad = p_kk41d;
        c2 = time - p_kk4;
        c2d = -p_kk4d;
        p_kik4 = p[k + t->funn[i] + k4];
        p_kik4d = pd[k + t->funn[i] + k4];
        t15 = (p[k + t->funn[i] + k4 + 1] - p_kik4) / h3_3;
        h3_3inv = 1.0 / h3_3;
        t15d = (pd[k + t->funn[i] + k4 + 1] - p_kik4d - t15 * h3_3d) * h3_3inv;
        spline0_ik410 = spline0[t->funspline[i] + k4 + 1][0];
        spline0_ik410d = spline0d[t->funspline[i] + k4 + 1][0];
        spline0_ik40 = spline0[t->funspline[i] + k4][0];
        spline0_ik40d = spline0d[t->funspline[i] + k4][0];
        e = t15 - h3_3 / 6.0 * (spline0_ik410 - spline0_ik40);
        ed = t15d - (h3_3d / 6.0 * (spline0_ik410 - spline0_ik40) + h3_3 / 6.0 * (spline0_ik410d -
            spline0_ik40d));
        t16 = 6.0 * h3_3;
        t16d = 6.0 * h3_3d;
        t17 = (spline0_ik40 * a * a * a + spline0_ik410 * c2 * c2 * c2) / t16;
        t16inv = 1.0 / t16;
        t17d = (((spline0_ik40d * a + spline0_ik40 * ad) * a + spline0_ik40 * a * ad) * a +
            spline0_ik40 * a * a * ad + (((spline0_ik410d * c2 + spline0_ik410 * c2d) * c2 +
            spline0_ik410 * c2 * c2d) * c2 + spline0_ik410 * c2 * c2 * c2d) - t17 * t16d) * t16inv;
        fund[i][0] = t17d + p_kik4d - ((spline0_ik40d * h3_3 + spline0_ik40 * h3_3d) * h3_3 +
            spline0_ik40 * h3_3 * h3_3d) / 6.0 + (ed * c2 + e * c2d);
        t18 = 2.0 * h3_3;
        t18d = 2.0 * h3_3d;
        t19 = (spline0_ik410 * c2 * c2 - spline0_ik40 * a * a) / t18;
        t18inv = 1.0 / t18;
        t19d = ((spline0_ik410d * c2 + spline0_ik410 * c2d) * c2 + spline0_ik410 * c2 * c2d -
            ((spline0_ik40d * a + spline0_ik40 * ad) * a + spline0_ik40 * a * ad) - t19 * t18d) *
            t18inv;
        fund[i][1] = t19d + ed;
        t20 = (spline0_ik40 * a + spline0_ik410 * c2) / h3_3;
        t20d = (spline0_ik40d * a + spline0_ik40 * ad + (spline0_ik410d * c2 + spline0_ik410 * c2d)
            - t20 * h3_3d) * h3_3inv;
        fund[i][2] = t20d;
      }
    }
  }
}
