/* Adjoint of core/kernel/function.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

void maggi_spline_constants_b(const maggi_topo *t, const double p[restrict t->np],
                              double pb[restrict t->np], double spline0[restrict t->nspline][3],
                              double spline0b[restrict t->nspline][3])
{
  int i, k, k2;
  double e0, e0_2, e0_2b, e0b, e1, e1_2, e1_2b, e1b, h0, h0_2, h0_2b, h0b, h1, h1_2, h1_2b, h1b,
      p_iik, p_iik2, p_iik2b, p_iikb, p_ik, p_ik2, p_ik2b, p_ikb, t2, t2b, t3, t3b, tb10, tb11,
      tb12, tb13, tb14, tb15, tb16, tb17, tb2, tb3, tb4, tb5, tb6, tb7, tb8, tb9, w, w2, w2b, wb;

  for (i = t->nroad - 1; i >= 0; --i) {
    if (t->roadkind[i] == MAGGI_ROAD_PROFILE) {
      for (k2 = 1; k2 <= t->roadn[i] - 2; ++k2) {
        tb17 = spline0b[t->roadspline[i] + k2][0];
        spline0b[t->roadspline[i] + k2][0] = 0.0;
        spline0b[t->roadspline[i] + k2][1] += tb17;
        spline0b[t->roadspline[i] + k2][2] -= tb17 * spline0[t->roadspline[i] + k2 + 1][0];
        spline0b[t->roadspline[i] + k2 + 1][0] -= tb17 * spline0[t->roadspline[i] + k2][2];
      }
      spline0b[t->roadspline[i] + t->roadn[i] - 1][0] = 0.0;
      spline0b[t->roadspline[i]][0] = 0.0;
      for (k2 = t->roadn[i] - 2; k2 >= 1; --k2) {
        p_ik2 = p[t->roadadr[i] + k2];
        h0_2 = p_ik2 - p[t->roadadr[i] + k2 - 1];
        h1_2 = p[t->roadadr[i] + k2 + 1] - p_ik2;
        p_iik2 = p[t->roadadr[i] + t->roadn[i] + k2];
        e0_2 = (p_iik2 - p[t->roadadr[i] + t->roadn[i] + k2 - 1]) / h0_2;
        e1_2 = (p[t->roadadr[i] + t->roadn[i] + k2 + 1] - p_iik2) / h1_2;
        w2 = 2.0 * (h0_2 + h1_2) - h0_2 * spline0[t->roadspline[i] + k2 - 1][2];
        t3 = spline0[t->roadspline[i] + k2][1];
        tb15 = spline0b[t->roadspline[i] + k2][2];
        spline0b[t->roadspline[i] + k2][2] = 0.0;
        tb16 = tb15 / w2;
        h1_2b = tb16;
        w2b = -(tb16 * spline0[t->roadspline[i] + k2][2]);
        t3b = spline0b[t->roadspline[i] + k2][1];
        spline0b[t->roadspline[i] + k2][1] = 0.0;
        tb13 = t3b / w2;
        tb14 = tb13 * 6.0;
        e1_2b = tb14;
        e0_2b = -tb14;
        h0_2b = -(tb13 * spline0[t->roadspline[i] + k2 - 1][1]);
        spline0b[t->roadspline[i] + k2 - 1][1] -= tb13 * h0_2;
        w2b -= tb13 * t3;
        tb12 = w2b * 2.0;
        h0_2b += tb12;
        h1_2b += tb12;
        h0_2b -= w2b * spline0[t->roadspline[i] + k2 - 1][2];
        spline0b[t->roadspline[i] + k2 - 1][2] -= w2b * h0_2;
        tb11 = e1_2b / h1_2;
        pb[t->roadadr[i] + t->roadn[i] + k2 + 1] += tb11;
        p_iik2b = -tb11;
        h1_2b -= tb11 * e1_2;
        tb10 = e0_2b / h0_2;
        p_iik2b += tb10;
        pb[t->roadadr[i] + t->roadn[i] + k2 - 1] -= tb10;
        h0_2b -= tb10 * e0_2;
        pb[t->roadadr[i] + t->roadn[i] + k2] += p_iik2b;
        pb[t->roadadr[i] + k2 + 1] += h1_2b;
        p_ik2b = -h1_2b;
        p_ik2b += h0_2b;
        pb[t->roadadr[i] + k2 - 1] -= h0_2b;
        pb[t->roadadr[i] + k2] += p_ik2b;
      }
      spline0b[t->roadspline[i]][2] = 0.0;
      spline0b[t->roadspline[i]][1] = 0.0;
    }
  }
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
      spline0b[t->funspline[i]][1] = 0.0;
    }
  }
}

void maggi_functions_b(const maggi_topo *t, const double p[restrict t->np],
                       double pb[restrict t->np], const double spline0[restrict t->nspline][3],
                       double spline0b[restrict t->nspline][3], double time,
                       double fun[restrict t->nfun][3], double funb[restrict t->nfun][3])
{
  int i, is_k2, is_k2_2, is_k2_3, is_k2_4, k, k2, k3;
  double a, ab, c, c2, c2b, cb, e, eb, f0b, f1b, f2b, h, h2, h2b, h3, h3b, h4, h4_2, h4_2b, h4_3,
      h4_3b, h4b, hb, moves, p_i, p_i1, p_i1b, p_i2, p_i2_2, p_i2_2b, p_i2b, p_i3, p_i3_2, p_i3_2b,
      p_i3_3, p_i3_3b, p_i3_4, p_i3_4b, p_i3b, p_i4, p_i4b, p_i5, p_i5b, p_ib, p_ii, p_ii1, p_ii1b,
      p_iib, p_iii1, p_iii1b, p_iik2, p_iik21, p_iik21b, p_iik2b, p_iik3, p_iik3b, p_ik2, p_ik2b,
      p_ik3, p_ik31, p_ik31b, p_ik3b, p_ikb, s, sb, slope, slope2, slope2b, slopeb, spline0_ik30,
      spline0_ik30b, spline0_ik310, spline0_ik310b, t10, t10b, t11, t11b, t12, t12b, t13, t13b, t14,
      t14b, t15, t15b, t16, t16b, t17, t17b, t18, t18b, t19, t19b, t2, t20, t20b, t21, t21b, t3, t4,
      t5, t5b, t6, t6b, t7, t7b, t8, t8b, t9, t9b, tb10, tb11, tb12, tb13, tb14, tb15, tb16, tb17,
      tb18, tb19, tb2, tb20, tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3, tb30, tb31,
      tb32, tb33, tb34, tb35, tb36, tb37, tb38, tb39, tb4, tb40, tb41, tb42, tb43, tb44, tb45, tb46,
      tb47, tb48, tb49, tb5, tb50, tb51, tb52, tb53, tb54, tb55, tb56, tb57, tb58, tb59, tb6, tb60,
      tb61, tb62, tb63, tb64, tb7, tb8, tb9, x, x2, x2b, x3, x3b, xb;

  (void)fun;
  t4 = 0.0;
  for (i = t->nfun - 1; i >= 0; --i) {
    moves = t->funheld[i] ? 0.0 : 1.0;
    f2b = funb[i][2] * moves;
    funb[i][2] = 0.0;
    f1b = funb[i][1] * moves;
    funb[i][1] = 0.0;
    f0b = funb[i][0];
    funb[i][0] = 0.0;
    /* of one function */
    if (t->funkind[i] == MAGGI_FUNCTION_CONSTANT) {
      f2b = 0.0;
      f1b = 0.0;
      pb[t->funadr[i]] += f0b;
      f0b = 0.0;
    } else if (t->funkind[i] == MAGGI_FUNCTION_POLYNOMIAL) {
      for (k = t->funn[i] - 1; k >= 1; --k) {
        t2 = pow(time, k);
        t3 = pow(time, k - 1);
        if (k > 1) {
          t4 = pow(time, k - 2);
        }
        if (k > 1) {
          pb[t->funadr[i] + k] += f2b * t4 * (k - 1) * k;
        }
        p_ikb = f1b * t3 * k;
        p_ikb += f0b * t2;
        pb[t->funadr[i] + k] += p_ikb;
      }
      f2b = 0.0;
      f1b = 0.0;
      /* sum_k c_k t^k */
      pb[t->funadr[i]] += f0b;
      f0b = 0.0;
    } else if (t->funkind[i] == MAGGI_FUNCTION_SINE) {
      p_i1 = p[t->funadr[i] + 1];
      p_i2 = p[t->funadr[i] + 2];
      t5 = p_i1 * time + p_i2;
      s = sin(t5);
      t6 = p_i1 * time + p_i2;
      c = cos(t6);
      p_i = p[t->funadr[i]];
      tb3 = f2b * s;
      tb4 = tb3 * p_i1;
      p_ib = -(tb4 * p_i1);
      p_i1b = -(tb4 * p_i);
      p_i1b += tb3 * (-p_i * p_i1);
      sb = f2b * (-p_i * p_i1 * p_i1);
      f2b = 0.0;
      tb2 = f1b * c;
      p_ib += tb2 * p_i1;
      p_i1b += tb2 * p_i;
      cb = f1b * (p_i * p_i1);
      f1b = 0.0;
      pb[t->funadr[i] + 3] += f0b;
      p_ib += f0b * s;
      sb += f0b * p_i;
      f0b = 0.0;
      pb[t->funadr[i]] += p_ib;
      t6b = -(cb * sin(t6));
      p_i1b += t6b * time;
      p_i2b = t6b;
      t5b = sb * cos(t5);
      p_i1b += t5b * time;
      p_i2b += t5b;
      pb[t->funadr[i] + 2] += p_i2b;
      pb[t->funadr[i] + 1] += p_i1b;
    } else if (t->funkind[i] == MAGGI_FUNCTION_STEP) {
      /* y0 + (y1 - y0) (10 x^3 - 15 x^4 + 6 x^5), x = (t - t0) / (t1 - t0) */
      if (MAGGI_RE(time) <= MAGGI_RE(p[t->funadr[i]])) {
        f2b = 0.0;
        f1b = 0.0;
        pb[t->funadr[i] + 2] += f0b;
        f0b = 0.0;
      } else if (MAGGI_RE(time) >= MAGGI_RE(p[t->funadr[i] + 1])) {
        f2b = 0.0;
        f1b = 0.0;
        pb[t->funadr[i] + 3] += f0b;
        f0b = 0.0;
      } else {
        p_i3 = p[t->funadr[i]];
        h = p[t->funadr[i] + 1] - p_i3;
        x = (time - p_i3) / h;
        p_i2_2 = p[t->funadr[i] + 2];
        p_i3_2 = p[t->funadr[i] + 3];
        t7 = (p_i3_2 - p_i2_2) / h;
        t8 = h * h;
        t9 = (p_i3_2 - p_i2_2) / t8;
        tb16 = f2b * (1.0 + x * (-3.0 + 2.0 * x));
        t9b = tb16 * x * 60.0;
        xb = tb16 * (t9 * 60.0);
        tb17 = f2b * (t9 * 60.0 * x);
        xb += tb17 * (-3.0 + 2.0 * x);
        xb += tb17 * x * 2.0;
        f2b = 0.0;
        tb15 = t9b / t8;
        p_i3_2b = tb15;
        p_i2_2b = -tb15;
        t8b = -(tb15 * t9);
        hb = t8b * h;
        hb += t8b * h;
        tb12 = f1b * (1.0 + x * (-2.0 + x));
        tb13 = tb12 * x;
        t7b = tb13 * x * 30.0;
        xb += tb13 * (t7 * 30.0);
        xb += tb12 * (t7 * 30.0 * x);
        tb14 = f1b * (t7 * 30.0 * x * x);
        xb += tb14 * (-2.0 + x);
        xb += tb14 * x;
        f1b = 0.0;
        tb11 = t7b / h;
        p_i3_2b += tb11;
        p_i2_2b -= tb11;
        hb -= tb11 * t7;
        p_i2_2b += f0b;
        tb6 = f0b * (10.0 + x * (-15.0 + 6.0 * x));
        tb7 = tb6 * x;
        tb8 = tb7 * x;
        tb9 = tb8 * x;
        p_i3_2b += tb9;
        p_i2_2b -= tb9;
        xb += tb8 * (p_i3_2 - p_i2_2);
        xb += tb7 * ((p_i3_2 - p_i2_2) * x);
        xb += tb6 * ((p_i3_2 - p_i2_2) * x * x);
        tb10 = f0b * ((p_i3_2 - p_i2_2) * x * x * x);
        xb += tb10 * (-15.0 + 6.0 * x);
        xb += tb10 * x * 6.0;
        f0b = 0.0;
        pb[t->funadr[i] + 3] += p_i3_2b;
        pb[t->funadr[i] + 2] += p_i2_2b;
        tb5 = xb / h;
        p_i3b = -tb5;
        hb -= tb5 * x;
        pb[t->funadr[i] + 1] += hb;
        p_i3b -= hb;
        pb[t->funadr[i]] += p_i3b;
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
        f2b = 0.0;
        f1b = 0.0;
        pb[t->funadr[i] + t->funn[i] + k2] += f0b;
        f0b = 0.0;
      } else {
        is_k2_4 = MAGGI_RE(time) >= MAGGI_RE(p[t->funadr[i] + k2 + 1]);
        if (is_k2_4) {
          f2b = 0.0;
          f1b = 0.0;
          pb[t->funadr[i] + t->funn[i] + k2 + 1] += f0b;
          f0b = 0.0;
        } else {
          p_ik2 = p[t->funadr[i] + k2];
          h2 = p[t->funadr[i] + k2 + 1] - p_ik2;
          x2 = (time - p_ik2) / h2;
          p_iik2 = p[t->funadr[i] + t->funn[i] + k2];
          p_iik21 = p[t->funadr[i] + t->funn[i] + k2 + 1];
          t10 = (p_iik21 - p_iik2) / h2;
          t11 = h2 * h2;
          t12 = (p_iik21 - p_iik2) / t11;
          tb29 = f2b * (1.0 + x2 * (-3.0 + 2.0 * x2));
          t12b = tb29 * x2 * 60.0;
          x2b = tb29 * (t12 * 60.0);
          tb30 = f2b * (t12 * 60.0 * x2);
          x2b += tb30 * (-3.0 + 2.0 * x2);
          x2b += tb30 * x2 * 2.0;
          f2b = 0.0;
          tb28 = t12b / t11;
          p_iik21b = tb28;
          p_iik2b = -tb28;
          t11b = -(tb28 * t12);
          h2b = t11b * h2;
          h2b += t11b * h2;
          tb25 = f1b * (1.0 + x2 * (-2.0 + x2));
          tb26 = tb25 * x2;
          t10b = tb26 * x2 * 30.0;
          x2b += tb26 * (t10 * 30.0);
          x2b += tb25 * (t10 * 30.0 * x2);
          tb27 = f1b * (t10 * 30.0 * x2 * x2);
          x2b += tb27 * (-2.0 + x2);
          x2b += tb27 * x2;
          f1b = 0.0;
          tb24 = t10b / h2;
          p_iik21b += tb24;
          p_iik2b -= tb24;
          h2b -= tb24 * t10;
          p_iik2b += f0b;
          tb19 = f0b * (10.0 + x2 * (-15.0 + 6.0 * x2));
          tb20 = tb19 * x2;
          tb21 = tb20 * x2;
          tb22 = tb21 * x2;
          p_iik21b += tb22;
          p_iik2b -= tb22;
          x2b += tb21 * (p_iik21 - p_iik2);
          x2b += tb20 * ((p_iik21 - p_iik2) * x2);
          x2b += tb19 * ((p_iik21 - p_iik2) * x2 * x2);
          tb23 = f0b * ((p_iik21 - p_iik2) * x2 * x2 * x2);
          x2b += tb23 * (-15.0 + 6.0 * x2);
          x2b += tb23 * x2 * 6.0;
          f0b = 0.0;
          pb[t->funadr[i] + t->funn[i] + k2 + 1] += p_iik21b;
          pb[t->funadr[i] + t->funn[i] + k2] += p_iik2b;
          tb18 = x2b / h2;
          p_ik2b = -tb18;
          h2b -= tb18 * x2;
          pb[t->funadr[i] + k2 + 1] += h2b;
          p_ik2b -= h2b;
          pb[t->funadr[i] + k2] += p_ik2b;
        }
      }
    } else if (t->funkind[i] == MAGGI_FUNCTION_RAMP) {
      p_i4 = p[t->funadr[i]];
      h3 = p[t->funadr[i] + 1] - p_i4;
      x3 = (time - p_i4) / h3;
      h3b = 0.0;
      x3b = 0.0;
      if (MAGGI_RE(time) <= MAGGI_RE(p[t->funadr[i]])) {
        f2b = 0.0;
        f1b = 0.0;
        pb[t->funadr[i] + 2] += f0b;
        f0b = 0.0;
      } else if (MAGGI_RE(time) >= MAGGI_RE(p[t->funadr[i] + 1])) {
        p_i3_3 = p[t->funadr[i] + 3];
        f2b = 0.0;
        p_i3_3b = f1b;
        f1b = 0.0;
        pb[t->funadr[i] + 2] += f0b;
        p_i3_3b += f0b * (time - 0.5 * (p[t->funadr[i]] + p[t->funadr[i] + 1]));
        tb32 = f0b * p_i3_3;
        tb33 = tb32 * 0.5;
        pb[t->funadr[i]] -= tb33;
        pb[t->funadr[i] + 1] -= tb33;
        f0b = 0.0;
        pb[t->funadr[i] + 3] += p_i3_3b;
      } else {
        p_i3_4 = p[t->funadr[i] + 3];
        t13 = p_i3_4 / h3;
        tb45 = f2b * (1.0 + x3 * (-2.0 + x3));
        tb46 = tb45 * x3;
        t13b = tb46 * x3 * 30.0;
        x3b += tb46 * (t13 * 30.0);
        x3b += tb45 * (t13 * 30.0 * x3);
        tb47 = f2b * (t13 * 30.0 * x3 * x3);
        x3b += tb47 * (-2.0 + x3);
        x3b += tb47 * x3;
        f2b = 0.0;
        tb44 = t13b / h3;
        p_i3_4b = tb44;
        h3b -= tb44 * t13;
        tb40 = f1b * (10.0 + x3 * (-15.0 + 6.0 * x3));
        tb41 = tb40 * x3;
        tb42 = tb41 * x3;
        p_i3_4b += tb42 * x3;
        x3b += tb42 * p_i3_4;
        x3b += tb41 * (p_i3_4 * x3);
        x3b += tb40 * (p_i3_4 * x3 * x3);
        tb43 = f1b * (p_i3_4 * x3 * x3 * x3);
        x3b += tb43 * (-15.0 + 6.0 * x3);
        x3b += tb43 * x3 * 6.0;
        f1b = 0.0;
        pb[t->funadr[i] + 2] += f0b;
        tb34 = f0b * (2.5 + x3 * (-3.0 + x3));
        tb35 = tb34 * x3;
        tb36 = tb35 * x3;
        tb37 = tb36 * x3;
        tb38 = tb37 * x3;
        p_i3_4b += tb38 * h3;
        h3b += tb38 * p_i3_4;
        x3b += tb37 * (p_i3_4 * h3);
        x3b += tb36 * (p_i3_4 * h3 * x3);
        x3b += tb35 * (p_i3_4 * h3 * x3 * x3);
        x3b += tb34 * (p_i3_4 * h3 * x3 * x3 * x3);
        tb39 = f0b * (p_i3_4 * h3 * x3 * x3 * x3 * x3);
        x3b += tb39 * (-3.0 + x3);
        x3b += tb39 * x3;
        f0b = 0.0;
        pb[t->funadr[i] + 3] += p_i3_4b;
      }
      tb31 = x3b / h3;
      p_i4b = -tb31;
      h3b -= tb31 * x3;
      /* y0, then its rate rises as a quintic step, h x^4 (5/2 - 3 x + x^2), then it is straight */
      pb[t->funadr[i] + 1] += h3b;
      p_i4b -= h3b;
      pb[t->funadr[i]] += p_i4b;
    } else {
      k3 = maggi_piece(t->np, p, t->funadr[i], t->funn[i], time);
      if (k3 < 0) {
        p_i5 = p[t->funadr[i]];
        h4 = p[t->funadr[i] + 1] - p_i5;
        p_ii = p[t->funadr[i] + t->funn[i]];
        t14 = (p[t->funadr[i] + t->funn[i] + 1] - p_ii) / h4;
        slope = t14 - h4 / 6.0 * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] +
            1][0]);
        f2b = 0.0;
        slopeb = f1b;
        f1b = 0.0;
        p_iib = f0b;
        slopeb += f0b * (time - p_i5);
        p_i5b = -(f0b * slope);
        f0b = 0.0;
        t14b = slopeb;
        h4b = -(slopeb * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] + 1][0]) /
            6.0);
        tb49 = slopeb * (h4 / 6.0);
        spline0b[t->funspline[i]][0] -= tb49 * 2.0;
        spline0b[t->funspline[i] + 1][0] -= tb49;
        tb48 = t14b / h4;
        pb[t->funadr[i] + t->funn[i] + 1] += tb48;
        p_iib -= tb48;
        h4b -= tb48 * t14;
        pb[t->funadr[i] + t->funn[i]] += p_iib;
        pb[t->funadr[i] + 1] += h4b;
        p_i5b -= h4b;
        pb[t->funadr[i]] += p_i5b;
      } else if (k3 > t->funn[i] - 2) {
        p_ii1 = p[t->funadr[i] + t->funn[i] - 1];
        h4_2 = p_ii1 - p[t->funadr[i] + t->funn[i] - 2];
        p_iii1 = p[t->funadr[i] + t->funn[i] + t->funn[i] - 1];
        t15 = (p_iii1 - p[t->funadr[i] + t->funn[i] + t->funn[i] - 2]) / h4_2;
        slope2 = t15 + h4_2 / 6.0 * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]);
        f2b = 0.0;
        slope2b = f1b;
        f1b = 0.0;
        p_iii1b = f0b;
        slope2b += f0b * (time - p_ii1);
        p_ii1b = -(f0b * slope2);
        f0b = 0.0;
        t15b = slope2b;
        h4_2b = slope2b * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]) / 6.0;
        tb51 = slope2b * (h4_2 / 6.0);
        spline0b[t->funspline[i] + t->funn[i] - 2][0] += tb51;
        spline0b[t->funspline[i] + t->funn[i] - 1][0] += tb51 * 2.0;
        tb50 = t15b / h4_2;
        p_iii1b += tb50;
        pb[t->funadr[i] + t->funn[i] + t->funn[i] - 2] -= tb50;
        h4_2b -= tb50 * t15;
        pb[t->funadr[i] + t->funn[i] + t->funn[i] - 1] += p_iii1b;
        p_ii1b += h4_2b;
        pb[t->funadr[i] + t->funn[i] - 2] -= h4_2b;
        pb[t->funadr[i] + t->funn[i] - 1] += p_ii1b;
      } else {
        p_ik31 = p[t->funadr[i] + k3 + 1];
        p_ik3 = p[t->funadr[i] + k3];
        h4_3 = p_ik31 - p_ik3;
        a = p_ik31 - time;
        c2 = time - p_ik3;
        p_iik3 = p[t->funadr[i] + t->funn[i] + k3];
        t16 = (p[t->funadr[i] + t->funn[i] + k3 + 1] - p_iik3) / h4_3;
        spline0_ik310 = spline0[t->funspline[i] + k3 + 1][0];
        spline0_ik30 = spline0[t->funspline[i] + k3][0];
        e = t16 - h4_3 / 6.0 * (spline0_ik310 - spline0_ik30);
        t17 = 6.0 * h4_3;
        t18 = (spline0_ik30 * a * a * a + spline0_ik310 * c2 * c2 * c2) / t17;
        t19 = 2.0 * h4_3;
        t20 = (spline0_ik310 * c2 * c2 - spline0_ik30 * a * a) / t19;
        t21 = (spline0_ik30 * a + spline0_ik310 * c2) / h4_3;
        t21b = f2b;
        f2b = 0.0;
        tb64 = t21b / h4_3;
        spline0_ik30b = tb64 * a;
        ab = tb64 * spline0_ik30;
        spline0_ik310b = tb64 * c2;
        c2b = tb64 * spline0_ik310;
        h4_3b = -(tb64 * t21);
        t20b = f1b;
        eb = f1b;
        f1b = 0.0;
        tb61 = t20b / t19;
        tb62 = tb61 * c2;
        spline0_ik310b += tb62 * c2;
        c2b += tb62 * spline0_ik310;
        c2b += tb61 * (spline0_ik310 * c2);
        tb63 = tb61 * a;
        spline0_ik30b -= tb63 * a;
        ab -= tb63 * spline0_ik30;
        ab -= tb61 * (spline0_ik30 * a);
        t19b = -(tb61 * t20);
        h4_3b += t19b * 2.0;
        t18b = f0b;
        p_iik3b = f0b;
        tb59 = f0b / 6.0;
        tb60 = tb59 * h4_3;
        spline0_ik30b -= tb60 * h4_3;
        h4_3b -= tb60 * spline0_ik30;
        h4_3b -= tb59 * (spline0_ik30 * h4_3);
        eb += f0b * c2;
        c2b += f0b * e;
        f0b = 0.0;
        tb54 = t18b / t17;
        tb55 = tb54 * a;
        tb56 = tb55 * a;
        spline0_ik30b += tb56 * a;
        ab += tb56 * spline0_ik30;
        ab += tb55 * (spline0_ik30 * a);
        ab += tb54 * (spline0_ik30 * a * a);
        tb57 = tb54 * c2;
        tb58 = tb57 * c2;
        spline0_ik310b += tb58 * c2;
        c2b += tb58 * spline0_ik310;
        c2b += tb57 * (spline0_ik310 * c2);
        c2b += tb54 * (spline0_ik310 * c2 * c2);
        t17b = -(tb54 * t18);
        h4_3b += t17b * 6.0;
        t16b = eb;
        h4_3b -= eb * (spline0_ik310 - spline0_ik30) / 6.0;
        tb53 = eb * (h4_3 / 6.0);
        spline0_ik310b -= tb53;
        spline0_ik30b += tb53;
        spline0b[t->funspline[i] + k3][0] += spline0_ik30b;
        spline0b[t->funspline[i] + k3 + 1][0] += spline0_ik310b;
        tb52 = t16b / h4_3;
        pb[t->funadr[i] + t->funn[i] + k3 + 1] += tb52;
        p_iik3b -= tb52;
        h4_3b -= tb52 * t16;
        pb[t->funadr[i] + t->funn[i] + k3] += p_iik3b;
        p_ik3b = -c2b;
        p_ik31b = ab;
        p_ik31b += h4_3b;
        p_ik3b -= h4_3b;
        pb[t->funadr[i] + k3] += p_ik3b;
        pb[t->funadr[i] + k3 + 1] += p_ik31b;
      }
    }
  }
}
