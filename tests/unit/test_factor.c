/* core/implicit/factor.c: solutions, plain and transposed, of random matrices, small and large; the
 * same matrix as a block of a larger one, so that dense and sparse elimination must agree; new
 * values, after which pivots must be others; singular ones. */
#include "factor.h"
#include "fixture.h"

enum { N_MAX = 120, COLUMNS = 5 };

typedef struct matrix {
  maggi_sparsity a;
  int coladr[N_MAX + 1], row[N_MAX * N_MAX];
  double value[N_MAX * N_MAX];
} matrix;

static matrix A, B;

static void begin(matrix *m, int n)
{
  m->a = (maggi_sparsity){n, n, m->coladr, m->row};
  m->coladr[0] = 0;
}

/* about `degree` entries in a column, and the diagonal */
static void scatter(matrix *m, int n, double degree, unsigned long long *seed)
{
  int i, j, k = 0;

  begin(m, n);
  for (j = 0; j < n; ++j) {
    for (i = 0; i < n; ++i)
      if (i == j || random01(seed) * n < degree) m->row[k++] = i;
    m->coladr[j + 1] = k;
  }
}

static void fill(matrix *m, double diagonal, unsigned long long *seed)
{
  int j, k;

  for (j = 0; j < m->a.ncol; ++j)
    for (k = m->coladr[j]; k < m->coladr[j + 1]; ++k)
      m->value[k] = random11(seed) + (m->row[k] == j ? diagonal : 0.0);
}

/* y = A x or A^T x */
static void multiply(const matrix *m, int is_transposed, const double *x, double *y)
{
  int j, k;

  memset(y, 0, (size_t)m->a.ncol * sizeof *y);
  for (j = 0; j < m->a.ncol; ++j)
    for (k = m->coladr[j]; k < m->coladr[j + 1]; ++k)
      if (is_transposed)
        y[j] += m->value[k] * x[m->row[k]];
      else
        y[m->row[k]] += m->value[k] * x[j];
}

static maggi_factor *create(const matrix *m)
{
  maggi_factor *f = NULL;

  if (!CHECK(maggi_factor_create(&m->a, &f) == MAGGI_OK)) exit(1);
  return f;
}

/* several columns at once, x from A x and A^T x; `limit` grows with the condition of A */
static void check_solutions(const maggi_factor *f, const matrix *m, double limit)
{
  static double x[N_MAX * COLUMNS], y[N_MAX * COLUMNS];
  unsigned long long seed = 5;
  int n = m->a.ncol, c, i, way;

  for (way = 0; way < 2; ++way) {
    for (c = 0; c < COLUMNS; ++c) {
      for (i = 0; i < n; ++i) x[c * n + i] = random11(&seed);
      multiply(m, way, x + c * n, y + c * n);
    }
    if (way)
      maggi_factor_solve_transposed(f, COLUMNS, y);
    else
      maggi_factor_solve(f, COLUMNS, y);
    for (i = 0; i < COLUMNS * n; ++i) CHECK_NEAR(y[i], x[i], 0.0, limit);
  }
}

static void test_random(void)
{
  static const int size[] = {0, 1, 2, 3, 5, 12, 23, 24, 25, 40, 77, N_MAX};
  unsigned long long seed = 1;
  maggi_factor *f;
  int i, pass;

  for (i = 0; i < (int)(sizeof size / sizeof *size); ++i) {
    scatter(&A, size[i], 4.0, &seed);
    f = create(&A);
    for (pass = 0; pass < 4; ++pass) {
      fill(&A, 6.0, &seed);
      CHECK(maggi_factor_compute(f, A.value));
      check_solutions(f, &A, 1e-13);
    }
    maggi_factor_free(f);
  }
  maggi_factor_free(NULL);
}

