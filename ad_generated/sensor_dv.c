/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra and Za carry minus gravity; p begins with gravity */
void maggi_sensors_dv(const maggi_topo *t, const double p[restrict t->np],
                      const double pd[restrict t->np][MAGGI_NDIR], const double origin[restrict 3],
                      const double spring0[restrict t->nspring],
                      const double spring0d[restrict t->nspring][MAGGI_NDIR],
                      const double q[restrict t->nq], const double qd[restrict t->nq][MAGGI_NDIR],
                      const double v[restrict t->nq], const double vd[restrict t->nq][MAGGI_NDIR],
                      const double A[restrict t->nbody + 1][9],
                      const double Ad[restrict t->nbody + 1][9][MAGGI_NDIR],
                      const double x[restrict t->nbody + 1][3],
                      const double xd[restrict t->nbody + 1][3][MAGGI_NDIR],
                      const double r[restrict t->npoint][3],
                      const double rd[restrict t->npoint][3][MAGGI_NDIR],
                      const double Z[restrict t->nbody + 1][6],
                      const double Zd[restrict t->nbody + 1][6][MAGGI_NDIR],
                      const double rv[restrict t->npoint][3],
                      const double rvd[restrict t->npoint][3][MAGGI_NDIR],
                      const double Za[restrict t->nbody + 1][6],
                      const double Zad[restrict t->nbody + 1][6][MAGGI_NDIR],
                      const double ra[restrict t->npoint][3],
                      const double rad[restrict t->npoint][3][MAGGI_NDIR],
                      const double driver[restrict t->ndriver][4],
                      const double driverd[restrict t->ndriver][4][MAGGI_NDIR],
                      const double speed[restrict t->nspeed][3],
                      const double speedd[restrict t->nspeed][3][MAGGI_NDIR],
                      const double lambda[restrict t->nrow],
                      const double lambdad[restrict t->nrow][MAGGI_NDIR],
                      double s[restrict t->nsensor][3],
                      double sd[restrict t->nsensor][3][MAGGI_NDIR], int nbdirs)
{
  int a, a4, a4_2, a4_3, b, b2, b2_2, i, j, k, k3, n2, nd;
  double A_j0, A_j0_2, A_j0_3, A_j0_4, A_j3, A_j3_2, A_j3_3, A_j3_4, A_j7, A_j8, L0, L1, L2, N0, N1,
      N2, T0, T1, T2, Z_j3, Z_j4, Z_k3, Z_k4, Z_k5, a00, a01, a02, a2, a3, along0, along1, along2,
      ar, areq, arm0, arm1, arm2, at, ateq, ay, br, bt, bx, by, bycy, c, c10, c11, c12, c13, c14,
      c15, c16, c17, c18, c19, c2, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c2inv, c3, c30,
      c31, c32, c33, c34, c35, c36, c37, c38, c39, c4, c40, c41, c42, c43, c44, c45, c46, c47, c48,
      c49, c5, c50, c51, c52, c53, c54, c55, c56, c57, c58, c59, c6, c60, c61, c62, c63, c7, c8, c9,
      ca, cx, cy, d, dfz, dr, dt, dv, dx, dy, e0, e1, e10, e11, e12, e13, e20, e21, e22, e2_2, e3,
      e4, e5, e6, e7, e8, e9, et, ev0, ev1, ev20, ev21, ev22, ev2_2, ex, ey, fx, fy, fz, fz0, fz0_2,
      fz0_2inv, fz0_3, fz0_4, fz0_4inv, fz0inv, fz2, g0, g0_2, g0_3, g0_4, g1, g1_2, g1_3, g1_4,
      g20, g22, g2_2, g2_5, g30, g31, gamma, gamma2, gx, gy, gz, h, h00, h10, h11, h2, h2inv, h3,
      h3inv, hinv, inv, inv2, inv3, kappa, kappa2, kx, l, l2, l2inv, linv, lv, mux, muy, muy2, n30,
      n31, n32, n40, n41, n42, n5, n5inv, n60, n61, n62, omega, one0, one1, one2, one3, one4, p10,
      p10inv, p2, p2inv, p3, p4, p4inv, p5, p6, p7, p8, p9, p_b2, p_b2_2, p_b2_2inv, p_b2_3, p_b2_4,
      p_b2_5, p_b2_5inv, p_b2_6, p_i, p_i1, p_i2, p_i3, p_k34, p_k35, r0, r2, r2inv, r3, ratio,
      ratio2, re, rhov, roll, rv_k0, rv_k0_2, rv_k0_3, rv_k1, rv_k1_2, rv_k1_3, rv_k2, s2, s2inv,
      s3, s4, shift, shy, side, slip1, speed2, speed2inv, speed3, stiff, stiff2, stiff2inv, stiff3,
      stiff4, svx, svy, t10, t100, t100inv, t101, t102, t103, t104, t105, t106, t107, t107inv, t108,
      t109, t11, t110, t111, t112, t11inv, t12, t14, t14inv, t15, t16, t17, t18, t19, t2, t20,
      t20inv, t21, t22, t23, t24, t25, t26, t26inv, t27, t28, t29, t2inv, t3, t30, t31, t32, t33,
      t34, t35, t36, t37, t38, t39, t4, t40, t41, t41inv, t42, t43, t44, t45, t46, t47, t47inv, t48,
      t48inv, t49, t49inv, t4inv, t5, t50, t51, t51inv, t52, t53, t54, t55, t56, t57, t58, t59,
      t59inv, t6, t60, t61, t62, t62inv, t63, t64, t65, t66, t67, t68, t69, t6inv, t7, t70, t71,
      t72, t73, t73inv, t74, t75, t76, t77, t78, t79, t79inv, t8, t80, t81, t82, t83, t84, t85, t86,
      t87, t88, t89, t8inv, t9, t90, t90inv, t91, t92, t93, t94, t94inv, t95, t96, t97, t98, t99,
      u20, u21, u30, u31, u32, ua0, ua1, ua2, un0, un1, un2, v20, v21, v22, vr0, vr1, vr2, vx, w,
      w2, w2inv, way, wr0, wr1, wr2, x2, x3, x4, x50, x51, x6, x7, x8, x9, xv, y, y10, y11, y12,
      y13, y14, y15, y16, y17, y18, y20, y21, y21inv, y22, y23, y24, y3, y4, y5, y6, y7, y8, y9,
      z1_3, z20, z21, z22, z22inv, z30, z4, z5, z6;
  double L0d[MAGGI_NDIR], L1d[MAGGI_NDIR], L2d[MAGGI_NDIR], a2d[MAGGI_NDIR], a3d[MAGGI_NDIR],
      areqd[MAGGI_NDIR], atd[MAGGI_NDIR], ateqd[MAGGI_NDIR], ayd[MAGGI_NDIR], btd[MAGGI_NDIR],
      bycyd[MAGGI_NDIR], cxd[MAGGI_NDIR], cyd[MAGGI_NDIR], dampingd[MAGGI_NDIR], dd[MAGGI_NDIR],
      dfzd[MAGGI_NDIR], dtd[MAGGI_NDIR], dxd[MAGGI_NDIR], dyd[MAGGI_NDIR], e10d[MAGGI_NDIR],
      e12d[MAGGI_NDIR], e13d[MAGGI_NDIR], e3d[MAGGI_NDIR], e4d[MAGGI_NDIR], e5d[MAGGI_NDIR],
      e6d[MAGGI_NDIR], e7d[MAGGI_NDIR], e8d[MAGGI_NDIR], exd[MAGGI_NDIR], eyd[MAGGI_NDIR],
      f0d[MAGGI_NDIR], f1d[MAGGI_NDIR], f2d[MAGGI_NDIR], fxd[MAGGI_NDIR], fyd[MAGGI_NDIR],
      fz0_2d[MAGGI_NDIR], fz0_3d[MAGGI_NDIR], fz0_4d[MAGGI_NDIR], fz2d[MAGGI_NDIR], fzd[MAGGI_NDIR],
      g0_2d[MAGGI_NDIR], g1_2d[MAGGI_NDIR], g20d[MAGGI_NDIR], g22d[MAGGI_NDIR], g30d[MAGGI_NDIR],
      g31d[MAGGI_NDIR], gamma2d[MAGGI_NDIR], gammad[MAGGI_NDIR], gyd[MAGGI_NDIR], gzd[MAGGI_NDIR],
      h00d[MAGGI_NDIR], h10d[MAGGI_NDIR], h11d[MAGGI_NDIR], kappa2d[MAGGI_NDIR], kappad[MAGGI_NDIR],
      kxd[MAGGI_NDIR], ld[MAGGI_NDIR], lvd[MAGGI_NDIR], muy2d[MAGGI_NDIR], muyd[MAGGI_NDIR],
      omegad[MAGGI_NDIR], one0d[MAGGI_NDIR], one1d[MAGGI_NDIR], one2d[MAGGI_NDIR],
      one3d[MAGGI_NDIR], one4d[MAGGI_NDIR], r0d[MAGGI_NDIR], r2d[MAGGI_NDIR], red[MAGGI_NDIR],
      rolling0d[MAGGI_NDIR], rolling1d[MAGGI_NDIR], rolling2d[MAGGI_NDIR], rolling3d[MAGGI_NDIR],
      rolling4d[MAGGI_NDIR], rolling5d[MAGGI_NDIR], shyd[MAGGI_NDIR], slip0d[MAGGI_NDIR],
      slip1d[MAGGI_NDIR], slip2d[MAGGI_NDIR], stiff3d[MAGGI_NDIR], stiff4d[MAGGI_NDIR],
      sumd[MAGGI_NDIR], u20d[MAGGI_NDIR], u21d[MAGGI_NDIR], u30d[MAGGI_NDIR], u31d[MAGGI_NDIR],
      u32d[MAGGI_NDIR], v20d[MAGGI_NDIR], v21d[MAGGI_NDIR], v22d[MAGGI_NDIR], vxd[MAGGI_NDIR],
      x2d[MAGGI_NDIR], x3d[MAGGI_NDIR], x4d[MAGGI_NDIR], x50d[MAGGI_NDIR], x51d[MAGGI_NDIR],
      xvd[MAGGI_NDIR], y10d[MAGGI_NDIR], y13d[MAGGI_NDIR], y16d[MAGGI_NDIR], y17d[MAGGI_NDIR],
      y20d[MAGGI_NDIR], y21d[MAGGI_NDIR], y23d[MAGGI_NDIR], y24d[MAGGI_NDIR], y3d[MAGGI_NDIR],
      y4d[MAGGI_NDIR], y6d[MAGGI_NDIR], y7d[MAGGI_NDIR], y8d[MAGGI_NDIR], yd[MAGGI_NDIR],
      z21d[MAGGI_NDIR], z22d[MAGGI_NDIR], z4d[MAGGI_NDIR];

  (void)origin;
  (void)x;
  (void)Za;
  (void)driver;
  (void)speed;
  (void)lambda;
  (void)nbdirs;
  for (i = 0; i < t->nsensor; ++i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n2 = t->sensorelement[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = rd[k][0][nd] - xd[t->nbody][0][nd];
        sd[i][1][nd] = rd[k][1][nd] - xd[t->nbody][1][nd];
        sd[i][2][nd] = rd[k][2][nd] - xd[t->nbody][2][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = rvd[k][0][nd];
        sd[i][1][nd] = rvd[k][1][nd];
        sd[i][2][nd] = rvd[k][2][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ACCELERATION) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = rad[k][0][nd] + pd[0][nd];
        sd[i][1][nd] = rad[k][1][nd] + pd[1][nd];
        sd[i][2][nd] = rad[k][2][nd] + pd[2][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LATERAL_ACCELERATION) {
      g0 = ra[k][0] + p[0];
      g1 = ra[k][1] + p[1];
      g2_2 = ra[k][2] + p[2];
      p_i = p[t->sensoradr[i]];
      w = p_i * p_i;
      rv_k0 = rv[k][0];
      rv_k1 = rv[k][1];
      rv_k2 = rv[k][2];
      t2 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + rv_k2 * rv_k2 + w;
      c = (g0 * rv_k0 + g1 * rv_k1 + g2_2 * rv_k2) / t2;
      t2inv = 1.0 / t2;
      n30 = g0 - c * rv_k0;
      n31 = g1 - c * rv_k1;
      n32 = g2_2 - c * rv_k2;
      p_i1 = p[t->sensoradr[i] + 1];
      t3 = n30 * n30 + n31 * n31 + n32 * n32 + p_i1 * p_i1;
      t4 = sqrt(t3);
      c4 = 1.0 / (2.0 * t4);
      t4inv = 1.0 / t4;
      t5 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + w;
      t6 = sqrt(t5);
      c5 = 1.0 / (2.0 * t6);
      t6inv = 1.0 / t6;
      t7 = g0 * g0 + g1 * g1 + p_i1 * p_i1;
      t8 = sqrt(t7);
      c6 = 1.0 / (2.0 * t8);
      t8inv = 1.0 / t8;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double cd, g0d, g1d, g2_2d, n30d, n31d, n32d, p_i1d, p_id, rv_k0d, rv_k1d, rv_k2d, t2d, t3d,
            t4d, t5d, t6d, t7d, t8d, wd;

        g0d = rad[k][0][nd] + pd[0][nd];
        g1d = rad[k][1][nd] + pd[1][nd];
        g2_2d = rad[k][2][nd] + pd[2][nd];
        p_id = pd[t->sensoradr[i]][nd];
        wd = p_id * p_i + p_i * p_id;
        rv_k0d = rvd[k][0][nd];
        rv_k1d = rvd[k][1][nd];
        rv_k2d = rvd[k][2][nd];
        t2d = rv_k0d * rv_k0 + rv_k0 * rv_k0d + (rv_k1d * rv_k1 + rv_k1 * rv_k1d) + (rv_k2d * rv_k2
            + rv_k2 * rv_k2d) + wd;
        cd = (g0d * rv_k0 + g0 * rv_k0d + (g1d * rv_k1 + g1 * rv_k1d) + (g2_2d * rv_k2 + g2_2 *
            rv_k2d) - c * t2d) * t2inv;
        n30d = g0d - (cd * rv_k0 + c * rv_k0d);
        n31d = g1d - (cd * rv_k1 + c * rv_k1d);
        n32d = g2_2d - (cd * rv_k2 + c * rv_k2d);
        p_i1d = pd[t->sensoradr[i] + 1][nd];
        t3d = n30d * n30 + n30 * n30d + (n31d * n31 + n31 * n31d) + (n32d * n32 + n32 * n32d) +
            (p_i1d * p_i1 + p_i1 * p_i1d);
        t4d = c4 * t3d;
        sd[i][0][nd] = (n30d * n30 + n30 * n30d + (n31d * n31 + n31 * n31d) + (n32d * n32 + n32 *
            n32d) - s[i][0] * t4d) * t4inv;
        t5d = rv_k0d * rv_k0 + rv_k0 * rv_k0d + (rv_k1d * rv_k1 + rv_k1 * rv_k1d) + wd;
        t6d = c5 * t5d;
        sd[i][1][nd] = (rv_k0d * g1 + rv_k0 * g1d - (rv_k1d * g0 + rv_k1 * g0d) - s[i][1] * t6d) *
            t6inv;
        t7d = g0d * g0 + g0 * g0d + (g1d * g1 + g1 * g1d) + (p_i1d * p_i1 + p_i1 * p_i1d);
        t8d = c6 * t7d;
        sd[i][2][nd] = (g0d * g0 + g0 * g0d + (g1d * g1 + g1 * g1d) - s[i][2] * t8d) * t8inv;
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SIDESLIP) {
      g0_2 = ra[k][0] + p[0];
      g1_2 = ra[k][1] + p[1];
      A_j0 = A[j][0];
      A_j3 = A[j][3];
      t9 = A_j0 * A_j0 + A_j3 * A_j3;
      h = sqrt(t9);
      c7 = 1.0 / (2.0 * h);
      rv_k0_2 = rv[k][0];
      rv_k1_2 = rv[k][1];
      u20 = (A_j0 * rv_k0_2 + A_j3 * rv_k1_2) / h;
      hinv = 1.0 / h;
      u21 = (A_j0 * rv_k1_2 - A_j3 * rv_k0_2) / h;
      p_i2 = p[t->sensoradr[i]];
      t10 = u20 * u20 + u21 * u21 + p_i2 * p_i2;
      r2 = sqrt(t10);
      c8 = 1.0 / (2.0 * r2);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j0d, A_j3d, hd, p_i2d, rv_k0_2d, rv_k1_2d, t10d, t9d;

        g0_2d[nd] = rad[k][0][nd] + pd[0][nd];
        g1_2d[nd] = rad[k][1][nd] + pd[1][nd];
        A_j0d = Ad[j][0][nd];
        A_j3d = Ad[j][3][nd];
        t9d = A_j0d * A_j0 + A_j0 * A_j0d + (A_j3d * A_j3 + A_j3 * A_j3d);
        hd = c7 * t9d;
        rv_k0_2d = rvd[k][0][nd];
        rv_k1_2d = rvd[k][1][nd];
        u20d[nd] = (A_j0d * rv_k0_2 + A_j0 * rv_k0_2d + (A_j3d * rv_k1_2 + A_j3 * rv_k1_2d) - u20 *
            hd) * hinv;
        u21d[nd] = (A_j0d * rv_k1_2 + A_j0 * rv_k1_2d - (A_j3d * rv_k0_2 + A_j3 * rv_k0_2d) - u21 *
            hd) * hinv;
        p_i2d = pd[t->sensoradr[i]][nd];
        t10d = u20d[nd] * u20 + u20 * u20d[nd] + (u21d[nd] * u21 + u21 * u21d[nd]) + (p_i2d * p_i2 +
            p_i2 * p_i2d);
        r2d[nd] = c8 * t10d;
      }
      if (MAGGI_RE(u20) < 0.0) {
        t11 = r2 - u20;
        p_i3 = p[t->sensoradr[i]];
        t12 = (u21 * u21 + p_i3 * p_i3) / t11;
        t11inv = 1.0 / t11;
        d = t12;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_i3d, t11d, t12d;

          t11d = r2d[nd] - u20d[nd];
          p_i3d = pd[t->sensoradr[i]][nd];
          t12d = (u21d[nd] * u21 + u21 * u21d[nd] + (p_i3d * p_i3 + p_i3 * p_i3d) - t12 * t11d) *
              t11inv;
          dd[nd] = t12d;
        }
      } else {
        d = r2 + u20;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          dd[nd] = r2d[nd] + u20d[nd];
        }
      }
      c9 = d / (d * d + u21 * u21);
      c10 = -(u21 / (d * d + u21 * u21));
      r2inv = 1.0 / r2;
      t14 = r2 * r2 * r2;
      t14inv = 1.0 / t14;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t13d, t14d;

        t13d = c9 * u21d[nd] + c10 * dd[nd];
        sd[i][0][nd] = 2.0 * t13d;
        sd[i][1][nd] = (u20d[nd] * u20 + u20 * u20d[nd] + (u21d[nd] * u21 + u21 * u21d[nd]) -
            s[i][1] * r2d[nd]) * r2inv;
        t14d = (r2d[nd] * r2 + r2 * r2d[nd]) * r2 + r2 * r2 * r2d[nd];
        sd[i][2][nd] = (rvd[k][0][nd] * g1_2 + rv[k][0] * g1_2d[nd] - (rvd[k][1][nd] * g0_2 +
            rv[k][1] * g0_2d[nd]) - s[i][2] * t14d) * t14inv;
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_VELOCITY) {
      A_j0_2 = A[j][0];
      A_j3_2 = A[j][3];
      t15 = A_j0_2 * A_j0_2 + A_j3_2 * A_j3_2;
      h2 = sqrt(t15);
      c11 = 1.0 / (2.0 * h2);
      rv_k0_3 = rv[k][0];
      rv_k1_3 = rv[k][1];
      h2inv = 1.0 / h2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j0_2d, A_j3_2d, h2d, rv_k0_3d, rv_k1_3d, t15d;

        A_j0_2d = Ad[j][0][nd];
        A_j3_2d = Ad[j][3][nd];
        t15d = A_j0_2d * A_j0_2 + A_j0_2 * A_j0_2d + (A_j3_2d * A_j3_2 + A_j3_2 * A_j3_2d);
        h2d = c11 * t15d;
        rv_k0_3d = rvd[k][0][nd];
        rv_k1_3d = rvd[k][1][nd];
        sd[i][0][nd] = (A_j0_2d * rv_k0_3 + A_j0_2 * rv_k0_3d + (A_j3_2d * rv_k1_3 + A_j3_2 *
            rv_k1_3d) - s[i][0] * h2d) * h2inv;
        sd[i][1][nd] = (A_j0_2d * rv_k1_3 + A_j0_2 * rv_k1_3d - (A_j3_2d * rv_k0_3 + A_j3_2 *
            rv_k0_3d) - s[i][1] * h2d) * h2inv;
        sd[i][2][nd] = rvd[k][2][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_ACCELERATION) {
      g0_3 = ra[k][0] + p[0];
      g1_3 = ra[k][1] + p[1];
      A_j0_3 = A[j][0];
      A_j3_3 = A[j][3];
      t16 = A_j0_3 * A_j0_3 + A_j3_3 * A_j3_3;
      h3 = sqrt(t16);
      c12 = 1.0 / (2.0 * h3);
      h3inv = 1.0 / h3;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j0_3d, A_j3_3d, g0_3d, g1_3d, g2_4d, h3d, t16d;

        g0_3d = rad[k][0][nd] + pd[0][nd];
        g1_3d = rad[k][1][nd] + pd[1][nd];
        g2_4d = rad[k][2][nd] + pd[2][nd];
        A_j0_3d = Ad[j][0][nd];
        A_j3_3d = Ad[j][3][nd];
        t16d = A_j0_3d * A_j0_3 + A_j0_3 * A_j0_3d + (A_j3_3d * A_j3_3 + A_j3_3 * A_j3_3d);
        h3d = c12 * t16d;
        sd[i][0][nd] = (A_j0_3d * g0_3 + A_j0_3 * g0_3d + (A_j3_3d * g1_3 + A_j3_3 * g1_3d) -
            s[i][0] * h3d) * h3inv;
        sd[i][1][nd] = (A_j0_3d * g1_3 + A_j0_3 * g1_3d - (A_j3_3d * g0_3 + A_j3_3 * g0_3d) -
            s[i][1] * h3d) * h3inv;
        sd[i][2][nd] = g2_4d;
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_BODY_ACCELERATION) {
      g0_4 = ra[k][0] + p[0];
      g1_4 = ra[k][1] + p[1];
      g2_5 = ra[k][2] + p[2];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double g0_4d, g1_4d, g2_5d;

        g0_4d = rad[k][0][nd] + pd[0][nd];
        g1_4d = rad[k][1][nd] + pd[1][nd];
        g2_5d = rad[k][2][nd] + pd[2][nd];
        sd[i][0][nd] = Ad[j][0][nd] * g0_4 + A[j][0] * g0_4d + (Ad[j][3][nd] * g1_4 + A[j][3] *
            g1_4d) + (Ad[j][6][nd] * g2_5 + A[j][6] * g2_5d);
        sd[i][1][nd] = Ad[j][1][nd] * g0_4 + A[j][1] * g0_4d + (Ad[j][4][nd] * g1_4 + A[j][4] *
            g1_4d) + (Ad[j][7][nd] * g2_5 + A[j][7] * g2_5d);
        sd[i][2][nd] = Ad[j][2][nd] * g0_4 + A[j][2] * g0_4d + (Ad[j][5][nd] * g1_4 + A[j][5] *
            g1_4d) + (Ad[j][8][nd] * g2_5 + A[j][8] * g2_5d);
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_COMBINATION) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sumd[nd] = 0.0;
      }
      for (a = 0; a < t->sensorterms[i]; ++a) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sumd[nd] += pd[t->sensoradr[i] + a][nd] * s[t->termsensor[n2 + a]][t->termcolumn[n2 + a]]
              + p[t->sensoradr[i] + a] * sd[t->termsensor[n2 + a]][t->termcolumn[n2 + a]][nd];
        }
      }
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = sumd[nd];
        sd[i][1][nd] = 0.0;
        sd[i][2][nd] = 0.0;
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j8 = A[j][8];
      c13 = A_j8 / (A_j8 * A_j8 + A_j7 * A_j7);
      c14 = -(A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      t17 = -A[j][6];
      t18 = A_j7 * A_j7 + A_j8 * A_j8;
      t19 = sqrt(t18);
      c15 = 1.0 / (2.0 * t19);
      c16 = t19 / (t19 * t19 + t17 * t17);
      c17 = -(t17 / (t19 * t19 + t17 * t17));
      c18 = A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]);
      c19 = -(A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j7d, A_j8d, t17d, t18d, t19d;

        A_j7d = Ad[j][7][nd];
        A_j8d = Ad[j][8][nd];
        /* R = Rz(yaw) Ry(pitch) Rx(roll) */
        sd[i][0][nd] = c13 * A_j7d + c14 * A_j8d;
        t17d = -Ad[j][6][nd];
        t18d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
        t19d = c15 * t18d;
        sd[i][1][nd] = c16 * t17d + c17 * t19d;
        sd[i][2][nd] = c18 * Ad[j][3][nd] + c19 * Ad[j][0][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      A_j0_4 = A[j][0];
      A_j3_4 = A[j][3];
      c2 = A_j0_4 * A_j0_4 + A_j3_4 * A_j3_4;
      Z_j3 = Z[j][3];
      Z_j4 = Z[j][4];
      roll = s[i][0];
      c2inv = 1.0 / c2;
      t20 = sqrt(c2);
      c20 = 1.0 / (2.0 * t20);
      t20inv = 1.0 / t20;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j0_4d, A_j3_4d, Z_j3d, Z_j4d, c2d, rolld, t20d;

        A_j0_4d = Ad[j][0][nd];
        A_j3_4d = Ad[j][3][nd];
        /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
         * A_6 = -sin(pitch) */
        c2d = A_j0_4d * A_j0_4 + A_j0_4 * A_j0_4d + (A_j3_4d * A_j3_4 + A_j3_4 * A_j3_4d);
        Z_j3d = Zd[j][3][nd];
        Z_j4d = Zd[j][4][nd];
        rolld = (A_j0_4d * Z_j3 + A_j0_4 * Z_j3d + (A_j3_4d * Z_j4 + A_j3_4 * Z_j4d) - roll * c2d) *
            c2inv;
        sd[i][0][nd] = rolld;
        t20d = c20 * c2d;
        sd[i][1][nd] = (A_j0_4d * Z_j4 + A_j0_4 * Z_j4d - (A_j3_4d * Z_j3 + A_j3_4 * Z_j3d) -
            s[i][1] * t20d) * t20inv;
        sd[i][2][nd] = Zd[j][5][nd] - (Ad[j][6][nd] * roll + A[j][6] * rolld);
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_VELOCITY) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = Zd[j][3][nd];
        sd[i][1][nd] = Zd[j][4][nd];
        sd[i][2][nd] = Zd[j][5][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_ACCELERATION) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = Zad[j][3][nd];
        sd[i][1][nd] = Zad[j][4][nd];
        sd[i][2][nd] = Zad[j][5][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SPRING) {
      a4 = t->springpa[n2];
      b = t->springpb[n2];
      e0 = r[a4][0] - r[b][0];
      ev0 = rv[a4][0] - rv[b][0];
      e1 = r[a4][1] - r[b][1];
      ev1 = rv[a4][1] - rv[b][1];
      e2_2 = r[a4][2] - r[b][2];
      ev2_2 = rv[a4][2] - rv[b][2];
      t21 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
      l = sqrt(t21);
      c21 = 1.0 / (2.0 * l);
      n40 = e0 / l;
      linv = 1.0 / l;
      n41 = e1 / l;
      n42 = e2_2 / l;
      lv = n40 * ev0 + n41 * ev1 + n42 * ev2_2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e0d, e1d, e2_2d, ev0d, ev1d, ev2_2d, n40d, n41d, n42d, t21d;

        e0d = rd[a4][0][nd] - rd[b][0][nd];
        ev0d = rvd[a4][0][nd] - rvd[b][0][nd];
        e1d = rd[a4][1][nd] - rd[b][1][nd];
        ev1d = rvd[a4][1][nd] - rvd[b][1][nd];
        e2_2d = rd[a4][2][nd] - rd[b][2][nd];
        ev2_2d = rvd[a4][2][nd] - rvd[b][2][nd];
        t21d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
        ld[nd] = c21 * t21d;
        n40d = (e0d - n40 * ld[nd]) * linv;
        n41d = (e1d - n41 * ld[nd]) * linv;
        n42d = (e2_2d - n42 * ld[nd]) * linv;
        lvd[nd] = n40d * ev0 + n40 * ev0d + (n41d * ev1 + n41 * ev1d) + (n42d * ev2_2 + n42 *
            ev2_2d);
        dampingd[nd] = pd[t->springadr[n2] + MAGGI_SPRING_C][nd] * lv + p[t->springadr[n2] +
            MAGGI_SPRING_C] * lvd[nd];
      }
      if (t->springpreload[n2]) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          f0d[nd] = pd[t->springadr[n2]][nd] * (l - spring0[n2]) + p[t->springadr[n2]] * (ld[nd] -
              spring0d[n2][nd]) + pd[t->springadr[n2] + MAGGI_SPRING_L][nd];
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          f0d[nd] = pd[t->springadr[n2]][nd] * (l - p[t->springadr[n2] + MAGGI_SPRING_L]) +
              p[t->springadr[n2]] * (ld[nd] - pd[t->springadr[n2] + MAGGI_SPRING_L][nd]);
        }
      }
      k3 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
      if (t->springslopes[n2]) {
        /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
        if (MAGGI_RE(lv) > MAGGI_RE(p[k3 + 4])) {
          p_k34 = p[k3 + 4];
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double p_k34d;

            p_k34d = pd[k3 + 4][nd];
            f2d[nd] = pd[k3][nd] * p_k34 + p[k3] * p_k34d + (pd[k3 + 1][nd] * (lv - p_k34) + p[k3 +
                1] * (lvd[nd] - p_k34d));
          }
        } else if (MAGGI_RE(lv) > 0.0) {
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            f2d[nd] = pd[k3][nd] * lv + p[k3] * lvd[nd];
          }
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k3 + 5])) {
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            f2d[nd] = pd[k3 + 2][nd] * lv + p[k3 + 2] * lvd[nd];
          }
        } else {
          p_k35 = p[k3 + 5];
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double p_k35d;

            p_k35d = pd[k3 + 5][nd];
            f2d[nd] = pd[k3 + 2][nd] * p_k35 + p[k3 + 2] * p_k35d + (pd[k3 + 3][nd] * (lv - p_k35) +
                p[k3 + 3] * (lvd[nd] - p_k35d));
          }
        }
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          f1d[nd] = dampingd[nd] + f2d[nd];
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          f1d[nd] = dampingd[nd];
        }
      }
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double z0d, z1d;

        z0d = ld[nd];
        z1d = lvd[nd];
        sd[i][0][nd] = z0d;
        sd[i][1][nd] = z1d;
        sd[i][2][nd] = f0d[nd] + f1d[nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_JOINT_SPRING) {
      if (t->jspringq2[n2] >= 0) {
        x2 = q[t->jspringq[n2]] - q[t->jspringq2[n2]];
        xv = v[t->jspringq[n2]] - v[t->jspringq2[n2]];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          x2d[nd] = qd[t->jspringq[n2]][nd] - qd[t->jspringq2[n2]][nd];
          xvd[nd] = vd[t->jspringq[n2]][nd] - vd[t->jspringq2[n2]][nd];
        }
      } else {
        x2 = q[t->jspringq[n2]];
        xv = v[t->jspringq[n2]];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          x2d[nd] = qd[t->jspringq[n2]][nd];
          xvd[nd] = vd[t->jspringq[n2]][nd];
        }
      }
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double torque0d, z0_2d, z1_2d;

        torque0d = -(pd[t->jspringadr[n2]][nd] * (x2 - p[t->jspringadr[n2] + MAGGI_JSPRING_REST])) -
            p[t->jspringadr[n2]] * (x2d[nd] - pd[t->jspringadr[n2] + MAGGI_JSPRING_REST][nd]) -
            (pd[t->jspringadr[n2] + MAGGI_JSPRING_C][nd] * xv + p[t->jspringadr[n2] +
            MAGGI_JSPRING_C] * xvd[nd]) - pd[t->jspringadr[n2] + MAGGI_JSPRING_PRELOAD][nd];
        z0_2d = x2d[nd];
        z1_2d = xvd[nd];
        sd[i][0][nd] = z0_2d;
        sd[i][1][nd] = z1_2d;
        sd[i][2][nd] = torque0d;
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ROD) {
      a4_2 = t->primpa[n2];
      b2 = t->primpb[n2];
      e20 = r[a4_2][0] - r[b2][0];
      ev20 = rv[a4_2][0] - rv[b2][0];
      e21 = r[a4_2][1] - r[b2][1];
      ev21 = rv[a4_2][1] - rv[b2][1];
      e22 = r[a4_2][2] - r[b2][2];
      ev22 = rv[a4_2][2] - rv[b2][2];
      t22 = e20 * e20 + e21 * e21 + e22 * e22;
      l2 = sqrt(t22);
      c22 = 1.0 / (2.0 * l2);
      z1_3 = s[i][1];
      l2inv = 1.0 / l2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e20d, e21d, e22d, ev20d, ev21d, ev22d, l2d, t22d, z0_3d, z1_3d;

        /* distance of two points and its rate */
        e20d = rd[a4_2][0][nd] - rd[b2][0][nd];
        ev20d = rvd[a4_2][0][nd] - rvd[b2][0][nd];
        e21d = rd[a4_2][1][nd] - rd[b2][1][nd];
        ev21d = rvd[a4_2][1][nd] - rvd[b2][1][nd];
        e22d = rd[a4_2][2][nd] - rd[b2][2][nd];
        ev22d = rvd[a4_2][2][nd] - rvd[b2][2][nd];
        t22d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 * e22d);
        l2d = c22 * t22d;
        z0_3d = l2d;
        z1_3d = (e20d * ev20 + e20 * ev20d + (e21d * ev21 + e21 * ev21d) + (e22d * ev22 + e22 *
            ev22d) - z1_3 * l2d) * l2inv;
        sd[i][0][nd] = z0_3d;
        sd[i][1][nd] = z1_3d;
        sd[i][2][nd] = lambdad[t->primrow[n2]][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SPEED) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = speedd[n2][0][nd];
        sd[i][1][nd] = speedd[n2][1][nd];
        sd[i][2][nd] = speedd[n2][2][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_DRIVER) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = driverd[n2][0][nd];
        sd[i][1][nd] = driverd[n2][1][nd];
        sd[i][2][nd] = driverd[n2][2][nd];
      }
    } else {
      a4_3 = t->wheelpoint[n2];
      b2_2 = t->wheelroad[n2];
      j = t->wheelbody[n2];
      k = t->wheelcarrier[n2];
      side = t->wheelmirror[n2] ? -1.0 : 1.0;
      a00 = p[t->wheelaxis[n2]];
      a01 = p[t->wheelaxis[n2] + 1];
      a02 = p[t->wheelaxis[n2] + 2];
      ua0 = A[j][0] * a00 + A[j][1] * a01 + A[j][2] * a02;
      ua1 = A[j][3] * a00 + A[j][4] * a01 + A[j][5] * a02;
      ua2 = A[j][6] * a00 + A[j][7] * a01 + A[j][8] * a02;
      t23 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
      n5 = sqrt(t23);
      c23 = 1.0 / (2.0 * n5);
      u30 = ua0 / n5;
      n5inv = 1.0 / n5;
      u31 = ua1 / n5;
      u32 = ua2 / n5;
      g20 = r[a4_3][0] - r[t->roadpoint[b2_2]][0];
      g22 = r[a4_3][2] - r[t->roadpoint[b2_2]][2];
      x4 = g20;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double a00d, a01d, a02d, n5d, t23d, ua0d, ua1d, ua2d;

        a00d = pd[t->wheelaxis[n2]][nd];
        a01d = pd[t->wheelaxis[n2] + 1][nd];
        a02d = pd[t->wheelaxis[n2] + 2][nd];
        ua0d = Ad[j][0][nd] * a00 + A[j][0] * a00d + (Ad[j][1][nd] * a01 + A[j][1] * a01d) +
            (Ad[j][2][nd] * a02 + A[j][2] * a02d);
        ua1d = Ad[j][3][nd] * a00 + A[j][3] * a00d + (Ad[j][4][nd] * a01 + A[j][4] * a01d) +
            (Ad[j][5][nd] * a02 + A[j][5] * a02d);
        ua2d = Ad[j][6][nd] * a00 + A[j][6] * a00d + (Ad[j][7][nd] * a01 + A[j][7] * a01d) +
            (Ad[j][8][nd] * a02 + A[j][8] * a02d);
        t23d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
        n5d = c23 * t23d;
        u30d[nd] = (ua0d - u30 * n5d) * n5inv;
        u31d[nd] = (ua1d - u31 * n5d) * n5inv;
        u32d[nd] = (ua2d - u32 * n5d) * n5inv;
        g20d[nd] = rd[a4_3][0][nd] - rd[t->roadpoint[b2_2]][0][nd];
        g22d[nd] = rd[a4_3][2][nd] - rd[t->roadpoint[b2_2]][2][nd];
        /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
         * the centre down the disc meets it, n its normal; then down the disc to that plane,
         *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
         * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
        x4d[nd] = g20d[nd];
      }
      /* height of the road above its point at x ahead of it, and its slope */
      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
        p_b2 = p[t->roadadr[b2_2]];
        h00 = p_b2 * x4;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_b2d;

          p_b2d = pd[t->roadadr[b2_2]][nd];
          h00d[nd] = p_b2d * x4 + p_b2 * x4d[nd];
        }
      } else {
        p_b2_2 = p[t->roadadr[b2_2] + 1];
        t24 = 6.28318530717958647693 * x4 / p_b2_2;
        p_b2_2inv = 1.0 / p_b2_2;
        t25 = sin(t24);
        c24 = cos(t24);
        p_b2_3 = p[t->roadadr[b2_2]];
        h00 = p_b2_3 * t25;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_b2_2d, p_b2_3d, t24d, t25d;

          p_b2_2d = pd[t->roadadr[b2_2] + 1][nd];
          t24d = (6.28318530717958647693 * x4d[nd] - t24 * p_b2_2d) * p_b2_2inv;
          t25d = c24 * t24d;
          p_b2_3d = pd[t->roadadr[b2_2]][nd];
          h00d[nd] = p_b2_3d * t25 + p_b2_3 * t25d;
        }
      }
      t26 = u30 * u30 + u31 * u31;
      t27 = u32 * u30 / t26;
      t26inv = 1.0 / t26;
      x3 = g20 + t27 * (g22 - h00);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t26d, t27d;

        t26d = u30d[nd] * u30 + u30 * u30d[nd] + (u31d[nd] * u31 + u31 * u31d[nd]);
        t27d = (u32d[nd] * u30 + u32 * u30d[nd] - t27 * t26d) * t26inv;
        x3d[nd] = g20d[nd] + (t27d * (g22 - h00) + t27 * (g22d[nd] - h00d[nd]));
      }
      /* height of the road above its point at x ahead of it, and its slope */
      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
        p_b2_4 = p[t->roadadr[b2_2]];
        h10 = p_b2_4 * x3;
        h11 = p_b2_4;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_b2_4d;

          p_b2_4d = pd[t->roadadr[b2_2]][nd];
          h10d[nd] = p_b2_4d * x3 + p_b2_4 * x3d[nd];
          h11d[nd] = p_b2_4d;
        }
      } else {
        p_b2_5 = p[t->roadadr[b2_2] + 1];
        t28 = 6.28318530717958647693 * x3 / p_b2_5;
        p_b2_5inv = 1.0 / p_b2_5;
        t29 = sin(t28);
        c25 = cos(t28);
        p_b2_6 = p[t->roadadr[b2_2]];
        h10 = p_b2_6 * t29;
        t30 = p_b2_6 * 6.28318530717958647693 / p_b2_5;
        t31 = 6.28318530717958647693 * x3 / p_b2_5;
        t32 = cos(t31);
        c26 = -sin(t31);
        h11 = t30 * t32;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_b2_5d, p_b2_6d, t28d, t29d, t30d, t31d, t32d;

          p_b2_5d = pd[t->roadadr[b2_2] + 1][nd];
          t28d = (6.28318530717958647693 * x3d[nd] - t28 * p_b2_5d) * p_b2_5inv;
          t29d = c25 * t28d;
          p_b2_6d = pd[t->roadadr[b2_2]][nd];
          h10d[nd] = p_b2_6d * t29 + p_b2_6 * t29d;
          t30d = (p_b2_6d * 6.28318530717958647693 - t30 * p_b2_5d) * p_b2_5inv;
          t31d = (6.28318530717958647693 * x3d[nd] - t31 * p_b2_5d) * p_b2_5inv;
          t32d = c26 * t31d;
          h11d[nd] = t30d * t32 + t30 * t32d;
        }
      }
      t33 = 1.0 + h11 * h11;
      s2 = sqrt(t33);
      c27 = 1.0 / (2.0 * s2);
      n60 = -h11 / s2;
      s2inv = 1.0 / s2;
      n61 = 0.0;
      n62 = 1.0 / s2;
      c3 = u30 * n60 + u31 * n61 + u32 * n62;
      un0 = u31 * n62 - u32 * n61;
      un1 = u32 * n60 - u30 * n62;
      un2 = u30 * n61 - u31 * n60;
      t34 = un0 * un0 + un1 * un1 + un2 * un2;
      w2 = sqrt(t34);
      c28 = 1.0 / (2.0 * w2);
      r3 = ((g20 - x3) * n60 + (g22 - h10) * n62) / w2;
      w2inv = 1.0 / w2;
      along0 = un0 / w2;
      along1 = un1 / w2;
      along2 = un2 / w2;
      L0 = n61 * along2 - n62 * along1;
      L1 = n62 * along0 - n60 * along2;
      L2 = n60 * along1 - n61 * along0;
      arm0 = r3 * (c3 * u30 - n60) / w2;
      T0 = along0;
      N0 = n60;
      arm1 = r3 * (c3 * u31 - n61) / w2;
      T1 = along1;
      N1 = n61;
      arm2 = r3 * (c3 * u32 - n62) / w2;
      T2 = along2;
      N2 = n62;
      z20 = r3;
      z21 = c3;
      z22 = w2;
      Z_k3 = Z[k][3];
      wr0 = Z_k3;
      Z_k4 = Z[k][4];
      wr1 = Z_k4;
      Z_k5 = Z[k][5];
      wr2 = Z_k5;
      vr0 = wr1 * arm2 - wr2 * arm1;
      vr1 = wr2 * arm0 - wr0 * arm2;
      vr2 = wr0 * arm1 - wr1 * arm0;
      v20 = rv[a4_3][0] + vr0;
      v21 = rv[a4_3][1] + vr1;
      v22 = rv[a4_3][2] + vr2;
      vx = v20 * T0 + v21 * T1 + v22 * T2;
      rhov = -(v20 * N0 + v21 * N1 + v22 * N2) / z22;
      z22inv = 1.0 / z22;
      omega = (Z[j][3] - Z_k3) * u30 + (Z[j][4] - Z_k4) * u31 + (Z[j][5] - Z_k5) * u32;
      p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
      fz = p2 * (p3 - z20) + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
      fz0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]];
      ratio = fz / fz0;
      fz0inv = 1.0 / fz0;
      t35 = fz0 / p2;
      p2inv = 1.0 / p2;
      t36 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratio;
      t37 = atan(t36);
      c29 = 1.0 / (1.0 + t36 * t36);
      re = p3 - t35 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double N0d, N2d, T0d, T1d, T2d, Z_k3d, Z_k4d, Z_k5d, along0d, along1d, along2d, arm0d,
            arm1d, arm2d, c3d, fz0d, n60d, n62d, p2d, p3d, r3d, ratiod, rhovd, s2d, t33d, t34d,
            t35d, t36d, t37d, un0d, un1d, un2d, vr0d, vr1d, vr2d, w2d, wr0d, wr1d, wr2d, z20d;

        t33d = h11d[nd] * h11 + h11 * h11d[nd];
        s2d = c27 * t33d;
        n60d = (-h11d[nd] - n60 * s2d) * s2inv;
        n62d = -(n62 * s2d * s2inv);
        c3d = u30d[nd] * n60 + u30 * n60d + u31d[nd] * n61 + (u32d[nd] * n62 + u32 * n62d);
        un0d = u31d[nd] * n62 + u31 * n62d - u32d[nd] * n61;
        un1d = u32d[nd] * n60 + u32 * n60d - (u30d[nd] * n62 + u30 * n62d);
        un2d = u30d[nd] * n61 - (u31d[nd] * n60 + u31 * n60d);
        t34d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
        w2d = c28 * t34d;
        r3d = ((g20d[nd] - x3d[nd]) * n60 + (g20 - x3) * n60d + ((g22d[nd] - h10d[nd]) * n62 + (g22
            - h10) * n62d) - r3 * w2d) * w2inv;
        along0d = (un0d - along0 * w2d) * w2inv;
        along1d = (un1d - along1 * w2d) * w2inv;
        along2d = (un2d - along2 * w2d) * w2inv;
        L0d[nd] = n61 * along2d - (n62d * along1 + n62 * along1d);
        L1d[nd] = n62d * along0 + n62 * along0d - (n60d * along2 + n60 * along2d);
        L2d[nd] = n60d * along1 + n60 * along1d - n61 * along0d;
        arm0d = (r3d * (c3 * u30 - n60) + r3 * (c3d * u30 + c3 * u30d[nd] - n60d) - arm0 * w2d) *
            w2inv;
        T0d = along0d;
        N0d = n60d;
        arm1d = (r3d * (c3 * u31 - n61) + r3 * (c3d * u31 + c3 * u31d[nd]) - arm1 * w2d) * w2inv;
        T1d = along1d;
        arm2d = (r3d * (c3 * u32 - n62) + r3 * (c3d * u32 + c3 * u32d[nd] - n62d) - arm2 * w2d) *
            w2inv;
        T2d = along2d;
        N2d = n62d;
        z20d = r3d;
        z21d[nd] = c3d;
        z22d[nd] = w2d;
        Z_k3d = Zd[k][3][nd];
        wr0d = Z_k3d;
        Z_k4d = Zd[k][4][nd];
        wr1d = Z_k4d;
        Z_k5d = Zd[k][5][nd];
        wr2d = Z_k5d;
        vr0d = wr1d * arm2 + wr1 * arm2d - (wr2d * arm1 + wr2 * arm1d);
        vr1d = wr2d * arm0 + wr2 * arm0d - (wr0d * arm2 + wr0 * arm2d);
        vr2d = wr0d * arm1 + wr0 * arm1d - (wr1d * arm0 + wr1 * arm0d);
        v20d[nd] = rvd[a4_3][0][nd] + vr0d;
        v21d[nd] = rvd[a4_3][1][nd] + vr1d;
        v22d[nd] = rvd[a4_3][2][nd] + vr2d;
        vxd[nd] = v20d[nd] * T0 + v20 * T0d + (v21d[nd] * T1 + v21 * T1d) + (v22d[nd] * T2 + v22 *
            T2d);
        rhovd = (-(v20d[nd] * N0 + v20 * N0d + v21d[nd] * N1 + (v22d[nd] * N2 + v22 * N2d)) - rhov *
            z22d[nd]) * z22inv;
        omegad[nd] = (Zd[j][3][nd] - Z_k3d) * u30 + (Z[j][3] - Z_k3) * u30d[nd] + ((Zd[j][4][nd] -
            Z_k4d) * u31 + (Z[j][4] - Z_k4) * u31d[nd]) + ((Zd[j][5][nd] - Z_k5d) * u32 + (Z[j][5] -
            Z_k5) * u32d[nd]);
        p2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS][nd];
        p3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS][nd];
        fzd[nd] = p2d * (p3 - z20) + p2 * (p3d - z20d) + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_VERTICAL_DAMPING][nd] * rhov + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
        fz0d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO][nd] *
            p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
            pd[t->tyreadr[t->wheeltyre[n2]]][nd];
        ratiod = (fzd[nd] - ratio * fz0d) * fz0inv;
        t35d = (fz0d - t35 * p2d) * p2inv;
        t36d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF][nd] * ratio +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratiod;
        t37d = c29 * t36d;
        red[nd] = p3d - (t35d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio) + t35 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF][nd] * t37 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37d +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF][nd] * ratio +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratiod)));
      }
      /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
      if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW])) {
        y = vx;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          yd[nd] = vxd[nd];
        }
      } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW])) {
        y = -vx;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          yd[nd] = -vxd[nd];
        }
      } else {
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW];
        t38 = vx * vx / p4;
        p4inv = 1.0 / p4;
        y = 0.5 * (p4 + t38);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p4d, t38d;

          p4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW][nd];
          t38d = (vxd[nd] * vx + vx * vxd[nd] - t38 * p4d) * p4inv;
          yd[nd] = 0.5 * (p4d + t38d);
        }
      }
      speed2 = y;
      kappa = (omega * re - vx) / speed2;
      speed2inv = 1.0 / speed2;
      a2 = (v20 * L0 + v21 * L1 + v22 * L2) / speed2;
      gamma = atan2(z21, z22);
      c30 = z22 / (z22 * z22 + z21 * z21);
      c31 = -(z21 / (z22 * z22 + z21 * z21));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double speed2d;

        speed2d = yd[nd];
        kappad[nd] = (omegad[nd] * re + omega * red[nd] - vxd[nd] - kappa * speed2d) * speed2inv;
        a2d[nd] = (v20d[nd] * L0 + v20 * L0d[nd] + (v21d[nd] * L1 + v21 * L1d[nd]) + (v22d[nd] * L2
            + v22 * L2d[nd]) - a2 * speed2d) * speed2inv;
        gammad[nd] = c30 * z21d[nd] + c31 * z22d[nd];
      }
      if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z20) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
          MAGGI_TYRE_UNLOADED_RADIUS])) {
        one0 = kappa;
        one1 = side * a2;
        one2 = side * gamma;
        one3 = fz;
        one4 = vx;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          one0d[nd] = kappad[nd];
          one1d[nd] = side * a2d[nd];
          one2d[nd] = side * gammad[nd];
          one3d[nd] = fzd[nd];
          one4d[nd] = vxd[nd];
        }
        if (t->wheelgrip[n2]) {
          kappa2 = one0;
          a3 = one1;
          gamma2 = one2;
          fz2 = one3;
          fz0_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          r0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          dfz = (fz2 - fz0_2) / fz0_2;
          fz0_2inv = 1.0 / fz0_2;
          kx = kappa2 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
          gx = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
          cx = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LCX];
          mux = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] *
              gx * gx) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          dx = mux * fz2;
          e3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz *
              dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double gxd, muxd;

            kappa2d[nd] = one0d[nd];
            a3d[nd] = one1d[nd];
            gamma2d[nd] = one2d[nd];
            fz2d[nd] = one3d[nd];
            fz0_2d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO][nd] *
                p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO]
                * pd[t->tyreadr[t->wheeltyre[n2]]][nd];
            r0d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS][nd];
            dfzd[nd] = (fz2d[nd] - fz0_2d[nd] - dfz * fz0_2d[nd]) * fz0_2inv;
            /* Fx0, Kx */
            kxd[nd] = kappa2d[nd] + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfzd[nd])) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX][nd]);
            gxd = gamma2d[nd] * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] + gamma2 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX][nd];
            cxd[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1][nd] *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PCX1] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX][nd];
            muxd = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd[nd])) * (1.0 -
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx) -
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3][nd]
                * gx + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gxd) * gx +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gxd)) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz) * (1.0
                - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx) *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX][nd];
            dxd[nd] = muxd * fz2 + mux * fz2d[nd];
            e3d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfzd[nd]) +
                ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfzd[nd]) * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz * dfzd[nd])) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX][nd];
          }
          if (MAGGI_RE(kx) > 0.0) {
            e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              e4d[nd] = e3d[nd] * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) - e3 *
                  pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4][nd];
            }
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e4) > 1.0) {
              y3 = 1.0;
#pragma omp simd
              for (nd = 0; nd < MAGGI_NDIR; ++nd) {
                y3d[nd] = 0.0;
              }
            } else {
              y3 = e4;
#pragma omp simd
              for (nd = 0; nd < MAGGI_NDIR; ++nd) {
                y3d[nd] = e4d[nd];
              }
            }
            ex = y3;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              exd[nd] = y3d[nd];
            }
          } else {
            e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              e5d[nd] = e3d[nd] * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) + e3 *
                  pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4][nd];
            }
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e5) > 1.0) {
              y4 = 1.0;
#pragma omp simd
              for (nd = 0; nd < MAGGI_NDIR; ++nd) {
                y4d[nd] = 0.0;
              }
            } else {
              y4 = e5;
#pragma omp simd
              for (nd = 0; nd < MAGGI_NDIR; ++nd) {
                y4d[nd] = e5d[nd];
              }
            }
            ex = y4;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              exd[nd] = y4d[nd];
            }
          }
          t39 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
          t40 = exp(t39);
          stiff = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t40 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          t41 = cx * dx;
          bx = stiff / t41;
          t41inv = 1.0 / t41;
          svx = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUX];
          y5 = bx * kx;
          t42 = atan(y5);
          c32 = 1.0 / (1.0 + y5 * y5);
          t43 = (1.0 - ex) * y5 + ex * t42;
          t44 = atan(t43);
          c33 = 1.0 / (1.0 + t43 * t43);
          t45 = cx * t44;
          t46 = sin(t45);
          c34 = cos(t45);
          x50 = dx * t46 + svx;
          x51 = stiff;
          fz0_3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          gy = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
          shy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] * gy;
          ay = a3 + shy;
          cy = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LCY];
          muy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] *
              gy * gy) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          dy = muy * fz2;
          e6 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double bxd, stiffd, svxd, t39d, t40d, t41d, t42d, t43d, t44d, t45d, t46d, y5d;

            t39d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfzd[nd];
            t40d = t40 * t39d;
            stiffd = ((fz2d[nd] * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd[nd]))) * t40 + fz2 *
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_PKX2] * dfz) * t40d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX]
                + fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t40 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX][nd];
            t41d = cxd[nd] * dx + cx * dxd[nd];
            bxd = (stiffd - bx * t41d) * t41inv;
            svxd = ((fz2d[nd] * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd[nd]))) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + fz2 *
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_PVX2] * dfz) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX][nd]) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + fz2 *
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX][nd];
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y5d = bxd * kx + bx * kxd[nd];
            t42d = c32 * y5d;
            t43d = -(exd[nd] * y5) + (1.0 - ex) * y5d + (exd[nd] * t42 + ex * t42d);
            t44d = c33 * t43d;
            t45d = cxd[nd] * t44 + cx * t44d;
            t46d = c34 * t45d;
            x50d[nd] = dxd[nd] * t46 + dx * t46d + svxd;
            x51d[nd] = stiffd;
            /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
            fz0_3d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO][nd] *
                p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO]
                * pd[t->tyreadr[t->wheeltyre[n2]]][nd];
            gyd[nd] = gamma2d[nd] * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] + gamma2 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY][nd];
            shyd[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfzd[nd])) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz) *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3][nd] * gy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] * gyd[nd]);
            ayd[nd] = a3d[nd] + shyd[nd];
            cyd[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1][nd] *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PCY1] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY][nd];
            muyd[nd] = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd[nd])) * (1.0 -
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy) -
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3][nd]
                * gy + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gyd[nd]) * gy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gyd[nd])) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz) * (1.0
                - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy) *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY][nd];
            dyd[nd] = muyd[nd] * fz2 + muy * fz2d[nd];
            e6d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfzd[nd])) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz) *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY][nd];
          }
          if (MAGGI_RE(ay) > 0.0) {
            e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              e7d[nd] = e6d[nd] * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                  p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy)) - e6 *
                  (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3][nd] +
                  (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4][nd] * gy +
                  p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gyd[nd]));
            }
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e7) > 1.0) {
              y6 = 1.0;
#pragma omp simd
              for (nd = 0; nd < MAGGI_NDIR; ++nd) {
                y6d[nd] = 0.0;
              }
            } else {
              y6 = e7;
#pragma omp simd
              for (nd = 0; nd < MAGGI_NDIR; ++nd) {
                y6d[nd] = e7d[nd];
              }
            }
            ey = y6;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              eyd[nd] = y6d[nd];
            }
          } else {
            e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              e8d[nd] = e6d[nd] * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                  p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy)) + e6 *
                  (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3][nd] +
                  (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4][nd] * gy +
                  p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gyd[nd]));
            }
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e8) > 1.0) {
              y7 = 1.0;
#pragma omp simd
              for (nd = 0; nd < MAGGI_NDIR; ++nd) {
                y7d[nd] = 0.0;
              }
            } else {
              y7 = e8;
#pragma omp simd
              for (nd = 0; nd < MAGGI_NDIR; ++nd) {
                y7d[nd] = e8d[nd];
              }
            }
            ey = y7;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              eyd[nd] = y7d[nd];
            }
          }
          t47 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3;
          z4 = fz2 / t47;
          t47inv = 1.0 / t47;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double t47d;

            t47d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2][nd] * fz0_3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3d[nd];
            z4d[nd] = (fz2d[nd] - z4 * t47d) * t47inv;
          }
          /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
           * where straight running is, and exact from w on */
          if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            y8 = gy;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y8d[nd] = gyd[nd];
            }
          } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            y8 = -gy;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y8d[nd] = -gyd[nd];
            }
          } else {
            p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t48 = p5 * p5;
            z5 = gy * gy / t48;
            t48inv = 1.0 / t48;
            y8 = 0.125 * p5 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              double p5d, t48d, z5d;

              p5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER][nd];
              t48d = p5d * p5 + p5 * p5d;
              z5d = (gyd[nd] * gy + gy * gyd[nd] - z5 * t48d) * t48inv;
              y8d[nd] = (0.125 * p5d * z5 + 0.125 * p5 * z5d) * (15.0 + z5 * (-10.0 + 3.0 * z5)) +
                  0.125 * p5 * z5 * (z5d * (-10.0 + 3.0 * z5) + z5 * (3.0 * z5d));
            }
          }
          t49 = 1.0 + z4 * z4;
          t50 = 2.0 * z4 / t49;
          t49inv = 1.0 / t49;
          stiff2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          t51 = cy * dy;
          by = stiff2 / t51;
          t51inv = 1.0 / t51;
          svy = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          y9 = by * ay;
          t52 = atan(y9);
          c35 = 1.0 / (1.0 + y9 * y9);
          t53 = (1.0 - ey) * y9 + ey * t52;
          t54 = atan(t53);
          c36 = 1.0 / (1.0 + t53 * t53);
          t55 = cy * t54;
          t56 = sin(t55);
          c37 = cos(t55);
          y20 = dy * t56 + svy;
          y21 = stiff2;
          y22 = muy;
          y23 = by * cy;
          t57 = svy / stiff2;
          stiff2inv = 1.0 / stiff2;
          y24 = shy + t57;
          muy2 = y22;
          x6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          t58 = 1.0 + x6 * x6;
          t59 = sqrt(t58);
          c38 = 1.0 / (2.0 * t59);
          t60 = 1.0 / t59;
          t59inv = 1.0 / t59;
          stiff3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          e10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_REY2] * dfz;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double byd, stiff2d, svyd, t49d, t50d, t51d, t52d, t53d, t54d, t55d, t56d, t57d, t58d,
                t59d, t60d, x6d, y22d, y9d;

            t49d = z4d[nd] * z4 + z4 * z4d[nd];
            t50d = (2.0 * z4d[nd] - t50 * t49d) * t49inv;
            stiff2d = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1][nd] * fz0_3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3d[nd]) * t50 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50d) * (1.0 -
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) -
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3][nd] * y8 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8d[nd])) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PKY1] * fz0_3 * t50 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PKY3] * y8) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY][nd];
            t51d = cyd[nd] * dy + cy * dyd[nd];
            byd = (stiff2d - by * t51d) * t51inv;
            svyd = (fz2d[nd] * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) +
                fz2 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd[nd])) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY][nd] +
                ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd[nd])) * gy +
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_PVY4] * dfz) * gyd[nd]))) * p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_LMUY] + fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY][nd];
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y9d = byd * ay + by * ayd[nd];
            t52d = c35 * y9d;
            t53d = -(eyd[nd] * y9) + (1.0 - ey) * y9d + (eyd[nd] * t52 + ey * t52d);
            t54d = c36 * t53d;
            t55d = cyd[nd] * t54 + cy * t54d;
            t56d = c37 * t55d;
            y20d[nd] = dyd[nd] * t56 + dy * t56d + svyd;
            y21d[nd] = stiff2d;
            y22d = muyd[nd];
            y23d[nd] = byd * cy + by * cyd[nd];
            t57d = (svyd - t57 * stiff2d) * stiff2inv;
            y24d[nd] = shyd[nd] + t57d;
            muy2d[nd] = y22d;
            /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
            x6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2][nd] * (a3 -
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_RBY2] * (a3d[nd] - pd[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_RBY3][nd]);
            t58d = x6d * x6 + x6 * x6d;
            t59d = c38 * t58d;
            t60d = -(t60 * t59d * t59inv);
            stiff3d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1][nd] * t60 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60d) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_RBY1] * t60 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA][nd];
            e10d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] * dfzd[nd]);
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e10) > 1.0) {
            y10 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y10d[nd] = 0.0;
            }
          } else {
            y10 = e10;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y10d[nd] = e10d[nd];
            }
          }
          e9 = y10;
          s4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RHY2] * dfz;
          x7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] * a3;
          t61 = 1.0 + x7 * x7;
          t62 = sqrt(t61);
          c39 = 1.0 / (2.0 * t62);
          t63 = 1.0 / t62;
          t62inv = 1.0 / t62;
          dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) * t63;
          y11 = stiff3 * (kappa2 + s4);
          y12 = stiff3 * s4;
          t64 = atan(y11);
          c40 = 1.0 / (1.0 + y11 * y11);
          t65 = (1.0 - e9) * y11 + e9 * t64;
          t66 = atan(t65);
          c41 = 1.0 / (1.0 + t65 * t65);
          p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
          t67 = p6 * t66;
          t68 = cos(t67);
          c42 = -sin(t67);
          t69 = atan(y12);
          c43 = 1.0 / (1.0 + y12 * y12);
          t70 = (1.0 - e9) * y12 + e9 * t69;
          t71 = atan(t70);
          c44 = 1.0 / (1.0 + t70 * t70);
          t72 = p6 * t71;
          t73 = cos(t72);
          c45 = -sin(t72);
          g30 = t68 / t73;
          t73inv = 1.0 / t73;
          t74 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2;
          t75 = atan(t74);
          c46 = 1.0 / (1.0 + t74 * t74);
          t76 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t75;
          t77 = sin(t76);
          c47 = cos(t76);
          g31 = dv * t77 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          x8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2;
          t78 = 1.0 + x8 * x8;
          t79 = sqrt(t78);
          c48 = 1.0 / (2.0 * t79);
          t80 = 1.0 / t79;
          t79inv = 1.0 / t79;
          stiff4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          e12 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_REX2] * dfz;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double dvd, e9d, p6d, s4d, t61d, t62d, t63d, t64d, t65d, t66d, t67d, t68d, t69d, t70d,
                t71d, t72d, t73d, t74d, t75d, t76d, t77d, t78d, t79d, t80d, x7d, x8d, y11d, y12d;

            e9d = y10d[nd];
            s4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfzd[nd]);
            x7d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4][nd] * a3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] * a3d[nd];
            t61d = x7d * x7 + x7 * x7d;
            t62d = c39 * t61d;
            t63d = -(t63 * t62d * t62inv);
            dvd = ((muy2d[nd] * fz2 + muy2 * fz2d[nd]) * (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) + muy2 * fz2 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd[nd]) +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3][nd] * gamma2 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2d[nd]))) * t63 + muy2 *
                fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) * t63d;
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y11d = stiff3d[nd] * (kappa2 + s4) + stiff3 * (kappa2d[nd] + s4d);
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y12d = stiff3d[nd] * s4 + stiff3 * s4d;
            t64d = c40 * y11d;
            t65d = -(e9d * y11) + (1.0 - e9) * y11d + (e9d * t64 + e9 * t64d);
            t66d = c41 * t65d;
            p6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1][nd];
            t67d = p6d * t66 + p6 * t66d;
            t68d = c42 * t67d;
            t69d = c43 * y12d;
            t70d = -(e9d * y12) + (1.0 - e9) * y12d + (e9d * t69 + e9 * t69d);
            t71d = c44 * t70d;
            t72d = p6d * t71 + p6 * t71d;
            t73d = c45 * t72d;
            g30d[nd] = (t68d - g30 * t73d) * t73inv;
            t74d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6][nd] * kappa2 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2d[nd];
            t75d = c46 * t74d;
            t76d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5][nd] * t75 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t75d;
            t77d = c47 * t76d;
            g31d[nd] = (dvd * t77 + dv * t77d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA]
                + dv * t77 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA][nd];
            /* Gxa = Fx / Fx0 */
            x8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2][nd] * kappa2 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2d[nd];
            t78d = x8d * x8 + x8 * x8d;
            t79d = c48 * t78d;
            t80d = -(t80 * t79d * t79inv);
            stiff4d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1][nd] * t80 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80d) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_RBX1] * t80 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL][nd];
            e12d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] * dfzd[nd]);
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e12) > 1.0) {
            y13 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y13d[nd] = 0.0;
            }
          } else {
            y13 = e12;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y13d[nd] = e12d[nd];
            }
          }
          e11 = y13;
          p7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
          y14 = stiff4 * (a3 + p7);
          y15 = stiff4 * p7;
          t81 = atan(y14);
          c49 = 1.0 / (1.0 + y14 * y14);
          t82 = (1.0 - e11) * y14 + e11 * t81;
          t83 = atan(t82);
          c50 = 1.0 / (1.0 + t82 * t82);
          p8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
          t84 = p8 * t83;
          t85 = cos(t84);
          c51 = -sin(t84);
          t86 = atan(y15);
          c52 = 1.0 / (1.0 + y15 * y15);
          t87 = (1.0 - e11) * y15 + e11 * t86;
          t88 = atan(t87);
          c53 = 1.0 / (1.0 + t87 * t87);
          t89 = p8 * t88;
          t90 = cos(t89);
          c54 = -sin(t89);
          t91 = t85 / t90;
          t90inv = 1.0 / t90;
          fx = x50 * t91;
          fy = g30 * y20 + g31;
          ratio2 = x51 * kappa2 / y21;
          y21inv = 1.0 / y21;
          bycy = y23;
          shift = y24;
          fz0_4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          gz = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ];
          at = a3 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] * dfz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QHZ4] * dfz) * gz;
          ar = a3 + shift;
          t92 = at * at + ratio2 * ratio2 + 1e-24;
          ateq = sqrt(t92);
          c55 = 1.0 / (2.0 * ateq);
          t93 = ar * ar + ratio2 * ratio2 + 1e-24;
          areq = sqrt(t93);
          c56 = 1.0 / (2.0 * areq);
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double ard, e11d, p7d, p8d, ratio2d, shiftd, t81d, t82d, t83d, t84d, t85d, t86d, t87d,
                t88d, t89d, t90d, t91d, t92d, t93d, y14d, y15d;

            e11d = y13d[nd];
            p7d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1][nd];
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y14d = stiff4d[nd] * (a3 + p7) + stiff4 * (a3d[nd] + p7d);
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y15d = stiff4d[nd] * p7 + stiff4 * p7d;
            t81d = c49 * y14d;
            t82d = -(e11d * y14) + (1.0 - e11) * y14d + (e11d * t81 + e11 * t81d);
            t83d = c50 * t82d;
            p8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1][nd];
            t84d = p8d * t83 + p8 * t83d;
            t85d = c51 * t84d;
            t86d = c52 * y15d;
            t87d = -(e11d * y15) + (1.0 - e11) * y15d + (e11d * t86 + e11 * t86d);
            t88d = c53 * t87d;
            t89d = p8d * t88 + p8 * t88d;
            t90d = c54 * t89d;
            t91d = (t85d - t91 * t90d) * t90inv;
            fxd[nd] = x50d[nd] * t91 + x50 * t91d;
            fyd[nd] = g30d[nd] * y20 + g30 * y20d[nd] + g31d[nd];
            ratio2d = (x51d[nd] * kappa2 + x51 * kappa2d[nd] - ratio2 * y21d[nd]) * y21inv;
            bycyd[nd] = y23d[nd];
            shiftd = y24d[nd];
            /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
             *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
            fz0_4d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO][nd] *
                p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO]
                * pd[t->tyreadr[t->wheeltyre[n2]]][nd];
            gzd[nd] = gamma2d[nd] * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ] + gamma2 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ][nd];
            atd[nd] = a3d[nd] + pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] * dfzd[nd]) +
                ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] * dfzd[nd])) * gz +
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QHZ4] * dfz) * gzd[nd]);
            ard = a3d[nd] + shiftd;
            t92d = atd[nd] * at + at * atd[nd] + (ratio2d * ratio2 + ratio2 * ratio2d);
            ateqd[nd] = c55 * t92d;
            t93d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
            areqd[nd] = c56 * t93d;
          }
          /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
           * where straight running is, and exact from w on */
          if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            y16 = gz;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y16d[nd] = gzd[nd];
            }
          } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            y16 = -gz;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y16d[nd] = -gzd[nd];
            }
          } else {
            p9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t94 = p9 * p9;
            z6 = gz * gz / t94;
            t94inv = 1.0 / t94;
            y16 = 0.125 * p9 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              double p9d, t94d, z6d;

              p9d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER][nd];
              t94d = p9d * p9 + p9 * p9d;
              z6d = (gzd[nd] * gz + gz * gzd[nd] - z6 * t94d) * t94inv;
              y16d[nd] = (0.125 * p9d * z6 + 0.125 * p9 * z6d) * (15.0 + z6 * (-10.0 + 3.0 * z6)) +
                  0.125 * p9 * z6 * (z6d * (-10.0 + 3.0 * z6) + z6 * (3.0 * z6d));
            }
          }
          bt = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUY];
          inv = 1.0 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          t95 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
          fz0_4inv = 1.0 / fz0_4;
          dt = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          t96 = bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * at;
          t97 = atan(t96);
          c57 = 1.0 / (1.0 + t96 * t96);
          e13 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
              dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t97);
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double t95d, t96d, t97d;

            btd[nd] = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfzd[nd]) +
                ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfzd[nd]) * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfzd[nd])) * (1.0 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) +
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
                dfz) * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4][nd] * gz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gzd[nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5][nd] * y16 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16d[nd]))) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY][nd] - bt *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY][nd]) * inv;
            t95d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS][nd] - t95 *
                fz0_4d[nd]) * fz0_4inv;
            dtd[nd] = (((fz2d[nd] * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfzd[nd]))) * (1.0 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) + fz2 *
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3][nd]
                * gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gzd[nd] +
                ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4][nd] * gz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gzd[nd]) * gz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gzd[nd]))) * t95 + fz2 *
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3]
                * gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95d) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] + fz2 *
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3]
                * gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR][nd];
            t96d = (btd[nd] * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] + bt *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1][nd]) * at + bt *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * atd[nd];
            t97d = c57 * t96d;
            e13d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfzd[nd]) +
                ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfzd[nd]) * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfzd[nd])) * (1.0 +
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t97) +
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
                dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5][nd] * gz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gzd[nd])) *
                0.63661977236758134308 * t97 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
                t97d);
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e13) > 1.0) {
            y17 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y17d[nd] = 0.0;
            }
          } else {
            y17 = e13;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y17d[nd] = e13d[nd];
            }
          }
          et = y17;
          p10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          t98 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LKY] / p10;
          p10inv = 1.0 / p10;
          br = t98 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycy;
          dr = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] * p10;
          t99 = 1.0 + a3 * a3;
          t100 = sqrt(t99);
          c58 = 1.0 / (2.0 * t100);
          ca = 1.0 / t100;
          t100inv = 1.0 / t100;
          y18 = bt * ateq;
          t101 = atan(y18);
          c59 = 1.0 / (1.0 + y18 * y18);
          t102 = (1.0 - et) * y18 + et * t101;
          t103 = atan(t102);
          c60 = 1.0 / (1.0 + t102 * t102);
          t104 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t103;
          t105 = cos(t104);
          c61 = -sin(t104);
          z30 = dt * t105 * ca;
          x9 = br * areq;
          t106 = 1.0 + x9 * x9;
          t107 = sqrt(t106);
          c62 = 1.0 / (2.0 * t107);
          t108 = 1.0 / t107;
          t107inv = 1.0 / t107;
          t109 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
          s3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t109 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LS];
          t110 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          inv2 = 1.0 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          way = tanh(t110);
          speed3 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          inv3 = 1.0 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          t111 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
          t112 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double brd, cad, drd, etd, force0d, force1d, force2d, force3d, force4d, force5d, p10d,
                s3d, speed3d, t100d, t101d, t102d, t103d, t104d, t105d, t106d, t107d, t108d, t109d,
                t110d, t111d, t112d, t98d, t99d, wayd, x9d, y18d, z30d, z31d;

            etd = y17d[nd];
            p10d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY][nd];
            t98d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9][nd] *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_QBZ9] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY][nd] - t98 *
                p10d) * p10inv;
            brd = t98d + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10][nd] * bycy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycyd[nd]);
            drd = ((fz2d[nd] * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz)
                + fz2 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfzd[nd])) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES][nd] +
                ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfzd[nd])) * gz +
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QDZ9] * dfz) * gzd[nd]))) * p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_UNLOADED_RADIUS] + fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz)
                * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS][nd]) * p10 + fz2 *
                ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] +
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_UNLOADED_RADIUS] * p10d;
            t99d = a3d[nd] * a3 + a3 * a3d[nd];
            t100d = c58 * t99d;
            cad = -(ca * t100d * t100inv);
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y18d = btd[nd] * ateq + bt * ateqd[nd];
            t101d = c59 * y18d;
            t102d = -(etd * y18) + (1.0 - et) * y18d + (etd * t101 + et * t101d);
            t103d = c60 * t102d;
            t104d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1][nd] * t103 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t103d;
            t105d = c61 * t104d;
            z30d = (dtd[nd] * t105 + dt * t105d) * ca + dt * t105 * cad;
            x9d = brd * areq + br * areqd[nd];
            t106d = x9d * x9 + x9 * x9d;
            t107d = c62 * t106d;
            t108d = -(t108 * t107d * t107inv);
            z31d = (drd * t108 + dr * t108d) * ca + dr * t108 * cad;
            t109d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2][nd] * fy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fyd[nd] - t109 * fz0_2d[nd]) *
                fz0_2inv;
            s3d = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1][nd] + t109d +
                ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfzd[nd])) * gamma2 +
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_SSZ4] * dfz) * gamma2d[nd])) * r0 + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_SSZ1] + t109 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0d[nd]) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_SSZ1] + t109 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS][nd];
            t110d = (one4d[nd] - t110 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED][nd])
                * inv2;
            wayd = (1.0 - way * way) * t110d;
            speed3d = (one4d[nd] - speed3 * pd[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_LONGVL][nd]) * inv3;
            force0d = fxd[nd];
            force1d = fyd[nd];
            force2d = fz2d[nd];
            t111d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3][nd] * fy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fyd[nd] - t111 * fz0_2d[nd]) *
                fz0_2inv;
            force3d = (r0d[nd] * fz2 + r0 * fz2d[nd]) * (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_QSX1] * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] +
                (-p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2 + t111) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX]) + r0 * fz2 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1][nd] *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_QSX1] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX][nd] +
                ((-(pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2][nd] * gamma2) -
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2d[nd] + t111d) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QSX2] * gamma2 + t111) * pd[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_LMX][nd]));
            t112d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2][nd] * fx +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fxd[nd] - t112 * fz0_2d[nd]) *
                fz0_2inv;
            force4d = (((-(wayd * r0) - way * r0d[nd]) * fz2 + -way * r0 * fz2d[nd]) *
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
                speed3) + -way * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1][nd]
                + t112d + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3][nd] * way +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3d) +
                ((((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4][nd] * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) *
                speed3 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 *
                speed3 * speed3d))) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY] + -way * r0 *
                fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
                speed3) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY][nd];
            force5d = -(z30d * (fy - g31)) - z30 * (fyd[nd] - g31d[nd]) + z31d + (s3d * fx + s3 *
                fxd[nd]);
            rolling0d[nd] = force0d;
            rolling1d[nd] = side * force1d;
            rolling2d[nd] = force2d;
            rolling3d[nd] = side * force3d;
            rolling4d[nd] = force4d;
            rolling5d[nd] = side * force5d;
          }
        } else {
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            rolling0d[nd] = 0.0;
            rolling1d[nd] = 0.0;
            rolling2d[nd] = fzd[nd];
            rolling3d[nd] = 0.0;
            rolling4d[nd] = 0.0;
            rolling5d[nd] = 0.0;
          }
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          rolling0d[nd] = 0.0;
          rolling1d[nd] = 0.0;
          rolling2d[nd] = 0.0;
          rolling3d[nd] = 0.0;
          rolling4d[nd] = 0.0;
          rolling5d[nd] = 0.0;
        }
      }
      slip1 = a2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        slip0d[nd] = kappad[nd];
        slip1d[nd] = a2d[nd];
        slip2d[nd] = gammad[nd];
      }
      if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_SLIP) {
        c63 = 1.0 / (1.0 + slip1 * slip1);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][0][nd] = slip0d[nd];
          sd[i][1][nd] = c63 * slip1d[nd];
          sd[i][2][nd] = slip2d[nd];
        }
      } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_FORCE) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][0][nd] = rolling0d[nd];
          sd[i][1][nd] = rolling1d[nd];
          sd[i][2][nd] = rolling2d[nd];
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][0][nd] = rolling3d[nd];
          sd[i][1][nd] = rolling4d[nd];
          sd[i][2][nd] = rolling5d[nd];
        }
      }
    }
  }
}
