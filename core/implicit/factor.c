#include "factor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#ifdef MAGGI_WITH_KLU
#include <klu.h>

#endif

/* Dense elimination is faster with so few unknowns, or where sparse elimination does more than this share of
 * its operations: make bench-derivatives */
enum { DENSE_UNKNOWNS = 8 };
#define DENSE_SHARE 0.2

/* a factorisation that repeats the pivots of another one must not lose more */
#define WORST_PIVOT 1e-13

struct maggi_factor {
  const maggi_sparsity *a;
  int n;
  double *dense; /* (n x n) rows; NULL: KLU */
  int *pivot;    /* (n) row that was exchanged */
#ifdef MAGGI_WITH_KLU
  klu_common common;
  klu_symbolic *symbolic;
  klu_numeric *numeric;
#endif
};

/* --------------------------------------------------------------------------------------- dense */

/* largest entry of column k from the diagonal on */
static int find_pivot(const maggi_factor *f, int k)
{
  int i, best = k;

  for (i = k + 1; i < f->n; ++i)
    if (fabs(f->dense[i * f->n + k]) > fabs(f->dense[best * f->n + k])) best = i;
  return best;
}

static void exchange(maggi_factor *f, int i, int k)
{
  double x;
  int j;

  for (j = 0; j < f->n && i != k; ++j) {
    x = f->dense[i * f->n + j];
    f->dense[i * f->n + j] = f->dense[k * f->n + j];
    f->dense[k * f->n + j] = x;
  }
}

static int eliminate(maggi_factor *f)
{
  double *a = f->dense, g;
  int i, j, k, n = f->n;

  for (k = 0; k < n; ++k) {
    f->pivot[k] = find_pivot(f, k);
    exchange(f, f->pivot[k], k);
    if (!(fabs(a[k * n + k]) > 0.0)) return 0;
    for (i = k + 1; i < n; ++i) {
      g = a[i * n + k] /= a[k * n + k];
      if (g == 0.0) continue;
      for (j = k + 1; j < n; ++j) a[i * n + j] -= g * a[k * n + j];
    }
  }
  return 1;
}

static int compute_dense(maggi_factor *f, const double *value)
{
  const maggi_sparsity *a = f->a;
  int j, k;

  memset(f->dense, 0, (size_t)f->n * (size_t)f->n * sizeof(double));
  for (j = 0; j < f->n; ++j)
    for (k = a->coladr[j]; k < a->coladr[j + 1]; ++k) f->dense[a->row[k] * f->n + j] = value[k];
  return eliminate(f);
}

static void swap(double *x, int i, int k)
{
  double y = x[i];

  x[i] = x[k];
  x[k] = y;
}

static void solve_dense(const maggi_factor *f, double *x)
{
  const double *a = f->dense;
  int i, k, n = f->n;

  for (k = 0; k < n; ++k) swap(x, k, f->pivot[k]);
  for (i = 0; i < n; ++i)
    for (k = 0; k < i; ++k) x[i] -= a[i * n + k] * x[k];
  for (i = n - 1; i >= 0; --i) {
    for (k = i + 1; k < n; ++k) x[i] -= a[i * n + k] * x[k];
    x[i] /= a[i * n + i];
  }
}

static void solve_dense_transposed(const maggi_factor *f, double *x)
{
  const double *a = f->dense;
  int i, k, n = f->n;

  for (i = 0; i < n; ++i) {
    x[i] /= a[i * n + i];
    for (k = i + 1; k < n; ++k) x[k] -= a[i * n + k] * x[i];
  }
  for (i = n - 1; i >= 0; --i)
    for (k = 0; k < i; ++k) x[k] -= a[i * n + k] * x[i];
  for (k = n - 1; k >= 0; --k) swap(x, k, f->pivot[k]);
}

/* ---------------------------------------------------------------------------------------- KLU */

#ifdef MAGGI_WITH_KLU

