/* Tangent of the adjoint of core/kernel/loop.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

void maggi_loop_residual_b_d(const maggi_topo *t, const double prim0[restrict t->nprim],
                             const double prim0d[restrict t->nprim],
                             double prim0b[restrict t->nprim], double prim0bd[restrict t->nprim],
                             const double r[restrict t->npoint][3],
                             const double rd[restrict t->npoint][3],
                             double rb[restrict t->npoint][3], double rbd[restrict t->npoint][3],
                             const double dir[restrict t->ndir][3],
                             const double dird[restrict t->ndir][3],
                             double dirb[restrict t->ndir][3], double dirbd[restrict t->ndir][3],
                             double res[restrict t->nrow], double resd[restrict t->nrow],
                             double resb[restrict t->nrow], double resbd[restrict t->nrow])
{
  int i;
  double e0, e0b, e0bd, e0d, e1, e1b, e1bd, e1d, e2, e2b, e2bd, e2d, prim0_i, prim0_ib, prim0_ibd,
      prim0_id, t2, t2b, t2bd, t2d, tb2, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7,
      tb7d, tb8, tb8d;

  for (i = t->nprim - 1; i >= 0; --i) {
    e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
    e0d = rd[t->primpa[i]][0] - rd[t->primpb[i]][0];
    e1 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
    e1d = rd[t->primpa[i]][1] - rd[t->primpb[i]][1];
    e2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
    e2d = rd[t->primpa[i]][2] - rd[t->primpb[i]][2];
    e0b = 0.0;
    e0bd = 0.0;
    e1b = 0.0;
    e1bd = 0.0;
    e2b = 0.0;
    e2bd = 0.0;
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
      e2b += resb[t->primrow[i] + 2];
      e2bd += resbd[t->primrow[i] + 2];
      resb[t->primrow[i] + 2] = 0.0;
      resbd[t->primrow[i] + 2] = 0.0;
      e1b += resb[t->primrow[i] + 1];
      e1bd += resbd[t->primrow[i] + 1];
      resb[t->primrow[i] + 1] = 0.0;
      resbd[t->primrow[i] + 1] = 0.0;
      e0b += resb[t->primrow[i]];
      e0bd += resbd[t->primrow[i]];
      resb[t->primrow[i]] = 0.0;
      resbd[t->primrow[i]] = 0.0;
    } else if (t->primkind[i] == MAGGI_PRIM_AXIS) {
      tb4 = resb[t->primrow[i] + 2];
      tb4d = resbd[t->primrow[i] + 2];
      resb[t->primrow[i] + 2] = 0.0;
      resbd[t->primrow[i] + 2] = 0.0;
      dirb[t->primda[i]][2] += tb4;
      dirbd[t->primda[i]][2] += tb4d;
      dirb[t->primdb[i]][2] -= tb4;
      dirbd[t->primdb[i]][2] -= tb4d;
      tb3 = resb[t->primrow[i] + 1];
      tb3d = resbd[t->primrow[i] + 1];
      resb[t->primrow[i] + 1] = 0.0;
      resbd[t->primrow[i] + 1] = 0.0;
      dirb[t->primda[i]][1] += tb3;
      dirbd[t->primda[i]][1] += tb3d;
      dirb[t->primdb[i]][1] -= tb3;
      dirbd[t->primdb[i]][1] -= tb3d;
      tb2 = resb[t->primrow[i]];
      tb2d = resbd[t->primrow[i]];
      resb[t->primrow[i]] = 0.0;
      resbd[t->primrow[i]] = 0.0;
      dirb[t->primda[i]][0] += tb2;
      dirbd[t->primda[i]][0] += tb2d;
      dirb[t->primdb[i]][0] -= tb2;
      dirbd[t->primdb[i]][0] -= tb2d;
    } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
      tb5 = resb[t->primrow[i]];
      tb5d = resbd[t->primrow[i]];
      resb[t->primrow[i]] = 0.0;
      resbd[t->primrow[i]] = 0.0;
      dirb[t->primda[i]][0] += tb5 * dir[t->primdb[i]][0];
      dirbd[t->primda[i]][0] += tb5d * dir[t->primdb[i]][0] + tb5 * dird[t->primdb[i]][0];
      dirb[t->primdb[i]][0] += tb5 * dir[t->primda[i]][0];
      dirbd[t->primdb[i]][0] += tb5d * dir[t->primda[i]][0] + tb5 * dird[t->primda[i]][0];
      dirb[t->primda[i]][1] += tb5 * dir[t->primdb[i]][1];
      dirbd[t->primda[i]][1] += tb5d * dir[t->primdb[i]][1] + tb5 * dird[t->primdb[i]][1];
      dirb[t->primdb[i]][1] += tb5 * dir[t->primda[i]][1];
      dirbd[t->primdb[i]][1] += tb5d * dir[t->primda[i]][1] + tb5 * dird[t->primda[i]][1];
      dirb[t->primda[i]][2] += tb5 * dir[t->primdb[i]][2];
      dirbd[t->primda[i]][2] += tb5d * dir[t->primdb[i]][2] + tb5 * dird[t->primdb[i]][2];
      dirb[t->primdb[i]][2] += tb5 * dir[t->primda[i]][2];
      dirbd[t->primdb[i]][2] += tb5d * dir[t->primda[i]][2] + tb5 * dird[t->primda[i]][2];
      prim0b[i] -= tb5;
      prim0bd[i] -= tb5d;
    } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
      tb6 = resb[t->primrow[i]];
      tb6d = resbd[t->primrow[i]];
      resb[t->primrow[i]] = 0.0;
      resbd[t->primrow[i]] = 0.0;
      e0b += tb6 * dir[t->primdb[i]][0];
      e0bd += tb6d * dir[t->primdb[i]][0] + tb6 * dird[t->primdb[i]][0];
      dirb[t->primdb[i]][0] += tb6 * e0;
      dirbd[t->primdb[i]][0] += tb6d * e0 + tb6 * e0d;
      e1b += tb6 * dir[t->primdb[i]][1];
      e1bd += tb6d * dir[t->primdb[i]][1] + tb6 * dird[t->primdb[i]][1];
      dirb[t->primdb[i]][1] += tb6 * e1;
      dirbd[t->primdb[i]][1] += tb6d * e1 + tb6 * e1d;
      e2b += tb6 * dir[t->primdb[i]][2];
      e2bd += tb6d * dir[t->primdb[i]][2] + tb6 * dird[t->primdb[i]][2];
      dirb[t->primdb[i]][2] += tb6 * e2;
      dirbd[t->primdb[i]][2] += tb6d * e2 + tb6 * e2d;
    } else {
      prim0_i = prim0[i];
      prim0_id = prim0d[i];
      t2 = 2.0 * prim0_i;
      t2d = 2.0 * prim0_id;
      tb7 = resb[t->primrow[i]];
      tb7d = resbd[t->primrow[i]];
      resb[t->primrow[i]] = 0.0;
      resbd[t->primrow[i]] = 0.0;
      tb8 = tb7 / t2;
      tb8d = (tb7d - tb8 * t2d) * (1.0 / t2);
      e0b += tb8 * e0;
      e0bd += tb8d * e0 + tb8 * e0d;
      e0b += tb8 * e0;
      e0bd += tb8d * e0 + tb8 * e0d;
      e1b += tb8 * e1;
      e1bd += tb8d * e1 + tb8 * e1d;
      e1b += tb8 * e1;
      e1bd += tb8d * e1 + tb8 * e1d;
      e2b += tb8 * e2;
      e2bd += tb8d * e2 + tb8 * e2d;
      e2b += tb8 * e2;
      e2bd += tb8d * e2 + tb8 * e2d;
      prim0_ib = -(tb8 * prim0_i);
      prim0_ibd = -(tb8d * prim0_i + tb8 * prim0_id);
      prim0_ib -= tb8 * prim0_i;
      prim0_ibd -= tb8d * prim0_i + tb8 * prim0_id;
      t2b = -(tb8 * res[t->primrow[i]]);
      t2bd = -(tb8d * res[t->primrow[i]] + tb8 * resd[t->primrow[i]]);
      prim0_ib += t2b * 2.0;
      prim0_ibd += t2bd * 2.0;
      prim0b[i] += prim0_ib;
      prim0bd[i] += prim0_ibd;
    }
    rb[t->primpa[i]][2] += e2b;
    rbd[t->primpa[i]][2] += e2bd;
    rb[t->primpb[i]][2] -= e2b;
    rbd[t->primpb[i]][2] -= e2bd;
    rb[t->primpa[i]][1] += e1b;
    rbd[t->primpa[i]][1] += e1bd;
    rb[t->primpb[i]][1] -= e1b;
    rbd[t->primpb[i]][1] -= e1bd;
    rb[t->primpa[i]][0] += e0b;
    rbd[t->primpa[i]][0] += e0bd;
    rb[t->primpb[i]][0] -= e0b;
    rbd[t->primpb[i]][0] -= e0bd;
  }
}

/* entries of the blocks of Phi_d; what the plan does not list is zero */
void maggi_loop_entries_b_d(const maggi_topo *t, const double prim0[restrict t->nprim],
                            const double prim0d[restrict t->nprim],
                            double prim0b[restrict t->nprim], double prim0bd[restrict t->nprim],
                            const double r[restrict t->npoint][3],
                            const double rd[restrict t->npoint][3],
                            double rb[restrict t->npoint][3], double rbd[restrict t->npoint][3],
                            const double dir[restrict t->ndir][3],
                            const double dird[restrict t->ndir][3],
                            double dirb[restrict t->ndir][3], double dirbd[restrict t->ndir][3],
                            const double b[restrict t->nbody][6],
                            const double bd[restrict t->nbody][6], double bb[restrict t->nbody][6],
                            double bbd[restrict t->nbody][6], double phi[restrict t->nphi],
                            double phid[restrict t->nphi], double phib[restrict t->nphi],
                            double phibd[restrict t->nphi])
{
  int i, k;
  double b_i3, b_i3_2, b_i3_2b, b_i3_2bd, b_i3_2d, b_i3_3, b_i3_3b, b_i3_3bd, b_i3_3d, b_i3_4,
      b_i3_4b, b_i3_4bd, b_i3_4d, b_i3_5, b_i3_5b, b_i3_5bd, b_i3_5d, b_i3b, b_i3bd, b_i3d, b_i4,
      b_i4_2, b_i4_2b, b_i4_2bd, b_i4_2d, b_i4_3, b_i4_3b, b_i4_3bd, b_i4_3d, b_i4_4, b_i4_4b,
      b_i4_4bd, b_i4_4d, b_i4_5, b_i4_5b, b_i4_5bd, b_i4_5d, b_i4b, b_i4bd, b_i4d, b_i5, b_i5_2,
      b_i5_2b, b_i5_2bd, b_i5_2d, b_i5_3, b_i5_3b, b_i5_3bd, b_i5_3d, b_i5_4, b_i5_4b, b_i5_4bd,
      b_i5_4d, b_i5_5, b_i5_5b, b_i5_5bd, b_i5_5d, b_i5b, b_i5bd, b_i5d, c0_2, c0_2b, c0_2bd, c0_2d,
      c0_3, c0_3b, c0_3bd, c0_3d, c0b, c0bd, c1_2, c1_2b, c1_2bd, c1_2d, c1_3, c1_3b, c1_3bd, c1_3d,
      c1b, c1bd, c2_2, c2_2b, c2_2bd, c2_2d, c2_3, c2_3b, c2_3bd, c2_3d, c2b, c2bd, dir_k0,
      dir_k0_2, dir_k0_2b, dir_k0_2bd, dir_k0_2d, dir_k0_3, dir_k0_3b, dir_k0_3bd, dir_k0_3d,
      dir_k0_4, dir_k0_4b, dir_k0_4bd, dir_k0_4d, dir_k0b, dir_k0bd, dir_k0d, dir_k1, dir_k1_2,
      dir_k1_2b, dir_k1_2bd, dir_k1_2d, dir_k1_3, dir_k1_3b, dir_k1_3bd, dir_k1_3d, dir_k1_4,
      dir_k1_4b, dir_k1_4bd, dir_k1_4d, dir_k1b, dir_k1bd, dir_k1d, dir_k2, dir_k2_2, dir_k2_2b,
      dir_k2_2bd, dir_k2_2d, dir_k2_3, dir_k2_3b, dir_k2_3bd, dir_k2_3d, dir_k2_4, dir_k2_4b,
      dir_k2_4bd, dir_k2_4d, dir_k2b, dir_k2bd, dir_k2d, e0b, e0bd, e1b, e1bd, e2b, e2bd, j0_2,
      j0_2b, j0_2bd, j0_2d, j0_3, j0_3b, j0_3bd, j0_3d, j0b, j0bd, j1_2, j1_2b, j1_2bd, j1_2d, j1_3,
      j1_3b, j1_3bd, j1_3d, j1b, j1bd, j2_2, j2_2b, j2_2bd, j2_2d, j2_3, j2_3b, j2_3bd, j2_3d, j2b,
      j2bd, r_k0, r_k0_2, r_k0_2b, r_k0_2bd, r_k0_2d, r_k0_3, r_k0_3b, r_k0_3bd, r_k0_3d, r_k0_4,
      r_k0_4b, r_k0_4bd, r_k0_4d, r_k0_5, r_k0_5b, r_k0_5bd, r_k0_5d, r_k0b, r_k0bd, r_k0d, r_k1,
      r_k1_2, r_k1_2b, r_k1_2bd, r_k1_2d, r_k1_3, r_k1_3b, r_k1_3bd, r_k1_3d, r_k1_4, r_k1_4b,
      r_k1_4bd, r_k1_4d, r_k1_5, r_k1_5b, r_k1_5bd, r_k1_5d, r_k1b, r_k1bd, r_k1d, r_k2, r_k2_2,
      r_k2_2b, r_k2_2bd, r_k2_2d, r_k2_3, r_k2_3b, r_k2_3bd, r_k2_3d, r_k2_4, r_k2_4b, r_k2_4bd,
      r_k2_4d, r_k2_5, r_k2_5b, r_k2_5bd, r_k2_5d, r_k2b, r_k2bd, r_k2d, s, t2, t2b, t2bd, t2d, tb2,
      tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d, w0, w0b, w0bd, w0d, w1, w1b, w1bd, w1d, w2, w2b, w2bd,
      w2d;

  (void)phi;
  (void)phid;
  for (i = t->nent - 1; i >= 0; --i) {
    k = t->entprim[i];
    s = t->entside[i] == 0 ? 1.0 : -1.0;
    w0 = b[t->qbody[t->entq[i]]][3];
    w0d = bd[t->qbody[t->entq[i]]][3];
    w1 = b[t->qbody[t->entq[i]]][4];
    w1d = bd[t->qbody[t->entq[i]]][4];
    w2 = b[t->qbody[t->entq[i]]][5];
    w2d = bd[t->qbody[t->entq[i]]][5];
    e1b = 0.0;
    e1bd = 0.0;
    e2b = 0.0;
    e2bd = 0.0;
    if (t->primkind[k] == MAGGI_PRIM_POINT || t->primkind[k] == MAGGI_PRIM_AXIS) {
      e2b += phib[t->entadr[i] + 2 * t->entstep[i]];
      e2bd += phibd[t->entadr[i] + 2 * t->entstep[i]];
      phib[t->entadr[i] + 2 * t->entstep[i]] = 0.0;
      phibd[t->entadr[i] + 2 * t->entstep[i]] = 0.0;
      e1b += phib[t->entadr[i] + t->entstep[i]];
      e1bd += phibd[t->entadr[i] + t->entstep[i]];
      phib[t->entadr[i] + t->entstep[i]] = 0.0;
      phibd[t->entadr[i] + t->entstep[i]] = 0.0;
    }
    e0b = phib[t->entadr[i]];
    e0bd = phibd[t->entadr[i]];
    phib[t->entadr[i]] = 0.0;
    phibd[t->entadr[i]] = 0.0;
    w0b = 0.0;
    w0bd = 0.0;
    w1b = 0.0;
    w1bd = 0.0;
    w2b = 0.0;
    w2bd = 0.0;
    if (t->primkind[k] == MAGGI_PRIM_POINT) {
      j2b = e2b * s;
      j2bd = e2bd * s;
      e2b = 0.0;
      e2bd = 0.0;
      j1b = e1b * s;
      j1bd = e1bd * s;
      e1b = 0.0;
      e1bd = 0.0;
      j0b = e0b * s;
      j0bd = e0bd * s;
      e0b = 0.0;
      e0bd = 0.0;
      if (t->entside[i] == 0) {
        b_i4 = b[t->qbody[t->entq[i]]][4];
        b_i4d = bd[t->qbody[t->entq[i]]][4];
        r_k2 = r[t->primpa[k]][2];
        r_k2d = rd[t->primpa[k]][2];
        b_i5 = b[t->qbody[t->entq[i]]][5];
        b_i5d = bd[t->qbody[t->entq[i]]][5];
        r_k1 = r[t->primpa[k]][1];
        r_k1d = rd[t->primpa[k]][1];
        r_k0 = r[t->primpa[k]][0];
        r_k0d = rd[t->primpa[k]][0];
        b_i3 = b[t->qbody[t->entq[i]]][3];
        b_i3d = bd[t->qbody[t->entq[i]]][3];
        bb[t->qbody[t->entq[i]]][2] += j2b;
        bbd[t->qbody[t->entq[i]]][2] += j2bd;
        b_i3b = j2b * r_k1;
        b_i3bd = j2bd * r_k1 + j2b * r_k1d;
        r_k1b = j2b * b_i3;
        r_k1bd = j2bd * b_i3 + j2b * b_i3d;
        b_i4b = -(j2b * r_k0);
        b_i4bd = -(j2bd * r_k0 + j2b * r_k0d);
        r_k0b = -(j2b * b_i4);
        r_k0bd = -(j2bd * b_i4 + j2b * b_i4d);
        j2b = 0.0;
        j2bd = 0.0;
        bb[t->qbody[t->entq[i]]][1] += j1b;
        bbd[t->qbody[t->entq[i]]][1] += j1bd;
        b_i5b = j1b * r_k0;
        b_i5bd = j1bd * r_k0 + j1b * r_k0d;
        r_k0b += j1b * b_i5;
        r_k0bd += j1bd * b_i5 + j1b * b_i5d;
        b_i3b -= j1b * r_k2;
        b_i3bd -= j1bd * r_k2 + j1b * r_k2d;
        r_k2b = -(j1b * b_i3);
        r_k2bd = -(j1bd * b_i3 + j1b * b_i3d);
        j1b = 0.0;
        j1bd = 0.0;
        bb[t->qbody[t->entq[i]]][3] += b_i3b;
        bbd[t->qbody[t->entq[i]]][3] += b_i3bd;
        rb[t->primpa[k]][0] += r_k0b;
        rbd[t->primpa[k]][0] += r_k0bd;
        bb[t->qbody[t->entq[i]]][0] += j0b;
        bbd[t->qbody[t->entq[i]]][0] += j0bd;
        b_i4b += j0b * r_k2;
        b_i4bd += j0bd * r_k2 + j0b * r_k2d;
        r_k2b += j0b * b_i4;
        r_k2bd += j0bd * b_i4 + j0b * b_i4d;
        b_i5b -= j0b * r_k1;
        b_i5bd -= j0bd * r_k1 + j0b * r_k1d;
        r_k1b -= j0b * b_i5;
        r_k1bd -= j0bd * b_i5 + j0b * b_i5d;
        j0b = 0.0;
        j0bd = 0.0;
        rb[t->primpa[k]][1] += r_k1b;
        rbd[t->primpa[k]][1] += r_k1bd;
        bb[t->qbody[t->entq[i]]][5] += b_i5b;
        bbd[t->qbody[t->entq[i]]][5] += b_i5bd;
        rb[t->primpa[k]][2] += r_k2b;
        rbd[t->primpa[k]][2] += r_k2bd;
        bb[t->qbody[t->entq[i]]][4] += b_i4b;
        bbd[t->qbody[t->entq[i]]][4] += b_i4bd;
      } else {
        b_i4_2 = b[t->qbody[t->entq[i]]][4];
        b_i4_2d = bd[t->qbody[t->entq[i]]][4];
        r_k2_2 = r[t->primpb[k]][2];
        r_k2_2d = rd[t->primpb[k]][2];
        b_i5_2 = b[t->qbody[t->entq[i]]][5];
        b_i5_2d = bd[t->qbody[t->entq[i]]][5];
        r_k1_2 = r[t->primpb[k]][1];
        r_k1_2d = rd[t->primpb[k]][1];
        r_k0_2 = r[t->primpb[k]][0];
        r_k0_2d = rd[t->primpb[k]][0];
        b_i3_2 = b[t->qbody[t->entq[i]]][3];
        b_i3_2d = bd[t->qbody[t->entq[i]]][3];
        bb[t->qbody[t->entq[i]]][2] += j2b;
        bbd[t->qbody[t->entq[i]]][2] += j2bd;
        b_i3_2b = j2b * r_k1_2;
        b_i3_2bd = j2bd * r_k1_2 + j2b * r_k1_2d;
        r_k1_2b = j2b * b_i3_2;
        r_k1_2bd = j2bd * b_i3_2 + j2b * b_i3_2d;
        b_i4_2b = -(j2b * r_k0_2);
        b_i4_2bd = -(j2bd * r_k0_2 + j2b * r_k0_2d);
        r_k0_2b = -(j2b * b_i4_2);
        r_k0_2bd = -(j2bd * b_i4_2 + j2b * b_i4_2d);
        j2b = 0.0;
        j2bd = 0.0;
        bb[t->qbody[t->entq[i]]][1] += j1b;
        bbd[t->qbody[t->entq[i]]][1] += j1bd;
        b_i5_2b = j1b * r_k0_2;
        b_i5_2bd = j1bd * r_k0_2 + j1b * r_k0_2d;
        r_k0_2b += j1b * b_i5_2;
        r_k0_2bd += j1bd * b_i5_2 + j1b * b_i5_2d;
        b_i3_2b -= j1b * r_k2_2;
        b_i3_2bd -= j1bd * r_k2_2 + j1b * r_k2_2d;
        r_k2_2b = -(j1b * b_i3_2);
        r_k2_2bd = -(j1bd * b_i3_2 + j1b * b_i3_2d);
        j1b = 0.0;
        j1bd = 0.0;
        bb[t->qbody[t->entq[i]]][3] += b_i3_2b;
        bbd[t->qbody[t->entq[i]]][3] += b_i3_2bd;
        rb[t->primpb[k]][0] += r_k0_2b;
        rbd[t->primpb[k]][0] += r_k0_2bd;
        bb[t->qbody[t->entq[i]]][0] += j0b;
        bbd[t->qbody[t->entq[i]]][0] += j0bd;
        b_i4_2b += j0b * r_k2_2;
        b_i4_2bd += j0bd * r_k2_2 + j0b * r_k2_2d;
        r_k2_2b += j0b * b_i4_2;
        r_k2_2bd += j0bd * b_i4_2 + j0b * b_i4_2d;
        b_i5_2b -= j0b * r_k1_2;
        b_i5_2bd -= j0bd * r_k1_2 + j0b * r_k1_2d;
        r_k1_2b -= j0b * b_i5_2;
        r_k1_2bd -= j0bd * b_i5_2 + j0b * b_i5_2d;
        j0b = 0.0;
        j0bd = 0.0;
        rb[t->primpb[k]][1] += r_k1_2b;
        rbd[t->primpb[k]][1] += r_k1_2bd;
        bb[t->qbody[t->entq[i]]][5] += b_i5_2b;
        bbd[t->qbody[t->entq[i]]][5] += b_i5_2bd;
        rb[t->primpb[k]][2] += r_k2_2b;
        rbd[t->primpb[k]][2] += r_k2_2bd;
        bb[t->qbody[t->entq[i]]][4] += b_i4_2b;
        bbd[t->qbody[t->entq[i]]][4] += b_i4_2bd;
      }
    } else if (t->primkind[k] == MAGGI_PRIM_AXIS) {
      c2b = e2b * s;
      c2bd = e2bd * s;
      e2b = 0.0;
      e2bd = 0.0;
      c1b = e1b * s;
      c1bd = e1bd * s;
      e1b = 0.0;
      e1bd = 0.0;
      c0b = e0b * s;
      c0bd = e0bd * s;
      e0b = 0.0;
      e0bd = 0.0;
      if (t->entside[i] == 0) {
        dir_k2 = dir[t->primda[k]][2];
        dir_k2d = dird[t->primda[k]][2];
        dir_k1 = dir[t->primda[k]][1];
        dir_k1d = dird[t->primda[k]][1];
        dir_k0 = dir[t->primda[k]][0];
        dir_k0d = dird[t->primda[k]][0];
        w0b += c2b * dir_k1;
        w0bd += c2bd * dir_k1 + c2b * dir_k1d;
        dir_k1b = c2b * w0;
        dir_k1bd = c2bd * w0 + c2b * w0d;
        w1b -= c2b * dir_k0;
        w1bd -= c2bd * dir_k0 + c2b * dir_k0d;
        dir_k0b = -(c2b * w1);
        dir_k0bd = -(c2bd * w1 + c2b * w1d);
        c2b = 0.0;
        c2bd = 0.0;
        w2b += c1b * dir_k0;
        w2bd += c1bd * dir_k0 + c1b * dir_k0d;
        dir_k0b += c1b * w2;
        dir_k0bd += c1bd * w2 + c1b * w2d;
        w0b -= c1b * dir_k2;
        w0bd -= c1bd * dir_k2 + c1b * dir_k2d;
        dir_k2b = -(c1b * w0);
        dir_k2bd = -(c1bd * w0 + c1b * w0d);
        c1b = 0.0;
        c1bd = 0.0;
        dirb[t->primda[k]][0] += dir_k0b;
        dirbd[t->primda[k]][0] += dir_k0bd;
        w1b += c0b * dir_k2;
        w1bd += c0bd * dir_k2 + c0b * dir_k2d;
        dir_k2b += c0b * w1;
        dir_k2bd += c0bd * w1 + c0b * w1d;
        w2b -= c0b * dir_k1;
        w2bd -= c0bd * dir_k1 + c0b * dir_k1d;
        dir_k1b -= c0b * w2;
        dir_k1bd -= c0bd * w2 + c0b * w2d;
        c0b = 0.0;
        c0bd = 0.0;
        dirb[t->primda[k]][1] += dir_k1b;
        dirbd[t->primda[k]][1] += dir_k1bd;
        dirb[t->primda[k]][2] += dir_k2b;
        dirbd[t->primda[k]][2] += dir_k2bd;
      } else {
        dir_k2_2 = dir[t->primdb[k]][2];
        dir_k2_2d = dird[t->primdb[k]][2];
        dir_k1_2 = dir[t->primdb[k]][1];
        dir_k1_2d = dird[t->primdb[k]][1];
        dir_k0_2 = dir[t->primdb[k]][0];
        dir_k0_2d = dird[t->primdb[k]][0];
        w0b += c2b * dir_k1_2;
        w0bd += c2bd * dir_k1_2 + c2b * dir_k1_2d;
        dir_k1_2b = c2b * w0;
        dir_k1_2bd = c2bd * w0 + c2b * w0d;
        w1b -= c2b * dir_k0_2;
        w1bd -= c2bd * dir_k0_2 + c2b * dir_k0_2d;
        dir_k0_2b = -(c2b * w1);
        dir_k0_2bd = -(c2bd * w1 + c2b * w1d);
        c2b = 0.0;
        c2bd = 0.0;
        w2b += c1b * dir_k0_2;
        w2bd += c1bd * dir_k0_2 + c1b * dir_k0_2d;
        dir_k0_2b += c1b * w2;
        dir_k0_2bd += c1bd * w2 + c1b * w2d;
        w0b -= c1b * dir_k2_2;
        w0bd -= c1bd * dir_k2_2 + c1b * dir_k2_2d;
        dir_k2_2b = -(c1b * w0);
        dir_k2_2bd = -(c1bd * w0 + c1b * w0d);
        c1b = 0.0;
        c1bd = 0.0;
        dirb[t->primdb[k]][0] += dir_k0_2b;
        dirbd[t->primdb[k]][0] += dir_k0_2bd;
        w1b += c0b * dir_k2_2;
        w1bd += c0bd * dir_k2_2 + c0b * dir_k2_2d;
        dir_k2_2b += c0b * w1;
        dir_k2_2bd += c0bd * w1 + c0b * w1d;
        w2b -= c0b * dir_k1_2;
        w2bd -= c0bd * dir_k1_2 + c0b * dir_k1_2d;
        dir_k1_2b -= c0b * w2;
        dir_k1_2bd -= c0bd * w2 + c0b * w2d;
        c0b = 0.0;
        c0bd = 0.0;
        dirb[t->primdb[k]][1] += dir_k1_2b;
        dirbd[t->primdb[k]][1] += dir_k1_2bd;
        dirb[t->primdb[k]][2] += dir_k2_2b;
        dirbd[t->primdb[k]][2] += dir_k2_2bd;
      }
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
      e2b = 0.0;
      e2bd = 0.0;
      e1b = 0.0;
      e1bd = 0.0;
      tb2 = e0b * s;
      tb2d = e0bd * s;
      w0b += tb2 * c0_2;
      w0bd += tb2d * c0_2 + tb2 * c0_2d;
      c0_2b = tb2 * w0;
      c0_2bd = tb2d * w0 + tb2 * w0d;
      w1b += tb2 * c1_2;
      w1bd += tb2d * c1_2 + tb2 * c1_2d;
      c1_2b = tb2 * w1;
      c1_2bd = tb2d * w1 + tb2 * w1d;
      w2b += tb2 * c2_2;
      w2bd += tb2d * c2_2 + tb2 * c2_2d;
      c2_2b = tb2 * w2;
      c2_2bd = tb2d * w2 + tb2 * w2d;
      e0b = 0.0;
      e0bd = 0.0;
      dir_k0_4b = c2_2b * dir_k1_4;
      dir_k0_4bd = c2_2bd * dir_k1_4 + c2_2b * dir_k1_4d;
      dir_k1_4b = c2_2b * dir_k0_4;
      dir_k1_4bd = c2_2bd * dir_k0_4 + c2_2b * dir_k0_4d;
      dir_k1_3b = -(c2_2b * dir_k0_3);
      dir_k1_3bd = -(c2_2bd * dir_k0_3 + c2_2b * dir_k0_3d);
      dir_k0_3b = -(c2_2b * dir_k1_3);
      dir_k0_3bd = -(c2_2bd * dir_k1_3 + c2_2b * dir_k1_3d);
      dir_k2_4b = c1_2b * dir_k0_3;
      dir_k2_4bd = c1_2bd * dir_k0_3 + c1_2b * dir_k0_3d;
      dir_k0_3b += c1_2b * dir_k2_4;
      dir_k0_3bd += c1_2bd * dir_k2_4 + c1_2b * dir_k2_4d;
      dir_k0_4b -= c1_2b * dir_k2_3;
      dir_k0_4bd -= c1_2bd * dir_k2_3 + c1_2b * dir_k2_3d;
      dir_k2_3b = -(c1_2b * dir_k0_4);
      dir_k2_3bd = -(c1_2bd * dir_k0_4 + c1_2b * dir_k0_4d);
      dirb[t->primda[k]][0] += dir_k0_4b;
      dirbd[t->primda[k]][0] += dir_k0_4bd;
      dirb[t->primdb[k]][0] += dir_k0_3b;
      dirbd[t->primdb[k]][0] += dir_k0_3bd;
      dir_k1_3b += c0_2b * dir_k2_3;
      dir_k1_3bd += c0_2bd * dir_k2_3 + c0_2b * dir_k2_3d;
      dir_k2_3b += c0_2b * dir_k1_3;
      dir_k2_3bd += c0_2bd * dir_k1_3 + c0_2b * dir_k1_3d;
      dir_k2_4b -= c0_2b * dir_k1_4;
      dir_k2_4bd -= c0_2bd * dir_k1_4 + c0_2b * dir_k1_4d;
      dir_k1_4b -= c0_2b * dir_k2_4;
      dir_k1_4bd -= c0_2bd * dir_k2_4 + c0_2b * dir_k2_4d;
      dirb[t->primdb[k]][1] += dir_k1_4b;
      dirbd[t->primdb[k]][1] += dir_k1_4bd;
      dirb[t->primda[k]][2] += dir_k2_4b;
      dirbd[t->primda[k]][2] += dir_k2_4bd;
      dirb[t->primdb[k]][2] += dir_k2_3b;
      dirbd[t->primdb[k]][2] += dir_k2_3bd;
      dirb[t->primda[k]][1] += dir_k1_3b;
      dirbd[t->primda[k]][1] += dir_k1_3bd;
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
      e2b = 0.0;
      e2bd = 0.0;
      e1b = 0.0;
      e1bd = 0.0;
      tb3 = e0b * s;
      tb3d = e0bd * s;
      dirb[t->primdb[k]][0] += tb3 * j0_2;
      dirbd[t->primdb[k]][0] += tb3d * j0_2 + tb3 * j0_2d;
      j0_2b = tb3 * dir[t->primdb[k]][0];
      j0_2bd = tb3d * dir[t->primdb[k]][0] + tb3 * dird[t->primdb[k]][0];
      dirb[t->primdb[k]][1] += tb3 * j1_2;
      dirbd[t->primdb[k]][1] += tb3d * j1_2 + tb3 * j1_2d;
      j1_2b = tb3 * dir[t->primdb[k]][1];
      j1_2bd = tb3d * dir[t->primdb[k]][1] + tb3 * dird[t->primdb[k]][1];
      dirb[t->primdb[k]][2] += tb3 * j2_2;
      dirbd[t->primdb[k]][2] += tb3d * j2_2 + tb3 * j2_2d;
      j2_2b = tb3 * dir[t->primdb[k]][2];
      j2_2bd = tb3d * dir[t->primdb[k]][2] + tb3 * dird[t->primdb[k]][2];
      e0b = 0.0;
      e0bd = 0.0;
      bb[t->qbody[t->entq[i]]][2] += j2_2b;
      bbd[t->qbody[t->entq[i]]][2] += j2_2bd;
      b_i3_3b = j2_2b * r_k1_3;
      b_i3_3bd = j2_2bd * r_k1_3 + j2_2b * r_k1_3d;
      r_k1_3b = j2_2b * b_i3_3;
      r_k1_3bd = j2_2bd * b_i3_3 + j2_2b * b_i3_3d;
      b_i4_3b = -(j2_2b * r_k0_3);
      b_i4_3bd = -(j2_2bd * r_k0_3 + j2_2b * r_k0_3d);
      r_k0_3b = -(j2_2b * b_i4_3);
      r_k0_3bd = -(j2_2bd * b_i4_3 + j2_2b * b_i4_3d);
      bb[t->qbody[t->entq[i]]][1] += j1_2b;
      bbd[t->qbody[t->entq[i]]][1] += j1_2bd;
      b_i5_3b = j1_2b * r_k0_3;
      b_i5_3bd = j1_2bd * r_k0_3 + j1_2b * r_k0_3d;
      r_k0_3b += j1_2b * b_i5_3;
      r_k0_3bd += j1_2bd * b_i5_3 + j1_2b * b_i5_3d;
      b_i3_3b -= j1_2b * r_k2_3;
      b_i3_3bd -= j1_2bd * r_k2_3 + j1_2b * r_k2_3d;
      r_k2_3b = -(j1_2b * b_i3_3);
      r_k2_3bd = -(j1_2bd * b_i3_3 + j1_2b * b_i3_3d);
      bb[t->qbody[t->entq[i]]][3] += b_i3_3b;
      bbd[t->qbody[t->entq[i]]][3] += b_i3_3bd;
      rb[t->primpa[k]][0] += r_k0_3b;
      rbd[t->primpa[k]][0] += r_k0_3bd;
      bb[t->qbody[t->entq[i]]][0] += j0_2b;
      bbd[t->qbody[t->entq[i]]][0] += j0_2bd;
      b_i4_3b += j0_2b * r_k2_3;
      b_i4_3bd += j0_2bd * r_k2_3 + j0_2b * r_k2_3d;
      r_k2_3b += j0_2b * b_i4_3;
      r_k2_3bd += j0_2bd * b_i4_3 + j0_2b * b_i4_3d;
      b_i5_3b -= j0_2b * r_k1_3;
      b_i5_3bd -= j0_2bd * r_k1_3 + j0_2b * r_k1_3d;
      r_k1_3b -= j0_2b * b_i5_3;
      r_k1_3bd -= j0_2bd * b_i5_3 + j0_2b * b_i5_3d;
      rb[t->primpa[k]][1] += r_k1_3b;
      rbd[t->primpa[k]][1] += r_k1_3bd;
      bb[t->qbody[t->entq[i]]][5] += b_i5_3b;
      bbd[t->qbody[t->entq[i]]][5] += b_i5_3bd;
      rb[t->primpa[k]][2] += r_k2_3b;
      rbd[t->primpa[k]][2] += r_k2_3bd;
      bb[t->qbody[t->entq[i]]][4] += b_i4_3b;
      bbd[t->qbody[t->entq[i]]][4] += b_i4_3bd;
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
      t2d = (s * (c0_3d * j0_3 + c0_3 * j0_3d + (c1_3d * j1_3 + c1_3 * j1_3d) + (c2_3d * j2_3 + c2_3
          * j2_3d)) - t2 * prim0d[k]) * (1.0 / prim0[k]);
      e2b = 0.0;
      e2bd = 0.0;
      e1b = 0.0;
      e1bd = 0.0;
      t2b = e0b;
      t2bd = e0bd;
      e0b = 0.0;
      e0bd = 0.0;
      tb4 = t2b / prim0[k];
      tb4d = (t2bd - tb4 * prim0d[k]) * (1.0 / prim0[k]);
      tb5 = tb4 * s;
      tb5d = tb4d * s;
      c0_3b = tb5 * j0_3;
      c0_3bd = tb5d * j0_3 + tb5 * j0_3d;
      j0_3b = tb5 * c0_3;
      j0_3bd = tb5d * c0_3 + tb5 * c0_3d;
      c1_3b = tb5 * j1_3;
      c1_3bd = tb5d * j1_3 + tb5 * j1_3d;
      j1_3b = tb5 * c1_3;
      j1_3bd = tb5d * c1_3 + tb5 * c1_3d;
      c2_3b = tb5 * j2_3;
      c2_3bd = tb5d * j2_3 + tb5 * j2_3d;
      j2_3b = tb5 * c2_3;
      j2_3bd = tb5d * c2_3 + tb5 * c2_3d;
      prim0b[k] -= tb4 * t2;
      prim0bd[k] -= tb4d * t2 + tb4 * t2d;
      rb[t->primpa[k]][2] += c2_3b;
      rbd[t->primpa[k]][2] += c2_3bd;
      rb[t->primpb[k]][2] -= c2_3b;
      rbd[t->primpb[k]][2] -= c2_3bd;
      rb[t->primpa[k]][1] += c1_3b;
      rbd[t->primpa[k]][1] += c1_3bd;
      rb[t->primpb[k]][1] -= c1_3b;
      rbd[t->primpb[k]][1] -= c1_3bd;
      rb[t->primpa[k]][0] += c0_3b;
      rbd[t->primpa[k]][0] += c0_3bd;
      rb[t->primpb[k]][0] -= c0_3b;
      rbd[t->primpb[k]][0] -= c0_3bd;
      if (t->entside[i] == 0) {
        b_i4_4 = b[t->qbody[t->entq[i]]][4];
        b_i4_4d = bd[t->qbody[t->entq[i]]][4];
        r_k2_4 = r[t->primpa[k]][2];
        r_k2_4d = rd[t->primpa[k]][2];
        b_i5_4 = b[t->qbody[t->entq[i]]][5];
        b_i5_4d = bd[t->qbody[t->entq[i]]][5];
        r_k1_4 = r[t->primpa[k]][1];
        r_k1_4d = rd[t->primpa[k]][1];
        r_k0_4 = r[t->primpa[k]][0];
        r_k0_4d = rd[t->primpa[k]][0];
        b_i3_4 = b[t->qbody[t->entq[i]]][3];
        b_i3_4d = bd[t->qbody[t->entq[i]]][3];
        bb[t->qbody[t->entq[i]]][2] += j2_3b;
        bbd[t->qbody[t->entq[i]]][2] += j2_3bd;
        b_i3_4b = j2_3b * r_k1_4;
        b_i3_4bd = j2_3bd * r_k1_4 + j2_3b * r_k1_4d;
        r_k1_4b = j2_3b * b_i3_4;
        r_k1_4bd = j2_3bd * b_i3_4 + j2_3b * b_i3_4d;
        b_i4_4b = -(j2_3b * r_k0_4);
        b_i4_4bd = -(j2_3bd * r_k0_4 + j2_3b * r_k0_4d);
        r_k0_4b = -(j2_3b * b_i4_4);
        r_k0_4bd = -(j2_3bd * b_i4_4 + j2_3b * b_i4_4d);
        j2_3b = 0.0;
        j2_3bd = 0.0;
        bb[t->qbody[t->entq[i]]][1] += j1_3b;
        bbd[t->qbody[t->entq[i]]][1] += j1_3bd;
        b_i5_4b = j1_3b * r_k0_4;
        b_i5_4bd = j1_3bd * r_k0_4 + j1_3b * r_k0_4d;
        r_k0_4b += j1_3b * b_i5_4;
        r_k0_4bd += j1_3bd * b_i5_4 + j1_3b * b_i5_4d;
        b_i3_4b -= j1_3b * r_k2_4;
        b_i3_4bd -= j1_3bd * r_k2_4 + j1_3b * r_k2_4d;
        r_k2_4b = -(j1_3b * b_i3_4);
        r_k2_4bd = -(j1_3bd * b_i3_4 + j1_3b * b_i3_4d);
        j1_3b = 0.0;
        j1_3bd = 0.0;
        bb[t->qbody[t->entq[i]]][3] += b_i3_4b;
        bbd[t->qbody[t->entq[i]]][3] += b_i3_4bd;
        rb[t->primpa[k]][0] += r_k0_4b;
        rbd[t->primpa[k]][0] += r_k0_4bd;
        bb[t->qbody[t->entq[i]]][0] += j0_3b;
        bbd[t->qbody[t->entq[i]]][0] += j0_3bd;
        b_i4_4b += j0_3b * r_k2_4;
        b_i4_4bd += j0_3bd * r_k2_4 + j0_3b * r_k2_4d;
        r_k2_4b += j0_3b * b_i4_4;
        r_k2_4bd += j0_3bd * b_i4_4 + j0_3b * b_i4_4d;
        b_i5_4b -= j0_3b * r_k1_4;
        b_i5_4bd -= j0_3bd * r_k1_4 + j0_3b * r_k1_4d;
        r_k1_4b -= j0_3b * b_i5_4;
        r_k1_4bd -= j0_3bd * b_i5_4 + j0_3b * b_i5_4d;
        j0_3b = 0.0;
        j0_3bd = 0.0;
        rb[t->primpa[k]][1] += r_k1_4b;
        rbd[t->primpa[k]][1] += r_k1_4bd;
        bb[t->qbody[t->entq[i]]][5] += b_i5_4b;
        bbd[t->qbody[t->entq[i]]][5] += b_i5_4bd;
        rb[t->primpa[k]][2] += r_k2_4b;
        rbd[t->primpa[k]][2] += r_k2_4bd;
        bb[t->qbody[t->entq[i]]][4] += b_i4_4b;
        bbd[t->qbody[t->entq[i]]][4] += b_i4_4bd;
      } else {
        b_i4_5 = b[t->qbody[t->entq[i]]][4];
        b_i4_5d = bd[t->qbody[t->entq[i]]][4];
        r_k2_5 = r[t->primpb[k]][2];
        r_k2_5d = rd[t->primpb[k]][2];
        b_i5_5 = b[t->qbody[t->entq[i]]][5];
        b_i5_5d = bd[t->qbody[t->entq[i]]][5];
        r_k1_5 = r[t->primpb[k]][1];
        r_k1_5d = rd[t->primpb[k]][1];
        r_k0_5 = r[t->primpb[k]][0];
        r_k0_5d = rd[t->primpb[k]][0];
        b_i3_5 = b[t->qbody[t->entq[i]]][3];
        b_i3_5d = bd[t->qbody[t->entq[i]]][3];
        bb[t->qbody[t->entq[i]]][2] += j2_3b;
        bbd[t->qbody[t->entq[i]]][2] += j2_3bd;
        b_i3_5b = j2_3b * r_k1_5;
        b_i3_5bd = j2_3bd * r_k1_5 + j2_3b * r_k1_5d;
        r_k1_5b = j2_3b * b_i3_5;
        r_k1_5bd = j2_3bd * b_i3_5 + j2_3b * b_i3_5d;
        b_i4_5b = -(j2_3b * r_k0_5);
        b_i4_5bd = -(j2_3bd * r_k0_5 + j2_3b * r_k0_5d);
        r_k0_5b = -(j2_3b * b_i4_5);
        r_k0_5bd = -(j2_3bd * b_i4_5 + j2_3b * b_i4_5d);
        j2_3b = 0.0;
        j2_3bd = 0.0;
        bb[t->qbody[t->entq[i]]][1] += j1_3b;
        bbd[t->qbody[t->entq[i]]][1] += j1_3bd;
        b_i5_5b = j1_3b * r_k0_5;
        b_i5_5bd = j1_3bd * r_k0_5 + j1_3b * r_k0_5d;
        r_k0_5b += j1_3b * b_i5_5;
        r_k0_5bd += j1_3bd * b_i5_5 + j1_3b * b_i5_5d;
        b_i3_5b -= j1_3b * r_k2_5;
        b_i3_5bd -= j1_3bd * r_k2_5 + j1_3b * r_k2_5d;
        r_k2_5b = -(j1_3b * b_i3_5);
        r_k2_5bd = -(j1_3bd * b_i3_5 + j1_3b * b_i3_5d);
        j1_3b = 0.0;
        j1_3bd = 0.0;
        bb[t->qbody[t->entq[i]]][3] += b_i3_5b;
        bbd[t->qbody[t->entq[i]]][3] += b_i3_5bd;
        rb[t->primpb[k]][0] += r_k0_5b;
        rbd[t->primpb[k]][0] += r_k0_5bd;
        bb[t->qbody[t->entq[i]]][0] += j0_3b;
        bbd[t->qbody[t->entq[i]]][0] += j0_3bd;
        b_i4_5b += j0_3b * r_k2_5;
        b_i4_5bd += j0_3bd * r_k2_5 + j0_3b * r_k2_5d;
        r_k2_5b += j0_3b * b_i4_5;
        r_k2_5bd += j0_3bd * b_i4_5 + j0_3b * b_i4_5d;
        b_i5_5b -= j0_3b * r_k1_5;
        b_i5_5bd -= j0_3bd * r_k1_5 + j0_3b * r_k1_5d;
        r_k1_5b -= j0_3b * b_i5_5;
        r_k1_5bd -= j0_3bd * b_i5_5 + j0_3b * b_i5_5d;
        j0_3b = 0.0;
        j0_3bd = 0.0;
        rb[t->primpb[k]][1] += r_k1_5b;
        rbd[t->primpb[k]][1] += r_k1_5bd;
        bb[t->qbody[t->entq[i]]][5] += b_i5_5b;
        bbd[t->qbody[t->entq[i]]][5] += b_i5_5bd;
        rb[t->primpb[k]][2] += r_k2_5b;
        rbd[t->primpb[k]][2] += r_k2_5bd;
        bb[t->qbody[t->entq[i]]][4] += b_i4_5b;
        bbd[t->qbody[t->entq[i]]][4] += b_i4_5bd;
      }
    }
    bb[t->qbody[t->entq[i]]][5] += w2b;
    bbd[t->qbody[t->entq[i]]][5] += w2bd;
    bb[t->qbody[t->entq[i]]][4] += w1b;
    bbd[t->qbody[t->entq[i]]][4] += w1bd;
    bb[t->qbody[t->entq[i]]][3] += w0b;
    bbd[t->qbody[t->entq[i]]][3] += w0bd;
  }
}

