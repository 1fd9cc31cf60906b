/* Linear solves: Cholesky without pivoting.  These are differentiated by rule, with the factor at
 * hand, not line by line (AD.md), so they may be written for speed. */
#include "columns.h"
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
      for (k = 0; k < j; ++k) s -= L[i * n + k] * L[j * n + k];
      L[i * n + j] = s * L[j * n + j];
    }
    s = L[i * n + i];
    for (k = 0; k < i; ++k) s -= L[i * n + k] * L[i * n + k];
    L[i * n + i] = 1.0 / sqrt(s);
  }
}

/* Velocities always need refinement: their error makes positions drift, and what is open of a loop is
 * magnified at singular positions.  A single column (accelerations, corrections) does not while the
 * pivots are alike. */
ALWAYS_INLINE int needs_refinement(int n, int width, const double *L)
{
  return width > 1 || has_small_pivots(n, L);
}

/* X = (Phi^T Phi)^-1 Phi^T Y; X and T have n rows */
ALWAYS_INLINE void least_squares(int m, int n, int width, const double *phi, const double *L,
                                 const double *Y, int stride, double *X, double *T)
{
  int i, k;
  double e[MAGGI_WIDTH];

  clear(n * width, X);
  for (k = 0; k < m; ++k) {
    load(width, Y + k * stride, e);
    for (i = 0; i < n; ++i) axpy(width, phi[k * n + i], e, X + i * width);
  }
  substitute(n, width, L, X);
  if (!needs_refinement(n, width, L)) return;
  clear(n * width, T);
  for (k = 0; k < m; ++k) {
    load(width, Y + k * stride, e);
    for (i = 0; i < n; ++i) axpy(width, -phi[k * n + i], X + i * width, e);
    for (i = 0; i < n; ++i) axpy(width, phi[k * n + i], e, T + i * width);
  }
  substitute(n, width, L, T);
  for (i = 0; i < n; ++i) axpy(width, 1.0, T + i * width, X + i * width);
}

enum { SMALL = 3 };

/* an island of at most SMALL dependents; m and n are constants of the caller, so that all of it stays
 * in registers */
ALWAYS_INLINE void solve_small(int m, int n, int width, const double *phi, const double *L,
                               const double *Y, int stride, const int *dep, double *X)
{
  double x[SMALL * MAGGI_WIDTH], t[SMALL * MAGGI_WIDTH];
  int i;

  least_squares(m, n, width, phi, L, Y, stride, x, t);
  for (i = 0; i < n; ++i) load(width, x + i * width, X + dep[i] * stride);
}

ALWAYS_INLINE void solve(int m, int n, int width, const double *phi, const double *L,
                         const double *Y, int stride, const int *dep, double *X, double *work)
{
  int k;

  if (m == 6 && n == 2) {
    solve_small(6, 2, width, phi, L, Y, stride, dep, X);
  } else if (m == 3 && n == 3) {
    solve_small(3, 3, width, phi, L, Y, stride, dep, X);
  } else if (m == 1 && n == 1) {
    solve_small(1, 1, width, phi, L, Y, stride, dep, X);
  } else if (m == 3 && n == 2) {
    solve_small(3, 2, width, phi, L, Y, stride, dep, X);
  } else {
    least_squares(m, n, width, phi, L, Y, stride, work, work + n * width);
    for (k = 0; k < n; ++k) load(width, work + k * width, X + dep[k] * stride);
  }
}

/* Columns begin..end of the rows dep[depadr..] of X; Y has m rows from yrow on; rows are `stride`
 * long and begin on a block; work holds 2 n blocks. */
void maggi_solve_columns(int m, int n, int phiadr, const double phi[], int choladr,
                         const double chol[], int yrow, const double Y[], int stride, int begin,
                         int end, int depadr, const int dep[], double X[], double work[])
{
  int c;

  for (c = begin / MAGGI_WIDTH * MAGGI_WIDTH; c < end; c += MAGGI_WIDTH)
    solve(m, n, MAGGI_WIDTH, phi + phiadr, chol + choladr, Y + yrow * stride + c, stride,
          dep + depadr, X + c, work);
}

/* the same for one column without room between its rows */
void maggi_solve_vector(int m, int n, int phiadr, const double phi[], int choladr,
                        const double chol[], int yrow, const double y[], int depadr,
                        const int dep[], double x[], double work[])
{
  solve(m, n, 1, phi + phiadr, chol + choladr, y + yrow, 1, dep + depadr, x, work);
}

ALWAYS_INLINE double dot_rows(int begin, int end, const double *a, const double *b)
{
  int k;
  double s = 0.0;

#pragma omp simd reduction(+ : s)
  for (k = begin; k < end; ++k) s += a[k] * b[k];
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
      load(MAGGI_WIDTH, Mr + i * stride + c, Ur + i * stride + c);
  for (k = 0; k < n; ++k) {
    u = Ur + k * stride;
    dinv[k] = 1.0 / sqrt(u[k]);
    for (c = k / MAGGI_WIDTH * MAGGI_WIDTH; c < n; c += MAGGI_WIDTH)
      scale(MAGGI_WIDTH, dinv[k], u + c);
    for (i = k + 1; i < n; ++i) {
      if (t->first[i] > k) continue;
      f = -u[i];
      for (c = i / MAGGI_WIDTH * MAGGI_WIDTH; c < n; c += MAGGI_WIDTH)
        axpy(MAGGI_WIDTH, f, u + c, Ur + i * stride + c);
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

  for (i = 0; i < n; ++i) acol[i] = fr[i];
  for (i = 0; i < n; ++i)
    for (k = n; k < t->ncol; ++k) acol[i] -= Mr[i * stride + k] * acol[k];
  for (k = 0; k < n; ++k) {
    f = acol[k] * dinv[k];
    acol[k] = f;
#pragma omp simd
    for (i = k + 1; i < n; ++i) acol[i] -= Ur[k * stride + i] * f;
  }
  for (k = n - 1; k >= 0; --k)
    acol[k] = (acol[k] - dot_rows(k + 1, n, Ur + k * stride, acol)) * dinv[k];
}
