/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/loop.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

void maggi_loop_residual_dv(const maggi_topo *t, const double prim0[restrict t->nprim],
                            const double prim0d[restrict t->nprim][MAGGI_NDIR],
                            const double r[restrict t->npoint][3],
                            const double rd[restrict t->npoint][3][MAGGI_NDIR],
                            const double dir[restrict t->ndir][3],
                            const double dird[restrict t->ndir][3][MAGGI_NDIR],
                            double res[restrict t->nrow], double resd[restrict t->nrow][MAGGI_NDIR],
                            int nbdirs)
{
  int i, nd;
  double e0, e1, e2, prim0_i, t2, t2inv;
  double e0d[MAGGI_NDIR], e1d[MAGGI_NDIR], e2d[MAGGI_NDIR];

  (void)nbdirs;
  for (i = 0; i < t->nprim; ++i) {
    e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
    e1 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
    e2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      e0d[nd] = rd[t->primpa[i]][0][nd] - rd[t->primpb[i]][0][nd];
      e1d[nd] = rd[t->primpa[i]][1][nd] - rd[t->primpb[i]][1][nd];
      e2d[nd] = rd[t->primpa[i]][2][nd] - rd[t->primpb[i]][2][nd];
    }
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        resd[t->primrow[i]][nd] = e0d[nd];
        resd[t->primrow[i] + 1][nd] = e1d[nd];
        resd[t->primrow[i] + 2][nd] = e2d[nd];
      }
    } else if (t->primkind[i] == MAGGI_PRIM_AXIS) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        resd[t->primrow[i]][nd] = dird[t->primda[i]][0][nd] - dird[t->primdb[i]][0][nd];
        resd[t->primrow[i] + 1][nd] = dird[t->primda[i]][1][nd] - dird[t->primdb[i]][1][nd];
        resd[t->primrow[i] + 2][nd] = dird[t->primda[i]][2][nd] - dird[t->primdb[i]][2][nd];
      }
    } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        resd[t->primrow[i]][nd] = dird[t->primda[i]][0][nd] * dir[t->primdb[i]][0] +
            dir[t->primda[i]][0] * dird[t->primdb[i]][0][nd] + (dird[t->primda[i]][1][nd] *
            dir[t->primdb[i]][1] + dir[t->primda[i]][1] * dird[t->primdb[i]][1][nd]) +
            (dird[t->primda[i]][2][nd] * dir[t->primdb[i]][2] + dir[t->primda[i]][2] *
            dird[t->primdb[i]][2][nd]) - prim0d[i][nd];
      }
    } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        resd[t->primrow[i]][nd] = e0d[nd] * dir[t->primdb[i]][0] + e0 * dird[t->primdb[i]][0][nd] +
            (e1d[nd] * dir[t->primdb[i]][1] + e1 * dird[t->primdb[i]][1][nd]) + (e2d[nd] *
            dir[t->primdb[i]][2] + e2 * dird[t->primdb[i]][2][nd]);
      }
    } else {
      prim0_i = prim0[i];
      t2 = 2.0 * prim0_i;
      t2inv = 1.0 / t2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double prim0_id, t2d;

        prim0_id = prim0d[i][nd];
        t2d = 2.0 * prim0_id;
        resd[t->primrow[i]][nd] = (e0d[nd] * e0 + e0 * e0d[nd] + (e1d[nd] * e1 + e1 * e1d[nd]) +
            (e2d[nd] * e2 + e2 * e2d[nd]) - (prim0_id * prim0_i + prim0_i * prim0_id) -
            res[t->primrow[i]] * t2d) * t2inv;
      }
    }
  }
}