void maggi_loop_rates_b_d(const maggi_topo *t, const double prim0[restrict t->nprim],
                          const double prim0d[restrict t->nprim], double prim0b[restrict t->nprim],
                          double prim0bd[restrict t->nprim], const double r[restrict t->npoint][3],
                          const double rd[restrict t->npoint][3], double rb[restrict t->npoint][3],
                          double rbd[restrict t->npoint][3], const double dir[restrict t->ndir][3],
                          const double dird[restrict t->ndir][3], double dirb[restrict t->ndir][3],
                          double dirbd[restrict t->ndir][3], const double rv[restrict t->npoint][3],
                          const double rvd[restrict t->npoint][3],
                          double rvb[restrict t->npoint][3], double rvbd[restrict t->npoint][3],
                          const double Z[restrict t->nbody + 1][6],
                          const double Zd[restrict t->nbody + 1][6],
                          double Zb[restrict t->nbody + 1][6], double Zbd[restrict t->nbody + 1][6],
                          double rate[restrict t->nrow], double rated[restrict t->nrow],
                          double rateb[restrict t->nrow], double ratebd[restrict t->nrow])
{
  int c, i, i2;
  double da10, da10b, da10bd, da10d, da11, da11b, da11bd, da11d, da12, da12b, da12bd, da12d, db10,
      db10b, db10bd, db10d, db11, db11b, db11bd, db11d, db12, db12b, db12bd, db12d, dir_i0,
      dir_i0_2, dir_i0_2b, dir_i0_2bd, dir_i0_2d, dir_i0b, dir_i0bd, dir_i0d, dir_i1, dir_i1_2,
      dir_i1_2b, dir_i1_2bd, dir_i1_2d, dir_i1b, dir_i1bd, dir_i1d, dir_i2, dir_i2_2, dir_i2_2b,
      dir_i2_2bd, dir_i2_2d, dir_i2b, dir_i2bd, dir_i2d, e0, e0b, e0bd, e0d, e10b, e10bd, e11b,
      e11bd, e12b, e12bd, e1_3, e1_3b, e1_3bd, e1_3d, e1_4b, e1_4bd, e1_5b, e1_5bd, e1_6b, e1_6bd,
      e20, e20b, e20bd, e20d, e21, e21b, e21bd, e21d, e22, e22b, e22bd, e22d, e2_2, e2_2b, e2_2bd,
      e2_2d, e30, e30b, e30bd, e30d, e31, e31b, e31bd, e31d, e32, e32b, e32bd, e32d, ev0, ev0b,
      ev0bd, ev0d, ev1, ev1b, ev1bd, ev1d, ev2, ev2b, ev2bd, ev2d, s, t2, t2b, t2bd, t2d, tb2, tb2d,
      tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d, w0, w0b, w0bd, w0d, w1, w1b, w1bd, w1d,
      w20, w20b, w20bd, w20d, w21, w21b, w21bd, w21d, w22, w22b, w22bd, w22d, w2_2, w2_2b, w2_2bd,
      w2_2d, w30, w30b, w30bd, w30d, w31, w31b, w31bd, w31d, w32, w32b, w32bd, w32d, w40, w40b,
      w40bd, w40d, w41, w41b, w41bd, w41d, w42, w42b, w42bd, w42d;

  (void)rate;
  (void)rated;
  s = -1.0;
  /* what turning with the bodies that carry both sides does to open points and axes */
  for (i2 = t->nprim - 1; i2 >= 0; --i2) {
    c = t->loopcommon[t->primloop[i2]];
    if (c < t->nbody && t->primkind[i2] == MAGGI_PRIM_POINT) {
      e20 = r[t->primpa[i2]][0] - r[t->primpb[i2]][0];
      e20d = rd[t->primpa[i2]][0] - rd[t->primpb[i2]][0];
      e21 = r[t->primpa[i2]][1] - r[t->primpb[i2]][1];
      e21d = rd[t->primpa[i2]][1] - rd[t->primpb[i2]][1];
      e22 = r[t->primpa[i2]][2] - r[t->primpb[i2]][2];
      e22d = rd[t->primpa[i2]][2] - rd[t->primpb[i2]][2];
      w30 = Z[c][3];
      w30d = Zd[c][3];
      w31 = Z[c][4];
      w31d = Zd[c][4];
      w32 = Z[c][5];
      w32d = Zd[c][5];
      e12b = rateb[t->primrow[i2] + 2] * s;
      e12bd = ratebd[t->primrow[i2] + 2] * s;
      e11b = rateb[t->primrow[i2] + 1] * s;
      e11bd = ratebd[t->primrow[i2] + 1] * s;
      e10b = rateb[t->primrow[i2]] * s;
      e10bd = ratebd[t->primrow[i2]] * s;
      w30b = e12b * e21;
      w30bd = e12bd * e21 + e12b * e21d;
      e21b = e12b * w30;
      e21bd = e12bd * w30 + e12b * w30d;
      w31b = -(e12b * e20);
      w31bd = -(e12bd * e20 + e12b * e20d);
      e20b = -(e12b * w31);
      e20bd = -(e12bd * w31 + e12b * w31d);
      w32b = e11b * e20;
      w32bd = e11bd * e20 + e11b * e20d;
      e20b += e11b * w32;
      e20bd += e11bd * w32 + e11b * w32d;
      w30b -= e11b * e22;
      w30bd -= e11bd * e22 + e11b * e22d;
      e22b = -(e11b * w30);
      e22bd = -(e11bd * w30 + e11b * w30d);
      w31b += e10b * e22;
      w31bd += e10bd * e22 + e10b * e22d;
      e22b += e10b * w31;
      e22bd += e10bd * w31 + e10b * w31d;
      w32b -= e10b * e21;
      w32bd -= e10bd * e21 + e10b * e21d;
      e21b -= e10b * w32;
      e21bd -= e10bd * w32 + e10b * w32d;
      Zb[c][5] += w32b;
      Zbd[c][5] += w32bd;
      Zb[c][4] += w31b;
      Zbd[c][4] += w31bd;
      Zb[c][3] += w30b;
      /* u' = w × u */
      Zbd[c][3] += w30bd;
      rb[t->primpa[i2]][2] += e22b;
      rbd[t->primpa[i2]][2] += e22bd;
      rb[t->primpb[i2]][2] -= e22b;
      rbd[t->primpb[i2]][2] -= e22bd;
      rb[t->primpa[i2]][1] += e21b;
      rbd[t->primpa[i2]][1] += e21bd;
      rb[t->primpb[i2]][1] -= e21b;
      rbd[t->primpb[i2]][1] -= e21bd;
      rb[t->primpa[i2]][0] += e20b;
      /* y += s w × (a - b) */
      rbd[t->primpa[i2]][0] += e20bd;
      rb[t->primpb[i2]][0] -= e20b;
      rbd[t->primpb[i2]][0] -= e20bd;
    } else if (c < t->nbody && t->primkind[i2] == MAGGI_PRIM_AXIS) {
      e30 = dir[t->primda[i2]][0] - dir[t->primdb[i2]][0];
      e30d = dird[t->primda[i2]][0] - dird[t->primdb[i2]][0];
      e31 = dir[t->primda[i2]][1] - dir[t->primdb[i2]][1];
      e31d = dird[t->primda[i2]][1] - dird[t->primdb[i2]][1];
      e32 = dir[t->primda[i2]][2] - dir[t->primdb[i2]][2];
      e32d = dird[t->primda[i2]][2] - dird[t->primdb[i2]][2];
      w40 = Z[c][3];
      w40d = Zd[c][3];
      w41 = Z[c][4];
      w41d = Zd[c][4];
      w42 = Z[c][5];
      w42d = Zd[c][5];
      e1_6b = rateb[t->primrow[i2] + 2] * s;
      e1_6bd = ratebd[t->primrow[i2] + 2] * s;
      e1_5b = rateb[t->primrow[i2] + 1] * s;
      e1_5bd = ratebd[t->primrow[i2] + 1] * s;
      e1_4b = rateb[t->primrow[i2]] * s;
      e1_4bd = ratebd[t->primrow[i2]] * s;
      w40b = e1_6b * e31;
      w40bd = e1_6bd * e31 + e1_6b * e31d;
      e31b = e1_6b * w40;
      e31bd = e1_6bd * w40 + e1_6b * w40d;
      w41b = -(e1_6b * e30);
      w41bd = -(e1_6bd * e30 + e1_6b * e30d);
      e30b = -(e1_6b * w41);
      e30bd = -(e1_6bd * w41 + e1_6b * w41d);
      w42b = e1_5b * e30;
      w42bd = e1_5bd * e30 + e1_5b * e30d;
      e30b += e1_5b * w42;
      e30bd += e1_5bd * w42 + e1_5b * w42d;
      w40b -= e1_5b * e32;
      w40bd -= e1_5bd * e32 + e1_5b * e32d;
      e32b = -(e1_5b * w40);
      e32bd = -(e1_5bd * w40 + e1_5b * w40d);
      w41b += e1_4b * e32;
      w41bd += e1_4bd * e32 + e1_4b * e32d;
      e32b += e1_4b * w41;
      e32bd += e1_4bd * w41 + e1_4b * w41d;
      w42b -= e1_4b * e31;
      w42bd -= e1_4bd * e31 + e1_4b * e31d;
      e31b -= e1_4b * w42;
      e31bd -= e1_4bd * w42 + e1_4b * w42d;
      Zb[c][5] += w42b;
      Zbd[c][5] += w42bd;
      Zb[c][4] += w41b;
      Zbd[c][4] += w41bd;
      Zb[c][3] += w40b;
      /* u' = w × u */
      Zbd[c][3] += w40bd;
      dirb[t->primda[i2]][2] += e32b;
      dirbd[t->primda[i2]][2] += e32bd;
      dirb[t->primdb[i2]][2] -= e32b;
      dirbd[t->primdb[i2]][2] -= e32bd;
      dirb[t->primda[i2]][1] += e31b;
      dirbd[t->primda[i2]][1] += e31bd;
      dirb[t->primdb[i2]][1] -= e31b;
      dirbd[t->primdb[i2]][1] -= e31bd;
      dirb[t->primda[i2]][0] += e30b;
      /* y += s w × (a - b) */
      dirbd[t->primda[i2]][0] += e30bd;
      dirb[t->primdb[i2]][0] -= e30b;
      dirbd[t->primdb[i2]][0] -= e30bd;
    }
  }
  for (i = t->nprim - 1; i >= 0; --i) {
    e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
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
    e0b = 0.0;
    e0bd = 0.0;
    e1_3b = 0.0;
    e1_3bd = 0.0;
    e2_2b = 0.0;
    e2_2bd = 0.0;
    ev0b = 0.0;
    ev0bd = 0.0;
    ev1b = 0.0;
    ev1bd = 0.0;
    ev2b = 0.0;
    ev2bd = 0.0;
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
      ev2b += rateb[t->primrow[i] + 2];
      ev2bd += ratebd[t->primrow[i] + 2];
      rateb[t->primrow[i] + 2] = 0.0;
      ratebd[t->primrow[i] + 2] = 0.0;
      ev1b += rateb[t->primrow[i] + 1];
      ev1bd += ratebd[t->primrow[i] + 1];
      rateb[t->primrow[i] + 1] = 0.0;
      ratebd[t->primrow[i] + 1] = 0.0;
      ev0b += rateb[t->primrow[i]];
      ev0bd += ratebd[t->primrow[i]];
      rateb[t->primrow[i]] = 0.0;
      ratebd[t->primrow[i]] = 0.0;
    } else if (t->primkind[i] == MAGGI_PRIM_ROD) {
      t2 = (ev0 * e0 + ev1 * e1_3 + ev2 * e2_2) / prim0[i];
      t2d = (ev0d * e0 + ev0 * e0d + (ev1d * e1_3 + ev1 * e1_3d) + (ev2d * e2_2 + ev2 * e2_2d) - t2
          * prim0d[i]) * (1.0 / prim0[i]);
      t2b = rateb[t->primrow[i]];
      t2bd = ratebd[t->primrow[i]];
      rateb[t->primrow[i]] = 0.0;
      ratebd[t->primrow[i]] = 0.0;
      tb2 = t2b / prim0[i];
      tb2d = (t2bd - tb2 * prim0d[i]) * (1.0 / prim0[i]);
      ev0b += tb2 * e0;
      ev0bd += tb2d * e0 + tb2 * e0d;
      e0b += tb2 * ev0;
      e0bd += tb2d * ev0 + tb2 * ev0d;
      ev1b += tb2 * e1_3;
      ev1bd += tb2d * e1_3 + tb2 * e1_3d;
      e1_3b += tb2 * ev1;
      e1_3bd += tb2d * ev1 + tb2 * ev1d;
      ev2b += tb2 * e2_2;
      ev2bd += tb2d * e2_2 + tb2 * e2_2d;
      e2_2b += tb2 * ev2;
      e2_2bd += tb2d * ev2 + tb2 * ev2d;
      prim0b[i] -= tb2 * t2;
      prim0bd[i] -= tb2d * t2 + tb2 * t2d;
    } else {
      w0 = Z[t->primba[i]][3];
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
      da10b = 0.0;
      da10bd = 0.0;
      da11b = 0.0;
      da11bd = 0.0;
      da12b = 0.0;
      da12bd = 0.0;
      db10b = 0.0;
      db10bd = 0.0;
      db11b = 0.0;
      db11bd = 0.0;
      db12b = 0.0;
      db12bd = 0.0;
      if (t->primkind[i] == MAGGI_PRIM_AXIS) {
        tb5 = rateb[t->primrow[i] + 2];
        tb5d = ratebd[t->primrow[i] + 2];
        rateb[t->primrow[i] + 2] = 0.0;
        ratebd[t->primrow[i] + 2] = 0.0;
        da12b += tb5;
        da12bd += tb5d;
        db12b -= tb5;
        db12bd -= tb5d;
        tb4 = rateb[t->primrow[i] + 1];
        tb4d = ratebd[t->primrow[i] + 1];
        rateb[t->primrow[i] + 1] = 0.0;
        ratebd[t->primrow[i] + 1] = 0.0;
        da11b += tb4;
        da11bd += tb4d;
        db11b -= tb4;
        db11bd -= tb4d;
        tb3 = rateb[t->primrow[i]];
        tb3d = ratebd[t->primrow[i]];
        rateb[t->primrow[i]] = 0.0;
        ratebd[t->primrow[i]] = 0.0;
        da10b += tb3;
        da10bd += tb3d;
        db10b -= tb3;
        db10bd -= tb3d;
      } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
        tb6 = rateb[t->primrow[i]];
        tb6d = ratebd[t->primrow[i]];
        rateb[t->primrow[i]] = 0.0;
        ratebd[t->primrow[i]] = 0.0;
        da10b += tb6 * dir[t->primdb[i]][0];
        da10bd += tb6d * dir[t->primdb[i]][0] + tb6 * dird[t->primdb[i]][0];
        dirb[t->primdb[i]][0] += tb6 * da10;
        dirbd[t->primdb[i]][0] += tb6d * da10 + tb6 * da10d;
        da11b += tb6 * dir[t->primdb[i]][1];
        da11bd += tb6d * dir[t->primdb[i]][1] + tb6 * dird[t->primdb[i]][1];
        dirb[t->primdb[i]][1] += tb6 * da11;
        dirbd[t->primdb[i]][1] += tb6d * da11 + tb6 * da11d;
        da12b += tb6 * dir[t->primdb[i]][2];
        da12bd += tb6d * dir[t->primdb[i]][2] + tb6 * dird[t->primdb[i]][2];
        dirb[t->primdb[i]][2] += tb6 * da12;
        dirbd[t->primdb[i]][2] += tb6d * da12 + tb6 * da12d;
        dirb[t->primda[i]][0] += tb6 * db10;
        dirbd[t->primda[i]][0] += tb6d * db10 + tb6 * db10d;
        db10b += tb6 * dir[t->primda[i]][0];
        db10bd += tb6d * dir[t->primda[i]][0] + tb6 * dird[t->primda[i]][0];
        dirb[t->primda[i]][1] += tb6 * db11;
        dirbd[t->primda[i]][1] += tb6d * db11 + tb6 * db11d;
        db11b += tb6 * dir[t->primda[i]][1];
        db11bd += tb6d * dir[t->primda[i]][1] + tb6 * dird[t->primda[i]][1];
        dirb[t->primda[i]][2] += tb6 * db12;
        dirbd[t->primda[i]][2] += tb6d * db12 + tb6 * db12d;
        db12b += tb6 * dir[t->primda[i]][2];
        db12bd += tb6d * dir[t->primda[i]][2] + tb6 * dird[t->primda[i]][2];
      } else {
        tb7 = rateb[t->primrow[i]];
        tb7d = ratebd[t->primrow[i]];
        rateb[t->primrow[i]] = 0.0;
        ratebd[t->primrow[i]] = 0.0;
        ev0b += tb7 * dir[t->primdb[i]][0];
        ev0bd += tb7d * dir[t->primdb[i]][0] + tb7 * dird[t->primdb[i]][0];
        dirb[t->primdb[i]][0] += tb7 * ev0;
        dirbd[t->primdb[i]][0] += tb7d * ev0 + tb7 * ev0d;
        ev1b += tb7 * dir[t->primdb[i]][1];
        ev1bd += tb7d * dir[t->primdb[i]][1] + tb7 * dird[t->primdb[i]][1];
        dirb[t->primdb[i]][1] += tb7 * ev1;
        dirbd[t->primdb[i]][1] += tb7d * ev1 + tb7 * ev1d;
        ev2b += tb7 * dir[t->primdb[i]][2];
        ev2bd += tb7d * dir[t->primdb[i]][2] + tb7 * dird[t->primdb[i]][2];
        dirb[t->primdb[i]][2] += tb7 * ev2;
        dirbd[t->primdb[i]][2] += tb7d * ev2 + tb7 * ev2d;
        e0b += tb7 * db10;
        e0bd += tb7d * db10 + tb7 * db10d;
        db10b += tb7 * e0;
        db10bd += tb7d * e0 + tb7 * e0d;
        e1_3b += tb7 * db11;
        e1_3bd += tb7d * db11 + tb7 * db11d;
        db11b += tb7 * e1_3;
        db11bd += tb7d * e1_3 + tb7 * e1_3d;
        e2_2b += tb7 * db12;
        e2_2bd += tb7d * db12 + tb7 * db12d;
        db12b += tb7 * e2_2;
        db12bd += tb7d * e2_2 + tb7 * e2_2d;
      }
      w20b = db12b * dir_i1_2;
      w20bd = db12bd * dir_i1_2 + db12b * dir_i1_2d;
      dir_i1_2b = db12b * w20;
      dir_i1_2bd = db12bd * w20 + db12b * w20d;
      w21b = -(db12b * dir_i0_2);
      w21bd = -(db12bd * dir_i0_2 + db12b * dir_i0_2d);
      dir_i0_2b = -(db12b * w21);
      dir_i0_2bd = -(db12bd * w21 + db12b * w21d);
      w22b = db11b * dir_i0_2;
      w22bd = db11bd * dir_i0_2 + db11b * dir_i0_2d;
      dir_i0_2b += db11b * w22;
      dir_i0_2bd += db11bd * w22 + db11b * w22d;
      w20b -= db11b * dir_i2_2;
      w20bd -= db11bd * dir_i2_2 + db11b * dir_i2_2d;
      dir_i2_2b = -(db11b * w20);
      dir_i2_2bd = -(db11bd * w20 + db11b * w20d);
      dirb[t->primdb[i]][0] += dir_i0_2b;
      dirbd[t->primdb[i]][0] += dir_i0_2bd;
      w21b += db10b * dir_i2_2;
      w21bd += db10bd * dir_i2_2 + db10b * dir_i2_2d;
      dir_i2_2b += db10b * w21;
      dir_i2_2bd += db10bd * w21 + db10b * w21d;
      w22b -= db10b * dir_i1_2;
      w22bd -= db10bd * dir_i1_2 + db10b * dir_i1_2d;
      dir_i1_2b -= db10b * w22;
      dir_i1_2bd -= db10bd * w22 + db10b * w22d;
      dirb[t->primdb[i]][1] += dir_i1_2b;
      dirbd[t->primdb[i]][1] += dir_i1_2bd;
      dirb[t->primdb[i]][2] += dir_i2_2b;
      dirbd[t->primdb[i]][2] += dir_i2_2bd;
      Zb[t->primbb[i]][5] += w22b;
      Zbd[t->primbb[i]][5] += w22bd;
      Zb[t->primbb[i]][4] += w21b;
      Zbd[t->primbb[i]][4] += w21bd;
      Zb[t->primbb[i]][3] += w20b;
      /* u' = w × u */
      Zbd[t->primbb[i]][3] += w20bd;
      w0b = da12b * dir_i1;
      w0bd = da12bd * dir_i1 + da12b * dir_i1d;
      dir_i1b = da12b * w0;
      dir_i1bd = da12bd * w0 + da12b * w0d;
      w1b = -(da12b * dir_i0);
      w1bd = -(da12bd * dir_i0 + da12b * dir_i0d);
      dir_i0b = -(da12b * w1);
      dir_i0bd = -(da12bd * w1 + da12b * w1d);
      w2_2b = da11b * dir_i0;
      w2_2bd = da11bd * dir_i0 + da11b * dir_i0d;
      dir_i0b += da11b * w2_2;
      dir_i0bd += da11bd * w2_2 + da11b * w2_2d;
      w0b -= da11b * dir_i2;
      w0bd -= da11bd * dir_i2 + da11b * dir_i2d;
      dir_i2b = -(da11b * w0);
      dir_i2bd = -(da11bd * w0 + da11b * w0d);
      dirb[t->primda[i]][0] += dir_i0b;
      dirbd[t->primda[i]][0] += dir_i0bd;
      w1b += da10b * dir_i2;
      w1bd += da10bd * dir_i2 + da10b * dir_i2d;
      dir_i2b += da10b * w1;
      dir_i2bd += da10bd * w1 + da10b * w1d;
      w2_2b -= da10b * dir_i1;
      w2_2bd -= da10bd * dir_i1 + da10b * dir_i1d;
      dir_i1b -= da10b * w2_2;
      dir_i1bd -= da10bd * w2_2 + da10b * w2_2d;
      dirb[t->primda[i]][1] += dir_i1b;
      dirbd[t->primda[i]][1] += dir_i1bd;
      dirb[t->primda[i]][2] += dir_i2b;
      dirbd[t->primda[i]][2] += dir_i2bd;
      Zb[t->primba[i]][5] += w2_2b;
      Zbd[t->primba[i]][5] += w2_2bd;
      Zb[t->primba[i]][4] += w1b;
      Zbd[t->primba[i]][4] += w1bd;
      Zb[t->primba[i]][3] += w0b;
      /* u' = w × u */
      Zbd[t->primba[i]][3] += w0bd;
    }
    rvb[t->primpa[i]][2] += ev2b;
    rvbd[t->primpa[i]][2] += ev2bd;
    rvb[t->primpb[i]][2] -= ev2b;
    rvbd[t->primpb[i]][2] -= ev2bd;
    rb[t->primpa[i]][2] += e2_2b;
    rbd[t->primpa[i]][2] += e2_2bd;
    rb[t->primpb[i]][2] -= e2_2b;
    rbd[t->primpb[i]][2] -= e2_2bd;
    rvb[t->primpa[i]][1] += ev1b;
    rvbd[t->primpa[i]][1] += ev1bd;
    rvb[t->primpb[i]][1] -= ev1b;
    rvbd[t->primpb[i]][1] -= ev1bd;
    rb[t->primpa[i]][1] += e1_3b;
    rbd[t->primpa[i]][1] += e1_3bd;
    rb[t->primpb[i]][1] -= e1_3b;
    rbd[t->primpb[i]][1] -= e1_3bd;
    rvb[t->primpa[i]][0] += ev0b;
    rvbd[t->primpa[i]][0] += ev0bd;
    rvb[t->primpb[i]][0] -= ev0b;
    rvbd[t->primpb[i]][0] -= ev0bd;
    rb[t->primpa[i]][0] += e0b;
    /* the first derivative of the equation */
    rbd[t->primpa[i]][0] += e0bd;
    rb[t->primpb[i]][0] -= e0b;
    rbd[t->primpb[i]][0] -= e0bd;
  }
}

