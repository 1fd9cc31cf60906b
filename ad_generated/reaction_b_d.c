/* Tangent of the adjoint of core/kernel/reaction.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* adds to F what the loops exert on bodies; what open ones would exert on the joints that carry both
 * sides is left out, as in Phi_z */
void maggi_loop_forces_b_d(const maggi_topo *t, const double prim0[restrict t->nprim],
                           const double prim0d[restrict t->nprim], double prim0b[restrict t->nprim],
                           double prim0bd[restrict t->nprim], const double r[restrict t->npoint][3],
                           const double rd[restrict t->npoint][3], double rb[restrict t->npoint][3],
                           double rbd[restrict t->npoint][3], const double dir[restrict t->ndir][3],
                           const double dird[restrict t->ndir][3], double dirb[restrict t->ndir][3],
                           double dirbd[restrict t->ndir][3], const double lambda[restrict t->nrow],
                           const double lambdad[restrict t->nrow], double lambdab[restrict t->nrow],
                           double lambdabd[restrict t->nrow], double F[restrict t->nbody + 1][6],
                           double Fd[restrict t->nbody + 1][6], double Fb[restrict t->nbody + 1][6],
                           double Fbd[restrict t->nbody + 1][6])
{
  int c, i;
  double c20b, c20bd, c21b, c21bd, c22b, c22bd, c30b, c30bd, c31b, c31bd, c32b, c32bd, ca0_2b,
      ca0_2bd, ca0b, ca0bd, ca1_2b, ca1_2bd, ca1b, ca1bd, ca2_2b, ca2_2bd, ca2b, ca2bd, cb20_2b,
      cb20_2bd, cb20b, cb20bd, cb21_2b, cb21_2bd, cb21b, cb21bd, cb22_2b, cb22_2bd, cb22b, cb22bd,
      dir_i0, dir_i0_2, dir_i0_2b, dir_i0_2bd, dir_i0_2d, dir_i0_3, dir_i0_3b, dir_i0_3bd,
      dir_i0_3d, dir_i0_4, dir_i0_4b, dir_i0_4bd, dir_i0_4d, dir_i0b, dir_i0bd, dir_i0d, dir_i1,
      dir_i1_2, dir_i1_2b, dir_i1_2bd, dir_i1_2d, dir_i1_3, dir_i1_3b, dir_i1_3bd, dir_i1_3d,
      dir_i1_4, dir_i1_4b, dir_i1_4bd, dir_i1_4d, dir_i1b, dir_i1bd, dir_i1d, dir_i2, dir_i2_2,
      dir_i2_2b, dir_i2_2bd, dir_i2_2d, dir_i2_3, dir_i2_3b, dir_i2_3bd, dir_i2_3d, dir_i2_4,
      dir_i2_4b, dir_i2_4bd, dir_i2_4d, dir_i2b, dir_i2bd, dir_i2d, e0, e0b, e0bd, e0d, e1, e1b,
      e1bd, e1d, e20, e20b, e20bd, e20d, e21, e21b, e21bd, e21d, e22, e22b, e22bd, e22d, e2_2,
      e2_2b, e2_2bd, e2_2d, fa0, fa0b, fa0bd, fa0d, fa1, fa1b, fa1bd, fa1d, fa2, fa2b, fa2bd, fa2d,
      fb0, fb0b, fb0bd, fb0d, fb1, fb1b, fb1bd, fb1d, fb2, fb2b, fb2bd, fb2d, l0, l0b, l0bd, l0d,
      l1, l1b, l1bd, l1d, l20, l20b, l20bd, l20d, l21, l21b, l21bd, l21d, l22, l22b, l22bd, l22d,
      l2_2, l2_2b, l2_2bd, l2_2d, l30, l30b, l30bd, l30d, l31, l31b, l31bd, l31d, l32, l32b, l32bd,
      l32d, lambda_i, lambda_ib, lambda_ibd, lambda_id, n20, n20b, n20bd, n20d, n21, n21b, n21bd,
      n21d, n22, n22b, n22bd, n22d, r_i0, r_i0_2, r_i0_2b, r_i0_2bd, r_i0_2d, r_i0_3, r_i0_3b,
      r_i0_3bd, r_i0_3d, r_i0b, r_i0bd, r_i0d, r_i1, r_i1_2, r_i1_2b, r_i1_2bd, r_i1_2d, r_i1_3,
      r_i1_3b, r_i1_3bd, r_i1_3d, r_i1b, r_i1bd, r_i1d, r_i2, r_i2_2, r_i2_2b, r_i2_2bd, r_i2_2d,
      r_i2_3, r_i2_3b, r_i2_3bd, r_i2_3d, r_i2b, r_i2bd, r_i2d, t2, t2b, t2bd, t2d, t3, t3b, t3bd,
      t3d, t4, t4b, t4bd, t4d, tb10, tb10d, tb11, tb11d, tb12, tb12d, tb13, tb13d, tb14, tb14d,
      tb15, tb15d, tb16, tb16d, tb2, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d,
      tb8, tb8d, tb9, tb9d;

  (void)F;
  (void)Fd;
  for (i = t->nprim - 1; i >= 0; --i) {
    c = t->loopcommon[t->primloop[i]];
    if (c < t->nbody && t->primkind[i] == MAGGI_PRIM_POINT) {
      e0 = r[t->primpa[i]][0] - r[t->primpb[i]][0];
      e0d = rd[t->primpa[i]][0] - rd[t->primpb[i]][0];
      l20 = lambda[t->primrow[i]];
      l20d = lambdad[t->primrow[i]];
      e1 = r[t->primpa[i]][1] - r[t->primpb[i]][1];
      e1d = rd[t->primpa[i]][1] - rd[t->primpb[i]][1];
      l21 = lambda[t->primrow[i] + 1];
      l21d = lambdad[t->primrow[i] + 1];
      e2_2 = r[t->primpa[i]][2] - r[t->primpb[i]][2];
      e2_2d = rd[t->primpa[i]][2] - rd[t->primpb[i]][2];
      l22 = lambda[t->primrow[i] + 2];
      l22d = lambdad[t->primrow[i] + 2];
      c22b = Fb[c][5];
      c22bd = Fbd[c][5];
      c21b = Fb[c][4];
      c21bd = Fbd[c][4];
      c20b = Fb[c][3];
      c20bd = Fbd[c][3];
      e0b = c22b * l21;
      e0bd = c22bd * l21 + c22b * l21d;
      l21b = c22b * e0;
      l21bd = c22bd * e0 + c22b * e0d;
      e1b = -(c22b * l20);
      e1bd = -(c22bd * l20 + c22b * l20d);
      l20b = -(c22b * e1);
      l20bd = -(c22bd * e1 + c22b * e1d);
      e2_2b = c21b * l20;
      e2_2bd = c21bd * l20 + c21b * l20d;
      l20b += c21b * e2_2;
      l20bd += c21bd * e2_2 + c21b * e2_2d;
      e0b -= c21b * l22;
      e0bd -= c21bd * l22 + c21b * l22d;
      l22b = -(c21b * e0);
      l22bd = -(c21bd * e0 + c21b * e0d);
      e1b += c20b * l22;
      e1bd += c20bd * l22 + c20b * l22d;
      l22b += c20b * e1;
      l22bd += c20bd * e1 + c20b * e1d;
      e2_2b -= c20b * l21;
      e2_2bd -= c20bd * l21 + c20b * l21d;
      l21b -= c20b * e2_2;
      l21bd -= c20bd * e2_2 + c20b * e2_2d;
      lambdab[t->primrow[i] + 2] += l22b;
      lambdabd[t->primrow[i] + 2] += l22bd;
      rb[t->primpa[i]][2] += e2_2b;
      rbd[t->primpa[i]][2] += e2_2bd;
      rb[t->primpb[i]][2] -= e2_2b;
      rbd[t->primpb[i]][2] -= e2_2bd;
      lambdab[t->primrow[i] + 1] += l21b;
      lambdabd[t->primrow[i] + 1] += l21bd;
      rb[t->primpa[i]][1] += e1b;
      rbd[t->primpa[i]][1] += e1bd;
      rb[t->primpb[i]][1] -= e1b;
      rbd[t->primpb[i]][1] -= e1bd;
      lambdab[t->primrow[i]] += l20b;
      lambdabd[t->primrow[i]] += l20bd;
      rb[t->primpa[i]][0] += e0b;
      /* the moment of an open pair of forces, which no joint of the loop takes */
      rbd[t->primpa[i]][0] += e0bd;
      rb[t->primpb[i]][0] -= e0b;
      rbd[t->primpb[i]][0] -= e0bd;
    } else if (c < t->nbody && t->primkind[i] == MAGGI_PRIM_AXIS) {
      e20 = dir[t->primda[i]][0] - dir[t->primdb[i]][0];
      e20d = dird[t->primda[i]][0] - dird[t->primdb[i]][0];
      l30 = lambda[t->primrow[i]];
      l30d = lambdad[t->primrow[i]];
      e21 = dir[t->primda[i]][1] - dir[t->primdb[i]][1];
      e21d = dird[t->primda[i]][1] - dird[t->primdb[i]][1];
      l31 = lambda[t->primrow[i] + 1];
      l31d = lambdad[t->primrow[i] + 1];
      e22 = dir[t->primda[i]][2] - dir[t->primdb[i]][2];
      e22d = dird[t->primda[i]][2] - dird[t->primdb[i]][2];
      l32 = lambda[t->primrow[i] + 2];
      l32d = lambdad[t->primrow[i] + 2];
      c32b = Fb[c][5];
      c32bd = Fbd[c][5];
      c31b = Fb[c][4];
      c31bd = Fbd[c][4];
      c30b = Fb[c][3];
      c30bd = Fbd[c][3];
      e20b = c32b * l31;
      e20bd = c32bd * l31 + c32b * l31d;
      l31b = c32b * e20;
      l31bd = c32bd * e20 + c32b * e20d;
      e21b = -(c32b * l30);
      e21bd = -(c32bd * l30 + c32b * l30d);
      l30b = -(c32b * e21);
      l30bd = -(c32bd * e21 + c32b * e21d);
      e22b = c31b * l30;
      e22bd = c31bd * l30 + c31b * l30d;
      l30b += c31b * e22;
      l30bd += c31bd * e22 + c31b * e22d;
      e20b -= c31b * l32;
      e20bd -= c31bd * l32 + c31b * l32d;
      l32b = -(c31b * e20);
      l32bd = -(c31bd * e20 + c31b * e20d);
      e21b += c30b * l32;
      e21bd += c30bd * l32 + c30b * l32d;
      l32b += c30b * e21;
      l32bd += c30bd * e21 + c30b * e21d;
      e22b -= c30b * l31;
      e22bd -= c30bd * l31 + c30b * l31d;
      l31b -= c30b * e22;
      l31bd -= c30bd * e22 + c30b * e22d;
      lambdab[t->primrow[i] + 2] += l32b;
      lambdabd[t->primrow[i] + 2] += l32bd;
      dirb[t->primda[i]][2] += e22b;
      dirbd[t->primda[i]][2] += e22bd;
      dirb[t->primdb[i]][2] -= e22b;
      dirbd[t->primdb[i]][2] -= e22bd;
      lambdab[t->primrow[i] + 1] += l31b;
      lambdabd[t->primrow[i] + 1] += l31bd;
      dirb[t->primda[i]][1] += e21b;
      dirbd[t->primda[i]][1] += e21bd;
      dirb[t->primdb[i]][1] -= e21b;
      dirbd[t->primdb[i]][1] -= e21bd;
      lambdab[t->primrow[i]] += l30b;
      lambdabd[t->primrow[i]] += l30bd;
      dirb[t->primda[i]][0] += e20b;
      /* the moment of an open pair of forces, which no joint of the loop takes */
      dirbd[t->primda[i]][0] += e20bd;
      dirb[t->primdb[i]][0] -= e20b;
      dirbd[t->primdb[i]][0] -= e20bd;
    }
  }
  for (i = t->nprim - 1; i >= 0; --i) {
    /* wrench at P that a building block exerts on body a and body b: - Phi^T lambda */
    if (t->primkind[i] == MAGGI_PRIM_AXIS) {
      l0 = lambda[t->primrow[i]];
      l0d = lambdad[t->primrow[i]];
      l1 = lambda[t->primrow[i] + 1];
      l1d = lambdad[t->primrow[i] + 1];
      l2_2 = lambda[t->primrow[i] + 2];
      l2_2d = lambdad[t->primrow[i] + 2];
      dir_i2 = dir[t->primda[i]][2];
      dir_i2d = dird[t->primda[i]][2];
      dir_i1 = dir[t->primda[i]][1];
      dir_i1d = dird[t->primda[i]][1];
      dir_i0 = dir[t->primda[i]][0];
      dir_i0d = dird[t->primda[i]][0];
      dir_i1_2 = dir[t->primdb[i]][1];
      dir_i1_2d = dird[t->primdb[i]][1];
      dir_i2_2 = dir[t->primdb[i]][2];
      dir_i2_2d = dird[t->primdb[i]][2];
      dir_i0_2 = dir[t->primdb[i]][0];
      dir_i0_2d = dird[t->primdb[i]][0];
      cb22b = Fb[t->primbb[i]][5];
      cb22bd = Fbd[t->primbb[i]][5];
      cb21b = Fb[t->primbb[i]][4];
      cb21bd = Fbd[t->primbb[i]][4];
      cb20b = Fb[t->primbb[i]][3];
      cb20bd = Fbd[t->primbb[i]][3];
      ca2b = Fb[t->primba[i]][5];
      ca2bd = Fbd[t->primba[i]][5];
      ca1b = Fb[t->primba[i]][4];
      ca1bd = Fbd[t->primba[i]][4];
      ca0b = Fb[t->primba[i]][3];
      ca0bd = Fbd[t->primba[i]][3];
      dir_i0_2b = cb22b * l1;
      dir_i0_2bd = cb22bd * l1 + cb22b * l1d;
      l1b = cb22b * dir_i0_2;
      l1bd = cb22bd * dir_i0_2 + cb22b * dir_i0_2d;
      dir_i1_2b = -(cb22b * l0);
      dir_i1_2bd = -(cb22bd * l0 + cb22b * l0d);
      l0b = -(cb22b * dir_i1_2);
      l0bd = -(cb22bd * dir_i1_2 + cb22b * dir_i1_2d);
      dir_i2_2b = cb21b * l0;
      dir_i2_2bd = cb21bd * l0 + cb21b * l0d;
      l0b += cb21b * dir_i2_2;
      l0bd += cb21bd * dir_i2_2 + cb21b * dir_i2_2d;
      dir_i0_2b -= cb21b * l2_2;
      dir_i0_2bd -= cb21bd * l2_2 + cb21b * l2_2d;
      l2_2b = -(cb21b * dir_i0_2);
      l2_2bd = -(cb21bd * dir_i0_2 + cb21b * dir_i0_2d);
      dirb[t->primdb[i]][0] += dir_i0_2b;
      dirbd[t->primdb[i]][0] += dir_i0_2bd;
      dir_i1_2b += cb20b * l2_2;
      dir_i1_2bd += cb20bd * l2_2 + cb20b * l2_2d;
      l2_2b += cb20b * dir_i1_2;
      l2_2bd += cb20bd * dir_i1_2 + cb20b * dir_i1_2d;
      dir_i2_2b -= cb20b * l1;
      dir_i2_2bd -= cb20bd * l1 + cb20b * l1d;
      l1b -= cb20b * dir_i2_2;
      l1bd -= cb20bd * dir_i2_2 + cb20b * dir_i2_2d;
      dirb[t->primdb[i]][2] += dir_i2_2b;
      dirbd[t->primdb[i]][2] += dir_i2_2bd;
      dirb[t->primdb[i]][1] += dir_i1_2b;
      dirbd[t->primdb[i]][1] += dir_i1_2bd;
      l0b += ca2b * dir_i1;
      l0bd += ca2bd * dir_i1 + ca2b * dir_i1d;
      dir_i1b = ca2b * l0;
      dir_i1bd = ca2bd * l0 + ca2b * l0d;
      l1b -= ca2b * dir_i0;
      l1bd -= ca2bd * dir_i0 + ca2b * dir_i0d;
      dir_i0b = -(ca2b * l1);
      dir_i0bd = -(ca2bd * l1 + ca2b * l1d);
      l2_2b += ca1b * dir_i0;
      l2_2bd += ca1bd * dir_i0 + ca1b * dir_i0d;
      dir_i0b += ca1b * l2_2;
      dir_i0bd += ca1bd * l2_2 + ca1b * l2_2d;
      l0b -= ca1b * dir_i2;
      l0bd -= ca1bd * dir_i2 + ca1b * dir_i2d;
      dir_i2b = -(ca1b * l0);
      dir_i2bd = -(ca1bd * l0 + ca1b * l0d);
      dirb[t->primda[i]][0] += dir_i0b;
      dirbd[t->primda[i]][0] += dir_i0bd;
      l1b += ca0b * dir_i2;
      l1bd += ca0bd * dir_i2 + ca0b * dir_i2d;
      dir_i2b += ca0b * l1;
      dir_i2bd += ca0bd * l1 + ca0b * l1d;
      l2_2b -= ca0b * dir_i1;
      l2_2bd -= ca0bd * dir_i1 + ca0b * dir_i1d;
      dir_i1b -= ca0b * l2_2;
      dir_i1bd -= ca0bd * l2_2 + ca0b * l2_2d;
      dirb[t->primda[i]][1] += dir_i1b;
      dirbd[t->primda[i]][1] += dir_i1bd;
      dirb[t->primda[i]][2] += dir_i2b;
      dirbd[t->primda[i]][2] += dir_i2bd;
      lambdab[t->primrow[i] + 2] += l2_2b;
      lambdabd[t->primrow[i] + 2] += l2_2bd;
      lambdab[t->primrow[i] + 1] += l1b;
      lambdabd[t->primrow[i] + 1] += l1bd;
      lambdab[t->primrow[i]] += l0b;
      lambdabd[t->primrow[i]] += l0bd;
    } else if (t->primkind[i] == MAGGI_PRIM_ANGLE) {
      dir_i1_3 = dir[t->primdb[i]][1];
      dir_i1_3d = dird[t->primdb[i]][1];
      dir_i2_3 = dir[t->primda[i]][2];
      dir_i2_3d = dird[t->primda[i]][2];
      dir_i2_4 = dir[t->primdb[i]][2];
      dir_i2_4d = dird[t->primdb[i]][2];
      dir_i1_4 = dir[t->primda[i]][1];
      dir_i1_4d = dird[t->primda[i]][1];
      n20 = dir_i1_3 * dir_i2_3 - dir_i2_4 * dir_i1_4;
      n20d = dir_i1_3d * dir_i2_3 + dir_i1_3 * dir_i2_3d - (dir_i2_4d * dir_i1_4 + dir_i2_4 *
          dir_i1_4d);
      dir_i0_3 = dir[t->primda[i]][0];
      dir_i0_3d = dird[t->primda[i]][0];
      dir_i0_4 = dir[t->primdb[i]][0];
      dir_i0_4d = dird[t->primdb[i]][0];
      n21 = dir_i2_4 * dir_i0_3 - dir_i0_4 * dir_i2_3;
      n21d = dir_i2_4d * dir_i0_3 + dir_i2_4 * dir_i0_3d - (dir_i0_4d * dir_i2_3 + dir_i0_4 *
          dir_i2_3d);
      n22 = dir_i0_4 * dir_i1_4 - dir_i1_3 * dir_i0_3;
      n22d = dir_i0_4d * dir_i1_4 + dir_i0_4 * dir_i1_4d - (dir_i1_3d * dir_i0_3 + dir_i1_3 *
          dir_i0_3d);
      lambda_i = lambda[t->primrow[i]];
      lambda_id = lambdad[t->primrow[i]];
      cb22_2b = Fb[t->primbb[i]][5];
      cb22_2bd = Fbd[t->primbb[i]][5];
      cb21_2b = Fb[t->primbb[i]][4];
      cb21_2bd = Fbd[t->primbb[i]][4];
      cb20_2b = Fb[t->primbb[i]][3];
      cb20_2bd = Fbd[t->primbb[i]][3];
      ca2_2b = Fb[t->primba[i]][5];
      ca2_2bd = Fbd[t->primba[i]][5];
      ca1_2b = Fb[t->primba[i]][4];
      ca1_2bd = Fbd[t->primba[i]][4];
      ca0_2b = Fb[t->primba[i]][3];
      ca0_2bd = Fbd[t->primba[i]][3];
      lambda_ib = -(cb22_2b * n22);
      lambda_ibd = -(cb22_2bd * n22 + cb22_2b * n22d);
      n22b = -(cb22_2b * lambda_i);
      n22bd = -(cb22_2bd * lambda_i + cb22_2b * lambda_id);
      lambda_ib += ca2_2b * n22;
      lambda_ibd += ca2_2bd * n22 + ca2_2b * n22d;
      n22b += ca2_2b * lambda_i;
      n22bd += ca2_2bd * lambda_i + ca2_2b * lambda_id;
      lambda_ib -= cb21_2b * n21;
      lambda_ibd -= cb21_2bd * n21 + cb21_2b * n21d;
      n21b = -(cb21_2b * lambda_i);
      n21bd = -(cb21_2bd * lambda_i + cb21_2b * lambda_id);
      lambda_ib += ca1_2b * n21;
      lambda_ibd += ca1_2bd * n21 + ca1_2b * n21d;
      n21b += ca1_2b * lambda_i;
      n21bd += ca1_2bd * lambda_i + ca1_2b * lambda_id;
      lambda_ib -= cb20_2b * n20;
      lambda_ibd -= cb20_2bd * n20 + cb20_2b * n20d;
      n20b = -(cb20_2b * lambda_i);
      n20bd = -(cb20_2bd * lambda_i + cb20_2b * lambda_id);
      lambda_ib += ca0_2b * n20;
      lambda_ibd += ca0_2bd * n20 + ca0_2b * n20d;
      n20b += ca0_2b * lambda_i;
      n20bd += ca0_2bd * lambda_i + ca0_2b * lambda_id;
      lambdab[t->primrow[i]] += lambda_ib;
      lambdabd[t->primrow[i]] += lambda_ibd;
      dir_i0_4b = n22b * dir_i1_4;
      dir_i0_4bd = n22bd * dir_i1_4 + n22b * dir_i1_4d;
      dir_i1_4b = n22b * dir_i0_4;
      dir_i1_4bd = n22bd * dir_i0_4 + n22b * dir_i0_4d;
      dir_i1_3b = -(n22b * dir_i0_3);
      dir_i1_3bd = -(n22bd * dir_i0_3 + n22b * dir_i0_3d);
      dir_i0_3b = -(n22b * dir_i1_3);
      dir_i0_3bd = -(n22bd * dir_i1_3 + n22b * dir_i1_3d);
      dir_i2_4b = n21b * dir_i0_3;
      dir_i2_4bd = n21bd * dir_i0_3 + n21b * dir_i0_3d;
      dir_i0_3b += n21b * dir_i2_4;
      dir_i0_3bd += n21bd * dir_i2_4 + n21b * dir_i2_4d;
      dir_i0_4b -= n21b * dir_i2_3;
      dir_i0_4bd -= n21bd * dir_i2_3 + n21b * dir_i2_3d;
      dir_i2_3b = -(n21b * dir_i0_4);
      dir_i2_3bd = -(n21bd * dir_i0_4 + n21b * dir_i0_4d);
      dirb[t->primdb[i]][0] += dir_i0_4b;
      dirbd[t->primdb[i]][0] += dir_i0_4bd;
      dirb[t->primda[i]][0] += dir_i0_3b;
      dirbd[t->primda[i]][0] += dir_i0_3bd;
      dir_i1_3b += n20b * dir_i2_3;
      dir_i1_3bd += n20bd * dir_i2_3 + n20b * dir_i2_3d;
      dir_i2_3b += n20b * dir_i1_3;
      dir_i2_3bd += n20bd * dir_i1_3 + n20b * dir_i1_3d;
      dir_i2_4b -= n20b * dir_i1_4;
      dir_i2_4bd -= n20bd * dir_i1_4 + n20b * dir_i1_4d;
      dir_i1_4b -= n20b * dir_i2_4;
      dir_i1_4bd -= n20bd * dir_i2_4 + n20b * dir_i2_4d;
      dirb[t->primda[i]][1] += dir_i1_4b;
      dirbd[t->primda[i]][1] += dir_i1_4bd;
      dirb[t->primdb[i]][2] += dir_i2_4b;
      dirbd[t->primdb[i]][2] += dir_i2_4bd;
      dirb[t->primda[i]][2] += dir_i2_3b;
      dirbd[t->primda[i]][2] += dir_i2_3bd;
      dirb[t->primdb[i]][1] += dir_i1_3b;
      dirbd[t->primdb[i]][1] += dir_i1_3bd;
    } else {
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        fb0 = lambda[t->primrow[i]];
        fb0d = lambdad[t->primrow[i]];
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        fb0 = lambda[t->primrow[i]] * dir[t->primdb[i]][0];
        fb0d = lambdad[t->primrow[i]] * dir[t->primdb[i]][0] + lambda[t->primrow[i]] *
            dird[t->primdb[i]][0];
      } else {
        t2 = lambda[t->primrow[i]] * (r[t->primpa[i]][0] - r[t->primpb[i]][0]) / prim0[i];
        t2d = (lambdad[t->primrow[i]] * (r[t->primpa[i]][0] - r[t->primpb[i]][0]) +
            lambda[t->primrow[i]] * (rd[t->primpa[i]][0] - rd[t->primpb[i]][0]) - t2 * prim0d[i]) *
            (1.0 / prim0[i]);
        fb0 = t2;
        fb0d = t2d;
      }
      fa0 = -fb0;
      fa0d = -fb0d;
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        fb1 = lambda[t->primrow[i] + 1];
        fb1d = lambdad[t->primrow[i] + 1];
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        fb1 = lambda[t->primrow[i]] * dir[t->primdb[i]][1];
        fb1d = lambdad[t->primrow[i]] * dir[t->primdb[i]][1] + lambda[t->primrow[i]] *
            dird[t->primdb[i]][1];
      } else {
        t3 = lambda[t->primrow[i]] * (r[t->primpa[i]][1] - r[t->primpb[i]][1]) / prim0[i];
        t3d = (lambdad[t->primrow[i]] * (r[t->primpa[i]][1] - r[t->primpb[i]][1]) +
            lambda[t->primrow[i]] * (rd[t->primpa[i]][1] - rd[t->primpb[i]][1]) - t3 * prim0d[i]) *
            (1.0 / prim0[i]);
        fb1 = t3;
        fb1d = t3d;
      }
      fa1 = -fb1;
      fa1d = -fb1d;
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        fb2 = lambda[t->primrow[i] + 2];
        fb2d = lambdad[t->primrow[i] + 2];
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        fb2 = lambda[t->primrow[i]] * dir[t->primdb[i]][2];
        fb2d = lambdad[t->primrow[i]] * dir[t->primdb[i]][2] + lambda[t->primrow[i]] *
            dird[t->primdb[i]][2];
      } else {
        t4 = lambda[t->primrow[i]] * (r[t->primpa[i]][2] - r[t->primpb[i]][2]) / prim0[i];
        t4d = (lambdad[t->primrow[i]] * (r[t->primpa[i]][2] - r[t->primpb[i]][2]) +
            lambda[t->primrow[i]] * (rd[t->primpa[i]][2] - rd[t->primpb[i]][2]) - t4 * prim0d[i]) *
            (1.0 / prim0[i]);
        fb2 = t4;
        fb2d = t4d;
      }
      fa2 = -fb2;
      fa2d = -fb2d;
      r_i1 = r[t->primpa[i]][1];
      r_i1d = rd[t->primpa[i]][1];
      r_i2 = r[t->primpa[i]][2];
      r_i2d = rd[t->primpa[i]][2];
      r_i0 = r[t->primpa[i]][0];
      r_i0d = rd[t->primpa[i]][0];
      fb0b = 0.0;
      fb0bd = 0.0;
      fb1b = 0.0;
      fb1bd = 0.0;
      fb2b = 0.0;
      fb2bd = 0.0;
      if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        r_i1_2 = r[t->primpa[i]][1];
        r_i1_2d = rd[t->primpa[i]][1];
        r_i2_2 = r[t->primpa[i]][2];
        r_i2_2d = rd[t->primpa[i]][2];
        r_i0_2 = r[t->primpa[i]][0];
        r_i0_2d = rd[t->primpa[i]][0];
        tb13 = Fb[t->primbb[i]][5];
        tb13d = Fbd[t->primbb[i]][5];
        r_i0_2b = tb13 * fb1;
        r_i0_2bd = tb13d * fb1 + tb13 * fb1d;
        fb1b += tb13 * r_i0_2;
        fb1bd += tb13d * r_i0_2 + tb13 * r_i0_2d;
        r_i1_2b = -(tb13 * fb0);
        r_i1_2bd = -(tb13d * fb0 + tb13 * fb0d);
        fb0b -= tb13 * r_i1_2;
        fb0bd -= tb13d * r_i1_2 + tb13 * r_i1_2d;
        tb12 = Fb[t->primbb[i]][4];
        tb12d = Fbd[t->primbb[i]][4];
        r_i2_2b = tb12 * fb0;
        r_i2_2bd = tb12d * fb0 + tb12 * fb0d;
        fb0b += tb12 * r_i2_2;
        fb0bd += tb12d * r_i2_2 + tb12 * r_i2_2d;
        r_i0_2b -= tb12 * fb2;
        r_i0_2bd -= tb12d * fb2 + tb12 * fb2d;
        fb2b -= tb12 * r_i0_2;
        fb2bd -= tb12d * r_i0_2 + tb12 * r_i0_2d;
        rb[t->primpa[i]][0] += r_i0_2b;
        rbd[t->primpa[i]][0] += r_i0_2bd;
        tb11 = Fb[t->primbb[i]][3];
        tb11d = Fbd[t->primbb[i]][3];
        r_i1_2b += tb11 * fb2;
        r_i1_2bd += tb11d * fb2 + tb11 * fb2d;
        fb2b += tb11 * r_i1_2;
        fb2bd += tb11d * r_i1_2 + tb11 * r_i1_2d;
        r_i2_2b -= tb11 * fb1;
        r_i2_2bd -= tb11d * fb1 + tb11 * fb1d;
        fb1b -= tb11 * r_i2_2;
        fb1bd -= tb11d * r_i2_2 + tb11 * r_i2_2d;
        rb[t->primpa[i]][2] += r_i2_2b;
        rbd[t->primpa[i]][2] += r_i2_2bd;
        rb[t->primpa[i]][1] += r_i1_2b;
        rbd[t->primpa[i]][1] += r_i1_2bd;
        fb2b += Fb[t->primbb[i]][2];
        fb2bd += Fbd[t->primbb[i]][2];
        fb1b += Fb[t->primbb[i]][1];
        fb1bd += Fbd[t->primbb[i]][1];
        fb0b += Fb[t->primbb[i]][0];
        fb0bd += Fbd[t->primbb[i]][0];
      } else {
        r_i1_3 = r[t->primpb[i]][1];
        r_i1_3d = rd[t->primpb[i]][1];
        r_i2_3 = r[t->primpb[i]][2];
        r_i2_3d = rd[t->primpb[i]][2];
        r_i0_3 = r[t->primpb[i]][0];
        r_i0_3d = rd[t->primpb[i]][0];
        tb16 = Fb[t->primbb[i]][5];
        tb16d = Fbd[t->primbb[i]][5];
        r_i0_3b = tb16 * fb1;
        r_i0_3bd = tb16d * fb1 + tb16 * fb1d;
        fb1b += tb16 * r_i0_3;
        fb1bd += tb16d * r_i0_3 + tb16 * r_i0_3d;
        r_i1_3b = -(tb16 * fb0);
        r_i1_3bd = -(tb16d * fb0 + tb16 * fb0d);
        fb0b -= tb16 * r_i1_3;
        fb0bd -= tb16d * r_i1_3 + tb16 * r_i1_3d;
        tb15 = Fb[t->primbb[i]][4];
        tb15d = Fbd[t->primbb[i]][4];
        r_i2_3b = tb15 * fb0;
        r_i2_3bd = tb15d * fb0 + tb15 * fb0d;
        fb0b += tb15 * r_i2_3;
        fb0bd += tb15d * r_i2_3 + tb15 * r_i2_3d;
        r_i0_3b -= tb15 * fb2;
        r_i0_3bd -= tb15d * fb2 + tb15 * fb2d;
        fb2b -= tb15 * r_i0_3;
        fb2bd -= tb15d * r_i0_3 + tb15 * r_i0_3d;
        rb[t->primpb[i]][0] += r_i0_3b;
        rbd[t->primpb[i]][0] += r_i0_3bd;
        tb14 = Fb[t->primbb[i]][3];
        tb14d = Fbd[t->primbb[i]][3];
        r_i1_3b += tb14 * fb2;
        r_i1_3bd += tb14d * fb2 + tb14 * fb2d;
        fb2b += tb14 * r_i1_3;
        fb2bd += tb14d * r_i1_3 + tb14 * r_i1_3d;
        r_i2_3b -= tb14 * fb1;
        r_i2_3bd -= tb14d * fb1 + tb14 * fb1d;
        fb1b -= tb14 * r_i2_3;
        fb1bd -= tb14d * r_i2_3 + tb14 * r_i2_3d;
        rb[t->primpb[i]][2] += r_i2_3b;
        rbd[t->primpb[i]][2] += r_i2_3bd;
        rb[t->primpb[i]][1] += r_i1_3b;
        rbd[t->primpb[i]][1] += r_i1_3bd;
        fb2b += Fb[t->primbb[i]][2];
        fb2bd += Fbd[t->primbb[i]][2];
        fb1b += Fb[t->primbb[i]][1];
        fb1bd += Fbd[t->primbb[i]][1];
        fb0b += Fb[t->primbb[i]][0];
        fb0bd += Fbd[t->primbb[i]][0];
      }
      tb10 = Fb[t->primba[i]][5];
      tb10d = Fbd[t->primba[i]][5];
      r_i0b = tb10 * fa1;
      r_i0bd = tb10d * fa1 + tb10 * fa1d;
      fa1b = tb10 * r_i0;
      fa1bd = tb10d * r_i0 + tb10 * r_i0d;
      r_i1b = -(tb10 * fa0);
      r_i1bd = -(tb10d * fa0 + tb10 * fa0d);
      fa0b = -(tb10 * r_i1);
      fa0bd = -(tb10d * r_i1 + tb10 * r_i1d);
      tb9 = Fb[t->primba[i]][4];
      tb9d = Fbd[t->primba[i]][4];
      r_i2b = tb9 * fa0;
      r_i2bd = tb9d * fa0 + tb9 * fa0d;
      fa0b += tb9 * r_i2;
      fa0bd += tb9d * r_i2 + tb9 * r_i2d;
      r_i0b -= tb9 * fa2;
      r_i0bd -= tb9d * fa2 + tb9 * fa2d;
      fa2b = -(tb9 * r_i0);
      fa2bd = -(tb9d * r_i0 + tb9 * r_i0d);
      rb[t->primpa[i]][0] += r_i0b;
      rbd[t->primpa[i]][0] += r_i0bd;
      tb8 = Fb[t->primba[i]][3];
      tb8d = Fbd[t->primba[i]][3];
      r_i1b += tb8 * fa2;
      r_i1bd += tb8d * fa2 + tb8 * fa2d;
      fa2b += tb8 * r_i1;
      fa2bd += tb8d * r_i1 + tb8 * r_i1d;
      r_i2b -= tb8 * fa1;
      r_i2bd -= tb8d * fa1 + tb8 * fa1d;
      fa1b -= tb8 * r_i2;
      fa1bd -= tb8d * r_i2 + tb8 * r_i2d;
      rb[t->primpa[i]][2] += r_i2b;
      rbd[t->primpa[i]][2] += r_i2bd;
      rb[t->primpa[i]][1] += r_i1b;
      rbd[t->primpa[i]][1] += r_i1bd;
      fa2b += Fb[t->primba[i]][2];
      fa2bd += Fbd[t->primba[i]][2];
      fa1b += Fb[t->primba[i]][1];
      fa1bd += Fbd[t->primba[i]][1];
      fa0b += Fb[t->primba[i]][0];
      fa0bd += Fbd[t->primba[i]][0];
      fb2b -= fa2b;
      fb2bd -= fa2bd;
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        lambdab[t->primrow[i] + 2] += fb2b;
        lambdabd[t->primrow[i] + 2] += fb2bd;
        fb2b = 0.0;
        fb2bd = 0.0;
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        lambdab[t->primrow[i]] += fb2b * dir[t->primdb[i]][2];
        lambdabd[t->primrow[i]] += fb2bd * dir[t->primdb[i]][2] + fb2b * dird[t->primdb[i]][2];
        dirb[t->primdb[i]][2] += fb2b * lambda[t->primrow[i]];
        dirbd[t->primdb[i]][2] += fb2bd * lambda[t->primrow[i]] + fb2b * lambdad[t->primrow[i]];
        fb2b = 0.0;
        fb2bd = 0.0;
      } else {
        t4 = lambda[t->primrow[i]] * (r[t->primpa[i]][2] - r[t->primpb[i]][2]) / prim0[i];
        t4d = (lambdad[t->primrow[i]] * (r[t->primpa[i]][2] - r[t->primpb[i]][2]) +
            lambda[t->primrow[i]] * (rd[t->primpa[i]][2] - rd[t->primpb[i]][2]) - t4 * prim0d[i]) *
            (1.0 / prim0[i]);
        t4b = fb2b;
        t4bd = fb2bd;
        fb2b = 0.0;
        fb2bd = 0.0;
        tb6 = t4b / prim0[i];
        tb6d = (t4bd - tb6 * prim0d[i]) * (1.0 / prim0[i]);
        lambdab[t->primrow[i]] += tb6 * (r[t->primpa[i]][2] - r[t->primpb[i]][2]);
        lambdabd[t->primrow[i]] += tb6d * (r[t->primpa[i]][2] - r[t->primpb[i]][2]) + tb6 *
            (rd[t->primpa[i]][2] - rd[t->primpb[i]][2]);
        tb7 = tb6 * lambda[t->primrow[i]];
        tb7d = tb6d * lambda[t->primrow[i]] + tb6 * lambdad[t->primrow[i]];
        rb[t->primpa[i]][2] += tb7;
        rbd[t->primpa[i]][2] += tb7d;
        rb[t->primpb[i]][2] -= tb7;
        rbd[t->primpb[i]][2] -= tb7d;
        prim0b[i] -= tb6 * t4;
        prim0bd[i] -= tb6d * t4 + tb6 * t4d;
      }
      fb1b -= fa1b;
      fb1bd -= fa1bd;
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        lambdab[t->primrow[i] + 1] += fb1b;
        lambdabd[t->primrow[i] + 1] += fb1bd;
        fb1b = 0.0;
        fb1bd = 0.0;
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        lambdab[t->primrow[i]] += fb1b * dir[t->primdb[i]][1];
        lambdabd[t->primrow[i]] += fb1bd * dir[t->primdb[i]][1] + fb1b * dird[t->primdb[i]][1];
        dirb[t->primdb[i]][1] += fb1b * lambda[t->primrow[i]];
        dirbd[t->primdb[i]][1] += fb1bd * lambda[t->primrow[i]] + fb1b * lambdad[t->primrow[i]];
        fb1b = 0.0;
        fb1bd = 0.0;
      } else {
        t3 = lambda[t->primrow[i]] * (r[t->primpa[i]][1] - r[t->primpb[i]][1]) / prim0[i];
        t3d = (lambdad[t->primrow[i]] * (r[t->primpa[i]][1] - r[t->primpb[i]][1]) +
            lambda[t->primrow[i]] * (rd[t->primpa[i]][1] - rd[t->primpb[i]][1]) - t3 * prim0d[i]) *
            (1.0 / prim0[i]);
        t3b = fb1b;
        t3bd = fb1bd;
        fb1b = 0.0;
        fb1bd = 0.0;
        tb4 = t3b / prim0[i];
        tb4d = (t3bd - tb4 * prim0d[i]) * (1.0 / prim0[i]);
        lambdab[t->primrow[i]] += tb4 * (r[t->primpa[i]][1] - r[t->primpb[i]][1]);
        lambdabd[t->primrow[i]] += tb4d * (r[t->primpa[i]][1] - r[t->primpb[i]][1]) + tb4 *
            (rd[t->primpa[i]][1] - rd[t->primpb[i]][1]);
        tb5 = tb4 * lambda[t->primrow[i]];
        tb5d = tb4d * lambda[t->primrow[i]] + tb4 * lambdad[t->primrow[i]];
        rb[t->primpa[i]][1] += tb5;
        rbd[t->primpa[i]][1] += tb5d;
        rb[t->primpb[i]][1] -= tb5;
        rbd[t->primpb[i]][1] -= tb5d;
        prim0b[i] -= tb4 * t3;
        prim0bd[i] -= tb4d * t3 + tb4 * t3d;
      }
      fb0b -= fa0b;
      fb0bd -= fa0bd;
      if (t->primkind[i] == MAGGI_PRIM_POINT) {
        lambdab[t->primrow[i]] += fb0b;
        lambdabd[t->primrow[i]] += fb0bd;
        fb0b = 0.0;
        fb0bd = 0.0;
      } else if (t->primkind[i] == MAGGI_PRIM_PLANE) {
        lambdab[t->primrow[i]] += fb0b * dir[t->primdb[i]][0];
        lambdabd[t->primrow[i]] += fb0bd * dir[t->primdb[i]][0] + fb0b * dird[t->primdb[i]][0];
        dirb[t->primdb[i]][0] += fb0b * lambda[t->primrow[i]];
        dirbd[t->primdb[i]][0] += fb0bd * lambda[t->primrow[i]] + fb0b * lambdad[t->primrow[i]];
        fb0b = 0.0;
        fb0bd = 0.0;
      } else {
        t2 = lambda[t->primrow[i]] * (r[t->primpa[i]][0] - r[t->primpb[i]][0]) / prim0[i];
        t2d = (lambdad[t->primrow[i]] * (r[t->primpa[i]][0] - r[t->primpb[i]][0]) +
            lambda[t->primrow[i]] * (rd[t->primpa[i]][0] - rd[t->primpb[i]][0]) - t2 * prim0d[i]) *
            (1.0 / prim0[i]);
        t2b = fb0b;
        t2bd = fb0bd;
        fb0b = 0.0;
        fb0bd = 0.0;
        tb2 = t2b / prim0[i];
        tb2d = (t2bd - tb2 * prim0d[i]) * (1.0 / prim0[i]);
        lambdab[t->primrow[i]] += tb2 * (r[t->primpa[i]][0] - r[t->primpb[i]][0]);
        lambdabd[t->primrow[i]] += tb2d * (r[t->primpa[i]][0] - r[t->primpb[i]][0]) + tb2 *
            (rd[t->primpa[i]][0] - rd[t->primpb[i]][0]);
        tb3 = tb2 * lambda[t->primrow[i]];
        tb3d = tb2d * lambda[t->primrow[i]] + tb2 * lambdad[t->primrow[i]];
        rb[t->primpa[i]][0] += tb3;
        rbd[t->primpa[i]][0] += tb3d;
        rb[t->primpb[i]][0] -= tb3;
        rbd[t->primpb[i]][0] -= tb3d;
        prim0b[i] -= tb2 * t2;
        prim0bd[i] -= tb2d * t2 + tb2 * t2d;
      }
    }
  }
}

