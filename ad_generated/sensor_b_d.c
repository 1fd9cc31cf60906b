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
                       double rabd[restrict t->npoint][3],
                       const double driver[restrict t->ndriver][4],
                       const double driverd[restrict t->ndriver][4],
                       double driverb[restrict t->ndriver][4],
                       double driverbd[restrict t->ndriver][4],
                       const double speed[restrict t->nspeed][3],
                       const double speedd[restrict t->nspeed][3],
                       double speedb[restrict t->nspeed][3], double speedbd[restrict t->nspeed][3],
                       const double lambda[restrict t->nrow],
                       const double lambdad[restrict t->nrow], double lambdab[restrict t->nrow],
                       double lambdabd[restrict t->nrow], double s[restrict t->nsensor][3],
                       double sd[restrict t->nsensor][3], double sb[restrict t->nsensor][3],
                       double sbd[restrict t->nsensor][3])
{
  int a, a4, a4_2, b, b2, b2_2, i, j, k, k2, n2;
  double A_j0, A_j0b, A_j0bd, A_j0d, A_j3, A_j3b, A_j3bd, A_j3d, A_j7, A_j7b, A_j7bd, A_j7d, A_j8,
      A_j8b, A_j8bd, A_j8d, L0, L0b, L0bd, L0d, L1, L1b, L1bd, L1d, L2, L2b, L2bd, L2d, N0, N0b,
      N0bd, N0d, N1, N2, N2b, N2bd, N2d, T0, T0b, T0bd, T0d, T1, T1b, T1bd, T1d, T2, T2b, T2bd, T2d,
      Z_j3, Z_j3b, Z_j3bd, Z_j3d, Z_j4, Z_j4b, Z_j4bd, Z_j4d, Z_k3, Z_k3b, Z_k3bd, Z_k3d, Z_k4,
      Z_k4b, Z_k4bd, Z_k4d, Z_k5, Z_k5b, Z_k5bd, Z_k5d, a00, a00b, a00bd, a00d, a01, a01b, a01bd,
      a01d, a02, a02b, a02bd, a02d, a2, a2b, a2bd, a2d, a3, a3b, a3bd, a3d, along0, along0b,
      along0bd, along0d, along1, along1b, along1bd, along1d, along2, along2b, along2bd, along2d, ar,
      arb, arbd, ard, areq, areqb, areqbd, areqd, arm0, arm0b, arm0bd, arm0d, arm1, arm1b, arm1bd,
      arm1d, arm2, arm2b, arm2bd, arm2d, at, atb, atbd, atd, ateq, ateqb, ateqbd, ateqd, ay, ayb,
      aybd, ayd, br, brb, brbd, brd, bt, btb, btbd, btd, bx, bxb, bxbd, bxd, by, byb, bybd, bycy,
      bycyb, bycybd, bycyd, byd, c, c2, c2b, c2bd, c2d, ca, cab, cabd, cad, cb, cbd, cd, cx, cxb,
      cxbd, cxd, cy, cyb, cybd, cyd, dampingb, dampingbd, dfz, dfzb, dfzbd, dfzd, dr, drb, drbd,
      drd, dt, dtb, dtbd, dtd, dv, dvb, dvbd, dvd, dx, dxb, dxbd, dxd, dy, dyb, dybd, dyd, e0, e0b,
      e0bd, e0d, e1, e10, e10b, e10bd, e10d, e11, e11b, e11bd, e11d, e12, e12b, e12bd, e12d, e13,
      e13b, e13bd, e13d, e1b, e1bd, e1d, e20, e20b, e20bd, e20d, e21, e21b, e21bd, e21d, e22, e22b,
      e22bd, e22d, e2_2, e2_2b, e2_2bd, e2_2d, e3, e3b, e3bd, e3d, e4, e4b, e4bd, e4d, e5, e5b,
      e5bd, e5d, e6, e6b, e6bd, e6d, e7, e7b, e7bd, e7d, e8, e8b, e8bd, e8d, e9, e9b, e9bd, e9d, et,
      etb, etbd, etd, ev0, ev0b, ev0bd, ev0d, ev1, ev1b, ev1bd, ev1d, ev20, ev20b, ev20bd, ev20d,
      ev21, ev21b, ev21bd, ev21d, ev22, ev22b, ev22bd, ev22d, ev2_2, ev2_2b, ev2_2bd, ev2_2d, ex,
      exb, exbd, exd, ey, eyb, eybd, eyd, f0b, f0bd, f1b, f1bd, f2b, f2bd, force0b, force0bd,
      force1b, force1bd, force2b, force2bd, force3b, force3bd, force4b, force4bd, force5b, force5bd,
      fx, fxb, fxbd, fxd, fy, fyb, fybd, fyd, fz, fz0, fz0_2, fz0_2b, fz0_2bd, fz0_2d, fz0_3,
      fz0_3b, fz0_3bd, fz0_3d, fz0_4, fz0_4b, fz0_4bd, fz0_4d, fz0b, fz0bd, fz0d, fz2, fz2b, fz2bd,
      fz2d, fzb, fzbd, fzd, g0, g0b, g0bd, g0d, g20, g20b, g20bd, g20d, g21, g21b, g21bd, g21d,
      g2_2, g2_2b, g2_2bd, g2_2d, gamma, gamma2, gamma2b, gamma2bd, gamma2d, gammab, gammabd,
      gammad, gx, gxb, gxbd, gxd, gy, gyb, gybd, gyd, gz, gzb, gzbd, gzd, h00, h00b, h00bd, h00d,
      h10, h10b, h10bd, h10d, h11, h11b, h11bd, h11d, kappa, kappa2, kappa2b, kappa2bd, kappa2d,
      kappab, kappabd, kappad, kx, kxb, kxbd, kxd, l, l2, l2b, l2bd, l2d, lb, lbd, ld, lv, lvb,
      lvbd, lvd, mux, muxb, muxbd, muxd, muy, muy2, muy2b, muy2bd, muy2d, muyb, muybd, muyd, n30,
      n30b, n30bd, n30d, n31, n31b, n31bd, n31d, n32, n32b, n32bd, n32d, n4, n4b, n4bd, n4d, n50,
      n50b, n50bd, n50d, n51, n52, n52b, n52bd, n52d, omega, omegab, omegabd, omegad, one0, one0b,
      one0bd, one0d, one1, one1b, one1bd, one1d, one2, one2b, one2bd, one2d, one3, one3b, one3bd,
      one3d, one4, one4b, one4bd, one4d, p10, p10b, p10bd, p10d, p2, p2b, p2bd, p2d, p3, p3b, p3bd,
      p3d, p4, p4b, p4bd, p4d, p5, p5b, p5bd, p5d, p6, p6b, p6bd, p6d, p7, p7b, p7bd, p7d, p8, p8b,
      p8bd, p8d, p9, p9b, p9bd, p9d, p_b2, p_b2_2, p_b2_2b, p_b2_2bd, p_b2_2d, p_b2_3, p_b2_3b,
      p_b2_3bd, p_b2_3d, p_b2_4, p_b2_4b, p_b2_4bd, p_b2_4d, p_b2_5, p_b2_5b, p_b2_5bd, p_b2_5d,
      p_b2_6, p_b2_6b, p_b2_6bd, p_b2_6d, p_b2b, p_b2bd, p_b2d, p_k24, p_k24b, p_k24bd, p_k24d,
      p_k25, p_k25b, p_k25bd, p_k25d, r0, r0b, r0bd, r0d, r2, r2b, r2bd, r2d, ratio, ratio2,
      ratio2b, ratio2bd, ratio2d, ratiob, ratiobd, ratiod, re, reb, rebd, red, rhov, rhovb, rhovbd,
      rhovd, roll, rollb, rollbd, rolld, rolling0b, rolling0bd, rolling1b, rolling1bd, rolling2b,
      rolling2bd, rolling3b, rolling3bd, rolling4b, rolling4bd, rolling5b, rolling5bd, s2, s2b,
      s2bd, s2d, s3, s3b, s3bd, s3d, s4, s4b, s4bd, s4d, shift, shiftb, shiftbd, shiftd, shy, shyb,
      shybd, shyd, side, slip0b, slip0bd, slip1, slip1b, slip1bd, slip1d, slip2b, slip2bd, speed2,
      speed2b, speed2bd, speed2d, speed3, speed3b, speed3bd, speed3d, stiff, stiff2, stiff2b,
      stiff2bd, stiff2d, stiff3, stiff3b, stiff3bd, stiff3d, stiff4, stiff4b, stiff4bd, stiff4d,
      stiffb, stiffbd, stiffd, svx, svxb, svxbd, svxd, svy, svyb, svybd, svyd, t10, t10b, t10bd,
      t10d, t11, t11b, t11bd, t11d, t12, t12b, t12bd, t12d, t13, t13b, t13bd, t13d, t14, t14b,
      t14bd, t14d, t15, t15b, t15bd, t15d, t16, t16b, t16bd, t16d, t17, t17b, t17bd, t17d, t18,
      t18b, t18bd, t18d, t19, t19b, t19bd, t19d, t2, t20, t20b, t20bd, t20d, t21, t21b, t21bd, t21d,
      t22, t22b, t22bd, t22d, t23, t23b, t23bd, t23d, t24, t24b, t24bd, t24d, t25, t25b, t25bd,
      t25d, t26, t26b, t26bd, t26d, t27, t27b, t27bd, t27d, t28, t28b, t28bd, t28d, t29, t29b,
      t29bd, t29d, t2b, t2bd, t2d, t3, t30, t30b, t30bd, t30d, t31, t31b, t31bd, t31d, t32, t32b,
      t32bd, t32d, t33, t33b, t33bd, t33d, t34, t34b, t34bd, t34d, t35, t35b, t35bd, t35d, t36,
      t36b, t36bd, t36d, t37, t37b, t37bd, t37d, t38, t38b, t38bd, t38d, t39, t39b, t39bd, t39d,
      t3b, t3bd, t3d, t4, t40, t40b, t40bd, t40d, t41, t41b, t41bd, t41d, t42, t42b, t42bd, t42d,
      t43, t43b, t43bd, t43d, t44, t44b, t44bd, t44d, t45, t45b, t45bd, t45d, t46, t46b, t46bd,
      t46d, t47, t47b, t47bd, t47d, t48, t48b, t48bd, t48d, t49, t49b, t49bd, t49d, t4b, t4bd, t4d,
      t5, t50, t50b, t50bd, t50d, t51, t51b, t51bd, t51d, t52, t52b, t52bd, t52d, t53, t53b, t53bd,
      t53d, t54, t54b, t54bd, t54d, t55, t55b, t55bd, t55d, t56, t56b, t56bd, t56d, t57, t57b,
      t57bd, t57d, t58, t58b, t58bd, t58d, t59, t59b, t59bd, t59d, t5b, t5bd, t5d, t6, t60, t60b,
      t60bd, t60d, t61, t61b, t61bd, t61d, t62, t62b, t62bd, t62d, t63, t63b, t63bd, t63d, t64,
      t64b, t64bd, t64d, t65, t65b, t65bd, t65d, t66, t66b, t66bd, t66d, t67, t67b, t67bd, t67d,
      t68, t68b, t68bd, t68d, t69, t69b, t69bd, t69d, t6b, t6bd, t6d, t7, t70, t70b, t70bd, t70d,
      t71, t71b, t71bd, t71d, t72, t72b, t72bd, t72d, t73, t73b, t73bd, t73d, t74, t74b, t74bd,
      t74d, t75, t75b, t75bd, t75d, t76, t76b, t76bd, t76d, t77, t77b, t77bd, t77d, t78, t78b,
      t78bd, t78d, t79, t79b, t79bd, t79d, t7b, t7bd, t7d, t8, t80, t80b, t80bd, t80d, t81, t81b,
      t81bd, t81d, t82, t82b, t82bd, t82d, t83, t83b, t83bd, t83d, t84, t84b, t84bd, t84d, t85,
      t85b, t85bd, t85d, t86, t86b, t86bd, t86d, t87, t87b, t87bd, t87d, t88, t88b, t88bd, t88d,
      t89, t89b, t89bd, t89d, t8b, t8bd, t8d, t9, t90, t90b, t90bd, t90d, t91, t91b, t91bd, t91d,
      t92, t92b, t92bd, t92d, t93, t93b, t93bd, t93d, t94, t94b, t94bd, t94d, t95, t95b, t95bd,
      t95d, t96, t96b, t96bd, t96d, t97, t97b, t97bd, t97d, t9b, t9bd, t9d, tb10, tb100, tb100d,
      tb101, tb101d, tb102, tb102d, tb103, tb103d, tb104, tb104d, tb105, tb105d, tb106, tb106d,
      tb107, tb107d, tb108, tb108d, tb109, tb109d, tb10d, tb11, tb110, tb110d, tb111, tb111d, tb112,
      tb112d, tb113, tb113d, tb114, tb114d, tb115, tb115d, tb116, tb116d, tb117, tb117d, tb118,
      tb118d, tb119, tb119d, tb11d, tb12, tb120, tb120d, tb121, tb121d, tb122, tb122d, tb123,
      tb123d, tb124, tb124d, tb125, tb125d, tb126, tb126d, tb127, tb127d, tb128, tb128d, tb129,
      tb129d, tb12d, tb13, tb130, tb130d, tb131, tb131d, tb132, tb132d, tb133, tb133d, tb134,
      tb134d, tb135, tb135d, tb136, tb136d, tb137, tb137d, tb138, tb138d, tb139, tb139d, tb13d,
      tb14, tb140, tb140d, tb141, tb141d, tb142, tb142d, tb143, tb143d, tb144, tb144d, tb145,
      tb145d, tb146, tb146d, tb147, tb147d, tb148, tb148d, tb149, tb149d, tb14d, tb15, tb150,
      tb150d, tb151, tb151d, tb152, tb152d, tb153, tb153d, tb154, tb154d, tb155, tb155d, tb156,
      tb156d, tb157, tb157d, tb158, tb158d, tb159, tb159d, tb15d, tb16, tb160, tb160d, tb161,
      tb161d, tb162, tb162d, tb163, tb163d, tb164, tb164d, tb165, tb165d, tb16d, tb17, tb17d, tb18,
      tb18d, tb19, tb19d, tb2, tb20, tb20d, tb21, tb21d, tb22, tb22d, tb23, tb23d, tb24, tb24d,
      tb25, tb25d, tb26, tb26d, tb27, tb27d, tb28, tb28d, tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31,
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
      tb95d, tb96, tb96d, tb97, tb97d, tb98, tb98d, tb99, tb99d, tb9d, torque0b, torque0bd, u20,
      u20b, u20bd, u20d, u21, u21b, u21bd, u21d, u22, u22b, u22bd, u22d, ua0, ua0b, ua0bd, ua0d,
      ua1, ua1b, ua1bd, ua1d, ua2, ua2b, ua2bd, ua2d, un0, un0b, un0bd, un0d, un1, un1b, un1bd,
      un1d, un2, un2b, un2bd, un2d, v20, v20b, v20bd, v20d, v21, v21b, v21bd, v21d, v22, v22b,
      v22bd, v22d, vr0, vr0b, vr0bd, vr0d, vr1, vr1b, vr1bd, vr1d, vr2, vr2b, vr2bd, vr2d, vx, vxb,
      vxbd, vxd, w, way, wayb, waybd, wayd, wb, wbd, wd, wr0, wr0b, wr0bd, wr0d, wr1, wr1b, wr1bd,
      wr1d, wr2, wr2b, wr2bd, wr2d, x2, x2b, x2bd, x2d, x3, x3b, x3bd, x3d, x4, x4b, x4bd, x4d, x50,
      x50b, x50bd, x50d, x51, x51b, x51bd, x51d, x6, x6b, x6bd, x6d, x7, x7b, x7bd, x7d, x8, x8b,
      x8bd, x8d, x9, x9b, x9bd, x9d, xv, xvb, xvbd, xvd, y, y10, y10b, y10bd, y10d, y11, y11b,
      y11bd, y11d, y12, y12b, y12bd, y12d, y13, y13b, y13bd, y13d, y14, y14b, y14bd, y14d, y15,
      y15b, y15bd, y15d, y16, y16b, y16bd, y16d, y17, y17b, y17bd, y17d, y18, y18b, y18bd, y18d,
      y20, y20b, y20bd, y20d, y21, y21b, y21bd, y21d, y22, y22b, y22bd, y22d, y23, y23b, y23bd,
      y23d, y24, y24b, y24bd, y24d, y3, y3b, y3bd, y3d, y4, y4b, y4bd, y4d, y5, y5b, y5bd, y5d, y6,
      y6b, y6bd, y6d, y7, y7b, y7bd, y7d, y8, y8b, y8bd, y8d, y9, y9b, y9bd, y9d, yb, ybd, yd,
      z0_2b, z0_2bd, z0_3b, z0_3bd, z0b, z0bd, z1_2b, z1_2bd, z1_3, z1_3b, z1_3bd, z1_3d, z1b, z1bd,
      z20, z20b, z20bd, z20d, z21, z21b, z21bd, z21d, z22, z22b, z22bd, z22d, z30, z30b, z30bd,
      z30d, z31b, z31bd, z4, z4b, z4bd, z4d, z5, z5b, z5bd, z5d, z6, z6b, z6bd, z6d;

  (void)origin;
  (void)x;
  (void)xd;
  (void)Za;
  (void)Zad;
  (void)ra;
  (void)rad;
  (void)driver;
  (void)driverd;
  (void)speed;
  (void)speedd;
  (void)lambda;
  (void)lambdad;
  A_j0 = 0.0;
  A_j0d = 0.0;
  A_j3 = 0.0;
  A_j3d = 0.0;
  A_j7 = 0.0;
  A_j7d = 0.0;
  A_j8 = 0.0;
  A_j8d = 0.0;
  L0 = 0.0;
  L0d = 0.0;
  L1 = 0.0;
  L1d = 0.0;
  L2 = 0.0;
  L2d = 0.0;
  N0 = 0.0;
  N0d = 0.0;
  N1 = 0.0;
  N2 = 0.0;
  N2d = 0.0;
  T0 = 0.0;
  T0d = 0.0;
  T1 = 0.0;
  T1d = 0.0;
  T2 = 0.0;
  T2d = 0.0;
  Z_j3 = 0.0;
  Z_j3d = 0.0;
  Z_j4 = 0.0;
  Z_j4d = 0.0;
  Z_k3 = 0.0;
  Z_k3d = 0.0;
  Z_k4 = 0.0;
  Z_k4d = 0.0;
  Z_k5 = 0.0;
  Z_k5d = 0.0;
  a00 = 0.0;
  a00d = 0.0;
  a01 = 0.0;
  a01d = 0.0;
  a02 = 0.0;
  a02d = 0.0;
  a2 = 0.0;
  a2d = 0.0;
  along0 = 0.0;
  along0d = 0.0;
  along1 = 0.0;
  along1d = 0.0;
  along2 = 0.0;
  along2d = 0.0;
  arm0 = 0.0;
  arm0d = 0.0;
  arm1 = 0.0;
  arm1d = 0.0;
  arm2 = 0.0;
  arm2d = 0.0;
  c = 0.0;
  c2 = 0.0;
  c2d = 0.0;
  cd = 0.0;
  e0 = 0.0;
  e0d = 0.0;
  e1 = 0.0;
  e1d = 0.0;
  e20 = 0.0;
  e20d = 0.0;
  e21 = 0.0;
  e21d = 0.0;
  e22 = 0.0;
  e22d = 0.0;
  e2_2 = 0.0;
  e2_2d = 0.0;
  ev0 = 0.0;
  ev0d = 0.0;
  ev1 = 0.0;
  ev1d = 0.0;
  ev20 = 0.0;
  ev20d = 0.0;
  ev21 = 0.0;
  ev21d = 0.0;
  ev22 = 0.0;
  ev22d = 0.0;
  ev2_2 = 0.0;
  ev2_2d = 0.0;
  fz = 0.0;
  fz0 = 0.0;
  fz0d = 0.0;
  fzd = 0.0;
  g0 = 0.0;
  g0d = 0.0;
  g2_2 = 0.0;
  g2_2d = 0.0;
  gamma = 0.0;
  gammad = 0.0;
  h00 = 0.0;
  h00d = 0.0;
  h10 = 0.0;
  h10d = 0.0;
  h11 = 0.0;
  h11d = 0.0;
  kappa = 0.0;
  kappad = 0.0;
  l = 0.0;
  l2 = 0.0;
  l2d = 0.0;
  ld = 0.0;
  lv = 0.0;
  lvd = 0.0;
  n30 = 0.0;
  n30d = 0.0;
  n31 = 0.0;
  n31d = 0.0;
  n32 = 0.0;
  n32d = 0.0;
  n4 = 0.0;
  n4d = 0.0;
  n50 = 0.0;
  n50d = 0.0;
  n51 = 0.0;
  n52 = 0.0;
  n52d = 0.0;
  omega = 0.0;
  omegad = 0.0;
  p2 = 0.0;
  p2d = 0.0;
  p3 = 0.0;
  p3d = 0.0;
  r2 = 0.0;
  r2d = 0.0;
  ratio = 0.0;
  ratiod = 0.0;
  re = 0.0;
  red = 0.0;
  rhov = 0.0;
  rhovd = 0.0;
  roll = 0.0;
  rolld = 0.0;
  s2 = 0.0;
  s2d = 0.0;
  side = 0.0;
  slip1 = 0.0;
  slip1d = 0.0;
  speed2 = 0.0;
  speed2d = 0.0;
  t11 = 0.0;
  t11d = 0.0;
  t12 = 0.0;
  t12d = 0.0;
  t2 = 0.0;
  t20 = 0.0;
  t20d = 0.0;
  t21 = 0.0;
  t21d = 0.0;
  t22 = 0.0;
  t22d = 0.0;
  t2d = 0.0;
  t4 = 0.0;
  t4d = 0.0;
  t5 = 0.0;
  t5d = 0.0;
  u20 = 0.0;
  u20d = 0.0;
  u21 = 0.0;
  u21d = 0.0;
  u22 = 0.0;
  u22d = 0.0;
  ua0 = 0.0;
  ua0d = 0.0;
  ua1 = 0.0;
  ua1d = 0.0;
  ua2 = 0.0;
  ua2d = 0.0;
  un0 = 0.0;
  un0d = 0.0;
  un1 = 0.0;
  un1d = 0.0;
  un2 = 0.0;
  un2d = 0.0;
  v20 = 0.0;
  v20d = 0.0;
  v21 = 0.0;
  v21d = 0.0;
  v22 = 0.0;
  v22d = 0.0;
  vx = 0.0;
  vxd = 0.0;
  w = 0.0;
  wd = 0.0;
  wr0 = 0.0;
  wr0d = 0.0;
  wr1 = 0.0;
  wr1d = 0.0;
  wr2 = 0.0;
  wr2d = 0.0;
  x2 = 0.0;
  x2d = 0.0;
  x3 = 0.0;
  x3d = 0.0;
  x4 = 0.0;
  x4d = 0.0;
  xv = 0.0;
  xvd = 0.0;
  z1_3 = 0.0;
  z1_3d = 0.0;
  z20 = 0.0;
  z20d = 0.0;
  z21 = 0.0;
  z21d = 0.0;
  z22 = 0.0;
  z22d = 0.0;
  a = 0;
  a4 = 0;
  a4_2 = 0;
  b = 0;
  b2 = 0;
  b2_2 = 0;
  k2 = 0;
  for (i = t->nsensor - 1; i >= 0; --i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n2 = t->sensorelement[i];
    if (t->sensorkind[i] != MAGGI_SENSOR_POSITION) {
      if (t->sensorkind[i] != MAGGI_SENSOR_VELOCITY) {
        if (t->sensorkind[i] != MAGGI_SENSOR_ACCELERATION) {
          if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
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
          } else {
            if (t->sensorkind[i] != MAGGI_SENSOR_ANGULAR_VELOCITY) {
              if (t->sensorkind[i] != MAGGI_SENSOR_ANGULAR_ACCELERATION) {
                if (t->sensorkind[i] == MAGGI_SENSOR_SPRING) {
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
                  lvd = n30d * ev0 + n30 * ev0d + (n31d * ev1 + n31 * ev1d) + (n32d * ev2_2 + n32 *
                      ev2_2d);
                  k2 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
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
                } else if (t->sensorkind[i] == MAGGI_SENSOR_ROD) {
                  a4 = t->primpa[n2];
                  b2 = t->primpb[n2];
                  e20 = r[a4][0] - r[b2][0];
                  e20d = rd[a4][0] - rd[b2][0];
                  ev20 = rv[a4][0] - rv[b2][0];
                  ev20d = rvd[a4][0] - rvd[b2][0];
                  e21 = r[a4][1] - r[b2][1];
                  e21d = rd[a4][1] - rd[b2][1];
                  ev21 = rv[a4][1] - rv[b2][1];
                  ev21d = rvd[a4][1] - rvd[b2][1];
                  e22 = r[a4][2] - r[b2][2];
                  e22d = rd[a4][2] - rd[b2][2];
                  ev22 = rv[a4][2] - rv[b2][2];
                  ev22d = rvd[a4][2] - rvd[b2][2];
                  t7 = e20 * e20 + e21 * e21 + e22 * e22;
                  t7d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 *
                      e22d);
                  l2 = sqrt(t7);
                  l2d = 1.0 / (2.0 * l2) * t7d;
                  z1_3 = s[i][1];
                  z1_3d = sd[i][1];
                } else {
                  if (t->sensorkind[i] != MAGGI_SENSOR_SPEED) {
                    if (t->sensorkind[i] != MAGGI_SENSOR_DRIVER) {
                      a4_2 = t->wheelpoint[n2];
                      b2_2 = t->wheelroad[n2];
                      j = t->wheelbody[n2];
                      k = t->wheelcarrier[n2];
                      side = t->wheelmirror[n2] ? -1.0 : 1.0;
                      a00 = p[t->wheelaxis[n2]];
                      a00d = pd[t->wheelaxis[n2]];
                      a01 = p[t->wheelaxis[n2] + 1];
                      a01d = pd[t->wheelaxis[n2] + 1];
                      a02 = p[t->wheelaxis[n2] + 2];
                      a02d = pd[t->wheelaxis[n2] + 2];
                      ua0 = A[j][0] * a00 + A[j][1] * a01 + A[j][2] * a02;
                      ua0d = Ad[j][0] * a00 + A[j][0] * a00d + (Ad[j][1] * a01 + A[j][1] * a01d) +
                          (Ad[j][2] * a02 + A[j][2] * a02d);
                      ua1 = A[j][3] * a00 + A[j][4] * a01 + A[j][5] * a02;
                      ua1d = Ad[j][3] * a00 + A[j][3] * a00d + (Ad[j][4] * a01 + A[j][4] * a01d) +
                          (Ad[j][5] * a02 + A[j][5] * a02d);
                      ua2 = A[j][6] * a00 + A[j][7] * a01 + A[j][8] * a02;
                      ua2d = Ad[j][6] * a00 + A[j][6] * a00d + (Ad[j][7] * a01 + A[j][7] * a01d) +
                          (Ad[j][8] * a02 + A[j][8] * a02d);
                      t8 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
                      t8d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2
                          * ua2d);
                      n4 = sqrt(t8);
                      n4d = 1.0 / (2.0 * n4) * t8d;
                      u20 = ua0 / n4;
                      u20d = (ua0d - u20 * n4d) * (1.0 / n4);
                      u21 = ua1 / n4;
                      u21d = (ua1d - u21 * n4d) * (1.0 / n4);
                      u22 = ua2 / n4;
                      u22d = (ua2d - u22 * n4d) * (1.0 / n4);
                      g0 = r[a4_2][0] - r[t->roadpoint[b2_2]][0];
                      g0d = rd[a4_2][0] - rd[t->roadpoint[b2_2]][0];
                      g2_2 = r[a4_2][2] - r[t->roadpoint[b2_2]][2];
                      g2_2d = rd[a4_2][2] - rd[t->roadpoint[b2_2]][2];
                      x4 = g0;
                      x4d = g0d;
                      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
                        p_b2 = p[t->roadadr[b2_2]];
                        p_b2d = pd[t->roadadr[b2_2]];
                        h00 = p_b2 * x4;
                        h00d = p_b2d * x4 + p_b2 * x4d;
                      } else {
                        p_b2_2 = p[t->roadadr[b2_2] + 1];
                        p_b2_2d = pd[t->roadadr[b2_2] + 1];
                        t9 = 6.28318530717958647693 * x4 / p_b2_2;
                        t9d = (6.28318530717958647693 * x4d - t9 * p_b2_2d) * (1.0 / p_b2_2);
                        t10 = sin(t9);
                        t10d = cos(t9) * t9d;
                        p_b2_3 = p[t->roadadr[b2_2]];
                        p_b2_3d = pd[t->roadadr[b2_2]];
                        h00 = p_b2_3 * t10;
                        h00d = p_b2_3d * t10 + p_b2_3 * t10d;
                      }
                      t11 = u20 * u20 + u21 * u21;
                      t11d = u20d * u20 + u20 * u20d + (u21d * u21 + u21 * u21d);
                      t12 = u22 * u20 / t11;
                      t12d = (u22d * u20 + u22 * u20d - t12 * t11d) * (1.0 / t11);
                      x3 = g0 + t12 * (g2_2 - h00);
                      x3d = g0d + (t12d * (g2_2 - h00) + t12 * (g2_2d - h00d));
                      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
                        p_b2_4 = p[t->roadadr[b2_2]];
                        p_b2_4d = pd[t->roadadr[b2_2]];
                        h10 = p_b2_4 * x3;
                        h10d = p_b2_4d * x3 + p_b2_4 * x3d;
                        h11 = p_b2_4;
                        h11d = p_b2_4d;
                      } else {
                        p_b2_5 = p[t->roadadr[b2_2] + 1];
                        p_b2_5d = pd[t->roadadr[b2_2] + 1];
                        t13 = 6.28318530717958647693 * x3 / p_b2_5;
                        t13d = (6.28318530717958647693 * x3d - t13 * p_b2_5d) * (1.0 / p_b2_5);
                        t14 = sin(t13);
                        t14d = cos(t13) * t13d;
                        p_b2_6 = p[t->roadadr[b2_2]];
                        p_b2_6d = pd[t->roadadr[b2_2]];
                        h10 = p_b2_6 * t14;
                        h10d = p_b2_6d * t14 + p_b2_6 * t14d;
                        t15 = p_b2_6 * 6.28318530717958647693 / p_b2_5;
                        t15d = (p_b2_6d * 6.28318530717958647693 - t15 * p_b2_5d) * (1.0 / p_b2_5);
                        t16 = 6.28318530717958647693 * x3 / p_b2_5;
                        t16d = (6.28318530717958647693 * x3d - t16 * p_b2_5d) * (1.0 / p_b2_5);
                        t17 = cos(t16);
                        t17d = -(sin(t16) * t16d);
                        h11 = t15 * t17;
                        h11d = t15d * t17 + t15 * t17d;
                      }
                      t18 = 1.0 + h11 * h11;
                      t18d = h11d * h11 + h11 * h11d;
                      s2 = sqrt(t18);
                      s2d = 1.0 / (2.0 * s2) * t18d;
                      n50 = -h11 / s2;
                      n50d = (-h11d - n50 * s2d) * (1.0 / s2);
                      n51 = 0.0;
                      n52 = 1.0 / s2;
                      n52d = -(n52 * s2d * (1.0 / s2));
                      c = u20 * n50 + u21 * n51 + u22 * n52;
                      cd = u20d * n50 + u20 * n50d + u21d * n51 + (u22d * n52 + u22 * n52d);
                      un0 = u21 * n52 - u22 * n51;
                      un0d = u21d * n52 + u21 * n52d - u22d * n51;
                      un1 = u22 * n50 - u20 * n52;
                      un1d = u22d * n50 + u22 * n50d - (u20d * n52 + u20 * n52d);
                      un2 = u20 * n51 - u21 * n50;
                      un2d = u20d * n51 - (u21d * n50 + u21 * n50d);
                      t19 = un0 * un0 + un1 * un1 + un2 * un2;
                      t19d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2
                          * un2d);
                      w = sqrt(t19);
                      wd = 1.0 / (2.0 * w) * t19d;
                      r2 = ((g0 - x3) * n50 + (g2_2 - h10) * n52) / w;
                      r2d = ((g0d - x3d) * n50 + (g0 - x3) * n50d + ((g2_2d - h10d) * n52 + (g2_2 -
                          h10) * n52d) - r2 * wd) * (1.0 / w);
                      along0 = un0 / w;
                      along0d = (un0d - along0 * wd) * (1.0 / w);
                      along1 = un1 / w;
                      along1d = (un1d - along1 * wd) * (1.0 / w);
                      along2 = un2 / w;
                      along2d = (un2d - along2 * wd) * (1.0 / w);
                      L0 = n51 * along2 - n52 * along1;
                      L0d = n51 * along2d - (n52d * along1 + n52 * along1d);
                      L1 = n52 * along0 - n50 * along2;
                      L1d = n52d * along0 + n52 * along0d - (n50d * along2 + n50 * along2d);
                      L2 = n50 * along1 - n51 * along0;
                      L2d = n50d * along1 + n50 * along1d - n51 * along0d;
                      arm0 = r2 * (c * u20 - n50) / w;
                      arm0d = (r2d * (c * u20 - n50) + r2 * (cd * u20 + c * u20d - n50d) - arm0 *
                          wd) * (1.0 / w);
                      T0 = along0;
                      T0d = along0d;
                      N0 = n50;
                      N0d = n50d;
                      arm1 = r2 * (c * u21 - n51) / w;
                      arm1d = (r2d * (c * u21 - n51) + r2 * (cd * u21 + c * u21d) - arm1 * wd) *
                          (1.0 / w);
                      T1 = along1;
                      T1d = along1d;
                      N1 = n51;
                      arm2 = r2 * (c * u22 - n52) / w;
                      arm2d = (r2d * (c * u22 - n52) + r2 * (cd * u22 + c * u22d - n52d) - arm2 *
                          wd) * (1.0 / w);
                      T2 = along2;
                      T2d = along2d;
                      N2 = n52;
                      N2d = n52d;
                      z20 = r2;
                      z20d = r2d;
                      z21 = c;
                      z21d = cd;
                      z22 = w;
                      z22d = wd;
                      Z_k3 = Z[k][3];
                      Z_k3d = Zd[k][3];
                      wr0 = Z_k3;
                      wr0d = Z_k3d;
                      Z_k4 = Z[k][4];
                      Z_k4d = Zd[k][4];
                      wr1 = Z_k4;
                      wr1d = Z_k4d;
                      Z_k5 = Z[k][5];
                      Z_k5d = Zd[k][5];
                      wr2 = Z_k5;
                      wr2d = Z_k5d;
                      vr0 = wr1 * arm2 - wr2 * arm1;
                      vr0d = wr1d * arm2 + wr1 * arm2d - (wr2d * arm1 + wr2 * arm1d);
                      vr1 = wr2 * arm0 - wr0 * arm2;
                      vr1d = wr2d * arm0 + wr2 * arm0d - (wr0d * arm2 + wr0 * arm2d);
                      vr2 = wr0 * arm1 - wr1 * arm0;
                      vr2d = wr0d * arm1 + wr0 * arm1d - (wr1d * arm0 + wr1 * arm0d);
                      v20 = rv[a4_2][0] + vr0;
                      v20d = rvd[a4_2][0] + vr0d;
                      v21 = rv[a4_2][1] + vr1;
                      v21d = rvd[a4_2][1] + vr1d;
                      v22 = rv[a4_2][2] + vr2;
                      v22d = rvd[a4_2][2] + vr2d;
                      vx = v20 * T0 + v21 * T1 + v22 * T2;
                      vxd = v20d * T0 + v20 * T0d + (v21d * T1 + v21 * T1d) + (v22d * T2 + v22 *
                          T2d);
                      rhov = -(v20 * N0 + v21 * N1 + v22 * N2) / z22;
                      rhovd = (-(v20d * N0 + v20 * N0d + v21d * N1 + (v22d * N2 + v22 * N2d)) - rhov
                          * z22d) * (1.0 / z22);
                      omega = (Z[j][3] - Z_k3) * u20 + (Z[j][4] - Z_k4) * u21 + (Z[j][5] - Z_k5) *
                          u22;
                      omegad = (Zd[j][3] - Z_k3d) * u20 + (Z[j][3] - Z_k3) * u20d + ((Zd[j][4] -
                          Z_k4d) * u21 + (Z[j][4] - Z_k4) * u21d) + ((Zd[j][5] - Z_k5d) * u22 +
                          (Z[j][5] - Z_k5) * u22d);
                      p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
                      p2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
                      p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
                      p3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
                      fz = p2 * (p3 - z20) + p[t->tyreadr[t->wheeltyre[n2]] +
                          MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
                      fzd = p2d * (p3 - z20) + p2 * (p3d - z20d) + (pd[t->tyreadr[t->wheeltyre[n2]]
                          + MAGGI_TYRE_VERTICAL_DAMPING] * rhov + p[t->tyreadr[t->wheeltyre[n2]] +
                          MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
                      fz0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
                          p[t->tyreadr[t->wheeltyre[n2]]];
                      fz0d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
                          p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] +
                          MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[n2]]];
                      ratio = fz / fz0;
                      ratiod = (fzd - ratio * fz0d) * (1.0 / fz0);
                      t20 = fz0 / p2;
                      t20d = (fz0d - t20 * p2d) * (1.0 / p2);
                      t21 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratio;
                      t21d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratio +
                          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratiod;
                      t22 = atan(t21);
                      t22d = 1.0 / (1.0 + t21 * t21) * t21d;
                      re = p3 - t20 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22 +
                          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio);
                      red = p3d - (t20d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22
                          + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio) + t20 *
                          (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22 +
                          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22d +
                          (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio +
                          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratiod)));
                      if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
                          MAGGI_TYRE_VXLOW])) {
                        y = vx;
                        yd = vxd;
                      } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
                          MAGGI_TYRE_VXLOW])) {
                        y = -vx;
                        yd = -vxd;
                      } else {
                        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW];
                        p4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW];
                        t23 = vx * vx / p4;
                        t23d = (vxd * vx + vx * vxd - t23 * p4d) * (1.0 / p4);
                        y = 0.5 * (p4 + t23);
                        yd = 0.5 * (p4d + t23d);
                      }
                      speed2 = y;
                      speed2d = yd;
                      kappa = (omega * re - vx) / speed2;
                      kappad = (omegad * re + omega * red - vxd - kappa * speed2d) * (1.0 / speed2);
                      a2 = (v20 * L0 + v21 * L1 + v22 * L2) / speed2;
                      a2d = (v20d * L0 + v20 * L0d + (v21d * L1 + v21 * L1d) + (v22d * L2 + v22 *
                          L2d) - a2 * speed2d) * (1.0 / speed2);
                      gamma = atan2(z21, z22);
                      gammad = z22 / (z22 * z22 + z21 * z21) * z21d - z21 / (z22 * z22 + z21 * z21)
                          * z22d;
                      slip1 = a2;
                      slip1d = a2d;
                    }
                  }
                }
              }
            }
          }
        }
      }
    }
    A_j0b = 0.0;
    A_j0bd = 0.0;
    A_j3b = 0.0;
    A_j3bd = 0.0;
    A_j7b = 0.0;
    A_j7bd = 0.0;
    A_j8b = 0.0;
    A_j8bd = 0.0;
    L0b = 0.0;
    L0bd = 0.0;
    L1b = 0.0;
    L1bd = 0.0;
    L2b = 0.0;
    L2bd = 0.0;
    N0b = 0.0;
    N0bd = 0.0;
    N2b = 0.0;
    N2bd = 0.0;
    T0b = 0.0;
    T0bd = 0.0;
    T1b = 0.0;
    T1bd = 0.0;
    T2b = 0.0;
    T2bd = 0.0;
    Z_j3b = 0.0;
    Z_j3bd = 0.0;
    Z_j4b = 0.0;
    Z_j4bd = 0.0;
    Z_k3b = 0.0;
    Z_k3bd = 0.0;
    Z_k4b = 0.0;
    Z_k4bd = 0.0;
    Z_k5b = 0.0;
    Z_k5bd = 0.0;
    a00b = 0.0;
    a00bd = 0.0;
    a01b = 0.0;
    a01bd = 0.0;
    a02b = 0.0;
    a02bd = 0.0;
    a2b = 0.0;
    a2bd = 0.0;
    along0b = 0.0;
    along0bd = 0.0;
    along1b = 0.0;
    along1bd = 0.0;
    along2b = 0.0;
    along2bd = 0.0;
    arm0b = 0.0;
    arm0bd = 0.0;
    arm1b = 0.0;
    arm1bd = 0.0;
    arm2b = 0.0;
    arm2bd = 0.0;
    c2b = 0.0;
    c2bd = 0.0;
    cb = 0.0;
    cbd = 0.0;
    dampingb = 0.0;
    dampingbd = 0.0;
    e0b = 0.0;
    e0bd = 0.0;
    e1b = 0.0;
    e1bd = 0.0;
    e20b = 0.0;
    e20bd = 0.0;
    e21b = 0.0;
    e21bd = 0.0;
    e22b = 0.0;
    e22bd = 0.0;
    e2_2b = 0.0;
    e2_2bd = 0.0;
    ev0b = 0.0;
    ev0bd = 0.0;
    ev1b = 0.0;
    ev1bd = 0.0;
    ev20b = 0.0;
    ev20bd = 0.0;
    ev21b = 0.0;
    ev21bd = 0.0;
    ev22b = 0.0;
    ev22bd = 0.0;
    ev2_2b = 0.0;
    ev2_2bd = 0.0;
    f0b = 0.0;
    f0bd = 0.0;
    f1b = 0.0;
    f1bd = 0.0;
    fz0b = 0.0;
    fz0bd = 0.0;
    fzb = 0.0;
    fzbd = 0.0;
    g0b = 0.0;
    g0bd = 0.0;
    g2_2b = 0.0;
    g2_2bd = 0.0;
    gammab = 0.0;
    gammabd = 0.0;
    h00b = 0.0;
    h00bd = 0.0;
    h10b = 0.0;
    h10bd = 0.0;
    h11b = 0.0;
    h11bd = 0.0;
    kappab = 0.0;
    kappabd = 0.0;
    l2b = 0.0;
    l2bd = 0.0;
    lb = 0.0;
    lbd = 0.0;
    lvb = 0.0;
    lvbd = 0.0;
    n30b = 0.0;
    n30bd = 0.0;
    n31b = 0.0;
    n31bd = 0.0;
    n32b = 0.0;
    n32bd = 0.0;
    n4b = 0.0;
    n4bd = 0.0;
    n50b = 0.0;
    n50bd = 0.0;
    n52b = 0.0;
    n52bd = 0.0;
    omegab = 0.0;
    omegabd = 0.0;
    p2b = 0.0;
    p2bd = 0.0;
    p3b = 0.0;
    p3bd = 0.0;
    r2b = 0.0;
    r2bd = 0.0;
    ratiob = 0.0;
    ratiobd = 0.0;
    reb = 0.0;
    rebd = 0.0;
    rhovb = 0.0;
    rhovbd = 0.0;
    rollb = 0.0;
    rollbd = 0.0;
    rolling0b = 0.0;
    rolling0bd = 0.0;
    rolling1b = 0.0;
    rolling1bd = 0.0;
    rolling2b = 0.0;
    rolling2bd = 0.0;
    rolling3b = 0.0;
    rolling3bd = 0.0;
    rolling4b = 0.0;
    rolling4bd = 0.0;
    rolling5b = 0.0;
    rolling5bd = 0.0;
    s2b = 0.0;
    s2bd = 0.0;
    slip0b = 0.0;
    slip0bd = 0.0;
    slip1b = 0.0;
    slip1bd = 0.0;
    slip2b = 0.0;
    slip2bd = 0.0;
    speed2b = 0.0;
    speed2bd = 0.0;
    t11b = 0.0;
    t11bd = 0.0;
    t12b = 0.0;
    t12bd = 0.0;
    t18b = 0.0;
    t18bd = 0.0;
    t19b = 0.0;
    t19bd = 0.0;
    t20b = 0.0;
    t20bd = 0.0;
    t21b = 0.0;
    t21bd = 0.0;
    t22b = 0.0;
    t22bd = 0.0;
    t2b = 0.0;
    t2bd = 0.0;
    t3b = 0.0;
    t3bd = 0.0;
    t4b = 0.0;
    t4bd = 0.0;
    t5b = 0.0;
    t5bd = 0.0;
    t6b = 0.0;
    t6bd = 0.0;
    t7b = 0.0;
    t7bd = 0.0;
    t8b = 0.0;
    t8bd = 0.0;
    torque0b = 0.0;
    torque0bd = 0.0;
    u20b = 0.0;
    u20bd = 0.0;
    u21b = 0.0;
    u21bd = 0.0;
    u22b = 0.0;
    u22bd = 0.0;
    ua0b = 0.0;
    ua0bd = 0.0;
    ua1b = 0.0;
    ua1bd = 0.0;
    ua2b = 0.0;
    ua2bd = 0.0;
    un0b = 0.0;
    un0bd = 0.0;
    un1b = 0.0;
    un1bd = 0.0;
    un2b = 0.0;
    un2bd = 0.0;
    v20b = 0.0;
    v20bd = 0.0;
    v21b = 0.0;
    v21bd = 0.0;
    v22b = 0.0;
    v22bd = 0.0;
    vr0b = 0.0;
    vr0bd = 0.0;
    vr1b = 0.0;
    vr1bd = 0.0;
    vr2b = 0.0;
    vr2bd = 0.0;
    vxb = 0.0;
    vxbd = 0.0;
    wb = 0.0;
    wbd = 0.0;
    wr0b = 0.0;
    wr0bd = 0.0;
    wr1b = 0.0;
    wr1bd = 0.0;
    wr2b = 0.0;
    wr2bd = 0.0;
    x2b = 0.0;
    x2bd = 0.0;
    x3b = 0.0;
    x3bd = 0.0;
    x4b = 0.0;
    x4bd = 0.0;
    xvb = 0.0;
    xvbd = 0.0;
    yb = 0.0;
    ybd = 0.0;
    z0_2b = 0.0;
    z0_2bd = 0.0;
    z0_3b = 0.0;
    z0_3bd = 0.0;
    z0b = 0.0;
    z0bd = 0.0;
    z1_2b = 0.0;
    z1_2bd = 0.0;
    z1_3b = 0.0;
    z1_3bd = 0.0;
    z1b = 0.0;
    z1bd = 0.0;
    z20b = 0.0;
    z20bd = 0.0;
    z21b = 0.0;
    z21bd = 0.0;
    z22b = 0.0;
    z22bd = 0.0;
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
      t2b += tb9 * (t4 / (t4 * t4 + t2 * t2));
      t2bd += tb9d * (t4 / (t4 * t4 + t2 * t2)) + tb9 * ((t4d - t4 / (t4 * t4 + t2 * t2) * (t4d * t4
          + t4 * t4d + (t2d * t2 + t2 * t2d))) / (t4 * t4 + t2 * t2));
      t4b -= tb9 * (t2 / (t4 * t4 + t2 * t2));
      t4bd -= tb9d * (t2 / (t4 * t4 + t2 * t2)) + tb9 * ((t2d - t2 / (t4 * t4 + t2 * t2) * (t4d * t4
          + t4 * t4d + (t2d * t2 + t2 * t2d))) / (t4 * t4 + t2 * t2));
      t3b += t4b * (1.0 / (2.0 * t4));
      t3bd += t4bd * (1.0 / (2.0 * t4)) - t4b * (1.0 / (2.0 * t4) * (2.0 * t4d) / (2.0 * t4));
      A_j7b += t3b * A_j7;
      A_j7bd += t3bd * A_j7 + t3b * A_j7d;
      A_j7b += t3b * A_j7;
      A_j7bd += t3bd * A_j7 + t3b * A_j7d;
      A_j8b += t3b * A_j8;
      A_j8bd += t3bd * A_j8 + t3b * A_j8d;
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
      tb14 = sb[i][2];
      tb14d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Zb[j][5] += tb14;
      Zbd[j][5] += tb14d;
      Ab[j][6] -= tb14 * roll;
      Abd[j][6] -= tb14d * roll + tb14 * rolld;
      rollb -= tb14 * A[j][6];
      rollbd -= tb14d * A[j][6] + tb14 * Ad[j][6];
      tb12 = sb[i][1];
      tb12d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb13 = tb12 / t5;
      tb13d = (tb12d - tb13 * t5d) * (1.0 / t5);
      A_j0b += tb13 * Z_j4;
      A_j0bd += tb13d * Z_j4 + tb13 * Z_j4d;
      Z_j4b += tb13 * A_j0;
      Z_j4bd += tb13d * A_j0 + tb13 * A_j0d;
      A_j3b -= tb13 * Z_j3;
      A_j3bd -= tb13d * Z_j3 + tb13 * Z_j3d;
      Z_j3b -= tb13 * A_j3;
      Z_j3bd -= tb13d * A_j3 + tb13 * A_j3d;
      t5b -= tb13 * s[i][1];
      t5bd -= tb13d * s[i][1] + tb13 * sd[i][1];
      c2b += t5b * (1.0 / (2.0 * t5));
      c2bd += t5bd * (1.0 / (2.0 * t5)) - t5b * (1.0 / (2.0 * t5) * (2.0 * t5d) / (2.0 * t5));
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
      tb22 = sb[i][2];
      tb22d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      f0b += tb22;
      f0bd += tb22d;
      f1b += tb22;
      f1bd += tb22d;
      z1b += sb[i][1];
      z1bd += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      z0b += sb[i][0];
      z0bd += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      lvb += z1b;
      lvbd += z1bd;
      lb += z0b;
      lbd += z0bd;
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
      n30b += lvb * ev0;
      n30bd += lvbd * ev0 + lvb * ev0d;
      ev0b += lvb * n30;
      ev0bd += lvbd * n30 + lvb * n30d;
      n31b += lvb * ev1;
      n31bd += lvbd * ev1 + lvb * ev1d;
      ev1b += lvb * n31;
      ev1bd += lvbd * n31 + lvb * n31d;
      n32b += lvb * ev2_2;
      n32bd += lvbd * ev2_2 + lvb * ev2_2d;
      ev2_2b += lvb * n32;
      ev2_2bd += lvbd * n32 + lvb * n32d;
      tb17 = n32b / l;
      tb17d = (n32bd - tb17 * ld) * (1.0 / l);
      e2_2b += tb17;
      e2_2bd += tb17d;
      lb -= tb17 * n32;
      lbd -= tb17d * n32 + tb17 * n32d;
      tb16 = n31b / l;
      tb16d = (n31bd - tb16 * ld) * (1.0 / l);
      e1b += tb16;
      e1bd += tb16d;
      lb -= tb16 * n31;
      lbd -= tb16d * n31 + tb16 * n31d;
      tb15 = n30b / l;
      tb15d = (n30bd - tb15 * ld) * (1.0 / l);
      e0b += tb15;
      e0bd += tb15d;
      lb -= tb15 * n30;
      lbd -= tb15d * n30 + tb15 * n30d;
      t6b += lb * (1.0 / (2.0 * l));
      t6bd += lbd * (1.0 / (2.0 * l)) - lb * (1.0 / (2.0 * l) * (2.0 * ld) / (2.0 * l));
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
      torque0b += sb[i][2];
      torque0bd += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      z1_2b += sb[i][1];
      z1_2bd += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      z0_2b += sb[i][0];
      z0_2bd += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      xvb += z1_2b;
      xvbd += z1_2bd;
      x2b += z0_2b;
      x2bd += z0_2bd;
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
      lambdab[t->primrow[n2]] += sb[i][2];
      lambdabd[t->primrow[n2]] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      z1_3b += sb[i][1];
      z1_3bd += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      z0_3b += sb[i][0];
      z0_3bd += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      tb24 = z1_3b / l2;
      tb24d = (z1_3bd - tb24 * l2d) * (1.0 / l2);
      e20b += tb24 * ev20;
      e20bd += tb24d * ev20 + tb24 * ev20d;
      ev20b += tb24 * e20;
      ev20bd += tb24d * e20 + tb24 * e20d;
      e21b += tb24 * ev21;
      e21bd += tb24d * ev21 + tb24 * ev21d;
      ev21b += tb24 * e21;
      ev21bd += tb24d * e21 + tb24 * e21d;
      e22b += tb24 * ev22;
      e22bd += tb24d * ev22 + tb24 * ev22d;
      ev22b += tb24 * e22;
      ev22bd += tb24d * e22 + tb24 * e22d;
      l2b -= tb24 * z1_3;
      l2bd -= tb24d * z1_3 + tb24 * z1_3d;
      l2b += z0_3b;
      l2bd += z0_3bd;
      t7b += l2b * (1.0 / (2.0 * l2));
      t7bd += l2bd * (1.0 / (2.0 * l2)) - l2b * (1.0 / (2.0 * l2) * (2.0 * l2d) / (2.0 * l2));
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
      rvb[a4][2] += ev22b;
      rvbd[a4][2] += ev22bd;
      rvb[b2][2] -= ev22b;
      rvbd[b2][2] -= ev22bd;
      rb[a4][2] += e22b;
      rbd[a4][2] += e22bd;
      rb[b2][2] -= e22b;
      rbd[b2][2] -= e22bd;
      rvb[a4][1] += ev21b;
      rvbd[a4][1] += ev21bd;
      rvb[b2][1] -= ev21b;
      rvbd[b2][1] -= ev21bd;
      rb[a4][1] += e21b;
      rbd[a4][1] += e21bd;
      rb[b2][1] -= e21b;
      rbd[b2][1] -= e21bd;
      rvb[a4][0] += ev20b;
      rvbd[a4][0] += ev20bd;
      rvb[b2][0] -= ev20b;
      rvbd[b2][0] -= ev20bd;
      rb[a4][0] += e20b;
      /* distance of two points and its rate */
      rbd[a4][0] += e20bd;
      rb[b2][0] -= e20b;
      rbd[b2][0] -= e20bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SPEED) {
      speedb[n2][2] += sb[i][2];
      speedbd[n2][2] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      speedb[n2][1] += sb[i][1];
      speedbd[n2][1] += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      speedb[n2][0] += sb[i][0];
      speedbd[n2][0] += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_DRIVER) {
      driverb[n2][2] += sb[i][2];
      driverbd[n2][2] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      driverb[n2][1] += sb[i][1];
      driverbd[n2][1] += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      driverb[n2][0] += sb[i][0];
      driverbd[n2][0] += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
    } else {
      if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_SLIP) {
        slip2b += sb[i][2];
        slip2bd += sbd[i][2];
        sb[i][2] = 0.0;
        sbd[i][2] = 0.0;
        tb165 = sb[i][1];
        tb165d = sbd[i][1];
        sb[i][1] = 0.0;
        sbd[i][1] = 0.0;
        slip1b += tb165 * (1.0 / (1.0 + slip1 * slip1));
        slip1bd += tb165d * (1.0 / (1.0 + slip1 * slip1)) - tb165 * (1.0 / (1.0 + slip1 * slip1) *
            (slip1d * slip1 + slip1 * slip1d) / (1.0 + slip1 * slip1));
        slip0b += sb[i][0];
        slip0bd += sbd[i][0];
        sb[i][0] = 0.0;
        sbd[i][0] = 0.0;
      } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_FORCE) {
        rolling2b += sb[i][2];
        rolling2bd += sbd[i][2];
        sb[i][2] = 0.0;
        sbd[i][2] = 0.0;
        rolling1b += sb[i][1];
        rolling1bd += sbd[i][1];
        sb[i][1] = 0.0;
        sbd[i][1] = 0.0;
        rolling0b += sb[i][0];
        rolling0bd += sbd[i][0];
        sb[i][0] = 0.0;
        sbd[i][0] = 0.0;
      } else {
        rolling5b += sb[i][2];
        rolling5bd += sbd[i][2];
        sb[i][2] = 0.0;
        sbd[i][2] = 0.0;
        rolling4b += sb[i][1];
        rolling4bd += sbd[i][1];
        sb[i][1] = 0.0;
        sbd[i][1] = 0.0;
        rolling3b += sb[i][0];
        rolling3bd += sbd[i][0];
        sb[i][0] = 0.0;
        sbd[i][0] = 0.0;
      }
      gammab += slip2b;
      gammabd += slip2bd;
      a2b += slip1b;
      a2bd += slip1bd;
      kappab += slip0b;
      kappabd += slip0bd;
      if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z20) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
          MAGGI_TYRE_UNLOADED_RADIUS])) {
        one0 = kappa;
        one0d = kappad;
        one1 = side * a2;
        one1d = side * a2d;
        one2 = side * gamma;
        one2d = side * gammad;
        one3 = fz;
        one3d = fzd;
        one4 = vx;
        one4d = vxd;
        one0b = 0.0;
        one0bd = 0.0;
        one1b = 0.0;
        one1bd = 0.0;
        one2b = 0.0;
        one2bd = 0.0;
        one3b = 0.0;
        one3bd = 0.0;
        one4b = 0.0;
        one4bd = 0.0;
        if (t->wheelgrip[n2]) {
          kappa2 = one0;
          kappa2d = one0d;
          a3 = one1;
          a3d = one1d;
          gamma2 = one2;
          gamma2d = one2d;
          fz2 = one3;
          fz2d = one3d;
          fz0_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          fz0_2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[n2]]];
          r0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          r0d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          dfz = (fz2 - fz0_2) / fz0_2;
          dfzd = (fz2d - fz0_2d - dfz * fz0_2d) * (1.0 / fz0_2);
          kx = kappa2 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
          kxd = kappa2d + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX]);
          gx = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
          gxd = gamma2d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] + gamma2 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
          cx = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LCX];
          cxd = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX];
          mux = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] *
              gx * gx) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          muxd = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd)) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx) -
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gxd) * gx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gxd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          dx = mux * fz2;
          dxd = muxd * fz2 + mux * fz2d;
          e3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz *
              dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
          e3d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
          if (MAGGI_RE(kx) > 0.0) {
            e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            e4d = e3d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) - e3 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
            if (MAGGI_RE(e4) > 1.0) {
              y3 = 1.0;
              y3d = 0.0;
            } else {
              y3 = e4;
              y3d = e4d;
            }
            ex = y3;
            exd = y3d;
          } else {
            e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            e5d = e3d * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) + e3 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
            if (MAGGI_RE(e5) > 1.0) {
              y4 = 1.0;
              y4d = 0.0;
            } else {
              y4 = e5;
              y4d = e5d;
            }
            ex = y4;
            exd = y4d;
          }
          t24 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
          t24d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfzd;
          t25 = exp(t24);
          t25d = t25 * t24d;
          stiff = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t25 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          stiffd = ((fz2d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd)))
              * t25 + fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t25d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) * t25 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          t26 = cx * dx;
          t26d = cxd * dx + cx * dxd;
          bx = stiff / t26;
          bxd = (stiffd - bx * t26d) * (1.0 / t26);
          svx = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUX];
          svxd = ((fz2d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd)))
              * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          y5 = bx * kx;
          y5d = bxd * kx + bx * kxd;
          t27 = atan(y5);
          t27d = 1.0 / (1.0 + y5 * y5) * y5d;
          t28 = (1.0 - ex) * y5 + ex * t27;
          t28d = -(exd * y5) + (1.0 - ex) * y5d + (exd * t27 + ex * t27d);
          t29 = atan(t28);
          t29d = 1.0 / (1.0 + t28 * t28) * t28d;
          t30 = cx * t29;
          t30d = cxd * t29 + cx * t29d;
          t31 = sin(t30);
          t31d = cos(t30) * t30d;
          x50 = dx * t31 + svx;
          x50d = dxd * t31 + dx * t31d + svxd;
          x51 = stiff;
          x51d = stiffd;
          fz0_3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          fz0_3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[n2]]];
          gy = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
          gyd = gamma2d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] + gamma2 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
          shy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] * gy;
          shyd = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + (pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHY3] * gy + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] * gyd);
          ay = a3 + shy;
          ayd = a3d + shyd;
          cy = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LCY];
          cyd = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY];
          muy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] *
              gy * gy) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          muyd = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd)) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy) -
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gyd) * gy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gyd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          dy = muy * fz2;
          dyd = muyd * fz2 + muy * fz2d;
          e6 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
          e6d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
          if (MAGGI_RE(ay) > 0.0) {
            e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            e7d = e6d * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy)) - e6 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gyd));
            if (MAGGI_RE(e7) > 1.0) {
              y6 = 1.0;
              y6d = 0.0;
            } else {
              y6 = e7;
              y6d = e7d;
            }
            ey = y6;
            eyd = y6d;
          } else {
            e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            e8d = e6d * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy)) + e6 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gyd));
            if (MAGGI_RE(e8) > 1.0) {
              y7 = 1.0;
              y7d = 0.0;
            } else {
              y7 = e8;
              y7d = e8d;
            }
            ey = y7;
            eyd = y7d;
          }
          t32 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3;
          t32d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3d;
          z4 = fz2 / t32;
          z4d = (fz2d - z4 * t32d) * (1.0 / t32);
          if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            y8 = gy;
            y8d = gyd;
          } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            y8 = -gy;
            y8d = -gyd;
          } else {
            p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            p5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t33 = p5 * p5;
            t33d = p5d * p5 + p5 * p5d;
            z5 = gy * gy / t33;
            z5d = (gyd * gy + gy * gyd - z5 * t33d) * (1.0 / t33);
            y8 = 0.125 * p5 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
            y8d = (0.125 * p5d * z5 + 0.125 * p5 * z5d) * (15.0 + z5 * (-10.0 + 3.0 * z5)) + 0.125 *
                p5 * z5 * (z5d * (-10.0 + 3.0 * z5) + z5 * (3.0 * z5d));
          }
          t34 = 1.0 + z4 * z4;
          t34d = z4d * z4 + z4 * z4d;
          t35 = 2.0 * z4 / t34;
          t35d = (2.0 * z4d - t35 * t34d) * (1.0 / t34);
          stiff2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          stiff2d = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3d) * t35 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35d) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8d)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKY1] * fz0_3 * t35 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKY3] * y8) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          t36 = cy * dy;
          t36d = cyd * dy + cy * dyd;
          by = stiff2 / t36;
          byd = (stiff2d - by * t36d) * (1.0 / t36);
          svy = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          svyd = (fz2d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) +
              fz2 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd)) * gy +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY4] * dfz) * gyd))) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] +
              fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          y9 = by * ay;
          y9d = byd * ay + by * ayd;
          t37 = atan(y9);
          t37d = 1.0 / (1.0 + y9 * y9) * y9d;
          t38 = (1.0 - ey) * y9 + ey * t37;
          t38d = -(eyd * y9) + (1.0 - ey) * y9d + (eyd * t37 + ey * t37d);
          t39 = atan(t38);
          t39d = 1.0 / (1.0 + t38 * t38) * t38d;
          t40 = cy * t39;
          t40d = cyd * t39 + cy * t39d;
          t41 = sin(t40);
          t41d = cos(t40) * t40d;
          y20 = dy * t41 + svy;
          y20d = dyd * t41 + dy * t41d + svyd;
          y21 = stiff2;
          y21d = stiff2d;
          y22 = muy;
          y22d = muyd;
          y23 = by * cy;
          y23d = byd * cy + by * cyd;
          t42 = svy / stiff2;
          t42d = (svyd - t42 * stiff2d) * (1.0 / stiff2);
          y24 = shy + t42;
          y24d = shyd + t42d;
          muy2 = y22;
          muy2d = y22d;
          x6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          x6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBY2] * (a3d - pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          t43 = 1.0 + x6 * x6;
          t43d = x6d * x6 + x6 * x6d;
          t44 = sqrt(t43);
          t44d = 1.0 / (2.0 * t44) * t43d;
          t45 = 1.0 / t44;
          t45d = -(t45 * t44d * (1.0 / t44));
          stiff3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t45 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          stiff3d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t45 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t45d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBY1] * t45 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          e10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_REY2] * dfz;
          e10d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] * dfzd);
          if (MAGGI_RE(e10) > 1.0) {
            y10 = 1.0;
            y10d = 0.0;
          } else {
            y10 = e10;
            y10d = e10d;
          }
          e9 = y10;
          e9d = y10d;
          s4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RHY2] * dfz;
          s4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfzd);
          x7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] * a3;
          x7d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] * a3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] * a3d;
          t46 = 1.0 + x7 * x7;
          t46d = x7d * x7 + x7 * x7d;
          t47 = sqrt(t46);
          t47d = 1.0 / (2.0 * t47) * t46d;
          t48 = 1.0 / t47;
          t48d = -(t48 * t47d * (1.0 / t47));
          dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) * t48;
          dvd = ((muy2d * fz2 + muy2 * fz2d) * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) + muy2 * fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2d))) * t48 + muy2 * fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) *
              t48d;
          y11 = stiff3 * (kappa2 + s4);
          y11d = stiff3d * (kappa2 + s4) + stiff3 * (kappa2d + s4d);
          y12 = stiff3 * s4;
          y12d = stiff3d * s4 + stiff3 * s4d;
          t49 = atan(y11);
          t49d = 1.0 / (1.0 + y11 * y11) * y11d;
          t50 = (1.0 - e9) * y11 + e9 * t49;
          t50d = -(e9d * y11) + (1.0 - e9) * y11d + (e9d * t49 + e9 * t49d);
          t51 = atan(t50);
          t51d = 1.0 / (1.0 + t50 * t50) * t50d;
          p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
          p6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
          t52 = p6 * t51;
          t52d = p6d * t51 + p6 * t51d;
          t53 = cos(t52);
          t53d = -(sin(t52) * t52d);
          t54 = atan(y12);
          t54d = 1.0 / (1.0 + y12 * y12) * y12d;
          t55 = (1.0 - e9) * y12 + e9 * t54;
          t55d = -(e9d * y12) + (1.0 - e9) * y12d + (e9d * t54 + e9 * t54d);
          t56 = atan(t55);
          t56d = 1.0 / (1.0 + t55 * t55) * t55d;
          t57 = p6 * t56;
          t57d = p6d * t56 + p6 * t56d;
          t58 = cos(t57);
          t58d = -(sin(t57) * t57d);
          g20 = t53 / t58;
          g20d = (t53d - g20 * t58d) * (1.0 / t58);
          t59 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2;
          t59d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2d;
          t60 = atan(t59);
          t60d = 1.0 / (1.0 + t59 * t59) * t59d;
          t61 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t60;
          t61d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t60 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t60d;
          t62 = sin(t61);
          t62d = cos(t61) * t61d;
          g21 = dv * t62 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          g21d = (dvd * t62 + dv * t62d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + dv *
              t62 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          x8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2;
          x8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2d;
          t63 = 1.0 + x8 * x8;
          t63d = x8d * x8 + x8 * x8d;
          t64 = sqrt(t63);
          t64d = 1.0 / (2.0 * t64) * t63d;
          t65 = 1.0 / t64;
          t65d = -(t65 * t64d * (1.0 / t64));
          stiff4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t65 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          stiff4d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t65 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t65d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBX1] * t65 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          e12 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_REX2] * dfz;
          e12d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] * dfzd);
          if (MAGGI_RE(e12) > 1.0) {
            y13 = 1.0;
            y13d = 0.0;
          } else {
            y13 = e12;
            y13d = e12d;
          }
          e11 = y13;
          e11d = y13d;
          p7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
          p7d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
          y14 = stiff4 * (a3 + p7);
          y14d = stiff4d * (a3 + p7) + stiff4 * (a3d + p7d);
          y15 = stiff4 * p7;
          y15d = stiff4d * p7 + stiff4 * p7d;
          t66 = atan(y14);
          t66d = 1.0 / (1.0 + y14 * y14) * y14d;
          t67 = (1.0 - e11) * y14 + e11 * t66;
          t67d = -(e11d * y14) + (1.0 - e11) * y14d + (e11d * t66 + e11 * t66d);
          t68 = atan(t67);
          t68d = 1.0 / (1.0 + t67 * t67) * t67d;
          p8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
          p8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
          t69 = p8 * t68;
          t69d = p8d * t68 + p8 * t68d;
          t70 = cos(t69);
          t70d = -(sin(t69) * t69d);
          t71 = atan(y15);
          t71d = 1.0 / (1.0 + y15 * y15) * y15d;
          t72 = (1.0 - e11) * y15 + e11 * t71;
          t72d = -(e11d * y15) + (1.0 - e11) * y15d + (e11d * t71 + e11 * t71d);
          t73 = atan(t72);
          t73d = 1.0 / (1.0 + t72 * t72) * t72d;
          t74 = p8 * t73;
          t74d = p8d * t73 + p8 * t73d;
          t75 = cos(t74);
          t75d = -(sin(t74) * t74d);
          t76 = t70 / t75;
          t76d = (t70d - t76 * t75d) * (1.0 / t75);
          fx = x50 * t76;
          fxd = x50d * t76 + x50 * t76d;
          fy = g20 * y20 + g21;
          fyd = g20d * y20 + g20 * y20d + g21d;
          ratio2 = x51 * kappa2 / y21;
          ratio2d = (x51d * kappa2 + x51 * kappa2d - ratio2 * y21d) * (1.0 / y21);
          bycy = y23;
          bycyd = y23d;
          shift = y24;
          shiftd = y24d;
          fz0_4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          fz0_4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[n2]]];
          gz = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ];
          gzd = gamma2d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ] + gamma2 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ];
          at = a3 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] * dfz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QHZ4] * dfz) * gz;
          atd = a3d + pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] * dfzd)) * gz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QHZ4] * dfz) * gzd);
          ar = a3 + shift;
          ard = a3d + shiftd;
          t77 = at * at + ratio2 * ratio2 + 1e-24;
          t77d = atd * at + at * atd + (ratio2d * ratio2 + ratio2 * ratio2d);
          ateq = sqrt(t77);
          ateqd = 1.0 / (2.0 * ateq) * t77d;
          t78 = ar * ar + ratio2 * ratio2 + 1e-24;
          t78d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
          areq = sqrt(t78);
          areqd = 1.0 / (2.0 * areq) * t78d;
          if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            y16 = gz;
            y16d = gzd;
          } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            y16 = -gz;
            y16d = -gzd;
          } else {
            p9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            p9d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t79 = p9 * p9;
            t79d = p9d * p9 + p9 * p9d;
            z6 = gz * gz / t79;
            z6d = (gzd * gz + gz * gzd - z6 * t79d) * (1.0 / t79);
            y16 = 0.125 * p9 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
            y16d = (0.125 * p9d * z6 + 0.125 * p9 * z6d) * (15.0 + z6 * (-10.0 + 3.0 * z6)) + 0.125
                * p9 * z6 * (z6d * (-10.0 + 3.0 * z6) + z6 * (3.0 * z6d));
          }
          bt = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUY];
          btd = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfzd)) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gzd +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16d))) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] - bt *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY]) * (1.0 /
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY]);
          t80 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
          t80d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] - t80 * fz0_4d) *
              (1.0 / fz0_4);
          dt = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t80 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          dtd = (((fz2d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfzd)))
              * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gzd +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gzd) * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gzd))) * t80 + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t80d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t80 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          t81 = bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * at;
          t81d = (btd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] + bt *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1]) * at + bt *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * atd;
          t82 = atan(t81);
          t82d = 1.0 / (1.0 + t81 * t81) * t81d;
          e13 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
              dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t82);
          e13d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfzd)) * (1.0 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t82) +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
              dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gzd)) * 0.63661977236758134308 *
              t82 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t82d);
          if (MAGGI_RE(e13) > 1.0) {
            y17 = 1.0;
            y17d = 0.0;
          } else {
            y17 = e13;
            y17d = e13d;
          }
          et = y17;
          etd = y17d;
          p10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          p10d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          t83 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LKY] / p10;
          t83d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ9] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] - t83 * p10d) *
              (1.0 / p10);
          br = t83 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycy;
          brd = t83d + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycyd);
          dr = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] * p10;
          drd = ((fz2d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) +
              fz2 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gzd))) * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_UNLOADED_RADIUS] + fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS]) * p10 + fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_UNLOADED_RADIUS] * p10d;
          t84 = 1.0 + a3 * a3;
          t84d = a3d * a3 + a3 * a3d;
          t85 = sqrt(t84);
          t85d = 1.0 / (2.0 * t85) * t84d;
          ca = 1.0 / t85;
          cad = -(ca * t85d * (1.0 / t85));
          y18 = bt * ateq;
          y18d = btd * ateq + bt * ateqd;
          t86 = atan(y18);
          t86d = 1.0 / (1.0 + y18 * y18) * y18d;
          t87 = (1.0 - et) * y18 + et * t86;
          t87d = -(etd * y18) + (1.0 - et) * y18d + (etd * t86 + et * t86d);
          t88 = atan(t87);
          t88d = 1.0 / (1.0 + t87 * t87) * t87d;
          t89 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t88;
          t89d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t88 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t88d;
          t90 = cos(t89);
          t90d = -(sin(t89) * t89d);
          z30 = dt * t90 * ca;
          z30d = (dtd * t90 + dt * t90d) * ca + dt * t90 * cad;
          x9 = br * areq;
          x9d = brd * areq + br * areqd;
          t91 = 1.0 + x9 * x9;
          t91d = x9d * x9 + x9 * x9d;
          t92 = sqrt(t91);
          t92d = 1.0 / (2.0 * t92) * t91d;
          t93 = 1.0 / t92;
          t93d = -(t93 * t92d * (1.0 / t92));
          t94 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
          t94d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fyd - t94 * fz0_2d) * (1.0 /
              fz0_2);
          s3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t94 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LS];
          s3d = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t94d +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfzd)) * gamma2 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2d)) * r0 + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t94 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t94 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS];
          t95 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          t95d = (one4d - t95 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED]) * (1.0 /
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED]);
          way = tanh(t95);
          wayd = (1.0 - way * way) * t95d;
          speed3 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          speed3d = (one4d - speed3 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL]) * (1.0 /
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL]);
          t96 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
          t96d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fyd - t96 * fz0_2d) * (1.0 /
              fz0_2);
          t97 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
          t97d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fxd - t97 * fz0_2d) * (1.0 /
              fz0_2);
          force5b = rolling5b * side;
          force5bd = rolling5bd * side;
          rolling5b = 0.0;
          rolling5bd = 0.0;
          force4b = rolling4b;
          force4bd = rolling4bd;
          rolling4b = 0.0;
          rolling4bd = 0.0;
          force3b = rolling3b * side;
          force3bd = rolling3bd * side;
          rolling3b = 0.0;
          rolling3bd = 0.0;
          force2b = rolling2b;
          force2bd = rolling2bd;
          rolling2b = 0.0;
          rolling2bd = 0.0;
          force1b = rolling1b * side;
          force1bd = rolling1bd * side;
          rolling1b = 0.0;
          rolling1bd = 0.0;
          force0b = rolling0b;
          force0bd = rolling0bd;
          rolling0b = 0.0;
          rolling0bd = 0.0;
          z30b = -(force5b * (fy - g21));
          z30bd = -(force5bd * (fy - g21) + force5b * (fyd - g21d));
          tb164 = force5b * z30;
          tb164d = force5bd * z30 + force5b * z30d;
          fyb = -tb164;
          fybd = -tb164d;
          g21b = tb164;
          g21bd = tb164d;
          z31b = force5b;
          z31bd = force5bd;
          s3b = force5b * fx;
          s3bd = force5bd * fx + force5b * fxd;
          fxb = force5b * s3;
          fxbd = force5bd * s3 + force5b * s3d;
          tb156 = force4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY];
          tb156d = force4bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY] + force4b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY];
          tb157 = tb156 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t97 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
              speed3);
          tb157d = tb156d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t97 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3)
              + tb156 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t97d +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3d) +
              ((((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) *
              speed3 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3
              * speed3d));
          tb158 = tb157 * fz2;
          tb158d = tb157d * fz2 + tb157 * fz2d;
          wayb = -(tb158 * r0);
          waybd = -(tb158d * r0 + tb158 * r0d);
          r0b = -(tb158 * way);
          r0bd = -(tb158d * way + tb158 * wayd);
          fz2b = tb157 * (-way * r0);
          fz2bd = tb157d * (-way * r0) + tb157 * (-(wayd * r0) - way * r0d);
          tb159 = tb156 * (-way * r0 * fz2);
          tb159d = tb156d * (-way * r0 * fz2) + tb156 * ((-(wayd * r0) - way * r0d) * fz2 + -way *
              r0 * fz2d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] += tb159;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] += tb159d;
          t97b = tb159;
          t97bd = tb159d;
          tb160 = tb159 * speed3;
          tb160d = tb159d * speed3 + tb159 * speed3d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] += tb160 * way;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] += tb160d * way + tb160 * wayd;
          wayb += tb160 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3];
          waybd += tb160d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] + tb160 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3];
          speed3b = tb159 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way);
          speed3bd = tb159d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way) + tb159 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * wayd);
          tb161 = tb159 * speed3;
          tb161d = tb159d * speed3 + tb159 * speed3d;
          tb162 = tb161 * speed3;
          tb162d = tb161d * speed3 + tb161 * speed3d;
          tb163 = tb162 * speed3;
          tb163d = tb162d * speed3 + tb162 * speed3d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] += tb163 * speed3;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] += tb163d * speed3 + tb163 * speed3d;
          speed3b += tb163 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4];
          speed3bd += tb163d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] + tb163 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4];
          speed3b += tb162 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3);
          speed3bd += tb162d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3) + tb162
              * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d);
          speed3b += tb161 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3);
          speed3bd += tb161d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3)
              + tb161 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3d);
          speed3b += tb159 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 *
              speed3);
          speed3bd += tb159d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3
              * speed3) + tb159 * (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY] += force4b * (-way * r0 * fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t97 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
              speed3));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY] += force4bd * (-way * r0 * fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t97 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
              speed3)) + force4b * (((-(wayd * r0) - way * r0d) * fz2 + -way * r0 * fz2d) *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t97 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3)
              + -way * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t97d +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3d) +
              ((((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) *
              speed3 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3
              * speed3d)));
          tb155 = t97b / fz0_2;
          tb155d = (t97bd - tb155 * fz0_2d) * (1.0 / fz0_2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] += tb155 * fx;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] += tb155d * fx + tb155 * fxd;
          fxb += tb155 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2];
          fxbd += tb155d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] + tb155 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2];
          fz0_2b = -(tb155 * t97);
          fz0_2bd = -(tb155d * t97 + tb155 * t97d);
          tb152 = force3b * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX2] * gamma2 + t96) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX]);
          tb152d = force3bd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX2] * gamma2 + t96) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX]) +
              force3b * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX1] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] +
              ((-(pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2d + t96d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX2] * gamma2 + t96) * pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMX]));
          r0b += tb152 * fz2;
          r0bd += tb152d * fz2 + tb152 * fz2d;
          fz2b += tb152 * r0;
          fz2bd += tb152d * r0 + tb152 * r0d;
          tb153 = force3b * (r0 * fz2);
          tb153d = force3bd * (r0 * fz2) + force3b * (r0d * fz2 + r0 * fz2d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] += tb153 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] += tb153d *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + tb153 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] += tb153 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] += tb153d *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] + tb153 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1];
          tb154 = tb153 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX];
          tb154d = tb153d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] + tb153 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] -= tb154 * gamma2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] -= tb154d * gamma2 + tb154 * gamma2d;
          gamma2b = -(tb154 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2]);
          gamma2bd = -(tb154d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] + tb154 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2]);
          t96b = tb154;
          t96bd = tb154d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] += tb153 *
              (-p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2 + t96);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] += tb153d *
              (-p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2 + t96) + tb153 *
              (-(pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2d + t96d);
          tb151 = t96b / fz0_2;
          tb151d = (t96bd - tb151 * fz0_2d) * (1.0 / fz0_2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] += tb151 * fy;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] += tb151d * fy + tb151 * fyd;
          fyb += tb151 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3];
          fybd += tb151d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] + tb151 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3];
          fz0_2b -= tb151 * t96;
          fz0_2bd -= tb151d * t96 + tb151 * t96d;
          fz2b += force2b;
          fz2bd += force2bd;
          fyb += force1b;
          fybd += force1bd;
          fxb += force0b;
          fxbd += force0bd;
          tb150 = speed3b / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          tb150d = (speed3bd - tb150 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL]) * (1.0
              / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL]);
          one4b += tb150;
          one4bd += tb150d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL] -= tb150 * speed3;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL] -= tb150d * speed3 + tb150 *
              speed3d;
          t95b = wayb * (1.0 - way * way);
          t95bd = waybd * (1.0 - way * way) - wayb * (wayd * way + way * wayd);
          tb149 = t95b / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          tb149d = (t95bd - tb149 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED]) * (1.0
              / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED]);
          one4b += tb149;
          one4bd += tb149d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED] -= tb149 * t95;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED] -= tb149d * t95 + tb149 * t95d;
          tb146 = s3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS];
          tb146d = s3bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] + s3b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS];
          tb147 = tb146 * r0;
          tb147d = tb146d * r0 + tb146 * r0d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] += tb147;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] += tb147d;
          t94b = tb147;
          t94bd = tb147d;
          tb148 = tb147 * gamma2;
          tb148d = tb147d * gamma2 + tb147 * gamma2d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] += tb148;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] += tb148d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] += tb148 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] += tb148d * dfz + tb148 * dfzd;
          dfzb = tb148 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4];
          dfzbd = tb148d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] + tb148 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4];
          gamma2b += tb147 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz);
          gamma2bd += tb147d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) + tb147 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfzd));
          r0b += tb146 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t94 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2);
          r0bd += tb146d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t94 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2) + tb146 * (pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t94d + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfzd)) * gamma2 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2d));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] += s3b * ((p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_SSZ1] + t94 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] += s3bd *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t94 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0) + s3b * ((pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t94d + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfzd)) * gamma2 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2d)) * r0 + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t94 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0d);
          tb145 = t94b / fz0_2;
          tb145d = (t94bd - tb145 * fz0_2d) * (1.0 / fz0_2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] += tb145 * fy;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] += tb145d * fy + tb145 * fyd;
          fyb += tb145 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2];
          fybd += tb145d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] + tb145 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2];
          fz0_2b -= tb145 * t94;
          fz0_2bd -= tb145d * t94 + tb145 * t94d;
          tb144 = z31b * ca;
          tb144d = z31bd * ca + z31b * cad;
          drb = tb144 * t93;
          drbd = tb144d * t93 + tb144 * t93d;
          t93b = tb144 * dr;
          t93bd = tb144d * dr + tb144 * drd;
          cab = z31b * (dr * t93);
          cabd = z31bd * (dr * t93) + z31b * (drd * t93 + dr * t93d);
          tb143 = t93b / t92;
          tb143d = (t93bd - tb143 * t92d) * (1.0 / t92);
          t92b = -(tb143 * t93);
          t92bd = -(tb143d * t93 + tb143 * t93d);
          t91b = t92b * (1.0 / (2.0 * t92));
          t91bd = t92bd * (1.0 / (2.0 * t92)) - t92b * (1.0 / (2.0 * t92) * (2.0 * t92d) / (2.0 *
              t92));
          x9b = t91b * x9;
          x9bd = t91bd * x9 + t91b * x9d;
          x9b += t91b * x9;
          x9bd += t91bd * x9 + t91b * x9d;
          brb = x9b * areq;
          brbd = x9bd * areq + x9b * areqd;
          areqb = x9b * br;
          areqbd = x9bd * br + x9b * brd;
          tb142 = z30b * ca;
          tb142d = z30bd * ca + z30b * cad;
          dtb = tb142 * t90;
          dtbd = tb142d * t90 + tb142 * t90d;
          t90b = tb142 * dt;
          t90bd = tb142d * dt + tb142 * dtd;
          cab += z30b * (dt * t90);
          cabd += z30bd * (dt * t90) + z30b * (dtd * t90 + dt * t90d);
          t89b = -(t90b * sin(t89));
          t89bd = -(t90bd * sin(t89) + t90b * (cos(t89) * t89d));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += t89b * t88;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += t89bd * t88 + t89b * t88d;
          t88b = t89b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          t88bd = t89bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] + t89b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          t87b = t88b * (1.0 / (1.0 + t87 * t87));
          t87bd = t88bd * (1.0 / (1.0 + t87 * t87)) - t88b * (1.0 / (1.0 + t87 * t87) * (t87d * t87
              + t87 * t87d) / (1.0 + t87 * t87));
          etb = -(t87b * y18);
          etbd = -(t87bd * y18 + t87b * y18d);
          y18b = t87b * (1.0 - et);
          y18bd = t87bd * (1.0 - et) - t87b * etd;
          etb += t87b * t86;
          etbd += t87bd * t86 + t87b * t86d;
          t86b = t87b * et;
          t86bd = t87bd * et + t87b * etd;
          y18b += t86b * (1.0 / (1.0 + y18 * y18));
          y18bd += t86bd * (1.0 / (1.0 + y18 * y18)) - t86b * (1.0 / (1.0 + y18 * y18) * (y18d * y18
              + y18 * y18d) / (1.0 + y18 * y18));
          btb = y18b * ateq;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          btbd = y18bd * ateq + y18b * ateqd;
          ateqb = y18b * bt;
          ateqbd = y18bd * bt + y18b * btd;
          tb141 = cab / t85;
          tb141d = (cabd - tb141 * t85d) * (1.0 / t85);
          t85b = -(tb141 * ca);
          t85bd = -(tb141d * ca + tb141 * cad);
          t84b = t85b * (1.0 / (2.0 * t85));
          t84bd = t85bd * (1.0 / (2.0 * t85)) - t85b * (1.0 / (2.0 * t85) * (2.0 * t85d) / (2.0 *
              t85));
          a3b = t84b * a3;
          a3bd = t84bd * a3 + t84b * a3d;
          a3b += t84b * a3;
          a3bd += t84bd * a3 + t84b * a3d;
          tb136 = drb * p10;
          tb136d = drbd * p10 + drb * p10d;
          tb137 = tb136 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          tb137d = tb136d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] + tb136 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          fz2b += tb137 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz);
          fz2bd += tb137d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) +
              tb137 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gzd));
          tb138 = tb137 * fz2;
          tb138d = tb137d * fz2 + tb137 * fz2d;
          tb139 = tb138 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES];
          tb139d = tb138d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + tb138 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] += tb139;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] += tb139d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] += tb139 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] += tb139d * dfz + tb139 * dfzd;
          dfzb += tb139 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7];
          dfzbd += tb139d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] + tb139 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] += tb138 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] += tb138d *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz) + tb138 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6]
              + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfzd));
          tb140 = tb138 * gz;
          tb140d = tb138d * gz + tb138 * gzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] += tb140;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] += tb140d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] += tb140 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] += tb140d * dfz + tb140 * dfzd;
          dfzb += tb140 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9];
          dfzbd += tb140d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] + tb140 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9];
          gzb = tb138 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz);
          gzbd = tb138d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) + tb138 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ9] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfzd));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb136 * (fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gz));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb136d * (fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gz)) + tb136 * (fz2d * ((p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) +
              fz2 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gzd)));
          p10b = drb * (fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS]);
          p10bd = drbd * (fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS]) + drb * ((fz2d *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gz) + fz2 * ((pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ6] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gzd))) * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_UNLOADED_RADIUS] + fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS]);
          t83b = brb;
          t83bd = brbd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] += brb * bycy;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] += brbd * bycy + brb * bycyd;
          bycyb = brb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10];
          bycybd = brbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] + brb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10];
          tb135 = t83b / p10;
          tb135d = (t83bd - tb135 * p10d) * (1.0 / p10);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] += tb135 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] += tb135d *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + tb135 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb135 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb135d *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] + tb135 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9];
          p10b -= tb135 * t83;
          p10bd -= tb135d * t83 + tb135 * t83d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += p10b;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += p10bd;
          y17b = etb;
          y17bd = etbd;
          e13b = 0.0;
          e13bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e13) > 1.0) {
            y17b = 0.0;
            y17bd = 0.0;
          } else {
            e13b += y17b;
            e13bd += y17bd;
            y17b = 0.0;
            y17bd = 0.0;
          }
          tb130 = e13b * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t82);
          tb130d = e13bd * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t82) + e13b * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gzd)) * 0.63661977236758134308 *
              t82 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t82d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] += tb130;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] += tb130d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] += tb130 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] += tb130d * dfz + tb130 * dfzd;
          dfzb += tb130 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2];
          dfzbd += tb130d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] + tb130 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2];
          tb131 = tb130 * dfz;
          tb131d = tb130d * dfz + tb130 * dfzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] += tb131 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] += tb131d * dfz + tb131 * dfzd;
          dfzb += tb131 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3];
          dfzbd += tb131d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] + tb131 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3];
          dfzb += tb130 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz);
          dfzbd += tb130d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz) + tb130 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfzd);
          tb132 = e13b * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfz);
          tb132d = e13bd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfz) + e13b *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfzd));
          tb133 = tb132 * t82;
          tb133d = tb132d * t82 + tb132 * t82d;
          tb134 = tb133 * 0.63661977236758134308;
          tb134d = tb133d * 0.63661977236758134308;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] += tb134;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] += tb134d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] += tb134 * gz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] += tb134d * gz + tb134 * gzd;
          gzb += tb134 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5];
          gzbd += tb134d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] + tb134 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5];
          t82b = tb132 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308);
          t82bd = tb132d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308) +
              tb132 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gzd)) * 0.63661977236758134308);
          t81b = t82b * (1.0 / (1.0 + t81 * t81));
          t81bd = t82bd * (1.0 / (1.0 + t81 * t81)) - t82b * (1.0 / (1.0 + t81 * t81) * (t81d * t81
              + t81 * t81d) / (1.0 + t81 * t81));
          tb129 = t81b * at;
          tb129d = t81bd * at + t81b * atd;
          btb += tb129 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          btbd += tb129d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] + tb129 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += tb129 * bt;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += tb129d * bt + tb129 * btd;
          atb = t81b * (bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1]);
          atbd = t81bd * (bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1]) + t81b * (btd *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] + bt *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1]);
          tb123 = dtb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          tb123d = dtbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] + dtb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          tb124 = tb123 * t80;
          tb124d = tb123d * t80 + tb123 * t80d;
          tb125 = tb124 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz);
          tb125d = tb124d * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) + tb124 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gzd +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gzd) * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gzd));
          fz2b += tb125 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz);
          fz2bd += tb125d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) + tb125 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfzd));
          tb126 = tb125 * fz2;
          tb126d = tb125d * fz2 + tb125 * fz2d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] += tb126;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] += tb126d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] += tb126 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] += tb126d * dfz + tb126 * dfzd;
          dfzb += tb126 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2];
          dfzbd += tb126d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] + tb126 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2];
          tb127 = tb124 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz));
          tb127d = tb124d * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz)) + tb124 * (fz2d *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) + fz2 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfzd)));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] += tb127 * gz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] += tb127d * gz + tb127 * gzd;
          gzb += tb127 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3];
          gzbd += tb127d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] + tb127 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3];
          tb128 = tb127 * gz;
          tb128d = tb127d * gz + tb127 * gzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] += tb128 * gz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] += tb128d * gz + tb128 * gzd;
          gzb += tb128 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4];
          gzbd += tb128d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] + tb128 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4];
          gzb += tb127 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz);
          gzbd += tb127d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz) + tb127 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gzd);
          t80b = tb123 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz));
          t80bd = tb123d * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz)) + tb123 * ((fz2d *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) + fz2 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfzd))) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gzd +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gzd) * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gzd)));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] += dtb * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t80);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] += dtbd * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t80) + dtb *
              (((fz2d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfzd)))
              * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gzd +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gzd) * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gzd))) * t80 + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t80d);
          tb122 = t80b / fz0_4;
          tb122d = (t80bd - tb122 * fz0_4d) * (1.0 / fz0_4);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb122;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb122d;
          fz0_4b = -(tb122 * t80);
          fz0_4bd = -(tb122d * t80 + tb122 * t80d);
          tb117 = btb / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb117d = (btbd - tb117 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY]) * (1.0 /
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY]);
          tb118 = tb117 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb118d = tb117d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + tb117 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb119 = tb118 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16);
          tb119d = tb118d * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) + tb118 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gzd +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16d));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] += tb119;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] += tb119d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] += tb119 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] += tb119d * dfz + tb119 * dfzd;
          dfzb += tb119 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2];
          dfzbd += tb119d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] + tb119 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2];
          tb120 = tb119 * dfz;
          tb120d = tb119d * dfz + tb119 * dfzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] += tb120 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] += tb120d * dfz + tb120 * dfzd;
          dfzb += tb120 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3];
          dfzbd += tb120d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] + tb120 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3];
          dfzb += tb119 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz);
          dfzbd += tb119d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz) + tb119 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfzd);
          tb121 = tb118 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfz);
          tb121d = tb118d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfz) + tb118 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfzd));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] += tb121 * gz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] += tb121d * gz + tb121 * gzd;
          gzb += tb121 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4];
          gzbd += tb121d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] + tb121 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] += tb121 * y16;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] += tb121d * y16 + tb121 * y16d;
          y16b = tb121 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5];
          y16bd = tb121d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] + tb121 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb117 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb117d *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16)) + tb117 *
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfzd)) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gzd +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16d)));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] -= tb117 * bt;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] -= tb117d * bt + tb117 * btd;
          /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
           * where straight running is, and exact from w on */
          if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            gzb += y16b;
            gzbd += y16bd;
            y16b = 0.0;
            y16bd = 0.0;
          } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            gzb -= y16b;
            gzbd -= y16bd;
            y16b = 0.0;
            y16bd = 0.0;
          } else {
            p9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            p9d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t79 = p9 * p9;
            t79d = p9d * p9 + p9 * p9d;
            z6 = gz * gz / t79;
            z6d = (gzd * gz + gz * gzd - z6 * t79d) * (1.0 / t79);
            tb115 = y16b * (15.0 + z6 * (-10.0 + 3.0 * z6));
            tb115d = y16bd * (15.0 + z6 * (-10.0 + 3.0 * z6)) + y16b * (z6d * (-10.0 + 3.0 * z6) +
                z6 * (3.0 * z6d));
            p9b = tb115 * z6 * 0.125;
            p9bd = (tb115d * z6 + tb115 * z6d) * 0.125;
            z6b = tb115 * (0.125 * p9);
            z6bd = tb115d * (0.125 * p9) + tb115 * (0.125 * p9d);
            tb116 = y16b * (0.125 * p9 * z6);
            tb116d = y16bd * (0.125 * p9 * z6) + y16b * (0.125 * p9d * z6 + 0.125 * p9 * z6d);
            z6b += tb116 * (-10.0 + 3.0 * z6);
            z6bd += tb116d * (-10.0 + 3.0 * z6) + tb116 * (3.0 * z6d);
            z6b += tb116 * z6 * 3.0;
            z6bd += (tb116d * z6 + tb116 * z6d) * 3.0;
            y16b = 0.0;
            y16bd = 0.0;
            tb114 = z6b / t79;
            tb114d = (z6bd - tb114 * t79d) * (1.0 / t79);
            gzb += tb114 * gz;
            gzbd += tb114d * gz + tb114 * gzd;
            gzb += tb114 * gz;
            gzbd += tb114d * gz + tb114 * gzd;
            t79b = -(tb114 * z6);
            t79bd = -(tb114d * z6 + tb114 * z6d);
            p9b += t79b * p9;
            p9bd += t79bd * p9 + t79b * p9d;
            p9b += t79b * p9;
            p9bd += t79bd * p9 + t79b * p9d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p9b;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p9bd;
          }
          t78b = areqb * (1.0 / (2.0 * areq));
          t78bd = areqbd * (1.0 / (2.0 * areq)) - areqb * (1.0 / (2.0 * areq) * (2.0 * areqd) / (2.0
              * areq));
          arb = t78b * ar;
          arbd = t78bd * ar + t78b * ard;
          arb += t78b * ar;
          arbd += t78bd * ar + t78b * ard;
          ratio2b = t78b * ratio2;
          ratio2bd = t78bd * ratio2 + t78b * ratio2d;
          ratio2b += t78b * ratio2;
          ratio2bd += t78bd * ratio2 + t78b * ratio2d;
          t77b = ateqb * (1.0 / (2.0 * ateq));
          t77bd = ateqbd * (1.0 / (2.0 * ateq)) - ateqb * (1.0 / (2.0 * ateq) * (2.0 * ateqd) / (2.0
              * ateq));
          atb += t77b * at;
          atbd += t77bd * at + t77b * atd;
          atb += t77b * at;
          atbd += t77bd * at + t77b * atd;
          ratio2b += t77b * ratio2;
          ratio2bd += t77bd * ratio2 + t77b * ratio2d;
          ratio2b += t77b * ratio2;
          ratio2bd += t77bd * ratio2 + t77b * ratio2d;
          a3b += arb;
          a3bd += arbd;
          shiftb = arb;
          shiftbd = arbd;
          a3b += atb;
          a3bd += atbd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ1] += atb;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ1] += atbd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] += atb * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] += atbd * dfz + atb * dfzd;
          dfzb += atb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2];
          dfzbd += atbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] + atb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2];
          tb113 = atb * gz;
          tb113d = atbd * gz + atb * gzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] += tb113;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] += tb113d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] += tb113 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] += tb113d * dfz + tb113 * dfzd;
          dfzb += tb113 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4];
          dfzbd += tb113d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] + tb113 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4];
          gzb += atb * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] * dfz);
          gzbd += atbd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] * dfz) + atb *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QHZ4] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] * dfzd));
          gamma2b += gzb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ];
          gamma2bd += gzbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ] + gzb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ] += gzb * gamma2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ] += gzbd * gamma2 + gzb * gamma2d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_4b *
              p[t->tyreadr[t->wheeltyre[n2]]];
          /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
           *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_4bd *
              p[t->tyreadr[t->wheeltyre[n2]]] + fz0_4b * pd[t->tyreadr[t->wheeltyre[n2]]];
          pb[t->tyreadr[t->wheeltyre[n2]]] += fz0_4b * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LFZO];
          pbd[t->tyreadr[t->wheeltyre[n2]]] += fz0_4bd * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LFZO] + fz0_4b * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO];
          y24b = shiftb;
          y24bd = shiftbd;
          y23b = bycyb;
          y23bd = bycybd;
          tb112 = ratio2b / y21;
          tb112d = (ratio2bd - tb112 * y21d) * (1.0 / y21);
          x51b = tb112 * kappa2;
          x51bd = tb112d * kappa2 + tb112 * kappa2d;
          kappa2b = tb112 * x51;
          kappa2bd = tb112d * x51 + tb112 * x51d;
          y21b = -(tb112 * ratio2);
          y21bd = -(tb112d * ratio2 + tb112 * ratio2d);
          g20b = fyb * y20;
          g20bd = fybd * y20 + fyb * y20d;
          y20b = fyb * g20;
          y20bd = fybd * g20 + fyb * g20d;
          g21b += fyb;
          g21bd += fybd;
          x50b = fxb * t76;
          x50bd = fxbd * t76 + fxb * t76d;
          t76b = fxb * x50;
          t76bd = fxbd * x50 + fxb * x50d;
          tb111 = t76b / t75;
          tb111d = (t76bd - tb111 * t75d) * (1.0 / t75);
          t70b = tb111;
          t70bd = tb111d;
          t75b = -(tb111 * t76);
          t75bd = -(tb111d * t76 + tb111 * t76d);
          t74b = -(t75b * sin(t74));
          t74bd = -(t75bd * sin(t74) + t75b * (cos(t74) * t74d));
          p8b = t74b * t73;
          p8bd = t74bd * t73 + t74b * t73d;
          t73b = t74b * p8;
          t73bd = t74bd * p8 + t74b * p8d;
          t72b = t73b * (1.0 / (1.0 + t72 * t72));
          t72bd = t73bd * (1.0 / (1.0 + t72 * t72)) - t73b * (1.0 / (1.0 + t72 * t72) * (t72d * t72
              + t72 * t72d) / (1.0 + t72 * t72));
          e11b = -(t72b * y15);
          e11bd = -(t72bd * y15 + t72b * y15d);
          y15b = t72b * (1.0 - e11);
          y15bd = t72bd * (1.0 - e11) - t72b * e11d;
          e11b += t72b * t71;
          e11bd += t72bd * t71 + t72b * t71d;
          t71b = t72b * e11;
          t71bd = t72bd * e11 + t72b * e11d;
          y15b += t71b * (1.0 / (1.0 + y15 * y15));
          y15bd += t71bd * (1.0 / (1.0 + y15 * y15)) - t71b * (1.0 / (1.0 + y15 * y15) * (y15d * y15
              + y15 * y15d) / (1.0 + y15 * y15));
          t69b = -(t70b * sin(t69));
          t69bd = -(t70bd * sin(t69) + t70b * (cos(t69) * t69d));
          p8b += t69b * t68;
          p8bd += t69bd * t68 + t69b * t68d;
          t68b = t69b * p8;
          t68bd = t69bd * p8 + t69b * p8d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += p8b;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += p8bd;
          t67b = t68b * (1.0 / (1.0 + t67 * t67));
          t67bd = t68bd * (1.0 / (1.0 + t67 * t67)) - t68b * (1.0 / (1.0 + t67 * t67) * (t67d * t67
              + t67 * t67d) / (1.0 + t67 * t67));
          e11b -= t67b * y14;
          e11bd -= t67bd * y14 + t67b * y14d;
          y14b = t67b * (1.0 - e11);
          y14bd = t67bd * (1.0 - e11) - t67b * e11d;
          e11b += t67b * t66;
          e11bd += t67bd * t66 + t67b * t66d;
          t66b = t67b * e11;
          t66bd = t67bd * e11 + t67b * e11d;
          y14b += t66b * (1.0 / (1.0 + y14 * y14));
          y14bd += t66bd * (1.0 / (1.0 + y14 * y14)) - t66b * (1.0 / (1.0 + y14 * y14) * (y14d * y14
              + y14 * y14d) / (1.0 + y14 * y14));
          stiff4b = y15b * p7;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff4bd = y15bd * p7 + y15b * p7d;
          p7b = y15b * stiff4;
          p7bd = y15bd * stiff4 + y15b * stiff4d;
          stiff4b += y14b * (a3 + p7);
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff4bd += y14bd * (a3 + p7) + y14b * (a3d + p7d);
          tb110 = y14b * stiff4;
          tb110d = y14bd * stiff4 + y14b * stiff4d;
          a3b += tb110;
          a3bd += tb110d;
          p7b += tb110;
          p7bd += tb110d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1] += p7b;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1] += p7bd;
          y13b = e11b;
          y13bd = e11bd;
          e12b = 0.0;
          e12bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e12) > 1.0) {
            y13b = 0.0;
            y13bd = 0.0;
          } else {
            e12b += y13b;
            e12bd += y13bd;
            y13b = 0.0;
            y13bd = 0.0;
          }
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] += e12b;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] += e12bd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] += e12b * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] += e12bd * dfz + e12b * dfzd;
          dfzb += e12b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2];
          dfzbd += e12bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] + e12b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2];
          tb109 = stiff4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          tb109d = stiff4bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + stiff4b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb109 * t65;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb109d * t65 + tb109 * t65d;
          t65b = tb109 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
          t65bd = tb109d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] + tb109 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += stiff4b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t65);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += stiff4bd *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t65) + stiff4b *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t65 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t65d);
          tb108 = t65b / t64;
          tb108d = (t65bd - tb108 * t64d) * (1.0 / t64);
          t64b = -(tb108 * t65);
          t64bd = -(tb108d * t65 + tb108 * t65d);
          t63b = t64b * (1.0 / (2.0 * t64));
          t63bd = t64bd * (1.0 / (2.0 * t64)) - t64b * (1.0 / (2.0 * t64) * (2.0 * t64d) / (2.0 *
              t64));
          x8b = t63b * x8;
          x8bd = t63bd * x8 + t63b * x8d;
          x8b += t63b * x8;
          x8bd += t63bd * x8 + t63b * x8d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x8b * kappa2;
          /* Gxa = Fx / Fx0 */
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x8bd * kappa2 + x8b * kappa2d;
          kappa2b += x8b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
          kappa2bd += x8bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] + x8b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
          tb107 = g21b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          tb107d = g21bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + g21b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          dvb = tb107 * t62;
          dvbd = tb107d * t62 + tb107 * t62d;
          t62b = tb107 * dv;
          t62bd = tb107d * dv + tb107 * dvd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g21b * (dv * t62);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g21bd * (dv * t62) + g21b * (dvd *
              t62 + dv * t62d);
          t61b = t62b * cos(t61);
          t61bd = t62bd * cos(t61) - t62b * (sin(t61) * t61d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t61b * t60;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t61bd * t60 + t61b * t60d;
          t60b = t61b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
          t60bd = t61bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] + t61b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
          t59b = t60b * (1.0 / (1.0 + t59 * t59));
          t59bd = t60bd * (1.0 / (1.0 + t59 * t59)) - t60b * (1.0 / (1.0 + t59 * t59) * (t59d * t59
              + t59 * t59d) / (1.0 + t59 * t59));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t59b * kappa2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t59bd * kappa2 + t59b * kappa2d;
          kappa2b += t59b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
          kappa2bd += t59bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] + t59b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
          tb106 = g20b / t58;
          tb106d = (g20bd - tb106 * t58d) * (1.0 / t58);
          t53b = tb106;
          t53bd = tb106d;
          t58b = -(tb106 * g20);
          t58bd = -(tb106d * g20 + tb106 * g20d);
          t57b = -(t58b * sin(t57));
          t57bd = -(t58bd * sin(t57) + t58b * (cos(t57) * t57d));
          p6b = t57b * t56;
          p6bd = t57bd * t56 + t57b * t56d;
          t56b = t57b * p6;
          t56bd = t57bd * p6 + t57b * p6d;
          t55b = t56b * (1.0 / (1.0 + t55 * t55));
          t55bd = t56bd * (1.0 / (1.0 + t55 * t55)) - t56b * (1.0 / (1.0 + t55 * t55) * (t55d * t55
              + t55 * t55d) / (1.0 + t55 * t55));
          e9b = -(t55b * y12);
          e9bd = -(t55bd * y12 + t55b * y12d);
          y12b = t55b * (1.0 - e9);
          y12bd = t55bd * (1.0 - e9) - t55b * e9d;
          e9b += t55b * t54;
          e9bd += t55bd * t54 + t55b * t54d;
          t54b = t55b * e9;
          t54bd = t55bd * e9 + t55b * e9d;
          y12b += t54b * (1.0 / (1.0 + y12 * y12));
          y12bd += t54bd * (1.0 / (1.0 + y12 * y12)) - t54b * (1.0 / (1.0 + y12 * y12) * (y12d * y12
              + y12 * y12d) / (1.0 + y12 * y12));
          t52b = -(t53b * sin(t52));
          t52bd = -(t53bd * sin(t52) + t53b * (cos(t52) * t52d));
          p6b += t52b * t51;
          p6bd += t52bd * t51 + t52b * t51d;
          t51b = t52b * p6;
          t51bd = t52bd * p6 + t52b * p6d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += p6b;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += p6bd;
          t50b = t51b * (1.0 / (1.0 + t50 * t50));
          t50bd = t51bd * (1.0 / (1.0 + t50 * t50)) - t51b * (1.0 / (1.0 + t50 * t50) * (t50d * t50
              + t50 * t50d) / (1.0 + t50 * t50));
          e9b -= t50b * y11;
          e9bd -= t50bd * y11 + t50b * y11d;
          y11b = t50b * (1.0 - e9);
          y11bd = t50bd * (1.0 - e9) - t50b * e9d;
          e9b += t50b * t49;
          e9bd += t50bd * t49 + t50b * t49d;
          t49b = t50b * e9;
          t49bd = t50bd * e9 + t50b * e9d;
          y11b += t49b * (1.0 / (1.0 + y11 * y11));
          y11bd += t49bd * (1.0 / (1.0 + y11 * y11)) - t49b * (1.0 / (1.0 + y11 * y11) * (y11d * y11
              + y11 * y11d) / (1.0 + y11 * y11));
          stiff3b = y12b * s4;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff3bd = y12bd * s4 + y12b * s4d;
          s4b = y12b * stiff3;
          s4bd = y12bd * stiff3 + y12b * stiff3d;
          stiff3b += y11b * (kappa2 + s4);
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff3bd += y11bd * (kappa2 + s4) + y11b * (kappa2d + s4d);
          tb105 = y11b * stiff3;
          tb105d = y11bd * stiff3 + y11b * stiff3d;
          kappa2b += tb105;
          kappa2bd += tb105d;
          s4b += tb105;
          s4bd += tb105d;
          tb102 = dvb * t48;
          tb102d = dvbd * t48 + dvb * t48d;
          tb103 = tb102 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2);
          tb103d = tb102d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) + tb102 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2d));
          muy2b = tb103 * fz2;
          muy2bd = tb103d * fz2 + tb103 * fz2d;
          fz2b += tb103 * muy2;
          fz2bd += tb103d * muy2 + tb103 * muy2d;
          tb104 = tb102 * (muy2 * fz2);
          tb104d = tb102d * (muy2 * fz2) + tb102 * (muy2d * fz2 + muy2 * fz2d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb104;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb104d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb104 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb104d * dfz + tb104 * dfzd;
          dfzb += tb104 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
          dfzbd += tb104d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] + tb104 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb104 * gamma2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb104d * gamma2 + tb104 * gamma2d;
          gamma2b += tb104 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
          gamma2bd += tb104d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] + tb104 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
          t48b = dvb * (muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2));
          t48bd = dvbd * (muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2)) + dvb * ((muy2d * fz2 +
              muy2 * fz2d) * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) + muy2 * fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2d)));
          tb101 = t48b / t47;
          tb101d = (t48bd - tb101 * t47d) * (1.0 / t47);
          t47b = -(tb101 * t48);
          t47bd = -(tb101d * t48 + tb101 * t48d);
          t46b = t47b * (1.0 / (2.0 * t47));
          t46bd = t47bd * (1.0 / (2.0 * t47)) - t47b * (1.0 / (2.0 * t47) * (2.0 * t47d) / (2.0 *
              t47));
          x7b = t46b * x7;
          x7bd = t46bd * x7 + t46b * x7d;
          x7b += t46b * x7;
          x7bd += t46bd * x7 + t46b * x7d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] += x7b * a3;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] += x7bd * a3 + x7b * a3d;
          a3b += x7b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
          a3bd += x7bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] + x7b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] += s4b;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] += s4bd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] += s4b * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] += s4bd * dfz + s4b * dfzd;
          dfzb += s4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2];
          dfzbd += s4bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] + s4b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2];
          y10b = e9b;
          y10bd = e9bd;
          e10b = 0.0;
          e10bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e10) > 1.0) {
            y10b = 0.0;
            y10bd = 0.0;
          } else {
            e10b += y10b;
            e10bd += y10bd;
            y10b = 0.0;
            y10bd = 0.0;
          }
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] += e10b;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] += e10bd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] += e10b * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] += e10bd * dfz + e10b * dfzd;
          dfzb += e10b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2];
          dfzbd += e10bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] + e10b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2];
          tb100 = stiff3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          tb100d = stiff3bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + stiff3b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb100 * t45;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb100d * t45 + tb100 * t45d;
          t45b = tb100 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
          t45bd = tb100d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] + tb100 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += stiff3b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t45);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += stiff3bd *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t45) + stiff3b *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t45 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t45d);
          tb99 = t45b / t44;
          tb99d = (t45bd - tb99 * t44d) * (1.0 / t44);
          t44b = -(tb99 * t45);
          t44bd = -(tb99d * t45 + tb99 * t45d);
          t43b = t44b * (1.0 / (2.0 * t44));
          t43bd = t44bd * (1.0 / (2.0 * t44)) - t44b * (1.0 / (2.0 * t44) * (2.0 * t44d) / (2.0 *
              t44));
          x6b = t43b * x6;
          x6bd = t43bd * x6 + t43b * x6d;
          x6b += t43b * x6;
          x6bd += t43bd * x6 + t43b * x6d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x6b * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x6bd * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + x6b * (a3d -
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          tb98 = x6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
          tb98d = x6bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] + x6b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
          a3b += tb98;
          a3bd += tb98d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb98;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb98d;
          y22b = muy2b;
          y22bd = muy2bd;
          shyb = y24b;
          shybd = y24bd;
          t42b = y24b;
          t42bd = y24bd;
          tb97 = t42b / stiff2;
          tb97d = (t42bd - tb97 * stiff2d) * (1.0 / stiff2);
          svyb = tb97;
          svybd = tb97d;
          stiff2b = -(tb97 * t42);
          stiff2bd = -(tb97d * t42 + tb97 * t42d);
          byb = y23b * cy;
          bybd = y23bd * cy + y23b * cyd;
          cyb = y23b * by;
          cybd = y23bd * by + y23b * byd;
          muyb = y22b;
          muybd = y22bd;
          stiff2b += y21b;
          stiff2bd += y21bd;
          dyb = y20b * t41;
          dybd = y20bd * t41 + y20b * t41d;
          t41b = y20b * dy;
          t41bd = y20bd * dy + y20b * dyd;
          svyb += y20b;
          svybd += y20bd;
          t40b = t41b * cos(t40);
          t40bd = t41bd * cos(t40) - t41b * (sin(t40) * t40d);
          cyb += t40b * t39;
          cybd += t40bd * t39 + t40b * t39d;
          t39b = t40b * cy;
          t39bd = t40bd * cy + t40b * cyd;
          t38b = t39b * (1.0 / (1.0 + t38 * t38));
          t38bd = t39bd * (1.0 / (1.0 + t38 * t38)) - t39b * (1.0 / (1.0 + t38 * t38) * (t38d * t38
              + t38 * t38d) / (1.0 + t38 * t38));
          eyb = -(t38b * y9);
          eybd = -(t38bd * y9 + t38b * y9d);
          y9b = t38b * (1.0 - ey);
          y9bd = t38bd * (1.0 - ey) - t38b * eyd;
          eyb += t38b * t37;
          eybd += t38bd * t37 + t38b * t37d;
          t37b = t38b * ey;
          t37bd = t38bd * ey + t38b * eyd;
          y9b += t37b * (1.0 / (1.0 + y9 * y9));
          y9bd += t37bd * (1.0 / (1.0 + y9 * y9)) - t37b * (1.0 / (1.0 + y9 * y9) * (y9d * y9 + y9 *
              y9d) / (1.0 + y9 * y9));
          byb += y9b * ay;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          bybd += y9bd * ay + y9b * ayd;
          ayb = y9b * by;
          aybd = y9bd * by + y9b * byd;
          tb93 = svyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb93d = svybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + svyb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          fz2b += tb93 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy);
          fz2bd += tb93d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) +
              tb93 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd)) * gy +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY4] * dfz) * gyd));
          tb94 = tb93 * fz2;
          tb94d = tb93d * fz2 + tb93 * fz2d;
          tb95 = tb94 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
          tb95d = tb94d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + tb94 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb95;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb95d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb95 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb95d * dfz + tb95 * dfzd;
          dfzb += tb95 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
          dfzbd += tb95d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] + tb95 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb94 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY2] * dfz);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb94d *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY2] * dfz) + tb94 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd));
          tb96 = tb94 * gy;
          tb96d = tb94d * gy + tb94 * gyd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb96;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb96d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb96 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb96d * dfz + tb96 * dfzd;
          dfzb += tb96 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
          dfzbd += tb96d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] + tb96 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
          gyb = tb94 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz);
          gybd = tb94d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) + tb94 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVY4] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += svyb * (fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY4] * dfz) * gy));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += svybd * (fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY4] * dfz) * gy)) + svyb * (fz2d * ((p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) +
              fz2 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd)) * gy +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY4] * dfz) * gyd)));
          tb92 = byb / t36;
          tb92d = (bybd - tb92 * t36d) * (1.0 / t36);
          stiff2b += tb92;
          stiff2bd += tb92d;
          t36b = -(tb92 * by);
          t36bd = -(tb92d * by + tb92 * byd);
          cyb += t36b * dy;
          cybd += t36bd * dy + t36b * dyd;
          dyb += t36b * cy;
          dybd += t36bd * cy + t36b * cyd;
          tb88 = stiff2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb88d = stiff2bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + stiff2b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb89 = tb88 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8);
          tb89d = tb88d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) - tb88 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8d);
          tb90 = tb89 * t35;
          tb90d = tb89d * t35 + tb89 * t35d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb90 * fz0_3;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb90d * fz0_3 + tb90 * fz0_3d;
          fz0_3b = tb90 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
          fz0_3bd = tb90d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] + tb90 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
          t35b = tb89 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3);
          t35bd = tb89d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3) + tb89 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3d);
          tb91 = tb88 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35);
          tb91d = tb88d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35) + tb88 *
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3d) * t35 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb91 * y8;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb91d * y8 + tb91 * y8d;
          y8b = -(tb91 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
          y8bd = -(tb91d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] + tb91 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += stiff2b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += stiff2bd *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8)) + stiff2b *
              (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3d) * t35 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35d) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8d));
          tb87 = t35b / t34;
          tb87d = (t35bd - tb87 * t34d) * (1.0 / t34);
          z4b = tb87 * 2.0;
          z4bd = tb87d * 2.0;
          t34b = -(tb87 * t35);
          t34bd = -(tb87d * t35 + tb87 * t35d);
          z4b += t34b * z4;
          z4bd += t34bd * z4 + t34b * z4d;
          z4b += t34b * z4;
          z4bd += t34bd * z4 + t34b * z4d;
          /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
           * where straight running is, and exact from w on */
          if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            gyb += y8b;
            gybd += y8bd;
            y8b = 0.0;
            y8bd = 0.0;
          } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            gyb -= y8b;
            gybd -= y8bd;
            y8b = 0.0;
            y8bd = 0.0;
          } else {
            p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            p5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t33 = p5 * p5;
            t33d = p5d * p5 + p5 * p5d;
            z5 = gy * gy / t33;
            z5d = (gyd * gy + gy * gyd - z5 * t33d) * (1.0 / t33);
            tb85 = y8b * (15.0 + z5 * (-10.0 + 3.0 * z5));
            tb85d = y8bd * (15.0 + z5 * (-10.0 + 3.0 * z5)) + y8b * (z5d * (-10.0 + 3.0 * z5) + z5 *
                (3.0 * z5d));
            p5b = tb85 * z5 * 0.125;
            p5bd = (tb85d * z5 + tb85 * z5d) * 0.125;
            z5b = tb85 * (0.125 * p5);
            z5bd = tb85d * (0.125 * p5) + tb85 * (0.125 * p5d);
            tb86 = y8b * (0.125 * p5 * z5);
            tb86d = y8bd * (0.125 * p5 * z5) + y8b * (0.125 * p5d * z5 + 0.125 * p5 * z5d);
            z5b += tb86 * (-10.0 + 3.0 * z5);
            z5bd += tb86d * (-10.0 + 3.0 * z5) + tb86 * (3.0 * z5d);
            z5b += tb86 * z5 * 3.0;
            z5bd += (tb86d * z5 + tb86 * z5d) * 3.0;
            y8b = 0.0;
            y8bd = 0.0;
            tb84 = z5b / t33;
            tb84d = (z5bd - tb84 * t33d) * (1.0 / t33);
            gyb += tb84 * gy;
            gybd += tb84d * gy + tb84 * gyd;
            gyb += tb84 * gy;
            gybd += tb84d * gy + tb84 * gyd;
            t33b = -(tb84 * z5);
            t33bd = -(tb84d * z5 + tb84 * z5d);
            p5b += t33b * p5;
            p5bd += t33bd * p5 + t33b * p5d;
            p5b += t33b * p5;
            p5bd += t33bd * p5 + t33b * p5d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p5b;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p5bd;
          }
          tb83 = z4b / t32;
          tb83d = (z4bd - tb83 * t32d) * (1.0 / t32);
          fz2b += tb83;
          fz2bd += tb83d;
          t32b = -(tb83 * z4);
          t32bd = -(tb83d * z4 + tb83 * z4d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t32b * fz0_3;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t32bd * fz0_3 + t32b * fz0_3d;
          fz0_3b += t32b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2];
          fz0_3bd += t32bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] + t32b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2];
          e6b = 0.0;
          e6bd = 0.0;
          if (MAGGI_RE(ay) > 0.0) {
            e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            e7d = e6d * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy)) - e6 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gyd));
            y6b = eyb;
            y6bd = eybd;
            eyb = 0.0;
            eybd = 0.0;
            e7b = 0.0;
            e7bd = 0.0;
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e7) > 1.0) {
              y6b = 0.0;
              y6bd = 0.0;
            } else {
              e7b += y6b;
              e7bd += y6bd;
              y6b = 0.0;
              y6bd = 0.0;
            }
            e6b += e7b * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            e6bd += e7bd * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy)) - e7b *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gyd));
            tb81 = e7b * e6;
            tb81d = e7bd * e6 + e7b * e6d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb81;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb81d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb81 * gy;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb81d * gy + tb81 * gyd;
            gyb -= tb81 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
            gybd -= tb81d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] + tb81 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
          } else {
            e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            e8d = e6d * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy)) + e6 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gyd));
            y7b = eyb;
            y7bd = eybd;
            eyb = 0.0;
            eybd = 0.0;
            e8b = 0.0;
            e8bd = 0.0;
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e8) > 1.0) {
              y7b = 0.0;
              y7bd = 0.0;
            } else {
              e8b += y7b;
              e8bd += y7bd;
              y7b = 0.0;
              y7bd = 0.0;
            }
            e6b += e8b * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            e6bd += e8bd * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy)) + e8b *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gyd));
            tb82 = e8b * e6;
            tb82d = e8bd * e6 + e8b * e6d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb82;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb82d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb82 * gy;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb82d * gy + tb82 * gyd;
            gyb += tb82 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
            gybd += tb82d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] + tb82 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
          }
          tb80 = e6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
          tb80d = e6bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] + e6b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb80;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb80d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb80 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb80d * dfz + tb80 * dfzd;
          dfzb += tb80 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2];
          dfzbd += tb80d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] + tb80 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] += e6b * (p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] += e6bd *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEY2] * dfz) + e6b * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfzd));
          muyb += dyb * fz2;
          muybd += dybd * fz2 + dyb * fz2d;
          fz2b += dyb * muy;
          fz2bd += dybd * muy + dyb * muyd;
          tb76 = muyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb76d = muybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + muyb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb77 = tb76 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy);
          tb77d = tb76d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy) - tb76
              * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gyd) * gy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gyd);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb77;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb77d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb77 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb77d * dfz + tb77 * dfzd;
          dfzb += tb77 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
          dfzbd += tb77d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] + tb77 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
          tb78 = tb76 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz);
          tb78d = tb76d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz) + tb76 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd));
          tb79 = tb78 * gy;
          tb79d = tb78d * gy + tb78 * gyd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb79 * gy;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb79d * gy + tb79 * gyd;
          gyb -= tb79 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
          gybd -= tb79d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] + tb79 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
          gyb -= tb78 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy);
          gybd -= tb78d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy) + tb78 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gyd);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += muyb *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] *
              gy * gy));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += muybd *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] *
              gy * gy)) + muyb * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd)) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy) -
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gyd) * gy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gyd));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] += cyb * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_LCY];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] += cybd *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY] + cyb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY] += cyb * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PCY1];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY] += cybd *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] + cyb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1];
          a3b += ayb;
          a3bd += aybd;
          shyb += ayb;
          shybd += aybd;
          tb75 = shyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
          tb75d = shybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + shyb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb75;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb75d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb75 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb75d * dfz + tb75 * dfzd;
          dfzb += tb75 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2];
          dfzbd += tb75d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] + tb75 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] += shyb *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHY2] * dfz);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] += shybd *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHY2] * dfz) + shyb * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfzd));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] += shyb * gy;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] += shybd * gy + shyb * gyd;
          gyb += shyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3];
          gybd += shybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] + shyb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3];
          gamma2b += gyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
          gamma2bd += gybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] + gyb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] += gyb * gamma2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] += gybd * gamma2 + gyb * gamma2d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_3b *
              p[t->tyreadr[t->wheeltyre[n2]]];
          /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_3bd *
              p[t->tyreadr[t->wheeltyre[n2]]] + fz0_3b * pd[t->tyreadr[t->wheeltyre[n2]]];
          pb[t->tyreadr[t->wheeltyre[n2]]] += fz0_3b * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LFZO];
          pbd[t->tyreadr[t->wheeltyre[n2]]] += fz0_3bd * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LFZO] + fz0_3b * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO];
          stiffb = x51b;
          stiffbd = x51bd;
          dxb = x50b * t31;
          dxbd = x50bd * t31 + x50b * t31d;
          t31b = x50b * dx;
          t31bd = x50bd * dx + x50b * dxd;
          svxb = x50b;
          svxbd = x50bd;
          t30b = t31b * cos(t30);
          t30bd = t31bd * cos(t30) - t31b * (sin(t30) * t30d);
          cxb = t30b * t29;
          cxbd = t30bd * t29 + t30b * t29d;
          t29b = t30b * cx;
          t29bd = t30bd * cx + t30b * cxd;
          t28b = t29b * (1.0 / (1.0 + t28 * t28));
          t28bd = t29bd * (1.0 / (1.0 + t28 * t28)) - t29b * (1.0 / (1.0 + t28 * t28) * (t28d * t28
              + t28 * t28d) / (1.0 + t28 * t28));
          exb = -(t28b * y5);
          exbd = -(t28bd * y5 + t28b * y5d);
          y5b = t28b * (1.0 - ex);
          y5bd = t28bd * (1.0 - ex) - t28b * exd;
          exb += t28b * t27;
          exbd += t28bd * t27 + t28b * t27d;
          t27b = t28b * ex;
          t27bd = t28bd * ex + t28b * exd;
          y5b += t27b * (1.0 / (1.0 + y5 * y5));
          y5bd += t27bd * (1.0 / (1.0 + y5 * y5)) - t27b * (1.0 / (1.0 + y5 * y5) * (y5d * y5 + y5 *
              y5d) / (1.0 + y5 * y5));
          bxb = y5b * kx;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          bxbd = y5bd * kx + y5b * kxd;
          kxb = y5b * bx;
          kxbd = y5bd * bx + y5b * bxd;
          tb72 = svxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb72d = svxbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + svxb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb73 = tb72 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
          tb73d = tb72d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + tb72 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
          fz2b += tb73 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz);
          fz2bd += tb73d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + tb73 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd));
          tb74 = tb73 * fz2;
          tb74d = tb73d * fz2 + tb73 * fz2d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb74;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb74d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb74 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb74d * dfz + tb74 * dfzd;
          dfzb += tb74 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
          dfzbd += tb74d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] + tb74 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb72 * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb72d * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz)) + tb72 * (fz2d * (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] *
              dfzd)));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += svxb * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += svxbd * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]) + svxb *
              ((fz2d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd)))
              * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]);
          tb71 = bxb / t26;
          tb71d = (bxbd - tb71 * t26d) * (1.0 / t26);
          stiffb += tb71;
          stiffbd += tb71d;
          t26b = -(tb71 * bx);
          t26bd = -(tb71d * bx + tb71 * bxd);
          cxb += t26b * dx;
          cxbd += t26bd * dx + t26b * dxd;
          dxb += t26b * cx;
          dxbd += t26bd * cx + t26b * cxd;
          tb68 = stiffb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          tb68d = stiffbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + stiffb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          tb69 = tb68 * t25;
          tb69d = tb68d * t25 + tb68 * t25d;
          fz2b += tb69 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz);
          fz2bd += tb69d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + tb69 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd));
          tb70 = tb69 * fz2;
          tb70d = tb69d * fz2 + tb69 * fz2d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb70;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb70d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb70 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb70d * dfz + tb70 * dfzd;
          dfzb += tb70 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
          dfzbd += tb70d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] + tb70 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
          t25b = tb68 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz));
          t25bd = tb68d * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz)) + tb68 * (fz2d *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) + fz2 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd)));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += stiffb * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) * t25);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += stiffbd * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) * t25) + stiffb * ((fz2d * (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd)))
              * t25 + fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t25d);
          t24b = t25b * t25;
          t24bd = t25bd * t25 + t25b * t25d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t24b * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t24bd * dfz + t24b * dfzd;
          dfzb += t24b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3];
          dfzbd += t24bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] + t24b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3];
          e3b = 0.0;
          e3bd = 0.0;
          if (MAGGI_RE(kx) > 0.0) {
            e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            e4d = e3d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) - e3 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
            y3b = exb;
            y3bd = exbd;
            exb = 0.0;
            exbd = 0.0;
            e4b = 0.0;
            e4bd = 0.0;
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e4) > 1.0) {
              y3b = 0.0;
              y3bd = 0.0;
            } else {
              e4b += y3b;
              e4bd += y3bd;
              y3b = 0.0;
              y3bd = 0.0;
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
            y4b = exb;
            y4bd = exbd;
            exb = 0.0;
            exbd = 0.0;
            e5b = 0.0;
            e5bd = 0.0;
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e5) > 1.0) {
              y4b = 0.0;
              y4bd = 0.0;
            } else {
              e5b += y4b;
              e5bd += y4bd;
              y4b = 0.0;
              y4bd = 0.0;
            }
            e3b += e5b * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            e3bd += e5bd * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) + e5b *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4] += e5b * e3;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4] += e5bd * e3 + e5b * e3d;
          }
          tb66 = e3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
          tb66d = e3bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] + e3b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb66;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb66d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb66 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb66d * dfz + tb66 * dfzd;
          dfzb += tb66 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2];
          dfzbd += tb66d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] + tb66 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2];
          tb67 = tb66 * dfz;
          tb67d = tb66d * dfz + tb66 * dfzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb67 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb67d * dfz + tb67 * dfzd;
          dfzb += tb67 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
          dfzbd += tb67d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] + tb67 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
          dfzb += tb66 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz);
          dfzbd += tb66d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) + tb66 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfzd);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] += e3b * (p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz * dfz);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] += e3bd *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz *
              dfz) + e3b * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz * dfzd));
          muxb = dxb * fz2;
          muxbd = dxbd * fz2 + dxb * fz2d;
          fz2b += dxb * mux;
          fz2bd += dxbd * mux + dxb * muxd;
          tb62 = muxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb62d = muxbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + muxb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb63 = tb62 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx);
          tb63d = tb62d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx) - tb62
              * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gxd) * gx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gxd);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb63;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb63d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb63 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb63d * dfz + tb63 * dfzd;
          dfzb += tb63 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
          dfzbd += tb63d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] + tb63 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
          tb64 = tb62 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz);
          tb64d = tb62d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz) + tb62 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd));
          tb65 = tb64 * gx;
          tb65d = tb64d * gx + tb64 * gxd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb65 * gx;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb65d * gx + tb65 * gxd;
          gxb = -(tb65 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
          gxbd = -(tb65d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] + tb65 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
          gxb -= tb64 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx);
          gxbd -= tb64d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx) + tb64 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gxd);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += muxb *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] *
              gx * gx));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += muxbd *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] *
              gx * gx)) + muxb * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd)) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx) -
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gxd) * gx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gxd));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] += cxb * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_LCX];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] += cxbd *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX] + cxb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX] += cxb * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PCX1];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX] += cxbd *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] + cxb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1];
          gamma2b += gxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
          gamma2bd += gxbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] + gxb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] += gxb * gamma2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] += gxbd * gamma2 + gxb * gamma2d;
          kappa2b += kxb;
          /* Fx0, Kx */
          kappa2bd += kxbd;
          tb61 = kxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
          tb61d = kxbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] + kxb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb61;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb61d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb61 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb61d * dfz + tb61 * dfzd;
          dfzb += tb61 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
          dfzbd += tb61d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] + tb61 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxbd *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHX2] * dfz) + kxb * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfzd));
          tb60 = dfzb / fz0_2;
          tb60d = (dfzbd - tb60 * fz0_2d) * (1.0 / fz0_2);
          fz2b += tb60;
          fz2bd += tb60d;
          fz0_2b -= tb60;
          fz0_2bd -= tb60d;
          fz0_2b -= tb60 * dfz;
          fz0_2bd -= tb60d * dfz + tb60 * dfzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += r0b;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += r0bd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_2b *
              p[t->tyreadr[t->wheeltyre[n2]]];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_2bd *
              p[t->tyreadr[t->wheeltyre[n2]]] + fz0_2b * pd[t->tyreadr[t->wheeltyre[n2]]];
          pb[t->tyreadr[t->wheeltyre[n2]]] += fz0_2b * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LFZO];
          pbd[t->tyreadr[t->wheeltyre[n2]]] += fz0_2bd * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LFZO] + fz0_2b * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO];
          one3b += fz2b;
          one3bd += fz2bd;
          one2b += gamma2b;
          one2bd += gamma2bd;
          one1b += a3b;
          one1bd += a3bd;
          one0b += kappa2b;
          one0bd += kappa2bd;
        } else {
          rolling5b = 0.0;
          rolling5bd = 0.0;
          rolling4b = 0.0;
          rolling4bd = 0.0;
          rolling3b = 0.0;
          rolling3bd = 0.0;
          fzb += rolling2b;
          fzbd += rolling2bd;
          rolling2b = 0.0;
          rolling2bd = 0.0;
          rolling1b = 0.0;
          rolling1bd = 0.0;
          rolling0b = 0.0;
          rolling0bd = 0.0;
        }
        vxb += one4b;
        vxbd += one4bd;
        fzb += one3b;
        fzbd += one3bd;
        gammab += one2b * side;
        gammabd += one2bd * side;
        a2b += one1b * side;
        a2bd += one1bd * side;
        kappab += one0b;
        kappabd += one0bd;
      } else {
        rolling5b = 0.0;
        rolling5bd = 0.0;
        rolling4b = 0.0;
        rolling4bd = 0.0;
        rolling3b = 0.0;
        rolling3bd = 0.0;
        rolling2b = 0.0;
        rolling2bd = 0.0;
        rolling1b = 0.0;
        rolling1bd = 0.0;
        rolling0b = 0.0;
        rolling0bd = 0.0;
      }
      z21b += gammab * (z22 / (z22 * z22 + z21 * z21));
      z21bd += gammabd * (z22 / (z22 * z22 + z21 * z21)) + gammab * ((z22d - z22 / (z22 * z22 + z21
          * z21) * (z22d * z22 + z22 * z22d + (z21d * z21 + z21 * z21d))) / (z22 * z22 + z21 *
          z21));
      z22b -= gammab * (z21 / (z22 * z22 + z21 * z21));
      z22bd -= gammabd * (z21 / (z22 * z22 + z21 * z21)) + gammab * ((z21d - z21 / (z22 * z22 + z21
          * z21) * (z22d * z22 + z22 * z22d + (z21d * z21 + z21 * z21d))) / (z22 * z22 + z21 *
          z21));
      tb59 = a2b / speed2;
      tb59d = (a2bd - tb59 * speed2d) * (1.0 / speed2);
      v20b += tb59 * L0;
      v20bd += tb59d * L0 + tb59 * L0d;
      L0b += tb59 * v20;
      L0bd += tb59d * v20 + tb59 * v20d;
      v21b += tb59 * L1;
      v21bd += tb59d * L1 + tb59 * L1d;
      L1b += tb59 * v21;
      L1bd += tb59d * v21 + tb59 * v21d;
      v22b += tb59 * L2;
      v22bd += tb59d * L2 + tb59 * L2d;
      L2b += tb59 * v22;
      L2bd += tb59d * v22 + tb59 * v22d;
      speed2b -= tb59 * a2;
      speed2bd -= tb59d * a2 + tb59 * a2d;
      tb58 = kappab / speed2;
      tb58d = (kappabd - tb58 * speed2d) * (1.0 / speed2);
      omegab += tb58 * re;
      omegabd += tb58d * re + tb58 * red;
      reb += tb58 * omega;
      rebd += tb58d * omega + tb58 * omegad;
      vxb -= tb58;
      vxbd -= tb58d;
      speed2b -= tb58 * kappa;
      speed2bd -= tb58d * kappa + tb58 * kappad;
      yb += speed2b;
      ybd += speed2bd;
      /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
      if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW])) {
        vxb += yb;
        vxbd += ybd;
        yb = 0.0;
        ybd = 0.0;
      } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW])) {
        vxb -= yb;
        vxbd -= ybd;
        yb = 0.0;
        ybd = 0.0;
      } else {
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW];
        p4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW];
        t23 = vx * vx / p4;
        t23d = (vxd * vx + vx * vxd - t23 * p4d) * (1.0 / p4);
        tb57 = yb * 0.5;
        tb57d = ybd * 0.5;
        p4b = tb57;
        p4bd = tb57d;
        t23b = tb57;
        t23bd = tb57d;
        yb = 0.0;
        ybd = 0.0;
        tb56 = t23b / p4;
        tb56d = (t23bd - tb56 * p4d) * (1.0 / p4);
        vxb += tb56 * vx;
        vxbd += tb56d * vx + tb56 * vxd;
        vxb += tb56 * vx;
        vxbd += tb56d * vx + tb56 * vxd;
        p4b -= tb56 * t23;
        p4bd -= tb56d * t23 + tb56 * t23d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW] += p4b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW] += p4bd;
      }
      p3b += reb;
      p3bd += rebd;
      t20b -= reb * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio);
      t20bd -= rebd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio) + reb *
          (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22d +
          (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratiod));
      tb55 = reb * t20;
      tb55d = rebd * t20 + reb * t20d;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] -= tb55 * t22;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] -= tb55d * t22 + tb55 * t22d;
      t22b -= tb55 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF];
      t22bd -= tb55d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] + tb55 *
          pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF];
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] -= tb55 * ratio;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] -= tb55d * ratio + tb55 * ratiod;
      ratiob -= tb55 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF];
      ratiobd -= tb55d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] + tb55 *
          pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF];
      t21b += t22b * (1.0 / (1.0 + t21 * t21));
      t21bd += t22bd * (1.0 / (1.0 + t21 * t21)) - t22b * (1.0 / (1.0 + t21 * t21) * (t21d * t21 +
          t21 * t21d) / (1.0 + t21 * t21));
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] += t21b * ratio;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] += t21bd * ratio + t21b * ratiod;
      ratiob += t21b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF];
      ratiobd += t21bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] + t21b *
          pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF];
      tb54 = t20b / p2;
      tb54d = (t20bd - tb54 * p2d) * (1.0 / p2);
      fz0b += tb54;
      fz0bd += tb54d;
      p2b -= tb54 * t20;
      p2bd -= tb54d * t20 + tb54 * t20d;
      tb53 = ratiob / fz0;
      tb53d = (ratiobd - tb53 * fz0d) * (1.0 / fz0);
      fzb += tb53;
      fzbd += tb53d;
      fz0b -= tb53 * ratio;
      fz0bd -= tb53d * ratio + tb53 * ratiod;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0b * p[t->tyreadr[t->wheeltyre[n2]]];
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0bd * p[t->tyreadr[t->wheeltyre[n2]]]
          + fz0b * pd[t->tyreadr[t->wheeltyre[n2]]];
      pb[t->tyreadr[t->wheeltyre[n2]]] += fz0b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO];
      pbd[t->tyreadr[t->wheeltyre[n2]]] += fz0bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO]
          + fz0b * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO];
      p2b += fzb * (p3 - z20);
      p2bd += fzbd * (p3 - z20) + fzb * (p3d - z20d);
      tb52 = fzb * p2;
      tb52d = fzbd * p2 + fzb * p2d;
      p3b += tb52;
      p3bd += tb52d;
      z20b -= tb52;
      z20bd -= tb52d;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzbd * rhov + fzb * rhovd;
      rhovb += fzb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING];
      rhovbd += fzbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] + fzb *
          pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING];
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += p3b;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += p3bd;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += p2b;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += p2bd;
      tb49 = omegab * u20;
      tb49d = omegabd * u20 + omegab * u20d;
      Zb[j][3] += tb49;
      Zbd[j][3] += tb49d;
      Z_k3b -= tb49;
      Z_k3bd -= tb49d;
      u20b += omegab * (Z[j][3] - Z_k3);
      u20bd += omegabd * (Z[j][3] - Z_k3) + omegab * (Zd[j][3] - Z_k3d);
      tb50 = omegab * u21;
      tb50d = omegabd * u21 + omegab * u21d;
      Zb[j][4] += tb50;
      Zbd[j][4] += tb50d;
      Z_k4b -= tb50;
      Z_k4bd -= tb50d;
      u21b += omegab * (Z[j][4] - Z_k4);
      u21bd += omegabd * (Z[j][4] - Z_k4) + omegab * (Zd[j][4] - Z_k4d);
      tb51 = omegab * u22;
      tb51d = omegabd * u22 + omegab * u22d;
      Zb[j][5] += tb51;
      Zbd[j][5] += tb51d;
      Z_k5b -= tb51;
      Z_k5bd -= tb51d;
      u22b += omegab * (Z[j][5] - Z_k5);
      u22bd += omegabd * (Z[j][5] - Z_k5) + omegab * (Zd[j][5] - Z_k5d);
      tb48 = rhovb / z22;
      tb48d = (rhovbd - tb48 * z22d) * (1.0 / z22);
      v20b -= tb48 * N0;
      v20bd -= tb48d * N0 + tb48 * N0d;
      N0b -= tb48 * v20;
      N0bd -= tb48d * v20 + tb48 * v20d;
      v21b -= tb48 * N1;
      v21bd -= tb48d * N1;
      v22b -= tb48 * N2;
      v22bd -= tb48d * N2 + tb48 * N2d;
      N2b -= tb48 * v22;
      N2bd -= tb48d * v22 + tb48 * v22d;
      z22b -= tb48 * rhov;
      z22bd -= tb48d * rhov + tb48 * rhovd;
      v20b += vxb * T0;
      v20bd += vxbd * T0 + vxb * T0d;
      T0b += vxb * v20;
      T0bd += vxbd * v20 + vxb * v20d;
      v21b += vxb * T1;
      v21bd += vxbd * T1 + vxb * T1d;
      T1b += vxb * v21;
      T1bd += vxbd * v21 + vxb * v21d;
      v22b += vxb * T2;
      v22bd += vxbd * T2 + vxb * T2d;
      T2b += vxb * v22;
      T2bd += vxbd * v22 + vxb * v22d;
      rvb[a4_2][2] += v22b;
      rvbd[a4_2][2] += v22bd;
      vr2b += v22b;
      vr2bd += v22bd;
      rvb[a4_2][1] += v21b;
      rvbd[a4_2][1] += v21bd;
      vr1b += v21b;
      vr1bd += v21bd;
      rvb[a4_2][0] += v20b;
      rvbd[a4_2][0] += v20bd;
      vr0b += v20b;
      vr0bd += v20bd;
      wr0b += vr2b * arm1;
      wr0bd += vr2bd * arm1 + vr2b * arm1d;
      arm1b += vr2b * wr0;
      arm1bd += vr2bd * wr0 + vr2b * wr0d;
      wr1b -= vr2b * arm0;
      wr1bd -= vr2bd * arm0 + vr2b * arm0d;
      arm0b -= vr2b * wr1;
      arm0bd -= vr2bd * wr1 + vr2b * wr1d;
      wr2b += vr1b * arm0;
      wr2bd += vr1bd * arm0 + vr1b * arm0d;
      arm0b += vr1b * wr2;
      arm0bd += vr1bd * wr2 + vr1b * wr2d;
      wr0b -= vr1b * arm2;
      wr0bd -= vr1bd * arm2 + vr1b * arm2d;
      arm2b -= vr1b * wr0;
      arm2bd -= vr1bd * wr0 + vr1b * wr0d;
      wr1b += vr0b * arm2;
      wr1bd += vr0bd * arm2 + vr0b * arm2d;
      arm2b += vr0b * wr1;
      arm2bd += vr0bd * wr1 + vr0b * wr1d;
      wr2b -= vr0b * arm1;
      wr2bd -= vr0bd * arm1 + vr0b * arm1d;
      arm1b -= vr0b * wr2;
      arm1bd -= vr0bd * wr2 + vr0b * wr2d;
      Z_k5b += wr2b;
      Z_k5bd += wr2bd;
      Zb[k][5] += Z_k5b;
      Zbd[k][5] += Z_k5bd;
      Z_k4b += wr1b;
      Z_k4bd += wr1bd;
      Zb[k][4] += Z_k4b;
      Zbd[k][4] += Z_k4bd;
      Z_k3b += wr0b;
      Z_k3bd += wr0bd;
      Zb[k][3] += Z_k3b;
      Zbd[k][3] += Z_k3bd;
      wb += z22b;
      wbd += z22bd;
      cb += z21b;
      cbd += z21bd;
      r2b += z20b;
      r2bd += z20bd;
      n52b += N2b;
      n52bd += N2bd;
      along2b += T2b;
      along2bd += T2bd;
      tb46 = arm2b / w;
      tb46d = (arm2bd - tb46 * wd) * (1.0 / w);
      r2b += tb46 * (c * u22 - n52);
      r2bd += tb46d * (c * u22 - n52) + tb46 * (cd * u22 + c * u22d - n52d);
      tb47 = tb46 * r2;
      tb47d = tb46d * r2 + tb46 * r2d;
      cb += tb47 * u22;
      cbd += tb47d * u22 + tb47 * u22d;
      u22b += tb47 * c;
      u22bd += tb47d * c + tb47 * cd;
      n52b -= tb47;
      n52bd -= tb47d;
      wb -= tb46 * arm2;
      wbd -= tb46d * arm2 + tb46 * arm2d;
      along1b += T1b;
      along1bd += T1bd;
      tb44 = arm1b / w;
      tb44d = (arm1bd - tb44 * wd) * (1.0 / w);
      r2b += tb44 * (c * u21 - n51);
      r2bd += tb44d * (c * u21 - n51) + tb44 * (cd * u21 + c * u21d);
      tb45 = tb44 * r2;
      tb45d = tb44d * r2 + tb44 * r2d;
      cb += tb45 * u21;
      cbd += tb45d * u21 + tb45 * u21d;
      u21b += tb45 * c;
      u21bd += tb45d * c + tb45 * cd;
      wb -= tb44 * arm1;
      wbd -= tb44d * arm1 + tb44 * arm1d;
      n50b += N0b;
      n50bd += N0bd;
      along0b += T0b;
      along0bd += T0bd;
      tb42 = arm0b / w;
      tb42d = (arm0bd - tb42 * wd) * (1.0 / w);
      r2b += tb42 * (c * u20 - n50);
      r2bd += tb42d * (c * u20 - n50) + tb42 * (cd * u20 + c * u20d - n50d);
      tb43 = tb42 * r2;
      tb43d = tb42d * r2 + tb42 * r2d;
      cb += tb43 * u20;
      cbd += tb43d * u20 + tb43 * u20d;
      u20b += tb43 * c;
      u20bd += tb43d * c + tb43 * cd;
      n50b -= tb43;
      n50bd -= tb43d;
      wb -= tb42 * arm0;
      wbd -= tb42d * arm0 + tb42 * arm0d;
      n50b += L2b * along1;
      n50bd += L2bd * along1 + L2b * along1d;
      along1b += L2b * n50;
      along1bd += L2bd * n50 + L2b * n50d;
      along0b -= L2b * n51;
      along0bd -= L2bd * n51;
      n52b += L1b * along0;
      n52bd += L1bd * along0 + L1b * along0d;
      along0b += L1b * n52;
      along0bd += L1bd * n52 + L1b * n52d;
      n50b -= L1b * along2;
      n50bd -= L1bd * along2 + L1b * along2d;
      along2b -= L1b * n50;
      along2bd -= L1bd * n50 + L1b * n50d;
      along2b += L0b * n51;
      along2bd += L0bd * n51;
      n52b -= L0b * along1;
      n52bd -= L0bd * along1 + L0b * along1d;
      along1b -= L0b * n52;
      along1bd -= L0bd * n52 + L0b * n52d;
      tb41 = along2b / w;
      tb41d = (along2bd - tb41 * wd) * (1.0 / w);
      un2b += tb41;
      un2bd += tb41d;
      wb -= tb41 * along2;
      wbd -= tb41d * along2 + tb41 * along2d;
      tb40 = along1b / w;
      tb40d = (along1bd - tb40 * wd) * (1.0 / w);
      un1b += tb40;
      un1bd += tb40d;
      wb -= tb40 * along1;
      wbd -= tb40d * along1 + tb40 * along1d;
      tb39 = along0b / w;
      tb39d = (along0bd - tb39 * wd) * (1.0 / w);
      un0b += tb39;
      un0bd += tb39d;
      wb -= tb39 * along0;
      wbd -= tb39d * along0 + tb39 * along0d;
      tb36 = r2b / w;
      tb36d = (r2bd - tb36 * wd) * (1.0 / w);
      tb37 = tb36 * n50;
      tb37d = tb36d * n50 + tb36 * n50d;
      g0b += tb37;
      g0bd += tb37d;
      x3b -= tb37;
      x3bd -= tb37d;
      n50b += tb36 * (g0 - x3);
      n50bd += tb36d * (g0 - x3) + tb36 * (g0d - x3d);
      tb38 = tb36 * n52;
      tb38d = tb36d * n52 + tb36 * n52d;
      g2_2b += tb38;
      g2_2bd += tb38d;
      h10b -= tb38;
      h10bd -= tb38d;
      n52b += tb36 * (g2_2 - h10);
      n52bd += tb36d * (g2_2 - h10) + tb36 * (g2_2d - h10d);
      wb -= tb36 * r2;
      wbd -= tb36d * r2 + tb36 * r2d;
      t19b += wb * (1.0 / (2.0 * w));
      t19bd += wbd * (1.0 / (2.0 * w)) - wb * (1.0 / (2.0 * w) * (2.0 * wd) / (2.0 * w));
      un0b += t19b * un0;
      un0bd += t19bd * un0 + t19b * un0d;
      un0b += t19b * un0;
      un0bd += t19bd * un0 + t19b * un0d;
      un1b += t19b * un1;
      un1bd += t19bd * un1 + t19b * un1d;
      un1b += t19b * un1;
      un1bd += t19bd * un1 + t19b * un1d;
      un2b += t19b * un2;
      un2bd += t19bd * un2 + t19b * un2d;
      un2b += t19b * un2;
      un2bd += t19bd * un2 + t19b * un2d;
      u20b += un2b * n51;
      u20bd += un2bd * n51;
      u21b -= un2b * n50;
      u21bd -= un2bd * n50 + un2b * n50d;
      n50b -= un2b * u21;
      n50bd -= un2bd * u21 + un2b * u21d;
      u22b += un1b * n50;
      u22bd += un1bd * n50 + un1b * n50d;
      n50b += un1b * u22;
      n50bd += un1bd * u22 + un1b * u22d;
      u20b -= un1b * n52;
      u20bd -= un1bd * n52 + un1b * n52d;
      n52b -= un1b * u20;
      n52bd -= un1bd * u20 + un1b * u20d;
      u21b += un0b * n52;
      u21bd += un0bd * n52 + un0b * n52d;
      n52b += un0b * u21;
      n52bd += un0bd * u21 + un0b * u21d;
      u22b -= un0b * n51;
      u22bd -= un0bd * n51;
      u20b += cb * n50;
      u20bd += cbd * n50 + cb * n50d;
      n50b += cb * u20;
      n50bd += cbd * u20 + cb * u20d;
      u21b += cb * n51;
      u21bd += cbd * n51;
      u22b += cb * n52;
      u22bd += cbd * n52 + cb * n52d;
      n52b += cb * u22;
      n52bd += cbd * u22 + cb * u22d;
      tb35 = n52b / s2;
      tb35d = (n52bd - tb35 * s2d) * (1.0 / s2);
      s2b -= tb35 * n52;
      s2bd -= tb35d * n52 + tb35 * n52d;
      tb34 = n50b / s2;
      tb34d = (n50bd - tb34 * s2d) * (1.0 / s2);
      h11b -= tb34;
      h11bd -= tb34d;
      s2b -= tb34 * n50;
      s2bd -= tb34d * n50 + tb34 * n50d;
      t18b += s2b * (1.0 / (2.0 * s2));
      t18bd += s2bd * (1.0 / (2.0 * s2)) - s2b * (1.0 / (2.0 * s2) * (2.0 * s2d) / (2.0 * s2));
      h11b += t18b * h11;
      h11bd += t18bd * h11 + t18b * h11d;
      h11b += t18b * h11;
      h11bd += t18bd * h11 + t18b * h11d;
      /* height of the road above its point at x ahead of it, and its slope */
      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
        p_b2_4 = p[t->roadadr[b2_2]];
        p_b2_4d = pd[t->roadadr[b2_2]];
        p_b2_4b = h11b;
        p_b2_4bd = h11bd;
        h11b = 0.0;
        h11bd = 0.0;
        p_b2_4b += h10b * x3;
        p_b2_4bd += h10bd * x3 + h10b * x3d;
        x3b += h10b * p_b2_4;
        x3bd += h10bd * p_b2_4 + h10b * p_b2_4d;
        h10b = 0.0;
        h10bd = 0.0;
        pb[t->roadadr[b2_2]] += p_b2_4b;
        pbd[t->roadadr[b2_2]] += p_b2_4bd;
      } else {
        p_b2_5 = p[t->roadadr[b2_2] + 1];
        p_b2_5d = pd[t->roadadr[b2_2] + 1];
        t13 = 6.28318530717958647693 * x3 / p_b2_5;
        t13d = (6.28318530717958647693 * x3d - t13 * p_b2_5d) * (1.0 / p_b2_5);
        t14 = sin(t13);
        t14d = cos(t13) * t13d;
        p_b2_6 = p[t->roadadr[b2_2]];
        p_b2_6d = pd[t->roadadr[b2_2]];
        t15 = p_b2_6 * 6.28318530717958647693 / p_b2_5;
        t15d = (p_b2_6d * 6.28318530717958647693 - t15 * p_b2_5d) * (1.0 / p_b2_5);
        t16 = 6.28318530717958647693 * x3 / p_b2_5;
        t16d = (6.28318530717958647693 * x3d - t16 * p_b2_5d) * (1.0 / p_b2_5);
        t17 = cos(t16);
        t17d = -(sin(t16) * t16d);
        t15b = h11b * t17;
        t15bd = h11bd * t17 + h11b * t17d;
        t17b = h11b * t15;
        t17bd = h11bd * t15 + h11b * t15d;
        h11b = 0.0;
        h11bd = 0.0;
        t16b = -(t17b * sin(t16));
        t16bd = -(t17bd * sin(t16) + t17b * (cos(t16) * t16d));
        tb33 = t16b / p_b2_5;
        tb33d = (t16bd - tb33 * p_b2_5d) * (1.0 / p_b2_5);
        x3b += tb33 * 6.28318530717958647693;
        x3bd += tb33d * 6.28318530717958647693;
        p_b2_5b = -(tb33 * t16);
        p_b2_5bd = -(tb33d * t16 + tb33 * t16d);
        tb32 = t15b / p_b2_5;
        tb32d = (t15bd - tb32 * p_b2_5d) * (1.0 / p_b2_5);
        p_b2_6b = tb32 * 6.28318530717958647693;
        p_b2_6bd = tb32d * 6.28318530717958647693;
        p_b2_5b -= tb32 * t15;
        p_b2_5bd -= tb32d * t15 + tb32 * t15d;
        p_b2_6b += h10b * t14;
        p_b2_6bd += h10bd * t14 + h10b * t14d;
        t14b = h10b * p_b2_6;
        t14bd = h10bd * p_b2_6 + h10b * p_b2_6d;
        h10b = 0.0;
        h10bd = 0.0;
        pb[t->roadadr[b2_2]] += p_b2_6b;
        pbd[t->roadadr[b2_2]] += p_b2_6bd;
        t13b = t14b * cos(t13);
        t13bd = t14bd * cos(t13) - t14b * (sin(t13) * t13d);
        tb31 = t13b / p_b2_5;
        tb31d = (t13bd - tb31 * p_b2_5d) * (1.0 / p_b2_5);
        x3b += tb31 * 6.28318530717958647693;
        x3bd += tb31d * 6.28318530717958647693;
        p_b2_5b -= tb31 * t13;
        p_b2_5bd -= tb31d * t13 + tb31 * t13d;
        pb[t->roadadr[b2_2] + 1] += p_b2_5b;
        pbd[t->roadadr[b2_2] + 1] += p_b2_5bd;
      }
      g0b += x3b;
      g0bd += x3bd;
      t12b += x3b * (g2_2 - h00);
      t12bd += x3bd * (g2_2 - h00) + x3b * (g2_2d - h00d);
      tb30 = x3b * t12;
      tb30d = x3bd * t12 + x3b * t12d;
      g2_2b += tb30;
      g2_2bd += tb30d;
      h00b -= tb30;
      h00bd -= tb30d;
      tb29 = t12b / t11;
      tb29d = (t12bd - tb29 * t11d) * (1.0 / t11);
      u22b += tb29 * u20;
      u22bd += tb29d * u20 + tb29 * u20d;
      u20b += tb29 * u22;
      u20bd += tb29d * u22 + tb29 * u22d;
      t11b -= tb29 * t12;
      t11bd -= tb29d * t12 + tb29 * t12d;
      u20b += t11b * u20;
      u20bd += t11bd * u20 + t11b * u20d;
      u20b += t11b * u20;
      u20bd += t11bd * u20 + t11b * u20d;
      u21b += t11b * u21;
      u21bd += t11bd * u21 + t11b * u21d;
      u21b += t11b * u21;
      u21bd += t11bd * u21 + t11b * u21d;
      /* height of the road above its point at x ahead of it, and its slope */
      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
        p_b2 = p[t->roadadr[b2_2]];
        p_b2d = pd[t->roadadr[b2_2]];
        p_b2b = h00b * x4;
        p_b2bd = h00bd * x4 + h00b * x4d;
        x4b += h00b * p_b2;
        x4bd += h00bd * p_b2 + h00b * p_b2d;
        h00b = 0.0;
        h00bd = 0.0;
        pb[t->roadadr[b2_2]] += p_b2b;
        pbd[t->roadadr[b2_2]] += p_b2bd;
      } else {
        p_b2_2 = p[t->roadadr[b2_2] + 1];
        p_b2_2d = pd[t->roadadr[b2_2] + 1];
        t9 = 6.28318530717958647693 * x4 / p_b2_2;
        t9d = (6.28318530717958647693 * x4d - t9 * p_b2_2d) * (1.0 / p_b2_2);
        t10 = sin(t9);
        t10d = cos(t9) * t9d;
        p_b2_3 = p[t->roadadr[b2_2]];
        p_b2_3d = pd[t->roadadr[b2_2]];
        p_b2_3b = h00b * t10;
        p_b2_3bd = h00bd * t10 + h00b * t10d;
        t10b = h00b * p_b2_3;
        t10bd = h00bd * p_b2_3 + h00b * p_b2_3d;
        h00b = 0.0;
        h00bd = 0.0;
        pb[t->roadadr[b2_2]] += p_b2_3b;
        pbd[t->roadadr[b2_2]] += p_b2_3bd;
        t9b = t10b * cos(t9);
        t9bd = t10bd * cos(t9) - t10b * (sin(t9) * t9d);
        tb28 = t9b / p_b2_2;
        tb28d = (t9bd - tb28 * p_b2_2d) * (1.0 / p_b2_2);
        x4b += tb28 * 6.28318530717958647693;
        x4bd += tb28d * 6.28318530717958647693;
        p_b2_2b = -(tb28 * t9);
        p_b2_2bd = -(tb28d * t9 + tb28 * t9d);
        pb[t->roadadr[b2_2] + 1] += p_b2_2b;
        pbd[t->roadadr[b2_2] + 1] += p_b2_2bd;
      }
      g0b += x4b;
      /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
       * the centre down the disc meets it, n its normal; then down the disc to that plane,
       *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
       * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
      g0bd += x4bd;
      rb[a4_2][2] += g2_2b;
      rbd[a4_2][2] += g2_2bd;
      rb[t->roadpoint[b2_2]][2] -= g2_2b;
      rbd[t->roadpoint[b2_2]][2] -= g2_2bd;
      rb[a4_2][0] += g0b;
      rbd[a4_2][0] += g0bd;
      rb[t->roadpoint[b2_2]][0] -= g0b;
      rbd[t->roadpoint[b2_2]][0] -= g0bd;
      tb27 = u22b / n4;
      tb27d = (u22bd - tb27 * n4d) * (1.0 / n4);
      ua2b += tb27;
      ua2bd += tb27d;
      n4b -= tb27 * u22;
      n4bd -= tb27d * u22 + tb27 * u22d;
      tb26 = u21b / n4;
      tb26d = (u21bd - tb26 * n4d) * (1.0 / n4);
      ua1b += tb26;
      ua1bd += tb26d;
      n4b -= tb26 * u21;
      n4bd -= tb26d * u21 + tb26 * u21d;
      tb25 = u20b / n4;
      tb25d = (u20bd - tb25 * n4d) * (1.0 / n4);
      ua0b += tb25;
      ua0bd += tb25d;
      n4b -= tb25 * u20;
      n4bd -= tb25d * u20 + tb25 * u20d;
      t8b += n4b * (1.0 / (2.0 * n4));
      t8bd += n4bd * (1.0 / (2.0 * n4)) - n4b * (1.0 / (2.0 * n4) * (2.0 * n4d) / (2.0 * n4));
      ua0b += t8b * ua0;
      ua0bd += t8bd * ua0 + t8b * ua0d;
      ua0b += t8b * ua0;
      ua0bd += t8bd * ua0 + t8b * ua0d;
      ua1b += t8b * ua1;
      ua1bd += t8bd * ua1 + t8b * ua1d;
      ua1b += t8b * ua1;
      ua1bd += t8bd * ua1 + t8b * ua1d;
      ua2b += t8b * ua2;
      ua2bd += t8bd * ua2 + t8b * ua2d;
      ua2b += t8b * ua2;
      ua2bd += t8bd * ua2 + t8b * ua2d;
      Ab[j][6] += ua2b * a00;
      Abd[j][6] += ua2bd * a00 + ua2b * a00d;
      a00b += ua2b * A[j][6];
      a00bd += ua2bd * A[j][6] + ua2b * Ad[j][6];
      Ab[j][7] += ua2b * a01;
      Abd[j][7] += ua2bd * a01 + ua2b * a01d;
      a01b += ua2b * A[j][7];
      a01bd += ua2bd * A[j][7] + ua2b * Ad[j][7];
      Ab[j][8] += ua2b * a02;
      Abd[j][8] += ua2bd * a02 + ua2b * a02d;
      a02b += ua2b * A[j][8];
      a02bd += ua2bd * A[j][8] + ua2b * Ad[j][8];
      Ab[j][3] += ua1b * a00;
      Abd[j][3] += ua1bd * a00 + ua1b * a00d;
      a00b += ua1b * A[j][3];
      a00bd += ua1bd * A[j][3] + ua1b * Ad[j][3];
      Ab[j][4] += ua1b * a01;
      Abd[j][4] += ua1bd * a01 + ua1b * a01d;
      a01b += ua1b * A[j][4];
      a01bd += ua1bd * A[j][4] + ua1b * Ad[j][4];
      Ab[j][5] += ua1b * a02;
      Abd[j][5] += ua1bd * a02 + ua1b * a02d;
      a02b += ua1b * A[j][5];
      a02bd += ua1bd * A[j][5] + ua1b * Ad[j][5];
      Ab[j][0] += ua0b * a00;
      Abd[j][0] += ua0bd * a00 + ua0b * a00d;
      a00b += ua0b * A[j][0];
      a00bd += ua0bd * A[j][0] + ua0b * Ad[j][0];
      Ab[j][1] += ua0b * a01;
      Abd[j][1] += ua0bd * a01 + ua0b * a01d;
      a01b += ua0b * A[j][1];
      a01bd += ua0bd * A[j][1] + ua0b * Ad[j][1];
      Ab[j][2] += ua0b * a02;
      Abd[j][2] += ua0bd * a02 + ua0b * a02d;
      a02b += ua0b * A[j][2];
      a02bd += ua0bd * A[j][2] + ua0b * Ad[j][2];
      pb[t->wheelaxis[n2] + 2] += a02b;
      pbd[t->wheelaxis[n2] + 2] += a02bd;
      pb[t->wheelaxis[n2] + 1] += a01b;
      pbd[t->wheelaxis[n2] + 1] += a01bd;
      pb[t->wheelaxis[n2]] += a00b;
      pbd[t->wheelaxis[n2]] += a00bd;
    }
  }
}
