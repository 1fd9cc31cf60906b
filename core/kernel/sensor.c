/* Sensors: position, velocity and acceleration of body points in global axes, angles of bodies. */
#include "kernel.h"
#include "maggi/maggi.h"

/* R = Rz(yaw) Ry(pitch) Rx(roll) */
static void angles(const double A[9], double s[3])
{
  s[0] = atan2(A[7], A[8]);
  s[1] = atan2(-A[6], sqrt(A[7] * A[7] + A[8] * A[8]));
  s[2] = atan2(A[3], A[0]);
}

/* ra carries minus gravity; p begins with gravity */
void maggi_sensors(const maggi_topo *t, const double p[t->np], const double origin[3],
                   const double A[t->nbody + 1][9], const double x[t->nbody + 1][3],
                   const double r[t->npoint][3], const double rv[t->npoint][3],
                   const double ra[t->npoint][3], double s[t->nsensor][3])
{
  int i, j, k;

  for (i = 0; i < t->nsensor; ++i) {
    j = t->sensorpoint[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      angles(A[t->sensorbody[i]], s[i]);
    } else {
      for (k = 0; k < 3; ++k) {
        if (t->sensorkind[i] == MAGGI_SENSOR_POSITION)
          s[i][k] = r[j][k] - x[t->nbody][k] + origin[k];
        else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY)
          s[i][k] = rv[j][k];
        else
          s[i][k] = ra[j][k] + p[k];
      }
    }
  }
}
