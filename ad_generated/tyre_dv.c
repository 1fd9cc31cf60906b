/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/tyre.c.
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
void maggi_wheel_forces_dv(const maggi_topo *t, const double p[restrict t->np],
                           const double pd[restrict t->np][MAGGI_NDIR],
                           const double spline0[restrict t->nspline][3],
                           const double spline0d[restrict t->nspline][3][MAGGI_NDIR],
                           const double A[restrict t->nbody + 1][9],
                           const double Ad[restrict t->nbody + 1][9][MAGGI_NDIR],
                           const double Z[restrict t->nbody + 1][6],
                           const double Zd[restrict t->nbody + 1][6][MAGGI_NDIR],
                           const double r[restrict t->npoint][3],
                           const double rd[restrict t->npoint][3][MAGGI_NDIR],
                           const double rv[restrict t->npoint][3],
                           const double rvd[restrict t->npoint][3][MAGGI_NDIR],
                           double slip[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                           double slipd[restrict t->nwheel][MAGGI_SLIP_NUMBERS][MAGGI_NDIR],
                           double f[restrict t->nwheel][6],
                           double fd[restrict t->nwheel][6][MAGGI_NDIR],
                           double F[restrict t->nwheel][6],
                           double Fd[restrict t->nwheel][6][MAGGI_NDIR], int nbdirs)
{
  int i, k3, k5, k6, k8, k9, k9_2, nd, road;
  double L0, L1, L2, N0, N1, N2, T0, T1, T2, Z_i3, Z_i4, Z_i5, a, a2, a3, a4, a5, along0, along1,
      along2, ar, areq, arm0, arm1, arm2, at, ateq, axis0, axis1, axis2, ay, b0, b2, b30, b31, b4,
      base, base2, br, bt, c, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c2, c20, c21, c22,
      c23, c24, c25, c26, c27, c28, c29, c3, c30, c31, c32, c33, c34, c35, c36, c37, c38, c39, c4,
      c40, c41, c42, c43, c44, c45, c46, c47, c48, c49, c5, c50, c51, c6, c7, c8, c9, ca, dfz, dr,
      dt, dv, e, e10, e11, e2, e3, e4, e5, e6, e7, e8, e9, et, ex, ey, f2, f3, f_i0, f_i1, f_i2,
      f_i3, f_i4, f_i5, force2, force30, force31, force32, fx, fy, fz, fz0, fz0_2, fz0_2inv, fz0_3,
      fz0_4, fz0_4inv, fz0inv, fz2, g0, g20, g21, g22, g23, g24, g25, g26, g27, g28, g2_2, gamma,
      gx, gy, gz, h, h00, h0_2, h0_3, h10, h11, h12, h1_2, h1_3, h2, h2_2, h2_2inv, h2_3, h2_3inv,
      h2inv, h3, h3_2, h3_2inv, h3inv, hinv, inv, inv2, inv3, inv4, inv5, inv6, k4, k7, kappa, kx,
      mux, muy, n2, n2inv, normal0, normal1, normal2, omega, one0, one1, one2, one3, one4, p10, p2,
      p3, p4, p5, p6, p7, p8, p8inv, p9, p_road, p_road2, p_road3, p_road4, p_road5, p_road6,
      p_roadk5, p_roadk51, p_roadk8, p_roadk81, p_roadroad, p_roadroad2, peak, r0, r2, r30, r31,
      r32, radius, radius2, ratio, ratio2, re, re2, rhov, s, s20, s30, s31, s4, scale, side, sinv,
      slope, slope2, slope2_2, slope3, speed, speed2, speedinv, spline0_roadk50, spline0_roadk510,
      spline0_roadk80, spline0_roadk810, t10, t100, t101, t102, t102inv, t103, t104, t105, t106,
      t107, t108, t108inv, t109, t11, t110, t111, t112, t113, t114, t115, t115inv, t116, t117, t118,
      t119, t12, t120, t13, t14, t14inv, t15, t16, t16inv, t17, t18, t19, t2, t20, t21, t22, t23,
      t24, t24inv, t25, t26, t26inv, t27, t27inv, t28, t29, t3, t30, t31, t32, t33, t34, t34inv,
      t35, t36, t36inv, t37, t38, t39, t4, t40, t41, t42, t43, t44, t45, t46, t46inv, t47, t47inv,
      t48, t48inv, t49, t5, t50, t51, t51inv, t52, t53, t54, t54inv, t55, t56, t57, t57inv, t58,
      t59, t6, t60, t61, t62, t63, t63inv, t64, t65, t66, t67, t68, t69, t7, t70, t71, t72, t73,
      t74, t75, t76, t77, t78, t79, t79inv, t7inv, t8, t80, t81, t81inv, t82, t83, t84, t85, t86,
      t87, t88, t89, t9, t90, t91, t92, t93, t94, t95, t96, t97, t97inv, t98, t99, t9inv, u0, u1,
      u2, u2_2, u3, ua0, ua1, ua2, un0, un1, un2, v0, v1, v2, vr0, vr1, vr2, vx, w, w2, w3, way,
      way2, way3, winv, wr0, wr1, wr2, x, x2, x3, x4, x50, x51, x52, x53, x54, x55, x6, x7, x8, x9,
      y, y10, y11, y12, y13, y14, y15, y16, y17, y18, y19, y2, y20, y3, y40, y40inv, y41, y42, y43,
      y43inv, y44, y45, y5, y6, y7, y8, y9, z0, z1, z2, z2_2, z2_2inv, z2_3, z2inv, z3, z3_2, z3_3,
      z3_3inv, z3inv, z40, z5, z6, z7;
  double L0d[MAGGI_NDIR], L1d[MAGGI_NDIR], L2d[MAGGI_NDIR], N0d[MAGGI_NDIR], N2d[MAGGI_NDIR],
      T0d[MAGGI_NDIR], T1d[MAGGI_NDIR], T2d[MAGGI_NDIR], a5d[MAGGI_NDIR], areqd[MAGGI_NDIR],
      arm0d[MAGGI_NDIR], arm1d[MAGGI_NDIR], arm2d[MAGGI_NDIR], atd[MAGGI_NDIR], ateqd[MAGGI_NDIR],
      ayd[MAGGI_NDIR], b0d[MAGGI_NDIR], b30d[MAGGI_NDIR], b31d[MAGGI_NDIR], base2d[MAGGI_NDIR],
      based[MAGGI_NDIR], btd[MAGGI_NDIR], c2d[MAGGI_NDIR], c4d[MAGGI_NDIR], dfzd[MAGGI_NDIR],
      dtd[MAGGI_NDIR], e10d[MAGGI_NDIR], e11d[MAGGI_NDIR], e3d[MAGGI_NDIR], e4d[MAGGI_NDIR],
      e5d[MAGGI_NDIR], e6d[MAGGI_NDIR], e7d[MAGGI_NDIR], e8d[MAGGI_NDIR], e9d[MAGGI_NDIR],
      exd[MAGGI_NDIR], eyd[MAGGI_NDIR], f2d[MAGGI_NDIR], f3d[MAGGI_NDIR], fxd[MAGGI_NDIR],
      fyd[MAGGI_NDIR], fz0_2d[MAGGI_NDIR], fz0_3d[MAGGI_NDIR], fz0_4d[MAGGI_NDIR], fz0d[MAGGI_NDIR],
      fz2d[MAGGI_NDIR], fzd[MAGGI_NDIR], g0d[MAGGI_NDIR], g20d[MAGGI_NDIR], g21d[MAGGI_NDIR],
      g22d[MAGGI_NDIR], g23d[MAGGI_NDIR], g24d[MAGGI_NDIR], g25d[MAGGI_NDIR], g28d[MAGGI_NDIR],
      g2_2d[MAGGI_NDIR], gammad[MAGGI_NDIR], gyd[MAGGI_NDIR], gzd[MAGGI_NDIR], h00d[MAGGI_NDIR],
      h10d[MAGGI_NDIR], h11d[MAGGI_NDIR], h12d[MAGGI_NDIR], kappad[MAGGI_NDIR], kxd[MAGGI_NDIR],
      muxd[MAGGI_NDIR], muyd[MAGGI_NDIR], omegad[MAGGI_NDIR], one4d[MAGGI_NDIR], peakd[MAGGI_NDIR],
      r0d[MAGGI_NDIR], radius2d[MAGGI_NDIR], radiusd[MAGGI_NDIR], re2d[MAGGI_NDIR], red[MAGGI_NDIR],
      s20d[MAGGI_NDIR], s30d[MAGGI_NDIR], s31d[MAGGI_NDIR], scaled[MAGGI_NDIR], t121d[MAGGI_NDIR],
      u0d[MAGGI_NDIR], u1d[MAGGI_NDIR], u2_2d[MAGGI_NDIR], v0d[MAGGI_NDIR], v1d[MAGGI_NDIR],
      v2d[MAGGI_NDIR], vxd[MAGGI_NDIR], x2d[MAGGI_NDIR], x3d[MAGGI_NDIR], x4d[MAGGI_NDIR],
      x50d[MAGGI_NDIR], x51d[MAGGI_NDIR], x52d[MAGGI_NDIR], x53d[MAGGI_NDIR], x54d[MAGGI_NDIR],
      x55d[MAGGI_NDIR], xd[MAGGI_NDIR], y10d[MAGGI_NDIR], y11d[MAGGI_NDIR], y18d[MAGGI_NDIR],
      y19d[MAGGI_NDIR], y2d[MAGGI_NDIR], y3d[MAGGI_NDIR], y40d[MAGGI_NDIR], y41d[MAGGI_NDIR],
      y42d[MAGGI_NDIR], y43d[MAGGI_NDIR], y44d[MAGGI_NDIR], y45d[MAGGI_NDIR], y5d[MAGGI_NDIR],
      y6d[MAGGI_NDIR], y7d[MAGGI_NDIR], y8d[MAGGI_NDIR], y9d[MAGGI_NDIR], yd[MAGGI_NDIR],
      z0d[MAGGI_NDIR], z1d[MAGGI_NDIR], z2_2d[MAGGI_NDIR], z5d[MAGGI_NDIR];

  (void)nbdirs;
  for (i = 0; i < t->nwheel; ++i) {
    /* the unit axis u of wheel i, and where it meets its road */
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
    c6 = 1.0 / (2.0 * n2);
    u0 = ua0 / n2;
    n2inv = 1.0 / n2;
    u1 = ua1 / n2;
    u2_2 = ua2 / n2;
    g0 = r[t->wheelpoint[i]][0] - r[t->roadpoint[road]][0];
    g2_2 = r[t->wheelpoint[i]][2] - r[t->roadpoint[road]][2];
    x2 = g0;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double axis0d, axis1d, axis2d, n2d, t2d, ua0d, ua1d, ua2d;

      axis0d = pd[t->wheelaxis[i]][nd];
      axis1d = pd[t->wheelaxis[i] + 1][nd];
      axis2d = pd[t->wheelaxis[i] + 2][nd];
      ua0d = Ad[t->wheelbody[i]][0][nd] * axis0 + A[t->wheelbody[i]][0] * axis0d +
          (Ad[t->wheelbody[i]][1][nd] * axis1 + A[t->wheelbody[i]][1] * axis1d) +
          (Ad[t->wheelbody[i]][2][nd] * axis2 + A[t->wheelbody[i]][2] * axis2d);
      ua1d = Ad[t->wheelbody[i]][3][nd] * axis0 + A[t->wheelbody[i]][3] * axis0d +
          (Ad[t->wheelbody[i]][4][nd] * axis1 + A[t->wheelbody[i]][4] * axis1d) +
          (Ad[t->wheelbody[i]][5][nd] * axis2 + A[t->wheelbody[i]][5] * axis2d);
      ua2d = Ad[t->wheelbody[i]][6][nd] * axis0 + A[t->wheelbody[i]][6] * axis0d +
          (Ad[t->wheelbody[i]][7][nd] * axis1 + A[t->wheelbody[i]][7] * axis1d) +
          (Ad[t->wheelbody[i]][8][nd] * axis2 + A[t->wheelbody[i]][8] * axis2d);
      t2d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
      n2d = c6 * t2d;
      u0d[nd] = (ua0d - u0 * n2d) * n2inv;
      u1d[nd] = (ua1d - u1 * n2d) * n2inv;
      u2_2d[nd] = (ua2d - u2_2 * n2d) * n2inv;
      g0d[nd] = rd[t->wheelpoint[i]][0][nd] - rd[t->roadpoint[road]][0][nd];
      g2_2d[nd] = rd[t->wheelpoint[i]][2][nd] - rd[t->roadpoint[road]][2][nd];
      /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
       * the centre down the disc meets it, n its normal; then down the disc to that plane,
       *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
       * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n|, slope that the plane lacks */
      x2d[nd] = g0d[nd];
    }
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      h00 = p_road * x2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_roadd;

        p_roadd = pd[t->roadadr[road]][nd];
        h00d[nd] = p_roadd * x2 + p_road * x2d[nd];
      }
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k4 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      inv = 1.0 / p[t->roadadr[road] + 1];
      t3 = k4 * x2;
      t4 = sin(t3);
      c7 = cos(t3);
      p_road2 = p[t->roadadr[road]];
      h00 = p_road2 * t4;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double k4d, p_road2d, t3d, t4d;

        k4d = -(k4 * pd[t->roadadr[road] + 1][nd] * inv);
        t3d = k4d * x2 + k4 * x2d[nd];
        t4d = c7 * t3d;
        p_road2d = pd[t->roadadr[road]][nd];
        h00d[nd] = p_road2d * t4 + p_road2 * t4d;
      }
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k3 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x2);
      x3 = x2 - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k3 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius = p[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      c2 = sqrt(t5);
      c8 = 1.0 / (2.0 * c2);
      f2 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t5d;

        x3d[nd] = x2d[nd] - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST][nd] - k3 * pd[t->roadadr[road]
            + MAGGI_BUMPS_SPACING][nd];
        /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
         * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
         *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
        radiusd[nd] = pd[t->roadadr[road]][nd];
        based[nd] = radiusd[nd] - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT][nd];
        t5d = radiusd[nd] * radius + radius * radiusd[nd] - (based[nd] * base + base * based[nd]);
        c2d[nd] = c8 * t5d;
        f2d[nd] = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET][nd];
      }
      if (MAGGI_RE(x3) > 0.0) {
        way = 1.0;
      } else {
        way = -1.0;
      }
      y = way * x3;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        yd[nd] = way * x3d[nd];
      }
      if (MAGGI_RE(y) >= MAGGI_RE(c2 + f2)) {
        b0 = 0.0;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          b0d[nd] = 0.0;
        }
      } else if (MAGGI_RE(y) > MAGGI_RE(c2 - f2)) {
        t6 = radius * radius - (c2 - f2) * (c2 - f2);
        z2 = sqrt(t6);
        c9 = 1.0 / (2.0 * z2);
        h0_2 = z2 - base;
        h1_2 = 2.0 * f2 * (c2 - f2) / z2;
        z2inv = 1.0 / z2;
        a = 3.0 * h0_2 - h1_2;
        t7 = z2 * z2 * z2;
        t8 = 2.0 * f2 * f2 * radius * radius / t7;
        t7inv = 1.0 / t7;
        b2 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        t9 = 2.0 * f2;
        u2 = (c2 + f2 - y) / t9;
        t9inv = 1.0 / t9;
        w2 = 1.0 - u2;
        b0 = u2 * u2 * u2 * (h0_2 + w2 * (a + w2 * b2));
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double ad, b2d, h0_2d, h1_2d, t6d, t7d, t8d, t9d, u2d, w2d, z2d;

          t6d = radiusd[nd] * radius + radius * radiusd[nd] - ((c2d[nd] - f2d[nd]) * (c2 - f2) + (c2
              - f2) * (c2d[nd] - f2d[nd]));
          z2d = c9 * t6d;
          h0_2d = z2d - based[nd];
          h1_2d = (2.0 * f2d[nd] * (c2 - f2) + 2.0 * f2 * (c2d[nd] - f2d[nd]) - h1_2 * z2d) * z2inv;
          ad = 3.0 * h0_2d - h1_2d;
          t7d = (z2d * z2 + z2 * z2d) * z2 + z2 * z2 * z2d;
          t8d = (((2.0 * f2d[nd] * f2 + 2.0 * f2 * f2d[nd]) * radius + 2.0 * f2 * f2 * radiusd[nd])
              * radius + 2.0 * f2 * f2 * radius * radiusd[nd] - t8 * t7d) * t7inv;
          b2d = 6.0 * h0_2d - 3.0 * h1_2d - t8d;
          t9d = 2.0 * f2d[nd];
          u2d = (c2d[nd] + f2d[nd] - yd[nd] - u2 * t9d) * t9inv;
          w2d = -u2d;
          b0d[nd] = ((u2d * u2 + u2 * u2d) * u2 + u2 * u2 * u2d) * (h0_2 + w2 * (a + w2 * b2)) + u2
              * u2 * u2 * (h0_2d + (w2d * (a + w2 * b2) + w2 * (ad + (w2d * b2 + w2 * b2d))));
        }
      } else {
        t10 = radius * radius - y * y;
        z2_3 = sqrt(t10);
        c10 = 1.0 / (2.0 * z2_3);
        b0 = z2_3 - base;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t10d, z2_3d;

          t10d = radiusd[nd] * radius + radius * radiusd[nd] - (yd[nd] * y + y * yd[nd]);
          z2_3d = c10 * t10d;
          b0d[nd] = z2_3d - based[nd];
        }
      }
      h00 = b0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        h00d[nd] = b0d[nd];
      }
    } else {
      k5 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x2);
      if (k5 < 0) {
        p_road3 = p[t->roadadr[road]];
        h = p[t->roadadr[road] + 1] - p_road3;
        p_roadroad = p[t->roadadr[road] + t->roadn[road]];
        t11 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad) / h;
        hinv = 1.0 / h;
        slope = t11 - h / 6.0 * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road]
            + 1][0]);
        s20 = p_roadroad + slope * (x2 - p_road3);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double hd, p_road3d, p_roadroadd, sloped, t11d;

          p_road3d = pd[t->roadadr[road]][nd];
          hd = pd[t->roadadr[road] + 1][nd] - p_road3d;
          p_roadroadd = pd[t->roadadr[road] + t->roadn[road]][nd];
          t11d = (pd[t->roadadr[road] + t->roadn[road] + 1][nd] - p_roadroadd - t11 * hd) * hinv;
          sloped = t11d - (hd / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
              spline0[t->roadspline[road] + 1][0]) + h / 6.0 * (2.0 *
              spline0d[t->roadspline[road]][0][nd] + spline0d[t->roadspline[road] + 1][0][nd]));
          s20d[nd] = p_roadroadd + (sloped * (x2 - p_road3) + slope * (x2d[nd] - p_road3d));
        }
      } else if (k5 > t->roadn[road] - 2) {
        p2 = p[t->roadadr[road] + t->roadn[road] - 1];
        h3 = p2 - p[t->roadadr[road] + t->roadn[road] - 2];
        p3 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t12 = (p3 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h3;
        h3inv = 1.0 / h3;
        slope3 = t12 + h3 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        s20 = p3 + slope3 * (x2 - p2);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double h3d, p2d, p3d, slope3d, t12d;

          p2d = pd[t->roadadr[road] + t->roadn[road] - 1][nd];
          h3d = p2d - pd[t->roadadr[road] + t->roadn[road] - 2][nd];
          p3d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1][nd];
          t12d = (p3d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2][nd] - t12 * h3d)
              * h3inv;
          slope3d = t12d + (h3d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0
              * spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h3 / 6.0 *
              (spline0d[t->roadspline[road] + t->roadn[road] - 2][0][nd] + 2.0 *
              spline0d[t->roadspline[road] + t->roadn[road] - 1][0][nd]));
          s20d[nd] = p3d + (slope3d * (x2 - p2) + slope3 * (x2d[nd] - p2d));
        }
      } else {
        p_roadk51 = p[t->roadadr[road] + k5 + 1];
        p_roadk5 = p[t->roadadr[road] + k5];
        h3_2 = p_roadk51 - p_roadk5;
        a2 = p_roadk51 - x2;
        c3 = x2 - p_roadk5;
        p4 = p[t->roadadr[road] + t->roadn[road] + k5];
        t13 = (p[t->roadadr[road] + t->roadn[road] + k5 + 1] - p4) / h3_2;
        h3_2inv = 1.0 / h3_2;
        spline0_roadk510 = spline0[t->roadspline[road] + k5 + 1][0];
        spline0_roadk50 = spline0[t->roadspline[road] + k5][0];
        e = t13 - h3_2 / 6.0 * (spline0_roadk510 - spline0_roadk50);
        t14 = 6.0 * h3_2;
        t15 = (spline0_roadk50 * a2 * a2 * a2 + spline0_roadk510 * c3 * c3 * c3) / t14;
        t14inv = 1.0 / t14;
        s20 = t15 + p4 - spline0_roadk50 * h3_2 * h3_2 / 6.0 + e * c3;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double a2d, c3d, ed, h3_2d, p4d, p_roadk51d, p_roadk5d, spline0_roadk50d,
              spline0_roadk510d, t13d, t14d, t15d;

          p_roadk51d = pd[t->roadadr[road] + k5 + 1][nd];
          p_roadk5d = pd[t->roadadr[road] + k5][nd];
          h3_2d = p_roadk51d - p_roadk5d;
          a2d = p_roadk51d - x2d[nd];
          c3d = x2d[nd] - p_roadk5d;
          p4d = pd[t->roadadr[road] + t->roadn[road] + k5][nd];
          t13d = (pd[t->roadadr[road] + t->roadn[road] + k5 + 1][nd] - p4d - t13 * h3_2d) * h3_2inv;
          spline0_roadk510d = spline0d[t->roadspline[road] + k5 + 1][0][nd];
          spline0_roadk50d = spline0d[t->roadspline[road] + k5][0][nd];
          ed = t13d - (h3_2d / 6.0 * (spline0_roadk510 - spline0_roadk50) + h3_2 / 6.0 *
              (spline0_roadk510d - spline0_roadk50d));
          t14d = 6.0 * h3_2d;
          t15d = (((spline0_roadk50d * a2 + spline0_roadk50 * a2d) * a2 + spline0_roadk50 * a2 *
              a2d) * a2 + spline0_roadk50 * a2 * a2 * a2d + (((spline0_roadk510d * c3 +
              spline0_roadk510 * c3d) * c3 + spline0_roadk510 * c3 * c3d) * c3 + spline0_roadk510 *
              c3 * c3 * c3d) - t15 * t14d) * t14inv;
          s20d[nd] = t15d + p4d - ((spline0_roadk50d * h3_2 + spline0_roadk50 * h3_2d) * h3_2 +
              spline0_roadk50 * h3_2 * h3_2d) / 6.0 + (ed * c3 + e * c3d);
        }
      }
      h00 = s20;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        h00d[nd] = s20d[nd];
      }
    }
    t16 = u0 * u0 + u1 * u1;
    t17 = u2_2 * u0 / t16;
    t16inv = 1.0 / t16;
    x = g0 + t17 * (g2_2 - h00);
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double t16d, t17d;

      t16d = u0d[nd] * u0 + u0 * u0d[nd] + (u1d[nd] * u1 + u1 * u1d[nd]);
      t17d = (u2_2d[nd] * u0 + u2_2 * u0d[nd] - t17 * t16d) * t16inv;
      xd[nd] = g0d[nd] + (t17d * (g2_2 - h00) + t17 * (g2_2d[nd] - h00d[nd]));
    }
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road4 = p[t->roadadr[road]];
      h10 = p_road4 * x;
      h11 = p_road4;
      h12 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_road4d;

        p_road4d = pd[t->roadadr[road]][nd];
        h10d[nd] = p_road4d * x + p_road4 * xd[nd];
        h11d[nd] = p_road4d;
        h12d[nd] = 0.0;
      }
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k7 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      inv2 = 1.0 / p[t->roadadr[road] + 1];
      t18 = k7 * x;
      t19 = sin(t18);
      c11 = cos(t18);
      p_road5 = p[t->roadadr[road]];
      h10 = p_road5 * t19;
      t20 = k7 * x;
      t21 = cos(t20);
      c12 = -sin(t20);
      h11 = k7 * p_road5 * t21;
      h12 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double k7d, p_road5d, t18d, t19d, t20d, t21d;

        k7d = -(k7 * pd[t->roadadr[road] + 1][nd] * inv2);
        t18d = k7d * x + k7 * xd[nd];
        t19d = c11 * t18d;
        p_road5d = pd[t->roadadr[road]][nd];
        h10d[nd] = p_road5d * t19 + p_road5 * t19d;
        t20d = k7d * x + k7 * xd[nd];
        t21d = c12 * t20d;
        h11d[nd] = (k7d * p_road5 + k7 * p_road5d) * t21 + k7 * p_road5 * t21d;
        h12d[nd] = 0.0;
      }
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k6 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x);
      x4 = x - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k6 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius2 = p[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      c4 = sqrt(t22);
      c13 = 1.0 / (2.0 * c4);
      f3 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t22d;

        x4d[nd] = xd[nd] - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST][nd] - k6 * pd[t->roadadr[road] +
            MAGGI_BUMPS_SPACING][nd];
        /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
         * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
         *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
        radius2d[nd] = pd[t->roadadr[road]][nd];
        base2d[nd] = radius2d[nd] - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT][nd];
        t22d = radius2d[nd] * radius2 + radius2 * radius2d[nd] - (base2d[nd] * base2 + base2 *
            base2d[nd]);
        c4d[nd] = c13 * t22d;
        f3d[nd] = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET][nd];
      }
      if (MAGGI_RE(x4) > 0.0) {
        way2 = 1.0;
      } else {
        way2 = -1.0;
      }
      y2 = way2 * x4;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y2d[nd] = way2 * x4d[nd];
      }
      if (MAGGI_RE(y2) >= MAGGI_RE(c4 + f3)) {
        b30 = 0.0;
        b31 = 0.0;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          b30d[nd] = 0.0;
          b31d[nd] = 0.0;
        }
      } else if (MAGGI_RE(y2) > MAGGI_RE(c4 - f3)) {
        t23 = radius2 * radius2 - (c4 - f3) * (c4 - f3);
        z3 = sqrt(t23);
        c14 = 1.0 / (2.0 * z3);
        h0_3 = z3 - base2;
        h1_3 = 2.0 * f3 * (c4 - f3) / z3;
        z3inv = 1.0 / z3;
        a3 = 3.0 * h0_3 - h1_3;
        t24 = z3 * z3 * z3;
        t25 = 2.0 * f3 * f3 * radius2 * radius2 / t24;
        t24inv = 1.0 / t24;
        b4 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        t26 = 2.0 * f3;
        u3 = (c4 + f3 - y2) / t26;
        t26inv = 1.0 / t26;
        w3 = 1.0 - u3;
        b30 = u3 * u3 * u3 * (h0_3 + w3 * (a3 + w3 * b4));
        t27 = 2.0 * f3;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3 * (a3 + 2.0 * w3 * b4)) /
            t27;
        t27inv = 1.0 / t27;
        b31 = t28;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double a3d, b4d, h0_3d, h1_3d, t23d, t24d, t25d, t26d, t27d, t28d, u3d, w3d, z3d;

          t23d = radius2d[nd] * radius2 + radius2 * radius2d[nd] - ((c4d[nd] - f3d[nd]) * (c4 - f3)
              + (c4 - f3) * (c4d[nd] - f3d[nd]));
          z3d = c14 * t23d;
          h0_3d = z3d - base2d[nd];
          h1_3d = (2.0 * f3d[nd] * (c4 - f3) + 2.0 * f3 * (c4d[nd] - f3d[nd]) - h1_3 * z3d) * z3inv;
          a3d = 3.0 * h0_3d - h1_3d;
          t24d = (z3d * z3 + z3 * z3d) * z3 + z3 * z3 * z3d;
          t25d = (((2.0 * f3d[nd] * f3 + 2.0 * f3 * f3d[nd]) * radius2 + 2.0 * f3 * f3 *
              radius2d[nd]) * radius2 + 2.0 * f3 * f3 * radius2 * radius2d[nd] - t25 * t24d) *
              t24inv;
          b4d = 6.0 * h0_3d - 3.0 * h1_3d - t25d;
          t26d = 2.0 * f3d[nd];
          u3d = (c4d[nd] + f3d[nd] - y2d[nd] - u3 * t26d) * t26inv;
          w3d = -u3d;
          b30d[nd] = ((u3d * u3 + u3 * u3d) * u3 + u3 * u3 * u3d) * (h0_3 + w3 * (a3 + w3 * b4)) +
              u3 * u3 * u3 * (h0_3d + (w3d * (a3 + w3 * b4) + w3 * (a3d + (w3d * b4 + w3 * b4d))));
          t27d = 2.0 * f3d[nd];
          t28d = ((-(way2 * u3d * u3) + -way2 * u3 * u3d) * (3.0 * (h0_3 + w3 * (a3 + w3 * b4)) - u3
              * (a3 + 2.0 * w3 * b4)) + -way2 * u3 * u3 * (3.0 * (h0_3d + (w3d * (a3 + w3 * b4) + w3
              * (a3d + (w3d * b4 + w3 * b4d)))) - (u3d * (a3 + 2.0 * w3 * b4) + u3 * (a3d + (2.0 *
              w3d * b4 + 2.0 * w3 * b4d)))) - t28 * t27d) * t27inv;
          b31d[nd] = t28d;
        }
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        z3_3 = sqrt(t29);
        c15 = 1.0 / (2.0 * z3_3);
        b30 = z3_3 - base2;
        t30 = -x4 / z3_3;
        z3_3inv = 1.0 / z3_3;
        b31 = t30;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t29d, t30d, z3_3d;

          t29d = radius2d[nd] * radius2 + radius2 * radius2d[nd] - (y2d[nd] * y2 + y2 * y2d[nd]);
          z3_3d = c15 * t29d;
          b30d[nd] = z3_3d - base2d[nd];
          t30d = (-x4d[nd] - t30 * z3_3d) * z3_3inv;
          b31d[nd] = t30d;
        }
      }
      h10 = b30;
      h11 = 0.0;
      h12 = b31;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        h10d[nd] = b30d[nd];
        h11d[nd] = 0.0;
        h12d[nd] = b31d[nd];
      }
    } else {
      k8 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x);
      if (k8 < 0) {
        p_road6 = p[t->roadadr[road]];
        h2 = p[t->roadadr[road] + 1] - p_road6;
        p_roadroad2 = p[t->roadadr[road] + t->roadn[road]];
        t31 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2) / h2;
        h2inv = 1.0 / h2;
        slope2 = t31 - h2 / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]);
        s30 = p_roadroad2 + slope2 * (x - p_road6);
        s31 = slope2;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double h2d, p_road6d, p_roadroad2d, slope2d, t31d;

          p_road6d = pd[t->roadadr[road]][nd];
          h2d = pd[t->roadadr[road] + 1][nd] - p_road6d;
          p_roadroad2d = pd[t->roadadr[road] + t->roadn[road]][nd];
          t31d = (pd[t->roadadr[road] + t->roadn[road] + 1][nd] - p_roadroad2d - t31 * h2d) * h2inv;
          slope2d = t31d - (h2d / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
              spline0[t->roadspline[road] + 1][0]) + h2 / 6.0 * (2.0 *
              spline0d[t->roadspline[road]][0][nd] + spline0d[t->roadspline[road] + 1][0][nd]));
          s30d[nd] = p_roadroad2d + (slope2d * (x - p_road6) + slope2 * (xd[nd] - p_road6d));
          s31d[nd] = slope2d;
        }
      } else if (k8 > t->roadn[road] - 2) {
        p5 = p[t->roadadr[road] + t->roadn[road] - 1];
        h2_2 = p5 - p[t->roadadr[road] + t->roadn[road] - 2];
        p6 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t32 = (p6 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h2_2;
        h2_2inv = 1.0 / h2_2;
        slope2_2 = t32 + h2_2 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        s30 = p6 + slope2_2 * (x - p5);
        s31 = slope2_2;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double h2_2d, p5d, p6d, slope2_2d, t32d;

          p5d = pd[t->roadadr[road] + t->roadn[road] - 1][nd];
          h2_2d = p5d - pd[t->roadadr[road] + t->roadn[road] - 2][nd];
          p6d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1][nd];
          t32d = (p6d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2][nd] - t32 *
              h2_2d) * h2_2inv;
          slope2_2d = t32d + (h2_2d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] +
              2.0 * spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h2_2 / 6.0 *
              (spline0d[t->roadspline[road] + t->roadn[road] - 2][0][nd] + 2.0 *
              spline0d[t->roadspline[road] + t->roadn[road] - 1][0][nd]));
          s30d[nd] = p6d + (slope2_2d * (x - p5) + slope2_2 * (xd[nd] - p5d));
          s31d[nd] = slope2_2d;
        }
      } else {
        p_roadk81 = p[t->roadadr[road] + k8 + 1];
        p_roadk8 = p[t->roadadr[road] + k8];
        h2_3 = p_roadk81 - p_roadk8;
        a4 = p_roadk81 - x;
        c5 = x - p_roadk8;
        p7 = p[t->roadadr[road] + t->roadn[road] + k8];
        t33 = (p[t->roadadr[road] + t->roadn[road] + k8 + 1] - p7) / h2_3;
        h2_3inv = 1.0 / h2_3;
        spline0_roadk810 = spline0[t->roadspline[road] + k8 + 1][0];
        spline0_roadk80 = spline0[t->roadspline[road] + k8][0];
        e2 = t33 - h2_3 / 6.0 * (spline0_roadk810 - spline0_roadk80);
        t34 = 6.0 * h2_3;
        t35 = (spline0_roadk80 * a4 * a4 * a4 + spline0_roadk810 * c5 * c5 * c5) / t34;
        t34inv = 1.0 / t34;
        s30 = t35 + p7 - spline0_roadk80 * h2_3 * h2_3 / 6.0 + e2 * c5;
        t36 = 2.0 * h2_3;
        t37 = (spline0_roadk810 * c5 * c5 - spline0_roadk80 * a4 * a4) / t36;
        t36inv = 1.0 / t36;
        s31 = t37 + e2;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double a4d, c5d, e2d, h2_3d, p7d, p_roadk81d, p_roadk8d, spline0_roadk80d,
              spline0_roadk810d, t33d, t34d, t35d, t36d, t37d;

          p_roadk81d = pd[t->roadadr[road] + k8 + 1][nd];
          p_roadk8d = pd[t->roadadr[road] + k8][nd];
          h2_3d = p_roadk81d - p_roadk8d;
          a4d = p_roadk81d - xd[nd];
          c5d = xd[nd] - p_roadk8d;
          p7d = pd[t->roadadr[road] + t->roadn[road] + k8][nd];
          t33d = (pd[t->roadadr[road] + t->roadn[road] + k8 + 1][nd] - p7d - t33 * h2_3d) * h2_3inv;
          spline0_roadk810d = spline0d[t->roadspline[road] + k8 + 1][0][nd];
          spline0_roadk80d = spline0d[t->roadspline[road] + k8][0][nd];
          e2d = t33d - (h2_3d / 6.0 * (spline0_roadk810 - spline0_roadk80) + h2_3 / 6.0 *
              (spline0_roadk810d - spline0_roadk80d));
          t34d = 6.0 * h2_3d;
          t35d = (((spline0_roadk80d * a4 + spline0_roadk80 * a4d) * a4 + spline0_roadk80 * a4 *
              a4d) * a4 + spline0_roadk80 * a4 * a4 * a4d + (((spline0_roadk810d * c5 +
              spline0_roadk810 * c5d) * c5 + spline0_roadk810 * c5 * c5d) * c5 + spline0_roadk810 *
              c5 * c5 * c5d) - t35 * t34d) * t34inv;
          s30d[nd] = t35d + p7d - ((spline0_roadk80d * h2_3 + spline0_roadk80 * h2_3d) * h2_3 +
              spline0_roadk80 * h2_3 * h2_3d) / 6.0 + (e2d * c5 + e2 * c5d);
          t36d = 2.0 * h2_3d;
          t37d = ((spline0_roadk810d * c5 + spline0_roadk810 * c5d) * c5 + spline0_roadk810 * c5 *
              c5d - ((spline0_roadk80d * a4 + spline0_roadk80 * a4d) * a4 + spline0_roadk80 * a4 *
              a4d) - t37 * t36d) * t36inv;
          s31d[nd] = t37d + e2d;
        }
      }
      h10 = s30;
      h11 = s31;
      h12 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        h10d[nd] = s30d[nd];
        h11d[nd] = s31d[nd];
        h12d[nd] = 0.0;
      }
    }
    t38 = 1.0 + h11 * h11;
    s = sqrt(t38);
    c16 = 1.0 / (2.0 * s);
    normal0 = -h11 / s;
    sinv = 1.0 / s;
    normal1 = 0.0;
    normal2 = 1.0 / s;
    c = u0 * normal0 + u1 * normal1 + u2_2 * normal2;
    un0 = u1 * normal2 - u2_2 * normal1;
    un1 = u2_2 * normal0 - u0 * normal2;
    un2 = u0 * normal1 - u1 * normal0;
    t39 = un0 * un0 + un1 * un1 + un2 * un2;
    w = sqrt(t39);
    c17 = 1.0 / (2.0 * w);
    r2 = ((g0 - x) * normal0 + (g2_2 - h10) * normal2) / w;
    winv = 1.0 / w;
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
    z2_2inv = 1.0 / z2_2;
    fz = slip[i][MAGGI_SLIP_FZ];
    fz0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double Z_i3d, Z_i4d, Z_i5d, along0d, along1d, along2d, cd, normal0d, normal2d, r2d, rhovd, sd,
          t38d, t39d, un0d, un1d, un2d, vr0d, vr1d, vr2d, wd, wr0d, wr1d, wr2d, z3_2d;

      t38d = h11d[nd] * h11 + h11 * h11d[nd];
      sd = c16 * t38d;
      normal0d = (-h11d[nd] - normal0 * sd) * sinv;
      normal2d = -(normal2 * sd * sinv);
      cd = u0d[nd] * normal0 + u0 * normal0d + u1d[nd] * normal1 + (u2_2d[nd] * normal2 + u2_2 *
          normal2d);
      un0d = u1d[nd] * normal2 + u1 * normal2d - u2_2d[nd] * normal1;
      un1d = u2_2d[nd] * normal0 + u2_2 * normal0d - (u0d[nd] * normal2 + u0 * normal2d);
      un2d = u0d[nd] * normal1 - (u1d[nd] * normal0 + u1 * normal0d);
      t39d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
      wd = c17 * t39d;
      r2d = ((g0d[nd] - xd[nd]) * normal0 + (g0 - x) * normal0d + ((g2_2d[nd] - h10d[nd]) * normal2
          + (g2_2 - h10) * normal2d) - r2 * wd) * winv;
      along0d = (un0d - along0 * wd) * winv;
      along1d = (un1d - along1 * wd) * winv;
      along2d = (un2d - along2 * wd) * winv;
      L0d[nd] = normal1 * along2d - (normal2d * along1 + normal2 * along1d);
      L1d[nd] = normal2d * along0 + normal2 * along0d - (normal0d * along2 + normal0 * along2d);
      L2d[nd] = normal0d * along1 + normal0 * along1d - normal1 * along0d;
      arm0d[nd] = (r2d * (c * u0 - normal0) + r2 * (cd * u0 + c * u0d[nd] - normal0d) - arm0 * wd) *
          winv;
      T0d[nd] = along0d;
      N0d[nd] = normal0d;
      arm1d[nd] = (r2d * (c * u1 - normal1) + r2 * (cd * u1 + c * u1d[nd]) - arm1 * wd) * winv;
      T1d[nd] = along1d;
      arm2d[nd] = (r2d * (c * u2_2 - normal2) + r2 * (cd * u2_2 + c * u2_2d[nd] - normal2d) - arm2 *
          wd) * winv;
      T2d[nd] = along2d;
      N2d[nd] = normal2d;
      z0d[nd] = r2d;
      z1d[nd] = cd;
      z2_2d[nd] = wd;
      z3_2d = h12d[nd];
      Z_i3d = Zd[t->wheelbody[i]][3][nd];
      Z_i4d = Zd[t->wheelbody[i]][4][nd];
      Z_i5d = Zd[t->wheelbody[i]][5][nd];
      /* Slip and forces of a wheel.  V is the velocity of the place on the road below the wheel, which the turn of
       * neither wheel nor carrier about the axis moves:
       *   Omega = w.u,  V = v_C + (w - Omega u) × r e,  rho = R0 - r,  rho' = -V.n / |u × n|
       *   Fz = Cz rho + Cd rho'
       *   kappa = -(V.t - Omega Re) / |V.t|,  tan(alpha) = V.l / |V.t|,  sin(gamma) = u.n
       * No force without contact; without grip that of the spring alone, as at rest. */
      omegad[nd] = Z_i3d * u0 + Z_i3 * u0d[nd] + (Z_i4d * u1 + Z_i4 * u1d[nd]) + (Z_i5d * u2_2 +
          Z_i5 * u2_2d[nd]);
      wr0d = Z_i3d - (omegad[nd] * u0 + omega * u0d[nd]);
      wr1d = Z_i4d - (omegad[nd] * u1 + omega * u1d[nd]);
      wr2d = Z_i5d - (omegad[nd] * u2_2 + omega * u2_2d[nd]);
      vr0d = wr1d * arm2 + wr1 * arm2d[nd] - (wr2d * arm1 + wr2 * arm1d[nd]);
      vr1d = wr2d * arm0 + wr2 * arm0d[nd] - (wr0d * arm2 + wr0 * arm2d[nd]);
      vr2d = wr0d * arm1 + wr0 * arm1d[nd] - (wr1d * arm0 + wr1 * arm0d[nd]);
      v0d[nd] = rvd[t->wheelpoint[i]][0][nd] + vr0d;
      v1d[nd] = rvd[t->wheelpoint[i]][1][nd] + vr1d;
      v2d[nd] = rvd[t->wheelpoint[i]][2][nd] + vr2d;
      vxd[nd] = v0d[nd] * T0 + v0 * T0d[nd] + (v1d[nd] * T1 + v1 * T1d[nd]) + (v2d[nd] * T2 + v2 *
          T2d[nd]);
      rhovd = (z3_2d * v0 + z3_2 * v0d[nd] - (v0d[nd] * N0 + v0 * N0d[nd] + v1d[nd] * N1 + (v2d[nd]
          * N2 + v2 * N2d[nd])) - rhov * z2_2d[nd]) * z2_2inv;
      fzd[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS][nd] *
          (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - z0) +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS] *
          (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS][nd] - z0d[nd]) +
          (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING][nd] * rhov +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
      /* Re = R0 - rho0 (D atan(B rd) + F rd),  rd = Fz / Fz0,  rho0 = Fz0 / Cz;  R0 in the air */
      fz0d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO][nd] *
          p[t->tyreadr[t->wheeltyre[i]]] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] *
          pd[t->tyreadr[t->wheeltyre[i]]][nd];
    }
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      fz0inv = 1.0 / fz0;
      t40 = fz0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      inv3 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t41 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio;
      t42 = atan(t41);
      c18 = 1.0 / (1.0 + t41 * t41);
      re2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - t40 *
          (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t42 + p[t->tyreadr[t->wheeltyre[i]] +
          MAGGI_TYRE_FREFF] * ratio);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double ratiod, t40d, t41d, t42d;

        ratiod = (fzd[nd] - ratio * fz0d[nd]) * fz0inv;
        t40d = (fz0d[nd] - t40 * pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_VERTICAL_STIFFNESS][nd]) * inv3;
        t41d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF][nd] * ratio +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratiod;
        t42d = c18 * t41d;
        re2d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS][nd] - (t40d *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t42 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_FREFF] * ratio) + t40 * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_DREFF][nd] * t42 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t42d +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF][nd] * ratio +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratiod)));
      }
    } else {
      re2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        re2d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS][nd];
      }
    }
    re = re2;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      red[nd] = re2d[nd];
    }
    /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
    if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y3 = vx;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y3d[nd] = vxd[nd];
      }
    } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y3 = -vx;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y3d[nd] = -vxd[nd];
      }
    } else {
      p8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      t43 = vx * vx / p8;
      p8inv = 1.0 / p8;
      y3 = 0.5 * (p8 + t43);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p8d, t43d;

        p8d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW][nd];
        t43d = (vxd[nd] * vx + vx * vxd[nd] - t43 * p8d) * p8inv;
        y3d[nd] = 0.5 * (p8d + t43d);
      }
    }
    speed = y3;
    speedinv = 1.0 / speed;
    c19 = z2_2 / (z2_2 * z2_2 + z1 * z1);
    c20 = -(z1 / (z2_2 * z2_2 + z1 * z1));
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double speedd;

      speedd = y3d[nd];
      slipd[i][MAGGI_SLIP_KAPPA][nd] = (omegad[nd] * re + omega * red[nd] - vxd[nd] -
          slip[i][MAGGI_SLIP_KAPPA] * speedd) * speedinv;
      slipd[i][MAGGI_SLIP_TAN_ALPHA][nd] = (v0d[nd] * L0 + v0 * L0d[nd] + (v1d[nd] * L1 + v1 *
          L1d[nd]) + (v2d[nd] * L2 + v2 * L2d[nd]) - slip[i][MAGGI_SLIP_TAN_ALPHA] * speedd) *
          speedinv;
      slipd[i][MAGGI_SLIP_GAMMA][nd] = c19 * z1d[nd] + c20 * z2_2d[nd];
      slipd[i][MAGGI_SLIP_FZ][nd] = fzd[nd];
      slipd[i][MAGGI_SLIP_VX][nd] = vxd[nd];
      slipd[i][MAGGI_SLIP_RADIUS][nd] = z0d[nd];
      slipd[i][MAGGI_SLIP_ROLLING][nd] = red[nd];
    }
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
        fz0_2inv = 1.0 / fz0_2;
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
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double gxd, one0d, one1d, one2d, one3d;

          /* the formula on either side; f: Fx Fy Fz, Mx My Mz */
          one0d = slipd[i][MAGGI_SLIP_KAPPA][nd];
          one1d = side * slipd[i][MAGGI_SLIP_TAN_ALPHA][nd];
          one2d = side * slipd[i][MAGGI_SLIP_GAMMA][nd];
          one3d = slipd[i][MAGGI_SLIP_FZ][nd];
          one4d[nd] = slipd[i][MAGGI_SLIP_VX][nd];
          kappad[nd] = one0d;
          a5d[nd] = one1d;
          gammad[nd] = one2d;
          fz2d[nd] = one3d;
          fz0_2d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO][nd] *
              p[t->tyreadr[t->wheeltyre[i]]] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[i]]][nd];
          r0d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS][nd];
          dfzd[nd] = (fz2d[nd] - fz0_2d[nd] - dfz * fz0_2d[nd]) * fz0_2inv;
          kxd[nd] = kappad[nd] + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX][nd]);
          gxd = gammad[nd] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] + gamma *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX][nd];
          muxd[nd] = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfzd[nd])) * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) -
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3][nd] * gx
              + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gxd) * gx +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gxd)) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX][nd];
          e3d[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1][nd] +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfzd[nd])) * dfz +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEX3] * dfz) * dfzd[nd])) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX]
              + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz) * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX][nd];
        }
        if (MAGGI_RE(kx) > 0.0) {
          e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            e4d[nd] = e3d[nd] * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) - e3 *
                pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4][nd];
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e4) > 1.0) {
            y5 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y5d[nd] = 0.0;
            }
          } else {
            y5 = e4;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y5d[nd] = e4d[nd];
            }
          }
          ex = y5;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            exd[nd] = y5d[nd];
          }
        } else {
          e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            e5d[nd] = e3d[nd] * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) + e3 *
                pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4][nd];
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e5) > 1.0) {
            y6 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y6d[nd] = 0.0;
            }
          } else {
            y6 = e5;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y6d[nd] = e5d[nd];
            }
          }
          ex = y6;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            exd[nd] = y6d[nd];
          }
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
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t44d, t45d;

          x50d[nd] = muxd[nd] * fz2 + mux * fz2d[nd];
          x51d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1][nd] *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PCX1] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX][nd];
          x52d[nd] = exd[nd];
          t44d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfzd[nd];
          t45d = t45 * t44d;
          x53d[nd] = ((fz2d[nd] * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfzd[nd]))) * t45 + fz2 *
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PKX2] * dfz) * t45d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] +
              fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t45 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX][nd];
          x54d[nd] = kxd[nd];
          x55d[nd] = ((fz2d[nd] * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd[nd]))) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX][nd]) * p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_LMUX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] * pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_LMUX][nd];
          /* sin(2 atan(z)) = 2 z / (1 + z^2) */
          fz0_3d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO][nd] *
              p[t->tyreadr[t->wheeltyre[i]]] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[i]]][nd];
          gyd[nd] = gammad[nd] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] + gamma *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY][nd];
          ayd[nd] = a5d[nd] + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY][nd]) +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3][nd] * gy +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gyd[nd]);
          muyd[nd] = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfzd[nd])) * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) -
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3][nd] * gy
              + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gyd[nd]) * gy +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gyd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY][nd];
          e6d[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY][nd];
        }
        if (MAGGI_RE(ay) > 0.0) {
          e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            e7d[nd] = e6d[nd] * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) - e6 *
                (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3][nd] +
                (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4][nd] * gy +
                p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd[nd]));
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e7) > 1.0) {
            y7 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y7d[nd] = 0.0;
            }
          } else {
            y7 = e7;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y7d[nd] = e7d[nd];
            }
          }
          ey = y7;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            eyd[nd] = y7d[nd];
          }
        } else {
          e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            e8d[nd] = e6d[nd] * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) + e6 *
                (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3][nd] +
                (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4][nd] * gy +
                p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd[nd]));
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e8) > 1.0) {
            y8 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y8d[nd] = 0.0;
            }
          } else {
            y8 = e8;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y8d[nd] = e8d[nd];
            }
          }
          ey = y8;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            eyd[nd] = y8d[nd];
          }
        }
        t46 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3;
        z5 = fz2 / t46;
        t46inv = 1.0 / t46;
        y40 = muy * fz2;
        y41 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        y42 = ey;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t46d;

          t46d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2][nd] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3d[nd];
          z5d[nd] = (fz2d[nd] - z5 * t46d) * t46inv;
          y40d[nd] = muyd[nd] * fz2 + muy * fz2d[nd];
          y41d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1][nd] *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PCY1] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY][nd];
          y42d[nd] = eyd[nd];
        }
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y9 = gy;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y9d[nd] = gyd[nd];
          }
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y9 = -gy;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y9d[nd] = -gyd[nd];
          }
        } else {
          p9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t47 = p9 * p9;
          z6 = gy * gy / t47;
          t47inv = 1.0 / t47;
          y9 = 0.125 * p9 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double p9d, t47d, z6d;

            p9d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER][nd];
            t47d = p9d * p9 + p9 * p9d;
            z6d = (gyd[nd] * gy + gy * gyd[nd] - z6 * t47d) * t47inv;
            y9d[nd] = (0.125 * p9d * z6 + 0.125 * p9 * z6d) * (15.0 + z6 * (-10.0 + 3.0 * z6)) +
                0.125 * p9 * z6 * (z6d * (-10.0 + 3.0 * z6) + z6 * (3.0 * z6d));
          }
        }
        t48 = 1.0 + z5 * z5;
        t49 = 2.0 * z5 / t48;
        t48inv = 1.0 / t48;
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
        c21 = 1.0 / (2.0 * t51);
        t52 = 1.0 / t51;
        t51inv = 1.0 / t51;
        g20 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t52 * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LXAL];
        g21 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        e9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t48d, t49d, t50d, t51d, t52d, x6d;

          t48d = z5d[nd] * z5 + z5 * z5d[nd];
          t49d = (2.0 * z5d[nd] - t49 * t48d) * t48inv;
          y43d[nd] = (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1][nd] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d[nd]) * t49 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t49d) * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9) - p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_PKY1] * fz0_3 * t49 * (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PKY3][nd] * y9 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] *
              y9d[nd])) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t49 * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y9) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY][nd];
          y44d[nd] = ayd[nd];
          y45d[nd] = (fz2d[nd] * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) + fz2
              * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY][nd] +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfzd[nd])) * gy +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PVY4] * dfz) * gyd[nd]))) * p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_LMUY] + fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY][nd];
          peakd[nd] = y40d[nd];
          /* what combined slip makes of the forces:  Fx = Gxa Fx0, Fy = Gyk Fy0 + SVyk.  g: b, c, e, shift of Gxa,
           * then of Gyk, SVyk */
          x6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2][nd] * kappa +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappad[nd];
          t50d = x6d * x6 + x6 * x6d;
          t51d = c21 * t50d;
          t52d = -(t52 * t51d * t51inv);
          g20d[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1][nd] * t52 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t52d) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_RBX1] * t52 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL][nd];
          g21d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1][nd];
          e9d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] * dfzd[nd]);
        }
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e9) > 1.0) {
          y10 = 1.0;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y10d[nd] = 0.0;
          }
        } else {
          y10 = e9;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y10d[nd] = e9d[nd];
          }
        }
        g22 = y10;
        g23 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        x7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a5 - p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBY3]);
        t53 = 1.0 + x7 * x7;
        t54 = sqrt(t53);
        c22 = 1.0 / (2.0 * t54);
        t55 = 1.0 / t54;
        t54inv = 1.0 / t54;
        g24 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t55 * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LYKA];
        g25 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        e10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t53d, t54d, t55d, x7d;

          g22d[nd] = y10d[nd];
          g23d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1][nd];
          x7d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2][nd] * (a5 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_RBY2] * (a5d[nd] - pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3][nd]);
          t53d = x7d * x7 + x7 * x7d;
          t54d = c22 * t53d;
          t55d = -(t55 * t54d * t54inv);
          g24d[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1][nd] * t55 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t55d) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_RBY1] * t55 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA][nd];
          g25d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1][nd];
          e10d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] * dfzd[nd]);
        }
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e10) > 1.0) {
          y11 = 1.0;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y11d[nd] = 0.0;
          }
        } else {
          y11 = e10;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y11d[nd] = e10d[nd];
          }
        }
        g26 = y11;
        g27 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz;
        x8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a5;
        t56 = 1.0 + x8 * x8;
        t57 = sqrt(t56);
        c23 = 1.0 / (2.0 * t57);
        t58 = 1.0 / t57;
        t57inv = 1.0 / t57;
        dv = peak * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma) * t58;
        t59 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa;
        t60 = atan(t59);
        c24 = 1.0 / (1.0 + t59 * t59);
        t61 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t60;
        t62 = sin(t61);
        c25 = cos(t61);
        g28 = dv * t62 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        t63 = x51 * x50;
        t64 = x53 / t63;
        t63inv = 1.0 / t63;
        y12 = t64 * x54;
        y13 = g20 * (a5 + g23);
        y14 = g20 * g23;
        t65 = atan(y12);
        c26 = 1.0 / (1.0 + y12 * y12);
        t66 = (1.0 - x52) * y12 + x52 * t65;
        t67 = atan(t66);
        c27 = 1.0 / (1.0 + t66 * t66);
        t68 = x51 * t67;
        t69 = sin(t68);
        c28 = cos(t68);
        t70 = atan(y13);
        c29 = 1.0 / (1.0 + y13 * y13);
        t71 = (1.0 - g22) * y13 + g22 * t70;
        t72 = atan(t71);
        c30 = 1.0 / (1.0 + t71 * t71);
        t73 = g21 * t72;
        t74 = cos(t73);
        c31 = -sin(t73);
        t75 = atan(y14);
        c32 = 1.0 / (1.0 + y14 * y14);
        t76 = (1.0 - g22) * y14 + g22 * t75;
        t77 = atan(t76);
        c33 = 1.0 / (1.0 + t76 * t76);
        t78 = g21 * t77;
        t79 = cos(t78);
        c34 = -sin(t78);
        t80 = t74 / t79;
        t79inv = 1.0 / t79;
        fx = (x50 * t69 + x55) * t80;
        t81 = y41 * y40;
        t82 = y43 / t81;
        t81inv = 1.0 / t81;
        y15 = t82 * y44;
        y16 = g24 * (kappa + g27);
        y17 = g24 * g27;
        t83 = atan(y15);
        c35 = 1.0 / (1.0 + y15 * y15);
        t84 = (1.0 - y42) * y15 + y42 * t83;
        t85 = atan(t84);
        c36 = 1.0 / (1.0 + t84 * t84);
        t86 = y41 * t85;
        t87 = sin(t86);
        c37 = cos(t86);
        t88 = atan(y16);
        c38 = 1.0 / (1.0 + y16 * y16);
        t89 = (1.0 - g26) * y16 + g26 * t88;
        t90 = atan(t89);
        c39 = 1.0 / (1.0 + t89 * t89);
        t91 = g25 * t90;
        t92 = cos(t91);
        c40 = -sin(t91);
        t93 = atan(y17);
        c41 = 1.0 / (1.0 + y17 * y17);
        t94 = (1.0 - g26) * y17 + g26 * t93;
        t95 = atan(t94);
        c42 = 1.0 / (1.0 + t94 * t94);
        t96 = g25 * t95;
        t97 = cos(t96);
        c43 = -sin(t96);
        t98 = t92 / t97;
        t97inv = 1.0 / t97;
        fy = (y40 * t87 + y45) * t98;
        ratio2 = x53 * kappa / y43;
        y43inv = 1.0 / y43;
        fz0_4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        gz = gamma * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        at = a5 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QHZ2] * dfz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gz;
        t99 = y45 / y43;
        ar = y44 + t99;
        t100 = at * at + ratio2 * ratio2 + 1e-24;
        ateq = sqrt(t100);
        c44 = 1.0 / (2.0 * ateq);
        t101 = ar * ar + ratio2 * ratio2 + 1e-24;
        areq = sqrt(t101);
        c45 = 1.0 / (2.0 * areq);
        scale = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LMUY];
        inv4 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double ard, dvd, g26d, g27d, ratio2d, t100d, t101d, t56d, t57d, t58d, t59d, t60d, t61d,
              t62d, t63d, t64d, t65d, t66d, t67d, t68d, t69d, t70d, t71d, t72d, t73d, t74d, t75d,
              t76d, t77d, t78d, t79d, t80d, t81d, t82d, t83d, t84d, t85d, t86d, t87d, t88d, t89d,
              t90d, t91d, t92d, t93d, t94d, t95d, t96d, t97d, t98d, t99d, x8d, y12d, y13d, y14d,
              y15d, y16d, y17d;

          g26d = y11d[nd];
          g27d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] * dfzd[nd]);
          x8d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4][nd] * a5 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a5d[nd];
          t56d = x8d * x8 + x8 * x8d;
          t57d = c23 * t56d;
          t58d = -(t58 * t57d * t57inv);
          dvd = (peakd[nd] * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_RVY3] * gamma) + peak * (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_RVY1][nd] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfzd[nd]) +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3][nd] * gamma +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gammad[nd]))) * t58 + peak *
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma) *
              t58d;
          t59d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6][nd] * kappa +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappad[nd];
          t60d = c24 * t59d;
          t61d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5][nd] * t60 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t60d;
          t62d = c25 * t61d;
          g28d[nd] = (dvd * t62 + dv * t62d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] +
              dv * t62 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA][nd];
          t63d = x51d[nd] * x50 + x51 * x50d[nd];
          t64d = (x53d[nd] - t64 * t63d) * t63inv;
          y12d = t64d * x54 + t64 * x54d[nd];
          y13d = g20d[nd] * (a5 + g23) + g20 * (a5d[nd] + g23d[nd]);
          y14d = g20d[nd] * g23 + g20 * g23d[nd];
          t65d = c26 * y12d;
          t66d = -(x52d[nd] * y12) + (1.0 - x52) * y12d + (x52d[nd] * t65 + x52 * t65d);
          t67d = c27 * t66d;
          t68d = x51d[nd] * t67 + x51 * t67d;
          t69d = c28 * t68d;
          t70d = c29 * y13d;
          t71d = -(g22d[nd] * y13) + (1.0 - g22) * y13d + (g22d[nd] * t70 + g22 * t70d);
          t72d = c30 * t71d;
          t73d = g21d[nd] * t72 + g21 * t72d;
          t74d = c31 * t73d;
          t75d = c32 * y14d;
          t76d = -(g22d[nd] * y14) + (1.0 - g22) * y14d + (g22d[nd] * t75 + g22 * t75d);
          t77d = c33 * t76d;
          t78d = g21d[nd] * t77 + g21 * t77d;
          t79d = c34 * t78d;
          t80d = (t74d - t80 * t79d) * t79inv;
          fxd[nd] = (x50d[nd] * t69 + x50 * t69d + x55d[nd]) * t80 + (x50 * t69 + x55) * t80d;
          t81d = y41d[nd] * y40 + y41 * y40d[nd];
          t82d = (y43d[nd] - t82 * t81d) * t81inv;
          y15d = t82d * y44 + t82 * y44d[nd];
          y16d = g24d[nd] * (kappa + g27) + g24 * (kappad[nd] + g27d);
          y17d = g24d[nd] * g27 + g24 * g27d;
          t83d = c35 * y15d;
          t84d = -(y42d[nd] * y15) + (1.0 - y42) * y15d + (y42d[nd] * t83 + y42 * t83d);
          t85d = c36 * t84d;
          t86d = y41d[nd] * t85 + y41 * t85d;
          t87d = c37 * t86d;
          t88d = c38 * y16d;
          t89d = -(g26d * y16) + (1.0 - g26) * y16d + (g26d * t88 + g26 * t88d);
          t90d = c39 * t89d;
          t91d = g25d[nd] * t90 + g25 * t90d;
          t92d = c40 * t91d;
          t93d = c41 * y17d;
          t94d = -(g26d * y17) + (1.0 - g26) * y17d + (g26d * t93 + g26 * t93d);
          t95d = c42 * t94d;
          t96d = g25d[nd] * t95 + g25 * t95d;
          t97d = c43 * t96d;
          t98d = (t92d - t98 * t97d) * t97inv;
          fyd[nd] = (y40d[nd] * t87 + y40 * t87d + y45d[nd]) * t98 + (y40 * t87 + y45) * t98d;
          ratio2d = (x53d[nd] * kappa + x53 * kappad[nd] - ratio2 * y43d[nd]) * y43inv;
          /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
           *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
          fz0_4d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO][nd] *
              p[t->tyreadr[t->wheeltyre[i]]] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[i]]][nd];
          gzd[nd] = gammad[nd] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] + gamma *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ][nd];
          atd[nd] = a5d[nd] + pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] * dfzd[nd]) +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfzd[nd])) * gz +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QHZ4] * dfz) * gzd[nd]);
          t99d = (y45d[nd] - t99 * y43d[nd]) * y43inv;
          ard = y44d[nd] + t99d;
          t100d = atd[nd] * at + at * atd[nd] + (ratio2d * ratio2 + ratio2 * ratio2d);
          ateqd[nd] = c44 * t100d;
          t101d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
          areqd[nd] = c45 * t101d;
          scaled[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY][nd] - scale *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY][nd]) * inv4;
        }
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y18 = gz;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y18d[nd] = gzd[nd];
          }
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y18 = -gz;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y18d[nd] = -gzd[nd];
          }
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t102 = p10 * p10;
          z7 = gz * gz / t102;
          t102inv = 1.0 / t102;
          y18 = 0.125 * p10 * z7 * (15.0 + z7 * (-10.0 + 3.0 * z7));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double p10d, t102d, z7d;

            p10d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER][nd];
            t102d = p10d * p10 + p10 * p10d;
            z7d = (gzd[nd] * gz + gz * gzd[nd] - z7 * t102d) * t102inv;
            y18d[nd] = (0.125 * p10d * z7 + 0.125 * p10 * z7d) * (15.0 + z7 * (-10.0 + 3.0 * z7)) +
                0.125 * p10 * z7 * (z7d * (-10.0 + 3.0 * z7) + z7 * (3.0 * z7d));
          }
        }
        bt = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz) * dfz) * (1.0
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ5] * y18) * scale;
        t103 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
        fz0_4inv = 1.0 / fz0_4;
        dt = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz) * gz) * t103 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        t104 = bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * at;
        t105 = atan(t104);
        c46 = 1.0 / (1.0 + t104 * t104);
        e11 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz) * dfz) * (1.0
            + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t105);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t103d, t104d, t105d;

          btd[nd] = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1][nd] +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfzd[nd])) * dfz +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QBZ3] * dfz) * dfzd[nd])) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18) +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz) * dfz) *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4][nd] * gz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gzd[nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5][nd] * y18 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18d[nd]))) * scale +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QBZ2] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz) * dfz) *
              (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y18) * scaled[nd];
          t103d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS][nd] - t103 *
              fz0_4d[nd]) * fz0_4inv;
          dtd[nd] = (((fz2d[nd] * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfzd[nd]))) * (1.0 +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ4] * gz) * gz) + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1]
              + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) *
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4][nd] * gz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gzd[nd])) * gz +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ4] * gz) * gzd[nd])) * t103 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ4] * gz) * gz) * t103d) * p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_LTR] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ4] * gz) * gz) * t103 * pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_LTR][nd];
          t104d = (btd[nd] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + bt *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1][nd]) * at + bt *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * atd[nd];
          t105d = c46 * t104d;
          e11d[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1][nd] +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfzd[nd])) * dfz +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QEZ3] * dfz) * dfzd[nd])) * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) *
              0.63661977236758134308 * t105) + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QEZ3] * dfz) * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QEZ4][nd] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5][nd] * gz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gzd[nd])) * 0.63661977236758134308
              * t105 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t105d);
        }
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e11) > 1.0) {
          y19 = 1.0;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y19d[nd] = 0.0;
          }
        } else {
          y19 = e11;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y19d[nd] = e11d[nd];
          }
        }
        et = y19;
        t106 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * y43 / y40;
        y40inv = 1.0 / y40;
        br = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * scale + t106;
        dr = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t107 = 1.0 + a5 * a5;
        t108 = sqrt(t107);
        c47 = 1.0 / (2.0 * t108);
        ca = 1.0 / t108;
        t108inv = 1.0 / t108;
        y20 = bt * ateq;
        t109 = atan(y20);
        c48 = 1.0 / (1.0 + y20 * y20);
        t110 = (1.0 - et) * y20 + et * t109;
        t111 = atan(t110);
        c49 = 1.0 / (1.0 + t110 * t110);
        t112 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t111;
        t113 = cos(t112);
        c50 = -sin(t112);
        z40 = dt * t113 * ca;
        x9 = br * areq;
        t114 = 1.0 + x9 * x9;
        t115 = sqrt(t114);
        c51 = 1.0 / (2.0 * t115);
        t116 = 1.0 / t115;
        t115inv = 1.0 / t115;
        force2 = fy + g28;
        t117 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * force2 / fz0_2;
        s4 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t117 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        t118 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        inv5 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        way3 = tanh(t118);
        speed2 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        inv6 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        t119 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * force2 / fz0_2;
        t120 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double brd, cad, drd, etd, force0d, force1d, force2_2d, force2d, force3_2d, force4d,
              force5d, s4d, speed2d, t106d, t107d, t108d, t109d, t110d, t111d, t112d, t113d, t114d,
              t115d, t116d, t117d, t118d, t119d, t120d, way3d, x9d, y20d, z40d, z41d;

          etd = y19d[nd];
          t106d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10][nd] * y43 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * y43d[nd] - t106 * y40d[nd]) *
              y40inv;
          brd = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9][nd] * scale +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * scaled[nd] + t106d;
          drd = ((fz2d[nd] * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) + fz2
              * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES][nd] +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfzd[nd])) * gz +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ9] * dfz) * gzd[nd]))) * p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_UNLOADED_RADIUS] + fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6]
              + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS][nd]) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + fz2 *
              ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_UNLOADED_RADIUS] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY][nd];
          t107d = a5d[nd] * a5 + a5 * a5d[nd];
          t108d = c47 * t107d;
          cad = -(ca * t108d * t108inv);
          y20d = btd[nd] * ateq + bt * ateqd[nd];
          t109d = c48 * y20d;
          t110d = -(etd * y20) + (1.0 - et) * y20d + (etd * t109 + et * t109d);
          t111d = c49 * t110d;
          t112d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1][nd] * t111 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t111d;
          t113d = c50 * t112d;
          z40d = (dtd[nd] * t113 + dt * t113d) * ca + dt * t113 * cad;
          x9d = brd * areq + br * areqd[nd];
          t114d = x9d * x9 + x9 * x9d;
          t115d = c51 * t114d;
          t116d = -(t116 * t115d * t115inv);
          z41d = (drd * t116 + dr * t116d) * ca + dr * t116 * cad;
          force2d = fyd[nd] + g28d[nd];
          t117d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2][nd] * force2 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * force2d - t117 * fz0_2d[nd]) *
              fz0_2inv;
          s4d = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1][nd] + t117d +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfzd[nd])) * gamma +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_SSZ4] * dfz) * gammad[nd])) * r0 + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_SSZ1] + t117 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0d[nd]) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_SSZ1] + t117 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma) * r0 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS][nd];
          t118d = (one4d[nd] - t118 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED][nd]) *
              inv5;
          way3d = (1.0 - way3 * way3) * t118d;
          speed2d = (one4d[nd] - speed2 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL][nd]) *
              inv6;
          force0d = fxd[nd];
          force1d = force2d;
          force2_2d = fz2d[nd];
          t119d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3][nd] * force2 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * force2d - t119 * fz0_2d[nd]) *
              fz0_2inv;
          force3_2d = (r0d[nd] * fz2 + r0 * fz2d[nd]) * (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QSX1] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] +
              (-p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma + t119) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]) + r0 * fz2 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1][nd] * p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX][nd] +
              ((-(pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2][nd] * gamma) -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gammad[nd] + t119d) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QSX2] * gamma + t119) * pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_LMX][nd]));
          t120d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2][nd] * fx +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fxd[nd] - t120 * fz0_2d[nd]) *
              fz0_2inv;
          force4d = (((-(way3d * r0) - way3 * r0d[nd]) * fz2 + -way3 * r0 * fz2d[nd]) *
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 * speed2 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2 * speed2)
              + -way3 * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1][nd] + t120d +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3][nd] * way3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3d) * speed2 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 * speed2d) +
              ((((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4][nd] * speed2 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2d) * speed2 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2d) * speed2 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2d) * speed2
              + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2 *
              speed2d))) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] + -way3 * r0 * fz2 *
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t120 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way3 * speed2 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed2 * speed2 * speed2 * speed2)
              * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY][nd];
          force5d = -(z40d * fy) - z40 * fyd[nd] + z41d + (s4d * fx + s4 * fxd[nd]);
          fd[i][0][nd] = force0d;
          fd[i][1][nd] = side * force1d;
          fd[i][2][nd] = force2_2d;
          fd[i][3][nd] = side * force3_2d;
          fd[i][4][nd] = force4d;
          fd[i][5][nd] = side * force5d;
        }
      } else {
        for (k9 = 0; k9 < 6; ++k9) {
          if (k9 == 2) {
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              t121d[nd] = fzd[nd];
            }
          } else {
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              t121d[nd] = 0.0;
            }
          }
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            fd[i][k9][nd] = t121d[nd];
          }
        }
      }
    } else {
      for (k9_2 = 0; k9_2 < 6; ++k9_2) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          fd[i][k9_2][nd] = 0.0;
        }
      }
    }
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
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double f_i0d, f_i1d, f_i2d, f_i3d, f_i4d, f_i5d, force30d, force31d, force32d, moment0d,
          moment1d, moment2d, r30d, r31d, r32d;

      /* F: force f_x T + f_y L + f_z N at the contact point, with its moment, as one about P */
      r30d = rd[t->wheelpoint[i]][0][nd] + arm0d[nd];
      f_i0d = fd[i][0][nd];
      f_i1d = fd[i][1][nd];
      f_i2d = fd[i][2][nd];
      force30d = f_i0d * T0 + f_i0 * T0d[nd] + (f_i1d * L0 + f_i1 * L0d[nd]) + (f_i2d * N0 + f_i2 *
          N0d[nd]);
      r31d = rd[t->wheelpoint[i]][1][nd] + arm1d[nd];
      force31d = f_i0d * T1 + f_i0 * T1d[nd] + (f_i1d * L1 + f_i1 * L1d[nd]) + f_i2d * N1;
      r32d = rd[t->wheelpoint[i]][2][nd] + arm2d[nd];
      force32d = f_i0d * T2 + f_i0 * T2d[nd] + (f_i1d * L2 + f_i1 * L2d[nd]) + (f_i2d * N2 + f_i2 *
          N2d[nd]);
      moment0d = r31d * force32 + r31 * force32d - (r32d * force31 + r32 * force31d);
      moment1d = r32d * force30 + r32 * force30d - (r30d * force32 + r30 * force32d);
      moment2d = r30d * force31 + r30 * force31d - (r31d * force30 + r31 * force30d);
      Fd[i][0][nd] = force30d;
      f_i3d = fd[i][3][nd];
      f_i4d = fd[i][4][nd];
      f_i5d = fd[i][5][nd];
      Fd[i][3][nd] = moment0d + (f_i3d * T0 + f_i3 * T0d[nd]) + (f_i4d * L0 + f_i4 * L0d[nd]) +
          (f_i5d * N0 + f_i5 * N0d[nd]);
      Fd[i][1][nd] = force31d;
      Fd[i][4][nd] = moment1d + (f_i3d * T1 + f_i3 * T1d[nd]) + (f_i4d * L1 + f_i4 * L1d[nd]) +
          f_i5d * N1;
      Fd[i][2][nd] = force32d;
      Fd[i][5][nd] = moment2d + (f_i3d * T2 + f_i3 * T2d[nd]) + (f_i4d * L2 + f_i4 * L2d[nd]) +
          (f_i5d * N2 + f_i5 * N2d[nd]);
    }
  }
}

