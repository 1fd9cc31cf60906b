/* Mass matrix of the tree, its reduction by R_z, and the reduced force.  FORMULATION 3, 5 and 6.
 *
 *   M_ij = b_i^T IS_j b_j          i = j or i an ancestor of j
 *   rods add  m/6 (J_a^T J_b + J_b^T J_a),  J = velocity of an end by coordinates, that of end a times m/6
 *   M^   = R^T M R                 in three parts, with D the dependent rows of R and U its rest:
 *        = M_uu + D^T Z + Z^T D,   Z = M_du + (one half of M_dd with half its diagonal) D
 * of which the upper half is computed.
 */
#include "kernel.h"

/* M_ij = b_j.F of the ancestors j of one coordinate, F = IS_i b_i */
static void mass_row(const maggi_topo *t, int begin, int end, const double b[t->nbody][6],
                     const double F[6], double M[t->npair])
{
  int k, j;
  double f0, f1, f2, f3, f4, f5;

  f0 = F[0];
  f1 = F[1];
  f2 = F[2];
  f3 = F[3];
  f4 = F[4];
  f5 = F[5];
  for (k = begin; k < end; ++k) {
    j = t->qbody[t->pairj[k]];
    M[k] =
        (b[j][0] * f0 + b[j][1] * f1 + b[j][2] * f2) + (b[j][3] * f3 + b[j][4] * f4 + b[j][5] * f5);
  }
}

void maggi_mass_matrix(const maggi_topo *t, const double p[t->np], const double b[t->nbody][6],
                       const double r[t->npoint][3], const double IS[t->nbody + 1][10],
                       double Fb[t->nq][6], double rodjac[t->nrodjac][3], double M[t->npair])
{
  int i, k, n;
  double f;
  double rate[3];

  for (i = 0; i < t->nq; ++i) maggi_inertia_mul(IS[t->qbody[i]], b[t->qbody[i]], Fb[i]);
  for (i = 0; i < t->nq; ++i) mass_row(t, t->pairadr[i], t->pairadr[i + 1], b, Fb[i], M);
  for (k = t->ntreepair; k < t->npair; ++k) M[k] = 0.0;
  for (i = 0; i < t->nrodjac; ++i) {
    maggi_point_rate(b[t->qbody[t->rodjacq[i]]], r[t->rodjacpoint[i]], rate);
    f = 1.0;
    if (t->rodjacadr[i] >= 0) f = p[t->rodjacadr[i]] * (1.0 / 6.0);
    for (k = 0; k < 3; ++k) rodjac[i][k] = f * rate[k];
  }
  n = 0;
  for (i = 0; i < t->nrodjac; ++i) {
    for (k = 0; k < t->rodjacnum[i]; ++k)
      M[t->rodpairm[n + k]] += maggi_dot(rodjac[i], rodjac[t->rodjacother[i] + k]);
    n = n + t->rodjacnum[i];
  }
}

/* dst[begin..end] += f src[begin..end] */
static void row_axpy(int dst, int src, int begin, int end, double f, int nR, const double R[nR],
                     int nZ, double Z[nZ])
{
  int c, i;

  for (c = begin / MAGGI_WIDTH * MAGGI_WIDTH; c < end; c += MAGGI_WIDTH) {
#pragma omp simd
    for (i = 0; i < MAGGI_WIDTH; ++i) Z[dst + c + i] += f * R[src + c + i];
  }
}

/* upper half of D^T Z + Z^T D for one dependent coordinate; its range of D is a part of that of Z */
static void outer_add(int row, int rbeg, int rend, int zbeg, int zend, int stride, int n,
                      const double R[n], const double Z[n], int nM, double M[nM])
{
  int c;

  for (c = zbeg; c < rbeg; ++c) row_axpy(c * stride, row, rbeg, rend, Z[row + c], n, R, nM, M);
  for (c = rbeg; c < rend; ++c) {
    row_axpy(c * stride, row, c, zend, R[row + c], n, Z, nM, M);
    row_axpy(c * stride, row, c, rend, Z[row + c], n, R, nM, M);
  }
}

