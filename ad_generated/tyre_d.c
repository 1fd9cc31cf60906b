/* Tangent of core/kernel/tyre.c.
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
void maggi_wheel_forces_d(const maggi_topo *t, const double p[restrict t->np],
                          const double pd[restrict t->np],
                          const double spline0[restrict t->nspline][3],
                          const double spline0d[restrict t->nspline][3],
                          const double A[restrict t->nbody + 1][9],
                          const double Ad[restrict t->nbody + 1][9],
                          const double Z[restrict t->nbody + 1][6],
                          const double Zd[restrict t->nbody + 1][6],
                          const double r[restrict t->npoint][3],
                          const double rd[restrict t->npoint][3],
                          const double rv[restrict t->npoint][3],
                          const double rvd[restrict t->npoint][3],
                          double slip[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                          double slipd[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                          double f[restrict t->nwheel][6], double fd[restrict t->nwheel][6],
                          double F[restrict t->nwheel][6], double Fd[restrict t->nwheel][6])
{
  int i, k3, k5, k6, k8, k9, k9_2, road;
  double L0, L0d, L1, L1d, L2, L2d, N0, N0d, N1, N2, N2d, T0, T0d, T1, T1d, T2, T2d, Z_i3, Z_i3d,
      Z_i4, Z_i4d, Z_i5, Z_i5d, a, a2, a2d, a3, a3d, a4, a4d, a5, a5d, ad, along0, along0d, along1,
      along1d, along2, along2d, ar, ard, areq, areqd, arm0, arm0d, arm1, arm1d, arm2, arm2d, at,
      atd, ateq, ateqd, axis0, axis0d, axis1, axis1d, axis2, axis2d, ay, ayd, b0, b0d, b2, b2d, b30,
      b30d, b31, b31d, b4, b4d, base, base2, base2d, based, br, brd, bt, btd, c, c10, c11, c12, c13,
      c14, c15, c16, c17, c18, c19, c2, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c2d, c3,
      c30, c31, c32, c33, c34, c35, c36, c37, c38, c39, c3d, c4, c40, c41, c42, c43, c44, c45, c46,
      c47, c48, c49, c4d, c5, c50, c51, c5d, c6, c7, c8, c9, ca, cad, cd, dfz, dfzd, dr, drd, dt,
      dtd, dv, dvd, e, e10, e10d, e11, e11d, e2, e2d, e3, e3d, e4, e4d, e5, e5d, e6, e6d, e7, e7d,
      e8, e8d, e9, e9d, ed, et, etd, ex, exd, ey, eyd, f2, f2d, f3, f3d, f_i0, f_i0d, f_i1, f_i1d,
      f_i2, f_i2d, f_i3, f_i3d, f_i4, f_i4d, f_i5, f_i5d, force0d, force1d, force2, force2_2d,
      force2d, force30, force30d, force31, force31d, force32, force32d, force3_2d, force4d, force5d,
      fx, fxd, fy, fyd, fz, fz0, fz0_2, fz0_2d, fz0_2inv, fz0_3, fz0_3d, fz0_4, fz0_4d, fz0_4inv,
      fz0d, fz0inv, fz2, fz2d, fzd, g0, g0d, g20, g20d, g21, g21d, g22, g22d, g23, g23d, g24, g24d,
      g25, g25d, g26, g26d, g27, g27d, g28, g28d, g2_2, g2_2d, gamma, gammad, gx, gxd, gy, gyd, gz,
      gzd, h, h00, h00d, h0_2, h0_2d, h0_3, h0_3d, h10, h10d, h11, h11d, h12, h12d, h1_2, h1_2d,
      h1_3, h1_3d, h2, h2_2, h2_2d, h2_2inv, h2_3, h2_3d, h2_3inv, h2d, h2inv, h3, h3_2, h3_2d,
      h3_2inv, h3d, h3inv, hd, hinv, inv, inv2, inv3, inv4, inv5, inv6, k4, k4d, k7, k7d, kappa,
      kappad, kx, kxd, moment0d, moment1d, moment2d, mux, muxd, muy, muyd, n2, n2d, n2inv, normal0,
      normal0d, normal1, normal2, normal2d, omega, omegad, one0, one0d, one1, one1d, one2, one2d,
      one3, one3d, one4, one4d, p10, p10d, p2, p2d, p3, p3d, p4, p4d, p5, p5d, p6, p6d, p7, p7d, p8,
      p8d, p8inv, p9, p9d, p_road, p_road2, p_road2d, p_road3, p_road3d, p_road4, p_road4d, p_road5,
      p_road5d, p_road6, p_road6d, p_roadd, p_roadk5, p_roadk51, p_roadk51d, p_roadk5d, p_roadk8,
      p_roadk81, p_roadk81d, p_roadk8d, p_roadroad, p_roadroad2, p_roadroad2d, p_roadroadd, peak,
      peakd, r0, r0d, r2, r2d, r30, r30d, r31, r31d, r32, r32d, radius, radius2, radius2d, radiusd,
      ratio, ratio2, ratio2d, ratiod, re, re2, re2d, red, rhov, rhovd, s, s20, s20d, s30, s30d, s31,
      s31d, s4, s4d, scale, scaled, sd, side, sinv, slope, slope2, slope2_2, slope2_2d, slope2d,
      slope3, slope3d, sloped, speed, speed2, speed2d, speedd, speedinv, spline0_roadk50,
      spline0_roadk50d, spline0_roadk510, spline0_roadk510d, spline0_roadk80, spline0_roadk80d,
      spline0_roadk810, spline0_roadk810d, t10, t100, t100d, t101, t101d, t102, t102d, t102inv,
      t103, t103d, t104, t104d, t105, t105d, t106, t106d, t107, t107d, t108, t108d, t108inv, t109,
      t109d, t10d, t11, t110, t110d, t111, t111d, t112, t112d, t113, t113d, t114, t114d, t115,
      t115d, t115inv, t116, t116d, t117, t117d, t118, t118d, t119, t119d, t11d, t12, t120, t120d,
      t121d, t12d, t13, t13d, t14, t14d, t14inv, t15, t15d, t16, t16d, t16inv, t17, t17d, t18, t18d,
      t19, t19d, t2, t20, t20d, t21, t21d, t22, t22d, t23, t23d, t24, t24d, t24inv, t25, t25d, t26,
      t26d, t26inv, t27, t27d, t27inv, t28, t28d, t29, t29d, t2d, t3, t30, t30d, t31, t31d, t32,
      t32d, t33, t33d, t34, t34d, t34inv, t35, t35d, t36, t36d, t36inv, t37, t37d, t38, t38d, t39,
      t39d, t3d, t4, t40, t40d, t41, t41d, t42, t42d, t43, t43d, t44, t44d, t45, t45d, t46, t46d,
      t46inv, t47, t47d, t47inv, t48, t48d, t48inv, t49, t49d, t4d, t5, t50, t50d, t51, t51d,
      t51inv, t52, t52d, t53, t53d, t54, t54d, t54inv, t55, t55d, t56, t56d, t57, t57d, t57inv, t58,
      t58d, t59, t59d, t5d, t6, t60, t60d, t61, t61d, t62, t62d, t63, t63d, t63inv, t64, t64d, t65,
      t65d, t66, t66d, t67, t67d, t68, t68d, t69, t69d, t6d, t7, t70, t70d, t71, t71d, t72, t72d,
      t73, t73d, t74, t74d, t75, t75d, t76, t76d, t77, t77d, t78, t78d, t79, t79d, t79inv, t7d,
      t7inv, t8, t80, t80d, t81, t81d, t81inv, t82, t82d, t83, t83d, t84, t84d, t85, t85d, t86,
      t86d, t87, t87d, t88, t88d, t89, t89d, t8d, t9, t90, t90d, t91, t91d, t92, t92d, t93, t93d,
      t94, t94d, t95, t95d, t96, t96d, t97, t97d, t97inv, t98, t98d, t99, t99d, t9d, t9inv, u0, u0d,
      u1, u1d, u2, u2_2, u2_2d, u2d, u3, u3d, ua0, ua0d, ua1, ua1d, ua2, ua2d, un0, un0d, un1, un1d,
      un2, un2d, v0, v0d, v1, v1d, v2, v2d, vr0, vr0d, vr1, vr1d, vr2, vr2d, vx, vxd, w, w2, w2d,
      w3, w3d, way, way2, way3, way3d, wd, winv, wr0, wr0d, wr1, wr1d, wr2, wr2d, x, x2, x2d, x3,
      x3d, x4, x4d, x50, x50d, x51, x51d, x52, x52d, x53, x53d, x54, x54d, x55, x55d, x6, x6d, x7,
      x7d, x8, x8d, x9, x9d, xd, y, y10, y10d, y11, y11d, y12, y12d, y13, y13d, y14, y14d, y15,
      y15d, y16, y16d, y17, y17d, y18, y18d, y19, y19d, y2, y20, y20d, y2d, y3, y3d, y40, y40d,
      y40inv, y41, y41d, y42, y42d, y43, y43d, y43inv, y44, y44d, y45, y45d, y5, y5d, y6, y6d, y7,
      y7d, y8, y8d, y9, y9d, yd, z0, z0d, z1, z1d, z2, z2_2, z2_2d, z2_2inv, z2_3, z2_3d, z2d,
      z2inv, z3, z3_2, z3_2d, z3_3, z3_3d, z3_3inv, z3d, z3inv, z40, z40d, z41d, z5, z5d, z6, z6d,
      z7, z7d;

  for (i = 0; i < t->nwheel; ++i) {
    /* the unit axis u of wheel i, and where it meets its road */
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
    c6 = 1.0 / (2.0 * n2);
    n2d = c6 * t2d;
    u0 = ua0 / n2;
    n2inv = 1.0 / n2;
    u0d = (ua0d - u0 * n2d) * n2inv;
    u1 = ua1 / n2;
    u1d = (ua1d - u1 * n2d) * n2inv;
    u2_2 = ua2 / n2;
    u2_2d = (ua2d - u2_2 * n2d) * n2inv;
    g0 = r[t->wheelpoint[i]][0] - r[t->roadpoint[road]][0];
    g0d = rd[t->wheelpoint[i]][0] - rd[t->roadpoint[road]][0];
    g2_2 = r[t->wheelpoint[i]][2] - r[t->roadpoint[road]][2];
    g2_2d = rd[t->wheelpoint[i]][2] - rd[t->roadpoint[road]][2];
    x2 = g0;
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n|, slope that the plane lacks */
    x2d = g0d;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      p_roadd = pd[t->roadadr[road]];
      h00 = p_road * x2;
      h00d = p_roadd * x2 + p_road * x2d;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k4 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      inv = 1.0 / p[t->roadadr[road] + 1];
      k4d = -(k4 * pd[t->roadadr[road] + 1] * inv);
      t3 = k4 * x2;
      t3d = k4d * x2 + k4 * x2d;
      t4 = sin(t3);
      c7 = cos(t3);
      t4d = c7 * t3d;
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
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      radiusd = pd[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      based = radiusd - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      t5d = radiusd * radius + radius * radiusd - (based * base + base * based);
      c2 = sqrt(t5);
      c8 = 1.0 / (2.0 * c2);
      c2d = c8 * t5d;
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
        c9 = 1.0 / (2.0 * z2);
        z2d = c9 * t6d;
        h0_2 = z2 - base;
        h0_2d = z2d - based;
        h1_2 = 2.0 * f2 * (c2 - f2) / z2;
        z2inv = 1.0 / z2;
        h1_2d = (2.0 * f2d * (c2 - f2) + 2.0 * f2 * (c2d - f2d) - h1_2 * z2d) * z2inv;
        a = 3.0 * h0_2 - h1_2;
        ad = 3.0 * h0_2d - h1_2d;
        t7 = z2 * z2 * z2;
        t7d = (z2d * z2 + z2 * z2d) * z2 + z2 * z2 * z2d;
        t8 = 2.0 * f2 * f2 * radius * radius / t7;
        t7inv = 1.0 / t7;
        t8d = (((2.0 * f2d * f2 + 2.0 * f2 * f2d) * radius + 2.0 * f2 * f2 * radiusd) * radius + 2.0
            * f2 * f2 * radius * radiusd - t8 * t7d) * t7inv;
        b2 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        b2d = 6.0 * h0_2d - 3.0 * h1_2d - t8d;
        t9 = 2.0 * f2;
        t9d = 2.0 * f2d;
        u2 = (c2 + f2 - y) / t9;
        t9inv = 1.0 / t9;
        u2d = (c2d + f2d - yd - u2 * t9d) * t9inv;
        w2 = 1.0 - u2;
        w2d = -u2d;
        b0 = u2 * u2 * u2 * (h0_2 + w2 * (a + w2 * b2));
        b0d = ((u2d * u2 + u2 * u2d) * u2 + u2 * u2 * u2d) * (h0_2 + w2 * (a + w2 * b2)) + u2 * u2 *
            u2 * (h0_2d + (w2d * (a + w2 * b2) + w2 * (ad + (w2d * b2 + w2 * b2d))));
      } else {
        t10 = radius * radius - y * y;
        t10d = radiusd * radius + radius * radiusd - (yd * y + y * yd);
        z2_3 = sqrt(t10);
        c10 = 1.0 / (2.0 * z2_3);
        z2_3d = c10 * t10d;
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
        hinv = 1.0 / h;
        t11d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroadd - t11 * hd) * hinv;
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
        h3inv = 1.0 / h3;
        t12d = (p3d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t12 * h3d) *
            h3inv;
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
        h3_2inv = 1.0 / h3_2;
        t13d = (pd[t->roadadr[road] + t->roadn[road] + k5 + 1] - p4d - t13 * h3_2d) * h3_2inv;
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
        t14inv = 1.0 / t14;
        t15d = (((spline0_roadk50d * a2 + spline0_roadk50 * a2d) * a2 + spline0_roadk50 * a2 * a2d)
            * a2 + spline0_roadk50 * a2 * a2 * a2d + (((spline0_roadk510d * c3 + spline0_roadk510 *
            c3d) * c3 + spline0_roadk510 * c3 * c3d) * c3 + spline0_roadk510 * c3 * c3 * c3d) - t15
            * t14d) * t14inv;
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
    t16inv = 1.0 / t16;
    t17d = (u2_2d * u0 + u2_2 * u0d - t17 * t16d) * t16inv;
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
      inv2 = 1.0 / p[t->roadadr[road] + 1];
      k7d = -(k7 * pd[t->roadadr[road] + 1] * inv2);
      t18 = k7 * x;
      t18d = k7d * x + k7 * xd;
      t19 = sin(t18);
      c11 = cos(t18);
      t19d = c11 * t18d;
      p_road5 = p[t->roadadr[road]];
      p_road5d = pd[t->roadadr[road]];
      h10 = p_road5 * t19;
      h10d = p_road5d * t19 + p_road5 * t19d;
      t20 = k7 * x;
      t20d = k7d * x + k7 * xd;
      t21 = cos(t20);
      c12 = -sin(t20);
      t21d = c12 * t20d;
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
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      radius2d = pd[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      base2d = radius2d - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      t22d = radius2d * radius2 + radius2 * radius2d - (base2d * base2 + base2 * base2d);
      c4 = sqrt(t22);
      c13 = 1.0 / (2.0 * c4);
      c4d = c13 * t22d;
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
        c14 = 1.0 / (2.0 * z3);
        z3d = c14 * t23d;
        h0_3 = z3 - base2;
        h0_3d = z3d - base2d;
        h1_3 = 2.0 * f3 * (c4 - f3) / z3;
        z3inv = 1.0 / z3;
        h1_3d = (2.0 * f3d * (c4 - f3) + 2.0 * f3 * (c4d - f3d) - h1_3 * z3d) * z3inv;
        a3 = 3.0 * h0_3 - h1_3;
        a3d = 3.0 * h0_3d - h1_3d;
        t24 = z3 * z3 * z3;
        t24d = (z3d * z3 + z3 * z3d) * z3 + z3 * z3 * z3d;
        t25 = 2.0 * f3 * f3 * radius2 * radius2 / t24;
        t24inv = 1.0 / t24;
        t25d = (((2.0 * f3d * f3 + 2.0 * f3 * f3d) * radius2 + 2.0 * f3 * f3 * radius2d) * radius2 +
            2.0 * f3 * f3 * radius2 * radius2d - t25 * t24d) * t24inv;
        b4 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        b4d = 6.0 * h0_3d - 3.0 * h1_3d - t25d;
        t26 = 2.0 * f3;
        t26d = 2.0 * f3d;
        u3 = (c4 + f3 - y2) / t26;
        t26inv = 1.0 / t26;
        u3d = (c4d + f3d - y2d - u3 * t26d) * t26inv;
        w3 = 1.0 - u3;
        w3d = -u3d;
        b30 = u3 * u3 * u3 * (h0_3 + w3 * (a3 + w3 * b4));
        b30d = ((u3d * u3 + u3 * u3d) * u3 + u3 * u3 * u3d) * (h0_3 + w3 * (a3 + w3 * b4)) + u3 * u3
            * u3 * (h0_3d + (w3d * (a3 + w3 * b4) + w3 * (a3d + (w3d * b4 + w3 * b4d))));
        t27 = 2.0 * f3;
        t27d = 2.0 * f3d;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 * (a3 + 2.0 * w3 * b4)) /
            t27;
        t27inv = 1.0 / t27;
        t28d = ((-(way2 * u3d * u3) + -way2 * u3 * u3d) * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 *
            (a3 + 2.0 * w3 * b4)) + -way2 * u3 * u3 * (3.0 * (h0_3d + (w3d * (a3 + w3 * b4) + w3 *
            (a3d + (w3d * b4 + w3 * b4d)))) - (u3d * (a3 + 2.0 * w3 * b4) + u3 * (a3d + (2.0 * w3d *
            b4 + 2.0 * w3 * b4d)))) - t28 * t27d) * t27inv;
        b31 = t28;
        b31d = t28d;
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        t29d = radius2d * radius2 + radius2 * radius2d - (y2d * y2 + y2 * y2d);
        z3_3 = sqrt(t29);
        c15 = 1.0 / (2.0 * z3_3);
        z3_3d = c15 * t29d;
        b30 = z3_3 - base2;
        b30d = z3_3d - base2d;
        t30 = -x4 / z3_3;
        z3_3inv = 1.0 / z3_3;
        t30d = (-x4d - t30 * z3_3d) * z3_3inv;
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
        h2inv = 1.0 / h2;
        t31d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2d - t31 * h2d) * h2inv;
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
        h2_2inv = 1.0 / h2_2;
        t32d = (p6d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t32 * h2_2d) *
            h2_2inv;
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
        h2_3inv = 1.0 / h2_3;
        t33d = (pd[t->roadadr[road] + t->roadn[road] + k8 + 1] - p7d - t33 * h2_3d) * h2_3inv;
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
        t34inv = 1.0 / t34;
        t35d = (((spline0_roadk80d * a4 + spline0_roadk80 * a4d) * a4 + spline0_roadk80 * a4 * a4d)
            * a4 + spline0_roadk80 * a4 * a4 * a4d + (((spline0_roadk810d * c5 + spline0_roadk810 *
            c5d) * c5 + spline0_roadk810 * c5 * c5d) * c5 + spline0_roadk810 * c5 * c5 * c5d) - t35
            * t34d) * t34inv;
        s30 = t35 + p7 - spline0_roadk80 * h2_3 * h2_3 / 6.0 + e2 * c5;
        s30d = t35d + p7d - ((spline0_roadk80d * h2_3 + spline0_roadk80 * h2_3d) * h2_3 +
            spline0_roadk80 * h2_3 * h2_3d) / 6.0 + (e2d * c5 + e2 * c5d);
        t36 = 2.0 * h2_3;
        t36d = 2.0 * h2_3d;
        t37 = (spline0_roadk810 * c5 * c5 - spline0_roadk80 * a4 * a4) / t36;
        t36inv = 1.0 / t36;
        t37d = ((spline0_roadk810d * c5 + spline0_roadk810 * c5d) * c5 + spline0_roadk810 * c5 * c5d
            - ((spline0_roadk80d * a4 + spline0_roadk80 * a4d) * a4 + spline0_roadk80 * a4 * a4d) -
            t37 * t36d) * t36inv;
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
    c16 = 1.0 / (2.0 * s);
    sd = c16 * t38d;
    normal0 = -h11 / s;
    sinv = 1.0 / s;
    normal0d = (-h11d - normal0 * sd) * sinv;
    normal1 = 0.0;
    normal2 = 1.0 / s;
    normal2d = -(normal2 * sd * sinv);
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
    c17 = 1.0 / (2.0 * w);
    wd = c17 * t39d;
    r2 = ((g0 - x) * normal0 + (g2_2 - h10) * normal2) / w;
    winv = 1.0 / w;
    r2d = ((g0d - xd) * normal0 + (g0 - x) * normal0d + ((g2_2d - h10d) * normal2 + (g2_2 - h10) *
        normal2d) - r2 * wd) * winv;
    along0 = un0 / w;
    along0d = (un0d - along0 * wd) * winv;
    along1 = un1 / w;
    along1d = (un1d - along1 * wd) * winv;
    along2 = un2 / w;
    along2d = (un2d - along2 * wd) * winv;
    L0 = normal1 * along2 - normal2 * along1;
    L0d = normal1 * along2d - (normal2d * along1 + normal2 * along1d);
    L1 = normal2 * along0 - normal0 * along2;
    L1d = normal2d * along0 + normal2 * along0d - (normal0d * along2 + normal0 * along2d);
    L2 = normal0 * along1 - normal1 * along0;
    L2d = normal0d * along1 + normal0 * along1d - normal1 * along0d;
    arm0 = r2 * (c * u0 - normal0) / w;
    arm0d = (r2d * (c * u0 - normal0) + r2 * (cd * u0 + c * u0d - normal0d) - arm0 * wd) * winv;
    T0 = along0;
    T0d = along0d;
    N0 = normal0;
    N0d = normal0d;
    arm1 = r2 * (c * u1 - normal1) / w;
    arm1d = (r2d * (c * u1 - normal1) + r2 * (cd * u1 + c * u1d) - arm1 * wd) * winv;
    T1 = along1;
    T1d = along1d;
    N1 = normal1;
    arm2 = r2 * (c * u2_2 - normal2) / w;
    arm2d = (r2d * (c * u2_2 - normal2) + r2 * (cd * u2_2 + c * u2_2d - normal2d) - arm2 * wd) *
        winv;
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
    /* Slip and forces of a wheel.  V is the velocity of the place on the road below the wheel, which the turn of
     * neither wheel nor carrier about the axis moves:
     *   Omega = w.u,  V = v_C + (w - Omega u) × r e,  rho = R0 - r,  rho' = -V.n / |u × n|
     *   Fz = Cz rho + Cd rho'
     *   kappa = -(V.t - Omega Re) / |V.t|,  tan(alpha) = V.l / |V.t|,  sin(gamma) = u.n
     * No force without contact; without grip that of the spring alone, as at rest. */
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
    vxd = v0d * T0 + v0 * T0d + (v1d * T1 + v1 * T1d) + (v2d * T2 + v2 * T2d);
    rhov = (z3_2 * v0 - (v0 * N0 + v1 * N1 + v2 * N2)) / z2_2;
    z2_2inv = 1.0 / z2_2;
    rhovd = (z3_2d * v0 + z3_2 * v0d - (v0d * N0 + v0 * N0d + v1d * N1 + (v2d * N2 + v2 * N2d)) -
        rhov * z2_2d) * z2_2inv;
    fz = slip[i][MAGGI_SLIP_FZ];
    fzd = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] *
        (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - z0) +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] *
        (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - z0d) +
        (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] * rhov +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
    fz0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
    /* Re = R0 - rho0 (D atan(B rd) + F rd),  rd = Fz / Fz0,  rho0 = Fz0 / Cz;  R0 in the air */
    fz0d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]] +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      fz0inv = 1.0 / fz0;
      ratiod = (fzd - ratio * fz0d) * fz0inv;
      t40 = fz0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      inv3 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t40d = (fz0d - t40 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS]) * inv3;
      t41 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio;
      t41d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratiod;
      t42 = atan(t41);
      c18 = 1.0 / (1.0 + t41 * t41);
      t42d = c18 * t41d;
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
    /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
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
      p8inv = 1.0 / p8;
      t43d = (vxd * vx + vx * vxd - t43 * p8d) * p8inv;
      y3 = 0.5 * (p8 + t43);
      y3d = 0.5 * (p8d + t43d);
    }
    speed = y3;
    speedd = y3d;
    speedinv = 1.0 / speed;
    slipd[i][MAGGI_SLIP_KAPPA] = (omegad * re + omega * red - vxd - slip[i][MAGGI_SLIP_KAPPA] *
        speedd) * speedinv;
    slipd[i][MAGGI_SLIP_TAN_ALPHA] = (v0d * L0 + v0 * L0d + (v1d * L1 + v1 * L1d) + (v2d * L2 + v2 *
        L2d) - slip[i][MAGGI_SLIP_TAN_ALPHA] * speedd) * speedinv;
    c19 = z2_2 / (z2_2 * z2_2 + z1 * z1);
    c20 = -(z1 / (z2_2 * z2_2 + z1 * z1));
    slipd[i][MAGGI_SLIP_GAMMA] = c19 * z1d + c20 * z2_2d;
    slipd[i][MAGGI_SLIP_FZ] = fzd;
    slipd[i][MAGGI_SLIP_VX] = vxd;
    slipd[i][MAGGI_SLIP_RADIUS] = z0d;
    slipd[i][MAGGI_SLIP_ROLLING] = red;
    if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z0) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_UNLOADED_RADIUS])) {
      if (t->wheelgrip[i]) {
        side = t->wheelmirror[i] ? -1.0 : 1.0;
        one0 = slip[i][MAGGI_SLIP_KAPPA];
        /* the formula on either side; f: Fx Fy Fz, Mx My Mz */
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
        fz0_2inv = 1.0 / fz0_2;
        dfzd = (fz2d - fz0_2d - dfz * fz0_2d) * fz0_2inv;
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
          /* a curvature: more than 1 would turn the curve around */
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
          /* a curvature: more than 1 would turn the curve around */
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
        /* sin(2 atan(z)) = 2 z / (1 + z^2) */
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
          /* a curvature: more than 1 would turn the curve around */
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
          /* a curvature: more than 1 would turn the curve around */
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
        t46inv = 1.0 / t46;
        z5d = (fz2d - z5 * t46d) * t46inv;
        y40 = muy * fz2;
        y40d = muyd * fz2 + muy * fz2d;
        y41 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        y41d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY];
        y42 = ey;
        y42d = eyd;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
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
          t47inv = 1.0 / t47;
          z6d = (gyd * gy + gy * gyd - z6 * t47d) * t47inv;
          y9 = 0.125 * p9 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
          y9d = (0.125 * p9d * z6 + 0.125 * p9 * z6d) * (15.0 + z6 * (-10.0 + 3.0 * z6)) + 0.125 *
              p9 * z6 * (z6d * (-10.0 + 3.0 * z6) + z6 * (3.0 * z6d));
        }
        t48 = 1.0 + z5 * z5;
        t48d = z5d * z5 + z5 * z5d;
        t49 = 2.0 * z5 / t48;
        t48inv = 1.0 / t48;
        t49d = (2.0 * z5d - t49 * t48d) * t48inv;
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
        /* what combined slip makes of the forces:  Fx = Gxa Fx0, Fy = Gyk Fy0 + SVyk.  g: b, c, e, shift of Gxa,
         * then of Gyk, SVyk */
        x6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappad;
        t50 = 1.0 + x6 * x6;
        t50d = x6d * x6 + x6 * x6d;
        t51 = sqrt(t50);
        c21 = 1.0 / (2.0 * t51);
        t51d = c21 * t50d;
        t52 = 1.0 / t51;
        t51inv = 1.0 / t51;
        t52d = -(t52 * t51d * t51inv);
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
        /* a curvature: more than 1 would turn the curve around */
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
        c22 = 1.0 / (2.0 * t54);
        t54d = c22 * t53d;
        t55 = 1.0 / t54;
        t54inv = 1.0 / t54;
        t55d = -(t55 * t54d * t54inv);
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
        /* a curvature: more than 1 would turn the curve around */
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
        c23 = 1.0 / (2.0 * t57);
        t57d = c23 * t56d;
        t58 = 1.0 / t57;
        t57inv = 1.0 / t57;
        t58d = -(t58 * t57d * t57inv);
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
        c24 = 1.0 / (1.0 + t59 * t59);
        t60d = c24 * t59d;
        t61 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t60;
        t61d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t60 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t60d;
        t62 = sin(t61);
        c25 = cos(t61);
        t62d = c25 * t61d;
        g28 = dv * t62 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        g28d = (dvd * t62 + dv * t62d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] + dv *
            t62 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        t63 = x51 * x50;
        t63d = x51d * x50 + x51 * x50d;
        t64 = x53 / t63;
        t63inv = 1.0 / t63;
        t64d = (x53d - t64 * t63d) * t63inv;
        y12 = t64 * x54;
        y12d = t64d * x54 + t64 * x54d;
        y13 = g20 * (a5 + g23);
        y13d = g20d * (a5 + g23) + g20 * (a5d + g23d);
        y14 = g20 * g23;
        y14d = g20d * g23 + g20 * g23d;
        t65 = atan(y12);
        c26 = 1.0 / (1.0 + y12 * y12);
        t65d = c26 * y12d;
        t66 = (1.0 - x52) * y12 + x52 * t65;
        t66d = -(x52d * y12) + (1.0 - x52) * y12d + (x52d * t65 + x52 * t65d);
        t67 = atan(t66);
        c27 = 1.0 / (1.0 + t66 * t66);
        t67d = c27 * t66d;
        t68 = x51 * t67;
        t68d = x51d * t67 + x51 * t67d;
        t69 = sin(t68);
        c28 = cos(t68);
        t69d = c28 * t68d;
        t70 = atan(y13);
        c29 = 1.0 / (1.0 + y13 * y13);
        t70d = c29 * y13d;
        t71 = (1.0 - g22) * y13 + g22 * t70;
        t71d = -(g22d * y13) + (1.0 - g22) * y13d + (g22d * t70 + g22 * t70d);
        t72 = atan(t71);
        c30 = 1.0 / (1.0 + t71 * t71);
        t72d = c30 * t71d;
        t73 = g21 * t72;
        t73d = g21d * t72 + g21 * t72d;
        t74 = cos(t73);
        c31 = -sin(t73);
        t74d = c31 * t73d;
        t75 = atan(y14);
        c32 = 1.0 / (1.0 + y14 * y14);
        t75d = c32 * y14d;
        t76 = (1.0 - g22) * y14 + g22 * t75;
        t76d = -(g22d * y14) + (1.0 - g22) * y14d + (g22d * t75 + g22 * t75d);
        t77 = atan(t76);
        c33 = 1.0 / (1.0 + t76 * t76);
        t77d = c33 * t76d;
        t78 = g21 * t77;
        t78d = g21d * t77 + g21 * t77d;
        t79 = cos(t78);
        c34 = -sin(t78);
        t79d = c34 * t78d;
        t80 = t74 / t79;
        t79inv = 1.0 / t79;
        t80d = (t74d - t80 * t79d) * t79inv;
        fx = (x50 * t69 + x55) * t80;
        fxd = (x50d * t69 + x50 * t69d + x55d) * t80 + (x50 * t69 + x55) * t80d;
        t81 = y41 * y40;
        t81d = y41d * y40 + y41 * y40d;
        t82 = y43 / t81;
        t81inv = 1.0 / t81;
        t82d = (y43d - t82 * t81d) * t81inv;
        y15 = t82 * y44;
        y15d = t82d * y44 + t82 * y44d;
        y16 = g24 * (kappa + g27);
        y16d = g24d * (kappa + g27) + g24 * (kappad + g27d);
        y17 = g24 * g27;
        y17d = g24d * g27 + g24 * g27d;
        t83 = atan(y15);
        c35 = 1.0 / (1.0 + y15 * y15);
        t83d = c35 * y15d;
        t84 = (1.0 - y42) * y15 + y42 * t83;
        t84d = -(y42d * y15) + (1.0 - y42) * y15d + (y42d * t83 + y42 * t83d);
        t85 = atan(t84);
        c36 = 1.0 / (1.0 + t84 * t84);
        t85d = c36 * t84d;
        t86 = y41 * t85;
        t86d = y41d * t85 + y41 * t85d;
        t87 = sin(t86);
        c37 = cos(t86);
        t87d = c37 * t86d;
        t88 = atan(y16);
        c38 = 1.0 / (1.0 + y16 * y16);
        t88d = c38 * y16d;
        t89 = (1.0 - g26) * y16 + g26 * t88;
        t89d = -(g26d * y16) + (1.0 - g26) * y16d + (g26d * t88 + g26 * t88d);
        t90 = atan(t89);
        c39 = 1.0 / (1.0 + t89 * t89);
        t90d = c39 * t89d;
        t91 = g25 * t90;
        t91d = g25d * t90 + g25 * t90d;
        t92 = cos(t91);
        c40 = -sin(t91);
        t92d = c40 * t91d;
        t93 = atan(y17);
        c41 = 1.0 / (1.0 + y17 * y17);
        t93d = c41 * y17d;
        t94 = (1.0 - g26) * y17 + g26 * t93;
        t94d = -(g26d * y17) + (1.0 - g26) * y17d + (g26d * t93 + g26 * t93d);
        t95 = atan(t94);
        c42 = 1.0 / (1.0 + t94 * t94);
        t95d = c42 * t94d;
        t96 = g25 * t95;
        t96d = g25d * t95 + g25 * t95d;
        t97 = cos(t96);
        c43 = -sin(t96);
        t97d = c43 * t96d;
        t98 = t92 / t97;
        t97inv = 1.0 / t97;
        t98d = (t92d - t98 * t97d) * t97inv;
        fy = (y40 * t87 + y45) * t98;
        fyd = (y40d * t87 + y40 * t87d + y45d) * t98 + (y40 * t87 + y45) * t98d;
        ratio2 = x53 * kappa / y43;
        y43inv = 1.0 / y43;
        ratio2d = (x53d * kappa + x53 * kappad - ratio2 * y43d) * y43inv;
        fz0_4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
         *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
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
        t99d = (y45d - t99 * y43d) * y43inv;
        ar = y44 + t99;
        ard = y44d + t99d;
        t100 = at * at + ratio2 * ratio2 + 1e-24;
        t100d = atd * at + at * atd + (ratio2d * ratio2 + ratio2 * ratio2d);
        ateq = sqrt(t100);
        c44 = 1.0 / (2.0 * ateq);
        ateqd = c44 * t100d;
        t101 = ar * ar + ratio2 * ratio2 + 1e-24;
        t101d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
        areq = sqrt(t101);
        c45 = 1.0 / (2.0 * areq);
        areqd = c45 * t101d;
        scale = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LMUY];
        inv4 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        scaled = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] - scale *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]) * inv4;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
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
          t102inv = 1.0 / t102;
          z7d = (gzd * gz + gz * gzd - z7 * t102d) * t102inv;
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
        fz0_4inv = 1.0 / fz0_4;
        t103d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - t103 * fz0_4d) *
            fz0_4inv;
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
        c46 = 1.0 / (1.0 + t104 * t104);
        t105d = c46 * t104d;
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
        /* a curvature: more than 1 would turn the curve around */
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
        y40inv = 1.0 / y40;
        t106d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * y43 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * y43d - t106 * y40d) * y40inv;
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
        c47 = 1.0 / (2.0 * t108);
        t108d = c47 * t107d;
        ca = 1.0 / t108;
        t108inv = 1.0 / t108;
        cad = -(ca * t108d * t108inv);
        y20 = bt * ateq;
        y20d = btd * ateq + bt * ateqd;
        t109 = atan(y20);
        c48 = 1.0 / (1.0 + y20 * y20);
        t109d = c48 * y20d;
        t110 = (1.0 - et) * y20 + et * t109;
        t110d = -(etd * y20) + (1.0 - et) * y20d + (etd * t109 + et * t109d);
        t111 = atan(t110);
        c49 = 1.0 / (1.0 + t110 * t110);
        t111d = c49 * t110d;
        t112 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t111;
        t112d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t111 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t111d;
        t113 = cos(t112);
        c50 = -sin(t112);
        t113d = c50 * t112d;
        z40 = dt * t113 * ca;
        z40d = (dtd * t113 + dt * t113d) * ca + dt * t113 * cad;
        x9 = br * areq;
        x9d = brd * areq + br * areqd;
        t114 = 1.0 + x9 * x9;
        t114d = x9d * x9 + x9 * x9d;
        t115 = sqrt(t114);
        c51 = 1.0 / (2.0 * t115);
        t115d = c51 * t114d;
        t116 = 1.0 / t115;
        t115inv = 1.0 / t115;
        t116d = -(t116 * t115d * t115inv);
        z41d = (drd * t116 + dr * t116d) * ca + dr * t116 * cad;
        force2 = fy + g28;
        force2d = fyd + g28d;
        t117 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * force2 / fz0_2;
        t117d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * force2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * force2d - t117 * fz0_2d) * fz0_2inv;
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
        inv5 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        t118d = (one4d - t118 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]) * inv5;
        way3 = tanh(t118);
        way3d = (1.0 - way3 * way3) * t118d;
        speed2 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        inv6 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        speed2d = (one4d - speed2 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]) * inv6;
        force0d = fxd;
        force1d = force2d;
        force2_2d = fz2d;
        t119 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * force2 / fz0_2;
        t119d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * force2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * force2d - t119 * fz0_2d) * fz0_2inv;
        force3_2d = (r0d * fz2 + r0 * fz2d) * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma + t119) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]) + r0
            * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX1] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] +
            ((-(pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma) -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gammad + t119d) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma + t119) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]));
        t120 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
        t120d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fxd - t120 * fz0_2d) * fz0_2inv;
        force4d = (((-(way3d * r0) - way3 * r0d) * fz2 + -way3 * r0 * fz2d) *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way3 * speed2 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed2 * speed2 * speed2 * speed2) + -way3 * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY1] + t120d + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 * speed2d) +
            ((((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2d) * speed2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2 * speed2d)))
            * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] + -way3 * r0 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way3 * speed2 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed2 * speed2 * speed2 * speed2) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        force5d = -(z40d * fy) - z40 * fyd + z41d + (s4d * fx + s4 * fxd);
        fd[i][0] = force0d;
        fd[i][1] = side * force1d;
        fd[i][2] = force2_2d;
        fd[i][3] = side * force3_2d;
        fd[i][4] = force4d;
        fd[i][5] = side * force5d;
      } else {
        for (k9 = 0; k9 < 6; ++k9) {
          if (k9 == 2) {
            t121d = fzd;
          } else {
            t121d = 0.0;
          }
          fd[i][k9] = t121d;
        }
      }
    } else {
      for (k9_2 = 0; k9_2 < 6; ++k9_2) {
        fd[i][k9_2] = 0.0;
      }
    }
    r30 = r[t->wheelpoint[i]][0] + arm0;
    /* F: force f_x T + f_y L + f_z N at the contact point, with its moment, as one about P */
    r30d = rd[t->wheelpoint[i]][0] + arm0d;
    f_i0 = f[i][0];
    f_i0d = fd[i][0];
    f_i1 = f[i][1];
    f_i1d = fd[i][1];
    f_i2 = f[i][2];
    f_i2d = fd[i][2];
    force30 = F[i][0];
    force30d = f_i0d * T0 + f_i0 * T0d + (f_i1d * L0 + f_i1 * L0d) + (f_i2d * N0 + f_i2 * N0d);
    r31 = r[t->wheelpoint[i]][1] + arm1;
    r31d = rd[t->wheelpoint[i]][1] + arm1d;
    force31 = F[i][1];
    force31d = f_i0d * T1 + f_i0 * T1d + (f_i1d * L1 + f_i1 * L1d) + f_i2d * N1;
    r32 = r[t->wheelpoint[i]][2] + arm2;
    r32d = rd[t->wheelpoint[i]][2] + arm2d;
    force32 = F[i][2];
    force32d = f_i0d * T2 + f_i0 * T2d + (f_i1d * L2 + f_i1 * L2d) + (f_i2d * N2 + f_i2 * N2d);
    moment0d = r31d * force32 + r31 * force32d - (r32d * force31 + r32 * force31d);
    moment1d = r32d * force30 + r32 * force30d - (r30d * force32 + r30 * force32d);
    moment2d = r30d * force31 + r30 * force31d - (r31d * force30 + r31 * force30d);
    Fd[i][0] = force30d;
    f_i3 = f[i][3];
    f_i3d = fd[i][3];
    f_i4 = f[i][4];
    f_i4d = fd[i][4];
    f_i5 = f[i][5];
    f_i5d = fd[i][5];
    Fd[i][3] = moment0d + (f_i3d * T0 + f_i3 * T0d) + (f_i4d * L0 + f_i4 * L0d) + (f_i5d * N0 + f_i5
        * N0d);
    Fd[i][1] = force31d;
    Fd[i][4] = moment1d + (f_i3d * T1 + f_i3 * T1d) + (f_i4d * L1 + f_i4 * L1d) + f_i5d * N1;
    Fd[i][2] = force32d;
    Fd[i][5] = moment2d + (f_i3d * T2 + f_i3 * T2d) + (f_i4d * L2 + f_i4 * L2d) + (f_i5d * N2 + f_i5
        * N2d);
  }
}

