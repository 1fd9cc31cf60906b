/* Tangent of core/kernel/control.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* adds to what elements exert on coordinates */
void maggi_control_forces_d(const maggi_topo *t, const double p[restrict t->np],
                            const double pd[restrict t->np], const double fun[restrict t->nfun][3],
                            const double fund[restrict t->nfun][3], const double v[restrict t->nq],
                            const double rv[restrict t->npoint][3],
                            const double rvd[restrict t->npoint][3],
                            double speed[restrict t->nspeed][3],
                            double speedd[restrict t->nspeed][3], double tau[restrict t->nq],
                            double taud[restrict t->nq], double power[restrict 1])
{
  int i, k;
  double c, c2, e, ed, factor, factord, gain, gaind, p2, p2d, rv_i0, rv_i0d, rv_i1, rv_i1d, rv_i2,
      rv_i2d, speed2, speed2d, t2d, t3, t3d, targetd, torqued;

  (void)v;
  (void)tau;
  (void)power;
  for (i = 0; i < t->nspeed; ++i) {
    if (t->speedfun[i] >= 0) {
      factor = fun[t->speedfun[i]][0];
      factord = fund[t->speedfun[i]][0];
    } else {
      factor = 1.0;
      factord = 0.0;
    }
    targetd = pd[t->speedadr[i]] * factor + p[t->speedadr[i]] * factord;
    rv_i0 = rv[t->speedpoint[i]][0];
    rv_i0d = rvd[t->speedpoint[i]][0];
    rv_i1 = rv[t->speedpoint[i]][1];
    rv_i1d = rvd[t->speedpoint[i]][1];
    rv_i2 = rv[t->speedpoint[i]][2];
    rv_i2d = rvd[t->speedpoint[i]][2];
    p2 = p[t->speedadr[i] + MAGGI_SPEED_LOW];
    p2d = pd[t->speedadr[i] + MAGGI_SPEED_LOW];
    /* error, torque on each coordinate, speed */
    t2d = rv_i0d * rv_i0 + rv_i0 * rv_i0d + (rv_i1d * rv_i1 + rv_i1 * rv_i1d) + (rv_i2d * rv_i2 +
        rv_i2 * rv_i2d) + (p2d * p2 + p2 * p2d);
    speed2 = speed[i][2];
    c = 1.0 / (2.0 * speed2);
    speed2d = c * t2d;
    e = speed[i][0];
    ed = targetd - speed2d;
    gain = p[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    gaind = pd[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE] +
        p[t->speedadr[i] + MAGGI_SPEED_GAIN] * pd[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    speedd[i][0] = ed;
    if (t->speedlinear[i]) {
      speedd[i][1] = gaind * e + gain * ed;
    } else {
      t3 = fabs(e);
      c2 = MAGGI_RE(e) < 0.0 ? -1.0 : 1.0;
      t3d = c2 * ed;
      speedd[i][1] = (gaind * e + gain * ed) * t3 + gain * e * t3d;
    }
    speedd[i][2] = speed2d;
    if (t->speedheld[i]) {
      torqued = 0.0;
    } else {
      torqued = speedd[i][1];
    }
    for (k = t->speedqadr[i]; k < t->speedqadr[i] + t->speedqnum[i]; ++k) {
      taud[t->speedq[k]] += torqued;
    }
  }
}
