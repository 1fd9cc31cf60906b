/* Tangent of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra and Za carry minus gravity; p begins with gravity */
void maggi_sensors_d(const maggi_topo *t, const double p[restrict t->np],
                     const double pd[restrict t->np], const double origin[restrict 3],
                     const double spring0[restrict t->nspring],
                     const double spring0d[restrict t->nspring], const double q[restrict t->nq],
                     const double qd[restrict t->nq], const double v[restrict t->nq],
                     const double vd[restrict t->nq], const double A[restrict t->nbody + 1][9],
                     const double Ad[restrict t->nbody + 1][9],
                     const double x[restrict t->nbody + 1][3],
                     const double xd[restrict t->nbody + 1][3],
                     const double r[restrict t->npoint][3], const double rd[restrict t->npoint][3],
                     const double Z[restrict t->nbody + 1][6],
                     const double Zd[restrict t->nbody + 1][6],
                     const double rv[restrict t->npoint][3],
                     const double rvd[restrict t->npoint][3],
                     const double Za[restrict t->nbody + 1][6],
                     const double Zad[restrict t->nbody + 1][6],
                     const double ra[restrict t->npoint][3],
                     const double rad[restrict t->npoint][3], const double lambda[restrict t->nrow],
                     const double lambdad[restrict t->nrow], double s[restrict t->nsensor][3],
                     double sd[restrict t->nsensor][3])
{
  int a, a2, b, b2, i, j, k, k2, n2;
  double A_j0, A_j0d, A_j3, A_j3d, A_j7, A_j7d, A_j8, A_j8d, Z_j3, Z_j3d, Z_j4, Z_j4d, c, c10, c11,
      c2, c2d, c2inv, c3, c4, c5, c6, c7, c8, c9, dampingd, e0, e0d, e1, e1d, e20, e20d, e21, e21d,
      e22, e22d, e2_2, e2_2d, ev0, ev0d, ev1, ev1d, ev20, ev20d, ev21, ev21d, ev22, ev22d, ev2_2,
      ev2_2d, f0d, f1d, f2d, l, l2, l2d, l2inv, ld, linv, lv, lvd, n30, n30d, n31, n31d, n32, n32d,
      p_k24, p_k24d, p_k25, p_k25d, roll, rolld, t2, t2d, t3, t3d, t4, t4d, t5, t5d, t5inv, t6, t6d,
      t7, t7d, torque0d, x2, x2d, xv, xvd, z0_2d, z0_3d, z0d, z1_2d, z1_3, z1_3d, z1d;

  (void)origin;
  (void)x;
  (void)Za;
  (void)ra;
  (void)lambda;
  for (i = 0; i < t->nsensor; ++i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n2 = t->sensorelement[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
      sd[i][0] = rd[k][0] - xd[t->nbody][0];
      sd[i][1] = rd[k][1] - xd[t->nbody][1];
      sd[i][2] = rd[k][2] - xd[t->nbody][2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
      sd[i][0] = rvd[k][0];
      sd[i][1] = rvd[k][1];
      sd[i][2] = rvd[k][2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ACCELERATION) {
      sd[i][0] = rad[k][0] + pd[0];
      sd[i][1] = rad[k][1] + pd[1];
      sd[i][2] = rad[k][2] + pd[2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j7d = Ad[j][7];
      A_j8 = A[j][8];
      A_j8d = Ad[j][8];
      c = A_j8 / (A_j8 * A_j8 + A_j7 * A_j7);
      c3 = -(A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      sd[i][0] = c * A_j7d + c3 * A_j8d;
      t2 = -A[j][6];
      t2d = -Ad[j][6];
      t3 = A_j7 * A_j7 + A_j8 * A_j8;
      t3d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
      t4 = sqrt(t3);
      c4 = 1.0 / (2.0 * t4);
      t4d = c4 * t3d;
      c5 = t4 / (t4 * t4 + t2 * t2);
      c6 = -(t2 / (t4 * t4 + t2 * t2));
      sd[i][1] = c5 * t2d + c6 * t4d;
      c7 = A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]);
      c8 = -(A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      sd[i][2] = c7 * Ad[j][3] + c8 * Ad[j][0];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      A_j0 = A[j][0];
      A_j0d = Ad[j][0];
      A_j3 = A[j][3];
      A_j3d = Ad[j][3];
      c2 = A_j0 * A_j0 + A_j3 * A_j3;
      /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
       * A_6 = -sin(pitch) */
      c2d = A_j0d * A_j0 + A_j0 * A_j0d + (A_j3d * A_j3 + A_j3 * A_j3d);
      Z_j3 = Z[j][3];
      Z_j3d = Zd[j][3];
      Z_j4 = Z[j][4];
      Z_j4d = Zd[j][4];
      roll = s[i][0];
      c2inv = 1.0 / c2;
      rolld = (A_j0d * Z_j3 + A_j0 * Z_j3d + (A_j3d * Z_j4 + A_j3 * Z_j4d) - roll * c2d) * c2inv;
      sd[i][0] = rolld;
      t5 = sqrt(c2);
      c9 = 1.0 / (2.0 * t5);
      t5d = c9 * c2d;
      t5inv = 1.0 / t5;
      sd[i][1] = (A_j0d * Z_j4 + A_j0 * Z_j4d - (A_j3d * Z_j3 + A_j3 * Z_j3d) - s[i][1] * t5d) *
          t5inv;
      sd[i][2] = Zd[j][5] - (Ad[j][6] * roll + A[j][6] * rolld);
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_VELOCITY) {
      sd[i][0] = Zd[j][3];
      sd[i][1] = Zd[j][4];
      sd[i][2] = Zd[j][5];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_ACCELERATION) {
      sd[i][0] = Zad[j][3];
      sd[i][1] = Zad[j][4];
      sd[i][2] = Zad[j][5];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SPRING) {
      a = t->springpa[n2];
      b = t->springpb[n2];
      e0 = r[a][0] - r[b][0];
      e0d = rd[a][0] - rd[b][0];
      ev0 = rv[a][0] - rv[b][0];
      ev0d = rvd[a][0] - rvd[b][0];
      e1 = r[a][1] - r[b][1];
      e1d = rd[a][1] - rd[b][1];
      ev1 = rv[a][1] - rv[b][1];
      ev1d = rvd[a][1] - rvd[b][1];
      e2_2 = r[a][2] - r[b][2];
      e2_2d = rd[a][2] - rd[b][2];
      ev2_2 = rv[a][2] - rv[b][2];
      ev2_2d = rvd[a][2] - rvd[b][2];
      t6 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
      t6d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
      l = sqrt(t6);
      c10 = 1.0 / (2.0 * l);
      ld = c10 * t6d;
      n30 = e0 / l;
      linv = 1.0 / l;
      n30d = (e0d - n30 * ld) * linv;
      n31 = e1 / l;
      n31d = (e1d - n31 * ld) * linv;
      n32 = e2_2 / l;
      n32d = (e2_2d - n32 * ld) * linv;
      lv = n30 * ev0 + n31 * ev1 + n32 * ev2_2;
      lvd = n30d * ev0 + n30 * ev0d + (n31d * ev1 + n31 * ev1d) + (n32d * ev2_2 + n32 * ev2_2d);
      dampingd = pd[t->springadr[n2] + MAGGI_SPRING_C] * lv + p[t->springadr[n2] + MAGGI_SPRING_C] *
          lvd;
      if (t->springpreload[n2]) {
        f0d = pd[t->springadr[n2]] * (l - spring0[n2]) + p[t->springadr[n2]] * (ld - spring0d[n2]) +
            pd[t->springadr[n2] + MAGGI_SPRING_L];
      } else {
        f0d = pd[t->springadr[n2]] * (l - p[t->springadr[n2] + MAGGI_SPRING_L]) +
            p[t->springadr[n2]] * (ld - pd[t->springadr[n2] + MAGGI_SPRING_L]);
      }
      k2 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
      if (t->springslopes[n2]) {
        /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
        if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
          p_k24 = p[k2 + 4];
          p_k24d = pd[k2 + 4];
          f2d = pd[k2] * p_k24 + p[k2] * p_k24d + (pd[k2 + 1] * (lv - p_k24) + p[k2 + 1] * (lvd -
              p_k24d));
        } else if (MAGGI_RE(lv) > 0.0) {
          f2d = pd[k2] * lv + p[k2] * lvd;
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
          f2d = pd[k2 + 2] * lv + p[k2 + 2] * lvd;
        } else {
          p_k25 = p[k2 + 5];
          p_k25d = pd[k2 + 5];
          f2d = pd[k2 + 2] * p_k25 + p[k2 + 2] * p_k25d + (pd[k2 + 3] * (lv - p_k25) + p[k2 + 3] *
              (lvd - p_k25d));
        }
        f1d = dampingd + f2d;
      } else {
        f1d = dampingd;
      }
      z0d = ld;
      z1d = lvd;
      sd[i][0] = z0d;
      sd[i][1] = z1d;
      sd[i][2] = f0d + f1d;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_JOINT_SPRING) {
      if (t->jspringq2[n2] >= 0) {
        x2 = q[t->jspringq[n2]] - q[t->jspringq2[n2]];
        x2d = qd[t->jspringq[n2]] - qd[t->jspringq2[n2]];
        xv = v[t->jspringq[n2]] - v[t->jspringq2[n2]];
        xvd = vd[t->jspringq[n2]] - vd[t->jspringq2[n2]];
      } else {
        x2 = q[t->jspringq[n2]];
        x2d = qd[t->jspringq[n2]];
        xv = v[t->jspringq[n2]];
        xvd = vd[t->jspringq[n2]];
      }
      torque0d = -(pd[t->jspringadr[n2]] * (x2 - p[t->jspringadr[n2] + MAGGI_JSPRING_REST])) -
          p[t->jspringadr[n2]] * (x2d - pd[t->jspringadr[n2] + MAGGI_JSPRING_REST]) -
          (pd[t->jspringadr[n2] + MAGGI_JSPRING_C] * xv + p[t->jspringadr[n2] + MAGGI_JSPRING_C] *
          xvd) - pd[t->jspringadr[n2] + MAGGI_JSPRING_PRELOAD];
      z0_2d = x2d;
      z1_2d = xvd;
      sd[i][0] = z0_2d;
      sd[i][1] = z1_2d;
      sd[i][2] = torque0d;
    } else {
      a2 = t->primpa[n2];
      b2 = t->primpb[n2];
      e20 = r[a2][0] - r[b2][0];
      /* distance of two points and its rate */
      e20d = rd[a2][0] - rd[b2][0];
      ev20 = rv[a2][0] - rv[b2][0];
      ev20d = rvd[a2][0] - rvd[b2][0];
      e21 = r[a2][1] - r[b2][1];
      e21d = rd[a2][1] - rd[b2][1];
      ev21 = rv[a2][1] - rv[b2][1];
      ev21d = rvd[a2][1] - rvd[b2][1];
      e22 = r[a2][2] - r[b2][2];
      e22d = rd[a2][2] - rd[b2][2];
      ev22 = rv[a2][2] - rv[b2][2];
      ev22d = rvd[a2][2] - rvd[b2][2];
      t7 = e20 * e20 + e21 * e21 + e22 * e22;
      t7d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 * e22d);
      l2 = sqrt(t7);
      c11 = 1.0 / (2.0 * l2);
      l2d = c11 * t7d;
      z0_3d = l2d;
      z1_3 = s[i][1];
      l2inv = 1.0 / l2;
      z1_3d = (e20d * ev20 + e20 * ev20d + (e21d * ev21 + e21 * ev21d) + (e22d * ev22 + e22 * ev22d)
          - z1_3 * l2d) * l2inv;
      sd[i][0] = z0_3d;
      sd[i][1] = z1_3d;
      sd[i][2] = lambdad[t->primrow[n2]];
    }
  }
}
