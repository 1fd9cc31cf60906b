/* Dependent velocities, island by island.  FORMULATION 4, [1] 5.42.
 *
 * An island is a set of loops whose dependent coordinates must be solved together; islands come in
 * an order in which each needs only dependents of earlier ones, so Phi_d is block lower triangular:
 *
 *   Phi_bb R_b = - (rate of the loops with the dependents of this island at rest) =: Y
 *   R_b = (Phi_bb^T Phi_bb)^-1 Phi_bb^T Y
 *
 * The rate comes from velocities V of bodies (relative to the body that carries both sides), one row
 * a body, 6 x stride numbers, one column for each independent or guided coordinate, propagated by
 *   V_dst = V_src + b_i R_i.
 * maggi_island_vector does the same for one column with a given right-hand side (accelerations,
 * corrections of positions).
 */
#include "kernel.h"

/* A = Phi^T Phi, lower half, then its factor in the same place */
static void normal_matrix(int m, int n, int phiadr, int nphi, const double phi[nphi], int adr,
                          int nchol, double chol[nchol])
{
  int i, j, k;
  double s;

  for (i = 0; i < n; ++i) {
    for (j = 0; j <= i; ++j) {
      s = 0.0;
      for (k = 0; k < m; ++k)
        s += phi[phiadr + k * n + i] * phi[phiadr + k * n + j];
      chol[adr + i * n + j] = s;
    }
  }
}

void maggi_island_factors(const maggi_topo *t, const double phi[t->nphi], double chol[t->nchol])
{
  int k, n;

  for (k = 0; k < t->nisland; ++k) {
    n = t->isldep[k + 1] - t->isldep[k];
    normal_matrix(t->islrow[k + 1] - t->islrow[k], n, t->islphi[k], t->nphi, phi, t->islchol[k],
                  t->nchol, chol);
    maggi_cholesky_island(n, t->islchol[k], chol);
  }
}

static void row_update(int dst, int src, int begin, int end, int stride, int q, const double b[6],
                       int nR, const double R[nR], int nV, double V[nV])
{
  int k, c;

  for (k = 0; k < 6; ++k)
    for (c = begin; c < end; ++c)
      V[(dst * 6 + k) * stride + c] = V[(src * 6 + k) * stride + c] + b[k] * R[q * stride + c];
}

/* Y = - rate of one building block for the columns of bodies a and b */
static void prim_rate(int kind, int row, int va, int vb, int begin, int end, int stride,
                      double length, const double ra[3], const double rb[3], const double da[3],
                      const double db[3], int nV, const double V[nV], int nY, double Y[nY])
{
  int c, i, j, k;
  double f[3], ma[3], mb[3];

  i = va * 6 * stride;
  j = vb * 6 * stride;
  k = stride;
  if (kind == MAGGI_PRIM_POINT) {
    for (c = begin; c < end; ++c)
      Y[row * k + c] = V[j + c] + V[j + 4 * k + c] * rb[2] - V[j + 5 * k + c] * rb[1] -
                       (V[i + c] + V[i + 4 * k + c] * ra[2] - V[i + 5 * k + c] * ra[1]);
    for (c = begin; c < end; ++c)
      Y[(row + 1) * k + c] = V[j + k + c] + V[j + 5 * k + c] * rb[0] - V[j + 3 * k + c] * rb[2] -
                             (V[i + k + c] + V[i + 5 * k + c] * ra[0] - V[i + 3 * k + c] * ra[2]);
    for (c = begin; c < end; ++c)
      Y[(row + 2) * k + c] =
          V[j + 2 * k + c] + V[j + 3 * k + c] * rb[1] - V[j + 4 * k + c] * rb[0] -
          (V[i + 2 * k + c] + V[i + 3 * k + c] * ra[1] - V[i + 4 * k + c] * ra[0]);
  } else if (kind == MAGGI_PRIM_AXIS) {
    for (c = begin; c < end; ++c)
      Y[row * k + c] = V[j + 4 * k + c] * db[2] - V[j + 5 * k + c] * db[1] -
                       (V[i + 4 * k + c] * da[2] - V[i + 5 * k + c] * da[1]);
    for (c = begin; c < end; ++c)
      Y[(row + 1) * k + c] = V[j + 5 * k + c] * db[0] - V[j + 3 * k + c] * db[2] -
                             (V[i + 5 * k + c] * da[0] - V[i + 3 * k + c] * da[2]);
    for (c = begin; c < end; ++c)
      Y[(row + 2) * k + c] = V[j + 3 * k + c] * db[1] - V[j + 4 * k + c] * db[0] -
                             (V[i + 3 * k + c] * da[1] - V[i + 4 * k + c] * da[0]);
  } else {
    /* one row: force direction f and moments ma, mb about P of a unit multiplier */
    if (kind == MAGGI_PRIM_ANGLE) {
      maggi_cross(da, db, ma);
      maggi_cross(da, db, mb);
      f[0] = 0.0;
      f[1] = 0.0;
      f[2] = 0.0;
    } else if (kind == MAGGI_PRIM_PLANE) {
      f[0] = db[0];
      f[1] = db[1];
      f[2] = db[2];
      maggi_cross(ra, db, ma);
      maggi_cross(ra, db, mb);
    } else {
      f[0] = (ra[0] - rb[0]) / length;
      f[1] = (ra[1] - rb[1]) / length;
      f[2] = (ra[2] - rb[2]) / length;
      maggi_cross(ra, f, ma);
      maggi_cross(rb, f, mb);
    }
    for (c = begin; c < end; ++c)
      Y[row * k + c] =
          f[0] * (V[j + c] - V[i + c]) + f[1] * (V[j + k + c] - V[i + k + c]) +
          f[2] * (V[j + 2 * k + c] - V[i + 2 * k + c]) + mb[0] * V[j + 3 * k + c] -
          ma[0] * V[i + 3 * k + c] + mb[1] * V[j + 4 * k + c] - ma[1] * V[i + 4 * k + c] +
          mb[2] * V[j + 5 * k + c] - ma[2] * V[i + 5 * k + c];
  }
}

