/* Tangent of the adjoint of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra carries minus gravity; p begins with gravity */
void maggi_sensors_b_d(const maggi_topo *t, const double p[restrict t->np],
                       const double pd[restrict t->np], double pb[restrict t->np],
                       double pbd[restrict t->np], const double origin[restrict 3],
                       const double A[restrict t->nbody + 1][9],
                       const double Ad[restrict t->nbody + 1][9],
                       double Ab[restrict t->nbody + 1][9], double Abd[restrict t->nbody + 1][9],
                       const double x[restrict t->nbody + 1][3],
                       const double xd[restrict t->nbody + 1][3],
                       double xb[restrict t->nbody + 1][3], double xbd[restrict t->nbody + 1][3],
                       const double r[restrict t->npoint][3],
                       const double rd[restrict t->npoint][3], double rb[restrict t->npoint][3],
                       double rbd[restrict t->npoint][3], const double rv[restrict t->npoint][3],
                       const double rvd[restrict t->npoint][3], double rvb[restrict t->npoint][3],
                       double rvbd[restrict t->npoint][3], const double ra[restrict t->npoint][3],
                       const double rad[restrict t->npoint][3], double rab[restrict t->npoint][3],
                       double rabd[restrict t->npoint][3], double s[restrict t->nsensor][3],
                       double sd[restrict t->nsensor][3], double sb[restrict t->nsensor][3],
                       double sbd[restrict t->nsensor][3])
{
  int i, j;
  double A_i7, A_i7b, A_i7bd, A_i7d, A_i8, A_i8b, A_i8bd, A_i8d, t2, t2b, t2bd, t2d, t3, t3b, t3bd,
      t3d, t4, t4b, t4bd, t4d, tb10, tb10d, tb2, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d,
      tb7, tb7d, tb8, tb8d, tb9, tb9d;

  (void)p;
  (void)pd;
  (void)origin;
  (void)x;
  (void)xd;
  (void)r;
  (void)rd;
  (void)rv;
  (void)rvd;
  (void)ra;
  (void)rad;
  (void)s;
  (void)sd;
  for (i = t->nsensor - 1; i >= 0; --i) {
    j = t->sensorpoint[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_i7 = A[t->sensorbody[i]][7];
      A_i7d = Ad[t->sensorbody[i]][7];
      A_i8 = A[t->sensorbody[i]][8];
      A_i8d = Ad[t->sensorbody[i]][8];
      t2 = -A[t->sensorbody[i]][6];
      t2d = -Ad[t->sensorbody[i]][6];
      t3 = A_i7 * A_i7 + A_i8 * A_i8;
      t3d = A_i7d * A_i7 + A_i7 * A_i7d + (A_i8d * A_i8 + A_i8 * A_i8d);
      t4 = sqrt(t3);
      t4d = 1.0 / (2.0 * t4) * t3d;
      tb4 = sb[i][2];
      tb4d = sbd[i][2];
      sb[i][2] = 0.0;
      sbd[i][2] = 0.0;
      Ab[t->sensorbody[i]][3] += tb4 * (A[t->sensorbody[i]][0] / (A[t->sensorbody[i]][0] *
          A[t->sensorbody[i]][0] + A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]));
      Abd[t->sensorbody[i]][3] += tb4d * (A[t->sensorbody[i]][0] / (A[t->sensorbody[i]][0] *
          A[t->sensorbody[i]][0] + A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3])) + tb4 *
          ((Ad[t->sensorbody[i]][0] - A[t->sensorbody[i]][0] / (A[t->sensorbody[i]][0] *
          A[t->sensorbody[i]][0] + A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]) *
          (Ad[t->sensorbody[i]][0] * A[t->sensorbody[i]][0] + A[t->sensorbody[i]][0] *
          Ad[t->sensorbody[i]][0] + (Ad[t->sensorbody[i]][3] * A[t->sensorbody[i]][3] +
          A[t->sensorbody[i]][3] * Ad[t->sensorbody[i]][3]))) / (A[t->sensorbody[i]][0] *
          A[t->sensorbody[i]][0] + A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]));
      Ab[t->sensorbody[i]][0] -= tb4 * (A[t->sensorbody[i]][3] / (A[t->sensorbody[i]][0] *
          A[t->sensorbody[i]][0] + A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]));
      Abd[t->sensorbody[i]][0] -= tb4d * (A[t->sensorbody[i]][3] / (A[t->sensorbody[i]][0] *
          A[t->sensorbody[i]][0] + A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3])) + tb4 *
          ((Ad[t->sensorbody[i]][3] - A[t->sensorbody[i]][3] / (A[t->sensorbody[i]][0] *
          A[t->sensorbody[i]][0] + A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]) *
          (Ad[t->sensorbody[i]][0] * A[t->sensorbody[i]][0] + A[t->sensorbody[i]][0] *
          Ad[t->sensorbody[i]][0] + (Ad[t->sensorbody[i]][3] * A[t->sensorbody[i]][3] +
          A[t->sensorbody[i]][3] * Ad[t->sensorbody[i]][3]))) / (A[t->sensorbody[i]][0] *
          A[t->sensorbody[i]][0] + A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]));
      tb3 = sb[i][1];
      tb3d = sbd[i][1];
      sb[i][1] = 0.0;
      sbd[i][1] = 0.0;
      t2b = tb3 * (t4 / (t4 * t4 + t2 * t2));
      t2bd = tb3d * (t4 / (t4 * t4 + t2 * t2)) + tb3 * ((t4d - t4 / (t4 * t4 + t2 * t2) * (t4d * t4
          + t4 * t4d + (t2d * t2 + t2 * t2d))) / (t4 * t4 + t2 * t2));
      t4b = -(tb3 * (t2 / (t4 * t4 + t2 * t2)));
      t4bd = -(tb3d * (t2 / (t4 * t4 + t2 * t2)) + tb3 * ((t2d - t2 / (t4 * t4 + t2 * t2) * (t4d *
          t4 + t4 * t4d + (t2d * t2 + t2 * t2d))) / (t4 * t4 + t2 * t2)));
      t3b = t4b * (1.0 / (2.0 * t4));
      t3bd = t4bd * (1.0 / (2.0 * t4)) - t4b * (1.0 / (2.0 * t4) * (2.0 * t4d) / (2.0 * t4));
      A_i7b = t3b * A_i7;
      A_i7bd = t3bd * A_i7 + t3b * A_i7d;
      A_i7b += t3b * A_i7;
      A_i7bd += t3bd * A_i7 + t3b * A_i7d;
      A_i8b = t3b * A_i8;
      A_i8bd = t3bd * A_i8 + t3b * A_i8d;
      A_i8b += t3b * A_i8;
      A_i8bd += t3bd * A_i8 + t3b * A_i8d;
      Ab[t->sensorbody[i]][6] -= t2b;
      Abd[t->sensorbody[i]][6] -= t2bd;
      tb2 = sb[i][0];
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      tb2d = sbd[i][0];
      sb[i][0] = 0.0;
      sbd[i][0] = 0.0;
      A_i7b += tb2 * (A_i8 / (A_i8 * A_i8 + A_i7 * A_i7));
      A_i7bd += tb2d * (A_i8 / (A_i8 * A_i8 + A_i7 * A_i7)) + tb2 * ((A_i8d - A_i8 / (A_i8 * A_i8 +
          A_i7 * A_i7) * (A_i8d * A_i8 + A_i8 * A_i8d + (A_i7d * A_i7 + A_i7 * A_i7d))) / (A_i8 *
          A_i8 + A_i7 * A_i7));
      A_i8b -= tb2 * (A_i7 / (A_i8 * A_i8 + A_i7 * A_i7));
      A_i8bd -= tb2d * (A_i7 / (A_i8 * A_i8 + A_i7 * A_i7)) + tb2 * ((A_i7d - A_i7 / (A_i8 * A_i8 +
          A_i7 * A_i7) * (A_i8d * A_i8 + A_i8 * A_i8d + (A_i7d * A_i7 + A_i7 * A_i7d))) / (A_i8 *
          A_i8 + A_i7 * A_i7));
      Ab[t->sensorbody[i]][8] += A_i8b;
      Abd[t->sensorbody[i]][8] += A_i8bd;
      Ab[t->sensorbody[i]][7] += A_i7b;
      Abd[t->sensorbody[i]][7] += A_i7bd;
    } else {
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
        tb9 = sb[i][2];
        tb9d = sbd[i][2];
        sb[i][2] = 0.0;
        sbd[i][2] = 0.0;
        rb[j][2] += tb9;
        rbd[j][2] += tb9d;
        xb[t->nbody][2] -= tb9;
        xbd[t->nbody][2] -= tb9d;
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
        rvb[j][2] += sb[i][2];
        rvbd[j][2] += sbd[i][2];
        sb[i][2] = 0.0;
        sbd[i][2] = 0.0;
      } else {
        tb10 = sb[i][2];
        tb10d = sbd[i][2];
        sb[i][2] = 0.0;
        sbd[i][2] = 0.0;
        rab[j][2] += tb10;
        rabd[j][2] += tb10d;
        pb[2] += tb10;
        pbd[2] += tb10d;
      }
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
        tb7 = sb[i][1];
        tb7d = sbd[i][1];
        sb[i][1] = 0.0;
        sbd[i][1] = 0.0;
        rb[j][1] += tb7;
        rbd[j][1] += tb7d;
        xb[t->nbody][1] -= tb7;
        xbd[t->nbody][1] -= tb7d;
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
        rvb[j][1] += sb[i][1];
        rvbd[j][1] += sbd[i][1];
        sb[i][1] = 0.0;
        sbd[i][1] = 0.0;
      } else {
        tb8 = sb[i][1];
        tb8d = sbd[i][1];
        sb[i][1] = 0.0;
        sbd[i][1] = 0.0;
        rab[j][1] += tb8;
        rabd[j][1] += tb8d;
        pb[1] += tb8;
        pbd[1] += tb8d;
      }
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
        tb5 = sb[i][0];
        tb5d = sbd[i][0];
        sb[i][0] = 0.0;
        sbd[i][0] = 0.0;
        rb[j][0] += tb5;
        rbd[j][0] += tb5d;
        xb[t->nbody][0] -= tb5;
        xbd[t->nbody][0] -= tb5d;
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
        rvb[j][0] += sb[i][0];
        rvbd[j][0] += sbd[i][0];
        sb[i][0] = 0.0;
        sbd[i][0] = 0.0;
      } else {
        tb6 = sb[i][0];
        tb6d = sbd[i][0];
        sb[i][0] = 0.0;
        sbd[i][0] = 0.0;
        rab[j][0] += tb6;
        rabd[j][0] += tb6d;
        pb[0] += tb6;
        pbd[0] += tb6d;
      }
    }
  }
}
