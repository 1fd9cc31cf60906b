/* Tangent of the adjoint of core/kernel/tyre.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

static int nearest_nodiff(int np, const double p[np], int adr, int n, double x)
{
  int i, k;

  k = 0;
  for (i = 1; i < n; ++i)
    if (MAGGI_RE(x) >
        MAGGI_RE(p[adr + MAGGI_BUMPS_FIRST] + (i - 0.5) * p[adr + MAGGI_BUMPS_SPACING]))
      k = i;
  return k;
}

/* slip: MAGGI_SLIP_..; f: Fx Fy Fz, Mx My Mz at the contact point, in its axes; F: the same at P */
void maggi_wheel_forces_b_d(const maggi_topo *t, const double p[restrict t->np],
                            const double pd[restrict t->np], double pb[restrict t->np],
                            double pbd[restrict t->np],
                            const double spline0[restrict t->nspline][3],
                            const double spline0d[restrict t->nspline][3],
                            double spline0b[restrict t->nspline][3],
                            double spline0bd[restrict t->nspline][3],
                            const double A[restrict t->nbody + 1][9],
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
                            double slip[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                            double slipd[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                            double slipb[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                            double slipbd[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                            double f[restrict t->nwheel][6], double fd[restrict t->nwheel][6],
                            double fb[restrict t->nwheel][6], double fbd[restrict t->nwheel][6],
                            double F[restrict t->nwheel][6], double Fd[restrict t->nwheel][6],
                            double Fb[restrict t->nwheel][6], double Fbd[restrict t->nwheel][6])
{
  int i, k3, k5, k6, k8, k9, k9_2, road;
  double L0, L0b, L0bd, L0d, L1, L1b, L1bd, L1d, L2, L2b, L2bd, L2d, N0, N0b, N0bd, N0d, N1, N2,
      N2b, N2bd, N2d, T0, T0b, T0bd, T0d, T1, T1b, T1bd, T1d, T2, T2b, T2bd, T2d, Z_i3, Z_i3b,
      Z_i3bd, Z_i3d, Z_i4, Z_i4b, Z_i4bd, Z_i4d, Z_i5, Z_i5b, Z_i5bd, Z_i5d, a, a2, a2b, a2bd, a2d,
      a3, a3b, a3bd, a3d, a4, a4b, a4bd, a4d, a5, a5b, a5bd, a5d, ab, abd, ad, along0, along0b,
      along0bd, along0d, along1, along1b, along1bd, along1d, along2, along2b, along2bd, along2d, ar,
      arb, arbd, ard, areq, areqb, areqbd, areqd, arm0, arm0b, arm0bd, arm0d, arm1, arm1b, arm1bd,
      arm1d, arm2, arm2b, arm2bd, arm2d, at, atb, atbd, atd, ateq, ateqb, ateqbd, ateqd, axis0,
      axis0b, axis0bd, axis0d, axis1, axis1b, axis1bd, axis1d, axis2, axis2b, axis2bd, axis2d, ay,
      ayb, aybd, ayd, b0, b0b, b0bd, b0d, b2, b2b, b2bd, b2d, b30, b30b, b30bd, b30d, b31, b31b,
      b31bd, b31d, b4, b4b, b4bd, b4d, base, base2, base2b, base2bd, base2d, baseb, basebd, based,
      br, brb, brbd, brd, bt, btb, btbd, btd, c, c2, c2b, c2bd, c2d, c3, c3b, c3bd, c3d, c4, c4b,
      c4bd, c4d, c5, c5b, c5bd, c5d, ca, cab, cabd, cad, cb, cbd, cd, dfz, dfzb, dfzbd, dfzd, dr,
      drb, drbd, drd, dt, dtb, dtbd, dtd, dv, dvb, dvbd, dvd, e, e10, e10b, e10bd, e10d, e11, e11b,
      e11bd, e11d, e2, e2b, e2bd, e2d, e3, e3b, e3bd, e3d, e4, e4b, e4bd, e4d, e5, e5b, e5bd, e5d,
      e6, e6b, e6bd, e6d, e7, e7b, e7bd, e7d, e8, e8b, e8bd, e8d, e9, e9b, e9bd, e9d, eb, ebd, ed,
      et, etb, etbd, etd, ex, exb, exbd, exd, ey, eyb, eybd, eyd, f2, f2b, f2bd, f2d, f3, f3b, f3bd,
      f3d, f_i0, f_i0b, f_i0bd, f_i0d, f_i1, f_i1b, f_i1bd, f_i1d, f_i2, f_i2b, f_i2bd, f_i2d, f_i3,
      f_i3b, f_i3bd, f_i3d, f_i4, f_i4b, f_i4bd, f_i4d, f_i5, f_i5b, f_i5bd, f_i5d, force0b,
      force0bd, force1b, force1bd, force2, force2_2b, force2_2bd, force2b, force2bd, force2d,
      force30, force30b, force30bd, force30d, force31, force31b, force31bd, force31d, force32,
      force32b, force32bd, force32d, force3_2b, force3_2bd, force4b, force4bd, force5b, force5bd,
      fx, fxb, fxbd, fxd, fy, fyb, fybd, fyd, fz, fz0, fz0_2, fz0_2b, fz0_2bd, fz0_2d, fz0_3,
      fz0_3b, fz0_3bd, fz0_3d, fz0_4, fz0_4b, fz0_4bd, fz0_4d, fz0b, fz0bd, fz0d, fz2, fz2b, fz2bd,
      fz2d, fzb, fzbd, fzd, g0, g0b, g0bd, g0d, g20, g20b, g20bd, g20d, g21, g21b, g21bd, g21d, g22,
      g22b, g22bd, g22d, g23, g23b, g23bd, g23d, g24, g24b, g24bd, g24d, g25, g25b, g25bd, g25d,
      g26, g26b, g26bd, g26d, g27, g27b, g27bd, g27d, g28, g28b, g28bd, g28d, g2_2, g2_2b, g2_2bd,
      g2_2d, gamma, gammab, gammabd, gammad, gx, gxb, gxbd, gxd, gy, gyb, gybd, gyd, gz, gzb, gzbd,
      gzd, h, h00, h00b, h00bd, h00d, h0_2, h0_2b, h0_2bd, h0_2d, h0_3, h0_3b, h0_3bd, h0_3d, h10,
      h10b, h10bd, h10d, h11, h11b, h11bd, h11d, h12, h12b, h12bd, h12d, h1_2, h1_2b, h1_2bd, h1_2d,
      h1_3, h1_3b, h1_3bd, h1_3d, h2, h2_2, h2_2b, h2_2bd, h2_2d, h2_3, h2_3b, h2_3bd, h2_3d, h2b,
      h2bd, h2d, h3, h3_2, h3_2b, h3_2bd, h3_2d, h3b, h3bd, h3d, hb, hbd, hd, k4, k4b, k4bd, k4d,
      k7, k7b, k7bd, k7d, kappa, kappab, kappabd, kappad, kx, kxb, kxbd, kxd, moment0b, moment0bd,
      moment1b, moment1bd, moment2b, moment2bd, mux, muxb, muxbd, muxd, muy, muyb, muybd, muyd, n2,
      n2b, n2bd, n2d, normal0, normal0b, normal0bd, normal0d, normal1, normal2, normal2b, normal2bd,
      normal2d, omega, omegab, omegabd, omegad, one0, one0b, one0bd, one0d, one1, one1b, one1bd,
      one1d, one2, one2b, one2bd, one2d, one3, one3b, one3bd, one3d, one4, one4b, one4bd, one4d,
      p10, p10b, p10bd, p10d, p2, p2b, p2bd, p2d, p3, p3b, p3bd, p3d, p4, p4b, p4bd, p4d, p5, p5b,
      p5bd, p5d, p6, p6b, p6bd, p6d, p7, p7b, p7bd, p7d, p8, p8b, p8bd, p8d, p9, p9b, p9bd, p9d,
      p_road, p_road2, p_road2b, p_road2bd, p_road2d, p_road3, p_road3b, p_road3bd, p_road3d,
      p_road4, p_road4b, p_road4bd, p_road4d, p_road5, p_road5b, p_road5bd, p_road5d, p_road6,
      p_road6b, p_road6bd, p_road6d, p_roadb, p_roadbd, p_roadd, p_roadk5, p_roadk51, p_roadk51b,
      p_roadk51bd, p_roadk51d, p_roadk5b, p_roadk5bd, p_roadk5d, p_roadk8, p_roadk81, p_roadk81b,
      p_roadk81bd, p_roadk81d, p_roadk8b, p_roadk8bd, p_roadk8d, p_roadroad, p_roadroad2,
      p_roadroad2b, p_roadroad2bd, p_roadroad2d, p_roadroadb, p_roadroadbd, p_roadroadd, peak,
      peakb, peakbd, peakd, r0, r0b, r0bd, r0d, r2, r2b, r2bd, r2d, r30, r30b, r30bd, r30d, r31,
      r31b, r31bd, r31d, r32, r32b, r32bd, r32d, radius, radius2, radius2b, radius2bd, radius2d,
      radiusb, radiusbd, radiusd, ratio, ratio2, ratio2b, ratio2bd, ratio2d, ratiob, ratiobd,
      ratiod, re, re2, re2b, re2bd, re2d, reb, rebd, red, rhov, rhovb, rhovbd, rhovd, s, s20, s20b,
      s20bd, s20d, s30, s30b, s30bd, s30d, s31, s31b, s31bd, s31d, s4, s4b, s4bd, s4d, sb, sbd,
      scale, scaleb, scalebd, scaled, sd, side, slope, slope2, slope2_2, slope2_2b, slope2_2bd,
      slope2_2d, slope2b, slope2bd, slope2d, slope3, slope3b, slope3bd, slope3d, slopeb, slopebd,
      sloped, speed, speed2, speed2b, speed2bd, speed2d, speedb, speedbd, speedd, spline0_roadk50,
      spline0_roadk50b, spline0_roadk50bd, spline0_roadk50d, spline0_roadk510, spline0_roadk510b,
      spline0_roadk510bd, spline0_roadk510d, spline0_roadk80, spline0_roadk80b, spline0_roadk80bd,
      spline0_roadk80d, spline0_roadk810, spline0_roadk810b, spline0_roadk810bd, spline0_roadk810d,
      t10, t100, t100b, t100bd, t100d, t101, t101b, t101bd, t101d, t102, t102b, t102bd, t102d, t103,
      t103b, t103bd, t103d, t104, t104b, t104bd, t104d, t105, t105b, t105bd, t105d, t106, t106b,
      t106bd, t106d, t107, t107b, t107bd, t107d, t108, t108b, t108bd, t108d, t109, t109b, t109bd,
      t109d, t10b, t10bd, t10d, t11, t110, t110b, t110bd, t110d, t111, t111b, t111bd, t111d, t112,
      t112b, t112bd, t112d, t113, t113b, t113bd, t113d, t114, t114b, t114bd, t114d, t115, t115b,
      t115bd, t115d, t116, t116b, t116bd, t116d, t117, t117b, t117bd, t117d, t118, t118b, t118bd,
      t118d, t119, t119b, t119bd, t119d, t11b, t11bd, t11d, t12, t120, t120b, t120bd, t120d, t121b,
      t121bd, t12b, t12bd, t12d, t13, t13b, t13bd, t13d, t14, t14b, t14bd, t14d, t15, t15b, t15bd,
      t15d, t16, t16b, t16bd, t16d, t17, t17b, t17bd, t17d, t18, t18b, t18bd, t18d, t19, t19b,
      t19bd, t19d, t2, t20, t20b, t20bd, t20d, t21, t21b, t21bd, t21d, t22, t22b, t22bd, t22d, t23,
      t23b, t23bd, t23d, t24, t24b, t24bd, t24d, t25, t25b, t25bd, t25d, t26, t26b, t26bd, t26d,
      t27, t27b, t27bd, t27d, t28, t28b, t28bd, t28d, t29, t29b, t29bd, t29d, t2b, t2bd, t2d, t3,
      t30, t30b, t30bd, t30d, t31, t31b, t31bd, t31d, t32, t32b, t32bd, t32d, t33, t33b, t33bd,
      t33d, t34, t34b, t34bd, t34d, t35, t35b, t35bd, t35d, t36, t36b, t36bd, t36d, t37, t37b,
      t37bd, t37d, t38, t38b, t38bd, t38d, t39, t39b, t39bd, t39d, t3b, t3bd, t3d, t4, t40, t40b,
      t40bd, t40d, t41, t41b, t41bd, t41d, t42, t42b, t42bd, t42d, t43, t43b, t43bd, t43d, t44,
      t44b, t44bd, t44d, t45, t45b, t45bd, t45d, t46, t46b, t46bd, t46d, t47, t47b, t47bd, t47d,
      t48, t48b, t48bd, t48d, t49, t49b, t49bd, t49d, t4b, t4bd, t4d, t5, t50, t50b, t50bd, t50d,
      t51, t51b, t51bd, t51d, t52, t52b, t52bd, t52d, t53, t53b, t53bd, t53d, t54, t54b, t54bd,
      t54d, t55, t55b, t55bd, t55d, t56, t56b, t56bd, t56d, t57, t57b, t57bd, t57d, t58, t58b,
      t58bd, t58d, t59, t59b, t59bd, t59d, t5b, t5bd, t5d, t6, t60, t60b, t60bd, t60d, t61, t61b,
      t61bd, t61d, t62, t62b, t62bd, t62d, t63, t63b, t63bd, t63d, t64, t64b, t64bd, t64d, t65,
      t65b, t65bd, t65d, t66, t66b, t66bd, t66d, t67, t67b, t67bd, t67d, t68, t68b, t68bd, t68d,
      t69, t69b, t69bd, t69d, t6b, t6bd, t6d, t7, t70, t70b, t70bd, t70d, t71, t71b, t71bd, t71d,
      t72, t72b, t72bd, t72d, t73, t73b, t73bd, t73d, t74, t74b, t74bd, t74d, t75, t75b, t75bd,
      t75d, t76, t76b, t76bd, t76d, t77, t77b, t77bd, t77d, t78, t78b, t78bd, t78d, t79, t79b,
      t79bd, t79d, t7b, t7bd, t7d, t8, t80, t80b, t80bd, t80d, t81, t81b, t81bd, t81d, t82, t82b,
      t82bd, t82d, t83, t83b, t83bd, t83d, t84, t84b, t84bd, t84d, t85, t85b, t85bd, t85d, t86,
      t86b, t86bd, t86d, t87, t87b, t87bd, t87d, t88, t88b, t88bd, t88d, t89, t89b, t89bd, t89d,
      t8b, t8bd, t8d, t9, t90, t90b, t90bd, t90d, t91, t91b, t91bd, t91d, t92, t92b, t92bd, t92d,
      t93, t93b, t93bd, t93d, t94, t94b, t94bd, t94d, t95, t95b, t95bd, t95d, t96, t96b, t96bd,
      t96d, t97, t97b, t97bd, t97d, t98, t98b, t98bd, t98d, t99, t99b, t99bd, t99d, t9b, t9bd, t9d,
      tb10, tb100, tb100d, tb101, tb101d, tb102, tb102d, tb103, tb103d, tb104, tb104d, tb105,
      tb105d, tb106, tb106d, tb107, tb107d, tb108, tb108d, tb109, tb109d, tb10d, tb11, tb110,
      tb110d, tb111, tb111d, tb112, tb112d, tb113, tb113d, tb114, tb114d, tb115, tb115d, tb116,
      tb116d, tb117, tb117d, tb118, tb118d, tb119, tb119d, tb11d, tb12, tb120, tb120d, tb121,
      tb121d, tb122, tb122d, tb123, tb123d, tb124, tb124d, tb125, tb125d, tb126, tb126d, tb127,
      tb127d, tb128, tb128d, tb129, tb129d, tb12d, tb13, tb130, tb130d, tb131, tb131d, tb132,
      tb132d, tb133, tb133d, tb134, tb134d, tb135, tb135d, tb136, tb136d, tb137, tb137d, tb138,
      tb138d, tb139, tb139d, tb13d, tb14, tb140, tb140d, tb141, tb141d, tb142, tb142d, tb143,
      tb143d, tb144, tb144d, tb145, tb145d, tb146, tb146d, tb147, tb147d, tb148, tb148d, tb149,
      tb149d, tb14d, tb15, tb150, tb150d, tb151, tb151d, tb152, tb152d, tb153, tb153d, tb154,
      tb154d, tb155, tb155d, tb156, tb156d, tb157, tb157d, tb158, tb158d, tb159, tb159d, tb15d,
      tb16, tb160, tb160d, tb161, tb161d, tb162, tb162d, tb163, tb163d, tb164, tb164d, tb165,
      tb165d, tb166, tb166d, tb167, tb167d, tb168, tb168d, tb169, tb169d, tb16d, tb17, tb170,
      tb170d, tb171, tb171d, tb172, tb172d, tb173, tb173d, tb174, tb174d, tb175, tb175d, tb176,
      tb176d, tb177, tb177d, tb178, tb178d, tb179, tb179d, tb17d, tb18, tb180, tb180d, tb181,
      tb181d, tb182, tb182d, tb183, tb183d, tb184, tb184d, tb185, tb185d, tb186, tb186d, tb187,
      tb187d, tb188, tb188d, tb189, tb189d, tb18d, tb19, tb190, tb190d, tb191, tb191d, tb192,
      tb192d, tb193, tb193d, tb194, tb194d, tb195, tb195d, tb196, tb196d, tb197, tb197d, tb198,
      tb198d, tb199, tb199d, tb19d, tb2, tb20, tb200, tb200d, tb201, tb201d, tb202, tb202d, tb203,
      tb203d, tb204, tb204d, tb205, tb205d, tb206, tb206d, tb207, tb207d, tb208, tb208d, tb209,
      tb209d, tb20d, tb21, tb21d, tb22, tb22d, tb23, tb23d, tb24, tb24d, tb25, tb25d, tb26, tb26d,
      tb27, tb27d, tb28, tb28d, tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31, tb31d, tb32, tb32d, tb33,
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
      tb97d, tb98, tb98d, tb99, tb99d, tb9d, u0, u0b, u0bd, u0d, u1, u1b, u1bd, u1d, u2, u2_2,
      u2_2b, u2_2bd, u2_2d, u2b, u2bd, u2d, u3, u3b, u3bd, u3d, ua0, ua0b, ua0bd, ua0d, ua1, ua1b,
      ua1bd, ua1d, ua2, ua2b, ua2bd, ua2d, un0, un0b, un0bd, un0d, un1, un1b, un1bd, un1d, un2,
      un2b, un2bd, un2d, v0, v0b, v0bd, v0d, v1, v1b, v1bd, v1d, v2, v2b, v2bd, v2d, vr0, vr0b,
      vr0bd, vr0d, vr1, vr1b, vr1bd, vr1d, vr2, vr2b, vr2bd, vr2d, vx, vxb, vxbd, vxd, w, w2, w2b,
      w2bd, w2d, w3, w3b, w3bd, w3d, way, way2, way3, way3b, way3bd, way3d, wb, wbd, wd, wr0, wr0b,
      wr0bd, wr0d, wr1, wr1b, wr1bd, wr1d, wr2, wr2b, wr2bd, wr2d, x, x2, x2b, x2bd, x2d, x3, x3b,
      x3bd, x3d, x4, x4b, x4bd, x4d, x50, x50b, x50bd, x50d, x51, x51b, x51bd, x51d, x52, x52b,
      x52bd, x52d, x53, x53b, x53bd, x53d, x54, x54b, x54bd, x54d, x55, x55b, x55bd, x55d, x6, x6b,
      x6bd, x6d, x7, x7b, x7bd, x7d, x8, x8b, x8bd, x8d, x9, x9b, x9bd, x9d, xb, xbd, xd, y, y10,
      y10b, y10bd, y10d, y11, y11b, y11bd, y11d, y12, y12b, y12bd, y12d, y13, y13b, y13bd, y13d,
      y14, y14b, y14bd, y14d, y15, y15b, y15bd, y15d, y16, y16b, y16bd, y16d, y17, y17b, y17bd,
      y17d, y18, y18b, y18bd, y18d, y19, y19b, y19bd, y19d, y2, y20, y20b, y20bd, y20d, y2b, y2bd,
      y2d, y3, y3b, y3bd, y3d, y40, y40b, y40bd, y40d, y41, y41b, y41bd, y41d, y42, y42b, y42bd,
      y42d, y43, y43b, y43bd, y43d, y44, y44b, y44bd, y44d, y45, y45b, y45bd, y45d, y5, y5b, y5bd,
      y5d, y6, y6b, y6bd, y6d, y7, y7b, y7bd, y7d, y8, y8b, y8bd, y8d, y9, y9b, y9bd, y9d, yb, ybd,
      yd, z0, z0b, z0bd, z0d, z1, z1b, z1bd, z1d, z2, z2_2, z2_2b, z2_2bd, z2_2d, z2_3, z2_3b,
      z2_3bd, z2_3d, z2b, z2bd, z2d, z3, z3_2, z3_2b, z3_2bd, z3_2d, z3_3, z3_3b, z3_3bd, z3_3d,
      z3b, z3bd, z3d, z40, z40b, z40bd, z40d, z41b, z41bd, z5, z5b, z5bd, z5d, z6, z6b, z6bd, z6d,
      z7, z7b, z7bd, z7d;

  for (i = t->nwheel - 1; i >= 0; --i) {
    road = t->wheelroad[i];
    axis0 = p[t->wheelaxis[i]];
    axis0d = pd[t->wheelaxis[i]];
    axis1 = p[t->wheelaxis[i] + 1];
    axis1d = pd[t->wheelaxis[i] + 1];
    axis2 = p[t->wheelaxis[i] + 2];
    axis2d = pd[t->wheelaxis[i] + 2];
    ua0 = A[t->wheelbody[i]][0] * axis0 + A[t->wheelbody[i]][1] * axis1 + A[t->wheelbody[i]][2] *
        axis2;
    ua0d = Ad[t->wheelbody[i]][0] * axis0 + A[t->wheelbody[i]][0] * axis0d + (Ad[t->wheelbody[i]][1]
        * axis1 + A[t->wheelbody[i]][1] * axis1d) + (Ad[t->wheelbody[i]][2] * axis2 +
        A[t->wheelbody[i]][2] * axis2d);
    ua1 = A[t->wheelbody[i]][3] * axis0 + A[t->wheelbody[i]][4] * axis1 + A[t->wheelbody[i]][5] *
        axis2;
    ua1d = Ad[t->wheelbody[i]][3] * axis0 + A[t->wheelbody[i]][3] * axis0d + (Ad[t->wheelbody[i]][4]
        * axis1 + A[t->wheelbody[i]][4] * axis1d) + (Ad[t->wheelbody[i]][5] * axis2 +
        A[t->wheelbody[i]][5] * axis2d);
    ua2 = A[t->wheelbody[i]][6] * axis0 + A[t->wheelbody[i]][7] * axis1 + A[t->wheelbody[i]][8] *
        axis2;
    ua2d = Ad[t->wheelbody[i]][6] * axis0 + A[t->wheelbody[i]][6] * axis0d + (Ad[t->wheelbody[i]][7]
        * axis1 + A[t->wheelbody[i]][7] * axis1d) + (Ad[t->wheelbody[i]][8] * axis2 +
        A[t->wheelbody[i]][8] * axis2d);
    t2 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
    t2d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
    n2 = sqrt(t2);
    n2d = 1.0 / (2.0 * n2) * t2d;
    u0 = ua0 / n2;
    u0d = (ua0d - u0 * n2d) * (1.0 / n2);
    u1 = ua1 / n2;
    u1d = (ua1d - u1 * n2d) * (1.0 / n2);
    u2_2 = ua2 / n2;
    u2_2d = (ua2d - u2_2 * n2d) * (1.0 / n2);
    g0 = r[t->wheelpoint[i]][0] - r[t->roadpoint[road]][0];
    g0d = rd[t->wheelpoint[i]][0] - rd[t->roadpoint[road]][0];
    g2_2 = r[t->wheelpoint[i]][2] - r[t->roadpoint[road]][2];
    g2_2d = rd[t->wheelpoint[i]][2] - rd[t->roadpoint[road]][2];
    x2 = g0;
    x2d = g0d;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      p_roadd = pd[t->roadadr[road]];
      h00 = p_road * x2;
      h00d = p_roadd * x2 + p_road * x2d;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k4 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      k4d = -(k4 * pd[t->roadadr[road] + 1] * (1.0 / p[t->roadadr[road] + 1]));
      t3 = k4 * x2;
      t3d = k4d * x2 + k4 * x2d;
      t4 = sin(t3);
      t4d = cos(t3) * t3d;
      p_road2 = p[t->roadadr[road]];
      p_road2d = pd[t->roadadr[road]];
      h00 = p_road2 * t4;
      h00d = p_road2d * t4 + p_road2 * t4d;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k3 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x2);
      x3 = x2 - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k3 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      x3d = x2d - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k3 * pd[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius = p[t->roadadr[road]];
      radiusd = pd[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      based = radiusd - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      t5d = radiusd * radius + radius * radiusd - (based * base + base * based);
      c2 = sqrt(t5);
      c2d = 1.0 / (2.0 * c2) * t5d;
      f2 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      f2d = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x3) > 0.0) {
        way = 1.0;
      } else {
        way = -1.0;
      }
      y = way * x3;
      yd = way * x3d;
      if (MAGGI_RE(y) >= MAGGI_RE(c2 + f2)) {
        b0 = 0.0;
        b0d = 0.0;
      } else if (MAGGI_RE(y) > MAGGI_RE(c2 - f2)) {
        t6 = radius * radius - (c2 - f2) * (c2 - f2);
        t6d = radiusd * radius + radius * radiusd - ((c2d - f2d) * (c2 - f2) + (c2 - f2) * (c2d -
            f2d));
        z2 = sqrt(t6);
        z2d = 1.0 / (2.0 * z2) * t6d;
        h0_2 = z2 - base;
        h0_2d = z2d - based;
        h1_2 = 2.0 * f2 * (c2 - f2) / z2;
        h1_2d = (2.0 * f2d * (c2 - f2) + 2.0 * f2 * (c2d - f2d) - h1_2 * z2d) * (1.0 / z2);
        a = 3.0 * h0_2 - h1_2;
        ad = 3.0 * h0_2d - h1_2d;
        t7 = z2 * z2 * z2;
        t7d = (z2d * z2 + z2 * z2d) * z2 + z2 * z2 * z2d;
        t8 = 2.0 * f2 * f2 * radius * radius / t7;
        t8d = (((2.0 * f2d * f2 + 2.0 * f2 * f2d) * radius + 2.0 * f2 * f2 * radiusd) * radius + 2.0
            * f2 * f2 * radius * radiusd - t8 * t7d) * (1.0 / t7);
        b2 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        b2d = 6.0 * h0_2d - 3.0 * h1_2d - t8d;
        t9 = 2.0 * f2;
        t9d = 2.0 * f2d;
        u2 = (c2 + f2 - y) / t9;
        u2d = (c2d + f2d - yd - u2 * t9d) * (1.0 / t9);
        w2 = 1.0 - u2;
        w2d = -u2d;
        b0 = u2 * u2 * u2 * (h0_2 + w2 * (a + w2 * b2));
        b0d = ((u2d * u2 + u2 * u2d) * u2 + u2 * u2 * u2d) * (h0_2 + w2 * (a + w2 * b2)) + u2 * u2 *
            u2 * (h0_2d + (w2d * (a + w2 * b2) + w2 * (ad + (w2d * b2 + w2 * b2d))));
      } else {
        t10 = radius * radius - y * y;
        t10d = radiusd * radius + radius * radiusd - (yd * y + y * yd);
        z2_3 = sqrt(t10);
        z2_3d = 1.0 / (2.0 * z2_3) * t10d;
        b0 = z2_3 - base;
        b0d = z2_3d - based;
      }
      h00 = b0;
      h00d = b0d;
    } else {
      k5 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x2);
      if (k5 < 0) {
        p_road3 = p[t->roadadr[road]];
        p_road3d = pd[t->roadadr[road]];
        h = p[t->roadadr[road] + 1] - p_road3;
        hd = pd[t->roadadr[road] + 1] - p_road3d;
        p_roadroad = p[t->roadadr[road] + t->roadn[road]];
        p_roadroadd = pd[t->roadadr[road] + t->roadn[road]];
        t11 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad) / h;
        t11d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroadd - t11 * hd) * (1.0 / h);
        slope = t11 - h / 6.0 * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road]
            + 1][0]);
        sloped = t11d - (hd / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]) + h / 6.0 * (2.0 * spline0d[t->roadspline[road]][0]
            + spline0d[t->roadspline[road] + 1][0]));
        s20 = p_roadroad + slope * (x2 - p_road3);
        s20d = p_roadroadd + (sloped * (x2 - p_road3) + slope * (x2d - p_road3d));
      } else if (k5 > t->roadn[road] - 2) {
        p2 = p[t->roadadr[road] + t->roadn[road] - 1];
        p2d = pd[t->roadadr[road] + t->roadn[road] - 1];
        h3 = p2 - p[t->roadadr[road] + t->roadn[road] - 2];
        h3d = p2d - pd[t->roadadr[road] + t->roadn[road] - 2];
        p3 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        p3d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t12 = (p3 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h3;
        t12d = (p3d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t12 * h3d) * (1.0
            / h3);
        slope3 = t12 + h3 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        slope3d = t12d + (h3d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h3 / 6.0 *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0]));
        s20 = p3 + slope3 * (x2 - p2);
        s20d = p3d + (slope3d * (x2 - p2) + slope3 * (x2d - p2d));
      } else {
        p_roadk51 = p[t->roadadr[road] + k5 + 1];
        p_roadk51d = pd[t->roadadr[road] + k5 + 1];
        p_roadk5 = p[t->roadadr[road] + k5];
        p_roadk5d = pd[t->roadadr[road] + k5];
        h3_2 = p_roadk51 - p_roadk5;
        h3_2d = p_roadk51d - p_roadk5d;
        a2 = p_roadk51 - x2;
        a2d = p_roadk51d - x2d;
        c3 = x2 - p_roadk5;
        c3d = x2d - p_roadk5d;
        p4 = p[t->roadadr[road] + t->roadn[road] + k5];
        p4d = pd[t->roadadr[road] + t->roadn[road] + k5];
        t13 = (p[t->roadadr[road] + t->roadn[road] + k5 + 1] - p4) / h3_2;
        t13d = (pd[t->roadadr[road] + t->roadn[road] + k5 + 1] - p4d - t13 * h3_2d) * (1.0 / h3_2);
        spline0_roadk510 = spline0[t->roadspline[road] + k5 + 1][0];
        spline0_roadk510d = spline0d[t->roadspline[road] + k5 + 1][0];
        spline0_roadk50 = spline0[t->roadspline[road] + k5][0];
        spline0_roadk50d = spline0d[t->roadspline[road] + k5][0];
        e = t13 - h3_2 / 6.0 * (spline0_roadk510 - spline0_roadk50);
        ed = t13d - (h3_2d / 6.0 * (spline0_roadk510 - spline0_roadk50) + h3_2 / 6.0 *
            (spline0_roadk510d - spline0_roadk50d));
        t14 = 6.0 * h3_2;
        t14d = 6.0 * h3_2d;
        t15 = (spline0_roadk50 * a2 * a2 * a2 + spline0_roadk510 * c3 * c3 * c3) / t14;
        t15d = (((spline0_roadk50d * a2 + spline0_roadk50 * a2d) * a2 + spline0_roadk50 * a2 * a2d)
            * a2 + spline0_roadk50 * a2 * a2 * a2d + (((spline0_roadk510d * c3 + spline0_roadk510 *
            c3d) * c3 + spline0_roadk510 * c3 * c3d) * c3 + spline0_roadk510 * c3 * c3 * c3d) - t15
            * t14d) * (1.0 / t14);
        s20 = t15 + p4 - spline0_roadk50 * h3_2 * h3_2 / 6.0 + e * c3;
        s20d = t15d + p4d - ((spline0_roadk50d * h3_2 + spline0_roadk50 * h3_2d) * h3_2 +
            spline0_roadk50 * h3_2 * h3_2d) / 6.0 + (ed * c3 + e * c3d);
      }
      h00 = s20;
      h00d = s20d;
    }
    t16 = u0 * u0 + u1 * u1;
    t16d = u0d * u0 + u0 * u0d + (u1d * u1 + u1 * u1d);
    t17 = u2_2 * u0 / t16;
    t17d = (u2_2d * u0 + u2_2 * u0d - t17 * t16d) * (1.0 / t16);
    x = g0 + t17 * (g2_2 - h00);
    xd = g0d + (t17d * (g2_2 - h00) + t17 * (g2_2d - h00d));
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road4 = p[t->roadadr[road]];
      p_road4d = pd[t->roadadr[road]];
      h10 = p_road4 * x;
      h10d = p_road4d * x + p_road4 * xd;
      h11 = p_road4;
      h11d = p_road4d;
      h12 = 0.0;
      h12d = 0.0;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k7 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      k7d = -(k7 * pd[t->roadadr[road] + 1] * (1.0 / p[t->roadadr[road] + 1]));
      t18 = k7 * x;
      t18d = k7d * x + k7 * xd;
      t19 = sin(t18);
      t19d = cos(t18) * t18d;
      p_road5 = p[t->roadadr[road]];
      p_road5d = pd[t->roadadr[road]];
      h10 = p_road5 * t19;
      h10d = p_road5d * t19 + p_road5 * t19d;
      t20 = k7 * x;
      t20d = k7d * x + k7 * xd;
      t21 = cos(t20);
      t21d = -(sin(t20) * t20d);
      h11 = k7 * p_road5 * t21;
      h11d = (k7d * p_road5 + k7 * p_road5d) * t21 + k7 * p_road5 * t21d;
      h12 = 0.0;
      h12d = 0.0;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k6 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x);
      x4 = x - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k6 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      x4d = xd - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k6 * pd[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius2 = p[t->roadadr[road]];
      radius2d = pd[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      base2d = radius2d - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      t22d = radius2d * radius2 + radius2 * radius2d - (base2d * base2 + base2 * base2d);
      c4 = sqrt(t22);
      c4d = 1.0 / (2.0 * c4) * t22d;
      f3 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      f3d = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x4) > 0.0) {
        way2 = 1.0;
      } else {
        way2 = -1.0;
      }
      y2 = way2 * x4;
      y2d = way2 * x4d;
      if (MAGGI_RE(y2) >= MAGGI_RE(c4 + f3)) {
        b30 = 0.0;
        b30d = 0.0;
        b31 = 0.0;
        b31d = 0.0;
      } else if (MAGGI_RE(y2) > MAGGI_RE(c4 - f3)) {
        t23 = radius2 * radius2 - (c4 - f3) * (c4 - f3);
        t23d = radius2d * radius2 + radius2 * radius2d - ((c4d - f3d) * (c4 - f3) + (c4 - f3) * (c4d
            - f3d));
        z3 = sqrt(t23);
        z3d = 1.0 / (2.0 * z3) * t23d;
        h0_3 = z3 - base2;
        h0_3d = z3d - base2d;
        h1_3 = 2.0 * f3 * (c4 - f3) / z3;
        h1_3d = (2.0 * f3d * (c4 - f3) + 2.0 * f3 * (c4d - f3d) - h1_3 * z3d) * (1.0 / z3);
        a3 = 3.0 * h0_3 - h1_3;
        a3d = 3.0 * h0_3d - h1_3d;
        t24 = z3 * z3 * z3;
        t24d = (z3d * z3 + z3 * z3d) * z3 + z3 * z3 * z3d;
        t25 = 2.0 * f3 * f3 * radius2 * radius2 / t24;
        t25d = (((2.0 * f3d * f3 + 2.0 * f3 * f3d) * radius2 + 2.0 * f3 * f3 * radius2d) * radius2 +
            2.0 * f3 * f3 * radius2 * radius2d - t25 * t24d) * (1.0 / t24);
        b4 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        b4d = 6.0 * h0_3d - 3.0 * h1_3d - t25d;
        t26 = 2.0 * f3;
        t26d = 2.0 * f3d;
        u3 = (c4 + f3 - y2) / t26;
        u3d = (c4d + f3d - y2d - u3 * t26d) * (1.0 / t26);
        w3 = 1.0 - u3;
        w3d = -u3d;
        b30 = u3 * u3 * u3 * (h0_3 + w3 * (a3 + w3 * b4));
        b30d = ((u3d * u3 + u3 * u3d) * u3 + u3 * u3 * u3d) * (h0_3 + w3 * (a3 + w3 * b4)) + u3 * u3
            * u3 * (h0_3d + (w3d * (a3 + w3 * b4) + w3 * (a3d + (w3d * b4 + w3 * b4d))));
        t27 = 2.0 * f3;
        t27d = 2.0 * f3d;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 * (a3 + 2.0 * w3 * b4)) /
            t27;
        t28d = ((-(way2 * u3d * u3) + -way2 * u3 * u3d) * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 *
            (a3 + 2.0 * w3 * b4)) + -way2 * u3 * u3 * (3.0 * (h0_3d + (w3d * (a3 + w3 * b4) + w3 *
            (a3d + (w3d * b4 + w3 * b4d)))) - (u3d * (a3 + 2.0 * w3 * b4) + u3 * (a3d + (2.0 * w3d *
            b4 + 2.0 * w3 * b4d)))) - t28 * t27d) * (1.0 / t27);
        b31 = t28;
        b31d = t28d;
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        t29d = radius2d * radius2 + radius2 * radius2d - (y2d * y2 + y2 * y2d);
        z3_3 = sqrt(t29);
        z3_3d = 1.0 / (2.0 * z3_3) * t29d;
        b30 = z3_3 - base2;
        b30d = z3_3d - base2d;
        t30 = -x4 / z3_3;
        t30d = (-x4d - t30 * z3_3d) * (1.0 / z3_3);
        b31 = t30;
        b31d = t30d;
      }
      h10 = b30;
      h10d = b30d;
      h11 = 0.0;
      h11d = 0.0;
      h12 = b31;
      h12d = b31d;
    } else {
      k8 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x);
      if (k8 < 0) {
        p_road6 = p[t->roadadr[road]];
        p_road6d = pd[t->roadadr[road]];
        h2 = p[t->roadadr[road] + 1] - p_road6;
        h2d = pd[t->roadadr[road] + 1] - p_road6d;
        p_roadroad2 = p[t->roadadr[road] + t->roadn[road]];
        p_roadroad2d = pd[t->roadadr[road] + t->roadn[road]];
        t31 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2) / h2;
        t31d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2d - t31 * h2d) * (1.0 / h2);
        slope2 = t31 - h2 / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]);
        slope2d = t31d - (h2d / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]) + h2 / 6.0 * (2.0 *
            spline0d[t->roadspline[road]][0] + spline0d[t->roadspline[road] + 1][0]));
        s30 = p_roadroad2 + slope2 * (x - p_road6);
        s30d = p_roadroad2d + (slope2d * (x - p_road6) + slope2 * (xd - p_road6d));
        s31 = slope2;
        s31d = slope2d;
      } else if (k8 > t->roadn[road] - 2) {
        p5 = p[t->roadadr[road] + t->roadn[road] - 1];
        p5d = pd[t->roadadr[road] + t->roadn[road] - 1];
        h2_2 = p5 - p[t->roadadr[road] + t->roadn[road] - 2];
        h2_2d = p5d - pd[t->roadadr[road] + t->roadn[road] - 2];
        p6 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        p6d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t32 = (p6 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h2_2;
        t32d = (p6d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t32 * h2_2d) *
            (1.0 / h2_2);
        slope2_2 = t32 + h2_2 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        slope2_2d = t32d + (h2_2d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] +
            2.0 * spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h2_2 / 6.0 *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0]));
        s30 = p6 + slope2_2 * (x - p5);
        s30d = p6d + (slope2_2d * (x - p5) + slope2_2 * (xd - p5d));
        s31 = slope2_2;
        s31d = slope2_2d;
      } else {
        p_roadk81 = p[t->roadadr[road] + k8 + 1];
        p_roadk81d = pd[t->roadadr[road] + k8 + 1];
        p_roadk8 = p[t->roadadr[road] + k8];
        p_roadk8d = pd[t->roadadr[road] + k8];
        h2_3 = p_roadk81 - p_roadk8;
        h2_3d = p_roadk81d - p_roadk8d;
        a4 = p_roadk81 - x;
        a4d = p_roadk81d - xd;
        c5 = x - p_roadk8;
        c5d = xd - p_roadk8d;
        p7 = p[t->roadadr[road] + t->roadn[road] + k8];
        p7d = pd[t->roadadr[road] + t->roadn[road] + k8];
        t33 = (p[t->roadadr[road] + t->roadn[road] + k8 + 1] - p7) / h2_3;
        t33d = (pd[t->roadadr[road] + t->roadn[road] + k8 + 1] - p7d - t33 * h2_3d) * (1.0 / h2_3);
        spline0_roadk810 = spline0[t->roadspline[road] + k8 + 1][0];
        spline0_roadk810d = spline0d[t->roadspline[road] + k8 + 1][0];
        spline0_roadk80 = spline0[t->roadspline[road] + k8][0];
        spline0_roadk80d = spline0d[t->roadspline[road] + k8][0];
        e2 = t33 - h2_3 / 6.0 * (spline0_roadk810 - spline0_roadk80);
        e2d = t33d - (h2_3d / 6.0 * (spline0_roadk810 - spline0_roadk80) + h2_3 / 6.0 *
            (spline0_roadk810d - spline0_roadk80d));
        t34 = 6.0 * h2_3;
        t34d = 6.0 * h2_3d;
        t35 = (spline0_roadk80 * a4 * a4 * a4 + spline0_roadk810 * c5 * c5 * c5) / t34;
        t35d = (((spline0_roadk80d * a4 + spline0_roadk80 * a4d) * a4 + spline0_roadk80 * a4 * a4d)
            * a4 + spline0_roadk80 * a4 * a4 * a4d + (((spline0_roadk810d * c5 + spline0_roadk810 *
            c5d) * c5 + spline0_roadk810 * c5 * c5d) * c5 + spline0_roadk810 * c5 * c5 * c5d) - t35
            * t34d) * (1.0 / t34);
        s30 = t35 + p7 - spline0_roadk80 * h2_3 * h2_3 / 6.0 + e2 * c5;
        s30d = t35d + p7d - ((spline0_roadk80d * h2_3 + spline0_roadk80 * h2_3d) * h2_3 +
            spline0_roadk80 * h2_3 * h2_3d) / 6.0 + (e2d * c5 + e2 * c5d);
        t36 = 2.0 * h2_3;
        t36d = 2.0 * h2_3d;
        t37 = (spline0_roadk810 * c5 * c5 - spline0_roadk80 * a4 * a4) / t36;
        t37d = ((spline0_roadk810d * c5 + spline0_roadk810 * c5d) * c5 + spline0_roadk810 * c5 * c5d
            - ((spline0_roadk80d * a4 + spline0_roadk80 * a4d) * a4 + spline0_roadk80 * a4 * a4d) -
            t37 * t36d) * (1.0 / t36);
        s31 = t37 + e2;
        s31d = t37d + e2d;
      }
      h10 = s30;
      h10d = s30d;
      h11 = s31;
      h11d = s31d;
      h12 = 0.0;
      h12d = 0.0;
    }
    t38 = 1.0 + h11 * h11;
    t38d = h11d * h11 + h11 * h11d;
    s = sqrt(t38);
    sd = 1.0 / (2.0 * s) * t38d;
    normal0 = -h11 / s;
    normal0d = (-h11d - normal0 * sd) * (1.0 / s);
    normal1 = 0.0;
    normal2 = 1.0 / s;
    normal2d = -(normal2 * sd * (1.0 / s));
    c = u0 * normal0 + u1 * normal1 + u2_2 * normal2;
    cd = u0d * normal0 + u0 * normal0d + u1d * normal1 + (u2_2d * normal2 + u2_2 * normal2d);
    un0 = u1 * normal2 - u2_2 * normal1;
    un0d = u1d * normal2 + u1 * normal2d - u2_2d * normal1;
    un1 = u2_2 * normal0 - u0 * normal2;
    un1d = u2_2d * normal0 + u2_2 * normal0d - (u0d * normal2 + u0 * normal2d);
    un2 = u0 * normal1 - u1 * normal0;
    un2d = u0d * normal1 - (u1d * normal0 + u1 * normal0d);
    t39 = un0 * un0 + un1 * un1 + un2 * un2;
    t39d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
    w = sqrt(t39);
    wd = 1.0 / (2.0 * w) * t39d;
    r2 = ((g0 - x) * normal0 + (g2_2 - h10) * normal2) / w;
    r2d = ((g0d - xd) * normal0 + (g0 - x) * normal0d + ((g2_2d - h10d) * normal2 + (g2_2 - h10) *
        normal2d) - r2 * wd) * (1.0 / w);
    along0 = un0 / w;
    along0d = (un0d - along0 * wd) * (1.0 / w);
    along1 = un1 / w;
    along1d = (un1d - along1 * wd) * (1.0 / w);
    along2 = un2 / w;
    along2d = (un2d - along2 * wd) * (1.0 / w);
    L0 = normal1 * along2 - normal2 * along1;
    L0d = normal1 * along2d - (normal2d * along1 + normal2 * along1d);
    L1 = normal2 * along0 - normal0 * along2;
    L1d = normal2d * along0 + normal2 * along0d - (normal0d * along2 + normal0 * along2d);
    L2 = normal0 * along1 - normal1 * along0;
    L2d = normal0d * along1 + normal0 * along1d - normal1 * along0d;
    arm0 = r2 * (c * u0 - normal0) / w;
    arm0d = (r2d * (c * u0 - normal0) + r2 * (cd * u0 + c * u0d - normal0d) - arm0 * wd) * (1.0 /
        w);
    T0 = along0;
    T0d = along0d;
    N0 = normal0;
    N0d = normal0d;
    arm1 = r2 * (c * u1 - normal1) / w;
    arm1d = (r2d * (c * u1 - normal1) + r2 * (cd * u1 + c * u1d) - arm1 * wd) * (1.0 / w);
    T1 = along1;
    T1d = along1d;
    N1 = normal1;
    arm2 = r2 * (c * u2_2 - normal2) / w;
    arm2d = (r2d * (c * u2_2 - normal2) + r2 * (cd * u2_2 + c * u2_2d - normal2d) - arm2 * wd) *
        (1.0 / w);
    T2 = along2;
    T2d = along2d;
    N2 = normal2;
    N2d = normal2d;
    z0 = r2;
    z0d = r2d;
    z1 = c;
    z1d = cd;
    z2_2 = w;
    z2_2d = wd;
    z3_2 = h12;
    z3_2d = h12d;
    Z_i3 = Z[t->wheelbody[i]][3];
    Z_i3d = Zd[t->wheelbody[i]][3];
    Z_i4 = Z[t->wheelbody[i]][4];
    Z_i4d = Zd[t->wheelbody[i]][4];
    Z_i5 = Z[t->wheelbody[i]][5];
    Z_i5d = Zd[t->wheelbody[i]][5];
    omega = Z_i3 * u0 + Z_i4 * u1 + Z_i5 * u2_2;
    omegad = Z_i3d * u0 + Z_i3 * u0d + (Z_i4d * u1 + Z_i4 * u1d) + (Z_i5d * u2_2 + Z_i5 * u2_2d);
    wr0 = Z_i3 - omega * u0;
    wr0d = Z_i3d - (omegad * u0 + omega * u0d);
    wr1 = Z_i4 - omega * u1;
    wr1d = Z_i4d - (omegad * u1 + omega * u1d);
    wr2 = Z_i5 - omega * u2_2;
    wr2d = Z_i5d - (omegad * u2_2 + omega * u2_2d);
    vr0 = wr1 * arm2 - wr2 * arm1;
    vr0d = wr1d * arm2 + wr1 * arm2d - (wr2d * arm1 + wr2 * arm1d);
    vr1 = wr2 * arm0 - wr0 * arm2;
    vr1d = wr2d * arm0 + wr2 * arm0d - (wr0d * arm2 + wr0 * arm2d);
    vr2 = wr0 * arm1 - wr1 * arm0;
    vr2d = wr0d * arm1 + wr0 * arm1d - (wr1d * arm0 + wr1 * arm0d);
    v0 = rv[t->wheelpoint[i]][0] + vr0;
    v0d = rvd[t->wheelpoint[i]][0] + vr0d;
    v1 = rv[t->wheelpoint[i]][1] + vr1;
    v1d = rvd[t->wheelpoint[i]][1] + vr1d;
    v2 = rv[t->wheelpoint[i]][2] + vr2;
    v2d = rvd[t->wheelpoint[i]][2] + vr2d;
    vx = slip[i][MAGGI_SLIP_VX];
    vxd = slipd[i][MAGGI_SLIP_VX];
    rhov = (z3_2 * v0 - (v0 * N0 + v1 * N1 + v2 * N2)) / z2_2;
    rhovd = (z3_2d * v0 + z3_2 * v0d - (v0d * N0 + v0 * N0d + v1d * N1 + (v2d * N2 + v2 * N2d)) -
        rhov * z2_2d) * (1.0 / z2_2);
    fz = slip[i][MAGGI_SLIP_FZ];
    fzd = slipd[i][MAGGI_SLIP_FZ];
    fz0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
    fz0d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]] +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      ratiod = (fzd - ratio * fz0d) * (1.0 / fz0);
      t40 = fz0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t40d = (fz0d - t40 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS]) * (1.0 /
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS]);
      t41 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio;
      t41d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratiod;
      t42 = atan(t41);
      t42d = 1.0 / (1.0 + t41 * t41) * t41d;
      re2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - t40 *
          (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t42 + p[t->tyreadr[t->wheeltyre[i]] +
          MAGGI_TYRE_FREFF] * ratio);
      re2d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - (t40d *
          (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t42 + p[t->tyreadr[t->wheeltyre[i]] +
          MAGGI_TYRE_FREFF] * ratio) + t40 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] *
          t42 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t42d +
          (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratiod)));
    } else {
      re2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
      re2d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
    }
    re = re2;
    red = re2d;
    if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y3 = vx;
      y3d = vxd;
    } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y3 = -vx;
      y3d = -vxd;
    } else {
      p8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      p8d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      t43 = vx * vx / p8;
      t43d = (vxd * vx + vx * vxd - t43 * p8d) * (1.0 / p8);
      y3 = 0.5 * (p8 + t43);
      y3d = 0.5 * (p8d + t43d);
    }
    speed = y3;
    speedd = y3d;
    r30 = r[t->wheelpoint[i]][0] + arm0;
    r30d = rd[t->wheelpoint[i]][0] + arm0d;
    f_i0 = f[i][0];
    f_i0d = fd[i][0];
    f_i1 = f[i][1];
    f_i1d = fd[i][1];
    f_i2 = f[i][2];
    f_i2d = fd[i][2];
    force30 = F[i][0];
    force30d = Fd[i][0];
    r31 = r[t->wheelpoint[i]][1] + arm1;
    r31d = rd[t->wheelpoint[i]][1] + arm1d;
    force31 = F[i][1];
    force31d = Fd[i][1];
    r32 = r[t->wheelpoint[i]][2] + arm2;
    r32d = rd[t->wheelpoint[i]][2] + arm2d;
    force32 = F[i][2];
    force32d = Fd[i][2];
    f_i3 = f[i][3];
    f_i3d = fd[i][3];
    f_i4 = f[i][4];
    f_i4d = fd[i][4];
    f_i5 = f[i][5];
    f_i5d = fd[i][5];
    tb209 = Fb[i][5];
    tb209d = Fbd[i][5];
    Fb[i][5] = 0.0;
    Fbd[i][5] = 0.0;
    moment2b = tb209;
    moment2bd = tb209d;
    f_i3b = tb209 * T2;
    f_i3bd = tb209d * T2 + tb209 * T2d;
    T2b = tb209 * f_i3;
    T2bd = tb209d * f_i3 + tb209 * f_i3d;
    f_i4b = tb209 * L2;
    f_i4bd = tb209d * L2 + tb209 * L2d;
    L2b = tb209 * f_i4;
    L2bd = tb209d * f_i4 + tb209 * f_i4d;
    f_i5b = tb209 * N2;
    f_i5bd = tb209d * N2 + tb209 * N2d;
    N2b = tb209 * f_i5;
    N2bd = tb209d * f_i5 + tb209 * f_i5d;
    force32b = Fb[i][2];
    force32bd = Fbd[i][2];
    Fb[i][2] = 0.0;
    Fbd[i][2] = 0.0;
    tb208 = Fb[i][4];
    tb208d = Fbd[i][4];
    Fb[i][4] = 0.0;
    Fbd[i][4] = 0.0;
    moment1b = tb208;
    moment1bd = tb208d;
    f_i3b += tb208 * T1;
    f_i3bd += tb208d * T1 + tb208 * T1d;
    T1b = tb208 * f_i3;
    T1bd = tb208d * f_i3 + tb208 * f_i3d;
    f_i4b += tb208 * L1;
    f_i4bd += tb208d * L1 + tb208 * L1d;
    L1b = tb208 * f_i4;
    L1bd = tb208d * f_i4 + tb208 * f_i4d;
    f_i5b += tb208 * N1;
    f_i5bd += tb208d * N1;
    force31b = Fb[i][1];
    force31bd = Fbd[i][1];
    Fb[i][1] = 0.0;
    Fbd[i][1] = 0.0;
    tb207 = Fb[i][3];
    tb207d = Fbd[i][3];
    Fb[i][3] = 0.0;
    Fbd[i][3] = 0.0;
    moment0b = tb207;
    moment0bd = tb207d;
    f_i3b += tb207 * T0;
    f_i3bd += tb207d * T0 + tb207 * T0d;
    T0b = tb207 * f_i3;
    T0bd = tb207d * f_i3 + tb207 * f_i3d;
    f_i4b += tb207 * L0;
    f_i4bd += tb207d * L0 + tb207 * L0d;
    L0b = tb207 * f_i4;
    L0bd = tb207d * f_i4 + tb207 * f_i4d;
    f_i5b += tb207 * N0;
    f_i5bd += tb207d * N0 + tb207 * N0d;
    N0b = tb207 * f_i5;
    N0bd = tb207d * f_i5 + tb207 * f_i5d;
    fb[i][5] += f_i5b;
    fbd[i][5] += f_i5bd;
    fb[i][4] += f_i4b;
    fbd[i][4] += f_i4bd;
    fb[i][3] += f_i3b;
    fbd[i][3] += f_i3bd;
    force30b = Fb[i][0];
    force30bd = Fbd[i][0];
    Fb[i][0] = 0.0;
    Fbd[i][0] = 0.0;
    r30b = moment2b * force31;
    r30bd = moment2bd * force31 + moment2b * force31d;
    force31b += moment2b * r30;
    force31bd += moment2bd * r30 + moment2b * r30d;
    r31b = -(moment2b * force30);
    r31bd = -(moment2bd * force30 + moment2b * force30d);
    force30b -= moment2b * r31;
    force30bd -= moment2bd * r31 + moment2b * r31d;
    r32b = moment1b * force30;
    r32bd = moment1bd * force30 + moment1b * force30d;
    force30b += moment1b * r32;
    force30bd += moment1bd * r32 + moment1b * r32d;
    r30b -= moment1b * force32;
    r30bd -= moment1bd * force32 + moment1b * force32d;
    force32b -= moment1b * r30;
    force32bd -= moment1bd * r30 + moment1b * r30d;
    r31b += moment0b * force32;
    r31bd += moment0bd * force32 + moment0b * force32d;
    force32b += moment0b * r31;
    force32bd += moment0bd * r31 + moment0b * r31d;
    r32b -= moment0b * force31;
    r32bd -= moment0bd * force31 + moment0b * force31d;
    force31b -= moment0b * r32;
    force31bd -= moment0bd * r32 + moment0b * r32d;
    f_i0b = force32b * T2;
    f_i0bd = force32bd * T2 + force32b * T2d;
    T2b += force32b * f_i0;
    T2bd += force32bd * f_i0 + force32b * f_i0d;
    f_i1b = force32b * L2;
    f_i1bd = force32bd * L2 + force32b * L2d;
    L2b += force32b * f_i1;
    L2bd += force32bd * f_i1 + force32b * f_i1d;
    f_i2b = force32b * N2;
    f_i2bd = force32bd * N2 + force32b * N2d;
    N2b += force32b * f_i2;
    N2bd += force32bd * f_i2 + force32b * f_i2d;
    rb[t->wheelpoint[i]][2] += r32b;
    rbd[t->wheelpoint[i]][2] += r32bd;
    arm2b = r32b;
    arm2bd = r32bd;
    f_i0b += force31b * T1;
    f_i0bd += force31bd * T1 + force31b * T1d;
    T1b += force31b * f_i0;
    T1bd += force31bd * f_i0 + force31b * f_i0d;
    f_i1b += force31b * L1;
    f_i1bd += force31bd * L1 + force31b * L1d;
    L1b += force31b * f_i1;
    L1bd += force31bd * f_i1 + force31b * f_i1d;
    f_i2b += force31b * N1;
    f_i2bd += force31bd * N1;
    rb[t->wheelpoint[i]][1] += r31b;
    rbd[t->wheelpoint[i]][1] += r31bd;
    arm1b = r31b;
    arm1bd = r31bd;
    f_i0b += force30b * T0;
    f_i0bd += force30bd * T0 + force30b * T0d;
    T0b += force30b * f_i0;
    T0bd += force30bd * f_i0 + force30b * f_i0d;
    f_i1b += force30b * L0;
    f_i1bd += force30bd * L0 + force30b * L0d;
    L0b += force30b * f_i1;
    L0bd += force30bd * f_i1 + force30b * f_i1d;
    f_i2b += force30b * N0;
    f_i2bd += force30bd * N0 + force30b * N0d;
    N0b += force30b * f_i2;
    N0bd += force30bd * f_i2 + force30b * f_i2d;
    fb[i][2] += f_i2b;
    fbd[i][2] += f_i2bd;
    fb[i][1] += f_i1b;
    fbd[i][1] += f_i1bd;
    fb[i][0] += f_i0b;
    fbd[i][0] += f_i0bd;
    rb[t->wheelpoint[i]][0] += r30b;
    /* F: force f_x T + f_y L + f_z N at the contact point, with its moment, as one about P */
    rbd[t->wheelpoint[i]][0] += r30bd;
    arm0b = r30b;
    arm0bd = r30bd;
    fzb = 0.0;
    fzbd = 0.0;
    if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z0) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_UNLOADED_RADIUS])) {
      if (t->wheelgrip[i]) {
        side = t->wheelmirror[i] ? -1.0 : 1.0;
        one0 = slip[i][MAGGI_SLIP_KAPPA];
        one0d = slipd[i][MAGGI_SLIP_KAPPA];
        one1 = side * slip[i][MAGGI_SLIP_TAN_ALPHA];
        one1d = side * slipd[i][MAGGI_SLIP_TAN_ALPHA];
        one2 = side * slip[i][MAGGI_SLIP_GAMMA];
        one2d = side * slipd[i][MAGGI_SLIP_GAMMA];
        one3 = slip[i][MAGGI_SLIP_FZ];
        one3d = slipd[i][MAGGI_SLIP_FZ];
        one4 = slip[i][MAGGI_SLIP_VX];
        one4d = slipd[i][MAGGI_SLIP_VX];
        kappa = one0;
        kappad = one0d;
        a5 = one1;
        a5d = one1d;
        gamma = one2;
        gammad = one2d;
        fz2 = one3;
        fz2d = one3d;
        fz0_2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        fz0_2d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        r0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        r0d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        dfz = (fz2 - fz0_2) / fz0_2;
        dfzd = (fz2d - fz0_2d - dfz * fz0_2d) * (1.0 / fz0_2);
        kx = kappa + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LHX];
        kxd = kappad + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHX2] * dfzd)) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX2] * dfz) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX]);
        gx = gamma * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        gxd = gammad * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] + gamma *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
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
        e3 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz) * dfz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        e3d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + ((pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PEX2] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfzd)) * dfz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX3] * dfz) * dfzd)) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz) * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        if (MAGGI_RE(kx) > 0.0) {
          e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e4d = e3d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) - e3 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          if (MAGGI_RE(e4) > 1.0) {
            y5 = 1.0;
            y5d = 0.0;
          } else {
            y5 = e4;
            y5d = e4d;
          }
          ex = y5;
          exd = y5d;
        } else {
          e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e5d = e3d * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) + e3 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          if (MAGGI_RE(e5) > 1.0) {
            y6 = 1.0;
            y6d = 0.0;
          } else {
            y6 = e5;
            y6d = e5d;
          }
          ex = y6;
          exd = y6d;
        }
        x50 = mux * fz2;
        x50d = muxd * fz2 + mux * fz2d;
        x51 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        x51d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX];
        x52 = ex;
        x52d = exd;
        t44 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz;
        t44d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfzd;
        t45 = exp(t44);
        t45d = t45 * t44d;
        x53 = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t45 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        x53d = ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t45 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t45d) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t45 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        x54 = kx;
        x54d = kxd;
        x55 = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        x55d = ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd))) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LMUX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        fz0_3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        fz0_3d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        gy = gamma * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        gyd = gammad * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] + gamma *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        ay = a5 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gy;
        ayd = a5d + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHY2] * dfzd)) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY2] * dfz) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY]) +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gy + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHY3] * gyd);
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
        e6 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        e6d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        if (MAGGI_RE(ay) > 0.0) {
          e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e7d = e6d * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) - e6 *
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
        } else {
          e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e8d = e6d * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) + e6 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          if (MAGGI_RE(e8) > 1.0) {
            y8 = 1.0;
            y8d = 0.0;
          } else {
            y8 = e8;
            y8d = e8d;
          }
          ey = y8;
          eyd = y8d;
        }
        t46 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3;
        t46d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3d;
        z5 = fz2 / t46;
        z5d = (fz2d - z5 * t46d) * (1.0 / t46);
        y40 = muy * fz2;
        y40d = muyd * fz2 + muy * fz2d;
        y41 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        y41d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY];
        y42 = ey;
        y42d = eyd;
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y9 = gy;
          y9d = gyd;
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y9 = -gy;
          y9d = -gyd;
        } else {
          p9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p9d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t47 = p9 * p9;
          t47d = p9d * p9 + p9 * p9d;
          z6 = gy * gy / t47;
          z6d = (gyd * gy + gy * gyd - z6 * t47d) * (1.0 / t47);
          y9 = 0.125 * p9 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
          y9d = (0.125 * p9d * z6 + 0.125 * p9 * z6d) * (15.0 + z6 * (-10.0 + 3.0 * z6)) + 0.125 *
              p9 * z6 * (z6d * (-10.0 + 3.0 * z6) + z6 * (3.0 * z6d));
        }
        t48 = 1.0 + z5 * z5;
        t48d = z5d * z5 + z5 * z5d;
        t49 = 2.0 * z5 / t48;
        t49d = (2.0 * z5d - t49 * t48d) * (1.0 / t48);
        y43 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t49 * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY];
        y43d = (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d) * t49 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t49d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9) - p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t49 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9d)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t49 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]
            * y9) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        y44 = ay;
        y44d = ayd;
        y45 = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        y45d = (fz2d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
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
        peak = y40;
        peakd = y40d;
        x6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa;
        x6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappad;
        t50 = 1.0 + x6 * x6;
        t50d = x6d * x6 + x6 * x6d;
        t51 = sqrt(t50);
        t51d = 1.0 / (2.0 * t51) * t50d;
        t52 = 1.0 / t51;
        t52d = -(t52 * t51d * (1.0 / t51));
        g20 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t52 * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LXAL];
        g20d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t52 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t52d) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t52 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        g21 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        g21d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        e9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz;
        e9d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] * dfzd);
        if (MAGGI_RE(e9) > 1.0) {
          y10 = 1.0;
          y10d = 0.0;
        } else {
          y10 = e9;
          y10d = e9d;
        }
        g22 = y10;
        g22d = y10d;
        g23 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        g23d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        x7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a5 - p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBY3]);
        x7d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a5 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RBY2] * (a5d - pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]);
        t53 = 1.0 + x7 * x7;
        t53d = x7d * x7 + x7 * x7d;
        t54 = sqrt(t53);
        t54d = 1.0 / (2.0 * t54) * t53d;
        t55 = 1.0 / t54;
        t55d = -(t55 * t54d * (1.0 / t54));
        g24 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t55 * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LYKA];
        g24d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t55 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t55d) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t55 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        g25 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        g25d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        e10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz;
        e10d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] * dfzd);
        if (MAGGI_RE(e10) > 1.0) {
          y11 = 1.0;
          y11d = 0.0;
        } else {
          y11 = e10;
          y11d = e10d;
        }
        g26 = y11;
        g26d = y11d;
        g27 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz;
        g27d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] * dfzd);
        x8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a5;
        x8d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a5 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RVY4] * a5d;
        t56 = 1.0 + x8 * x8;
        t56d = x8d * x8 + x8 * x8d;
        t57 = sqrt(t56);
        t57d = 1.0 / (2.0 * t57) * t56d;
        t58 = 1.0 / t57;
        t58d = -(t58 * t57d * (1.0 / t57));
        dv = peak * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma) * t58;
        dvd = (peakd * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma) + peak * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RVY2] * dfzd) + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gammad))) * t58 + peak *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma) *
            t58d;
        t59 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa;
        t59d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappad;
        t60 = atan(t59);
        t60d = 1.0 / (1.0 + t59 * t59) * t59d;
        t61 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t60;
        t61d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t60 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t60d;
        t62 = sin(t61);
        t62d = cos(t61) * t61d;
        g28 = dv * t62 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        g28d = (dvd * t62 + dv * t62d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] + dv *
            t62 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        t63 = x51 * x50;
        t63d = x51d * x50 + x51 * x50d;
        t64 = x53 / t63;
        t64d = (x53d - t64 * t63d) * (1.0 / t63);
        y12 = t64 * x54;
        y12d = t64d * x54 + t64 * x54d;
        y13 = g20 * (a5 + g23);
        y13d = g20d * (a5 + g23) + g20 * (a5d + g23d);
        y14 = g20 * g23;
        y14d = g20d * g23 + g20 * g23d;
        t65 = atan(y12);
        t65d = 1.0 / (1.0 + y12 * y12) * y12d;
        t66 = (1.0 - x52) * y12 + x52 * t65;
        t66d = -(x52d * y12) + (1.0 - x52) * y12d + (x52d * t65 + x52 * t65d);
        t67 = atan(t66);
        t67d = 1.0 / (1.0 + t66 * t66) * t66d;
        t68 = x51 * t67;
        t68d = x51d * t67 + x51 * t67d;
        t69 = sin(t68);
        t69d = cos(t68) * t68d;
        t70 = atan(y13);
        t70d = 1.0 / (1.0 + y13 * y13) * y13d;
        t71 = (1.0 - g22) * y13 + g22 * t70;
        t71d = -(g22d * y13) + (1.0 - g22) * y13d + (g22d * t70 + g22 * t70d);
        t72 = atan(t71);
        t72d = 1.0 / (1.0 + t71 * t71) * t71d;
        t73 = g21 * t72;
        t73d = g21d * t72 + g21 * t72d;
        t74 = cos(t73);
        t74d = -(sin(t73) * t73d);
        t75 = atan(y14);
        t75d = 1.0 / (1.0 + y14 * y14) * y14d;
        t76 = (1.0 - g22) * y14 + g22 * t75;
        t76d = -(g22d * y14) + (1.0 - g22) * y14d + (g22d * t75 + g22 * t75d);
        t77 = atan(t76);
        t77d = 1.0 / (1.0 + t76 * t76) * t76d;
        t78 = g21 * t77;
        t78d = g21d * t77 + g21 * t77d;
        t79 = cos(t78);
        t79d = -(sin(t78) * t78d);
        t80 = t74 / t79;
        t80d = (t74d - t80 * t79d) * (1.0 / t79);
        fx = (x50 * t69 + x55) * t80;
        fxd = (x50d * t69 + x50 * t69d + x55d) * t80 + (x50 * t69 + x55) * t80d;
        t81 = y41 * y40;
        t81d = y41d * y40 + y41 * y40d;
        t82 = y43 / t81;
        t82d = (y43d - t82 * t81d) * (1.0 / t81);
        y15 = t82 * y44;
        y15d = t82d * y44 + t82 * y44d;
        y16 = g24 * (kappa + g27);
        y16d = g24d * (kappa + g27) + g24 * (kappad + g27d);
        y17 = g24 * g27;
        y17d = g24d * g27 + g24 * g27d;
        t83 = atan(y15);
        t83d = 1.0 / (1.0 + y15 * y15) * y15d;
        t84 = (1.0 - y42) * y15 + y42 * t83;
        t84d = -(y42d * y15) + (1.0 - y42) * y15d + (y42d * t83 + y42 * t83d);
        t85 = atan(t84);
        t85d = 1.0 / (1.0 + t84 * t84) * t84d;
        t86 = y41 * t85;
        t86d = y41d * t85 + y41 * t85d;
        t87 = sin(t86);
        t87d = cos(t86) * t86d;
        t88 = atan(y16);
        t88d = 1.0 / (1.0 + y16 * y16) * y16d;
        t89 = (1.0 - g26) * y16 + g26 * t88;
        t89d = -(g26d * y16) + (1.0 - g26) * y16d + (g26d * t88 + g26 * t88d);
        t90 = atan(t89);
        t90d = 1.0 / (1.0 + t89 * t89) * t89d;
        t91 = g25 * t90;
        t91d = g25d * t90 + g25 * t90d;
        t92 = cos(t91);
        t92d = -(sin(t91) * t91d);
        t93 = atan(y17);
        t93d = 1.0 / (1.0 + y17 * y17) * y17d;
        t94 = (1.0 - g26) * y17 + g26 * t93;
        t94d = -(g26d * y17) + (1.0 - g26) * y17d + (g26d * t93 + g26 * t93d);
        t95 = atan(t94);
        t95d = 1.0 / (1.0 + t94 * t94) * t94d;
        t96 = g25 * t95;
        t96d = g25d * t95 + g25 * t95d;
        t97 = cos(t96);
        t97d = -(sin(t96) * t96d);
        t98 = t92 / t97;
        t98d = (t92d - t98 * t97d) * (1.0 / t97);
        fy = (y40 * t87 + y45) * t98;
        fyd = (y40d * t87 + y40 * t87d + y45d) * t98 + (y40 * t87 + y45) * t98d;
        ratio2 = x53 * kappa / y43;
        ratio2d = (x53d * kappa + x53 * kappad - ratio2 * y43d) * (1.0 / y43);
        fz0_4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        fz0_4d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        gz = gamma * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        gzd = gammad * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] + gamma *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        at = a5 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QHZ2] * dfz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gz;
        atd = a5d + pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QHZ2] * dfzd) + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QHZ4] * dfzd)) * gz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gzd);
        t99 = y45 / y43;
        t99d = (y45d - t99 * y43d) * (1.0 / y43);
        ar = y44 + t99;
        ard = y44d + t99d;
        t100 = at * at + ratio2 * ratio2 + 1e-24;
        t100d = atd * at + at * atd + (ratio2d * ratio2 + ratio2 * ratio2d);
        ateq = sqrt(t100);
        ateqd = 1.0 / (2.0 * ateq) * t100d;
        t101 = ar * ar + ratio2 * ratio2 + 1e-24;
        t101d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
        areq = sqrt(t101);
        areqd = 1.0 / (2.0 * areq) * t101d;
        scale = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LMUY];
        scaled = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] - scale *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]);
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y18 = gz;
          y18d = gzd;
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y18 = -gz;
          y18d = -gzd;
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p10d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t102 = p10 * p10;
          t102d = p10d * p10 + p10 * p10d;
          z7 = gz * gz / t102;
          z7d = (gzd * gz + gz * gzd - z7 * t102d) * (1.0 / t102);
          y18 = 0.125 * p10 * z7 * (15.0 + z7 * (-10.0 + 3.0 * z7));
          y18d = (0.125 * p10d * z7 + 0.125 * p10 * z7d) * (15.0 + z7 * (-10.0 + 3.0 * z7)) + 0.125
              * p10 * z7 * (z7d * (-10.0 + 3.0 * z7) + z7 * (3.0 * z7d));
        }
        bt = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz) * dfz) * (1.0
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ5] * y18) * scale;
        btd = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + ((pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ2] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfzd)) * dfz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz) * dfzd)) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18) +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz) * dfz) *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ4] * gzd + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18d))) * scale +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz) * dfz) * (1.0
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ5] * y18) * scaled;
        t103 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
        t103d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - t103 * fz0_4d) *
            (1.0 / fz0_4);
        dt = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gz) * t103 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        dtd = (((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfzd))) *
            (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ4] * gz) * gz) + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gzd)) * gz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz) * gzd)) * t103 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz) * gz) * t103d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR]
            + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz) * gz) * t103 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        t104 = bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * at;
        t104d = (btd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + bt *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1]) * at + bt *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * atd;
        t105 = atan(t104);
        t105d = 1.0 / (1.0 + t104 * t104) * t104d;
        e11 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz) * dfz) * (1.0
            + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t105);
        e11d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + ((pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ2] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfzd)) * dfz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ3] * dfz) * dfzd)) * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) *
            0.63661977236758134308 * t105) + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ3] * dfz) * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ5] * gzd)) * 0.63661977236758134308 * t105 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t105d);
        if (MAGGI_RE(e11) > 1.0) {
          y19 = 1.0;
          y19d = 0.0;
        } else {
          y19 = e11;
          y19d = e11d;
        }
        et = y19;
        etd = y19d;
        t106 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * y43 / y40;
        t106d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * y43 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * y43d - t106 * y40d) * (1.0 / y40);
        br = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * scale + t106;
        brd = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * scale +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * scaled + t106d;
        dr = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
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
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS]) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + fz2 * ((p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t107 = 1.0 + a5 * a5;
        t107d = a5d * a5 + a5 * a5d;
        t108 = sqrt(t107);
        t108d = 1.0 / (2.0 * t108) * t107d;
        ca = 1.0 / t108;
        cad = -(ca * t108d * (1.0 / t108));
        y20 = bt * ateq;
        y20d = btd * ateq + bt * ateqd;
        t109 = atan(y20);
        t109d = 1.0 / (1.0 + y20 * y20) * y20d;
        t110 = (1.0 - et) * y20 + et * t109;
        t110d = -(etd * y20) + (1.0 - et) * y20d + (etd * t109 + et * t109d);
        t111 = atan(t110);
        t111d = 1.0 / (1.0 + t110 * t110) * t110d;
        t112 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t111;
        t112d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t111 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t111d;
        t113 = cos(t112);
        t113d = -(sin(t112) * t112d);
        z40 = dt * t113 * ca;
        z40d = (dtd * t113 + dt * t113d) * ca + dt * t113 * cad;
        x9 = br * areq;
        x9d = brd * areq + br * areqd;
        t114 = 1.0 + x9 * x9;
        t114d = x9d * x9 + x9 * x9d;
        t115 = sqrt(t114);
        t115d = 1.0 / (2.0 * t115) * t114d;
        t116 = 1.0 / t115;
        t116d = -(t116 * t115d * (1.0 / t115));
        force2 = fy + g28;
        force2d = fyd + g28d;
        t117 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * force2 / fz0_2;
        t117d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * force2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * force2d - t117 * fz0_2d) * (1.0 /
            fz0_2);
        s4 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t117 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        s4d = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t117d +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfzd)) *
            gamma + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gammad)) * r0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t117 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS]
            + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t117 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        t118 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        t118d = (one4d - t118 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]);
        way3 = tanh(t118);
        way3d = (1.0 - way3 * way3) * t118d;
        speed2 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        speed2d = (one4d - speed2 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]);
        t119 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * force2 / fz0_2;
        t119d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * force2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * force2d - t119 * fz0_2d) * (1.0 /
            fz0_2);
        t120 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
        t120d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fxd - t120 * fz0_2d) * (1.0 / fz0_2);
        force5b = fb[i][5] * side;
        force5bd = fbd[i][5] * side;
        fb[i][5] = 0.0;
        fbd[i][5] = 0.0;
        force4b = fb[i][4];
        force4bd = fbd[i][4];
        fb[i][4] = 0.0;
        fbd[i][4] = 0.0;
        force3_2b = fb[i][3] * side;
        force3_2bd = fbd[i][3] * side;
        fb[i][3] = 0.0;
        fbd[i][3] = 0.0;
        force2_2b = fb[i][2];
        force2_2bd = fbd[i][2];
        fb[i][2] = 0.0;
        fbd[i][2] = 0.0;
        force1b = fb[i][1] * side;
        force1bd = fbd[i][1] * side;
        fb[i][1] = 0.0;
        fbd[i][1] = 0.0;
        force0b = fb[i][0];
        force0bd = fbd[i][0];
        fb[i][0] = 0.0;
        fbd[i][0] = 0.0;
        z40b = -(force5b * fy);
        z40bd = -(force5bd * fy + force5b * fyd);
        fyb = -(force5b * z40);
        fybd = -(force5bd * z40 + force5b * z40d);
        z41b = force5b;
        z41bd = force5bd;
        s4b = force5b * fx;
        s4bd = force5bd * fx + force5b * fxd;
        fxb = force5b * s4;
        fxbd = force5bd * s4 + force5b * s4d;
        tb199 = force4b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        tb199d = force4bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] + force4b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        tb200 = tb199 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2 * speed2);
        tb200d = tb199d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2 * speed2) +
            tb199 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120d +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 * speed2d) +
            ((((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2 * speed2d));
        tb201 = tb200 * fz2;
        tb201d = tb200d * fz2 + tb200 * fz2d;
        way3b = -(tb201 * r0);
        way3bd = -(tb201d * r0 + tb201 * r0d);
        r0b = -(tb201 * way3);
        r0bd = -(tb201d * way3 + tb201 * way3d);
        fz2b = tb200 * (-way3 * r0);
        fz2bd = tb200d * (-way3 * r0) + tb200 * (-(way3d * r0) - way3 * r0d);
        tb202 = tb199 * (-way3 * r0 * fz2);
        tb202d = tb199d * (-way3 * r0 * fz2) + tb199 * ((-(way3d * r0) - way3 * r0d) * fz2 + -way3 *
            r0 * fz2d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] += tb202;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] += tb202d;
        t120b = tb202;
        t120bd = tb202d;
        tb203 = tb202 * speed2;
        tb203d = tb202d * speed2 + tb202 * speed2d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] += tb203 * way3;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] += tb203d * way3 + tb203 * way3d;
        way3b += tb203 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3];
        way3bd += tb203d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] + tb203 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3];
        speed2b = tb202 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3);
        speed2bd = tb202d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3) + tb202 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3d);
        tb204 = tb202 * speed2;
        tb204d = tb202d * speed2 + tb202 * speed2d;
        tb205 = tb204 * speed2;
        tb205d = tb204d * speed2 + tb204 * speed2d;
        tb206 = tb205 * speed2;
        tb206d = tb205d * speed2 + tb205 * speed2d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] += tb206 * speed2;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] += tb206d * speed2 + tb206 * speed2d;
        speed2b += tb206 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4];
        speed2bd += tb206d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] + tb206 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4];
        speed2b += tb205 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2);
        speed2bd += tb205d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2) + tb205 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2d);
        speed2b += tb204 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2);
        speed2bd += tb204d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2) +
            tb204 * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2d);
        speed2b += tb202 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 *
            speed2);
        speed2bd += tb202d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 *
            speed2) + tb202 * (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] += force4b * (-way3 * r0 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way3 * speed2 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed2 * speed2 * speed2 * speed2));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] += force4bd * (-way3 * r0 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way3 * speed2 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed2 * speed2 * speed2 * speed2)) + force4b * (((-(way3d * r0) - way3 * r0d) * fz2 +
            -way3 * r0 * fz2d) * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2 * speed2) +
            -way3 * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120d +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 * speed2d) +
            ((((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2 *
            speed2d)));
        tb198 = t120b / fz0_2;
        tb198d = (t120bd - tb198 * fz0_2d) * (1.0 / fz0_2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] += tb198 * fx;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] += tb198d * fx + tb198 * fxd;
        fxb += tb198 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2];
        fxbd += tb198d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] + tb198 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2];
        fz0_2b = -(tb198 * t120);
        fz0_2bd = -(tb198d * t120 + tb198 * t120d);
        tb195 = force3_2b * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma + t119) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]);
        tb195d = force3_2bd * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma + t119) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]) +
            force3_2b * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX1] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] +
            ((-(pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma) -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gammad + t119d) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma + t119) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]));
        r0b += tb195 * fz2;
        r0bd += tb195d * fz2 + tb195 * fz2d;
        fz2b += tb195 * r0;
        fz2bd += tb195d * r0 + tb195 * r0d;
        tb196 = force3_2b * (r0 * fz2);
        tb196d = force3_2bd * (r0 * fz2) + force3_2b * (r0d * fz2 + r0 * fz2d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] += tb196 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LVMX];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] += tb196d * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVMX] + tb196 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] += tb196 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX1];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] += tb196d * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSX1] + tb196 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1];
        tb197 = tb196 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX];
        tb197d = tb196d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] + tb196 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] -= tb197 * gamma;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] -= tb197d * gamma + tb197 * gammad;
        gammab = -(tb197 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2]);
        gammabd = -(tb197d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] + tb197 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2]);
        t119b = tb197;
        t119bd = tb197d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] += tb196 * (-p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSX2] * gamma + t119);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] += tb196d *
            (-p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma + t119) + tb196 *
            (-(pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma) -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gammad + t119d);
        tb194 = t119b / fz0_2;
        tb194d = (t119bd - tb194 * fz0_2d) * (1.0 / fz0_2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] += tb194 * force2;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] += tb194d * force2 + tb194 * force2d;
        force2b = tb194 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3];
        force2bd = tb194d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] + tb194 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3];
        fz0_2b -= tb194 * t119;
        fz0_2bd -= tb194d * t119 + tb194 * t119d;
        fz2b += force2_2b;
        fz2bd += force2_2bd;
        force2b += force1b;
        force2bd += force1bd;
        fxb += force0b;
        fxbd += force0bd;
        tb193 = speed2b / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        tb193d = (speed2bd - tb193 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]);
        one4b = tb193;
        one4bd = tb193d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL] -= tb193 * speed2;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL] -= tb193d * speed2 + tb193 * speed2d;
        t118b = way3b * (1.0 - way3 * way3);
        t118bd = way3bd * (1.0 - way3 * way3) - way3b * (way3d * way3 + way3 * way3d);
        tb192 = t118b / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        tb192d = (t118bd - tb192 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]);
        one4b += tb192;
        one4bd += tb192d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED] -= tb192 * t118;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED] -= tb192d * t118 + tb192 * t118d;
        tb189 = s4b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        tb189d = s4bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] + s4b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        tb190 = tb189 * r0;
        tb190d = tb189d * r0 + tb189 * r0d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] += tb190;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] += tb190d;
        t117b = tb190;
        t117bd = tb190d;
        tb191 = tb190 * gamma;
        tb191d = tb190d * gamma + tb190 * gammad;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] += tb191;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] += tb191d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] += tb191 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] += tb191d * dfz + tb191 * dfzd;
        dfzb = tb191 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4];
        dfzbd = tb191d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] + tb191 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4];
        gammab += tb190 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz);
        gammabd += tb190d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) + tb190 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfzd));
        r0b += tb189 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t117 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma);
        r0bd += tb189d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t117 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma) + tb189 * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ1] + t117d + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_SSZ4] * dfzd)) * gamma + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gammad));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] += s4b * ((p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ1] + t117 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] += s4bd * ((p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ1] + t117 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0) + s4b *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t117d +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfzd)) *
            gamma + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gammad)) * r0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t117 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0d);
        tb188 = t117b / fz0_2;
        tb188d = (t117bd - tb188 * fz0_2d) * (1.0 / fz0_2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] += tb188 * force2;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] += tb188d * force2 + tb188 * force2d;
        force2b += tb188 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2];
        force2bd += tb188d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] + tb188 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2];
        fz0_2b -= tb188 * t117;
        fz0_2bd -= tb188d * t117 + tb188 * t117d;
        fyb += force2b;
        fybd += force2bd;
        g28b = force2b;
        g28bd = force2bd;
        tb187 = z41b * ca;
        tb187d = z41bd * ca + z41b * cad;
        drb = tb187 * t116;
        drbd = tb187d * t116 + tb187 * t116d;
        t116b = tb187 * dr;
        t116bd = tb187d * dr + tb187 * drd;
        cab = z41b * (dr * t116);
        cabd = z41bd * (dr * t116) + z41b * (drd * t116 + dr * t116d);
        tb186 = t116b / t115;
        tb186d = (t116bd - tb186 * t115d) * (1.0 / t115);
        t115b = -(tb186 * t116);
        t115bd = -(tb186d * t116 + tb186 * t116d);
        t114b = t115b * (1.0 / (2.0 * t115));
        t114bd = t115bd * (1.0 / (2.0 * t115)) - t115b * (1.0 / (2.0 * t115) * (2.0 * t115d) / (2.0
            * t115));
        x9b = t114b * x9;
        x9bd = t114bd * x9 + t114b * x9d;
        x9b += t114b * x9;
        x9bd += t114bd * x9 + t114b * x9d;
        brb = x9b * areq;
        brbd = x9bd * areq + x9b * areqd;
        areqb = x9b * br;
        areqbd = x9bd * br + x9b * brd;
        tb185 = z40b * ca;
        tb185d = z40bd * ca + z40b * cad;
        dtb = tb185 * t113;
        dtbd = tb185d * t113 + tb185 * t113d;
        t113b = tb185 * dt;
        t113bd = tb185d * dt + tb185 * dtd;
        cab += z40b * (dt * t113);
        cabd += z40bd * (dt * t113) + z40b * (dtd * t113 + dt * t113d);
        t112b = -(t113b * sin(t112));
        t112bd = -(t113bd * sin(t112) + t113b * (cos(t112) * t112d));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += t112b * t111;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += t112bd * t111 + t112b * t111d;
        t111b = t112b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        t111bd = t112bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + t112b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        t110b = t111b * (1.0 / (1.0 + t110 * t110));
        t110bd = t111bd * (1.0 / (1.0 + t110 * t110)) - t111b * (1.0 / (1.0 + t110 * t110) * (t110d
            * t110 + t110 * t110d) / (1.0 + t110 * t110));
        etb = -(t110b * y20);
        etbd = -(t110bd * y20 + t110b * y20d);
        y20b = t110b * (1.0 - et);
        y20bd = t110bd * (1.0 - et) - t110b * etd;
        etb += t110b * t109;
        etbd += t110bd * t109 + t110b * t109d;
        t109b = t110b * et;
        t109bd = t110bd * et + t110b * etd;
        y20b += t109b * (1.0 / (1.0 + y20 * y20));
        y20bd += t109bd * (1.0 / (1.0 + y20 * y20)) - t109b * (1.0 / (1.0 + y20 * y20) * (y20d * y20
            + y20 * y20d) / (1.0 + y20 * y20));
        btb = y20b * ateq;
        btbd = y20bd * ateq + y20b * ateqd;
        ateqb = y20b * bt;
        ateqbd = y20bd * bt + y20b * btd;
        tb184 = cab / t108;
        tb184d = (cabd - tb184 * t108d) * (1.0 / t108);
        t108b = -(tb184 * ca);
        t108bd = -(tb184d * ca + tb184 * cad);
        t107b = t108b * (1.0 / (2.0 * t108));
        t107bd = t108bd * (1.0 / (2.0 * t108)) - t108b * (1.0 / (2.0 * t108) * (2.0 * t108d) / (2.0
            * t108));
        a5b = t107b * a5;
        a5bd = t107bd * a5 + t107b * a5d;
        a5b += t107b * a5;
        a5bd += t107bd * a5 + t107b * a5d;
        tb179 = drb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb179d = drbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + drb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb180 = tb179 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        tb180d = tb179d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] + tb179 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        fz2b += tb180 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz);
        fz2bd += tb180d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) + tb180 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gzd));
        tb181 = tb180 * fz2;
        tb181d = tb180d * fz2 + tb180 * fz2d;
        tb182 = tb181 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES];
        tb182d = tb181d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + tb181 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] += tb182;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] += tb182d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] += tb182 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] += tb182d * dfz + tb182 * dfzd;
        dfzb += tb182 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7];
        dfzbd += tb182d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] + tb182 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] += tb181 * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] += tb181d *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) + tb181 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ7] * dfzd));
        tb183 = tb181 * gz;
        tb183d = tb181d * gz + tb181 * gzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] += tb183;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] += tb183d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] += tb183 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] += tb183d * dfz + tb183 * dfzd;
        dfzb += tb183 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9];
        dfzbd += tb183d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] + tb183 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9];
        gzb = tb181 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz);
        gzbd = tb181d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) + tb181 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfzd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb179 * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb179d * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz)) + tb179 * (fz2d * ((p[t->tyreadr[t->wheeltyre[i]] +
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
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += drb * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_UNLOADED_RADIUS]);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += drbd * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_UNLOADED_RADIUS]) + drb * ((fz2d * ((p[t->tyreadr[t->wheeltyre[i]] +
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
            MAGGI_TYRE_QDZ9] * dfz) * gzd))) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_UNLOADED_RADIUS] + fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS]);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] += brb * scale;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] += brbd * scale + brb * scaled;
        scaleb = brb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9];
        scalebd = brbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] + brb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9];
        t106b = brb;
        t106bd = brbd;
        tb178 = t106b / y40;
        tb178d = (t106bd - tb178 * y40d) * (1.0 / y40);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] += tb178 * y43;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] += tb178d * y43 + tb178 * y43d;
        y43b = tb178 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10];
        y43bd = tb178d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] + tb178 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10];
        y40b = -(tb178 * t106);
        y40bd = -(tb178d * t106 + tb178 * t106d);
        y19b = etb;
        y19bd = etbd;
        e11b = 0.0;
        e11bd = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e11) > 1.0) {
          y19b = 0.0;
          y19bd = 0.0;
        } else {
          e11b += y19b;
          e11bd += y19bd;
          y19b = 0.0;
          y19bd = 0.0;
        }
        tb173 = e11b * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t105);
        tb173d = e11bd * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t105)
            + e11b * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ5] * gzd)) * 0.63661977236758134308 * t105 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t105d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] += tb173;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] += tb173d;
        tb174 = tb173 * dfz;
        tb174d = tb173d * dfz + tb173 * dfzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] += tb174;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] += tb174d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] += tb174 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] += tb174d * dfz + tb174 * dfzd;
        dfzb += tb174 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3];
        dfzbd += tb174d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] + tb174 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3];
        dfzb += tb173 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz);
        dfzbd += tb173d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz) + tb173 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ3] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfzd));
        tb175 = e11b * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ3] * dfz) * dfz);
        tb175d = e11bd * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ3] * dfz) * dfz) + e11b * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ1] + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ3] * dfzd)) * dfz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz) * dfzd));
        tb176 = tb175 * t105;
        tb176d = tb175d * t105 + tb175 * t105d;
        tb177 = tb176 * 0.63661977236758134308;
        tb177d = tb176d * 0.63661977236758134308;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] += tb177;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] += tb177d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] += tb177 * gz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] += tb177d * gz + tb177 * gzd;
        gzb += tb177 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5];
        gzbd += tb177d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] + tb177 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5];
        t105b = tb175 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308);
        t105bd = tb175d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308) + tb175
            * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ5] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gzd)) *
            0.63661977236758134308);
        t104b = t105b * (1.0 / (1.0 + t104 * t104));
        t104bd = t105bd * (1.0 / (1.0 + t104 * t104)) - t105b * (1.0 / (1.0 + t104 * t104) * (t104d
            * t104 + t104 * t104d) / (1.0 + t104 * t104));
        tb172 = t104b * at;
        tb172d = t104bd * at + t104b * atd;
        btb += tb172 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        btbd += tb172d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + tb172 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += tb172 * bt;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += tb172d * bt + tb172 * btd;
        atb = t104b * (bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1]);
        atbd = t104bd * (bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1]) + t104b * (btd *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + bt * pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QCZ1]);
        tb166 = dtb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        tb166d = dtbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] + dtb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        tb167 = tb166 * t103;
        tb167d = tb166d * t103 + tb166 * t103d;
        tb168 = tb167 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gz);
        tb168d = tb167d * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gz) + tb167 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gzd)) * gz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz) * gzd);
        fz2b += tb168 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz);
        fz2bd += tb168d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) + tb168 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfzd));
        tb169 = tb168 * fz2;
        tb169d = tb168d * fz2 + tb168 * fz2d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] += tb169;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] += tb169d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] += tb169 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] += tb169d * dfz + tb169 * dfzd;
        dfzb += tb169 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2];
        dfzbd += tb169d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] + tb169 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2];
        tb170 = tb167 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz));
        tb170d = tb167d * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz)) + tb167 * (fz2d *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) + fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfzd)));
        tb171 = tb170 * gz;
        tb171d = tb170d * gz + tb170 * gzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] += tb171;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] += tb171d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] += tb171 * gz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] += tb171d * gz + tb171 * gzd;
        gzb += tb171 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4];
        gzbd += tb171d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] + tb171 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4];
        gzb += tb170 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz);
        gzbd += tb170d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) + tb170 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gzd));
        t103b = tb166 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz) * gz));
        t103bd = tb166d * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz) * gz)) + tb166 * ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfzd))) *
            (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ4] * gz) * gz) + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gzd)) * gz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz) * gzd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] += dtb * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gz) * t103);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] += dtbd * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gz) * t103) + dtb * (((fz2d *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) + fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfzd))) * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gz) + fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ4] * gzd)) * gz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gzd)) * t103 + fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gz) * t103d);
        tb165 = t103b / fz0_4;
        tb165d = (t103bd - tb165 * fz0_4d) * (1.0 / fz0_4);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb165;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb165d;
        fz0_4b = -(tb165 * t103);
        fz0_4bd = -(tb165d * t103 + tb165 * t103d);
        tb161 = btb * scale;
        tb161d = btbd * scale + btb * scaled;
        tb162 = tb161 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18);
        tb162d = tb161d * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18) + tb161 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ4] * gzd + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18d));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] += tb162;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] += tb162d;
        tb163 = tb162 * dfz;
        tb163d = tb162d * dfz + tb162 * dfzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] += tb163;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] += tb163d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] += tb163 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] += tb163d * dfz + tb163 * dfzd;
        dfzb += tb163 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3];
        dfzbd += tb163d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] + tb163 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3];
        dfzb += tb162 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz);
        dfzbd += tb162d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz) + tb162 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfzd));
        tb164 = tb161 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz) * dfz);
        tb164d = tb161d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz) * dfz) + tb161 * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ1] + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ3] * dfzd)) * dfz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz) * dfzd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] += tb164 * gz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] += tb164d * gz + tb164 * gzd;
        gzb += tb164 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4];
        gzbd += tb164d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] + tb164 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] += tb164 * y18;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] += tb164d * y18 + tb164 * y18d;
        y18b = tb164 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5];
        y18bd = tb164d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] + tb164 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5];
        scaleb += btb * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz) * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4]
            * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18));
        scalebd += btbd * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz) * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4]
            * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18)) + btb *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfzd)) * dfz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz) * dfzd)) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18) +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz) * dfz) *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ4] * gzd + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18d)));
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          gzb += y18b;
          gzbd += y18bd;
          y18b = 0.0;
          y18bd = 0.0;
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          gzb -= y18b;
          gzbd -= y18bd;
          y18b = 0.0;
          y18bd = 0.0;
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p10d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t102 = p10 * p10;
          t102d = p10d * p10 + p10 * p10d;
          z7 = gz * gz / t102;
          z7d = (gzd * gz + gz * gzd - z7 * t102d) * (1.0 / t102);
          tb159 = y18b * (15.0 + z7 * (-10.0 + 3.0 * z7));
          tb159d = y18bd * (15.0 + z7 * (-10.0 + 3.0 * z7)) + y18b * (z7d * (-10.0 + 3.0 * z7) + z7
              * (3.0 * z7d));
          p10b = tb159 * z7 * 0.125;
          p10bd = (tb159d * z7 + tb159 * z7d) * 0.125;
          z7b = tb159 * (0.125 * p10);
          z7bd = tb159d * (0.125 * p10) + tb159 * (0.125 * p10d);
          tb160 = y18b * (0.125 * p10 * z7);
          tb160d = y18bd * (0.125 * p10 * z7) + y18b * (0.125 * p10d * z7 + 0.125 * p10 * z7d);
          z7b += tb160 * (-10.0 + 3.0 * z7);
          z7bd += tb160d * (-10.0 + 3.0 * z7) + tb160 * (3.0 * z7d);
          z7b += tb160 * z7 * 3.0;
          z7bd += (tb160d * z7 + tb160 * z7d) * 3.0;
          y18b = 0.0;
          y18bd = 0.0;
          tb158 = z7b / t102;
          tb158d = (z7bd - tb158 * t102d) * (1.0 / t102);
          gzb += tb158 * gz;
          gzbd += tb158d * gz + tb158 * gzd;
          gzb += tb158 * gz;
          gzbd += tb158d * gz + tb158 * gzd;
          t102b = -(tb158 * z7);
          t102bd = -(tb158d * z7 + tb158 * z7d);
          p10b += t102b * p10;
          p10bd += t102bd * p10 + t102b * p10d;
          p10b += t102b * p10;
          p10bd += t102bd * p10 + t102b * p10d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p10b;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p10bd;
        }
        tb157 = scaleb / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb157d = (scalebd - tb157 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]) * (1.0 /
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += tb157;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += tb157d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] -= tb157 * scale;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] -= tb157d * scale + tb157 * scaled;
        t101b = areqb * (1.0 / (2.0 * areq));
        t101bd = areqbd * (1.0 / (2.0 * areq)) - areqb * (1.0 / (2.0 * areq) * (2.0 * areqd) / (2.0
            * areq));
        arb = t101b * ar;
        arbd = t101bd * ar + t101b * ard;
        arb += t101b * ar;
        arbd += t101bd * ar + t101b * ard;
        ratio2b = t101b * ratio2;
        ratio2bd = t101bd * ratio2 + t101b * ratio2d;
        ratio2b += t101b * ratio2;
        ratio2bd += t101bd * ratio2 + t101b * ratio2d;
        t100b = ateqb * (1.0 / (2.0 * ateq));
        t100bd = ateqbd * (1.0 / (2.0 * ateq)) - ateqb * (1.0 / (2.0 * ateq) * (2.0 * ateqd) / (2.0
            * ateq));
        atb += t100b * at;
        atbd += t100bd * at + t100b * atd;
        atb += t100b * at;
        atbd += t100bd * at + t100b * atd;
        ratio2b += t100b * ratio2;
        ratio2bd += t100bd * ratio2 + t100b * ratio2d;
        ratio2b += t100b * ratio2;
        ratio2bd += t100bd * ratio2 + t100b * ratio2d;
        y44b = arb;
        y44bd = arbd;
        t99b = arb;
        t99bd = arbd;
        tb156 = t99b / y43;
        tb156d = (t99bd - tb156 * y43d) * (1.0 / y43);
        y45b = tb156;
        y45bd = tb156d;
        y43b -= tb156 * t99;
        y43bd -= tb156d * t99 + tb156 * t99d;
        a5b += atb;
        a5bd += atbd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] += atb;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] += atbd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] += atb * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] += atbd * dfz + atb * dfzd;
        dfzb += atb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2];
        dfzbd += atbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] + atb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2];
        tb155 = atb * gz;
        tb155d = atbd * gz + atb * gzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] += tb155;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] += tb155d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] += tb155 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] += tb155d * dfz + tb155 * dfzd;
        dfzb += tb155 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4];
        dfzbd += tb155d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] + tb155 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4];
        gzb += atb * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz);
        gzbd += atbd * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) + atb *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QHZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfzd));
        gammab += gzb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        gammabd += gzbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] + gzb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] += gzb * gamma;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] += gzbd * gamma + gzb * gammad;
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
        tb154 = ratio2b / y43;
        tb154d = (ratio2bd - tb154 * y43d) * (1.0 / y43);
        x53b = tb154 * kappa;
        x53bd = tb154d * kappa + tb154 * kappad;
        kappab = tb154 * x53;
        kappabd = tb154d * x53 + tb154 * x53d;
        y43b -= tb154 * ratio2;
        y43bd -= tb154d * ratio2 + tb154 * ratio2d;
        tb153 = fyb * t98;
        tb153d = fybd * t98 + fyb * t98d;
        y40b += tb153 * t87;
        y40bd += tb153d * t87 + tb153 * t87d;
        t87b = tb153 * y40;
        t87bd = tb153d * y40 + tb153 * y40d;
        y45b += tb153;
        y45bd += tb153d;
        t98b = fyb * (y40 * t87 + y45);
        t98bd = fybd * (y40 * t87 + y45) + fyb * (y40d * t87 + y40 * t87d + y45d);
        tb152 = t98b / t97;
        tb152d = (t98bd - tb152 * t97d) * (1.0 / t97);
        t92b = tb152;
        t92bd = tb152d;
        t97b = -(tb152 * t98);
        t97bd = -(tb152d * t98 + tb152 * t98d);
        t96b = -(t97b * sin(t96));
        t96bd = -(t97bd * sin(t96) + t97b * (cos(t96) * t96d));
        g25b = t96b * t95;
        g25bd = t96bd * t95 + t96b * t95d;
        t95b = t96b * g25;
        t95bd = t96bd * g25 + t96b * g25d;
        t94b = t95b * (1.0 / (1.0 + t94 * t94));
        t94bd = t95bd * (1.0 / (1.0 + t94 * t94)) - t95b * (1.0 / (1.0 + t94 * t94) * (t94d * t94 +
            t94 * t94d) / (1.0 + t94 * t94));
        g26b = -(t94b * y17);
        g26bd = -(t94bd * y17 + t94b * y17d);
        y17b = t94b * (1.0 - g26);
        y17bd = t94bd * (1.0 - g26) - t94b * g26d;
        g26b += t94b * t93;
        g26bd += t94bd * t93 + t94b * t93d;
        t93b = t94b * g26;
        t93bd = t94bd * g26 + t94b * g26d;
        y17b += t93b * (1.0 / (1.0 + y17 * y17));
        y17bd += t93bd * (1.0 / (1.0 + y17 * y17)) - t93b * (1.0 / (1.0 + y17 * y17) * (y17d * y17 +
            y17 * y17d) / (1.0 + y17 * y17));
        t91b = -(t92b * sin(t91));
        t91bd = -(t92bd * sin(t91) + t92b * (cos(t91) * t91d));
        g25b += t91b * t90;
        g25bd += t91bd * t90 + t91b * t90d;
        t90b = t91b * g25;
        t90bd = t91bd * g25 + t91b * g25d;
        t89b = t90b * (1.0 / (1.0 + t89 * t89));
        t89bd = t90bd * (1.0 / (1.0 + t89 * t89)) - t90b * (1.0 / (1.0 + t89 * t89) * (t89d * t89 +
            t89 * t89d) / (1.0 + t89 * t89));
        g26b -= t89b * y16;
        g26bd -= t89bd * y16 + t89b * y16d;
        y16b = t89b * (1.0 - g26);
        y16bd = t89bd * (1.0 - g26) - t89b * g26d;
        g26b += t89b * t88;
        g26bd += t89bd * t88 + t89b * t88d;
        t88b = t89b * g26;
        t88bd = t89bd * g26 + t89b * g26d;
        y16b += t88b * (1.0 / (1.0 + y16 * y16));
        y16bd += t88bd * (1.0 / (1.0 + y16 * y16)) - t88b * (1.0 / (1.0 + y16 * y16) * (y16d * y16 +
            y16 * y16d) / (1.0 + y16 * y16));
        t86b = t87b * cos(t86);
        t86bd = t87bd * cos(t86) - t87b * (sin(t86) * t86d);
        y41b = t86b * t85;
        y41bd = t86bd * t85 + t86b * t85d;
        t85b = t86b * y41;
        t85bd = t86bd * y41 + t86b * y41d;
        t84b = t85b * (1.0 / (1.0 + t84 * t84));
        t84bd = t85bd * (1.0 / (1.0 + t84 * t84)) - t85b * (1.0 / (1.0 + t84 * t84) * (t84d * t84 +
            t84 * t84d) / (1.0 + t84 * t84));
        y42b = -(t84b * y15);
        y42bd = -(t84bd * y15 + t84b * y15d);
        y15b = t84b * (1.0 - y42);
        y15bd = t84bd * (1.0 - y42) - t84b * y42d;
        y42b += t84b * t83;
        y42bd += t84bd * t83 + t84b * t83d;
        t83b = t84b * y42;
        t83bd = t84bd * y42 + t84b * y42d;
        y15b += t83b * (1.0 / (1.0 + y15 * y15));
        y15bd += t83bd * (1.0 / (1.0 + y15 * y15)) - t83b * (1.0 / (1.0 + y15 * y15) * (y15d * y15 +
            y15 * y15d) / (1.0 + y15 * y15));
        g24b = y17b * g27;
        g24bd = y17bd * g27 + y17b * g27d;
        g27b = y17b * g24;
        g27bd = y17bd * g24 + y17b * g24d;
        g24b += y16b * (kappa + g27);
        g24bd += y16bd * (kappa + g27) + y16b * (kappad + g27d);
        tb151 = y16b * g24;
        tb151d = y16bd * g24 + y16b * g24d;
        kappab += tb151;
        kappabd += tb151d;
        g27b += tb151;
        g27bd += tb151d;
        t82b = y15b * y44;
        t82bd = y15bd * y44 + y15b * y44d;
        y44b += y15b * t82;
        y44bd += y15bd * t82 + y15b * t82d;
        tb150 = t82b / t81;
        tb150d = (t82bd - tb150 * t81d) * (1.0 / t81);
        y43b += tb150;
        y43bd += tb150d;
        t81b = -(tb150 * t82);
        t81bd = -(tb150d * t82 + tb150 * t82d);
        y41b += t81b * y40;
        y41bd += t81bd * y40 + t81b * y40d;
        y40b += t81b * y41;
        y40bd += t81bd * y41 + t81b * y41d;
        tb149 = fxb * t80;
        tb149d = fxbd * t80 + fxb * t80d;
        x50b = tb149 * t69;
        x50bd = tb149d * t69 + tb149 * t69d;
        t69b = tb149 * x50;
        t69bd = tb149d * x50 + tb149 * x50d;
        x55b = tb149;
        x55bd = tb149d;
        t80b = fxb * (x50 * t69 + x55);
        t80bd = fxbd * (x50 * t69 + x55) + fxb * (x50d * t69 + x50 * t69d + x55d);
        tb148 = t80b / t79;
        tb148d = (t80bd - tb148 * t79d) * (1.0 / t79);
        t74b = tb148;
        t74bd = tb148d;
        t79b = -(tb148 * t80);
        t79bd = -(tb148d * t80 + tb148 * t80d);
        t78b = -(t79b * sin(t78));
        t78bd = -(t79bd * sin(t78) + t79b * (cos(t78) * t78d));
        g21b = t78b * t77;
        g21bd = t78bd * t77 + t78b * t77d;
        t77b = t78b * g21;
        t77bd = t78bd * g21 + t78b * g21d;
        t76b = t77b * (1.0 / (1.0 + t76 * t76));
        t76bd = t77bd * (1.0 / (1.0 + t76 * t76)) - t77b * (1.0 / (1.0 + t76 * t76) * (t76d * t76 +
            t76 * t76d) / (1.0 + t76 * t76));
        g22b = -(t76b * y14);
        g22bd = -(t76bd * y14 + t76b * y14d);
        y14b = t76b * (1.0 - g22);
        y14bd = t76bd * (1.0 - g22) - t76b * g22d;
        g22b += t76b * t75;
        g22bd += t76bd * t75 + t76b * t75d;
        t75b = t76b * g22;
        t75bd = t76bd * g22 + t76b * g22d;
        y14b += t75b * (1.0 / (1.0 + y14 * y14));
        y14bd += t75bd * (1.0 / (1.0 + y14 * y14)) - t75b * (1.0 / (1.0 + y14 * y14) * (y14d * y14 +
            y14 * y14d) / (1.0 + y14 * y14));
        t73b = -(t74b * sin(t73));
        t73bd = -(t74bd * sin(t73) + t74b * (cos(t73) * t73d));
        g21b += t73b * t72;
        g21bd += t73bd * t72 + t73b * t72d;
        t72b = t73b * g21;
        t72bd = t73bd * g21 + t73b * g21d;
        t71b = t72b * (1.0 / (1.0 + t71 * t71));
        t71bd = t72bd * (1.0 / (1.0 + t71 * t71)) - t72b * (1.0 / (1.0 + t71 * t71) * (t71d * t71 +
            t71 * t71d) / (1.0 + t71 * t71));
        g22b -= t71b * y13;
        g22bd -= t71bd * y13 + t71b * y13d;
        y13b = t71b * (1.0 - g22);
        y13bd = t71bd * (1.0 - g22) - t71b * g22d;
        g22b += t71b * t70;
        g22bd += t71bd * t70 + t71b * t70d;
        t70b = t71b * g22;
        t70bd = t71bd * g22 + t71b * g22d;
        y13b += t70b * (1.0 / (1.0 + y13 * y13));
        y13bd += t70bd * (1.0 / (1.0 + y13 * y13)) - t70b * (1.0 / (1.0 + y13 * y13) * (y13d * y13 +
            y13 * y13d) / (1.0 + y13 * y13));
        t68b = t69b * cos(t68);
        t68bd = t69bd * cos(t68) - t69b * (sin(t68) * t68d);
        x51b = t68b * t67;
        x51bd = t68bd * t67 + t68b * t67d;
        t67b = t68b * x51;
        t67bd = t68bd * x51 + t68b * x51d;
        t66b = t67b * (1.0 / (1.0 + t66 * t66));
        t66bd = t67bd * (1.0 / (1.0 + t66 * t66)) - t67b * (1.0 / (1.0 + t66 * t66) * (t66d * t66 +
            t66 * t66d) / (1.0 + t66 * t66));
        x52b = -(t66b * y12);
        x52bd = -(t66bd * y12 + t66b * y12d);
        y12b = t66b * (1.0 - x52);
        y12bd = t66bd * (1.0 - x52) - t66b * x52d;
        x52b += t66b * t65;
        x52bd += t66bd * t65 + t66b * t65d;
        t65b = t66b * x52;
        t65bd = t66bd * x52 + t66b * x52d;
        y12b += t65b * (1.0 / (1.0 + y12 * y12));
        y12bd += t65bd * (1.0 / (1.0 + y12 * y12)) - t65b * (1.0 / (1.0 + y12 * y12) * (y12d * y12 +
            y12 * y12d) / (1.0 + y12 * y12));
        g20b = y14b * g23;
        g20bd = y14bd * g23 + y14b * g23d;
        g23b = y14b * g20;
        g23bd = y14bd * g20 + y14b * g20d;
        g20b += y13b * (a5 + g23);
        g20bd += y13bd * (a5 + g23) + y13b * (a5d + g23d);
        tb147 = y13b * g20;
        tb147d = y13bd * g20 + y13b * g20d;
        a5b += tb147;
        a5bd += tb147d;
        g23b += tb147;
        g23bd += tb147d;
        t64b = y12b * x54;
        t64bd = y12bd * x54 + y12b * x54d;
        x54b = y12b * t64;
        x54bd = y12bd * t64 + y12b * t64d;
        tb146 = t64b / t63;
        tb146d = (t64bd - tb146 * t63d) * (1.0 / t63);
        x53b += tb146;
        x53bd += tb146d;
        t63b = -(tb146 * t64);
        t63bd = -(tb146d * t64 + tb146 * t64d);
        x51b += t63b * x50;
        x51bd += t63bd * x50 + t63b * x50d;
        x50b += t63b * x51;
        x50bd += t63bd * x51 + t63b * x51d;
        tb145 = g28b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        tb145d = g28bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] + g28b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        dvb = tb145 * t62;
        dvbd = tb145d * t62 + tb145 * t62d;
        t62b = tb145 * dv;
        t62bd = tb145d * dv + tb145 * dvd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] += g28b * (dv * t62);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] += g28bd * (dv * t62) + g28b * (dvd *
            t62 + dv * t62d);
        t61b = t62b * cos(t61);
        t61bd = t62bd * cos(t61) - t62b * (sin(t61) * t61d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] += t61b * t60;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] += t61bd * t60 + t61b * t60d;
        t60b = t61b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5];
        t60bd = t61bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] + t61b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5];
        t59b = t60b * (1.0 / (1.0 + t59 * t59));
        t59bd = t60bd * (1.0 / (1.0 + t59 * t59)) - t60b * (1.0 / (1.0 + t59 * t59) * (t59d * t59 +
            t59 * t59d) / (1.0 + t59 * t59));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] += t59b * kappa;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] += t59bd * kappa + t59b * kappad;
        kappab += t59b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6];
        kappabd += t59bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] + t59b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6];
        tb143 = dvb * t58;
        tb143d = dvbd * t58 + dvb * t58d;
        peakb = tb143 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma);
        peakbd = tb143d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma) + tb143 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RVY2] * dfzd) + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gammad));
        tb144 = tb143 * peak;
        tb144d = tb143d * peak + tb143 * peakd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] += tb144;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] += tb144d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] += tb144 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] += tb144d * dfz + tb144 * dfzd;
        dfzb += tb144 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2];
        dfzbd += tb144d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] + tb144 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] += tb144 * gamma;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] += tb144d * gamma + tb144 * gammad;
        gammab += tb144 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3];
        gammabd += tb144d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] + tb144 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3];
        t58b = dvb * (peak * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma));
        t58bd = dvbd * (peak * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma)) + dvb * (peakd * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma) + peak *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gammad)));
        tb142 = t58b / t57;
        tb142d = (t58bd - tb142 * t57d) * (1.0 / t57);
        t57b = -(tb142 * t58);
        t57bd = -(tb142d * t58 + tb142 * t58d);
        t56b = t57b * (1.0 / (2.0 * t57));
        t56bd = t57bd * (1.0 / (2.0 * t57)) - t57b * (1.0 / (2.0 * t57) * (2.0 * t57d) / (2.0 *
            t57));
        x8b = t56b * x8;
        x8bd = t56bd * x8 + t56b * x8d;
        x8b += t56b * x8;
        x8bd += t56bd * x8 + t56b * x8d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] += x8b * a5;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] += x8bd * a5 + x8b * a5d;
        a5b += x8b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4];
        a5bd += x8bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] + x8b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] += g27b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] += g27bd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] += g27b * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] += g27bd * dfz + g27b * dfzd;
        dfzb += g27b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2];
        dfzbd += g27bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] + g27b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2];
        y11b = g26b;
        y11bd = g26bd;
        e10b = 0.0;
        e10bd = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e10) > 1.0) {
          y11b = 0.0;
          y11bd = 0.0;
        } else {
          e10b += y11b;
          e10bd += y11bd;
          y11b = 0.0;
          y11bd = 0.0;
        }
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] += e10b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] += e10bd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] += e10b * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] += e10bd * dfz + e10b * dfzd;
        dfzb += e10b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2];
        dfzbd += e10bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] + e10b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1] += g25b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1] += g25bd;
        tb141 = g24b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        tb141d = g24bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA] + g24b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] += tb141 * t55;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] += tb141d * t55 + tb141 * t55d;
        t55b = tb141 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1];
        t55bd = tb141d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] + tb141 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA] += g24b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RBY1] * t55);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA] += g24bd * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBY1] * t55) + g24b * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] *
            t55 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t55d);
        tb140 = t55b / t54;
        tb140d = (t55bd - tb140 * t54d) * (1.0 / t54);
        t54b = -(tb140 * t55);
        t54bd = -(tb140d * t55 + tb140 * t55d);
        t53b = t54b * (1.0 / (2.0 * t54));
        t53bd = t54bd * (1.0 / (2.0 * t54)) - t54b * (1.0 / (2.0 * t54) * (2.0 * t54d) / (2.0 *
            t54));
        x7b = t53b * x7;
        x7bd = t53bd * x7 + t53b * x7d;
        x7b += t53b * x7;
        x7bd += t53bd * x7 + t53b * x7d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] += x7b * (a5 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] += x7bd * (a5 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]) + x7b * (a5d -
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]);
        tb139 = x7b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2];
        tb139d = x7bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] + x7b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2];
        a5b += tb139;
        a5bd += tb139d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3] -= tb139;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3] -= tb139d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1] += g23b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1] += g23bd;
        y10b = g22b;
        y10bd = g22bd;
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
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] += e9b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] += e9bd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] += e9b * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] += e9bd * dfz + e9b * dfzd;
        dfzb += e9b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2];
        dfzbd += e9bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] + e9b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1] += g21b;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1] += g21bd;
        tb138 = g20b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        tb138d = g20bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL] + g20b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] += tb138 * t52;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] += tb138d * t52 + tb138 * t52d;
        t52b = tb138 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1];
        t52bd = tb138d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] + tb138 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL] += g20b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RBX1] * t52);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL] += g20bd * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBX1] * t52) + g20b * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] *
            t52 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t52d);
        tb137 = t52b / t51;
        tb137d = (t52bd - tb137 * t51d) * (1.0 / t51);
        t51b = -(tb137 * t52);
        t51bd = -(tb137d * t52 + tb137 * t52d);
        t50b = t51b * (1.0 / (2.0 * t51));
        t50bd = t51bd * (1.0 / (2.0 * t51)) - t51b * (1.0 / (2.0 * t51) * (2.0 * t51d) / (2.0 *
            t51));
        x6b = t50b * x6;
        x6bd = t50bd * x6 + t50b * x6d;
        x6b += t50b * x6;
        x6bd += t50bd * x6 + t50b * x6d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] += x6b * kappa;
        /* what combined slip makes of the forces:  Fx = Gxa Fx0, Fy = Gyk Fy0 + SVyk.  g: b, c, e, shift of Gxa,
         * then of Gyk, SVyk */
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] += x6bd * kappa + x6b * kappad;
        kappab += x6b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2];
        kappabd += x6bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] + x6b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2];
        y40b += peakb;
        y40bd += peakbd;
        tb133 = y45b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb133d = y45bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + y45b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        fz2b += tb133 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy);
        fz2bd += tb133d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) + tb133 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfzd)) * gy +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gyd));
        tb134 = tb133 * fz2;
        tb134d = tb133d * fz2 + tb133 * fz2d;
        tb135 = tb134 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY];
        tb135d = tb134d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + tb134 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] += tb135;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] += tb135d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] += tb135 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] += tb135d * dfz + tb135 * dfzd;
        dfzb += tb135 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2];
        dfzbd += tb135d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] + tb135 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] += tb134 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] += tb134d * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) + tb134 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfzd));
        tb136 = tb134 * gy;
        tb136d = tb134d * gy + tb134 * gyd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] += tb136;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] += tb136d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] += tb136 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] += tb136d * dfz + tb136 * dfzd;
        dfzb += tb136 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4];
        dfzbd += tb136d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] + tb136 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4];
        gyb = tb134 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz);
        gybd = tb134d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) + tb134 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfzd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += y45b * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gy));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += y45bd * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gy)) + y45b * (fz2d * ((p[t->tyreadr[t->wheeltyre[i]] +
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
        ayb = y44b;
        aybd = y44bd;
        tb129 = y43b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        tb129d = y43bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] + y43b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        tb130 = tb129 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9);
        tb130d = tb129d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9) - tb129 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PKY3] * y9d);
        tb131 = tb130 * t49;
        tb131d = tb130d * t49 + tb130 * t49d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] += tb131 * fz0_3;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] += tb131d * fz0_3 + tb131 * fz0_3d;
        fz0_3b = tb131 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1];
        fz0_3bd = tb131d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] + tb131 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1];
        t49b = tb130 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3);
        t49bd = tb130d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3) + tb130 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d);
        tb132 = tb129 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t49);
        tb132d = tb129d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t49) + tb129 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d) * t49 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t49d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] -= tb132 * y9;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] -= tb132d * y9 + tb132 * y9d;
        y9b = -(tb132 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]);
        y9bd = -(tb132d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] + tb132 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += y43b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t49 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]
            * y9));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += y43bd * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PKY1] * fz0_3 * t49 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY3] * y9)) + y43b * (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] *
            fz0_3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d) * t49 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t49d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9) - p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t49 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9d));
        tb128 = t49b / t48;
        tb128d = (t49bd - tb128 * t48d) * (1.0 / t48);
        z5b = tb128 * 2.0;
        z5bd = tb128d * 2.0;
        t48b = -(tb128 * t49);
        t48bd = -(tb128d * t49 + tb128 * t49d);
        z5b += t48b * z5;
        z5bd += t48bd * z5 + t48b * z5d;
        z5b += t48b * z5;
        z5bd += t48bd * z5 + t48b * z5d;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          gyb += y9b;
          gybd += y9bd;
          y9b = 0.0;
          y9bd = 0.0;
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          gyb -= y9b;
          gybd -= y9bd;
          y9b = 0.0;
          y9bd = 0.0;
        } else {
          p9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p9d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t47 = p9 * p9;
          t47d = p9d * p9 + p9 * p9d;
          z6 = gy * gy / t47;
          z6d = (gyd * gy + gy * gyd - z6 * t47d) * (1.0 / t47);
          tb126 = y9b * (15.0 + z6 * (-10.0 + 3.0 * z6));
          tb126d = y9bd * (15.0 + z6 * (-10.0 + 3.0 * z6)) + y9b * (z6d * (-10.0 + 3.0 * z6) + z6 *
              (3.0 * z6d));
          p9b = tb126 * z6 * 0.125;
          p9bd = (tb126d * z6 + tb126 * z6d) * 0.125;
          z6b = tb126 * (0.125 * p9);
          z6bd = tb126d * (0.125 * p9) + tb126 * (0.125 * p9d);
          tb127 = y9b * (0.125 * p9 * z6);
          tb127d = y9bd * (0.125 * p9 * z6) + y9b * (0.125 * p9d * z6 + 0.125 * p9 * z6d);
          z6b += tb127 * (-10.0 + 3.0 * z6);
          z6bd += tb127d * (-10.0 + 3.0 * z6) + tb127 * (3.0 * z6d);
          z6b += tb127 * z6 * 3.0;
          z6bd += (tb127d * z6 + tb127 * z6d) * 3.0;
          y9b = 0.0;
          y9bd = 0.0;
          tb125 = z6b / t47;
          tb125d = (z6bd - tb125 * t47d) * (1.0 / t47);
          gyb += tb125 * gy;
          gybd += tb125d * gy + tb125 * gyd;
          gyb += tb125 * gy;
          gybd += tb125d * gy + tb125 * gyd;
          t47b = -(tb125 * z6);
          t47bd = -(tb125d * z6 + tb125 * z6d);
          p9b += t47b * p9;
          p9bd += t47bd * p9 + t47b * p9d;
          p9b += t47b * p9;
          p9bd += t47bd * p9 + t47b * p9d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p9b;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p9bd;
        }
        eyb = y42b;
        eybd = y42bd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] += y41b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] += y41bd * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LCY] + y41b * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY] += y41b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCY1];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY] += y41bd * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCY1] + y41b * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1];
        muyb = y40b * fz2;
        muybd = y40bd * fz2 + y40b * fz2d;
        fz2b += y40b * muy;
        fz2bd += y40bd * muy + y40b * muyd;
        tb124 = z5b / t46;
        tb124d = (z5bd - tb124 * t46d) * (1.0 / t46);
        fz2b += tb124;
        fz2bd += tb124d;
        t46b = -(tb124 * z5);
        t46bd = -(tb124d * z5 + tb124 * z5d);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] += t46b * fz0_3;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] += t46bd * fz0_3 + t46b * fz0_3d;
        fz0_3b += t46b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2];
        fz0_3bd += t46bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] + t46b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2];
        e6b = 0.0;
        e6bd = 0.0;
        if (MAGGI_RE(ay) > 0.0) {
          e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e7d = e6d * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) - e6 *
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
          e6b += e7b * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e6bd += e7bd * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) - e7b *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          tb122 = e7b * e6;
          tb122d = e7bd * e6 + e7b * e6d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] -= tb122;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] -= tb122d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] -= tb122 * gy;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] -= tb122d * gy + tb122 * gyd;
          gyb -= tb122 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
          gybd -= tb122d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] + tb122 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
        } else {
          e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e8d = e6d * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) + e6 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          y8b = eyb;
          y8bd = eybd;
          eyb = 0.0;
          eybd = 0.0;
          e8b = 0.0;
          e8bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e8) > 1.0) {
            y8b = 0.0;
            y8bd = 0.0;
          } else {
            e8b += y8b;
            e8bd += y8bd;
            y8b = 0.0;
            y8bd = 0.0;
          }
          e6b += e8b * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e6bd += e8bd * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) + e8b *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          tb123 = e8b * e6;
          tb123d = e8bd * e6 + e8b * e6d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] += tb123;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] += tb123d;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] += tb123 * gy;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] += tb123d * gy + tb123 * gyd;
          gyb += tb123 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
          gybd += tb123d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] + tb123 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
        }
        tb121 = e6b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        tb121d = e6bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] + e6b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] += tb121;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] += tb121d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] += tb121 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] += tb121d * dfz + tb121 * dfzd;
        dfzb += tb121 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2];
        dfzbd += tb121d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] + tb121 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] += e6b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] += e6bd * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz) + e6b *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfzd));
        tb117 = muyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb117d = muybd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + muyb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb118 = tb117 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy);
        tb118d = tb117d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) - tb117
            * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gyd) * gy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gyd);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] += tb118;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] += tb118d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] += tb118 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] += tb118d * dfz + tb118 * dfzd;
        dfzb += tb118 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2];
        dfzbd += tb118d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] + tb118 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2];
        tb119 = tb117 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz);
        tb119d = tb117d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz) + tb117 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfzd));
        tb120 = tb119 * gy;
        tb120d = tb119d * gy + tb119 * gyd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] -= tb120 * gy;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] -= tb120d * gy + tb120 * gyd;
        gyb -= tb120 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3];
        gybd -= tb120d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] + tb120 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3];
        gyb -= tb119 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy);
        gybd -= tb119d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy) + tb119 *
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
        a5b += ayb;
        a5bd += aybd;
        tb116 = ayb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY];
        tb116d = aybd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] + ayb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] += tb116;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] += tb116d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] += tb116 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] += tb116d * dfz + tb116 * dfzd;
        dfzb += tb116 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2];
        dfzbd += tb116d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] + tb116 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] += ayb * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] += aybd * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz) + ayb *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfzd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] += ayb * gy;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] += aybd * gy + ayb * gyd;
        gyb += ayb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3];
        gybd += aybd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] + ayb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3];
        gammab += gyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        gammabd += gybd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] + gyb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] += gyb * gamma;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] += gybd * gamma + gyb * gammad;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_3b *
            p[t->tyreadr[t->wheeltyre[i]]];
        /* sin(2 atan(z)) = 2 z / (1 + z^2) */
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_3bd *
            p[t->tyreadr[t->wheeltyre[i]]] + fz0_3b * pd[t->tyreadr[t->wheeltyre[i]]];
        pb[t->tyreadr[t->wheeltyre[i]]] += fz0_3b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO];
        pbd[t->tyreadr[t->wheeltyre[i]]] += fz0_3bd * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO] + fz0_3b * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO];
        tb113 = x55b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb113d = x55bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] + x55b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb114 = tb113 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX];
        tb114d = tb113d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] + tb113 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX];
        fz2b += tb114 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz);
        fz2bd += tb114d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + tb114 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd));
        tb115 = tb114 * fz2;
        tb115d = tb114d * fz2 + tb114 * fz2d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] += tb115;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] += tb115d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] += tb115 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] += tb115d * dfz + tb115 * dfzd;
        dfzb += tb115 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2];
        dfzbd += tb115d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] + tb115 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] += tb113 * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz));
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] += tb113d * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz)) + tb113 * (fz2d * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd)));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] += x55b * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] += x55bd * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]) + x55b *
            ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd))) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]);
        kxb = x54b;
        kxbd = x54bd;
        tb110 = x53b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        tb110d = x53bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] + x53b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        tb111 = tb110 * t45;
        tb111d = tb110d * t45 + tb110 * t45d;
        fz2b += tb111 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz);
        fz2bd += tb111d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) + tb111 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfzd));
        tb112 = tb111 * fz2;
        tb112d = tb111d * fz2 + tb111 * fz2d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] += tb112;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] += tb112d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] += tb112 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] += tb112d * dfz + tb112 * dfzd;
        dfzb += tb112 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2];
        dfzbd += tb112d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] + tb112 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2];
        t45b = tb110 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz));
        t45bd = tb110d * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz)) + tb110 * (fz2d *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz) + fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PKX2] * dfzd)));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] += x53b * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz) * t45);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] += x53bd * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz) * t45) + x53b * ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t45 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t45d);
        t44b = t45b * t45;
        t44bd = t45bd * t45 + t45b * t45d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] += t44b * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] += t44bd * dfz + t44b * dfzd;
        dfzb += t44b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3];
        dfzbd += t44bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] + t44b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3];
        exb = x52b;
        exbd = x52bd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] += x51b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] += x51bd * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LCX] + x51b * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX] += x51b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCX1];
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX] += x51bd * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCX1] + x51b * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1];
        muxb = x50b * fz2;
        muxbd = x50bd * fz2 + x50b * fz2d;
        fz2b += x50b * mux;
        fz2bd += x50bd * mux + x50b * muxd;
        e3b = 0.0;
        e3bd = 0.0;
        if (MAGGI_RE(kx) > 0.0) {
          e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e4d = e3d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) - e3 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          y5b = exb;
          y5bd = exbd;
          exb = 0.0;
          exbd = 0.0;
          e4b = 0.0;
          e4bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e4) > 1.0) {
            y5b = 0.0;
            y5bd = 0.0;
          } else {
            e4b += y5b;
            e4bd += y5bd;
            y5b = 0.0;
            y5bd = 0.0;
          }
          e3b += e4b * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e3bd += e4bd * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) - e4b *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] -= e4b * e3;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] -= e4bd * e3 + e4b * e3d;
        } else {
          e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e5d = e3d * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) + e3 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          y6b = exb;
          y6bd = exbd;
          exb = 0.0;
          exbd = 0.0;
          e5b = 0.0;
          e5bd = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e5) > 1.0) {
            y6b = 0.0;
            y6bd = 0.0;
          } else {
            e5b += y6b;
            e5bd += y6bd;
            y6b = 0.0;
            y6bd = 0.0;
          }
          e3b += e5b * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e3bd += e5bd * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) + e5b *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] += e5b * e3;
          pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] += e5bd * e3 + e5b * e3d;
        }
        tb108 = e3b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        tb108d = e3bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] + e3b *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] += tb108;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] += tb108d;
        tb109 = tb108 * dfz;
        tb109d = tb108d * dfz + tb108 * dfzd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] += tb109;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] += tb109d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] += tb109 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] += tb109d * dfz + tb109 * dfzd;
        dfzb += tb109 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3];
        dfzbd += tb109d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] + tb109 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3];
        dfzb += tb108 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz);
        dfzbd += tb108d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz) + tb108 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX3] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfzd));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] += e3b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz) * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] += e3bd * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz) * dfz) + e3b *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfzd)) * dfz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX3] * dfz) * dfzd));
        tb104 = muxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb104d = muxbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] + muxb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb105 = tb104 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx);
        tb105d = tb104d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) - tb104
            * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gxd) * gx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gxd);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] += tb105;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] += tb105d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] += tb105 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] += tb105d * dfz + tb105 * dfzd;
        dfzb += tb105 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2];
        dfzbd += tb105d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] + tb105 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2];
        tb106 = tb104 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz);
        tb106d = tb104d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz) + tb104 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfzd));
        tb107 = tb106 * gx;
        tb107d = tb106d * gx + tb106 * gxd;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] -= tb107 * gx;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] -= tb107d * gx + tb107 * gxd;
        gxb = -(tb107 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3]);
        gxbd = -(tb107d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] + tb107 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3]);
        gxb -= tb106 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx);
        gxbd -= tb106d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx) + tb106 *
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
        gammab += gxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        gammabd += gxbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] + gxb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] += gxb * gamma;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] += gxbd * gamma + gxb * gammad;
        kappab += kxb;
        kappabd += kxbd;
        tb103 = kxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX];
        tb103d = kxbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] + kxb *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] += tb103;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] += tb103d;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] += tb103 * dfz;
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] += tb103d * dfz + tb103 * dfzd;
        dfzb += tb103 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2];
        dfzbd += tb103d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] + tb103 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz);
        pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] += kxbd * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) + kxb *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfzd));
        tb102 = dfzb / fz0_2;
        tb102d = (dfzbd - tb102 * fz0_2d) * (1.0 / fz0_2);
        fz2b += tb102;
        fz2bd += tb102d;
        fz0_2b -= tb102;
        fz0_2bd -= tb102d;
        fz0_2b -= tb102 * dfz;
        fz0_2bd -= tb102d * dfz + tb102 * dfzd;
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
        one3b = fz2b;
        one3bd = fz2bd;
        one2b = gammab;
        one2bd = gammabd;
        one1b = a5b;
        one1bd = a5bd;
        one0b = kappab;
        one0bd = kappabd;
        slipb[i][MAGGI_SLIP_VX] += one4b;
        slipbd[i][MAGGI_SLIP_VX] += one4bd;
        slipb[i][MAGGI_SLIP_FZ] += one3b;
        slipbd[i][MAGGI_SLIP_FZ] += one3bd;
        slipb[i][MAGGI_SLIP_GAMMA] += one2b * side;
        slipbd[i][MAGGI_SLIP_GAMMA] += one2bd * side;
        slipb[i][MAGGI_SLIP_TAN_ALPHA] += one1b * side;
        slipbd[i][MAGGI_SLIP_TAN_ALPHA] += one1bd * side;
        slipb[i][MAGGI_SLIP_KAPPA] += one0b;
        /* the formula on either side; f: Fx Fy Fz, Mx My Mz */
        slipbd[i][MAGGI_SLIP_KAPPA] += one0bd;
      } else {
        for (k9 = 5; k9 >= 0; --k9) {
          t121b = fb[i][k9];
          t121bd = fbd[i][k9];
          fb[i][k9] = 0.0;
          fbd[i][k9] = 0.0;
          if (k9 == 2) {
            fzb += t121b;
            fzbd += t121bd;
            t121b = 0.0;
            t121bd = 0.0;
          } else {
            t121b = 0.0;
            t121bd = 0.0;
          }
        }
      }
    } else {
      for (k9_2 = 5; k9_2 >= 0; --k9_2) {
        fb[i][k9_2] = 0.0;
        fbd[i][k9_2] = 0.0;
      }
    }
    reb = slipb[i][MAGGI_SLIP_ROLLING];
    rebd = slipbd[i][MAGGI_SLIP_ROLLING];
    slipb[i][MAGGI_SLIP_ROLLING] = 0.0;
    slipbd[i][MAGGI_SLIP_ROLLING] = 0.0;
    z0b = slipb[i][MAGGI_SLIP_RADIUS];
    z0bd = slipbd[i][MAGGI_SLIP_RADIUS];
    slipb[i][MAGGI_SLIP_RADIUS] = 0.0;
    slipbd[i][MAGGI_SLIP_RADIUS] = 0.0;
    vxb = slipb[i][MAGGI_SLIP_VX];
    vxbd = slipbd[i][MAGGI_SLIP_VX];
    slipb[i][MAGGI_SLIP_VX] = 0.0;
    slipbd[i][MAGGI_SLIP_VX] = 0.0;
    fzb += slipb[i][MAGGI_SLIP_FZ];
    fzbd += slipbd[i][MAGGI_SLIP_FZ];
    slipb[i][MAGGI_SLIP_FZ] = 0.0;
    slipbd[i][MAGGI_SLIP_FZ] = 0.0;
    tb101 = slipb[i][MAGGI_SLIP_GAMMA];
    tb101d = slipbd[i][MAGGI_SLIP_GAMMA];
    slipb[i][MAGGI_SLIP_GAMMA] = 0.0;
    slipbd[i][MAGGI_SLIP_GAMMA] = 0.0;
    z1b = tb101 * (z2_2 / (z2_2 * z2_2 + z1 * z1));
    z1bd = tb101d * (z2_2 / (z2_2 * z2_2 + z1 * z1)) + tb101 * ((z2_2d - z2_2 / (z2_2 * z2_2 + z1 *
        z1) * (z2_2d * z2_2 + z2_2 * z2_2d + (z1d * z1 + z1 * z1d))) / (z2_2 * z2_2 + z1 * z1));
    z2_2b = -(tb101 * (z1 / (z2_2 * z2_2 + z1 * z1)));
    z2_2bd = -(tb101d * (z1 / (z2_2 * z2_2 + z1 * z1)) + tb101 * ((z1d - z1 / (z2_2 * z2_2 + z1 *
        z1) * (z2_2d * z2_2 + z2_2 * z2_2d + (z1d * z1 + z1 * z1d))) / (z2_2 * z2_2 + z1 * z1)));
    tb99 = slipb[i][MAGGI_SLIP_TAN_ALPHA];
    tb99d = slipbd[i][MAGGI_SLIP_TAN_ALPHA];
    slipb[i][MAGGI_SLIP_TAN_ALPHA] = 0.0;
    slipbd[i][MAGGI_SLIP_TAN_ALPHA] = 0.0;
    tb100 = tb99 / speed;
    tb100d = (tb99d - tb100 * speedd) * (1.0 / speed);
    v0b = tb100 * L0;
    v0bd = tb100d * L0 + tb100 * L0d;
    L0b += tb100 * v0;
    L0bd += tb100d * v0 + tb100 * v0d;
    v1b = tb100 * L1;
    v1bd = tb100d * L1 + tb100 * L1d;
    L1b += tb100 * v1;
    L1bd += tb100d * v1 + tb100 * v1d;
    v2b = tb100 * L2;
    v2bd = tb100d * L2 + tb100 * L2d;
    L2b += tb100 * v2;
    L2bd += tb100d * v2 + tb100 * v2d;
    speedb = -(tb100 * slip[i][MAGGI_SLIP_TAN_ALPHA]);
    speedbd = -(tb100d * slip[i][MAGGI_SLIP_TAN_ALPHA] + tb100 * slipd[i][MAGGI_SLIP_TAN_ALPHA]);
    tb97 = slipb[i][MAGGI_SLIP_KAPPA];
    tb97d = slipbd[i][MAGGI_SLIP_KAPPA];
    slipb[i][MAGGI_SLIP_KAPPA] = 0.0;
    slipbd[i][MAGGI_SLIP_KAPPA] = 0.0;
    tb98 = tb97 / speed;
    tb98d = (tb97d - tb98 * speedd) * (1.0 / speed);
    omegab = tb98 * re;
    omegabd = tb98d * re + tb98 * red;
    reb += tb98 * omega;
    rebd += tb98d * omega + tb98 * omegad;
    vxb -= tb98;
    vxbd -= tb98d;
    speedb -= tb98 * slip[i][MAGGI_SLIP_KAPPA];
    speedbd -= tb98d * slip[i][MAGGI_SLIP_KAPPA] + tb98 * slipd[i][MAGGI_SLIP_KAPPA];
    y3b = speedb;
    y3bd = speedbd;
    /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
    if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      vxb += y3b;
      vxbd += y3bd;
      y3b = 0.0;
      y3bd = 0.0;
    } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      vxb -= y3b;
      vxbd -= y3bd;
      y3b = 0.0;
      y3bd = 0.0;
    } else {
      p8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      p8d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      t43 = vx * vx / p8;
      t43d = (vxd * vx + vx * vxd - t43 * p8d) * (1.0 / p8);
      tb96 = y3b * 0.5;
      tb96d = y3bd * 0.5;
      p8b = tb96;
      p8bd = tb96d;
      t43b = tb96;
      t43bd = tb96d;
      y3b = 0.0;
      y3bd = 0.0;
      tb95 = t43b / p8;
      tb95d = (t43bd - tb95 * p8d) * (1.0 / p8);
      vxb += tb95 * vx;
      vxbd += tb95d * vx + tb95 * vxd;
      vxb += tb95 * vx;
      vxbd += tb95d * vx + tb95 * vxd;
      p8b -= tb95 * t43;
      p8bd -= tb95d * t43 + tb95 * t43d;
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW] += p8b;
      pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW] += p8bd;
    }
    re2b = reb;
    re2bd = rebd;
    fz0b = 0.0;
    fz0bd = 0.0;
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      ratiod = (fzd - ratio * fz0d) * (1.0 / fz0);
      t40 = fz0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t40d = (fz0d - t40 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS]) * (1.0 /
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS]);
      t41 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio;
      t41d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratiod;
      t42 = atan(t41);
      t42d = 1.0 / (1.0 + t41 * t41) * t41d;
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += re2b;
      pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += re2bd;
      t40b = -(re2b * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t42 +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio));
      t40bd = -(re2bd * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t42 +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio) + re2b *
          (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t42 + p[t->tyreadr[t->wheeltyre[i]]
          + MAGGI_TYRE_DREFF] * t42d + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratiod)));
      tb94 = re2b * t40;
      tb94d = re2bd * t40 + re2b * t40d;
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] -= tb94 * t42;
      pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] -= tb94d * t42 + tb94 * t42d;
      t42b = -(tb94 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF]);
      t42bd = -(tb94d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] + tb94 *
          pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF]);
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] -= tb94 * ratio;
      pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] -= tb94d * ratio + tb94 * ratiod;
      ratiob = -(tb94 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF]);
      ratiobd = -(tb94d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] + tb94 *
          pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF]);
      re2b = 0.0;
      re2bd = 0.0;
      t41b = t42b * (1.0 / (1.0 + t41 * t41));
      t41bd = t42bd * (1.0 / (1.0 + t41 * t41)) - t42b * (1.0 / (1.0 + t41 * t41) * (t41d * t41 +
          t41 * t41d) / (1.0 + t41 * t41));
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] += t41b * ratio;
      pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] += t41bd * ratio + t41b * ratiod;
      ratiob += t41b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF];
      ratiobd += t41bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] + t41b *
          pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF];
      tb93 = t40b / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      tb93d = (t40bd - tb93 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS]) *
          (1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS]);
      fz0b += tb93;
      fz0bd += tb93d;
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] -= tb93 * t40;
      pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] -= tb93d * t40 + tb93 * t40d;
      tb92 = ratiob / fz0;
      tb92d = (ratiobd - tb92 * fz0d) * (1.0 / fz0);
      fzb += tb92;
      fzbd += tb92d;
      fz0b -= tb92 * ratio;
      fz0bd -= tb92d * ratio + tb92 * ratiod;
    } else {
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += re2b;
      pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += re2bd;
      re2b = 0.0;
      re2bd = 0.0;
    }
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0b * p[t->tyreadr[t->wheeltyre[i]]];
    /* Re = R0 - rho0 (D atan(B rd) + F rd),  rd = Fz / Fz0,  rho0 = Fz0 / Cz;  R0 in the air */
    pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0bd * p[t->tyreadr[t->wheeltyre[i]]] +
        fz0b * pd[t->tyreadr[t->wheeltyre[i]]];
    pb[t->tyreadr[t->wheeltyre[i]]] += fz0b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO];
    pbd[t->tyreadr[t->wheeltyre[i]]] += fz0bd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] +
        fz0b * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO];
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += fzb *
        (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - z0);
    pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += fzbd *
        (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - z0) + fzb *
        (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - z0d);
    tb91 = fzb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
    tb91d = fzbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] + fzb *
        pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb91;
    pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb91d;
    z0b -= tb91;
    z0bd -= tb91d;
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
    pbd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzbd * rhov + fzb * rhovd;
    rhovb = fzb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING];
    rhovbd = fzbd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] + fzb *
        pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING];
    tb90 = rhovb / z2_2;
    tb90d = (rhovbd - tb90 * z2_2d) * (1.0 / z2_2);
    z3_2b = tb90 * v0;
    z3_2bd = tb90d * v0 + tb90 * v0d;
    v0b += tb90 * z3_2;
    v0bd += tb90d * z3_2 + tb90 * z3_2d;
    v0b -= tb90 * N0;
    v0bd -= tb90d * N0 + tb90 * N0d;
    N0b -= tb90 * v0;
    N0bd -= tb90d * v0 + tb90 * v0d;
    v1b -= tb90 * N1;
    v1bd -= tb90d * N1;
    v2b -= tb90 * N2;
    v2bd -= tb90d * N2 + tb90 * N2d;
    N2b -= tb90 * v2;
    N2bd -= tb90d * v2 + tb90 * v2d;
    z2_2b -= tb90 * rhov;
    z2_2bd -= tb90d * rhov + tb90 * rhovd;
    v0b += vxb * T0;
    v0bd += vxbd * T0 + vxb * T0d;
    T0b += vxb * v0;
    T0bd += vxbd * v0 + vxb * v0d;
    v1b += vxb * T1;
    v1bd += vxbd * T1 + vxb * T1d;
    T1b += vxb * v1;
    T1bd += vxbd * v1 + vxb * v1d;
    v2b += vxb * T2;
    v2bd += vxbd * T2 + vxb * T2d;
    T2b += vxb * v2;
    T2bd += vxbd * v2 + vxb * v2d;
    rvb[t->wheelpoint[i]][2] += v2b;
    rvbd[t->wheelpoint[i]][2] += v2bd;
    vr2b = v2b;
    vr2bd = v2bd;
    rvb[t->wheelpoint[i]][1] += v1b;
    rvbd[t->wheelpoint[i]][1] += v1bd;
    vr1b = v1b;
    vr1bd = v1bd;
    rvb[t->wheelpoint[i]][0] += v0b;
    rvbd[t->wheelpoint[i]][0] += v0bd;
    vr0b = v0b;
    vr0bd = v0bd;
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
    Z_i5b = wr2b;
    Z_i5bd = wr2bd;
    omegab -= wr2b * u2_2;
    omegabd -= wr2bd * u2_2 + wr2b * u2_2d;
    u2_2b = -(wr2b * omega);
    u2_2bd = -(wr2bd * omega + wr2b * omegad);
    Z_i4b = wr1b;
    Z_i4bd = wr1bd;
    omegab -= wr1b * u1;
    omegabd -= wr1bd * u1 + wr1b * u1d;
    u1b = -(wr1b * omega);
    u1bd = -(wr1bd * omega + wr1b * omegad);
    Z_i3b = wr0b;
    Z_i3bd = wr0bd;
    omegab -= wr0b * u0;
    omegabd -= wr0bd * u0 + wr0b * u0d;
    u0b = -(wr0b * omega);
    u0bd = -(wr0bd * omega + wr0b * omegad);
    Z_i3b += omegab * u0;
    /* Slip and forces of a wheel.  V is the velocity of the place on the road below the wheel, which the turn of
     * neither wheel nor carrier about the axis moves:
     *   Omega = w.u,  V = v_C + (w - Omega u) × r e,  rho = R0 - r,  rho' = -V.n / |u × n|
     *   Fz = Cz rho + Cd rho'
     *   kappa = -(V.t - Omega Re) / |V.t|,  tan(alpha) = V.l / |V.t|,  sin(gamma) = u.n
     * No force without contact; without grip that of the spring alone, as at rest. */
    Z_i3bd += omegabd * u0 + omegab * u0d;
    u0b += omegab * Z_i3;
    u0bd += omegabd * Z_i3 + omegab * Z_i3d;
    Z_i4b += omegab * u1;
    Z_i4bd += omegabd * u1 + omegab * u1d;
    u1b += omegab * Z_i4;
    u1bd += omegabd * Z_i4 + omegab * Z_i4d;
    Z_i5b += omegab * u2_2;
    Z_i5bd += omegabd * u2_2 + omegab * u2_2d;
    u2_2b += omegab * Z_i5;
    u2_2bd += omegabd * Z_i5 + omegab * Z_i5d;
    Zb[t->wheelbody[i]][5] += Z_i5b;
    Zbd[t->wheelbody[i]][5] += Z_i5bd;
    Zb[t->wheelbody[i]][4] += Z_i4b;
    Zbd[t->wheelbody[i]][4] += Z_i4bd;
    Zb[t->wheelbody[i]][3] += Z_i3b;
    Zbd[t->wheelbody[i]][3] += Z_i3bd;
    h12b = z3_2b;
    h12bd = z3_2bd;
    wb = z2_2b;
    wbd = z2_2bd;
    cb = z1b;
    cbd = z1bd;
    r2b = z0b;
    r2bd = z0bd;
    normal2b = N2b;
    normal2bd = N2bd;
    along2b = T2b;
    along2bd = T2bd;
    tb88 = arm2b / w;
    tb88d = (arm2bd - tb88 * wd) * (1.0 / w);
    r2b += tb88 * (c * u2_2 - normal2);
    r2bd += tb88d * (c * u2_2 - normal2) + tb88 * (cd * u2_2 + c * u2_2d - normal2d);
    tb89 = tb88 * r2;
    tb89d = tb88d * r2 + tb88 * r2d;
    cb += tb89 * u2_2;
    cbd += tb89d * u2_2 + tb89 * u2_2d;
    u2_2b += tb89 * c;
    u2_2bd += tb89d * c + tb89 * cd;
    normal2b -= tb89;
    normal2bd -= tb89d;
    wb -= tb88 * arm2;
    wbd -= tb88d * arm2 + tb88 * arm2d;
    along1b = T1b;
    along1bd = T1bd;
    tb86 = arm1b / w;
    tb86d = (arm1bd - tb86 * wd) * (1.0 / w);
    r2b += tb86 * (c * u1 - normal1);
    r2bd += tb86d * (c * u1 - normal1) + tb86 * (cd * u1 + c * u1d);
    tb87 = tb86 * r2;
    tb87d = tb86d * r2 + tb86 * r2d;
    cb += tb87 * u1;
    cbd += tb87d * u1 + tb87 * u1d;
    u1b += tb87 * c;
    u1bd += tb87d * c + tb87 * cd;
    wb -= tb86 * arm1;
    wbd -= tb86d * arm1 + tb86 * arm1d;
    normal0b = N0b;
    normal0bd = N0bd;
    along0b = T0b;
    along0bd = T0bd;
    tb84 = arm0b / w;
    tb84d = (arm0bd - tb84 * wd) * (1.0 / w);
    r2b += tb84 * (c * u0 - normal0);
    r2bd += tb84d * (c * u0 - normal0) + tb84 * (cd * u0 + c * u0d - normal0d);
    tb85 = tb84 * r2;
    tb85d = tb84d * r2 + tb84 * r2d;
    cb += tb85 * u0;
    cbd += tb85d * u0 + tb85 * u0d;
    u0b += tb85 * c;
    u0bd += tb85d * c + tb85 * cd;
    normal0b -= tb85;
    normal0bd -= tb85d;
    wb -= tb84 * arm0;
    wbd -= tb84d * arm0 + tb84 * arm0d;
    normal0b += L2b * along1;
    normal0bd += L2bd * along1 + L2b * along1d;
    along1b += L2b * normal0;
    along1bd += L2bd * normal0 + L2b * normal0d;
    along0b -= L2b * normal1;
    along0bd -= L2bd * normal1;
    normal2b += L1b * along0;
    normal2bd += L1bd * along0 + L1b * along0d;
    along0b += L1b * normal2;
    along0bd += L1bd * normal2 + L1b * normal2d;
    normal0b -= L1b * along2;
    normal0bd -= L1bd * along2 + L1b * along2d;
    along2b -= L1b * normal0;
    along2bd -= L1bd * normal0 + L1b * normal0d;
    along2b += L0b * normal1;
    along2bd += L0bd * normal1;
    normal2b -= L0b * along1;
    normal2bd -= L0bd * along1 + L0b * along1d;
    along1b -= L0b * normal2;
    along1bd -= L0bd * normal2 + L0b * normal2d;
    tb83 = along2b / w;
    tb83d = (along2bd - tb83 * wd) * (1.0 / w);
    un2b = tb83;
    un2bd = tb83d;
    wb -= tb83 * along2;
    wbd -= tb83d * along2 + tb83 * along2d;
    tb82 = along1b / w;
    tb82d = (along1bd - tb82 * wd) * (1.0 / w);
    un1b = tb82;
    un1bd = tb82d;
    wb -= tb82 * along1;
    wbd -= tb82d * along1 + tb82 * along1d;
    tb81 = along0b / w;
    tb81d = (along0bd - tb81 * wd) * (1.0 / w);
    un0b = tb81;
    un0bd = tb81d;
    wb -= tb81 * along0;
    wbd -= tb81d * along0 + tb81 * along0d;
    tb78 = r2b / w;
    tb78d = (r2bd - tb78 * wd) * (1.0 / w);
    tb79 = tb78 * normal0;
    tb79d = tb78d * normal0 + tb78 * normal0d;
    g0b = tb79;
    g0bd = tb79d;
    xb = -tb79;
    xbd = -tb79d;
    normal0b += tb78 * (g0 - x);
    normal0bd += tb78d * (g0 - x) + tb78 * (g0d - xd);
    tb80 = tb78 * normal2;
    tb80d = tb78d * normal2 + tb78 * normal2d;
    g2_2b = tb80;
    g2_2bd = tb80d;
    h10b = -tb80;
    h10bd = -tb80d;
    normal2b += tb78 * (g2_2 - h10);
    normal2bd += tb78d * (g2_2 - h10) + tb78 * (g2_2d - h10d);
    wb -= tb78 * r2;
    wbd -= tb78d * r2 + tb78 * r2d;
    t39b = wb * (1.0 / (2.0 * w));
    t39bd = wbd * (1.0 / (2.0 * w)) - wb * (1.0 / (2.0 * w) * (2.0 * wd) / (2.0 * w));
    un0b += t39b * un0;
    un0bd += t39bd * un0 + t39b * un0d;
    un0b += t39b * un0;
    un0bd += t39bd * un0 + t39b * un0d;
    un1b += t39b * un1;
    un1bd += t39bd * un1 + t39b * un1d;
    un1b += t39b * un1;
    un1bd += t39bd * un1 + t39b * un1d;
    un2b += t39b * un2;
    un2bd += t39bd * un2 + t39b * un2d;
    un2b += t39b * un2;
    un2bd += t39bd * un2 + t39b * un2d;
    u0b += un2b * normal1;
    u0bd += un2bd * normal1;
    u1b -= un2b * normal0;
    u1bd -= un2bd * normal0 + un2b * normal0d;
    normal0b -= un2b * u1;
    normal0bd -= un2bd * u1 + un2b * u1d;
    u2_2b += un1b * normal0;
    u2_2bd += un1bd * normal0 + un1b * normal0d;
    normal0b += un1b * u2_2;
    normal0bd += un1bd * u2_2 + un1b * u2_2d;
    u0b -= un1b * normal2;
    u0bd -= un1bd * normal2 + un1b * normal2d;
    normal2b -= un1b * u0;
    normal2bd -= un1bd * u0 + un1b * u0d;
    u1b += un0b * normal2;
    u1bd += un0bd * normal2 + un0b * normal2d;
    normal2b += un0b * u1;
    normal2bd += un0bd * u1 + un0b * u1d;
    u2_2b -= un0b * normal1;
    u2_2bd -= un0bd * normal1;
    u0b += cb * normal0;
    u0bd += cbd * normal0 + cb * normal0d;
    normal0b += cb * u0;
    normal0bd += cbd * u0 + cb * u0d;
    u1b += cb * normal1;
    u1bd += cbd * normal1;
    u2_2b += cb * normal2;
    u2_2bd += cbd * normal2 + cb * normal2d;
    normal2b += cb * u2_2;
    normal2bd += cbd * u2_2 + cb * u2_2d;
    tb77 = normal2b / s;
    tb77d = (normal2bd - tb77 * sd) * (1.0 / s);
    sb = -(tb77 * normal2);
    sbd = -(tb77d * normal2 + tb77 * normal2d);
    tb76 = normal0b / s;
    tb76d = (normal0bd - tb76 * sd) * (1.0 / s);
    h11b = -tb76;
    h11bd = -tb76d;
    sb -= tb76 * normal0;
    sbd -= tb76d * normal0 + tb76 * normal0d;
    t38b = sb * (1.0 / (2.0 * s));
    t38bd = sbd * (1.0 / (2.0 * s)) - sb * (1.0 / (2.0 * s) * (2.0 * sd) / (2.0 * s));
    h11b += t38b * h11;
    h11bd += t38bd * h11 + t38b * h11d;
    h11b += t38b * h11;
    h11bd += t38bd * h11 + t38b * h11d;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road4 = p[t->roadadr[road]];
      p_road4d = pd[t->roadadr[road]];
      h12b = 0.0;
      h12bd = 0.0;
      p_road4b = h11b;
      p_road4bd = h11bd;
      h11b = 0.0;
      h11bd = 0.0;
      p_road4b += h10b * x;
      p_road4bd += h10bd * x + h10b * xd;
      xb += h10b * p_road4;
      xbd += h10bd * p_road4 + h10b * p_road4d;
      h10b = 0.0;
      h10bd = 0.0;
      pb[t->roadadr[road]] += p_road4b;
      pbd[t->roadadr[road]] += p_road4bd;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k7 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      k7d = -(k7 * pd[t->roadadr[road] + 1] * (1.0 / p[t->roadadr[road] + 1]));
      t18 = k7 * x;
      t18d = k7d * x + k7 * xd;
      t19 = sin(t18);
      t19d = cos(t18) * t18d;
      p_road5 = p[t->roadadr[road]];
      p_road5d = pd[t->roadadr[road]];
      t20 = k7 * x;
      t20d = k7d * x + k7 * xd;
      t21 = cos(t20);
      t21d = -(sin(t20) * t20d);
      h12b = 0.0;
      h12bd = 0.0;
      tb37 = h11b * t21;
      tb37d = h11bd * t21 + h11b * t21d;
      k7b = tb37 * p_road5;
      k7bd = tb37d * p_road5 + tb37 * p_road5d;
      p_road5b = tb37 * k7;
      p_road5bd = tb37d * k7 + tb37 * k7d;
      t21b = h11b * (k7 * p_road5);
      t21bd = h11bd * (k7 * p_road5) + h11b * (k7d * p_road5 + k7 * p_road5d);
      h11b = 0.0;
      h11bd = 0.0;
      t20b = -(t21b * sin(t20));
      t20bd = -(t21bd * sin(t20) + t21b * (cos(t20) * t20d));
      k7b += t20b * x;
      k7bd += t20bd * x + t20b * xd;
      xb += t20b * k7;
      xbd += t20bd * k7 + t20b * k7d;
      p_road5b += h10b * t19;
      p_road5bd += h10bd * t19 + h10b * t19d;
      t19b = h10b * p_road5;
      t19bd = h10bd * p_road5 + h10b * p_road5d;
      h10b = 0.0;
      h10bd = 0.0;
      pb[t->roadadr[road]] += p_road5b;
      pbd[t->roadadr[road]] += p_road5bd;
      t18b = t19b * cos(t18);
      t18bd = t19bd * cos(t18) - t19b * (sin(t18) * t18d);
      k7b += t18b * x;
      k7bd += t18bd * x + t18b * xd;
      xb += t18b * k7;
      xbd += t18bd * k7 + t18b * k7d;
      tb36 = k7b / p[t->roadadr[road] + 1];
      tb36d = (k7bd - tb36 * pd[t->roadadr[road] + 1]) * (1.0 / p[t->roadadr[road] + 1]);
      pb[t->roadadr[road] + 1] -= tb36 * k7;
      pbd[t->roadadr[road] + 1] -= tb36d * k7 + tb36 * k7d;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k6 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x);
      x4 = x - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k6 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      x4d = xd - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k6 * pd[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius2 = p[t->roadadr[road]];
      radius2d = pd[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      base2d = radius2d - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      t22d = radius2d * radius2 + radius2 * radius2d - (base2d * base2 + base2 * base2d);
      c4 = sqrt(t22);
      c4d = 1.0 / (2.0 * c4) * t22d;
      f3 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      f3d = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x4) > 0.0) {
        way2 = 1.0;
      } else {
        way2 = -1.0;
      }
      y2 = way2 * x4;
      y2d = way2 * x4d;
      b31b = h12b;
      b31bd = h12bd;
      h12b = 0.0;
      h12bd = 0.0;
      h11b = 0.0;
      h11bd = 0.0;
      b30b = h10b;
      b30bd = h10bd;
      h10b = 0.0;
      h10bd = 0.0;
      base2b = 0.0;
      base2bd = 0.0;
      c4b = 0.0;
      c4bd = 0.0;
      f3b = 0.0;
      f3bd = 0.0;
      radius2b = 0.0;
      radius2bd = 0.0;
      x4b = 0.0;
      x4bd = 0.0;
      y2b = 0.0;
      y2bd = 0.0;
      if (MAGGI_RE(y2) >= MAGGI_RE(c4 + f3)) {
        b31b = 0.0;
        b31bd = 0.0;
        b30b = 0.0;
        b30bd = 0.0;
      } else if (MAGGI_RE(y2) > MAGGI_RE(c4 - f3)) {
        t23 = radius2 * radius2 - (c4 - f3) * (c4 - f3);
        t23d = radius2d * radius2 + radius2 * radius2d - ((c4d - f3d) * (c4 - f3) + (c4 - f3) * (c4d
            - f3d));
        z3 = sqrt(t23);
        z3d = 1.0 / (2.0 * z3) * t23d;
        h0_3 = z3 - base2;
        h0_3d = z3d - base2d;
        h1_3 = 2.0 * f3 * (c4 - f3) / z3;
        h1_3d = (2.0 * f3d * (c4 - f3) + 2.0 * f3 * (c4d - f3d) - h1_3 * z3d) * (1.0 / z3);
        a3 = 3.0 * h0_3 - h1_3;
        a3d = 3.0 * h0_3d - h1_3d;
        t24 = z3 * z3 * z3;
        t24d = (z3d * z3 + z3 * z3d) * z3 + z3 * z3 * z3d;
        t25 = 2.0 * f3 * f3 * radius2 * radius2 / t24;
        t25d = (((2.0 * f3d * f3 + 2.0 * f3 * f3d) * radius2 + 2.0 * f3 * f3 * radius2d) * radius2 +
            2.0 * f3 * f3 * radius2 * radius2d - t25 * t24d) * (1.0 / t24);
        b4 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        b4d = 6.0 * h0_3d - 3.0 * h1_3d - t25d;
        t26 = 2.0 * f3;
        t26d = 2.0 * f3d;
        u3 = (c4 + f3 - y2) / t26;
        u3d = (c4d + f3d - y2d - u3 * t26d) * (1.0 / t26);
        w3 = 1.0 - u3;
        w3d = -u3d;
        t27 = 2.0 * f3;
        t27d = 2.0 * f3d;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 * (a3 + 2.0 * w3 * b4)) /
            t27;
        t28d = ((-(way2 * u3d * u3) + -way2 * u3 * u3d) * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 *
            (a3 + 2.0 * w3 * b4)) + -way2 * u3 * u3 * (3.0 * (h0_3d + (w3d * (a3 + w3 * b4) + w3 *
            (a3d + (w3d * b4 + w3 * b4d)))) - (u3d * (a3 + 2.0 * w3 * b4) + u3 * (a3d + (2.0 * w3d *
            b4 + 2.0 * w3 * b4d)))) - t28 * t27d) * (1.0 / t27);
        t28b = b31b;
        t28bd = b31bd;
        b31b = 0.0;
        b31bd = 0.0;
        tb51 = t28b / t27;
        tb51d = (t28bd - tb51 * t27d) * (1.0 / t27);
        tb52 = tb51 * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 * (a3 + 2.0 * w3 * b4));
        tb52d = tb51d * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 * (a3 + 2.0 * w3 * b4)) + tb51 *
            (3.0 * (h0_3d + (w3d * (a3 + w3 * b4) + w3 * (a3d + (w3d * b4 + w3 * b4d)))) - (u3d *
            (a3 + 2.0 * w3 * b4) + u3 * (a3d + (2.0 * w3d * b4 + 2.0 * w3 * b4d))));
        u3b = -(tb52 * u3 * way2);
        u3bd = -((tb52d * u3 + tb52 * u3d) * way2);
        u3b += tb52 * (-way2 * u3);
        u3bd += tb52d * (-way2 * u3) - tb52 * (way2 * u3d);
        tb53 = tb51 * (-way2 * u3 * u3);
        tb53d = tb51d * (-way2 * u3 * u3) + tb51 * (-(way2 * u3d * u3) + -way2 * u3 * u3d);
        tb54 = tb53 * 3.0;
        tb54d = tb53d * 3.0;
        h0_3b = tb54;
        h0_3bd = tb54d;
        w3b = tb54 * (a3 + w3 * b4);
        w3bd = tb54d * (a3 + w3 * b4) + tb54 * (a3d + (w3d * b4 + w3 * b4d));
        tb55 = tb54 * w3;
        tb55d = tb54d * w3 + tb54 * w3d;
        a3b = tb55;
        a3bd = tb55d;
        w3b += tb55 * b4;
        w3bd += tb55d * b4 + tb55 * b4d;
        b4b = tb55 * w3;
        b4bd = tb55d * w3 + tb55 * w3d;
        u3b -= tb53 * (a3 + 2.0 * w3 * b4);
        u3bd -= tb53d * (a3 + 2.0 * w3 * b4) + tb53 * (a3d + (2.0 * w3d * b4 + 2.0 * w3 * b4d));
        tb56 = tb53 * u3;
        tb56d = tb53d * u3 + tb53 * u3d;
        a3b -= tb56;
        a3bd -= tb56d;
        w3b -= tb56 * b4 * 2.0;
        w3bd -= (tb56d * b4 + tb56 * b4d) * 2.0;
        b4b -= tb56 * (2.0 * w3);
        b4bd -= tb56d * (2.0 * w3) + tb56 * (2.0 * w3d);
        t27b = -(tb51 * t28);
        t27bd = -(tb51d * t28 + tb51 * t28d);
        f3b += t27b * 2.0;
        f3bd += t27bd * 2.0;
        tb47 = b30b * (h0_3 + w3 * (a3 + w3 * b4));
        tb47d = b30bd * (h0_3 + w3 * (a3 + w3 * b4)) + b30b * (h0_3d + (w3d * (a3 + w3 * b4) + w3 *
            (a3d + (w3d * b4 + w3 * b4d))));
        tb48 = tb47 * u3;
        tb48d = tb47d * u3 + tb47 * u3d;
        u3b += tb48 * u3;
        u3bd += tb48d * u3 + tb48 * u3d;
        u3b += tb48 * u3;
        u3bd += tb48d * u3 + tb48 * u3d;
        u3b += tb47 * (u3 * u3);
        u3bd += tb47d * (u3 * u3) + tb47 * (u3d * u3 + u3 * u3d);
        tb49 = b30b * (u3 * u3 * u3);
        tb49d = b30bd * (u3 * u3 * u3) + b30b * ((u3d * u3 + u3 * u3d) * u3 + u3 * u3 * u3d);
        h0_3b += tb49;
        h0_3bd += tb49d;
        w3b += tb49 * (a3 + w3 * b4);
        w3bd += tb49d * (a3 + w3 * b4) + tb49 * (a3d + (w3d * b4 + w3 * b4d));
        tb50 = tb49 * w3;
        tb50d = tb49d * w3 + tb49 * w3d;
        a3b += tb50;
        a3bd += tb50d;
        w3b += tb50 * b4;
        w3bd += tb50d * b4 + tb50 * b4d;
        b4b += tb50 * w3;
        b4bd += tb50d * w3 + tb50 * w3d;
        b30b = 0.0;
        b30bd = 0.0;
        u3b -= w3b;
        u3bd -= w3bd;
        tb46 = u3b / t26;
        tb46d = (u3bd - tb46 * t26d) * (1.0 / t26);
        c4b += tb46;
        c4bd += tb46d;
        f3b += tb46;
        f3bd += tb46d;
        y2b -= tb46;
        y2bd -= tb46d;
        t26b = -(tb46 * u3);
        t26bd = -(tb46d * u3 + tb46 * u3d);
        f3b += t26b * 2.0;
        f3bd += t26bd * 2.0;
        h0_3b += b4b * 6.0;
        h0_3bd += b4bd * 6.0;
        h1_3b = -(b4b * 3.0);
        h1_3bd = -(b4bd * 3.0);
        t25b = -b4b;
        t25bd = -b4bd;
        tb43 = t25b / t24;
        tb43d = (t25bd - tb43 * t24d) * (1.0 / t24);
        tb44 = tb43 * radius2;
        tb44d = tb43d * radius2 + tb43 * radius2d;
        tb45 = tb44 * radius2;
        tb45d = tb44d * radius2 + tb44 * radius2d;
        f3b += tb45 * f3 * 2.0;
        f3bd += (tb45d * f3 + tb45 * f3d) * 2.0;
        f3b += tb45 * (2.0 * f3);
        f3bd += tb45d * (2.0 * f3) + tb45 * (2.0 * f3d);
        radius2b += tb44 * (2.0 * f3 * f3);
        radius2bd += tb44d * (2.0 * f3 * f3) + tb44 * (2.0 * f3d * f3 + 2.0 * f3 * f3d);
        radius2b += tb43 * (2.0 * f3 * f3 * radius2);
        radius2bd += tb43d * (2.0 * f3 * f3 * radius2) + tb43 * ((2.0 * f3d * f3 + 2.0 * f3 * f3d) *
            radius2 + 2.0 * f3 * f3 * radius2d);
        t24b = -(tb43 * t25);
        t24bd = -(tb43d * t25 + tb43 * t25d);
        tb42 = t24b * z3;
        tb42d = t24bd * z3 + t24b * z3d;
        z3b = tb42 * z3;
        z3bd = tb42d * z3 + tb42 * z3d;
        z3b += tb42 * z3;
        z3bd += tb42d * z3 + tb42 * z3d;
        z3b += t24b * (z3 * z3);
        z3bd += t24bd * (z3 * z3) + t24b * (z3d * z3 + z3 * z3d);
        h0_3b += a3b * 3.0;
        h0_3bd += a3bd * 3.0;
        h1_3b -= a3b;
        h1_3bd -= a3bd;
        tb40 = h1_3b / z3;
        tb40d = (h1_3bd - tb40 * z3d) * (1.0 / z3);
        f3b += tb40 * (c4 - f3) * 2.0;
        f3bd += (tb40d * (c4 - f3) + tb40 * (c4d - f3d)) * 2.0;
        tb41 = tb40 * (2.0 * f3);
        tb41d = tb40d * (2.0 * f3) + tb40 * (2.0 * f3d);
        c4b += tb41;
        c4bd += tb41d;
        f3b -= tb41;
        f3bd -= tb41d;
        z3b -= tb40 * h1_3;
        z3bd -= tb40d * h1_3 + tb40 * h1_3d;
        z3b += h0_3b;
        z3bd += h0_3bd;
        base2b -= h0_3b;
        base2bd -= h0_3bd;
        t23b = z3b * (1.0 / (2.0 * z3));
        t23bd = z3bd * (1.0 / (2.0 * z3)) - z3b * (1.0 / (2.0 * z3) * (2.0 * z3d) / (2.0 * z3));
        radius2b += t23b * radius2;
        radius2bd += t23bd * radius2 + t23b * radius2d;
        radius2b += t23b * radius2;
        radius2bd += t23bd * radius2 + t23b * radius2d;
        tb38 = t23b * (c4 - f3);
        tb38d = t23bd * (c4 - f3) + t23b * (c4d - f3d);
        c4b -= tb38;
        c4bd -= tb38d;
        f3b += tb38;
        f3bd += tb38d;
        tb39 = t23b * (c4 - f3);
        tb39d = t23bd * (c4 - f3) + t23b * (c4d - f3d);
        c4b -= tb39;
        c4bd -= tb39d;
        f3b += tb39;
        f3bd += tb39d;
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        t29d = radius2d * radius2 + radius2 * radius2d - (y2d * y2 + y2 * y2d);
        z3_3 = sqrt(t29);
        z3_3d = 1.0 / (2.0 * z3_3) * t29d;
        t30 = -x4 / z3_3;
        t30d = (-x4d - t30 * z3_3d) * (1.0 / z3_3);
        t30b = b31b;
        t30bd = b31bd;
        b31b = 0.0;
        b31bd = 0.0;
        tb57 = t30b / z3_3;
        tb57d = (t30bd - tb57 * z3_3d) * (1.0 / z3_3);
        x4b -= tb57;
        x4bd -= tb57d;
        z3_3b = -(tb57 * t30);
        z3_3bd = -(tb57d * t30 + tb57 * t30d);
        z3_3b += b30b;
        z3_3bd += b30bd;
        base2b -= b30b;
        base2bd -= b30bd;
        b30b = 0.0;
        b30bd = 0.0;
        t29b = z3_3b * (1.0 / (2.0 * z3_3));
        t29bd = z3_3bd * (1.0 / (2.0 * z3_3)) - z3_3b * (1.0 / (2.0 * z3_3) * (2.0 * z3_3d) / (2.0 *
            z3_3));
        radius2b += t29b * radius2;
        radius2bd += t29bd * radius2 + t29b * radius2d;
        radius2b += t29b * radius2;
        radius2bd += t29bd * radius2 + t29b * radius2d;
        y2b -= t29b * y2;
        y2bd -= t29bd * y2 + t29b * y2d;
        y2b -= t29b * y2;
        y2bd -= t29bd * y2 + t29b * y2d;
      }
      x4b += y2b * way2;
      x4bd += y2bd * way2;
      pb[t->roadadr[road] + MAGGI_BUMPS_FILLET] += f3b * 0.5;
      pbd[t->roadadr[road] + MAGGI_BUMPS_FILLET] += f3bd * 0.5;
      t22b = c4b * (1.0 / (2.0 * c4));
      t22bd = c4bd * (1.0 / (2.0 * c4)) - c4b * (1.0 / (2.0 * c4) * (2.0 * c4d) / (2.0 * c4));
      radius2b += t22b * radius2;
      radius2bd += t22bd * radius2 + t22b * radius2d;
      radius2b += t22b * radius2;
      radius2bd += t22bd * radius2 + t22b * radius2d;
      base2b -= t22b * base2;
      base2bd -= t22bd * base2 + t22b * base2d;
      base2b -= t22b * base2;
      base2bd -= t22bd * base2 + t22b * base2d;
      radius2b += base2b;
      radius2bd += base2bd;
      pb[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= base2b;
      pbd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= base2bd;
      pb[t->roadadr[road]] += radius2b;
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      pbd[t->roadadr[road]] += radius2bd;
      xb += x4b;
      xbd += x4bd;
      pb[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x4b;
      pbd[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x4bd;
      pb[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x4b * k6;
      pbd[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x4bd * k6;
    } else {
      k8 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x);
      h12b = 0.0;
      h12bd = 0.0;
      s31b = h11b;
      s31bd = h11bd;
      h11b = 0.0;
      h11bd = 0.0;
      s30b = h10b;
      s30bd = h10bd;
      h10b = 0.0;
      h10bd = 0.0;
      if (k8 < 0) {
        p_road6 = p[t->roadadr[road]];
        p_road6d = pd[t->roadadr[road]];
        h2 = p[t->roadadr[road] + 1] - p_road6;
        h2d = pd[t->roadadr[road] + 1] - p_road6d;
        p_roadroad2 = p[t->roadadr[road] + t->roadn[road]];
        p_roadroad2d = pd[t->roadadr[road] + t->roadn[road]];
        t31 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2) / h2;
        t31d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2d - t31 * h2d) * (1.0 / h2);
        slope2 = t31 - h2 / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]);
        slope2d = t31d - (h2d / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]) + h2 / 6.0 * (2.0 *
            spline0d[t->roadspline[road]][0] + spline0d[t->roadspline[road] + 1][0]));
        slope2b = s31b;
        slope2bd = s31bd;
        s31b = 0.0;
        s31bd = 0.0;
        p_roadroad2b = s30b;
        p_roadroad2bd = s30bd;
        slope2b += s30b * (x - p_road6);
        slope2bd += s30bd * (x - p_road6) + s30b * (xd - p_road6d);
        tb60 = s30b * slope2;
        tb60d = s30bd * slope2 + s30b * slope2d;
        xb += tb60;
        xbd += tb60d;
        p_road6b = -tb60;
        p_road6bd = -tb60d;
        s30b = 0.0;
        s30bd = 0.0;
        t31b = slope2b;
        t31bd = slope2bd;
        h2b = -(slope2b * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) / 6.0);
        h2bd = -((slope2bd * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) + slope2b * (2.0 * spline0d[t->roadspline[road]][0] +
            spline0d[t->roadspline[road] + 1][0])) / 6.0);
        tb59 = slope2b * (h2 / 6.0);
        tb59d = slope2bd * (h2 / 6.0) + slope2b * (h2d / 6.0);
        spline0b[t->roadspline[road]][0] -= tb59 * 2.0;
        spline0bd[t->roadspline[road]][0] -= tb59d * 2.0;
        spline0b[t->roadspline[road] + 1][0] -= tb59;
        spline0bd[t->roadspline[road] + 1][0] -= tb59d;
        tb58 = t31b / h2;
        tb58d = (t31bd - tb58 * h2d) * (1.0 / h2);
        pb[t->roadadr[road] + t->roadn[road] + 1] += tb58;
        pbd[t->roadadr[road] + t->roadn[road] + 1] += tb58d;
        p_roadroad2b -= tb58;
        p_roadroad2bd -= tb58d;
        h2b -= tb58 * t31;
        h2bd -= tb58d * t31 + tb58 * t31d;
        pb[t->roadadr[road] + t->roadn[road]] += p_roadroad2b;
        pbd[t->roadadr[road] + t->roadn[road]] += p_roadroad2bd;
        pb[t->roadadr[road] + 1] += h2b;
        pbd[t->roadadr[road] + 1] += h2bd;
        p_road6b -= h2b;
        p_road6bd -= h2bd;
        pb[t->roadadr[road]] += p_road6b;
        pbd[t->roadadr[road]] += p_road6bd;
      } else if (k8 > t->roadn[road] - 2) {
        p5 = p[t->roadadr[road] + t->roadn[road] - 1];
        p5d = pd[t->roadadr[road] + t->roadn[road] - 1];
        h2_2 = p5 - p[t->roadadr[road] + t->roadn[road] - 2];
        h2_2d = p5d - pd[t->roadadr[road] + t->roadn[road] - 2];
        p6 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        p6d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t32 = (p6 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h2_2;
        t32d = (p6d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t32 * h2_2d) *
            (1.0 / h2_2);
        slope2_2 = t32 + h2_2 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        slope2_2d = t32d + (h2_2d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] +
            2.0 * spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h2_2 / 6.0 *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0]));
        slope2_2b = s31b;
        slope2_2bd = s31bd;
        s31b = 0.0;
        s31bd = 0.0;
        p6b = s30b;
        p6bd = s30bd;
        slope2_2b += s30b * (x - p5);
        slope2_2bd += s30bd * (x - p5) + s30b * (xd - p5d);
        tb63 = s30b * slope2_2;
        tb63d = s30bd * slope2_2 + s30b * slope2_2d;
        xb += tb63;
        xbd += tb63d;
        p5b = -tb63;
        p5bd = -tb63d;
        s30b = 0.0;
        s30bd = 0.0;
        t32b = slope2_2b;
        t32bd = slope2_2bd;
        h2_2b = slope2_2b * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) / 6.0;
        h2_2bd = (slope2_2bd * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + slope2_2b *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0])) / 6.0;
        tb62 = slope2_2b * (h2_2 / 6.0);
        tb62d = slope2_2bd * (h2_2 / 6.0) + slope2_2b * (h2_2d / 6.0);
        spline0b[t->roadspline[road] + t->roadn[road] - 2][0] += tb62;
        spline0bd[t->roadspline[road] + t->roadn[road] - 2][0] += tb62d;
        spline0b[t->roadspline[road] + t->roadn[road] - 1][0] += tb62 * 2.0;
        spline0bd[t->roadspline[road] + t->roadn[road] - 1][0] += tb62d * 2.0;
        tb61 = t32b / h2_2;
        tb61d = (t32bd - tb61 * h2_2d) * (1.0 / h2_2);
        p6b += tb61;
        p6bd += tb61d;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb61;
        pbd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb61d;
        h2_2b -= tb61 * t32;
        h2_2bd -= tb61d * t32 + tb61 * t32d;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p6b;
        pbd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p6bd;
        p5b += h2_2b;
        p5bd += h2_2bd;
        pb[t->roadadr[road] + t->roadn[road] - 2] -= h2_2b;
        pbd[t->roadadr[road] + t->roadn[road] - 2] -= h2_2bd;
        pb[t->roadadr[road] + t->roadn[road] - 1] += p5b;
        pbd[t->roadadr[road] + t->roadn[road] - 1] += p5bd;
      } else {
        p_roadk81 = p[t->roadadr[road] + k8 + 1];
        p_roadk81d = pd[t->roadadr[road] + k8 + 1];
        p_roadk8 = p[t->roadadr[road] + k8];
        p_roadk8d = pd[t->roadadr[road] + k8];
        h2_3 = p_roadk81 - p_roadk8;
        h2_3d = p_roadk81d - p_roadk8d;
        a4 = p_roadk81 - x;
        a4d = p_roadk81d - xd;
        c5 = x - p_roadk8;
        c5d = xd - p_roadk8d;
        p7 = p[t->roadadr[road] + t->roadn[road] + k8];
        p7d = pd[t->roadadr[road] + t->roadn[road] + k8];
        t33 = (p[t->roadadr[road] + t->roadn[road] + k8 + 1] - p7) / h2_3;
        t33d = (pd[t->roadadr[road] + t->roadn[road] + k8 + 1] - p7d - t33 * h2_3d) * (1.0 / h2_3);
        spline0_roadk810 = spline0[t->roadspline[road] + k8 + 1][0];
        spline0_roadk810d = spline0d[t->roadspline[road] + k8 + 1][0];
        spline0_roadk80 = spline0[t->roadspline[road] + k8][0];
        spline0_roadk80d = spline0d[t->roadspline[road] + k8][0];
        e2 = t33 - h2_3 / 6.0 * (spline0_roadk810 - spline0_roadk80);
        e2d = t33d - (h2_3d / 6.0 * (spline0_roadk810 - spline0_roadk80) + h2_3 / 6.0 *
            (spline0_roadk810d - spline0_roadk80d));
        t34 = 6.0 * h2_3;
        t34d = 6.0 * h2_3d;
        t35 = (spline0_roadk80 * a4 * a4 * a4 + spline0_roadk810 * c5 * c5 * c5) / t34;
        t35d = (((spline0_roadk80d * a4 + spline0_roadk80 * a4d) * a4 + spline0_roadk80 * a4 * a4d)
            * a4 + spline0_roadk80 * a4 * a4 * a4d + (((spline0_roadk810d * c5 + spline0_roadk810 *
            c5d) * c5 + spline0_roadk810 * c5 * c5d) * c5 + spline0_roadk810 * c5 * c5 * c5d) - t35
            * t34d) * (1.0 / t34);
        t36 = 2.0 * h2_3;
        t36d = 2.0 * h2_3d;
        t37 = (spline0_roadk810 * c5 * c5 - spline0_roadk80 * a4 * a4) / t36;
        t37d = ((spline0_roadk810d * c5 + spline0_roadk810 * c5d) * c5 + spline0_roadk810 * c5 * c5d
            - ((spline0_roadk80d * a4 + spline0_roadk80 * a4d) * a4 + spline0_roadk80 * a4 * a4d) -
            t37 * t36d) * (1.0 / t36);
        t37b = s31b;
        t37bd = s31bd;
        e2b = s31b;
        e2bd = s31bd;
        s31b = 0.0;
        s31bd = 0.0;
        tb73 = t37b / t36;
        tb73d = (t37bd - tb73 * t36d) * (1.0 / t36);
        tb74 = tb73 * c5;
        tb74d = tb73d * c5 + tb73 * c5d;
        spline0_roadk810b = tb74 * c5;
        spline0_roadk810bd = tb74d * c5 + tb74 * c5d;
        c5b = tb74 * spline0_roadk810;
        c5bd = tb74d * spline0_roadk810 + tb74 * spline0_roadk810d;
        c5b += tb73 * (spline0_roadk810 * c5);
        c5bd += tb73d * (spline0_roadk810 * c5) + tb73 * (spline0_roadk810d * c5 + spline0_roadk810
            * c5d);
        tb75 = tb73 * a4;
        tb75d = tb73d * a4 + tb73 * a4d;
        spline0_roadk80b = -(tb75 * a4);
        spline0_roadk80bd = -(tb75d * a4 + tb75 * a4d);
        a4b = -(tb75 * spline0_roadk80);
        a4bd = -(tb75d * spline0_roadk80 + tb75 * spline0_roadk80d);
        a4b -= tb73 * (spline0_roadk80 * a4);
        a4bd -= tb73d * (spline0_roadk80 * a4) + tb73 * (spline0_roadk80d * a4 + spline0_roadk80 *
            a4d);
        t36b = -(tb73 * t37);
        t36bd = -(tb73d * t37 + tb73 * t37d);
        h2_3b = t36b * 2.0;
        h2_3bd = t36bd * 2.0;
        t35b = s30b;
        t35bd = s30bd;
        p7b = s30b;
        p7bd = s30bd;
        tb71 = s30b / 6.0;
        tb71d = s30bd / 6.0;
        tb72 = tb71 * h2_3;
        tb72d = tb71d * h2_3 + tb71 * h2_3d;
        spline0_roadk80b -= tb72 * h2_3;
        spline0_roadk80bd -= tb72d * h2_3 + tb72 * h2_3d;
        h2_3b -= tb72 * spline0_roadk80;
        h2_3bd -= tb72d * spline0_roadk80 + tb72 * spline0_roadk80d;
        h2_3b -= tb71 * (spline0_roadk80 * h2_3);
        h2_3bd -= tb71d * (spline0_roadk80 * h2_3) + tb71 * (spline0_roadk80d * h2_3 +
            spline0_roadk80 * h2_3d);
        e2b += s30b * c5;
        e2bd += s30bd * c5 + s30b * c5d;
        c5b += s30b * e2;
        c5bd += s30bd * e2 + s30b * e2d;
        s30b = 0.0;
        s30bd = 0.0;
        tb66 = t35b / t34;
        tb66d = (t35bd - tb66 * t34d) * (1.0 / t34);
        tb67 = tb66 * a4;
        tb67d = tb66d * a4 + tb66 * a4d;
        tb68 = tb67 * a4;
        tb68d = tb67d * a4 + tb67 * a4d;
        spline0_roadk80b += tb68 * a4;
        spline0_roadk80bd += tb68d * a4 + tb68 * a4d;
        a4b += tb68 * spline0_roadk80;
        a4bd += tb68d * spline0_roadk80 + tb68 * spline0_roadk80d;
        a4b += tb67 * (spline0_roadk80 * a4);
        a4bd += tb67d * (spline0_roadk80 * a4) + tb67 * (spline0_roadk80d * a4 + spline0_roadk80 *
            a4d);
        a4b += tb66 * (spline0_roadk80 * a4 * a4);
        a4bd += tb66d * (spline0_roadk80 * a4 * a4) + tb66 * ((spline0_roadk80d * a4 +
            spline0_roadk80 * a4d) * a4 + spline0_roadk80 * a4 * a4d);
        tb69 = tb66 * c5;
        tb69d = tb66d * c5 + tb66 * c5d;
        tb70 = tb69 * c5;
        tb70d = tb69d * c5 + tb69 * c5d;
        spline0_roadk810b += tb70 * c5;
        spline0_roadk810bd += tb70d * c5 + tb70 * c5d;
        c5b += tb70 * spline0_roadk810;
        c5bd += tb70d * spline0_roadk810 + tb70 * spline0_roadk810d;
        c5b += tb69 * (spline0_roadk810 * c5);
        c5bd += tb69d * (spline0_roadk810 * c5) + tb69 * (spline0_roadk810d * c5 + spline0_roadk810
            * c5d);
        c5b += tb66 * (spline0_roadk810 * c5 * c5);
        c5bd += tb66d * (spline0_roadk810 * c5 * c5) + tb66 * ((spline0_roadk810d * c5 +
            spline0_roadk810 * c5d) * c5 + spline0_roadk810 * c5 * c5d);
        t34b = -(tb66 * t35);
        t34bd = -(tb66d * t35 + tb66 * t35d);
        h2_3b += t34b * 6.0;
        h2_3bd += t34bd * 6.0;
        t33b = e2b;
        t33bd = e2bd;
        h2_3b -= e2b * (spline0_roadk810 - spline0_roadk80) / 6.0;
        h2_3bd -= (e2bd * (spline0_roadk810 - spline0_roadk80) + e2b * (spline0_roadk810d -
            spline0_roadk80d)) / 6.0;
        tb65 = e2b * (h2_3 / 6.0);
        tb65d = e2bd * (h2_3 / 6.0) + e2b * (h2_3d / 6.0);
        spline0_roadk810b -= tb65;
        spline0_roadk810bd -= tb65d;
        spline0_roadk80b += tb65;
        spline0_roadk80bd += tb65d;
        spline0b[t->roadspline[road] + k8][0] += spline0_roadk80b;
        spline0bd[t->roadspline[road] + k8][0] += spline0_roadk80bd;
        spline0b[t->roadspline[road] + k8 + 1][0] += spline0_roadk810b;
        spline0bd[t->roadspline[road] + k8 + 1][0] += spline0_roadk810bd;
        tb64 = t33b / h2_3;
        tb64d = (t33bd - tb64 * h2_3d) * (1.0 / h2_3);
        pb[t->roadadr[road] + t->roadn[road] + k8 + 1] += tb64;
        pbd[t->roadadr[road] + t->roadn[road] + k8 + 1] += tb64d;
        p7b -= tb64;
        p7bd -= tb64d;
        h2_3b -= tb64 * t33;
        h2_3bd -= tb64d * t33 + tb64 * t33d;
        pb[t->roadadr[road] + t->roadn[road] + k8] += p7b;
        pbd[t->roadadr[road] + t->roadn[road] + k8] += p7bd;
        xb += c5b;
        xbd += c5bd;
        p_roadk8b = -c5b;
        p_roadk8bd = -c5bd;
        p_roadk81b = a4b;
        p_roadk81bd = a4bd;
        xb -= a4b;
        xbd -= a4bd;
        p_roadk81b += h2_3b;
        p_roadk81bd += h2_3bd;
        p_roadk8b -= h2_3b;
        p_roadk8bd -= h2_3bd;
        pb[t->roadadr[road] + k8] += p_roadk8b;
        pbd[t->roadadr[road] + k8] += p_roadk8bd;
        pb[t->roadadr[road] + k8 + 1] += p_roadk81b;
        pbd[t->roadadr[road] + k8 + 1] += p_roadk81bd;
      }
    }
    g0b += xb;
    g0bd += xbd;
    t17b = xb * (g2_2 - h00);
    t17bd = xbd * (g2_2 - h00) + xb * (g2_2d - h00d);
    tb35 = xb * t17;
    tb35d = xbd * t17 + xb * t17d;
    g2_2b += tb35;
    g2_2bd += tb35d;
    h00b = -tb35;
    h00bd = -tb35d;
    tb34 = t17b / t16;
    tb34d = (t17bd - tb34 * t16d) * (1.0 / t16);
    u2_2b += tb34 * u0;
    u2_2bd += tb34d * u0 + tb34 * u0d;
    u0b += tb34 * u2_2;
    u0bd += tb34d * u2_2 + tb34 * u2_2d;
    t16b = -(tb34 * t17);
    t16bd = -(tb34d * t17 + tb34 * t17d);
    u0b += t16b * u0;
    u0bd += t16bd * u0 + t16b * u0d;
    u0b += t16b * u0;
    u0bd += t16bd * u0 + t16b * u0d;
    u1b += t16b * u1;
    u1bd += t16bd * u1 + t16b * u1d;
    u1b += t16b * u1;
    u1bd += t16bd * u1 + t16b * u1d;
    x2b = 0.0;
    x2bd = 0.0;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      p_roadd = pd[t->roadadr[road]];
      p_roadb = h00b * x2;
      p_roadbd = h00bd * x2 + h00b * x2d;
      x2b += h00b * p_road;
      x2bd += h00bd * p_road + h00b * p_roadd;
      h00b = 0.0;
      h00bd = 0.0;
      pb[t->roadadr[road]] += p_roadb;
      pbd[t->roadadr[road]] += p_roadbd;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k4 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      k4d = -(k4 * pd[t->roadadr[road] + 1] * (1.0 / p[t->roadadr[road] + 1]));
      t3 = k4 * x2;
      t3d = k4d * x2 + k4 * x2d;
      t4 = sin(t3);
      t4d = cos(t3) * t3d;
      p_road2 = p[t->roadadr[road]];
      p_road2d = pd[t->roadadr[road]];
      p_road2b = h00b * t4;
      p_road2bd = h00bd * t4 + h00b * t4d;
      t4b = h00b * p_road2;
      t4bd = h00bd * p_road2 + h00b * p_road2d;
      h00b = 0.0;
      h00bd = 0.0;
      pb[t->roadadr[road]] += p_road2b;
      pbd[t->roadadr[road]] += p_road2bd;
      t3b = t4b * cos(t3);
      t3bd = t4bd * cos(t3) - t4b * (sin(t3) * t3d);
      k4b = t3b * x2;
      k4bd = t3bd * x2 + t3b * x2d;
      x2b += t3b * k4;
      x2bd += t3bd * k4 + t3b * k4d;
      tb5 = k4b / p[t->roadadr[road] + 1];
      tb5d = (k4bd - tb5 * pd[t->roadadr[road] + 1]) * (1.0 / p[t->roadadr[road] + 1]);
      pb[t->roadadr[road] + 1] -= tb5 * k4;
      pbd[t->roadadr[road] + 1] -= tb5d * k4 + tb5 * k4d;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k3 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x2);
      x3 = x2 - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k3 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      x3d = x2d - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k3 * pd[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius = p[t->roadadr[road]];
      radiusd = pd[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      based = radiusd - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      t5d = radiusd * radius + radius * radiusd - (based * base + base * based);
      c2 = sqrt(t5);
      c2d = 1.0 / (2.0 * c2) * t5d;
      f2 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      f2d = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x3) > 0.0) {
        way = 1.0;
      } else {
        way = -1.0;
      }
      y = way * x3;
      yd = way * x3d;
      b0b = h00b;
      b0bd = h00bd;
      h00b = 0.0;
      h00bd = 0.0;
      baseb = 0.0;
      basebd = 0.0;
      c2b = 0.0;
      c2bd = 0.0;
      f2b = 0.0;
      f2bd = 0.0;
      radiusb = 0.0;
      radiusbd = 0.0;
      yb = 0.0;
      ybd = 0.0;
      if (MAGGI_RE(y) >= MAGGI_RE(c2 + f2)) {
        b0b = 0.0;
        b0bd = 0.0;
      } else if (MAGGI_RE(y) > MAGGI_RE(c2 - f2)) {
        t6 = radius * radius - (c2 - f2) * (c2 - f2);
        t6d = radiusd * radius + radius * radiusd - ((c2d - f2d) * (c2 - f2) + (c2 - f2) * (c2d -
            f2d));
        z2 = sqrt(t6);
        z2d = 1.0 / (2.0 * z2) * t6d;
        h0_2 = z2 - base;
        h0_2d = z2d - based;
        h1_2 = 2.0 * f2 * (c2 - f2) / z2;
        h1_2d = (2.0 * f2d * (c2 - f2) + 2.0 * f2 * (c2d - f2d) - h1_2 * z2d) * (1.0 / z2);
        a = 3.0 * h0_2 - h1_2;
        ad = 3.0 * h0_2d - h1_2d;
        t7 = z2 * z2 * z2;
        t7d = (z2d * z2 + z2 * z2d) * z2 + z2 * z2 * z2d;
        t8 = 2.0 * f2 * f2 * radius * radius / t7;
        t8d = (((2.0 * f2d * f2 + 2.0 * f2 * f2d) * radius + 2.0 * f2 * f2 * radiusd) * radius + 2.0
            * f2 * f2 * radius * radiusd - t8 * t7d) * (1.0 / t7);
        b2 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        b2d = 6.0 * h0_2d - 3.0 * h1_2d - t8d;
        t9 = 2.0 * f2;
        t9d = 2.0 * f2d;
        u2 = (c2 + f2 - y) / t9;
        u2d = (c2d + f2d - yd - u2 * t9d) * (1.0 / t9);
        w2 = 1.0 - u2;
        w2d = -u2d;
        tb15 = b0b * (h0_2 + w2 * (a + w2 * b2));
        tb15d = b0bd * (h0_2 + w2 * (a + w2 * b2)) + b0b * (h0_2d + (w2d * (a + w2 * b2) + w2 * (ad
            + (w2d * b2 + w2 * b2d))));
        tb16 = tb15 * u2;
        tb16d = tb15d * u2 + tb15 * u2d;
        u2b = tb16 * u2;
        u2bd = tb16d * u2 + tb16 * u2d;
        u2b += tb16 * u2;
        u2bd += tb16d * u2 + tb16 * u2d;
        u2b += tb15 * (u2 * u2);
        u2bd += tb15d * (u2 * u2) + tb15 * (u2d * u2 + u2 * u2d);
        tb17 = b0b * (u2 * u2 * u2);
        tb17d = b0bd * (u2 * u2 * u2) + b0b * ((u2d * u2 + u2 * u2d) * u2 + u2 * u2 * u2d);
        h0_2b = tb17;
        h0_2bd = tb17d;
        w2b = tb17 * (a + w2 * b2);
        w2bd = tb17d * (a + w2 * b2) + tb17 * (ad + (w2d * b2 + w2 * b2d));
        tb18 = tb17 * w2;
        tb18d = tb17d * w2 + tb17 * w2d;
        ab = tb18;
        abd = tb18d;
        w2b += tb18 * b2;
        w2bd += tb18d * b2 + tb18 * b2d;
        b2b = tb18 * w2;
        b2bd = tb18d * w2 + tb18 * w2d;
        b0b = 0.0;
        b0bd = 0.0;
        u2b -= w2b;
        u2bd -= w2bd;
        tb14 = u2b / t9;
        tb14d = (u2bd - tb14 * t9d) * (1.0 / t9);
        c2b += tb14;
        c2bd += tb14d;
        f2b += tb14;
        f2bd += tb14d;
        yb -= tb14;
        ybd -= tb14d;
        t9b = -(tb14 * u2);
        t9bd = -(tb14d * u2 + tb14 * u2d);
        f2b += t9b * 2.0;
        f2bd += t9bd * 2.0;
        h0_2b += b2b * 6.0;
        h0_2bd += b2bd * 6.0;
        h1_2b = -(b2b * 3.0);
        h1_2bd = -(b2bd * 3.0);
        t8b = -b2b;
        t8bd = -b2bd;
        tb11 = t8b / t7;
        tb11d = (t8bd - tb11 * t7d) * (1.0 / t7);
        tb12 = tb11 * radius;
        tb12d = tb11d * radius + tb11 * radiusd;
        tb13 = tb12 * radius;
        tb13d = tb12d * radius + tb12 * radiusd;
        f2b += tb13 * f2 * 2.0;
        f2bd += (tb13d * f2 + tb13 * f2d) * 2.0;
        f2b += tb13 * (2.0 * f2);
        f2bd += tb13d * (2.0 * f2) + tb13 * (2.0 * f2d);
        radiusb += tb12 * (2.0 * f2 * f2);
        radiusbd += tb12d * (2.0 * f2 * f2) + tb12 * (2.0 * f2d * f2 + 2.0 * f2 * f2d);
        radiusb += tb11 * (2.0 * f2 * f2 * radius);
        radiusbd += tb11d * (2.0 * f2 * f2 * radius) + tb11 * ((2.0 * f2d * f2 + 2.0 * f2 * f2d) *
            radius + 2.0 * f2 * f2 * radiusd);
        t7b = -(tb11 * t8);
        t7bd = -(tb11d * t8 + tb11 * t8d);
        tb10 = t7b * z2;
        tb10d = t7bd * z2 + t7b * z2d;
        z2b = tb10 * z2;
        z2bd = tb10d * z2 + tb10 * z2d;
        z2b += tb10 * z2;
        z2bd += tb10d * z2 + tb10 * z2d;
        z2b += t7b * (z2 * z2);
        z2bd += t7bd * (z2 * z2) + t7b * (z2d * z2 + z2 * z2d);
        h0_2b += ab * 3.0;
        h0_2bd += abd * 3.0;
        h1_2b -= ab;
        h1_2bd -= abd;
        tb8 = h1_2b / z2;
        tb8d = (h1_2bd - tb8 * z2d) * (1.0 / z2);
        f2b += tb8 * (c2 - f2) * 2.0;
        f2bd += (tb8d * (c2 - f2) + tb8 * (c2d - f2d)) * 2.0;
        tb9 = tb8 * (2.0 * f2);
        tb9d = tb8d * (2.0 * f2) + tb8 * (2.0 * f2d);
        c2b += tb9;
        c2bd += tb9d;
        f2b -= tb9;
        f2bd -= tb9d;
        z2b -= tb8 * h1_2;
        z2bd -= tb8d * h1_2 + tb8 * h1_2d;
        z2b += h0_2b;
        z2bd += h0_2bd;
        baseb -= h0_2b;
        basebd -= h0_2bd;
        t6b = z2b * (1.0 / (2.0 * z2));
        t6bd = z2bd * (1.0 / (2.0 * z2)) - z2b * (1.0 / (2.0 * z2) * (2.0 * z2d) / (2.0 * z2));
        radiusb += t6b * radius;
        radiusbd += t6bd * radius + t6b * radiusd;
        radiusb += t6b * radius;
        radiusbd += t6bd * radius + t6b * radiusd;
        tb6 = t6b * (c2 - f2);
        tb6d = t6bd * (c2 - f2) + t6b * (c2d - f2d);
        c2b -= tb6;
        c2bd -= tb6d;
        f2b += tb6;
        f2bd += tb6d;
        tb7 = t6b * (c2 - f2);
        tb7d = t6bd * (c2 - f2) + t6b * (c2d - f2d);
        c2b -= tb7;
        c2bd -= tb7d;
        f2b += tb7;
        f2bd += tb7d;
      } else {
        t10 = radius * radius - y * y;
        t10d = radiusd * radius + radius * radiusd - (yd * y + y * yd);
        z2_3 = sqrt(t10);
        z2_3d = 1.0 / (2.0 * z2_3) * t10d;
        z2_3b = b0b;
        z2_3bd = b0bd;
        baseb -= b0b;
        basebd -= b0bd;
        b0b = 0.0;
        b0bd = 0.0;
        t10b = z2_3b * (1.0 / (2.0 * z2_3));
        t10bd = z2_3bd * (1.0 / (2.0 * z2_3)) - z2_3b * (1.0 / (2.0 * z2_3) * (2.0 * z2_3d) / (2.0 *
            z2_3));
        radiusb += t10b * radius;
        radiusbd += t10bd * radius + t10b * radiusd;
        radiusb += t10b * radius;
        radiusbd += t10bd * radius + t10b * radiusd;
        yb -= t10b * y;
        ybd -= t10bd * y + t10b * yd;
        yb -= t10b * y;
        ybd -= t10bd * y + t10b * yd;
      }
      x3b = yb * way;
      x3bd = ybd * way;
      pb[t->roadadr[road] + MAGGI_BUMPS_FILLET] += f2b * 0.5;
      pbd[t->roadadr[road] + MAGGI_BUMPS_FILLET] += f2bd * 0.5;
      t5b = c2b * (1.0 / (2.0 * c2));
      t5bd = c2bd * (1.0 / (2.0 * c2)) - c2b * (1.0 / (2.0 * c2) * (2.0 * c2d) / (2.0 * c2));
      radiusb += t5b * radius;
      radiusbd += t5bd * radius + t5b * radiusd;
      radiusb += t5b * radius;
      radiusbd += t5bd * radius + t5b * radiusd;
      baseb -= t5b * base;
      basebd -= t5bd * base + t5b * based;
      baseb -= t5b * base;
      basebd -= t5bd * base + t5b * based;
      radiusb += baseb;
      radiusbd += basebd;
      pb[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= baseb;
      pbd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= basebd;
      pb[t->roadadr[road]] += radiusb;
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      pbd[t->roadadr[road]] += radiusbd;
      x2b += x3b;
      x2bd += x3bd;
      pb[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x3b;
      pbd[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x3bd;
      pb[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x3b * k3;
      pbd[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x3bd * k3;
    } else {
      k5 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x2);
      s20b = h00b;
      s20bd = h00bd;
      h00b = 0.0;
      h00bd = 0.0;
      if (k5 < 0) {
        p_road3 = p[t->roadadr[road]];
        p_road3d = pd[t->roadadr[road]];
        h = p[t->roadadr[road] + 1] - p_road3;
        hd = pd[t->roadadr[road] + 1] - p_road3d;
        p_roadroad = p[t->roadadr[road] + t->roadn[road]];
        p_roadroadd = pd[t->roadadr[road] + t->roadn[road]];
        t11 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad) / h;
        t11d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroadd - t11 * hd) * (1.0 / h);
        slope = t11 - h / 6.0 * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road]
            + 1][0]);
        sloped = t11d - (hd / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]) + h / 6.0 * (2.0 * spline0d[t->roadspline[road]][0]
            + spline0d[t->roadspline[road] + 1][0]));
        p_roadroadb = s20b;
        p_roadroadbd = s20bd;
        slopeb = s20b * (x2 - p_road3);
        slopebd = s20bd * (x2 - p_road3) + s20b * (x2d - p_road3d);
        tb21 = s20b * slope;
        tb21d = s20bd * slope + s20b * sloped;
        x2b += tb21;
        x2bd += tb21d;
        p_road3b = -tb21;
        p_road3bd = -tb21d;
        s20b = 0.0;
        s20bd = 0.0;
        t11b = slopeb;
        t11bd = slopebd;
        hb = -(slopeb * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) / 6.0);
        hbd = -((slopebd * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) + slopeb * (2.0 * spline0d[t->roadspline[road]][0] + spline0d[t->roadspline[road]
            + 1][0])) / 6.0);
        tb20 = slopeb * (h / 6.0);
        tb20d = slopebd * (h / 6.0) + slopeb * (hd / 6.0);
        spline0b[t->roadspline[road]][0] -= tb20 * 2.0;
        spline0bd[t->roadspline[road]][0] -= tb20d * 2.0;
        spline0b[t->roadspline[road] + 1][0] -= tb20;
        spline0bd[t->roadspline[road] + 1][0] -= tb20d;
        tb19 = t11b / h;
        tb19d = (t11bd - tb19 * hd) * (1.0 / h);
        pb[t->roadadr[road] + t->roadn[road] + 1] += tb19;
        pbd[t->roadadr[road] + t->roadn[road] + 1] += tb19d;
        p_roadroadb -= tb19;
        p_roadroadbd -= tb19d;
        hb -= tb19 * t11;
        hbd -= tb19d * t11 + tb19 * t11d;
        pb[t->roadadr[road] + t->roadn[road]] += p_roadroadb;
        pbd[t->roadadr[road] + t->roadn[road]] += p_roadroadbd;
        pb[t->roadadr[road] + 1] += hb;
        pbd[t->roadadr[road] + 1] += hbd;
        p_road3b -= hb;
        p_road3bd -= hbd;
        pb[t->roadadr[road]] += p_road3b;
        pbd[t->roadadr[road]] += p_road3bd;
      } else if (k5 > t->roadn[road] - 2) {
        p2 = p[t->roadadr[road] + t->roadn[road] - 1];
        p2d = pd[t->roadadr[road] + t->roadn[road] - 1];
        h3 = p2 - p[t->roadadr[road] + t->roadn[road] - 2];
        h3d = p2d - pd[t->roadadr[road] + t->roadn[road] - 2];
        p3 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        p3d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t12 = (p3 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h3;
        t12d = (p3d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t12 * h3d) * (1.0
            / h3);
        slope3 = t12 + h3 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        slope3d = t12d + (h3d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h3 / 6.0 *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0]));
        p3b = s20b;
        p3bd = s20bd;
        slope3b = s20b * (x2 - p2);
        slope3bd = s20bd * (x2 - p2) + s20b * (x2d - p2d);
        tb24 = s20b * slope3;
        tb24d = s20bd * slope3 + s20b * slope3d;
        x2b += tb24;
        x2bd += tb24d;
        p2b = -tb24;
        p2bd = -tb24d;
        s20b = 0.0;
        s20bd = 0.0;
        t12b = slope3b;
        t12bd = slope3bd;
        h3b = slope3b * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) / 6.0;
        h3bd = (slope3bd * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + slope3b *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0])) / 6.0;
        tb23 = slope3b * (h3 / 6.0);
        tb23d = slope3bd * (h3 / 6.0) + slope3b * (h3d / 6.0);
        spline0b[t->roadspline[road] + t->roadn[road] - 2][0] += tb23;
        spline0bd[t->roadspline[road] + t->roadn[road] - 2][0] += tb23d;
        spline0b[t->roadspline[road] + t->roadn[road] - 1][0] += tb23 * 2.0;
        spline0bd[t->roadspline[road] + t->roadn[road] - 1][0] += tb23d * 2.0;
        tb22 = t12b / h3;
        tb22d = (t12bd - tb22 * h3d) * (1.0 / h3);
        p3b += tb22;
        p3bd += tb22d;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb22;
        pbd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb22d;
        h3b -= tb22 * t12;
        h3bd -= tb22d * t12 + tb22 * t12d;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p3b;
        pbd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p3bd;
        p2b += h3b;
        p2bd += h3bd;
        pb[t->roadadr[road] + t->roadn[road] - 2] -= h3b;
        pbd[t->roadadr[road] + t->roadn[road] - 2] -= h3bd;
        pb[t->roadadr[road] + t->roadn[road] - 1] += p2b;
        pbd[t->roadadr[road] + t->roadn[road] - 1] += p2bd;
      } else {
        p_roadk51 = p[t->roadadr[road] + k5 + 1];
        p_roadk51d = pd[t->roadadr[road] + k5 + 1];
        p_roadk5 = p[t->roadadr[road] + k5];
        p_roadk5d = pd[t->roadadr[road] + k5];
        h3_2 = p_roadk51 - p_roadk5;
        h3_2d = p_roadk51d - p_roadk5d;
        a2 = p_roadk51 - x2;
        a2d = p_roadk51d - x2d;
        c3 = x2 - p_roadk5;
        c3d = x2d - p_roadk5d;
        p4 = p[t->roadadr[road] + t->roadn[road] + k5];
        p4d = pd[t->roadadr[road] + t->roadn[road] + k5];
        t13 = (p[t->roadadr[road] + t->roadn[road] + k5 + 1] - p4) / h3_2;
        t13d = (pd[t->roadadr[road] + t->roadn[road] + k5 + 1] - p4d - t13 * h3_2d) * (1.0 / h3_2);
        spline0_roadk510 = spline0[t->roadspline[road] + k5 + 1][0];
        spline0_roadk510d = spline0d[t->roadspline[road] + k5 + 1][0];
        spline0_roadk50 = spline0[t->roadspline[road] + k5][0];
        spline0_roadk50d = spline0d[t->roadspline[road] + k5][0];
        e = t13 - h3_2 / 6.0 * (spline0_roadk510 - spline0_roadk50);
        ed = t13d - (h3_2d / 6.0 * (spline0_roadk510 - spline0_roadk50) + h3_2 / 6.0 *
            (spline0_roadk510d - spline0_roadk50d));
        t14 = 6.0 * h3_2;
        t14d = 6.0 * h3_2d;
        t15 = (spline0_roadk50 * a2 * a2 * a2 + spline0_roadk510 * c3 * c3 * c3) / t14;
        t15d = (((spline0_roadk50d * a2 + spline0_roadk50 * a2d) * a2 + spline0_roadk50 * a2 * a2d)
            * a2 + spline0_roadk50 * a2 * a2 * a2d + (((spline0_roadk510d * c3 + spline0_roadk510 *
            c3d) * c3 + spline0_roadk510 * c3 * c3d) * c3 + spline0_roadk510 * c3 * c3 * c3d) - t15
            * t14d) * (1.0 / t14);
        t15b = s20b;
        t15bd = s20bd;
        p4b = s20b;
        p4bd = s20bd;
        tb32 = s20b / 6.0;
        tb32d = s20bd / 6.0;
        tb33 = tb32 * h3_2;
        tb33d = tb32d * h3_2 + tb32 * h3_2d;
        spline0_roadk50b = -(tb33 * h3_2);
        spline0_roadk50bd = -(tb33d * h3_2 + tb33 * h3_2d);
        h3_2b = -(tb33 * spline0_roadk50);
        h3_2bd = -(tb33d * spline0_roadk50 + tb33 * spline0_roadk50d);
        h3_2b -= tb32 * (spline0_roadk50 * h3_2);
        h3_2bd -= tb32d * (spline0_roadk50 * h3_2) + tb32 * (spline0_roadk50d * h3_2 +
            spline0_roadk50 * h3_2d);
        eb = s20b * c3;
        ebd = s20bd * c3 + s20b * c3d;
        c3b = s20b * e;
        c3bd = s20bd * e + s20b * ed;
        s20b = 0.0;
        s20bd = 0.0;
        tb27 = t15b / t14;
        tb27d = (t15bd - tb27 * t14d) * (1.0 / t14);
        tb28 = tb27 * a2;
        tb28d = tb27d * a2 + tb27 * a2d;
        tb29 = tb28 * a2;
        tb29d = tb28d * a2 + tb28 * a2d;
        spline0_roadk50b += tb29 * a2;
        spline0_roadk50bd += tb29d * a2 + tb29 * a2d;
        a2b = tb29 * spline0_roadk50;
        a2bd = tb29d * spline0_roadk50 + tb29 * spline0_roadk50d;
        a2b += tb28 * (spline0_roadk50 * a2);
        a2bd += tb28d * (spline0_roadk50 * a2) + tb28 * (spline0_roadk50d * a2 + spline0_roadk50 *
            a2d);
        a2b += tb27 * (spline0_roadk50 * a2 * a2);
        a2bd += tb27d * (spline0_roadk50 * a2 * a2) + tb27 * ((spline0_roadk50d * a2 +
            spline0_roadk50 * a2d) * a2 + spline0_roadk50 * a2 * a2d);
        tb30 = tb27 * c3;
        tb30d = tb27d * c3 + tb27 * c3d;
        tb31 = tb30 * c3;
        tb31d = tb30d * c3 + tb30 * c3d;
        spline0_roadk510b = tb31 * c3;
        spline0_roadk510bd = tb31d * c3 + tb31 * c3d;
        c3b += tb31 * spline0_roadk510;
        c3bd += tb31d * spline0_roadk510 + tb31 * spline0_roadk510d;
        c3b += tb30 * (spline0_roadk510 * c3);
        c3bd += tb30d * (spline0_roadk510 * c3) + tb30 * (spline0_roadk510d * c3 + spline0_roadk510
            * c3d);
        c3b += tb27 * (spline0_roadk510 * c3 * c3);
        c3bd += tb27d * (spline0_roadk510 * c3 * c3) + tb27 * ((spline0_roadk510d * c3 +
            spline0_roadk510 * c3d) * c3 + spline0_roadk510 * c3 * c3d);
        t14b = -(tb27 * t15);
        t14bd = -(tb27d * t15 + tb27 * t15d);
        h3_2b += t14b * 6.0;
        h3_2bd += t14bd * 6.0;
        t13b = eb;
        t13bd = ebd;
        h3_2b -= eb * (spline0_roadk510 - spline0_roadk50) / 6.0;
        h3_2bd -= (ebd * (spline0_roadk510 - spline0_roadk50) + eb * (spline0_roadk510d -
            spline0_roadk50d)) / 6.0;
        tb26 = eb * (h3_2 / 6.0);
        tb26d = ebd * (h3_2 / 6.0) + eb * (h3_2d / 6.0);
        spline0_roadk510b -= tb26;
        spline0_roadk510bd -= tb26d;
        spline0_roadk50b += tb26;
        spline0_roadk50bd += tb26d;
        spline0b[t->roadspline[road] + k5][0] += spline0_roadk50b;
        spline0bd[t->roadspline[road] + k5][0] += spline0_roadk50bd;
        spline0b[t->roadspline[road] + k5 + 1][0] += spline0_roadk510b;
        spline0bd[t->roadspline[road] + k5 + 1][0] += spline0_roadk510bd;
        tb25 = t13b / h3_2;
        tb25d = (t13bd - tb25 * h3_2d) * (1.0 / h3_2);
        pb[t->roadadr[road] + t->roadn[road] + k5 + 1] += tb25;
        pbd[t->roadadr[road] + t->roadn[road] + k5 + 1] += tb25d;
        p4b -= tb25;
        p4bd -= tb25d;
        h3_2b -= tb25 * t13;
        h3_2bd -= tb25d * t13 + tb25 * t13d;
        pb[t->roadadr[road] + t->roadn[road] + k5] += p4b;
        pbd[t->roadadr[road] + t->roadn[road] + k5] += p4bd;
        x2b += c3b;
        x2bd += c3bd;
        p_roadk5b = -c3b;
        p_roadk5bd = -c3bd;
        p_roadk51b = a2b;
        p_roadk51bd = a2bd;
        x2b -= a2b;
        x2bd -= a2bd;
        p_roadk51b += h3_2b;
        p_roadk51bd += h3_2bd;
        p_roadk5b -= h3_2b;
        p_roadk5bd -= h3_2bd;
        pb[t->roadadr[road] + k5] += p_roadk5b;
        pbd[t->roadadr[road] + k5] += p_roadk5bd;
        pb[t->roadadr[road] + k5 + 1] += p_roadk51b;
        pbd[t->roadadr[road] + k5 + 1] += p_roadk51bd;
      }
    }
    g0b += x2b;
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n|, slope that the plane lacks */
    g0bd += x2bd;
    rb[t->wheelpoint[i]][2] += g2_2b;
    rbd[t->wheelpoint[i]][2] += g2_2bd;
    rb[t->roadpoint[road]][2] -= g2_2b;
    rbd[t->roadpoint[road]][2] -= g2_2bd;
    rb[t->wheelpoint[i]][0] += g0b;
    rbd[t->wheelpoint[i]][0] += g0bd;
    rb[t->roadpoint[road]][0] -= g0b;
    rbd[t->roadpoint[road]][0] -= g0bd;
    tb4 = u2_2b / n2;
    tb4d = (u2_2bd - tb4 * n2d) * (1.0 / n2);
    ua2b = tb4;
    ua2bd = tb4d;
    n2b = -(tb4 * u2_2);
    n2bd = -(tb4d * u2_2 + tb4 * u2_2d);
    tb3 = u1b / n2;
    tb3d = (u1bd - tb3 * n2d) * (1.0 / n2);
    ua1b = tb3;
    ua1bd = tb3d;
    n2b -= tb3 * u1;
    n2bd -= tb3d * u1 + tb3 * u1d;
    tb2 = u0b / n2;
    tb2d = (u0bd - tb2 * n2d) * (1.0 / n2);
    ua0b = tb2;
    ua0bd = tb2d;
    n2b -= tb2 * u0;
    n2bd -= tb2d * u0 + tb2 * u0d;
    t2b = n2b * (1.0 / (2.0 * n2));
    t2bd = n2bd * (1.0 / (2.0 * n2)) - n2b * (1.0 / (2.0 * n2) * (2.0 * n2d) / (2.0 * n2));
    ua0b += t2b * ua0;
    ua0bd += t2bd * ua0 + t2b * ua0d;
    ua0b += t2b * ua0;
    ua0bd += t2bd * ua0 + t2b * ua0d;
    ua1b += t2b * ua1;
    ua1bd += t2bd * ua1 + t2b * ua1d;
    ua1b += t2b * ua1;
    ua1bd += t2bd * ua1 + t2b * ua1d;
    ua2b += t2b * ua2;
    ua2bd += t2bd * ua2 + t2b * ua2d;
    ua2b += t2b * ua2;
    ua2bd += t2bd * ua2 + t2b * ua2d;
    Ab[t->wheelbody[i]][6] += ua2b * axis0;
    Abd[t->wheelbody[i]][6] += ua2bd * axis0 + ua2b * axis0d;
    axis0b = ua2b * A[t->wheelbody[i]][6];
    axis0bd = ua2bd * A[t->wheelbody[i]][6] + ua2b * Ad[t->wheelbody[i]][6];
    Ab[t->wheelbody[i]][7] += ua2b * axis1;
    Abd[t->wheelbody[i]][7] += ua2bd * axis1 + ua2b * axis1d;
    axis1b = ua2b * A[t->wheelbody[i]][7];
    axis1bd = ua2bd * A[t->wheelbody[i]][7] + ua2b * Ad[t->wheelbody[i]][7];
    Ab[t->wheelbody[i]][8] += ua2b * axis2;
    Abd[t->wheelbody[i]][8] += ua2bd * axis2 + ua2b * axis2d;
    axis2b = ua2b * A[t->wheelbody[i]][8];
    axis2bd = ua2bd * A[t->wheelbody[i]][8] + ua2b * Ad[t->wheelbody[i]][8];
    Ab[t->wheelbody[i]][3] += ua1b * axis0;
    Abd[t->wheelbody[i]][3] += ua1bd * axis0 + ua1b * axis0d;
    axis0b += ua1b * A[t->wheelbody[i]][3];
    axis0bd += ua1bd * A[t->wheelbody[i]][3] + ua1b * Ad[t->wheelbody[i]][3];
    Ab[t->wheelbody[i]][4] += ua1b * axis1;
    Abd[t->wheelbody[i]][4] += ua1bd * axis1 + ua1b * axis1d;
    axis1b += ua1b * A[t->wheelbody[i]][4];
    axis1bd += ua1bd * A[t->wheelbody[i]][4] + ua1b * Ad[t->wheelbody[i]][4];
    Ab[t->wheelbody[i]][5] += ua1b * axis2;
    Abd[t->wheelbody[i]][5] += ua1bd * axis2 + ua1b * axis2d;
    axis2b += ua1b * A[t->wheelbody[i]][5];
    axis2bd += ua1bd * A[t->wheelbody[i]][5] + ua1b * Ad[t->wheelbody[i]][5];
    Ab[t->wheelbody[i]][0] += ua0b * axis0;
    Abd[t->wheelbody[i]][0] += ua0bd * axis0 + ua0b * axis0d;
    axis0b += ua0b * A[t->wheelbody[i]][0];
    axis0bd += ua0bd * A[t->wheelbody[i]][0] + ua0b * Ad[t->wheelbody[i]][0];
    Ab[t->wheelbody[i]][1] += ua0b * axis1;
    Abd[t->wheelbody[i]][1] += ua0bd * axis1 + ua0b * axis1d;
    axis1b += ua0b * A[t->wheelbody[i]][1];
    axis1bd += ua0bd * A[t->wheelbody[i]][1] + ua0b * Ad[t->wheelbody[i]][1];
    Ab[t->wheelbody[i]][2] += ua0b * axis2;
    Abd[t->wheelbody[i]][2] += ua0bd * axis2 + ua0b * axis2d;
    axis2b += ua0b * A[t->wheelbody[i]][2];
    axis2bd += ua0bd * A[t->wheelbody[i]][2] + ua0b * Ad[t->wheelbody[i]][2];
    pb[t->wheelaxis[i] + 2] += axis2b;
    pbd[t->wheelaxis[i] + 2] += axis2bd;
    pb[t->wheelaxis[i] + 1] += axis1b;
    pbd[t->wheelaxis[i] + 1] += axis1bd;
    pb[t->wheelaxis[i]] += axis0b;
    pbd[t->wheelaxis[i]] += axis0bd;
  }
}

/* Rates of the coordinates on which wheels turn at which they roll freely, kappa = 0: with w that of the
 * carrier and w_q that of the wheel on it at the rate 1
 *   v = (V.t / Re - w.u) / (w_q.u) */
void maggi_rolling_b_d(const maggi_topo *t, const double p[restrict t->np],
                       const double pd[restrict t->np], double pb[restrict t->np],
                       double pbd[restrict t->np], const double spline0[restrict t->nspline][3],
                       const double spline0d[restrict t->nspline][3],
                       double spline0b[restrict t->nspline][3],
                       double spline0bd[restrict t->nspline][3],
                       const double A[restrict t->nbody + 1][9],
                       const double Ad[restrict t->nbody + 1][9],
                       double Ab[restrict t->nbody + 1][9], double Abd[restrict t->nbody + 1][9],
                       const double b[restrict t->nbody][6], const double bd[restrict t->nbody][6],
                       double bb[restrict t->nbody][6], double bbd[restrict t->nbody][6],
                       const double r[restrict t->npoint][3],
                       const double rd[restrict t->npoint][3], double rb[restrict t->npoint][3],
                       double rbd[restrict t->npoint][3], const double Z[restrict t->nbody + 1][6],
                       const double Zd[restrict t->nbody + 1][6],
                       double Zb[restrict t->nbody + 1][6], double Zbd[restrict t->nbody + 1][6],
                       double spin[restrict t->nwheel], double spind[restrict t->nwheel],
                       double spinb[restrict t->nwheel], double spinbd[restrict t->nwheel])
{
  int adr, body, carrier, i, k4, k6, k7, k9, road;
  double N0, N0b, N0bd, N0d, N1, N2, N2b, N2bd, N2d, T0, T0b, T0bd, T0d, T1, T1b, T1bd, T1d, T2,
      T2b, T2bd, T2d, a, a2, a2b, a2bd, a2d, a3, a3b, a3bd, a3d, a4, a4b, a4bd, a4d, ab, abd, ad,
      along0, along0b, along0bd, along0d, along1, along1b, along1bd, along1d, along2, along2b,
      along2bd, along2d, arm0, arm0b, arm0bd, arm0d, arm1, arm1b, arm1bd, arm1d, arm2, arm2b,
      arm2bd, arm2d, axis0, axis0b, axis0bd, axis0d, axis1, axis1b, axis1bd, axis1d, axis2, axis2b,
      axis2bd, axis2d, b20, b20b, b20bd, b20d, b3, b3b, b3bd, b3d, b40, b40b, b40bd, b40d, b41,
      b41b, b41bd, b41d, b5, b5b, b5bd, b5d, base, base2, base2b, base2bd, base2d, baseb, basebd,
      based, c, c2, c2b, c2bd, c2d, c3, c3b, c3bd, c3d, c4, c4b, c4bd, c4d, c5, c5b, c5bd, c5d, cb,
      cbd, cd, e, e2, e2b, e2bd, e2d, eb, ebd, ed, f, f2, f2b, f2bd, f2d, fb, fbd, fd, fz, fz0,
      fz0b, fz0bd, fz0d, fzb, fzbd, fzd, g0, g0b, g0bd, g0d, g2, g2b, g2bd, g2d, h, h00, h00b,
      h00bd, h00d, h0_2, h0_2b, h0_2bd, h0_2d, h0_3, h0_3b, h0_3bd, h0_3d, h10, h10b, h10bd, h10d,
      h11, h11b, h11bd, h11d, h12, h12b, h12bd, h12d, h1_2, h1_2b, h1_2bd, h1_2d, h1_3, h1_3b,
      h1_3bd, h1_3d, h2, h2_2, h2_2b, h2_2bd, h2_2d, h2_3, h2_3b, h2_3bd, h2_3d, h2b, h2bd, h2d, h3,
      h3_2, h3_2b, h3_2bd, h3_2d, h3b, h3bd, h3d, hb, hbd, hd, k5, k5b, k5bd, k5d, k8, k8b, k8bd,
      k8d, n2, n2b, n2bd, n2d, normal0, normal0b, normal0bd, normal0d, normal1, normal2, normal2b,
      normal2bd, normal2d, p2, p2b, p2bd, p2d, p3, p3b, p3bd, p3d, p4, p4b, p4bd, p4d, p5, p5b,
      p5bd, p5d, p6, p6b, p6bd, p6d, p7, p7b, p7bd, p7d, p_road, p_road2, p_road2b, p_road2bd,
      p_road2d, p_road3, p_road3b, p_road3bd, p_road3d, p_road4, p_road4b, p_road4bd, p_road4d,
      p_road5, p_road5b, p_road5bd, p_road5d, p_road6, p_road6b, p_road6bd, p_road6d, p_roadb,
      p_roadbd, p_roadd, p_roadk6, p_roadk61, p_roadk61b, p_roadk61bd, p_roadk61d, p_roadk6b,
      p_roadk6bd, p_roadk6d, p_roadk9, p_roadk91, p_roadk91b, p_roadk91bd, p_roadk91d, p_roadk9b,
      p_roadk9bd, p_roadk9d, p_roadroad, p_roadroad2, p_roadroad2b, p_roadroad2bd, p_roadroad2d,
      p_roadroadb, p_roadroadbd, p_roadroadd, r2, r2b, r2bd, r2d, r_i0, r_i0b, r_i0bd, r_i0d, r_i1,
      r_i1b, r_i1bd, r_i1d, r_i2, r_i2b, r_i2bd, r_i2d, radius, radius2, radius2b, radius2bd,
      radius2d, radiusb, radiusbd, radiusd, ratio, ratiob, ratiobd, ratiod, re, re2, re2b, re2bd,
      re2d, reb, rebd, red, rhov, rhovb, rhovbd, rhovd, s, s20, s20b, s20bd, s20d, s30, s30b, s30bd,
      s30d, s31, s31b, s31bd, s31d, sb, sbd, sd, slope, slope2, slope2_2, slope2_2b, slope2_2bd,
      slope2_2d, slope2b, slope2bd, slope2d, slope3, slope3b, slope3bd, slope3d, slopeb, slopebd,
      sloped, spline0_roadk60, spline0_roadk60b, spline0_roadk60bd, spline0_roadk60d,
      spline0_roadk610, spline0_roadk610b, spline0_roadk610bd, spline0_roadk610d, spline0_roadk90,
      spline0_roadk90b, spline0_roadk90bd, spline0_roadk90d, spline0_roadk910, spline0_roadk910b,
      spline0_roadk910bd, spline0_roadk910d, t10, t10b, t10bd, t10d, t11, t11b, t11bd, t11d, t12,
      t12b, t12bd, t12d, t13, t13b, t13bd, t13d, t14, t14b, t14bd, t14d, t15, t15b, t15bd, t15d,
      t16, t16b, t16bd, t16d, t17, t17b, t17bd, t17d, t18, t18b, t18bd, t18d, t19, t19b, t19bd,
      t19d, t2, t20, t20b, t20bd, t20d, t21, t21b, t21bd, t21d, t22, t22b, t22bd, t22d, t23, t23b,
      t23bd, t23d, t24, t24b, t24bd, t24d, t25, t25b, t25bd, t25d, t26, t26b, t26bd, t26d, t27,
      t27b, t27bd, t27d, t28, t28b, t28bd, t28d, t29, t29b, t29bd, t29d, t2b, t2bd, t2d, t3, t30,
      t30b, t30bd, t30d, t31, t31b, t31bd, t31d, t32, t32b, t32bd, t32d, t33, t33b, t33bd, t33d,
      t34, t34b, t34bd, t34d, t35, t35b, t35bd, t35d, t36, t36b, t36bd, t36d, t37, t37b, t37bd,
      t37d, t38, t38b, t38bd, t38d, t39, t39b, t39bd, t39d, t3b, t3bd, t3d, t4, t40, t40b, t40bd,
      t40d, t41, t41b, t41bd, t41d, t42, t42b, t42bd, t42d, t43, t43b, t43bd, t43d, t44, t44b,
      t44bd, t44d, t4b, t4bd, t4d, t5, t5b, t5bd, t5d, t6, t6b, t6bd, t6d, t7, t7b, t7bd, t7d, t8,
      t8b, t8bd, t8d, t9, t9b, t9bd, t9d, tb10, tb10d, tb11, tb11d, tb12, tb12d, tb13, tb13d, tb14,
      tb14d, tb15, tb15d, tb16, tb16d, tb17, tb17d, tb18, tb18d, tb19, tb19d, tb2, tb20, tb20d,
      tb21, tb21d, tb22, tb22d, tb23, tb23d, tb24, tb24d, tb25, tb25d, tb26, tb26d, tb27, tb27d,
      tb28, tb28d, tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31, tb31d, tb32, tb32d, tb33, tb33d, tb34,
      tb34d, tb35, tb35d, tb36, tb36d, tb37, tb37d, tb38, tb38d, tb39, tb39d, tb3d, tb4, tb40,
      tb40d, tb41, tb41d, tb42, tb42d, tb43, tb43d, tb44, tb44d, tb45, tb45d, tb46, tb46d, tb47,
      tb47d, tb48, tb48d, tb49, tb49d, tb4d, tb5, tb50, tb50d, tb51, tb51d, tb52, tb52d, tb53,
      tb53d, tb54, tb54d, tb55, tb55d, tb56, tb56d, tb57, tb57d, tb58, tb58d, tb59, tb59d, tb5d,
      tb6, tb60, tb60d, tb61, tb61d, tb62, tb62d, tb63, tb63d, tb64, tb64d, tb65, tb65d, tb66,
      tb66d, tb67, tb67d, tb68, tb68d, tb69, tb69d, tb6d, tb7, tb70, tb70d, tb71, tb71d, tb72,
      tb72d, tb73, tb73d, tb74, tb74d, tb75, tb75d, tb76, tb76d, tb77, tb77d, tb78, tb78d, tb79,
      tb79d, tb7d, tb8, tb80, tb80d, tb81, tb81d, tb82, tb82d, tb83, tb83d, tb84, tb84d, tb85,
      tb85d, tb86, tb86d, tb87, tb87d, tb88, tb88d, tb89, tb89d, tb8d, tb9, tb90, tb90d, tb91,
      tb91d, tb92, tb92d, tb93, tb93d, tb94, tb94d, tb95, tb95d, tb96, tb96d, tb97, tb97d, tb9d,
      turn, turnb, turnbd, turnd, u0, u0b, u0bd, u0d, u1, u1b, u1bd, u1d, u2, u2_2, u2_2b, u2_2bd,
      u2_2d, u2b, u2bd, u2d, u3, u3b, u3bd, u3d, ua0, ua0b, ua0bd, ua0d, ua1, ua1b, ua1bd, ua1d,
      ua2, ua2b, ua2bd, ua2d, un0, un0b, un0bd, un0d, un1, un1b, un1bd, un1d, un2, un2b, un2bd,
      un2d, v0, v0b, v0bd, v0d, v1, v1b, v1bd, v1d, v2, v2b, v2bd, v2d, vc0, vc0b, vc0bd, vc0d, vc1,
      vc1b, vc1bd, vc1d, vc2, vc2b, vc2bd, vc2d, vr0, vr0b, vr0bd, vr0d, vr1, vr1b, vr1bd, vr1d,
      vr2, vr2b, vr2bd, vr2d, w0, w0b, w0bd, w0d, w1, w1b, w1bd, w1d, w2, w2_2, w2_2b, w2_2bd,
      w2_2d, w2b, w2bd, w2d, w3, w3b, w3bd, w3d, w4, w4b, w4bd, w4d, way, way2, wr0, wr0b, wr0bd,
      wr0d, wr1, wr1b, wr1bd, wr1d, wr2, wr2b, wr2bd, wr2d, x, x2, x2b, x2bd, x2d, x3, x3b, x3bd,
      x3d, x4, x4b, x4bd, x4d, xb, xbd, xd, y, y2, y2b, y2bd, y2d, yb, ybd, yd, z0, z0b, z0bd, z0d,
      z2, z2_2, z2_2b, z2_2bd, z2_2d, z2_3, z2_3b, z2_3bd, z2_3d, z2b, z2bd, z2d, z3, z3_2, z3_2b,
      z3_2bd, z3_2d, z3_3, z3_3b, z3_3bd, z3_3d, z3b, z3bd, z3d;

  for (i = t->nwheel - 1; i >= 0; --i) {
    adr = t->tyreadr[t->wheeltyre[i]];
    body = t->wheelbody[i];
    carrier = t->wheelcarrier[i];
    road = t->wheelroad[i];
    axis0 = p[t->wheelaxis[i]];
    axis0d = pd[t->wheelaxis[i]];
    axis1 = p[t->wheelaxis[i] + 1];
    axis1d = pd[t->wheelaxis[i] + 1];
    axis2 = p[t->wheelaxis[i] + 2];
    axis2d = pd[t->wheelaxis[i] + 2];
    ua0 = A[t->wheelbody[i]][0] * axis0 + A[t->wheelbody[i]][1] * axis1 + A[t->wheelbody[i]][2] *
        axis2;
    ua0d = Ad[t->wheelbody[i]][0] * axis0 + A[t->wheelbody[i]][0] * axis0d + (Ad[t->wheelbody[i]][1]
        * axis1 + A[t->wheelbody[i]][1] * axis1d) + (Ad[t->wheelbody[i]][2] * axis2 +
        A[t->wheelbody[i]][2] * axis2d);
    ua1 = A[t->wheelbody[i]][3] * axis0 + A[t->wheelbody[i]][4] * axis1 + A[t->wheelbody[i]][5] *
        axis2;
    ua1d = Ad[t->wheelbody[i]][3] * axis0 + A[t->wheelbody[i]][3] * axis0d + (Ad[t->wheelbody[i]][4]
        * axis1 + A[t->wheelbody[i]][4] * axis1d) + (Ad[t->wheelbody[i]][5] * axis2 +
        A[t->wheelbody[i]][5] * axis2d);
    ua2 = A[t->wheelbody[i]][6] * axis0 + A[t->wheelbody[i]][7] * axis1 + A[t->wheelbody[i]][8] *
        axis2;
    ua2d = Ad[t->wheelbody[i]][6] * axis0 + A[t->wheelbody[i]][6] * axis0d + (Ad[t->wheelbody[i]][7]
        * axis1 + A[t->wheelbody[i]][7] * axis1d) + (Ad[t->wheelbody[i]][8] * axis2 +
        A[t->wheelbody[i]][8] * axis2d);
    t2 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
    t2d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
    n2 = sqrt(t2);
    n2d = 1.0 / (2.0 * n2) * t2d;
    u0 = ua0 / n2;
    u0d = (ua0d - u0 * n2d) * (1.0 / n2);
    u1 = ua1 / n2;
    u1d = (ua1d - u1 * n2d) * (1.0 / n2);
    u2_2 = ua2 / n2;
    u2_2d = (ua2d - u2_2 * n2d) * (1.0 / n2);
    g0 = r[t->wheelpoint[i]][0] - r[t->roadpoint[road]][0];
    g0d = rd[t->wheelpoint[i]][0] - rd[t->roadpoint[road]][0];
    g2 = r[t->wheelpoint[i]][2] - r[t->roadpoint[road]][2];
    g2d = rd[t->wheelpoint[i]][2] - rd[t->roadpoint[road]][2];
    x2 = g0;
    x2d = g0d;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      p_roadd = pd[t->roadadr[road]];
      h00 = p_road * x2;
      h00d = p_roadd * x2 + p_road * x2d;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k5 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      k5d = -(k5 * pd[t->roadadr[road] + 1] * (1.0 / p[t->roadadr[road] + 1]));
      t3 = k5 * x2;
      t3d = k5d * x2 + k5 * x2d;
      t4 = sin(t3);
      t4d = cos(t3) * t3d;
      p_road2 = p[t->roadadr[road]];
      p_road2d = pd[t->roadadr[road]];
      h00 = p_road2 * t4;
      h00d = p_road2d * t4 + p_road2 * t4d;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k4 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x2);
      x3 = x2 - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k4 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      x3d = x2d - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k4 * pd[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius = p[t->roadadr[road]];
      radiusd = pd[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      based = radiusd - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      t5d = radiusd * radius + radius * radiusd - (based * base + base * based);
      c2 = sqrt(t5);
      c2d = 1.0 / (2.0 * c2) * t5d;
      f = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      fd = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x3) > 0.0) {
        way = 1.0;
      } else {
        way = -1.0;
      }
      y = way * x3;
      yd = way * x3d;
      if (MAGGI_RE(y) >= MAGGI_RE(c2 + f)) {
        b20 = 0.0;
        b20d = 0.0;
      } else if (MAGGI_RE(y) > MAGGI_RE(c2 - f)) {
        t6 = radius * radius - (c2 - f) * (c2 - f);
        t6d = radiusd * radius + radius * radiusd - ((c2d - fd) * (c2 - f) + (c2 - f) * (c2d - fd));
        z2 = sqrt(t6);
        z2d = 1.0 / (2.0 * z2) * t6d;
        h0_2 = z2 - base;
        h0_2d = z2d - based;
        h1_2 = 2.0 * f * (c2 - f) / z2;
        h1_2d = (2.0 * fd * (c2 - f) + 2.0 * f * (c2d - fd) - h1_2 * z2d) * (1.0 / z2);
        a = 3.0 * h0_2 - h1_2;
        ad = 3.0 * h0_2d - h1_2d;
        t7 = z2 * z2 * z2;
        t7d = (z2d * z2 + z2 * z2d) * z2 + z2 * z2 * z2d;
        t8 = 2.0 * f * f * radius * radius / t7;
        t8d = (((2.0 * fd * f + 2.0 * f * fd) * radius + 2.0 * f * f * radiusd) * radius + 2.0 * f *
            f * radius * radiusd - t8 * t7d) * (1.0 / t7);
        b3 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        b3d = 6.0 * h0_2d - 3.0 * h1_2d - t8d;
        t9 = 2.0 * f;
        t9d = 2.0 * fd;
        u2 = (c2 + f - y) / t9;
        u2d = (c2d + fd - yd - u2 * t9d) * (1.0 / t9);
        w3 = 1.0 - u2;
        w3d = -u2d;
        b20 = u2 * u2 * u2 * (h0_2 + w3 * (a + w3 * b3));
        b20d = ((u2d * u2 + u2 * u2d) * u2 + u2 * u2 * u2d) * (h0_2 + w3 * (a + w3 * b3)) + u2 * u2
            * u2 * (h0_2d + (w3d * (a + w3 * b3) + w3 * (ad + (w3d * b3 + w3 * b3d))));
      } else {
        t10 = radius * radius - y * y;
        t10d = radiusd * radius + radius * radiusd - (yd * y + y * yd);
        z2_3 = sqrt(t10);
        z2_3d = 1.0 / (2.0 * z2_3) * t10d;
        b20 = z2_3 - base;
        b20d = z2_3d - based;
      }
      h00 = b20;
      h00d = b20d;
    } else {
      k6 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x2);
      if (k6 < 0) {
        p_road3 = p[t->roadadr[road]];
        p_road3d = pd[t->roadadr[road]];
        h = p[t->roadadr[road] + 1] - p_road3;
        hd = pd[t->roadadr[road] + 1] - p_road3d;
        p_roadroad = p[t->roadadr[road] + t->roadn[road]];
        p_roadroadd = pd[t->roadadr[road] + t->roadn[road]];
        t11 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad) / h;
        t11d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroadd - t11 * hd) * (1.0 / h);
        slope = t11 - h / 6.0 * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road]
            + 1][0]);
        sloped = t11d - (hd / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]) + h / 6.0 * (2.0 * spline0d[t->roadspline[road]][0]
            + spline0d[t->roadspline[road] + 1][0]));
        s20 = p_roadroad + slope * (x2 - p_road3);
        s20d = p_roadroadd + (sloped * (x2 - p_road3) + slope * (x2d - p_road3d));
      } else if (k6 > t->roadn[road] - 2) {
        p2 = p[t->roadadr[road] + t->roadn[road] - 1];
        p2d = pd[t->roadadr[road] + t->roadn[road] - 1];
        h3 = p2 - p[t->roadadr[road] + t->roadn[road] - 2];
        h3d = p2d - pd[t->roadadr[road] + t->roadn[road] - 2];
        p3 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        p3d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t12 = (p3 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h3;
        t12d = (p3d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t12 * h3d) * (1.0
            / h3);
        slope3 = t12 + h3 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        slope3d = t12d + (h3d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h3 / 6.0 *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0]));
        s20 = p3 + slope3 * (x2 - p2);
        s20d = p3d + (slope3d * (x2 - p2) + slope3 * (x2d - p2d));
      } else {
        p_roadk61 = p[t->roadadr[road] + k6 + 1];
        p_roadk61d = pd[t->roadadr[road] + k6 + 1];
        p_roadk6 = p[t->roadadr[road] + k6];
        p_roadk6d = pd[t->roadadr[road] + k6];
        h3_2 = p_roadk61 - p_roadk6;
        h3_2d = p_roadk61d - p_roadk6d;
        a2 = p_roadk61 - x2;
        a2d = p_roadk61d - x2d;
        c3 = x2 - p_roadk6;
        c3d = x2d - p_roadk6d;
        p4 = p[t->roadadr[road] + t->roadn[road] + k6];
        p4d = pd[t->roadadr[road] + t->roadn[road] + k6];
        t13 = (p[t->roadadr[road] + t->roadn[road] + k6 + 1] - p4) / h3_2;
        t13d = (pd[t->roadadr[road] + t->roadn[road] + k6 + 1] - p4d - t13 * h3_2d) * (1.0 / h3_2);
        spline0_roadk610 = spline0[t->roadspline[road] + k6 + 1][0];
        spline0_roadk610d = spline0d[t->roadspline[road] + k6 + 1][0];
        spline0_roadk60 = spline0[t->roadspline[road] + k6][0];
        spline0_roadk60d = spline0d[t->roadspline[road] + k6][0];
        e = t13 - h3_2 / 6.0 * (spline0_roadk610 - spline0_roadk60);
        ed = t13d - (h3_2d / 6.0 * (spline0_roadk610 - spline0_roadk60) + h3_2 / 6.0 *
            (spline0_roadk610d - spline0_roadk60d));
        t14 = 6.0 * h3_2;
        t14d = 6.0 * h3_2d;
        t15 = (spline0_roadk60 * a2 * a2 * a2 + spline0_roadk610 * c3 * c3 * c3) / t14;
        t15d = (((spline0_roadk60d * a2 + spline0_roadk60 * a2d) * a2 + spline0_roadk60 * a2 * a2d)
            * a2 + spline0_roadk60 * a2 * a2 * a2d + (((spline0_roadk610d * c3 + spline0_roadk610 *
            c3d) * c3 + spline0_roadk610 * c3 * c3d) * c3 + spline0_roadk610 * c3 * c3 * c3d) - t15
            * t14d) * (1.0 / t14);
        s20 = t15 + p4 - spline0_roadk60 * h3_2 * h3_2 / 6.0 + e * c3;
        s20d = t15d + p4d - ((spline0_roadk60d * h3_2 + spline0_roadk60 * h3_2d) * h3_2 +
            spline0_roadk60 * h3_2 * h3_2d) / 6.0 + (ed * c3 + e * c3d);
      }
      h00 = s20;
      h00d = s20d;
    }
    t16 = u0 * u0 + u1 * u1;
    t16d = u0d * u0 + u0 * u0d + (u1d * u1 + u1 * u1d);
    t17 = u2_2 * u0 / t16;
    t17d = (u2_2d * u0 + u2_2 * u0d - t17 * t16d) * (1.0 / t16);
    x = g0 + t17 * (g2 - h00);
    xd = g0d + (t17d * (g2 - h00) + t17 * (g2d - h00d));
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road4 = p[t->roadadr[road]];
      p_road4d = pd[t->roadadr[road]];
      h10 = p_road4 * x;
      h10d = p_road4d * x + p_road4 * xd;
      h11 = p_road4;
      h11d = p_road4d;
      h12 = 0.0;
      h12d = 0.0;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k8 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      k8d = -(k8 * pd[t->roadadr[road] + 1] * (1.0 / p[t->roadadr[road] + 1]));
      t18 = k8 * x;
      t18d = k8d * x + k8 * xd;
      t19 = sin(t18);
      t19d = cos(t18) * t18d;
      p_road5 = p[t->roadadr[road]];
      p_road5d = pd[t->roadadr[road]];
      h10 = p_road5 * t19;
      h10d = p_road5d * t19 + p_road5 * t19d;
      t20 = k8 * x;
      t20d = k8d * x + k8 * xd;
      t21 = cos(t20);
      t21d = -(sin(t20) * t20d);
      h11 = k8 * p_road5 * t21;
      h11d = (k8d * p_road5 + k8 * p_road5d) * t21 + k8 * p_road5 * t21d;
      h12 = 0.0;
      h12d = 0.0;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k7 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x);
      x4 = x - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k7 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      x4d = xd - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k7 * pd[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius2 = p[t->roadadr[road]];
      radius2d = pd[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      base2d = radius2d - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      t22d = radius2d * radius2 + radius2 * radius2d - (base2d * base2 + base2 * base2d);
      c4 = sqrt(t22);
      c4d = 1.0 / (2.0 * c4) * t22d;
      f2 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      f2d = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x4) > 0.0) {
        way2 = 1.0;
      } else {
        way2 = -1.0;
      }
      y2 = way2 * x4;
      y2d = way2 * x4d;
      if (MAGGI_RE(y2) >= MAGGI_RE(c4 + f2)) {
        b40 = 0.0;
        b40d = 0.0;
        b41 = 0.0;
        b41d = 0.0;
      } else if (MAGGI_RE(y2) > MAGGI_RE(c4 - f2)) {
        t23 = radius2 * radius2 - (c4 - f2) * (c4 - f2);
        t23d = radius2d * radius2 + radius2 * radius2d - ((c4d - f2d) * (c4 - f2) + (c4 - f2) * (c4d
            - f2d));
        z3 = sqrt(t23);
        z3d = 1.0 / (2.0 * z3) * t23d;
        h0_3 = z3 - base2;
        h0_3d = z3d - base2d;
        h1_3 = 2.0 * f2 * (c4 - f2) / z3;
        h1_3d = (2.0 * f2d * (c4 - f2) + 2.0 * f2 * (c4d - f2d) - h1_3 * z3d) * (1.0 / z3);
        a3 = 3.0 * h0_3 - h1_3;
        a3d = 3.0 * h0_3d - h1_3d;
        t24 = z3 * z3 * z3;
        t24d = (z3d * z3 + z3 * z3d) * z3 + z3 * z3 * z3d;
        t25 = 2.0 * f2 * f2 * radius2 * radius2 / t24;
        t25d = (((2.0 * f2d * f2 + 2.0 * f2 * f2d) * radius2 + 2.0 * f2 * f2 * radius2d) * radius2 +
            2.0 * f2 * f2 * radius2 * radius2d - t25 * t24d) * (1.0 / t24);
        b5 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        b5d = 6.0 * h0_3d - 3.0 * h1_3d - t25d;
        t26 = 2.0 * f2;
        t26d = 2.0 * f2d;
        u3 = (c4 + f2 - y2) / t26;
        u3d = (c4d + f2d - y2d - u3 * t26d) * (1.0 / t26);
        w4 = 1.0 - u3;
        w4d = -u3d;
        b40 = u3 * u3 * u3 * (h0_3 + w4 * (a3 + w4 * b5));
        b40d = ((u3d * u3 + u3 * u3d) * u3 + u3 * u3 * u3d) * (h0_3 + w4 * (a3 + w4 * b5)) + u3 * u3
            * u3 * (h0_3d + (w4d * (a3 + w4 * b5) + w4 * (a3d + (w4d * b5 + w4 * b5d))));
        t27 = 2.0 * f2;
        t27d = 2.0 * f2d;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 * (a3 + 2.0 * w4 * b5)) /
            t27;
        t28d = ((-(way2 * u3d * u3) + -way2 * u3 * u3d) * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 *
            (a3 + 2.0 * w4 * b5)) + -way2 * u3 * u3 * (3.0 * (h0_3d + (w4d * (a3 + w4 * b5) + w4 *
            (a3d + (w4d * b5 + w4 * b5d)))) - (u3d * (a3 + 2.0 * w4 * b5) + u3 * (a3d + (2.0 * w4d *
            b5 + 2.0 * w4 * b5d)))) - t28 * t27d) * (1.0 / t27);
        b41 = t28;
        b41d = t28d;
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        t29d = radius2d * radius2 + radius2 * radius2d - (y2d * y2 + y2 * y2d);
        z3_3 = sqrt(t29);
        z3_3d = 1.0 / (2.0 * z3_3) * t29d;
        b40 = z3_3 - base2;
        b40d = z3_3d - base2d;
        t30 = -x4 / z3_3;
        t30d = (-x4d - t30 * z3_3d) * (1.0 / z3_3);
        b41 = t30;
        b41d = t30d;
      }
      h10 = b40;
      h10d = b40d;
      h11 = 0.0;
      h11d = 0.0;
      h12 = b41;
      h12d = b41d;
    } else {
      k9 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x);
      if (k9 < 0) {
        p_road6 = p[t->roadadr[road]];
        p_road6d = pd[t->roadadr[road]];
        h2 = p[t->roadadr[road] + 1] - p_road6;
        h2d = pd[t->roadadr[road] + 1] - p_road6d;
        p_roadroad2 = p[t->roadadr[road] + t->roadn[road]];
        p_roadroad2d = pd[t->roadadr[road] + t->roadn[road]];
        t31 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2) / h2;
        t31d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2d - t31 * h2d) * (1.0 / h2);
        slope2 = t31 - h2 / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]);
        slope2d = t31d - (h2d / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]) + h2 / 6.0 * (2.0 *
            spline0d[t->roadspline[road]][0] + spline0d[t->roadspline[road] + 1][0]));
        s30 = p_roadroad2 + slope2 * (x - p_road6);
        s30d = p_roadroad2d + (slope2d * (x - p_road6) + slope2 * (xd - p_road6d));
        s31 = slope2;
        s31d = slope2d;
      } else if (k9 > t->roadn[road] - 2) {
        p5 = p[t->roadadr[road] + t->roadn[road] - 1];
        p5d = pd[t->roadadr[road] + t->roadn[road] - 1];
        h2_2 = p5 - p[t->roadadr[road] + t->roadn[road] - 2];
        h2_2d = p5d - pd[t->roadadr[road] + t->roadn[road] - 2];
        p6 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        p6d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t32 = (p6 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h2_2;
        t32d = (p6d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t32 * h2_2d) *
            (1.0 / h2_2);
        slope2_2 = t32 + h2_2 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        slope2_2d = t32d + (h2_2d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] +
            2.0 * spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h2_2 / 6.0 *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0]));
        s30 = p6 + slope2_2 * (x - p5);
        s30d = p6d + (slope2_2d * (x - p5) + slope2_2 * (xd - p5d));
        s31 = slope2_2;
        s31d = slope2_2d;
      } else {
        p_roadk91 = p[t->roadadr[road] + k9 + 1];
        p_roadk91d = pd[t->roadadr[road] + k9 + 1];
        p_roadk9 = p[t->roadadr[road] + k9];
        p_roadk9d = pd[t->roadadr[road] + k9];
        h2_3 = p_roadk91 - p_roadk9;
        h2_3d = p_roadk91d - p_roadk9d;
        a4 = p_roadk91 - x;
        a4d = p_roadk91d - xd;
        c5 = x - p_roadk9;
        c5d = xd - p_roadk9d;
        p7 = p[t->roadadr[road] + t->roadn[road] + k9];
        p7d = pd[t->roadadr[road] + t->roadn[road] + k9];
        t33 = (p[t->roadadr[road] + t->roadn[road] + k9 + 1] - p7) / h2_3;
        t33d = (pd[t->roadadr[road] + t->roadn[road] + k9 + 1] - p7d - t33 * h2_3d) * (1.0 / h2_3);
        spline0_roadk910 = spline0[t->roadspline[road] + k9 + 1][0];
        spline0_roadk910d = spline0d[t->roadspline[road] + k9 + 1][0];
        spline0_roadk90 = spline0[t->roadspline[road] + k9][0];
        spline0_roadk90d = spline0d[t->roadspline[road] + k9][0];
        e2 = t33 - h2_3 / 6.0 * (spline0_roadk910 - spline0_roadk90);
        e2d = t33d - (h2_3d / 6.0 * (spline0_roadk910 - spline0_roadk90) + h2_3 / 6.0 *
            (spline0_roadk910d - spline0_roadk90d));
        t34 = 6.0 * h2_3;
        t34d = 6.0 * h2_3d;
        t35 = (spline0_roadk90 * a4 * a4 * a4 + spline0_roadk910 * c5 * c5 * c5) / t34;
        t35d = (((spline0_roadk90d * a4 + spline0_roadk90 * a4d) * a4 + spline0_roadk90 * a4 * a4d)
            * a4 + spline0_roadk90 * a4 * a4 * a4d + (((spline0_roadk910d * c5 + spline0_roadk910 *
            c5d) * c5 + spline0_roadk910 * c5 * c5d) * c5 + spline0_roadk910 * c5 * c5 * c5d) - t35
            * t34d) * (1.0 / t34);
        s30 = t35 + p7 - spline0_roadk90 * h2_3 * h2_3 / 6.0 + e2 * c5;
        s30d = t35d + p7d - ((spline0_roadk90d * h2_3 + spline0_roadk90 * h2_3d) * h2_3 +
            spline0_roadk90 * h2_3 * h2_3d) / 6.0 + (e2d * c5 + e2 * c5d);
        t36 = 2.0 * h2_3;
        t36d = 2.0 * h2_3d;
        t37 = (spline0_roadk910 * c5 * c5 - spline0_roadk90 * a4 * a4) / t36;
        t37d = ((spline0_roadk910d * c5 + spline0_roadk910 * c5d) * c5 + spline0_roadk910 * c5 * c5d
            - ((spline0_roadk90d * a4 + spline0_roadk90 * a4d) * a4 + spline0_roadk90 * a4 * a4d) -
            t37 * t36d) * (1.0 / t36);
        s31 = t37 + e2;
        s31d = t37d + e2d;
      }
      h10 = s30;
      h10d = s30d;
      h11 = s31;
      h11d = s31d;
      h12 = 0.0;
      h12d = 0.0;
    }
    t38 = 1.0 + h11 * h11;
    t38d = h11d * h11 + h11 * h11d;
    s = sqrt(t38);
    sd = 1.0 / (2.0 * s) * t38d;
    normal0 = -h11 / s;
    normal0d = (-h11d - normal0 * sd) * (1.0 / s);
    normal1 = 0.0;
    normal2 = 1.0 / s;
    normal2d = -(normal2 * sd * (1.0 / s));
    c = u0 * normal0 + u1 * normal1 + u2_2 * normal2;
    cd = u0d * normal0 + u0 * normal0d + u1d * normal1 + (u2_2d * normal2 + u2_2 * normal2d);
    un0 = u1 * normal2 - u2_2 * normal1;
    un0d = u1d * normal2 + u1 * normal2d - u2_2d * normal1;
    un1 = u2_2 * normal0 - u0 * normal2;
    un1d = u2_2d * normal0 + u2_2 * normal0d - (u0d * normal2 + u0 * normal2d);
    un2 = u0 * normal1 - u1 * normal0;
    un2d = u0d * normal1 - (u1d * normal0 + u1 * normal0d);
    t39 = un0 * un0 + un1 * un1 + un2 * un2;
    t39d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
    w2 = sqrt(t39);
    w2d = 1.0 / (2.0 * w2) * t39d;
    r2 = ((g0 - x) * normal0 + (g2 - h10) * normal2) / w2;
    r2d = ((g0d - xd) * normal0 + (g0 - x) * normal0d + ((g2d - h10d) * normal2 + (g2 - h10) *
        normal2d) - r2 * w2d) * (1.0 / w2);
    along0 = un0 / w2;
    along0d = (un0d - along0 * w2d) * (1.0 / w2);
    along1 = un1 / w2;
    along1d = (un1d - along1 * w2d) * (1.0 / w2);
    along2 = un2 / w2;
    along2d = (un2d - along2 * w2d) * (1.0 / w2);
    arm0 = r2 * (c * u0 - normal0) / w2;
    arm0d = (r2d * (c * u0 - normal0) + r2 * (cd * u0 + c * u0d - normal0d) - arm0 * w2d) * (1.0 /
        w2);
    T0 = along0;
    T0d = along0d;
    N0 = normal0;
    N0d = normal0d;
    arm1 = r2 * (c * u1 - normal1) / w2;
    arm1d = (r2d * (c * u1 - normal1) + r2 * (cd * u1 + c * u1d) - arm1 * w2d) * (1.0 / w2);
    T1 = along1;
    T1d = along1d;
    N1 = normal1;
    arm2 = r2 * (c * u2_2 - normal2) / w2;
    arm2d = (r2d * (c * u2_2 - normal2) + r2 * (cd * u2_2 + c * u2_2d - normal2d) - arm2 * w2d) *
        (1.0 / w2);
    T2 = along2;
    T2d = along2d;
    N2 = normal2;
    N2d = normal2d;
    z0 = r2;
    z0d = r2d;
    z2_2 = w2;
    z2_2d = w2d;
    z3_2 = h12;
    z3_2d = h12d;
    w0 = Z[carrier][3];
    w0d = Zd[carrier][3];
    w1 = Z[carrier][4];
    w1d = Zd[carrier][4];
    w2_2 = Z[carrier][5];
    w2_2d = Zd[carrier][5];
    turn = w0 * u0 + w1 * u1 + w2_2 * u2_2;
    turnd = w0d * u0 + w0 * u0d + (w1d * u1 + w1 * u1d) + (w2_2d * u2_2 + w2_2 * u2_2d);
    wr0 = w0 - turn * u0;
    wr0d = w0d - (turnd * u0 + turn * u0d);
    wr1 = w1 - turn * u1;
    wr1d = w1d - (turnd * u1 + turn * u1d);
    wr2 = w2_2 - turn * u2_2;
    wr2d = w2_2d - (turnd * u2_2 + turn * u2_2d);
    r_i2 = r[t->wheelpoint[i]][2];
    r_i2d = rd[t->wheelpoint[i]][2];
    r_i1 = r[t->wheelpoint[i]][1];
    r_i1d = rd[t->wheelpoint[i]][1];
    vc0 = w1 * r_i2 - w2_2 * r_i1;
    vc0d = w1d * r_i2 + w1 * r_i2d - (w2_2d * r_i1 + w2_2 * r_i1d);
    r_i0 = r[t->wheelpoint[i]][0];
    r_i0d = rd[t->wheelpoint[i]][0];
    vc1 = w2_2 * r_i0 - w0 * r_i2;
    vc1d = w2_2d * r_i0 + w2_2 * r_i0d - (w0d * r_i2 + w0 * r_i2d);
    vc2 = w0 * r_i1 - w1 * r_i0;
    vc2d = w0d * r_i1 + w0 * r_i1d - (w1d * r_i0 + w1 * r_i0d);
    vr0 = wr1 * arm2 - wr2 * arm1;
    vr0d = wr1d * arm2 + wr1 * arm2d - (wr2d * arm1 + wr2 * arm1d);
    vr1 = wr2 * arm0 - wr0 * arm2;
    vr1d = wr2d * arm0 + wr2 * arm0d - (wr0d * arm2 + wr0 * arm2d);
    vr2 = wr0 * arm1 - wr1 * arm0;
    vr2d = wr0d * arm1 + wr0 * arm1d - (wr1d * arm0 + wr1 * arm0d);
    v0 = Z[carrier][0] + vc0 + vr0;
    v0d = Zd[carrier][0] + vc0d + vr0d;
    v1 = Z[carrier][1] + vc1 + vr1;
    v1d = Zd[carrier][1] + vc1d + vr1d;
    v2 = Z[carrier][2] + vc2 + vr2;
    v2d = Zd[carrier][2] + vc2d + vr2d;
    rhov = (z3_2 * v0 - (v0 * N0 + v1 * N1 + v2 * N2)) / z2_2;
    rhovd = (z3_2d * v0 + z3_2 * v0d - (v0d * N0 + v0 * N0d + v1d * N1 + (v2d * N2 + v2 * N2d)) -
        rhov * z2_2d) * (1.0 / z2_2);
    fz = p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] * (p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0) + p[adr
        + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
    fzd = pd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] * (p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0) +
        p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] * (pd[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0d) +
        (pd[adr + MAGGI_TYRE_VERTICAL_DAMPING] * rhov + p[adr + MAGGI_TYRE_VERTICAL_DAMPING] *
        rhovd);
    fz0 = p[adr + MAGGI_TYRE_LFZO] * p[adr];
    fz0d = pd[adr + MAGGI_TYRE_LFZO] * p[adr] + p[adr + MAGGI_TYRE_LFZO] * pd[adr];
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      ratiod = (fzd - ratio * fz0d) * (1.0 / fz0);
      t40 = fz0 / p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t40d = (fz0d - t40 * pd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS]) * (1.0 / p[adr +
          MAGGI_TYRE_VERTICAL_STIFFNESS]);
      t41 = p[adr + MAGGI_TYRE_BREFF] * ratio;
      t41d = pd[adr + MAGGI_TYRE_BREFF] * ratio + p[adr + MAGGI_TYRE_BREFF] * ratiod;
      t42 = atan(t41);
      t42d = 1.0 / (1.0 + t41 * t41) * t41d;
      re2 = p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - t40 * (p[adr + MAGGI_TYRE_DREFF] * t42 + p[adr +
          MAGGI_TYRE_FREFF] * ratio);
      re2d = pd[adr + MAGGI_TYRE_UNLOADED_RADIUS] - (t40d * (p[adr + MAGGI_TYRE_DREFF] * t42 + p[adr
          + MAGGI_TYRE_FREFF] * ratio) + t40 * (pd[adr + MAGGI_TYRE_DREFF] * t42 + p[adr +
          MAGGI_TYRE_DREFF] * t42d + (pd[adr + MAGGI_TYRE_FREFF] * ratio + p[adr + MAGGI_TYRE_FREFF]
          * ratiod)));
    } else {
      re2 = p[adr + MAGGI_TYRE_UNLOADED_RADIUS];
      re2d = pd[adr + MAGGI_TYRE_UNLOADED_RADIUS];
    }
    re = re2;
    red = re2d;
    t43 = (v0 * T0 + v1 * T1 + v2 * T2) / re;
    t43d = (v0d * T0 + v0 * T0d + (v1d * T1 + v1 * T1d) + (v2d * T2 + v2 * T2d) - t43 * red) * (1.0
        / re);
    t44 = b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2_2;
    t44d = bd[body][3] * u0 + b[body][3] * u0d + (bd[body][4] * u1 + b[body][4] * u1d) +
        (bd[body][5] * u2_2 + b[body][5] * u2_2d);
    tb96 = spinb[i];
    tb96d = spinbd[i];
    spinb[i] = 0.0;
    spinbd[i] = 0.0;
    tb97 = tb96 / t44;
    tb97d = (tb96d - tb97 * t44d) * (1.0 / t44);
    t43b = tb97;
    t43bd = tb97d;
    turnb = -tb97;
    turnbd = -tb97d;
    t44b = -(tb97 * spin[i]);
    t44bd = -(tb97d * spin[i] + tb97 * spind[i]);
    bb[body][3] += t44b * u0;
    bbd[body][3] += t44bd * u0 + t44b * u0d;
    u0b = t44b * b[body][3];
    u0bd = t44bd * b[body][3] + t44b * bd[body][3];
    bb[body][4] += t44b * u1;
    bbd[body][4] += t44bd * u1 + t44b * u1d;
    u1b = t44b * b[body][4];
    u1bd = t44bd * b[body][4] + t44b * bd[body][4];
    bb[body][5] += t44b * u2_2;
    bbd[body][5] += t44bd * u2_2 + t44b * u2_2d;
    u2_2b = t44b * b[body][5];
    u2_2bd = t44bd * b[body][5] + t44b * bd[body][5];
    tb95 = t43b / re;
    tb95d = (t43bd - tb95 * red) * (1.0 / re);
    v0b = tb95 * T0;
    v0bd = tb95d * T0 + tb95 * T0d;
    T0b = tb95 * v0;
    T0bd = tb95d * v0 + tb95 * v0d;
    v1b = tb95 * T1;
    v1bd = tb95d * T1 + tb95 * T1d;
    T1b = tb95 * v1;
    T1bd = tb95d * v1 + tb95 * v1d;
    v2b = tb95 * T2;
    v2bd = tb95d * T2 + tb95 * T2d;
    T2b = tb95 * v2;
    T2bd = tb95d * v2 + tb95 * v2d;
    reb = -(tb95 * t43);
    rebd = -(tb95d * t43 + tb95 * t43d);
    re2b = reb;
    re2bd = rebd;
    fz0b = 0.0;
    fz0bd = 0.0;
    fzb = 0.0;
    fzbd = 0.0;
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      ratiod = (fzd - ratio * fz0d) * (1.0 / fz0);
      t40 = fz0 / p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t40d = (fz0d - t40 * pd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS]) * (1.0 / p[adr +
          MAGGI_TYRE_VERTICAL_STIFFNESS]);
      t41 = p[adr + MAGGI_TYRE_BREFF] * ratio;
      t41d = pd[adr + MAGGI_TYRE_BREFF] * ratio + p[adr + MAGGI_TYRE_BREFF] * ratiod;
      t42 = atan(t41);
      t42d = 1.0 / (1.0 + t41 * t41) * t41d;
      pb[adr + MAGGI_TYRE_UNLOADED_RADIUS] += re2b;
      pbd[adr + MAGGI_TYRE_UNLOADED_RADIUS] += re2bd;
      t40b = -(re2b * (p[adr + MAGGI_TYRE_DREFF] * t42 + p[adr + MAGGI_TYRE_FREFF] * ratio));
      t40bd = -(re2bd * (p[adr + MAGGI_TYRE_DREFF] * t42 + p[adr + MAGGI_TYRE_FREFF] * ratio) + re2b
          * (pd[adr + MAGGI_TYRE_DREFF] * t42 + p[adr + MAGGI_TYRE_DREFF] * t42d + (pd[adr +
          MAGGI_TYRE_FREFF] * ratio + p[adr + MAGGI_TYRE_FREFF] * ratiod)));
      tb94 = re2b * t40;
      tb94d = re2bd * t40 + re2b * t40d;
      pb[adr + MAGGI_TYRE_DREFF] -= tb94 * t42;
      pbd[adr + MAGGI_TYRE_DREFF] -= tb94d * t42 + tb94 * t42d;
      t42b = -(tb94 * p[adr + MAGGI_TYRE_DREFF]);
      t42bd = -(tb94d * p[adr + MAGGI_TYRE_DREFF] + tb94 * pd[adr + MAGGI_TYRE_DREFF]);
      pb[adr + MAGGI_TYRE_FREFF] -= tb94 * ratio;
      pbd[adr + MAGGI_TYRE_FREFF] -= tb94d * ratio + tb94 * ratiod;
      ratiob = -(tb94 * p[adr + MAGGI_TYRE_FREFF]);
      ratiobd = -(tb94d * p[adr + MAGGI_TYRE_FREFF] + tb94 * pd[adr + MAGGI_TYRE_FREFF]);
      re2b = 0.0;
      re2bd = 0.0;
      t41b = t42b * (1.0 / (1.0 + t41 * t41));
      t41bd = t42bd * (1.0 / (1.0 + t41 * t41)) - t42b * (1.0 / (1.0 + t41 * t41) * (t41d * t41 +
          t41 * t41d) / (1.0 + t41 * t41));
      pb[adr + MAGGI_TYRE_BREFF] += t41b * ratio;
      pbd[adr + MAGGI_TYRE_BREFF] += t41bd * ratio + t41b * ratiod;
      ratiob += t41b * p[adr + MAGGI_TYRE_BREFF];
      ratiobd += t41bd * p[adr + MAGGI_TYRE_BREFF] + t41b * pd[adr + MAGGI_TYRE_BREFF];
      tb93 = t40b / p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
      tb93d = (t40bd - tb93 * pd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS]) * (1.0 / p[adr +
          MAGGI_TYRE_VERTICAL_STIFFNESS]);
      fz0b += tb93;
      fz0bd += tb93d;
      pb[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] -= tb93 * t40;
      pbd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] -= tb93d * t40 + tb93 * t40d;
      tb92 = ratiob / fz0;
      tb92d = (ratiobd - tb92 * fz0d) * (1.0 / fz0);
      fzb += tb92;
      fzbd += tb92d;
      fz0b -= tb92 * ratio;
      fz0bd -= tb92d * ratio + tb92 * ratiod;
    } else {
      pb[adr + MAGGI_TYRE_UNLOADED_RADIUS] += re2b;
      pbd[adr + MAGGI_TYRE_UNLOADED_RADIUS] += re2bd;
      re2b = 0.0;
      re2bd = 0.0;
    }
    pb[adr + MAGGI_TYRE_LFZO] += fz0b * p[adr];
    /* Re = R0 - rho0 (D atan(B rd) + F rd),  rd = Fz / Fz0,  rho0 = Fz0 / Cz;  R0 in the air */
    pbd[adr + MAGGI_TYRE_LFZO] += fz0bd * p[adr] + fz0b * pd[adr];
    pb[adr] += fz0b * p[adr + MAGGI_TYRE_LFZO];
    pbd[adr] += fz0bd * p[adr + MAGGI_TYRE_LFZO] + fz0b * pd[adr + MAGGI_TYRE_LFZO];
    pb[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] += fzb * (p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0);
    pbd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] += fzbd * (p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0) +
        fzb * (pd[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0d);
    tb91 = fzb * p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
    tb91d = fzbd * p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] + fzb * pd[adr +
        MAGGI_TYRE_VERTICAL_STIFFNESS];
    pb[adr + MAGGI_TYRE_UNLOADED_RADIUS] += tb91;
    pbd[adr + MAGGI_TYRE_UNLOADED_RADIUS] += tb91d;
    z0b = -tb91;
    z0bd = -tb91d;
    pb[adr + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
    pbd[adr + MAGGI_TYRE_VERTICAL_DAMPING] += fzbd * rhov + fzb * rhovd;
    rhovb = fzb * p[adr + MAGGI_TYRE_VERTICAL_DAMPING];
    rhovbd = fzbd * p[adr + MAGGI_TYRE_VERTICAL_DAMPING] + fzb * pd[adr +
        MAGGI_TYRE_VERTICAL_DAMPING];
    tb90 = rhovb / z2_2;
    tb90d = (rhovbd - tb90 * z2_2d) * (1.0 / z2_2);
    z3_2b = tb90 * v0;
    z3_2bd = tb90d * v0 + tb90 * v0d;
    v0b += tb90 * z3_2;
    v0bd += tb90d * z3_2 + tb90 * z3_2d;
    v0b -= tb90 * N0;
    v0bd -= tb90d * N0 + tb90 * N0d;
    N0b = -(tb90 * v0);
    N0bd = -(tb90d * v0 + tb90 * v0d);
    v1b -= tb90 * N1;
    v1bd -= tb90d * N1;
    v2b -= tb90 * N2;
    v2bd -= tb90d * N2 + tb90 * N2d;
    N2b = -(tb90 * v2);
    N2bd = -(tb90d * v2 + tb90 * v2d);
    z2_2b = -(tb90 * rhov);
    z2_2bd = -(tb90d * rhov + tb90 * rhovd);
    Zb[carrier][2] += v2b;
    Zbd[carrier][2] += v2bd;
    vc2b = v2b;
    vc2bd = v2bd;
    vr2b = v2b;
    vr2bd = v2bd;
    Zb[carrier][1] += v1b;
    Zbd[carrier][1] += v1bd;
    vc1b = v1b;
    vc1bd = v1bd;
    vr1b = v1b;
    vr1bd = v1bd;
    Zb[carrier][0] += v0b;
    Zbd[carrier][0] += v0bd;
    vc0b = v0b;
    vc0bd = v0bd;
    vr0b = v0b;
    vr0bd = v0bd;
    wr0b = vr2b * arm1;
    wr0bd = vr2bd * arm1 + vr2b * arm1d;
    arm1b = vr2b * wr0;
    arm1bd = vr2bd * wr0 + vr2b * wr0d;
    wr1b = -(vr2b * arm0);
    wr1bd = -(vr2bd * arm0 + vr2b * arm0d);
    arm0b = -(vr2b * wr1);
    arm0bd = -(vr2bd * wr1 + vr2b * wr1d);
    wr2b = vr1b * arm0;
    wr2bd = vr1bd * arm0 + vr1b * arm0d;
    arm0b += vr1b * wr2;
    arm0bd += vr1bd * wr2 + vr1b * wr2d;
    wr0b -= vr1b * arm2;
    wr0bd -= vr1bd * arm2 + vr1b * arm2d;
    arm2b = -(vr1b * wr0);
    arm2bd = -(vr1bd * wr0 + vr1b * wr0d);
    wr1b += vr0b * arm2;
    wr1bd += vr0bd * arm2 + vr0b * arm2d;
    arm2b += vr0b * wr1;
    arm2bd += vr0bd * wr1 + vr0b * wr1d;
    wr2b -= vr0b * arm1;
    wr2bd -= vr0bd * arm1 + vr0b * arm1d;
    arm1b -= vr0b * wr2;
    arm1bd -= vr0bd * wr2 + vr0b * wr2d;
    w0b = vc2b * r_i1;
    w0bd = vc2bd * r_i1 + vc2b * r_i1d;
    r_i1b = vc2b * w0;
    r_i1bd = vc2bd * w0 + vc2b * w0d;
    w1b = -(vc2b * r_i0);
    w1bd = -(vc2bd * r_i0 + vc2b * r_i0d);
    r_i0b = -(vc2b * w1);
    r_i0bd = -(vc2bd * w1 + vc2b * w1d);
    w2_2b = vc1b * r_i0;
    w2_2bd = vc1bd * r_i0 + vc1b * r_i0d;
    r_i0b += vc1b * w2_2;
    r_i0bd += vc1bd * w2_2 + vc1b * w2_2d;
    w0b -= vc1b * r_i2;
    w0bd -= vc1bd * r_i2 + vc1b * r_i2d;
    r_i2b = -(vc1b * w0);
    r_i2bd = -(vc1bd * w0 + vc1b * w0d);
    rb[t->wheelpoint[i]][0] += r_i0b;
    rbd[t->wheelpoint[i]][0] += r_i0bd;
    w1b += vc0b * r_i2;
    w1bd += vc0bd * r_i2 + vc0b * r_i2d;
    r_i2b += vc0b * w1;
    r_i2bd += vc0bd * w1 + vc0b * w1d;
    w2_2b -= vc0b * r_i1;
    w2_2bd -= vc0bd * r_i1 + vc0b * r_i1d;
    r_i1b -= vc0b * w2_2;
    r_i1bd -= vc0bd * w2_2 + vc0b * w2_2d;
    rb[t->wheelpoint[i]][1] += r_i1b;
    rbd[t->wheelpoint[i]][1] += r_i1bd;
    rb[t->wheelpoint[i]][2] += r_i2b;
    rbd[t->wheelpoint[i]][2] += r_i2bd;
    w2_2b += wr2b;
    w2_2bd += wr2bd;
    turnb -= wr2b * u2_2;
    turnbd -= wr2bd * u2_2 + wr2b * u2_2d;
    u2_2b -= wr2b * turn;
    u2_2bd -= wr2bd * turn + wr2b * turnd;
    w1b += wr1b;
    w1bd += wr1bd;
    turnb -= wr1b * u1;
    turnbd -= wr1bd * u1 + wr1b * u1d;
    u1b -= wr1b * turn;
    u1bd -= wr1bd * turn + wr1b * turnd;
    w0b += wr0b;
    w0bd += wr0bd;
    turnb -= wr0b * u0;
    turnbd -= wr0bd * u0 + wr0b * u0d;
    u0b -= wr0b * turn;
    u0bd -= wr0bd * turn + wr0b * turnd;
    w0b += turnb * u0;
    w0bd += turnbd * u0 + turnb * u0d;
    u0b += turnb * w0;
    u0bd += turnbd * w0 + turnb * w0d;
    w1b += turnb * u1;
    w1bd += turnbd * u1 + turnb * u1d;
    u1b += turnb * w1;
    u1bd += turnbd * w1 + turnb * w1d;
    w2_2b += turnb * u2_2;
    w2_2bd += turnbd * u2_2 + turnb * u2_2d;
    u2_2b += turnb * w2_2;
    u2_2bd += turnbd * w2_2 + turnb * w2_2d;
    Zb[carrier][5] += w2_2b;
    Zbd[carrier][5] += w2_2bd;
    Zb[carrier][4] += w1b;
    Zbd[carrier][4] += w1bd;
    Zb[carrier][3] += w0b;
    Zbd[carrier][3] += w0bd;
    h12b = z3_2b;
    h12bd = z3_2bd;
    w2b = z2_2b;
    w2bd = z2_2bd;
    r2b = z0b;
    r2bd = z0bd;
    normal2b = N2b;
    normal2bd = N2bd;
    along2b = T2b;
    along2bd = T2bd;
    tb88 = arm2b / w2;
    tb88d = (arm2bd - tb88 * w2d) * (1.0 / w2);
    r2b += tb88 * (c * u2_2 - normal2);
    r2bd += tb88d * (c * u2_2 - normal2) + tb88 * (cd * u2_2 + c * u2_2d - normal2d);
    tb89 = tb88 * r2;
    tb89d = tb88d * r2 + tb88 * r2d;
    cb = tb89 * u2_2;
    cbd = tb89d * u2_2 + tb89 * u2_2d;
    u2_2b += tb89 * c;
    u2_2bd += tb89d * c + tb89 * cd;
    normal2b -= tb89;
    normal2bd -= tb89d;
    w2b -= tb88 * arm2;
    w2bd -= tb88d * arm2 + tb88 * arm2d;
    along1b = T1b;
    along1bd = T1bd;
    tb86 = arm1b / w2;
    tb86d = (arm1bd - tb86 * w2d) * (1.0 / w2);
    r2b += tb86 * (c * u1 - normal1);
    r2bd += tb86d * (c * u1 - normal1) + tb86 * (cd * u1 + c * u1d);
    tb87 = tb86 * r2;
    tb87d = tb86d * r2 + tb86 * r2d;
    cb += tb87 * u1;
    cbd += tb87d * u1 + tb87 * u1d;
    u1b += tb87 * c;
    u1bd += tb87d * c + tb87 * cd;
    w2b -= tb86 * arm1;
    w2bd -= tb86d * arm1 + tb86 * arm1d;
    normal0b = N0b;
    normal0bd = N0bd;
    along0b = T0b;
    along0bd = T0bd;
    tb84 = arm0b / w2;
    tb84d = (arm0bd - tb84 * w2d) * (1.0 / w2);
    r2b += tb84 * (c * u0 - normal0);
    r2bd += tb84d * (c * u0 - normal0) + tb84 * (cd * u0 + c * u0d - normal0d);
    tb85 = tb84 * r2;
    tb85d = tb84d * r2 + tb84 * r2d;
    cb += tb85 * u0;
    cbd += tb85d * u0 + tb85 * u0d;
    u0b += tb85 * c;
    u0bd += tb85d * c + tb85 * cd;
    normal0b -= tb85;
    normal0bd -= tb85d;
    w2b -= tb84 * arm0;
    w2bd -= tb84d * arm0 + tb84 * arm0d;
    tb83 = along2b / w2;
    tb83d = (along2bd - tb83 * w2d) * (1.0 / w2);
    un2b = tb83;
    un2bd = tb83d;
    w2b -= tb83 * along2;
    w2bd -= tb83d * along2 + tb83 * along2d;
    tb82 = along1b / w2;
    tb82d = (along1bd - tb82 * w2d) * (1.0 / w2);
    un1b = tb82;
    un1bd = tb82d;
    w2b -= tb82 * along1;
    w2bd -= tb82d * along1 + tb82 * along1d;
    tb81 = along0b / w2;
    tb81d = (along0bd - tb81 * w2d) * (1.0 / w2);
    un0b = tb81;
    un0bd = tb81d;
    w2b -= tb81 * along0;
    w2bd -= tb81d * along0 + tb81 * along0d;
    tb78 = r2b / w2;
    tb78d = (r2bd - tb78 * w2d) * (1.0 / w2);
    tb79 = tb78 * normal0;
    tb79d = tb78d * normal0 + tb78 * normal0d;
    g0b = tb79;
    g0bd = tb79d;
    xb = -tb79;
    xbd = -tb79d;
    normal0b += tb78 * (g0 - x);
    normal0bd += tb78d * (g0 - x) + tb78 * (g0d - xd);
    tb80 = tb78 * normal2;
    tb80d = tb78d * normal2 + tb78 * normal2d;
    g2b = tb80;
    g2bd = tb80d;
    h10b = -tb80;
    h10bd = -tb80d;
    normal2b += tb78 * (g2 - h10);
    normal2bd += tb78d * (g2 - h10) + tb78 * (g2d - h10d);
    w2b -= tb78 * r2;
    w2bd -= tb78d * r2 + tb78 * r2d;
    t39b = w2b * (1.0 / (2.0 * w2));
    t39bd = w2bd * (1.0 / (2.0 * w2)) - w2b * (1.0 / (2.0 * w2) * (2.0 * w2d) / (2.0 * w2));
    un0b += t39b * un0;
    un0bd += t39bd * un0 + t39b * un0d;
    un0b += t39b * un0;
    un0bd += t39bd * un0 + t39b * un0d;
    un1b += t39b * un1;
    un1bd += t39bd * un1 + t39b * un1d;
    un1b += t39b * un1;
    un1bd += t39bd * un1 + t39b * un1d;
    un2b += t39b * un2;
    un2bd += t39bd * un2 + t39b * un2d;
    un2b += t39b * un2;
    un2bd += t39bd * un2 + t39b * un2d;
    u0b += un2b * normal1;
    u0bd += un2bd * normal1;
    u1b -= un2b * normal0;
    u1bd -= un2bd * normal0 + un2b * normal0d;
    normal0b -= un2b * u1;
    normal0bd -= un2bd * u1 + un2b * u1d;
    u2_2b += un1b * normal0;
    u2_2bd += un1bd * normal0 + un1b * normal0d;
    normal0b += un1b * u2_2;
    normal0bd += un1bd * u2_2 + un1b * u2_2d;
    u0b -= un1b * normal2;
    u0bd -= un1bd * normal2 + un1b * normal2d;
    normal2b -= un1b * u0;
    normal2bd -= un1bd * u0 + un1b * u0d;
    u1b += un0b * normal2;
    u1bd += un0bd * normal2 + un0b * normal2d;
    normal2b += un0b * u1;
    normal2bd += un0bd * u1 + un0b * u1d;
    u2_2b -= un0b * normal1;
    u2_2bd -= un0bd * normal1;
    u0b += cb * normal0;
    u0bd += cbd * normal0 + cb * normal0d;
    normal0b += cb * u0;
    normal0bd += cbd * u0 + cb * u0d;
    u1b += cb * normal1;
    u1bd += cbd * normal1;
    u2_2b += cb * normal2;
    u2_2bd += cbd * normal2 + cb * normal2d;
    normal2b += cb * u2_2;
    normal2bd += cbd * u2_2 + cb * u2_2d;
    tb77 = normal2b / s;
    tb77d = (normal2bd - tb77 * sd) * (1.0 / s);
    sb = -(tb77 * normal2);
    sbd = -(tb77d * normal2 + tb77 * normal2d);
    tb76 = normal0b / s;
    tb76d = (normal0bd - tb76 * sd) * (1.0 / s);
    h11b = -tb76;
    h11bd = -tb76d;
    sb -= tb76 * normal0;
    sbd -= tb76d * normal0 + tb76 * normal0d;
    t38b = sb * (1.0 / (2.0 * s));
    t38bd = sbd * (1.0 / (2.0 * s)) - sb * (1.0 / (2.0 * s) * (2.0 * sd) / (2.0 * s));
    h11b += t38b * h11;
    h11bd += t38bd * h11 + t38b * h11d;
    h11b += t38b * h11;
    h11bd += t38bd * h11 + t38b * h11d;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road4 = p[t->roadadr[road]];
      p_road4d = pd[t->roadadr[road]];
      h12b = 0.0;
      h12bd = 0.0;
      p_road4b = h11b;
      p_road4bd = h11bd;
      h11b = 0.0;
      h11bd = 0.0;
      p_road4b += h10b * x;
      p_road4bd += h10bd * x + h10b * xd;
      xb += h10b * p_road4;
      xbd += h10bd * p_road4 + h10b * p_road4d;
      h10b = 0.0;
      h10bd = 0.0;
      pb[t->roadadr[road]] += p_road4b;
      pbd[t->roadadr[road]] += p_road4bd;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k8 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      k8d = -(k8 * pd[t->roadadr[road] + 1] * (1.0 / p[t->roadadr[road] + 1]));
      t18 = k8 * x;
      t18d = k8d * x + k8 * xd;
      t19 = sin(t18);
      t19d = cos(t18) * t18d;
      p_road5 = p[t->roadadr[road]];
      p_road5d = pd[t->roadadr[road]];
      t20 = k8 * x;
      t20d = k8d * x + k8 * xd;
      t21 = cos(t20);
      t21d = -(sin(t20) * t20d);
      h12b = 0.0;
      h12bd = 0.0;
      tb37 = h11b * t21;
      tb37d = h11bd * t21 + h11b * t21d;
      k8b = tb37 * p_road5;
      k8bd = tb37d * p_road5 + tb37 * p_road5d;
      p_road5b = tb37 * k8;
      p_road5bd = tb37d * k8 + tb37 * k8d;
      t21b = h11b * (k8 * p_road5);
      t21bd = h11bd * (k8 * p_road5) + h11b * (k8d * p_road5 + k8 * p_road5d);
      h11b = 0.0;
      h11bd = 0.0;
      t20b = -(t21b * sin(t20));
      t20bd = -(t21bd * sin(t20) + t21b * (cos(t20) * t20d));
      k8b += t20b * x;
      k8bd += t20bd * x + t20b * xd;
      xb += t20b * k8;
      xbd += t20bd * k8 + t20b * k8d;
      p_road5b += h10b * t19;
      p_road5bd += h10bd * t19 + h10b * t19d;
      t19b = h10b * p_road5;
      t19bd = h10bd * p_road5 + h10b * p_road5d;
      h10b = 0.0;
      h10bd = 0.0;
      pb[t->roadadr[road]] += p_road5b;
      pbd[t->roadadr[road]] += p_road5bd;
      t18b = t19b * cos(t18);
      t18bd = t19bd * cos(t18) - t19b * (sin(t18) * t18d);
      k8b += t18b * x;
      k8bd += t18bd * x + t18b * xd;
      xb += t18b * k8;
      xbd += t18bd * k8 + t18b * k8d;
      tb36 = k8b / p[t->roadadr[road] + 1];
      tb36d = (k8bd - tb36 * pd[t->roadadr[road] + 1]) * (1.0 / p[t->roadadr[road] + 1]);
      pb[t->roadadr[road] + 1] -= tb36 * k8;
      pbd[t->roadadr[road] + 1] -= tb36d * k8 + tb36 * k8d;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k7 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x);
      x4 = x - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k7 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      x4d = xd - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k7 * pd[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius2 = p[t->roadadr[road]];
      radius2d = pd[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      base2d = radius2d - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      t22d = radius2d * radius2 + radius2 * radius2d - (base2d * base2 + base2 * base2d);
      c4 = sqrt(t22);
      c4d = 1.0 / (2.0 * c4) * t22d;
      f2 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      f2d = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x4) > 0.0) {
        way2 = 1.0;
      } else {
        way2 = -1.0;
      }
      y2 = way2 * x4;
      y2d = way2 * x4d;
      b41b = h12b;
      b41bd = h12bd;
      h12b = 0.0;
      h12bd = 0.0;
      h11b = 0.0;
      h11bd = 0.0;
      b40b = h10b;
      b40bd = h10bd;
      h10b = 0.0;
      h10bd = 0.0;
      base2b = 0.0;
      base2bd = 0.0;
      c4b = 0.0;
      c4bd = 0.0;
      f2b = 0.0;
      f2bd = 0.0;
      radius2b = 0.0;
      radius2bd = 0.0;
      x4b = 0.0;
      x4bd = 0.0;
      y2b = 0.0;
      y2bd = 0.0;
      if (MAGGI_RE(y2) >= MAGGI_RE(c4 + f2)) {
        b41b = 0.0;
        b41bd = 0.0;
        b40b = 0.0;
        b40bd = 0.0;
      } else if (MAGGI_RE(y2) > MAGGI_RE(c4 - f2)) {
        t23 = radius2 * radius2 - (c4 - f2) * (c4 - f2);
        t23d = radius2d * radius2 + radius2 * radius2d - ((c4d - f2d) * (c4 - f2) + (c4 - f2) * (c4d
            - f2d));
        z3 = sqrt(t23);
        z3d = 1.0 / (2.0 * z3) * t23d;
        h0_3 = z3 - base2;
        h0_3d = z3d - base2d;
        h1_3 = 2.0 * f2 * (c4 - f2) / z3;
        h1_3d = (2.0 * f2d * (c4 - f2) + 2.0 * f2 * (c4d - f2d) - h1_3 * z3d) * (1.0 / z3);
        a3 = 3.0 * h0_3 - h1_3;
        a3d = 3.0 * h0_3d - h1_3d;
        t24 = z3 * z3 * z3;
        t24d = (z3d * z3 + z3 * z3d) * z3 + z3 * z3 * z3d;
        t25 = 2.0 * f2 * f2 * radius2 * radius2 / t24;
        t25d = (((2.0 * f2d * f2 + 2.0 * f2 * f2d) * radius2 + 2.0 * f2 * f2 * radius2d) * radius2 +
            2.0 * f2 * f2 * radius2 * radius2d - t25 * t24d) * (1.0 / t24);
        b5 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        b5d = 6.0 * h0_3d - 3.0 * h1_3d - t25d;
        t26 = 2.0 * f2;
        t26d = 2.0 * f2d;
        u3 = (c4 + f2 - y2) / t26;
        u3d = (c4d + f2d - y2d - u3 * t26d) * (1.0 / t26);
        w4 = 1.0 - u3;
        w4d = -u3d;
        t27 = 2.0 * f2;
        t27d = 2.0 * f2d;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 * (a3 + 2.0 * w4 * b5)) /
            t27;
        t28d = ((-(way2 * u3d * u3) + -way2 * u3 * u3d) * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 *
            (a3 + 2.0 * w4 * b5)) + -way2 * u3 * u3 * (3.0 * (h0_3d + (w4d * (a3 + w4 * b5) + w4 *
            (a3d + (w4d * b5 + w4 * b5d)))) - (u3d * (a3 + 2.0 * w4 * b5) + u3 * (a3d + (2.0 * w4d *
            b5 + 2.0 * w4 * b5d)))) - t28 * t27d) * (1.0 / t27);
        t28b = b41b;
        t28bd = b41bd;
        b41b = 0.0;
        b41bd = 0.0;
        tb51 = t28b / t27;
        tb51d = (t28bd - tb51 * t27d) * (1.0 / t27);
        tb52 = tb51 * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 * (a3 + 2.0 * w4 * b5));
        tb52d = tb51d * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 * (a3 + 2.0 * w4 * b5)) + tb51 *
            (3.0 * (h0_3d + (w4d * (a3 + w4 * b5) + w4 * (a3d + (w4d * b5 + w4 * b5d)))) - (u3d *
            (a3 + 2.0 * w4 * b5) + u3 * (a3d + (2.0 * w4d * b5 + 2.0 * w4 * b5d))));
        u3b = -(tb52 * u3 * way2);
        u3bd = -((tb52d * u3 + tb52 * u3d) * way2);
        u3b += tb52 * (-way2 * u3);
        u3bd += tb52d * (-way2 * u3) - tb52 * (way2 * u3d);
        tb53 = tb51 * (-way2 * u3 * u3);
        tb53d = tb51d * (-way2 * u3 * u3) + tb51 * (-(way2 * u3d * u3) + -way2 * u3 * u3d);
        tb54 = tb53 * 3.0;
        tb54d = tb53d * 3.0;
        h0_3b = tb54;
        h0_3bd = tb54d;
        w4b = tb54 * (a3 + w4 * b5);
        w4bd = tb54d * (a3 + w4 * b5) + tb54 * (a3d + (w4d * b5 + w4 * b5d));
        tb55 = tb54 * w4;
        tb55d = tb54d * w4 + tb54 * w4d;
        a3b = tb55;
        a3bd = tb55d;
        w4b += tb55 * b5;
        w4bd += tb55d * b5 + tb55 * b5d;
        b5b = tb55 * w4;
        b5bd = tb55d * w4 + tb55 * w4d;
        u3b -= tb53 * (a3 + 2.0 * w4 * b5);
        u3bd -= tb53d * (a3 + 2.0 * w4 * b5) + tb53 * (a3d + (2.0 * w4d * b5 + 2.0 * w4 * b5d));
        tb56 = tb53 * u3;
        tb56d = tb53d * u3 + tb53 * u3d;
        a3b -= tb56;
        a3bd -= tb56d;
        w4b -= tb56 * b5 * 2.0;
        w4bd -= (tb56d * b5 + tb56 * b5d) * 2.0;
        b5b -= tb56 * (2.0 * w4);
        b5bd -= tb56d * (2.0 * w4) + tb56 * (2.0 * w4d);
        t27b = -(tb51 * t28);
        t27bd = -(tb51d * t28 + tb51 * t28d);
        f2b += t27b * 2.0;
        f2bd += t27bd * 2.0;
        tb47 = b40b * (h0_3 + w4 * (a3 + w4 * b5));
        tb47d = b40bd * (h0_3 + w4 * (a3 + w4 * b5)) + b40b * (h0_3d + (w4d * (a3 + w4 * b5) + w4 *
            (a3d + (w4d * b5 + w4 * b5d))));
        tb48 = tb47 * u3;
        tb48d = tb47d * u3 + tb47 * u3d;
        u3b += tb48 * u3;
        u3bd += tb48d * u3 + tb48 * u3d;
        u3b += tb48 * u3;
        u3bd += tb48d * u3 + tb48 * u3d;
        u3b += tb47 * (u3 * u3);
        u3bd += tb47d * (u3 * u3) + tb47 * (u3d * u3 + u3 * u3d);
        tb49 = b40b * (u3 * u3 * u3);
        tb49d = b40bd * (u3 * u3 * u3) + b40b * ((u3d * u3 + u3 * u3d) * u3 + u3 * u3 * u3d);
        h0_3b += tb49;
        h0_3bd += tb49d;
        w4b += tb49 * (a3 + w4 * b5);
        w4bd += tb49d * (a3 + w4 * b5) + tb49 * (a3d + (w4d * b5 + w4 * b5d));
        tb50 = tb49 * w4;
        tb50d = tb49d * w4 + tb49 * w4d;
        a3b += tb50;
        a3bd += tb50d;
        w4b += tb50 * b5;
        w4bd += tb50d * b5 + tb50 * b5d;
        b5b += tb50 * w4;
        b5bd += tb50d * w4 + tb50 * w4d;
        b40b = 0.0;
        b40bd = 0.0;
        u3b -= w4b;
        u3bd -= w4bd;
        tb46 = u3b / t26;
        tb46d = (u3bd - tb46 * t26d) * (1.0 / t26);
        c4b += tb46;
        c4bd += tb46d;
        f2b += tb46;
        f2bd += tb46d;
        y2b -= tb46;
        y2bd -= tb46d;
        t26b = -(tb46 * u3);
        t26bd = -(tb46d * u3 + tb46 * u3d);
        f2b += t26b * 2.0;
        f2bd += t26bd * 2.0;
        h0_3b += b5b * 6.0;
        h0_3bd += b5bd * 6.0;
        h1_3b = -(b5b * 3.0);
        h1_3bd = -(b5bd * 3.0);
        t25b = -b5b;
        t25bd = -b5bd;
        tb43 = t25b / t24;
        tb43d = (t25bd - tb43 * t24d) * (1.0 / t24);
        tb44 = tb43 * radius2;
        tb44d = tb43d * radius2 + tb43 * radius2d;
        tb45 = tb44 * radius2;
        tb45d = tb44d * radius2 + tb44 * radius2d;
        f2b += tb45 * f2 * 2.0;
        f2bd += (tb45d * f2 + tb45 * f2d) * 2.0;
        f2b += tb45 * (2.0 * f2);
        f2bd += tb45d * (2.0 * f2) + tb45 * (2.0 * f2d);
        radius2b += tb44 * (2.0 * f2 * f2);
        radius2bd += tb44d * (2.0 * f2 * f2) + tb44 * (2.0 * f2d * f2 + 2.0 * f2 * f2d);
        radius2b += tb43 * (2.0 * f2 * f2 * radius2);
        radius2bd += tb43d * (2.0 * f2 * f2 * radius2) + tb43 * ((2.0 * f2d * f2 + 2.0 * f2 * f2d) *
            radius2 + 2.0 * f2 * f2 * radius2d);
        t24b = -(tb43 * t25);
        t24bd = -(tb43d * t25 + tb43 * t25d);
        tb42 = t24b * z3;
        tb42d = t24bd * z3 + t24b * z3d;
        z3b = tb42 * z3;
        z3bd = tb42d * z3 + tb42 * z3d;
        z3b += tb42 * z3;
        z3bd += tb42d * z3 + tb42 * z3d;
        z3b += t24b * (z3 * z3);
        z3bd += t24bd * (z3 * z3) + t24b * (z3d * z3 + z3 * z3d);
        h0_3b += a3b * 3.0;
        h0_3bd += a3bd * 3.0;
        h1_3b -= a3b;
        h1_3bd -= a3bd;
        tb40 = h1_3b / z3;
        tb40d = (h1_3bd - tb40 * z3d) * (1.0 / z3);
        f2b += tb40 * (c4 - f2) * 2.0;
        f2bd += (tb40d * (c4 - f2) + tb40 * (c4d - f2d)) * 2.0;
        tb41 = tb40 * (2.0 * f2);
        tb41d = tb40d * (2.0 * f2) + tb40 * (2.0 * f2d);
        c4b += tb41;
        c4bd += tb41d;
        f2b -= tb41;
        f2bd -= tb41d;
        z3b -= tb40 * h1_3;
        z3bd -= tb40d * h1_3 + tb40 * h1_3d;
        z3b += h0_3b;
        z3bd += h0_3bd;
        base2b -= h0_3b;
        base2bd -= h0_3bd;
        t23b = z3b * (1.0 / (2.0 * z3));
        t23bd = z3bd * (1.0 / (2.0 * z3)) - z3b * (1.0 / (2.0 * z3) * (2.0 * z3d) / (2.0 * z3));
        radius2b += t23b * radius2;
        radius2bd += t23bd * radius2 + t23b * radius2d;
        radius2b += t23b * radius2;
        radius2bd += t23bd * radius2 + t23b * radius2d;
        tb38 = t23b * (c4 - f2);
        tb38d = t23bd * (c4 - f2) + t23b * (c4d - f2d);
        c4b -= tb38;
        c4bd -= tb38d;
        f2b += tb38;
        f2bd += tb38d;
        tb39 = t23b * (c4 - f2);
        tb39d = t23bd * (c4 - f2) + t23b * (c4d - f2d);
        c4b -= tb39;
        c4bd -= tb39d;
        f2b += tb39;
        f2bd += tb39d;
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        t29d = radius2d * radius2 + radius2 * radius2d - (y2d * y2 + y2 * y2d);
        z3_3 = sqrt(t29);
        z3_3d = 1.0 / (2.0 * z3_3) * t29d;
        t30 = -x4 / z3_3;
        t30d = (-x4d - t30 * z3_3d) * (1.0 / z3_3);
        t30b = b41b;
        t30bd = b41bd;
        b41b = 0.0;
        b41bd = 0.0;
        tb57 = t30b / z3_3;
        tb57d = (t30bd - tb57 * z3_3d) * (1.0 / z3_3);
        x4b -= tb57;
        x4bd -= tb57d;
        z3_3b = -(tb57 * t30);
        z3_3bd = -(tb57d * t30 + tb57 * t30d);
        z3_3b += b40b;
        z3_3bd += b40bd;
        base2b -= b40b;
        base2bd -= b40bd;
        b40b = 0.0;
        b40bd = 0.0;
        t29b = z3_3b * (1.0 / (2.0 * z3_3));
        t29bd = z3_3bd * (1.0 / (2.0 * z3_3)) - z3_3b * (1.0 / (2.0 * z3_3) * (2.0 * z3_3d) / (2.0 *
            z3_3));
        radius2b += t29b * radius2;
        radius2bd += t29bd * radius2 + t29b * radius2d;
        radius2b += t29b * radius2;
        radius2bd += t29bd * radius2 + t29b * radius2d;
        y2b -= t29b * y2;
        y2bd -= t29bd * y2 + t29b * y2d;
        y2b -= t29b * y2;
        y2bd -= t29bd * y2 + t29b * y2d;
      }
      x4b += y2b * way2;
      x4bd += y2bd * way2;
      pb[t->roadadr[road] + MAGGI_BUMPS_FILLET] += f2b * 0.5;
      pbd[t->roadadr[road] + MAGGI_BUMPS_FILLET] += f2bd * 0.5;
      t22b = c4b * (1.0 / (2.0 * c4));
      t22bd = c4bd * (1.0 / (2.0 * c4)) - c4b * (1.0 / (2.0 * c4) * (2.0 * c4d) / (2.0 * c4));
      radius2b += t22b * radius2;
      radius2bd += t22bd * radius2 + t22b * radius2d;
      radius2b += t22b * radius2;
      radius2bd += t22bd * radius2 + t22b * radius2d;
      base2b -= t22b * base2;
      base2bd -= t22bd * base2 + t22b * base2d;
      base2b -= t22b * base2;
      base2bd -= t22bd * base2 + t22b * base2d;
      radius2b += base2b;
      radius2bd += base2bd;
      pb[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= base2b;
      pbd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= base2bd;
      pb[t->roadadr[road]] += radius2b;
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      pbd[t->roadadr[road]] += radius2bd;
      xb += x4b;
      xbd += x4bd;
      pb[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x4b;
      pbd[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x4bd;
      pb[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x4b * k7;
      pbd[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x4bd * k7;
    } else {
      k9 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x);
      h12b = 0.0;
      h12bd = 0.0;
      s31b = h11b;
      s31bd = h11bd;
      h11b = 0.0;
      h11bd = 0.0;
      s30b = h10b;
      s30bd = h10bd;
      h10b = 0.0;
      h10bd = 0.0;
      if (k9 < 0) {
        p_road6 = p[t->roadadr[road]];
        p_road6d = pd[t->roadadr[road]];
        h2 = p[t->roadadr[road] + 1] - p_road6;
        h2d = pd[t->roadadr[road] + 1] - p_road6d;
        p_roadroad2 = p[t->roadadr[road] + t->roadn[road]];
        p_roadroad2d = pd[t->roadadr[road] + t->roadn[road]];
        t31 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2) / h2;
        t31d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2d - t31 * h2d) * (1.0 / h2);
        slope2 = t31 - h2 / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]);
        slope2d = t31d - (h2d / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]) + h2 / 6.0 * (2.0 *
            spline0d[t->roadspline[road]][0] + spline0d[t->roadspline[road] + 1][0]));
        slope2b = s31b;
        slope2bd = s31bd;
        s31b = 0.0;
        s31bd = 0.0;
        p_roadroad2b = s30b;
        p_roadroad2bd = s30bd;
        slope2b += s30b * (x - p_road6);
        slope2bd += s30bd * (x - p_road6) + s30b * (xd - p_road6d);
        tb60 = s30b * slope2;
        tb60d = s30bd * slope2 + s30b * slope2d;
        xb += tb60;
        xbd += tb60d;
        p_road6b = -tb60;
        p_road6bd = -tb60d;
        s30b = 0.0;
        s30bd = 0.0;
        t31b = slope2b;
        t31bd = slope2bd;
        h2b = -(slope2b * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) / 6.0);
        h2bd = -((slope2bd * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) + slope2b * (2.0 * spline0d[t->roadspline[road]][0] +
            spline0d[t->roadspline[road] + 1][0])) / 6.0);
        tb59 = slope2b * (h2 / 6.0);
        tb59d = slope2bd * (h2 / 6.0) + slope2b * (h2d / 6.0);
        spline0b[t->roadspline[road]][0] -= tb59 * 2.0;
        spline0bd[t->roadspline[road]][0] -= tb59d * 2.0;
        spline0b[t->roadspline[road] + 1][0] -= tb59;
        spline0bd[t->roadspline[road] + 1][0] -= tb59d;
        tb58 = t31b / h2;
        tb58d = (t31bd - tb58 * h2d) * (1.0 / h2);
        pb[t->roadadr[road] + t->roadn[road] + 1] += tb58;
        pbd[t->roadadr[road] + t->roadn[road] + 1] += tb58d;
        p_roadroad2b -= tb58;
        p_roadroad2bd -= tb58d;
        h2b -= tb58 * t31;
        h2bd -= tb58d * t31 + tb58 * t31d;
        pb[t->roadadr[road] + t->roadn[road]] += p_roadroad2b;
        pbd[t->roadadr[road] + t->roadn[road]] += p_roadroad2bd;
        pb[t->roadadr[road] + 1] += h2b;
        pbd[t->roadadr[road] + 1] += h2bd;
        p_road6b -= h2b;
        p_road6bd -= h2bd;
        pb[t->roadadr[road]] += p_road6b;
        pbd[t->roadadr[road]] += p_road6bd;
      } else if (k9 > t->roadn[road] - 2) {
        p5 = p[t->roadadr[road] + t->roadn[road] - 1];
        p5d = pd[t->roadadr[road] + t->roadn[road] - 1];
        h2_2 = p5 - p[t->roadadr[road] + t->roadn[road] - 2];
        h2_2d = p5d - pd[t->roadadr[road] + t->roadn[road] - 2];
        p6 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        p6d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t32 = (p6 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h2_2;
        t32d = (p6d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t32 * h2_2d) *
            (1.0 / h2_2);
        slope2_2 = t32 + h2_2 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        slope2_2d = t32d + (h2_2d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] +
            2.0 * spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h2_2 / 6.0 *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0]));
        slope2_2b = s31b;
        slope2_2bd = s31bd;
        s31b = 0.0;
        s31bd = 0.0;
        p6b = s30b;
        p6bd = s30bd;
        slope2_2b += s30b * (x - p5);
        slope2_2bd += s30bd * (x - p5) + s30b * (xd - p5d);
        tb63 = s30b * slope2_2;
        tb63d = s30bd * slope2_2 + s30b * slope2_2d;
        xb += tb63;
        xbd += tb63d;
        p5b = -tb63;
        p5bd = -tb63d;
        s30b = 0.0;
        s30bd = 0.0;
        t32b = slope2_2b;
        t32bd = slope2_2bd;
        h2_2b = slope2_2b * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) / 6.0;
        h2_2bd = (slope2_2bd * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + slope2_2b *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0])) / 6.0;
        tb62 = slope2_2b * (h2_2 / 6.0);
        tb62d = slope2_2bd * (h2_2 / 6.0) + slope2_2b * (h2_2d / 6.0);
        spline0b[t->roadspline[road] + t->roadn[road] - 2][0] += tb62;
        spline0bd[t->roadspline[road] + t->roadn[road] - 2][0] += tb62d;
        spline0b[t->roadspline[road] + t->roadn[road] - 1][0] += tb62 * 2.0;
        spline0bd[t->roadspline[road] + t->roadn[road] - 1][0] += tb62d * 2.0;
        tb61 = t32b / h2_2;
        tb61d = (t32bd - tb61 * h2_2d) * (1.0 / h2_2);
        p6b += tb61;
        p6bd += tb61d;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb61;
        pbd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb61d;
        h2_2b -= tb61 * t32;
        h2_2bd -= tb61d * t32 + tb61 * t32d;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p6b;
        pbd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p6bd;
        p5b += h2_2b;
        p5bd += h2_2bd;
        pb[t->roadadr[road] + t->roadn[road] - 2] -= h2_2b;
        pbd[t->roadadr[road] + t->roadn[road] - 2] -= h2_2bd;
        pb[t->roadadr[road] + t->roadn[road] - 1] += p5b;
        pbd[t->roadadr[road] + t->roadn[road] - 1] += p5bd;
      } else {
        p_roadk91 = p[t->roadadr[road] + k9 + 1];
        p_roadk91d = pd[t->roadadr[road] + k9 + 1];
        p_roadk9 = p[t->roadadr[road] + k9];
        p_roadk9d = pd[t->roadadr[road] + k9];
        h2_3 = p_roadk91 - p_roadk9;
        h2_3d = p_roadk91d - p_roadk9d;
        a4 = p_roadk91 - x;
        a4d = p_roadk91d - xd;
        c5 = x - p_roadk9;
        c5d = xd - p_roadk9d;
        p7 = p[t->roadadr[road] + t->roadn[road] + k9];
        p7d = pd[t->roadadr[road] + t->roadn[road] + k9];
        t33 = (p[t->roadadr[road] + t->roadn[road] + k9 + 1] - p7) / h2_3;
        t33d = (pd[t->roadadr[road] + t->roadn[road] + k9 + 1] - p7d - t33 * h2_3d) * (1.0 / h2_3);
        spline0_roadk910 = spline0[t->roadspline[road] + k9 + 1][0];
        spline0_roadk910d = spline0d[t->roadspline[road] + k9 + 1][0];
        spline0_roadk90 = spline0[t->roadspline[road] + k9][0];
        spline0_roadk90d = spline0d[t->roadspline[road] + k9][0];
        e2 = t33 - h2_3 / 6.0 * (spline0_roadk910 - spline0_roadk90);
        e2d = t33d - (h2_3d / 6.0 * (spline0_roadk910 - spline0_roadk90) + h2_3 / 6.0 *
            (spline0_roadk910d - spline0_roadk90d));
        t34 = 6.0 * h2_3;
        t34d = 6.0 * h2_3d;
        t35 = (spline0_roadk90 * a4 * a4 * a4 + spline0_roadk910 * c5 * c5 * c5) / t34;
        t35d = (((spline0_roadk90d * a4 + spline0_roadk90 * a4d) * a4 + spline0_roadk90 * a4 * a4d)
            * a4 + spline0_roadk90 * a4 * a4 * a4d + (((spline0_roadk910d * c5 + spline0_roadk910 *
            c5d) * c5 + spline0_roadk910 * c5 * c5d) * c5 + spline0_roadk910 * c5 * c5 * c5d) - t35
            * t34d) * (1.0 / t34);
        t36 = 2.0 * h2_3;
        t36d = 2.0 * h2_3d;
        t37 = (spline0_roadk910 * c5 * c5 - spline0_roadk90 * a4 * a4) / t36;
        t37d = ((spline0_roadk910d * c5 + spline0_roadk910 * c5d) * c5 + spline0_roadk910 * c5 * c5d
            - ((spline0_roadk90d * a4 + spline0_roadk90 * a4d) * a4 + spline0_roadk90 * a4 * a4d) -
            t37 * t36d) * (1.0 / t36);
        t37b = s31b;
        t37bd = s31bd;
        e2b = s31b;
        e2bd = s31bd;
        s31b = 0.0;
        s31bd = 0.0;
        tb73 = t37b / t36;
        tb73d = (t37bd - tb73 * t36d) * (1.0 / t36);
        tb74 = tb73 * c5;
        tb74d = tb73d * c5 + tb73 * c5d;
        spline0_roadk910b = tb74 * c5;
        spline0_roadk910bd = tb74d * c5 + tb74 * c5d;
        c5b = tb74 * spline0_roadk910;
        c5bd = tb74d * spline0_roadk910 + tb74 * spline0_roadk910d;
        c5b += tb73 * (spline0_roadk910 * c5);
        c5bd += tb73d * (spline0_roadk910 * c5) + tb73 * (spline0_roadk910d * c5 + spline0_roadk910
            * c5d);
        tb75 = tb73 * a4;
        tb75d = tb73d * a4 + tb73 * a4d;
        spline0_roadk90b = -(tb75 * a4);
        spline0_roadk90bd = -(tb75d * a4 + tb75 * a4d);
        a4b = -(tb75 * spline0_roadk90);
        a4bd = -(tb75d * spline0_roadk90 + tb75 * spline0_roadk90d);
        a4b -= tb73 * (spline0_roadk90 * a4);
        a4bd -= tb73d * (spline0_roadk90 * a4) + tb73 * (spline0_roadk90d * a4 + spline0_roadk90 *
            a4d);
        t36b = -(tb73 * t37);
        t36bd = -(tb73d * t37 + tb73 * t37d);
        h2_3b = t36b * 2.0;
        h2_3bd = t36bd * 2.0;
        t35b = s30b;
        t35bd = s30bd;
        p7b = s30b;
        p7bd = s30bd;
        tb71 = s30b / 6.0;
        tb71d = s30bd / 6.0;
        tb72 = tb71 * h2_3;
        tb72d = tb71d * h2_3 + tb71 * h2_3d;
        spline0_roadk90b -= tb72 * h2_3;
        spline0_roadk90bd -= tb72d * h2_3 + tb72 * h2_3d;
        h2_3b -= tb72 * spline0_roadk90;
        h2_3bd -= tb72d * spline0_roadk90 + tb72 * spline0_roadk90d;
        h2_3b -= tb71 * (spline0_roadk90 * h2_3);
        h2_3bd -= tb71d * (spline0_roadk90 * h2_3) + tb71 * (spline0_roadk90d * h2_3 +
            spline0_roadk90 * h2_3d);
        e2b += s30b * c5;
        e2bd += s30bd * c5 + s30b * c5d;
        c5b += s30b * e2;
        c5bd += s30bd * e2 + s30b * e2d;
        s30b = 0.0;
        s30bd = 0.0;
        tb66 = t35b / t34;
        tb66d = (t35bd - tb66 * t34d) * (1.0 / t34);
        tb67 = tb66 * a4;
        tb67d = tb66d * a4 + tb66 * a4d;
        tb68 = tb67 * a4;
        tb68d = tb67d * a4 + tb67 * a4d;
        spline0_roadk90b += tb68 * a4;
        spline0_roadk90bd += tb68d * a4 + tb68 * a4d;
        a4b += tb68 * spline0_roadk90;
        a4bd += tb68d * spline0_roadk90 + tb68 * spline0_roadk90d;
        a4b += tb67 * (spline0_roadk90 * a4);
        a4bd += tb67d * (spline0_roadk90 * a4) + tb67 * (spline0_roadk90d * a4 + spline0_roadk90 *
            a4d);
        a4b += tb66 * (spline0_roadk90 * a4 * a4);
        a4bd += tb66d * (spline0_roadk90 * a4 * a4) + tb66 * ((spline0_roadk90d * a4 +
            spline0_roadk90 * a4d) * a4 + spline0_roadk90 * a4 * a4d);
        tb69 = tb66 * c5;
        tb69d = tb66d * c5 + tb66 * c5d;
        tb70 = tb69 * c5;
        tb70d = tb69d * c5 + tb69 * c5d;
        spline0_roadk910b += tb70 * c5;
        spline0_roadk910bd += tb70d * c5 + tb70 * c5d;
        c5b += tb70 * spline0_roadk910;
        c5bd += tb70d * spline0_roadk910 + tb70 * spline0_roadk910d;
        c5b += tb69 * (spline0_roadk910 * c5);
        c5bd += tb69d * (spline0_roadk910 * c5) + tb69 * (spline0_roadk910d * c5 + spline0_roadk910
            * c5d);
        c5b += tb66 * (spline0_roadk910 * c5 * c5);
        c5bd += tb66d * (spline0_roadk910 * c5 * c5) + tb66 * ((spline0_roadk910d * c5 +
            spline0_roadk910 * c5d) * c5 + spline0_roadk910 * c5 * c5d);
        t34b = -(tb66 * t35);
        t34bd = -(tb66d * t35 + tb66 * t35d);
        h2_3b += t34b * 6.0;
        h2_3bd += t34bd * 6.0;
        t33b = e2b;
        t33bd = e2bd;
        h2_3b -= e2b * (spline0_roadk910 - spline0_roadk90) / 6.0;
        h2_3bd -= (e2bd * (spline0_roadk910 - spline0_roadk90) + e2b * (spline0_roadk910d -
            spline0_roadk90d)) / 6.0;
        tb65 = e2b * (h2_3 / 6.0);
        tb65d = e2bd * (h2_3 / 6.0) + e2b * (h2_3d / 6.0);
        spline0_roadk910b -= tb65;
        spline0_roadk910bd -= tb65d;
        spline0_roadk90b += tb65;
        spline0_roadk90bd += tb65d;
        spline0b[t->roadspline[road] + k9][0] += spline0_roadk90b;
        spline0bd[t->roadspline[road] + k9][0] += spline0_roadk90bd;
        spline0b[t->roadspline[road] + k9 + 1][0] += spline0_roadk910b;
        spline0bd[t->roadspline[road] + k9 + 1][0] += spline0_roadk910bd;
        tb64 = t33b / h2_3;
        tb64d = (t33bd - tb64 * h2_3d) * (1.0 / h2_3);
        pb[t->roadadr[road] + t->roadn[road] + k9 + 1] += tb64;
        pbd[t->roadadr[road] + t->roadn[road] + k9 + 1] += tb64d;
        p7b -= tb64;
        p7bd -= tb64d;
        h2_3b -= tb64 * t33;
        h2_3bd -= tb64d * t33 + tb64 * t33d;
        pb[t->roadadr[road] + t->roadn[road] + k9] += p7b;
        pbd[t->roadadr[road] + t->roadn[road] + k9] += p7bd;
        xb += c5b;
        xbd += c5bd;
        p_roadk9b = -c5b;
        p_roadk9bd = -c5bd;
        p_roadk91b = a4b;
        p_roadk91bd = a4bd;
        xb -= a4b;
        xbd -= a4bd;
        p_roadk91b += h2_3b;
        p_roadk91bd += h2_3bd;
        p_roadk9b -= h2_3b;
        p_roadk9bd -= h2_3bd;
        pb[t->roadadr[road] + k9] += p_roadk9b;
        pbd[t->roadadr[road] + k9] += p_roadk9bd;
        pb[t->roadadr[road] + k9 + 1] += p_roadk91b;
        pbd[t->roadadr[road] + k9 + 1] += p_roadk91bd;
      }
    }
    g0b += xb;
    g0bd += xbd;
    t17b = xb * (g2 - h00);
    t17bd = xbd * (g2 - h00) + xb * (g2d - h00d);
    tb35 = xb * t17;
    tb35d = xbd * t17 + xb * t17d;
    g2b += tb35;
    g2bd += tb35d;
    h00b = -tb35;
    h00bd = -tb35d;
    tb34 = t17b / t16;
    tb34d = (t17bd - tb34 * t16d) * (1.0 / t16);
    u2_2b += tb34 * u0;
    u2_2bd += tb34d * u0 + tb34 * u0d;
    u0b += tb34 * u2_2;
    u0bd += tb34d * u2_2 + tb34 * u2_2d;
    t16b = -(tb34 * t17);
    t16bd = -(tb34d * t17 + tb34 * t17d);
    u0b += t16b * u0;
    u0bd += t16bd * u0 + t16b * u0d;
    u0b += t16b * u0;
    u0bd += t16bd * u0 + t16b * u0d;
    u1b += t16b * u1;
    u1bd += t16bd * u1 + t16b * u1d;
    u1b += t16b * u1;
    u1bd += t16bd * u1 + t16b * u1d;
    x2b = 0.0;
    x2bd = 0.0;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      p_roadd = pd[t->roadadr[road]];
      p_roadb = h00b * x2;
      p_roadbd = h00bd * x2 + h00b * x2d;
      x2b += h00b * p_road;
      x2bd += h00bd * p_road + h00b * p_roadd;
      h00b = 0.0;
      h00bd = 0.0;
      pb[t->roadadr[road]] += p_roadb;
      pbd[t->roadadr[road]] += p_roadbd;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k5 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      k5d = -(k5 * pd[t->roadadr[road] + 1] * (1.0 / p[t->roadadr[road] + 1]));
      t3 = k5 * x2;
      t3d = k5d * x2 + k5 * x2d;
      t4 = sin(t3);
      t4d = cos(t3) * t3d;
      p_road2 = p[t->roadadr[road]];
      p_road2d = pd[t->roadadr[road]];
      p_road2b = h00b * t4;
      p_road2bd = h00bd * t4 + h00b * t4d;
      t4b = h00b * p_road2;
      t4bd = h00bd * p_road2 + h00b * p_road2d;
      h00b = 0.0;
      h00bd = 0.0;
      pb[t->roadadr[road]] += p_road2b;
      pbd[t->roadadr[road]] += p_road2bd;
      t3b = t4b * cos(t3);
      t3bd = t4bd * cos(t3) - t4b * (sin(t3) * t3d);
      k5b = t3b * x2;
      k5bd = t3bd * x2 + t3b * x2d;
      x2b += t3b * k5;
      x2bd += t3bd * k5 + t3b * k5d;
      tb5 = k5b / p[t->roadadr[road] + 1];
      tb5d = (k5bd - tb5 * pd[t->roadadr[road] + 1]) * (1.0 / p[t->roadadr[road] + 1]);
      pb[t->roadadr[road] + 1] -= tb5 * k5;
      pbd[t->roadadr[road] + 1] -= tb5d * k5 + tb5 * k5d;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k4 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x2);
      x3 = x2 - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k4 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      x3d = x2d - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k4 * pd[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius = p[t->roadadr[road]];
      radiusd = pd[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      based = radiusd - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      t5d = radiusd * radius + radius * radiusd - (based * base + base * based);
      c2 = sqrt(t5);
      c2d = 1.0 / (2.0 * c2) * t5d;
      f = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      fd = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x3) > 0.0) {
        way = 1.0;
      } else {
        way = -1.0;
      }
      y = way * x3;
      yd = way * x3d;
      b20b = h00b;
      b20bd = h00bd;
      h00b = 0.0;
      h00bd = 0.0;
      baseb = 0.0;
      basebd = 0.0;
      c2b = 0.0;
      c2bd = 0.0;
      fb = 0.0;
      fbd = 0.0;
      radiusb = 0.0;
      radiusbd = 0.0;
      yb = 0.0;
      ybd = 0.0;
      if (MAGGI_RE(y) >= MAGGI_RE(c2 + f)) {
        b20b = 0.0;
        b20bd = 0.0;
      } else if (MAGGI_RE(y) > MAGGI_RE(c2 - f)) {
        t6 = radius * radius - (c2 - f) * (c2 - f);
        t6d = radiusd * radius + radius * radiusd - ((c2d - fd) * (c2 - f) + (c2 - f) * (c2d - fd));
        z2 = sqrt(t6);
        z2d = 1.0 / (2.0 * z2) * t6d;
        h0_2 = z2 - base;
        h0_2d = z2d - based;
        h1_2 = 2.0 * f * (c2 - f) / z2;
        h1_2d = (2.0 * fd * (c2 - f) + 2.0 * f * (c2d - fd) - h1_2 * z2d) * (1.0 / z2);
        a = 3.0 * h0_2 - h1_2;
        ad = 3.0 * h0_2d - h1_2d;
        t7 = z2 * z2 * z2;
        t7d = (z2d * z2 + z2 * z2d) * z2 + z2 * z2 * z2d;
        t8 = 2.0 * f * f * radius * radius / t7;
        t8d = (((2.0 * fd * f + 2.0 * f * fd) * radius + 2.0 * f * f * radiusd) * radius + 2.0 * f *
            f * radius * radiusd - t8 * t7d) * (1.0 / t7);
        b3 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        b3d = 6.0 * h0_2d - 3.0 * h1_2d - t8d;
        t9 = 2.0 * f;
        t9d = 2.0 * fd;
        u2 = (c2 + f - y) / t9;
        u2d = (c2d + fd - yd - u2 * t9d) * (1.0 / t9);
        w3 = 1.0 - u2;
        w3d = -u2d;
        tb15 = b20b * (h0_2 + w3 * (a + w3 * b3));
        tb15d = b20bd * (h0_2 + w3 * (a + w3 * b3)) + b20b * (h0_2d + (w3d * (a + w3 * b3) + w3 *
            (ad + (w3d * b3 + w3 * b3d))));
        tb16 = tb15 * u2;
        tb16d = tb15d * u2 + tb15 * u2d;
        u2b = tb16 * u2;
        u2bd = tb16d * u2 + tb16 * u2d;
        u2b += tb16 * u2;
        u2bd += tb16d * u2 + tb16 * u2d;
        u2b += tb15 * (u2 * u2);
        u2bd += tb15d * (u2 * u2) + tb15 * (u2d * u2 + u2 * u2d);
        tb17 = b20b * (u2 * u2 * u2);
        tb17d = b20bd * (u2 * u2 * u2) + b20b * ((u2d * u2 + u2 * u2d) * u2 + u2 * u2 * u2d);
        h0_2b = tb17;
        h0_2bd = tb17d;
        w3b = tb17 * (a + w3 * b3);
        w3bd = tb17d * (a + w3 * b3) + tb17 * (ad + (w3d * b3 + w3 * b3d));
        tb18 = tb17 * w3;
        tb18d = tb17d * w3 + tb17 * w3d;
        ab = tb18;
        abd = tb18d;
        w3b += tb18 * b3;
        w3bd += tb18d * b3 + tb18 * b3d;
        b3b = tb18 * w3;
        b3bd = tb18d * w3 + tb18 * w3d;
        b20b = 0.0;
        b20bd = 0.0;
        u2b -= w3b;
        u2bd -= w3bd;
        tb14 = u2b / t9;
        tb14d = (u2bd - tb14 * t9d) * (1.0 / t9);
        c2b += tb14;
        c2bd += tb14d;
        fb += tb14;
        fbd += tb14d;
        yb -= tb14;
        ybd -= tb14d;
        t9b = -(tb14 * u2);
        t9bd = -(tb14d * u2 + tb14 * u2d);
        fb += t9b * 2.0;
        fbd += t9bd * 2.0;
        h0_2b += b3b * 6.0;
        h0_2bd += b3bd * 6.0;
        h1_2b = -(b3b * 3.0);
        h1_2bd = -(b3bd * 3.0);
        t8b = -b3b;
        t8bd = -b3bd;
        tb11 = t8b / t7;
        tb11d = (t8bd - tb11 * t7d) * (1.0 / t7);
        tb12 = tb11 * radius;
        tb12d = tb11d * radius + tb11 * radiusd;
        tb13 = tb12 * radius;
        tb13d = tb12d * radius + tb12 * radiusd;
        fb += tb13 * f * 2.0;
        fbd += (tb13d * f + tb13 * fd) * 2.0;
        fb += tb13 * (2.0 * f);
        fbd += tb13d * (2.0 * f) + tb13 * (2.0 * fd);
        radiusb += tb12 * (2.0 * f * f);
        radiusbd += tb12d * (2.0 * f * f) + tb12 * (2.0 * fd * f + 2.0 * f * fd);
        radiusb += tb11 * (2.0 * f * f * radius);
        radiusbd += tb11d * (2.0 * f * f * radius) + tb11 * ((2.0 * fd * f + 2.0 * f * fd) * radius
            + 2.0 * f * f * radiusd);
        t7b = -(tb11 * t8);
        t7bd = -(tb11d * t8 + tb11 * t8d);
        tb10 = t7b * z2;
        tb10d = t7bd * z2 + t7b * z2d;
        z2b = tb10 * z2;
        z2bd = tb10d * z2 + tb10 * z2d;
        z2b += tb10 * z2;
        z2bd += tb10d * z2 + tb10 * z2d;
        z2b += t7b * (z2 * z2);
        z2bd += t7bd * (z2 * z2) + t7b * (z2d * z2 + z2 * z2d);
        h0_2b += ab * 3.0;
        h0_2bd += abd * 3.0;
        h1_2b -= ab;
        h1_2bd -= abd;
        tb8 = h1_2b / z2;
        tb8d = (h1_2bd - tb8 * z2d) * (1.0 / z2);
        fb += tb8 * (c2 - f) * 2.0;
        fbd += (tb8d * (c2 - f) + tb8 * (c2d - fd)) * 2.0;
        tb9 = tb8 * (2.0 * f);
        tb9d = tb8d * (2.0 * f) + tb8 * (2.0 * fd);
        c2b += tb9;
        c2bd += tb9d;
        fb -= tb9;
        fbd -= tb9d;
        z2b -= tb8 * h1_2;
        z2bd -= tb8d * h1_2 + tb8 * h1_2d;
        z2b += h0_2b;
        z2bd += h0_2bd;
        baseb -= h0_2b;
        basebd -= h0_2bd;
        t6b = z2b * (1.0 / (2.0 * z2));
        t6bd = z2bd * (1.0 / (2.0 * z2)) - z2b * (1.0 / (2.0 * z2) * (2.0 * z2d) / (2.0 * z2));
        radiusb += t6b * radius;
        radiusbd += t6bd * radius + t6b * radiusd;
        radiusb += t6b * radius;
        radiusbd += t6bd * radius + t6b * radiusd;
        tb6 = t6b * (c2 - f);
        tb6d = t6bd * (c2 - f) + t6b * (c2d - fd);
        c2b -= tb6;
        c2bd -= tb6d;
        fb += tb6;
        fbd += tb6d;
        tb7 = t6b * (c2 - f);
        tb7d = t6bd * (c2 - f) + t6b * (c2d - fd);
        c2b -= tb7;
        c2bd -= tb7d;
        fb += tb7;
        fbd += tb7d;
      } else {
        t10 = radius * radius - y * y;
        t10d = radiusd * radius + radius * radiusd - (yd * y + y * yd);
        z2_3 = sqrt(t10);
        z2_3d = 1.0 / (2.0 * z2_3) * t10d;
        z2_3b = b20b;
        z2_3bd = b20bd;
        baseb -= b20b;
        basebd -= b20bd;
        b20b = 0.0;
        b20bd = 0.0;
        t10b = z2_3b * (1.0 / (2.0 * z2_3));
        t10bd = z2_3bd * (1.0 / (2.0 * z2_3)) - z2_3b * (1.0 / (2.0 * z2_3) * (2.0 * z2_3d) / (2.0 *
            z2_3));
        radiusb += t10b * radius;
        radiusbd += t10bd * radius + t10b * radiusd;
        radiusb += t10b * radius;
        radiusbd += t10bd * radius + t10b * radiusd;
        yb -= t10b * y;
        ybd -= t10bd * y + t10b * yd;
        yb -= t10b * y;
        ybd -= t10bd * y + t10b * yd;
      }
      x3b = yb * way;
      x3bd = ybd * way;
      pb[t->roadadr[road] + MAGGI_BUMPS_FILLET] += fb * 0.5;
      pbd[t->roadadr[road] + MAGGI_BUMPS_FILLET] += fbd * 0.5;
      t5b = c2b * (1.0 / (2.0 * c2));
      t5bd = c2bd * (1.0 / (2.0 * c2)) - c2b * (1.0 / (2.0 * c2) * (2.0 * c2d) / (2.0 * c2));
      radiusb += t5b * radius;
      radiusbd += t5bd * radius + t5b * radiusd;
      radiusb += t5b * radius;
      radiusbd += t5bd * radius + t5b * radiusd;
      baseb -= t5b * base;
      basebd -= t5bd * base + t5b * based;
      baseb -= t5b * base;
      basebd -= t5bd * base + t5b * based;
      radiusb += baseb;
      radiusbd += basebd;
      pb[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= baseb;
      pbd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= basebd;
      pb[t->roadadr[road]] += radiusb;
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      pbd[t->roadadr[road]] += radiusbd;
      x2b += x3b;
      x2bd += x3bd;
      pb[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x3b;
      pbd[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x3bd;
      pb[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x3b * k4;
      pbd[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x3bd * k4;
    } else {
      k6 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x2);
      s20b = h00b;
      s20bd = h00bd;
      h00b = 0.0;
      h00bd = 0.0;
      if (k6 < 0) {
        p_road3 = p[t->roadadr[road]];
        p_road3d = pd[t->roadadr[road]];
        h = p[t->roadadr[road] + 1] - p_road3;
        hd = pd[t->roadadr[road] + 1] - p_road3d;
        p_roadroad = p[t->roadadr[road] + t->roadn[road]];
        p_roadroadd = pd[t->roadadr[road] + t->roadn[road]];
        t11 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad) / h;
        t11d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroadd - t11 * hd) * (1.0 / h);
        slope = t11 - h / 6.0 * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road]
            + 1][0]);
        sloped = t11d - (hd / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]) + h / 6.0 * (2.0 * spline0d[t->roadspline[road]][0]
            + spline0d[t->roadspline[road] + 1][0]));
        p_roadroadb = s20b;
        p_roadroadbd = s20bd;
        slopeb = s20b * (x2 - p_road3);
        slopebd = s20bd * (x2 - p_road3) + s20b * (x2d - p_road3d);
        tb21 = s20b * slope;
        tb21d = s20bd * slope + s20b * sloped;
        x2b += tb21;
        x2bd += tb21d;
        p_road3b = -tb21;
        p_road3bd = -tb21d;
        s20b = 0.0;
        s20bd = 0.0;
        t11b = slopeb;
        t11bd = slopebd;
        hb = -(slopeb * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) / 6.0);
        hbd = -((slopebd * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) + slopeb * (2.0 * spline0d[t->roadspline[road]][0] + spline0d[t->roadspline[road]
            + 1][0])) / 6.0);
        tb20 = slopeb * (h / 6.0);
        tb20d = slopebd * (h / 6.0) + slopeb * (hd / 6.0);
        spline0b[t->roadspline[road]][0] -= tb20 * 2.0;
        spline0bd[t->roadspline[road]][0] -= tb20d * 2.0;
        spline0b[t->roadspline[road] + 1][0] -= tb20;
        spline0bd[t->roadspline[road] + 1][0] -= tb20d;
        tb19 = t11b / h;
        tb19d = (t11bd - tb19 * hd) * (1.0 / h);
        pb[t->roadadr[road] + t->roadn[road] + 1] += tb19;
        pbd[t->roadadr[road] + t->roadn[road] + 1] += tb19d;
        p_roadroadb -= tb19;
        p_roadroadbd -= tb19d;
        hb -= tb19 * t11;
        hbd -= tb19d * t11 + tb19 * t11d;
        pb[t->roadadr[road] + t->roadn[road]] += p_roadroadb;
        pbd[t->roadadr[road] + t->roadn[road]] += p_roadroadbd;
        pb[t->roadadr[road] + 1] += hb;
        pbd[t->roadadr[road] + 1] += hbd;
        p_road3b -= hb;
        p_road3bd -= hbd;
        pb[t->roadadr[road]] += p_road3b;
        pbd[t->roadadr[road]] += p_road3bd;
      } else if (k6 > t->roadn[road] - 2) {
        p2 = p[t->roadadr[road] + t->roadn[road] - 1];
        p2d = pd[t->roadadr[road] + t->roadn[road] - 1];
        h3 = p2 - p[t->roadadr[road] + t->roadn[road] - 2];
        h3d = p2d - pd[t->roadadr[road] + t->roadn[road] - 2];
        p3 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        p3d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t12 = (p3 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h3;
        t12d = (p3d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t12 * h3d) * (1.0
            / h3);
        slope3 = t12 + h3 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        slope3d = t12d + (h3d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h3 / 6.0 *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0]));
        p3b = s20b;
        p3bd = s20bd;
        slope3b = s20b * (x2 - p2);
        slope3bd = s20bd * (x2 - p2) + s20b * (x2d - p2d);
        tb24 = s20b * slope3;
        tb24d = s20bd * slope3 + s20b * slope3d;
        x2b += tb24;
        x2bd += tb24d;
        p2b = -tb24;
        p2bd = -tb24d;
        s20b = 0.0;
        s20bd = 0.0;
        t12b = slope3b;
        t12bd = slope3bd;
        h3b = slope3b * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) / 6.0;
        h3bd = (slope3bd * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + slope3b *
            (spline0d[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0d[t->roadspline[road] + t->roadn[road] - 1][0])) / 6.0;
        tb23 = slope3b * (h3 / 6.0);
        tb23d = slope3bd * (h3 / 6.0) + slope3b * (h3d / 6.0);
        spline0b[t->roadspline[road] + t->roadn[road] - 2][0] += tb23;
        spline0bd[t->roadspline[road] + t->roadn[road] - 2][0] += tb23d;
        spline0b[t->roadspline[road] + t->roadn[road] - 1][0] += tb23 * 2.0;
        spline0bd[t->roadspline[road] + t->roadn[road] - 1][0] += tb23d * 2.0;
        tb22 = t12b / h3;
        tb22d = (t12bd - tb22 * h3d) * (1.0 / h3);
        p3b += tb22;
        p3bd += tb22d;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb22;
        pbd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb22d;
        h3b -= tb22 * t12;
        h3bd -= tb22d * t12 + tb22 * t12d;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p3b;
        pbd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p3bd;
        p2b += h3b;
        p2bd += h3bd;
        pb[t->roadadr[road] + t->roadn[road] - 2] -= h3b;
        pbd[t->roadadr[road] + t->roadn[road] - 2] -= h3bd;
        pb[t->roadadr[road] + t->roadn[road] - 1] += p2b;
        pbd[t->roadadr[road] + t->roadn[road] - 1] += p2bd;
      } else {
        p_roadk61 = p[t->roadadr[road] + k6 + 1];
        p_roadk61d = pd[t->roadadr[road] + k6 + 1];
        p_roadk6 = p[t->roadadr[road] + k6];
        p_roadk6d = pd[t->roadadr[road] + k6];
        h3_2 = p_roadk61 - p_roadk6;
        h3_2d = p_roadk61d - p_roadk6d;
        a2 = p_roadk61 - x2;
        a2d = p_roadk61d - x2d;
        c3 = x2 - p_roadk6;
        c3d = x2d - p_roadk6d;
        p4 = p[t->roadadr[road] + t->roadn[road] + k6];
        p4d = pd[t->roadadr[road] + t->roadn[road] + k6];
        t13 = (p[t->roadadr[road] + t->roadn[road] + k6 + 1] - p4) / h3_2;
        t13d = (pd[t->roadadr[road] + t->roadn[road] + k6 + 1] - p4d - t13 * h3_2d) * (1.0 / h3_2);
        spline0_roadk610 = spline0[t->roadspline[road] + k6 + 1][0];
        spline0_roadk610d = spline0d[t->roadspline[road] + k6 + 1][0];
        spline0_roadk60 = spline0[t->roadspline[road] + k6][0];
        spline0_roadk60d = spline0d[t->roadspline[road] + k6][0];
        e = t13 - h3_2 / 6.0 * (spline0_roadk610 - spline0_roadk60);
        ed = t13d - (h3_2d / 6.0 * (spline0_roadk610 - spline0_roadk60) + h3_2 / 6.0 *
            (spline0_roadk610d - spline0_roadk60d));
        t14 = 6.0 * h3_2;
        t14d = 6.0 * h3_2d;
        t15 = (spline0_roadk60 * a2 * a2 * a2 + spline0_roadk610 * c3 * c3 * c3) / t14;
        t15d = (((spline0_roadk60d * a2 + spline0_roadk60 * a2d) * a2 + spline0_roadk60 * a2 * a2d)
            * a2 + spline0_roadk60 * a2 * a2 * a2d + (((spline0_roadk610d * c3 + spline0_roadk610 *
            c3d) * c3 + spline0_roadk610 * c3 * c3d) * c3 + spline0_roadk610 * c3 * c3 * c3d) - t15
            * t14d) * (1.0 / t14);
        t15b = s20b;
        t15bd = s20bd;
        p4b = s20b;
        p4bd = s20bd;
        tb32 = s20b / 6.0;
        tb32d = s20bd / 6.0;
        tb33 = tb32 * h3_2;
        tb33d = tb32d * h3_2 + tb32 * h3_2d;
        spline0_roadk60b = -(tb33 * h3_2);
        spline0_roadk60bd = -(tb33d * h3_2 + tb33 * h3_2d);
        h3_2b = -(tb33 * spline0_roadk60);
        h3_2bd = -(tb33d * spline0_roadk60 + tb33 * spline0_roadk60d);
        h3_2b -= tb32 * (spline0_roadk60 * h3_2);
        h3_2bd -= tb32d * (spline0_roadk60 * h3_2) + tb32 * (spline0_roadk60d * h3_2 +
            spline0_roadk60 * h3_2d);
        eb = s20b * c3;
        ebd = s20bd * c3 + s20b * c3d;
        c3b = s20b * e;
        c3bd = s20bd * e + s20b * ed;
        s20b = 0.0;
        s20bd = 0.0;
        tb27 = t15b / t14;
        tb27d = (t15bd - tb27 * t14d) * (1.0 / t14);
        tb28 = tb27 * a2;
        tb28d = tb27d * a2 + tb27 * a2d;
        tb29 = tb28 * a2;
        tb29d = tb28d * a2 + tb28 * a2d;
        spline0_roadk60b += tb29 * a2;
        spline0_roadk60bd += tb29d * a2 + tb29 * a2d;
        a2b = tb29 * spline0_roadk60;
        a2bd = tb29d * spline0_roadk60 + tb29 * spline0_roadk60d;
        a2b += tb28 * (spline0_roadk60 * a2);
        a2bd += tb28d * (spline0_roadk60 * a2) + tb28 * (spline0_roadk60d * a2 + spline0_roadk60 *
            a2d);
        a2b += tb27 * (spline0_roadk60 * a2 * a2);
        a2bd += tb27d * (spline0_roadk60 * a2 * a2) + tb27 * ((spline0_roadk60d * a2 +
            spline0_roadk60 * a2d) * a2 + spline0_roadk60 * a2 * a2d);
        tb30 = tb27 * c3;
        tb30d = tb27d * c3 + tb27 * c3d;
        tb31 = tb30 * c3;
        tb31d = tb30d * c3 + tb30 * c3d;
        spline0_roadk610b = tb31 * c3;
        spline0_roadk610bd = tb31d * c3 + tb31 * c3d;
        c3b += tb31 * spline0_roadk610;
        c3bd += tb31d * spline0_roadk610 + tb31 * spline0_roadk610d;
        c3b += tb30 * (spline0_roadk610 * c3);
        c3bd += tb30d * (spline0_roadk610 * c3) + tb30 * (spline0_roadk610d * c3 + spline0_roadk610
            * c3d);
        c3b += tb27 * (spline0_roadk610 * c3 * c3);
        c3bd += tb27d * (spline0_roadk610 * c3 * c3) + tb27 * ((spline0_roadk610d * c3 +
            spline0_roadk610 * c3d) * c3 + spline0_roadk610 * c3 * c3d);
        t14b = -(tb27 * t15);
        t14bd = -(tb27d * t15 + tb27 * t15d);
        h3_2b += t14b * 6.0;
        h3_2bd += t14bd * 6.0;
        t13b = eb;
        t13bd = ebd;
        h3_2b -= eb * (spline0_roadk610 - spline0_roadk60) / 6.0;
        h3_2bd -= (ebd * (spline0_roadk610 - spline0_roadk60) + eb * (spline0_roadk610d -
            spline0_roadk60d)) / 6.0;
        tb26 = eb * (h3_2 / 6.0);
        tb26d = ebd * (h3_2 / 6.0) + eb * (h3_2d / 6.0);
        spline0_roadk610b -= tb26;
        spline0_roadk610bd -= tb26d;
        spline0_roadk60b += tb26;
        spline0_roadk60bd += tb26d;
        spline0b[t->roadspline[road] + k6][0] += spline0_roadk60b;
        spline0bd[t->roadspline[road] + k6][0] += spline0_roadk60bd;
        spline0b[t->roadspline[road] + k6 + 1][0] += spline0_roadk610b;
        spline0bd[t->roadspline[road] + k6 + 1][0] += spline0_roadk610bd;
        tb25 = t13b / h3_2;
        tb25d = (t13bd - tb25 * h3_2d) * (1.0 / h3_2);
        pb[t->roadadr[road] + t->roadn[road] + k6 + 1] += tb25;
        pbd[t->roadadr[road] + t->roadn[road] + k6 + 1] += tb25d;
        p4b -= tb25;
        p4bd -= tb25d;
        h3_2b -= tb25 * t13;
        h3_2bd -= tb25d * t13 + tb25 * t13d;
        pb[t->roadadr[road] + t->roadn[road] + k6] += p4b;
        pbd[t->roadadr[road] + t->roadn[road] + k6] += p4bd;
        x2b += c3b;
        x2bd += c3bd;
        p_roadk6b = -c3b;
        p_roadk6bd = -c3bd;
        p_roadk61b = a2b;
        p_roadk61bd = a2bd;
        x2b -= a2b;
        x2bd -= a2bd;
        p_roadk61b += h3_2b;
        p_roadk61bd += h3_2bd;
        p_roadk6b -= h3_2b;
        p_roadk6bd -= h3_2bd;
        pb[t->roadadr[road] + k6] += p_roadk6b;
        pbd[t->roadadr[road] + k6] += p_roadk6bd;
        pb[t->roadadr[road] + k6 + 1] += p_roadk61b;
        pbd[t->roadadr[road] + k6 + 1] += p_roadk61bd;
      }
    }
    g0b += x2b;
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n|, slope that the plane lacks */
    g0bd += x2bd;
    rb[t->wheelpoint[i]][2] += g2b;
    rbd[t->wheelpoint[i]][2] += g2bd;
    rb[t->roadpoint[road]][2] -= g2b;
    rbd[t->roadpoint[road]][2] -= g2bd;
    rb[t->wheelpoint[i]][0] += g0b;
    rbd[t->wheelpoint[i]][0] += g0bd;
    rb[t->roadpoint[road]][0] -= g0b;
    rbd[t->roadpoint[road]][0] -= g0bd;
    tb4 = u2_2b / n2;
    tb4d = (u2_2bd - tb4 * n2d) * (1.0 / n2);
    ua2b = tb4;
    ua2bd = tb4d;
    n2b = -(tb4 * u2_2);
    n2bd = -(tb4d * u2_2 + tb4 * u2_2d);
    tb3 = u1b / n2;
    tb3d = (u1bd - tb3 * n2d) * (1.0 / n2);
    ua1b = tb3;
    ua1bd = tb3d;
    n2b -= tb3 * u1;
    n2bd -= tb3d * u1 + tb3 * u1d;
    tb2 = u0b / n2;
    tb2d = (u0bd - tb2 * n2d) * (1.0 / n2);
    ua0b = tb2;
    ua0bd = tb2d;
    n2b -= tb2 * u0;
    n2bd -= tb2d * u0 + tb2 * u0d;
    t2b = n2b * (1.0 / (2.0 * n2));
    t2bd = n2bd * (1.0 / (2.0 * n2)) - n2b * (1.0 / (2.0 * n2) * (2.0 * n2d) / (2.0 * n2));
    ua0b += t2b * ua0;
    ua0bd += t2bd * ua0 + t2b * ua0d;
    ua0b += t2b * ua0;
    ua0bd += t2bd * ua0 + t2b * ua0d;
    ua1b += t2b * ua1;
    ua1bd += t2bd * ua1 + t2b * ua1d;
    ua1b += t2b * ua1;
    ua1bd += t2bd * ua1 + t2b * ua1d;
    ua2b += t2b * ua2;
    ua2bd += t2bd * ua2 + t2b * ua2d;
    ua2b += t2b * ua2;
    ua2bd += t2bd * ua2 + t2b * ua2d;
    Ab[t->wheelbody[i]][6] += ua2b * axis0;
    Abd[t->wheelbody[i]][6] += ua2bd * axis0 + ua2b * axis0d;
    axis0b = ua2b * A[t->wheelbody[i]][6];
    axis0bd = ua2bd * A[t->wheelbody[i]][6] + ua2b * Ad[t->wheelbody[i]][6];
    Ab[t->wheelbody[i]][7] += ua2b * axis1;
    Abd[t->wheelbody[i]][7] += ua2bd * axis1 + ua2b * axis1d;
    axis1b = ua2b * A[t->wheelbody[i]][7];
    axis1bd = ua2bd * A[t->wheelbody[i]][7] + ua2b * Ad[t->wheelbody[i]][7];
    Ab[t->wheelbody[i]][8] += ua2b * axis2;
    Abd[t->wheelbody[i]][8] += ua2bd * axis2 + ua2b * axis2d;
    axis2b = ua2b * A[t->wheelbody[i]][8];
    axis2bd = ua2bd * A[t->wheelbody[i]][8] + ua2b * Ad[t->wheelbody[i]][8];
    Ab[t->wheelbody[i]][3] += ua1b * axis0;
    Abd[t->wheelbody[i]][3] += ua1bd * axis0 + ua1b * axis0d;
    axis0b += ua1b * A[t->wheelbody[i]][3];
    axis0bd += ua1bd * A[t->wheelbody[i]][3] + ua1b * Ad[t->wheelbody[i]][3];
    Ab[t->wheelbody[i]][4] += ua1b * axis1;
    Abd[t->wheelbody[i]][4] += ua1bd * axis1 + ua1b * axis1d;
    axis1b += ua1b * A[t->wheelbody[i]][4];
    axis1bd += ua1bd * A[t->wheelbody[i]][4] + ua1b * Ad[t->wheelbody[i]][4];
    Ab[t->wheelbody[i]][5] += ua1b * axis2;
    Abd[t->wheelbody[i]][5] += ua1bd * axis2 + ua1b * axis2d;
    axis2b += ua1b * A[t->wheelbody[i]][5];
    axis2bd += ua1bd * A[t->wheelbody[i]][5] + ua1b * Ad[t->wheelbody[i]][5];
    Ab[t->wheelbody[i]][0] += ua0b * axis0;
    Abd[t->wheelbody[i]][0] += ua0bd * axis0 + ua0b * axis0d;
    axis0b += ua0b * A[t->wheelbody[i]][0];
    axis0bd += ua0bd * A[t->wheelbody[i]][0] + ua0b * Ad[t->wheelbody[i]][0];
    Ab[t->wheelbody[i]][1] += ua0b * axis1;
    Abd[t->wheelbody[i]][1] += ua0bd * axis1 + ua0b * axis1d;
    axis1b += ua0b * A[t->wheelbody[i]][1];
    axis1bd += ua0bd * A[t->wheelbody[i]][1] + ua0b * Ad[t->wheelbody[i]][1];
    Ab[t->wheelbody[i]][2] += ua0b * axis2;
    Abd[t->wheelbody[i]][2] += ua0bd * axis2 + ua0b * axis2d;
    axis2b += ua0b * A[t->wheelbody[i]][2];
    axis2bd += ua0bd * A[t->wheelbody[i]][2] + ua0b * Ad[t->wheelbody[i]][2];
    pb[t->wheelaxis[i] + 2] += axis2b;
    pbd[t->wheelaxis[i] + 2] += axis2bd;
    pb[t->wheelaxis[i] + 1] += axis1b;
    pbd[t->wheelaxis[i] + 1] += axis1bd;
    pb[t->wheelaxis[i]] += axis0b;
    pbd[t->wheelaxis[i]] += axis0bd;
  }
}
