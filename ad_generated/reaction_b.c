/* Adjoint of core/kernel/reaction.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* adds to F what the loops exert on bodies; what open ones would exert on the joints that carry both
 * sides is left out, as in Phi_z */
void maggi_loop_forces_b(const maggi_topo *t, const double prim0[restrict t->nprim],
                         double prim0b[restrict t->nprim], const double r[restrict t->npoint][3],
                         double rb[restrict t->npoint][3], const double dir[restrict t->ndir][3],
                         double dirb[restrict t->ndir][3], const double lambda[restrict t->nrow],
                         double lambdab[restrict t->nrow], double F[restrict t->nbody + 1][6],
                         double Fb[restrict t->nbody + 1][6])
{
  int c, i;
  double c20b, c21b, c22b, c30b, c31b, c32b, ca0_2b, ca0b, ca1_2b, ca1b, ca2_2b, ca2b, cb20_2b,
      cb20b, cb21_2b, cb21b, cb22_2b, cb22b, dir_i0, dir_i0_2, dir_i0_2b, dir_i0_3, dir_i0_3b,
      dir_i0_4, dir_i0_4b, dir_i0b, dir_i1, dir_i1_2, dir_i1_2b, dir_i1_3, dir_i1_3b, dir_i1_4,
      dir_i1_4b, dir_i1b, dir_i2, dir_i2_2, dir_i2_2b, dir_i2_3, dir_i2_3b, dir_i2_4, dir_i2_4b,
      dir_i2b, e0, e0b, e1, e1b, e20, e20b, e21, e21b, e22, e22b, e2_2, e2_2b, fa0, fa0b, fa1, fa1b,
      fa2, fa2b, fb0, fb0b, fb1, fb1b, fb2, fb2b, l0, l0b, l1, l1b, l20, l20b, l21, l21b, l22, l22b,
      l2_2, l2_2b, l30, l30b, l31, l31b, l32, l32b, lambda_i, lambda_ib, n20, n20b, n21, n21b, n22,
      n22b, r_i0, r_i0_2, r_i0_2b, r_i0_3, r_i0_3b, r_i0b, r_i1, r_i1_2, r_i1_2b, r_i1_3, r_i1_3b,
      r_i1b, r_i2, r_i2_2, r_i2_2b, r_i2_3, r_i2_3b, r_i2b, t2, t2b, t3, t3b, t4, t4b, tb10, tb11,
      tb12, tb13, tb14, tb15, tb16, tb2, tb3, tb4, tb5, tb6, tb7, tb8, tb9;

  (void)F;
  for (i = t->nprim - 1; i >= 0; --i) {
    c = t->loopcommon[t->primloop[i]];
    if (c < t->nbody && t->primkind[i] == MAGGI_PRIM_POINT) {
      e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
      l20 = lambda[t->primrow[i]];
      e1 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
      l21 = lambda[t->primrow[i] + 1];
      e2_2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
      l22 = lambda[t->primrow[i] + 2];
      c22b = Fb[c][5];
      c21b = Fb[c][4];
      c20b = Fb[c][3];
      e0b = c22b * l21;
      l21b = c22b * e0;
      e1b = -(c22b * l20);
      l20b = -(c22b * e1);
      e2_2b = c21b * l20;
      l20b += c21b * e2_2;
      e0b -= c21b * l22;
      l22b = -(c21b * e0);
      e1b += c20b * l22;
      l22b += c20b * e1;
      e2_2b -= c20b * l21;
      l21b -= c20b * e2_2;
      lambdab[t->primrow[i] + 2] += l22b;
      rb[t->primpa[i]][2] += e2_2b;
      rb[t->primpb[i]][2] -= e2_2b;
      lambdab[t->primrow[i] + 1] += l21b;
      rb[t->primpa[i]][1] += e1b;
      rb[t->primpb[i]][1] -= e1b;
      lambdab[t->primrow[i]] += l20b;
      /* the moment of an open pair of forces, which no joint of the loop takes */
      rb[t->primpa[i]][0] += e0b;
      rb[t->primpb[i]][0] -= e0b;
    } else if (c < t->nbody && t->primkind[i] == MAGGI_PRIM_AXIS) {
      e20 = dir[t->primda[i]][0] - dir[t->primdb[i]][0];
      l30 = lambda[t->primrow[i]];
      e21 = dir[t->primda[i]][1] - dir[t->primdb[i]][1];
      l31 = lambda[t->primrow[i] + 1];
      e22 = dir[t->primda[i]][2] - dir[t->primdb[i]][2];
      l32 = lambda[t->primrow[i] + 2];
      c32b = Fb[c][5];
      c31b = Fb[c][4];
      c30b = Fb[c][3];
      e20b = c32b * l31;
      l31b = c32b * e20;
      e21b = -(c32b * l30);
      l30b = -(c32b * e21);
      e22b = c31b * l30;
      l30b += c31b * e22;
      e20b -= c31b * l32;
      l32b = -(c31b * e20);
      e21b += c30b * l32;
      l32b += c30b * e21;
      e22b -= c30b * l31;
      l31b -= c30b * e22;
      lambdab[t->primrow[i] + 2] += l32b;
      dirb[t->primda[i]][2] += e22b;
      dirb[t->primdb[i]][2] -= e22b;
      lambdab[t->primrow[i] + 1] += l31b;
      dirb[t->primda[i]][1] += e21b;
      dirb[t->primdb[i]][1] -= e21b;
      lambdab[t->primrow[i]] += l30b;
      /* the moment of an open pair of forces, which no joint of the loop takes */
      dirb[t->primda[i]][0] += e20b;
      dirb[t->primdb[i]][0] -= e20b;
    }
  }
  for (i = t->nprim - 1; i >= 0; --i) {
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
      cb22b = Fb[t->primbb[i]][5];
      cb21b = Fb[t->primbb[i]][4];
      cb20b = Fb[t->primbb[i]][3];
      ca2b = Fb[t->primba[i]][5];
      ca1b = Fb[t->primba[i]][4];
      ca0b = Fb[t->primba[i]][3];
      dir_i0_2b = cb22b * l1;
      l1b = cb22b * dir_i0_2;
      dir_i1_2b = -(cb22b * l0);
      l0b = -(cb22b * dir_i1_2);
      dir_i2_2b = cb21b * l0;
      l0b += cb21b * dir_i2_2;
      dir_i0_2b -= cb21b * l2_2;
      l2_2b = -(cb21b * dir_i0_2);
      dirb[t->primdb[i]][0] += dir_i0_2b;
      dir_i1_2b += cb20b * l2_2;
      l2_2b += cb20b * dir_i1_2;
      dir_i2_2b -= cb20b * l1;
      l1b -= cb20b * dir_i2_2;
      dirb[t->primdb[i]][2] += dir_i2_2b;
      dirb[t->primdb[i]][1] += dir_i1_2b;
      l0b += ca2b * dir_i1;
      dir_i1b = ca2b * l0;
      l1b -= ca2b * dir_i0;
      dir_i0b = -(ca2b * l1);
      l2_2b += ca1b * dir_i0;
      dir_i0b += ca1b * l2_2;
      l0b -= ca1b * dir_i2;
      dir_i2b = -(ca1b * l0);
      dirb[t->primda[i]][0] += dir_i0b;
      l1b += ca0b * dir_i2;
      dir_i2b += ca0b * l1;
      l2_2b -= ca0b * dir_i1;
      dir_i1b -= ca0b * l2_2;
      dirb[t->primda[i]][1] += dir_i1b;
      dirb[t->primda[i]][2] += dir_i2b;
      lambdab[t->primrow[i] + 2] += l2_2b;
      lambdab[t->primrow[i] + 1] += l1b;
      lambdab[t->primrow[i]] += l0b;
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
      cb22_2b = Fb[t->primbb[i]][5];
      cb21_2b = Fb[t->primbb[i]][4];
      cb20_2b = Fb[t->primbb[i]][3];
      ca2_2b = Fb[t->primba[i]][5];
      ca1_2b = Fb[t->primba[i]][4];
      ca0_2b = Fb[t->primba[i]][3];
      lambda_ib = -(cb22_2b * n22);
      n22b = -(cb22_2b * lambda_i);
      lambda_ib += ca2_2b * n22;
      n22b += ca2_2b * lambda_i;
      lambda_ib -= cb21_2b * n21;
      n21b = -(cb21_2b * lambda_i);
      lambda_ib += ca1_2b * n21;
      n21b += ca1_2b * lambda_i;
      lambda_ib -= cb20_2b * n20;
      n20b = -(cb20_2b * lambda_i);
      lambda_ib += ca0_2b * n20;
      n20b += ca0_2b * lambda_i;
      lambdab[t->primrow[i]] += lambda_ib;
      dir_i0_4b = n22b * dir_i1_4;
      dir_i1_4b = n22b * dir_i0_4;
      dir_i1_3b = -(n22b * dir_i0_3);
      dir_i0_3b = -(n22b * dir_i1_3);
      dir_i2_4b = n21b * dir_i0_3;
      dir_i0_3b += n21b * dir_i2_4;
      dir_i0_4b -= n21b * dir_i2_3;
      dir_i2_3b = -(n21b * dir_i0_4);
      dirb[t->primdb[i]][0] += dir_i0_4b;
      dirb[t->primda[i]][0] += dir_i0_3b;
      dir_i1_3b += n20b * dir_i2_3;
      dir_i2_3b += n20b * dir_i1_3;
      dir_i2_4b -= n20b * dir_i1_4;
      dir_i1_4b -= n20b * dir_i2_4;
      dirb[t->primda[i]][1] += dir_i1_4b;
      dirb[t->primdb[i]][2] += dir_i2_4b;
      dirb[t->primda[i]][2] += dir_i2_3b;
      dirb[t->primdb[i]][1] += dir_i1_3b;
    } else {
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        fb0 = lambda[t->primrow[i]];
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        fb0 = lambda[t->primrow[i]] * dir[t->primdb[i]][0];
      } else {
        t2 = lambda[t->primrow[i]] * (r[t->primpa[i]][0] - r[t->primpb[i]][0]) / prim0[i];
        fb0 = t2;
      }
      fa0 = -fb0;
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        fb1 = lambda[t->primrow[i] + 1];
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        fb1 = lambda[t->primrow[i]] * dir[t->primdb[i]][1];
      } else {
        t3 = lambda[t->primrow[i]] * (r[t->primpa[i]][1] - r[t->primpb[i]][1]) / prim0[i];
        fb1 = t3;
      }
      fa1 = -fb1;
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        fb2 = lambda[t->primrow[i] + 2];
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        fb2 = lambda[t->primrow[i]] * dir[t->primdb[i]][2];
      } else {
        t4 = lambda[t->primrow[i]] * (r[t->primpa[i]][2] - r[t->primpb[i]][2]) / prim0[i];
        fb2 = t4;
      }
      fa2 = -fb2;
      r_i1 = r[t->primpa[i]][1];
      r_i2 = r[t->primpa[i]][2];
      r_i0 = r[t->primpa[i]][0];
      fb0b = 0.0;
      fb1b = 0.0;
      fb2b = 0.0;
      if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        r_i1_2 = r[t->primpa[i]][1];
        r_i2_2 = r[t->primpa[i]][2];
        r_i0_2 = r[t->primpa[i]][0];
        tb13 = Fb[t->primbb[i]][5];
        r_i0_2b = tb13 * fb1;
        fb1b += tb13 * r_i0_2;
        r_i1_2b = -(tb13 * fb0);
        fb0b -= tb13 * r_i1_2;
        tb12 = Fb[t->primbb[i]][4];
        r_i2_2b = tb12 * fb0;
        fb0b += tb12 * r_i2_2;
        r_i0_2b -= tb12 * fb2;
        fb2b -= tb12 * r_i0_2;
        rb[t->primpa[i]][0] += r_i0_2b;
        tb11 = Fb[t->primbb[i]][3];
        r_i1_2b += tb11 * fb2;
        fb2b += tb11 * r_i1_2;
        r_i2_2b -= tb11 * fb1;
        fb1b -= tb11 * r_i2_2;
        rb[t->primpa[i]][2] += r_i2_2b;
        rb[t->primpa[i]][1] += r_i1_2b;
        fb2b += Fb[t->primbb[i]][2];
        fb1b += Fb[t->primbb[i]][1];
        fb0b += Fb[t->primbb[i]][0];
      } else {
        r_i1_3 = r[t->primpb[i]][1];
        r_i2_3 = r[t->primpb[i]][2];
        r_i0_3 = r[t->primpb[i]][0];
        tb16 = Fb[t->primbb[i]][5];
        r_i0_3b = tb16 * fb1;
        fb1b += tb16 * r_i0_3;
        r_i1_3b = -(tb16 * fb0);
        fb0b -= tb16 * r_i1_3;
        tb15 = Fb[t->primbb[i]][4];
        r_i2_3b = tb15 * fb0;
        fb0b += tb15 * r_i2_3;
        r_i0_3b -= tb15 * fb2;
        fb2b -= tb15 * r_i0_3;
        rb[t->primpb[i]][0] += r_i0_3b;
        tb14 = Fb[t->primbb[i]][3];
        r_i1_3b += tb14 * fb2;
        fb2b += tb14 * r_i1_3;
        r_i2_3b -= tb14 * fb1;
        fb1b -= tb14 * r_i2_3;
        rb[t->primpb[i]][2] += r_i2_3b;
        rb[t->primpb[i]][1] += r_i1_3b;
        fb2b += Fb[t->primbb[i]][2];
        fb1b += Fb[t->primbb[i]][1];
        fb0b += Fb[t->primbb[i]][0];
      }
      tb10 = Fb[t->primba[i]][5];
      r_i0b = tb10 * fa1;
      fa1b = tb10 * r_i0;
      r_i1b = -(tb10 * fa0);
      fa0b = -(tb10 * r_i1);
      tb9 = Fb[t->primba[i]][4];
      r_i2b = tb9 * fa0;
      fa0b += tb9 * r_i2;
      r_i0b -= tb9 * fa2;
      fa2b = -(tb9 * r_i0);
      rb[t->primpa[i]][0] += r_i0b;
      tb8 = Fb[t->primba[i]][3];
      r_i1b += tb8 * fa2;
      fa2b += tb8 * r_i1;
      r_i2b -= tb8 * fa1;
      fa1b -= tb8 * r_i2;
      rb[t->primpa[i]][2] += r_i2b;
      rb[t->primpa[i]][1] += r_i1b;
      fa2b += Fb[t->primba[i]][2];
      fa1b += Fb[t->primba[i]][1];
      fa0b += Fb[t->primba[i]][0];
      fb2b -= fa2b;
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        lambdab[t->primrow[i] + 2] += fb2b;
        fb2b = 0.0;
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        lambdab[t->primrow[i]] += fb2b * dir[t->primdb[i]][2];
        dirb[t->primdb[i]][2] += fb2b * lambda[t->primrow[i]];
        fb2b = 0.0;
      } else {
        t4 = lambda[t->primrow[i]] * (r[t->primpa[i]][2] - r[t->primpb[i]][2]) / prim0[i];
        t4b = fb2b;
        fb2b = 0.0;
        tb6 = t4b / prim0[i];
        lambdab[t->primrow[i]] += tb6 * (r[t->primpa[i]][2] - r[t->primpb[i]][2]);
        tb7 = tb6 * lambda[t->primrow[i]];
        rb[t->primpa[i]][2] += tb7;
        rb[t->primpb[i]][2] -= tb7;
        prim0b[i] -= tb6 * t4;
      }
      fb1b -= fa1b;
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        lambdab[t->primrow[i] + 1] += fb1b;
        fb1b = 0.0;
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        lambdab[t->primrow[i]] += fb1b * dir[t->primdb[i]][1];
        dirb[t->primdb[i]][1] += fb1b * lambda[t->primrow[i]];
        fb1b = 0.0;
      } else {
        t3 = lambda[t->primrow[i]] * (r[t->primpa[i]][1] - r[t->primpb[i]][1]) / prim0[i];
        t3b = fb1b;
        fb1b = 0.0;
        tb4 = t3b / prim0[i];
        lambdab[t->primrow[i]] += tb4 * (r[t->primpa[i]][1] - r[t->primpb[i]][1]);
        tb5 = tb4 * lambda[t->primrow[i]];
        rb[t->primpa[i]][1] += tb5;
        rb[t->primpb[i]][1] -= tb5;
        prim0b[i] -= tb4 * t3;
      }
      fb0b -= fa0b;
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        lambdab[t->primrow[i]] += fb0b;
        fb0b = 0.0;
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        lambdab[t->primrow[i]] += fb0b * dir[t->primdb[i]][0];
        dirb[t->primdb[i]][0] += fb0b * lambda[t->primrow[i]];
        fb0b = 0.0;
      } else {
        t2 = lambda[t->primrow[i]] * (r[t->primpa[i]][0] - r[t->primpb[i]][0]) / prim0[i];
        t2b = fb0b;
        fb0b = 0.0;
        tb2 = t2b / prim0[i];
        lambdab[t->primrow[i]] += tb2 * (r[t->primpa[i]][0] - r[t->primpb[i]][0]);
        tb3 = tb2 * lambda[t->primrow[i]];
        rb[t->primpa[i]][0] += tb3;
        rb[t->primpb[i]][0] -= tb3;
        prim0b[i] -= tb2 * t2;
      }
    }
  }
}

