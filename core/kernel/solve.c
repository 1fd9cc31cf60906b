/* Linear solves: Cholesky without pivoting.  These are differentiated by rule, with the factor at
 * hand, not line by line (AD.md), so they may be written for speed. */
#include <stddef.h>

#include "kernel.h"

/* lower factor of the n x n matrix at chol[adr], in place; a lost pivot leaves what is not finite */
void maggi_cholesky_island(int n, int adr, double chol[])
{
  int i, j, k;
  double s;
  double *L = chol + adr;

  for (i = 0; i < n; ++i) {
    for (j = 0; j < i; ++j) {
      s = L[i * n + j];
      for (k = 0; k < j; ++k)
        s -= L[i * n + k] * L[j * n + k];
      L[i * n + j] = s / L[j * n + j];
    }
    s = L[i * n + i];
    for (k = 0; k < i; ++k)
      s -= L[i * n + k] * L[i * n + k];
    L[i * n + i] = sqrt(s);
  }
}

enum { CHUNK = MAGGI_SOLVE_WIDTH };

/* row i of a set of rows: at[i], or i itself when at is NULL */
static inline int row_of(const int *at, int i)
{
  return at ? at[i] : i;
}

/* X = A^-1 X, L L^T = A, on `width` columns of the rows `at` of X */
static inline void substitute(int n, int width, const double *L, const int *at, int stride,
                              double *X)
{
  int i, j, c;
  double f;
  double *x;

  for (i = 0; i < n; ++i) {
    x = X + row_of(at, i) * stride;
    for (j = 0; j < i; ++j) {
      f = L[i * n + j];
      for (c = 0; c < width; ++c)
        x[c] -= f * X[row_of(at, j) * stride + c];
    }
    f = 1.0 / L[i * n + i];
    for (c = 0; c < width; ++c)
      x[c] *= f;
  }
  for (i = n - 1; i >= 0; --i) {
    x = X + row_of(at, i) * stride;
    for (j = i + 1; j < n; ++j) {
      f = L[j * n + i];
      for (c = 0; c < width; ++c)
        x[c] -= f * X[row_of(at, j) * stride + c];
    }
    f = 1.0 / L[i * n + i];
    for (c = 0; c < width; ++c)
      x[c] *= f;
  }
}

/* T = Phi^T (Y - Phi X), or Phi^T Y when X is NULL; rows `at` of X, rows `tat` of T */
static inline void project(int m, int n, int width, const double *phi, const double *Y, int stride,
                           const int *at, const double *X, const int *tat, int tstride, double *T)
{
  int i, k, c;
  double e[CHUNK];

  for (i = 0; i < n; ++i)
    for (c = 0; c < width; ++c)
      T[row_of(tat, i) * tstride + c] = 0.0;
  for (k = 0; k < m; ++k) {
    for (c = 0; c < width; ++c)
      e[c] = Y[k * stride + c];
    if (X)
      for (i = 0; i < n; ++i)
        for (c = 0; c < width; ++c)
          e[c] -= phi[k * n + i] * X[row_of(at, i) * stride + c];
    for (i = 0; i < n; ++i)
      for (c = 0; c < width; ++c)
        T[row_of(tat, i) * tstride + c] += phi[k * n + i] * e[c];
  }
}

/* X = (Phi^T Phi)^-1 Phi^T Y with one step of iterative refinement */
static inline void solve_chunk(int m, int n, int width, const double *phi, const double *L,
                               const double *Y, int stride, const int *at, double *X, double *work)
{
  int i, c;

  project(m, n, width, phi, Y, stride, NULL, NULL, at, stride, X);
  substitute(n, width, L, at, stride, X);
  project(m, n, width, phi, Y, stride, at, X, NULL, CHUNK, work);
  substitute(n, width, L, NULL, CHUNK, work);
  for (i = 0; i < n; ++i)
    for (c = 0; c < width; ++c)
      X[at[i] * stride + c] += work[i * CHUNK + c];
}

/* Columns begin..end of the rows dep[depadr..] of X; Y has m rows from yrow on; rows are `stride`
 * long; work holds n rows of MAGGI_SOLVE_WIDTH numbers. */
void maggi_solve_island(int m, int n, int phiadr, const double phi[], int choladr,
                        const double chol[], int yrow, const double Y[], int stride, int begin,
                        int end, int depadr, const int dep[], double X[], double work[])
{
  int c;

  for (c = begin; c + CHUNK <= end; c += CHUNK)
    solve_chunk(m, n, CHUNK, phi + phiadr, chol + choladr, Y + yrow * stride + c, stride,
                dep + depadr, X + c, work);
  if (c < end)
    solve_chunk(m, n, end - c, phi + phiadr, chol + choladr, Y + yrow * stride + c, stride,
                dep + depadr, X + c, work);
}

static inline double dot_rows(int begin, int end, const double *a, const double *b)
{
  int k;
  double s = 0.0;

#pragma omp simd reduction(+ : s)
  for (k = begin; k < end; ++k)
    s += a[k] * b[k];
  return s;
}

/* Factor of the reduced mass matrix, rows from their first nonzero on: the columns are numbered from
 * the leaves to the root, so the factor keeps these zeros.  dinv holds the inverse pivots. */
void maggi_factor_mass(const maggi_topo *t, const double Mr[], double Lr[], double dinv[])
{
  int i, j, begin;
  int n = t->nind, stride = t->stride;
  double s;

  for (i = 0; i < n; ++i) {
    for (j = t->first[i]; j < i; ++j) {
      begin = t->first[i] > t->first[j] ? t->first[i] : t->first[j];
      s = Mr[i * stride + j] - dot_rows(begin, j, Lr + i * stride, Lr + j * stride);
      Lr[i * stride + j] = s * dinv[j];
    }
    s = Mr[i * stride + i] - dot_rows(t->first[i], i, Lr + i * stride, Lr + i * stride);
    Lr[i * stride + i] = sqrt(s);
    dinv[i] = 1.0 / Lr[i * stride + i];
  }
}

/* M_ii a_i = f_i - M_ig a_g; acol holds a_g on entry and all accelerations of columns on return */
void maggi_solve_mass(const maggi_topo *t, const double Mr[], const double fr[], const double Lr[],
                      const double dinv[], double acol[])
{
  int i, k;
  int n = t->nind, stride = t->stride;

  for (i = 0; i < n; ++i)
    acol[i] = fr[i];
  for (k = n; k < t->ncol; ++k)
    for (i = t->first[k]; i < n; ++i)
      acol[i] -= Mr[k * stride + i] * acol[k];
  for (i = 0; i < n; ++i)
    acol[i] = (acol[i] - dot_rows(t->first[i], i, Lr + i * stride, acol)) * dinv[i];
  for (i = n - 1; i >= 0; --i) {
    acol[i] *= dinv[i];
    for (k = t->first[i]; k < i; ++k)
      acol[k] -= Lr[i * stride + k] * acol[i];
  }
}
