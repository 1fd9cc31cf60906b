/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/reaction.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* adds to F what the loops exert on bodies; what open ones would exert on the joints that carry both
 * sides is left out, as in Phi_z */
void maggi_loop_forces_dv(const maggi_topo *t, const double prim0[restrict t->nprim],
                          const double prim0d[restrict t->nprim][MAGGI_NDIR],
                          const double r[restrict t->npoint][3],
                          const double rd[restrict t->npoint][3][MAGGI_NDIR],
                          const double dir[restrict t->ndir][3],
                          const double dird[restrict t->ndir][3][MAGGI_NDIR],
                          const double lambda[restrict t->nrow],
                          const double lambdad[restrict t->nrow][MAGGI_NDIR],
                          double F[restrict t->nbody + 1][6],
                          double Fd[restrict t->nbody + 1][6][MAGGI_NDIR], int nbdirs)
{
  int c, i, nd;
  double dir_i0, dir_i0_2, dir_i0_3, dir_i0_4, dir_i1, dir_i1_2, dir_i1_3, dir_i1_4, dir_i2,
      dir_i2_2, dir_i2_3, dir_i2_4, e0, e1, e20, e21, e22, e2_2, fa0, fa1, fa2, fb0, fb1, fb2, inv,
      inv2, inv3, l0, l1, l20, l21, l22, l2_2, l30, l31, l32, lambda_i, n20, n21, n22, r_i0, r_i0_2,
      r_i0_3, r_i1, r_i1_2, r_i1_3, r_i2, r_i2_2, r_i2_3, t2, t3, t4;
  double fa0d[MAGGI_NDIR], fa1d[MAGGI_NDIR], fb0d[MAGGI_NDIR], fb1d[MAGGI_NDIR], fb2d[MAGGI_NDIR];

  (void)F;
  (void)nbdirs;
  for (i = 0; i < t->nprim; ++i) {
    /* wrench at P that a building block exerts on body a and body b: - Phi^T lambda */
    if (t->primkind[i] == MAGGI_PRIM_AXIS) {
      l0 = lambda[t->primrow[i]];
      l1 = lambda[t->primrow[i] + 1];
      l2_2 = lambda[t->primrow[i] + 2];
      dir_i2 = dir[t->primda[i]][2];
      dir_i1 = dir[t->primda[i]][1];
      dir_i0 = dir[t->primda[i]][0];
      dir_i1_2 = dir[t->primdb[i]][1];
      dir_i2_2 = dir[t->primdb[i]][2];
      dir_i0_2 = dir[t->primdb[i]][0];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double ca0d, ca1d, ca2d, cb20d, cb21d, cb22d, dir_i0_2d, dir_i0d, dir_i1_2d, dir_i1d,
            dir_i2_2d, dir_i2d, l0d, l1d, l2_2d;

        l0d = lambdad[t->primrow[i]][nd];
        l1d = lambdad[t->primrow[i] + 1][nd];
        l2_2d = lambdad[t->primrow[i] + 2][nd];
        dir_i2d = dird[t->primda[i]][2][nd];
        dir_i1d = dird[t->primda[i]][1][nd];
        ca0d = l1d * dir_i2 + l1 * dir_i2d - (l2_2d * dir_i1 + l2_2 * dir_i1d);
        dir_i0d = dird[t->primda[i]][0][nd];
        ca1d = l2_2d * dir_i0 + l2_2 * dir_i0d - (l0d * dir_i2 + l0 * dir_i2d);
        ca2d = l0d * dir_i1 + l0 * dir_i1d - (l1d * dir_i0 + l1 * dir_i0d);
        dir_i1_2d = dird[t->primdb[i]][1][nd];
        dir_i2_2d = dird[t->primdb[i]][2][nd];
        cb20d = dir_i1_2d * l2_2 + dir_i1_2 * l2_2d - (dir_i2_2d * l1 + dir_i2_2 * l1d);
        dir_i0_2d = dird[t->primdb[i]][0][nd];
        cb21d = dir_i2_2d * l0 + dir_i2_2 * l0d - (dir_i0_2d * l2_2 + dir_i0_2 * l2_2d);
        cb22d = dir_i0_2d * l1 + dir_i0_2 * l1d - (dir_i1_2d * l0 + dir_i1_2 * l0d);
        Fd[t->primba[i]][3][nd] += ca0d;
        Fd[t->primba[i]][4][nd] += ca1d;
        Fd[t->primba[i]][5][nd] += ca2d;
        Fd[t->primbb[i]][3][nd] += cb20d;
        Fd[t->primbb[i]][4][nd] += cb21d;
        Fd[t->primbb[i]][5][nd] += cb22d;
      }
    } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
      dir_i1_3 = dir[t->primdb[i]][1];
      dir_i2_3 = dir[t->primda[i]][2];
      dir_i2_4 = dir[t->primdb[i]][2];
      dir_i1_4 = dir[t->primda[i]][1];
      n20 = dir_i1_3 * dir_i2_3 - dir_i2_4 * dir_i1_4;
      dir_i0_3 = dir[t->primda[i]][0];
      dir_i0_4 = dir[t->primdb[i]][0];
      n21 = dir_i2_4 * dir_i0_3 - dir_i0_4 * dir_i2_3;
      n22 = dir_i0_4 * dir_i1_4 - dir_i1_3 * dir_i0_3;
      lambda_i = lambda[t->primrow[i]];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double ca0_2d, ca1_2d, ca2_2d, cb20_2d, cb21_2d, cb22_2d, dir_i0_3d, dir_i0_4d, dir_i1_3d,
            dir_i1_4d, dir_i2_3d, dir_i2_4d, lambda_id, n20d, n21d, n22d;

        dir_i1_3d = dird[t->primdb[i]][1][nd];
        dir_i2_3d = dird[t->primda[i]][2][nd];
        dir_i2_4d = dird[t->primdb[i]][2][nd];
        dir_i1_4d = dird[t->primda[i]][1][nd];
        n20d = dir_i1_3d * dir_i2_3 + dir_i1_3 * dir_i2_3d - (dir_i2_4d * dir_i1_4 + dir_i2_4 *
            dir_i1_4d);
        dir_i0_3d = dird[t->primda[i]][0][nd];
        dir_i0_4d = dird[t->primdb[i]][0][nd];
        n21d = dir_i2_4d * dir_i0_3 + dir_i2_4 * dir_i0_3d - (dir_i0_4d * dir_i2_3 + dir_i0_4 *
            dir_i2_3d);
        n22d = dir_i0_4d * dir_i1_4 + dir_i0_4 * dir_i1_4d - (dir_i1_3d * dir_i0_3 + dir_i1_3 *
            dir_i0_3d);
        lambda_id = lambdad[t->primrow[i]][nd];
        ca0_2d = lambda_id * n20 + lambda_i * n20d;
        cb20_2d = -(lambda_id * n20) - lambda_i * n20d;
        ca1_2d = lambda_id * n21 + lambda_i * n21d;
        cb21_2d = -(lambda_id * n21) - lambda_i * n21d;
        ca2_2d = lambda_id * n22 + lambda_i * n22d;
        cb22_2d = -(lambda_id * n22) - lambda_i * n22d;
        Fd[t->primba[i]][3][nd] += ca0_2d;
        Fd[t->primba[i]][4][nd] += ca1_2d;
        Fd[t->primba[i]][5][nd] += ca2_2d;
        Fd[t->primbb[i]][3][nd] += cb20_2d;
        Fd[t->primbb[i]][4][nd] += cb21_2d;
        Fd[t->primbb[i]][5][nd] += cb22_2d;
      }
    } else {
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        fb0 = lambda[t->primrow[i]];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          fb0d[nd] = lambdad[t->primrow[i]][nd];
        }
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        fb0 = lambda[t->primrow[i]] * dir[t->primdb[i]][0];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          fb0d[nd] = lambdad[t->primrow[i]][nd] * dir[t->primdb[i]][0] + lambda[t->primrow[i]] *
              dird[t->primdb[i]][0][nd];
        }
      } else {
        t2 = lambda[t->primrow[i]] * (r[t->primpa[i]][0] - r[t->primpb[i]][0]) / prim0[i];
        inv = 1.0 / prim0[i];
        fb0 = t2;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t2d;

          t2d = (lambdad[t->primrow[i]][nd] * (r[t->primpa[i]][0] - r[t->primpb[i]][0]) +
              lambda[t->primrow[i]] * (rd[t->primpa[i]][0][nd] - rd[t->primpb[i]][0][nd]) - t2 *
              prim0d[i][nd]) * inv;
          fb0d[nd] = t2d;
        }
      }
      fa0 = -fb0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        fa0d[nd] = -fb0d[nd];
      }
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        fb1 = lambda[t->primrow[i] + 1];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          fb1d[nd] = lambdad[t->primrow[i] + 1][nd];
        }
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        fb1 = lambda[t->primrow[i]] * dir[t->primdb[i]][1];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          fb1d[nd] = lambdad[t->primrow[i]][nd] * dir[t->primdb[i]][1] + lambda[t->primrow[i]] *
              dird[t->primdb[i]][1][nd];
        }
      } else {
        t3 = lambda[t->primrow[i]] * (r[t->primpa[i]][1] - r[t->primpb[i]][1]) / prim0[i];
        inv2 = 1.0 / prim0[i];
        fb1 = t3;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t3d;

          t3d = (lambdad[t->primrow[i]][nd] * (r[t->primpa[i]][1] - r[t->primpb[i]][1]) +
              lambda[t->primrow[i]] * (rd[t->primpa[i]][1][nd] - rd[t->primpb[i]][1][nd]) - t3 *
              prim0d[i][nd]) * inv2;
          fb1d[nd] = t3d;
        }
      }
      fa1 = -fb1;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        fa1d[nd] = -fb1d[nd];
      }
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        fb2 = lambda[t->primrow[i] + 2];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          fb2d[nd] = lambdad[t->primrow[i] + 2][nd];
        }
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        fb2 = lambda[t->primrow[i]] * dir[t->primdb[i]][2];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          fb2d[nd] = lambdad[t->primrow[i]][nd] * dir[t->primdb[i]][2] + lambda[t->primrow[i]] *
              dird[t->primdb[i]][2][nd];
        }
      } else {
        t4 = lambda[t->primrow[i]] * (r[t->primpa[i]][2] - r[t->primpb[i]][2]) / prim0[i];
        inv3 = 1.0 / prim0[i];
        fb2 = t4;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t4d;

          t4d = (lambdad[t->primrow[i]][nd] * (r[t->primpa[i]][2] - r[t->primpb[i]][2]) +
              lambda[t->primrow[i]] * (rd[t->primpa[i]][2][nd] - rd[t->primpb[i]][2][nd]) - t4 *
              prim0d[i][nd]) * inv3;
          fb2d[nd] = t4d;
        }
      }
      fa2 = -fb2;
      r_i1 = r[t->primpa[i]][1];
      r_i2 = r[t->primpa[i]][2];
      r_i0 = r[t->primpa[i]][0];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double fa2d, r_i0d, r_i1d, r_i2d;

        fa2d = -fb2d[nd];
        Fd[t->primba[i]][0][nd] += fa0d[nd];
        Fd[t->primba[i]][1][nd] += fa1d[nd];
        Fd[t->primba[i]][2][nd] += fa2d;
        r_i1d = rd[t->primpa[i]][1][nd];
        r_i2d = rd[t->primpa[i]][2][nd];
        Fd[t->primba[i]][3][nd] += r_i1d * fa2 + r_i1 * fa2d - (r_i2d * fa1 + r_i2 * fa1d[nd]);
        r_i0d = rd[t->primpa[i]][0][nd];
        Fd[t->primba[i]][4][nd] += r_i2d * fa0 + r_i2 * fa0d[nd] - (r_i0d * fa2 + r_i0 * fa2d);
        Fd[t->primba[i]][5][nd] += r_i0d * fa1 + r_i0 * fa1d[nd] - (r_i1d * fa0 + r_i1 * fa0d[nd]);
      }
      if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        r_i1_2 = r[t->primpa[i]][1];
        r_i2_2 = r[t->primpa[i]][2];
        r_i0_2 = r[t->primpa[i]][0];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double r_i0_2d, r_i1_2d, r_i2_2d;

          Fd[t->primbb[i]][0][nd] += fb0d[nd];
          Fd[t->primbb[i]][1][nd] += fb1d[nd];
          Fd[t->primbb[i]][2][nd] += fb2d[nd];
          r_i1_2d = rd[t->primpa[i]][1][nd];
          r_i2_2d = rd[t->primpa[i]][2][nd];
          Fd[t->primbb[i]][3][nd] += r_i1_2d * fb2 + r_i1_2 * fb2d[nd] - (r_i2_2d * fb1 + r_i2_2 *
              fb1d[nd]);
          r_i0_2d = rd[t->primpa[i]][0][nd];
          Fd[t->primbb[i]][4][nd] += r_i2_2d * fb0 + r_i2_2 * fb0d[nd] - (r_i0_2d * fb2 + r_i0_2 *
              fb2d[nd]);
          Fd[t->primbb[i]][5][nd] += r_i0_2d * fb1 + r_i0_2 * fb1d[nd] - (r_i1_2d * fb0 + r_i1_2 *
              fb0d[nd]);
        }
      } else {
        r_i1_3 = r[t->primpb[i]][1];
        r_i2_3 = r[t->primpb[i]][2];
        r_i0_3 = r[t->primpb[i]][0];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double r_i0_3d, r_i1_3d, r_i2_3d;

          Fd[t->primbb[i]][0][nd] += fb0d[nd];
          Fd[t->primbb[i]][1][nd] += fb1d[nd];
          Fd[t->primbb[i]][2][nd] += fb2d[nd];
          r_i1_3d = rd[t->primpb[i]][1][nd];
          r_i2_3d = rd[t->primpb[i]][2][nd];
          Fd[t->primbb[i]][3][nd] += r_i1_3d * fb2 + r_i1_3 * fb2d[nd] - (r_i2_3d * fb1 + r_i2_3 *
              fb1d[nd]);
          r_i0_3d = rd[t->primpb[i]][0][nd];
          Fd[t->primbb[i]][4][nd] += r_i2_3d * fb0 + r_i2_3 * fb0d[nd] - (r_i0_3d * fb2 + r_i0_3 *
              fb2d[nd]);
          Fd[t->primbb[i]][5][nd] += r_i0_3d * fb1 + r_i0_3 * fb1d[nd] - (r_i1_3d * fb0 + r_i1_3 *
              fb0d[nd]);
        }
      }
    }
  }
  for (i = 0; i < t->nprim; ++i) {
    c = t->loopcommon[t->primloop[i]];
    if (c < t->nbody && t->primkind[i] == MAGGI_PRIM_POINT) {
      e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
      l20 = lambda[t->primrow[i]];
      e1 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
      l21 = lambda[t->primrow[i] + 1];
      e2_2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
      l22 = lambda[t->primrow[i] + 2];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double c20d, c21d, c22d, e0d, e1d, e2_2d, l20d, l21d, l22d;

        /* the moment of an open pair of forces, which no joint of the loop takes */
        e0d = rd[t->primpa[i]][0][nd] - rd[t->primpb[i]][0][nd];
        l20d = lambdad[t->primrow[i]][nd];
        e1d = rd[t->primpa[i]][1][nd] - rd[t->primpb[i]][1][nd];
        l21d = lambdad[t->primrow[i] + 1][nd];
        e2_2d = rd[t->primpa[i]][2][nd] - rd[t->primpb[i]][2][nd];
        l22d = lambdad[t->primrow[i] + 2][nd];
        c20d = e1d * l22 + e1 * l22d - (e2_2d * l21 + e2_2 * l21d);
        c21d = e2_2d * l20 + e2_2 * l20d - (e0d * l22 + e0 * l22d);
        c22d = e0d * l21 + e0 * l21d - (e1d * l20 + e1 * l20d);
        Fd[c][3][nd] += c20d;
        Fd[c][4][nd] += c21d;
        Fd[c][5][nd] += c22d;
      }
    } else if (c < t->nbody && t->primkind[i] == MAGGI_PRIM_AXIS) {
      e20 = dir[t->primda[i]][0] - dir[t->primdb[i]][0];
      l30 = lambda[t->primrow[i]];
      e21 = dir[t->primda[i]][1] - dir[t->primdb[i]][1];
      l31 = lambda[t->primrow[i] + 1];
      e22 = dir[t->primda[i]][2] - dir[t->primdb[i]][2];
      l32 = lambda[t->primrow[i] + 2];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double c30d, c31d, c32d, e20d, e21d, e22d, l30d, l31d, l32d;

        /* the moment of an open pair of forces, which no joint of the loop takes */
        e20d = dird[t->primda[i]][0][nd] - dird[t->primdb[i]][0][nd];
        l30d = lambdad[t->primrow[i]][nd];
        e21d = dird[t->primda[i]][1][nd] - dird[t->primdb[i]][1][nd];
        l31d = lambdad[t->primrow[i] + 1][nd];
        e22d = dird[t->primda[i]][2][nd] - dird[t->primdb[i]][2][nd];
        l32d = lambdad[t->primrow[i] + 2][nd];
        c30d = e21d * l32 + e21 * l32d - (e22d * l31 + e22 * l31d);
        c31d = e22d * l30 + e22 * l30d - (e20d * l32 + e20 * l32d);
        c32d = e20d * l31 + e20 * l31d - (e21d * l30 + e21 * l30d);
        Fd[c][3][nd] += c30d;
        Fd[c][4][nd] += c31d;
        Fd[c][5][nd] += c32d;
      }
    }
  }
}

