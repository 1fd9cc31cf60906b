/* Tangent of the adjoint of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra and Za carry minus gravity; p begins with gravity */
void maggi_sensors_b_d(const maggi_topo *t, const double p[restrict t->np],
                       const double pd[restrict t->np], double pb[restrict t->np],
                       double pbd[restrict t->np], const double origin[restrict 3],
                       const double spring0[restrict t->nspring],
                       const double spring0d[restrict t->nspring],
                       double spring0b[restrict t->nspring], double spring0bd[restrict t->nspring],
                       const double q[restrict t->nq], const double qd[restrict t->nq],
                       double qb[restrict t->nq], double qbd[restrict t->nq],
                       const double v[restrict t->nq], const double vd[restrict t->nq],
                       double vb[restrict t->nq], double vbd[restrict t->nq],
                       const double A[restrict t->nbody + 1][9],
                       const double Ad[restrict t->nbody + 1][9],
                       double Ab[restrict t->nbody + 1][9], double Abd[restrict t->nbody + 1][9],
                       const double x[restrict t->nbody + 1][3],
                       const double xd[restrict t->nbody + 1][3],
                       double xb[restrict t->nbody + 1][3], double xbd[restrict t->nbody + 1][3],
                       const double r[restrict t->npoint][3],
                       const double rd[restrict t->npoint][3], double rb[restrict t->npoint][3],
                       double rbd[restrict t->npoint][3], const double Z[restrict t->nbody + 1][6],
                       const double Zd[restrict t->nbody + 1][6],
                       double Zb[restrict t->nbody + 1][6], double Zbd[restrict t->nbody + 1][6],
                       const double rv[restrict t->npoint][3],
                       const double rvd[restrict t->npoint][3], double rvb[restrict t->npoint][3],
                       double rvbd[restrict t->npoint][3],
                       const double Za[restrict t->nbody + 1][6],
                       const double Zad[restrict t->nbody + 1][6],
                       double Zab[restrict t->nbody + 1][6], double Zabd[restrict t->nbody + 1][6],
                       const double ra[restrict t->npoint][3],
                       const double rad[restrict t->npoint][3], double rab[restrict t->npoint][3],
                       double rabd[restrict t->npoint][3], const double lambda[restrict t->nrow],
                       const double lambdad[restrict t->nrow], double lambdab[restrict t->nrow],
                       double lambdabd[restrict t->nrow],
                       const double slip[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                       const double slipd[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                       double slipb[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                       double slipbd[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                       const double grip[restrict t->nwheel][6],
                       const double gripd[restrict t->nwheel][6],
                       double gripb[restrict t->nwheel][6], double gripbd[restrict t->nwheel][6],
                       double s[restrict t->nsensor][3], double sd[restrict t->nsensor][3],
                       double sb[restrict t->nsensor][3], double sbd[restrict t->nsensor][3])
{
  int a, a3, a3_2, b, b7, i, j, k, k3, n2;
  double A_j0, A_j0_2, A_j0_2b, A_j0_2bd, A_j0_2d, A_j0_3, A_j0_3b, A_j0_3bd, A_j0_3d, A_j0_4,
      A_j0_4b, A_j0_4bd, A_j0_4d, A_j0b, A_j0bd, A_j0d, A_j3, A_j3_2, A_j3_2b, A_j3_2bd, A_j3_2d,
      A_j3_3, A_j3_3b, A_j3_3bd, A_j3_3d, A_j3_4, A_j3_4b, A_j3_4bd, A_j3_4d, A_j3b, A_j3bd, A_j3d,
      A_j7, A_j7b, A_j7bd, A_j7d, A_j8, A_j8b, A_j8bd, A_j8d, Z_j3, Z_j3b, Z_j3bd, Z_j3d, Z_j4,
      Z_j4b, Z_j4bd, Z_j4d, a2, a2b, a2bd, a2d, ay, ayb, aybd, ayd, b2, b2b, b2bd, b2d, b3, b3b,
      b3bd, b3d, b4, b4b, b4bd, b4d, b5, b5b, b5bd, b5d, b6, b6b, b6bd, b6d, c, c2, c2b, c2bd, c2d,
      c3, c3b, c3bd, c3d, c4, c4b, c4bd, c4d, cb, cbd, cd, d, dampingb, dampingbd, db, dbd, dd, dfz,
      dfzb, dfzbd, dfzd, dv, dvb, dvbd, dvd, e0, e0b, e0bd, e0d, e1, e10, e10b, e10bd, e10d, e11,
      e11b, e11bd, e11d, e12, e12b, e12bd, e12d, e1b, e1bd, e1d, e20, e20b, e20bd, e20d, e21, e21b,
      e21bd, e21d, e22, e22b, e22bd, e22d, e2_2, e2_2b, e2_2bd, e2_2d, e3, e3b, e3bd, e3d, e4, e4b,
      e4bd, e4d, e5, e5b, e5bd, e5d, e6, e6b, e6bd, e6d, e7, e7b, e7bd, e7d, e8, e8b, e8bd, e8d, e9,
      e9b, e9bd, e9d, ev0, ev0b, ev0bd, ev0d, ev1, ev1b, ev1bd, ev1d, ev20, ev20b, ev20bd, ev20d,
      ev21, ev21b, ev21bd, ev21d, ev22, ev22b, ev22bd, ev22d, ev2_2, ev2_2b, ev2_2bd, ev2_2d, ex,
      exb, exbd, exd, ey, eyb, eybd, eyd, f0b, f0bd, f1b, f1bd, f2b, f2bd, fx, fxb, fxbd, fxd, fy,
      fyb, fybd, fyd, fz, fz0, fz0_2, fz0_2b, fz0_2bd, fz0_2d, fz0b, fz0bd, fz0d, fzb, fzbd, fzd,
      g0, g0_2, g0_2b, g0_2bd, g0_2d, g0_3, g0_3b, g0_3bd, g0_3d, g0_4, g0_4b, g0_4bd, g0_4d, g0b,
      g0bd, g0d, g1, g1_2, g1_2b, g1_2bd, g1_2d, g1_3, g1_3b, g1_3bd, g1_3d, g1_4, g1_4b, g1_4bd,
      g1_4d, g1b, g1bd, g1d, g20, g20b, g20bd, g20d, g21, g21b, g21bd, g21d, g22, g22b, g22bd, g22d,
      g23, g23b, g23bd, g23d, g24, g24b, g24bd, g24d, g25, g25b, g25bd, g25d, g26, g26b, g26bd,
      g26d, g27, g27b, g27bd, g27d, g28, g28b, g28bd, g28d, g2_2, g2_2b, g2_2bd, g2_2d, g2_4b,
      g2_4bd, g2_5, g2_5b, g2_5bd, g2_5d, gamma, gammab, gammabd, gammad, gx, gx2, gx2b, gx2bd,
      gx2d, gxb, gxbd, gxd, gy, gy2, gy2b, gy2bd, gy2d, gyb, gybd, gyd, h, h2, h2b, h2bd, h2d, h3,
      h3b, h3bd, h3d, hb, hbd, hd, ka, kab, kabd, kad, kappa, kappab, kappabd, kappad, kx, kxb,
      kxbd, kxd, l, l2, l2b, l2bd, l2d, l3, l3b, l3bd, l3d, lb, lbd, ld, lv, lvb, lvbd, lvd, m, mb,
      mbd, md, mux, muxb, muxbd, muxd, muy, muyb, muybd, muyd, n30, n30b, n30bd, n30d, n31, n31b,
      n31bd, n31d, n32, n32b, n32bd, n32d, n40, n40b, n40bd, n40d, n41, n41b, n41bd, n41d, n42,
      n42b, n42bd, n42d, n5, n5b, n5bd, n5d, n6, n6b, n6bd, n6d, one0, one0b, one0bd, one0d, one1,
      one1b, one1bd, one1d, one2, one2b, one2bd, one2d, one3, one3b, one3bd, one3d, p2, p2b, p2bd,
      p2d, p3, p3b, p3bd, p3d, p4, p4b, p4bd, p4d, p5, p5b, p5bd, p5d, p6, p6b, p6bd, p6d, p_i,
      p_i1, p_i1b, p_i1bd, p_i1d, p_i2, p_i2b, p_i2bd, p_i2d, p_i3, p_i3b, p_i3bd, p_i3d, p_ib,
      p_ibd, p_id, p_k34, p_k34b, p_k34bd, p_k34d, p_k35, p_k35b, p_k35bd, p_k35d, peak, peakb,
      peakbd, peakd, r2, r2b, r2bd, r2d, roll, rollb, rollbd, rolld, rv_k0, rv_k0_2, rv_k0_2b,
      rv_k0_2bd, rv_k0_2d, rv_k0_3, rv_k0_3b, rv_k0_3bd, rv_k0_3d, rv_k0b, rv_k0bd, rv_k0d, rv_k1,
      rv_k1_2, rv_k1_2b, rv_k1_2bd, rv_k1_2d, rv_k1_3, rv_k1_3b, rv_k1_3bd, rv_k1_3d, rv_k1b,
      rv_k1bd, rv_k1d, rv_k2, rv_k2b, rv_k2bd, rv_k2d, s2, s2b, s2bd, s2d, s3, s3b, s3bd, s3d,
      shift, shift2, shift2b, shift2bd, shift2d, shiftb, shiftbd, shiftd, side, slip_n2b, slip_n2bd,
      sumb, sumbd, t10, t100, t100b, t100bd, t100d, t101, t101b, t101bd, t101d, t102, t102b, t102bd,
      t102d, t103, t103b, t103bd, t103d, t104, t104b, t104bd, t104d, t105, t105b, t105bd, t105d,
      t106, t106b, t106bd, t106d, t107, t107b, t107bd, t107d, t108, t108b, t108bd, t108d, t109,
      t109b, t109bd, t109d, t10b, t10bd, t10d, t11, t110, t110b, t110bd, t110d, t111, t111b, t111bd,
      t111d, t112, t112b, t112bd, t112d, t113, t113b, t113bd, t113d, t114, t114b, t114bd, t114d,
      t115, t115b, t115bd, t115d, t116, t116b, t116bd, t116d, t117, t117b, t117bd, t117d, t118,
      t118b, t118bd, t118d, t119, t119b, t119bd, t119d, t11b, t11bd, t11d, t12, t120, t120b, t120bd,
      t120d, t121, t121b, t121bd, t121d, t122, t122b, t122bd, t122d, t123, t123b, t123bd, t123d,
      t124, t124b, t124bd, t124d, t125, t125b, t125bd, t125d, t126, t126b, t126bd, t126d, t127,
      t127b, t127bd, t127d, t128, t128b, t128bd, t128d, t129, t129b, t129bd, t129d, t12b, t12bd,
      t12d, t130, t130b, t130bd, t130d, t131, t131b, t131bd, t131d, t132, t132b, t132bd, t132d,
      t133, t133b, t133bd, t133d, t134, t134b, t134bd, t134d, t135, t135b, t135bd, t135d, t136,
      t136b, t136bd, t136d, t137, t137b, t137bd, t137d, t138, t138b, t138bd, t138d, t139, t139b,
      t139bd, t139d, t13b, t13bd, t14, t140, t140b, t140bd, t140d, t141, t141b, t141bd, t141d, t142,
      t142b, t142bd, t142d, t143, t143b, t143bd, t143d, t144, t144b, t144bd, t144d, t145, t145b,
      t145bd, t145d, t146, t146b, t146bd, t146d, t147, t147b, t147bd, t147d, t148, t148b, t148bd,
      t148d, t149b, t149bd, t14b, t14bd, t14d, t15, t15b, t15bd, t15d, t16, t16b, t16bd, t16d, t17,
      t17b, t17bd, t17d, t18, t18b, t18bd, t18d, t19, t19b, t19bd, t19d, t2, t20, t20b, t20bd, t20d,
      t21, t21b, t21bd, t21d, t22, t22b, t22bd, t22d, t23, t23b, t23bd, t23d, t24, t24b, t24bd,
      t24d, t25, t25b, t25bd, t25d, t26, t26b, t26bd, t26d, t27, t27b, t27bd, t27d, t28, t28b,
      t28bd, t28d, t29, t29b, t29bd, t29d, t2b, t2bd, t2d, t3, t30, t30b, t30bd, t30d, t31, t31b,
      t31bd, t31d, t32, t32b, t32bd, t32d, t33, t33b, t33bd, t33d, t34, t34b, t34bd, t34d, t35,
      t35b, t35bd, t35d, t36, t36b, t36bd, t36d, t37, t37b, t37bd, t37d, t38, t38b, t38bd, t38d,
      t39, t39b, t39bd, t39d, t3b, t3bd, t3d, t4, t40, t40b, t40bd, t40d, t41, t41b, t41bd, t41d,
      t42, t42b, t42bd, t42d, t43, t43b, t43bd, t43d, t44, t44b, t44bd, t44d, t45, t45b, t45bd,
      t45d, t46, t46b, t46bd, t46d, t47, t47b, t47bd, t47d, t48, t48b, t48bd, t48d, t49, t49b,
      t49bd, t49d, t4b, t4bd, t4d, t5, t50, t50b, t50bd, t50d, t51, t51b, t51bd, t51d, t52, t52b,
      t52bd, t52d, t53, t53b, t53bd, t53d, t54, t54b, t54bd, t54d, t55, t55b, t55bd, t55d, t56,
      t56b, t56bd, t56d, t57, t57b, t57bd, t57d, t58, t58b, t58bd, t58d, t59, t59b, t59bd, t59d,
      t5b, t5bd, t5d, t6, t60, t60b, t60bd, t60d, t61, t61b, t61bd, t61d, t62, t62b, t62bd, t62d,
      t63, t63b, t63bd, t63d, t64, t64b, t64bd, t64d, t65, t65b, t65bd, t65d, t66, t66b, t66bd,
      t66d, t67, t67b, t67bd, t67d, t68, t68b, t68bd, t68d, t69, t69b, t69bd, t69d, t6b, t6bd, t6d,
      t7, t70, t70b, t70bd, t70d, t71, t71b, t71bd, t71d, t72, t72b, t72bd, t72d, t73, t73b, t73bd,
      t73d, t74, t74b, t74bd, t74d, t75, t75b, t75bd, t75d, t76, t76b, t76bd, t76d, t77, t77b,
      t77bd, t77d, t78, t78b, t78bd, t78d, t79, t79b, t79bd, t79d, t7b, t7bd, t7d, t8, t80, t80b,
      t80bd, t80d, t81, t81b, t81bd, t81d, t82, t82b, t82bd, t82d, t83, t83b, t83bd, t83d, t84,
      t84b, t84bd, t84d, t85, t85b, t85bd, t85d, t86, t86b, t86bd, t86d, t87, t87b, t87bd, t87d,
      t88, t88b, t88bd, t88d, t89, t89b, t89bd, t89d, t8b, t8bd, t8d, t9, t90, t90b, t90bd, t90d,
      t91, t91b, t91bd, t91d, t92, t92b, t92bd, t92d, t93, t93b, t93bd, t93d, t94, t94b, t94bd,
      t94d, t95, t95b, t95bd, t95d, t96, t96b, t96bd, t96d, t97, t97b, t97bd, t97d, t98, t98b,
      t98bd, t98d, t99, t99b, t99bd, t99d, t9b, t9bd, t9d, tb10, tb100, tb100d, tb101, tb101d,
      tb102, tb102d, tb103, tb103d, tb104, tb104d, tb105, tb105d, tb106, tb106d, tb107, tb107d,
      tb108, tb108d, tb109, tb109d, tb10d, tb11, tb110, tb110d, tb111, tb111d, tb112, tb112d, tb113,
      tb113d, tb114, tb114d, tb115, tb115d, tb116, tb116d, tb117, tb117d, tb118, tb118d, tb119,
      tb119d, tb11d, tb12, tb120, tb120d, tb121, tb121d, tb122, tb122d, tb123, tb123d, tb124,
      tb124d, tb125, tb125d, tb126, tb126d, tb127, tb127d, tb128, tb128d, tb129, tb129d, tb12d,
      tb13, tb130, tb130d, tb131, tb131d, tb132, tb132d, tb133, tb133d, tb134, tb134d, tb135,
      tb135d, tb136, tb136d, tb137, tb137d, tb138, tb138d, tb139, tb139d, tb13d, tb14, tb140,
      tb140d, tb141, tb141d, tb142, tb142d, tb143, tb143d, tb144, tb144d, tb145, tb145d, tb146,
      tb146d, tb147, tb147d, tb148, tb148d, tb149, tb149d, tb14d, tb15, tb150, tb150d, tb151,
      tb151d, tb152, tb152d, tb153, tb153d, tb154, tb154d, tb155, tb155d, tb156, tb156d, tb157,
      tb157d, tb158, tb158d, tb15d, tb16, tb16d, tb17, tb17d, tb18, tb18d, tb19, tb19d, tb2, tb20,
      tb20d, tb21, tb21d, tb22, tb22d, tb23, tb23d, tb24, tb24d, tb25, tb25d, tb26, tb26d, tb27,
      tb27d, tb28, tb28d, tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31, tb31d, tb32, tb32d, tb33,
      tb33d, tb34, tb34d, tb35, tb35d, tb36, tb36d, tb37, tb37d, tb38, tb38d, tb39, tb39d, tb3d,
      tb4, tb40, tb40d, tb41, tb41d, tb42, tb42d, tb43, tb43d, tb44, tb44d, tb45, tb45d, tb46,
      tb46d, tb47, tb47d, tb48, tb48d, tb49, tb49d, tb4d, tb5, tb50, tb50d, tb51, tb51d, tb52,
      tb52d, tb53, tb53d, tb54, tb54d, tb55, tb55d, tb56, tb56d, tb57, tb57d, tb58, tb58d, tb59,
      tb59d, tb5d, tb6, tb60, tb60d, tb61, tb61d, tb62, tb62d, tb63, tb63d, tb64, tb64d, tb65,
      tb65d, tb66, tb66d, tb67, tb67d, tb68, tb68d, tb69, tb69d, tb6d, tb7, tb70, tb70d, tb71,
      tb71d, tb72, tb72d, tb73, tb73d, tb74, tb74d, tb75, tb75d, tb76, tb76d, tb77, tb77d, tb78,
      tb78d, tb79, tb79d, tb7d, tb8, tb80, tb80d, tb81, tb81d, tb82, tb82d, tb83, tb83d, tb84,
      tb84d, tb85, tb85d, tb86, tb86d, tb87, tb87d, tb88, tb88d, tb89, tb89d, tb8d, tb9, tb90,
      tb90d, tb91, tb91d, tb92, tb92d, tb93, tb93d, tb94, tb94d, tb95, tb95d, tb96, tb96d, tb97,
      tb97d, tb98, tb98d, tb99, tb99d, tb9d, torque0b, torque0bd, u20, u20b, u20bd, u20d, u21, u21b,
      u21bd, u21d, ux, uxb, uxbd, uxd, uy, uyb, uybd, uyd, v2, v2b, v2bd, v2d, w, wb, wbd, wd, wx1,
      wx1b, wx1bd, wx1d, wy1, wy1b, wy1bd, wy1d, x2, x2b, x2bd, x2d, x30, x30b, x30bd, x30d, x31,
      x31b, x31bd, x31d, x32, x32b, x32bd, x32d, x33, x33b, x33bd, x33d, x34, x34b, x34bd, x34d,
      x35, x35b, x35bd, x35d, x4, x4b, x4bd, x4d, x5, x5b, x5bd, x5d, x6, x6b, x6bd, x6d, x7, x7b,
      x7bd, x7d, x8, x8b, x8bd, x8d, x9, x9b, x9bd, x9d, xv, xvb, xvbd, xvd, y0, y0_2, y0_2b,
      y0_2bd, y0_2d, y0_3, y0_3b, y0_3bd, y0_3d, y0b, y0bd, y0d, y1, y10, y10b, y10bd, y10d, y11,
      y11b, y11bd, y11d, y12, y12b, y12bd, y12d, y13, y13b, y13bd, y13d, y14, y14b, y14bd, y14d,
      y15, y15b, y15bd, y15d, y16, y16b, y16bd, y16d, y17, y17b, y17bd, y17d, y18, y18b, y18bd,
      y18d, y1b, y1bd, y1d, y2, y2_2, y2_2b, y2_2bd, y2_2d, y2b, y2bd, y2d, y3, y3_2, y3_2b, y3_2bd,
      y3_2d, y3b, y3bd, y3d, y4, y4_2, y4_2b, y4_2bd, y4_2d, y4b, y4bd, y4d, y5, y5_2, y5_2b,
      y5_2bd, y5_2d, y5b, y5bd, y5d, y6, y6b, y6bd, y6d, y7, y7b, y7bd, y7d, y8, y8b, y8bd, y8d, y9,
      y9b, y9bd, y9d, z0, z0_2, z0_2b, z0_2bd, z0_2d, z0_3b, z0_3bd, z0_4b, z0_4bd, z0_5b, z0_5bd,
      z0b, z0bd, z0d, z10, z10b, z10bd, z10d, z11, z11b, z11bd, z11d, z1_2b, z1_2bd, z1_3, z1_3b,
      z1_3bd, z1_3d, z1b, z1bd, z2, z2b, z2bd, z2d, z3, z3b, z3bd, z3d, z4, z4b, z4bd, z4d, z5, z5b,
      z5bd, z5d, z6, z6b, z6bd, z6d, z7, z7b, z7bd, z7d, z8, z8b, z8bd, z8d, z9, z9b, z9bd, z9d;

  (void)origin;
  (void)x;
  (void)xd;
  (void)Za;
  (void)Zad;
  (void)lambda;
  (void)lambdad;
  for (i = t->nsensor - 1; i >= 0; --i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n2 = t->sensorelement[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
      tb4 = sb[i][2];
      tb4d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      rb[k][2] += tb4;
      rbd[k][2] += tb4d;
      xb[t->nbody][2] -= tb4;
      xbd[t->nbody][2] -= tb4d;
      tb3 = sb[i][1];
      tb3d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      rb[k][1] += tb3;
      rbd[k][1] += tb3d;
      xb[t->nbody][1] -= tb3;
      xbd[t->nbody][1] -= tb3d;
      tb2 = sb[i][0];
      tb2d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      rb[k][0] += tb2;
      rbd[k][0] += tb2d;
      xb[t->nbody][0] -= tb2;
      xbd[t->nbody][0] -= tb2d;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
      rvb[k][2] += sb[i][2];
      rvbd[k][2] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      rvb[k][1] += sb[i][1];
      rvbd[k][1] += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      rvb[k][0] += sb[i][0];
      rvbd[k][0] += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ACCELERATION) {
      tb7 = sb[i][2];
      tb7d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      rab[k][2] += tb7;
      rabd[k][2] += tb7d;
      pb[2] += tb7;
      pbd[2] += tb7d;
      tb6 = sb[i][1];
      tb6d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      rab[k][1] += tb6;
      rabd[k][1] += tb6d;
      pb[1] += tb6;
      pbd[1] += tb6d;
      tb5 = sb[i][0];
      tb5d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      rab[k][0] += tb5;
      rabd[k][0] += tb5d;
      pb[0] += tb5;
      pbd[0] += tb5d;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LATERAL_ACCELERATION) {
      g0 = ra[k][0] + p[0];
      g0d = rad[k][0] + pd[0];
      g1 = ra[k][1] + p[1];
      g1d = rad[k][1] + pd[1];
      g2_2 = ra[k][2] + p[2];
      g2_2d = rad[k][2] + pd[2];
      p_i = p[t->sensoradr[i]];
      p_id = pd[t->sensoradr[i]];
      w = p_i * p_i;
      wd = p_id * p_i + p_i * p_id;
      rv_k0 = rv[k][0];
      rv_k0d = rvd[k][0];
      rv_k1 = rv[k][1];
      rv_k1d = rvd[k][1];
      rv_k2 = rv[k][2];
      rv_k2d = rvd[k][2];
      t2 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + rv_k2 * rv_k2 + w;
      t2d = rv_k0d * rv_k0 + rv_k0 * rv_k0d + (rv_k1d * rv_k1 + rv_k1 * rv_k1d) + (rv_k2d * rv_k2 +
          rv_k2 * rv_k2d) + wd;
      c = (g0 * rv_k0 + g1 * rv_k1 + g2_2 * rv_k2) / t2;
      cd = (g0d * rv_k0 + g0 * rv_k0d + (g1d * rv_k1 + g1 * rv_k1d) + (g2_2d * rv_k2 + g2_2 *
          rv_k2d) - c * t2d) * (1.0 / t2);
      n30 = g0 - c * rv_k0;
      n30d = g0d - (cd * rv_k0 + c * rv_k0d);
      n31 = g1 - c * rv_k1;
      n31d = g1d - (cd * rv_k1 + c * rv_k1d);
      n32 = g2_2 - c * rv_k2;
      n32d = g2_2d - (cd * rv_k2 + c * rv_k2d);
      p_i1 = p[t->sensoradr[i] + 1];
      p_i1d = pd[t->sensoradr[i] + 1];
      t3 = n30 * n30 + n31 * n31 + n32 * n32 + p_i1 * p_i1;
      t3d = n30d * n30 + n30 * n30d + (n31d * n31 + n31 * n31d) + (n32d * n32 + n32 * n32d) + (p_i1d
          * p_i1 + p_i1 * p_i1d);
      t4 = sqrt(t3);
      t4d = 1.0 / (2.0 * t4) * t3d;
      t5 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + w;
      t5d = rv_k0d * rv_k0 + rv_k0 * rv_k0d + (rv_k1d * rv_k1 + rv_k1 * rv_k1d) + wd;
      t6 = sqrt(t5);
      t6d = 1.0 / (2.0 * t6) * t5d;
      t7 = g0 * g0 + g1 * g1 + p_i1 * p_i1;
      t7d = g0d * g0 + g0 * g0d + (g1d * g1 + g1 * g1d) + (p_i1d * p_i1 + p_i1 * p_i1d);
      t8 = sqrt(t7);
      t8d = 1.0 / (2.0 * t8) * t7d;
      tb13 = sb[i][2];
      tb13d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      tb14 = tb13 / t8;
      tb14d = (tb13d - tb14 * t8d) * (1.0 / t8);
      g0b = tb14 * g0;
      g0bd = tb14d * g0 + tb14 * g0d;
      g0b += tb14 * g0;
      g0bd += tb14d * g0 + tb14 * g0d;
      g1b = tb14 * g1;
      g1bd = tb14d * g1 + tb14 * g1d;
      g1b += tb14 * g1;
      g1bd += tb14d * g1 + tb14 * g1d;
      t8b = -(tb14 * s[i][2]);
      t8bd = -(tb14d * s[i][2] + tb14 * sd[i][2]);
      t7b = t8b * (1.0 / (2.0 * t8));
      t7bd = t8bd * (1.0 / (2.0 * t8)) - t8b * (1.0 / (2.0 * t8) * (2.0 * t8d) / (2.0 * t8));
      g0b += t7b * g0;
      g0bd += t7bd * g0 + t7b * g0d;
      g0b += t7b * g0;
      g0bd += t7bd * g0 + t7b * g0d;
      g1b += t7b * g1;
      g1bd += t7bd * g1 + t7b * g1d;
      g1b += t7b * g1;
      g1bd += t7bd * g1 + t7b * g1d;
      p_i1b = t7b * p_i1;
      p_i1bd = t7bd * p_i1 + t7b * p_i1d;
      p_i1b += t7b * p_i1;
      p_i1bd += t7bd * p_i1 + t7b * p_i1d;
      tb11 = sb[i][1];
      tb11d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb12 = tb11 / t6;
      tb12d = (tb11d - tb12 * t6d) * (1.0 / t6);
      rv_k0b = tb12 * g1;
      rv_k0bd = tb12d * g1 + tb12 * g1d;
      g1b += tb12 * rv_k0;
      g1bd += tb12d * rv_k0 + tb12 * rv_k0d;
      rv_k1b = -(tb12 * g0);
      rv_k1bd = -(tb12d * g0 + tb12 * g0d);
      g0b -= tb12 * rv_k1;
      g0bd -= tb12d * rv_k1 + tb12 * rv_k1d;
      t6b = -(tb12 * s[i][1]);
      t6bd = -(tb12d * s[i][1] + tb12 * sd[i][1]);
      t5b = t6b * (1.0 / (2.0 * t6));
      t5bd = t6bd * (1.0 / (2.0 * t6)) - t6b * (1.0 / (2.0 * t6) * (2.0 * t6d) / (2.0 * t6));
      rv_k0b += t5b * rv_k0;
      rv_k0bd += t5bd * rv_k0 + t5b * rv_k0d;
      rv_k0b += t5b * rv_k0;
      rv_k0bd += t5bd * rv_k0 + t5b * rv_k0d;
      rv_k1b += t5b * rv_k1;
      rv_k1bd += t5bd * rv_k1 + t5b * rv_k1d;
      rv_k1b += t5b * rv_k1;
      rv_k1bd += t5bd * rv_k1 + t5b * rv_k1d;
      wb = t5b;
      wbd = t5bd;
      tb9 = sb[i][0];
      tb9d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      tb10 = tb9 / t4;
      tb10d = (tb9d - tb10 * t4d) * (1.0 / t4);
      n30b = tb10 * n30;
      n30bd = tb10d * n30 + tb10 * n30d;
      n30b += tb10 * n30;
      n30bd += tb10d * n30 + tb10 * n30d;
      n31b = tb10 * n31;
      n31bd = tb10d * n31 + tb10 * n31d;
      n31b += tb10 * n31;
      n31bd += tb10d * n31 + tb10 * n31d;
      n32b = tb10 * n32;
      n32bd = tb10d * n32 + tb10 * n32d;
      n32b += tb10 * n32;
      n32bd += tb10d * n32 + tb10 * n32d;
      t4b = -(tb10 * s[i][0]);
      t4bd = -(tb10d * s[i][0] + tb10 * sd[i][0]);
      t3b = t4b * (1.0 / (2.0 * t4));
      t3bd = t4bd * (1.0 / (2.0 * t4)) - t4b * (1.0 / (2.0 * t4) * (2.0 * t4d) / (2.0 * t4));
      n30b += t3b * n30;
      n30bd += t3bd * n30 + t3b * n30d;
      n30b += t3b * n30;
      n30bd += t3bd * n30 + t3b * n30d;
      n31b += t3b * n31;
      n31bd += t3bd * n31 + t3b * n31d;
      n31b += t3b * n31;
      n31bd += t3bd * n31 + t3b * n31d;
      n32b += t3b * n32;
      n32bd += t3bd * n32 + t3b * n32d;
      n32b += t3b * n32;
      n32bd += t3bd * n32 + t3b * n32d;
      p_i1b += t3b * p_i1;
      p_i1bd += t3bd * p_i1 + t3b * p_i1d;
      p_i1b += t3b * p_i1;
      p_i1bd += t3bd * p_i1 + t3b * p_i1d;
      pb[t->sensoradr[i] + 1] += p_i1b;
      pbd[t->sensoradr[i] + 1] += p_i1bd;
      g2_2b = n32b;
      g2_2bd = n32bd;
      cb = -(n32b * rv_k2);
      cbd = -(n32bd * rv_k2 + n32b * rv_k2d);
      rv_k2b = -(n32b * c);
      rv_k2bd = -(n32bd * c + n32b * cd);
      g1b += n31b;
      g1bd += n31bd;
      cb -= n31b * rv_k1;
      cbd -= n31bd * rv_k1 + n31b * rv_k1d;
      rv_k1b -= n31b * c;
      rv_k1bd -= n31bd * c + n31b * cd;
      g0b += n30b;
      g0bd += n30bd;
      cb -= n30b * rv_k0;
      cbd -= n30bd * rv_k0 + n30b * rv_k0d;
      rv_k0b -= n30b * c;
      rv_k0bd -= n30bd * c + n30b * cd;
      tb8 = cb / t2;
      tb8d = (cbd - tb8 * t2d) * (1.0 / t2);
      g0b += tb8 * rv_k0;
      g0bd += tb8d * rv_k0 + tb8 * rv_k0d;
      rv_k0b += tb8 * g0;
      rv_k0bd += tb8d * g0 + tb8 * g0d;
      g1b += tb8 * rv_k1;
      g1bd += tb8d * rv_k1 + tb8 * rv_k1d;
      rv_k1b += tb8 * g1;
      rv_k1bd += tb8d * g1 + tb8 * g1d;
      g2_2b += tb8 * rv_k2;
      g2_2bd += tb8d * rv_k2 + tb8 * rv_k2d;
      rv_k2b += tb8 * g2_2;
      rv_k2bd += tb8d * g2_2 + tb8 * g2_2d;
      t2b = -(tb8 * c);
      t2bd = -(tb8d * c + tb8 * cd);
      rv_k0b += t2b * rv_k0;
      rv_k0bd += t2bd * rv_k0 + t2b * rv_k0d;
      rv_k0b += t2b * rv_k0;
      rv_k0bd += t2bd * rv_k0 + t2b * rv_k0d;
      rv_k1b += t2b * rv_k1;
      rv_k1bd += t2bd * rv_k1 + t2b * rv_k1d;
      rv_k1b += t2b * rv_k1;
      rv_k1bd += t2bd * rv_k1 + t2b * rv_k1d;
      rv_k2b += t2b * rv_k2;
      rv_k2bd += t2bd * rv_k2 + t2b * rv_k2d;
      rv_k2b += t2b * rv_k2;
      rv_k2bd += t2bd * rv_k2 + t2b * rv_k2d;
      wb += t2b;
      wbd += t2bd;
      rvb[k][2] += rv_k2b;
      rvbd[k][2] += rv_k2bd;
      rvb[k][1] += rv_k1b;
      rvbd[k][1] += rv_k1bd;
      rvb[k][0] += rv_k0b;
      rvbd[k][0] += rv_k0bd;
      p_ib = wb * p_i;
      p_ibd = wbd * p_i + wb * p_id;
      p_ib += wb * p_i;
      p_ibd += wbd * p_i + wb * p_id;
      pb[t->sensoradr[i]] += p_ib;
      pbd[t->sensoradr[i]] += p_ibd;
      rab[k][2] += g2_2b;
      rabd[k][2] += g2_2bd;
      pb[2] += g2_2b;
      pbd[2] += g2_2bd;
      rab[k][1] += g1b;
      rabd[k][1] += g1bd;
      pb[1] += g1b;
      pbd[1] += g1bd;
      rab[k][0] += g0b;
      rabd[k][0] += g0bd;
      pb[0] += g0b;
      pbd[0] += g0bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SIDESLIP) {
      g0_2 = ra[k][0] + p[0];
      g0_2d = rad[k][0] + pd[0];
      g1_2 = ra[k][1] + p[1];
      g1_2d = rad[k][1] + pd[1];
      A_j0 = A[j][0];
      A_j0d = Ad[j][0];
      A_j3 = A[j][3];
      A_j3d = Ad[j][3];
      t9 = A_j0 * A_j0 + A_j3 * A_j3;
      t9d = A_j0d * A_j0 + A_j0 * A_j0d + (A_j3d * A_j3 + A_j3 * A_j3d);
      h = sqrt(t9);
      hd = 1.0 / (2.0 * h) * t9d;
      rv_k0_2 = rv[k][0];
      rv_k0_2d = rvd[k][0];
      rv_k1_2 = rv[k][1];
      rv_k1_2d = rvd[k][1];
      u20 = (A_j0 * rv_k0_2 + A_j3 * rv_k1_2) / h;
      u20d = (A_j0d * rv_k0_2 + A_j0 * rv_k0_2d + (A_j3d * rv_k1_2 + A_j3 * rv_k1_2d) - u20 * hd) *
          (1.0 / h);
      u21 = (A_j0 * rv_k1_2 - A_j3 * rv_k0_2) / h;
      u21d = (A_j0d * rv_k1_2 + A_j0 * rv_k1_2d - (A_j3d * rv_k0_2 + A_j3 * rv_k0_2d) - u21 * hd) *
          (1.0 / h);
      p_i2 = p[t->sensoradr[i]];
      p_i2d = pd[t->sensoradr[i]];
      t10 = u20 * u20 + u21 * u21 + p_i2 * p_i2;
      t10d = u20d * u20 + u20 * u20d + (u21d * u21 + u21 * u21d) + (p_i2d * p_i2 + p_i2 * p_i2d);
      r2 = sqrt(t10);
      r2d = 1.0 / (2.0 * r2) * t10d;
      if (MAGGI_RE(u20) < 0.0) {
        t11 = r2 - u20;
        t11d = r2d - u20d;
        p_i3 = p[t->sensoradr[i]];
        p_i3d = pd[t->sensoradr[i]];
        t12 = (u21 * u21 + p_i3 * p_i3) / t11;
        t12d = (u21d * u21 + u21 * u21d + (p_i3d * p_i3 + p_i3 * p_i3d) - t12 * t11d) * (1.0 / t11);
        d = t12;
        dd = t12d;
      } else {
        d = r2 + u20;
        dd = r2d + u20d;
      }
      t14 = r2 * r2 * r2;
      t14d = (r2d * r2 + r2 * r2d) * r2 + r2 * r2 * r2d;
      tb21 = sb[i][2];
      tb21d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      tb22 = tb21 / t14;
      tb22d = (tb21d - tb22 * t14d) * (1.0 / t14);
      rvb[k][0] += tb22 * g1_2;
      rvbd[k][0] += tb22d * g1_2 + tb22 * g1_2d;
      g1_2b = tb22 * rv[k][0];
      g1_2bd = tb22d * rv[k][0] + tb22 * rvd[k][0];
      rvb[k][1] -= tb22 * g0_2;
      rvbd[k][1] -= tb22d * g0_2 + tb22 * g0_2d;
      g0_2b = -(tb22 * rv[k][1]);
      g0_2bd = -(tb22d * rv[k][1] + tb22 * rvd[k][1]);
      t14b = -(tb22 * s[i][2]);
      t14bd = -(tb22d * s[i][2] + tb22 * sd[i][2]);
      tb20 = t14b * r2;
      tb20d = t14bd * r2 + t14b * r2d;
      r2b = tb20 * r2;
      r2bd = tb20d * r2 + tb20 * r2d;
      r2b += tb20 * r2;
      r2bd += tb20d * r2 + tb20 * r2d;
      r2b += t14b * (r2 * r2);
      r2bd += t14bd * (r2 * r2) + t14b * (r2d * r2 + r2 * r2d);
      tb18 = sb[i][1];
      tb18d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb19 = tb18 / r2;
      tb19d = (tb18d - tb19 * r2d) * (1.0 / r2);
      u20b = tb19 * u20;
      u20bd = tb19d * u20 + tb19 * u20d;
      u20b += tb19 * u20;
      u20bd += tb19d * u20 + tb19 * u20d;
      u21b = tb19 * u21;
      u21bd = tb19d * u21 + tb19 * u21d;
      u21b += tb19 * u21;
      u21bd += tb19d * u21 + tb19 * u21d;
      r2b -= tb19 * s[i][1];
      r2bd -= tb19d * s[i][1] + tb19 * sd[i][1];
      t13b = sb[i][0] * 2.0;
      t13bd = sbd[i][0] * 2.0;
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      u21b += t13b * (d / (d * d + u21 * u21));
      u21bd += t13bd * (d / (d * d + u21 * u21)) + t13b * ((dd - d / (d * d + u21 * u21) * (dd * d +
          d * dd + (u21d * u21 + u21 * u21d))) / (d * d + u21 * u21));
      db = -(t13b * (u21 / (d * d + u21 * u21)));
      dbd = -(t13bd * (u21 / (d * d + u21 * u21)) + t13b * ((u21d - u21 / (d * d + u21 * u21) * (dd
          * d + d * dd + (u21d * u21 + u21 * u21d))) / (d * d + u21 * u21)));
      if (MAGGI_RE(u20) < 0.0) {
        t11 = r2 - u20;
        t11d = r2d - u20d;
        p_i3 = p[t->sensoradr[i]];
        p_i3d = pd[t->sensoradr[i]];
        t12 = (u21 * u21 + p_i3 * p_i3) / t11;
        t12d = (u21d * u21 + u21 * u21d + (p_i3d * p_i3 + p_i3 * p_i3d) - t12 * t11d) * (1.0 / t11);
        t12b = db;
        t12bd = dbd;
        db = 0.0;
        dbd = 0.0;
        tb17 = t12b / t11;
        tb17d = (t12bd - tb17 * t11d) * (1.0 / t11);
        u21b += tb17 * u21;
        u21bd += tb17d * u21 + tb17 * u21d;
        u21b += tb17 * u21;
        u21bd += tb17d * u21 + tb17 * u21d;
        p_i3b = tb17 * p_i3;
        p_i3bd = tb17d * p_i3 + tb17 * p_i3d;
        p_i3b += tb17 * p_i3;
        p_i3bd += tb17d * p_i3 + tb17 * p_i3d;
        t11b = -(tb17 * t12);
        t11bd = -(tb17d * t12 + tb17 * t12d);
        pb[t->sensoradr[i]] += p_i3b;
        pbd[t->sensoradr[i]] += p_i3bd;
        r2b += t11b;
        r2bd += t11bd;
        u20b -= t11b;
        u20bd -= t11bd;
      } else {
        r2b += db;
        r2bd += dbd;
        u20b += db;
        u20bd += dbd;
        db = 0.0;
        dbd = 0.0;
      }
      t10b = r2b * (1.0 / (2.0 * r2));
      t10bd = r2bd * (1.0 / (2.0 * r2)) - r2b * (1.0 / (2.0 * r2) * (2.0 * r2d) / (2.0 * r2));
      u20b += t10b * u20;
      u20bd += t10bd * u20 + t10b * u20d;
      u20b += t10b * u20;
      u20bd += t10bd * u20 + t10b * u20d;
      u21b += t10b * u21;
      u21bd += t10bd * u21 + t10b * u21d;
      u21b += t10b * u21;
      u21bd += t10bd * u21 + t10b * u21d;
      p_i2b = t10b * p_i2;
      p_i2bd = t10bd * p_i2 + t10b * p_i2d;
      p_i2b += t10b * p_i2;
      p_i2bd += t10bd * p_i2 + t10b * p_i2d;
      pb[t->sensoradr[i]] += p_i2b;
      pbd[t->sensoradr[i]] += p_i2bd;
      tb16 = u21b / h;
      tb16d = (u21bd - tb16 * hd) * (1.0 / h);
      A_j0b = tb16 * rv_k1_2;
      A_j0bd = tb16d * rv_k1_2 + tb16 * rv_k1_2d;
      rv_k1_2b = tb16 * A_j0;
      rv_k1_2bd = tb16d * A_j0 + tb16 * A_j0d;
      A_j3b = -(tb16 * rv_k0_2);
      A_j3bd = -(tb16d * rv_k0_2 + tb16 * rv_k0_2d);
      rv_k0_2b = -(tb16 * A_j3);
      rv_k0_2bd = -(tb16d * A_j3 + tb16 * A_j3d);
      hb = -(tb16 * u21);
      hbd = -(tb16d * u21 + tb16 * u21d);
      tb15 = u20b / h;
      tb15d = (u20bd - tb15 * hd) * (1.0 / h);
      A_j0b += tb15 * rv_k0_2;
      A_j0bd += tb15d * rv_k0_2 + tb15 * rv_k0_2d;
      rv_k0_2b += tb15 * A_j0;
      rv_k0_2bd += tb15d * A_j0 + tb15 * A_j0d;
      A_j3b += tb15 * rv_k1_2;
      A_j3bd += tb15d * rv_k1_2 + tb15 * rv_k1_2d;
      rv_k1_2b += tb15 * A_j3;
      rv_k1_2bd += tb15d * A_j3 + tb15 * A_j3d;
      hb -= tb15 * u20;
      hbd -= tb15d * u20 + tb15 * u20d;
      rvb[k][1] += rv_k1_2b;
      rvbd[k][1] += rv_k1_2bd;
      rvb[k][0] += rv_k0_2b;
      rvbd[k][0] += rv_k0_2bd;
      t9b = hb * (1.0 / (2.0 * h));
      t9bd = hbd * (1.0 / (2.0 * h)) - hb * (1.0 / (2.0 * h) * (2.0 * hd) / (2.0 * h));
      A_j0b += t9b * A_j0;
      A_j0bd += t9bd * A_j0 + t9b * A_j0d;
      A_j0b += t9b * A_j0;
      A_j0bd += t9bd * A_j0 + t9b * A_j0d;
      A_j3b += t9b * A_j3;
      A_j3bd += t9bd * A_j3 + t9b * A_j3d;
      A_j3b += t9b * A_j3;
      A_j3bd += t9bd * A_j3 + t9b * A_j3d;
      Ab[j][3] += A_j3b;
      Abd[j][3] += A_j3bd;
      Ab[j][0] += A_j0b;
      Abd[j][0] += A_j0bd;
      rab[k][1] += g1_2b;
      rabd[k][1] += g1_2bd;
      pb[1] += g1_2b;
      pbd[1] += g1_2bd;
      rab[k][0] += g0_2b;
      rabd[k][0] += g0_2bd;
      pb[0] += g0_2b;
      pbd[0] += g0_2bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_VELOCITY) {
      A_j0_2 = A[j][0];
      A_j0_2d = Ad[j][0];
      A_j3_2 = A[j][3];
      A_j3_2d = Ad[j][3];
      t15 = A_j0_2 * A_j0_2 + A_j3_2 * A_j3_2;
      t15d = A_j0_2d * A_j0_2 + A_j0_2 * A_j0_2d + (A_j3_2d * A_j3_2 + A_j3_2 * A_j3_2d);
      h2 = sqrt(t15);
      h2d = 1.0 / (2.0 * h2) * t15d;
      rv_k0_3 = rv[k][0];
      rv_k0_3d = rvd[k][0];
      rv_k1_3 = rv[k][1];
      rv_k1_3d = rvd[k][1];
      rvb[k][2] += sb[i][2];
      rvbd[k][2] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      tb25 = sb[i][1];
      tb25d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb26 = tb25 / h2;
      tb26d = (tb25d - tb26 * h2d) * (1.0 / h2);
      A_j0_2b = tb26 * rv_k1_3;
      A_j0_2bd = tb26d * rv_k1_3 + tb26 * rv_k1_3d;
      rv_k1_3b = tb26 * A_j0_2;
      rv_k1_3bd = tb26d * A_j0_2 + tb26 * A_j0_2d;
      A_j3_2b = -(tb26 * rv_k0_3);
      A_j3_2bd = -(tb26d * rv_k0_3 + tb26 * rv_k0_3d);
      rv_k0_3b = -(tb26 * A_j3_2);
      rv_k0_3bd = -(tb26d * A_j3_2 + tb26 * A_j3_2d);
      h2b = -(tb26 * s[i][1]);
      h2bd = -(tb26d * s[i][1] + tb26 * sd[i][1]);
      tb23 = sb[i][0];
      tb23d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      tb24 = tb23 / h2;
      tb24d = (tb23d - tb24 * h2d) * (1.0 / h2);
      A_j0_2b += tb24 * rv_k0_3;
      A_j0_2bd += tb24d * rv_k0_3 + tb24 * rv_k0_3d;
      rv_k0_3b += tb24 * A_j0_2;
      rv_k0_3bd += tb24d * A_j0_2 + tb24 * A_j0_2d;
      A_j3_2b += tb24 * rv_k1_3;
      A_j3_2bd += tb24d * rv_k1_3 + tb24 * rv_k1_3d;
      rv_k1_3b += tb24 * A_j3_2;
      rv_k1_3bd += tb24d * A_j3_2 + tb24 * A_j3_2d;
      h2b -= tb24 * s[i][0];
      h2bd -= tb24d * s[i][0] + tb24 * sd[i][0];
      rvb[k][1] += rv_k1_3b;
      rvbd[k][1] += rv_k1_3bd;
      rvb[k][0] += rv_k0_3b;
      rvbd[k][0] += rv_k0_3bd;
      t15b = h2b * (1.0 / (2.0 * h2));
      t15bd = h2bd * (1.0 / (2.0 * h2)) - h2b * (1.0 / (2.0 * h2) * (2.0 * h2d) / (2.0 * h2));
      A_j0_2b += t15b * A_j0_2;
      A_j0_2bd += t15bd * A_j0_2 + t15b * A_j0_2d;
      A_j0_2b += t15b * A_j0_2;
      A_j0_2bd += t15bd * A_j0_2 + t15b * A_j0_2d;
      A_j3_2b += t15b * A_j3_2;
      A_j3_2bd += t15bd * A_j3_2 + t15b * A_j3_2d;
      A_j3_2b += t15b * A_j3_2;
      A_j3_2bd += t15bd * A_j3_2 + t15b * A_j3_2d;
      Ab[j][3] += A_j3_2b;
      Abd[j][3] += A_j3_2bd;
      Ab[j][0] += A_j0_2b;
      Abd[j][0] += A_j0_2bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_ACCELERATION) {
      g0_3 = ra[k][0] + p[0];
      g0_3d = rad[k][0] + pd[0];
      g1_3 = ra[k][1] + p[1];
      g1_3d = rad[k][1] + pd[1];
      A_j0_3 = A[j][0];
      A_j0_3d = Ad[j][0];
      A_j3_3 = A[j][3];
      A_j3_3d = Ad[j][3];
      t16 = A_j0_3 * A_j0_3 + A_j3_3 * A_j3_3;
      t16d = A_j0_3d * A_j0_3 + A_j0_3 * A_j0_3d + (A_j3_3d * A_j3_3 + A_j3_3 * A_j3_3d);
      h3 = sqrt(t16);
      h3d = 1.0 / (2.0 * h3) * t16d;
      g2_4b = sb[i][2];
      g2_4bd = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      tb29 = sb[i][1];
      tb29d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb30 = tb29 / h3;
      tb30d = (tb29d - tb30 * h3d) * (1.0 / h3);
      A_j0_3b = tb30 * g1_3;
      A_j0_3bd = tb30d * g1_3 + tb30 * g1_3d;
      g1_3b = tb30 * A_j0_3;
      g1_3bd = tb30d * A_j0_3 + tb30 * A_j0_3d;
      A_j3_3b = -(tb30 * g0_3);
      A_j3_3bd = -(tb30d * g0_3 + tb30 * g0_3d);
      g0_3b = -(tb30 * A_j3_3);
      g0_3bd = -(tb30d * A_j3_3 + tb30 * A_j3_3d);
      h3b = -(tb30 * s[i][1]);
      h3bd = -(tb30d * s[i][1] + tb30 * sd[i][1]);
      tb27 = sb[i][0];
      tb27d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      tb28 = tb27 / h3;
      tb28d = (tb27d - tb28 * h3d) * (1.0 / h3);
      A_j0_3b += tb28 * g0_3;
      A_j0_3bd += tb28d * g0_3 + tb28 * g0_3d;
      g0_3b += tb28 * A_j0_3;
      g0_3bd += tb28d * A_j0_3 + tb28 * A_j0_3d;
      A_j3_3b += tb28 * g1_3;
      A_j3_3bd += tb28d * g1_3 + tb28 * g1_3d;
      g1_3b += tb28 * A_j3_3;
      g1_3bd += tb28d * A_j3_3 + tb28 * A_j3_3d;
      h3b -= tb28 * s[i][0];
      h3bd -= tb28d * s[i][0] + tb28 * sd[i][0];
      t16b = h3b * (1.0 / (2.0 * h3));
      t16bd = h3bd * (1.0 / (2.0 * h3)) - h3b * (1.0 / (2.0 * h3) * (2.0 * h3d) / (2.0 * h3));
      A_j0_3b += t16b * A_j0_3;
      A_j0_3bd += t16bd * A_j0_3 + t16b * A_j0_3d;
      A_j0_3b += t16b * A_j0_3;
      A_j0_3bd += t16bd * A_j0_3 + t16b * A_j0_3d;
      A_j3_3b += t16b * A_j3_3;
      A_j3_3bd += t16bd * A_j3_3 + t16b * A_j3_3d;
      A_j3_3b += t16b * A_j3_3;
      A_j3_3bd += t16bd * A_j3_3 + t16b * A_j3_3d;
      Ab[j][3] += A_j3_3b;
      Abd[j][3] += A_j3_3bd;
      Ab[j][0] += A_j0_3b;
      Abd[j][0] += A_j0_3bd;
      rab[k][2] += g2_4b;
      rabd[k][2] += g2_4bd;
      pb[2] += g2_4b;
      pbd[2] += g2_4bd;
      rab[k][1] += g1_3b;
      rabd[k][1] += g1_3bd;
      pb[1] += g1_3b;
      pbd[1] += g1_3bd;
      rab[k][0] += g0_3b;
      rabd[k][0] += g0_3bd;
      pb[0] += g0_3b;
      pbd[0] += g0_3bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_BODY_ACCELERATION) {
      g0_4 = ra[k][0] + p[0];
      g0_4d = rad[k][0] + pd[0];
      g1_4 = ra[k][1] + p[1];
      g1_4d = rad[k][1] + pd[1];
      g2_5 = ra[k][2] + p[2];
      g2_5d = rad[k][2] + pd[2];
      tb33 = sb[i][2];
      tb33d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Ab[j][2] += tb33 * g0_4;
      Abd[j][2] += tb33d * g0_4 + tb33 * g0_4d;
      g0_4b = tb33 * A[j][2];
      g0_4bd = tb33d * A[j][2] + tb33 * Ad[j][2];
      Ab[j][5] += tb33 * g1_4;
      Abd[j][5] += tb33d * g1_4 + tb33 * g1_4d;
      g1_4b = tb33 * A[j][5];
      g1_4bd = tb33d * A[j][5] + tb33 * Ad[j][5];
      Ab[j][8] += tb33 * g2_5;
      Abd[j][8] += tb33d * g2_5 + tb33 * g2_5d;
      g2_5b = tb33 * A[j][8];
      g2_5bd = tb33d * A[j][8] + tb33 * Ad[j][8];
      tb32 = sb[i][1];
      tb32d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      Ab[j][1] += tb32 * g0_4;
      Abd[j][1] += tb32d * g0_4 + tb32 * g0_4d;
      g0_4b += tb32 * A[j][1];
      g0_4bd += tb32d * A[j][1] + tb32 * Ad[j][1];
      Ab[j][4] += tb32 * g1_4;
      Abd[j][4] += tb32d * g1_4 + tb32 * g1_4d;
      g1_4b += tb32 * A[j][4];
      g1_4bd += tb32d * A[j][4] + tb32 * Ad[j][4];
      Ab[j][7] += tb32 * g2_5;
      Abd[j][7] += tb32d * g2_5 + tb32 * g2_5d;
      g2_5b += tb32 * A[j][7];
      g2_5bd += tb32d * A[j][7] + tb32 * Ad[j][7];
      tb31 = sb[i][0];
      tb31d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      Ab[j][0] += tb31 * g0_4;
      Abd[j][0] += tb31d * g0_4 + tb31 * g0_4d;
      g0_4b += tb31 * A[j][0];
      g0_4bd += tb31d * A[j][0] + tb31 * Ad[j][0];
      Ab[j][3] += tb31 * g1_4;
      Abd[j][3] += tb31d * g1_4 + tb31 * g1_4d;
      g1_4b += tb31 * A[j][3];
      g1_4bd += tb31d * A[j][3] + tb31 * Ad[j][3];
      Ab[j][6] += tb31 * g2_5;
      Abd[j][6] += tb31d * g2_5 + tb31 * g2_5d;
      g2_5b += tb31 * A[j][6];
      g2_5bd += tb31d * A[j][6] + tb31 * Ad[j][6];
      rab[k][2] += g2_5b;
      rabd[k][2] += g2_5bd;
      pb[2] += g2_5b;
      pbd[2] += g2_5bd;
      rab[k][1] += g1_4b;
      rabd[k][1] += g1_4bd;
      pb[1] += g1_4b;
      pbd[1] += g1_4bd;
      rab[k][0] += g0_4b;
      rabd[k][0] += g0_4bd;
      pb[0] += g0_4b;
      pbd[0] += g0_4bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_COMBINATION) {
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      sumb = sb[i][0];
      sumbd = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      for (a = t->sensorterms[i] - 1; a >= 0; --a) {
        pb[t->sensoradr[i] + a] += sumb * s[t->termsensor[n2 + a]][t->termcolumn[n2 + a]];
        pbd[t->sensoradr[i] + a] += sumbd * s[t->termsensor[n2 + a]][t->termcolumn[n2 + a]] + sumb *
            sd[t->termsensor[n2 + a]][t->termcolumn[n2 + a]];
        sb[t->termsensor[n2 + a]][t->termcolumn[n2 + a]] += sumb * p[t->sensoradr[i] + a];
        sbd[t->termsensor[n2 + a]][t->termcolumn[n2 + a]] += sumbd * p[t->sensoradr[i] + a] + sumb *
            pd[t->sensoradr[i] + a];
      }
      sumb = 0.0;
      sumbd = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j7d = Ad[j][7];
      A_j8 = A[j][8];
      A_j8d = Ad[j][8];
      t17 = -A[j][6];
      t17d = -Ad[j][6];
      t18 = A_j7 * A_j7 + A_j8 * A_j8;
      t18d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
      t19 = sqrt(t18);
      t19d = 1.0 / (2.0 * t19) * t18d;
      tb36 = sb[i][2];
      tb36d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Ab[j][3] += tb36 * (A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      Abd[j][3] += tb36d * (A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3])) + tb36 * ((Ad[j][0] -
          A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]) * (Ad[j][0] * A[j][0] + A[j][0] *
          Ad[j][0] + (Ad[j][3] * A[j][3] + A[j][3] * Ad[j][3]))) / (A[j][0] * A[j][0] + A[j][3] *
          A[j][3]));
      Ab[j][0] -= tb36 * (A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      Abd[j][0] -= tb36d * (A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3])) + tb36 * ((Ad[j][3] -
          A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]) * (Ad[j][0] * A[j][0] + A[j][0] *
          Ad[j][0] + (Ad[j][3] * A[j][3] + A[j][3] * Ad[j][3]))) / (A[j][0] * A[j][0] + A[j][3] *
          A[j][3]));
      tb35 = sb[i][1];
      tb35d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      t17b = tb35 * (t19 / (t19 * t19 + t17 * t17));
      t17bd = tb35d * (t19 / (t19 * t19 + t17 * t17)) + tb35 * ((t19d - t19 / (t19 * t19 + t17 *
          t17) * (t19d * t19 + t19 * t19d + (t17d * t17 + t17 * t17d))) / (t19 * t19 + t17 * t17));
      t19b = -(tb35 * (t17 / (t19 * t19 + t17 * t17)));
      t19bd = -(tb35d * (t17 / (t19 * t19 + t17 * t17)) + tb35 * ((t17d - t17 / (t19 * t19 + t17 *
          t17) * (t19d * t19 + t19 * t19d + (t17d * t17 + t17 * t17d))) / (t19 * t19 + t17 * t17)));
      t18b = t19b * (1.0 / (2.0 * t19));
      t18bd = t19bd * (1.0 / (2.0 * t19)) - t19b * (1.0 / (2.0 * t19) * (2.0 * t19d) / (2.0 * t19));
      A_j7b = t18b * A_j7;
      A_j7bd = t18bd * A_j7 + t18b * A_j7d;
      A_j7b += t18b * A_j7;
      A_j7bd += t18bd * A_j7 + t18b * A_j7d;
      A_j8b = t18b * A_j8;
      A_j8bd = t18bd * A_j8 + t18b * A_j8d;
      A_j8b += t18b * A_j8;
      A_j8bd += t18bd * A_j8 + t18b * A_j8d;
      Ab[j][6] -= t17b;
      Abd[j][6] -= t17bd;
      tb34 = sb[i][0];
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      tb34d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      A_j7b += tb34 * (A_j8 / (A_j8 * A_j8 + A_j7 * A_j7));
      A_j7bd += tb34d * (A_j8 / (A_j8 * A_j8 + A_j7 * A_j7)) + tb34 * ((A_j8d - A_j8 / (A_j8 * A_j8
          + A_j7 * A_j7) * (A_j8d * A_j8 + A_j8 * A_j8d + (A_j7d * A_j7 + A_j7 * A_j7d))) / (A_j8 *
          A_j8 + A_j7 * A_j7));
      A_j8b -= tb34 * (A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      A_j8bd -= tb34d * (A_j7 / (A_j8 * A_j8 + A_j7 * A_j7)) + tb34 * ((A_j7d - A_j7 / (A_j8 * A_j8
          + A_j7 * A_j7) * (A_j8d * A_j8 + A_j8 * A_j8d + (A_j7d * A_j7 + A_j7 * A_j7d))) / (A_j8 *
          A_j8 + A_j7 * A_j7));
      Ab[j][8] += A_j8b;
      Abd[j][8] += A_j8bd;
      Ab[j][7] += A_j7b;
      Abd[j][7] += A_j7bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      A_j0_4 = A[j][0];
      A_j0_4d = Ad[j][0];
      A_j3_4 = A[j][3];
      A_j3_4d = Ad[j][3];
      c2 = A_j0_4 * A_j0_4 + A_j3_4 * A_j3_4;
      c2d = A_j0_4d * A_j0_4 + A_j0_4 * A_j0_4d + (A_j3_4d * A_j3_4 + A_j3_4 * A_j3_4d);
      Z_j3 = Z[j][3];
      Z_j3d = Zd[j][3];
      Z_j4 = Z[j][4];
      Z_j4d = Zd[j][4];
      roll = s[i][0];
      rolld = sd[i][0];
      t20 = sqrt(c2);
      t20d = 1.0 / (2.0 * t20) * c2d;
      tb40 = sb[i][2];
      tb40d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Zb[j][5] += tb40;
      Zbd[j][5] += tb40d;
      Ab[j][6] -= tb40 * roll;
      Abd[j][6] -= tb40d * roll + tb40 * rolld;
      rollb = -(tb40 * A[j][6]);
      rollbd = -(tb40d * A[j][6] + tb40 * Ad[j][6]);
      tb38 = sb[i][1];
      tb38d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb39 = tb38 / t20;
      tb39d = (tb38d - tb39 * t20d) * (1.0 / t20);
      A_j0_4b = tb39 * Z_j4;
      A_j0_4bd = tb39d * Z_j4 + tb39 * Z_j4d;
      Z_j4b = tb39 * A_j0_4;
      Z_j4bd = tb39d * A_j0_4 + tb39 * A_j0_4d;
      A_j3_4b = -(tb39 * Z_j3);
      A_j3_4bd = -(tb39d * Z_j3 + tb39 * Z_j3d);
      Z_j3b = -(tb39 * A_j3_4);
      Z_j3bd = -(tb39d * A_j3_4 + tb39 * A_j3_4d);
      t20b = -(tb39 * s[i][1]);
      t20bd = -(tb39d * s[i][1] + tb39 * sd[i][1]);
      c2b = t20b * (1.0 / (2.0 * t20));
      c2bd = t20bd * (1.0 / (2.0 * t20)) - t20b * (1.0 / (2.0 * t20) * (2.0 * t20d) / (2.0 * t20));
      rollb += sb[i][0];
      rollbd += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      tb37 = rollb / c2;
      tb37d = (rollbd - tb37 * c2d) * (1.0 / c2);
      A_j0_4b += tb37 * Z_j3;
      A_j0_4bd += tb37d * Z_j3 + tb37 * Z_j3d;
      Z_j3b += tb37 * A_j0_4;
      Z_j3bd += tb37d * A_j0_4 + tb37 * A_j0_4d;
      A_j3_4b += tb37 * Z_j4;
      A_j3_4bd += tb37d * Z_j4 + tb37 * Z_j4d;
      Z_j4b += tb37 * A_j3_4;
      Z_j4bd += tb37d * A_j3_4 + tb37 * A_j3_4d;
      c2b -= tb37 * roll;
      c2bd -= tb37d * roll + tb37 * rolld;
      Zb[j][4] += Z_j4b;
      Zbd[j][4] += Z_j4bd;
      Zb[j][3] += Z_j3b;
      Zbd[j][3] += Z_j3bd;
      A_j0_4b += c2b * A_j0_4;
      /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
       * A_6 = -sin(pitch) */
      A_j0_4bd += c2bd * A_j0_4 + c2b * A_j0_4d;
      A_j0_4b += c2b * A_j0_4;
      A_j0_4bd += c2bd * A_j0_4 + c2b * A_j0_4d;
      A_j3_4b += c2b * A_j3_4;
      A_j3_4bd += c2bd * A_j3_4 + c2b * A_j3_4d;
      A_j3_4b += c2b * A_j3_4;
      A_j3_4bd += c2bd * A_j3_4 + c2b * A_j3_4d;
      Ab[j][3] += A_j3_4b;
      Abd[j][3] += A_j3_4bd;
      Ab[j][0] += A_j0_4b;
      Abd[j][0] += A_j0_4bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_VELOCITY) {
      Zb[j][5] += sb[i][2];
      Zbd[j][5] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Zb[j][4] += sb[i][1];
      Zbd[j][4] += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      Zb[j][3] += sb[i][0];
      Zbd[j][3] += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_ACCELERATION) {
      Zab[j][5] += sb[i][2];
      Zabd[j][5] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Zab[j][4] += sb[i][1];
      Zabd[j][4] += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      Zab[j][3] += sb[i][0];
      Zabd[j][3] += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SPRING) {
      a3 = t->springpa[n2];
      b = t->springpb[n2];
      e0 = r[a3][0] - r[b][0];
      e0d = rd[a3][0] - rd[b][0];
      ev0 = rv[a3][0] - rv[b][0];
      ev0d = rvd[a3][0] - rvd[b][0];
      e1 = r[a3][1] - r[b][1];
      e1d = rd[a3][1] - rd[b][1];
      ev1 = rv[a3][1] - rv[b][1];
      ev1d = rvd[a3][1] - rvd[b][1];
      e2_2 = r[a3][2] - r[b][2];
      e2_2d = rd[a3][2] - rd[b][2];
      ev2_2 = rv[a3][2] - rv[b][2];
      ev2_2d = rvd[a3][2] - rvd[b][2];
      t21 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
      t21d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
      l = sqrt(t21);
      ld = 1.0 / (2.0 * l) * t21d;
      n40 = e0 / l;
      n40d = (e0d - n40 * ld) * (1.0 / l);
      n41 = e1 / l;
      n41d = (e1d - n41 * ld) * (1.0 / l);
      n42 = e2_2 / l;
      n42d = (e2_2d - n42 * ld) * (1.0 / l);
      lv = n40 * ev0 + n41 * ev1 + n42 * ev2_2;
      lvd = n40d * ev0 + n40 * ev0d + (n41d * ev1 + n41 * ev1d) + (n42d * ev2_2 + n42 * ev2_2d);
      k3 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
      tb48 = sb[i][2];
      tb48d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      f0b = tb48;
      f0bd = tb48d;
      f1b = tb48;
      f1bd = tb48d;
      z1b = sb[i][1];
      z1bd = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      z0_3b = sb[i][0];
      z0_3bd = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      lvb = z1b;
      lvbd = z1bd;
      lb = z0_3b;
      lbd = z0_3bd;
      dampingb = 0.0;
      dampingbd = 0.0;
      if (t->springslopes[n2]) {
        dampingb += f1b;
        dampingbd += f1bd;
        f2b = f1b;
        f2bd = f1bd;
        f1b = 0.0;
        f1bd = 0.0;
        /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
        if (MAGGI_RE(lv) > MAGGI_RE(p[k3 + 4])) {
          p_k34 = p[k3 + 4];
          p_k34d = pd[k3 + 4];
          pb[k3] += f2b * p_k34;
          pbd[k3] += f2bd * p_k34 + f2b * p_k34d;
          p_k34b = f2b * p[k3];
          p_k34bd = f2bd * p[k3] + f2b * pd[k3];
          pb[k3 + 1] += f2b * (lv - p_k34);
          pbd[k3 + 1] += f2bd * (lv - p_k34) + f2b * (lvd - p_k34d);
          tb46 = f2b * p[k3 + 1];
          tb46d = f2bd * p[k3 + 1] + f2b * pd[k3 + 1];
          lvb += tb46;
          lvbd += tb46d;
          p_k34b -= tb46;
          p_k34bd -= tb46d;
          f2b = 0.0;
          f2bd = 0.0;
          pb[k3 + 4] += p_k34b;
          pbd[k3 + 4] += p_k34bd;
        } else if (MAGGI_RE(lv) > 0.0) {
          pb[k3] += f2b * lv;
          pbd[k3] += f2bd * lv + f2b * lvd;
          lvb += f2b * p[k3];
          lvbd += f2bd * p[k3] + f2b * pd[k3];
          f2b = 0.0;
          f2bd = 0.0;
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k3 + 5])) {
          pb[k3 + 2] += f2b * lv;
          pbd[k3 + 2] += f2bd * lv + f2b * lvd;
          lvb += f2b * p[k3 + 2];
          lvbd += f2bd * p[k3 + 2] + f2b * pd[k3 + 2];
          f2b = 0.0;
          f2bd = 0.0;
        } else {
          p_k35 = p[k3 + 5];
          p_k35d = pd[k3 + 5];
          pb[k3 + 2] += f2b * p_k35;
          pbd[k3 + 2] += f2bd * p_k35 + f2b * p_k35d;
          p_k35b = f2b * p[k3 + 2];
          p_k35bd = f2bd * p[k3 + 2] + f2b * pd[k3 + 2];
          pb[k3 + 3] += f2b * (lv - p_k35);
          pbd[k3 + 3] += f2bd * (lv - p_k35) + f2b * (lvd - p_k35d);
          tb47 = f2b * p[k3 + 3];
          tb47d = f2bd * p[k3 + 3] + f2b * pd[k3 + 3];
          lvb += tb47;
          lvbd += tb47d;
          p_k35b -= tb47;
          p_k35bd -= tb47d;
          f2b = 0.0;
          f2bd = 0.0;
          pb[k3 + 5] += p_k35b;
          pbd[k3 + 5] += p_k35bd;
        }
      } else {
        dampingb += f1b;
        dampingbd += f1bd;
        f1b = 0.0;
        f1bd = 0.0;
      }
      if (t->springpreload[n2]) {
        pb[t->springadr[n2]] += f0b * (l - spring0[n2]);
        pbd[t->springadr[n2]] += f0bd * (l - spring0[n2]) + f0b * (ld - spring0d[n2]);
        tb44 = f0b * p[t->springadr[n2]];
        tb44d = f0bd * p[t->springadr[n2]] + f0b * pd[t->springadr[n2]];
        lb += tb44;
        lbd += tb44d;
        spring0b[n2] -= tb44;
        spring0bd[n2] -= tb44d;
        pb[t->springadr[n2] + MAGGI_SPRING_L] += f0b;
        pbd[t->springadr[n2] + MAGGI_SPRING_L] += f0bd;
        f0b = 0.0;
        f0bd = 0.0;
      } else {
        pb[t->springadr[n2]] += f0b * (l - p[t->springadr[n2] + MAGGI_SPRING_L]);
        pbd[t->springadr[n2]] += f0bd * (l - p[t->springadr[n2] + MAGGI_SPRING_L]) + f0b * (ld -
            pd[t->springadr[n2] + MAGGI_SPRING_L]);
        tb45 = f0b * p[t->springadr[n2]];
        tb45d = f0bd * p[t->springadr[n2]] + f0b * pd[t->springadr[n2]];
        lb += tb45;
        lbd += tb45d;
        pb[t->springadr[n2] + MAGGI_SPRING_L] -= tb45;
        pbd[t->springadr[n2] + MAGGI_SPRING_L] -= tb45d;
        f0b = 0.0;
        f0bd = 0.0;
      }
      pb[t->springadr[n2] + MAGGI_SPRING_C] += dampingb * lv;
      pbd[t->springadr[n2] + MAGGI_SPRING_C] += dampingbd * lv + dampingb * lvd;
      lvb += dampingb * p[t->springadr[n2] + MAGGI_SPRING_C];
      lvbd += dampingbd * p[t->springadr[n2] + MAGGI_SPRING_C] + dampingb * pd[t->springadr[n2] +
          MAGGI_SPRING_C];
      n40b = lvb * ev0;
      n40bd = lvbd * ev0 + lvb * ev0d;
      ev0b = lvb * n40;
      ev0bd = lvbd * n40 + lvb * n40d;
      n41b = lvb * ev1;
      n41bd = lvbd * ev1 + lvb * ev1d;
      ev1b = lvb * n41;
      ev1bd = lvbd * n41 + lvb * n41d;
      n42b = lvb * ev2_2;
      n42bd = lvbd * ev2_2 + lvb * ev2_2d;
      ev2_2b = lvb * n42;
      ev2_2bd = lvbd * n42 + lvb * n42d;
      tb43 = n42b / l;
      tb43d = (n42bd - tb43 * ld) * (1.0 / l);
      e2_2b = tb43;
      e2_2bd = tb43d;
      lb -= tb43 * n42;
      lbd -= tb43d * n42 + tb43 * n42d;
      tb42 = n41b / l;
      tb42d = (n41bd - tb42 * ld) * (1.0 / l);
      e1b = tb42;
      e1bd = tb42d;
      lb -= tb42 * n41;
      lbd -= tb42d * n41 + tb42 * n41d;
      tb41 = n40b / l;
      tb41d = (n40bd - tb41 * ld) * (1.0 / l);
      e0b = tb41;
      e0bd = tb41d;
      lb -= tb41 * n40;
      lbd -= tb41d * n40 + tb41 * n40d;
      t21b = lb * (1.0 / (2.0 * l));
      t21bd = lbd * (1.0 / (2.0 * l)) - lb * (1.0 / (2.0 * l) * (2.0 * ld) / (2.0 * l));
      e0b += t21b * e0;
      e0bd += t21bd * e0 + t21b * e0d;
      e0b += t21b * e0;
      e0bd += t21bd * e0 + t21b * e0d;
      e1b += t21b * e1;
      e1bd += t21bd * e1 + t21b * e1d;
      e1b += t21b * e1;
      e1bd += t21bd * e1 + t21b * e1d;
      e2_2b += t21b * e2_2;
      e2_2bd += t21bd * e2_2 + t21b * e2_2d;
      e2_2b += t21b * e2_2;
      e2_2bd += t21bd * e2_2 + t21b * e2_2d;
      rvb[a3][2] += ev2_2b;
      rvbd[a3][2] += ev2_2bd;
      rvb[b][2] -= ev2_2b;
      rvbd[b][2] -= ev2_2bd;
      rb[a3][2] += e2_2b;
      rbd[a3][2] += e2_2bd;
      rb[b][2] -= e2_2b;
      rbd[b][2] -= e2_2bd;
      rvb[a3][1] += ev1b;
      rvbd[a3][1] += ev1bd;
      rvb[b][1] -= ev1b;
      rvbd[b][1] -= ev1bd;
      rb[a3][1] += e1b;
      rbd[a3][1] += e1bd;
      rb[b][1] -= e1b;
      rbd[b][1] -= e1bd;
      rvb[a3][0] += ev0b;
      rvbd[a3][0] += ev0bd;
      rvb[b][0] -= ev0b;
      rvbd[b][0] -= ev0bd;
      rb[a3][0] += e0b;
      rbd[a3][0] += e0bd;
      rb[b][0] -= e0b;
      rbd[b][0] -= e0bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_JOINT_SPRING) {
      if (t->jspringq2[n2] >= 0) {
        x2 = q[t->jspringq[n2]] - q[t->jspringq2[n2]];
        x2d = qd[t->jspringq[n2]] - qd[t->jspringq2[n2]];
        xv = v[t->jspringq[n2]] - v[t->jspringq2[n2]];
        xvd = vd[t->jspringq[n2]] - vd[t->jspringq2[n2]];
      } else {
        x2 = q[t->jspringq[n2]];
        x2d = qd[t->jspringq[n2]];
        xv = v[t->jspringq[n2]];
        xvd = vd[t->jspringq[n2]];
      }
      torque0b = sb[i][2];
      torque0bd = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      z1_2b = sb[i][1];
      z1_2bd = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      z0_4b = sb[i][0];
      z0_4bd = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      xvb = z1_2b;
      xvbd = z1_2bd;
      x2b = z0_4b;
      x2bd = z0_4bd;
      pb[t->jspringadr[n2]] -= torque0b * (x2 - p[t->jspringadr[n2] + MAGGI_JSPRING_REST]);
      pbd[t->jspringadr[n2]] -= torque0bd * (x2 - p[t->jspringadr[n2] + MAGGI_JSPRING_REST]) +
          torque0b * (x2d - pd[t->jspringadr[n2] + MAGGI_JSPRING_REST]);
      tb49 = torque0b * p[t->jspringadr[n2]];
      tb49d = torque0bd * p[t->jspringadr[n2]] + torque0b * pd[t->jspringadr[n2]];
      x2b -= tb49;
      x2bd -= tb49d;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_REST] += tb49;
      pbd[t->jspringadr[n2] + MAGGI_JSPRING_REST] += tb49d;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_C] -= torque0b * xv;
      pbd[t->jspringadr[n2] + MAGGI_JSPRING_C] -= torque0bd * xv + torque0b * xvd;
      xvb -= torque0b * p[t->jspringadr[n2] + MAGGI_JSPRING_C];
      xvbd -= torque0bd * p[t->jspringadr[n2] + MAGGI_JSPRING_C] + torque0b * pd[t->jspringadr[n2] +
          MAGGI_JSPRING_C];
      pb[t->jspringadr[n2] + MAGGI_JSPRING_PRELOAD] -= torque0b;
      pbd[t->jspringadr[n2] + MAGGI_JSPRING_PRELOAD] -= torque0bd;
      if (t->jspringq2[n2] >= 0) {
        vb[t->jspringq[n2]] += xvb;
        vbd[t->jspringq[n2]] += xvbd;
        vb[t->jspringq2[n2]] -= xvb;
        vbd[t->jspringq2[n2]] -= xvbd;
        xvb = 0.0;
        xvbd = 0.0;
        qb[t->jspringq[n2]] += x2b;
        qbd[t->jspringq[n2]] += x2bd;
        qb[t->jspringq2[n2]] -= x2b;
        qbd[t->jspringq2[n2]] -= x2bd;
        x2b = 0.0;
        x2bd = 0.0;
      } else {
        vb[t->jspringq[n2]] += xvb;
        vbd[t->jspringq[n2]] += xvbd;
        xvb = 0.0;
        xvbd = 0.0;
        qb[t->jspringq[n2]] += x2b;
        qbd[t->jspringq[n2]] += x2bd;
        x2b = 0.0;
        x2bd = 0.0;
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ROD) {
      a3_2 = t->primpa[n2];
      b7 = t->primpb[n2];
      e20 = r[a3_2][0] - r[b7][0];
      e20d = rd[a3_2][0] - rd[b7][0];
      ev20 = rv[a3_2][0] - rv[b7][0];
      ev20d = rvd[a3_2][0] - rvd[b7][0];
      e21 = r[a3_2][1] - r[b7][1];
      e21d = rd[a3_2][1] - rd[b7][1];
      ev21 = rv[a3_2][1] - rv[b7][1];
      ev21d = rvd[a3_2][1] - rvd[b7][1];
      e22 = r[a3_2][2] - r[b7][2];
      e22d = rd[a3_2][2] - rd[b7][2];
      ev22 = rv[a3_2][2] - rv[b7][2];
      ev22d = rvd[a3_2][2] - rvd[b7][2];
      t22 = e20 * e20 + e21 * e21 + e22 * e22;
      t22d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 * e22d);
      l2 = sqrt(t22);
      l2d = 1.0 / (2.0 * l2) * t22d;
      z1_3 = s[i][1];
      z1_3d = sd[i][1];
      lambdab[t->primrow[n2]] += sb[i][2];
      lambdabd[t->primrow[n2]] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      z1_3b = sb[i][1];
      z1_3bd = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      z0_5b = sb[i][0];
      z0_5bd = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      tb50 = z1_3b / l2;
      tb50d = (z1_3bd - tb50 * l2d) * (1.0 / l2);
      e20b = tb50 * ev20;
      e20bd = tb50d * ev20 + tb50 * ev20d;
      ev20b = tb50 * e20;
      ev20bd = tb50d * e20 + tb50 * e20d;
      e21b = tb50 * ev21;
      e21bd = tb50d * ev21 + tb50 * ev21d;
      ev21b = tb50 * e21;
      ev21bd = tb50d * e21 + tb50 * e21d;
      e22b = tb50 * ev22;
      e22bd = tb50d * ev22 + tb50 * ev22d;
      ev22b = tb50 * e22;
      ev22bd = tb50d * e22 + tb50 * e22d;
      l2b = -(tb50 * z1_3);
      l2bd = -(tb50d * z1_3 + tb50 * z1_3d);
      l2b += z0_5b;
      l2bd += z0_5bd;
      t22b = l2b * (1.0 / (2.0 * l2));
      t22bd = l2bd * (1.0 / (2.0 * l2)) - l2b * (1.0 / (2.0 * l2) * (2.0 * l2d) / (2.0 * l2));
      e20b += t22b * e20;
      e20bd += t22bd * e20 + t22b * e20d;
      e20b += t22b * e20;
      e20bd += t22bd * e20 + t22b * e20d;
      e21b += t22b * e21;
      e21bd += t22bd * e21 + t22b * e21d;
      e21b += t22b * e21;
      e21bd += t22bd * e21 + t22b * e21d;
      e22b += t22b * e22;
      e22bd += t22bd * e22 + t22b * e22d;
      e22b += t22b * e22;
      e22bd += t22bd * e22 + t22b * e22d;
      rvb[a3_2][2] += ev22b;
      rvbd[a3_2][2] += ev22bd;
      rvb[b7][2] -= ev22b;
      rvbd[b7][2] -= ev22bd;
      rb[a3_2][2] += e22b;
      rbd[a3_2][2] += e22bd;
      rb[b7][2] -= e22b;
      rbd[b7][2] -= e22bd;
      rvb[a3_2][1] += ev21b;
      rvbd[a3_2][1] += ev21bd;
      rvb[b7][1] -= ev21b;
      rvbd[b7][1] -= ev21bd;
      rb[a3_2][1] += e21b;
      rbd[a3_2][1] += e21bd;
      rb[b7][1] -= e21b;
      rbd[b7][1] -= e21bd;
      rvb[a3_2][0] += ev20b;
      rvbd[a3_2][0] += ev20bd;
      rvb[b7][0] -= ev20b;
      rvbd[b7][0] -= ev20bd;
      rb[a3_2][0] += e20b;
      /* distance of two points and its rate */
      rbd[a3_2][0] += e20bd;
      rb[b7][0] -= e20b;
      rbd[b7][0] -= e20bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_SLIP) {
      slipb[n2][MAGGI_SLIP_GAMMA] += sb[i][2];
      slipbd[n2][MAGGI_SLIP_GAMMA] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      tb51 = sb[i][1];
      tb51d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      slipb[n2][MAGGI_SLIP_TAN_ALPHA] += tb51 * (1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] *
          slip[n2][MAGGI_SLIP_TAN_ALPHA]));
      slipbd[n2][MAGGI_SLIP_TAN_ALPHA] += tb51d * (1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] *
          slip[n2][MAGGI_SLIP_TAN_ALPHA])) - tb51 * (1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] *
          slip[n2][MAGGI_SLIP_TAN_ALPHA]) * (slipd[n2][MAGGI_SLIP_TAN_ALPHA] *
          slip[n2][MAGGI_SLIP_TAN_ALPHA] + slip[n2][MAGGI_SLIP_TAN_ALPHA] *
          slipd[n2][MAGGI_SLIP_TAN_ALPHA]) / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] *
          slip[n2][MAGGI_SLIP_TAN_ALPHA]));
      slipb[n2][MAGGI_SLIP_KAPPA] += sb[i][0];
      slipbd[n2][MAGGI_SLIP_KAPPA] += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_FORCE) {
      gripb[n2][2] += sb[i][2];
      gripbd[n2][2] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      gripb[n2][1] += sb[i][1];
      gripbd[n2][1] += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      gripb[n2][0] += sb[i][0];
      gripbd[n2][0] += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_MOMENT) {
      gripb[n2][5] += sb[i][2];
      gripbd[n2][5] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      gripb[n2][4] += sb[i][1];
      gripbd[n2][4] += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      gripb[n2][3] += sb[i][0];
      gripbd[n2][3] += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_CONTACT) {
      slipb[n2][MAGGI_SLIP_ROLLING] += sb[i][2];
      slipbd[n2][MAGGI_SLIP_ROLLING] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      slip_n2b = sb[i][1];
      slip_n2bd = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb52 = sb[i][0];
      tb52d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb52;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb52d;
      slip_n2b -= tb52;
      slip_n2bd -= tb52d;
      slipb[n2][MAGGI_SLIP_RADIUS] += slip_n2b;
      slipbd[n2][MAGGI_SLIP_RADIUS] += slip_n2bd;
    } else {
      side = t->wheelmirror[n2] ? -1.0 : 1.0;
      /* slopes of the formula, which a tyre of the other side has as well; 0 in the air */
      if (MAGGI_RE(grip[n2][2]) > 0.0) {
        one0 = slip[n2][MAGGI_SLIP_KAPPA];
        one0d = slipd[n2][MAGGI_SLIP_KAPPA];
        one1 = side * slip[n2][MAGGI_SLIP_TAN_ALPHA];
        one1d = side * slipd[n2][MAGGI_SLIP_TAN_ALPHA];
        one2 = side * slip[n2][MAGGI_SLIP_GAMMA];
        one2d = side * slipd[n2][MAGGI_SLIP_GAMMA];
        one3 = grip[n2][2];
        one3d = gripd[n2][2];
        kappa = one0;
        kappad = one0d;
        a2 = one1;
        a2d = one1d;
        gamma = one2;
        gammad = one2d;
        fz = one3;
        fzd = one3d;
        fz0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]];
        fz0d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]]
            + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[n2]]];
        dfz = (fz - fz0) / fz0;
        dfzd = (fzd - fz0d - dfz * fz0d) * (1.0 / fz0);
        kx = kappa + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
        kxd = kappad + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX]);
        gx2 = gamma * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
        gx2d = gammad * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] + gamma *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
        mux = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2
            * gx2) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        muxd = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd)) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2) -
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2d) * gx2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2d)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        e3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
        e3d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] +
            ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PEX3] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfzd)) *
            dfz + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
        if (MAGGI_RE(kx) > 0.0) {
          e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          e4d = e3d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) - e3 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
          if (MAGGI_RE(e4) > 1.0) {
            y2 = 1.0;
            y2d = 0.0;
          } else {
            y2 = e4;
            y2d = e4d;
          }
          ex = y2;
          exd = y2d;
        } else {
          e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          e5d = e3d * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) + e3 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
          if (MAGGI_RE(e5) > 1.0) {
            y3 = 1.0;
            y3d = 0.0;
          } else {
            y3 = e5;
            y3d = e5d;
          }
          ex = y3;
          exd = y3d;
        }
        x30 = mux * fz;
        x30d = muxd * fz + mux * fzd;
        x31 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCX];
        x31d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX];
        x32 = ex;
        x32d = exd;
        t23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
        t23d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfzd;
        t24 = exp(t23);
        t24d = t24 * t23d;
        x33 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t24 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        x33d = ((fzd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t24 + fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t24d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + fz * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t24 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        x34 = kx;
        x34d = kxd;
        x35 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LMUX];
        x35d = ((fzd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + fz *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd))) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + fz * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]) * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LMUX] + fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LMUX];
        fz0_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]];
        fz0_2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
            p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
            pd[t->tyreadr[t->wheeltyre[n2]]];
        gy2 = gamma * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
        gy2d = gammad * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] + gamma *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
        ay = a2 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHY3] * gy2;
        ayd = a2d + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY]) + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHY3] * gy2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] * gy2d);
        muy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2
            * gy2) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        muyd = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd)) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2) -
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2d) * gy2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2d)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        e6 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
        e6d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PEY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
        if (MAGGI_RE(ay) > 0.0) {
          e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          e7d = e6d * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2)) - e6 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEY4] * gy2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2d));
          if (MAGGI_RE(e7) > 1.0) {
            y4 = 1.0;
            y4d = 0.0;
          } else {
            y4 = e7;
            y4d = e7d;
          }
          ey = y4;
          eyd = y4d;
        } else {
          e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          e8d = e6d * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2)) + e6 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEY4] * gy2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2d));
          if (MAGGI_RE(e8) > 1.0) {
            y5 = 1.0;
            y5d = 0.0;
          } else {
            y5 = e8;
            y5d = e8d;
          }
          ey = y5;
          eyd = y5d;
        }
        t25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2;
        t25d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2d;
        z2 = fz / t25;
        z2d = (fzd - z2 * t25d) * (1.0 / t25);
        y0_3 = muy * fz;
        y0_3d = muyd * fz + muy * fzd;
        y1 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCY];
        y1d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY];
        y2_2 = ey;
        y2_2d = eyd;
        if (MAGGI_RE(gy2) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
          y6 = gy2;
          y6d = gy2d;
        } else if (MAGGI_RE(gy2) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LOW_CAMBER])) {
          y6 = -gy2;
          y6d = -gy2d;
        } else {
          p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
          p2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
          t26 = p2 * p2;
          t26d = p2d * p2 + p2 * p2d;
          z3 = gy2 * gy2 / t26;
          z3d = (gy2d * gy2 + gy2 * gy2d - z3 * t26d) * (1.0 / t26);
          y6 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
          y6d = (0.125 * p2d * z3 + 0.125 * p2 * z3d) * (15.0 + z3 * (-10.0 + 3.0 * z3)) + 0.125 *
              p2 * z3 * (z3d * (-10.0 + 3.0 * z3) + z3 * (3.0 * z3d));
        }
        t27 = 1.0 + z2 * z2;
        t27d = z2d * z2 + z2 * z2d;
        t28 = 2.0 * z2 / t27;
        t28d = (2.0 * z2d - t28 * t27d) * (1.0 / t27);
        y3_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28 * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) * p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_LKY];
        y3_2d = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d) * t28 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) - p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKY1] * fz0_2 * t28 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] *
            y6 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6d)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKY1] * fz0_2 * t28 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKY3] * y6) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
        y4_2 = ay;
        y4_2d = ayd;
        y5_2 = fz * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        y5_2d = (fzd * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) + fz
            * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd)) * gy2 +
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY4] * dfz) * gy2d))) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] +
            fz * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        peak = y0_3;
        peakd = y0_3d;
        x4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa;
        x4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappad;
        t29 = 1.0 + x4 * x4;
        t29d = x4d * x4 + x4 * x4d;
        t30 = sqrt(t29);
        t30d = 1.0 / (2.0 * t30) * t29d;
        t31 = 1.0 / t30;
        t31d = -(t31 * t30d * (1.0 / t30));
        g20 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g20d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBX1] * t31 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g21 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
        g21d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
        e9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REX2] * dfz;
        e9d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_REX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] * dfzd);
        if (MAGGI_RE(e9) > 1.0) {
          y7 = 1.0;
          y7d = 0.0;
        } else {
          y7 = e9;
          y7d = e9d;
        }
        g22 = y7;
        g22d = y7d;
        g23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        g23d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        x5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        x5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBY2] * (a2d - pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        t32 = 1.0 + x5 * x5;
        t32d = x5d * x5 + x5 * x5d;
        t33 = sqrt(t32);
        t33d = 1.0 / (2.0 * t33) * t32d;
        t34 = 1.0 / t33;
        t34d = -(t34 * t33d * (1.0 / t33));
        g24 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g24d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBY1] * t34 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
        g25d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
        e10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REY2] * dfz;
        e10d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_REY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] * dfzd);
        if (MAGGI_RE(e10) > 1.0) {
          y8 = 1.0;
          y8d = 0.0;
        } else {
          y8 = e10;
          y8d = e10d;
        }
        g26 = y8;
        g26d = y8d;
        g27 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RHY2] * dfz;
        g27d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RHY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfzd);
        p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        p3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        x6 = p3 * a2;
        x6d = p3d * a2 + p3 * a2d;
        t35 = 1.0 + x6 * x6;
        t35d = x6d * x6 + x6 * x6d;
        t36 = sqrt(t35);
        t36d = 1.0 / (2.0 * t36) * t35d;
        t37 = 1.0 / t36;
        t37d = -(t37 * t36d * (1.0 / t36));
        dv = peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) * t37;
        dvd = (peakd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) + peak * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1]
            + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gammad))) * t37 + peak *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma) *
            t37d;
        t38 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa;
        t38d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappad;
        t39 = atan(t38);
        t39d = 1.0 / (1.0 + t38 * t38) * t38d;
        t40 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t39;
        t40d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t39 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t39d;
        t41 = sin(t40);
        t41d = cos(t40) * t40d;
        g28 = dv * t41 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        g28d = (dvd * t41 + dv * t41d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + dv *
            t41 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        y9 = g20 * (a2 + g23);
        y9d = g20d * (a2 + g23) + g20 * (a2d + g23d);
        y10 = g20 * g23;
        y10d = g20d * g23 + g20 * g23d;
        t42 = atan(y9);
        t42d = 1.0 / (1.0 + y9 * y9) * y9d;
        t43 = (1.0 - g22) * y9 + g22 * t42;
        t43d = -(g22d * y9) + (1.0 - g22) * y9d + (g22d * t42 + g22 * t42d);
        t44 = atan(t43);
        t44d = 1.0 / (1.0 + t43 * t43) * t43d;
        t45 = g21 * t44;
        t45d = g21d * t44 + g21 * t44d;
        t46 = cos(t45);
        t46d = -(sin(t45) * t45d);
        t47 = atan(y10);
        t47d = 1.0 / (1.0 + y10 * y10) * y10d;
        t48 = (1.0 - g22) * y10 + g22 * t47;
        t48d = -(g22d * y10) + (1.0 - g22) * y10d + (g22d * t47 + g22 * t47d);
        t49 = atan(t48);
        t49d = 1.0 / (1.0 + t48 * t48) * t48d;
        t50 = g21 * t49;
        t50d = g21d * t49 + g21 * t49d;
        t51 = cos(t50);
        t51d = -(sin(t50) * t50d);
        gx = t46 / t51;
        gxd = (t46d - gx * t51d) * (1.0 / t51);
        y11 = g24 * (kappa + g27);
        y11d = g24d * (kappa + g27) + g24 * (kappad + g27d);
        y12 = g24 * g27;
        y12d = g24d * g27 + g24 * g27d;
        t52 = atan(y11);
        t52d = 1.0 / (1.0 + y11 * y11) * y11d;
        t53 = (1.0 - g26) * y11 + g26 * t52;
        t53d = -(g26d * y11) + (1.0 - g26) * y11d + (g26d * t52 + g26 * t52d);
        t54 = atan(t53);
        t54d = 1.0 / (1.0 + t53 * t53) * t53d;
        t55 = g25 * t54;
        t55d = g25d * t54 + g25 * t54d;
        t56 = cos(t55);
        t56d = -(sin(t55) * t55d);
        t57 = atan(y12);
        t57d = 1.0 / (1.0 + y12 * y12) * y12d;
        t58 = (1.0 - g26) * y12 + g26 * t57;
        t58d = -(g26d * y12) + (1.0 - g26) * y12d + (g26d * t57 + g26 * t57d);
        t59 = atan(t58);
        t59d = 1.0 / (1.0 + t58 * t58) * t58d;
        t60 = g25 * t59;
        t60d = g25d * t59 + g25 * t59d;
        t61 = cos(t60);
        t61d = -(sin(t60) * t60d);
        gy = t56 / t61;
        gyd = (t56d - gy * t61d) * (1.0 / t61);
        b3 = g20;
        b3d = g20d;
        c3 = g21;
        c3d = g21d;
        e11 = g22;
        e11d = g22d;
        shift = g23;
        shiftd = g23d;
        y13 = b3 * (a2 + shift);
        y13d = b3d * (a2 + shift) + b3 * (a2d + shiftd);
        y0 = b3 * shift;
        y0d = b3d * shift + b3 * shiftd;
        t62 = atan(y13);
        t62d = 1.0 / (1.0 + y13 * y13) * y13d;
        t63 = (1.0 - e11) * y13 + e11 * t62;
        t63d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t62 + e11 * t62d);
        t64 = atan(t63);
        t64d = 1.0 / (1.0 + t63 * t63) * t63d;
        z4 = c3 * t64;
        z4d = c3d * t64 + c3 * t64d;
        t65 = atan(y0);
        t65d = 1.0 / (1.0 + y0 * y0) * y0d;
        t66 = (1.0 - e11) * y0 + e11 * t65;
        t66d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t65 + e11 * t65d);
        t67 = atan(t66);
        t67d = 1.0 / (1.0 + t66 * t66) * t66d;
        z0 = c3 * t67;
        z0d = c3d * t67 + c3 * t67d;
        n5 = cos(z0);
        n5d = -(sin(z0) * z0d);
        t68 = atan(y13);
        t68d = 1.0 / (1.0 + y13 * y13) * y13d;
        z5 = (1.0 - e11) * y13 + e11 * t68;
        z5d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t68 + e11 * t68d);
        t69 = sin(z4);
        t69d = cos(z4) * z4d;
        t70 = 1.0 + y13 * y13;
        t70d = y13d * y13 + y13 * y13d;
        t71 = e11 / t70;
        t71d = (e11d - t71 * t70d) * (1.0 / t70);
        t72 = 1.0 + z5 * z5;
        t72d = z5d * z5 + z5 * z5d;
        t73 = c3 * (1.0 - e11 + t71) / t72;
        t73d = (c3d * (1.0 - e11 + t71) + c3 * (-e11d + t71d) - t73 * t72d) * (1.0 / t72);
        s2 = -t69 * t73 / n5;
        s2d = (-(t69d * t73) - t69 * t73d - s2 * n5d) * (1.0 / n5);
        t74 = atan(y0);
        t74d = 1.0 / (1.0 + y0 * y0) * y0d;
        z6 = (1.0 - e11) * y0 + e11 * t74;
        z6d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t74 + e11 * t74d);
        t75 = cos(z4);
        t75d = -(sin(z4) * z4d);
        t76 = sin(z0);
        t76d = cos(z0) * z0d;
        t77 = n5 * n5;
        t77d = n5d * n5 + n5 * n5d;
        t78 = t75 * t76 / t77;
        t78d = (t75d * t76 + t75 * t76d - t78 * t77d) * (1.0 / t77);
        t79 = 1.0 + y0 * y0;
        t79d = y0d * y0 + y0 * y0d;
        t80 = e11 / t79;
        t80d = (e11d - t80 * t79d) * (1.0 / t79);
        t81 = 1.0 + z6 * z6;
        t81d = z6d * z6 + z6 * z6d;
        t82 = c3 * (1.0 - e11 + t80) / t81;
        t82d = (c3d * (1.0 - e11 + t80) + c3 * (-e11d + t80d) - t82 * t81d) * (1.0 / t81);
        wx1 = s2 * (a2 + shift) + t78 * t82 * shift;
        wx1d = s2d * (a2 + shift) + s2 * (a2d + shiftd) + ((t78d * t82 + t78 * t82d) * shift + t78 *
            t82 * shiftd);
        b4 = g24;
        b4d = g24d;
        c4 = g25;
        c4d = g25d;
        e12 = g26;
        e12d = g26d;
        shift2 = g27;
        shift2d = g27d;
        y14 = b4 * (kappa + shift2);
        y14d = b4d * (kappa + shift2) + b4 * (kappad + shift2d);
        y0_2 = b4 * shift2;
        y0_2d = b4d * shift2 + b4 * shift2d;
        t83 = atan(y14);
        t83d = 1.0 / (1.0 + y14 * y14) * y14d;
        t84 = (1.0 - e12) * y14 + e12 * t83;
        t84d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t83 + e12 * t83d);
        t85 = atan(t84);
        t85d = 1.0 / (1.0 + t84 * t84) * t84d;
        z7 = c4 * t85;
        z7d = c4d * t85 + c4 * t85d;
        t86 = atan(y0_2);
        t86d = 1.0 / (1.0 + y0_2 * y0_2) * y0_2d;
        t87 = (1.0 - e12) * y0_2 + e12 * t86;
        t87d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t86 + e12 * t86d);
        t88 = atan(t87);
        t88d = 1.0 / (1.0 + t87 * t87) * t87d;
        z0_2 = c4 * t88;
        z0_2d = c4d * t88 + c4 * t88d;
        n6 = cos(z0_2);
        n6d = -(sin(z0_2) * z0_2d);
        t89 = atan(y14);
        t89d = 1.0 / (1.0 + y14 * y14) * y14d;
        z8 = (1.0 - e12) * y14 + e12 * t89;
        z8d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t89 + e12 * t89d);
        t90 = sin(z7);
        t90d = cos(z7) * z7d;
        t91 = 1.0 + y14 * y14;
        t91d = y14d * y14 + y14 * y14d;
        t92 = e12 / t91;
        t92d = (e12d - t92 * t91d) * (1.0 / t91);
        t93 = 1.0 + z8 * z8;
        t93d = z8d * z8 + z8 * z8d;
        t94 = c4 * (1.0 - e12 + t92) / t93;
        t94d = (c4d * (1.0 - e12 + t92) + c4 * (-e12d + t92d) - t94 * t93d) * (1.0 / t93);
        s3 = -t90 * t94 / n6;
        s3d = (-(t90d * t94) - t90 * t94d - s3 * n6d) * (1.0 / n6);
        t95 = atan(y0_2);
        t95d = 1.0 / (1.0 + y0_2 * y0_2) * y0_2d;
        z9 = (1.0 - e12) * y0_2 + e12 * t95;
        z9d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t95 + e12 * t95d);
        t96 = cos(z7);
        t96d = -(sin(z7) * z7d);
        t97 = sin(z0_2);
        t97d = cos(z0_2) * z0_2d;
        t98 = n6 * n6;
        t98d = n6d * n6 + n6 * n6d;
        t99 = t96 * t97 / t98;
        t99d = (t96d * t97 + t96 * t97d - t99 * t98d) * (1.0 / t98);
        t100 = 1.0 + y0_2 * y0_2;
        t100d = y0_2d * y0_2 + y0_2 * y0_2d;
        t101 = e12 / t100;
        t101d = (e12d - t101 * t100d) * (1.0 / t100);
        t102 = 1.0 + z9 * z9;
        t102d = z9d * z9 + z9 * z9d;
        t103 = c4 * (1.0 - e12 + t101) / t102;
        t103d = (c4d * (1.0 - e12 + t101) + c4 * (-e12d + t101d) - t103 * t102d) * (1.0 / t102);
        wy1 = s3 * (kappa + shift2) + t99 * t103 * shift2;
        wy1d = s3d * (kappa + shift2) + s3 * (kappad + shift2d) + ((t99d * t103 + t99 * t103d) *
            shift2 + t99 * t103 * shift2d);
        t104 = x31 * x30;
        t104d = x31d * x30 + x31 * x30d;
        t105 = x33 / t104;
        t105d = (x33d - t105 * t104d) * (1.0 / t104);
        y15 = t105 * x34;
        y15d = t105d * x34 + t105 * x34d;
        t106 = atan(y15);
        t106d = 1.0 / (1.0 + y15 * y15) * y15d;
        t107 = (1.0 - x32) * y15 + x32 * t106;
        t107d = -(x32d * y15) + (1.0 - x32) * y15d + (x32d * t106 + x32 * t106d);
        t108 = atan(t107);
        t108d = 1.0 / (1.0 + t107 * t107) * t107d;
        t109 = x31 * t108;
        t109d = x31d * t108 + x31 * t108d;
        t110 = sin(t109);
        t110d = cos(t109) * t109d;
        fx = x30 * t110 + x35;
        fxd = x30d * t110 + x30 * t110d + x35d;
        t111 = y1 * y0_3;
        t111d = y1d * y0_3 + y1 * y0_3d;
        t112 = y3_2 / t111;
        t112d = (y3_2d - t112 * t111d) * (1.0 / t111);
        y16 = t112 * y4_2;
        y16d = t112d * y4_2 + t112 * y4_2d;
        t113 = atan(y16);
        t113d = 1.0 / (1.0 + y16 * y16) * y16d;
        t114 = (1.0 - y2_2) * y16 + y2_2 * t113;
        t114d = -(y2_2d * y16) + (1.0 - y2_2) * y16d + (y2_2d * t113 + y2_2 * t113d);
        t115 = atan(t114);
        t115d = 1.0 / (1.0 + t114 * t114) * t114d;
        t116 = y1 * t115;
        t116d = y1d * t115 + y1 * t115d;
        t117 = sin(t116);
        t117d = cos(t116) * t116d;
        fy = y0_3 * t117 + y5_2;
        fyd = y0_3d * t117 + y0_3 * t117d + y5_2d;
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        p5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        x7 = p4 * (a2 - p5);
        x7d = p4d * (a2 - p5) + p4 * (a2d - p5d);
        t118 = 1.0 + x7 * x7;
        t118d = x7d * x7 + x7 * x7d;
        t119 = sqrt(t118);
        t119d = 1.0 / (2.0 * t119) * t118d;
        t120 = 1.0 / t119;
        t120d = -(t120 * t119d * (1.0 / t119));
        l3 = p4 * t120;
        l3d = p4d * t120 + p4 * t120d;
        x8 = p3 * a2;
        x8d = p3d * a2 + p3 * a2d;
        t121 = 1.0 + x8 * x8;
        t121d = x8d * x8 + x8 * x8d;
        t122 = sqrt(t121);
        t122d = 1.0 / (2.0 * t122) * t121d;
        t123 = 1.0 / t122;
        t123d = -(t123 * t122d * (1.0 / t122));
        v2 = p3 * t123;
        v2d = p3d * t123 + p3 * t123d;
        b2 = -g24 * l3 * l3 * (a2 - p5);
        b2d = ((-(g24d * l3) - g24 * l3d) * l3 + -g24 * l3 * l3d) * (a2 - p5) + -g24 * l3 * l3 *
            (a2d - p5d);
        t124 = y1 * y0_3;
        t124d = y1d * y0_3 + y1 * y0_3d;
        b5 = y3_2 / t124;
        b5d = (y3_2d - b5 * t124d) * (1.0 / t124);
        y17 = b5 * y4_2;
        y17d = b5d * y4_2 + b5 * y4_2d;
        t125 = atan(y17);
        t125d = 1.0 / (1.0 + y17 * y17) * y17d;
        z10 = (1.0 - y2_2) * y17 + y2_2 * t125;
        z10d = -(y2_2d * y17) + (1.0 - y2_2) * y17d + (y2_2d * t125 + y2_2 * t125d);
        t126 = atan(y17);
        t126d = 1.0 / (1.0 + y17 * y17) * y17d;
        t127 = (1.0 - y2_2) * y17 + y2_2 * t126;
        t127d = -(y2_2d * y17) + (1.0 - y2_2) * y17d + (y2_2d * t126 + y2_2 * t126d);
        t128 = atan(t127);
        t128d = 1.0 / (1.0 + t127 * t127) * t127d;
        t129 = y1 * t128;
        t129d = y1d * t128 + y1 * t128d;
        t130 = cos(t129);
        t130d = -(sin(t129) * t129d);
        t131 = 1.0 + y17 * y17;
        t131d = y17d * y17 + y17 * y17d;
        t132 = y2_2 / t131;
        t132d = (y2_2d - t132 * t131d) * (1.0 / t131);
        t133 = 1.0 + z10 * z10;
        t133d = z10d * z10 + z10 * z10d;
        t134 = y1 * (1.0 - y2_2 + t132) / t133;
        t134d = (y1d * (1.0 - y2_2 + t132) + y1 * (-y2_2d + t132d) - t134 * t133d) * (1.0 / t133);
        p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        p6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        x9 = p6 * kappa;
        x9d = p6d * kappa + p6 * kappad;
        t135 = 1.0 + x9 * x9;
        t135d = x9d * x9 + x9 * x9d;
        t136 = sqrt(t135);
        t136d = 1.0 / (2.0 * t136) * t135d;
        t137 = 1.0 / t136;
        t137d = -(t137 * t136d * (1.0 / t136));
        m = p6 * t137;
        md = p6d * t137 + p6 * t137d;
        ka = -g20 * m * m * kappa;
        kad = ((-(g20d * m) - g20 * md) * m + -g20 * m * md) * kappa + -g20 * m * m * kappad;
        t138 = x31 * x30;
        t138d = x31d * x30 + x31 * x30d;
        b6 = x33 / t138;
        b6d = (x33d - b6 * t138d) * (1.0 / t138);
        y18 = b6 * x34;
        y18d = b6d * x34 + b6 * x34d;
        t139 = atan(y18);
        t139d = 1.0 / (1.0 + y18 * y18) * y18d;
        z11 = (1.0 - x32) * y18 + x32 * t139;
        z11d = -(x32d * y18) + (1.0 - x32) * y18d + (x32d * t139 + x32 * t139d);
        t140 = atan(y18);
        t140d = 1.0 / (1.0 + y18 * y18) * y18d;
        t141 = (1.0 - x32) * y18 + x32 * t140;
        t141d = -(x32d * y18) + (1.0 - x32) * y18d + (x32d * t140 + x32 * t140d);
        t142 = atan(t141);
        t142d = 1.0 / (1.0 + t141 * t141) * t141d;
        t143 = x31 * t142;
        t143d = x31d * t142 + x31 * t142d;
        t144 = cos(t143);
        t144d = -(sin(t143) * t143d);
        t145 = 1.0 + y18 * y18;
        t145d = y18d * y18 + y18 * y18d;
        t146 = x32 / t145;
        t146d = (x32d - t146 * t145d) * (1.0 / t145);
        t147 = 1.0 + z11 * z11;
        t147d = z11d * z11 + z11 * z11d;
        t148 = x31 * (1.0 - x32 + t146) / t147;
        t148d = (x31d * (1.0 - x32 + t146) + x31 * (-x32d + t146d) - t148 * t147d) * (1.0 / t147);
        ux = fx * gx / x30;
        uxd = (fxd * gx + fx * gxd - ux * x30d) * (1.0 / x30);
        uy = (fy * gy + g28) / y0_3;
        uyd = (fyd * gy + fy * gyd + g28d - uy * y0_3d) * (1.0 / y0_3);
        tb158 = sb[i][2];
        tb158d = sbd[i][2];
        sb[i][2] = 0.0;
        sbd[i][2] = 0.0;
        t149b = tb158 * (1.0 / (2.0 * s[i][2]));
        t149bd = tb158d * (1.0 / (2.0 * s[i][2])) - tb158 * (1.0 / (2.0 * s[i][2]) * (2.0 *
            sd[i][2]) / (2.0 * s[i][2]));
        uxb = t149b * ux;
        uxbd = t149bd * ux + t149b * uxd;
        uxb += t149b * ux;
        uxbd += t149bd * ux + t149b * uxd;
        uyb = t149b * uy;
        uybd = t149bd * uy + t149b * uyd;
        uyb += t149b * uy;
        uybd += t149bd * uy + t149b * uyd;
        tb157 = uyb / y0_3;
        tb157d = (uybd - tb157 * y0_3d) * (1.0 / y0_3);
        fyb = tb157 * gy;
        fybd = tb157d * gy + tb157 * gyd;
        gyb = tb157 * fy;
        gybd = tb157d * fy + tb157 * fyd;
        g28b = tb157;
        g28bd = tb157d;
        y0_3b = -(tb157 * uy);
        y0_3bd = -(tb157d * uy + tb157 * uyd);
        tb156 = uxb / x30;
        tb156d = (uxbd - tb156 * x30d) * (1.0 / x30);
        fxb = tb156 * gx;
        fxbd = tb156d * gx + tb156 * gxd;
        gxb = tb156 * fx;
        gxbd = tb156d * fx + tb156 * fxd;
        x30b = -(tb156 * ux);
        x30bd = -(tb156d * ux + tb156 * uxd);
        tb151 = sb[i][1];
        tb151d = sbd[i][1];
        sb[i][1] = 0.0;
        sbd[i][1] = 0.0;
        gxb += tb151 * (x30 * t144 * t148 * b6);
        gxbd += tb151d * (x30 * t144 * t148 * b6) + tb151 * (((x30d * t144 + x30 * t144d) * t148 +
            x30 * t144 * t148d) * b6 + x30 * t144 * t148 * b6d);
        tb152 = tb151 * gx;
        tb152d = tb151d * gx + tb151 * gxd;
        tb153 = tb152 * b6;
        tb153d = tb152d * b6 + tb152 * b6d;
        tb154 = tb153 * t148;
        tb154d = tb153d * t148 + tb153 * t148d;
        x30b += tb154 * t144;
        x30bd += tb154d * t144 + tb154 * t144d;
        t144b = tb154 * x30;
        t144bd = tb154d * x30 + tb154 * x30d;
        t148b = tb153 * (x30 * t144);
        t148bd = tb153d * (x30 * t144) + tb153 * (x30d * t144 + x30 * t144d);
        b6b = tb152 * (x30 * t144 * t148);
        b6bd = tb152d * (x30 * t144 * t148) + tb152 * ((x30d * t144 + x30 * t144d) * t148 + x30 *
            t144 * t148d);
        tb155 = tb151 * ka;
        tb155d = tb151d * ka + tb151 * kad;
        fxb += tb155 * wx1;
        fxbd += tb155d * wx1 + tb155 * wx1d;
        wx1b = tb155 * fx;
        wx1bd = tb155d * fx + tb155 * fxd;
        kab = tb151 * (fx * wx1);
        kabd = tb151d * (fx * wx1) + tb151 * (fxd * wx1 + fx * wx1d);
        tb149 = t148b / t147;
        tb149d = (t148bd - tb149 * t147d) * (1.0 / t147);
        x31b = tb149 * (1.0 - x32 + t146);
        x31bd = tb149d * (1.0 - x32 + t146) + tb149 * (-x32d + t146d);
        tb150 = tb149 * x31;
        tb150d = tb149d * x31 + tb149 * x31d;
        x32b = -tb150;
        x32bd = -tb150d;
        t146b = tb150;
        t146bd = tb150d;
        t147b = -(tb149 * t148);
        t147bd = -(tb149d * t148 + tb149 * t148d);
        z11b = t147b * z11;
        z11bd = t147bd * z11 + t147b * z11d;
        z11b += t147b * z11;
        z11bd += t147bd * z11 + t147b * z11d;
        tb148 = t146b / t145;
        tb148d = (t146bd - tb148 * t145d) * (1.0 / t145);
        x32b += tb148;
        x32bd += tb148d;
        t145b = -(tb148 * t146);
        t145bd = -(tb148d * t146 + tb148 * t146d);
        y18b = t145b * y18;
        y18bd = t145bd * y18 + t145b * y18d;
        y18b += t145b * y18;
        y18bd += t145bd * y18 + t145b * y18d;
        t143b = -(t144b * sin(t143));
        t143bd = -(t144bd * sin(t143) + t144b * (cos(t143) * t143d));
        x31b += t143b * t142;
        x31bd += t143bd * t142 + t143b * t142d;
        t142b = t143b * x31;
        t142bd = t143bd * x31 + t143b * x31d;
        t141b = t142b * (1.0 / (1.0 + t141 * t141));
        t141bd = t142bd * (1.0 / (1.0 + t141 * t141)) - t142b * (1.0 / (1.0 + t141 * t141) * (t141d
            * t141 + t141 * t141d) / (1.0 + t141 * t141));
        x32b -= t141b * y18;
        x32bd -= t141bd * y18 + t141b * y18d;
        y18b += t141b * (1.0 - x32);
        y18bd += t141bd * (1.0 - x32) - t141b * x32d;
        x32b += t141b * t140;
        x32bd += t141bd * t140 + t141b * t140d;
        t140b = t141b * x32;
        t140bd = t141bd * x32 + t141b * x32d;
        y18b += t140b * (1.0 / (1.0 + y18 * y18));
        y18bd += t140bd * (1.0 / (1.0 + y18 * y18)) - t140b * (1.0 / (1.0 + y18 * y18) * (y18d * y18
            + y18 * y18d) / (1.0 + y18 * y18));
        x32b -= z11b * y18;
        x32bd -= z11bd * y18 + z11b * y18d;
        y18b += z11b * (1.0 - x32);
        y18bd += z11bd * (1.0 - x32) - z11b * x32d;
        x32b += z11b * t139;
        x32bd += z11bd * t139 + z11b * t139d;
        t139b = z11b * x32;
        t139bd = z11bd * x32 + z11b * x32d;
        y18b += t139b * (1.0 / (1.0 + y18 * y18));
        /* its derivative by y */
        y18bd += t139bd * (1.0 / (1.0 + y18 * y18)) - t139b * (1.0 / (1.0 + y18 * y18) * (y18d * y18
            + y18 * y18d) / (1.0 + y18 * y18));
        b6b += y18b * x34;
        b6bd += y18bd * x34 + y18b * x34d;
        x34b = y18b * b6;
        x34bd = y18bd * b6 + y18b * b6d;
        tb147 = b6b / t138;
        tb147d = (b6bd - tb147 * t138d) * (1.0 / t138);
        x33b = tb147;
        x33bd = tb147d;
        t138b = -(tb147 * b6);
        t138bd = -(tb147d * b6 + tb147 * b6d);
        x31b += t138b * x30;
        /* its derivative by the slip */
        x31bd += t138bd * x30 + t138b * x30d;
        x30b += t138b * x31;
        x30bd += t138bd * x31 + t138b * x31d;
        tb145 = kab * kappa;
        tb145d = kabd * kappa + kab * kappad;
        tb146 = tb145 * m;
        tb146d = tb145d * m + tb145 * md;
        g20b = -(tb146 * m);
        g20bd = -(tb146d * m + tb146 * md);
        mb = -(tb146 * g20);
        mbd = -(tb146d * g20 + tb146 * g20d);
        mb += tb145 * (-g20 * m);
        mbd += tb145d * (-g20 * m) + tb145 * (-(g20d * m) - g20 * md);
        kappab = kab * (-g20 * m * m);
        kappabd = kabd * (-g20 * m * m) + kab * ((-(g20d * m) - g20 * md) * m + -g20 * m * md);
        p6b = mb * t137;
        p6bd = mbd * t137 + mb * t137d;
        t137b = mb * p6;
        t137bd = mbd * p6 + mb * p6d;
        tb144 = t137b / t136;
        tb144d = (t137bd - tb144 * t136d) * (1.0 / t136);
        t136b = -(tb144 * t137);
        t136bd = -(tb144d * t137 + tb144 * t137d);
        t135b = t136b * (1.0 / (2.0 * t136));
        t135bd = t136bd * (1.0 / (2.0 * t136)) - t136b * (1.0 / (2.0 * t136) * (2.0 * t136d) / (2.0
            * t136));
        x9b = t135b * x9;
        x9bd = t135bd * x9 + t135b * x9d;
        x9b += t135b * x9;
        x9bd += t135bd * x9 + t135b * x9d;
        p6b += x9b * kappa;
        p6bd += x9bd * kappa + x9b * kappad;
        kappab += x9b * p6;
        kappabd += x9bd * p6 + x9b * p6d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += p6b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += p6bd;
        tb135 = sb[i][0];
        tb135d = sbd[i][0];
        sb[i][0] = 0.0;
        sbd[i][0] = 0.0;
        tb136 = tb135 * (gy * (y0_3 * t130 * t134 * b5) + fy * wy1 * b2 - g28 * v2 * v2 * a2);
        tb136d = tb135d * (gy * (y0_3 * t130 * t134 * b5) + fy * wy1 * b2 - g28 * v2 * v2 * a2) +
            tb135 * (gyd * (y0_3 * t130 * t134 * b5) + gy * (((y0_3d * t130 + y0_3 * t130d) * t134 +
            y0_3 * t130 * t134d) * b5 + y0_3 * t130 * t134 * b5d) + ((fyd * wy1 + fy * wy1d) * b2 +
            fy * wy1 * b2d) - (((g28d * v2 + g28 * v2d) * v2 + g28 * v2 * v2d) * a2 + g28 * v2 * v2
            * a2d));
        a2b = tb136 * a2;
        a2bd = tb136d * a2 + tb136 * a2d;
        a2b += tb136 * a2;
        a2bd += tb136d * a2 + tb136 * a2d;
        tb137 = tb135 * (1.0 + a2 * a2);
        tb137d = tb135d * (1.0 + a2 * a2) + tb135 * (a2d * a2 + a2 * a2d);
        gyb += tb137 * (y0_3 * t130 * t134 * b5);
        gybd += tb137d * (y0_3 * t130 * t134 * b5) + tb137 * (((y0_3d * t130 + y0_3 * t130d) * t134
            + y0_3 * t130 * t134d) * b5 + y0_3 * t130 * t134 * b5d);
        tb138 = tb137 * gy;
        tb138d = tb137d * gy + tb137 * gyd;
        tb139 = tb138 * b5;
        tb139d = tb138d * b5 + tb138 * b5d;
        tb140 = tb139 * t134;
        tb140d = tb139d * t134 + tb139 * t134d;
        y0_3b += tb140 * t130;
        y0_3bd += tb140d * t130 + tb140 * t130d;
        t130b = tb140 * y0_3;
        t130bd = tb140d * y0_3 + tb140 * y0_3d;
        t134b = tb139 * (y0_3 * t130);
        t134bd = tb139d * (y0_3 * t130) + tb139 * (y0_3d * t130 + y0_3 * t130d);
        b5b = tb138 * (y0_3 * t130 * t134);
        b5bd = tb138d * (y0_3 * t130 * t134) + tb138 * ((y0_3d * t130 + y0_3 * t130d) * t134 + y0_3
            * t130 * t134d);
        tb141 = tb137 * b2;
        tb141d = tb137d * b2 + tb137 * b2d;
        fyb += tb141 * wy1;
        fybd += tb141d * wy1 + tb141 * wy1d;
        wy1b = tb141 * fy;
        wy1bd = tb141d * fy + tb141 * fyd;
        b2b = tb137 * (fy * wy1);
        b2bd = tb137d * (fy * wy1) + tb137 * (fyd * wy1 + fy * wy1d);
        tb142 = tb137 * a2;
        tb142d = tb137d * a2 + tb137 * a2d;
        tb143 = tb142 * v2;
        tb143d = tb142d * v2 + tb142 * v2d;
        g28b -= tb143 * v2;
        g28bd -= tb143d * v2 + tb143 * v2d;
        v2b = -(tb143 * g28);
        v2bd = -(tb143d * g28 + tb143 * g28d);
        v2b -= tb142 * (g28 * v2);
        v2bd -= tb142d * (g28 * v2) + tb142 * (g28d * v2 + g28 * v2d);
        a2b -= tb137 * (g28 * v2 * v2);
        a2bd -= tb137d * (g28 * v2 * v2) + tb137 * ((g28d * v2 + g28 * v2d) * v2 + g28 * v2 * v2d);
        tb133 = t134b / t133;
        tb133d = (t134bd - tb133 * t133d) * (1.0 / t133);
        y1b = tb133 * (1.0 - y2_2 + t132);
        y1bd = tb133d * (1.0 - y2_2 + t132) + tb133 * (-y2_2d + t132d);
        tb134 = tb133 * y1;
        tb134d = tb133d * y1 + tb133 * y1d;
        y2_2b = -tb134;
        y2_2bd = -tb134d;
        t132b = tb134;
        t132bd = tb134d;
        t133b = -(tb133 * t134);
        t133bd = -(tb133d * t134 + tb133 * t134d);
        z10b = t133b * z10;
        z10bd = t133bd * z10 + t133b * z10d;
        z10b += t133b * z10;
        z10bd += t133bd * z10 + t133b * z10d;
        tb132 = t132b / t131;
        tb132d = (t132bd - tb132 * t131d) * (1.0 / t131);
        y2_2b += tb132;
        y2_2bd += tb132d;
        t131b = -(tb132 * t132);
        t131bd = -(tb132d * t132 + tb132 * t132d);
        y17b = t131b * y17;
        y17bd = t131bd * y17 + t131b * y17d;
        y17b += t131b * y17;
        y17bd += t131bd * y17 + t131b * y17d;
        t129b = -(t130b * sin(t129));
        t129bd = -(t130bd * sin(t129) + t130b * (cos(t129) * t129d));
        y1b += t129b * t128;
        y1bd += t129bd * t128 + t129b * t128d;
        t128b = t129b * y1;
        t128bd = t129bd * y1 + t129b * y1d;
        t127b = t128b * (1.0 / (1.0 + t127 * t127));
        t127bd = t128bd * (1.0 / (1.0 + t127 * t127)) - t128b * (1.0 / (1.0 + t127 * t127) * (t127d
            * t127 + t127 * t127d) / (1.0 + t127 * t127));
        y2_2b -= t127b * y17;
        y2_2bd -= t127bd * y17 + t127b * y17d;
        y17b += t127b * (1.0 - y2_2);
        y17bd += t127bd * (1.0 - y2_2) - t127b * y2_2d;
        y2_2b += t127b * t126;
        y2_2bd += t127bd * t126 + t127b * t126d;
        t126b = t127b * y2_2;
        t126bd = t127bd * y2_2 + t127b * y2_2d;
        y17b += t126b * (1.0 / (1.0 + y17 * y17));
        y17bd += t126bd * (1.0 / (1.0 + y17 * y17)) - t126b * (1.0 / (1.0 + y17 * y17) * (y17d * y17
            + y17 * y17d) / (1.0 + y17 * y17));
        y2_2b -= z10b * y17;
        y2_2bd -= z10bd * y17 + z10b * y17d;
        y17b += z10b * (1.0 - y2_2);
        y17bd += z10bd * (1.0 - y2_2) - z10b * y2_2d;
        y2_2b += z10b * t125;
        y2_2bd += z10bd * t125 + z10b * t125d;
        t125b = z10b * y2_2;
        t125bd = z10bd * y2_2 + z10b * y2_2d;
        y17b += t125b * (1.0 / (1.0 + y17 * y17));
        /* its derivative by y */
        y17bd += t125bd * (1.0 / (1.0 + y17 * y17)) - t125b * (1.0 / (1.0 + y17 * y17) * (y17d * y17
            + y17 * y17d) / (1.0 + y17 * y17));
        b5b += y17b * y4_2;
        b5bd += y17bd * y4_2 + y17b * y4_2d;
        y4_2b = y17b * b5;
        y4_2bd = y17bd * b5 + y17b * b5d;
        tb131 = b5b / t124;
        tb131d = (b5bd - tb131 * t124d) * (1.0 / t124);
        y3_2b = tb131;
        y3_2bd = tb131d;
        t124b = -(tb131 * b5);
        t124bd = -(tb131d * b5 + tb131 * b5d);
        y1b += t124b * y0_3;
        /* its derivative by the slip */
        y1bd += t124bd * y0_3 + t124b * y0_3d;
        y0_3b += t124b * y1;
        y0_3bd += t124bd * y1 + t124b * y1d;
        tb128 = b2b * (a2 - p5);
        tb128d = b2bd * (a2 - p5) + b2b * (a2d - p5d);
        tb129 = tb128 * l3;
        tb129d = tb128d * l3 + tb128 * l3d;
        g24b = -(tb129 * l3);
        g24bd = -(tb129d * l3 + tb129 * l3d);
        l3b = -(tb129 * g24);
        l3bd = -(tb129d * g24 + tb129 * g24d);
        l3b += tb128 * (-g24 * l3);
        l3bd += tb128d * (-g24 * l3) + tb128 * (-(g24d * l3) - g24 * l3d);
        tb130 = b2b * (-g24 * l3 * l3);
        tb130d = b2bd * (-g24 * l3 * l3) + b2b * ((-(g24d * l3) - g24 * l3d) * l3 + -g24 * l3 *
            l3d);
        a2b += tb130;
        a2bd += tb130d;
        p5b = -tb130;
        p5bd = -tb130d;
        p3b = v2b * t123;
        p3bd = v2bd * t123 + v2b * t123d;
        t123b = v2b * p3;
        t123bd = v2bd * p3 + v2b * p3d;
        tb127 = t123b / t122;
        tb127d = (t123bd - tb127 * t122d) * (1.0 / t122);
        t122b = -(tb127 * t123);
        t122bd = -(tb127d * t123 + tb127 * t123d);
        t121b = t122b * (1.0 / (2.0 * t122));
        t121bd = t122bd * (1.0 / (2.0 * t122)) - t122b * (1.0 / (2.0 * t122) * (2.0 * t122d) / (2.0
            * t122));
        x8b = t121b * x8;
        x8bd = t121bd * x8 + t121b * x8d;
        x8b += t121b * x8;
        x8bd += t121bd * x8 + t121b * x8d;
        p3b += x8b * a2;
        p3bd += x8bd * a2 + x8b * a2d;
        a2b += x8b * p3;
        a2bd += x8bd * p3 + x8b * p3d;
        p4b = l3b * t120;
        p4bd = l3bd * t120 + l3b * t120d;
        t120b = l3b * p4;
        t120bd = l3bd * p4 + l3b * p4d;
        tb126 = t120b / t119;
        tb126d = (t120bd - tb126 * t119d) * (1.0 / t119);
        t119b = -(tb126 * t120);
        t119bd = -(tb126d * t120 + tb126 * t120d);
        t118b = t119b * (1.0 / (2.0 * t119));
        t118bd = t119bd * (1.0 / (2.0 * t119)) - t119b * (1.0 / (2.0 * t119) * (2.0 * t119d) / (2.0
            * t119));
        x7b = t118b * x7;
        x7bd = t118bd * x7 + t118b * x7d;
        x7b += t118b * x7;
        x7bd += t118bd * x7 + t118b * x7d;
        p4b += x7b * (a2 - p5);
        /* b and the shift of Fy change with a by their cos(atan()) */
        p4bd += x7bd * (a2 - p5) + x7b * (a2d - p5d);
        tb125 = x7b * p4;
        tb125d = x7bd * p4 + x7b * p4d;
        a2b += tb125;
        a2bd += tb125d;
        p5b -= tb125;
        p5bd -= tb125d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] += p5b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] += p5bd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += p4b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += p4bd;
        y0_3b += fyb * t117;
        y0_3bd += fybd * t117 + fyb * t117d;
        t117b = fyb * y0_3;
        t117bd = fybd * y0_3 + fyb * y0_3d;
        y5_2b = fyb;
        y5_2bd = fybd;
        t116b = t117b * cos(t116);
        t116bd = t117bd * cos(t116) - t117b * (sin(t116) * t116d);
        y1b += t116b * t115;
        y1bd += t116bd * t115 + t116b * t115d;
        t115b = t116b * y1;
        t115bd = t116bd * y1 + t116b * y1d;
        t114b = t115b * (1.0 / (1.0 + t114 * t114));
        t114bd = t115bd * (1.0 / (1.0 + t114 * t114)) - t115b * (1.0 / (1.0 + t114 * t114) * (t114d
            * t114 + t114 * t114d) / (1.0 + t114 * t114));
        y2_2b -= t114b * y16;
        y2_2bd -= t114bd * y16 + t114b * y16d;
        y16b = t114b * (1.0 - y2_2);
        y16bd = t114bd * (1.0 - y2_2) - t114b * y2_2d;
        y2_2b += t114b * t113;
        y2_2bd += t114bd * t113 + t114b * t113d;
        t113b = t114b * y2_2;
        t113bd = t114bd * y2_2 + t114b * y2_2d;
        y16b += t113b * (1.0 / (1.0 + y16 * y16));
        y16bd += t113bd * (1.0 / (1.0 + y16 * y16)) - t113b * (1.0 / (1.0 + y16 * y16) * (y16d * y16
            + y16 * y16d) / (1.0 + y16 * y16));
        t112b = y16b * y4_2;
        t112bd = y16bd * y4_2 + y16b * y4_2d;
        y4_2b += y16b * t112;
        y4_2bd += y16bd * t112 + y16b * t112d;
        tb124 = t112b / t111;
        tb124d = (t112bd - tb124 * t111d) * (1.0 / t111);
        y3_2b += tb124;
        y3_2bd += tb124d;
        t111b = -(tb124 * t112);
        t111bd = -(tb124d * t112 + tb124 * t112d);
        y1b += t111b * y0_3;
        y1bd += t111bd * y0_3 + t111b * y0_3d;
        y0_3b += t111b * y1;
        y0_3bd += t111bd * y1 + t111b * y1d;
        x30b += fxb * t110;
        x30bd += fxbd * t110 + fxb * t110d;
        t110b = fxb * x30;
        t110bd = fxbd * x30 + fxb * x30d;
        x35b = fxb;
        x35bd = fxbd;
        t109b = t110b * cos(t109);
        t109bd = t110bd * cos(t109) - t110b * (sin(t109) * t109d);
        x31b += t109b * t108;
        x31bd += t109bd * t108 + t109b * t108d;
        t108b = t109b * x31;
        t108bd = t109bd * x31 + t109b * x31d;
        t107b = t108b * (1.0 / (1.0 + t107 * t107));
        t107bd = t108bd * (1.0 / (1.0 + t107 * t107)) - t108b * (1.0 / (1.0 + t107 * t107) * (t107d
            * t107 + t107 * t107d) / (1.0 + t107 * t107));
        x32b -= t107b * y15;
        x32bd -= t107bd * y15 + t107b * y15d;
        y15b = t107b * (1.0 - x32);
        y15bd = t107bd * (1.0 - x32) - t107b * x32d;
        x32b += t107b * t106;
        x32bd += t107bd * t106 + t107b * t106d;
        t106b = t107b * x32;
        t106bd = t107bd * x32 + t107b * x32d;
        y15b += t106b * (1.0 / (1.0 + y15 * y15));
        y15bd += t106bd * (1.0 / (1.0 + y15 * y15)) - t106b * (1.0 / (1.0 + y15 * y15) * (y15d * y15
            + y15 * y15d) / (1.0 + y15 * y15));
        t105b = y15b * x34;
        t105bd = y15bd * x34 + y15b * x34d;
        x34b += y15b * t105;
        x34bd += y15bd * t105 + y15b * t105d;
        tb123 = t105b / t104;
        tb123d = (t105bd - tb123 * t104d) * (1.0 / t104);
        x33b += tb123;
        x33bd += tb123d;
        t104b = -(tb123 * t105);
        t104bd = -(tb123d * t105 + tb123 * t105d);
        x31b += t104b * x30;
        x31bd += t104bd * x30 + t104b * x30d;
        x30b += t104b * x31;
        x30bd += t104bd * x31 + t104b * x31d;
        s3b = wy1b * (kappa + shift2);
        s3bd = wy1bd * (kappa + shift2) + wy1b * (kappad + shift2d);
        tb121 = wy1b * s3;
        tb121d = wy1bd * s3 + wy1b * s3d;
        kappab += tb121;
        kappabd += tb121d;
        shift2b = tb121;
        shift2bd = tb121d;
        tb122 = wy1b * shift2;
        tb122d = wy1bd * shift2 + wy1b * shift2d;
        t99b = tb122 * t103;
        t99bd = tb122d * t103 + tb122 * t103d;
        t103b = tb122 * t99;
        t103bd = tb122d * t99 + tb122 * t99d;
        shift2b += wy1b * (t99 * t103);
        shift2bd += wy1bd * (t99 * t103) + wy1b * (t99d * t103 + t99 * t103d);
        tb119 = t103b / t102;
        tb119d = (t103bd - tb119 * t102d) * (1.0 / t102);
        c4b = tb119 * (1.0 - e12 + t101);
        c4bd = tb119d * (1.0 - e12 + t101) + tb119 * (-e12d + t101d);
        tb120 = tb119 * c4;
        tb120d = tb119d * c4 + tb119 * c4d;
        e12b = -tb120;
        e12bd = -tb120d;
        t101b = tb120;
        t101bd = tb120d;
        t102b = -(tb119 * t103);
        t102bd = -(tb119d * t103 + tb119 * t103d);
        z9b = t102b * z9;
        z9bd = t102bd * z9 + t102b * z9d;
        z9b += t102b * z9;
        z9bd += t102bd * z9 + t102b * z9d;
        tb118 = t101b / t100;
        tb118d = (t101bd - tb118 * t100d) * (1.0 / t100);
        e12b += tb118;
        e12bd += tb118d;
        t100b = -(tb118 * t101);
        t100bd = -(tb118d * t101 + tb118 * t101d);
        y0_2b = t100b * y0_2;
        y0_2bd = t100bd * y0_2 + t100b * y0_2d;
        y0_2b += t100b * y0_2;
        y0_2bd += t100bd * y0_2 + t100b * y0_2d;
        tb117 = t99b / t98;
        tb117d = (t99bd - tb117 * t98d) * (1.0 / t98);
        t96b = tb117 * t97;
        t96bd = tb117d * t97 + tb117 * t97d;
        t97b = tb117 * t96;
        t97bd = tb117d * t96 + tb117 * t96d;
        t98b = -(tb117 * t99);
        t98bd = -(tb117d * t99 + tb117 * t99d);
        n6b = t98b * n6;
        n6bd = t98bd * n6 + t98b * n6d;
        n6b += t98b * n6;
        n6bd += t98bd * n6 + t98b * n6d;
        z0_2b = t97b * cos(z0_2);
        z0_2bd = t97bd * cos(z0_2) - t97b * (sin(z0_2) * z0_2d);
        z7b = -(t96b * sin(z7));
        z7bd = -(t96bd * sin(z7) + t96b * (cos(z7) * z7d));
        e12b -= z9b * y0_2;
        e12bd -= z9bd * y0_2 + z9b * y0_2d;
        y0_2b += z9b * (1.0 - e12);
        y0_2bd += z9bd * (1.0 - e12) - z9b * e12d;
        e12b += z9b * t95;
        e12bd += z9bd * t95 + z9b * t95d;
        t95b = z9b * e12;
        t95bd = z9bd * e12 + z9b * e12d;
        y0_2b += t95b * (1.0 / (1.0 + y0_2 * y0_2));
        /* its derivative by y */
        y0_2bd += t95bd * (1.0 / (1.0 + y0_2 * y0_2)) - t95b * (1.0 / (1.0 + y0_2 * y0_2) * (y0_2d *
            y0_2 + y0_2 * y0_2d) / (1.0 + y0_2 * y0_2));
        tb116 = s3b / n6;
        tb116d = (s3bd - tb116 * n6d) * (1.0 / n6);
        t90b = -(tb116 * t94);
        t90bd = -(tb116d * t94 + tb116 * t94d);
        t94b = -(tb116 * t90);
        t94bd = -(tb116d * t90 + tb116 * t90d);
        n6b -= tb116 * s3;
        n6bd -= tb116d * s3 + tb116 * s3d;
        tb114 = t94b / t93;
        tb114d = (t94bd - tb114 * t93d) * (1.0 / t93);
        c4b += tb114 * (1.0 - e12 + t92);
        c4bd += tb114d * (1.0 - e12 + t92) + tb114 * (-e12d + t92d);
        tb115 = tb114 * c4;
        tb115d = tb114d * c4 + tb114 * c4d;
        e12b -= tb115;
        e12bd -= tb115d;
        t92b = tb115;
        t92bd = tb115d;
        t93b = -(tb114 * t94);
        t93bd = -(tb114d * t94 + tb114 * t94d);
        z8b = t93b * z8;
        z8bd = t93bd * z8 + t93b * z8d;
        z8b += t93b * z8;
        z8bd += t93bd * z8 + t93b * z8d;
        tb113 = t92b / t91;
        tb113d = (t92bd - tb113 * t91d) * (1.0 / t91);
        e12b += tb113;
        e12bd += tb113d;
        t91b = -(tb113 * t92);
        t91bd = -(tb113d * t92 + tb113 * t92d);
        y14b = t91b * y14;
        y14bd = t91bd * y14 + t91b * y14d;
        y14b += t91b * y14;
        y14bd += t91bd * y14 + t91b * y14d;
        z7b += t90b * cos(z7);
        z7bd += t90bd * cos(z7) - t90b * (sin(z7) * z7d);
        e12b -= z8b * y14;
        e12bd -= z8bd * y14 + z8b * y14d;
        y14b += z8b * (1.0 - e12);
        y14bd += z8bd * (1.0 - e12) - z8b * e12d;
        e12b += z8b * t89;
        e12bd += z8bd * t89 + z8b * t89d;
        t89b = z8b * e12;
        t89bd = z8bd * e12 + z8b * e12d;
        y14b += t89b * (1.0 / (1.0 + y14 * y14));
        /* its derivative by y */
        y14bd += t89bd * (1.0 / (1.0 + y14 * y14)) - t89b * (1.0 / (1.0 + y14 * y14) * (y14d * y14 +
            y14 * y14d) / (1.0 + y14 * y14));
        z0_2b -= n6b * sin(z0_2);
        z0_2bd -= n6bd * sin(z0_2) + n6b * (cos(z0_2) * z0_2d);
        c4b += z0_2b * t88;
        c4bd += z0_2bd * t88 + z0_2b * t88d;
        t88b = z0_2b * c4;
        t88bd = z0_2bd * c4 + z0_2b * c4d;
        t87b = t88b * (1.0 / (1.0 + t87 * t87));
        t87bd = t88bd * (1.0 / (1.0 + t87 * t87)) - t88b * (1.0 / (1.0 + t87 * t87) * (t87d * t87 +
            t87 * t87d) / (1.0 + t87 * t87));
        e12b -= t87b * y0_2;
        e12bd -= t87bd * y0_2 + t87b * y0_2d;
        y0_2b += t87b * (1.0 - e12);
        y0_2bd += t87bd * (1.0 - e12) - t87b * e12d;
        e12b += t87b * t86;
        e12bd += t87bd * t86 + t87b * t86d;
        t86b = t87b * e12;
        t86bd = t87bd * e12 + t87b * e12d;
        y0_2b += t86b * (1.0 / (1.0 + y0_2 * y0_2));
        y0_2bd += t86bd * (1.0 / (1.0 + y0_2 * y0_2)) - t86b * (1.0 / (1.0 + y0_2 * y0_2) * (y0_2d *
            y0_2 + y0_2 * y0_2d) / (1.0 + y0_2 * y0_2));
        c4b += z7b * t85;
        c4bd += z7bd * t85 + z7b * t85d;
        t85b = z7b * c4;
        t85bd = z7bd * c4 + z7b * c4d;
        t84b = t85b * (1.0 / (1.0 + t84 * t84));
        t84bd = t85bd * (1.0 / (1.0 + t84 * t84)) - t85b * (1.0 / (1.0 + t84 * t84) * (t84d * t84 +
            t84 * t84d) / (1.0 + t84 * t84));
        e12b -= t84b * y14;
        e12bd -= t84bd * y14 + t84b * y14d;
        y14b += t84b * (1.0 - e12);
        y14bd += t84bd * (1.0 - e12) - t84b * e12d;
        e12b += t84b * t83;
        e12bd += t84bd * t83 + t84b * t83d;
        t83b = t84b * e12;
        t83bd = t84bd * e12 + t84b * e12d;
        y14b += t83b * (1.0 / (1.0 + y14 * y14));
        y14bd += t83bd * (1.0 / (1.0 + y14 * y14)) - t83b * (1.0 / (1.0 + y14 * y14) * (y14d * y14 +
            y14 * y14d) / (1.0 + y14 * y14));
        b4b = y0_2b * shift2;
        b4bd = y0_2bd * shift2 + y0_2b * shift2d;
        shift2b += y0_2b * b4;
        shift2bd += y0_2bd * b4 + y0_2b * b4d;
        b4b += y14b * (kappa + shift2);
        /* its derivatives by x and by b */
        b4bd += y14bd * (kappa + shift2) + y14b * (kappad + shift2d);
        tb112 = y14b * b4;
        tb112d = y14bd * b4 + y14b * b4d;
        kappab += tb112;
        kappabd += tb112d;
        shift2b += tb112;
        shift2bd += tb112d;
        g27b = shift2b;
        g27bd = shift2bd;
        g26b = e12b;
        g26bd = e12bd;
        g25b = c4b;
        g25bd = c4bd;
        g24b += b4b;
        g24bd += b4bd;
        s2b = wx1b * (a2 + shift);
        s2bd = wx1bd * (a2 + shift) + wx1b * (a2d + shiftd);
        tb110 = wx1b * s2;
        tb110d = wx1bd * s2 + wx1b * s2d;
        a2b += tb110;
        a2bd += tb110d;
        shiftb = tb110;
        shiftbd = tb110d;
        tb111 = wx1b * shift;
        tb111d = wx1bd * shift + wx1b * shiftd;
        t78b = tb111 * t82;
        t78bd = tb111d * t82 + tb111 * t82d;
        t82b = tb111 * t78;
        t82bd = tb111d * t78 + tb111 * t78d;
        shiftb += wx1b * (t78 * t82);
        shiftbd += wx1bd * (t78 * t82) + wx1b * (t78d * t82 + t78 * t82d);
        tb108 = t82b / t81;
        tb108d = (t82bd - tb108 * t81d) * (1.0 / t81);
        c3b = tb108 * (1.0 - e11 + t80);
        c3bd = tb108d * (1.0 - e11 + t80) + tb108 * (-e11d + t80d);
        tb109 = tb108 * c3;
        tb109d = tb108d * c3 + tb108 * c3d;
        e11b = -tb109;
        e11bd = -tb109d;
        t80b = tb109;
        t80bd = tb109d;
        t81b = -(tb108 * t82);
        t81bd = -(tb108d * t82 + tb108 * t82d);
        z6b = t81b * z6;
        z6bd = t81bd * z6 + t81b * z6d;
        z6b += t81b * z6;
        z6bd += t81bd * z6 + t81b * z6d;
        tb107 = t80b / t79;
        tb107d = (t80bd - tb107 * t79d) * (1.0 / t79);
        e11b += tb107;
        e11bd += tb107d;
        t79b = -(tb107 * t80);
        t79bd = -(tb107d * t80 + tb107 * t80d);
        y0b = t79b * y0;
        y0bd = t79bd * y0 + t79b * y0d;
        y0b += t79b * y0;
        y0bd += t79bd * y0 + t79b * y0d;
        tb106 = t78b / t77;
        tb106d = (t78bd - tb106 * t77d) * (1.0 / t77);
        t75b = tb106 * t76;
        t75bd = tb106d * t76 + tb106 * t76d;
        t76b = tb106 * t75;
        t76bd = tb106d * t75 + tb106 * t75d;
        t77b = -(tb106 * t78);
        t77bd = -(tb106d * t78 + tb106 * t78d);
        n5b = t77b * n5;
        n5bd = t77bd * n5 + t77b * n5d;
        n5b += t77b * n5;
        n5bd += t77bd * n5 + t77b * n5d;
        z0b = t76b * cos(z0);
        z0bd = t76bd * cos(z0) - t76b * (sin(z0) * z0d);
        z4b = -(t75b * sin(z4));
        z4bd = -(t75bd * sin(z4) + t75b * (cos(z4) * z4d));
        e11b -= z6b * y0;
        e11bd -= z6bd * y0 + z6b * y0d;
        y0b += z6b * (1.0 - e11);
        y0bd += z6bd * (1.0 - e11) - z6b * e11d;
        e11b += z6b * t74;
        e11bd += z6bd * t74 + z6b * t74d;
        t74b = z6b * e11;
        t74bd = z6bd * e11 + z6b * e11d;
        y0b += t74b * (1.0 / (1.0 + y0 * y0));
        /* its derivative by y */
        y0bd += t74bd * (1.0 / (1.0 + y0 * y0)) - t74b * (1.0 / (1.0 + y0 * y0) * (y0d * y0 + y0 *
            y0d) / (1.0 + y0 * y0));
        tb105 = s2b / n5;
        tb105d = (s2bd - tb105 * n5d) * (1.0 / n5);
        t69b = -(tb105 * t73);
        t69bd = -(tb105d * t73 + tb105 * t73d);
        t73b = -(tb105 * t69);
        t73bd = -(tb105d * t69 + tb105 * t69d);
        n5b -= tb105 * s2;
        n5bd -= tb105d * s2 + tb105 * s2d;
        tb103 = t73b / t72;
        tb103d = (t73bd - tb103 * t72d) * (1.0 / t72);
        c3b += tb103 * (1.0 - e11 + t71);
        c3bd += tb103d * (1.0 - e11 + t71) + tb103 * (-e11d + t71d);
        tb104 = tb103 * c3;
        tb104d = tb103d * c3 + tb103 * c3d;
        e11b -= tb104;
        e11bd -= tb104d;
        t71b = tb104;
        t71bd = tb104d;
        t72b = -(tb103 * t73);
        t72bd = -(tb103d * t73 + tb103 * t73d);
        z5b = t72b * z5;
        z5bd = t72bd * z5 + t72b * z5d;
        z5b += t72b * z5;
        z5bd += t72bd * z5 + t72b * z5d;
        tb102 = t71b / t70;
        tb102d = (t71bd - tb102 * t70d) * (1.0 / t70);
        e11b += tb102;
        e11bd += tb102d;
        t70b = -(tb102 * t71);
        t70bd = -(tb102d * t71 + tb102 * t71d);
        y13b = t70b * y13;
        y13bd = t70bd * y13 + t70b * y13d;
        y13b += t70b * y13;
        y13bd += t70bd * y13 + t70b * y13d;
        z4b += t69b * cos(z4);
        z4bd += t69bd * cos(z4) - t69b * (sin(z4) * z4d);
        e11b -= z5b * y13;
        e11bd -= z5bd * y13 + z5b * y13d;
        y13b += z5b * (1.0 - e11);
        y13bd += z5bd * (1.0 - e11) - z5b * e11d;
        e11b += z5b * t68;
        e11bd += z5bd * t68 + z5b * t68d;
        t68b = z5b * e11;
        t68bd = z5bd * e11 + z5b * e11d;
        y13b += t68b * (1.0 / (1.0 + y13 * y13));
        /* its derivative by y */
        y13bd += t68bd * (1.0 / (1.0 + y13 * y13)) - t68b * (1.0 / (1.0 + y13 * y13) * (y13d * y13 +
            y13 * y13d) / (1.0 + y13 * y13));
        z0b -= n5b * sin(z0);
        z0bd -= n5bd * sin(z0) + n5b * (cos(z0) * z0d);
        c3b += z0b * t67;
        c3bd += z0bd * t67 + z0b * t67d;
        t67b = z0b * c3;
        t67bd = z0bd * c3 + z0b * c3d;
        t66b = t67b * (1.0 / (1.0 + t66 * t66));
        t66bd = t67bd * (1.0 / (1.0 + t66 * t66)) - t67b * (1.0 / (1.0 + t66 * t66) * (t66d * t66 +
            t66 * t66d) / (1.0 + t66 * t66));
        e11b -= t66b * y0;
        e11bd -= t66bd * y0 + t66b * y0d;
        y0b += t66b * (1.0 - e11);
        y0bd += t66bd * (1.0 - e11) - t66b * e11d;
        e11b += t66b * t65;
        e11bd += t66bd * t65 + t66b * t65d;
        t65b = t66b * e11;
        t65bd = t66bd * e11 + t66b * e11d;
        y0b += t65b * (1.0 / (1.0 + y0 * y0));
        y0bd += t65bd * (1.0 / (1.0 + y0 * y0)) - t65b * (1.0 / (1.0 + y0 * y0) * (y0d * y0 + y0 *
            y0d) / (1.0 + y0 * y0));
        c3b += z4b * t64;
        c3bd += z4bd * t64 + z4b * t64d;
        t64b = z4b * c3;
        t64bd = z4bd * c3 + z4b * c3d;
        t63b = t64b * (1.0 / (1.0 + t63 * t63));
        t63bd = t64bd * (1.0 / (1.0 + t63 * t63)) - t64b * (1.0 / (1.0 + t63 * t63) * (t63d * t63 +
            t63 * t63d) / (1.0 + t63 * t63));
        e11b -= t63b * y13;
        e11bd -= t63bd * y13 + t63b * y13d;
        y13b += t63b * (1.0 - e11);
        y13bd += t63bd * (1.0 - e11) - t63b * e11d;
        e11b += t63b * t62;
        e11bd += t63bd * t62 + t63b * t62d;
        t62b = t63b * e11;
        t62bd = t63bd * e11 + t63b * e11d;
        y13b += t62b * (1.0 / (1.0 + y13 * y13));
        y13bd += t62bd * (1.0 / (1.0 + y13 * y13)) - t62b * (1.0 / (1.0 + y13 * y13) * (y13d * y13 +
            y13 * y13d) / (1.0 + y13 * y13));
        b3b = y0b * shift;
        b3bd = y0bd * shift + y0b * shiftd;
        shiftb += y0b * b3;
        shiftbd += y0bd * b3 + y0b * b3d;
        b3b += y13b * (a2 + shift);
        /* its derivatives by x and by b */
        b3bd += y13bd * (a2 + shift) + y13b * (a2d + shiftd);
        tb101 = y13b * b3;
        tb101d = y13bd * b3 + y13b * b3d;
        a2b += tb101;
        a2bd += tb101d;
        shiftb += tb101;
        shiftbd += tb101d;
        g23b = shiftb;
        g23bd = shiftbd;
        g22b = e11b;
        g22bd = e11bd;
        g21b = c3b;
        g21bd = c3bd;
        g20b += b3b;
        g20bd += b3bd;
        tb100 = gyb / t61;
        tb100d = (gybd - tb100 * t61d) * (1.0 / t61);
        t56b = tb100;
        t56bd = tb100d;
        t61b = -(tb100 * gy);
        t61bd = -(tb100d * gy + tb100 * gyd);
        t60b = -(t61b * sin(t60));
        t60bd = -(t61bd * sin(t60) + t61b * (cos(t60) * t60d));
        g25b += t60b * t59;
        g25bd += t60bd * t59 + t60b * t59d;
        t59b = t60b * g25;
        t59bd = t60bd * g25 + t60b * g25d;
        t58b = t59b * (1.0 / (1.0 + t58 * t58));
        t58bd = t59bd * (1.0 / (1.0 + t58 * t58)) - t59b * (1.0 / (1.0 + t58 * t58) * (t58d * t58 +
            t58 * t58d) / (1.0 + t58 * t58));
        g26b -= t58b * y12;
        g26bd -= t58bd * y12 + t58b * y12d;
        y12b = t58b * (1.0 - g26);
        y12bd = t58bd * (1.0 - g26) - t58b * g26d;
        g26b += t58b * t57;
        g26bd += t58bd * t57 + t58b * t57d;
        t57b = t58b * g26;
        t57bd = t58bd * g26 + t58b * g26d;
        y12b += t57b * (1.0 / (1.0 + y12 * y12));
        y12bd += t57bd * (1.0 / (1.0 + y12 * y12)) - t57b * (1.0 / (1.0 + y12 * y12) * (y12d * y12 +
            y12 * y12d) / (1.0 + y12 * y12));
        t55b = -(t56b * sin(t55));
        t55bd = -(t56bd * sin(t55) + t56b * (cos(t55) * t55d));
        g25b += t55b * t54;
        g25bd += t55bd * t54 + t55b * t54d;
        t54b = t55b * g25;
        t54bd = t55bd * g25 + t55b * g25d;
        t53b = t54b * (1.0 / (1.0 + t53 * t53));
        t53bd = t54bd * (1.0 / (1.0 + t53 * t53)) - t54b * (1.0 / (1.0 + t53 * t53) * (t53d * t53 +
            t53 * t53d) / (1.0 + t53 * t53));
        g26b -= t53b * y11;
        g26bd -= t53bd * y11 + t53b * y11d;
        y11b = t53b * (1.0 - g26);
        y11bd = t53bd * (1.0 - g26) - t53b * g26d;
        g26b += t53b * t52;
        g26bd += t53bd * t52 + t53b * t52d;
        t52b = t53b * g26;
        t52bd = t53bd * g26 + t53b * g26d;
        y11b += t52b * (1.0 / (1.0 + y11 * y11));
        y11bd += t52bd * (1.0 / (1.0 + y11 * y11)) - t52b * (1.0 / (1.0 + y11 * y11) * (y11d * y11 +
            y11 * y11d) / (1.0 + y11 * y11));
        g24b += y12b * g27;
        g24bd += y12bd * g27 + y12b * g27d;
        g27b += y12b * g24;
        g27bd += y12bd * g24 + y12b * g24d;
        g24b += y11b * (kappa + g27);
        g24bd += y11bd * (kappa + g27) + y11b * (kappad + g27d);
        tb99 = y11b * g24;
        tb99d = y11bd * g24 + y11b * g24d;
        kappab += tb99;
        kappabd += tb99d;
        g27b += tb99;
        g27bd += tb99d;
        tb98 = gxb / t51;
        tb98d = (gxbd - tb98 * t51d) * (1.0 / t51);
        t46b = tb98;
        t46bd = tb98d;
        t51b = -(tb98 * gx);
        t51bd = -(tb98d * gx + tb98 * gxd);
        t50b = -(t51b * sin(t50));
        t50bd = -(t51bd * sin(t50) + t51b * (cos(t50) * t50d));
        g21b += t50b * t49;
        g21bd += t50bd * t49 + t50b * t49d;
        t49b = t50b * g21;
        t49bd = t50bd * g21 + t50b * g21d;
        t48b = t49b * (1.0 / (1.0 + t48 * t48));
        t48bd = t49bd * (1.0 / (1.0 + t48 * t48)) - t49b * (1.0 / (1.0 + t48 * t48) * (t48d * t48 +
            t48 * t48d) / (1.0 + t48 * t48));
        g22b -= t48b * y10;
        g22bd -= t48bd * y10 + t48b * y10d;
        y10b = t48b * (1.0 - g22);
        y10bd = t48bd * (1.0 - g22) - t48b * g22d;
        g22b += t48b * t47;
        g22bd += t48bd * t47 + t48b * t47d;
        t47b = t48b * g22;
        t47bd = t48bd * g22 + t48b * g22d;
        y10b += t47b * (1.0 / (1.0 + y10 * y10));
        y10bd += t47bd * (1.0 / (1.0 + y10 * y10)) - t47b * (1.0 / (1.0 + y10 * y10) * (y10d * y10 +
            y10 * y10d) / (1.0 + y10 * y10));
        t45b = -(t46b * sin(t45));
        t45bd = -(t46bd * sin(t45) + t46b * (cos(t45) * t45d));
        g21b += t45b * t44;
        g21bd += t45bd * t44 + t45b * t44d;
        t44b = t45b * g21;
        t44bd = t45bd * g21 + t45b * g21d;
        t43b = t44b * (1.0 / (1.0 + t43 * t43));
        t43bd = t44bd * (1.0 / (1.0 + t43 * t43)) - t44b * (1.0 / (1.0 + t43 * t43) * (t43d * t43 +
            t43 * t43d) / (1.0 + t43 * t43));
        g22b -= t43b * y9;
        g22bd -= t43bd * y9 + t43b * y9d;
        y9b = t43b * (1.0 - g22);
        y9bd = t43bd * (1.0 - g22) - t43b * g22d;
        g22b += t43b * t42;
        g22bd += t43bd * t42 + t43b * t42d;
        t42b = t43b * g22;
        t42bd = t43bd * g22 + t43b * g22d;
        y9b += t42b * (1.0 / (1.0 + y9 * y9));
        y9bd += t42bd * (1.0 / (1.0 + y9 * y9)) - t42b * (1.0 / (1.0 + y9 * y9) * (y9d * y9 + y9 *
            y9d) / (1.0 + y9 * y9));
        g20b += y10b * g23;
        g20bd += y10bd * g23 + y10b * g23d;
        g23b += y10b * g20;
        g23bd += y10bd * g20 + y10b * g20d;
        g20b += y9b * (a2 + g23);
        g20bd += y9bd * (a2 + g23) + y9b * (a2d + g23d);
        tb97 = y9b * g20;
        tb97d = y9bd * g20 + y9b * g20d;
        a2b += tb97;
        a2bd += tb97d;
        g23b += tb97;
        g23bd += tb97d;
        tb96 = g28b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        tb96d = g28bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + g28b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        dvb = tb96 * t41;
        dvbd = tb96d * t41 + tb96 * t41d;
        t41b = tb96 * dv;
        t41bd = tb96d * dv + tb96 * dvd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g28b * (dv * t41);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g28bd * (dv * t41) + g28b * (dvd *
            t41 + dv * t41d);
        t40b = t41b * cos(t40);
        t40bd = t41bd * cos(t40) - t41b * (sin(t40) * t40d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t40b * t39;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t40bd * t39 + t40b * t39d;
        t39b = t40b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
        t39bd = t40bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] + t40b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
        t38b = t39b * (1.0 / (1.0 + t38 * t38));
        t38bd = t39bd * (1.0 / (1.0 + t38 * t38)) - t39b * (1.0 / (1.0 + t38 * t38) * (t38d * t38 +
            t38 * t38d) / (1.0 + t38 * t38));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t38b * kappa;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t38bd * kappa + t38b * kappad;
        kappab += t38b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
        kappabd += t38bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] + t38b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
        tb94 = dvb * t37;
        tb94d = dvbd * t37 + dvb * t37d;
        peakb = tb94 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma);
        peakbd = tb94d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) + tb94 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1]
            + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gammad));
        tb95 = tb94 * peak;
        tb95d = tb94d * peak + tb94 * peakd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb95;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb95d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb95 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb95d * dfz + tb95 * dfzd;
        dfzb = tb95 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
        dfzbd = tb95d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] + tb95 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb95 * gamma;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb95d * gamma + tb95 * gammad;
        gammab = tb95 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
        gammabd = tb95d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] + tb95 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
        t37b = dvb * (peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma));
        t37bd = dvbd * (peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma)) + dvb * (peakd * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma) + peak *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gammad)));
        tb93 = t37b / t36;
        tb93d = (t37bd - tb93 * t36d) * (1.0 / t36);
        t36b = -(tb93 * t37);
        t36bd = -(tb93d * t37 + tb93 * t37d);
        t35b = t36b * (1.0 / (2.0 * t36));
        t35bd = t36bd * (1.0 / (2.0 * t36)) - t36b * (1.0 / (2.0 * t36) * (2.0 * t36d) / (2.0 *
            t36));
        x6b = t35b * x6;
        x6bd = t35bd * x6 + t35b * x6d;
        x6b += t35b * x6;
        x6bd += t35bd * x6 + t35b * x6d;
        p3b += x6b * a2;
        p3bd += x6bd * a2 + x6b * a2d;
        a2b += x6b * p3;
        a2bd += x6bd * p3 + x6b * p3d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] += p3b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] += p3bd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] += g27b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] += g27bd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] += g27b * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] += g27bd * dfz + g27b * dfzd;
        dfzb += g27b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2];
        dfzbd += g27bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] + g27b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2];
        y8b = g26b;
        y8bd = g26bd;
        e10b = 0.0;
        e10bd = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e10) > 1.0) {
          y8b = 0.0;
          y8bd = 0.0;
        } else {
          e10b += y8b;
          e10bd += y8bd;
          y8b = 0.0;
          y8bd = 0.0;
        }
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] += e10b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] += e10bd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] += e10b * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] += e10bd * dfz + e10b * dfzd;
        dfzb += e10b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2];
        dfzbd += e10bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] + e10b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += g25b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += g25bd;
        tb92 = g24b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        tb92d = g24bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + g24b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb92 * t34;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb92d * t34 + tb92 * t34d;
        t34b = tb92 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
        t34bd = tb92d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] + tb92 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += g24b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RBY1] * t34);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += g24bd *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34) + g24b *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34d);
        tb91 = t34b / t33;
        tb91d = (t34bd - tb91 * t33d) * (1.0 / t33);
        t33b = -(tb91 * t34);
        t33bd = -(tb91d * t34 + tb91 * t34d);
        t32b = t33b * (1.0 / (2.0 * t33));
        t32bd = t33bd * (1.0 / (2.0 * t33)) - t33b * (1.0 / (2.0 * t33) * (2.0 * t33d) / (2.0 *
            t33));
        x5b = t32b * x5;
        x5bd = t32bd * x5 + t32b * x5d;
        x5b += t32b * x5;
        x5bd += t32bd * x5 + t32b * x5d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x5b * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x5bd * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + x5b * (a2d -
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        tb90 = x5b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        tb90d = x5bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] + x5b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        a2b += tb90;
        a2bd += tb90d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb90;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb90d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1] += g23b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1] += g23bd;
        y7b = g22b;
        y7bd = g22bd;
        e9b = 0.0;
        e9bd = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e9) > 1.0) {
          y7b = 0.0;
          y7bd = 0.0;
        } else {
          e9b += y7b;
          e9bd += y7bd;
          y7b = 0.0;
          y7bd = 0.0;
        }
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] += e9b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] += e9bd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] += e9b * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] += e9bd * dfz + e9b * dfzd;
        dfzb += e9b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2];
        dfzbd += e9bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] + e9b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += g21b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += g21bd;
        tb89 = g20b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        tb89d = g20bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + g20b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb89 * t31;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb89d * t31 + tb89 * t31d;
        t31b = tb89 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
        t31bd = tb89d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] + tb89 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += g20b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RBX1] * t31);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += g20bd *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31) + g20b *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31d);
        tb88 = t31b / t30;
        tb88d = (t31bd - tb88 * t30d) * (1.0 / t30);
        t30b = -(tb88 * t31);
        t30bd = -(tb88d * t31 + tb88 * t31d);
        t29b = t30b * (1.0 / (2.0 * t30));
        t29bd = t30bd * (1.0 / (2.0 * t30)) - t30b * (1.0 / (2.0 * t30) * (2.0 * t30d) / (2.0 *
            t30));
        x4b = t29b * x4;
        x4bd = t29bd * x4 + t29b * x4d;
        x4b += t29b * x4;
        x4bd += t29bd * x4 + t29b * x4d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x4b * kappa;
        /* what combined slip makes of the forces:  Fx = Gxa Fx0, Fy = Gyk Fy0 + SVyk.  g: b, c, e, shift of Gxa,
         * then of Gyk, SVyk */
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x4bd * kappa + x4b * kappad;
        kappab += x4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        kappabd += x4bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] + x4b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        y0_3b += peakb;
        y0_3bd += peakbd;
        tb84 = y5_2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        tb84d = y5_2bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + y5_2b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        fzb = tb84 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2);
        fzbd = tb84d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) +
            tb84 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd)) * gy2 +
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY4] * dfz) * gy2d));
        tb85 = tb84 * fz;
        tb85d = tb84d * fz + tb84 * fzd;
        tb86 = tb85 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
        tb86d = tb85d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + tb85 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb86;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb86d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb86 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb86d * dfz + tb86 * dfzd;
        dfzb += tb86 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
        dfzbd += tb86d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] + tb86 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb85 * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb85d *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY2] * dfz) + tb85 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd));
        tb87 = tb85 * gy2;
        tb87d = tb85d * gy2 + tb85 * gy2d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb87;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb87d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb87 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb87d * dfz + tb87 * dfzd;
        dfzb += tb87 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
        dfzbd += tb87d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] + tb87 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
        gy2b = tb85 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz);
        gy2bd = tb85d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) + tb85 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY4] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += y5_2b * (fz *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY4] * dfz) * gy2));
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += y5_2bd * (fz *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY4] * dfz) * gy2)) + y5_2b * (fzd * ((p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) + fz
            * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd)) * gy2 +
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY4] * dfz) * gy2d)));
        ayb = y4_2b;
        aybd = y4_2bd;
        tb80 = y3_2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
        tb80d = y3_2bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + y3_2b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
        tb81 = tb80 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6);
        tb81d = tb80d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) - tb80 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6d);
        tb82 = tb81 * t28;
        tb82d = tb81d * t28 + tb81 * t28d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb82 * fz0_2;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb82d * fz0_2 + tb82 * fz0_2d;
        fz0_2b = tb82 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
        fz0_2bd = tb82d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] + tb82 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
        t28b = tb81 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2);
        t28bd = tb81d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2) + tb81 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d);
        tb83 = tb80 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28);
        tb83d = tb80d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28) + tb80 *
            ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d) * t28 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb83 * y6;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb83d * y6 + tb83 * y6d;
        y6b = -(tb83 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
        y6bd = -(tb83d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] + tb83 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += y3_2b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKY1] * fz0_2 * t28 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKY3] * y6));
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += y3_2bd *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28 * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6)) + y3_2b *
            (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d) * t28 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) - p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKY1] * fz0_2 * t28 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] *
            y6 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6d));
        tb79 = t28b / t27;
        tb79d = (t28bd - tb79 * t27d) * (1.0 / t27);
        z2b = tb79 * 2.0;
        z2bd = tb79d * 2.0;
        t27b = -(tb79 * t28);
        t27bd = -(tb79d * t28 + tb79 * t28d);
        z2b += t27b * z2;
        z2bd += t27bd * z2 + t27b * z2d;
        z2b += t27b * z2;
        z2bd += t27bd * z2 + t27b * z2d;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gy2) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
          gy2b += y6b;
          gy2bd += y6bd;
          y6b = 0.0;
          y6bd = 0.0;
        } else if (MAGGI_RE(gy2) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LOW_CAMBER])) {
          gy2b -= y6b;
          gy2bd -= y6bd;
          y6b = 0.0;
          y6bd = 0.0;
        } else {
          p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
          p2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
          t26 = p2 * p2;
          t26d = p2d * p2 + p2 * p2d;
          z3 = gy2 * gy2 / t26;
          z3d = (gy2d * gy2 + gy2 * gy2d - z3 * t26d) * (1.0 / t26);
          tb77 = y6b * (15.0 + z3 * (-10.0 + 3.0 * z3));
          tb77d = y6bd * (15.0 + z3 * (-10.0 + 3.0 * z3)) + y6b * (z3d * (-10.0 + 3.0 * z3) + z3 *
              (3.0 * z3d));
          p2b = tb77 * z3 * 0.125;
          p2bd = (tb77d * z3 + tb77 * z3d) * 0.125;
          z3b = tb77 * (0.125 * p2);
          z3bd = tb77d * (0.125 * p2) + tb77 * (0.125 * p2d);
          tb78 = y6b * (0.125 * p2 * z3);
          tb78d = y6bd * (0.125 * p2 * z3) + y6b * (0.125 * p2d * z3 + 0.125 * p2 * z3d);
          z3b += tb78 * (-10.0 + 3.0 * z3);
          z3bd += tb78d * (-10.0 + 3.0 * z3) + tb78 * (3.0 * z3d);
          z3b += tb78 * z3 * 3.0;
          z3bd += (tb78d * z3 + tb78 * z3d) * 3.0;
          y6b = 0.0;
          y6bd = 0.0;
          tb76 = z3b / t26;
          tb76d = (z3bd - tb76 * t26d) * (1.0 / t26);
          gy2b += tb76 * gy2;
          gy2bd += tb76d * gy2 + tb76 * gy2d;
          gy2b += tb76 * gy2;
          gy2bd += tb76d * gy2 + tb76 * gy2d;
          t26b = -(tb76 * z3);
          t26bd = -(tb76d * z3 + tb76 * z3d);
          p2b += t26b * p2;
          p2bd += t26bd * p2 + t26b * p2d;
          p2b += t26b * p2;
          p2bd += t26bd * p2 + t26b * p2d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p2b;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p2bd;
        }
        eyb = y2_2b;
        eybd = y2_2bd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] += y1b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCY];
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] += y1bd * p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_LCY] + y1b * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY] += y1b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PCY1];
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY] += y1bd * p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PCY1] + y1b * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1];
        muyb = y0_3b * fz;
        muybd = y0_3bd * fz + y0_3b * fzd;
        fzb += y0_3b * muy;
        fzbd += y0_3bd * muy + y0_3b * muyd;
        tb75 = z2b / t25;
        tb75d = (z2bd - tb75 * t25d) * (1.0 / t25);
        fzb += tb75;
        fzbd += tb75d;
        t25b = -(tb75 * z2);
        t25bd = -(tb75d * z2 + tb75 * z2d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t25b * fz0_2;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t25bd * fz0_2 + t25b * fz0_2d;
        fz0_2b += t25b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2];
        fz0_2bd += t25bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] + t25b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2];
        e6b = 0.0;
        e6bd = 0.0;
        if (MAGGI_RE(ay) > 0.0) {
          e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          e7d = e6d * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2)) - e6 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEY4] * gy2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2d));
          y4b = eyb;
          y4bd = eybd;
          eyb = 0.0;
          eybd = 0.0;
          e7b = 0.0;
          e7bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e7) > 1.0) {
            y4b = 0.0;
            y4bd = 0.0;
          } else {
            e7b += y4b;
            e7bd += y4bd;
            y4b = 0.0;
            y4bd = 0.0;
          }
          e6b += e7b * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          e6bd += e7bd * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2)) - e7b *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEY4] * gy2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2d));
          tb73 = e7b * e6;
          tb73d = e7bd * e6 + e7b * e6d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb73;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb73d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb73 * gy2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb73d * gy2 + tb73 * gy2d;
          gy2b -= tb73 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
          gy2bd -= tb73d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] + tb73 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
        } else {
          e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          e8d = e6d * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2)) + e6 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEY4] * gy2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2d));
          y5b = eyb;
          y5bd = eybd;
          eyb = 0.0;
          eybd = 0.0;
          e8b = 0.0;
          e8bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e8) > 1.0) {
            y5b = 0.0;
            y5bd = 0.0;
          } else {
            e8b += y5b;
            e8bd += y5bd;
            y5b = 0.0;
            y5bd = 0.0;
          }
          e6b += e8b * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          e6bd += e8bd * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2)) + e8b *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEY4] * gy2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2d));
          tb74 = e8b * e6;
          tb74d = e8bd * e6 + e8b * e6d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb74;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb74d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb74 * gy2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb74d * gy2 + tb74 * gy2d;
          gy2b += tb74 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
          gy2bd += tb74d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] + tb74 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
        }
        tb72 = e6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
        tb72d = e6bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] + e6b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb72;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb72d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb72 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb72d * dfz + tb72 * dfzd;
        dfzb += tb72 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2];
        dfzbd += tb72d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] + tb72 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] += e6b * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] += e6bd * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz) + e6b *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfzd));
        tb68 = muyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        tb68d = muybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + muyb *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        tb69 = tb68 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2);
        tb69d = tb68d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2) - tb68
            * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2d) * gy2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb69;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb69d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb69 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb69d * dfz + tb69 * dfzd;
        dfzb += tb69 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
        dfzbd += tb69d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] + tb69 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
        tb70 = tb68 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz);
        tb70d = tb68d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz) + tb68 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd));
        tb71 = tb70 * gy2;
        tb71d = tb70d * gy2 + tb70 * gy2d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb71 * gy2;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb71d * gy2 + tb71 * gy2d;
        gy2b -= tb71 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
        gy2bd -= tb71d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] + tb71 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
        gy2b -= tb70 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2);
        gy2bd -= tb70d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2) + tb70 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += muyb *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2
            * gy2));
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += muybd *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2
            * gy2)) + muyb * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd)) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2) -
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2d) * gy2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2d));
        a2b += ayb;
        a2bd += aybd;
        tb67 = ayb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
        tb67d = aybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + ayb *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb67;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb67d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb67 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb67d * dfz + tb67 * dfzd;
        dfzb += tb67 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2];
        dfzbd += tb67d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] + tb67 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] += ayb * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] += aybd * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz) + ayb *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfzd));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] += ayb * gy2;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] += aybd * gy2 + ayb * gy2d;
        gy2b += ayb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3];
        gy2bd += aybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] + ayb *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3];
        gammab += gy2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
        gammabd += gy2bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] + gy2b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] += gy2b * gamma;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] += gy2bd * gamma + gy2b * gammad;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_2b *
            p[t->tyreadr[t->wheeltyre[n2]]];
        /* sin(2 atan(z)) = 2 z / (1 + z^2) */
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_2bd *
            p[t->tyreadr[t->wheeltyre[n2]]] + fz0_2b * pd[t->tyreadr[t->wheeltyre[n2]]];
        pb[t->tyreadr[t->wheeltyre[n2]]] += fz0_2b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LFZO];
        pbd[t->tyreadr[t->wheeltyre[n2]]] += fz0_2bd * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LFZO] + fz0_2b * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO];
        tb64 = x35b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb64d = x35bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + x35b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb65 = tb64 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
        tb65d = tb64d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + tb64 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
        fzb += tb65 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz);
        fzbd += tb65d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + tb65 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd));
        tb66 = tb65 * fz;
        tb66d = tb65d * fz + tb65 * fzd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb66;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb66d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb66 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb66d * dfz + tb66 * dfzd;
        dfzb += tb66 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
        dfzbd += tb66d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] + tb66 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb64 * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz));
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb64d * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz)) + tb64 * (fzd * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + fz *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd)));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += x35b * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += x35bd * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]) + x35b *
            ((fzd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + fz *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd))) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + fz * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]);
        kxb = x34b;
        kxbd = x34bd;
        tb61 = x33b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        tb61d = x33bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + x33b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        tb62 = tb61 * t24;
        tb62d = tb61d * t24 + tb61 * t24d;
        fzb += tb62 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz);
        fzbd += tb62d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + tb62 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd));
        tb63 = tb62 * fz;
        tb63d = tb62d * fz + tb62 * fzd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb63;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb63d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb63 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb63d * dfz + tb63 * dfzd;
        dfzb += tb63 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
        dfzbd += tb63d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] + tb63 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
        t24b = tb61 * (fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz));
        t24bd = tb61d * (fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz)) + tb61 * (fzd *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz) + fz * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd)));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += x33b * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz) * t24);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += x33bd * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz) * t24) + x33b * ((fzd * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t24 + fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t24d);
        t23b = t24b * t24;
        t23bd = t24bd * t24 + t24b * t24d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t23b * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t23bd * dfz + t23b * dfzd;
        dfzb += t23b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3];
        dfzbd += t23bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] + t23b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3];
        exb = x32b;
        exbd = x32bd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] += x31b * p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_LCX];
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] += x31bd *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX] + x31b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX] += x31b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PCX1];
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX] += x31bd * p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PCX1] + x31b * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1];
        muxb = x30b * fz;
        muxbd = x30bd * fz + x30b * fzd;
        fzb += x30b * mux;
        fzbd += x30bd * mux + x30b * muxd;
        e3b = 0.0;
        e3bd = 0.0;
        if (MAGGI_RE(kx) > 0.0) {
          e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          e4d = e3d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) - e3 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
          y2b = exb;
          y2bd = exbd;
          exb = 0.0;
          exbd = 0.0;
          e4b = 0.0;
          e4bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e4) > 1.0) {
            y2b = 0.0;
            y2bd = 0.0;
          } else {
            e4b += y2b;
            e4bd += y2bd;
            y2b = 0.0;
            y2bd = 0.0;
          }
          e3b += e4b * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          e3bd += e4bd * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) - e4b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4] -= e4b * e3;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4] -= e4bd * e3 + e4b * e3d;
        } else {
          e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          e5d = e3d * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) + e3 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
          y3b = exb;
          y3bd = exbd;
          exb = 0.0;
          exbd = 0.0;
          e5b = 0.0;
          e5bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e5) > 1.0) {
            y3b = 0.0;
            y3bd = 0.0;
          } else {
            e5b += y3b;
            e5bd += y3bd;
            y3b = 0.0;
            y3bd = 0.0;
          }
          e3b += e5b * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          e3bd += e5bd * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) + e5b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4] += e5b * e3;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4] += e5bd * e3 + e5b * e3d;
        }
        tb59 = e3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
        tb59d = e3bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] + e3b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb59;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb59d;
        tb60 = tb59 * dfz;
        tb60d = tb59d * dfz + tb59 * dfzd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb60;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb60d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb60 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb60d * dfz + tb60 * dfzd;
        dfzb += tb60 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
        dfzbd += tb60d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] + tb60 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
        dfzb += tb59 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz);
        dfzbd += tb59d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) + tb59 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEX3] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfzd));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] += e3b * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfz);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] += e3bd * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfz) + e3b *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] + ((pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PEX2] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfzd)) * dfz +
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEX3] * dfz) * dfzd));
        tb55 = muxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb55d = muxbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + muxb *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb56 = tb55 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2);
        tb56d = tb55d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2) - tb55
            * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2d) * gx2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb56;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb56d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb56 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb56d * dfz + tb56 * dfzd;
        dfzb += tb56 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
        dfzbd += tb56d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] + tb56 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
        tb57 = tb55 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz);
        tb57d = tb55d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz) + tb55 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd));
        tb58 = tb57 * gx2;
        tb58d = tb57d * gx2 + tb57 * gx2d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb58 * gx2;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb58d * gx2 + tb58 * gx2d;
        gx2b = -(tb58 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
        gx2bd = -(tb58d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] + tb58 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
        gx2b -= tb57 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2);
        gx2bd -= tb57d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2) + tb57 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += muxb *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2
            * gx2));
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += muxbd *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2
            * gx2)) + muxb * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd)) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2) -
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2d) * gx2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2d));
        gammab += gx2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
        gammabd += gx2bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] + gx2b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] += gx2b * gamma;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] += gx2bd * gamma + gx2b * gammad;
        kappab += kxb;
        kappabd += kxbd;
        tb54 = kxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
        tb54d = kxbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] + kxb *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb54;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb54d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb54 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb54d * dfz + tb54 * dfzd;
        dfzb += tb54 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
        dfzbd += tb54d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] + tb54 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxbd * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) + kxb *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfzd));
        tb53 = dfzb / fz0;
        tb53d = (dfzbd - tb53 * fz0d) * (1.0 / fz0);
        fzb += tb53;
        fzbd += tb53d;
        fz0b = -tb53;
        fz0bd = -tb53d;
        fz0b -= tb53 * dfz;
        fz0bd -= tb53d * dfz + tb53 * dfzd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0b *
            p[t->tyreadr[t->wheeltyre[n2]]];
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0bd *
            p[t->tyreadr[t->wheeltyre[n2]]] + fz0b * pd[t->tyreadr[t->wheeltyre[n2]]];
        pb[t->tyreadr[t->wheeltyre[n2]]] += fz0b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LFZO];
        pbd[t->tyreadr[t->wheeltyre[n2]]] += fz0bd * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LFZO] + fz0b * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO];
        one3b = fzb;
        one3bd = fzbd;
        one2b = gammab;
        one2bd = gammabd;
        one1b = a2b;
        one1bd = a2bd;
        one0b = kappab;
        one0bd = kappabd;
        gripb[n2][2] += one3b;
        gripbd[n2][2] += one3bd;
        slipb[n2][MAGGI_SLIP_GAMMA] += one2b * side;
        slipbd[n2][MAGGI_SLIP_GAMMA] += one2bd * side;
        slipb[n2][MAGGI_SLIP_TAN_ALPHA] += one1b * side;
        slipbd[n2][MAGGI_SLIP_TAN_ALPHA] += one1bd * side;
        slipb[n2][MAGGI_SLIP_KAPPA] += one0b;
        slipbd[n2][MAGGI_SLIP_KAPPA] += one0bd;
      } else {
        sb[i][2] = 0.0;
        sbd[i][2] = 0.0;
        sb[i][1] = 0.0;
        sbd[i][1] = 0.0;
        sb[i][0] = 0.0;
        sbd[i][0] = 0.0;
      }
    }
  }
}
