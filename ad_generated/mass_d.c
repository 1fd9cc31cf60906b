/* Tangent of core/kernel/mass.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* f_i = b_i.FS_i + tau_i */
void maggi_generalised_forces_d(const maggi_topo *t, const double b[restrict t->nbody][6],
                                const double bd[restrict t->nbody][6],
                                const double FS[restrict t->nbody + 1][6],
                                const double FSd[restrict t->nbody + 1][6],
                                const double tau[restrict t->nq], const double taud[restrict t->nq],
                                double f[restrict t->nq], double fd[restrict t->nq])
{
  int i;

  (void)tau;
  (void)f;
  for (i = 0; i < t->nq; ++i) {
    fd[i] = bd[t->qbody[i]][0] * FS[t->qbody[i]][0] + b[t->qbody[i]][0] * FSd[t->qbody[i]][0] +
        (bd[t->qbody[i]][1] * FS[t->qbody[i]][1] + b[t->qbody[i]][1] * FSd[t->qbody[i]][1]) +
        (bd[t->qbody[i]][2] * FS[t->qbody[i]][2] + b[t->qbody[i]][2] * FSd[t->qbody[i]][2]) +
        (bd[t->qbody[i]][3] * FS[t->qbody[i]][3] + b[t->qbody[i]][3] * FSd[t->qbody[i]][3] +
        (bd[t->qbody[i]][4] * FS[t->qbody[i]][4] + b[t->qbody[i]][4] * FSd[t->qbody[i]][4]) +
        (bd[t->qbody[i]][5] * FS[t->qbody[i]][5] + b[t->qbody[i]][5] * FSd[t->qbody[i]][5])) +
        taud[i];
  }
}