/* A, eliminated dense, and a matrix of diagonal blocks A, 2 A, 3 A, which is too sparse for that */
static void test_both_ways(void)
{
  double x[8], y[N_MAX];
  unsigned long long seed = 2;
  maggi_factor *f, *g;
  int pass, i, j, k, n = 8;

  for (pass = 0; pass < 10; ++pass) {
    scatter(&A, n, 3.0, &seed);
    fill(&A, 2.0, &seed);
    begin(&B, 3 * n);
    for (i = k = 0; i < 3; ++i) {
      for (j = 0; j < n; ++j) {
        for (; k < A.coladr[j + 1] + i * A.coladr[n]; ++k) {
          B.row[k] = A.row[k - i * A.coladr[n]] + i * n;
          B.value[k] = A.value[k - i * A.coladr[n]] * (i + 1);
        }
        B.coladr[i * n + j + 1] = k;
      }
    }
    f = create(&A);
    g = create(&B);
    CHECK(maggi_factor_compute(f, A.value) && maggi_factor_compute(g, B.value));
    for (j = 0; j < 2; ++j) {
      for (i = 0; i < n; ++i) x[i] = y[i] = y[i + n] = y[i + 2 * n] = random11(&seed);
      if (j) {
        maggi_factor_solve_transposed(f, 1, x);
        maggi_factor_solve_transposed(g, 1, y);
      } else {
        maggi_factor_solve(f, 1, x);
        maggi_factor_solve(g, 1, y);
      }
      for (i = 0; i < 3 * n; ++i) CHECK_NEAR(y[i] * (i / n + 1), x[i % n], 1e-11, 1e-11);
    }
    maggi_factor_free(f);
    maggi_factor_free(g);
  }
}

/* values whose pivots on the diagonal are small or zero after others for which they were the
 * best */
static void check_pivots(int n)
{
  unsigned long long seed = 3;
  maggi_factor *f;
  double small;
  int j, k;

  begin(&A, n);
  for (j = k = 0; j < n; ++j) { /* diagonal and both neighbours, in a ring */
    for (int i = 0; i < n; ++i)
      if (i == j || (i + 1) % n == j || (j + 1) % n == i) A.row[k++] = i;
    A.coladr[j + 1] = k;
  }
  f = create(&A);
  for (small = 1.0; small > 1e-30; small *= 1e-3) {
    fill(&A, 10.0, &seed);
    CHECK(maggi_factor_compute(f, A.value));
    check_solutions(f, &A, 1e-13);
    for (j = 0; j < n; ++j) /* a cyclic shift, with a small rest */
      for (k = A.coladr[j]; k < A.coladr[j + 1]; ++k)
        A.value[k] =
            (A.row[k] + 1) % n == j ? 1.0 + 0.1 * random11(&seed) : small * random11(&seed);
    CHECK(maggi_factor_compute(f, A.value));
    if (small < 1e-2) check_solutions(f, &A, 1e-12);
  }
  maggi_factor_free(f);
}

/* a row, a column of zeros; matrices that are not singular go on afterwards */
static void check_singular(int n)
{
  unsigned long long seed = 4;
  maggi_factor *f;
  int j, k;

  scatter(&A, n, n, &seed);
  f = create(&A);
  fill(&A, 3.0, &seed);
  for (j = 0; j < n; ++j)
    for (k = A.coladr[j]; k < A.coladr[j + 1]; ++k)
      if (A.row[k] == n / 2) A.value[k] = 0.0;
  CHECK(!maggi_factor_compute(f, A.value));
  fill(&A, 2.0 * n, &seed);
  CHECK(maggi_factor_compute(f, A.value));
  check_solutions(f, &A, 1e-13);
  for (j = 0; j < n; ++j) {
    for (k = A.coladr[j]; k < A.coladr[j + 1]; ++k) A.value[k] = j == n - 1 ? 0.0 : random11(&seed);
  }
  CHECK(!maggi_factor_compute(f, A.value));
  fill(&A, 2.0 * n, &seed);
  CHECK(maggi_factor_compute(f, A.value));
  check_solutions(f, &A, 1e-13);
  maggi_factor_free(f);
}

int main(void)
{
  test_random();
  test_both_ways();
  check_pivots(7);
  check_pivots(23);
  check_pivots(60);
  check_singular(2);
  check_singular(11);
  check_singular(40);
  return check_done();
}