/* what a joint exerts on its body, about the joint point: - FS, which is about P */
void maggi_reactions_b(const maggi_topo *t, const double x[restrict t->nbody + 1][3],
                       double xb[restrict t->nbody + 1][3],
                       const double FS[restrict t->nbody + 1][6],
                       double FSb[restrict t->nbody + 1][6], double wrench[restrict t->nbody][6],
                       double wrenchb[restrict t->nbody][6])
{
  int i;
  double FS_i0, FS_i0b, FS_i1, FS_i1b, FS_i2, FS_i2b, tb2, tb3, tb4, x_i0, x_i0b, x_i1, x_i1b, x_i2,
      x_i2b;

  (void)wrench;
  for (i = t->nbody - 1; i >= 0; --i) {
    FS_i0 = FS[i][0];
    FS_i1 = FS[i][1];
    FS_i2 = FS[i][2];
    x_i1 = x[i][1];
    x_i2 = x[i][2];
    x_i0 = x[i][0];
    tb4 = wrenchb[i][5];
    wrenchb[i][5] = 0.0;
    x_i0b = tb4 * FS_i1;
    FS_i1b = tb4 * x_i0;
    x_i1b = -(tb4 * FS_i0);
    FS_i0b = -(tb4 * x_i1);
    FSb[i][5] -= tb4;
    tb3 = wrenchb[i][4];
    wrenchb[i][4] = 0.0;
    x_i2b = tb3 * FS_i0;
    FS_i0b += tb3 * x_i2;
    x_i0b -= tb3 * FS_i2;
    FS_i2b = -(tb3 * x_i0);
    FSb[i][4] -= tb3;
    xb[i][0] += x_i0b;
    tb2 = wrenchb[i][3];
    wrenchb[i][3] = 0.0;
    x_i1b += tb2 * FS_i2;
    FS_i2b += tb2 * x_i1;
    x_i2b -= tb2 * FS_i1;
    FS_i1b -= tb2 * x_i2;
    FSb[i][3] -= tb2;
    xb[i][2] += x_i2b;
    xb[i][1] += x_i1b;
    FS_i2b -= wrenchb[i][2];
    wrenchb[i][2] = 0.0;
    FSb[i][2] += FS_i2b;
    FS_i1b -= wrenchb[i][1];
    wrenchb[i][1] = 0.0;
    FSb[i][1] += FS_i1b;
    FS_i0b -= wrenchb[i][0];
    wrenchb[i][0] = 0.0;
    FSb[i][0] += FS_i0b;
  }
}
