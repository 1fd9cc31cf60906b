/* Drivers and controllers of speed: torques of drivers on what steers, and torques on coordinates that
 * keep a point at a speed.  [1] 3.10.
 *
 *   T = gain torque e |e|   or   gain torque e,   e = target - |v|,   |v| = sqrt(v.v + low^2)
 */
#include "kernel.h"

/* error, torque on each coordinate, speed */
static void speed_law(int linear, int np, const double p[np], int adr, double target,
                      const double v[3], double s[3])
{
  double e, speed, gain;

  speed = sqrt(maggi_dot(v, v) + p[adr + MAGGI_SPEED_LOW] * p[adr + MAGGI_SPEED_LOW]);
  e = target - speed;
  gain = p[adr + MAGGI_SPEED_GAIN] * p[adr + MAGGI_SPEED_TORQUE];
  s[0] = e;
  if (linear)
    s[1] = gain * e;
  else
    s[1] = gain * e * fabs(e);
  s[2] = speed;
}

/* adds to what elements exert on coordinates */
void maggi_control_forces(const maggi_topo *t, const double p[t->np], const double fun[t->nfun][3],
                          const double path0[t->npath0][8], const double q[t->nq],
                          const double v[t->nq], const double r[t->npoint][3],
                          const double rv[t->npoint][3], double driver[t->ndriver][4],
                          double speed[t->nspeed][3], double tau[t->nq], double power[1])
{
  int i, k, a, b;
  double factor, target, torque;
  double x[3], steer[1];

  for (i = 0; i < t->ndriver; ++i) {
    a = t->driverpoint[i];
    b = t->driverorigin[i];
    for (k = 0; k < 3; ++k) x[k] = r[a][k] - r[b][k];
    k = t->driverq[i];
    maggi_driver(t->driveradr[i], t->driverpath[i], t->driverspeeds[i], t->drivern[i],
                 t->driverrow[i], t->np, p, t->npath0, path0, x, rv[a], q[k], v[k], driver[i],
                 steer);
    if (t->driverheld[i] == 0) {
      tau[k] += steer[0];
      power[0] += steer[0] * v[k];
    }
  }

  for (i = 0; i < t->nspeed; ++i) {
    if (t->speedfun[i] >= 0)
      factor = fun[t->speedfun[i]][0];
    else
      factor = 1.0;
    if (t->speeddriver[i] >= 0)
      target = driver[t->speeddriver[i]][3] * factor;
    else
      target = p[t->speedadr[i] + MAGGI_SPEED_TARGET] * factor;
    speed_law(t->speedlinear[i], t->np, p, t->speedadr[i], target, rv[t->speedpoint[i]], speed[i]);
    if (t->speedheld[i])
      torque = 0.0;
    else
      torque = speed[i][1];
    for (k = t->speedqadr[i]; k < t->speedqadr[i] + t->speedqnum[i]; ++k) {
      tau[t->speedq[k]] += torque;
      power[0] += torque * v[t->speedq[k]];
    }
  }
}
