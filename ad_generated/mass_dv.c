/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/mass.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* f_i = b_i.FS_i + tau_i */
void maggi_generalised_forces_dv(const maggi_topo *t, const double b[restrict t->nbody][6],
                                 const double bd[restrict t->nbody][6][MAGGI_NDIR],
                                 const double FS[restrict t->nbody + 1][6],
                                 const double FSd[restrict t->nbody + 1][6][MAGGI_NDIR],
                                 const double tau[restrict t->nq],
                                 const double taud[restrict t->nq][MAGGI_NDIR],
                                 double f[restrict t->nq], double fd[restrict t->nq][MAGGI_NDIR],
                                 int nbdirs)
{
  int i, nd;

  (void)tau;
  (void)f;
  (void)nbdirs;
  for (i = 0; i < t->nq; ++i) {
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      fd[i][nd] = bd[t->qbody[i]][0][nd] * FS[t->qbody[i]][0] + b[t->qbody[i]][0] *
          FSd[t->qbody[i]][0][nd] + (bd[t->qbody[i]][1][nd] * FS[t->qbody[i]][1] + b[t->qbody[i]][1]
          * FSd[t->qbody[i]][1][nd]) + (bd[t->qbody[i]][2][nd] * FS[t->qbody[i]][2] +
          b[t->qbody[i]][2] * FSd[t->qbody[i]][2][nd]) + (bd[t->qbody[i]][3][nd] *
          FS[t->qbody[i]][3] + b[t->qbody[i]][3] * FSd[t->qbody[i]][3][nd] + (bd[t->qbody[i]][4][nd]
          * FS[t->qbody[i]][4] + b[t->qbody[i]][4] * FSd[t->qbody[i]][4][nd]) +
          (bd[t->qbody[i]][5][nd] * FS[t->qbody[i]][5] + b[t->qbody[i]][5] *
          FSd[t->qbody[i]][5][nd])) + taud[i][nd];
    }
  }
}
