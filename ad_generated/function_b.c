/* Adjoint of core/kernel/function.c.
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

void maggi_spline_constants_b(const maggi_topo *t, const double p[restrict t->np],
                              double pb[restrict t->np], double spline0[restrict t->nspline][3],
                              double spline0b[restrict t->nspline][3])
{
  int i, k;
  double e0, e0b, e1, e1b, h0, h0b, h1, h1b, p_iik, p_iikb, p_ik, p_ikb, t2, t2b, tb2, tb3, tb4,
      tb5, tb6, tb7, tb8, tb9, w, wb;

  for (i = t->nfun - 1; i >= 0; --i) {
    if (t->funkind[i] == MAGGI_FUNCTION_SPLINE) {
      for (k = 1; k <= t->funn[i] - 2; ++k) {
        tb9 = spline0b[t->funspline[i] + k][0];
        spline0b[t->funspline[i] + k][0] = 0.0;
        spline0b[t->funspline[i] + k][1] += tb9;
        spline0b[t->funspline[i] + k][2] -= tb9 * spline0[t->funspline[i] + k + 1][0];
        spline0b[t->funspline[i] + k + 1][0] -= tb9 * spline0[t->funspline[i] + k][2];
      }
      spline0b[t->funspline[i] + t->funn[i] - 1][0] = 0.0;
      spline0b[t->funspline[i]][0] = 0.0;
      for (k = t->funn[i] - 2; k >= 1; --k) {
        p_ik = p[t->funadr[i] + k];
        h0 = p_ik - p[t->funadr[i] + k - 1];
        h1 = p[t->funadr[i] + k + 1] - p_ik;
        p_iik = p[t->funadr[i] + t->funn[i] + k];
        e0 = (p_iik - p[t->funadr[i] + t->funn[i] + k - 1]) / h0;
        e1 = (p[t->funadr[i] + t->funn[i] + k + 1] - p_iik) / h1;
        w = 2.0 * (h0 + h1) - h0 * spline0[t->funspline[i] + k - 1][2];
        t2 = spline0[t->funspline[i] + k][1];
        tb7 = spline0b[t->funspline[i] + k][2];
        spline0b[t->funspline[i] + k][2] = 0.0;
        tb8 = tb7 / w;
        h1b = tb8;
        wb = -(tb8 * spline0[t->funspline[i] + k][2]);
        t2b = spline0b[t->funspline[i] + k][1];
        spline0b[t->funspline[i] + k][1] = 0.0;
        tb5 = t2b / w;
        tb6 = tb5 * 6.0;
        e1b = tb6;
        e0b = -tb6;
        h0b = -(tb5 * spline0[t->funspline[i] + k - 1][1]);
        spline0b[t->funspline[i] + k - 1][1] -= tb5 * h0;
        wb -= tb5 * t2;
        tb4 = wb * 2.0;
        h0b += tb4;
        h1b += tb4;
        h0b -= wb * spline0[t->funspline[i] + k - 1][2];
        spline0b[t->funspline[i] + k - 1][2] -= wb * h0;
        tb3 = e1b / h1;
        pb[t->funadr[i] + t->funn[i] + k + 1] += tb3;
        p_iikb = -tb3;
        h1b -= tb3 * e1;
        tb2 = e0b / h0;
        p_iikb += tb2;
        pb[t->funadr[i] + t->funn[i] + k - 1] -= tb2;
        h0b -= tb2 * e0;
        pb[t->funadr[i] + t->funn[i] + k] += p_iikb;
        pb[t->funadr[i] + k + 1] += h1b;
        p_ikb = -h1b;
        p_ikb += h0b;
        pb[t->funadr[i] + k - 1] -= h0b;
        pb[t->funadr[i] + k] += p_ikb;
      }
      spline0b[t->funspline[i]][2] = 0.0;
      /* natural cubic spline through (t_k, y_k): second derivatives m_k from the tridiagonal system
       *   h_{k-1} m_{k-1} + 2 (h_{k-1} + h_k) m_k + h_k m_{k+1} = 6 (e_k - e_{k-1}),  e = slope of a piece
       * by elimination, m = 0 at the ends.  Columns of s: m, and what the elimination needs. */
      spline0b[t->funspline[i]][1] = 0.0;
    }
  }
}

