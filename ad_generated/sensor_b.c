/* Adjoint of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra and Za carry minus gravity; p begins with gravity */
void maggi_sensors_b(const maggi_topo *t, const double p[restrict t->np], double pb[restrict t->np],
                     const double origin[restrict 3], const double spring0[restrict t->nspring],
                     double spring0b[restrict t->nspring], const double q[restrict t->nq],
                     double qb[restrict t->nq], const double v[restrict t->nq],
                     double vb[restrict t->nq], const double A[restrict t->nbody + 1][9],
                     double Ab[restrict t->nbody + 1][9], const double x[restrict t->nbody + 1][3],
                     double xb[restrict t->nbody + 1][3], const double r[restrict t->npoint][3],
                     double rb[restrict t->npoint][3], const double Z[restrict t->nbody + 1][6],
                     double Zb[restrict t->nbody + 1][6], const double rv[restrict t->npoint][3],
                     double rvb[restrict t->npoint][3], const double Za[restrict t->nbody + 1][6],
                     double Zab[restrict t->nbody + 1][6], const double ra[restrict t->npoint][3],
                     double rab[restrict t->npoint][3], const double lambda[restrict t->nrow],
                     double lambdab[restrict t->nrow], double s[restrict t->nsensor][3],
                     double sb[restrict t->nsensor][3])
{
  int a, a2, b, b2, i, j, k, k2, n2;
  double A_j0, A_j0b, A_j3, A_j3b, A_j7, A_j7b, A_j8, A_j8b, Z_j3, Z_j3b, Z_j4, Z_j4b, c2, c2b,
      dampingb, e0, e0b, e1, e1b, e20, e20b, e21, e21b, e22, e22b, e2_2, e2_2b, ev0, ev0b, ev1,
      ev1b, ev20, ev20b, ev21, ev21b, ev22, ev22b, ev2_2, ev2_2b, f0b, f1b, f2b, l, l2, l2b, lb, lv,
      lvb, n30, n30b, n31, n31b, n32, n32b, p_k24, p_k24b, p_k25, p_k25b, roll, rollb, t2, t2b, t3,
      t3b, t4, t4b, t5, t5b, t6, t6b, t7, t7b, tb10, tb11, tb12, tb13, tb14, tb15, tb16, tb17, tb18,
      tb19, tb2, tb20, tb21, tb22, tb23, tb24, tb3, tb4, tb5, tb6, tb7, tb8, tb9, torque0b, x2, x2b,
      xv, xvb, z0_2b, z0_3b, z0b, z1_2b, z1_3, z1_3b, z1b;

  (void)origin;
  (void)x;
  (void)Za;
  (void)ra;
  (void)lambda;
  for (i = t->nsensor - 1; i >= 0; --i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n2 = t->sensorelement[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
      tb4 = sb[i][2];
      sb[i][2] = 0.0;
      rb[k][2] += tb4;
      xb[t->nbody][2] -= tb4;
      tb3 = sb[i][1];
      sb[i][1] = 0.0;
      rb[k][1] += tb3;
      xb[t->nbody][1] -= tb3;
      tb2 = sb[i][0];
      sb[i][0] = 0.0;
      rb[k][0] += tb2;
      xb[t->nbody][0] -= tb2;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
      rvb[k][2] += sb[i][2];
      sb[i][2] = 0.0;
      rvb[k][1] += sb[i][1];
      sb[i][1] = 0.0;
      rvb[k][0] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ACCELERATION) {
      tb7 = sb[i][2];
      sb[i][2] = 0.0;
      rab[k][2] += tb7;
      pb[2] += tb7;
      tb6 = sb[i][1];
      sb[i][1] = 0.0;
      rab[k][1] += tb6;
      pb[1] += tb6;
      tb5 = sb[i][0];
      sb[i][0] = 0.0;
      rab[k][0] += tb5;
      pb[0] += tb5;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j8 = A[j][8];
      t2 = -A[j][6];
      t3 = A_j7 * A_j7 + A_j8 * A_j8;
      t4 = sqrt(t3);
      tb10 = sb[i][2];
      sb[i][2] = 0.0;
      Ab[j][3] += tb10 * (A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      Ab[j][0] -= tb10 * (A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      tb9 = sb[i][1];
      sb[i][1] = 0.0;
      t2b = tb9 * (t4 / (t4 * t4 + t2 * t2));
      t4b = -(tb9 * (t2 / (t4 * t4 + t2 * t2)));
      t3b = t4b * (1.0 / (2.0 * t4));
      A_j7b = t3b * A_j7;
      A_j7b += t3b * A_j7;
      A_j8b = t3b * A_j8;
      A_j8b += t3b * A_j8;
      Ab[j][6] -= t2b;
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      tb8 = sb[i][0];
      sb[i][0] = 0.0;
      A_j7b += tb8 * (A_j8 / (A_j8 * A_j8 + A_j7 * A_j7));
      A_j8b -= tb8 * (A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      Ab[j][8] += A_j8b;
      Ab[j][7] += A_j7b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      A_j0 = A[j][0];
      A_j3 = A[j][3];
      c2 = A_j0 * A_j0 + A_j3 * A_j3;
      Z_j3 = Z[j][3];
      Z_j4 = Z[j][4];
      roll = s[i][0];
      t5 = sqrt(c2);
      tb14 = sb[i][2];
      sb[i][2] = 0.0;
      Zb[j][5] += tb14;
      Ab[j][6] -= tb14 * roll;
      rollb = -(tb14 * A[j][6]);
      tb12 = sb[i][1];
      sb[i][1] = 0.0;
      tb13 = tb12 / t5;
      A_j0b = tb13 * Z_j4;
      Z_j4b = tb13 * A_j0;
      A_j3b = -(tb13 * Z_j3);
      Z_j3b = -(tb13 * A_j3);
      t5b = -(tb13 * s[i][1]);
      c2b = t5b * (1.0 / (2.0 * t5));
      rollb += sb[i][0];
      sb[i][0] = 0.0;
      tb11 = rollb / c2;
      A_j0b += tb11 * Z_j3;
      Z_j3b += tb11 * A_j0;
      A_j3b += tb11 * Z_j4;
      Z_j4b += tb11 * A_j3;
      c2b -= tb11 * roll;
      Zb[j][4] += Z_j4b;
      Zb[j][3] += Z_j3b;
      /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
       * A_6 = -sin(pitch) */
      A_j0b += c2b * A_j0;
      A_j0b += c2b * A_j0;
      A_j3b += c2b * A_j3;
      A_j3b += c2b * A_j3;
      Ab[j][3] += A_j3b;
      Ab[j][0] += A_j0b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_VELOCITY) {
      Zb[j][5] += sb[i][2];
      sb[i][2] = 0.0;
      Zb[j][4] += sb[i][1];
      sb[i][1] = 0.0;
      Zb[j][3] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_ACCELERATION) {
      Zab[j][5] += sb[i][2];
      sb[i][2] = 0.0;
      Zab[j][4] += sb[i][1];
      sb[i][1] = 0.0;
      Zab[j][3] += sb[i][0];
      sb[i][0] = 0.0;
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
      n30 = e0 / l;
      n31 = e1 / l;
      n32 = e2_2 / l;
      lv = n30 * ev0 + n31 * ev1 + n32 * ev2_2;
      k2 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
      tb22 = sb[i][2];
      sb[i][2] = 0.0;
      f0b = tb22;
      f1b = tb22;
      z1b = sb[i][1];
      sb[i][1] = 0.0;
      z0b = sb[i][0];
      sb[i][0] = 0.0;
      lvb = z1b;
      lb = z0b;
      dampingb = 0.0;
      if (t->springslopes[n2]) {
        dampingb += f1b;
        f2b = f1b;
        f1b = 0.0;
        /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
        if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
          p_k24 = p[k2 + 4];
          pb[k2] += f2b * p_k24;
          p_k24b = f2b * p[k2];
          pb[k2 + 1] += f2b * (lv - p_k24);
          tb20 = f2b * p[k2 + 1];
          lvb += tb20;
          p_k24b -= tb20;
          f2b = 0.0;
          pb[k2 + 4] += p_k24b;
        } else if (MAGGI_RE(lv) > 0.0) {
          pb[k2] += f2b * lv;
          lvb += f2b * p[k2];
          f2b = 0.0;
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
          pb[k2 + 2] += f2b * lv;
          lvb += f2b * p[k2 + 2];
          f2b = 0.0;
        } else {
          p_k25 = p[k2 + 5];
          pb[k2 + 2] += f2b * p_k25;
          p_k25b = f2b * p[k2 + 2];
          pb[k2 + 3] += f2b * (lv - p_k25);
          tb21 = f2b * p[k2 + 3];
          lvb += tb21;
          p_k25b -= tb21;
          f2b = 0.0;
          pb[k2 + 5] += p_k25b;
        }
      } else {
        dampingb += f1b;
        f1b = 0.0;
      }
      if (t->springpreload[n2]) {
        pb[t->springadr[n2]] += f0b * (l - spring0[n2]);
        tb18 = f0b * p[t->springadr[n2]];
        lb += tb18;
        spring0b[n2] -= tb18;
        pb[t->springadr[n2] + MAGGI_SPRING_L] += f0b;
        f0b = 0.0;
      } else {
        pb[t->springadr[n2]] += f0b * (l - p[t->springadr[n2] + MAGGI_SPRING_L]);
        tb19 = f0b * p[t->springadr[n2]];
        lb += tb19;
        pb[t->springadr[n2] + MAGGI_SPRING_L] -= tb19;
        f0b = 0.0;
      }
      pb[t->springadr[n2] + MAGGI_SPRING_C] += dampingb * lv;
      lvb += dampingb * p[t->springadr[n2] + MAGGI_SPRING_C];
      n30b = lvb * ev0;
      ev0b = lvb * n30;
      n31b = lvb * ev1;
      ev1b = lvb * n31;
      n32b = lvb * ev2_2;
      ev2_2b = lvb * n32;
      tb17 = n32b / l;
      e2_2b = tb17;
      lb -= tb17 * n32;
      tb16 = n31b / l;
      e1b = tb16;
      lb -= tb16 * n31;
      tb15 = n30b / l;
      e0b = tb15;
      lb -= tb15 * n30;
      t6b = lb * (1.0 / (2.0 * l));
      e0b += t6b * e0;
      e0b += t6b * e0;
      e1b += t6b * e1;
      e1b += t6b * e1;
      e2_2b += t6b * e2_2;
      e2_2b += t6b * e2_2;
      rvb[a][2] += ev2_2b;
      rvb[b][2] -= ev2_2b;
      rb[a][2] += e2_2b;
      rb[b][2] -= e2_2b;
      rvb[a][1] += ev1b;
      rvb[b][1] -= ev1b;
      rb[a][1] += e1b;
      rb[b][1] -= e1b;
      rvb[a][0] += ev0b;
      rvb[b][0] -= ev0b;
      rb[a][0] += e0b;
      rb[b][0] -= e0b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_JOINT_SPRING) {
      if (t->jspringq2[n2] >= 0) {
        x2 = q[t->jspringq[n2]] - q[t->jspringq2[n2]];
        xv = v[t->jspringq[n2]] - v[t->jspringq2[n2]];
      } else {
        x2 = q[t->jspringq[n2]];
        xv = v[t->jspringq[n2]];
      }
      torque0b = sb[i][2];
      sb[i][2] = 0.0;
      z1_2b = sb[i][1];
      sb[i][1] = 0.0;
      z0_2b = sb[i][0];
      sb[i][0] = 0.0;
      xvb = z1_2b;
      x2b = z0_2b;
      pb[t->jspringadr[n2]] -= torque0b * (x2 - p[t->jspringadr[n2] + MAGGI_JSPRING_REST]);
      tb23 = torque0b * p[t->jspringadr[n2]];
      x2b -= tb23;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_REST] += tb23;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_C] -= torque0b * xv;
      xvb -= torque0b * p[t->jspringadr[n2] + MAGGI_JSPRING_C];
      pb[t->jspringadr[n2] + MAGGI_JSPRING_PRELOAD] -= torque0b;
      if (t->jspringq2[n2] >= 0) {
        vb[t->jspringq[n2]] += xvb;
        vb[t->jspringq2[n2]] -= xvb;
        xvb = 0.0;
        qb[t->jspringq[n2]] += x2b;
        qb[t->jspringq2[n2]] -= x2b;
        x2b = 0.0;
      } else {
        vb[t->jspringq[n2]] += xvb;
        xvb = 0.0;
        qb[t->jspringq[n2]] += x2b;
        x2b = 0.0;
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
      z1_3 = s[i][1];
      lambdab[t->primrow[n2]] += sb[i][2];
      sb[i][2] = 0.0;
      z1_3b = sb[i][1];
      sb[i][1] = 0.0;
      z0_3b = sb[i][0];
      sb[i][0] = 0.0;
      tb24 = z1_3b / l2;
      e20b = tb24 * ev20;
      ev20b = tb24 * e20;
      e21b = tb24 * ev21;
      ev21b = tb24 * e21;
      e22b = tb24 * ev22;
      ev22b = tb24 * e22;
      l2b = -(tb24 * z1_3);
      l2b += z0_3b;
      t7b = l2b * (1.0 / (2.0 * l2));
      e20b += t7b * e20;
      e20b += t7b * e20;
      e21b += t7b * e21;
      e21b += t7b * e21;
      e22b += t7b * e22;
      e22b += t7b * e22;
      rvb[a2][2] += ev22b;
      rvb[b2][2] -= ev22b;
      rb[a2][2] += e22b;
      rb[b2][2] -= e22b;
      rvb[a2][1] += ev21b;
      rvb[b2][1] -= ev21b;
      rb[a2][1] += e21b;
      rb[b2][1] -= e21b;
      rvb[a2][0] += ev20b;
      rvb[b2][0] -= ev20b;
      /* distance of two points and its rate */
      rb[a2][0] += e20b;
      rb[b2][0] -= e20b;
    }
  }
}
