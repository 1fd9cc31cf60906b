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
 * corrections of positions), maggi_loop_multipliers the transpose: forces instead of velocities, islands
 * and updates from the last to the first.  FORMULATION 7, [1] 2.69-2.85:
 *
 *   Phi_z^T lambda = w on the dependent coordinates, w = forces not balanced by inertia
 *   lambda_b = Phi_bb mu_b,  mu_b = (Phi_bb^T Phi_bb)^-1 (w_b - sum over later islands Phi_cb^T lambda_c)
 *
 * of which lambda has the smallest norm.
 */
#include "columns.h"
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
      for (k = 0; k < m; ++k) s += phi[phiadr + k * n + i] * phi[phiadr + k * n + j];
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

/* columns begin..end in steps of `width`, which is MAGGI_WIDTH, or 1 for a single column */
ALWAYS_INLINE void row_update(int width, int dst, int src, int begin, int end, int stride, int q,
                              const double b[6], int nR, const double R[nR], int nV, double V[nV])
{
  int k, c, i, at, from;

  for (c = begin / width * width; c < end; c += width) {
    for (k = 0; k < 6; ++k) {
      at = (dst * 6 + k) * stride + c;
      from = (src * 6 + k) * stride + c;
#pragma omp simd
      for (i = 0; i < width; ++i) V[at + i] = V[from + i] + b[k] * R[q * stride + c + i];
    }
  }
}

/* components l, m, n of the rate of r_a - r_b (or of a - b when linear is 0):
 *   Y = (s_l + w_m r_n - w_n r_m) of b less that of a */
ALWAYS_INLINE void vector_rate(int width, int linear, int row, int l, int m, int n, int a, int b,
                               int k, const double ra[3], const double rb[3], int nV,
                               const double V[nV], int nY, double Y[nY])
{
  int i, am, an, bm, bn;

  am = a + (3 + m) * k;
  an = a + (3 + n) * k;
  bm = b + (3 + m) * k;
  bn = b + (3 + n) * k;
  if (linear) {
#pragma omp simd
    for (i = 0; i < width; ++i)
      Y[row + i] = V[b + l * k + i] - V[a + l * k + i] + V[bm + i] * rb[n] - V[bn + i] * rb[m] -
                   V[am + i] * ra[n] + V[an + i] * ra[m];
  } else {
#pragma omp simd
    for (i = 0; i < width; ++i)
      Y[row + i] = V[bm + i] * rb[n] - V[bn + i] * rb[m] - V[am + i] * ra[n] + V[an + i] * ra[m];
  }
}

/* force direction f and moments ma, mb about P of a unit multiplier of an equation with one row */
static void row_wrench(int kind, double length, const double ra[3], const double rb[3],
                       const double da[3], const double db[3], double f[3], double ma[3],
                       double mb[3])
{
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
}

/* Y = - rate of one building block for the columns of rows va and vb */
ALWAYS_INLINE void prim_rate(int width, int kind, int row, int va, int vb, int begin, int end,
                             int stride, double length, const double ra[3], const double rb[3],
                             const double da[3], const double db[3], int nV, const double V[nV],
                             int nY, double Y[nY])
{
  int c, i, a, b, k, y;
  double f[3], ma[3], mb[3];

  k = stride;
  if (kind != MAGGI_PRIM_POINT && kind != MAGGI_PRIM_AXIS)
    row_wrench(kind, length, ra, rb, da, db, f, ma, mb);
  for (c = begin / width * width; c < end; c += width) {
    a = va * 6 * k + c;
    b = vb * 6 * k + c;
    y = row * k + c;
    if (kind == MAGGI_PRIM_POINT) {
      vector_rate(width, 1, y, 0, 1, 2, a, b, k, ra, rb, nV, V, nY, Y);
      vector_rate(width, 1, y + k, 1, 2, 0, a, b, k, ra, rb, nV, V, nY, Y);
      vector_rate(width, 1, y + 2 * k, 2, 0, 1, a, b, k, ra, rb, nV, V, nY, Y);
    } else if (kind == MAGGI_PRIM_AXIS) {
      vector_rate(width, 0, y, 0, 1, 2, a, b, k, da, db, nV, V, nY, Y);
      vector_rate(width, 0, y + k, 1, 2, 0, a, b, k, da, db, nV, V, nY, Y);
      vector_rate(width, 0, y + 2 * k, 2, 0, 1, a, b, k, da, db, nV, V, nY, Y);
    } else {
#pragma omp simd
      for (i = 0; i < width; ++i)
        Y[y + i] = f[0] * (V[b + i] - V[a + i]) + f[1] * (V[b + k + i] - V[a + k + i]) +
                   f[2] * (V[b + 2 * k + i] - V[a + 2 * k + i]) + mb[0] * V[b + 3 * k + i] -
                   ma[0] * V[a + 3 * k + i] + mb[1] * V[b + 4 * k + i] - ma[1] * V[a + 4 * k + i] +
                   mb[2] * V[b + 5 * k + i] - ma[2] * V[a + 5 * k + i];
    }
  }
}

