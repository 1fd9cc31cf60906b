/* Adjoint of core/kernel/mass.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* f_i = b_i.FS_i + tau_i */
void maggi_generalised_forces_b(const maggi_topo *t, const double b[restrict t->nbody][6],
                                double bb[restrict t->nbody][6],
                                const double FS[restrict t->nbody + 1][6],
                                double FSb[restrict t->nbody + 1][6],
                                const double tau[restrict t->nq], double taub[restrict t->nq],
                                double f[restrict t->nq], double fb[restrict t->nq])
{
  int i;
  double tb2;

  (void)tau;
  (void)f;
  for (i = t->nq - 1; i >= 0; --i) {
    tb2 = fb[i];
    fb[i] = 0.0;
    bb[t->qbody[i]][0] += tb2 * FS[t->qbody[i]][0];
    FSb[t->qbody[i]][0] += tb2 * b[t->qbody[i]][0];
    bb[t->qbody[i]][1] += tb2 * FS[t->qbody[i]][1];
    FSb[t->qbody[i]][1] += tb2 * b[t->qbody[i]][1];
    bb[t->qbody[i]][2] += tb2 * FS[t->qbody[i]][2];
    FSb[t->qbody[i]][2] += tb2 * b[t->qbody[i]][2];
    bb[t->qbody[i]][3] += tb2 * FS[t->qbody[i]][3];
    FSb[t->qbody[i]][3] += tb2 * b[t->qbody[i]][3];
    bb[t->qbody[i]][4] += tb2 * FS[t->qbody[i]][4];
    FSb[t->qbody[i]][4] += tb2 * b[t->qbody[i]][4];
    bb[t->qbody[i]][5] += tb2 * FS[t->qbody[i]][5];
    FSb[t->qbody[i]][5] += tb2 * b[t->qbody[i]][5];
    taub[i] += tb2;
  }
}
