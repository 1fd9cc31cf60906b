/* Tangent of the adjoint of core/kernel/function.c.
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

void maggi_spline_constants_b_d(const maggi_topo *t, const double p[restrict t->np],
                                const double pd[restrict t->np], double pb[restrict t->np],
                                double pbd[restrict t->np], double spline0[restrict t->nspline][3],
                                double spline0d[restrict t->nspline][3],
                                double spline0b[restrict t->nspline][3],
                                double spline0bd[restrict t->nspline][3])
{
  int i, k;
  double e0, e0b, e0bd, e0d, e1, e1b, e1bd, e1d, h0, h0b, h0bd, h0d, h1, h1b, h1bd, h1d, p_iik,
      p_iikb, p_iikbd, p_iikd, p_ik, p_ikb, p_ikbd, p_ikd, t2, t2b, t2bd, t2d, tb2, tb2d, tb3, tb3d,
      tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d, w, wb, wbd, wd;

  for (i = t->nfun - 1; i >= 0; --i) {
    if (t->funkind[i] == MAGGI_FUNCTION_SPLINE) {
      for (k = 1; k <= t->funn[i] - 2; ++k) {
        tb9 = spline0b[t->funspline[i] + k][0];
        tb9d = spline0bd[t->funspline[i] + k][0];
        spline0b[t->funspline[i] + k][0] = 0.0;
        spline0bd[t->funspline[i] + k][0] = 0.0;
        spline0b[t->funspline[i] + k][1] += tb9;
        spline0bd[t->funspline[i] + k][1] += tb9d;
        spline0b[t->funspline[i] + k][2] -= tb9 * spline0[t->funspline[i] + k + 1][0];
        spline0bd[t->funspline[i] + k][2] -= tb9d * spline0[t->funspline[i] + k + 1][0] + tb9 *
            spline0d[t->funspline[i] + k + 1][0];
        spline0b[t->funspline[i] + k + 1][0] -= tb9 * spline0[t->funspline[i] + k][2];
        spline0bd[t->funspline[i] + k + 1][0] -= tb9d * spline0[t->funspline[i] + k][2] + tb9 *
            spline0d[t->funspline[i] + k][2];
      }
      spline0b[t->funspline[i] + t->funn[i] - 1][0] = 0.0;
      spline0bd[t->funspline[i] + t->funn[i] - 1][0] = 0.0;
      spline0b[t->funspline[i]][0] = 0.0;
      spline0bd[t->funspline[i]][0] = 0.0;
      for (k = t->funn[i] - 2; k >= 1; --k) {
        p_ik = p[t->funadr[i] + k];
        p_ikd = pd[t->funadr[i] + k];
        h0 = p_ik - p[t->funadr[i] + k - 1];
        h0d = p_ikd - pd[t->funadr[i] + k - 1];
        h1 = p[t->funadr[i] + k + 1] - p_ik;
        h1d = pd[t->funadr[i] + k + 1] - p_ikd;
        p_iik = p[t->funadr[i] + t->funn[i] + k];
        p_iikd = pd[t->funadr[i] + t->funn[i] + k];
        e0 = (p_iik - p[t->funadr[i] + t->funn[i] + k - 1]) / h0;
        e0d = (p_iikd - pd[t->funadr[i] + t->funn[i] + k - 1] - e0 * h0d) * (1.0 / h0);
        e1 = (p[t->funadr[i] + t->funn[i] + k + 1] - p_iik) / h1;
        e1d = (pd[t->funadr[i] + t->funn[i] + k + 1] - p_iikd - e1 * h1d) * (1.0 / h1);
        w = 2.0 * (h0 + h1) - h0 * spline0[t->funspline[i] + k - 1][2];
        wd = 2.0 * (h0d + h1d) - (h0d * spline0[t->funspline[i] + k - 1][2] + h0 *
            spline0d[t->funspline[i] + k - 1][2]);
        t2 = spline0[t->funspline[i] + k][1];
        t2d = spline0d[t->funspline[i] + k][1];
        tb7 = spline0b[t->funspline[i] + k][2];
        tb7d = spline0bd[t->funspline[i] + k][2];
        spline0b[t->funspline[i] + k][2] = 0.0;
        spline0bd[t->funspline[i] + k][2] = 0.0;
        tb8 = tb7 / w;
        tb8d = (tb7d - tb8 * wd) * (1.0 / w);
        h1b = tb8;
        h1bd = tb8d;
        wb = -(tb8 * spline0[t->funspline[i] + k][2]);
        wbd = -(tb8d * spline0[t->funspline[i] + k][2] + tb8 * spline0d[t->funspline[i] + k][2]);
        t2b = spline0b[t->funspline[i] + k][1];
        t2bd = spline0bd[t->funspline[i] + k][1];
        spline0b[t->funspline[i] + k][1] = 0.0;
        spline0bd[t->funspline[i] + k][1] = 0.0;
        tb5 = t2b / w;
        tb5d = (t2bd - tb5 * wd) * (1.0 / w);
        tb6 = tb5 * 6.0;
        tb6d = tb5d * 6.0;
        e1b = tb6;
        e1bd = tb6d;
        e0b = -tb6;
        e0bd = -tb6d;
        h0b = -(tb5 * spline0[t->funspline[i] + k - 1][1]);
        h0bd = -(tb5d * spline0[t->funspline[i] + k - 1][1] + tb5 * spline0d[t->funspline[i] + k -
            1][1]);
        spline0b[t->funspline[i] + k - 1][1] -= tb5 * h0;
        spline0bd[t->funspline[i] + k - 1][1] -= tb5d * h0 + tb5 * h0d;
        wb -= tb5 * t2;
        wbd -= tb5d * t2 + tb5 * t2d;
        tb4 = wb * 2.0;
        tb4d = wbd * 2.0;
        h0b += tb4;
        h0bd += tb4d;
        h1b += tb4;
        h1bd += tb4d;
        h0b -= wb * spline0[t->funspline[i] + k - 1][2];
        h0bd -= wbd * spline0[t->funspline[i] + k - 1][2] + wb * spline0d[t->funspline[i] + k -
            1][2];
        spline0b[t->funspline[i] + k - 1][2] -= wb * h0;
        spline0bd[t->funspline[i] + k - 1][2] -= wbd * h0 + wb * h0d;
        tb3 = e1b / h1;
        tb3d = (e1bd - tb3 * h1d) * (1.0 / h1);
        pb[t->funadr[i] + t->funn[i] + k + 1] += tb3;
        pbd[t->funadr[i] + t->funn[i] + k + 1] += tb3d;
        p_iikb = -tb3;
        p_iikbd = -tb3d;
        h1b -= tb3 * e1;
        h1bd -= tb3d * e1 + tb3 * e1d;
        tb2 = e0b / h0;
        tb2d = (e0bd - tb2 * h0d) * (1.0 / h0);
        p_iikb += tb2;
        p_iikbd += tb2d;
        pb[t->funadr[i] + t->funn[i] + k - 1] -= tb2;
        pbd[t->funadr[i] + t->funn[i] + k - 1] -= tb2d;
        h0b -= tb2 * e0;
        h0bd -= tb2d * e0 + tb2 * e0d;
        pb[t->funadr[i] + t->funn[i] + k] += p_iikb;
        pbd[t->funadr[i] + t->funn[i] + k] += p_iikbd;
        pb[t->funadr[i] + k + 1] += h1b;
        pbd[t->funadr[i] + k + 1] += h1bd;
        p_ikb = -h1b;
        p_ikbd = -h1bd;
        p_ikb += h0b;
        p_ikbd += h0bd;
        pb[t->funadr[i] + k - 1] -= h0b;
        pbd[t->funadr[i] + k - 1] -= h0bd;
        pb[t->funadr[i] + k] += p_ikb;
        pbd[t->funadr[i] + k] += p_ikbd;
      }
      spline0b[t->funspline[i]][2] = 0.0;
      spline0bd[t->funspline[i]][2] = 0.0;
      spline0b[t->funspline[i]][1] = 0.0;
      /* natural cubic spline through (t_k, y_k): second derivatives m_k from the tridiagonal system
       *   h_{k-1} m_{k-1} + 2 (h_{k-1} + h_k) m_k + h_k m_{k+1} = 6 (e_k - e_{k-1}),  e = slope of a piece
       * by elimination, m = 0 at the ends.  Columns of s: m, and what the elimination needs. */
      spline0bd[t->funspline[i]][1] = 0.0;
    }
  }
}

