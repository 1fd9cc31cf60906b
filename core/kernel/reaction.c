/* Forces that the multipliers of the loops stand for, and reactions of joints.  FORMULATION 7, [1]
 * 2.69-2.85. */
#include "kernel.h"

static void torque_add(const double torque[3], double F[6])
{
  F[3] += torque[0];
  F[4] += torque[1];
  F[5] += torque[2];
}

/* wrench at P that a building block exerts on body a and body b: - Phi^T lambda */
static void prim_force(int kind, int row, double length, const double ra[3], const double rb[3],
                       const double da[3], const double db[3], int nrow, const double lambda[nrow],
                       double Fa[6], double Fb[6])
{
  int k;
  double l[3], fa[3], fb[3], n[3], ca[3], cb[3];

  if (kind == MAGGI_PRIM_AXIS) {
    for (k = 0; k < 3; ++k) l[k] = lambda[row + k];
    maggi_cross(l, da, ca);
    maggi_cross(db, l, cb);
    torque_add(ca, Fa);
    torque_add(cb, Fb);
  } else if (kind == MAGGI_PRIM_ANGLE) {
    maggi_cross(db, da, n);
    for (k = 0; k < 3; ++k) {
      ca[k] = lambda[row] * n[k];
      cb[k] = -lambda[row] * n[k];
    }
    torque_add(ca, Fa);
    torque_add(cb, Fb);
  } else {
    for (k = 0; k < 3; ++k) {
      if (kind == MAGGI_PRIM_POINT)
        fb[k] = lambda[row + k];
      else if (kind == MAGGI_PRIM_PLANE)
        fb[k] = lambda[row] * db[k];
      else
        fb[k] = lambda[row] * (ra[k] - rb[k]) / length;
      fa[k] = -fb[k];
    }
    maggi_wrench_add(fa, ra, Fa);
    if (kind == MAGGI_PRIM_PLANE)
      maggi_wrench_add(fb, ra, Fb);
    else
      maggi_wrench_add(fb, rb, Fb);
  }
}

/* the moment of an open pair of forces, which no joint of the loop takes */
static void carrier_torque(int row, const double a[3], const double b[3], int nrow,
                           const double lambda[nrow], double F[6])
{
  int k;
  double e[3], l[3], c[3];

  for (k = 0; k < 3; ++k) {
    e[k] = a[k] - b[k];
    l[k] = lambda[row + k];
  }
  maggi_cross(e, l, c);
  torque_add(c, F);
}

/* adds to F what the loops exert on bodies; what open ones would exert on the joints that carry both
 * sides is left out, as in Phi_z */
void maggi_loop_forces(const maggi_topo *t, const double prim0[t->nprim],
                       const double r[t->npoint][3], const double dir[t->ndir][3],
                       const double lambda[t->nrow], double F[t->nbody + 1][6])
{
  int i, c;

  for (i = 0; i < t->nprim; ++i)
    prim_force(t->primkind[i], t->primrow[i], prim0[i], r[t->primpa[i]], r[t->primpb[i]],
               dir[t->primda[i]], dir[t->primdb[i]], t->nrow, lambda, F[t->primba[i]],
               F[t->primbb[i]]);
  for (i = 0; i < t->nprim; ++i) {
    c = t->loopcommon[t->primloop[i]];
    if (c < t->nbody && t->primkind[i] == MAGGI_PRIM_POINT)
      carrier_torque(t->primrow[i], r[t->primpa[i]], r[t->primpb[i]], t->nrow, lambda, F[c]);
    else if (c < t->nbody && t->primkind[i] == MAGGI_PRIM_AXIS)
      carrier_torque(t->primrow[i], dir[t->primda[i]], dir[t->primdb[i]], t->nrow, lambda, F[c]);
  }
}

/* what a joint exerts on its body, about the joint point: - FS, which is about P */
void maggi_reactions(const maggi_topo *t, const double x[t->nbody + 1][3],
                     const double FS[t->nbody + 1][6], double wrench[t->nbody][6])
{
  int i;

  for (i = 0; i < t->nbody; ++i) {
    wrench[i][0] = -FS[i][0];
    wrench[i][1] = -FS[i][1];
    wrench[i][2] = -FS[i][2];
    wrench[i][3] = x[i][1] * FS[i][2] - x[i][2] * FS[i][1] - FS[i][3];
    wrench[i][4] = x[i][2] * FS[i][0] - x[i][0] * FS[i][2] - FS[i][4];
    wrench[i][5] = x[i][0] * FS[i][1] - x[i][1] * FS[i][0] - FS[i][5];
  }
}
