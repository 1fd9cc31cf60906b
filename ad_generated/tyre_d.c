/* Tangent of core/kernel/tyre.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* the formula of every tyre at a slip of its own */
void maggi_tyres_d(const maggi_topo *t, const double p[restrict t->np],
                   const double pd[restrict t->np], const double slip[restrict t->ntyre][5],
                   const double slipd[restrict t->ntyre][5], double f[restrict t->ntyre][6],
                   double fd[restrict t->ntyre][6])
{
  int i;
  double a, ad, ar, ard, areq, areqd, at, atd, ateq, ateqd, ay, ayd, br, brd, bt, btd, bx, bxd, by,
      bycy, bycyd, byd, c, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c2, c20, c21, c22, c23,
      c24, c25, c26, c27, c28, c29, c3, c30, c31, c4, c5, c6, c7, c8, c9, ca, cad, cx, cxd, cy, cyd,
      dfz, dfzd, dr, drd, dt, dtd, dv, dvd, dx, dxd, dy, dyd, e, e10, e10d, e11, e11d, e2, e2d, e3,
      e3d, e4, e4d, e5, e5d, e6, e6d, e7, e7d, e8, e8d, e9, e9d, ed, et, etd, ex, exd, ey, eyd, fx,
      fxd, fy, fyd, fz, fz0, fz0_2, fz0_2d, fz0_3, fz0_3d, fz0_3inv, fz0d, fz0inv, fzd, g0, g0d, g1,
      g1d, gamma, gammad, gx, gxd, gy, gyd, gz, gzd, inv, inv2, inv3, kappa, kappad, kx, kxd, mux,
      muxd, muy, muy2, muy2d, muyd, p2, p2d, p3, p3d, p4, p4d, p5, p5d, p6, p6d, p7, p7d, p7inv, r0,
      r0d, ratio, ratiod, s, s2, s2d, sd, shift, shiftd, shy, shyd, slip_i4, slip_i4d, speed,
      speedd, stiff, stiff2, stiff2d, stiff2inv, stiff3, stiff3d, stiff4, stiff4d, stiffd, svx,
      svxd, svy, svyd, t10, t10d, t10inv, t11, t11d, t11inv, t12, t12d, t12inv, t13, t13d, t14,
      t14d, t14inv, t15, t15d, t16, t16d, t17, t17d, t18, t18d, t19, t19d, t2, t20, t20d, t21, t21d,
      t22, t22d, t22inv, t23, t23d, t24, t24d, t25, t25d, t25inv, t26, t26d, t27, t27d, t28, t28d,
      t29, t29d, t2d, t3, t30, t30d, t31, t31d, t32, t32d, t33, t33d, t34, t34d, t35, t35d, t36,
      t36d, t36inv, t37, t37d, t38, t38d, t39, t39d, t3d, t4, t40, t40d, t41, t41d, t42, t42d,
      t42inv, t43, t43d, t44, t44d, t45, t45d, t46, t46d, t47, t47d, t48, t48d, t49, t49d, t4d,
      t4inv, t5, t50, t50d, t51, t51d, t52, t52d, t53, t53d, t53inv, t54, t54d, t55, t55d, t56,
      t56d, t57, t57d, t57inv, t58, t58d, t59, t59d, t5d, t6, t60, t60d, t61, t61d, t62, t62d, t63,
      t63d, t63inv, t64, t64d, t65, t65d, t66, t66d, t67, t67d, t68, t68d, t69, t69d, t6d, t7, t70,
      t70d, t70inv, t71, t71d, t72, t72d, t73, t73d, t74, t74d, t75, t75d, t7d, t8, t8d, t9, t9d,
      way, wayd, x0, x0d, x1, x1d, x2, x2d, x3, x3d, x4, x4d, x5, x5d, y0, y0d, y1, y10, y10d, y11,
      y11d, y12, y12d, y13, y13d, y14, y14d, y15, y15d, y16, y16d, y17, y17d, y1d, y1inv, y2, y2_2,
      y2_2d, y2d, y3, y3_2, y3_2d, y3d, y4, y4_2, y4_2d, y4d, y5, y5d, y6, y6d, y7, y7d, y8, y8d,
      y9, y9d, z0, z0d, z1d, z2, z2d, z3, z3d, z4, z4d;

  for (i = 0; i < t->ntyre; ++i) {
    kappa = slip[i][0];
    kappad = slipd[i][0];
    a = slip[i][1];
    ad = slipd[i][1];
    gamma = slip[i][2];
    gammad = slipd[i][2];
    fz = f[i][2];
    fzd = slipd[i][3];
    fz0 = p[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]];
    fz0d = pd[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]] + p[t->tyreadr[i] +
        MAGGI_TYRE_LFZO] * pd[t->tyreadr[i]];
    r0 = p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS];
    r0d = pd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS];
    dfz = (fz - fz0) / fz0;
    fz0inv = 1.0 / fz0;
    dfzd = (fzd - fz0d - dfz * fz0d) * fz0inv;
    kx = kappa + (p[t->tyreadr[i] + MAGGI_TYRE_PHX1] + p[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LHX];
    /* Fx0, Kx */
    kxd = kappad + ((pd[t->tyreadr[i] + MAGGI_TYRE_PHX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PHX2] *
        dfz + p[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfzd)) * p[t->tyreadr[i] + MAGGI_TYRE_LHX] +
        (p[t->tyreadr[i] + MAGGI_TYRE_PHX1] + p[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfz) *
        pd[t->tyreadr[i] + MAGGI_TYRE_LHX]);
    gx = gamma * p[t->tyreadr[i] + MAGGI_TYRE_LGAX];
    gxd = gammad * p[t->tyreadr[i] + MAGGI_TYRE_LGAX] + gamma * pd[t->tyreadr[i] + MAGGI_TYRE_LGAX];
    cx = p[t->tyreadr[i] + MAGGI_TYRE_PCX1] * p[t->tyreadr[i] + MAGGI_TYRE_LCX];
    cxd = pd[t->tyreadr[i] + MAGGI_TYRE_PCX1] * p[t->tyreadr[i] + MAGGI_TYRE_LCX] + p[t->tyreadr[i]
        + MAGGI_TYRE_PCX1] * pd[t->tyreadr[i] + MAGGI_TYRE_LCX];
    mux = (p[t->tyreadr[i] + MAGGI_TYRE_PDX1] + p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
        p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx * gx) * p[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    muxd = ((pd[t->tyreadr[i] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfzd)) * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx
        * gx) - (p[t->tyreadr[i] + MAGGI_TYRE_PDX1] + p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz) *
        ((pd[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx + p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gxd) * gx
        + p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx * gxd)) * p[t->tyreadr[i] + MAGGI_TYRE_LMUX] +
        (p[t->tyreadr[i] + MAGGI_TYRE_PDX1] + p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
        p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx * gx) * pd[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    dx = mux * fz;
    dxd = muxd * fz + mux * fzd;
    e = (p[t->tyreadr[i] + MAGGI_TYRE_PEX1] + p[t->tyreadr[i] + MAGGI_TYRE_PEX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LEX];
    ed = (pd[t->tyreadr[i] + MAGGI_TYRE_PEX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PEX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PEX2] * dfzd) + ((pd[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfzd) * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz
        * dfzd)) * p[t->tyreadr[i] + MAGGI_TYRE_LEX] + (p[t->tyreadr[i] + MAGGI_TYRE_PEX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz * dfz) *
        pd[t->tyreadr[i] + MAGGI_TYRE_LEX];
    if (MAGGI_RE(kx) > 0.0) {
      e2 = e * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
      e2d = ed * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PEX4]) - e * pd[t->tyreadr[i] +
          MAGGI_TYRE_PEX4];
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e2) > 1.0) {
        y2 = 1.0;
        y2d = 0.0;
      } else {
        y2 = e2;
        y2d = e2d;
      }
      ex = y2;
      exd = y2d;
    } else {
      e3 = e * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
      e3d = ed * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_PEX4]) + e * pd[t->tyreadr[i] +
          MAGGI_TYRE_PEX4];
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e3) > 1.0) {
        y3 = 1.0;
        y3d = 0.0;
      } else {
        y3 = e3;
        y3d = e3d;
      }
      ex = y3;
      exd = y3d;
    }
    t2 = p[t->tyreadr[i] + MAGGI_TYRE_PKX3] * dfz;
    t2d = pd[t->tyreadr[i] + MAGGI_TYRE_PKX3] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PKX3] * dfzd;
    t3 = exp(t2);
    t3d = t3 * t2d;
    stiff = fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz) *
        t3 * p[t->tyreadr[i] + MAGGI_TYRE_LKX];
    stiffd = ((fzd * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz)
        + fz * (pd[t->tyreadr[i] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfzd))) * t3 + fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1]
        + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz) * t3d) * p[t->tyreadr[i] + MAGGI_TYRE_LKX] + fz
        * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz) * t3 *
        pd[t->tyreadr[i] + MAGGI_TYRE_LKX];
    t4 = cx * dx;
    t4d = cxd * dx + cx * dxd;
    bx = stiff / t4;
    t4inv = 1.0 / t4;
    bxd = (stiffd - bx * t4d) * t4inv;
    svx = fz * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVX] * p[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    svxd = ((fzd * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) +
        fz * (pd[t->tyreadr[i] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfzd))) * p[t->tyreadr[i] + MAGGI_TYRE_LVX] + fz *
        (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) *
        pd[t->tyreadr[i] + MAGGI_TYRE_LVX]) * p[t->tyreadr[i] + MAGGI_TYRE_LMUX] + fz *
        (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVX] * pd[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    y4 = bx * kx;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    y4d = bxd * kx + bx * kxd;
    t5 = atan(y4);
    c = 1.0 / (1.0 + y4 * y4);
    t5d = c * y4d;
    t6 = (1.0 - ex) * y4 + ex * t5;
    t6d = -(exd * y4) + (1.0 - ex) * y4d + (exd * t5 + ex * t5d);
    t7 = atan(t6);
    c2 = 1.0 / (1.0 + t6 * t6);
    t7d = c2 * t6d;
    t8 = cx * t7;
    t8d = cxd * t7 + cx * t7d;
    t9 = sin(t8);
    c3 = cos(t8);
    t9d = c3 * t8d;
    x0 = dx * t9 + svx;
    x0d = dxd * t9 + dx * t9d + svxd;
    x1 = stiff;
    x1d = stiffd;
    fz0_2 = p[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]];
    /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
    fz0_2d = pd[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]] + p[t->tyreadr[i] +
        MAGGI_TYRE_LFZO] * pd[t->tyreadr[i]];
    gy = gamma * p[t->tyreadr[i] + MAGGI_TYRE_LGAY];
    gyd = gammad * p[t->tyreadr[i] + MAGGI_TYRE_LGAY] + gamma * pd[t->tyreadr[i] + MAGGI_TYRE_LGAY];
    shy = (p[t->tyreadr[i] + MAGGI_TYRE_PHY1] + p[t->tyreadr[i] + MAGGI_TYRE_PHY2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LHY] + p[t->tyreadr[i] + MAGGI_TYRE_PHY3] * gy;
    shyd = (pd[t->tyreadr[i] + MAGGI_TYRE_PHY1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PHY2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PHY2] * dfzd)) * p[t->tyreadr[i] + MAGGI_TYRE_LHY] +
        (p[t->tyreadr[i] + MAGGI_TYRE_PHY1] + p[t->tyreadr[i] + MAGGI_TYRE_PHY2] * dfz) *
        pd[t->tyreadr[i] + MAGGI_TYRE_LHY] + (pd[t->tyreadr[i] + MAGGI_TYRE_PHY3] * gy +
        p[t->tyreadr[i] + MAGGI_TYRE_PHY3] * gyd);
    ay = a + shy;
    ayd = ad + shyd;
    cy = p[t->tyreadr[i] + MAGGI_TYRE_PCY1] * p[t->tyreadr[i] + MAGGI_TYRE_LCY];
    cyd = pd[t->tyreadr[i] + MAGGI_TYRE_PCY1] * p[t->tyreadr[i] + MAGGI_TYRE_LCY] + p[t->tyreadr[i]
        + MAGGI_TYRE_PCY1] * pd[t->tyreadr[i] + MAGGI_TYRE_LCY];
    muy = (p[t->tyreadr[i] + MAGGI_TYRE_PDY1] + p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
        p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy * gy) * p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    muyd = ((pd[t->tyreadr[i] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfzd)) * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy
        * gy) - (p[t->tyreadr[i] + MAGGI_TYRE_PDY1] + p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz) *
        ((pd[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy + p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gyd) * gy
        + p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy * gyd)) * p[t->tyreadr[i] + MAGGI_TYRE_LMUY] +
        (p[t->tyreadr[i] + MAGGI_TYRE_PDY1] + p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
        p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy * gy) * pd[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    dy = muy * fz;
    dyd = muyd * fz + muy * fzd;
    e4 = (p[t->tyreadr[i] + MAGGI_TYRE_PEY1] + p[t->tyreadr[i] + MAGGI_TYRE_PEY2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LEY];
    e4d = (pd[t->tyreadr[i] + MAGGI_TYRE_PEY1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PEY2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PEY2] * dfzd)) * p[t->tyreadr[i] + MAGGI_TYRE_LEY] +
        (p[t->tyreadr[i] + MAGGI_TYRE_PEY1] + p[t->tyreadr[i] + MAGGI_TYRE_PEY2] * dfz) *
        pd[t->tyreadr[i] + MAGGI_TYRE_LEY];
    if (MAGGI_RE(ay) > 0.0) {
      e5 = e4 * (1.0 - (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
      e5d = e4d * (1.0 - (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy)) - e4 * (pd[t->tyreadr[i] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] * gyd));
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e5) > 1.0) {
        y5 = 1.0;
        y5d = 0.0;
      } else {
        y5 = e5;
        y5d = e5d;
      }
      ey = y5;
      eyd = y5d;
    } else {
      e6 = e4 * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
      e6d = e4d * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy)) + e4 * (pd[t->tyreadr[i] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] * gyd));
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e6) > 1.0) {
        y6 = 1.0;
        y6d = 0.0;
      } else {
        y6 = e6;
        y6d = e6d;
      }
      ey = y6;
      eyd = y6d;
    }
    t10 = p[t->tyreadr[i] + MAGGI_TYRE_PKY2] * fz0_2;
    t10d = pd[t->tyreadr[i] + MAGGI_TYRE_PKY2] * fz0_2 + p[t->tyreadr[i] + MAGGI_TYRE_PKY2] *
        fz0_2d;
    z2 = fz / t10;
    t10inv = 1.0 / t10;
    z2d = (fzd - z2 * t10d) * t10inv;
    /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
     * where straight running is, and exact from w on */
    if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y7 = gy;
      y7d = gyd;
    } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y7 = -gy;
      y7d = -gyd;
    } else {
      p2 = p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      p2d = pd[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      t11 = p2 * p2;
      t11d = p2d * p2 + p2 * p2d;
      z3 = gy * gy / t11;
      t11inv = 1.0 / t11;
      z3d = (gyd * gy + gy * gyd - z3 * t11d) * t11inv;
      y7 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
      y7d = (0.125 * p2d * z3 + 0.125 * p2 * z3d) * (15.0 + z3 * (-10.0 + 3.0 * z3)) + 0.125 * p2 *
          z3 * (z3d * (-10.0 + 3.0 * z3) + z3 * (3.0 * z3d));
    }
    t12 = 1.0 + z2 * z2;
    t12d = z2d * z2 + z2 * z2d;
    t13 = 2.0 * z2 / t12;
    t12inv = 1.0 / t12;
    t13d = (2.0 * z2d - t13 * t12d) * t12inv;
    stiff2 = p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 - p[t->tyreadr[i] +
        MAGGI_TYRE_PKY3] * y7) * p[t->tyreadr[i] + MAGGI_TYRE_LKY];
    stiff2d = (((pd[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 + p[t->tyreadr[i] + MAGGI_TYRE_PKY1] *
        fz0_2d) * t13 + p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13d) * (1.0 - p[t->tyreadr[i]
        + MAGGI_TYRE_PKY3] * y7) - p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13 *
        (pd[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7 + p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7d)) *
        p[t->tyreadr[i] + MAGGI_TYRE_LKY] + p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0
        - p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7) * pd[t->tyreadr[i] + MAGGI_TYRE_LKY];
    t14 = cy * dy;
    t14d = cyd * dy + cy * dyd;
    by = stiff2 / t14;
    t14inv = 1.0 / t14;
    byd = (stiff2d - by * t14d) * t14inv;
    svy = fz * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfz) * gy) * p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    svyd = (fzd * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfz) * gy) + fz * ((pd[t->tyreadr[i] + MAGGI_TYRE_PVY1] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfzd)) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY2] * dfz) * pd[t->tyreadr[i] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[i] +
        MAGGI_TYRE_PVY3] + (pd[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfzd)) * gy + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfz) * gyd))) * p[t->tyreadr[i] + MAGGI_TYRE_LMUY] + fz *
        ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfz) * gy) * pd[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    y8 = by * ay;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    y8d = byd * ay + by * ayd;
    t15 = atan(y8);
    c4 = 1.0 / (1.0 + y8 * y8);
    t15d = c4 * y8d;
    t16 = (1.0 - ey) * y8 + ey * t15;
    t16d = -(eyd * y8) + (1.0 - ey) * y8d + (eyd * t15 + ey * t15d);
    t17 = atan(t16);
    c5 = 1.0 / (1.0 + t16 * t16);
    t17d = c5 * t16d;
    t18 = cy * t17;
    t18d = cyd * t17 + cy * t17d;
    t19 = sin(t18);
    c6 = cos(t18);
    t19d = c6 * t18d;
    y0 = dy * t19 + svy;
    y0d = dyd * t19 + dy * t19d + svyd;
    y1 = stiff2;
    y1d = stiff2d;
    y2_2 = muy;
    y2_2d = muyd;
    y3_2 = by * cy;
    y3_2d = byd * cy + by * cyd;
    t20 = svy / stiff2;
    stiff2inv = 1.0 / stiff2;
    t20d = (svyd - t20 * stiff2d) * stiff2inv;
    y4_2 = shy + t20;
    y4_2d = shyd + t20d;
    muy2 = y2_2;
    muy2d = y2_2d;
    x2 = p[t->tyreadr[i] + MAGGI_TYRE_RBY2] * (a - p[t->tyreadr[i] + MAGGI_TYRE_RBY3]);
    /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
    x2d = pd[t->tyreadr[i] + MAGGI_TYRE_RBY2] * (a - p[t->tyreadr[i] + MAGGI_TYRE_RBY3]) +
        p[t->tyreadr[i] + MAGGI_TYRE_RBY2] * (ad - pd[t->tyreadr[i] + MAGGI_TYRE_RBY3]);
    t21 = 1.0 + x2 * x2;
    t21d = x2d * x2 + x2 * x2d;
    t22 = sqrt(t21);
    c7 = 1.0 / (2.0 * t22);
    t22d = c7 * t21d;
    t23 = 1.0 / t22;
    t22inv = 1.0 / t22;
    t23d = -(t23 * t22d * t22inv);
    stiff3 = p[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23 * p[t->tyreadr[i] + MAGGI_TYRE_LYKA];
    stiff3d = (pd[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23 + p[t->tyreadr[i] + MAGGI_TYRE_RBY1] *
        t23d) * p[t->tyreadr[i] + MAGGI_TYRE_LYKA] + p[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23 *
        pd[t->tyreadr[i] + MAGGI_TYRE_LYKA];
    e8 = p[t->tyreadr[i] + MAGGI_TYRE_REY1] + p[t->tyreadr[i] + MAGGI_TYRE_REY2] * dfz;
    e8d = pd[t->tyreadr[i] + MAGGI_TYRE_REY1] + (pd[t->tyreadr[i] + MAGGI_TYRE_REY2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_REY2] * dfzd);
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e8) > 1.0) {
      y9 = 1.0;
      y9d = 0.0;
    } else {
      y9 = e8;
      y9d = e8d;
    }
    e7 = y9;
    e7d = y9d;
    s2 = p[t->tyreadr[i] + MAGGI_TYRE_RHY1] + p[t->tyreadr[i] + MAGGI_TYRE_RHY2] * dfz;
    s2d = pd[t->tyreadr[i] + MAGGI_TYRE_RHY1] + (pd[t->tyreadr[i] + MAGGI_TYRE_RHY2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_RHY2] * dfzd);
    x3 = p[t->tyreadr[i] + MAGGI_TYRE_RVY4] * a;
    x3d = pd[t->tyreadr[i] + MAGGI_TYRE_RVY4] * a + p[t->tyreadr[i] + MAGGI_TYRE_RVY4] * ad;
    t24 = 1.0 + x3 * x3;
    t24d = x3d * x3 + x3 * x3d;
    t25 = sqrt(t24);
    c8 = 1.0 / (2.0 * t25);
    t25d = c8 * t24d;
    t26 = 1.0 / t25;
    t25inv = 1.0 / t25;
    t26d = -(t26 * t25d * t25inv);
    dv = muy2 * fz * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz
        + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma) * t26;
    dvd = ((muy2d * fz + muy2 * fzd) * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] +
        MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma) + muy2 * fz *
        (pd[t->tyreadr[i] + MAGGI_TYRE_RVY1] + (pd[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfzd) + (pd[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma +
        p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gammad))) * t26 + muy2 * fz * (p[t->tyreadr[i] +
        MAGGI_TYRE_RVY1] + p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_RVY3] * gamma) * t26d;
    y10 = stiff3 * (kappa + s2);
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    y10d = stiff3d * (kappa + s2) + stiff3 * (kappad + s2d);
    y11 = stiff3 * s2;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    y11d = stiff3d * s2 + stiff3 * s2d;
    t27 = atan(y10);
    c9 = 1.0 / (1.0 + y10 * y10);
    t27d = c9 * y10d;
    t28 = (1.0 - e7) * y10 + e7 * t27;
    t28d = -(e7d * y10) + (1.0 - e7) * y10d + (e7d * t27 + e7 * t27d);
    t29 = atan(t28);
    c10 = 1.0 / (1.0 + t28 * t28);
    t29d = c10 * t28d;
    p3 = p[t->tyreadr[i] + MAGGI_TYRE_RCY1];
    p3d = pd[t->tyreadr[i] + MAGGI_TYRE_RCY1];
    t30 = p3 * t29;
    t30d = p3d * t29 + p3 * t29d;
    t31 = cos(t30);
    c11 = -sin(t30);
    t31d = c11 * t30d;
    t32 = atan(y11);
    c12 = 1.0 / (1.0 + y11 * y11);
    t32d = c12 * y11d;
    t33 = (1.0 - e7) * y11 + e7 * t32;
    t33d = -(e7d * y11) + (1.0 - e7) * y11d + (e7d * t32 + e7 * t32d);
    t34 = atan(t33);
    c13 = 1.0 / (1.0 + t33 * t33);
    t34d = c13 * t33d;
    t35 = p3 * t34;
    t35d = p3d * t34 + p3 * t34d;
    t36 = cos(t35);
    c14 = -sin(t35);
    t36d = c14 * t35d;
    g0 = t31 / t36;
    t36inv = 1.0 / t36;
    g0d = (t31d - g0 * t36d) * t36inv;
    t37 = p[t->tyreadr[i] + MAGGI_TYRE_RVY6] * kappa;
    t37d = pd[t->tyreadr[i] + MAGGI_TYRE_RVY6] * kappa + p[t->tyreadr[i] + MAGGI_TYRE_RVY6] *
        kappad;
    t38 = atan(t37);
    c15 = 1.0 / (1.0 + t37 * t37);
    t38d = c15 * t37d;
    t39 = p[t->tyreadr[i] + MAGGI_TYRE_RVY5] * t38;
    t39d = pd[t->tyreadr[i] + MAGGI_TYRE_RVY5] * t38 + p[t->tyreadr[i] + MAGGI_TYRE_RVY5] * t38d;
    t40 = sin(t39);
    c16 = cos(t39);
    t40d = c16 * t39d;
    g1 = dv * t40 * p[t->tyreadr[i] + MAGGI_TYRE_LVYKA];
    g1d = (dvd * t40 + dv * t40d) * p[t->tyreadr[i] + MAGGI_TYRE_LVYKA] + dv * t40 *
        pd[t->tyreadr[i] + MAGGI_TYRE_LVYKA];
    x4 = p[t->tyreadr[i] + MAGGI_TYRE_RBX2] * kappa;
    /* Gxa = Fx / Fx0 */
    x4d = pd[t->tyreadr[i] + MAGGI_TYRE_RBX2] * kappa + p[t->tyreadr[i] + MAGGI_TYRE_RBX2] * kappad;
    t41 = 1.0 + x4 * x4;
    t41d = x4d * x4 + x4 * x4d;
    t42 = sqrt(t41);
    c17 = 1.0 / (2.0 * t42);
    t42d = c17 * t41d;
    t43 = 1.0 / t42;
    t42inv = 1.0 / t42;
    t43d = -(t43 * t42d * t42inv);
    stiff4 = p[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43 * p[t->tyreadr[i] + MAGGI_TYRE_LXAL];
    stiff4d = (pd[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43 + p[t->tyreadr[i] + MAGGI_TYRE_RBX1] *
        t43d) * p[t->tyreadr[i] + MAGGI_TYRE_LXAL] + p[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43 *
        pd[t->tyreadr[i] + MAGGI_TYRE_LXAL];
    e10 = p[t->tyreadr[i] + MAGGI_TYRE_REX1] + p[t->tyreadr[i] + MAGGI_TYRE_REX2] * dfz;
    e10d = pd[t->tyreadr[i] + MAGGI_TYRE_REX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_REX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_REX2] * dfzd);
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e10) > 1.0) {
      y12 = 1.0;
      y12d = 0.0;
    } else {
      y12 = e10;
      y12d = e10d;
    }
    e9 = y12;
    e9d = y12d;
    p4 = p[t->tyreadr[i] + MAGGI_TYRE_RHX1];
    p4d = pd[t->tyreadr[i] + MAGGI_TYRE_RHX1];
    y13 = stiff4 * (a + p4);
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    y13d = stiff4d * (a + p4) + stiff4 * (ad + p4d);
    y14 = stiff4 * p4;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    y14d = stiff4d * p4 + stiff4 * p4d;
    t44 = atan(y13);
    c18 = 1.0 / (1.0 + y13 * y13);
    t44d = c18 * y13d;
    t45 = (1.0 - e9) * y13 + e9 * t44;
    t45d = -(e9d * y13) + (1.0 - e9) * y13d + (e9d * t44 + e9 * t44d);
    t46 = atan(t45);
    c19 = 1.0 / (1.0 + t45 * t45);
    t46d = c19 * t45d;
    p5 = p[t->tyreadr[i] + MAGGI_TYRE_RCX1];
    p5d = pd[t->tyreadr[i] + MAGGI_TYRE_RCX1];
    t47 = p5 * t46;
    t47d = p5d * t46 + p5 * t46d;
    t48 = cos(t47);
    c20 = -sin(t47);
    t48d = c20 * t47d;
    t49 = atan(y14);
    c21 = 1.0 / (1.0 + y14 * y14);
    t49d = c21 * y14d;
    t50 = (1.0 - e9) * y14 + e9 * t49;
    t50d = -(e9d * y14) + (1.0 - e9) * y14d + (e9d * t49 + e9 * t49d);
    t51 = atan(t50);
    c22 = 1.0 / (1.0 + t50 * t50);
    t51d = c22 * t50d;
    t52 = p5 * t51;
    t52d = p5d * t51 + p5 * t51d;
    t53 = cos(t52);
    c23 = -sin(t52);
    t53d = c23 * t52d;
    t54 = t48 / t53;
    t53inv = 1.0 / t53;
    t54d = (t48d - t54 * t53d) * t53inv;
    fx = f[i][0];
    fxd = x0d * t54 + x0 * t54d;
    fy = f[i][1];
    fyd = g0d * y0 + g0 * y0d + g1d;
    ratio = x1 * kappa / y1;
    y1inv = 1.0 / y1;
    ratiod = (x1d * kappa + x1 * kappad - ratio * y1d) * y1inv;
    bycy = y3_2;
    bycyd = y3_2d;
    shift = y4_2;
    shiftd = y4_2d;
    fz0_3 = p[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]];
    /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
     *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
    fz0_3d = pd[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]] + p[t->tyreadr[i] +
        MAGGI_TYRE_LFZO] * pd[t->tyreadr[i]];
    gz = gamma * p[t->tyreadr[i] + MAGGI_TYRE_LGAZ];
    gzd = gammad * p[t->tyreadr[i] + MAGGI_TYRE_LGAZ] + gamma * pd[t->tyreadr[i] + MAGGI_TYRE_LGAZ];
    at = a + p[t->tyreadr[i] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QHZ2] * dfz +
        (p[t->tyreadr[i] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfz) * gz;
    atd = ad + pd[t->tyreadr[i] + MAGGI_TYRE_QHZ1] + (pd[t->tyreadr[i] + MAGGI_TYRE_QHZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QHZ2] * dfzd) + ((pd[t->tyreadr[i] + MAGGI_TYRE_QHZ3] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfzd)) *
        gz + (p[t->tyreadr[i] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfz) * gzd);
    ar = a + shift;
    ard = ad + shiftd;
    t55 = at * at + ratio * ratio + 1e-24;
    t55d = atd * at + at * atd + (ratiod * ratio + ratio * ratiod);
    ateq = sqrt(t55);
    c24 = 1.0 / (2.0 * ateq);
    ateqd = c24 * t55d;
    t56 = ar * ar + ratio * ratio + 1e-24;
    t56d = ard * ar + ar * ard + (ratiod * ratio + ratio * ratiod);
    areq = sqrt(t56);
    c25 = 1.0 / (2.0 * areq);
    areqd = c25 * t56d;
    /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
     * where straight running is, and exact from w on */
    if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y15 = gz;
      y15d = gzd;
    } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y15 = -gz;
      y15d = -gzd;
    } else {
      p6 = p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      p6d = pd[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      t57 = p6 * p6;
      t57d = p6d * p6 + p6 * p6d;
      z4 = gz * gz / t57;
      t57inv = 1.0 / t57;
      z4d = (gzd * gz + gz * gzd - z4 * t57d) * t57inv;
      y15 = 0.125 * p6 * z4 * (15.0 + z4 * (-10.0 + 3.0 * z4));
      y15d = (0.125 * p6d * z4 + 0.125 * p6 * z4d) * (15.0 + z4 * (-10.0 + 3.0 * z4)) + 0.125 * p6 *
          z4 * (z4d * (-10.0 + 3.0 * z4) + z4 * (3.0 * z4d));
    }
    bt = (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4]
        * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15) * p[t->tyreadr[i] + MAGGI_TYRE_LKY] /
        p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    inv = 1.0 / p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    btd = (((pd[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + (pd[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfzd) + ((pd[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfzd) * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz
        * dfzd)) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] +
        MAGGI_TYRE_QBZ5] * y15) + (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i] +
        MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (pd[t->tyreadr[i]
        + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gzd + (pd[t->tyreadr[i] +
        MAGGI_TYRE_QBZ5] * y15 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15d))) * p[t->tyreadr[i] +
        MAGGI_TYRE_LKY] + (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] *
        dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 + p[t->tyreadr[i] +
        MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15) * pd[t->tyreadr[i] +
        MAGGI_TYRE_LKY] - bt * pd[t->tyreadr[i] + MAGGI_TYRE_LMUY]) * inv;
    t58 = p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_3;
    fz0_3inv = 1.0 / fz0_3;
    t58d = (pd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] - t58 * fz0_3d) * fz0_3inv;
    dt = fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) * (1.0
        + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) *
        t58 * p[t->tyreadr[i] + MAGGI_TYRE_LTR];
    dtd = (((fzd * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) +
        fz * (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfzd))) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] *
        gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) + fz * (p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gzd + ((pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gzd) * gz + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ4] * gz * gzd))) * t58 + fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) * t58d) * p[t->tyreadr[i] + MAGGI_TYRE_LTR] +
        fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) * (1.0
        + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) *
        t58 * pd[t->tyreadr[i] + MAGGI_TYRE_LTR];
    t59 = bt * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * at;
    t59d = (btd * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] + bt * pd[t->tyreadr[i] + MAGGI_TYRE_QCZ1]) *
        at + bt * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * atd;
    t60 = atan(t59);
    c26 = 1.0 / (1.0 + t59 * t59);
    t60d = c26 * t59d;
    e11 = (p[t->tyreadr[i] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz * dfz) * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_QEZ4]
        + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t60);
    e11d = (pd[t->tyreadr[i] + MAGGI_TYRE_QEZ1] + (pd[t->tyreadr[i] + MAGGI_TYRE_QEZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QEZ2] * dfzd) + ((pd[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfzd) * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz
        * dfzd)) * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] *
        gz) * 0.63661977236758134308 * t60) + (p[t->tyreadr[i] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[i]
        + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz * dfz) *
        ((pd[t->tyreadr[i] + MAGGI_TYRE_QEZ4] + (pd[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gz +
        p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gzd)) * 0.63661977236758134308 * t60 + (p[t->tyreadr[i]
        + MAGGI_TYRE_QEZ4] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
        t60d);
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e11) > 1.0) {
      y16 = 1.0;
      y16d = 0.0;
    } else {
      y16 = e11;
      y16d = e11d;
    }
    et = y16;
    etd = y16d;
    p7 = p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    p7d = pd[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    t61 = p[t->tyreadr[i] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[i] + MAGGI_TYRE_LKY] / p7;
    p7inv = 1.0 / p7;
    t61d = (pd[t->tyreadr[i] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[i] + MAGGI_TYRE_LKY] +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ9] * pd[t->tyreadr[i] + MAGGI_TYRE_LKY] - t61 * p7d) *
        p7inv;
    br = t61 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ10] * bycy;
    brd = t61d + (pd[t->tyreadr[i] + MAGGI_TYRE_QBZ10] * bycy + p[t->tyreadr[i] + MAGGI_TYRE_QBZ10]
        * bycyd);
    dr = fz * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] * p7;
    drd = ((fzd * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfz) * gz) + fz * ((pd[t->tyreadr[i] + MAGGI_TYRE_QDZ6] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfzd)) *
        p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ7] * dfz) * pd[t->tyreadr[i] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfzd)) * gz + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfz) * gzd))) * p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] + fz *
        ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfz) * gz) * pd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS]) * p7 + fz *
        ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] * p7d;
    t62 = 1.0 + a * a;
    t62d = ad * a + a * ad;
    t63 = sqrt(t62);
    c27 = 1.0 / (2.0 * t63);
    t63d = c27 * t62d;
    ca = 1.0 / t63;
    t63inv = 1.0 / t63;
    cad = -(ca * t63d * t63inv);
    y17 = bt * ateq;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    y17d = btd * ateq + bt * ateqd;
    t64 = atan(y17);
    c28 = 1.0 / (1.0 + y17 * y17);
    t64d = c28 * y17d;
    t65 = (1.0 - et) * y17 + et * t64;
    t65d = -(etd * y17) + (1.0 - et) * y17d + (etd * t64 + et * t64d);
    t66 = atan(t65);
    c29 = 1.0 / (1.0 + t65 * t65);
    t66d = c29 * t65d;
    t67 = p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * t66;
    t67d = pd[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * t66 + p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * t66d;
    t68 = cos(t67);
    c30 = -sin(t67);
    t68d = c30 * t67d;
    z0 = dt * t68 * ca;
    z0d = (dtd * t68 + dt * t68d) * ca + dt * t68 * cad;
    x5 = br * areq;
    x5d = brd * areq + br * areqd;
    t69 = 1.0 + x5 * x5;
    t69d = x5d * x5 + x5 * x5d;
    t70 = sqrt(t69);
    c31 = 1.0 / (2.0 * t70);
    t70d = c31 * t69d;
    t71 = 1.0 / t70;
    t70inv = 1.0 / t70;
    t71d = -(t71 * t70d * t70inv);
    z1d = (drd * t71 + dr * t71d) * ca + dr * t71 * cad;
    t72 = p[t->tyreadr[i] + MAGGI_TYRE_SSZ2] * fy / fz0;
    t72d = (pd[t->tyreadr[i] + MAGGI_TYRE_SSZ2] * fy + p[t->tyreadr[i] + MAGGI_TYRE_SSZ2] * fyd -
        t72 * fz0d) * fz0inv;
    s = (p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] +
        p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0 * p[t->tyreadr[i] + MAGGI_TYRE_LS];
    sd = ((pd[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72d + ((pd[t->tyreadr[i] + MAGGI_TYRE_SSZ3] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfzd)) *
        gamma + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) *
        gammad)) * r0 + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 + (p[t->tyreadr[i] +
        MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0d) *
        p[t->tyreadr[i] + MAGGI_TYRE_LS] + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 +
        (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma) *
        r0 * pd[t->tyreadr[i] + MAGGI_TYRE_LS];
    slip_i4 = slip[i][4];
    slip_i4d = slipd[i][4];
    t73 = slip_i4 / p[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED];
    inv2 = 1.0 / p[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED];
    t73d = (slip_i4d - t73 * pd[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED]) * inv2;
    way = tanh(t73);
    wayd = (1.0 - way * way) * t73d;
    speed = slip_i4 / p[t->tyreadr[i] + MAGGI_TYRE_LONGVL];
    inv3 = 1.0 / p[t->tyreadr[i] + MAGGI_TYRE_LONGVL];
    speedd = (slip_i4d - speed * pd[t->tyreadr[i] + MAGGI_TYRE_LONGVL]) * inv3;
    fd[i][0] = fxd;
    fd[i][1] = fyd;
    fd[i][2] = fzd;
    t74 = p[t->tyreadr[i] + MAGGI_TYRE_QSX3] * fy / fz0;
    t74d = (pd[t->tyreadr[i] + MAGGI_TYRE_QSX3] * fy + p[t->tyreadr[i] + MAGGI_TYRE_QSX3] * fyd -
        t74 * fz0d) * fz0inv;
    fd[i][3] = (r0d * fz + r0 * fzd) * (p[t->tyreadr[i] + MAGGI_TYRE_QSX1] * p[t->tyreadr[i] +
        MAGGI_TYRE_LVMX] + (-p[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma + t74) * p[t->tyreadr[i] +
        MAGGI_TYRE_LMX]) + r0 * fz * (pd[t->tyreadr[i] + MAGGI_TYRE_QSX1] * p[t->tyreadr[i] +
        MAGGI_TYRE_LVMX] + p[t->tyreadr[i] + MAGGI_TYRE_QSX1] * pd[t->tyreadr[i] + MAGGI_TYRE_LVMX]
        + ((-(pd[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma) - p[t->tyreadr[i] + MAGGI_TYRE_QSX2] *
        gammad + t74d) * p[t->tyreadr[i] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[i] + MAGGI_TYRE_QSX2] *
        gamma + t74) * pd[t->tyreadr[i] + MAGGI_TYRE_LMX]));
    t75 = p[t->tyreadr[i] + MAGGI_TYRE_QSY2] * fx / fz0;
    t75d = (pd[t->tyreadr[i] + MAGGI_TYRE_QSY2] * fx + p[t->tyreadr[i] + MAGGI_TYRE_QSY2] * fxd -
        t75 * fz0d) * fz0inv;
    fd[i][4] = (((-(wayd * r0) - way * r0d) * fz + -way * r0 * fzd) * (p[t->tyreadr[i] +
        MAGGI_TYRE_QSY1] + t75 + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way * speed + p[t->tyreadr[i]
        + MAGGI_TYRE_QSY4] * speed * speed * speed * speed) + -way * r0 * fz * (pd[t->tyreadr[i] +
        MAGGI_TYRE_QSY1] + t75d + ((pd[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way + p[t->tyreadr[i] +
        MAGGI_TYRE_QSY3] * wayd) * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way * speedd) +
        ((((pd[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] *
        speedd) * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speedd) * speed +
        p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speedd) * speed + p[t->tyreadr[i] +
        MAGGI_TYRE_QSY4] * speed * speed * speed * speedd))) * p[t->tyreadr[i] + MAGGI_TYRE_LMY] +
        -way * r0 * fz * (p[t->tyreadr[i] + MAGGI_TYRE_QSY1] + t75 + p[t->tyreadr[i] +
        MAGGI_TYRE_QSY3] * way * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed
        * speed) * pd[t->tyreadr[i] + MAGGI_TYRE_LMY];
    fd[i][5] = -(z0d * (fy - g1)) - z0 * (fyd - g1d) + z1d + (sd * fx + s * fxd);
  }
}

/* Rates of the coordinates on which wheels turn at which they roll freely, kappa = 0: with V the velocity of
 * the contact point on the carrier and w the velocity of the wheel by its coordinate
 *   v = V.t / (Re w.u) */
void maggi_rolling_d(const maggi_topo *t, const double p[restrict t->np],
                     const double pd[restrict t->np], const double A[restrict t->nbody + 1][9],
                     const double Ad[restrict t->nbody + 1][9],
                     const double b[restrict t->nbody][6], const double bd[restrict t->nbody][6],
                     const double r[restrict t->npoint][3], const double rd[restrict t->npoint][3],
                     const double Z[restrict t->nbody + 1][6],
                     const double Zd[restrict t->nbody + 1][6], double spin[restrict t->nwheel],
                     double spind[restrict t->nwheel])
{
  int adr, body, carrier, i, road;
  double N0, N0d, N1, N2, N2d, T0, T0d, T1, T1d, T2, T2d, a00, a00d, a01, a01d, a02, a02d, along0,
      along0d, along1, along1d, along2, along2d, arm0, arm0d, arm1, arm1d, arm2, arm2d, c0, c0d, c1,
      c1d, c2, c2_2, c2_2d, c2d, c3, c4, c5, c6, c7, c8, c9, fz, fz0, fz0d, fz0inv, fzd, g0, g0d,
      g2, g2d, h00, h00d, h10, h10d, h11, h11d, n2, n2d, n2inv, n30, n30d, n31, n32, n32d, p2, p2d,
      p2inv, p3, p3d, p_road, p_road1, p_road1_2, p_road1_2d, p_road1_2inv, p_road1d, p_road1inv,
      p_road2, p_road2d, p_road3, p_road3d, p_road4, p_road4d, p_roadd, r2, r2d, ratio, ratiod, re,
      red, rhov, rhovd, s, sd, sinv, t10, t10d, t11, t11d, t12, t12d, t13, t13d, t14, t14d, t15,
      t15d, t16, t16d, t17, t17d, t17inv, t2, t2d, t3, t3d, t4, t4d, t5, t5d, t5inv, t6, t6d, t7,
      t7d, t8, t8d, t9, t9d, u0, u0d, u1, u1d, u2, u2d, ua0, ua0d, ua1, ua1d, ua2, ua2d, un0, un0d,
      un1, un1d, un2, un2d, v0, v0d, v1, v1d, v2, v2d, w0, w0d, w1, w1d, w2, w2_2, w2_2d, w2d,
      w2inv, wr0, wr0d, wr1, wr1d, wr2, wr2d, x, x2, x2d, xd, z0, z0d, z2, z2d, z2inv;

  for (i = 0; i < t->nwheel; ++i) {
    adr = t->tyreadr[t->wheeltyre[i]];
    body = t->wheelbody[i];
    carrier = t->wheelcarrier[i];
    road = t->wheelroad[i];
    a00 = p[t->wheelaxis[i]];
    a00d = pd[t->wheelaxis[i]];
    a01 = p[t->wheelaxis[i] + 1];
    a01d = pd[t->wheelaxis[i] + 1];
    a02 = p[t->wheelaxis[i] + 2];
    a02d = pd[t->wheelaxis[i] + 2];
    ua0 = A[body][0] * a00 + A[body][1] * a01 + A[body][2] * a02;
    ua0d = Ad[body][0] * a00 + A[body][0] * a00d + (Ad[body][1] * a01 + A[body][1] * a01d) +
        (Ad[body][2] * a02 + A[body][2] * a02d);
    ua1 = A[body][3] * a00 + A[body][4] * a01 + A[body][5] * a02;
    ua1d = Ad[body][3] * a00 + A[body][3] * a00d + (Ad[body][4] * a01 + A[body][4] * a01d) +
        (Ad[body][5] * a02 + A[body][5] * a02d);
    ua2 = A[body][6] * a00 + A[body][7] * a01 + A[body][8] * a02;
    ua2d = Ad[body][6] * a00 + A[body][6] * a00d + (Ad[body][7] * a01 + A[body][7] * a01d) +
        (Ad[body][8] * a02 + A[body][8] * a02d);
    t2 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
    t2d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
    n2 = sqrt(t2);
    c3 = 1.0 / (2.0 * n2);
    n2d = c3 * t2d;
    u0 = ua0 / n2;
    n2inv = 1.0 / n2;
    u0d = (ua0d - u0 * n2d) * n2inv;
    u1 = ua1 / n2;
    u1d = (ua1d - u1 * n2d) * n2inv;
    u2 = ua2 / n2;
    u2d = (ua2d - u2 * n2d) * n2inv;
    g0 = r[t->wheelpoint[i]][0] - r[t->roadpoint[road]][0];
    g0d = rd[t->wheelpoint[i]][0] - rd[t->roadpoint[road]][0];
    g2 = r[t->wheelpoint[i]][2] - r[t->roadpoint[road]][2];
    g2d = rd[t->wheelpoint[i]][2] - rd[t->roadpoint[road]][2];
    x2 = g0;
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
    x2d = g0d;
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      p_roadd = pd[t->roadadr[road]];
      h00 = p_road * x2;
      h00d = p_roadd * x2 + p_road * x2d;
    } else {
      p_road1 = p[t->roadadr[road] + 1];
      p_road1d = pd[t->roadadr[road] + 1];
      t3 = 6.28318530717958647693 * x2 / p_road1;
      p_road1inv = 1.0 / p_road1;
      t3d = (6.28318530717958647693 * x2d - t3 * p_road1d) * p_road1inv;
      t4 = sin(t3);
      c4 = cos(t3);
      t4d = c4 * t3d;
      p_road2 = p[t->roadadr[road]];
      p_road2d = pd[t->roadadr[road]];
      h00 = p_road2 * t4;
      h00d = p_road2d * t4 + p_road2 * t4d;
    }
    t5 = u0 * u0 + u1 * u1;
    t5d = u0d * u0 + u0 * u0d + (u1d * u1 + u1 * u1d);
    t6 = u2 * u0 / t5;
    t5inv = 1.0 / t5;
    t6d = (u2d * u0 + u2 * u0d - t6 * t5d) * t5inv;
    x = g0 + t6 * (g2 - h00);
    xd = g0d + (t6d * (g2 - h00) + t6 * (g2d - h00d));
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road3 = p[t->roadadr[road]];
      p_road3d = pd[t->roadadr[road]];
      h10 = p_road3 * x;
      h10d = p_road3d * x + p_road3 * xd;
      h11 = p_road3;
      h11d = p_road3d;
    } else {
      p_road1_2 = p[t->roadadr[road] + 1];
      p_road1_2d = pd[t->roadadr[road] + 1];
      t7 = 6.28318530717958647693 * x / p_road1_2;
      p_road1_2inv = 1.0 / p_road1_2;
      t7d = (6.28318530717958647693 * xd - t7 * p_road1_2d) * p_road1_2inv;
      t8 = sin(t7);
      c5 = cos(t7);
      t8d = c5 * t7d;
      p_road4 = p[t->roadadr[road]];
      p_road4d = pd[t->roadadr[road]];
      h10 = p_road4 * t8;
      h10d = p_road4d * t8 + p_road4 * t8d;
      t9 = p_road4 * 6.28318530717958647693 / p_road1_2;
      t9d = (p_road4d * 6.28318530717958647693 - t9 * p_road1_2d) * p_road1_2inv;
      t10 = 6.28318530717958647693 * x / p_road1_2;
      t10d = (6.28318530717958647693 * xd - t10 * p_road1_2d) * p_road1_2inv;
      t11 = cos(t10);
      c6 = -sin(t10);
      t11d = c6 * t10d;
      h11 = t9 * t11;
      h11d = t9d * t11 + t9 * t11d;
    }
    t12 = 1.0 + h11 * h11;
    t12d = h11d * h11 + h11 * h11d;
    s = sqrt(t12);
    c7 = 1.0 / (2.0 * s);
    sd = c7 * t12d;
    n30 = -h11 / s;
    sinv = 1.0 / s;
    n30d = (-h11d - n30 * sd) * sinv;
    n31 = 0.0;
    n32 = 1.0 / s;
    n32d = -(n32 * sd * sinv);
    c2 = u0 * n30 + u1 * n31 + u2 * n32;
    c2d = u0d * n30 + u0 * n30d + u1d * n31 + (u2d * n32 + u2 * n32d);
    un0 = u1 * n32 - u2 * n31;
    un0d = u1d * n32 + u1 * n32d - u2d * n31;
    un1 = u2 * n30 - u0 * n32;
    un1d = u2d * n30 + u2 * n30d - (u0d * n32 + u0 * n32d);
    un2 = u0 * n31 - u1 * n30;
    un2d = u0d * n31 - (u1d * n30 + u1 * n30d);
    t13 = un0 * un0 + un1 * un1 + un2 * un2;
    t13d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
    w2 = sqrt(t13);
    c8 = 1.0 / (2.0 * w2);
    w2d = c8 * t13d;
    r2 = ((g0 - x) * n30 + (g2 - h10) * n32) / w2;
    w2inv = 1.0 / w2;
    r2d = ((g0d - xd) * n30 + (g0 - x) * n30d + ((g2d - h10d) * n32 + (g2 - h10) * n32d) - r2 * w2d)
        * w2inv;
    along0 = un0 / w2;
    along0d = (un0d - along0 * w2d) * w2inv;
    along1 = un1 / w2;
    along1d = (un1d - along1 * w2d) * w2inv;
    along2 = un2 / w2;
    along2d = (un2d - along2 * w2d) * w2inv;
    arm0 = r2 * (c2 * u0 - n30) / w2;
    arm0d = (r2d * (c2 * u0 - n30) + r2 * (c2d * u0 + c2 * u0d - n30d) - arm0 * w2d) * w2inv;
    T0 = along0;
    T0d = along0d;
    N0 = n30;
    N0d = n30d;
    arm1 = r2 * (c2 * u1 - n31) / w2;
    arm1d = (r2d * (c2 * u1 - n31) + r2 * (c2d * u1 + c2 * u1d) - arm1 * w2d) * w2inv;
    T1 = along1;
    T1d = along1d;
    N1 = n31;
    arm2 = r2 * (c2 * u2 - n32) / w2;
    arm2d = (r2d * (c2 * u2 - n32) + r2 * (c2d * u2 + c2 * u2d - n32d) - arm2 * w2d) * w2inv;
    T2 = along2;
    T2d = along2d;
    N2 = n32;
    N2d = n32d;
    z0 = r2;
    z0d = r2d;
    z2 = w2;
    z2d = w2d;
    c0 = r[t->wheelpoint[i]][0] + arm0;
    c0d = rd[t->wheelpoint[i]][0] + arm0d;
    c1 = r[t->wheelpoint[i]][1] + arm1;
    c1d = rd[t->wheelpoint[i]][1] + arm1d;
    c2_2 = r[t->wheelpoint[i]][2] + arm2;
    c2_2d = rd[t->wheelpoint[i]][2] + arm2d;
    wr0 = Z[carrier][3];
    wr0d = Zd[carrier][3];
    wr1 = Z[carrier][4];
    wr1d = Zd[carrier][4];
    wr2 = Z[carrier][5];
    wr2d = Zd[carrier][5];
    w0 = wr1 * c2_2 - wr2 * c1;
    w0d = wr1d * c2_2 + wr1 * c2_2d - (wr2d * c1 + wr2 * c1d);
    w1 = wr2 * c0 - wr0 * c2_2;
    w1d = wr2d * c0 + wr2 * c0d - (wr0d * c2_2 + wr0 * c2_2d);
    w2_2 = wr0 * c1 - wr1 * c0;
    w2_2d = wr0d * c1 + wr0 * c1d - (wr1d * c0 + wr1 * c0d);
    v0 = Z[carrier][0] + w0;
    v0d = Zd[carrier][0] + w0d;
    v1 = Z[carrier][1] + w1;
    v1d = Zd[carrier][1] + w1d;
    v2 = Z[carrier][2] + w2_2;
    v2d = Zd[carrier][2] + w2_2d;
    rhov = -(v0 * N0 + v1 * N1 + v2 * N2) / z2;
    z2inv = 1.0 / z2;
    rhovd = (-(v0d * N0 + v0 * N0d + v1d * N1 + (v2d * N2 + v2 * N2d)) - rhov * z2d) * z2inv;
    p2 = p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
    p2d = pd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
    p3 = p[adr + MAGGI_TYRE_UNLOADED_RADIUS];
    p3d = pd[adr + MAGGI_TYRE_UNLOADED_RADIUS];
    fz = p2 * (p3 - z0) + p[adr + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
    fzd = p2d * (p3 - z0) + p2 * (p3d - z0d) + (pd[adr + MAGGI_TYRE_VERTICAL_DAMPING] * rhov + p[adr
        + MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
    fz0 = p[adr + MAGGI_TYRE_LFZO] * p[adr];
    fz0d = pd[adr + MAGGI_TYRE_LFZO] * p[adr] + p[adr + MAGGI_TYRE_LFZO] * pd[adr];
    ratio = fz / fz0;
    fz0inv = 1.0 / fz0;
    ratiod = (fzd - ratio * fz0d) * fz0inv;
    t14 = fz0 / p2;
    p2inv = 1.0 / p2;
    t14d = (fz0d - t14 * p2d) * p2inv;
    t15 = p[adr + MAGGI_TYRE_BREFF] * ratio;
    t15d = pd[adr + MAGGI_TYRE_BREFF] * ratio + p[adr + MAGGI_TYRE_BREFF] * ratiod;
    t16 = atan(t15);
    c9 = 1.0 / (1.0 + t15 * t15);
    t16d = c9 * t15d;
    re = p3 - t14 * (p[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_FREFF] * ratio);
    red = p3d - (t14d * (p[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_FREFF] * ratio) + t14
        * (pd[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_DREFF] * t16d + (pd[adr +
        MAGGI_TYRE_FREFF] * ratio + p[adr + MAGGI_TYRE_FREFF] * ratiod)));
    t17 = re * (b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2);
    t17d = red * (b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2) + re * (bd[body][3] * u0 +
        b[body][3] * u0d + (bd[body][4] * u1 + b[body][4] * u1d) + (bd[body][5] * u2 + b[body][5] *
        u2d));
    t17inv = 1.0 / t17;
    spind[i] = (v0d * T0 + v0 * T0d + (v1d * T1 + v1 * T1d) + (v2d * T2 + v2 * T2d) - spin[i] *
        t17d) * t17inv;
  }
}
