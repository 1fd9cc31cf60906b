/* Adjoint of core/kernel/element.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

void maggi_element_forces_b(const maggi_topo *t, const double p[restrict t->np],
                            double pb[restrict t->np], const double fun[restrict t->nfun][3],
                            double funb[restrict t->nfun][3],
                            const double spring0[restrict t->nspring],
                            double spring0b[restrict t->nspring], const double q[restrict t->nq],
                            double qb[restrict t->nq], const double v[restrict t->nq],
                            double vb[restrict t->nq], const double A[restrict t->nbody + 1][9],
                            double Ab[restrict t->nbody + 1][9],
                            const double Z[restrict t->nbody + 1][6],
                            double Zb[restrict t->nbody + 1][6],
                            const double r[restrict t->npoint][3], double rb[restrict t->npoint][3],
                            const double rv[restrict t->npoint][3],
                            double rvb[restrict t->npoint][3], double Q[restrict t->nbody + 1][6],
                            double Qb[restrict t->nbody + 1][6], double tau[restrict t->nq],
                            double taub[restrict t->nq], double power[restrict 1])
{
  int a, a4, a5, a5_2, a6, adr, adr2, b, b2, b3, b4, i, k, k11, k2;
  double L0, L0b, L1, L1b, L2, L2b, N0, N0b, N1, N2, N2b, T0, T0b, T1, T1b, T2, T2b, Z_b43, Z_b43b,
      Z_b44, Z_b44b, Z_b45, Z_b45b, a00, a00b, a01, a01b, a02, a02b, a2, a2b, a3, a3b, along0,
      along0b, along1, along1b, along2, along2b, ar, arb, areq, areqb, arm0, arm0b, arm1, arm1b,
      arm2, arm2b, at, atb, ateq, ateqb, ay, ayb, back0, back0b, back1, back1b, back20, back20b,
      back21, back21b, back22, back22b, back2_2, back2_2b, br, brb, bt, btb, bx, bxb, by, byb, bycy,
      bycyb, c, c20, c20b, c21, c21b, c22, c22b, c3, c3b, ca, cab, cb, cx, cxb, cy, cyb, damping,
      dampingb, dfz, dfzb, dr, drb, dt, dtb, dv, dvb, dx, dxb, dy, dyb, e0, e0b, e1, e10, e10b, e11,
      e11b, e12, e12b, e1b, e2, e2_2, e2_2b, e2b, e3, e3b, e4, e4b, e5, e5b, e6, e6b, e7, e7b, e8,
      e8b, e9, e9b, et, etb, ev0, ev0b, ev1, ev1b, ev2, ev2b, ex, exb, ey, eyb, f0, f0b, f1, f1b,
      f2, f2b, f3, f3b, force0, force0b, force1, force1b, force20, force20b, force21, force21b,
      force22, force22b, force23, force23b, force24, force24b, force25, force25b, force2_2,
      force2_2b, force30, force30b, force31, force31b, force32, force32b, fx, fxb, fy, fyb, fz, fz0,
      fz0_2, fz0_2b, fz0_3, fz0_3b, fz0_4, fz0_4b, fz0b, fz2, fz2b, fzb, g0, g0b, g1, g1b, g20,
      g20b, g22, g22b, g2_2, g2_2b, g30, g30b, g31, g31b, gamma, gamma2, gamma2b, gammab, gx, gxb,
      gy, gyb, gz, gzb, h00, h00b, h10, h10b, h11, h11b, kappa, kappa2, kappa2b, kappab, kx, kxb, l,
      lb, lv, lvb, moment0b, moment1b, moment2b, mux, muxb, muy, muy2, muy2b, muyb, n20, n20b, n21,
      n21b, n22, n22b, n3, n3b, n40, n40b, n41, n42, n42b, omega, omegab, one0, one0b, one1, one1b,
      one2, one2b, one3, one3b, one4, one4b, p10, p10b, p11, p11b, p2, p2b, p3, p3b, p4, p4b, p5,
      p5b, p6, p6b, p7, p7b, p8, p8b, p9, p9b, p_adr2, p_adr2b, p_k11, p_k111, p_k111_2, p_k111_2b,
      p_k111b, p_k11_2, p_k11_2b, p_k11_3, p_k11_3b, p_k11_4, p_k11_4b, p_k11b, p_k24, p_k24b,
      p_k25, p_k25b, r0, r0b, r2, r2b, r30, r30b, r31, r31b, r32, r32b, r_a0, r_a0b, r_a1, r_a1b,
      r_a2, r_a2b, r_b0, r_b0b, r_b1, r_b1b, r_b2, r_b2b, r_i0, r_i0b, r_i1, r_i1b, r_i2, r_i2b,
      ratio, ratio2, ratio2b, ratiob, re, reb, rhov, rhovb, rolling0, rolling0b, rolling1,
      rolling1b, rolling2, rolling2b, rolling3, rolling3b, rolling4, rolling4b, rolling5, rolling5b,
      s, s2, s2b, s3, s3b, s4, s4b, sb, shift, shiftb, shy, shyb, side, speed, speed2, speed2b,
      speed3, speed3b, speedb, stiff, stiff2, stiff2b, stiff3, stiff3b, stiff4, stiff4b, stiffb,
      svx, svxb, svy, svyb, t10, t10b, t11, t11b, t12, t12b, t13, t13b, t14, t14b, t15, t15b, t16,
      t16b, t17, t17b, t18, t18b, t19, t19b, t2, t20, t20b, t21, t21b, t22, t22b, t23, t23b, t24,
      t24b, t25, t25b, t26, t26b, t27, t27b, t28, t28b, t29, t29b, t2b, t3, t30, t30b, t31, t31b,
      t32, t32b, t33, t33b, t34, t34b, t35, t35b, t36, t36b, t37, t37b, t38, t38b, t39, t39b, t3b,
      t4, t40, t40b, t41, t41b, t42, t42b, t43, t43b, t44, t44b, t45, t45b, t46, t46b, t47, t47b,
      t48, t48b, t49, t49b, t4b, t5, t50, t50b, t51, t51b, t52, t52b, t53, t53b, t54, t54b, t55,
      t55b, t56, t56b, t57, t57b, t58, t58b, t59, t59b, t5b, t6, t60, t60b, t61, t61b, t62, t62b,
      t63, t63b, t64, t64b, t65, t65b, t66, t66b, t67, t67b, t68, t68b, t69, t69b, t6b, t7, t70,
      t70b, t71, t71b, t72, t72b, t73, t73b, t74, t74b, t75, t75b, t76, t76b, t77, t77b, t78, t78b,
      t79, t79b, t7b, t8, t80, t80b, t81, t81b, t82, t82b, t83, t83b, t84, t84b, t85, t85b, t86,
      t86b, t87, t87b, t88, t88b, t89, t89b, t8b, t9, t90, t90b, t91, t91b, t92, t92b, t93, t93b,
      t9b, tb10, tb100, tb101, tb102, tb103, tb104, tb105, tb106, tb107, tb108, tb109, tb11, tb110,
      tb111, tb112, tb113, tb114, tb115, tb116, tb117, tb118, tb119, tb12, tb120, tb121, tb122,
      tb123, tb124, tb125, tb126, tb127, tb128, tb129, tb13, tb130, tb131, tb132, tb133, tb134,
      tb135, tb136, tb137, tb138, tb139, tb14, tb140, tb141, tb142, tb143, tb144, tb145, tb146,
      tb147, tb148, tb149, tb15, tb150, tb151, tb152, tb153, tb154, tb155, tb156, tb157, tb158,
      tb159, tb16, tb160, tb161, tb162, tb163, tb164, tb165, tb166, tb167, tb168, tb169, tb17,
      tb170, tb18, tb19, tb2, tb20, tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3, tb30,
      tb31, tb32, tb33, tb34, tb35, tb36, tb37, tb38, tb39, tb4, tb40, tb41, tb42, tb43, tb44, tb45,
      tb46, tb47, tb48, tb49, tb5, tb50, tb51, tb52, tb53, tb54, tb55, tb56, tb57, tb58, tb59, tb6,
      tb60, tb61, tb62, tb63, tb64, tb65, tb66, tb67, tb68, tb69, tb7, tb70, tb71, tb72, tb73, tb74,
      tb75, tb76, tb77, tb78, tb79, tb8, tb80, tb81, tb82, tb83, tb84, tb85, tb86, tb87, tb88, tb89,
      tb9, tb90, tb91, tb92, tb93, tb94, tb95, tb96, tb97, tb98, tb99, torque0b, u0, u0b, u1, u1b,
      u20, u20b, u21, u21b, u22, u22b, u2_2, u2_2b, u30, u30b, u31, u31b, u32, u32b, ua0, ua0b, ua1,
      ua1b, ua2, ua2b, un0, un0b, un1, un1b, un2, un2b, v40, v40b, v41, v41b, v42, v42b, vr0, vr0b,
      vr1, vr1b, vr2, vr2b, vx, vxb, w, way, wayb, wb, wr0, wr0b, wr1, wr1b, wr2, wr2b, x, x2, x2b,
      x3, x3b, x40, x40b, x41, x41b, x5, x5b, x6, x6b, x7, x7b, x8, x8b, xb, xv, xvb, y, y10, y10b,
      y11, y11b, y12, y12b, y13, y13b, y14, y14b, y15, y15b, y16, y16b, y17, y17b, y18, y18b, y20,
      y20b, y21, y21b, y22, y22b, y23, y23b, y24, y24b, y3, y3b, y4, y4b, y5, y5b, y6, y6b, y7, y7b,
      y8, y8b, y9, y9b, yb, z20, z20b, z21, z21b, z22, z22b, z30, z30b, z31, z31b, z4, z4b, z5, z5b,
      z6, z6b;

  (void)Q;
  (void)tau;
  (void)power;
  for (i = t->nwheel - 1; i >= 0; --i) {
    a6 = t->wheelbody[i];
    b4 = t->wheelcarrier[i];
    k11 = t->wheelroad[i];
    side = t->wheelmirror[i] ? -1.0 : 1.0;
    a00 = p[t->wheelaxis[i]];
    a01 = p[t->wheelaxis[i] + 1];
    a02 = p[t->wheelaxis[i] + 2];
    ua0 = A[a6][0] * a00 + A[a6][1] * a01 + A[a6][2] * a02;
    ua1 = A[a6][3] * a00 + A[a6][4] * a01 + A[a6][5] * a02;
    ua2 = A[a6][6] * a00 + A[a6][7] * a01 + A[a6][8] * a02;
    t4 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
    n3 = sqrt(t4);
    u30 = ua0 / n3;
    u31 = ua1 / n3;
    u32 = ua2 / n3;
    g20 = r[t->wheelpoint[i]][0] - r[t->roadpoint[k11]][0];
    g22 = r[t->wheelpoint[i]][2] - r[t->roadpoint[k11]][2];
    x3 = g20;
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11 = p[t->roadadr[k11]];
      h00 = p_k11 * x3;
    } else {
      p_k111 = p[t->roadadr[k11] + 1];
      t5 = 6.28318530717958647693 * x3 / p_k111;
      t6 = sin(t5);
      p_k11_2 = p[t->roadadr[k11]];
      h00 = p_k11_2 * t6;
    }
    t7 = u30 * u30 + u31 * u31;
    t8 = u32 * u30 / t7;
    x2 = g20 + t8 * (g22 - h00);
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11_3 = p[t->roadadr[k11]];
      h10 = p_k11_3 * x2;
      h11 = p_k11_3;
    } else {
      p_k111_2 = p[t->roadadr[k11] + 1];
      t9 = 6.28318530717958647693 * x2 / p_k111_2;
      t10 = sin(t9);
      p_k11_4 = p[t->roadadr[k11]];
      h10 = p_k11_4 * t10;
      t11 = p_k11_4 * 6.28318530717958647693 / p_k111_2;
      t12 = 6.28318530717958647693 * x2 / p_k111_2;
      t13 = cos(t12);
      h11 = t11 * t13;
    }
    t14 = 1.0 + h11 * h11;
    s2 = sqrt(t14);
    n40 = -h11 / s2;
    n41 = 0.0;
    n42 = 1.0 / s2;
    c3 = u30 * n40 + u31 * n41 + u32 * n42;
    un0 = u31 * n42 - u32 * n41;
    un1 = u32 * n40 - u30 * n42;
    un2 = u30 * n41 - u31 * n40;
    t15 = un0 * un0 + un1 * un1 + un2 * un2;
    w = sqrt(t15);
    r2 = ((g20 - x2) * n40 + (g22 - h10) * n42) / w;
    along0 = un0 / w;
    along1 = un1 / w;
    along2 = un2 / w;
    L0 = n41 * along2 - n42 * along1;
    L1 = n42 * along0 - n40 * along2;
    L2 = n40 * along1 - n41 * along0;
    arm0 = r2 * (c3 * u30 - n40) / w;
    T0 = along0;
    N0 = n40;
    arm1 = r2 * (c3 * u31 - n41) / w;
    T1 = along1;
    N1 = n41;
    arm2 = r2 * (c3 * u32 - n42) / w;
    T2 = along2;
    N2 = n42;
    z20 = r2;
    z21 = c3;
    z22 = w;
    Z_b43 = Z[b4][3];
    wr0 = Z_b43;
    Z_b44 = Z[b4][4];
    wr1 = Z_b44;
    Z_b45 = Z[b4][5];
    wr2 = Z_b45;
    vr0 = wr1 * arm2 - wr2 * arm1;
    vr1 = wr2 * arm0 - wr0 * arm2;
    vr2 = wr0 * arm1 - wr1 * arm0;
    v40 = rv[t->wheelpoint[i]][0] + vr0;
    v41 = rv[t->wheelpoint[i]][1] + vr1;
    v42 = rv[t->wheelpoint[i]][2] + vr2;
    vx = v40 * T0 + v41 * T1 + v42 * T2;
    rhov = -(v40 * N0 + v41 * N1 + v42 * N2) / z22;
    omega = (Z[a6][3] - Z_b43) * u30 + (Z[a6][4] - Z_b44) * u31 + (Z[a6][5] - Z_b45) * u32;
    p3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
    p4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
    fz = p3 * (p4 - z20) + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
    fz0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
    ratio = fz / fz0;
    t16 = fz0 / p3;
    t17 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio;
    t18 = atan(t17);
    re = p4 - t16 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio);
    if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y = vx;
    } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y = -vx;
    } else {
      p5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      t19 = vx * vx / p5;
      y = 0.5 * (p5 + t19);
    }
    speed2 = y;
    kappa = (omega * re - vx) / speed2;
    a2 = (v40 * L0 + v41 * L1 + v42 * L2) / speed2;
    gamma = atan2(z21, z22);
    if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z20) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_UNLOADED_RADIUS])) {
      one0 = kappa;
      one1 = side * a2;
      one2 = side * gamma;
      one3 = fz;
      one4 = vx;
      if (t->wheelgrip[i]) {
        kappa2 = one0;
        a3 = one1;
        gamma2 = one2;
        fz2 = one3;
        fz0_2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        r0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        dfz = (fz2 - fz0_2) / fz0_2;
        kx = kappa2 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LHX];
        gx = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        cx = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        mux = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx *
            gx) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        dx = mux * fz2;
        e2 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        if (MAGGI_RE(kx) > 0.0) {
          e3 = e2 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          if (MAGGI_RE(e3) > 1.0) {
            y3 = 1.0;
          } else {
            y3 = e3;
          }
          ex = y3;
        } else {
          e4 = e2 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          if (MAGGI_RE(e4) > 1.0) {
            y4 = 1.0;
          } else {
            y4 = e4;
          }
          ex = y4;
        }
        t20 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz;
        t21 = exp(t20);
        stiff = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        t22 = cx * dx;
        bx = stiff / t22;
        svx = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        y5 = bx * kx;
        t23 = atan(y5);
        t24 = (1.0 - ex) * y5 + ex * t23;
        t25 = atan(t24);
        t26 = cx * t25;
        t27 = sin(t26);
        x40 = dx * t27 + svx;
        x41 = stiff;
        fz0_3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        gy = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        shy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gy;
        ay = a3 + shy;
        cy = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        muy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy *
            gy) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        dy = muy * fz2;
        e5 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        if (MAGGI_RE(ay) > 0.0) {
          e6 = e5 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          if (MAGGI_RE(e6) > 1.0) {
            y6 = 1.0;
          } else {
            y6 = e6;
          }
          ey = y6;
        } else {
          e7 = e5 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          if (MAGGI_RE(e7) > 1.0) {
            y7 = 1.0;
          } else {
            y7 = e7;
          }
          ey = y7;
        }
        t28 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3;
        z4 = fz2 / t28;
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y8 = gy;
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y8 = -gy;
        } else {
          p6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t29 = p6 * p6;
          z5 = gy * gy / t29;
          y8 = 0.125 * p6 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
        }
        t30 = 1.0 + z4 * z4;
        t31 = 2.0 * z4 / t30;
        stiff2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY];
        t32 = cy * dy;
        by = stiff2 / t32;
        svy = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        y9 = by * ay;
        t33 = atan(y9);
        t34 = (1.0 - ey) * y9 + ey * t33;
        t35 = atan(t34);
        t36 = cy * t35;
        t37 = sin(t36);
        y20 = dy * t37 + svy;
        y21 = stiff2;
        y22 = muy;
        y23 = by * cy;
        t38 = svy / stiff2;
        y24 = shy + t38;
        muy2 = y22;
        x5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a3 - p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBY3]);
        t39 = 1.0 + x5 * x5;
        t40 = sqrt(t39);
        t41 = 1.0 / t40;
        stiff3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        e9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz;
        if (MAGGI_RE(e9) > 1.0) {
          y10 = 1.0;
        } else {
          y10 = e9;
        }
        e8 = y10;
        s4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz;
        x6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a3;
        t42 = 1.0 + x6 * x6;
        t43 = sqrt(t42);
        t44 = 1.0 / t43;
        dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2) * t44;
        y11 = stiff3 * (kappa2 + s4);
        y12 = stiff3 * s4;
        t45 = atan(y11);
        t46 = (1.0 - e8) * y11 + e8 * t45;
        t47 = atan(t46);
        p7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        t48 = p7 * t47;
        t49 = cos(t48);
        t50 = atan(y12);
        t51 = (1.0 - e8) * y12 + e8 * t50;
        t52 = atan(t51);
        t53 = p7 * t52;
        t54 = cos(t53);
        g30 = t49 / t54;
        t55 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2;
        t56 = atan(t55);
        t57 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56;
        t58 = sin(t57);
        g31 = dv * t58 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        x7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2;
        t59 = 1.0 + x7 * x7;
        t60 = sqrt(t59);
        t61 = 1.0 / t60;
        stiff4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        e11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz;
        if (MAGGI_RE(e11) > 1.0) {
          y13 = 1.0;
        } else {
          y13 = e11;
        }
        e10 = y13;
        p8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        y14 = stiff4 * (a3 + p8);
        y15 = stiff4 * p8;
        t62 = atan(y14);
        t63 = (1.0 - e10) * y14 + e10 * t62;
        t64 = atan(t63);
        p9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        t65 = p9 * t64;
        t66 = cos(t65);
        t67 = atan(y15);
        t68 = (1.0 - e10) * y15 + e10 * t67;
        t69 = atan(t68);
        t70 = p9 * t69;
        t71 = cos(t70);
        t72 = t66 / t71;
        fx = x40 * t72;
        fy = g30 * y20 + g31;
        ratio2 = x41 * kappa2 / y21;
        bycy = y23;
        shift = y24;
        fz0_4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        gz = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        at = a3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QHZ2] * dfz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gz;
        ar = a3 + shift;
        t73 = at * at + ratio2 * ratio2 + 1e-24;
        ateq = sqrt(t73);
        t74 = ar * ar + ratio2 * ratio2 + 1e-24;
        areq = sqrt(t74);
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y16 = gz;
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y16 = -gz;
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t75 = p10 * p10;
          z6 = gz * gz / t75;
          y16 = 0.125 * p10 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
        }
        bt = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t76 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
        dt = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        t77 = bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * at;
        t78 = atan(t77);
        e12 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfz) *
            (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78);
        if (MAGGI_RE(e12) > 1.0) {
          y17 = 1.0;
        } else {
          y17 = e12;
        }
        et = y17;
        p11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t79 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY] / p11;
        br = t79 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycy;
        dr = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] * p11;
        t80 = 1.0 + a3 * a3;
        t81 = sqrt(t80);
        ca = 1.0 / t81;
        y18 = bt * ateq;
        t82 = atan(y18);
        t83 = (1.0 - et) * y18 + et * t82;
        t84 = atan(t83);
        t85 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84;
        t86 = cos(t85);
        z30 = dt * t86 * ca;
        x8 = br * areq;
        t87 = 1.0 + x8 * x8;
        t88 = sqrt(t87);
        t89 = 1.0 / t88;
        z31 = dr * t89 * ca;
        t90 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
        s3 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        t91 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        way = tanh(t91);
        speed3 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        force20 = fx;
        force21 = fy;
        force22 = fz2;
        t92 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
        force23 = r0 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]);
        t93 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
        force24 = -way * r0 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        force25 = -z30 * (fy - g31) + z31 + s3 * fx;
        rolling0 = force20;
        rolling1 = side * force21;
        rolling2 = force22;
        rolling3 = side * force23;
        rolling4 = force24;
        rolling5 = side * force25;
      } else {
        rolling0 = 0.0;
        rolling1 = 0.0;
        rolling2 = fz;
        rolling3 = 0.0;
        rolling4 = 0.0;
        rolling5 = 0.0;
      }
    } else {
      rolling0 = 0.0;
      rolling1 = 0.0;
      rolling2 = 0.0;
      rolling3 = 0.0;
      rolling4 = 0.0;
      rolling5 = 0.0;
    }
    r30 = r[t->wheelpoint[i]][0] + arm0;
    force30 = rolling0 * T0 + rolling1 * L0 + rolling2 * N0;
    r31 = r[t->wheelpoint[i]][1] + arm1;
    force31 = rolling0 * T1 + rolling1 * L1 + rolling2 * N1;
    r32 = r[t->wheelpoint[i]][2] + arm2;
    force32 = rolling0 * T2 + rolling1 * L2 + rolling2 * N2;
    moment2b = Qb[a6][5];
    moment1b = Qb[a6][4];
    moment0b = Qb[a6][3];
    tb170 = Qb[a6][5];
    r30b = tb170 * force31;
    force31b = tb170 * r30;
    r31b = -(tb170 * force30);
    force30b = -(tb170 * r31);
    tb169 = Qb[a6][4];
    r32b = tb169 * force30;
    force30b += tb169 * r32;
    r30b -= tb169 * force32;
    force32b = -(tb169 * r30);
    tb168 = Qb[a6][3];
    r31b += tb168 * force32;
    force32b += tb168 * r31;
    r32b -= tb168 * force31;
    force31b -= tb168 * r32;
    force32b += Qb[a6][2];
    force31b += Qb[a6][1];
    force30b += Qb[a6][0];
    rolling3b = moment2b * T2;
    T2b = moment2b * rolling3;
    rolling4b = moment2b * L2;
    L2b = moment2b * rolling4;
    rolling5b = moment2b * N2;
    N2b = moment2b * rolling5;
    rolling0b = force32b * T2;
    T2b += force32b * rolling0;
    rolling1b = force32b * L2;
    L2b += force32b * rolling1;
    rolling2b = force32b * N2;
    N2b += force32b * rolling2;
    rb[t->wheelpoint[i]][2] += r32b;
    arm2b = r32b;
    rolling3b += moment1b * T1;
    T1b = moment1b * rolling3;
    rolling4b += moment1b * L1;
    L1b = moment1b * rolling4;
    rolling5b += moment1b * N1;
    rolling0b += force31b * T1;
    T1b += force31b * rolling0;
    rolling1b += force31b * L1;
    L1b += force31b * rolling1;
    rolling2b += force31b * N1;
    rb[t->wheelpoint[i]][1] += r31b;
    arm1b = r31b;
    rolling3b += moment0b * T0;
    T0b = moment0b * rolling3;
    rolling4b += moment0b * L0;
    L0b = moment0b * rolling4;
    rolling5b += moment0b * N0;
    N0b = moment0b * rolling5;
    rolling0b += force30b * T0;
    T0b += force30b * rolling0;
    rolling1b += force30b * L0;
    L0b += force30b * rolling1;
    rolling2b += force30b * N0;
    N0b += force30b * rolling2;
    /* at the contact point on the wheel:  f_x T + f_y L + f_z N;  power of all of it, springs of tyres too */
    rb[t->wheelpoint[i]][0] += r30b;
    arm0b = r30b;
    a2b = 0.0;
    fzb = 0.0;
    gammab = 0.0;
    kappab = 0.0;
    vxb = 0.0;
    if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z20) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_UNLOADED_RADIUS])) {
      one0 = kappa;
      one1 = side * a2;
      one2 = side * gamma;
      one3 = fz;
      one4 = vx;
      one0b = 0.0;
      one1b = 0.0;
      one2b = 0.0;
      one3b = 0.0;
      one4b = 0.0;
      if (t->wheelgrip[i]) {
        kappa2 = one0;
        a3 = one1;
        gamma2 = one2;
        fz2 = one3;
        fz0_2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        r0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        dfz = (fz2 - fz0_2) / fz0_2;
        kx = kappa2 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LHX];
        gx = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        cx = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        mux = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx *
            gx) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        dx = mux * fz2;
        e2 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        if (MAGGI_RE(kx) > 0.0) {
          e3 = e2 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          if (MAGGI_RE(e3) > 1.0) {
            y3 = 1.0;
          } else {
            y3 = e3;
          }
          ex = y3;
        } else {
          e4 = e2 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          if (MAGGI_RE(e4) > 1.0) {
            y4 = 1.0;
          } else {
            y4 = e4;
          }
          ex = y4;
        }
        t20 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz;
        t21 = exp(t20);
        stiff = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        t22 = cx * dx;
        bx = stiff / t22;
        svx = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        y5 = bx * kx;
        t23 = atan(y5);
        t24 = (1.0 - ex) * y5 + ex * t23;
        t25 = atan(t24);
        t26 = cx * t25;
        t27 = sin(t26);
        x40 = dx * t27 + svx;
        x41 = stiff;
        fz0_3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        gy = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        shy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gy;
        ay = a3 + shy;
        cy = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        muy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy *
            gy) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        dy = muy * fz2;
        e5 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        if (MAGGI_RE(ay) > 0.0) {
          e6 = e5 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          if (MAGGI_RE(e6) > 1.0) {
            y6 = 1.0;
          } else {
            y6 = e6;
          }
          ey = y6;
        } else {
          e7 = e5 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          if (MAGGI_RE(e7) > 1.0) {
            y7 = 1.0;
          } else {
            y7 = e7;
          }
          ey = y7;
        }
        t28 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3;
        z4 = fz2 / t28;
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y8 = gy;
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y8 = -gy;
        } else {
          p6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t29 = p6 * p6;
          z5 = gy * gy / t29;
          y8 = 0.125 * p6 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
        }
        t30 = 1.0 + z4 * z4;
        t31 = 2.0 * z4 / t30;
        stiff2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY];
        t32 = cy * dy;
        by = stiff2 / t32;
        svy = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        y9 = by * ay;
        t33 = atan(y9);
        t34 = (1.0 - ey) * y9 + ey * t33;
        t35 = atan(t34);
        t36 = cy * t35;
        t37 = sin(t36);
        y20 = dy * t37 + svy;
        y21 = stiff2;
        y22 = muy;
        y23 = by * cy;
        t38 = svy / stiff2;
        y24 = shy + t38;
        muy2 = y22;
        x5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a3 - p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBY3]);
        t39 = 1.0 + x5 * x5;
        t40 = sqrt(t39);
        t41 = 1.0 / t40;
        stiff3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        e9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz;
        if (MAGGI_RE(e9) > 1.0) {
          y10 = 1.0;
        } else {
          y10 = e9;
        }
        e8 = y10;
        s4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz;
        x6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a3;
        t42 = 1.0 + x6 * x6;
        t43 = sqrt(t42);
        t44 = 1.0 / t43;
        dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2) * t44;
        y11 = stiff3 * (kappa2 + s4);
        y12 = stiff3 * s4;
        t45 = atan(y11);
        t46 = (1.0 - e8) * y11 + e8 * t45;
        t47 = atan(t46);
        p7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        t48 = p7 * t47;
        t49 = cos(t48);
        t50 = atan(y12);
        t51 = (1.0 - e8) * y12 + e8 * t50;
        t52 = atan(t51);
        t53 = p7 * t52;
        t54 = cos(t53);
        g30 = t49 / t54;
        t55 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2;
        t56 = atan(t55);
        t57 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56;
        t58 = sin(t57);
        g31 = dv * t58 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        x7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2;
        t59 = 1.0 + x7 * x7;
        t60 = sqrt(t59);
        t61 = 1.0 / t60;
        stiff4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        e11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz;
        if (MAGGI_RE(e11) > 1.0) {
          y13 = 1.0;
        } else {
          y13 = e11;
        }
        e10 = y13;
        p8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        y14 = stiff4 * (a3 + p8);
        y15 = stiff4 * p8;
        t62 = atan(y14);
        t63 = (1.0 - e10) * y14 + e10 * t62;
        t64 = atan(t63);
        p9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        t65 = p9 * t64;
        t66 = cos(t65);
        t67 = atan(y15);
        t68 = (1.0 - e10) * y15 + e10 * t67;
        t69 = atan(t68);
        t70 = p9 * t69;
        t71 = cos(t70);
        t72 = t66 / t71;
        fx = x40 * t72;
        fy = g30 * y20 + g31;
        ratio2 = x41 * kappa2 / y21;
        bycy = y23;
        shift = y24;
        fz0_4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        gz = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        at = a3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QHZ2] * dfz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gz;
        ar = a3 + shift;
        t73 = at * at + ratio2 * ratio2 + 1e-24;
        ateq = sqrt(t73);
        t74 = ar * ar + ratio2 * ratio2 + 1e-24;
        areq = sqrt(t74);
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y16 = gz;
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y16 = -gz;
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t75 = p10 * p10;
          z6 = gz * gz / t75;
          y16 = 0.125 * p10 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
        }
        bt = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t76 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
        dt = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        t77 = bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * at;
        t78 = atan(t77);
        e12 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfz) *
            (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78);
        if (MAGGI_RE(e12) > 1.0) {
          y17 = 1.0;
        } else {
          y17 = e12;
        }
        et = y17;
        p11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t79 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY] / p11;
        br = t79 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycy;
        dr = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] * p11;
        t80 = 1.0 + a3 * a3;
        t81 = sqrt(t80);
        ca = 1.0 / t81;
        y18 = bt * ateq;
        t82 = atan(y18);
        t83 = (1.0 - et) * y18 + et * t82;
        t84 = atan(t83);
        t85 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84;
        t86 = cos(t85);
        z30 = dt * t86 * ca;
        x8 = br * areq;
        t87 = 1.0 + x8 * x8;
        t88 = sqrt(t87);
        t89 = 1.0 / t88;
        t90 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
        s3 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        t91 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        way = tanh(t91);
        speed3 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        t92 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
        t93 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
        force25b = rolling5b * side;
        rolling5b = 0.0;
        force24b = rolling4b;
        rolling4b = 0.0;
        force23b = rolling3b * side;
        rolling3b = 0.0;
        force22b = rolling2b;
        rolling2b = 0.0;
        force21b = rolling1b * side;
        rolling1b = 0.0;
        force20b = rolling0b;
        rolling0b = 0.0;
        z30b = -(force25b * (fy - g31));
        tb167 = force25b * z30;
        fyb = -tb167;
        g31b = tb167;
        z31b = force25b;
        s3b = force25b * fx;
        fxb = force25b * s3;
        tb159 = force24b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        tb160 = tb159 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3);
        tb161 = tb160 * fz2;
        wayb = -(tb161 * r0);
        r0b = -(tb161 * way);
        fz2b = tb160 * (-way * r0);
        tb162 = tb159 * (-way * r0 * fz2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] += tb162;
        t93b = tb162;
        tb163 = tb162 * speed3;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] += tb163 * way;
        wayb += tb163 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3];
        speed3b = tb162 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way);
        tb164 = tb162 * speed3;
        tb165 = tb164 * speed3;
        tb166 = tb165 * speed3;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] += tb166 * speed3;
        speed3b += tb166 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4];
        speed3b += tb165 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3);
        speed3b += tb164 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3);
        speed3b += tb162 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 *
            speed3);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] += force24b * (-way * r0 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way * speed3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed3 * speed3 * speed3 * speed3));
        tb158 = t93b / fz0_2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] += tb158 * fx;
        fxb += tb158 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2];
        fz0_2b = -(tb158 * t93);
        tb155 = force23b * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]);
        r0b += tb155 * fz2;
        fz2b += tb155 * r0;
        tb156 = force23b * (r0 * fz2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] += tb156 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LVMX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] += tb156 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX1];
        tb157 = tb156 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] -= tb157 * gamma2;
        gamma2b = -(tb157 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2]);
        t92b = tb157;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] += tb156 * (-p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSX2] * gamma2 + t92);
        tb154 = t92b / fz0_2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] += tb154 * fy;
        fyb += tb154 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3];
        fz0_2b -= tb154 * t92;
        fz2b += force22b;
        fyb += force21b;
        fxb += force20b;
        tb153 = speed3b / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        one4b += tb153;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL] -= tb153 * speed3;
        t91b = wayb * (1.0 - way * way);
        tb152 = t91b / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        one4b += tb152;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED] -= tb152 * t91;
        tb149 = s3b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        tb150 = tb149 * r0;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] += tb150;
        t90b = tb150;
        tb151 = tb150 * gamma2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] += tb151;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] += tb151 * dfz;
        dfzb = tb151 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4];
        gamma2b += tb150 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz);
        r0b += tb149 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] += s3b * ((p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0);
        tb148 = t90b / fz0_2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] += tb148 * fy;
        fyb += tb148 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2];
        fz0_2b -= tb148 * t90;
        tb147 = z31b * ca;
        drb = tb147 * t89;
        t89b = tb147 * dr;
        cab = z31b * (dr * t89);
        tb146 = t89b / t88;
        t88b = -(tb146 * t89);
        t87b = t88b * (1.0 / (2.0 * t88));
        x8b = t87b * x8;
        x8b += t87b * x8;
        brb = x8b * areq;
        areqb = x8b * br;
        tb145 = z30b * ca;
        dtb = tb145 * t86;
        t86b = tb145 * dt;
        cab += z30b * (dt * t86);
        t85b = -(t86b * sin(t85));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += t85b * t84;
        t84b = t85b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        t83b = t84b * (1.0 / (1.0 + t83 * t83));
        etb = -(t83b * y18);
        y18b = t83b * (1.0 - et);
        etb += t83b * t82;
        t82b = t83b * et;
        y18b += t82b * (1.0 / (1.0 + y18 * y18));
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        btb = y18b * ateq;
        ateqb = y18b * bt;
        tb144 = cab / t81;
        t81b = -(tb144 * ca);
        t80b = t81b * (1.0 / (2.0 * t81));
        a3b = t80b * a3;
        a3b += t80b * a3;
        tb139 = drb * p11;
        tb140 = tb139 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        fz2b += tb140 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz);
        tb141 = tb140 * fz2;
        tb142 = tb141 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] += tb142;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] += tb142 * dfz;
        dfzb += tb142 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] += tb141 * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz);
        tb143 = tb141 * gz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] += tb143;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] += tb143 * dfz;
        dfzb += tb143 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9];
        gzb = tb141 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb139 * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz));
        p11b = drb * (fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS]);
        t79b = brb;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] += brb * bycy;
        bycyb = brb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10];
        tb138 = t79b / p11;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] += tb138 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += tb138 * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ9];
        p11b -= tb138 * t79;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += p11b;
        y17b = etb;
        e12b = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e12) > 1.0) {
          y17b = 0.0;
        } else {
          e12b += y17b;
          y17b = 0.0;
        }
        tb133 = e12b * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] += tb133;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] += tb133 * dfz;
        dfzb += tb133 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2];
        tb134 = tb133 * dfz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] += tb134 * dfz;
        dfzb += tb134 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3];
        dfzb += tb133 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz);
        tb135 = e12b * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ3] * dfz * dfz);
        tb136 = tb135 * t78;
        tb137 = tb136 * 0.63661977236758134308;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] += tb137;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] += tb137 * gz;
        gzb += tb137 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5];
        t78b = tb135 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308);
        t77b = t78b * (1.0 / (1.0 + t77 * t77));
        tb132 = t77b * at;
        btb += tb132 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] += tb132 * bt;
        atb = t77b * (bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1]);
        tb126 = dtb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        tb127 = tb126 * t76;
        tb128 = tb127 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz);
        fz2b += tb128 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz);
        tb129 = tb128 * fz2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] += tb129;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] += tb129 * dfz;
        dfzb += tb129 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2];
        tb130 = tb127 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] += tb130 * gz;
        gzb += tb130 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3];
        tb131 = tb130 * gz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] += tb131 * gz;
        gzb += tb131 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4];
        gzb += tb130 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz);
        t76b = tb126 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz * gz));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] += dtb * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76);
        tb125 = t76b / fz0_4;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb125;
        fz0_4b = -(tb125 * t76);
        tb120 = btb / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb121 = tb120 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        tb122 = tb121 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] += tb122;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] += tb122 * dfz;
        dfzb += tb122 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2];
        tb123 = tb122 * dfz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] += tb123 * dfz;
        dfzb += tb123 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3];
        dfzb += tb122 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz);
        tb124 = tb121 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz * dfz);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] += tb124 * gz;
        gzb += tb124 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] += tb124 * y16;
        y16b = tb124 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += tb120 * ((p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ5] * y16));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] -= tb120 * bt;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          gzb += y16b;
          y16b = 0.0;
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          gzb -= y16b;
          y16b = 0.0;
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t75 = p10 * p10;
          z6 = gz * gz / t75;
          tb118 = y16b * (15.0 + z6 * (-10.0 + 3.0 * z6));
          p10b = tb118 * z6 * 0.125;
          z6b = tb118 * (0.125 * p10);
          tb119 = y16b * (0.125 * p10 * z6);
          z6b += tb119 * (-10.0 + 3.0 * z6);
          z6b += tb119 * z6 * 3.0;
          y16b = 0.0;
          tb117 = z6b / t75;
          gzb += tb117 * gz;
          gzb += tb117 * gz;
          t75b = -(tb117 * z6);
          p10b += t75b * p10;
          p10b += t75b * p10;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p10b;
        }
        t74b = areqb * (1.0 / (2.0 * areq));
        arb = t74b * ar;
        arb += t74b * ar;
        ratio2b = t74b * ratio2;
        ratio2b += t74b * ratio2;
        t73b = ateqb * (1.0 / (2.0 * ateq));
        atb += t73b * at;
        atb += t73b * at;
        ratio2b += t73b * ratio2;
        ratio2b += t73b * ratio2;
        a3b += arb;
        shiftb = arb;
        a3b += atb;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] += atb;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] += atb * dfz;
        dfzb += atb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2];
        tb116 = atb * gz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] += tb116;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] += tb116 * dfz;
        dfzb += tb116 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4];
        gzb += atb * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz);
        gamma2b += gzb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] += gzb * gamma2;
        /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
         *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_4b *
            p[t->tyreadr[t->wheeltyre[i]]];
        pb[t->tyreadr[t->wheeltyre[i]]] += fz0_4b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO];
        y24b = shiftb;
        y23b = bycyb;
        tb115 = ratio2b / y21;
        x41b = tb115 * kappa2;
        kappa2b = tb115 * x41;
        y21b = -(tb115 * ratio2);
        g30b = fyb * y20;
        y20b = fyb * g30;
        g31b += fyb;
        x40b = fxb * t72;
        t72b = fxb * x40;
        tb114 = t72b / t71;
        t66b = tb114;
        t71b = -(tb114 * t72);
        t70b = -(t71b * sin(t70));
        p9b = t70b * t69;
        t69b = t70b * p9;
        t68b = t69b * (1.0 / (1.0 + t68 * t68));
        e10b = -(t68b * y15);
        y15b = t68b * (1.0 - e10);
        e10b += t68b * t67;
        t67b = t68b * e10;
        y15b += t67b * (1.0 / (1.0 + y15 * y15));
        t65b = -(t66b * sin(t65));
        p9b += t65b * t64;
        t64b = t65b * p9;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1] += p9b;
        t63b = t64b * (1.0 / (1.0 + t63 * t63));
        e10b -= t63b * y14;
        y14b = t63b * (1.0 - e10);
        e10b += t63b * t62;
        t62b = t63b * e10;
        y14b += t62b * (1.0 / (1.0 + y14 * y14));
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        stiff4b = y15b * p8;
        p8b = y15b * stiff4;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        stiff4b += y14b * (a3 + p8);
        tb113 = y14b * stiff4;
        a3b += tb113;
        p8b += tb113;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1] += p8b;
        y13b = e10b;
        e11b = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e11) > 1.0) {
          y13b = 0.0;
        } else {
          e11b += y13b;
          y13b = 0.0;
        }
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] += e11b;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] += e11b * dfz;
        dfzb += e11b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2];
        tb112 = stiff4b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] += tb112 * t61;
        t61b = tb112 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL] += stiff4b *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61);
        tb111 = t61b / t60;
        t60b = -(tb111 * t61);
        t59b = t60b * (1.0 / (2.0 * t60));
        x7b = t59b * x7;
        x7b += t59b * x7;
        /* Gxa = Fx / Fx0 */
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] += x7b * kappa2;
        kappa2b += x7b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2];
        tb110 = g31b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        dvb = tb110 * t58;
        t58b = tb110 * dv;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] += g31b * (dv * t58);
        t57b = t58b * cos(t57);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] += t57b * t56;
        t56b = t57b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5];
        t55b = t56b * (1.0 / (1.0 + t55 * t55));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] += t55b * kappa2;
        kappa2b += t55b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6];
        tb109 = g30b / t54;
        t49b = tb109;
        t54b = -(tb109 * g30);
        t53b = -(t54b * sin(t53));
        p7b = t53b * t52;
        t52b = t53b * p7;
        t51b = t52b * (1.0 / (1.0 + t51 * t51));
        e8b = -(t51b * y12);
        y12b = t51b * (1.0 - e8);
        e8b += t51b * t50;
        t50b = t51b * e8;
        y12b += t50b * (1.0 / (1.0 + y12 * y12));
        t48b = -(t49b * sin(t48));
        p7b += t48b * t47;
        t47b = t48b * p7;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1] += p7b;
        t46b = t47b * (1.0 / (1.0 + t46 * t46));
        e8b -= t46b * y11;
        y11b = t46b * (1.0 - e8);
        e8b += t46b * t45;
        t45b = t46b * e8;
        y11b += t45b * (1.0 / (1.0 + y11 * y11));
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        stiff3b = y12b * s4;
        s4b = y12b * stiff3;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        stiff3b += y11b * (kappa2 + s4);
        tb108 = y11b * stiff3;
        kappa2b += tb108;
        s4b += tb108;
        tb105 = dvb * t44;
        tb106 = tb105 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2);
        muy2b = tb106 * fz2;
        fz2b += tb106 * muy2;
        tb107 = tb105 * (muy2 * fz2);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] += tb107;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] += tb107 * dfz;
        dfzb += tb107 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] += tb107 * gamma2;
        gamma2b += tb107 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3];
        t44b = dvb * (muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2));
        tb104 = t44b / t43;
        t43b = -(tb104 * t44);
        t42b = t43b * (1.0 / (2.0 * t43));
        x6b = t42b * x6;
        x6b += t42b * x6;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] += x6b * a3;
        a3b += x6b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] += s4b;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] += s4b * dfz;
        dfzb += s4b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2];
        y10b = e8b;
        e9b = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e9) > 1.0) {
          y10b = 0.0;
        } else {
          e9b += y10b;
          y10b = 0.0;
        }
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] += e9b;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] += e9b * dfz;
        dfzb += e9b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2];
        tb103 = stiff3b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] += tb103 * t41;
        t41b = tb103 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA] += stiff3b *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41);
        tb102 = t41b / t40;
        t40b = -(tb102 * t41);
        t39b = t40b * (1.0 / (2.0 * t40));
        x5b = t39b * x5;
        x5b += t39b * x5;
        /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] += x5b * (a3 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]);
        tb101 = x5b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2];
        a3b += tb101;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3] -= tb101;
        y22b = muy2b;
        shyb = y24b;
        t38b = y24b;
        tb100 = t38b / stiff2;
        svyb = tb100;
        stiff2b = -(tb100 * t38);
        byb = y23b * cy;
        cyb = y23b * by;
        muyb = y22b;
        stiff2b += y21b;
        dyb = y20b * t37;
        t37b = y20b * dy;
        svyb += y20b;
        t36b = t37b * cos(t36);
        cyb += t36b * t35;
        t35b = t36b * cy;
        t34b = t35b * (1.0 / (1.0 + t34 * t34));
        eyb = -(t34b * y9);
        y9b = t34b * (1.0 - ey);
        eyb += t34b * t33;
        t33b = t34b * ey;
        y9b += t33b * (1.0 / (1.0 + y9 * y9));
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        byb += y9b * ay;
        ayb = y9b * by;
        tb96 = svyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        fz2b += tb96 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy);
        tb97 = tb96 * fz2;
        tb98 = tb97 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] += tb98;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] += tb98 * dfz;
        dfzb += tb98 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] += tb97 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz);
        tb99 = tb97 * gy;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] += tb99;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] += tb99 * dfz;
        dfzb += tb99 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4];
        gyb = tb97 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += svyb * (fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gy));
        tb95 = byb / t32;
        stiff2b += tb95;
        t32b = -(tb95 * by);
        cyb += t32b * dy;
        dyb += t32b * cy;
        tb91 = stiff2b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        tb92 = tb91 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8);
        tb93 = tb92 * t31;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] += tb93 * fz0_3;
        fz0_3b = tb93 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1];
        t31b = tb92 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3);
        tb94 = tb91 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] -= tb94 * y8;
        y8b = -(tb94 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] += stiff2b * (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY3] * y8));
        tb90 = t31b / t30;
        z4b = tb90 * 2.0;
        t30b = -(tb90 * t31);
        z4b += t30b * z4;
        z4b += t30b * z4;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          gyb += y8b;
          y8b = 0.0;
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          gyb -= y8b;
          y8b = 0.0;
        } else {
          p6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t29 = p6 * p6;
          z5 = gy * gy / t29;
          tb88 = y8b * (15.0 + z5 * (-10.0 + 3.0 * z5));
          p6b = tb88 * z5 * 0.125;
          z5b = tb88 * (0.125 * p6);
          tb89 = y8b * (0.125 * p6 * z5);
          z5b += tb89 * (-10.0 + 3.0 * z5);
          z5b += tb89 * z5 * 3.0;
          y8b = 0.0;
          tb87 = z5b / t29;
          gyb += tb87 * gy;
          gyb += tb87 * gy;
          t29b = -(tb87 * z5);
          p6b += t29b * p6;
          p6b += t29b * p6;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER] += p6b;
        }
        tb86 = z4b / t28;
        fz2b += tb86;
        t28b = -(tb86 * z4);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] += t28b * fz0_3;
        fz0_3b += t28b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2];
        e5b = 0.0;
        if (MAGGI_RE(ay) > 0.0) {
          e6 = e5 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          y6b = eyb;
          eyb = 0.0;
          e6b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e6) > 1.0) {
            y6b = 0.0;
          } else {
            e6b += y6b;
            y6b = 0.0;
          }
          e5b += e6b * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          tb84 = e6b * e5;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] -= tb84;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] -= tb84 * gy;
          gyb -= tb84 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
        } else {
          e7 = e5 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
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
          e5b += e7b * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          tb85 = e7b * e5;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] += tb85;
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] += tb85 * gy;
          gyb += tb85 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4];
        }
        tb83 = e5b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] += tb83;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] += tb83 * dfz;
        dfzb += tb83 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] += e5b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz);
        muyb += dyb * fz2;
        fz2b += dyb * muy;
        tb79 = muyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        tb80 = tb79 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] += tb80;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] += tb80 * dfz;
        dfzb += tb80 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2];
        tb81 = tb79 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz);
        tb82 = tb81 * gy;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] -= tb82 * gy;
        gyb -= tb82 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3];
        gyb -= tb81 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] += muyb * ((p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] += cyb * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY] += cyb * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCY1];
        a3b += ayb;
        shyb += ayb;
        tb78 = shyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] += tb78;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] += tb78 * dfz;
        dfzb += tb78 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] += shyb * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] += shyb * gy;
        gyb += shyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3];
        gamma2b += gyb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] += gyb * gamma2;
        /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_3b *
            p[t->tyreadr[t->wheeltyre[i]]];
        pb[t->tyreadr[t->wheeltyre[i]]] += fz0_3b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO];
        stiffb = x41b;
        dxb = x40b * t27;
        t27b = x40b * dx;
        svxb = x40b;
        t26b = t27b * cos(t26);
        cxb = t26b * t25;
        t25b = t26b * cx;
        t24b = t25b * (1.0 / (1.0 + t24 * t24));
        exb = -(t24b * y5);
        y5b = t24b * (1.0 - ex);
        exb += t24b * t23;
        t23b = t24b * ex;
        y5b += t23b * (1.0 / (1.0 + y5 * y5));
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        bxb = y5b * kx;
        kxb = y5b * bx;
        tb75 = svxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb76 = tb75 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX];
        fz2b += tb76 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz);
        tb77 = tb76 * fz2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] += tb77;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] += tb77 * dfz;
        dfzb += tb77 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] += tb75 * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] += svxb * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]);
        tb74 = bxb / t22;
        stiffb += tb74;
        t22b = -(tb74 * bx);
        cxb += t22b * dx;
        dxb += t22b * cx;
        tb71 = stiffb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        tb72 = tb71 * t21;
        fz2b += tb72 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz);
        tb73 = tb72 * fz2;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] += tb73;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] += tb73 * dfz;
        dfzb += tb73 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2];
        t21b = tb71 * (fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] += stiffb * (fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz) * t21);
        t20b = t21b * t21;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] += t20b * dfz;
        dfzb += t20b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3];
        e2b = 0.0;
        if (MAGGI_RE(kx) > 0.0) {
          e3 = e2 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          y3b = exb;
          exb = 0.0;
          e3b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e3) > 1.0) {
            y3b = 0.0;
          } else {
            e3b += y3b;
            y3b = 0.0;
          }
          e2b += e3b * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] -= e3b * e2;
        } else {
          e4 = e2 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          y4b = exb;
          exb = 0.0;
          e4b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e4) > 1.0) {
            y4b = 0.0;
          } else {
            e4b += y4b;
            y4b = 0.0;
          }
          e2b += e4b * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4] += e4b * e2;
        }
        tb69 = e2b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] += tb69;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] += tb69 * dfz;
        dfzb += tb69 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2];
        tb70 = tb69 * dfz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] += tb70 * dfz;
        dfzb += tb70 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3];
        dfzb += tb69 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] += e2b * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz);
        muxb = dxb * fz2;
        fz2b += dxb * mux;
        tb65 = muxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        tb66 = tb65 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] += tb66;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] += tb66 * dfz;
        dfzb += tb66 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2];
        tb67 = tb65 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz);
        tb68 = tb67 * gx;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] -= tb68 * gx;
        gxb = -(tb68 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3]);
        gxb -= tb67 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx);
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] += muxb * ((p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx));
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] += cxb * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX] += cxb * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PCX1];
        gamma2b += gxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] += gxb * gamma2;
        /* Fx0, Kx */
        kappa2b += kxb;
        tb64 = kxb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] += tb64;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] += tb64 * dfz;
        dfzb += tb64 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2];
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz);
        tb63 = dfzb / fz0_2;
        fz2b += tb63;
        fz0_2b -= tb63;
        fz0_2b -= tb63 * dfz;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += r0b;
        pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0_2b *
            p[t->tyreadr[t->wheeltyre[i]]];
        pb[t->tyreadr[t->wheeltyre[i]]] += fz0_2b * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LFZO];
        one3b += fz2b;
        one2b += gamma2b;
        one1b += a3b;
        one0b += kappa2b;
      } else {
        rolling5b = 0.0;
        rolling4b = 0.0;
        rolling3b = 0.0;
        fzb += rolling2b;
        rolling2b = 0.0;
        rolling1b = 0.0;
        rolling0b = 0.0;
      }
      vxb += one4b;
      fzb += one3b;
      gammab += one2b * side;
      a2b += one1b * side;
      kappab += one0b;
    } else {
      rolling5b = 0.0;
      rolling4b = 0.0;
      rolling3b = 0.0;
      rolling2b = 0.0;
      rolling1b = 0.0;
      rolling0b = 0.0;
    }
    z21b = gammab * (z22 / (z22 * z22 + z21 * z21));
    z22b = -(gammab * (z21 / (z22 * z22 + z21 * z21)));
    tb62 = a2b / speed2;
    v40b = tb62 * L0;
    L0b += tb62 * v40;
    v41b = tb62 * L1;
    L1b += tb62 * v41;
    v42b = tb62 * L2;
    L2b += tb62 * v42;
    speed2b = -(tb62 * a2);
    tb61 = kappab / speed2;
    omegab = tb61 * re;
    reb = tb61 * omega;
    vxb -= tb61;
    speed2b -= tb61 * kappa;
    yb = speed2b;
    /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
    if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      vxb += yb;
      yb = 0.0;
    } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      vxb -= yb;
      yb = 0.0;
    } else {
      p5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      t19 = vx * vx / p5;
      tb60 = yb * 0.5;
      p5b = tb60;
      t19b = tb60;
      yb = 0.0;
      tb59 = t19b / p5;
      vxb += tb59 * vx;
      vxb += tb59 * vx;
      p5b -= tb59 * t19;
      pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW] += p5b;
    }
    p4b = reb;
    t16b = -(reb * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio));
    tb58 = reb * t16;
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] -= tb58 * t18;
    t18b = -(tb58 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF]);
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] -= tb58 * ratio;
    ratiob = -(tb58 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF]);
    t17b = t18b * (1.0 / (1.0 + t17 * t17));
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] += t17b * ratio;
    ratiob += t17b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF];
    tb57 = t16b / p3;
    fz0b = tb57;
    p3b = -(tb57 * t16);
    tb56 = ratiob / fz0;
    fzb += tb56;
    fz0b -= tb56 * ratio;
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] += fz0b * p[t->tyreadr[t->wheeltyre[i]]];
    pb[t->tyreadr[t->wheeltyre[i]]] += fz0b * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO];
    p3b += fzb * (p4 - z20);
    tb55 = fzb * p3;
    p4b += tb55;
    z20b = -tb55;
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
    rhovb = fzb * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING];
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] += p4b;
    pb[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += p3b;
    tb52 = omegab * u30;
    Zb[a6][3] += tb52;
    Z_b43b = -tb52;
    u30b = omegab * (Z[a6][3] - Z_b43);
    tb53 = omegab * u31;
    Zb[a6][4] += tb53;
    Z_b44b = -tb53;
    u31b = omegab * (Z[a6][4] - Z_b44);
    tb54 = omegab * u32;
    Zb[a6][5] += tb54;
    Z_b45b = -tb54;
    u32b = omegab * (Z[a6][5] - Z_b45);
    tb51 = rhovb / z22;
    v40b -= tb51 * N0;
    N0b -= tb51 * v40;
    v41b -= tb51 * N1;
    v42b -= tb51 * N2;
    N2b -= tb51 * v42;
    z22b -= tb51 * rhov;
    v40b += vxb * T0;
    T0b += vxb * v40;
    v41b += vxb * T1;
    T1b += vxb * v41;
    v42b += vxb * T2;
    T2b += vxb * v42;
    rvb[t->wheelpoint[i]][2] += v42b;
    vr2b = v42b;
    rvb[t->wheelpoint[i]][1] += v41b;
    vr1b = v41b;
    rvb[t->wheelpoint[i]][0] += v40b;
    vr0b = v40b;
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
    Z_b45b += wr2b;
    Zb[b4][5] += Z_b45b;
    Z_b44b += wr1b;
    Zb[b4][4] += Z_b44b;
    Z_b43b += wr0b;
    Zb[b4][3] += Z_b43b;
    wb = z22b;
    c3b = z21b;
    r2b = z20b;
    n42b = N2b;
    along2b = T2b;
    tb49 = arm2b / w;
    r2b += tb49 * (c3 * u32 - n42);
    tb50 = tb49 * r2;
    c3b += tb50 * u32;
    u32b += tb50 * c3;
    n42b -= tb50;
    wb -= tb49 * arm2;
    along1b = T1b;
    tb47 = arm1b / w;
    r2b += tb47 * (c3 * u31 - n41);
    tb48 = tb47 * r2;
    c3b += tb48 * u31;
    u31b += tb48 * c3;
    wb -= tb47 * arm1;
    n40b = N0b;
    along0b = T0b;
    tb45 = arm0b / w;
    r2b += tb45 * (c3 * u30 - n40);
    tb46 = tb45 * r2;
    c3b += tb46 * u30;
    u30b += tb46 * c3;
    n40b -= tb46;
    wb -= tb45 * arm0;
    n40b += L2b * along1;
    along1b += L2b * n40;
    along0b -= L2b * n41;
    n42b += L1b * along0;
    along0b += L1b * n42;
    n40b -= L1b * along2;
    along2b -= L1b * n40;
    along2b += L0b * n41;
    n42b -= L0b * along1;
    along1b -= L0b * n42;
    tb44 = along2b / w;
    un2b = tb44;
    wb -= tb44 * along2;
    tb43 = along1b / w;
    un1b = tb43;
    wb -= tb43 * along1;
    tb42 = along0b / w;
    un0b = tb42;
    wb -= tb42 * along0;
    tb39 = r2b / w;
    tb40 = tb39 * n40;
    g20b = tb40;
    x2b = -tb40;
    n40b += tb39 * (g20 - x2);
    tb41 = tb39 * n42;
    g22b = tb41;
    h10b = -tb41;
    n42b += tb39 * (g22 - h10);
    wb -= tb39 * r2;
    t15b = wb * (1.0 / (2.0 * w));
    un0b += t15b * un0;
    un0b += t15b * un0;
    un1b += t15b * un1;
    un1b += t15b * un1;
    un2b += t15b * un2;
    un2b += t15b * un2;
    u30b += un2b * n41;
    u31b -= un2b * n40;
    n40b -= un2b * u31;
    u32b += un1b * n40;
    n40b += un1b * u32;
    u30b -= un1b * n42;
    n42b -= un1b * u30;
    u31b += un0b * n42;
    n42b += un0b * u31;
    u32b -= un0b * n41;
    u30b += c3b * n40;
    n40b += c3b * u30;
    u31b += c3b * n41;
    u32b += c3b * n42;
    n42b += c3b * u32;
    tb38 = n42b / s2;
    s2b = -(tb38 * n42);
    tb37 = n40b / s2;
    h11b = -tb37;
    s2b -= tb37 * n40;
    t14b = s2b * (1.0 / (2.0 * s2));
    h11b += t14b * h11;
    h11b += t14b * h11;
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11_3 = p[t->roadadr[k11]];
      p_k11_3b = h11b;
      h11b = 0.0;
      p_k11_3b += h10b * x2;
      x2b += h10b * p_k11_3;
      h10b = 0.0;
      pb[t->roadadr[k11]] += p_k11_3b;
    } else {
      p_k111_2 = p[t->roadadr[k11] + 1];
      t9 = 6.28318530717958647693 * x2 / p_k111_2;
      t10 = sin(t9);
      p_k11_4 = p[t->roadadr[k11]];
      t11 = p_k11_4 * 6.28318530717958647693 / p_k111_2;
      t12 = 6.28318530717958647693 * x2 / p_k111_2;
      t13 = cos(t12);
      t11b = h11b * t13;
      t13b = h11b * t11;
      h11b = 0.0;
      t12b = -(t13b * sin(t12));
      tb36 = t12b / p_k111_2;
      x2b += tb36 * 6.28318530717958647693;
      p_k111_2b = -(tb36 * t12);
      tb35 = t11b / p_k111_2;
      p_k11_4b = tb35 * 6.28318530717958647693;
      p_k111_2b -= tb35 * t11;
      p_k11_4b += h10b * t10;
      t10b = h10b * p_k11_4;
      h10b = 0.0;
      pb[t->roadadr[k11]] += p_k11_4b;
      t9b = t10b * cos(t9);
      tb34 = t9b / p_k111_2;
      x2b += tb34 * 6.28318530717958647693;
      p_k111_2b -= tb34 * t9;
      pb[t->roadadr[k11] + 1] += p_k111_2b;
    }
    g20b += x2b;
    t8b = x2b * (g22 - h00);
    tb33 = x2b * t8;
    g22b += tb33;
    h00b = -tb33;
    tb32 = t8b / t7;
    u32b += tb32 * u30;
    u30b += tb32 * u32;
    t7b = -(tb32 * t8);
    u30b += t7b * u30;
    u30b += t7b * u30;
    u31b += t7b * u31;
    u31b += t7b * u31;
    x3b = 0.0;
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11 = p[t->roadadr[k11]];
      p_k11b = h00b * x3;
      x3b += h00b * p_k11;
      h00b = 0.0;
      pb[t->roadadr[k11]] += p_k11b;
    } else {
      p_k111 = p[t->roadadr[k11] + 1];
      t5 = 6.28318530717958647693 * x3 / p_k111;
      t6 = sin(t5);
      p_k11_2 = p[t->roadadr[k11]];
      p_k11_2b = h00b * t6;
      t6b = h00b * p_k11_2;
      h00b = 0.0;
      pb[t->roadadr[k11]] += p_k11_2b;
      t5b = t6b * cos(t5);
      tb31 = t5b / p_k111;
      x3b += tb31 * 6.28318530717958647693;
      p_k111b = -(tb31 * t5);
      pb[t->roadadr[k11] + 1] += p_k111b;
    }
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
    g20b += x3b;
    rb[t->wheelpoint[i]][2] += g22b;
    rb[t->roadpoint[k11]][2] -= g22b;
    rb[t->wheelpoint[i]][0] += g20b;
    rb[t->roadpoint[k11]][0] -= g20b;
    tb30 = u32b / n3;
    ua2b = tb30;
    n3b = -(tb30 * u32);
    tb29 = u31b / n3;
    ua1b = tb29;
    n3b -= tb29 * u31;
    tb28 = u30b / n3;
    ua0b = tb28;
    n3b -= tb28 * u30;
    t4b = n3b * (1.0 / (2.0 * n3));
    ua0b += t4b * ua0;
    ua0b += t4b * ua0;
    ua1b += t4b * ua1;
    ua1b += t4b * ua1;
    ua2b += t4b * ua2;
    ua2b += t4b * ua2;
    Ab[a6][6] += ua2b * a00;
    a00b = ua2b * A[a6][6];
    Ab[a6][7] += ua2b * a01;
    a01b = ua2b * A[a6][7];
    Ab[a6][8] += ua2b * a02;
    a02b = ua2b * A[a6][8];
    Ab[a6][3] += ua1b * a00;
    a00b += ua1b * A[a6][3];
    Ab[a6][4] += ua1b * a01;
    a01b += ua1b * A[a6][4];
    Ab[a6][5] += ua1b * a02;
    a02b += ua1b * A[a6][5];
    Ab[a6][0] += ua0b * a00;
    a00b += ua0b * A[a6][0];
    Ab[a6][1] += ua0b * a01;
    a01b += ua0b * A[a6][1];
    Ab[a6][2] += ua0b * a02;
    a02b += ua0b * A[a6][2];
    pb[t->wheelaxis[i] + 2] += a02b;
    pb[t->wheelaxis[i] + 1] += a01b;
    pb[t->wheelaxis[i]] += a00b;
  }
  for (i = t->nforce - 1; i >= 0; --i) {
    adr2 = t->forceadr[i];
    if (t->forcefun[i] >= 0) {
      s = fun[t->forcefun[i]][0];
    } else {
      s = 1.0;
    }
    sb = 0.0;
    if (t->forcekind[i] == MAGGI_FORCE_JOINT) {
      a5 = t->forceq[i];
      p_adr2 = p[adr2];
      tb16 = taub[a5];
      p_adr2b = tb16 * s;
      sb += tb16 * p_adr2;
      pb[adr2] += p_adr2b;
    } else {
      a5_2 = t->forcebody[i];
      b3 = t->forcereaction[i];
      if (t->forcekind[i] == MAGGI_FORCE_DRAG) {
        u20 = rv[t->forcepoint[i]][0] - p[adr2 + MAGGI_DRAG_WIND];
        u21 = rv[t->forcepoint[i]][1] - p[adr2 + MAGGI_DRAG_WIND + 1];
        u22 = rv[t->forcepoint[i]][2] - p[adr2 + MAGGI_DRAG_WIND + 2];
        p2 = p[adr2 + MAGGI_DRAG_LOW];
        t3 = u20 * u20 + u21 * u21 + u22 * u22 + p2 * p2;
        speed = sqrt(t3);
        c = 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * s;
        g0 = -c * speed * u20;
        g1 = -c * speed * u21;
        g2_2 = -c * speed * u22;
      } else {
        c20 = p[adr2] * s;
        c21 = p[adr2 + 1] * s;
        c22 = p[adr2 + 2] * s;
        if (t->forcekind[i] == MAGGI_FORCE_BODY || t->forcekind[i] == MAGGI_TORQUE_BODY) {
          g0 = A[a5_2][0] * c20 + A[a5_2][1] * c21 + A[a5_2][2] * c22;
          g1 = A[a5_2][3] * c20 + A[a5_2][4] * c21 + A[a5_2][5] * c22;
          g2_2 = A[a5_2][6] * c20 + A[a5_2][7] * c21 + A[a5_2][8] * c22;
        } else {
          g0 = c20;
          g1 = c21;
          g2_2 = c22;
        }
      }
      g0b = 0.0;
      g1b = 0.0;
      g2_2b = 0.0;
      if (t->forcepoint[i] >= 0) {
        back20 = -g0;
        back21 = -g1;
        back22 = -g2_2;
        r_i1 = r[t->forcepoint[i]][1];
        r_i2 = r[t->forcepoint[i]][2];
        r_i0 = r[t->forcepoint[i]][0];
        tb27 = Qb[b3][5];
        r_i0b = tb27 * back21;
        back21b = tb27 * r_i0;
        r_i1b = -(tb27 * back20);
        back20b = -(tb27 * r_i1);
        tb26 = Qb[b3][4];
        r_i2b = tb26 * back20;
        back20b += tb26 * r_i2;
        r_i0b -= tb26 * back22;
        back22b = -(tb26 * r_i0);
        tb25 = Qb[b3][3];
        r_i1b += tb25 * back22;
        back22b += tb25 * r_i1;
        r_i2b -= tb25 * back21;
        back21b -= tb25 * r_i2;
        back22b += Qb[b3][2];
        back21b += Qb[b3][1];
        back20b += Qb[b3][0];
        tb24 = Qb[a5_2][5];
        r_i0b += tb24 * g1;
        g1b += tb24 * r_i0;
        r_i1b -= tb24 * g0;
        g0b -= tb24 * r_i1;
        tb23 = Qb[a5_2][4];
        r_i2b += tb23 * g0;
        g0b += tb23 * r_i2;
        r_i0b -= tb23 * g2_2;
        g2_2b -= tb23 * r_i0;
        rb[t->forcepoint[i]][0] += r_i0b;
        tb22 = Qb[a5_2][3];
        r_i1b += tb22 * g2_2;
        g2_2b += tb22 * r_i1;
        r_i2b -= tb22 * g1;
        g1b -= tb22 * r_i2;
        rb[t->forcepoint[i]][2] += r_i2b;
        rb[t->forcepoint[i]][1] += r_i1b;
        g2_2b += Qb[a5_2][2];
        g1b += Qb[a5_2][1];
        g0b += Qb[a5_2][0];
        g2_2b -= back22b;
        g1b -= back21b;
        /* force at r, or pure torque, on one body and back on another; returns its power */
        g0b -= back20b;
      } else {
        g2_2b -= Qb[b3][5];
        g2_2b += Qb[a5_2][5];
        g1b -= Qb[b3][4];
        g1b += Qb[a5_2][4];
        g0b -= Qb[b3][3];
        g0b += Qb[a5_2][3];
      }
      if (t->forcekind[i] == MAGGI_FORCE_DRAG) {
        u20 = rv[t->forcepoint[i]][0] - p[adr2 + MAGGI_DRAG_WIND];
        u21 = rv[t->forcepoint[i]][1] - p[adr2 + MAGGI_DRAG_WIND + 1];
        u22 = rv[t->forcepoint[i]][2] - p[adr2 + MAGGI_DRAG_WIND + 2];
        p2 = p[adr2 + MAGGI_DRAG_LOW];
        t3 = u20 * u20 + u21 * u21 + u22 * u22 + p2 * p2;
        speed = sqrt(t3);
        c = 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * s;
        tb21 = g2_2b * u22;
        cb = -(tb21 * speed);
        speedb = -(tb21 * c);
        u22b = g2_2b * (-c * speed);
        g2_2b = 0.0;
        tb20 = g1b * u21;
        cb -= tb20 * speed;
        speedb -= tb20 * c;
        u21b = g1b * (-c * speed);
        g1b = 0.0;
        tb19 = g0b * u20;
        cb -= tb19 * speed;
        speedb -= tb19 * c;
        u20b = g0b * (-c * speed);
        g0b = 0.0;
        tb17 = cb * s;
        tb18 = tb17 * p[adr2 + MAGGI_DRAG_AREA];
        pb[adr2] += tb18 * p[adr2 + MAGGI_DRAG_C] * 0.5;
        pb[adr2 + MAGGI_DRAG_C] += tb18 * (0.5 * p[adr2]);
        pb[adr2 + MAGGI_DRAG_AREA] += tb17 * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C]);
        sb += cb * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA]);
        t3b = speedb * (1.0 / (2.0 * speed));
        u20b += t3b * u20;
        u20b += t3b * u20;
        u21b += t3b * u21;
        u21b += t3b * u21;
        u22b += t3b * u22;
        u22b += t3b * u22;
        p2b = t3b * p2;
        p2b += t3b * p2;
        pb[adr2 + MAGGI_DRAG_LOW] += p2b;
        rvb[t->forcepoint[i]][2] += u22b;
        pb[adr2 + MAGGI_DRAG_WIND + 2] -= u22b;
        rvb[t->forcepoint[i]][1] += u21b;
        pb[adr2 + MAGGI_DRAG_WIND + 1] -= u21b;
        /* - rho/2 c A |u| u,  u = v - wind,  |u| = sqrt(u.u + low^2) */
        rvb[t->forcepoint[i]][0] += u20b;
        pb[adr2 + MAGGI_DRAG_WIND] -= u20b;
      } else {
        c20 = p[adr2] * s;
        c21 = p[adr2 + 1] * s;
        c22 = p[adr2 + 2] * s;
        c20b = 0.0;
        c21b = 0.0;
        c22b = 0.0;
        if (t->forcekind[i] == MAGGI_FORCE_BODY || t->forcekind[i] == MAGGI_TORQUE_BODY) {
          Ab[a5_2][6] += g2_2b * c20;
          c20b += g2_2b * A[a5_2][6];
          Ab[a5_2][7] += g2_2b * c21;
          c21b += g2_2b * A[a5_2][7];
          Ab[a5_2][8] += g2_2b * c22;
          c22b += g2_2b * A[a5_2][8];
          g2_2b = 0.0;
          Ab[a5_2][3] += g1b * c20;
          c20b += g1b * A[a5_2][3];
          Ab[a5_2][4] += g1b * c21;
          c21b += g1b * A[a5_2][4];
          Ab[a5_2][5] += g1b * c22;
          c22b += g1b * A[a5_2][5];
          g1b = 0.0;
          Ab[a5_2][0] += g0b * c20;
          c20b += g0b * A[a5_2][0];
          Ab[a5_2][1] += g0b * c21;
          c21b += g0b * A[a5_2][1];
          Ab[a5_2][2] += g0b * c22;
          c22b += g0b * A[a5_2][2];
          g0b = 0.0;
        } else {
          c22b += g2_2b;
          g2_2b = 0.0;
          c21b += g1b;
          g1b = 0.0;
          c20b += g0b;
          g0b = 0.0;
        }
        pb[adr2 + 2] += c22b * s;
        sb += c22b * p[adr2 + 2];
        pb[adr2 + 1] += c21b * s;
        sb += c21b * p[adr2 + 1];
        pb[adr2] += c20b * s;
        sb += c20b * p[adr2];
      }
    }
    if (t->forcefun[i] >= 0) {
      funb[t->forcefun[i]][0] += sb;
      sb = 0.0;
    } else {
      sb = 0.0;
    }
  }
  for (i = t->njspring - 1; i >= 0; --i) {
    a4 = t->jspringq[i];
    b2 = t->jspringq2[i];
    adr = t->jspringadr[i];
    if (b2 >= 0) {
      x = q[a4] - q[b2];
      xv = v[a4] - v[b2];
    } else {
      x = q[a4];
      xv = v[a4];
    }
    torque0b = 0.0;
    if (b2 >= 0) {
      torque0b -= taub[b2];
    }
    torque0b += taub[a4];
    pb[adr] -= torque0b * (x - p[adr + MAGGI_JSPRING_REST]);
    tb15 = torque0b * p[adr];
    xb = -tb15;
    pb[adr + MAGGI_JSPRING_REST] += tb15;
    pb[adr + MAGGI_JSPRING_C] -= torque0b * xv;
    xvb = -(torque0b * p[adr + MAGGI_JSPRING_C]);
    pb[adr + MAGGI_JSPRING_PRELOAD] -= torque0b;
    if (b2 >= 0) {
      vb[a4] += xvb;
      vb[b2] -= xvb;
      xvb = 0.0;
      qb[a4] += xb;
      qb[b2] -= xb;
      xb = 0.0;
    } else {
      vb[a4] += xvb;
      xvb = 0.0;
      qb[a4] += xb;
      xb = 0.0;
    }
  }
  for (i = t->nspring - 1; i >= 0; --i) {
    a = t->springpa[i];
    b = t->springpb[i];
    e0 = r[a][0] - r[b][0];
    ev0 = rv[a][0] - rv[b][0];
    e1 = r[a][1] - r[b][1];
    ev1 = rv[a][1] - rv[b][1];
    e2_2 = r[a][2] - r[b][2];
    ev2 = rv[a][2] - rv[b][2];
    t2 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
    l = sqrt(t2);
    n20 = e0 / l;
    n21 = e1 / l;
    n22 = e2_2 / l;
    lv = n20 * ev0 + n21 * ev1 + n22 * ev2;
    damping = p[t->springadr[i] + MAGGI_SPRING_C] * lv;
    if (t->springpreload[i]) {
      f0 = p[t->springadr[i]] * (l - spring0[i]) + p[t->springadr[i] + MAGGI_SPRING_L];
    } else {
      f0 = p[t->springadr[i]] * (l - p[t->springadr[i] + MAGGI_SPRING_L]);
    }
    k2 = t->springadr[i] + MAGGI_SPRING_SLOPES;
    if (t->springslopes[i]) {
      if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
        p_k24 = p[k2 + 4];
        f2 = p[k2] * p_k24 + p[k2 + 1] * (lv - p_k24);
      } else if (MAGGI_RE(lv) > 0.0) {
        f2 = p[k2] * lv;
      } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
        f2 = p[k2 + 2] * lv;
      } else {
        p_k25 = p[k2 + 5];
        f2 = p[k2 + 2] * p_k25 + p[k2 + 3] * (lv - p_k25);
      }
      f1 = damping + f2;
    } else {
      f1 = damping;
    }
    u0 = n20;
    u1 = n21;
    u2_2 = n22;
    f3 = f0 + f1;
    force0 = f3 * u0;
    back0 = -f3 * u0;
    force1 = f3 * u1;
    back1 = -f3 * u1;
    force2_2 = f3 * u2_2;
    back2_2 = -f3 * u2_2;
    r_a1 = r[a][1];
    r_a2 = r[a][2];
    r_a0 = r[a][0];
    r_b1 = r[b][1];
    r_b2 = r[b][2];
    r_b0 = r[b][0];
    tb14 = Qb[t->pointbody[b]][5];
    r_b0b = tb14 * force1;
    force1b = tb14 * r_b0;
    r_b1b = -(tb14 * force0);
    force0b = -(tb14 * r_b1);
    tb13 = Qb[t->pointbody[b]][4];
    r_b2b = tb13 * force0;
    force0b += tb13 * r_b2;
    r_b0b -= tb13 * force2_2;
    force2_2b = -(tb13 * r_b0);
    rb[b][0] += r_b0b;
    tb12 = Qb[t->pointbody[b]][3];
    r_b1b += tb12 * force2_2;
    force2_2b += tb12 * r_b1;
    r_b2b -= tb12 * force1;
    force1b -= tb12 * r_b2;
    rb[b][2] += r_b2b;
    rb[b][1] += r_b1b;
    force2_2b += Qb[t->pointbody[b]][2];
    force1b += Qb[t->pointbody[b]][1];
    force0b += Qb[t->pointbody[b]][0];
    tb11 = Qb[t->pointbody[a]][5];
    r_a0b = tb11 * back1;
    back1b = tb11 * r_a0;
    r_a1b = -(tb11 * back0);
    back0b = -(tb11 * r_a1);
    tb10 = Qb[t->pointbody[a]][4];
    r_a2b = tb10 * back0;
    back0b += tb10 * r_a2;
    r_a0b -= tb10 * back2_2;
    back2_2b = -(tb10 * r_a0);
    rb[a][0] += r_a0b;
    tb9 = Qb[t->pointbody[a]][3];
    r_a1b += tb9 * back2_2;
    back2_2b += tb9 * r_a1;
    r_a2b -= tb9 * back1;
    back1b -= tb9 * r_a2;
    rb[a][2] += r_a2b;
    rb[a][1] += r_a1b;
    back2_2b += Qb[t->pointbody[a]][2];
    back1b += Qb[t->pointbody[a]][1];
    back0b += Qb[t->pointbody[a]][0];
    f3b = -(back2_2b * u2_2);
    u2_2b = -(back2_2b * f3);
    f3b += force2_2b * u2_2;
    u2_2b += force2_2b * f3;
    f3b -= back1b * u1;
    u1b = -(back1b * f3);
    f3b += force1b * u1;
    u1b += force1b * f3;
    f3b -= back0b * u0;
    u0b = -(back0b * f3);
    f3b += force0b * u0;
    u0b += force0b * f3;
    f0b = f3b;
    f1b = f3b;
    n22b = u2_2b;
    n21b = u1b;
    n20b = u0b;
    dampingb = 0.0;
    lvb = 0.0;
    if (t->springslopes[i]) {
      dampingb += f1b;
      f2b = f1b;
      f1b = 0.0;
      /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
      if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
        p_k24 = p[k2 + 4];
        pb[k2] += f2b * p_k24;
        p_k24b = f2b * p[k2];
        pb[k2 + 1] += f2b * (lv - p_k24);
        tb7 = f2b * p[k2 + 1];
        lvb += tb7;
        p_k24b -= tb7;
        f2b = 0.0;
        pb[k2 + 4] += p_k24b;
      } else if (MAGGI_RE(lv) > 0.0) {
        pb[k2] += f2b * lv;
        lvb += f2b * p[k2];
        f2b = 0.0;
      } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
        pb[k2 + 2] += f2b * lv;
        lvb += f2b * p[k2 + 2];
        f2b = 0.0;
      } else {
        p_k25 = p[k2 + 5];
        pb[k2 + 2] += f2b * p_k25;
        p_k25b = f2b * p[k2 + 2];
        pb[k2 + 3] += f2b * (lv - p_k25);
        tb8 = f2b * p[k2 + 3];
        lvb += tb8;
        p_k25b -= tb8;
        f2b = 0.0;
        pb[k2 + 5] += p_k25b;
      }
    } else {
      dampingb += f1b;
      f1b = 0.0;
    }
    lb = 0.0;
    if (t->springpreload[i]) {
      pb[t->springadr[i]] += f0b * (l - spring0[i]);
      tb5 = f0b * p[t->springadr[i]];
      lb += tb5;
      spring0b[i] -= tb5;
      pb[t->springadr[i] + MAGGI_SPRING_L] += f0b;
      f0b = 0.0;
    } else {
      pb[t->springadr[i]] += f0b * (l - p[t->springadr[i] + MAGGI_SPRING_L]);
      tb6 = f0b * p[t->springadr[i]];
      lb += tb6;
      pb[t->springadr[i] + MAGGI_SPRING_L] -= tb6;
      f0b = 0.0;
    }
    pb[t->springadr[i] + MAGGI_SPRING_C] += dampingb * lv;
    lvb += dampingb * p[t->springadr[i] + MAGGI_SPRING_C];
    n20b += lvb * ev0;
    ev0b = lvb * n20;
    n21b += lvb * ev1;
    ev1b = lvb * n21;
    n22b += lvb * ev2;
    ev2b = lvb * n22;
    tb4 = n22b / l;
    e2_2b = tb4;
    lb -= tb4 * n22;
    tb3 = n21b / l;
    e1b = tb3;
    lb -= tb3 * n21;
    tb2 = n20b / l;
    e0b = tb2;
    lb -= tb2 * n20;
    t2b = lb * (1.0 / (2.0 * l));
    e0b += t2b * e0;
    e0b += t2b * e0;
    e1b += t2b * e1;
    e1b += t2b * e1;
    e2_2b += t2b * e2_2;
    e2_2b += t2b * e2_2;
    rvb[a][2] += ev2b;
    rvb[b][2] -= ev2b;
    rb[a][2] += e2_2b;
    rb[b][2] -= e2_2b;
    rvb[a][1] += ev1b;
    rvb[b][1] -= ev1b;
    rb[a][1] += e1b;
    rb[b][1] -= e1b;
    rvb[a][0] += ev0b;
    rvb[b][0] -= ev0b;
    rb[a][0] += e0b;
    rb[b][0] -= e0b;
  }
  for (i = t->nq - 1; i >= 0; --i) {
    taub[i] = 0.0;
  }
  for (i = t->nbody; i >= 0; --i) {
    for (k = 5; k >= 0; --k) {
      Qb[i][k] = 0.0;
    }
  }
}
