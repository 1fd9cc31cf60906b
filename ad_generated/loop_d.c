/* Tangent of core/kernel/loop.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

void maggi_loop_residual_d(const maggi_topo *t, const double prim0[restrict t->nprim],
                           const double prim0d[restrict t->nprim],
                           const double r[restrict t->npoint][3],
                           const double rd[restrict t->npoint][3],
                           const double dir[restrict t->ndir][3],
                           const double dird[restrict t->ndir][3], double res[restrict t->nrow],
                           double resd[restrict t->nrow])
{
  int i;
  double e0, e0d, e1, e1d, e2, e2d, prim0_i, prim0_id, t2, t2d, t2inv;

  for (i = 0; i < t->nprim; ++i) {
    e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
    e0d = rd[t->primpa[i]][0] - rd[t->primpb[i]][0];
    e1 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
    e1d = rd[t->primpa[i]][1] - rd[t->primpb[i]][1];
    e2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
    e2d = rd[t->primpa[i]][2] - rd[t->primpb[i]][2];
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
      resd[t->primrow[i]] = e0d;
      resd[t->primrow[i] + 1] = e1d;
      resd[t->primrow[i] + 2] = e2d;
    } else if (t->primkind[i] == MAGGI_PRIM_AXIS) {
      resd[t->primrow[i]] = dird[t->primda[i]][0] - dird[t->primdb[i]][0];
      resd[t->primrow[i] + 1] = dird[t->primda[i]][1] - dird[t->primdb[i]][1];
      resd[t->primrow[i] + 2] = dird[t->primda[i]][2] - dird[t->primdb[i]][2];
    } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
      resd[t->primrow[i]] = dird[t->primda[i]][0] * dir[t->primdb[i]][0] + dir[t->primda[i]][0] *
          dird[t->primdb[i]][0] + (dird[t->primda[i]][1] * dir[t->primdb[i]][1] +
          dir[t->primda[i]][1] * dird[t->primdb[i]][1]) + (dird[t->primda[i]][2] *
          dir[t->primdb[i]][2] + dir[t->primda[i]][2] * dird[t->primdb[i]][2]) - prim0d[i];
    } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
      resd[t->primrow[i]] = e0d * dir[t->primdb[i]][0] + e0 * dird[t->primdb[i]][0] + (e1d *
          dir[t->primdb[i]][1] + e1 * dird[t->primdb[i]][1]) + (e2d * dir[t->primdb[i]][2] + e2 *
          dird[t->primdb[i]][2]);
    } else {
      prim0_i = prim0[i];
      prim0_id = prim0d[i];
      t2 = 2.0 * prim0_i;
      t2d = 2.0 * prim0_id;
      t2inv = 1.0 / t2;
      resd[t->primrow[i]] = (e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2d * e2 + e2 * e2d) -
          (prim0_id * prim0_i + prim0_i * prim0_id) - res[t->primrow[i]] * t2d) * t2inv;
    }
  }
}

/* entries of the blocks of Phi_d; what the plan does not list is zero */
void maggi_loop_entries_d(const maggi_topo *t, const double prim0[restrict t->nprim],
                          const double prim0d[restrict t->nprim],
                          const double r[restrict t->npoint][3],
                          const double rd[restrict t->npoint][3],
                          const double dir[restrict t->ndir][3],
                          const double dird[restrict t->ndir][3],
                          const double b[restrict t->nbody][6],
                          const double bd[restrict t->nbody][6], double phi[restrict t->nphi],
                          double phid[restrict t->nphi])
{
  int i, k;
  double b_i3, b_i3_2, b_i3_2d, b_i3_3, b_i3_3d, b_i3_4, b_i3_4d, b_i3_5, b_i3_5d, b_i3d, b_i4,
      b_i4_2, b_i4_2d, b_i4_3, b_i4_3d, b_i4_4, b_i4_4d, b_i4_5, b_i4_5d, b_i4d, b_i5, b_i5_2,
      b_i5_2d, b_i5_3, b_i5_3d, b_i5_4, b_i5_4d, b_i5_5, b_i5_5d, b_i5d, c0_2, c0_2d, c0_3, c0_3d,
      c0d, c1_2, c1_2d, c1_3, c1_3d, c1d, c2_2, c2_2d, c2_3, c2_3d, c2d, dir_k0, dir_k0_2,
      dir_k0_2d, dir_k0_3, dir_k0_3d, dir_k0_4, dir_k0_4d, dir_k0d, dir_k1, dir_k1_2, dir_k1_2d,
      dir_k1_3, dir_k1_3d, dir_k1_4, dir_k1_4d, dir_k1d, dir_k2, dir_k2_2, dir_k2_2d, dir_k2_3,
      dir_k2_3d, dir_k2_4, dir_k2_4d, dir_k2d, e0d, e1d, e2d, inv, j0_2, j0_2d, j0_3, j0_3d, j0d,
      j1_2, j1_2d, j1_3, j1_3d, j1d, j2_2, j2_2d, j2_3, j2_3d, j2d, r_k0, r_k0_2, r_k0_2d, r_k0_3,
      r_k0_3d, r_k0_4, r_k0_4d, r_k0_5, r_k0_5d, r_k0d, r_k1, r_k1_2, r_k1_2d, r_k1_3, r_k1_3d,
      r_k1_4, r_k1_4d, r_k1_5, r_k1_5d, r_k1d, r_k2, r_k2_2, r_k2_2d, r_k2_3, r_k2_3d, r_k2_4,
      r_k2_4d, r_k2_5, r_k2_5d, r_k2d, s, t2, t2d, w0, w0d, w1, w1d, w2, w2d;

  (void)phi;
  for (i = 0; i < t->nent; ++i) {
    k = t->entprim[i];
    s = t->entside[i] == 0 ? 1.0 : -1.0;
    w0 = b[t->qbody[t->entq[i]]][3];
    w0d = bd[t->qbody[t->entq[i]]][3];
    w1 = b[t->qbody[t->entq[i]]][4];
    w1d = bd[t->qbody[t->entq[i]]][4];
    w2 = b[t->qbody[t->entq[i]]][5];
    w2d = bd[t->qbody[t->entq[i]]][5];
    if (t->primkind[k] == MAGGI_PRIM_POINT) {
      if (t->entside[i] == 0) {
        b_i4 = b[t->qbody[t->entq[i]]][4];
        b_i4d = bd[t->qbody[t->entq[i]]][4];
        r_k2 = r[t->primpa[k]][2];
        r_k2d = rd[t->primpa[k]][2];
        b_i5 = b[t->qbody[t->entq[i]]][5];
        b_i5d = bd[t->qbody[t->entq[i]]][5];
        r_k1 = r[t->primpa[k]][1];
        r_k1d = rd[t->primpa[k]][1];
        j0d = bd[t->qbody[t->entq[i]]][0] + (b_i4d * r_k2 + b_i4 * r_k2d) - (b_i5d * r_k1 + b_i5 *
            r_k1d);
        r_k0 = r[t->primpa[k]][0];
        r_k0d = rd[t->primpa[k]][0];
        b_i3 = b[t->qbody[t->entq[i]]][3];
        b_i3d = bd[t->qbody[t->entq[i]]][3];
        j1d = bd[t->qbody[t->entq[i]]][1] + (b_i5d * r_k0 + b_i5 * r_k0d) - (b_i3d * r_k2 + b_i3 *
            r_k2d);
        j2d = bd[t->qbody[t->entq[i]]][2] + (b_i3d * r_k1 + b_i3 * r_k1d) - (b_i4d * r_k0 + b_i4 *
            r_k0d);
      } else {
        b_i4_2 = b[t->qbody[t->entq[i]]][4];
        b_i4_2d = bd[t->qbody[t->entq[i]]][4];
        r_k2_2 = r[t->primpb[k]][2];
        r_k2_2d = rd[t->primpb[k]][2];
        b_i5_2 = b[t->qbody[t->entq[i]]][5];
        b_i5_2d = bd[t->qbody[t->entq[i]]][5];
        r_k1_2 = r[t->primpb[k]][1];
        r_k1_2d = rd[t->primpb[k]][1];
        j0d = bd[t->qbody[t->entq[i]]][0] + (b_i4_2d * r_k2_2 + b_i4_2 * r_k2_2d) - (b_i5_2d *
            r_k1_2 + b_i5_2 * r_k1_2d);
        r_k0_2 = r[t->primpb[k]][0];
        r_k0_2d = rd[t->primpb[k]][0];
        b_i3_2 = b[t->qbody[t->entq[i]]][3];
        b_i3_2d = bd[t->qbody[t->entq[i]]][3];
        j1d = bd[t->qbody[t->entq[i]]][1] + (b_i5_2d * r_k0_2 + b_i5_2 * r_k0_2d) - (b_i3_2d *
            r_k2_2 + b_i3_2 * r_k2_2d);
        j2d = bd[t->qbody[t->entq[i]]][2] + (b_i3_2d * r_k1_2 + b_i3_2 * r_k1_2d) - (b_i4_2d *
            r_k0_2 + b_i4_2 * r_k0_2d);
      }
      e0d = s * j0d;
      e1d = s * j1d;
      e2d = s * j2d;
    } else if (t->primkind[k] == MAGGI_PRIM_AXIS) {
      if (t->entside[i] == 0) {
        dir_k2 = dir[t->primda[k]][2];
        dir_k2d = dird[t->primda[k]][2];
        dir_k1 = dir[t->primda[k]][1];
        dir_k1d = dird[t->primda[k]][1];
        c0d = w1d * dir_k2 + w1 * dir_k2d - (w2d * dir_k1 + w2 * dir_k1d);
        dir_k0 = dir[t->primda[k]][0];
        dir_k0d = dird[t->primda[k]][0];
        c1d = w2d * dir_k0 + w2 * dir_k0d - (w0d * dir_k2 + w0 * dir_k2d);
        c2d = w0d * dir_k1 + w0 * dir_k1d - (w1d * dir_k0 + w1 * dir_k0d);
      } else {
        dir_k2_2 = dir[t->primdb[k]][2];
        dir_k2_2d = dird[t->primdb[k]][2];
        dir_k1_2 = dir[t->primdb[k]][1];
        dir_k1_2d = dird[t->primdb[k]][1];
        c0d = w1d * dir_k2_2 + w1 * dir_k2_2d - (w2d * dir_k1_2 + w2 * dir_k1_2d);
        dir_k0_2 = dir[t->primdb[k]][0];
        dir_k0_2d = dird[t->primdb[k]][0];
        c1d = w2d * dir_k0_2 + w2 * dir_k0_2d - (w0d * dir_k2_2 + w0 * dir_k2_2d);
        c2d = w0d * dir_k1_2 + w0 * dir_k1_2d - (w1d * dir_k0_2 + w1 * dir_k0_2d);
      }
      e0d = s * c0d;
      e1d = s * c1d;
      e2d = s * c2d;
    } else if (t->primkind[k] == MAGGI_PRIM_ANGLE) {
      dir_k1_3 = dir[t->primda[k]][1];
      dir_k1_3d = dird[t->primda[k]][1];
      dir_k2_3 = dir[t->primdb[k]][2];
      dir_k2_3d = dird[t->primdb[k]][2];
      dir_k2_4 = dir[t->primda[k]][2];
      dir_k2_4d = dird[t->primda[k]][2];
      dir_k1_4 = dir[t->primdb[k]][1];
      dir_k1_4d = dird[t->primdb[k]][1];
      c0_2 = dir_k1_3 * dir_k2_3 - dir_k2_4 * dir_k1_4;
      c0_2d = dir_k1_3d * dir_k2_3 + dir_k1_3 * dir_k2_3d - (dir_k2_4d * dir_k1_4 + dir_k2_4 *
          dir_k1_4d);
      dir_k0_3 = dir[t->primdb[k]][0];
      dir_k0_3d = dird[t->primdb[k]][0];
      dir_k0_4 = dir[t->primda[k]][0];
      dir_k0_4d = dird[t->primda[k]][0];
      c1_2 = dir_k2_4 * dir_k0_3 - dir_k0_4 * dir_k2_3;
      c1_2d = dir_k2_4d * dir_k0_3 + dir_k2_4 * dir_k0_3d - (dir_k0_4d * dir_k2_3 + dir_k0_4 *
          dir_k2_3d);
      c2_2 = dir_k0_4 * dir_k1_4 - dir_k1_3 * dir_k0_3;
      c2_2d = dir_k0_4d * dir_k1_4 + dir_k0_4 * dir_k1_4d - (dir_k1_3d * dir_k0_3 + dir_k1_3 *
          dir_k0_3d);
      e0d = s * (w0d * c0_2 + w0 * c0_2d + (w1d * c1_2 + w1 * c1_2d) + (w2d * c2_2 + w2 * c2_2d));
      e1d = 0.0;
      e2d = 0.0;
    } else if (t->primkind[k] == MAGGI_PRIM_PLANE) {
      b_i4_3 = b[t->qbody[t->entq[i]]][4];
      b_i4_3d = bd[t->qbody[t->entq[i]]][4];
      r_k2_3 = r[t->primpa[k]][2];
      r_k2_3d = rd[t->primpa[k]][2];
      b_i5_3 = b[t->qbody[t->entq[i]]][5];
      b_i5_3d = bd[t->qbody[t->entq[i]]][5];
      r_k1_3 = r[t->primpa[k]][1];
      r_k1_3d = rd[t->primpa[k]][1];
      j0_2 = b[t->qbody[t->entq[i]]][0] + b_i4_3 * r_k2_3 - b_i5_3 * r_k1_3;
      j0_2d = bd[t->qbody[t->entq[i]]][0] + (b_i4_3d * r_k2_3 + b_i4_3 * r_k2_3d) - (b_i5_3d *
          r_k1_3 + b_i5_3 * r_k1_3d);
      r_k0_3 = r[t->primpa[k]][0];
      r_k0_3d = rd[t->primpa[k]][0];
      b_i3_3 = b[t->qbody[t->entq[i]]][3];
      b_i3_3d = bd[t->qbody[t->entq[i]]][3];
      j1_2 = b[t->qbody[t->entq[i]]][1] + b_i5_3 * r_k0_3 - b_i3_3 * r_k2_3;
      j1_2d = bd[t->qbody[t->entq[i]]][1] + (b_i5_3d * r_k0_3 + b_i5_3 * r_k0_3d) - (b_i3_3d *
          r_k2_3 + b_i3_3 * r_k2_3d);
      j2_2 = b[t->qbody[t->entq[i]]][2] + b_i3_3 * r_k1_3 - b_i4_3 * r_k0_3;
      j2_2d = bd[t->qbody[t->entq[i]]][2] + (b_i3_3d * r_k1_3 + b_i3_3 * r_k1_3d) - (b_i4_3d *
          r_k0_3 + b_i4_3 * r_k0_3d);
      e0d = s * (dird[t->primdb[k]][0] * j0_2 + dir[t->primdb[k]][0] * j0_2d +
          (dird[t->primdb[k]][1] * j1_2 + dir[t->primdb[k]][1] * j1_2d) + (dird[t->primdb[k]][2] *
          j2_2 + dir[t->primdb[k]][2] * j2_2d));
      e1d = 0.0;
      e2d = 0.0;
    } else {
      if (t->entside[i] == 0) {
        b_i4_4 = b[t->qbody[t->entq[i]]][4];
        b_i4_4d = bd[t->qbody[t->entq[i]]][4];
        r_k2_4 = r[t->primpa[k]][2];
        r_k2_4d = rd[t->primpa[k]][2];
        b_i5_4 = b[t->qbody[t->entq[i]]][5];
        b_i5_4d = bd[t->qbody[t->entq[i]]][5];
        r_k1_4 = r[t->primpa[k]][1];
        r_k1_4d = rd[t->primpa[k]][1];
        j0_3 = b[t->qbody[t->entq[i]]][0] + b_i4_4 * r_k2_4 - b_i5_4 * r_k1_4;
        j0_3d = bd[t->qbody[t->entq[i]]][0] + (b_i4_4d * r_k2_4 + b_i4_4 * r_k2_4d) - (b_i5_4d *
            r_k1_4 + b_i5_4 * r_k1_4d);
        r_k0_4 = r[t->primpa[k]][0];
        r_k0_4d = rd[t->primpa[k]][0];
        b_i3_4 = b[t->qbody[t->entq[i]]][3];
        b_i3_4d = bd[t->qbody[t->entq[i]]][3];
        j1_3 = b[t->qbody[t->entq[i]]][1] + b_i5_4 * r_k0_4 - b_i3_4 * r_k2_4;
        j1_3d = bd[t->qbody[t->entq[i]]][1] + (b_i5_4d * r_k0_4 + b_i5_4 * r_k0_4d) - (b_i3_4d *
            r_k2_4 + b_i3_4 * r_k2_4d);
        j2_3 = b[t->qbody[t->entq[i]]][2] + b_i3_4 * r_k1_4 - b_i4_4 * r_k0_4;
        j2_3d = bd[t->qbody[t->entq[i]]][2] + (b_i3_4d * r_k1_4 + b_i3_4 * r_k1_4d) - (b_i4_4d *
            r_k0_4 + b_i4_4 * r_k0_4d);
      } else {
        b_i4_5 = b[t->qbody[t->entq[i]]][4];
        b_i4_5d = bd[t->qbody[t->entq[i]]][4];
        r_k2_5 = r[t->primpb[k]][2];
        r_k2_5d = rd[t->primpb[k]][2];
        b_i5_5 = b[t->qbody[t->entq[i]]][5];
        b_i5_5d = bd[t->qbody[t->entq[i]]][5];
        r_k1_5 = r[t->primpb[k]][1];
        r_k1_5d = rd[t->primpb[k]][1];
        j0_3 = b[t->qbody[t->entq[i]]][0] + b_i4_5 * r_k2_5 - b_i5_5 * r_k1_5;
        j0_3d = bd[t->qbody[t->entq[i]]][0] + (b_i4_5d * r_k2_5 + b_i4_5 * r_k2_5d) - (b_i5_5d *
            r_k1_5 + b_i5_5 * r_k1_5d);
        r_k0_5 = r[t->primpb[k]][0];
        r_k0_5d = rd[t->primpb[k]][0];
        b_i3_5 = b[t->qbody[t->entq[i]]][3];
        b_i3_5d = bd[t->qbody[t->entq[i]]][3];
        j1_3 = b[t->qbody[t->entq[i]]][1] + b_i5_5 * r_k0_5 - b_i3_5 * r_k2_5;
        j1_3d = bd[t->qbody[t->entq[i]]][1] + (b_i5_5d * r_k0_5 + b_i5_5 * r_k0_5d) - (b_i3_5d *
            r_k2_5 + b_i3_5 * r_k2_5d);
        j2_3 = b[t->qbody[t->entq[i]]][2] + b_i3_5 * r_k1_5 - b_i4_5 * r_k0_5;
        j2_3d = bd[t->qbody[t->entq[i]]][2] + (b_i3_5d * r_k1_5 + b_i3_5 * r_k1_5d) - (b_i4_5d *
            r_k0_5 + b_i4_5 * r_k0_5d);
      }
      c0_3 = r[t->primpa[k]][0] - r[t->primpb[k]][0];
      c0_3d = rd[t->primpa[k]][0] - rd[t->primpb[k]][0];
      c1_3 = r[t->primpa[k]][1] - r[t->primpb[k]][1];
      c1_3d = rd[t->primpa[k]][1] - rd[t->primpb[k]][1];
      c2_3 = r[t->primpa[k]][2] - r[t->primpb[k]][2];
      c2_3d = rd[t->primpa[k]][2] - rd[t->primpb[k]][2];
      t2 = s * (c0_3 * j0_3 + c1_3 * j1_3 + c2_3 * j2_3) / prim0[k];
      inv = 1.0 / prim0[k];
      t2d = (s * (c0_3d * j0_3 + c0_3 * j0_3d + (c1_3d * j1_3 + c1_3 * j1_3d) + (c2_3d * j2_3 + c2_3
          * j2_3d)) - t2 * prim0d[k]) * inv;
      e0d = t2d;
      e1d = 0.0;
      e2d = 0.0;
    }
    phid[t->entadr[i]] = e0d;
    if (t->primkind[k] == MAGGI_PRIM_POINT || t->primkind[k] == MAGGI_PRIM_AXIS) {
      phid[t->entadr[i] + t->entstep[i]] = e1d;
      phid[t->entadr[i] + 2 * t->entstep[i]] = e2d;
    }
  }
}

