/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/tyre.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* the formula of every tyre at a slip of its own */
void maggi_tyres_dv(const maggi_topo *t, const double p[restrict t->np],
                    const double pd[restrict t->np][MAGGI_NDIR],
                    const double slip[restrict t->ntyre][5],
                    const double slipd[restrict t->ntyre][5][MAGGI_NDIR],
                    double f[restrict t->ntyre][6], double fd[restrict t->ntyre][6][MAGGI_NDIR],
                    int nbdirs)
{
  int i, nd;
  double a, ar, areq, at, ateq, ay, br, bt, bx, by, bycy, c, c10, c11, c12, c13, c14, c15, c16, c17,
      c18, c19, c2, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c3, c30, c31, c4, c5, c6, c7,
      c8, c9, ca, cx, cy, dfz, dr, dt, dv, dx, dy, e, e10, e11, e2, e3, e4, e5, e6, e7, e8, e9, et,
      ex, ey, fx, fy, fz, fz0, fz0_2, fz0_3, fz0_3inv, fz0inv, g0, g1, gamma, gx, gy, gz, inv, inv2,
      inv3, kappa, kx, mux, muy, muy2, p2, p3, p4, p5, p6, p7, p7inv, r0, ratio, s, s2, shift, shy,
      slip_i4, speed, stiff, stiff2, stiff2inv, stiff3, stiff4, svx, svy, t10, t10inv, t11, t11inv,
      t12, t12inv, t13, t14, t14inv, t15, t16, t17, t18, t19, t2, t20, t21, t22, t22inv, t23, t24,
      t25, t25inv, t26, t27, t28, t29, t3, t30, t31, t32, t33, t34, t35, t36, t36inv, t37, t38, t39,
      t4, t40, t41, t42, t42inv, t43, t44, t45, t46, t47, t48, t49, t4inv, t5, t50, t51, t52, t53,
      t53inv, t54, t55, t56, t57, t57inv, t58, t59, t6, t60, t61, t62, t63, t63inv, t64, t65, t66,
      t67, t68, t69, t7, t70, t70inv, t71, t72, t73, t74, t75, t8, t9, way, x0, x1, x2, x3, x4, x5,
      y0, y1, y10, y11, y12, y13, y14, y15, y16, y17, y1inv, y2, y2_2, y3, y3_2, y4, y4_2, y5, y6,
      y7, y8, y9, z0, z2, z3, z4;
  double ad[MAGGI_NDIR], areqd[MAGGI_NDIR], atd[MAGGI_NDIR], ateqd[MAGGI_NDIR], ayd[MAGGI_NDIR],
      btd[MAGGI_NDIR], bycyd[MAGGI_NDIR], cxd[MAGGI_NDIR], cyd[MAGGI_NDIR], dfzd[MAGGI_NDIR],
      dtd[MAGGI_NDIR], dxd[MAGGI_NDIR], dyd[MAGGI_NDIR], e10d[MAGGI_NDIR], e11d[MAGGI_NDIR],
      e2d[MAGGI_NDIR], e3d[MAGGI_NDIR], e4d[MAGGI_NDIR], e5d[MAGGI_NDIR], e6d[MAGGI_NDIR],
      e8d[MAGGI_NDIR], ed[MAGGI_NDIR], exd[MAGGI_NDIR], eyd[MAGGI_NDIR], fxd[MAGGI_NDIR],
      fyd[MAGGI_NDIR], fz0_2d[MAGGI_NDIR], fz0_3d[MAGGI_NDIR], fz0d[MAGGI_NDIR], fzd[MAGGI_NDIR],
      g0d[MAGGI_NDIR], g1d[MAGGI_NDIR], gammad[MAGGI_NDIR], gyd[MAGGI_NDIR], gzd[MAGGI_NDIR],
      kappad[MAGGI_NDIR], kxd[MAGGI_NDIR], muy2d[MAGGI_NDIR], muyd[MAGGI_NDIR], r0d[MAGGI_NDIR],
      shyd[MAGGI_NDIR], stiff3d[MAGGI_NDIR], stiff4d[MAGGI_NDIR], x0d[MAGGI_NDIR], x1d[MAGGI_NDIR],
      y0d[MAGGI_NDIR], y12d[MAGGI_NDIR], y15d[MAGGI_NDIR], y16d[MAGGI_NDIR], y1d[MAGGI_NDIR],
      y2d[MAGGI_NDIR], y3_2d[MAGGI_NDIR], y3d[MAGGI_NDIR], y4_2d[MAGGI_NDIR], y5d[MAGGI_NDIR],
      y6d[MAGGI_NDIR], y7d[MAGGI_NDIR], y9d[MAGGI_NDIR], z2d[MAGGI_NDIR];

  (void)nbdirs;
  for (i = 0; i < t->ntyre; ++i) {
    kappa = slip[i][0];
    a = slip[i][1];
    gamma = slip[i][2];
    fz = f[i][2];
    fz0 = p[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]];
    r0 = p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS];
    dfz = (fz - fz0) / fz0;
    fz0inv = 1.0 / fz0;
    kx = kappa + (p[t->tyreadr[i] + MAGGI_TYRE_PHX1] + p[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LHX];
    gx = gamma * p[t->tyreadr[i] + MAGGI_TYRE_LGAX];
    cx = p[t->tyreadr[i] + MAGGI_TYRE_PCX1] * p[t->tyreadr[i] + MAGGI_TYRE_LCX];
    mux = (p[t->tyreadr[i] + MAGGI_TYRE_PDX1] + p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
        p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx * gx) * p[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    dx = mux * fz;
    e = (p[t->tyreadr[i] + MAGGI_TYRE_PEX1] + p[t->tyreadr[i] + MAGGI_TYRE_PEX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LEX];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double gxd, muxd;

      kappad[nd] = slipd[i][0][nd];
      ad[nd] = slipd[i][1][nd];
      gammad[nd] = slipd[i][2][nd];
      fzd[nd] = slipd[i][3][nd];
      fz0d[nd] = pd[t->tyreadr[i] + MAGGI_TYRE_LFZO][nd] * p[t->tyreadr[i]] + p[t->tyreadr[i] +
          MAGGI_TYRE_LFZO] * pd[t->tyreadr[i]][nd];
      r0d[nd] = pd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS][nd];
      dfzd[nd] = (fzd[nd] - fz0d[nd] - dfz * fz0d[nd]) * fz0inv;
      /* Fx0, Kx */
      kxd[nd] = kappad[nd] + ((pd[t->tyreadr[i] + MAGGI_TYRE_PHX1][nd] + (pd[t->tyreadr[i] +
          MAGGI_TYRE_PHX2][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfzd[nd])) *
          p[t->tyreadr[i] + MAGGI_TYRE_LHX] + (p[t->tyreadr[i] + MAGGI_TYRE_PHX1] + p[t->tyreadr[i]
          + MAGGI_TYRE_PHX2] * dfz) * pd[t->tyreadr[i] + MAGGI_TYRE_LHX][nd]);
      gxd = gammad[nd] * p[t->tyreadr[i] + MAGGI_TYRE_LGAX] + gamma * pd[t->tyreadr[i] +
          MAGGI_TYRE_LGAX][nd];
      cxd[nd] = pd[t->tyreadr[i] + MAGGI_TYRE_PCX1][nd] * p[t->tyreadr[i] + MAGGI_TYRE_LCX] +
          p[t->tyreadr[i] + MAGGI_TYRE_PCX1] * pd[t->tyreadr[i] + MAGGI_TYRE_LCX][nd];
      muxd = ((pd[t->tyreadr[i] + MAGGI_TYRE_PDX1][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_PDX2][nd] *
          dfz + p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfzd[nd])) * (1.0 - p[t->tyreadr[i] +
          MAGGI_TYRE_PDX3] * gx * gx) - (p[t->tyreadr[i] + MAGGI_TYRE_PDX1] + p[t->tyreadr[i] +
          MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[i] + MAGGI_TYRE_PDX3][nd] * gx + p[t->tyreadr[i]
          + MAGGI_TYRE_PDX3] * gxd) * gx + p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx * gxd)) *
          p[t->tyreadr[i] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[i] + MAGGI_TYRE_PDX1] + p[t->tyreadr[i]
          + MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx * gx) *
          pd[t->tyreadr[i] + MAGGI_TYRE_LMUX][nd];
      dxd[nd] = muxd * fz + mux * fzd[nd];
      ed[nd] = (pd[t->tyreadr[i] + MAGGI_TYRE_PEX1][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_PEX2][nd] *
          dfz + p[t->tyreadr[i] + MAGGI_TYRE_PEX2] * dfzd[nd]) + ((pd[t->tyreadr[i] +
          MAGGI_TYRE_PEX3][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfzd[nd]) * dfz +
          p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz * dfzd[nd])) * p[t->tyreadr[i] + MAGGI_TYRE_LEX]
          + (p[t->tyreadr[i] + MAGGI_TYRE_PEX1] + p[t->tyreadr[i] + MAGGI_TYRE_PEX2] * dfz +
          p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz * dfz) * pd[t->tyreadr[i] + MAGGI_TYRE_LEX][nd];
    }
    if (MAGGI_RE(kx) > 0.0) {
      e2 = e * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        e2d[nd] = ed[nd] * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PEX4]) - e * pd[t->tyreadr[i] +
            MAGGI_TYRE_PEX4][nd];
      }
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e2) > 1.0) {
        y2 = 1.0;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          y2d[nd] = 0.0;
        }
      } else {
        y2 = e2;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          y2d[nd] = e2d[nd];
        }
      }
      ex = y2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        exd[nd] = y2d[nd];
      }
    } else {
      e3 = e * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        e3d[nd] = ed[nd] * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_PEX4]) + e * pd[t->tyreadr[i] +
            MAGGI_TYRE_PEX4][nd];
      }
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e3) > 1.0) {
        y3 = 1.0;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          y3d[nd] = 0.0;
        }
      } else {
        y3 = e3;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          y3d[nd] = e3d[nd];
        }
      }
      ex = y3;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        exd[nd] = y3d[nd];
      }
    }
    t2 = p[t->tyreadr[i] + MAGGI_TYRE_PKX3] * dfz;
    t3 = exp(t2);
    stiff = fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz) *
        t3 * p[t->tyreadr[i] + MAGGI_TYRE_LKX];
    t4 = cx * dx;
    bx = stiff / t4;
    t4inv = 1.0 / t4;
    svx = fz * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVX] * p[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    y4 = bx * kx;
    t5 = atan(y4);
    c = 1.0 / (1.0 + y4 * y4);
    t6 = (1.0 - ex) * y4 + ex * t5;
    t7 = atan(t6);
    c2 = 1.0 / (1.0 + t6 * t6);
    t8 = cx * t7;
    t9 = sin(t8);
    c3 = cos(t8);
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
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double bxd, stiffd, svxd, t2d, t3d, t4d, t5d, t6d, t7d, t8d, t9d, y4d;

      t2d = pd[t->tyreadr[i] + MAGGI_TYRE_PKX3][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PKX3] *
          dfzd[nd];
      t3d = t3 * t2d;
      stiffd = ((fzd[nd] * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2]
          * dfz) + fz * (pd[t->tyreadr[i] + MAGGI_TYRE_PKX1][nd] + (pd[t->tyreadr[i] +
          MAGGI_TYRE_PKX2][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfzd[nd]))) * t3 + fz *
          (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz) * t3d) *
          p[t->tyreadr[i] + MAGGI_TYRE_LKX] + fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] +
          p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz) * t3 * pd[t->tyreadr[i] + MAGGI_TYRE_LKX][nd];
      t4d = cxd[nd] * dx + cx * dxd[nd];
      bxd = (stiffd - bx * t4d) * t4inv;
      svxd = ((fzd[nd] * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] *
          dfz) + fz * (pd[t->tyreadr[i] + MAGGI_TYRE_PVX1][nd] + (pd[t->tyreadr[i] +
          MAGGI_TYRE_PVX2][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfzd[nd]))) *
          p[t->tyreadr[i] + MAGGI_TYRE_LVX] + fz * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] +
          p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) * pd[t->tyreadr[i] + MAGGI_TYRE_LVX][nd]) *
          p[t->tyreadr[i] + MAGGI_TYRE_LMUX] + fz * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] +
          p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LVX] *
          pd[t->tyreadr[i] + MAGGI_TYRE_LMUX][nd];
      /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
      y4d = bxd * kx + bx * kxd[nd];
      t5d = c * y4d;
      t6d = -(exd[nd] * y4) + (1.0 - ex) * y4d + (exd[nd] * t5 + ex * t5d);
      t7d = c2 * t6d;
      t8d = cxd[nd] * t7 + cx * t7d;
      t9d = c3 * t8d;
      x0d[nd] = dxd[nd] * t9 + dx * t9d + svxd;
      x1d[nd] = stiffd;
      /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
      fz0_2d[nd] = pd[t->tyreadr[i] + MAGGI_TYRE_LFZO][nd] * p[t->tyreadr[i]] + p[t->tyreadr[i] +
          MAGGI_TYRE_LFZO] * pd[t->tyreadr[i]][nd];
      gyd[nd] = gammad[nd] * p[t->tyreadr[i] + MAGGI_TYRE_LGAY] + gamma * pd[t->tyreadr[i] +
          MAGGI_TYRE_LGAY][nd];
      shyd[nd] = (pd[t->tyreadr[i] + MAGGI_TYRE_PHY1][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_PHY2][nd]
          * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PHY2] * dfzd[nd])) * p[t->tyreadr[i] +
          MAGGI_TYRE_LHY] + (p[t->tyreadr[i] + MAGGI_TYRE_PHY1] + p[t->tyreadr[i] + MAGGI_TYRE_PHY2]
          * dfz) * pd[t->tyreadr[i] + MAGGI_TYRE_LHY][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_PHY3][nd]
          * gy + p[t->tyreadr[i] + MAGGI_TYRE_PHY3] * gyd[nd]);
      ayd[nd] = ad[nd] + shyd[nd];
      cyd[nd] = pd[t->tyreadr[i] + MAGGI_TYRE_PCY1][nd] * p[t->tyreadr[i] + MAGGI_TYRE_LCY] +
          p[t->tyreadr[i] + MAGGI_TYRE_PCY1] * pd[t->tyreadr[i] + MAGGI_TYRE_LCY][nd];
      muyd[nd] = ((pd[t->tyreadr[i] + MAGGI_TYRE_PDY1][nd] + (pd[t->tyreadr[i] +
          MAGGI_TYRE_PDY2][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfzd[nd])) * (1.0 -
          p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy * gy) - (p[t->tyreadr[i] + MAGGI_TYRE_PDY1] +
          p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[i] + MAGGI_TYRE_PDY3][nd] * gy
          + p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gyd[nd]) * gy + p[t->tyreadr[i] + MAGGI_TYRE_PDY3]
          * gy * gyd[nd])) * p[t->tyreadr[i] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[i] +
          MAGGI_TYRE_PDY1] + p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[i] +
          MAGGI_TYRE_PDY3] * gy * gy) * pd[t->tyreadr[i] + MAGGI_TYRE_LMUY][nd];
      dyd[nd] = muyd[nd] * fz + muy * fzd[nd];
      e4d[nd] = (pd[t->tyreadr[i] + MAGGI_TYRE_PEY1][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_PEY2][nd]
          * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PEY2] * dfzd[nd])) * p[t->tyreadr[i] +
          MAGGI_TYRE_LEY] + (p[t->tyreadr[i] + MAGGI_TYRE_PEY1] + p[t->tyreadr[i] + MAGGI_TYRE_PEY2]
          * dfz) * pd[t->tyreadr[i] + MAGGI_TYRE_LEY][nd];
    }
    if (MAGGI_RE(ay) > 0.0) {
      e5 = e4 * (1.0 - (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        e5d[nd] = e4d[nd] * (1.0 - (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] +
            MAGGI_TYRE_PEY4] * gy)) - e4 * (pd[t->tyreadr[i] + MAGGI_TYRE_PEY3][nd] +
            (pd[t->tyreadr[i] + MAGGI_TYRE_PEY4][nd] * gy + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
            gyd[nd]));
      }
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e5) > 1.0) {
        y5 = 1.0;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          y5d[nd] = 0.0;
        }
      } else {
        y5 = e5;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          y5d[nd] = e5d[nd];
        }
      }
      ey = y5;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        eyd[nd] = y5d[nd];
      }
    } else {
      e6 = e4 * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        e6d[nd] = e4d[nd] * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] +
            MAGGI_TYRE_PEY4] * gy)) + e4 * (pd[t->tyreadr[i] + MAGGI_TYRE_PEY3][nd] +
            (pd[t->tyreadr[i] + MAGGI_TYRE_PEY4][nd] * gy + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
            gyd[nd]));
      }
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e6) > 1.0) {
        y6 = 1.0;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          y6d[nd] = 0.0;
        }
      } else {
        y6 = e6;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          y6d[nd] = e6d[nd];
        }
      }
      ey = y6;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        eyd[nd] = y6d[nd];
      }
    }
    t10 = p[t->tyreadr[i] + MAGGI_TYRE_PKY2] * fz0_2;
    z2 = fz / t10;
    t10inv = 1.0 / t10;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double t10d;

      t10d = pd[t->tyreadr[i] + MAGGI_TYRE_PKY2][nd] * fz0_2 + p[t->tyreadr[i] + MAGGI_TYRE_PKY2] *
          fz0_2d[nd];
      z2d[nd] = (fzd[nd] - z2 * t10d) * t10inv;
    }
    /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
     * where straight running is, and exact from w on */
    if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y7 = gy;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y7d[nd] = gyd[nd];
      }
    } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y7 = -gy;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y7d[nd] = -gyd[nd];
      }
    } else {
      p2 = p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      t11 = p2 * p2;
      z3 = gy * gy / t11;
      t11inv = 1.0 / t11;
      y7 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p2d, t11d, z3d;

        p2d = pd[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER][nd];
        t11d = p2d * p2 + p2 * p2d;
        z3d = (gyd[nd] * gy + gy * gyd[nd] - z3 * t11d) * t11inv;
        y7d[nd] = (0.125 * p2d * z3 + 0.125 * p2 * z3d) * (15.0 + z3 * (-10.0 + 3.0 * z3)) + 0.125 *
            p2 * z3 * (z3d * (-10.0 + 3.0 * z3) + z3 * (3.0 * z3d));
      }
    }
    t12 = 1.0 + z2 * z2;
    t13 = 2.0 * z2 / t12;
    t12inv = 1.0 / t12;
    stiff2 = p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 - p[t->tyreadr[i] +
        MAGGI_TYRE_PKY3] * y7) * p[t->tyreadr[i] + MAGGI_TYRE_LKY];
    t14 = cy * dy;
    by = stiff2 / t14;
    t14inv = 1.0 / t14;
    svy = fz * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfz) * gy) * p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    y8 = by * ay;
    t15 = atan(y8);
    c4 = 1.0 / (1.0 + y8 * y8);
    t16 = (1.0 - ey) * y8 + ey * t15;
    t17 = atan(t16);
    c5 = 1.0 / (1.0 + t16 * t16);
    t18 = cy * t17;
    t19 = sin(t18);
    c6 = cos(t18);
    y0 = dy * t19 + svy;
    y1 = stiff2;
    y2_2 = muy;
    y3_2 = by * cy;
    t20 = svy / stiff2;
    stiff2inv = 1.0 / stiff2;
    y4_2 = shy + t20;
    muy2 = y2_2;
    x2 = p[t->tyreadr[i] + MAGGI_TYRE_RBY2] * (a - p[t->tyreadr[i] + MAGGI_TYRE_RBY3]);
    t21 = 1.0 + x2 * x2;
    t22 = sqrt(t21);
    c7 = 1.0 / (2.0 * t22);
    t23 = 1.0 / t22;
    t22inv = 1.0 / t22;
    stiff3 = p[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23 * p[t->tyreadr[i] + MAGGI_TYRE_LYKA];
    e8 = p[t->tyreadr[i] + MAGGI_TYRE_REY1] + p[t->tyreadr[i] + MAGGI_TYRE_REY2] * dfz;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double byd, stiff2d, svyd, t12d, t13d, t14d, t15d, t16d, t17d, t18d, t19d, t20d, t21d, t22d,
          t23d, x2d, y2_2d, y8d;

      t12d = z2d[nd] * z2 + z2 * z2d[nd];
      t13d = (2.0 * z2d[nd] - t13 * t12d) * t12inv;
      stiff2d = (((pd[t->tyreadr[i] + MAGGI_TYRE_PKY1][nd] * fz0_2 + p[t->tyreadr[i] +
          MAGGI_TYRE_PKY1] * fz0_2d[nd]) * t13 + p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13d)
          * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7) - p[t->tyreadr[i] + MAGGI_TYRE_PKY1] *
          fz0_2 * t13 * (pd[t->tyreadr[i] + MAGGI_TYRE_PKY3][nd] * y7 + p[t->tyreadr[i] +
          MAGGI_TYRE_PKY3] * y7d[nd])) * p[t->tyreadr[i] + MAGGI_TYRE_LKY] + p[t->tyreadr[i] +
          MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7) *
          pd[t->tyreadr[i] + MAGGI_TYRE_LKY][nd];
      t14d = cyd[nd] * dy + cy * dyd[nd];
      byd = (stiff2d - by * t14d) * t14inv;
      svyd = (fzd[nd] * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] *
          dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] +
          p[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz) * gy) + fz * ((pd[t->tyreadr[i] +
          MAGGI_TYRE_PVY1][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_PVY2][nd] * dfz + p[t->tyreadr[i] +
          MAGGI_TYRE_PVY2] * dfzd[nd])) * p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] +
          MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) * pd[t->tyreadr[i] +
          MAGGI_TYRE_LVY][nd] + ((pd[t->tyreadr[i] + MAGGI_TYRE_PVY3][nd] + (pd[t->tyreadr[i] +
          MAGGI_TYRE_PVY4][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfzd[nd])) * gy +
          (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz) *
          gyd[nd]))) * p[t->tyreadr[i] + MAGGI_TYRE_LMUY] + fz * ((p[t->tyreadr[i] +
          MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[i] +
          MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] + MAGGI_TYRE_PVY4]
          * dfz) * gy) * pd[t->tyreadr[i] + MAGGI_TYRE_LMUY][nd];
      /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
      y8d = byd * ay + by * ayd[nd];
      t15d = c4 * y8d;
      t16d = -(eyd[nd] * y8) + (1.0 - ey) * y8d + (eyd[nd] * t15 + ey * t15d);
      t17d = c5 * t16d;
      t18d = cyd[nd] * t17 + cy * t17d;
      t19d = c6 * t18d;
      y0d[nd] = dyd[nd] * t19 + dy * t19d + svyd;
      y1d[nd] = stiff2d;
      y2_2d = muyd[nd];
      y3_2d[nd] = byd * cy + by * cyd[nd];
      t20d = (svyd - t20 * stiff2d) * stiff2inv;
      y4_2d[nd] = shyd[nd] + t20d;
      muy2d[nd] = y2_2d;
      /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
      x2d = pd[t->tyreadr[i] + MAGGI_TYRE_RBY2][nd] * (a - p[t->tyreadr[i] + MAGGI_TYRE_RBY3]) +
          p[t->tyreadr[i] + MAGGI_TYRE_RBY2] * (ad[nd] - pd[t->tyreadr[i] + MAGGI_TYRE_RBY3][nd]);
      t21d = x2d * x2 + x2 * x2d;
      t22d = c7 * t21d;
      t23d = -(t23 * t22d * t22inv);
      stiff3d[nd] = (pd[t->tyreadr[i] + MAGGI_TYRE_RBY1][nd] * t23 + p[t->tyreadr[i] +
          MAGGI_TYRE_RBY1] * t23d) * p[t->tyreadr[i] + MAGGI_TYRE_LYKA] + p[t->tyreadr[i] +
          MAGGI_TYRE_RBY1] * t23 * pd[t->tyreadr[i] + MAGGI_TYRE_LYKA][nd];
      e8d[nd] = pd[t->tyreadr[i] + MAGGI_TYRE_REY1][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_REY2][nd] *
          dfz + p[t->tyreadr[i] + MAGGI_TYRE_REY2] * dfzd[nd]);
    }
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e8) > 1.0) {
      y9 = 1.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y9d[nd] = 0.0;
      }
    } else {
      y9 = e8;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y9d[nd] = e8d[nd];
      }
    }
    e7 = y9;
    s2 = p[t->tyreadr[i] + MAGGI_TYRE_RHY1] + p[t->tyreadr[i] + MAGGI_TYRE_RHY2] * dfz;
    x3 = p[t->tyreadr[i] + MAGGI_TYRE_RVY4] * a;
    t24 = 1.0 + x3 * x3;
    t25 = sqrt(t24);
    c8 = 1.0 / (2.0 * t25);
    t26 = 1.0 / t25;
    t25inv = 1.0 / t25;
    dv = muy2 * fz * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz
        + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma) * t26;
    y10 = stiff3 * (kappa + s2);
    y11 = stiff3 * s2;
    t27 = atan(y10);
    c9 = 1.0 / (1.0 + y10 * y10);
    t28 = (1.0 - e7) * y10 + e7 * t27;
    t29 = atan(t28);
    c10 = 1.0 / (1.0 + t28 * t28);
    p3 = p[t->tyreadr[i] + MAGGI_TYRE_RCY1];
    t30 = p3 * t29;
    t31 = cos(t30);
    c11 = -sin(t30);
    t32 = atan(y11);
    c12 = 1.0 / (1.0 + y11 * y11);
    t33 = (1.0 - e7) * y11 + e7 * t32;
    t34 = atan(t33);
    c13 = 1.0 / (1.0 + t33 * t33);
    t35 = p3 * t34;
    t36 = cos(t35);
    c14 = -sin(t35);
    g0 = t31 / t36;
    t36inv = 1.0 / t36;
    t37 = p[t->tyreadr[i] + MAGGI_TYRE_RVY6] * kappa;
    t38 = atan(t37);
    c15 = 1.0 / (1.0 + t37 * t37);
    t39 = p[t->tyreadr[i] + MAGGI_TYRE_RVY5] * t38;
    t40 = sin(t39);
    c16 = cos(t39);
    g1 = dv * t40 * p[t->tyreadr[i] + MAGGI_TYRE_LVYKA];
    x4 = p[t->tyreadr[i] + MAGGI_TYRE_RBX2] * kappa;
    t41 = 1.0 + x4 * x4;
    t42 = sqrt(t41);
    c17 = 1.0 / (2.0 * t42);
    t43 = 1.0 / t42;
    t42inv = 1.0 / t42;
    stiff4 = p[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43 * p[t->tyreadr[i] + MAGGI_TYRE_LXAL];
    e10 = p[t->tyreadr[i] + MAGGI_TYRE_REX1] + p[t->tyreadr[i] + MAGGI_TYRE_REX2] * dfz;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double dvd, e7d, p3d, s2d, t24d, t25d, t26d, t27d, t28d, t29d, t30d, t31d, t32d, t33d, t34d,
          t35d, t36d, t37d, t38d, t39d, t40d, t41d, t42d, t43d, x3d, x4d, y10d, y11d;

      e7d = y9d[nd];
      s2d = pd[t->tyreadr[i] + MAGGI_TYRE_RHY1][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_RHY2][nd] * dfz
          + p[t->tyreadr[i] + MAGGI_TYRE_RHY2] * dfzd[nd]);
      x3d = pd[t->tyreadr[i] + MAGGI_TYRE_RVY4][nd] * a + p[t->tyreadr[i] + MAGGI_TYRE_RVY4] *
          ad[nd];
      t24d = x3d * x3 + x3 * x3d;
      t25d = c8 * t24d;
      t26d = -(t26 * t25d * t25inv);
      dvd = ((muy2d[nd] * fz + muy2 * fzd[nd]) * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] +
          p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma) +
          muy2 * fz * (pd[t->tyreadr[i] + MAGGI_TYRE_RVY1][nd] + (pd[t->tyreadr[i] +
          MAGGI_TYRE_RVY2][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfzd[nd]) +
          (pd[t->tyreadr[i] + MAGGI_TYRE_RVY3][nd] * gamma + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] *
          gammad[nd]))) * t26 + muy2 * fz * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] +
          MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma) * t26d;
      /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
      y10d = stiff3d[nd] * (kappa + s2) + stiff3 * (kappad[nd] + s2d);
      /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
      y11d = stiff3d[nd] * s2 + stiff3 * s2d;
      t27d = c9 * y10d;
      t28d = -(e7d * y10) + (1.0 - e7) * y10d + (e7d * t27 + e7 * t27d);
      t29d = c10 * t28d;
      p3d = pd[t->tyreadr[i] + MAGGI_TYRE_RCY1][nd];
      t30d = p3d * t29 + p3 * t29d;
      t31d = c11 * t30d;
      t32d = c12 * y11d;
      t33d = -(e7d * y11) + (1.0 - e7) * y11d + (e7d * t32 + e7 * t32d);
      t34d = c13 * t33d;
      t35d = p3d * t34 + p3 * t34d;
      t36d = c14 * t35d;
      g0d[nd] = (t31d - g0 * t36d) * t36inv;
      t37d = pd[t->tyreadr[i] + MAGGI_TYRE_RVY6][nd] * kappa + p[t->tyreadr[i] + MAGGI_TYRE_RVY6] *
          kappad[nd];
      t38d = c15 * t37d;
      t39d = pd[t->tyreadr[i] + MAGGI_TYRE_RVY5][nd] * t38 + p[t->tyreadr[i] + MAGGI_TYRE_RVY5] *
          t38d;
      t40d = c16 * t39d;
      g1d[nd] = (dvd * t40 + dv * t40d) * p[t->tyreadr[i] + MAGGI_TYRE_LVYKA] + dv * t40 *
          pd[t->tyreadr[i] + MAGGI_TYRE_LVYKA][nd];
      /* Gxa = Fx / Fx0 */
      x4d = pd[t->tyreadr[i] + MAGGI_TYRE_RBX2][nd] * kappa + p[t->tyreadr[i] + MAGGI_TYRE_RBX2] *
          kappad[nd];
      t41d = x4d * x4 + x4 * x4d;
      t42d = c17 * t41d;
      t43d = -(t43 * t42d * t42inv);
      stiff4d[nd] = (pd[t->tyreadr[i] + MAGGI_TYRE_RBX1][nd] * t43 + p[t->tyreadr[i] +
          MAGGI_TYRE_RBX1] * t43d) * p[t->tyreadr[i] + MAGGI_TYRE_LXAL] + p[t->tyreadr[i] +
          MAGGI_TYRE_RBX1] * t43 * pd[t->tyreadr[i] + MAGGI_TYRE_LXAL][nd];
      e10d[nd] = pd[t->tyreadr[i] + MAGGI_TYRE_REX1][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_REX2][nd]
          * dfz + p[t->tyreadr[i] + MAGGI_TYRE_REX2] * dfzd[nd]);
    }
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e10) > 1.0) {
      y12 = 1.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y12d[nd] = 0.0;
      }
    } else {
      y12 = e10;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y12d[nd] = e10d[nd];
      }
    }
    e9 = y12;
    p4 = p[t->tyreadr[i] + MAGGI_TYRE_RHX1];
    y13 = stiff4 * (a + p4);
    y14 = stiff4 * p4;
    t44 = atan(y13);
    c18 = 1.0 / (1.0 + y13 * y13);
    t45 = (1.0 - e9) * y13 + e9 * t44;
    t46 = atan(t45);
    c19 = 1.0 / (1.0 + t45 * t45);
    p5 = p[t->tyreadr[i] + MAGGI_TYRE_RCX1];
    t47 = p5 * t46;
    t48 = cos(t47);
    c20 = -sin(t47);
    t49 = atan(y14);
    c21 = 1.0 / (1.0 + y14 * y14);
    t50 = (1.0 - e9) * y14 + e9 * t49;
    t51 = atan(t50);
    c22 = 1.0 / (1.0 + t50 * t50);
    t52 = p5 * t51;
    t53 = cos(t52);
    c23 = -sin(t52);
    t54 = t48 / t53;
    t53inv = 1.0 / t53;
    fx = f[i][0];
    fy = f[i][1];
    ratio = x1 * kappa / y1;
    y1inv = 1.0 / y1;
    bycy = y3_2;
    shift = y4_2;
    fz0_3 = p[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]];
    gz = gamma * p[t->tyreadr[i] + MAGGI_TYRE_LGAZ];
    at = a + p[t->tyreadr[i] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QHZ2] * dfz +
        (p[t->tyreadr[i] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfz) * gz;
    ar = a + shift;
    t55 = at * at + ratio * ratio + 1e-24;
    ateq = sqrt(t55);
    c24 = 1.0 / (2.0 * ateq);
    t56 = ar * ar + ratio * ratio + 1e-24;
    areq = sqrt(t56);
    c25 = 1.0 / (2.0 * areq);
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double ard, e9d, p4d, p5d, ratiod, shiftd, t44d, t45d, t46d, t47d, t48d, t49d, t50d, t51d,
          t52d, t53d, t54d, t55d, t56d, y13d, y14d;

      e9d = y12d[nd];
      p4d = pd[t->tyreadr[i] + MAGGI_TYRE_RHX1][nd];
      /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
      y13d = stiff4d[nd] * (a + p4) + stiff4 * (ad[nd] + p4d);
      /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
      y14d = stiff4d[nd] * p4 + stiff4 * p4d;
      t44d = c18 * y13d;
      t45d = -(e9d * y13) + (1.0 - e9) * y13d + (e9d * t44 + e9 * t44d);
      t46d = c19 * t45d;
      p5d = pd[t->tyreadr[i] + MAGGI_TYRE_RCX1][nd];
      t47d = p5d * t46 + p5 * t46d;
      t48d = c20 * t47d;
      t49d = c21 * y14d;
      t50d = -(e9d * y14) + (1.0 - e9) * y14d + (e9d * t49 + e9 * t49d);
      t51d = c22 * t50d;
      t52d = p5d * t51 + p5 * t51d;
      t53d = c23 * t52d;
      t54d = (t48d - t54 * t53d) * t53inv;
      fxd[nd] = x0d[nd] * t54 + x0 * t54d;
      fyd[nd] = g0d[nd] * y0 + g0 * y0d[nd] + g1d[nd];
      ratiod = (x1d[nd] * kappa + x1 * kappad[nd] - ratio * y1d[nd]) * y1inv;
      bycyd[nd] = y3_2d[nd];
      shiftd = y4_2d[nd];
      /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
       *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
      fz0_3d[nd] = pd[t->tyreadr[i] + MAGGI_TYRE_LFZO][nd] * p[t->tyreadr[i]] + p[t->tyreadr[i] +
          MAGGI_TYRE_LFZO] * pd[t->tyreadr[i]][nd];
      gzd[nd] = gammad[nd] * p[t->tyreadr[i] + MAGGI_TYRE_LGAZ] + gamma * pd[t->tyreadr[i] +
          MAGGI_TYRE_LGAZ][nd];
      atd[nd] = ad[nd] + pd[t->tyreadr[i] + MAGGI_TYRE_QHZ1][nd] + (pd[t->tyreadr[i] +
          MAGGI_TYRE_QHZ2][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QHZ2] * dfzd[nd]) +
          ((pd[t->tyreadr[i] + MAGGI_TYRE_QHZ3][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_QHZ4][nd] * dfz
          + p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfzd[nd])) * gz + (p[t->tyreadr[i] +
          MAGGI_TYRE_QHZ3] + p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfz) * gzd[nd]);
      ard = ad[nd] + shiftd;
      t55d = atd[nd] * at + at * atd[nd] + (ratiod * ratio + ratio * ratiod);
      ateqd[nd] = c24 * t55d;
      t56d = ard * ar + ar * ard + (ratiod * ratio + ratio * ratiod);
      areqd[nd] = c25 * t56d;
    }
    /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
     * where straight running is, and exact from w on */
    if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y15 = gz;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y15d[nd] = gzd[nd];
      }
    } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      y15 = -gz;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y15d[nd] = -gzd[nd];
      }
    } else {
      p6 = p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      t57 = p6 * p6;
      z4 = gz * gz / t57;
      t57inv = 1.0 / t57;
      y15 = 0.125 * p6 * z4 * (15.0 + z4 * (-10.0 + 3.0 * z4));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p6d, t57d, z4d;

        p6d = pd[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER][nd];
        t57d = p6d * p6 + p6 * p6d;
        z4d = (gzd[nd] * gz + gz * gzd[nd] - z4 * t57d) * t57inv;
        y15d[nd] = (0.125 * p6d * z4 + 0.125 * p6 * z4d) * (15.0 + z4 * (-10.0 + 3.0 * z4)) + 0.125
            * p6 * z4 * (z4d * (-10.0 + 3.0 * z4) + z4 * (3.0 * z4d));
      }
    }
    bt = (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4]
        * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15) * p[t->tyreadr[i] + MAGGI_TYRE_LKY] /
        p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    inv = 1.0 / p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    t58 = p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_3;
    fz0_3inv = 1.0 / fz0_3;
    dt = fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) * (1.0
        + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) *
        t58 * p[t->tyreadr[i] + MAGGI_TYRE_LTR];
    t59 = bt * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * at;
    t60 = atan(t59);
    c26 = 1.0 / (1.0 + t59 * t59);
    e11 = (p[t->tyreadr[i] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz * dfz) * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_QEZ4]
        + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t60);
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double t58d, t59d, t60d;

      btd[nd] = (((pd[t->tyreadr[i] + MAGGI_TYRE_QBZ1][nd] + (pd[t->tyreadr[i] +
          MAGGI_TYRE_QBZ2][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfzd[nd]) +
          ((pd[t->tyreadr[i] + MAGGI_TYRE_QBZ3][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] *
          dfzd[nd]) * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfzd[nd])) * (1.0 +
          p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15) +
          (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz +
          p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (pd[t->tyreadr[i] + MAGGI_TYRE_QBZ4][nd]
          * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gzd[nd] + (pd[t->tyreadr[i] +
          MAGGI_TYRE_QBZ5][nd] * y15 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15d[nd]))) *
          p[t->tyreadr[i] + MAGGI_TYRE_LKY] + (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i]
          + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 +
          p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15) *
          pd[t->tyreadr[i] + MAGGI_TYRE_LKY][nd] - bt * pd[t->tyreadr[i] + MAGGI_TYRE_LMUY][nd]) *
          inv;
      t58d = (pd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS][nd] - t58 * fz0_3d[nd]) * fz0_3inv;
      dtd[nd] = (((fzd[nd] * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] +
          MAGGI_TYRE_QDZ2] * dfz) + fz * (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ1][nd] +
          (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ2][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] *
          dfzd[nd]))) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] +
          MAGGI_TYRE_QDZ4] * gz * gz) + fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] +
          MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ3][nd] * gz + p[t->tyreadr[i]
          + MAGGI_TYRE_QDZ3] * gzd[nd] + ((pd[t->tyreadr[i] + MAGGI_TYRE_QDZ4][nd] * gz +
          p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gzd[nd]) * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] *
          gz * gzd[nd]))) * t58 + fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] +
          MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i]
          + MAGGI_TYRE_QDZ4] * gz * gz) * t58d) * p[t->tyreadr[i] + MAGGI_TYRE_LTR] + fz *
          (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
          p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) *
          t58 * pd[t->tyreadr[i] + MAGGI_TYRE_LTR][nd];
      t59d = (btd[nd] * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] + bt * pd[t->tyreadr[i] +
          MAGGI_TYRE_QCZ1][nd]) * at + bt * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * atd[nd];
      t60d = c26 * t59d;
      e11d[nd] = (pd[t->tyreadr[i] + MAGGI_TYRE_QEZ1][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_QEZ2][nd]
          * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QEZ2] * dfzd[nd]) + ((pd[t->tyreadr[i] +
          MAGGI_TYRE_QEZ3][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfzd[nd]) * dfz +
          p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz * dfzd[nd])) * (1.0 + (p[t->tyreadr[i] +
          MAGGI_TYRE_QEZ4] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
          t60) + (p[t->tyreadr[i] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ2] * dfz +
          p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz * dfz) * ((pd[t->tyreadr[i] +
          MAGGI_TYRE_QEZ4][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_QEZ5][nd] * gz + p[t->tyreadr[i] +
          MAGGI_TYRE_QEZ5] * gzd[nd])) * 0.63661977236758134308 * t60 + (p[t->tyreadr[i] +
          MAGGI_TYRE_QEZ4] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
          t60d);
    }
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e11) > 1.0) {
      y16 = 1.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y16d[nd] = 0.0;
      }
    } else {
      y16 = e11;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y16d[nd] = e11d[nd];
      }
    }
    et = y16;
    p7 = p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    t61 = p[t->tyreadr[i] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[i] + MAGGI_TYRE_LKY] / p7;
    p7inv = 1.0 / p7;
    br = t61 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ10] * bycy;
    dr = fz * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] * p7;
    t62 = 1.0 + a * a;
    t63 = sqrt(t62);
    c27 = 1.0 / (2.0 * t63);
    ca = 1.0 / t63;
    t63inv = 1.0 / t63;
    y17 = bt * ateq;
    t64 = atan(y17);
    c28 = 1.0 / (1.0 + y17 * y17);
    t65 = (1.0 - et) * y17 + et * t64;
    t66 = atan(t65);
    c29 = 1.0 / (1.0 + t65 * t65);
    t67 = p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * t66;
    t68 = cos(t67);
    c30 = -sin(t67);
    z0 = dt * t68 * ca;
    x5 = br * areq;
    t69 = 1.0 + x5 * x5;
    t70 = sqrt(t69);
    c31 = 1.0 / (2.0 * t70);
    t71 = 1.0 / t70;
    t70inv = 1.0 / t70;
    t72 = p[t->tyreadr[i] + MAGGI_TYRE_SSZ2] * fy / fz0;
    s = (p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] +
        p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0 * p[t->tyreadr[i] + MAGGI_TYRE_LS];
    slip_i4 = slip[i][4];
    t73 = slip_i4 / p[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED];
    inv2 = 1.0 / p[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED];
    way = tanh(t73);
    speed = slip_i4 / p[t->tyreadr[i] + MAGGI_TYRE_LONGVL];
    inv3 = 1.0 / p[t->tyreadr[i] + MAGGI_TYRE_LONGVL];
    t74 = p[t->tyreadr[i] + MAGGI_TYRE_QSX3] * fy / fz0;
    t75 = p[t->tyreadr[i] + MAGGI_TYRE_QSY2] * fx / fz0;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double brd, cad, drd, etd, p7d, sd, slip_i4d, speedd, t61d, t62d, t63d, t64d, t65d, t66d,
          t67d, t68d, t69d, t70d, t71d, t72d, t73d, t74d, t75d, wayd, x5d, y17d, z0d, z1d;

      etd = y16d[nd];
      p7d = pd[t->tyreadr[i] + MAGGI_TYRE_LMUY][nd];
      t61d = (pd[t->tyreadr[i] + MAGGI_TYRE_QBZ9][nd] * p[t->tyreadr[i] + MAGGI_TYRE_LKY] +
          p[t->tyreadr[i] + MAGGI_TYRE_QBZ9] * pd[t->tyreadr[i] + MAGGI_TYRE_LKY][nd] - t61 * p7d) *
          p7inv;
      brd = t61d + (pd[t->tyreadr[i] + MAGGI_TYRE_QBZ10][nd] * bycy + p[t->tyreadr[i] +
          MAGGI_TYRE_QBZ10] * bycyd[nd]);
      drd = ((fzd[nd] * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] *
          dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] +
          p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz) * gz) + fz * ((pd[t->tyreadr[i] +
          MAGGI_TYRE_QDZ6][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ7][nd] * dfz + p[t->tyreadr[i] +
          MAGGI_TYRE_QDZ7] * dfzd[nd])) * p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] +
          MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) * pd[t->tyreadr[i] +
          MAGGI_TYRE_LRES][nd] + ((pd[t->tyreadr[i] + MAGGI_TYRE_QDZ8][nd] + (pd[t->tyreadr[i] +
          MAGGI_TYRE_QDZ9][nd] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfzd[nd])) * gz +
          (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz) *
          gzd[nd]))) * p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] + fz * ((p[t->tyreadr[i] +
          MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[i] +
          MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] +
          MAGGI_TYRE_QDZ9] * dfz) * gz) * pd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS][nd]) * p7 +
          fz * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) *
          p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i]
          + MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] * p7d;
      t62d = ad[nd] * a + a * ad[nd];
      t63d = c27 * t62d;
      cad = -(ca * t63d * t63inv);
      /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
      y17d = btd[nd] * ateq + bt * ateqd[nd];
      t64d = c28 * y17d;
      t65d = -(etd * y17) + (1.0 - et) * y17d + (etd * t64 + et * t64d);
      t66d = c29 * t65d;
      t67d = pd[t->tyreadr[i] + MAGGI_TYRE_QCZ1][nd] * t66 + p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] *
          t66d;
      t68d = c30 * t67d;
      z0d = (dtd[nd] * t68 + dt * t68d) * ca + dt * t68 * cad;
      x5d = brd * areq + br * areqd[nd];
      t69d = x5d * x5 + x5 * x5d;
      t70d = c31 * t69d;
      t71d = -(t71 * t70d * t70inv);
      z1d = (drd * t71 + dr * t71d) * ca + dr * t71 * cad;
      t72d = (pd[t->tyreadr[i] + MAGGI_TYRE_SSZ2][nd] * fy + p[t->tyreadr[i] + MAGGI_TYRE_SSZ2] *
          fyd[nd] - t72 * fz0d[nd]) * fz0inv;
      sd = ((pd[t->tyreadr[i] + MAGGI_TYRE_SSZ1][nd] + t72d + ((pd[t->tyreadr[i] +
          MAGGI_TYRE_SSZ3][nd] + (pd[t->tyreadr[i] + MAGGI_TYRE_SSZ4][nd] * dfz + p[t->tyreadr[i] +
          MAGGI_TYRE_SSZ4] * dfzd[nd])) * gamma + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] +
          p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gammad[nd])) * r0 + (p[t->tyreadr[i] +
          MAGGI_TYRE_SSZ1] + t72 + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] +
          MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0d[nd]) * p[t->tyreadr[i] + MAGGI_TYRE_LS] +
          (p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] +
          p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0 * pd[t->tyreadr[i] +
          MAGGI_TYRE_LS][nd];
      slip_i4d = slipd[i][4][nd];
      t73d = (slip_i4d - t73 * pd[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED][nd]) * inv2;
      wayd = (1.0 - way * way) * t73d;
      speedd = (slip_i4d - speed * pd[t->tyreadr[i] + MAGGI_TYRE_LONGVL][nd]) * inv3;
      fd[i][0][nd] = fxd[nd];
      fd[i][1][nd] = fyd[nd];
      fd[i][2][nd] = fzd[nd];
      t74d = (pd[t->tyreadr[i] + MAGGI_TYRE_QSX3][nd] * fy + p[t->tyreadr[i] + MAGGI_TYRE_QSX3] *
          fyd[nd] - t74 * fz0d[nd]) * fz0inv;
      fd[i][3][nd] = (r0d[nd] * fz + r0 * fzd[nd]) * (p[t->tyreadr[i] + MAGGI_TYRE_QSX1] *
          p[t->tyreadr[i] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma + t74) *
          p[t->tyreadr[i] + MAGGI_TYRE_LMX]) + r0 * fz * (pd[t->tyreadr[i] + MAGGI_TYRE_QSX1][nd] *
          p[t->tyreadr[i] + MAGGI_TYRE_LVMX] + p[t->tyreadr[i] + MAGGI_TYRE_QSX1] * pd[t->tyreadr[i]
          + MAGGI_TYRE_LVMX][nd] + ((-(pd[t->tyreadr[i] + MAGGI_TYRE_QSX2][nd] * gamma) -
          p[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gammad[nd] + t74d) * p[t->tyreadr[i] +
          MAGGI_TYRE_LMX] + (-p[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma + t74) * pd[t->tyreadr[i] +
          MAGGI_TYRE_LMX][nd]));
      t75d = (pd[t->tyreadr[i] + MAGGI_TYRE_QSY2][nd] * fx + p[t->tyreadr[i] + MAGGI_TYRE_QSY2] *
          fxd[nd] - t75 * fz0d[nd]) * fz0inv;
      fd[i][4][nd] = (((-(wayd * r0) - way * r0d[nd]) * fz + -way * r0 * fzd[nd]) * (p[t->tyreadr[i]
          + MAGGI_TYRE_QSY1] + t75 + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way * speed +
          p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed * speed) + -way * r0 * fz *
          (pd[t->tyreadr[i] + MAGGI_TYRE_QSY1][nd] + t75d + ((pd[t->tyreadr[i] +
          MAGGI_TYRE_QSY3][nd] * way + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * wayd) * speed +
          p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way * speedd) + ((((pd[t->tyreadr[i] +
          MAGGI_TYRE_QSY4][nd] * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speedd) * speed +
          p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speedd) * speed + p[t->tyreadr[i] +
          MAGGI_TYRE_QSY4] * speed * speed * speedd) * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] *
          speed * speed * speed * speedd))) * p[t->tyreadr[i] + MAGGI_TYRE_LMY] + -way * r0 * fz *
          (p[t->tyreadr[i] + MAGGI_TYRE_QSY1] + t75 + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way *
          speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed * speed) *
          pd[t->tyreadr[i] + MAGGI_TYRE_LMY][nd];
      fd[i][5][nd] = -(z0d * (fy - g1)) - z0 * (fyd[nd] - g1d[nd]) + z1d + (sd * fx + s * fxd[nd]);
    }
  }
}

