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
                      double s[restrict t->nsensor][3],
                      double sd[restrict t->nsensor][3][MAGGI_NDIR], int nbdirs)
{
  int a, a2, b, b2, i, j, k, k2, n2, nd;
  double A_j0, A_j3, A_j7, A_j8, Z_j3, Z_j4, c, c10, c11, c2, c2inv, c3, c4, c5, c6, c7, c8, c9, e0,
      e1, e20, e21, e22, e2_2, ev0, ev1, ev20, ev21, ev22, ev2_2, l, l2, l2inv, linv, lv, n30, n31,
      n32, p_k24, p_k25, roll, t2, t3, t4, t5, t5inv, t6, t7, x2, xv, z1_3;
  double dampingd[MAGGI_NDIR], f0d[MAGGI_NDIR], f1d[MAGGI_NDIR], f2d[MAGGI_NDIR], ld[MAGGI_NDIR],
      lvd[MAGGI_NDIR], x2d[MAGGI_NDIR], xvd[MAGGI_NDIR];

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
      c = A_j8 / (A_j8 * A_j8 + A_j7 * A_j7);
      c3 = -(A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      t2 = -A[j][6];
      t3 = A_j7 * A_j7 + A_j8 * A_j8;
      t4 = sqrt(t3);
      c4 = 1.0 / (2.0 * t4);
      c5 = t4 / (t4 * t4 + t2 * t2);
      c6 = -(t2 / (t4 * t4 + t2 * t2));
      c7 = A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]);
      c8 = -(A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_j7d, A_j8d, t2d, t3d, t4d;

        A_j7d = Ad[j][7][nd];
        A_j8d = Ad[j][8][nd];
        /* R = Rz(yaw) Ry(pitch) Rx(roll) */
        sd[i][0][nd] = c * A_j7d + c3 * A_j8d;
        t2d = -Ad[j][6][nd];
        t3d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
        t4d = c4 * t3d;
        sd[i][1][nd] = c5 * t2d + c6 * t4d;
        sd[i][2][nd] = c7 * Ad[j][3][nd] + c8 * Ad[j][0][nd];
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
      c9 = 1.0 / (2.0 * t5);
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
        t5d = c9 * c2d;
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
      c10 = 1.0 / (2.0 * l);
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
        ld[nd] = c10 * t6d;
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
    } else {
      a2 = t->primpa[n2];
      b2 = t->primpb[n2];
      e20 = r[a2][0] - r[b2][0];
      ev20 = rv[a2][0] - rv[b2][0];
      e21 = r[a2][1] - r[b2][1];
      ev21 = rv[a2][1] - rv[b2][1];
      e22 = r[a2][2] - r[b2][2];
      ev22 = rv[a2][2] - rv[b2][2];
      t7 = e20 * e20 + e21 * e21 + e22 * e22;
      l2 = sqrt(t7);
      c11 = 1.0 / (2.0 * l2);
      z1_3 = s[i][1];
      l2inv = 1.0 / l2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e20d, e21d, e22d, ev20d, ev21d, ev22d, l2d, t7d, z0_3d, z1_3d;

        /* distance of two points and its rate */
        e20d = rd[a2][0][nd] - rd[b2][0][nd];
        ev20d = rvd[a2][0][nd] - rvd[b2][0][nd];
        e21d = rd[a2][1][nd] - rd[b2][1][nd];
        ev21d = rvd[a2][1][nd] - rvd[b2][1][nd];
        e22d = rd[a2][2][nd] - rd[b2][2][nd];
        ev22d = rvd[a2][2][nd] - rvd[b2][2][nd];
        t7d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 * e22d);
        l2d = c11 * t7d;
        z0_3d = l2d;
        z1_3d = (e20d * ev20 + e20 * ev20d + (e21d * ev21 + e21 * ev21d) + (e22d * ev22 + e22 *
            ev22d) - z1_3 * l2d) * l2inv;
        sd[i][0][nd] = z0_3d;
        sd[i][1][nd] = z1_3d;
        sd[i][2][nd] = lambdad[t->primrow[n2]][nd];
      }
    }
  }
}
