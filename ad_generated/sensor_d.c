/* Tangent of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra carries minus gravity; p begins with gravity */
void maggi_sensors_d(const maggi_topo *t, const double p[restrict t->np],
                     const double pd[restrict t->np], const double origin[restrict 3],
                     const double A[restrict t->nbody + 1][9],
                     const double Ad[restrict t->nbody + 1][9],
                     const double x[restrict t->nbody + 1][3],
                     const double xd[restrict t->nbody + 1][3],
                     const double r[restrict t->npoint][3], const double rd[restrict t->npoint][3],
                     const double rv[restrict t->npoint][3],
                     const double rvd[restrict t->npoint][3],
                     const double ra[restrict t->npoint][3],
                     const double rad[restrict t->npoint][3], double s[restrict t->nsensor][3],
                     double sd[restrict t->nsensor][3])
{
  int i, j;
  double A_i7, A_i7d, A_i8, A_i8d, c, c2, c3, c4, c5, c6, c7, t2, t2d, t3, t3d, t4, t4d;

  (void)p;
  (void)origin;
  (void)x;
  (void)r;
  (void)rv;
  (void)ra;
  (void)s;
  for (i = 0; i < t->nsensor; ++i) {
    j = t->sensorpoint[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_i7 = A[t->sensorbody[i]][7];
      A_i7d = Ad[t->sensorbody[i]][7];
      A_i8 = A[t->sensorbody[i]][8];
      A_i8d = Ad[t->sensorbody[i]][8];
      c = A_i8 / (A_i8 * A_i8 + A_i7 * A_i7);
      c2 = -(A_i7 / (A_i8 * A_i8 + A_i7 * A_i7));
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      sd[i][0] = c * A_i7d + c2 * A_i8d;
      t2 = -A[t->sensorbody[i]][6];
      t2d = -Ad[t->sensorbody[i]][6];
      t3 = A_i7 * A_i7 + A_i8 * A_i8;
      t3d = A_i7d * A_i7 + A_i7 * A_i7d + (A_i8d * A_i8 + A_i8 * A_i8d);
      t4 = sqrt(t3);
      c3 = 1.0 / (2.0 * t4);
      t4d = c3 * t3d;
      c4 = t4 / (t4 * t4 + t2 * t2);
      c5 = -(t2 / (t4 * t4 + t2 * t2));
      sd[i][1] = c4 * t2d + c5 * t4d;
      c6 = A[t->sensorbody[i]][0] / (A[t->sensorbody[i]][0] * A[t->sensorbody[i]][0] +
          A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]);
      c7 = -(A[t->sensorbody[i]][3] / (A[t->sensorbody[i]][0] * A[t->sensorbody[i]][0] +
          A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]));
      sd[i][2] = c6 * Ad[t->sensorbody[i]][3] + c7 * Ad[t->sensorbody[i]][0];
    } else {
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
        sd[i][0] = rd[j][0] - xd[t->nbody][0];
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
        sd[i][0] = rvd[j][0];
      } else {
        sd[i][0] = rad[j][0] + pd[0];
      }
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
        sd[i][1] = rd[j][1] - xd[t->nbody][1];
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
        sd[i][1] = rvd[j][1];
      } else {
        sd[i][1] = rad[j][1] + pd[1];
      }
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
        sd[i][2] = rd[j][2] - xd[t->nbody][2];
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
        sd[i][2] = rvd[j][2];
      } else {
        sd[i][2] = rad[j][2] + pd[2];
      }
    }
  }
}