/* Rates of the coordinates on which wheels turn at which they roll freely, kappa = 0: with V the velocity of
 * the contact point on the carrier and w the velocity of the wheel by its coordinate
 *   v = V.t / (Re w.u) */
void maggi_rolling_dv(const maggi_topo *t, const double p[restrict t->np],
                      const double pd[restrict t->np][MAGGI_NDIR],
                      const double A[restrict t->nbody + 1][9],
                      const double Ad[restrict t->nbody + 1][9][MAGGI_NDIR],
                      const double b[restrict t->nbody][6],
                      const double bd[restrict t->nbody][6][MAGGI_NDIR],
                      const double r[restrict t->npoint][3],
                      const double rd[restrict t->npoint][3][MAGGI_NDIR],
                      const double Z[restrict t->nbody + 1][6],
                      const double Zd[restrict t->nbody + 1][6][MAGGI_NDIR],
                      double spin[restrict t->nwheel], double spind[restrict t->nwheel][MAGGI_NDIR],
                      int nbdirs)
{
  int adr, body, carrier, i, nd, road;
  double N0, N1, N2, T0, T1, T2, a00, a01, a02, along0, along1, along2, arm0, arm1, arm2, c0, c1,
      c2, c2_2, c3, c4, c5, c6, c7, c8, c9, fz, fz0, fz0inv, g0, g2, h00, h10, h11, n2, n2inv, n30,
      n31, n32, p2, p2inv, p3, p_road, p_road1, p_road1_2, p_road1_2inv, p_road1inv, p_road2,
      p_road3, p_road4, r2, ratio, re, rhov, s, sinv, t10, t11, t12, t13, t14, t15, t16, t17,
      t17inv, t2, t3, t4, t5, t5inv, t6, t7, t8, t9, u0, u1, u2, ua0, ua1, ua2, un0, un1, un2, v0,
      v1, v2, w0, w1, w2, w2_2, w2inv, wr0, wr1, wr2, x, x2, z0, z2, z2inv;
  double g0d[MAGGI_NDIR], g2d[MAGGI_NDIR], h00d[MAGGI_NDIR], h10d[MAGGI_NDIR], h11d[MAGGI_NDIR],
      u0d[MAGGI_NDIR], u1d[MAGGI_NDIR], u2d[MAGGI_NDIR], x2d[MAGGI_NDIR], xd[MAGGI_NDIR];

  (void)nbdirs;
  for (i = 0; i < t->nwheel; ++i) {
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
    c3 = 1.0 / (2.0 * n2);
    u0 = ua0 / n2;
    n2inv = 1.0 / n2;
    u1 = ua1 / n2;
    u2 = ua2 / n2;
    g0 = r[t->wheelpoint[i]][0] - r[t->roadpoint[road]][0];
    g2 = r[t->wheelpoint[i]][2] - r[t->roadpoint[road]][2];
    x2 = g0;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double a00d, a01d, a02d, n2d, t2d, ua0d, ua1d, ua2d;

      a00d = pd[t->wheelaxis[i]][nd];
      a01d = pd[t->wheelaxis[i] + 1][nd];
      a02d = pd[t->wheelaxis[i] + 2][nd];
      ua0d = Ad[body][0][nd] * a00 + A[body][0] * a00d + (Ad[body][1][nd] * a01 + A[body][1] * a01d)
          + (Ad[body][2][nd] * a02 + A[body][2] * a02d);
      ua1d = Ad[body][3][nd] * a00 + A[body][3] * a00d + (Ad[body][4][nd] * a01 + A[body][4] * a01d)
          + (Ad[body][5][nd] * a02 + A[body][5] * a02d);
      ua2d = Ad[body][6][nd] * a00 + A[body][6] * a00d + (Ad[body][7][nd] * a01 + A[body][7] * a01d)
          + (Ad[body][8][nd] * a02 + A[body][8] * a02d);
      t2d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
      n2d = c3 * t2d;
      u0d[nd] = (ua0d - u0 * n2d) * n2inv;
      u1d[nd] = (ua1d - u1 * n2d) * n2inv;
      u2d[nd] = (ua2d - u2 * n2d) * n2inv;
      g0d[nd] = rd[t->wheelpoint[i]][0][nd] - rd[t->roadpoint[road]][0][nd];
      g2d[nd] = rd[t->wheelpoint[i]][2][nd] - rd[t->roadpoint[road]][2][nd];
      /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
       * the centre down the disc meets it, n its normal; then down the disc to that plane,
       *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
       * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
      x2d[nd] = g0d[nd];
    }
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      h00 = p_road * x2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_roadd;

        p_roadd = pd[t->roadadr[road]][nd];
        h00d[nd] = p_roadd * x2 + p_road * x2d[nd];
      }
    } else {
      p_road1 = p[t->roadadr[road] + 1];
      t3 = 6.28318530717958647693 * x2 / p_road1;
      p_road1inv = 1.0 / p_road1;
      t4 = sin(t3);
      c4 = cos(t3);
      p_road2 = p[t->roadadr[road]];
      h00 = p_road2 * t4;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_road1d, p_road2d, t3d, t4d;

        p_road1d = pd[t->roadadr[road] + 1][nd];
        t3d = (6.28318530717958647693 * x2d[nd] - t3 * p_road1d) * p_road1inv;
        t4d = c4 * t3d;
        p_road2d = pd[t->roadadr[road]][nd];
        h00d[nd] = p_road2d * t4 + p_road2 * t4d;
      }
    }
    t5 = u0 * u0 + u1 * u1;
    t6 = u2 * u0 / t5;
    t5inv = 1.0 / t5;
    x = g0 + t6 * (g2 - h00);
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double t5d, t6d;

      t5d = u0d[nd] * u0 + u0 * u0d[nd] + (u1d[nd] * u1 + u1 * u1d[nd]);
      t6d = (u2d[nd] * u0 + u2 * u0d[nd] - t6 * t5d) * t5inv;
      xd[nd] = g0d[nd] + (t6d * (g2 - h00) + t6 * (g2d[nd] - h00d[nd]));
    }
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road3 = p[t->roadadr[road]];
      h10 = p_road3 * x;
      h11 = p_road3;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_road3d;

        p_road3d = pd[t->roadadr[road]][nd];
        h10d[nd] = p_road3d * x + p_road3 * xd[nd];
        h11d[nd] = p_road3d;
      }
    } else {
      p_road1_2 = p[t->roadadr[road] + 1];
      t7 = 6.28318530717958647693 * x / p_road1_2;
      p_road1_2inv = 1.0 / p_road1_2;
      t8 = sin(t7);
      c5 = cos(t7);
      p_road4 = p[t->roadadr[road]];
      h10 = p_road4 * t8;
      t9 = p_road4 * 6.28318530717958647693 / p_road1_2;
      t10 = 6.28318530717958647693 * x / p_road1_2;
      t11 = cos(t10);
      c6 = -sin(t10);
      h11 = t9 * t11;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_road1_2d, p_road4d, t10d, t11d, t7d, t8d, t9d;

        p_road1_2d = pd[t->roadadr[road] + 1][nd];
        t7d = (6.28318530717958647693 * xd[nd] - t7 * p_road1_2d) * p_road1_2inv;
        t8d = c5 * t7d;
        p_road4d = pd[t->roadadr[road]][nd];
        h10d[nd] = p_road4d * t8 + p_road4 * t8d;
        t9d = (p_road4d * 6.28318530717958647693 - t9 * p_road1_2d) * p_road1_2inv;
        t10d = (6.28318530717958647693 * xd[nd] - t10 * p_road1_2d) * p_road1_2inv;
        t11d = c6 * t10d;
        h11d[nd] = t9d * t11 + t9 * t11d;
      }
    }
    t12 = 1.0 + h11 * h11;
    s = sqrt(t12);
    c7 = 1.0 / (2.0 * s);
    n30 = -h11 / s;
    sinv = 1.0 / s;
    n31 = 0.0;
    n32 = 1.0 / s;
    c2 = u0 * n30 + u1 * n31 + u2 * n32;
    un0 = u1 * n32 - u2 * n31;
    un1 = u2 * n30 - u0 * n32;
    un2 = u0 * n31 - u1 * n30;
    t13 = un0 * un0 + un1 * un1 + un2 * un2;
    w2 = sqrt(t13);
    c8 = 1.0 / (2.0 * w2);
    r2 = ((g0 - x) * n30 + (g2 - h10) * n32) / w2;
    w2inv = 1.0 / w2;
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
    z2inv = 1.0 / z2;
    p2 = p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
    p3 = p[adr + MAGGI_TYRE_UNLOADED_RADIUS];
    fz = p2 * (p3 - z0) + p[adr + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
    fz0 = p[adr + MAGGI_TYRE_LFZO] * p[adr];
    ratio = fz / fz0;
    fz0inv = 1.0 / fz0;
    t14 = fz0 / p2;
    p2inv = 1.0 / p2;
    t15 = p[adr + MAGGI_TYRE_BREFF] * ratio;
    t16 = atan(t15);
    c9 = 1.0 / (1.0 + t15 * t15);
    re = p3 - t14 * (p[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_FREFF] * ratio);
    t17 = re * (b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2);
    t17inv = 1.0 / t17;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double N0d, N2d, T0d, T1d, T2d, along0d, along1d, along2d, arm0d, arm1d, arm2d, c0d, c1d,
          c2_2d, c2d, fz0d, fzd, n30d, n32d, p2d, p3d, r2d, ratiod, red, rhovd, sd, t12d, t13d,
          t14d, t15d, t16d, t17d, un0d, un1d, un2d, v0d, v1d, v2d, w0d, w1d, w2_2d, w2d, wr0d, wr1d,
          wr2d, z0d, z2d;

      t12d = h11d[nd] * h11 + h11 * h11d[nd];
      sd = c7 * t12d;
      n30d = (-h11d[nd] - n30 * sd) * sinv;
      n32d = -(n32 * sd * sinv);
      c2d = u0d[nd] * n30 + u0 * n30d + u1d[nd] * n31 + (u2d[nd] * n32 + u2 * n32d);
      un0d = u1d[nd] * n32 + u1 * n32d - u2d[nd] * n31;
      un1d = u2d[nd] * n30 + u2 * n30d - (u0d[nd] * n32 + u0 * n32d);
      un2d = u0d[nd] * n31 - (u1d[nd] * n30 + u1 * n30d);
      t13d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
      w2d = c8 * t13d;
      r2d = ((g0d[nd] - xd[nd]) * n30 + (g0 - x) * n30d + ((g2d[nd] - h10d[nd]) * n32 + (g2 - h10) *
          n32d) - r2 * w2d) * w2inv;
      along0d = (un0d - along0 * w2d) * w2inv;
      along1d = (un1d - along1 * w2d) * w2inv;
      along2d = (un2d - along2 * w2d) * w2inv;
      arm0d = (r2d * (c2 * u0 - n30) + r2 * (c2d * u0 + c2 * u0d[nd] - n30d) - arm0 * w2d) * w2inv;
      T0d = along0d;
      N0d = n30d;
      arm1d = (r2d * (c2 * u1 - n31) + r2 * (c2d * u1 + c2 * u1d[nd]) - arm1 * w2d) * w2inv;
      T1d = along1d;
      arm2d = (r2d * (c2 * u2 - n32) + r2 * (c2d * u2 + c2 * u2d[nd] - n32d) - arm2 * w2d) * w2inv;
      T2d = along2d;
      N2d = n32d;
      z0d = r2d;
      z2d = w2d;
      c0d = rd[t->wheelpoint[i]][0][nd] + arm0d;
      c1d = rd[t->wheelpoint[i]][1][nd] + arm1d;
      c2_2d = rd[t->wheelpoint[i]][2][nd] + arm2d;
      wr0d = Zd[carrier][3][nd];
      wr1d = Zd[carrier][4][nd];
      wr2d = Zd[carrier][5][nd];
      w0d = wr1d * c2_2 + wr1 * c2_2d - (wr2d * c1 + wr2 * c1d);
      w1d = wr2d * c0 + wr2 * c0d - (wr0d * c2_2 + wr0 * c2_2d);
      w2_2d = wr0d * c1 + wr0 * c1d - (wr1d * c0 + wr1 * c0d);
      v0d = Zd[carrier][0][nd] + w0d;
      v1d = Zd[carrier][1][nd] + w1d;
      v2d = Zd[carrier][2][nd] + w2_2d;
      rhovd = (-(v0d * N0 + v0 * N0d + v1d * N1 + (v2d * N2 + v2 * N2d)) - rhov * z2d) * z2inv;
      p2d = pd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS][nd];
      p3d = pd[adr + MAGGI_TYRE_UNLOADED_RADIUS][nd];
      fzd = p2d * (p3 - z0) + p2 * (p3d - z0d) + (pd[adr + MAGGI_TYRE_VERTICAL_DAMPING][nd] * rhov +
          p[adr + MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
      fz0d = pd[adr + MAGGI_TYRE_LFZO][nd] * p[adr] + p[adr + MAGGI_TYRE_LFZO] * pd[adr][nd];
      ratiod = (fzd - ratio * fz0d) * fz0inv;
      t14d = (fz0d - t14 * p2d) * p2inv;
      t15d = pd[adr + MAGGI_TYRE_BREFF][nd] * ratio + p[adr + MAGGI_TYRE_BREFF] * ratiod;
      t16d = c9 * t15d;
      red = p3d - (t14d * (p[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_FREFF] * ratio) +
          t14 * (pd[adr + MAGGI_TYRE_DREFF][nd] * t16 + p[adr + MAGGI_TYRE_DREFF] * t16d + (pd[adr +
          MAGGI_TYRE_FREFF][nd] * ratio + p[adr + MAGGI_TYRE_FREFF] * ratiod)));
      t17d = red * (b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2) + re * (bd[body][3][nd] *
          u0 + b[body][3] * u0d[nd] + (bd[body][4][nd] * u1 + b[body][4] * u1d[nd]) +
          (bd[body][5][nd] * u2 + b[body][5] * u2d[nd]));
      spind[i][nd] = (v0d * T0 + v0 * T0d + (v1d * T1 + v1 * T1d) + (v2d * T2 + v2 * T2d) - spin[i]
          * t17d) * t17inv;
    }
  }
}
