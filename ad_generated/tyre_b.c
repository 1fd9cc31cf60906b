/* Adjoint of core/kernel/tyre.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* the formula of every tyre at a slip of its own */
void maggi_tyres_b(const maggi_topo *t, const double p[restrict t->np], double pb[restrict t->np],
                   const double slip[restrict t->ntyre][5], double slipb[restrict t->ntyre][5],
                   double f[restrict t->ntyre][6], double fb[restrict t->ntyre][6])
{
  int i;
  double a, ab, ar, arb, areq, areqb, at, atb, ateq, ateqb, ay, ayb, br, brb, bt, btb, bx, bxb, by,
      byb, bycy, bycyb, ca, cab, cx, cxb, cy, cyb, dfz, dfzb, dr, drb, dt, dtb, dv, dvb, dx, dxb,
      dy, dyb, e, e10, e10b, e11, e11b, e2, e2b, e3, e3b, e4, e4b, e5, e5b, e6, e6b, e7, e7b, e8,
      e8b, e9, e9b, eb, et, etb, ex, exb, ey, eyb, fx, fxb, fy, fyb, fz, fz0, fz0_2, fz0_2b, fz0_3,
      fz0_3b, fz0b, fzb, g0, g0b, g1, g1b, gamma, gammab, gx, gxb, gy, gyb, gz, gzb, kappa, kappab,
      kx, kxb, mux, muxb, muy, muy2, muy2b, muyb, p2, p2b, p3, p3b, p4, p4b, p5, p5b, p6, p6b, p7,
      p7b, r0, r0b, ratio, ratiob, s, s2, s2b, sb, shift, shiftb, shy, shyb, slip_i4, slip_i4b,
      speed, speedb, stiff, stiff2, stiff2b, stiff3, stiff3b, stiff4, stiff4b, stiffb, svx, svxb,
      svy, svyb, t10, t10b, t11, t11b, t12, t12b, t13, t13b, t14, t14b, t15, t15b, t16, t16b, t17,
      t17b, t18, t18b, t19, t19b, t2, t20, t20b, t21, t21b, t22, t22b, t23, t23b, t24, t24b, t25,
      t25b, t26, t26b, t27, t27b, t28, t28b, t29, t29b, t2b, t3, t30, t30b, t31, t31b, t32, t32b,
      t33, t33b, t34, t34b, t35, t35b, t36, t36b, t37, t37b, t38, t38b, t39, t39b, t3b, t4, t40,
      t40b, t41, t41b, t42, t42b, t43, t43b, t44, t44b, t45, t45b, t46, t46b, t47, t47b, t48, t48b,
      t49, t49b, t4b, t5, t50, t50b, t51, t51b, t52, t52b, t53, t53b, t54, t54b, t55, t55b, t56,
      t56b, t57, t57b, t58, t58b, t59, t59b, t5b, t6, t60, t60b, t61, t61b, t62, t62b, t63, t63b,
      t64, t64b, t65, t65b, t66, t66b, t67, t67b, t68, t68b, t69, t69b, t6b, t7, t70, t70b, t71,
      t71b, t72, t72b, t73, t73b, t74, t74b, t75, t75b, t7b, t8, t8b, t9, t9b, tb10, tb100, tb101,
      tb102, tb103, tb104, tb105, tb106, tb107, tb108, tb109, tb11, tb12, tb13, tb14, tb15, tb16,
      tb17, tb18, tb19, tb2, tb20, tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3, tb30,
      tb31, tb32, tb33, tb34, tb35, tb36, tb37, tb38, tb39, tb4, tb40, tb41, tb42, tb43, tb44, tb45,
      tb46, tb47, tb48, tb49, tb5, tb50, tb51, tb52, tb53, tb54, tb55, tb56, tb57, tb58, tb59, tb6,
      tb60, tb61, tb62, tb63, tb64, tb65, tb66, tb67, tb68, tb69, tb7, tb70, tb71, tb72, tb73, tb74,
      tb75, tb76, tb77, tb78, tb79, tb8, tb80, tb81, tb82, tb83, tb84, tb85, tb86, tb87, tb88, tb89,
      tb9, tb90, tb91, tb92, tb93, tb94, tb95, tb96, tb97, tb98, tb99, way, wayb, x0, x0b, x1, x1b,
      x2, x2b, x3, x3b, x4, x4b, x5, x5b, y0, y0b, y1, y10, y10b, y11, y11b, y12, y12b, y13, y13b,
      y14, y14b, y15, y15b, y16, y16b, y17, y17b, y1b, y2, y2_2, y2_2b, y2b, y3, y3_2, y3_2b, y3b,
      y4, y4_2, y4_2b, y4b, y5, y5b, y6, y6b, y7, y7b, y8, y8b, y9, y9b, z0, z0b, z1b, z2, z2b, z3,
      z3b, z4, z4b;

  for (i = t->ntyre - 1; i >= 0; --i) {
    kappa = slip[i][0];
    a = slip[i][1];
    gamma = slip[i][2];
    fz = f[i][2];
    fz0 = p[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]];
    r0 = p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS];
    dfz = (fz - fz0) / fz0;
    kx = kappa + (p[t->tyreadr[i] + MAGGI_TYRE_PHX1] + p[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LHX];
    gx = gamma * p[t->tyreadr[i] + MAGGI_TYRE_LGAX];
    cx = p[t->tyreadr[i] + MAGGI_TYRE_PCX1] * p[t->tyreadr[i] + MAGGI_TYRE_LCX];
    mux = (p[t->tyreadr[i] + MAGGI_TYRE_PDX1] + p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
        p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx * gx) * p[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    dx = mux * fz;
    e = (p[t->tyreadr[i] + MAGGI_TYRE_PEX1] + p[t->tyreadr[i] + MAGGI_TYRE_PEX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LEX];
    if (MAGGI_RE(kx) > 0.0) {
      e2 = e * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
      if (MAGGI_RE(e2) > 1.0) {
        y2 = 1.0;
      } else {
        y2 = e2;
      }
      ex = y2;
    } else {
      e3 = e * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
      if (MAGGI_RE(e3) > 1.0) {
        y3 = 1.0;
      } else {
        y3 = e3;
      }
      ex = y3;
    }
    t2 = p[t->tyreadr[i] + MAGGI_TYRE_PKX3] * dfz;
    t3 = exp(t2);
    stiff = fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz) *
        t3 * p[t->tyreadr[i] + MAGGI_TYRE_LKX];
    t4 = cx * dx;
    bx = stiff / t4;
    svx = fz * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVX] * p[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    y4 = bx * kx;
    t5 = atan(y4);
    t6 = (1.0 - ex) * y4 + ex * t5;
    t7 = atan(t6);
    t8 = cx * t7;
    t9 = sin(t8);
    x0 = dx * t9 + svx;
    x1 = stiff;
    fz0_2 = p[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]];
    gy = gamma * p[t->tyreadr[i] + MAGGI_TYRE_LGAY];
    shy = (p[t->tyreadr[i] + MAGGI_TYRE_PHY1] + p[t->tyreadr[i] + MAGGI_TYRE_PHY2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LHY] + p[t->tyreadr[i] + MAGGI_TYRE_PHY3] * gy;
    ay = a + shy;
    cy = p[t->tyreadr[i] + MAGGI_TYRE_PCY1] * p[t->tyreadr[i] + MAGGI_TYRE_LCY];
    muy = (p[t->tyreadr[i] + MAGGI_TYRE_PDY1] + p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
        p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy * gy) * p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    dy = muy * fz;
    e4 = (p[t->tyreadr[i] + MAGGI_TYRE_PEY1] + p[t->tyreadr[i] + MAGGI_TYRE_PEY2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LEY];
    if (MAGGI_RE(ay) > 0.0) {
      e5 = e4 * (1.0 - (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
      if (MAGGI_RE(e5) > 1.0) {
        y5 = 1.0;
      } else {
        y5 = e5;
      }
      ey = y5;
    } else {
      e6 = e4 * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
      if (MAGGI_RE(e6) > 1.0) {
        y6 = 1.0;
      } else {
        y6 = e6;
      }
      ey = y6;
    }
    t10 = p[t->tyreadr[i] + MAGGI_TYRE_PKY2] * fz0_2;
    z2 = fz / t10;
    if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y7 = gy;
    } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y7 = -gy;
    } else {
      p2 = p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      t11 = p2 * p2;
      z3 = gy * gy / t11;
      y7 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
    }
    t12 = 1.0 + z2 * z2;
    t13 = 2.0 * z2 / t12;
    stiff2 = p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 - p[t->tyreadr[i] +
        MAGGI_TYRE_PKY3] * y7) * p[t->tyreadr[i] + MAGGI_TYRE_LKY];
    t14 = cy * dy;
    by = stiff2 / t14;
    svy = fz * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfz) * gy) * p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    y8 = by * ay;
    t15 = atan(y8);
    t16 = (1.0 - ey) * y8 + ey * t15;
    t17 = atan(t16);
    t18 = cy * t17;
    t19 = sin(t18);
    y0 = dy * t19 + svy;
    y1 = stiff2;
    y2_2 = muy;
    y3_2 = by * cy;
    t20 = svy / stiff2;
    y4_2 = shy + t20;
    muy2 = y2_2;
    x2 = p[t->tyreadr[i] + MAGGI_TYRE_RBY2] * (a - p[t->tyreadr[i] + MAGGI_TYRE_RBY3]);
    t21 = 1.0 + x2 * x2;
    t22 = sqrt(t21);
    t23 = 1.0 / t22;
    stiff3 = p[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23 * p[t->tyreadr[i] + MAGGI_TYRE_LYKA];
    e8 = p[t->tyreadr[i] + MAGGI_TYRE_REY1] + p[t->tyreadr[i] + MAGGI_TYRE_REY2] * dfz;
    if (MAGGI_RE(e8) > 1.0) {
      y9 = 1.0;
    } else {
      y9 = e8;
    }
    e7 = y9;
    s2 = p[t->tyreadr[i] + MAGGI_TYRE_RHY1] + p[t->tyreadr[i] + MAGGI_TYRE_RHY2] * dfz;
    x3 = p[t->tyreadr[i] + MAGGI_TYRE_RVY4] * a;
    t24 = 1.0 + x3 * x3;
    t25 = sqrt(t24);
    t26 = 1.0 / t25;
    dv = muy2 * fz * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz
        + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma) * t26;
    y10 = stiff3 * (kappa + s2);
    y11 = stiff3 * s2;
    t27 = atan(y10);
    t28 = (1.0 - e7) * y10 + e7 * t27;
    t29 = atan(t28);
    p3 = p[t->tyreadr[i] + MAGGI_TYRE_RCY1];
    t30 = p3 * t29;
    t31 = cos(t30);
    t32 = atan(y11);
    t33 = (1.0 - e7) * y11 + e7 * t32;
    t34 = atan(t33);
    t35 = p3 * t34;
    t36 = cos(t35);
    g0 = t31 / t36;
    t37 = p[t->tyreadr[i] + MAGGI_TYRE_RVY6] * kappa;
    t38 = atan(t37);
    t39 = p[t->tyreadr[i] + MAGGI_TYRE_RVY5] * t38;
    t40 = sin(t39);
    g1 = dv * t40 * p[t->tyreadr[i] + MAGGI_TYRE_LVYKA];
    x4 = p[t->tyreadr[i] + MAGGI_TYRE_RBX2] * kappa;
    t41 = 1.0 + x4 * x4;
    t42 = sqrt(t41);
    t43 = 1.0 / t42;
    stiff4 = p[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43 * p[t->tyreadr[i] + MAGGI_TYRE_LXAL];
    e10 = p[t->tyreadr[i] + MAGGI_TYRE_REX1] + p[t->tyreadr[i] + MAGGI_TYRE_REX2] * dfz;
    if (MAGGI_RE(e10) > 1.0) {
      y12 = 1.0;
    } else {
      y12 = e10;
    }
    e9 = y12;
    p4 = p[t->tyreadr[i] + MAGGI_TYRE_RHX1];
    y13 = stiff4 * (a + p4);
    y14 = stiff4 * p4;
    t44 = atan(y13);
    t45 = (1.0 - e9) * y13 + e9 * t44;
    t46 = atan(t45);
    p5 = p[t->tyreadr[i] + MAGGI_TYRE_RCX1];
    t47 = p5 * t46;
    t48 = cos(t47);
    t49 = atan(y14);
    t50 = (1.0 - e9) * y14 + e9 * t49;
    t51 = atan(t50);
    t52 = p5 * t51;
    t53 = cos(t52);
    t54 = t48 / t53;
    fx = f[i][0];
    fy = f[i][1];
    ratio = x1 * kappa / y1;
    bycy = y3_2;
    shift = y4_2;
    fz0_3 = p[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]];
    gz = gamma * p[t->tyreadr[i] + MAGGI_TYRE_LGAZ];
    at = a + p[t->tyreadr[i] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QHZ2] * dfz +
        (p[t->tyreadr[i] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfz) * gz;
    ar = a + shift;
    t55 = at * at + ratio * ratio + 1e-24;
    ateq = sqrt(t55);
    t56 = ar * ar + ratio * ratio + 1e-24;
    areq = sqrt(t56);
    if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y15 = gz;
    } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y15 = -gz;
    } else {
      p6 = p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      t57 = p6 * p6;
      z4 = gz * gz / t57;
      y15 = 0.125 * p6 * z4 * (15.0 + z4 * (-10.0 + 3.0 * z4));
    }
    bt = (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4]
        * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15) * p[t->tyreadr[i] + MAGGI_TYRE_LKY] /
        p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    t58 = p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_3;
    dt = fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) * (1.0
        + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) *
        t58 * p[t->tyreadr[i] + MAGGI_TYRE_LTR];
    t59 = bt * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * at;
    t60 = atan(t59);
    e11 = (p[t->tyreadr[i] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz * dfz) * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_QEZ4]
        + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t60);
    if (MAGGI_RE(e11) > 1.0) {
      y16 = 1.0;
    } else {
      y16 = e11;
    }
    et = y16;
    p7 = p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    t61 = p[t->tyreadr[i] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[i] + MAGGI_TYRE_LKY] / p7;
    br = t61 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ10] * bycy;
    dr = fz * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] * p7;
    t62 = 1.0 + a * a;
    t63 = sqrt(t62);
    ca = 1.0 / t63;
    y17 = bt * ateq;
    t64 = atan(y17);
    t65 = (1.0 - et) * y17 + et * t64;
    t66 = atan(t65);
    t67 = p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * t66;
    t68 = cos(t67);
    z0 = dt * t68 * ca;
    x5 = br * areq;
    t69 = 1.0 + x5 * x5;
    t70 = sqrt(t69);
    t71 = 1.0 / t70;
    t72 = p[t->tyreadr[i] + MAGGI_TYRE_SSZ2] * fy / fz0;
    s = (p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] +
        p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0 * p[t->tyreadr[i] + MAGGI_TYRE_LS];
    slip_i4 = slip[i][4];
    t73 = slip_i4 / p[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED];
    way = tanh(t73);
    speed = slip_i4 / p[t->tyreadr[i] + MAGGI_TYRE_LONGVL];
    t74 = p[t->tyreadr[i] + MAGGI_TYRE_QSX3] * fy / fz0;
    t75 = p[t->tyreadr[i] + MAGGI_TYRE_QSY2] * fx / fz0;
    tb108 = fb[i][5];
    fb[i][5] = 0.0;
    z0b = -(tb108 * (fy - g1));
    tb109 = tb108 * z0;
    fyb = -tb109;
    g1b = tb109;
    z1b = tb108;
    sb = tb108 * fx;
    fxb = tb108 * s;
    tb99 = fb[i][4];
    fb[i][4] = 0.0;
    tb100 = tb99 * p[t->tyreadr[i] + MAGGI_TYRE_LMY];
    tb101 = tb100 * (p[t->tyreadr[i] + MAGGI_TYRE_QSY1] + t75 + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] *
        way * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed * speed);
    tb102 = tb101 * fz;
    wayb = -(tb102 * r0);
    r0b = -(tb102 * way);
    fzb = tb101 * (-way * r0);
    tb103 = tb100 * (-way * r0 * fz);
    pb[t->tyreadr[i] + MAGGI_TYRE_QSY1] += tb103;
    t75b = tb103;
    tb104 = tb103 * speed;
    pb[t->tyreadr[i] + MAGGI_TYRE_QSY3] += tb104 * way;
    wayb += tb104 * p[t->tyreadr[i] + MAGGI_TYRE_QSY3];
    speedb = tb103 * (p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way);
    tb105 = tb103 * speed;
    tb106 = tb105 * speed;
    tb107 = tb106 * speed;
    pb[t->tyreadr[i] + MAGGI_TYRE_QSY4] += tb107 * speed;
    speedb += tb107 * p[t->tyreadr[i] + MAGGI_TYRE_QSY4];
    speedb += tb106 * (p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed);
    speedb += tb105 * (p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed);
    speedb += tb103 * (p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed);
    pb[t->tyreadr[i] + MAGGI_TYRE_LMY] += tb99 * (-way * r0 * fz * (p[t->tyreadr[i] +
        MAGGI_TYRE_QSY1] + t75 + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way * speed + p[t->tyreadr[i]
        + MAGGI_TYRE_QSY4] * speed * speed * speed * speed));
    tb98 = t75b / fz0;
    pb[t->tyreadr[i] + MAGGI_TYRE_QSY2] += tb98 * fx;
    fxb += tb98 * p[t->tyreadr[i] + MAGGI_TYRE_QSY2];
    fz0b = -(tb98 * t75);
    tb94 = fb[i][3];
    fb[i][3] = 0.0;
    tb95 = tb94 * (p[t->tyreadr[i] + MAGGI_TYRE_QSX1] * p[t->tyreadr[i] + MAGGI_TYRE_LVMX] +
        (-p[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma + t74) * p[t->tyreadr[i] + MAGGI_TYRE_LMX]);
    r0b += tb95 * fz;
    fzb += tb95 * r0;
    tb96 = tb94 * (r0 * fz);
    pb[t->tyreadr[i] + MAGGI_TYRE_QSX1] += tb96 * p[t->tyreadr[i] + MAGGI_TYRE_LVMX];
    pb[t->tyreadr[i] + MAGGI_TYRE_LVMX] += tb96 * p[t->tyreadr[i] + MAGGI_TYRE_QSX1];
    tb97 = tb96 * p[t->tyreadr[i] + MAGGI_TYRE_LMX];
    pb[t->tyreadr[i] + MAGGI_TYRE_QSX2] -= tb97 * gamma;
    gammab = -(tb97 * p[t->tyreadr[i] + MAGGI_TYRE_QSX2]);
    t74b = tb97;
    pb[t->tyreadr[i] + MAGGI_TYRE_LMX] += tb96 * (-p[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma +
        t74);
    tb93 = t74b / fz0;
    pb[t->tyreadr[i] + MAGGI_TYRE_QSX3] += tb93 * fy;
    fyb += tb93 * p[t->tyreadr[i] + MAGGI_TYRE_QSX3];
    fz0b -= tb93 * t74;
    fzb += fb[i][2];
    fb[i][2] = 0.0;
    fyb += fb[i][1];
    fb[i][1] = 0.0;
    fxb += fb[i][0];
    fb[i][0] = 0.0;
    tb92 = speedb / p[t->tyreadr[i] + MAGGI_TYRE_LONGVL];
    slip_i4b = tb92;
    pb[t->tyreadr[i] + MAGGI_TYRE_LONGVL] -= tb92 * speed;
    t73b = wayb * (1.0 - way * way);
    tb91 = t73b / p[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED];
    slip_i4b += tb91;
    pb[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED] -= tb91 * t73;
    slipb[i][4] += slip_i4b;
    tb88 = sb * p[t->tyreadr[i] + MAGGI_TYRE_LS];
    tb89 = tb88 * r0;
    pb[t->tyreadr[i] + MAGGI_TYRE_SSZ1] += tb89;
    t72b = tb89;
    tb90 = tb89 * gamma;
    pb[t->tyreadr[i] + MAGGI_TYRE_SSZ3] += tb90;
    pb[t->tyreadr[i] + MAGGI_TYRE_SSZ4] += tb90 * dfz;
    dfzb = tb90 * p[t->tyreadr[i] + MAGGI_TYRE_SSZ4];
    gammab += tb89 * (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] *
        dfz);
    r0b += tb88 * (p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] +
        p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma);
    pb[t->tyreadr[i] + MAGGI_TYRE_LS] += sb * ((p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 +
        (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma) *
        r0);
    tb87 = t72b / fz0;
    pb[t->tyreadr[i] + MAGGI_TYRE_SSZ2] += tb87 * fy;
    fyb += tb87 * p[t->tyreadr[i] + MAGGI_TYRE_SSZ2];
    fz0b -= tb87 * t72;
    tb86 = z1b * ca;
    drb = tb86 * t71;
    t71b = tb86 * dr;
    cab = z1b * (dr * t71);
    tb85 = t71b / t70;
    t70b = -(tb85 * t71);
    t69b = t70b * (1.0 / (2.0 * t70));
    x5b = t69b * x5;
    x5b += t69b * x5;
    brb = x5b * areq;
    areqb = x5b * br;
    tb84 = z0b * ca;
    dtb = tb84 * t68;
    t68b = tb84 * dt;
    cab += z0b * (dt * t68);
    t67b = -(t68b * sin(t67));
    pb[t->tyreadr[i] + MAGGI_TYRE_QCZ1] += t67b * t66;
    t66b = t67b * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1];
    t65b = t66b * (1.0 / (1.0 + t65 * t65));
    etb = -(t65b * y17);
    y17b = t65b * (1.0 - et);
    etb += t65b * t64;
    t64b = t65b * et;
    y17b += t64b * (1.0 / (1.0 + y17 * y17));
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    btb = y17b * ateq;
    ateqb = y17b * bt;
    tb83 = cab / t63;
    t63b = -(tb83 * ca);
    t62b = t63b * (1.0 / (2.0 * t63));
    ab = t62b * a;
    ab += t62b * a;
    tb78 = drb * p7;
    tb79 = tb78 * p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS];
    fzb += tb79 * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfz) * gz);
    tb80 = tb79 * fz;
    tb81 = tb80 * p[t->tyreadr[i] + MAGGI_TYRE_LRES];
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ6] += tb81;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ7] += tb81 * dfz;
    dfzb += tb81 * p[t->tyreadr[i] + MAGGI_TYRE_QDZ7];
    pb[t->tyreadr[i] + MAGGI_TYRE_LRES] += tb80 * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz);
    tb82 = tb80 * gz;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ8] += tb82;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ9] += tb82 * dfz;
    dfzb += tb82 * p[t->tyreadr[i] + MAGGI_TYRE_QDZ9];
    gzb = tb80 * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz);
    pb[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] += tb78 * (fz * ((p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[i] +
        MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9]
        * dfz) * gz));
    p7b = drb * (fz * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] *
        dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[i] +
        MAGGI_TYRE_UNLOADED_RADIUS]);
    t61b = brb;
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ10] += brb * bycy;
    bycyb = brb * p[t->tyreadr[i] + MAGGI_TYRE_QBZ10];
    tb77 = t61b / p7;
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ9] += tb77 * p[t->tyreadr[i] + MAGGI_TYRE_LKY];
    pb[t->tyreadr[i] + MAGGI_TYRE_LKY] += tb77 * p[t->tyreadr[i] + MAGGI_TYRE_QBZ9];
    p7b -= tb77 * t61;
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUY] += p7b;
    y16b = etb;
    e11b = 0.0;
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e11) > 1.0) {
      y16b = 0.0;
    } else {
      e11b += y16b;
      y16b = 0.0;
    }
    tb72 = e11b * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] *
        gz) * 0.63661977236758134308 * t60);
    pb[t->tyreadr[i] + MAGGI_TYRE_QEZ1] += tb72;
    pb[t->tyreadr[i] + MAGGI_TYRE_QEZ2] += tb72 * dfz;
    dfzb += tb72 * p[t->tyreadr[i] + MAGGI_TYRE_QEZ2];
    tb73 = tb72 * dfz;
    pb[t->tyreadr[i] + MAGGI_TYRE_QEZ3] += tb73 * dfz;
    dfzb += tb73 * p[t->tyreadr[i] + MAGGI_TYRE_QEZ3];
    dfzb += tb72 * (p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz);
    tb74 = e11b * (p[t->tyreadr[i] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz * dfz);
    tb75 = tb74 * t60;
    tb76 = tb75 * 0.63661977236758134308;
    pb[t->tyreadr[i] + MAGGI_TYRE_QEZ4] += tb76;
    pb[t->tyreadr[i] + MAGGI_TYRE_QEZ5] += tb76 * gz;
    gzb += tb76 * p[t->tyreadr[i] + MAGGI_TYRE_QEZ5];
    t60b = tb74 * ((p[t->tyreadr[i] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gz) *
        0.63661977236758134308);
    t59b = t60b * (1.0 / (1.0 + t59 * t59));
    tb71 = t59b * at;
    btb += tb71 * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1];
    pb[t->tyreadr[i] + MAGGI_TYRE_QCZ1] += tb71 * bt;
    atb = t59b * (bt * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1]);
    tb65 = dtb * p[t->tyreadr[i] + MAGGI_TYRE_LTR];
    tb66 = tb65 * t58;
    tb67 = tb66 * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ4] * gz * gz);
    fzb += tb67 * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz);
    tb68 = tb67 * fz;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ1] += tb68;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ2] += tb68 * dfz;
    dfzb += tb68 * p[t->tyreadr[i] + MAGGI_TYRE_QDZ2];
    tb69 = tb66 * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] *
        dfz));
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ3] += tb69 * gz;
    gzb += tb69 * p[t->tyreadr[i] + MAGGI_TYRE_QDZ3];
    tb70 = tb69 * gz;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ4] += tb70 * gz;
    gzb += tb70 * p[t->tyreadr[i] + MAGGI_TYRE_QDZ4];
    gzb += tb69 * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz);
    t58b = tb65 * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] *
        dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] *
        gz * gz));
    pb[t->tyreadr[i] + MAGGI_TYRE_LTR] += dtb * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) * t58);
    tb64 = t58b / fz0_3;
    pb[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] += tb64;
    fz0_3b = -(tb64 * t58);
    tb59 = btb / p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    tb60 = tb59 * p[t->tyreadr[i] + MAGGI_TYRE_LKY];
    tb61 = tb60 * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] +
        MAGGI_TYRE_QBZ5] * y15);
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ1] += tb61;
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ2] += tb61 * dfz;
    dfzb += tb61 * p[t->tyreadr[i] + MAGGI_TYRE_QBZ2];
    tb62 = tb61 * dfz;
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ3] += tb62 * dfz;
    dfzb += tb62 * p[t->tyreadr[i] + MAGGI_TYRE_QBZ3];
    dfzb += tb61 * (p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz);
    tb63 = tb60 * (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz);
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ4] += tb63 * gz;
    gzb += tb63 * p[t->tyreadr[i] + MAGGI_TYRE_QBZ4];
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ5] += tb63 * y15;
    y15b = tb63 * p[t->tyreadr[i] + MAGGI_TYRE_QBZ5];
    pb[t->tyreadr[i] + MAGGI_TYRE_LKY] += tb59 * ((p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
        (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15));
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUY] -= tb59 * bt;
    /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
     * where straight running is, and exact from w on */
    if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      gzb += y15b;
      y15b = 0.0;
    } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      gzb -= y15b;
      y15b = 0.0;
    } else {
      p6 = p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      t57 = p6 * p6;
      z4 = gz * gz / t57;
      tb57 = y15b * (15.0 + z4 * (-10.0 + 3.0 * z4));
      p6b = tb57 * z4 * 0.125;
      z4b = tb57 * (0.125 * p6);
      tb58 = y15b * (0.125 * p6 * z4);
      z4b += tb58 * (-10.0 + 3.0 * z4);
      z4b += tb58 * z4 * 3.0;
      y15b = 0.0;
      tb56 = z4b / t57;
      gzb += tb56 * gz;
      gzb += tb56 * gz;
      t57b = -(tb56 * z4);
      p6b += t57b * p6;
      p6b += t57b * p6;
      pb[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER] += p6b;
    }
    t56b = areqb * (1.0 / (2.0 * areq));
    arb = t56b * ar;
    arb += t56b * ar;
    ratiob = t56b * ratio;
    ratiob += t56b * ratio;
    t55b = ateqb * (1.0 / (2.0 * ateq));
    atb += t55b * at;
    atb += t55b * at;
    ratiob += t55b * ratio;
    ratiob += t55b * ratio;
    ab += arb;
    shiftb = arb;
    ab += atb;
    pb[t->tyreadr[i] + MAGGI_TYRE_QHZ1] += atb;
    pb[t->tyreadr[i] + MAGGI_TYRE_QHZ2] += atb * dfz;
    dfzb += atb * p[t->tyreadr[i] + MAGGI_TYRE_QHZ2];
    tb55 = atb * gz;
    pb[t->tyreadr[i] + MAGGI_TYRE_QHZ3] += tb55;
    pb[t->tyreadr[i] + MAGGI_TYRE_QHZ4] += tb55 * dfz;
    dfzb += tb55 * p[t->tyreadr[i] + MAGGI_TYRE_QHZ4];
    gzb += atb * (p[t->tyreadr[i] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfz);
    gammab += gzb * p[t->tyreadr[i] + MAGGI_TYRE_LGAZ];
    pb[t->tyreadr[i] + MAGGI_TYRE_LGAZ] += gzb * gamma;
    /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
     *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
    pb[t->tyreadr[i] + MAGGI_TYRE_LFZO] += fz0_3b * p[t->tyreadr[i]];
    pb[t->tyreadr[i]] += fz0_3b * p[t->tyreadr[i] + MAGGI_TYRE_LFZO];
    y4_2b = shiftb;
    y3_2b = bycyb;
    tb54 = ratiob / y1;
    x1b = tb54 * kappa;
    kappab = tb54 * x1;
    y1b = -(tb54 * ratio);
    g0b = fyb * y0;
    y0b = fyb * g0;
    g1b += fyb;
    x0b = fxb * t54;
    t54b = fxb * x0;
    tb53 = t54b / t53;
    t48b = tb53;
    t53b = -(tb53 * t54);
    t52b = -(t53b * sin(t52));
    p5b = t52b * t51;
    t51b = t52b * p5;
    t50b = t51b * (1.0 / (1.0 + t50 * t50));
    e9b = -(t50b * y14);
    y14b = t50b * (1.0 - e9);
    e9b += t50b * t49;
    t49b = t50b * e9;
    y14b += t49b * (1.0 / (1.0 + y14 * y14));
    t47b = -(t48b * sin(t47));
    p5b += t47b * t46;
    t46b = t47b * p5;
    pb[t->tyreadr[i] + MAGGI_TYRE_RCX1] += p5b;
    t45b = t46b * (1.0 / (1.0 + t45 * t45));
    e9b -= t45b * y13;
    y13b = t45b * (1.0 - e9);
    e9b += t45b * t44;
    t44b = t45b * e9;
    y13b += t44b * (1.0 / (1.0 + y13 * y13));
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    stiff4b = y14b * p4;
    p4b = y14b * stiff4;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    stiff4b += y13b * (a + p4);
    tb52 = y13b * stiff4;
    ab += tb52;
    p4b += tb52;
    pb[t->tyreadr[i] + MAGGI_TYRE_RHX1] += p4b;
    y12b = e9b;
    e10b = 0.0;
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e10) > 1.0) {
      y12b = 0.0;
    } else {
      e10b += y12b;
      y12b = 0.0;
    }
    pb[t->tyreadr[i] + MAGGI_TYRE_REX1] += e10b;
    pb[t->tyreadr[i] + MAGGI_TYRE_REX2] += e10b * dfz;
    dfzb += e10b * p[t->tyreadr[i] + MAGGI_TYRE_REX2];
    tb51 = stiff4b * p[t->tyreadr[i] + MAGGI_TYRE_LXAL];
    pb[t->tyreadr[i] + MAGGI_TYRE_RBX1] += tb51 * t43;
    t43b = tb51 * p[t->tyreadr[i] + MAGGI_TYRE_RBX1];
    pb[t->tyreadr[i] + MAGGI_TYRE_LXAL] += stiff4b * (p[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43);
    tb50 = t43b / t42;
    t42b = -(tb50 * t43);
    t41b = t42b * (1.0 / (2.0 * t42));
    x4b = t41b * x4;
    x4b += t41b * x4;
    /* Gxa = Fx / Fx0 */
    pb[t->tyreadr[i] + MAGGI_TYRE_RBX2] += x4b * kappa;
    kappab += x4b * p[t->tyreadr[i] + MAGGI_TYRE_RBX2];
    tb49 = g1b * p[t->tyreadr[i] + MAGGI_TYRE_LVYKA];
    dvb = tb49 * t40;
    t40b = tb49 * dv;
    pb[t->tyreadr[i] + MAGGI_TYRE_LVYKA] += g1b * (dv * t40);
    t39b = t40b * cos(t39);
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY5] += t39b * t38;
    t38b = t39b * p[t->tyreadr[i] + MAGGI_TYRE_RVY5];
    t37b = t38b * (1.0 / (1.0 + t37 * t37));
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY6] += t37b * kappa;
    kappab += t37b * p[t->tyreadr[i] + MAGGI_TYRE_RVY6];
    tb48 = g0b / t36;
    t31b = tb48;
    t36b = -(tb48 * g0);
    t35b = -(t36b * sin(t35));
    p3b = t35b * t34;
    t34b = t35b * p3;
    t33b = t34b * (1.0 / (1.0 + t33 * t33));
    e7b = -(t33b * y11);
    y11b = t33b * (1.0 - e7);
    e7b += t33b * t32;
    t32b = t33b * e7;
    y11b += t32b * (1.0 / (1.0 + y11 * y11));
    t30b = -(t31b * sin(t30));
    p3b += t30b * t29;
    t29b = t30b * p3;
    pb[t->tyreadr[i] + MAGGI_TYRE_RCY1] += p3b;
    t28b = t29b * (1.0 / (1.0 + t28 * t28));
    e7b -= t28b * y10;
    y10b = t28b * (1.0 - e7);
    e7b += t28b * t27;
    t27b = t28b * e7;
    y10b += t27b * (1.0 / (1.0 + y10 * y10));
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    stiff3b = y11b * s2;
    s2b = y11b * stiff3;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    stiff3b += y10b * (kappa + s2);
    tb47 = y10b * stiff3;
    kappab += tb47;
    s2b += tb47;
    tb44 = dvb * t26;
    tb45 = tb44 * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma);
    muy2b = tb45 * fz;
    fzb += tb45 * muy2;
    tb46 = tb44 * (muy2 * fz);
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY1] += tb46;
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY2] += tb46 * dfz;
    dfzb += tb46 * p[t->tyreadr[i] + MAGGI_TYRE_RVY2];
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY3] += tb46 * gamma;
    gammab += tb46 * p[t->tyreadr[i] + MAGGI_TYRE_RVY3];
    t26b = dvb * (muy2 * fz * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] +
        MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma));
    tb43 = t26b / t25;
    t25b = -(tb43 * t26);
    t24b = t25b * (1.0 / (2.0 * t25));
    x3b = t24b * x3;
    x3b += t24b * x3;
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY4] += x3b * a;
    ab += x3b * p[t->tyreadr[i] + MAGGI_TYRE_RVY4];
    pb[t->tyreadr[i] + MAGGI_TYRE_RHY1] += s2b;
    pb[t->tyreadr[i] + MAGGI_TYRE_RHY2] += s2b * dfz;
    dfzb += s2b * p[t->tyreadr[i] + MAGGI_TYRE_RHY2];
    y9b = e7b;
    e8b = 0.0;
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e8) > 1.0) {
      y9b = 0.0;
    } else {
      e8b += y9b;
      y9b = 0.0;
    }
    pb[t->tyreadr[i] + MAGGI_TYRE_REY1] += e8b;
    pb[t->tyreadr[i] + MAGGI_TYRE_REY2] += e8b * dfz;
    dfzb += e8b * p[t->tyreadr[i] + MAGGI_TYRE_REY2];
    tb42 = stiff3b * p[t->tyreadr[i] + MAGGI_TYRE_LYKA];
    pb[t->tyreadr[i] + MAGGI_TYRE_RBY1] += tb42 * t23;
    t23b = tb42 * p[t->tyreadr[i] + MAGGI_TYRE_RBY1];
    pb[t->tyreadr[i] + MAGGI_TYRE_LYKA] += stiff3b * (p[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23);
    tb41 = t23b / t22;
    t22b = -(tb41 * t23);
    t21b = t22b * (1.0 / (2.0 * t22));
    x2b = t21b * x2;
    x2b += t21b * x2;
    /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
    pb[t->tyreadr[i] + MAGGI_TYRE_RBY2] += x2b * (a - p[t->tyreadr[i] + MAGGI_TYRE_RBY3]);
    tb40 = x2b * p[t->tyreadr[i] + MAGGI_TYRE_RBY2];
    ab += tb40;
    pb[t->tyreadr[i] + MAGGI_TYRE_RBY3] -= tb40;
    y2_2b = muy2b;
    shyb = y4_2b;
    t20b = y4_2b;
    tb39 = t20b / stiff2;
    svyb = tb39;
    stiff2b = -(tb39 * t20);
    byb = y3_2b * cy;
    cyb = y3_2b * by;
    muyb = y2_2b;
    stiff2b += y1b;
    dyb = y0b * t19;
    t19b = y0b * dy;
    svyb += y0b;
    t18b = t19b * cos(t18);
    cyb += t18b * t17;
    t17b = t18b * cy;
    t16b = t17b * (1.0 / (1.0 + t16 * t16));
    eyb = -(t16b * y8);
    y8b = t16b * (1.0 - ey);
    eyb += t16b * t15;
    t15b = t16b * ey;
    y8b += t15b * (1.0 / (1.0 + y8 * y8));
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    byb += y8b * ay;
    ayb = y8b * by;
    tb35 = svyb * p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    fzb += tb35 * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfz) * gy);
    tb36 = tb35 * fz;
    tb37 = tb36 * p[t->tyreadr[i] + MAGGI_TYRE_LVY];
    pb[t->tyreadr[i] + MAGGI_TYRE_PVY1] += tb37;
    pb[t->tyreadr[i] + MAGGI_TYRE_PVY2] += tb37 * dfz;
    dfzb += tb37 * p[t->tyreadr[i] + MAGGI_TYRE_PVY2];
    pb[t->tyreadr[i] + MAGGI_TYRE_LVY] += tb36 * (p[t->tyreadr[i] + MAGGI_TYRE_PVY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz);
    tb38 = tb36 * gy;
    pb[t->tyreadr[i] + MAGGI_TYRE_PVY3] += tb38;
    pb[t->tyreadr[i] + MAGGI_TYRE_PVY4] += tb38 * dfz;
    dfzb += tb38 * p[t->tyreadr[i] + MAGGI_TYRE_PVY4];
    gyb = tb36 * (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz);
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUY] += svyb * (fz * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LVY] +
        (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz) * gy));
    tb34 = byb / t14;
    stiff2b += tb34;
    t14b = -(tb34 * by);
    cyb += t14b * dy;
    dyb += t14b * cy;
    tb30 = stiff2b * p[t->tyreadr[i] + MAGGI_TYRE_LKY];
    tb31 = tb30 * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7);
    tb32 = tb31 * t13;
    pb[t->tyreadr[i] + MAGGI_TYRE_PKY1] += tb32 * fz0_2;
    fz0_2b = tb32 * p[t->tyreadr[i] + MAGGI_TYRE_PKY1];
    t13b = tb31 * (p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2);
    tb33 = tb30 * (p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13);
    pb[t->tyreadr[i] + MAGGI_TYRE_PKY3] -= tb33 * y7;
    y7b = -(tb33 * p[t->tyreadr[i] + MAGGI_TYRE_PKY3]);
    pb[t->tyreadr[i] + MAGGI_TYRE_LKY] += stiff2b * (p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 *
        t13 * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7));
    tb29 = t13b / t12;
    z2b = tb29 * 2.0;
    t12b = -(tb29 * t13);
    z2b += t12b * z2;
    z2b += t12b * z2;
    /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
     * where straight running is, and exact from w on */
    if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      gyb += y7b;
      y7b = 0.0;
    } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      gyb -= y7b;
      y7b = 0.0;
    } else {
      p2 = p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      t11 = p2 * p2;
      z3 = gy * gy / t11;
      tb27 = y7b * (15.0 + z3 * (-10.0 + 3.0 * z3));
      p2b = tb27 * z3 * 0.125;
      z3b = tb27 * (0.125 * p2);
      tb28 = y7b * (0.125 * p2 * z3);
      z3b += tb28 * (-10.0 + 3.0 * z3);
      z3b += tb28 * z3 * 3.0;
      y7b = 0.0;
      tb26 = z3b / t11;
      gyb += tb26 * gy;
      gyb += tb26 * gy;
      t11b = -(tb26 * z3);
      p2b += t11b * p2;
      p2b += t11b * p2;
      pb[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER] += p2b;
    }
    tb25 = z2b / t10;
    fzb += tb25;
    t10b = -(tb25 * z2);
    pb[t->tyreadr[i] + MAGGI_TYRE_PKY2] += t10b * fz0_2;
    fz0_2b += t10b * p[t->tyreadr[i] + MAGGI_TYRE_PKY2];
    e4b = 0.0;
    if (MAGGI_RE(ay) > 0.0) {
      e5 = e4 * (1.0 - (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
      y5b = eyb;
      eyb = 0.0;
      e5b = 0.0;
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e5) > 1.0) {
        y5b = 0.0;
      } else {
        e5b += y5b;
        y5b = 0.0;
      }
      e4b += e5b * (1.0 - (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
      tb23 = e5b * e4;
      pb[t->tyreadr[i] + MAGGI_TYRE_PEY3] -= tb23;
      pb[t->tyreadr[i] + MAGGI_TYRE_PEY4] -= tb23 * gy;
      gyb -= tb23 * p[t->tyreadr[i] + MAGGI_TYRE_PEY4];
    } else {
      e6 = e4 * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
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
      e4b += e6b * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
      tb24 = e6b * e4;
      pb[t->tyreadr[i] + MAGGI_TYRE_PEY3] += tb24;
      pb[t->tyreadr[i] + MAGGI_TYRE_PEY4] += tb24 * gy;
      gyb += tb24 * p[t->tyreadr[i] + MAGGI_TYRE_PEY4];
    }
    tb22 = e4b * p[t->tyreadr[i] + MAGGI_TYRE_LEY];
    pb[t->tyreadr[i] + MAGGI_TYRE_PEY1] += tb22;
    pb[t->tyreadr[i] + MAGGI_TYRE_PEY2] += tb22 * dfz;
    dfzb += tb22 * p[t->tyreadr[i] + MAGGI_TYRE_PEY2];
    pb[t->tyreadr[i] + MAGGI_TYRE_LEY] += e4b * (p[t->tyreadr[i] + MAGGI_TYRE_PEY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PEY2] * dfz);
    muyb += dyb * fz;
    fzb += dyb * muy;
    tb18 = muyb * p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    tb19 = tb18 * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy * gy);
    pb[t->tyreadr[i] + MAGGI_TYRE_PDY1] += tb19;
    pb[t->tyreadr[i] + MAGGI_TYRE_PDY2] += tb19 * dfz;
    dfzb += tb19 * p[t->tyreadr[i] + MAGGI_TYRE_PDY2];
    tb20 = tb18 * (p[t->tyreadr[i] + MAGGI_TYRE_PDY1] + p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz);
    tb21 = tb20 * gy;
    pb[t->tyreadr[i] + MAGGI_TYRE_PDY3] -= tb21 * gy;
    gyb -= tb21 * p[t->tyreadr[i] + MAGGI_TYRE_PDY3];
    gyb -= tb20 * (p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy);
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUY] += muyb * ((p[t->tyreadr[i] + MAGGI_TYRE_PDY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy *
        gy));
    pb[t->tyreadr[i] + MAGGI_TYRE_PCY1] += cyb * p[t->tyreadr[i] + MAGGI_TYRE_LCY];
    pb[t->tyreadr[i] + MAGGI_TYRE_LCY] += cyb * p[t->tyreadr[i] + MAGGI_TYRE_PCY1];
    ab += ayb;
    shyb += ayb;
    tb17 = shyb * p[t->tyreadr[i] + MAGGI_TYRE_LHY];
    pb[t->tyreadr[i] + MAGGI_TYRE_PHY1] += tb17;
    pb[t->tyreadr[i] + MAGGI_TYRE_PHY2] += tb17 * dfz;
    dfzb += tb17 * p[t->tyreadr[i] + MAGGI_TYRE_PHY2];
    pb[t->tyreadr[i] + MAGGI_TYRE_LHY] += shyb * (p[t->tyreadr[i] + MAGGI_TYRE_PHY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PHY2] * dfz);
    pb[t->tyreadr[i] + MAGGI_TYRE_PHY3] += shyb * gy;
    gyb += shyb * p[t->tyreadr[i] + MAGGI_TYRE_PHY3];
    gammab += gyb * p[t->tyreadr[i] + MAGGI_TYRE_LGAY];
    pb[t->tyreadr[i] + MAGGI_TYRE_LGAY] += gyb * gamma;
    /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
    pb[t->tyreadr[i] + MAGGI_TYRE_LFZO] += fz0_2b * p[t->tyreadr[i]];
    pb[t->tyreadr[i]] += fz0_2b * p[t->tyreadr[i] + MAGGI_TYRE_LFZO];
    stiffb = x1b;
    dxb = x0b * t9;
    t9b = x0b * dx;
    svxb = x0b;
    t8b = t9b * cos(t8);
    cxb = t8b * t7;
    t7b = t8b * cx;
    t6b = t7b * (1.0 / (1.0 + t6 * t6));
    exb = -(t6b * y4);
    y4b = t6b * (1.0 - ex);
    exb += t6b * t5;
    t5b = t6b * ex;
    y4b += t5b * (1.0 / (1.0 + y4 * y4));
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    bxb = y4b * kx;
    kxb = y4b * bx;
    tb14 = svxb * p[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    tb15 = tb14 * p[t->tyreadr[i] + MAGGI_TYRE_LVX];
    fzb += tb15 * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz);
    tb16 = tb15 * fz;
    pb[t->tyreadr[i] + MAGGI_TYRE_PVX1] += tb16;
    pb[t->tyreadr[i] + MAGGI_TYRE_PVX2] += tb16 * dfz;
    dfzb += tb16 * p[t->tyreadr[i] + MAGGI_TYRE_PVX2];
    pb[t->tyreadr[i] + MAGGI_TYRE_LVX] += tb14 * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz));
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUX] += svxb * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LVX]);
    tb13 = bxb / t4;
    stiffb += tb13;
    t4b = -(tb13 * bx);
    cxb += t4b * dx;
    dxb += t4b * cx;
    tb10 = stiffb * p[t->tyreadr[i] + MAGGI_TYRE_LKX];
    tb11 = tb10 * t3;
    fzb += tb11 * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz);
    tb12 = tb11 * fz;
    pb[t->tyreadr[i] + MAGGI_TYRE_PKX1] += tb12;
    pb[t->tyreadr[i] + MAGGI_TYRE_PKX2] += tb12 * dfz;
    dfzb += tb12 * p[t->tyreadr[i] + MAGGI_TYRE_PKX2];
    t3b = tb10 * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] *
        dfz));
    pb[t->tyreadr[i] + MAGGI_TYRE_LKX] += stiffb * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz) * t3);
    t2b = t3b * t3;
    pb[t->tyreadr[i] + MAGGI_TYRE_PKX3] += t2b * dfz;
    dfzb += t2b * p[t->tyreadr[i] + MAGGI_TYRE_PKX3];
    eb = 0.0;
    if (MAGGI_RE(kx) > 0.0) {
      e2 = e * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
      y2b = exb;
      exb = 0.0;
      e2b = 0.0;
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e2) > 1.0) {
        y2b = 0.0;
      } else {
        e2b += y2b;
        y2b = 0.0;
      }
      eb += e2b * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
      pb[t->tyreadr[i] + MAGGI_TYRE_PEX4] -= e2b * e;
    } else {
      e3 = e * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
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
      eb += e3b * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
      pb[t->tyreadr[i] + MAGGI_TYRE_PEX4] += e3b * e;
    }
    tb8 = eb * p[t->tyreadr[i] + MAGGI_TYRE_LEX];
    pb[t->tyreadr[i] + MAGGI_TYRE_PEX1] += tb8;
    pb[t->tyreadr[i] + MAGGI_TYRE_PEX2] += tb8 * dfz;
    dfzb += tb8 * p[t->tyreadr[i] + MAGGI_TYRE_PEX2];
    tb9 = tb8 * dfz;
    pb[t->tyreadr[i] + MAGGI_TYRE_PEX3] += tb9 * dfz;
    dfzb += tb9 * p[t->tyreadr[i] + MAGGI_TYRE_PEX3];
    dfzb += tb8 * (p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz);
    pb[t->tyreadr[i] + MAGGI_TYRE_LEX] += eb * (p[t->tyreadr[i] + MAGGI_TYRE_PEX1] + p[t->tyreadr[i]
        + MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz * dfz);
    muxb = dxb * fz;
    fzb += dxb * mux;
    tb4 = muxb * p[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    tb5 = tb4 * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx * gx);
    pb[t->tyreadr[i] + MAGGI_TYRE_PDX1] += tb5;
    pb[t->tyreadr[i] + MAGGI_TYRE_PDX2] += tb5 * dfz;
    dfzb += tb5 * p[t->tyreadr[i] + MAGGI_TYRE_PDX2];
    tb6 = tb4 * (p[t->tyreadr[i] + MAGGI_TYRE_PDX1] + p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz);
    tb7 = tb6 * gx;
    pb[t->tyreadr[i] + MAGGI_TYRE_PDX3] -= tb7 * gx;
    gxb = -(tb7 * p[t->tyreadr[i] + MAGGI_TYRE_PDX3]);
    gxb -= tb6 * (p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx);
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUX] += muxb * ((p[t->tyreadr[i] + MAGGI_TYRE_PDX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx *
        gx));
    pb[t->tyreadr[i] + MAGGI_TYRE_PCX1] += cxb * p[t->tyreadr[i] + MAGGI_TYRE_LCX];
    pb[t->tyreadr[i] + MAGGI_TYRE_LCX] += cxb * p[t->tyreadr[i] + MAGGI_TYRE_PCX1];
    gammab += gxb * p[t->tyreadr[i] + MAGGI_TYRE_LGAX];
    pb[t->tyreadr[i] + MAGGI_TYRE_LGAX] += gxb * gamma;
    /* Fx0, Kx */
    kappab += kxb;
    tb3 = kxb * p[t->tyreadr[i] + MAGGI_TYRE_LHX];
    pb[t->tyreadr[i] + MAGGI_TYRE_PHX1] += tb3;
    pb[t->tyreadr[i] + MAGGI_TYRE_PHX2] += tb3 * dfz;
    dfzb += tb3 * p[t->tyreadr[i] + MAGGI_TYRE_PHX2];
    pb[t->tyreadr[i] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[i] + MAGGI_TYRE_PHX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfz);
    tb2 = dfzb / fz0;
    fzb += tb2;
    fz0b -= tb2;
    fz0b -= tb2 * dfz;
    pb[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] += r0b;
    pb[t->tyreadr[i] + MAGGI_TYRE_LFZO] += fz0b * p[t->tyreadr[i]];
    pb[t->tyreadr[i]] += fz0b * p[t->tyreadr[i] + MAGGI_TYRE_LFZO];
    slipb[i][3] += fzb;
    slipb[i][2] += gammab;
    slipb[i][1] += ab;
    slipb[i][0] += kappab;
  }
}