/* entries of the blocks of Phi_d; what the plan does not list is zero */
void maggi_loop_entries_dv(const maggi_topo *t, const double prim0[restrict t->nprim],
                           const double prim0d[restrict t->nprim][MAGGI_NDIR],
                           const double r[restrict t->npoint][3],
                           const double rd[restrict t->npoint][3][MAGGI_NDIR],
                           const double dir[restrict t->ndir][3],
                           const double dird[restrict t->ndir][3][MAGGI_NDIR],
                           const double b[restrict t->nbody][6],
                           const double bd[restrict t->nbody][6][MAGGI_NDIR],
                           double phi[restrict t->nphi], double phid[restrict t->nphi][MAGGI_NDIR],
                           int nbdirs)
{
  int i, k, nd;
  double b_i3, b_i3_2, b_i3_3, b_i3_4, b_i3_5, b_i4, b_i4_2, b_i4_3, b_i4_4, b_i4_5, b_i5, b_i5_2,
      b_i5_3, b_i5_4, b_i5_5, c0_2, c0_3, c1_2, c1_3, c2_2, c2_3, dir_k0, dir_k0_2, dir_k0_3,
      dir_k0_4, dir_k1, dir_k1_2, dir_k1_3, dir_k1_4, dir_k2, dir_k2_2, dir_k2_3, dir_k2_4, inv,
      j0_2, j0_3, j1_2, j1_3, j2_2, j2_3, r_k0, r_k0_2, r_k0_3, r_k0_4, r_k0_5, r_k1, r_k1_2,
      r_k1_3, r_k1_4, r_k1_5, r_k2, r_k2_2, r_k2_3, r_k2_4, r_k2_5, s, t2, w0, w1, w2;
  double c0d[MAGGI_NDIR], c1d[MAGGI_NDIR], c2d[MAGGI_NDIR], e0d[MAGGI_NDIR], e1d[MAGGI_NDIR],
      e2d[MAGGI_NDIR], j0_3d[MAGGI_NDIR], j0d[MAGGI_NDIR], j1_3d[MAGGI_NDIR], j1d[MAGGI_NDIR],
      j2_3d[MAGGI_NDIR], j2d[MAGGI_NDIR], w0d[MAGGI_NDIR], w1d[MAGGI_NDIR], w2d[MAGGI_NDIR];

  (void)phi;
  (void)nbdirs;
  for (i = 0; i < t->nent; ++i) {
    k = t->entprim[i];
    s = t->entside[i] == 0 ? 1.0 : -1.0;
    w0 = b[t->qbody[t->entq[i]]][3];
    w1 = b[t->qbody[t->entq[i]]][4];
    w2 = b[t->qbody[t->entq[i]]][5];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      w0d[nd] = bd[t->qbody[t->entq[i]]][3][nd];
      w1d[nd] = bd[t->qbody[t->entq[i]]][4][nd];
      w2d[nd] = bd[t->qbody[t->entq[i]]][5][nd];
    }
    if (t->primkind[k] == MAGGI_PRIM_POINT) {
      if (t->entside[i] == 0) {
        b_i4 = b[t->qbody[t->entq[i]]][4];
        r_k2 = r[t->primpa[k]][2];
        b_i5 = b[t->qbody[t->entq[i]]][5];
        r_k1 = r[t->primpa[k]][1];
        r_k0 = r[t->primpa[k]][0];
        b_i3 = b[t->qbody[t->entq[i]]][3];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double b_i3d, b_i4d, b_i5d, r_k0d, r_k1d, r_k2d;

          b_i4d = bd[t->qbody[t->entq[i]]][4][nd];
          r_k2d = rd[t->primpa[k]][2][nd];
          b_i5d = bd[t->qbody[t->entq[i]]][5][nd];
          r_k1d = rd[t->primpa[k]][1][nd];
          j0d[nd] = bd[t->qbody[t->entq[i]]][0][nd] + (b_i4d * r_k2 + b_i4 * r_k2d) - (b_i5d * r_k1
              + b_i5 * r_k1d);
          r_k0d = rd[t->primpa[k]][0][nd];
          b_i3d = bd[t->qbody[t->entq[i]]][3][nd];
          j1d[nd] = bd[t->qbody[t->entq[i]]][1][nd] + (b_i5d * r_k0 + b_i5 * r_k0d) - (b_i3d * r_k2
              + b_i3 * r_k2d);
          j2d[nd] = bd[t->qbody[t->entq[i]]][2][nd] + (b_i3d * r_k1 + b_i3 * r_k1d) - (b_i4d * r_k0
              + b_i4 * r_k0d);
        }
      } else {
        b_i4_2 = b[t->qbody[t->entq[i]]][4];
        r_k2_2 = r[t->primpb[k]][2];
        b_i5_2 = b[t->qbody[t->entq[i]]][5];
        r_k1_2 = r[t->primpb[k]][1];
        r_k0_2 = r[t->primpb[k]][0];
        b_i3_2 = b[t->qbody[t->entq[i]]][3];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double b_i3_2d, b_i4_2d, b_i5_2d, r_k0_2d, r_k1_2d, r_k2_2d;

          b_i4_2d = bd[t->qbody[t->entq[i]]][4][nd];
          r_k2_2d = rd[t->primpb[k]][2][nd];
          b_i5_2d = bd[t->qbody[t->entq[i]]][5][nd];
          r_k1_2d = rd[t->primpb[k]][1][nd];
          j0d[nd] = bd[t->qbody[t->entq[i]]][0][nd] + (b_i4_2d * r_k2_2 + b_i4_2 * r_k2_2d) -
              (b_i5_2d * r_k1_2 + b_i5_2 * r_k1_2d);
          r_k0_2d = rd[t->primpb[k]][0][nd];
          b_i3_2d = bd[t->qbody[t->entq[i]]][3][nd];
          j1d[nd] = bd[t->qbody[t->entq[i]]][1][nd] + (b_i5_2d * r_k0_2 + b_i5_2 * r_k0_2d) -
              (b_i3_2d * r_k2_2 + b_i3_2 * r_k2_2d);
          j2d[nd] = bd[t->qbody[t->entq[i]]][2][nd] + (b_i3_2d * r_k1_2 + b_i3_2 * r_k1_2d) -
              (b_i4_2d * r_k0_2 + b_i4_2 * r_k0_2d);
        }
      }
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        e0d[nd] = s * j0d[nd];
        e1d[nd] = s * j1d[nd];
        e2d[nd] = s * j2d[nd];
      }
    } else if (t->primkind[k] == MAGGI_PRIM_AXIS) {
      if (t->entside[i] == 0) {
        dir_k2 = dir[t->primda[k]][2];
        dir_k1 = dir[t->primda[k]][1];
        dir_k0 = dir[t->primda[k]][0];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double dir_k0d, dir_k1d, dir_k2d;

          dir_k2d = dird[t->primda[k]][2][nd];
          dir_k1d = dird[t->primda[k]][1][nd];
          c0d[nd] = w1d[nd] * dir_k2 + w1 * dir_k2d - (w2d[nd] * dir_k1 + w2 * dir_k1d);
          dir_k0d = dird[t->primda[k]][0][nd];
          c1d[nd] = w2d[nd] * dir_k0 + w2 * dir_k0d - (w0d[nd] * dir_k2 + w0 * dir_k2d);
          c2d[nd] = w0d[nd] * dir_k1 + w0 * dir_k1d - (w1d[nd] * dir_k0 + w1 * dir_k0d);
        }
      } else {
        dir_k2_2 = dir[t->primdb[k]][2];
        dir_k1_2 = dir[t->primdb[k]][1];
        dir_k0_2 = dir[t->primdb[k]][0];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double dir_k0_2d, dir_k1_2d, dir_k2_2d;

          dir_k2_2d = dird[t->primdb[k]][2][nd];
          dir_k1_2d = dird[t->primdb[k]][1][nd];
          c0d[nd] = w1d[nd] * dir_k2_2 + w1 * dir_k2_2d - (w2d[nd] * dir_k1_2 + w2 * dir_k1_2d);
          dir_k0_2d = dird[t->primdb[k]][0][nd];
          c1d[nd] = w2d[nd] * dir_k0_2 + w2 * dir_k0_2d - (w0d[nd] * dir_k2_2 + w0 * dir_k2_2d);
          c2d[nd] = w0d[nd] * dir_k1_2 + w0 * dir_k1_2d - (w1d[nd] * dir_k0_2 + w1 * dir_k0_2d);
        }
      }
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        e0d[nd] = s * c0d[nd];
        e1d[nd] = s * c1d[nd];
        e2d[nd] = s * c2d[nd];
      }
    } else if (t->primkind[k] == MAGGI_PRIM_ANGLE) {
      dir_k1_3 = dir[t->primda[k]][1];
      dir_k2_3 = dir[t->primdb[k]][2];
      dir_k2_4 = dir[t->primda[k]][2];
      dir_k1_4 = dir[t->primdb[k]][1];
      c0_2 = dir_k1_3 * dir_k2_3 - dir_k2_4 * dir_k1_4;
      dir_k0_3 = dir[t->primdb[k]][0];
      dir_k0_4 = dir[t->primda[k]][0];
      c1_2 = dir_k2_4 * dir_k0_3 - dir_k0_4 * dir_k2_3;
      c2_2 = dir_k0_4 * dir_k1_4 - dir_k1_3 * dir_k0_3;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double c0_2d, c1_2d, c2_2d, dir_k0_3d, dir_k0_4d, dir_k1_3d, dir_k1_4d, dir_k2_3d,
            dir_k2_4d;

        dir_k1_3d = dird[t->primda[k]][1][nd];
        dir_k2_3d = dird[t->primdb[k]][2][nd];
        dir_k2_4d = dird[t->primda[k]][2][nd];
        dir_k1_4d = dird[t->primdb[k]][1][nd];
        c0_2d = dir_k1_3d * dir_k2_3 + dir_k1_3 * dir_k2_3d - (dir_k2_4d * dir_k1_4 + dir_k2_4 *
            dir_k1_4d);
        dir_k0_3d = dird[t->primdb[k]][0][nd];
        dir_k0_4d = dird[t->primda[k]][0][nd];
        c1_2d = dir_k2_4d * dir_k0_3 + dir_k2_4 * dir_k0_3d - (dir_k0_4d * dir_k2_3 + dir_k0_4 *
            dir_k2_3d);
        c2_2d = dir_k0_4d * dir_k1_4 + dir_k0_4 * dir_k1_4d - (dir_k1_3d * dir_k0_3 + dir_k1_3 *
            dir_k0_3d);
        e0d[nd] = s * (w0d[nd] * c0_2 + w0 * c0_2d + (w1d[nd] * c1_2 + w1 * c1_2d) + (w2d[nd] * c2_2
            + w2 * c2_2d));
        e1d[nd] = 0.0;
        e2d[nd] = 0.0;
      }
    } else if (t->primkind[k] == MAGGI_PRIM_PLANE) {
      b_i4_3 = b[t->qbody[t->entq[i]]][4];
      r_k2_3 = r[t->primpa[k]][2];
      b_i5_3 = b[t->qbody[t->entq[i]]][5];
      r_k1_3 = r[t->primpa[k]][1];
      j0_2 = b[t->qbody[t->entq[i]]][0] + b_i4_3 * r_k2_3 - b_i5_3 * r_k1_3;
      r_k0_3 = r[t->primpa[k]][0];
      b_i3_3 = b[t->qbody[t->entq[i]]][3];
      j1_2 = b[t->qbody[t->entq[i]]][1] + b_i5_3 * r_k0_3 - b_i3_3 * r_k2_3;
      j2_2 = b[t->qbody[t->entq[i]]][2] + b_i3_3 * r_k1_3 - b_i4_3 * r_k0_3;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double b_i3_3d, b_i4_3d, b_i5_3d, j0_2d, j1_2d, j2_2d, r_k0_3d, r_k1_3d, r_k2_3d;

        b_i4_3d = bd[t->qbody[t->entq[i]]][4][nd];
        r_k2_3d = rd[t->primpa[k]][2][nd];
        b_i5_3d = bd[t->qbody[t->entq[i]]][5][nd];
        r_k1_3d = rd[t->primpa[k]][1][nd];
        j0_2d = bd[t->qbody[t->entq[i]]][0][nd] + (b_i4_3d * r_k2_3 + b_i4_3 * r_k2_3d) - (b_i5_3d *
            r_k1_3 + b_i5_3 * r_k1_3d);
        r_k0_3d = rd[t->primpa[k]][0][nd];
        b_i3_3d = bd[t->qbody[t->entq[i]]][3][nd];
        j1_2d = bd[t->qbody[t->entq[i]]][1][nd] + (b_i5_3d * r_k0_3 + b_i5_3 * r_k0_3d) - (b_i3_3d *
            r_k2_3 + b_i3_3 * r_k2_3d);
        j2_2d = bd[t->qbody[t->entq[i]]][2][nd] + (b_i3_3d * r_k1_3 + b_i3_3 * r_k1_3d) - (b_i4_3d *
            r_k0_3 + b_i4_3 * r_k0_3d);
        e0d[nd] = s * (dird[t->primdb[k]][0][nd] * j0_2 + dir[t->primdb[k]][0] * j0_2d +
            (dird[t->primdb[k]][1][nd] * j1_2 + dir[t->primdb[k]][1] * j1_2d) +
            (dird[t->primdb[k]][2][nd] * j2_2 + dir[t->primdb[k]][2] * j2_2d));
        e1d[nd] = 0.0;
        e2d[nd] = 0.0;
      }
    } else {
      if (t->entside[i] == 0) {
        b_i4_4 = b[t->qbody[t->entq[i]]][4];
        r_k2_4 = r[t->primpa[k]][2];
        b_i5_4 = b[t->qbody[t->entq[i]]][5];
        r_k1_4 = r[t->primpa[k]][1];
        j0_3 = b[t->qbody[t->entq[i]]][0] + b_i4_4 * r_k2_4 - b_i5_4 * r_k1_4;
        r_k0_4 = r[t->primpa[k]][0];
        b_i3_4 = b[t->qbody[t->entq[i]]][3];
        j1_3 = b[t->qbody[t->entq[i]]][1] + b_i5_4 * r_k0_4 - b_i3_4 * r_k2_4;
        j2_3 = b[t->qbody[t->entq[i]]][2] + b_i3_4 * r_k1_4 - b_i4_4 * r_k0_4;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double b_i3_4d, b_i4_4d, b_i5_4d, r_k0_4d, r_k1_4d, r_k2_4d;

          b_i4_4d = bd[t->qbody[t->entq[i]]][4][nd];
          r_k2_4d = rd[t->primpa[k]][2][nd];
          b_i5_4d = bd[t->qbody[t->entq[i]]][5][nd];
          r_k1_4d = rd[t->primpa[k]][1][nd];
          j0_3d[nd] = bd[t->qbody[t->entq[i]]][0][nd] + (b_i4_4d * r_k2_4 + b_i4_4 * r_k2_4d) -
              (b_i5_4d * r_k1_4 + b_i5_4 * r_k1_4d);
          r_k0_4d = rd[t->primpa[k]][0][nd];
          b_i3_4d = bd[t->qbody[t->entq[i]]][3][nd];
          j1_3d[nd] = bd[t->qbody[t->entq[i]]][1][nd] + (b_i5_4d * r_k0_4 + b_i5_4 * r_k0_4d) -
              (b_i3_4d * r_k2_4 + b_i3_4 * r_k2_4d);
          j2_3d[nd] = bd[t->qbody[t->entq[i]]][2][nd] + (b_i3_4d * r_k1_4 + b_i3_4 * r_k1_4d) -
              (b_i4_4d * r_k0_4 + b_i4_4 * r_k0_4d);
        }
      } else {
        b_i4_5 = b[t->qbody[t->entq[i]]][4];
        r_k2_5 = r[t->primpb[k]][2];
        b_i5_5 = b[t->qbody[t->entq[i]]][5];
        r_k1_5 = r[t->primpb[k]][1];
        j0_3 = b[t->qbody[t->entq[i]]][0] + b_i4_5 * r_k2_5 - b_i5_5 * r_k1_5;
        r_k0_5 = r[t->primpb[k]][0];
        b_i3_5 = b[t->qbody[t->entq[i]]][3];
        j1_3 = b[t->qbody[t->entq[i]]][1] + b_i5_5 * r_k0_5 - b_i3_5 * r_k2_5;
        j2_3 = b[t->qbody[t->entq[i]]][2] + b_i3_5 * r_k1_5 - b_i4_5 * r_k0_5;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double b_i3_5d, b_i4_5d, b_i5_5d, r_k0_5d, r_k1_5d, r_k2_5d;

          b_i4_5d = bd[t->qbody[t->entq[i]]][4][nd];
          r_k2_5d = rd[t->primpb[k]][2][nd];
          b_i5_5d = bd[t->qbody[t->entq[i]]][5][nd];
          r_k1_5d = rd[t->primpb[k]][1][nd];
          j0_3d[nd] = bd[t->qbody[t->entq[i]]][0][nd] + (b_i4_5d * r_k2_5 + b_i4_5 * r_k2_5d) -
              (b_i5_5d * r_k1_5 + b_i5_5 * r_k1_5d);
          r_k0_5d = rd[t->primpb[k]][0][nd];
          b_i3_5d = bd[t->qbody[t->entq[i]]][3][nd];
          j1_3d[nd] = bd[t->qbody[t->entq[i]]][1][nd] + (b_i5_5d * r_k0_5 + b_i5_5 * r_k0_5d) -
              (b_i3_5d * r_k2_5 + b_i3_5 * r_k2_5d);
          j2_3d[nd] = bd[t->qbody[t->entq[i]]][2][nd] + (b_i3_5d * r_k1_5 + b_i3_5 * r_k1_5d) -
              (b_i4_5d * r_k0_5 + b_i4_5 * r_k0_5d);
        }
      }
      c0_3 = r[t->primpa[k]][0] - r[t->primpb[k]][0];
      c1_3 = r[t->primpa[k]][1] - r[t->primpb[k]][1];
      c2_3 = r[t->primpa[k]][2] - r[t->primpb[k]][2];
      t2 = s * (c0_3 * j0_3 + c1_3 * j1_3 + c2_3 * j2_3) / prim0[k];
      inv = 1.0 / prim0[k];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double c0_3d, c1_3d, c2_3d, t2d;

        c0_3d = rd[t->primpa[k]][0][nd] - rd[t->primpb[k]][0][nd];
        c1_3d = rd[t->primpa[k]][1][nd] - rd[t->primpb[k]][1][nd];
        c2_3d = rd[t->primpa[k]][2][nd] - rd[t->primpb[k]][2][nd];
        t2d = (s * (c0_3d * j0_3 + c0_3 * j0_3d[nd] + (c1_3d * j1_3 + c1_3 * j1_3d[nd]) + (c2_3d *
            j2_3 + c2_3 * j2_3d[nd])) - t2 * prim0d[k][nd]) * inv;
        e0d[nd] = t2d;
        e1d[nd] = 0.0;
        e2d[nd] = 0.0;
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      phid[t->entadr[i]][nd] = e0d[nd];
    }
    if (t->primkind[k] == MAGGI_PRIM_POINT || t->primkind[k] == MAGGI_PRIM_AXIS) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        phid[t->entadr[i] + t->entstep[i]][nd] = e1d[nd];
        phid[t->entadr[i] + 2 * t->entstep[i]][nd] = e2d[nd];
      }
    }
  }
}

