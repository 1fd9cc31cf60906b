/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/control.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* adds to what elements exert on coordinates */
void maggi_control_forces_dv(const maggi_topo *t, const double p[restrict t->np],
                             const double pd[restrict t->np][MAGGI_NDIR],
                             const double fun[restrict t->nfun][3],
                             const double fund[restrict t->nfun][3][MAGGI_NDIR],
                             const double v[restrict t->nq], const double rv[restrict t->npoint][3],
                             const double rvd[restrict t->npoint][3][MAGGI_NDIR],
                             double speed[restrict t->nspeed][3],
                             double speedd[restrict t->nspeed][3][MAGGI_NDIR],
                             double tau[restrict t->nq], double taud[restrict t->nq][MAGGI_NDIR],
                             double power[restrict 1], int nbdirs)
{
  int i, k, nd;
  double c, c2, e, factor, gain, p2, rv_i0, rv_i1, rv_i2, speed2, t3;
  double ed[MAGGI_NDIR], factord[MAGGI_NDIR], gaind[MAGGI_NDIR], speed2d[MAGGI_NDIR],
      torqued[MAGGI_NDIR];

  (void)v;
  (void)tau;
  (void)power;
  (void)nbdirs;
  for (i = 0; i < t->nspeed; ++i) {
    if (t->speedfun[i] >= 0) {
      factor = fun[t->speedfun[i]][0];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        factord[nd] = fund[t->speedfun[i]][0][nd];
      }
    } else {
      factor = 1.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        factord[nd] = 0.0;
      }
    }
    rv_i0 = rv[t->speedpoint[i]][0];
    rv_i1 = rv[t->speedpoint[i]][1];
    rv_i2 = rv[t->speedpoint[i]][2];
    p2 = p[t->speedadr[i] + MAGGI_SPEED_LOW];
    speed2 = speed[i][2];
    c = 1.0 / (2.0 * speed2);
    e = speed[i][0];
    gain = p[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double p2d, rv_i0d, rv_i1d, rv_i2d, t2d, targetd;

      targetd = pd[t->speedadr[i]][nd] * factor + p[t->speedadr[i]] * factord[nd];
      rv_i0d = rvd[t->speedpoint[i]][0][nd];
      rv_i1d = rvd[t->speedpoint[i]][1][nd];
      rv_i2d = rvd[t->speedpoint[i]][2][nd];
      p2d = pd[t->speedadr[i] + MAGGI_SPEED_LOW][nd];
      /* error, torque on each coordinate, speed */
      t2d = rv_i0d * rv_i0 + rv_i0 * rv_i0d + (rv_i1d * rv_i1 + rv_i1 * rv_i1d) + (rv_i2d * rv_i2 +
          rv_i2 * rv_i2d) + (p2d * p2 + p2 * p2d);
      speed2d[nd] = c * t2d;
      ed[nd] = targetd - speed2d[nd];
      gaind[nd] = pd[t->speedadr[i] + MAGGI_SPEED_GAIN][nd] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE]
          + p[t->speedadr[i] + MAGGI_SPEED_GAIN] * pd[t->speedadr[i] + MAGGI_SPEED_TORQUE][nd];
      speedd[i][0][nd] = ed[nd];
    }
    if (t->speedlinear[i]) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        speedd[i][1][nd] = gaind[nd] * e + gain * ed[nd];
      }
    } else {
      t3 = fabs(e);
      c2 = MAGGI_RE(e) < 0.0 ? -1.0 : 1.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t3d;

        t3d = c2 * ed[nd];
        speedd[i][1][nd] = (gaind[nd] * e + gain * ed[nd]) * t3 + gain * e * t3d;
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      speedd[i][2][nd] = speed2d[nd];
    }
    if (t->speedheld[i]) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        torqued[nd] = 0.0;
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        torqued[nd] = speedd[i][1][nd];
      }
    }
    for (k = t->speedqadr[i]; k < t->speedqadr[i] + t->speedqnum[i]; ++k) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        taud[t->speedq[k]][nd] += torqued[nd];
      }
    }
  }
}
