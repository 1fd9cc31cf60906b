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
  int a, a4, a4_2, a4_3, b, b2, b2_2, i, j, k, k3, n2;
  double A_j0, A_j0_2, A_j0_2b, A_j0_2bd, A_j0_2d, A_j0_3, A_j0_3b, A_j0_3bd, A_j0_3d, A_j0_4,
      A_j0_4b, A_j0_4bd, A_j0_4d, A_j0b, A_j0bd, A_j0d, A_j3, A_j3_2, A_j3_2b, A_j3_2bd, A_j3_2d,
      A_j3_3, A_j3_3b, A_j3_3bd, A_j3_3d, A_j3_4, A_j3_4b, A_j3_4bd, A_j3_4d, A_j3b, A_j3bd, A_j3d,
      A_j7, A_j7b, A_j7bd, A_j7d, A_j8, A_j8b, A_j8bd, A_j8d, L0, L0b, L0bd, L0d, L1, L1b, L1bd,
      L1d, L2, L2b, L2bd, L2d, N0, N0b, N0bd, N0d, N1, N2, N2b, N2bd, N2d, T0, T0b, T0bd, T0d, T1,
      T1b, T1bd, T1d, T2, T2b, T2bd, T2d, Z_j3, Z_j3b, Z_j3bd, Z_j3d, Z_j4, Z_j4b, Z_j4bd, Z_j4d,
      Z_k3, Z_k3b, Z_k3bd, Z_k3d, Z_k4, Z_k4b, Z_k4bd, Z_k4d, Z_k5, Z_k5b, Z_k5bd, Z_k5d, a00, a00b,
      a00bd, a00d, a01, a01b, a01bd, a01d, a02, a02b, a02bd, a02d, a2, a2b, a2bd, a2d, a3, a3b,
      a3bd, a3d, along0, along0b, along0bd, along0d, along1, along1b, along1bd, along1d, along2,
      along2b, along2bd, along2d, ar, arb, arbd, ard, areq, areqb, areqbd, areqd, arm0, arm0b,
      arm0bd, arm0d, arm1, arm1b, arm1bd, arm1d, arm2, arm2b, arm2bd, arm2d, at, atb, atbd, atd,
      ateq, ateqb, ateqbd, ateqd, ay, ayb, aybd, ayd, br, brb, brbd, brd, bt, btb, btbd, btd, bx,
      bxb, bxbd, bxd, by, byb, bybd, bycy, bycyb, bycybd, bycyd, byd, c, c2, c2b, c2bd, c2d, c3,
      c3b, c3bd, c3d, ca, cab, cabd, cad, cb, cbd, cd, cx, cxb, cxbd, cxd, cy, cyb, cybd, cyd, d,
      dampingb, dampingbd, db, dbd, dd, dfz, dfzb, dfzbd, dfzd, dr, drb, drbd, drd, dt, dtb, dtbd,
      dtd, dv, dvb, dvbd, dvd, dx, dxb, dxbd, dxd, dy, dyb, dybd, dyd, e0, e0b, e0bd, e0d, e1, e10,
      e10b, e10bd, e10d, e11, e11b, e11bd, e11d, e12, e12b, e12bd, e12d, e13, e13b, e13bd, e13d,
      e1b, e1bd, e1d, e20, e20b, e20bd, e20d, e21, e21b, e21bd, e21d, e22, e22b, e22bd, e22d, e2_2,
      e2_2b, e2_2bd, e2_2d, e3, e3b, e3bd, e3d, e4, e4b, e4bd, e4d, e5, e5b, e5bd, e5d, e6, e6b,
      e6bd, e6d, e7, e7b, e7bd, e7d, e8, e8b, e8bd, e8d, e9, e9b, e9bd, e9d, et, etb, etbd, etd,
      ev0, ev0b, ev0bd, ev0d, ev1, ev1b, ev1bd, ev1d, ev20, ev20b, ev20bd, ev20d, ev21, ev21b,
      ev21bd, ev21d, ev22, ev22b, ev22bd, ev22d, ev2_2, ev2_2b, ev2_2bd, ev2_2d, ex, exb, exbd, exd,
      ey, eyb, eybd, eyd, f0b, f0bd, f1b, f1bd, f2b, f2bd, force0b, force0bd, force1b, force1bd,
      force2b, force2bd, force3b, force3bd, force4b, force4bd, force5b, force5bd, fx, fxb, fxbd,
      fxd, fy, fyb, fybd, fyd, fz, fz0, fz0_2, fz0_2b, fz0_2bd, fz0_2d, fz0_3, fz0_3b, fz0_3bd,
      fz0_3d, fz0_4, fz0_4b, fz0_4bd, fz0_4d, fz0b, fz0bd, fz0d, fz2, fz2b, fz2bd, fz2d, fzb, fzbd,
      fzd, g0, g0_2, g0_2b, g0_2bd, g0_2d, g0_3, g0_3b, g0_3bd, g0_3d, g0_4, g0_4b, g0_4bd, g0_4d,
      g0b, g0bd, g0d, g1, g1_2, g1_2b, g1_2bd, g1_2d, g1_3, g1_3b, g1_3bd, g1_3d, g1_4, g1_4b,
      g1_4bd, g1_4d, g1b, g1bd, g1d, g20, g20b, g20bd, g20d, g22, g22b, g22bd, g22d, g2_2, g2_2b,
      g2_2bd, g2_2d, g2_4b, g2_4bd, g2_5, g2_5b, g2_5bd, g2_5d, g30, g30b, g30bd, g30d, g31, g31b,
      g31bd, g31d, gamma, gamma2, gamma2b, gamma2bd, gamma2d, gammab, gammabd, gammad, gx, gxb,
      gxbd, gxd, gy, gyb, gybd, gyd, gz, gzb, gzbd, gzd, h, h00, h00b, h00bd, h00d, h10, h10b,
      h10bd, h10d, h11, h11b, h11bd, h11d, h2, h2b, h2bd, h2d, h3, h3b, h3bd, h3d, hb, hbd, hd,
      kappa, kappa2, kappa2b, kappa2bd, kappa2d, kappab, kappabd, kappad, kx, kxb, kxbd, kxd, l, l2,
      l2b, l2bd, l2d, lb, lbd, ld, lv, lvb, lvbd, lvd, mux, muxb, muxbd, muxd, muy, muy2, muy2b,
      muy2bd, muy2d, muyb, muybd, muyd, n30, n30b, n30bd, n30d, n31, n31b, n31bd, n31d, n32, n32b,
      n32bd, n32d, n40, n40b, n40bd, n40d, n41, n41b, n41bd, n41d, n42, n42b, n42bd, n42d, n5, n5b,
      n5bd, n5d, n60, n60b, n60bd, n60d, n61, n62, n62b, n62bd, n62d, omega, omegab, omegabd,
      omegad, one0, one0b, one0bd, one0d, one1, one1b, one1bd, one1d, one2, one2b, one2bd, one2d,
      one3, one3b, one3bd, one3d, one4, one4b, one4bd, one4d, p10, p10b, p10bd, p10d, p2, p2b, p2bd,
      p2d, p3, p3b, p3bd, p3d, p4, p4b, p4bd, p4d, p5, p5b, p5bd, p5d, p6, p6b, p6bd, p6d, p7, p7b,
      p7bd, p7d, p8, p8b, p8bd, p8d, p9, p9b, p9bd, p9d, p_b2, p_b2_2, p_b2_2b, p_b2_2bd, p_b2_2d,
      p_b2_3, p_b2_3b, p_b2_3bd, p_b2_3d, p_b2_4, p_b2_4b, p_b2_4bd, p_b2_4d, p_b2_5, p_b2_5b,
      p_b2_5bd, p_b2_5d, p_b2_6, p_b2_6b, p_b2_6bd, p_b2_6d, p_b2b, p_b2bd, p_b2d, p_i, p_i1, p_i1b,
      p_i1bd, p_i1d, p_i2, p_i2b, p_i2bd, p_i2d, p_i3, p_i3b, p_i3bd, p_i3d, p_ib, p_ibd, p_id,
      p_k34, p_k34b, p_k34bd, p_k34d, p_k35, p_k35b, p_k35bd, p_k35d, r0, r0b, r0bd, r0d, r2, r2b,
      r2bd, r2d, r3, r3b, r3bd, r3d, ratio, ratio2, ratio2b, ratio2bd, ratio2d, ratiob, ratiobd,
      ratiod, re, reb, rebd, red, rhov, rhovb, rhovbd, rhovd, roll, rollb, rollbd, rolld, rolling0b,
      rolling0bd, rolling1b, rolling1bd, rolling2b, rolling2bd, rolling3b, rolling3bd, rolling4b,
      rolling4bd, rolling5b, rolling5bd, rv_k0, rv_k0_2, rv_k0_2b, rv_k0_2bd, rv_k0_2d, rv_k0_3,
      rv_k0_3b, rv_k0_3bd, rv_k0_3d, rv_k0b, rv_k0bd, rv_k0d, rv_k1, rv_k1_2, rv_k1_2b, rv_k1_2bd,
      rv_k1_2d, rv_k1_3, rv_k1_3b, rv_k1_3bd, rv_k1_3d, rv_k1b, rv_k1bd, rv_k1d, rv_k2, rv_k2b,
      rv_k2bd, rv_k2d, s2, s2b, s2bd, s2d, s3, s3b, s3bd, s3d, s4, s4b, s4bd, s4d, shift, shiftb,
      shiftbd, shiftd, shy, shyb, shybd, shyd, side, slip0b, slip0bd, slip1, slip1b, slip1bd,
      slip1d, slip2b, slip2bd, speed2, speed2b, speed2bd, speed2d, speed3, speed3b, speed3bd,
      speed3d, stiff, stiff2, stiff2b, stiff2bd, stiff2d, stiff3, stiff3b, stiff3bd, stiff3d,
      stiff4, stiff4b, stiff4bd, stiff4d, stiffb, stiffbd, stiffd, sumb, sumbd, svx, svxb, svxbd,
      svxd, svy, svyb, svybd, svyd, t10, t100, t100b, t100bd, t100d, t101, t101b, t101bd, t101d,
      t102, t102b, t102bd, t102d, t103, t103b, t103bd, t103d, t104, t104b, t104bd, t104d, t105,
      t105b, t105bd, t105d, t106, t106b, t106bd, t106d, t107, t107b, t107bd, t107d, t108, t108b,
      t108bd, t108d, t109, t109b, t109bd, t109d, t10b, t10bd, t10d, t11, t110, t110b, t110bd, t110d,
      t111, t111b, t111bd, t111d, t112, t112b, t112bd, t112d, t11b, t11bd, t11d, t12, t12b, t12bd,
      t12d, t13b, t13bd, t14, t14b, t14bd, t14d, t15, t15b, t15bd, t15d, t16, t16b, t16bd, t16d,
      t17, t17b, t17bd, t17d, t18, t18b, t18bd, t18d, t19, t19b, t19bd, t19d, t2, t20, t20b, t20bd,
      t20d, t21, t21b, t21bd, t21d, t22, t22b, t22bd, t22d, t23, t23b, t23bd, t23d, t24, t24b,
      t24bd, t24d, t25, t25b, t25bd, t25d, t26, t26b, t26bd, t26d, t27, t27b, t27bd, t27d, t28,
      t28b, t28bd, t28d, t29, t29b, t29bd, t29d, t2b, t2bd, t2d, t3, t30, t30b, t30bd, t30d, t31,
      t31b, t31bd, t31d, t32, t32b, t32bd, t32d, t33, t33b, t33bd, t33d, t34, t34b, t34bd, t34d,
      t35, t35b, t35bd, t35d, t36, t36b, t36bd, t36d, t37, t37b, t37bd, t37d, t38, t38b, t38bd,
      t38d, t39, t39b, t39bd, t39d, t3b, t3bd, t3d, t4, t40, t40b, t40bd, t40d, t41, t41b, t41bd,
      t41d, t42, t42b, t42bd, t42d, t43, t43b, t43bd, t43d, t44, t44b, t44bd, t44d, t45, t45b,
      t45bd, t45d, t46, t46b, t46bd, t46d, t47, t47b, t47bd, t47d, t48, t48b, t48bd, t48d, t49,
      t49b, t49bd, t49d, t4b, t4bd, t4d, t5, t50, t50b, t50bd, t50d, t51, t51b, t51bd, t51d, t52,
      t52b, t52bd, t52d, t53, t53b, t53bd, t53d, t54, t54b, t54bd, t54d, t55, t55b, t55bd, t55d,
      t56, t56b, t56bd, t56d, t57, t57b, t57bd, t57d, t58, t58b, t58bd, t58d, t59, t59b, t59bd,
      t59d, t5b, t5bd, t5d, t6, t60, t60b, t60bd, t60d, t61, t61b, t61bd, t61d, t62, t62b, t62bd,
      t62d, t63, t63b, t63bd, t63d, t64, t64b, t64bd, t64d, t65, t65b, t65bd, t65d, t66, t66b,
      t66bd, t66d, t67, t67b, t67bd, t67d, t68, t68b, t68bd, t68d, t69, t69b, t69bd, t69d, t6b,
      t6bd, t6d, t7, t70, t70b, t70bd, t70d, t71, t71b, t71bd, t71d, t72, t72b, t72bd, t72d, t73,
      t73b, t73bd, t73d, t74, t74b, t74bd, t74d, t75, t75b, t75bd, t75d, t76, t76b, t76bd, t76d,
      t77, t77b, t77bd, t77d, t78, t78b, t78bd, t78d, t79, t79b, t79bd, t79d, t7b, t7bd, t7d, t8,
      t80, t80b, t80bd, t80d, t81, t81b, t81bd, t81d, t82, t82b, t82bd, t82d, t83, t83b, t83bd,
      t83d, t84, t84b, t84bd, t84d, t85, t85b, t85bd, t85d, t86, t86b, t86bd, t86d, t87, t87b,
      t87bd, t87d, t88, t88b, t88bd, t88d, t89, t89b, t89bd, t89d, t8b, t8bd, t8d, t9, t90, t90b,
      t90bd, t90d, t91, t91b, t91bd, t91d, t92, t92b, t92bd, t92d, t93, t93b, t93bd, t93d, t94,
      t94b, t94bd, t94d, t95, t95b, t95bd, t95d, t96, t96b, t96bd, t96d, t97, t97b, t97bd, t97d,
      t98, t98b, t98bd, t98d, t99, t99b, t99bd, t99d, t9b, t9bd, t9d, tb10, tb100, tb100d, tb101,
      tb101d, tb102, tb102d, tb103, tb103d, tb104, tb104d, tb105, tb105d, tb106, tb106d, tb107,
      tb107d, tb108, tb108d, tb109, tb109d, tb10d, tb11, tb110, tb110d, tb111, tb111d, tb112,
      tb112d, tb113, tb113d, tb114, tb114d, tb115, tb115d, tb116, tb116d, tb117, tb117d, tb118,
      tb118d, tb119, tb119d, tb11d, tb12, tb120, tb120d, tb121, tb121d, tb122, tb122d, tb123,
      tb123d, tb124, tb124d, tb125, tb125d, tb126, tb126d, tb127, tb127d, tb128, tb128d, tb129,
      tb129d, tb12d, tb13, tb130, tb130d, tb131, tb131d, tb132, tb132d, tb133, tb133d, tb134,
      tb134d, tb135, tb135d, tb136, tb136d, tb137, tb137d, tb138, tb138d, tb139, tb139d, tb13d,
      tb14, tb140, tb140d, tb141, tb141d, tb142, tb142d, tb143, tb143d, tb144, tb144d, tb145,
      tb145d, tb146, tb146d, tb147, tb147d, tb148, tb148d, tb149, tb149d, tb14d, tb15, tb150,
      tb150d, tb151, tb151d, tb152, tb152d, tb153, tb153d, tb154, tb154d, tb155, tb155d, tb156,
      tb156d, tb157, tb157d, tb158, tb158d, tb159, tb159d, tb15d, tb16, tb160, tb160d, tb161,
      tb161d, tb162, tb162d, tb163, tb163d, tb164, tb164d, tb165, tb165d, tb166, tb166d, tb167,
      tb167d, tb168, tb168d, tb169, tb169d, tb16d, tb17, tb170, tb170d, tb171, tb171d, tb172,
      tb172d, tb173, tb173d, tb174, tb174d, tb175, tb175d, tb176, tb176d, tb177, tb177d, tb178,
      tb178d, tb179, tb179d, tb17d, tb18, tb180, tb180d, tb181, tb181d, tb182, tb182d, tb183,
      tb183d, tb184, tb184d, tb185, tb185d, tb186, tb186d, tb187, tb187d, tb188, tb188d, tb189,
      tb189d, tb18d, tb19, tb190, tb190d, tb191, tb191d, tb19d, tb2, tb20, tb20d, tb21, tb21d, tb22,
      tb22d, tb23, tb23d, tb24, tb24d, tb25, tb25d, tb26, tb26d, tb27, tb27d, tb28, tb28d, tb29,
      tb29d, tb2d, tb3, tb30, tb30d, tb31, tb31d, tb32, tb32d, tb33, tb33d, tb34, tb34d, tb35,
      tb35d, tb36, tb36d, tb37, tb37d, tb38, tb38d, tb39, tb39d, tb3d, tb4, tb40, tb40d, tb41,
      tb41d, tb42, tb42d, tb43, tb43d, tb44, tb44d, tb45, tb45d, tb46, tb46d, tb47, tb47d, tb48,
      tb48d, tb49, tb49d, tb4d, tb5, tb50, tb50d, tb51, tb51d, tb52, tb52d, tb53, tb53d, tb54,
      tb54d, tb55, tb55d, tb56, tb56d, tb57, tb57d, tb58, tb58d, tb59, tb59d, tb5d, tb6, tb60,
      tb60d, tb61, tb61d, tb62, tb62d, tb63, tb63d, tb64, tb64d, tb65, tb65d, tb66, tb66d, tb67,
      tb67d, tb68, tb68d, tb69, tb69d, tb6d, tb7, tb70, tb70d, tb71, tb71d, tb72, tb72d, tb73,
      tb73d, tb74, tb74d, tb75, tb75d, tb76, tb76d, tb77, tb77d, tb78, tb78d, tb79, tb79d, tb7d,
      tb8, tb80, tb80d, tb81, tb81d, tb82, tb82d, tb83, tb83d, tb84, tb84d, tb85, tb85d, tb86,
      tb86d, tb87, tb87d, tb88, tb88d, tb89, tb89d, tb8d, tb9, tb90, tb90d, tb91, tb91d, tb92,
      tb92d, tb93, tb93d, tb94, tb94d, tb95, tb95d, tb96, tb96d, tb97, tb97d, tb98, tb98d, tb99,
      tb99d, tb9d, torque0b, torque0bd, u20, u20b, u20bd, u20d, u21, u21b, u21bd, u21d, u30, u30b,
      u30bd, u30d, u31, u31b, u31bd, u31d, u32, u32b, u32bd, u32d, ua0, ua0b, ua0bd, ua0d, ua1,
      ua1b, ua1bd, ua1d, ua2, ua2b, ua2bd, ua2d, un0, un0b, un0bd, un0d, un1, un1b, un1bd, un1d,
      un2, un2b, un2bd, un2d, v20, v20b, v20bd, v20d, v21, v21b, v21bd, v21d, v22, v22b, v22bd,
      v22d, vr0, vr0b, vr0bd, vr0d, vr1, vr1b, vr1bd, vr1d, vr2, vr2b, vr2bd, vr2d, vx, vxb, vxbd,
      vxd, w, w2, w2b, w2bd, w2d, way, wayb, waybd, wayd, wb, wbd, wd, wr0, wr0b, wr0bd, wr0d, wr1,
      wr1b, wr1bd, wr1d, wr2, wr2b, wr2bd, wr2d, x2, x2b, x2bd, x2d, x3, x3b, x3bd, x3d, x4, x4b,
      x4bd, x4d, x50, x50b, x50bd, x50d, x51, x51b, x51bd, x51d, x6, x6b, x6bd, x6d, x7, x7b, x7bd,
      x7d, x8, x8b, x8bd, x8d, x9, x9b, x9bd, x9d, xv, xvb, xvbd, xvd, y, y10, y10b, y10bd, y10d,
      y11, y11b, y11bd, y11d, y12, y12b, y12bd, y12d, y13, y13b, y13bd, y13d, y14, y14b, y14bd,
      y14d, y15, y15b, y15bd, y15d, y16, y16b, y16bd, y16d, y17, y17b, y17bd, y17d, y18, y18b,
      y18bd, y18d, y20, y20b, y20bd, y20d, y21, y21b, y21bd, y21d, y22, y22b, y22bd, y22d, y23,
      y23b, y23bd, y23d, y24, y24b, y24bd, y24d, y3, y3b, y3bd, y3d, y4, y4b, y4bd, y4d, y5, y5b,
      y5bd, y5d, y6, y6b, y6bd, y6d, y7, y7b, y7bd, y7d, y8, y8b, y8bd, y8d, y9, y9b, y9bd, y9d, yb,
      ybd, yd, z0_2b, z0_2bd, z0_3b, z0_3bd, z0b, z0bd, z1_2b, z1_2bd, z1_3, z1_3b, z1_3bd, z1_3d,
      z1b, z1bd, z20, z20b, z20bd, z20d, z21, z21b, z21bd, z21d, z22, z22b, z22bd, z22d, z30, z30b,
      z30bd, z30d, z31b, z31bd, z4, z4b, z4bd, z4d, z5, z5b, z5bd, z5d, z6, z6b, z6bd, z6d;

  (void)origin;
  (void)x;
  (void)xd;
  (void)Za;
  (void)Zad;
  (void)driver;
  (void)driverd;
  (void)speed;
  (void)speedd;
  (void)lambda;
  (void)lambdad;
  A_j0 = 0.0;
  A_j0_2 = 0.0;
  A_j0_2d = 0.0;
  A_j0_3 = 0.0;
  A_j0_3d = 0.0;
  A_j0_4 = 0.0;
  A_j0_4d = 0.0;
  A_j0d = 0.0;
  A_j3 = 0.0;
  A_j3_2 = 0.0;
  A_j3_2d = 0.0;
  A_j3_3 = 0.0;
  A_j3_3d = 0.0;
  A_j3_4 = 0.0;
  A_j3_4d = 0.0;
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
  c3 = 0.0;
  c3d = 0.0;
  cd = 0.0;
  d = 0.0;
  dd = 0.0;
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
  g0_2 = 0.0;
  g0_2d = 0.0;
  g0_3 = 0.0;
  g0_3d = 0.0;
  g0_4 = 0.0;
  g0_4d = 0.0;
  g0d = 0.0;
  g1 = 0.0;
  g1_2 = 0.0;
  g1_2d = 0.0;
  g1_3 = 0.0;
  g1_3d = 0.0;
  g1_4 = 0.0;
  g1_4d = 0.0;
  g1d = 0.0;
  g20 = 0.0;
  g20d = 0.0;
  g22 = 0.0;
  g22d = 0.0;
  g2_2 = 0.0;
  g2_2d = 0.0;
  g2_5 = 0.0;
  g2_5d = 0.0;
  gamma = 0.0;
  gammad = 0.0;
  h = 0.0;
  h00 = 0.0;
  h00d = 0.0;
  h10 = 0.0;
  h10d = 0.0;
  h11 = 0.0;
  h11d = 0.0;
  h2 = 0.0;
  h2d = 0.0;
  h3 = 0.0;
  h3d = 0.0;
  hd = 0.0;
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
  n40 = 0.0;
  n40d = 0.0;
  n41 = 0.0;
  n41d = 0.0;
  n42 = 0.0;
  n42d = 0.0;
  n5 = 0.0;
  n5d = 0.0;
  n60 = 0.0;
  n60d = 0.0;
  n61 = 0.0;
  n62 = 0.0;
  n62d = 0.0;
  omega = 0.0;
  omegad = 0.0;
  p2 = 0.0;
  p2d = 0.0;
  p3 = 0.0;
  p3d = 0.0;
  p_i = 0.0;
  p_i1 = 0.0;
  p_i1d = 0.0;
  p_i2 = 0.0;
  p_i2d = 0.0;
  p_id = 0.0;
  r2 = 0.0;
  r2d = 0.0;
  r3 = 0.0;
  r3d = 0.0;
  ratio = 0.0;
  ratiod = 0.0;
  re = 0.0;
  red = 0.0;
  rhov = 0.0;
  rhovd = 0.0;
  roll = 0.0;
  rolld = 0.0;
  rv_k0 = 0.0;
  rv_k0_2 = 0.0;
  rv_k0_2d = 0.0;
  rv_k0_3 = 0.0;
  rv_k0_3d = 0.0;
  rv_k0d = 0.0;
  rv_k1 = 0.0;
  rv_k1_2 = 0.0;
  rv_k1_2d = 0.0;
  rv_k1_3 = 0.0;
  rv_k1_3d = 0.0;
  rv_k1d = 0.0;
  rv_k2 = 0.0;
  rv_k2d = 0.0;
  s2 = 0.0;
  s2d = 0.0;
  side = 0.0;
  slip1 = 0.0;
  slip1d = 0.0;
  speed2 = 0.0;
  speed2d = 0.0;
  t14 = 0.0;
  t14d = 0.0;
  t17 = 0.0;
  t17d = 0.0;
  t19 = 0.0;
  t19d = 0.0;
  t2 = 0.0;
  t20 = 0.0;
  t20d = 0.0;
  t26 = 0.0;
  t26d = 0.0;
  t27 = 0.0;
  t27d = 0.0;
  t2d = 0.0;
  t35 = 0.0;
  t35d = 0.0;
  t36 = 0.0;
  t36d = 0.0;
  t37 = 0.0;
  t37d = 0.0;
  t4 = 0.0;
  t4d = 0.0;
  t6 = 0.0;
  t6d = 0.0;
  t8 = 0.0;
  t8d = 0.0;
  u20 = 0.0;
  u20d = 0.0;
  u21 = 0.0;
  u21d = 0.0;
  u30 = 0.0;
  u30d = 0.0;
  u31 = 0.0;
  u31d = 0.0;
  u32 = 0.0;
  u32d = 0.0;
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
  w2 = 0.0;
  w2d = 0.0;
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
  a4 = 0;
  a4_2 = 0;
  a4_3 = 0;
  b = 0;
  b2 = 0;
  b2_2 = 0;
  k3 = 0;
  for (i = t->nsensor - 1; i >= 0; --i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n2 = t->sensorelement[i];
    if (t->sensorkind[i] != MAGGI_SENSOR_POSITION) {
      if (t->sensorkind[i] != MAGGI_SENSOR_VELOCITY) {
        if (t->sensorkind[i] != MAGGI_SENSOR_ACCELERATION) {
          if (t->sensorkind[i] == MAGGI_SENSOR_LATERAL_ACCELERATION) {
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
            t2d = rv_k0d * rv_k0 + rv_k0 * rv_k0d + (rv_k1d * rv_k1 + rv_k1 * rv_k1d) + (rv_k2d *
                rv_k2 + rv_k2 * rv_k2d) + wd;
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
            t3d = n30d * n30 + n30 * n30d + (n31d * n31 + n31 * n31d) + (n32d * n32 + n32 * n32d) +
                (p_i1d * p_i1 + p_i1 * p_i1d);
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
            u20d = (A_j0d * rv_k0_2 + A_j0 * rv_k0_2d + (A_j3d * rv_k1_2 + A_j3 * rv_k1_2d) - u20 *
                hd) * (1.0 / h);
            u21 = (A_j0 * rv_k1_2 - A_j3 * rv_k0_2) / h;
            u21d = (A_j0d * rv_k1_2 + A_j0 * rv_k1_2d - (A_j3d * rv_k0_2 + A_j3 * rv_k0_2d) - u21 *
                hd) * (1.0 / h);
            p_i2 = p[t->sensoradr[i]];
            p_i2d = pd[t->sensoradr[i]];
            t10 = u20 * u20 + u21 * u21 + p_i2 * p_i2;
            t10d = u20d * u20 + u20 * u20d + (u21d * u21 + u21 * u21d) + (p_i2d * p_i2 + p_i2 *
                p_i2d);
            r2 = sqrt(t10);
            r2d = 1.0 / (2.0 * r2) * t10d;
            if (MAGGI_RE(u20) < 0.0) {
              t11 = r2 - u20;
              t11d = r2d - u20d;
              p_i3 = p[t->sensoradr[i]];
              p_i3d = pd[t->sensoradr[i]];
              t12 = (u21 * u21 + p_i3 * p_i3) / t11;
              t12d = (u21d * u21 + u21 * u21d + (p_i3d * p_i3 + p_i3 * p_i3d) - t12 * t11d) * (1.0 /
                  t11);
              d = t12;
              dd = t12d;
            } else {
              d = r2 + u20;
              dd = r2d + u20d;
            }
            t14 = r2 * r2 * r2;
            t14d = (r2d * r2 + r2 * r2d) * r2 + r2 * r2 * r2d;
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
          } else if (t->sensorkind[i] == MAGGI_SENSOR_BODY_ACCELERATION) {
            g0_4 = ra[k][0] + p[0];
            g0_4d = rad[k][0] + pd[0];
            g1_4 = ra[k][1] + p[1];
            g1_4d = rad[k][1] + pd[1];
            g2_5 = ra[k][2] + p[2];
            g2_5d = rad[k][2] + pd[2];
          } else {
            if (t->sensorkind[i] != MAGGI_SENSOR_COMBINATION) {
              if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
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
              } else {
                if (t->sensorkind[i] != MAGGI_SENSOR_ANGULAR_VELOCITY) {
                  if (t->sensorkind[i] != MAGGI_SENSOR_ANGULAR_ACCELERATION) {
                    if (t->sensorkind[i] == MAGGI_SENSOR_SPRING) {
                      a4 = t->springpa[n2];
                      b = t->springpb[n2];
                      e0 = r[a4][0] - r[b][0];
                      e0d = rd[a4][0] - rd[b][0];
                      ev0 = rv[a4][0] - rv[b][0];
                      ev0d = rvd[a4][0] - rvd[b][0];
                      e1 = r[a4][1] - r[b][1];
                      e1d = rd[a4][1] - rd[b][1];
                      ev1 = rv[a4][1] - rv[b][1];
                      ev1d = rvd[a4][1] - rvd[b][1];
                      e2_2 = r[a4][2] - r[b][2];
                      e2_2d = rd[a4][2] - rd[b][2];
                      ev2_2 = rv[a4][2] - rv[b][2];
                      ev2_2d = rvd[a4][2] - rvd[b][2];
                      t21 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
                      t21d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 *
                          e2_2d);
                      l = sqrt(t21);
                      ld = 1.0 / (2.0 * l) * t21d;
                      n40 = e0 / l;
                      n40d = (e0d - n40 * ld) * (1.0 / l);
                      n41 = e1 / l;
                      n41d = (e1d - n41 * ld) * (1.0 / l);
                      n42 = e2_2 / l;
                      n42d = (e2_2d - n42 * ld) * (1.0 / l);
                      lv = n40 * ev0 + n41 * ev1 + n42 * ev2_2;
                      lvd = n40d * ev0 + n40 * ev0d + (n41d * ev1 + n41 * ev1d) + (n42d * ev2_2 +
                          n42 * ev2_2d);
                      k3 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
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
                      a4_2 = t->primpa[n2];
                      b2 = t->primpb[n2];
                      e20 = r[a4_2][0] - r[b2][0];
                      e20d = rd[a4_2][0] - rd[b2][0];
                      ev20 = rv[a4_2][0] - rv[b2][0];
                      ev20d = rvd[a4_2][0] - rvd[b2][0];
                      e21 = r[a4_2][1] - r[b2][1];
                      e21d = rd[a4_2][1] - rd[b2][1];
                      ev21 = rv[a4_2][1] - rv[b2][1];
                      ev21d = rvd[a4_2][1] - rvd[b2][1];
                      e22 = r[a4_2][2] - r[b2][2];
                      e22d = rd[a4_2][2] - rd[b2][2];
                      ev22 = rv[a4_2][2] - rv[b2][2];
                      ev22d = rvd[a4_2][2] - rvd[b2][2];
                      t22 = e20 * e20 + e21 * e21 + e22 * e22;
                      t22d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22
                          * e22d);
                      l2 = sqrt(t22);
                      l2d = 1.0 / (2.0 * l2) * t22d;
                      z1_3 = s[i][1];
                      z1_3d = sd[i][1];
                    } else {
                      if (t->sensorkind[i] != MAGGI_SENSOR_SPEED) {
                        if (t->sensorkind[i] != MAGGI_SENSOR_DRIVER) {
                          a4_3 = t->wheelpoint[n2];
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
                          ua0d = Ad[j][0] * a00 + A[j][0] * a00d + (Ad[j][1] * a01 + A[j][1] * a01d)
                              + (Ad[j][2] * a02 + A[j][2] * a02d);
                          ua1 = A[j][3] * a00 + A[j][4] * a01 + A[j][5] * a02;
                          ua1d = Ad[j][3] * a00 + A[j][3] * a00d + (Ad[j][4] * a01 + A[j][4] * a01d)
                              + (Ad[j][5] * a02 + A[j][5] * a02d);
                          ua2 = A[j][6] * a00 + A[j][7] * a01 + A[j][8] * a02;
                          ua2d = Ad[j][6] * a00 + A[j][6] * a00d + (Ad[j][7] * a01 + A[j][7] * a01d)
                              + (Ad[j][8] * a02 + A[j][8] * a02d);
                          t23 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
                          t23d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 +
                              ua2 * ua2d);
                          n5 = sqrt(t23);
                          n5d = 1.0 / (2.0 * n5) * t23d;
                          u30 = ua0 / n5;
                          u30d = (ua0d - u30 * n5d) * (1.0 / n5);
                          u31 = ua1 / n5;
                          u31d = (ua1d - u31 * n5d) * (1.0 / n5);
                          u32 = ua2 / n5;
                          u32d = (ua2d - u32 * n5d) * (1.0 / n5);
                          g20 = r[a4_3][0] - r[t->roadpoint[b2_2]][0];
                          g20d = rd[a4_3][0] - rd[t->roadpoint[b2_2]][0];
                          g22 = r[a4_3][2] - r[t->roadpoint[b2_2]][2];
                          g22d = rd[a4_3][2] - rd[t->roadpoint[b2_2]][2];
                          x4 = g20;
                          x4d = g20d;
                          if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
                            p_b2 = p[t->roadadr[b2_2]];
                            p_b2d = pd[t->roadadr[b2_2]];
                            h00 = p_b2 * x4;
                            h00d = p_b2d * x4 + p_b2 * x4d;
                          } else {
                            p_b2_2 = p[t->roadadr[b2_2] + 1];
                            p_b2_2d = pd[t->roadadr[b2_2] + 1];
                            t24 = 6.28318530717958647693 * x4 / p_b2_2;
                            t24d = (6.28318530717958647693 * x4d - t24 * p_b2_2d) * (1.0 / p_b2_2);
                            t25 = sin(t24);
                            t25d = cos(t24) * t24d;
                            p_b2_3 = p[t->roadadr[b2_2]];
                            p_b2_3d = pd[t->roadadr[b2_2]];
                            h00 = p_b2_3 * t25;
                            h00d = p_b2_3d * t25 + p_b2_3 * t25d;
                          }
                          t26 = u30 * u30 + u31 * u31;
                          t26d = u30d * u30 + u30 * u30d + (u31d * u31 + u31 * u31d);
                          t27 = u32 * u30 / t26;
                          t27d = (u32d * u30 + u32 * u30d - t27 * t26d) * (1.0 / t26);
                          x3 = g20 + t27 * (g22 - h00);
                          x3d = g20d + (t27d * (g22 - h00) + t27 * (g22d - h00d));
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
                            t28 = 6.28318530717958647693 * x3 / p_b2_5;
                            t28d = (6.28318530717958647693 * x3d - t28 * p_b2_5d) * (1.0 / p_b2_5);
                            t29 = sin(t28);
                            t29d = cos(t28) * t28d;
                            p_b2_6 = p[t->roadadr[b2_2]];
                            p_b2_6d = pd[t->roadadr[b2_2]];
                            h10 = p_b2_6 * t29;
                            h10d = p_b2_6d * t29 + p_b2_6 * t29d;
                            t30 = p_b2_6 * 6.28318530717958647693 / p_b2_5;
                            t30d = (p_b2_6d * 6.28318530717958647693 - t30 * p_b2_5d) * (1.0 /
                                p_b2_5);
                            t31 = 6.28318530717958647693 * x3 / p_b2_5;
                            t31d = (6.28318530717958647693 * x3d - t31 * p_b2_5d) * (1.0 / p_b2_5);
                            t32 = cos(t31);
                            t32d = -(sin(t31) * t31d);
                            h11 = t30 * t32;
                            h11d = t30d * t32 + t30 * t32d;
                          }
                          t33 = 1.0 + h11 * h11;
                          t33d = h11d * h11 + h11 * h11d;
                          s2 = sqrt(t33);
                          s2d = 1.0 / (2.0 * s2) * t33d;
                          n60 = -h11 / s2;
                          n60d = (-h11d - n60 * s2d) * (1.0 / s2);
                          n61 = 0.0;
                          n62 = 1.0 / s2;
                          n62d = -(n62 * s2d * (1.0 / s2));
                          c3 = u30 * n60 + u31 * n61 + u32 * n62;
                          c3d = u30d * n60 + u30 * n60d + u31d * n61 + (u32d * n62 + u32 * n62d);
                          un0 = u31 * n62 - u32 * n61;
                          un0d = u31d * n62 + u31 * n62d - u32d * n61;
                          un1 = u32 * n60 - u30 * n62;
                          un1d = u32d * n60 + u32 * n60d - (u30d * n62 + u30 * n62d);
                          un2 = u30 * n61 - u31 * n60;
                          un2d = u30d * n61 - (u31d * n60 + u31 * n60d);
                          t34 = un0 * un0 + un1 * un1 + un2 * un2;
                          t34d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 +
                              un2 * un2d);
                          w2 = sqrt(t34);
                          w2d = 1.0 / (2.0 * w2) * t34d;
                          r3 = ((g20 - x3) * n60 + (g22 - h10) * n62) / w2;
                          r3d = ((g20d - x3d) * n60 + (g20 - x3) * n60d + ((g22d - h10d) * n62 +
                              (g22 - h10) * n62d) - r3 * w2d) * (1.0 / w2);
                          along0 = un0 / w2;
                          along0d = (un0d - along0 * w2d) * (1.0 / w2);
                          along1 = un1 / w2;
                          along1d = (un1d - along1 * w2d) * (1.0 / w2);
                          along2 = un2 / w2;
                          along2d = (un2d - along2 * w2d) * (1.0 / w2);
                          L0 = n61 * along2 - n62 * along1;
                          L0d = n61 * along2d - (n62d * along1 + n62 * along1d);
                          L1 = n62 * along0 - n60 * along2;
                          L1d = n62d * along0 + n62 * along0d - (n60d * along2 + n60 * along2d);
                          L2 = n60 * along1 - n61 * along0;
                          L2d = n60d * along1 + n60 * along1d - n61 * along0d;
                          arm0 = r3 * (c3 * u30 - n60) / w2;
                          arm0d = (r3d * (c3 * u30 - n60) + r3 * (c3d * u30 + c3 * u30d - n60d) -
                              arm0 * w2d) * (1.0 / w2);
                          T0 = along0;
                          T0d = along0d;
                          N0 = n60;
                          N0d = n60d;
                          arm1 = r3 * (c3 * u31 - n61) / w2;
                          arm1d = (r3d * (c3 * u31 - n61) + r3 * (c3d * u31 + c3 * u31d) - arm1 *
                              w2d) * (1.0 / w2);
                          T1 = along1;
                          T1d = along1d;
                          N1 = n61;
                          arm2 = r3 * (c3 * u32 - n62) / w2;
                          arm2d = (r3d * (c3 * u32 - n62) + r3 * (c3d * u32 + c3 * u32d - n62d) -
                              arm2 * w2d) * (1.0 / w2);
                          T2 = along2;
                          T2d = along2d;
                          N2 = n62;
                          N2d = n62d;
                          z20 = r3;
                          z20d = r3d;
                          z21 = c3;
                          z21d = c3d;
                          z22 = w2;
                          z22d = w2d;
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
                          v20 = rv[a4_3][0] + vr0;
                          v20d = rvd[a4_3][0] + vr0d;
                          v21 = rv[a4_3][1] + vr1;
                          v21d = rvd[a4_3][1] + vr1d;
                          v22 = rv[a4_3][2] + vr2;
                          v22d = rvd[a4_3][2] + vr2d;
                          vx = v20 * T0 + v21 * T1 + v22 * T2;
                          vxd = v20d * T0 + v20 * T0d + (v21d * T1 + v21 * T1d) + (v22d * T2 + v22 *
                              T2d);
                          rhov = -(v20 * N0 + v21 * N1 + v22 * N2) / z22;
                          rhovd = (-(v20d * N0 + v20 * N0d + v21d * N1 + (v22d * N2 + v22 * N2d)) -
                              rhov * z22d) * (1.0 / z22);
                          omega = (Z[j][3] - Z_k3) * u30 + (Z[j][4] - Z_k4) * u31 + (Z[j][5] - Z_k5)
                              * u32;
                          omegad = (Zd[j][3] - Z_k3d) * u30 + (Z[j][3] - Z_k3) * u30d + ((Zd[j][4] -
                              Z_k4d) * u31 + (Z[j][4] - Z_k4) * u31d) + ((Zd[j][5] - Z_k5d) * u32 +
                              (Z[j][5] - Z_k5) * u32d);
                          p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
                          p2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
                          p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
                          p3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
                          fz = p2 * (p3 - z20) + p[t->tyreadr[t->wheeltyre[n2]] +
                              MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
                          fzd = p2d * (p3 - z20) + p2 * (p3d - z20d) +
                              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] * rhov
                              + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] *
                              rhovd);
                          fz0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
                              p[t->tyreadr[t->wheeltyre[n2]]];
                          fz0d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
                              p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] +
                              MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[n2]]];
                          ratio = fz / fz0;
                          ratiod = (fzd - ratio * fz0d) * (1.0 / fz0);
                          t35 = fz0 / p2;
                          t35d = (fz0d - t35 * p2d) * (1.0 / p2);
                          t36 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratio;
                          t36d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratio +
                              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratiod;
                          t37 = atan(t36);
                          t37d = 1.0 / (1.0 + t36 * t36) * t36d;
                          re = p3 - t35 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37
                              + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio);
                          red = p3d - (t35d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] *
                              t37 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio) +
                              t35 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37 +
                              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37d +
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
                            t38 = vx * vx / p4;
                            t38d = (vxd * vx + vx * vxd - t38 * p4d) * (1.0 / p4);
                            y = 0.5 * (p4 + t38);
                            yd = 0.5 * (p4d + t38d);
                          }
                          speed2 = y;
                          speed2d = yd;
                          kappa = (omega * re - vx) / speed2;
                          kappad = (omegad * re + omega * red - vxd - kappa * speed2d) * (1.0 /
                              speed2);
                          a2 = (v20 * L0 + v21 * L1 + v22 * L2) / speed2;
                          a2d = (v20d * L0 + v20 * L0d + (v21d * L1 + v21 * L1d) + (v22d * L2 + v22
                              * L2d) - a2 * speed2d) * (1.0 / speed2);
                          gamma = atan2(z21, z22);
                          gammad = z22 / (z22 * z22 + z21 * z21) * z21d - z21 / (z22 * z22 + z21 *
                              z21) * z22d;
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
      }
    }
    A_j0_2b = 0.0;
    A_j0_2bd = 0.0;
    A_j0_3b = 0.0;
    A_j0_3bd = 0.0;
    A_j0_4b = 0.0;
    A_j0_4bd = 0.0;
    A_j0b = 0.0;
    A_j0bd = 0.0;
    A_j3_2b = 0.0;
    A_j3_2bd = 0.0;
    A_j3_3b = 0.0;
    A_j3_3bd = 0.0;
    A_j3_4b = 0.0;
    A_j3_4bd = 0.0;
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
    c3b = 0.0;
    c3bd = 0.0;
    cb = 0.0;
    cbd = 0.0;
    dampingb = 0.0;
    dampingbd = 0.0;
    db = 0.0;
    dbd = 0.0;
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
    g0_2b = 0.0;
    g0_2bd = 0.0;
    g0_3b = 0.0;
    g0_3bd = 0.0;
    g0_4b = 0.0;
    g0_4bd = 0.0;
    g0b = 0.0;
    g0bd = 0.0;
    g1_2b = 0.0;
    g1_2bd = 0.0;
    g1_3b = 0.0;
    g1_3bd = 0.0;
    g1_4b = 0.0;
    g1_4bd = 0.0;
    g1b = 0.0;
    g1bd = 0.0;
    g20b = 0.0;
    g20bd = 0.0;
    g22b = 0.0;
    g22bd = 0.0;
    g2_2b = 0.0;
    g2_2bd = 0.0;
    g2_4b = 0.0;
    g2_4bd = 0.0;
    g2_5b = 0.0;
    g2_5bd = 0.0;
    gammab = 0.0;
    gammabd = 0.0;
    h00b = 0.0;
    h00bd = 0.0;
    h10b = 0.0;
    h10bd = 0.0;
    h11b = 0.0;
    h11bd = 0.0;
    h2b = 0.0;
    h2bd = 0.0;
    h3b = 0.0;
    h3bd = 0.0;
    hb = 0.0;
    hbd = 0.0;
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
    n40b = 0.0;
    n40bd = 0.0;
    n41b = 0.0;
    n41bd = 0.0;
    n42b = 0.0;
    n42bd = 0.0;
    n5b = 0.0;
    n5bd = 0.0;
    n60b = 0.0;
    n60bd = 0.0;
    n62b = 0.0;
    n62bd = 0.0;
    omegab = 0.0;
    omegabd = 0.0;
    p2b = 0.0;
    p2bd = 0.0;
    p3b = 0.0;
    p3bd = 0.0;
    p_i1b = 0.0;
    p_i1bd = 0.0;
    p_i2b = 0.0;
    p_i2bd = 0.0;
    p_ib = 0.0;
    p_ibd = 0.0;
    r2b = 0.0;
    r2bd = 0.0;
    r3b = 0.0;
    r3bd = 0.0;
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
    rv_k0_2b = 0.0;
    rv_k0_2bd = 0.0;
    rv_k0_3b = 0.0;
    rv_k0_3bd = 0.0;
    rv_k0b = 0.0;
    rv_k0bd = 0.0;
    rv_k1_2b = 0.0;
    rv_k1_2bd = 0.0;
    rv_k1_3b = 0.0;
    rv_k1_3bd = 0.0;
    rv_k1b = 0.0;
    rv_k1bd = 0.0;
    rv_k2b = 0.0;
    rv_k2bd = 0.0;
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
    sumb = 0.0;
    sumbd = 0.0;
    t10b = 0.0;
    t10bd = 0.0;
    t13b = 0.0;
    t13bd = 0.0;
    t14b = 0.0;
    t14bd = 0.0;
    t15b = 0.0;
    t15bd = 0.0;
    t16b = 0.0;
    t16bd = 0.0;
    t17b = 0.0;
    t17bd = 0.0;
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
    t23b = 0.0;
    t23bd = 0.0;
    t26b = 0.0;
    t26bd = 0.0;
    t27b = 0.0;
    t27bd = 0.0;
    t2b = 0.0;
    t2bd = 0.0;
    t33b = 0.0;
    t33bd = 0.0;
    t34b = 0.0;
    t34bd = 0.0;
    t35b = 0.0;
    t35bd = 0.0;
    t36b = 0.0;
    t36bd = 0.0;
    t37b = 0.0;
    t37bd = 0.0;
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
    t9b = 0.0;
    t9bd = 0.0;
    torque0b = 0.0;
    torque0bd = 0.0;
    u20b = 0.0;
    u20bd = 0.0;
    u21b = 0.0;
    u21bd = 0.0;
    u30b = 0.0;
    u30bd = 0.0;
    u31b = 0.0;
    u31bd = 0.0;
    u32b = 0.0;
    u32bd = 0.0;
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
    w2b = 0.0;
    w2bd = 0.0;
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
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LATERAL_ACCELERATION) {
      tb13 = sb[i][2];
      tb13d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      tb14 = tb13 / t8;
      tb14d = (tb13d - tb14 * t8d) * (1.0 / t8);
      g0b += tb14 * g0;
      g0bd += tb14d * g0 + tb14 * g0d;
      g0b += tb14 * g0;
      g0bd += tb14d * g0 + tb14 * g0d;
      g1b += tb14 * g1;
      g1bd += tb14d * g1 + tb14 * g1d;
      g1b += tb14 * g1;
      g1bd += tb14d * g1 + tb14 * g1d;
      t8b -= tb14 * s[i][2];
      t8bd -= tb14d * s[i][2] + tb14 * sd[i][2];
      t7b += t8b * (1.0 / (2.0 * t8));
      t7bd += t8bd * (1.0 / (2.0 * t8)) - t8b * (1.0 / (2.0 * t8) * (2.0 * t8d) / (2.0 * t8));
      g0b += t7b * g0;
      g0bd += t7bd * g0 + t7b * g0d;
      g0b += t7b * g0;
      g0bd += t7bd * g0 + t7b * g0d;
      g1b += t7b * g1;
      g1bd += t7bd * g1 + t7b * g1d;
      g1b += t7b * g1;
      g1bd += t7bd * g1 + t7b * g1d;
      p_i1b += t7b * p_i1;
      p_i1bd += t7bd * p_i1 + t7b * p_i1d;
      p_i1b += t7b * p_i1;
      p_i1bd += t7bd * p_i1 + t7b * p_i1d;
      tb11 = sb[i][1];
      tb11d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb12 = tb11 / t6;
      tb12d = (tb11d - tb12 * t6d) * (1.0 / t6);
      rv_k0b += tb12 * g1;
      rv_k0bd += tb12d * g1 + tb12 * g1d;
      g1b += tb12 * rv_k0;
      g1bd += tb12d * rv_k0 + tb12 * rv_k0d;
      rv_k1b -= tb12 * g0;
      rv_k1bd -= tb12d * g0 + tb12 * g0d;
      g0b -= tb12 * rv_k1;
      g0bd -= tb12d * rv_k1 + tb12 * rv_k1d;
      t6b -= tb12 * s[i][1];
      t6bd -= tb12d * s[i][1] + tb12 * sd[i][1];
      t5b += t6b * (1.0 / (2.0 * t6));
      t5bd += t6bd * (1.0 / (2.0 * t6)) - t6b * (1.0 / (2.0 * t6) * (2.0 * t6d) / (2.0 * t6));
      rv_k0b += t5b * rv_k0;
      rv_k0bd += t5bd * rv_k0 + t5b * rv_k0d;
      rv_k0b += t5b * rv_k0;
      rv_k0bd += t5bd * rv_k0 + t5b * rv_k0d;
      rv_k1b += t5b * rv_k1;
      rv_k1bd += t5bd * rv_k1 + t5b * rv_k1d;
      rv_k1b += t5b * rv_k1;
      rv_k1bd += t5bd * rv_k1 + t5b * rv_k1d;
      wb += t5b;
      wbd += t5bd;
      tb9 = sb[i][0];
      tb9d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      tb10 = tb9 / t4;
      tb10d = (tb9d - tb10 * t4d) * (1.0 / t4);
      n30b += tb10 * n30;
      n30bd += tb10d * n30 + tb10 * n30d;
      n30b += tb10 * n30;
      n30bd += tb10d * n30 + tb10 * n30d;
      n31b += tb10 * n31;
      n31bd += tb10d * n31 + tb10 * n31d;
      n31b += tb10 * n31;
      n31bd += tb10d * n31 + tb10 * n31d;
      n32b += tb10 * n32;
      n32bd += tb10d * n32 + tb10 * n32d;
      n32b += tb10 * n32;
      n32bd += tb10d * n32 + tb10 * n32d;
      t4b -= tb10 * s[i][0];
      t4bd -= tb10d * s[i][0] + tb10 * sd[i][0];
      t3b += t4b * (1.0 / (2.0 * t4));
      t3bd += t4bd * (1.0 / (2.0 * t4)) - t4b * (1.0 / (2.0 * t4) * (2.0 * t4d) / (2.0 * t4));
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
      g2_2b += n32b;
      g2_2bd += n32bd;
      cb -= n32b * rv_k2;
      cbd -= n32bd * rv_k2 + n32b * rv_k2d;
      rv_k2b -= n32b * c;
      rv_k2bd -= n32bd * c + n32b * cd;
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
      t2b -= tb8 * c;
      t2bd -= tb8d * c + tb8 * cd;
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
      p_ib += wb * p_i;
      p_ibd += wbd * p_i + wb * p_id;
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
      tb21 = sb[i][2];
      tb21d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      tb22 = tb21 / t14;
      tb22d = (tb21d - tb22 * t14d) * (1.0 / t14);
      rvb[k][0] += tb22 * g1_2;
      rvbd[k][0] += tb22d * g1_2 + tb22 * g1_2d;
      g1_2b += tb22 * rv[k][0];
      g1_2bd += tb22d * rv[k][0] + tb22 * rvd[k][0];
      rvb[k][1] -= tb22 * g0_2;
      rvbd[k][1] -= tb22d * g0_2 + tb22 * g0_2d;
      g0_2b -= tb22 * rv[k][1];
      g0_2bd -= tb22d * rv[k][1] + tb22 * rvd[k][1];
      t14b -= tb22 * s[i][2];
      t14bd -= tb22d * s[i][2] + tb22 * sd[i][2];
      tb20 = t14b * r2;
      tb20d = t14bd * r2 + t14b * r2d;
      r2b += tb20 * r2;
      r2bd += tb20d * r2 + tb20 * r2d;
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
      u20b += tb19 * u20;
      u20bd += tb19d * u20 + tb19 * u20d;
      u20b += tb19 * u20;
      u20bd += tb19d * u20 + tb19 * u20d;
      u21b += tb19 * u21;
      u21bd += tb19d * u21 + tb19 * u21d;
      u21b += tb19 * u21;
      u21bd += tb19d * u21 + tb19 * u21d;
      r2b -= tb19 * s[i][1];
      r2bd -= tb19d * s[i][1] + tb19 * sd[i][1];
      t13b += sb[i][0] * 2.0;
      t13bd += sbd[i][0] * 2.0;
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      u21b += t13b * (d / (d * d + u21 * u21));
      u21bd += t13bd * (d / (d * d + u21 * u21)) + t13b * ((dd - d / (d * d + u21 * u21) * (dd * d +
          d * dd + (u21d * u21 + u21 * u21d))) / (d * d + u21 * u21));
      db -= t13b * (u21 / (d * d + u21 * u21));
      dbd -= t13bd * (u21 / (d * d + u21 * u21)) + t13b * ((u21d - u21 / (d * d + u21 * u21) * (dd *
          d + d * dd + (u21d * u21 + u21 * u21d))) / (d * d + u21 * u21));
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
      t10b += r2b * (1.0 / (2.0 * r2));
      t10bd += r2bd * (1.0 / (2.0 * r2)) - r2b * (1.0 / (2.0 * r2) * (2.0 * r2d) / (2.0 * r2));
      u20b += t10b * u20;
      u20bd += t10bd * u20 + t10b * u20d;
      u20b += t10b * u20;
      u20bd += t10bd * u20 + t10b * u20d;
      u21b += t10b * u21;
      u21bd += t10bd * u21 + t10b * u21d;
      u21b += t10b * u21;
      u21bd += t10bd * u21 + t10b * u21d;
      p_i2b += t10b * p_i2;
      p_i2bd += t10bd * p_i2 + t10b * p_i2d;
      p_i2b += t10b * p_i2;
      p_i2bd += t10bd * p_i2 + t10b * p_i2d;
      pb[t->sensoradr[i]] += p_i2b;
      pbd[t->sensoradr[i]] += p_i2bd;
      tb16 = u21b / h;
      tb16d = (u21bd - tb16 * hd) * (1.0 / h);
      A_j0b += tb16 * rv_k1_2;
      A_j0bd += tb16d * rv_k1_2 + tb16 * rv_k1_2d;
      rv_k1_2b += tb16 * A_j0;
      rv_k1_2bd += tb16d * A_j0 + tb16 * A_j0d;
      A_j3b -= tb16 * rv_k0_2;
      A_j3bd -= tb16d * rv_k0_2 + tb16 * rv_k0_2d;
      rv_k0_2b -= tb16 * A_j3;
      rv_k0_2bd -= tb16d * A_j3 + tb16 * A_j3d;
      hb -= tb16 * u21;
      hbd -= tb16d * u21 + tb16 * u21d;
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
      t9b += hb * (1.0 / (2.0 * h));
      t9bd += hbd * (1.0 / (2.0 * h)) - hb * (1.0 / (2.0 * h) * (2.0 * hd) / (2.0 * h));
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
      A_j0_2b += tb26 * rv_k1_3;
      A_j0_2bd += tb26d * rv_k1_3 + tb26 * rv_k1_3d;
      rv_k1_3b += tb26 * A_j0_2;
      rv_k1_3bd += tb26d * A_j0_2 + tb26 * A_j0_2d;
      A_j3_2b -= tb26 * rv_k0_3;
      A_j3_2bd -= tb26d * rv_k0_3 + tb26 * rv_k0_3d;
      rv_k0_3b -= tb26 * A_j3_2;
      rv_k0_3bd -= tb26d * A_j3_2 + tb26 * A_j3_2d;
      h2b -= tb26 * s[i][1];
      h2bd -= tb26d * s[i][1] + tb26 * sd[i][1];
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
      t15b += h2b * (1.0 / (2.0 * h2));
      t15bd += h2bd * (1.0 / (2.0 * h2)) - h2b * (1.0 / (2.0 * h2) * (2.0 * h2d) / (2.0 * h2));
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
      g2_4b += sb[i][2];
      g2_4bd += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      tb29 = sb[i][1];
      tb29d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb30 = tb29 / h3;
      tb30d = (tb29d - tb30 * h3d) * (1.0 / h3);
      A_j0_3b += tb30 * g1_3;
      A_j0_3bd += tb30d * g1_3 + tb30 * g1_3d;
      g1_3b += tb30 * A_j0_3;
      g1_3bd += tb30d * A_j0_3 + tb30 * A_j0_3d;
      A_j3_3b -= tb30 * g0_3;
      A_j3_3bd -= tb30d * g0_3 + tb30 * g0_3d;
      g0_3b -= tb30 * A_j3_3;
      g0_3bd -= tb30d * A_j3_3 + tb30 * A_j3_3d;
      h3b -= tb30 * s[i][1];
      h3bd -= tb30d * s[i][1] + tb30 * sd[i][1];
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
      t16b += h3b * (1.0 / (2.0 * h3));
      t16bd += h3bd * (1.0 / (2.0 * h3)) - h3b * (1.0 / (2.0 * h3) * (2.0 * h3d) / (2.0 * h3));
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
      tb33 = sb[i][2];
      tb33d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Ab[j][2] += tb33 * g0_4;
      Abd[j][2] += tb33d * g0_4 + tb33 * g0_4d;
      g0_4b += tb33 * A[j][2];
      g0_4bd += tb33d * A[j][2] + tb33 * Ad[j][2];
      Ab[j][5] += tb33 * g1_4;
      Abd[j][5] += tb33d * g1_4 + tb33 * g1_4d;
      g1_4b += tb33 * A[j][5];
      g1_4bd += tb33d * A[j][5] + tb33 * Ad[j][5];
      Ab[j][8] += tb33 * g2_5;
      Abd[j][8] += tb33d * g2_5 + tb33 * g2_5d;
      g2_5b += tb33 * A[j][8];
      g2_5bd += tb33d * A[j][8] + tb33 * Ad[j][8];
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
      sumb += sb[i][0];
      sumbd += sbd[i][0];
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
      t17b += tb35 * (t19 / (t19 * t19 + t17 * t17));
      t17bd += tb35d * (t19 / (t19 * t19 + t17 * t17)) + tb35 * ((t19d - t19 / (t19 * t19 + t17 *
          t17) * (t19d * t19 + t19 * t19d + (t17d * t17 + t17 * t17d))) / (t19 * t19 + t17 * t17));
      t19b -= tb35 * (t17 / (t19 * t19 + t17 * t17));
      t19bd -= tb35d * (t17 / (t19 * t19 + t17 * t17)) + tb35 * ((t17d - t17 / (t19 * t19 + t17 *
          t17) * (t19d * t19 + t19 * t19d + (t17d * t17 + t17 * t17d))) / (t19 * t19 + t17 * t17));
      t18b += t19b * (1.0 / (2.0 * t19));
      t18bd += t19bd * (1.0 / (2.0 * t19)) - t19b * (1.0 / (2.0 * t19) * (2.0 * t19d) / (2.0 *
          t19));
      A_j7b += t18b * A_j7;
      A_j7bd += t18bd * A_j7 + t18b * A_j7d;
      A_j7b += t18b * A_j7;
      A_j7bd += t18bd * A_j7 + t18b * A_j7d;
      A_j8b += t18b * A_j8;
      A_j8bd += t18bd * A_j8 + t18b * A_j8d;
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
      tb40 = sb[i][2];
      tb40d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Zb[j][5] += tb40;
      Zbd[j][5] += tb40d;
      Ab[j][6] -= tb40 * roll;
      Abd[j][6] -= tb40d * roll + tb40 * rolld;
      rollb -= tb40 * A[j][6];
      rollbd -= tb40d * A[j][6] + tb40 * Ad[j][6];
      tb38 = sb[i][1];
      tb38d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb39 = tb38 / t20;
      tb39d = (tb38d - tb39 * t20d) * (1.0 / t20);
      A_j0_4b += tb39 * Z_j4;
      A_j0_4bd += tb39d * Z_j4 + tb39 * Z_j4d;
      Z_j4b += tb39 * A_j0_4;
      Z_j4bd += tb39d * A_j0_4 + tb39 * A_j0_4d;
      A_j3_4b -= tb39 * Z_j3;
      A_j3_4bd -= tb39d * Z_j3 + tb39 * Z_j3d;
      Z_j3b -= tb39 * A_j3_4;
      Z_j3bd -= tb39d * A_j3_4 + tb39 * A_j3_4d;
      t20b -= tb39 * s[i][1];
      t20bd -= tb39d * s[i][1] + tb39 * sd[i][1];
      c2b += t20b * (1.0 / (2.0 * t20));
      c2bd += t20bd * (1.0 / (2.0 * t20)) - t20b * (1.0 / (2.0 * t20) * (2.0 * t20d) / (2.0 * t20));
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
      tb48 = sb[i][2];
      tb48d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      f0b += tb48;
      f0bd += tb48d;
      f1b += tb48;
      f1bd += tb48d;
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
      n40b += lvb * ev0;
      n40bd += lvbd * ev0 + lvb * ev0d;
      ev0b += lvb * n40;
      ev0bd += lvbd * n40 + lvb * n40d;
      n41b += lvb * ev1;
      n41bd += lvbd * ev1 + lvb * ev1d;
      ev1b += lvb * n41;
      ev1bd += lvbd * n41 + lvb * n41d;
      n42b += lvb * ev2_2;
      n42bd += lvbd * ev2_2 + lvb * ev2_2d;
      ev2_2b += lvb * n42;
      ev2_2bd += lvbd * n42 + lvb * n42d;
      tb43 = n42b / l;
      tb43d = (n42bd - tb43 * ld) * (1.0 / l);
      e2_2b += tb43;
      e2_2bd += tb43d;
      lb -= tb43 * n42;
      lbd -= tb43d * n42 + tb43 * n42d;
      tb42 = n41b / l;
      tb42d = (n41bd - tb42 * ld) * (1.0 / l);
      e1b += tb42;
      e1bd += tb42d;
      lb -= tb42 * n41;
      lbd -= tb42d * n41 + tb42 * n41d;
      tb41 = n40b / l;
      tb41d = (n40bd - tb41 * ld) * (1.0 / l);
      e0b += tb41;
      e0bd += tb41d;
      lb -= tb41 * n40;
      lbd -= tb41d * n40 + tb41 * n40d;
      t21b += lb * (1.0 / (2.0 * l));
      t21bd += lbd * (1.0 / (2.0 * l)) - lb * (1.0 / (2.0 * l) * (2.0 * ld) / (2.0 * l));
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
      rvb[a4][2] += ev2_2b;
      rvbd[a4][2] += ev2_2bd;
      rvb[b][2] -= ev2_2b;
      rvbd[b][2] -= ev2_2bd;
      rb[a4][2] += e2_2b;
      rbd[a4][2] += e2_2bd;
      rb[b][2] -= e2_2b;
      rbd[b][2] -= e2_2bd;
      rvb[a4][1] += ev1b;
      rvbd[a4][1] += ev1bd;
      rvb[b][1] -= ev1b;
      rvbd[b][1] -= ev1bd;
      rb[a4][1] += e1b;
      rbd[a4][1] += e1bd;
      rb[b][1] -= e1b;
      rbd[b][1] -= e1bd;
      rvb[a4][0] += ev0b;
      rvbd[a4][0] += ev0bd;
      rvb[b][0] -= ev0b;
      rvbd[b][0] -= ev0bd;
      rb[a4][0] += e0b;
      rbd[a4][0] += e0bd;
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
      tb50 = z1_3b / l2;
      tb50d = (z1_3bd - tb50 * l2d) * (1.0 / l2);
      e20b += tb50 * ev20;
      e20bd += tb50d * ev20 + tb50 * ev20d;
      ev20b += tb50 * e20;
      ev20bd += tb50d * e20 + tb50 * e20d;
      e21b += tb50 * ev21;
      e21bd += tb50d * ev21 + tb50 * ev21d;
      ev21b += tb50 * e21;
      ev21bd += tb50d * e21 + tb50 * e21d;
      e22b += tb50 * ev22;
      e22bd += tb50d * ev22 + tb50 * ev22d;
      ev22b += tb50 * e22;
      ev22bd += tb50d * e22 + tb50 * e22d;
      l2b -= tb50 * z1_3;
      l2bd -= tb50d * z1_3 + tb50 * z1_3d;
      l2b += z0_3b;
      l2bd += z0_3bd;
      t22b += l2b * (1.0 / (2.0 * l2));
      t22bd += l2bd * (1.0 / (2.0 * l2)) - l2b * (1.0 / (2.0 * l2) * (2.0 * l2d) / (2.0 * l2));
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
      rvb[a4_2][2] += ev22b;
      rvbd[a4_2][2] += ev22bd;
      rvb[b2][2] -= ev22b;
      rvbd[b2][2] -= ev22bd;
      rb[a4_2][2] += e22b;
      rbd[a4_2][2] += e22bd;
      rb[b2][2] -= e22b;
      rbd[b2][2] -= e22bd;
      rvb[a4_2][1] += ev21b;
      rvbd[a4_2][1] += ev21bd;
      rvb[b2][1] -= ev21b;
      rvbd[b2][1] -= ev21bd;
      rb[a4_2][1] += e21b;
      rbd[a4_2][1] += e21bd;
      rb[b2][1] -= e21b;
      rbd[b2][1] -= e21bd;
      rvb[a4_2][0] += ev20b;
      rvbd[a4_2][0] += ev20bd;
      rvb[b2][0] -= ev20b;
      rvbd[b2][0] -= ev20bd;
      rb[a4_2][0] += e20b;
      /* distance of two points and its rate */
      rbd[a4_2][0] += e20bd;
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
        tb191 = sb[i][1];
        tb191d = sbd[i][1];
        sb[i][1] = 0.0;
        sbd[i][1] = 0.0;
        slip1b += tb191 * (1.0 / (1.0 + slip1 * slip1));
        slip1bd += tb191d * (1.0 / (1.0 + slip1 * slip1)) - tb191 * (1.0 / (1.0 + slip1 * slip1) *
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
          t39 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
          t39d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfzd;
          t40 = exp(t39);
          t40d = t40 * t39d;
          stiff = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t40 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          stiffd = ((fz2d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd)))
              * t40 + fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t40d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) * t40 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          t41 = cx * dx;
          t41d = cxd * dx + cx * dxd;
          bx = stiff / t41;
          bxd = (stiffd - bx * t41d) * (1.0 / t41);
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
          t42 = atan(y5);
          t42d = 1.0 / (1.0 + y5 * y5) * y5d;
          t43 = (1.0 - ex) * y5 + ex * t42;
          t43d = -(exd * y5) + (1.0 - ex) * y5d + (exd * t42 + ex * t42d);
          t44 = atan(t43);
          t44d = 1.0 / (1.0 + t43 * t43) * t43d;
          t45 = cx * t44;
          t45d = cxd * t44 + cx * t44d;
          t46 = sin(t45);
          t46d = cos(t45) * t45d;
          x50 = dx * t46 + svx;
          x50d = dxd * t46 + dx * t46d + svxd;
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
          t47 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3;
          t47d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3d;
          z4 = fz2 / t47;
          z4d = (fz2d - z4 * t47d) * (1.0 / t47);
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
            t48 = p5 * p5;
            t48d = p5d * p5 + p5 * p5d;
            z5 = gy * gy / t48;
            z5d = (gyd * gy + gy * gyd - z5 * t48d) * (1.0 / t48);
            y8 = 0.125 * p5 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
            y8d = (0.125 * p5d * z5 + 0.125 * p5 * z5d) * (15.0 + z5 * (-10.0 + 3.0 * z5)) + 0.125 *
                p5 * z5 * (z5d * (-10.0 + 3.0 * z5) + z5 * (3.0 * z5d));
          }
          t49 = 1.0 + z4 * z4;
          t49d = z4d * z4 + z4 * z4d;
          t50 = 2.0 * z4 / t49;
          t50d = (2.0 * z4d - t50 * t49d) * (1.0 / t49);
          stiff2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          stiff2d = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3d) * t50 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50d) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8d)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKY1] * fz0_3 * t50 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKY3] * y8) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          t51 = cy * dy;
          t51d = cyd * dy + cy * dyd;
          by = stiff2 / t51;
          byd = (stiff2d - by * t51d) * (1.0 / t51);
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
          t52 = atan(y9);
          t52d = 1.0 / (1.0 + y9 * y9) * y9d;
          t53 = (1.0 - ey) * y9 + ey * t52;
          t53d = -(eyd * y9) + (1.0 - ey) * y9d + (eyd * t52 + ey * t52d);
          t54 = atan(t53);
          t54d = 1.0 / (1.0 + t53 * t53) * t53d;
          t55 = cy * t54;
          t55d = cyd * t54 + cy * t54d;
          t56 = sin(t55);
          t56d = cos(t55) * t55d;
          y20 = dy * t56 + svy;
          y20d = dyd * t56 + dy * t56d + svyd;
          y21 = stiff2;
          y21d = stiff2d;
          y22 = muy;
          y22d = muyd;
          y23 = by * cy;
          y23d = byd * cy + by * cyd;
          t57 = svy / stiff2;
          t57d = (svyd - t57 * stiff2d) * (1.0 / stiff2);
          y24 = shy + t57;
          y24d = shyd + t57d;
          muy2 = y22;
          muy2d = y22d;
          x6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          x6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBY2] * (a3d - pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          t58 = 1.0 + x6 * x6;
          t58d = x6d * x6 + x6 * x6d;
          t59 = sqrt(t58);
          t59d = 1.0 / (2.0 * t59) * t58d;
          t60 = 1.0 / t59;
          t60d = -(t60 * t59d * (1.0 / t59));
          stiff3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          stiff3d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBY1] * t60 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
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
          t61 = 1.0 + x7 * x7;
          t61d = x7d * x7 + x7 * x7d;
          t62 = sqrt(t61);
          t62d = 1.0 / (2.0 * t62) * t61d;
          t63 = 1.0 / t62;
          t63d = -(t63 * t62d * (1.0 / t62));
          dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) * t63;
          dvd = ((muy2d * fz2 + muy2 * fz2d) * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) + muy2 * fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2d))) * t63 + muy2 * fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) *
              t63d;
          y11 = stiff3 * (kappa2 + s4);
          y11d = stiff3d * (kappa2 + s4) + stiff3 * (kappa2d + s4d);
          y12 = stiff3 * s4;
          y12d = stiff3d * s4 + stiff3 * s4d;
          t64 = atan(y11);
          t64d = 1.0 / (1.0 + y11 * y11) * y11d;
          t65 = (1.0 - e9) * y11 + e9 * t64;
          t65d = -(e9d * y11) + (1.0 - e9) * y11d + (e9d * t64 + e9 * t64d);
          t66 = atan(t65);
          t66d = 1.0 / (1.0 + t65 * t65) * t65d;
          p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
          p6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
          t67 = p6 * t66;
          t67d = p6d * t66 + p6 * t66d;
          t68 = cos(t67);
          t68d = -(sin(t67) * t67d);
          t69 = atan(y12);
          t69d = 1.0 / (1.0 + y12 * y12) * y12d;
          t70 = (1.0 - e9) * y12 + e9 * t69;
          t70d = -(e9d * y12) + (1.0 - e9) * y12d + (e9d * t69 + e9 * t69d);
          t71 = atan(t70);
          t71d = 1.0 / (1.0 + t70 * t70) * t70d;
          t72 = p6 * t71;
          t72d = p6d * t71 + p6 * t71d;
          t73 = cos(t72);
          t73d = -(sin(t72) * t72d);
          g30 = t68 / t73;
          g30d = (t68d - g30 * t73d) * (1.0 / t73);
          t74 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2;
          t74d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2d;
          t75 = atan(t74);
          t75d = 1.0 / (1.0 + t74 * t74) * t74d;
          t76 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t75;
          t76d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t75 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t75d;
          t77 = sin(t76);
          t77d = cos(t76) * t76d;
          g31 = dv * t77 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          g31d = (dvd * t77 + dv * t77d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + dv *
              t77 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          x8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2;
          x8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2d;
          t78 = 1.0 + x8 * x8;
          t78d = x8d * x8 + x8 * x8d;
          t79 = sqrt(t78);
          t79d = 1.0 / (2.0 * t79) * t78d;
          t80 = 1.0 / t79;
          t80d = -(t80 * t79d * (1.0 / t79));
          stiff4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          stiff4d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBX1] * t80 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
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
          t81 = atan(y14);
          t81d = 1.0 / (1.0 + y14 * y14) * y14d;
          t82 = (1.0 - e11) * y14 + e11 * t81;
          t82d = -(e11d * y14) + (1.0 - e11) * y14d + (e11d * t81 + e11 * t81d);
          t83 = atan(t82);
          t83d = 1.0 / (1.0 + t82 * t82) * t82d;
          p8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
          p8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
          t84 = p8 * t83;
          t84d = p8d * t83 + p8 * t83d;
          t85 = cos(t84);
          t85d = -(sin(t84) * t84d);
          t86 = atan(y15);
          t86d = 1.0 / (1.0 + y15 * y15) * y15d;
          t87 = (1.0 - e11) * y15 + e11 * t86;
          t87d = -(e11d * y15) + (1.0 - e11) * y15d + (e11d * t86 + e11 * t86d);
          t88 = atan(t87);
          t88d = 1.0 / (1.0 + t87 * t87) * t87d;
          t89 = p8 * t88;
          t89d = p8d * t88 + p8 * t88d;
          t90 = cos(t89);
          t90d = -(sin(t89) * t89d);
          t91 = t85 / t90;
          t91d = (t85d - t91 * t90d) * (1.0 / t90);
          fx = x50 * t91;
          fxd = x50d * t91 + x50 * t91d;
          fy = g30 * y20 + g31;
          fyd = g30d * y20 + g30 * y20d + g31d;
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
          t92 = at * at + ratio2 * ratio2 + 1e-24;
          t92d = atd * at + at * atd + (ratio2d * ratio2 + ratio2 * ratio2d);
          ateq = sqrt(t92);
          ateqd = 1.0 / (2.0 * ateq) * t92d;
          t93 = ar * ar + ratio2 * ratio2 + 1e-24;
          t93d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
          areq = sqrt(t93);
          areqd = 1.0 / (2.0 * areq) * t93d;
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
            t94 = p9 * p9;
            t94d = p9d * p9 + p9 * p9d;
            z6 = gz * gz / t94;
            z6d = (gzd * gz + gz * gzd - z6 * t94d) * (1.0 / t94);
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
          t95 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
          t95d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] - t95 * fz0_4d) *
              (1.0 / fz0_4);
          dt = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95 *
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
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gzd))) * t95 + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          t96 = bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * at;
          t96d = (btd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] + bt *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1]) * at + bt *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * atd;
          t97 = atan(t96);
          t97d = 1.0 / (1.0 + t96 * t96) * t96d;
          e13 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
              dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t97);
          e13d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfzd)) * (1.0 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t97) +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
              dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gzd)) * 0.63661977236758134308 *
              t97 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t97d);
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
          t98 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LKY] / p10;
          t98d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ9] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] - t98 * p10d) *
              (1.0 / p10);
          br = t98 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycy;
          brd = t98d + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycy +
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
          t99 = 1.0 + a3 * a3;
          t99d = a3d * a3 + a3 * a3d;
          t100 = sqrt(t99);
          t100d = 1.0 / (2.0 * t100) * t99d;
          ca = 1.0 / t100;
          cad = -(ca * t100d * (1.0 / t100));
          y18 = bt * ateq;
          y18d = btd * ateq + bt * ateqd;
          t101 = atan(y18);
          t101d = 1.0 / (1.0 + y18 * y18) * y18d;
          t102 = (1.0 - et) * y18 + et * t101;
          t102d = -(etd * y18) + (1.0 - et) * y18d + (etd * t101 + et * t101d);
          t103 = atan(t102);
          t103d = 1.0 / (1.0 + t102 * t102) * t102d;
          t104 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t103;
          t104d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t103 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t103d;
          t105 = cos(t104);
          t105d = -(sin(t104) * t104d);
          z30 = dt * t105 * ca;
          z30d = (dtd * t105 + dt * t105d) * ca + dt * t105 * cad;
          x9 = br * areq;
          x9d = brd * areq + br * areqd;
          t106 = 1.0 + x9 * x9;
          t106d = x9d * x9 + x9 * x9d;
          t107 = sqrt(t106);
          t107d = 1.0 / (2.0 * t107) * t106d;
          t108 = 1.0 / t107;
          t108d = -(t108 * t107d * (1.0 / t107));
          t109 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
          t109d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fyd - t109 * fz0_2d) * (1.0 /
              fz0_2);
          s3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t109 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LS];
          s3d = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t109d +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfzd)) * gamma2 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2d)) * r0 + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t109 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t109 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS];
          t110 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          t110d = (one4d - t110 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED]) * (1.0 /
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED]);
          way = tanh(t110);
          wayd = (1.0 - way * way) * t110d;
          speed3 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          speed3d = (one4d - speed3 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL]) * (1.0 /
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL]);
          t111 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
          t111d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fyd - t111 * fz0_2d) * (1.0 /
              fz0_2);
          t112 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
          t112d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fxd - t112 * fz0_2d) * (1.0 /
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
          z30b = -(force5b * (fy - g31));
          z30bd = -(force5bd * (fy - g31) + force5b * (fyd - g31d));
          tb190 = force5b * z30;
          tb190d = force5bd * z30 + force5b * z30d;
          fyb = -tb190;
          fybd = -tb190d;
          g31b = tb190;
          g31bd = tb190d;
          z31b = force5b;
          z31bd = force5bd;
          s3b = force5b * fx;
          s3bd = force5bd * fx + force5b * fxd;
          fxb = force5b * s3;
          fxbd = force5bd * s3 + force5b * s3d;
          tb182 = force4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY];
          tb182d = force4bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY] + force4b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY];
          tb183 = tb182 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
              speed3);
          tb183d = tb182d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3)
              + tb182 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112d +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3d) +
              ((((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) *
              speed3 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3
              * speed3d));
          tb184 = tb183 * fz2;
          tb184d = tb183d * fz2 + tb183 * fz2d;
          wayb = -(tb184 * r0);
          waybd = -(tb184d * r0 + tb184 * r0d);
          r0b = -(tb184 * way);
          r0bd = -(tb184d * way + tb184 * wayd);
          fz2b = tb183 * (-way * r0);
          fz2bd = tb183d * (-way * r0) + tb183 * (-(wayd * r0) - way * r0d);
          tb185 = tb182 * (-way * r0 * fz2);
          tb185d = tb182d * (-way * r0 * fz2) + tb182 * ((-(wayd * r0) - way * r0d) * fz2 + -way *
              r0 * fz2d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] += tb185;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] += tb185d;
          t112b = tb185;
          t112bd = tb185d;
          tb186 = tb185 * speed3;
          tb186d = tb185d * speed3 + tb185 * speed3d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] += tb186 * way;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] += tb186d * way + tb186 * wayd;
          wayb += tb186 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3];
          waybd += tb186d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] + tb186 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3];
          speed3b = tb185 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way);
          speed3bd = tb185d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way) + tb185 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * wayd);
          tb187 = tb185 * speed3;
          tb187d = tb185d * speed3 + tb185 * speed3d;
          tb188 = tb187 * speed3;
          tb188d = tb187d * speed3 + tb187 * speed3d;
          tb189 = tb188 * speed3;
          tb189d = tb188d * speed3 + tb188 * speed3d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] += tb189 * speed3;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] += tb189d * speed3 + tb189 * speed3d;
          speed3b += tb189 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4];
          speed3bd += tb189d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] + tb189 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4];
          speed3b += tb188 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3);
          speed3bd += tb188d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3) + tb188
              * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d);
          speed3b += tb187 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3);
          speed3bd += tb187d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3)
              + tb187 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3d);
          speed3b += tb185 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 *
              speed3);
          speed3bd += tb185d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3
              * speed3) + tb185 * (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY] += force4b * (-way * r0 * fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
              speed3));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY] += force4bd * (-way * r0 * fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
              speed3)) + force4b * (((-(wayd * r0) - way * r0d) * fz2 + -way * r0 * fz2d) *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3)
              + -way * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112d +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3d) +
              ((((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) *
              speed3 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3
              * speed3d)));
          tb181 = t112b / fz0_2;
          tb181d = (t112bd - tb181 * fz0_2d) * (1.0 / fz0_2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] += tb181 * fx;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] += tb181d * fx + tb181 * fxd;
          fxb += tb181 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2];
          fxbd += tb181d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] + tb181 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2];
          fz0_2b = -(tb181 * t112);
          fz0_2bd = -(tb181d * t112 + tb181 * t112d);
          tb178 = force3b * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX2] * gamma2 + t111) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX]);
          tb178d = force3bd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX2] * gamma2 + t111) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX])
              + force3b * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX1] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] +
              ((-(pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2d + t111d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX2] * gamma2 + t111) * pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMX]));
          r0b += tb178 * fz2;
          r0bd += tb178d * fz2 + tb178 * fz2d;
          fz2b += tb178 * r0;
          fz2bd += tb178d * r0 + tb178 * r0d;
          tb179 = force3b * (r0 * fz2);
          tb179d = force3bd * (r0 * fz2) + force3b * (r0d * fz2 + r0 * fz2d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] += tb179 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] += tb179d *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + tb179 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] += tb179 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] += tb179d *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] + tb179 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1];
          tb180 = tb179 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX];
          tb180d = tb179d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] + tb179 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] -= tb180 * gamma2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] -= tb180d * gamma2 + tb180 * gamma2d;
          gamma2b = -(tb180 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2]);
          gamma2bd = -(tb180d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] + tb180 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2]);
          t111b = tb180;
          t111bd = tb180d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] += tb179 *
              (-p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2 + t111);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] += tb179d *
              (-p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2 + t111) + tb179 *
              (-(pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2d + t111d);
          tb177 = t111b / fz0_2;
          tb177d = (t111bd - tb177 * fz0_2d) * (1.0 / fz0_2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] += tb177 * fy;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] += tb177d * fy + tb177 * fyd;
          fyb += tb177 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3];
          fybd += tb177d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] + tb177 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3];
          fz0_2b -= tb177 * t111;
          fz0_2bd -= tb177d * t111 + tb177 * t111d;
          fz2b += force2b;
          fz2bd += force2bd;
          fyb += force1b;
          fybd += force1bd;
          fxb += force0b;
          fxbd += force0bd;
          tb176 = speed3b / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          tb176d = (speed3bd - tb176 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL]) * (1.0
              / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL]);
          one4b += tb176;
          one4bd += tb176d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL] -= tb176 * speed3;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL] -= tb176d * speed3 + tb176 *
              speed3d;
          t110b = wayb * (1.0 - way * way);
          t110bd = waybd * (1.0 - way * way) - wayb * (wayd * way + way * wayd);
          tb175 = t110b / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          tb175d = (t110bd - tb175 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED]) * (1.0
              / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED]);
          one4b += tb175;
          one4bd += tb175d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED] -= tb175 * t110;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED] -= tb175d * t110 + tb175 * t110d;
          tb172 = s3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS];
          tb172d = s3bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] + s3b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS];
          tb173 = tb172 * r0;
          tb173d = tb172d * r0 + tb172 * r0d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] += tb173;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] += tb173d;
          t109b = tb173;
          t109bd = tb173d;
          tb174 = tb173 * gamma2;
          tb174d = tb173d * gamma2 + tb173 * gamma2d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] += tb174;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] += tb174d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] += tb174 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] += tb174d * dfz + tb174 * dfzd;
          dfzb = tb174 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4];
          dfzbd = tb174d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] + tb174 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4];
          gamma2b += tb173 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz);
          gamma2bd += tb173d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) + tb173 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfzd));
          r0b += tb172 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t109 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2);
          r0bd += tb172d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t109 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2) + tb172 * (pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t109d + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfzd)) * gamma2 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2d));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] += s3b * ((p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_SSZ1] + t109 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] += s3bd *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t109 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0) + s3b * ((pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t109d + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfzd)) * gamma2 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2d)) * r0 + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t109 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0d);
          tb171 = t109b / fz0_2;
          tb171d = (t109bd - tb171 * fz0_2d) * (1.0 / fz0_2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] += tb171 * fy;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] += tb171d * fy + tb171 * fyd;
          fyb += tb171 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2];
          fybd += tb171d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] + tb171 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2];
          fz0_2b -= tb171 * t109;
          fz0_2bd -= tb171d * t109 + tb171 * t109d;
          tb170 = z31b * ca;
          tb170d = z31bd * ca + z31b * cad;
          drb = tb170 * t108;
          drbd = tb170d * t108 + tb170 * t108d;
          t108b = tb170 * dr;
          t108bd = tb170d * dr + tb170 * drd;
          cab = z31b * (dr * t108);
          cabd = z31bd * (dr * t108) + z31b * (drd * t108 + dr * t108d);
          tb169 = t108b / t107;
          tb169d = (t108bd - tb169 * t107d) * (1.0 / t107);
          t107b = -(tb169 * t108);
          t107bd = -(tb169d * t108 + tb169 * t108d);
          t106b = t107b * (1.0 / (2.0 * t107));
          t106bd = t107bd * (1.0 / (2.0 * t107)) - t107b * (1.0 / (2.0 * t107) * (2.0 * t107d) /
              (2.0 * t107));
          x9b = t106b * x9;
          x9bd = t106bd * x9 + t106b * x9d;
          x9b += t106b * x9;
          x9bd += t106bd * x9 + t106b * x9d;
          brb = x9b * areq;
          brbd = x9bd * areq + x9b * areqd;
          areqb = x9b * br;
          areqbd = x9bd * br + x9b * brd;
          tb168 = z30b * ca;
          tb168d = z30bd * ca + z30b * cad;
          dtb = tb168 * t105;
          dtbd = tb168d * t105 + tb168 * t105d;
          t105b = tb168 * dt;
          t105bd = tb168d * dt + tb168 * dtd;
          cab += z30b * (dt * t105);
          cabd += z30bd * (dt * t105) + z30b * (dtd * t105 + dt * t105d);
          t104b = -(t105b * sin(t104));
          t104bd = -(t105bd * sin(t104) + t105b * (cos(t104) * t104d));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += t104b * t103;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += t104bd * t103 + t104b * t103d;
          t103b = t104b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          t103bd = t104bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] + t104b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          t102b = t103b * (1.0 / (1.0 + t102 * t102));
          t102bd = t103bd * (1.0 / (1.0 + t102 * t102)) - t103b * (1.0 / (1.0 + t102 * t102) *
              (t102d * t102 + t102 * t102d) / (1.0 + t102 * t102));
          etb = -(t102b * y18);
          etbd = -(t102bd * y18 + t102b * y18d);
          y18b = t102b * (1.0 - et);
          y18bd = t102bd * (1.0 - et) - t102b * etd;
          etb += t102b * t101;
          etbd += t102bd * t101 + t102b * t101d;
          t101b = t102b * et;
          t101bd = t102bd * et + t102b * etd;
          y18b += t101b * (1.0 / (1.0 + y18 * y18));
          y18bd += t101bd * (1.0 / (1.0 + y18 * y18)) - t101b * (1.0 / (1.0 + y18 * y18) * (y18d *
              y18 + y18 * y18d) / (1.0 + y18 * y18));
          btb = y18b * ateq;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          btbd = y18bd * ateq + y18b * ateqd;
          ateqb = y18b * bt;
          ateqbd = y18bd * bt + y18b * btd;
          tb167 = cab / t100;
          tb167d = (cabd - tb167 * t100d) * (1.0 / t100);
          t100b = -(tb167 * ca);
          t100bd = -(tb167d * ca + tb167 * cad);
          t99b = t100b * (1.0 / (2.0 * t100));
          t99bd = t100bd * (1.0 / (2.0 * t100)) - t100b * (1.0 / (2.0 * t100) * (2.0 * t100d) / (2.0
              * t100));
          a3b = t99b * a3;
          a3bd = t99bd * a3 + t99b * a3d;
          a3b += t99b * a3;
          a3bd += t99bd * a3 + t99b * a3d;
          tb162 = drb * p10;
          tb162d = drbd * p10 + drb * p10d;
          tb163 = tb162 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          tb163d = tb162d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] + tb162 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          fz2b += tb163 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz);
          fz2bd += tb163d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) +
              tb163 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gzd));
          tb164 = tb163 * fz2;
          tb164d = tb163d * fz2 + tb163 * fz2d;
          tb165 = tb164 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES];
          tb165d = tb164d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + tb164 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] += tb165;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] += tb165d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] += tb165 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] += tb165d * dfz + tb165 * dfzd;
          dfzb += tb165 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7];
          dfzbd += tb165d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] + tb165 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] += tb164 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] += tb164d *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz) + tb164 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6]
              + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfzd));
          tb166 = tb164 * gz;
          tb166d = tb164d * gz + tb164 * gzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] += tb166;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] += tb166d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] += tb166 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] += tb166d * dfz + tb166 * dfzd;
          dfzb += tb166 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9];
          dfzbd += tb166d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] + tb166 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9];
          gzb = tb164 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz);
          gzbd = tb164d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) + tb164 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ9] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfzd));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb162 * (fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gz));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb162d * (fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gz)) + tb162 * (fz2d * ((p[t->tyreadr[t->wheeltyre[n2]] +
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
          t98b = brb;
          t98bd = brbd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] += brb * bycy;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] += brbd * bycy + brb * bycyd;
          bycyb = brb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10];
          bycybd = brbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] + brb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10];
          tb161 = t98b / p10;
          tb161d = (t98bd - tb161 * p10d) * (1.0 / p10);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] += tb161 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] += tb161d *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + tb161 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb161 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9];
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb161d *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] + tb161 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9];
          p10b -= tb161 * t98;
          p10bd -= tb161d * t98 + tb161 * t98d;
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
          tb156 = e13b * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t97);
          tb156d = e13bd * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t97) + e13b * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gzd)) * 0.63661977236758134308 *
              t97 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t97d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] += tb156;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] += tb156d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] += tb156 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] += tb156d * dfz + tb156 * dfzd;
          dfzb += tb156 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2];
          dfzbd += tb156d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] + tb156 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2];
          tb157 = tb156 * dfz;
          tb157d = tb156d * dfz + tb156 * dfzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] += tb157 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] += tb157d * dfz + tb157 * dfzd;
          dfzb += tb157 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3];
          dfzbd += tb157d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] + tb157 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3];
          dfzb += tb156 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz);
          dfzbd += tb156d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz) + tb156 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfzd);
          tb158 = e13b * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfz);
          tb158d = e13bd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfz) + e13b *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfzd));
          tb159 = tb158 * t97;
          tb159d = tb158d * t97 + tb158 * t97d;
          tb160 = tb159 * 0.63661977236758134308;
          tb160d = tb159d * 0.63661977236758134308;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] += tb160;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] += tb160d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] += tb160 * gz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] += tb160d * gz + tb160 * gzd;
          gzb += tb160 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5];
          gzbd += tb160d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] + tb160 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5];
          t97b = tb158 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308);
          t97bd = tb158d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308) +
              tb158 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gzd)) * 0.63661977236758134308);
          t96b = t97b * (1.0 / (1.0 + t96 * t96));
          t96bd = t97bd * (1.0 / (1.0 + t96 * t96)) - t97b * (1.0 / (1.0 + t96 * t96) * (t96d * t96
              + t96 * t96d) / (1.0 + t96 * t96));
          tb155 = t96b * at;
          tb155d = t96bd * at + t96b * atd;
          btb += tb155 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          btbd += tb155d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] + tb155 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += tb155 * bt;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += tb155d * bt + tb155 * btd;
          atb = t96b * (bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1]);
          atbd = t96bd * (bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1]) + t96b * (btd *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] + bt *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1]);
          tb149 = dtb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          tb149d = dtbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] + dtb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          tb150 = tb149 * t95;
          tb150d = tb149d * t95 + tb149 * t95d;
          tb151 = tb150 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz);
          tb151d = tb150d * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) + tb150 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gzd +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gzd) * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gzd));
          fz2b += tb151 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz);
          fz2bd += tb151d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) + tb151 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfzd));
          tb152 = tb151 * fz2;
          tb152d = tb151d * fz2 + tb151 * fz2d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] += tb152;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] += tb152d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] += tb152 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] += tb152d * dfz + tb152 * dfzd;
          dfzb += tb152 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2];
          dfzbd += tb152d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] + tb152 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2];
          tb153 = tb150 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz));
          tb153d = tb150d * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz)) + tb150 * (fz2d *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) + fz2 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfzd)));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] += tb153 * gz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] += tb153d * gz + tb153 * gzd;
          gzb += tb153 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3];
          gzbd += tb153d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] + tb153 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3];
          tb154 = tb153 * gz;
          tb154d = tb153d * gz + tb153 * gzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] += tb154 * gz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] += tb154d * gz + tb154 * gzd;
          gzb += tb154 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4];
          gzbd += tb154d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] + tb154 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4];
          gzb += tb153 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz);
          gzbd += tb153d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz) + tb153 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gzd);
          t95b = tb149 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz));
          t95bd = tb149d * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz)) + tb149 * ((fz2d *
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
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] += dtbd * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95) + dtb *
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
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gzd))) * t95 + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95d);
          tb148 = t95b / fz0_4;
          tb148d = (t95bd - tb148 * fz0_4d) * (1.0 / fz0_4);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb148;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb148d;
          fz0_4b = -(tb148 * t95);
          fz0_4bd = -(tb148d * t95 + tb148 * t95d);
          tb143 = btb / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb143d = (btbd - tb143 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY]) * (1.0 /
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY]);
          tb144 = tb143 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb144d = tb143d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + tb143 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb145 = tb144 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16);
          tb145d = tb144d * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) + tb144 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gzd +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16d));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] += tb145;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] += tb145d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] += tb145 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] += tb145d * dfz + tb145 * dfzd;
          dfzb += tb145 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2];
          dfzbd += tb145d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] + tb145 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2];
          tb146 = tb145 * dfz;
          tb146d = tb145d * dfz + tb145 * dfzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] += tb146 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] += tb146d * dfz + tb146 * dfzd;
          dfzb += tb146 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3];
          dfzbd += tb146d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] + tb146 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3];
          dfzb += tb145 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz);
          dfzbd += tb145d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz) + tb145 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfzd);
          tb147 = tb144 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfz);
          tb147d = tb144d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfz) + tb144 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfzd));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] += tb147 * gz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] += tb147d * gz + tb147 * gzd;
          gzb += tb147 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4];
          gzbd += tb147d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] + tb147 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] += tb147 * y16;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] += tb147d * y16 + tb147 * y16d;
          y16b = tb147 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5];
          y16bd = tb147d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] + tb147 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb143 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb143d *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16)) + tb143 *
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
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] -= tb143 * bt;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] -= tb143d * bt + tb143 * btd;
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
            t94 = p9 * p9;
            t94d = p9d * p9 + p9 * p9d;
            z6 = gz * gz / t94;
            z6d = (gzd * gz + gz * gzd - z6 * t94d) * (1.0 / t94);
            tb141 = y16b * (15.0 + z6 * (-10.0 + 3.0 * z6));
            tb141d = y16bd * (15.0 + z6 * (-10.0 + 3.0 * z6)) + y16b * (z6d * (-10.0 + 3.0 * z6) +
                z6 * (3.0 * z6d));
            p9b = tb141 * z6 * 0.125;
            p9bd = (tb141d * z6 + tb141 * z6d) * 0.125;
            z6b = tb141 * (0.125 * p9);
            z6bd = tb141d * (0.125 * p9) + tb141 * (0.125 * p9d);
            tb142 = y16b * (0.125 * p9 * z6);
            tb142d = y16bd * (0.125 * p9 * z6) + y16b * (0.125 * p9d * z6 + 0.125 * p9 * z6d);
            z6b += tb142 * (-10.0 + 3.0 * z6);
            z6bd += tb142d * (-10.0 + 3.0 * z6) + tb142 * (3.0 * z6d);
            z6b += tb142 * z6 * 3.0;
            z6bd += (tb142d * z6 + tb142 * z6d) * 3.0;
            y16b = 0.0;
            y16bd = 0.0;
            tb140 = z6b / t94;
            tb140d = (z6bd - tb140 * t94d) * (1.0 / t94);
            gzb += tb140 * gz;
            gzbd += tb140d * gz + tb140 * gzd;
            gzb += tb140 * gz;
            gzbd += tb140d * gz + tb140 * gzd;
            t94b = -(tb140 * z6);
            t94bd = -(tb140d * z6 + tb140 * z6d);
            p9b += t94b * p9;
            p9bd += t94bd * p9 + t94b * p9d;
            p9b += t94b * p9;
            p9bd += t94bd * p9 + t94b * p9d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p9b;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p9bd;
          }
          t93b = areqb * (1.0 / (2.0 * areq));
          t93bd = areqbd * (1.0 / (2.0 * areq)) - areqb * (1.0 / (2.0 * areq) * (2.0 * areqd) / (2.0
              * areq));
          arb = t93b * ar;
          arbd = t93bd * ar + t93b * ard;
          arb += t93b * ar;
          arbd += t93bd * ar + t93b * ard;
          ratio2b = t93b * ratio2;
          ratio2bd = t93bd * ratio2 + t93b * ratio2d;
          ratio2b += t93b * ratio2;
          ratio2bd += t93bd * ratio2 + t93b * ratio2d;
          t92b = ateqb * (1.0 / (2.0 * ateq));
          t92bd = ateqbd * (1.0 / (2.0 * ateq)) - ateqb * (1.0 / (2.0 * ateq) * (2.0 * ateqd) / (2.0
              * ateq));
          atb += t92b * at;
          atbd += t92bd * at + t92b * atd;
          atb += t92b * at;
          atbd += t92bd * at + t92b * atd;
          ratio2b += t92b * ratio2;
          ratio2bd += t92bd * ratio2 + t92b * ratio2d;
          ratio2b += t92b * ratio2;
          ratio2bd += t92bd * ratio2 + t92b * ratio2d;
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
          tb139 = atb * gz;
          tb139d = atbd * gz + atb * gzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] += tb139;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] += tb139d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] += tb139 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] += tb139d * dfz + tb139 * dfzd;
          dfzb += tb139 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4];
          dfzbd += tb139d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] + tb139 *
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
          tb138 = ratio2b / y21;
          tb138d = (ratio2bd - tb138 * y21d) * (1.0 / y21);
          x51b = tb138 * kappa2;
          x51bd = tb138d * kappa2 + tb138 * kappa2d;
          kappa2b = tb138 * x51;
          kappa2bd = tb138d * x51 + tb138 * x51d;
          y21b = -(tb138 * ratio2);
          y21bd = -(tb138d * ratio2 + tb138 * ratio2d);
          g30b = fyb * y20;
          g30bd = fybd * y20 + fyb * y20d;
          y20b = fyb * g30;
          y20bd = fybd * g30 + fyb * g30d;
          g31b += fyb;
          g31bd += fybd;
          x50b = fxb * t91;
          x50bd = fxbd * t91 + fxb * t91d;
          t91b = fxb * x50;
          t91bd = fxbd * x50 + fxb * x50d;
          tb137 = t91b / t90;
          tb137d = (t91bd - tb137 * t90d) * (1.0 / t90);
          t85b = tb137;
          t85bd = tb137d;
          t90b = -(tb137 * t91);
          t90bd = -(tb137d * t91 + tb137 * t91d);
          t89b = -(t90b * sin(t89));
          t89bd = -(t90bd * sin(t89) + t90b * (cos(t89) * t89d));
          p8b = t89b * t88;
          p8bd = t89bd * t88 + t89b * t88d;
          t88b = t89b * p8;
          t88bd = t89bd * p8 + t89b * p8d;
          t87b = t88b * (1.0 / (1.0 + t87 * t87));
          t87bd = t88bd * (1.0 / (1.0 + t87 * t87)) - t88b * (1.0 / (1.0 + t87 * t87) * (t87d * t87
              + t87 * t87d) / (1.0 + t87 * t87));
          e11b = -(t87b * y15);
          e11bd = -(t87bd * y15 + t87b * y15d);
          y15b = t87b * (1.0 - e11);
          y15bd = t87bd * (1.0 - e11) - t87b * e11d;
          e11b += t87b * t86;
          e11bd += t87bd * t86 + t87b * t86d;
          t86b = t87b * e11;
          t86bd = t87bd * e11 + t87b * e11d;
          y15b += t86b * (1.0 / (1.0 + y15 * y15));
          y15bd += t86bd * (1.0 / (1.0 + y15 * y15)) - t86b * (1.0 / (1.0 + y15 * y15) * (y15d * y15
              + y15 * y15d) / (1.0 + y15 * y15));
          t84b = -(t85b * sin(t84));
          t84bd = -(t85bd * sin(t84) + t85b * (cos(t84) * t84d));
          p8b += t84b * t83;
          p8bd += t84bd * t83 + t84b * t83d;
          t83b = t84b * p8;
          t83bd = t84bd * p8 + t84b * p8d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += p8b;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += p8bd;
          t82b = t83b * (1.0 / (1.0 + t82 * t82));
          t82bd = t83bd * (1.0 / (1.0 + t82 * t82)) - t83b * (1.0 / (1.0 + t82 * t82) * (t82d * t82
              + t82 * t82d) / (1.0 + t82 * t82));
          e11b -= t82b * y14;
          e11bd -= t82bd * y14 + t82b * y14d;
          y14b = t82b * (1.0 - e11);
          y14bd = t82bd * (1.0 - e11) - t82b * e11d;
          e11b += t82b * t81;
          e11bd += t82bd * t81 + t82b * t81d;
          t81b = t82b * e11;
          t81bd = t82bd * e11 + t82b * e11d;
          y14b += t81b * (1.0 / (1.0 + y14 * y14));
          y14bd += t81bd * (1.0 / (1.0 + y14 * y14)) - t81b * (1.0 / (1.0 + y14 * y14) * (y14d * y14
              + y14 * y14d) / (1.0 + y14 * y14));
          stiff4b = y15b * p7;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff4bd = y15bd * p7 + y15b * p7d;
          p7b = y15b * stiff4;
          p7bd = y15bd * stiff4 + y15b * stiff4d;
          stiff4b += y14b * (a3 + p7);
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff4bd += y14bd * (a3 + p7) + y14b * (a3d + p7d);
          tb136 = y14b * stiff4;
          tb136d = y14bd * stiff4 + y14b * stiff4d;
          a3b += tb136;
          a3bd += tb136d;
          p7b += tb136;
          p7bd += tb136d;
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
          tb135 = stiff4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          tb135d = stiff4bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + stiff4b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb135 * t80;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb135d * t80 + tb135 * t80d;
          t80b = tb135 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
          t80bd = tb135d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] + tb135 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += stiff4b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += stiff4bd *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80) + stiff4b *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80d);
          tb134 = t80b / t79;
          tb134d = (t80bd - tb134 * t79d) * (1.0 / t79);
          t79b = -(tb134 * t80);
          t79bd = -(tb134d * t80 + tb134 * t80d);
          t78b = t79b * (1.0 / (2.0 * t79));
          t78bd = t79bd * (1.0 / (2.0 * t79)) - t79b * (1.0 / (2.0 * t79) * (2.0 * t79d) / (2.0 *
              t79));
          x8b = t78b * x8;
          x8bd = t78bd * x8 + t78b * x8d;
          x8b += t78b * x8;
          x8bd += t78bd * x8 + t78b * x8d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x8b * kappa2;
          /* Gxa = Fx / Fx0 */
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x8bd * kappa2 + x8b * kappa2d;
          kappa2b += x8b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
          kappa2bd += x8bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] + x8b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
          tb133 = g31b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          tb133d = g31bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + g31b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          dvb = tb133 * t77;
          dvbd = tb133d * t77 + tb133 * t77d;
          t77b = tb133 * dv;
          t77bd = tb133d * dv + tb133 * dvd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g31b * (dv * t77);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g31bd * (dv * t77) + g31b * (dvd *
              t77 + dv * t77d);
          t76b = t77b * cos(t76);
          t76bd = t77bd * cos(t76) - t77b * (sin(t76) * t76d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t76b * t75;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t76bd * t75 + t76b * t75d;
          t75b = t76b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
          t75bd = t76bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] + t76b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
          t74b = t75b * (1.0 / (1.0 + t74 * t74));
          t74bd = t75bd * (1.0 / (1.0 + t74 * t74)) - t75b * (1.0 / (1.0 + t74 * t74) * (t74d * t74
              + t74 * t74d) / (1.0 + t74 * t74));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t74b * kappa2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t74bd * kappa2 + t74b * kappa2d;
          kappa2b += t74b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
          kappa2bd += t74bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] + t74b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
          tb132 = g30b / t73;
          tb132d = (g30bd - tb132 * t73d) * (1.0 / t73);
          t68b = tb132;
          t68bd = tb132d;
          t73b = -(tb132 * g30);
          t73bd = -(tb132d * g30 + tb132 * g30d);
          t72b = -(t73b * sin(t72));
          t72bd = -(t73bd * sin(t72) + t73b * (cos(t72) * t72d));
          p6b = t72b * t71;
          p6bd = t72bd * t71 + t72b * t71d;
          t71b = t72b * p6;
          t71bd = t72bd * p6 + t72b * p6d;
          t70b = t71b * (1.0 / (1.0 + t70 * t70));
          t70bd = t71bd * (1.0 / (1.0 + t70 * t70)) - t71b * (1.0 / (1.0 + t70 * t70) * (t70d * t70
              + t70 * t70d) / (1.0 + t70 * t70));
          e9b = -(t70b * y12);
          e9bd = -(t70bd * y12 + t70b * y12d);
          y12b = t70b * (1.0 - e9);
          y12bd = t70bd * (1.0 - e9) - t70b * e9d;
          e9b += t70b * t69;
          e9bd += t70bd * t69 + t70b * t69d;
          t69b = t70b * e9;
          t69bd = t70bd * e9 + t70b * e9d;
          y12b += t69b * (1.0 / (1.0 + y12 * y12));
          y12bd += t69bd * (1.0 / (1.0 + y12 * y12)) - t69b * (1.0 / (1.0 + y12 * y12) * (y12d * y12
              + y12 * y12d) / (1.0 + y12 * y12));
          t67b = -(t68b * sin(t67));
          t67bd = -(t68bd * sin(t67) + t68b * (cos(t67) * t67d));
          p6b += t67b * t66;
          p6bd += t67bd * t66 + t67b * t66d;
          t66b = t67b * p6;
          t66bd = t67bd * p6 + t67b * p6d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += p6b;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += p6bd;
          t65b = t66b * (1.0 / (1.0 + t65 * t65));
          t65bd = t66bd * (1.0 / (1.0 + t65 * t65)) - t66b * (1.0 / (1.0 + t65 * t65) * (t65d * t65
              + t65 * t65d) / (1.0 + t65 * t65));
          e9b -= t65b * y11;
          e9bd -= t65bd * y11 + t65b * y11d;
          y11b = t65b * (1.0 - e9);
          y11bd = t65bd * (1.0 - e9) - t65b * e9d;
          e9b += t65b * t64;
          e9bd += t65bd * t64 + t65b * t64d;
          t64b = t65b * e9;
          t64bd = t65bd * e9 + t65b * e9d;
          y11b += t64b * (1.0 / (1.0 + y11 * y11));
          y11bd += t64bd * (1.0 / (1.0 + y11 * y11)) - t64b * (1.0 / (1.0 + y11 * y11) * (y11d * y11
              + y11 * y11d) / (1.0 + y11 * y11));
          stiff3b = y12b * s4;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff3bd = y12bd * s4 + y12b * s4d;
          s4b = y12b * stiff3;
          s4bd = y12bd * stiff3 + y12b * stiff3d;
          stiff3b += y11b * (kappa2 + s4);
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff3bd += y11bd * (kappa2 + s4) + y11b * (kappa2d + s4d);
          tb131 = y11b * stiff3;
          tb131d = y11bd * stiff3 + y11b * stiff3d;
          kappa2b += tb131;
          kappa2bd += tb131d;
          s4b += tb131;
          s4bd += tb131d;
          tb128 = dvb * t63;
          tb128d = dvbd * t63 + dvb * t63d;
          tb129 = tb128 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2);
          tb129d = tb128d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) + tb128 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2d));
          muy2b = tb129 * fz2;
          muy2bd = tb129d * fz2 + tb129 * fz2d;
          fz2b += tb129 * muy2;
          fz2bd += tb129d * muy2 + tb129 * muy2d;
          tb130 = tb128 * (muy2 * fz2);
          tb130d = tb128d * (muy2 * fz2) + tb128 * (muy2d * fz2 + muy2 * fz2d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb130;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb130d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb130 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb130d * dfz + tb130 * dfzd;
          dfzb += tb130 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
          dfzbd += tb130d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] + tb130 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb130 * gamma2;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb130d * gamma2 + tb130 * gamma2d;
          gamma2b += tb130 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
          gamma2bd += tb130d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] + tb130 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
          t63b = dvb * (muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2));
          t63bd = dvbd * (muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2)) + dvb * ((muy2d * fz2 +
              muy2 * fz2d) * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) + muy2 * fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2d)));
          tb127 = t63b / t62;
          tb127d = (t63bd - tb127 * t62d) * (1.0 / t62);
          t62b = -(tb127 * t63);
          t62bd = -(tb127d * t63 + tb127 * t63d);
          t61b = t62b * (1.0 / (2.0 * t62));
          t61bd = t62bd * (1.0 / (2.0 * t62)) - t62b * (1.0 / (2.0 * t62) * (2.0 * t62d) / (2.0 *
              t62));
          x7b = t61b * x7;
          x7bd = t61bd * x7 + t61b * x7d;
          x7b += t61b * x7;
          x7bd += t61bd * x7 + t61b * x7d;
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
          tb126 = stiff3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          tb126d = stiff3bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + stiff3b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb126 * t60;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb126d * t60 + tb126 * t60d;
          t60b = tb126 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
          t60bd = tb126d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] + tb126 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += stiff3b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += stiff3bd *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60) + stiff3b *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60d);
          tb125 = t60b / t59;
          tb125d = (t60bd - tb125 * t59d) * (1.0 / t59);
          t59b = -(tb125 * t60);
          t59bd = -(tb125d * t60 + tb125 * t60d);
          t58b = t59b * (1.0 / (2.0 * t59));
          t58bd = t59bd * (1.0 / (2.0 * t59)) - t59b * (1.0 / (2.0 * t59) * (2.0 * t59d) / (2.0 *
              t59));
          x6b = t58b * x6;
          x6bd = t58bd * x6 + t58b * x6d;
          x6b += t58b * x6;
          x6bd += t58bd * x6 + t58b * x6d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x6b * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x6bd * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + x6b * (a3d -
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          tb124 = x6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
          tb124d = x6bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] + x6b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
          a3b += tb124;
          a3bd += tb124d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb124;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb124d;
          y22b = muy2b;
          y22bd = muy2bd;
          shyb = y24b;
          shybd = y24bd;
          t57b = y24b;
          t57bd = y24bd;
          tb123 = t57b / stiff2;
          tb123d = (t57bd - tb123 * stiff2d) * (1.0 / stiff2);
          svyb = tb123;
          svybd = tb123d;
          stiff2b = -(tb123 * t57);
          stiff2bd = -(tb123d * t57 + tb123 * t57d);
          byb = y23b * cy;
          bybd = y23bd * cy + y23b * cyd;
          cyb = y23b * by;
          cybd = y23bd * by + y23b * byd;
          muyb = y22b;
          muybd = y22bd;
          stiff2b += y21b;
          stiff2bd += y21bd;
          dyb = y20b * t56;
          dybd = y20bd * t56 + y20b * t56d;
          t56b = y20b * dy;
          t56bd = y20bd * dy + y20b * dyd;
          svyb += y20b;
          svybd += y20bd;
          t55b = t56b * cos(t55);
          t55bd = t56bd * cos(t55) - t56b * (sin(t55) * t55d);
          cyb += t55b * t54;
          cybd += t55bd * t54 + t55b * t54d;
          t54b = t55b * cy;
          t54bd = t55bd * cy + t55b * cyd;
          t53b = t54b * (1.0 / (1.0 + t53 * t53));
          t53bd = t54bd * (1.0 / (1.0 + t53 * t53)) - t54b * (1.0 / (1.0 + t53 * t53) * (t53d * t53
              + t53 * t53d) / (1.0 + t53 * t53));
          eyb = -(t53b * y9);
          eybd = -(t53bd * y9 + t53b * y9d);
          y9b = t53b * (1.0 - ey);
          y9bd = t53bd * (1.0 - ey) - t53b * eyd;
          eyb += t53b * t52;
          eybd += t53bd * t52 + t53b * t52d;
          t52b = t53b * ey;
          t52bd = t53bd * ey + t53b * eyd;
          y9b += t52b * (1.0 / (1.0 + y9 * y9));
          y9bd += t52bd * (1.0 / (1.0 + y9 * y9)) - t52b * (1.0 / (1.0 + y9 * y9) * (y9d * y9 + y9 *
              y9d) / (1.0 + y9 * y9));
          byb += y9b * ay;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          bybd += y9bd * ay + y9b * ayd;
          ayb = y9b * by;
          aybd = y9bd * by + y9b * byd;
          tb119 = svyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb119d = svybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + svyb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          fz2b += tb119 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy);
          fz2bd += tb119d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) +
              tb119 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd)) * gy +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY4] * dfz) * gyd));
          tb120 = tb119 * fz2;
          tb120d = tb119d * fz2 + tb119 * fz2d;
          tb121 = tb120 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
          tb121d = tb120d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + tb120 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb121;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb121d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb121 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb121d * dfz + tb121 * dfzd;
          dfzb += tb121 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
          dfzbd += tb121d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] + tb121 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb120 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY2] * dfz);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb120d *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY2] * dfz) + tb120 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1]
              + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd));
          tb122 = tb120 * gy;
          tb122d = tb120d * gy + tb120 * gyd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb122;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb122d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb122 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb122d * dfz + tb122 * dfzd;
          dfzb += tb122 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
          dfzbd += tb122d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] + tb122 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
          gyb = tb120 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz);
          gybd = tb120d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) + tb120 *
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
          tb118 = byb / t51;
          tb118d = (bybd - tb118 * t51d) * (1.0 / t51);
          stiff2b += tb118;
          stiff2bd += tb118d;
          t51b = -(tb118 * by);
          t51bd = -(tb118d * by + tb118 * byd);
          cyb += t51b * dy;
          cybd += t51bd * dy + t51b * dyd;
          dyb += t51b * cy;
          dybd += t51bd * cy + t51b * cyd;
          tb114 = stiff2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb114d = stiff2bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + stiff2b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb115 = tb114 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8);
          tb115d = tb114d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) - tb114 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8d);
          tb116 = tb115 * t50;
          tb116d = tb115d * t50 + tb115 * t50d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb116 * fz0_3;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb116d * fz0_3 + tb116 * fz0_3d;
          fz0_3b = tb116 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
          fz0_3bd = tb116d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] + tb116 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
          t50b = tb115 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3);
          t50bd = tb115d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3) + tb115 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3d);
          tb117 = tb114 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50);
          tb117d = tb114d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50) +
              tb114 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3d) * t50 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb117 * y8;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb117d * y8 + tb117 * y8d;
          y8b = -(tb117 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
          y8bd = -(tb117d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] + tb117 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += stiff2b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += stiff2bd *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8)) + stiff2b *
              (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3d) * t50 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50d) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8d));
          tb113 = t50b / t49;
          tb113d = (t50bd - tb113 * t49d) * (1.0 / t49);
          z4b = tb113 * 2.0;
          z4bd = tb113d * 2.0;
          t49b = -(tb113 * t50);
          t49bd = -(tb113d * t50 + tb113 * t50d);
          z4b += t49b * z4;
          z4bd += t49bd * z4 + t49b * z4d;
          z4b += t49b * z4;
          z4bd += t49bd * z4 + t49b * z4d;
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
            t48 = p5 * p5;
            t48d = p5d * p5 + p5 * p5d;
            z5 = gy * gy / t48;
            z5d = (gyd * gy + gy * gyd - z5 * t48d) * (1.0 / t48);
            tb111 = y8b * (15.0 + z5 * (-10.0 + 3.0 * z5));
            tb111d = y8bd * (15.0 + z5 * (-10.0 + 3.0 * z5)) + y8b * (z5d * (-10.0 + 3.0 * z5) + z5
                * (3.0 * z5d));
            p5b = tb111 * z5 * 0.125;
            p5bd = (tb111d * z5 + tb111 * z5d) * 0.125;
            z5b = tb111 * (0.125 * p5);
            z5bd = tb111d * (0.125 * p5) + tb111 * (0.125 * p5d);
            tb112 = y8b * (0.125 * p5 * z5);
            tb112d = y8bd * (0.125 * p5 * z5) + y8b * (0.125 * p5d * z5 + 0.125 * p5 * z5d);
            z5b += tb112 * (-10.0 + 3.0 * z5);
            z5bd += tb112d * (-10.0 + 3.0 * z5) + tb112 * (3.0 * z5d);
            z5b += tb112 * z5 * 3.0;
            z5bd += (tb112d * z5 + tb112 * z5d) * 3.0;
            y8b = 0.0;
            y8bd = 0.0;
            tb110 = z5b / t48;
            tb110d = (z5bd - tb110 * t48d) * (1.0 / t48);
            gyb += tb110 * gy;
            gybd += tb110d * gy + tb110 * gyd;
            gyb += tb110 * gy;
            gybd += tb110d * gy + tb110 * gyd;
            t48b = -(tb110 * z5);
            t48bd = -(tb110d * z5 + tb110 * z5d);
            p5b += t48b * p5;
            p5bd += t48bd * p5 + t48b * p5d;
            p5b += t48b * p5;
            p5bd += t48bd * p5 + t48b * p5d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p5b;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p5bd;
          }
          tb109 = z4b / t47;
          tb109d = (z4bd - tb109 * t47d) * (1.0 / t47);
          fz2b += tb109;
          fz2bd += tb109d;
          t47b = -(tb109 * z4);
          t47bd = -(tb109d * z4 + tb109 * z4d);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t47b * fz0_3;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t47bd * fz0_3 + t47b * fz0_3d;
          fz0_3b += t47b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2];
          fz0_3bd += t47bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] + t47b *
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
            tb107 = e7b * e6;
            tb107d = e7bd * e6 + e7b * e6d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb107;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb107d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb107 * gy;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb107d * gy + tb107 * gyd;
            gyb -= tb107 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
            gybd -= tb107d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] + tb107 *
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
            tb108 = e8b * e6;
            tb108d = e8bd * e6 + e8b * e6d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb108;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb108d;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb108 * gy;
            pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb108d * gy + tb108 * gyd;
            gyb += tb108 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
            gybd += tb108d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] + tb108 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
          }
          tb106 = e6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
          tb106d = e6bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] + e6b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb106;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb106d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb106 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb106d * dfz + tb106 * dfzd;
          dfzb += tb106 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2];
          dfzbd += tb106d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] + tb106 *
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
          tb102 = muyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb102d = muybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + muyb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb103 = tb102 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy);
          tb103d = tb102d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy) -
              tb102 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gyd) * gy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gyd);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb103;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb103d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb103 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb103d * dfz + tb103 * dfzd;
          dfzb += tb103 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
          dfzbd += tb103d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] + tb103 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
          tb104 = tb102 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz);
          tb104d = tb102d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz) + tb102 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd));
          tb105 = tb104 * gy;
          tb105d = tb104d * gy + tb104 * gyd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb105 * gy;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb105d * gy + tb105 * gyd;
          gyb -= tb105 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
          gybd -= tb105d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] + tb105 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
          gyb -= tb104 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy);
          gybd -= tb104d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy) + tb104 *
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
          tb101 = shyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
          tb101d = shybd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + shyb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb101;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb101d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb101 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb101d * dfz + tb101 * dfzd;
          dfzb += tb101 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2];
          dfzbd += tb101d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] + tb101 *
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
          dxb = x50b * t46;
          dxbd = x50bd * t46 + x50b * t46d;
          t46b = x50b * dx;
          t46bd = x50bd * dx + x50b * dxd;
          svxb = x50b;
          svxbd = x50bd;
          t45b = t46b * cos(t45);
          t45bd = t46bd * cos(t45) - t46b * (sin(t45) * t45d);
          cxb = t45b * t44;
          cxbd = t45bd * t44 + t45b * t44d;
          t44b = t45b * cx;
          t44bd = t45bd * cx + t45b * cxd;
          t43b = t44b * (1.0 / (1.0 + t43 * t43));
          t43bd = t44bd * (1.0 / (1.0 + t43 * t43)) - t44b * (1.0 / (1.0 + t43 * t43) * (t43d * t43
              + t43 * t43d) / (1.0 + t43 * t43));
          exb = -(t43b * y5);
          exbd = -(t43bd * y5 + t43b * y5d);
          y5b = t43b * (1.0 - ex);
          y5bd = t43bd * (1.0 - ex) - t43b * exd;
          exb += t43b * t42;
          exbd += t43bd * t42 + t43b * t42d;
          t42b = t43b * ex;
          t42bd = t43bd * ex + t43b * exd;
          y5b += t42b * (1.0 / (1.0 + y5 * y5));
          y5bd += t42bd * (1.0 / (1.0 + y5 * y5)) - t42b * (1.0 / (1.0 + y5 * y5) * (y5d * y5 + y5 *
              y5d) / (1.0 + y5 * y5));
          bxb = y5b * kx;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          bxbd = y5bd * kx + y5b * kxd;
          kxb = y5b * bx;
          kxbd = y5bd * bx + y5b * bxd;
          tb98 = svxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb98d = svxbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + svxb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb99 = tb98 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
          tb99d = tb98d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + tb98 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
          fz2b += tb99 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz);
          fz2bd += tb99d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + tb99 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd));
          tb100 = tb99 * fz2;
          tb100d = tb99d * fz2 + tb99 * fz2d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb100;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb100d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb100 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb100d * dfz + tb100 * dfzd;
          dfzb += tb100 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
          dfzbd += tb100d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] + tb100 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb98 * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz));
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb98d * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz)) + tb98 * (fz2d * (p[t->tyreadr[t->wheeltyre[n2]] +
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
          tb97 = bxb / t41;
          tb97d = (bxbd - tb97 * t41d) * (1.0 / t41);
          stiffb += tb97;
          stiffbd += tb97d;
          t41b = -(tb97 * bx);
          t41bd = -(tb97d * bx + tb97 * bxd);
          cxb += t41b * dx;
          cxbd += t41bd * dx + t41b * dxd;
          dxb += t41b * cx;
          dxbd += t41bd * cx + t41b * cxd;
          tb94 = stiffb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          tb94d = stiffbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + stiffb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          tb95 = tb94 * t40;
          tb95d = tb94d * t40 + tb94 * t40d;
          fz2b += tb95 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz);
          fz2bd += tb95d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + tb95 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd));
          tb96 = tb95 * fz2;
          tb96d = tb95d * fz2 + tb95 * fz2d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb96;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb96d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb96 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb96d * dfz + tb96 * dfzd;
          dfzb += tb96 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
          dfzbd += tb96d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] + tb96 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
          t40b = tb94 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz));
          t40bd = tb94d * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz)) + tb94 * (fz2d *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) + fz2 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd)));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += stiffb * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) * t40);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += stiffbd * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) * t40) + stiffb * ((fz2d * (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd)))
              * t40 + fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t40d);
          t39b = t40b * t40;
          t39bd = t40bd * t40 + t40b * t40d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t39b * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t39bd * dfz + t39b * dfzd;
          dfzb += t39b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3];
          dfzbd += t39bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] + t39b *
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
          tb92 = e3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
          tb92d = e3bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] + e3b *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb92;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb92d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb92 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb92d * dfz + tb92 * dfzd;
          dfzb += tb92 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2];
          dfzbd += tb92d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] + tb92 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2];
          tb93 = tb92 * dfz;
          tb93d = tb92d * dfz + tb92 * dfzd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb93 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb93d * dfz + tb93 * dfzd;
          dfzb += tb93 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
          dfzbd += tb93d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] + tb93 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
          dfzb += tb92 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz);
          dfzbd += tb92d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) + tb92 *
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
          tb88 = muxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb88d = muxbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + muxb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb89 = tb88 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx);
          tb89d = tb88d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx) - tb88
              * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gxd) * gx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gxd);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb89;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb89d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb89 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb89d * dfz + tb89 * dfzd;
          dfzb += tb89 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
          dfzbd += tb89d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] + tb89 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
          tb90 = tb88 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz);
          tb90d = tb88d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz) + tb88 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd));
          tb91 = tb90 * gx;
          tb91d = tb90d * gx + tb90 * gxd;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb91 * gx;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb91d * gx + tb91 * gxd;
          gxb = -(tb91 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
          gxbd = -(tb91d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] + tb91 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
          gxb -= tb90 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx);
          gxbd -= tb90d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx) + tb90 *
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
          tb87 = kxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
          tb87d = kxbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] + kxb *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb87;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb87d;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb87 * dfz;
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb87d * dfz + tb87 * dfzd;
          dfzb += tb87 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
          dfzbd += tb87d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] + tb87 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz);
          pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxbd *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHX2] * dfz) + kxb * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfzd));
          tb86 = dfzb / fz0_2;
          tb86d = (dfzbd - tb86 * fz0_2d) * (1.0 / fz0_2);
          fz2b += tb86;
          fz2bd += tb86d;
          fz0_2b -= tb86;
          fz0_2bd -= tb86d;
          fz0_2b -= tb86 * dfz;
          fz0_2bd -= tb86d * dfz + tb86 * dfzd;
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
      tb85 = a2b / speed2;
      tb85d = (a2bd - tb85 * speed2d) * (1.0 / speed2);
      v20b += tb85 * L0;
      v20bd += tb85d * L0 + tb85 * L0d;
      L0b += tb85 * v20;
      L0bd += tb85d * v20 + tb85 * v20d;
      v21b += tb85 * L1;
      v21bd += tb85d * L1 + tb85 * L1d;
      L1b += tb85 * v21;
      L1bd += tb85d * v21 + tb85 * v21d;
      v22b += tb85 * L2;
      v22bd += tb85d * L2 + tb85 * L2d;
      L2b += tb85 * v22;
      L2bd += tb85d * v22 + tb85 * v22d;
      speed2b -= tb85 * a2;
      speed2bd -= tb85d * a2 + tb85 * a2d;
      tb84 = kappab / speed2;
      tb84d = (kappabd - tb84 * speed2d) * (1.0 / speed2);
      omegab += tb84 * re;
      omegabd += tb84d * re + tb84 * red;
      reb += tb84 * omega;
      rebd += tb84d * omega + tb84 * omegad;
      vxb -= tb84;
      vxbd -= tb84d;
      speed2b -= tb84 * kappa;
      speed2bd -= tb84d * kappa + tb84 * kappad;
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
        t38 = vx * vx / p4;
        t38d = (vxd * vx + vx * vxd - t38 * p4d) * (1.0 / p4);
        tb83 = yb * 0.5;
        tb83d = ybd * 0.5;
        p4b = tb83;
        p4bd = tb83d;
        t38b = tb83;
        t38bd = tb83d;
        yb = 0.0;
        ybd = 0.0;
        tb82 = t38b / p4;
        tb82d = (t38bd - tb82 * p4d) * (1.0 / p4);
        vxb += tb82 * vx;
        vxbd += tb82d * vx + tb82 * vxd;
        vxb += tb82 * vx;
        vxbd += tb82d * vx + tb82 * vxd;
        p4b -= tb82 * t38;
        p4bd -= tb82d * t38 + tb82 * t38d;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW] += p4b;
        pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW] += p4bd;
      }
      p3b += reb;
      p3bd += rebd;
      t35b -= reb * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio);
      t35bd -= rebd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio) + reb *
          (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37d +
          (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratiod));
      tb81 = reb * t35;
      tb81d = rebd * t35 + reb * t35d;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] -= tb81 * t37;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] -= tb81d * t37 + tb81 * t37d;
      t37b -= tb81 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF];
      t37bd -= tb81d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] + tb81 *
          pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF];
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] -= tb81 * ratio;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] -= tb81d * ratio + tb81 * ratiod;
      ratiob -= tb81 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF];
      ratiobd -= tb81d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] + tb81 *
          pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF];
      t36b += t37b * (1.0 / (1.0 + t36 * t36));
      t36bd += t37bd * (1.0 / (1.0 + t36 * t36)) - t37b * (1.0 / (1.0 + t36 * t36) * (t36d * t36 +
          t36 * t36d) / (1.0 + t36 * t36));
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] += t36b * ratio;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] += t36bd * ratio + t36b * ratiod;
      ratiob += t36b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF];
      ratiobd += t36bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] + t36b *
          pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF];
      tb80 = t35b / p2;
      tb80d = (t35bd - tb80 * p2d) * (1.0 / p2);
      fz0b += tb80;
      fz0bd += tb80d;
      p2b -= tb80 * t35;
      p2bd -= tb80d * t35 + tb80 * t35d;
      tb79 = ratiob / fz0;
      tb79d = (ratiobd - tb79 * fz0d) * (1.0 / fz0);
      fzb += tb79;
      fzbd += tb79d;
      fz0b -= tb79 * ratio;
      fz0bd -= tb79d * ratio + tb79 * ratiod;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0b * p[t->tyreadr[t->wheeltyre[n2]]];
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0bd * p[t->tyreadr[t->wheeltyre[n2]]]
          + fz0b * pd[t->tyreadr[t->wheeltyre[n2]]];
      pb[t->tyreadr[t->wheeltyre[n2]]] += fz0b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO];
      pbd[t->tyreadr[t->wheeltyre[n2]]] += fz0bd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO]
          + fz0b * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO];
      p2b += fzb * (p3 - z20);
      p2bd += fzbd * (p3 - z20) + fzb * (p3d - z20d);
      tb78 = fzb * p2;
      tb78d = fzbd * p2 + fzb * p2d;
      p3b += tb78;
      p3bd += tb78d;
      z20b -= tb78;
      z20bd -= tb78d;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzbd * rhov + fzb * rhovd;
      rhovb += fzb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING];
      rhovbd += fzbd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] + fzb *
          pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING];
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += p3b;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += p3bd;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += p2b;
      pbd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += p2bd;
      tb75 = omegab * u30;
      tb75d = omegabd * u30 + omegab * u30d;
      Zb[j][3] += tb75;
      Zbd[j][3] += tb75d;
      Z_k3b -= tb75;
      Z_k3bd -= tb75d;
      u30b += omegab * (Z[j][3] - Z_k3);
      u30bd += omegabd * (Z[j][3] - Z_k3) + omegab * (Zd[j][3] - Z_k3d);
      tb76 = omegab * u31;
      tb76d = omegabd * u31 + omegab * u31d;
      Zb[j][4] += tb76;
      Zbd[j][4] += tb76d;
      Z_k4b -= tb76;
      Z_k4bd -= tb76d;
      u31b += omegab * (Z[j][4] - Z_k4);
      u31bd += omegabd * (Z[j][4] - Z_k4) + omegab * (Zd[j][4] - Z_k4d);
      tb77 = omegab * u32;
      tb77d = omegabd * u32 + omegab * u32d;
      Zb[j][5] += tb77;
      Zbd[j][5] += tb77d;
      Z_k5b -= tb77;
      Z_k5bd -= tb77d;
      u32b += omegab * (Z[j][5] - Z_k5);
      u32bd += omegabd * (Z[j][5] - Z_k5) + omegab * (Zd[j][5] - Z_k5d);
      tb74 = rhovb / z22;
      tb74d = (rhovbd - tb74 * z22d) * (1.0 / z22);
      v20b -= tb74 * N0;
      v20bd -= tb74d * N0 + tb74 * N0d;
      N0b -= tb74 * v20;
      N0bd -= tb74d * v20 + tb74 * v20d;
      v21b -= tb74 * N1;
      v21bd -= tb74d * N1;
      v22b -= tb74 * N2;
      v22bd -= tb74d * N2 + tb74 * N2d;
      N2b -= tb74 * v22;
      N2bd -= tb74d * v22 + tb74 * v22d;
      z22b -= tb74 * rhov;
      z22bd -= tb74d * rhov + tb74 * rhovd;
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
      rvb[a4_3][2] += v22b;
      rvbd[a4_3][2] += v22bd;
      vr2b += v22b;
      vr2bd += v22bd;
      rvb[a4_3][1] += v21b;
      rvbd[a4_3][1] += v21bd;
      vr1b += v21b;
      vr1bd += v21bd;
      rvb[a4_3][0] += v20b;
      rvbd[a4_3][0] += v20bd;
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
      w2b += z22b;
      w2bd += z22bd;
      c3b += z21b;
      c3bd += z21bd;
      r3b += z20b;
      r3bd += z20bd;
      n62b += N2b;
      n62bd += N2bd;
      along2b += T2b;
      along2bd += T2bd;
      tb72 = arm2b / w2;
      tb72d = (arm2bd - tb72 * w2d) * (1.0 / w2);
      r3b += tb72 * (c3 * u32 - n62);
      r3bd += tb72d * (c3 * u32 - n62) + tb72 * (c3d * u32 + c3 * u32d - n62d);
      tb73 = tb72 * r3;
      tb73d = tb72d * r3 + tb72 * r3d;
      c3b += tb73 * u32;
      c3bd += tb73d * u32 + tb73 * u32d;
      u32b += tb73 * c3;
      u32bd += tb73d * c3 + tb73 * c3d;
      n62b -= tb73;
      n62bd -= tb73d;
      w2b -= tb72 * arm2;
      w2bd -= tb72d * arm2 + tb72 * arm2d;
      along1b += T1b;
      along1bd += T1bd;
      tb70 = arm1b / w2;
      tb70d = (arm1bd - tb70 * w2d) * (1.0 / w2);
      r3b += tb70 * (c3 * u31 - n61);
      r3bd += tb70d * (c3 * u31 - n61) + tb70 * (c3d * u31 + c3 * u31d);
      tb71 = tb70 * r3;
      tb71d = tb70d * r3 + tb70 * r3d;
      c3b += tb71 * u31;
      c3bd += tb71d * u31 + tb71 * u31d;
      u31b += tb71 * c3;
      u31bd += tb71d * c3 + tb71 * c3d;
      w2b -= tb70 * arm1;
      w2bd -= tb70d * arm1 + tb70 * arm1d;
      n60b += N0b;
      n60bd += N0bd;
      along0b += T0b;
      along0bd += T0bd;
      tb68 = arm0b / w2;
      tb68d = (arm0bd - tb68 * w2d) * (1.0 / w2);
      r3b += tb68 * (c3 * u30 - n60);
      r3bd += tb68d * (c3 * u30 - n60) + tb68 * (c3d * u30 + c3 * u30d - n60d);
      tb69 = tb68 * r3;
      tb69d = tb68d * r3 + tb68 * r3d;
      c3b += tb69 * u30;
      c3bd += tb69d * u30 + tb69 * u30d;
      u30b += tb69 * c3;
      u30bd += tb69d * c3 + tb69 * c3d;
      n60b -= tb69;
      n60bd -= tb69d;
      w2b -= tb68 * arm0;
      w2bd -= tb68d * arm0 + tb68 * arm0d;
      n60b += L2b * along1;
      n60bd += L2bd * along1 + L2b * along1d;
      along1b += L2b * n60;
      along1bd += L2bd * n60 + L2b * n60d;
      along0b -= L2b * n61;
      along0bd -= L2bd * n61;
      n62b += L1b * along0;
      n62bd += L1bd * along0 + L1b * along0d;
      along0b += L1b * n62;
      along0bd += L1bd * n62 + L1b * n62d;
      n60b -= L1b * along2;
      n60bd -= L1bd * along2 + L1b * along2d;
      along2b -= L1b * n60;
      along2bd -= L1bd * n60 + L1b * n60d;
      along2b += L0b * n61;
      along2bd += L0bd * n61;
      n62b -= L0b * along1;
      n62bd -= L0bd * along1 + L0b * along1d;
      along1b -= L0b * n62;
      along1bd -= L0bd * n62 + L0b * n62d;
      tb67 = along2b / w2;
      tb67d = (along2bd - tb67 * w2d) * (1.0 / w2);
      un2b += tb67;
      un2bd += tb67d;
      w2b -= tb67 * along2;
      w2bd -= tb67d * along2 + tb67 * along2d;
      tb66 = along1b / w2;
      tb66d = (along1bd - tb66 * w2d) * (1.0 / w2);
      un1b += tb66;
      un1bd += tb66d;
      w2b -= tb66 * along1;
      w2bd -= tb66d * along1 + tb66 * along1d;
      tb65 = along0b / w2;
      tb65d = (along0bd - tb65 * w2d) * (1.0 / w2);
      un0b += tb65;
      un0bd += tb65d;
      w2b -= tb65 * along0;
      w2bd -= tb65d * along0 + tb65 * along0d;
      tb62 = r3b / w2;
      tb62d = (r3bd - tb62 * w2d) * (1.0 / w2);
      tb63 = tb62 * n60;
      tb63d = tb62d * n60 + tb62 * n60d;
      g20b += tb63;
      g20bd += tb63d;
      x3b -= tb63;
      x3bd -= tb63d;
      n60b += tb62 * (g20 - x3);
      n60bd += tb62d * (g20 - x3) + tb62 * (g20d - x3d);
      tb64 = tb62 * n62;
      tb64d = tb62d * n62 + tb62 * n62d;
      g22b += tb64;
      g22bd += tb64d;
      h10b -= tb64;
      h10bd -= tb64d;
      n62b += tb62 * (g22 - h10);
      n62bd += tb62d * (g22 - h10) + tb62 * (g22d - h10d);
      w2b -= tb62 * r3;
      w2bd -= tb62d * r3 + tb62 * r3d;
      t34b += w2b * (1.0 / (2.0 * w2));
      t34bd += w2bd * (1.0 / (2.0 * w2)) - w2b * (1.0 / (2.0 * w2) * (2.0 * w2d) / (2.0 * w2));
      un0b += t34b * un0;
      un0bd += t34bd * un0 + t34b * un0d;
      un0b += t34b * un0;
      un0bd += t34bd * un0 + t34b * un0d;
      un1b += t34b * un1;
      un1bd += t34bd * un1 + t34b * un1d;
      un1b += t34b * un1;
      un1bd += t34bd * un1 + t34b * un1d;
      un2b += t34b * un2;
      un2bd += t34bd * un2 + t34b * un2d;
      un2b += t34b * un2;
      un2bd += t34bd * un2 + t34b * un2d;
      u30b += un2b * n61;
      u30bd += un2bd * n61;
      u31b -= un2b * n60;
      u31bd -= un2bd * n60 + un2b * n60d;
      n60b -= un2b * u31;
      n60bd -= un2bd * u31 + un2b * u31d;
      u32b += un1b * n60;
      u32bd += un1bd * n60 + un1b * n60d;
      n60b += un1b * u32;
      n60bd += un1bd * u32 + un1b * u32d;
      u30b -= un1b * n62;
      u30bd -= un1bd * n62 + un1b * n62d;
      n62b -= un1b * u30;
      n62bd -= un1bd * u30 + un1b * u30d;
      u31b += un0b * n62;
      u31bd += un0bd * n62 + un0b * n62d;
      n62b += un0b * u31;
      n62bd += un0bd * u31 + un0b * u31d;
      u32b -= un0b * n61;
      u32bd -= un0bd * n61;
      u30b += c3b * n60;
      u30bd += c3bd * n60 + c3b * n60d;
      n60b += c3b * u30;
      n60bd += c3bd * u30 + c3b * u30d;
      u31b += c3b * n61;
      u31bd += c3bd * n61;
      u32b += c3b * n62;
      u32bd += c3bd * n62 + c3b * n62d;
      n62b += c3b * u32;
      n62bd += c3bd * u32 + c3b * u32d;
      tb61 = n62b / s2;
      tb61d = (n62bd - tb61 * s2d) * (1.0 / s2);
      s2b -= tb61 * n62;
      s2bd -= tb61d * n62 + tb61 * n62d;
      tb60 = n60b / s2;
      tb60d = (n60bd - tb60 * s2d) * (1.0 / s2);
      h11b -= tb60;
      h11bd -= tb60d;
      s2b -= tb60 * n60;
      s2bd -= tb60d * n60 + tb60 * n60d;
      t33b += s2b * (1.0 / (2.0 * s2));
      t33bd += s2bd * (1.0 / (2.0 * s2)) - s2b * (1.0 / (2.0 * s2) * (2.0 * s2d) / (2.0 * s2));
      h11b += t33b * h11;
      h11bd += t33bd * h11 + t33b * h11d;
      h11b += t33b * h11;
      h11bd += t33bd * h11 + t33b * h11d;
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
        t28 = 6.28318530717958647693 * x3 / p_b2_5;
        t28d = (6.28318530717958647693 * x3d - t28 * p_b2_5d) * (1.0 / p_b2_5);
        t29 = sin(t28);
        t29d = cos(t28) * t28d;
        p_b2_6 = p[t->roadadr[b2_2]];
        p_b2_6d = pd[t->roadadr[b2_2]];
        t30 = p_b2_6 * 6.28318530717958647693 / p_b2_5;
        t30d = (p_b2_6d * 6.28318530717958647693 - t30 * p_b2_5d) * (1.0 / p_b2_5);
        t31 = 6.28318530717958647693 * x3 / p_b2_5;
        t31d = (6.28318530717958647693 * x3d - t31 * p_b2_5d) * (1.0 / p_b2_5);
        t32 = cos(t31);
        t32d = -(sin(t31) * t31d);
        t30b = h11b * t32;
        t30bd = h11bd * t32 + h11b * t32d;
        t32b = h11b * t30;
        t32bd = h11bd * t30 + h11b * t30d;
        h11b = 0.0;
        h11bd = 0.0;
        t31b = -(t32b * sin(t31));
        t31bd = -(t32bd * sin(t31) + t32b * (cos(t31) * t31d));
        tb59 = t31b / p_b2_5;
        tb59d = (t31bd - tb59 * p_b2_5d) * (1.0 / p_b2_5);
        x3b += tb59 * 6.28318530717958647693;
        x3bd += tb59d * 6.28318530717958647693;
        p_b2_5b = -(tb59 * t31);
        p_b2_5bd = -(tb59d * t31 + tb59 * t31d);
        tb58 = t30b / p_b2_5;
        tb58d = (t30bd - tb58 * p_b2_5d) * (1.0 / p_b2_5);
        p_b2_6b = tb58 * 6.28318530717958647693;
        p_b2_6bd = tb58d * 6.28318530717958647693;
        p_b2_5b -= tb58 * t30;
        p_b2_5bd -= tb58d * t30 + tb58 * t30d;
        p_b2_6b += h10b * t29;
        p_b2_6bd += h10bd * t29 + h10b * t29d;
        t29b = h10b * p_b2_6;
        t29bd = h10bd * p_b2_6 + h10b * p_b2_6d;
        h10b = 0.0;
        h10bd = 0.0;
        pb[t->roadadr[b2_2]] += p_b2_6b;
        pbd[t->roadadr[b2_2]] += p_b2_6bd;
        t28b = t29b * cos(t28);
        t28bd = t29bd * cos(t28) - t29b * (sin(t28) * t28d);
        tb57 = t28b / p_b2_5;
        tb57d = (t28bd - tb57 * p_b2_5d) * (1.0 / p_b2_5);
        x3b += tb57 * 6.28318530717958647693;
        x3bd += tb57d * 6.28318530717958647693;
        p_b2_5b -= tb57 * t28;
        p_b2_5bd -= tb57d * t28 + tb57 * t28d;
        pb[t->roadadr[b2_2] + 1] += p_b2_5b;
        pbd[t->roadadr[b2_2] + 1] += p_b2_5bd;
      }
      g20b += x3b;
      g20bd += x3bd;
      t27b += x3b * (g22 - h00);
      t27bd += x3bd * (g22 - h00) + x3b * (g22d - h00d);
      tb56 = x3b * t27;
      tb56d = x3bd * t27 + x3b * t27d;
      g22b += tb56;
      g22bd += tb56d;
      h00b -= tb56;
      h00bd -= tb56d;
      tb55 = t27b / t26;
      tb55d = (t27bd - tb55 * t26d) * (1.0 / t26);
      u32b += tb55 * u30;
      u32bd += tb55d * u30 + tb55 * u30d;
      u30b += tb55 * u32;
      u30bd += tb55d * u32 + tb55 * u32d;
      t26b -= tb55 * t27;
      t26bd -= tb55d * t27 + tb55 * t27d;
      u30b += t26b * u30;
      u30bd += t26bd * u30 + t26b * u30d;
      u30b += t26b * u30;
      u30bd += t26bd * u30 + t26b * u30d;
      u31b += t26b * u31;
      u31bd += t26bd * u31 + t26b * u31d;
      u31b += t26b * u31;
      u31bd += t26bd * u31 + t26b * u31d;
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
        t24 = 6.28318530717958647693 * x4 / p_b2_2;
        t24d = (6.28318530717958647693 * x4d - t24 * p_b2_2d) * (1.0 / p_b2_2);
        t25 = sin(t24);
        t25d = cos(t24) * t24d;
        p_b2_3 = p[t->roadadr[b2_2]];
        p_b2_3d = pd[t->roadadr[b2_2]];
        p_b2_3b = h00b * t25;
        p_b2_3bd = h00bd * t25 + h00b * t25d;
        t25b = h00b * p_b2_3;
        t25bd = h00bd * p_b2_3 + h00b * p_b2_3d;
        h00b = 0.0;
        h00bd = 0.0;
        pb[t->roadadr[b2_2]] += p_b2_3b;
        pbd[t->roadadr[b2_2]] += p_b2_3bd;
        t24b = t25b * cos(t24);
        t24bd = t25bd * cos(t24) - t25b * (sin(t24) * t24d);
        tb54 = t24b / p_b2_2;
        tb54d = (t24bd - tb54 * p_b2_2d) * (1.0 / p_b2_2);
        x4b += tb54 * 6.28318530717958647693;
        x4bd += tb54d * 6.28318530717958647693;
        p_b2_2b = -(tb54 * t24);
        p_b2_2bd = -(tb54d * t24 + tb54 * t24d);
        pb[t->roadadr[b2_2] + 1] += p_b2_2b;
        pbd[t->roadadr[b2_2] + 1] += p_b2_2bd;
      }
      g20b += x4b;
      /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
       * the centre down the disc meets it, n its normal; then down the disc to that plane,
       *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
       * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
      g20bd += x4bd;
      rb[a4_3][2] += g22b;
      rbd[a4_3][2] += g22bd;
      rb[t->roadpoint[b2_2]][2] -= g22b;
      rbd[t->roadpoint[b2_2]][2] -= g22bd;
      rb[a4_3][0] += g20b;
      rbd[a4_3][0] += g20bd;
      rb[t->roadpoint[b2_2]][0] -= g20b;
      rbd[t->roadpoint[b2_2]][0] -= g20bd;
      tb53 = u32b / n5;
      tb53d = (u32bd - tb53 * n5d) * (1.0 / n5);
      ua2b += tb53;
      ua2bd += tb53d;
      n5b -= tb53 * u32;
      n5bd -= tb53d * u32 + tb53 * u32d;
      tb52 = u31b / n5;
      tb52d = (u31bd - tb52 * n5d) * (1.0 / n5);
      ua1b += tb52;
      ua1bd += tb52d;
      n5b -= tb52 * u31;
      n5bd -= tb52d * u31 + tb52 * u31d;
      tb51 = u30b / n5;
      tb51d = (u30bd - tb51 * n5d) * (1.0 / n5);
      ua0b += tb51;
      ua0bd += tb51d;
      n5b -= tb51 * u30;
      n5bd -= tb51d * u30 + tb51 * u30d;
      t23b += n5b * (1.0 / (2.0 * n5));
      t23bd += n5bd * (1.0 / (2.0 * n5)) - n5b * (1.0 / (2.0 * n5) * (2.0 * n5d) / (2.0 * n5));
      ua0b += t23b * ua0;
      ua0bd += t23bd * ua0 + t23b * ua0d;
      ua0b += t23b * ua0;
      ua0bd += t23bd * ua0 + t23b * ua0d;
      ua1b += t23b * ua1;
      ua1bd += t23bd * ua1 + t23b * ua1d;
      ua1b += t23b * ua1;
      ua1bd += t23bd * ua1 + t23b * ua1d;
      ua2b += t23b * ua2;
      ua2bd += t23bd * ua2 + t23b * ua2d;
      ua2b += t23b * ua2;
      ua2bd += t23bd * ua2 + t23b * ua2d;
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
