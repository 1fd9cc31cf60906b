/* core/kernel/solve.c: factors and solutions against dense ones in long double. */
#include "fixture.h"
#include "kernel.h"

enum { N = 40, M = 60, COLUMNS = 30 };

typedef long double real;

/* x = argmin |A x - b| by Householder reflections, A m x n of full rank */
static void least_squares(int m, int n, const double *a, const double *b, int stride, real *x)
{
  static real A[M][N], y[M];
  real s, beta, f;
  int i, j, k;

  for (i = 0; i < m; ++i) {
    y[i] = b[i * stride];
    for (j = 0; j < n; ++j) A[i][j] = a[i * n + j];
  }
  for (k = 0; k < n; ++k) {
    s = 0.0L;
    for (i = k; i < m; ++i) s += A[i][k] * A[i][k];
    s = A[k][k] > 0.0L ? -sqrtl(s) : sqrtl(s);
    beta = s * (s - A[k][k]); /* half of |v|^2, v = column - s e_k */
    A[k][k] -= s;
    for (j = k + 1; j <= n; ++j) {
      f = 0.0L;
      for (i = k; i < m; ++i) f += A[i][k] * (j < n ? A[i][j] : y[i]);
      f /= beta;
      for (i = k; i < m; ++i) *(j < n ? &A[i][j] : &y[i]) -= f * A[i][k];
    }
    x[k] = s; /* diagonal of R */
  }
  for (k = n - 1; k >= 0; --k) {
    s = y[k];
    for (j = k + 1; j < n; ++j) s -= A[k][j] * x[j];
    x[k] = s / x[k];
  }
}

static void fill(double *a, int n, unsigned long long *seed)
{
  int i;

  for (i = 0; i < n; ++i) a[i] = random11(seed);
}

/* L L^T = A with L in the lower half, its diagonal inverted; what lies above is not touched */
static void test_cholesky(int n)
{
  double B[N * N], A[N * N], L[N * N + 3], s;
  unsigned long long seed = 3 + (unsigned)n;
  int i, j, k;

  fill(B, n * n, &seed);
  for (i = 0; i < n; ++i)
    for (j = 0; j < n; ++j) {
      A[i * n + j] = i == j ? 0.1 : 0.0;
      for (k = 0; k < n; ++k) A[i * n + j] += B[i * n + k] * B[j * n + k];
      L[3 + i * n + j] = j <= i ? A[i * n + j] : NAN;
    }
  maggi_cholesky_island(n, 3, L);
  for (i = 0; i < n; ++i)
    for (j = 0; j <= i; ++j) {
      s = 0.0;
      for (k = 0; k < j; ++k) s += L[3 + i * n + k] * L[3 + j * n + k];
      if (j < i)
        s += L[3 + i * n + j] / L[3 + j * n + j];
      else
        s += 1.0 / (L[3 + i * n + i] * L[3 + i * n + i]);
      CHECK_NEAR(s, A[i * n + j], 0.0, 2e-15 * n);
    }
}

/* An island of m rows and n dependents, columns begin..end of `stride`, zero outside; the last
 * rows repeat combinations of the others, as redundant equations do.  Columns of Phi are scaled,
 * and two of them nearly parallel, so that its condition is a few times `condition`: the refined
 * normal equations must not square that. */