void maggi_island_columns(const maggi_topo *t, const double prim0[t->nprim],
                          const double r[t->npoint][3], const double dir[t->ndir][3],
                          const double b[t->nbody][6], const double phi[t->nphi],
                          const double chol[t->nchol], double V[t->nvrow * 6 * t->stride],
                          double Y[t->nrow * t->stride], double R[t->nq * t->stride],
                          double work[t->nq * MAGGI_SOLVE_WIDTH])
{
  int k, i, j;

  for (k = 0; k < t->nisland; ++k) {
    for (i = t->islvop[k]; i < t->islvop[k + 1]; ++i) {
      j = t->vopdst[i];
      row_update(j, t->vopsrc[i], t->vrowbeg[j], t->vrowend[j], t->stride, t->vopq[i],
                 b[t->qbody[t->vopq[i]]], t->nq * t->stride, R, t->nvrow * 6 * t->stride, V);
    }
    for (i = t->islprim[k]; i < t->islprim[k + 1]; ++i) {
      j = t->primorder[i];
      prim_rate(t->primkind[j], t->primy[j], t->primva[j], t->primvb[j], t->islbeg[k],
                t->islend[k], t->stride, prim0[j], r[t->primpa[j]], r[t->primpb[j]],
                dir[t->primda[j]], dir[t->primdb[j]], t->nvrow * 6 * t->stride, V,
                t->nrow * t->stride, Y);
    }
    maggi_solve_island(t->islrow[k + 1] - t->islrow[k], t->isldep[k + 1] - t->isldep[k],
                       t->islphi[k], phi, t->islchol[k], chol, t->islrow[k], Y, t->stride,
                       t->islbeg[k], t->islend[k], t->isldep[k], t->dep, R, work);
  }
}

/* rows of rhs in the order of the loops; x is written for the dependent coordinates, zero elsewhere */
void maggi_island_vector(const maggi_topo *t, const double prim0[t->nprim],
                         const double r[t->npoint][3], const double dir[t->ndir][3],
                         const double b[t->nbody][6], const double phi[t->nphi],
                         const double chol[t->nchol], const double rhs[t->nrow],
                         double v1[t->nvrow * 6], double y1[t->nrow], double x[t->nq],
                         double work[t->nq * MAGGI_SOLVE_WIDTH])
{
  int k, i, j, n, row;

  for (k = 0; k < t->nisland; ++k) {
    for (i = t->islvop[k]; i < t->islvop[k + 1]; ++i)
      row_update(t->vopdst[i], t->vopsrc[i], 0, 1, 1, t->vopq[i], b[t->qbody[t->vopq[i]]], t->nq,
                 x, t->nvrow * 6, v1);
    for (i = t->islprim[k]; i < t->islprim[k + 1]; ++i) {
      j = t->primorder[i];
      prim_rate(t->primkind[j], t->primy[j], t->primva[j], t->primvb[j], 0, 1, 1, prim0[j],
                r[t->primpa[j]], r[t->primpb[j]], dir[t->primda[j]], dir[t->primdb[j]],
                t->nvrow * 6, v1, t->nrow, y1);
      n = t->primkind[j] == MAGGI_PRIM_POINT || t->primkind[j] == MAGGI_PRIM_AXIS ? 3 : 1;
      for (row = 0; row < n; ++row)
        y1[t->primy[j] + row] += rhs[t->primrow[j] + row];
    }
    maggi_solve_island(t->islrow[k + 1] - t->islrow[k], t->isldep[k + 1] - t->isldep[k],
                       t->islphi[k], phi, t->islchol[k], chol, t->islrow[k], y1, 1, 0, 1,
                       t->isldep[k], t->dep, x, work);
  }
}

/* v = R vcol + x0 on the dependent coordinates, vcol on the others */
void maggi_expand(const maggi_topo *t, const double R[t->nq * t->stride],
                  const double vcol[t->ncol], const double x0[t->nq], double v[t->nq])
{
  int i, c;
  double s;

  for (i = 0; i < t->nq; ++i) {
    if (t->col[i] >= 0) {
      v[i] = vcol[t->col[i]];
    } else {
      s = x0[i];
      for (c = t->rbeg[i]; c < t->rend[i]; ++c)
        s += R[i * t->stride + c] * vcol[c];
      v[i] = s;
    }
  }
}