void maggi_island_columns(const maggi_topo *t, const double prim0[t->nprim],
                          const double r[t->npoint][3], const double dir[t->ndir][3],
                          const double b[t->nbody][6], const double phi[t->nphi],
                          const double chol[t->nchol], double V[t->nvrow * 6 * t->stride],
                          double Y[t->nrow * t->stride], double R[t->nq * t->stride],
                          double work[t->nq * MAGGI_WIDTH * 2])
{
  int k, i, j;

  for (k = 0; k < t->nisland; ++k) {
    for (i = t->islvop[k]; i < t->islvop[k + 1]; ++i) {
      j = t->vopdst[i];
      row_update(MAGGI_WIDTH, j, t->vopsrc[i], t->vrowbeg[j], t->vrowend[j], t->stride, t->vopq[i],
                 b[t->qbody[t->vopq[i]]], t->nq * t->stride, R, t->nvrow * 6 * t->stride, V);
    }
    for (i = t->islprim[k]; i < t->islprim[k + 1]; ++i) {
      j = t->primorder[i];
      prim_rate(MAGGI_WIDTH, t->primkind[j], t->primy[j], t->primva[j], t->primvb[j], t->islbeg[k],
                t->islend[k], t->stride, prim0[j], r[t->primpa[j]], r[t->primpb[j]],
                dir[t->primda[j]], dir[t->primdb[j]], t->nvrow * 6 * t->stride, V,
                t->nrow * t->stride, Y);
    }
    maggi_solve_columns(t->islrow[k + 1] - t->islrow[k], t->isldep[k + 1] - t->isldep[k],
                        t->islphi[k], phi, t->islchol[k], chol, t->islrow[k], Y, t->stride,
                        t->islbeg[k], t->islend[k], t->isldep[k], t->dep, R, work);
  }
}

/* width is a constant of the caller */
ALWAYS_INLINE void island_rates(int width, const maggi_topo *t, int k, int n,
                                const double prim0[t->nprim], const double r[t->npoint][3],
                                const double dir[t->ndir][3], const double b[t->nbody][6],
                                const double x[t->nq * n], double V[t->nvrow * 6 * n],
                                double Y[t->nrow * n])
{
  int i, j;

  for (i = t->islvop[k]; i < t->islvop[k + 1]; ++i)
    row_update(width, t->vopdst[i], t->vopsrc[i], 0, n, n, t->vopq[i], b[t->qbody[t->vopq[i]]],
               t->nq * n, x, t->nvrow * 6 * n, V);
  for (i = t->islprim[k]; i < t->islprim[k + 1]; ++i) {
    j = t->primorder[i];
    prim_rate(width, t->primkind[j], t->primy[j], t->primva[j], t->primvb[j], 0, n, n, prim0[j],
              r[t->primpa[j]], r[t->primpb[j]], dir[t->primda[j]], dir[t->primdb[j]],
              t->nvrow * 6 * n, V, t->nrow * n, Y);
  }
}

/* Y = - rate of the loops of island k by coordinates of earlier islands, x with room for n columns, one
 * or a multiple of MAGGI_WIDTH; V holds velocities by these */
void maggi_island_rates(const maggi_topo *t, int k, int n, const double prim0[t->nprim],
                        const double r[t->npoint][3], const double dir[t->ndir][3],
                        const double b[t->nbody][6], const double x[t->nq * n],
                        double V[t->nvrow * 6 * n], double Y[t->nrow * n])
{
  if (n == 1)
    island_rates(1, t, k, 1, prim0, r, dir, b, x, V, Y);
  else
    island_rates(MAGGI_WIDTH, t, k, n, prim0, r, dir, b, x, V, Y);
}

