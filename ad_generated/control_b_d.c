/* Tangent of the adjoint of core/kernel/control.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* adds to what elements exert on coordinates */
void maggi_control_forces_b_d(const maggi_topo *t, const double p[restrict t->np],
                              const double pd[restrict t->np], double pb[restrict t->np],
                              double pbd[restrict t->np], const double fun[restrict t->nfun][3],
                              const double fund[restrict t->nfun][3],
                              double funb[restrict t->nfun][3], double funbd[restrict t->nfun][3],
                              const double v[restrict t->nq],
                              const double rv[restrict t->npoint][3],
                              const double rvd[restrict t->npoint][3],
                              double rvb[restrict t->npoint][3], double rvbd[restrict t->npoint][3],
                              double speed[restrict t->nspeed][3],
                              double speedd[restrict t->nspeed][3],
                              double speedb[restrict t->nspeed][3],
                              double speedbd[restrict t->nspeed][3], double tau[restrict t->nq],
                              double taud[restrict t->nq], double taub[restrict t->nq],
                              double taubd[restrict t->nq], double power[restrict 1])
{
  int i, k;
  double e, eb, ebd, ed, factor, factorb, factorbd, factord, gain, gainb, gainbd, gaind, p2, p2b,
      p2bd, p2d, rv_i0, rv_i0b, rv_i0bd, rv_i0d, rv_i1, rv_i1b, rv_i1bd, rv_i1d, rv_i2, rv_i2b,
      rv_i2bd, rv_i2d, speed2, speed2b, speed2bd, speed2d, t2b, t2bd, t3, t3b, t3bd, t3d, targetb,
      targetbd, tb2, tb2d, tb3, tb3d, tb4, tb4d, torqueb, torquebd;

  (void)v;
  (void)tau;
  (void)taud;
  (void)power;
  for (i = t->nspeed - 1; i >= 0; --i) {
    if (t->speedfun[i] >= 0) {
      factor = fun[t->speedfun[i]][0];
      factord = fund[t->speedfun[i]][0];
    } else {
      factor = 1.0;
      factord = 0.0;
    }
    rv_i0 = rv[t->speedpoint[i]][0];
    rv_i0d = rvd[t->speedpoint[i]][0];
    rv_i1 = rv[t->speedpoint[i]][1];
    rv_i1d = rvd[t->speedpoint[i]][1];
    rv_i2 = rv[t->speedpoint[i]][2];
    rv_i2d = rvd[t->speedpoint[i]][2];
    p2 = p[t->speedadr[i] + MAGGI_SPEED_LOW];
    p2d = pd[t->speedadr[i] + MAGGI_SPEED_LOW];
    speed2 = speed[i][2];
    speed2d = speedd[i][2];
    e = speed[i][0];
    ed = speedd[i][0];
    gain = p[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    gaind = pd[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE] +
        p[t->speedadr[i] + MAGGI_SPEED_GAIN] * pd[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    torqueb = 0.0;
    torquebd = 0.0;
    for (k = t->speedqadr[i] + t->speedqnum[i] - 1; k >= t->speedqadr[i]; --k) {
      torqueb += taub[t->speedq[k]];
      torquebd += taubd[t->speedq[k]];
    }
    if (t->speedheld[i]) {
      torqueb = 0.0;
      torquebd = 0.0;
    } else {
      speedb[i][1] += torqueb;
      speedbd[i][1] += torquebd;
      torqueb = 0.0;
      torquebd = 0.0;
    }
    speed2b = speedb[i][2];
    speed2bd = speedbd[i][2];
    speedb[i][2] = 0.0;
    speedbd[i][2] = 0.0;
    eb = 0.0;
    ebd = 0.0;
    gainb = 0.0;
    gainbd = 0.0;
    if (t->speedlinear[i]) {
      tb2 = speedb[i][1];
      tb2d = speedbd[i][1];
      speedb[i][1] = 0.0;
      speedbd[i][1] = 0.0;
      gainb += tb2 * e;
      gainbd += tb2d * e + tb2 * ed;
      eb += tb2 * gain;
      ebd += tb2d * gain + tb2 * gaind;
    } else {
      t3 = fabs(e);
      t3d = (MAGGI_RE(e) < 0.0 ? -1.0 : 1.0) * ed;
      tb3 = speedb[i][1];
      tb3d = speedbd[i][1];
      speedb[i][1] = 0.0;
      speedbd[i][1] = 0.0;
      tb4 = tb3 * t3;
      tb4d = tb3d * t3 + tb3 * t3d;
      gainb += tb4 * e;
      gainbd += tb4d * e + tb4 * ed;
      eb += tb4 * gain;
      ebd += tb4d * gain + tb4 * gaind;
      t3b = tb3 * (gain * e);
      t3bd = tb3d * (gain * e) + tb3 * (gaind * e + gain * ed);
      eb += t3b * (MAGGI_RE(e) < 0.0 ? -1.0 : 1.0);
      ebd += t3bd * (MAGGI_RE(e) < 0.0 ? -1.0 : 1.0);
    }
    eb += speedb[i][0];
    ebd += speedbd[i][0];
    speedb[i][0] = 0.0;
    speedbd[i][0] = 0.0;
    pb[t->speedadr[i] + MAGGI_SPEED_GAIN] += gainb * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    pbd[t->speedadr[i] + MAGGI_SPEED_GAIN] += gainbd * p[t->speedadr[i] + MAGGI_SPEED_TORQUE] +
        gainb * pd[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    pb[t->speedadr[i] + MAGGI_SPEED_TORQUE] += gainb * p[t->speedadr[i] + MAGGI_SPEED_GAIN];
    pbd[t->speedadr[i] + MAGGI_SPEED_TORQUE] += gainbd * p[t->speedadr[i] + MAGGI_SPEED_GAIN] +
        gainb * pd[t->speedadr[i] + MAGGI_SPEED_GAIN];
    targetb = eb;
    targetbd = ebd;
    speed2b -= eb;
    speed2bd -= ebd;
    t2b = speed2b * (1.0 / (2.0 * speed2));
    t2bd = speed2bd * (1.0 / (2.0 * speed2)) - speed2b * (1.0 / (2.0 * speed2) * (2.0 * speed2d) /
        (2.0 * speed2));
    rv_i0b = t2b * rv_i0;
    /* error, torque on each coordinate, speed */
    rv_i0bd = t2bd * rv_i0 + t2b * rv_i0d;
    rv_i0b += t2b * rv_i0;
    rv_i0bd += t2bd * rv_i0 + t2b * rv_i0d;
    rv_i1b = t2b * rv_i1;
    rv_i1bd = t2bd * rv_i1 + t2b * rv_i1d;
    rv_i1b += t2b * rv_i1;
    rv_i1bd += t2bd * rv_i1 + t2b * rv_i1d;
    rv_i2b = t2b * rv_i2;
    rv_i2bd = t2bd * rv_i2 + t2b * rv_i2d;
    rv_i2b += t2b * rv_i2;
    rv_i2bd += t2bd * rv_i2 + t2b * rv_i2d;
    p2b = t2b * p2;
    p2bd = t2bd * p2 + t2b * p2d;
    p2b += t2b * p2;
    p2bd += t2bd * p2 + t2b * p2d;
    pb[t->speedadr[i] + MAGGI_SPEED_LOW] += p2b;
    pbd[t->speedadr[i] + MAGGI_SPEED_LOW] += p2bd;
    rvb[t->speedpoint[i]][2] += rv_i2b;
    rvbd[t->speedpoint[i]][2] += rv_i2bd;
    rvb[t->speedpoint[i]][1] += rv_i1b;
    rvbd[t->speedpoint[i]][1] += rv_i1bd;
    rvb[t->speedpoint[i]][0] += rv_i0b;
    rvbd[t->speedpoint[i]][0] += rv_i0bd;
    pb[t->speedadr[i]] += targetb * factor;
    pbd[t->speedadr[i]] += targetbd * factor + targetb * factord;
    factorb = targetb * p[t->speedadr[i]];
    factorbd = targetbd * p[t->speedadr[i]] + targetb * pd[t->speedadr[i]];
    if (t->speedfun[i] >= 0) {
      funb[t->speedfun[i]][0] += factorb;
      funbd[t->speedfun[i]][0] += factorbd;
      factorb = 0.0;
      factorbd = 0.0;
    } else {
      factorb = 0.0;
      factorbd = 0.0;
    }
  }
}
