/* Tangent of the adjoint of core/kernel/element.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

void maggi_element_forces_b_d(const maggi_topo *t, const double p[restrict t->np],
                              const double pd[restrict t->np], double pb[restrict t->np],
                              double pbd[restrict t->np], const double fun[restrict t->nfun][3],
                              const double fund[restrict t->nfun][3],
                              double funb[restrict t->nfun][3], double funbd[restrict t->nfun][3],
                              const double spring0[restrict t->nspring],
                              const double spring0d[restrict t->nspring],
                              double spring0b[restrict t->nspring],
                              double spring0bd[restrict t->nspring], const double q[restrict t->nq],
                              const double qd[restrict t->nq], double qb[restrict t->nq],
                              double qbd[restrict t->nq], const double v[restrict t->nq],
                              const double vd[restrict t->nq], double vb[restrict t->nq],
                              double vbd[restrict t->nq], const double A[restrict t->nbody + 1][9],
                              const double Ad[restrict t->nbody + 1][9],
                              double Ab[restrict t->nbody + 1][9],
                              double Abd[restrict t->nbody + 1][9],
                              const double Z[restrict t->nbody + 1][6],
                              const double Zd[restrict t->nbody + 1][6],
                              double Zb[restrict t->nbody + 1][6],
                              double Zbd[restrict t->nbody + 1][6],
                              const double r[restrict t->npoint][3],
                              const double rd[restrict t->npoint][3],
                              double rb[restrict t->npoint][3], double rbd[restrict t->npoint][3],
                              const double rv[restrict t->npoint][3],
                              const double rvd[restrict t->npoint][3],
                              double rvb[restrict t->npoint][3], double rvbd[restrict t->npoint][3],
                              double Q[restrict t->nbody + 1][6],
                              double Qd[restrict t->nbody + 1][6],
                              double Qb[restrict t->nbody + 1][6],
                              double Qbd[restrict t->nbody + 1][6], double tau[restrict t->nq],
                              double taud[restrict t->nq], double taub[restrict t->nq],
                              double taubd[restrict t->nq], double power[restrict 1])
{
  int a, a4, a5, a5_2, a6, adr, adr2, b, b2, b3, b4, i, k, k11, k2;
  double L0, L0b, L0bd, L0d, L1, L1b, L1bd, L1d, L2, L2b, L2bd, L2d, N0, N0b, N0bd, N0d, N1, N2,
      N2b, N2bd, N2d, T0, T0b, T0bd, T0d, T1, T1b, T1bd, T1d, T2, T2b, T2bd, T2d, Z_b43, Z_b43b,
      Z_b43bd, Z_b43d, Z_b44, Z_b44b, Z_b44bd, Z_b44d, Z_b45, Z_b45b, Z_b45bd, Z_b45d, a00, a00b,
      a00bd, a00d, a01, a01b, a01bd, a01d, a02, a02b, a02bd, a02d, a2, a2b, a2bd, a2d, a3, a3b,
      a3bd, a3d, along0, along0b, along0bd, along0d, along1, along1b, along1bd, along1d, along2,
      along2b, along2bd, along2d, ar, arb, arbd, ard, areq, areqb, areqbd, areqd, arm0, arm0b,
      arm0bd, arm0d, arm1, arm1b, arm1bd, arm1d, arm2, arm2b, arm2bd, arm2d, at, atb, atbd, atd,
      ateq, ateqb, ateqbd, ateqd, ay, ayb, aybd, ayd, back0, back0b, back0bd, back0d, back1, back1b,
      back1bd, back1d, back20, back20b, back20bd, back20d, back21, back21b, back21bd, back21d,
      back22, back22b, back22bd, back22d, back2_2, back2_2b, back2_2bd, back2_2d, br, brb, brbd,
      brd, bt, btb, btbd, btd, bx, bxb, bxbd, bxd, by, byb, bybd, bycy, bycyb, bycybd, bycyd, byd,
      c, c20, c20b, c20bd, c20d, c21, c21b, c21bd, c21d, c22, c22b, c22bd, c22d, c3, c3b, c3bd, c3d,
      ca, cab, cabd, cad, cb, cbd, cd, cx, cxb, cxbd, cxd, cy, cyb, cybd, cyd, damping, dampingb,
      dampingbd, dampingd, dfz, dfzb, dfzbd, dfzd, dr, drb, drbd, drd, dt, dtb, dtbd, dtd, dv, dvb,
      dvbd, dvd, dx, dxb, dxbd, dxd, dy, dyb, dybd, dyd, e0, e0b, e0bd, e0d, e1, e10, e10b, e10bd,
      e10d, e11, e11b, e11bd, e11d, e12, e12b, e12bd, e12d, e1b, e1bd, e1d, e2, e2_2, e2_2b, e2_2bd,
      e2_2d, e2b, e2bd, e2d, e3, e3b, e3bd, e3d, e4, e4b, e4bd, e4d, e5, e5b, e5bd, e5d, e6, e6b,
      e6bd, e6d, e7, e7b, e7bd, e7d, e8, e8b, e8bd, e8d, e9, e9b, e9bd, e9d, et, etb, etbd, etd,
      ev0, ev0b, ev0bd, ev0d, ev1, ev1b, ev1bd, ev1d, ev2, ev2b, ev2bd, ev2d, ex, exb, exbd, exd,
      ey, eyb, eybd, eyd, f0, f0b, f0bd, f0d, f1, f1b, f1bd, f1d, f2, f2b, f2bd, f2d, f3, f3b, f3bd,
      f3d, force0, force0b, force0bd, force0d, force1, force1b, force1bd, force1d, force20,
      force20b, force20bd, force20d, force21, force21b, force21bd, force21d, force22, force22b,
      force22bd, force22d, force23, force23b, force23bd, force23d, force24, force24b, force24bd,
      force24d, force25, force25b, force25bd, force25d, force2_2, force2_2b, force2_2bd, force2_2d,
      force30, force30b, force30bd, force30d, force31, force31b, force31bd, force31d, force32,
      force32b, force32bd, force32d, fx, fxb, fxbd, fxd, fy, fyb, fybd, fyd, fz, fz0, fz0_2, fz0_2b,
      fz0_2bd, fz0_2d, fz0_3, fz0_3b, fz0_3bd, fz0_3d, fz0_4, fz0_4b, fz0_4bd, fz0_4d, fz0b, fz0bd,
      fz0d, fz2, fz2b, fz2bd, fz2d, fzb, fzbd, fzd, g0, g0b, g0bd, g0d, g1, g1b, g1bd, g1d, g20,
      g20b, g20bd, g20d, g22, g22b, g22bd, g22d, g2_2, g2_2b, g2_2bd, g2_2d, g30, g30b, g30bd, g30d,
      g31, g31b, g31bd, g31d, gamma, gamma2, gamma2b, gamma2bd, gamma2d, gammab, gammabd, gammad,
      gx, gxb, gxbd, gxd, gy, gyb, gybd, gyd, gz, gzb, gzbd, gzd, h00, h00b, h00bd, h00d, h10, h10b,
      h10bd, h10d, h11, h11b, h11bd, h11d, kappa, kappa2, kappa2b, kappa2bd, kappa2d, kappab,
      kappabd, kappad, kx, kxb, kxbd, kxd, l, lb, lbd, ld, lv, lvb, lvbd, lvd, moment0b, moment0bd,
      moment1b, moment1bd, moment2b, moment2bd, mux, muxb, muxbd, muxd, muy, muy2, muy2b, muy2bd,
      muy2d, muyb, muybd, muyd, n20, n20b, n20bd, n20d, n21, n21b, n21bd, n21d, n22, n22b, n22bd,
      n22d, n3, n3b, n3bd, n3d, n40, n40b, n40bd, n40d, n41, n42, n42b, n42bd, n42d, omega, omegab,
      omegabd, omegad, one0, one0b, one0bd, one0d, one1, one1b, one1bd, one1d, one2, one2b, one2bd,
      one2d, one3, one3b, one3bd, one3d, one4, one4b, one4bd, one4d, p10, p10b, p10bd, p10d, p11,
      p11b, p11bd, p11d, p2, p2b, p2bd, p2d, p3, p3b, p3bd, p3d, p4, p4b, p4bd, p4d, p5, p5b, p5bd,
      p5d, p6, p6b, p6bd, p6d, p7, p7b, p7bd, p7d, p8, p8b, p8bd, p8d, p9, p9b, p9bd, p9d, p_adr2,
      p_adr2b, p_adr2bd, p_adr2d, p_k11, p_k111, p_k111_2, p_k111_2b, p_k111_2bd, p_k111_2d,
      p_k111b, p_k111bd, p_k111d, p_k11_2, p_k11_2b, p_k11_2bd, p_k11_2d, p_k11_3, p_k11_3b,
      p_k11_3bd, p_k11_3d, p_k11_4, p_k11_4b, p_k11_4bd, p_k11_4d, p_k11b, p_k11bd, p_k11d, p_k24,
      p_k24b, p_k24bd, p_k24d, p_k25, p_k25b, p_k25bd, p_k25d, r0, r0b, r0bd, r0d, r2, r2b, r2bd,
      r2d, r30, r30b, r30bd, r30d, r31, r31b, r31bd, r31d, r32, r32b, r32bd, r32d, r_a0, r_a0b,
      r_a0bd, r_a0d, r_a1, r_a1b, r_a1bd, r_a1d, r_a2, r_a2b, r_a2bd, r_a2d, r_b0, r_b0b, r_b0bd,
      r_b0d, r_b1, r_b1b, r_b1bd, r_b1d, r_b2, r_b2b, r_b2bd, r_b2d, r_i0, r_i0b, r_i0bd, r_i0d,
      r_i1, r_i1b, r_i1bd, r_i1d, r_i2, r_i2b, r_i2bd, r_i2d, ratio, ratio2, ratio2b, ratio2bd,
      ratio2d, ratiob, ratiobd, ratiod, re, reb, rebd, red, rhov, rhovb, rhovbd, rhovd, rolling0,
      rolling0b, rolling0bd, rolling0d, rolling1, rolling1b, rolling1bd, rolling1d, rolling2,
      rolling2b, rolling2bd, rolling2d, rolling3, rolling3b, rolling3bd, rolling3d, rolling4,
      rolling4b, rolling4bd, rolling4d, rolling5, rolling5b, rolling5bd, rolling5d, s, s2, s2b,
      s2bd, s2d, s3, s3b, s3bd, s3d, s4, s4b, s4bd, s4d, sb, sbd, sd, shift, shiftb, shiftbd,
      shiftd, shy, shyb, shybd, shyd, side, speed, speed2, speed2b, speed2bd, speed2d, speed3,
      speed3b, speed3bd, speed3d, speedb, speedbd, speedd, stiff, stiff2, stiff2b, stiff2bd,
      stiff2d, stiff3, stiff3b, stiff3bd, stiff3d, stiff4, stiff4b, stiff4bd, stiff4d, stiffb,
      stiffbd, stiffd, svx, svxb, svxbd, svxd, svy, svyb, svybd, svyd, t10, t10b, t10bd, t10d, t11,
      t11b, t11bd, t11d, t12, t12b, t12bd, t12d, t13, t13b, t13bd, t13d, t14, t14b, t14bd, t14d,
      t15, t15b, t15bd, t15d, t16, t16b, t16bd, t16d, t17, t17b, t17bd, t17d, t18, t18b, t18bd,
      t18d, t19, t19b, t19bd, t19d, t2, t20, t20b, t20bd, t20d, t21, t21b, t21bd, t21d, t22, t22b,
      t22bd, t22d, t23, t23b, t23bd, t23d, t24, t24b, t24bd, t24d, t25, t25b, t25bd, t25d, t26,
      t26b, t26bd, t26d, t27, t27b, t27bd, t27d, t28, t28b, t28bd, t28d, t29, t29b, t29bd, t29d,
      t2b, t2bd, t2d, t3, t30, t30b, t30bd, t30d, t31, t31b, t31bd, t31d, t32, t32b, t32bd, t32d,
      t33, t33b, t33bd, t33d, t34, t34b, t34bd, t34d, t35, t35b, t35bd, t35d, t36, t36b, t36bd,
      t36d, t37, t37b, t37bd, t37d, t38, t38b, t38bd, t38d, t39, t39b, t39bd, t39d, t3b, t3bd, t3d,
      t4, t40, t40b, t40bd, t40d, t41, t41b, t41bd, t41d, t42, t42b, t42bd, t42d, t43, t43b, t43bd,
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
      t92bd, t92d, t93, t93b, t93bd, t93d, t9b, t9bd, t9d, tb10, tb100, tb100d, tb101, tb101d,
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
      tb157d, tb158, tb158d, tb159, tb159d, tb15d, tb16, tb160, tb160d, tb161, tb161d, tb162,
      tb162d, tb163, tb163d, tb164, tb164d, tb165, tb165d, tb166, tb166d, tb167, tb167d, tb168,
      tb168d, tb169, tb169d, tb16d, tb17, tb170, tb170d, tb17d, tb18, tb18d, tb19, tb19d, tb2, tb20,
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
      tb97d, tb98, tb98d, tb99, tb99d, tb9d, torque0b, torque0bd, u0, u0b, u0bd, u0d, u1, u1b, u1bd,
      u1d, u20, u20b, u20bd, u20d, u21, u21b, u21bd, u21d, u22, u22b, u22bd, u22d, u2_2, u2_2b,
      u2_2bd, u2_2d, u30, u30b, u30bd, u30d, u31, u31b, u31bd, u31d, u32, u32b, u32bd, u32d, ua0,
      ua0b, ua0bd, ua0d, ua1, ua1b, ua1bd, ua1d, ua2, ua2b, ua2bd, ua2d, un0, un0b, un0bd, un0d,
      un1, un1b, un1bd, un1d, un2, un2b, un2bd, un2d, v40, v40b, v40bd, v40d, v41, v41b, v41bd,
      v41d, v42, v42b, v42bd, v42d, vr0, vr0b, vr0bd, vr0d, vr1, vr1b, vr1bd, vr1d, vr2, vr2b,
      vr2bd, vr2d, vx, vxb, vxbd, vxd, w, way, wayb, waybd, wayd, wb, wbd, wd, wr0, wr0b, wr0bd,
      wr0d, wr1, wr1b, wr1bd, wr1d, wr2, wr2b, wr2bd, wr2d, x, x2, x2b, x2bd, x2d, x3, x3b, x3bd,
      x3d, x40, x40b, x40bd, x40d, x41, x41b, x41bd, x41d, x5, x5b, x5bd, x5d, x6, x6b, x6bd, x6d,
      x7, x7b, x7bd, x7d, x8, x8b, x8bd, x8d, xb, xbd, xd, xv, xvb, xvbd, xvd, y, y10, y10b, y10bd,
      y10d, y11, y11b, y11bd, y11d, y12, y12b, y12bd, y12d, y13, y13b, y13bd, y13d, y14, y14b,
      y14bd, y14d, y15, y15b, y15bd, y15d, y16, y16b, y16bd, y16d, y17, y17b, y17bd, y17d, y18,
      y18b, y18bd, y18d, y20, y20b, y20bd, y20d, y21, y21b, y21bd, y21d, y22, y22b, y22bd, y22d,
      y23, y23b, y23bd, y23d, y24, y24b, y24bd, y24d, y3, y3b, y3bd, y3d, y4, y4b, y4bd, y4d, y5,
      y5b, y5bd, y5d, y6, y6b, y6bd, y6d, y7, y7b, y7bd, y7d, y8, y8b, y8bd, y8d, y9, y9b, y9bd,
      y9d, yb, ybd, yd, z20, z20b, z20bd, z20d, z21, z21b, z21bd, z21d, z22, z22b, z22bd, z22d, z30,
      z30b, z30bd, z30d, z31, z31b, z31bd, z31d, z4, z4b, z4bd, z4d, z5, z5b, z5bd, z5d, z6, z6b,
      z6bd, z6d;

  (void)Q;
  (void)Qd;
  (void)tau;
  (void)taud;
  (void)power;
  for (i = t->nwheel - 1; i >= 0; --i) {
    a6 = t->wheelbody[i];
    b4 = t->wheelcarrier[i];
    k11 = t->wheelroad[i];
    side = t->wheelmirror[i] ? -1.0 : 1.0;
    a00 = p[t->wheelaxis[i]];
    a00d = pd[t->wheelaxis[i]];
    a01 = p[t->wheelaxis[i] + 1];
    a01d = pd[t->wheelaxis[i] + 1];
    a02 = p[t->wheelaxis[i] + 2];
    a02d = pd[t->wheelaxis[i] + 2];
    ua0 = A[a6][0] * a00 + A[a6][1] * a01 + A[a6][2] * a02;
    ua0d = Ad[a6][0] * a00 + A[a6][0] * a00d + (Ad[a6][1] * a01 + A[a6][1] * a01d) + (Ad[a6][2] *
        a02 + A[a6][2] * a02d);
    ua1 = A[a6][3] * a00 + A[a6][4] * a01 + A[a6][5] * a02;
    ua1d = Ad[a6][3] * a00 + A[a6][3] * a00d + (Ad[a6][4] * a01 + A[a6][4] * a01d) + (Ad[a6][5] *
        a02 + A[a6][5] * a02d);
    ua2 = A[a6][6] * a00 + A[a6][7] * a01 + A[a6][8] * a02;
    ua2d = Ad[a6][6] * a00 + A[a6][6] * a00d + (Ad[a6][7] * a01 + A[a6][7] * a01d) + (Ad[a6][8] *
        a02 + A[a6][8] * a02d);
    t4 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
    t4d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
    n3 = sqrt(t4);
    n3d = 1.0 / (2.0 * n3) * t4d;
    u30 = ua0 / n3;
    u30d = (ua0d - u30 * n3d) * (1.0 / n3);
    u31 = ua1 / n3;
    u31d = (ua1d - u31 * n3d) * (1.0 / n3);
    u32 = ua2 / n3;
    u32d = (ua2d - u32 * n3d) * (1.0 / n3);
    g20 = r[t->wheelpoint[i]][0] - r[t->roadpoint[k11]][0];
    g20d = rd[t->wheelpoint[i]][0] - rd[t->roadpoint[k11]][0];
    g22 = r[t->wheelpoint[i]][2] - r[t->roadpoint[k11]][2];
    g22d = rd[t->wheelpoint[i]][2] - rd[t->roadpoint[k11]][2];
    x3 = g20;
    x3d = g20d;
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11 = p[t->roadadr[k11]];
      p_k11d = pd[t->roadadr[k11]];
      h00 = p_k11 * x3;
      h00d = p_k11d * x3 + p_k11 * x3d;
    } else {
      p_k111 = p[t->roadadr[k11] + 1];
      p_k111d = pd[t->roadadr[k11] + 1];
      t5 = 6.28318530717958647693 * x3 / p_k111;
      t5d = (6.28318530717958647693 * x3d - t5 * p_k111d) * (1.0 / p_k111);
      t6 = sin(t5);
      t6d = cos(t5) * t5d;
      p_k11_2 = p[t->roadadr[k11]];
      p_k11_2d = pd[t->roadadr[k11]];
      h00 = p_k11_2 * t6;
      h00d = p_k11_2d * t6 + p_k11_2 * t6d;
    }
    t7 = u30 * u30 + u31 * u31;
    t7d = u30d * u30 + u30 * u30d + (u31d * u31 + u31 * u31d);
    t8 = u32 * u30 / t7;
    t8d = (u32d * u30 + u32 * u30d - t8 * t7d) * (1.0 / t7);
    x2 = g20 + t8 * (g22 - h00);
    x2d = g20d + (t8d * (g22 - h00) + t8 * (g22d - h00d));
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11_3 = p[t->roadadr[k11]];
      p_k11_3d = pd[t->roadadr[k11]];
      h10 = p_k11_3 * x2;
      h10d = p_k11_3d * x2 + p_k11_3 * x2d;
      h11 = p_k11_3;
      h11d = p_k11_3d;
    } else {
      p_k111_2 = p[t->roadadr[k11] + 1];
      p_k111_2d = pd[t->roadadr[k11] + 1];
      t9 = 6.28318530717958647693 * x2 / p_k111_2;
      t9d = (6.28318530717958647693 * x2d - t9 * p_k111_2d) * (1.0 / p_k111_2);
      t10 = sin(t9);
      t10d = cos(t9) * t9d;
      p_k11_4 = p[t->roadadr[k11]];
      p_k11_4d = pd[t->roadadr[k11]];
      h10 = p_k11_4 * t10;
      h10d = p_k11_4d * t10 + p_k11_4 * t10d;
      t11 = p_k11_4 * 6.28318530717958647693 / p_k111_2;
      t11d = (p_k11_4d * 6.28318530717958647693 - t11 * p_k111_2d) * (1.0 / p_k111_2);
      t12 = 6.28318530717958647693 * x2 / p_k111_2;
      t12d = (6.28318530717958647693 * x2d - t12 * p_k111_2d) * (1.0 / p_k111_2);
      t13 = cos(t12);
      t13d = -(sin(t12) * t12d);
      h11 = t11 * t13;
      h11d = t11d * t13 + t11 * t13d;
    }
    t14 = 1.0 + h11 * h11;
    t14d = h11d * h11 + h11 * h11d;
    s2 = sqrt(t14);
    s2d = 1.0 / (2.0 * s2) * t14d;
    n40 = -h11 / s2;
    n40d = (-h11d - n40 * s2d) * (1.0 / s2);
    n41 = 0.0;
    n42 = 1.0 / s2;
    n42d = -(n42 * s2d * (1.0 / s2));
    c3 = u30 * n40 + u31 * n41 + u32 * n42;
    c3d = u30d * n40 + u30 * n40d + u31d * n41 + (u32d * n42 + u32 * n42d);
    un0 = u31 * n42 - u32 * n41;
    un0d = u31d * n42 + u31 * n42d - u32d * n41;
    un1 = u32 * n40 - u30 * n42;
    un1d = u32d * n40 + u32 * n40d - (u30d * n42 + u30 * n42d);
    un2 = u30 * n41 - u31 * n40;
    un2d = u30d * n41 - (u31d * n40 + u31 * n40d);
    t15 = un0 * un0 + un1 * un1 + un2 * un2;
    t15d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
    w = sqrt(t15);
    wd = 1.0 / (2.0 * w) * t15d;
    r2 = ((g20 - x2) * n40 + (g22 - h10) * n42) / w;
    r2d = ((g20d - x2d) * n40 + (g20 - x2) * n40d + ((g22d - h10d) * n42 + (g22 - h10) * n42d) - r2
        * wd) * (1.0 / w);
    along0 = un0 / w;
    along0d = (un0d - along0 * wd) * (1.0 / w);
    along1 = un1 / w;
    along1d = (un1d - along1 * wd) * (1.0 / w);
    along2 = un2 / w;
    along2d = (un2d - along2 * wd) * (1.0 / w);
    L0 = n41 * along2 - n42 * along1;
    L0d = n41 * along2d - (n42d * along1 + n42 * along1d);
    L1 = n42 * along0 - n40 * along2;
    L1d = n42d * along0 + n42 * along0d - (n40d * along2 + n40 * along2d);
    L2 = n40 * along1 - n41 * along0;
    L2d = n40d * along1 + n40 * along1d - n41 * along0d;
    arm0 = r2 * (c3 * u30 - n40) / w;
    arm0d = (r2d * (c3 * u30 - n40) + r2 * (c3d * u30 + c3 * u30d - n40d) - arm0 * wd) * (1.0 / w);
    T0 = along0;
    T0d = along0d;
    N0 = n40;
    N0d = n40d;
    arm1 = r2 * (c3 * u31 - n41) / w;
    arm1d = (r2d * (c3 * u31 - n41) + r2 * (c3d * u31 + c3 * u31d) - arm1 * wd) * (1.0 / w);
    T1 = along1;
    T1d = along1d;
    N1 = n41;
    arm2 = r2 * (c3 * u32 - n42) / w;
    arm2d = (r2d * (c3 * u32 - n42) + r2 * (c3d * u32 + c3 * u32d - n42d) - arm2 * wd) * (1.0 / w);
    T2 = along2;
    T2d = along2d;
    N2 = n42;
    N2d = n42d;
    z20 = r2;
    z20d = r2d;
    z21 = c3;
    z21d = c3d;
    z22 = w;
    z22d = wd;
    Z_b43 = Z[b4][3];
    Z_b43d = Zd[b4][3];
    wr0 = Z_b43;
    wr0d = Z_b43d;
    Z_b44 = Z[b4][4];
    Z_b44d = Zd[b4][4];
    wr1 = Z_b44;
    wr1d = Z_b44d;
    Z_b45 = Z[b4][5];
    Z_b45d = Zd[b4][5];
    wr2 = Z_b45;
    wr2d = Z_b45d;
    vr0 = wr1 * arm2 - wr2 * arm1;
    vr0d = wr1d * arm2 + wr1 * arm2d - (wr2d * arm1 + wr2 * arm1d);
    vr1 = wr2 * arm0 - wr0 * arm2;
    vr1d = wr2d * arm0 + wr2 * arm0d - (wr0d * arm2 + wr0 * arm2d);
    vr2 = wr0 * arm1 - wr1 * arm0;
    vr2d = wr0d * arm1 + wr0 * arm1d - (wr1d * arm0 + wr1 * arm0d);
    v40 = rv[t->wheelpoint[i]][0] + vr0;
    v40d = rvd[t->wheelpoint[i]][0] + vr0d;
    v41 = rv[t->wheelpoint[i]][1] + vr1;
    v41d = rvd[t->wheelpoint[i]][1] + vr1d;
    v42 = rv[t->wheelpoint[i]][2] + vr2;
    v42d = rvd[t->wheelpoint[i]][2] + vr2d;
    vx = v40 * T0 + v41 * T1 + v42 * T2;
    vxd = v40d * T0 + v40 * T0d + (v41d * T1 + v41 * T1d) + (v42d * T2 + v42 * T2d);
    rhov = -(v40 * N0 + v41 * N1 + v42 * N2) / z22;
    rhovd = (-(v40d * N0 + v40 * N0d + v41d * N1 + (v42d * N2 + v42 * N2d)) - rhov * z22d) * (1.0 /
        z22);
    omega = (Z[a6][3] - Z_b43) * u30 + (Z[a6][4] - Z_b44) * u31 + (Z[a6][5] - Z_b45) * u32;
    omegad = (Zd[a6][3] - Z_b43d) * u30 + (Z[a6][3] - Z_b43) * u30d + ((Zd[a6][4] - Z_b44d) * u31 +
        (Z[a6][4] - Z_b44) * u31d) + ((Zd[a6][5] - Z_b45d) * u32 + (Z[a6][5] - Z_b45) * u32d);
    p3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
    p3d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
    p4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
    p4d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
    fz = p3 * (p4 - z20) + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
    fzd = p3d * (p4 - z20) + p3 * (p4d - z20d) + (pd[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_VERTICAL_DAMPING] * rhov + p[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
    fz0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
    fz0d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]] +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
    ratio = fz / fz0;
    ratiod = (fzd - ratio * fz0d) * (1.0 / fz0);
    t16 = fz0 / p3;
    t16d = (fz0d - t16 * p3d) * (1.0 / p3);
    t17 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio;
    t17d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratiod;
    t18 = atan(t17);
    t18d = 1.0 / (1.0 + t17 * t17) * t17d;
    re = p4 - t16 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio);
    red = p4d - (t16d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio) + t16 *
        (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 + p[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_DREFF] * t18d + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratiod)));
    if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y = vx;
      yd = vxd;
    } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y = -vx;
      yd = -vxd;
    } else {
      p5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      p5d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      t19 = vx * vx / p5;
      t19d = (vxd * vx + vx * vxd - t19 * p5d) * (1.0 / p5);
      y = 0.5 * (p5 + t19);
      yd = 0.5 * (p5d + t19d);
    }
    speed2 = y;
    speed2d = yd;
    kappa = (omega * re - vx) / speed2;
    kappad = (omegad * re + omega * red - vxd - kappa * speed2d) * (1.0 / speed2);
    a2 = (v40 * L0 + v41 * L1 + v42 * L2) / speed2;
    a2d = (v40d * L0 + v40 * L0d + (v41d * L1 + v41 * L1d) + (v42d * L2 + v42 * L2d) - a2 * speed2d)
        * (1.0 / speed2);
    gamma = atan2(z21, z22);
    gammad = z22 / (z22 * z22 + z21 * z21) * z21d - z21 / (z22 * z22 + z21 * z21) * z22d;
    if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z20) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] +
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
      if (t->wheelgrip[i]) {
        kappa2 = one0;
        kappa2d = one0d;
        a3 = one1;
        a3d = one1d;
        gamma2 = one2;
        gamma2d = one2d;
        fz2 = one3;
        fz2d = one3d;
        fz0_2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        fz0_2d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        r0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        r0d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        dfz = (fz2 - fz0_2) / fz0_2;
        dfzd = (fz2d - fz0_2d - dfz * fz0_2d) * (1.0 / fz0_2);
        kx = kappa2 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LHX];
        kxd = kappa2d + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHX2] * dfzd)) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX2] * dfz) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX]);
        gx = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        gxd = gamma2d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] + gamma2 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        cx = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        cxd = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX];
        mux = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx *
            gx) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        muxd = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfzd)) *
            (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) -
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gxd) * gx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gxd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        dx = mux * fz2;
        dxd = muxd * fz2 + mux * fz2d;
        e2 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        e2d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        if (MAGGI_RE(kx) > 0.0) {
          e3 = e2 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e3d = e2d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) - e2 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          if (MAGGI_RE(e3) > 1.0) {
            y3 = 1.0;
            y3d = 0.0;
          } else {
            y3 = e3;
            y3d = e3d;
          }
          ex = y3;
          exd = y3d;
        } else {
          e4 = e2 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e4d = e2d * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) + e2 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          if (MAGGI_RE(e4) > 1.0) {
            y4 = 1.0;
            y4d = 0.0;
          } else {
            y4 = e4;
            y4d = e4d;
          }
          ex = y4;
          exd = y4d;
        }
        t20 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz;
        t20d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfzd;
        t21 = exp(t20);
        t21d = t21 * t20d;
        stiff = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        stiffd = ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t21 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21d) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        t22 = cx * dx;
        t22d = cxd * dx + cx * dxd;
        bx = stiff / t22;
        bxd = (stiffd - bx * t22d) * (1.0 / t22);
        svx = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        svxd = ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd))) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LMUX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        y5 = bx * kx;
        y5d = bxd * kx + bx * kxd;
        t23 = atan(y5);
        t23d = 1.0 / (1.0 + y5 * y5) * y5d;
        t24 = (1.0 - ex) * y5 + ex * t23;
        t24d = -(exd * y5) + (1.0 - ex) * y5d + (exd * t23 + ex * t23d);
        t25 = atan(t24);
        t25d = 1.0 / (1.0 + t24 * t24) * t24d;
        t26 = cx * t25;
        t26d = cxd * t25 + cx * t25d;
        t27 = sin(t26);
        t27d = cos(t26) * t26d;
        x40 = dx * t27 + svx;
        x40d = dxd * t27 + dx * t27d + svxd;
        x41 = stiff;
        x41d = stiffd;
        fz0_3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        fz0_3d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        gy = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        gyd = gamma2d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] + gamma2 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        shy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gy;
        shyd = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY3] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gyd);
        ay = a3 + shy;
        ayd = a3d + shyd;
        cy = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        cyd = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY];
        muy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy *
            gy) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        muyd = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfzd)) *
            (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) -
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gyd) * gy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gyd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        dy = muy * fz2;
        dyd = muyd * fz2 + muy * fz2d;
        e5 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        e5d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        if (MAGGI_RE(ay) > 0.0) {
          e6 = e5 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e6d = e5d * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) - e5 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          if (MAGGI_RE(e6) > 1.0) {
            y6 = 1.0;
            y6d = 0.0;
          } else {
            y6 = e6;
            y6d = e6d;
          }
          ey = y6;
          eyd = y6d;
        } else {
          e7 = e5 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e7d = e5d * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) + e5 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          if (MAGGI_RE(e7) > 1.0) {
            y7 = 1.0;
            y7d = 0.0;
          } else {
            y7 = e7;
            y7d = e7d;
          }
          ey = y7;
          eyd = y7d;
        }
        t28 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3;
        t28d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3d;
        z4 = fz2 / t28;
        z4d = (fz2d - z4 * t28d) * (1.0 / t28);
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y8 = gy;
          y8d = gyd;
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y8 = -gy;
          y8d = -gyd;
        } else {
          p6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t29 = p6 * p6;
          t29d = p6d * p6 + p6 * p6d;
          z5 = gy * gy / t29;
          z5d = (gyd * gy + gy * gyd - z5 * t29d) * (1.0 / t29);
          y8 = 0.125 * p6 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
          y8d = (0.125 * p6d * z5 + 0.125 * p6 * z5d) * (15.0 + z5 * (-10.0 + 3.0 * z5)) + 0.125 *
              p6 * z5 * (z5d * (-10.0 + 3.0 * z5) + z5 * (3.0 * z5d));
        }
        t30 = 1.0 + z4 * z4;
        t30d = z4d * z4 + z4 * z4d;
        t31 = 2.0 * z4 / t30;
        t31d = (2.0 * z4d - t31 * t30d) * (1.0 / t30);
        stiff2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY];
        stiff2d = (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d) * t31 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) - p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t31 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8d)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]
            * y8) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        t32 = cy * dy;
        t32d = cyd * dy + cy * dyd;
        by = stiff2 / t32;
        byd = (stiff2d - by * t32d) * (1.0 / t32);
        svy = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        svyd = (fz2d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) + fz2 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfzd)) * gy +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gyd))) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] +
            fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gy) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        y9 = by * ay;
        y9d = byd * ay + by * ayd;
        t33 = atan(y9);
        t33d = 1.0 / (1.0 + y9 * y9) * y9d;
        t34 = (1.0 - ey) * y9 + ey * t33;
        t34d = -(eyd * y9) + (1.0 - ey) * y9d + (eyd * t33 + ey * t33d);
        t35 = atan(t34);
        t35d = 1.0 / (1.0 + t34 * t34) * t34d;
        t36 = cy * t35;
        t36d = cyd * t35 + cy * t35d;
        t37 = sin(t36);
        t37d = cos(t36) * t36d;
        y20 = dy * t37 + svy;
        y20d = dyd * t37 + dy * t37d + svyd;
        y21 = stiff2;
        y21d = stiff2d;
        y22 = muy;
        y22d = muyd;
        y23 = by * cy;
        y23d = byd * cy + by * cyd;
        t38 = svy / stiff2;
        t38d = (svyd - t38 * stiff2d) * (1.0 / stiff2);
        y24 = shy + t38;
        y24d = shyd + t38d;
        muy2 = y22;
        muy2d = y22d;
        x5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a3 - p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBY3]);
        x5d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a3 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RBY2] * (a3d - pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]);
        t39 = 1.0 + x5 * x5;
        t39d = x5d * x5 + x5 * x5d;
        t40 = sqrt(t39);
        t40d = 1.0 / (2.0 * t40) * t39d;
        t41 = 1.0 / t40;
        t41d = -(t41 * t40d * (1.0 / t40));
        stiff3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        stiff3d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41d) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        e9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz;
        e9d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] * dfzd);
        if (MAGGI_RE(e9) > 1.0) {
          y10 = 1.0;
          y10d = 0.0;
        } else {
          y10 = e9;
          y10d = e9d;
        }
        e8 = y10;
        e8d = y10d;
        s4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz;
        s4d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] * dfzd);
        x6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a3;
        x6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a3 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RVY4] * a3d;
        t42 = 1.0 + x6 * x6;
        t42d = x6d * x6 + x6 * x6d;
        t43 = sqrt(t42);
        t43d = 1.0 / (2.0 * t43) * t42d;
        t44 = 1.0 / t43;
        t44d = -(t44 * t43d * (1.0 / t43));
        dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2) * t44;
        dvd = ((muy2d * fz2 + muy2 * fz2d) * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2) + muy2 * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2d))) * t44 + muy2 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2) *
            t44d;
        y11 = stiff3 * (kappa2 + s4);
        y11d = stiff3d * (kappa2 + s4) + stiff3 * (kappa2d + s4d);
        y12 = stiff3 * s4;
        y12d = stiff3d * s4 + stiff3 * s4d;
        t45 = atan(y11);
        t45d = 1.0 / (1.0 + y11 * y11) * y11d;
        t46 = (1.0 - e8) * y11 + e8 * t45;
        t46d = -(e8d * y11) + (1.0 - e8) * y11d + (e8d * t45 + e8 * t45d);
        t47 = atan(t46);
        t47d = 1.0 / (1.0 + t46 * t46) * t46d;
        p7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        p7d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        t48 = p7 * t47;
        t48d = p7d * t47 + p7 * t47d;
        t49 = cos(t48);
        t49d = -(sin(t48) * t48d);
        t50 = atan(y12);
        t50d = 1.0 / (1.0 + y12 * y12) * y12d;
        t51 = (1.0 - e8) * y12 + e8 * t50;
        t51d = -(e8d * y12) + (1.0 - e8) * y12d + (e8d * t50 + e8 * t50d);
        t52 = atan(t51);
        t52d = 1.0 / (1.0 + t51 * t51) * t51d;
        t53 = p7 * t52;
        t53d = p7d * t52 + p7 * t52d;
        t54 = cos(t53);
        t54d = -(sin(t53) * t53d);
        g30 = t49 / t54;
        g30d = (t49d - g30 * t54d) * (1.0 / t54);
        t55 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2;
        t55d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2d;
        t56 = atan(t55);
        t56d = 1.0 / (1.0 + t55 * t55) * t55d;
        t57 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56;
        t57d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56d;
        t58 = sin(t57);
        t58d = cos(t57) * t57d;
        g31 = dv * t58 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        g31d = (dvd * t58 + dv * t58d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] + dv *
            t58 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        x7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2;
        x7d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2d;
        t59 = 1.0 + x7 * x7;
        t59d = x7d * x7 + x7 * x7d;
        t60 = sqrt(t59);
        t60d = 1.0 / (2.0 * t60) * t59d;
        t61 = 1.0 / t60;
        t61d = -(t61 * t60d * (1.0 / t60));
        stiff4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        stiff4d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61d) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        e11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz;
        e11d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] * dfzd);
        if (MAGGI_RE(e11) > 1.0) {
          y13 = 1.0;
          y13d = 0.0;
        } else {
          y13 = e11;
          y13d = e11d;
        }
        e10 = y13;
        e10d = y13d;
        p8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        p8d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        y14 = stiff4 * (a3 + p8);
        y14d = stiff4d * (a3 + p8) + stiff4 * (a3d + p8d);
        y15 = stiff4 * p8;
        y15d = stiff4d * p8 + stiff4 * p8d;
        t62 = atan(y14);
        t62d = 1.0 / (1.0 + y14 * y14) * y14d;
        t63 = (1.0 - e10) * y14 + e10 * t62;
        t63d = -(e10d * y14) + (1.0 - e10) * y14d + (e10d * t62 + e10 * t62d);
        t64 = atan(t63);
        t64d = 1.0 / (1.0 + t63 * t63) * t63d;
        p9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        p9d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        t65 = p9 * t64;
        t65d = p9d * t64 + p9 * t64d;
        t66 = cos(t65);
        t66d = -(sin(t65) * t65d);
        t67 = atan(y15);
        t67d = 1.0 / (1.0 + y15 * y15) * y15d;
        t68 = (1.0 - e10) * y15 + e10 * t67;
        t68d = -(e10d * y15) + (1.0 - e10) * y15d + (e10d * t67 + e10 * t67d);
        t69 = atan(t68);
        t69d = 1.0 / (1.0 + t68 * t68) * t68d;
        t70 = p9 * t69;
        t70d = p9d * t69 + p9 * t69d;
        t71 = cos(t70);
        t71d = -(sin(t70) * t70d);
        t72 = t66 / t71;
        t72d = (t66d - t72 * t71d) * (1.0 / t71);
        fx = x40 * t72;
        fxd = x40d * t72 + x40 * t72d;
        fy = g30 * y20 + g31;
        fyd = g30d * y20 + g30 * y20d + g31d;
        ratio2 = x41 * kappa2 / y21;
        ratio2d = (x41d * kappa2 + x41 * kappa2d - ratio2 * y21d) * (1.0 / y21);
        bycy = y23;
        bycyd = y23d;
        shift = y24;
        shiftd = y24d;
        fz0_4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        fz0_4d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        gz = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        gzd = gamma2d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] + gamma2 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        at = a3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QHZ2] * dfz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gz;
        atd = a3d + pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QHZ2] * dfzd) + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QHZ4] * dfzd)) * gz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gzd);
        ar = a3 + shift;
        ard = a3d + shiftd;
        t73 = at * at + ratio2 * ratio2 + 1e-24;
        t73d = atd * at + at * atd + (ratio2d * ratio2 + ratio2 * ratio2d);
        ateq = sqrt(t73);
        ateqd = 1.0 / (2.0 * ateq) * t73d;
        t74 = ar * ar + ratio2 * ratio2 + 1e-24;
        t74d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
        areq = sqrt(t74);
        areqd = 1.0 / (2.0 * areq) * t74d;
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y16 = gz;
          y16d = gzd;
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y16 = -gz;
          y16d = -gzd;
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p10d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t75 = p10 * p10;
          t75d = p10d * p10 + p10 * p10d;
          z6 = gz * gz / t75;
          z6d = (gzd * gz + gz * gzd - z6 * t75d) * (1.0 / t75);
          y16 = 0.125 * p10 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
          y16d = (0.125 * p10d * z6 + 0.125 * p10 * z6d) * (15.0 + z6 * (-10.0 + 3.0 * z6)) + 0.125
              * p10 * z6 * (z6d * (-10.0 + 3.0 * z6) + z6 * (3.0 * z6d));
        }
        bt = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        btd = (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfzd)) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ5] * y16) + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz * dfz) * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gzd +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ5] * y16d))) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16) * pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LKY] - bt * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]);
        t76 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
        t76d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - t76 * fz0_4d) * (1.0
            / fz0_4);
        dt = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        dtd = (((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfzd))) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) + fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gzd +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ4] * gzd) * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz *
            gzd))) * t76 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz * gz) * t76d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] +
            fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        t77 = bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * at;
        t77d = (btd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + bt *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1]) * at + bt *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * atd;
        t78 = atan(t77);
        t78d = 1.0 / (1.0 + t77 * t77) * t77d;
        e12 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfz) *
            (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78);
        e12d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfzd)) * (1.0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78) + (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfz) *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gzd)) *
            0.63661977236758134308 * t78 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78d);
        if (MAGGI_RE(e12) > 1.0) {
          y17 = 1.0;
          y17d = 0.0;
        } else {
          y17 = e12;
          y17d = e12d;
        }
        et = y17;
        etd = y17d;
        p11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        p11d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t79 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY] / p11;
        t79d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] - t79 * p11d) * (1.0 / p11);
        br = t79 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycy;
        brd = t79d + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycyd);
        dr = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] * p11;
        drd = ((fz2d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) + fz2 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gzd))) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_UNLOADED_RADIUS] + fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS]) * p11 + fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_UNLOADED_RADIUS] * p11d;
        t80 = 1.0 + a3 * a3;
        t80d = a3d * a3 + a3 * a3d;
        t81 = sqrt(t80);
        t81d = 1.0 / (2.0 * t81) * t80d;
        ca = 1.0 / t81;
        cad = -(ca * t81d * (1.0 / t81));
        y18 = bt * ateq;
        y18d = btd * ateq + bt * ateqd;
        t82 = atan(y18);
        t82d = 1.0 / (1.0 + y18 * y18) * y18d;
        t83 = (1.0 - et) * y18 + et * t82;
        t83d = -(etd * y18) + (1.0 - et) * y18d + (etd * t82 + et * t82d);
        t84 = atan(t83);
        t84d = 1.0 / (1.0 + t83 * t83) * t83d;
        t85 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84;
        t85d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84d;
        t86 = cos(t85);
        t86d = -(sin(t85) * t85d);
        z30 = dt * t86 * ca;
        z30d = (dtd * t86 + dt * t86d) * ca + dt * t86 * cad;
        x8 = br * areq;
        x8d = brd * areq + br * areqd;
        t87 = 1.0 + x8 * x8;
        t87d = x8d * x8 + x8 * x8d;
        t88 = sqrt(t87);
        t88d = 1.0 / (2.0 * t88) * t87d;
        t89 = 1.0 / t88;
        t89d = -(t89 * t88d * (1.0 / t88));
        z31 = dr * t89 * ca;
        z31d = (drd * t89 + dr * t89d) * ca + dr * t89 * cad;
        t90 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
        t90d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fyd - t90 * fz0_2d) * (1.0 / fz0_2);
        s3 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        s3d = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90d +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfzd)) *
            gamma2 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2d)) * r0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) *
            r0d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        t91 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        t91d = (one4d - t91 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]);
        way = tanh(t91);
        wayd = (1.0 - way * way) * t91d;
        speed3 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        speed3d = (one4d - speed3 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]);
        force20 = fx;
        force20d = fxd;
        force21 = fy;
        force21d = fyd;
        force22 = fz2;
        force22d = fz2d;
        t92 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
        t92d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fyd - t92 * fz0_2d) * (1.0 / fz0_2);
        force23 = r0 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]);
        force23d = (r0d * fz2 + r0 * fz2d) * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]) + r0
            * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX1] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] +
            ((-(pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma2) -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma2d + t92d) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]));
        t93 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
        t93d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fxd - t93 * fz0_2d) * (1.0 / fz0_2);
        force24 = -way * r0 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        force24d = (((-(wayd * r0) - way * r0d) * fz2 + -way * r0 * fz2d) *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way * speed3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed3 * speed3 * speed3 * speed3) + -way * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSY1] + t93d + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3d) +
            ((((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3d)))
            * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] + -way * r0 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way * speed3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed3 * speed3 * speed3 * speed3) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        force25 = -z30 * (fy - g31) + z31 + s3 * fx;
        force25d = -(z30d * (fy - g31)) - z30 * (fyd - g31d) + z31d + (s3d * fx + s3 * fxd);
        rolling0 = force20;
        rolling0d = force20d;
        rolling1 = side * force21;
        rolling1d = side * force21d;
        rolling2 = force22;
        rolling2d = force22d;
        rolling3 = side * force23;
        rolling3d = side * force23d;
        rolling4 = force24;
        rolling4d = force24d;
        rolling5 = side * force25;
        rolling5d = side * force25d;
      } else {
        rolling0 = 0.0;
        rolling0d = 0.0;
        rolling1 = 0.0;
        rolling1d = 0.0;
        rolling2 = fz;
        rolling2d = fzd;
        rolling3 = 0.0;
        rolling3d = 0.0;
        rolling4 = 0.0;
        rolling4d = 0.0;
        rolling5 = 0.0;
        rolling5d = 0.0;
      }
    } else {
      rolling0 = 0.0;
      rolling0d = 0.0;
      rolling1 = 0.0;
      rolling1d = 0.0;
      rolling2 = 0.0;
      rolling2d = 0.0;
      rolling3 = 0.0;
      rolling3d = 0.0;
      rolling4 = 0.0;
      rolling4d = 0.0;
      rolling5 = 0.0;
      rolling5d = 0.0;
    }
    r30 = r[t->wheelpoint[i]][0] + arm0;
    r30d = rd[t->wheelpoint[i]][0] + arm0d;
    force30 = rolling0 * T0 + rolling1 * L0 + rolling2 * N0;
    force30d = rolling0d * T0 + rolling0 * T0d + (rolling1d * L0 + rolling1 * L0d) + (rolling2d * N0
        + rolling2 * N0d);
    r31 = r[t->wheelpoint[i]][1] + arm1;
    r31d = rd[t->wheelpoint[i]][1] + arm1d;
    force31 = rolling0 * T1 + rolling1 * L1 + rolling2 * N1;
    force31d = rolling0d * T1 + rolling0 * T1d + (rolling1d * L1 + rolling1 * L1d) + rolling2d * N1;
    r32 = r[t->wheelpoint[i]][2] + arm2;
    r32d = rd[t->wheelpoint[i]][2] + arm2d;
    force32 = rolling0 * T2 + rolling1 * L2 + rolling2 * N2;
    force32d = rolling0d * T2 + rolling0 * T2d + (rolling1d * L2 + rolling1 * L2d) + (rolling2d * N2
        + rolling2 * N2d);
    moment2b = Qb[a6][5];
    moment2bd = Qbd[a6][5];
    moment1b = Qb[a6][4];
    moment1bd = Qbd[a6][4];
    moment0b = Qb[a6][3];
    moment0bd = Qbd[a6][3];
    tb170 = Qb[a6][5];
    tb170d = Qbd[a6][5];
    r30b = tb170 * force31;
    r30bd = tb170d * force31 + tb170 * force31d;
    force31b = tb170 * r30;
    force31bd = tb170d * r30 + tb170 * r30d;
    r31b = -(tb170 * force30);
    r31bd = -(tb170d * force30 + tb170 * force30d);
    force30b = -(tb170 * r31);
    force30bd = -(tb170d * r31 + tb170 * r31d);
    tb169 = Qb[a6][4];
    tb169d = Qbd[a6][4];
    r32b = tb169 * force30;
    r32bd = tb169d * force30 + tb169 * force30d;
    force30b += tb169 * r32;
    force30bd += tb169d * r32 + tb169 * r32d;
    r30b -= tb169 * force32;
    r30bd -= tb169d * force32 + tb169 * force32d;
    force32b = -(tb169 * r30);
    force32bd = -(tb169d * r30 + tb169 * r30d);
    tb168 = Qb[a6][3];
    tb168d = Qbd[a6][3];
    r31b += tb168 * force32;
    r31bd += tb168d * force32 + tb168 * force32d;
    force32b += tb168 * r31;
    force32bd += tb168d * r31 + tb168 * r31d;
    r32b -= tb168 * force31;
    r32bd -= tb168d * force31 + tb168 * force31d;
    force31b -= tb168 * r32;
    force31bd -= tb168d * r32 + tb168 * r32d;
    force32b += Qb[a6][2];
    force32bd += Qbd[a6][2];
    force31b += Qb[a6][1];
    force31bd += Qbd[a6][1];
    force30b += Qb[a6][0];
    force30bd += Qbd[a6][0];
    rolling3b = moment2b * T2;
    rolling3bd = moment2bd * T2 + moment2b * T2d;
    T2b = moment2b * rolling3;
    T2bd = moment2bd * rolling3 + moment2b * rolling3d;
    rolling4b = moment2b * L2;
    rolling4bd = moment2bd * L2 + moment2b * L2d;
    L2b = moment2b * rolling4;
    L2bd = moment2bd * rolling4 + moment2b * rolling4d;
    rolling5b = moment2b * N2;
    rolling5bd = moment2bd * N2 + moment2b * N2d;
    N2b = moment2b * rolling5;
    N2bd = moment2bd * rolling5 + moment2b * rolling5d;
    rolling0b = force32b * T2;
    rolling0bd = force32bd * T2 + force32b * T2d;
    T2b += force32b * rolling0;
    T2bd += force32bd * rolling0 + force32b * rolling0d;
    rolling1b = force32b * L2;
    rolling1bd = force32bd * L2 + force32b * L2d;
    L2b += force32b * rolling1;
    L2bd += force32bd * rolling1 + force32b * rolling1d;
    rolling2b = force32b * N2;
    rolling2bd = force32bd * N2 + force32b * N2d;
    N2b += force32b * rolling2;
    N2bd += force32bd * rolling2 + force32b * rolling2d;
    rb[t->wheelpoint[i]][2] += r32b;
    rbd[t->wheelpoint[i]][2] += r32bd;
    arm2b = r32b;
    arm2bd = r32bd;
    rolling3b += moment1b * T1;
    rolling3bd += moment1bd * T1 + moment1b * T1d;
    T1b = moment1b * rolling3;
    T1bd = moment1bd * rolling3 + moment1b * rolling3d;
    rolling4b += moment1b * L1;
    rolling4bd += moment1bd * L1 + moment1b * L1d;
    L1b = moment1b * rolling4;
    L1bd = moment1bd * rolling4 + moment1b * rolling4d;
    rolling5b += moment1b * N1;
    rolling5bd += moment1bd * N1;
    rolling0b += force31b * T1;
    rolling0bd += force31bd * T1 + force31b * T1d;
    T1b += force31b * rolling0;
    T1bd += force31bd * rolling0 + force31b * rolling0d;
    rolling1b += force31b * L1;
    rolling1bd += force31bd * L1 + force31b * L1d;
    L1b += force31b * rolling1;
    L1bd += force31bd * rolling1 + force31b * rolling1d;
    rolling2b += force31b * N1;
    rolling2bd += force31bd * N1;
    rb[t->wheelpoint[i]][1] += r31b;
    rbd[t->wheelpoint[i]][1] += r31bd;
    arm1b = r31b;
    arm1bd = r31bd;
    rolling3b += moment0b * T0;
    rolling3bd += moment0bd * T0 + moment0b * T0d;
    T0b = moment0b * rolling3;
    T0bd = moment0bd * rolling3 + moment0b * rolling3d;
    rolling4b += moment0b * L0;
    rolling4bd += moment0bd * L0 + moment0b * L0d;
    L0b = moment0b * rolling4;
    L0bd = moment0bd * rolling4 + moment0b * rolling4d;
    rolling5b += moment0b * N0;
    rolling5bd += moment0bd * N0 + moment0b * N0d;
    N0b = moment0b * rolling5;
    N0bd = moment0bd * rolling5 + moment0b * rolling5d;
    rolling0b += force30b * T0;
    rolling0bd += force30bd * T0 + force30b * T0d;
    T0b += force30b * rolling0;
    T0bd += force30bd * rolling0 + force30b * rolling0d;
    rolling1b += force30b * L0;
    rolling1bd += force30bd * L0 + force30b * L0d;
    L0b += force30b * rolling1;
    L0bd += force30bd * rolling1 + force30b * rolling1d;
    rolling2b += force30b * N0;
    rolling2bd += force30bd * N0 + force30b * N0d;
    N0b += force30b * rolling2;
    N0bd += force30bd * rolling2 + force30b * rolling2d;
    rb[t->wheelpoint[i]][0] += r30b;
    /* at the contact point on the wheel:  f_x T + f_y L + f_z N;  power of all of it, springs of tyres too */
    rbd[t->wheelpoint[i]][0] += r30bd;
    arm0b = r30b;
    arm0bd = r30bd;
    a2b = 0.0;
    a2bd = 0.0;
    fzb = 0.0;
    fzbd = 0.0;
    gammab = 0.0;
    gammabd = 0.0;
    kappab = 0.0;
    kappabd = 0.0;
    vxb = 0.0;
    vxbd = 0.0;
    if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z20) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] +
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
      if (t->wheelgrip[i]) {
        kappa2 = one0;
        kappa2d = one0d;
        a3 = one1;
        a3d = one1d;
        gamma2 = one2;
        gamma2d = one2d;
        fz2 = one3;
        fz2d = one3d;
        fz0_2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        fz0_2d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        r0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        r0d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        dfz = (fz2 - fz0_2) / fz0_2;
        dfzd = (fz2d - fz0_2d - dfz * fz0_2d) * (1.0 / fz0_2);
        kx = kappa2 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LHX];
        kxd = kappa2d + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHX2] * dfzd)) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX2] * dfz) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX]);
        gx = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        gxd = gamma2d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] + gamma2 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        cx = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        cxd = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX];
        mux = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx *
            gx) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        muxd = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfzd)) *
            (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) -
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gxd) * gx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gxd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        dx = mux * fz2;
        dxd = muxd * fz2 + mux * fz2d;
        e2 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        e2d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        if (MAGGI_RE(kx) > 0.0) {
          e3 = e2 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e3d = e2d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) - e2 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          if (MAGGI_RE(e3) > 1.0) {
            y3 = 1.0;
            y3d = 0.0;
          } else {
            y3 = e3;
            y3d = e3d;
          }
          ex = y3;
          exd = y3d;
        } else {
          e4 = e2 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e4d = e2d * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) + e2 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          if (MAGGI_RE(e4) > 1.0) {
            y4 = 1.0;
            y4d = 0.0;
          } else {
            y4 = e4;
            y4d = e4d;
          }
          ex = y4;
          exd = y4d;
        }
        t20 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz;
        t20d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfzd;
        t21 = exp(t20);
        t21d = t21 * t20d;
        stiff = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        stiffd = ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t21 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21d) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        t22 = cx * dx;
        t22d = cxd * dx + cx * dxd;
        bx = stiff / t22;
        bxd = (stiffd - bx * t22d) * (1.0 / t22);
        svx = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        svxd = ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd))) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LMUX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        y5 = bx * kx;
        y5d = bxd * kx + bx * kxd;
        t23 = atan(y5);
        t23d = 1.0 / (1.0 + y5 * y5) * y5d;
        t24 = (1.0 - ex) * y5 + ex * t23;
        t24d = -(exd * y5) + (1.0 - ex) * y5d + (exd * t23 + ex * t23d);
        t25 = atan(t24);
        t25d = 1.0 / (1.0 + t24 * t24) * t24d;
        t26 = cx * t25;
        t26d = cxd * t25 + cx * t25d;
        t27 = sin(t26);
        t27d = cos(t26) * t26d;
        x40 = dx * t27 + svx;
        x40d = dxd * t27 + dx * t27d + svxd;
        x41 = stiff;
        x41d = stiffd;
        fz0_3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        fz0_3d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        gy = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        gyd = gamma2d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] + gamma2 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        shy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gy;
        shyd = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY3] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gyd);
        ay = a3 + shy;
        ayd = a3d + shyd;
        cy = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        cyd = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY];
        muy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy *
            gy) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        muyd = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfzd)) *
            (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) -
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gyd) * gy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gyd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        dy = muy * fz2;
        dyd = muyd * fz2 + muy * fz2d;
        e5 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        e5d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        if (MAGGI_RE(ay) > 0.0) {
          e6 = e5 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e6d = e5d * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) - e5 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          if (MAGGI_RE(e6) > 1.0) {
            y6 = 1.0;
            y6d = 0.0;
          } else {
            y6 = e6;
            y6d = e6d;
          }
          ey = y6;
          eyd = y6d;
        } else {
          e7 = e5 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e7d = e5d * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) + e5 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          if (MAGGI_RE(e7) > 1.0) {
            y7 = 1.0;
            y7d = 0.0;
          } else {
            y7 = e7;
            y7d = e7d;
          }
          ey = y7;
          eyd = y7d;
        }
        t28 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3;
        t28d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3d;
        z4 = fz2 / t28;
        z4d = (fz2d - z4 * t28d) * (1.0 / t28);
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y8 = gy;
          y8d = gyd;
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y8 = -gy;
          y8d = -gyd;
        } else {
          p6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t29 = p6 * p6;
          t29d = p6d * p6 + p6 * p6d;
          z5 = gy * gy / t29;
          z5d = (gyd * gy + gy * gyd - z5 * t29d) * (1.0 / t29);
          y8 = 0.125 * p6 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
          y8d = (0.125 * p6d * z5 + 0.125 * p6 * z5d) * (15.0 + z5 * (-10.0 + 3.0 * z5)) + 0.125 *
              p6 * z5 * (z5d * (-10.0 + 3.0 * z5) + z5 * (3.0 * z5d));
        }
        t30 = 1.0 + z4 * z4;
        t30d = z4d * z4 + z4 * z4d;
        t31 = 2.0 * z4 / t30;
        t31d = (2.0 * z4d - t31 * t30d) * (1.0 / t30);
        stiff2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY];
        stiff2d = (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d) * t31 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) - p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t31 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8d)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]
            * y8) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        t32 = cy * dy;
        t32d = cyd * dy + cy * dyd;
        by = stiff2 / t32;
        byd = (stiff2d - by * t32d) * (1.0 / t32);
        svy = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        svyd = (fz2d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) + fz2 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfzd)) * gy +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gyd))) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] +
            fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gy) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        y9 = by * ay;
        y9d = byd * ay + by * ayd;
        t33 = atan(y9);
        t33d = 1.0 / (1.0 + y9 * y9) * y9d;
        t34 = (1.0 - ey) * y9 + ey * t33;
        t34d = -(eyd * y9) + (1.0 - ey) * y9d + (eyd * t33 + ey * t33d);
        t35 = atan(t34);
        t35d = 1.0 / (1.0 + t34 * t34) * t34d;
        t36 = cy * t35;
        t36d = cyd * t35 + cy * t35d;
        t37 = sin(t36);
        t37d = cos(t36) * t36d;
        y20 = dy * t37 + svy;
        y20d = dyd * t37 + dy * t37d + svyd;
        y21 = stiff2;
        y21d = stiff2d;
        y22 = muy;
        y22d = muyd;
        y23 = by * cy;
        y23d = byd * cy + by * cyd;
        t38 = svy / stiff2;
        t38d = (svyd - t38 * stiff2d) * (1.0 / stiff2);
        y24 = shy + t38;
        y24d = shyd + t38d;
        muy2 = y22;
        muy2d = y22d;
        x5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a3 - p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBY3]);
        x5d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a3 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RBY2] * (a3d - pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]);
        t39 = 1.0 + x5 * x5;
        t39d = x5d * x5 + x5 * x5d;
        t40 = sqrt(t39);
        t40d = 1.0 / (2.0 * t40) * t39d;
        t41 = 1.0 / t40;
        t41d = -(t41 * t40d * (1.0 / t40));
        stiff3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        stiff3d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41d) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        e9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz;
        e9d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] * dfzd);
        if (MAGGI_RE(e9) > 1.0) {
          y10 = 1.0;
          y10d = 0.0;
        } else {
          y10 = e9;
          y10d = e9d;
        }
        e8 = y10;
        e8d = y10d;
        s4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz;
        s4d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] * dfzd);
        x6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a3;
        x6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a3 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RVY4] * a3d;
        t42 = 1.0 + x6 * x6;
        t42d = x6d * x6 + x6 * x6d;
        t43 = sqrt(t42);
        t43d = 1.0 / (2.0 * t43) * t42d;
        t44 = 1.0 / t43;
        t44d = -(t44 * t43d * (1.0 / t43));
        dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2) * t44;
        dvd = ((muy2d * fz2 + muy2 * fz2d) * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2) + muy2 * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2d))) * t44 + muy2 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2) *
            t44d;
        y11 = stiff3 * (kappa2 + s4);
        y11d = stiff3d * (kappa2 + s4) + stiff3 * (kappa2d + s4d);
        y12 = stiff3 * s4;
        y12d = stiff3d * s4 + stiff3 * s4d;
        t45 = atan(y11);
        t45d = 1.0 / (1.0 + y11 * y11) * y11d;
        t46 = (1.0 - e8) * y11 + e8 * t45;
        t46d = -(e8d * y11) + (1.0 - e8) * y11d + (e8d * t45 + e8 * t45d);
        t47 = atan(t46);
        t47d = 1.0 / (1.0 + t46 * t46) * t46d;
        p7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        p7d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        t48 = p7 * t47;
        t48d = p7d * t47 + p7 * t47d;
        t49 = cos(t48);
        t49d = -(sin(t48) * t48d);
        t50 = atan(y12);
        t50d = 1.0 / (1.0 + y12 * y12) * y12d;
        t51 = (1.0 - e8) * y12 + e8 * t50;
        t51d = -(e8d * y12) + (1.0 - e8) * y12d + (e8d * t50 + e8 * t50d);
        t52 = atan(t51);
        t52d = 1.0 / (1.0 + t51 * t51) * t51d;
        t53 = p7 * t52;
        t53d = p7d * t52 + p7 * t52d;
        t54 = cos(t53);
        t54d = -(sin(t53) * t53d);
        g30 = t49 / t54;
        g30d = (t49d - g30 * t54d) * (1.0 / t54);
        t55 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2;
        t55d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2d;
        t56 = atan(t55);
        t56d = 1.0 / (1.0 + t55 * t55) * t55d;
        t57 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56;
        t57d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56d;
        t58 = sin(t57);
        t58d = cos(t57) * t57d;
        g31 = dv * t58 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        g31d = (dvd * t58 + dv * t58d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] + dv *
            t58 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        x7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2;
        x7d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2d;
        t59 = 1.0 + x7 * x7;
        t59d = x7d * x7 + x7 * x7d;
        t60 = sqrt(t59);
        t60d = 1.0 / (2.0 * t60) * t59d;
        t61 = 1.0 / t60;
        t61d = -(t61 * t60d * (1.0 / t60));
        stiff4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        stiff4d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61d) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        e11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz;
        e11d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] * dfzd);
        if (MAGGI_RE(e11) > 1.0) {
          y13 = 1.0;
          y13d = 0.0;
        } else {
          y13 = e11;
          y13d = e11d;
        }
        e10 = y13;
        e10d = y13d;
        p8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        p8d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        y14 = stiff4 * (a3 + p8);
        y14d = stiff4d * (a3 + p8) + stiff4 * (a3d + p8d);
        y15 = stiff4 * p8;
        y15d = stiff4d * p8 + stiff4 * p8d;
        t62 = atan(y14);
        t62d = 1.0 / (1.0 + y14 * y14) * y14d;
        t63 = (1.0 - e10) * y14 + e10 * t62;
        t63d = -(e10d * y14) + (1.0 - e10) * y14d + (e10d * t62 + e10 * t62d);
        t64 = atan(t63);
        t64d = 1.0 / (1.0 + t63 * t63) * t63d;
        p9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        p9d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        t65 = p9 * t64;
        t65d = p9d * t64 + p9 * t64d;
        t66 = cos(t65);
        t66d = -(sin(t65) * t65d);
        t67 = atan(y15);
        t67d = 1.0 / (1.0 + y15 * y15) * y15d;
        t68 = (1.0 - e10) * y15 + e10 * t67;
        t68d = -(e10d * y15) + (1.0 - e10) * y15d + (e10d * t67 + e10 * t67d);
        t69 = atan(t68);
        t69d = 1.0 / (1.0 + t68 * t68) * t68d;
        t70 = p9 * t69;
        t70d = p9d * t69 + p9 * t69d;
        t71 = cos(t70);
        t71d = -(sin(t70) * t70d);
        t72 = t66 / t71;
        t72d = (t66d - t72 * t71d) * (1.0 / t71);
        fx = x40 * t72;
        fxd = x40d * t72 + x40 * t72d;
        fy = g30 * y20 + g31;
        fyd = g30d * y20 + g30 * y20d + g31d;
        ratio2 = x41 * kappa2 / y21;
        ratio2d = (x41d * kappa2 + x41 * kappa2d - ratio2 * y21d) * (1.0 / y21);
        bycy = y23;
        bycyd = y23d;
        shift = y24;
        shiftd = y24d;
        fz0_4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        fz0_4d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        gz = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        gzd = gamma2d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] + gamma2 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        at = a3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QHZ2] * dfz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gz;
        atd = a3d + pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QHZ2] * dfzd) + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QHZ4] * dfzd)) * gz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gzd);
        ar = a3 + shift;
        ard = a3d + shiftd;
        t73 = at * at + ratio2 * ratio2 + 1e-24;
        t73d = atd * at + at * atd + (ratio2d * ratio2 + ratio2 * ratio2d);
        ateq = sqrt(t73);
        ateqd = 1.0 / (2.0 * ateq) * t73d;
        t74 = ar * ar + ratio2 * ratio2 + 1e-24;
        t74d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
        areq = sqrt(t74);
        areqd = 1.0 / (2.0 * areq) * t74d;
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y16 = gz;
          y16d = gzd;
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y16 = -gz;
          y16d = -gzd;
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p10d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t75 = p10 * p10;
          t75d = p10d * p10 + p10 * p10d;
          z6 = gz * gz / t75;
          z6d = (gzd * gz + gz * gzd - z6 * t75d) * (1.0 / t75);
          y16 = 0.125 * p10 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
          y16d = (0.125 * p10d * z6 + 0.125 * p10 * z6d) * (15.0 + z6 * (-10.0 + 3.0 * z6)) + 0.125
              * p10 * z6 * (z6d * (-10.0 + 3.0 * z6) + z6 * (3.0 * z6d));
        }
        bt = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        btd = (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfzd)) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ5] * y16) + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz * dfz) * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gzd +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ5] * y16d))) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16) * pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LKY] - bt * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]);
        t76 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
        t76d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - t76 * fz0_4d) * (1.0
            / fz0_4);
        dt = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        dtd = (((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfzd))) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) + fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gzd +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ4] * gzd) * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz *
            gzd))) * t76 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz * gz) * t76d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] +
            fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        t77 = bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * at;
        t77d = (btd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + bt *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1]) * at + bt *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * atd;
        t78 = atan(t77);
        t78d = 1.0 / (1.0 + t77 * t77) * t77d;
        e12 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfz) *
            (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78);
        e12d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfzd)) * (1.0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78) + (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfz) *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gzd)) *
            0.63661977236758134308 * t78 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78d);
        if (MAGGI_RE(e12) > 1.0) {
          y17 = 1.0;
          y17d = 0.0;
        } else {
          y17 = e12;
          y17d = e12d;
        }
        et = y17;
        etd = y17d;
        p11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        p11d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t79 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY] / p11;
        t79d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] - t79 * p11d) * (1.0 / p11);
        br = t79 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycy;
        brd = t79d + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycyd);
        dr = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] * p11;
        drd = ((fz2d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) + fz2 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gzd))) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_UNLOADED_RADIUS] + fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS]) * p11 + fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_UNLOADED_RADIUS] * p11d;
        t80 = 1.0 + a3 * a3;
        t80d = a3d * a3 + a3 * a3d;
        t81 = sqrt(t80);
        t81d = 1.0 / (2.0 * t81) * t80d;
        ca = 1.0 / t81;
        cad = -(ca * t81d * (1.0 / t81));
        y18 = bt * ateq;
        y18d = btd * ateq + bt * ateqd;
        t82 = atan(y18);
        t82d = 1.0 / (1.0 + y18 * y18) * y18d;
        t83 = (1.0 - et) * y18 + et * t82;
        t83d = -(etd * y18) + (1.0 - et) * y18d + (etd * t82 + et * t82d);
        t84 = atan(t83);
        t84d = 1.0 / (1.0 + t83 * t83) * t83d;
        t85 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84;
        t85d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84d;
        t86 = cos(t85);
        t86d = -(sin(t85) * t85d);
        z30 = dt * t86 * ca;
        z30d = (dtd * t86 + dt * t86d) * ca + dt * t86 * cad;
        x8 = br * areq;
        x8d = brd * areq + br * areqd;
        t87 = 1.0 + x8 * x8;
        t87d = x8d * x8 + x8 * x8d;
        t88 = sqrt(t87);
        t88d = 1.0 / (2.0 * t88) * t87d;
        t89 = 1.0 / t88;
        t89d = -(t89 * t88d * (1.0 / t88));
        t90 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
        t90d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fyd - t90 * fz0_2d) * (1.0 / fz0_2);
        s3 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        s3d = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90d +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfzd)) *
            gamma2 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2d)) * r0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) *
            r0d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        t91 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        t91d = (one4d - t91 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]);
        way = tanh(t91);
        wayd = (1.0 - way * way) * t91d;
        speed3 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        speed3d = (one4d - speed3 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]);
        t92 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
        t92d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fyd - t92 * fz0_2d) * (1.0 / fz0_2);
        t93 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
        t93d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fxd - t93 * fz0_2d) * (1.0 / fz0_2);
        force25b = rolling5b * side;
        force25bd = rolling5bd * side;
        rolling5b = 0.0;
        rolling5bd = 0.0;
        force24b = rolling4b;
        force24bd = rolling4bd;
        rolling4b = 0.0;
        rolling4bd = 0.0;
        force23b = rolling3b * side;
        force23bd = rolling3bd * side;
        rolling3b = 0.0;
        rolling3bd = 0.0;
        force22b = rolling2b;
        force22bd = rolling2bd;
        rolling2b = 0.0;
        rolling2bd = 0.0;
        force21b = rolling1b * side;
        force21bd = rolling1bd * side;
        rolling1b = 0.0;
        rolling1bd = 0.0;
        force20b = rolling0b;
        force20bd = rolling0bd;
        rolling0b = 0.0;
        rolling0bd = 0.0;
        z30b = -(force25b * (fy - g31));
        z30bd = -(force25bd * (fy - g31) + force25b * (fyd - g31d));
        tb167 = force25b * z30;
        tb167d = force25bd * z30 + force25b * z30d;
        fyb = -tb167;
        fybd = -tb167d;
        g31b = tb167;
        g31bd = tb167d;
        z31b = force25b;
        z31bd = force25bd;
        s3b = force25b * fx;
        s3bd = force25bd * fx + force25b * fxd;
        fxb = force25b * s3;
        fxbd = force25bd * s3 + force25b * s3d;
        tb159 = force24b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        tb159d = force24bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] + force24b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        tb160 = tb159 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3);
        tb160d = tb159d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3) +
            tb159 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93d +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3d) +
            ((((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3d));
        tb161 = tb160 * fz2;
        tb161d = tb160d * fz2 + tb160 * fz2d;
        wayb = -(tb161 * r0);
        waybd = -(tb161d * r0 + tb161 * r0d);
        r0b = -(tb161 * way);
        r0bd = -(tb161d * way + tb161 * wayd);
        fz2b = tb160 * (-way * r0);
        fz2bd = tb160d * (-way * r0) + tb160 * (-(wayd * r0) - way * r0d);
        tb162 = tb159 * (-way * r0 * fz2);
        tb162d = tb159d * (-way * r0 * fz2) + tb159 * ((-(wayd * r0) - way * r0d) * fz2 + -way * r0
            * fz2d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] += tb162;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] += tb162d;
        t93b = tb162;
        t93bd = tb162d;
        tb163 = tb162 * speed3;
        tb163d = tb162d * speed3 + tb162 * speed3d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] += tb163 * way;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] += tb163d * way + tb163 * wayd;
        wayb += tb163 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3];
        waybd += tb163d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] + tb163 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3];
        speed3b = tb162 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way);
        speed3bd = tb162d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way) + tb162 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * wayd);
        tb164 = tb162 * speed3;
        tb164d = tb162d * speed3 + tb162 * speed3d;
        tb165 = tb164 * speed3;
        tb165d = tb164d * speed3 + tb164 * speed3d;
        tb166 = tb165 * speed3;
        tb166d = tb165d * speed3 + tb165 * speed3d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] += tb166 * speed3;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] += tb166d * speed3 + tb166 * speed3d;
        speed3b += tb166 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4];
        speed3bd += tb166d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] + tb166 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4];
        speed3b += tb165 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3);
        speed3bd += tb165d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3) + tb165 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3d);
        speed3b += tb164 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3);
        speed3bd += tb164d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3) +
            tb164 * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3d);
        speed3b += tb162 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 *
            speed3);
        speed3bd += tb162d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 *
            speed3) + tb162 * (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] += force24b * (-way * r0 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way * speed3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed3 * speed3 * speed3 * speed3));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] += force24bd * (-way * r0 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way * speed3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed3 * speed3 * speed3 * speed3)) + force24b * (((-(wayd * r0) - way * r0d) * fz2 +
            -way * r0 * fz2d) * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3) +
            -way * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93d +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3d) +
            ((((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
            speed3d)));
        tb158 = t93b / fz0_2;
        tb158d = (t93bd - tb158 * fz0_2d) * (1.0 / fz0_2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] += tb158 * fx;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] += tb158d * fx + tb158 * fxd;
        fxb += tb158 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2];
        fxbd += tb158d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] + tb158 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2];
        fz0_2b = -(tb158 * t93);
        fz0_2bd = -(tb158d * t93 + tb158 * t93d);
        tb155 = force23b * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]);
        tb155d = force23bd * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]) +
            force23b * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX1] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] +
            ((-(pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma2) -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma2d + t92d) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]));
        r0b += tb155 * fz2;
        r0bd += tb155d * fz2 + tb155 * fz2d;
        fz2b += tb155 * r0;
        fz2bd += tb155d * r0 + tb155 * r0d;
        tb156 = force23b * (r0 * fz2);
        tb156d = force23bd * (r0 * fz2) + force23b * (r0d * fz2 + r0 * fz2d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] += tb156 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LVMX];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] += tb156d * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVMX] + tb156 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] += tb156 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX1];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] += tb156d * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSX1] + tb156 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1];
        tb157 = tb156 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX];
        tb157d = tb156d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] + tb156 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] -= tb157 * gamma2;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] -= tb157d * gamma2 + tb157 * gamma2d;
        gamma2b = -(tb157 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2]);
        gamma2bd = -(tb157d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] + tb157 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2]);
        t92b = tb157;
        t92bd = tb157d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] += tb156 * (-p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSX2] * gamma2 + t92);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] += tb156d *
            (-p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma2 + t92) + tb156 *
            (-(pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma2) -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma2d + t92d);
        tb154 = t92b / fz0_2;
        tb154d = (t92bd - tb154 * fz0_2d) * (1.0 / fz0_2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] += tb154 * fy;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] += tb154d * fy + tb154 * fyd;
        fyb += tb154 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3];
        fybd += tb154d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] + tb154 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3];
        fz0_2b -= tb154 * t92;
        fz0_2bd -= tb154d * t92 + tb154 * t92d;
        fz2b += force22b;
        fz2bd += force22bd;
        fyb += force21b;
        fybd += force21bd;
        fxb += force20b;
        fxbd += force20bd;
        tb153 = speed3b / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        tb153d = (speed3bd - tb153 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]);
        one4b += tb153;
        one4bd += tb153d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL] -= tb153 * speed3;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL] -= tb153d * speed3 + tb153 * speed3d;
        t91b = wayb * (1.0 - way * way);
        t91bd = waybd * (1.0 - way * way) - wayb * (wayd * way + way * wayd);
        tb152 = t91b / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        tb152d = (t91bd - tb152 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]);
        one4b += tb152;
        one4bd += tb152d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED] -= tb152 * t91;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED] -= tb152d * t91 + tb152 * t91d;
        tb149 = s3b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        tb149d = s3bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] + s3b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        tb150 = tb149 * r0;
        tb150d = tb149d * r0 + tb149 * r0d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] += tb150;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] += tb150d;
        t90b = tb150;
        t90bd = tb150d;
        tb151 = tb150 * gamma2;
        tb151d = tb150d * gamma2 + tb150 * gamma2d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] += tb151;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] += tb151d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] += tb151 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] += tb151d * dfz + tb151 * dfzd;
        dfzb = tb151 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4];
        dfzbd = tb151d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] + tb151 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4];
        gamma2b += tb150 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz);
        gamma2bd += tb150d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) + tb150 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfzd));
        r0b += tb149 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma2);
        r0bd += tb149d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma2) + tb149 * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ1] + t90d + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_SSZ4] * dfzd)) * gamma2 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2d));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] += s3b * ((p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] += s3bd * ((p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0) + s3b *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90d +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfzd)) *
            gamma2 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2d)) * r0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) *
            r0d);
        tb148 = t90b / fz0_2;
        tb148d = (t90bd - tb148 * fz0_2d) * (1.0 / fz0_2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] += tb148 * fy;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] += tb148d * fy + tb148 * fyd;
        fyb += tb148 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2];
        fybd += tb148d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] + tb148 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2];
        fz0_2b -= tb148 * t90;
        fz0_2bd -= tb148d * t90 + tb148 * t90d;
        tb147 = z31b * ca;
        tb147d = z31bd * ca + z31b * cad;
        drb = tb147 * t89;
        drbd = tb147d * t89 + tb147 * t89d;
        t89b = tb147 * dr;
        t89bd = tb147d * dr + tb147 * drd;
        cab = z31b * (dr * t89);
        cabd = z31bd * (dr * t89) + z31b * (drd * t89 + dr * t89d);
        tb146 = t89b / t88;
        tb146d = (t89bd - tb146 * t88d) * (1.0 / t88);
        t88b = -(tb146 * t89);
        t88bd = -(tb146d * t89 + tb146 * t89d);
        t87b = t88b * (1.0 / (2.0 * t88));
        t87bd = t88bd * (1.0 / (2.0 * t88)) - t88b * (1.0 / (2.0 * t88) * (2.0 * t88d) / (2.0 *
            t88));
        x8b = t87b * x8;
        x8bd = t87bd * x8 + t87b * x8d;
        x8b += t87b * x8;
        x8bd += t87bd * x8 + t87b * x8d;
        brb = x8b * areq;
        brbd = x8bd * areq + x8b * areqd;
        areqb = x8b * br;
        areqbd = x8bd * br + x8b * brd;
        tb145 = z30b * ca;
        tb145d = z30bd * ca + z30b * cad;
        dtb = tb145 * t86;
        dtbd = tb145d * t86 + tb145 * t86d;
        t86b = tb145 * dt;
        t86bd = tb145d * dt + tb145 * dtd;
        cab += z30b * (dt * t86);
        cabd += z30bd * (dt * t86) + z30b * (dtd * t86 + dt * t86d);
        t85b = -(t86b * sin(t85));
        t85bd = -(t86bd * sin(t85) + t86b * (cos(t85) * t85d));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += t85b * t84;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += t85bd * t84 + t85b * t84d;
        t84b = t85b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        t84bd = t85bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + t85b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        t83b = t84b * (1.0 / (1.0 + t83 * t83));
        t83bd = t84bd * (1.0 / (1.0 + t83 * t83)) - t84b * (1.0 / (1.0 + t83 * t83) * (t83d * t83 +
            t83 * t83d) / (1.0 + t83 * t83));
        etb = -(t83b * y18);
        etbd = -(t83bd * y18 + t83b * y18d);
        y18b = t83b * (1.0 - et);
        y18bd = t83bd * (1.0 - et) - t83b * etd;
        etb += t83b * t82;
        etbd += t83bd * t82 + t83b * t82d;
        t82b = t83b * et;
        t82bd = t83bd * et + t83b * etd;
        y18b += t82b * (1.0 / (1.0 + y18 * y18));
        y18bd += t82bd * (1.0 / (1.0 + y18 * y18)) - t82b * (1.0 / (1.0 + y18 * y18) * (y18d * y18 +
            y18 * y18d) / (1.0 + y18 * y18));
        btb = y18b * ateq;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        btbd = y18bd * ateq + y18b * ateqd;
        ateqb = y18b * bt;
        ateqbd = y18bd * bt + y18b * btd;
        tb144 = cab / t81;
        tb144d = (cabd - tb144 * t81d) * (1.0 / t81);
        t81b = -(tb144 * ca);
        t81bd = -(tb144d * ca + tb144 * cad);
        t80b = t81b * (1.0 / (2.0 * t81));
        t80bd = t81bd * (1.0 / (2.0 * t81)) - t81b * (1.0 / (2.0 * t81) * (2.0 * t81d) / (2.0 *
            t81));
        a3b = t80b * a3;
        a3bd = t80bd * a3 + t80b * a3d;
        a3b += t80b * a3;
        a3bd += t80bd * a3 + t80b * a3d;
        tb139 = drb * p11;
        tb139d = drbd * p11 + drb * p11d;
        tb140 = tb139 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        tb140d = tb139d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] + tb139 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        fz2b += tb140 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz);
        fz2bd += tb140d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) + tb140 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gzd));
        tb141 = tb140 * fz2;
        tb141d = tb140d * fz2 + tb140 * fz2d;
        tb142 = tb141 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES];
        tb142d = tb141d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + tb141 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] += tb142;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] += tb142d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] += tb142 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] += tb142d * dfz + tb142 * dfzd;
        dfzb += tb142 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7];
        dfzbd += tb142d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] + tb142 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] += tb141 * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] += tb141d *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) + tb141 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ7] * dfzd));
        tb143 = tb141 * gz;
        tb143d = tb141d * gz + tb141 * gzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] += tb143;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] += tb143d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] += tb143 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] += tb143d * dfz + tb143 * dfzd;
        dfzb += tb143 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9];
        dfzbd += tb143d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] + tb143 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9];
        gzb = tb141 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz);
        gzbd = tb141d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) + tb141 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfzd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb139 * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb139d * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz)) + tb139 * (fz2d * ((p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) + fz2 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gzd)));
        p11b = drb * (fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS]);
        p11bd = drbd * (fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS]) + drb * ((fz2d *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz) + fz2 * ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ6] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gzd))) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_UNLOADED_RADIUS] + fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS]);
        t79b = brb;
        t79bd = brbd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] += brb * bycy;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] += brbd * bycy + brb * bycyd;
        bycyb = brb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10];
        bycybd = brbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] + brb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10];
        tb138 = t79b / p11;
        tb138d = (t79bd - tb138 * p11d) * (1.0 / p11);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] += tb138 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] += tb138d * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LKY] + tb138 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += tb138 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ9];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += tb138d * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ9] + tb138 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9];
        p11b -= tb138 * t79;
        p11bd -= tb138d * t79 + tb138 * t79d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += p11b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += p11bd;
        y17b = etb;
        y17bd = etbd;
        e12b = 0.0;
        e12bd = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e12) > 1.0) {
          y17b = 0.0;
          y17bd = 0.0;
        } else {
          e12b += y17b;
          e12bd += y17bd;
          y17b = 0.0;
          y17bd = 0.0;
        }
        tb133 = e12b * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78);
        tb133d = e12bd * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78) +
            e12b * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ5] * gzd)) * 0.63661977236758134308 * t78 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] += tb133;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] += tb133d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] += tb133 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] += tb133d * dfz + tb133 * dfzd;
        dfzb += tb133 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2];
        dfzbd += tb133d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] + tb133 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2];
        tb134 = tb133 * dfz;
        tb134d = tb133d * dfz + tb133 * dfzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] += tb134 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] += tb134d * dfz + tb134 * dfzd;
        dfzb += tb134 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3];
        dfzbd += tb134d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] + tb134 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3];
        dfzb += tb133 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz);
        dfzbd += tb133d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz) + tb133 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ3] * dfzd);
        tb135 = e12b * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ3] * dfz * dfz);
        tb135d = e12bd * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ3] * dfz * dfz) + e12b * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ1] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfzd));
        tb136 = tb135 * t78;
        tb136d = tb135d * t78 + tb135 * t78d;
        tb137 = tb136 * 0.63661977236758134308;
        tb137d = tb136d * 0.63661977236758134308;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] += tb137;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] += tb137d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] += tb137 * gz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] += tb137d * gz + tb137 * gzd;
        gzb += tb137 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5];
        gzbd += tb137d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] + tb137 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5];
        t78b = tb135 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308);
        t78bd = tb135d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308) + tb135
            * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ5] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gzd)) *
            0.63661977236758134308);
        t77b = t78b * (1.0 / (1.0 + t77 * t77));
        t77bd = t78bd * (1.0 / (1.0 + t77 * t77)) - t78b * (1.0 / (1.0 + t77 * t77) * (t77d * t77 +
            t77 * t77d) / (1.0 + t77 * t77));
        tb132 = t77b * at;
        tb132d = t77bd * at + t77b * atd;
        btb += tb132 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        btbd += tb132d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + tb132 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += tb132 * bt;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += tb132d * bt + tb132 * btd;
        atb = t77b * (bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1]);
        atbd = t77bd * (bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1]) + t77b * (btd *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + bt * pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QCZ1]);
        tb126 = dtb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        tb126d = dtbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] + dtb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        tb127 = tb126 * t76;
        tb127d = tb126d * t76 + tb126 * t76d;
        tb128 = tb127 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz);
        tb128d = tb127d * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) + tb127 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ3] * gzd + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gzd) * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gzd));
        fz2b += tb128 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz);
        fz2bd += tb128d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) + tb128 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfzd));
        tb129 = tb128 * fz2;
        tb129d = tb128d * fz2 + tb128 * fz2d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] += tb129;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] += tb129d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] += tb129 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] += tb129d * dfz + tb129 * dfzd;
        dfzb += tb129 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2];
        dfzbd += tb129d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] + tb129 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2];
        tb130 = tb127 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz));
        tb130d = tb127d * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz)) + tb127 * (fz2d *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) + fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfzd)));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] += tb130 * gz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] += tb130d * gz + tb130 * gzd;
        gzb += tb130 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3];
        gzbd += tb130d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + tb130 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3];
        tb131 = tb130 * gz;
        tb131d = tb130d * gz + tb130 * gzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] += tb131 * gz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] += tb131d * gz + tb131 * gzd;
        gzb += tb131 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4];
        gzbd += tb131d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] + tb131 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4];
        gzb += tb130 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz);
        gzbd += tb130d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) + tb130 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ4] * gzd);
        t76b = tb126 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz * gz));
        t76bd = tb126d * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz * gz)) + tb126 * ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfzd))) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) + fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gzd +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ4] * gzd) * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz *
            gzd)));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] += dtb * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] += dtbd * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76) + dtb * (((fz2d *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) + fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfzd))) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] *
            gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) + fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gzd +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ4] * gzd) * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz *
            gzd))) * t76 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz * gz) * t76d);
        tb125 = t76b / fz0_4;
        tb125d = (t76bd - tb125 * fz0_4d) * (1.0 / fz0_4);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb125;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb125d;
        fz0_4b = -(tb125 * t76);
        fz0_4bd = -(tb125d * t76 + tb125 * t76d);
        tb120 = btb / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb120d = (btbd - tb120 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]);
        tb121 = tb120 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        tb121d = tb120d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] + tb120 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        tb122 = tb121 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16);
        tb122d = tb121d * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16) + tb121 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ4] * gzd + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16d));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] += tb122;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] += tb122d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] += tb122 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] += tb122d * dfz + tb122 * dfzd;
        dfzb += tb122 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2];
        dfzbd += tb122d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] + tb122 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2];
        tb123 = tb122 * dfz;
        tb123d = tb122d * dfz + tb122 * dfzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] += tb123 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] += tb123d * dfz + tb123 * dfzd;
        dfzb += tb123 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3];
        dfzbd += tb123d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] + tb123 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3];
        dfzb += tb122 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz);
        dfzbd += tb122d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz) + tb122 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ3] * dfzd);
        tb124 = tb121 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz * dfz);
        tb124d = tb121d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz * dfz) + tb121 * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ1] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfzd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] += tb124 * gz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] += tb124d * gz + tb124 * gzd;
        gzb += tb124 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4];
        gzbd += tb124d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] + tb124 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] += tb124 * y16;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] += tb124d * y16 + tb124 * y16d;
        y16b = tb124 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5];
        y16bd = tb124d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] + tb124 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += tb120 * ((p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ5] * y16));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += tb120d *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16)) + tb120 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfzd)) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ5] * y16) + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz * dfz) * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gzd +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ5] * y16d)));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] -= tb120 * bt;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] -= tb120d * bt + tb120 * btd;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          gzb += y16b;
          gzbd += y16bd;
          y16b = 0.0;
          y16bd = 0.0;
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          gzb -= y16b;
          gzbd -= y16bd;
          y16b = 0.0;
          y16bd = 0.0;
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p10d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t75 = p10 * p10;
          t75d = p10d * p10 + p10 * p10d;
          z6 = gz * gz / t75;
          z6d = (gzd * gz + gz * gzd - z6 * t75d) * (1.0 / t75);
          tb118 = y16b * (15.0 + z6 * (-10.0 + 3.0 * z6));
          tb118d = y16bd * (15.0 + z6 * (-10.0 + 3.0 * z6)) + y16b * (z6d * (-10.0 + 3.0 * z6) + z6
              * (3.0 * z6d));
          p10b = tb118 * z6 * 0.125;
          p10bd = (tb118d * z6 + tb118 * z6d) * 0.125;
          z6b = tb118 * (0.125 * p10);
          z6bd = tb118d * (0.125 * p10) + tb118 * (0.125 * p10d);
          tb119 = y16b * (0.125 * p10 * z6);
          tb119d = y16bd * (0.125 * p10 * z6) + y16b * (0.125 * p10d * z6 + 0.125 * p10 * z6d);
          z6b += tb119 * (-10.0 + 3.0 * z6);
          z6bd += tb119d * (-10.0 + 3.0 * z6) + tb119 * (3.0 * z6d);
          z6b += tb119 * z6 * 3.0;
          z6bd += (tb119d * z6 + tb119 * z6d) * 3.0;
          y16b = 0.0;
          y16bd = 0.0;
          tb117 = z6b / t75;
          tb117d = (z6bd - tb117 * t75d) * (1.0 / t75);
          gzb += tb117 * gz;
          gzbd += tb117d * gz + tb117 * gzd;
          gzb += tb117 * gz;
          gzbd += tb117d * gz + tb117 * gzd;
          t75b = -(tb117 * z6);
          t75bd = -(tb117d * z6 + tb117 * z6d);
          p10b += t75b * p10;
          p10bd += t75bd * p10 + t75b * p10d;
          p10b += t75b * p10;
          p10bd += t75bd * p10 + t75b * p10d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p10b;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p10bd;
        }
        t74b = areqb * (1.0 / (2.0 * areq));
        t74bd = areqbd * (1.0 / (2.0 * areq)) - areqb * (1.0 / (2.0 * areq) * (2.0 * areqd) / (2.0 *
            areq));
        arb = t74b * ar;
        arbd = t74bd * ar + t74b * ard;
        arb += t74b * ar;
        arbd += t74bd * ar + t74b * ard;
        ratio2b = t74b * ratio2;
        ratio2bd = t74bd * ratio2 + t74b * ratio2d;
        ratio2b += t74b * ratio2;
        ratio2bd += t74bd * ratio2 + t74b * ratio2d;
        t73b = ateqb * (1.0 / (2.0 * ateq));
        t73bd = ateqbd * (1.0 / (2.0 * ateq)) - ateqb * (1.0 / (2.0 * ateq) * (2.0 * ateqd) / (2.0 *
            ateq));
        atb += t73b * at;
        atbd += t73bd * at + t73b * atd;
        atb += t73b * at;
        atbd += t73bd * at + t73b * atd;
        ratio2b += t73b * ratio2;
        ratio2bd += t73bd * ratio2 + t73b * ratio2d;
        ratio2b += t73b * ratio2;
        ratio2bd += t73bd * ratio2 + t73b * ratio2d;
        a3b += arb;
        a3bd += arbd;
        shiftb = arb;
        shiftbd = arbd;
        a3b += atb;
        a3bd += atbd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] += atb;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] += atbd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] += atb * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] += atbd * dfz + atb * dfzd;
        dfzb += atb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2];
        dfzbd += atbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] + atb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2];
        tb116 = atb * gz;
        tb116d = atbd * gz + atb * gzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] += tb116;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] += tb116d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] += tb116 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] += tb116d * dfz + tb116 * dfzd;
        dfzb += tb116 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4];
        dfzbd += tb116d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] + tb116 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4];
        gzb += atb * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz);
        gzbd += atbd * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) + atb *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QHZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfzd));
        gamma2b += gzb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        gamma2bd += gzbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] + gzb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] += gzb * gamma2;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] += gzbd * gamma2 + gzb * gamma2d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_4b *
            p[t->tyreadr[t->wheeltyre[i]]];
        /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
         *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_4bd *
            p[t->tyreadr[t->wheeltyre[i]]] + fz0_4b * pd[t->tyreadr[t->wheeltyre[i]]];
        pb[t->tyreadr[t->wheeltyre[i]]] += fz0_4b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO];
        pbd[t->tyreadr[t->wheeltyre[i]]] += fz0_4bd * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO] + fz0_4b * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO];
        y24b = shiftb;
        y24bd = shiftbd;
        y23b = bycyb;
        y23bd = bycybd;
        tb115 = ratio2b / y21;
        tb115d = (ratio2bd - tb115 * y21d) * (1.0 / y21);
        x41b = tb115 * kappa2;
        x41bd = tb115d * kappa2 + tb115 * kappa2d;
        kappa2b = tb115 * x41;
        kappa2bd = tb115d * x41 + tb115 * x41d;
        y21b = -(tb115 * ratio2);
        y21bd = -(tb115d * ratio2 + tb115 * ratio2d);
        g30b = fyb * y20;
        g30bd = fybd * y20 + fyb * y20d;
        y20b = fyb * g30;
        y20bd = fybd * g30 + fyb * g30d;
        g31b += fyb;
        g31bd += fybd;
        x40b = fxb * t72;
        x40bd = fxbd * t72 + fxb * t72d;
        t72b = fxb * x40;
        t72bd = fxbd * x40 + fxb * x40d;
        tb114 = t72b / t71;
        tb114d = (t72bd - tb114 * t71d) * (1.0 / t71);
        t66b = tb114;
        t66bd = tb114d;
        t71b = -(tb114 * t72);
        t71bd = -(tb114d * t72 + tb114 * t72d);
        t70b = -(t71b * sin(t70));
        t70bd = -(t71bd * sin(t70) + t71b * (cos(t70) * t70d));
        p9b = t70b * t69;
        p9bd = t70bd * t69 + t70b * t69d;
        t69b = t70b * p9;
        t69bd = t70bd * p9 + t70b * p9d;
        t68b = t69b * (1.0 / (1.0 + t68 * t68));
        t68bd = t69bd * (1.0 / (1.0 + t68 * t68)) - t69b * (1.0 / (1.0 + t68 * t68) * (t68d * t68 +
            t68 * t68d) / (1.0 + t68 * t68));
        e10b = -(t68b * y15);
        e10bd = -(t68bd * y15 + t68b * y15d);
        y15b = t68b * (1.0 - e10);
        y15bd = t68bd * (1.0 - e10) - t68b * e10d;
        e10b += t68b * t67;
        e10bd += t68bd * t67 + t68b * t67d;
        t67b = t68b * e10;
        t67bd = t68bd * e10 + t68b * e10d;
        y15b += t67b * (1.0 / (1.0 + y15 * y15));
        y15bd += t67bd * (1.0 / (1.0 + y15 * y15)) - t67b * (1.0 / (1.0 + y15 * y15) * (y15d * y15 +
            y15 * y15d) / (1.0 + y15 * y15));
        t65b = -(t66b * sin(t65));
        t65bd = -(t66bd * sin(t65) + t66b * (cos(t65) * t65d));
        p9b += t65b * t64;
        p9bd += t65bd * t64 + t65b * t64d;
        t64b = t65b * p9;
        t64bd = t65bd * p9 + t65b * p9d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1] += p9b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1] += p9bd;
        t63b = t64b * (1.0 / (1.0 + t63 * t63));
        t63bd = t64bd * (1.0 / (1.0 + t63 * t63)) - t64b * (1.0 / (1.0 + t63 * t63) * (t63d * t63 +
            t63 * t63d) / (1.0 + t63 * t63));
        e10b -= t63b * y14;
        e10bd -= t63bd * y14 + t63b * y14d;
        y14b = t63b * (1.0 - e10);
        y14bd = t63bd * (1.0 - e10) - t63b * e10d;
        e10b += t63b * t62;
        e10bd += t63bd * t62 + t63b * t62d;
        t62b = t63b * e10;
        t62bd = t63bd * e10 + t63b * e10d;
        y14b += t62b * (1.0 / (1.0 + y14 * y14));
        y14bd += t62bd * (1.0 / (1.0 + y14 * y14)) - t62b * (1.0 / (1.0 + y14 * y14) * (y14d * y14 +
            y14 * y14d) / (1.0 + y14 * y14));
        stiff4b = y15b * p8;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        stiff4bd = y15bd * p8 + y15b * p8d;
        p8b = y15b * stiff4;
        p8bd = y15bd * stiff4 + y15b * stiff4d;
        stiff4b += y14b * (a3 + p8);
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        stiff4bd += y14bd * (a3 + p8) + y14b * (a3d + p8d);
        tb113 = y14b * stiff4;
        tb113d = y14bd * stiff4 + y14b * stiff4d;
        a3b += tb113;
        a3bd += tb113d;
        p8b += tb113;
        p8bd += tb113d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1] += p8b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1] += p8bd;
        y13b = e10b;
        y13bd = e10bd;
        e11b = 0.0;
        e11bd = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e11) > 1.0) {
          y13b = 0.0;
          y13bd = 0.0;
        } else {
          e11b += y13b;
          e11bd += y13bd;
          y13b = 0.0;
          y13bd = 0.0;
        }
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] += e11b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] += e11bd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] += e11b * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] += e11bd * dfz + e11b * dfzd;
        dfzb += e11b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2];
        dfzbd += e11bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] + e11b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2];
        tb112 = stiff4b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        tb112d = stiff4bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL] + stiff4b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] += tb112 * t61;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] += tb112d * t61 + tb112 * t61d;
        t61b = tb112 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1];
        t61bd = tb112d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] + tb112 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL] += stiff4b *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL] += stiff4bd *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61) + stiff4b *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBX1] * t61d);
        tb111 = t61b / t60;
        tb111d = (t61bd - tb111 * t60d) * (1.0 / t60);
        t60b = -(tb111 * t61);
        t60bd = -(tb111d * t61 + tb111 * t61d);
        t59b = t60b * (1.0 / (2.0 * t60));
        t59bd = t60bd * (1.0 / (2.0 * t60)) - t60b * (1.0 / (2.0 * t60) * (2.0 * t60d) / (2.0 *
            t60));
        x7b = t59b * x7;
        x7bd = t59bd * x7 + t59b * x7d;
        x7b += t59b * x7;
        x7bd += t59bd * x7 + t59b * x7d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] += x7b * kappa2;
        /* Gxa = Fx / Fx0 */
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] += x7bd * kappa2 + x7b * kappa2d;
        kappa2b += x7b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2];
        kappa2bd += x7bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] + x7b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2];
        tb110 = g31b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        tb110d = g31bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] + g31b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        dvb = tb110 * t58;
        dvbd = tb110d * t58 + tb110 * t58d;
        t58b = tb110 * dv;
        t58bd = tb110d * dv + tb110 * dvd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] += g31b * (dv * t58);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] += g31bd * (dv * t58) + g31b * (dvd *
            t58 + dv * t58d);
        t57b = t58b * cos(t57);
        t57bd = t58bd * cos(t57) - t58b * (sin(t57) * t57d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] += t57b * t56;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] += t57bd * t56 + t57b * t56d;
        t56b = t57b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5];
        t56bd = t57bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] + t57b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5];
        t55b = t56b * (1.0 / (1.0 + t55 * t55));
        t55bd = t56bd * (1.0 / (1.0 + t55 * t55)) - t56b * (1.0 / (1.0 + t55 * t55) * (t55d * t55 +
            t55 * t55d) / (1.0 + t55 * t55));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] += t55b * kappa2;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] += t55bd * kappa2 + t55b * kappa2d;
        kappa2b += t55b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6];
        kappa2bd += t55bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] + t55b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6];
        tb109 = g30b / t54;
        tb109d = (g30bd - tb109 * t54d) * (1.0 / t54);
        t49b = tb109;
        t49bd = tb109d;
        t54b = -(tb109 * g30);
        t54bd = -(tb109d * g30 + tb109 * g30d);
        t53b = -(t54b * sin(t53));
        t53bd = -(t54bd * sin(t53) + t54b * (cos(t53) * t53d));
        p7b = t53b * t52;
        p7bd = t53bd * t52 + t53b * t52d;
        t52b = t53b * p7;
        t52bd = t53bd * p7 + t53b * p7d;
        t51b = t52b * (1.0 / (1.0 + t51 * t51));
        t51bd = t52bd * (1.0 / (1.0 + t51 * t51)) - t52b * (1.0 / (1.0 + t51 * t51) * (t51d * t51 +
            t51 * t51d) / (1.0 + t51 * t51));
        e8b = -(t51b * y12);
        e8bd = -(t51bd * y12 + t51b * y12d);
        y12b = t51b * (1.0 - e8);
        y12bd = t51bd * (1.0 - e8) - t51b * e8d;
        e8b += t51b * t50;
        e8bd += t51bd * t50 + t51b * t50d;
        t50b = t51b * e8;
        t50bd = t51bd * e8 + t51b * e8d;
        y12b += t50b * (1.0 / (1.0 + y12 * y12));
        y12bd += t50bd * (1.0 / (1.0 + y12 * y12)) - t50b * (1.0 / (1.0 + y12 * y12) * (y12d * y12 +
            y12 * y12d) / (1.0 + y12 * y12));
        t48b = -(t49b * sin(t48));
        t48bd = -(t49bd * sin(t48) + t49b * (cos(t48) * t48d));
        p7b += t48b * t47;
        p7bd += t48bd * t47 + t48b * t47d;
        t47b = t48b * p7;
        t47bd = t48bd * p7 + t48b * p7d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1] += p7b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1] += p7bd;
        t46b = t47b * (1.0 / (1.0 + t46 * t46));
        t46bd = t47bd * (1.0 / (1.0 + t46 * t46)) - t47b * (1.0 / (1.0 + t46 * t46) * (t46d * t46 +
            t46 * t46d) / (1.0 + t46 * t46));
        e8b -= t46b * y11;
        e8bd -= t46bd * y11 + t46b * y11d;
        y11b = t46b * (1.0 - e8);
        y11bd = t46bd * (1.0 - e8) - t46b * e8d;
        e8b += t46b * t45;
        e8bd += t46bd * t45 + t46b * t45d;
        t45b = t46b * e8;
        t45bd = t46bd * e8 + t46b * e8d;
        y11b += t45b * (1.0 / (1.0 + y11 * y11));
        y11bd += t45bd * (1.0 / (1.0 + y11 * y11)) - t45b * (1.0 / (1.0 + y11 * y11) * (y11d * y11 +
            y11 * y11d) / (1.0 + y11 * y11));
        stiff3b = y12b * s4;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        stiff3bd = y12bd * s4 + y12b * s4d;
        s4b = y12b * stiff3;
        s4bd = y12bd * stiff3 + y12b * stiff3d;
        stiff3b += y11b * (kappa2 + s4);
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        stiff3bd += y11bd * (kappa2 + s4) + y11b * (kappa2d + s4d);
        tb108 = y11b * stiff3;
        tb108d = y11bd * stiff3 + y11b * stiff3d;
        kappa2b += tb108;
        kappa2bd += tb108d;
        s4b += tb108;
        s4bd += tb108d;
        tb105 = dvb * t44;
        tb105d = dvbd * t44 + dvb * t44d;
        tb106 = tb105 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2);
        tb106d = tb105d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2) + tb105 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1]
            + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2d));
        muy2b = tb106 * fz2;
        muy2bd = tb106d * fz2 + tb106 * fz2d;
        fz2b += tb106 * muy2;
        fz2bd += tb106d * muy2 + tb106 * muy2d;
        tb107 = tb105 * (muy2 * fz2);
        tb107d = tb105d * (muy2 * fz2) + tb105 * (muy2d * fz2 + muy2 * fz2d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] += tb107;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] += tb107d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] += tb107 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] += tb107d * dfz + tb107 * dfzd;
        dfzb += tb107 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2];
        dfzbd += tb107d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] + tb107 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] += tb107 * gamma2;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] += tb107d * gamma2 + tb107 * gamma2d;
        gamma2b += tb107 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3];
        gamma2bd += tb107d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] + tb107 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3];
        t44b = dvb * (muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2));
        t44bd = dvbd * (muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2)) + dvb * ((muy2d * fz2 + muy2 * fz2d) *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2) +
            muy2 * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RVY2] * dfzd) + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2d)));
        tb104 = t44b / t43;
        tb104d = (t44bd - tb104 * t43d) * (1.0 / t43);
        t43b = -(tb104 * t44);
        t43bd = -(tb104d * t44 + tb104 * t44d);
        t42b = t43b * (1.0 / (2.0 * t43));
        t42bd = t43bd * (1.0 / (2.0 * t43)) - t43b * (1.0 / (2.0 * t43) * (2.0 * t43d) / (2.0 *
            t43));
        x6b = t42b * x6;
        x6bd = t42bd * x6 + t42b * x6d;
        x6b += t42b * x6;
        x6bd += t42bd * x6 + t42b * x6d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] += x6b * a3;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] += x6bd * a3 + x6b * a3d;
        a3b += x6b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4];
        a3bd += x6bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] + x6b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] += s4b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] += s4bd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] += s4b * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] += s4bd * dfz + s4b * dfzd;
        dfzb += s4b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2];
        dfzbd += s4bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] + s4b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2];
        y10b = e8b;
        y10bd = e8bd;
        e9b = 0.0;
        e9bd = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e9) > 1.0) {
          y10b = 0.0;
          y10bd = 0.0;
        } else {
          e9b += y10b;
          e9bd += y10bd;
          y10b = 0.0;
          y10bd = 0.0;
        }
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] += e9b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] += e9bd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] += e9b * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] += e9bd * dfz + e9b * dfzd;
        dfzb += e9b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2];
        dfzbd += e9bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] + e9b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2];
        tb103 = stiff3b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        tb103d = stiff3bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA] + stiff3b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] += tb103 * t41;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] += tb103d * t41 + tb103 * t41d;
        t41b = tb103 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1];
        t41bd = tb103d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] + tb103 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA] += stiff3b *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA] += stiff3bd *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41) + stiff3b *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBY1] * t41d);
        tb102 = t41b / t40;
        tb102d = (t41bd - tb102 * t40d) * (1.0 / t40);
        t40b = -(tb102 * t41);
        t40bd = -(tb102d * t41 + tb102 * t41d);
        t39b = t40b * (1.0 / (2.0 * t40));
        t39bd = t40bd * (1.0 / (2.0 * t40)) - t40b * (1.0 / (2.0 * t40) * (2.0 * t40d) / (2.0 *
            t40));
        x5b = t39b * x5;
        x5bd = t39bd * x5 + t39b * x5d;
        x5b += t39b * x5;
        x5bd += t39bd * x5 + t39b * x5d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] += x5b * (a3 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]);
        /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] += x5bd * (a3 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]) + x5b * (a3d -
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]);
        tb101 = x5b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2];
        tb101d = x5bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] + x5b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2];
        a3b += tb101;
        a3bd += tb101d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3] -= tb101;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3] -= tb101d;
        y22b = muy2b;
        y22bd = muy2bd;
        shyb = y24b;
        shybd = y24bd;
        t38b = y24b;
        t38bd = y24bd;
        tb100 = t38b / stiff2;
        tb100d = (t38bd - tb100 * stiff2d) * (1.0 / stiff2);
        svyb = tb100;
        svybd = tb100d;
        stiff2b = -(tb100 * t38);
        stiff2bd = -(tb100d * t38 + tb100 * t38d);
        byb = y23b * cy;
        bybd = y23bd * cy + y23b * cyd;
        cyb = y23b * by;
        cybd = y23bd * by + y23b * byd;
        muyb = y22b;
        muybd = y22bd;
        stiff2b += y21b;
        stiff2bd += y21bd;
        dyb = y20b * t37;
        dybd = y20bd * t37 + y20b * t37d;
        t37b = y20b * dy;
        t37bd = y20bd * dy + y20b * dyd;
        svyb += y20b;
        svybd += y20bd;
        t36b = t37b * cos(t36);
        t36bd = t37bd * cos(t36) - t37b * (sin(t36) * t36d);
        cyb += t36b * t35;
        cybd += t36bd * t35 + t36b * t35d;
        t35b = t36b * cy;
        t35bd = t36bd * cy + t36b * cyd;
        t34b = t35b * (1.0 / (1.0 + t34 * t34));
        t34bd = t35bd * (1.0 / (1.0 + t34 * t34)) - t35b * (1.0 / (1.0 + t34 * t34) * (t34d * t34 +
            t34 * t34d) / (1.0 + t34 * t34));
        eyb = -(t34b * y9);
        eybd = -(t34bd * y9 + t34b * y9d);
        y9b = t34b * (1.0 - ey);
        y9bd = t34bd * (1.0 - ey) - t34b * eyd;
        eyb += t34b * t33;
        eybd += t34bd * t33 + t34b * t33d;
        t33b = t34b * ey;
        t33bd = t34bd * ey + t34b * eyd;
        y9b += t33b * (1.0 / (1.0 + y9 * y9));
        y9bd += t33bd * (1.0 / (1.0 + y9 * y9)) - t33b * (1.0 / (1.0 + y9 * y9) * (y9d * y9 + y9 *
            y9d) / (1.0 + y9 * y9));
        byb += y9b * ay;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        bybd += y9bd * ay + y9b * ayd;
        ayb = y9b * by;
        aybd = y9bd * by + y9b * byd;
        tb96 = svyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb96d = svybd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + svyb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        fz2b += tb96 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy);
        fz2bd += tb96d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) + tb96 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfzd)) * gy +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gyd));
        tb97 = tb96 * fz2;
        tb97d = tb96d * fz2 + tb96 * fz2d;
        tb98 = tb97 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY];
        tb98d = tb97d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + tb97 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] += tb98;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] += tb98d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] += tb98 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] += tb98d * dfz + tb98 * dfzd;
        dfzb += tb98 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2];
        dfzbd += tb98d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] + tb98 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] += tb97 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] += tb97d * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) + tb97 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfzd));
        tb99 = tb97 * gy;
        tb99d = tb97d * gy + tb97 * gyd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] += tb99;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] += tb99d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] += tb99 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] += tb99d * dfz + tb99 * dfzd;
        dfzb += tb99 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4];
        dfzbd += tb99d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] + tb99 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4];
        gyb = tb97 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz);
        gybd = tb97d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) + tb97 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfzd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += svyb * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gy));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += svybd * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gy)) + svyb * (fz2d * ((p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) + fz2 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfzd)) * gy +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gyd)));
        tb95 = byb / t32;
        tb95d = (bybd - tb95 * t32d) * (1.0 / t32);
        stiff2b += tb95;
        stiff2bd += tb95d;
        t32b = -(tb95 * by);
        t32bd = -(tb95d * by + tb95 * byd);
        cyb += t32b * dy;
        cybd += t32bd * dy + t32b * dyd;
        dyb += t32b * cy;
        dybd += t32bd * cy + t32b * cyd;
        tb91 = stiff2b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        tb91d = stiff2bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] + stiff2b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        tb92 = tb91 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8);
        tb92d = tb91d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) - tb91 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PKY3] * y8d);
        tb93 = tb92 * t31;
        tb93d = tb92d * t31 + tb92 * t31d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] += tb93 * fz0_3;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] += tb93d * fz0_3 + tb93 * fz0_3d;
        fz0_3b = tb93 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1];
        fz0_3bd = tb93d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] + tb93 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1];
        t31b = tb92 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3);
        t31bd = tb92d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3) + tb92 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d);
        tb94 = tb91 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31);
        tb94d = tb91d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31) + tb91 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d) * t31 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] -= tb94 * y8;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] -= tb94d * y8 + tb94 * y8d;
        y8b = -(tb94 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]);
        y8bd = -(tb94d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] + tb94 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += stiff2b * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY3] * y8));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += stiff2bd *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8)) + stiff2b *
            (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d) * t31 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) - p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t31 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8d));
        tb90 = t31b / t30;
        tb90d = (t31bd - tb90 * t30d) * (1.0 / t30);
        z4b = tb90 * 2.0;
        z4bd = tb90d * 2.0;
        t30b = -(tb90 * t31);
        t30bd = -(tb90d * t31 + tb90 * t31d);
        z4b += t30b * z4;
        z4bd += t30bd * z4 + t30b * z4d;
        z4b += t30b * z4;
        z4bd += t30bd * z4 + t30b * z4d;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          gyb += y8b;
          gybd += y8bd;
          y8b = 0.0;
          y8bd = 0.0;
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          gyb -= y8b;
          gybd -= y8bd;
          y8b = 0.0;
          y8bd = 0.0;
        } else {
          p6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t29 = p6 * p6;
          t29d = p6d * p6 + p6 * p6d;
          z5 = gy * gy / t29;
          z5d = (gyd * gy + gy * gyd - z5 * t29d) * (1.0 / t29);
          tb88 = y8b * (15.0 + z5 * (-10.0 + 3.0 * z5));
          tb88d = y8bd * (15.0 + z5 * (-10.0 + 3.0 * z5)) + y8b * (z5d * (-10.0 + 3.0 * z5) + z5 *
              (3.0 * z5d));
          p6b = tb88 * z5 * 0.125;
          p6bd = (tb88d * z5 + tb88 * z5d) * 0.125;
          z5b = tb88 * (0.125 * p6);
          z5bd = tb88d * (0.125 * p6) + tb88 * (0.125 * p6d);
          tb89 = y8b * (0.125 * p6 * z5);
          tb89d = y8bd * (0.125 * p6 * z5) + y8b * (0.125 * p6d * z5 + 0.125 * p6 * z5d);
          z5b += tb89 * (-10.0 + 3.0 * z5);
          z5bd += tb89d * (-10.0 + 3.0 * z5) + tb89 * (3.0 * z5d);
          z5b += tb89 * z5 * 3.0;
          z5bd += (tb89d * z5 + tb89 * z5d) * 3.0;
          y8b = 0.0;
          y8bd = 0.0;
          tb87 = z5b / t29;
          tb87d = (z5bd - tb87 * t29d) * (1.0 / t29);
          gyb += tb87 * gy;
          gybd += tb87d * gy + tb87 * gyd;
          gyb += tb87 * gy;
          gybd += tb87d * gy + tb87 * gyd;
          t29b = -(tb87 * z5);
          t29bd = -(tb87d * z5 + tb87 * z5d);
          p6b += t29b * p6;
          p6bd += t29bd * p6 + t29b * p6d;
          p6b += t29b * p6;
          p6bd += t29bd * p6 + t29b * p6d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p6b;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p6bd;
        }
        tb86 = z4b / t28;
        tb86d = (z4bd - tb86 * t28d) * (1.0 / t28);
        fz2b += tb86;
        fz2bd += tb86d;
        t28b = -(tb86 * z4);
        t28bd = -(tb86d * z4 + tb86 * z4d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] += t28b * fz0_3;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] += t28bd * fz0_3 + t28b * fz0_3d;
        fz0_3b += t28b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2];
        fz0_3bd += t28bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] + t28b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2];
        e5b = 0.0;
        e5bd = 0.0;
        if (MAGGI_RE(ay) > 0.0) {
          e6 = e5 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e6d = e5d * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) - e5 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          y6b = eyb;
          y6bd = eybd;
          eyb = 0.0;
          eybd = 0.0;
          e6b = 0.0;
          e6bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e6) > 1.0) {
            y6b = 0.0;
            y6bd = 0.0;
          } else {
            e6b += y6b;
            e6bd += y6bd;
            y6b = 0.0;
            y6bd = 0.0;
          }
          e5b += e6b * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e5bd += e6bd * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) - e6b *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          tb84 = e6b * e5;
          tb84d = e6bd * e5 + e6b * e5d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] -= tb84;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] -= tb84d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] -= tb84 * gy;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] -= tb84d * gy + tb84 * gyd;
          gyb -= tb84 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
          gybd -= tb84d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] + tb84 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
        } else {
          e7 = e5 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e7d = e5d * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) + e5 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          y7b = eyb;
          y7bd = eybd;
          eyb = 0.0;
          eybd = 0.0;
          e7b = 0.0;
          e7bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e7) > 1.0) {
            y7b = 0.0;
            y7bd = 0.0;
          } else {
            e7b += y7b;
            e7bd += y7bd;
            y7b = 0.0;
            y7bd = 0.0;
          }
          e5b += e7b * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e5bd += e7bd * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) + e7b *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          tb85 = e7b * e5;
          tb85d = e7bd * e5 + e7b * e5d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] += tb85;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] += tb85d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] += tb85 * gy;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] += tb85d * gy + tb85 * gyd;
          gyb += tb85 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
          gybd += tb85d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] + tb85 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
        }
        tb83 = e5b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        tb83d = e5bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] + e5b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] += tb83;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] += tb83d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] += tb83 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] += tb83d * dfz + tb83 * dfzd;
        dfzb += tb83 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2];
        dfzbd += tb83d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] + tb83 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] += e5b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] += e5bd * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz) + e5b *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfzd));
        muyb += dyb * fz2;
        muybd += dybd * fz2 + dyb * fz2d;
        fz2b += dyb * muy;
        fz2bd += dybd * muy + dyb * muyd;
        tb79 = muyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb79d = muybd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + muyb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb80 = tb79 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy);
        tb80d = tb79d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) - tb79 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDY3] * gyd) * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy *
            gyd);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] += tb80;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] += tb80d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] += tb80 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] += tb80d * dfz + tb80 * dfzd;
        dfzb += tb80 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2];
        dfzbd += tb80d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] + tb80 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2];
        tb81 = tb79 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz);
        tb81d = tb79d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz) + tb79 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfzd));
        tb82 = tb81 * gy;
        tb82d = tb81d * gy + tb81 * gyd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] -= tb82 * gy;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] -= tb82d * gy + tb82 * gyd;
        gyb -= tb82 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3];
        gybd -= tb82d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] + tb82 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3];
        gyb -= tb81 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy);
        gybd -= tb81d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy) + tb81 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDY3] * gyd);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += muyb * ((p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += muybd *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy *
            gy)) + muyb * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDY2] * dfzd)) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] *
            gy * gy) - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz) *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDY3] * gyd) * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy *
            gyd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] += cyb * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] += cybd * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY] + cyb * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY] += cyb * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCY1];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY] += cybd * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCY1] + cyb * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1];
        a3b += ayb;
        a3bd += aybd;
        shyb += ayb;
        shybd += aybd;
        tb78 = shyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY];
        tb78d = shybd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] + shyb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] += tb78;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] += tb78d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] += tb78 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] += tb78d * dfz + tb78 * dfzd;
        dfzb += tb78 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2];
        dfzbd += tb78d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] + tb78 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] += shyb * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] += shybd * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz) + shyb *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfzd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] += shyb * gy;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] += shybd * gy + shyb * gyd;
        gyb += shyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3];
        gybd += shybd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] + shyb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3];
        gamma2b += gyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        gamma2bd += gybd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] + gyb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] += gyb * gamma2;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] += gybd * gamma2 + gyb * gamma2d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_3b *
            p[t->tyreadr[t->wheeltyre[i]]];
        /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_3bd *
            p[t->tyreadr[t->wheeltyre[i]]] + fz0_3b * pd[t->tyreadr[t->wheeltyre[i]]];
        pb[t->tyreadr[t->wheeltyre[i]]] += fz0_3b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO];
        pbd[t->tyreadr[t->wheeltyre[i]]] += fz0_3bd * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO] + fz0_3b * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO];
        stiffb = x41b;
        stiffbd = x41bd;
        dxb = x40b * t27;
        dxbd = x40bd * t27 + x40b * t27d;
        t27b = x40b * dx;
        t27bd = x40bd * dx + x40b * dxd;
        svxb = x40b;
        svxbd = x40bd;
        t26b = t27b * cos(t26);
        t26bd = t27bd * cos(t26) - t27b * (sin(t26) * t26d);
        cxb = t26b * t25;
        cxbd = t26bd * t25 + t26b * t25d;
        t25b = t26b * cx;
        t25bd = t26bd * cx + t26b * cxd;
        t24b = t25b * (1.0 / (1.0 + t24 * t24));
        t24bd = t25bd * (1.0 / (1.0 + t24 * t24)) - t25b * (1.0 / (1.0 + t24 * t24) * (t24d * t24 +
            t24 * t24d) / (1.0 + t24 * t24));
        exb = -(t24b * y5);
        exbd = -(t24bd * y5 + t24b * y5d);
        y5b = t24b * (1.0 - ex);
        y5bd = t24bd * (1.0 - ex) - t24b * exd;
        exb += t24b * t23;
        exbd += t24bd * t23 + t24b * t23d;
        t23b = t24b * ex;
        t23bd = t24bd * ex + t24b * exd;
        y5b += t23b * (1.0 / (1.0 + y5 * y5));
        y5bd += t23bd * (1.0 / (1.0 + y5 * y5)) - t23b * (1.0 / (1.0 + y5 * y5) * (y5d * y5 + y5 *
            y5d) / (1.0 + y5 * y5));
        bxb = y5b * kx;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        bxbd = y5bd * kx + y5b * kxd;
        kxb = y5b * bx;
        kxbd = y5bd * bx + y5b * bxd;
        tb75 = svxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb75d = svxbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] + svxb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb76 = tb75 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX];
        tb76d = tb75d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] + tb75 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX];
        fz2b += tb76 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz);
        fz2bd += tb76d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + tb76 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd));
        tb77 = tb76 * fz2;
        tb77d = tb76d * fz2 + tb76 * fz2d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] += tb77;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] += tb77d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] += tb77 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] += tb77d * dfz + tb77 * dfzd;
        dfzb += tb77 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2];
        dfzbd += tb77d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] + tb77 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] += tb75 * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] += tb75d * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz)) + tb75 * (fz2d * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd)));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] += svxb * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] += svxbd * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]) + svxb *
            ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd))) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]);
        tb74 = bxb / t22;
        tb74d = (bxbd - tb74 * t22d) * (1.0 / t22);
        stiffb += tb74;
        stiffbd += tb74d;
        t22b = -(tb74 * bx);
        t22bd = -(tb74d * bx + tb74 * bxd);
        cxb += t22b * dx;
        cxbd += t22bd * dx + t22b * dxd;
        dxb += t22b * cx;
        dxbd += t22bd * cx + t22b * cxd;
        tb71 = stiffb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        tb71d = stiffbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] + stiffb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        tb72 = tb71 * t21;
        tb72d = tb71d * t21 + tb71 * t21d;
        fz2b += tb72 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz);
        fz2bd += tb72d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) + tb72 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfzd));
        tb73 = tb72 * fz2;
        tb73d = tb72d * fz2 + tb72 * fz2d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] += tb73;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] += tb73d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] += tb73 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] += tb73d * dfz + tb73 * dfzd;
        dfzb += tb73 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2];
        dfzbd += tb73d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] + tb73 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2];
        t21b = tb71 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz));
        t21bd = tb71d * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz)) + tb71 * (fz2d *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz) + fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PKX2] * dfzd)));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] += stiffb * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz) * t21);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] += stiffbd * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz) * t21) + stiffb * ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t21 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21d);
        t20b = t21b * t21;
        t20bd = t21bd * t21 + t21b * t21d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] += t20b * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] += t20bd * dfz + t20b * dfzd;
        dfzb += t20b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3];
        dfzbd += t20bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] + t20b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3];
        e2b = 0.0;
        e2bd = 0.0;
        if (MAGGI_RE(kx) > 0.0) {
          e3 = e2 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e3d = e2d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) - e2 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          y3b = exb;
          y3bd = exbd;
          exb = 0.0;
          exbd = 0.0;
          e3b = 0.0;
          e3bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e3) > 1.0) {
            y3b = 0.0;
            y3bd = 0.0;
          } else {
            e3b += y3b;
            e3bd += y3bd;
            y3b = 0.0;
            y3bd = 0.0;
          }
          e2b += e3b * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e2bd += e3bd * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) - e3b *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] -= e3b * e2;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] -= e3bd * e2 + e3b * e2d;
        } else {
          e4 = e2 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e4d = e2d * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) + e2 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          y4b = exb;
          y4bd = exbd;
          exb = 0.0;
          exbd = 0.0;
          e4b = 0.0;
          e4bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e4) > 1.0) {
            y4b = 0.0;
            y4bd = 0.0;
          } else {
            e4b += y4b;
            e4bd += y4bd;
            y4b = 0.0;
            y4bd = 0.0;
          }
          e2b += e4b * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e2bd += e4bd * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) + e4b *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] += e4b * e2;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] += e4bd * e2 + e4b * e2d;
        }
        tb69 = e2b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        tb69d = e2bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] + e2b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] += tb69;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] += tb69d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] += tb69 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] += tb69d * dfz + tb69 * dfzd;
        dfzb += tb69 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2];
        dfzbd += tb69d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] + tb69 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2];
        tb70 = tb69 * dfz;
        tb70d = tb69d * dfz + tb69 * dfzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] += tb70 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] += tb70d * dfz + tb70 * dfzd;
        dfzb += tb70 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3];
        dfzbd += tb70d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] + tb70 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3];
        dfzb += tb69 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz);
        dfzbd += tb69d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz) + tb69 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PEX3] * dfzd);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] += e2b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] += e2bd * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz) + e2b *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfzd));
        muxb = dxb * fz2;
        muxbd = dxbd * fz2 + dxb * fz2d;
        fz2b += dxb * mux;
        fz2bd += dxbd * mux + dxb * muxd;
        tb65 = muxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb65d = muxbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] + muxb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb66 = tb65 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx);
        tb66d = tb65d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) - tb65 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDX3] * gxd) * gx + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx *
            gxd);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] += tb66;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] += tb66d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] += tb66 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] += tb66d * dfz + tb66 * dfzd;
        dfzb += tb66 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2];
        dfzbd += tb66d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] + tb66 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2];
        tb67 = tb65 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz);
        tb67d = tb65d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz) + tb65 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfzd));
        tb68 = tb67 * gx;
        tb68d = tb67d * gx + tb67 * gxd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] -= tb68 * gx;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] -= tb68d * gx + tb68 * gxd;
        gxb = -(tb68 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3]);
        gxbd = -(tb68d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] + tb68 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3]);
        gxb -= tb67 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx);
        gxbd -= tb67d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx) + tb67 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDX3] * gxd);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] += muxb * ((p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] += muxbd *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx *
            gx)) + muxb * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDX2] * dfzd)) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] *
            gx * gx) - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz) *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDX3] * gxd) * gx + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx *
            gxd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] += cxb * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] += cxbd * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX] + cxb * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX] += cxb * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCX1];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX] += cxbd * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCX1] + cxb * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1];
        gamma2b += gxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        gamma2bd += gxbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] + gxb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] += gxb * gamma2;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] += gxbd * gamma2 + gxb * gamma2d;
        kappa2b += kxb;
        /* Fx0, Kx */
        kappa2bd += kxbd;
        tb64 = kxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX];
        tb64d = kxbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] + kxb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] += tb64;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] += tb64d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] += tb64 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] += tb64d * dfz + tb64 * dfzd;
        dfzb += tb64 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2];
        dfzbd += tb64d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] + tb64 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] += kxbd * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) + kxb *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfzd));
        tb63 = dfzb / fz0_2;
        tb63d = (dfzbd - tb63 * fz0_2d) * (1.0 / fz0_2);
        fz2b += tb63;
        fz2bd += tb63d;
        fz0_2b -= tb63;
        fz0_2bd -= tb63d;
        fz0_2b -= tb63 * dfz;
        fz0_2bd -= tb63d * dfz + tb63 * dfzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += r0b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += r0bd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_2b *
            p[t->tyreadr[t->wheeltyre[i]]];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_2bd *
            p[t->tyreadr[t->wheeltyre[i]]] + fz0_2b * pd[t->tyreadr[t->wheeltyre[i]]];
        pb[t->tyreadr[t->wheeltyre[i]]] += fz0_2b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO];
        pbd[t->tyreadr[t->wheeltyre[i]]] += fz0_2bd * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO] + fz0_2b * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO];
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
    z21b = gammab * (z22 / (z22 * z22 + z21 * z21));
    z21bd = gammabd * (z22 / (z22 * z22 + z21 * z21)) + gammab * ((z22d - z22 / (z22 * z22 + z21 *
        z21) * (z22d * z22 + z22 * z22d + (z21d * z21 + z21 * z21d))) / (z22 * z22 + z21 * z21));
    z22b = -(gammab * (z21 / (z22 * z22 + z21 * z21)));
    z22bd = -(gammabd * (z21 / (z22 * z22 + z21 * z21)) + gammab * ((z21d - z21 / (z22 * z22 + z21 *
        z21) * (z22d * z22 + z22 * z22d + (z21d * z21 + z21 * z21d))) / (z22 * z22 + z21 * z21)));
    tb62 = a2b / speed2;
    tb62d = (a2bd - tb62 * speed2d) * (1.0 / speed2);
    v40b = tb62 * L0;
    v40bd = tb62d * L0 + tb62 * L0d;
    L0b += tb62 * v40;
    L0bd += tb62d * v40 + tb62 * v40d;
    v41b = tb62 * L1;
    v41bd = tb62d * L1 + tb62 * L1d;
    L1b += tb62 * v41;
    L1bd += tb62d * v41 + tb62 * v41d;
    v42b = tb62 * L2;
    v42bd = tb62d * L2 + tb62 * L2d;
    L2b += tb62 * v42;
    L2bd += tb62d * v42 + tb62 * v42d;
    speed2b = -(tb62 * a2);
    speed2bd = -(tb62d * a2 + tb62 * a2d);
    tb61 = kappab / speed2;
    tb61d = (kappabd - tb61 * speed2d) * (1.0 / speed2);
    omegab = tb61 * re;
    omegabd = tb61d * re + tb61 * red;
    reb = tb61 * omega;
    rebd = tb61d * omega + tb61 * omegad;
    vxb -= tb61;
    vxbd -= tb61d;
    speed2b -= tb61 * kappa;
    speed2bd -= tb61d * kappa + tb61 * kappad;
    yb = speed2b;
    ybd = speed2bd;
    /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
    if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      vxb += yb;
      vxbd += ybd;
      yb = 0.0;
      ybd = 0.0;
    } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      vxb -= yb;
      vxbd -= ybd;
      yb = 0.0;
      ybd = 0.0;
    } else {
      p5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      p5d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      t19 = vx * vx / p5;
      t19d = (vxd * vx + vx * vxd - t19 * p5d) * (1.0 / p5);
      tb60 = yb * 0.5;
      tb60d = ybd * 0.5;
      p5b = tb60;
      p5bd = tb60d;
      t19b = tb60;
      t19bd = tb60d;
      yb = 0.0;
      ybd = 0.0;
      tb59 = t19b / p5;
      tb59d = (t19bd - tb59 * p5d) * (1.0 / p5);
      vxb += tb59 * vx;
      vxbd += tb59d * vx + tb59 * vxd;
      vxb += tb59 * vx;
      vxbd += tb59d * vx + tb59 * vxd;
      p5b -= tb59 * t19;
      p5bd -= tb59d * t19 + tb59 * t19d;
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW] += p5b;
      pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW] += p5bd;
    }
    p4b = reb;
    p4bd = rebd;
    t16b = -(reb * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio));
    t16bd = -(rebd * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio) + reb *
        (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 + p[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_DREFF] * t18d + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratiod)));
    tb58 = reb * t16;
    tb58d = rebd * t16 + reb * t16d;
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] -= tb58 * t18;
    pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] -= tb58d * t18 + tb58 * t18d;
    t18b = -(tb58 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF]);
    t18bd = -(tb58d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] + tb58 *
        pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF]);
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] -= tb58 * ratio;
    pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] -= tb58d * ratio + tb58 * ratiod;
    ratiob = -(tb58 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF]);
    ratiobd = -(tb58d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] + tb58 *
        pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF]);
    t17b = t18b * (1.0 / (1.0 + t17 * t17));
    t17bd = t18bd * (1.0 / (1.0 + t17 * t17)) - t18b * (1.0 / (1.0 + t17 * t17) * (t17d * t17 + t17
        * t17d) / (1.0 + t17 * t17));
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] += t17b * ratio;
    pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] += t17bd * ratio + t17b * ratiod;
    ratiob += t17b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF];
    ratiobd += t17bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] + t17b *
        pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF];
    tb57 = t16b / p3;
    tb57d = (t16bd - tb57 * p3d) * (1.0 / p3);
    fz0b = tb57;
    fz0bd = tb57d;
    p3b = -(tb57 * t16);
    p3bd = -(tb57d * t16 + tb57 * t16d);
    tb56 = ratiob / fz0;
    tb56d = (ratiobd - tb56 * fz0d) * (1.0 / fz0);
    fzb += tb56;
    fzbd += tb56d;
    fz0b -= tb56 * ratio;
    fz0bd -= tb56d * ratio + tb56 * ratiod;
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0b * p[t->tyreadr[t->wheeltyre[i]]];
    pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0bd * p[t->tyreadr[t->wheeltyre[i]]] +
        fz0b * pd[t->tyreadr[t->wheeltyre[i]]];
    pb[t->tyreadr[t->wheeltyre[i]]] += fz0b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO];
    pbd[t->tyreadr[t->wheeltyre[i]]] += fz0bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] +
        fz0b * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO];
    p3b += fzb * (p4 - z20);
    p3bd += fzbd * (p4 - z20) + fzb * (p4d - z20d);
    tb55 = fzb * p3;
    tb55d = fzbd * p3 + fzb * p3d;
    p4b += tb55;
    p4bd += tb55d;
    z20b = -tb55;
    z20bd = -tb55d;
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
    pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzbd * rhov + fzb * rhovd;
    rhovb = fzb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING];
    rhovbd = fzbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] + fzb *
        pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING];
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += p4b;
    pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += p4bd;
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += p3b;
    pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += p3bd;
    tb52 = omegab * u30;
    tb52d = omegabd * u30 + omegab * u30d;
    Zb[a6][3] += tb52;
    Zbd[a6][3] += tb52d;
    Z_b43b = -tb52;
    Z_b43bd = -tb52d;
    u30b = omegab * (Z[a6][3] - Z_b43);
    u30bd = omegabd * (Z[a6][3] - Z_b43) + omegab * (Zd[a6][3] - Z_b43d);
    tb53 = omegab * u31;
    tb53d = omegabd * u31 + omegab * u31d;
    Zb[a6][4] += tb53;
    Zbd[a6][4] += tb53d;
    Z_b44b = -tb53;
    Z_b44bd = -tb53d;
    u31b = omegab * (Z[a6][4] - Z_b44);
    u31bd = omegabd * (Z[a6][4] - Z_b44) + omegab * (Zd[a6][4] - Z_b44d);
    tb54 = omegab * u32;
    tb54d = omegabd * u32 + omegab * u32d;
    Zb[a6][5] += tb54;
    Zbd[a6][5] += tb54d;
    Z_b45b = -tb54;
    Z_b45bd = -tb54d;
    u32b = omegab * (Z[a6][5] - Z_b45);
    u32bd = omegabd * (Z[a6][5] - Z_b45) + omegab * (Zd[a6][5] - Z_b45d);
    tb51 = rhovb / z22;
    tb51d = (rhovbd - tb51 * z22d) * (1.0 / z22);
    v40b -= tb51 * N0;
    v40bd -= tb51d * N0 + tb51 * N0d;
    N0b -= tb51 * v40;
    N0bd -= tb51d * v40 + tb51 * v40d;
    v41b -= tb51 * N1;
    v41bd -= tb51d * N1;
    v42b -= tb51 * N2;
    v42bd -= tb51d * N2 + tb51 * N2d;
    N2b -= tb51 * v42;
    N2bd -= tb51d * v42 + tb51 * v42d;
    z22b -= tb51 * rhov;
    z22bd -= tb51d * rhov + tb51 * rhovd;
    v40b += vxb * T0;
    v40bd += vxbd * T0 + vxb * T0d;
    T0b += vxb * v40;
    T0bd += vxbd * v40 + vxb * v40d;
    v41b += vxb * T1;
    v41bd += vxbd * T1 + vxb * T1d;
    T1b += vxb * v41;
    T1bd += vxbd * v41 + vxb * v41d;
    v42b += vxb * T2;
    v42bd += vxbd * T2 + vxb * T2d;
    T2b += vxb * v42;
    T2bd += vxbd * v42 + vxb * v42d;
    rvb[t->wheelpoint[i]][2] += v42b;
    rvbd[t->wheelpoint[i]][2] += v42bd;
    vr2b = v42b;
    vr2bd = v42bd;
    rvb[t->wheelpoint[i]][1] += v41b;
    rvbd[t->wheelpoint[i]][1] += v41bd;
    vr1b = v41b;
    vr1bd = v41bd;
    rvb[t->wheelpoint[i]][0] += v40b;
    rvbd[t->wheelpoint[i]][0] += v40bd;
    vr0b = v40b;
    vr0bd = v40bd;
    wr0b = vr2b * arm1;
    wr0bd = vr2bd * arm1 + vr2b * arm1d;
    arm1b += vr2b * wr0;
    arm1bd += vr2bd * wr0 + vr2b * wr0d;
    wr1b = -(vr2b * arm0);
    wr1bd = -(vr2bd * arm0 + vr2b * arm0d);
    arm0b -= vr2b * wr1;
    arm0bd -= vr2bd * wr1 + vr2b * wr1d;
    wr2b = vr1b * arm0;
    wr2bd = vr1bd * arm0 + vr1b * arm0d;
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
    Z_b45b += wr2b;
    Z_b45bd += wr2bd;
    Zb[b4][5] += Z_b45b;
    Zbd[b4][5] += Z_b45bd;
    Z_b44b += wr1b;
    Z_b44bd += wr1bd;
    Zb[b4][4] += Z_b44b;
    Zbd[b4][4] += Z_b44bd;
    Z_b43b += wr0b;
    Z_b43bd += wr0bd;
    Zb[b4][3] += Z_b43b;
    Zbd[b4][3] += Z_b43bd;
    wb = z22b;
    wbd = z22bd;
    c3b = z21b;
    c3bd = z21bd;
    r2b = z20b;
    r2bd = z20bd;
    n42b = N2b;
    n42bd = N2bd;
    along2b = T2b;
    along2bd = T2bd;
    tb49 = arm2b / w;
    tb49d = (arm2bd - tb49 * wd) * (1.0 / w);
    r2b += tb49 * (c3 * u32 - n42);
    r2bd += tb49d * (c3 * u32 - n42) + tb49 * (c3d * u32 + c3 * u32d - n42d);
    tb50 = tb49 * r2;
    tb50d = tb49d * r2 + tb49 * r2d;
    c3b += tb50 * u32;
    c3bd += tb50d * u32 + tb50 * u32d;
    u32b += tb50 * c3;
    u32bd += tb50d * c3 + tb50 * c3d;
    n42b -= tb50;
    n42bd -= tb50d;
    wb -= tb49 * arm2;
    wbd -= tb49d * arm2 + tb49 * arm2d;
    along1b = T1b;
    along1bd = T1bd;
    tb47 = arm1b / w;
    tb47d = (arm1bd - tb47 * wd) * (1.0 / w);
    r2b += tb47 * (c3 * u31 - n41);
    r2bd += tb47d * (c3 * u31 - n41) + tb47 * (c3d * u31 + c3 * u31d);
    tb48 = tb47 * r2;
    tb48d = tb47d * r2 + tb47 * r2d;
    c3b += tb48 * u31;
    c3bd += tb48d * u31 + tb48 * u31d;
    u31b += tb48 * c3;
    u31bd += tb48d * c3 + tb48 * c3d;
    wb -= tb47 * arm1;
    wbd -= tb47d * arm1 + tb47 * arm1d;
    n40b = N0b;
    n40bd = N0bd;
    along0b = T0b;
    along0bd = T0bd;
    tb45 = arm0b / w;
    tb45d = (arm0bd - tb45 * wd) * (1.0 / w);
    r2b += tb45 * (c3 * u30 - n40);
    r2bd += tb45d * (c3 * u30 - n40) + tb45 * (c3d * u30 + c3 * u30d - n40d);
    tb46 = tb45 * r2;
    tb46d = tb45d * r2 + tb45 * r2d;
    c3b += tb46 * u30;
    c3bd += tb46d * u30 + tb46 * u30d;
    u30b += tb46 * c3;
    u30bd += tb46d * c3 + tb46 * c3d;
    n40b -= tb46;
    n40bd -= tb46d;
    wb -= tb45 * arm0;
    wbd -= tb45d * arm0 + tb45 * arm0d;
    n40b += L2b * along1;
    n40bd += L2bd * along1 + L2b * along1d;
    along1b += L2b * n40;
    along1bd += L2bd * n40 + L2b * n40d;
    along0b -= L2b * n41;
    along0bd -= L2bd * n41;
    n42b += L1b * along0;
    n42bd += L1bd * along0 + L1b * along0d;
    along0b += L1b * n42;
    along0bd += L1bd * n42 + L1b * n42d;
    n40b -= L1b * along2;
    n40bd -= L1bd * along2 + L1b * along2d;
    along2b -= L1b * n40;
    along2bd -= L1bd * n40 + L1b * n40d;
    along2b += L0b * n41;
    along2bd += L0bd * n41;
    n42b -= L0b * along1;
    n42bd -= L0bd * along1 + L0b * along1d;
    along1b -= L0b * n42;
    along1bd -= L0bd * n42 + L0b * n42d;
    tb44 = along2b / w;
    tb44d = (along2bd - tb44 * wd) * (1.0 / w);
    un2b = tb44;
    un2bd = tb44d;
    wb -= tb44 * along2;
    wbd -= tb44d * along2 + tb44 * along2d;
    tb43 = along1b / w;
    tb43d = (along1bd - tb43 * wd) * (1.0 / w);
    un1b = tb43;
    un1bd = tb43d;
    wb -= tb43 * along1;
    wbd -= tb43d * along1 + tb43 * along1d;
    tb42 = along0b / w;
    tb42d = (along0bd - tb42 * wd) * (1.0 / w);
    un0b = tb42;
    un0bd = tb42d;
    wb -= tb42 * along0;
    wbd -= tb42d * along0 + tb42 * along0d;
    tb39 = r2b / w;
    tb39d = (r2bd - tb39 * wd) * (1.0 / w);
    tb40 = tb39 * n40;
    tb40d = tb39d * n40 + tb39 * n40d;
    g20b = tb40;
    g20bd = tb40d;
    x2b = -tb40;
    x2bd = -tb40d;
    n40b += tb39 * (g20 - x2);
    n40bd += tb39d * (g20 - x2) + tb39 * (g20d - x2d);
    tb41 = tb39 * n42;
    tb41d = tb39d * n42 + tb39 * n42d;
    g22b = tb41;
    g22bd = tb41d;
    h10b = -tb41;
    h10bd = -tb41d;
    n42b += tb39 * (g22 - h10);
    n42bd += tb39d * (g22 - h10) + tb39 * (g22d - h10d);
    wb -= tb39 * r2;
    wbd -= tb39d * r2 + tb39 * r2d;
    t15b = wb * (1.0 / (2.0 * w));
    t15bd = wbd * (1.0 / (2.0 * w)) - wb * (1.0 / (2.0 * w) * (2.0 * wd) / (2.0 * w));
    un0b += t15b * un0;
    un0bd += t15bd * un0 + t15b * un0d;
    un0b += t15b * un0;
    un0bd += t15bd * un0 + t15b * un0d;
    un1b += t15b * un1;
    un1bd += t15bd * un1 + t15b * un1d;
    un1b += t15b * un1;
    un1bd += t15bd * un1 + t15b * un1d;
    un2b += t15b * un2;
    un2bd += t15bd * un2 + t15b * un2d;
    un2b += t15b * un2;
    un2bd += t15bd * un2 + t15b * un2d;
    u30b += un2b * n41;
    u30bd += un2bd * n41;
    u31b -= un2b * n40;
    u31bd -= un2bd * n40 + un2b * n40d;
    n40b -= un2b * u31;
    n40bd -= un2bd * u31 + un2b * u31d;
    u32b += un1b * n40;
    u32bd += un1bd * n40 + un1b * n40d;
    n40b += un1b * u32;
    n40bd += un1bd * u32 + un1b * u32d;
    u30b -= un1b * n42;
    u30bd -= un1bd * n42 + un1b * n42d;
    n42b -= un1b * u30;
    n42bd -= un1bd * u30 + un1b * u30d;
    u31b += un0b * n42;
    u31bd += un0bd * n42 + un0b * n42d;
    n42b += un0b * u31;
    n42bd += un0bd * u31 + un0b * u31d;
    u32b -= un0b * n41;
    u32bd -= un0bd * n41;
    u30b += c3b * n40;
    u30bd += c3bd * n40 + c3b * n40d;
    n40b += c3b * u30;
    n40bd += c3bd * u30 + c3b * u30d;
    u31b += c3b * n41;
    u31bd += c3bd * n41;
    u32b += c3b * n42;
    u32bd += c3bd * n42 + c3b * n42d;
    n42b += c3b * u32;
    n42bd += c3bd * u32 + c3b * u32d;
    tb38 = n42b / s2;
    tb38d = (n42bd - tb38 * s2d) * (1.0 / s2);
    s2b = -(tb38 * n42);
    s2bd = -(tb38d * n42 + tb38 * n42d);
    tb37 = n40b / s2;
    tb37d = (n40bd - tb37 * s2d) * (1.0 / s2);
    h11b = -tb37;
    h11bd = -tb37d;
    s2b -= tb37 * n40;
    s2bd -= tb37d * n40 + tb37 * n40d;
    t14b = s2b * (1.0 / (2.0 * s2));
    t14bd = s2bd * (1.0 / (2.0 * s2)) - s2b * (1.0 / (2.0 * s2) * (2.0 * s2d) / (2.0 * s2));
    h11b += t14b * h11;
    h11bd += t14bd * h11 + t14b * h11d;
    h11b += t14b * h11;
    h11bd += t14bd * h11 + t14b * h11d;
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11_3 = p[t->roadadr[k11]];
      p_k11_3d = pd[t->roadadr[k11]];
      p_k11_3b = h11b;
      p_k11_3bd = h11bd;
      h11b = 0.0;
      h11bd = 0.0;
      p_k11_3b += h10b * x2;
      p_k11_3bd += h10bd * x2 + h10b * x2d;
      x2b += h10b * p_k11_3;
      x2bd += h10bd * p_k11_3 + h10b * p_k11_3d;
      h10b = 0.0;
      h10bd = 0.0;
      pb[t->roadadr[k11]] += p_k11_3b;
      pbd[t->roadadr[k11]] += p_k11_3bd;
    } else {
      p_k111_2 = p[t->roadadr[k11] + 1];
      p_k111_2d = pd[t->roadadr[k11] + 1];
      t9 = 6.28318530717958647693 * x2 / p_k111_2;
      t9d = (6.28318530717958647693 * x2d - t9 * p_k111_2d) * (1.0 / p_k111_2);
      t10 = sin(t9);
      t10d = cos(t9) * t9d;
      p_k11_4 = p[t->roadadr[k11]];
      p_k11_4d = pd[t->roadadr[k11]];
      t11 = p_k11_4 * 6.28318530717958647693 / p_k111_2;
      t11d = (p_k11_4d * 6.28318530717958647693 - t11 * p_k111_2d) * (1.0 / p_k111_2);
      t12 = 6.28318530717958647693 * x2 / p_k111_2;
      t12d = (6.28318530717958647693 * x2d - t12 * p_k111_2d) * (1.0 / p_k111_2);
      t13 = cos(t12);
      t13d = -(sin(t12) * t12d);
      t11b = h11b * t13;
      t11bd = h11bd * t13 + h11b * t13d;
      t13b = h11b * t11;
      t13bd = h11bd * t11 + h11b * t11d;
      h11b = 0.0;
      h11bd = 0.0;
      t12b = -(t13b * sin(t12));
      t12bd = -(t13bd * sin(t12) + t13b * (cos(t12) * t12d));
      tb36 = t12b / p_k111_2;
      tb36d = (t12bd - tb36 * p_k111_2d) * (1.0 / p_k111_2);
      x2b += tb36 * 6.28318530717958647693;
      x2bd += tb36d * 6.28318530717958647693;
      p_k111_2b = -(tb36 * t12);
      p_k111_2bd = -(tb36d * t12 + tb36 * t12d);
      tb35 = t11b / p_k111_2;
      tb35d = (t11bd - tb35 * p_k111_2d) * (1.0 / p_k111_2);
      p_k11_4b = tb35 * 6.28318530717958647693;
      p_k11_4bd = tb35d * 6.28318530717958647693;
      p_k111_2b -= tb35 * t11;
      p_k111_2bd -= tb35d * t11 + tb35 * t11d;
      p_k11_4b += h10b * t10;
      p_k11_4bd += h10bd * t10 + h10b * t10d;
      t10b = h10b * p_k11_4;
      t10bd = h10bd * p_k11_4 + h10b * p_k11_4d;
      h10b = 0.0;
      h10bd = 0.0;
      pb[t->roadadr[k11]] += p_k11_4b;
      pbd[t->roadadr[k11]] += p_k11_4bd;
      t9b = t10b * cos(t9);
      t9bd = t10bd * cos(t9) - t10b * (sin(t9) * t9d);
      tb34 = t9b / p_k111_2;
      tb34d = (t9bd - tb34 * p_k111_2d) * (1.0 / p_k111_2);
      x2b += tb34 * 6.28318530717958647693;
      x2bd += tb34d * 6.28318530717958647693;
      p_k111_2b -= tb34 * t9;
      p_k111_2bd -= tb34d * t9 + tb34 * t9d;
      pb[t->roadadr[k11] + 1] += p_k111_2b;
      pbd[t->roadadr[k11] + 1] += p_k111_2bd;
    }
    g20b += x2b;
    g20bd += x2bd;
    t8b = x2b * (g22 - h00);
    t8bd = x2bd * (g22 - h00) + x2b * (g22d - h00d);
    tb33 = x2b * t8;
    tb33d = x2bd * t8 + x2b * t8d;
    g22b += tb33;
    g22bd += tb33d;
    h00b = -tb33;
    h00bd = -tb33d;
    tb32 = t8b / t7;
    tb32d = (t8bd - tb32 * t7d) * (1.0 / t7);
    u32b += tb32 * u30;
    u32bd += tb32d * u30 + tb32 * u30d;
    u30b += tb32 * u32;
    u30bd += tb32d * u32 + tb32 * u32d;
    t7b = -(tb32 * t8);
    t7bd = -(tb32d * t8 + tb32 * t8d);
    u30b += t7b * u30;
    u30bd += t7bd * u30 + t7b * u30d;
    u30b += t7b * u30;
    u30bd += t7bd * u30 + t7b * u30d;
    u31b += t7b * u31;
    u31bd += t7bd * u31 + t7b * u31d;
    u31b += t7b * u31;
    u31bd += t7bd * u31 + t7b * u31d;
    x3b = 0.0;
    x3bd = 0.0;
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11 = p[t->roadadr[k11]];
      p_k11d = pd[t->roadadr[k11]];
      p_k11b = h00b * x3;
      p_k11bd = h00bd * x3 + h00b * x3d;
      x3b += h00b * p_k11;
      x3bd += h00bd * p_k11 + h00b * p_k11d;
      h00b = 0.0;
      h00bd = 0.0;
      pb[t->roadadr[k11]] += p_k11b;
      pbd[t->roadadr[k11]] += p_k11bd;
    } else {
      p_k111 = p[t->roadadr[k11] + 1];
      p_k111d = pd[t->roadadr[k11] + 1];
      t5 = 6.28318530717958647693 * x3 / p_k111;
      t5d = (6.28318530717958647693 * x3d - t5 * p_k111d) * (1.0 / p_k111);
      t6 = sin(t5);
      t6d = cos(t5) * t5d;
      p_k11_2 = p[t->roadadr[k11]];
      p_k11_2d = pd[t->roadadr[k11]];
      p_k11_2b = h00b * t6;
      p_k11_2bd = h00bd * t6 + h00b * t6d;
      t6b = h00b * p_k11_2;
      t6bd = h00bd * p_k11_2 + h00b * p_k11_2d;
      h00b = 0.0;
      h00bd = 0.0;
      pb[t->roadadr[k11]] += p_k11_2b;
      pbd[t->roadadr[k11]] += p_k11_2bd;
      t5b = t6b * cos(t5);
      t5bd = t6bd * cos(t5) - t6b * (sin(t5) * t5d);
      tb31 = t5b / p_k111;
      tb31d = (t5bd - tb31 * p_k111d) * (1.0 / p_k111);
      x3b += tb31 * 6.28318530717958647693;
      x3bd += tb31d * 6.28318530717958647693;
      p_k111b = -(tb31 * t5);
      p_k111bd = -(tb31d * t5 + tb31 * t5d);
      pb[t->roadadr[k11] + 1] += p_k111b;
      pbd[t->roadadr[k11] + 1] += p_k111bd;
    }
    g20b += x3b;
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
    g20bd += x3bd;
    rb[t->wheelpoint[i]][2] += g22b;
    rbd[t->wheelpoint[i]][2] += g22bd;
    rb[t->roadpoint[k11]][2] -= g22b;
    rbd[t->roadpoint[k11]][2] -= g22bd;
    rb[t->wheelpoint[i]][0] += g20b;
    rbd[t->wheelpoint[i]][0] += g20bd;
    rb[t->roadpoint[k11]][0] -= g20b;
    rbd[t->roadpoint[k11]][0] -= g20bd;
    tb30 = u32b / n3;
    tb30d = (u32bd - tb30 * n3d) * (1.0 / n3);
    ua2b = tb30;
    ua2bd = tb30d;
    n3b = -(tb30 * u32);
    n3bd = -(tb30d * u32 + tb30 * u32d);
    tb29 = u31b / n3;
    tb29d = (u31bd - tb29 * n3d) * (1.0 / n3);
    ua1b = tb29;
    ua1bd = tb29d;
    n3b -= tb29 * u31;
    n3bd -= tb29d * u31 + tb29 * u31d;
    tb28 = u30b / n3;
    tb28d = (u30bd - tb28 * n3d) * (1.0 / n3);
    ua0b = tb28;
    ua0bd = tb28d;
    n3b -= tb28 * u30;
    n3bd -= tb28d * u30 + tb28 * u30d;
    t4b = n3b * (1.0 / (2.0 * n3));
    t4bd = n3bd * (1.0 / (2.0 * n3)) - n3b * (1.0 / (2.0 * n3) * (2.0 * n3d) / (2.0 * n3));
    ua0b += t4b * ua0;
    ua0bd += t4bd * ua0 + t4b * ua0d;
    ua0b += t4b * ua0;
    ua0bd += t4bd * ua0 + t4b * ua0d;
    ua1b += t4b * ua1;
    ua1bd += t4bd * ua1 + t4b * ua1d;
    ua1b += t4b * ua1;
    ua1bd += t4bd * ua1 + t4b * ua1d;
    ua2b += t4b * ua2;
    ua2bd += t4bd * ua2 + t4b * ua2d;
    ua2b += t4b * ua2;
    ua2bd += t4bd * ua2 + t4b * ua2d;
    Ab[a6][6] += ua2b * a00;
    Abd[a6][6] += ua2bd * a00 + ua2b * a00d;
    a00b = ua2b * A[a6][6];
    a00bd = ua2bd * A[a6][6] + ua2b * Ad[a6][6];
    Ab[a6][7] += ua2b * a01;
    Abd[a6][7] += ua2bd * a01 + ua2b * a01d;
    a01b = ua2b * A[a6][7];
    a01bd = ua2bd * A[a6][7] + ua2b * Ad[a6][7];
    Ab[a6][8] += ua2b * a02;
    Abd[a6][8] += ua2bd * a02 + ua2b * a02d;
    a02b = ua2b * A[a6][8];
    a02bd = ua2bd * A[a6][8] + ua2b * Ad[a6][8];
    Ab[a6][3] += ua1b * a00;
    Abd[a6][3] += ua1bd * a00 + ua1b * a00d;
    a00b += ua1b * A[a6][3];
    a00bd += ua1bd * A[a6][3] + ua1b * Ad[a6][3];
    Ab[a6][4] += ua1b * a01;
    Abd[a6][4] += ua1bd * a01 + ua1b * a01d;
    a01b += ua1b * A[a6][4];
    a01bd += ua1bd * A[a6][4] + ua1b * Ad[a6][4];
    Ab[a6][5] += ua1b * a02;
    Abd[a6][5] += ua1bd * a02 + ua1b * a02d;
    a02b += ua1b * A[a6][5];
    a02bd += ua1bd * A[a6][5] + ua1b * Ad[a6][5];
    Ab[a6][0] += ua0b * a00;
    Abd[a6][0] += ua0bd * a00 + ua0b * a00d;
    a00b += ua0b * A[a6][0];
    a00bd += ua0bd * A[a6][0] + ua0b * Ad[a6][0];
    Ab[a6][1] += ua0b * a01;
    Abd[a6][1] += ua0bd * a01 + ua0b * a01d;
    a01b += ua0b * A[a6][1];
    a01bd += ua0bd * A[a6][1] + ua0b * Ad[a6][1];
    Ab[a6][2] += ua0b * a02;
    Abd[a6][2] += ua0bd * a02 + ua0b * a02d;
    a02b += ua0b * A[a6][2];
    a02bd += ua0bd * A[a6][2] + ua0b * Ad[a6][2];
    pb[t->wheelaxis[i] + 2] += a02b;
    pbd[t->wheelaxis[i] + 2] += a02bd;
    pb[t->wheelaxis[i] + 1] += a01b;
    pbd[t->wheelaxis[i] + 1] += a01bd;
    pb[t->wheelaxis[i]] += a00b;
    pbd[t->wheelaxis[i]] += a00bd;
  }
  for (i = t->nforce - 1; i >= 0; --i) {
    adr2 = t->forceadr[i];
    if (t->forcefun[i] >= 0) {
      s = fun[t->forcefun[i]][0];
      sd = fund[t->forcefun[i]][0];
    } else {
      s = 1.0;
      sd = 0.0;
    }
    sb = 0.0;
    sbd = 0.0;
    if (t->forcekind[i] == MAGGI_FORCE_JOINT) {
      a5 = t->forceq[i];
      p_adr2 = p[adr2];
      p_adr2d = pd[adr2];
      tb16 = taub[a5];
      tb16d = taubd[a5];
      p_adr2b = tb16 * s;
      p_adr2bd = tb16d * s + tb16 * sd;
      sb += tb16 * p_adr2;
      sbd += tb16d * p_adr2 + tb16 * p_adr2d;
      pb[adr2] += p_adr2b;
      pbd[adr2] += p_adr2bd;
    } else {
      a5_2 = t->forcebody[i];
      b3 = t->forcereaction[i];
      if (t->forcekind[i] == MAGGI_FORCE_DRAG) {
        u20 = rv[t->forcepoint[i]][0] - p[adr2 + MAGGI_DRAG_WIND];
        u20d = rvd[t->forcepoint[i]][0] - pd[adr2 + MAGGI_DRAG_WIND];
        u21 = rv[t->forcepoint[i]][1] - p[adr2 + MAGGI_DRAG_WIND + 1];
        u21d = rvd[t->forcepoint[i]][1] - pd[adr2 + MAGGI_DRAG_WIND + 1];
        u22 = rv[t->forcepoint[i]][2] - p[adr2 + MAGGI_DRAG_WIND + 2];
        u22d = rvd[t->forcepoint[i]][2] - pd[adr2 + MAGGI_DRAG_WIND + 2];
        p2 = p[adr2 + MAGGI_DRAG_LOW];
        p2d = pd[adr2 + MAGGI_DRAG_LOW];
        t3 = u20 * u20 + u21 * u21 + u22 * u22 + p2 * p2;
        t3d = u20d * u20 + u20 * u20d + (u21d * u21 + u21 * u21d) + (u22d * u22 + u22 * u22d) + (p2d
            * p2 + p2 * p2d);
        speed = sqrt(t3);
        speedd = 1.0 / (2.0 * speed) * t3d;
        c = 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * s;
        cd = ((0.5 * pd[adr2] * p[adr2 + MAGGI_DRAG_C] + 0.5 * p[adr2] * pd[adr2 + MAGGI_DRAG_C]) *
            p[adr2 + MAGGI_DRAG_AREA] + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * pd[adr2 +
            MAGGI_DRAG_AREA]) * s + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 +
            MAGGI_DRAG_AREA] * sd;
        g0 = -c * speed * u20;
        g0d = (-(cd * speed) - c * speedd) * u20 + -c * speed * u20d;
        g1 = -c * speed * u21;
        g1d = (-(cd * speed) - c * speedd) * u21 + -c * speed * u21d;
        g2_2 = -c * speed * u22;
        g2_2d = (-(cd * speed) - c * speedd) * u22 + -c * speed * u22d;
      } else {
        c20 = p[adr2] * s;
        c20d = pd[adr2] * s + p[adr2] * sd;
        c21 = p[adr2 + 1] * s;
        c21d = pd[adr2 + 1] * s + p[adr2 + 1] * sd;
        c22 = p[adr2 + 2] * s;
        c22d = pd[adr2 + 2] * s + p[adr2 + 2] * sd;
        if (t->forcekind[i] == MAGGI_FORCE_BODY || t->forcekind[i] == MAGGI_TORQUE_BODY) {
          g0 = A[a5_2][0] * c20 + A[a5_2][1] * c21 + A[a5_2][2] * c22;
          g0d = Ad[a5_2][0] * c20 + A[a5_2][0] * c20d + (Ad[a5_2][1] * c21 + A[a5_2][1] * c21d) +
              (Ad[a5_2][2] * c22 + A[a5_2][2] * c22d);
          g1 = A[a5_2][3] * c20 + A[a5_2][4] * c21 + A[a5_2][5] * c22;
          g1d = Ad[a5_2][3] * c20 + A[a5_2][3] * c20d + (Ad[a5_2][4] * c21 + A[a5_2][4] * c21d) +
              (Ad[a5_2][5] * c22 + A[a5_2][5] * c22d);
          g2_2 = A[a5_2][6] * c20 + A[a5_2][7] * c21 + A[a5_2][8] * c22;
          g2_2d = Ad[a5_2][6] * c20 + A[a5_2][6] * c20d + (Ad[a5_2][7] * c21 + A[a5_2][7] * c21d) +
              (Ad[a5_2][8] * c22 + A[a5_2][8] * c22d);
        } else {
          g0 = c20;
          g0d = c20d;
          g1 = c21;
          g1d = c21d;
          g2_2 = c22;
          g2_2d = c22d;
        }
      }
      g0b = 0.0;
      g0bd = 0.0;
      g1b = 0.0;
      g1bd = 0.0;
      g2_2b = 0.0;
      g2_2bd = 0.0;
      if (t->forcepoint[i] >= 0) {
        back20 = -g0;
        back20d = -g0d;
        back21 = -g1;
        back21d = -g1d;
        back22 = -g2_2;
        back22d = -g2_2d;
        r_i1 = r[t->forcepoint[i]][1];
        r_i1d = rd[t->forcepoint[i]][1];
        r_i2 = r[t->forcepoint[i]][2];
        r_i2d = rd[t->forcepoint[i]][2];
        r_i0 = r[t->forcepoint[i]][0];
        r_i0d = rd[t->forcepoint[i]][0];
        tb27 = Qb[b3][5];
        tb27d = Qbd[b3][5];
        r_i0b = tb27 * back21;
        r_i0bd = tb27d * back21 + tb27 * back21d;
        back21b = tb27 * r_i0;
        back21bd = tb27d * r_i0 + tb27 * r_i0d;
        r_i1b = -(tb27 * back20);
        r_i1bd = -(tb27d * back20 + tb27 * back20d);
        back20b = -(tb27 * r_i1);
        back20bd = -(tb27d * r_i1 + tb27 * r_i1d);
        tb26 = Qb[b3][4];
        tb26d = Qbd[b3][4];
        r_i2b = tb26 * back20;
        r_i2bd = tb26d * back20 + tb26 * back20d;
        back20b += tb26 * r_i2;
        back20bd += tb26d * r_i2 + tb26 * r_i2d;
        r_i0b -= tb26 * back22;
        r_i0bd -= tb26d * back22 + tb26 * back22d;
        back22b = -(tb26 * r_i0);
        back22bd = -(tb26d * r_i0 + tb26 * r_i0d);
        tb25 = Qb[b3][3];
        tb25d = Qbd[b3][3];
        r_i1b += tb25 * back22;
        r_i1bd += tb25d * back22 + tb25 * back22d;
        back22b += tb25 * r_i1;
        back22bd += tb25d * r_i1 + tb25 * r_i1d;
        r_i2b -= tb25 * back21;
        r_i2bd -= tb25d * back21 + tb25 * back21d;
        back21b -= tb25 * r_i2;
        back21bd -= tb25d * r_i2 + tb25 * r_i2d;
        back22b += Qb[b3][2];
        back22bd += Qbd[b3][2];
        back21b += Qb[b3][1];
        back21bd += Qbd[b3][1];
        back20b += Qb[b3][0];
        back20bd += Qbd[b3][0];
        tb24 = Qb[a5_2][5];
        tb24d = Qbd[a5_2][5];
        r_i0b += tb24 * g1;
        r_i0bd += tb24d * g1 + tb24 * g1d;
        g1b += tb24 * r_i0;
        g1bd += tb24d * r_i0 + tb24 * r_i0d;
        r_i1b -= tb24 * g0;
        r_i1bd -= tb24d * g0 + tb24 * g0d;
        g0b -= tb24 * r_i1;
        g0bd -= tb24d * r_i1 + tb24 * r_i1d;
        tb23 = Qb[a5_2][4];
        tb23d = Qbd[a5_2][4];
        r_i2b += tb23 * g0;
        r_i2bd += tb23d * g0 + tb23 * g0d;
        g0b += tb23 * r_i2;
        g0bd += tb23d * r_i2 + tb23 * r_i2d;
        r_i0b -= tb23 * g2_2;
        r_i0bd -= tb23d * g2_2 + tb23 * g2_2d;
        g2_2b -= tb23 * r_i0;
        g2_2bd -= tb23d * r_i0 + tb23 * r_i0d;
        rb[t->forcepoint[i]][0] += r_i0b;
        rbd[t->forcepoint[i]][0] += r_i0bd;
        tb22 = Qb[a5_2][3];
        tb22d = Qbd[a5_2][3];
        r_i1b += tb22 * g2_2;
        r_i1bd += tb22d * g2_2 + tb22 * g2_2d;
        g2_2b += tb22 * r_i1;
        g2_2bd += tb22d * r_i1 + tb22 * r_i1d;
        r_i2b -= tb22 * g1;
        r_i2bd -= tb22d * g1 + tb22 * g1d;
        g1b -= tb22 * r_i2;
        g1bd -= tb22d * r_i2 + tb22 * r_i2d;
        rb[t->forcepoint[i]][2] += r_i2b;
        rbd[t->forcepoint[i]][2] += r_i2bd;
        rb[t->forcepoint[i]][1] += r_i1b;
        rbd[t->forcepoint[i]][1] += r_i1bd;
        g2_2b += Qb[a5_2][2];
        g2_2bd += Qbd[a5_2][2];
        g1b += Qb[a5_2][1];
        g1bd += Qbd[a5_2][1];
        g0b += Qb[a5_2][0];
        g0bd += Qbd[a5_2][0];
        g2_2b -= back22b;
        g2_2bd -= back22bd;
        g1b -= back21b;
        g1bd -= back21bd;
        g0b -= back20b;
        /* force at r, or pure torque, on one body and back on another; returns its power */
        g0bd -= back20bd;
      } else {
        g2_2b -= Qb[b3][5];
        g2_2bd -= Qbd[b3][5];
        g2_2b += Qb[a5_2][5];
        g2_2bd += Qbd[a5_2][5];
        g1b -= Qb[b3][4];
        g1bd -= Qbd[b3][4];
        g1b += Qb[a5_2][4];
        g1bd += Qbd[a5_2][4];
        g0b -= Qb[b3][3];
        g0bd -= Qbd[b3][3];
        g0b += Qb[a5_2][3];
        g0bd += Qbd[a5_2][3];
      }
      if (t->forcekind[i] == MAGGI_FORCE_DRAG) {
        u20 = rv[t->forcepoint[i]][0] - p[adr2 + MAGGI_DRAG_WIND];
        u20d = rvd[t->forcepoint[i]][0] - pd[adr2 + MAGGI_DRAG_WIND];
        u21 = rv[t->forcepoint[i]][1] - p[adr2 + MAGGI_DRAG_WIND + 1];
        u21d = rvd[t->forcepoint[i]][1] - pd[adr2 + MAGGI_DRAG_WIND + 1];
        u22 = rv[t->forcepoint[i]][2] - p[adr2 + MAGGI_DRAG_WIND + 2];
        u22d = rvd[t->forcepoint[i]][2] - pd[adr2 + MAGGI_DRAG_WIND + 2];
        p2 = p[adr2 + MAGGI_DRAG_LOW];
        p2d = pd[adr2 + MAGGI_DRAG_LOW];
        t3 = u20 * u20 + u21 * u21 + u22 * u22 + p2 * p2;
        t3d = u20d * u20 + u20 * u20d + (u21d * u21 + u21 * u21d) + (u22d * u22 + u22 * u22d) + (p2d
            * p2 + p2 * p2d);
        speed = sqrt(t3);
        speedd = 1.0 / (2.0 * speed) * t3d;
        c = 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * s;
        cd = ((0.5 * pd[adr2] * p[adr2 + MAGGI_DRAG_C] + 0.5 * p[adr2] * pd[adr2 + MAGGI_DRAG_C]) *
            p[adr2 + MAGGI_DRAG_AREA] + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * pd[adr2 +
            MAGGI_DRAG_AREA]) * s + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 +
            MAGGI_DRAG_AREA] * sd;
        tb21 = g2_2b * u22;
        tb21d = g2_2bd * u22 + g2_2b * u22d;
        cb = -(tb21 * speed);
        cbd = -(tb21d * speed + tb21 * speedd);
        speedb = -(tb21 * c);
        speedbd = -(tb21d * c + tb21 * cd);
        u22b = g2_2b * (-c * speed);
        u22bd = g2_2bd * (-c * speed) + g2_2b * (-(cd * speed) - c * speedd);
        g2_2b = 0.0;
        g2_2bd = 0.0;
        tb20 = g1b * u21;
        tb20d = g1bd * u21 + g1b * u21d;
        cb -= tb20 * speed;
        cbd -= tb20d * speed + tb20 * speedd;
        speedb -= tb20 * c;
        speedbd -= tb20d * c + tb20 * cd;
        u21b = g1b * (-c * speed);
        u21bd = g1bd * (-c * speed) + g1b * (-(cd * speed) - c * speedd);
        g1b = 0.0;
        g1bd = 0.0;
        tb19 = g0b * u20;
        tb19d = g0bd * u20 + g0b * u20d;
        cb -= tb19 * speed;
        cbd -= tb19d * speed + tb19 * speedd;
        speedb -= tb19 * c;
        speedbd -= tb19d * c + tb19 * cd;
        u20b = g0b * (-c * speed);
        u20bd = g0bd * (-c * speed) + g0b * (-(cd * speed) - c * speedd);
        g0b = 0.0;
        g0bd = 0.0;
        tb17 = cb * s;
        tb17d = cbd * s + cb * sd;
        tb18 = tb17 * p[adr2 + MAGGI_DRAG_AREA];
        tb18d = tb17d * p[adr2 + MAGGI_DRAG_AREA] + tb17 * pd[adr2 + MAGGI_DRAG_AREA];
        pb[adr2] += tb18 * p[adr2 + MAGGI_DRAG_C] * 0.5;
        pbd[adr2] += (tb18d * p[adr2 + MAGGI_DRAG_C] + tb18 * pd[adr2 + MAGGI_DRAG_C]) * 0.5;
        pb[adr2 + MAGGI_DRAG_C] += tb18 * (0.5 * p[adr2]);
        pbd[adr2 + MAGGI_DRAG_C] += tb18d * (0.5 * p[adr2]) + tb18 * (0.5 * pd[adr2]);
        pb[adr2 + MAGGI_DRAG_AREA] += tb17 * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C]);
        pbd[adr2 + MAGGI_DRAG_AREA] += tb17d * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C]) + tb17 *
            (0.5 * pd[adr2] * p[adr2 + MAGGI_DRAG_C] + 0.5 * p[adr2] * pd[adr2 + MAGGI_DRAG_C]);
        sb += cb * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA]);
        sbd += cbd * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA]) + cb *
            ((0.5 * pd[adr2] * p[adr2 + MAGGI_DRAG_C] + 0.5 * p[adr2] * pd[adr2 + MAGGI_DRAG_C]) *
            p[adr2 + MAGGI_DRAG_AREA] + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * pd[adr2 +
            MAGGI_DRAG_AREA]);
        t3b = speedb * (1.0 / (2.0 * speed));
        t3bd = speedbd * (1.0 / (2.0 * speed)) - speedb * (1.0 / (2.0 * speed) * (2.0 * speedd) /
            (2.0 * speed));
        u20b += t3b * u20;
        u20bd += t3bd * u20 + t3b * u20d;
        u20b += t3b * u20;
        u20bd += t3bd * u20 + t3b * u20d;
        u21b += t3b * u21;
        u21bd += t3bd * u21 + t3b * u21d;
        u21b += t3b * u21;
        u21bd += t3bd * u21 + t3b * u21d;
        u22b += t3b * u22;
        u22bd += t3bd * u22 + t3b * u22d;
        u22b += t3b * u22;
        u22bd += t3bd * u22 + t3b * u22d;
        p2b = t3b * p2;
        p2bd = t3bd * p2 + t3b * p2d;
        p2b += t3b * p2;
        p2bd += t3bd * p2 + t3b * p2d;
        pb[adr2 + MAGGI_DRAG_LOW] += p2b;
        pbd[adr2 + MAGGI_DRAG_LOW] += p2bd;
        rvb[t->forcepoint[i]][2] += u22b;
        rvbd[t->forcepoint[i]][2] += u22bd;
        pb[adr2 + MAGGI_DRAG_WIND + 2] -= u22b;
        pbd[adr2 + MAGGI_DRAG_WIND + 2] -= u22bd;
        rvb[t->forcepoint[i]][1] += u21b;
        rvbd[t->forcepoint[i]][1] += u21bd;
        pb[adr2 + MAGGI_DRAG_WIND + 1] -= u21b;
        pbd[adr2 + MAGGI_DRAG_WIND + 1] -= u21bd;
        rvb[t->forcepoint[i]][0] += u20b;
        /* - rho/2 c A |u| u,  u = v - wind,  |u| = sqrt(u.u + low^2) */
        rvbd[t->forcepoint[i]][0] += u20bd;
        pb[adr2 + MAGGI_DRAG_WIND] -= u20b;
        pbd[adr2 + MAGGI_DRAG_WIND] -= u20bd;
      } else {
        c20 = p[adr2] * s;
        c20d = pd[adr2] * s + p[adr2] * sd;
        c21 = p[adr2 + 1] * s;
        c21d = pd[adr2 + 1] * s + p[adr2 + 1] * sd;
        c22 = p[adr2 + 2] * s;
        c22d = pd[adr2 + 2] * s + p[adr2 + 2] * sd;
        c20b = 0.0;
        c20bd = 0.0;
        c21b = 0.0;
        c21bd = 0.0;
        c22b = 0.0;
        c22bd = 0.0;
        if (t->forcekind[i] == MAGGI_FORCE_BODY || t->forcekind[i] == MAGGI_TORQUE_BODY) {
          Ab[a5_2][6] += g2_2b * c20;
          Abd[a5_2][6] += g2_2bd * c20 + g2_2b * c20d;
          c20b += g2_2b * A[a5_2][6];
          c20bd += g2_2bd * A[a5_2][6] + g2_2b * Ad[a5_2][6];
          Ab[a5_2][7] += g2_2b * c21;
          Abd[a5_2][7] += g2_2bd * c21 + g2_2b * c21d;
          c21b += g2_2b * A[a5_2][7];
          c21bd += g2_2bd * A[a5_2][7] + g2_2b * Ad[a5_2][7];
          Ab[a5_2][8] += g2_2b * c22;
          Abd[a5_2][8] += g2_2bd * c22 + g2_2b * c22d;
          c22b += g2_2b * A[a5_2][8];
          c22bd += g2_2bd * A[a5_2][8] + g2_2b * Ad[a5_2][8];
          g2_2b = 0.0;
          g2_2bd = 0.0;
          Ab[a5_2][3] += g1b * c20;
          Abd[a5_2][3] += g1bd * c20 + g1b * c20d;
          c20b += g1b * A[a5_2][3];
          c20bd += g1bd * A[a5_2][3] + g1b * Ad[a5_2][3];
          Ab[a5_2][4] += g1b * c21;
          Abd[a5_2][4] += g1bd * c21 + g1b * c21d;
          c21b += g1b * A[a5_2][4];
          c21bd += g1bd * A[a5_2][4] + g1b * Ad[a5_2][4];
          Ab[a5_2][5] += g1b * c22;
          Abd[a5_2][5] += g1bd * c22 + g1b * c22d;
          c22b += g1b * A[a5_2][5];
          c22bd += g1bd * A[a5_2][5] + g1b * Ad[a5_2][5];
          g1b = 0.0;
          g1bd = 0.0;
          Ab[a5_2][0] += g0b * c20;
          Abd[a5_2][0] += g0bd * c20 + g0b * c20d;
          c20b += g0b * A[a5_2][0];
          c20bd += g0bd * A[a5_2][0] + g0b * Ad[a5_2][0];
          Ab[a5_2][1] += g0b * c21;
          Abd[a5_2][1] += g0bd * c21 + g0b * c21d;
          c21b += g0b * A[a5_2][1];
          c21bd += g0bd * A[a5_2][1] + g0b * Ad[a5_2][1];
          Ab[a5_2][2] += g0b * c22;
          Abd[a5_2][2] += g0bd * c22 + g0b * c22d;
          c22b += g0b * A[a5_2][2];
          c22bd += g0bd * A[a5_2][2] + g0b * Ad[a5_2][2];
          g0b = 0.0;
          g0bd = 0.0;
        } else {
          c22b += g2_2b;
          c22bd += g2_2bd;
          g2_2b = 0.0;
          g2_2bd = 0.0;
          c21b += g1b;
          c21bd += g1bd;
          g1b = 0.0;
          g1bd = 0.0;
          c20b += g0b;
          c20bd += g0bd;
          g0b = 0.0;
          g0bd = 0.0;
        }
        pb[adr2 + 2] += c22b * s;
        pbd[adr2 + 2] += c22bd * s + c22b * sd;
        sb += c22b * p[adr2 + 2];
        sbd += c22bd * p[adr2 + 2] + c22b * pd[adr2 + 2];
        pb[adr2 + 1] += c21b * s;
        pbd[adr2 + 1] += c21bd * s + c21b * sd;
        sb += c21b * p[adr2 + 1];
        sbd += c21bd * p[adr2 + 1] + c21b * pd[adr2 + 1];
        pb[adr2] += c20b * s;
        pbd[adr2] += c20bd * s + c20b * sd;
        sb += c20b * p[adr2];
        sbd += c20bd * p[adr2] + c20b * pd[adr2];
      }
    }
    if (t->forcefun[i] >= 0) {
      funb[t->forcefun[i]][0] += sb;
      funbd[t->forcefun[i]][0] += sbd;
      sb = 0.0;
      sbd = 0.0;
    } else {
      sb = 0.0;
      sbd = 0.0;
    }
  }
  for (i = t->njspring - 1; i >= 0; --i) {
    a4 = t->jspringq[i];
    b2 = t->jspringq2[i];
    adr = t->jspringadr[i];
    if (b2 >= 0) {
      x = q[a4] - q[b2];
      xd = qd[a4] - qd[b2];
      xv = v[a4] - v[b2];
      xvd = vd[a4] - vd[b2];
    } else {
      x = q[a4];
      xd = qd[a4];
      xv = v[a4];
      xvd = vd[a4];
    }
    torque0b = 0.0;
    torque0bd = 0.0;
    if (b2 >= 0) {
      torque0b -= taub[b2];
      torque0bd -= taubd[b2];
    }
    torque0b += taub[a4];
    torque0bd += taubd[a4];
    pb[adr] -= torque0b * (x - p[adr + MAGGI_JSPRING_REST]);
    pbd[adr] -= torque0bd * (x - p[adr + MAGGI_JSPRING_REST]) + torque0b * (xd - pd[adr +
        MAGGI_JSPRING_REST]);
    tb15 = torque0b * p[adr];
    tb15d = torque0bd * p[adr] + torque0b * pd[adr];
    xb = -tb15;
    xbd = -tb15d;
    pb[adr + MAGGI_JSPRING_REST] += tb15;
    pbd[adr + MAGGI_JSPRING_REST] += tb15d;
    pb[adr + MAGGI_JSPRING_C] -= torque0b * xv;
    pbd[adr + MAGGI_JSPRING_C] -= torque0bd * xv + torque0b * xvd;
    xvb = -(torque0b * p[adr + MAGGI_JSPRING_C]);
    xvbd = -(torque0bd * p[adr + MAGGI_JSPRING_C] + torque0b * pd[adr + MAGGI_JSPRING_C]);
    pb[adr + MAGGI_JSPRING_PRELOAD] -= torque0b;
    pbd[adr + MAGGI_JSPRING_PRELOAD] -= torque0bd;
    if (b2 >= 0) {
      vb[a4] += xvb;
      vbd[a4] += xvbd;
      vb[b2] -= xvb;
      vbd[b2] -= xvbd;
      xvb = 0.0;
      xvbd = 0.0;
      qb[a4] += xb;
      qbd[a4] += xbd;
      qb[b2] -= xb;
      qbd[b2] -= xbd;
      xb = 0.0;
      xbd = 0.0;
    } else {
      vb[a4] += xvb;
      vbd[a4] += xvbd;
      xvb = 0.0;
      xvbd = 0.0;
      qb[a4] += xb;
      qbd[a4] += xbd;
      xb = 0.0;
      xbd = 0.0;
    }
  }
  for (i = t->nspring - 1; i >= 0; --i) {
    a = t->springpa[i];
    b = t->springpb[i];
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
    ev2 = rv[a][2] - rv[b][2];
    ev2d = rvd[a][2] - rvd[b][2];
    t2 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
    t2d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
    l = sqrt(t2);
    ld = 1.0 / (2.0 * l) * t2d;
    n20 = e0 / l;
    n20d = (e0d - n20 * ld) * (1.0 / l);
    n21 = e1 / l;
    n21d = (e1d - n21 * ld) * (1.0 / l);
    n22 = e2_2 / l;
    n22d = (e2_2d - n22 * ld) * (1.0 / l);
    lv = n20 * ev0 + n21 * ev1 + n22 * ev2;
    lvd = n20d * ev0 + n20 * ev0d + (n21d * ev1 + n21 * ev1d) + (n22d * ev2 + n22 * ev2d);
    damping = p[t->springadr[i] + MAGGI_SPRING_C] * lv;
    dampingd = pd[t->springadr[i] + MAGGI_SPRING_C] * lv + p[t->springadr[i] + MAGGI_SPRING_C] *
        lvd;
    if (t->springpreload[i]) {
      f0 = p[t->springadr[i]] * (l - spring0[i]) + p[t->springadr[i] + MAGGI_SPRING_L];
      f0d = pd[t->springadr[i]] * (l - spring0[i]) + p[t->springadr[i]] * (ld - spring0d[i]) +
          pd[t->springadr[i] + MAGGI_SPRING_L];
    } else {
      f0 = p[t->springadr[i]] * (l - p[t->springadr[i] + MAGGI_SPRING_L]);
      f0d = pd[t->springadr[i]] * (l - p[t->springadr[i] + MAGGI_SPRING_L]) + p[t->springadr[i]] *
          (ld - pd[t->springadr[i] + MAGGI_SPRING_L]);
    }
    k2 = t->springadr[i] + MAGGI_SPRING_SLOPES;
    if (t->springslopes[i]) {
      if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
        p_k24 = p[k2 + 4];
        p_k24d = pd[k2 + 4];
        f2 = p[k2] * p_k24 + p[k2 + 1] * (lv - p_k24);
        f2d = pd[k2] * p_k24 + p[k2] * p_k24d + (pd[k2 + 1] * (lv - p_k24) + p[k2 + 1] * (lvd -
            p_k24d));
      } else if (MAGGI_RE(lv) > 0.0) {
        f2 = p[k2] * lv;
        f2d = pd[k2] * lv + p[k2] * lvd;
      } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
        f2 = p[k2 + 2] * lv;
        f2d = pd[k2 + 2] * lv + p[k2 + 2] * lvd;
      } else {
        p_k25 = p[k2 + 5];
        p_k25d = pd[k2 + 5];
        f2 = p[k2 + 2] * p_k25 + p[k2 + 3] * (lv - p_k25);
        f2d = pd[k2 + 2] * p_k25 + p[k2 + 2] * p_k25d + (pd[k2 + 3] * (lv - p_k25) + p[k2 + 3] *
            (lvd - p_k25d));
      }
      f1 = damping + f2;
      f1d = dampingd + f2d;
    } else {
      f1 = damping;
      f1d = dampingd;
    }
    u0 = n20;
    u0d = n20d;
    u1 = n21;
    u1d = n21d;
    u2_2 = n22;
    u2_2d = n22d;
    f3 = f0 + f1;
    f3d = f0d + f1d;
    force0 = f3 * u0;
    force0d = f3d * u0 + f3 * u0d;
    back0 = -f3 * u0;
    back0d = -(f3d * u0) - f3 * u0d;
    force1 = f3 * u1;
    force1d = f3d * u1 + f3 * u1d;
    back1 = -f3 * u1;
    back1d = -(f3d * u1) - f3 * u1d;
    force2_2 = f3 * u2_2;
    force2_2d = f3d * u2_2 + f3 * u2_2d;
    back2_2 = -f3 * u2_2;
    back2_2d = -(f3d * u2_2) - f3 * u2_2d;
    r_a1 = r[a][1];
    r_a1d = rd[a][1];
    r_a2 = r[a][2];
    r_a2d = rd[a][2];
    r_a0 = r[a][0];
    r_a0d = rd[a][0];
    r_b1 = r[b][1];
    r_b1d = rd[b][1];
    r_b2 = r[b][2];
    r_b2d = rd[b][2];
    r_b0 = r[b][0];
    r_b0d = rd[b][0];
    tb14 = Qb[t->pointbody[b]][5];
    tb14d = Qbd[t->pointbody[b]][5];
    r_b0b = tb14 * force1;
    r_b0bd = tb14d * force1 + tb14 * force1d;
    force1b = tb14 * r_b0;
    force1bd = tb14d * r_b0 + tb14 * r_b0d;
    r_b1b = -(tb14 * force0);
    r_b1bd = -(tb14d * force0 + tb14 * force0d);
    force0b = -(tb14 * r_b1);
    force0bd = -(tb14d * r_b1 + tb14 * r_b1d);
    tb13 = Qb[t->pointbody[b]][4];
    tb13d = Qbd[t->pointbody[b]][4];
    r_b2b = tb13 * force0;
    r_b2bd = tb13d * force0 + tb13 * force0d;
    force0b += tb13 * r_b2;
    force0bd += tb13d * r_b2 + tb13 * r_b2d;
    r_b0b -= tb13 * force2_2;
    r_b0bd -= tb13d * force2_2 + tb13 * force2_2d;
    force2_2b = -(tb13 * r_b0);
    force2_2bd = -(tb13d * r_b0 + tb13 * r_b0d);
    rb[b][0] += r_b0b;
    rbd[b][0] += r_b0bd;
    tb12 = Qb[t->pointbody[b]][3];
    tb12d = Qbd[t->pointbody[b]][3];
    r_b1b += tb12 * force2_2;
    r_b1bd += tb12d * force2_2 + tb12 * force2_2d;
    force2_2b += tb12 * r_b1;
    force2_2bd += tb12d * r_b1 + tb12 * r_b1d;
    r_b2b -= tb12 * force1;
    r_b2bd -= tb12d * force1 + tb12 * force1d;
    force1b -= tb12 * r_b2;
    force1bd -= tb12d * r_b2 + tb12 * r_b2d;
    rb[b][2] += r_b2b;
    rbd[b][2] += r_b2bd;
    rb[b][1] += r_b1b;
    rbd[b][1] += r_b1bd;
    force2_2b += Qb[t->pointbody[b]][2];
    force2_2bd += Qbd[t->pointbody[b]][2];
    force1b += Qb[t->pointbody[b]][1];
    force1bd += Qbd[t->pointbody[b]][1];
    force0b += Qb[t->pointbody[b]][0];
    force0bd += Qbd[t->pointbody[b]][0];
    tb11 = Qb[t->pointbody[a]][5];
    tb11d = Qbd[t->pointbody[a]][5];
    r_a0b = tb11 * back1;
    r_a0bd = tb11d * back1 + tb11 * back1d;
    back1b = tb11 * r_a0;
    back1bd = tb11d * r_a0 + tb11 * r_a0d;
    r_a1b = -(tb11 * back0);
    r_a1bd = -(tb11d * back0 + tb11 * back0d);
    back0b = -(tb11 * r_a1);
    back0bd = -(tb11d * r_a1 + tb11 * r_a1d);
    tb10 = Qb[t->pointbody[a]][4];
    tb10d = Qbd[t->pointbody[a]][4];
    r_a2b = tb10 * back0;
    r_a2bd = tb10d * back0 + tb10 * back0d;
    back0b += tb10 * r_a2;
    back0bd += tb10d * r_a2 + tb10 * r_a2d;
    r_a0b -= tb10 * back2_2;
    r_a0bd -= tb10d * back2_2 + tb10 * back2_2d;
    back2_2b = -(tb10 * r_a0);
    back2_2bd = -(tb10d * r_a0 + tb10 * r_a0d);
    rb[a][0] += r_a0b;
    rbd[a][0] += r_a0bd;
    tb9 = Qb[t->pointbody[a]][3];
    tb9d = Qbd[t->pointbody[a]][3];
    r_a1b += tb9 * back2_2;
    r_a1bd += tb9d * back2_2 + tb9 * back2_2d;
    back2_2b += tb9 * r_a1;
    back2_2bd += tb9d * r_a1 + tb9 * r_a1d;
    r_a2b -= tb9 * back1;
    r_a2bd -= tb9d * back1 + tb9 * back1d;
    back1b -= tb9 * r_a2;
    back1bd -= tb9d * r_a2 + tb9 * r_a2d;
    rb[a][2] += r_a2b;
    rbd[a][2] += r_a2bd;
    rb[a][1] += r_a1b;
    rbd[a][1] += r_a1bd;
    back2_2b += Qb[t->pointbody[a]][2];
    back2_2bd += Qbd[t->pointbody[a]][2];
    back1b += Qb[t->pointbody[a]][1];
    back1bd += Qbd[t->pointbody[a]][1];
    back0b += Qb[t->pointbody[a]][0];
    back0bd += Qbd[t->pointbody[a]][0];
    f3b = -(back2_2b * u2_2);
    f3bd = -(back2_2bd * u2_2 + back2_2b * u2_2d);
    u2_2b = -(back2_2b * f3);
    u2_2bd = -(back2_2bd * f3 + back2_2b * f3d);
    f3b += force2_2b * u2_2;
    f3bd += force2_2bd * u2_2 + force2_2b * u2_2d;
    u2_2b += force2_2b * f3;
    u2_2bd += force2_2bd * f3 + force2_2b * f3d;
    f3b -= back1b * u1;
    f3bd -= back1bd * u1 + back1b * u1d;
    u1b = -(back1b * f3);
    u1bd = -(back1bd * f3 + back1b * f3d);
    f3b += force1b * u1;
    f3bd += force1bd * u1 + force1b * u1d;
    u1b += force1b * f3;
    u1bd += force1bd * f3 + force1b * f3d;
    f3b -= back0b * u0;
    f3bd -= back0bd * u0 + back0b * u0d;
    u0b = -(back0b * f3);
    u0bd = -(back0bd * f3 + back0b * f3d);
    f3b += force0b * u0;
    f3bd += force0bd * u0 + force0b * u0d;
    u0b += force0b * f3;
    u0bd += force0bd * f3 + force0b * f3d;
    f0b = f3b;
    f0bd = f3bd;
    f1b = f3b;
    f1bd = f3bd;
    n22b = u2_2b;
    n22bd = u2_2bd;
    n21b = u1b;
    n21bd = u1bd;
    n20b = u0b;
    n20bd = u0bd;
    dampingb = 0.0;
    dampingbd = 0.0;
    lvb = 0.0;
    lvbd = 0.0;
    if (t->springslopes[i]) {
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
        tb7 = f2b * p[k2 + 1];
        tb7d = f2bd * p[k2 + 1] + f2b * pd[k2 + 1];
        lvb += tb7;
        lvbd += tb7d;
        p_k24b -= tb7;
        p_k24bd -= tb7d;
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
        tb8 = f2b * p[k2 + 3];
        tb8d = f2bd * p[k2 + 3] + f2b * pd[k2 + 3];
        lvb += tb8;
        lvbd += tb8d;
        p_k25b -= tb8;
        p_k25bd -= tb8d;
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
    lb = 0.0;
    lbd = 0.0;
    if (t->springpreload[i]) {
      pb[t->springadr[i]] += f0b * (l - spring0[i]);
      pbd[t->springadr[i]] += f0bd * (l - spring0[i]) + f0b * (ld - spring0d[i]);
      tb5 = f0b * p[t->springadr[i]];
      tb5d = f0bd * p[t->springadr[i]] + f0b * pd[t->springadr[i]];
      lb += tb5;
      lbd += tb5d;
      spring0b[i] -= tb5;
      spring0bd[i] -= tb5d;
      pb[t->springadr[i] + MAGGI_SPRING_L] += f0b;
      pbd[t->springadr[i] + MAGGI_SPRING_L] += f0bd;
      f0b = 0.0;
      f0bd = 0.0;
    } else {
      pb[t->springadr[i]] += f0b * (l - p[t->springadr[i] + MAGGI_SPRING_L]);
      pbd[t->springadr[i]] += f0bd * (l - p[t->springadr[i] + MAGGI_SPRING_L]) + f0b * (ld -
          pd[t->springadr[i] + MAGGI_SPRING_L]);
      tb6 = f0b * p[t->springadr[i]];
      tb6d = f0bd * p[t->springadr[i]] + f0b * pd[t->springadr[i]];
      lb += tb6;
      lbd += tb6d;
      pb[t->springadr[i] + MAGGI_SPRING_L] -= tb6;
      pbd[t->springadr[i] + MAGGI_SPRING_L] -= tb6d;
      f0b = 0.0;
      f0bd = 0.0;
    }
    pb[t->springadr[i] + MAGGI_SPRING_C] += dampingb * lv;
    pbd[t->springadr[i] + MAGGI_SPRING_C] += dampingbd * lv + dampingb * lvd;
    lvb += dampingb * p[t->springadr[i] + MAGGI_SPRING_C];
    lvbd += dampingbd * p[t->springadr[i] + MAGGI_SPRING_C] + dampingb * pd[t->springadr[i] +
        MAGGI_SPRING_C];
    n20b += lvb * ev0;
    n20bd += lvbd * ev0 + lvb * ev0d;
    ev0b = lvb * n20;
    ev0bd = lvbd * n20 + lvb * n20d;
    n21b += lvb * ev1;
    n21bd += lvbd * ev1 + lvb * ev1d;
    ev1b = lvb * n21;
    ev1bd = lvbd * n21 + lvb * n21d;
    n22b += lvb * ev2;
    n22bd += lvbd * ev2 + lvb * ev2d;
    ev2b = lvb * n22;
    ev2bd = lvbd * n22 + lvb * n22d;
    tb4 = n22b / l;
    tb4d = (n22bd - tb4 * ld) * (1.0 / l);
    e2_2b = tb4;
    e2_2bd = tb4d;
    lb -= tb4 * n22;
    lbd -= tb4d * n22 + tb4 * n22d;
    tb3 = n21b / l;
    tb3d = (n21bd - tb3 * ld) * (1.0 / l);
    e1b = tb3;
    e1bd = tb3d;
    lb -= tb3 * n21;
    lbd -= tb3d * n21 + tb3 * n21d;
    tb2 = n20b / l;
    tb2d = (n20bd - tb2 * ld) * (1.0 / l);
    e0b = tb2;
    e0bd = tb2d;
    lb -= tb2 * n20;
    lbd -= tb2d * n20 + tb2 * n20d;
    t2b = lb * (1.0 / (2.0 * l));
    t2bd = lbd * (1.0 / (2.0 * l)) - lb * (1.0 / (2.0 * l) * (2.0 * ld) / (2.0 * l));
    e0b += t2b * e0;
    e0bd += t2bd * e0 + t2b * e0d;
    e0b += t2b * e0;
    e0bd += t2bd * e0 + t2b * e0d;
    e1b += t2b * e1;
    e1bd += t2bd * e1 + t2b * e1d;
    e1b += t2b * e1;
    e1bd += t2bd * e1 + t2b * e1d;
    e2_2b += t2b * e2_2;
    e2_2bd += t2bd * e2_2 + t2b * e2_2d;
    e2_2b += t2b * e2_2;
    e2_2bd += t2bd * e2_2 + t2b * e2_2d;
    rvb[a][2] += ev2b;
    rvbd[a][2] += ev2bd;
    rvb[b][2] -= ev2b;
    rvbd[b][2] -= ev2bd;
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
  }
  for (i = t->nq - 1; i >= 0; --i) {
    taub[i] = 0.0;
    taubd[i] = 0.0;
  }
  for (i = t->nbody; i >= 0; --i) {
    for (k = 5; k >= 0; --k) {
      Qb[i][k] = 0.0;
      Qbd[i][k] = 0.0;
    }
  }
}