/* Rates of the coordinates on which wheels turn at which they roll freely, kappa = 0: with V the velocity of
 * the contact point on the carrier and w the velocity of the wheel by its coordinate
 *   v = V.t / (Re w.u) */
void maggi_rolling_b(const maggi_topo *t, const double p[restrict t->np], double pb[restrict t->np],
                     const double A[restrict t->nbody + 1][9], double Ab[restrict t->nbody + 1][9],
                     const double b[restrict t->nbody][6], double bb[restrict t->nbody][6],
                     const double r[restrict t->npoint][3], double rb[restrict t->npoint][3],
                     const double Z[restrict t->nbody + 1][6], double Zb[restrict t->nbody + 1][6],
                     double spin[restrict t->nwheel], double spinb[restrict t->nwheel])
{
  int adr, body, carrier, i, road;
  double N0, N0b, N1, N2, N2b, T0, T0b, T1, T1b, T2, T2b, a00, a00b, a01, a01b, a02, a02b, along0,
      along0b, along1, along1b, along2, along2b, arm0, arm0b, arm1, arm1b, arm2, arm2b, c0, c0b, c1,
      c1b, c2, c2_2, c2_2b, c2b, fz, fz0, fz0b, fzb, g0, g0b, g2, g2b, h00, h00b, h10, h10b, h11,
      h11b, n2, n2b, n30, n30b, n31, n32, n32b, p2, p2b, p3, p3b, p_road, p_road1, p_road1_2,
      p_road1_2b, p_road1b, p_road2, p_road2b, p_road3, p_road3b, p_road4, p_road4b, p_roadb, r2,
      r2b, ratio, ratiob, re, reb, rhov, rhovb, s, sb, t10, t10b, t11, t11b, t12, t12b, t13, t13b,
      t14, t14b, t15, t15b, t16, t16b, t17, t17b, t2, t2b, t3, t3b, t4, t4b, t5, t5b, t6, t6b, t7,
      t7b, t8, t8b, t9, t9b, tb10, tb11, tb12, tb13, tb14, tb15, tb16, tb17, tb18, tb19, tb2, tb20,
      tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3, tb30, tb31, tb32, tb4, tb5, tb6,
      tb7, tb8, tb9, u0, u0b, u1, u1b, u2, u2b, ua0, ua0b, ua1, ua1b, ua2, ua2b, un0, un0b, un1,
      un1b, un2, un2b, v0, v0b, v1, v1b, v2, v2b, w0, w0b, w1, w1b, w2, w2_2, w2_2b, w2b, wr0, wr0b,
      wr1, wr1b, wr2, wr2b, x, x2, x2b, xb, z0, z0b, z2, z2b;

  for (i = t->nwheel - 1; i >= 0; --i) {
    adr = t->tyreadr[t->wheeltyre[i]];
    body = t->wheelbody[i];
    carrier = t->wheelcarrier[i];
    road = t->wheelroad[i];
    a00 = p[t->wheelaxis[i]];
    a01 = p[t->wheelaxis[i] + 1];
    a02 = p[t->wheelaxis[i] + 2];
    ua0 = A[body][0] * a00 + A[body][1] * a01 + A[body][2] * a02;
    ua1 = A[body][3] * a00 + A[body][4] * a01 + A[body][5] * a02;
    ua2 = A[body][6] * a00 + A[body][7] * a01 + A[body][8] * a02;
    t2 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
    n2 = sqrt(t2);
    u0 = ua0 / n2;
    u1 = ua1 / n2;
    u2 = ua2 / n2;
    g0 = r[t->wheelpoint[i]][0] - r[t->roadpoint[road]][0];
    g2 = r[t->wheelpoint[i]][2] - r[t->roadpoint[road]][2];
    x2 = g0;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      h00 = p_road * x2;
    } else {
      p_road1 = p[t->roadadr[road] + 1];
      t3 = 6.28318530717958647693 * x2 / p_road1;
      t4 = sin(t3);
      p_road2 = p[t->roadadr[road]];
      h00 = p_road2 * t4;
    }
    t5 = u0 * u0 + u1 * u1;
    t6 = u2 * u0 / t5;
    x = g0 + t6 * (g2 - h00);
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road3 = p[t->roadadr[road]];
      h10 = p_road3 * x;
      h11 = p_road3;
    } else {
      p_road1_2 = p[t->roadadr[road] + 1];
      t7 = 6.28318530717958647693 * x / p_road1_2;
      t8 = sin(t7);
      p_road4 = p[t->roadadr[road]];
      h10 = p_road4 * t8;
      t9 = p_road4 * 6.28318530717958647693 / p_road1_2;
      t10 = 6.28318530717958647693 * x / p_road1_2;
      t11 = cos(t10);
      h11 = t9 * t11;
    }
    t12 = 1.0 + h11 * h11;
    s = sqrt(t12);
    n30 = -h11 / s;
    n31 = 0.0;
    n32 = 1.0 / s;
    c2 = u0 * n30 + u1 * n31 + u2 * n32;
    un0 = u1 * n32 - u2 * n31;
    un1 = u2 * n30 - u0 * n32;
    un2 = u0 * n31 - u1 * n30;
    t13 = un0 * un0 + un1 * un1 + un2 * un2;
    w2 = sqrt(t13);
    r2 = ((g0 - x) * n30 + (g2 - h10) * n32) / w2;
    along0 = un0 / w2;
    along1 = un1 / w2;
    along2 = un2 / w2;
    arm0 = r2 * (c2 * u0 - n30) / w2;
    T0 = along0;
    N0 = n30;
    arm1 = r2 * (c2 * u1 - n31) / w2;
    T1 = along1;
    N1 = n31;
    arm2 = r2 * (c2 * u2 - n32) / w2;
    T2 = along2;
    N2 = n32;
    z0 = r2;
    z2 = w2;
    c0 = r[t->wheelpoint[i]][0] + arm0;
    c1 = r[t->wheelpoint[i]][1] + arm1;
    c2_2 = r[t->wheelpoint[i]][2] + arm2;
    wr0 = Z[carrier][3];
    wr1 = Z[carrier][4];
    wr2 = Z[carrier][5];
    w0 = wr1 * c2_2 - wr2 * c1;
    w1 = wr2 * c0 - wr0 * c2_2;
    w2_2 = wr0 * c1 - wr1 * c0;
    v0 = Z[carrier][0] + w0;
    v1 = Z[carrier][1] + w1;
    v2 = Z[carrier][2] + w2_2;
    rhov = -(v0 * N0 + v1 * N1 + v2 * N2) / z2;
    p2 = p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
    p3 = p[adr + MAGGI_TYRE_UNLOADED_RADIUS];
    fz = p2 * (p3 - z0) + p[adr + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
    fz0 = p[adr + MAGGI_TYRE_LFZO] * p[adr];
    ratio = fz / fz0;
    t14 = fz0 / p2;
    t15 = p[adr + MAGGI_TYRE_BREFF] * ratio;
    t16 = atan(t15);
    re = p3 - t14 * (p[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_FREFF] * ratio);
    t17 = re * (b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2);
    tb31 = spinb[i];
    spinb[i] = 0.0;
    tb32 = tb31 / t17;
    v0b = tb32 * T0;
    T0b = tb32 * v0;
    v1b = tb32 * T1;
    T1b = tb32 * v1;
    v2b = tb32 * T2;
    T2b = tb32 * v2;
    t17b = -(tb32 * spin[i]);
    reb = t17b * (b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2);
    tb30 = t17b * re;
    bb[body][3] += tb30 * u0;
    u0b = tb30 * b[body][3];
    bb[body][4] += tb30 * u1;
    u1b = tb30 * b[body][4];
    bb[body][5] += tb30 * u2;
    u2b = tb30 * b[body][5];
    p3b = reb;
    t14b = -(reb * (p[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_FREFF] * ratio));
    tb29 = reb * t14;
    pb[adr + MAGGI_TYRE_DREFF] -= tb29 * t16;
    t16b = -(tb29 * p[adr + MAGGI_TYRE_DREFF]);
    pb[adr + MAGGI_TYRE_FREFF] -= tb29 * ratio;
    ratiob = -(tb29 * p[adr + MAGGI_TYRE_FREFF]);
    t15b = t16b * (1.0 / (1.0 + t15 * t15));
    pb[adr + MAGGI_TYRE_BREFF] += t15b * ratio;
    ratiob += t15b * p[adr + MAGGI_TYRE_BREFF];
    tb28 = t14b / p2;
    fz0b = tb28;
    p2b = -(tb28 * t14);
    tb27 = ratiob / fz0;
    fzb = tb27;
    fz0b -= tb27 * ratio;
    pb[adr + MAGGI_TYRE_LFZO] += fz0b * p[adr];
    pb[adr] += fz0b * p[adr + MAGGI_TYRE_LFZO];
    p2b += fzb * (p3 - z0);
    tb26 = fzb * p2;
    p3b += tb26;
    z0b = -tb26;
    pb[adr + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
    rhovb = fzb * p[adr + MAGGI_TYRE_VERTICAL_DAMPING];
    pb[adr + MAGGI_TYRE_UNLOADED_RADIUS] += p3b;
    pb[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] += p2b;
    tb25 = rhovb / z2;
    v0b -= tb25 * N0;
    N0b = -(tb25 * v0);
    v1b -= tb25 * N1;
    v2b -= tb25 * N2;
    N2b = -(tb25 * v2);
    z2b = -(tb25 * rhov);
    Zb[carrier][2] += v2b;
    w2_2b = v2b;
    Zb[carrier][1] += v1b;
    w1b = v1b;
    Zb[carrier][0] += v0b;
    w0b = v0b;
    wr0b = w2_2b * c1;
    c1b = w2_2b * wr0;
    wr1b = -(w2_2b * c0);
    c0b = -(w2_2b * wr1);
    wr2b = w1b * c0;
    c0b += w1b * wr2;
    wr0b -= w1b * c2_2;
    c2_2b = -(w1b * wr0);
    wr1b += w0b * c2_2;
    c2_2b += w0b * wr1;
    wr2b -= w0b * c1;
    c1b -= w0b * wr2;
    Zb[carrier][5] += wr2b;
    Zb[carrier][4] += wr1b;
    Zb[carrier][3] += wr0b;
    rb[t->wheelpoint[i]][2] += c2_2b;
    arm2b = c2_2b;
    rb[t->wheelpoint[i]][1] += c1b;
    arm1b = c1b;
    rb[t->wheelpoint[i]][0] += c0b;
    arm0b = c0b;
    w2b = z2b;
    r2b = z0b;
    n32b = N2b;
    along2b = T2b;
    tb23 = arm2b / w2;
    r2b += tb23 * (c2 * u2 - n32);
    tb24 = tb23 * r2;
    c2b = tb24 * u2;
    u2b += tb24 * c2;
    n32b -= tb24;
    w2b -= tb23 * arm2;
    along1b = T1b;
    tb21 = arm1b / w2;
    r2b += tb21 * (c2 * u1 - n31);
    tb22 = tb21 * r2;
    c2b += tb22 * u1;
    u1b += tb22 * c2;
    w2b -= tb21 * arm1;
    n30b = N0b;
    along0b = T0b;
    tb19 = arm0b / w2;
    r2b += tb19 * (c2 * u0 - n30);
    tb20 = tb19 * r2;
    c2b += tb20 * u0;
    u0b += tb20 * c2;
    n30b -= tb20;
    w2b -= tb19 * arm0;
    tb18 = along2b / w2;
    un2b = tb18;
    w2b -= tb18 * along2;
    tb17 = along1b / w2;
    un1b = tb17;
    w2b -= tb17 * along1;
    tb16 = along0b / w2;
    un0b = tb16;
    w2b -= tb16 * along0;
    tb13 = r2b / w2;
    tb14 = tb13 * n30;
    g0b = tb14;
    xb = -tb14;
    n30b += tb13 * (g0 - x);
    tb15 = tb13 * n32;
    g2b = tb15;
    h10b = -tb15;
    n32b += tb13 * (g2 - h10);
    w2b -= tb13 * r2;
    t13b = w2b * (1.0 / (2.0 * w2));
    un0b += t13b * un0;
    un0b += t13b * un0;
    un1b += t13b * un1;
    un1b += t13b * un1;
    un2b += t13b * un2;
    un2b += t13b * un2;
    u0b += un2b * n31;
    u1b -= un2b * n30;
    n30b -= un2b * u1;
    u2b += un1b * n30;
    n30b += un1b * u2;
    u0b -= un1b * n32;
    n32b -= un1b * u0;
    u1b += un0b * n32;
    n32b += un0b * u1;
    u2b -= un0b * n31;
    u0b += c2b * n30;
    n30b += c2b * u0;
    u1b += c2b * n31;
    u2b += c2b * n32;
    n32b += c2b * u2;
    tb12 = n32b / s;
    sb = -(tb12 * n32);
    tb11 = n30b / s;
    h11b = -tb11;
    sb -= tb11 * n30;
    t12b = sb * (1.0 / (2.0 * s));
    h11b += t12b * h11;
    h11b += t12b * h11;
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road3 = p[t->roadadr[road]];
      p_road3b = h11b;
      h11b = 0.0;
      p_road3b += h10b * x;
      xb += h10b * p_road3;
      h10b = 0.0;
      pb[t->roadadr[road]] += p_road3b;
    } else {
      p_road1_2 = p[t->roadadr[road] + 1];
      t7 = 6.28318530717958647693 * x / p_road1_2;
      t8 = sin(t7);
      p_road4 = p[t->roadadr[road]];
      t9 = p_road4 * 6.28318530717958647693 / p_road1_2;
      t10 = 6.28318530717958647693 * x / p_road1_2;
      t11 = cos(t10);
      t9b = h11b * t11;
      t11b = h11b * t9;
      h11b = 0.0;
      t10b = -(t11b * sin(t10));
      tb10 = t10b / p_road1_2;
      xb += tb10 * 6.28318530717958647693;
      p_road1_2b = -(tb10 * t10);
      tb9 = t9b / p_road1_2;
      p_road4b = tb9 * 6.28318530717958647693;
      p_road1_2b -= tb9 * t9;
      p_road4b += h10b * t8;
      t8b = h10b * p_road4;
      h10b = 0.0;
      pb[t->roadadr[road]] += p_road4b;
      t7b = t8b * cos(t7);
      tb8 = t7b / p_road1_2;
      xb += tb8 * 6.28318530717958647693;
      p_road1_2b -= tb8 * t7;
      pb[t->roadadr[road] + 1] += p_road1_2b;
    }
    g0b += xb;
    t6b = xb * (g2 - h00);
    tb7 = xb * t6;
    g2b += tb7;
    h00b = -tb7;
    tb6 = t6b / t5;
    u2b += tb6 * u0;
    u0b += tb6 * u2;
    t5b = -(tb6 * t6);
    u0b += t5b * u0;
    u0b += t5b * u0;
    u1b += t5b * u1;
    u1b += t5b * u1;
    x2b = 0.0;
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      p_roadb = h00b * x2;
      x2b += h00b * p_road;
      h00b = 0.0;
      pb[t->roadadr[road]] += p_roadb;
    } else {
      p_road1 = p[t->roadadr[road] + 1];
      t3 = 6.28318530717958647693 * x2 / p_road1;
      t4 = sin(t3);
      p_road2 = p[t->roadadr[road]];
      p_road2b = h00b * t4;
      t4b = h00b * p_road2;
      h00b = 0.0;
      pb[t->roadadr[road]] += p_road2b;
      t3b = t4b * cos(t3);
      tb5 = t3b / p_road1;
      x2b += tb5 * 6.28318530717958647693;
      p_road1b = -(tb5 * t3);
      pb[t->roadadr[road] + 1] += p_road1b;
    }
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
    g0b += x2b;
    rb[t->wheelpoint[i]][2] += g2b;
    rb[t->roadpoint[road]][2] -= g2b;
    rb[t->wheelpoint[i]][0] += g0b;
    rb[t->roadpoint[road]][0] -= g0b;
    tb4 = u2b / n2;
    ua2b = tb4;
    n2b = -(tb4 * u2);
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
    Ab[body][6] += ua2b * a00;
    a00b = ua2b * A[body][6];
    Ab[body][7] += ua2b * a01;
    a01b = ua2b * A[body][7];
    Ab[body][8] += ua2b * a02;
    a02b = ua2b * A[body][8];
    Ab[body][3] += ua1b * a00;
    a00b += ua1b * A[body][3];
    Ab[body][4] += ua1b * a01;
    a01b += ua1b * A[body][4];
    Ab[body][5] += ua1b * a02;
    a02b += ua1b * A[body][5];
    Ab[body][0] += ua0b * a00;
    a00b += ua0b * A[body][0];
    Ab[body][1] += ua0b * a01;
    a01b += ua0b * A[body][1];
    Ab[body][2] += ua0b * a02;
    a02b += ua0b * A[body][2];
    pb[t->wheelaxis[i] + 2] += a02b;
    pb[t->wheelaxis[i] + 1] += a01b;
    pb[t->wheelaxis[i]] += a00b;
  }
}