/* what a joint exerts on its body, about the joint point: - FS, which is about P */
void maggi_reactions_b_d(const maggi_topo *t, const double x[restrict t->nbody + 1][3],
                         const double xd[restrict t->nbody + 1][3],
                         double xb[restrict t->nbody + 1][3], double xbd[restrict t->nbody + 1][3],
                         const double FS[restrict t->nbody + 1][6],
                         const double FSd[restrict t->nbody + 1][6],
                         double FSb[restrict t->nbody + 1][6],
                         double FSbd[restrict t->nbody + 1][6], double wrench[restrict t->nbody][6],
                         double wrenchd[restrict t->nbody][6], double wrenchb[restrict t->nbody][6],
                         double wrenchbd[restrict t->nbody][6])
{
  int i;
  double FS_i0, FS_i0b, FS_i0bd, FS_i0d, FS_i1, FS_i1b, FS_i1bd, FS_i1d, FS_i2, FS_i2b, FS_i2bd,
      FS_i2d, tb2, tb2d, tb3, tb3d, tb4, tb4d, x_i0, x_i0b, x_i0bd, x_i0d, x_i1, x_i1b, x_i1bd,
      x_i1d, x_i2, x_i2b, x_i2bd, x_i2d;

  (void)wrench;
  (void)wrenchd;
  for (i = t->nbody - 1; i >= 0; --i) {
    FS_i0 = FS[i][0];
    FS_i0d = FSd[i][0];
    FS_i1 = FS[i][1];
    FS_i1d = FSd[i][1];
    FS_i2 = FS[i][2];
    FS_i2d = FSd[i][2];
    x_i1 = x[i][1];
    x_i1d = xd[i][1];
    x_i2 = x[i][2];
    x_i2d = xd[i][2];
    x_i0 = x[i][0];
    x_i0d = xd[i][0];
    tb4 = wrenchb[i][5];
    tb4d = wrenchbd[i][5];
    wrenchb[i][5] = 0.0;
    wrenchbd[i][5] = 0.0;
    x_i0b = tb4 * FS_i1;
    x_i0bd = tb4d * FS_i1 + tb4 * FS_i1d;
    FS_i1b = tb4 * x_i0;
    FS_i1bd = tb4d * x_i0 + tb4 * x_i0d;
    x_i1b = -(tb4 * FS_i0);
    x_i1bd = -(tb4d * FS_i0 + tb4 * FS_i0d);
    FS_i0b = -(tb4 * x_i1);
    FS_i0bd = -(tb4d * x_i1 + tb4 * x_i1d);
    FSb[i][5] -= tb4;
    FSbd[i][5] -= tb4d;
    tb3 = wrenchb[i][4];
    tb3d = wrenchbd[i][4];
    wrenchb[i][4] = 0.0;
    wrenchbd[i][4] = 0.0;
    x_i2b = tb3 * FS_i0;
    x_i2bd = tb3d * FS_i0 + tb3 * FS_i0d;
    FS_i0b += tb3 * x_i2;
    FS_i0bd += tb3d * x_i2 + tb3 * x_i2d;
    x_i0b -= tb3 * FS_i2;
    x_i0bd -= tb3d * FS_i2 + tb3 * FS_i2d;
    FS_i2b = -(tb3 * x_i0);
    FS_i2bd = -(tb3d * x_i0 + tb3 * x_i0d);
    FSb[i][4] -= tb3;
    FSbd[i][4] -= tb3d;
    xb[i][0] += x_i0b;
    xbd[i][0] += x_i0bd;
    tb2 = wrenchb[i][3];
    tb2d = wrenchbd[i][3];
    wrenchb[i][3] = 0.0;
    wrenchbd[i][3] = 0.0;
    x_i1b += tb2 * FS_i2;
    x_i1bd += tb2d * FS_i2 + tb2 * FS_i2d;
    FS_i2b += tb2 * x_i1;
    FS_i2bd += tb2d * x_i1 + tb2 * x_i1d;
    x_i2b -= tb2 * FS_i1;
    x_i2bd -= tb2d * FS_i1 + tb2 * FS_i1d;
    FS_i1b -= tb2 * x_i2;
    FS_i1bd -= tb2d * x_i2 + tb2 * x_i2d;
    FSb[i][3] -= tb2;
    FSbd[i][3] -= tb2d;
    xb[i][2] += x_i2b;
    xbd[i][2] += x_i2bd;
    xb[i][1] += x_i1b;
    xbd[i][1] += x_i1bd;
    FS_i2b -= wrenchb[i][2];
    FS_i2bd -= wrenchbd[i][2];
    wrenchb[i][2] = 0.0;
    wrenchbd[i][2] = 0.0;
    FSb[i][2] += FS_i2b;
    FSbd[i][2] += FS_i2bd;
    FS_i1b -= wrenchb[i][1];
    FS_i1bd -= wrenchbd[i][1];
    wrenchb[i][1] = 0.0;
    wrenchbd[i][1] = 0.0;
    FSb[i][1] += FS_i1b;
    FSbd[i][1] += FS_i1bd;
    FS_i0b -= wrenchb[i][0];
    FS_i0bd -= wrenchbd[i][0];
    wrenchb[i][0] = 0.0;
    wrenchbd[i][0] = 0.0;
    FSb[i][0] += FS_i0b;
    FSbd[i][0] += FS_i0bd;
  }
}
