/* Controllers of speed: torques on coordinates that keep a point at a speed.  Thesis [1] 3.10.
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
                          const double v[t->nq], const double rv[t->npoint][3],
                          double speed[t->nspeed][3], double tau[t->nq], double power[1])
{
  int i, k;
  double factor, target, torque;

  for (i = 0; i < t->nspeed; ++i) {
    if (t->speedfun[i] >= 0)
      factor = fun[t->speedfun[i]][0];
    else
      factor = 1.0;
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
