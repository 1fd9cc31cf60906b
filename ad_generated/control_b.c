/* Adjoint of core/kernel/control.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* adds to what elements exert on coordinates */
void maggi_control_forces_b(const maggi_topo *t, const double p[restrict t->np],
                            double pb[restrict t->np], const double fun[restrict t->nfun][3],
                            double funb[restrict t->nfun][3], const double v[restrict t->nq],
                            const double rv[restrict t->npoint][3],
                            double rvb[restrict t->npoint][3], double speed[restrict t->nspeed][3],
                            double speedb[restrict t->nspeed][3], double tau[restrict t->nq],
                            double taub[restrict t->nq], double power[restrict 1])
{
  int i, k;
  double e, eb, factor, factorb, gain, gainb, p2, p2b, rv_i0, rv_i0b, rv_i1, rv_i1b, rv_i2, rv_i2b,
      speed2, speed2b, t2b, t3, t3b, targetb, tb2, tb3, tb4, torqueb;

  (void)v;
  (void)tau;
  (void)power;
  for (i = t->nspeed - 1; i >= 0; --i) {
    if (t->speedfun[i] >= 0) {
      factor = fun[t->speedfun[i]][0];
    } else {
      factor = 1.0;
    }
    rv_i0 = rv[t->speedpoint[i]][0];
    rv_i1 = rv[t->speedpoint[i]][1];
    rv_i2 = rv[t->speedpoint[i]][2];
    p2 = p[t->speedadr[i] + MAGGI_SPEED_LOW];
    speed2 = speed[i][2];
    e = speed[i][0];
    gain = p[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    torqueb = 0.0;
    for (k = t->speedqadr[i] + t->speedqnum[i] - 1; k >= t->speedqadr[i]; --k) {
      torqueb += taub[t->speedq[k]];
    }
    if (t->speedheld[i]) {
      torqueb = 0.0;
    } else {
      speedb[i][1] += torqueb;
      torqueb = 0.0;
    }
    speed2b = speedb[i][2];
    speedb[i][2] = 0.0;
    eb = 0.0;
    gainb = 0.0;
    if (t->speedlinear[i]) {
      tb2 = speedb[i][1];
      speedb[i][1] = 0.0;
      gainb += tb2 * e;
      eb += tb2 * gain;
    } else {
      t3 = fabs(e);
      tb3 = speedb[i][1];
      speedb[i][1] = 0.0;
      tb4 = tb3 * t3;
      gainb += tb4 * e;
      eb += tb4 * gain;
      t3b = tb3 * (gain * e);
      eb += t3b * (MAGGI_RE(e) < 0.0 ? -1.0 : 1.0);
    }
    eb += speedb[i][0];
    speedb[i][0] = 0.0;
    pb[t->speedadr[i] + MAGGI_SPEED_GAIN] += gainb * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    pb[t->speedadr[i] + MAGGI_SPEED_TORQUE] += gainb * p[t->speedadr[i] + MAGGI_SPEED_GAIN];
    targetb = eb;
    speed2b -= eb;
    t2b = speed2b * (1.0 / (2.0 * speed2));
    /* error, torque on each coordinate, speed */
    rv_i0b = t2b * rv_i0;
    rv_i0b += t2b * rv_i0;
    rv_i1b = t2b * rv_i1;
    rv_i1b += t2b * rv_i1;
    rv_i2b = t2b * rv_i2;
    rv_i2b += t2b * rv_i2;
    p2b = t2b * p2;
    p2b += t2b * p2;
    pb[t->speedadr[i] + MAGGI_SPEED_LOW] += p2b;
    rvb[t->speedpoint[i]][2] += rv_i2b;
    rvb[t->speedpoint[i]][1] += rv_i1b;
    rvb[t->speedpoint[i]][0] += rv_i0b;
    pb[t->speedadr[i]] += targetb * factor;
    factorb = targetb * p[t->speedadr[i]];
    if (t->speedfun[i] >= 0) {
      funb[t->speedfun[i]][0] += factorb;
      factorb = 0.0;
    } else {
      factorb = 0.0;
    }
  }
}
