/* Linear solves: Cholesky without pivoting.  These are differentiated by rule, with the factor at
 * hand, not line by line (AD.md), so they may be written for speed. */
#include <stddef.h>

#include "kernel.h"

/* lower factor of the n x n matrix at chol[adr], in place, with the inverse pivots on its diagonal; a
 * lost pivot leaves what is not finite */
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
      L[i * n + j] = s * L[j * n + j];
    }
    s = L[i * n + i];
    for (k = 0; k < i; ++k)
      s -= L[i * n + k] * L[i * n + k];
    L[i * n + i] = 1.0 / sqrt(s);
  }
}

/* one block of columns */
typedef double block[MAGGI_WIDTH];

static inline void load(const double *from, block x)
{
  int c;

#pragma omp simd
  for (c = 0; c < MAGGI_WIDTH; ++c)
    x[c] = from[c];
}

static inline void axpy(double f, const block x, block y)
{
  int c;

#pragma omp simd
  for (c = 0; c < MAGGI_WIDTH; ++c)
    y[c] += f * x[c];
}

static inline void scale(double f, block x)
{
  int c;

#pragma omp simd
  for (c = 0; c < MAGGI_WIDTH; ++c)
    x[c] *= f;
}

/* T = A^-1 T, L L^T = A */
static inline void substitute(int n, const double *L, block T[])
{
  int i, j;

  for (i = 0; i < n; ++i) {
    for (j = 0; j < i; ++j)
      axpy(-L[i * n + j], T[j], T[i]);
    scale(L[i * n + i], T[i]);
  }
  for (i = n - 1; i >= 0; --i) {
    for (j = i + 1; j < n; ++j)
      axpy(-L[j * n + i], T[j], T[i]);
    scale(L[i * n + i], T[i]);
  }
}

/* X = (Phi^T Phi)^-1 Phi^T Y with one step of iterative refinement, one block; X and T have n rows */
static inline void least_squares(int m, int n, const double *phi, const double *L, const double *Y,
                                 int stride, block X[], block T[])
{
  int i, k;
  block e;

  for (i = 0; i < n; ++i)
    for (k = 0; k < MAGGI_WIDTH; ++k)
      X[i][k] = 0.0;
  for (k = 0; k < m; ++k) {
    load(Y + k * stride, e);
    for (i = 0; i < n; ++i)
      axpy(phi[k * n + i], e, X[i]);
  }
  substitute(n, L, X);
  for (i = 0; i < n; ++i)
    for (k = 0; k < MAGGI_WIDTH; ++k)
      T[i][k] = 0.0;
  for (k = 0; k < m; ++k) {
    load(Y + k * stride, e);
    for (i = 0; i < n; ++i)
      axpy(-phi[k * n + i], X[i], e);
    for (i = 0; i < n; ++i)
      axpy(phi[k * n + i], e, T[i]);
  }
  substitute(n, L, T);
  for (i = 0; i < n; ++i)
    axpy(1.0, T[i], X[i]);
}

/* small islands with their blocks in registers */
#define SMALL(rows, n)                                                                             \
  static void least_squares_##rows##_##n(const double *phi, const double *L, const double *Y,      \
                                         int stride, block X[])                                    \
  {                                                                                                \
    block x[n], t[n];                                                                              \
    int i;                                                                                         \
                                                                                                   \
    least_squares(rows, n, phi, L, Y, stride, x, t);                                               \
    for (i = 0; i < n; ++i)                                                                        \
      load(x[i], X[i]);                                                                            \
  }
SMALL(1, 1)
SMALL(3, 2)
SMALL(3, 3)
SMALL(6, 2)

/* Columns begin..end of the rows dep[depadr..] of X; Y has m rows from yrow on; rows are `stride`
 * long and begin on a block; work holds 2 n blocks. */
void maggi_solve_island(int m, int n, int phiadr, const double phi[], int choladr,
                        const double chol[], int yrow, const double Y[], int stride, int begin,
                        int end, int depadr, const int dep[], double X[], double work[])
{
  const double *P = phi + phiadr, *L = chol + choladr, *y;
  block *x = (block *)work, *spare = x + n;
  int i, c;

  for (c = begin / MAGGI_WIDTH * MAGGI_WIDTH; c < end; c += MAGGI_WIDTH) {
    y = Y + yrow * stride + c;
    if (m == 6 && n == 2)
      least_squares_6_2(P, L, y, stride, x);
    else if (m == 3 && n == 3)
      least_squares_3_3(P, L, y, stride, x);
    else if (m == 1 && n == 1)
      least_squares_1_1(P, L, y, stride, x);
    else if (m == 3 && n == 2)
      least_squares_3_2(P, L, y, stride, x);
    else
      least_squares(m, n, P, L, y, stride, x, spare);
    for (i = 0; i < n; ++i)
      load(x[i], X + dep[depadr + i] * stride + c);
  }
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

/* Factor M^ = U^T U of the reduced mass matrix, upper half by rows.  The columns are numbered from the
 * leaves to the root, so U keeps the zeros above `first` of a column.  dinv holds the inverse pivots;
 * what lies left of the diagonal within its block has no meaning. */
void maggi_factor_mass(const maggi_topo *t, const double Mr[], double Ur[], double dinv[])
{
  int i, k, c;
  int n = t->nind, stride = t->stride;
  double f;
  double *u;

  for (i = 0; i < n; ++i)
    for (c = i / MAGGI_WIDTH * MAGGI_WIDTH; c < n; c += MAGGI_WIDTH)
      load(Mr + i * stride + c, Ur + i * stride + c);
  for (k = 0; k < n; ++k) {
    u = Ur + k * stride;
    dinv[k] = 1.0 / sqrt(u[k]);
    for (c = k / MAGGI_WIDTH * MAGGI_WIDTH; c < n; c += MAGGI_WIDTH)
      scale(dinv[k], u + c);
    for (i = k + 1; i < n; ++i) {
      if (t->first[i] > k)
        continue;
      f = -u[i];
      for (c = i / MAGGI_WIDTH * MAGGI_WIDTH; c < n; c += MAGGI_WIDTH)
        axpy(f, u + c, Ur + i * stride + c);
    }
  }
}

/* M_ii a_i = f_i - M_ig a_g; acol holds a_g on entry and all accelerations of columns on return */
void maggi_solve_mass(const maggi_topo *t, const double Mr[], const double fr[], const double Ur[],
                      const double dinv[], double acol[])
{
  int i, k;
  int n = t->nind, stride = t->stride;
  double f;

  for (i = 0; i < n; ++i)
    acol[i] = fr[i];
  for (i = 0; i < n; ++i)
    for (k = n; k < t->ncol; ++k)
      acol[i] -= Mr[i * stride + k] * acol[k];
  for (k = 0; k < n; ++k) {
    f = acol[k] * dinv[k];
    acol[k] = f;
#pragma omp simd
    for (i = k + 1; i < n; ++i)
      acol[i] -= Ur[k * stride + i] * f;
  }
  for (k = n - 1; k >= 0; --k)
    acol[k] = (acol[k] - dot_rows(k + 1, n, Ur + k * stride, acol)) * dinv[k];
}