void maggi_loop_rates_d(const maggi_topo *t, const double prim0[restrict t->nprim],
                        const double prim0d[restrict t->nprim],
                        const double r[restrict t->npoint][3],
                        const double rd[restrict t->npoint][3],
                        const double dir[restrict t->ndir][3],
                        const double dird[restrict t->ndir][3],
                        const double rv[restrict t->npoint][3],
                        const double rvd[restrict t->npoint][3],
                        const double Z[restrict t->nbody + 1][6],
                        const double Zd[restrict t->nbody + 1][6], double rate[restrict t->nrow],
                        double rated[restrict t->nrow])
{
  int c, i, i2;
  double da10, da10d, da11, da11d, da12, da12d, db10, db10d, db11, db11d, db12, db12d, dir_i0,
      dir_i0_2, dir_i0_2d, dir_i0d, dir_i1, dir_i1_2, dir_i1_2d, dir_i1d, dir_i2, dir_i2_2,
      dir_i2_2d, dir_i2d, e0, e0d, e10d, e11d, e12d, e1_3, e1_3d, e1_4d, e1_5d, e1_6d, e20, e20d,
      e21, e21d, e22, e22d, e2_2, e2_2d, e30, e30d, e31, e31d, e32, e32d, ev0, ev0d, ev1, ev1d, ev2,
      ev2d, inv, s, t2, t2d, w0, w0d, w1, w1d, w20, w20d, w21, w21d, w22, w22d, w2_2, w2_2d, w30,
      w30d, w31, w31d, w32, w32d, w40, w40d, w41, w41d, w42, w42d;

  (void)rate;
  for (i = 0; i < t->nprim; ++i) {
    e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
    /* the first derivative of the equation */
    e0d = rd[t->primpa[i]][0] - rd[t->primpb[i]][0];
    ev0 = rv[t->primpa[i]][0] - rv[t->primpb[i]][0];
    ev0d = rvd[t->primpa[i]][0] - rvd[t->primpb[i]][0];
    e1_3 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
    e1_3d = rd[t->primpa[i]][1] - rd[t->primpb[i]][1];
    ev1 = rv[t->primpa[i]][1] - rv[t->primpb[i]][1];
    ev1d = rvd[t->primpa[i]][1] - rvd[t->primpb[i]][1];
    e2_2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
    e2_2d = rd[t->primpa[i]][2] - rd[t->primpb[i]][2];
    ev2 = rv[t->primpa[i]][2] - rv[t->primpb[i]][2];
    ev2d = rvd[t->primpa[i]][2] - rvd[t->primpb[i]][2];
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
      rated[t->primrow[i]] = ev0d;
      rated[t->primrow[i] + 1] = ev1d;
      rated[t->primrow[i] + 2] = ev2d;
    } else if (t->primkind[i] == MAGGI_PRIM_ROD) {
      t2 = (ev0 * e0 + ev1 * e1_3 + ev2 * e2_2) / prim0[i];
      inv = 1.0 / prim0[i];
      t2d = (ev0d * e0 + ev0 * e0d + (ev1d * e1_3 + ev1 * e1_3d) + (ev2d * e2_2 + ev2 * e2_2d) - t2
          * prim0d[i]) * inv;
      rated[t->primrow[i]] = t2d;
    } else {
      w0 = Z[t->primba[i]][3];
      /* u' = w × u */
      w0d = Zd[t->primba[i]][3];
      w1 = Z[t->primba[i]][4];
      w1d = Zd[t->primba[i]][4];
      w2_2 = Z[t->primba[i]][5];
      w2_2d = Zd[t->primba[i]][5];
      dir_i2 = dir[t->primda[i]][2];
      dir_i2d = dird[t->primda[i]][2];
      dir_i1 = dir[t->primda[i]][1];
      dir_i1d = dird[t->primda[i]][1];
      da10 = w1 * dir_i2 - w2_2 * dir_i1;
      da10d = w1d * dir_i2 + w1 * dir_i2d - (w2_2d * dir_i1 + w2_2 * dir_i1d);
      dir_i0 = dir[t->primda[i]][0];
      dir_i0d = dird[t->primda[i]][0];
      da11 = w2_2 * dir_i0 - w0 * dir_i2;
      da11d = w2_2d * dir_i0 + w2_2 * dir_i0d - (w0d * dir_i2 + w0 * dir_i2d);
      da12 = w0 * dir_i1 - w1 * dir_i0;
      da12d = w0d * dir_i1 + w0 * dir_i1d - (w1d * dir_i0 + w1 * dir_i0d);
      w20 = Z[t->primbb[i]][3];
      /* u' = w × u */
      w20d = Zd[t->primbb[i]][3];
      w21 = Z[t->primbb[i]][4];
      w21d = Zd[t->primbb[i]][4];
      w22 = Z[t->primbb[i]][5];
      w22d = Zd[t->primbb[i]][5];
      dir_i2_2 = dir[t->primdb[i]][2];
      dir_i2_2d = dird[t->primdb[i]][2];
      dir_i1_2 = dir[t->primdb[i]][1];
      dir_i1_2d = dird[t->primdb[i]][1];
      db10 = w21 * dir_i2_2 - w22 * dir_i1_2;
      db10d = w21d * dir_i2_2 + w21 * dir_i2_2d - (w22d * dir_i1_2 + w22 * dir_i1_2d);
      dir_i0_2 = dir[t->primdb[i]][0];
      dir_i0_2d = dird[t->primdb[i]][0];
      db11 = w22 * dir_i0_2 - w20 * dir_i2_2;
      db11d = w22d * dir_i0_2 + w22 * dir_i0_2d - (w20d * dir_i2_2 + w20 * dir_i2_2d);
      db12 = w20 * dir_i1_2 - w21 * dir_i0_2;
      db12d = w20d * dir_i1_2 + w20 * dir_i1_2d - (w21d * dir_i0_2 + w21 * dir_i0_2d);
      if (t->primkind[i] == MAGGI_PRIM_AXIS) {
        rated[t->primrow[i]] = da10d - db10d;
        rated[t->primrow[i] + 1] = da11d - db11d;
        rated[t->primrow[i] + 2] = da12d - db12d;
      } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
        rated[t->primrow[i]] = da10d * dir[t->primdb[i]][0] + da10 * dird[t->primdb[i]][0] + (da11d
            * dir[t->primdb[i]][1] + da11 * dird[t->primdb[i]][1]) + (da12d * dir[t->primdb[i]][2] +
            da12 * dird[t->primdb[i]][2]) + (dird[t->primda[i]][0] * db10 + dir[t->primda[i]][0] *
            db10d + (dird[t->primda[i]][1] * db11 + dir[t->primda[i]][1] * db11d) +
            (dird[t->primda[i]][2] * db12 + dir[t->primda[i]][2] * db12d));
      } else {
        rated[t->primrow[i]] = ev0d * dir[t->primdb[i]][0] + ev0 * dird[t->primdb[i]][0] + (ev1d *
            dir[t->primdb[i]][1] + ev1 * dird[t->primdb[i]][1]) + (ev2d * dir[t->primdb[i]][2] + ev2
            * dird[t->primdb[i]][2]) + (e0d * db10 + e0 * db10d + (e1_3d * db11 + e1_3 * db11d) +
            (e2_2d * db12 + e2_2 * db12d));
      }
    }
  }
  s = -1.0;
  /* what turning with the bodies that carry both sides does to open points and axes */
  for (i2 = 0; i2 < t->nprim; ++i2) {
    c = t->loopcommon[t->primloop[i2]];
    if (c < t->nbody && t->primkind[i2] == MAGGI_PRIM_POINT) {
      e20 = r[t->primpa[i2]][0] - r[t->primpb[i2]][0];
      /* y += s w × (a - b) */
      e20d = rd[t->primpa[i2]][0] - rd[t->primpb[i2]][0];
      e21 = r[t->primpa[i2]][1] - r[t->primpb[i2]][1];
      e21d = rd[t->primpa[i2]][1] - rd[t->primpb[i2]][1];
      e22 = r[t->primpa[i2]][2] - r[t->primpb[i2]][2];
      e22d = rd[t->primpa[i2]][2] - rd[t->primpb[i2]][2];
      w30 = Z[c][3];
      /* u' = w × u */
      w30d = Zd[c][3];
      w31 = Z[c][4];
      w31d = Zd[c][4];
      w32 = Z[c][5];
      w32d = Zd[c][5];
      e10d = w31d * e22 + w31 * e22d - (w32d * e21 + w32 * e21d);
      e11d = w32d * e20 + w32 * e20d - (w30d * e22 + w30 * e22d);
      e12d = w30d * e21 + w30 * e21d - (w31d * e20 + w31 * e20d);
      rated[t->primrow[i2]] += s * e10d;
      rated[t->primrow[i2] + 1] += s * e11d;
      rated[t->primrow[i2] + 2] += s * e12d;
    } else if (c < t->nbody && t->primkind[i2] == MAGGI_PRIM_AXIS) {
      e30 = dir[t->primda[i2]][0] - dir[t->primdb[i2]][0];
      /* y += s w × (a - b) */
      e30d = dird[t->primda[i2]][0] - dird[t->primdb[i2]][0];
      e31 = dir[t->primda[i2]][1] - dir[t->primdb[i2]][1];
      e31d = dird[t->primda[i2]][1] - dird[t->primdb[i2]][1];
      e32 = dir[t->primda[i2]][2] - dir[t->primdb[i2]][2];
      e32d = dird[t->primda[i2]][2] - dird[t->primdb[i2]][2];
      w40 = Z[c][3];
      /* u' = w × u */
      w40d = Zd[c][3];
      w41 = Z[c][4];
      w41d = Zd[c][4];
      w42 = Z[c][5];
      w42d = Zd[c][5];
      e1_4d = w41d * e32 + w41 * e32d - (w42d * e31 + w42 * e31d);
      e1_5d = w42d * e30 + w42 * e30d - (w40d * e32 + w40 * e32d);
      e1_6d = w40d * e31 + w40 * e31d - (w41d * e30 + w41 * e30d);
      rated[t->primrow[i2]] += s * e1_4d;
      rated[t->primrow[i2] + 1] += s * e1_5d;
      rated[t->primrow[i2] + 2] += s * e1_6d;
    }
  }
}

