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
  int a, a3, b, b7, i, j, k, k2, n2, nd;
  double A_j0, A_j3, A_j7, A_j8, Z_j3, Z_j4, a2, ay, b2, b3, b4, b5, b6, c, c10, c11, c12, c13, c14,
      c15, c16, c17, c18, c19, c2, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c2inv, c3, c30,
      c31, c32, c33, c34, c35, c36, c37, c38, c39, c4, c40, c41, c42, c43, c44, c45, c46, c47, c48,
      c49, c5, c50, c51, c52, c53, c54, c55, c56, c57, c58, c59, c6, c60, c61, c62, c63, c64, c65,
      c66, c67, c68, c69, c7, c8, c9, dfz, dv, e0, e1, e10, e11, e12, e20, e21, e22, e2_2, e3, e4,
      e5, e6, e7, e8, e9, ev0, ev1, ev20, ev21, ev22, ev2_2, ex, ey, fx, fy, fz, fz0, fz0_2, fz0inv,
      g0, g1, g2, g3, g4, g5, g6, g7, g8, gamma, gx, gx2, gy, gy2, ka, kappa, kx, l, l2, l2inv, l3,
      linv, lv, m, mux, muy, n30, n31, n32, n4, n4inv, n5, n5inv, one0, one1, one2, one3, p2, p3,
      p4, p5, p6, p_k24, p_k25, peak, roll, s2, s3, shift, shift2, side, t10, t100, t101, t102,
      t103, t104, t104inv, t105, t106, t107, t107inv, t108, t109, t109inv, t10inv, t11, t110, t111,
      t112, t113, t114, t115, t116, t116inv, t117, t118, t118inv, t119, t11inv, t12, t120, t121,
      t121inv, t122, t123, t123inv, t124, t125, t126, t127, t128, t129, t12inv, t13, t130, t130inv,
      t131, t132, t132inv, t133, t14, t15, t15inv, t16, t17, t18, t18inv, t19, t2, t20, t21, t21inv,
      t22, t23, t24, t25, t26, t27, t28, t29, t3, t30, t31, t32, t33, t34, t35, t36, t36inv, t37,
      t38, t39, t4, t40, t41, t42, t43, t44, t45, t46, t46inv, t47, t48, t49, t5, t50, t51, t52,
      t53, t54, t55, t55inv, t56, t57, t57inv, t58, t59, t5inv, t6, t60, t61, t62, t62inv, t63, t64,
      t64inv, t65, t66, t66inv, t67, t68, t69, t7, t70, t71, t72, t73, t74, t75, t76, t76inv, t77,
      t78, t78inv, t79, t8, t80, t81, t82, t83, t83inv, t84, t85, t85inv, t86, t87, t87inv, t88,
      t89, t89inv, t9, t90, t91, t92, t93, t94, t95, t96, t96inv, t97, t98, t99, ux, uy, v2, wx1,
      wy1, x2, x30, x30inv, x31, x32, x33, x34, x35, x4, x5, x6, x7, x8, x9, xv, y0, y0_2, y0_3,
      y0_3inv, y1, y10, y11, y12, y13, y14, y15, y16, y17, y18, y2, y2_2, y3, y3_2, y4, y4_2, y5,
      y5_2, y6, y7, y8, y9, z0, z0_2, z10, z11, z1_3, z2, z3, z4, z5, z6, z7, z8, z9;
  double a2d[MAGGI_NDIR], ayd[MAGGI_NDIR], dampingd[MAGGI_NDIR], dfzd[MAGGI_NDIR], e10d[MAGGI_NDIR],
      e3d[MAGGI_NDIR], e4d[MAGGI_NDIR], e5d[MAGGI_NDIR], e6d[MAGGI_NDIR], e7d[MAGGI_NDIR],
      e8d[MAGGI_NDIR], e9d[MAGGI_NDIR], exd[MAGGI_NDIR], eyd[MAGGI_NDIR], f0d[MAGGI_NDIR],
      f1d[MAGGI_NDIR], f2d[MAGGI_NDIR], fz0_2d[MAGGI_NDIR], fzd[MAGGI_NDIR], g0d[MAGGI_NDIR],
      g1d[MAGGI_NDIR], g2d[MAGGI_NDIR], g3d[MAGGI_NDIR], g4d[MAGGI_NDIR], g5d[MAGGI_NDIR],
      gammad[MAGGI_NDIR], gy2d[MAGGI_NDIR], kappad[MAGGI_NDIR], kxd[MAGGI_NDIR], ld[MAGGI_NDIR],
      lvd[MAGGI_NDIR], muxd[MAGGI_NDIR], muyd[MAGGI_NDIR], peakd[MAGGI_NDIR], x2d[MAGGI_NDIR],
      x30d[MAGGI_NDIR], x31d[MAGGI_NDIR], x32d[MAGGI_NDIR], x33d[MAGGI_NDIR], x34d[MAGGI_NDIR],
      x35d[MAGGI_NDIR], xvd[MAGGI_NDIR], y0_3d[MAGGI_NDIR], y1d[MAGGI_NDIR], y2_2d[MAGGI_NDIR],
      y2d[MAGGI_NDIR], y3_2d[MAGGI_NDIR], y3d[MAGGI_NDIR], y4_2d[MAGGI_NDIR], y4d[MAGGI_NDIR],
      y5_2d[MAGGI_NDIR], y5d[MAGGI_NDIR], y6d[MAGGI_NDIR], y7d[MAGGI_NDIR], y8d[MAGGI_NDIR],
      z2d[MAGGI_NDIR];

  (void)origin;
  (void)x;
  (void)Za;
  (void)ra;
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
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j8 = A[j][8];
      c4 = A_j8 / (A_j8 * A_j8 + A_j7 * A_j7);
      c5 = -(A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      t2 = -A[j][6];
      t3 = A_j7 * A_j7 + A_j8 * A_j8;
      t4 = sqrt(t3);
      c6 = 1.0 / (2.0 * t4);
      c7 = t4 / (t4 * t4 + t2 * t2);
      c8 = -(t2 / (t4 * t4 + t2 * t2));
      c9 = A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]);
      c10 = -(A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j7d, A_j8d, t2d, t3d, t4d;

        A_j7d = Ad[j][7][nd];
        A_j8d = Ad[j][8][nd];
        /* R = Rz(yaw) Ry(pitch) Rx(roll) */
        sd[i][0][nd] = c4 * A_j7d + c5 * A_j8d;
        t2d = -Ad[j][6][nd];
        t3d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
        t4d = c6 * t3d;
        sd[i][1][nd] = c7 * t2d + c8 * t4d;
        sd[i][2][nd] = c9 * Ad[j][3][nd] + c10 * Ad[j][0][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      A_j0 = A[j][0];
      A_j3 = A[j][3];
      c2 = A_j0 * A_j0 + A_j3 * A_j3;
      Z_j3 = Z[j][3];
      Z_j4 = Z[j][4];
      roll = s[i][0];
      c2inv = 1.0 / c2;
      t5 = sqrt(c2);
      c11 = 1.0 / (2.0 * t5);
      t5inv = 1.0 / t5;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j0d, A_j3d, Z_j3d, Z_j4d, c2d, rolld, t5d;

        A_j0d = Ad[j][0][nd];
        A_j3d = Ad[j][3][nd];
        /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
         * A_6 = -sin(pitch) */
        c2d = A_j0d * A_j0 + A_j0 * A_j0d + (A_j3d * A_j3 + A_j3 * A_j3d);
        Z_j3d = Zd[j][3][nd];
        Z_j4d = Zd[j][4][nd];
        rolld = (A_j0d * Z_j3 + A_j0 * Z_j3d + (A_j3d * Z_j4 + A_j3 * Z_j4d) - roll * c2d) * c2inv;
        sd[i][0][nd] = rolld;
        t5d = c11 * c2d;
        sd[i][1][nd] = (A_j0d * Z_j4 + A_j0 * Z_j4d - (A_j3d * Z_j3 + A_j3 * Z_j3d) - s[i][1] * t5d)
            * t5inv;
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
      a = t->springpa[n2];
      b = t->springpb[n2];
      e0 = r[a][0] - r[b][0];
      ev0 = rv[a][0] - rv[b][0];
      e1 = r[a][1] - r[b][1];
      ev1 = rv[a][1] - rv[b][1];
      e2_2 = r[a][2] - r[b][2];
      ev2_2 = rv[a][2] - rv[b][2];
      t6 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
      l = sqrt(t6);
      c12 = 1.0 / (2.0 * l);
      n30 = e0 / l;
      linv = 1.0 / l;
      n31 = e1 / l;
      n32 = e2_2 / l;
      lv = n30 * ev0 + n31 * ev1 + n32 * ev2_2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e0d, e1d, e2_2d, ev0d, ev1d, ev2_2d, n30d, n31d, n32d, t6d;

        e0d = rd[a][0][nd] - rd[b][0][nd];
        ev0d = rvd[a][0][nd] - rvd[b][0][nd];
        e1d = rd[a][1][nd] - rd[b][1][nd];
        ev1d = rvd[a][1][nd] - rvd[b][1][nd];
        e2_2d = rd[a][2][nd] - rd[b][2][nd];
        ev2_2d = rvd[a][2][nd] - rvd[b][2][nd];
        t6d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
        ld[nd] = c12 * t6d;
        n30d = (e0d - n30 * ld[nd]) * linv;
        n31d = (e1d - n31 * ld[nd]) * linv;
        n32d = (e2_2d - n32 * ld[nd]) * linv;
        lvd[nd] = n30d * ev0 + n30 * ev0d + (n31d * ev1 + n31 * ev1d) + (n32d * ev2_2 + n32 *
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
      k2 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
      if (t->springslopes[n2]) {
        /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
        if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
          p_k24 = p[k2 + 4];
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double p_k24d;

            p_k24d = pd[k2 + 4][nd];
            f2d[nd] = pd[k2][nd] * p_k24 + p[k2] * p_k24d + (pd[k2 + 1][nd] * (lv - p_k24) + p[k2 +
                1] * (lvd[nd] - p_k24d));
          }
        } else if (MAGGI_RE(lv) > 0.0) {
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            f2d[nd] = pd[k2][nd] * lv + p[k2] * lvd[nd];
          }
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            f2d[nd] = pd[k2 + 2][nd] * lv + p[k2 + 2] * lvd[nd];
          }
        } else {
          p_k25 = p[k2 + 5];
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double p_k25d;

            p_k25d = pd[k2 + 5][nd];
            f2d[nd] = pd[k2 + 2][nd] * p_k25 + p[k2 + 2] * p_k25d + (pd[k2 + 3][nd] * (lv - p_k25) +
                p[k2 + 3] * (lvd[nd] - p_k25d));
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
      a3 = t->primpa[n2];
      b7 = t->primpb[n2];
      e20 = r[a3][0] - r[b7][0];
      ev20 = rv[a3][0] - rv[b7][0];
      e21 = r[a3][1] - r[b7][1];
      ev21 = rv[a3][1] - rv[b7][1];
      e22 = r[a3][2] - r[b7][2];
      ev22 = rv[a3][2] - rv[b7][2];
      t7 = e20 * e20 + e21 * e21 + e22 * e22;
      l2 = sqrt(t7);
      c13 = 1.0 / (2.0 * l2);
      z1_3 = s[i][1];
      l2inv = 1.0 / l2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e20d, e21d, e22d, ev20d, ev21d, ev22d, l2d, t7d, z0_5d, z1_3d;

        /* distance of two points and its rate */
        e20d = rd[a3][0][nd] - rd[b7][0][nd];
        ev20d = rvd[a3][0][nd] - rvd[b7][0][nd];
        e21d = rd[a3][1][nd] - rd[b7][1][nd];
        ev21d = rvd[a3][1][nd] - rvd[b7][1][nd];
        e22d = rd[a3][2][nd] - rd[b7][2][nd];
        ev22d = rvd[a3][2][nd] - rvd[b7][2][nd];
        t7d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 * e22d);
        l2d = c13 * t7d;
        z0_5d = l2d;
        z1_3d = (e20d * ev20 + e20 * ev20d + (e21d * ev21 + e21 * ev21d) + (e22d * ev22 + e22 *
            ev22d) - z1_3 * l2d) * l2inv;
        sd[i][0][nd] = z0_5d;
        sd[i][1][nd] = z1_3d;
        sd[i][2][nd] = lambdad[t->primrow[n2]][nd];
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_SLIP) {
      c14 = 1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] * slip[n2][MAGGI_SLIP_TAN_ALPHA]);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[i][0][nd] = slipd[n2][MAGGI_SLIP_KAPPA][nd];
        sd[i][1][nd] = c14 * slipd[n2][MAGGI_SLIP_TAN_ALPHA][nd];
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
        t8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
        t9 = exp(t8);
        x33 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t9 *
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
          double t8d, t9d;

          x30d[nd] = muxd[nd] * fz + mux * fzd[nd];
          x31d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1][nd] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PCX1] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX][nd];
          x32d[nd] = exd[nd];
          t8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfzd[nd];
          t9d = t9 * t8d;
          x33d[nd] = ((fzd[nd] * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd[nd]))) * t9 + fz *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) * t9d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + fz
              * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PKX2] * dfz) * t9 * pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LKX][nd];
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
        t10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2;
        z2 = fz / t10;
        t10inv = 1.0 / t10;
        y0_3 = muy * fz;
        y1 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCY];
        y2_2 = ey;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t10d;

          t10d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2][nd] * fz0_2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2d[nd];
          z2d[nd] = (fzd[nd] - z2 * t10d) * t10inv;
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
          t11 = p2 * p2;
          z3 = gy2 * gy2 / t11;
          t11inv = 1.0 / t11;
          y6 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double p2d, t11d, z3d;

            p2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER][nd];
            t11d = p2d * p2 + p2 * p2d;
            z3d = (gy2d[nd] * gy2 + gy2 * gy2d[nd] - z3 * t11d) * t11inv;
            y6d[nd] = (0.125 * p2d * z3 + 0.125 * p2 * z3d) * (15.0 + z3 * (-10.0 + 3.0 * z3)) +
                0.125 * p2 * z3 * (z3d * (-10.0 + 3.0 * z3) + z3 * (3.0 * z3d));
          }
        }
        t12 = 1.0 + z2 * z2;
        t13 = 2.0 * z2 / t12;
        t12inv = 1.0 / t12;
        y3_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 -
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
        t14 = 1.0 + x4 * x4;
        t15 = sqrt(t14);
        c15 = 1.0 / (2.0 * t15);
        t16 = 1.0 / t15;
        t15inv = 1.0 / t15;
        g0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g1 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
        e9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REX2] * dfz;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t12d, t13d, t14d, t15d, t16d, x4d;

          t12d = z2d[nd] * z2 + z2 * z2d[nd];
          t13d = (2.0 * z2d[nd] - t13 * t12d) * t12inv;
          y3_2d[nd] = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1][nd] * fz0_2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d[nd]) * t13 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13d) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3][nd] * y6 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6d[nd])) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
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
          t14d = x4d * x4 + x4 * x4d;
          t15d = c15 * t14d;
          t16d = -(t16 * t15d * t15inv);
          g0d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1][nd] * t16 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBX1] * t16 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL][nd];
          g1d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1][nd];
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
        g2 = y7;
        g3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        x5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        t17 = 1.0 + x5 * x5;
        t18 = sqrt(t17);
        c16 = 1.0 / (2.0 * t18);
        t19 = 1.0 / t18;
        t18inv = 1.0 / t18;
        g4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
        e10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REY2] * dfz;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t17d, t18d, t19d, x5d;

          g2d[nd] = y7d[nd];
          g3d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1][nd];
          x5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2][nd] * (a2 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBY2] * (a2d[nd] - pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3][nd]);
          t17d = x5d * x5 + x5 * x5d;
          t18d = c16 * t17d;
          t19d = -(t19 * t18d * t18inv);
          g4d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1][nd] * t19 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBY1] * t19 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA][nd];
          g5d[nd] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1][nd];
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
        g6 = y8;
        g7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RHY2] * dfz;
        p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        x6 = p3 * a2;
        t20 = 1.0 + x6 * x6;
        t21 = sqrt(t20);
        c17 = 1.0 / (2.0 * t21);
        t22 = 1.0 / t21;
        t21inv = 1.0 / t21;
        dv = peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) * t22;
        t23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa;
        t24 = atan(t23);
        c18 = 1.0 / (1.0 + t23 * t23);
        t25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t24;
        t26 = sin(t25);
        c19 = cos(t25);
        g8 = dv * t26 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        y9 = g0 * (a2 + g3);
        y10 = g0 * g3;
        t27 = atan(y9);
        c20 = 1.0 / (1.0 + y9 * y9);
        t28 = (1.0 - g2) * y9 + g2 * t27;
        t29 = atan(t28);
        c21 = 1.0 / (1.0 + t28 * t28);
        t30 = g1 * t29;
        t31 = cos(t30);
        c22 = -sin(t30);
        t32 = atan(y10);
        c23 = 1.0 / (1.0 + y10 * y10);
        t33 = (1.0 - g2) * y10 + g2 * t32;
        t34 = atan(t33);
        c24 = 1.0 / (1.0 + t33 * t33);
        t35 = g1 * t34;
        t36 = cos(t35);
        c25 = -sin(t35);
        gx = t31 / t36;
        t36inv = 1.0 / t36;
        y11 = g4 * (kappa + g7);
        y12 = g4 * g7;
        t37 = atan(y11);
        c26 = 1.0 / (1.0 + y11 * y11);
        t38 = (1.0 - g6) * y11 + g6 * t37;
        t39 = atan(t38);
        c27 = 1.0 / (1.0 + t38 * t38);
        t40 = g5 * t39;
        t41 = cos(t40);
        c28 = -sin(t40);
        t42 = atan(y12);
        c29 = 1.0 / (1.0 + y12 * y12);
        t43 = (1.0 - g6) * y12 + g6 * t42;
        t44 = atan(t43);
        c30 = 1.0 / (1.0 + t43 * t43);
        t45 = g5 * t44;
        t46 = cos(t45);
        c31 = -sin(t45);
        gy = t41 / t46;
        t46inv = 1.0 / t46;
        b3 = g0;
        c = g1;
        e11 = g2;
        shift = g3;
        y13 = b3 * (a2 + shift);
        y0 = b3 * shift;
        t47 = atan(y13);
        c32 = 1.0 / (1.0 + y13 * y13);
        t48 = (1.0 - e11) * y13 + e11 * t47;
        t49 = atan(t48);
        c33 = 1.0 / (1.0 + t48 * t48);
        z4 = c * t49;
        t50 = atan(y0);
        c34 = 1.0 / (1.0 + y0 * y0);
        t51 = (1.0 - e11) * y0 + e11 * t50;
        t52 = atan(t51);
        c35 = 1.0 / (1.0 + t51 * t51);
        z0 = c * t52;
        n4 = cos(z0);
        c36 = -sin(z0);
        t53 = atan(y13);
        c37 = 1.0 / (1.0 + y13 * y13);
        z5 = (1.0 - e11) * y13 + e11 * t53;
        t54 = sin(z4);
        c38 = cos(z4);
        t55 = 1.0 + y13 * y13;
        t56 = e11 / t55;
        t55inv = 1.0 / t55;
        t57 = 1.0 + z5 * z5;
        t58 = c * (1.0 - e11 + t56) / t57;
        t57inv = 1.0 / t57;
        s2 = -t54 * t58 / n4;
        n4inv = 1.0 / n4;
        t59 = atan(y0);
        c39 = 1.0 / (1.0 + y0 * y0);
        z6 = (1.0 - e11) * y0 + e11 * t59;
        t60 = cos(z4);
        c40 = -sin(z4);
        t61 = sin(z0);
        c41 = cos(z0);
        t62 = n4 * n4;
        t63 = t60 * t61 / t62;
        t62inv = 1.0 / t62;
        t64 = 1.0 + y0 * y0;
        t65 = e11 / t64;
        t64inv = 1.0 / t64;
        t66 = 1.0 + z6 * z6;
        t67 = c * (1.0 - e11 + t65) / t66;
        t66inv = 1.0 / t66;
        wx1 = s2 * (a2 + shift) + t63 * t67 * shift;
        b4 = g4;
        c3 = g5;
        e12 = g6;
        shift2 = g7;
        y14 = b4 * (kappa + shift2);
        y0_2 = b4 * shift2;
        t68 = atan(y14);
        c42 = 1.0 / (1.0 + y14 * y14);
        t69 = (1.0 - e12) * y14 + e12 * t68;
        t70 = atan(t69);
        c43 = 1.0 / (1.0 + t69 * t69);
        z7 = c3 * t70;
        t71 = atan(y0_2);
        c44 = 1.0 / (1.0 + y0_2 * y0_2);
        t72 = (1.0 - e12) * y0_2 + e12 * t71;
        t73 = atan(t72);
        c45 = 1.0 / (1.0 + t72 * t72);
        z0_2 = c3 * t73;
        n5 = cos(z0_2);
        c46 = -sin(z0_2);
        t74 = atan(y14);
        c47 = 1.0 / (1.0 + y14 * y14);
        z8 = (1.0 - e12) * y14 + e12 * t74;
        t75 = sin(z7);
        c48 = cos(z7);
        t76 = 1.0 + y14 * y14;
        t77 = e12 / t76;
        t76inv = 1.0 / t76;
        t78 = 1.0 + z8 * z8;
        t79 = c3 * (1.0 - e12 + t77) / t78;
        t78inv = 1.0 / t78;
        s3 = -t75 * t79 / n5;
        n5inv = 1.0 / n5;
        t80 = atan(y0_2);
        c49 = 1.0 / (1.0 + y0_2 * y0_2);
        z9 = (1.0 - e12) * y0_2 + e12 * t80;
        t81 = cos(z7);
        c50 = -sin(z7);
        t82 = sin(z0_2);
        c51 = cos(z0_2);
        t83 = n5 * n5;
        t84 = t81 * t82 / t83;
        t83inv = 1.0 / t83;
        t85 = 1.0 + y0_2 * y0_2;
        t86 = e12 / t85;
        t85inv = 1.0 / t85;
        t87 = 1.0 + z9 * z9;
        t88 = c3 * (1.0 - e12 + t86) / t87;
        t87inv = 1.0 / t87;
        wy1 = s3 * (kappa + shift2) + t84 * t88 * shift2;
        t89 = x31 * x30;
        t90 = x33 / t89;
        t89inv = 1.0 / t89;
        y15 = t90 * x34;
        t91 = atan(y15);
        c52 = 1.0 / (1.0 + y15 * y15);
        t92 = (1.0 - x32) * y15 + x32 * t91;
        t93 = atan(t92);
        c53 = 1.0 / (1.0 + t92 * t92);
        t94 = x31 * t93;
        t95 = sin(t94);
        c54 = cos(t94);
        fx = x30 * t95 + x35;
        t96 = y1 * y0_3;
        t97 = y3_2 / t96;
        t96inv = 1.0 / t96;
        y16 = t97 * y4_2;
        t98 = atan(y16);
        c55 = 1.0 / (1.0 + y16 * y16);
        t99 = (1.0 - y2_2) * y16 + y2_2 * t98;
        t100 = atan(t99);
        c56 = 1.0 / (1.0 + t99 * t99);
        t101 = y1 * t100;
        t102 = sin(t101);
        c57 = cos(t101);
        fy = y0_3 * t102 + y5_2;
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        x7 = p4 * (a2 - p5);
        t103 = 1.0 + x7 * x7;
        t104 = sqrt(t103);
        c58 = 1.0 / (2.0 * t104);
        t105 = 1.0 / t104;
        t104inv = 1.0 / t104;
        l3 = p4 * t105;
        x8 = p3 * a2;
        t106 = 1.0 + x8 * x8;
        t107 = sqrt(t106);
        c59 = 1.0 / (2.0 * t107);
        t108 = 1.0 / t107;
        t107inv = 1.0 / t107;
        v2 = p3 * t108;
        b2 = -g4 * l3 * l3 * (a2 - p5);
        t109 = y1 * y0_3;
        b5 = y3_2 / t109;
        t109inv = 1.0 / t109;
        y17 = b5 * y4_2;
        t110 = atan(y17);
        c60 = 1.0 / (1.0 + y17 * y17);
        z10 = (1.0 - y2_2) * y17 + y2_2 * t110;
        t111 = atan(y17);
        c61 = 1.0 / (1.0 + y17 * y17);
        t112 = (1.0 - y2_2) * y17 + y2_2 * t111;
        t113 = atan(t112);
        c62 = 1.0 / (1.0 + t112 * t112);
        t114 = y1 * t113;
        t115 = cos(t114);
        c63 = -sin(t114);
        t116 = 1.0 + y17 * y17;
        t117 = y2_2 / t116;
        t116inv = 1.0 / t116;
        t118 = 1.0 + z10 * z10;
        t119 = y1 * (1.0 - y2_2 + t117) / t118;
        t118inv = 1.0 / t118;
        p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        x9 = p6 * kappa;
        t120 = 1.0 + x9 * x9;
        t121 = sqrt(t120);
        c64 = 1.0 / (2.0 * t121);
        t122 = 1.0 / t121;
        t121inv = 1.0 / t121;
        m = p6 * t122;
        ka = -g0 * m * m * kappa;
        t123 = x31 * x30;
        b6 = x33 / t123;
        t123inv = 1.0 / t123;
        y18 = b6 * x34;
        t124 = atan(y18);
        c65 = 1.0 / (1.0 + y18 * y18);
        z11 = (1.0 - x32) * y18 + x32 * t124;
        t125 = atan(y18);
        c66 = 1.0 / (1.0 + y18 * y18);
        t126 = (1.0 - x32) * y18 + x32 * t125;
        t127 = atan(t126);
        c67 = 1.0 / (1.0 + t126 * t126);
        t128 = x31 * t127;
        t129 = cos(t128);
        c68 = -sin(t128);
        t130 = 1.0 + y18 * y18;
        t131 = x32 / t130;
        t130inv = 1.0 / t130;
        t132 = 1.0 + z11 * z11;
        t133 = x31 * (1.0 - x32 + t131) / t132;
        t132inv = 1.0 / t132;
        ux = fx * gx / x30;
        x30inv = 1.0 / x30;
        uy = (fy * gy + g8) / y0_3;
        y0_3inv = 1.0 / y0_3;
        c69 = 1.0 / (2.0 * s[i][2]);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double b2d, b3d, b4d, b5d, b6d, c3d, cd, dvd, e11d, e12d, fxd, fyd, g6d, g7d, g8d, gxd,
              gyd, kad, l3d, md, n4d, n5d, p3d, p4d, p5d, p6d, s2d, s3d, shift2d, shiftd, t100d,
              t101d, t102d, t103d, t104d, t105d, t106d, t107d, t108d, t109d, t110d, t111d, t112d,
              t113d, t114d, t115d, t116d, t117d, t118d, t119d, t120d, t121d, t122d, t123d, t124d,
              t125d, t126d, t127d, t128d, t129d, t130d, t131d, t132d, t133d, t134d, t20d, t21d,
              t22d, t23d, t24d, t25d, t26d, t27d, t28d, t29d, t30d, t31d, t32d, t33d, t34d, t35d,
              t36d, t37d, t38d, t39d, t40d, t41d, t42d, t43d, t44d, t45d, t46d, t47d, t48d, t49d,
              t50d, t51d, t52d, t53d, t54d, t55d, t56d, t57d, t58d, t59d, t60d, t61d, t62d, t63d,
              t64d, t65d, t66d, t67d, t68d, t69d, t70d, t71d, t72d, t73d, t74d, t75d, t76d, t77d,
              t78d, t79d, t80d, t81d, t82d, t83d, t84d, t85d, t86d, t87d, t88d, t89d, t90d, t91d,
              t92d, t93d, t94d, t95d, t96d, t97d, t98d, t99d, uxd, uyd, v2d, wx1d, wy1d, x6d, x7d,
              x8d, x9d, y0_2d, y0d, y10d, y11d, y12d, y13d, y14d, y15d, y16d, y17d, y18d, y9d,
              z0_2d, z0d, z10d, z11d, z4d, z5d, z6d, z7d, z8d, z9d;

          g6d = y8d[nd];
          g7d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfzd[nd]);
          p3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4][nd];
          x6d = p3d * a2 + p3 * a2d[nd];
          t20d = x6d * x6 + x6 * x6d;
          t21d = c17 * t20d;
          t22d = -(t22 * t21d * t21inv);
          dvd = (peakd[nd] * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma) + peak *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd[nd]) +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3][nd] * gamma +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gammad[nd]))) * t22 + peak *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma) *
              t22d;
          t23d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6][nd] * kappa +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappad[nd];
          t24d = c18 * t23d;
          t25d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5][nd] * t24 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t24d;
          t26d = c19 * t25d;
          g8d = (dvd * t26 + dv * t26d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + dv *
              t26 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA][nd];
          y9d = g0d[nd] * (a2 + g3) + g0 * (a2d[nd] + g3d[nd]);
          y10d = g0d[nd] * g3 + g0 * g3d[nd];
          t27d = c20 * y9d;
          t28d = -(g2d[nd] * y9) + (1.0 - g2) * y9d + (g2d[nd] * t27 + g2 * t27d);
          t29d = c21 * t28d;
          t30d = g1d[nd] * t29 + g1 * t29d;
          t31d = c22 * t30d;
          t32d = c23 * y10d;
          t33d = -(g2d[nd] * y10) + (1.0 - g2) * y10d + (g2d[nd] * t32 + g2 * t32d);
          t34d = c24 * t33d;
          t35d = g1d[nd] * t34 + g1 * t34d;
          t36d = c25 * t35d;
          gxd = (t31d - gx * t36d) * t36inv;
          y11d = g4d[nd] * (kappa + g7) + g4 * (kappad[nd] + g7d);
          y12d = g4d[nd] * g7 + g4 * g7d;
          t37d = c26 * y11d;
          t38d = -(g6d * y11) + (1.0 - g6) * y11d + (g6d * t37 + g6 * t37d);
          t39d = c27 * t38d;
          t40d = g5d[nd] * t39 + g5 * t39d;
          t41d = c28 * t40d;
          t42d = c29 * y12d;
          t43d = -(g6d * y12) + (1.0 - g6) * y12d + (g6d * t42 + g6 * t42d);
          t44d = c30 * t43d;
          t45d = g5d[nd] * t44 + g5 * t44d;
          t46d = c31 * t45d;
          gyd = (t41d - gy * t46d) * t46inv;
          b3d = g0d[nd];
          cd = g1d[nd];
          e11d = g2d[nd];
          shiftd = g3d[nd];
          /* its derivatives by x and by b */
          y13d = b3d * (a2 + shift) + b3 * (a2d[nd] + shiftd);
          y0d = b3d * shift + b3 * shiftd;
          t47d = c32 * y13d;
          t48d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t47 + e11 * t47d);
          t49d = c33 * t48d;
          z4d = cd * t49 + c * t49d;
          t50d = c34 * y0d;
          t51d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t50 + e11 * t50d);
          t52d = c35 * t51d;
          z0d = cd * t52 + c * t52d;
          n4d = c36 * z0d;
          /* its derivative by y */
          t53d = c37 * y13d;
          z5d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t53 + e11 * t53d);
          t54d = c38 * z4d;
          t55d = y13d * y13 + y13 * y13d;
          t56d = (e11d - t56 * t55d) * t55inv;
          t57d = z5d * z5 + z5 * z5d;
          t58d = (cd * (1.0 - e11 + t56) + c * (-e11d + t56d) - t58 * t57d) * t57inv;
          s2d = (-(t54d * t58) - t54 * t58d - s2 * n4d) * n4inv;
          /* its derivative by y */
          t59d = c39 * y0d;
          z6d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t59 + e11 * t59d);
          t60d = c40 * z4d;
          t61d = c41 * z0d;
          t62d = n4d * n4 + n4 * n4d;
          t63d = (t60d * t61 + t60 * t61d - t63 * t62d) * t62inv;
          t64d = y0d * y0 + y0 * y0d;
          t65d = (e11d - t65 * t64d) * t64inv;
          t66d = z6d * z6 + z6 * z6d;
          t67d = (cd * (1.0 - e11 + t65) + c * (-e11d + t65d) - t67 * t66d) * t66inv;
          wx1d = s2d * (a2 + shift) + s2 * (a2d[nd] + shiftd) + ((t63d * t67 + t63 * t67d) * shift +
              t63 * t67 * shiftd);
          b4d = g4d[nd];
          c3d = g5d[nd];
          e12d = g6d;
          shift2d = g7d;
          /* its derivatives by x and by b */
          y14d = b4d * (kappa + shift2) + b4 * (kappad[nd] + shift2d);
          y0_2d = b4d * shift2 + b4 * shift2d;
          t68d = c42 * y14d;
          t69d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t68 + e12 * t68d);
          t70d = c43 * t69d;
          z7d = c3d * t70 + c3 * t70d;
          t71d = c44 * y0_2d;
          t72d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t71 + e12 * t71d);
          t73d = c45 * t72d;
          z0_2d = c3d * t73 + c3 * t73d;
          n5d = c46 * z0_2d;
          /* its derivative by y */
          t74d = c47 * y14d;
          z8d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t74 + e12 * t74d);
          t75d = c48 * z7d;
          t76d = y14d * y14 + y14 * y14d;
          t77d = (e12d - t77 * t76d) * t76inv;
          t78d = z8d * z8 + z8 * z8d;
          t79d = (c3d * (1.0 - e12 + t77) + c3 * (-e12d + t77d) - t79 * t78d) * t78inv;
          s3d = (-(t75d * t79) - t75 * t79d - s3 * n5d) * n5inv;
          /* its derivative by y */
          t80d = c49 * y0_2d;
          z9d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t80 + e12 * t80d);
          t81d = c50 * z7d;
          t82d = c51 * z0_2d;
          t83d = n5d * n5 + n5 * n5d;
          t84d = (t81d * t82 + t81 * t82d - t84 * t83d) * t83inv;
          t85d = y0_2d * y0_2 + y0_2 * y0_2d;
          t86d = (e12d - t86 * t85d) * t85inv;
          t87d = z9d * z9 + z9 * z9d;
          t88d = (c3d * (1.0 - e12 + t86) + c3 * (-e12d + t86d) - t88 * t87d) * t87inv;
          wy1d = s3d * (kappa + shift2) + s3 * (kappad[nd] + shift2d) + ((t84d * t88 + t84 * t88d) *
              shift2 + t84 * t88 * shift2d);
          t89d = x31d[nd] * x30 + x31 * x30d[nd];
          t90d = (x33d[nd] - t90 * t89d) * t89inv;
          y15d = t90d * x34 + t90 * x34d[nd];
          t91d = c52 * y15d;
          t92d = -(x32d[nd] * y15) + (1.0 - x32) * y15d + (x32d[nd] * t91 + x32 * t91d);
          t93d = c53 * t92d;
          t94d = x31d[nd] * t93 + x31 * t93d;
          t95d = c54 * t94d;
          fxd = x30d[nd] * t95 + x30 * t95d + x35d[nd];
          t96d = y1d[nd] * y0_3 + y1 * y0_3d[nd];
          t97d = (y3_2d[nd] - t97 * t96d) * t96inv;
          y16d = t97d * y4_2 + t97 * y4_2d[nd];
          t98d = c55 * y16d;
          t99d = -(y2_2d[nd] * y16) + (1.0 - y2_2) * y16d + (y2_2d[nd] * t98 + y2_2 * t98d);
          t100d = c56 * t99d;
          t101d = y1d[nd] * t100 + y1 * t100d;
          t102d = c57 * t101d;
          fyd = y0_3d[nd] * t102 + y0_3 * t102d + y5_2d[nd];
          p4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2][nd];
          p5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3][nd];
          /* b and the shift of Fy change with a by their cos(atan()) */
          x7d = p4d * (a2 - p5) + p4 * (a2d[nd] - p5d);
          t103d = x7d * x7 + x7 * x7d;
          t104d = c58 * t103d;
          t105d = -(t105 * t104d * t104inv);
          l3d = p4d * t105 + p4 * t105d;
          x8d = p3d * a2 + p3 * a2d[nd];
          t106d = x8d * x8 + x8 * x8d;
          t107d = c59 * t106d;
          t108d = -(t108 * t107d * t107inv);
          v2d = p3d * t108 + p3 * t108d;
          b2d = ((-(g4d[nd] * l3) - g4 * l3d) * l3 + -g4 * l3 * l3d) * (a2 - p5) + -g4 * l3 * l3 *
              (a2d[nd] - p5d);
          /* its derivative by the slip */
          t109d = y1d[nd] * y0_3 + y1 * y0_3d[nd];
          b5d = (y3_2d[nd] - b5 * t109d) * t109inv;
          y17d = b5d * y4_2 + b5 * y4_2d[nd];
          /* its derivative by y */
          t110d = c60 * y17d;
          z10d = -(y2_2d[nd] * y17) + (1.0 - y2_2) * y17d + (y2_2d[nd] * t110 + y2_2 * t110d);
          t111d = c61 * y17d;
          t112d = -(y2_2d[nd] * y17) + (1.0 - y2_2) * y17d + (y2_2d[nd] * t111 + y2_2 * t111d);
          t113d = c62 * t112d;
          t114d = y1d[nd] * t113 + y1 * t113d;
          t115d = c63 * t114d;
          t116d = y17d * y17 + y17 * y17d;
          t117d = (y2_2d[nd] - t117 * t116d) * t116inv;
          t118d = z10d * z10 + z10 * z10d;
          t119d = (y1d[nd] * (1.0 - y2_2 + t117) + y1 * (-y2_2d[nd] + t117d) - t119 * t118d) *
              t118inv;
          sd[i][0][nd] = (a2d[nd] * a2 + a2 * a2d[nd]) * (gy * (y0_3 * t115 * t119 * b5) + fy * wy1
              * b2 - g8 * v2 * v2 * a2) + (1.0 + a2 * a2) * (gyd * (y0_3 * t115 * t119 * b5) + gy *
              (((y0_3d[nd] * t115 + y0_3 * t115d) * t119 + y0_3 * t115 * t119d) * b5 + y0_3 * t115 *
              t119 * b5d) + ((fyd * wy1 + fy * wy1d) * b2 + fy * wy1 * b2d) - (((g8d * v2 + g8 *
              v2d) * v2 + g8 * v2 * v2d) * a2 + g8 * v2 * v2 * a2d[nd]));
          p6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2][nd];
          x9d = p6d * kappa + p6 * kappad[nd];
          t120d = x9d * x9 + x9 * x9d;
          t121d = c64 * t120d;
          t122d = -(t122 * t121d * t121inv);
          md = p6d * t122 + p6 * t122d;
          kad = ((-(g0d[nd] * m) - g0 * md) * m + -g0 * m * md) * kappa + -g0 * m * m * kappad[nd];
          /* its derivative by the slip */
          t123d = x31d[nd] * x30 + x31 * x30d[nd];
          b6d = (x33d[nd] - b6 * t123d) * t123inv;
          y18d = b6d * x34 + b6 * x34d[nd];
          /* its derivative by y */
          t124d = c65 * y18d;
          z11d = -(x32d[nd] * y18) + (1.0 - x32) * y18d + (x32d[nd] * t124 + x32 * t124d);
          t125d = c66 * y18d;
          t126d = -(x32d[nd] * y18) + (1.0 - x32) * y18d + (x32d[nd] * t125 + x32 * t125d);
          t127d = c67 * t126d;
          t128d = x31d[nd] * t127 + x31 * t127d;
          t129d = c68 * t128d;
          t130d = y18d * y18 + y18 * y18d;
          t131d = (x32d[nd] - t131 * t130d) * t130inv;
          t132d = z11d * z11 + z11 * z11d;
          t133d = (x31d[nd] * (1.0 - x32 + t131) + x31 * (-x32d[nd] + t131d) - t133 * t132d) *
              t132inv;
          sd[i][1][nd] = gxd * (x30 * t129 * t133 * b6) + gx * (((x30d[nd] * t129 + x30 * t129d) *
              t133 + x30 * t129 * t133d) * b6 + x30 * t129 * t133 * b6d) + ((fxd * wx1 + fx * wx1d)
              * ka + fx * wx1 * kad);
          uxd = (fxd * gx + fx * gxd - ux * x30d[nd]) * x30inv;
          uyd = (fyd * gy + fy * gyd + g8d - uy * y0_3d[nd]) * y0_3inv;
          t134d = uxd * ux + ux * uxd + (uyd * uy + uy * uyd);
          sd[i][2][nd] = c69 * t134d;
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
