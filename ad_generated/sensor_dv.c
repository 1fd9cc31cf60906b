/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra carries minus gravity; p begins with gravity */
void maggi_sensors_dv(const maggi_topo *t, const double p[restrict t->np],
                      const double pd[restrict t->np][MAGGI_NDIR], const double origin[restrict 3],
                      const double A[restrict t->nbody + 1][9],
                      const double Ad[restrict t->nbody + 1][9][MAGGI_NDIR],
                      const double x[restrict t->nbody + 1][3],
                      const double xd[restrict t->nbody + 1][3][MAGGI_NDIR],
                      const double r[restrict t->npoint][3],
                      const double rd[restrict t->npoint][3][MAGGI_NDIR],
                      const double rv[restrict t->npoint][3],
                      const double rvd[restrict t->npoint][3][MAGGI_NDIR],
                      const double ra[restrict t->npoint][3],
                      const double rad[restrict t->npoint][3][MAGGI_NDIR],
                      double s[restrict t->nsensor][3],
                      double sd[restrict t->nsensor][3][MAGGI_NDIR], int nbdirs)
{
  int i, j, nd;
  double A_i7, A_i8, c, c2, c3, c4, c5, c6, c7, t2, t3, t4;

  (void)p;
  (void)origin;
  (void)x;
  (void)r;
  (void)rv;
  (void)ra;
  (void)s;
  (void)nbdirs;
  for (i = 0; i < t->nsensor; ++i) {
    j = t->sensorpoint[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_i7 = A[t->sensorbody[i]][7];
      A_i8 = A[t->sensorbody[i]][8];
      c = A_i8 / (A_i8 * A_i8 + A_i7 * A_i7);
      c2 = -(A_i7 / (A_i8 * A_i8 + A_i7 * A_i7));
      t2 = -A[t->sensorbody[i]][6];
      t3 = A_i7 * A_i7 + A_i8 * A_i8;
      t4 = sqrt(t3);
      c3 = 1.0 / (2.0 * t4);
      c4 = t4 / (t4 * t4 + t2 * t2);
      c5 = -(t2 / (t4 * t4 + t2 * t2));
      c6 = A[t->sensorbody[i]][0] / (A[t->sensorbody[i]][0] * A[t->sensorbody[i]][0] +
          A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]);
      c7 = -(A[t->sensorbody[i]][3] / (A[t->sensorbody[i]][0] * A[t->sensorbody[i]][0] +
          A[t->sensorbody[i]][3] * A[t->sensorbody[i]][3]));
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_i7d, A_i8d, t2d, t3d, t4d;

        A_i7d = Ad[t->sensorbody[i]][7][nd];
        A_i8d = Ad[t->sensorbody[i]][8][nd];
        /* R = Rz(yaw) Ry(pitch) Rx(roll) */
        sd[i][0][nd] = c * A_i7d + c2 * A_i8d;
        t2d = -Ad[t->sensorbody[i]][6][nd];
        t3d = A_i7d * A_i7 + A_i7 * A_i7d + (A_i8d * A_i8 + A_i8 * A_i8d);
        t4d = c3 * t3d;
        sd[i][1][nd] = c4 * t2d + c5 * t4d;
        sd[i][2][nd] = c6 * Ad[t->sensorbody[i]][3][nd] + c7 * Ad[t->sensorbody[i]][0][nd];
      }
    } else {
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][0][nd] = rd[j][0][nd] - xd[t->nbody][0][nd];
        }
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][0][nd] = rvd[j][0][nd];
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][0][nd] = rad[j][0][nd] + pd[0][nd];
        }
      }
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][1][nd] = rd[j][1][nd] - xd[t->nbody][1][nd];
        }
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][1][nd] = rvd[j][1][nd];
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][1][nd] = rad[j][1][nd] + pd[1][nd];
        }
      }
      if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][2][nd] = rd[j][2][nd] - xd[t->nbody][2][nd];
        }
      } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][2][nd] = rvd[j][2][nd];
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          sd[i][2][nd] = rad[j][2][nd] + pd[2][nd];
        }
      }
    }
  }
}