static void row_zero(int row, int begin, int end, int n, double M[n])
{
  int c, i;

  for (c = begin / MAGGI_WIDTH * MAGGI_WIDTH; c < end; c += MAGGI_WIDTH) {
#pragma omp simd
    for (i = 0; i < MAGGI_WIDTH; ++i) M[row + c + i] = 0.0;
  }
}

/* row of M_dd R for dependent coordinate i of the order of dep, with half of its own entry */
static void row_sum(const maggi_topo *t, int i, const double M[t->npair],
                    const double R[t->nq * t->stride], double MR[t->nq * t->stride])
{
  int c, e, j, k, from;
  double f;
  double sum[MAGGI_WIDTH];

  k = t->dep[i];
  for (c = t->zbeg[k] / MAGGI_WIDTH * MAGGI_WIDTH; c < t->zend[k]; c += MAGGI_WIDTH) {
    for (j = 0; j < MAGGI_WIDTH; ++j) sum[j] = 0.0;
    for (e = t->ddadr[i]; e < t->ddadr[i + 1]; ++e) {
      from = t->ddsrc[e] * t->stride + c;
      f = t->ddsrc[e] == k ? 0.5 * M[t->ddpair[e]] : M[t->ddpair[e]];
#pragma omp simd
      for (j = 0; j < MAGGI_WIDTH; ++j) sum[j] += f * R[from + j];
    }
    for (j = 0; j < MAGGI_WIDTH; ++j) MR[k * t->stride + c + j] = sum[j];
  }
}

void maggi_reduced_mass(const maggi_topo *t, const double M[t->npair],
                        const double R[t->nq * t->stride], double MR[t->nq * t->stride],
                        double Mr[t->ncol * t->stride])
{
  int i, k, nR, nM;

  nR = t->nq * t->stride;
  nM = t->ncol * t->stride;
  for (i = 0; i < t->ncol; ++i) row_zero(i * t->stride, i, t->ncol, nM, Mr);
  for (i = 0; i < t->ndep; ++i) row_sum(t, i, M, R, MR);
  for (i = 0; i < t->nii; ++i) Mr[t->iirow[i] * t->stride + t->iicol[i]] += M[t->iipair[i]];
  for (i = 0; i < t->nid; ++i) MR[t->iddep[i] * t->stride + t->idcol[i]] += M[t->idpair[i]];
  for (i = 0; i < t->ndep; ++i) {
    k = t->dep[i];
    outer_add(k * t->stride, t->rbeg[k], t->rend[k], t->zbeg[k], t->zend[k], t->stride, nR, R, MR,
              nM, Mr);
  }
}

/* f_i = b_i.FS_i + tau_i */
void maggi_generalised_forces(const maggi_topo *t, const double b[t->nbody][6],
                              const double FS[t->nbody + 1][6], const double tau[t->nq],
                              double f[t->nq])
{
  int i;

  for (i = 0; i < t->nq; ++i) f[i] = maggi_dot6(b[t->qbody[i]], FS[t->qbody[i]]) + tau[i];
}

/* R^T f */
void maggi_reduced_force(const maggi_topo *t, const double f[t->nq],
                         const double R[t->nq * t->stride], double fr[t->stride])
{
  int i, k, c;

  for (c = 0; c < t->ncol; ++c) fr[c] = f[t->colq[c]];
  for (i = 0; i < t->ndep; ++i) {
    k = t->dep[i];
    row_axpy(0, k * t->stride, t->rbeg[k], t->rend[k], f[k], t->nq * t->stride, R, t->stride, fr);
  }
}

/* torque or force of a guide: its row of M^ a - R^T f */
void maggi_drives(const maggi_topo *t, const double Mr[t->ncol * t->stride],
                  const double fr[t->ncol], const double acol[t->ncol], double drive[t->ncol])
{
  int i, k;
  double s;

  for (i = 0; i < t->nind; ++i) drive[i] = 0.0;
  for (i = t->nind; i < t->ncol; ++i) {
    s = -fr[i];
    for (k = 0; k < i; ++k) s += Mr[k * t->stride + i] * acol[k];
    for (k = i; k < t->ncol; ++k) s += Mr[i * t->stride + k] * acol[k];
    drive[i] = s;
  }
}