/* rows of rhs in the order of the loops; x is written for the dependent coordinates, zero elsewhere */
void maggi_island_vector(const maggi_topo *t, const double prim0[t->nprim],
                         const double r[t->npoint][3], const double dir[t->ndir][3],
                         const double b[t->nbody][6], const double phi[t->nphi],
                         const double chol[t->nchol], const double rhs[t->nrow],
                         double v1[t->nvrow * 6], double y1[t->nrow], double x[t->nq],
                         double work[t->nq * MAGGI_WIDTH * 2])
{
  int k, i, j, row;

  for (k = 0; k < t->nisland; ++k) {
    maggi_island_rates(t, k, 1, prim0, r, dir, b, x, v1, y1);
    for (i = t->islprim[k]; i < t->islprim[k + 1]; ++i) {
      j = t->primorder[i];
      for (row = 0; row < maggi_prim_rows(t->primkind[j]); ++row)
        y1[t->primy[j] + row] += rhs[t->primrow[j] + row];
    }
    maggi_solve_vector(t->islrow[k + 1] - t->islrow[k], t->isldep[k + 1] - t->isldep[k],
                       t->islphi[k], phi, t->islchol[k], chol, t->islrow[k], y1, t->isldep[k],
                       t->dep, x, work);
  }
}

/* adds the wrench - Phi^T lambda of one building block to those of body a and body b */
static void prim_wrench(int kind, int row, double length, const double ra[3], const double rb[3],
                        const double da[3], const double db[3], int nrow, const double lambda[nrow],
                        double Ga[6], double Gb[6])
{
  int k;
  double f[3], ma[3], mb[3];

  if (kind == MAGGI_PRIM_POINT || kind == MAGGI_PRIM_AXIS) {
    for (k = 0; k < 3; ++k) f[k] = lambda[row + k];
    maggi_cross(kind == MAGGI_PRIM_POINT ? ra : da, f, ma);
    maggi_cross(kind == MAGGI_PRIM_POINT ? rb : db, f, mb);
    for (k = 0; k < 3 && kind == MAGGI_PRIM_AXIS; ++k) f[k] = 0.0;
  } else {
    row_wrench(kind, length, ra, rb, da, db, f, ma, mb);
    for (k = 0; k < 3; ++k) {
      f[k] *= lambda[row];
      ma[k] *= lambda[row];
      mb[k] *= lambda[row];
    }
  }
  for (k = 0; k < 3; ++k) {
    Ga[k] -= f[k];
    Ga[k + 3] -= ma[k];
    Gb[k] += f[k];
    Gb[k + 3] += mb[k];
  }
}

/* mu of one island, L L^T mu = w, and y = Phi mu.  Where the pivots of L differ much, one step of
 * refinement: mu is by another of them larger than y, so y gets the correction and not the sum.  work
 * holds n numbers. */
ALWAYS_INLINE void island_multipliers(int m, int n, const double *phi, const double *L,
                                      const double *w, double *mu, double *y, double *work)
{
  int i, row, pass;
  double s;

  for (i = 0; i < n; ++i) {
    work[i] = w[i];
    mu[i] = 0.0;
  }
  clear(m, y);
  for (pass = 0;; ++pass) {
    substitute(n, 1, L, work);
    for (i = 0; i < n; ++i) mu[i] += work[i];
    for (row = 0; row < m; ++row) {
      s = 0.0;
      for (i = 0; i < n; ++i) s += phi[row * n + i] * work[i];
      y[row] += s;
    }
    if (pass > 0 || !has_small_pivots(n, L)) return;
    for (i = 0; i < n; ++i) {
      s = w[i];
      for (row = 0; row < m; ++row) s -= phi[row * n + i] * y[row];
      work[i] = s;
    }
  }
}

enum { SMALL_ISLAND = 3 };

/* an island of at most SMALL_ISLAND dependents; n is a constant of the caller */
ALWAYS_INLINE void small_multipliers(int m, int n, const double *phi, const double *L,
                                     const int *dep, double *mu, double *y)
{
  double w[SMALL_ISLAND], x[SMALL_ISLAND], work[SMALL_ISLAND];
  int i;

  for (i = 0; i < n; ++i) w[i] = mu[dep[i]];
  island_multipliers(m, n, phi, L, w, x, y, work);
  for (i = 0; i < n; ++i) mu[dep[i]] = x[i];
}