void maggi_loop_rates_dv(const maggi_topo *t, const double prim0[restrict t->nprim],
                         const double prim0d[restrict t->nprim][MAGGI_NDIR],
                         const double r[restrict t->npoint][3],
                         const double rd[restrict t->npoint][3][MAGGI_NDIR],
                         const double dir[restrict t->ndir][3],
                         const double dird[restrict t->ndir][3][MAGGI_NDIR],
                         const double rv[restrict t->npoint][3],
                         const double rvd[restrict t->npoint][3][MAGGI_NDIR],
                         const double Z[restrict t->nbody + 1][6],
                         const double Zd[restrict t->nbody + 1][6][MAGGI_NDIR],
                         double rate[restrict t->nrow], double rated[restrict t->nrow][MAGGI_NDIR],
                         int nbdirs)
{
  int c, i, i2, nd;
  double da10, da11, da12, db10, db11, db12, dir_i0, dir_i0_2, dir_i1, dir_i1_2, dir_i2, dir_i2_2,
      e0, e1_3, e20, e21, e22, e2_2, e30, e31, e32, ev0, ev1, ev2, inv, s, t2, w0, w1, w20, w21,
      w22, w2_2, w30, w31, w32, w40, w41, w42;
  double da10d[MAGGI_NDIR], da11d[MAGGI_NDIR], da12d[MAGGI_NDIR], db10d[MAGGI_NDIR],
      db11d[MAGGI_NDIR], db12d[MAGGI_NDIR], e0d[MAGGI_NDIR], e1_3d[MAGGI_NDIR], e2_2d[MAGGI_NDIR],
      ev0d[MAGGI_NDIR], ev1d[MAGGI_NDIR], ev2d[MAGGI_NDIR];

  (void)rate;
  (void)nbdirs;
  for (i = 0; i < t->nprim; ++i) {
    e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
    ev0 = rv[t->primpa[i]][0] - rv[t->primpb[i]][0];
    e1_3 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
    ev1 = rv[t->primpa[i]][1] - rv[t->primpb[i]][1];
    e2_2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
    ev2 = rv[t->primpa[i]][2] - rv[t->primpb[i]][2];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      /* the first derivative of the equation */
      e0d[nd] = rd[t->primpa[i]][0][nd] - rd[t->primpb[i]][0][nd];
      ev0d[nd] = rvd[t->primpa[i]][0][nd] - rvd[t->primpb[i]][0][nd];
      e1_3d[nd] = rd[t->primpa[i]][1][nd] - rd[t->primpb[i]][1][nd];
      ev1d[nd] = rvd[t->primpa[i]][1][nd] - rvd[t->primpb[i]][1][nd];
      e2_2d[nd] = rd[t->primpa[i]][2][nd] - rd[t->primpb[i]][2][nd];
      ev2d[nd] = rvd[t->primpa[i]][2][nd] - rvd[t->primpb[i]][2][nd];
    }
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        rated[t->primrow[i]][nd] = ev0d[nd];
        rated[t->primrow[i] + 1][nd] = ev1d[nd];
        rated[t->primrow[i] + 2][nd] = ev2d[nd];
      }
    } else if (t->primkind[i] == MAGGI_PRIM_ROD) {
      t2 = (ev0 * e0 + ev1 * e1_3 + ev2 * e2_2) / prim0[i];
      inv = 1.0 / prim0[i];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t2d;

        t2d = (ev0d[nd] * e0 + ev0 * e0d[nd] + (ev1d[nd] * e1_3 + ev1 * e1_3d[nd]) + (ev2d[nd] *
            e2_2 + ev2 * e2_2d[nd]) - t2 * prim0d[i][nd]) * inv;
        rated[t->primrow[i]][nd] = t2d;
      }
    } else {
      w0 = Z[t->primba[i]][3];
      w1 = Z[t->primba[i]][4];
      w2_2 = Z[t->primba[i]][5];
      dir_i2 = dir[t->primda[i]][2];
      dir_i1 = dir[t->primda[i]][1];
      da10 = w1 * dir_i2 - w2_2 * dir_i1;
      dir_i0 = dir[t->primda[i]][0];
      da11 = w2_2 * dir_i0 - w0 * dir_i2;
      da12 = w0 * dir_i1 - w1 * dir_i0;
      w20 = Z[t->primbb[i]][3];
      w21 = Z[t->primbb[i]][4];
      w22 = Z[t->primbb[i]][5];
      dir_i2_2 = dir[t->primdb[i]][2];
      dir_i1_2 = dir[t->primdb[i]][1];
      db10 = w21 * dir_i2_2 - w22 * dir_i1_2;
      dir_i0_2 = dir[t->primdb[i]][0];
      db11 = w22 * dir_i0_2 - w20 * dir_i2_2;
      db12 = w20 * dir_i1_2 - w21 * dir_i0_2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double dir_i0_2d, dir_i0d, dir_i1_2d, dir_i1d, dir_i2_2d, dir_i2d, w0d, w1d, w20d, w21d,
            w22d, w2_2d;

        /* u' = w × u */
        w0d = Zd[t->primba[i]][3][nd];
        w1d = Zd[t->primba[i]][4][nd];
        w2_2d = Zd[t->primba[i]][5][nd];
        dir_i2d = dird[t->primda[i]][2][nd];
        dir_i1d = dird[t->primda[i]][1][nd];
        da10d[nd] = w1d * dir_i2 + w1 * dir_i2d - (w2_2d * dir_i1 + w2_2 * dir_i1d);
        dir_i0d = dird[t->primda[i]][0][nd];
        da11d[nd] = w2_2d * dir_i0 + w2_2 * dir_i0d - (w0d * dir_i2 + w0 * dir_i2d);
        da12d[nd] = w0d * dir_i1 + w0 * dir_i1d - (w1d * dir_i0 + w1 * dir_i0d);
        /* u' = w × u */
        w20d = Zd[t->primbb[i]][3][nd];
        w21d = Zd[t->primbb[i]][4][nd];
        w22d = Zd[t->primbb[i]][5][nd];
        dir_i2_2d = dird[t->primdb[i]][2][nd];
        dir_i1_2d = dird[t->primdb[i]][1][nd];
        db10d[nd] = w21d * dir_i2_2 + w21 * dir_i2_2d - (w22d * dir_i1_2 + w22 * dir_i1_2d);
        dir_i0_2d = dird[t->primdb[i]][0][nd];
        db11d[nd] = w22d * dir_i0_2 + w22 * dir_i0_2d - (w20d * dir_i2_2 + w20 * dir_i2_2d);
        db12d[nd] = w20d * dir_i1_2 + w20 * dir_i1_2d - (w21d * dir_i0_2 + w21 * dir_i0_2d);
      }
      if (t->primkind[i] == MAGGI_PRIM_AXIS) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          rated[t->primrow[i]][nd] = da10d[nd] - db10d[nd];
          rated[t->primrow[i] + 1][nd] = da11d[nd] - db11d[nd];
          rated[t->primrow[i] + 2][nd] = da12d[nd] - db12d[nd];
        }
      } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          rated[t->primrow[i]][nd] = da10d[nd] * dir[t->primdb[i]][0] + da10 *
              dird[t->primdb[i]][0][nd] + (da11d[nd] * dir[t->primdb[i]][1] + da11 *
              dird[t->primdb[i]][1][nd]) + (da12d[nd] * dir[t->primdb[i]][2] + da12 *
              dird[t->primdb[i]][2][nd]) + (dird[t->primda[i]][0][nd] * db10 + dir[t->primda[i]][0]
              * db10d[nd] + (dird[t->primda[i]][1][nd] * db11 + dir[t->primda[i]][1] * db11d[nd]) +
              (dird[t->primda[i]][2][nd] * db12 + dir[t->primda[i]][2] * db12d[nd]));
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          rated[t->primrow[i]][nd] = ev0d[nd] * dir[t->primdb[i]][0] + ev0 *
              dird[t->primdb[i]][0][nd] + (ev1d[nd] * dir[t->primdb[i]][1] + ev1 *
              dird[t->primdb[i]][1][nd]) + (ev2d[nd] * dir[t->primdb[i]][2] + ev2 *
              dird[t->primdb[i]][2][nd]) + (e0d[nd] * db10 + e0 * db10d[nd] + (e1_3d[nd] * db11 +
              e1_3 * db11d[nd]) + (e2_2d[nd] * db12 + e2_2 * db12d[nd]));
        }
      }
    }
  }
  s = -1.0;
  /* what turning with the bodies that carry both sides does to open points and axes */
  for (i2 = 0; i2 < t->nprim; ++i2) {
    c = t->loopcommon[t->primloop[i2]];
    if (c < t->nbody && t->primkind[i2] == MAGGI_PRIM_POINT) {
      e20 = r[t->primpa[i2]][0] - r[t->primpb[i2]][0];
      e21 = r[t->primpa[i2]][1] - r[t->primpb[i2]][1];
      e22 = r[t->primpa[i2]][2] - r[t->primpb[i2]][2];
      w30 = Z[c][3];
      w31 = Z[c][4];
      w32 = Z[c][5];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e10d, e11d, e12d, e20d, e21d, e22d, w30d, w31d, w32d;

        /* y += s w × (a - b) */
        e20d = rd[t->primpa[i2]][0][nd] - rd[t->primpb[i2]][0][nd];
        e21d = rd[t->primpa[i2]][1][nd] - rd[t->primpb[i2]][1][nd];
        e22d = rd[t->primpa[i2]][2][nd] - rd[t->primpb[i2]][2][nd];
        /* u' = w × u */
        w30d = Zd[c][3][nd];
        w31d = Zd[c][4][nd];
        w32d = Zd[c][5][nd];
        e10d = w31d * e22 + w31 * e22d - (w32d * e21 + w32 * e21d);
        e11d = w32d * e20 + w32 * e20d - (w30d * e22 + w30 * e22d);
        e12d = w30d * e21 + w30 * e21d - (w31d * e20 + w31 * e20d);
        rated[t->primrow[i2]][nd] += s * e10d;
        rated[t->primrow[i2] + 1][nd] += s * e11d;
        rated[t->primrow[i2] + 2][nd] += s * e12d;
      }
    } else if (c < t->nbody && t->primkind[i2] == MAGGI_PRIM_AXIS) {
      e30 = dir[t->primda[i2]][0] - dir[t->primdb[i2]][0];
      e31 = dir[t->primda[i2]][1] - dir[t->primdb[i2]][1];
      e32 = dir[t->primda[i2]][2] - dir[t->primdb[i2]][2];
      w40 = Z[c][3];
      w41 = Z[c][4];
      w42 = Z[c][5];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e1_4d, e1_5d, e1_6d, e30d, e31d, e32d, w40d, w41d, w42d;

        /* y += s w × (a - b) */
        e30d = dird[t->primda[i2]][0][nd] - dird[t->primdb[i2]][0][nd];
        e31d = dird[t->primda[i2]][1][nd] - dird[t->primdb[i2]][1][nd];
        e32d = dird[t->primda[i2]][2][nd] - dird[t->primdb[i2]][2][nd];
        /* u' = w × u */
        w40d = Zd[c][3][nd];
        w41d = Zd[c][4][nd];
        w42d = Zd[c][5][nd];
        e1_4d = w41d * e32 + w41 * e32d - (w42d * e31 + w42 * e31d);
        e1_5d = w42d * e30 + w42 * e30d - (w40d * e32 + w40 * e32d);
        e1_6d = w40d * e31 + w40 * e31d - (w41d * e30 + w41 * e30d);
        rated[t->primrow[i2]][nd] += s * e1_4d;
        rated[t->primrow[i2] + 1][nd] += s * e1_5d;
        rated[t->primrow[i2] + 2][nd] += s * e1_6d;
      }
    }
  }
}

