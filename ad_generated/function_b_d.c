/* Tangent of the adjoint of core/kernel/function.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

void maggi_spline_constants_b_d(const maggi_topo *t, const double p[restrict t->np],
                                const double pd[restrict t->np], double pb[restrict t->np],
                                double pbd[restrict t->np], double spline0[restrict t->nspline][3],
                                double spline0d[restrict t->nspline][3],
                                double spline0b[restrict t->nspline][3],
                                double spline0bd[restrict t->nspline][3])
{
  int i, k, k2;
  double e0, e0_2, e0_2b, e0_2bd, e0_2d, e0b, e0bd, e0d, e1, e1_2, e1_2b, e1_2bd, e1_2d, e1b, e1bd,
      e1d, h0, h0_2, h0_2b, h0_2bd, h0_2d, h0b, h0bd, h0d, h1, h1_2, h1_2b, h1_2bd, h1_2d, h1b,
      h1bd, h1d, p_iik, p_iik2, p_iik2b, p_iik2bd, p_iik2d, p_iikb, p_iikbd, p_iikd, p_ik, p_ik2,
      p_ik2b, p_ik2bd, p_ik2d, p_ikb, p_ikbd, p_ikd, t2, t2b, t2bd, t2d, t3, t3b, t3bd, t3d, tb10,
      tb10d, tb11, tb11d, tb12, tb12d, tb13, tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d, tb17,
      tb17d, tb2, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d,
      w, w2, w2b, w2bd, w2d, wb, wbd, wd;

  for (i = t->nroad - 1; i >= 0; --i) {
    if (t->roadkind[i] == MAGGI_ROAD_PROFILE) {
      for (k2 = 1; k2 <= t->roadn[i] - 2; ++k2) {
        tb17 = spline0b[t->roadspline[i] + k2][0];
        tb17d = spline0bd[t->roadspline[i] + k2][0];
        spline0b[t->roadspline[i] + k2][0] = 0.0;
        spline0bd[t->roadspline[i] + k2][0] = 0.0;
        spline0b[t->roadspline[i] + k2][1] += tb17;
        spline0bd[t->roadspline[i] + k2][1] += tb17d;
        spline0b[t->roadspline[i] + k2][2] -= tb17 * spline0[t->roadspline[i] + k2 + 1][0];
        spline0bd[t->roadspline[i] + k2][2] -= tb17d * spline0[t->roadspline[i] + k2 + 1][0] + tb17
            * spline0d[t->roadspline[i] + k2 + 1][0];
        spline0b[t->roadspline[i] + k2 + 1][0] -= tb17 * spline0[t->roadspline[i] + k2][2];
        spline0bd[t->roadspline[i] + k2 + 1][0] -= tb17d * spline0[t->roadspline[i] + k2][2] + tb17
            * spline0d[t->roadspline[i] + k2][2];
      }
      spline0b[t->roadspline[i] + t->roadn[i] - 1][0] = 0.0;
      spline0bd[t->roadspline[i] + t->roadn[i] - 1][0] = 0.0;
      spline0b[t->roadspline[i]][0] = 0.0;
      spline0bd[t->roadspline[i]][0] = 0.0;
      for (k2 = t->roadn[i] - 2; k2 >= 1; --k2) {
        p_ik2 = p[t->roadadr[i] + k2];
        p_ik2d = pd[t->roadadr[i] + k2];
        h0_2 = p_ik2 - p[t->roadadr[i] + k2 - 1];
        h0_2d = p_ik2d - pd[t->roadadr[i] + k2 - 1];
        h1_2 = p[t->roadadr[i] + k2 + 1] - p_ik2;
        h1_2d = pd[t->roadadr[i] + k2 + 1] - p_ik2d;
        p_iik2 = p[t->roadadr[i] + t->roadn[i] + k2];
        p_iik2d = pd[t->roadadr[i] + t->roadn[i] + k2];
        e0_2 = (p_iik2 - p[t->roadadr[i] + t->roadn[i] + k2 - 1]) / h0_2;
        e0_2d = (p_iik2d - pd[t->roadadr[i] + t->roadn[i] + k2 - 1] - e0_2 * h0_2d) * (1.0 / h0_2);
        e1_2 = (p[t->roadadr[i] + t->roadn[i] + k2 + 1] - p_iik2) / h1_2;
        e1_2d = (pd[t->roadadr[i] + t->roadn[i] + k2 + 1] - p_iik2d - e1_2 * h1_2d) * (1.0 / h1_2);
        w2 = 2.0 * (h0_2 + h1_2) - h0_2 * spline0[t->roadspline[i] + k2 - 1][2];
        w2d = 2.0 * (h0_2d + h1_2d) - (h0_2d * spline0[t->roadspline[i] + k2 - 1][2] + h0_2 *
            spline0d[t->roadspline[i] + k2 - 1][2]);
        t3 = spline0[t->roadspline[i] + k2][1];
        t3d = spline0d[t->roadspline[i] + k2][1];
        tb15 = spline0b[t->roadspline[i] + k2][2];
        tb15d = spline0bd[t->roadspline[i] + k2][2];
        spline0b[t->roadspline[i] + k2][2] = 0.0;
        spline0bd[t->roadspline[i] + k2][2] = 0.0;
        tb16 = tb15 / w2;
        tb16d = (tb15d - tb16 * w2d) * (1.0 / w2);
        h1_2b = tb16;
        h1_2bd = tb16d;
        w2b = -(tb16 * spline0[t->roadspline[i] + k2][2]);
        w2bd = -(tb16d * spline0[t->roadspline[i] + k2][2] + tb16 * spline0d[t->roadspline[i] +
            k2][2]);
        t3b = spline0b[t->roadspline[i] + k2][1];
        t3bd = spline0bd[t->roadspline[i] + k2][1];
        spline0b[t->roadspline[i] + k2][1] = 0.0;
        spline0bd[t->roadspline[i] + k2][1] = 0.0;
        tb13 = t3b / w2;
        tb13d = (t3bd - tb13 * w2d) * (1.0 / w2);
        tb14 = tb13 * 6.0;
        tb14d = tb13d * 6.0;
        e1_2b = tb14;
        e1_2bd = tb14d;
        e0_2b = -tb14;
        e0_2bd = -tb14d;
        h0_2b = -(tb13 * spline0[t->roadspline[i] + k2 - 1][1]);
        h0_2bd = -(tb13d * spline0[t->roadspline[i] + k2 - 1][1] + tb13 * spline0d[t->roadspline[i]
            + k2 - 1][1]);
        spline0b[t->roadspline[i] + k2 - 1][1] -= tb13 * h0_2;
        spline0bd[t->roadspline[i] + k2 - 1][1] -= tb13d * h0_2 + tb13 * h0_2d;
        w2b -= tb13 * t3;
        w2bd -= tb13d * t3 + tb13 * t3d;
        tb12 = w2b * 2.0;
        tb12d = w2bd * 2.0;
        h0_2b += tb12;
        h0_2bd += tb12d;
        h1_2b += tb12;
        h1_2bd += tb12d;
        h0_2b -= w2b * spline0[t->roadspline[i] + k2 - 1][2];
        h0_2bd -= w2bd * spline0[t->roadspline[i] + k2 - 1][2] + w2b * spline0d[t->roadspline[i] +
            k2 - 1][2];
        spline0b[t->roadspline[i] + k2 - 1][2] -= w2b * h0_2;
        spline0bd[t->roadspline[i] + k2 - 1][2] -= w2bd * h0_2 + w2b * h0_2d;
        tb11 = e1_2b / h1_2;
        tb11d = (e1_2bd - tb11 * h1_2d) * (1.0 / h1_2);
        pb[t->roadadr[i] + t->roadn[i] + k2 + 1] += tb11;
        pbd[t->roadadr[i] + t->roadn[i] + k2 + 1] += tb11d;
        p_iik2b = -tb11;
        p_iik2bd = -tb11d;
        h1_2b -= tb11 * e1_2;
        h1_2bd -= tb11d * e1_2 + tb11 * e1_2d;
        tb10 = e0_2b / h0_2;
        tb10d = (e0_2bd - tb10 * h0_2d) * (1.0 / h0_2);
        p_iik2b += tb10;
        p_iik2bd += tb10d;
        pb[t->roadadr[i] + t->roadn[i] + k2 - 1] -= tb10;
        pbd[t->roadadr[i] + t->roadn[i] + k2 - 1] -= tb10d;
        h0_2b -= tb10 * e0_2;
        h0_2bd -= tb10d * e0_2 + tb10 * e0_2d;
        pb[t->roadadr[i] + t->roadn[i] + k2] += p_iik2b;
        pbd[t->roadadr[i] + t->roadn[i] + k2] += p_iik2bd;
        pb[t->roadadr[i] + k2 + 1] += h1_2b;
        pbd[t->roadadr[i] + k2 + 1] += h1_2bd;
        p_ik2b = -h1_2b;
        p_ik2bd = -h1_2bd;
        p_ik2b += h0_2b;
        p_ik2bd += h0_2bd;
        pb[t->roadadr[i] + k2 - 1] -= h0_2b;
        pbd[t->roadadr[i] + k2 - 1] -= h0_2bd;
        pb[t->roadadr[i] + k2] += p_ik2b;
        pbd[t->roadadr[i] + k2] += p_ik2bd;
      }
      spline0b[t->roadspline[i]][2] = 0.0;
      spline0bd[t->roadspline[i]][2] = 0.0;
      spline0b[t->roadspline[i]][1] = 0.0;
      spline0bd[t->roadspline[i]][1] = 0.0;
    }
  }
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
  int i, is_k2, is_k2_2, is_k2_3, is_k2_4, k, k2, k3;
  double a, ab, abd, ad, c, c2, c2b, c2bd, c2d, cb, cbd, cd, e, eb, ebd, ed, f0b, f0bd, f1b, f1bd,
      f2b, f2bd, h, h2, h2b, h2bd, h2d, h3, h3b, h3bd, h3d, h4, h4_2, h4_2b, h4_2bd, h4_2d, h4_3,
      h4_3b, h4_3bd, h4_3d, h4b, h4bd, h4d, hb, hbd, hd, moves, p_i, p_i1, p_i1b, p_i1bd, p_i1d,
      p_i2, p_i2_2, p_i2_2b, p_i2_2bd, p_i2_2d, p_i2b, p_i2bd, p_i2d, p_i3, p_i3_2, p_i3_2b,
      p_i3_2bd, p_i3_2d, p_i3_3, p_i3_3b, p_i3_3bd, p_i3_3d, p_i3_4, p_i3_4b, p_i3_4bd, p_i3_4d,
      p_i3b, p_i3bd, p_i3d, p_i4, p_i4b, p_i4bd, p_i4d, p_i5, p_i5b, p_i5bd, p_i5d, p_ib, p_ibd,
      p_id, p_ii, p_ii1, p_ii1b, p_ii1bd, p_ii1d, p_iib, p_iibd, p_iid, p_iii1, p_iii1b, p_iii1bd,
      p_iii1d, p_iik2, p_iik21, p_iik21b, p_iik21bd, p_iik21d, p_iik2b, p_iik2bd, p_iik2d, p_iik3,
      p_iik3b, p_iik3bd, p_iik3d, p_ik2, p_ik2b, p_ik2bd, p_ik2d, p_ik3, p_ik31, p_ik31b, p_ik31bd,
      p_ik31d, p_ik3b, p_ik3bd, p_ik3d, p_ikb, p_ikbd, s, sb, sbd, sd, slope, slope2, slope2b,
      slope2bd, slope2d, slopeb, slopebd, sloped, spline0_ik30, spline0_ik30b, spline0_ik30bd,
      spline0_ik30d, spline0_ik310, spline0_ik310b, spline0_ik310bd, spline0_ik310d, t10, t10b,
      t10bd, t10d, t11, t11b, t11bd, t11d, t12, t12b, t12bd, t12d, t13, t13b, t13bd, t13d, t14,
      t14b, t14bd, t14d, t15, t15b, t15bd, t15d, t16, t16b, t16bd, t16d, t17, t17b, t17bd, t17d,
      t18, t18b, t18bd, t18d, t19, t19b, t19bd, t19d, t2, t20, t20b, t20bd, t20d, t21, t21b, t21bd,
      t21d, t3, t4, t5, t5b, t5bd, t5d, t6, t6b, t6bd, t6d, t7, t7b, t7bd, t7d, t8, t8b, t8bd, t8d,
      t9, t9b, t9bd, t9d, tb10, tb10d, tb11, tb11d, tb12, tb12d, tb13, tb13d, tb14, tb14d, tb15,
      tb15d, tb16, tb16d, tb17, tb17d, tb18, tb18d, tb19, tb19d, tb2, tb20, tb20d, tb21, tb21d,
      tb22, tb22d, tb23, tb23d, tb24, tb24d, tb25, tb25d, tb26, tb26d, tb27, tb27d, tb28, tb28d,
      tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31, tb31d, tb32, tb32d, tb33, tb33d, tb34, tb34d, tb35,
      tb35d, tb36, tb36d, tb37, tb37d, tb38, tb38d, tb39, tb39d, tb3d, tb4, tb40, tb40d, tb41,
      tb41d, tb42, tb42d, tb43, tb43d, tb44, tb44d, tb45, tb45d, tb46, tb46d, tb47, tb47d, tb48,
      tb48d, tb49, tb49d, tb4d, tb5, tb50, tb50d, tb51, tb51d, tb52, tb52d, tb53, tb53d, tb54,
      tb54d, tb55, tb55d, tb56, tb56d, tb57, tb57d, tb58, tb58d, tb59, tb59d, tb5d, tb6, tb60,
      tb60d, tb61, tb61d, tb62, tb62d, tb63, tb63d, tb64, tb64d, tb6d, tb7, tb7d, tb8, tb8d, tb9,
      tb9d, x, x2, x2b, x2bd, x2d, x3, x3b, x3bd, x3d, xb, xbd, xd;

  (void)fun;
  (void)fund;
  t4 = 0.0;
  for (i = t->nfun - 1; i >= 0; --i) {
    moves = t->funheld[i] ? 0.0 : 1.0;
    f2b = funb[i][2] * moves;
    f2bd = funbd[i][2] * moves;
    funb[i][2] = 0.0;
    funbd[i][2] = 0.0;
    f1b = funb[i][1] * moves;
    f1bd = funbd[i][1] * moves;
    funb[i][1] = 0.0;
    funbd[i][1] = 0.0;
    f0b = funb[i][0];
    f0bd = funbd[i][0];
    funb[i][0] = 0.0;
    funbd[i][0] = 0.0;
    /* of one function */
    if (t->funkind[i] == MAGGI_FUNCTION_CONSTANT) {
      f2b = 0.0;
      f2bd = 0.0;
      f1b = 0.0;
      f1bd = 0.0;
      pb[t->funadr[i]] += f0b;
      pbd[t->funadr[i]] += f0bd;
      f0b = 0.0;
      f0bd = 0.0;
    } else if (t->funkind[i] == MAGGI_FUNCTION_POLYNOMIAL) {
      for (k = t->funn[i] - 1; k >= 1; --k) {
        t2 = pow(time, k);
        t3 = pow(time, k - 1);
        if (k > 1) {
          t4 = pow(time, k - 2);
        }
        if (k > 1) {
          pb[t->funadr[i] + k] += f2b * t4 * (k - 1) * k;
          pbd[t->funadr[i] + k] += f2bd * t4 * (k - 1) * k;
        }
        p_ikb = f1b * t3 * k;
        p_ikbd = f1bd * t3 * k;
        p_ikb += f0b * t2;
        p_ikbd += f0bd * t2;
        pb[t->funadr[i] + k] += p_ikb;
        pbd[t->funadr[i] + k] += p_ikbd;
      }
      f2b = 0.0;
      f2bd = 0.0;
      f1b = 0.0;
      f1bd = 0.0;
      pb[t->funadr[i]] += f0b;
      /* sum_k c_k t^k */
      pbd[t->funadr[i]] += f0bd;
      f0b = 0.0;
      f0bd = 0.0;
    } else if (t->funkind[i] == MAGGI_FUNCTION_SINE) {
      p_i1 = p[t->funadr[i] + 1];
      p_i1d = pd[t->funadr[i] + 1];
      p_i2 = p[t->funadr[i] + 2];
      p_i2d = pd[t->funadr[i] + 2];
      t5 = p_i1 * time + p_i2;
      t5d = p_i1d * time + p_i2d;
      s = sin(t5);
      sd = cos(t5) * t5d;
      t6 = p_i1 * time + p_i2;
      t6d = p_i1d * time + p_i2d;
      c = cos(t6);
      cd = -(sin(t6) * t6d);
      p_i = p[t->funadr[i]];
      p_id = pd[t->funadr[i]];
      tb3 = f2b * s;
      tb3d = f2bd * s + f2b * sd;
      tb4 = tb3 * p_i1;
      tb4d = tb3d * p_i1 + tb3 * p_i1d;
      p_ib = -(tb4 * p_i1);
      p_ibd = -(tb4d * p_i1 + tb4 * p_i1d);
      p_i1b = -(tb4 * p_i);
      p_i1bd = -(tb4d * p_i + tb4 * p_id);
      p_i1b += tb3 * (-p_i * p_i1);
      p_i1bd += tb3d * (-p_i * p_i1) + tb3 * (-(p_id * p_i1) - p_i * p_i1d);
      sb = f2b * (-p_i * p_i1 * p_i1);
      sbd = f2bd * (-p_i * p_i1 * p_i1) + f2b * ((-(p_id * p_i1) - p_i * p_i1d) * p_i1 + -p_i * p_i1
          * p_i1d);
      f2b = 0.0;
      f2bd = 0.0;
      tb2 = f1b * c;
      tb2d = f1bd * c + f1b * cd;
      p_ib += tb2 * p_i1;
      p_ibd += tb2d * p_i1 + tb2 * p_i1d;
      p_i1b += tb2 * p_i;
      p_i1bd += tb2d * p_i + tb2 * p_id;
      cb = f1b * (p_i * p_i1);
      cbd = f1bd * (p_i * p_i1) + f1b * (p_id * p_i1 + p_i * p_i1d);
      f1b = 0.0;
      f1bd = 0.0;
      pb[t->funadr[i] + 3] += f0b;
      pbd[t->funadr[i] + 3] += f0bd;
      p_ib += f0b * s;
      p_ibd += f0bd * s + f0b * sd;
      sb += f0b * p_i;
      sbd += f0bd * p_i + f0b * p_id;
      f0b = 0.0;
      f0bd = 0.0;
      pb[t->funadr[i]] += p_ib;
      pbd[t->funadr[i]] += p_ibd;
      t6b = -(cb * sin(t6));
      t6bd = -(cbd * sin(t6) + cb * (cos(t6) * t6d));
      p_i1b += t6b * time;
      p_i1bd += t6bd * time;
      p_i2b = t6b;
      p_i2bd = t6bd;
      t5b = sb * cos(t5);
      t5bd = sbd * cos(t5) - sb * (sin(t5) * t5d);
      p_i1b += t5b * time;
      p_i1bd += t5bd * time;
      p_i2b += t5b;
      p_i2bd += t5bd;
      pb[t->funadr[i] + 2] += p_i2b;
      pbd[t->funadr[i] + 2] += p_i2bd;
      pb[t->funadr[i] + 1] += p_i1b;
      pbd[t->funadr[i] + 1] += p_i1bd;
    } else if (t->funkind[i] == MAGGI_FUNCTION_STEP) {
      /* y0 + (y1 - y0) (10 x^3 - 15 x^4 + 6 x^5), x = (t - t0) / (t1 - t0) */
      if (MAGGI_RE(time) <= MAGGI_RE(p[t->funadr[i]])) {
        f2b = 0.0;
        f2bd = 0.0;
        f1b = 0.0;
        f1bd = 0.0;
        pb[t->funadr[i] + 2] += f0b;
        pbd[t->funadr[i] + 2] += f0bd;
        f0b = 0.0;
        f0bd = 0.0;
      } else if (MAGGI_RE(time) >= MAGGI_RE(p[t->funadr[i] + 1])) {
        f2b = 0.0;
        f2bd = 0.0;
        f1b = 0.0;
        f1bd = 0.0;
        pb[t->funadr[i] + 3] += f0b;
        pbd[t->funadr[i] + 3] += f0bd;
        f0b = 0.0;
        f0bd = 0.0;
      } else {
        p_i3 = p[t->funadr[i]];
        p_i3d = pd[t->funadr[i]];
        h = p[t->funadr[i] + 1] - p_i3;
        hd = pd[t->funadr[i] + 1] - p_i3d;
        x = (time - p_i3) / h;
        xd = (-p_i3d - x * hd) * (1.0 / h);
        p_i2_2 = p[t->funadr[i] + 2];
        p_i2_2d = pd[t->funadr[i] + 2];
        p_i3_2 = p[t->funadr[i] + 3];
        p_i3_2d = pd[t->funadr[i] + 3];
        t7 = (p_i3_2 - p_i2_2) / h;
        t7d = (p_i3_2d - p_i2_2d - t7 * hd) * (1.0 / h);
        t8 = h * h;
        t8d = hd * h + h * hd;
        t9 = (p_i3_2 - p_i2_2) / t8;
        t9d = (p_i3_2d - p_i2_2d - t9 * t8d) * (1.0 / t8);
        tb16 = f2b * (1.0 + x * (-3.0 + 2.0 * x));
        tb16d = f2bd * (1.0 + x * (-3.0 + 2.0 * x)) + f2b * (xd * (-3.0 + 2.0 * x) + x * (2.0 *
            xd));
        t9b = tb16 * x * 60.0;
        t9bd = (tb16d * x + tb16 * xd) * 60.0;
        xb = tb16 * (t9 * 60.0);
        xbd = tb16d * (t9 * 60.0) + tb16 * (t9d * 60.0);
        tb17 = f2b * (t9 * 60.0 * x);
        tb17d = f2bd * (t9 * 60.0 * x) + f2b * (t9d * 60.0 * x + t9 * 60.0 * xd);
        xb += tb17 * (-3.0 + 2.0 * x);
        xbd += tb17d * (-3.0 + 2.0 * x) + tb17 * (2.0 * xd);
        xb += tb17 * x * 2.0;
        xbd += (tb17d * x + tb17 * xd) * 2.0;
        f2b = 0.0;
        f2bd = 0.0;
        tb15 = t9b / t8;
        tb15d = (t9bd - tb15 * t8d) * (1.0 / t8);
        p_i3_2b = tb15;
        p_i3_2bd = tb15d;
        p_i2_2b = -tb15;
        p_i2_2bd = -tb15d;
        t8b = -(tb15 * t9);
        t8bd = -(tb15d * t9 + tb15 * t9d);
        hb = t8b * h;
        hbd = t8bd * h + t8b * hd;
        hb += t8b * h;
        hbd += t8bd * h + t8b * hd;
        tb12 = f1b * (1.0 + x * (-2.0 + x));
        tb12d = f1bd * (1.0 + x * (-2.0 + x)) + f1b * (xd * (-2.0 + x) + x * xd);
        tb13 = tb12 * x;
        tb13d = tb12d * x + tb12 * xd;
        t7b = tb13 * x * 30.0;
        t7bd = (tb13d * x + tb13 * xd) * 30.0;
        xb += tb13 * (t7 * 30.0);
        xbd += tb13d * (t7 * 30.0) + tb13 * (t7d * 30.0);
        xb += tb12 * (t7 * 30.0 * x);
        xbd += tb12d * (t7 * 30.0 * x) + tb12 * (t7d * 30.0 * x + t7 * 30.0 * xd);
        tb14 = f1b * (t7 * 30.0 * x * x);
        tb14d = f1bd * (t7 * 30.0 * x * x) + f1b * ((t7d * 30.0 * x + t7 * 30.0 * xd) * x + t7 *
            30.0 * x * xd);
        xb += tb14 * (-2.0 + x);
        xbd += tb14d * (-2.0 + x) + tb14 * xd;
        xb += tb14 * x;
        xbd += tb14d * x + tb14 * xd;
        f1b = 0.0;
        f1bd = 0.0;
        tb11 = t7b / h;
        tb11d = (t7bd - tb11 * hd) * (1.0 / h);
        p_i3_2b += tb11;
        p_i3_2bd += tb11d;
        p_i2_2b -= tb11;
        p_i2_2bd -= tb11d;
        hb -= tb11 * t7;
        hbd -= tb11d * t7 + tb11 * t7d;
        p_i2_2b += f0b;
        p_i2_2bd += f0bd;
        tb6 = f0b * (10.0 + x * (-15.0 + 6.0 * x));
        tb6d = f0bd * (10.0 + x * (-15.0 + 6.0 * x)) + f0b * (xd * (-15.0 + 6.0 * x) + x * (6.0 *
            xd));
        tb7 = tb6 * x;
        tb7d = tb6d * x + tb6 * xd;
        tb8 = tb7 * x;
        tb8d = tb7d * x + tb7 * xd;
        tb9 = tb8 * x;
        tb9d = tb8d * x + tb8 * xd;
        p_i3_2b += tb9;
        p_i3_2bd += tb9d;
        p_i2_2b -= tb9;
        p_i2_2bd -= tb9d;
        xb += tb8 * (p_i3_2 - p_i2_2);
        xbd += tb8d * (p_i3_2 - p_i2_2) + tb8 * (p_i3_2d - p_i2_2d);
        xb += tb7 * ((p_i3_2 - p_i2_2) * x);
        xbd += tb7d * ((p_i3_2 - p_i2_2) * x) + tb7 * ((p_i3_2d - p_i2_2d) * x + (p_i3_2 - p_i2_2) *
            xd);
        xb += tb6 * ((p_i3_2 - p_i2_2) * x * x);
        xbd += tb6d * ((p_i3_2 - p_i2_2) * x * x) + tb6 * (((p_i3_2d - p_i2_2d) * x + (p_i3_2 -
            p_i2_2) * xd) * x + (p_i3_2 - p_i2_2) * x * xd);
        tb10 = f0b * ((p_i3_2 - p_i2_2) * x * x * x);
        tb10d = f0bd * ((p_i3_2 - p_i2_2) * x * x * x) + f0b * ((((p_i3_2d - p_i2_2d) * x + (p_i3_2
            - p_i2_2) * xd) * x + (p_i3_2 - p_i2_2) * x * xd) * x + (p_i3_2 - p_i2_2) * x * x * xd);
        xb += tb10 * (-15.0 + 6.0 * x);
        xbd += tb10d * (-15.0 + 6.0 * x) + tb10 * (6.0 * xd);
        xb += tb10 * x * 6.0;
        xbd += (tb10d * x + tb10 * xd) * 6.0;
        f0b = 0.0;
        f0bd = 0.0;
        pb[t->funadr[i] + 3] += p_i3_2b;
        pbd[t->funadr[i] + 3] += p_i3_2bd;
        pb[t->funadr[i] + 2] += p_i2_2b;
        pbd[t->funadr[i] + 2] += p_i2_2bd;
        tb5 = xb / h;
        tb5d = (xbd - tb5 * hd) * (1.0 / h);
        p_i3b = -tb5;
        p_i3bd = -tb5d;
        hb -= tb5 * x;
        hbd -= tb5d * x + tb5 * xd;
        pb[t->funadr[i] + 1] += hb;
        pbd[t->funadr[i] + 1] += hbd;
        p_i3b -= hb;
        p_i3bd -= hbd;
        pb[t->funadr[i]] += p_i3b;
        pbd[t->funadr[i]] += p_i3bd;
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
        f2bd = 0.0;
        f1b = 0.0;
        f1bd = 0.0;
        pb[t->funadr[i] + t->funn[i] + k2] += f0b;
        pbd[t->funadr[i] + t->funn[i] + k2] += f0bd;
        f0b = 0.0;
        f0bd = 0.0;
      } else {
        is_k2_4 = MAGGI_RE(time) >= MAGGI_RE(p[t->funadr[i] + k2 + 1]);
        if (is_k2_4) {
          f2b = 0.0;
          f2bd = 0.0;
          f1b = 0.0;
          f1bd = 0.0;
          pb[t->funadr[i] + t->funn[i] + k2 + 1] += f0b;
          pbd[t->funadr[i] + t->funn[i] + k2 + 1] += f0bd;
          f0b = 0.0;
          f0bd = 0.0;
        } else {
          p_ik2 = p[t->funadr[i] + k2];
          p_ik2d = pd[t->funadr[i] + k2];
          h2 = p[t->funadr[i] + k2 + 1] - p_ik2;
          h2d = pd[t->funadr[i] + k2 + 1] - p_ik2d;
          x2 = (time - p_ik2) / h2;
          x2d = (-p_ik2d - x2 * h2d) * (1.0 / h2);
          p_iik2 = p[t->funadr[i] + t->funn[i] + k2];
          p_iik2d = pd[t->funadr[i] + t->funn[i] + k2];
          p_iik21 = p[t->funadr[i] + t->funn[i] + k2 + 1];
          p_iik21d = pd[t->funadr[i] + t->funn[i] + k2 + 1];
          t10 = (p_iik21 - p_iik2) / h2;
          t10d = (p_iik21d - p_iik2d - t10 * h2d) * (1.0 / h2);
          t11 = h2 * h2;
          t11d = h2d * h2 + h2 * h2d;
          t12 = (p_iik21 - p_iik2) / t11;
          t12d = (p_iik21d - p_iik2d - t12 * t11d) * (1.0 / t11);
          tb29 = f2b * (1.0 + x2 * (-3.0 + 2.0 * x2));
          tb29d = f2bd * (1.0 + x2 * (-3.0 + 2.0 * x2)) + f2b * (x2d * (-3.0 + 2.0 * x2) + x2 * (2.0
              * x2d));
          t12b = tb29 * x2 * 60.0;
          t12bd = (tb29d * x2 + tb29 * x2d) * 60.0;
          x2b = tb29 * (t12 * 60.0);
          x2bd = tb29d * (t12 * 60.0) + tb29 * (t12d * 60.0);
          tb30 = f2b * (t12 * 60.0 * x2);
          tb30d = f2bd * (t12 * 60.0 * x2) + f2b * (t12d * 60.0 * x2 + t12 * 60.0 * x2d);
          x2b += tb30 * (-3.0 + 2.0 * x2);
          x2bd += tb30d * (-3.0 + 2.0 * x2) + tb30 * (2.0 * x2d);
          x2b += tb30 * x2 * 2.0;
          x2bd += (tb30d * x2 + tb30 * x2d) * 2.0;
          f2b = 0.0;
          f2bd = 0.0;
          tb28 = t12b / t11;
          tb28d = (t12bd - tb28 * t11d) * (1.0 / t11);
          p_iik21b = tb28;
          p_iik21bd = tb28d;
          p_iik2b = -tb28;
          p_iik2bd = -tb28d;
          t11b = -(tb28 * t12);
          t11bd = -(tb28d * t12 + tb28 * t12d);
          h2b = t11b * h2;
          h2bd = t11bd * h2 + t11b * h2d;
          h2b += t11b * h2;
          h2bd += t11bd * h2 + t11b * h2d;
          tb25 = f1b * (1.0 + x2 * (-2.0 + x2));
          tb25d = f1bd * (1.0 + x2 * (-2.0 + x2)) + f1b * (x2d * (-2.0 + x2) + x2 * x2d);
          tb26 = tb25 * x2;
          tb26d = tb25d * x2 + tb25 * x2d;
          t10b = tb26 * x2 * 30.0;
          t10bd = (tb26d * x2 + tb26 * x2d) * 30.0;
          x2b += tb26 * (t10 * 30.0);
          x2bd += tb26d * (t10 * 30.0) + tb26 * (t10d * 30.0);
          x2b += tb25 * (t10 * 30.0 * x2);
          x2bd += tb25d * (t10 * 30.0 * x2) + tb25 * (t10d * 30.0 * x2 + t10 * 30.0 * x2d);
          tb27 = f1b * (t10 * 30.0 * x2 * x2);
          tb27d = f1bd * (t10 * 30.0 * x2 * x2) + f1b * ((t10d * 30.0 * x2 + t10 * 30.0 * x2d) * x2
              + t10 * 30.0 * x2 * x2d);
          x2b += tb27 * (-2.0 + x2);
          x2bd += tb27d * (-2.0 + x2) + tb27 * x2d;
          x2b += tb27 * x2;
          x2bd += tb27d * x2 + tb27 * x2d;
          f1b = 0.0;
          f1bd = 0.0;
          tb24 = t10b / h2;
          tb24d = (t10bd - tb24 * h2d) * (1.0 / h2);
          p_iik21b += tb24;
          p_iik21bd += tb24d;
          p_iik2b -= tb24;
          p_iik2bd -= tb24d;
          h2b -= tb24 * t10;
          h2bd -= tb24d * t10 + tb24 * t10d;
          p_iik2b += f0b;
          p_iik2bd += f0bd;
          tb19 = f0b * (10.0 + x2 * (-15.0 + 6.0 * x2));
          tb19d = f0bd * (10.0 + x2 * (-15.0 + 6.0 * x2)) + f0b * (x2d * (-15.0 + 6.0 * x2) + x2 *
              (6.0 * x2d));
          tb20 = tb19 * x2;
          tb20d = tb19d * x2 + tb19 * x2d;
          tb21 = tb20 * x2;
          tb21d = tb20d * x2 + tb20 * x2d;
          tb22 = tb21 * x2;
          tb22d = tb21d * x2 + tb21 * x2d;
          p_iik21b += tb22;
          p_iik21bd += tb22d;
          p_iik2b -= tb22;
          p_iik2bd -= tb22d;
          x2b += tb21 * (p_iik21 - p_iik2);
          x2bd += tb21d * (p_iik21 - p_iik2) + tb21 * (p_iik21d - p_iik2d);
          x2b += tb20 * ((p_iik21 - p_iik2) * x2);
          x2bd += tb20d * ((p_iik21 - p_iik2) * x2) + tb20 * ((p_iik21d - p_iik2d) * x2 + (p_iik21 -
              p_iik2) * x2d);
          x2b += tb19 * ((p_iik21 - p_iik2) * x2 * x2);
          x2bd += tb19d * ((p_iik21 - p_iik2) * x2 * x2) + tb19 * (((p_iik21d - p_iik2d) * x2 +
              (p_iik21 - p_iik2) * x2d) * x2 + (p_iik21 - p_iik2) * x2 * x2d);
          tb23 = f0b * ((p_iik21 - p_iik2) * x2 * x2 * x2);
          tb23d = f0bd * ((p_iik21 - p_iik2) * x2 * x2 * x2) + f0b * ((((p_iik21d - p_iik2d) * x2 +
              (p_iik21 - p_iik2) * x2d) * x2 + (p_iik21 - p_iik2) * x2 * x2d) * x2 + (p_iik21 -
              p_iik2) * x2 * x2 * x2d);
          x2b += tb23 * (-15.0 + 6.0 * x2);
          x2bd += tb23d * (-15.0 + 6.0 * x2) + tb23 * (6.0 * x2d);
          x2b += tb23 * x2 * 6.0;
          x2bd += (tb23d * x2 + tb23 * x2d) * 6.0;
          f0b = 0.0;
          f0bd = 0.0;
          pb[t->funadr[i] + t->funn[i] + k2 + 1] += p_iik21b;
          pbd[t->funadr[i] + t->funn[i] + k2 + 1] += p_iik21bd;
          pb[t->funadr[i] + t->funn[i] + k2] += p_iik2b;
          pbd[t->funadr[i] + t->funn[i] + k2] += p_iik2bd;
          tb18 = x2b / h2;
          tb18d = (x2bd - tb18 * h2d) * (1.0 / h2);
          p_ik2b = -tb18;
          p_ik2bd = -tb18d;
          h2b -= tb18 * x2;
          h2bd -= tb18d * x2 + tb18 * x2d;
          pb[t->funadr[i] + k2 + 1] += h2b;
          pbd[t->funadr[i] + k2 + 1] += h2bd;
          p_ik2b -= h2b;
          p_ik2bd -= h2bd;
          pb[t->funadr[i] + k2] += p_ik2b;
          pbd[t->funadr[i] + k2] += p_ik2bd;
        }
      }
    } else if (t->funkind[i] == MAGGI_FUNCTION_RAMP) {
      p_i4 = p[t->funadr[i]];
      p_i4d = pd[t->funadr[i]];
      h3 = p[t->funadr[i] + 1] - p_i4;
      h3d = pd[t->funadr[i] + 1] - p_i4d;
      x3 = (time - p_i4) / h3;
      x3d = (-p_i4d - x3 * h3d) * (1.0 / h3);
      h3b = 0.0;
      h3bd = 0.0;
      x3b = 0.0;
      x3bd = 0.0;
      if (MAGGI_RE(time) <= MAGGI_RE(p[t->funadr[i]])) {
        f2b = 0.0;
        f2bd = 0.0;
        f1b = 0.0;
        f1bd = 0.0;
        pb[t->funadr[i] + 2] += f0b;
        pbd[t->funadr[i] + 2] += f0bd;
        f0b = 0.0;
        f0bd = 0.0;
      } else if (MAGGI_RE(time) >= MAGGI_RE(p[t->funadr[i] + 1])) {
        p_i3_3 = p[t->funadr[i] + 3];
        p_i3_3d = pd[t->funadr[i] + 3];
        f2b = 0.0;
        f2bd = 0.0;
        p_i3_3b = f1b;
        p_i3_3bd = f1bd;
        f1b = 0.0;
        f1bd = 0.0;
        pb[t->funadr[i] + 2] += f0b;
        pbd[t->funadr[i] + 2] += f0bd;
        p_i3_3b += f0b * (time - 0.5 * (p[t->funadr[i]] + p[t->funadr[i] + 1]));
        p_i3_3bd += f0bd * (time - 0.5 * (p[t->funadr[i]] + p[t->funadr[i] + 1])) - f0b * (0.5 *
            (pd[t->funadr[i]] + pd[t->funadr[i] + 1]));
        tb32 = f0b * p_i3_3;
        tb32d = f0bd * p_i3_3 + f0b * p_i3_3d;
        tb33 = tb32 * 0.5;
        tb33d = tb32d * 0.5;
        pb[t->funadr[i]] -= tb33;
        pbd[t->funadr[i]] -= tb33d;
        pb[t->funadr[i] + 1] -= tb33;
        pbd[t->funadr[i] + 1] -= tb33d;
        f0b = 0.0;
        f0bd = 0.0;
        pb[t->funadr[i] + 3] += p_i3_3b;
        pbd[t->funadr[i] + 3] += p_i3_3bd;
      } else {
        p_i3_4 = p[t->funadr[i] + 3];
        p_i3_4d = pd[t->funadr[i] + 3];
        t13 = p_i3_4 / h3;
        t13d = (p_i3_4d - t13 * h3d) * (1.0 / h3);
        tb45 = f2b * (1.0 + x3 * (-2.0 + x3));
        tb45d = f2bd * (1.0 + x3 * (-2.0 + x3)) + f2b * (x3d * (-2.0 + x3) + x3 * x3d);
        tb46 = tb45 * x3;
        tb46d = tb45d * x3 + tb45 * x3d;
        t13b = tb46 * x3 * 30.0;
        t13bd = (tb46d * x3 + tb46 * x3d) * 30.0;
        x3b += tb46 * (t13 * 30.0);
        x3bd += tb46d * (t13 * 30.0) + tb46 * (t13d * 30.0);
        x3b += tb45 * (t13 * 30.0 * x3);
        x3bd += tb45d * (t13 * 30.0 * x3) + tb45 * (t13d * 30.0 * x3 + t13 * 30.0 * x3d);
        tb47 = f2b * (t13 * 30.0 * x3 * x3);
        tb47d = f2bd * (t13 * 30.0 * x3 * x3) + f2b * ((t13d * 30.0 * x3 + t13 * 30.0 * x3d) * x3 +
            t13 * 30.0 * x3 * x3d);
        x3b += tb47 * (-2.0 + x3);
        x3bd += tb47d * (-2.0 + x3) + tb47 * x3d;
        x3b += tb47 * x3;
        x3bd += tb47d * x3 + tb47 * x3d;
        f2b = 0.0;
        f2bd = 0.0;
        tb44 = t13b / h3;
        tb44d = (t13bd - tb44 * h3d) * (1.0 / h3);
        p_i3_4b = tb44;
        p_i3_4bd = tb44d;
        h3b -= tb44 * t13;
        h3bd -= tb44d * t13 + tb44 * t13d;
        tb40 = f1b * (10.0 + x3 * (-15.0 + 6.0 * x3));
        tb40d = f1bd * (10.0 + x3 * (-15.0 + 6.0 * x3)) + f1b * (x3d * (-15.0 + 6.0 * x3) + x3 *
            (6.0 * x3d));
        tb41 = tb40 * x3;
        tb41d = tb40d * x3 + tb40 * x3d;
        tb42 = tb41 * x3;
        tb42d = tb41d * x3 + tb41 * x3d;
        p_i3_4b += tb42 * x3;
        p_i3_4bd += tb42d * x3 + tb42 * x3d;
        x3b += tb42 * p_i3_4;
        x3bd += tb42d * p_i3_4 + tb42 * p_i3_4d;
        x3b += tb41 * (p_i3_4 * x3);
        x3bd += tb41d * (p_i3_4 * x3) + tb41 * (p_i3_4d * x3 + p_i3_4 * x3d);
        x3b += tb40 * (p_i3_4 * x3 * x3);
        x3bd += tb40d * (p_i3_4 * x3 * x3) + tb40 * ((p_i3_4d * x3 + p_i3_4 * x3d) * x3 + p_i3_4 *
            x3 * x3d);
        tb43 = f1b * (p_i3_4 * x3 * x3 * x3);
        tb43d = f1bd * (p_i3_4 * x3 * x3 * x3) + f1b * (((p_i3_4d * x3 + p_i3_4 * x3d) * x3 + p_i3_4
            * x3 * x3d) * x3 + p_i3_4 * x3 * x3 * x3d);
        x3b += tb43 * (-15.0 + 6.0 * x3);
        x3bd += tb43d * (-15.0 + 6.0 * x3) + tb43 * (6.0 * x3d);
        x3b += tb43 * x3 * 6.0;
        x3bd += (tb43d * x3 + tb43 * x3d) * 6.0;
        f1b = 0.0;
        f1bd = 0.0;
        pb[t->funadr[i] + 2] += f0b;
        pbd[t->funadr[i] + 2] += f0bd;
        tb34 = f0b * (2.5 + x3 * (-3.0 + x3));
        tb34d = f0bd * (2.5 + x3 * (-3.0 + x3)) + f0b * (x3d * (-3.0 + x3) + x3 * x3d);
        tb35 = tb34 * x3;
        tb35d = tb34d * x3 + tb34 * x3d;
        tb36 = tb35 * x3;
        tb36d = tb35d * x3 + tb35 * x3d;
        tb37 = tb36 * x3;
        tb37d = tb36d * x3 + tb36 * x3d;
        tb38 = tb37 * x3;
        tb38d = tb37d * x3 + tb37 * x3d;
        p_i3_4b += tb38 * h3;
        p_i3_4bd += tb38d * h3 + tb38 * h3d;
        h3b += tb38 * p_i3_4;
        h3bd += tb38d * p_i3_4 + tb38 * p_i3_4d;
        x3b += tb37 * (p_i3_4 * h3);
        x3bd += tb37d * (p_i3_4 * h3) + tb37 * (p_i3_4d * h3 + p_i3_4 * h3d);
        x3b += tb36 * (p_i3_4 * h3 * x3);
        x3bd += tb36d * (p_i3_4 * h3 * x3) + tb36 * ((p_i3_4d * h3 + p_i3_4 * h3d) * x3 + p_i3_4 *
            h3 * x3d);
        x3b += tb35 * (p_i3_4 * h3 * x3 * x3);
        x3bd += tb35d * (p_i3_4 * h3 * x3 * x3) + tb35 * (((p_i3_4d * h3 + p_i3_4 * h3d) * x3 +
            p_i3_4 * h3 * x3d) * x3 + p_i3_4 * h3 * x3 * x3d);
        x3b += tb34 * (p_i3_4 * h3 * x3 * x3 * x3);
        x3bd += tb34d * (p_i3_4 * h3 * x3 * x3 * x3) + tb34 * ((((p_i3_4d * h3 + p_i3_4 * h3d) * x3
            + p_i3_4 * h3 * x3d) * x3 + p_i3_4 * h3 * x3 * x3d) * x3 + p_i3_4 * h3 * x3 * x3 * x3d);
        tb39 = f0b * (p_i3_4 * h3 * x3 * x3 * x3 * x3);
        tb39d = f0bd * (p_i3_4 * h3 * x3 * x3 * x3 * x3) + f0b * (((((p_i3_4d * h3 + p_i3_4 * h3d) *
            x3 + p_i3_4 * h3 * x3d) * x3 + p_i3_4 * h3 * x3 * x3d) * x3 + p_i3_4 * h3 * x3 * x3 *
            x3d) * x3 + p_i3_4 * h3 * x3 * x3 * x3 * x3d);
        x3b += tb39 * (-3.0 + x3);
        x3bd += tb39d * (-3.0 + x3) + tb39 * x3d;
        x3b += tb39 * x3;
        x3bd += tb39d * x3 + tb39 * x3d;
        f0b = 0.0;
        f0bd = 0.0;
        pb[t->funadr[i] + 3] += p_i3_4b;
        pbd[t->funadr[i] + 3] += p_i3_4bd;
      }
      tb31 = x3b / h3;
      tb31d = (x3bd - tb31 * h3d) * (1.0 / h3);
      p_i4b = -tb31;
      p_i4bd = -tb31d;
      h3b -= tb31 * x3;
      h3bd -= tb31d * x3 + tb31 * x3d;
      pb[t->funadr[i] + 1] += h3b;
      /* y0, then its rate rises as a quintic step, h x^4 (5/2 - 3 x + x^2), then it is straight */
      pbd[t->funadr[i] + 1] += h3bd;
      p_i4b -= h3b;
      p_i4bd -= h3bd;
      pb[t->funadr[i]] += p_i4b;
      pbd[t->funadr[i]] += p_i4bd;
    } else {
      k3 = maggi_piece(t->np, p, t->funadr[i], t->funn[i], time);
      if (k3 < 0) {
        p_i5 = p[t->funadr[i]];
        p_i5d = pd[t->funadr[i]];
        h4 = p[t->funadr[i] + 1] - p_i5;
        h4d = pd[t->funadr[i] + 1] - p_i5d;
        p_ii = p[t->funadr[i] + t->funn[i]];
        p_iid = pd[t->funadr[i] + t->funn[i]];
        t14 = (p[t->funadr[i] + t->funn[i] + 1] - p_ii) / h4;
        t14d = (pd[t->funadr[i] + t->funn[i] + 1] - p_iid - t14 * h4d) * (1.0 / h4);
        slope = t14 - h4 / 6.0 * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] +
            1][0]);
        sloped = t14d - (h4d / 6.0 * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] +
            1][0]) + h4 / 6.0 * (2.0 * spline0d[t->funspline[i]][0] + spline0d[t->funspline[i] +
            1][0]));
        f2b = 0.0;
        f2bd = 0.0;
        slopeb = f1b;
        slopebd = f1bd;
        f1b = 0.0;
        f1bd = 0.0;
        p_iib = f0b;
        p_iibd = f0bd;
        slopeb += f0b * (time - p_i5);
        slopebd += f0bd * (time - p_i5) - f0b * p_i5d;
        p_i5b = -(f0b * slope);
        p_i5bd = -(f0bd * slope + f0b * sloped);
        f0b = 0.0;
        f0bd = 0.0;
        t14b = slopeb;
        t14bd = slopebd;
        h4b = -(slopeb * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] + 1][0]) /
            6.0);
        h4bd = -((slopebd * (2.0 * spline0[t->funspline[i]][0] + spline0[t->funspline[i] + 1][0]) +
            slopeb * (2.0 * spline0d[t->funspline[i]][0] + spline0d[t->funspline[i] + 1][0])) /
            6.0);
        tb49 = slopeb * (h4 / 6.0);
        tb49d = slopebd * (h4 / 6.0) + slopeb * (h4d / 6.0);
        spline0b[t->funspline[i]][0] -= tb49 * 2.0;
        spline0bd[t->funspline[i]][0] -= tb49d * 2.0;
        spline0b[t->funspline[i] + 1][0] -= tb49;
        spline0bd[t->funspline[i] + 1][0] -= tb49d;
        tb48 = t14b / h4;
        tb48d = (t14bd - tb48 * h4d) * (1.0 / h4);
        pb[t->funadr[i] + t->funn[i] + 1] += tb48;
        pbd[t->funadr[i] + t->funn[i] + 1] += tb48d;
        p_iib -= tb48;
        p_iibd -= tb48d;
        h4b -= tb48 * t14;
        h4bd -= tb48d * t14 + tb48 * t14d;
        pb[t->funadr[i] + t->funn[i]] += p_iib;
        pbd[t->funadr[i] + t->funn[i]] += p_iibd;
        pb[t->funadr[i] + 1] += h4b;
        pbd[t->funadr[i] + 1] += h4bd;
        p_i5b -= h4b;
        p_i5bd -= h4bd;
        pb[t->funadr[i]] += p_i5b;
        pbd[t->funadr[i]] += p_i5bd;
      } else if (k3 > t->funn[i] - 2) {
        p_ii1 = p[t->funadr[i] + t->funn[i] - 1];
        p_ii1d = pd[t->funadr[i] + t->funn[i] - 1];
        h4_2 = p_ii1 - p[t->funadr[i] + t->funn[i] - 2];
        h4_2d = p_ii1d - pd[t->funadr[i] + t->funn[i] - 2];
        p_iii1 = p[t->funadr[i] + t->funn[i] + t->funn[i] - 1];
        p_iii1d = pd[t->funadr[i] + t->funn[i] + t->funn[i] - 1];
        t15 = (p_iii1 - p[t->funadr[i] + t->funn[i] + t->funn[i] - 2]) / h4_2;
        t15d = (p_iii1d - pd[t->funadr[i] + t->funn[i] + t->funn[i] - 2] - t15 * h4_2d) * (1.0 /
            h4_2);
        slope2 = t15 + h4_2 / 6.0 * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]);
        slope2d = t15d + (h4_2d / 6.0 * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]) + h4_2 / 6.0 * (spline0d[t->funspline[i] +
            t->funn[i] - 2][0] + 2.0 * spline0d[t->funspline[i] + t->funn[i] - 1][0]));
        f2b = 0.0;
        f2bd = 0.0;
        slope2b = f1b;
        slope2bd = f1bd;
        f1b = 0.0;
        f1bd = 0.0;
        p_iii1b = f0b;
        p_iii1bd = f0bd;
        slope2b += f0b * (time - p_ii1);
        slope2bd += f0bd * (time - p_ii1) - f0b * p_ii1d;
        p_ii1b = -(f0b * slope2);
        p_ii1bd = -(f0bd * slope2 + f0b * slope2d);
        f0b = 0.0;
        f0bd = 0.0;
        t15b = slope2b;
        t15bd = slope2bd;
        h4_2b = slope2b * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]) / 6.0;
        h4_2bd = (slope2bd * (spline0[t->funspline[i] + t->funn[i] - 2][0] + 2.0 *
            spline0[t->funspline[i] + t->funn[i] - 1][0]) + slope2b * (spline0d[t->funspline[i] +
            t->funn[i] - 2][0] + 2.0 * spline0d[t->funspline[i] + t->funn[i] - 1][0])) / 6.0;
        tb51 = slope2b * (h4_2 / 6.0);
        tb51d = slope2bd * (h4_2 / 6.0) + slope2b * (h4_2d / 6.0);
        spline0b[t->funspline[i] + t->funn[i] - 2][0] += tb51;
        spline0bd[t->funspline[i] + t->funn[i] - 2][0] += tb51d;
        spline0b[t->funspline[i] + t->funn[i] - 1][0] += tb51 * 2.0;
        spline0bd[t->funspline[i] + t->funn[i] - 1][0] += tb51d * 2.0;
        tb50 = t15b / h4_2;
        tb50d = (t15bd - tb50 * h4_2d) * (1.0 / h4_2);
        p_iii1b += tb50;
        p_iii1bd += tb50d;
        pb[t->funadr[i] + t->funn[i] + t->funn[i] - 2] -= tb50;
        pbd[t->funadr[i] + t->funn[i] + t->funn[i] - 2] -= tb50d;
        h4_2b -= tb50 * t15;
        h4_2bd -= tb50d * t15 + tb50 * t15d;
        pb[t->funadr[i] + t->funn[i] + t->funn[i] - 1] += p_iii1b;
        pbd[t->funadr[i] + t->funn[i] + t->funn[i] - 1] += p_iii1bd;
        p_ii1b += h4_2b;
        p_ii1bd += h4_2bd;
        pb[t->funadr[i] + t->funn[i] - 2] -= h4_2b;
        pbd[t->funadr[i] + t->funn[i] - 2] -= h4_2bd;
        pb[t->funadr[i] + t->funn[i] - 1] += p_ii1b;
        pbd[t->funadr[i] + t->funn[i] - 1] += p_ii1bd;
      } else {
        p_ik31 = p[t->funadr[i] + k3 + 1];
        p_ik31d = pd[t->funadr[i] + k3 + 1];
        p_ik3 = p[t->funadr[i] + k3];
        p_ik3d = pd[t->funadr[i] + k3];
        h4_3 = p_ik31 - p_ik3;
        h4_3d = p_ik31d - p_ik3d;
        a = p_ik31 - time;
        ad = p_ik31d;
        c2 = time - p_ik3;
        c2d = -p_ik3d;
        p_iik3 = p[t->funadr[i] + t->funn[i] + k3];
        p_iik3d = pd[t->funadr[i] + t->funn[i] + k3];
        t16 = (p[t->funadr[i] + t->funn[i] + k3 + 1] - p_iik3) / h4_3;
        t16d = (pd[t->funadr[i] + t->funn[i] + k3 + 1] - p_iik3d - t16 * h4_3d) * (1.0 / h4_3);
        spline0_ik310 = spline0[t->funspline[i] + k3 + 1][0];
        spline0_ik310d = spline0d[t->funspline[i] + k3 + 1][0];
        spline0_ik30 = spline0[t->funspline[i] + k3][0];
        spline0_ik30d = spline0d[t->funspline[i] + k3][0];
        e = t16 - h4_3 / 6.0 * (spline0_ik310 - spline0_ik30);
        ed = t16d - (h4_3d / 6.0 * (spline0_ik310 - spline0_ik30) + h4_3 / 6.0 * (spline0_ik310d -
            spline0_ik30d));
        t17 = 6.0 * h4_3;
        t17d = 6.0 * h4_3d;
        t18 = (spline0_ik30 * a * a * a + spline0_ik310 * c2 * c2 * c2) / t17;
        t18d = (((spline0_ik30d * a + spline0_ik30 * ad) * a + spline0_ik30 * a * ad) * a +
            spline0_ik30 * a * a * ad + (((spline0_ik310d * c2 + spline0_ik310 * c2d) * c2 +
            spline0_ik310 * c2 * c2d) * c2 + spline0_ik310 * c2 * c2 * c2d) - t18 * t17d) * (1.0 /
            t17);
        t19 = 2.0 * h4_3;
        t19d = 2.0 * h4_3d;
        t20 = (spline0_ik310 * c2 * c2 - spline0_ik30 * a * a) / t19;
        t20d = ((spline0_ik310d * c2 + spline0_ik310 * c2d) * c2 + spline0_ik310 * c2 * c2d -
            ((spline0_ik30d * a + spline0_ik30 * ad) * a + spline0_ik30 * a * ad) - t20 * t19d) *
            (1.0 / t19);
        t21 = (spline0_ik30 * a + spline0_ik310 * c2) / h4_3;
        t21d = (spline0_ik30d * a + spline0_ik30 * ad + (spline0_ik310d * c2 + spline0_ik310 * c2d)
            - t21 * h4_3d) * (1.0 / h4_3);
        t21b = f2b;
        t21bd = f2bd;
        f2b = 0.0;
        f2bd = 0.0;
        tb64 = t21b / h4_3;
        tb64d = (t21bd - tb64 * h4_3d) * (1.0 / h4_3);
        spline0_ik30b = tb64 * a;
        spline0_ik30bd = tb64d * a + tb64 * ad;
        ab = tb64 * spline0_ik30;
        abd = tb64d * spline0_ik30 + tb64 * spline0_ik30d;
        spline0_ik310b = tb64 * c2;
        spline0_ik310bd = tb64d * c2 + tb64 * c2d;
        c2b = tb64 * spline0_ik310;
        c2bd = tb64d * spline0_ik310 + tb64 * spline0_ik310d;
        h4_3b = -(tb64 * t21);
        h4_3bd = -(tb64d * t21 + tb64 * t21d);
        t20b = f1b;
        t20bd = f1bd;
        eb = f1b;
        ebd = f1bd;
        f1b = 0.0;
        f1bd = 0.0;
        tb61 = t20b / t19;
        tb61d = (t20bd - tb61 * t19d) * (1.0 / t19);
        tb62 = tb61 * c2;
        tb62d = tb61d * c2 + tb61 * c2d;
        spline0_ik310b += tb62 * c2;
        spline0_ik310bd += tb62d * c2 + tb62 * c2d;
        c2b += tb62 * spline0_ik310;
        c2bd += tb62d * spline0_ik310 + tb62 * spline0_ik310d;
        c2b += tb61 * (spline0_ik310 * c2);
        c2bd += tb61d * (spline0_ik310 * c2) + tb61 * (spline0_ik310d * c2 + spline0_ik310 * c2d);
        tb63 = tb61 * a;
        tb63d = tb61d * a + tb61 * ad;
        spline0_ik30b -= tb63 * a;
        spline0_ik30bd -= tb63d * a + tb63 * ad;
        ab -= tb63 * spline0_ik30;
        abd -= tb63d * spline0_ik30 + tb63 * spline0_ik30d;
        ab -= tb61 * (spline0_ik30 * a);
        abd -= tb61d * (spline0_ik30 * a) + tb61 * (spline0_ik30d * a + spline0_ik30 * ad);
        t19b = -(tb61 * t20);
        t19bd = -(tb61d * t20 + tb61 * t20d);
        h4_3b += t19b * 2.0;
        h4_3bd += t19bd * 2.0;
        t18b = f0b;
        t18bd = f0bd;
        p_iik3b = f0b;
        p_iik3bd = f0bd;
        tb59 = f0b / 6.0;
        tb59d = f0bd / 6.0;
        tb60 = tb59 * h4_3;
        tb60d = tb59d * h4_3 + tb59 * h4_3d;
        spline0_ik30b -= tb60 * h4_3;
        spline0_ik30bd -= tb60d * h4_3 + tb60 * h4_3d;
        h4_3b -= tb60 * spline0_ik30;
        h4_3bd -= tb60d * spline0_ik30 + tb60 * spline0_ik30d;
        h4_3b -= tb59 * (spline0_ik30 * h4_3);
        h4_3bd -= tb59d * (spline0_ik30 * h4_3) + tb59 * (spline0_ik30d * h4_3 + spline0_ik30 *
            h4_3d);
        eb += f0b * c2;
        ebd += f0bd * c2 + f0b * c2d;
        c2b += f0b * e;
        c2bd += f0bd * e + f0b * ed;
        f0b = 0.0;
        f0bd = 0.0;
        tb54 = t18b / t17;
        tb54d = (t18bd - tb54 * t17d) * (1.0 / t17);
        tb55 = tb54 * a;
        tb55d = tb54d * a + tb54 * ad;
        tb56 = tb55 * a;
        tb56d = tb55d * a + tb55 * ad;
        spline0_ik30b += tb56 * a;
        spline0_ik30bd += tb56d * a + tb56 * ad;
        ab += tb56 * spline0_ik30;
        abd += tb56d * spline0_ik30 + tb56 * spline0_ik30d;
        ab += tb55 * (spline0_ik30 * a);
        abd += tb55d * (spline0_ik30 * a) + tb55 * (spline0_ik30d * a + spline0_ik30 * ad);
        ab += tb54 * (spline0_ik30 * a * a);
        abd += tb54d * (spline0_ik30 * a * a) + tb54 * ((spline0_ik30d * a + spline0_ik30 * ad) * a
            + spline0_ik30 * a * ad);
        tb57 = tb54 * c2;
        tb57d = tb54d * c2 + tb54 * c2d;
        tb58 = tb57 * c2;
        tb58d = tb57d * c2 + tb57 * c2d;
        spline0_ik310b += tb58 * c2;
        spline0_ik310bd += tb58d * c2 + tb58 * c2d;
        c2b += tb58 * spline0_ik310;
        c2bd += tb58d * spline0_ik310 + tb58 * spline0_ik310d;
        c2b += tb57 * (spline0_ik310 * c2);
        c2bd += tb57d * (spline0_ik310 * c2) + tb57 * (spline0_ik310d * c2 + spline0_ik310 * c2d);
        c2b += tb54 * (spline0_ik310 * c2 * c2);
        c2bd += tb54d * (spline0_ik310 * c2 * c2) + tb54 * ((spline0_ik310d * c2 + spline0_ik310 *
            c2d) * c2 + spline0_ik310 * c2 * c2d);
        t17b = -(tb54 * t18);
        t17bd = -(tb54d * t18 + tb54 * t18d);
        h4_3b += t17b * 6.0;
        h4_3bd += t17bd * 6.0;
        t16b = eb;
        t16bd = ebd;
        h4_3b -= eb * (spline0_ik310 - spline0_ik30) / 6.0;
        h4_3bd -= (ebd * (spline0_ik310 - spline0_ik30) + eb * (spline0_ik310d - spline0_ik30d)) /
            6.0;
        tb53 = eb * (h4_3 / 6.0);
        tb53d = ebd * (h4_3 / 6.0) + eb * (h4_3d / 6.0);
        spline0_ik310b -= tb53;
        spline0_ik310bd -= tb53d;
        spline0_ik30b += tb53;
        spline0_ik30bd += tb53d;
        spline0b[t->funspline[i] + k3][0] += spline0_ik30b;
        spline0bd[t->funspline[i] + k3][0] += spline0_ik30bd;
        spline0b[t->funspline[i] + k3 + 1][0] += spline0_ik310b;
        spline0bd[t->funspline[i] + k3 + 1][0] += spline0_ik310bd;
        tb52 = t16b / h4_3;
        tb52d = (t16bd - tb52 * h4_3d) * (1.0 / h4_3);
        pb[t->funadr[i] + t->funn[i] + k3 + 1] += tb52;
        pbd[t->funadr[i] + t->funn[i] + k3 + 1] += tb52d;
        p_iik3b -= tb52;
        p_iik3bd -= tb52d;
        h4_3b -= tb52 * t16;
        h4_3bd -= tb52d * t16 + tb52 * t16d;
        pb[t->funadr[i] + t->funn[i] + k3] += p_iik3b;
        pbd[t->funadr[i] + t->funn[i] + k3] += p_iik3bd;
        p_ik3b = -c2b;
        p_ik3bd = -c2bd;
        p_ik31b = ab;
        p_ik31bd = abd;
        p_ik31b += h4_3b;
        p_ik31bd += h4_3bd;
        p_ik3b -= h4_3b;
        p_ik3bd -= h4_3bd;
        pb[t->funadr[i] + k3] += p_ik3b;
        pbd[t->funadr[i] + k3] += p_ik3bd;
        pb[t->funadr[i] + k3 + 1] += p_ik31b;
        pbd[t->funadr[i] + k3 + 1] += p_ik31bd;
      }
    }
  }
}
