/* Adjoint of core/kernel/loop.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

void maggi_loop_residual_b(const maggi_topo *t, const double prim0[restrict t->nprim],
                           double prim0b[restrict t->nprim], const double r[restrict t->npoint][3],
                           double rb[restrict t->npoint][3], const double dir[restrict t->ndir][3],
                           double dirb[restrict t->ndir][3], double res[restrict t->nrow],
                           double resb[restrict t->nrow])
{
  int i;
  double e0, e0b, e1, e1b, e2, e2b, prim0_i, prim0_ib, t2, t2b, tb2, tb3, tb4, tb5, tb6, tb7, tb8;

  for (i = t->nprim - 1; i >= 0; --i) {
    e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
    e1 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
    e2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
    e0b = 0.0;
    e1b = 0.0;
    e2b = 0.0;
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
      e2b += resb[t->primrow[i] + 2];
      resb[t->primrow[i] + 2] = 0.0;
      e1b += resb[t->primrow[i] + 1];
      resb[t->primrow[i] + 1] = 0.0;
      e0b += resb[t->primrow[i]];
      resb[t->primrow[i]] = 0.0;
    } else if (t->primkind[i] == MAGGI_PRIM_AXIS) {
      tb4 = resb[t->primrow[i] + 2];
      resb[t->primrow[i] + 2] = 0.0;
      dirb[t->primda[i]][2] += tb4;
      dirb[t->primdb[i]][2] -= tb4;
      tb3 = resb[t->primrow[i] + 1];
      resb[t->primrow[i] + 1] = 0.0;
      dirb[t->primda[i]][1] += tb3;
      dirb[t->primdb[i]][1] -= tb3;
      tb2 = resb[t->primrow[i]];
      resb[t->primrow[i]] = 0.0;
      dirb[t->primda[i]][0] += tb2;
      dirb[t->primdb[i]][0] -= tb2;
    } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
      tb5 = resb[t->primrow[i]];
      resb[t->primrow[i]] = 0.0;
      dirb[t->primda[i]][0] += tb5 * dir[t->primdb[i]][0];
      dirb[t->primdb[i]][0] += tb5 * dir[t->primda[i]][0];
      dirb[t->primda[i]][1] += tb5 * dir[t->primdb[i]][1];
      dirb[t->primdb[i]][1] += tb5 * dir[t->primda[i]][1];
      dirb[t->primda[i]][2] += tb5 * dir[t->primdb[i]][2];
      dirb[t->primdb[i]][2] += tb5 * dir[t->primda[i]][2];
      prim0b[i] -= tb5;
    } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
      tb6 = resb[t->primrow[i]];
      resb[t->primrow[i]] = 0.0;
      e0b += tb6 * dir[t->primdb[i]][0];
      dirb[t->primdb[i]][0] += tb6 * e0;
      e1b += tb6 * dir[t->primdb[i]][1];
      dirb[t->primdb[i]][1] += tb6 * e1;
      e2b += tb6 * dir[t->primdb[i]][2];
      dirb[t->primdb[i]][2] += tb6 * e2;
    } else {
      prim0_i = prim0[i];
      t2 = 2.0 * prim0_i;
      tb7 = resb[t->primrow[i]];
      resb[t->primrow[i]] = 0.0;
      tb8 = tb7 / t2;
      e0b += tb8 * e0;
      e0b += tb8 * e0;
      e1b += tb8 * e1;
      e1b += tb8 * e1;
      e2b += tb8 * e2;
      e2b += tb8 * e2;
      prim0_ib = -(tb8 * prim0_i);
      prim0_ib -= tb8 * prim0_i;
      t2b = -(tb8 * res[t->primrow[i]]);
      prim0_ib += t2b * 2.0;
      prim0b[i] += prim0_ib;
    }
    rb[t->primpa[i]][2] += e2b;
    rb[t->primpb[i]][2] -= e2b;
    rb[t->primpa[i]][1] += e1b;
    rb[t->primpb[i]][1] -= e1b;
    rb[t->primpa[i]][0] += e0b;
    rb[t->primpb[i]][0] -= e0b;
  }
}

/* entries of the blocks of Phi_d; what the plan does not list is zero */
void maggi_loop_entries_b(const maggi_topo *t, const double prim0[restrict t->nprim],
                          double prim0b[restrict t->nprim], const double r[restrict t->npoint][3],
                          double rb[restrict t->npoint][3], const double dir[restrict t->ndir][3],
                          double dirb[restrict t->ndir][3], const double b[restrict t->nbody][6],
                          double bb[restrict t->nbody][6], double phi[restrict t->nphi],
                          double phib[restrict t->nphi])
{
  int i, k;
  double b_i3, b_i3_2, b_i3_2b, b_i3_3, b_i3_3b, b_i3_4, b_i3_4b, b_i3_5, b_i3_5b, b_i3b, b_i4,
      b_i4_2, b_i4_2b, b_i4_3, b_i4_3b, b_i4_4, b_i4_4b, b_i4_5, b_i4_5b, b_i4b, b_i5, b_i5_2,
      b_i5_2b, b_i5_3, b_i5_3b, b_i5_4, b_i5_4b, b_i5_5, b_i5_5b, b_i5b, c0_2, c0_2b, c0_3, c0_3b,
      c0b, c1_2, c1_2b, c1_3, c1_3b, c1b, c2_2, c2_2b, c2_3, c2_3b, c2b, dir_k0, dir_k0_2,
      dir_k0_2b, dir_k0_3, dir_k0_3b, dir_k0_4, dir_k0_4b, dir_k0b, dir_k1, dir_k1_2, dir_k1_2b,
      dir_k1_3, dir_k1_3b, dir_k1_4, dir_k1_4b, dir_k1b, dir_k2, dir_k2_2, dir_k2_2b, dir_k2_3,
      dir_k2_3b, dir_k2_4, dir_k2_4b, dir_k2b, e0b, e1b, e2b, j0_2, j0_2b, j0_3, j0_3b, j0b, j1_2,
      j1_2b, j1_3, j1_3b, j1b, j2_2, j2_2b, j2_3, j2_3b, j2b, r_k0, r_k0_2, r_k0_2b, r_k0_3,
      r_k0_3b, r_k0_4, r_k0_4b, r_k0_5, r_k0_5b, r_k0b, r_k1, r_k1_2, r_k1_2b, r_k1_3, r_k1_3b,
      r_k1_4, r_k1_4b, r_k1_5, r_k1_5b, r_k1b, r_k2, r_k2_2, r_k2_2b, r_k2_3, r_k2_3b, r_k2_4,
      r_k2_4b, r_k2_5, r_k2_5b, r_k2b, s, t2, t2b, tb2, tb3, tb4, tb5, w0, w0b, w1, w1b, w2, w2b;

  (void)phi;
  for (i = t->nent - 1; i >= 0; --i) {
    k = t->entprim[i];
    s = t->entside[i] == 0 ? 1.0 : -1.0;
    w0 = b[t->qbody[t->entq[i]]][3];
    w1 = b[t->qbody[t->entq[i]]][4];
    w2 = b[t->qbody[t->entq[i]]][5];
    e1b = 0.0;
    e2b = 0.0;
    if (t->primkind[k] == MAGGI_PRIM_POINT || t->primkind[k] == MAGGI_PRIM_AXIS) {
      e2b += phib[t->entadr[i] + 2 * t->entstep[i]];
      phib[t->entadr[i] + 2 * t->entstep[i]] = 0.0;
      e1b += phib[t->entadr[i] + t->entstep[i]];
      phib[t->entadr[i] + t->entstep[i]] = 0.0;
    }
    e0b = phib[t->entadr[i]];
    phib[t->entadr[i]] = 0.0;
    w0b = 0.0;
    w1b = 0.0;
    w2b = 0.0;
    if (t->primkind[k] == MAGGI_PRIM_POINT) {
      j2b = e2b * s;
      e2b = 0.0;
      j1b = e1b * s;
      e1b = 0.0;
      j0b = e0b * s;
      e0b = 0.0;
      if (t->entside[i] == 0) {
        b_i4 = b[t->qbody[t->entq[i]]][4];
        r_k2 = r[t->primpa[k]][2];
        b_i5 = b[t->qbody[t->entq[i]]][5];
        r_k1 = r[t->primpa[k]][1];
        r_k0 = r[t->primpa[k]][0];
        b_i3 = b[t->qbody[t->entq[i]]][3];
        bb[t->qbody[t->entq[i]]][2] += j2b;
        b_i3b = j2b * r_k1;
        r_k1b = j2b * b_i3;
        b_i4b = -(j2b * r_k0);
        r_k0b = -(j2b * b_i4);
        j2b = 0.0;
        bb[t->qbody[t->entq[i]]][1] += j1b;
        b_i5b = j1b * r_k0;
        r_k0b += j1b * b_i5;
        b_i3b -= j1b * r_k2;
        r_k2b = -(j1b * b_i3);
        j1b = 0.0;
        bb[t->qbody[t->entq[i]]][3] += b_i3b;
        rb[t->primpa[k]][0] += r_k0b;
        bb[t->qbody[t->entq[i]]][0] += j0b;
        b_i4b += j0b * r_k2;
        r_k2b += j0b * b_i4;
        b_i5b -= j0b * r_k1;
        r_k1b -= j0b * b_i5;
        j0b = 0.0;
        rb[t->primpa[k]][1] += r_k1b;
        bb[t->qbody[t->entq[i]]][5] += b_i5b;
        rb[t->primpa[k]][2] += r_k2b;
        bb[t->qbody[t->entq[i]]][4] += b_i4b;
      } else {
        b_i4_2 = b[t->qbody[t->entq[i]]][4];
        r_k2_2 = r[t->primpb[k]][2];
        b_i5_2 = b[t->qbody[t->entq[i]]][5];
        r_k1_2 = r[t->primpb[k]][1];
        r_k0_2 = r[t->primpb[k]][0];
        b_i3_2 = b[t->qbody[t->entq[i]]][3];
        bb[t->qbody[t->entq[i]]][2] += j2b;
        b_i3_2b = j2b * r_k1_2;
        r_k1_2b = j2b * b_i3_2;
        b_i4_2b = -(j2b * r_k0_2);
        r_k0_2b = -(j2b * b_i4_2);
        j2b = 0.0;
        bb[t->qbody[t->entq[i]]][1] += j1b;
        b_i5_2b = j1b * r_k0_2;
        r_k0_2b += j1b * b_i5_2;
        b_i3_2b -= j1b * r_k2_2;
        r_k2_2b = -(j1b * b_i3_2);
        j1b = 0.0;
        bb[t->qbody[t->entq[i]]][3] += b_i3_2b;
        rb[t->primpb[k]][0] += r_k0_2b;
        bb[t->qbody[t->entq[i]]][0] += j0b;
        b_i4_2b += j0b * r_k2_2;
        r_k2_2b += j0b * b_i4_2;
        b_i5_2b -= j0b * r_k1_2;
        r_k1_2b -= j0b * b_i5_2;
        j0b = 0.0;
        rb[t->primpb[k]][1] += r_k1_2b;
        bb[t->qbody[t->entq[i]]][5] += b_i5_2b;
        rb[t->primpb[k]][2] += r_k2_2b;
        bb[t->qbody[t->entq[i]]][4] += b_i4_2b;
      }
    } else if (t->primkind[k] == MAGGI_PRIM_AXIS) {
      c2b = e2b * s;
      e2b = 0.0;
      c1b = e1b * s;
      e1b = 0.0;
      c0b = e0b * s;
      e0b = 0.0;
      if (t->entside[i] == 0) {
        dir_k2 = dir[t->primda[k]][2];
        dir_k1 = dir[t->primda[k]][1];
        dir_k0 = dir[t->primda[k]][0];
        w0b += c2b * dir_k1;
        dir_k1b = c2b * w0;
        w1b -= c2b * dir_k0;
        dir_k0b = -(c2b * w1);
        c2b = 0.0;
        w2b += c1b * dir_k0;
        dir_k0b += c1b * w2;
        w0b -= c1b * dir_k2;
        dir_k2b = -(c1b * w0);
        c1b = 0.0;
        dirb[t->primda[k]][0] += dir_k0b;
        w1b += c0b * dir_k2;
        dir_k2b += c0b * w1;
        w2b -= c0b * dir_k1;
        dir_k1b -= c0b * w2;
        c0b = 0.0;
        dirb[t->primda[k]][1] += dir_k1b;
        dirb[t->primda[k]][2] += dir_k2b;
      } else {
        dir_k2_2 = dir[t->primdb[k]][2];
        dir_k1_2 = dir[t->primdb[k]][1];
        dir_k0_2 = dir[t->primdb[k]][0];
        w0b += c2b * dir_k1_2;
        dir_k1_2b = c2b * w0;
        w1b -= c2b * dir_k0_2;
        dir_k0_2b = -(c2b * w1);
        c2b = 0.0;
        w2b += c1b * dir_k0_2;
        dir_k0_2b += c1b * w2;
        w0b -= c1b * dir_k2_2;
        dir_k2_2b = -(c1b * w0);
        c1b = 0.0;
        dirb[t->primdb[k]][0] += dir_k0_2b;
        w1b += c0b * dir_k2_2;
        dir_k2_2b += c0b * w1;
        w2b -= c0b * dir_k1_2;
        dir_k1_2b -= c0b * w2;
        c0b = 0.0;
        dirb[t->primdb[k]][1] += dir_k1_2b;
        dirb[t->primdb[k]][2] += dir_k2_2b;
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
      e2b = 0.0;
      e1b = 0.0;
      tb2 = e0b * s;
      w0b += tb2 * c0_2;
      c0_2b = tb2 * w0;
      w1b += tb2 * c1_2;
      c1_2b = tb2 * w1;
      w2b += tb2 * c2_2;
      c2_2b = tb2 * w2;
      e0b = 0.0;
      dir_k0_4b = c2_2b * dir_k1_4;
      dir_k1_4b = c2_2b * dir_k0_4;
      dir_k1_3b = -(c2_2b * dir_k0_3);
      dir_k0_3b = -(c2_2b * dir_k1_3);
      dir_k2_4b = c1_2b * dir_k0_3;
      dir_k0_3b += c1_2b * dir_k2_4;
      dir_k0_4b -= c1_2b * dir_k2_3;
      dir_k2_3b = -(c1_2b * dir_k0_4);
      dirb[t->primda[k]][0] += dir_k0_4b;
      dirb[t->primdb[k]][0] += dir_k0_3b;
      dir_k1_3b += c0_2b * dir_k2_3;
      dir_k2_3b += c0_2b * dir_k1_3;
      dir_k2_4b -= c0_2b * dir_k1_4;
      dir_k1_4b -= c0_2b * dir_k2_4;
      dirb[t->primdb[k]][1] += dir_k1_4b;
      dirb[t->primda[k]][2] += dir_k2_4b;
      dirb[t->primdb[k]][2] += dir_k2_3b;
      dirb[t->primda[k]][1] += dir_k1_3b;
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
      e2b = 0.0;
      e1b = 0.0;
      tb3 = e0b * s;
      dirb[t->primdb[k]][0] += tb3 * j0_2;
      j0_2b = tb3 * dir[t->primdb[k]][0];
      dirb[t->primdb[k]][1] += tb3 * j1_2;
      j1_2b = tb3 * dir[t->primdb[k]][1];
      dirb[t->primdb[k]][2] += tb3 * j2_2;
      j2_2b = tb3 * dir[t->primdb[k]][2];
      e0b = 0.0;
      bb[t->qbody[t->entq[i]]][2] += j2_2b;
      b_i3_3b = j2_2b * r_k1_3;
      r_k1_3b = j2_2b * b_i3_3;
      b_i4_3b = -(j2_2b * r_k0_3);
      r_k0_3b = -(j2_2b * b_i4_3);
      bb[t->qbody[t->entq[i]]][1] += j1_2b;
      b_i5_3b = j1_2b * r_k0_3;
      r_k0_3b += j1_2b * b_i5_3;
      b_i3_3b -= j1_2b * r_k2_3;
      r_k2_3b = -(j1_2b * b_i3_3);
      bb[t->qbody[t->entq[i]]][3] += b_i3_3b;
      rb[t->primpa[k]][0] += r_k0_3b;
      bb[t->qbody[t->entq[i]]][0] += j0_2b;
      b_i4_3b += j0_2b * r_k2_3;
      r_k2_3b += j0_2b * b_i4_3;
      b_i5_3b -= j0_2b * r_k1_3;
      r_k1_3b -= j0_2b * b_i5_3;
      rb[t->primpa[k]][1] += r_k1_3b;
      bb[t->qbody[t->entq[i]]][5] += b_i5_3b;
      rb[t->primpa[k]][2] += r_k2_3b;
      bb[t->qbody[t->entq[i]]][4] += b_i4_3b;
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
      }
      c0_3 = r[t->primpa[k]][0] - r[t->primpb[k]][0];
      c1_3 = r[t->primpa[k]][1] - r[t->primpb[k]][1];
      c2_3 = r[t->primpa[k]][2] - r[t->primpb[k]][2];
      t2 = s * (c0_3 * j0_3 + c1_3 * j1_3 + c2_3 * j2_3) / prim0[k];
      e2b = 0.0;
      e1b = 0.0;
      t2b = e0b;
      e0b = 0.0;
      tb4 = t2b / prim0[k];
      tb5 = tb4 * s;
      c0_3b = tb5 * j0_3;
      j0_3b = tb5 * c0_3;
      c1_3b = tb5 * j1_3;
      j1_3b = tb5 * c1_3;
      c2_3b = tb5 * j2_3;
      j2_3b = tb5 * c2_3;
      prim0b[k] -= tb4 * t2;
      rb[t->primpa[k]][2] += c2_3b;
      rb[t->primpb[k]][2] -= c2_3b;
      rb[t->primpa[k]][1] += c1_3b;
      rb[t->primpb[k]][1] -= c1_3b;
      rb[t->primpa[k]][0] += c0_3b;
      rb[t->primpb[k]][0] -= c0_3b;
      if (t->entside[i] == 0) {
        b_i4_4 = b[t->qbody[t->entq[i]]][4];
        r_k2_4 = r[t->primpa[k]][2];
        b_i5_4 = b[t->qbody[t->entq[i]]][5];
        r_k1_4 = r[t->primpa[k]][1];
        r_k0_4 = r[t->primpa[k]][0];
        b_i3_4 = b[t->qbody[t->entq[i]]][3];
        bb[t->qbody[t->entq[i]]][2] += j2_3b;
        b_i3_4b = j2_3b * r_k1_4;
        r_k1_4b = j2_3b * b_i3_4;
        b_i4_4b = -(j2_3b * r_k0_4);
        r_k0_4b = -(j2_3b * b_i4_4);
        j2_3b = 0.0;
        bb[t->qbody[t->entq[i]]][1] += j1_3b;
        b_i5_4b = j1_3b * r_k0_4;
        r_k0_4b += j1_3b * b_i5_4;
        b_i3_4b -= j1_3b * r_k2_4;
        r_k2_4b = -(j1_3b * b_i3_4);
        j1_3b = 0.0;
        bb[t->qbody[t->entq[i]]][3] += b_i3_4b;
        rb[t->primpa[k]][0] += r_k0_4b;
        bb[t->qbody[t->entq[i]]][0] += j0_3b;
        b_i4_4b += j0_3b * r_k2_4;
        r_k2_4b += j0_3b * b_i4_4;
        b_i5_4b -= j0_3b * r_k1_4;
        r_k1_4b -= j0_3b * b_i5_4;
        j0_3b = 0.0;
        rb[t->primpa[k]][1] += r_k1_4b;
        bb[t->qbody[t->entq[i]]][5] += b_i5_4b;
        rb[t->primpa[k]][2] += r_k2_4b;
        bb[t->qbody[t->entq[i]]][4] += b_i4_4b;
      } else {
        b_i4_5 = b[t->qbody[t->entq[i]]][4];
        r_k2_5 = r[t->primpb[k]][2];
        b_i5_5 = b[t->qbody[t->entq[i]]][5];
        r_k1_5 = r[t->primpb[k]][1];
        r_k0_5 = r[t->primpb[k]][0];
        b_i3_5 = b[t->qbody[t->entq[i]]][3];
        bb[t->qbody[t->entq[i]]][2] += j2_3b;
        b_i3_5b = j2_3b * r_k1_5;
        r_k1_5b = j2_3b * b_i3_5;
        b_i4_5b = -(j2_3b * r_k0_5);
        r_k0_5b = -(j2_3b * b_i4_5);
        j2_3b = 0.0;
        bb[t->qbody[t->entq[i]]][1] += j1_3b;
        b_i5_5b = j1_3b * r_k0_5;
        r_k0_5b += j1_3b * b_i5_5;
        b_i3_5b -= j1_3b * r_k2_5;
        r_k2_5b = -(j1_3b * b_i3_5);
        j1_3b = 0.0;
        bb[t->qbody[t->entq[i]]][3] += b_i3_5b;
        rb[t->primpb[k]][0] += r_k0_5b;
        bb[t->qbody[t->entq[i]]][0] += j0_3b;
        b_i4_5b += j0_3b * r_k2_5;
        r_k2_5b += j0_3b * b_i4_5;
        b_i5_5b -= j0_3b * r_k1_5;
        r_k1_5b -= j0_3b * b_i5_5;
        j0_3b = 0.0;
        rb[t->primpb[k]][1] += r_k1_5b;
        bb[t->qbody[t->entq[i]]][5] += b_i5_5b;
        rb[t->primpb[k]][2] += r_k2_5b;
        bb[t->qbody[t->entq[i]]][4] += b_i4_5b;
      }
    }
    bb[t->qbody[t->entq[i]]][5] += w2b;
    bb[t->qbody[t->entq[i]]][4] += w1b;
    bb[t->qbody[t->entq[i]]][3] += w0b;
  }
}