/* mu in place of w on the dependents of one island; work holds 3 n numbers */
static void solve_multipliers(int m, int n, const double phi[], const double L[], const int dep[],
                              double mu[], double y[], double work[])
{
  int i;

  if (n == 1) {
    small_multipliers(m, 1, phi, L, dep, mu, y);
  } else if (n == 2) {
    small_multipliers(m, 2, phi, L, dep, mu, y);
  } else if (n == 3) {
    small_multipliers(m, 3, phi, L, dep, mu, y);
  } else {
    for (i = 0; i < n; ++i) work[i] = mu[dep[i]];
    island_multipliers(m, n, phi, L, work, work + n, y, work + 2 * n);
    for (i = 0; i < n; ++i) mu[dep[i]] = work[n + i];
  }
}

/* mu on the dependent coordinates, no meaning on the others.  G holds wrenches on velocity rows. */
void maggi_loop_multipliers(const maggi_topo *t, const double prim0[t->nprim],
                            const double r[t->npoint][3], const double dir[t->ndir][3],
                            const double b[t->nbody][6], const double phi[t->nphi],
                            const double chol[t->nchol], const double w[t->nq],
                            double G[t->nvrow * 6], double y1[t->nrow], double mu[t->nq],
                            double lambda[t->nrow], double work[t->nq * MAGGI_WIDTH * 2])
{
  int k, i, j, c, q, row;
  double *dst, *src;

  for (i = 0; i < t->nq; ++i) mu[i] = w[i];
  for (i = 0; i < t->nrow; ++i) lambda[i] = 0.0;
  for (i = 0; i < t->nvrow * 6 && t->nisland > 1; ++i) G[i] = 0.0;
  for (k = t->nisland - 1; k >= 0; --k) {
    solve_multipliers(t->islrow[k + 1] - t->islrow[k], t->isldep[k + 1] - t->isldep[k],
                      phi + t->islphi[k], chol + t->islchol[k], t->dep + t->isldep[k], mu,
                      y1 + t->islrow[k], work);
    for (i = t->islprim[k]; i < t->islprim[k + 1]; ++i) {
      j = t->primorder[i];
      for (row = 0; row < maggi_prim_rows(t->primkind[j]); ++row)
        lambda[t->primrow[j] + row] = y1[t->primy[j] + row];
    }
    if (k == 0) break;
    for (i = t->islprim[k]; i < t->islprim[k + 1]; ++i) {
      j = t->primorder[i];
      prim_wrench(t->primkind[j], t->primrow[j], prim0[j], r[t->primpa[j]], r[t->primpb[j]],
                  dir[t->primda[j]], dir[t->primdb[j]], t->nrow, lambda, G + t->primva[j] * 6,
                  G + t->primvb[j] * 6);
    }
    for (i = t->islvop[k + 1] - 1; i >= t->islvop[k]; --i) {
      q = t->vopq[i];
      dst = G + t->vopdst[i] * 6;
      src = G + t->vopsrc[i] * 6;
      mu[q] += maggi_dot6(b[t->qbody[q]], dst);
      for (c = 0; c < 6; ++c) src[c] += dst[c];
    }
  }
}

/* sum of R v over the blocks of begin..end; v may have anything finite where R is zero */
static double row_dot(int row, int begin, int end, int nR, const double R[nR], int nv,
                      const double v[nv])
{
  int c, i;
  double s;

  s = 0.0;
  for (c = begin / MAGGI_WIDTH * MAGGI_WIDTH; c < end; c += MAGGI_WIDTH) {
#pragma omp simd reduction(+ : s)
    for (i = 0; i < MAGGI_WIDTH; ++i) s += R[row + c + i] * v[c + i];
  }
  return s;
}

/* v = R vcol + x0 on the dependent coordinates, vcol on the others */
void maggi_expand(const maggi_topo *t, const double R[t->nq * t->stride],
                  const double vcol[t->stride], const double x0[t->nq], double v[t->nq])
{
  int i, k, c;

  for (c = 0; c < t->ncol; ++c) v[t->colq[c]] = vcol[c];
  for (i = 0; i < t->ndep; ++i) {
    k = t->dep[i];
    v[k] = x0[k] +
           row_dot(k * t->stride, t->rbeg[k], t->rend[k], t->nq * t->stride, R, t->stride, vcol);
  }
}