static void test_island(int m, int n, int stride, int begin, int end, double condition,
                        double limit)
{
  static double phi[M * N + 5], chol[N * N + 7], Y[(M + 2) * COLUMNS], X[2 * N * COLUMNS];
  static double work[2 * N * MAGGI_WIDTH], y[M + 2], x1[2 * N], x0[N * COLUMNS];
  real x[N];
  int dep[N + 1], i, j, k, c;
  unsigned long long seed = (unsigned)(m + 10 * n + 100 * stride);

  for (i = 0; i < m; ++i)
    for (j = 0; j < n; ++j)
      phi[5 + i * n + j] =
          i < m - 2 || m < n + 2 ? random11(&seed) : phi[5 + j] - 0.5 * phi[5 + n + j];
  for (i = 0; n > 1 && i < m; ++i)
    phi[5 + i * n + n - 1] = phi[5 + i * n] + phi[5 + i * n + n - 1] / condition;
  for (i = 0; i < n; ++i) {
    dep[i + 1] = 2 * n - 1 - 2 * i; /* rows of X in another order, with gaps */
    for (j = 0; j <= i; ++j) {
      chol[7 + i * n + j] = 0.0;
      for (k = 0; k < m; ++k) chol[7 + i * n + j] += phi[5 + k * n + i] * phi[5 + k * n + j];
    }
  }
  maggi_cholesky_island(n, 7, chol);
  /* right-hand sides that the columns of Phi reach, as those of a mechanism */
  fill(x0, n * stride, &seed);
  for (i = 0; i < 2 * n; ++i)
    for (c = 0; c < stride; ++c) X[i * stride + c] = i % 2 ? 0.0 : NAN;
  memset(Y, 0, sizeof Y);
  for (k = 0; k < m; ++k)
    for (c = begin; c < end; ++c) {
      Y[(2 + k) * stride + c] = 0.0;
      for (j = 0; j < n; ++j) Y[(2 + k) * stride + c] += phi[5 + k * n + j] * x0[j * stride + c];
    }
  maggi_solve_columns(m, n, 5, phi, 7, chol, 2, Y, stride, begin, end, 1, dep, X, work);
  for (c = 0; c < stride; ++c) {
    if (c < begin || c >= end) {
      for (i = 0; i < n; ++i) CHECK(X[dep[i + 1] * stride + c] == 0.0);
      continue;
    }
    least_squares(m, n, phi + 5, Y + 2 * stride + c, stride, x);
    for (i = 0; i < n; ++i) CHECK_NEAR(X[dep[i + 1] * stride + c], (double)x[i], 0.0, limit);
  }
  /* one column alone */
  for (c = begin; c < end; ++c) {
    for (k = 0; k < m + 2; ++k) y[k] = Y[k * stride + c];
    maggi_solve_vector(m, n, 5, phi, 7, chol, 2, y, 1, dep, x1, work);
    for (i = 0; i < n; ++i) CHECK_NEAR(x1[dep[i + 1]], X[dep[i + 1] * stride + c], 0.0, limit);
  }
  for (i = 0; i < n; ++i) /* the rows between are not touched */
    for (c = 0; c < stride; ++c) CHECK(isnan(X[2 * i * stride + c]));
}

/* An envelope: row i begins at first[i].  Rows and columns nind..ncol belong to guided
 * coordinates. */
static void test_mass(int nind, int nguide, unsigned long long seed)
{
  static double Mr[N * N], Lr[N * N], A[N * N], b[N];
  double fr[N], acol[N], dinv[N], s;
  real x[N];
  maggi_topo t;
  int first[N], i, j, n = nind + nguide, stride = (n + 7) / 8 * 8;

  memset(&t, 0, sizeof t);
  t.nind = nind;
  t.ncol = n;
  t.nq = n;
  t.stride = stride;
  t.first = first;
  memset(Mr, 0, sizeof Mr);
  memset(Lr, 0, sizeof Lr);
  memset(A, 0, sizeof A);
  for (i = 0; i < n; ++i) {
    first[i] = (int)(random01(&seed) * (i + 1));
    for (j = first[i]; j <= i; ++j) {
      Mr[i * stride + j] = Mr[j * stride + i] = i == j ? n : random11(&seed);
      if (i < nind) A[i * nind + j] = A[j * nind + i] = Mr[i * stride + j];
    }
    fr[i] = random11(&seed);
    acol[i] = i < nind ? NAN : random11(&seed);
  }
  for (i = 0; i < nind; ++i) {
    s = fr[i];
    for (j = nind; j < n; ++j)
      if (i >= first[j]) s -= Mr[j * stride + i] * acol[j];
    b[i] = s;
  }
  maggi_factor_mass(&t, Mr, Lr, dinv);
  maggi_solve_mass(&t, Mr, fr, Lr, dinv, acol);
  least_squares(nind, nind, A, b, 1, x);
  for (i = 0; i < nind; ++i) CHECK_NEAR(acol[i], (double)x[i], 1e-14, 1e-15);
}

int main(void)
{
  int n, extra;

  for (n = 1; n <= N; ++n) test_cholesky(n);
  for (n = 1; n <= 20; ++n)
    for (extra = 0; extra < 5; ++extra) {
      test_island(n + extra, n, 16, 0, 16, 1.0, 1e-10);
      test_island(n + extra, n, 24, 3, 22, 1.0, 1e-10);
      test_island(n + extra, n, 8, 0, 1, 1.0, 1e-10);
    }
  test_island(6, 2, 8, 2, 2, 1.0, 0.0); /* no column at all */
  /* eps K + (eps K^2)^2, K = 3 condition: with one refinement the square of the condition K enters
   * squared itself, so up to 1e4 the error is that of orthogonal methods */
  test_island(12, 6, 16, 0, 11, 1e2, 1e-13);
  test_island(12, 6, 16, 0, 11, 1e4, 1e-11);
  test_island(12, 6, 16, 0, 11, 1e6, 4e-6);
  for (n = 1; n <= 30; ++n) {
    test_mass(n, 0, 5 + (unsigned)n);
    test_mass(n, n % 7, 50 + (unsigned)n);
  }
  return check_done();
}