void maggi_functions_b_d(const maggi_topo *t, const double p[restrict t->np],
                         const double pd[restrict t->np], double pb[restrict t->np],
                         double pbd[restrict t->np], const double spline0[restrict t->nspline][3],
                         const double spline0d[restrict t->nspline][3],
                         double spline0b[restrict t->nspline][3],
                         double spline0bd[restrict t->nspline][3], double time,
                         double fun[restrict t->nfun][3], double fund[restrict t->nfun][3],
                         double funb[restrict t->nfun][3], double funbd[restrict t->nfun][3])
{
  int i, is_k3, is_k3_2, is_k3_3, is_k3_4, k, k2, k3, k4;
  double a, ab, abd, ad, c, c2, c2b, c2bd, c2d, cb, cbd, cd, e, eb, ebd, ed, h, h2, h2b, h2bd, h2d,
      h3, h3_2, h3_2b, h3_2bd, h3_2d, h3_3, h3_3b, h3_3bd, h3_3d, h3b, h3bd, h3d, hb, hbd, hd, p_k,
      p_k1, p_k1b, p_k1bd, p_k1d, p_k2, p_k2_2, p_k2_2b, p_k2_2bd, p_k2_2d, p_k2b, p_k2bd, p_k2d,
      p_k3, p_k3_2, p_k3_2b, p_k3_2bd, p_k3_2d, p_k3b, p_k3bd, p_k3d, p_k4, p_k4b, p_k4bd, p_k4d,
      p_kb, p_kbd, p_kd, p_ki, p_ki1, p_ki1b, p_ki1bd, p_ki1d, p_kib, p_kibd, p_kid, p_kii1,
      p_kii1b, p_kii1bd, p_kii1d, p_kik3, p_kik31, p_kik31b, p_kik31bd, p_kik31d, p_kik3b, p_kik3bd,
      p_kik3d, p_kik4, p_kik4b, p_kik4bd, p_kik4d, p_kk2b, p_kk2bd, p_kk3, p_kk3b, p_kk3bd, p_kk3d,
      p_kk4, p_kk41, p_kk41b, p_kk41bd, p_kk41d, p_kk4b, p_kk4bd, p_kk4d, s, sb, sbd, sd, slope,
      slope2, slope2b, slope2bd, slope2d, slopeb, slopebd, sloped, spline0_ik40, spline0_ik40b,
      spline0_ik40bd, spline0_ik40d, spline0_ik410, spline0_ik410b, spline0_ik410bd, spline0_ik410d,
      t10, t10b, t10bd, t10d, t11, t11b, t11bd, t11d, t12, t12b, t12bd, t12d, t13, t13b, t13bd,
      t13d, t14, t14b, t14bd, t14d, t15, t15b, t15bd, t15d, t16, t16b, t16bd, t16d, t17, t17b,
      t17bd, t17d, t18, t18b, t18bd, t18d, t19, t19b, t19bd, t19d, t2, t20, t20b, t20bd, t20d, t3,
      t4, t5, t5b, t5bd, t5d, t6, t6b, t6bd, t6d, t7, t7b, t7bd, t7d, t8, t8b, t8bd, t8d, t9, t9b,
      t9bd, t9d, tb10, tb10d, tb11, tb11d, tb12, tb12d, tb13, tb13d, tb14, tb14d, tb15, tb15d, tb16,
      tb16d, tb17, tb17d, tb18, tb18d, tb19, tb19d, tb2, tb20, tb20d, tb21, tb21d, tb22, tb22d,
      tb23, tb23d, tb24, tb24d, tb25, tb25d, tb26, tb26d, tb27, tb27d, tb28, tb28d, tb29, tb29d,
      tb2d, tb3, tb30, tb30d, tb31, tb31d, tb32, tb32d, tb33, tb33d, tb34, tb34d, tb35, tb35d, tb36,
      tb36d, tb37, tb37d, tb38, tb38d, tb39, tb39d, tb3d, tb4, tb40, tb40d, tb41, tb41d, tb42,
      tb42d, tb43, tb43d, tb44, tb44d, tb45, tb45d, tb46, tb46d, tb47, tb47d, tb48, tb48d, tb49,
      tb49d, tb4d, tb5, tb50, tb50d, tb51, tb51d, tb52, tb52d, tb53, tb53d, tb54, tb54d, tb55,
      tb55d, tb56, tb56d, tb57, tb57d, tb58, tb58d, tb59, tb59d, tb5d, tb6, tb60, tb60d, tb6d, tb7,
      tb7d, tb8, tb8d, tb9, tb9d, x, x2, x2b, x2bd, x2d, xb, xbd, xd;

  (void)fun;
  (void)fund;
  for (i = t->nfun - 1; i >= 0; --i) {
    k = t->funadr[i];
    if (t->funkind[i] == MAGGI_FUNCTION_CONSTANT) {
      funb[i][2] = 0.0;
      funbd[i][2] = 0.0;
      funb[i][1] = 0.0;
      funbd[i][1] = 0.0;
      pb[k] += funb[i][0];
      pbd[k] += funbd[i][0];
      funb[i][0] = 0.0;
      funbd[i][0] = 0.0;
    } else if (t->funkind[i] == MAGGI_FUNCTION_POLYNOMIAL) {
      for (k2 = t->funn[i] - 1; k2 >= 1; --k2) {
        t2 = pow(time, k2);
        t3 = pow(time, k2 - 1);
        if (k2 > 1) {
          t4 = pow(time, k2 - 2);
          pb[k + k2] += funb[i][2] * t4 * (k2 - 1) * k2;
          pbd[k + k2] += funbd[i][2] * t4 * (k2 - 1) * k2;
        }
        p_kk2b = funb[i][1] * t3 * k2;
        p_kk2bd = funbd[i][1] * t3 * k2;
        p_kk2b += funb[i][0] * t2;
        p_kk2bd += funbd[i][0] * t2;
        pb[k + k2] += p_kk2b;
        pbd[k + k2] += p_kk2bd;
      }
      funb[i][2] = 0.0;
      funbd[i][2] = 0.0;
      funb[i][1] = 0.0;
      funbd[i][1] = 0.0;
      pb[k] += funb[i][0];
      /* sum_k c_k t^k */
      pbd[k] += funbd[i][0];
      funb[i][0] = 0.0;
      funbd[i][0] = 0.0;
    } else if (t->funkind[i] == MAGGI_FUNCTION_SINE) {
      p_k1 = p[k + 1];
      p_k1d = pd[k + 1];
      p_k2 = p[k + 2];
      p_k2d = pd[k + 2];
      t5 = p_k1 * time + p_k2;
      t5d = p_k1d * time + p_k2d;
      s = sin(t5);
      sd = cos(t5) * t5d;
      t6 = p_k1 * time + p_k2;
      t6d = p_k1d * time + p_k2d;
      c = cos(t6);
      cd = -(sin(t6) * t6d);
      p_k = p[k];
      p_kd = pd[k];
      tb5 = funb[i][2];
      tb5d = funbd[i][2];
      funb[i][2] = 0.0;
      funbd[i][2] = 0.0;
      tb6 = tb5 * s;
      tb6d = tb5d * s + tb5 * sd;
      tb7 = tb6 * p_k1;
      tb7d = tb6d * p_k1 + tb6 * p_k1d;
      p_kb = -(tb7 * p_k1);
      p_kbd = -(tb7d * p_k1 + tb7 * p_k1d);
      p_k1b = -(tb7 * p_k);
      p_k1bd = -(tb7d * p_k + tb7 * p_kd);
      p_k1b += tb6 * (-p_k * p_k1);
      p_k1bd += tb6d * (-p_k * p_k1) + tb6 * (-(p_kd * p_k1) - p_k * p_k1d);
      sb = tb5 * (-p_k * p_k1 * p_k1);
      sbd = tb5d * (-p_k * p_k1 * p_k1) + tb5 * ((-(p_kd * p_k1) - p_k * p_k1d) * p_k1 + -p_k * p_k1
          * p_k1d);
      tb3 = funb[i][1];
      tb3d = funbd[i][1];
      funb[i][1] = 0.0;
      funbd[i][1] = 0.0;
      tb4 = tb3 * c;
      tb4d = tb3d * c + tb3 * cd;
      p_kb += tb4 * p_k1;
      p_kbd += tb4d * p_k1 + tb4 * p_k1d;
      p_k1b += tb4 * p_k;
      p_k1bd += tb4d * p_k + tb4 * p_kd;
      cb = tb3 * (p_k * p_k1);
      cbd = tb3d * (p_k * p_k1) + tb3 * (p_kd * p_k1 + p_k * p_k1d);
      tb2 = funb[i][0];
      tb2d = funbd[i][0];
      funb[i][0] = 0.0;
      funbd[i][0] = 0.0;
      pb[k + 3] += tb2;
      pbd[k + 3] += tb2d;
      p_kb += tb2 * s;
      p_kbd += tb2d * s + tb2 * sd;
      sb += tb2 * p_k;
      sbd += tb2d * p_k + tb2 * p_kd;
      pb[k] += p_kb;
      pbd[k] += p_kbd;
      t6b = -(cb * sin(t6));
      t6bd = -(cbd * sin(t6) + cb * (cos(t6) * t6d));
      p_k1b += t6b * time;
      p_k1bd += t6bd * time;
      p_k2b = t6b;
      p_k2bd = t6bd;
      t5b = sb * cos(t5);
      t5bd = sbd * cos(t5) - sb * (sin(t5) * t5d);
      p_k1b += t5b * time;
      p_k1bd += t5bd * time;
      p_k2b += t5b;
      p_k2bd += t5bd;
      pb[k + 2] += p_k2b;
      pbd[k + 2] += p_k2bd;
      pb[k + 1] += p_k1b;
      pbd[k + 1] += p_k1bd;
    } else if (t->funkind[i] == MAGGI_FUNCTION_STEP) {
      /* y0 + (y1 - y0) (10 x^3 - 15 x^4 + 6 x^5), x = (t - t0) / (t1 - t0) */
      if (MAGGI_RE(time) <= MAGGI_RE(p[k])) {
        funb[i][2] = 0.0;
        funbd[i][2] = 0.0;
        funb[i][1] = 0.0;
        funbd[i][1] = 0.0;
        pb[k + 2] += funb[i][0];
        pbd[k + 2] += funbd[i][0];
        funb[i][0] = 0.0;
        funbd[i][0] = 0.0;
      } else if (MAGGI_RE(time) >= MAGGI_RE(p[k + 1])) {
        funb[i][2] = 0.0;
        funbd[i][2] = 0.0;
        funb[i][1] = 0.0;
        funbd[i][1] = 0.0;
        pb[k + 3] += funb[i][0];
        pbd[k + 3] += funbd[i][0];
        funb[i][0] = 0.0;
        funbd[i][0] = 0.0;
      } else {
        p_k3 = p[k];
        p_k3d = pd[k];
        h = p[k + 1] - p_k3;
        hd = pd[k + 1] - p_k3d;
        x = (time - p_k3) / h;
        xd = (-p_k3d - x * hd) * (1.0 / h);
        p_k2_2 = p[k + 2];
        p_k2_2d = pd[k + 2];
        p_k3_2 = p[k + 3];
        p_k3_2d = pd[k + 3];
        t7 = (p_k3_2 - p_k2_2) / h;
        t7d = (p_k3_2d - p_k2_2d - t7 * hd) * (1.0 / h);
        t8 = h * h;
        t8d = hd * h + h * hd;
        t9 = (p_k3_2 - p_k2_2) / t8;
        t9d = (p_k3_2d - p_k2_2d - t9 * t8d) * (1.0 / t8);
        tb21 = funb[i][2];
        tb21d = funbd[i][2];
        funb[i][2] = 0.0;
        funbd[i][2] = 0.0;
        tb22 = tb21 * (1.0 + x * (-3.0 + 2.0 * x));
        tb22d = tb21d * (1.0 + x * (-3.0 + 2.0 * x)) + tb21 * (xd * (-3.0 + 2.0 * x) + x * (2.0 *
            xd));
        t9b = tb22 * x * 60.0;
        t9bd = (tb22d * x + tb22 * xd) * 60.0;
        xb = tb22 * (t9 * 60.0);
        xbd = tb22d * (t9 * 60.0) + tb22 * (t9d * 60.0);
        tb23 = tb21 * (t9 * 60.0 * x);
        tb23d = tb21d * (t9 * 60.0 * x) + tb21 * (t9d * 60.0 * x + t9 * 60.0 * xd);
        xb += tb23 * (-3.0 + 2.0 * x);
        xbd += tb23d * (-3.0 + 2.0 * x) + tb23 * (2.0 * xd);
        xb += tb23 * x * 2.0;
        xbd += (tb23d * x + tb23 * xd) * 2.0;
        tb20 = t9b / t8;
        tb20d = (t9bd - tb20 * t8d) * (1.0 / t8);
        p_k3_2b = tb20;
        p_k3_2bd = tb20d;
        p_k2_2b = -tb20;
        p_k2_2bd = -tb20d;
        t8b = -(tb20 * t9);
        t8bd = -(tb20d * t9 + tb20 * t9d);
        hb = t8b * h;
        hbd = t8bd * h + t8b * hd;
        hb += t8b * h;
        hbd += t8bd * h + t8b * hd;
        tb16 = funb[i][1];
        tb16d = funbd[i][1];
        funb[i][1] = 0.0;
        funbd[i][1] = 0.0;
        tb17 = tb16 * (1.0 + x * (-2.0 + x));
        tb17d = tb16d * (1.0 + x * (-2.0 + x)) + tb16 * (xd * (-2.0 + x) + x * xd);
        tb18 = tb17 * x;
        tb18d = tb17d * x + tb17 * xd;
        t7b = tb18 * x * 30.0;
        t7bd = (tb18d * x + tb18 * xd) * 30.0;
        xb += tb18 * (t7 * 30.0);
        xbd += tb18d * (t7 * 30.0) + tb18 * (t7d * 30.0);
        xb += tb17 * (t7 * 30.0 * x);
        xbd += tb17d * (t7 * 30.0 * x) + tb17 * (t7d * 30.0 * x + t7 * 30.0 * xd);
        tb19 = tb16 * (t7 * 30.0 * x * x);
        tb19d = tb16d * (t7 * 30.0 * x * x) + tb16 * ((t7d * 30.0 * x + t7 * 30.0 * xd) * x + t7 *
            30.0 * x * xd);
        xb += tb19 * (-2.0 + x);
        xbd += tb19d * (-2.0 + x) + tb19 * xd;
        xb += tb19 * x;
        xbd += tb19d * x + tb19 * xd;
        tb15 = t7b / h;
        tb15d = (t7bd - tb15 * hd) * (1.0 / h);
        p_k3_2b += tb15;
        p_k3_2bd += tb15d;
        p_k2_2b -= tb15;
        p_k2_2bd -= tb15d;
        hb -= tb15 * t7;
        hbd -= tb15d * t7 + tb15 * t7d;
        tb9 = funb[i][0];
        tb9d = funbd[i][0];
        funb[i][0] = 0.0;
        funbd[i][0] = 0.0;
        p_k2_2b += tb9;
        p_k2_2bd += tb9d;
        tb10 = tb9 * (10.0 + x * (-15.0 + 6.0 * x));
        tb10d = tb9d * (10.0 + x * (-15.0 + 6.0 * x)) + tb9 * (xd * (-15.0 + 6.0 * x) + x * (6.0 *
            xd));
        tb11 = tb10 * x;
        tb11d = tb10d * x + tb10 * xd;
        tb12 = tb11 * x;
        tb12d = tb11d * x + tb11 * xd;
        tb13 = tb12 * x;
        tb13d = tb12d * x + tb12 * xd;
        p_k3_2b += tb13;
        p_k3_2bd += tb13d;
        p_k2_2b -= tb13;
        p_k2_2bd -= tb13d;
        xb += tb12 * (p_k3_2 - p_k2_2);
        xbd += tb12d * (p_k3_2 - p_k2_2) + tb12 * (p_k3_2d - p_k2_2d);
        xb += tb11 * ((p_k3_2 - p_k2_2) * x);
        xbd += tb11d * ((p_k3_2 - p_k2_2) * x) + tb11 * ((p_k3_2d - p_k2_2d) * x + (p_k3_2 - p_k2_2)
            * xd);
        xb += tb10 * ((p_k3_2 - p_k2_2) * x * x);
        xbd += tb10d * ((p_k3_2 - p_k2_2) * x * x) + tb10 * (((p_k3_2d - p_k2_2d) * x + (p_k3_2 -
            p_k2_2) * xd) * x + (p_k3_2 - p_k2_2) * x * xd);
        tb14 = tb9 * ((p_k3_2 - p_k2_2) * x * x * x);
        tb14d = tb9d * ((p_k3_2 - p_k2_2) * x * x * x) + tb9 * ((((p_k3_2d - p_k2_2d) * x + (p_k3_2
            - p_k2_2) * xd) * x + (p_k3_2 - p_k2_2) * x * xd) * x + (p_k3_2 - p_k2_2) * x * x * xd);
        xb += tb14 * (-15.0 + 6.0 * x);
        xbd += tb14d * (-15.0 + 6.0 * x) + tb14 * (6.0 * xd);
        xb += tb14 * x * 6.0;
        xbd += (tb14d * x + tb14 * xd) * 6.0;
        pb[k + 3] += p_k3_2b;
        pbd[k + 3] += p_k3_2bd;
        pb[k + 2] += p_k2_2b;
        pbd[k + 2] += p_k2_2bd;
        tb8 = xb / h;
        tb8d = (xbd - tb8 * hd) * (1.0 / h);
        p_k3b = -tb8;
        p_k3bd = -tb8d;
        hb -= tb8 * x;
        hbd -= tb8d * x + tb8 * xd;
        pb[k + 1] += hb;
        pbd[k + 1] += hbd;
        p_k3b -= hb;
        p_k3bd -= hbd;
        pb[k] += p_k3b;
        pbd[k] += p_k3bd;
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
        funbd[i][2] = 0.0;
        funb[i][1] = 0.0;
        funbd[i][1] = 0.0;
        pb[k + t->funn[i] + k3] += funb[i][0];
        pbd[k + t->funn[i] + k3] += funbd[i][0];
        funb[i][0] = 0.0;
        funbd[i][0] = 0.0;
      } else {
        is_k3_4 = MAGGI_RE(time) >= MAGGI_RE(p[k + k3 + 1]);
        if (is_k3_4) {
          funb[i][2] = 0.0;
          funbd[i][2] = 0.0;
          funb[i][1] = 0.0;
          funbd[i][1] = 0.0;
          pb[k + t->funn[i] + k3 + 1] += funb[i][0];
          pbd[k + t->funn[i] + k3 + 1] += funbd[i][0];
          funb[i][0] = 0.0;
          funbd[i][0] = 0.0;
        } else {
          p_kk3 = p[k + k3];
          p_kk3d = pd[k + k3];
          h2 = p[k + k3 + 1] - p_kk3;
          h2d = pd[k + k3 + 1] - p_kk3d;
          x2 = (time - p_kk3) / h2;
          x2d = (-p_kk3d - x2 * h2d) * (1.0 / h2);
          p_kik3 = p[k + t->funn[i] + k3];
          p_kik3d = pd[k + t->funn[i] + k3];
          p_kik31 = p[k + t->funn[i] + k3 + 1];
          p_kik31d = pd[k + t->funn[i] + k3 + 1];
          t10 = (p_kik31 - p_kik3) / h2;
          t10d = (p_kik31d - p_kik3d - t10 * h2d) * (1.0 / h2);
          t11 = h2 * h2;
          t11d = h2d * h2 + h2 * h2d;
          t12 = (p_kik31 - p_kik3) / t11;
          t12d = (p_kik31d - p_kik3d - t12 * t11d) * (1.0 / t11);
          tb37 = funb[i][2];
          tb37d = funbd[i][2];
          funb[i][2] = 0.0;
          funbd[i][2] = 0.0;
          tb38 = tb37 * (1.0 + x2 * (-3.0 + 2.0 * x2));
          tb38d = tb37d * (1.0 + x2 * (-3.0 + 2.0 * x2)) + tb37 * (x2d * (-3.0 + 2.0 * x2) + x2 *
              (2.0 * x2d));
          t12b = tb38 * x2 * 60.0;
          t12bd = (tb38d * x2 + tb38 * x2d) * 60.0;
          x2b = tb38 * (t12 * 60.0);
          x2bd = tb38d * (t12 * 60.0) + tb38 * (t12d * 60.0);
          tb39 = tb37 * (t12 * 60.0 * x2);
          tb39d = tb37d * (t12 * 60.0 * x2) + tb37 * (t12d * 60.0 * x2 + t12 * 60.0 * x2d);
          x2b += tb39 * (-3.0 + 2.0 * x2);
          x2bd += tb39d * (-3.0 + 2.0 * x2) + tb39 * (2.0 * x2d);
          x2b += tb39 * x2 * 2.0;
          x2bd += (tb39d * x2 + tb39 * x2d) * 2.0;
          tb36 = t12b / t11;
          tb36d = (t12bd - tb36 * t11d) * (1.0 / t11);
          p_kik31b = tb36;
          p_kik31bd = tb36d;
          p_kik3b = -tb36;
          p_kik3bd = -tb36d;
          t11b = -(tb36 * t12);
          t11bd = -(tb36d * t12 + tb36 * t12d);
          h2b = t11b * h2;
          h2bd = t11bd * h2 + t11b * h2d;
          h2b += t11b * h2;
          h2bd += t11bd * h2 + t11b * h2d;
          tb32 = funb[i][1];
          tb32d = funbd[i][1];
          funb[i][1] = 0.0;
          funbd[i][1] = 0.0;
          tb33 = tb32 * (1.0 + x2 * (-2.0 + x2));
          tb33d = tb32d * (1.0 + x2 * (-2.0 + x2)) + tb32 * (x2d * (-2.0 + x2) + x2 * x2d);
          tb34 = tb33 * x2;
          tb34d = tb33d * x2 + tb33 * x2d;
          t10b = tb34 * x2 * 30.0;
          t10bd = (tb34d * x2 + tb34 * x2d) * 30.0;
          x2b += tb34 * (t10 * 30.0);
          x2bd += tb34d * (t10 * 30.0) + tb34 * (t10d * 30.0);
          x2b += tb33 * (t10 * 30.0 * x2);
          x2bd += tb33d * (t10 * 30.0 * x2) + tb33 * (t10d * 30.0 * x2 + t10 * 30.0 * x2d);
          tb35 = tb32 * (t10 * 30.0 * x2 * x2);
          tb35d = tb32d * (t10 * 30.0 * x2 * x2) + tb32 * ((t10d * 30.0 * x2 + t10 * 30.0 * x2d) *
              x2 + t10 * 30.0 * x2 * x2d);
          x2b += tb35 * (-2.0 + x2);
          x2bd += tb35d * (-2.0 + x2) + tb35 * x2d;
          x2b += tb35 * x2;
          x2bd += tb35d * x2 + tb35 * x2d;
          tb31 = t10b / h2;
          tb31d = (t10bd - tb31 * h2d) * (1.0 / h2);
          p_kik31b += tb31;
          p_kik31bd += tb31d;
          p_kik3b -= tb31;
          p_kik3bd -= tb31d;
          h2b -= tb31 * t10;
          h2bd -= tb31d * t10 + tb31 * t10d;
          tb25 = funb[i][0];
          tb25d = funbd[i][0];
          funb[i][0] = 0.0;
          funbd[i][0] = 0.0;
          p_kik3b += tb25;
          p_kik3bd += tb25d;
          tb26 = tb25 * (10.0 + x2 * (-15.0 + 6.0 * x2));
          tb26d = tb25d * (10.0 + x2 * (-15.0 + 6.0 * x2)) + tb25 * (x2d * (-15.0 + 6.0 * x2) + x2 *
              (6.0 * x2d));
          tb27 = tb26 * x2;
          tb27d = tb26d * x2 + tb26 * x2d;
          tb28 = tb27 * x2;
          tb28d = tb27d * x2 + tb27 * x2d;
          tb29 = tb28 * x2;
          tb29d = tb28d * x2 + tb28 * x2d;
          p_kik31b += tb29;
          p_kik31bd += tb29d;
          p_kik3b -= tb29;
          p_kik3bd -= tb29d;
          x2b += tb28 * (p_kik31 - p_kik3);
          x2bd += tb28d * (p_kik31 - p_kik3) + tb28 * (p_kik31d - p_kik3d);
          x2b += tb27 * ((p_kik31 - p_kik3) * x2);
          x2bd += tb27d * ((p_kik31 - p_kik3) * x2) + tb27 * ((p_kik31d - p_kik3d) * x2 + (p_kik31 -
              p_kik3) * x2d);
          x2b += tb26 * ((p_kik31 - p_kik3) * x2 * x2);
          x2bd += tb26d * ((p_kik31 - p_kik3) * x2 * x2) + tb26 * (((p_kik31d - p_kik3d) * x2 +
              (p_kik31 - p_kik3) * x2d) * x2 + (p_kik31 - p_kik3) * x2 * x2d);
          tb30 = tb25 * ((p_kik31 - p_kik3) * x2 * x2 * x2);
          tb30d = tb25d * ((p_kik31 - p_kik3) * x2 * x2 * x2) + tb25 * ((((p_kik31d - p_kik3d) * x2
              + (p_kik31 - p_kik3) * x2d) * x2 + (p_kik31 - p_kik3) * x2 * x2d) * x2 + (p_kik31 -
              p_kik3) * x2 * x2 * x2d);
          x2b += tb30 * (-15.0 + 6.0 * x2);
          x2bd += tb30d * (-15.0 + 6.0 * x2) + tb30 * (6.0 * x2d);
          x2b += tb30 * x2 * 6.0;
          x2bd += (tb30d * x2 + tb30 * x2d) * 6.0;
          pb[k + t->funn[i] + k3 + 1] += p_kik31b;
          pbd[k + t->funn[i] + k3 + 1] += p_kik31bd;
          pb[k + t->funn[i] + k3] += p_kik3b;
          pbd[k + t->funn[i] + k3] += p_kik3bd;
          tb24 = x2b / h2;
          tb24d = (x2bd - tb24 * h2d) * (1.0 / h2);
          p_kk3b = -tb24;
          p_kk3bd = -tb24d;
          h2b -= tb24 * x2;
          h2bd -= tb24d * x2 + tb24 * x2d;
          pb[k + k3 + 1] += h2b;
          pbd[k + k3 + 1] += h2bd;
          p_kk3b -= h2b;
          p_kk3bd -= h2bd;
          pb[k + k3] += p_kk3b;
          pbd[k + k3] += p_kk3bd;
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
        t13d = (pd[k + t->funn[i] + 1] - p_kid - t13 * h3d) * (1.0 / h3);
        slope = t13 - h3 / 6.0 * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] +
            1][0]);
        sloped = t13d - (h3d / 6.0 * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] +
            1][0]) + h3 / 6.0 * (2.0 * spline0d[t->funspline[i]][0] + spline0d[t->funspline[i] +
            1][0]));
        funb[i][2] = 0.0;
        funbd[i][2] = 0.0;
        slopeb = funb[i][1];
        slopebd = funbd[i][1];
        funb[i][1] = 0.0;
        funbd[i][1] = 0.0;
        tb42 = funb[i][0];
        tb42d = funbd[i][0];
        funb[i][0] = 0.0;
        funbd[i][0] = 0.0;
        p_kib = tb42;
        p_kibd = tb42d;
        slopeb += tb42 * (time - p_k4);
        slopebd += tb42d * (time - p_k4) - tb42 * p_k4d;
        p_k4b = -(tb42 * slope);
        p_k4bd = -(tb42d * slope + tb42 * sloped);
        t13b = slopeb;
        t13bd = slopebd;
        h3b = -(slopeb * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] + 1][0]) /
            6.0);
        h3bd = -((slopebd * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] + 1][0]) +
            slopeb * (2.0 * spline0d[t->funspline[i]][0] + spline0d[t->funspline[i] + 1][0])) /
            6.0);
        tb41 = slopeb * (h3 / 6.0);
        tb41d = slopebd * (h3 / 6.0) + slopeb * (h3d / 6.0);
        spline0b[t->funspline[i]][0] -= tb41 * 2.0;
        spline0bd[t->funspline[i]][0] -= tb41d * 2.0;
        spline0b[t->funspline[i] + 1][0] -= tb41;
        spline0bd[t->funspline[i] + 1][0] -= tb41d;
        tb40 = t13b / h3;
        tb40d = (t13bd - tb40 * h3d) * (1.0 / h3);
        pb[k + t->funn[i] + 1] += tb40;
        pbd[k + t->funn[i] + 1] += tb40d;
        p_kib -= tb40;
        p_kibd -= tb40d;
        h3b -= tb40 * t13;
        h3bd -= tb40d * t13 + tb40 * t13d;
        pb[k + t->funn[i]] += p_kib;
        pbd[k + t->funn[i]] += p_kibd;
        pb[k + 1] += h3b;
        pbd[k + 1] += h3bd;
        p_k4b -= h3b;
        p_k4bd -= h3bd;
        pb[k] += p_k4b;
        pbd[k] += p_k4bd;
      } else if (k4 > t->funn[i] - 2) {
        p_ki1 = p[k + t->funn[i] - 1];
        p_ki1d = pd[k + t->funn[i] - 1];
        h3_2 = p_ki1 - p[k + t->funn[i] - 2];
        h3_2d = p_ki1d - pd[k + t->funn[i] - 2];
        p_kii1 = p[k + t->funn[i] + t->funn[i] - 1];
        p_kii1d = pd[k + t->funn[i] + t->funn[i] - 1];
        t14 = (p_kii1 - p[k + t->funn[i] + t->funn[i] - 2]) / h3_2;
        t14d = (p_kii1d - pd[k + t->funn[i] + t->funn[i] - 2] - t14 * h3_2d) * (1.0 / h3_2);
        slope2 = t14 + h3_2 / 6.0 * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]);
        slope2d = t14d + (h3_2d / 6.0 * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]) + h3_2 / 6.0 * (spline0d[t->funspline[i] +
            t->funn[i] - 2][0] + 2.0 * spline0d[t->funspline[i] + t->funn[i] - 1][0]));
        funb[i][2] = 0.0;
        funbd[i][2] = 0.0;
        slope2b = funb[i][1];
        slope2bd = funbd[i][1];
        funb[i][1] = 0.0;
        funbd[i][1] = 0.0;
        tb45 = funb[i][0];
        tb45d = funbd[i][0];
        funb[i][0] = 0.0;
        funbd[i][0] = 0.0;
        p_kii1b = tb45;
        p_kii1bd = tb45d;
        slope2b += tb45 * (time - p_ki1);
        slope2bd += tb45d * (time - p_ki1) - tb45 * p_ki1d;
        p_ki1b = -(tb45 * slope2);
        p_ki1bd = -(tb45d * slope2 + tb45 * slope2d);
        t14b = slope2b;
        t14bd = slope2bd;
        h3_2b = slope2b * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]) / 6.0;
        h3_2bd = (slope2bd * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]) + slope2b * (spline0d[t->funspline[i] +
            t->funn[i] - 2][0] + 2.0 * spline0d[t->funspline[i] + t->funn[i] - 1][0])) / 6.0;
        tb44 = slope2b * (h3_2 / 6.0);
        tb44d = slope2bd * (h3_2 / 6.0) + slope2b * (h3_2d / 6.0);
        spline0b[t->funspline[i] + t->funn[i] - 2][0] += tb44;
        spline0bd[t->funspline[i] + t->funn[i] - 2][0] += tb44d;
        spline0b[t->funspline[i] + t->funn[i] - 1][0] += tb44 * 2.0;
        spline0bd[t->funspline[i] + t->funn[i] - 1][0] += tb44d * 2.0;
        tb43 = t14b / h3_2;
        tb43d = (t14bd - tb43 * h3_2d) * (1.0 / h3_2);
        p_kii1b += tb43;
        p_kii1bd += tb43d;
        pb[k + t->funn[i] + t->funn[i] - 2] -= tb43;
        pbd[k + t->funn[i] + t->funn[i] - 2] -= tb43d;
        h3_2b -= tb43 * t14;
        h3_2bd -= tb43d * t14 + tb43 * t14d;
        pb[k + t->funn[i] + t->funn[i] - 1] += p_kii1b;
        pbd[k + t->funn[i] + t->funn[i] - 1] += p_kii1bd;
        p_ki1b += h3_2b;
        p_ki1bd += h3_2bd;
        pb[k + t->funn[i] - 2] -= h3_2b;
        pbd[k + t->funn[i] - 2] -= h3_2bd;
        pb[k + t->funn[i] - 1] += p_ki1b;
        pbd[k + t->funn[i] - 1] += p_ki1bd;
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
        t15d = (pd[k + t->funn[i] + k4 + 1] - p_kik4d - t15 * h3_3d) * (1.0 / h3_3);
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
        t17d = (((spline0_ik40d * a + spline0_ik40 * ad) * a + spline0_ik40 * a * ad) * a +
            spline0_ik40 * a * a * ad + (((spline0_ik410d * c2 + spline0_ik410 * c2d) * c2 +
            spline0_ik410 * c2 * c2d) * c2 + spline0_ik410 * c2 * c2 * c2d) - t17 * t16d) * (1.0 /
            t16);
        t18 = 2.0 * h3_3;
        t18d = 2.0 * h3_3d;
        t19 = (spline0_ik410 * c2 * c2 - spline0_ik40 * a * a) / t18;
        t19d = ((spline0_ik410d * c2 + spline0_ik410 * c2d) * c2 + spline0_ik410 * c2 * c2d -
            ((spline0_ik40d * a + spline0_ik40 * ad) * a + spline0_ik40 * a * ad) - t19 * t18d) *
            (1.0 / t18);
        t20 = (spline0_ik40 * a + spline0_ik410 * c2) / h3_3;
        t20d = (spline0_ik40d * a + spline0_ik40 * ad + (spline0_ik410d * c2 + spline0_ik410 * c2d)
            - t20 * h3_3d) * (1.0 / h3_3);
        t20b = funb[i][2];
        t20bd = funbd[i][2];
        funb[i][2] = 0.0;
        funbd[i][2] = 0.0;
        tb60 = t20b / h3_3;
        tb60d = (t20bd - tb60 * h3_3d) * (1.0 / h3_3);
        spline0_ik40b = tb60 * a;
        spline0_ik40bd = tb60d * a + tb60 * ad;
        ab = tb60 * spline0_ik40;
        abd = tb60d * spline0_ik40 + tb60 * spline0_ik40d;
        spline0_ik410b = tb60 * c2;
        spline0_ik410bd = tb60d * c2 + tb60 * c2d;
        c2b = tb60 * spline0_ik410;
        c2bd = tb60d * spline0_ik410 + tb60 * spline0_ik410d;
        h3_3b = -(tb60 * t20);
        h3_3bd = -(tb60d * t20 + tb60 * t20d);
        tb59 = funb[i][1];
        tb59d = funbd[i][1];
        funb[i][1] = 0.0;
        funbd[i][1] = 0.0;
        t19b = tb59;
        t19bd = tb59d;
        eb = tb59;
        ebd = tb59d;
        tb56 = t19b / t18;
        tb56d = (t19bd - tb56 * t18d) * (1.0 / t18);
        tb57 = tb56 * c2;
        tb57d = tb56d * c2 + tb56 * c2d;
        spline0_ik410b += tb57 * c2;
        spline0_ik410bd += tb57d * c2 + tb57 * c2d;
        c2b += tb57 * spline0_ik410;
        c2bd += tb57d * spline0_ik410 + tb57 * spline0_ik410d;
        c2b += tb56 * (spline0_ik410 * c2);
        c2bd += tb56d * (spline0_ik410 * c2) + tb56 * (spline0_ik410d * c2 + spline0_ik410 * c2d);
        tb58 = tb56 * a;
        tb58d = tb56d * a + tb56 * ad;
        spline0_ik40b -= tb58 * a;
        spline0_ik40bd -= tb58d * a + tb58 * ad;
        ab -= tb58 * spline0_ik40;
        abd -= tb58d * spline0_ik40 + tb58 * spline0_ik40d;
        ab -= tb56 * (spline0_ik40 * a);
        abd -= tb56d * (spline0_ik40 * a) + tb56 * (spline0_ik40d * a + spline0_ik40 * ad);
        t18b = -(tb56 * t19);
        t18bd = -(tb56d * t19 + tb56 * t19d);
        h3_3b += t18b * 2.0;
        h3_3bd += t18bd * 2.0;
        tb53 = funb[i][0];
        tb53d = funbd[i][0];
        funb[i][0] = 0.0;
        funbd[i][0] = 0.0;
        t17b = tb53;
        t17bd = tb53d;
        p_kik4b = tb53;
        p_kik4bd = tb53d;
        tb54 = tb53 / 6.0;
        tb54d = tb53d / 6.0;
        tb55 = tb54 * h3_3;
        tb55d = tb54d * h3_3 + tb54 * h3_3d;
        spline0_ik40b -= tb55 * h3_3;
        spline0_ik40bd -= tb55d * h3_3 + tb55 * h3_3d;
        h3_3b -= tb55 * spline0_ik40;
        h3_3bd -= tb55d * spline0_ik40 + tb55 * spline0_ik40d;
        h3_3b -= tb54 * (spline0_ik40 * h3_3);
        h3_3bd -= tb54d * (spline0_ik40 * h3_3) + tb54 * (spline0_ik40d * h3_3 + spline0_ik40 *
            h3_3d);
        eb += tb53 * c2;
        ebd += tb53d * c2 + tb53 * c2d;
        c2b += tb53 * e;
        c2bd += tb53d * e + tb53 * ed;
        tb48 = t17b / t16;
        tb48d = (t17bd - tb48 * t16d) * (1.0 / t16);
        tb49 = tb48 * a;
        tb49d = tb48d * a + tb48 * ad;
        tb50 = tb49 * a;
        tb50d = tb49d * a + tb49 * ad;
        spline0_ik40b += tb50 * a;
        spline0_ik40bd += tb50d * a + tb50 * ad;
        ab += tb50 * spline0_ik40;
        abd += tb50d * spline0_ik40 + tb50 * spline0_ik40d;
        ab += tb49 * (spline0_ik40 * a);
        abd += tb49d * (spline0_ik40 * a) + tb49 * (spline0_ik40d * a + spline0_ik40 * ad);
        ab += tb48 * (spline0_ik40 * a * a);
        abd += tb48d * (spline0_ik40 * a * a) + tb48 * ((spline0_ik40d * a + spline0_ik40 * ad) * a
            + spline0_ik40 * a * ad);
        tb51 = tb48 * c2;
        tb51d = tb48d * c2 + tb48 * c2d;
        tb52 = tb51 * c2;
        tb52d = tb51d * c2 + tb51 * c2d;
        spline0_ik410b += tb52 * c2;
        spline0_ik410bd += tb52d * c2 + tb52 * c2d;
        c2b += tb52 * spline0_ik410;
        c2bd += tb52d * spline0_ik410 + tb52 * spline0_ik410d;
        c2b += tb51 * (spline0_ik410 * c2);
        c2bd += tb51d * (spline0_ik410 * c2) + tb51 * (spline0_ik410d * c2 + spline0_ik410 * c2d);
        c2b += tb48 * (spline0_ik410 * c2 * c2);
        c2bd += tb48d * (spline0_ik410 * c2 * c2) + tb48 * ((spline0_ik410d * c2 + spline0_ik410 *
            c2d) * c2 + spline0_ik410 * c2 * c2d);
        t16b = -(tb48 * t17);
        t16bd = -(tb48d * t17 + tb48 * t17d);
        h3_3b += t16b * 6.0;
        h3_3bd += t16bd * 6.0;
        t15b = eb;
        t15bd = ebd;
        h3_3b -= eb * (spline0_ik410 - spline0_ik40) / 6.0;
        h3_3bd -= (ebd * (spline0_ik410 - spline0_ik40) + eb * (spline0_ik410d - spline0_ik40d)) /
            6.0;
        tb47 = eb * (h3_3 / 6.0);
        tb47d = ebd * (h3_3 / 6.0) + eb * (h3_3d / 6.0);
        spline0_ik410b -= tb47;
        spline0_ik410bd -= tb47d;
        spline0_ik40b += tb47;
        spline0_ik40bd += tb47d;
        spline0b[t->funspline[i] + k4][0] += spline0_ik40b;
        spline0bd[t->funspline[i] + k4][0] += spline0_ik40bd;
        spline0b[t->funspline[i] + k4 + 1][0] += spline0_ik410b;
        spline0bd[t->funspline[i] + k4 + 1][0] += spline0_ik410bd;
        tb46 = t15b / h3_3;
        tb46d = (t15bd - tb46 * h3_3d) * (1.0 / h3_3);
        pb[k + t->funn[i] + k4 + 1] += tb46;
        pbd[k + t->funn[i] + k4 + 1] += tb46d;
        p_kik4b -= tb46;
        p_kik4bd -= tb46d;
        h3_3b -= tb46 * t15;
        h3_3bd -= tb46d * t15 + tb46 * t15d;
        pb[k + t->funn[i] + k4] += p_kik4b;
        pbd[k + t->funn[i] + k4] += p_kik4bd;
        p_kk4b = -c2b;
        p_kk4bd = -c2bd;
        p_kk41b = ab;
        p_kk41bd = abd;
        p_kk41b += h3_3b;
        p_kk41bd += h3_3bd;
        p_kk4b -= h3_3b;
        p_kk4bd -= h3_3bd;
        pb[k + k4] += p_kk4b;
        pbd[k + k4] += p_kk4bd;
        pb[k + k4 + 1] += p_kk41b;
        pbd[k + k4 + 1] += p_kk41bd;
      }
    }
  }
}