void maggi_loop_rates_b(const maggi_topo *t, const double prim0[restrict t->nprim],
                        double prim0b[restrict t->nprim], const double r[restrict t->npoint][3],
                        double rb[restrict t->npoint][3], const double dir[restrict t->ndir][3],
                        double dirb[restrict t->ndir][3], const double rv[restrict t->npoint][3],
                        double rvb[restrict t->npoint][3], const double Z[restrict t->nbody + 1][6],
                        double Zb[restrict t->nbody + 1][6], double rate[restrict t->nrow],
                        double rateb[restrict t->nrow])
{
  int c, i, i2;
  double da10, da10b, da11, da11b, da12, da12b, db10, db10b, db11, db11b, db12, db12b, dir_i0,
      dir_i0_2, dir_i0_2b, dir_i0b, dir_i1, dir_i1_2, dir_i1_2b, dir_i1b, dir_i2, dir_i2_2,
      dir_i2_2b, dir_i2b, e0, e0b, e10b, e11b, e12b, e1_3, e1_3b, e1_4b, e1_5b, e1_6b, e20, e20b,
      e21, e21b, e22, e22b, e2_2, e2_2b, e30, e30b, e31, e31b, e32, e32b, ev0, ev0b, ev1, ev1b, ev2,
      ev2b, s, t2, t2b, tb2, tb3, tb4, tb5, tb6, tb7, w0, w0b, w1, w1b, w20, w20b, w21, w21b, w22,
      w22b, w2_2, w2_2b, w30, w30b, w31, w31b, w32, w32b, w40, w40b, w41, w41b, w42, w42b;

  (void)rate;
  s = -1.0;
  /* what turning with the bodies that carry both sides does to open points and axes */
  for (i2 = t->nprim - 1; i2 >= 0; --i2) {
    c = t->loopcommon[t->primloop[i2]];
    if (c < t->nbody && t->primkind[i2] == MAGGI_PRIM_POINT) {
      e20 = r[t->primpa[i2]][0] - r[t->primpb[i2]][0];
      e21 = r[t->primpa[i2]][1] - r[t->primpb[i2]][1];
      e22 = r[t->primpa[i2]][2] - r[t->primpb[i2]][2];
      w30 = Z[c][3];
      w31 = Z[c][4];
      w32 = Z[c][5];
      e12b = rateb[t->primrow[i2] + 2] * s;
      e11b = rateb[t->primrow[i2] + 1] * s;
      e10b = rateb[t->primrow[i2]] * s;
      w30b = e12b * e21;
      e21b = e12b * w30;
      w31b = -(e12b * e20);
      e20b = -(e12b * w31);
      w32b = e11b * e20;
      e20b += e11b * w32;
      w30b -= e11b * e22;
      e22b = -(e11b * w30);
      w31b += e10b * e22;
      e22b += e10b * w31;
      w32b -= e10b * e21;
      e21b -= e10b * w32;
      Zb[c][5] += w32b;
      Zb[c][4] += w31b;
      /* u' = w × u */
      Zb[c][3] += w30b;
      rb[t->primpa[i2]][2] += e22b;
      rb[t->primpb[i2]][2] -= e22b;
      rb[t->primpa[i2]][1] += e21b;
      rb[t->primpb[i2]][1] -= e21b;
      /* y += s w × (a - b) */
      rb[t->primpa[i2]][0] += e20b;
      rb[t->primpb[i2]][0] -= e20b;
    } else if (c < t->nbody && t->primkind[i2] == MAGGI_PRIM_AXIS) {
      e30 = dir[t->primda[i2]][0] - dir[t->primdb[i2]][0];
      e31 = dir[t->primda[i2]][1] - dir[t->primdb[i2]][1];
      e32 = dir[t->primda[i2]][2] - dir[t->primdb[i2]][2];
      w40 = Z[c][3];
      w41 = Z[c][4];
      w42 = Z[c][5];
      e1_6b = rateb[t->primrow[i2] + 2] * s;
      e1_5b = rateb[t->primrow[i2] + 1] * s;
      e1_4b = rateb[t->primrow[i2]] * s;
      w40b = e1_6b * e31;
      e31b = e1_6b * w40;
      w41b = -(e1_6b * e30);
      e30b = -(e1_6b * w41);
      w42b = e1_5b * e30;
      e30b += e1_5b * w42;
      w40b -= e1_5b * e32;
      e32b = -(e1_5b * w40);
      w41b += e1_4b * e32;
      e32b += e1_4b * w41;
      w42b -= e1_4b * e31;
      e31b -= e1_4b * w42;
      Zb[c][5] += w42b;
      Zb[c][4] += w41b;
      /* u' = w × u */
      Zb[c][3] += w40b;
      dirb[t->primda[i2]][2] += e32b;
      dirb[t->primdb[i2]][2] -= e32b;
      dirb[t->primda[i2]][1] += e31b;
      dirb[t->primdb[i2]][1] -= e31b;
      /* y += s w × (a - b) */
      dirb[t->primda[i2]][0] += e30b;
      dirb[t->primdb[i2]][0] -= e30b;
    }
  }
  for (i = t->nprim - 1; i >= 0; --i) {
    e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
    ev0 = rv[t->primpa[i]][0] - rv[t->primpb[i]][0];
    e1_3 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
    ev1 = rv[t->primpa[i]][1] - rv[t->primpb[i]][1];
    e2_2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
    ev2 = rv[t->primpa[i]][2] - rv[t->primpb[i]][2];
    e0b = 0.0;
    e1_3b = 0.0;
    e2_2b = 0.0;
    ev0b = 0.0;
    ev1b = 0.0;
    ev2b = 0.0;
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
      ev2b += rateb[t->primrow[i] + 2];
      rateb[t->primrow[i] + 2] = 0.0;
      ev1b += rateb[t->primrow[i] + 1];
      rateb[t->primrow[i] + 1] = 0.0;
      ev0b += rateb[t->primrow[i]];
      rateb[t->primrow[i]] = 0.0;
    } else if (t->primkind[i] == MAGGI_PRIM_ROD) {
      t2 = (ev0 * e0 + ev1 * e1_3 + ev2 * e2_2) / prim0[i];
      t2b = rateb[t->primrow[i]];
      rateb[t->primrow[i]] = 0.0;
      tb2 = t2b / prim0[i];
      ev0b += tb2 * e0;
      e0b += tb2 * ev0;
      ev1b += tb2 * e1_3;
      e1_3b += tb2 * ev1;
      ev2b += tb2 * e2_2;
      e2_2b += tb2 * ev2;
      prim0b[i] -= tb2 * t2;
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
      da10b = 0.0;
      da11b = 0.0;
      da12b = 0.0;
      db10b = 0.0;
      db11b = 0.0;
      db12b = 0.0;
      if (t->primkind[i] == MAGGI_PRIM_AXIS) {
        tb5 = rateb[t->primrow[i] + 2];
        rateb[t->primrow[i] + 2] = 0.0;
        da12b += tb5;
        db12b -= tb5;
        tb4 = rateb[t->primrow[i] + 1];
        rateb[t->primrow[i] + 1] = 0.0;
        da11b += tb4;
        db11b -= tb4;
        tb3 = rateb[t->primrow[i]];
        rateb[t->primrow[i]] = 0.0;
        da10b += tb3;
        db10b -= tb3;
      } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
        tb6 = rateb[t->primrow[i]];
        rateb[t->primrow[i]] = 0.0;
        da10b += tb6 * dir[t->primdb[i]][0];
        dirb[t->primdb[i]][0] += tb6 * da10;
        da11b += tb6 * dir[t->primdb[i]][1];
        dirb[t->primdb[i]][1] += tb6 * da11;
        da12b += tb6 * dir[t->primdb[i]][2];
        dirb[t->primdb[i]][2] += tb6 * da12;
        dirb[t->primda[i]][0] += tb6 * db10;
        db10b += tb6 * dir[t->primda[i]][0];
        dirb[t->primda[i]][1] += tb6 * db11;
        db11b += tb6 * dir[t->primda[i]][1];
        dirb[t->primda[i]][2] += tb6 * db12;
        db12b += tb6 * dir[t->primda[i]][2];
      } else {
        tb7 = rateb[t->primrow[i]];
        rateb[t->primrow[i]] = 0.0;
        ev0b += tb7 * dir[t->primdb[i]][0];
        dirb[t->primdb[i]][0] += tb7 * ev0;
        ev1b += tb7 * dir[t->primdb[i]][1];
        dirb[t->primdb[i]][1] += tb7 * ev1;
        ev2b += tb7 * dir[t->primdb[i]][2];
        dirb[t->primdb[i]][2] += tb7 * ev2;
        e0b += tb7 * db10;
        db10b += tb7 * e0;
        e1_3b += tb7 * db11;
        db11b += tb7 * e1_3;
        e2_2b += tb7 * db12;
        db12b += tb7 * e2_2;
      }
      w20b = db12b * dir_i1_2;
      dir_i1_2b = db12b * w20;
      w21b = -(db12b * dir_i0_2);
      dir_i0_2b = -(db12b * w21);
      w22b = db11b * dir_i0_2;
      dir_i0_2b += db11b * w22;
      w20b -= db11b * dir_i2_2;
      dir_i2_2b = -(db11b * w20);
      dirb[t->primdb[i]][0] += dir_i0_2b;
      w21b += db10b * dir_i2_2;
      dir_i2_2b += db10b * w21;
      w22b -= db10b * dir_i1_2;
      dir_i1_2b -= db10b * w22;
      dirb[t->primdb[i]][1] += dir_i1_2b;
      dirb[t->primdb[i]][2] += dir_i2_2b;
      Zb[t->primbb[i]][5] += w22b;
      Zb[t->primbb[i]][4] += w21b;
      /* u' = w × u */
      Zb[t->primbb[i]][3] += w20b;
      w0b = da12b * dir_i1;
      dir_i1b = da12b * w0;
      w1b = -(da12b * dir_i0);
      dir_i0b = -(da12b * w1);
      w2_2b = da11b * dir_i0;
      dir_i0b += da11b * w2_2;
      w0b -= da11b * dir_i2;
      dir_i2b = -(da11b * w0);
      dirb[t->primda[i]][0] += dir_i0b;
      w1b += da10b * dir_i2;
      dir_i2b += da10b * w1;
      w2_2b -= da10b * dir_i1;
      dir_i1b -= da10b * w2_2;
      dirb[t->primda[i]][1] += dir_i1b;
      dirb[t->primda[i]][2] += dir_i2b;
      Zb[t->primba[i]][5] += w2_2b;
      Zb[t->primba[i]][4] += w1b;
      /* u' = w × u */
      Zb[t->primba[i]][3] += w0b;
    }
    rvb[t->primpa[i]][2] += ev2b;
    rvb[t->primpb[i]][2] -= ev2b;
    rb[t->primpa[i]][2] += e2_2b;
    rb[t->primpb[i]][2] -= e2_2b;
    rvb[t->primpa[i]][1] += ev1b;
    rvb[t->primpb[i]][1] -= ev1b;
    rb[t->primpa[i]][1] += e1_3b;
    rb[t->primpb[i]][1] -= e1_3b;
    rvb[t->primpa[i]][0] += ev0b;
    rvb[t->primpb[i]][0] -= ev0b;
    /* the first derivative of the equation */
    rb[t->primpa[i]][0] += e0b;
    rb[t->primpb[i]][0] -= e0b;
  }
}