static int analyse(maggi_factor *f)
{
  klu_defaults(&f->common);
  f->symbolic = klu_analyze(f->n, f->a->coladr, f->a->row, &f->common);
  return f->symbolic != NULL;
}

static int is_sparse_faster(const maggi_factor *f)
{
  double n = f->n;

  return f->symbolic->est_flops < DENSE_SHARE * 2.0 / 3.0 * n * n * n;
}

static void free_sparse(maggi_factor *f)
{
  if (f->numeric) klu_free_numeric(&f->numeric, &f->common);
  if (f->symbolic) klu_free_symbolic(&f->symbolic, &f->common);
}

/* KLU does not change the values */
static int compute_sparse(maggi_factor *f, const double *value)
{
  int *coladr = f->a->coladr, *row = f->a->row;
  double *x = (double *)value;

  if (f->numeric && klu_refactor(coladr, row, x, f->symbolic, f->numeric, &f->common) &&
      klu_rcond(f->symbolic, f->numeric, &f->common) && f->common.rcond > WORST_PIVOT)
    return 1;
  if (f->numeric) klu_free_numeric(&f->numeric, &f->common);
  f->numeric = klu_factor(coladr, row, x, f->symbolic, &f->common);
  return f->numeric != NULL;
}

static void solve_sparse(const maggi_factor *f, int n, double *x, int is_transposed)
{
  klu_common common = f->common; /* only its statistics change */

  if (is_transposed)
    klu_tsolve(f->symbolic, f->numeric, f->n, n, x, &common);
  else
    klu_solve(f->symbolic, f->numeric, f->n, n, x, &common);
}

#else

static int analyse(maggi_factor *f)
{
  (void)f;
  return 0;
}

static int is_sparse_faster(const maggi_factor *f)
{
  (void)f;
  return 0;
}

static void free_sparse(maggi_factor *f)
{
  (void)f;
}

static int compute_sparse(maggi_factor *f, const double *value)
{
  (void)f, (void)value;
  return 0;
}

static void solve_sparse(const maggi_factor *f, int n, double *x, int is_transposed)
{
  (void)f, (void)n, (void)x, (void)is_transposed;
}

#endif

/* -------------------------------------------------------------------------------------- factor */

maggi_status maggi_factor_create(const maggi_sparsity *a, maggi_factor **factor)
{
  maggi_factor *f = calloc(1, sizeof *f);
  size_t n = (size_t)a->ncol;
  int ok = 1;

  *factor = NULL;
  if (!f) return MAGGI_E_MEMORY;
  f->a = a;
  f->n = a->ncol;
  if (f->n <= DENSE_UNKNOWNS || !analyse(f) || !is_sparse_faster(f)) {
    free_sparse(f);
    f->dense = malloc(n * n * sizeof(double) + 1);
    f->pivot = malloc(n * sizeof(int) + 1);
    ok = f->dense && f->pivot;
  }
  if (!ok) {
    maggi_factor_free(f);
    return MAGGI_E_MEMORY;
  }
  *factor = f;
  return MAGGI_OK;
}

void maggi_factor_free(maggi_factor *f)
{
  if (!f) return;
  free_sparse(f);
  free(f->dense);
  free(f->pivot);
  free(f);
}

int maggi_factor_compute(maggi_factor *f, const double *value)
{
  return f->dense ? compute_dense(f, value) : compute_sparse(f, value);
}

void maggi_factor_solve(const maggi_factor *f, int n, double *x)
{
  int i;

  if (!f->dense) solve_sparse(f, n, x, 0);
  for (i = 0; i < n && f->dense; ++i) solve_dense(f, x + i * f->n);
}

void maggi_factor_solve_transposed(const maggi_factor *f, int n, double *x)
{
  int i;

  if (!f->dense) solve_sparse(f, n, x, 1);
  for (i = 0; i < n && f->dense; ++i) solve_dense_transposed(f, x + i * f->n);
}