void maggi_loop_gamma_d(const maggi_topo *t, const double prim0[restrict t->nprim],
                        const double prim0d[restrict t->nprim],
                        const double r[restrict t->npoint][3],
                        const double rd[restrict t->npoint][3],
                        const double dir[restrict t->ndir][3],
                        const double dird[restrict t->ndir][3],
                        const double rv[restrict t->npoint][3],
                        const double rvd[restrict t->npoint][3],
                        const double ra[restrict t->npoint][3],
                        const double rad[restrict t->npoint][3],
                        const double Z[restrict t->nbody + 1][6],
                        const double Zd[restrict t->nbody + 1][6],
                        const double Z0[restrict t->nbody + 1][6],
                        const double Z0d[restrict t->nbody + 1][6], double gam[restrict t->nrow],
                        double gamd[restrict t->nrow])
{
  int a, b, c3, i, i2;
  double Z_a3, Z_a3d, Z_a4, Z_a4d, Z_a5, Z_a5d, Z_b3, Z_b3d, Z_b4, Z_b4d, Z_b5, Z_b5d, c0, c0d, c1,
      c1d, c20, c20d, c21, c21d, c22, c22d, c2_2, c2_2d, da10, da10d, da11, da11d, da12, da12d,
      da20, da20d, da21, da21d, da22, da22d, db10, db10d, db11, db11d, db12, db12d, db20, db20d,
      db21, db21d, db22, db22d, dir_i0, dir_i0_2, dir_i0_2d, dir_i0d, dir_i1, dir_i1_2, dir_i1_2d,
      dir_i1d, dir_i2, dir_i2_2, dir_i2_2d, dir_i2d, e0, e0d, e10d, e11d, e12d, e1_3, e1_3d, e1_4d,
      e1_5d, e1_6d, e20, e20d, e21, e21d, e22, e22d, e2_2, e2_2d, e30, e30d, e31, e31d, e32, e32d,
      e40, e40d, e41, e41d, e42, e42d, e50, e50d, e51, e51d, e52, e52d, ea0, ea0d, ea1, ea1d, ea2,
      ea2d, ev0, ev0d, ev1, ev1d, ev2, ev2d, inv, t2, t2d, w0, w0d, w1, w1d, w20, w20d, w21, w21d,
      w22, w22d, w2_2, w2_2d, w30, w30d, w31, w31d, w32, w32d, w40, w40d, w41, w41d, w42, w42d, w50,
      w50d, w51, w51d, w52, w52d, w60, w60d, w61, w61d, w62, w62d, w70, w70d, w71, w71d, w72, w72d,
      w80, w80d, w81, w81d, w82, w82d;

  (void)gam;
  for (i = 0; i < t->nprim; ++i) {
    a = t->primba[i];
    b = t->primbb[i];
    e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
    /* minus the second derivative of the equation with all joint accelerations zero */
    e0d = rd[t->primpa[i]][0] - rd[t->primpb[i]][0];
    ev0 = rv[t->primpa[i]][0] - rv[t->primpb[i]][0];
    ev0d = rvd[t->primpa[i]][0] - rvd[t->primpb[i]][0];
    ea0 = ra[t->primpa[i]][0] - ra[t->primpb[i]][0];
    ea0d = rad[t->primpa[i]][0] - rad[t->primpb[i]][0];
    e1_3 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
    e1_3d = rd[t->primpa[i]][1] - rd[t->primpb[i]][1];
    ev1 = rv[t->primpa[i]][1] - rv[t->primpb[i]][1];
    ev1d = rvd[t->primpa[i]][1] - rvd[t->primpb[i]][1];
    ea1 = ra[t->primpa[i]][1] - ra[t->primpb[i]][1];
    ea1d = rad[t->primpa[i]][1] - rad[t->primpb[i]][1];
    e2_2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
    e2_2d = rd[t->primpa[i]][2] - rd[t->primpb[i]][2];
    ev2 = rv[t->primpa[i]][2] - rv[t->primpb[i]][2];
    ev2d = rvd[t->primpa[i]][2] - rvd[t->primpb[i]][2];
    ea2 = ra[t->primpa[i]][2] - ra[t->primpb[i]][2];
    ea2d = rad[t->primpa[i]][2] - rad[t->primpb[i]][2];
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
      gamd[t->primrow[i]] = -ea0d;
      gamd[t->primrow[i] + 1] = -ea1d;
      gamd[t->primrow[i] + 2] = -ea2d;
    } else if (t->primkind[i] == MAGGI_PRIM_ROD) {
      t2 = -(ea0 * e0 + ea1 * e1_3 + ea2 * e2_2 + (ev0 * ev0 + ev1 * ev1 + ev2 * ev2)) / prim0[i];
      inv = 1.0 / prim0[i];
      t2d = (-(ea0d * e0 + ea0 * e0d + (ea1d * e1_3 + ea1 * e1_3d) + (ea2d * e2_2 + ea2 * e2_2d) +
          (ev0d * ev0 + ev0 * ev0d + (ev1d * ev1 + ev1 * ev1d) + (ev2d * ev2 + ev2 * ev2d))) - t2 *
          prim0d[i]) * inv;
      gamd[t->primrow[i]] = t2d;
    } else {
      Z_a3 = Z[a][3];
      Z_a3d = Zd[a][3];
      w0 = Z_a3;
      /* u' = w × u */
      w0d = Z_a3d;
      Z_a4 = Z[a][4];
      Z_a4d = Zd[a][4];
      w1 = Z_a4;
      w1d = Z_a4d;
      Z_a5 = Z[a][5];
      Z_a5d = Zd[a][5];
      w2_2 = Z_a5;
      w2_2d = Z_a5d;
      dir_i2 = dir[t->primda[i]][2];
      dir_i2d = dird[t->primda[i]][2];
      dir_i1 = dir[t->primda[i]][1];
      dir_i1d = dird[t->primda[i]][1];
      da10 = w1 * dir_i2 - w2_2 * dir_i1;
      da10d = w1d * dir_i2 + w1 * dir_i2d - (w2_2d * dir_i1 + w2_2 * dir_i1d);
      dir_i0 = dir[t->primda[i]][0];
      dir_i0d = dird[t->primda[i]][0];
      da11 = w2_2 * dir_i0 - w0 * dir_i2;
      da11d = w2_2d * dir_i0 + w2_2 * dir_i0d - (w0d * dir_i2 + w0 * dir_i2d);
      da12 = w0 * dir_i1 - w1 * dir_i0;
      da12d = w0d * dir_i1 + w0 * dir_i1d - (w1d * dir_i0 + w1 * dir_i0d);
      Z_b3 = Z[b][3];
      Z_b3d = Zd[b][3];
      w20 = Z_b3;
      /* u' = w × u */
      w20d = Z_b3d;
      Z_b4 = Z[b][4];
      Z_b4d = Zd[b][4];
      w21 = Z_b4;
      w21d = Z_b4d;
      Z_b5 = Z[b][5];
      Z_b5d = Zd[b][5];
      w22 = Z_b5;
      w22d = Z_b5d;
      dir_i2_2 = dir[t->primdb[i]][2];
      dir_i2_2d = dird[t->primdb[i]][2];
      dir_i1_2 = dir[t->primdb[i]][1];
      dir_i1_2d = dird[t->primdb[i]][1];
      db10 = w21 * dir_i2_2 - w22 * dir_i1_2;
      db10d = w21d * dir_i2_2 + w21 * dir_i2_2d - (w22d * dir_i1_2 + w22 * dir_i1_2d);
      dir_i0_2 = dir[t->primdb[i]][0];
      dir_i0_2d = dird[t->primdb[i]][0];
      db11 = w22 * dir_i0_2 - w20 * dir_i2_2;
      db11d = w22d * dir_i0_2 + w22 * dir_i0_2d - (w20d * dir_i2_2 + w20 * dir_i2_2d);
      db12 = w20 * dir_i1_2 - w21 * dir_i0_2;
      db12d = w20d * dir_i1_2 + w20 * dir_i1_2d - (w21d * dir_i0_2 + w21 * dir_i0_2d);
      w30 = Z0[a][3];
      /* u'' = w' × u + w × u'
       * u' = w × u */
      w30d = Z0d[a][3];
      w31 = Z0[a][4];
      w31d = Z0d[a][4];
      w32 = Z0[a][5];
      w32d = Z0d[a][5];
      c0 = w31 * dir_i2 - w32 * dir_i1;
      c0d = w31d * dir_i2 + w31 * dir_i2d - (w32d * dir_i1 + w32 * dir_i1d);
      c1 = w32 * dir_i0 - w30 * dir_i2;
      c1d = w32d * dir_i0 + w32 * dir_i0d - (w30d * dir_i2 + w30 * dir_i2d);
      c2_2 = w30 * dir_i1 - w31 * dir_i0;
      c2_2d = w30d * dir_i1 + w30 * dir_i1d - (w31d * dir_i0 + w31 * dir_i0d);
      w40 = Z_a3;
      /* u' = w × u */
      w40d = Z_a3d;
      w41 = Z_a4;
      w41d = Z_a4d;
      w42 = Z_a5;
      w42d = Z_a5d;
      e20 = w41 * da12 - w42 * da11;
      e20d = w41d * da12 + w41 * da12d - (w42d * da11 + w42 * da11d);
      e21 = w42 * da10 - w40 * da12;
      e21d = w42d * da10 + w42 * da10d - (w40d * da12 + w40 * da12d);
      e22 = w40 * da11 - w41 * da10;
      e22d = w40d * da11 + w40 * da11d - (w41d * da10 + w41 * da10d);
      da20 = c0 + e20;
      da20d = c0d + e20d;
      da21 = c1 + e21;
      da21d = c1d + e21d;
      da22 = c2_2 + e22;
      da22d = c2_2d + e22d;
      w50 = Z0[b][3];
      /* u'' = w' × u + w × u'
       * u' = w × u */
      w50d = Z0d[b][3];
      w51 = Z0[b][4];
      w51d = Z0d[b][4];
      w52 = Z0[b][5];
      w52d = Z0d[b][5];
      c20 = w51 * dir_i2_2 - w52 * dir_i1_2;
      c20d = w51d * dir_i2_2 + w51 * dir_i2_2d - (w52d * dir_i1_2 + w52 * dir_i1_2d);
      c21 = w52 * dir_i0_2 - w50 * dir_i2_2;
      c21d = w52d * dir_i0_2 + w52 * dir_i0_2d - (w50d * dir_i2_2 + w50 * dir_i2_2d);
      c22 = w50 * dir_i1_2 - w51 * dir_i0_2;
      c22d = w50d * dir_i1_2 + w50 * dir_i1_2d - (w51d * dir_i0_2 + w51 * dir_i0_2d);
      w60 = Z_b3;
      /* u' = w × u */
      w60d = Z_b3d;
      w61 = Z_b4;
      w61d = Z_b4d;
      w62 = Z_b5;
      w62d = Z_b5d;
      e30 = w61 * db12 - w62 * db11;
      e30d = w61d * db12 + w61 * db12d - (w62d * db11 + w62 * db11d);
      e31 = w62 * db10 - w60 * db12;
      e31d = w62d * db10 + w62 * db10d - (w60d * db12 + w60 * db12d);
      e32 = w60 * db11 - w61 * db10;
      e32d = w60d * db11 + w60 * db11d - (w61d * db10 + w61 * db10d);
      db20 = c20 + e30;
      db20d = c20d + e30d;
      db21 = c21 + e31;
      db21d = c21d + e31d;
      db22 = c22 + e32;
      db22d = c22d + e32d;
      if (t->primkind[i] == MAGGI_PRIM_AXIS) {
        gamd[t->primrow[i]] = db20d - da20d;
        gamd[t->primrow[i] + 1] = db21d - da21d;
        gamd[t->primrow[i] + 2] = db22d - da22d;
      } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
        gamd[t->primrow[i]] = -(da20d * dir[t->primdb[i]][0] + da20 * dird[t->primdb[i]][0] + (da21d
            * dir[t->primdb[i]][1] + da21 * dird[t->primdb[i]][1]) + (da22d * dir[t->primdb[i]][2] +
            da22 * dird[t->primdb[i]][2]) + 2.0 * (da10d * db10 + da10 * db10d + (da11d * db11 +
            da11 * db11d) + (da12d * db12 + da12 * db12d)) + (dird[t->primda[i]][0] * db20 +
            dir[t->primda[i]][0] * db20d + (dird[t->primda[i]][1] * db21 + dir[t->primda[i]][1] *
            db21d) + (dird[t->primda[i]][2] * db22 + dir[t->primda[i]][2] * db22d)));
      } else {
        gamd[t->primrow[i]] = -(ea0d * dir[t->primdb[i]][0] + ea0 * dird[t->primdb[i]][0] + (ea1d *
            dir[t->primdb[i]][1] + ea1 * dird[t->primdb[i]][1]) + (ea2d * dir[t->primdb[i]][2] + ea2
            * dird[t->primdb[i]][2]) + 2.0 * (ev0d * db10 + ev0 * db10d + (ev1d * db11 + ev1 *
            db11d) + (ev2d * db12 + ev2 * db12d)) + (e0d * db20 + e0 * db20d + (e1_3d * db21 + e1_3
            * db21d) + (e2_2d * db22 + e2_2 * db22d)));
      }
    }
  }
  /* what turning with the bodies that carry both sides does to open points and axes */
  for (i2 = 0; i2 < t->nprim; ++i2) {
    c3 = t->loopcommon[t->primloop[i2]];
    if (c3 < t->nbody && t->primkind[i2] == MAGGI_PRIM_POINT) {
      e40 = r[t->primpa[i2]][0] - r[t->primpb[i2]][0];
      /* y += s w × (a - b) */
      e40d = rd[t->primpa[i2]][0] - rd[t->primpb[i2]][0];
      e41 = r[t->primpa[i2]][1] - r[t->primpb[i2]][1];
      e41d = rd[t->primpa[i2]][1] - rd[t->primpb[i2]][1];
      e42 = r[t->primpa[i2]][2] - r[t->primpb[i2]][2];
      e42d = rd[t->primpa[i2]][2] - rd[t->primpb[i2]][2];
      w70 = Z0[c3][3];
      /* u' = w × u */
      w70d = Z0d[c3][3];
      w71 = Z0[c3][4];
      w71d = Z0d[c3][4];
      w72 = Z0[c3][5];
      w72d = Z0d[c3][5];
      e10d = w71d * e42 + w71 * e42d - (w72d * e41 + w72 * e41d);
      e11d = w72d * e40 + w72 * e40d - (w70d * e42 + w70 * e42d);
      e12d = w70d * e41 + w70 * e41d - (w71d * e40 + w71 * e40d);
      gamd[t->primrow[i2]] += e10d;
      gamd[t->primrow[i2] + 1] += e11d;
      gamd[t->primrow[i2] + 2] += e12d;
    } else if (c3 < t->nbody && t->primkind[i2] == MAGGI_PRIM_AXIS) {
      e50 = dir[t->primda[i2]][0] - dir[t->primdb[i2]][0];
      /* y += s w × (a - b) */
      e50d = dird[t->primda[i2]][0] - dird[t->primdb[i2]][0];
      e51 = dir[t->primda[i2]][1] - dir[t->primdb[i2]][1];
      e51d = dird[t->primda[i2]][1] - dird[t->primdb[i2]][1];
      e52 = dir[t->primda[i2]][2] - dir[t->primdb[i2]][2];
      e52d = dird[t->primda[i2]][2] - dird[t->primdb[i2]][2];
      w80 = Z0[c3][3];
      /* u' = w × u */
      w80d = Z0d[c3][3];
      w81 = Z0[c3][4];
      w81d = Z0d[c3][4];
      w82 = Z0[c3][5];
      w82d = Z0d[c3][5];
      e1_4d = w81d * e52 + w81 * e52d - (w82d * e51 + w82 * e51d);
      e1_5d = w82d * e50 + w82 * e50d - (w80d * e52 + w80 * e52d);
      e1_6d = w80d * e51 + w80 * e51d - (w81d * e50 + w81 * e50d);
      gamd[t->primrow[i2]] += e1_4d;
      gamd[t->primrow[i2] + 1] += e1_5d;
      gamd[t->primrow[i2] + 2] += e1_6d;
    }
  }
}
