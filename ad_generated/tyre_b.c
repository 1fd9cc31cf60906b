/* Adjoint of core/kernel/tyre.c.
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
void maggi_wheel_forces_b(const maggi_topo *t, const double p[restrict t->np],
                          double pb[restrict t->np], const double spline0[restrict t->nspline][3],
                          double spline0b[restrict t->nspline][3],
                          const double A[restrict t->nbody + 1][9],
                          double Ab[restrict t->nbody + 1][9],
                          const double Z[restrict t->nbody + 1][6],
                          double Zb[restrict t->nbody + 1][6],
                          const double r[restrict t->npoint][3], double rb[restrict t->npoint][3],
                          const double rv[restrict t->npoint][3], double rvb[restrict t->npoint][3],
                          double slip[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                          double slipb[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                          double f[restrict t->nwheel][6], double fb[restrict t->nwheel][6],
                          double F[restrict t->nwheel][6], double Fb[restrict t->nwheel][6])
{
  int i, k3, k5, k6, k8, k9, k9_2, road;
  double L0, L0b, L1, L1b, L2, L2b, N0, N0b, N1, N2, N2b, T0, T0b, T1, T1b, T2, T2b, Z_i3, Z_i3b,
      Z_i4, Z_i4b, Z_i5, Z_i5b, a, a2, a2b, a3, a3b, a4, a4b, a5, a5b, ab, along0, along0b, along1,
      along1b, along2, along2b, ar, arb, areq, areqb, arm0, arm0b, arm1, arm1b, arm2, arm2b, at,
      atb, ateq, ateqb, axis0, axis0b, axis1, axis1b, axis2, axis2b, ay, ayb, b0, b0b, b2, b2b, b30,
      b30b, b31, b31b, b4, b4b, base, base2, base2b, baseb, br, brb, bt, btb, c, c2, c2b, c3, c3b,
      c4, c4b, c5, c5b, ca, cab, cb, dfz, dfzb, dr, drb, dt, dtb, dv, dvb, e, e10, e10b, e11, e11b,
      e2, e2b, e3, e3b, e4, e4b, e5, e5b, e6, e6b, e7, e7b, e8, e8b, e9, e9b, eb, et, etb, ex, exb,
      ey, eyb, f2, f2b, f3, f3b, f_i0, f_i0b, f_i1, f_i1b, f_i2, f_i2b, f_i3, f_i3b, f_i4, f_i4b,
      f_i5, f_i5b, force0b, force1b, force2, force2_2b, force2b, force30, force30b, force31,
      force31b, force32, force32b, force3_2b, force4b, force5b, fx, fxb, fy, fyb, fz, fz0, fz0_2,
      fz0_2b, fz0_3, fz0_3b, fz0_4, fz0_4b, fz0b, fz2, fz2b, fzb, g0, g0b, g20, g20b, g21, g21b,
      g22, g22b, g23, g23b, g24, g24b, g25, g25b, g26, g26b, g27, g27b, g28, g28b, g2_2, g2_2b,
      gamma, gammab, gx, gxb, gy, gyb, gz, gzb, h, h00, h00b, h0_2, h0_2b, h0_3, h0_3b, h10, h10b,
      h11, h11b, h12, h12b, h1_2, h1_2b, h1_3, h1_3b, h2, h2_2, h2_2b, h2_3, h2_3b, h2b, h3, h3_2,
      h3_2b, h3b, hb, k4, k4b, k7, k7b, kappa, kappab, kx, kxb, moment0b, moment1b, moment2b, mux,
      muxb, muy, muyb, n2, n2b, normal0, normal0b, normal1, normal2, normal2b, omega, omegab, one0,
      one0b, one1, one1b, one2, one2b, one3, one3b, one4, one4b, p10, p10b, p2, p2b, p3, p3b, p4,
      p4b, p5, p5b, p6, p6b, p7, p7b, p8, p8b, p9, p9b, p_road, p_road2, p_road2b, p_road3,
      p_road3b, p_road4, p_road4b, p_road5, p_road5b, p_road6, p_road6b, p_roadb, p_roadk5,
      p_roadk51, p_roadk51b, p_roadk5b, p_roadk8, p_roadk81, p_roadk81b, p_roadk8b, p_roadroad,
      p_roadroad2, p_roadroad2b, p_roadroadb, peak, peakb, r0, r0b, r2, r2b, r30, r30b, r31, r31b,
      r32, r32b, radius, radius2, radius2b, radiusb, ratio, ratio2, ratio2b, ratiob, re, re2, re2b,
      reb, rhov, rhovb, s, s20, s20b, s30, s30b, s31, s31b, s4, s4b, sb, scale, scaleb, side, slope,
      slope2, slope2_2, slope2_2b, slope2b, slope3, slope3b, slopeb, speed, speed2, speed2b, speedb,
      spline0_roadk50, spline0_roadk50b, spline0_roadk510, spline0_roadk510b, spline0_roadk80,
      spline0_roadk80b, spline0_roadk810, spline0_roadk810b, t10, t100, t100b, t101, t101b, t102,
      t102b, t103, t103b, t104, t104b, t105, t105b, t106, t106b, t107, t107b, t108, t108b, t109,
      t109b, t10b, t11, t110, t110b, t111, t111b, t112, t112b, t113, t113b, t114, t114b, t115,
      t115b, t116, t116b, t117, t117b, t118, t118b, t119, t119b, t11b, t12, t120, t120b, t121b,
      t12b, t13, t13b, t14, t14b, t15, t15b, t16, t16b, t17, t17b, t18, t18b, t19, t19b, t2, t20,
      t20b, t21, t21b, t22, t22b, t23, t23b, t24, t24b, t25, t25b, t26, t26b, t27, t27b, t28, t28b,
      t29, t29b, t2b, t3, t30, t30b, t31, t31b, t32, t32b, t33, t33b, t34, t34b, t35, t35b, t36,
      t36b, t37, t37b, t38, t38b, t39, t39b, t3b, t4, t40, t40b, t41, t41b, t42, t42b, t43, t43b,
      t44, t44b, t45, t45b, t46, t46b, t47, t47b, t48, t48b, t49, t49b, t4b, t5, t50, t50b, t51,
      t51b, t52, t52b, t53, t53b, t54, t54b, t55, t55b, t56, t56b, t57, t57b, t58, t58b, t59, t59b,
      t5b, t6, t60, t60b, t61, t61b, t62, t62b, t63, t63b, t64, t64b, t65, t65b, t66, t66b, t67,
      t67b, t68, t68b, t69, t69b, t6b, t7, t70, t70b, t71, t71b, t72, t72b, t73, t73b, t74, t74b,
      t75, t75b, t76, t76b, t77, t77b, t78, t78b, t79, t79b, t7b, t8, t80, t80b, t81, t81b, t82,
      t82b, t83, t83b, t84, t84b, t85, t85b, t86, t86b, t87, t87b, t88, t88b, t89, t89b, t8b, t9,
      t90, t90b, t91, t91b, t92, t92b, t93, t93b, t94, t94b, t95, t95b, t96, t96b, t97, t97b, t98,
      t98b, t99, t99b, t9b, tb10, tb100, tb101, tb102, tb103, tb104, tb105, tb106, tb107, tb108,
      tb109, tb11, tb110, tb111, tb112, tb113, tb114, tb115, tb116, tb117, tb118, tb119, tb12,
      tb120, tb121, tb122, tb123, tb124, tb125, tb126, tb127, tb128, tb129, tb13, tb130, tb131,
      tb132, tb133, tb134, tb135, tb136, tb137, tb138, tb139, tb14, tb140, tb141, tb142, tb143,
      tb144, tb145, tb146, tb147, tb148, tb149, tb15, tb150, tb151, tb152, tb153, tb154, tb155,
      tb156, tb157, tb158, tb159, tb16, tb160, tb161, tb162, tb163, tb164, tb165, tb166, tb167,
      tb168, tb169, tb17, tb170, tb171, tb172, tb173, tb174, tb175, tb176, tb177, tb178, tb179,
      tb18, tb180, tb181, tb182, tb183, tb184, tb185, tb186, tb187, tb188, tb189, tb19, tb190,
      tb191, tb192, tb193, tb194, tb195, tb196, tb197, tb198, tb199, tb2, tb20, tb200, tb201, tb202,
      tb203, tb204, tb205, tb206, tb207, tb208, tb209, tb21, tb22, tb23, tb24, tb25, tb26, tb27,
      tb28, tb29, tb3, tb30, tb31, tb32, tb33, tb34, tb35, tb36, tb37, tb38, tb39, tb4, tb40, tb41,
      tb42, tb43, tb44, tb45, tb46, tb47, tb48, tb49, tb5, tb50, tb51, tb52, tb53, tb54, tb55, tb56,
      tb57, tb58, tb59, tb6, tb60, tb61, tb62, tb63, tb64, tb65, tb66, tb67, tb68, tb69, tb7, tb70,
      tb71, tb72, tb73, tb74, tb75, tb76, tb77, tb78, tb79, tb8, tb80, tb81, tb82, tb83, tb84, tb85,
      tb86, tb87, tb88, tb89, tb9, tb90, tb91, tb92, tb93, tb94, tb95, tb96, tb97, tb98, tb99, u0,
      u0b, u1, u1b, u2, u2_2, u2_2b, u2b, u3, u3b, ua0, ua0b, ua1, ua1b, ua2, ua2b, un0, un0b, un1,
      un1b, un2, un2b, v0, v0b, v1, v1b, v2, v2b, vr0, vr0b, vr1, vr1b, vr2, vr2b, vx, vxb, w, w2,
      w2b, w3, w3b, way, way2, way3, way3b, wb, wr0, wr0b, wr1, wr1b, wr2, wr2b, x, x2, x2b, x3,
      x3b, x4, x4b, x50, x50b, x51, x51b, x52, x52b, x53, x53b, x54, x54b, x55, x55b, x6, x6b, x7,
      x7b, x8, x8b, x9, x9b, xb, y, y10, y10b, y11, y11b, y12, y12b, y13, y13b, y14, y14b, y15,
      y15b, y16, y16b, y17, y17b, y18, y18b, y19, y19b, y2, y20, y20b, y2b, y3, y3b, y40, y40b, y41,
      y41b, y42, y42b, y43, y43b, y44, y44b, y45, y45b, y5, y5b, y6, y6b, y7, y7b, y8, y8b, y9, y9b,
      yb, z0, z0b, z1, z1b, z2, z2_2, z2_2b, z2_3, z2_3b, z2b, z3, z3_2, z3_2b, z3_3, z3_3b, z3b,
      z40, z40b, z41b, z5, z5b, z6, z6b, z7, z7b;

  for (i = t->nwheel - 1; i >= 0; --i) {
    road = t->wheelroad[i];
    axis0 = p[t->wheelaxis[i]];
    axis1 = p[t->wheelaxis[i] + 1];
    axis2 = p[t->wheelaxis[i] + 2];
    ua0 = A[t->wheelbody[i]][0] * axis0 + A[t->wheelbody[i]][1] * axis1 + A[t->wheelbody[i]][2] *
        axis2;
    ua1 = A[t->wheelbody[i]][3] * axis0 + A[t->wheelbody[i]][4] * axis1 + A[t->wheelbody[i]][5] *
        axis2;
    ua2 = A[t->wheelbody[i]][6] * axis0 + A[t->wheelbody[i]][7] * axis1 + A[t->wheelbody[i]][8] *
        axis2;
    t2 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
    n2 = sqrt(t2);
    u0 = ua0 / n2;
    u1 = ua1 / n2;
    u2_2 = ua2 / n2;
    g0 = r[t->wheelpoint[i]][0] - r[t->roadpoint[road]][0];
    g2_2 = r[t->wheelpoint[i]][2] - r[t->roadpoint[road]][2];
    x2 = g0;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      h00 = p_road * x2;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k4 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      t3 = k4 * x2;
      t4 = sin(t3);
      p_road2 = p[t->roadadr[road]];
      h00 = p_road2 * t4;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k3 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x2);
      x3 = x2 - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k3 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius = p[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      c2 = sqrt(t5);
      f2 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x3) > 0.0) {
        way = 1.0;
      } else {
        way = -1.0;
      }
      y = way * x3;
      if (MAGGI_RE(y) >= MAGGI_RE(c2 + f2)) {
        b0 = 0.0;
      } else if (MAGGI_RE(y) > MAGGI_RE(c2 - f2)) {
        t6 = radius * radius - (c2 - f2) * (c2 - f2);
        z2 = sqrt(t6);
        h0_2 = z2 - base;
        h1_2 = 2.0 * f2 * (c2 - f2) / z2;
        a = 3.0 * h0_2 - h1_2;
        t7 = z2 * z2 * z2;
        t8 = 2.0 * f2 * f2 * radius * radius / t7;
        b2 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        t9 = 2.0 * f2;
        u2 = (c2 + f2 - y) / t9;
        w2 = 1.0 - u2;
        b0 = u2 * u2 * u2 * (h0_2 + w2 * (a + w2 * b2));
      } else {
        t10 = radius * radius - y * y;
        z2_3 = sqrt(t10);
        b0 = z2_3 - base;
      }
      h00 = b0;
    } else {
      k5 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x2);
      if (k5 < 0) {
        p_road3 = p[t->roadadr[road]];
        h = p[t->roadadr[road] + 1] - p_road3;
        p_roadroad = p[t->roadadr[road] + t->roadn[road]];
        t11 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad) / h;
        slope = t11 - h / 6.0 * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road]
            + 1][0]);
        s20 = p_roadroad + slope * (x2 - p_road3);
      } else if (k5 > t->roadn[road] - 2) {
        p2 = p[t->roadadr[road] + t->roadn[road] - 1];
        h3 = p2 - p[t->roadadr[road] + t->roadn[road] - 2];
        p3 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t12 = (p3 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h3;
        slope3 = t12 + h3 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        s20 = p3 + slope3 * (x2 - p2);
      } else {
        p_roadk51 = p[t->roadadr[road] + k5 + 1];
        p_roadk5 = p[t->roadadr[road] + k5];
        h3_2 = p_roadk51 - p_roadk5;
        a2 = p_roadk51 - x2;
        c3 = x2 - p_roadk5;
        p4 = p[t->roadadr[road] + t->roadn[road] + k5];
        t13 = (p[t->roadadr[road] + t->roadn[road] + k5 + 1] - p4) / h3_2;
        spline0_roadk510 = spline0[t->roadspline[road] + k5 + 1][0];
        spline0_roadk50 = spline0[t->roadspline[road] + k5][0];
        e = t13 - h3_2 / 6.0 * (spline0_roadk510 - spline0_roadk50);
        t14 = 6.0 * h3_2;
        t15 = (spline0_roadk50 * a2 * a2 * a2 + spline0_roadk510 * c3 * c3 * c3) / t14;
        s20 = t15 + p4 - spline0_roadk50 * h3_2 * h3_2 / 6.0 + e * c3;
      }
      h00 = s20;
    }
    t16 = u0 * u0 + u1 * u1;
    t17 = u2_2 * u0 / t16;
    x = g0 + t17 * (g2_2 - h00);
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road4 = p[t->roadadr[road]];
      h10 = p_road4 * x;
      h11 = p_road4;
      h12 = 0.0;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k7 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      t18 = k7 * x;
      t19 = sin(t18);
      p_road5 = p[t->roadadr[road]];
      h10 = p_road5 * t19;
      t20 = k7 * x;
      t21 = cos(t20);
      h11 = k7 * p_road5 * t21;
      h12 = 0.0;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k6 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x);
      x4 = x - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k6 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius2 = p[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      c4 = sqrt(t22);
      f3 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x4) > 0.0) {
        way2 = 1.0;
      } else {
        way2 = -1.0;
      }
      y2 = way2 * x4;
      if (MAGGI_RE(y2) >= MAGGI_RE(c4 + f3)) {
        b30 = 0.0;
        b31 = 0.0;
      } else if (MAGGI_RE(y2) > MAGGI_RE(c4 - f3)) {
        t23 = radius2 * radius2 - (c4 - f3) * (c4 - f3);
        z3 = sqrt(t23);
        h0_3 = z3 - base2;
        h1_3 = 2.0 * f3 * (c4 - f3) / z3;
        a3 = 3.0 * h0_3 - h1_3;
        t24 = z3 * z3 * z3;
        t25 = 2.0 * f3 * f3 * radius2 * radius2 / t24;
        b4 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        t26 = 2.0 * f3;
        u3 = (c4 + f3 - y2) / t26;
        w3 = 1.0 - u3;
        b30 = u3 * u3 * u3 * (h0_3 + w3 * (a3 + w3 * b4));
        t27 = 2.0 * f3;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 * (a3 + 2.0 * w3 * b4)) /
            t27;
        b31 = t28;
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        z3_3 = sqrt(t29);
        b30 = z3_3 - base2;
        t30 = -x4 / z3_3;
        b31 = t30;
      }
      h10 = b30;
      h11 = 0.0;
      h12 = b31;
    } else {
      k8 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x);
      if (k8 < 0) {
        p_road6 = p[t->roadadr[road]];
        h2 = p[t->roadadr[road] + 1] - p_road6;
        p_roadroad2 = p[t->roadadr[road] + t->roadn[road]];
        t31 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2) / h2;
        slope2 = t31 - h2 / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]);
        s30 = p_roadroad2 + slope2 * (x - p_road6);
        s31 = slope2;
      } else if (k8 > t->roadn[road] - 2) {
        p5 = p[t->roadadr[road] + t->roadn[road] - 1];
        h2_2 = p5 - p[t->roadadr[road] + t->roadn[road] - 2];
        p6 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t32 = (p6 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h2_2;
        slope2_2 = t32 + h2_2 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        s30 = p6 + slope2_2 * (x - p5);
        s31 = slope2_2;
      } else {
        p_roadk81 = p[t->roadadr[road] + k8 + 1];
        p_roadk8 = p[t->roadadr[road] + k8];
        h2_3 = p_roadk81 - p_roadk8;
        a4 = p_roadk81 - x;
        c5 = x - p_roadk8;
        p7 = p[t->roadadr[road] + t->roadn[road] + k8];
        t33 = (p[t->roadadr[road] + t->roadn[road] + k8 + 1] - p7) / h2_3;
        spline0_roadk810 = spline0[t->roadspline[road] + k8 + 1][0];
        spline0_roadk80 = spline0[t->roadspline[road] + k8][0];
        e2 = t33 - h2_3 / 6.0 * (spline0_roadk810 - spline0_roadk80);
        t34 = 6.0 * h2_3;
        t35 = (spline0_roadk80 * a4 * a4 * a4 + spline0_roadk810 * c5 * c5 * c5) / t34;
        s30 = t35 + p7 - spline0_roadk80 * h2_3 * h2_3 / 6.0 + e2 * c5;
        t36 = 2.0 * h2_3;
        t37 = (spline0_roadk810 * c5 * c5 - spline0_roadk80 * a4 * a4) / t36;
        s31 = t37 + e2;
      }
      h10 = s30;
      h11 = s31;
      h12 = 0.0;
    }
    t38 = 1.0 + h11 * h11;
    s = sqrt(t38);
    normal0 = -h11 / s;
    normal1 = 0.0;
    normal2 = 1.0 / s;
    c = u0 * normal0 + u1 * normal1 + u2_2 * normal2;
    un0 = u1 * normal2 - u2_2 * normal1;
    un1 = u2_2 * normal0 - u0 * normal2;
    un2 = u0 * normal1 - u1 * normal0;
    t39 = un0 * un0 + un1 * un1 + un2 * un2;
    w = sqrt(t39);
    r2 = ((g0 - x) * normal0 + (g2_2 - h10) * normal2) / w;
    along0 = un0 / w;
    along1 = un1 / w;
    along2 = un2 / w;
    L0 = normal1 * along2 - normal2 * along1;
    L1 = normal2 * along0 - normal0 * along2;
    L2 = normal0 * along1 - normal1 * along0;
    arm0 = r2 * (c * u0 - normal0) / w;
    T0 = along0;
    N0 = normal0;
    arm1 = r2 * (c * u1 - normal1) / w;
    T1 = along1;
    N1 = normal1;
    arm2 = r2 * (c * u2_2 - normal2) / w;
    T2 = along2;
    N2 = normal2;
    z0 = r2;
    z1 = c;
    z2_2 = w;
    z3_2 = h12;
    Z_i3 = Z[t->wheelbody[i]][3];
    Z_i4 = Z[t->wheelbody[i]][4];
    Z_i5 = Z[t->wheelbody[i]][5];
    omega = Z_i3 * u0 + Z_i4 * u1 + Z_i5 * u2_2;
    wr0 = Z_i3 - omega * u0;
    wr1 = Z_i4 - omega * u1;
    wr2 = Z_i5 - omega * u2_2;
    vr0 = wr1 * arm2 - wr2 * arm1;
    vr1 = wr2 * arm0 - wr0 * arm2;
    vr2 = wr0 * arm1 - wr1 * arm0;
    v0 = rv[t->wheelpoint[i]][0] + vr0;
    v1 = rv[t->wheelpoint[i]][1] + vr1;
    v2 = rv[t->wheelpoint[i]][2] + vr2;
    vx = slip[i][MAGGI_SLIP_VX];
    rhov = (z3_2 * v0 - (v0 * N0 + v1 * N1 + v2 * N2)) / z2_2;
    fz = slip[i][MAGGI_SLIP_FZ];
    fz0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      t40 = fz0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t41 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio;
      t42 = atan(t41);
      re2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - t40 *
          (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t42 + p[t->tyreadr[t->wheeltyre[i]] +
          MAGGI_TYRE_FREFF] * ratio);
    } else {
      re2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
    }
    re = re2;
    if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y3 = vx;
    } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y3 = -vx;
    } else {
      p8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      t43 = vx * vx / p8;
      y3 = 0.5 * (p8 + t43);
    }
    speed = y3;
    r30 = r[t->wheelpoint[i]][0] + arm0;
    f_i0 = f[i][0];
    f_i1 = f[i][1];
    f_i2 = f[i][2];
    force30 = F[i][0];
    r31 = r[t->wheelpoint[i]][1] + arm1;
    force31 = F[i][1];
    r32 = r[t->wheelpoint[i]][2] + arm2;
    force32 = F[i][2];
    f_i3 = f[i][3];
    f_i4 = f[i][4];
    f_i5 = f[i][5];
    tb209 = Fb[i][5];
    Fb[i][5] = 0.0;
    moment2b = tb209;
    f_i3b = tb209 * T2;
    T2b = tb209 * f_i3;
    f_i4b = tb209 * L2;
    L2b = tb209 * f_i4;
    f_i5b = tb209 * N2;
    N2b = tb209 * f_i5;
    force32b = Fb[i][2];
    Fb[i][2] = 0.0;
    tb208 = Fb[i][4];
    Fb[i][4] = 0.0;
    moment1b = tb208;
    f_i3b += tb208 * T1;
    T1b = tb208 * f_i3;
    f_i4b += tb208 * L1;
    L1b = tb208 * f_i4;
    f_i5b += tb208 * N1;
    force31b = Fb[i][1];
    Fb[i][1] = 0.0;
    tb207 = Fb[i][3];
    Fb[i][3] = 0.0;
    moment0b = tb207;
    f_i3b += tb207 * T0;
    T0b = tb207 * f_i3;
    f_i4b += tb207 * L0;
    L0b = tb207 * f_i4;
    f_i5b += tb207 * N0;
    N0b = tb207 * f_i5;
    fb[i][5] += f_i5b;
    fb[i][4] += f_i4b;
    fb[i][3] += f_i3b;
    force30b = Fb[i][0];
    Fb[i][0] = 0.0;
    r30b = moment2b * force31;
    force31b += moment2b * r30;
    r31b = -(moment2b * force30);
    force30b -= moment2b * r31;
    r32b = moment1b * force30;
    force30b += moment1b * r32;
    r30b -= moment1b * force32;
    force32b -= moment1b * r30;
    r31b += moment0b * force32;
    force32b += moment0b * r31;
    r32b -= moment0b * force31;
    force31b -= moment0b * r32;
    f_i0b = force32b * T2;
    T2b += force32b * f_i0;
    f_i1b = force32b * L2;
    L2b += force32b * f_i1;
    f_i2b = force32b * N2;
    N2b += force32b * f_i2;
    rb[t->wheelpoint[i]][2] += r32b;
    arm2b = r32b;
    f_i0b += force31b * T1;
    T1b += force31b * f_i0;
    f_i1b += force31b * L1;
    L1b += force31b * f_i1;
    f_i2b += force31b * N1;
    rb[t->wheelpoint[i]][1] += r31b;
    arm1b = r31b;
    f_i0b += force30b * T0;
    T0b += force30b * f_i0;
    f_i1b += force30b * L0;
    L0b += force30b * f_i1;
    f_i2b += force30b * N0;
    N0b += force30b * f_i2;
    fb[i][2] += f_i2b;
    fb[i][1] += f_i1b;
    fb[i][0] += f_i0b;
    /* F: force f_x T + f_y L + f_z N at the contact point, with its moment, as one about P */
    rb[t->wheelpoint[i]][0] += r30b;
    arm0b = r30b;
    fzb = 0.0;
    if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z0) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_UNLOADED_RADIUS])) {
      if (t->wheelgrip[i]) {
        side = t->wheelmirror[i] ? -1.0 : 1.0;
        one0 = slip[i][MAGGI_SLIP_KAPPA];
        one1 = side * slip[i][MAGGI_SLIP_TAN_ALPHA];
        one2 = side * slip[i][MAGGI_SLIP_GAMMA];
        one3 = slip[i][MAGGI_SLIP_FZ];
        one4 = slip[i][MAGGI_SLIP_VX];
        kappa = one0;
        a5 = one1;
        gamma = one2;
        fz2 = one3;
        fz0_2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        r0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        dfz = (fz2 - fz0_2) / fz0_2;
        kx = kappa + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LHX];
        gx = gamma * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        mux = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx *
            gx) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        e3 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz) * dfz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        if (MAGGI_RE(kx) > 0.0) {
          e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          if (MAGGI_RE(e4) > 1.0) {
            y5 = 1.0;
          } else {
            y5 = e4;
          }
          ex = y5;
        } else {
          e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          if (MAGGI_RE(e5) > 1.0) {
            y6 = 1.0;
          } else {
            y6 = e5;
          }
          ex = y6;
        }
        x50 = mux * fz2;
        x51 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        x52 = ex;
        t44 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz;
        t45 = exp(t44);
        x53 = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t45 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        x54 = kx;
        x55 = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        fz0_3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        gy = gamma * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        ay = a5 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gy;
        muy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy *
            gy) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        e6 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        if (MAGGI_RE(ay) > 0.0) {
          e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          if (MAGGI_RE(e7) > 1.0) {
            y7 = 1.0;
          } else {
            y7 = e7;
          }
          ey = y7;
        } else {
          e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          if (MAGGI_RE(e8) > 1.0) {
            y8 = 1.0;
          } else {
            y8 = e8;
          }
          ey = y8;
        }
        t46 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3;
        z5 = fz2 / t46;
        y40 = muy * fz2;
        y41 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        y42 = ey;
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y9 = gy;
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y9 = -gy;
        } else {
          p9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t47 = p9 * p9;
          z6 = gy * gy / t47;
          y9 = 0.125 * p9 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
        }
        t48 = 1.0 + z5 * z5;
        t49 = 2.0 * z5 / t48;
        y43 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t49 * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY];
        y44 = ay;
        y45 = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        peak = y40;
        x6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa;
        t50 = 1.0 + x6 * x6;
        t51 = sqrt(t50);
        t52 = 1.0 / t51;
        g20 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t52 * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LXAL];
        g21 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        e9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz;
        if (MAGGI_RE(e9) > 1.0) {
          y10 = 1.0;
        } else {
          y10 = e9;
        }
        g22 = y10;
        g23 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        x7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a5 - p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBY3]);
        t53 = 1.0 + x7 * x7;
        t54 = sqrt(t53);
        t55 = 1.0 / t54;
        g24 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t55 * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LYKA];
        g25 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        e10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz;
        if (MAGGI_RE(e10) > 1.0) {
          y11 = 1.0;
        } else {
          y11 = e10;
        }
        g26 = y11;
        g27 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz;
        x8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a5;
        t56 = 1.0 + x8 * x8;
        t57 = sqrt(t56);
        t58 = 1.0 / t57;
        dv = peak * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma) * t58;
        t59 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa;
        t60 = atan(t59);
        t61 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t60;
        t62 = sin(t61);
        g28 = dv * t62 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        t63 = x51 * x50;
        t64 = x53 / t63;
        y12 = t64 * x54;
        y13 = g20 * (a5 + g23);
        y14 = g20 * g23;
        t65 = atan(y12);
        t66 = (1.0 - x52) * y12 + x52 * t65;
        t67 = atan(t66);
        t68 = x51 * t67;
        t69 = sin(t68);
        t70 = atan(y13);
        t71 = (1.0 - g22) * y13 + g22 * t70;
        t72 = atan(t71);
        t73 = g21 * t72;
        t74 = cos(t73);
        t75 = atan(y14);
        t76 = (1.0 - g22) * y14 + g22 * t75;
        t77 = atan(t76);
        t78 = g21 * t77;
        t79 = cos(t78);
        t80 = t74 / t79;
        fx = (x50 * t69 + x55) * t80;
        t81 = y41 * y40;
        t82 = y43 / t81;
        y15 = t82 * y44;
        y16 = g24 * (kappa + g27);
        y17 = g24 * g27;
        t83 = atan(y15);
        t84 = (1.0 - y42) * y15 + y42 * t83;
        t85 = atan(t84);
        t86 = y41 * t85;
        t87 = sin(t86);
        t88 = atan(y16);
        t89 = (1.0 - g26) * y16 + g26 * t88;
        t90 = atan(t89);
        t91 = g25 * t90;
        t92 = cos(t91);
        t93 = atan(y17);
        t94 = (1.0 - g26) * y17 + g26 * t93;
        t95 = atan(t94);
        t96 = g25 * t95;
        t97 = cos(t96);
        t98 = t92 / t97;
        fy = (y40 * t87 + y45) * t98;
        ratio2 = x53 * kappa / y43;
        fz0_4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        gz = gamma * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        at = a5 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QHZ2] * dfz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gz;
        t99 = y45 / y43;
        ar = y44 + t99;
        t100 = at * at + ratio2 * ratio2 + 1e-24;
        ateq = sqrt(t100);
        t101 = ar * ar + ratio2 * ratio2 + 1e-24;
        areq = sqrt(t101);
        scale = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LMUY];
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y18 = gz;
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y18 = -gz;
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t102 = p10 * p10;
          z7 = gz * gz / t102;
          y18 = 0.125 * p10 * z7 * (15.0 + z7 * (-10.0 + 3.0 * z7));
        }
        bt = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz) * dfz) * (1.0
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ5] * y18) * scale;
        t103 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
        dt = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gz) * t103 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        t104 = bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * at;
        t105 = atan(t104);
        e11 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz) * dfz) * (1.0
            + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t105);
        if (MAGGI_RE(e11) > 1.0) {
          y19 = 1.0;
        } else {
          y19 = e11;
        }
        et = y19;
        t106 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * y43 / y40;
        br = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * scale + t106;
        dr = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t107 = 1.0 + a5 * a5;
        t108 = sqrt(t107);
        ca = 1.0 / t108;
        y20 = bt * ateq;
        t109 = atan(y20);
        t110 = (1.0 - et) * y20 + et * t109;
        t111 = atan(t110);
        t112 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t111;
        t113 = cos(t112);
        z40 = dt * t113 * ca;
        x9 = br * areq;
        t114 = 1.0 + x9 * x9;
        t115 = sqrt(t114);
        t116 = 1.0 / t115;
        force2 = fy + g28;
        t117 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * force2 / fz0_2;
        s4 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t117 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        t118 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        way3 = tanh(t118);
        speed2 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        t119 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * force2 / fz0_2;
        t120 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
        force5b = fb[i][5] * side;
        fb[i][5] = 0.0;
        force4b = fb[i][4];
        fb[i][4] = 0.0;
        force3_2b = fb[i][3] * side;
        fb[i][3] = 0.0;
        force2_2b = fb[i][2];
        fb[i][2] = 0.0;
        force1b = fb[i][1] * side;
        fb[i][1] = 0.0;
        force0b = fb[i][0];
        fb[i][0] = 0.0;
        z40b = -(force5b * fy);
        fyb = -(force5b * z40);
        z41b = force5b;
        s4b = force5b * fx;
        fxb = force5b * s4;
        tb199 = force4b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        tb200 = tb199 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2 * speed2);
        tb201 = tb200 * fz2;
        way3b = -(tb201 * r0);
        r0b = -(tb201 * way3);
        fz2b = tb200 * (-way3 * r0);
        tb202 = tb199 * (-way3 * r0 * fz2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] += tb202;
        t120b = tb202;
        tb203 = tb202 * speed2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] += tb203 * way3;
        way3b += tb203 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3];
        speed2b = tb202 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3);
        tb204 = tb202 * speed2;
        tb205 = tb204 * speed2;
        tb206 = tb205 * speed2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] += tb206 * speed2;
        speed2b += tb206 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4];
        speed2b += tb205 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2);
        speed2b += tb204 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2);
        speed2b += tb202 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 *
            speed2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] += force4b * (-way3 * r0 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way3 * speed2 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed2 * speed2 * speed2 * speed2));
        tb198 = t120b / fz0_2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] += tb198 * fx;
        fxb += tb198 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2];
        fz0_2b = -(tb198 * t120);
        tb195 = force3_2b * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma + t119) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]);
        r0b += tb195 * fz2;
        fz2b += tb195 * r0;
        tb196 = force3_2b * (r0 * fz2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] += tb196 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LVMX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] += tb196 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX1];
        tb197 = tb196 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] -= tb197 * gamma;
        gammab = -(tb197 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2]);
        t119b = tb197;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] += tb196 * (-p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSX2] * gamma + t119);
        tb194 = t119b / fz0_2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] += tb194 * force2;
        force2b = tb194 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3];
        fz0_2b -= tb194 * t119;
        fz2b += force2_2b;
        force2b += force1b;
        fxb += force0b;
        tb193 = speed2b / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        one4b = tb193;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL] -= tb193 * speed2;
        t118b = way3b * (1.0 - way3 * way3);
        tb192 = t118b / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        one4b += tb192;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED] -= tb192 * t118;
        tb189 = s4b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        tb190 = tb189 * r0;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] += tb190;
        t117b = tb190;
        tb191 = tb190 * gamma;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] += tb191;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] += tb191 * dfz;
        dfzb = tb191 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4];
        gammab += tb190 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz);
        r0b += tb189 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t117 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] += s4b * ((p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ1] + t117 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0);
        tb188 = t117b / fz0_2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] += tb188 * force2;
        force2b += tb188 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2];
        fz0_2b -= tb188 * t117;
        fyb += force2b;
        g28b = force2b;
        tb187 = z41b * ca;
        drb = tb187 * t116;
        t116b = tb187 * dr;
        cab = z41b * (dr * t116);
        tb186 = t116b / t115;
        t115b = -(tb186 * t116);
        t114b = t115b * (1.0 / (2.0 * t115));
        x9b = t114b * x9;
        x9b += t114b * x9;
        brb = x9b * areq;
        areqb = x9b * br;
        tb185 = z40b * ca;
        dtb = tb185 * t113;
        t113b = tb185 * dt;
        cab += z40b * (dt * t113);
        t112b = -(t113b * sin(t112));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += t112b * t111;
        t111b = t112b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        t110b = t111b * (1.0 / (1.0 + t110 * t110));
        etb = -(t110b * y20);
        y20b = t110b * (1.0 - et);
        etb += t110b * t109;
        t109b = t110b * et;
        y20b += t109b * (1.0 / (1.0 + y20 * y20));
        btb = y20b * ateq;
        ateqb = y20b * bt;
        tb184 = cab / t108;
        t108b = -(tb184 * ca);
        t107b = t108b * (1.0 / (2.0 * t108));
        a5b = t107b * a5;
        a5b += t107b * a5;
        tb179 = drb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb180 = tb179 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        fz2b += tb180 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz);
        tb181 = tb180 * fz2;
        tb182 = tb181 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] += tb182;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] += tb182 * dfz;
        dfzb += tb182 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] += tb181 * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz);
        tb183 = tb181 * gz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] += tb183;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] += tb183 * dfz;
        dfzb += tb183 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9];
        gzb = tb181 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb179 * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += drb * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_UNLOADED_RADIUS]);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] += brb * scale;
        scaleb = brb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9];
        t106b = brb;
        tb178 = t106b / y40;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] += tb178 * y43;
        y43b = tb178 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10];
        y40b = -(tb178 * t106);
        y19b = etb;
        e11b = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e11) > 1.0) {
          y19b = 0.0;
        } else {
          e11b += y19b;
          y19b = 0.0;
        }
        tb173 = e11b * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t105);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] += tb173;
        tb174 = tb173 * dfz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] += tb174;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] += tb174 * dfz;
        dfzb += tb174 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3];
        dfzb += tb173 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz);
        tb175 = e11b * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ3] * dfz) * dfz);
        tb176 = tb175 * t105;
        tb177 = tb176 * 0.63661977236758134308;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] += tb177;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] += tb177 * gz;
        gzb += tb177 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5];
        t105b = tb175 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308);
        t104b = t105b * (1.0 / (1.0 + t104 * t104));
        tb172 = t104b * at;
        btb += tb172 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += tb172 * bt;
        atb = t104b * (bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1]);
        tb166 = dtb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        tb167 = tb166 * t103;
        tb168 = tb167 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gz);
        fz2b += tb168 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz);
        tb169 = tb168 * fz2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] += tb169;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] += tb169 * dfz;
        dfzb += tb169 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2];
        tb170 = tb167 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz));
        tb171 = tb170 * gz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] += tb171;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] += tb171 * gz;
        gzb += tb171 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4];
        gzb += tb170 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz);
        t103b = tb166 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz) * gz));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] += dtb * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gz) * t103);
        tb165 = t103b / fz0_4;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb165;
        fz0_4b = -(tb165 * t103);
        tb161 = btb * scale;
        tb162 = tb161 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] += tb162;
        tb163 = tb162 * dfz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] += tb163;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] += tb163 * dfz;
        dfzb += tb163 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3];
        dfzb += tb162 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz);
        tb164 = tb161 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz) * dfz);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] += tb164 * gz;
        gzb += tb164 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] += tb164 * y18;
        y18b = tb164 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5];
        scaleb += btb * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz) * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4]
            * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18));
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          gzb += y18b;
          y18b = 0.0;
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          gzb -= y18b;
          y18b = 0.0;
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t102 = p10 * p10;
          z7 = gz * gz / t102;
          tb159 = y18b * (15.0 + z7 * (-10.0 + 3.0 * z7));
          p10b = tb159 * z7 * 0.125;
          z7b = tb159 * (0.125 * p10);
          tb160 = y18b * (0.125 * p10 * z7);
          z7b += tb160 * (-10.0 + 3.0 * z7);
          z7b += tb160 * z7 * 3.0;
          y18b = 0.0;
          tb158 = z7b / t102;
          gzb += tb158 * gz;
          gzb += tb158 * gz;
          t102b = -(tb158 * z7);
          p10b += t102b * p10;
          p10b += t102b * p10;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p10b;
        }
        tb157 = scaleb / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += tb157;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] -= tb157 * scale;
        t101b = areqb * (1.0 / (2.0 * areq));
        arb = t101b * ar;
        arb += t101b * ar;
        ratio2b = t101b * ratio2;
        ratio2b += t101b * ratio2;
        t100b = ateqb * (1.0 / (2.0 * ateq));
        atb += t100b * at;
        atb += t100b * at;
        ratio2b += t100b * ratio2;
        ratio2b += t100b * ratio2;
        y44b = arb;
        t99b = arb;
        tb156 = t99b / y43;
        y45b = tb156;
        y43b -= tb156 * t99;
        a5b += atb;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] += atb;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] += atb * dfz;
        dfzb += atb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2];
        tb155 = atb * gz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] += tb155;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] += tb155 * dfz;
        dfzb += tb155 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4];
        gzb += atb * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz);
        gammab += gzb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] += gzb * gamma;
        /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
         *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_4b *
            p[t->tyreadr[t->wheeltyre[i]]];
        pb[t->tyreadr[t->wheeltyre[i]]] += fz0_4b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO];
        tb154 = ratio2b / y43;
        x53b = tb154 * kappa;
        kappab = tb154 * x53;
        y43b -= tb154 * ratio2;
        tb153 = fyb * t98;
        y40b += tb153 * t87;
        t87b = tb153 * y40;
        y45b += tb153;
        t98b = fyb * (y40 * t87 + y45);
        tb152 = t98b / t97;
        t92b = tb152;
        t97b = -(tb152 * t98);
        t96b = -(t97b * sin(t96));
        g25b = t96b * t95;
        t95b = t96b * g25;
        t94b = t95b * (1.0 / (1.0 + t94 * t94));
        g26b = -(t94b * y17);
        y17b = t94b * (1.0 - g26);
        g26b += t94b * t93;
        t93b = t94b * g26;
        y17b += t93b * (1.0 / (1.0 + y17 * y17));
        t91b = -(t92b * sin(t91));
        g25b += t91b * t90;
        t90b = t91b * g25;
        t89b = t90b * (1.0 / (1.0 + t89 * t89));
        g26b -= t89b * y16;
        y16b = t89b * (1.0 - g26);
        g26b += t89b * t88;
        t88b = t89b * g26;
        y16b += t88b * (1.0 / (1.0 + y16 * y16));
        t86b = t87b * cos(t86);
        y41b = t86b * t85;
        t85b = t86b * y41;
        t84b = t85b * (1.0 / (1.0 + t84 * t84));
        y42b = -(t84b * y15);
        y15b = t84b * (1.0 - y42);
        y42b += t84b * t83;
        t83b = t84b * y42;
        y15b += t83b * (1.0 / (1.0 + y15 * y15));
        g24b = y17b * g27;
        g27b = y17b * g24;
        g24b += y16b * (kappa + g27);
        tb151 = y16b * g24;
        kappab += tb151;
        g27b += tb151;
        t82b = y15b * y44;
        y44b += y15b * t82;
        tb150 = t82b / t81;
        y43b += tb150;
        t81b = -(tb150 * t82);
        y41b += t81b * y40;
        y40b += t81b * y41;
        tb149 = fxb * t80;
        x50b = tb149 * t69;
        t69b = tb149 * x50;
        x55b = tb149;
        t80b = fxb * (x50 * t69 + x55);
        tb148 = t80b / t79;
        t74b = tb148;
        t79b = -(tb148 * t80);
        t78b = -(t79b * sin(t78));
        g21b = t78b * t77;
        t77b = t78b * g21;
        t76b = t77b * (1.0 / (1.0 + t76 * t76));
        g22b = -(t76b * y14);
        y14b = t76b * (1.0 - g22);
        g22b += t76b * t75;
        t75b = t76b * g22;
        y14b += t75b * (1.0 / (1.0 + y14 * y14));
        t73b = -(t74b * sin(t73));
        g21b += t73b * t72;
        t72b = t73b * g21;
        t71b = t72b * (1.0 / (1.0 + t71 * t71));
        g22b -= t71b * y13;
        y13b = t71b * (1.0 - g22);
        g22b += t71b * t70;
        t70b = t71b * g22;
        y13b += t70b * (1.0 / (1.0 + y13 * y13));
        t68b = t69b * cos(t68);
        x51b = t68b * t67;
        t67b = t68b * x51;
        t66b = t67b * (1.0 / (1.0 + t66 * t66));
        x52b = -(t66b * y12);
        y12b = t66b * (1.0 - x52);
        x52b += t66b * t65;
        t65b = t66b * x52;
        y12b += t65b * (1.0 / (1.0 + y12 * y12));
        g20b = y14b * g23;
        g23b = y14b * g20;
        g20b += y13b * (a5 + g23);
        tb147 = y13b * g20;
        a5b += tb147;
        g23b += tb147;
        t64b = y12b * x54;
        x54b = y12b * t64;
        tb146 = t64b / t63;
        x53b += tb146;
        t63b = -(tb146 * t64);
        x51b += t63b * x50;
        x50b += t63b * x51;
        tb145 = g28b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        dvb = tb145 * t62;
        t62b = tb145 * dv;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] += g28b * (dv * t62);
        t61b = t62b * cos(t61);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] += t61b * t60;
        t60b = t61b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5];
        t59b = t60b * (1.0 / (1.0 + t59 * t59));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] += t59b * kappa;
        kappab += t59b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6];
        tb143 = dvb * t58;
        peakb = tb143 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma);
        tb144 = tb143 * peak;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] += tb144;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] += tb144 * dfz;
        dfzb += tb144 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] += tb144 * gamma;
        gammab += tb144 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3];
        t58b = dvb * (peak * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma));
        tb142 = t58b / t57;
        t57b = -(tb142 * t58);
        t56b = t57b * (1.0 / (2.0 * t57));
        x8b = t56b * x8;
        x8b += t56b * x8;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] += x8b * a5;
        a5b += x8b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] += g27b;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] += g27b * dfz;
        dfzb += g27b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2];
        y11b = g26b;
        e10b = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e10) > 1.0) {
          y11b = 0.0;
        } else {
          e10b += y11b;
          y11b = 0.0;
        }
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] += e10b;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] += e10b * dfz;
        dfzb += e10b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1] += g25b;
        tb141 = g24b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] += tb141 * t55;
        t55b = tb141 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA] += g24b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RBY1] * t55);
        tb140 = t55b / t54;
        t54b = -(tb140 * t55);
        t53b = t54b * (1.0 / (2.0 * t54));
        x7b = t53b * x7;
        x7b += t53b * x7;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] += x7b * (a5 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]);
        tb139 = x7b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2];
        a5b += tb139;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3] -= tb139;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1] += g23b;
        y10b = g22b;
        e9b = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e9) > 1.0) {
          y10b = 0.0;
        } else {
          e9b += y10b;
          y10b = 0.0;
        }
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] += e9b;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] += e9b * dfz;
        dfzb += e9b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1] += g21b;
        tb138 = g20b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] += tb138 * t52;
        t52b = tb138 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL] += g20b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RBX1] * t52);
        tb137 = t52b / t51;
        t51b = -(tb137 * t52);
        t50b = t51b * (1.0 / (2.0 * t51));
        x6b = t50b * x6;
        x6b += t50b * x6;
        /* what combined slip makes of the forces:  Fx = Gxa Fx0, Fy = Gyk Fy0 + SVyk.  g: b, c, e, shift of Gxa,
         * then of Gyk, SVyk */
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] += x6b * kappa;
        kappab += x6b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2];
        y40b += peakb;
        tb133 = y45b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        fz2b += tb133 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy);
        tb134 = tb133 * fz2;
        tb135 = tb134 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] += tb135;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] += tb135 * dfz;
        dfzb += tb135 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] += tb134 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz);
        tb136 = tb134 * gy;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] += tb136;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] += tb136 * dfz;
        dfzb += tb136 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4];
        gyb = tb134 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += y45b * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gy));
        ayb = y44b;
        tb129 = y43b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        tb130 = tb129 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9);
        tb131 = tb130 * t49;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] += tb131 * fz0_3;
        fz0_3b = tb131 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1];
        t49b = tb130 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3);
        tb132 = tb129 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t49);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] -= tb132 * y9;
        y9b = -(tb132 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += y43b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t49 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]
            * y9));
        tb128 = t49b / t48;
        z5b = tb128 * 2.0;
        t48b = -(tb128 * t49);
        z5b += t48b * z5;
        z5b += t48b * z5;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          gyb += y9b;
          y9b = 0.0;
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          gyb -= y9b;
          y9b = 0.0;
        } else {
          p9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t47 = p9 * p9;
          z6 = gy * gy / t47;
          tb126 = y9b * (15.0 + z6 * (-10.0 + 3.0 * z6));
          p9b = tb126 * z6 * 0.125;
          z6b = tb126 * (0.125 * p9);
          tb127 = y9b * (0.125 * p9 * z6);
          z6b += tb127 * (-10.0 + 3.0 * z6);
          z6b += tb127 * z6 * 3.0;
          y9b = 0.0;
          tb125 = z6b / t47;
          gyb += tb125 * gy;
          gyb += tb125 * gy;
          t47b = -(tb125 * z6);
          p9b += t47b * p9;
          p9b += t47b * p9;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p9b;
        }
        eyb = y42b;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] += y41b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY] += y41b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCY1];
        muyb = y40b * fz2;
        fz2b += y40b * muy;
        tb124 = z5b / t46;
        fz2b += tb124;
        t46b = -(tb124 * z5);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] += t46b * fz0_3;
        fz0_3b += t46b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2];
        e6b = 0.0;
        if (MAGGI_RE(ay) > 0.0) {
          e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          y7b = eyb;
          eyb = 0.0;
          e7b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e7) > 1.0) {
            y7b = 0.0;
          } else {
            e7b += y7b;
            y7b = 0.0;
          }
          e6b += e7b * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          tb122 = e7b * e6;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] -= tb122;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] -= tb122 * gy;
          gyb -= tb122 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
        } else {
          e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          y8b = eyb;
          eyb = 0.0;
          e8b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e8) > 1.0) {
            y8b = 0.0;
          } else {
            e8b += y8b;
            y8b = 0.0;
          }
          e6b += e8b * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          tb123 = e8b * e6;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] += tb123;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] += tb123 * gy;
          gyb += tb123 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
        }
        tb121 = e6b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] += tb121;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] += tb121 * dfz;
        dfzb += tb121 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] += e6b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz);
        tb117 = muyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb118 = tb117 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] += tb118;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] += tb118 * dfz;
        dfzb += tb118 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2];
        tb119 = tb117 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz);
        tb120 = tb119 * gy;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] -= tb120 * gy;
        gyb -= tb120 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3];
        gyb -= tb119 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += muyb * ((p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy));
        a5b += ayb;
        tb116 = ayb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] += tb116;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] += tb116 * dfz;
        dfzb += tb116 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] += ayb * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] += ayb * gy;
        gyb += ayb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3];
        gammab += gyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] += gyb * gamma;
        /* sin(2 atan(z)) = 2 z / (1 + z^2) */
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_3b *
            p[t->tyreadr[t->wheeltyre[i]]];
        pb[t->tyreadr[t->wheeltyre[i]]] += fz0_3b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO];
        tb113 = x55b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb114 = tb113 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX];
        fz2b += tb114 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz);
        tb115 = tb114 * fz2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] += tb115;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] += tb115 * dfz;
        dfzb += tb115 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] += tb113 * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] += x55b * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]);
        kxb = x54b;
        tb110 = x53b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        tb111 = tb110 * t45;
        fz2b += tb111 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz);
        tb112 = tb111 * fz2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] += tb112;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] += tb112 * dfz;
        dfzb += tb112 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2];
        t45b = tb110 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] += x53b * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz) * t45);
        t44b = t45b * t45;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] += t44b * dfz;
        dfzb += t44b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3];
        exb = x52b;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] += x51b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX] += x51b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCX1];
        muxb = x50b * fz2;
        fz2b += x50b * mux;
        e3b = 0.0;
        if (MAGGI_RE(kx) > 0.0) {
          e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          y5b = exb;
          exb = 0.0;
          e4b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e4) > 1.0) {
            y5b = 0.0;
          } else {
            e4b += y5b;
            y5b = 0.0;
          }
          e3b += e4b * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] -= e4b * e3;
        } else {
          e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          y6b = exb;
          exb = 0.0;
          e5b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e5) > 1.0) {
            y6b = 0.0;
          } else {
            e5b += y6b;
            y6b = 0.0;
          }
          e3b += e5b * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] += e5b * e3;
        }
        tb108 = e3b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] += tb108;
        tb109 = tb108 * dfz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] += tb109;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] += tb109 * dfz;
        dfzb += tb109 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3];
        dfzb += tb108 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] += e3b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz) * dfz);
        tb104 = muxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb105 = tb104 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] += tb105;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] += tb105 * dfz;
        dfzb += tb105 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2];
        tb106 = tb104 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz);
        tb107 = tb106 * gx;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] -= tb107 * gx;
        gxb = -(tb107 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3]);
        gxb -= tb106 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] += muxb * ((p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx));
        gammab += gxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] += gxb * gamma;
        kappab += kxb;
        tb103 = kxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] += tb103;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] += tb103 * dfz;
        dfzb += tb103 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz);
        tb102 = dfzb / fz0_2;
        fz2b += tb102;
        fz0_2b -= tb102;
        fz0_2b -= tb102 * dfz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += r0b;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_2b *
            p[t->tyreadr[t->wheeltyre[i]]];
        pb[t->tyreadr[t->wheeltyre[i]]] += fz0_2b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO];
        one3b = fz2b;
        one2b = gammab;
        one1b = a5b;
        one0b = kappab;
        slipb[i][MAGGI_SLIP_VX] += one4b;
        slipb[i][MAGGI_SLIP_FZ] += one3b;
        slipb[i][MAGGI_SLIP_GAMMA] += one2b * side;
        slipb[i][MAGGI_SLIP_TAN_ALPHA] += one1b * side;
        /* the formula on either side; f: Fx Fy Fz, Mx My Mz */
        slipb[i][MAGGI_SLIP_KAPPA] += one0b;
      } else {
        for (k9 = 5; k9 >= 0; --k9) {
          t121b = fb[i][k9];
          fb[i][k9] = 0.0;
          if (k9 == 2) {
            fzb += t121b;
            t121b = 0.0;
          } else {
            t121b = 0.0;
          }
        }
      }
    } else {
      for (k9_2 = 5; k9_2 >= 0; --k9_2) {
        fb[i][k9_2] = 0.0;
      }
    }
    reb = slipb[i][MAGGI_SLIP_ROLLING];
    slipb[i][MAGGI_SLIP_ROLLING] = 0.0;
    z0b = slipb[i][MAGGI_SLIP_RADIUS];
    slipb[i][MAGGI_SLIP_RADIUS] = 0.0;
    vxb = slipb[i][MAGGI_SLIP_VX];
    slipb[i][MAGGI_SLIP_VX] = 0.0;
    fzb += slipb[i][MAGGI_SLIP_FZ];
    slipb[i][MAGGI_SLIP_FZ] = 0.0;
    tb101 = slipb[i][MAGGI_SLIP_GAMMA];
    slipb[i][MAGGI_SLIP_GAMMA] = 0.0;
    z1b = tb101 * (z2_2 / (z2_2 * z2_2 + z1 * z1));
    z2_2b = -(tb101 * (z1 / (z2_2 * z2_2 + z1 * z1)));
    tb99 = slipb[i][MAGGI_SLIP_TAN_ALPHA];
    slipb[i][MAGGI_SLIP_TAN_ALPHA] = 0.0;
    tb100 = tb99 / speed;
    v0b = tb100 * L0;
    L0b += tb100 * v0;
    v1b = tb100 * L1;
    L1b += tb100 * v1;
    v2b = tb100 * L2;
    L2b += tb100 * v2;
    speedb = -(tb100 * slip[i][MAGGI_SLIP_TAN_ALPHA]);
    tb97 = slipb[i][MAGGI_SLIP_KAPPA];
    slipb[i][MAGGI_SLIP_KAPPA] = 0.0;
    tb98 = tb97 / speed;
    omegab = tb98 * re;
    reb += tb98 * omega;
    vxb -= tb98;
    speedb -= tb98 * slip[i][MAGGI_SLIP_KAPPA];
    y3b = speedb;
    /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
    if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      vxb += y3b;
      y3b = 0.0;
    } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      vxb -= y3b;
      y3b = 0.0;
    } else {
      p8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      t43 = vx * vx / p8;
      tb96 = y3b * 0.5;
      p8b = tb96;
      t43b = tb96;
      y3b = 0.0;
      tb95 = t43b / p8;
      vxb += tb95 * vx;
      vxb += tb95 * vx;
      p8b -= tb95 * t43;
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW] += p8b;
    }
    re2b = reb;
    fz0b = 0.0;
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      t40 = fz0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t41 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio;
      t42 = atan(t41);
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += re2b;
      t40b = -(re2b * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t42 +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio));
      tb94 = re2b * t40;
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] -= tb94 * t42;
      t42b = -(tb94 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF]);
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] -= tb94 * ratio;
      ratiob = -(tb94 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF]);
      re2b = 0.0;
      t41b = t42b * (1.0 / (1.0 + t41 * t41));
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] += t41b * ratio;
      ratiob += t41b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF];
      tb93 = t40b / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      fz0b += tb93;
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] -= tb93 * t40;
      tb92 = ratiob / fz0;
      fzb += tb92;
      fz0b -= tb92 * ratio;
    } else {
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += re2b;
      re2b = 0.0;
    }
    /* Re = R0 - rho0 (D atan(B rd) + F rd),  rd = Fz / Fz0,  rho0 = Fz0 / Cz;  R0 in the air */
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0b * p[t->tyreadr[t->wheeltyre[i]]];
    pb[t->tyreadr[t->wheeltyre[i]]] += fz0b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO];
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += fzb *
        (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - z0);
    tb91 = fzb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb91;
    z0b -= tb91;
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
    rhovb = fzb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING];
    tb90 = rhovb / z2_2;
    z3_2b = tb90 * v0;
    v0b += tb90 * z3_2;
    v0b -= tb90 * N0;
    N0b -= tb90 * v0;
    v1b -= tb90 * N1;
    v2b -= tb90 * N2;
    N2b -= tb90 * v2;
    z2_2b -= tb90 * rhov;
    v0b += vxb * T0;
    T0b += vxb * v0;
    v1b += vxb * T1;
    T1b += vxb * v1;
    v2b += vxb * T2;
    T2b += vxb * v2;
    rvb[t->wheelpoint[i]][2] += v2b;
    vr2b = v2b;
    rvb[t->wheelpoint[i]][1] += v1b;
    vr1b = v1b;
    rvb[t->wheelpoint[i]][0] += v0b;
    vr0b = v0b;
    wr0b = vr2b * arm1;
    arm1b += vr2b * wr0;
    wr1b = -(vr2b * arm0);
    arm0b -= vr2b * wr1;
    wr2b = vr1b * arm0;
    arm0b += vr1b * wr2;
    wr0b -= vr1b * arm2;
    arm2b -= vr1b * wr0;
    wr1b += vr0b * arm2;
    arm2b += vr0b * wr1;
    wr2b -= vr0b * arm1;
    arm1b -= vr0b * wr2;
    Z_i5b = wr2b;
    omegab -= wr2b * u2_2;
    u2_2b = -(wr2b * omega);
    Z_i4b = wr1b;
    omegab -= wr1b * u1;
    u1b = -(wr1b * omega);
    Z_i3b = wr0b;
    omegab -= wr0b * u0;
    u0b = -(wr0b * omega);
    /* Slip and forces of a wheel.  V is the velocity of the place on the road below the wheel, which the turn of
     * neither wheel nor carrier about the axis moves:
     *   Omega = w.u,  V = v_C + (w - Omega u) × r e,  rho = R0 - r,  rho' = -V.n / |u × n|
     *   Fz = Cz rho + Cd rho'
     *   kappa = -(V.t - Omega Re) / |V.t|,  tan(alpha) = V.l / |V.t|,  sin(gamma) = u.n
     * No force without contact; without grip that of the spring alone, as at rest. */
    Z_i3b += omegab * u0;
    u0b += omegab * Z_i3;
    Z_i4b += omegab * u1;
    u1b += omegab * Z_i4;
    Z_i5b += omegab * u2_2;
    u2_2b += omegab * Z_i5;
    Zb[t->wheelbody[i]][5] += Z_i5b;
    Zb[t->wheelbody[i]][4] += Z_i4b;
    Zb[t->wheelbody[i]][3] += Z_i3b;
    h12b = z3_2b;
    wb = z2_2b;
    cb = z1b;
    r2b = z0b;
    normal2b = N2b;
    along2b = T2b;
    tb88 = arm2b / w;
    r2b += tb88 * (c * u2_2 - normal2);
    tb89 = tb88 * r2;
    cb += tb89 * u2_2;
    u2_2b += tb89 * c;
    normal2b -= tb89;
    wb -= tb88 * arm2;
    along1b = T1b;
    tb86 = arm1b / w;
    r2b += tb86 * (c * u1 - normal1);
    tb87 = tb86 * r2;
    cb += tb87 * u1;
    u1b += tb87 * c;
    wb -= tb86 * arm1;
    normal0b = N0b;
    along0b = T0b;
    tb84 = arm0b / w;
    r2b += tb84 * (c * u0 - normal0);
    tb85 = tb84 * r2;
    cb += tb85 * u0;
    u0b += tb85 * c;
    normal0b -= tb85;
    wb -= tb84 * arm0;
    normal0b += L2b * along1;
    along1b += L2b * normal0;
    along0b -= L2b * normal1;
    normal2b += L1b * along0;
    along0b += L1b * normal2;
    normal0b -= L1b * along2;
    along2b -= L1b * normal0;
    along2b += L0b * normal1;
    normal2b -= L0b * along1;
    along1b -= L0b * normal2;
    tb83 = along2b / w;
    un2b = tb83;
    wb -= tb83 * along2;
    tb82 = along1b / w;
    un1b = tb82;
    wb -= tb82 * along1;
    tb81 = along0b / w;
    un0b = tb81;
    wb -= tb81 * along0;
    tb78 = r2b / w;
    tb79 = tb78 * normal0;
    g0b = tb79;
    xb = -tb79;
    normal0b += tb78 * (g0 - x);
    tb80 = tb78 * normal2;
    g2_2b = tb80;
    h10b = -tb80;
    normal2b += tb78 * (g2_2 - h10);
    wb -= tb78 * r2;
    t39b = wb * (1.0 / (2.0 * w));
    un0b += t39b * un0;
    un0b += t39b * un0;
    un1b += t39b * un1;
    un1b += t39b * un1;
    un2b += t39b * un2;
    un2b += t39b * un2;
    u0b += un2b * normal1;
    u1b -= un2b * normal0;
    normal0b -= un2b * u1;
    u2_2b += un1b * normal0;
    normal0b += un1b * u2_2;
    u0b -= un1b * normal2;
    normal2b -= un1b * u0;
    u1b += un0b * normal2;
    normal2b += un0b * u1;
    u2_2b -= un0b * normal1;
    u0b += cb * normal0;
    normal0b += cb * u0;
    u1b += cb * normal1;
    u2_2b += cb * normal2;
    normal2b += cb * u2_2;
    tb77 = normal2b / s;
    sb = -(tb77 * normal2);
    tb76 = normal0b / s;
    h11b = -tb76;
    sb -= tb76 * normal0;
    t38b = sb * (1.0 / (2.0 * s));
    h11b += t38b * h11;
    h11b += t38b * h11;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road4 = p[t->roadadr[road]];
      h12b = 0.0;
      p_road4b = h11b;
      h11b = 0.0;
      p_road4b += h10b * x;
      xb += h10b * p_road4;
      h10b = 0.0;
      pb[t->roadadr[road]] += p_road4b;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k7 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      t18 = k7 * x;
      t19 = sin(t18);
      p_road5 = p[t->roadadr[road]];
      t20 = k7 * x;
      t21 = cos(t20);
      h12b = 0.0;
      tb37 = h11b * t21;
      k7b = tb37 * p_road5;
      p_road5b = tb37 * k7;
      t21b = h11b * (k7 * p_road5);
      h11b = 0.0;
      t20b = -(t21b * sin(t20));
      k7b += t20b * x;
      xb += t20b * k7;
      p_road5b += h10b * t19;
      t19b = h10b * p_road5;
      h10b = 0.0;
      pb[t->roadadr[road]] += p_road5b;
      t18b = t19b * cos(t18);
      k7b += t18b * x;
      xb += t18b * k7;
      tb36 = k7b / p[t->roadadr[road] + 1];
      pb[t->roadadr[road] + 1] -= tb36 * k7;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k6 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x);
      x4 = x - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k6 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius2 = p[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      c4 = sqrt(t22);
      f3 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x4) > 0.0) {
        way2 = 1.0;
      } else {
        way2 = -1.0;
      }
      y2 = way2 * x4;
      b31b = h12b;
      h12b = 0.0;
      h11b = 0.0;
      b30b = h10b;
      h10b = 0.0;
      base2b = 0.0;
      c4b = 0.0;
      f3b = 0.0;
      radius2b = 0.0;
      x4b = 0.0;
      y2b = 0.0;
      if (MAGGI_RE(y2) >= MAGGI_RE(c4 + f3)) {
        b31b = 0.0;
        b30b = 0.0;
      } else if (MAGGI_RE(y2) > MAGGI_RE(c4 - f3)) {
        t23 = radius2 * radius2 - (c4 - f3) * (c4 - f3);
        z3 = sqrt(t23);
        h0_3 = z3 - base2;
        h1_3 = 2.0 * f3 * (c4 - f3) / z3;
        a3 = 3.0 * h0_3 - h1_3;
        t24 = z3 * z3 * z3;
        t25 = 2.0 * f3 * f3 * radius2 * radius2 / t24;
        b4 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        t26 = 2.0 * f3;
        u3 = (c4 + f3 - y2) / t26;
        w3 = 1.0 - u3;
        t27 = 2.0 * f3;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 * (a3 + 2.0 * w3 * b4)) /
            t27;
        t28b = b31b;
        b31b = 0.0;
        tb51 = t28b / t27;
        tb52 = tb51 * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 * (a3 + 2.0 * w3 * b4));
        u3b = -(tb52 * u3 * way2);
        u3b += tb52 * (-way2 * u3);
        tb53 = tb51 * (-way2 * u3 * u3);
        tb54 = tb53 * 3.0;
        h0_3b = tb54;
        w3b = tb54 * (a3 + w3 * b4);
        tb55 = tb54 * w3;
        a3b = tb55;
        w3b += tb55 * b4;
        b4b = tb55 * w3;
        u3b -= tb53 * (a3 + 2.0 * w3 * b4);
        tb56 = tb53 * u3;
        a3b -= tb56;
        w3b -= tb56 * b4 * 2.0;
        b4b -= tb56 * (2.0 * w3);
        t27b = -(tb51 * t28);
        f3b += t27b * 2.0;
        tb47 = b30b * (h0_3 + w3 * (a3 + w3 * b4));
        tb48 = tb47 * u3;
        u3b += tb48 * u3;
        u3b += tb48 * u3;
        u3b += tb47 * (u3 * u3);
        tb49 = b30b * (u3 * u3 * u3);
        h0_3b += tb49;
        w3b += tb49 * (a3 + w3 * b4);
        tb50 = tb49 * w3;
        a3b += tb50;
        w3b += tb50 * b4;
        b4b += tb50 * w3;
        b30b = 0.0;
        u3b -= w3b;
        tb46 = u3b / t26;
        c4b += tb46;
        f3b += tb46;
        y2b -= tb46;
        t26b = -(tb46 * u3);
        f3b += t26b * 2.0;
        h0_3b += b4b * 6.0;
        h1_3b = -(b4b * 3.0);
        t25b = -b4b;
        tb43 = t25b / t24;
        tb44 = tb43 * radius2;
        tb45 = tb44 * radius2;
        f3b += tb45 * f3 * 2.0;
        f3b += tb45 * (2.0 * f3);
        radius2b += tb44 * (2.0 * f3 * f3);
        radius2b += tb43 * (2.0 * f3 * f3 * radius2);
        t24b = -(tb43 * t25);
        tb42 = t24b * z3;
        z3b = tb42 * z3;
        z3b += tb42 * z3;
        z3b += t24b * (z3 * z3);
        h0_3b += a3b * 3.0;
        h1_3b -= a3b;
        tb40 = h1_3b / z3;
        f3b += tb40 * (c4 - f3) * 2.0;
        tb41 = tb40 * (2.0 * f3);
        c4b += tb41;
        f3b -= tb41;
        z3b -= tb40 * h1_3;
        z3b += h0_3b;
        base2b -= h0_3b;
        t23b = z3b * (1.0 / (2.0 * z3));
        radius2b += t23b * radius2;
        radius2b += t23b * radius2;
        tb38 = t23b * (c4 - f3);
        c4b -= tb38;
        f3b += tb38;
        tb39 = t23b * (c4 - f3);
        c4b -= tb39;
        f3b += tb39;
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        z3_3 = sqrt(t29);
        t30 = -x4 / z3_3;
        t30b = b31b;
        b31b = 0.0;
        tb57 = t30b / z3_3;
        x4b -= tb57;
        z3_3b = -(tb57 * t30);
        z3_3b += b30b;
        base2b -= b30b;
        b30b = 0.0;
        t29b = z3_3b * (1.0 / (2.0 * z3_3));
        radius2b += t29b * radius2;
        radius2b += t29b * radius2;
        y2b -= t29b * y2;
        y2b -= t29b * y2;
      }
      x4b += y2b * way2;
      pb[t->roadadr[road] + MAGGI_BUMPS_FILLET] += f3b * 0.5;
      t22b = c4b * (1.0 / (2.0 * c4));
      radius2b += t22b * radius2;
      radius2b += t22b * radius2;
      base2b -= t22b * base2;
      base2b -= t22b * base2;
      radius2b += base2b;
      pb[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= base2b;
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      pb[t->roadadr[road]] += radius2b;
      xb += x4b;
      pb[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x4b;
      pb[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x4b * k6;
    } else {
      k8 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x);
      h12b = 0.0;
      s31b = h11b;
      h11b = 0.0;
      s30b = h10b;
      h10b = 0.0;
      if (k8 < 0) {
        p_road6 = p[t->roadadr[road]];
        h2 = p[t->roadadr[road] + 1] - p_road6;
        p_roadroad2 = p[t->roadadr[road] + t->roadn[road]];
        t31 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2) / h2;
        slope2 = t31 - h2 / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]);
        slope2b = s31b;
        s31b = 0.0;
        p_roadroad2b = s30b;
        slope2b += s30b * (x - p_road6);
        tb60 = s30b * slope2;
        xb += tb60;
        p_road6b = -tb60;
        s30b = 0.0;
        t31b = slope2b;
        h2b = -(slope2b * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) / 6.0);
        tb59 = slope2b * (h2 / 6.0);
        spline0b[t->roadspline[road]][0] -= tb59 * 2.0;
        spline0b[t->roadspline[road] + 1][0] -= tb59;
        tb58 = t31b / h2;
        pb[t->roadadr[road] + t->roadn[road] + 1] += tb58;
        p_roadroad2b -= tb58;
        h2b -= tb58 * t31;
        pb[t->roadadr[road] + t->roadn[road]] += p_roadroad2b;
        pb[t->roadadr[road] + 1] += h2b;
        p_road6b -= h2b;
        pb[t->roadadr[road]] += p_road6b;
      } else if (k8 > t->roadn[road] - 2) {
        p5 = p[t->roadadr[road] + t->roadn[road] - 1];
        h2_2 = p5 - p[t->roadadr[road] + t->roadn[road] - 2];
        p6 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t32 = (p6 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h2_2;
        slope2_2 = t32 + h2_2 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        slope2_2b = s31b;
        s31b = 0.0;
        p6b = s30b;
        slope2_2b += s30b * (x - p5);
        tb63 = s30b * slope2_2;
        xb += tb63;
        p5b = -tb63;
        s30b = 0.0;
        t32b = slope2_2b;
        h2_2b = slope2_2b * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) / 6.0;
        tb62 = slope2_2b * (h2_2 / 6.0);
        spline0b[t->roadspline[road] + t->roadn[road] - 2][0] += tb62;
        spline0b[t->roadspline[road] + t->roadn[road] - 1][0] += tb62 * 2.0;
        tb61 = t32b / h2_2;
        p6b += tb61;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb61;
        h2_2b -= tb61 * t32;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p6b;
        p5b += h2_2b;
        pb[t->roadadr[road] + t->roadn[road] - 2] -= h2_2b;
        pb[t->roadadr[road] + t->roadn[road] - 1] += p5b;
      } else {
        p_roadk81 = p[t->roadadr[road] + k8 + 1];
        p_roadk8 = p[t->roadadr[road] + k8];
        h2_3 = p_roadk81 - p_roadk8;
        a4 = p_roadk81 - x;
        c5 = x - p_roadk8;
        p7 = p[t->roadadr[road] + t->roadn[road] + k8];
        t33 = (p[t->roadadr[road] + t->roadn[road] + k8 + 1] - p7) / h2_3;
        spline0_roadk810 = spline0[t->roadspline[road] + k8 + 1][0];
        spline0_roadk80 = spline0[t->roadspline[road] + k8][0];
        e2 = t33 - h2_3 / 6.0 * (spline0_roadk810 - spline0_roadk80);
        t34 = 6.0 * h2_3;
        t35 = (spline0_roadk80 * a4 * a4 * a4 + spline0_roadk810 * c5 * c5 * c5) / t34;
        t36 = 2.0 * h2_3;
        t37 = (spline0_roadk810 * c5 * c5 - spline0_roadk80 * a4 * a4) / t36;
        t37b = s31b;
        e2b = s31b;
        s31b = 0.0;
        tb73 = t37b / t36;
        tb74 = tb73 * c5;
        spline0_roadk810b = tb74 * c5;
        c5b = tb74 * spline0_roadk810;
        c5b += tb73 * (spline0_roadk810 * c5);
        tb75 = tb73 * a4;
        spline0_roadk80b = -(tb75 * a4);
        a4b = -(tb75 * spline0_roadk80);
        a4b -= tb73 * (spline0_roadk80 * a4);
        t36b = -(tb73 * t37);
        h2_3b = t36b * 2.0;
        t35b = s30b;
        p7b = s30b;
        tb71 = s30b / 6.0;
        tb72 = tb71 * h2_3;
        spline0_roadk80b -= tb72 * h2_3;
        h2_3b -= tb72 * spline0_roadk80;
        h2_3b -= tb71 * (spline0_roadk80 * h2_3);
        e2b += s30b * c5;
        c5b += s30b * e2;
        s30b = 0.0;
        tb66 = t35b / t34;
        tb67 = tb66 * a4;
        tb68 = tb67 * a4;
        spline0_roadk80b += tb68 * a4;
        a4b += tb68 * spline0_roadk80;
        a4b += tb67 * (spline0_roadk80 * a4);
        a4b += tb66 * (spline0_roadk80 * a4 * a4);
        tb69 = tb66 * c5;
        tb70 = tb69 * c5;
        spline0_roadk810b += tb70 * c5;
        c5b += tb70 * spline0_roadk810;
        c5b += tb69 * (spline0_roadk810 * c5);
        c5b += tb66 * (spline0_roadk810 * c5 * c5);
        t34b = -(tb66 * t35);
        h2_3b += t34b * 6.0;
        t33b = e2b;
        h2_3b -= e2b * (spline0_roadk810 - spline0_roadk80) / 6.0;
        tb65 = e2b * (h2_3 / 6.0);
        spline0_roadk810b -= tb65;
        spline0_roadk80b += tb65;
        spline0b[t->roadspline[road] + k8][0] += spline0_roadk80b;
        spline0b[t->roadspline[road] + k8 + 1][0] += spline0_roadk810b;
        tb64 = t33b / h2_3;
        pb[t->roadadr[road] + t->roadn[road] + k8 + 1] += tb64;
        p7b -= tb64;
        h2_3b -= tb64 * t33;
        pb[t->roadadr[road] + t->roadn[road] + k8] += p7b;
        xb += c5b;
        p_roadk8b = -c5b;
        p_roadk81b = a4b;
        xb -= a4b;
        p_roadk81b += h2_3b;
        p_roadk8b -= h2_3b;
        pb[t->roadadr[road] + k8] += p_roadk8b;
        pb[t->roadadr[road] + k8 + 1] += p_roadk81b;
      }
    }
    g0b += xb;
    t17b = xb * (g2_2 - h00);
    tb35 = xb * t17;
    g2_2b += tb35;
    h00b = -tb35;
    tb34 = t17b / t16;
    u2_2b += tb34 * u0;
    u0b += tb34 * u2_2;
    t16b = -(tb34 * t17);
    u0b += t16b * u0;
    u0b += t16b * u0;
    u1b += t16b * u1;
    u1b += t16b * u1;
    x2b = 0.0;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      p_roadb = h00b * x2;
      x2b += h00b * p_road;
      h00b = 0.0;
      pb[t->roadadr[road]] += p_roadb;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k4 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      t3 = k4 * x2;
      t4 = sin(t3);
      p_road2 = p[t->roadadr[road]];
      p_road2b = h00b * t4;
      t4b = h00b * p_road2;
      h00b = 0.0;
      pb[t->roadadr[road]] += p_road2b;
      t3b = t4b * cos(t3);
      k4b = t3b * x2;
      x2b += t3b * k4;
      tb5 = k4b / p[t->roadadr[road] + 1];
      pb[t->roadadr[road] + 1] -= tb5 * k4;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k3 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x2);
      x3 = x2 - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k3 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius = p[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      c2 = sqrt(t5);
      f2 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x3) > 0.0) {
        way = 1.0;
      } else {
        way = -1.0;
      }
      y = way * x3;
      b0b = h00b;
      h00b = 0.0;
      baseb = 0.0;
      c2b = 0.0;
      f2b = 0.0;
      radiusb = 0.0;
      yb = 0.0;
      if (MAGGI_RE(y) >= MAGGI_RE(c2 + f2)) {
        b0b = 0.0;
      } else if (MAGGI_RE(y) > MAGGI_RE(c2 - f2)) {
        t6 = radius * radius - (c2 - f2) * (c2 - f2);
        z2 = sqrt(t6);
        h0_2 = z2 - base;
        h1_2 = 2.0 * f2 * (c2 - f2) / z2;
        a = 3.0 * h0_2 - h1_2;
        t7 = z2 * z2 * z2;
        t8 = 2.0 * f2 * f2 * radius * radius / t7;
        b2 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        t9 = 2.0 * f2;
        u2 = (c2 + f2 - y) / t9;
        w2 = 1.0 - u2;
        tb15 = b0b * (h0_2 + w2 * (a + w2 * b2));
        tb16 = tb15 * u2;
        u2b = tb16 * u2;
        u2b += tb16 * u2;
        u2b += tb15 * (u2 * u2);
        tb17 = b0b * (u2 * u2 * u2);
        h0_2b = tb17;
        w2b = tb17 * (a + w2 * b2);
        tb18 = tb17 * w2;
        ab = tb18;
        w2b += tb18 * b2;
        b2b = tb18 * w2;
        b0b = 0.0;
        u2b -= w2b;
        tb14 = u2b / t9;
        c2b += tb14;
        f2b += tb14;
        yb -= tb14;
        t9b = -(tb14 * u2);
        f2b += t9b * 2.0;
        h0_2b += b2b * 6.0;
        h1_2b = -(b2b * 3.0);
        t8b = -b2b;
        tb11 = t8b / t7;
        tb12 = tb11 * radius;
        tb13 = tb12 * radius;
        f2b += tb13 * f2 * 2.0;
        f2b += tb13 * (2.0 * f2);
        radiusb += tb12 * (2.0 * f2 * f2);
        radiusb += tb11 * (2.0 * f2 * f2 * radius);
        t7b = -(tb11 * t8);
        tb10 = t7b * z2;
        z2b = tb10 * z2;
        z2b += tb10 * z2;
        z2b += t7b * (z2 * z2);
        h0_2b += ab * 3.0;
        h1_2b -= ab;
        tb8 = h1_2b / z2;
        f2b += tb8 * (c2 - f2) * 2.0;
        tb9 = tb8 * (2.0 * f2);
        c2b += tb9;
        f2b -= tb9;
        z2b -= tb8 * h1_2;
        z2b += h0_2b;
        baseb -= h0_2b;
        t6b = z2b * (1.0 / (2.0 * z2));
        radiusb += t6b * radius;
        radiusb += t6b * radius;
        tb6 = t6b * (c2 - f2);
        c2b -= tb6;
        f2b += tb6;
        tb7 = t6b * (c2 - f2);
        c2b -= tb7;
        f2b += tb7;
      } else {
        t10 = radius * radius - y * y;
        z2_3 = sqrt(t10);
        z2_3b = b0b;
        baseb -= b0b;
        b0b = 0.0;
        t10b = z2_3b * (1.0 / (2.0 * z2_3));
        radiusb += t10b * radius;
        radiusb += t10b * radius;
        yb -= t10b * y;
        yb -= t10b * y;
      }
      x3b = yb * way;
      pb[t->roadadr[road] + MAGGI_BUMPS_FILLET] += f2b * 0.5;
      t5b = c2b * (1.0 / (2.0 * c2));
      radiusb += t5b * radius;
      radiusb += t5b * radius;
      baseb -= t5b * base;
      baseb -= t5b * base;
      radiusb += baseb;
      pb[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= baseb;
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      pb[t->roadadr[road]] += radiusb;
      x2b += x3b;
      pb[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x3b;
      pb[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x3b * k3;
    } else {
      k5 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x2);
      s20b = h00b;
      h00b = 0.0;
      if (k5 < 0) {
        p_road3 = p[t->roadadr[road]];
        h = p[t->roadadr[road] + 1] - p_road3;
        p_roadroad = p[t->roadadr[road] + t->roadn[road]];
        t11 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad) / h;
        slope = t11 - h / 6.0 * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road]
            + 1][0]);
        p_roadroadb = s20b;
        slopeb = s20b * (x2 - p_road3);
        tb21 = s20b * slope;
        x2b += tb21;
        p_road3b = -tb21;
        s20b = 0.0;
        t11b = slopeb;
        hb = -(slopeb * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) / 6.0);
        tb20 = slopeb * (h / 6.0);
        spline0b[t->roadspline[road]][0] -= tb20 * 2.0;
        spline0b[t->roadspline[road] + 1][0] -= tb20;
        tb19 = t11b / h;
        pb[t->roadadr[road] + t->roadn[road] + 1] += tb19;
        p_roadroadb -= tb19;
        hb -= tb19 * t11;
        pb[t->roadadr[road] + t->roadn[road]] += p_roadroadb;
        pb[t->roadadr[road] + 1] += hb;
        p_road3b -= hb;
        pb[t->roadadr[road]] += p_road3b;
      } else if (k5 > t->roadn[road] - 2) {
        p2 = p[t->roadadr[road] + t->roadn[road] - 1];
        h3 = p2 - p[t->roadadr[road] + t->roadn[road] - 2];
        p3 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t12 = (p3 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h3;
        slope3 = t12 + h3 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        p3b = s20b;
        slope3b = s20b * (x2 - p2);
        tb24 = s20b * slope3;
        x2b += tb24;
        p2b = -tb24;
        s20b = 0.0;
        t12b = slope3b;
        h3b = slope3b * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) / 6.0;
        tb23 = slope3b * (h3 / 6.0);
        spline0b[t->roadspline[road] + t->roadn[road] - 2][0] += tb23;
        spline0b[t->roadspline[road] + t->roadn[road] - 1][0] += tb23 * 2.0;
        tb22 = t12b / h3;
        p3b += tb22;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb22;
        h3b -= tb22 * t12;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p3b;
        p2b += h3b;
        pb[t->roadadr[road] + t->roadn[road] - 2] -= h3b;
        pb[t->roadadr[road] + t->roadn[road] - 1] += p2b;
      } else {
        p_roadk51 = p[t->roadadr[road] + k5 + 1];
        p_roadk5 = p[t->roadadr[road] + k5];
        h3_2 = p_roadk51 - p_roadk5;
        a2 = p_roadk51 - x2;
        c3 = x2 - p_roadk5;
        p4 = p[t->roadadr[road] + t->roadn[road] + k5];
        t13 = (p[t->roadadr[road] + t->roadn[road] + k5 + 1] - p4) / h3_2;
        spline0_roadk510 = spline0[t->roadspline[road] + k5 + 1][0];
        spline0_roadk50 = spline0[t->roadspline[road] + k5][0];
        e = t13 - h3_2 / 6.0 * (spline0_roadk510 - spline0_roadk50);
        t14 = 6.0 * h3_2;
        t15 = (spline0_roadk50 * a2 * a2 * a2 + spline0_roadk510 * c3 * c3 * c3) / t14;
        t15b = s20b;
        p4b = s20b;
        tb32 = s20b / 6.0;
        tb33 = tb32 * h3_2;
        spline0_roadk50b = -(tb33 * h3_2);
        h3_2b = -(tb33 * spline0_roadk50);
        h3_2b -= tb32 * (spline0_roadk50 * h3_2);
        eb = s20b * c3;
        c3b = s20b * e;
        s20b = 0.0;
        tb27 = t15b / t14;
        tb28 = tb27 * a2;
        tb29 = tb28 * a2;
        spline0_roadk50b += tb29 * a2;
        a2b = tb29 * spline0_roadk50;
        a2b += tb28 * (spline0_roadk50 * a2);
        a2b += tb27 * (spline0_roadk50 * a2 * a2);
        tb30 = tb27 * c3;
        tb31 = tb30 * c3;
        spline0_roadk510b = tb31 * c3;
        c3b += tb31 * spline0_roadk510;
        c3b += tb30 * (spline0_roadk510 * c3);
        c3b += tb27 * (spline0_roadk510 * c3 * c3);
        t14b = -(tb27 * t15);
        h3_2b += t14b * 6.0;
        t13b = eb;
        h3_2b -= eb * (spline0_roadk510 - spline0_roadk50) / 6.0;
        tb26 = eb * (h3_2 / 6.0);
        spline0_roadk510b -= tb26;
        spline0_roadk50b += tb26;
        spline0b[t->roadspline[road] + k5][0] += spline0_roadk50b;
        spline0b[t->roadspline[road] + k5 + 1][0] += spline0_roadk510b;
        tb25 = t13b / h3_2;
        pb[t->roadadr[road] + t->roadn[road] + k5 + 1] += tb25;
        p4b -= tb25;
        h3_2b -= tb25 * t13;
        pb[t->roadadr[road] + t->roadn[road] + k5] += p4b;
        x2b += c3b;
        p_roadk5b = -c3b;
        p_roadk51b = a2b;
        x2b -= a2b;
        p_roadk51b += h3_2b;
        p_roadk5b -= h3_2b;
        pb[t->roadadr[road] + k5] += p_roadk5b;
        pb[t->roadadr[road] + k5 + 1] += p_roadk51b;
      }
    }
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n|, slope that the plane lacks */
    g0b += x2b;
    rb[t->wheelpoint[i]][2] += g2_2b;
    rb[t->roadpoint[road]][2] -= g2_2b;
    rb[t->wheelpoint[i]][0] += g0b;
    rb[t->roadpoint[road]][0] -= g0b;
    tb4 = u2_2b / n2;
    ua2b = tb4;
    n2b = -(tb4 * u2_2);
    tb3 = u1b / n2;
    ua1b = tb3;
    n2b -= tb3 * u1;
    tb2 = u0b / n2;
    ua0b = tb2;
    n2b -= tb2 * u0;
    t2b = n2b * (1.0 / (2.0 * n2));
    ua0b += t2b * ua0;
    ua0b += t2b * ua0;
    ua1b += t2b * ua1;
    ua1b += t2b * ua1;
    ua2b += t2b * ua2;
    ua2b += t2b * ua2;
    Ab[t->wheelbody[i]][6] += ua2b * axis0;
    axis0b = ua2b * A[t->wheelbody[i]][6];
    Ab[t->wheelbody[i]][7] += ua2b * axis1;
    axis1b = ua2b * A[t->wheelbody[i]][7];
    Ab[t->wheelbody[i]][8] += ua2b * axis2;
    axis2b = ua2b * A[t->wheelbody[i]][8];
    Ab[t->wheelbody[i]][3] += ua1b * axis0;
    axis0b += ua1b * A[t->wheelbody[i]][3];
    Ab[t->wheelbody[i]][4] += ua1b * axis1;
    axis1b += ua1b * A[t->wheelbody[i]][4];
    Ab[t->wheelbody[i]][5] += ua1b * axis2;
    axis2b += ua1b * A[t->wheelbody[i]][5];
    Ab[t->wheelbody[i]][0] += ua0b * axis0;
    axis0b += ua0b * A[t->wheelbody[i]][0];
    Ab[t->wheelbody[i]][1] += ua0b * axis1;
    axis1b += ua0b * A[t->wheelbody[i]][1];
    Ab[t->wheelbody[i]][2] += ua0b * axis2;
    axis2b += ua0b * A[t->wheelbody[i]][2];
    pb[t->wheelaxis[i] + 2] += axis2b;
    pb[t->wheelaxis[i] + 1] += axis1b;
    pb[t->wheelaxis[i]] += axis0b;
  }
}

