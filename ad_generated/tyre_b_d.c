/* Tangent of the adjoint of core/kernel/tyre.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* the formula of every tyre at a slip of its own */
void maggi_tyres_b_d(const maggi_topo *t, const double p[restrict t->np],
                     const double pd[restrict t->np], double pb[restrict t->np],
                     double pbd[restrict t->np], const double slip[restrict t->ntyre][5],
                     const double slipd[restrict t->ntyre][5], double slipb[restrict t->ntyre][5],
                     double slipbd[restrict t->ntyre][5], double f[restrict t->ntyre][6],
                     double fd[restrict t->ntyre][6], double fb[restrict t->ntyre][6],
                     double fbd[restrict t->ntyre][6])
{
  int i;
  double a, ab, abd, ad, ar, arb, arbd, ard, areq, areqb, areqbd, areqd, at, atb, atbd, atd, ateq,
      ateqb, ateqbd, ateqd, ay, ayb, aybd, ayd, br, brb, brbd, brd, bt, btb, btbd, btd, bx, bxb,
      bxbd, bxd, by, byb, bybd, bycy, bycyb, bycybd, bycyd, byd, ca, cab, cabd, cad, cx, cxb, cxbd,
      cxd, cy, cyb, cybd, cyd, dfz, dfzb, dfzbd, dfzd, dr, drb, drbd, drd, dt, dtb, dtbd, dtd, dv,
      dvb, dvbd, dvd, dx, dxb, dxbd, dxd, dy, dyb, dybd, dyd, e, e10, e10b, e10bd, e10d, e11, e11b,
      e11bd, e11d, e2, e2b, e2bd, e2d, e3, e3b, e3bd, e3d, e4, e4b, e4bd, e4d, e5, e5b, e5bd, e5d,
      e6, e6b, e6bd, e6d, e7, e7b, e7bd, e7d, e8, e8b, e8bd, e8d, e9, e9b, e9bd, e9d, eb, ebd, ed,
      et, etb, etbd, etd, ex, exb, exbd, exd, ey, eyb, eybd, eyd, fx, fxb, fxbd, fxd, fy, fyb, fybd,
      fyd, fz, fz0, fz0_2, fz0_2b, fz0_2bd, fz0_2d, fz0_3, fz0_3b, fz0_3bd, fz0_3d, fz0b, fz0bd,
      fz0d, fzb, fzbd, fzd, g0, g0b, g0bd, g0d, g1, g1b, g1bd, g1d, gamma, gammab, gammabd, gammad,
      gx, gxb, gxbd, gxd, gy, gyb, gybd, gyd, gz, gzb, gzbd, gzd, kappa, kappab, kappabd, kappad,
      kx, kxb, kxbd, kxd, mux, muxb, muxbd, muxd, muy, muy2, muy2b, muy2bd, muy2d, muyb, muybd,
      muyd, p2, p2b, p2bd, p2d, p3, p3b, p3bd, p3d, p4, p4b, p4bd, p4d, p5, p5b, p5bd, p5d, p6, p6b,
      p6bd, p6d, p7, p7b, p7bd, p7d, r0, r0b, r0bd, r0d, ratio, ratiob, ratiobd, ratiod, s, s2, s2b,
      s2bd, s2d, sb, sbd, sd, shift, shiftb, shiftbd, shiftd, shy, shyb, shybd, shyd, slip_i4,
      slip_i4b, slip_i4bd, slip_i4d, speed, speedb, speedbd, speedd, stiff, stiff2, stiff2b,
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
      t74d, t75, t75b, t75bd, t75d, t7b, t7bd, t7d, t8, t8b, t8bd, t8d, t9, t9b, t9bd, t9d, tb10,
      tb100, tb100d, tb101, tb101d, tb102, tb102d, tb103, tb103d, tb104, tb104d, tb105, tb105d,
      tb106, tb106d, tb107, tb107d, tb108, tb108d, tb109, tb109d, tb10d, tb11, tb11d, tb12, tb12d,
      tb13, tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d, tb17, tb17d, tb18, tb18d, tb19, tb19d,
      tb2, tb20, tb20d, tb21, tb21d, tb22, tb22d, tb23, tb23d, tb24, tb24d, tb25, tb25d, tb26,
      tb26d, tb27, tb27d, tb28, tb28d, tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31, tb31d, tb32,
      tb32d, tb33, tb33d, tb34, tb34d, tb35, tb35d, tb36, tb36d, tb37, tb37d, tb38, tb38d, tb39,
      tb39d, tb3d, tb4, tb40, tb40d, tb41, tb41d, tb42, tb42d, tb43, tb43d, tb44, tb44d, tb45,
      tb45d, tb46, tb46d, tb47, tb47d, tb48, tb48d, tb49, tb49d, tb4d, tb5, tb50, tb50d, tb51,
      tb51d, tb52, tb52d, tb53, tb53d, tb54, tb54d, tb55, tb55d, tb56, tb56d, tb57, tb57d, tb58,
      tb58d, tb59, tb59d, tb5d, tb6, tb60, tb60d, tb61, tb61d, tb62, tb62d, tb63, tb63d, tb64,
      tb64d, tb65, tb65d, tb66, tb66d, tb67, tb67d, tb68, tb68d, tb69, tb69d, tb6d, tb7, tb70,
      tb70d, tb71, tb71d, tb72, tb72d, tb73, tb73d, tb74, tb74d, tb75, tb75d, tb76, tb76d, tb77,
      tb77d, tb78, tb78d, tb79, tb79d, tb7d, tb8, tb80, tb80d, tb81, tb81d, tb82, tb82d, tb83,
      tb83d, tb84, tb84d, tb85, tb85d, tb86, tb86d, tb87, tb87d, tb88, tb88d, tb89, tb89d, tb8d,
      tb9, tb90, tb90d, tb91, tb91d, tb92, tb92d, tb93, tb93d, tb94, tb94d, tb95, tb95d, tb96,
      tb96d, tb97, tb97d, tb98, tb98d, tb99, tb99d, tb9d, way, wayb, waybd, wayd, x0, x0b, x0bd,
      x0d, x1, x1b, x1bd, x1d, x2, x2b, x2bd, x2d, x3, x3b, x3bd, x3d, x4, x4b, x4bd, x4d, x5, x5b,
      x5bd, x5d, y0, y0b, y0bd, y0d, y1, y10, y10b, y10bd, y10d, y11, y11b, y11bd, y11d, y12, y12b,
      y12bd, y12d, y13, y13b, y13bd, y13d, y14, y14b, y14bd, y14d, y15, y15b, y15bd, y15d, y16,
      y16b, y16bd, y16d, y17, y17b, y17bd, y17d, y1b, y1bd, y1d, y2, y2_2, y2_2b, y2_2bd, y2_2d,
      y2b, y2bd, y2d, y3, y3_2, y3_2b, y3_2bd, y3_2d, y3b, y3bd, y3d, y4, y4_2, y4_2b, y4_2bd,
      y4_2d, y4b, y4bd, y4d, y5, y5b, y5bd, y5d, y6, y6b, y6bd, y6d, y7, y7b, y7bd, y7d, y8, y8b,
      y8bd, y8d, y9, y9b, y9bd, y9d, z0, z0b, z0bd, z0d, z1b, z1bd, z2, z2b, z2bd, z2d, z3, z3b,
      z3bd, z3d, z4, z4b, z4bd, z4d;

  for (i = t->ntyre - 1; i >= 0; --i) {
    kappa = slip[i][0];
    kappad = slipd[i][0];
    a = slip[i][1];
    ad = slipd[i][1];
    gamma = slip[i][2];
    gammad = slipd[i][2];
    fz = f[i][2];
    fzd = fd[i][2];
    fz0 = p[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]];
    fz0d = pd[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]] + p[t->tyreadr[i] +
        MAGGI_TYRE_LFZO] * pd[t->tyreadr[i]];
    r0 = p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS];
    r0d = pd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS];
    dfz = (fz - fz0) / fz0;
    dfzd = (fzd - fz0d - dfz * fz0d) * (1.0 / fz0);
    kx = kappa + (p[t->tyreadr[i] + MAGGI_TYRE_PHX1] + p[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LHX];
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
    bxd = (stiffd - bx * t4d) * (1.0 / t4);
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
    y4d = bxd * kx + bx * kxd;
    t5 = atan(y4);
    t5d = 1.0 / (1.0 + y4 * y4) * y4d;
    t6 = (1.0 - ex) * y4 + ex * t5;
    t6d = -(exd * y4) + (1.0 - ex) * y4d + (exd * t5 + ex * t5d);
    t7 = atan(t6);
    t7d = 1.0 / (1.0 + t6 * t6) * t6d;
    t8 = cx * t7;
    t8d = cxd * t7 + cx * t7d;
    t9 = sin(t8);
    t9d = cos(t8) * t8d;
    x0 = dx * t9 + svx;
    x0d = dxd * t9 + dx * t9d + svxd;
    x1 = stiff;
    x1d = stiffd;
    fz0_2 = p[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]];
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
    z2d = (fzd - z2 * t10d) * (1.0 / t10);
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
      z3d = (gyd * gy + gy * gyd - z3 * t11d) * (1.0 / t11);
      y7 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
      y7d = (0.125 * p2d * z3 + 0.125 * p2 * z3d) * (15.0 + z3 * (-10.0 + 3.0 * z3)) + 0.125 * p2 *
          z3 * (z3d * (-10.0 + 3.0 * z3) + z3 * (3.0 * z3d));
    }
    t12 = 1.0 + z2 * z2;
    t12d = z2d * z2 + z2 * z2d;
    t13 = 2.0 * z2 / t12;
    t13d = (2.0 * z2d - t13 * t12d) * (1.0 / t12);
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
    byd = (stiff2d - by * t14d) * (1.0 / t14);
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
    y8d = byd * ay + by * ayd;
    t15 = atan(y8);
    t15d = 1.0 / (1.0 + y8 * y8) * y8d;
    t16 = (1.0 - ey) * y8 + ey * t15;
    t16d = -(eyd * y8) + (1.0 - ey) * y8d + (eyd * t15 + ey * t15d);
    t17 = atan(t16);
    t17d = 1.0 / (1.0 + t16 * t16) * t16d;
    t18 = cy * t17;
    t18d = cyd * t17 + cy * t17d;
    t19 = sin(t18);
    t19d = cos(t18) * t18d;
    y0 = dy * t19 + svy;
    y0d = dyd * t19 + dy * t19d + svyd;
    y1 = stiff2;
    y1d = stiff2d;
    y2_2 = muy;
    y2_2d = muyd;
    y3_2 = by * cy;
    y3_2d = byd * cy + by * cyd;
    t20 = svy / stiff2;
    t20d = (svyd - t20 * stiff2d) * (1.0 / stiff2);
    y4_2 = shy + t20;
    y4_2d = shyd + t20d;
    muy2 = y2_2;
    muy2d = y2_2d;
    x2 = p[t->tyreadr[i] + MAGGI_TYRE_RBY2] * (a - p[t->tyreadr[i] + MAGGI_TYRE_RBY3]);
    x2d = pd[t->tyreadr[i] + MAGGI_TYRE_RBY2] * (a - p[t->tyreadr[i] + MAGGI_TYRE_RBY3]) +
        p[t->tyreadr[i] + MAGGI_TYRE_RBY2] * (ad - pd[t->tyreadr[i] + MAGGI_TYRE_RBY3]);
    t21 = 1.0 + x2 * x2;
    t21d = x2d * x2 + x2 * x2d;
    t22 = sqrt(t21);
    t22d = 1.0 / (2.0 * t22) * t21d;
    t23 = 1.0 / t22;
    t23d = -(t23 * t22d * (1.0 / t22));
    stiff3 = p[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23 * p[t->tyreadr[i] + MAGGI_TYRE_LYKA];
    stiff3d = (pd[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23 + p[t->tyreadr[i] + MAGGI_TYRE_RBY1] *
        t23d) * p[t->tyreadr[i] + MAGGI_TYRE_LYKA] + p[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23 *
        pd[t->tyreadr[i] + MAGGI_TYRE_LYKA];
    e8 = p[t->tyreadr[i] + MAGGI_TYRE_REY1] + p[t->tyreadr[i] + MAGGI_TYRE_REY2] * dfz;
    e8d = pd[t->tyreadr[i] + MAGGI_TYRE_REY1] + (pd[t->tyreadr[i] + MAGGI_TYRE_REY2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_REY2] * dfzd);
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
    t25d = 1.0 / (2.0 * t25) * t24d;
    t26 = 1.0 / t25;
    t26d = -(t26 * t25d * (1.0 / t25));
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
    y10d = stiff3d * (kappa + s2) + stiff3 * (kappad + s2d);
    y11 = stiff3 * s2;
    y11d = stiff3d * s2 + stiff3 * s2d;
    t27 = atan(y10);
    t27d = 1.0 / (1.0 + y10 * y10) * y10d;
    t28 = (1.0 - e7) * y10 + e7 * t27;
    t28d = -(e7d * y10) + (1.0 - e7) * y10d + (e7d * t27 + e7 * t27d);
    t29 = atan(t28);
    t29d = 1.0 / (1.0 + t28 * t28) * t28d;
    p3 = p[t->tyreadr[i] + MAGGI_TYRE_RCY1];
    p3d = pd[t->tyreadr[i] + MAGGI_TYRE_RCY1];
    t30 = p3 * t29;
    t30d = p3d * t29 + p3 * t29d;
    t31 = cos(t30);
    t31d = -(sin(t30) * t30d);
    t32 = atan(y11);
    t32d = 1.0 / (1.0 + y11 * y11) * y11d;
    t33 = (1.0 - e7) * y11 + e7 * t32;
    t33d = -(e7d * y11) + (1.0 - e7) * y11d + (e7d * t32 + e7 * t32d);
    t34 = atan(t33);
    t34d = 1.0 / (1.0 + t33 * t33) * t33d;
    t35 = p3 * t34;
    t35d = p3d * t34 + p3 * t34d;
    t36 = cos(t35);
    t36d = -(sin(t35) * t35d);
    g0 = t31 / t36;
    g0d = (t31d - g0 * t36d) * (1.0 / t36);
    t37 = p[t->tyreadr[i] + MAGGI_TYRE_RVY6] * kappa;
    t37d = pd[t->tyreadr[i] + MAGGI_TYRE_RVY6] * kappa + p[t->tyreadr[i] + MAGGI_TYRE_RVY6] *
        kappad;
    t38 = atan(t37);
    t38d = 1.0 / (1.0 + t37 * t37) * t37d;
    t39 = p[t->tyreadr[i] + MAGGI_TYRE_RVY5] * t38;
    t39d = pd[t->tyreadr[i] + MAGGI_TYRE_RVY5] * t38 + p[t->tyreadr[i] + MAGGI_TYRE_RVY5] * t38d;
    t40 = sin(t39);
    t40d = cos(t39) * t39d;
    g1 = dv * t40 * p[t->tyreadr[i] + MAGGI_TYRE_LVYKA];
    g1d = (dvd * t40 + dv * t40d) * p[t->tyreadr[i] + MAGGI_TYRE_LVYKA] + dv * t40 *
        pd[t->tyreadr[i] + MAGGI_TYRE_LVYKA];
    x4 = p[t->tyreadr[i] + MAGGI_TYRE_RBX2] * kappa;
    x4d = pd[t->tyreadr[i] + MAGGI_TYRE_RBX2] * kappa + p[t->tyreadr[i] + MAGGI_TYRE_RBX2] * kappad;
    t41 = 1.0 + x4 * x4;
    t41d = x4d * x4 + x4 * x4d;
    t42 = sqrt(t41);
    t42d = 1.0 / (2.0 * t42) * t41d;
    t43 = 1.0 / t42;
    t43d = -(t43 * t42d * (1.0 / t42));
    stiff4 = p[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43 * p[t->tyreadr[i] + MAGGI_TYRE_LXAL];
    stiff4d = (pd[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43 + p[t->tyreadr[i] + MAGGI_TYRE_RBX1] *
        t43d) * p[t->tyreadr[i] + MAGGI_TYRE_LXAL] + p[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43 *
        pd[t->tyreadr[i] + MAGGI_TYRE_LXAL];
    e10 = p[t->tyreadr[i] + MAGGI_TYRE_REX1] + p[t->tyreadr[i] + MAGGI_TYRE_REX2] * dfz;
    e10d = pd[t->tyreadr[i] + MAGGI_TYRE_REX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_REX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_REX2] * dfzd);
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
    y13d = stiff4d * (a + p4) + stiff4 * (ad + p4d);
    y14 = stiff4 * p4;
    y14d = stiff4d * p4 + stiff4 * p4d;
    t44 = atan(y13);
    t44d = 1.0 / (1.0 + y13 * y13) * y13d;
    t45 = (1.0 - e9) * y13 + e9 * t44;
    t45d = -(e9d * y13) + (1.0 - e9) * y13d + (e9d * t44 + e9 * t44d);
    t46 = atan(t45);
    t46d = 1.0 / (1.0 + t45 * t45) * t45d;
    p5 = p[t->tyreadr[i] + MAGGI_TYRE_RCX1];
    p5d = pd[t->tyreadr[i] + MAGGI_TYRE_RCX1];
    t47 = p5 * t46;
    t47d = p5d * t46 + p5 * t46d;
    t48 = cos(t47);
    t48d = -(sin(t47) * t47d);
    t49 = atan(y14);
    t49d = 1.0 / (1.0 + y14 * y14) * y14d;
    t50 = (1.0 - e9) * y14 + e9 * t49;
    t50d = -(e9d * y14) + (1.0 - e9) * y14d + (e9d * t49 + e9 * t49d);
    t51 = atan(t50);
    t51d = 1.0 / (1.0 + t50 * t50) * t50d;
    t52 = p5 * t51;
    t52d = p5d * t51 + p5 * t51d;
    t53 = cos(t52);
    t53d = -(sin(t52) * t52d);
    t54 = t48 / t53;
    t54d = (t48d - t54 * t53d) * (1.0 / t53);
    fx = f[i][0];
    fxd = fd[i][0];
    fy = f[i][1];
    fyd = fd[i][1];
    ratio = x1 * kappa / y1;
    ratiod = (x1d * kappa + x1 * kappad - ratio * y1d) * (1.0 / y1);
    bycy = y3_2;
    bycyd = y3_2d;
    shift = y4_2;
    shiftd = y4_2d;
    fz0_3 = p[t->tyreadr[i] + MAGGI_TYRE_LFZO] * p[t->tyreadr[i]];
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
    ateqd = 1.0 / (2.0 * ateq) * t55d;
    t56 = ar * ar + ratio * ratio + 1e-24;
    t56d = ard * ar + ar * ard + (ratiod * ratio + ratio * ratiod);
    areq = sqrt(t56);
    areqd = 1.0 / (2.0 * areq) * t56d;
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
      z4d = (gzd * gz + gz * gzd - z4 * t57d) * (1.0 / t57);
      y15 = 0.125 * p6 * z4 * (15.0 + z4 * (-10.0 + 3.0 * z4));
      y15d = (0.125 * p6d * z4 + 0.125 * p6 * z4d) * (15.0 + z4 * (-10.0 + 3.0 * z4)) + 0.125 * p6 *
          z4 * (z4d * (-10.0 + 3.0 * z4) + z4 * (3.0 * z4d));
    }
    bt = (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4]
        * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15) * p[t->tyreadr[i] + MAGGI_TYRE_LKY] /
        p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
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
        MAGGI_TYRE_LKY] - bt * pd[t->tyreadr[i] + MAGGI_TYRE_LMUY]) * (1.0 / p[t->tyreadr[i] +
        MAGGI_TYRE_LMUY]);
    t58 = p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_3;
    t58d = (pd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] - t58 * fz0_3d) * (1.0 / fz0_3);
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
    t60d = 1.0 / (1.0 + t59 * t59) * t59d;
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
    t61d = (pd[t->tyreadr[i] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[i] + MAGGI_TYRE_LKY] +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ9] * pd[t->tyreadr[i] + MAGGI_TYRE_LKY] - t61 * p7d) * (1.0
        / p7);
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
    t63d = 1.0 / (2.0 * t63) * t62d;
    ca = 1.0 / t63;
    cad = -(ca * t63d * (1.0 / t63));
    y17 = bt * ateq;
    y17d = btd * ateq + bt * ateqd;
    t64 = atan(y17);
    t64d = 1.0 / (1.0 + y17 * y17) * y17d;
    t65 = (1.0 - et) * y17 + et * t64;
    t65d = -(etd * y17) + (1.0 - et) * y17d + (etd * t64 + et * t64d);
    t66 = atan(t65);
    t66d = 1.0 / (1.0 + t65 * t65) * t65d;
    t67 = p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * t66;
    t67d = pd[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * t66 + p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] * t66d;
    t68 = cos(t67);
    t68d = -(sin(t67) * t67d);
    z0 = dt * t68 * ca;
    z0d = (dtd * t68 + dt * t68d) * ca + dt * t68 * cad;
    x5 = br * areq;
    x5d = brd * areq + br * areqd;
    t69 = 1.0 + x5 * x5;
    t69d = x5d * x5 + x5 * x5d;
    t70 = sqrt(t69);
    t70d = 1.0 / (2.0 * t70) * t69d;
    t71 = 1.0 / t70;
    t71d = -(t71 * t70d * (1.0 / t70));
    t72 = p[t->tyreadr[i] + MAGGI_TYRE_SSZ2] * fy / fz0;
    t72d = (pd[t->tyreadr[i] + MAGGI_TYRE_SSZ2] * fy + p[t->tyreadr[i] + MAGGI_TYRE_SSZ2] * fyd -
        t72 * fz0d) * (1.0 / fz0);
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
    t73d = (slip_i4d - t73 * pd[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED]) * (1.0 / p[t->tyreadr[i] +
        MAGGI_TYRE_LOW_SPEED]);
    way = tanh(t73);
    wayd = (1.0 - way * way) * t73d;
    speed = slip_i4 / p[t->tyreadr[i] + MAGGI_TYRE_LONGVL];
    speedd = (slip_i4d - speed * pd[t->tyreadr[i] + MAGGI_TYRE_LONGVL]) * (1.0 / p[t->tyreadr[i] +
        MAGGI_TYRE_LONGVL]);
    t74 = p[t->tyreadr[i] + MAGGI_TYRE_QSX3] * fy / fz0;
    t74d = (pd[t->tyreadr[i] + MAGGI_TYRE_QSX3] * fy + p[t->tyreadr[i] + MAGGI_TYRE_QSX3] * fyd -
        t74 * fz0d) * (1.0 / fz0);
    t75 = p[t->tyreadr[i] + MAGGI_TYRE_QSY2] * fx / fz0;
    t75d = (pd[t->tyreadr[i] + MAGGI_TYRE_QSY2] * fx + p[t->tyreadr[i] + MAGGI_TYRE_QSY2] * fxd -
        t75 * fz0d) * (1.0 / fz0);
    tb108 = fb[i][5];
    tb108d = fbd[i][5];
    fb[i][5] = 0.0;
    fbd[i][5] = 0.0;
    z0b = -(tb108 * (fy - g1));
    z0bd = -(tb108d * (fy - g1) + tb108 * (fyd - g1d));
    tb109 = tb108 * z0;
    tb109d = tb108d * z0 + tb108 * z0d;
    fyb = -tb109;
    fybd = -tb109d;
    g1b = tb109;
    g1bd = tb109d;
    z1b = tb108;
    z1bd = tb108d;
    sb = tb108 * fx;
    sbd = tb108d * fx + tb108 * fxd;
    fxb = tb108 * s;
    fxbd = tb108d * s + tb108 * sd;
    tb99 = fb[i][4];
    tb99d = fbd[i][4];
    fb[i][4] = 0.0;
    fbd[i][4] = 0.0;
    tb100 = tb99 * p[t->tyreadr[i] + MAGGI_TYRE_LMY];
    tb100d = tb99d * p[t->tyreadr[i] + MAGGI_TYRE_LMY] + tb99 * pd[t->tyreadr[i] + MAGGI_TYRE_LMY];
    tb101 = tb100 * (p[t->tyreadr[i] + MAGGI_TYRE_QSY1] + t75 + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] *
        way * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed * speed);
    tb101d = tb100d * (p[t->tyreadr[i] + MAGGI_TYRE_QSY1] + t75 + p[t->tyreadr[i] + MAGGI_TYRE_QSY3]
        * way * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed * speed) + tb100
        * (pd[t->tyreadr[i] + MAGGI_TYRE_QSY1] + t75d + ((pd[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way
        + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * wayd) * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] *
        way * speedd) + ((((pd[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed + p[t->tyreadr[i] +
        MAGGI_TYRE_QSY4] * speedd) * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speedd) *
        speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speedd) * speed +
        p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed * speedd));
    tb102 = tb101 * fz;
    tb102d = tb101d * fz + tb101 * fzd;
    wayb = -(tb102 * r0);
    waybd = -(tb102d * r0 + tb102 * r0d);
    r0b = -(tb102 * way);
    r0bd = -(tb102d * way + tb102 * wayd);
    fzb = tb101 * (-way * r0);
    fzbd = tb101d * (-way * r0) + tb101 * (-(wayd * r0) - way * r0d);
    tb103 = tb100 * (-way * r0 * fz);
    tb103d = tb100d * (-way * r0 * fz) + tb100 * ((-(wayd * r0) - way * r0d) * fz + -way * r0 *
        fzd);
    pb[t->tyreadr[i] + MAGGI_TYRE_QSY1] += tb103;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QSY1] += tb103d;
    t75b = tb103;
    t75bd = tb103d;
    tb104 = tb103 * speed;
    tb104d = tb103d * speed + tb103 * speedd;
    pb[t->tyreadr[i] + MAGGI_TYRE_QSY3] += tb104 * way;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QSY3] += tb104d * way + tb104 * wayd;
    wayb += tb104 * p[t->tyreadr[i] + MAGGI_TYRE_QSY3];
    waybd += tb104d * p[t->tyreadr[i] + MAGGI_TYRE_QSY3] + tb104 * pd[t->tyreadr[i] +
        MAGGI_TYRE_QSY3];
    speedb = tb103 * (p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way);
    speedbd = tb103d * (p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way) + tb103 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_QSY3] * way + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * wayd);
    tb105 = tb103 * speed;
    tb105d = tb103d * speed + tb103 * speedd;
    tb106 = tb105 * speed;
    tb106d = tb105d * speed + tb105 * speedd;
    tb107 = tb106 * speed;
    tb107d = tb106d * speed + tb106 * speedd;
    pb[t->tyreadr[i] + MAGGI_TYRE_QSY4] += tb107 * speed;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QSY4] += tb107d * speed + tb107 * speedd;
    speedb += tb107 * p[t->tyreadr[i] + MAGGI_TYRE_QSY4];
    speedbd += tb107d * p[t->tyreadr[i] + MAGGI_TYRE_QSY4] + tb107 * pd[t->tyreadr[i] +
        MAGGI_TYRE_QSY4];
    speedb += tb106 * (p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed);
    speedbd += tb106d * (p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed) + tb106 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_QSY4] * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speedd);
    speedb += tb105 * (p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed);
    speedbd += tb105d * (p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed) + tb105 *
        ((pd[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speedd)
        * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speedd);
    speedb += tb103 * (p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed);
    speedbd += tb103d * (p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed) + tb103 *
        (((pd[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] *
        speedd) * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speedd) * speed +
        p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speedd);
    pb[t->tyreadr[i] + MAGGI_TYRE_LMY] += tb99 * (-way * r0 * fz * (p[t->tyreadr[i] +
        MAGGI_TYRE_QSY1] + t75 + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way * speed + p[t->tyreadr[i]
        + MAGGI_TYRE_QSY4] * speed * speed * speed * speed));
    pbd[t->tyreadr[i] + MAGGI_TYRE_LMY] += tb99d * (-way * r0 * fz * (p[t->tyreadr[i] +
        MAGGI_TYRE_QSY1] + t75 + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way * speed + p[t->tyreadr[i]
        + MAGGI_TYRE_QSY4] * speed * speed * speed * speed)) + tb99 * (((-(wayd * r0) - way * r0d) *
        fz + -way * r0 * fzd) * (p[t->tyreadr[i] + MAGGI_TYRE_QSY1] + t75 + p[t->tyreadr[i] +
        MAGGI_TYRE_QSY3] * way * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed
        * speed) + -way * r0 * fz * (pd[t->tyreadr[i] + MAGGI_TYRE_QSY1] + t75d + ((pd[t->tyreadr[i]
        + MAGGI_TYRE_QSY3] * way + p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * wayd) * speed +
        p[t->tyreadr[i] + MAGGI_TYRE_QSY3] * way * speedd) + ((((pd[t->tyreadr[i] + MAGGI_TYRE_QSY4]
        * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speedd) * speed + p[t->tyreadr[i] +
        MAGGI_TYRE_QSY4] * speed * speedd) * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed *
        speed * speedd) * speed + p[t->tyreadr[i] + MAGGI_TYRE_QSY4] * speed * speed * speed *
        speedd)));
    tb98 = t75b / fz0;
    tb98d = (t75bd - tb98 * fz0d) * (1.0 / fz0);
    pb[t->tyreadr[i] + MAGGI_TYRE_QSY2] += tb98 * fx;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QSY2] += tb98d * fx + tb98 * fxd;
    fxb += tb98 * p[t->tyreadr[i] + MAGGI_TYRE_QSY2];
    fxbd += tb98d * p[t->tyreadr[i] + MAGGI_TYRE_QSY2] + tb98 * pd[t->tyreadr[i] + MAGGI_TYRE_QSY2];
    fz0b = -(tb98 * t75);
    fz0bd = -(tb98d * t75 + tb98 * t75d);
    tb94 = fb[i][3];
    tb94d = fbd[i][3];
    fb[i][3] = 0.0;
    fbd[i][3] = 0.0;
    tb95 = tb94 * (p[t->tyreadr[i] + MAGGI_TYRE_QSX1] * p[t->tyreadr[i] + MAGGI_TYRE_LVMX] +
        (-p[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma + t74) * p[t->tyreadr[i] + MAGGI_TYRE_LMX]);
    tb95d = tb94d * (p[t->tyreadr[i] + MAGGI_TYRE_QSX1] * p[t->tyreadr[i] + MAGGI_TYRE_LVMX] +
        (-p[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma + t74) * p[t->tyreadr[i] + MAGGI_TYRE_LMX]) +
        tb94 * (pd[t->tyreadr[i] + MAGGI_TYRE_QSX1] * p[t->tyreadr[i] + MAGGI_TYRE_LVMX] +
        p[t->tyreadr[i] + MAGGI_TYRE_QSX1] * pd[t->tyreadr[i] + MAGGI_TYRE_LVMX] +
        ((-(pd[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma) - p[t->tyreadr[i] + MAGGI_TYRE_QSX2] *
        gammad + t74d) * p[t->tyreadr[i] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[i] + MAGGI_TYRE_QSX2] *
        gamma + t74) * pd[t->tyreadr[i] + MAGGI_TYRE_LMX]));
    r0b += tb95 * fz;
    r0bd += tb95d * fz + tb95 * fzd;
    fzb += tb95 * r0;
    fzbd += tb95d * r0 + tb95 * r0d;
    tb96 = tb94 * (r0 * fz);
    tb96d = tb94d * (r0 * fz) + tb94 * (r0d * fz + r0 * fzd);
    pb[t->tyreadr[i] + MAGGI_TYRE_QSX1] += tb96 * p[t->tyreadr[i] + MAGGI_TYRE_LVMX];
    pbd[t->tyreadr[i] + MAGGI_TYRE_QSX1] += tb96d * p[t->tyreadr[i] + MAGGI_TYRE_LVMX] + tb96 *
        pd[t->tyreadr[i] + MAGGI_TYRE_LVMX];
    pb[t->tyreadr[i] + MAGGI_TYRE_LVMX] += tb96 * p[t->tyreadr[i] + MAGGI_TYRE_QSX1];
    pbd[t->tyreadr[i] + MAGGI_TYRE_LVMX] += tb96d * p[t->tyreadr[i] + MAGGI_TYRE_QSX1] + tb96 *
        pd[t->tyreadr[i] + MAGGI_TYRE_QSX1];
    tb97 = tb96 * p[t->tyreadr[i] + MAGGI_TYRE_LMX];
    tb97d = tb96d * p[t->tyreadr[i] + MAGGI_TYRE_LMX] + tb96 * pd[t->tyreadr[i] + MAGGI_TYRE_LMX];
    pb[t->tyreadr[i] + MAGGI_TYRE_QSX2] -= tb97 * gamma;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QSX2] -= tb97d * gamma + tb97 * gammad;
    gammab = -(tb97 * p[t->tyreadr[i] + MAGGI_TYRE_QSX2]);
    gammabd = -(tb97d * p[t->tyreadr[i] + MAGGI_TYRE_QSX2] + tb97 * pd[t->tyreadr[i] +
        MAGGI_TYRE_QSX2]);
    t74b = tb97;
    t74bd = tb97d;
    pb[t->tyreadr[i] + MAGGI_TYRE_LMX] += tb96 * (-p[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma +
        t74);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LMX] += tb96d * (-p[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma +
        t74) + tb96 * (-(pd[t->tyreadr[i] + MAGGI_TYRE_QSX2] * gamma) - p[t->tyreadr[i] +
        MAGGI_TYRE_QSX2] * gammad + t74d);
    tb93 = t74b / fz0;
    tb93d = (t74bd - tb93 * fz0d) * (1.0 / fz0);
    pb[t->tyreadr[i] + MAGGI_TYRE_QSX3] += tb93 * fy;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QSX3] += tb93d * fy + tb93 * fyd;
    fyb += tb93 * p[t->tyreadr[i] + MAGGI_TYRE_QSX3];
    fybd += tb93d * p[t->tyreadr[i] + MAGGI_TYRE_QSX3] + tb93 * pd[t->tyreadr[i] + MAGGI_TYRE_QSX3];
    fz0b -= tb93 * t74;
    fz0bd -= tb93d * t74 + tb93 * t74d;
    fzb += fb[i][2];
    fzbd += fbd[i][2];
    fb[i][2] = 0.0;
    fbd[i][2] = 0.0;
    fyb += fb[i][1];
    fybd += fbd[i][1];
    fb[i][1] = 0.0;
    fbd[i][1] = 0.0;
    fxb += fb[i][0];
    fxbd += fbd[i][0];
    fb[i][0] = 0.0;
    fbd[i][0] = 0.0;
    tb92 = speedb / p[t->tyreadr[i] + MAGGI_TYRE_LONGVL];
    tb92d = (speedbd - tb92 * pd[t->tyreadr[i] + MAGGI_TYRE_LONGVL]) * (1.0 / p[t->tyreadr[i] +
        MAGGI_TYRE_LONGVL]);
    slip_i4b = tb92;
    slip_i4bd = tb92d;
    pb[t->tyreadr[i] + MAGGI_TYRE_LONGVL] -= tb92 * speed;
    pbd[t->tyreadr[i] + MAGGI_TYRE_LONGVL] -= tb92d * speed + tb92 * speedd;
    t73b = wayb * (1.0 - way * way);
    t73bd = waybd * (1.0 - way * way) - wayb * (wayd * way + way * wayd);
    tb91 = t73b / p[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED];
    tb91d = (t73bd - tb91 * pd[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED]) * (1.0 / p[t->tyreadr[i] +
        MAGGI_TYRE_LOW_SPEED]);
    slip_i4b += tb91;
    slip_i4bd += tb91d;
    pb[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED] -= tb91 * t73;
    pbd[t->tyreadr[i] + MAGGI_TYRE_LOW_SPEED] -= tb91d * t73 + tb91 * t73d;
    slipb[i][4] += slip_i4b;
    slipbd[i][4] += slip_i4bd;
    tb88 = sb * p[t->tyreadr[i] + MAGGI_TYRE_LS];
    tb88d = sbd * p[t->tyreadr[i] + MAGGI_TYRE_LS] + sb * pd[t->tyreadr[i] + MAGGI_TYRE_LS];
    tb89 = tb88 * r0;
    tb89d = tb88d * r0 + tb88 * r0d;
    pb[t->tyreadr[i] + MAGGI_TYRE_SSZ1] += tb89;
    pbd[t->tyreadr[i] + MAGGI_TYRE_SSZ1] += tb89d;
    t72b = tb89;
    t72bd = tb89d;
    tb90 = tb89 * gamma;
    tb90d = tb89d * gamma + tb89 * gammad;
    pb[t->tyreadr[i] + MAGGI_TYRE_SSZ3] += tb90;
    pbd[t->tyreadr[i] + MAGGI_TYRE_SSZ3] += tb90d;
    pb[t->tyreadr[i] + MAGGI_TYRE_SSZ4] += tb90 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_SSZ4] += tb90d * dfz + tb90 * dfzd;
    dfzb = tb90 * p[t->tyreadr[i] + MAGGI_TYRE_SSZ4];
    dfzbd = tb90d * p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] + tb90 * pd[t->tyreadr[i] + MAGGI_TYRE_SSZ4];
    gammab += tb89 * (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] *
        dfz);
    gammabd += tb89d * (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] *
        dfz) + tb89 * (pd[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[i] + MAGGI_TYRE_SSZ4] *
        dfz + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfzd));
    r0b += tb88 * (p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] +
        p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma);
    r0bd += tb88d * (p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3]
        + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma) + tb88 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_SSZ1] + t72d + ((pd[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[i] +
        MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfzd)) * gamma +
        (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gammad));
    pb[t->tyreadr[i] + MAGGI_TYRE_LS] += sb * ((p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 +
        (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma) *
        r0);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LS] += sbd * ((p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 +
        (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma) *
        r0) + sb * ((pd[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72d + ((pd[t->tyreadr[i] +
        MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_SSZ4] * dfzd)) * gamma + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] +
        MAGGI_TYRE_SSZ4] * dfz) * gammad)) * r0 + (p[t->tyreadr[i] + MAGGI_TYRE_SSZ1] + t72 +
        (p[t->tyreadr[i] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[i] + MAGGI_TYRE_SSZ4] * dfz) * gamma) *
        r0d);
    tb87 = t72b / fz0;
    tb87d = (t72bd - tb87 * fz0d) * (1.0 / fz0);
    pb[t->tyreadr[i] + MAGGI_TYRE_SSZ2] += tb87 * fy;
    pbd[t->tyreadr[i] + MAGGI_TYRE_SSZ2] += tb87d * fy + tb87 * fyd;
    fyb += tb87 * p[t->tyreadr[i] + MAGGI_TYRE_SSZ2];
    fybd += tb87d * p[t->tyreadr[i] + MAGGI_TYRE_SSZ2] + tb87 * pd[t->tyreadr[i] + MAGGI_TYRE_SSZ2];
    fz0b -= tb87 * t72;
    fz0bd -= tb87d * t72 + tb87 * t72d;
    tb86 = z1b * ca;
    tb86d = z1bd * ca + z1b * cad;
    drb = tb86 * t71;
    drbd = tb86d * t71 + tb86 * t71d;
    t71b = tb86 * dr;
    t71bd = tb86d * dr + tb86 * drd;
    cab = z1b * (dr * t71);
    cabd = z1bd * (dr * t71) + z1b * (drd * t71 + dr * t71d);
    tb85 = t71b / t70;
    tb85d = (t71bd - tb85 * t70d) * (1.0 / t70);
    t70b = -(tb85 * t71);
    t70bd = -(tb85d * t71 + tb85 * t71d);
    t69b = t70b * (1.0 / (2.0 * t70));
    t69bd = t70bd * (1.0 / (2.0 * t70)) - t70b * (1.0 / (2.0 * t70) * (2.0 * t70d) / (2.0 * t70));
    x5b = t69b * x5;
    x5bd = t69bd * x5 + t69b * x5d;
    x5b += t69b * x5;
    x5bd += t69bd * x5 + t69b * x5d;
    brb = x5b * areq;
    brbd = x5bd * areq + x5b * areqd;
    areqb = x5b * br;
    areqbd = x5bd * br + x5b * brd;
    tb84 = z0b * ca;
    tb84d = z0bd * ca + z0b * cad;
    dtb = tb84 * t68;
    dtbd = tb84d * t68 + tb84 * t68d;
    t68b = tb84 * dt;
    t68bd = tb84d * dt + tb84 * dtd;
    cab += z0b * (dt * t68);
    cabd += z0bd * (dt * t68) + z0b * (dtd * t68 + dt * t68d);
    t67b = -(t68b * sin(t67));
    t67bd = -(t68bd * sin(t67) + t68b * (cos(t67) * t67d));
    pb[t->tyreadr[i] + MAGGI_TYRE_QCZ1] += t67b * t66;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QCZ1] += t67bd * t66 + t67b * t66d;
    t66b = t67b * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1];
    t66bd = t67bd * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] + t67b * pd[t->tyreadr[i] + MAGGI_TYRE_QCZ1];
    t65b = t66b * (1.0 / (1.0 + t65 * t65));
    t65bd = t66bd * (1.0 / (1.0 + t65 * t65)) - t66b * (1.0 / (1.0 + t65 * t65) * (t65d * t65 + t65
        * t65d) / (1.0 + t65 * t65));
    etb = -(t65b * y17);
    etbd = -(t65bd * y17 + t65b * y17d);
    y17b = t65b * (1.0 - et);
    y17bd = t65bd * (1.0 - et) - t65b * etd;
    etb += t65b * t64;
    etbd += t65bd * t64 + t65b * t64d;
    t64b = t65b * et;
    t64bd = t65bd * et + t65b * etd;
    y17b += t64b * (1.0 / (1.0 + y17 * y17));
    y17bd += t64bd * (1.0 / (1.0 + y17 * y17)) - t64b * (1.0 / (1.0 + y17 * y17) * (y17d * y17 + y17
        * y17d) / (1.0 + y17 * y17));
    btb = y17b * ateq;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    btbd = y17bd * ateq + y17b * ateqd;
    ateqb = y17b * bt;
    ateqbd = y17bd * bt + y17b * btd;
    tb83 = cab / t63;
    tb83d = (cabd - tb83 * t63d) * (1.0 / t63);
    t63b = -(tb83 * ca);
    t63bd = -(tb83d * ca + tb83 * cad);
    t62b = t63b * (1.0 / (2.0 * t63));
    t62bd = t63bd * (1.0 / (2.0 * t63)) - t63b * (1.0 / (2.0 * t63) * (2.0 * t63d) / (2.0 * t63));
    ab = t62b * a;
    abd = t62bd * a + t62b * ad;
    ab += t62b * a;
    abd += t62bd * a + t62b * ad;
    tb78 = drb * p7;
    tb78d = drbd * p7 + drb * p7d;
    tb79 = tb78 * p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS];
    tb79d = tb78d * p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] + tb78 * pd[t->tyreadr[i] +
        MAGGI_TYRE_UNLOADED_RADIUS];
    fzb += tb79 * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfz) * gz);
    fzbd += tb79d * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz)
        * p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i]
        + MAGGI_TYRE_QDZ9] * dfz) * gz) + tb79 * ((pd[t->tyreadr[i] + MAGGI_TYRE_QDZ6] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfzd)) *
        p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ7] * dfz) * pd[t->tyreadr[i] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfzd)) * gz + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfz) * gzd));
    tb80 = tb79 * fz;
    tb80d = tb79d * fz + tb79 * fzd;
    tb81 = tb80 * p[t->tyreadr[i] + MAGGI_TYRE_LRES];
    tb81d = tb80d * p[t->tyreadr[i] + MAGGI_TYRE_LRES] + tb80 * pd[t->tyreadr[i] + MAGGI_TYRE_LRES];
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ6] += tb81;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QDZ6] += tb81d;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ7] += tb81 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QDZ7] += tb81d * dfz + tb81 * dfzd;
    dfzb += tb81 * p[t->tyreadr[i] + MAGGI_TYRE_QDZ7];
    dfzbd += tb81d * p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] + tb81 * pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ7];
    pb[t->tyreadr[i] + MAGGI_TYRE_LRES] += tb80 * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LRES] += tb80d * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) + tb80 * (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ6] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfzd));
    tb82 = tb80 * gz;
    tb82d = tb80d * gz + tb80 * gzd;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ8] += tb82;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QDZ8] += tb82d;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ9] += tb82 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QDZ9] += tb82d * dfz + tb82 * dfzd;
    dfzb += tb82 * p[t->tyreadr[i] + MAGGI_TYRE_QDZ9];
    dfzbd += tb82d * p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] + tb82 * pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9];
    gzb = tb80 * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz);
    gzbd = tb80d * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz) +
        tb80 * (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfzd));
    pb[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] += tb78 * (fz * ((p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[i] +
        MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9]
        * dfz) * gz));
    pbd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] += tb78d * (fz * ((p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[i] +
        MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9]
        * dfz) * gz)) + tb78 * (fzd * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz) * gz) + fz * ((pd[t->tyreadr[i]
        + MAGGI_TYRE_QDZ6] + (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ7] * dfzd)) * p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) * pd[t->tyreadr[i] +
        MAGGI_TYRE_LRES] + ((pd[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ9] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfzd)) * gz + (p[t->tyreadr[i]
        + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz) * gzd)));
    p7b = drb * (fz * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] *
        dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[i] +
        MAGGI_TYRE_UNLOADED_RADIUS]);
    p7bd = drbd * (fz * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] *
        dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[i] +
        MAGGI_TYRE_UNLOADED_RADIUS]) + drb * ((fzd * ((p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LRES] +
        (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz) * gz) + fz *
        ((pd[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfzd)) * p[t->tyreadr[i] + MAGGI_TYRE_LRES] +
        (p[t->tyreadr[i] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) *
        pd[t->tyreadr[i] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[i] + MAGGI_TYRE_QDZ8] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfzd)) *
        gz + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9] * dfz) *
        gzd))) * p[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] + fz * ((p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ6] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[i] +
        MAGGI_TYRE_LRES] + (p[t->tyreadr[i] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ9]
        * dfz) * gz) * pd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS]);
    t61b = brb;
    t61bd = brbd;
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ10] += brb * bycy;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QBZ10] += brbd * bycy + brb * bycyd;
    bycyb = brb * p[t->tyreadr[i] + MAGGI_TYRE_QBZ10];
    bycybd = brbd * p[t->tyreadr[i] + MAGGI_TYRE_QBZ10] + brb * pd[t->tyreadr[i] +
        MAGGI_TYRE_QBZ10];
    tb77 = t61b / p7;
    tb77d = (t61bd - tb77 * p7d) * (1.0 / p7);
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ9] += tb77 * p[t->tyreadr[i] + MAGGI_TYRE_LKY];
    pbd[t->tyreadr[i] + MAGGI_TYRE_QBZ9] += tb77d * p[t->tyreadr[i] + MAGGI_TYRE_LKY] + tb77 *
        pd[t->tyreadr[i] + MAGGI_TYRE_LKY];
    pb[t->tyreadr[i] + MAGGI_TYRE_LKY] += tb77 * p[t->tyreadr[i] + MAGGI_TYRE_QBZ9];
    pbd[t->tyreadr[i] + MAGGI_TYRE_LKY] += tb77d * p[t->tyreadr[i] + MAGGI_TYRE_QBZ9] + tb77 *
        pd[t->tyreadr[i] + MAGGI_TYRE_QBZ9];
    p7b -= tb77 * t61;
    p7bd -= tb77d * t61 + tb77 * t61d;
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUY] += p7b;
    pbd[t->tyreadr[i] + MAGGI_TYRE_LMUY] += p7bd;
    y16b = etb;
    y16bd = etbd;
    e11b = 0.0;
    e11bd = 0.0;
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e11) > 1.0) {
      y16b = 0.0;
      y16bd = 0.0;
    } else {
      e11b += y16b;
      e11bd += y16bd;
      y16b = 0.0;
      y16bd = 0.0;
    }
    tb72 = e11b * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] *
        gz) * 0.63661977236758134308 * t60);
    tb72d = e11bd * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5]
        * gz) * 0.63661977236758134308 * t60) + e11b * ((pd[t->tyreadr[i] + MAGGI_TYRE_QEZ4] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gzd)) *
        0.63661977236758134308 * t60 + (p[t->tyreadr[i] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[i] +
        MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t60d);
    pb[t->tyreadr[i] + MAGGI_TYRE_QEZ1] += tb72;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QEZ1] += tb72d;
    pb[t->tyreadr[i] + MAGGI_TYRE_QEZ2] += tb72 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QEZ2] += tb72d * dfz + tb72 * dfzd;
    dfzb += tb72 * p[t->tyreadr[i] + MAGGI_TYRE_QEZ2];
    dfzbd += tb72d * p[t->tyreadr[i] + MAGGI_TYRE_QEZ2] + tb72 * pd[t->tyreadr[i] +
        MAGGI_TYRE_QEZ2];
    tb73 = tb72 * dfz;
    tb73d = tb72d * dfz + tb72 * dfzd;
    pb[t->tyreadr[i] + MAGGI_TYRE_QEZ3] += tb73 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QEZ3] += tb73d * dfz + tb73 * dfzd;
    dfzb += tb73 * p[t->tyreadr[i] + MAGGI_TYRE_QEZ3];
    dfzbd += tb73d * p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] + tb73 * pd[t->tyreadr[i] +
        MAGGI_TYRE_QEZ3];
    dfzb += tb72 * (p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz);
    dfzbd += tb72d * (p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz) + tb72 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_QEZ3] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfzd);
    tb74 = e11b * (p[t->tyreadr[i] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz * dfz);
    tb74d = e11bd * (p[t->tyreadr[i] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz * dfz) + e11b * (pd[t->tyreadr[i] +
        MAGGI_TYRE_QEZ1] + (pd[t->tyreadr[i] + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_QEZ2] * dfzd) + ((pd[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_QEZ3] * dfzd) * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QEZ3] * dfz * dfzd));
    tb75 = tb74 * t60;
    tb75d = tb74d * t60 + tb74 * t60d;
    tb76 = tb75 * 0.63661977236758134308;
    tb76d = tb75d * 0.63661977236758134308;
    pb[t->tyreadr[i] + MAGGI_TYRE_QEZ4] += tb76;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QEZ4] += tb76d;
    pb[t->tyreadr[i] + MAGGI_TYRE_QEZ5] += tb76 * gz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QEZ5] += tb76d * gz + tb76 * gzd;
    gzb += tb76 * p[t->tyreadr[i] + MAGGI_TYRE_QEZ5];
    gzbd += tb76d * p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] + tb76 * pd[t->tyreadr[i] + MAGGI_TYRE_QEZ5];
    t60b = tb74 * ((p[t->tyreadr[i] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gz) *
        0.63661977236758134308);
    t60bd = tb74d * ((p[t->tyreadr[i] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gz)
        * 0.63661977236758134308) + tb74 * ((pd[t->tyreadr[i] + MAGGI_TYRE_QEZ4] + (pd[t->tyreadr[i]
        + MAGGI_TYRE_QEZ5] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QEZ5] * gzd)) *
        0.63661977236758134308);
    t59b = t60b * (1.0 / (1.0 + t59 * t59));
    t59bd = t60bd * (1.0 / (1.0 + t59 * t59)) - t60b * (1.0 / (1.0 + t59 * t59) * (t59d * t59 + t59
        * t59d) / (1.0 + t59 * t59));
    tb71 = t59b * at;
    tb71d = t59bd * at + t59b * atd;
    btb += tb71 * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1];
    btbd += tb71d * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1] + tb71 * pd[t->tyreadr[i] + MAGGI_TYRE_QCZ1];
    pb[t->tyreadr[i] + MAGGI_TYRE_QCZ1] += tb71 * bt;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QCZ1] += tb71d * bt + tb71 * btd;
    atb = t59b * (bt * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1]);
    atbd = t59bd * (bt * p[t->tyreadr[i] + MAGGI_TYRE_QCZ1]) + t59b * (btd * p[t->tyreadr[i] +
        MAGGI_TYRE_QCZ1] + bt * pd[t->tyreadr[i] + MAGGI_TYRE_QCZ1]);
    tb65 = dtb * p[t->tyreadr[i] + MAGGI_TYRE_LTR];
    tb65d = dtbd * p[t->tyreadr[i] + MAGGI_TYRE_LTR] + dtb * pd[t->tyreadr[i] + MAGGI_TYRE_LTR];
    tb66 = tb65 * t58;
    tb66d = tb65d * t58 + tb65 * t58d;
    tb67 = tb66 * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ4] * gz * gz);
    tb67d = tb66d * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ4] * gz * gz) + tb66 * (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gzd + ((pd[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gzd) * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz *
        gzd));
    fzb += tb67 * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz);
    fzbd += tb67d * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz)
        + tb67 * (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfzd));
    tb68 = tb67 * fz;
    tb68d = tb67d * fz + tb67 * fzd;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ1] += tb68;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QDZ1] += tb68d;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ2] += tb68 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QDZ2] += tb68d * dfz + tb68 * dfzd;
    dfzb += tb68 * p[t->tyreadr[i] + MAGGI_TYRE_QDZ2];
    dfzbd += tb68d * p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] + tb68 * pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ2];
    tb69 = tb66 * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] *
        dfz));
    tb69d = tb66d * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] *
        dfz)) + tb66 * (fzd * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ2] * dfz) + fz * (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfzd)));
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ3] += tb69 * gz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QDZ3] += tb69d * gz + tb69 * gzd;
    gzb += tb69 * p[t->tyreadr[i] + MAGGI_TYRE_QDZ3];
    gzbd += tb69d * p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] + tb69 * pd[t->tyreadr[i] + MAGGI_TYRE_QDZ3];
    tb70 = tb69 * gz;
    tb70d = tb69d * gz + tb69 * gzd;
    pb[t->tyreadr[i] + MAGGI_TYRE_QDZ4] += tb70 * gz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QDZ4] += tb70d * gz + tb70 * gzd;
    gzb += tb70 * p[t->tyreadr[i] + MAGGI_TYRE_QDZ4];
    gzbd += tb70d * p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] + tb70 * pd[t->tyreadr[i] + MAGGI_TYRE_QDZ4];
    gzb += tb69 * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz);
    gzbd += tb69d * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz) + tb69 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gzd);
    t58b = tb65 * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] *
        dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] *
        gz * gz));
    t58bd = tb65d * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] *
        dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] *
        gz * gz)) + tb65 * ((fzd * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ2] * dfz) + fz * (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfzd))) * (1.0 +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) + fz
        * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) *
        (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gzd +
        ((pd[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gzd) * gz
        + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gzd)));
    pb[t->tyreadr[i] + MAGGI_TYRE_LTR] += dtb * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) * t58);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LTR] += dtbd * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) * t58) + dtb * (((fzd * (p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) + fz * (pd[t->tyreadr[i] +
        MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_QDZ2] * dfzd))) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz * gz) + fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gzd + ((pd[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz +
        p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gzd) * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4] * gz *
        gzd))) * t58 + fz * (p[t->tyreadr[i] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QDZ2]
        * dfz) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QDZ4]
        * gz * gz) * t58d);
    tb64 = t58b / fz0_3;
    tb64d = (t58bd - tb64 * fz0_3d) * (1.0 / fz0_3);
    pb[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] += tb64;
    pbd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] += tb64d;
    fz0_3b = -(tb64 * t58);
    fz0_3bd = -(tb64d * t58 + tb64 * t58d);
    tb59 = btb / p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    tb59d = (btbd - tb59 * pd[t->tyreadr[i] + MAGGI_TYRE_LMUY]) * (1.0 / p[t->tyreadr[i] +
        MAGGI_TYRE_LMUY]);
    tb60 = tb59 * p[t->tyreadr[i] + MAGGI_TYRE_LKY];
    tb60d = tb59d * p[t->tyreadr[i] + MAGGI_TYRE_LKY] + tb59 * pd[t->tyreadr[i] + MAGGI_TYRE_LKY];
    tb61 = tb60 * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] +
        MAGGI_TYRE_QBZ5] * y15);
    tb61d = tb60d * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] +
        MAGGI_TYRE_QBZ5] * y15) + tb60 * (pd[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i]
        + MAGGI_TYRE_QBZ4] * gzd + (pd[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15 + p[t->tyreadr[i] +
        MAGGI_TYRE_QBZ5] * y15d));
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ1] += tb61;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QBZ1] += tb61d;
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ2] += tb61 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QBZ2] += tb61d * dfz + tb61 * dfzd;
    dfzb += tb61 * p[t->tyreadr[i] + MAGGI_TYRE_QBZ2];
    dfzbd += tb61d * p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] + tb61 * pd[t->tyreadr[i] +
        MAGGI_TYRE_QBZ2];
    tb62 = tb61 * dfz;
    tb62d = tb61d * dfz + tb61 * dfzd;
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ3] += tb62 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QBZ3] += tb62d * dfz + tb62 * dfzd;
    dfzb += tb62 * p[t->tyreadr[i] + MAGGI_TYRE_QBZ3];
    dfzbd += tb62d * p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] + tb62 * pd[t->tyreadr[i] +
        MAGGI_TYRE_QBZ3];
    dfzb += tb61 * (p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz);
    dfzbd += tb61d * (p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz) + tb61 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_QBZ3] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfzd);
    tb63 = tb60 * (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz);
    tb63d = tb60d * (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) + tb60 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_QBZ1] + (pd[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_QBZ2] * dfzd) + ((pd[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_QBZ3] * dfzd) * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfzd));
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ4] += tb63 * gz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QBZ4] += tb63d * gz + tb63 * gzd;
    gzb += tb63 * p[t->tyreadr[i] + MAGGI_TYRE_QBZ4];
    gzbd += tb63d * p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] + tb63 * pd[t->tyreadr[i] + MAGGI_TYRE_QBZ4];
    pb[t->tyreadr[i] + MAGGI_TYRE_QBZ5] += tb63 * y15;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QBZ5] += tb63d * y15 + tb63 * y15d;
    y15b = tb63 * p[t->tyreadr[i] + MAGGI_TYRE_QBZ5];
    y15bd = tb63d * p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] + tb63 * pd[t->tyreadr[i] + MAGGI_TYRE_QBZ5];
    pb[t->tyreadr[i] + MAGGI_TYRE_LKY] += tb59 * ((p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
        (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15));
    pbd[t->tyreadr[i] + MAGGI_TYRE_LKY] += tb59d * ((p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
        (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15))
        + tb59 * ((pd[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + (pd[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfz
        + p[t->tyreadr[i] + MAGGI_TYRE_QBZ2] * dfzd) + ((pd[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfzd) * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz
        * dfzd)) * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] +
        MAGGI_TYRE_QBZ5] * y15) + (p[t->tyreadr[i] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[i] +
        MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (pd[t->tyreadr[i]
        + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[i] + MAGGI_TYRE_QBZ4] * gzd + (pd[t->tyreadr[i] +
        MAGGI_TYRE_QBZ5] * y15 + p[t->tyreadr[i] + MAGGI_TYRE_QBZ5] * y15d)));
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUY] -= tb59 * bt;
    pbd[t->tyreadr[i] + MAGGI_TYRE_LMUY] -= tb59d * bt + tb59 * btd;
    /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
     * where straight running is, and exact from w on */
    if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      gzb += y15b;
      gzbd += y15bd;
      y15b = 0.0;
      y15bd = 0.0;
    } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      gzb -= y15b;
      gzbd -= y15bd;
      y15b = 0.0;
      y15bd = 0.0;
    } else {
      p6 = p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      p6d = pd[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      t57 = p6 * p6;
      t57d = p6d * p6 + p6 * p6d;
      z4 = gz * gz / t57;
      z4d = (gzd * gz + gz * gzd - z4 * t57d) * (1.0 / t57);
      tb57 = y15b * (15.0 + z4 * (-10.0 + 3.0 * z4));
      tb57d = y15bd * (15.0 + z4 * (-10.0 + 3.0 * z4)) + y15b * (z4d * (-10.0 + 3.0 * z4) + z4 *
          (3.0 * z4d));
      p6b = tb57 * z4 * 0.125;
      p6bd = (tb57d * z4 + tb57 * z4d) * 0.125;
      z4b = tb57 * (0.125 * p6);
      z4bd = tb57d * (0.125 * p6) + tb57 * (0.125 * p6d);
      tb58 = y15b * (0.125 * p6 * z4);
      tb58d = y15bd * (0.125 * p6 * z4) + y15b * (0.125 * p6d * z4 + 0.125 * p6 * z4d);
      z4b += tb58 * (-10.0 + 3.0 * z4);
      z4bd += tb58d * (-10.0 + 3.0 * z4) + tb58 * (3.0 * z4d);
      z4b += tb58 * z4 * 3.0;
      z4bd += (tb58d * z4 + tb58 * z4d) * 3.0;
      y15b = 0.0;
      y15bd = 0.0;
      tb56 = z4b / t57;
      tb56d = (z4bd - tb56 * t57d) * (1.0 / t57);
      gzb += tb56 * gz;
      gzbd += tb56d * gz + tb56 * gzd;
      gzb += tb56 * gz;
      gzbd += tb56d * gz + tb56 * gzd;
      t57b = -(tb56 * z4);
      t57bd = -(tb56d * z4 + tb56 * z4d);
      p6b += t57b * p6;
      p6bd += t57bd * p6 + t57b * p6d;
      p6b += t57b * p6;
      p6bd += t57bd * p6 + t57b * p6d;
      pb[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER] += p6b;
      pbd[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER] += p6bd;
    }
    t56b = areqb * (1.0 / (2.0 * areq));
    t56bd = areqbd * (1.0 / (2.0 * areq)) - areqb * (1.0 / (2.0 * areq) * (2.0 * areqd) / (2.0 *
        areq));
    arb = t56b * ar;
    arbd = t56bd * ar + t56b * ard;
    arb += t56b * ar;
    arbd += t56bd * ar + t56b * ard;
    ratiob = t56b * ratio;
    ratiobd = t56bd * ratio + t56b * ratiod;
    ratiob += t56b * ratio;
    ratiobd += t56bd * ratio + t56b * ratiod;
    t55b = ateqb * (1.0 / (2.0 * ateq));
    t55bd = ateqbd * (1.0 / (2.0 * ateq)) - ateqb * (1.0 / (2.0 * ateq) * (2.0 * ateqd) / (2.0 *
        ateq));
    atb += t55b * at;
    atbd += t55bd * at + t55b * atd;
    atb += t55b * at;
    atbd += t55bd * at + t55b * atd;
    ratiob += t55b * ratio;
    ratiobd += t55bd * ratio + t55b * ratiod;
    ratiob += t55b * ratio;
    ratiobd += t55bd * ratio + t55b * ratiod;
    ab += arb;
    abd += arbd;
    shiftb = arb;
    shiftbd = arbd;
    ab += atb;
    abd += atbd;
    pb[t->tyreadr[i] + MAGGI_TYRE_QHZ1] += atb;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QHZ1] += atbd;
    pb[t->tyreadr[i] + MAGGI_TYRE_QHZ2] += atb * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QHZ2] += atbd * dfz + atb * dfzd;
    dfzb += atb * p[t->tyreadr[i] + MAGGI_TYRE_QHZ2];
    dfzbd += atbd * p[t->tyreadr[i] + MAGGI_TYRE_QHZ2] + atb * pd[t->tyreadr[i] + MAGGI_TYRE_QHZ2];
    tb55 = atb * gz;
    tb55d = atbd * gz + atb * gzd;
    pb[t->tyreadr[i] + MAGGI_TYRE_QHZ3] += tb55;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QHZ3] += tb55d;
    pb[t->tyreadr[i] + MAGGI_TYRE_QHZ4] += tb55 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_QHZ4] += tb55d * dfz + tb55 * dfzd;
    dfzb += tb55 * p[t->tyreadr[i] + MAGGI_TYRE_QHZ4];
    dfzbd += tb55d * p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] + tb55 * pd[t->tyreadr[i] +
        MAGGI_TYRE_QHZ4];
    gzb += atb * (p[t->tyreadr[i] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfz);
    gzbd += atbd * (p[t->tyreadr[i] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfz) +
        atb * (pd[t->tyreadr[i] + MAGGI_TYRE_QHZ3] + (pd[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_QHZ4] * dfzd));
    gammab += gzb * p[t->tyreadr[i] + MAGGI_TYRE_LGAZ];
    gammabd += gzbd * p[t->tyreadr[i] + MAGGI_TYRE_LGAZ] + gzb * pd[t->tyreadr[i] +
        MAGGI_TYRE_LGAZ];
    pb[t->tyreadr[i] + MAGGI_TYRE_LGAZ] += gzb * gamma;
    pbd[t->tyreadr[i] + MAGGI_TYRE_LGAZ] += gzbd * gamma + gzb * gammad;
    pb[t->tyreadr[i] + MAGGI_TYRE_LFZO] += fz0_3b * p[t->tyreadr[i]];
    /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
     *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
    pbd[t->tyreadr[i] + MAGGI_TYRE_LFZO] += fz0_3bd * p[t->tyreadr[i]] + fz0_3b * pd[t->tyreadr[i]];
    pb[t->tyreadr[i]] += fz0_3b * p[t->tyreadr[i] + MAGGI_TYRE_LFZO];
    pbd[t->tyreadr[i]] += fz0_3bd * p[t->tyreadr[i] + MAGGI_TYRE_LFZO] + fz0_3b * pd[t->tyreadr[i] +
        MAGGI_TYRE_LFZO];
    y4_2b = shiftb;
    y4_2bd = shiftbd;
    y3_2b = bycyb;
    y3_2bd = bycybd;
    tb54 = ratiob / y1;
    tb54d = (ratiobd - tb54 * y1d) * (1.0 / y1);
    x1b = tb54 * kappa;
    x1bd = tb54d * kappa + tb54 * kappad;
    kappab = tb54 * x1;
    kappabd = tb54d * x1 + tb54 * x1d;
    y1b = -(tb54 * ratio);
    y1bd = -(tb54d * ratio + tb54 * ratiod);
    g0b = fyb * y0;
    g0bd = fybd * y0 + fyb * y0d;
    y0b = fyb * g0;
    y0bd = fybd * g0 + fyb * g0d;
    g1b += fyb;
    g1bd += fybd;
    x0b = fxb * t54;
    x0bd = fxbd * t54 + fxb * t54d;
    t54b = fxb * x0;
    t54bd = fxbd * x0 + fxb * x0d;
    tb53 = t54b / t53;
    tb53d = (t54bd - tb53 * t53d) * (1.0 / t53);
    t48b = tb53;
    t48bd = tb53d;
    t53b = -(tb53 * t54);
    t53bd = -(tb53d * t54 + tb53 * t54d);
    t52b = -(t53b * sin(t52));
    t52bd = -(t53bd * sin(t52) + t53b * (cos(t52) * t52d));
    p5b = t52b * t51;
    p5bd = t52bd * t51 + t52b * t51d;
    t51b = t52b * p5;
    t51bd = t52bd * p5 + t52b * p5d;
    t50b = t51b * (1.0 / (1.0 + t50 * t50));
    t50bd = t51bd * (1.0 / (1.0 + t50 * t50)) - t51b * (1.0 / (1.0 + t50 * t50) * (t50d * t50 + t50
        * t50d) / (1.0 + t50 * t50));
    e9b = -(t50b * y14);
    e9bd = -(t50bd * y14 + t50b * y14d);
    y14b = t50b * (1.0 - e9);
    y14bd = t50bd * (1.0 - e9) - t50b * e9d;
    e9b += t50b * t49;
    e9bd += t50bd * t49 + t50b * t49d;
    t49b = t50b * e9;
    t49bd = t50bd * e9 + t50b * e9d;
    y14b += t49b * (1.0 / (1.0 + y14 * y14));
    y14bd += t49bd * (1.0 / (1.0 + y14 * y14)) - t49b * (1.0 / (1.0 + y14 * y14) * (y14d * y14 + y14
        * y14d) / (1.0 + y14 * y14));
    t47b = -(t48b * sin(t47));
    t47bd = -(t48bd * sin(t47) + t48b * (cos(t47) * t47d));
    p5b += t47b * t46;
    p5bd += t47bd * t46 + t47b * t46d;
    t46b = t47b * p5;
    t46bd = t47bd * p5 + t47b * p5d;
    pb[t->tyreadr[i] + MAGGI_TYRE_RCX1] += p5b;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RCX1] += p5bd;
    t45b = t46b * (1.0 / (1.0 + t45 * t45));
    t45bd = t46bd * (1.0 / (1.0 + t45 * t45)) - t46b * (1.0 / (1.0 + t45 * t45) * (t45d * t45 + t45
        * t45d) / (1.0 + t45 * t45));
    e9b -= t45b * y13;
    e9bd -= t45bd * y13 + t45b * y13d;
    y13b = t45b * (1.0 - e9);
    y13bd = t45bd * (1.0 - e9) - t45b * e9d;
    e9b += t45b * t44;
    e9bd += t45bd * t44 + t45b * t44d;
    t44b = t45b * e9;
    t44bd = t45bd * e9 + t45b * e9d;
    y13b += t44b * (1.0 / (1.0 + y13 * y13));
    y13bd += t44bd * (1.0 / (1.0 + y13 * y13)) - t44b * (1.0 / (1.0 + y13 * y13) * (y13d * y13 + y13
        * y13d) / (1.0 + y13 * y13));
    stiff4b = y14b * p4;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    stiff4bd = y14bd * p4 + y14b * p4d;
    p4b = y14b * stiff4;
    p4bd = y14bd * stiff4 + y14b * stiff4d;
    stiff4b += y13b * (a + p4);
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    stiff4bd += y13bd * (a + p4) + y13b * (ad + p4d);
    tb52 = y13b * stiff4;
    tb52d = y13bd * stiff4 + y13b * stiff4d;
    ab += tb52;
    abd += tb52d;
    p4b += tb52;
    p4bd += tb52d;
    pb[t->tyreadr[i] + MAGGI_TYRE_RHX1] += p4b;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RHX1] += p4bd;
    y12b = e9b;
    y12bd = e9bd;
    e10b = 0.0;
    e10bd = 0.0;
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e10) > 1.0) {
      y12b = 0.0;
      y12bd = 0.0;
    } else {
      e10b += y12b;
      e10bd += y12bd;
      y12b = 0.0;
      y12bd = 0.0;
    }
    pb[t->tyreadr[i] + MAGGI_TYRE_REX1] += e10b;
    pbd[t->tyreadr[i] + MAGGI_TYRE_REX1] += e10bd;
    pb[t->tyreadr[i] + MAGGI_TYRE_REX2] += e10b * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_REX2] += e10bd * dfz + e10b * dfzd;
    dfzb += e10b * p[t->tyreadr[i] + MAGGI_TYRE_REX2];
    dfzbd += e10bd * p[t->tyreadr[i] + MAGGI_TYRE_REX2] + e10b * pd[t->tyreadr[i] +
        MAGGI_TYRE_REX2];
    tb51 = stiff4b * p[t->tyreadr[i] + MAGGI_TYRE_LXAL];
    tb51d = stiff4bd * p[t->tyreadr[i] + MAGGI_TYRE_LXAL] + stiff4b * pd[t->tyreadr[i] +
        MAGGI_TYRE_LXAL];
    pb[t->tyreadr[i] + MAGGI_TYRE_RBX1] += tb51 * t43;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RBX1] += tb51d * t43 + tb51 * t43d;
    t43b = tb51 * p[t->tyreadr[i] + MAGGI_TYRE_RBX1];
    t43bd = tb51d * p[t->tyreadr[i] + MAGGI_TYRE_RBX1] + tb51 * pd[t->tyreadr[i] + MAGGI_TYRE_RBX1];
    pb[t->tyreadr[i] + MAGGI_TYRE_LXAL] += stiff4b * (p[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LXAL] += stiff4bd * (p[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43) +
        stiff4b * (pd[t->tyreadr[i] + MAGGI_TYRE_RBX1] * t43 + p[t->tyreadr[i] + MAGGI_TYRE_RBX1] *
        t43d);
    tb50 = t43b / t42;
    tb50d = (t43bd - tb50 * t42d) * (1.0 / t42);
    t42b = -(tb50 * t43);
    t42bd = -(tb50d * t43 + tb50 * t43d);
    t41b = t42b * (1.0 / (2.0 * t42));
    t41bd = t42bd * (1.0 / (2.0 * t42)) - t42b * (1.0 / (2.0 * t42) * (2.0 * t42d) / (2.0 * t42));
    x4b = t41b * x4;
    x4bd = t41bd * x4 + t41b * x4d;
    x4b += t41b * x4;
    x4bd += t41bd * x4 + t41b * x4d;
    pb[t->tyreadr[i] + MAGGI_TYRE_RBX2] += x4b * kappa;
    /* Gxa = Fx / Fx0 */
    pbd[t->tyreadr[i] + MAGGI_TYRE_RBX2] += x4bd * kappa + x4b * kappad;
    kappab += x4b * p[t->tyreadr[i] + MAGGI_TYRE_RBX2];
    kappabd += x4bd * p[t->tyreadr[i] + MAGGI_TYRE_RBX2] + x4b * pd[t->tyreadr[i] +
        MAGGI_TYRE_RBX2];
    tb49 = g1b * p[t->tyreadr[i] + MAGGI_TYRE_LVYKA];
    tb49d = g1bd * p[t->tyreadr[i] + MAGGI_TYRE_LVYKA] + g1b * pd[t->tyreadr[i] + MAGGI_TYRE_LVYKA];
    dvb = tb49 * t40;
    dvbd = tb49d * t40 + tb49 * t40d;
    t40b = tb49 * dv;
    t40bd = tb49d * dv + tb49 * dvd;
    pb[t->tyreadr[i] + MAGGI_TYRE_LVYKA] += g1b * (dv * t40);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LVYKA] += g1bd * (dv * t40) + g1b * (dvd * t40 + dv * t40d);
    t39b = t40b * cos(t39);
    t39bd = t40bd * cos(t39) - t40b * (sin(t39) * t39d);
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY5] += t39b * t38;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RVY5] += t39bd * t38 + t39b * t38d;
    t38b = t39b * p[t->tyreadr[i] + MAGGI_TYRE_RVY5];
    t38bd = t39bd * p[t->tyreadr[i] + MAGGI_TYRE_RVY5] + t39b * pd[t->tyreadr[i] + MAGGI_TYRE_RVY5];
    t37b = t38b * (1.0 / (1.0 + t37 * t37));
    t37bd = t38bd * (1.0 / (1.0 + t37 * t37)) - t38b * (1.0 / (1.0 + t37 * t37) * (t37d * t37 + t37
        * t37d) / (1.0 + t37 * t37));
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY6] += t37b * kappa;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RVY6] += t37bd * kappa + t37b * kappad;
    kappab += t37b * p[t->tyreadr[i] + MAGGI_TYRE_RVY6];
    kappabd += t37bd * p[t->tyreadr[i] + MAGGI_TYRE_RVY6] + t37b * pd[t->tyreadr[i] +
        MAGGI_TYRE_RVY6];
    tb48 = g0b / t36;
    tb48d = (g0bd - tb48 * t36d) * (1.0 / t36);
    t31b = tb48;
    t31bd = tb48d;
    t36b = -(tb48 * g0);
    t36bd = -(tb48d * g0 + tb48 * g0d);
    t35b = -(t36b * sin(t35));
    t35bd = -(t36bd * sin(t35) + t36b * (cos(t35) * t35d));
    p3b = t35b * t34;
    p3bd = t35bd * t34 + t35b * t34d;
    t34b = t35b * p3;
    t34bd = t35bd * p3 + t35b * p3d;
    t33b = t34b * (1.0 / (1.0 + t33 * t33));
    t33bd = t34bd * (1.0 / (1.0 + t33 * t33)) - t34b * (1.0 / (1.0 + t33 * t33) * (t33d * t33 + t33
        * t33d) / (1.0 + t33 * t33));
    e7b = -(t33b * y11);
    e7bd = -(t33bd * y11 + t33b * y11d);
    y11b = t33b * (1.0 - e7);
    y11bd = t33bd * (1.0 - e7) - t33b * e7d;
    e7b += t33b * t32;
    e7bd += t33bd * t32 + t33b * t32d;
    t32b = t33b * e7;
    t32bd = t33bd * e7 + t33b * e7d;
    y11b += t32b * (1.0 / (1.0 + y11 * y11));
    y11bd += t32bd * (1.0 / (1.0 + y11 * y11)) - t32b * (1.0 / (1.0 + y11 * y11) * (y11d * y11 + y11
        * y11d) / (1.0 + y11 * y11));
    t30b = -(t31b * sin(t30));
    t30bd = -(t31bd * sin(t30) + t31b * (cos(t30) * t30d));
    p3b += t30b * t29;
    p3bd += t30bd * t29 + t30b * t29d;
    t29b = t30b * p3;
    t29bd = t30bd * p3 + t30b * p3d;
    pb[t->tyreadr[i] + MAGGI_TYRE_RCY1] += p3b;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RCY1] += p3bd;
    t28b = t29b * (1.0 / (1.0 + t28 * t28));
    t28bd = t29bd * (1.0 / (1.0 + t28 * t28)) - t29b * (1.0 / (1.0 + t28 * t28) * (t28d * t28 + t28
        * t28d) / (1.0 + t28 * t28));
    e7b -= t28b * y10;
    e7bd -= t28bd * y10 + t28b * y10d;
    y10b = t28b * (1.0 - e7);
    y10bd = t28bd * (1.0 - e7) - t28b * e7d;
    e7b += t28b * t27;
    e7bd += t28bd * t27 + t28b * t27d;
    t27b = t28b * e7;
    t27bd = t28bd * e7 + t28b * e7d;
    y10b += t27b * (1.0 / (1.0 + y10 * y10));
    y10bd += t27bd * (1.0 / (1.0 + y10 * y10)) - t27b * (1.0 / (1.0 + y10 * y10) * (y10d * y10 + y10
        * y10d) / (1.0 + y10 * y10));
    stiff3b = y11b * s2;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    stiff3bd = y11bd * s2 + y11b * s2d;
    s2b = y11b * stiff3;
    s2bd = y11bd * stiff3 + y11b * stiff3d;
    stiff3b += y10b * (kappa + s2);
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    stiff3bd += y10bd * (kappa + s2) + y10b * (kappad + s2d);
    tb47 = y10b * stiff3;
    tb47d = y10bd * stiff3 + y10b * stiff3d;
    kappab += tb47;
    kappabd += tb47d;
    s2b += tb47;
    s2bd += tb47d;
    tb44 = dvb * t26;
    tb44d = dvbd * t26 + dvb * t26d;
    tb45 = tb44 * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma);
    tb45d = tb44d * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma) + tb44 * (pd[t->tyreadr[i] + MAGGI_TYRE_RVY1] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfzd) +
        (pd[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] *
        gammad));
    muy2b = tb45 * fz;
    muy2bd = tb45d * fz + tb45 * fzd;
    fzb += tb45 * muy2;
    fzbd += tb45d * muy2 + tb45 * muy2d;
    tb46 = tb44 * (muy2 * fz);
    tb46d = tb44d * (muy2 * fz) + tb44 * (muy2d * fz + muy2 * fzd);
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY1] += tb46;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RVY1] += tb46d;
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY2] += tb46 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RVY2] += tb46d * dfz + tb46 * dfzd;
    dfzb += tb46 * p[t->tyreadr[i] + MAGGI_TYRE_RVY2];
    dfzbd += tb46d * p[t->tyreadr[i] + MAGGI_TYRE_RVY2] + tb46 * pd[t->tyreadr[i] +
        MAGGI_TYRE_RVY2];
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY3] += tb46 * gamma;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RVY3] += tb46d * gamma + tb46 * gammad;
    gammab += tb46 * p[t->tyreadr[i] + MAGGI_TYRE_RVY3];
    gammabd += tb46d * p[t->tyreadr[i] + MAGGI_TYRE_RVY3] + tb46 * pd[t->tyreadr[i] +
        MAGGI_TYRE_RVY3];
    t26b = dvb * (muy2 * fz * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] +
        MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma));
    t26bd = dvbd * (muy2 * fz * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] +
        MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma)) + dvb * ((muy2d * fz +
        muy2 * fzd) * (p[t->tyreadr[i] + MAGGI_TYRE_RVY1] + p[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz
        + p[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma) + muy2 * fz * (pd[t->tyreadr[i] +
        MAGGI_TYRE_RVY1] + (pd[t->tyreadr[i] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_RVY2] * dfzd) + (pd[t->tyreadr[i] + MAGGI_TYRE_RVY3] * gamma + p[t->tyreadr[i] +
        MAGGI_TYRE_RVY3] * gammad)));
    tb43 = t26b / t25;
    tb43d = (t26bd - tb43 * t25d) * (1.0 / t25);
    t25b = -(tb43 * t26);
    t25bd = -(tb43d * t26 + tb43 * t26d);
    t24b = t25b * (1.0 / (2.0 * t25));
    t24bd = t25bd * (1.0 / (2.0 * t25)) - t25b * (1.0 / (2.0 * t25) * (2.0 * t25d) / (2.0 * t25));
    x3b = t24b * x3;
    x3bd = t24bd * x3 + t24b * x3d;
    x3b += t24b * x3;
    x3bd += t24bd * x3 + t24b * x3d;
    pb[t->tyreadr[i] + MAGGI_TYRE_RVY4] += x3b * a;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RVY4] += x3bd * a + x3b * ad;
    ab += x3b * p[t->tyreadr[i] + MAGGI_TYRE_RVY4];
    abd += x3bd * p[t->tyreadr[i] + MAGGI_TYRE_RVY4] + x3b * pd[t->tyreadr[i] + MAGGI_TYRE_RVY4];
    pb[t->tyreadr[i] + MAGGI_TYRE_RHY1] += s2b;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RHY1] += s2bd;
    pb[t->tyreadr[i] + MAGGI_TYRE_RHY2] += s2b * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RHY2] += s2bd * dfz + s2b * dfzd;
    dfzb += s2b * p[t->tyreadr[i] + MAGGI_TYRE_RHY2];
    dfzbd += s2bd * p[t->tyreadr[i] + MAGGI_TYRE_RHY2] + s2b * pd[t->tyreadr[i] + MAGGI_TYRE_RHY2];
    y9b = e7b;
    y9bd = e7bd;
    e8b = 0.0;
    e8bd = 0.0;
    /* a curvature: more than 1 would turn the curve around */
    if (MAGGI_RE(e8) > 1.0) {
      y9b = 0.0;
      y9bd = 0.0;
    } else {
      e8b += y9b;
      e8bd += y9bd;
      y9b = 0.0;
      y9bd = 0.0;
    }
    pb[t->tyreadr[i] + MAGGI_TYRE_REY1] += e8b;
    pbd[t->tyreadr[i] + MAGGI_TYRE_REY1] += e8bd;
    pb[t->tyreadr[i] + MAGGI_TYRE_REY2] += e8b * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_REY2] += e8bd * dfz + e8b * dfzd;
    dfzb += e8b * p[t->tyreadr[i] + MAGGI_TYRE_REY2];
    dfzbd += e8bd * p[t->tyreadr[i] + MAGGI_TYRE_REY2] + e8b * pd[t->tyreadr[i] + MAGGI_TYRE_REY2];
    tb42 = stiff3b * p[t->tyreadr[i] + MAGGI_TYRE_LYKA];
    tb42d = stiff3bd * p[t->tyreadr[i] + MAGGI_TYRE_LYKA] + stiff3b * pd[t->tyreadr[i] +
        MAGGI_TYRE_LYKA];
    pb[t->tyreadr[i] + MAGGI_TYRE_RBY1] += tb42 * t23;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RBY1] += tb42d * t23 + tb42 * t23d;
    t23b = tb42 * p[t->tyreadr[i] + MAGGI_TYRE_RBY1];
    t23bd = tb42d * p[t->tyreadr[i] + MAGGI_TYRE_RBY1] + tb42 * pd[t->tyreadr[i] + MAGGI_TYRE_RBY1];
    pb[t->tyreadr[i] + MAGGI_TYRE_LYKA] += stiff3b * (p[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LYKA] += stiff3bd * (p[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23) +
        stiff3b * (pd[t->tyreadr[i] + MAGGI_TYRE_RBY1] * t23 + p[t->tyreadr[i] + MAGGI_TYRE_RBY1] *
        t23d);
    tb41 = t23b / t22;
    tb41d = (t23bd - tb41 * t22d) * (1.0 / t22);
    t22b = -(tb41 * t23);
    t22bd = -(tb41d * t23 + tb41 * t23d);
    t21b = t22b * (1.0 / (2.0 * t22));
    t21bd = t22bd * (1.0 / (2.0 * t22)) - t22b * (1.0 / (2.0 * t22) * (2.0 * t22d) / (2.0 * t22));
    x2b = t21b * x2;
    x2bd = t21bd * x2 + t21b * x2d;
    x2b += t21b * x2;
    x2bd += t21bd * x2 + t21b * x2d;
    pb[t->tyreadr[i] + MAGGI_TYRE_RBY2] += x2b * (a - p[t->tyreadr[i] + MAGGI_TYRE_RBY3]);
    /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
    pbd[t->tyreadr[i] + MAGGI_TYRE_RBY2] += x2bd * (a - p[t->tyreadr[i] + MAGGI_TYRE_RBY3]) + x2b *
        (ad - pd[t->tyreadr[i] + MAGGI_TYRE_RBY3]);
    tb40 = x2b * p[t->tyreadr[i] + MAGGI_TYRE_RBY2];
    tb40d = x2bd * p[t->tyreadr[i] + MAGGI_TYRE_RBY2] + x2b * pd[t->tyreadr[i] + MAGGI_TYRE_RBY2];
    ab += tb40;
    abd += tb40d;
    pb[t->tyreadr[i] + MAGGI_TYRE_RBY3] -= tb40;
    pbd[t->tyreadr[i] + MAGGI_TYRE_RBY3] -= tb40d;
    y2_2b = muy2b;
    y2_2bd = muy2bd;
    shyb = y4_2b;
    shybd = y4_2bd;
    t20b = y4_2b;
    t20bd = y4_2bd;
    tb39 = t20b / stiff2;
    tb39d = (t20bd - tb39 * stiff2d) * (1.0 / stiff2);
    svyb = tb39;
    svybd = tb39d;
    stiff2b = -(tb39 * t20);
    stiff2bd = -(tb39d * t20 + tb39 * t20d);
    byb = y3_2b * cy;
    bybd = y3_2bd * cy + y3_2b * cyd;
    cyb = y3_2b * by;
    cybd = y3_2bd * by + y3_2b * byd;
    muyb = y2_2b;
    muybd = y2_2bd;
    stiff2b += y1b;
    stiff2bd += y1bd;
    dyb = y0b * t19;
    dybd = y0bd * t19 + y0b * t19d;
    t19b = y0b * dy;
    t19bd = y0bd * dy + y0b * dyd;
    svyb += y0b;
    svybd += y0bd;
    t18b = t19b * cos(t18);
    t18bd = t19bd * cos(t18) - t19b * (sin(t18) * t18d);
    cyb += t18b * t17;
    cybd += t18bd * t17 + t18b * t17d;
    t17b = t18b * cy;
    t17bd = t18bd * cy + t18b * cyd;
    t16b = t17b * (1.0 / (1.0 + t16 * t16));
    t16bd = t17bd * (1.0 / (1.0 + t16 * t16)) - t17b * (1.0 / (1.0 + t16 * t16) * (t16d * t16 + t16
        * t16d) / (1.0 + t16 * t16));
    eyb = -(t16b * y8);
    eybd = -(t16bd * y8 + t16b * y8d);
    y8b = t16b * (1.0 - ey);
    y8bd = t16bd * (1.0 - ey) - t16b * eyd;
    eyb += t16b * t15;
    eybd += t16bd * t15 + t16b * t15d;
    t15b = t16b * ey;
    t15bd = t16bd * ey + t16b * eyd;
    y8b += t15b * (1.0 / (1.0 + y8 * y8));
    y8bd += t15bd * (1.0 / (1.0 + y8 * y8)) - t15b * (1.0 / (1.0 + y8 * y8) * (y8d * y8 + y8 * y8d)
        / (1.0 + y8 * y8));
    byb += y8b * ay;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    bybd += y8bd * ay + y8b * ayd;
    ayb = y8b * by;
    aybd = y8bd * by + y8b * byd;
    tb35 = svyb * p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    tb35d = svybd * p[t->tyreadr[i] + MAGGI_TYRE_LMUY] + svyb * pd[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    fzb += tb35 * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfz) * gy);
    fzbd += tb35d * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz)
        * p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i]
        + MAGGI_TYRE_PVY4] * dfz) * gy) + tb35 * ((pd[t->tyreadr[i] + MAGGI_TYRE_PVY1] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfzd)) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY2] * dfz) * pd[t->tyreadr[i] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[i] +
        MAGGI_TYRE_PVY3] + (pd[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfzd)) * gy + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfz) * gyd));
    tb36 = tb35 * fz;
    tb36d = tb35d * fz + tb35 * fzd;
    tb37 = tb36 * p[t->tyreadr[i] + MAGGI_TYRE_LVY];
    tb37d = tb36d * p[t->tyreadr[i] + MAGGI_TYRE_LVY] + tb36 * pd[t->tyreadr[i] + MAGGI_TYRE_LVY];
    pb[t->tyreadr[i] + MAGGI_TYRE_PVY1] += tb37;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PVY1] += tb37d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PVY2] += tb37 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PVY2] += tb37d * dfz + tb37 * dfzd;
    dfzb += tb37 * p[t->tyreadr[i] + MAGGI_TYRE_PVY2];
    dfzbd += tb37d * p[t->tyreadr[i] + MAGGI_TYRE_PVY2] + tb37 * pd[t->tyreadr[i] +
        MAGGI_TYRE_PVY2];
    pb[t->tyreadr[i] + MAGGI_TYRE_LVY] += tb36 * (p[t->tyreadr[i] + MAGGI_TYRE_PVY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LVY] += tb36d * (p[t->tyreadr[i] + MAGGI_TYRE_PVY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) + tb36 * (pd[t->tyreadr[i] + MAGGI_TYRE_PVY1] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfzd));
    tb38 = tb36 * gy;
    tb38d = tb36d * gy + tb36 * gyd;
    pb[t->tyreadr[i] + MAGGI_TYRE_PVY3] += tb38;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PVY3] += tb38d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PVY4] += tb38 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PVY4] += tb38d * dfz + tb38 * dfzd;
    dfzb += tb38 * p[t->tyreadr[i] + MAGGI_TYRE_PVY4];
    dfzbd += tb38d * p[t->tyreadr[i] + MAGGI_TYRE_PVY4] + tb38 * pd[t->tyreadr[i] +
        MAGGI_TYRE_PVY4];
    gyb = tb36 * (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz);
    gybd = tb36d * (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz) +
        tb36 * (pd[t->tyreadr[i] + MAGGI_TYRE_PVY3] + (pd[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfzd));
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUY] += svyb * (fz * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LVY] +
        (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz) * gy));
    pbd[t->tyreadr[i] + MAGGI_TYRE_LMUY] += svybd * (fz * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LVY] +
        (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz) * gy)) +
        svyb * (fzd * ((p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] *
        dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz) * gy) + fz * ((pd[t->tyreadr[i] + MAGGI_TYRE_PVY1]
        + (pd[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PVY2] * dfzd)) *
        p[t->tyreadr[i] + MAGGI_TYRE_LVY] + (p[t->tyreadr[i] + MAGGI_TYRE_PVY1] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY2] * dfz) * pd[t->tyreadr[i] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[i] +
        MAGGI_TYRE_PVY3] + (pd[t->tyreadr[i] + MAGGI_TYRE_PVY4] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfzd)) * gy + (p[t->tyreadr[i] + MAGGI_TYRE_PVY3] + p[t->tyreadr[i] +
        MAGGI_TYRE_PVY4] * dfz) * gyd)));
    tb34 = byb / t14;
    tb34d = (bybd - tb34 * t14d) * (1.0 / t14);
    stiff2b += tb34;
    stiff2bd += tb34d;
    t14b = -(tb34 * by);
    t14bd = -(tb34d * by + tb34 * byd);
    cyb += t14b * dy;
    cybd += t14bd * dy + t14b * dyd;
    dyb += t14b * cy;
    dybd += t14bd * cy + t14b * cyd;
    tb30 = stiff2b * p[t->tyreadr[i] + MAGGI_TYRE_LKY];
    tb30d = stiff2bd * p[t->tyreadr[i] + MAGGI_TYRE_LKY] + stiff2b * pd[t->tyreadr[i] +
        MAGGI_TYRE_LKY];
    tb31 = tb30 * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7);
    tb31d = tb30d * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7) - tb30 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_PKY3] * y7 + p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7d);
    tb32 = tb31 * t13;
    tb32d = tb31d * t13 + tb31 * t13d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PKY1] += tb32 * fz0_2;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PKY1] += tb32d * fz0_2 + tb32 * fz0_2d;
    fz0_2b = tb32 * p[t->tyreadr[i] + MAGGI_TYRE_PKY1];
    fz0_2bd = tb32d * p[t->tyreadr[i] + MAGGI_TYRE_PKY1] + tb32 * pd[t->tyreadr[i] +
        MAGGI_TYRE_PKY1];
    t13b = tb31 * (p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2);
    t13bd = tb31d * (p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2) + tb31 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_PKY1] * fz0_2 + p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2d);
    tb33 = tb30 * (p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13);
    tb33d = tb30d * (p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13) + tb30 * ((pd[t->tyreadr[i] +
        MAGGI_TYRE_PKY1] * fz0_2 + p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2d) * t13 +
        p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13d);
    pb[t->tyreadr[i] + MAGGI_TYRE_PKY3] -= tb33 * y7;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PKY3] -= tb33d * y7 + tb33 * y7d;
    y7b = -(tb33 * p[t->tyreadr[i] + MAGGI_TYRE_PKY3]);
    y7bd = -(tb33d * p[t->tyreadr[i] + MAGGI_TYRE_PKY3] + tb33 * pd[t->tyreadr[i] +
        MAGGI_TYRE_PKY3]);
    pb[t->tyreadr[i] + MAGGI_TYRE_LKY] += stiff2b * (p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 *
        t13 * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7));
    pbd[t->tyreadr[i] + MAGGI_TYRE_LKY] += stiff2bd * (p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 *
        t13 * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7)) + stiff2b * (((pd[t->tyreadr[i] +
        MAGGI_TYRE_PKY1] * fz0_2 + p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2d) * t13 +
        p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13d) * (1.0 - p[t->tyreadr[i] +
        MAGGI_TYRE_PKY3] * y7) - p[t->tyreadr[i] + MAGGI_TYRE_PKY1] * fz0_2 * t13 *
        (pd[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7 + p[t->tyreadr[i] + MAGGI_TYRE_PKY3] * y7d));
    tb29 = t13b / t12;
    tb29d = (t13bd - tb29 * t12d) * (1.0 / t12);
    z2b = tb29 * 2.0;
    z2bd = tb29d * 2.0;
    t12b = -(tb29 * t13);
    t12bd = -(tb29d * t13 + tb29 * t13d);
    z2b += t12b * z2;
    z2bd += t12bd * z2 + t12b * z2d;
    z2b += t12b * z2;
    z2bd += t12bd * z2 + t12b * z2d;
    /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
     * where straight running is, and exact from w on */
    if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      gyb += y7b;
      gybd += y7bd;
      y7b = 0.0;
      y7bd = 0.0;
    } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER])) {
      gyb -= y7b;
      gybd -= y7bd;
      y7b = 0.0;
      y7bd = 0.0;
    } else {
      p2 = p[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      p2d = pd[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER];
      t11 = p2 * p2;
      t11d = p2d * p2 + p2 * p2d;
      z3 = gy * gy / t11;
      z3d = (gyd * gy + gy * gyd - z3 * t11d) * (1.0 / t11);
      tb27 = y7b * (15.0 + z3 * (-10.0 + 3.0 * z3));
      tb27d = y7bd * (15.0 + z3 * (-10.0 + 3.0 * z3)) + y7b * (z3d * (-10.0 + 3.0 * z3) + z3 * (3.0
          * z3d));
      p2b = tb27 * z3 * 0.125;
      p2bd = (tb27d * z3 + tb27 * z3d) * 0.125;
      z3b = tb27 * (0.125 * p2);
      z3bd = tb27d * (0.125 * p2) + tb27 * (0.125 * p2d);
      tb28 = y7b * (0.125 * p2 * z3);
      tb28d = y7bd * (0.125 * p2 * z3) + y7b * (0.125 * p2d * z3 + 0.125 * p2 * z3d);
      z3b += tb28 * (-10.0 + 3.0 * z3);
      z3bd += tb28d * (-10.0 + 3.0 * z3) + tb28 * (3.0 * z3d);
      z3b += tb28 * z3 * 3.0;
      z3bd += (tb28d * z3 + tb28 * z3d) * 3.0;
      y7b = 0.0;
      y7bd = 0.0;
      tb26 = z3b / t11;
      tb26d = (z3bd - tb26 * t11d) * (1.0 / t11);
      gyb += tb26 * gy;
      gybd += tb26d * gy + tb26 * gyd;
      gyb += tb26 * gy;
      gybd += tb26d * gy + tb26 * gyd;
      t11b = -(tb26 * z3);
      t11bd = -(tb26d * z3 + tb26 * z3d);
      p2b += t11b * p2;
      p2bd += t11bd * p2 + t11b * p2d;
      p2b += t11b * p2;
      p2bd += t11bd * p2 + t11b * p2d;
      pb[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER] += p2b;
      pbd[t->tyreadr[i] + MAGGI_TYRE_LOW_CAMBER] += p2bd;
    }
    tb25 = z2b / t10;
    tb25d = (z2bd - tb25 * t10d) * (1.0 / t10);
    fzb += tb25;
    fzbd += tb25d;
    t10b = -(tb25 * z2);
    t10bd = -(tb25d * z2 + tb25 * z2d);
    pb[t->tyreadr[i] + MAGGI_TYRE_PKY2] += t10b * fz0_2;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PKY2] += t10bd * fz0_2 + t10b * fz0_2d;
    fz0_2b += t10b * p[t->tyreadr[i] + MAGGI_TYRE_PKY2];
    fz0_2bd += t10bd * p[t->tyreadr[i] + MAGGI_TYRE_PKY2] + t10b * pd[t->tyreadr[i] +
        MAGGI_TYRE_PKY2];
    e4b = 0.0;
    e4bd = 0.0;
    if (MAGGI_RE(ay) > 0.0) {
      e5 = e4 * (1.0 - (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
      e5d = e4d * (1.0 - (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy)) - e4 * (pd[t->tyreadr[i] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] * gyd));
      y5b = eyb;
      y5bd = eybd;
      eyb = 0.0;
      eybd = 0.0;
      e5b = 0.0;
      e5bd = 0.0;
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e5) > 1.0) {
        y5b = 0.0;
        y5bd = 0.0;
      } else {
        e5b += y5b;
        e5bd += y5bd;
        y5b = 0.0;
        y5bd = 0.0;
      }
      e4b += e5b * (1.0 - (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
      e4bd += e5bd * (1.0 - (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4]
          * gy)) - e5b * (pd[t->tyreadr[i] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[i] + MAGGI_TYRE_PEY4]
          * gy + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] * gyd));
      tb23 = e5b * e4;
      tb23d = e5bd * e4 + e5b * e4d;
      pb[t->tyreadr[i] + MAGGI_TYRE_PEY3] -= tb23;
      pbd[t->tyreadr[i] + MAGGI_TYRE_PEY3] -= tb23d;
      pb[t->tyreadr[i] + MAGGI_TYRE_PEY4] -= tb23 * gy;
      pbd[t->tyreadr[i] + MAGGI_TYRE_PEY4] -= tb23d * gy + tb23 * gyd;
      gyb -= tb23 * p[t->tyreadr[i] + MAGGI_TYRE_PEY4];
      gybd -= tb23d * p[t->tyreadr[i] + MAGGI_TYRE_PEY4] + tb23 * pd[t->tyreadr[i] +
          MAGGI_TYRE_PEY4];
    } else {
      e6 = e4 * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
      e6d = e4d * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy)) + e4 * (pd[t->tyreadr[i] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] * gyd));
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
      e4b += e6b * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] *
          gy));
      e4bd += e6bd * (1.0 + (p[t->tyreadr[i] + MAGGI_TYRE_PEY3] + p[t->tyreadr[i] + MAGGI_TYRE_PEY4]
          * gy)) + e6b * (pd[t->tyreadr[i] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[i] + MAGGI_TYRE_PEY4]
          * gy + p[t->tyreadr[i] + MAGGI_TYRE_PEY4] * gyd));
      tb24 = e6b * e4;
      tb24d = e6bd * e4 + e6b * e4d;
      pb[t->tyreadr[i] + MAGGI_TYRE_PEY3] += tb24;
      pbd[t->tyreadr[i] + MAGGI_TYRE_PEY3] += tb24d;
      pb[t->tyreadr[i] + MAGGI_TYRE_PEY4] += tb24 * gy;
      pbd[t->tyreadr[i] + MAGGI_TYRE_PEY4] += tb24d * gy + tb24 * gyd;
      gyb += tb24 * p[t->tyreadr[i] + MAGGI_TYRE_PEY4];
      gybd += tb24d * p[t->tyreadr[i] + MAGGI_TYRE_PEY4] + tb24 * pd[t->tyreadr[i] +
          MAGGI_TYRE_PEY4];
    }
    tb22 = e4b * p[t->tyreadr[i] + MAGGI_TYRE_LEY];
    tb22d = e4bd * p[t->tyreadr[i] + MAGGI_TYRE_LEY] + e4b * pd[t->tyreadr[i] + MAGGI_TYRE_LEY];
    pb[t->tyreadr[i] + MAGGI_TYRE_PEY1] += tb22;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PEY1] += tb22d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PEY2] += tb22 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PEY2] += tb22d * dfz + tb22 * dfzd;
    dfzb += tb22 * p[t->tyreadr[i] + MAGGI_TYRE_PEY2];
    dfzbd += tb22d * p[t->tyreadr[i] + MAGGI_TYRE_PEY2] + tb22 * pd[t->tyreadr[i] +
        MAGGI_TYRE_PEY2];
    pb[t->tyreadr[i] + MAGGI_TYRE_LEY] += e4b * (p[t->tyreadr[i] + MAGGI_TYRE_PEY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PEY2] * dfz);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LEY] += e4bd * (p[t->tyreadr[i] + MAGGI_TYRE_PEY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PEY2] * dfz) + e4b * (pd[t->tyreadr[i] + MAGGI_TYRE_PEY1] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_PEY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PEY2] * dfzd));
    muyb += dyb * fz;
    muybd += dybd * fz + dyb * fzd;
    fzb += dyb * muy;
    fzbd += dybd * muy + dyb * muyd;
    tb18 = muyb * p[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    tb18d = muybd * p[t->tyreadr[i] + MAGGI_TYRE_LMUY] + muyb * pd[t->tyreadr[i] + MAGGI_TYRE_LMUY];
    tb19 = tb18 * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy * gy);
    tb19d = tb18d * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy * gy) - tb18 * ((pd[t->tyreadr[i]
        + MAGGI_TYRE_PDY3] * gy + p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gyd) * gy + p[t->tyreadr[i] +
        MAGGI_TYRE_PDY3] * gy * gyd);
    pb[t->tyreadr[i] + MAGGI_TYRE_PDY1] += tb19;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PDY1] += tb19d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PDY2] += tb19 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PDY2] += tb19d * dfz + tb19 * dfzd;
    dfzb += tb19 * p[t->tyreadr[i] + MAGGI_TYRE_PDY2];
    dfzbd += tb19d * p[t->tyreadr[i] + MAGGI_TYRE_PDY2] + tb19 * pd[t->tyreadr[i] +
        MAGGI_TYRE_PDY2];
    tb20 = tb18 * (p[t->tyreadr[i] + MAGGI_TYRE_PDY1] + p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz);
    tb20d = tb18d * (p[t->tyreadr[i] + MAGGI_TYRE_PDY1] + p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz)
        + tb18 * (pd[t->tyreadr[i] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfzd));
    tb21 = tb20 * gy;
    tb21d = tb20d * gy + tb20 * gyd;
    pb[t->tyreadr[i] + MAGGI_TYRE_PDY3] -= tb21 * gy;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PDY3] -= tb21d * gy + tb21 * gyd;
    gyb -= tb21 * p[t->tyreadr[i] + MAGGI_TYRE_PDY3];
    gybd -= tb21d * p[t->tyreadr[i] + MAGGI_TYRE_PDY3] + tb21 * pd[t->tyreadr[i] + MAGGI_TYRE_PDY3];
    gyb -= tb20 * (p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy);
    gybd -= tb20d * (p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy) + tb20 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_PDY3] * gy + p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gyd);
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUY] += muyb * ((p[t->tyreadr[i] + MAGGI_TYRE_PDY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy *
        gy));
    pbd[t->tyreadr[i] + MAGGI_TYRE_LMUY] += muybd * ((p[t->tyreadr[i] + MAGGI_TYRE_PDY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy *
        gy)) + muyb * ((pd[t->tyreadr[i] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PDY2] *
        dfz + p[t->tyreadr[i] + MAGGI_TYRE_PDY2] * dfzd)) * (1.0 - p[t->tyreadr[i] +
        MAGGI_TYRE_PDY3] * gy * gy) - (p[t->tyreadr[i] + MAGGI_TYRE_PDY1] + p[t->tyreadr[i] +
        MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy + p[t->tyreadr[i] +
        MAGGI_TYRE_PDY3] * gyd) * gy + p[t->tyreadr[i] + MAGGI_TYRE_PDY3] * gy * gyd));
    pb[t->tyreadr[i] + MAGGI_TYRE_PCY1] += cyb * p[t->tyreadr[i] + MAGGI_TYRE_LCY];
    pbd[t->tyreadr[i] + MAGGI_TYRE_PCY1] += cybd * p[t->tyreadr[i] + MAGGI_TYRE_LCY] + cyb *
        pd[t->tyreadr[i] + MAGGI_TYRE_LCY];
    pb[t->tyreadr[i] + MAGGI_TYRE_LCY] += cyb * p[t->tyreadr[i] + MAGGI_TYRE_PCY1];
    pbd[t->tyreadr[i] + MAGGI_TYRE_LCY] += cybd * p[t->tyreadr[i] + MAGGI_TYRE_PCY1] + cyb *
        pd[t->tyreadr[i] + MAGGI_TYRE_PCY1];
    ab += ayb;
    abd += aybd;
    shyb += ayb;
    shybd += aybd;
    tb17 = shyb * p[t->tyreadr[i] + MAGGI_TYRE_LHY];
    tb17d = shybd * p[t->tyreadr[i] + MAGGI_TYRE_LHY] + shyb * pd[t->tyreadr[i] + MAGGI_TYRE_LHY];
    pb[t->tyreadr[i] + MAGGI_TYRE_PHY1] += tb17;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PHY1] += tb17d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PHY2] += tb17 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PHY2] += tb17d * dfz + tb17 * dfzd;
    dfzb += tb17 * p[t->tyreadr[i] + MAGGI_TYRE_PHY2];
    dfzbd += tb17d * p[t->tyreadr[i] + MAGGI_TYRE_PHY2] + tb17 * pd[t->tyreadr[i] +
        MAGGI_TYRE_PHY2];
    pb[t->tyreadr[i] + MAGGI_TYRE_LHY] += shyb * (p[t->tyreadr[i] + MAGGI_TYRE_PHY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PHY2] * dfz);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LHY] += shybd * (p[t->tyreadr[i] + MAGGI_TYRE_PHY1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PHY2] * dfz) + shyb * (pd[t->tyreadr[i] + MAGGI_TYRE_PHY1] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_PHY2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PHY2] * dfzd));
    pb[t->tyreadr[i] + MAGGI_TYRE_PHY3] += shyb * gy;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PHY3] += shybd * gy + shyb * gyd;
    gyb += shyb * p[t->tyreadr[i] + MAGGI_TYRE_PHY3];
    gybd += shybd * p[t->tyreadr[i] + MAGGI_TYRE_PHY3] + shyb * pd[t->tyreadr[i] + MAGGI_TYRE_PHY3];
    gammab += gyb * p[t->tyreadr[i] + MAGGI_TYRE_LGAY];
    gammabd += gybd * p[t->tyreadr[i] + MAGGI_TYRE_LGAY] + gyb * pd[t->tyreadr[i] +
        MAGGI_TYRE_LGAY];
    pb[t->tyreadr[i] + MAGGI_TYRE_LGAY] += gyb * gamma;
    pbd[t->tyreadr[i] + MAGGI_TYRE_LGAY] += gybd * gamma + gyb * gammad;
    pb[t->tyreadr[i] + MAGGI_TYRE_LFZO] += fz0_2b * p[t->tyreadr[i]];
    /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
    pbd[t->tyreadr[i] + MAGGI_TYRE_LFZO] += fz0_2bd * p[t->tyreadr[i]] + fz0_2b * pd[t->tyreadr[i]];
    pb[t->tyreadr[i]] += fz0_2b * p[t->tyreadr[i] + MAGGI_TYRE_LFZO];
    pbd[t->tyreadr[i]] += fz0_2bd * p[t->tyreadr[i] + MAGGI_TYRE_LFZO] + fz0_2b * pd[t->tyreadr[i] +
        MAGGI_TYRE_LFZO];
    stiffb = x1b;
    stiffbd = x1bd;
    dxb = x0b * t9;
    dxbd = x0bd * t9 + x0b * t9d;
    t9b = x0b * dx;
    t9bd = x0bd * dx + x0b * dxd;
    svxb = x0b;
    svxbd = x0bd;
    t8b = t9b * cos(t8);
    t8bd = t9bd * cos(t8) - t9b * (sin(t8) * t8d);
    cxb = t8b * t7;
    cxbd = t8bd * t7 + t8b * t7d;
    t7b = t8b * cx;
    t7bd = t8bd * cx + t8b * cxd;
    t6b = t7b * (1.0 / (1.0 + t6 * t6));
    t6bd = t7bd * (1.0 / (1.0 + t6 * t6)) - t7b * (1.0 / (1.0 + t6 * t6) * (t6d * t6 + t6 * t6d) /
        (1.0 + t6 * t6));
    exb = -(t6b * y4);
    exbd = -(t6bd * y4 + t6b * y4d);
    y4b = t6b * (1.0 - ex);
    y4bd = t6bd * (1.0 - ex) - t6b * exd;
    exb += t6b * t5;
    exbd += t6bd * t5 + t6b * t5d;
    t5b = t6b * ex;
    t5bd = t6bd * ex + t6b * exd;
    y4b += t5b * (1.0 / (1.0 + y4 * y4));
    y4bd += t5bd * (1.0 / (1.0 + y4 * y4)) - t5b * (1.0 / (1.0 + y4 * y4) * (y4d * y4 + y4 * y4d) /
        (1.0 + y4 * y4));
    bxb = y4b * kx;
    /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
    bxbd = y4bd * kx + y4b * kxd;
    kxb = y4b * bx;
    kxbd = y4bd * bx + y4b * bxd;
    tb14 = svxb * p[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    tb14d = svxbd * p[t->tyreadr[i] + MAGGI_TYRE_LMUX] + svxb * pd[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    tb15 = tb14 * p[t->tyreadr[i] + MAGGI_TYRE_LVX];
    tb15d = tb14d * p[t->tyreadr[i] + MAGGI_TYRE_LVX] + tb14 * pd[t->tyreadr[i] + MAGGI_TYRE_LVX];
    fzb += tb15 * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz);
    fzbd += tb15d * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz)
        + tb15 * (pd[t->tyreadr[i] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfzd));
    tb16 = tb15 * fz;
    tb16d = tb15d * fz + tb15 * fzd;
    pb[t->tyreadr[i] + MAGGI_TYRE_PVX1] += tb16;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PVX1] += tb16d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PVX2] += tb16 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PVX2] += tb16d * dfz + tb16 * dfzd;
    dfzb += tb16 * p[t->tyreadr[i] + MAGGI_TYRE_PVX2];
    dfzbd += tb16d * p[t->tyreadr[i] + MAGGI_TYRE_PVX2] + tb16 * pd[t->tyreadr[i] +
        MAGGI_TYRE_PVX2];
    pb[t->tyreadr[i] + MAGGI_TYRE_LVX] += tb14 * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz));
    pbd[t->tyreadr[i] + MAGGI_TYRE_LVX] += tb14d * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz)) + tb14 * (fzd * (p[t->tyreadr[i] +
        MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) + fz * (pd[t->tyreadr[i] +
        MAGGI_TYRE_PVX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_PVX2] * dfzd)));
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUX] += svxb * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LVX]);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LMUX] += svxbd * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[i] + MAGGI_TYRE_LVX]) + svxb *
        ((fzd * (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) + fz
        * (pd[t->tyreadr[i] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfzd))) * p[t->tyreadr[i] + MAGGI_TYRE_LVX] + fz *
        (p[t->tyreadr[i] + MAGGI_TYRE_PVX1] + p[t->tyreadr[i] + MAGGI_TYRE_PVX2] * dfz) *
        pd[t->tyreadr[i] + MAGGI_TYRE_LVX]);
    tb13 = bxb / t4;
    tb13d = (bxbd - tb13 * t4d) * (1.0 / t4);
    stiffb += tb13;
    stiffbd += tb13d;
    t4b = -(tb13 * bx);
    t4bd = -(tb13d * bx + tb13 * bxd);
    cxb += t4b * dx;
    cxbd += t4bd * dx + t4b * dxd;
    dxb += t4b * cx;
    dxbd += t4bd * cx + t4b * cxd;
    tb10 = stiffb * p[t->tyreadr[i] + MAGGI_TYRE_LKX];
    tb10d = stiffbd * p[t->tyreadr[i] + MAGGI_TYRE_LKX] + stiffb * pd[t->tyreadr[i] +
        MAGGI_TYRE_LKX];
    tb11 = tb10 * t3;
    tb11d = tb10d * t3 + tb10 * t3d;
    fzb += tb11 * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz);
    fzbd += tb11d * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz)
        + tb11 * (pd[t->tyreadr[i] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfzd));
    tb12 = tb11 * fz;
    tb12d = tb11d * fz + tb11 * fzd;
    pb[t->tyreadr[i] + MAGGI_TYRE_PKX1] += tb12;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PKX1] += tb12d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PKX2] += tb12 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PKX2] += tb12d * dfz + tb12 * dfzd;
    dfzb += tb12 * p[t->tyreadr[i] + MAGGI_TYRE_PKX2];
    dfzbd += tb12d * p[t->tyreadr[i] + MAGGI_TYRE_PKX2] + tb12 * pd[t->tyreadr[i] +
        MAGGI_TYRE_PKX2];
    t3b = tb10 * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] *
        dfz));
    t3bd = tb10d * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] *
        dfz)) + tb10 * (fzd * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i] +
        MAGGI_TYRE_PKX2] * dfz) + fz * (pd[t->tyreadr[i] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[i] +
        MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfzd)));
    pb[t->tyreadr[i] + MAGGI_TYRE_LKX] += stiffb * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz) * t3);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LKX] += stiffbd * (fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz) * t3) + stiffb * ((fzd * (p[t->tyreadr[i] +
        MAGGI_TYRE_PKX1] + p[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz) + fz * (pd[t->tyreadr[i] +
        MAGGI_TYRE_PKX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[i] +
        MAGGI_TYRE_PKX2] * dfzd))) * t3 + fz * (p[t->tyreadr[i] + MAGGI_TYRE_PKX1] + p[t->tyreadr[i]
        + MAGGI_TYRE_PKX2] * dfz) * t3d);
    t2b = t3b * t3;
    t2bd = t3bd * t3 + t3b * t3d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PKX3] += t2b * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PKX3] += t2bd * dfz + t2b * dfzd;
    dfzb += t2b * p[t->tyreadr[i] + MAGGI_TYRE_PKX3];
    dfzbd += t2bd * p[t->tyreadr[i] + MAGGI_TYRE_PKX3] + t2b * pd[t->tyreadr[i] + MAGGI_TYRE_PKX3];
    eb = 0.0;
    ebd = 0.0;
    if (MAGGI_RE(kx) > 0.0) {
      e2 = e * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
      e2d = ed * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PEX4]) - e * pd[t->tyreadr[i] +
          MAGGI_TYRE_PEX4];
      y2b = exb;
      y2bd = exbd;
      exb = 0.0;
      exbd = 0.0;
      e2b = 0.0;
      e2bd = 0.0;
      /* a curvature: more than 1 would turn the curve around */
      if (MAGGI_RE(e2) > 1.0) {
        y2b = 0.0;
        y2bd = 0.0;
      } else {
        e2b += y2b;
        e2bd += y2bd;
        y2b = 0.0;
        y2bd = 0.0;
      }
      eb += e2b * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
      ebd += e2bd * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PEX4]) - e2b * pd[t->tyreadr[i] +
          MAGGI_TYRE_PEX4];
      pb[t->tyreadr[i] + MAGGI_TYRE_PEX4] -= e2b * e;
      pbd[t->tyreadr[i] + MAGGI_TYRE_PEX4] -= e2bd * e + e2b * ed;
    } else {
      e3 = e * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
      e3d = ed * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_PEX4]) + e * pd[t->tyreadr[i] +
          MAGGI_TYRE_PEX4];
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
      eb += e3b * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_PEX4]);
      ebd += e3bd * (1.0 + p[t->tyreadr[i] + MAGGI_TYRE_PEX4]) + e3b * pd[t->tyreadr[i] +
          MAGGI_TYRE_PEX4];
      pb[t->tyreadr[i] + MAGGI_TYRE_PEX4] += e3b * e;
      pbd[t->tyreadr[i] + MAGGI_TYRE_PEX4] += e3bd * e + e3b * ed;
    }
    tb8 = eb * p[t->tyreadr[i] + MAGGI_TYRE_LEX];
    tb8d = ebd * p[t->tyreadr[i] + MAGGI_TYRE_LEX] + eb * pd[t->tyreadr[i] + MAGGI_TYRE_LEX];
    pb[t->tyreadr[i] + MAGGI_TYRE_PEX1] += tb8;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PEX1] += tb8d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PEX2] += tb8 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PEX2] += tb8d * dfz + tb8 * dfzd;
    dfzb += tb8 * p[t->tyreadr[i] + MAGGI_TYRE_PEX2];
    dfzbd += tb8d * p[t->tyreadr[i] + MAGGI_TYRE_PEX2] + tb8 * pd[t->tyreadr[i] + MAGGI_TYRE_PEX2];
    tb9 = tb8 * dfz;
    tb9d = tb8d * dfz + tb8 * dfzd;
    pb[t->tyreadr[i] + MAGGI_TYRE_PEX3] += tb9 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PEX3] += tb9d * dfz + tb9 * dfzd;
    dfzb += tb9 * p[t->tyreadr[i] + MAGGI_TYRE_PEX3];
    dfzbd += tb9d * p[t->tyreadr[i] + MAGGI_TYRE_PEX3] + tb9 * pd[t->tyreadr[i] + MAGGI_TYRE_PEX3];
    dfzb += tb8 * (p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz);
    dfzbd += tb8d * (p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz) + tb8 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_PEX3] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfzd);
    pb[t->tyreadr[i] + MAGGI_TYRE_LEX] += eb * (p[t->tyreadr[i] + MAGGI_TYRE_PEX1] + p[t->tyreadr[i]
        + MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz * dfz);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LEX] += ebd * (p[t->tyreadr[i] + MAGGI_TYRE_PEX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz * dfz) +
        eb * (pd[t->tyreadr[i] + MAGGI_TYRE_PEX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PEX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PEX2] * dfzd) + ((pd[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfzd) * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PEX3] * dfz
        * dfzd));
    muxb = dxb * fz;
    muxbd = dxbd * fz + dxb * fzd;
    fzb += dxb * mux;
    fzbd += dxbd * mux + dxb * muxd;
    tb4 = muxb * p[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    tb4d = muxbd * p[t->tyreadr[i] + MAGGI_TYRE_LMUX] + muxb * pd[t->tyreadr[i] + MAGGI_TYRE_LMUX];
    tb5 = tb4 * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx * gx);
    tb5d = tb4d * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx * gx) - tb4 * ((pd[t->tyreadr[i] +
        MAGGI_TYRE_PDX3] * gx + p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gxd) * gx + p[t->tyreadr[i] +
        MAGGI_TYRE_PDX3] * gx * gxd);
    pb[t->tyreadr[i] + MAGGI_TYRE_PDX1] += tb5;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PDX1] += tb5d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PDX2] += tb5 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PDX2] += tb5d * dfz + tb5 * dfzd;
    dfzb += tb5 * p[t->tyreadr[i] + MAGGI_TYRE_PDX2];
    dfzbd += tb5d * p[t->tyreadr[i] + MAGGI_TYRE_PDX2] + tb5 * pd[t->tyreadr[i] + MAGGI_TYRE_PDX2];
    tb6 = tb4 * (p[t->tyreadr[i] + MAGGI_TYRE_PDX1] + p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz);
    tb6d = tb4d * (p[t->tyreadr[i] + MAGGI_TYRE_PDX1] + p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz) +
        tb4 * (pd[t->tyreadr[i] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz +
        p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfzd));
    tb7 = tb6 * gx;
    tb7d = tb6d * gx + tb6 * gxd;
    pb[t->tyreadr[i] + MAGGI_TYRE_PDX3] -= tb7 * gx;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PDX3] -= tb7d * gx + tb7 * gxd;
    gxb = -(tb7 * p[t->tyreadr[i] + MAGGI_TYRE_PDX3]);
    gxbd = -(tb7d * p[t->tyreadr[i] + MAGGI_TYRE_PDX3] + tb7 * pd[t->tyreadr[i] + MAGGI_TYRE_PDX3]);
    gxb -= tb6 * (p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx);
    gxbd -= tb6d * (p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx) + tb6 * (pd[t->tyreadr[i] +
        MAGGI_TYRE_PDX3] * gx + p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gxd);
    pb[t->tyreadr[i] + MAGGI_TYRE_LMUX] += muxb * ((p[t->tyreadr[i] + MAGGI_TYRE_PDX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx *
        gx));
    pbd[t->tyreadr[i] + MAGGI_TYRE_LMUX] += muxbd * ((p[t->tyreadr[i] + MAGGI_TYRE_PDX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx *
        gx)) + muxb * ((pd[t->tyreadr[i] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[i] + MAGGI_TYRE_PDX2] *
        dfz + p[t->tyreadr[i] + MAGGI_TYRE_PDX2] * dfzd)) * (1.0 - p[t->tyreadr[i] +
        MAGGI_TYRE_PDX3] * gx * gx) - (p[t->tyreadr[i] + MAGGI_TYRE_PDX1] + p[t->tyreadr[i] +
        MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx + p[t->tyreadr[i] +
        MAGGI_TYRE_PDX3] * gxd) * gx + p[t->tyreadr[i] + MAGGI_TYRE_PDX3] * gx * gxd));
    pb[t->tyreadr[i] + MAGGI_TYRE_PCX1] += cxb * p[t->tyreadr[i] + MAGGI_TYRE_LCX];
    pbd[t->tyreadr[i] + MAGGI_TYRE_PCX1] += cxbd * p[t->tyreadr[i] + MAGGI_TYRE_LCX] + cxb *
        pd[t->tyreadr[i] + MAGGI_TYRE_LCX];
    pb[t->tyreadr[i] + MAGGI_TYRE_LCX] += cxb * p[t->tyreadr[i] + MAGGI_TYRE_PCX1];
    pbd[t->tyreadr[i] + MAGGI_TYRE_LCX] += cxbd * p[t->tyreadr[i] + MAGGI_TYRE_PCX1] + cxb *
        pd[t->tyreadr[i] + MAGGI_TYRE_PCX1];
    gammab += gxb * p[t->tyreadr[i] + MAGGI_TYRE_LGAX];
    gammabd += gxbd * p[t->tyreadr[i] + MAGGI_TYRE_LGAX] + gxb * pd[t->tyreadr[i] +
        MAGGI_TYRE_LGAX];
    pb[t->tyreadr[i] + MAGGI_TYRE_LGAX] += gxb * gamma;
    pbd[t->tyreadr[i] + MAGGI_TYRE_LGAX] += gxbd * gamma + gxb * gammad;
    kappab += kxb;
    /* Fx0, Kx */
    kappabd += kxbd;
    tb3 = kxb * p[t->tyreadr[i] + MAGGI_TYRE_LHX];
    tb3d = kxbd * p[t->tyreadr[i] + MAGGI_TYRE_LHX] + kxb * pd[t->tyreadr[i] + MAGGI_TYRE_LHX];
    pb[t->tyreadr[i] + MAGGI_TYRE_PHX1] += tb3;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PHX1] += tb3d;
    pb[t->tyreadr[i] + MAGGI_TYRE_PHX2] += tb3 * dfz;
    pbd[t->tyreadr[i] + MAGGI_TYRE_PHX2] += tb3d * dfz + tb3 * dfzd;
    dfzb += tb3 * p[t->tyreadr[i] + MAGGI_TYRE_PHX2];
    dfzbd += tb3d * p[t->tyreadr[i] + MAGGI_TYRE_PHX2] + tb3 * pd[t->tyreadr[i] + MAGGI_TYRE_PHX2];
    pb[t->tyreadr[i] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[i] + MAGGI_TYRE_PHX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfz);
    pbd[t->tyreadr[i] + MAGGI_TYRE_LHX] += kxbd * (p[t->tyreadr[i] + MAGGI_TYRE_PHX1] +
        p[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfz) + kxb * (pd[t->tyreadr[i] + MAGGI_TYRE_PHX1] +
        (pd[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfz + p[t->tyreadr[i] + MAGGI_TYRE_PHX2] * dfzd));
    tb2 = dfzb / fz0;
    tb2d = (dfzbd - tb2 * fz0d) * (1.0 / fz0);
    fzb += tb2;
    fzbd += tb2d;
    fz0b -= tb2;
    fz0bd -= tb2d;
    fz0b -= tb2 * dfz;
    fz0bd -= tb2d * dfz + tb2 * dfzd;
    pb[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] += r0b;
    pbd[t->tyreadr[i] + MAGGI_TYRE_UNLOADED_RADIUS] += r0bd;
    pb[t->tyreadr[i] + MAGGI_TYRE_LFZO] += fz0b * p[t->tyreadr[i]];
    pbd[t->tyreadr[i] + MAGGI_TYRE_LFZO] += fz0bd * p[t->tyreadr[i]] + fz0b * pd[t->tyreadr[i]];
    pb[t->tyreadr[i]] += fz0b * p[t->tyreadr[i] + MAGGI_TYRE_LFZO];
    pbd[t->tyreadr[i]] += fz0bd * p[t->tyreadr[i] + MAGGI_TYRE_LFZO] + fz0b * pd[t->tyreadr[i] +
        MAGGI_TYRE_LFZO];
    slipb[i][3] += fzb;
    slipbd[i][3] += fzbd;
    slipb[i][2] += gammab;
    slipbd[i][2] += gammabd;
    slipb[i][1] += ab;
    slipbd[i][1] += abd;
    slipb[i][0] += kappab;
    slipbd[i][0] += kappabd;
  }
}