/* Rates of the coordinates on which wheels turn at which they roll freely, kappa = 0: with w that of the
 * carrier and w_q that of the wheel on it at the rate 1
 *   v = (V.t / Re - w.u) / (w_q.u) */
void maggi_rolling_dv(const maggi_topo *t, const double p[restrict t->np],
                      const double pd[restrict t->np][MAGGI_NDIR],
                      const double spline0[restrict t->nspline][3],
                      const double spline0d[restrict t->nspline][3][MAGGI_NDIR],
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
  int adr, body, carrier, i, k4, k6, k7, k9, nd, road;
  double N0, N1, N2, T0, T1, T2, a, a2, a3, a4, along0, along1, along2, arm0, arm1, arm2, axis0,
      axis1, axis2, b20, b3, b40, b41, b5, base, base2, c, c10, c11, c12, c13, c14, c15, c16, c17,
      c18, c2, c3, c4, c5, c6, c7, c8, c9, e, e2, f, f2, fz, fz0, fz0inv, g0, g2, h, h00, h0_2,
      h0_3, h10, h11, h12, h1_2, h1_3, h2, h2_2, h2_2inv, h2_3, h2_3inv, h2inv, h3, h3_2, h3_2inv,
      h3inv, hinv, inv, inv2, inv3, k5, k8, n2, n2inv, normal0, normal1, normal2, p2, p3, p4, p5,
      p6, p7, p_road, p_road2, p_road3, p_road4, p_road5, p_road6, p_roadk6, p_roadk61, p_roadk9,
      p_roadk91, p_roadroad, p_roadroad2, r2, r_i0, r_i1, r_i2, radius, radius2, ratio, re, re2,
      reinv, rhov, s, s20, s30, s31, sinv, slope, slope2, slope2_2, slope3, spline0_roadk60,
      spline0_roadk610, spline0_roadk90, spline0_roadk910, t10, t11, t12, t13, t14, t14inv, t15,
      t16, t16inv, t17, t18, t19, t2, t20, t21, t22, t23, t24, t24inv, t25, t26, t26inv, t27,
      t27inv, t28, t29, t3, t30, t31, t32, t33, t34, t34inv, t35, t36, t36inv, t37, t38, t39, t4,
      t40, t41, t42, t43, t44, t44inv, t5, t6, t7, t7inv, t8, t9, t9inv, turn, u0, u1, u2, u2_2, u3,
      ua0, ua1, ua2, un0, un1, un2, v0, v1, v2, vc0, vc1, vc2, vr0, vr1, vr2, w0, w1, w2, w2_2,
      w2inv, w3, w4, way, way2, wr0, wr1, wr2, x, x2, x3, x4, y, y2, z0, z2, z2_2, z2_2inv, z2_3,
      z2inv, z3, z3_2, z3_3, z3_3inv, z3inv;
  double T0d[MAGGI_NDIR], T1d[MAGGI_NDIR], T2d[MAGGI_NDIR], b20d[MAGGI_NDIR], b40d[MAGGI_NDIR],
      b41d[MAGGI_NDIR], base2d[MAGGI_NDIR], based[MAGGI_NDIR], c2d[MAGGI_NDIR], c4d[MAGGI_NDIR],
      f2d[MAGGI_NDIR], fd[MAGGI_NDIR], fz0d[MAGGI_NDIR], fzd[MAGGI_NDIR], g0d[MAGGI_NDIR],
      g2d[MAGGI_NDIR], h00d[MAGGI_NDIR], h10d[MAGGI_NDIR], h11d[MAGGI_NDIR], h12d[MAGGI_NDIR],
      radius2d[MAGGI_NDIR], radiusd[MAGGI_NDIR], re2d[MAGGI_NDIR], s20d[MAGGI_NDIR],
      s30d[MAGGI_NDIR], s31d[MAGGI_NDIR], turnd[MAGGI_NDIR], u0d[MAGGI_NDIR], u1d[MAGGI_NDIR],
      u2_2d[MAGGI_NDIR], v0d[MAGGI_NDIR], v1d[MAGGI_NDIR], v2d[MAGGI_NDIR], x2d[MAGGI_NDIR],
      x3d[MAGGI_NDIR], x4d[MAGGI_NDIR], xd[MAGGI_NDIR], y2d[MAGGI_NDIR], yd[MAGGI_NDIR];

  (void)nbdirs;
  for (i = 0; i < t->nwheel; ++i) {
    adr = t->tyreadr[t->wheeltyre[i]];
    body = t->wheelbody[i];
    carrier = t->wheelcarrier[i];
    /* the unit axis u of wheel i, and where it meets its road */
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
    c6 = 1.0 / (2.0 * n2);
    u0 = ua0 / n2;
    n2inv = 1.0 / n2;
    u1 = ua1 / n2;
    u2_2 = ua2 / n2;
    g0 = r[t->wheelpoint[i]][0] - r[t->roadpoint[road]][0];
    g2 = r[t->wheelpoint[i]][2] - r[t->roadpoint[road]][2];
    x2 = g0;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double axis0d, axis1d, axis2d, n2d, t2d, ua0d, ua1d, ua2d;

      axis0d = pd[t->wheelaxis[i]][nd];
      axis1d = pd[t->wheelaxis[i] + 1][nd];
      axis2d = pd[t->wheelaxis[i] + 2][nd];
      ua0d = Ad[t->wheelbody[i]][0][nd] * axis0 + A[t->wheelbody[i]][0] * axis0d +
          (Ad[t->wheelbody[i]][1][nd] * axis1 + A[t->wheelbody[i]][1] * axis1d) +
          (Ad[t->wheelbody[i]][2][nd] * axis2 + A[t->wheelbody[i]][2] * axis2d);
      ua1d = Ad[t->wheelbody[i]][3][nd] * axis0 + A[t->wheelbody[i]][3] * axis0d +
          (Ad[t->wheelbody[i]][4][nd] * axis1 + A[t->wheelbody[i]][4] * axis1d) +
          (Ad[t->wheelbody[i]][5][nd] * axis2 + A[t->wheelbody[i]][5] * axis2d);
      ua2d = Ad[t->wheelbody[i]][6][nd] * axis0 + A[t->wheelbody[i]][6] * axis0d +
          (Ad[t->wheelbody[i]][7][nd] * axis1 + A[t->wheelbody[i]][7] * axis1d) +
          (Ad[t->wheelbody[i]][8][nd] * axis2 + A[t->wheelbody[i]][8] * axis2d);
      t2d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
      n2d = c6 * t2d;
      u0d[nd] = (ua0d - u0 * n2d) * n2inv;
      u1d[nd] = (ua1d - u1 * n2d) * n2inv;
      u2_2d[nd] = (ua2d - u2_2 * n2d) * n2inv;
      g0d[nd] = rd[t->wheelpoint[i]][0][nd] - rd[t->roadpoint[road]][0][nd];
      g2d[nd] = rd[t->wheelpoint[i]][2][nd] - rd[t->roadpoint[road]][2][nd];
      /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
       * the centre down the disc meets it, n its normal; then down the disc to that plane,
       *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
       * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n|, slope that the plane lacks */
      x2d[nd] = g0d[nd];
    }
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road = p[t->roadadr[road]];
      h00 = p_road * x2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_roadd;

        p_roadd = pd[t->roadadr[road]][nd];
        h00d[nd] = p_roadd * x2 + p_road * x2d[nd];
      }
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k5 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      inv = 1.0 / p[t->roadadr[road] + 1];
      t3 = k5 * x2;
      t4 = sin(t3);
      c7 = cos(t3);
      p_road2 = p[t->roadadr[road]];
      h00 = p_road2 * t4;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double k5d, p_road2d, t3d, t4d;

        k5d = -(k5 * pd[t->roadadr[road] + 1][nd] * inv);
        t3d = k5d * x2 + k5 * x2d[nd];
        t4d = c7 * t3d;
        p_road2d = pd[t->roadadr[road]][nd];
        h00d[nd] = p_road2d * t4 + p_road2 * t4d;
      }
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k4 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x2);
      x3 = x2 - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k4 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius = p[t->roadadr[road]];
      base = radius - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t5 = radius * radius - base * base;
      c2 = sqrt(t5);
      c8 = 1.0 / (2.0 * c2);
      f = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t5d;

        x3d[nd] = x2d[nd] - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST][nd] - k4 * pd[t->roadadr[road]
            + MAGGI_BUMPS_SPACING][nd];
        /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
         * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
         *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
        radiusd[nd] = pd[t->roadadr[road]][nd];
        based[nd] = radiusd[nd] - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT][nd];
        t5d = radiusd[nd] * radius + radius * radiusd[nd] - (based[nd] * base + base * based[nd]);
        c2d[nd] = c8 * t5d;
        fd[nd] = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET][nd];
      }
      if (MAGGI_RE(x3) > 0.0) {
        way = 1.0;
      } else {
        way = -1.0;
      }
      y = way * x3;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        yd[nd] = way * x3d[nd];
      }
      if (MAGGI_RE(y) >= MAGGI_RE(c2 + f)) {
        b20 = 0.0;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          b20d[nd] = 0.0;
        }
      } else if (MAGGI_RE(y) > MAGGI_RE(c2 - f)) {
        t6 = radius * radius - (c2 - f) * (c2 - f);
        z2 = sqrt(t6);
        c9 = 1.0 / (2.0 * z2);
        h0_2 = z2 - base;
        h1_2 = 2.0 * f * (c2 - f) / z2;
        z2inv = 1.0 / z2;
        a = 3.0 * h0_2 - h1_2;
        t7 = z2 * z2 * z2;
        t8 = 2.0 * f * f * radius * radius / t7;
        t7inv = 1.0 / t7;
        b3 = 6.0 * h0_2 - 3.0 * h1_2 - t8;
        t9 = 2.0 * f;
        u2 = (c2 + f - y) / t9;
        t9inv = 1.0 / t9;
        w3 = 1.0 - u2;
        b20 = u2 * u2 * u2 * (h0_2 + w3 * (a + w3 * b3));
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double ad, b3d, h0_2d, h1_2d, t6d, t7d, t8d, t9d, u2d, w3d, z2d;

          t6d = radiusd[nd] * radius + radius * radiusd[nd] - ((c2d[nd] - fd[nd]) * (c2 - f) + (c2 -
              f) * (c2d[nd] - fd[nd]));
          z2d = c9 * t6d;
          h0_2d = z2d - based[nd];
          h1_2d = (2.0 * fd[nd] * (c2 - f) + 2.0 * f * (c2d[nd] - fd[nd]) - h1_2 * z2d) * z2inv;
          ad = 3.0 * h0_2d - h1_2d;
          t7d = (z2d * z2 + z2 * z2d) * z2 + z2 * z2 * z2d;
          t8d = (((2.0 * fd[nd] * f + 2.0 * f * fd[nd]) * radius + 2.0 * f * f * radiusd[nd]) *
              radius + 2.0 * f * f * radius * radiusd[nd] - t8 * t7d) * t7inv;
          b3d = 6.0 * h0_2d - 3.0 * h1_2d - t8d;
          t9d = 2.0 * fd[nd];
          u2d = (c2d[nd] + fd[nd] - yd[nd] - u2 * t9d) * t9inv;
          w3d = -u2d;
          b20d[nd] = ((u2d * u2 + u2 * u2d) * u2 + u2 * u2 * u2d) * (h0_2 + w3 * (a + w3 * b3)) + u2
              * u2 * u2 * (h0_2d + (w3d * (a + w3 * b3) + w3 * (ad + (w3d * b3 + w3 * b3d))));
        }
      } else {
        t10 = radius * radius - y * y;
        z2_3 = sqrt(t10);
        c10 = 1.0 / (2.0 * z2_3);
        b20 = z2_3 - base;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t10d, z2_3d;

          t10d = radiusd[nd] * radius + radius * radiusd[nd] - (yd[nd] * y + y * yd[nd]);
          z2_3d = c10 * t10d;
          b20d[nd] = z2_3d - based[nd];
        }
      }
      h00 = b20;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        h00d[nd] = b20d[nd];
      }
    } else {
      k6 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x2);
      if (k6 < 0) {
        p_road3 = p[t->roadadr[road]];
        h = p[t->roadadr[road] + 1] - p_road3;
        p_roadroad = p[t->roadadr[road] + t->roadn[road]];
        t11 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad) / h;
        hinv = 1.0 / h;
        slope = t11 - h / 6.0 * (2.0 * spline0[t->roadspline[road]][0] + spline0[t->roadspline[road]
            + 1][0]);
        s20 = p_roadroad + slope * (x2 - p_road3);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double hd, p_road3d, p_roadroadd, sloped, t11d;

          p_road3d = pd[t->roadadr[road]][nd];
          hd = pd[t->roadadr[road] + 1][nd] - p_road3d;
          p_roadroadd = pd[t->roadadr[road] + t->roadn[road]][nd];
          t11d = (pd[t->roadadr[road] + t->roadn[road] + 1][nd] - p_roadroadd - t11 * hd) * hinv;
          sloped = t11d - (hd / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
              spline0[t->roadspline[road] + 1][0]) + h / 6.0 * (2.0 *
              spline0d[t->roadspline[road]][0][nd] + spline0d[t->roadspline[road] + 1][0][nd]));
          s20d[nd] = p_roadroadd + (sloped * (x2 - p_road3) + slope * (x2d[nd] - p_road3d));
        }
      } else if (k6 > t->roadn[road] - 2) {
        p2 = p[t->roadadr[road] + t->roadn[road] - 1];
        h3 = p2 - p[t->roadadr[road] + t->roadn[road] - 2];
        p3 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t12 = (p3 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h3;
        h3inv = 1.0 / h3;
        slope3 = t12 + h3 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        s20 = p3 + slope3 * (x2 - p2);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double h3d, p2d, p3d, slope3d, t12d;

          p2d = pd[t->roadadr[road] + t->roadn[road] - 1][nd];
          h3d = p2d - pd[t->roadadr[road] + t->roadn[road] - 2][nd];
          p3d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1][nd];
          t12d = (p3d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2][nd] - t12 * h3d)
              * h3inv;
          slope3d = t12d + (h3d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0
              * spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h3 / 6.0 *
              (spline0d[t->roadspline[road] + t->roadn[road] - 2][0][nd] + 2.0 *
              spline0d[t->roadspline[road] + t->roadn[road] - 1][0][nd]));
          s20d[nd] = p3d + (slope3d * (x2 - p2) + slope3 * (x2d[nd] - p2d));
        }
      } else {
        p_roadk61 = p[t->roadadr[road] + k6 + 1];
        p_roadk6 = p[t->roadadr[road] + k6];
        h3_2 = p_roadk61 - p_roadk6;
        a2 = p_roadk61 - x2;
        c3 = x2 - p_roadk6;
        p4 = p[t->roadadr[road] + t->roadn[road] + k6];
        t13 = (p[t->roadadr[road] + t->roadn[road] + k6 + 1] - p4) / h3_2;
        h3_2inv = 1.0 / h3_2;
        spline0_roadk610 = spline0[t->roadspline[road] + k6 + 1][0];
        spline0_roadk60 = spline0[t->roadspline[road] + k6][0];
        e = t13 - h3_2 / 6.0 * (spline0_roadk610 - spline0_roadk60);
        t14 = 6.0 * h3_2;
        t15 = (spline0_roadk60 * a2 * a2 * a2 + spline0_roadk610 * c3 * c3 * c3) / t14;
        t14inv = 1.0 / t14;
        s20 = t15 + p4 - spline0_roadk60 * h3_2 * h3_2 / 6.0 + e * c3;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double a2d, c3d, ed, h3_2d, p4d, p_roadk61d, p_roadk6d, spline0_roadk60d,
              spline0_roadk610d, t13d, t14d, t15d;

          p_roadk61d = pd[t->roadadr[road] + k6 + 1][nd];
          p_roadk6d = pd[t->roadadr[road] + k6][nd];
          h3_2d = p_roadk61d - p_roadk6d;
          a2d = p_roadk61d - x2d[nd];
          c3d = x2d[nd] - p_roadk6d;
          p4d = pd[t->roadadr[road] + t->roadn[road] + k6][nd];
          t13d = (pd[t->roadadr[road] + t->roadn[road] + k6 + 1][nd] - p4d - t13 * h3_2d) * h3_2inv;
          spline0_roadk610d = spline0d[t->roadspline[road] + k6 + 1][0][nd];
          spline0_roadk60d = spline0d[t->roadspline[road] + k6][0][nd];
          ed = t13d - (h3_2d / 6.0 * (spline0_roadk610 - spline0_roadk60) + h3_2 / 6.0 *
              (spline0_roadk610d - spline0_roadk60d));
          t14d = 6.0 * h3_2d;
          t15d = (((spline0_roadk60d * a2 + spline0_roadk60 * a2d) * a2 + spline0_roadk60 * a2 *
              a2d) * a2 + spline0_roadk60 * a2 * a2 * a2d + (((spline0_roadk610d * c3 +
              spline0_roadk610 * c3d) * c3 + spline0_roadk610 * c3 * c3d) * c3 + spline0_roadk610 *
              c3 * c3 * c3d) - t15 * t14d) * t14inv;
          s20d[nd] = t15d + p4d - ((spline0_roadk60d * h3_2 + spline0_roadk60 * h3_2d) * h3_2 +
              spline0_roadk60 * h3_2 * h3_2d) / 6.0 + (ed * c3 + e * c3d);
        }
      }
      h00 = s20;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        h00d[nd] = s20d[nd];
      }
    }
    t16 = u0 * u0 + u1 * u1;
    t17 = u2_2 * u0 / t16;
    t16inv = 1.0 / t16;
    x = g0 + t17 * (g2 - h00);
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double t16d, t17d;

      t16d = u0d[nd] * u0 + u0 * u0d[nd] + (u1d[nd] * u1 + u1 * u1d[nd]);
      t17d = (u2_2d[nd] * u0 + u2_2 * u0d[nd] - t17 * t16d) * t16inv;
      xd[nd] = g0d[nd] + (t17d * (g2 - h00) + t17 * (g2d[nd] - h00d[nd]));
    }
    if (t->roadkind[road] == MAGGI_ROAD_FLAT) {
      p_road4 = p[t->roadadr[road]];
      h10 = p_road4 * x;
      h11 = p_road4;
      h12 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_road4d;

        p_road4d = pd[t->roadadr[road]][nd];
        h10d[nd] = p_road4d * x + p_road4 * xd[nd];
        h11d[nd] = p_road4d;
        h12d[nd] = 0.0;
      }
    } else if (t->roadkind[road] == MAGGI_ROAD_SINE) {
      k8 = 6.28318530717958647693 / p[t->roadadr[road] + 1];
      inv2 = 1.0 / p[t->roadadr[road] + 1];
      t18 = k8 * x;
      t19 = sin(t18);
      c11 = cos(t18);
      p_road5 = p[t->roadadr[road]];
      h10 = p_road5 * t19;
      t20 = k8 * x;
      t21 = cos(t20);
      c12 = -sin(t20);
      h11 = k8 * p_road5 * t21;
      h12 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double k8d, p_road5d, t18d, t19d, t20d, t21d;

        k8d = -(k8 * pd[t->roadadr[road] + 1][nd] * inv2);
        t18d = k8d * x + k8 * xd[nd];
        t19d = c11 * t18d;
        p_road5d = pd[t->roadadr[road]][nd];
        h10d[nd] = p_road5d * t19 + p_road5 * t19d;
        t20d = k8d * x + k8 * xd[nd];
        t21d = c12 * t20d;
        h11d[nd] = (k8d * p_road5 + k8 * p_road5d) * t21 + k8 * p_road5 * t21d;
        h12d[nd] = 0.0;
      }
    } else if (t->roadkind[road] == MAGGI_ROAD_BUMPS) {
      k7 = nearest_nodiff(t->np, p, t->roadadr[road], t->roadn[road], x);
      x4 = x - p[t->roadadr[road] + MAGGI_BUMPS_FIRST] - k7 * p[t->roadadr[road] +
          MAGGI_BUMPS_SPACING];
      radius2 = p[t->roadadr[road]];
      base2 = radius2 - p[t->roadadr[road] + MAGGI_BUMPS_HEIGHT];
      t22 = radius2 * radius2 - base2 * base2;
      c4 = sqrt(t22);
      c13 = 1.0 / (2.0 * c4);
      f2 = 0.5 * p[t->roadadr[road] + MAGGI_BUMPS_FILLET];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t22d;

        x4d[nd] = xd[nd] - pd[t->roadadr[road] + MAGGI_BUMPS_FIRST][nd] - k7 * pd[t->roadadr[road] +
            MAGGI_BUMPS_SPACING][nd];
        /* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
         * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
         *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
        radius2d[nd] = pd[t->roadadr[road]][nd];
        base2d[nd] = radius2d[nd] - pd[t->roadadr[road] + MAGGI_BUMPS_HEIGHT][nd];
        t22d = radius2d[nd] * radius2 + radius2 * radius2d[nd] - (base2d[nd] * base2 + base2 *
            base2d[nd]);
        c4d[nd] = c13 * t22d;
        f2d[nd] = 0.5 * pd[t->roadadr[road] + MAGGI_BUMPS_FILLET][nd];
      }
      if (MAGGI_RE(x4) > 0.0) {
        way2 = 1.0;
      } else {
        way2 = -1.0;
      }
      y2 = way2 * x4;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        y2d[nd] = way2 * x4d[nd];
      }
      if (MAGGI_RE(y2) >= MAGGI_RE(c4 + f2)) {
        b40 = 0.0;
        b41 = 0.0;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          b40d[nd] = 0.0;
          b41d[nd] = 0.0;
        }
      } else if (MAGGI_RE(y2) > MAGGI_RE(c4 - f2)) {
        t23 = radius2 * radius2 - (c4 - f2) * (c4 - f2);
        z3 = sqrt(t23);
        c14 = 1.0 / (2.0 * z3);
        h0_3 = z3 - base2;
        h1_3 = 2.0 * f2 * (c4 - f2) / z3;
        z3inv = 1.0 / z3;
        a3 = 3.0 * h0_3 - h1_3;
        t24 = z3 * z3 * z3;
        t25 = 2.0 * f2 * f2 * radius2 * radius2 / t24;
        t24inv = 1.0 / t24;
        b5 = 6.0 * h0_3 - 3.0 * h1_3 - t25;
        t26 = 2.0 * f2;
        u3 = (c4 + f2 - y2) / t26;
        t26inv = 1.0 / t26;
        w4 = 1.0 - u3;
        b40 = u3 * u3 * u3 * (h0_3 + w4 * (a3 + w4 * b5));
        t27 = 2.0 * f2;
        t28 = -way2 * u3 * u3 * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3 * (a3 + 2.0 * w4 * b5)) /
            t27;
        t27inv = 1.0 / t27;
        b41 = t28;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double a3d, b5d, h0_3d, h1_3d, t23d, t24d, t25d, t26d, t27d, t28d, u3d, w4d, z3d;

          t23d = radius2d[nd] * radius2 + radius2 * radius2d[nd] - ((c4d[nd] - f2d[nd]) * (c4 - f2)
              + (c4 - f2) * (c4d[nd] - f2d[nd]));
          z3d = c14 * t23d;
          h0_3d = z3d - base2d[nd];
          h1_3d = (2.0 * f2d[nd] * (c4 - f2) + 2.0 * f2 * (c4d[nd] - f2d[nd]) - h1_3 * z3d) * z3inv;
          a3d = 3.0 * h0_3d - h1_3d;
          t24d = (z3d * z3 + z3 * z3d) * z3 + z3 * z3 * z3d;
          t25d = (((2.0 * f2d[nd] * f2 + 2.0 * f2 * f2d[nd]) * radius2 + 2.0 * f2 * f2 *
              radius2d[nd]) * radius2 + 2.0 * f2 * f2 * radius2 * radius2d[nd] - t25 * t24d) *
              t24inv;
          b5d = 6.0 * h0_3d - 3.0 * h1_3d - t25d;
          t26d = 2.0 * f2d[nd];
          u3d = (c4d[nd] + f2d[nd] - y2d[nd] - u3 * t26d) * t26inv;
          w4d = -u3d;
          b40d[nd] = ((u3d * u3 + u3 * u3d) * u3 + u3 * u3 * u3d) * (h0_3 + w4 * (a3 + w4 * b5)) +
              u3 * u3 * u3 * (h0_3d + (w4d * (a3 + w4 * b5) + w4 * (a3d + (w4d * b5 + w4 * b5d))));
          t27d = 2.0 * f2d[nd];
          t28d = ((-(way2 * u3d * u3) + -way2 * u3 * u3d) * (3.0 * (h0_3 + w4 * (a3 + w4 * b5)) - u3
              * (a3 + 2.0 * w4 * b5)) + -way2 * u3 * u3 * (3.0 * (h0_3d + (w4d * (a3 + w4 * b5) + w4
              * (a3d + (w4d * b5 + w4 * b5d)))) - (u3d * (a3 + 2.0 * w4 * b5) + u3 * (a3d + (2.0 *
              w4d * b5 + 2.0 * w4 * b5d)))) - t28 * t27d) * t27inv;
          b41d[nd] = t28d;
        }
      } else {
        t29 = radius2 * radius2 - y2 * y2;
        z3_3 = sqrt(t29);
        c15 = 1.0 / (2.0 * z3_3);
        b40 = z3_3 - base2;
        t30 = -x4 / z3_3;
        z3_3inv = 1.0 / z3_3;
        b41 = t30;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t29d, t30d, z3_3d;

          t29d = radius2d[nd] * radius2 + radius2 * radius2d[nd] - (y2d[nd] * y2 + y2 * y2d[nd]);
          z3_3d = c15 * t29d;
          b40d[nd] = z3_3d - base2d[nd];
          t30d = (-x4d[nd] - t30 * z3_3d) * z3_3inv;
          b41d[nd] = t30d;
        }
      }
      h10 = b40;
      h11 = 0.0;
      h12 = b41;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        h10d[nd] = b40d[nd];
        h11d[nd] = 0.0;
        h12d[nd] = b41d[nd];
      }
    } else {
      k9 = maggi_piece(t->np, p, t->roadadr[road], t->roadn[road], x);
      if (k9 < 0) {
        p_road6 = p[t->roadadr[road]];
        h2 = p[t->roadadr[road] + 1] - p_road6;
        p_roadroad2 = p[t->roadadr[road] + t->roadn[road]];
        t31 = (p[t->roadadr[road] + t->roadn[road] + 1] - p_roadroad2) / h2;
        h2inv = 1.0 / h2;
        slope2 = t31 - h2 / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
            spline0[t->roadspline[road] + 1][0]);
        s30 = p_roadroad2 + slope2 * (x - p_road6);
        s31 = slope2;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double h2d, p_road6d, p_roadroad2d, slope2d, t31d;

          p_road6d = pd[t->roadadr[road]][nd];
          h2d = pd[t->roadadr[road] + 1][nd] - p_road6d;
          p_roadroad2d = pd[t->roadadr[road] + t->roadn[road]][nd];
          t31d = (pd[t->roadadr[road] + t->roadn[road] + 1][nd] - p_roadroad2d - t31 * h2d) * h2inv;
          slope2d = t31d - (h2d / 6.0 * (2.0 * spline0[t->roadspline[road]][0] +
              spline0[t->roadspline[road] + 1][0]) + h2 / 6.0 * (2.0 *
              spline0d[t->roadspline[road]][0][nd] + spline0d[t->roadspline[road] + 1][0][nd]));
          s30d[nd] = p_roadroad2d + (slope2d * (x - p_road6) + slope2 * (xd[nd] - p_road6d));
          s31d[nd] = slope2d;
        }
      } else if (k9 > t->roadn[road] - 2) {
        p5 = p[t->roadadr[road] + t->roadn[road] - 1];
        h2_2 = p5 - p[t->roadadr[road] + t->roadn[road] - 2];
        p6 = p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1];
        t32 = (p6 - p[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2]) / h2_2;
        h2_2inv = 1.0 / h2_2;
        slope2_2 = t32 + h2_2 / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] + 2.0 *
            spline0[t->roadspline[road] + t->roadn[road] - 1][0]);
        s30 = p6 + slope2_2 * (x - p5);
        s31 = slope2_2;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double h2_2d, p5d, p6d, slope2_2d, t32d;

          p5d = pd[t->roadadr[road] + t->roadn[road] - 1][nd];
          h2_2d = p5d - pd[t->roadadr[road] + t->roadn[road] - 2][nd];
          p6d = pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 1][nd];
          t32d = (p6d - pd[t->roadadr[road] + t->roadn[road] + t->roadn[road] - 2][nd] - t32 *
              h2_2d) * h2_2inv;
          slope2_2d = t32d + (h2_2d / 6.0 * (spline0[t->roadspline[road] + t->roadn[road] - 2][0] +
              2.0 * spline0[t->roadspline[road] + t->roadn[road] - 1][0]) + h2_2 / 6.0 *
              (spline0d[t->roadspline[road] + t->roadn[road] - 2][0][nd] + 2.0 *
              spline0d[t->roadspline[road] + t->roadn[road] - 1][0][nd]));
          s30d[nd] = p6d + (slope2_2d * (x - p5) + slope2_2 * (xd[nd] - p5d));
          s31d[nd] = slope2_2d;
        }
      } else {
        p_roadk91 = p[t->roadadr[road] + k9 + 1];
        p_roadk9 = p[t->roadadr[road] + k9];
        h2_3 = p_roadk91 - p_roadk9;
        a4 = p_roadk91 - x;
        c5 = x - p_roadk9;
        p7 = p[t->roadadr[road] + t->roadn[road] + k9];
        t33 = (p[t->roadadr[road] + t->roadn[road] + k9 + 1] - p7) / h2_3;
        h2_3inv = 1.0 / h2_3;
        spline0_roadk910 = spline0[t->roadspline[road] + k9 + 1][0];
        spline0_roadk90 = spline0[t->roadspline[road] + k9][0];
        e2 = t33 - h2_3 / 6.0 * (spline0_roadk910 - spline0_roadk90);
        t34 = 6.0 * h2_3;
        t35 = (spline0_roadk90 * a4 * a4 * a4 + spline0_roadk910 * c5 * c5 * c5) / t34;
        t34inv = 1.0 / t34;
        s30 = t35 + p7 - spline0_roadk90 * h2_3 * h2_3 / 6.0 + e2 * c5;
        t36 = 2.0 * h2_3;
        t37 = (spline0_roadk910 * c5 * c5 - spline0_roadk90 * a4 * a4) / t36;
        t36inv = 1.0 / t36;
        s31 = t37 + e2;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double a4d, c5d, e2d, h2_3d, p7d, p_roadk91d, p_roadk9d, spline0_roadk90d,
              spline0_roadk910d, t33d, t34d, t35d, t36d, t37d;

          p_roadk91d = pd[t->roadadr[road] + k9 + 1][nd];
          p_roadk9d = pd[t->roadadr[road] + k9][nd];
          h2_3d = p_roadk91d - p_roadk9d;
          a4d = p_roadk91d - xd[nd];
          c5d = xd[nd] - p_roadk9d;
          p7d = pd[t->roadadr[road] + t->roadn[road] + k9][nd];
          t33d = (pd[t->roadadr[road] + t->roadn[road] + k9 + 1][nd] - p7d - t33 * h2_3d) * h2_3inv;
          spline0_roadk910d = spline0d[t->roadspline[road] + k9 + 1][0][nd];
          spline0_roadk90d = spline0d[t->roadspline[road] + k9][0][nd];
          e2d = t33d - (h2_3d / 6.0 * (spline0_roadk910 - spline0_roadk90) + h2_3 / 6.0 *
              (spline0_roadk910d - spline0_roadk90d));
          t34d = 6.0 * h2_3d;
          t35d = (((spline0_roadk90d * a4 + spline0_roadk90 * a4d) * a4 + spline0_roadk90 * a4 *
              a4d) * a4 + spline0_roadk90 * a4 * a4 * a4d + (((spline0_roadk910d * c5 +
              spline0_roadk910 * c5d) * c5 + spline0_roadk910 * c5 * c5d) * c5 + spline0_roadk910 *
              c5 * c5 * c5d) - t35 * t34d) * t34inv;
          s30d[nd] = t35d + p7d - ((spline0_roadk90d * h2_3 + spline0_roadk90 * h2_3d) * h2_3 +
              spline0_roadk90 * h2_3 * h2_3d) / 6.0 + (e2d * c5 + e2 * c5d);
          t36d = 2.0 * h2_3d;
          t37d = ((spline0_roadk910d * c5 + spline0_roadk910 * c5d) * c5 + spline0_roadk910 * c5 *
              c5d - ((spline0_roadk90d * a4 + spline0_roadk90 * a4d) * a4 + spline0_roadk90 * a4 *
              a4d) - t37 * t36d) * t36inv;
          s31d[nd] = t37d + e2d;
        }
      }
      h10 = s30;
      h11 = s31;
      h12 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        h10d[nd] = s30d[nd];
        h11d[nd] = s31d[nd];
        h12d[nd] = 0.0;
      }
    }
    t38 = 1.0 + h11 * h11;
    s = sqrt(t38);
    c16 = 1.0 / (2.0 * s);
    normal0 = -h11 / s;
    sinv = 1.0 / s;
    normal1 = 0.0;
    normal2 = 1.0 / s;
    c = u0 * normal0 + u1 * normal1 + u2_2 * normal2;
    un0 = u1 * normal2 - u2_2 * normal1;
    un1 = u2_2 * normal0 - u0 * normal2;
    un2 = u0 * normal1 - u1 * normal0;
    t39 = un0 * un0 + un1 * un1 + un2 * un2;
    w2 = sqrt(t39);
    c17 = 1.0 / (2.0 * w2);
    r2 = ((g0 - x) * normal0 + (g2 - h10) * normal2) / w2;
    w2inv = 1.0 / w2;
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
    z2_2inv = 1.0 / z2_2;
    fz = p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] * (p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - z0) + p[adr
        + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
    fz0 = p[adr + MAGGI_TYRE_LFZO] * p[adr];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double N0d, N2d, along0d, along1d, along2d, arm0d, arm1d, arm2d, cd, normal0d, normal2d, r2d,
          r_i0d, r_i1d, r_i2d, rhovd, sd, t38d, t39d, un0d, un1d, un2d, vc0d, vc1d, vc2d, vr0d,
          vr1d, vr2d, w0d, w1d, w2_2d, w2d, wr0d, wr1d, wr2d, z0d, z2_2d, z3_2d;

      t38d = h11d[nd] * h11 + h11 * h11d[nd];
      sd = c16 * t38d;
      normal0d = (-h11d[nd] - normal0 * sd) * sinv;
      normal2d = -(normal2 * sd * sinv);
      cd = u0d[nd] * normal0 + u0 * normal0d + u1d[nd] * normal1 + (u2_2d[nd] * normal2 + u2_2 *
          normal2d);
      un0d = u1d[nd] * normal2 + u1 * normal2d - u2_2d[nd] * normal1;
      un1d = u2_2d[nd] * normal0 + u2_2 * normal0d - (u0d[nd] * normal2 + u0 * normal2d);
      un2d = u0d[nd] * normal1 - (u1d[nd] * normal0 + u1 * normal0d);
      t39d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
      w2d = c17 * t39d;
      r2d = ((g0d[nd] - xd[nd]) * normal0 + (g0 - x) * normal0d + ((g2d[nd] - h10d[nd]) * normal2 +
          (g2 - h10) * normal2d) - r2 * w2d) * w2inv;
      along0d = (un0d - along0 * w2d) * w2inv;
      along1d = (un1d - along1 * w2d) * w2inv;
      along2d = (un2d - along2 * w2d) * w2inv;
      arm0d = (r2d * (c * u0 - normal0) + r2 * (cd * u0 + c * u0d[nd] - normal0d) - arm0 * w2d) *
          w2inv;
      T0d[nd] = along0d;
      N0d = normal0d;
      arm1d = (r2d * (c * u1 - normal1) + r2 * (cd * u1 + c * u1d[nd]) - arm1 * w2d) * w2inv;
      T1d[nd] = along1d;
      arm2d = (r2d * (c * u2_2 - normal2) + r2 * (cd * u2_2 + c * u2_2d[nd] - normal2d) - arm2 *
          w2d) * w2inv;
      T2d[nd] = along2d;
      N2d = normal2d;
      z0d = r2d;
      z2_2d = w2d;
      z3_2d = h12d[nd];
      w0d = Zd[carrier][3][nd];
      w1d = Zd[carrier][4][nd];
      w2_2d = Zd[carrier][5][nd];
      turnd[nd] = w0d * u0 + w0 * u0d[nd] + (w1d * u1 + w1 * u1d[nd]) + (w2_2d * u2_2 + w2_2 *
          u2_2d[nd]);
      wr0d = w0d - (turnd[nd] * u0 + turn * u0d[nd]);
      wr1d = w1d - (turnd[nd] * u1 + turn * u1d[nd]);
      wr2d = w2_2d - (turnd[nd] * u2_2 + turn * u2_2d[nd]);
      r_i2d = rd[t->wheelpoint[i]][2][nd];
      r_i1d = rd[t->wheelpoint[i]][1][nd];
      vc0d = w1d * r_i2 + w1 * r_i2d - (w2_2d * r_i1 + w2_2 * r_i1d);
      r_i0d = rd[t->wheelpoint[i]][0][nd];
      vc1d = w2_2d * r_i0 + w2_2 * r_i0d - (w0d * r_i2 + w0 * r_i2d);
      vc2d = w0d * r_i1 + w0 * r_i1d - (w1d * r_i0 + w1 * r_i0d);
      vr0d = wr1d * arm2 + wr1 * arm2d - (wr2d * arm1 + wr2 * arm1d);
      vr1d = wr2d * arm0 + wr2 * arm0d - (wr0d * arm2 + wr0 * arm2d);
      vr2d = wr0d * arm1 + wr0 * arm1d - (wr1d * arm0 + wr1 * arm0d);
      v0d[nd] = Zd[carrier][0][nd] + vc0d + vr0d;
      v1d[nd] = Zd[carrier][1][nd] + vc1d + vr1d;
      v2d[nd] = Zd[carrier][2][nd] + vc2d + vr2d;
      rhovd = (z3_2d * v0 + z3_2 * v0d[nd] - (v0d[nd] * N0 + v0 * N0d + v1d[nd] * N1 + (v2d[nd] * N2
          + v2 * N2d)) - rhov * z2_2d) * z2_2inv;
      fzd[nd] = pd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS][nd] * (p[adr + MAGGI_TYRE_UNLOADED_RADIUS] -
          z0) + p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS] * (pd[adr + MAGGI_TYRE_UNLOADED_RADIUS][nd] -
          z0d) + (pd[adr + MAGGI_TYRE_VERTICAL_DAMPING][nd] * rhov + p[adr +
          MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
      /* Re = R0 - rho0 (D atan(B rd) + F rd),  rd = Fz / Fz0,  rho0 = Fz0 / Cz;  R0 in the air */
      fz0d[nd] = pd[adr + MAGGI_TYRE_LFZO][nd] * p[adr] + p[adr + MAGGI_TYRE_LFZO] * pd[adr][nd];
    }
    if (MAGGI_RE(fz) > 0.0) {
      ratio = fz / fz0;
      fz0inv = 1.0 / fz0;
      t40 = fz0 / p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
      inv3 = 1.0 / p[adr + MAGGI_TYRE_VERTICAL_STIFFNESS];
      t41 = p[adr + MAGGI_TYRE_BREFF] * ratio;
      t42 = atan(t41);
      c18 = 1.0 / (1.0 + t41 * t41);
      re2 = p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - t40 * (p[adr + MAGGI_TYRE_DREFF] * t42 + p[adr +
          MAGGI_TYRE_FREFF] * ratio);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double ratiod, t40d, t41d, t42d;

        ratiod = (fzd[nd] - ratio * fz0d[nd]) * fz0inv;
        t40d = (fz0d[nd] - t40 * pd[adr + MAGGI_TYRE_VERTICAL_STIFFNESS][nd]) * inv3;
        t41d = pd[adr + MAGGI_TYRE_BREFF][nd] * ratio + p[adr + MAGGI_TYRE_BREFF] * ratiod;
        t42d = c18 * t41d;
        re2d[nd] = pd[adr + MAGGI_TYRE_UNLOADED_RADIUS][nd] - (t40d * (p[adr + MAGGI_TYRE_DREFF] *
            t42 + p[adr + MAGGI_TYRE_FREFF] * ratio) + t40 * (pd[adr + MAGGI_TYRE_DREFF][nd] * t42 +
            p[adr + MAGGI_TYRE_DREFF] * t42d + (pd[adr + MAGGI_TYRE_FREFF][nd] * ratio + p[adr +
            MAGGI_TYRE_FREFF] * ratiod)));
      }
    } else {
      re2 = p[adr + MAGGI_TYRE_UNLOADED_RADIUS];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        re2d[nd] = pd[adr + MAGGI_TYRE_UNLOADED_RADIUS][nd];
      }
    }
    re = re2;
    t43 = (v0 * T0 + v1 * T1 + v2 * T2) / re;
    reinv = 1.0 / re;
    t44 = b[body][3] * u0 + b[body][4] * u1 + b[body][5] * u2_2;
    t44inv = 1.0 / t44;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double red, t43d, t44d;

      red = re2d[nd];
      t43d = (v0d[nd] * T0 + v0 * T0d[nd] + (v1d[nd] * T1 + v1 * T1d[nd]) + (v2d[nd] * T2 + v2 *
          T2d[nd]) - t43 * red) * reinv;
      t44d = bd[body][3][nd] * u0 + b[body][3] * u0d[nd] + (bd[body][4][nd] * u1 + b[body][4] *
          u1d[nd]) + (bd[body][5][nd] * u2_2 + b[body][5] * u2_2d[nd]);
      spind[i][nd] = (t43d - turnd[nd] - spin[i] * t44d) * t44inv;
    }
  }
}