void maggi_functions_b(const maggi_topo *t, const double p[restrict t->np],
                       double pb[restrict t->np], const double spline0[restrict t->nspline][3],
                       double spline0b[restrict t->nspline][3], double time,
                       double fun[restrict t->nfun][3], double funb[restrict t->nfun][3])
{
  int i, is_k3, is_k3_2, is_k3_3, is_k3_4, k, k2, k3, k4;
  double a, ab, c, c2, c2b, cb, e, eb, h, h2, h2b, h3, h3_2, h3_2b, h3_3, h3_3b, h3b, hb, p_k, p_k1,
      p_k1b, p_k2, p_k2_2, p_k2_2b, p_k2b, p_k3, p_k3_2, p_k3_2b, p_k3b, p_k4, p_k4b, p_kb, p_ki,
      p_ki1, p_ki1b, p_kib, p_kii1, p_kii1b, p_kik3, p_kik31, p_kik31b, p_kik3b, p_kik4, p_kik4b,
      p_kk2b, p_kk3, p_kk3b, p_kk4, p_kk41, p_kk41b, p_kk4b, s, sb, slope, slope2, slope2b, slopeb,
      spline0_ik40, spline0_ik40b, spline0_ik410, spline0_ik410b, t10, t10b, t11, t11b, t12, t12b,
      t13, t13b, t14, t14b, t15, t15b, t16, t16b, t17, t17b, t18, t18b, t19, t19b, t2, t20, t20b,
      t3, t4, t5, t5b, t6, t6b, t7, t7b, t8, t8b, t9, t9b, tb10, tb11, tb12, tb13, tb14, tb15, tb16,
      tb17, tb18, tb19, tb2, tb20, tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3, tb30,
      tb31, tb32, tb33, tb34, tb35, tb36, tb37, tb38, tb39, tb4, tb40, tb41, tb42, tb43, tb44, tb45,
      tb46, tb47, tb48, tb49, tb5, tb50, tb51, tb52, tb53, tb54, tb55, tb56, tb57, tb58, tb59, tb6,
      tb60, tb7, tb8, tb9, x, x2, x2b, xb;

  (void)fun;
  for (i = t->nfun - 1; i >= 0; --i) {
    k = t->funadr[i];
    if (t->funkind[i] == MAGGI_FUNCTION_CONSTANT) {
      funb[i][2] = 0.0;
      funb[i][1] = 0.0;
      pb[k] += funb[i][0];
      funb[i][0] = 0.0;
    } else if (t->funkind[i] == MAGGI_FUNCTION_POLYNOMIAL) {
      for (k2 = t->funn[i] - 1; k2 >= 1; --k2) {
        t2 = pow(time, k2);
        t3 = pow(time, k2 - 1);
        if (k2 > 1) {
          t4 = pow(time, k2 - 2);
          pb[k + k2] += funb[i][2] * t4 * (k2 - 1) * k2;
        }
        p_kk2b = funb[i][1] * t3 * k2;
        p_kk2b += funb[i][0] * t2;
        pb[k + k2] += p_kk2b;
      }
      funb[i][2] = 0.0;
      funb[i][1] = 0.0;
      /* sum_k c_k t^k */
      pb[k] += funb[i][0];
      funb[i][0] = 0.0;
    } else if (t->funkind[i] == MAGGI_FUNCTION_SINE) {
      p_k1 = p[k + 1];
      p_k2 = p[k + 2];
      t5 = p_k1 * time + p_k2;
      s = sin(t5);
      t6 = p_k1 * time + p_k2;
      c = cos(t6);
      p_k = p[k];
      tb5 = funb[i][2];
      funb[i][2] = 0.0;
      tb6 = tb5 * s;
      tb7 = tb6 * p_k1;
      p_kb = -(tb7 * p_k1);
      p_k1b = -(tb7 * p_k);
      p_k1b += tb6 * (-p_k * p_k1);
      sb = tb5 * (-p_k * p_k1 * p_k1);
      tb3 = funb[i][1];
      funb[i][1] = 0.0;
      tb4 = tb3 * c;
      p_kb += tb4 * p_k1;
      p_k1b += tb4 * p_k;
      cb = tb3 * (p_k * p_k1);
      tb2 = funb[i][0];
      funb[i][0] = 0.0;
      pb[k + 3] += tb2;
      p_kb += tb2 * s;
      sb += tb2 * p_k;
      pb[k] += p_kb;
      t6b = -(cb * sin(t6));
      p_k1b += t6b * time;
      p_k2b = t6b;
      t5b = sb * cos(t5);
      p_k1b += t5b * time;
      p_k2b += t5b;
      pb[k + 2] += p_k2b;
      pb[k + 1] += p_k1b;
    } else if (t->funkind[i] == MAGGI_FUNCTION_STEP) {
      /* y0 + (y1 - y0) (10 x^3 - 15 x^4 + 6 x^5), x = (t - t0) / (t1 - t0) */
      if (MAGGI_RE(time) <= MAGGI_RE(p[k])) {
        funb[i][2] = 0.0;
        funb[i][1] = 0.0;
        pb[k + 2] += funb[i][0];
        funb[i][0] = 0.0;
      } else if (MAGGI_RE(time) >= MAGGI_RE(p[k + 1])) {
        funb[i][2] = 0.0;
        funb[i][1] = 0.0;
        pb[k + 3] += funb[i][0];
        funb[i][0] = 0.0;
      } else {
        p_k3 = p[k];
        h = p[k + 1] - p_k3;
        x = (time - p_k3) / h;
        p_k2_2 = p[k + 2];
        p_k3_2 = p[k + 3];
        t7 = (p_k3_2 - p_k2_2) / h;
        t8 = h * h;
        t9 = (p_k3_2 - p_k2_2) / t8;
        tb21 = funb[i][2];
        funb[i][2] = 0.0;
        tb22 = tb21 * (1.0 + x * (-3.0 + 2.0 * x));
        t9b = tb22 * x * 60.0;
        xb = tb22 * (t9 * 60.0);
        tb23 = tb21 * (t9 * 60.0 * x);
        xb += tb23 * (-3.0 + 2.0 * x);
        xb += tb23 * x * 2.0;
        tb20 = t9b / t8;
        p_k3_2b = tb20;
        p_k2_2b = -tb20;
        t8b = -(tb20 * t9);
        hb = t8b * h;
        hb += t8b * h;
        tb16 = funb[i][1];
        funb[i][1] = 0.0;
        tb17 = tb16 * (1.0 + x * (-2.0 + x));
        tb18 = tb17 * x;
        t7b = tb18 * x * 30.0;
        xb += tb18 * (t7 * 30.0);
        xb += tb17 * (t7 * 30.0 * x);
        tb19 = tb16 * (t7 * 30.0 * x * x);
        xb += tb19 * (-2.0 + x);
        xb += tb19 * x;
        tb15 = t7b / h;
        p_k3_2b += tb15;
        p_k2_2b -= tb15;
        hb -= tb15 * t7;
        tb9 = funb[i][0];
        funb[i][0] = 0.0;
        p_k2_2b += tb9;
        tb10 = tb9 * (10.0 + x * (-15.0 + 6.0 * x));
        tb11 = tb10 * x;
        tb12 = tb11 * x;
        tb13 = tb12 * x;
        p_k3_2b += tb13;
        p_k2_2b -= tb13;
        xb += tb12 * (p_k3_2 - p_k2_2);
        xb += tb11 * ((p_k3_2 - p_k2_2) * x);
        xb += tb10 * ((p_k3_2 - p_k2_2) * x * x);
        tb14 = tb9 * ((p_k3_2 - p_k2_2) * x * x * x);
        xb += tb14 * (-15.0 + 6.0 * x);
        xb += tb14 * x * 6.0;
        pb[k + 3] += p_k3_2b;
        pb[k + 2] += p_k2_2b;
        tb8 = xb / h;
        p_k3b = -tb8;
        hb -= tb8 * x;
        pb[k + 1] += hb;
        p_k3b -= hb;
        pb[k] += p_k3b;
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
        funb[i][2] = 0.0;
        funb[i][1] = 0.0;
        pb[k + t->funn[i] + k3] += funb[i][0];
        funb[i][0] = 0.0;
      } else {
        is_k3_4 = MAGGI_RE(time) >= MAGGI_RE(p[k + k3 + 1]);
        if (is_k3_4) {
          funb[i][2] = 0.0;
          funb[i][1] = 0.0;
          pb[k + t->funn[i] + k3 + 1] += funb[i][0];
          funb[i][0] = 0.0;
        } else {
          p_kk3 = p[k + k3];
          h2 = p[k + k3 + 1] - p_kk3;
          x2 = (time - p_kk3) / h2;
          p_kik3 = p[k + t->funn[i] + k3];
          p_kik31 = p[k + t->funn[i] + k3 + 1];
          t10 = (p_kik31 - p_kik3) / h2;
          t11 = h2 * h2;
          t12 = (p_kik31 - p_kik3) / t11;
          tb37 = funb[i][2];
          funb[i][2] = 0.0;
          tb38 = tb37 * (1.0 + x2 * (-3.0 + 2.0 * x2));
          t12b = tb38 * x2 * 60.0;
          x2b = tb38 * (t12 * 60.0);
          tb39 = tb37 * (t12 * 60.0 * x2);
          x2b += tb39 * (-3.0 + 2.0 * x2);
          x2b += tb39 * x2 * 2.0;
          tb36 = t12b / t11;
          p_kik31b = tb36;
          p_kik3b = -tb36;
          t11b = -(tb36 * t12);
          h2b = t11b * h2;
          h2b += t11b * h2;
          tb32 = funb[i][1];
          funb[i][1] = 0.0;
          tb33 = tb32 * (1.0 + x2 * (-2.0 + x2));
          tb34 = tb33 * x2;
          t10b = tb34 * x2 * 30.0;
          x2b += tb34 * (t10 * 30.0);
          x2b += tb33 * (t10 * 30.0 * x2);
          tb35 = tb32 * (t10 * 30.0 * x2 * x2);
          x2b += tb35 * (-2.0 + x2);
          x2b += tb35 * x2;
          tb31 = t10b / h2;
          p_kik31b += tb31;
          p_kik3b -= tb31;
          h2b -= tb31 * t10;
          tb25 = funb[i][0];
          funb[i][0] = 0.0;
          p_kik3b += tb25;
          tb26 = tb25 * (10.0 + x2 * (-15.0 + 6.0 * x2));
          tb27 = tb26 * x2;
          tb28 = tb27 * x2;
          tb29 = tb28 * x2;
          p_kik31b += tb29;
          p_kik3b -= tb29;
          x2b += tb28 * (p_kik31 - p_kik3);
          x2b += tb27 * ((p_kik31 - p_kik3) * x2);
          x2b += tb26 * ((p_kik31 - p_kik3) * x2 * x2);
          tb30 = tb25 * ((p_kik31 - p_kik3) * x2 * x2 * x2);
          x2b += tb30 * (-15.0 + 6.0 * x2);
          x2b += tb30 * x2 * 6.0;
          pb[k + t->funn[i] + k3 + 1] += p_kik31b;
          pb[k + t->funn[i] + k3] += p_kik3b;
          tb24 = x2b / h2;
          p_kk3b = -tb24;
          h2b -= tb24 * x2;
          pb[k + k3 + 1] += h2b;
          p_kk3b -= h2b;
          pb[k + k3] += p_kk3b;
        }
      }
    } else {
      k4 = piece_nodiff(t->np, p, k, t->funn[i], time);
      if (k4 < 0) {
        p_k4 = p[k];
        h3 = p[k + 1] - p_k4;
        p_ki = p[k + t->funn[i]];
        t13 = (p[k + t->funn[i] + 1] - p_ki) / h3;
        slope = t13 - h3 / 6.0 * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] +
            1][0]);
        funb[i][2] = 0.0;
        slopeb = funb[i][1];
        funb[i][1] = 0.0;
        tb42 = funb[i][0];
        funb[i][0] = 0.0;
        p_kib = tb42;
        slopeb += tb42 * (time - p_k4);
        p_k4b = -(tb42 * slope);
        t13b = slopeb;
        h3b = -(slopeb * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] + 1][0]) /
            6.0);
        tb41 = slopeb * (h3 / 6.0);
        spline0b[t->funspline[i]][0] -= tb41 * 2.0;
        spline0b[t->funspline[i] + 1][0] -= tb41;
        tb40 = t13b / h3;
        pb[k + t->funn[i] + 1] += tb40;
        p_kib -= tb40;
        h3b -= tb40 * t13;
        pb[k + t->funn[i]] += p_kib;
        pb[k + 1] += h3b;
        p_k4b -= h3b;
        pb[k] += p_k4b;
      } else if (k4 > t->funn[i] - 2) {
        p_ki1 = p[k + t->funn[i] - 1];
        h3_2 = p_ki1 - p[k + t->funn[i] - 2];
        p_kii1 = p[k + t->funn[i] + t->funn[i] - 1];
        t14 = (p_kii1 - p[k + t->funn[i] + t->funn[i] - 2]) / h3_2;
        slope2 = t14 + h3_2 / 6.0 * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]);
        funb[i][2] = 0.0;
        slope2b = funb[i][1];
        funb[i][1] = 0.0;
        tb45 = funb[i][0];
        funb[i][0] = 0.0;
        p_kii1b = tb45;
        slope2b += tb45 * (time - p_ki1);
        p_ki1b = -(tb45 * slope2);
        t14b = slope2b;
        h3_2b = slope2b * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]) / 6.0;
        tb44 = slope2b * (h3_2 / 6.0);
        spline0b[t->funspline[i] + t->funn[i] - 2][0] += tb44;
        spline0b[t->funspline[i] + t->funn[i] - 1][0] += tb44 * 2.0;
        tb43 = t14b / h3_2;
        p_kii1b += tb43;
        pb[k + t->funn[i] + t->funn[i] - 2] -= tb43;
        h3_2b -= tb43 * t14;
        pb[k + t->funn[i] + t->funn[i] - 1] += p_kii1b;
        p_ki1b += h3_2b;
        pb[k + t->funn[i] - 2] -= h3_2b;
        pb[k + t->funn[i] - 1] += p_ki1b;
      } else {
        p_kk41 = p[k + k4 + 1];
        p_kk4 = p[k + k4];
        h3_3 = p_kk41 - p_kk4;
        a = p_kk41 - time;
        c2 = time - p_kk4;
        p_kik4 = p[k + t->funn[i] + k4];
        t15 = (p[k + t->funn[i] + k4 + 1] - p_kik4) / h3_3;
        spline0_ik410 = spline0[t->funspline[i] + k4 + 1][0];
        spline0_ik40 = spline0[t->funspline[i] + k4][0];
        e = t15 - h3_3 / 6.0 * (spline0_ik410 - spline0_ik40);
        t16 = 6.0 * h3_3;
        t17 = (spline0_ik40 * a * a * a + spline0_ik410 * c2 * c2 * c2) / t16;
        t18 = 2.0 * h3_3;
        t19 = (spline0_ik410 * c2 * c2 - spline0_ik40 * a * a) / t18;
        t20 = (spline0_ik40 * a + spline0_ik410 * c2) / h3_3;
        t20b = funb[i][2];
        funb[i][2] = 0.0;
        tb60 = t20b / h3_3;
        spline0_ik40b = tb60 * a;
        ab = tb60 * spline0_ik40;
        spline0_ik410b = tb60 * c2;
        c2b = tb60 * spline0_ik410;
        h3_3b = -(tb60 * t20);
        tb59 = funb[i][1];
        funb[i][1] = 0.0;
        t19b = tb59;
        eb = tb59;
        tb56 = t19b / t18;
        tb57 = tb56 * c2;
        spline0_ik410b += tb57 * c2;
        c2b += tb57 * spline0_ik410;
        c2b += tb56 * (spline0_ik410 * c2);
        tb58 = tb56 * a;
        spline0_ik40b -= tb58 * a;
        ab -= tb58 * spline0_ik40;
        ab -= tb56 * (spline0_ik40 * a);
        t18b = -(tb56 * t19);
        h3_3b += t18b * 2.0;
        tb53 = funb[i][0];
        funb[i][0] = 0.0;
        t17b = tb53;
        p_kik4b = tb53;
        tb54 = tb53 / 6.0;
        tb55 = tb54 * h3_3;
        spline0_ik40b -= tb55 * h3_3;
        h3_3b -= tb55 * spline0_ik40;
        h3_3b -= tb54 * (spline0_ik40 * h3_3);
        eb += tb53 * c2;
        c2b += tb53 * e;
        tb48 = t17b / t16;
        tb49 = tb48 * a;
        tb50 = tb49 * a;
        spline0_ik40b += tb50 * a;
        ab += tb50 * spline0_ik40;
        ab += tb49 * (spline0_ik40 * a);
        ab += tb48 * (spline0_ik40 * a * a);
        tb51 = tb48 * c2;
        tb52 = tb51 * c2;
        spline0_ik410b += tb52 * c2;
        c2b += tb52 * spline0_ik410;
        c2b += tb51 * (spline0_ik410 * c2);
        c2b += tb48 * (spline0_ik410 * c2 * c2);
        t16b = -(tb48 * t17);
        h3_3b += t16b * 6.0;
        t15b = eb;
        h3_3b -= eb * (spline0_ik410 - spline0_ik40) / 6.0;
        tb47 = eb * (h3_3 / 6.0);
        spline0_ik410b -= tb47;
        spline0_ik40b += tb47;
        spline0b[t->funspline[i] + k4][0] += spline0_ik40b;
        spline0b[t->funspline[i] + k4 + 1][0] += spline0_ik410b;
        tb46 = t15b / h3_3;
        pb[k + t->funn[i] + k4 + 1] += tb46;
        p_kik4b -= tb46;
        h3_3b -= tb46 * t15;
        pb[k + t->funn[i] + k4] += p_kik4b;
        p_kk4b = -c2b;
        p_kk41b = ab;
        p_kk41b += h3_3b;
        p_kk4b -= h3_3b;
        pb[k + k4] += p_kk4b;
        pb[k + k4 + 1] += p_kk41b;
      }
    }
  }
}