/* Rates of the coordinates on which wheels turn at which they roll freely, kappa = 0: with w that of the
 * carrier and w_q that of the wheel on it at the rate 1
 *   v = (V.t / Re - w.u) / (w_q.u) */
void maggi_rolling_b(const maggi_topo *t, const double p[restrict t->np], double pb[restrict t->np],
                     const double spline0[restrict t->nspline][3],
                     double spline0b[restrict t->nspline][3],
                     const double A[restrict t->nbody + 1][9], double Ab[restrict t->nbody + 1][9],
                     const double b[restrict t->nbody][6], double bb[restrict t->nbody][6],
                     const double r[restrict t->npoint][3], double rb[restrict t->npoint][3],
                     const double Z[restrict t->nbody + 1][6], double Zb[restrict t->nbody + 1][6],
                     double spin[restrict t->nwheel], double spinb[restrict t->nwheel])
{
  int adr, body, carrier, i, k4, k6, k7, k9, road;
  double N0, N0b, N1, N2, N2b, T0, T0b, T1, T1b, T2, T2b, a, a2, a2b, a3, a3b, a4, a4b, ab, along0,
      along0b, along1, along1b, along2, along2b, arm0, arm0b, arm1, arm1b, arm2, arm2b, axis0,
      axis0b, axis1, axis1b, axis2, axis2b, b20, b20b, b3, b3b, b40, b40b, b41, b41b, b5, b5b, base,
      base2, base2b, baseb, c, c2, c2b, c3, c3b, c4, c4b, c5, c5b, cb, e, e2, e2b, eb, f, f2, f2b,
      fb, fz, fz0, fz0b, fzb, g0, g0b, g2, g2b, h, h00, h00b, h0_2, h0_2b, h0_3, h0_3b, h10, h10b,
      h11, h11b, h12, h12b, h1_2, h1_2b, h1_3, h1_3b, h2, h2_2, h2_2b, h2_3, h2_3b, h2b, h3, h3_2,
      h3_2b, h3b, hb, k5, k5b, k8, k8b, n2, n2b, normal0, normal0b, normal1, normal2, normal2b, p2,
      p2b, p3, p3b, p4, p4b, p5, p5b, p6, p6b, p7, p7b, p_road, p_road2, p_road2b, p_road3,
      p_road3b, p_road4, p_road4b, p_road5, p_road5b, p_road6, p_road6b, p_roadb, p_roadk6,
      p_roadk61, p_roadk61b, p_roadk6b, p_roadk9, p_roadk91, p_roadk91b, p_roadk9b, p_roadroad,
      p_roadroad2, p_roadroad2b, p_roadroadb, r2, r2b, r_i0, r_i0b, r_i1, r_i1b, r_i2, r_i2b,
      radius, radius2, radius2b, radiusb, ratio, ratiob, re, re2, re2b, reb, rhov, rhovb, s, s20,
      s20b, s30, s30b, s31, s31b, sb, slope, slope2, slope2_2, slope2_2b, slope2b, slope3, slope3b,
      slopeb, spline0_roadk60, spline0_roadk60b, spline0_roadk610, spline0_roadk610b,
      spline0_roadk90, spline0_roadk90b, spline0_roadk910, spline0_roadk910b, t10, t10b, t11, t11b,
      t12, t12b, t13, t13b, t14, t14b, t15, t15b, t16, t16b, t17, t17b, t18, t18b, t19, t19b, t2,
      t20, t20b, t21, t21b, t22, t22b, t23, t23b, t24, t24b, t25, t25b, t26, t26b, t27, t27b, t28,
      t28b, t29, t29b, t2b, t3, t30, t30b, t31, t31b, t32, t32b, t33, t33b, t34, t34b, t35, t35b,
      t36, t36b, t37, t37b, t38, t38b, t39, t39b, t3b, t4, t40, t40b, t41, t41b, t42, t42b, t43,
      t43b, t44, t44b, t4b, t5, t5b, t6, t6b, t7, t7b, t8, t8b, t9, t9b, tb10, tb11, tb12, tb13,
      tb14, tb15, tb16, tb17, tb18, tb19, tb2, tb20, tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28,
      tb29, tb3, tb30, tb31, tb32, tb33, tb34, tb35, tb36, tb37, tb38, tb39, tb4, tb40, tb41, tb42,
      tb43, tb44, tb45, tb46, tb47, tb48, tb49, tb5, tb50, tb51, tb52, tb53, tb54, tb55, tb56, tb57,
      tb58, tb59, tb6, tb60, tb61, tb62, tb63, tb64, tb65, tb66, tb67, tb68, tb69, tb7, tb70, tb71,
      tb72, tb73, tb74, tb75, tb76, tb77, tb78, tb79, tb8, tb80, tb81, tb82, tb83, tb84, tb85, tb86,
      tb87, tb88, tb89, tb9, tb90, tb91, tb92, tb93, tb94, tb95, tb96, tb97, turn, turnb, u0, u0b,
      u1, u1b, u2, u2_2, u2_2b, u2b, u3, u3b, ua0, ua0b, ua1, ua1b, ua2, ua2b, un0, un0b, un1, un1b,
      un2, un2b, v0, v0b, v1, v1b, v2, v2b, vc0, vc0b, vc1, vc1b, vc2, vc2b, vr0, vr0b, vr1, vr1b,
      vr2, vr2b, w0, w0b, w1, w1b, w2, w2_2, w2_2b, w2b, w3, w3b, w4, w4b, way, way2, wr0, wr0b,
      wr1, wr1b, wr2, wr2b, x, x2, x2b, x3, x3b, x4, x4b, xb, y, y2, y2b, yb, z0, z0b, z2, z2_2,
      z2_2b, z2_3, z2_3b, z2b, z3, z3_2, z3_2b, z3_3, z3_3b, z3b;

  for (i = t->nwheel - 1; i >= 0; --i) {
    adr = t->tyreadr[t->wheeltyre[i]];
    body = t->wheelbody[i];
    carrier = t->wheelcarrier[i];
    road = t->wheelroad[i];
    axis0 = p[t->wheelaxis[i]];
    axis1 = p[t->wheelaxis[i] + 1];
    axis2 = p[t->wheelaxis[i] + 2];
    ua0 = A[t->wheelbody[i]][0] * axis0 + A[t->wheelbody[i]][1] * axis1 + A[t->wheelbody[i]][2] *
        axis2;
    ua1 = A[t->wheelbody[i]][3] * axis0 + A[t->wheelbody[i]][4] * axis1 + A[t->wheelbody[i]][5] *
        axis2;
    ua2 = A[t->wheelbody[i]][6] * axis0 + A[t->wheelbody[i]][7] * axis1 + A[t->wheelbody[i]][8] *
        axis2;
    t2 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
    n2 = sqrt(t2);
    u0 = ua0 / n2;
    u1 = ua1 / n2;
    u2_2 = ua2 / n2;
    g0 = r[t->wheelpoint[i]][0] - r[t->roadpoint[road]][0];
    g2 = r[t->wheelpoint[i]][2] - r[t->roadpoint[road]][2];
    x2 = g0;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      h00 = p_road * x2;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k5 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      t3 = k5 * x2;
      t4 = sin(t3);
      p_road2 = p[t->roadadr[road]];
      h00 = p_road2 * t4;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k4 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x2);
      x3 = x2 - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k4 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius = p[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      c2 = sqrt(t5);
      f = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x3) > 0.0) {
        way = 1.0;
      } else {
        way = -1.0;
      }
      y = way * x3;
      if (MAGGI_RE(y) >= MAGGI_RE(c2 + f)) {
        b20 = 0.0;
      } else if (MAGGI_RE(y) > MAGGI_RE(c2 - f)) {
        t6 = radius * radius - (c2 - f) * (c2 - f);
        z2 = sqrt(t6);
        h0_2 = z2 - base;
        h1_2 = 2.0 * f * (c2 - f) / z2;
        a = 3.0 * h0_2 - h1_2;
        t7 = z2 * z2 * z2;
        t8 = 2.0 * f * f * radius * radius / t7;
        b3 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        t9 = 2.0 * f;
        u2 = (c2 + f - y) / t9;
        w3 = 1.0 - u2;
        b20 = u2 * u2 * u2 * (h0_2 + w3 * (a + w3 * b3));
      } else {
        t10 = radius * radius - y * y;
        z2_3 = sqrt(t10);
        b20 = z2_3 - base;
      }
      h00 = b20;
    } else {
      k6 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x2);
      if (k6 < 0) {
        p_road3 = p[t->roadadr[road]];
        h = p[t->roadadr[road] + 1] - p_road3;
        p_roadroad = p[t->roadadr[road] + t->roadn[road]];
        t11 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad) / h;
        slope = t11 - h / 6.0 * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road]
            + 1][0]);
        s20 = p_roadroad + slope * (x2 - p_road3);
      } else if (k6 > t->roadn[road] - 2) {
        p2 = p[t->roadadr[road] + t->roadn[road] - 1];
        h3 = p2 - p[t->roadadr[road] + t->roadn[road] - 2];
        p3 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t12 = (p3 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h3;
        slope3 = t12 + h3 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        s20 = p3 + slope3 * (x2 - p2);
      } else {
        p_roadk61 = p[t->roadadr[road] + k6 + 1];
        p_roadk6 = p[t->roadadr[road] + k6];
        h3_2 = p_roadk61 - p_roadk6;
        a2 = p_roadk61 - x2;
        c3 = x2 - p_roadk6;
        p4 = p[t->roadadr[road] + t->roadn[road] + k6];
        t13 = (p[t->roadadr[road] + t->roadn[road] + k6 + 1] - p4) / h3_2;
        spline0_roadk610 = spline0[t->roadspline[road] + k6 + 1][0];
        spline0_roadk60 = spline0[t->roadspline[road] + k6][0];
        e = t13 - h3_2 / 6.0 * (spline0_roadk610 - spline0_roadk60);
        t14 = 6.0 * h3_2;
        t15 = (spline0_roadk60 * a2 * a2 * a2 + spline0_roadk610 * c3 * c3 * c3) / t14;
        s20 = t15 + p4 - spline0_roadk60 * h3_2 * h3_2 / 6.0 + e * c3;
      }
      h00 = s20;
    }
    t16 = u0 * u0 + u1 * u1;
    t17 = u2_2 * u0 / t16;
    x = g0 + t17 * (g2 - h00);
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road4 = p[t->roadadr[road]];
      h10 = p_road4 * x;
      h11 = p_road4;
      h12 = 0.0;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k8 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      t18 = k8 * x;
      t19 = sin(t18);
      p_road5 = p[t->roadadr[road]];
      h10 = p_road5 * t19;
      t20 = k8 * x;
      t21 = cos(t20);
      h11 = k8 * p_road5 * t21;
      h12 = 0.0;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k7 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x);
      x4 = x - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k7 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius2 = p[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      c4 = sqrt(t22);
      f2 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x4) > 0.0) {
        way2 = 1.0;
      } else {
        way2 = -1.0;
      }
      y2 = way2 * x4;
      if (MAGGI_RE(y2) >= MAGGI_RE(c4 + f2)) {
        b40 = 0.0;
        b41 = 0.0;
      } else if (MAGGI_RE(y2) > MAGGI_RE(c4 - f2)) {
        t23 = radius2 * radius2 - (c4 - f2) * (c4 - f2);
        z3 = sqrt(t23);
        h0_3 = z3 - base2;
        h1_3 = 2.0 * f2 * (c4 - f2) / z3;
        a3 = 3.0 * h0_3 - h1_3;
        t24 = z3 * z3 * z3;
        t25 = 2.0 * f2 * f2 * radius2 * radius2 / t24;
        b5 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        t26 = 2.0 * f2;
        u3 = (c4 + f2 - y2) / t26;
        w4 = 1.0 - u3;
        b40 = u3 * u3 * u3 * (h0_3 + w4 * (a3 + w4 * b5));
        t27 = 2.0 * f2;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 * (a3 + 2.0 * w4 * b5)) /
            t27;
        b41 = t28;
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        z3_3 = sqrt(t29);
        b40 = z3_3 - base2;
        t30 = -x4 / z3_3;
        b41 = t30;
      }
      h10 = b40;
      h11 = 0.0;
      h12 = b41;
    } else {
      k9 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x);
      if (k9 < 0) {
        p_road6 = p[t->roadadr[road]];
        h2 = p[t->roadadr[road] + 1] - p_road6;
        p_roadroad2 = p[t->roadadr[road] + t->roadn[road]];
        t31 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2) / h2;
        slope2 = t31 - h2 / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]);
        s30 = p_roadroad2 + slope2 * (x - p_road6);
        s31 = slope2;
      } else if (k9 > t->roadn[road] - 2) {
        p5 = p[t->roadadr[road] + t->roadn[road] - 1];
        h2_2 = p5 - p[t->roadadr[road] + t->roadn[road] - 2];
        p6 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t32 = (p6 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h2_2;
        slope2_2 = t32 + h2_2 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        s30 = p6 + slope2_2 * (x - p5);
        s31 = slope2_2;
      } else {
        p_roadk91 = p[t->roadadr[road] + k9 + 1];
        p_roadk9 = p[t->roadadr[road] + k9];
        h2_3 = p_roadk91 - p_roadk9;
        a4 = p_roadk91 - x;
        c5 = x - p_roadk9;
        p7 = p[t->roadadr[road] + t->roadn[road] + k9];
        t33 = (p[t->roadadr[road] + t->roadn[road] + k9 + 1] - p7) / h2_3;
        spline0_roadk910 = spline0[t->roadspline[road] + k9 + 1][0];
        spline0_roadk90 = spline0[t->roadspline[road] + k9][0];
        e2 = t33 - h2_3 / 6.0 * (spline0_roadk910 - spline0_roadk90);
        t34 = 6.0 * h2_3;
        t35 = (spline0_roadk90 * a4 * a4 * a4 + spline0_roadk910 * c5 * c5 * c5) / t34;
        s30 = t35 + p7 - spline0_roadk90 * h2_3 * h2_3 / 6.0 + e2 * c5;
        t36 = 2.0 * h2_3;
        t37 = (spline0_roadk910 * c5 * c5 - spline0_roadk90 * a4 * a4) / t36;
        s31 = t37 + e2;
      }
      h10 = s30;
      h11 = s31;
      h12 = 0.0;
    }
    t38 = 1.0 + h11 * h11;
    s = sqrt(t38);
    normal0 = -h11 / s;
    normal1 = 0.0;
    normal2 = 1.0 / s;
    c = u0 * normal0 + u1 * normal1 + u2_2 * normal2;
    un0 = u1 * normal2 - u2_2 * normal1;
    un1 = u2_2 * normal0 - u0 * normal2;
    un2 = u0 * normal1 - u1 * normal0;
    t39 = un0 * un0 + un1 * un1 + un2 * un2;
    w2 = sqrt(t39);
    r2 = ((g0 - x) * normal0 + (g2 - h10) * normal2) / w2;
    along0 = un0 / w2;
    along1 = un1 / w2;
    along2 = un2 / w2;
    arm0 = r2 * (c * u0 - normal0) / w2;
    T0 = along0;
    N0 = normal0;
    arm1 = r2 * (c * u1 - normal1) / w2;
    T1 = along1;
    N1 = normal1;
    arm2 = r2 * (c * u2_2 - normal2) / w2;
    T2 = along2;
    N2 = normal2;
    z0 = r2;
    z2_2 = w2;
    z3_2 = h12;
    w0 = Z[carrier][3];
    w1 = Z[carrier][4];
    w2_2 = Z[carrier][5];
    turn = w0 * u0 + w1 * u1 + w2_2 * u2_2;
    wr0 = w0 - turn * u0;
    wr1 = w1 - turn * u1;
    wr2 = w2_2 - turn * u2_2;
    r_i2 = r[t->wheelpoint[i]][2];
    r_i1 = r[t->wheelpoint[i]][1];
    vc0 = w1 * r_i2 - w2_2 * r_i1;
    r_i0 = r[t->wheelpoint[i]][0];
    vc1 = w2_2 * r_i0 - w0 * r_i2;
    vc2 = w0 * r_i1 - w1 * r_i0;
    vr0 = wr1 * arm2 - wr2 * arm1;
    vr1 = wr2 * arm0 - wr0 * arm2;
    vr2 = wr0 * arm1 - wr1 * arm0;
    v0 = Z[carrier][0] + vc0 + vr0;
    v1 = Z[carrier][1] + vc1 + vr1;
    v2 = Z[carrier][2] + vc2 + vr2;
    rhov = (z3_2 * v0 - (v0 * N0 + v1 * N1 + v2 * N2)) / z2_2;
    fz = p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] * (p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0) + p[adr
        + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
    fz0 = p[adr + MAGGI_TYRE_LFZO] * p[adr];
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      t40 = fz0 / p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t41 = p[adr + MAGGI_TYRE_BREFF] * ratio;
      t42 = atan(t41);
      re2 = p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - t40 * (p[adr + MAGGI_TYRE_DREFF] * t42 + p[adr +
          MAGGI_TYRE_FREFF] * ratio);
    } else {
      re2 = p[adr + MAGGI_TYRE_UNLOADED_RADIUS];
    }
    re = re2;
    t43 = (v0 * T0 + v1 * T1 + v2 * T2) / re;
    t44 = b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2_2;
    tb96 = spinb[i];
    spinb[i] = 0.0;
    tb97 = tb96 / t44;
    t43b = tb97;
    turnb = -tb97;
    t44b = -(tb97 * spin[i]);
    bb[body][3] += t44b * u0;
    u0b = t44b * b[body][3];
    bb[body][4] += t44b * u1;
    u1b = t44b * b[body][4];
    bb[body][5] += t44b * u2_2;
    u2_2b = t44b * b[body][5];
    tb95 = t43b / re;
    v0b = tb95 * T0;
    T0b = tb95 * v0;
    v1b = tb95 * T1;
    T1b = tb95 * v1;
    v2b = tb95 * T2;
    T2b = tb95 * v2;
    reb = -(tb95 * t43);
    re2b = reb;
    fz0b = 0.0;
    fzb = 0.0;
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      t40 = fz0 / p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t41 = p[adr + MAGGI_TYRE_BREFF] * ratio;
      t42 = atan(t41);
      pb[adr + MAGGI_TYRE_UNLOADED_RADIUS] += re2b;
      t40b = -(re2b * (p[adr + MAGGI_TYRE_DREFF] * t42 + p[adr + MAGGI_TYRE_FREFF] * ratio));
      tb94 = re2b * t40;
      pb[adr + MAGGI_TYRE_DREFF] -= tb94 * t42;
      t42b = -(tb94 * p[adr + MAGGI_TYRE_DREFF]);
      pb[adr + MAGGI_TYRE_FREFF] -= tb94 * ratio;
      ratiob = -(tb94 * p[adr + MAGGI_TYRE_FREFF]);
      re2b = 0.0;
      t41b = t42b * (1.0 / (1.0 + t41 * t41));
      pb[adr + MAGGI_TYRE_BREFF] += t41b * ratio;
      ratiob += t41b * p[adr + MAGGI_TYRE_BREFF];
      tb93 = t40b / p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
      fz0b += tb93;
      pb[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] -= tb93 * t40;
      tb92 = ratiob / fz0;
      fzb += tb92;
      fz0b -= tb92 * ratio;
    } else {
      pb[adr + MAGGI_TYRE_UNLOADED_RADIUS] += re2b;
      re2b = 0.0;
    }
    /* Re = R0 - rho0 (D atan(B rd) + F rd),  rd = Fz / Fz0,  rho0 = Fz0 / Cz;  R0 in the air */
    pb[adr + MAGGI_TYRE_LFZO] += fz0b * p[adr];
    pb[adr] += fz0b * p[adr + MAGGI_TYRE_LFZO];
    pb[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] += fzb * (p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0);
    tb91 = fzb * p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
    pb[adr + MAGGI_TYRE_UNLOADED_RADIUS] += tb91;
    z0b = -tb91;
    pb[adr + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
    rhovb = fzb * p[adr + MAGGI_TYRE_VERTICAL_DAMPING];
    tb90 = rhovb / z2_2;
    z3_2b = tb90 * v0;
    v0b += tb90 * z3_2;
    v0b -= tb90 * N0;
    N0b = -(tb90 * v0);
    v1b -= tb90 * N1;
    v2b -= tb90 * N2;
    N2b = -(tb90 * v2);
    z2_2b = -(tb90 * rhov);
    Zb[carrier][2] += v2b;
    vc2b = v2b;
    vr2b = v2b;
    Zb[carrier][1] += v1b;
    vc1b = v1b;
    vr1b = v1b;
    Zb[carrier][0] += v0b;
    vc0b = v0b;
    vr0b = v0b;
    wr0b = vr2b * arm1;
    arm1b = vr2b * wr0;
    wr1b = -(vr2b * arm0);
    arm0b = -(vr2b * wr1);
    wr2b = vr1b * arm0;
    arm0b += vr1b * wr2;
    wr0b -= vr1b * arm2;
    arm2b = -(vr1b * wr0);
    wr1b += vr0b * arm2;
    arm2b += vr0b * wr1;
    wr2b -= vr0b * arm1;
    arm1b -= vr0b * wr2;
    w0b = vc2b * r_i1;
    r_i1b = vc2b * w0;
    w1b = -(vc2b * r_i0);
    r_i0b = -(vc2b * w1);
    w2_2b = vc1b * r_i0;
    r_i0b += vc1b * w2_2;
    w0b -= vc1b * r_i2;
    r_i2b = -(vc1b * w0);
    rb[t->wheelpoint[i]][0] += r_i0b;
    w1b += vc0b * r_i2;
    r_i2b += vc0b * w1;
    w2_2b -= vc0b * r_i1;
    r_i1b -= vc0b * w2_2;
    rb[t->wheelpoint[i]][1] += r_i1b;
    rb[t->wheelpoint[i]][2] += r_i2b;
    w2_2b += wr2b;
    turnb -= wr2b * u2_2;
    u2_2b -= wr2b * turn;
    w1b += wr1b;
    turnb -= wr1b * u1;
    u1b -= wr1b * turn;
    w0b += wr0b;
    turnb -= wr0b * u0;
    u0b -= wr0b * turn;
    w0b += turnb * u0;
    u0b += turnb * w0;
    w1b += turnb * u1;
    u1b += turnb * w1;
    w2_2b += turnb * u2_2;
    u2_2b += turnb * w2_2;
    Zb[carrier][5] += w2_2b;
    Zb[carrier][4] += w1b;
    Zb[carrier][3] += w0b;
    h12b = z3_2b;
    w2b = z2_2b;
    r2b = z0b;
    normal2b = N2b;
    along2b = T2b;
    tb88 = arm2b / w2;
    r2b += tb88 * (c * u2_2 - normal2);
    tb89 = tb88 * r2;
    cb = tb89 * u2_2;
    u2_2b += tb89 * c;
    normal2b -= tb89;
    w2b -= tb88 * arm2;
    along1b = T1b;
    tb86 = arm1b / w2;
    r2b += tb86 * (c * u1 - normal1);
    tb87 = tb86 * r2;
    cb += tb87 * u1;
    u1b += tb87 * c;
    w2b -= tb86 * arm1;
    normal0b = N0b;
    along0b = T0b;
    tb84 = arm0b / w2;
    r2b += tb84 * (c * u0 - normal0);
    tb85 = tb84 * r2;
    cb += tb85 * u0;
    u0b += tb85 * c;
    normal0b -= tb85;
    w2b -= tb84 * arm0;
    tb83 = along2b / w2;
    un2b = tb83;
    w2b -= tb83 * along2;
    tb82 = along1b / w2;
    un1b = tb82;
    w2b -= tb82 * along1;
    tb81 = along0b / w2;
    un0b = tb81;
    w2b -= tb81 * along0;
    tb78 = r2b / w2;
    tb79 = tb78 * normal0;
    g0b = tb79;
    xb = -tb79;
    normal0b += tb78 * (g0 - x);
    tb80 = tb78 * normal2;
    g2b = tb80;
    h10b = -tb80;
    normal2b += tb78 * (g2 - h10);
    w2b -= tb78 * r2;
    t39b = w2b * (1.0 / (2.0 * w2));
    un0b += t39b * un0;
    un0b += t39b * un0;
    un1b += t39b * un1;
    un1b += t39b * un1;
    un2b += t39b * un2;
    un2b += t39b * un2;
    u0b += un2b * normal1;
    u1b -= un2b * normal0;
    normal0b -= un2b * u1;
    u2_2b += un1b * normal0;
    normal0b += un1b * u2_2;
    u0b -= un1b * normal2;
    normal2b -= un1b * u0;
    u1b += un0b * normal2;
    normal2b += un0b * u1;
    u2_2b -= un0b * normal1;
    u0b += cb * normal0;
    normal0b += cb * u0;
    u1b += cb * normal1;
    u2_2b += cb * normal2;
    normal2b += cb * u2_2;
    tb77 = normal2b / s;
    sb = -(tb77 * normal2);
    tb76 = normal0b / s;
    h11b = -tb76;
    sb -= tb76 * normal0;
    t38b = sb * (1.0 / (2.0 * s));
    h11b += t38b * h11;
    h11b += t38b * h11;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road4 = p[t->roadadr[road]];
      h12b = 0.0;
      p_road4b = h11b;
      h11b = 0.0;
      p_road4b += h10b * x;
      xb += h10b * p_road4;
      h10b = 0.0;
      pb[t->roadadr[road]] += p_road4b;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k8 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      t18 = k8 * x;
      t19 = sin(t18);
      p_road5 = p[t->roadadr[road]];
      t20 = k8 * x;
      t21 = cos(t20);
      h12b = 0.0;
      tb37 = h11b * t21;
      k8b = tb37 * p_road5;
      p_road5b = tb37 * k8;
      t21b = h11b * (k8 * p_road5);
      h11b = 0.0;
      t20b = -(t21b * sin(t20));
      k8b += t20b * x;
      xb += t20b * k8;
      p_road5b += h10b * t19;
      t19b = h10b * p_road5;
      h10b = 0.0;
      pb[t->roadadr[road]] += p_road5b;
      t18b = t19b * cos(t18);
      k8b += t18b * x;
      xb += t18b * k8;
      tb36 = k8b / p[t->roadadr[road] + 1];
      pb[t->roadadr[road] + 1] -= tb36 * k8;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k7 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x);
      x4 = x - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k7 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius2 = p[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      c4 = sqrt(t22);
      f2 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x4) > 0.0) {
        way2 = 1.0;
      } else {
        way2 = -1.0;
      }
      y2 = way2 * x4;
      b41b = h12b;
      h12b = 0.0;
      h11b = 0.0;
      b40b = h10b;
      h10b = 0.0;
      base2b = 0.0;
      c4b = 0.0;
      f2b = 0.0;
      radius2b = 0.0;
      x4b = 0.0;
      y2b = 0.0;
      if (MAGGI_RE(y2) >= MAGGI_RE(c4 + f2)) {
        b41b = 0.0;
        b40b = 0.0;
      } else if (MAGGI_RE(y2) > MAGGI_RE(c4 - f2)) {
        t23 = radius2 * radius2 - (c4 - f2) * (c4 - f2);
        z3 = sqrt(t23);
        h0_3 = z3 - base2;
        h1_3 = 2.0 * f2 * (c4 - f2) / z3;
        a3 = 3.0 * h0_3 - h1_3;
        t24 = z3 * z3 * z3;
        t25 = 2.0 * f2 * f2 * radius2 * radius2 / t24;
        b5 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        t26 = 2.0 * f2;
        u3 = (c4 + f2 - y2) / t26;
        w4 = 1.0 - u3;
        t27 = 2.0 * f2;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 * (a3 + 2.0 * w4 * b5)) /
            t27;
        t28b = b41b;
        b41b = 0.0;
        tb51 = t28b / t27;
        tb52 = tb51 * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 * (a3 + 2.0 * w4 * b5));
        u3b = -(tb52 * u3 * way2);
        u3b += tb52 * (-way2 * u3);
        tb53 = tb51 * (-way2 * u3 * u3);
        tb54 = tb53 * 3.0;
        h0_3b = tb54;
        w4b = tb54 * (a3 + w4 * b5);
        tb55 = tb54 * w4;
        a3b = tb55;
        w4b += tb55 * b5;
        b5b = tb55 * w4;
        u3b -= tb53 * (a3 + 2.0 * w4 * b5);
        tb56 = tb53 * u3;
        a3b -= tb56;
        w4b -= tb56 * b5 * 2.0;
        b5b -= tb56 * (2.0 * w4);
        t27b = -(tb51 * t28);
        f2b += t27b * 2.0;
        tb47 = b40b * (h0_3 + w4 * (a3 + w4 * b5));
        tb48 = tb47 * u3;
        u3b += tb48 * u3;
        u3b += tb48 * u3;
        u3b += tb47 * (u3 * u3);
        tb49 = b40b * (u3 * u3 * u3);
        h0_3b += tb49;
        w4b += tb49 * (a3 + w4 * b5);
        tb50 = tb49 * w4;
        a3b += tb50;
        w4b += tb50 * b5;
        b5b += tb50 * w4;
        b40b = 0.0;
        u3b -= w4b;
        tb46 = u3b / t26;
        c4b += tb46;
        f2b += tb46;
        y2b -= tb46;
        t26b = -(tb46 * u3);
        f2b += t26b * 2.0;
        h0_3b += b5b * 6.0;
        h1_3b = -(b5b * 3.0);
        t25b = -b5b;
        tb43 = t25b / t24;
        tb44 = tb43 * radius2;
        tb45 = tb44 * radius2;
        f2b += tb45 * f2 * 2.0;
        f2b += tb45 * (2.0 * f2);
        radius2b += tb44 * (2.0 * f2 * f2);
        radius2b += tb43 * (2.0 * f2 * f2 * radius2);
        t24b = -(tb43 * t25);
        tb42 = t24b * z3;
        z3b = tb42 * z3;
        z3b += tb42 * z3;
        z3b += t24b * (z3 * z3);
        h0_3b += a3b * 3.0;
        h1_3b -= a3b;
        tb40 = h1_3b / z3;
        f2b += tb40 * (c4 - f2) * 2.0;
        tb41 = tb40 * (2.0 * f2);
        c4b += tb41;
        f2b -= tb41;
        z3b -= tb40 * h1_3;
        z3b += h0_3b;
        base2b -= h0_3b;
        t23b = z3b * (1.0 / (2.0 * z3));
        radius2b += t23b * radius2;
        radius2b += t23b * radius2;
        tb38 = t23b * (c4 - f2);
        c4b -= tb38;
        f2b += tb38;
        tb39 = t23b * (c4 - f2);
        c4b -= tb39;
        f2b += tb39;
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        z3_3 = sqrt(t29);
        t30 = -x4 / z3_3;
        t30b = b41b;
        b41b = 0.0;
        tb57 = t30b / z3_3;
        x4b -= tb57;
        z3_3b = -(tb57 * t30);
        z3_3b += b40b;
        base2b -= b40b;
        b40b = 0.0;
        t29b = z3_3b * (1.0 / (2.0 * z3_3));
        radius2b += t29b * radius2;
        radius2b += t29b * radius2;
        y2b -= t29b * y2;
        y2b -= t29b * y2;
      }
      x4b += y2b * way2;
      pb[t->roadadr[road] + MAGGI_BUMPS_FILLET] += f2b * 0.5;
      t22b = c4b * (1.0 / (2.0 * c4));
      radius2b += t22b * radius2;
      radius2b += t22b * radius2;
      base2b -= t22b * base2;
      base2b -= t22b * base2;
      radius2b += base2b;
      pb[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= base2b;
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      pb[t->roadadr[road]] += radius2b;
      xb += x4b;
      pb[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x4b;
      pb[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x4b * k7;
    } else {
      k9 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x);
      h12b = 0.0;
      s31b = h11b;
      h11b = 0.0;
      s30b = h10b;
      h10b = 0.0;
      if (k9 < 0) {
        p_road6 = p[t->roadadr[road]];
        h2 = p[t->roadadr[road] + 1] - p_road6;
        p_roadroad2 = p[t->roadadr[road] + t->roadn[road]];
        t31 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2) / h2;
        slope2 = t31 - h2 / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]);
        slope2b = s31b;
        s31b = 0.0;
        p_roadroad2b = s30b;
        slope2b += s30b * (x - p_road6);
        tb60 = s30b * slope2;
        xb += tb60;
        p_road6b = -tb60;
        s30b = 0.0;
        t31b = slope2b;
        h2b = -(slope2b * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) / 6.0);
        tb59 = slope2b * (h2 / 6.0);
        spline0b[t->roadspline[road]][0] -= tb59 * 2.0;
        spline0b[t->roadspline[road] + 1][0] -= tb59;
        tb58 = t31b / h2;
        pb[t->roadadr[road] + t->roadn[road] + 1] += tb58;
        p_roadroad2b -= tb58;
        h2b -= tb58 * t31;
        pb[t->roadadr[road] + t->roadn[road]] += p_roadroad2b;
        pb[t->roadadr[road] + 1] += h2b;
        p_road6b -= h2b;
        pb[t->roadadr[road]] += p_road6b;
      } else if (k9 > t->roadn[road] - 2) {
        p5 = p[t->roadadr[road] + t->roadn[road] - 1];
        h2_2 = p5 - p[t->roadadr[road] + t->roadn[road] - 2];
        p6 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t32 = (p6 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h2_2;
        slope2_2 = t32 + h2_2 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        slope2_2b = s31b;
        s31b = 0.0;
        p6b = s30b;
        slope2_2b += s30b * (x - p5);
        tb63 = s30b * slope2_2;
        xb += tb63;
        p5b = -tb63;
        s30b = 0.0;
        t32b = slope2_2b;
        h2_2b = slope2_2b * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) / 6.0;
        tb62 = slope2_2b * (h2_2 / 6.0);
        spline0b[t->roadspline[road] + t->roadn[road] - 2][0] += tb62;
        spline0b[t->roadspline[road] + t->roadn[road] - 1][0] += tb62 * 2.0;
        tb61 = t32b / h2_2;
        p6b += tb61;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb61;
        h2_2b -= tb61 * t32;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p6b;
        p5b += h2_2b;
        pb[t->roadadr[road] + t->roadn[road] - 2] -= h2_2b;
        pb[t->roadadr[road] + t->roadn[road] - 1] += p5b;
      } else {
        p_roadk91 = p[t->roadadr[road] + k9 + 1];
        p_roadk9 = p[t->roadadr[road] + k9];
        h2_3 = p_roadk91 - p_roadk9;
        a4 = p_roadk91 - x;
        c5 = x - p_roadk9;
        p7 = p[t->roadadr[road] + t->roadn[road] + k9];
        t33 = (p[t->roadadr[road] + t->roadn[road] + k9 + 1] - p7) / h2_3;
        spline0_roadk910 = spline0[t->roadspline[road] + k9 + 1][0];
        spline0_roadk90 = spline0[t->roadspline[road] + k9][0];
        e2 = t33 - h2_3 / 6.0 * (spline0_roadk910 - spline0_roadk90);
        t34 = 6.0 * h2_3;
        t35 = (spline0_roadk90 * a4 * a4 * a4 + spline0_roadk910 * c5 * c5 * c5) / t34;
        t36 = 2.0 * h2_3;
        t37 = (spline0_roadk910 * c5 * c5 - spline0_roadk90 * a4 * a4) / t36;
        t37b = s31b;
        e2b = s31b;
        s31b = 0.0;
        tb73 = t37b / t36;
        tb74 = tb73 * c5;
        spline0_roadk910b = tb74 * c5;
        c5b = tb74 * spline0_roadk910;
        c5b += tb73 * (spline0_roadk910 * c5);
        tb75 = tb73 * a4;
        spline0_roadk90b = -(tb75 * a4);
        a4b = -(tb75 * spline0_roadk90);
        a4b -= tb73 * (spline0_roadk90 * a4);
        t36b = -(tb73 * t37);
        h2_3b = t36b * 2.0;
        t35b = s30b;
        p7b = s30b;
        tb71 = s30b / 6.0;
        tb72 = tb71 * h2_3;
        spline0_roadk90b -= tb72 * h2_3;
        h2_3b -= tb72 * spline0_roadk90;
        h2_3b -= tb71 * (spline0_roadk90 * h2_3);
        e2b += s30b * c5;
        c5b += s30b * e2;
        s30b = 0.0;
        tb66 = t35b / t34;
        tb67 = tb66 * a4;
        tb68 = tb67 * a4;
        spline0_roadk90b += tb68 * a4;
        a4b += tb68 * spline0_roadk90;
        a4b += tb67 * (spline0_roadk90 * a4);
        a4b += tb66 * (spline0_roadk90 * a4 * a4);
        tb69 = tb66 * c5;
        tb70 = tb69 * c5;
        spline0_roadk910b += tb70 * c5;
        c5b += tb70 * spline0_roadk910;
        c5b += tb69 * (spline0_roadk910 * c5);
        c5b += tb66 * (spline0_roadk910 * c5 * c5);
        t34b = -(tb66 * t35);
        h2_3b += t34b * 6.0;
        t33b = e2b;
        h2_3b -= e2b * (spline0_roadk910 - spline0_roadk90) / 6.0;
        tb65 = e2b * (h2_3 / 6.0);
        spline0_roadk910b -= tb65;
        spline0_roadk90b += tb65;
        spline0b[t->roadspline[road] + k9][0] += spline0_roadk90b;
        spline0b[t->roadspline[road] + k9 + 1][0] += spline0_roadk910b;
        tb64 = t33b / h2_3;
        pb[t->roadadr[road] + t->roadn[road] + k9 + 1] += tb64;
        p7b -= tb64;
        h2_3b -= tb64 * t33;
        pb[t->roadadr[road] + t->roadn[road] + k9] += p7b;
        xb += c5b;
        p_roadk9b = -c5b;
        p_roadk91b = a4b;
        xb -= a4b;
        p_roadk91b += h2_3b;
        p_roadk9b -= h2_3b;
        pb[t->roadadr[road] + k9] += p_roadk9b;
        pb[t->roadadr[road] + k9 + 1] += p_roadk91b;
      }
    }
    g0b += xb;
    t17b = xb * (g2 - h00);
    tb35 = xb * t17;
    g2b += tb35;
    h00b = -tb35;
    tb34 = t17b / t16;
    u2_2b += tb34 * u0;
    u0b += tb34 * u2_2;
    t16b = -(tb34 * t17);
    u0b += t16b * u0;
    u0b += t16b * u0;
    u1b += t16b * u1;
    u1b += t16b * u1;
    x2b = 0.0;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      p_roadb = h00b * x2;
      x2b += h00b * p_road;
      h00b = 0.0;
      pb[t->roadadr[road]] += p_roadb;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k5 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      t3 = k5 * x2;
      t4 = sin(t3);
      p_road2 = p[t->roadadr[road]];
      p_road2b = h00b * t4;
      t4b = h00b * p_road2;
      h00b = 0.0;
      pb[t->roadadr[road]] += p_road2b;
      t3b = t4b * cos(t3);
      k5b = t3b * x2;
      x2b += t3b * k5;
      tb5 = k5b / p[t->roadadr[road] + 1];
      pb[t->roadadr[road] + 1] -= tb5 * k5;
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k4 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x2);
      x3 = x2 - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k4 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius = p[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      c2 = sqrt(t5);
      f = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
      if (MAGGI_RE(x3) > 0.0) {
        way = 1.0;
      } else {
        way = -1.0;
      }
      y = way * x3;
      b20b = h00b;
      h00b = 0.0;
      baseb = 0.0;
      c2b = 0.0;
      fb = 0.0;
      radiusb = 0.0;
      yb = 0.0;
      if (MAGGI_RE(y) >= MAGGI_RE(c2 + f)) {
        b20b = 0.0;
      } else if (MAGGI_RE(y) > MAGGI_RE(c2 - f)) {
        t6 = radius * radius - (c2 - f) * (c2 - f);
        z2 = sqrt(t6);
        h0_2 = z2 - base;
        h1_2 = 2.0 * f * (c2 - f) / z2;
        a = 3.0 * h0_2 - h1_2;
        t7 = z2 * z2 * z2;
        t8 = 2.0 * f * f * radius * radius / t7;
        b3 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        t9 = 2.0 * f;
        u2 = (c2 + f - y) / t9;
        w3 = 1.0 - u2;
        tb15 = b20b * (h0_2 + w3 * (a + w3 * b3));
        tb16 = tb15 * u2;
        u2b = tb16 * u2;
        u2b += tb16 * u2;
        u2b += tb15 * (u2 * u2);
        tb17 = b20b * (u2 * u2 * u2);
        h0_2b = tb17;
        w3b = tb17 * (a + w3 * b3);
        tb18 = tb17 * w3;
        ab = tb18;
        w3b += tb18 * b3;
        b3b = tb18 * w3;
        b20b = 0.0;
        u2b -= w3b;
        tb14 = u2b / t9;
        c2b += tb14;
        fb += tb14;
        yb -= tb14;
        t9b = -(tb14 * u2);
        fb += t9b * 2.0;
        h0_2b += b3b * 6.0;
        h1_2b = -(b3b * 3.0);
        t8b = -b3b;
        tb11 = t8b / t7;
        tb12 = tb11 * radius;
        tb13 = tb12 * radius;
        fb += tb13 * f * 2.0;
        fb += tb13 * (2.0 * f);
        radiusb += tb12 * (2.0 * f * f);
        radiusb += tb11 * (2.0 * f * f * radius);
        t7b = -(tb11 * t8);
        tb10 = t7b * z2;
        z2b = tb10 * z2;
        z2b += tb10 * z2;
        z2b += t7b * (z2 * z2);
        h0_2b += ab * 3.0;
        h1_2b -= ab;
        tb8 = h1_2b / z2;
        fb += tb8 * (c2 - f) * 2.0;
        tb9 = tb8 * (2.0 * f);
        c2b += tb9;
        fb -= tb9;
        z2b -= tb8 * h1_2;
        z2b += h0_2b;
        baseb -= h0_2b;
        t6b = z2b * (1.0 / (2.0 * z2));
        radiusb += t6b * radius;
        radiusb += t6b * radius;
        tb6 = t6b * (c2 - f);
        c2b -= tb6;
        fb += tb6;
        tb7 = t6b * (c2 - f);
        c2b -= tb7;
        fb += tb7;
      } else {
        t10 = radius * radius - y * y;
        z2_3 = sqrt(t10);
        z2_3b = b20b;
        baseb -= b20b;
        b20b = 0.0;
        t10b = z2_3b * (1.0 / (2.0 * z2_3));
        radiusb += t10b * radius;
        radiusb += t10b * radius;
        yb -= t10b * y;
        yb -= t10b * y;
      }
      x3b = yb * way;
      pb[t->roadadr[road] + MAGGI_BUMPS_FILLET] += fb * 0.5;
      t5b = c2b * (1.0 / (2.0 * c2));
      radiusb += t5b * radius;
      radiusb += t5b * radius;
      baseb -= t5b * base;
      baseb -= t5b * base;
      radiusb += baseb;
      pb[t->roadadr[road] + MAGGI_BUMPS_HEIGHT] -= baseb;
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      pb[t->roadadr[road]] += radiusb;
      x2b += x3b;
      pb[t->roadadr[road] + MAGGI_BUMPS_FIRST] -= x3b;
      pb[t->roadadr[road] + MAGGI_BUMPS_SPACING] -= x3b * k4;
    } else {
      k6 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x2);
      s20b = h00b;
      h00b = 0.0;
      if (k6 < 0) {
        p_road3 = p[t->roadadr[road]];
        h = p[t->roadadr[road] + 1] - p_road3;
        p_roadroad = p[t->roadadr[road] + t->roadn[road]];
        t11 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad) / h;
        slope = t11 - h / 6.0 * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road]
            + 1][0]);
        p_roadroadb = s20b;
        slopeb = s20b * (x2 - p_road3);
        tb21 = s20b * slope;
        x2b += tb21;
        p_road3b = -tb21;
        s20b = 0.0;
        t11b = slopeb;
        hb = -(slopeb * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road] +
            1][0]) / 6.0);
        tb20 = slopeb * (h / 6.0);
        spline0b[t->roadspline[road]][0] -= tb20 * 2.0;
        spline0b[t->roadspline[road] + 1][0] -= tb20;
        tb19 = t11b / h;
        pb[t->roadadr[road] + t->roadn[road] + 1] += tb19;
        p_roadroadb -= tb19;
        hb -= tb19 * t11;
        pb[t->roadadr[road] + t->roadn[road]] += p_roadroadb;
        pb[t->roadadr[road] + 1] += hb;
        p_road3b -= hb;
        pb[t->roadadr[road]] += p_road3b;
      } else if (k6 > t->roadn[road] - 2) {
        p2 = p[t->roadadr[road] + t->roadn[road] - 1];
        h3 = p2 - p[t->roadadr[road] + t->roadn[road] - 2];
        p3 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t12 = (p3 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h3;
        slope3 = t12 + h3 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        p3b = s20b;
        slope3b = s20b * (x2 - p2);
        tb24 = s20b * slope3;
        x2b += tb24;
        p2b = -tb24;
        s20b = 0.0;
        t12b = slope3b;
        h3b = slope3b * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]) / 6.0;
        tb23 = slope3b * (h3 / 6.0);
        spline0b[t->roadspline[road] + t->roadn[road] - 2][0] += tb23;
        spline0b[t->roadspline[road] + t->roadn[road] - 1][0] += tb23 * 2.0;
        tb22 = t12b / h3;
        p3b += tb22;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] -= tb22;
        h3b -= tb22 * t12;
        pb[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1] += p3b;
        p2b += h3b;
        pb[t->roadadr[road] + t->roadn[road] - 2] -= h3b;
        pb[t->roadadr[road] + t->roadn[road] - 1] += p2b;
      } else {
        p_roadk61 = p[t->roadadr[road] + k6 + 1];
        p_roadk6 = p[t->roadadr[road] + k6];
        h3_2 = p_roadk61 - p_roadk6;
        a2 = p_roadk61 - x2;
        c3 = x2 - p_roadk6;
        p4 = p[t->roadadr[road] + t->roadn[road] + k6];
        t13 = (p[t->roadadr[road] + t->roadn[road] + k6 + 1] - p4) / h3_2;
        spline0_roadk610 = spline0[t->roadspline[road] + k6 + 1][0];
        spline0_roadk60 = spline0[t->roadspline[road] + k6][0];
        e = t13 - h3_2 / 6.0 * (spline0_roadk610 - spline0_roadk60);
        t14 = 6.0 * h3_2;
        t15 = (spline0_roadk60 * a2 * a2 * a2 + spline0_roadk610 * c3 * c3 * c3) / t14;
        t15b = s20b;
        p4b = s20b;
        tb32 = s20b / 6.0;
        tb33 = tb32 * h3_2;
        spline0_roadk60b = -(tb33 * h3_2);
        h3_2b = -(tb33 * spline0_roadk60);
        h3_2b -= tb32 * (spline0_roadk60 * h3_2);
        eb = s20b * c3;
        c3b = s20b * e;
        s20b = 0.0;
        tb27 = t15b / t14;
        tb28 = tb27 * a2;
        tb29 = tb28 * a2;
        spline0_roadk60b += tb29 * a2;
        a2b = tb29 * spline0_roadk60;
        a2b += tb28 * (spline0_roadk60 * a2);
        a2b += tb27 * (spline0_roadk60 * a2 * a2);
        tb30 = tb27 * c3;
        tb31 = tb30 * c3;
        spline0_roadk610b = tb31 * c3;
        c3b += tb31 * spline0_roadk610;
        c3b += tb30 * (spline0_roadk610 * c3);
        c3b += tb27 * (spline0_roadk610 * c3 * c3);
        t14b = -(tb27 * t15);
        h3_2b += t14b * 6.0;
        t13b = eb;
        h3_2b -= eb * (spline0_roadk610 - spline0_roadk60) / 6.0;
        tb26 = eb * (h3_2 / 6.0);
        spline0_roadk610b -= tb26;
        spline0_roadk60b += tb26;
        spline0b[t->roadspline[road] + k6][0] += spline0_roadk60b;
        spline0b[t->roadspline[road] + k6 + 1][0] += spline0_roadk610b;
        tb25 = t13b / h3_2;
        pb[t->roadadr[road] + t->roadn[road] + k6 + 1] += tb25;
        p4b -= tb25;
        h3_2b -= tb25 * t13;
        pb[t->roadadr[road] + t->roadn[road] + k6] += p4b;
        x2b += c3b;
        p_roadk6b = -c3b;
        p_roadk61b = a2b;
        x2b -= a2b;
        p_roadk61b += h3_2b;
        p_roadk6b -= h3_2b;
        pb[t->roadadr[road] + k6] += p_roadk6b;
        pb[t->roadadr[road] + k6 + 1] += p_roadk61b;
      }
    }
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n|, slope that the plane lacks */
    g0b += x2b;
    rb[t->wheelpoint[i]][2] += g2b;
    rb[t->roadpoint[road]][2] -= g2b;
    rb[t->wheelpoint[i]][0] += g0b;
    rb[t->roadpoint[road]][0] -= g0b;
    tb4 = u2_2b / n2;
    ua2b = tb4;
    n2b = -(tb4 * u2_2);
    tb3 = u1b / n2;
    ua1b = tb3;
    n2b -= tb3 * u1;
    tb2 = u0b / n2;
    ua0b = tb2;
    n2b -= tb2 * u0;
    t2b = n2b * (1.0 / (2.0 * n2));
    ua0b += t2b * ua0;
    ua0b += t2b * ua0;
    ua1b += t2b * ua1;
    ua1b += t2b * ua1;
    ua2b += t2b * ua2;
    ua2b += t2b * ua2;
    Ab[t->wheelbody[i]][6] += ua2b * axis0;
    axis0b = ua2b * A[t->wheelbody[i]][6];
    Ab[t->wheelbody[i]][7] += ua2b * axis1;
    axis1b = ua2b * A[t->wheelbody[i]][7];
    Ab[t->wheelbody[i]][8] += ua2b * axis2;
    axis2b = ua2b * A[t->wheelbody[i]][8];
    Ab[t->wheelbody[i]][3] += ua1b * axis0;
    axis0b += ua1b * A[t->wheelbody[i]][3];
    Ab[t->wheelbody[i]][4] += ua1b * axis1;
    axis1b += ua1b * A[t->wheelbody[i]][4];
    Ab[t->wheelbody[i]][5] += ua1b * axis2;
    axis2b += ua1b * A[t->wheelbody[i]][5];
    Ab[t->wheelbody[i]][0] += ua0b * axis0;
    axis0b += ua0b * A[t->wheelbody[i]][0];
    Ab[t->wheelbody[i]][1] += ua0b * axis1;
    axis1b += ua0b * A[t->wheelbody[i]][1];
    Ab[t->wheelbody[i]][2] += ua0b * axis2;
    axis2b += ua0b * A[t->wheelbody[i]][2];
    pb[t->wheelaxis[i] + 2] += axis2b;
    pb[t->wheelaxis[i] + 1] += axis1b;
    pb[t->wheelaxis[i]] += axis0b;
  }
}
