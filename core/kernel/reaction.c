/* Lagrange multipliers of the loops and the forces they stand for.  FORMULATION 7, [1] 2.69-2.85.
 *
 * Phi_z^T lambda = w on the dependent coordinates, w = forces not balanced by inertia.  Islands from
 * the last to the first, each with the share of smallest norm:
 *   lambda_b = Phi_bb (Phi_bb^T Phi_bb)^-1 (w_b - sum over later islands Phi_cb^T lambda_c)
 */
#include "kernel.h"

/* L L^T y = y in place, one island */
static void solve_factor(int n, int adr, int nchol, const double chol[nchol], int depadr,
                         const int dep[], int nq, double y[nq])
{
  int i, j;
  double s;

  for (i = 0; i < n; ++i) {
    s = y[dep[depadr + i]];
    for (j = 0; j < i; ++j) s -= chol[adr + i * n + j] * y[dep[depadr + j]];
    y[dep[depadr + i]] = s * chol[adr + i * n + i];
  }
  for (i = n - 1; i >= 0; --i) {
    s = y[dep[depadr + i]];
    for (j = i + 1; j < n; ++j) s -= chol[adr + j * n + i] * y[dep[depadr + j]];
    y[dep[depadr + i]] = s * chol[adr + i * n + i];
  }
}

void maggi_loop_multipliers(const maggi_topo *t, const double prim0[t->nprim],
                            const double r[t->npoint][3], const double dir[t->ndir][3],
                            const double b[t->nbody][6], const double phi[t->nphi],
                            const double chol[t->nchol], const double w[t->nq], double wd[t->nq],
                            double lambda[t->nrow])
{
  int k, i, j, l, n, row, c;
  double s;
  double e[3];

  for (i = 0; i < t->nq; ++i) wd[i] = w[i];
  for (i = 0; i < t->nrow; ++i) lambda[i] = 0.0;
  for (k = t->nisland - 1; k >= 0; --k) {
    n = t->isldep[k + 1] - t->isldep[k];
    solve_factor(n, t->islchol[k], t->nchol, chol, t->isldep[k], t->dep, t->nq, wd);
    for (i = t->islprim[k]; i < t->islprim[k + 1]; ++i) {
      j = t->primorder[i];
      for (row = 0; row < maggi_prim_rows(t->primkind[j]); ++row) {
        s = 0.0;
        for (c = 0; c < n; ++c)
          s += phi[t->islphi[k] + (t->primy[j] + row - t->islrow[k]) * n + c] *
               wd[t->dep[t->isldep[k] + c]];
        lambda[t->primrow[j] + row] = s;
      }
    }
    for (i = t->islprim[k]; i < t->islprim[k + 1]; ++i) {
      j = t->primorder[i];
      l = t->primloop[j];
      for (c = t->pathadr[l]; c < t->pathadr[l + 1]; ++c) {
        maggi_prim_entry(t->primkind[j], t->pathside[c], prim0[j], b[t->qbody[t->pathq[c]]],
                         r[t->primpa[j]], r[t->primpb[j]], dir[t->primda[j]], dir[t->primdb[j]], e);
        for (row = 0; row < maggi_prim_rows(t->primkind[j]); ++row)
          wd[t->pathq[c]] -= e[row] * lambda[t->primrow[j] + row];
      }
    }
  }
}

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
  double l[3], fa[3], fb[3], c[3], ca[3], cb[3];

  if (kind == MAGGI_PRIM_AXIS) {
    for (k = 0; k < 3; ++k) l[k] = lambda[row + k];
    maggi_cross(l, da, ca);
    maggi_cross(db, l, cb);
    torque_add(ca, Fa);
    torque_add(cb, Fb);
  } else if (kind == MAGGI_PRIM_ANGLE) {
    maggi_cross(db, da, c);
    for (k = 0; k < 3; ++k) {
      ca[k] = lambda[row] * c[k];
      cb[k] = -lambda[row] * c[k];
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

/* adds to F what the loops exert on bodies */
void maggi_loop_forces(const maggi_topo *t, const double prim0[t->nprim],
                       const double r[t->npoint][3], const double dir[t->ndir][3],
                       const double lambda[t->nrow], double F[t->nbody + 1][6])
{
  int i;

  for (i = 0; i < t->nprim; ++i)
    prim_force(t->primkind[i], t->primrow[i], prim0[i], r[t->primpa[i]], r[t->primpb[i]],
               dir[t->primda[i]], dir[t->primdb[i]], t->nrow, lambda, F[t->primba[i]],
               F[t->primbb[i]]);
}
