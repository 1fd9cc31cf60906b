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
  int a, a4, a4_2, b, b2, b2_2, i, j, k, k2, n2, nd;
  double A_j0, A_j3, A_j7, A_j8, L0, L1, L2, N0, N1, N2, T0, T1, T2, Z_j3, Z_j4, Z_k3, Z_k4, Z_k5,
      a00, a01, a02, a2, a3, along0, along1, along2, ar, areq, arm0, arm1, arm2, at, ateq, ay, br,
      bt, bx, by, bycy, c, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c2, c20, c21, c22, c23,
      c24, c25, c26, c27, c28, c29, c2inv, c3, c30, c31, c32, c33, c34, c35, c36, c37, c38, c39, c4,
      c40, c41, c42, c43, c44, c45, c46, c47, c48, c49, c5, c50, c51, c52, c53, c6, c7, c8, c9, ca,
      cx, cy, dfz, dr, dt, dv, dx, dy, e0, e1, e10, e11, e12, e13, e20, e21, e22, e2_2, e3, e4, e5,
      e6, e7, e8, e9, et, ev0, ev1, ev20, ev21, ev22, ev2_2, ex, ey, fx, fy, fz, fz0, fz0_2,
      fz0_2inv, fz0_3, fz0_4, fz0_4inv, fz0inv, fz2, g0, g20, g21, g2_2, gamma, gamma2, gx, gy, gz,
      h00, h10, h11, inv, inv2, inv3, kappa, kappa2, kx, l, l2, l2inv, linv, lv, mux, muy, muy2,
      n30, n31, n32, n4, n4inv, n50, n51, n52, omega, one0, one1, one2, one3, one4, p10, p10inv, p2,
      p2inv, p3, p4, p4inv, p5, p6, p7, p8, p9, p_b2, p_b2_2, p_b2_2inv, p_b2_3, p_b2_4, p_b2_5,
      p_b2_5inv, p_b2_6, p_k24, p_k25, r0, r2, ratio, ratio2, re, rhov, roll, s2, s2inv, s3, s4,
      shift, shy, side, slip1, speed2, speed2inv, speed3, stiff, stiff2, stiff2inv, stiff3, stiff4,
      svx, svy, t10, t11, t11inv, t12, t13, t14, t15, t16, t17, t18, t19, t2, t20, t21, t22, t23,
      t24, t25, t26, t26inv, t27, t28, t29, t3, t30, t31, t32, t32inv, t33, t33inv, t34, t34inv,
      t35, t36, t36inv, t37, t38, t39, t4, t40, t41, t42, t43, t44, t44inv, t45, t46, t47, t47inv,
      t48, t49, t5, t50, t51, t52, t53, t54, t55, t56, t57, t58, t58inv, t59, t5inv, t6, t60, t61,
      t62, t63, t64, t64inv, t65, t66, t67, t68, t69, t7, t70, t71, t72, t73, t74, t75, t75inv, t76,
      t77, t78, t79, t79inv, t8, t80, t81, t82, t83, t84, t85, t85inv, t86, t87, t88, t89, t9, t90,
      t91, t92, t92inv, t93, t94, t95, t96, t97, u20, u21, u22, ua0, ua1, ua2, un0, un1, un2, v20,
      v21, v22, vr0, vr1, vr2, vx, w, way, winv, wr0, wr1, wr2, x2, x3, x4, x50, x51, x6, x7, x8,
      x9, xv, y, y10, y11, y12, y13, y14, y15, y16, y17, y18, y20, y21, y21inv, y22, y23, y24, y3,
      y4, y5, y6, y7, y8, y9, z1_3, z20, z21, z22, z22inv, z30, z4, z5, z6;
  double L0d[MAGGI_NDIR], L1d[MAGGI_NDIR], L2d[MAGGI_NDIR], a2d[MAGGI_NDIR], a3d[MAGGI_NDIR],
      areqd[MAGGI_NDIR], atd[MAGGI_NDIR], ateqd[MAGGI_NDIR], ayd[MAGGI_NDIR], btd[MAGGI_NDIR],
      bycyd[MAGGI_NDIR], cxd[MAGGI_NDIR], cyd[MAGGI_NDIR], dampingd[MAGGI_NDIR], dfzd[MAGGI_NDIR],
      dtd[MAGGI_NDIR], dxd[MAGGI_NDIR], dyd[MAGGI_NDIR], e10d[MAGGI_NDIR], e12d[MAGGI_NDIR],
      e13d[MAGGI_NDIR], e3d[MAGGI_NDIR], e4d[MAGGI_NDIR], e5d[MAGGI_NDIR], e6d[MAGGI_NDIR],
      e7d[MAGGI_NDIR], e8d[MAGGI_NDIR], exd[MAGGI_NDIR], eyd[MAGGI_NDIR], f0d[MAGGI_NDIR],
      f1d[MAGGI_NDIR], f2d[MAGGI_NDIR], fxd[MAGGI_NDIR], fyd[MAGGI_NDIR], fz0_2d[MAGGI_NDIR],
      fz0_3d[MAGGI_NDIR], fz0_4d[MAGGI_NDIR], fz2d[MAGGI_NDIR], fzd[MAGGI_NDIR], g0d[MAGGI_NDIR],
      g20d[MAGGI_NDIR], g21d[MAGGI_NDIR], g2_2d[MAGGI_NDIR], gamma2d[MAGGI_NDIR],
      gammad[MAGGI_NDIR], gyd[MAGGI_NDIR], gzd[MAGGI_NDIR], h00d[MAGGI_NDIR], h10d[MAGGI_NDIR],
      h11d[MAGGI_NDIR], kappa2d[MAGGI_NDIR], kappad[MAGGI_NDIR], kxd[MAGGI_NDIR], ld[MAGGI_NDIR],
      lvd[MAGGI_NDIR], muy2d[MAGGI_NDIR], muyd[MAGGI_NDIR], omegad[MAGGI_NDIR], one0d[MAGGI_NDIR],
      one1d[MAGGI_NDIR], one2d[MAGGI_NDIR], one3d[MAGGI_NDIR], one4d[MAGGI_NDIR], r0d[MAGGI_NDIR],
      red[MAGGI_NDIR], rolling0d[MAGGI_NDIR], rolling1d[MAGGI_NDIR], rolling2d[MAGGI_NDIR],
      rolling3d[MAGGI_NDIR], rolling4d[MAGGI_NDIR], rolling5d[MAGGI_NDIR], shyd[MAGGI_NDIR],
      slip0d[MAGGI_NDIR], slip1d[MAGGI_NDIR], slip2d[MAGGI_NDIR], stiff3d[MAGGI_NDIR],
      stiff4d[MAGGI_NDIR], u20d[MAGGI_NDIR], u21d[MAGGI_NDIR], u22d[MAGGI_NDIR], v20d[MAGGI_NDIR],
      v21d[MAGGI_NDIR], v22d[MAGGI_NDIR], vxd[MAGGI_NDIR], x2d[MAGGI_NDIR], x3d[MAGGI_NDIR],
      x4d[MAGGI_NDIR], x50d[MAGGI_NDIR], x51d[MAGGI_NDIR], xvd[MAGGI_NDIR], y10d[MAGGI_NDIR],
      y13d[MAGGI_NDIR], y16d[MAGGI_NDIR], y17d[MAGGI_NDIR], y20d[MAGGI_NDIR], y21d[MAGGI_NDIR],
      y23d[MAGGI_NDIR], y24d[MAGGI_NDIR], y3d[MAGGI_NDIR], y4d[MAGGI_NDIR], y6d[MAGGI_NDIR],
      y7d[MAGGI_NDIR], y8d[MAGGI_NDIR], yd[MAGGI_NDIR], z21d[MAGGI_NDIR], z22d[MAGGI_NDIR],
      z4d[MAGGI_NDIR];

  (void)origin;
  (void)x;
  (void)Za;
  (void)ra;
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
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j8 = A[j][8];
      c3 = A_j8 / (A_j8 * A_j8 + A_j7 * A_j7);
      c4 = -(A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      t2 = -A[j][6];
      t3 = A_j7 * A_j7 + A_j8 * A_j8;
      t4 = sqrt(t3);
      c5 = 1.0 / (2.0 * t4);
      c6 = t4 / (t4 * t4 + t2 * t2);
      c7 = -(t2 / (t4 * t4 + t2 * t2));
      c8 = A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]);
      c9 = -(A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j7d, A_j8d, t2d, t3d, t4d;

        A_j7d = Ad[j][7][nd];
        A_j8d = Ad[j][8][nd];
        /* R = Rz(yaw) Ry(pitch) Rx(roll) */
        sd[i][0][nd] = c3 * A_j7d + c4 * A_j8d;
        t2d = -Ad[j][6][nd];
        t3d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
        t4d = c5 * t3d;
        sd[i][1][nd] = c6 * t2d + c7 * t4d;
        sd[i][2][nd] = c8 * Ad[j][3][nd] + c9 * Ad[j][0][nd];
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
      c10 = 1.0 / (2.0 * t5);
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
        t5d = c10 * c2d;
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
      c11 = 1.0 / (2.0 * l);
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
        ld[nd] = c11 * t6d;
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
      a4 = t->primpa[n2];
      b2 = t->primpb[n2];
      e20 = r[a4][0] - r[b2][0];
      ev20 = rv[a4][0] - rv[b2][0];
      e21 = r[a4][1] - r[b2][1];
      ev21 = rv[a4][1] - rv[b2][1];
      e22 = r[a4][2] - r[b2][2];
      ev22 = rv[a4][2] - rv[b2][2];
      t7 = e20 * e20 + e21 * e21 + e22 * e22;
      l2 = sqrt(t7);
      c12 = 1.0 / (2.0 * l2);
      z1_3 = s[i][1];
      l2inv = 1.0 / l2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e20d, e21d, e22d, ev20d, ev21d, ev22d, l2d, t7d, z0_3d, z1_3d;

        /* distance of two points and its rate */
        e20d = rd[a4][0][nd] - rd[b2][0][nd];
        ev20d = rvd[a4][0][nd] - rvd[b2][0][nd];
        e21d = rd[a4][1][nd] - rd[b2][1][nd];
        ev21d = rvd[a4][1][nd] - rvd[b2][1][nd];
        e22d = rd[a4][2][nd] - rd[b2][2][nd];
        ev22d = rvd[a4][2][nd] - rvd[b2][2][nd];
        t7d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 * e22d);
        l2d = c12 * t7d;
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
      a4_2 = t->wheelpoint[n2];
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
      t8 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
      n4 = sqrt(t8);
      c13 = 1.0 / (2.0 * n4);
      u20 = ua0 / n4;
      n4inv = 1.0 / n4;
      u21 = ua1 / n4;
      u22 = ua2 / n4;
      g0 = r[a4_2][0] - r[t->roadpoint[b2_2]][0];
      g2_2 = r[a4_2][2] - r[t->roadpoint[b2_2]][2];
      x4 = g0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double a00d, a01d, a02d, n4d, t8d, ua0d, ua1d, ua2d;

        a00d = pd[t->wheelaxis[n2]][nd];
        a01d = pd[t->wheelaxis[n2] + 1][nd];
        a02d = pd[t->wheelaxis[n2] + 2][nd];
        ua0d = Ad[j][0][nd] * a00 + A[j][0] * a00d + (Ad[j][1][nd] * a01 + A[j][1] * a01d) +
            (Ad[j][2][nd] * a02 + A[j][2] * a02d);
        ua1d = Ad[j][3][nd] * a00 + A[j][3] * a00d + (Ad[j][4][nd] * a01 + A[j][4] * a01d) +
            (Ad[j][5][nd] * a02 + A[j][5] * a02d);
        ua2d = Ad[j][6][nd] * a00 + A[j][6] * a00d + (Ad[j][7][nd] * a01 + A[j][7] * a01d) +
            (Ad[j][8][nd] * a02 + A[j][8] * a02d);
        t8d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
        n4d = c13 * t8d;
        u20d[nd] = (ua0d - u20 * n4d) * n4inv;
        u21d[nd] = (ua1d - u21 * n4d) * n4inv;
        u22d[nd] = (ua2d - u22 * n4d) * n4inv;
        g0d[nd] = rd[a4_2][0][nd] - rd[t->roadpoint[b2_2]][0][nd];
        g2_2d[nd] = rd[a4_2][2][nd] - rd[t->roadpoint[b2_2]][2][nd];
        /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
         * the centre down the disc meets it, n its normal; then down the disc to that plane,
         *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
         * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
        x4d[nd] = g0d[nd];
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
        t9 = 6.28318530717958647693 * x4 / p_b2_2;
        p_b2_2inv = 1.0 / p_b2_2;
        t10 = sin(t9);
        c14 = cos(t9);
        p_b2_3 = p[t->roadadr[b2_2]];
        h00 = p_b2_3 * t10;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_b2_2d, p_b2_3d, t10d, t9d;

          p_b2_2d = pd[t->roadadr[b2_2] + 1][nd];
          t9d = (6.28318530717958647693 * x4d[nd] - t9 * p_b2_2d) * p_b2_2inv;
          t10d = c14 * t9d;
          p_b2_3d = pd[t->roadadr[b2_2]][nd];
          h00d[nd] = p_b2_3d * t10 + p_b2_3 * t10d;
        }
      }
      t11 = u20 * u20 + u21 * u21;
      t12 = u22 * u20 / t11;
      t11inv = 1.0 / t11;
      x3 = g0 + t12 * (g2_2 - h00);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t11d, t12d;

        t11d = u20d[nd] * u20 + u20 * u20d[nd] + (u21d[nd] * u21 + u21 * u21d[nd]);
        t12d = (u22d[nd] * u20 + u22 * u20d[nd] - t12 * t11d) * t11inv;
        x3d[nd] = g0d[nd] + (t12d * (g2_2 - h00) + t12 * (g2_2d[nd] - h00d[nd]));
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
        t13 = 6.28318530717958647693 * x3 / p_b2_5;
        p_b2_5inv = 1.0 / p_b2_5;
        t14 = sin(t13);
        c15 = cos(t13);
        p_b2_6 = p[t->roadadr[b2_2]];
        h10 = p_b2_6 * t14;
        t15 = p_b2_6 * 6.28318530717958647693 / p_b2_5;
        t16 = 6.28318530717958647693 * x3 / p_b2_5;
        t17 = cos(t16);
        c16 = -sin(t16);
        h11 = t15 * t17;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_b2_5d, p_b2_6d, t13d, t14d, t15d, t16d, t17d;

          p_b2_5d = pd[t->roadadr[b2_2] + 1][nd];
          t13d = (6.28318530717958647693 * x3d[nd] - t13 * p_b2_5d) * p_b2_5inv;
          t14d = c15 * t13d;
          p_b2_6d = pd[t->roadadr[b2_2]][nd];
          h10d[nd] = p_b2_6d * t14 + p_b2_6 * t14d;
          t15d = (p_b2_6d * 6.28318530717958647693 - t15 * p_b2_5d) * p_b2_5inv;
          t16d = (6.28318530717958647693 * x3d[nd] - t16 * p_b2_5d) * p_b2_5inv;
          t17d = c16 * t16d;
          h11d[nd] = t15d * t17 + t15 * t17d;
        }
      }
      t18 = 1.0 + h11 * h11;
      s2 = sqrt(t18);
      c17 = 1.0 / (2.0 * s2);
      n50 = -h11 / s2;
      s2inv = 1.0 / s2;
      n51 = 0.0;
      n52 = 1.0 / s2;
      c = u20 * n50 + u21 * n51 + u22 * n52;
      un0 = u21 * n52 - u22 * n51;
      un1 = u22 * n50 - u20 * n52;
      un2 = u20 * n51 - u21 * n50;
      t19 = un0 * un0 + un1 * un1 + un2 * un2;
      w = sqrt(t19);
      c18 = 1.0 / (2.0 * w);
      r2 = ((g0 - x3) * n50 + (g2_2 - h10) * n52) / w;
      winv = 1.0 / w;
      along0 = un0 / w;
      along1 = un1 / w;
      along2 = un2 / w;
      L0 = n51 * along2 - n52 * along1;
      L1 = n52 * along0 - n50 * along2;
      L2 = n50 * along1 - n51 * along0;
      arm0 = r2 * (c * u20 - n50) / w;
      T0 = along0;
      N0 = n50;
      arm1 = r2 * (c * u21 - n51) / w;
      T1 = along1;
      N1 = n51;
      arm2 = r2 * (c * u22 - n52) / w;
      T2 = along2;
      N2 = n52;
      z20 = r2;
      z21 = c;
      z22 = w;
      Z_k3 = Z[k][3];
      wr0 = Z_k3;
      Z_k4 = Z[k][4];
      wr1 = Z_k4;
      Z_k5 = Z[k][5];
      wr2 = Z_k5;
      vr0 = wr1 * arm2 - wr2 * arm1;
      vr1 = wr2 * arm0 - wr0 * arm2;
      vr2 = wr0 * arm1 - wr1 * arm0;
      v20 = rv[a4_2][0] + vr0;
      v21 = rv[a4_2][1] + vr1;
      v22 = rv[a4_2][2] + vr2;
      vx = v20 * T0 + v21 * T1 + v22 * T2;
      rhov = -(v20 * N0 + v21 * N1 + v22 * N2) / z22;
      z22inv = 1.0 / z22;
      omega = (Z[j][3] - Z_k3) * u20 + (Z[j][4] - Z_k4) * u21 + (Z[j][5] - Z_k5) * u22;
      p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
      fz = p2 * (p3 - z20) + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
      fz0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]];
      ratio = fz / fz0;
      fz0inv = 1.0 / fz0;
      t20 = fz0 / p2;
      p2inv = 1.0 / p2;
      t21 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratio;
      t22 = atan(t21);
      c19 = 1.0 / (1.0 + t21 * t21);
      re = p3 - t20 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double N0d, N2d, T0d, T1d, T2d, Z_k3d, Z_k4d, Z_k5d, along0d, along1d, along2d, arm0d,
            arm1d, arm2d, cd, fz0d, n50d, n52d, p2d, p3d, r2d, ratiod, rhovd, s2d, t18d, t19d, t20d,
            t21d, t22d, un0d, un1d, un2d, vr0d, vr1d, vr2d, wd, wr0d, wr1d, wr2d, z20d;

        t18d = h11d[nd] * h11 + h11 * h11d[nd];
        s2d = c17 * t18d;
        n50d = (-h11d[nd] - n50 * s2d) * s2inv;
        n52d = -(n52 * s2d * s2inv);
        cd = u20d[nd] * n50 + u20 * n50d + u21d[nd] * n51 + (u22d[nd] * n52 + u22 * n52d);
        un0d = u21d[nd] * n52 + u21 * n52d - u22d[nd] * n51;
        un1d = u22d[nd] * n50 + u22 * n50d - (u20d[nd] * n52 + u20 * n52d);
        un2d = u20d[nd] * n51 - (u21d[nd] * n50 + u21 * n50d);
        t19d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
        wd = c18 * t19d;
        r2d = ((g0d[nd] - x3d[nd]) * n50 + (g0 - x3) * n50d + ((g2_2d[nd] - h10d[nd]) * n52 + (g2_2
            - h10) * n52d) - r2 * wd) * winv;
        along0d = (un0d - along0 * wd) * winv;
        along1d = (un1d - along1 * wd) * winv;
        along2d = (un2d - along2 * wd) * winv;
        L0d[nd] = n51 * along2d - (n52d * along1 + n52 * along1d);
        L1d[nd] = n52d * along0 + n52 * along0d - (n50d * along2 + n50 * along2d);
        L2d[nd] = n50d * along1 + n50 * along1d - n51 * along0d;
        arm0d = (r2d * (c * u20 - n50) + r2 * (cd * u20 + c * u20d[nd] - n50d) - arm0 * wd) * winv;
        T0d = along0d;
        N0d = n50d;
        arm1d = (r2d * (c * u21 - n51) + r2 * (cd * u21 + c * u21d[nd]) - arm1 * wd) * winv;
        T1d = along1d;
        arm2d = (r2d * (c * u22 - n52) + r2 * (cd * u22 + c * u22d[nd] - n52d) - arm2 * wd) * winv;
        T2d = along2d;
        N2d = n52d;
        z20d = r2d;
        z21d[nd] = cd;
        z22d[nd] = wd;
        Z_k3d = Zd[k][3][nd];
        wr0d = Z_k3d;
        Z_k4d = Zd[k][4][nd];
        wr1d = Z_k4d;
        Z_k5d = Zd[k][5][nd];
        wr2d = Z_k5d;
        vr0d = wr1d * arm2 + wr1 * arm2d - (wr2d * arm1 + wr2 * arm1d);
        vr1d = wr2d * arm0 + wr2 * arm0d - (wr0d * arm2 + wr0 * arm2d);
        vr2d = wr0d * arm1 + wr0 * arm1d - (wr1d * arm0 + wr1 * arm0d);
        v20d[nd] = rvd[a4_2][0][nd] + vr0d;
        v21d[nd] = rvd[a4_2][1][nd] + vr1d;
        v22d[nd] = rvd[a4_2][2][nd] + vr2d;
        vxd[nd] = v20d[nd] * T0 + v20 * T0d + (v21d[nd] * T1 + v21 * T1d) + (v22d[nd] * T2 + v22 *
            T2d);
        rhovd = (-(v20d[nd] * N0 + v20 * N0d + v21d[nd] * N1 + (v22d[nd] * N2 + v22 * N2d)) - rhov *
            z22d[nd]) * z22inv;
        omegad[nd] = (Zd[j][3][nd] - Z_k3d) * u20 + (Z[j][3] - Z_k3) * u20d[nd] + ((Zd[j][4][nd] -
            Z_k4d) * u21 + (Z[j][4] - Z_k4) * u21d[nd]) + ((Zd[j][5][nd] - Z_k5d) * u22 + (Z[j][5] -
            Z_k5) * u22d[nd]);
        p2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS][nd];
        p3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS][nd];
        fzd[nd] = p2d * (p3 - z20) + p2 * (p3d - z20d) + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_VERTICAL_DAMPING][nd] * rhov + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
        fz0d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO][nd] *
            p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
            pd[t->tyreadr[t->wheeltyre[n2]]][nd];
        ratiod = (fzd[nd] - ratio * fz0d) * fz0inv;
        t20d = (fz0d - t20 * p2d) * p2inv;
        t21d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF][nd] * ratio +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratiod;
        t22d = c19 * t21d;
        red[nd] = p3d - (t20d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio) + t20 *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF][nd] * t22 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22d +
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
        t23 = vx * vx / p4;
        p4inv = 1.0 / p4;
        y = 0.5 * (p4 + t23);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p4d, t23d;

          p4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW][nd];
          t23d = (vxd[nd] * vx + vx * vxd[nd] - t23 * p4d) * p4inv;
          yd[nd] = 0.5 * (p4d + t23d);
        }
      }
      speed2 = y;
      kappa = (omega * re - vx) / speed2;
      speed2inv = 1.0 / speed2;
      a2 = (v20 * L0 + v21 * L1 + v22 * L2) / speed2;
      gamma = atan2(z21, z22);
      c20 = z22 / (z22 * z22 + z21 * z21);
      c21 = -(z21 / (z22 * z22 + z21 * z21));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double speed2d;

        speed2d = yd[nd];
        kappad[nd] = (omegad[nd] * re + omega * red[nd] - vxd[nd] - kappa * speed2d) * speed2inv;
        a2d[nd] = (v20d[nd] * L0 + v20 * L0d[nd] + (v21d[nd] * L1 + v21 * L1d[nd]) + (v22d[nd] * L2
            + v22 * L2d[nd]) - a2 * speed2d) * speed2inv;
        gammad[nd] = c20 * z21d[nd] + c21 * z22d[nd];
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
          t24 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
          t25 = exp(t24);
          stiff = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t25 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          t26 = cx * dx;
          bx = stiff / t26;
          t26inv = 1.0 / t26;
          svx = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUX];
          y5 = bx * kx;
          t27 = atan(y5);
          c22 = 1.0 / (1.0 + y5 * y5);
          t28 = (1.0 - ex) * y5 + ex * t27;
          t29 = atan(t28);
          c23 = 1.0 / (1.0 + t28 * t28);
          t30 = cx * t29;
          t31 = sin(t30);
          c24 = cos(t30);
          x50 = dx * t31 + svx;
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
            double bxd, stiffd, svxd, t24d, t25d, t26d, t27d, t28d, t29d, t30d, t31d, y5d;

            t24d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfzd[nd];
            t25d = t25 * t24d;
            stiffd = ((fz2d[nd] * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd[nd]))) * t25 + fz2 *
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_PKX2] * dfz) * t25d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX]
                + fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t25 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX][nd];
            t26d = cxd[nd] * dx + cx * dxd[nd];
            bxd = (stiffd - bx * t26d) * t26inv;
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
            t27d = c22 * y5d;
            t28d = -(exd[nd] * y5) + (1.0 - ex) * y5d + (exd[nd] * t27 + ex * t27d);
            t29d = c23 * t28d;
            t30d = cxd[nd] * t29 + cx * t29d;
            t31d = c24 * t30d;
            x50d[nd] = dxd[nd] * t31 + dx * t31d + svxd;
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
          t32 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3;
          z4 = fz2 / t32;
          t32inv = 1.0 / t32;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double t32d;

            t32d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2][nd] * fz0_3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3d[nd];
            z4d[nd] = (fz2d[nd] - z4 * t32d) * t32inv;
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
            t33 = p5 * p5;
            z5 = gy * gy / t33;
            t33inv = 1.0 / t33;
            y8 = 0.125 * p5 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              double p5d, t33d, z5d;

              p5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER][nd];
              t33d = p5d * p5 + p5 * p5d;
              z5d = (gyd[nd] * gy + gy * gyd[nd] - z5 * t33d) * t33inv;
              y8d[nd] = (0.125 * p5d * z5 + 0.125 * p5 * z5d) * (15.0 + z5 * (-10.0 + 3.0 * z5)) +
                  0.125 * p5 * z5 * (z5d * (-10.0 + 3.0 * z5) + z5 * (3.0 * z5d));
            }
          }
          t34 = 1.0 + z4 * z4;
          t35 = 2.0 * z4 / t34;
          t34inv = 1.0 / t34;
          stiff2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          t36 = cy * dy;
          by = stiff2 / t36;
          t36inv = 1.0 / t36;
          svy = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          y9 = by * ay;
          t37 = atan(y9);
          c25 = 1.0 / (1.0 + y9 * y9);
          t38 = (1.0 - ey) * y9 + ey * t37;
          t39 = atan(t38);
          c26 = 1.0 / (1.0 + t38 * t38);
          t40 = cy * t39;
          t41 = sin(t40);
          c27 = cos(t40);
          y20 = dy * t41 + svy;
          y21 = stiff2;
          y22 = muy;
          y23 = by * cy;
          t42 = svy / stiff2;
          stiff2inv = 1.0 / stiff2;
          y24 = shy + t42;
          muy2 = y22;
          x6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          t43 = 1.0 + x6 * x6;
          t44 = sqrt(t43);
          c28 = 1.0 / (2.0 * t44);
          t45 = 1.0 / t44;
          t44inv = 1.0 / t44;
          stiff3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t45 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          e10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_REY2] * dfz;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double byd, stiff2d, svyd, t34d, t35d, t36d, t37d, t38d, t39d, t40d, t41d, t42d, t43d,
                t44d, t45d, x6d, y22d, y9d;

            t34d = z4d[nd] * z4 + z4 * z4d[nd];
            t35d = (2.0 * z4d[nd] - t35 * t34d) * t34inv;
            stiff2d = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1][nd] * fz0_3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3d[nd]) * t35 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35d) * (1.0 -
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) -
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3][nd] * y8 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8d[nd])) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PKY1] * fz0_3 * t35 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_PKY3] * y8) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY][nd];
            t36d = cyd[nd] * dy + cy * dyd[nd];
            byd = (stiff2d - by * t36d) * t36inv;
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
            t37d = c25 * y9d;
            t38d = -(eyd[nd] * y9) + (1.0 - ey) * y9d + (eyd[nd] * t37 + ey * t37d);
            t39d = c26 * t38d;
            t40d = cyd[nd] * t39 + cy * t39d;
            t41d = c27 * t40d;
            y20d[nd] = dyd[nd] * t41 + dy * t41d + svyd;
            y21d[nd] = stiff2d;
            y22d = muyd[nd];
            y23d[nd] = byd * cy + by * cyd[nd];
            t42d = (svyd - t42 * stiff2d) * stiff2inv;
            y24d[nd] = shyd[nd] + t42d;
            muy2d[nd] = y22d;
            /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
            x6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2][nd] * (a3 -
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_RBY2] * (a3d[nd] - pd[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_RBY3][nd]);
            t43d = x6d * x6 + x6 * x6d;
            t44d = c28 * t43d;
            t45d = -(t45 * t44d * t44inv);
            stiff3d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1][nd] * t45 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t45d) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_RBY1] * t45 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA][nd];
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
          t46 = 1.0 + x7 * x7;
          t47 = sqrt(t46);
          c29 = 1.0 / (2.0 * t47);
          t48 = 1.0 / t47;
          t47inv = 1.0 / t47;
          dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) * t48;
          y11 = stiff3 * (kappa2 + s4);
          y12 = stiff3 * s4;
          t49 = atan(y11);
          c30 = 1.0 / (1.0 + y11 * y11);
          t50 = (1.0 - e9) * y11 + e9 * t49;
          t51 = atan(t50);
          c31 = 1.0 / (1.0 + t50 * t50);
          p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
          t52 = p6 * t51;
          t53 = cos(t52);
          c32 = -sin(t52);
          t54 = atan(y12);
          c33 = 1.0 / (1.0 + y12 * y12);
          t55 = (1.0 - e9) * y12 + e9 * t54;
          t56 = atan(t55);
          c34 = 1.0 / (1.0 + t55 * t55);
          t57 = p6 * t56;
          t58 = cos(t57);
          c35 = -sin(t57);
          g20 = t53 / t58;
          t58inv = 1.0 / t58;
          t59 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2;
          t60 = atan(t59);
          c36 = 1.0 / (1.0 + t59 * t59);
          t61 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t60;
          t62 = sin(t61);
          c37 = cos(t61);
          g21 = dv * t62 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          x8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2;
          t63 = 1.0 + x8 * x8;
          t64 = sqrt(t63);
          c38 = 1.0 / (2.0 * t64);
          t65 = 1.0 / t64;
          t64inv = 1.0 / t64;
          stiff4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t65 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          e12 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_REX2] * dfz;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double dvd, e9d, p6d, s4d, t46d, t47d, t48d, t49d, t50d, t51d, t52d, t53d, t54d, t55d,
                t56d, t57d, t58d, t59d, t60d, t61d, t62d, t63d, t64d, t65d, x7d, x8d, y11d, y12d;

            e9d = y10d[nd];
            s4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfzd[nd]);
            x7d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4][nd] * a3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] * a3d[nd];
            t46d = x7d * x7 + x7 * x7d;
            t47d = c29 * t46d;
            t48d = -(t48 * t47d * t47inv);
            dvd = ((muy2d[nd] * fz2 + muy2 * fz2d[nd]) * (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) + muy2 * fz2 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd[nd]) +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3][nd] * gamma2 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2d[nd]))) * t48 + muy2 *
                fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) * t48d;
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y11d = stiff3d[nd] * (kappa2 + s4) + stiff3 * (kappa2d[nd] + s4d);
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y12d = stiff3d[nd] * s4 + stiff3 * s4d;
            t49d = c30 * y11d;
            t50d = -(e9d * y11) + (1.0 - e9) * y11d + (e9d * t49 + e9 * t49d);
            t51d = c31 * t50d;
            p6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1][nd];
            t52d = p6d * t51 + p6 * t51d;
            t53d = c32 * t52d;
            t54d = c33 * y12d;
            t55d = -(e9d * y12) + (1.0 - e9) * y12d + (e9d * t54 + e9 * t54d);
            t56d = c34 * t55d;
            t57d = p6d * t56 + p6 * t56d;
            t58d = c35 * t57d;
            g20d[nd] = (t53d - g20 * t58d) * t58inv;
            t59d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6][nd] * kappa2 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2d[nd];
            t60d = c36 * t59d;
            t61d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5][nd] * t60 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t60d;
            t62d = c37 * t61d;
            g21d[nd] = (dvd * t62 + dv * t62d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA]
                + dv * t62 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA][nd];
            /* Gxa = Fx / Fx0 */
            x8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2][nd] * kappa2 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2d[nd];
            t63d = x8d * x8 + x8 * x8d;
            t64d = c38 * t63d;
            t65d = -(t65 * t64d * t64inv);
            stiff4d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1][nd] * t65 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t65d) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_RBX1] * t65 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL][nd];
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
          t66 = atan(y14);
          c39 = 1.0 / (1.0 + y14 * y14);
          t67 = (1.0 - e11) * y14 + e11 * t66;
          t68 = atan(t67);
          c40 = 1.0 / (1.0 + t67 * t67);
          p8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
          t69 = p8 * t68;
          t70 = cos(t69);
          c41 = -sin(t69);
          t71 = atan(y15);
          c42 = 1.0 / (1.0 + y15 * y15);
          t72 = (1.0 - e11) * y15 + e11 * t71;
          t73 = atan(t72);
          c43 = 1.0 / (1.0 + t72 * t72);
          t74 = p8 * t73;
          t75 = cos(t74);
          c44 = -sin(t74);
          t76 = t70 / t75;
          t75inv = 1.0 / t75;
          fx = x50 * t76;
          fy = g20 * y20 + g21;
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
          t77 = at * at + ratio2 * ratio2 + 1e-24;
          ateq = sqrt(t77);
          c45 = 1.0 / (2.0 * ateq);
          t78 = ar * ar + ratio2 * ratio2 + 1e-24;
          areq = sqrt(t78);
          c46 = 1.0 / (2.0 * areq);
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double ard, e11d, p7d, p8d, ratio2d, shiftd, t66d, t67d, t68d, t69d, t70d, t71d, t72d,
                t73d, t74d, t75d, t76d, t77d, t78d, y14d, y15d;

            e11d = y13d[nd];
            p7d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1][nd];
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y14d = stiff4d[nd] * (a3 + p7) + stiff4 * (a3d[nd] + p7d);
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y15d = stiff4d[nd] * p7 + stiff4 * p7d;
            t66d = c39 * y14d;
            t67d = -(e11d * y14) + (1.0 - e11) * y14d + (e11d * t66 + e11 * t66d);
            t68d = c40 * t67d;
            p8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1][nd];
            t69d = p8d * t68 + p8 * t68d;
            t70d = c41 * t69d;
            t71d = c42 * y15d;
            t72d = -(e11d * y15) + (1.0 - e11) * y15d + (e11d * t71 + e11 * t71d);
            t73d = c43 * t72d;
            t74d = p8d * t73 + p8 * t73d;
            t75d = c44 * t74d;
            t76d = (t70d - t76 * t75d) * t75inv;
            fxd[nd] = x50d[nd] * t76 + x50 * t76d;
            fyd[nd] = g20d[nd] * y20 + g20 * y20d[nd] + g21d[nd];
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
            t77d = atd[nd] * at + at * atd[nd] + (ratio2d * ratio2 + ratio2 * ratio2d);
            ateqd[nd] = c45 * t77d;
            t78d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
            areqd[nd] = c46 * t78d;
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
            t79 = p9 * p9;
            z6 = gz * gz / t79;
            t79inv = 1.0 / t79;
            y16 = 0.125 * p9 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              double p9d, t79d, z6d;

              p9d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER][nd];
              t79d = p9d * p9 + p9 * p9d;
              z6d = (gzd[nd] * gz + gz * gzd[nd] - z6 * t79d) * t79inv;
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
          t80 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
          fz0_4inv = 1.0 / fz0_4;
          dt = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t80 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          t81 = bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * at;
          t82 = atan(t81);
          c47 = 1.0 / (1.0 + t81 * t81);
          e13 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
              dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t82);
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double t80d, t81d, t82d;

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
            t80d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS][nd] - t80 *
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
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gzd[nd]))) * t80 + fz2 *
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3]
                * gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t80d) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] + fz2 *
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3]
                * gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t80 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR][nd];
            t81d = (btd[nd] * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] + bt *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1][nd]) * at + bt *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * atd[nd];
            t82d = c47 * t81d;
            e13d[nd] = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfzd[nd]) +
                ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfzd[nd]) * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfzd[nd])) * (1.0 +
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t82) +
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
                dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5][nd] * gz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gzd[nd])) *
                0.63661977236758134308 * t82 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
                t82d);
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
          t83 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LKY] / p10;
          p10inv = 1.0 / p10;
          br = t83 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycy;
          dr = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] * p10;
          t84 = 1.0 + a3 * a3;
          t85 = sqrt(t84);
          c48 = 1.0 / (2.0 * t85);
          ca = 1.0 / t85;
          t85inv = 1.0 / t85;
          y18 = bt * ateq;
          t86 = atan(y18);
          c49 = 1.0 / (1.0 + y18 * y18);
          t87 = (1.0 - et) * y18 + et * t86;
          t88 = atan(t87);
          c50 = 1.0 / (1.0 + t87 * t87);
          t89 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t88;
          t90 = cos(t89);
          c51 = -sin(t89);
          z30 = dt * t90 * ca;
          x9 = br * areq;
          t91 = 1.0 + x9 * x9;
          t92 = sqrt(t91);
          c52 = 1.0 / (2.0 * t92);
          t93 = 1.0 / t92;
          t92inv = 1.0 / t92;
          t94 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
          s3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t94 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LS];
          t95 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          inv2 = 1.0 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          way = tanh(t95);
          speed3 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          inv3 = 1.0 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          t96 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
          t97 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double brd, cad, drd, etd, force0d, force1d, force2d, force3d, force4d, force5d, p10d,
                s3d, speed3d, t83d, t84d, t85d, t86d, t87d, t88d, t89d, t90d, t91d, t92d, t93d,
                t94d, t95d, t96d, t97d, wayd, x9d, y18d, z30d, z31d;

            etd = y17d[nd];
            p10d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY][nd];
            t83d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9][nd] *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_QBZ9] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY][nd] - t83 *
                p10d) * p10inv;
            brd = t83d + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10][nd] * bycy +
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
            t84d = a3d[nd] * a3 + a3 * a3d[nd];
            t85d = c48 * t84d;
            cad = -(ca * t85d * t85inv);
            /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
            y18d = btd[nd] * ateq + bt * ateqd[nd];
            t86d = c49 * y18d;
            t87d = -(etd * y18) + (1.0 - et) * y18d + (etd * t86 + et * t86d);
            t88d = c50 * t87d;
            t89d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1][nd] * t88 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t88d;
            t90d = c51 * t89d;
            z30d = (dtd[nd] * t90 + dt * t90d) * ca + dt * t90 * cad;
            x9d = brd * areq + br * areqd[nd];
            t91d = x9d * x9 + x9 * x9d;
            t92d = c52 * t91d;
            t93d = -(t93 * t92d * t92inv);
            z31d = (drd * t93 + dr * t93d) * ca + dr * t93 * cad;
            t94d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2][nd] * fy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fyd[nd] - t94 * fz0_2d[nd]) *
                fz0_2inv;
            s3d = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1][nd] + t94d +
                ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3][nd] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4][nd] * dfz +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfzd[nd])) * gamma2 +
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_SSZ4] * dfz) * gamma2d[nd])) * r0 + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_SSZ1] + t94 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0d[nd]) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] + (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_SSZ1] + t94 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS][nd];
            t95d = (one4d[nd] - t95 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED][nd]) *
                inv2;
            wayd = (1.0 - way * way) * t95d;
            speed3d = (one4d[nd] - speed3 * pd[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_LONGVL][nd]) * inv3;
            force0d = fxd[nd];
            force1d = fyd[nd];
            force2d = fz2d[nd];
            t96d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3][nd] * fy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fyd[nd] - t96 * fz0_2d[nd]) *
                fz0_2inv;
            force3d = (r0d[nd] * fz2 + r0 * fz2d[nd]) * (p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_QSX1] * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] +
                (-p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2 + t96) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX]) + r0 * fz2 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1][nd] *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_QSX1] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX][nd] +
                ((-(pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2][nd] * gamma2) -
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2d[nd] + t96d) *
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[n2]]
                + MAGGI_TYRE_QSX2] * gamma2 + t96) * pd[t->tyreadr[t->wheeltyre[n2]] +
                MAGGI_TYRE_LMX][nd]));
            t97d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2][nd] * fx +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fxd[nd] - t97 * fz0_2d[nd]) *
                fz0_2inv;
            force4d = (((-(wayd * r0) - way * r0d[nd]) * fz2 + -way * r0 * fz2d[nd]) *
                (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t97 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
                speed3) + -way * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1][nd]
                + t97d + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3][nd] * way +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3d) +
                ((((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4][nd] * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) *
                speed3 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 *
                speed3 * speed3d))) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY] + -way * r0 *
                fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t97 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
                speed3) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY][nd];
            force5d = -(z30d * (fy - g21)) - z30 * (fyd[nd] - g21d[nd]) + z31d + (s3d * fx + s3 *
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
        c53 = 1.0 / (1.0 + slip1 * slip1);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][0][nd] = slip0d[nd];
          sd[i][1][nd] = c53 * slip1d[nd];
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