void maggi_loop_gamma_b(const maggi_topo *t, const double prim0[restrict t->nprim],
                        double prim0b[restrict t->nprim], const double r[restrict t->npoint][3],
                        double rb[restrict t->npoint][3], const double dir[restrict t->ndir][3],
                        double dirb[restrict t->ndir][3], const double rv[restrict t->npoint][3],
                        double rvb[restrict t->npoint][3], const double ra[restrict t->npoint][3],
                        double rab[restrict t->npoint][3], const double Z[restrict t->nbody + 1][6],
                        double Zb[restrict t->nbody + 1][6],
                        const double Z0[restrict t->nbody + 1][6],
                        double Z0b[restrict t->nbody + 1][6], double gam[restrict t->nrow],
                        double gamb[restrict t->nrow])
{
  int a, b, c3, i, i2;
  double Z_a3, Z_a3b, Z_a4, Z_a4b, Z_a5, Z_a5b, Z_b3, Z_b3b, Z_b4, Z_b4b, Z_b5, Z_b5b, c0, c0b, c1,
      c1b, c20, c20b, c21, c21b, c22, c22b, c2_2, c2_2b, da10, da10b, da11, da11b, da12, da12b,
      da20, da20b, da21, da21b, da22, da22b, db10, db10b, db11, db11b, db12, db12b, db20, db20b,
      db21, db21b, db22, db22b, dir_i0, dir_i0_2, dir_i0_2b, dir_i0b, dir_i1, dir_i1_2, dir_i1_2b,
      dir_i1b, dir_i2, dir_i2_2, dir_i2_2b, dir_i2b, e0, e0b, e10b, e11b, e12b, e1_3, e1_3b, e1_4b,
      e1_5b, e1_6b, e20, e20b, e21, e21b, e22, e22b, e2_2, e2_2b, e30, e30b, e31, e31b, e32, e32b,
      e40, e40b, e41, e41b, e42, e42b, e50, e50b, e51, e51b, e52, e52b, ea0, ea0b, ea1, ea1b, ea2,
      ea2b, ev0, ev0b, ev1, ev1b, ev2, ev2b, t2, t2b, tb2, tb3, tb4, tb5, tb6, tb7, tb8, tb9, w0,
      w0b, w1, w1b, w20, w20b, w21, w21b, w22, w22b, w2_2, w2_2b, w30, w30b, w31, w31b, w32, w32b,
      w40, w40b, w41, w41b, w42, w42b, w50, w50b, w51, w51b, w52, w52b, w60, w60b, w61, w61b, w62,
      w62b, w70, w70b, w71, w71b, w72, w72b, w80, w80b, w81, w81b, w82, w82b;

  (void)gam;
  /* what turning with the bodies that carry both sides does to open points and axes */
  for (i2 = t->nprim - 1; i2 >= 0; --i2) {
    c3 = t->loopcommon[t->primloop[i2]];
    if (c3 < t->nbody && t->primkind[i2] == MAGGI_PRIM_POINT) {
      e40 = r[t->primpa[i2]][0] - r[t->primpb[i2]][0];
      e41 = r[t->primpa[i2]][1] - r[t->primpb[i2]][1];
      e42 = r[t->primpa[i2]][2] - r[t->primpb[i2]][2];
      w70 = Z0[c3][3];
      w71 = Z0[c3][4];
      w72 = Z0[c3][5];
      e12b = gamb[t->primrow[i2] + 2];
      e11b = gamb[t->primrow[i2] + 1];
      e10b = gamb[t->primrow[i2]];
      w70b = e12b * e41;
      e41b = e12b * w70;
      w71b = -(e12b * e40);
      e40b = -(e12b * w71);
      w72b = e11b * e40;
      e40b += e11b * w72;
      w70b -= e11b * e42;
      e42b = -(e11b * w70);
      w71b += e10b * e42;
      e42b += e10b * w71;
      w72b -= e10b * e41;
      e41b -= e10b * w72;
      Z0b[c3][5] += w72b;
      Z0b[c3][4] += w71b;
      /* u' = w × u */
      Z0b[c3][3] += w70b;
      rb[t->primpa[i2]][2] += e42b;
      rb[t->primpb[i2]][2] -= e42b;
      rb[t->primpa[i2]][1] += e41b;
      rb[t->primpb[i2]][1] -= e41b;
      /* y += s w × (a - b) */
      rb[t->primpa[i2]][0] += e40b;
      rb[t->primpb[i2]][0] -= e40b;
    } else if (c3 < t->nbody && t->primkind[i2] == MAGGI_PRIM_AXIS) {
      e50 = dir[t->primda[i2]][0] - dir[t->primdb[i2]][0];
      e51 = dir[t->primda[i2]][1] - dir[t->primdb[i2]][1];
      e52 = dir[t->primda[i2]][2] - dir[t->primdb[i2]][2];
      w80 = Z0[c3][3];
      w81 = Z0[c3][4];
      w82 = Z0[c3][5];
      e1_6b = gamb[t->primrow[i2] + 2];
      e1_5b = gamb[t->primrow[i2] + 1];
      e1_4b = gamb[t->primrow[i2]];
      w80b = e1_6b * e51;
      e51b = e1_6b * w80;
      w81b = -(e1_6b * e50);
      e50b = -(e1_6b * w81);
      w82b = e1_5b * e50;
      e50b += e1_5b * w82;
      w80b -= e1_5b * e52;
      e52b = -(e1_5b * w80);
      w81b += e1_4b * e52;
      e52b += e1_4b * w81;
      w82b -= e1_4b * e51;
      e51b -= e1_4b * w82;
      Z0b[c3][5] += w82b;
      Z0b[c3][4] += w81b;
      /* u' = w × u */
      Z0b[c3][3] += w80b;
      dirb[t->primda[i2]][2] += e52b;
      dirb[t->primdb[i2]][2] -= e52b;
      dirb[t->primda[i2]][1] += e51b;
      dirb[t->primdb[i2]][1] -= e51b;
      /* y += s w × (a - b) */
      dirb[t->primda[i2]][0] += e50b;
      dirb[t->primdb[i2]][0] -= e50b;
    }
  }
  for (i = t->nprim - 1; i >= 0; --i) {
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
    e0b = 0.0;
    e1_3b = 0.0;
    e2_2b = 0.0;
    ea0b = 0.0;
    ea1b = 0.0;
    ea2b = 0.0;
    ev0b = 0.0;
    ev1b = 0.0;
    ev2b = 0.0;
    if (t->primkind[i] == MAGGI_PRIM_POINT) {
      ea2b -= gamb[t->primrow[i] + 2];
      gamb[t->primrow[i] + 2] = 0.0;
      ea1b -= gamb[t->primrow[i] + 1];
      gamb[t->primrow[i] + 1] = 0.0;
      ea0b -= gamb[t->primrow[i]];
      gamb[t->primrow[i]] = 0.0;
    } else if (t->primkind[i] == MAGGI_PRIM_ROD) {
      t2 = -(ea0 * e0 + ea1 * e1_3 + ea2 * e2_2 + (ev0 * ev0 + ev1 * ev1 + ev2 * ev2)) / prim0[i];
      t2b = gamb[t->primrow[i]];
      gamb[t->primrow[i]] = 0.0;
      tb2 = t2b / prim0[i];
      ea0b -= tb2 * e0;
      e0b -= tb2 * ea0;
      ea1b -= tb2 * e1_3;
      e1_3b -= tb2 * ea1;
      ea2b -= tb2 * e2_2;
      e2_2b -= tb2 * ea2;
      ev0b -= tb2 * ev0;
      ev0b -= tb2 * ev0;
      ev1b -= tb2 * ev1;
      ev1b -= tb2 * ev1;
      ev2b -= tb2 * ev2;
      ev2b -= tb2 * ev2;
      prim0b[i] -= tb2 * t2;
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
      da10b = 0.0;
      da11b = 0.0;
      da12b = 0.0;
      da20b = 0.0;
      da21b = 0.0;
      da22b = 0.0;
      db10b = 0.0;
      db11b = 0.0;
      db12b = 0.0;
      db20b = 0.0;
      db21b = 0.0;
      db22b = 0.0;
      if (t->primkind[i] == MAGGI_PRIM_AXIS) {
        tb5 = gamb[t->primrow[i] + 2];
        gamb[t->primrow[i] + 2] = 0.0;
        db22b += tb5;
        da22b -= tb5;
        tb4 = gamb[t->primrow[i] + 1];
        gamb[t->primrow[i] + 1] = 0.0;
        db21b += tb4;
        da21b -= tb4;
        tb3 = gamb[t->primrow[i]];
        gamb[t->primrow[i]] = 0.0;
        db20b += tb3;
        da20b -= tb3;
      } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
        tb6 = gamb[t->primrow[i]];
        gamb[t->primrow[i]] = 0.0;
        da20b -= tb6 * dir[t->primdb[i]][0];
        dirb[t->primdb[i]][0] -= tb6 * da20;
        da21b -= tb6 * dir[t->primdb[i]][1];
        dirb[t->primdb[i]][1] -= tb6 * da21;
        da22b -= tb6 * dir[t->primdb[i]][2];
        dirb[t->primdb[i]][2] -= tb6 * da22;
        tb7 = tb6 * 2.0;
        da10b -= tb7 * db10;
        db10b -= tb7 * da10;
        da11b -= tb7 * db11;
        db11b -= tb7 * da11;
        da12b -= tb7 * db12;
        db12b -= tb7 * da12;
        dirb[t->primda[i]][0] -= tb6 * db20;
        db20b -= tb6 * dir[t->primda[i]][0];
        dirb[t->primda[i]][1] -= tb6 * db21;
        db21b -= tb6 * dir[t->primda[i]][1];
        dirb[t->primda[i]][2] -= tb6 * db22;
        db22b -= tb6 * dir[t->primda[i]][2];
      } else {
        tb8 = gamb[t->primrow[i]];
        gamb[t->primrow[i]] = 0.0;
        ea0b -= tb8 * dir[t->primdb[i]][0];
        dirb[t->primdb[i]][0] -= tb8 * ea0;
        ea1b -= tb8 * dir[t->primdb[i]][1];
        dirb[t->primdb[i]][1] -= tb8 * ea1;
        ea2b -= tb8 * dir[t->primdb[i]][2];
        dirb[t->primdb[i]][2] -= tb8 * ea2;
        tb9 = tb8 * 2.0;
        ev0b -= tb9 * db10;
        db10b -= tb9 * ev0;
        ev1b -= tb9 * db11;
        db11b -= tb9 * ev1;
        ev2b -= tb9 * db12;
        db12b -= tb9 * ev2;
        e0b -= tb8 * db20;
        db20b -= tb8 * e0;
        e1_3b -= tb8 * db21;
        db21b -= tb8 * e1_3;
        e2_2b -= tb8 * db22;
        db22b -= tb8 * e2_2;
      }
      c22b = db22b;
      e32b = db22b;
      c21b = db21b;
      e31b = db21b;
      c20b = db20b;
      e30b = db20b;
      w60b = e32b * db11;
      db11b += e32b * w60;
      w61b = -(e32b * db10);
      db10b -= e32b * w61;
      w62b = e31b * db10;
      db10b += e31b * w62;
      w60b -= e31b * db12;
      db12b -= e31b * w60;
      w61b += e30b * db12;
      db12b += e30b * w61;
      w62b -= e30b * db11;
      db11b -= e30b * w62;
      Z_b5b = w62b;
      Z_b4b = w61b;
      /* u' = w × u */
      Z_b3b = w60b;
      w50b = c22b * dir_i1_2;
      dir_i1_2b = c22b * w50;
      w51b = -(c22b * dir_i0_2);
      dir_i0_2b = -(c22b * w51);
      w52b = c21b * dir_i0_2;
      dir_i0_2b += c21b * w52;
      w50b -= c21b * dir_i2_2;
      dir_i2_2b = -(c21b * w50);
      w51b += c20b * dir_i2_2;
      dir_i2_2b += c20b * w51;
      w52b -= c20b * dir_i1_2;
      dir_i1_2b -= c20b * w52;
      Z0b[b][5] += w52b;
      Z0b[b][4] += w51b;
      /* u'' = w' × u + w × u'
       * u' = w × u */
      Z0b[b][3] += w50b;
      c2_2b = da22b;
      e22b = da22b;
      c1b = da21b;
      e21b = da21b;
      c0b = da20b;
      e20b = da20b;
      w40b = e22b * da11;
      da11b += e22b * w40;
      w41b = -(e22b * da10);
      da10b -= e22b * w41;
      w42b = e21b * da10;
      da10b += e21b * w42;
      w40b -= e21b * da12;
      da12b -= e21b * w40;
      w41b += e20b * da12;
      da12b += e20b * w41;
      w42b -= e20b * da11;
      da11b -= e20b * w42;
      Z_a5b = w42b;
      Z_a4b = w41b;
      /* u' = w × u */
      Z_a3b = w40b;
      w30b = c2_2b * dir_i1;
      dir_i1b = c2_2b * w30;
      w31b = -(c2_2b * dir_i0);
      dir_i0b = -(c2_2b * w31);
      w32b = c1b * dir_i0;
      dir_i0b += c1b * w32;
      w30b -= c1b * dir_i2;
      dir_i2b = -(c1b * w30);
      w31b += c0b * dir_i2;
      dir_i2b += c0b * w31;
      w32b -= c0b * dir_i1;
      dir_i1b -= c0b * w32;
      Z0b[a][5] += w32b;
      Z0b[a][4] += w31b;
      /* u'' = w' × u + w × u'
       * u' = w × u */
      Z0b[a][3] += w30b;
      w20b = db12b * dir_i1_2;
      dir_i1_2b += db12b * w20;
      w21b = -(db12b * dir_i0_2);
      dir_i0_2b -= db12b * w21;
      w22b = db11b * dir_i0_2;
      dir_i0_2b += db11b * w22;
      w20b -= db11b * dir_i2_2;
      dir_i2_2b -= db11b * w20;
      dirb[t->primdb[i]][0] += dir_i0_2b;
      w21b += db10b * dir_i2_2;
      dir_i2_2b += db10b * w21;
      w22b -= db10b * dir_i1_2;
      dir_i1_2b -= db10b * w22;
      dirb[t->primdb[i]][1] += dir_i1_2b;
      dirb[t->primdb[i]][2] += dir_i2_2b;
      Z_b5b += w22b;
      Zb[b][5] += Z_b5b;
      Z_b4b += w21b;
      Zb[b][4] += Z_b4b;
      /* u' = w × u */
      Z_b3b += w20b;
      Zb[b][3] += Z_b3b;
      w0b = da12b * dir_i1;
      dir_i1b += da12b * w0;
      w1b = -(da12b * dir_i0);
      dir_i0b -= da12b * w1;
      w2_2b = da11b * dir_i0;
      dir_i0b += da11b * w2_2;
      w0b -= da11b * dir_i2;
      dir_i2b -= da11b * w0;
      dirb[t->primda[i]][0] += dir_i0b;
      w1b += da10b * dir_i2;
      dir_i2b += da10b * w1;
      w2_2b -= da10b * dir_i1;
      dir_i1b -= da10b * w2_2;
      dirb[t->primda[i]][1] += dir_i1b;
      dirb[t->primda[i]][2] += dir_i2b;
      Z_a5b += w2_2b;
      Zb[a][5] += Z_a5b;
      Z_a4b += w1b;
      Zb[a][4] += Z_a4b;
      /* u' = w × u */
      Z_a3b += w0b;
      Zb[a][3] += Z_a3b;
    }
    rab[t->primpa[i]][2] += ea2b;
    rab[t->primpb[i]][2] -= ea2b;
    rvb[t->primpa[i]][2] += ev2b;
    rvb[t->primpb[i]][2] -= ev2b;
    rb[t->primpa[i]][2] += e2_2b;
    rb[t->primpb[i]][2] -= e2_2b;
    rab[t->primpa[i]][1] += ea1b;
    rab[t->primpb[i]][1] -= ea1b;
    rvb[t->primpa[i]][1] += ev1b;
    rvb[t->primpb[i]][1] -= ev1b;
    rb[t->primpa[i]][1] += e1_3b;
    rb[t->primpb[i]][1] -= e1_3b;
    rab[t->primpa[i]][0] += ea0b;
    rab[t->primpb[i]][0] -= ea0b;
    rvb[t->primpa[i]][0] += ev0b;
    rvb[t->primpb[i]][0] -= ev0b;
    /* minus the second derivative of the equation with all joint accelerations zero */
    rb[t->primpa[i]][0] += e0b;
    rb[t->primpb[i]][0] -= e0b;
  }
}