void maggi_loop_gamma_dv(const maggi_topo *t, const double prim0[restrict t->nprim],
                         const double prim0d[restrict t->nprim][MAGGI_NDIR],
                         const double r[restrict t->npoint][3],
                         const double rd[restrict t->npoint][3][MAGGI_NDIR],
                         const double dir[restrict t->ndir][3],
                         const double dird[restrict t->ndir][3][MAGGI_NDIR],
                         const double rv[restrict t->npoint][3],
                         const double rvd[restrict t->npoint][3][MAGGI_NDIR],
                         const double ra[restrict t->npoint][3],
                         const double rad[restrict t->npoint][3][MAGGI_NDIR],
                         const double Z[restrict t->nbody + 1][6],
                         const double Zd[restrict t->nbody + 1][6][MAGGI_NDIR],
                         const double Z0[restrict t->nbody + 1][6],
                         const double Z0d[restrict t->nbody + 1][6][MAGGI_NDIR],
                         double gam[restrict t->nrow], double gamd[restrict t->nrow][MAGGI_NDIR],
                         int nbdirs)
{
  int a, b, c3, i, i2, nd;
  double Z_a3, Z_a4, Z_a5, Z_b3, Z_b4, Z_b5, c0, c1, c20, c21, c22, c2_2, da10, da11, da12, da20,
      da21, da22, db10, db11, db12, db20, db21, db22, dir_i0, dir_i0_2, dir_i1, dir_i1_2, dir_i2,
      dir_i2_2, e0, e1_3, e20, e21, e22, e2_2, e30, e31, e32, e40, e41, e42, e50, e51, e52, ea0,
      ea1, ea2, ev0, ev1, ev2, inv, t2, w0, w1, w20, w21, w22, w2_2, w30, w31, w32, w40, w41, w42,
      w50, w51, w52, w60, w61, w62, w70, w71, w72, w80, w81, w82;
  double da10d[MAGGI_NDIR], da11d[MAGGI_NDIR], da12d[MAGGI_NDIR], da20d[MAGGI_NDIR],
      da21d[MAGGI_NDIR], da22d[MAGGI_NDIR], db10d[MAGGI_NDIR], db11d[MAGGI_NDIR], db12d[MAGGI_NDIR],
      db20d[MAGGI_NDIR], db21d[MAGGI_NDIR], db22d[MAGGI_NDIR], e0d[MAGGI_NDIR], e1_3d[MAGGI_NDIR],
      e2_2d[MAGGI_NDIR], ea0d[MAGGI_NDIR], ea1d[MAGGI_NDIR], ea2d[MAGGI_NDIR], ev0d[MAGGI_NDIR],
      ev1d[MAGGI_NDIR], ev2d[MAGGI_NDIR];

  (void)gam;
  (void)nbdirs;
  for (i = 0; i < t->nprim; ++i) {
    a = t->primba[i];
    b = t->primbb[i];
    e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
    ev0 = rv[t->primpa[i]][0] - rv[t->primpb[i]][0];
    ea0 = ra[t->primpa[i]][0] - ra[t->primpb[i]][0];
    e1_3 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
    ev1 = rv[t->primpa[i]][1] - rv[t->primpb[i]][1];
    ea1 = ra[t->primpa[i]][1] - ra[t->primpb[i]][1];
    e2_2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
    ev2 = rv[t->primpa[i]][2] - rv[t->primpb[i]][2];
    ea2 = ra[t->primpa[i]][2] - ra[t->primpb[i]][2];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      /* minus the second derivative of the equation with all joint accelerations zero */
      e0d[nd] = rd[t->primpa[i]][0][nd] - rd[t->primpb[i]][0][nd];
      ev0d[nd] = rvd[t->primpa[i]][0][nd] - rvd[t->primpb[i]][0][nd];
      ea0d[nd] = rad[t->primpa[i]][0][nd] - rad[t->primpb[i]][0][nd];
      e1_3d[nd] = rd[t->primpa[i]][1][nd] - rd[t->primpb[i]][1][nd];
      ev1d[nd] = rvd[t->primpa[i]][1][nd] - rvd[t->primpb[i]][1][nd];
      ea1d[nd] = rad[t->primpa[i]][1][nd] - rad[t->primpb[i]][1][nd];
      e2_2d[nd] = rd[t->primpa[i]][2][nd] - rd[t->primpb[i]][2][nd];
      ev2d[nd] = rvd[t->primpa[i]][2][nd] - rvd[t->primpb[i]][2][nd];
      ea2d[nd] = rad[t->primpa[i]][2][nd] - rad[t->primpb[i]][2][nd];
    }
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        gamd[t->primrow[i]][nd] = -ea0d[nd];
        gamd[t->primrow[i] + 1][nd] = -ea1d[nd];
        gamd[t->primrow[i] + 2][nd] = -ea2d[nd];
      }
    } else if (t->primkind[i] == MAGGI_PRIM_ROD) {
      t2 = -(ea0 * e0 + ea1 * e1_3 + ea2 * e2_2 + (ev0 * ev0 + ev1 * ev1 + ev2 * ev2)) / prim0[i];
      inv = 1.0 / prim0[i];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t2d;

        t2d = (-(ea0d[nd] * e0 + ea0 * e0d[nd] + (ea1d[nd] * e1_3 + ea1 * e1_3d[nd]) + (ea2d[nd] *
            e2_2 + ea2 * e2_2d[nd]) + (ev0d[nd] * ev0 + ev0 * ev0d[nd] + (ev1d[nd] * ev1 + ev1 *
            ev1d[nd]) + (ev2d[nd] * ev2 + ev2 * ev2d[nd]))) - t2 * prim0d[i][nd]) * inv;
        gamd[t->primrow[i]][nd] = t2d;
      }
    } else {
      Z_a3 = Z[a][3];
      w0 = Z_a3;
      Z_a4 = Z[a][4];
      w1 = Z_a4;
      Z_a5 = Z[a][5];
      w2_2 = Z_a5;
      dir_i2 = dir[t->primda[i]][2];
      dir_i1 = dir[t->primda[i]][1];
      da10 = w1 * dir_i2 - w2_2 * dir_i1;
      dir_i0 = dir[t->primda[i]][0];
      da11 = w2_2 * dir_i0 - w0 * dir_i2;
      da12 = w0 * dir_i1 - w1 * dir_i0;
      Z_b3 = Z[b][3];
      w20 = Z_b3;
      Z_b4 = Z[b][4];
      w21 = Z_b4;
      Z_b5 = Z[b][5];
      w22 = Z_b5;
      dir_i2_2 = dir[t->primdb[i]][2];
      dir_i1_2 = dir[t->primdb[i]][1];
      db10 = w21 * dir_i2_2 - w22 * dir_i1_2;
      dir_i0_2 = dir[t->primdb[i]][0];
      db11 = w22 * dir_i0_2 - w20 * dir_i2_2;
      db12 = w20 * dir_i1_2 - w21 * dir_i0_2;
      w30 = Z0[a][3];
      w31 = Z0[a][4];
      w32 = Z0[a][5];
      c0 = w31 * dir_i2 - w32 * dir_i1;
      c1 = w32 * dir_i0 - w30 * dir_i2;
      c2_2 = w30 * dir_i1 - w31 * dir_i0;
      w40 = Z_a3;
      w41 = Z_a4;
      w42 = Z_a5;
      e20 = w41 * da12 - w42 * da11;
      e21 = w42 * da10 - w40 * da12;
      e22 = w40 * da11 - w41 * da10;
      da20 = c0 + e20;
      da21 = c1 + e21;
      da22 = c2_2 + e22;
      w50 = Z0[b][3];
      w51 = Z0[b][4];
      w52 = Z0[b][5];
      c20 = w51 * dir_i2_2 - w52 * dir_i1_2;
      c21 = w52 * dir_i0_2 - w50 * dir_i2_2;
      c22 = w50 * dir_i1_2 - w51 * dir_i0_2;
      w60 = Z_b3;
      w61 = Z_b4;
      w62 = Z_b5;
      e30 = w61 * db12 - w62 * db11;
      e31 = w62 * db10 - w60 * db12;
      e32 = w60 * db11 - w61 * db10;
      db20 = c20 + e30;
      db21 = c21 + e31;
      db22 = c22 + e32;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double Z_a3d, Z_a4d, Z_a5d, Z_b3d, Z_b4d, Z_b5d, c0d, c1d, c20d, c21d, c22d, c2_2d,
            dir_i0_2d, dir_i0d, dir_i1_2d, dir_i1d, dir_i2_2d, dir_i2d, e20d, e21d, e22d, e30d,
            e31d, e32d, w0d, w1d, w20d, w21d, w22d, w2_2d, w30d, w31d, w32d, w40d, w41d, w42d, w50d,
            w51d, w52d, w60d, w61d, w62d;

        Z_a3d = Zd[a][3][nd];
        /* u' = w × u */
        w0d = Z_a3d;
        Z_a4d = Zd[a][4][nd];
        w1d = Z_a4d;
        Z_a5d = Zd[a][5][nd];
        w2_2d = Z_a5d;
        dir_i2d = dird[t->primda[i]][2][nd];
        dir_i1d = dird[t->primda[i]][1][nd];
        da10d[nd] = w1d * dir_i2 + w1 * dir_i2d - (w2_2d * dir_i1 + w2_2 * dir_i1d);
        dir_i0d = dird[t->primda[i]][0][nd];
        da11d[nd] = w2_2d * dir_i0 + w2_2 * dir_i0d - (w0d * dir_i2 + w0 * dir_i2d);
        da12d[nd] = w0d * dir_i1 + w0 * dir_i1d - (w1d * dir_i0 + w1 * dir_i0d);
        Z_b3d = Zd[b][3][nd];
        /* u' = w × u */
        w20d = Z_b3d;
        Z_b4d = Zd[b][4][nd];
        w21d = Z_b4d;
        Z_b5d = Zd[b][5][nd];
        w22d = Z_b5d;
        dir_i2_2d = dird[t->primdb[i]][2][nd];
        dir_i1_2d = dird[t->primdb[i]][1][nd];
        db10d[nd] = w21d * dir_i2_2 + w21 * dir_i2_2d - (w22d * dir_i1_2 + w22 * dir_i1_2d);
        dir_i0_2d = dird[t->primdb[i]][0][nd];
        db11d[nd] = w22d * dir_i0_2 + w22 * dir_i0_2d - (w20d * dir_i2_2 + w20 * dir_i2_2d);
        db12d[nd] = w20d * dir_i1_2 + w20 * dir_i1_2d - (w21d * dir_i0_2 + w21 * dir_i0_2d);
        /* u'' = w' × u + w × u'
         * u' = w × u */
        w30d = Z0d[a][3][nd];
        w31d = Z0d[a][4][nd];
        w32d = Z0d[a][5][nd];
        c0d = w31d * dir_i2 + w31 * dir_i2d - (w32d * dir_i1 + w32 * dir_i1d);
        c1d = w32d * dir_i0 + w32 * dir_i0d - (w30d * dir_i2 + w30 * dir_i2d);
        c2_2d = w30d * dir_i1 + w30 * dir_i1d - (w31d * dir_i0 + w31 * dir_i0d);
        /* u' = w × u */
        w40d = Z_a3d;
        w41d = Z_a4d;
        w42d = Z_a5d;
        e20d = w41d * da12 + w41 * da12d[nd] - (w42d * da11 + w42 * da11d[nd]);
        e21d = w42d * da10 + w42 * da10d[nd] - (w40d * da12 + w40 * da12d[nd]);
        e22d = w40d * da11 + w40 * da11d[nd] - (w41d * da10 + w41 * da10d[nd]);
        da20d[nd] = c0d + e20d;
        da21d[nd] = c1d + e21d;
        da22d[nd] = c2_2d + e22d;
        /* u'' = w' × u + w × u'
         * u' = w × u */
        w50d = Z0d[b][3][nd];
        w51d = Z0d[b][4][nd];
        w52d = Z0d[b][5][nd];
        c20d = w51d * dir_i2_2 + w51 * dir_i2_2d - (w52d * dir_i1_2 + w52 * dir_i1_2d);
        c21d = w52d * dir_i0_2 + w52 * dir_i0_2d - (w50d * dir_i2_2 + w50 * dir_i2_2d);
        c22d = w50d * dir_i1_2 + w50 * dir_i1_2d - (w51d * dir_i0_2 + w51 * dir_i0_2d);
        /* u' = w × u */
        w60d = Z_b3d;
        w61d = Z_b4d;
        w62d = Z_b5d;
        e30d = w61d * db12 + w61 * db12d[nd] - (w62d * db11 + w62 * db11d[nd]);
        e31d = w62d * db10 + w62 * db10d[nd] - (w60d * db12 + w60 * db12d[nd]);
        e32d = w60d * db11 + w60 * db11d[nd] - (w61d * db10 + w61 * db10d[nd]);
        db20d[nd] = c20d + e30d;
        db21d[nd] = c21d + e31d;
        db22d[nd] = c22d + e32d;
      }
      if (t->primkind[i] == MAGGI_PRIM_AXIS) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          gamd[t->primrow[i]][nd] = db20d[nd] - da20d[nd];
          gamd[t->primrow[i] + 1][nd] = db21d[nd] - da21d[nd];
          gamd[t->primrow[i] + 2][nd] = db22d[nd] - da22d[nd];
        }
      } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          gamd[t->primrow[i]][nd] = -(da20d[nd] * dir[t->primdb[i]][0] + da20 *
              dird[t->primdb[i]][0][nd] + (da21d[nd] * dir[t->primdb[i]][1] + da21 *
              dird[t->primdb[i]][1][nd]) + (da22d[nd] * dir[t->primdb[i]][2] + da22 *
              dird[t->primdb[i]][2][nd]) + 2.0 * (da10d[nd] * db10 + da10 * db10d[nd] + (da11d[nd] *
              db11 + da11 * db11d[nd]) + (da12d[nd] * db12 + da12 * db12d[nd])) +
              (dird[t->primda[i]][0][nd] * db20 + dir[t->primda[i]][0] * db20d[nd] +
              (dird[t->primda[i]][1][nd] * db21 + dir[t->primda[i]][1] * db21d[nd]) +
              (dird[t->primda[i]][2][nd] * db22 + dir[t->primda[i]][2] * db22d[nd])));
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          gamd[t->primrow[i]][nd] = -(ea0d[nd] * dir[t->primdb[i]][0] + ea0 *
              dird[t->primdb[i]][0][nd] + (ea1d[nd] * dir[t->primdb[i]][1] + ea1 *
              dird[t->primdb[i]][1][nd]) + (ea2d[nd] * dir[t->primdb[i]][2] + ea2 *
              dird[t->primdb[i]][2][nd]) + 2.0 * (ev0d[nd] * db10 + ev0 * db10d[nd] + (ev1d[nd] *
              db11 + ev1 * db11d[nd]) + (ev2d[nd] * db12 + ev2 * db12d[nd])) + (e0d[nd] * db20 + e0
              * db20d[nd] + (e1_3d[nd] * db21 + e1_3 * db21d[nd]) + (e2_2d[nd] * db22 + e2_2 *
              db22d[nd])));
        }
      }
    }
  }
  /* what turning with the bodies that carry both sides does to open points and axes */
  for (i2 = 0; i2 < t->nprim; ++i2) {
    c3 = t->loopcommon[t->primloop[i2]];
    if (c3 < t->nbody && t->primkind[i2] == MAGGI_PRIM_POINT) {
      e40 = r[t->primpa[i2]][0] - r[t->primpb[i2]][0];
      e41 = r[t->primpa[i2]][1] - r[t->primpb[i2]][1];
      e42 = r[t->primpa[i2]][2] - r[t->primpb[i2]][2];
      w70 = Z0[c3][3];
      w71 = Z0[c3][4];
      w72 = Z0[c3][5];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e10d, e11d, e12d, e40d, e41d, e42d, w70d, w71d, w72d;

        /* y += s w × (a - b) */
        e40d = rd[t->primpa[i2]][0][nd] - rd[t->primpb[i2]][0][nd];
        e41d = rd[t->primpa[i2]][1][nd] - rd[t->primpb[i2]][1][nd];
        e42d = rd[t->primpa[i2]][2][nd] - rd[t->primpb[i2]][2][nd];
        /* u' = w × u */
        w70d = Z0d[c3][3][nd];
        w71d = Z0d[c3][4][nd];
        w72d = Z0d[c3][5][nd];
        e10d = w71d * e42 + w71 * e42d - (w72d * e41 + w72 * e41d);
        e11d = w72d * e40 + w72 * e40d - (w70d * e42 + w70 * e42d);
        e12d = w70d * e41 + w70 * e41d - (w71d * e40 + w71 * e40d);
        gamd[t->primrow[i2]][nd] += e10d;
        gamd[t->primrow[i2] + 1][nd] += e11d;
        gamd[t->primrow[i2] + 2][nd] += e12d;
      }
    } else if (c3 < t->nbody && t->primkind[i2] == MAGGI_PRIM_AXIS) {
      e50 = dir[t->primda[i2]][0] - dir[t->primdb[i2]][0];
      e51 = dir[t->primda[i2]][1] - dir[t->primdb[i2]][1];
      e52 = dir[t->primda[i2]][2] - dir[t->primdb[i2]][2];
      w80 = Z0[c3][3];
      w81 = Z0[c3][4];
      w82 = Z0[c3][5];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e1_4d, e1_5d, e1_6d, e50d, e51d, e52d, w80d, w81d, w82d;

        /* y += s w × (a - b) */
        e50d = dird[t->primda[i2]][0][nd] - dird[t->primdb[i2]][0][nd];
        e51d = dird[t->primda[i2]][1][nd] - dird[t->primdb[i2]][1][nd];
        e52d = dird[t->primda[i2]][2][nd] - dird[t->primdb[i2]][2][nd];
        /* u' = w × u */
        w80d = Z0d[c3][3][nd];
        w81d = Z0d[c3][4][nd];
        w82d = Z0d[c3][5][nd];
        e1_4d = w81d * e52 + w81 * e52d - (w82d * e51 + w82 * e51d);
        e1_5d = w82d * e50 + w82 * e50d - (w80d * e52 + w80 * e52d);
        e1_6d = w80d * e51 + w80 * e51d - (w81d * e50 + w81 * e50d);
        gamd[t->primrow[i2]][nd] += e1_4d;
        gamd[t->primrow[i2] + 1][nd] += e1_5d;
        gamd[t->primrow[i2] + 2][nd] += e1_6d;
      }
    }
  }
}
