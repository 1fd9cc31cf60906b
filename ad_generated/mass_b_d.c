/* Tangent of the adjoint of core/kernel/mass.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* f_i = b_i.FS_i + tau_i */
void maggi_generalised_forces_b_d(const maggi_topo *t, const double b[restrict t->nbody][6],
                                  const double bd[restrict t->nbody][6],
                                  double bb[restrict t->nbody][6], double bbd[restrict t->nbody][6],
                                  const double FS[restrict t->nbody + 1][6],
                                  const double FSd[restrict t->nbody + 1][6],
                                  double FSb[restrict t->nbody + 1][6],
                                  double FSbd[restrict t->nbody + 1][6],
                                  const double tau[restrict t->nq],
                                  const double taud[restrict t->nq], double taub[restrict t->nq],
                                  double taubd[restrict t->nq], double f[restrict t->nq],
                                  double fd[restrict t->nq], double fb[restrict t->nq],
                                  double fbd[restrict t->nq])
{
  int i;
  double tb2, tb2d;

  (void)tau;
  (void)taud;
  (void)f;
  (void)fd;
  for (i = t->nq - 1; i >= 0; --i) {
    tb2 = fb[i];
    tb2d = fbd[i];
    fb[i] = 0.0;
    fbd[i] = 0.0;
    bb[t->qbody[i]][0] += tb2 * FS[t->qbody[i]][0];
    bbd[t->qbody[i]][0] += tb2d * FS[t->qbody[i]][0] + tb2 * FSd[t->qbody[i]][0];
    FSb[t->qbody[i]][0] += tb2 * b[t->qbody[i]][0];
    FSbd[t->qbody[i]][0] += tb2d * b[t->qbody[i]][0] + tb2 * bd[t->qbody[i]][0];
    bb[t->qbody[i]][1] += tb2 * FS[t->qbody[i]][1];
    bbd[t->qbody[i]][1] += tb2d * FS[t->qbody[i]][1] + tb2 * FSd[t->qbody[i]][1];
    FSb[t->qbody[i]][1] += tb2 * b[t->qbody[i]][1];
    FSbd[t->qbody[i]][1] += tb2d * b[t->qbody[i]][1] + tb2 * bd[t->qbody[i]][1];
    bb[t->qbody[i]][2] += tb2 * FS[t->qbody[i]][2];
    bbd[t->qbody[i]][2] += tb2d * FS[t->qbody[i]][2] + tb2 * FSd[t->qbody[i]][2];
    FSb[t->qbody[i]][2] += tb2 * b[t->qbody[i]][2];
    FSbd[t->qbody[i]][2] += tb2d * b[t->qbody[i]][2] + tb2 * bd[t->qbody[i]][2];
    bb[t->qbody[i]][3] += tb2 * FS[t->qbody[i]][3];
    bbd[t->qbody[i]][3] += tb2d * FS[t->qbody[i]][3] + tb2 * FSd[t->qbody[i]][3];
    FSb[t->qbody[i]][3] += tb2 * b[t->qbody[i]][3];
    FSbd[t->qbody[i]][3] += tb2d * b[t->qbody[i]][3] + tb2 * bd[t->qbody[i]][3];
    bb[t->qbody[i]][4] += tb2 * FS[t->qbody[i]][4];
    bbd[t->qbody[i]][4] += tb2d * FS[t->qbody[i]][4] + tb2 * FSd[t->qbody[i]][4];
    FSb[t->qbody[i]][4] += tb2 * b[t->qbody[i]][4];
    FSbd[t->qbody[i]][4] += tb2d * b[t->qbody[i]][4] + tb2 * bd[t->qbody[i]][4];
    bb[t->qbody[i]][5] += tb2 * FS[t->qbody[i]][5];
    bbd[t->qbody[i]][5] += tb2d * FS[t->qbody[i]][5] + tb2 * FSd[t->qbody[i]][5];
    FSb[t->qbody[i]][5] += tb2 * b[t->qbody[i]][5];
    FSbd[t->qbody[i]][5] += tb2d * b[t->qbody[i]][5] + tb2 * bd[t->qbody[i]][5];
    taub[i] += tb2;
    taubd[i] += tb2d;
  }
}
