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
                      const double lambda[restrict t->nrow],
                      const double lambdad[restrict t->nrow][MAGGI_NDIR],
                      const double slip[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                      const double slipd[restrict t->nwheel][MAGGI_SLIP_NUMBERS][MAGGI_NDIR],
                      const double grip[restrict t->nwheel][6],
                      const double gripd[restrict t->nwheel][6][MAGGI_NDIR],
                      double s[restrict t->nsensor][3],
                      double sd[restrict t->nsensor][3][MAGGI_NDIR], int nbdirs)
{
  int a, a3, a3_2, b, b7, i, j, k, k3, n2, nd;
  double A_j0, A_j0_2, A_j0_3, A_j0_4, A_j3, A_j3_2, A_j3_3, A_j3_4, A_j7, A_j8, Z_j3, Z_j4, a2, ay,
      b2, b3, b4, b5, b6, c, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c2, c20, c21, c22,
      c23, c24, c25, c26, c27, c28, c29, c2inv, c3, c30, c31, c32, c33, c34, c35, c36, c37, c38,
      c39, c4, c40, c41, c42, c43, c44, c45, c46, c47, c48, c49, c5, c50, c51, c52, c53, c54, c55,
      c56, c57, c58, c59, c6, c60, c61, c62, c63, c64, c65, c66, c67, c68, c69, c7, c70, c71, c72,
      c73, c74, c75, c76, c77, c78, c79, c8, c9, d, dfz, dv, e0, e1, e10, e11, e12, e20, e21, e22,
      e2_2, e3, e4, e5, e6, e7, e8, e9, ev0, ev1, ev20, ev21, ev22, ev2_2, ex, ey, fx, fy, fz, fz0,
      fz0_2, fz0inv, g0, g0_2, g0_3, g0_4, g1, g1_2, g1_3, g1_4, g20, g21, g22, g23, g24, g25, g26,
      g27, g28, g2_2, g2_5, gamma, gx, gx2, gy, gy2, h, h2, h2inv, h3, h3inv, hinv, ka, kappa, kx,
      l, l2, l2inv, l3, linv, lv, m, mux, muy, n30, n31, n32, n40, n41, n42, n5, n5inv, n6, n6inv,
      one0, one1, one2, one3, p2, p3, p4, p5, p6, p_i, p_i1, p_i2, p_i3, p_k34, p_k35, peak, r2,
      r2inv, roll, rv_k0, rv_k0_2, rv_k0_3, rv_k1, rv_k1_2, rv_k1_3, rv_k2, s2, s3, shift, shift2,
      side, t10, t100, t100inv, t101, t102, t102inv, t103, t104, t104inv, t105, t106, t107, t108,
      t109, t11, t110, t111, t111inv, t112, t113, t114, t115, t116, t117, t118, t119, t119inv,
      t11inv, t12, t120, t121, t122, t122inv, t123, t124, t124inv, t125, t126, t127, t128, t129,
      t130, t131, t131inv, t132, t133, t133inv, t134, t135, t136, t136inv, t137, t138, t138inv,
      t139, t14, t140, t141, t142, t143, t144, t145, t145inv, t146, t147, t147inv, t148, t14inv,
      t15, t16, t17, t18, t19, t2, t20, t20inv, t21, t22, t23, t24, t25, t25inv, t26, t26inv, t27,
      t27inv, t28, t29, t2inv, t3, t30, t30inv, t31, t32, t33, t33inv, t34, t35, t36, t36inv, t37,
      t38, t39, t4, t40, t41, t42, t43, t44, t45, t46, t47, t48, t49, t4inv, t5, t50, t51, t51inv,
      t52, t53, t54, t55, t56, t57, t58, t59, t6, t60, t61, t61inv, t62, t63, t64, t65, t66, t67,
      t68, t69, t6inv, t7, t70, t70inv, t71, t72, t72inv, t73, t74, t75, t76, t77, t77inv, t78, t79,
      t79inv, t8, t80, t81, t81inv, t82, t83, t84, t85, t86, t87, t88, t89, t8inv, t9, t90, t91,
      t91inv, t92, t93, t93inv, t94, t95, t96, t97, t98, t98inv, t99, u20, u21, ux, uy, v2, w, wx1,
      wy1, x2, x30, x30inv, x31, x32, x33, x34, x35, x4, x5, x6, x7, x8, x9, xv, y0, y0_2, y0_3,
      y0_3inv, y1, y10, y11, y12, y13, y14, y15, y16, y17, y18, y2, y2_2, y3, y3_2, y4, y4_2, y5,
      y5_2, y6, y7, y8, y9, z0, z0_2, z10, z11, z1_3, z2, z3, z4, z5, z6, z7, z8, z9;
  double a2d[MAGGI_NDIR], ayd[MAGGI_NDIR], dampingd[MAGGI_NDIR], dd[MAGGI_NDIR], dfzd[MAGGI_NDIR],
      e10d[MAGGI_NDIR], e3d[MAGGI_NDIR], e4d[MAGGI_NDIR], e5d[MAGGI_NDIR], e6d[MAGGI_NDIR],
      e7d[MAGGI_NDIR], e8d[MAGGI_NDIR], e9d[MAGGI_NDIR], exd[MAGGI_NDIR], eyd[MAGGI_NDIR],
      f0d[MAGGI_NDIR], f1d[MAGGI_NDIR], f2d[MAGGI_NDIR], fz0_2d[MAGGI_NDIR], fzd[MAGGI_NDIR],
      g0_2d[MAGGI_NDIR], g1_2d[MAGGI_NDIR], g20d[MAGGI_NDIR], g21d[MAGGI_NDIR], g22d[MAGGI_NDIR],
      g23d[MAGGI_NDIR], g24d[MAGGI_NDIR], g25d[MAGGI_NDIR], gammad[MAGGI_NDIR], gy2d[MAGGI_NDIR],
      kappad[MAGGI_NDIR], kxd[MAGGI_NDIR], ld[MAGGI_NDIR], lvd[MAGGI_NDIR], muxd[MAGGI_NDIR],
      muyd[MAGGI_NDIR], peakd[MAGGI_NDIR], r2d[MAGGI_NDIR], sumd[MAGGI_NDIR], u20d[MAGGI_NDIR],
      u21d[MAGGI_NDIR], x2d[MAGGI_NDIR], x30d[MAGGI_NDIR], x31d[MAGGI_NDIR], x32d[MAGGI_NDIR],
      x33d[MAGGI_NDIR], x34d[MAGGI_NDIR], x35d[MAGGI_NDIR], xvd[MAGGI_NDIR], y0_3d[MAGGI_NDIR],
      y1d[MAGGI_NDIR], y2_2d[MAGGI_NDIR], y2d[MAGGI_NDIR], y3_2d[MAGGI_NDIR], y3d[MAGGI_NDIR],
      y4_2d[MAGGI_NDIR], y4d[MAGGI_NDIR], y5_2d[MAGGI_NDIR], y5d[MAGGI_NDIR], y6d[MAGGI_NDIR],
      y7d[MAGGI_NDIR], y8d[MAGGI_NDIR], z2d[MAGGI_NDIR];

  (void)origin;
  (void)x;
  (void)Za;
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
      c5 = 1.0 / (2.0 * t4);
      t4inv = 1.0 / t4;
      t5 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + w;
      t6 = sqrt(t5);
      c6 = 1.0 / (2.0 * t6);
      t6inv = 1.0 / t6;
      t7 = g0 * g0 + g1 * g1 + p_i1 * p_i1;
      t8 = sqrt(t7);
      c7 = 1.0 / (2.0 * t8);
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
        t4d = c5 * t3d;
        sd[i][0][nd] = (n30d * n30 + n30 * n30d + (n31d * n31 + n31 * n31d) + (n32d * n32 + n32 *
            n32d) - s[i][0] * t4d) * t4inv;
        t5d = rv_k0d * rv_k0 + rv_k0 * rv_k0d + (rv_k1d * rv_k1 + rv_k1 * rv_k1d) + wd;
        t6d = c6 * t5d;
        sd[i][1][nd] = (rv_k0d * g1 + rv_k0 * g1d - (rv_k1d * g0 + rv_k1 * g0d) - s[i][1] * t6d) *
            t6inv;
        t7d = g0d * g0 + g0 * g0d + (g1d * g1 + g1 * g1d) + (p_i1d * p_i1 + p_i1 * p_i1d);
        t8d = c7 * t7d;
        sd[i][2][nd] = (g0d * g0 + g0 * g0d + (g1d * g1 + g1 * g1d) - s[i][2] * t8d) * t8inv;
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SIDESLIP) {
      g0_2 = ra[k][0] + p[0];
      g1_2 = ra[k][1] + p[1];
      A_j0 = A[j][0];
      A_j3 = A[j][3];
      t9 = A_j0 * A_j0 + A_j3 * A_j3;
      h = sqrt(t9);
      c8 = 1.0 / (2.0 * h);
      rv_k0_2 = rv[k][0];
      rv_k1_2 = rv[k][1];
      u20 = (A_j0 * rv_k0_2 + A_j3 * rv_k1_2) / h;
      hinv = 1.0 / h;
      u21 = (A_j0 * rv_k1_2 - A_j3 * rv_k0_2) / h;
      p_i2 = p[t->sensoradr[i]];
      t10 = u20 * u20 + u21 * u21 + p_i2 * p_i2;
      r2 = sqrt(t10);
      c9 = 1.0 / (2.0 * r2);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j0d, A_j3d, hd, p_i2d, rv_k0_2d, rv_k1_2d, t10d, t9d;

        g0_2d[nd] = rad[k][0][nd] + pd[0][nd];
        g1_2d[nd] = rad[k][1][nd] + pd[1][nd];
        A_j0d = Ad[j][0][nd];
        A_j3d = Ad[j][3][nd];
        t9d = A_j0d * A_j0 + A_j0 * A_j0d + (A_j3d * A_j3 + A_j3 * A_j3d);
        hd = c8 * t9d;
        rv_k0_2d = rvd[k][0][nd];
        rv_k1_2d = rvd[k][1][nd];
        u20d[nd] = (A_j0d * rv_k0_2 + A_j0 * rv_k0_2d + (A_j3d * rv_k1_2 + A_j3 * rv_k1_2d) - u20 *
            hd) * hinv;
        u21d[nd] = (A_j0d * rv_k1_2 + A_j0 * rv_k1_2d - (A_j3d * rv_k0_2 + A_j3 * rv_k0_2d) - u21 *
            hd) * hinv;
        p_i2d = pd[t->sensoradr[i]][nd];
        t10d = u20d[nd] * u20 + u20 * u20d[nd] + (u21d[nd] * u21 + u21 * u21d[nd]) + (p_i2d * p_i2 +
            p_i2 * p_i2d);
        r2d[nd] = c9 * t10d;
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
      c10 = d / (d * d + u21 * u21);
      c11 = -(u21 / (d * d + u21 * u21));
      r2inv = 1.0 / r2;
      t14 = r2 * r2 * r2;
      t14inv = 1.0 / t14;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t13d, t14d;

        t13d = c10 * u21d[nd] + c11 * dd[nd];
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
      c12 = 1.0 / (2.0 * h2);
      rv_k0_3 = rv[k][0];
      rv_k1_3 = rv[k][1];
      h2inv = 1.0 / h2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j0_2d, A_j3_2d, h2d, rv_k0_3d, rv_k1_3d, t15d;

        A_j0_2d = Ad[j][0][nd];
        A_j3_2d = Ad[j][3][nd];
        t15d = A_j0_2d * A_j0_2 + A_j0_2 * A_j0_2d + (A_j3_2d * A_j3_2 + A_j3_2 * A_j3_2d);
        h2d = c12 * t15d;
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
      c13 = 1.0 / (2.0 * h3);
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
        h3d = c13 * t16d;
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
      c14 = A_j8 / (A_j8 * A_j8 + A_j7 * A_j7);
      c15 = -(A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      t17 = -A[j][6];
      t18 = A_j7 * A_j7 + A_j8 * A_j8;
      t19 = sqrt(t18);
      c16 = 1.0 / (2.0 * t19);
      c17 = t19 / (t19 * t19 + t17 * t17);
      c18 = -(t17 / (t19 * t19 + t17 * t17));
      c19 = A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]);
      c20 = -(A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j7d, A_j8d, t17d, t18d, t19d;

        A_j7d = Ad[j][7][nd];
        A_j8d = Ad[j][8][nd];
        /* R = Rz(yaw) Ry(pitch) Rx(roll) */
        sd[i][0][nd] = c14 * A_j7d + c15 * A_j8d;
        t17d = -Ad[j][6][nd];
        t18d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
        t19d = c16 * t18d;
        sd[i][1][nd] = c17 * t17d + c18 * t19d;
        sd[i][2][nd] = c19 * Ad[j][3][nd] + c20 * Ad[j][0][nd];
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
      c21 = 1.0 / (2.0 * t20);
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
        t20d = c21 * c2d;
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
      a3 = t->springpa[n2];
      b = t->springpb[n2];
      e0 = r[a3][0] - r[b][0];
      ev0 = rv[a3][0] - rv[b][0];
      e1 = r[a3][1] - r[b][1];
      ev1 = rv[a3][1] - rv[b][1];
      e2_2 = r[a3][2] - r[b][2];
      ev2_2 = rv[a3][2] - rv[b][2];
      t21 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
      l = sqrt(t21);
      c22 = 1.0 / (2.0 * l);
      n40 = e0 / l;
      linv = 1.0 / l;
      n41 = e1 / l;
      n42 = e2_2 / l;
      lv = n40 * ev0 + n41 * ev1 + n42 * ev2_2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e0d, e1d, e2_2d, ev0d, ev1d, ev2_2d, n40d, n41d, n42d, t21d;

        e0d = rd[a3][0][nd] - rd[b][0][nd];
        ev0d = rvd[a3][0][nd] - rvd[b][0][nd];
        e1d = rd[a3][1][nd] - rd[b][1][nd];
        ev1d = rvd[a3][1][nd] - rvd[b][1][nd];
        e2_2d = rd[a3][2][nd] - rd[b][2][nd];
        ev2_2d = rvd[a3][2][nd] - rvd[b][2][nd];
        t21d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
        ld[nd] = c22 * t21d;
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
        double z0_3d, z1d;

        z0_3d = ld[nd];
        z1d = lvd[nd];
        sd[i][0][nd] = z0_3d;
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
        double torque0d, z0_4d, z1_2d;

        torque0d = -(pd[t->jspringadr[n2]][nd] * (x2 - p[t->jspringadr[n2] + MAGGI_JSPRING_REST])) -
            p[t->jspringadr[n2]] * (x2d[nd] - pd[t->jspringadr[n2] + MAGGI_JSPRING_REST][nd]) -
            (pd[t->jspringadr[n2] + MAGGI_JSPRING_C][nd] * xv + p[t->jspringadr[n2] +
            MAGGI_JSPRING_C] * xvd[nd]) - pd[t->jspringadr[n2] + MAGGI_JSPRING_PRELOAD][nd];
        z0_4d = x2d[nd];
        z1_2d = xvd[nd];
        sd[i][0][nd] = z0_4d;
        sd[i][1][nd] = z1_2d;
        sd[i][2][nd] = torque0d;
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ROD) {
      a3_2 = t->primpa[n2];
      b7 = t->primpb[n2];
      e20 = r[a3_2][0] - r[b7][0];
      ev20 = rv[a3_2][0] - rv[b7][0];
      e21 = r[a3_2][1] - r[b7][1];
      ev21 = rv[a3_2][1] - rv[b7][1];
      e22 = r[a3_2][2] - r[b7][2];
      ev22 = rv[a3_2][2] - rv[b7][2];
      t22 = e20 * e20 + e21 * e21 + e22 * e22;
      l2 = sqrt(t22);
      c23 = 1.0 / (2.0 * l2);
      z1_3 = s[i][1];
      l2inv = 1.0 / l2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e20d, e21d, e22d, ev20d, ev21d, ev22d, l2d, t22d, z0_5d, z1_3d;

        /* distance of two points and its rate */
        e20d = rd[a3_2][0][nd] - rd[b7][0][nd];
        ev20d = rvd[a3_2][0][nd] - rvd[b7][0][nd];
        e21d = rd[a3_2][1][nd] - rd[b7][1][nd];
        ev21d = rvd[a3_2][1][nd] - rvd[b7][1][nd];
        e22d = rd[a3_2][2][nd] - rd[b7][2][nd];
        ev22d = rvd[a3_2][2][nd] - rvd[b7][2][nd];
        t22d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 * e22d);
        l2d = c23 * t22d;
        z0_5d = l2d;
        z1_3d = (e20d * ev20 + e20 * ev20d + (e21d * ev21 + e21 * ev21d) + (e22d * ev22 + e22 *
            ev22d) - z1_3 * l2d) * l2inv;
        sd[i][0][nd] = z0_5d;
        sd[i][1][nd] = z1_3d;
        sd[i][2][nd] = lambdad[t->primrow[n2]][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_SLIP) {
      c24 = 1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] * slip[n2][MAGGI_SLIP_TAN_ALPHA]);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = slipd[n2][MAGGI_SLIP_KAPPA][nd];
        sd[i][1][nd] = c24 * slipd[n2][MAGGI_SLIP_TAN_ALPHA][nd];
        sd[i][2][nd] = slipd[n2][MAGGI_SLIP_GAMMA][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_FORCE) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = gripd[n2][0][nd];
        sd[i][1][nd] = gripd[n2][1][nd];
        sd[i][2][nd] = gripd[n2][2][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_MOMENT) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = gripd[n2][3][nd];
        sd[i][1][nd] = gripd[n2][4][nd];
        sd[i][2][nd] = gripd[n2][5][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_CONTACT) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slip_n2d;

        slip_n2d = slipd[n2][MAGGI_SLIP_RADIUS][nd];
        sd[i][0][nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS][nd] - slip_n2d;
        sd[i][1][nd] = slip_n2d;
        sd[i][2][nd] = slipd[n2][MAGGI_SLIP_ROLLING][nd];
      }
    } else {
      side = t->wheelmirror[n2] ? -1.0 : 1.0;
      /* slopes of the formula, which a tyre of the other side has as well; 0 in the air */
      if (MAGGI_RE(grip[n2][2]) > 0.0) {
        one0 = slip[n2][MAGGI_SLIP_KAPPA];
        one1 = side * slip[n2][MAGGI_SLIP_TAN_ALPHA];
        one2 = side * slip[n2][MAGGI_SLIP_GAMMA];
        one3 = grip[n2][2];
        kappa = one0;
        a2 = one1;
        gamma = one2;
        fz = one3;
        fz0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]];
        dfz = (fz - fz0) / fz0;
        fz0inv = 1.0 / fz0;
        kx = kappa + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
        gx2 = gamma * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
        mux = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2
            * gx2) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        e3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double fz0d, gx2d, one0d, one1d, one2d, one3d;

          one0d = slipd[n2][MAGGI_SLIP_KAPPA][nd];
          one1d = side * slipd[n2][MAGGI_SLIP_TAN_ALPHA][nd];
          one2d = side * slipd[n2][MAGGI_SLIP_GAMMA][nd];
          one3d = gripd[n2][2][nd];
          kappad[nd] = one0d;
          a2d[nd] = one1d;
          gammad[nd] = one2d;
          fzd[nd] = one3d;
          fz0d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO][nd] *
              p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[n2]]][nd];
          dfzd[nd] = (fzd[nd] - fz0d - dfz * fz0d) * fz0inv;
          kxd[nd] = kappad[nd] + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX][nd]);
          gx2d = gammad[nd] * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] + gamma *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX][nd];
          muxd[nd] = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd[nd])) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2) -
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3][nd] *
              gx2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2d) * gx2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2d)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX][nd];
          e3d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1][nd] +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfzd[nd])) * dfz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEX3] * dfz) * dfzd[nd])) * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LEX] + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEX3] * dfz) * dfz) * pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LEX][nd];
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
            y2 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y2d[nd] = 0.0;
            }
          } else {
            y2 = e4;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y2d[nd] = e4d[nd];
            }
          }
          ex = y2;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            exd[nd] = y2d[nd];
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
            y3 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y3d[nd] = 0.0;
            }
          } else {
            y3 = e5;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y3d[nd] = e5d[nd];
            }
          }
          ex = y3;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            exd[nd] = y3d[nd];
          }
        }
        x30 = mux * fz;
        x31 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCX];
        x32 = ex;
        t23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
        t24 = exp(t23);
        x33 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t24 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        x34 = kx;
        x35 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LMUX];
        fz0_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]];
        gy2 = gamma * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
        ay = a2 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHY3] * gy2;
        muy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2
            * gy2) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        e6 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t23d, t24d;

          x30d[nd] = muxd[nd] * fz + mux * fzd[nd];
          x31d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1][nd] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PCX1] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX][nd];
          x32d[nd] = exd[nd];
          t23d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfzd[nd];
          t24d = t24 * t23d;
          x33d[nd] = ((fzd[nd] * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd[nd]))) * t24 + fz *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) * t24d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] +
              fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t24 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX][nd];
          x34d[nd] = kxd[nd];
          x35d[nd] = ((fzd[nd] * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + fz *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd[nd]))) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + fz *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX][nd]) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + fz *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX][nd];
          /* sin(2 atan(z)) = 2 z / (1 + z^2) */
          fz0_2d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO][nd] *
              p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[n2]]][nd];
          gy2d[nd] = gammad[nd] * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] + gamma *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY][nd];
          ayd[nd] = a2d[nd] + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY][nd]) +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3][nd] * gy2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] * gy2d[nd]);
          muyd[nd] = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd[nd])) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2) -
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3][nd] *
              gy2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2d[nd]) * gy2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2d[nd])) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY][nd];
          e6d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY][nd];
        }
        if (MAGGI_RE(ay) > 0.0) {
          e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            e7d[nd] = e6d[nd] * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2)) - e6 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4][nd] * gy2 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2d[nd]));
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e7) > 1.0) {
            y4 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y4d[nd] = 0.0;
            }
          } else {
            y4 = e7;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y4d[nd] = e7d[nd];
            }
          }
          ey = y4;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            eyd[nd] = y4d[nd];
          }
        } else {
          e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            e8d[nd] = e6d[nd] * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2)) + e6 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4][nd] * gy2 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2d[nd]));
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e8) > 1.0) {
            y5 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y5d[nd] = 0.0;
            }
          } else {
            y5 = e8;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y5d[nd] = e8d[nd];
            }
          }
          ey = y5;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            eyd[nd] = y5d[nd];
          }
        }
        t25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2;
        z2 = fz / t25;
        t25inv = 1.0 / t25;
        y0_3 = muy * fz;
        y1 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCY];
        y2_2 = ey;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t25d;

          t25d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2][nd] * fz0_2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2d[nd];
          z2d[nd] = (fzd[nd] - z2 * t25d) * t25inv;
          y0_3d[nd] = muyd[nd] * fz + muy * fzd[nd];
          y1d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1][nd] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PCY1] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY][nd];
          y2_2d[nd] = eyd[nd];
        }
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gy2) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
          y6 = gy2;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y6d[nd] = gy2d[nd];
          }
        } else if (MAGGI_RE(gy2) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LOW_CAMBER])) {
          y6 = -gy2;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y6d[nd] = -gy2d[nd];
          }
        } else {
          p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
          t26 = p2 * p2;
          z3 = gy2 * gy2 / t26;
          t26inv = 1.0 / t26;
          y6 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double p2d, t26d, z3d;

            p2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER][nd];
            t26d = p2d * p2 + p2 * p2d;
            z3d = (gy2d[nd] * gy2 + gy2 * gy2d[nd] - z3 * t26d) * t26inv;
            y6d[nd] = (0.125 * p2d * z3 + 0.125 * p2 * z3d) * (15.0 + z3 * (-10.0 + 3.0 * z3)) +
                0.125 * p2 * z3 * (z3d * (-10.0 + 3.0 * z3) + z3 * (3.0 * z3d));
          }
        }
        t27 = 1.0 + z2 * z2;
        t28 = 2.0 * z2 / t27;
        t27inv = 1.0 / t27;
        y3_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28 * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) * p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_LKY];
        y4_2 = ay;
        y5_2 = fz * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        peak = y0_3;
        x4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa;
        t29 = 1.0 + x4 * x4;
        t30 = sqrt(t29);
        c25 = 1.0 / (2.0 * t30);
        t31 = 1.0 / t30;
        t30inv = 1.0 / t30;
        g20 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g21 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
        e9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REX2] * dfz;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t27d, t28d, t29d, t30d, t31d, x4d;

          t27d = z2d[nd] * z2 + z2 * z2d[nd];
          t28d = (2.0 * z2d[nd] - t28 * t27d) * t27inv;
          y3_2d[nd] = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1][nd] * fz0_2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d[nd]) * t28 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28d) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3][nd] * y6 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6d[nd])) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKY1] * fz0_2 * t28 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKY3] * y6) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY][nd];
          y4_2d[nd] = ayd[nd];
          y5_2d[nd] = (fzd[nd] * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) +
              fz * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY][nd] +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd[nd])) * gy2 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY4] * dfz) * gy2d[nd]))) * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUY] + fz * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY][nd];
          peakd[nd] = y0_3d[nd];
          /* what combined slip makes of the forces:  Fx = Gxa Fx0, Fy = Gyk Fy0 + SVyk.  g: b, c, e, shift of Gxa,
           * then of Gyk, SVyk */
          x4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2][nd] * kappa +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappad[nd];
          t29d = x4d * x4 + x4 * x4d;
          t30d = c25 * t29d;
          t31d = -(t31 * t30d * t30inv);
          g20d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1][nd] * t31 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBX1] * t31 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL][nd];
          g21d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1][nd];
          e9d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] * dfzd[nd]);
        }
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e9) > 1.0) {
          y7 = 1.0;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y7d[nd] = 0.0;
          }
        } else {
          y7 = e9;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y7d[nd] = e9d[nd];
          }
        }
        g22 = y7;
        g23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        x5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        t32 = 1.0 + x5 * x5;
        t33 = sqrt(t32);
        c26 = 1.0 / (2.0 * t33);
        t34 = 1.0 / t33;
        t33inv = 1.0 / t33;
        g24 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
        e10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REY2] * dfz;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t32d, t33d, t34d, x5d;

          g22d[nd] = y7d[nd];
          g23d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1][nd];
          x5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2][nd] * (a2 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBY2] * (a2d[nd] - pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3][nd]);
          t32d = x5d * x5 + x5 * x5d;
          t33d = c26 * t32d;
          t34d = -(t34 * t33d * t33inv);
          g24d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1][nd] * t34 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBY1] * t34 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA][nd];
          g25d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1][nd];
          e10d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] * dfzd[nd]);
        }
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e10) > 1.0) {
          y8 = 1.0;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y8d[nd] = 0.0;
          }
        } else {
          y8 = e10;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y8d[nd] = e10d[nd];
          }
        }
        g26 = y8;
        g27 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RHY2] * dfz;
        p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        x6 = p3 * a2;
        t35 = 1.0 + x6 * x6;
        t36 = sqrt(t35);
        c27 = 1.0 / (2.0 * t36);
        t37 = 1.0 / t36;
        t36inv = 1.0 / t36;
        dv = peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) * t37;
        t38 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa;
        t39 = atan(t38);
        c28 = 1.0 / (1.0 + t38 * t38);
        t40 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t39;
        t41 = sin(t40);
        c29 = cos(t40);
        g28 = dv * t41 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        y9 = g20 * (a2 + g23);
        y10 = g20 * g23;
        t42 = atan(y9);
        c30 = 1.0 / (1.0 + y9 * y9);
        t43 = (1.0 - g22) * y9 + g22 * t42;
        t44 = atan(t43);
        c31 = 1.0 / (1.0 + t43 * t43);
        t45 = g21 * t44;
        t46 = cos(t45);
        c32 = -sin(t45);
        t47 = atan(y10);
        c33 = 1.0 / (1.0 + y10 * y10);
        t48 = (1.0 - g22) * y10 + g22 * t47;
        t49 = atan(t48);
        c34 = 1.0 / (1.0 + t48 * t48);
        t50 = g21 * t49;
        t51 = cos(t50);
        c35 = -sin(t50);
        gx = t46 / t51;
        t51inv = 1.0 / t51;
        y11 = g24 * (kappa + g27);
        y12 = g24 * g27;
        t52 = atan(y11);
        c36 = 1.0 / (1.0 + y11 * y11);
        t53 = (1.0 - g26) * y11 + g26 * t52;
        t54 = atan(t53);
        c37 = 1.0 / (1.0 + t53 * t53);
        t55 = g25 * t54;
        t56 = cos(t55);
        c38 = -sin(t55);
        t57 = atan(y12);
        c39 = 1.0 / (1.0 + y12 * y12);
        t58 = (1.0 - g26) * y12 + g26 * t57;
        t59 = atan(t58);
        c40 = 1.0 / (1.0 + t58 * t58);
        t60 = g25 * t59;
        t61 = cos(t60);
        c41 = -sin(t60);
        gy = t56 / t61;
        t61inv = 1.0 / t61;
        b3 = g20;
        c3 = g21;
        e11 = g22;
        shift = g23;
        y13 = b3 * (a2 + shift);
        y0 = b3 * shift;
        t62 = atan(y13);
        c42 = 1.0 / (1.0 + y13 * y13);
        t63 = (1.0 - e11) * y13 + e11 * t62;
        t64 = atan(t63);
        c43 = 1.0 / (1.0 + t63 * t63);
        z4 = c3 * t64;
        t65 = atan(y0);
        c44 = 1.0 / (1.0 + y0 * y0);
        t66 = (1.0 - e11) * y0 + e11 * t65;
        t67 = atan(t66);
        c45 = 1.0 / (1.0 + t66 * t66);
        z0 = c3 * t67;
        n5 = cos(z0);
        c46 = -sin(z0);
        t68 = atan(y13);
        c47 = 1.0 / (1.0 + y13 * y13);
        z5 = (1.0 - e11) * y13 + e11 * t68;
        t69 = sin(z4);
        c48 = cos(z4);
        t70 = 1.0 + y13 * y13;
        t71 = e11 / t70;
        t70inv = 1.0 / t70;
        t72 = 1.0 + z5 * z5;
        t73 = c3 * (1.0 - e11 + t71) / t72;
        t72inv = 1.0 / t72;
        s2 = -t69 * t73 / n5;
        n5inv = 1.0 / n5;
        t74 = atan(y0);
        c49 = 1.0 / (1.0 + y0 * y0);
        z6 = (1.0 - e11) * y0 + e11 * t74;
        t75 = cos(z4);
        c50 = -sin(z4);
        t76 = sin(z0);
        c51 = cos(z0);
        t77 = n5 * n5;
        t78 = t75 * t76 / t77;
        t77inv = 1.0 / t77;
        t79 = 1.0 + y0 * y0;
        t80 = e11 / t79;
        t79inv = 1.0 / t79;
        t81 = 1.0 + z6 * z6;
        t82 = c3 * (1.0 - e11 + t80) / t81;
        t81inv = 1.0 / t81;
        wx1 = s2 * (a2 + shift) + t78 * t82 * shift;
        b4 = g24;
        c4 = g25;
        e12 = g26;
        shift2 = g27;
        y14 = b4 * (kappa + shift2);
        y0_2 = b4 * shift2;
        t83 = atan(y14);
        c52 = 1.0 / (1.0 + y14 * y14);
        t84 = (1.0 - e12) * y14 + e12 * t83;
        t85 = atan(t84);
        c53 = 1.0 / (1.0 + t84 * t84);
        z7 = c4 * t85;
        t86 = atan(y0_2);
        c54 = 1.0 / (1.0 + y0_2 * y0_2);
        t87 = (1.0 - e12) * y0_2 + e12 * t86;
        t88 = atan(t87);
        c55 = 1.0 / (1.0 + t87 * t87);
        z0_2 = c4 * t88;
        n6 = cos(z0_2);
        c56 = -sin(z0_2);
        t89 = atan(y14);
        c57 = 1.0 / (1.0 + y14 * y14);
        z8 = (1.0 - e12) * y14 + e12 * t89;
        t90 = sin(z7);
        c58 = cos(z7);
        t91 = 1.0 + y14 * y14;
        t92 = e12 / t91;
        t91inv = 1.0 / t91;
        t93 = 1.0 + z8 * z8;
        t94 = c4 * (1.0 - e12 + t92) / t93;
        t93inv = 1.0 / t93;
        s3 = -t90 * t94 / n6;
        n6inv = 1.0 / n6;
        t95 = atan(y0_2);
        c59 = 1.0 / (1.0 + y0_2 * y0_2);
        z9 = (1.0 - e12) * y0_2 + e12 * t95;
        t96 = cos(z7);
        c60 = -sin(z7);
        t97 = sin(z0_2);
        c61 = cos(z0_2);
        t98 = n6 * n6;
        t99 = t96 * t97 / t98;
        t98inv = 1.0 / t98;
        t100 = 1.0 + y0_2 * y0_2;
        t101 = e12 / t100;
        t100inv = 1.0 / t100;
        t102 = 1.0 + z9 * z9;
        t103 = c4 * (1.0 - e12 + t101) / t102;
        t102inv = 1.0 / t102;
        wy1 = s3 * (kappa + shift2) + t99 * t103 * shift2;
        t104 = x31 * x30;
        t105 = x33 / t104;
        t104inv = 1.0 / t104;
        y15 = t105 * x34;
        t106 = atan(y15);
        c62 = 1.0 / (1.0 + y15 * y15);
        t107 = (1.0 - x32) * y15 + x32 * t106;
        t108 = atan(t107);
        c63 = 1.0 / (1.0 + t107 * t107);
        t109 = x31 * t108;
        t110 = sin(t109);
        c64 = cos(t109);
        fx = x30 * t110 + x35;
        t111 = y1 * y0_3;
        t112 = y3_2 / t111;
        t111inv = 1.0 / t111;
        y16 = t112 * y4_2;
        t113 = atan(y16);
        c65 = 1.0 / (1.0 + y16 * y16);
        t114 = (1.0 - y2_2) * y16 + y2_2 * t113;
        t115 = atan(t114);
        c66 = 1.0 / (1.0 + t114 * t114);
        t116 = y1 * t115;
        t117 = sin(t116);
        c67 = cos(t116);
        fy = y0_3 * t117 + y5_2;
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        x7 = p4 * (a2 - p5);
        t118 = 1.0 + x7 * x7;
        t119 = sqrt(t118);
        c68 = 1.0 / (2.0 * t119);
        t120 = 1.0 / t119;
        t119inv = 1.0 / t119;
        l3 = p4 * t120;
        x8 = p3 * a2;
        t121 = 1.0 + x8 * x8;
        t122 = sqrt(t121);
        c69 = 1.0 / (2.0 * t122);
        t123 = 1.0 / t122;
        t122inv = 1.0 / t122;
        v2 = p3 * t123;
        b2 = -g24 * l3 * l3 * (a2 - p5);
        t124 = y1 * y0_3;
        b5 = y3_2 / t124;
        t124inv = 1.0 / t124;
        y17 = b5 * y4_2;
        t125 = atan(y17);
        c70 = 1.0 / (1.0 + y17 * y17);
        z10 = (1.0 - y2_2) * y17 + y2_2 * t125;
        t126 = atan(y17);
        c71 = 1.0 / (1.0 + y17 * y17);
        t127 = (1.0 - y2_2) * y17 + y2_2 * t126;
        t128 = atan(t127);
        c72 = 1.0 / (1.0 + t127 * t127);
        t129 = y1 * t128;
        t130 = cos(t129);
        c73 = -sin(t129);
        t131 = 1.0 + y17 * y17;
        t132 = y2_2 / t131;
        t131inv = 1.0 / t131;
        t133 = 1.0 + z10 * z10;
        t134 = y1 * (1.0 - y2_2 + t132) / t133;
        t133inv = 1.0 / t133;
        p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        x9 = p6 * kappa;
        t135 = 1.0 + x9 * x9;
        t136 = sqrt(t135);
        c74 = 1.0 / (2.0 * t136);
        t137 = 1.0 / t136;
        t136inv = 1.0 / t136;
        m = p6 * t137;
        ka = -g20 * m * m * kappa;
        t138 = x31 * x30;
        b6 = x33 / t138;
        t138inv = 1.0 / t138;
        y18 = b6 * x34;
        t139 = atan(y18);
        c75 = 1.0 / (1.0 + y18 * y18);
        z11 = (1.0 - x32) * y18 + x32 * t139;
        t140 = atan(y18);
        c76 = 1.0 / (1.0 + y18 * y18);
        t141 = (1.0 - x32) * y18 + x32 * t140;
        t142 = atan(t141);
        c77 = 1.0 / (1.0 + t141 * t141);
        t143 = x31 * t142;
        t144 = cos(t143);
        c78 = -sin(t143);
        t145 = 1.0 + y18 * y18;
        t146 = x32 / t145;
        t145inv = 1.0 / t145;
        t147 = 1.0 + z11 * z11;
        t148 = x31 * (1.0 - x32 + t146) / t147;
        t147inv = 1.0 / t147;
        ux = fx * gx / x30;
        x30inv = 1.0 / x30;
        uy = (fy * gy + g28) / y0_3;
        y0_3inv = 1.0 / y0_3;
        c79 = 1.0 / (2.0 * s[i][2]);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double b2d, b3d, b4d, b5d, b6d, c3d, c4d, dvd, e11d, e12d, fxd, fyd, g26d, g27d, g28d,
              gxd, gyd, kad, l3d, md, n5d, n6d, p3d, p4d, p5d, p6d, s2d, s3d, shift2d, shiftd,
              t100d, t101d, t102d, t103d, t104d, t105d, t106d, t107d, t108d, t109d, t110d, t111d,
              t112d, t113d, t114d, t115d, t116d, t117d, t118d, t119d, t120d, t121d, t122d, t123d,
              t124d, t125d, t126d, t127d, t128d, t129d, t130d, t131d, t132d, t133d, t134d, t135d,
              t136d, t137d, t138d, t139d, t140d, t141d, t142d, t143d, t144d, t145d, t146d, t147d,
              t148d, t149d, t35d, t36d, t37d, t38d, t39d, t40d, t41d, t42d, t43d, t44d, t45d, t46d,
              t47d, t48d, t49d, t50d, t51d, t52d, t53d, t54d, t55d, t56d, t57d, t58d, t59d, t60d,
              t61d, t62d, t63d, t64d, t65d, t66d, t67d, t68d, t69d, t70d, t71d, t72d, t73d, t74d,
              t75d, t76d, t77d, t78d, t79d, t80d, t81d, t82d, t83d, t84d, t85d, t86d, t87d, t88d,
              t89d, t90d, t91d, t92d, t93d, t94d, t95d, t96d, t97d, t98d, t99d, uxd, uyd, v2d, wx1d,
              wy1d, x6d, x7d, x8d, x9d, y0_2d, y0d, y10d, y11d, y12d, y13d, y14d, y15d, y16d, y17d,
              y18d, y9d, z0_2d, z0d, z10d, z11d, z4d, z5d, z6d, z7d, z8d, z9d;

          g26d = y8d[nd];
          g27d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfzd[nd]);
          p3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4][nd];
          x6d = p3d * a2 + p3 * a2d[nd];
          t35d = x6d * x6 + x6 * x6d;
          t36d = c27 * t35d;
          t37d = -(t37 * t36d * t36inv);
          dvd = (peakd[nd] * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma) + peak *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd[nd]) +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3][nd] * gamma +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gammad[nd]))) * t37 + peak *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma) *
              t37d;
          t38d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6][nd] * kappa +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappad[nd];
          t39d = c28 * t38d;
          t40d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5][nd] * t39 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t39d;
          t41d = c29 * t40d;
          g28d = (dvd * t41 + dv * t41d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + dv *
              t41 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA][nd];
          y9d = g20d[nd] * (a2 + g23) + g20 * (a2d[nd] + g23d[nd]);
          y10d = g20d[nd] * g23 + g20 * g23d[nd];
          t42d = c30 * y9d;
          t43d = -(g22d[nd] * y9) + (1.0 - g22) * y9d + (g22d[nd] * t42 + g22 * t42d);
          t44d = c31 * t43d;
          t45d = g21d[nd] * t44 + g21 * t44d;
          t46d = c32 * t45d;
          t47d = c33 * y10d;
          t48d = -(g22d[nd] * y10) + (1.0 - g22) * y10d + (g22d[nd] * t47 + g22 * t47d);
          t49d = c34 * t48d;
          t50d = g21d[nd] * t49 + g21 * t49d;
          t51d = c35 * t50d;
          gxd = (t46d - gx * t51d) * t51inv;
          y11d = g24d[nd] * (kappa + g27) + g24 * (kappad[nd] + g27d);
          y12d = g24d[nd] * g27 + g24 * g27d;
          t52d = c36 * y11d;
          t53d = -(g26d * y11) + (1.0 - g26) * y11d + (g26d * t52 + g26 * t52d);
          t54d = c37 * t53d;
          t55d = g25d[nd] * t54 + g25 * t54d;
          t56d = c38 * t55d;
          t57d = c39 * y12d;
          t58d = -(g26d * y12) + (1.0 - g26) * y12d + (g26d * t57 + g26 * t57d);
          t59d = c40 * t58d;
          t60d = g25d[nd] * t59 + g25 * t59d;
          t61d = c41 * t60d;
          gyd = (t56d - gy * t61d) * t61inv;
          b3d = g20d[nd];
          c3d = g21d[nd];
          e11d = g22d[nd];
          shiftd = g23d[nd];
          /* its derivatives by x and by b */
          y13d = b3d * (a2 + shift) + b3 * (a2d[nd] + shiftd);
          y0d = b3d * shift + b3 * shiftd;
          t62d = c42 * y13d;
          t63d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t62 + e11 * t62d);
          t64d = c43 * t63d;
          z4d = c3d * t64 + c3 * t64d;
          t65d = c44 * y0d;
          t66d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t65 + e11 * t65d);
          t67d = c45 * t66d;
          z0d = c3d * t67 + c3 * t67d;
          n5d = c46 * z0d;
          /* its derivative by y */
          t68d = c47 * y13d;
          z5d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t68 + e11 * t68d);
          t69d = c48 * z4d;
          t70d = y13d * y13 + y13 * y13d;
          t71d = (e11d - t71 * t70d) * t70inv;
          t72d = z5d * z5 + z5 * z5d;
          t73d = (c3d * (1.0 - e11 + t71) + c3 * (-e11d + t71d) - t73 * t72d) * t72inv;
          s2d = (-(t69d * t73) - t69 * t73d - s2 * n5d) * n5inv;
          /* its derivative by y */
          t74d = c49 * y0d;
          z6d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t74 + e11 * t74d);
          t75d = c50 * z4d;
          t76d = c51 * z0d;
          t77d = n5d * n5 + n5 * n5d;
          t78d = (t75d * t76 + t75 * t76d - t78 * t77d) * t77inv;
          t79d = y0d * y0 + y0 * y0d;
          t80d = (e11d - t80 * t79d) * t79inv;
          t81d = z6d * z6 + z6 * z6d;
          t82d = (c3d * (1.0 - e11 + t80) + c3 * (-e11d + t80d) - t82 * t81d) * t81inv;
          wx1d = s2d * (a2 + shift) + s2 * (a2d[nd] + shiftd) + ((t78d * t82 + t78 * t82d) * shift +
              t78 * t82 * shiftd);
          b4d = g24d[nd];
          c4d = g25d[nd];
          e12d = g26d;
          shift2d = g27d;
          /* its derivatives by x and by b */
          y14d = b4d * (kappa + shift2) + b4 * (kappad[nd] + shift2d);
          y0_2d = b4d * shift2 + b4 * shift2d;
          t83d = c52 * y14d;
          t84d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t83 + e12 * t83d);
          t85d = c53 * t84d;
          z7d = c4d * t85 + c4 * t85d;
          t86d = c54 * y0_2d;
          t87d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t86 + e12 * t86d);
          t88d = c55 * t87d;
          z0_2d = c4d * t88 + c4 * t88d;
          n6d = c56 * z0_2d;
          /* its derivative by y */
          t89d = c57 * y14d;
          z8d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t89 + e12 * t89d);
          t90d = c58 * z7d;
          t91d = y14d * y14 + y14 * y14d;
          t92d = (e12d - t92 * t91d) * t91inv;
          t93d = z8d * z8 + z8 * z8d;
          t94d = (c4d * (1.0 - e12 + t92) + c4 * (-e12d + t92d) - t94 * t93d) * t93inv;
          s3d = (-(t90d * t94) - t90 * t94d - s3 * n6d) * n6inv;
          /* its derivative by y */
          t95d = c59 * y0_2d;
          z9d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t95 + e12 * t95d);
          t96d = c60 * z7d;
          t97d = c61 * z0_2d;
          t98d = n6d * n6 + n6 * n6d;
          t99d = (t96d * t97 + t96 * t97d - t99 * t98d) * t98inv;
          t100d = y0_2d * y0_2 + y0_2 * y0_2d;
          t101d = (e12d - t101 * t100d) * t100inv;
          t102d = z9d * z9 + z9 * z9d;
          t103d = (c4d * (1.0 - e12 + t101) + c4 * (-e12d + t101d) - t103 * t102d) * t102inv;
          wy1d = s3d * (kappa + shift2) + s3 * (kappad[nd] + shift2d) + ((t99d * t103 + t99 * t103d)
              * shift2 + t99 * t103 * shift2d);
          t104d = x31d[nd] * x30 + x31 * x30d[nd];
          t105d = (x33d[nd] - t105 * t104d) * t104inv;
          y15d = t105d * x34 + t105 * x34d[nd];
          t106d = c62 * y15d;
          t107d = -(x32d[nd] * y15) + (1.0 - x32) * y15d + (x32d[nd] * t106 + x32 * t106d);
          t108d = c63 * t107d;
          t109d = x31d[nd] * t108 + x31 * t108d;
          t110d = c64 * t109d;
          fxd = x30d[nd] * t110 + x30 * t110d + x35d[nd];
          t111d = y1d[nd] * y0_3 + y1 * y0_3d[nd];
          t112d = (y3_2d[nd] - t112 * t111d) * t111inv;
          y16d = t112d * y4_2 + t112 * y4_2d[nd];
          t113d = c65 * y16d;
          t114d = -(y2_2d[nd] * y16) + (1.0 - y2_2) * y16d + (y2_2d[nd] * t113 + y2_2 * t113d);
          t115d = c66 * t114d;
          t116d = y1d[nd] * t115 + y1 * t115d;
          t117d = c67 * t116d;
          fyd = y0_3d[nd] * t117 + y0_3 * t117d + y5_2d[nd];
          p4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2][nd];
          p5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3][nd];
          /* b and the shift of Fy change with a by their cos(atan()) */
          x7d = p4d * (a2 - p5) + p4 * (a2d[nd] - p5d);
          t118d = x7d * x7 + x7 * x7d;
          t119d = c68 * t118d;
          t120d = -(t120 * t119d * t119inv);
          l3d = p4d * t120 + p4 * t120d;
          x8d = p3d * a2 + p3 * a2d[nd];
          t121d = x8d * x8 + x8 * x8d;
          t122d = c69 * t121d;
          t123d = -(t123 * t122d * t122inv);
          v2d = p3d * t123 + p3 * t123d;
          b2d = ((-(g24d[nd] * l3) - g24 * l3d) * l3 + -g24 * l3 * l3d) * (a2 - p5) + -g24 * l3 * l3
              * (a2d[nd] - p5d);
          /* its derivative by the slip */
          t124d = y1d[nd] * y0_3 + y1 * y0_3d[nd];
          b5d = (y3_2d[nd] - b5 * t124d) * t124inv;
          y17d = b5d * y4_2 + b5 * y4_2d[nd];
          /* its derivative by y */
          t125d = c70 * y17d;
          z10d = -(y2_2d[nd] * y17) + (1.0 - y2_2) * y17d + (y2_2d[nd] * t125 + y2_2 * t125d);
          t126d = c71 * y17d;
          t127d = -(y2_2d[nd] * y17) + (1.0 - y2_2) * y17d + (y2_2d[nd] * t126 + y2_2 * t126d);
          t128d = c72 * t127d;
          t129d = y1d[nd] * t128 + y1 * t128d;
          t130d = c73 * t129d;
          t131d = y17d * y17 + y17 * y17d;
          t132d = (y2_2d[nd] - t132 * t131d) * t131inv;
          t133d = z10d * z10 + z10 * z10d;
          t134d = (y1d[nd] * (1.0 - y2_2 + t132) + y1 * (-y2_2d[nd] + t132d) - t134 * t133d) *
              t133inv;
          sd[i][0][nd] = (a2d[nd] * a2 + a2 * a2d[nd]) * (gy * (y0_3 * t130 * t134 * b5) + fy * wy1
              * b2 - g28 * v2 * v2 * a2) + (1.0 + a2 * a2) * (gyd * (y0_3 * t130 * t134 * b5) + gy *
              (((y0_3d[nd] * t130 + y0_3 * t130d) * t134 + y0_3 * t130 * t134d) * b5 + y0_3 * t130 *
              t134 * b5d) + ((fyd * wy1 + fy * wy1d) * b2 + fy * wy1 * b2d) - (((g28d * v2 + g28 *
              v2d) * v2 + g28 * v2 * v2d) * a2 + g28 * v2 * v2 * a2d[nd]));
          p6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2][nd];
          x9d = p6d * kappa + p6 * kappad[nd];
          t135d = x9d * x9 + x9 * x9d;
          t136d = c74 * t135d;
          t137d = -(t137 * t136d * t136inv);
          md = p6d * t137 + p6 * t137d;
          kad = ((-(g20d[nd] * m) - g20 * md) * m + -g20 * m * md) * kappa + -g20 * m * m *
              kappad[nd];
          /* its derivative by the slip */
          t138d = x31d[nd] * x30 + x31 * x30d[nd];
          b6d = (x33d[nd] - b6 * t138d) * t138inv;
          y18d = b6d * x34 + b6 * x34d[nd];
          /* its derivative by y */
          t139d = c75 * y18d;
          z11d = -(x32d[nd] * y18) + (1.0 - x32) * y18d + (x32d[nd] * t139 + x32 * t139d);
          t140d = c76 * y18d;
          t141d = -(x32d[nd] * y18) + (1.0 - x32) * y18d + (x32d[nd] * t140 + x32 * t140d);
          t142d = c77 * t141d;
          t143d = x31d[nd] * t142 + x31 * t142d;
          t144d = c78 * t143d;
          t145d = y18d * y18 + y18 * y18d;
          t146d = (x32d[nd] - t146 * t145d) * t145inv;
          t147d = z11d * z11 + z11 * z11d;
          t148d = (x31d[nd] * (1.0 - x32 + t146) + x31 * (-x32d[nd] + t146d) - t148 * t147d) *
              t147inv;
          sd[i][1][nd] = gxd * (x30 * t144 * t148 * b6) + gx * (((x30d[nd] * t144 + x30 * t144d) *
              t148 + x30 * t144 * t148d) * b6 + x30 * t144 * t148 * b6d) + ((fxd * wx1 + fx * wx1d)
              * ka + fx * wx1 * kad);
          uxd = (fxd * gx + fx * gxd - ux * x30d[nd]) * x30inv;
          uyd = (fyd * gy + fy * gyd + g28d - uy * y0_3d[nd]) * y0_3inv;
          t149d = uxd * ux + ux * uxd + (uyd * uy + uy * uyd);
          sd[i][2][nd] = c79 * t149d;
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][0][nd] = 0.0;
          sd[i][1][nd] = 0.0;
          sd[i][2][nd] = 0.0;
        }
      }
    }
  }
}
