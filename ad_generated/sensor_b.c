/* Adjoint of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra carries minus gravity; p begins with gravity */
void maggi_sensors_b(const maggi_topo *t, const double p[restrict t->np], double pb[restrict t->np],
                     const double origin[restrict 3], const double A[restrict t->nbody + 1][9],
                     double Ab[restrict t->nbody + 1][9], const double x[restrict t->nbody + 1][3],
                     double xb[restrict t->nbody + 1][3], const double r[restrict t->npoint][3],
                     double rb[restrict t->npoint][3], const double rv[restrict t->npoint][3],
                     double rvb[restrict t->npoint][3], const double ra[restrict t->npoint][3],
                     double rab[restrict t->npoint][3], double s[restrict t->nsensor][3],
                     double sb[restrict t->nsensor][3])
{
  int i, j;
  double A_i7, A_i7b, A_i8, A_i8b, t2, t2b, t3, t3b, t4, t4b, tb10, tb2, tb3, tb4, tb5, tb6, tb7,
      tb8, tb9;

  (void)p;
  (void)origin;
  (void)x;
  (void)r;
  (void)rv;
  (void)ra;
  (void)s;
  for (i = t->nsensor - 1; i >= 0; --i) {
    j = t->sensorpoint[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_i7 = A[t->sensorbody[i]][7];
      A_i8 = A[t->sensorbody[i]][8];
      t2 = -A[t->sensorbody[i]][6];
      t3 = A_i7 * A_i7 + A_i8 * A_i8;
      t4 = sqrt(t3);
      tb4 = sb[i][2];
      sb[i][2] = 0.0;
      Ab[t->sensorbody[i]][3] += tb4 * (A[t->sensorbody[i]][0] / (A[t->sensorbody[i]][0] *
          A[t->sensorbody[i]][0] + A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]));
      Ab[t->sensorbody[i]][0] -= tb4 * (A[t->sensorbody[i]][3] / (A[t->sensorbody[i]][0] *
          A[t->sensorbody[i]][0] + A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]));
      tb3 = sb[i][1];
      sb[i][1] = 0.0;
      t2b = tb3 * (t4 / (t4 * t4 + t2 * t2));
      t4b = -(tb3 * (t2 / (t4 * t4 + t2 * t2)));
      t3b = t4b * (1.0 / (2.0 * t4));
      A_i7b = t3b * A_i7;
      A_i7b += t3b * A_i7;
      A_i8b = t3b * A_i8;
      A_i8b += t3b * A_i8;
      Ab[t->sensorbody[i]][6] -= t2b;
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      tb2 = sb[i][0];
      sb[i][0] = 0.0;
      A_i7b += tb2 * (A_i8 / (A_i8 * A_i8 + A_i7 * A_i7));
      A_i8b -= tb2 * (A_i7 / (A_i8 * A_i8 + A_i7 * A_i7));
      Ab[t->sensorbody[i]][8] += A_i8b;
      Ab[t->sensorbody[i]][7] += A_i7b;
    } else {
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
        tb9 = sb[i][2];
        sb[i][2] = 0.0;
        rb[j][2] += tb9;
        xb[t->nbody][2] -= tb9;
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
        rvb[j][2] += sb[i][2];
        sb[i][2] = 0.0;
      } else {
        tb10 = sb[i][2];
        sb[i][2] = 0.0;
        rab[j][2] += tb10;
        pb[2] += tb10;
      }
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
        tb7 = sb[i][1];
        sb[i][1] = 0.0;
        rb[j][1] += tb7;
        xb[t->nbody][1] -= tb7;
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
        rvb[j][1] += sb[i][1];
        sb[i][1] = 0.0;
      } else {
        tb8 = sb[i][1];
        sb[i][1] = 0.0;
        rab[j][1] += tb8;
        pb[1] += tb8;
      }
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
        tb5 = sb[i][0];
        sb[i][0] = 0.0;
        rb[j][0] += tb5;
        xb[t->nbody][0] -= tb5;
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
        rvb[j][0] += sb[i][0];
        sb[i][0] = 0.0;
      } else {
        tb6 = sb[i][0];
        sb[i][0] = 0.0;
        rab[j][0] += tb6;
        pb[0] += tb6;
      }
    }
  }
}
