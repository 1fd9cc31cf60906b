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
  int a, a3, b, b7, i, j, k, k2, n2;
  double A_j0, A_j0b, A_j0bd, A_j0d, A_j3, A_j3b, A_j3bd, A_j3d, A_j7, A_j7b, A_j7bd, A_j7d, A_j8,
      A_j8b, A_j8bd, A_j8d, Z_j3, Z_j3b, Z_j3bd, Z_j3d, Z_j4, Z_j4b, Z_j4bd, Z_j4d, a2, a2b, a2bd,
      a2d, ay, ayb, aybd, ayd, b2, b2b, b2bd, b2d, b3, b3b, b3bd, b3d, b4, b4b, b4bd, b4d, b5, b5b,
      b5bd, b5d, b6, b6b, b6bd, b6d, c, c2, c2b, c2bd, c2d, c3, c3b, c3bd, c3d, cb, cbd, cd,
      dampingb, dampingbd, dfz, dfzb, dfzbd, dfzd, dv, dvb, dvbd, dvd, e0, e0b, e0bd, e0d, e1, e10,
      e10b, e10bd, e10d, e11, e11b, e11bd, e11d, e12, e12b, e12bd, e12d, e1b, e1bd, e1d, e20, e20b,
      e20bd, e20d, e21, e21b, e21bd, e21d, e22, e22b, e22bd, e22d, e2_2, e2_2b, e2_2bd, e2_2d, e3,
      e3b, e3bd, e3d, e4, e4b, e4bd, e4d, e5, e5b, e5bd, e5d, e6, e6b, e6bd, e6d, e7, e7b, e7bd,
      e7d, e8, e8b, e8bd, e8d, e9, e9b, e9bd, e9d, ev0, ev0b, ev0bd, ev0d, ev1, ev1b, ev1bd, ev1d,
      ev20, ev20b, ev20bd, ev20d, ev21, ev21b, ev21bd, ev21d, ev22, ev22b, ev22bd, ev22d, ev2_2,
      ev2_2b, ev2_2bd, ev2_2d, ex, exb, exbd, exd, ey, eyb, eybd, eyd, f0b, f0bd, f1b, f1bd, f2b,
      f2bd, fx, fxb, fxbd, fxd, fy, fyb, fybd, fyd, fz, fz0, fz0_2, fz0_2b, fz0_2bd, fz0_2d, fz0b,
      fz0bd, fz0d, fzb, fzbd, fzd, g0, g0b, g0bd, g0d, g1, g1b, g1bd, g1d, g2, g2b, g2bd, g2d, g3,
      g3b, g3bd, g3d, g4, g4b, g4bd, g4d, g5, g5b, g5bd, g5d, g6, g6b, g6bd, g6d, g7, g7b, g7bd,
      g7d, g8, g8b, g8bd, g8d, gamma, gammab, gammabd, gammad, gx, gx2, gx2b, gx2bd, gx2d, gxb,
      gxbd, gxd, gy, gy2, gy2b, gy2bd, gy2d, gyb, gybd, gyd, ka, kab, kabd, kad, kappa, kappab,
      kappabd, kappad, kx, kxb, kxbd, kxd, l, l2, l2b, l2bd, l2d, l3, l3b, l3bd, l3d, lb, lbd, ld,
      lv, lvb, lvbd, lvd, m, mb, mbd, md, mux, muxb, muxbd, muxd, muy, muyb, muybd, muyd, n30, n30b,
      n30bd, n30d, n31, n31b, n31bd, n31d, n32, n32b, n32bd, n32d, n4, n4b, n4bd, n4d, n5, n5b,
      n5bd, n5d, one0, one0b, one0bd, one0d, one1, one1b, one1bd, one1d, one2, one2b, one2bd, one2d,
      one3, one3b, one3bd, one3d, p2, p2b, p2bd, p2d, p3, p3b, p3bd, p3d, p4, p4b, p4bd, p4d, p5,
      p5b, p5bd, p5d, p6, p6b, p6bd, p6d, p_k24, p_k24b, p_k24bd, p_k24d, p_k25, p_k25b, p_k25bd,
      p_k25d, peak, peakb, peakbd, peakd, roll, rollb, rollbd, rolld, s2, s2b, s2bd, s2d, s3, s3b,
      s3bd, s3d, shift, shift2, shift2b, shift2bd, shift2d, shiftb, shiftbd, shiftd, side, slip_n2b,
      slip_n2bd, t10, t100, t100b, t100bd, t100d, t101, t101b, t101bd, t101d, t102, t102b, t102bd,
      t102d, t103, t103b, t103bd, t103d, t104, t104b, t104bd, t104d, t105, t105b, t105bd, t105d,
      t106, t106b, t106bd, t106d, t107, t107b, t107bd, t107d, t108, t108b, t108bd, t108d, t109,
      t109b, t109bd, t109d, t10b, t10bd, t10d, t11, t110, t110b, t110bd, t110d, t111, t111b, t111bd,
      t111d, t112, t112b, t112bd, t112d, t113, t113b, t113bd, t113d, t114, t114b, t114bd, t114d,
      t115, t115b, t115bd, t115d, t116, t116b, t116bd, t116d, t117, t117b, t117bd, t117d, t118,
      t118b, t118bd, t118d, t119, t119b, t119bd, t119d, t11b, t11bd, t11d, t12, t120, t120b, t120bd,
      t120d, t121, t121b, t121bd, t121d, t122, t122b, t122bd, t122d, t123, t123b, t123bd, t123d,
      t124, t124b, t124bd, t124d, t125, t125b, t125bd, t125d, t126, t126b, t126bd, t126d, t127,
      t127b, t127bd, t127d, t128, t128b, t128bd, t128d, t129, t129b, t129bd, t129d, t12b, t12bd,
      t12d, t13, t130, t130b, t130bd, t130d, t131, t131b, t131bd, t131d, t132, t132b, t132bd, t132d,
      t133, t133b, t133bd, t133d, t134b, t134bd, t13b, t13bd, t13d, t14, t14b, t14bd, t14d, t15,
      t15b, t15bd, t15d, t16, t16b, t16bd, t16d, t17, t17b, t17bd, t17d, t18, t18b, t18bd, t18d,
      t19, t19b, t19bd, t19d, t2, t20, t20b, t20bd, t20d, t21, t21b, t21bd, t21d, t22, t22b, t22bd,
      t22d, t23, t23b, t23bd, t23d, t24, t24b, t24bd, t24d, t25, t25b, t25bd, t25d, t26, t26b,
      t26bd, t26d, t27, t27b, t27bd, t27d, t28, t28b, t28bd, t28d, t29, t29b, t29bd, t29d, t2b,
      t2bd, t2d, t3, t30, t30b, t30bd, t30d, t31, t31b, t31bd, t31d, t32, t32b, t32bd, t32d, t33,
      t33b, t33bd, t33d, t34, t34b, t34bd, t34d, t35, t35b, t35bd, t35d, t36, t36b, t36bd, t36d,
      t37, t37b, t37bd, t37d, t38, t38b, t38bd, t38d, t39, t39b, t39bd, t39d, t3b, t3bd, t3d, t4,
      t40, t40b, t40bd, t40d, t41, t41b, t41bd, t41d, t42, t42b, t42bd, t42d, t43, t43b, t43bd,
      t43d, t44, t44b, t44bd, t44d, t45, t45b, t45bd, t45d, t46, t46b, t46bd, t46d, t47, t47b,
      t47bd, t47d, t48, t48b, t48bd, t48d, t49, t49b, t49bd, t49d, t4b, t4bd, t4d, t5, t50, t50b,
      t50bd, t50d, t51, t51b, t51bd, t51d, t52, t52b, t52bd, t52d, t53, t53b, t53bd, t53d, t54,
      t54b, t54bd, t54d, t55, t55b, t55bd, t55d, t56, t56b, t56bd, t56d, t57, t57b, t57bd, t57d,
      t58, t58b, t58bd, t58d, t59, t59b, t59bd, t59d, t5b, t5bd, t5d, t6, t60, t60b, t60bd, t60d,
      t61, t61b, t61bd, t61d, t62, t62b, t62bd, t62d, t63, t63b, t63bd, t63d, t64, t64b, t64bd,
      t64d, t65, t65b, t65bd, t65d, t66, t66b, t66bd, t66d, t67, t67b, t67bd, t67d, t68, t68b,
      t68bd, t68d, t69, t69b, t69bd, t69d, t6b, t6bd, t6d, t7, t70, t70b, t70bd, t70d, t71, t71b,
      t71bd, t71d, t72, t72b, t72bd, t72d, t73, t73b, t73bd, t73d, t74, t74b, t74bd, t74d, t75,
      t75b, t75bd, t75d, t76, t76b, t76bd, t76d, t77, t77b, t77bd, t77d, t78, t78b, t78bd, t78d,
      t79, t79b, t79bd, t79d, t7b, t7bd, t7d, t8, t80, t80b, t80bd, t80d, t81, t81b, t81bd, t81d,
      t82, t82b, t82bd, t82d, t83, t83b, t83bd, t83d, t84, t84b, t84bd, t84d, t85, t85b, t85bd,
      t85d, t86, t86b, t86bd, t86d, t87, t87b, t87bd, t87d, t88, t88b, t88bd, t88d, t89, t89b,
      t89bd, t89d, t8b, t8bd, t8d, t9, t90, t90b, t90bd, t90d, t91, t91b, t91bd, t91d, t92, t92b,
      t92bd, t92d, t93, t93b, t93bd, t93d, t94, t94b, t94bd, t94d, t95, t95b, t95bd, t95d, t96,
      t96b, t96bd, t96d, t97, t97b, t97bd, t97d, t98, t98b, t98bd, t98d, t99, t99b, t99bd, t99d,
      t9b, t9bd, t9d, tb10, tb100, tb100d, tb101, tb101d, tb102, tb102d, tb103, tb103d, tb104,
      tb104d, tb105, tb105d, tb106, tb106d, tb107, tb107d, tb108, tb108d, tb109, tb109d, tb10d,
      tb11, tb110, tb110d, tb111, tb111d, tb112, tb112d, tb113, tb113d, tb114, tb114d, tb115,
      tb115d, tb116, tb116d, tb117, tb117d, tb118, tb118d, tb119, tb119d, tb11d, tb12, tb120,
      tb120d, tb121, tb121d, tb122, tb122d, tb123, tb123d, tb124, tb124d, tb125, tb125d, tb126,
      tb126d, tb127, tb127d, tb128, tb128d, tb129, tb129d, tb12d, tb13, tb130, tb130d, tb131,
      tb131d, tb132, tb132d, tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d, tb17, tb17d, tb18, tb18d,
      tb19, tb19d, tb2, tb20, tb20d, tb21, tb21d, tb22, tb22d, tb23, tb23d, tb24, tb24d, tb25,
      tb25d, tb26, tb26d, tb27, tb27d, tb28, tb28d, tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31,
      tb31d, tb32, tb32d, tb33, tb33d, tb34, tb34d, tb35, tb35d, tb36, tb36d, tb37, tb37d, tb38,
      tb38d, tb39, tb39d, tb3d, tb4, tb40, tb40d, tb41, tb41d, tb42, tb42d, tb43, tb43d, tb44,
      tb44d, tb45, tb45d, tb46, tb46d, tb47, tb47d, tb48, tb48d, tb49, tb49d, tb4d, tb5, tb50,
      tb50d, tb51, tb51d, tb52, tb52d, tb53, tb53d, tb54, tb54d, tb55, tb55d, tb56, tb56d, tb57,
      tb57d, tb58, tb58d, tb59, tb59d, tb5d, tb6, tb60, tb60d, tb61, tb61d, tb62, tb62d, tb63,
      tb63d, tb64, tb64d, tb65, tb65d, tb66, tb66d, tb67, tb67d, tb68, tb68d, tb69, tb69d, tb6d,
      tb7, tb70, tb70d, tb71, tb71d, tb72, tb72d, tb73, tb73d, tb74, tb74d, tb75, tb75d, tb76,
      tb76d, tb77, tb77d, tb78, tb78d, tb79, tb79d, tb7d, tb8, tb80, tb80d, tb81, tb81d, tb82,
      tb82d, tb83, tb83d, tb84, tb84d, tb85, tb85d, tb86, tb86d, tb87, tb87d, tb88, tb88d, tb89,
      tb89d, tb8d, tb9, tb90, tb90d, tb91, tb91d, tb92, tb92d, tb93, tb93d, tb94, tb94d, tb95,
      tb95d, tb96, tb96d, tb97, tb97d, tb98, tb98d, tb99, tb99d, tb9d, torque0b, torque0bd, ux, uxb,
      uxbd, uxd, uy, uyb, uybd, uyd, v2, v2b, v2bd, v2d, wx1, wx1b, wx1bd, wx1d, wy1, wy1b, wy1bd,
      wy1d, x2, x2b, x2bd, x2d, x30, x30b, x30bd, x30d, x31, x31b, x31bd, x31d, x32, x32b, x32bd,
      x32d, x33, x33b, x33bd, x33d, x34, x34b, x34bd, x34d, x35, x35b, x35bd, x35d, x4, x4b, x4bd,
      x4d, x5, x5b, x5bd, x5d, x6, x6b, x6bd, x6d, x7, x7b, x7bd, x7d, x8, x8b, x8bd, x8d, x9, x9b,
      x9bd, x9d, xv, xvb, xvbd, xvd, y0, y0_2, y0_2b, y0_2bd, y0_2d, y0_3, y0_3b, y0_3bd, y0_3d,
      y0b, y0bd, y0d, y1, y10, y10b, y10bd, y10d, y11, y11b, y11bd, y11d, y12, y12b, y12bd, y12d,
      y13, y13b, y13bd, y13d, y14, y14b, y14bd, y14d, y15, y15b, y15bd, y15d, y16, y16b, y16bd,
      y16d, y17, y17b, y17bd, y17d, y18, y18b, y18bd, y18d, y1b, y1bd, y1d, y2, y2_2, y2_2b, y2_2bd,
      y2_2d, y2b, y2bd, y2d, y3, y3_2, y3_2b, y3_2bd, y3_2d, y3b, y3bd, y3d, y4, y4_2, y4_2b,
      y4_2bd, y4_2d, y4b, y4bd, y4d, y5, y5_2, y5_2b, y5_2bd, y5_2d, y5b, y5bd, y5d, y6, y6b, y6bd,
      y6d, y7, y7b, y7bd, y7d, y8, y8b, y8bd, y8d, y9, y9b, y9bd, y9d, z0, z0_2, z0_2b, z0_2bd,
      z0_2d, z0_3b, z0_3bd, z0_4b, z0_4bd, z0_5b, z0_5bd, z0b, z0bd, z0d, z10, z10b, z10bd, z10d,
      z11, z11b, z11bd, z11d, z1_2b, z1_2bd, z1_3, z1_3b, z1_3bd, z1_3d, z1b, z1bd, z2, z2b, z2bd,
      z2d, z3, z3b, z3bd, z3d, z4, z4b, z4bd, z4d, z5, z5b, z5bd, z5d, z6, z6b, z6bd, z6d, z7, z7b,
      z7bd, z7d, z8, z8b, z8bd, z8d, z9, z9b, z9bd, z9d;

  (void)origin;
  (void)x;
  (void)xd;
  (void)Za;
  (void)Zad;
  (void)ra;
  (void)rad;
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
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j7d = Ad[j][7];
      A_j8 = A[j][8];
      A_j8d = Ad[j][8];
      t2 = -A[j][6];
      t2d = -Ad[j][6];
      t3 = A_j7 * A_j7 + A_j8 * A_j8;
      t3d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
      t4 = sqrt(t3);
      t4d = 1.0 / (2.0 * t4) * t3d;
      tb10 = sb[i][2];
      tb10d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Ab[j][3] += tb10 * (A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      Abd[j][3] += tb10d * (A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3])) + tb10 * ((Ad[j][0] -
          A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]) * (Ad[j][0] * A[j][0] + A[j][0] *
          Ad[j][0] + (Ad[j][3] * A[j][3] + A[j][3] * Ad[j][3]))) / (A[j][0] * A[j][0] + A[j][3] *
          A[j][3]));
      Ab[j][0] -= tb10 * (A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      Abd[j][0] -= tb10d * (A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3])) + tb10 * ((Ad[j][3] -
          A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]) * (Ad[j][0] * A[j][0] + A[j][0] *
          Ad[j][0] + (Ad[j][3] * A[j][3] + A[j][3] * Ad[j][3]))) / (A[j][0] * A[j][0] + A[j][3] *
          A[j][3]));
      tb9 = sb[i][1];
      tb9d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      t2b = tb9 * (t4 / (t4 * t4 + t2 * t2));
      t2bd = tb9d * (t4 / (t4 * t4 + t2 * t2)) + tb9 * ((t4d - t4 / (t4 * t4 + t2 * t2) * (t4d * t4
          + t4 * t4d + (t2d * t2 + t2 * t2d))) / (t4 * t4 + t2 * t2));
      t4b = -(tb9 * (t2 / (t4 * t4 + t2 * t2)));
      t4bd = -(tb9d * (t2 / (t4 * t4 + t2 * t2)) + tb9 * ((t2d - t2 / (t4 * t4 + t2 * t2) * (t4d *
          t4 + t4 * t4d + (t2d * t2 + t2 * t2d))) / (t4 * t4 + t2 * t2)));
      t3b = t4b * (1.0 / (2.0 * t4));
      t3bd = t4bd * (1.0 / (2.0 * t4)) - t4b * (1.0 / (2.0 * t4) * (2.0 * t4d) / (2.0 * t4));
      A_j7b = t3b * A_j7;
      A_j7bd = t3bd * A_j7 + t3b * A_j7d;
      A_j7b += t3b * A_j7;
      A_j7bd += t3bd * A_j7 + t3b * A_j7d;
      A_j8b = t3b * A_j8;
      A_j8bd = t3bd * A_j8 + t3b * A_j8d;
      A_j8b += t3b * A_j8;
      A_j8bd += t3bd * A_j8 + t3b * A_j8d;
      Ab[j][6] -= t2b;
      Abd[j][6] -= t2bd;
      tb8 = sb[i][0];
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      tb8d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      A_j7b += tb8 * (A_j8 / (A_j8 * A_j8 + A_j7 * A_j7));
      A_j7bd += tb8d * (A_j8 / (A_j8 * A_j8 + A_j7 * A_j7)) + tb8 * ((A_j8d - A_j8 / (A_j8 * A_j8 +
          A_j7 * A_j7) * (A_j8d * A_j8 + A_j8 * A_j8d + (A_j7d * A_j7 + A_j7 * A_j7d))) / (A_j8 *
          A_j8 + A_j7 * A_j7));
      A_j8b -= tb8 * (A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      A_j8bd -= tb8d * (A_j7 / (A_j8 * A_j8 + A_j7 * A_j7)) + tb8 * ((A_j7d - A_j7 / (A_j8 * A_j8 +
          A_j7 * A_j7) * (A_j8d * A_j8 + A_j8 * A_j8d + (A_j7d * A_j7 + A_j7 * A_j7d))) / (A_j8 *
          A_j8 + A_j7 * A_j7));
      Ab[j][8] += A_j8b;
      Abd[j][8] += A_j8bd;
      Ab[j][7] += A_j7b;
      Abd[j][7] += A_j7bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      A_j0 = A[j][0];
      A_j0d = Ad[j][0];
      A_j3 = A[j][3];
      A_j3d = Ad[j][3];
      c2 = A_j0 * A_j0 + A_j3 * A_j3;
      c2d = A_j0d * A_j0 + A_j0 * A_j0d + (A_j3d * A_j3 + A_j3 * A_j3d);
      Z_j3 = Z[j][3];
      Z_j3d = Zd[j][3];
      Z_j4 = Z[j][4];
      Z_j4d = Zd[j][4];
      roll = s[i][0];
      rolld = sd[i][0];
      t5 = sqrt(c2);
      t5d = 1.0 / (2.0 * t5) * c2d;
      tb14 = sb[i][2];
      tb14d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Zb[j][5] += tb14;
      Zbd[j][5] += tb14d;
      Ab[j][6] -= tb14 * roll;
      Abd[j][6] -= tb14d * roll + tb14 * rolld;
      rollb = -(tb14 * A[j][6]);
      rollbd = -(tb14d * A[j][6] + tb14 * Ad[j][6]);
      tb12 = sb[i][1];
      tb12d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb13 = tb12 / t5;
      tb13d = (tb12d - tb13 * t5d) * (1.0 / t5);
      A_j0b = tb13 * Z_j4;
      A_j0bd = tb13d * Z_j4 + tb13 * Z_j4d;
      Z_j4b = tb13 * A_j0;
      Z_j4bd = tb13d * A_j0 + tb13 * A_j0d;
      A_j3b = -(tb13 * Z_j3);
      A_j3bd = -(tb13d * Z_j3 + tb13 * Z_j3d);
      Z_j3b = -(tb13 * A_j3);
      Z_j3bd = -(tb13d * A_j3 + tb13 * A_j3d);
      t5b = -(tb13 * s[i][1]);
      t5bd = -(tb13d * s[i][1] + tb13 * sd[i][1]);
      c2b = t5b * (1.0 / (2.0 * t5));
      c2bd = t5bd * (1.0 / (2.0 * t5)) - t5b * (1.0 / (2.0 * t5) * (2.0 * t5d) / (2.0 * t5));
      rollb += sb[i][0];
      rollbd += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      tb11 = rollb / c2;
      tb11d = (rollbd - tb11 * c2d) * (1.0 / c2);
      A_j0b += tb11 * Z_j3;
      A_j0bd += tb11d * Z_j3 + tb11 * Z_j3d;
      Z_j3b += tb11 * A_j0;
      Z_j3bd += tb11d * A_j0 + tb11 * A_j0d;
      A_j3b += tb11 * Z_j4;
      A_j3bd += tb11d * Z_j4 + tb11 * Z_j4d;
      Z_j4b += tb11 * A_j3;
      Z_j4bd += tb11d * A_j3 + tb11 * A_j3d;
      c2b -= tb11 * roll;
      c2bd -= tb11d * roll + tb11 * rolld;
      Zb[j][4] += Z_j4b;
      Zbd[j][4] += Z_j4bd;
      Zb[j][3] += Z_j3b;
      Zbd[j][3] += Z_j3bd;
      A_j0b += c2b * A_j0;
      /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
       * A_6 = -sin(pitch) */
      A_j0bd += c2bd * A_j0 + c2b * A_j0d;
      A_j0b += c2b * A_j0;
      A_j0bd += c2bd * A_j0 + c2b * A_j0d;
      A_j3b += c2b * A_j3;
      A_j3bd += c2bd * A_j3 + c2b * A_j3d;
      A_j3b += c2b * A_j3;
      A_j3bd += c2bd * A_j3 + c2b * A_j3d;
      Ab[j][3] += A_j3b;
      Abd[j][3] += A_j3bd;
      Ab[j][0] += A_j0b;
      Abd[j][0] += A_j0bd;
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
      a = t->springpa[n2];
      b = t->springpb[n2];
      e0 = r[a][0] - r[b][0];
      e0d = rd[a][0] - rd[b][0];
      ev0 = rv[a][0] - rv[b][0];
      ev0d = rvd[a][0] - rvd[b][0];
      e1 = r[a][1] - r[b][1];
      e1d = rd[a][1] - rd[b][1];
      ev1 = rv[a][1] - rv[b][1];
      ev1d = rvd[a][1] - rvd[b][1];
      e2_2 = r[a][2] - r[b][2];
      e2_2d = rd[a][2] - rd[b][2];
      ev2_2 = rv[a][2] - rv[b][2];
      ev2_2d = rvd[a][2] - rvd[b][2];
      t6 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
      t6d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
      l = sqrt(t6);
      ld = 1.0 / (2.0 * l) * t6d;
      n30 = e0 / l;
      n30d = (e0d - n30 * ld) * (1.0 / l);
      n31 = e1 / l;
      n31d = (e1d - n31 * ld) * (1.0 / l);
      n32 = e2_2 / l;
      n32d = (e2_2d - n32 * ld) * (1.0 / l);
      lv = n30 * ev0 + n31 * ev1 + n32 * ev2_2;
      lvd = n30d * ev0 + n30 * ev0d + (n31d * ev1 + n31 * ev1d) + (n32d * ev2_2 + n32 * ev2_2d);
      k2 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
      tb22 = sb[i][2];
      tb22d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      f0b = tb22;
      f0bd = tb22d;
      f1b = tb22;
      f1bd = tb22d;
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
        if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
          p_k24 = p[k2 + 4];
          p_k24d = pd[k2 + 4];
          pb[k2] += f2b * p_k24;
          pbd[k2] += f2bd * p_k24 + f2b * p_k24d;
          p_k24b = f2b * p[k2];
          p_k24bd = f2bd * p[k2] + f2b * pd[k2];
          pb[k2 + 1] += f2b * (lv - p_k24);
          pbd[k2 + 1] += f2bd * (lv - p_k24) + f2b * (lvd - p_k24d);
          tb20 = f2b * p[k2 + 1];
          tb20d = f2bd * p[k2 + 1] + f2b * pd[k2 + 1];
          lvb += tb20;
          lvbd += tb20d;
          p_k24b -= tb20;
          p_k24bd -= tb20d;
          f2b = 0.0;
          f2bd = 0.0;
          pb[k2 + 4] += p_k24b;
          pbd[k2 + 4] += p_k24bd;
        } else if (MAGGI_RE(lv) > 0.0) {
          pb[k2] += f2b * lv;
          pbd[k2] += f2bd * lv + f2b * lvd;
          lvb += f2b * p[k2];
          lvbd += f2bd * p[k2] + f2b * pd[k2];
          f2b = 0.0;
          f2bd = 0.0;
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
          pb[k2 + 2] += f2b * lv;
          pbd[k2 + 2] += f2bd * lv + f2b * lvd;
          lvb += f2b * p[k2 + 2];
          lvbd += f2bd * p[k2 + 2] + f2b * pd[k2 + 2];
          f2b = 0.0;
          f2bd = 0.0;
        } else {
          p_k25 = p[k2 + 5];
          p_k25d = pd[k2 + 5];
          pb[k2 + 2] += f2b * p_k25;
          pbd[k2 + 2] += f2bd * p_k25 + f2b * p_k25d;
          p_k25b = f2b * p[k2 + 2];
          p_k25bd = f2bd * p[k2 + 2] + f2b * pd[k2 + 2];
          pb[k2 + 3] += f2b * (lv - p_k25);
          pbd[k2 + 3] += f2bd * (lv - p_k25) + f2b * (lvd - p_k25d);
          tb21 = f2b * p[k2 + 3];
          tb21d = f2bd * p[k2 + 3] + f2b * pd[k2 + 3];
          lvb += tb21;
          lvbd += tb21d;
          p_k25b -= tb21;
          p_k25bd -= tb21d;
          f2b = 0.0;
          f2bd = 0.0;
          pb[k2 + 5] += p_k25b;
          pbd[k2 + 5] += p_k25bd;
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
        tb18 = f0b * p[t->springadr[n2]];
        tb18d = f0bd * p[t->springadr[n2]] + f0b * pd[t->springadr[n2]];
        lb += tb18;
        lbd += tb18d;
        spring0b[n2] -= tb18;
        spring0bd[n2] -= tb18d;
        pb[t->springadr[n2] + MAGGI_SPRING_L] += f0b;
        pbd[t->springadr[n2] + MAGGI_SPRING_L] += f0bd;
        f0b = 0.0;
        f0bd = 0.0;
      } else {
        pb[t->springadr[n2]] += f0b * (l - p[t->springadr[n2] + MAGGI_SPRING_L]);
        pbd[t->springadr[n2]] += f0bd * (l - p[t->springadr[n2] + MAGGI_SPRING_L]) + f0b * (ld -
            pd[t->springadr[n2] + MAGGI_SPRING_L]);
        tb19 = f0b * p[t->springadr[n2]];
        tb19d = f0bd * p[t->springadr[n2]] + f0b * pd[t->springadr[n2]];
        lb += tb19;
        lbd += tb19d;
        pb[t->springadr[n2] + MAGGI_SPRING_L] -= tb19;
        pbd[t->springadr[n2] + MAGGI_SPRING_L] -= tb19d;
        f0b = 0.0;
        f0bd = 0.0;
      }
      pb[t->springadr[n2] + MAGGI_SPRING_C] += dampingb * lv;
      pbd[t->springadr[n2] + MAGGI_SPRING_C] += dampingbd * lv + dampingb * lvd;
      lvb += dampingb * p[t->springadr[n2] + MAGGI_SPRING_C];
      lvbd += dampingbd * p[t->springadr[n2] + MAGGI_SPRING_C] + dampingb * pd[t->springadr[n2] +
          MAGGI_SPRING_C];
      n30b = lvb * ev0;
      n30bd = lvbd * ev0 + lvb * ev0d;
      ev0b = lvb * n30;
      ev0bd = lvbd * n30 + lvb * n30d;
      n31b = lvb * ev1;
      n31bd = lvbd * ev1 + lvb * ev1d;
      ev1b = lvb * n31;
      ev1bd = lvbd * n31 + lvb * n31d;
      n32b = lvb * ev2_2;
      n32bd = lvbd * ev2_2 + lvb * ev2_2d;
      ev2_2b = lvb * n32;
      ev2_2bd = lvbd * n32 + lvb * n32d;
      tb17 = n32b / l;
      tb17d = (n32bd - tb17 * ld) * (1.0 / l);
      e2_2b = tb17;
      e2_2bd = tb17d;
      lb -= tb17 * n32;
      lbd -= tb17d * n32 + tb17 * n32d;
      tb16 = n31b / l;
      tb16d = (n31bd - tb16 * ld) * (1.0 / l);
      e1b = tb16;
      e1bd = tb16d;
      lb -= tb16 * n31;
      lbd -= tb16d * n31 + tb16 * n31d;
      tb15 = n30b / l;
      tb15d = (n30bd - tb15 * ld) * (1.0 / l);
      e0b = tb15;
      e0bd = tb15d;
      lb -= tb15 * n30;
      lbd -= tb15d * n30 + tb15 * n30d;
      t6b = lb * (1.0 / (2.0 * l));
      t6bd = lbd * (1.0 / (2.0 * l)) - lb * (1.0 / (2.0 * l) * (2.0 * ld) / (2.0 * l));
      e0b += t6b * e0;
      e0bd += t6bd * e0 + t6b * e0d;
      e0b += t6b * e0;
      e0bd += t6bd * e0 + t6b * e0d;
      e1b += t6b * e1;
      e1bd += t6bd * e1 + t6b * e1d;
      e1b += t6b * e1;
      e1bd += t6bd * e1 + t6b * e1d;
      e2_2b += t6b * e2_2;
      e2_2bd += t6bd * e2_2 + t6b * e2_2d;
      e2_2b += t6b * e2_2;
      e2_2bd += t6bd * e2_2 + t6b * e2_2d;
      rvb[a][2] += ev2_2b;
      rvbd[a][2] += ev2_2bd;
      rvb[b][2] -= ev2_2b;
      rvbd[b][2] -= ev2_2bd;
      rb[a][2] += e2_2b;
      rbd[a][2] += e2_2bd;
      rb[b][2] -= e2_2b;
      rbd[b][2] -= e2_2bd;
      rvb[a][1] += ev1b;
      rvbd[a][1] += ev1bd;
      rvb[b][1] -= ev1b;
      rvbd[b][1] -= ev1bd;
      rb[a][1] += e1b;
      rbd[a][1] += e1bd;
      rb[b][1] -= e1b;
      rbd[b][1] -= e1bd;
      rvb[a][0] += ev0b;
      rvbd[a][0] += ev0bd;
      rvb[b][0] -= ev0b;
      rvbd[b][0] -= ev0bd;
      rb[a][0] += e0b;
      rbd[a][0] += e0bd;
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
      tb23 = torque0b * p[t->jspringadr[n2]];
      tb23d = torque0bd * p[t->jspringadr[n2]] + torque0b * pd[t->jspringadr[n2]];
      x2b -= tb23;
      x2bd -= tb23d;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_REST] += tb23;
      pbd[t->jspringadr[n2] + MAGGI_JSPRING_REST] += tb23d;
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
      a3 = t->primpa[n2];
      b7 = t->primpb[n2];
      e20 = r[a3][0] - r[b7][0];
      e20d = rd[a3][0] - rd[b7][0];
      ev20 = rv[a3][0] - rv[b7][0];
      ev20d = rvd[a3][0] - rvd[b7][0];
      e21 = r[a3][1] - r[b7][1];
      e21d = rd[a3][1] - rd[b7][1];
      ev21 = rv[a3][1] - rv[b7][1];
      ev21d = rvd[a3][1] - rvd[b7][1];
      e22 = r[a3][2] - r[b7][2];
      e22d = rd[a3][2] - rd[b7][2];
      ev22 = rv[a3][2] - rv[b7][2];
      ev22d = rvd[a3][2] - rvd[b7][2];
      t7 = e20 * e20 + e21 * e21 + e22 * e22;
      t7d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 * e22d);
      l2 = sqrt(t7);
      l2d = 1.0 / (2.0 * l2) * t7d;
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
      tb24 = z1_3b / l2;
      tb24d = (z1_3bd - tb24 * l2d) * (1.0 / l2);
      e20b = tb24 * ev20;
      e20bd = tb24d * ev20 + tb24 * ev20d;
      ev20b = tb24 * e20;
      ev20bd = tb24d * e20 + tb24 * e20d;
      e21b = tb24 * ev21;
      e21bd = tb24d * ev21 + tb24 * ev21d;
      ev21b = tb24 * e21;
      ev21bd = tb24d * e21 + tb24 * e21d;
      e22b = tb24 * ev22;
      e22bd = tb24d * ev22 + tb24 * ev22d;
      ev22b = tb24 * e22;
      ev22bd = tb24d * e22 + tb24 * e22d;
      l2b = -(tb24 * z1_3);
      l2bd = -(tb24d * z1_3 + tb24 * z1_3d);
      l2b += z0_5b;
      l2bd += z0_5bd;
      t7b = l2b * (1.0 / (2.0 * l2));
      t7bd = l2bd * (1.0 / (2.0 * l2)) - l2b * (1.0 / (2.0 * l2) * (2.0 * l2d) / (2.0 * l2));
      e20b += t7b * e20;
      e20bd += t7bd * e20 + t7b * e20d;
      e20b += t7b * e20;
      e20bd += t7bd * e20 + t7b * e20d;
      e21b += t7b * e21;
      e21bd += t7bd * e21 + t7b * e21d;
      e21b += t7b * e21;
      e21bd += t7bd * e21 + t7b * e21d;
      e22b += t7b * e22;
      e22bd += t7bd * e22 + t7b * e22d;
      e22b += t7b * e22;
      e22bd += t7bd * e22 + t7b * e22d;
      rvb[a3][2] += ev22b;
      rvbd[a3][2] += ev22bd;
      rvb[b7][2] -= ev22b;
      rvbd[b7][2] -= ev22bd;
      rb[a3][2] += e22b;
      rbd[a3][2] += e22bd;
      rb[b7][2] -= e22b;
      rbd[b7][2] -= e22bd;
      rvb[a3][1] += ev21b;
      rvbd[a3][1] += ev21bd;
      rvb[b7][1] -= ev21b;
      rvbd[b7][1] -= ev21bd;
      rb[a3][1] += e21b;
      rbd[a3][1] += e21bd;
      rb[b7][1] -= e21b;
      rbd[b7][1] -= e21bd;
      rvb[a3][0] += ev20b;
      rvbd[a3][0] += ev20bd;
      rvb[b7][0] -= ev20b;
      rvbd[b7][0] -= ev20bd;
      rb[a3][0] += e20b;
      /* distance of two points and its rate */
      rbd[a3][0] += e20bd;
      rb[b7][0] -= e20b;
      rbd[b7][0] -= e20bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_SLIP) {
      slipb[n2][MAGGI_SLIP_GAMMA] += sb[i][2];
      slipbd[n2][MAGGI_SLIP_GAMMA] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      tb25 = sb[i][1];
      tb25d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      slipb[n2][MAGGI_SLIP_TAN_ALPHA] += tb25 * (1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] *
          slip[n2][MAGGI_SLIP_TAN_ALPHA]));
      slipbd[n2][MAGGI_SLIP_TAN_ALPHA] += tb25d * (1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] *
          slip[n2][MAGGI_SLIP_TAN_ALPHA])) - tb25 * (1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] *
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
      tb26 = sb[i][0];
      tb26d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb26;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb26d;
      slip_n2b -= tb26;
      slip_n2bd -= tb26d;
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
        t8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
        t8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfzd;
        t9 = exp(t8);
        t9d = t9 * t8d;
        x33 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t9 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        x33d = ((fzd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t9 + fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t9d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + fz * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t9 *
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
        t10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2;
        t10d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2d;
        z2 = fz / t10;
        z2d = (fzd - z2 * t10d) * (1.0 / t10);
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
          t11 = p2 * p2;
          t11d = p2d * p2 + p2 * p2d;
          z3 = gy2 * gy2 / t11;
          z3d = (gy2d * gy2 + gy2 * gy2d - z3 * t11d) * (1.0 / t11);
          y6 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
          y6d = (0.125 * p2d * z3 + 0.125 * p2 * z3d) * (15.0 + z3 * (-10.0 + 3.0 * z3)) + 0.125 *
              p2 * z3 * (z3d * (-10.0 + 3.0 * z3) + z3 * (3.0 * z3d));
        }
        t12 = 1.0 + z2 * z2;
        t12d = z2d * z2 + z2 * z2d;
        t13 = 2.0 * z2 / t12;
        t13d = (2.0 * z2d - t13 * t12d) * (1.0 / t12);
        y3_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) * p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_LKY];
        y3_2d = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d) * t13 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) - p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] *
            y6 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6d)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
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
        t14 = 1.0 + x4 * x4;
        t14d = x4d * x4 + x4 * x4d;
        t15 = sqrt(t14);
        t15d = 1.0 / (2.0 * t15) * t14d;
        t16 = 1.0 / t15;
        t16d = -(t16 * t15d * (1.0 / t15));
        g0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g0d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBX1] * t16 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g1 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
        g1d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
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
        g2 = y7;
        g2d = y7d;
        g3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        g3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        x5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        x5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBY2] * (a2d - pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        t17 = 1.0 + x5 * x5;
        t17d = x5d * x5 + x5 * x5d;
        t18 = sqrt(t17);
        t18d = 1.0 / (2.0 * t18) * t17d;
        t19 = 1.0 / t18;
        t19d = -(t19 * t18d * (1.0 / t18));
        g4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g4d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBY1] * t19 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
        g5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
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
        g6 = y8;
        g6d = y8d;
        g7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RHY2] * dfz;
        g7d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RHY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfzd);
        p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        p3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        x6 = p3 * a2;
        x6d = p3d * a2 + p3 * a2d;
        t20 = 1.0 + x6 * x6;
        t20d = x6d * x6 + x6 * x6d;
        t21 = sqrt(t20);
        t21d = 1.0 / (2.0 * t21) * t20d;
        t22 = 1.0 / t21;
        t22d = -(t22 * t21d * (1.0 / t21));
        dv = peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) * t22;
        dvd = (peakd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) + peak * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1]
            + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gammad))) * t22 + peak *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma) *
            t22d;
        t23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa;
        t23d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappad;
        t24 = atan(t23);
        t24d = 1.0 / (1.0 + t23 * t23) * t23d;
        t25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t24;
        t25d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t24 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t24d;
        t26 = sin(t25);
        t26d = cos(t25) * t25d;
        g8 = dv * t26 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        g8d = (dvd * t26 + dv * t26d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + dv *
            t26 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        y9 = g0 * (a2 + g3);
        y9d = g0d * (a2 + g3) + g0 * (a2d + g3d);
        y10 = g0 * g3;
        y10d = g0d * g3 + g0 * g3d;
        t27 = atan(y9);
        t27d = 1.0 / (1.0 + y9 * y9) * y9d;
        t28 = (1.0 - g2) * y9 + g2 * t27;
        t28d = -(g2d * y9) + (1.0 - g2) * y9d + (g2d * t27 + g2 * t27d);
        t29 = atan(t28);
        t29d = 1.0 / (1.0 + t28 * t28) * t28d;
        t30 = g1 * t29;
        t30d = g1d * t29 + g1 * t29d;
        t31 = cos(t30);
        t31d = -(sin(t30) * t30d);
        t32 = atan(y10);
        t32d = 1.0 / (1.0 + y10 * y10) * y10d;
        t33 = (1.0 - g2) * y10 + g2 * t32;
        t33d = -(g2d * y10) + (1.0 - g2) * y10d + (g2d * t32 + g2 * t32d);
        t34 = atan(t33);
        t34d = 1.0 / (1.0 + t33 * t33) * t33d;
        t35 = g1 * t34;
        t35d = g1d * t34 + g1 * t34d;
        t36 = cos(t35);
        t36d = -(sin(t35) * t35d);
        gx = t31 / t36;
        gxd = (t31d - gx * t36d) * (1.0 / t36);
        y11 = g4 * (kappa + g7);
        y11d = g4d * (kappa + g7) + g4 * (kappad + g7d);
        y12 = g4 * g7;
        y12d = g4d * g7 + g4 * g7d;
        t37 = atan(y11);
        t37d = 1.0 / (1.0 + y11 * y11) * y11d;
        t38 = (1.0 - g6) * y11 + g6 * t37;
        t38d = -(g6d * y11) + (1.0 - g6) * y11d + (g6d * t37 + g6 * t37d);
        t39 = atan(t38);
        t39d = 1.0 / (1.0 + t38 * t38) * t38d;
        t40 = g5 * t39;
        t40d = g5d * t39 + g5 * t39d;
        t41 = cos(t40);
        t41d = -(sin(t40) * t40d);
        t42 = atan(y12);
        t42d = 1.0 / (1.0 + y12 * y12) * y12d;
        t43 = (1.0 - g6) * y12 + g6 * t42;
        t43d = -(g6d * y12) + (1.0 - g6) * y12d + (g6d * t42 + g6 * t42d);
        t44 = atan(t43);
        t44d = 1.0 / (1.0 + t43 * t43) * t43d;
        t45 = g5 * t44;
        t45d = g5d * t44 + g5 * t44d;
        t46 = cos(t45);
        t46d = -(sin(t45) * t45d);
        gy = t41 / t46;
        gyd = (t41d - gy * t46d) * (1.0 / t46);
        b3 = g0;
        b3d = g0d;
        c = g1;
        cd = g1d;
        e11 = g2;
        e11d = g2d;
        shift = g3;
        shiftd = g3d;
        y13 = b3 * (a2 + shift);
        y13d = b3d * (a2 + shift) + b3 * (a2d + shiftd);
        y0 = b3 * shift;
        y0d = b3d * shift + b3 * shiftd;
        t47 = atan(y13);
        t47d = 1.0 / (1.0 + y13 * y13) * y13d;
        t48 = (1.0 - e11) * y13 + e11 * t47;
        t48d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t47 + e11 * t47d);
        t49 = atan(t48);
        t49d = 1.0 / (1.0 + t48 * t48) * t48d;
        z4 = c * t49;
        z4d = cd * t49 + c * t49d;
        t50 = atan(y0);
        t50d = 1.0 / (1.0 + y0 * y0) * y0d;
        t51 = (1.0 - e11) * y0 + e11 * t50;
        t51d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t50 + e11 * t50d);
        t52 = atan(t51);
        t52d = 1.0 / (1.0 + t51 * t51) * t51d;
        z0 = c * t52;
        z0d = cd * t52 + c * t52d;
        n4 = cos(z0);
        n4d = -(sin(z0) * z0d);
        t53 = atan(y13);
        t53d = 1.0 / (1.0 + y13 * y13) * y13d;
        z5 = (1.0 - e11) * y13 + e11 * t53;
        z5d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t53 + e11 * t53d);
        t54 = sin(z4);
        t54d = cos(z4) * z4d;
        t55 = 1.0 + y13 * y13;
        t55d = y13d * y13 + y13 * y13d;
        t56 = e11 / t55;
        t56d = (e11d - t56 * t55d) * (1.0 / t55);
        t57 = 1.0 + z5 * z5;
        t57d = z5d * z5 + z5 * z5d;
        t58 = c * (1.0 - e11 + t56) / t57;
        t58d = (cd * (1.0 - e11 + t56) + c * (-e11d + t56d) - t58 * t57d) * (1.0 / t57);
        s2 = -t54 * t58 / n4;
        s2d = (-(t54d * t58) - t54 * t58d - s2 * n4d) * (1.0 / n4);
        t59 = atan(y0);
        t59d = 1.0 / (1.0 + y0 * y0) * y0d;
        z6 = (1.0 - e11) * y0 + e11 * t59;
        z6d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t59 + e11 * t59d);
        t60 = cos(z4);
        t60d = -(sin(z4) * z4d);
        t61 = sin(z0);
        t61d = cos(z0) * z0d;
        t62 = n4 * n4;
        t62d = n4d * n4 + n4 * n4d;
        t63 = t60 * t61 / t62;
        t63d = (t60d * t61 + t60 * t61d - t63 * t62d) * (1.0 / t62);
        t64 = 1.0 + y0 * y0;
        t64d = y0d * y0 + y0 * y0d;
        t65 = e11 / t64;
        t65d = (e11d - t65 * t64d) * (1.0 / t64);
        t66 = 1.0 + z6 * z6;
        t66d = z6d * z6 + z6 * z6d;
        t67 = c * (1.0 - e11 + t65) / t66;
        t67d = (cd * (1.0 - e11 + t65) + c * (-e11d + t65d) - t67 * t66d) * (1.0 / t66);
        wx1 = s2 * (a2 + shift) + t63 * t67 * shift;
        wx1d = s2d * (a2 + shift) + s2 * (a2d + shiftd) + ((t63d * t67 + t63 * t67d) * shift + t63 *
            t67 * shiftd);
        b4 = g4;
        b4d = g4d;
        c3 = g5;
        c3d = g5d;
        e12 = g6;
        e12d = g6d;
        shift2 = g7;
        shift2d = g7d;
        y14 = b4 * (kappa + shift2);
        y14d = b4d * (kappa + shift2) + b4 * (kappad + shift2d);
        y0_2 = b4 * shift2;
        y0_2d = b4d * shift2 + b4 * shift2d;
        t68 = atan(y14);
        t68d = 1.0 / (1.0 + y14 * y14) * y14d;
        t69 = (1.0 - e12) * y14 + e12 * t68;
        t69d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t68 + e12 * t68d);
        t70 = atan(t69);
        t70d = 1.0 / (1.0 + t69 * t69) * t69d;
        z7 = c3 * t70;
        z7d = c3d * t70 + c3 * t70d;
        t71 = atan(y0_2);
        t71d = 1.0 / (1.0 + y0_2 * y0_2) * y0_2d;
        t72 = (1.0 - e12) * y0_2 + e12 * t71;
        t72d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t71 + e12 * t71d);
        t73 = atan(t72);
        t73d = 1.0 / (1.0 + t72 * t72) * t72d;
        z0_2 = c3 * t73;
        z0_2d = c3d * t73 + c3 * t73d;
        n5 = cos(z0_2);
        n5d = -(sin(z0_2) * z0_2d);
        t74 = atan(y14);
        t74d = 1.0 / (1.0 + y14 * y14) * y14d;
        z8 = (1.0 - e12) * y14 + e12 * t74;
        z8d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t74 + e12 * t74d);
        t75 = sin(z7);
        t75d = cos(z7) * z7d;
        t76 = 1.0 + y14 * y14;
        t76d = y14d * y14 + y14 * y14d;
        t77 = e12 / t76;
        t77d = (e12d - t77 * t76d) * (1.0 / t76);
        t78 = 1.0 + z8 * z8;
        t78d = z8d * z8 + z8 * z8d;
        t79 = c3 * (1.0 - e12 + t77) / t78;
        t79d = (c3d * (1.0 - e12 + t77) + c3 * (-e12d + t77d) - t79 * t78d) * (1.0 / t78);
        s3 = -t75 * t79 / n5;
        s3d = (-(t75d * t79) - t75 * t79d - s3 * n5d) * (1.0 / n5);
        t80 = atan(y0_2);
        t80d = 1.0 / (1.0 + y0_2 * y0_2) * y0_2d;
        z9 = (1.0 - e12) * y0_2 + e12 * t80;
        z9d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t80 + e12 * t80d);
        t81 = cos(z7);
        t81d = -(sin(z7) * z7d);
        t82 = sin(z0_2);
        t82d = cos(z0_2) * z0_2d;
        t83 = n5 * n5;
        t83d = n5d * n5 + n5 * n5d;
        t84 = t81 * t82 / t83;
        t84d = (t81d * t82 + t81 * t82d - t84 * t83d) * (1.0 / t83);
        t85 = 1.0 + y0_2 * y0_2;
        t85d = y0_2d * y0_2 + y0_2 * y0_2d;
        t86 = e12 / t85;
        t86d = (e12d - t86 * t85d) * (1.0 / t85);
        t87 = 1.0 + z9 * z9;
        t87d = z9d * z9 + z9 * z9d;
        t88 = c3 * (1.0 - e12 + t86) / t87;
        t88d = (c3d * (1.0 - e12 + t86) + c3 * (-e12d + t86d) - t88 * t87d) * (1.0 / t87);
        wy1 = s3 * (kappa + shift2) + t84 * t88 * shift2;
        wy1d = s3d * (kappa + shift2) + s3 * (kappad + shift2d) + ((t84d * t88 + t84 * t88d) *
            shift2 + t84 * t88 * shift2d);
        t89 = x31 * x30;
        t89d = x31d * x30 + x31 * x30d;
        t90 = x33 / t89;
        t90d = (x33d - t90 * t89d) * (1.0 / t89);
        y15 = t90 * x34;
        y15d = t90d * x34 + t90 * x34d;
        t91 = atan(y15);
        t91d = 1.0 / (1.0 + y15 * y15) * y15d;
        t92 = (1.0 - x32) * y15 + x32 * t91;
        t92d = -(x32d * y15) + (1.0 - x32) * y15d + (x32d * t91 + x32 * t91d);
        t93 = atan(t92);
        t93d = 1.0 / (1.0 + t92 * t92) * t92d;
        t94 = x31 * t93;
        t94d = x31d * t93 + x31 * t93d;
        t95 = sin(t94);
        t95d = cos(t94) * t94d;
        fx = x30 * t95 + x35;
        fxd = x30d * t95 + x30 * t95d + x35d;
        t96 = y1 * y0_3;
        t96d = y1d * y0_3 + y1 * y0_3d;
        t97 = y3_2 / t96;
        t97d = (y3_2d - t97 * t96d) * (1.0 / t96);
        y16 = t97 * y4_2;
        y16d = t97d * y4_2 + t97 * y4_2d;
        t98 = atan(y16);
        t98d = 1.0 / (1.0 + y16 * y16) * y16d;
        t99 = (1.0 - y2_2) * y16 + y2_2 * t98;
        t99d = -(y2_2d * y16) + (1.0 - y2_2) * y16d + (y2_2d * t98 + y2_2 * t98d);
        t100 = atan(t99);
        t100d = 1.0 / (1.0 + t99 * t99) * t99d;
        t101 = y1 * t100;
        t101d = y1d * t100 + y1 * t100d;
        t102 = sin(t101);
        t102d = cos(t101) * t101d;
        fy = y0_3 * t102 + y5_2;
        fyd = y0_3d * t102 + y0_3 * t102d + y5_2d;
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        p5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        x7 = p4 * (a2 - p5);
        x7d = p4d * (a2 - p5) + p4 * (a2d - p5d);
        t103 = 1.0 + x7 * x7;
        t103d = x7d * x7 + x7 * x7d;
        t104 = sqrt(t103);
        t104d = 1.0 / (2.0 * t104) * t103d;
        t105 = 1.0 / t104;
        t105d = -(t105 * t104d * (1.0 / t104));
        l3 = p4 * t105;
        l3d = p4d * t105 + p4 * t105d;
        x8 = p3 * a2;
        x8d = p3d * a2 + p3 * a2d;
        t106 = 1.0 + x8 * x8;
        t106d = x8d * x8 + x8 * x8d;
        t107 = sqrt(t106);
        t107d = 1.0 / (2.0 * t107) * t106d;
        t108 = 1.0 / t107;
        t108d = -(t108 * t107d * (1.0 / t107));
        v2 = p3 * t108;
        v2d = p3d * t108 + p3 * t108d;
        b2 = -g4 * l3 * l3 * (a2 - p5);
        b2d = ((-(g4d * l3) - g4 * l3d) * l3 + -g4 * l3 * l3d) * (a2 - p5) + -g4 * l3 * l3 * (a2d -
            p5d);
        t109 = y1 * y0_3;
        t109d = y1d * y0_3 + y1 * y0_3d;
        b5 = y3_2 / t109;
        b5d = (y3_2d - b5 * t109d) * (1.0 / t109);
        y17 = b5 * y4_2;
        y17d = b5d * y4_2 + b5 * y4_2d;
        t110 = atan(y17);
        t110d = 1.0 / (1.0 + y17 * y17) * y17d;
        z10 = (1.0 - y2_2) * y17 + y2_2 * t110;
        z10d = -(y2_2d * y17) + (1.0 - y2_2) * y17d + (y2_2d * t110 + y2_2 * t110d);
        t111 = atan(y17);
        t111d = 1.0 / (1.0 + y17 * y17) * y17d;
        t112 = (1.0 - y2_2) * y17 + y2_2 * t111;
        t112d = -(y2_2d * y17) + (1.0 - y2_2) * y17d + (y2_2d * t111 + y2_2 * t111d);
        t113 = atan(t112);
        t113d = 1.0 / (1.0 + t112 * t112) * t112d;
        t114 = y1 * t113;
        t114d = y1d * t113 + y1 * t113d;
        t115 = cos(t114);
        t115d = -(sin(t114) * t114d);
        t116 = 1.0 + y17 * y17;
        t116d = y17d * y17 + y17 * y17d;
        t117 = y2_2 / t116;
        t117d = (y2_2d - t117 * t116d) * (1.0 / t116);
        t118 = 1.0 + z10 * z10;
        t118d = z10d * z10 + z10 * z10d;
        t119 = y1 * (1.0 - y2_2 + t117) / t118;
        t119d = (y1d * (1.0 - y2_2 + t117) + y1 * (-y2_2d + t117d) - t119 * t118d) * (1.0 / t118);
        p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        p6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        x9 = p6 * kappa;
        x9d = p6d * kappa + p6 * kappad;
        t120 = 1.0 + x9 * x9;
        t120d = x9d * x9 + x9 * x9d;
        t121 = sqrt(t120);
        t121d = 1.0 / (2.0 * t121) * t120d;
        t122 = 1.0 / t121;
        t122d = -(t122 * t121d * (1.0 / t121));
        m = p6 * t122;
        md = p6d * t122 + p6 * t122d;
        ka = -g0 * m * m * kappa;
        kad = ((-(g0d * m) - g0 * md) * m + -g0 * m * md) * kappa + -g0 * m * m * kappad;
        t123 = x31 * x30;
        t123d = x31d * x30 + x31 * x30d;
        b6 = x33 / t123;
        b6d = (x33d - b6 * t123d) * (1.0 / t123);
        y18 = b6 * x34;
        y18d = b6d * x34 + b6 * x34d;
        t124 = atan(y18);
        t124d = 1.0 / (1.0 + y18 * y18) * y18d;
        z11 = (1.0 - x32) * y18 + x32 * t124;
        z11d = -(x32d * y18) + (1.0 - x32) * y18d + (x32d * t124 + x32 * t124d);
        t125 = atan(y18);
        t125d = 1.0 / (1.0 + y18 * y18) * y18d;
        t126 = (1.0 - x32) * y18 + x32 * t125;
        t126d = -(x32d * y18) + (1.0 - x32) * y18d + (x32d * t125 + x32 * t125d);
        t127 = atan(t126);
        t127d = 1.0 / (1.0 + t126 * t126) * t126d;
        t128 = x31 * t127;
        t128d = x31d * t127 + x31 * t127d;
        t129 = cos(t128);
        t129d = -(sin(t128) * t128d);
        t130 = 1.0 + y18 * y18;
        t130d = y18d * y18 + y18 * y18d;
        t131 = x32 / t130;
        t131d = (x32d - t131 * t130d) * (1.0 / t130);
        t132 = 1.0 + z11 * z11;
        t132d = z11d * z11 + z11 * z11d;
        t133 = x31 * (1.0 - x32 + t131) / t132;
        t133d = (x31d * (1.0 - x32 + t131) + x31 * (-x32d + t131d) - t133 * t132d) * (1.0 / t132);
        ux = fx * gx / x30;
        uxd = (fxd * gx + fx * gxd - ux * x30d) * (1.0 / x30);
        uy = (fy * gy + g8) / y0_3;
        uyd = (fyd * gy + fy * gyd + g8d - uy * y0_3d) * (1.0 / y0_3);
        tb132 = sb[i][2];
        tb132d = sbd[i][2];
        sb[i][2] = 0.0;
        sbd[i][2] = 0.0;
        t134b = tb132 * (1.0 / (2.0 * s[i][2]));
        t134bd = tb132d * (1.0 / (2.0 * s[i][2])) - tb132 * (1.0 / (2.0 * s[i][2]) * (2.0 *
            sd[i][2]) / (2.0 * s[i][2]));
        uxb = t134b * ux;
        uxbd = t134bd * ux + t134b * uxd;
        uxb += t134b * ux;
        uxbd += t134bd * ux + t134b * uxd;
        uyb = t134b * uy;
        uybd = t134bd * uy + t134b * uyd;
        uyb += t134b * uy;
        uybd += t134bd * uy + t134b * uyd;
        tb131 = uyb / y0_3;
        tb131d = (uybd - tb131 * y0_3d) * (1.0 / y0_3);
        fyb = tb131 * gy;
        fybd = tb131d * gy + tb131 * gyd;
        gyb = tb131 * fy;
        gybd = tb131d * fy + tb131 * fyd;
        g8b = tb131;
        g8bd = tb131d;
        y0_3b = -(tb131 * uy);
        y0_3bd = -(tb131d * uy + tb131 * uyd);
        tb130 = uxb / x30;
        tb130d = (uxbd - tb130 * x30d) * (1.0 / x30);
        fxb = tb130 * gx;
        fxbd = tb130d * gx + tb130 * gxd;
        gxb = tb130 * fx;
        gxbd = tb130d * fx + tb130 * fxd;
        x30b = -(tb130 * ux);
        x30bd = -(tb130d * ux + tb130 * uxd);
        tb125 = sb[i][1];
        tb125d = sbd[i][1];
        sb[i][1] = 0.0;
        sbd[i][1] = 0.0;
        gxb += tb125 * (x30 * t129 * t133 * b6);
        gxbd += tb125d * (x30 * t129 * t133 * b6) + tb125 * (((x30d * t129 + x30 * t129d) * t133 +
            x30 * t129 * t133d) * b6 + x30 * t129 * t133 * b6d);
        tb126 = tb125 * gx;
        tb126d = tb125d * gx + tb125 * gxd;
        tb127 = tb126 * b6;
        tb127d = tb126d * b6 + tb126 * b6d;
        tb128 = tb127 * t133;
        tb128d = tb127d * t133 + tb127 * t133d;
        x30b += tb128 * t129;
        x30bd += tb128d * t129 + tb128 * t129d;
        t129b = tb128 * x30;
        t129bd = tb128d * x30 + tb128 * x30d;
        t133b = tb127 * (x30 * t129);
        t133bd = tb127d * (x30 * t129) + tb127 * (x30d * t129 + x30 * t129d);
        b6b = tb126 * (x30 * t129 * t133);
        b6bd = tb126d * (x30 * t129 * t133) + tb126 * ((x30d * t129 + x30 * t129d) * t133 + x30 *
            t129 * t133d);
        tb129 = tb125 * ka;
        tb129d = tb125d * ka + tb125 * kad;
        fxb += tb129 * wx1;
        fxbd += tb129d * wx1 + tb129 * wx1d;
        wx1b = tb129 * fx;
        wx1bd = tb129d * fx + tb129 * fxd;
        kab = tb125 * (fx * wx1);
        kabd = tb125d * (fx * wx1) + tb125 * (fxd * wx1 + fx * wx1d);
        tb123 = t133b / t132;
        tb123d = (t133bd - tb123 * t132d) * (1.0 / t132);
        x31b = tb123 * (1.0 - x32 + t131);
        x31bd = tb123d * (1.0 - x32 + t131) + tb123 * (-x32d + t131d);
        tb124 = tb123 * x31;
        tb124d = tb123d * x31 + tb123 * x31d;
        x32b = -tb124;
        x32bd = -tb124d;
        t131b = tb124;
        t131bd = tb124d;
        t132b = -(tb123 * t133);
        t132bd = -(tb123d * t133 + tb123 * t133d);
        z11b = t132b * z11;
        z11bd = t132bd * z11 + t132b * z11d;
        z11b += t132b * z11;
        z11bd += t132bd * z11 + t132b * z11d;
        tb122 = t131b / t130;
        tb122d = (t131bd - tb122 * t130d) * (1.0 / t130);
        x32b += tb122;
        x32bd += tb122d;
        t130b = -(tb122 * t131);
        t130bd = -(tb122d * t131 + tb122 * t131d);
        y18b = t130b * y18;
        y18bd = t130bd * y18 + t130b * y18d;
        y18b += t130b * y18;
        y18bd += t130bd * y18 + t130b * y18d;
        t128b = -(t129b * sin(t128));
        t128bd = -(t129bd * sin(t128) + t129b * (cos(t128) * t128d));
        x31b += t128b * t127;
        x31bd += t128bd * t127 + t128b * t127d;
        t127b = t128b * x31;
        t127bd = t128bd * x31 + t128b * x31d;
        t126b = t127b * (1.0 / (1.0 + t126 * t126));
        t126bd = t127bd * (1.0 / (1.0 + t126 * t126)) - t127b * (1.0 / (1.0 + t126 * t126) * (t126d
            * t126 + t126 * t126d) / (1.0 + t126 * t126));
        x32b -= t126b * y18;
        x32bd -= t126bd * y18 + t126b * y18d;
        y18b += t126b * (1.0 - x32);
        y18bd += t126bd * (1.0 - x32) - t126b * x32d;
        x32b += t126b * t125;
        x32bd += t126bd * t125 + t126b * t125d;
        t125b = t126b * x32;
        t125bd = t126bd * x32 + t126b * x32d;
        y18b += t125b * (1.0 / (1.0 + y18 * y18));
        y18bd += t125bd * (1.0 / (1.0 + y18 * y18)) - t125b * (1.0 / (1.0 + y18 * y18) * (y18d * y18
            + y18 * y18d) / (1.0 + y18 * y18));
        x32b -= z11b * y18;
        x32bd -= z11bd * y18 + z11b * y18d;
        y18b += z11b * (1.0 - x32);
        y18bd += z11bd * (1.0 - x32) - z11b * x32d;
        x32b += z11b * t124;
        x32bd += z11bd * t124 + z11b * t124d;
        t124b = z11b * x32;
        t124bd = z11bd * x32 + z11b * x32d;
        y18b += t124b * (1.0 / (1.0 + y18 * y18));
        /* its derivative by y */
        y18bd += t124bd * (1.0 / (1.0 + y18 * y18)) - t124b * (1.0 / (1.0 + y18 * y18) * (y18d * y18
            + y18 * y18d) / (1.0 + y18 * y18));
        b6b += y18b * x34;
        b6bd += y18bd * x34 + y18b * x34d;
        x34b = y18b * b6;
        x34bd = y18bd * b6 + y18b * b6d;
        tb121 = b6b / t123;
        tb121d = (b6bd - tb121 * t123d) * (1.0 / t123);
        x33b = tb121;
        x33bd = tb121d;
        t123b = -(tb121 * b6);
        t123bd = -(tb121d * b6 + tb121 * b6d);
        x31b += t123b * x30;
        /* its derivative by the slip */
        x31bd += t123bd * x30 + t123b * x30d;
        x30b += t123b * x31;
        x30bd += t123bd * x31 + t123b * x31d;
        tb119 = kab * kappa;
        tb119d = kabd * kappa + kab * kappad;
        tb120 = tb119 * m;
        tb120d = tb119d * m + tb119 * md;
        g0b = -(tb120 * m);
        g0bd = -(tb120d * m + tb120 * md);
        mb = -(tb120 * g0);
        mbd = -(tb120d * g0 + tb120 * g0d);
        mb += tb119 * (-g0 * m);
        mbd += tb119d * (-g0 * m) + tb119 * (-(g0d * m) - g0 * md);
        kappab = kab * (-g0 * m * m);
        kappabd = kabd * (-g0 * m * m) + kab * ((-(g0d * m) - g0 * md) * m + -g0 * m * md);
        p6b = mb * t122;
        p6bd = mbd * t122 + mb * t122d;
        t122b = mb * p6;
        t122bd = mbd * p6 + mb * p6d;
        tb118 = t122b / t121;
        tb118d = (t122bd - tb118 * t121d) * (1.0 / t121);
        t121b = -(tb118 * t122);
        t121bd = -(tb118d * t122 + tb118 * t122d);
        t120b = t121b * (1.0 / (2.0 * t121));
        t120bd = t121bd * (1.0 / (2.0 * t121)) - t121b * (1.0 / (2.0 * t121) * (2.0 * t121d) / (2.0
            * t121));
        x9b = t120b * x9;
        x9bd = t120bd * x9 + t120b * x9d;
        x9b += t120b * x9;
        x9bd += t120bd * x9 + t120b * x9d;
        p6b += x9b * kappa;
        p6bd += x9bd * kappa + x9b * kappad;
        kappab += x9b * p6;
        kappabd += x9bd * p6 + x9b * p6d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += p6b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += p6bd;
        tb109 = sb[i][0];
        tb109d = sbd[i][0];
        sb[i][0] = 0.0;
        sbd[i][0] = 0.0;
        tb110 = tb109 * (gy * (y0_3 * t115 * t119 * b5) + fy * wy1 * b2 - g8 * v2 * v2 * a2);
        tb110d = tb109d * (gy * (y0_3 * t115 * t119 * b5) + fy * wy1 * b2 - g8 * v2 * v2 * a2) +
            tb109 * (gyd * (y0_3 * t115 * t119 * b5) + gy * (((y0_3d * t115 + y0_3 * t115d) * t119 +
            y0_3 * t115 * t119d) * b5 + y0_3 * t115 * t119 * b5d) + ((fyd * wy1 + fy * wy1d) * b2 +
            fy * wy1 * b2d) - (((g8d * v2 + g8 * v2d) * v2 + g8 * v2 * v2d) * a2 + g8 * v2 * v2 *
            a2d));
        a2b = tb110 * a2;
        a2bd = tb110d * a2 + tb110 * a2d;
        a2b += tb110 * a2;
        a2bd += tb110d * a2 + tb110 * a2d;
        tb111 = tb109 * (1.0 + a2 * a2);
        tb111d = tb109d * (1.0 + a2 * a2) + tb109 * (a2d * a2 + a2 * a2d);
        gyb += tb111 * (y0_3 * t115 * t119 * b5);
        gybd += tb111d * (y0_3 * t115 * t119 * b5) + tb111 * (((y0_3d * t115 + y0_3 * t115d) * t119
            + y0_3 * t115 * t119d) * b5 + y0_3 * t115 * t119 * b5d);
        tb112 = tb111 * gy;
        tb112d = tb111d * gy + tb111 * gyd;
        tb113 = tb112 * b5;
        tb113d = tb112d * b5 + tb112 * b5d;
        tb114 = tb113 * t119;
        tb114d = tb113d * t119 + tb113 * t119d;
        y0_3b += tb114 * t115;
        y0_3bd += tb114d * t115 + tb114 * t115d;
        t115b = tb114 * y0_3;
        t115bd = tb114d * y0_3 + tb114 * y0_3d;
        t119b = tb113 * (y0_3 * t115);
        t119bd = tb113d * (y0_3 * t115) + tb113 * (y0_3d * t115 + y0_3 * t115d);
        b5b = tb112 * (y0_3 * t115 * t119);
        b5bd = tb112d * (y0_3 * t115 * t119) + tb112 * ((y0_3d * t115 + y0_3 * t115d) * t119 + y0_3
            * t115 * t119d);
        tb115 = tb111 * b2;
        tb115d = tb111d * b2 + tb111 * b2d;
        fyb += tb115 * wy1;
        fybd += tb115d * wy1 + tb115 * wy1d;
        wy1b = tb115 * fy;
        wy1bd = tb115d * fy + tb115 * fyd;
        b2b = tb111 * (fy * wy1);
        b2bd = tb111d * (fy * wy1) + tb111 * (fyd * wy1 + fy * wy1d);
        tb116 = tb111 * a2;
        tb116d = tb111d * a2 + tb111 * a2d;
        tb117 = tb116 * v2;
        tb117d = tb116d * v2 + tb116 * v2d;
        g8b -= tb117 * v2;
        g8bd -= tb117d * v2 + tb117 * v2d;
        v2b = -(tb117 * g8);
        v2bd = -(tb117d * g8 + tb117 * g8d);
        v2b -= tb116 * (g8 * v2);
        v2bd -= tb116d * (g8 * v2) + tb116 * (g8d * v2 + g8 * v2d);
        a2b -= tb111 * (g8 * v2 * v2);
        a2bd -= tb111d * (g8 * v2 * v2) + tb111 * ((g8d * v2 + g8 * v2d) * v2 + g8 * v2 * v2d);
        tb107 = t119b / t118;
        tb107d = (t119bd - tb107 * t118d) * (1.0 / t118);
        y1b = tb107 * (1.0 - y2_2 + t117);
        y1bd = tb107d * (1.0 - y2_2 + t117) + tb107 * (-y2_2d + t117d);
        tb108 = tb107 * y1;
        tb108d = tb107d * y1 + tb107 * y1d;
        y2_2b = -tb108;
        y2_2bd = -tb108d;
        t117b = tb108;
        t117bd = tb108d;
        t118b = -(tb107 * t119);
        t118bd = -(tb107d * t119 + tb107 * t119d);
        z10b = t118b * z10;
        z10bd = t118bd * z10 + t118b * z10d;
        z10b += t118b * z10;
        z10bd += t118bd * z10 + t118b * z10d;
        tb106 = t117b / t116;
        tb106d = (t117bd - tb106 * t116d) * (1.0 / t116);
        y2_2b += tb106;
        y2_2bd += tb106d;
        t116b = -(tb106 * t117);
        t116bd = -(tb106d * t117 + tb106 * t117d);
        y17b = t116b * y17;
        y17bd = t116bd * y17 + t116b * y17d;
        y17b += t116b * y17;
        y17bd += t116bd * y17 + t116b * y17d;
        t114b = -(t115b * sin(t114));
        t114bd = -(t115bd * sin(t114) + t115b * (cos(t114) * t114d));
        y1b += t114b * t113;
        y1bd += t114bd * t113 + t114b * t113d;
        t113b = t114b * y1;
        t113bd = t114bd * y1 + t114b * y1d;
        t112b = t113b * (1.0 / (1.0 + t112 * t112));
        t112bd = t113bd * (1.0 / (1.0 + t112 * t112)) - t113b * (1.0 / (1.0 + t112 * t112) * (t112d
            * t112 + t112 * t112d) / (1.0 + t112 * t112));
        y2_2b -= t112b * y17;
        y2_2bd -= t112bd * y17 + t112b * y17d;
        y17b += t112b * (1.0 - y2_2);
        y17bd += t112bd * (1.0 - y2_2) - t112b * y2_2d;
        y2_2b += t112b * t111;
        y2_2bd += t112bd * t111 + t112b * t111d;
        t111b = t112b * y2_2;
        t111bd = t112bd * y2_2 + t112b * y2_2d;
        y17b += t111b * (1.0 / (1.0 + y17 * y17));
        y17bd += t111bd * (1.0 / (1.0 + y17 * y17)) - t111b * (1.0 / (1.0 + y17 * y17) * (y17d * y17
            + y17 * y17d) / (1.0 + y17 * y17));
        y2_2b -= z10b * y17;
        y2_2bd -= z10bd * y17 + z10b * y17d;
        y17b += z10b * (1.0 - y2_2);
        y17bd += z10bd * (1.0 - y2_2) - z10b * y2_2d;
        y2_2b += z10b * t110;
        y2_2bd += z10bd * t110 + z10b * t110d;
        t110b = z10b * y2_2;
        t110bd = z10bd * y2_2 + z10b * y2_2d;
        y17b += t110b * (1.0 / (1.0 + y17 * y17));
        /* its derivative by y */
        y17bd += t110bd * (1.0 / (1.0 + y17 * y17)) - t110b * (1.0 / (1.0 + y17 * y17) * (y17d * y17
            + y17 * y17d) / (1.0 + y17 * y17));
        b5b += y17b * y4_2;
        b5bd += y17bd * y4_2 + y17b * y4_2d;
        y4_2b = y17b * b5;
        y4_2bd = y17bd * b5 + y17b * b5d;
        tb105 = b5b / t109;
        tb105d = (b5bd - tb105 * t109d) * (1.0 / t109);
        y3_2b = tb105;
        y3_2bd = tb105d;
        t109b = -(tb105 * b5);
        t109bd = -(tb105d * b5 + tb105 * b5d);
        y1b += t109b * y0_3;
        /* its derivative by the slip */
        y1bd += t109bd * y0_3 + t109b * y0_3d;
        y0_3b += t109b * y1;
        y0_3bd += t109bd * y1 + t109b * y1d;
        tb102 = b2b * (a2 - p5);
        tb102d = b2bd * (a2 - p5) + b2b * (a2d - p5d);
        tb103 = tb102 * l3;
        tb103d = tb102d * l3 + tb102 * l3d;
        g4b = -(tb103 * l3);
        g4bd = -(tb103d * l3 + tb103 * l3d);
        l3b = -(tb103 * g4);
        l3bd = -(tb103d * g4 + tb103 * g4d);
        l3b += tb102 * (-g4 * l3);
        l3bd += tb102d * (-g4 * l3) + tb102 * (-(g4d * l3) - g4 * l3d);
        tb104 = b2b * (-g4 * l3 * l3);
        tb104d = b2bd * (-g4 * l3 * l3) + b2b * ((-(g4d * l3) - g4 * l3d) * l3 + -g4 * l3 * l3d);
        a2b += tb104;
        a2bd += tb104d;
        p5b = -tb104;
        p5bd = -tb104d;
        p3b = v2b * t108;
        p3bd = v2bd * t108 + v2b * t108d;
        t108b = v2b * p3;
        t108bd = v2bd * p3 + v2b * p3d;
        tb101 = t108b / t107;
        tb101d = (t108bd - tb101 * t107d) * (1.0 / t107);
        t107b = -(tb101 * t108);
        t107bd = -(tb101d * t108 + tb101 * t108d);
        t106b = t107b * (1.0 / (2.0 * t107));
        t106bd = t107bd * (1.0 / (2.0 * t107)) - t107b * (1.0 / (2.0 * t107) * (2.0 * t107d) / (2.0
            * t107));
        x8b = t106b * x8;
        x8bd = t106bd * x8 + t106b * x8d;
        x8b += t106b * x8;
        x8bd += t106bd * x8 + t106b * x8d;
        p3b += x8b * a2;
        p3bd += x8bd * a2 + x8b * a2d;
        a2b += x8b * p3;
        a2bd += x8bd * p3 + x8b * p3d;
        p4b = l3b * t105;
        p4bd = l3bd * t105 + l3b * t105d;
        t105b = l3b * p4;
        t105bd = l3bd * p4 + l3b * p4d;
        tb100 = t105b / t104;
        tb100d = (t105bd - tb100 * t104d) * (1.0 / t104);
        t104b = -(tb100 * t105);
        t104bd = -(tb100d * t105 + tb100 * t105d);
        t103b = t104b * (1.0 / (2.0 * t104));
        t103bd = t104bd * (1.0 / (2.0 * t104)) - t104b * (1.0 / (2.0 * t104) * (2.0 * t104d) / (2.0
            * t104));
        x7b = t103b * x7;
        x7bd = t103bd * x7 + t103b * x7d;
        x7b += t103b * x7;
        x7bd += t103bd * x7 + t103b * x7d;
        p4b += x7b * (a2 - p5);
        /* b and the shift of Fy change with a by their cos(atan()) */
        p4bd += x7bd * (a2 - p5) + x7b * (a2d - p5d);
        tb99 = x7b * p4;
        tb99d = x7bd * p4 + x7b * p4d;
        a2b += tb99;
        a2bd += tb99d;
        p5b -= tb99;
        p5bd -= tb99d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] += p5b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] += p5bd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += p4b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += p4bd;
        y0_3b += fyb * t102;
        y0_3bd += fybd * t102 + fyb * t102d;
        t102b = fyb * y0_3;
        t102bd = fybd * y0_3 + fyb * y0_3d;
        y5_2b = fyb;
        y5_2bd = fybd;
        t101b = t102b * cos(t101);
        t101bd = t102bd * cos(t101) - t102b * (sin(t101) * t101d);
        y1b += t101b * t100;
        y1bd += t101bd * t100 + t101b * t100d;
        t100b = t101b * y1;
        t100bd = t101bd * y1 + t101b * y1d;
        t99b = t100b * (1.0 / (1.0 + t99 * t99));
        t99bd = t100bd * (1.0 / (1.0 + t99 * t99)) - t100b * (1.0 / (1.0 + t99 * t99) * (t99d * t99
            + t99 * t99d) / (1.0 + t99 * t99));
        y2_2b -= t99b * y16;
        y2_2bd -= t99bd * y16 + t99b * y16d;
        y16b = t99b * (1.0 - y2_2);
        y16bd = t99bd * (1.0 - y2_2) - t99b * y2_2d;
        y2_2b += t99b * t98;
        y2_2bd += t99bd * t98 + t99b * t98d;
        t98b = t99b * y2_2;
        t98bd = t99bd * y2_2 + t99b * y2_2d;
        y16b += t98b * (1.0 / (1.0 + y16 * y16));
        y16bd += t98bd * (1.0 / (1.0 + y16 * y16)) - t98b * (1.0 / (1.0 + y16 * y16) * (y16d * y16 +
            y16 * y16d) / (1.0 + y16 * y16));
        t97b = y16b * y4_2;
        t97bd = y16bd * y4_2 + y16b * y4_2d;
        y4_2b += y16b * t97;
        y4_2bd += y16bd * t97 + y16b * t97d;
        tb98 = t97b / t96;
        tb98d = (t97bd - tb98 * t96d) * (1.0 / t96);
        y3_2b += tb98;
        y3_2bd += tb98d;
        t96b = -(tb98 * t97);
        t96bd = -(tb98d * t97 + tb98 * t97d);
        y1b += t96b * y0_3;
        y1bd += t96bd * y0_3 + t96b * y0_3d;
        y0_3b += t96b * y1;
        y0_3bd += t96bd * y1 + t96b * y1d;
        x30b += fxb * t95;
        x30bd += fxbd * t95 + fxb * t95d;
        t95b = fxb * x30;
        t95bd = fxbd * x30 + fxb * x30d;
        x35b = fxb;
        x35bd = fxbd;
        t94b = t95b * cos(t94);
        t94bd = t95bd * cos(t94) - t95b * (sin(t94) * t94d);
        x31b += t94b * t93;
        x31bd += t94bd * t93 + t94b * t93d;
        t93b = t94b * x31;
        t93bd = t94bd * x31 + t94b * x31d;
        t92b = t93b * (1.0 / (1.0 + t92 * t92));
        t92bd = t93bd * (1.0 / (1.0 + t92 * t92)) - t93b * (1.0 / (1.0 + t92 * t92) * (t92d * t92 +
            t92 * t92d) / (1.0 + t92 * t92));
        x32b -= t92b * y15;
        x32bd -= t92bd * y15 + t92b * y15d;
        y15b = t92b * (1.0 - x32);
        y15bd = t92bd * (1.0 - x32) - t92b * x32d;
        x32b += t92b * t91;
        x32bd += t92bd * t91 + t92b * t91d;
        t91b = t92b * x32;
        t91bd = t92bd * x32 + t92b * x32d;
        y15b += t91b * (1.0 / (1.0 + y15 * y15));
        y15bd += t91bd * (1.0 / (1.0 + y15 * y15)) - t91b * (1.0 / (1.0 + y15 * y15) * (y15d * y15 +
            y15 * y15d) / (1.0 + y15 * y15));
        t90b = y15b * x34;
        t90bd = y15bd * x34 + y15b * x34d;
        x34b += y15b * t90;
        x34bd += y15bd * t90 + y15b * t90d;
        tb97 = t90b / t89;
        tb97d = (t90bd - tb97 * t89d) * (1.0 / t89);
        x33b += tb97;
        x33bd += tb97d;
        t89b = -(tb97 * t90);
        t89bd = -(tb97d * t90 + tb97 * t90d);
        x31b += t89b * x30;
        x31bd += t89bd * x30 + t89b * x30d;
        x30b += t89b * x31;
        x30bd += t89bd * x31 + t89b * x31d;
        s3b = wy1b * (kappa + shift2);
        s3bd = wy1bd * (kappa + shift2) + wy1b * (kappad + shift2d);
        tb95 = wy1b * s3;
        tb95d = wy1bd * s3 + wy1b * s3d;
        kappab += tb95;
        kappabd += tb95d;
        shift2b = tb95;
        shift2bd = tb95d;
        tb96 = wy1b * shift2;
        tb96d = wy1bd * shift2 + wy1b * shift2d;
        t84b = tb96 * t88;
        t84bd = tb96d * t88 + tb96 * t88d;
        t88b = tb96 * t84;
        t88bd = tb96d * t84 + tb96 * t84d;
        shift2b += wy1b * (t84 * t88);
        shift2bd += wy1bd * (t84 * t88) + wy1b * (t84d * t88 + t84 * t88d);
        tb93 = t88b / t87;
        tb93d = (t88bd - tb93 * t87d) * (1.0 / t87);
        c3b = tb93 * (1.0 - e12 + t86);
        c3bd = tb93d * (1.0 - e12 + t86) + tb93 * (-e12d + t86d);
        tb94 = tb93 * c3;
        tb94d = tb93d * c3 + tb93 * c3d;
        e12b = -tb94;
        e12bd = -tb94d;
        t86b = tb94;
        t86bd = tb94d;
        t87b = -(tb93 * t88);
        t87bd = -(tb93d * t88 + tb93 * t88d);
        z9b = t87b * z9;
        z9bd = t87bd * z9 + t87b * z9d;
        z9b += t87b * z9;
        z9bd += t87bd * z9 + t87b * z9d;
        tb92 = t86b / t85;
        tb92d = (t86bd - tb92 * t85d) * (1.0 / t85);
        e12b += tb92;
        e12bd += tb92d;
        t85b = -(tb92 * t86);
        t85bd = -(tb92d * t86 + tb92 * t86d);
        y0_2b = t85b * y0_2;
        y0_2bd = t85bd * y0_2 + t85b * y0_2d;
        y0_2b += t85b * y0_2;
        y0_2bd += t85bd * y0_2 + t85b * y0_2d;
        tb91 = t84b / t83;
        tb91d = (t84bd - tb91 * t83d) * (1.0 / t83);
        t81b = tb91 * t82;
        t81bd = tb91d * t82 + tb91 * t82d;
        t82b = tb91 * t81;
        t82bd = tb91d * t81 + tb91 * t81d;
        t83b = -(tb91 * t84);
        t83bd = -(tb91d * t84 + tb91 * t84d);
        n5b = t83b * n5;
        n5bd = t83bd * n5 + t83b * n5d;
        n5b += t83b * n5;
        n5bd += t83bd * n5 + t83b * n5d;
        z0_2b = t82b * cos(z0_2);
        z0_2bd = t82bd * cos(z0_2) - t82b * (sin(z0_2) * z0_2d);
        z7b = -(t81b * sin(z7));
        z7bd = -(t81bd * sin(z7) + t81b * (cos(z7) * z7d));
        e12b -= z9b * y0_2;
        e12bd -= z9bd * y0_2 + z9b * y0_2d;
        y0_2b += z9b * (1.0 - e12);
        y0_2bd += z9bd * (1.0 - e12) - z9b * e12d;
        e12b += z9b * t80;
        e12bd += z9bd * t80 + z9b * t80d;
        t80b = z9b * e12;
        t80bd = z9bd * e12 + z9b * e12d;
        y0_2b += t80b * (1.0 / (1.0 + y0_2 * y0_2));
        /* its derivative by y */
        y0_2bd += t80bd * (1.0 / (1.0 + y0_2 * y0_2)) - t80b * (1.0 / (1.0 + y0_2 * y0_2) * (y0_2d *
            y0_2 + y0_2 * y0_2d) / (1.0 + y0_2 * y0_2));
        tb90 = s3b / n5;
        tb90d = (s3bd - tb90 * n5d) * (1.0 / n5);
        t75b = -(tb90 * t79);
        t75bd = -(tb90d * t79 + tb90 * t79d);
        t79b = -(tb90 * t75);
        t79bd = -(tb90d * t75 + tb90 * t75d);
        n5b -= tb90 * s3;
        n5bd -= tb90d * s3 + tb90 * s3d;
        tb88 = t79b / t78;
        tb88d = (t79bd - tb88 * t78d) * (1.0 / t78);
        c3b += tb88 * (1.0 - e12 + t77);
        c3bd += tb88d * (1.0 - e12 + t77) + tb88 * (-e12d + t77d);
        tb89 = tb88 * c3;
        tb89d = tb88d * c3 + tb88 * c3d;
        e12b -= tb89;
        e12bd -= tb89d;
        t77b = tb89;
        t77bd = tb89d;
        t78b = -(tb88 * t79);
        t78bd = -(tb88d * t79 + tb88 * t79d);
        z8b = t78b * z8;
        z8bd = t78bd * z8 + t78b * z8d;
        z8b += t78b * z8;
        z8bd += t78bd * z8 + t78b * z8d;
        tb87 = t77b / t76;
        tb87d = (t77bd - tb87 * t76d) * (1.0 / t76);
        e12b += tb87;
        e12bd += tb87d;
        t76b = -(tb87 * t77);
        t76bd = -(tb87d * t77 + tb87 * t77d);
        y14b = t76b * y14;
        y14bd = t76bd * y14 + t76b * y14d;
        y14b += t76b * y14;
        y14bd += t76bd * y14 + t76b * y14d;
        z7b += t75b * cos(z7);
        z7bd += t75bd * cos(z7) - t75b * (sin(z7) * z7d);
        e12b -= z8b * y14;
        e12bd -= z8bd * y14 + z8b * y14d;
        y14b += z8b * (1.0 - e12);
        y14bd += z8bd * (1.0 - e12) - z8b * e12d;
        e12b += z8b * t74;
        e12bd += z8bd * t74 + z8b * t74d;
        t74b = z8b * e12;
        t74bd = z8bd * e12 + z8b * e12d;
        y14b += t74b * (1.0 / (1.0 + y14 * y14));
        /* its derivative by y */
        y14bd += t74bd * (1.0 / (1.0 + y14 * y14)) - t74b * (1.0 / (1.0 + y14 * y14) * (y14d * y14 +
            y14 * y14d) / (1.0 + y14 * y14));
        z0_2b -= n5b * sin(z0_2);
        z0_2bd -= n5bd * sin(z0_2) + n5b * (cos(z0_2) * z0_2d);
        c3b += z0_2b * t73;
        c3bd += z0_2bd * t73 + z0_2b * t73d;
        t73b = z0_2b * c3;
        t73bd = z0_2bd * c3 + z0_2b * c3d;
        t72b = t73b * (1.0 / (1.0 + t72 * t72));
        t72bd = t73bd * (1.0 / (1.0 + t72 * t72)) - t73b * (1.0 / (1.0 + t72 * t72) * (t72d * t72 +
            t72 * t72d) / (1.0 + t72 * t72));
        e12b -= t72b * y0_2;
        e12bd -= t72bd * y0_2 + t72b * y0_2d;
        y0_2b += t72b * (1.0 - e12);
        y0_2bd += t72bd * (1.0 - e12) - t72b * e12d;
        e12b += t72b * t71;
        e12bd += t72bd * t71 + t72b * t71d;
        t71b = t72b * e12;
        t71bd = t72bd * e12 + t72b * e12d;
        y0_2b += t71b * (1.0 / (1.0 + y0_2 * y0_2));
        y0_2bd += t71bd * (1.0 / (1.0 + y0_2 * y0_2)) - t71b * (1.0 / (1.0 + y0_2 * y0_2) * (y0_2d *
            y0_2 + y0_2 * y0_2d) / (1.0 + y0_2 * y0_2));
        c3b += z7b * t70;
        c3bd += z7bd * t70 + z7b * t70d;
        t70b = z7b * c3;
        t70bd = z7bd * c3 + z7b * c3d;
        t69b = t70b * (1.0 / (1.0 + t69 * t69));
        t69bd = t70bd * (1.0 / (1.0 + t69 * t69)) - t70b * (1.0 / (1.0 + t69 * t69) * (t69d * t69 +
            t69 * t69d) / (1.0 + t69 * t69));
        e12b -= t69b * y14;
        e12bd -= t69bd * y14 + t69b * y14d;
        y14b += t69b * (1.0 - e12);
        y14bd += t69bd * (1.0 - e12) - t69b * e12d;
        e12b += t69b * t68;
        e12bd += t69bd * t68 + t69b * t68d;
        t68b = t69b * e12;
        t68bd = t69bd * e12 + t69b * e12d;
        y14b += t68b * (1.0 / (1.0 + y14 * y14));
        y14bd += t68bd * (1.0 / (1.0 + y14 * y14)) - t68b * (1.0 / (1.0 + y14 * y14) * (y14d * y14 +
            y14 * y14d) / (1.0 + y14 * y14));
        b4b = y0_2b * shift2;
        b4bd = y0_2bd * shift2 + y0_2b * shift2d;
        shift2b += y0_2b * b4;
        shift2bd += y0_2bd * b4 + y0_2b * b4d;
        b4b += y14b * (kappa + shift2);
        /* its derivatives by x and by b */
        b4bd += y14bd * (kappa + shift2) + y14b * (kappad + shift2d);
        tb86 = y14b * b4;
        tb86d = y14bd * b4 + y14b * b4d;
        kappab += tb86;
        kappabd += tb86d;
        shift2b += tb86;
        shift2bd += tb86d;
        g7b = shift2b;
        g7bd = shift2bd;
        g6b = e12b;
        g6bd = e12bd;
        g5b = c3b;
        g5bd = c3bd;
        g4b += b4b;
        g4bd += b4bd;
        s2b = wx1b * (a2 + shift);
        s2bd = wx1bd * (a2 + shift) + wx1b * (a2d + shiftd);
        tb84 = wx1b * s2;
        tb84d = wx1bd * s2 + wx1b * s2d;
        a2b += tb84;
        a2bd += tb84d;
        shiftb = tb84;
        shiftbd = tb84d;
        tb85 = wx1b * shift;
        tb85d = wx1bd * shift + wx1b * shiftd;
        t63b = tb85 * t67;
        t63bd = tb85d * t67 + tb85 * t67d;
        t67b = tb85 * t63;
        t67bd = tb85d * t63 + tb85 * t63d;
        shiftb += wx1b * (t63 * t67);
        shiftbd += wx1bd * (t63 * t67) + wx1b * (t63d * t67 + t63 * t67d);
        tb82 = t67b / t66;
        tb82d = (t67bd - tb82 * t66d) * (1.0 / t66);
        cb = tb82 * (1.0 - e11 + t65);
        cbd = tb82d * (1.0 - e11 + t65) + tb82 * (-e11d + t65d);
        tb83 = tb82 * c;
        tb83d = tb82d * c + tb82 * cd;
        e11b = -tb83;
        e11bd = -tb83d;
        t65b = tb83;
        t65bd = tb83d;
        t66b = -(tb82 * t67);
        t66bd = -(tb82d * t67 + tb82 * t67d);
        z6b = t66b * z6;
        z6bd = t66bd * z6 + t66b * z6d;
        z6b += t66b * z6;
        z6bd += t66bd * z6 + t66b * z6d;
        tb81 = t65b / t64;
        tb81d = (t65bd - tb81 * t64d) * (1.0 / t64);
        e11b += tb81;
        e11bd += tb81d;
        t64b = -(tb81 * t65);
        t64bd = -(tb81d * t65 + tb81 * t65d);
        y0b = t64b * y0;
        y0bd = t64bd * y0 + t64b * y0d;
        y0b += t64b * y0;
        y0bd += t64bd * y0 + t64b * y0d;
        tb80 = t63b / t62;
        tb80d = (t63bd - tb80 * t62d) * (1.0 / t62);
        t60b = tb80 * t61;
        t60bd = tb80d * t61 + tb80 * t61d;
        t61b = tb80 * t60;
        t61bd = tb80d * t60 + tb80 * t60d;
        t62b = -(tb80 * t63);
        t62bd = -(tb80d * t63 + tb80 * t63d);
        n4b = t62b * n4;
        n4bd = t62bd * n4 + t62b * n4d;
        n4b += t62b * n4;
        n4bd += t62bd * n4 + t62b * n4d;
        z0b = t61b * cos(z0);
        z0bd = t61bd * cos(z0) - t61b * (sin(z0) * z0d);
        z4b = -(t60b * sin(z4));
        z4bd = -(t60bd * sin(z4) + t60b * (cos(z4) * z4d));
        e11b -= z6b * y0;
        e11bd -= z6bd * y0 + z6b * y0d;
        y0b += z6b * (1.0 - e11);
        y0bd += z6bd * (1.0 - e11) - z6b * e11d;
        e11b += z6b * t59;
        e11bd += z6bd * t59 + z6b * t59d;
        t59b = z6b * e11;
        t59bd = z6bd * e11 + z6b * e11d;
        y0b += t59b * (1.0 / (1.0 + y0 * y0));
        /* its derivative by y */
        y0bd += t59bd * (1.0 / (1.0 + y0 * y0)) - t59b * (1.0 / (1.0 + y0 * y0) * (y0d * y0 + y0 *
            y0d) / (1.0 + y0 * y0));
        tb79 = s2b / n4;
        tb79d = (s2bd - tb79 * n4d) * (1.0 / n4);
        t54b = -(tb79 * t58);
        t54bd = -(tb79d * t58 + tb79 * t58d);
        t58b = -(tb79 * t54);
        t58bd = -(tb79d * t54 + tb79 * t54d);
        n4b -= tb79 * s2;
        n4bd -= tb79d * s2 + tb79 * s2d;
        tb77 = t58b / t57;
        tb77d = (t58bd - tb77 * t57d) * (1.0 / t57);
        cb += tb77 * (1.0 - e11 + t56);
        cbd += tb77d * (1.0 - e11 + t56) + tb77 * (-e11d + t56d);
        tb78 = tb77 * c;
        tb78d = tb77d * c + tb77 * cd;
        e11b -= tb78;
        e11bd -= tb78d;
        t56b = tb78;
        t56bd = tb78d;
        t57b = -(tb77 * t58);
        t57bd = -(tb77d * t58 + tb77 * t58d);
        z5b = t57b * z5;
        z5bd = t57bd * z5 + t57b * z5d;
        z5b += t57b * z5;
        z5bd += t57bd * z5 + t57b * z5d;
        tb76 = t56b / t55;
        tb76d = (t56bd - tb76 * t55d) * (1.0 / t55);
        e11b += tb76;
        e11bd += tb76d;
        t55b = -(tb76 * t56);
        t55bd = -(tb76d * t56 + tb76 * t56d);
        y13b = t55b * y13;
        y13bd = t55bd * y13 + t55b * y13d;
        y13b += t55b * y13;
        y13bd += t55bd * y13 + t55b * y13d;
        z4b += t54b * cos(z4);
        z4bd += t54bd * cos(z4) - t54b * (sin(z4) * z4d);
        e11b -= z5b * y13;
        e11bd -= z5bd * y13 + z5b * y13d;
        y13b += z5b * (1.0 - e11);
        y13bd += z5bd * (1.0 - e11) - z5b * e11d;
        e11b += z5b * t53;
        e11bd += z5bd * t53 + z5b * t53d;
        t53b = z5b * e11;
        t53bd = z5bd * e11 + z5b * e11d;
        y13b += t53b * (1.0 / (1.0 + y13 * y13));
        /* its derivative by y */
        y13bd += t53bd * (1.0 / (1.0 + y13 * y13)) - t53b * (1.0 / (1.0 + y13 * y13) * (y13d * y13 +
            y13 * y13d) / (1.0 + y13 * y13));
        z0b -= n4b * sin(z0);
        z0bd -= n4bd * sin(z0) + n4b * (cos(z0) * z0d);
        cb += z0b * t52;
        cbd += z0bd * t52 + z0b * t52d;
        t52b = z0b * c;
        t52bd = z0bd * c + z0b * cd;
        t51b = t52b * (1.0 / (1.0 + t51 * t51));
        t51bd = t52bd * (1.0 / (1.0 + t51 * t51)) - t52b * (1.0 / (1.0 + t51 * t51) * (t51d * t51 +
            t51 * t51d) / (1.0 + t51 * t51));
        e11b -= t51b * y0;
        e11bd -= t51bd * y0 + t51b * y0d;
        y0b += t51b * (1.0 - e11);
        y0bd += t51bd * (1.0 - e11) - t51b * e11d;
        e11b += t51b * t50;
        e11bd += t51bd * t50 + t51b * t50d;
        t50b = t51b * e11;
        t50bd = t51bd * e11 + t51b * e11d;
        y0b += t50b * (1.0 / (1.0 + y0 * y0));
        y0bd += t50bd * (1.0 / (1.0 + y0 * y0)) - t50b * (1.0 / (1.0 + y0 * y0) * (y0d * y0 + y0 *
            y0d) / (1.0 + y0 * y0));
        cb += z4b * t49;
        cbd += z4bd * t49 + z4b * t49d;
        t49b = z4b * c;
        t49bd = z4bd * c + z4b * cd;
        t48b = t49b * (1.0 / (1.0 + t48 * t48));
        t48bd = t49bd * (1.0 / (1.0 + t48 * t48)) - t49b * (1.0 / (1.0 + t48 * t48) * (t48d * t48 +
            t48 * t48d) / (1.0 + t48 * t48));
        e11b -= t48b * y13;
        e11bd -= t48bd * y13 + t48b * y13d;
        y13b += t48b * (1.0 - e11);
        y13bd += t48bd * (1.0 - e11) - t48b * e11d;
        e11b += t48b * t47;
        e11bd += t48bd * t47 + t48b * t47d;
        t47b = t48b * e11;
        t47bd = t48bd * e11 + t48b * e11d;
        y13b += t47b * (1.0 / (1.0 + y13 * y13));
        y13bd += t47bd * (1.0 / (1.0 + y13 * y13)) - t47b * (1.0 / (1.0 + y13 * y13) * (y13d * y13 +
            y13 * y13d) / (1.0 + y13 * y13));
        b3b = y0b * shift;
        b3bd = y0bd * shift + y0b * shiftd;
        shiftb += y0b * b3;
        shiftbd += y0bd * b3 + y0b * b3d;
        b3b += y13b * (a2 + shift);
        /* its derivatives by x and by b */
        b3bd += y13bd * (a2 + shift) + y13b * (a2d + shiftd);
        tb75 = y13b * b3;
        tb75d = y13bd * b3 + y13b * b3d;
        a2b += tb75;
        a2bd += tb75d;
        shiftb += tb75;
        shiftbd += tb75d;
        g3b = shiftb;
        g3bd = shiftbd;
        g2b = e11b;
        g2bd = e11bd;
        g1b = cb;
        g1bd = cbd;
        g0b += b3b;
        g0bd += b3bd;
        tb74 = gyb / t46;
        tb74d = (gybd - tb74 * t46d) * (1.0 / t46);
        t41b = tb74;
        t41bd = tb74d;
        t46b = -(tb74 * gy);
        t46bd = -(tb74d * gy + tb74 * gyd);
        t45b = -(t46b * sin(t45));
        t45bd = -(t46bd * sin(t45) + t46b * (cos(t45) * t45d));
        g5b += t45b * t44;
        g5bd += t45bd * t44 + t45b * t44d;
        t44b = t45b * g5;
        t44bd = t45bd * g5 + t45b * g5d;
        t43b = t44b * (1.0 / (1.0 + t43 * t43));
        t43bd = t44bd * (1.0 / (1.0 + t43 * t43)) - t44b * (1.0 / (1.0 + t43 * t43) * (t43d * t43 +
            t43 * t43d) / (1.0 + t43 * t43));
        g6b -= t43b * y12;
        g6bd -= t43bd * y12 + t43b * y12d;
        y12b = t43b * (1.0 - g6);
        y12bd = t43bd * (1.0 - g6) - t43b * g6d;
        g6b += t43b * t42;
        g6bd += t43bd * t42 + t43b * t42d;
        t42b = t43b * g6;
        t42bd = t43bd * g6 + t43b * g6d;
        y12b += t42b * (1.0 / (1.0 + y12 * y12));
        y12bd += t42bd * (1.0 / (1.0 + y12 * y12)) - t42b * (1.0 / (1.0 + y12 * y12) * (y12d * y12 +
            y12 * y12d) / (1.0 + y12 * y12));
        t40b = -(t41b * sin(t40));
        t40bd = -(t41bd * sin(t40) + t41b * (cos(t40) * t40d));
        g5b += t40b * t39;
        g5bd += t40bd * t39 + t40b * t39d;
        t39b = t40b * g5;
        t39bd = t40bd * g5 + t40b * g5d;
        t38b = t39b * (1.0 / (1.0 + t38 * t38));
        t38bd = t39bd * (1.0 / (1.0 + t38 * t38)) - t39b * (1.0 / (1.0 + t38 * t38) * (t38d * t38 +
            t38 * t38d) / (1.0 + t38 * t38));
        g6b -= t38b * y11;
        g6bd -= t38bd * y11 + t38b * y11d;
        y11b = t38b * (1.0 - g6);
        y11bd = t38bd * (1.0 - g6) - t38b * g6d;
        g6b += t38b * t37;
        g6bd += t38bd * t37 + t38b * t37d;
        t37b = t38b * g6;
        t37bd = t38bd * g6 + t38b * g6d;
        y11b += t37b * (1.0 / (1.0 + y11 * y11));
        y11bd += t37bd * (1.0 / (1.0 + y11 * y11)) - t37b * (1.0 / (1.0 + y11 * y11) * (y11d * y11 +
            y11 * y11d) / (1.0 + y11 * y11));
        g4b += y12b * g7;
        g4bd += y12bd * g7 + y12b * g7d;
        g7b += y12b * g4;
        g7bd += y12bd * g4 + y12b * g4d;
        g4b += y11b * (kappa + g7);
        g4bd += y11bd * (kappa + g7) + y11b * (kappad + g7d);
        tb73 = y11b * g4;
        tb73d = y11bd * g4 + y11b * g4d;
        kappab += tb73;
        kappabd += tb73d;
        g7b += tb73;
        g7bd += tb73d;
        tb72 = gxb / t36;
        tb72d = (gxbd - tb72 * t36d) * (1.0 / t36);
        t31b = tb72;
        t31bd = tb72d;
        t36b = -(tb72 * gx);
        t36bd = -(tb72d * gx + tb72 * gxd);
        t35b = -(t36b * sin(t35));
        t35bd = -(t36bd * sin(t35) + t36b * (cos(t35) * t35d));
        g1b += t35b * t34;
        g1bd += t35bd * t34 + t35b * t34d;
        t34b = t35b * g1;
        t34bd = t35bd * g1 + t35b * g1d;
        t33b = t34b * (1.0 / (1.0 + t33 * t33));
        t33bd = t34bd * (1.0 / (1.0 + t33 * t33)) - t34b * (1.0 / (1.0 + t33 * t33) * (t33d * t33 +
            t33 * t33d) / (1.0 + t33 * t33));
        g2b -= t33b * y10;
        g2bd -= t33bd * y10 + t33b * y10d;
        y10b = t33b * (1.0 - g2);
        y10bd = t33bd * (1.0 - g2) - t33b * g2d;
        g2b += t33b * t32;
        g2bd += t33bd * t32 + t33b * t32d;
        t32b = t33b * g2;
        t32bd = t33bd * g2 + t33b * g2d;
        y10b += t32b * (1.0 / (1.0 + y10 * y10));
        y10bd += t32bd * (1.0 / (1.0 + y10 * y10)) - t32b * (1.0 / (1.0 + y10 * y10) * (y10d * y10 +
            y10 * y10d) / (1.0 + y10 * y10));
        t30b = -(t31b * sin(t30));
        t30bd = -(t31bd * sin(t30) + t31b * (cos(t30) * t30d));
        g1b += t30b * t29;
        g1bd += t30bd * t29 + t30b * t29d;
        t29b = t30b * g1;
        t29bd = t30bd * g1 + t30b * g1d;
        t28b = t29b * (1.0 / (1.0 + t28 * t28));
        t28bd = t29bd * (1.0 / (1.0 + t28 * t28)) - t29b * (1.0 / (1.0 + t28 * t28) * (t28d * t28 +
            t28 * t28d) / (1.0 + t28 * t28));
        g2b -= t28b * y9;
        g2bd -= t28bd * y9 + t28b * y9d;
        y9b = t28b * (1.0 - g2);
        y9bd = t28bd * (1.0 - g2) - t28b * g2d;
        g2b += t28b * t27;
        g2bd += t28bd * t27 + t28b * t27d;
        t27b = t28b * g2;
        t27bd = t28bd * g2 + t28b * g2d;
        y9b += t27b * (1.0 / (1.0 + y9 * y9));
        y9bd += t27bd * (1.0 / (1.0 + y9 * y9)) - t27b * (1.0 / (1.0 + y9 * y9) * (y9d * y9 + y9 *
            y9d) / (1.0 + y9 * y9));
        g0b += y10b * g3;
        g0bd += y10bd * g3 + y10b * g3d;
        g3b += y10b * g0;
        g3bd += y10bd * g0 + y10b * g0d;
        g0b += y9b * (a2 + g3);
        g0bd += y9bd * (a2 + g3) + y9b * (a2d + g3d);
        tb71 = y9b * g0;
        tb71d = y9bd * g0 + y9b * g0d;
        a2b += tb71;
        a2bd += tb71d;
        g3b += tb71;
        g3bd += tb71d;
        tb70 = g8b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        tb70d = g8bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + g8b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        dvb = tb70 * t26;
        dvbd = tb70d * t26 + tb70 * t26d;
        t26b = tb70 * dv;
        t26bd = tb70d * dv + tb70 * dvd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g8b * (dv * t26);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g8bd * (dv * t26) + g8b * (dvd * t26
            + dv * t26d);
        t25b = t26b * cos(t25);
        t25bd = t26bd * cos(t25) - t26b * (sin(t25) * t25d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t25b * t24;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t25bd * t24 + t25b * t24d;
        t24b = t25b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
        t24bd = t25bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] + t25b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
        t23b = t24b * (1.0 / (1.0 + t23 * t23));
        t23bd = t24bd * (1.0 / (1.0 + t23 * t23)) - t24b * (1.0 / (1.0 + t23 * t23) * (t23d * t23 +
            t23 * t23d) / (1.0 + t23 * t23));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t23b * kappa;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t23bd * kappa + t23b * kappad;
        kappab += t23b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
        kappabd += t23bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] + t23b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
        tb68 = dvb * t22;
        tb68d = dvbd * t22 + dvb * t22d;
        peakb = tb68 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma);
        peakbd = tb68d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) + tb68 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1]
            + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gammad));
        tb69 = tb68 * peak;
        tb69d = tb68d * peak + tb68 * peakd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb69;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb69d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb69 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb69d * dfz + tb69 * dfzd;
        dfzb = tb69 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
        dfzbd = tb69d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] + tb69 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb69 * gamma;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb69d * gamma + tb69 * gammad;
        gammab = tb69 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
        gammabd = tb69d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] + tb69 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
        t22b = dvb * (peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma));
        t22bd = dvbd * (peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma)) + dvb * (peakd * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma) + peak *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gammad)));
        tb67 = t22b / t21;
        tb67d = (t22bd - tb67 * t21d) * (1.0 / t21);
        t21b = -(tb67 * t22);
        t21bd = -(tb67d * t22 + tb67 * t22d);
        t20b = t21b * (1.0 / (2.0 * t21));
        t20bd = t21bd * (1.0 / (2.0 * t21)) - t21b * (1.0 / (2.0 * t21) * (2.0 * t21d) / (2.0 *
            t21));
        x6b = t20b * x6;
        x6bd = t20bd * x6 + t20b * x6d;
        x6b += t20b * x6;
        x6bd += t20bd * x6 + t20b * x6d;
        p3b += x6b * a2;
        p3bd += x6bd * a2 + x6b * a2d;
        a2b += x6b * p3;
        a2bd += x6bd * p3 + x6b * p3d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] += p3b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] += p3bd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] += g7b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] += g7bd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] += g7b * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] += g7bd * dfz + g7b * dfzd;
        dfzb += g7b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2];
        dfzbd += g7bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] + g7b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2];
        y8b = g6b;
        y8bd = g6bd;
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
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += g5b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += g5bd;
        tb66 = g4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        tb66d = g4bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + g4b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb66 * t19;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb66d * t19 + tb66 * t19d;
        t19b = tb66 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
        t19bd = tb66d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] + tb66 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += g4b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RBY1] * t19);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += g4bd *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19) + g4b *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19d);
        tb65 = t19b / t18;
        tb65d = (t19bd - tb65 * t18d) * (1.0 / t18);
        t18b = -(tb65 * t19);
        t18bd = -(tb65d * t19 + tb65 * t19d);
        t17b = t18b * (1.0 / (2.0 * t18));
        t17bd = t18bd * (1.0 / (2.0 * t18)) - t18b * (1.0 / (2.0 * t18) * (2.0 * t18d) / (2.0 *
            t18));
        x5b = t17b * x5;
        x5bd = t17bd * x5 + t17b * x5d;
        x5b += t17b * x5;
        x5bd += t17bd * x5 + t17b * x5d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x5b * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x5bd * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + x5b * (a2d -
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        tb64 = x5b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        tb64d = x5bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] + x5b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        a2b += tb64;
        a2bd += tb64d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb64;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb64d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1] += g3b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1] += g3bd;
        y7b = g2b;
        y7bd = g2bd;
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
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += g1b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += g1bd;
        tb63 = g0b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        tb63d = g0bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + g0b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb63 * t16;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb63d * t16 + tb63 * t16d;
        t16b = tb63 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
        t16bd = tb63d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] + tb63 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += g0b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RBX1] * t16);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += g0bd *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16) + g0b *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16d);
        tb62 = t16b / t15;
        tb62d = (t16bd - tb62 * t15d) * (1.0 / t15);
        t15b = -(tb62 * t16);
        t15bd = -(tb62d * t16 + tb62 * t16d);
        t14b = t15b * (1.0 / (2.0 * t15));
        t14bd = t15bd * (1.0 / (2.0 * t15)) - t15b * (1.0 / (2.0 * t15) * (2.0 * t15d) / (2.0 *
            t15));
        x4b = t14b * x4;
        x4bd = t14bd * x4 + t14b * x4d;
        x4b += t14b * x4;
        x4bd += t14bd * x4 + t14b * x4d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x4b * kappa;
        /* what combined slip makes of the forces:  Fx = Gxa Fx0, Fy = Gyk Fy0 + SVyk.  g: b, c, e, shift of Gxa,
         * then of Gyk, SVyk */
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x4bd * kappa + x4b * kappad;
        kappab += x4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        kappabd += x4bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] + x4b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        y0_3b += peakb;
        y0_3bd += peakbd;
        tb58 = y5_2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        tb58d = y5_2bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + y5_2b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        fzb = tb58 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2);
        fzbd = tb58d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) +
            tb58 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd)) * gy2 +
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY4] * dfz) * gy2d));
        tb59 = tb58 * fz;
        tb59d = tb58d * fz + tb58 * fzd;
        tb60 = tb59 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
        tb60d = tb59d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + tb59 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb60;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb60d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb60 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb60d * dfz + tb60 * dfzd;
        dfzb += tb60 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
        dfzbd += tb60d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] + tb60 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb59 * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb59d *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY2] * dfz) + tb59 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd));
        tb61 = tb59 * gy2;
        tb61d = tb59d * gy2 + tb59 * gy2d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb61;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb61d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb61 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb61d * dfz + tb61 * dfzd;
        dfzb += tb61 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
        dfzbd += tb61d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] + tb61 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
        gy2b = tb59 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz);
        gy2bd = tb59d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) + tb59 *
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
        tb54 = y3_2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
        tb54d = y3_2bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + y3_2b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
        tb55 = tb54 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6);
        tb55d = tb54d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) - tb54 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6d);
        tb56 = tb55 * t13;
        tb56d = tb55d * t13 + tb55 * t13d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb56 * fz0_2;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb56d * fz0_2 + tb56 * fz0_2d;
        fz0_2b = tb56 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
        fz0_2bd = tb56d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] + tb56 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
        t13b = tb55 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2);
        t13bd = tb55d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2) + tb55 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d);
        tb57 = tb54 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13);
        tb57d = tb54d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13) + tb54 *
            ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d) * t13 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb57 * y6;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb57d * y6 + tb57 * y6d;
        y6b = -(tb57 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
        y6bd = -(tb57d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] + tb57 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += y3_2b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKY3] * y6));
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += y3_2bd *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6)) + y3_2b *
            (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d) * t13 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) - p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] *
            y6 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6d));
        tb53 = t13b / t12;
        tb53d = (t13bd - tb53 * t12d) * (1.0 / t12);
        z2b = tb53 * 2.0;
        z2bd = tb53d * 2.0;
        t12b = -(tb53 * t13);
        t12bd = -(tb53d * t13 + tb53 * t13d);
        z2b += t12b * z2;
        z2bd += t12bd * z2 + t12b * z2d;
        z2b += t12b * z2;
        z2bd += t12bd * z2 + t12b * z2d;
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
          t11 = p2 * p2;
          t11d = p2d * p2 + p2 * p2d;
          z3 = gy2 * gy2 / t11;
          z3d = (gy2d * gy2 + gy2 * gy2d - z3 * t11d) * (1.0 / t11);
          tb51 = y6b * (15.0 + z3 * (-10.0 + 3.0 * z3));
          tb51d = y6bd * (15.0 + z3 * (-10.0 + 3.0 * z3)) + y6b * (z3d * (-10.0 + 3.0 * z3) + z3 *
              (3.0 * z3d));
          p2b = tb51 * z3 * 0.125;
          p2bd = (tb51d * z3 + tb51 * z3d) * 0.125;
          z3b = tb51 * (0.125 * p2);
          z3bd = tb51d * (0.125 * p2) + tb51 * (0.125 * p2d);
          tb52 = y6b * (0.125 * p2 * z3);
          tb52d = y6bd * (0.125 * p2 * z3) + y6b * (0.125 * p2d * z3 + 0.125 * p2 * z3d);
          z3b += tb52 * (-10.0 + 3.0 * z3);
          z3bd += tb52d * (-10.0 + 3.0 * z3) + tb52 * (3.0 * z3d);
          z3b += tb52 * z3 * 3.0;
          z3bd += (tb52d * z3 + tb52 * z3d) * 3.0;
          y6b = 0.0;
          y6bd = 0.0;
          tb50 = z3b / t11;
          tb50d = (z3bd - tb50 * t11d) * (1.0 / t11);
          gy2b += tb50 * gy2;
          gy2bd += tb50d * gy2 + tb50 * gy2d;
          gy2b += tb50 * gy2;
          gy2bd += tb50d * gy2 + tb50 * gy2d;
          t11b = -(tb50 * z3);
          t11bd = -(tb50d * z3 + tb50 * z3d);
          p2b += t11b * p2;
          p2bd += t11bd * p2 + t11b * p2d;
          p2b += t11b * p2;
          p2bd += t11bd * p2 + t11b * p2d;
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
        tb49 = z2b / t10;
        tb49d = (z2bd - tb49 * t10d) * (1.0 / t10);
        fzb += tb49;
        fzbd += tb49d;
        t10b = -(tb49 * z2);
        t10bd = -(tb49d * z2 + tb49 * z2d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t10b * fz0_2;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t10bd * fz0_2 + t10b * fz0_2d;
        fz0_2b += t10b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2];
        fz0_2bd += t10bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] + t10b *
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
          tb47 = e7b * e6;
          tb47d = e7bd * e6 + e7b * e6d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb47;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb47d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb47 * gy2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb47d * gy2 + tb47 * gy2d;
          gy2b -= tb47 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
          gy2bd -= tb47d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] + tb47 *
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
          tb48 = e8b * e6;
          tb48d = e8bd * e6 + e8b * e6d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb48;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb48d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb48 * gy2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb48d * gy2 + tb48 * gy2d;
          gy2b += tb48 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
          gy2bd += tb48d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] + tb48 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
        }
        tb46 = e6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
        tb46d = e6bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] + e6b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb46;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb46d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb46 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb46d * dfz + tb46 * dfzd;
        dfzb += tb46 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2];
        dfzbd += tb46d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] + tb46 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] += e6b * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] += e6bd * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz) + e6b *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfzd));
        tb42 = muyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        tb42d = muybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + muyb *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        tb43 = tb42 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2);
        tb43d = tb42d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2) - tb42
            * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2d) * gy2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb43;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb43d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb43 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb43d * dfz + tb43 * dfzd;
        dfzb += tb43 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
        dfzbd += tb43d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] + tb43 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
        tb44 = tb42 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz);
        tb44d = tb42d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz) + tb42 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd));
        tb45 = tb44 * gy2;
        tb45d = tb44d * gy2 + tb44 * gy2d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb45 * gy2;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb45d * gy2 + tb45 * gy2d;
        gy2b -= tb45 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
        gy2bd -= tb45d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] + tb45 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
        gy2b -= tb44 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2);
        gy2bd -= tb44d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2) + tb44 *
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
        tb41 = ayb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
        tb41d = aybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + ayb *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb41;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb41d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb41 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb41d * dfz + tb41 * dfzd;
        dfzb += tb41 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2];
        dfzbd += tb41d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] + tb41 *
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
        tb38 = x35b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb38d = x35bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + x35b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb39 = tb38 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
        tb39d = tb38d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + tb38 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
        fzb += tb39 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz);
        fzbd += tb39d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + tb39 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd));
        tb40 = tb39 * fz;
        tb40d = tb39d * fz + tb39 * fzd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb40;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb40d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb40 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb40d * dfz + tb40 * dfzd;
        dfzb += tb40 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
        dfzbd += tb40d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] + tb40 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb38 * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz));
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb38d * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz)) + tb38 * (fzd * (p[t->tyreadr[t->wheeltyre[n2]] +
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
        tb35 = x33b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        tb35d = x33bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + x33b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        tb36 = tb35 * t9;
        tb36d = tb35d * t9 + tb35 * t9d;
        fzb += tb36 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz);
        fzbd += tb36d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + tb36 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd));
        tb37 = tb36 * fz;
        tb37d = tb36d * fz + tb36 * fzd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb37;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb37d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb37 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb37d * dfz + tb37 * dfzd;
        dfzb += tb37 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
        dfzbd += tb37d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] + tb37 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
        t9b = tb35 * (fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz));
        t9bd = tb35d * (fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz)) + tb35 * (fzd *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz) + fz * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd)));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += x33b * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz) * t9);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += x33bd * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz) * t9) + x33b * ((fzd * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t9 + fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t9d);
        t8b = t9b * t9;
        t8bd = t9bd * t9 + t9b * t9d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t8b * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t8bd * dfz + t8b * dfzd;
        dfzb += t8b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3];
        dfzbd += t8bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] + t8b *
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
        tb33 = e3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
        tb33d = e3bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] + e3b *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb33;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb33d;
        tb34 = tb33 * dfz;
        tb34d = tb33d * dfz + tb33 * dfzd;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb34;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb34d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb34 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb34d * dfz + tb34 * dfzd;
        dfzb += tb34 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
        dfzbd += tb34d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] + tb34 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
        dfzb += tb33 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz);
        dfzbd += tb33d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) + tb33 *
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
        tb29 = muxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb29d = muxbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + muxb *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb30 = tb29 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2);
        tb30d = tb29d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2) - tb29
            * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2d) * gx2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2d);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb30;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb30d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb30 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb30d * dfz + tb30 * dfzd;
        dfzb += tb30 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
        dfzbd += tb30d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] + tb30 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
        tb31 = tb29 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz);
        tb31d = tb29d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz) + tb29 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd));
        tb32 = tb31 * gx2;
        tb32d = tb31d * gx2 + tb31 * gx2d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb32 * gx2;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb32d * gx2 + tb32 * gx2d;
        gx2b = -(tb32 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
        gx2bd = -(tb32d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] + tb32 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
        gx2b -= tb31 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2);
        gx2bd -= tb31d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2) + tb31 *
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
        tb28 = kxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
        tb28d = kxbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] + kxb *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb28;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb28d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb28 * dfz;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb28d * dfz + tb28 * dfzd;
        dfzb += tb28 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
        dfzbd += tb28d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] + tb28 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxbd * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) + kxb *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfzd));
        tb27 = dfzb / fz0;
        tb27d = (dfzbd - tb27 * fz0d) * (1.0 / fz0);
        fzb += tb27;
        fzbd += tb27d;
        fz0b = -tb27;
        fz0bd = -tb27d;
        fz0b -= tb27 * dfz;
        fz0bd -= tb27d * dfz + tb27 * dfzd;
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