void maggi_loop_gamma_b_d(const maggi_topo *t, const double prim0[restrict t->nprim],
                          const double prim0d[restrict t->nprim], double prim0b[restrict t->nprim],
                          double prim0bd[restrict t->nprim], const double r[restrict t->npoint][3],
                          const double rd[restrict t->npoint][3], double rb[restrict t->npoint][3],
                          double rbd[restrict t->npoint][3], const double dir[restrict t->ndir][3],
                          const double dird[restrict t->ndir][3], double dirb[restrict t->ndir][3],
                          double dirbd[restrict t->ndir][3], const double rv[restrict t->npoint][3],
                          const double rvd[restrict t->npoint][3],
                          double rvb[restrict t->npoint][3], double rvbd[restrict t->npoint][3],
                          const double ra[restrict t->npoint][3],
                          const double rad[restrict t->npoint][3],
                          double rab[restrict t->npoint][3], double rabd[restrict t->npoint][3],
                          const double Z[restrict t->nbody + 1][6],
                          const double Zd[restrict t->nbody + 1][6],
                          double Zb[restrict t->nbody + 1][6], double Zbd[restrict t->nbody + 1][6],
                          const double Z0[restrict t->nbody + 1][6],
                          const double Z0d[restrict t->nbody + 1][6],
                          double Z0b[restrict t->nbody + 1][6],
                          double Z0bd[restrict t->nbody + 1][6], double gam[restrict t->nrow],
                          double gamd[restrict t->nrow], double gamb[restrict t->nrow],
                          double gambd[restrict t->nrow])
{
  int a, b, c3, i, i2;
  double Z_a3, Z_a3b, Z_a3bd, Z_a3d, Z_a4, Z_a4b, Z_a4bd, Z_a4d, Z_a5, Z_a5b, Z_a5bd, Z_a5d, Z_b3,
      Z_b3b, Z_b3bd, Z_b3d, Z_b4, Z_b4b, Z_b4bd, Z_b4d, Z_b5, Z_b5b, Z_b5bd, Z_b5d, c0, c0b, c0bd,
      c0d, c1, c1b, c1bd, c1d, c20, c20b, c20bd, c20d, c21, c21b, c21bd, c21d, c22, c22b, c22bd,
      c22d, c2_2, c2_2b, c2_2bd, c2_2d, da10, da10b, da10bd, da10d, da11, da11b, da11bd, da11d,
      da12, da12b, da12bd, da12d, da20, da20b, da20bd, da20d, da21, da21b, da21bd, da21d, da22,
      da22b, da22bd, da22d, db10, db10b, db10bd, db10d, db11, db11b, db11bd, db11d, db12, db12b,
      db12bd, db12d, db20, db20b, db20bd, db20d, db21, db21b, db21bd, db21d, db22, db22b, db22bd,
      db22d, dir_i0, dir_i0_2, dir_i0_2b, dir_i0_2bd, dir_i0_2d, dir_i0b, dir_i0bd, dir_i0d, dir_i1,
      dir_i1_2, dir_i1_2b, dir_i1_2bd, dir_i1_2d, dir_i1b, dir_i1bd, dir_i1d, dir_i2, dir_i2_2,
      dir_i2_2b, dir_i2_2bd, dir_i2_2d, dir_i2b, dir_i2bd, dir_i2d, e0, e0b, e0bd, e0d, e10b, e10bd,
      e11b, e11bd, e12b, e12bd, e1_3, e1_3b, e1_3bd, e1_3d, e1_4b, e1_4bd, e1_5b, e1_5bd, e1_6b,
      e1_6bd, e20, e20b, e20bd, e20d, e21, e21b, e21bd, e21d, e22, e22b, e22bd, e22d, e2_2, e2_2b,
      e2_2bd, e2_2d, e30, e30b, e30bd, e30d, e31, e31b, e31bd, e31d, e32, e32b, e32bd, e32d, e40,
      e40b, e40bd, e40d, e41, e41b, e41bd, e41d, e42, e42b, e42bd, e42d, e50, e50b, e50bd, e50d,
      e51, e51b, e51bd, e51d, e52, e52b, e52bd, e52d, ea0, ea0b, ea0bd, ea0d, ea1, ea1b, ea1bd,
      ea1d, ea2, ea2b, ea2bd, ea2d, ev0, ev0b, ev0bd, ev0d, ev1, ev1b, ev1bd, ev1d, ev2, ev2b,
      ev2bd, ev2d, t2, t2b, t2bd, t2d, tb2, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7,
      tb7d, tb8, tb8d, tb9, tb9d, w0, w0b, w0bd, w0d, w1, w1b, w1bd, w1d, w20, w20b, w20bd, w20d,
      w21, w21b, w21bd, w21d, w22, w22b, w22bd, w22d, w2_2, w2_2b, w2_2bd, w2_2d, w30, w30b, w30bd,
      w30d, w31, w31b, w31bd, w31d, w32, w32b, w32bd, w32d, w40, w40b, w40bd, w40d, w41, w41b,
      w41bd, w41d, w42, w42b, w42bd, w42d, w50, w50b, w50bd, w50d, w51, w51b, w51bd, w51d, w52,
      w52b, w52bd, w52d, w60, w60b, w60bd, w60d, w61, w61b, w61bd, w61d, w62, w62b, w62bd, w62d,
      w70, w70b, w70bd, w70d, w71, w71b, w71bd, w71d, w72, w72b, w72bd, w72d, w80, w80b, w80bd,
      w80d, w81, w81b, w81bd, w81d, w82, w82b, w82bd, w82d;

  (void)gam;
  (void)gamd;
  /* what turning with the bodies that carry both sides does to open points and axes */
  for (i2 = t->nprim - 1; i2 >= 0; --i2) {
    c3 = t->loopcommon[t->primloop[i2]];
    if (c3 < t->nbody && t->primkind[i2] == MAGGI_PRIM_POINT) {
      e40 = r[t->primpa[i2]][0] - r[t->primpb[i2]][0];
      e40d = rd[t->primpa[i2]][0] - rd[t->primpb[i2]][0];
      e41 = r[t->primpa[i2]][1] - r[t->primpb[i2]][1];
      e41d = rd[t->primpa[i2]][1] - rd[t->primpb[i2]][1];
      e42 = r[t->primpa[i2]][2] - r[t->primpb[i2]][2];
      e42d = rd[t->primpa[i2]][2] - rd[t->primpb[i2]][2];
      w70 = Z0[c3][3];
      w70d = Z0d[c3][3];
      w71 = Z0[c3][4];
      w71d = Z0d[c3][4];
      w72 = Z0[c3][5];
      w72d = Z0d[c3][5];
      e12b = gamb[t->primrow[i2] + 2];
      e12bd = gambd[t->primrow[i2] + 2];
      e11b = gamb[t->primrow[i2] + 1];
      e11bd = gambd[t->primrow[i2] + 1];
      e10b = gamb[t->primrow[i2]];
      e10bd = gambd[t->primrow[i2]];
      w70b = e12b * e41;
      w70bd = e12bd * e41 + e12b * e41d;
      e41b = e12b * w70;
      e41bd = e12bd * w70 + e12b * w70d;
      w71b = -(e12b * e40);
      w71bd = -(e12bd * e40 + e12b * e40d);
      e40b = -(e12b * w71);
      e40bd = -(e12bd * w71 + e12b * w71d);
      w72b = e11b * e40;
      w72bd = e11bd * e40 + e11b * e40d;
      e40b += e11b * w72;
      e40bd += e11bd * w72 + e11b * w72d;
      w70b -= e11b * e42;
      w70bd -= e11bd * e42 + e11b * e42d;
      e42b = -(e11b * w70);
      e42bd = -(e11bd * w70 + e11b * w70d);
      w71b += e10b * e42;
      w71bd += e10bd * e42 + e10b * e42d;
      e42b += e10b * w71;
      e42bd += e10bd * w71 + e10b * w71d;
      w72b -= e10b * e41;
      w72bd -= e10bd * e41 + e10b * e41d;
      e41b -= e10b * w72;
      e41bd -= e10bd * w72 + e10b * w72d;
      Z0b[c3][5] += w72b;
      Z0bd[c3][5] += w72bd;
      Z0b[c3][4] += w71b;
      Z0bd[c3][4] += w71bd;
      Z0b[c3][3] += w70b;
      /* u' = w × u */
      Z0bd[c3][3] += w70bd;
      rb[t->primpa[i2]][2] += e42b;
      rbd[t->primpa[i2]][2] += e42bd;
      rb[t->primpb[i2]][2] -= e42b;
      rbd[t->primpb[i2]][2] -= e42bd;
      rb[t->primpa[i2]][1] += e41b;
      rbd[t->primpa[i2]][1] += e41bd;
      rb[t->primpb[i2]][1] -= e41b;
      rbd[t->primpb[i2]][1] -= e41bd;
      rb[t->primpa[i2]][0] += e40b;
      /* y += s w × (a - b) */
      rbd[t->primpa[i2]][0] += e40bd;
      rb[t->primpb[i2]][0] -= e40b;
      rbd[t->primpb[i2]][0] -= e40bd;
    } else if (c3 < t->nbody && t->primkind[i2] == MAGGI_PRIM_AXIS) {
      e50 = dir[t->primda[i2]][0] - dir[t->primdb[i2]][0];
      e50d = dird[t->primda[i2]][0] - dird[t->primdb[i2]][0];
      e51 = dir[t->primda[i2]][1] - dir[t->primdb[i2]][1];
      e51d = dird[t->primda[i2]][1] - dird[t->primdb[i2]][1];
      e52 = dir[t->primda[i2]][2] - dir[t->primdb[i2]][2];
      e52d = dird[t->primda[i2]][2] - dird[t->primdb[i2]][2];
      w80 = Z0[c3][3];
      w80d = Z0d[c3][3];
      w81 = Z0[c3][4];
      w81d = Z0d[c3][4];
      w82 = Z0[c3][5];
      w82d = Z0d[c3][5];
      e1_6b = gamb[t->primrow[i2] + 2];
      e1_6bd = gambd[t->primrow[i2] + 2];
      e1_5b = gamb[t->primrow[i2] + 1];
      e1_5bd = gambd[t->primrow[i2] + 1];
      e1_4b = gamb[t->primrow[i2]];
      e1_4bd = gambd[t->primrow[i2]];
      w80b = e1_6b * e51;
      w80bd = e1_6bd * e51 + e1_6b * e51d;
      e51b = e1_6b * w80;
      e51bd = e1_6bd * w80 + e1_6b * w80d;
      w81b = -(e1_6b * e50);
      w81bd = -(e1_6bd * e50 + e1_6b * e50d);
      e50b = -(e1_6b * w81);
      e50bd = -(e1_6bd * w81 + e1_6b * w81d);
      w82b = e1_5b * e50;
      w82bd = e1_5bd * e50 + e1_5b * e50d;
      e50b += e1_5b * w82;
      e50bd += e1_5bd * w82 + e1_5b * w82d;
      w80b -= e1_5b * e52;
      w80bd -= e1_5bd * e52 + e1_5b * e52d;
      e52b = -(e1_5b * w80);
      e52bd = -(e1_5bd * w80 + e1_5b * w80d);
      w81b += e1_4b * e52;
      w81bd += e1_4bd * e52 + e1_4b * e52d;
      e52b += e1_4b * w81;
      e52bd += e1_4bd * w81 + e1_4b * w81d;
      w82b -= e1_4b * e51;
      w82bd -= e1_4bd * e51 + e1_4b * e51d;
      e51b -= e1_4b * w82;
      e51bd -= e1_4bd * w82 + e1_4b * w82d;
      Z0b[c3][5] += w82b;
      Z0bd[c3][5] += w82bd;
      Z0b[c3][4] += w81b;
      Z0bd[c3][4] += w81bd;
      Z0b[c3][3] += w80b;
      /* u' = w × u */
      Z0bd[c3][3] += w80bd;
      dirb[t->primda[i2]][2] += e52b;
      dirbd[t->primda[i2]][2] += e52bd;
      dirb[t->primdb[i2]][2] -= e52b;
      dirbd[t->primdb[i2]][2] -= e52bd;
      dirb[t->primda[i2]][1] += e51b;
      dirbd[t->primda[i2]][1] += e51bd;
      dirb[t->primdb[i2]][1] -= e51b;
      dirbd[t->primdb[i2]][1] -= e51bd;
      dirb[t->primda[i2]][0] += e50b;
      /* y += s w × (a - b) */
      dirbd[t->primda[i2]][0] += e50bd;
      dirb[t->primdb[i2]][0] -= e50b;
      dirbd[t->primdb[i2]][0] -= e50bd;
    }
  }
  for (i = t->nprim - 1; i >= 0; --i) {
    a = t->primba[i];
    b = t->primbb[i];
    e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
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
    e0b = 0.0;
    e0bd = 0.0;
    e1_3b = 0.0;
    e1_3bd = 0.0;
    e2_2b = 0.0;
    e2_2bd = 0.0;
    ea0b = 0.0;
    ea0bd = 0.0;
    ea1b = 0.0;
    ea1bd = 0.0;
    ea2b = 0.0;
    ea2bd = 0.0;
    ev0b = 0.0;
    ev0bd = 0.0;
    ev1b = 0.0;
    ev1bd = 0.0;
    ev2b = 0.0;
    ev2bd = 0.0;
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
      ea2b -= gamb[t->primrow[i] + 2];
      ea2bd -= gambd[t->primrow[i] + 2];
      gamb[t->primrow[i] + 2] = 0.0;
      gambd[t->primrow[i] + 2] = 0.0;
      ea1b -= gamb[t->primrow[i] + 1];
      ea1bd -= gambd[t->primrow[i] + 1];
      gamb[t->primrow[i] + 1] = 0.0;
      gambd[t->primrow[i] + 1] = 0.0;
      ea0b -= gamb[t->primrow[i]];
      ea0bd -= gambd[t->primrow[i]];
      gamb[t->primrow[i]] = 0.0;
      gambd[t->primrow[i]] = 0.0;
    } else if (t->primkind[i] == MAGGI_PRIM_ROD) {
      t2 = -(ea0 * e0 + ea1 * e1_3 + ea2 * e2_2 + (ev0 * ev0 + ev1 * ev1 + ev2 * ev2)) / prim0[i];
      t2d = (-(ea0d * e0 + ea0 * e0d + (ea1d * e1_3 + ea1 * e1_3d) + (ea2d * e2_2 + ea2 * e2_2d) +
          (ev0d * ev0 + ev0 * ev0d + (ev1d * ev1 + ev1 * ev1d) + (ev2d * ev2 + ev2 * ev2d))) - t2 *
          prim0d[i]) * (1.0 / prim0[i]);
      t2b = gamb[t->primrow[i]];
      t2bd = gambd[t->primrow[i]];
      gamb[t->primrow[i]] = 0.0;
      gambd[t->primrow[i]] = 0.0;
      tb2 = t2b / prim0[i];
      tb2d = (t2bd - tb2 * prim0d[i]) * (1.0 / prim0[i]);
      ea0b -= tb2 * e0;
      ea0bd -= tb2d * e0 + tb2 * e0d;
      e0b -= tb2 * ea0;
      e0bd -= tb2d * ea0 + tb2 * ea0d;
      ea1b -= tb2 * e1_3;
      ea1bd -= tb2d * e1_3 + tb2 * e1_3d;
      e1_3b -= tb2 * ea1;
      e1_3bd -= tb2d * ea1 + tb2 * ea1d;
      ea2b -= tb2 * e2_2;
      ea2bd -= tb2d * e2_2 + tb2 * e2_2d;
      e2_2b -= tb2 * ea2;
      e2_2bd -= tb2d * ea2 + tb2 * ea2d;
      ev0b -= tb2 * ev0;
      ev0bd -= tb2d * ev0 + tb2 * ev0d;
      ev0b -= tb2 * ev0;
      ev0bd -= tb2d * ev0 + tb2 * ev0d;
      ev1b -= tb2 * ev1;
      ev1bd -= tb2d * ev1 + tb2 * ev1d;
      ev1b -= tb2 * ev1;
      ev1bd -= tb2d * ev1 + tb2 * ev1d;
      ev2b -= tb2 * ev2;
      ev2bd -= tb2d * ev2 + tb2 * ev2d;
      ev2b -= tb2 * ev2;
      ev2bd -= tb2d * ev2 + tb2 * ev2d;
      prim0b[i] -= tb2 * t2;
      prim0bd[i] -= tb2d * t2 + tb2 * t2d;
    } else {
      Z_a3 = Z[a][3];
      Z_a3d = Zd[a][3];
      w0 = Z_a3;
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
      da10b = 0.0;
      da10bd = 0.0;
      da11b = 0.0;
      da11bd = 0.0;
      da12b = 0.0;
      da12bd = 0.0;
      da20b = 0.0;
      da20bd = 0.0;
      da21b = 0.0;
      da21bd = 0.0;
      da22b = 0.0;
      da22bd = 0.0;
      db10b = 0.0;
      db10bd = 0.0;
      db11b = 0.0;
      db11bd = 0.0;
      db12b = 0.0;
      db12bd = 0.0;
      db20b = 0.0;
      db20bd = 0.0;
      db21b = 0.0;
      db21bd = 0.0;
      db22b = 0.0;
      db22bd = 0.0;
      if (t->primkind[i] == MAGGI_PRIM_AXIS) {
        tb5 = gamb[t->primrow[i] + 2];
        tb5d = gambd[t->primrow[i] + 2];
        gamb[t->primrow[i] + 2] = 0.0;
        gambd[t->primrow[i] + 2] = 0.0;
        db22b += tb5;
        db22bd += tb5d;
        da22b -= tb5;
        da22bd -= tb5d;
        tb4 = gamb[t->primrow[i] + 1];
        tb4d = gambd[t->primrow[i] + 1];
        gamb[t->primrow[i] + 1] = 0.0;
        gambd[t->primrow[i] + 1] = 0.0;
        db21b += tb4;
        db21bd += tb4d;
        da21b -= tb4;
        da21bd -= tb4d;
        tb3 = gamb[t->primrow[i]];
        tb3d = gambd[t->primrow[i]];
        gamb[t->primrow[i]] = 0.0;
        gambd[t->primrow[i]] = 0.0;
        db20b += tb3;
        db20bd += tb3d;
        da20b -= tb3;
        da20bd -= tb3d;
      } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
        tb6 = gamb[t->primrow[i]];
        tb6d = gambd[t->primrow[i]];
        gamb[t->primrow[i]] = 0.0;
        gambd[t->primrow[i]] = 0.0;
        da20b -= tb6 * dir[t->primdb[i]][0];
        da20bd -= tb6d * dir[t->primdb[i]][0] + tb6 * dird[t->primdb[i]][0];
        dirb[t->primdb[i]][0] -= tb6 * da20;
        dirbd[t->primdb[i]][0] -= tb6d * da20 + tb6 * da20d;
        da21b -= tb6 * dir[t->primdb[i]][1];
        da21bd -= tb6d * dir[t->primdb[i]][1] + tb6 * dird[t->primdb[i]][1];
        dirb[t->primdb[i]][1] -= tb6 * da21;
        dirbd[t->primdb[i]][1] -= tb6d * da21 + tb6 * da21d;
        da22b -= tb6 * dir[t->primdb[i]][2];
        da22bd -= tb6d * dir[t->primdb[i]][2] + tb6 * dird[t->primdb[i]][2];
        dirb[t->primdb[i]][2] -= tb6 * da22;
        dirbd[t->primdb[i]][2] -= tb6d * da22 + tb6 * da22d;
        tb7 = tb6 * 2.0;
        tb7d = tb6d * 2.0;
        da10b -= tb7 * db10;
        da10bd -= tb7d * db10 + tb7 * db10d;
        db10b -= tb7 * da10;
        db10bd -= tb7d * da10 + tb7 * da10d;
        da11b -= tb7 * db11;
        da11bd -= tb7d * db11 + tb7 * db11d;
        db11b -= tb7 * da11;
        db11bd -= tb7d * da11 + tb7 * da11d;
        da12b -= tb7 * db12;
        da12bd -= tb7d * db12 + tb7 * db12d;
        db12b -= tb7 * da12;
        db12bd -= tb7d * da12 + tb7 * da12d;
        dirb[t->primda[i]][0] -= tb6 * db20;
        dirbd[t->primda[i]][0] -= tb6d * db20 + tb6 * db20d;
        db20b -= tb6 * dir[t->primda[i]][0];
        db20bd -= tb6d * dir[t->primda[i]][0] + tb6 * dird[t->primda[i]][0];
        dirb[t->primda[i]][1] -= tb6 * db21;
        dirbd[t->primda[i]][1] -= tb6d * db21 + tb6 * db21d;
        db21b -= tb6 * dir[t->primda[i]][1];
        db21bd -= tb6d * dir[t->primda[i]][1] + tb6 * dird[t->primda[i]][1];
        dirb[t->primda[i]][2] -= tb6 * db22;
        dirbd[t->primda[i]][2] -= tb6d * db22 + tb6 * db22d;
        db22b -= tb6 * dir[t->primda[i]][2];
        db22bd -= tb6d * dir[t->primda[i]][2] + tb6 * dird[t->primda[i]][2];
      } else {
        tb8 = gamb[t->primrow[i]];
        tb8d = gambd[t->primrow[i]];
        gamb[t->primrow[i]] = 0.0;
        gambd[t->primrow[i]] = 0.0;
        ea0b -= tb8 * dir[t->primdb[i]][0];
        ea0bd -= tb8d * dir[t->primdb[i]][0] + tb8 * dird[t->primdb[i]][0];
        dirb[t->primdb[i]][0] -= tb8 * ea0;
        dirbd[t->primdb[i]][0] -= tb8d * ea0 + tb8 * ea0d;
        ea1b -= tb8 * dir[t->primdb[i]][1];
        ea1bd -= tb8d * dir[t->primdb[i]][1] + tb8 * dird[t->primdb[i]][1];
        dirb[t->primdb[i]][1] -= tb8 * ea1;
        dirbd[t->primdb[i]][1] -= tb8d * ea1 + tb8 * ea1d;
        ea2b -= tb8 * dir[t->primdb[i]][2];
        ea2bd -= tb8d * dir[t->primdb[i]][2] + tb8 * dird[t->primdb[i]][2];
        dirb[t->primdb[i]][2] -= tb8 * ea2;
        dirbd[t->primdb[i]][2] -= tb8d * ea2 + tb8 * ea2d;
        tb9 = tb8 * 2.0;
        tb9d = tb8d * 2.0;
        ev0b -= tb9 * db10;
        ev0bd -= tb9d * db10 + tb9 * db10d;
        db10b -= tb9 * ev0;
        db10bd -= tb9d * ev0 + tb9 * ev0d;
        ev1b -= tb9 * db11;
        ev1bd -= tb9d * db11 + tb9 * db11d;
        db11b -= tb9 * ev1;
        db11bd -= tb9d * ev1 + tb9 * ev1d;
        ev2b -= tb9 * db12;
        ev2bd -= tb9d * db12 + tb9 * db12d;
        db12b -= tb9 * ev2;
        db12bd -= tb9d * ev2 + tb9 * ev2d;
        e0b -= tb8 * db20;
        e0bd -= tb8d * db20 + tb8 * db20d;
        db20b -= tb8 * e0;
        db20bd -= tb8d * e0 + tb8 * e0d;
        e1_3b -= tb8 * db21;
        e1_3bd -= tb8d * db21 + tb8 * db21d;
        db21b -= tb8 * e1_3;
        db21bd -= tb8d * e1_3 + tb8 * e1_3d;
        e2_2b -= tb8 * db22;
        e2_2bd -= tb8d * db22 + tb8 * db22d;
        db22b -= tb8 * e2_2;
        db22bd -= tb8d * e2_2 + tb8 * e2_2d;
      }
      c22b = db22b;
      c22bd = db22bd;
      e32b = db22b;
      e32bd = db22bd;
      c21b = db21b;
      c21bd = db21bd;
      e31b = db21b;
      e31bd = db21bd;
      c20b = db20b;
      c20bd = db20bd;
      e30b = db20b;
      e30bd = db20bd;
      w60b = e32b * db11;
      w60bd = e32bd * db11 + e32b * db11d;
      db11b += e32b * w60;
      db11bd += e32bd * w60 + e32b * w60d;
      w61b = -(e32b * db10);
      w61bd = -(e32bd * db10 + e32b * db10d);
      db10b -= e32b * w61;
      db10bd -= e32bd * w61 + e32b * w61d;
      w62b = e31b * db10;
      w62bd = e31bd * db10 + e31b * db10d;
      db10b += e31b * w62;
      db10bd += e31bd * w62 + e31b * w62d;
      w60b -= e31b * db12;
      w60bd -= e31bd * db12 + e31b * db12d;
      db12b -= e31b * w60;
      db12bd -= e31bd * w60 + e31b * w60d;
      w61b += e30b * db12;
      w61bd += e30bd * db12 + e30b * db12d;
      db12b += e30b * w61;
      db12bd += e30bd * w61 + e30b * w61d;
      w62b -= e30b * db11;
      w62bd -= e30bd * db11 + e30b * db11d;
      db11b -= e30b * w62;
      db11bd -= e30bd * w62 + e30b * w62d;
      Z_b5b = w62b;
      Z_b5bd = w62bd;
      Z_b4b = w61b;
      Z_b4bd = w61bd;
      Z_b3b = w60b;
      /* u' = w × u */
      Z_b3bd = w60bd;
      w50b = c22b * dir_i1_2;
      w50bd = c22bd * dir_i1_2 + c22b * dir_i1_2d;
      dir_i1_2b = c22b * w50;
      dir_i1_2bd = c22bd * w50 + c22b * w50d;
      w51b = -(c22b * dir_i0_2);
      w51bd = -(c22bd * dir_i0_2 + c22b * dir_i0_2d);
      dir_i0_2b = -(c22b * w51);
      dir_i0_2bd = -(c22bd * w51 + c22b * w51d);
      w52b = c21b * dir_i0_2;
      w52bd = c21bd * dir_i0_2 + c21b * dir_i0_2d;
      dir_i0_2b += c21b * w52;
      dir_i0_2bd += c21bd * w52 + c21b * w52d;
      w50b -= c21b * dir_i2_2;
      w50bd -= c21bd * dir_i2_2 + c21b * dir_i2_2d;
      dir_i2_2b = -(c21b * w50);
      dir_i2_2bd = -(c21bd * w50 + c21b * w50d);
      w51b += c20b * dir_i2_2;
      w51bd += c20bd * dir_i2_2 + c20b * dir_i2_2d;
      dir_i2_2b += c20b * w51;
      dir_i2_2bd += c20bd * w51 + c20b * w51d;
      w52b -= c20b * dir_i1_2;
      w52bd -= c20bd * dir_i1_2 + c20b * dir_i1_2d;
      dir_i1_2b -= c20b * w52;
      dir_i1_2bd -= c20bd * w52 + c20b * w52d;
      Z0b[b][5] += w52b;
      Z0bd[b][5] += w52bd;
      Z0b[b][4] += w51b;
      Z0bd[b][4] += w51bd;
      Z0b[b][3] += w50b;
      /* u'' = w' × u + w × u'
       * u' = w × u */
      Z0bd[b][3] += w50bd;
      c2_2b = da22b;
      c2_2bd = da22bd;
      e22b = da22b;
      e22bd = da22bd;
      c1b = da21b;
      c1bd = da21bd;
      e21b = da21b;
      e21bd = da21bd;
      c0b = da20b;
      c0bd = da20bd;
      e20b = da20b;
      e20bd = da20bd;
      w40b = e22b * da11;
      w40bd = e22bd * da11 + e22b * da11d;
      da11b += e22b * w40;
      da11bd += e22bd * w40 + e22b * w40d;
      w41b = -(e22b * da10);
      w41bd = -(e22bd * da10 + e22b * da10d);
      da10b -= e22b * w41;
      da10bd -= e22bd * w41 + e22b * w41d;
      w42b = e21b * da10;
      w42bd = e21bd * da10 + e21b * da10d;
      da10b += e21b * w42;
      da10bd += e21bd * w42 + e21b * w42d;
      w40b -= e21b * da12;
      w40bd -= e21bd * da12 + e21b * da12d;
      da12b -= e21b * w40;
      da12bd -= e21bd * w40 + e21b * w40d;
      w41b += e20b * da12;
      w41bd += e20bd * da12 + e20b * da12d;
      da12b += e20b * w41;
      da12bd += e20bd * w41 + e20b * w41d;
      w42b -= e20b * da11;
      w42bd -= e20bd * da11 + e20b * da11d;
      da11b -= e20b * w42;
      da11bd -= e20bd * w42 + e20b * w42d;
      Z_a5b = w42b;
      Z_a5bd = w42bd;
      Z_a4b = w41b;
      Z_a4bd = w41bd;
      Z_a3b = w40b;
      /* u' = w × u */
      Z_a3bd = w40bd;
      w30b = c2_2b * dir_i1;
      w30bd = c2_2bd * dir_i1 + c2_2b * dir_i1d;
      dir_i1b = c2_2b * w30;
      dir_i1bd = c2_2bd * w30 + c2_2b * w30d;
      w31b = -(c2_2b * dir_i0);
      w31bd = -(c2_2bd * dir_i0 + c2_2b * dir_i0d);
      dir_i0b = -(c2_2b * w31);
      dir_i0bd = -(c2_2bd * w31 + c2_2b * w31d);
      w32b = c1b * dir_i0;
      w32bd = c1bd * dir_i0 + c1b * dir_i0d;
      dir_i0b += c1b * w32;
      dir_i0bd += c1bd * w32 + c1b * w32d;
      w30b -= c1b * dir_i2;
      w30bd -= c1bd * dir_i2 + c1b * dir_i2d;
      dir_i2b = -(c1b * w30);
      dir_i2bd = -(c1bd * w30 + c1b * w30d);
      w31b += c0b * dir_i2;
      w31bd += c0bd * dir_i2 + c0b * dir_i2d;
      dir_i2b += c0b * w31;
      dir_i2bd += c0bd * w31 + c0b * w31d;
      w32b -= c0b * dir_i1;
      w32bd -= c0bd * dir_i1 + c0b * dir_i1d;
      dir_i1b -= c0b * w32;
      dir_i1bd -= c0bd * w32 + c0b * w32d;
      Z0b[a][5] += w32b;
      Z0bd[a][5] += w32bd;
      Z0b[a][4] += w31b;
      Z0bd[a][4] += w31bd;
      Z0b[a][3] += w30b;
      /* u'' = w' × u + w × u'
       * u' = w × u */
      Z0bd[a][3] += w30bd;
      w20b = db12b * dir_i1_2;
      w20bd = db12bd * dir_i1_2 + db12b * dir_i1_2d;
      dir_i1_2b += db12b * w20;
      dir_i1_2bd += db12bd * w20 + db12b * w20d;
      w21b = -(db12b * dir_i0_2);
      w21bd = -(db12bd * dir_i0_2 + db12b * dir_i0_2d);
      dir_i0_2b -= db12b * w21;
      dir_i0_2bd -= db12bd * w21 + db12b * w21d;
      w22b = db11b * dir_i0_2;
      w22bd = db11bd * dir_i0_2 + db11b * dir_i0_2d;
      dir_i0_2b += db11b * w22;
      dir_i0_2bd += db11bd * w22 + db11b * w22d;
      w20b -= db11b * dir_i2_2;
      w20bd -= db11bd * dir_i2_2 + db11b * dir_i2_2d;
      dir_i2_2b -= db11b * w20;
      dir_i2_2bd -= db11bd * w20 + db11b * w20d;
      dirb[t->primdb[i]][0] += dir_i0_2b;
      dirbd[t->primdb[i]][0] += dir_i0_2bd;
      w21b += db10b * dir_i2_2;
      w21bd += db10bd * dir_i2_2 + db10b * dir_i2_2d;
      dir_i2_2b += db10b * w21;
      dir_i2_2bd += db10bd * w21 + db10b * w21d;
      w22b -= db10b * dir_i1_2;
      w22bd -= db10bd * dir_i1_2 + db10b * dir_i1_2d;
      dir_i1_2b -= db10b * w22;
      dir_i1_2bd -= db10bd * w22 + db10b * w22d;
      dirb[t->primdb[i]][1] += dir_i1_2b;
      dirbd[t->primdb[i]][1] += dir_i1_2bd;
      dirb[t->primdb[i]][2] += dir_i2_2b;
      dirbd[t->primdb[i]][2] += dir_i2_2bd;
      Z_b5b += w22b;
      Z_b5bd += w22bd;
      Zb[b][5] += Z_b5b;
      Zbd[b][5] += Z_b5bd;
      Z_b4b += w21b;
      Z_b4bd += w21bd;
      Zb[b][4] += Z_b4b;
      Zbd[b][4] += Z_b4bd;
      Z_b3b += w20b;
      /* u' = w × u */
      Z_b3bd += w20bd;
      Zb[b][3] += Z_b3b;
      Zbd[b][3] += Z_b3bd;
      w0b = da12b * dir_i1;
      w0bd = da12bd * dir_i1 + da12b * dir_i1d;
      dir_i1b += da12b * w0;
      dir_i1bd += da12bd * w0 + da12b * w0d;
      w1b = -(da12b * dir_i0);
      w1bd = -(da12bd * dir_i0 + da12b * dir_i0d);
      dir_i0b -= da12b * w1;
      dir_i0bd -= da12bd * w1 + da12b * w1d;
      w2_2b = da11b * dir_i0;
      w2_2bd = da11bd * dir_i0 + da11b * dir_i0d;
      dir_i0b += da11b * w2_2;
      dir_i0bd += da11bd * w2_2 + da11b * w2_2d;
      w0b -= da11b * dir_i2;
      w0bd -= da11bd * dir_i2 + da11b * dir_i2d;
      dir_i2b -= da11b * w0;
      dir_i2bd -= da11bd * w0 + da11b * w0d;
      dirb[t->primda[i]][0] += dir_i0b;
      dirbd[t->primda[i]][0] += dir_i0bd;
      w1b += da10b * dir_i2;
      w1bd += da10bd * dir_i2 + da10b * dir_i2d;
      dir_i2b += da10b * w1;
      dir_i2bd += da10bd * w1 + da10b * w1d;
      w2_2b -= da10b * dir_i1;
      w2_2bd -= da10bd * dir_i1 + da10b * dir_i1d;
      dir_i1b -= da10b * w2_2;
      dir_i1bd -= da10bd * w2_2 + da10b * w2_2d;
      dirb[t->primda[i]][1] += dir_i1b;
      dirbd[t->primda[i]][1] += dir_i1bd;
      dirb[t->primda[i]][2] += dir_i2b;
      dirbd[t->primda[i]][2] += dir_i2bd;
      Z_a5b += w2_2b;
      Z_a5bd += w2_2bd;
      Zb[a][5] += Z_a5b;
      Zbd[a][5] += Z_a5bd;
      Z_a4b += w1b;
      Z_a4bd += w1bd;
      Zb[a][4] += Z_a4b;
      Zbd[a][4] += Z_a4bd;
      Z_a3b += w0b;
      /* u' = w × u */
      Z_a3bd += w0bd;
      Zb[a][3] += Z_a3b;
      Zbd[a][3] += Z_a3bd;
    }
    rab[t->primpa[i]][2] += ea2b;
    rabd[t->primpa[i]][2] += ea2bd;
    rab[t->primpb[i]][2] -= ea2b;
    rabd[t->primpb[i]][2] -= ea2bd;
    rvb[t->primpa[i]][2] += ev2b;
    rvbd[t->primpa[i]][2] += ev2bd;
    rvb[t->primpb[i]][2] -= ev2b;
    rvbd[t->primpb[i]][2] -= ev2bd;
    rb[t->primpa[i]][2] += e2_2b;
    rbd[t->primpa[i]][2] += e2_2bd;
    rb[t->primpb[i]][2] -= e2_2b;
    rbd[t->primpb[i]][2] -= e2_2bd;
    rab[t->primpa[i]][1] += ea1b;
    rabd[t->primpa[i]][1] += ea1bd;
    rab[t->primpb[i]][1] -= ea1b;
    rabd[t->primpb[i]][1] -= ea1bd;
    rvb[t->primpa[i]][1] += ev1b;
    rvbd[t->primpa[i]][1] += ev1bd;
    rvb[t->primpb[i]][1] -= ev1b;
    rvbd[t->primpb[i]][1] -= ev1bd;
    rb[t->primpa[i]][1] += e1_3b;
    rbd[t->primpa[i]][1] += e1_3bd;
    rb[t->primpb[i]][1] -= e1_3b;
    rbd[t->primpb[i]][1] -= e1_3bd;
    rab[t->primpa[i]][0] += ea0b;
    rabd[t->primpa[i]][0] += ea0bd;
    rab[t->primpb[i]][0] -= ea0b;
    rabd[t->primpb[i]][0] -= ea0bd;
    rvb[t->primpa[i]][0] += ev0b;
    rvbd[t->primpa[i]][0] += ev0bd;
    rvb[t->primpb[i]][0] -= ev0b;
    rvbd[t->primpb[i]][0] -= ev0bd;
    rb[t->primpa[i]][0] += e0b;
    /* minus the second derivative of the equation with all joint accelerations zero */
    rbd[t->primpa[i]][0] += e0bd;
    rb[t->primpb[i]][0] -= e0b;
    rbd[t->primpb[i]][0] -= e0bd;
  }
}