/* Rates of the coordinates on which wheels turn at which they roll freely, kappa = 0: with V the velocity of
 * the contact point on the carrier and w the velocity of the wheel by its coordinate
 *   v = V.t / (Re w.u) */
void maggi_rolling_b_d(const maggi_topo *t, const double p[restrict t->np],
                       const double pd[restrict t->np], double pb[restrict t->np],
                       double pbd[restrict t->np], const double A[restrict t->nbody + 1][9],
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
  int adr, body, carrier, i, road;
  double N0, N0b, N0bd, N0d, N1, N2, N2b, N2bd, N2d, T0, T0b, T0bd, T0d, T1, T1b, T1bd, T1d, T2,
      T2b, T2bd, T2d, a00, a00b, a00bd, a00d, a01, a01b, a01bd, a01d, a02, a02b, a02bd, a02d,
      along0, along0b, along0bd, along0d, along1, along1b, along1bd, along1d, along2, along2b,
      along2bd, along2d, arm0, arm0b, arm0bd, arm0d, arm1, arm1b, arm1bd, arm1d, arm2, arm2b,
      arm2bd, arm2d, c0, c0b, c0bd, c0d, c1, c1b, c1bd, c1d, c2, c2_2, c2_2b, c2_2bd, c2_2d, c2b,
      c2bd, c2d, fz, fz0, fz0b, fz0bd, fz0d, fzb, fzbd, fzd, g0, g0b, g0bd, g0d, g2, g2b, g2bd, g2d,
      h00, h00b, h00bd, h00d, h10, h10b, h10bd, h10d, h11, h11b, h11bd, h11d, n2, n2b, n2bd, n2d,
      n30, n30b, n30bd, n30d, n31, n32, n32b, n32bd, n32d, p2, p2b, p2bd, p2d, p3, p3b, p3bd, p3d,
      p_road, p_road1, p_road1_2, p_road1_2b, p_road1_2bd, p_road1_2d, p_road1b, p_road1bd,
      p_road1d, p_road2, p_road2b, p_road2bd, p_road2d, p_road3, p_road3b, p_road3bd, p_road3d,
      p_road4, p_road4b, p_road4bd, p_road4d, p_roadb, p_roadbd, p_roadd, r2, r2b, r2bd, r2d, ratio,
      ratiob, ratiobd, ratiod, re, reb, rebd, red, rhov, rhovb, rhovbd, rhovd, s, sb, sbd, sd, t10,
      t10b, t10bd, t10d, t11, t11b, t11bd, t11d, t12, t12b, t12bd, t12d, t13, t13b, t13bd, t13d,
      t14, t14b, t14bd, t14d, t15, t15b, t15bd, t15d, t16, t16b, t16bd, t16d, t17, t17b, t17bd,
      t17d, t2, t2b, t2bd, t2d, t3, t3b, t3bd, t3d, t4, t4b, t4bd, t4d, t5, t5b, t5bd, t5d, t6, t6b,
      t6bd, t6d, t7, t7b, t7bd, t7d, t8, t8b, t8bd, t8d, t9, t9b, t9bd, t9d, tb10, tb10d, tb11,
      tb11d, tb12, tb12d, tb13, tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d, tb17, tb17d, tb18,
      tb18d, tb19, tb19d, tb2, tb20, tb20d, tb21, tb21d, tb22, tb22d, tb23, tb23d, tb24, tb24d,
      tb25, tb25d, tb26, tb26d, tb27, tb27d, tb28, tb28d, tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31,
      tb31d, tb32, tb32d, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d,
      u0, u0b, u0bd, u0d, u1, u1b, u1bd, u1d, u2, u2b, u2bd, u2d, ua0, ua0b, ua0bd, ua0d, ua1, ua1b,
      ua1bd, ua1d, ua2, ua2b, ua2bd, ua2d, un0, un0b, un0bd, un0d, un1, un1b, un1bd, un1d, un2,
      un2b, un2bd, un2d, v0, v0b, v0bd, v0d, v1, v1b, v1bd, v1d, v2, v2b, v2bd, v2d, w0, w0b, w0bd,
      w0d, w1, w1b, w1bd, w1d, w2, w2_2, w2_2b, w2_2bd, w2_2d, w2b, w2bd, w2d, wr0, wr0b, wr0bd,
      wr0d, wr1, wr1b, wr1bd, wr1d, wr2, wr2b, wr2bd, wr2d, x, x2, x2b, x2bd, x2d, xb, xbd, xd, z0,
      z0b, z0bd, z0d, z2, z2b, z2bd, z2d;

  for (i = t->nwheel - 1; i >= 0; --i) {
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
    n2d = 1.0 / (2.0 * n2) * t2d;
    u0 = ua0 / n2;
    u0d = (ua0d - u0 * n2d) * (1.0 / n2);
    u1 = ua1 / n2;
    u1d = (ua1d - u1 * n2d) * (1.0 / n2);
    u2 = ua2 / n2;
    u2d = (ua2d - u2 * n2d) * (1.0 / n2);
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
    } else {
      p_road1 = p[t->roadadr[road] + 1];
      p_road1d = pd[t->roadadr[road] + 1];
      t3 = 6.28318530717958647693 * x2 / p_road1;
      t3d = (6.28318530717958647693 * x2d - t3 * p_road1d) * (1.0 / p_road1);
      t4 = sin(t3);
      t4d = cos(t3) * t3d;
      p_road2 = p[t->roadadr[road]];
      p_road2d = pd[t->roadadr[road]];
      h00 = p_road2 * t4;
      h00d = p_road2d * t4 + p_road2 * t4d;
    }
    t5 = u0 * u0 + u1 * u1;
    t5d = u0d * u0 + u0 * u0d + (u1d * u1 + u1 * u1d);
    t6 = u2 * u0 / t5;
    t6d = (u2d * u0 + u2 * u0d - t6 * t5d) * (1.0 / t5);
    x = g0 + t6 * (g2 - h00);
    xd = g0d + (t6d * (g2 - h00) + t6 * (g2d - h00d));
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
      t7d = (6.28318530717958647693 * xd - t7 * p_road1_2d) * (1.0 / p_road1_2);
      t8 = sin(t7);
      t8d = cos(t7) * t7d;
      p_road4 = p[t->roadadr[road]];
      p_road4d = pd[t->roadadr[road]];
      h10 = p_road4 * t8;
      h10d = p_road4d * t8 + p_road4 * t8d;
      t9 = p_road4 * 6.28318530717958647693 / p_road1_2;
      t9d = (p_road4d * 6.28318530717958647693 - t9 * p_road1_2d) * (1.0 / p_road1_2);
      t10 = 6.28318530717958647693 * x / p_road1_2;
      t10d = (6.28318530717958647693 * xd - t10 * p_road1_2d) * (1.0 / p_road1_2);
      t11 = cos(t10);
      t11d = -(sin(t10) * t10d);
      h11 = t9 * t11;
      h11d = t9d * t11 + t9 * t11d;
    }
    t12 = 1.0 + h11 * h11;
    t12d = h11d * h11 + h11 * h11d;
    s = sqrt(t12);
    sd = 1.0 / (2.0 * s) * t12d;
    n30 = -h11 / s;
    n30d = (-h11d - n30 * sd) * (1.0 / s);
    n31 = 0.0;
    n32 = 1.0 / s;
    n32d = -(n32 * sd * (1.0 / s));
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
    w2d = 1.0 / (2.0 * w2) * t13d;
    r2 = ((g0 - x) * n30 + (g2 - h10) * n32) / w2;
    r2d = ((g0d - xd) * n30 + (g0 - x) * n30d + ((g2d - h10d) * n32 + (g2 - h10) * n32d) - r2 * w2d)
        * (1.0 / w2);
    along0 = un0 / w2;
    along0d = (un0d - along0 * w2d) * (1.0 / w2);
    along1 = un1 / w2;
    along1d = (un1d - along1 * w2d) * (1.0 / w2);
    along2 = un2 / w2;
    along2d = (un2d - along2 * w2d) * (1.0 / w2);
    arm0 = r2 * (c2 * u0 - n30) / w2;
    arm0d = (r2d * (c2 * u0 - n30) + r2 * (c2d * u0 + c2 * u0d - n30d) - arm0 * w2d) * (1.0 / w2);
    T0 = along0;
    T0d = along0d;
    N0 = n30;
    N0d = n30d;
    arm1 = r2 * (c2 * u1 - n31) / w2;
    arm1d = (r2d * (c2 * u1 - n31) + r2 * (c2d * u1 + c2 * u1d) - arm1 * w2d) * (1.0 / w2);
    T1 = along1;
    T1d = along1d;
    N1 = n31;
    arm2 = r2 * (c2 * u2 - n32) / w2;
    arm2d = (r2d * (c2 * u2 - n32) + r2 * (c2d * u2 + c2 * u2d - n32d) - arm2 * w2d) * (1.0 / w2);
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
    rhovd = (-(v0d * N0 + v0 * N0d + v1d * N1 + (v2d * N2 + v2 * N2d)) - rhov * z2d) * (1.0 / z2);
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
    ratiod = (fzd - ratio * fz0d) * (1.0 / fz0);
    t14 = fz0 / p2;
    t14d = (fz0d - t14 * p2d) * (1.0 / p2);
    t15 = p[adr + MAGGI_TYRE_BREFF] * ratio;
    t15d = pd[adr + MAGGI_TYRE_BREFF] * ratio + p[adr + MAGGI_TYRE_BREFF] * ratiod;
    t16 = atan(t15);
    t16d = 1.0 / (1.0 + t15 * t15) * t15d;
    re = p3 - t14 * (p[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_FREFF] * ratio);
    red = p3d - (t14d * (p[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_FREFF] * ratio) + t14
        * (pd[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_DREFF] * t16d + (pd[adr +
        MAGGI_TYRE_FREFF] * ratio + p[adr + MAGGI_TYRE_FREFF] * ratiod)));
    t17 = re * (b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2);
    t17d = red * (b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2) + re * (bd[body][3] * u0 +
        b[body][3] * u0d + (bd[body][4] * u1 + b[body][4] * u1d) + (bd[body][5] * u2 + b[body][5] *
        u2d));
    tb31 = spinb[i];
    tb31d = spinbd[i];
    spinb[i] = 0.0;
    spinbd[i] = 0.0;
    tb32 = tb31 / t17;
    tb32d = (tb31d - tb32 * t17d) * (1.0 / t17);
    v0b = tb32 * T0;
    v0bd = tb32d * T0 + tb32 * T0d;
    T0b = tb32 * v0;
    T0bd = tb32d * v0 + tb32 * v0d;
    v1b = tb32 * T1;
    v1bd = tb32d * T1 + tb32 * T1d;
    T1b = tb32 * v1;
    T1bd = tb32d * v1 + tb32 * v1d;
    v2b = tb32 * T2;
    v2bd = tb32d * T2 + tb32 * T2d;
    T2b = tb32 * v2;
    T2bd = tb32d * v2 + tb32 * v2d;
    t17b = -(tb32 * spin[i]);
    t17bd = -(tb32d * spin[i] + tb32 * spind[i]);
    reb = t17b * (b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2);
    rebd = t17bd * (b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2) + t17b * (bd[body][3] * u0
        + b[body][3] * u0d + (bd[body][4] * u1 + b[body][4] * u1d) + (bd[body][5] * u2 + b[body][5]
        * u2d));
    tb30 = t17b * re;
    tb30d = t17bd * re + t17b * red;
    bb[body][3] += tb30 * u0;
    bbd[body][3] += tb30d * u0 + tb30 * u0d;
    u0b = tb30 * b[body][3];
    u0bd = tb30d * b[body][3] + tb30 * bd[body][3];
    bb[body][4] += tb30 * u1;
    bbd[body][4] += tb30d * u1 + tb30 * u1d;
    u1b = tb30 * b[body][4];
    u1bd = tb30d * b[body][4] + tb30 * bd[body][4];
    bb[body][5] += tb30 * u2;
    bbd[body][5] += tb30d * u2 + tb30 * u2d;
    u2b = tb30 * b[body][5];
    u2bd = tb30d * b[body][5] + tb30 * bd[body][5];
    p3b = reb;
    p3bd = rebd;
    t14b = -(reb * (p[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_FREFF] * ratio));
    t14bd = -(rebd * (p[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_FREFF] * ratio) + reb *
        (pd[adr + MAGGI_TYRE_DREFF] * t16 + p[adr + MAGGI_TYRE_DREFF] * t16d + (pd[adr +
        MAGGI_TYRE_FREFF] * ratio + p[adr + MAGGI_TYRE_FREFF] * ratiod)));
    tb29 = reb * t14;
    tb29d = rebd * t14 + reb * t14d;
    pb[adr + MAGGI_TYRE_DREFF] -= tb29 * t16;
    pbd[adr + MAGGI_TYRE_DREFF] -= tb29d * t16 + tb29 * t16d;
    t16b = -(tb29 * p[adr + MAGGI_TYRE_DREFF]);
    t16bd = -(tb29d * p[adr + MAGGI_TYRE_DREFF] + tb29 * pd[adr + MAGGI_TYRE_DREFF]);
    pb[adr + MAGGI_TYRE_FREFF] -= tb29 * ratio;
    pbd[adr + MAGGI_TYRE_FREFF] -= tb29d * ratio + tb29 * ratiod;
    ratiob = -(tb29 * p[adr + MAGGI_TYRE_FREFF]);
    ratiobd = -(tb29d * p[adr + MAGGI_TYRE_FREFF] + tb29 * pd[adr + MAGGI_TYRE_FREFF]);
    t15b = t16b * (1.0 / (1.0 + t15 * t15));
    t15bd = t16bd * (1.0 / (1.0 + t15 * t15)) - t16b * (1.0 / (1.0 + t15 * t15) * (t15d * t15 + t15
        * t15d) / (1.0 + t15 * t15));
    pb[adr + MAGGI_TYRE_BREFF] += t15b * ratio;
    pbd[adr + MAGGI_TYRE_BREFF] += t15bd * ratio + t15b * ratiod;
    ratiob += t15b * p[adr + MAGGI_TYRE_BREFF];
    ratiobd += t15bd * p[adr + MAGGI_TYRE_BREFF] + t15b * pd[adr + MAGGI_TYRE_BREFF];
    tb28 = t14b / p2;
    tb28d = (t14bd - tb28 * p2d) * (1.0 / p2);
    fz0b = tb28;
    fz0bd = tb28d;
    p2b = -(tb28 * t14);
    p2bd = -(tb28d * t14 + tb28 * t14d);
    tb27 = ratiob / fz0;
    tb27d = (ratiobd - tb27 * fz0d) * (1.0 / fz0);
    fzb = tb27;
    fzbd = tb27d;
    fz0b -= tb27 * ratio;
    fz0bd -= tb27d * ratio + tb27 * ratiod;
    pb[adr + MAGGI_TYRE_LFZO] += fz0b * p[adr];
    pbd[adr + MAGGI_TYRE_LFZO] += fz0bd * p[adr] + fz0b * pd[adr];
    pb[adr] += fz0b * p[adr + MAGGI_TYRE_LFZO];
    pbd[adr] += fz0bd * p[adr + MAGGI_TYRE_LFZO] + fz0b * pd[adr + MAGGI_TYRE_LFZO];
    p2b += fzb * (p3 - z0);
    p2bd += fzbd * (p3 - z0) + fzb * (p3d - z0d);
    tb26 = fzb * p2;
    tb26d = fzbd * p2 + fzb * p2d;
    p3b += tb26;
    p3bd += tb26d;
    z0b = -tb26;
    z0bd = -tb26d;
    pb[adr + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
    pbd[adr + MAGGI_TYRE_VERTICAL_DAMPING] += fzbd * rhov + fzb * rhovd;
    rhovb = fzb * p[adr + MAGGI_TYRE_VERTICAL_DAMPING];
    rhovbd = fzbd * p[adr + MAGGI_TYRE_VERTICAL_DAMPING] + fzb * pd[adr +
        MAGGI_TYRE_VERTICAL_DAMPING];
    pb[adr + MAGGI_TYRE_UNLOADED_RADIUS] += p3b;
    pbd[adr + MAGGI_TYRE_UNLOADED_RADIUS] += p3bd;
    pb[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] += p2b;
    pbd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] += p2bd;
    tb25 = rhovb / z2;
    tb25d = (rhovbd - tb25 * z2d) * (1.0 / z2);
    v0b -= tb25 * N0;
    v0bd -= tb25d * N0 + tb25 * N0d;
    N0b = -(tb25 * v0);
    N0bd = -(tb25d * v0 + tb25 * v0d);
    v1b -= tb25 * N1;
    v1bd -= tb25d * N1;
    v2b -= tb25 * N2;
    v2bd -= tb25d * N2 + tb25 * N2d;
    N2b = -(tb25 * v2);
    N2bd = -(tb25d * v2 + tb25 * v2d);
    z2b = -(tb25 * rhov);
    z2bd = -(tb25d * rhov + tb25 * rhovd);
    Zb[carrier][2] += v2b;
    Zbd[carrier][2] += v2bd;
    w2_2b = v2b;
    w2_2bd = v2bd;
    Zb[carrier][1] += v1b;
    Zbd[carrier][1] += v1bd;
    w1b = v1b;
    w1bd = v1bd;
    Zb[carrier][0] += v0b;
    Zbd[carrier][0] += v0bd;
    w0b = v0b;
    w0bd = v0bd;
    wr0b = w2_2b * c1;
    wr0bd = w2_2bd * c1 + w2_2b * c1d;
    c1b = w2_2b * wr0;
    c1bd = w2_2bd * wr0 + w2_2b * wr0d;
    wr1b = -(w2_2b * c0);
    wr1bd = -(w2_2bd * c0 + w2_2b * c0d);
    c0b = -(w2_2b * wr1);
    c0bd = -(w2_2bd * wr1 + w2_2b * wr1d);
    wr2b = w1b * c0;
    wr2bd = w1bd * c0 + w1b * c0d;
    c0b += w1b * wr2;
    c0bd += w1bd * wr2 + w1b * wr2d;
    wr0b -= w1b * c2_2;
    wr0bd -= w1bd * c2_2 + w1b * c2_2d;
    c2_2b = -(w1b * wr0);
    c2_2bd = -(w1bd * wr0 + w1b * wr0d);
    wr1b += w0b * c2_2;
    wr1bd += w0bd * c2_2 + w0b * c2_2d;
    c2_2b += w0b * wr1;
    c2_2bd += w0bd * wr1 + w0b * wr1d;
    wr2b -= w0b * c1;
    wr2bd -= w0bd * c1 + w0b * c1d;
    c1b -= w0b * wr2;
    c1bd -= w0bd * wr2 + w0b * wr2d;
    Zb[carrier][5] += wr2b;
    Zbd[carrier][5] += wr2bd;
    Zb[carrier][4] += wr1b;
    Zbd[carrier][4] += wr1bd;
    Zb[carrier][3] += wr0b;
    Zbd[carrier][3] += wr0bd;
    rb[t->wheelpoint[i]][2] += c2_2b;
    rbd[t->wheelpoint[i]][2] += c2_2bd;
    arm2b = c2_2b;
    arm2bd = c2_2bd;
    rb[t->wheelpoint[i]][1] += c1b;
    rbd[t->wheelpoint[i]][1] += c1bd;
    arm1b = c1b;
    arm1bd = c1bd;
    rb[t->wheelpoint[i]][0] += c0b;
    rbd[t->wheelpoint[i]][0] += c0bd;
    arm0b = c0b;
    arm0bd = c0bd;
    w2b = z2b;
    w2bd = z2bd;
    r2b = z0b;
    r2bd = z0bd;
    n32b = N2b;
    n32bd = N2bd;
    along2b = T2b;
    along2bd = T2bd;
    tb23 = arm2b / w2;
    tb23d = (arm2bd - tb23 * w2d) * (1.0 / w2);
    r2b += tb23 * (c2 * u2 - n32);
    r2bd += tb23d * (c2 * u2 - n32) + tb23 * (c2d * u2 + c2 * u2d - n32d);
    tb24 = tb23 * r2;
    tb24d = tb23d * r2 + tb23 * r2d;
    c2b = tb24 * u2;
    c2bd = tb24d * u2 + tb24 * u2d;
    u2b += tb24 * c2;
    u2bd += tb24d * c2 + tb24 * c2d;
    n32b -= tb24;
    n32bd -= tb24d;
    w2b -= tb23 * arm2;
    w2bd -= tb23d * arm2 + tb23 * arm2d;
    along1b = T1b;
    along1bd = T1bd;
    tb21 = arm1b / w2;
    tb21d = (arm1bd - tb21 * w2d) * (1.0 / w2);
    r2b += tb21 * (c2 * u1 - n31);
    r2bd += tb21d * (c2 * u1 - n31) + tb21 * (c2d * u1 + c2 * u1d);
    tb22 = tb21 * r2;
    tb22d = tb21d * r2 + tb21 * r2d;
    c2b += tb22 * u1;
    c2bd += tb22d * u1 + tb22 * u1d;
    u1b += tb22 * c2;
    u1bd += tb22d * c2 + tb22 * c2d;
    w2b -= tb21 * arm1;
    w2bd -= tb21d * arm1 + tb21 * arm1d;
    n30b = N0b;
    n30bd = N0bd;
    along0b = T0b;
    along0bd = T0bd;
    tb19 = arm0b / w2;
    tb19d = (arm0bd - tb19 * w2d) * (1.0 / w2);
    r2b += tb19 * (c2 * u0 - n30);
    r2bd += tb19d * (c2 * u0 - n30) + tb19 * (c2d * u0 + c2 * u0d - n30d);
    tb20 = tb19 * r2;
    tb20d = tb19d * r2 + tb19 * r2d;
    c2b += tb20 * u0;
    c2bd += tb20d * u0 + tb20 * u0d;
    u0b += tb20 * c2;
    u0bd += tb20d * c2 + tb20 * c2d;
    n30b -= tb20;
    n30bd -= tb20d;
    w2b -= tb19 * arm0;
    w2bd -= tb19d * arm0 + tb19 * arm0d;
    tb18 = along2b / w2;
    tb18d = (along2bd - tb18 * w2d) * (1.0 / w2);
    un2b = tb18;
    un2bd = tb18d;
    w2b -= tb18 * along2;
    w2bd -= tb18d * along2 + tb18 * along2d;
    tb17 = along1b / w2;
    tb17d = (along1bd - tb17 * w2d) * (1.0 / w2);
    un1b = tb17;
    un1bd = tb17d;
    w2b -= tb17 * along1;
    w2bd -= tb17d * along1 + tb17 * along1d;
    tb16 = along0b / w2;
    tb16d = (along0bd - tb16 * w2d) * (1.0 / w2);
    un0b = tb16;
    un0bd = tb16d;
    w2b -= tb16 * along0;
    w2bd -= tb16d * along0 + tb16 * along0d;
    tb13 = r2b / w2;
    tb13d = (r2bd - tb13 * w2d) * (1.0 / w2);
    tb14 = tb13 * n30;
    tb14d = tb13d * n30 + tb13 * n30d;
    g0b = tb14;
    g0bd = tb14d;
    xb = -tb14;
    xbd = -tb14d;
    n30b += tb13 * (g0 - x);
    n30bd += tb13d * (g0 - x) + tb13 * (g0d - xd);
    tb15 = tb13 * n32;
    tb15d = tb13d * n32 + tb13 * n32d;
    g2b = tb15;
    g2bd = tb15d;
    h10b = -tb15;
    h10bd = -tb15d;
    n32b += tb13 * (g2 - h10);
    n32bd += tb13d * (g2 - h10) + tb13 * (g2d - h10d);
    w2b -= tb13 * r2;
    w2bd -= tb13d * r2 + tb13 * r2d;
    t13b = w2b * (1.0 / (2.0 * w2));
    t13bd = w2bd * (1.0 / (2.0 * w2)) - w2b * (1.0 / (2.0 * w2) * (2.0 * w2d) / (2.0 * w2));
    un0b += t13b * un0;
    un0bd += t13bd * un0 + t13b * un0d;
    un0b += t13b * un0;
    un0bd += t13bd * un0 + t13b * un0d;
    un1b += t13b * un1;
    un1bd += t13bd * un1 + t13b * un1d;
    un1b += t13b * un1;
    un1bd += t13bd * un1 + t13b * un1d;
    un2b += t13b * un2;
    un2bd += t13bd * un2 + t13b * un2d;
    un2b += t13b * un2;
    un2bd += t13bd * un2 + t13b * un2d;
    u0b += un2b * n31;
    u0bd += un2bd * n31;
    u1b -= un2b * n30;
    u1bd -= un2bd * n30 + un2b * n30d;
    n30b -= un2b * u1;
    n30bd -= un2bd * u1 + un2b * u1d;
    u2b += un1b * n30;
    u2bd += un1bd * n30 + un1b * n30d;
    n30b += un1b * u2;
    n30bd += un1bd * u2 + un1b * u2d;
    u0b -= un1b * n32;
    u0bd -= un1bd * n32 + un1b * n32d;
    n32b -= un1b * u0;
    n32bd -= un1bd * u0 + un1b * u0d;
    u1b += un0b * n32;
    u1bd += un0bd * n32 + un0b * n32d;
    n32b += un0b * u1;
    n32bd += un0bd * u1 + un0b * u1d;
    u2b -= un0b * n31;
    u2bd -= un0bd * n31;
    u0b += c2b * n30;
    u0bd += c2bd * n30 + c2b * n30d;
    n30b += c2b * u0;
    n30bd += c2bd * u0 + c2b * u0d;
    u1b += c2b * n31;
    u1bd += c2bd * n31;
    u2b += c2b * n32;
    u2bd += c2bd * n32 + c2b * n32d;
    n32b += c2b * u2;
    n32bd += c2bd * u2 + c2b * u2d;
    tb12 = n32b / s;
    tb12d = (n32bd - tb12 * sd) * (1.0 / s);
    sb = -(tb12 * n32);
    sbd = -(tb12d * n32 + tb12 * n32d);
    tb11 = n30b / s;
    tb11d = (n30bd - tb11 * sd) * (1.0 / s);
    h11b = -tb11;
    h11bd = -tb11d;
    sb -= tb11 * n30;
    sbd -= tb11d * n30 + tb11 * n30d;
    t12b = sb * (1.0 / (2.0 * s));
    t12bd = sbd * (1.0 / (2.0 * s)) - sb * (1.0 / (2.0 * s) * (2.0 * sd) / (2.0 * s));
    h11b += t12b * h11;
    h11bd += t12bd * h11 + t12b * h11d;
    h11b += t12b * h11;
    h11bd += t12bd * h11 + t12b * h11d;
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road3 = p[t->roadadr[road]];
      p_road3d = pd[t->roadadr[road]];
      p_road3b = h11b;
      p_road3bd = h11bd;
      h11b = 0.0;
      h11bd = 0.0;
      p_road3b += h10b * x;
      p_road3bd += h10bd * x + h10b * xd;
      xb += h10b * p_road3;
      xbd += h10bd * p_road3 + h10b * p_road3d;
      h10b = 0.0;
      h10bd = 0.0;
      pb[t->roadadr[road]] += p_road3b;
      pbd[t->roadadr[road]] += p_road3bd;
    } else {
      p_road1_2 = p[t->roadadr[road] + 1];
      p_road1_2d = pd[t->roadadr[road] + 1];
      t7 = 6.28318530717958647693 * x / p_road1_2;
      t7d = (6.28318530717958647693 * xd - t7 * p_road1_2d) * (1.0 / p_road1_2);
      t8 = sin(t7);
      t8d = cos(t7) * t7d;
      p_road4 = p[t->roadadr[road]];
      p_road4d = pd[t->roadadr[road]];
      t9 = p_road4 * 6.28318530717958647693 / p_road1_2;
      t9d = (p_road4d * 6.28318530717958647693 - t9 * p_road1_2d) * (1.0 / p_road1_2);
      t10 = 6.28318530717958647693 * x / p_road1_2;
      t10d = (6.28318530717958647693 * xd - t10 * p_road1_2d) * (1.0 / p_road1_2);
      t11 = cos(t10);
      t11d = -(sin(t10) * t10d);
      t9b = h11b * t11;
      t9bd = h11bd * t11 + h11b * t11d;
      t11b = h11b * t9;
      t11bd = h11bd * t9 + h11b * t9d;
      h11b = 0.0;
      h11bd = 0.0;
      t10b = -(t11b * sin(t10));
      t10bd = -(t11bd * sin(t10) + t11b * (cos(t10) * t10d));
      tb10 = t10b / p_road1_2;
      tb10d = (t10bd - tb10 * p_road1_2d) * (1.0 / p_road1_2);
      xb += tb10 * 6.28318530717958647693;
      xbd += tb10d * 6.28318530717958647693;
      p_road1_2b = -(tb10 * t10);
      p_road1_2bd = -(tb10d * t10 + tb10 * t10d);
      tb9 = t9b / p_road1_2;
      tb9d = (t9bd - tb9 * p_road1_2d) * (1.0 / p_road1_2);
      p_road4b = tb9 * 6.28318530717958647693;
      p_road4bd = tb9d * 6.28318530717958647693;
      p_road1_2b -= tb9 * t9;
      p_road1_2bd -= tb9d * t9 + tb9 * t9d;
      p_road4b += h10b * t8;
      p_road4bd += h10bd * t8 + h10b * t8d;
      t8b = h10b * p_road4;
      t8bd = h10bd * p_road4 + h10b * p_road4d;
      h10b = 0.0;
      h10bd = 0.0;
      pb[t->roadadr[road]] += p_road4b;
      pbd[t->roadadr[road]] += p_road4bd;
      t7b = t8b * cos(t7);
      t7bd = t8bd * cos(t7) - t8b * (sin(t7) * t7d);
      tb8 = t7b / p_road1_2;
      tb8d = (t7bd - tb8 * p_road1_2d) * (1.0 / p_road1_2);
      xb += tb8 * 6.28318530717958647693;
      xbd += tb8d * 6.28318530717958647693;
      p_road1_2b -= tb8 * t7;
      p_road1_2bd -= tb8d * t7 + tb8 * t7d;
      pb[t->roadadr[road] + 1] += p_road1_2b;
      pbd[t->roadadr[road] + 1] += p_road1_2bd;
    }
    g0b += xb;
    g0bd += xbd;
    t6b = xb * (g2 - h00);
    t6bd = xbd * (g2 - h00) + xb * (g2d - h00d);
    tb7 = xb * t6;
    tb7d = xbd * t6 + xb * t6d;
    g2b += tb7;
    g2bd += tb7d;
    h00b = -tb7;
    h00bd = -tb7d;
    tb6 = t6b / t5;
    tb6d = (t6bd - tb6 * t5d) * (1.0 / t5);
    u2b += tb6 * u0;
    u2bd += tb6d * u0 + tb6 * u0d;
    u0b += tb6 * u2;
    u0bd += tb6d * u2 + tb6 * u2d;
    t5b = -(tb6 * t6);
    t5bd = -(tb6d * t6 + tb6 * t6d);
    u0b += t5b * u0;
    u0bd += t5bd * u0 + t5b * u0d;
    u0b += t5b * u0;
    u0bd += t5bd * u0 + t5b * u0d;
    u1b += t5b * u1;
    u1bd += t5bd * u1 + t5b * u1d;
    u1b += t5b * u1;
    u1bd += t5bd * u1 + t5b * u1d;
    x2b = 0.0;
    x2bd = 0.0;
    /* height of the road above its point at x ahead of it, and its slope */
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
    } else {
      p_road1 = p[t->roadadr[road] + 1];
      p_road1d = pd[t->roadadr[road] + 1];
      t3 = 6.28318530717958647693 * x2 / p_road1;
      t3d = (6.28318530717958647693 * x2d - t3 * p_road1d) * (1.0 / p_road1);
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
      tb5 = t3b / p_road1;
      tb5d = (t3bd - tb5 * p_road1d) * (1.0 / p_road1);
      x2b += tb5 * 6.28318530717958647693;
      x2bd += tb5d * 6.28318530717958647693;
      p_road1b = -(tb5 * t3);
      p_road1bd = -(tb5d * t3 + tb5 * t3d);
      pb[t->roadadr[road] + 1] += p_road1b;
      pbd[t->roadadr[road] + 1] += p_road1bd;
    }
    g0b += x2b;
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
    g0bd += x2bd;
    rb[t->wheelpoint[i]][2] += g2b;
    rbd[t->wheelpoint[i]][2] += g2bd;
    rb[t->roadpoint[road]][2] -= g2b;
    rbd[t->roadpoint[road]][2] -= g2bd;
    rb[t->wheelpoint[i]][0] += g0b;
    rbd[t->wheelpoint[i]][0] += g0bd;
    rb[t->roadpoint[road]][0] -= g0b;
    rbd[t->roadpoint[road]][0] -= g0bd;
    tb4 = u2b / n2;
    tb4d = (u2bd - tb4 * n2d) * (1.0 / n2);
    ua2b = tb4;
    ua2bd = tb4d;
    n2b = -(tb4 * u2);
    n2bd = -(tb4d * u2 + tb4 * u2d);
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
    Ab[body][6] += ua2b * a00;
    Abd[body][6] += ua2bd * a00 + ua2b * a00d;
    a00b = ua2b * A[body][6];
    a00bd = ua2bd * A[body][6] + ua2b * Ad[body][6];
    Ab[body][7] += ua2b * a01;
    Abd[body][7] += ua2bd * a01 + ua2b * a01d;
    a01b = ua2b * A[body][7];
    a01bd = ua2bd * A[body][7] + ua2b * Ad[body][7];
    Ab[body][8] += ua2b * a02;
    Abd[body][8] += ua2bd * a02 + ua2b * a02d;
    a02b = ua2b * A[body][8];
    a02bd = ua2bd * A[body][8] + ua2b * Ad[body][8];
    Ab[body][3] += ua1b * a00;
    Abd[body][3] += ua1bd * a00 + ua1b * a00d;
    a00b += ua1b * A[body][3];
    a00bd += ua1bd * A[body][3] + ua1b * Ad[body][3];
    Ab[body][4] += ua1b * a01;
    Abd[body][4] += ua1bd * a01 + ua1b * a01d;
    a01b += ua1b * A[body][4];
    a01bd += ua1bd * A[body][4] + ua1b * Ad[body][4];
    Ab[body][5] += ua1b * a02;
    Abd[body][5] += ua1bd * a02 + ua1b * a02d;
    a02b += ua1b * A[body][5];
    a02bd += ua1bd * A[body][5] + ua1b * Ad[body][5];
    Ab[body][0] += ua0b * a00;
    Abd[body][0] += ua0bd * a00 + ua0b * a00d;
    a00b += ua0b * A[body][0];
    a00bd += ua0bd * A[body][0] + ua0b * Ad[body][0];
    Ab[body][1] += ua0b * a01;
    Abd[body][1] += ua0bd * a01 + ua0b * a01d;
    a01b += ua0b * A[body][1];
    a01bd += ua0bd * A[body][1] + ua0b * Ad[body][1];
    Ab[body][2] += ua0b * a02;
    Abd[body][2] += ua0bd * a02 + ua0b * a02d;
    a02b += ua0b * A[body][2];
    a02bd += ua0bd * A[body][2] + ua0b * Ad[body][2];
    pb[t->wheelaxis[i] + 2] += a02b;
    pbd[t->wheelaxis[i] + 2] += a02bd;
    pb[t->wheelaxis[i] + 1] += a01b;
    pbd[t->wheelaxis[i] + 1] += a01bd;
    pb[t->wheelaxis[i]] += a00b;
    pbd[t->wheelaxis[i]] += a00bd;
  }
}