/* what a joint exerts on its body, about the joint point: - FS, which is about P */
void maggi_reactions_dv(const maggi_topo *t, const double x[restrict t->nbody + 1][3],
                        const double xd[restrict t->nbody + 1][3][MAGGI_NDIR],
                        const double FS[restrict t->nbody + 1][6],
                        const double FSd[restrict t->nbody + 1][6][MAGGI_NDIR],
                        double wrench[restrict t->nbody][6],
                        double wrenchd[restrict t->nbody][6][MAGGI_NDIR], int nbdirs)
{
  int i, nd;
  double FS_i0, FS_i1, FS_i2, x_i0, x_i1, x_i2;

  (void)wrench;
  (void)nbdirs;
  for (i = 0; i < t->nbody; ++i) {
    FS_i0 = FS[i][0];
    FS_i1 = FS[i][1];
    FS_i2 = FS[i][2];
    x_i1 = x[i][1];
    x_i2 = x[i][2];
    x_i0 = x[i][0];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double FS_i0d, FS_i1d, FS_i2d, x_i0d, x_i1d, x_i2d;

      FS_i0d = FSd[i][0][nd];
      wrenchd[i][0][nd] = -FS_i0d;
      FS_i1d = FSd[i][1][nd];
      wrenchd[i][1][nd] = -FS_i1d;
      FS_i2d = FSd[i][2][nd];
      wrenchd[i][2][nd] = -FS_i2d;
      x_i1d = xd[i][1][nd];
      x_i2d = xd[i][2][nd];
      wrenchd[i][3][nd] = x_i1d * FS_i2 + x_i1 * FS_i2d - (x_i2d * FS_i1 + x_i2 * FS_i1d) -
          FSd[i][3][nd];
      x_i0d = xd[i][0][nd];
      wrenchd[i][4][nd] = x_i2d * FS_i0 + x_i2 * FS_i0d - (x_i0d * FS_i2 + x_i0 * FS_i2d) -
          FSd[i][4][nd];
      wrenchd[i][5][nd] = x_i0d * FS_i1 + x_i0 * FS_i1d - (x_i1d * FS_i0 + x_i1 * FS_i0d) -
          FSd[i][5][nd];
    }
  }
}
