/* Tangent of the adjoint of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra and Za carry minus gravity; p begins with gravity */
void maggi_sensors_b_d(const maggi_topo *t, const double p[restrict t->np],
                       const double pd[restrict t->np], double pb[restrict t->np],
                       double pbd[restrict t->np], const double origin[restrict 3],
                       const double spring0[restrict t->nspring],
                       const double spring0d[restrict t->nspring],
                       double spring0b[restrict t->nspring], double spring0bd[restrict t->nspring],
                       const double q[restrict t->nq], const double qd[restrict t->nq],
                       double qb[restrict t->nq], double qbd[restrict t->nq],
                       const double v[restrict t->nq], const double vd[restrict t->nq],
                       double vb[restrict t->nq], double vbd[restrict t->nq],
                       const double A[restrict t->nbody + 1][9],
                       const double Ad[restrict t->nbody + 1][9],
                       double Ab[restrict t->nbody + 1][9], double Abd[restrict t->nbody + 1][9],
                       const double x[restrict t->nbody + 1][3],
                       const double xd[restrict t->nbody + 1][3],
                       double xb[restrict t->nbody + 1][3], double xbd[restrict t->nbody + 1][3],
                       const double r[restrict t->npoint][3],
                       const double rd[restrict t->npoint][3], double rb[restrict t->npoint][3],
                       double rbd[restrict t->npoint][3], const double Z[restrict t->nbody + 1][6],
                       const double Zd[restrict t->nbody + 1][6],
                       double Zb[restrict t->nbody + 1][6], double Zbd[restrict t->nbody + 1][6],
                       const double rv[restrict t->npoint][3],
                       const double rvd[restrict t->npoint][3], double rvb[restrict t->npoint][3],
                       double rvbd[restrict t->npoint][3],
                       const double Za[restrict t->nbody + 1][6],
                       const double Zad[restrict t->nbody + 1][6],
                       double Zab[restrict t->nbody + 1][6], double Zabd[restrict t->nbody + 1][6],
                       const double ra[restrict t->npoint][3],
                       const double rad[restrict t->npoint][3], double rab[restrict t->npoint][3],
                       double rabd[restrict t->npoint][3], const double lambda[restrict t->nrow],
                       const double lambdad[restrict t->nrow], double lambdab[restrict t->nrow],
                       double lambdabd[restrict t->nrow], double s[restrict t->nsensor][3],
                       double sd[restrict t->nsensor][3], double sb[restrict t->nsensor][3],
                       double sbd[restrict t->nsensor][3])
{
  int a, a2, b, b2, i, j, k, k2, n2;
  double A_j0, A_j0b, A_j0bd, A_j0d, A_j3, A_j3b, A_j3bd, A_j3d, A_j7, A_j7b, A_j7bd, A_j7d, A_j8,
      A_j8b, A_j8bd, A_j8d, Z_j3, Z_j3b, Z_j3bd, Z_j3d, Z_j4, Z_j4b, Z_j4bd, Z_j4d, c2, c2b, c2bd,
      c2d, dampingb, dampingbd, e0, e0b, e0bd, e0d, e1, e1b, e1bd, e1d, e20, e20b, e20bd, e20d, e21,
      e21b, e21bd, e21d, e22, e22b, e22bd, e22d, e2_2, e2_2b, e2_2bd, e2_2d, ev0, ev0b, ev0bd, ev0d,
      ev1, ev1b, ev1bd, ev1d, ev20, ev20b, ev20bd, ev20d, ev21, ev21b, ev21bd, ev21d, ev22, ev22b,
      ev22bd, ev22d, ev2_2, ev2_2b, ev2_2bd, ev2_2d, f0b, f0bd, f1b, f1bd, f2b, f2bd, l, l2, l2b,
      l2bd, l2d, lb, lbd, ld, lv, lvb, lvbd, lvd, n30, n30b, n30bd, n30d, n31, n31b, n31bd, n31d,
      n32, n32b, n32bd, n32d, p_k24, p_k24b, p_k24bd, p_k24d, p_k25, p_k25b, p_k25bd, p_k25d, roll,
      rollb, rollbd, rolld, t2, t2b, t2bd, t2d, t3, t3b, t3bd, t3d, t4, t4b, t4bd, t4d, t5, t5b,
      t5bd, t5d, t6, t6b, t6bd, t6d, t7, t7b, t7bd, t7d, tb10, tb10d, tb11, tb11d, tb12, tb12d,
      tb13, tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d, tb17, tb17d, tb18, tb18d, tb19, tb19d,
      tb2, tb20, tb20d, tb21, tb21d, tb22, tb22d, tb23, tb23d, tb24, tb24d, tb2d, tb3, tb3d, tb4,
      tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d, torque0b, torque0bd, x2, x2b,
      x2bd, x2d, xv, xvb, xvbd, xvd, z0_2b, z0_2bd, z0_3b, z0_3bd, z0b, z0bd, z1_2b, z1_2bd, z1_3,
      z1_3b, z1_3bd, z1_3d, z1b, z1bd;

  (void)origin;
  (void)x;
  (void)xd;
  (void)Za;
  (void)Zad;
  (void)ra;
  (void)rad;
  (void)lambda;
  (void)lambdad;
  for (i = t->nsensor - 1; i >= 0; --i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n2 = t->sensorelement[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
      tb4 = sb[i][2];
      tb4d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      rb[k][2] += tb4;
      rbd[k][2] += tb4d;
      xb[t->nbody][2] -= tb4;
      xbd[t->nbody][2] -= tb4d;
      tb3 = sb[i][1];
      tb3d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      rb[k][1] += tb3;
      rbd[k][1] += tb3d;
      xb[t->nbody][1] -= tb3;
      xbd[t->nbody][1] -= tb3d;
      tb2 = sb[i][0];
      tb2d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      rb[k][0] += tb2;
      rbd[k][0] += tb2d;
      xb[t->nbody][0] -= tb2;
      xbd[t->nbody][0] -= tb2d;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
      rvb[k][2] += sb[i][2];
      rvbd[k][2] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      rvb[k][1] += sb[i][1];
      rvbd[k][1] += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      rvb[k][0] += sb[i][0];
      rvbd[k][0] += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ACCELERATION) {
      tb7 = sb[i][2];
      tb7d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      rab[k][2] += tb7;
      rabd[k][2] += tb7d;
      pb[2] += tb7;
      pbd[2] += tb7d;
      tb6 = sb[i][1];
      tb6d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      rab[k][1] += tb6;
      rabd[k][1] += tb6d;
      pb[1] += tb6;
      pbd[1] += tb6d;
      tb5 = sb[i][0];
      tb5d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      rab[k][0] += tb5;
      rabd[k][0] += tb5d;
      pb[0] += tb5;
      pbd[0] += tb5d;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j7d = Ad[j][7];
      A_j8 = A[j][8];
      A_j8d = Ad[j][8];
      t2 = -A[j][6];
      t2d = -Ad[j][6];
      t3 = A_j7 * A_j7 + A_j8 * A_j8;
      t3d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
      t4 = sqrt(t3);
      t4d = 1.0 / (2.0 * t4) * t3d;
      tb10 = sb[i][2];
      tb10d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Ab[j][3] += tb10 * (A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      Abd[j][3] += tb10d * (A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3])) + tb10 * ((Ad[j][0] -
          A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]) * (Ad[j][0] * A[j][0] + A[j][0] *
          Ad[j][0] + (Ad[j][3] * A[j][3] + A[j][3] * Ad[j][3]))) / (A[j][0] * A[j][0] + A[j][3] *
          A[j][3]));
      Ab[j][0] -= tb10 * (A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      Abd[j][0] -= tb10d * (A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3])) + tb10 * ((Ad[j][3] -
          A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]) * (Ad[j][0] * A[j][0] + A[j][0] *
          Ad[j][0] + (Ad[j][3] * A[j][3] + A[j][3] * Ad[j][3]))) / (A[j][0] * A[j][0] + A[j][3] *
          A[j][3]));
      tb9 = sb[i][1];
      tb9d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      t2b = tb9 * (t4 / (t4 * t4 + t2 * t2));
      t2bd = tb9d * (t4 / (t4 * t4 + t2 * t2)) + tb9 * ((t4d - t4 / (t4 * t4 + t2 * t2) * (t4d * t4
          + t4 * t4d + (t2d * t2 + t2 * t2d))) / (t4 * t4 + t2 * t2));
      t4b = -(tb9 * (t2 / (t4 * t4 + t2 * t2)));
      t4bd = -(tb9d * (t2 / (t4 * t4 + t2 * t2)) + tb9 * ((t2d - t2 / (t4 * t4 + t2 * t2) * (t4d *
          t4 + t4 * t4d + (t2d * t2 + t2 * t2d))) / (t4 * t4 + t2 * t2)));
      t3b = t4b * (1.0 / (2.0 * t4));
      t3bd = t4bd * (1.0 / (2.0 * t4)) - t4b * (1.0 / (2.0 * t4) * (2.0 * t4d) / (2.0 * t4));
      A_j7b = t3b * A_j7;
      A_j7bd = t3bd * A_j7 + t3b * A_j7d;
      A_j7b += t3b * A_j7;
      A_j7bd += t3bd * A_j7 + t3b * A_j7d;
      A_j8b = t3b * A_j8;
      A_j8bd = t3bd * A_j8 + t3b * A_j8d;
      A_j8b += t3b * A_j8;
      A_j8bd += t3bd * A_j8 + t3b * A_j8d;
      Ab[j][6] -= t2b;
      Abd[j][6] -= t2bd;
      tb8 = sb[i][0];
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      tb8d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      A_j7b += tb8 * (A_j8 / (A_j8 * A_j8 + A_j7 * A_j7));
      A_j7bd += tb8d * (A_j8 / (A_j8 * A_j8 + A_j7 * A_j7)) + tb8 * ((A_j8d - A_j8 / (A_j8 * A_j8 +
          A_j7 * A_j7) * (A_j8d * A_j8 + A_j8 * A_j8d + (A_j7d * A_j7 + A_j7 * A_j7d))) / (A_j8 *
          A_j8 + A_j7 * A_j7));
      A_j8b -= tb8 * (A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      A_j8bd -= tb8d * (A_j7 / (A_j8 * A_j8 + A_j7 * A_j7)) + tb8 * ((A_j7d - A_j7 / (A_j8 * A_j8 +
          A_j7 * A_j7) * (A_j8d * A_j8 + A_j8 * A_j8d + (A_j7d * A_j7 + A_j7 * A_j7d))) / (A_j8 *
          A_j8 + A_j7 * A_j7));
      Ab[j][8] += A_j8b;
      Abd[j][8] += A_j8bd;
      Ab[j][7] += A_j7b;
      Abd[j][7] += A_j7bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      A_j0 = A[j][0];
      A_j0d = Ad[j][0];
      A_j3 = A[j][3];
      A_j3d = Ad[j][3];
      c2 = A_j0 * A_j0 + A_j3 * A_j3;
      c2d = A_j0d * A_j0 + A_j0 * A_j0d + (A_j3d * A_j3 + A_j3 * A_j3d);
      Z_j3 = Z[j][3];
      Z_j3d = Zd[j][3];
      Z_j4 = Z[j][4];
      Z_j4d = Zd[j][4];
      roll = s[i][0];
      rolld = sd[i][0];
      t5 = sqrt(c2);
      t5d = 1.0 / (2.0 * t5) * c2d;
      tb14 = sb[i][2];
      tb14d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Zb[j][5] += tb14;
      Zbd[j][5] += tb14d;
      Ab[j][6] -= tb14 * roll;
      Abd[j][6] -= tb14d * roll + tb14 * rolld;
      rollb = -(tb14 * A[j][6]);
      rollbd = -(tb14d * A[j][6] + tb14 * Ad[j][6]);
      tb12 = sb[i][1];
      tb12d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      tb13 = tb12 / t5;
      tb13d = (tb12d - tb13 * t5d) * (1.0 / t5);
      A_j0b = tb13 * Z_j4;
      A_j0bd = tb13d * Z_j4 + tb13 * Z_j4d;
      Z_j4b = tb13 * A_j0;
      Z_j4bd = tb13d * A_j0 + tb13 * A_j0d;
      A_j3b = -(tb13 * Z_j3);
      A_j3bd = -(tb13d * Z_j3 + tb13 * Z_j3d);
      Z_j3b = -(tb13 * A_j3);
      Z_j3bd = -(tb13d * A_j3 + tb13 * A_j3d);
      t5b = -(tb13 * s[i][1]);
      t5bd = -(tb13d * s[i][1] + tb13 * sd[i][1]);
      c2b = t5b * (1.0 / (2.0 * t5));
      c2bd = t5bd * (1.0 / (2.0 * t5)) - t5b * (1.0 / (2.0 * t5) * (2.0 * t5d) / (2.0 * t5));
      rollb += sb[i][0];
      rollbd += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      tb11 = rollb / c2;
      tb11d = (rollbd - tb11 * c2d) * (1.0 / c2);
      A_j0b += tb11 * Z_j3;
      A_j0bd += tb11d * Z_j3 + tb11 * Z_j3d;
      Z_j3b += tb11 * A_j0;
      Z_j3bd += tb11d * A_j0 + tb11 * A_j0d;
      A_j3b += tb11 * Z_j4;
      A_j3bd += tb11d * Z_j4 + tb11 * Z_j4d;
      Z_j4b += tb11 * A_j3;
      Z_j4bd += tb11d * A_j3 + tb11 * A_j3d;
      c2b -= tb11 * roll;
      c2bd -= tb11d * roll + tb11 * rolld;
      Zb[j][4] += Z_j4b;
      Zbd[j][4] += Z_j4bd;
      Zb[j][3] += Z_j3b;
      Zbd[j][3] += Z_j3bd;
      A_j0b += c2b * A_j0;
      /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
       * A_6 = -sin(pitch) */
      A_j0bd += c2bd * A_j0 + c2b * A_j0d;
      A_j0b += c2b * A_j0;
      A_j0bd += c2bd * A_j0 + c2b * A_j0d;
      A_j3b += c2b * A_j3;
      A_j3bd += c2bd * A_j3 + c2b * A_j3d;
      A_j3b += c2b * A_j3;
      A_j3bd += c2bd * A_j3 + c2b * A_j3d;
      Ab[j][3] += A_j3b;
      Abd[j][3] += A_j3bd;
      Ab[j][0] += A_j0b;
      Abd[j][0] += A_j0bd;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_VELOCITY) {
      Zb[j][5] += sb[i][2];
      Zbd[j][5] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Zb[j][4] += sb[i][1];
      Zbd[j][4] += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      Zb[j][3] += sb[i][0];
      Zbd[j][3] += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_ACCELERATION) {
      Zab[j][5] += sb[i][2];
      Zabd[j][5] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Zab[j][4] += sb[i][1];
      Zabd[j][4] += sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      Zab[j][3] += sb[i][0];
      Zabd[j][3] += sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
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
      ld = 1.0 / (2.0 * l) * t6d;
      n30 = e0 / l;
      n30d = (e0d - n30 * ld) * (1.0 / l);
      n31 = e1 / l;
      n31d = (e1d - n31 * ld) * (1.0 / l);
      n32 = e2_2 / l;
      n32d = (e2_2d - n32 * ld) * (1.0 / l);
      lv = n30 * ev0 + n31 * ev1 + n32 * ev2_2;
      lvd = n30d * ev0 + n30 * ev0d + (n31d * ev1 + n31 * ev1d) + (n32d * ev2_2 + n32 * ev2_2d);
      k2 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
      tb22 = sb[i][2];
      tb22d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      f0b = tb22;
      f0bd = tb22d;
      f1b = tb22;
      f1bd = tb22d;
      z1b = sb[i][1];
      z1bd = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      z0b = sb[i][0];
      z0bd = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      lvb = z1b;
      lvbd = z1bd;
      lb = z0b;
      lbd = z0bd;
      dampingb = 0.0;
      dampingbd = 0.0;
      if (t->springslopes[n2]) {
        dampingb += f1b;
        dampingbd += f1bd;
        f2b = f1b;
        f2bd = f1bd;
        f1b = 0.0;
        f1bd = 0.0;
        /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
        if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
          p_k24 = p[k2 + 4];
          p_k24d = pd[k2 + 4];
          pb[k2] += f2b * p_k24;
          pbd[k2] += f2bd * p_k24 + f2b * p_k24d;
          p_k24b = f2b * p[k2];
          p_k24bd = f2bd * p[k2] + f2b * pd[k2];
          pb[k2 + 1] += f2b * (lv - p_k24);
          pbd[k2 + 1] += f2bd * (lv - p_k24) + f2b * (lvd - p_k24d);
          tb20 = f2b * p[k2 + 1];
          tb20d = f2bd * p[k2 + 1] + f2b * pd[k2 + 1];
          lvb += tb20;
          lvbd += tb20d;
          p_k24b -= tb20;
          p_k24bd -= tb20d;
          f2b = 0.0;
          f2bd = 0.0;
          pb[k2 + 4] += p_k24b;
          pbd[k2 + 4] += p_k24bd;
        } else if (MAGGI_RE(lv) > 0.0) {
          pb[k2] += f2b * lv;
          pbd[k2] += f2bd * lv + f2b * lvd;
          lvb += f2b * p[k2];
          lvbd += f2bd * p[k2] + f2b * pd[k2];
          f2b = 0.0;
          f2bd = 0.0;
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
          pb[k2 + 2] += f2b * lv;
          pbd[k2 + 2] += f2bd * lv + f2b * lvd;
          lvb += f2b * p[k2 + 2];
          lvbd += f2bd * p[k2 + 2] + f2b * pd[k2 + 2];
          f2b = 0.0;
          f2bd = 0.0;
        } else {
          p_k25 = p[k2 + 5];
          p_k25d = pd[k2 + 5];
          pb[k2 + 2] += f2b * p_k25;
          pbd[k2 + 2] += f2bd * p_k25 + f2b * p_k25d;
          p_k25b = f2b * p[k2 + 2];
          p_k25bd = f2bd * p[k2 + 2] + f2b * pd[k2 + 2];
          pb[k2 + 3] += f2b * (lv - p_k25);
          pbd[k2 + 3] += f2bd * (lv - p_k25) + f2b * (lvd - p_k25d);
          tb21 = f2b * p[k2 + 3];
          tb21d = f2bd * p[k2 + 3] + f2b * pd[k2 + 3];
          lvb += tb21;
          lvbd += tb21d;
          p_k25b -= tb21;
          p_k25bd -= tb21d;
          f2b = 0.0;
          f2bd = 0.0;
          pb[k2 + 5] += p_k25b;
          pbd[k2 + 5] += p_k25bd;
        }
      } else {
        dampingb += f1b;
        dampingbd += f1bd;
        f1b = 0.0;
        f1bd = 0.0;
      }
      if (t->springpreload[n2]) {
        pb[t->springadr[n2]] += f0b * (l - spring0[n2]);
        pbd[t->springadr[n2]] += f0bd * (l - spring0[n2]) + f0b * (ld - spring0d[n2]);
        tb18 = f0b * p[t->springadr[n2]];
        tb18d = f0bd * p[t->springadr[n2]] + f0b * pd[t->springadr[n2]];
        lb += tb18;
        lbd += tb18d;
        spring0b[n2] -= tb18;
        spring0bd[n2] -= tb18d;
        pb[t->springadr[n2] + MAGGI_SPRING_L] += f0b;
        pbd[t->springadr[n2] + MAGGI_SPRING_L] += f0bd;
        f0b = 0.0;
        f0bd = 0.0;
      } else {
        pb[t->springadr[n2]] += f0b * (l - p[t->springadr[n2] + MAGGI_SPRING_L]);
        pbd[t->springadr[n2]] += f0bd * (l - p[t->springadr[n2] + MAGGI_SPRING_L]) + f0b * (ld -
            pd[t->springadr[n2] + MAGGI_SPRING_L]);
        tb19 = f0b * p[t->springadr[n2]];
        tb19d = f0bd * p[t->springadr[n2]] + f0b * pd[t->springadr[n2]];
        lb += tb19;
        lbd += tb19d;
        pb[t->springadr[n2] + MAGGI_SPRING_L] -= tb19;
        pbd[t->springadr[n2] + MAGGI_SPRING_L] -= tb19d;
        f0b = 0.0;
        f0bd = 0.0;
      }
      pb[t->springadr[n2] + MAGGI_SPRING_C] += dampingb * lv;
      pbd[t->springadr[n2] + MAGGI_SPRING_C] += dampingbd * lv + dampingb * lvd;
      lvb += dampingb * p[t->springadr[n2] + MAGGI_SPRING_C];
      lvbd += dampingbd * p[t->springadr[n2] + MAGGI_SPRING_C] + dampingb * pd[t->springadr[n2] +
          MAGGI_SPRING_C];
      n30b = lvb * ev0;
      n30bd = lvbd * ev0 + lvb * ev0d;
      ev0b = lvb * n30;
      ev0bd = lvbd * n30 + lvb * n30d;
      n31b = lvb * ev1;
      n31bd = lvbd * ev1 + lvb * ev1d;
      ev1b = lvb * n31;
      ev1bd = lvbd * n31 + lvb * n31d;
      n32b = lvb * ev2_2;
      n32bd = lvbd * ev2_2 + lvb * ev2_2d;
      ev2_2b = lvb * n32;
      ev2_2bd = lvbd * n32 + lvb * n32d;
      tb17 = n32b / l;
      tb17d = (n32bd - tb17 * ld) * (1.0 / l);
      e2_2b = tb17;
      e2_2bd = tb17d;
      lb -= tb17 * n32;
      lbd -= tb17d * n32 + tb17 * n32d;
      tb16 = n31b / l;
      tb16d = (n31bd - tb16 * ld) * (1.0 / l);
      e1b = tb16;
      e1bd = tb16d;
      lb -= tb16 * n31;
      lbd -= tb16d * n31 + tb16 * n31d;
      tb15 = n30b / l;
      tb15d = (n30bd - tb15 * ld) * (1.0 / l);
      e0b = tb15;
      e0bd = tb15d;
      lb -= tb15 * n30;
      lbd -= tb15d * n30 + tb15 * n30d;
      t6b = lb * (1.0 / (2.0 * l));
      t6bd = lbd * (1.0 / (2.0 * l)) - lb * (1.0 / (2.0 * l) * (2.0 * ld) / (2.0 * l));
      e0b += t6b * e0;
      e0bd += t6bd * e0 + t6b * e0d;
      e0b += t6b * e0;
      e0bd += t6bd * e0 + t6b * e0d;
      e1b += t6b * e1;
      e1bd += t6bd * e1 + t6b * e1d;
      e1b += t6b * e1;
      e1bd += t6bd * e1 + t6b * e1d;
      e2_2b += t6b * e2_2;
      e2_2bd += t6bd * e2_2 + t6b * e2_2d;
      e2_2b += t6b * e2_2;
      e2_2bd += t6bd * e2_2 + t6b * e2_2d;
      rvb[a][2] += ev2_2b;
      rvbd[a][2] += ev2_2bd;
      rvb[b][2] -= ev2_2b;
      rvbd[b][2] -= ev2_2bd;
      rb[a][2] += e2_2b;
      rbd[a][2] += e2_2bd;
      rb[b][2] -= e2_2b;
      rbd[b][2] -= e2_2bd;
      rvb[a][1] += ev1b;
      rvbd[a][1] += ev1bd;
      rvb[b][1] -= ev1b;
      rvbd[b][1] -= ev1bd;
      rb[a][1] += e1b;
      rbd[a][1] += e1bd;
      rb[b][1] -= e1b;
      rbd[b][1] -= e1bd;
      rvb[a][0] += ev0b;
      rvbd[a][0] += ev0bd;
      rvb[b][0] -= ev0b;
      rvbd[b][0] -= ev0bd;
      rb[a][0] += e0b;
      rbd[a][0] += e0bd;
      rb[b][0] -= e0b;
      rbd[b][0] -= e0bd;
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
      torque0b = sb[i][2];
      torque0bd = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      z1_2b = sb[i][1];
      z1_2bd = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      z0_2b = sb[i][0];
      z0_2bd = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      xvb = z1_2b;
      xvbd = z1_2bd;
      x2b = z0_2b;
      x2bd = z0_2bd;
      pb[t->jspringadr[n2]] -= torque0b * (x2 - p[t->jspringadr[n2] + MAGGI_JSPRING_REST]);
      pbd[t->jspringadr[n2]] -= torque0bd * (x2 - p[t->jspringadr[n2] + MAGGI_JSPRING_REST]) +
          torque0b * (x2d - pd[t->jspringadr[n2] + MAGGI_JSPRING_REST]);
      tb23 = torque0b * p[t->jspringadr[n2]];
      tb23d = torque0bd * p[t->jspringadr[n2]] + torque0b * pd[t->jspringadr[n2]];
      x2b -= tb23;
      x2bd -= tb23d;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_REST] += tb23;
      pbd[t->jspringadr[n2] + MAGGI_JSPRING_REST] += tb23d;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_C] -= torque0b * xv;
      pbd[t->jspringadr[n2] + MAGGI_JSPRING_C] -= torque0bd * xv + torque0b * xvd;
      xvb -= torque0b * p[t->jspringadr[n2] + MAGGI_JSPRING_C];
      xvbd -= torque0bd * p[t->jspringadr[n2] + MAGGI_JSPRING_C] + torque0b * pd[t->jspringadr[n2] +
          MAGGI_JSPRING_C];
      pb[t->jspringadr[n2] + MAGGI_JSPRING_PRELOAD] -= torque0b;
      pbd[t->jspringadr[n2] + MAGGI_JSPRING_PRELOAD] -= torque0bd;
      if (t->jspringq2[n2] >= 0) {
        vb[t->jspringq[n2]] += xvb;
        vbd[t->jspringq[n2]] += xvbd;
        vb[t->jspringq2[n2]] -= xvb;
        vbd[t->jspringq2[n2]] -= xvbd;
        xvb = 0.0;
        xvbd = 0.0;
        qb[t->jspringq[n2]] += x2b;
        qbd[t->jspringq[n2]] += x2bd;
        qb[t->jspringq2[n2]] -= x2b;
        qbd[t->jspringq2[n2]] -= x2bd;
        x2b = 0.0;
        x2bd = 0.0;
      } else {
        vb[t->jspringq[n2]] += xvb;
        vbd[t->jspringq[n2]] += xvbd;
        xvb = 0.0;
        xvbd = 0.0;
        qb[t->jspringq[n2]] += x2b;
        qbd[t->jspringq[n2]] += x2bd;
        x2b = 0.0;
        x2bd = 0.0;
      }
    } else {
      a2 = t->primpa[n2];
      b2 = t->primpb[n2];
      e20 = r[a2][0] - r[b2][0];
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
      l2d = 1.0 / (2.0 * l2) * t7d;
      z1_3 = s[i][1];
      z1_3d = sd[i][1];
      lambdab[t->primrow[n2]] += sb[i][2];
      lambdabd[t->primrow[n2]] += sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      z1_3b = sb[i][1];
      z1_3bd = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      z0_3b = sb[i][0];
      z0_3bd = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      tb24 = z1_3b / l2;
      tb24d = (z1_3bd - tb24 * l2d) * (1.0 / l2);
      e20b = tb24 * ev20;
      e20bd = tb24d * ev20 + tb24 * ev20d;
      ev20b = tb24 * e20;
      ev20bd = tb24d * e20 + tb24 * e20d;
      e21b = tb24 * ev21;
      e21bd = tb24d * ev21 + tb24 * ev21d;
      ev21b = tb24 * e21;
      ev21bd = tb24d * e21 + tb24 * e21d;
      e22b = tb24 * ev22;
      e22bd = tb24d * ev22 + tb24 * ev22d;
      ev22b = tb24 * e22;
      ev22bd = tb24d * e22 + tb24 * e22d;
      l2b = -(tb24 * z1_3);
      l2bd = -(tb24d * z1_3 + tb24 * z1_3d);
      l2b += z0_3b;
      l2bd += z0_3bd;
      t7b = l2b * (1.0 / (2.0 * l2));
      t7bd = l2bd * (1.0 / (2.0 * l2)) - l2b * (1.0 / (2.0 * l2) * (2.0 * l2d) / (2.0 * l2));
      e20b += t7b * e20;
      e20bd += t7bd * e20 + t7b * e20d;
      e20b += t7b * e20;
      e20bd += t7bd * e20 + t7b * e20d;
      e21b += t7b * e21;
      e21bd += t7bd * e21 + t7b * e21d;
      e21b += t7b * e21;
      e21bd += t7bd * e21 + t7b * e21d;
      e22b += t7b * e22;
      e22bd += t7bd * e22 + t7b * e22d;
      e22b += t7b * e22;
      e22bd += t7bd * e22 + t7b * e22d;
      rvb[a2][2] += ev22b;
      rvbd[a2][2] += ev22bd;
      rvb[b2][2] -= ev22b;
      rvbd[b2][2] -= ev22bd;
      rb[a2][2] += e22b;
      rbd[a2][2] += e22bd;
      rb[b2][2] -= e22b;
      rbd[b2][2] -= e22bd;
      rvb[a2][1] += ev21b;
      rvbd[a2][1] += ev21bd;
      rvb[b2][1] -= ev21b;
      rvbd[b2][1] -= ev21bd;
      rb[a2][1] += e21b;
      rbd[a2][1] += e21bd;
      rb[b2][1] -= e21b;
      rbd[b2][1] -= e21bd;
      rvb[a2][0] += ev20b;
      rvbd[a2][0] += ev20bd;
      rvb[b2][0] -= ev20b;
      rvbd[b2][0] -= ev20bd;
      rb[a2][0] += e20b;
      /* distance of two points and its rate */
      rbd[a2][0] += e20bd;
      rb[b2][0] -= e20b;
      rbd[b2][0] -= e20bd;
    }
  }
}