/* Rates of the coordinates on which wheels turn at which they roll freely, kappa = 0: with w that of the
 * carrier and w_q that of the wheel on it at the rate 1
 *   v = (V.t / Re - w.u) / (w_q.u) */
void maggi_rolling_d(const maggi_topo *t, const double p[restrict t->np],
                     const double pd[restrict t->np], const double spline0[restrict t->nspline][3],
                     const double spline0d[restrict t->nspline][3],
                     const double A[restrict t->nbody + 1][9],
                     const double Ad[restrict t->nbody + 1][9],
                     const double b[restrict t->nbody][6], const double bd[restrict t->nbody][6],
                     const double r[restrict t->npoint][3], const double rd[restrict t->npoint][3],
                     const double Z[restrict t->nbody + 1][6],
                     const double Zd[restrict t->nbody + 1][6], double spin[restrict t->nwheel],
                     double spind[restrict t->nwheel])
{
  int adr, body, carrier, i, k4, k6, k7, k9, road;
  double N0, N0d, N1, N2, N2d, T0, T0d, T1, T1d, T2, T2d, a, a2, a2d, a3, a3d, a4, a4d, ad, along0,
      along0d, along1, along1d, along2, along2d, arm0, arm0d, arm1, arm1d, arm2, arm2d, axis0,
      axis0d, axis1, axis1d, axis2, axis2d, b20, b20d, b3, b3d, b40, b40d, b41, b41d, b5, b5d, base,
      base2, base2d, based, c, c10, c11, c12, c13, c14, c15, c16, c17, c18, c2, c2d, c3, c3d, c4,
      c4d, c5, c5d, c6, c7, c8, c9, cd, e, e2, e2d, ed, f, f2, f2d, fd, fz, fz0, fz0d, fz0inv, fzd,
      g0, g0d, g2, g2d, h, h00, h00d, h0_2, h0_2d, h0_3, h0_3d, h10, h10d, h11, h11d, h12, h12d,
      h1_2, h1_2d, h1_3, h1_3d, h2, h2_2, h2_2d, h2_2inv, h2_3, h2_3d, h2_3inv, h2d, h2inv, h3,
      h3_2, h3_2d, h3_2inv, h3d, h3inv, hd, hinv, inv, inv2, inv3, k5, k5d, k8, k8d, n2, n2d, n2inv,
      normal0, normal0d, normal1, normal2, normal2d, p2, p2d, p3, p3d, p4, p4d, p5, p5d, p6, p6d,
      p7, p7d, p_road, p_road2, p_road2d, p_road3, p_road3d, p_road4, p_road4d, p_road5, p_road5d,
      p_road6, p_road6d, p_roadd, p_roadk6, p_roadk61, p_roadk61d, p_roadk6d, p_roadk9, p_roadk91,
      p_roadk91d, p_roadk9d, p_roadroad, p_roadroad2, p_roadroad2d, p_roadroadd, r2, r2d, r_i0,
      r_i0d, r_i1, r_i1d, r_i2, r_i2d, radius, radius2, radius2d, radiusd, ratio, ratiod, re, re2,
      re2d, red, reinv, rhov, rhovd, s, s20, s20d, s30, s30d, s31, s31d, sd, sinv, slope, slope2,
      slope2_2, slope2_2d, slope2d, slope3, slope3d, sloped, spline0_roadk60, spline0_roadk60d,
      spline0_roadk610, spline0_roadk610d, spline0_roadk90, spline0_roadk90d, spline0_roadk910,
      spline0_roadk910d, t10, t10d, t11, t11d, t12, t12d, t13, t13d, t14, t14d, t14inv, t15, t15d,
      t16, t16d, t16inv, t17, t17d, t18, t18d, t19, t19d, t2, t20, t20d, t21, t21d, t22, t22d, t23,
      t23d, t24, t24d, t24inv, t25, t25d, t26, t26d, t26inv, t27, t27d, t27inv, t28, t28d, t29,
      t29d, t2d, t3, t30, t30d, t31, t31d, t32, t32d, t33, t33d, t34, t34d, t34inv, t35, t35d, t36,
      t36d, t36inv, t37, t37d, t38, t38d, t39, t39d, t3d, t4, t40, t40d, t41, t41d, t42, t42d, t43,
      t43d, t44, t44d, t44inv, t4d, t5, t5d, t6, t6d, t7, t7d, t7inv, t8, t8d, t9, t9d, t9inv, turn,
      turnd, u0, u0d, u1, u1d, u2, u2_2, u2_2d, u2d, u3, u3d, ua0, ua0d, ua1, ua1d, ua2, ua2d, un0,
      un0d, un1, un1d, un2, un2d, v0, v0d, v1, v1d, v2, v2d, vc0, vc0d, vc1, vc1d, vc2, vc2d, vr0,
      vr0d, vr1, vr1d, vr2, vr2d, w0, w0d, w1, w1d, w2, w2_2, w2_2d, w2d, w2inv, w3, w3d, w4, w4d,
      way, way2, wr0, wr0d, wr1, wr1d, wr2, wr2d, x, x2, x2d, x3, x3d, x4, x4d, xd, y, y2, y2d, yd,
      z0, z0d, z2, z2_2, z2_2d, z2_2inv, z2_3, z2_3d, z2d, z2inv, z3, z3_2, z3_2d, z3_3, z3_3d,
      z3_3inv, z3d, z3inv;

  for (i = 0; i < t->nwheel; ++i) {
    adr = t->tyreadr[t->wheeltyre[i]];
    body = t->wheelbody[i];
    carrier = t->wheelcarrier[i];
    /* the unit axis u of wheel i, and where it meets its road */
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
    c6 = 1.0 / (2.0 * n2);
    n2d = c6 * t2d;
    u0 = ua0 / n2;
    n2inv = 1.0 / n2;
    u0d = (ua0d - u0 * n2d) * n2inv;
    u1 = ua1 / n2;
    u1d = (ua1d - u1 * n2d) * n2inv;
    u2_2 = ua2 / n2;
    u2_2d = (ua2d - u2_2 * n2d) * n2inv;
    g0 = r[t->wheelpoint[i]][0] - r[t->roadpoint[road]][0];
    g0d = rd[t->wheelpoint[i]][0] - rd[t->roadpoint[road]][0];
    g2 = r[t->wheelpoint[i]][2] - r[t->roadpoint[road]][2];
    g2d = rd[t->wheelpoint[i]][2] - rd[t->roadpoint[road]][2];
    x2 = g0;
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n|, slope that the plane lacks */
    x2d = g0d;
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      p_roadd = pd[t->roadadr[road]];
      h00 = p_road * x2;
      h00d = p_roadd * x2 + p_road * x2d;
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k5 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      inv = 1.0 / p[t->roadadr[road] + 1];
      k5d = -(k5 * pd[t->roadadr[road] + 1] * inv);
      t3 = k5 * x2;
      t3d = k5d * x2 + k5 * x2d;
      t4 = sin(t3);
      c7 = cos(t3);
      t4d = c7 * t3d;
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
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      radiusd = pd[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      based = radiusd - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      t5d = radiusd * radius + radius * radiusd - (based * base + base * based);
      c2 = sqrt(t5);
      c8 = 1.0 / (2.0 * c2);
      c2d = c8 * t5d;
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
        c9 = 1.0 / (2.0 * z2);
        z2d = c9 * t6d;
        h0_2 = z2 - base;
        h0_2d = z2d - based;
        h1_2 = 2.0 * f * (c2 - f) / z2;
        z2inv = 1.0 / z2;
        h1_2d = (2.0 * fd * (c2 - f) + 2.0 * f * (c2d - fd) - h1_2 * z2d) * z2inv;
        a = 3.0 * h0_2 - h1_2;
        ad = 3.0 * h0_2d - h1_2d;
        t7 = z2 * z2 * z2;
        t7d = (z2d * z2 + z2 * z2d) * z2 + z2 * z2 * z2d;
        t8 = 2.0 * f * f * radius * radius / t7;
        t7inv = 1.0 / t7;
        t8d = (((2.0 * fd * f + 2.0 * f * fd) * radius + 2.0 * f * f * radiusd) * radius + 2.0 * f *
            f * radius * radiusd - t8 * t7d) * t7inv;
        b3 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        b3d = 6.0 * h0_2d - 3.0 * h1_2d - t8d;
        t9 = 2.0 * f;
        t9d = 2.0 * fd;
        u2 = (c2 + f - y) / t9;
        t9inv = 1.0 / t9;
        u2d = (c2d + fd - yd - u2 * t9d) * t9inv;
        w3 = 1.0 - u2;
        w3d = -u2d;
        b20 = u2 * u2 * u2 * (h0_2 + w3 * (a + w3 * b3));
        b20d = ((u2d * u2 + u2 * u2d) * u2 + u2 * u2 * u2d) * (h0_2 + w3 * (a + w3 * b3)) + u2 * u2
            * u2 * (h0_2d + (w3d * (a + w3 * b3) + w3 * (ad + (w3d * b3 + w3 * b3d))));
      } else {
        t10 = radius * radius - y * y;
        t10d = radiusd * radius + radius * radiusd - (yd * y + y * yd);
        z2_3 = sqrt(t10);
        c10 = 1.0 / (2.0 * z2_3);
        z2_3d = c10 * t10d;
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
        hinv = 1.0 / h;
        t11d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroadd - t11 * hd) * hinv;
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
        h3inv = 1.0 / h3;
        t12d = (p3d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t12 * h3d) *
            h3inv;
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
        h3_2inv = 1.0 / h3_2;
        t13d = (pd[t->roadadr[road] + t->roadn[road] + k6 + 1] - p4d - t13 * h3_2d) * h3_2inv;
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
        t14inv = 1.0 / t14;
        t15d = (((spline0_roadk60d * a2 + spline0_roadk60 * a2d) * a2 + spline0_roadk60 * a2 * a2d)
            * a2 + spline0_roadk60 * a2 * a2 * a2d + (((spline0_roadk610d * c3 + spline0_roadk610 *
            c3d) * c3 + spline0_roadk610 * c3 * c3d) * c3 + spline0_roadk610 * c3 * c3 * c3d) - t15
            * t14d) * t14inv;
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
    t16inv = 1.0 / t16;
    t17d = (u2_2d * u0 + u2_2 * u0d - t17 * t16d) * t16inv;
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
      inv2 = 1.0 / p[t->roadadr[road] + 1];
      k8d = -(k8 * pd[t->roadadr[road] + 1] * inv2);
      t18 = k8 * x;
      t18d = k8d * x + k8 * xd;
      t19 = sin(t18);
      c11 = cos(t18);
      t19d = c11 * t18d;
      p_road5 = p[t->roadadr[road]];
      p_road5d = pd[t->roadadr[road]];
      h10 = p_road5 * t19;
      h10d = p_road5d * t19 + p_road5 * t19d;
      t20 = k8 * x;
      t20d = k8d * x + k8 * xd;
      t21 = cos(t20);
      c12 = -sin(t20);
      t21d = c12 * t20d;
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
      /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
       * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
       *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
      radius2d = pd[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      base2d = radius2d - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      t22d = radius2d * radius2 + radius2 * radius2d - (base2d * base2 + base2 * base2d);
      c4 = sqrt(t22);
      c13 = 1.0 / (2.0 * c4);
      c4d = c13 * t22d;
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
        c14 = 1.0 / (2.0 * z3);
        z3d = c14 * t23d;
        h0_3 = z3 - base2;
        h0_3d = z3d - base2d;
        h1_3 = 2.0 * f2 * (c4 - f2) / z3;
        z3inv = 1.0 / z3;
        h1_3d = (2.0 * f2d * (c4 - f2) + 2.0 * f2 * (c4d - f2d) - h1_3 * z3d) * z3inv;
        a3 = 3.0 * h0_3 - h1_3;
        a3d = 3.0 * h0_3d - h1_3d;
        t24 = z3 * z3 * z3;
        t24d = (z3d * z3 + z3 * z3d) * z3 + z3 * z3 * z3d;
        t25 = 2.0 * f2 * f2 * radius2 * radius2 / t24;
        t24inv = 1.0 / t24;
        t25d = (((2.0 * f2d * f2 + 2.0 * f2 * f2d) * radius2 + 2.0 * f2 * f2 * radius2d) * radius2 +
            2.0 * f2 * f2 * radius2 * radius2d - t25 * t24d) * t24inv;
        b5 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        b5d = 6.0 * h0_3d - 3.0 * h1_3d - t25d;
        t26 = 2.0 * f2;
        t26d = 2.0 * f2d;
        u3 = (c4 + f2 - y2) / t26;
        t26inv = 1.0 / t26;
        u3d = (c4d + f2d - y2d - u3 * t26d) * t26inv;
        w4 = 1.0 - u3;
        w4d = -u3d;
        b40 = u3 * u3 * u3 * (h0_3 + w4 * (a3 + w4 * b5));
        b40d = ((u3d * u3 + u3 * u3d) * u3 + u3 * u3 * u3d) * (h0_3 + w4 * (a3 + w4 * b5)) + u3 * u3
            * u3 * (h0_3d + (w4d * (a3 + w4 * b5) + w4 * (a3d + (w4d * b5 + w4 * b5d))));
        t27 = 2.0 * f2;
        t27d = 2.0 * f2d;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 * (a3 + 2.0 * w4 * b5)) /
            t27;
        t27inv = 1.0 / t27;
        t28d = ((-(way2 * u3d * u3) + -way2 * u3 * u3d) * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 *
            (a3 + 2.0 * w4 * b5)) + -way2 * u3 * u3 * (3.0 * (h0_3d + (w4d * (a3 + w4 * b5) + w4 *
            (a3d + (w4d * b5 + w4 * b5d)))) - (u3d * (a3 + 2.0 * w4 * b5) + u3 * (a3d + (2.0 * w4d *
            b5 + 2.0 * w4 * b5d)))) - t28 * t27d) * t27inv;
        b41 = t28;
        b41d = t28d;
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        t29d = radius2d * radius2 + radius2 * radius2d - (y2d * y2 + y2 * y2d);
        z3_3 = sqrt(t29);
        c15 = 1.0 / (2.0 * z3_3);
        z3_3d = c15 * t29d;
        b40 = z3_3 - base2;
        b40d = z3_3d - base2d;
        t30 = -x4 / z3_3;
        z3_3inv = 1.0 / z3_3;
        t30d = (-x4d - t30 * z3_3d) * z3_3inv;
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
        h2inv = 1.0 / h2;
        t31d = (pd[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2d - t31 * h2d) * h2inv;
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
        h2_2inv = 1.0 / h2_2;
        t32d = (p6d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2] - t32 * h2_2d) *
            h2_2inv;
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
        h2_3inv = 1.0 / h2_3;
        t33d = (pd[t->roadadr[road] + t->roadn[road] + k9 + 1] - p7d - t33 * h2_3d) * h2_3inv;
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
        t34inv = 1.0 / t34;
        t35d = (((spline0_roadk90d * a4 + spline0_roadk90 * a4d) * a4 + spline0_roadk90 * a4 * a4d)
            * a4 + spline0_roadk90 * a4 * a4 * a4d + (((spline0_roadk910d * c5 + spline0_roadk910 *
            c5d) * c5 + spline0_roadk910 * c5 * c5d) * c5 + spline0_roadk910 * c5 * c5 * c5d) - t35
            * t34d) * t34inv;
        s30 = t35 + p7 - spline0_roadk90 * h2_3 * h2_3 / 6.0 + e2 * c5;
        s30d = t35d + p7d - ((spline0_roadk90d * h2_3 + spline0_roadk90 * h2_3d) * h2_3 +
            spline0_roadk90 * h2_3 * h2_3d) / 6.0 + (e2d * c5 + e2 * c5d);
        t36 = 2.0 * h2_3;
        t36d = 2.0 * h2_3d;
        t37 = (spline0_roadk910 * c5 * c5 - spline0_roadk90 * a4 * a4) / t36;
        t36inv = 1.0 / t36;
        t37d = ((spline0_roadk910d * c5 + spline0_roadk910 * c5d) * c5 + spline0_roadk910 * c5 * c5d
            - ((spline0_roadk90d * a4 + spline0_roadk90 * a4d) * a4 + spline0_roadk90 * a4 * a4d) -
            t37 * t36d) * t36inv;
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
    c16 = 1.0 / (2.0 * s);
    sd = c16 * t38d;
    normal0 = -h11 / s;
    sinv = 1.0 / s;
    normal0d = (-h11d - normal0 * sd) * sinv;
    normal1 = 0.0;
    normal2 = 1.0 / s;
    normal2d = -(normal2 * sd * sinv);
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
    c17 = 1.0 / (2.0 * w2);
    w2d = c17 * t39d;
    r2 = ((g0 - x) * normal0 + (g2 - h10) * normal2) / w2;
    w2inv = 1.0 / w2;
    r2d = ((g0d - xd) * normal0 + (g0 - x) * normal0d + ((g2d - h10d) * normal2 + (g2 - h10) *
        normal2d) - r2 * w2d) * w2inv;
    along0 = un0 / w2;
    along0d = (un0d - along0 * w2d) * w2inv;
    along1 = un1 / w2;
    along1d = (un1d - along1 * w2d) * w2inv;
    along2 = un2 / w2;
    along2d = (un2d - along2 * w2d) * w2inv;
    arm0 = r2 * (c * u0 - normal0) / w2;
    arm0d = (r2d * (c * u0 - normal0) + r2 * (cd * u0 + c * u0d - normal0d) - arm0 * w2d) * w2inv;
    T0 = along0;
    T0d = along0d;
    N0 = normal0;
    N0d = normal0d;
    arm1 = r2 * (c * u1 - normal1) / w2;
    arm1d = (r2d * (c * u1 - normal1) + r2 * (cd * u1 + c * u1d) - arm1 * w2d) * w2inv;
    T1 = along1;
    T1d = along1d;
    N1 = normal1;
    arm2 = r2 * (c * u2_2 - normal2) / w2;
    arm2d = (r2d * (c * u2_2 - normal2) + r2 * (cd * u2_2 + c * u2_2d - normal2d) - arm2 * w2d) *
        w2inv;
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
    z2_2inv = 1.0 / z2_2;
    rhovd = (z3_2d * v0 + z3_2 * v0d - (v0d * N0 + v0 * N0d + v1d * N1 + (v2d * N2 + v2 * N2d)) -
        rhov * z2_2d) * z2_2inv;
    fz = p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] * (p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0) + p[adr
        + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
    fzd = pd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] * (p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0) +
        p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] * (pd[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0d) +
        (pd[adr + MAGGI_TYRE_VERTICAL_DAMPING] * rhov + p[adr + MAGGI_TYRE_VERTICAL_DAMPING] *
        rhovd);
    fz0 = p[adr + MAGGI_TYRE_LFZO] * p[adr];
    /* Re = R0 - rho0 (D atan(B rd) + F rd),  rd = Fz / Fz0,  rho0 = Fz0 / Cz;  R0 in the air */
    fz0d = pd[adr + MAGGI_TYRE_LFZO] * p[adr] + p[adr + MAGGI_TYRE_LFZO] * pd[adr];
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      fz0inv = 1.0 / fz0;
      ratiod = (fzd - ratio * fz0d) * fz0inv;
      t40 = fz0 / p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
      inv3 = 1.0 / p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t40d = (fz0d - t40 * pd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS]) * inv3;
      t41 = p[adr + MAGGI_TYRE_BREFF] * ratio;
      t41d = pd[adr + MAGGI_TYRE_BREFF] * ratio + p[adr + MAGGI_TYRE_BREFF] * ratiod;
      t42 = atan(t41);
      c18 = 1.0 / (1.0 + t41 * t41);
      t42d = c18 * t41d;
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
    reinv = 1.0 / re;
    t43d = (v0d * T0 + v0 * T0d + (v1d * T1 + v1 * T1d) + (v2d * T2 + v2 * T2d) - t43 * red) *
        reinv;
    t44 = b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2_2;
    t44d = bd[body][3] * u0 + b[body][3] * u0d + (bd[body][4] * u1 + b[body][4] * u1d) +
        (bd[body][5] * u2_2 + b[body][5] * u2_2d);
    t44inv = 1.0 / t44;
    spind[i] = (t43d - turnd - spin[i] * t44d) * t44inv;
  }
}
