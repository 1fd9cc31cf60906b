/* P S A = L U, S the scales of rows, P their order.
 *
 * Columns are scaled too when it is told whether A is singular: a pivot is compared with the largest
 * entry that its column had in S A. */
#include "dense.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* pivots of a regular matrix are larger, relative to their column */
static const double singular_below = 1e-12;

int maggi_dense_create(maggi_dense *f, int n)
{
  size_t m = (size_t)n + 1;

  f->n = 0;
  f->lu = calloc(m * m, sizeof(double));
  f->scale = calloc(m, sizeof(double));
  f->work = calloc(m, sizeof(double));
  f->row = calloc(m, sizeof(int));
  return f->lu && f->scale && f->work && f->row;
}

void maggi_dense_free(maggi_dense *f)
{
  free(f->lu);
  free(f->scale);
  free(f->work);
  free(f->row);
}

/* scaled copy; rows of zeros stay */
static void load(maggi_dense *f, const double *a)
{
  double largest;
  int i, k, n = f->n;

  for (i = 0; i < n; ++i) {
    largest = 0.0;
    for (k = 0; k < n; ++k) largest = fmax(largest, fabs(a[i * n + k]));
    f->scale[i] = largest > 0.0 ? 1.0 / largest : 1.0;
    f->row[i] = i;
    for (k = 0; k < n; ++k) f->lu[i * n + k] = f->scale[i] * a[i * n + k];
  }
}

static void swap(maggi_dense *f, int i, int j)
{
  int k, row = f->row[i];
  double x;

  f->row[i] = f->row[j];
  f->row[j] = row;
  for (k = 0; k < f->n; ++k) {
    x = f->lu[i * f->n + k];
    f->lu[i * f->n + k] = f->lu[j * f->n + k];
    f->lu[j * f->n + k] = x;
  }
}

/* x with U x = 0, from the columns before c, which has no pivot */
static void find_null(maggi_dense *f, int c)
{
  double *x = f->work;
  int i, k, n = f->n;

  for (i = 0; i < n; ++i) x[i] = i == c ? 1.0 : 0.0;
  for (i = c - 1; i >= 0; --i) {
    for (k = i + 1; k <= c; ++k) x[i] -= f->lu[i * n + k] * x[k];
    x[i] /= f->lu[i * n + i];
  }
}

int maggi_dense_factor(maggi_dense *f, int n, const double *a)
{
  double *u = f->lu, column, factor;
  int i, j, k, at;

  f->n = n;
  load(f, a);
  for (j = 0; j < n; ++j) {
    column = 0.0;
    for (i = 0; i < n; ++i) column = fmax(column, fabs(f->scale[i] * a[i * n + j]));
    at = j;
    for (i = j + 1; i < n; ++i)
      if (fabs(u[i * n + j]) > fabs(u[at * n + j])) at = i;
    if (!(fabs(u[at * n + j]) > singular_below * column)) {
      find_null(f, j);
      return 0;
    }
    if (at != j) swap(f, at, j);
    for (i = j + 1; i < n; ++i) {
      factor = u[i * n + j] / u[j * n + j];
      u[i * n + j] = factor;
      for (k = j + 1; k < n && factor != 0.0; ++k) u[i * n + k] -= factor * u[j * n + k];
    }
  }
  return 1;
}

void maggi_dense_solve(const maggi_dense *f, double *x)
{
  const double *u = f->lu;
  double *y = f->work;
  int i, k, n = f->n;

  for (i = 0; i < n; ++i) {
    y[i] = f->scale[f->row[i]] * x[f->row[i]];
    for (k = 0; k < i; ++k) y[i] -= u[i * n + k] * y[k];
  }
  for (i = n - 1; i >= 0; --i) {
    x[i] = y[i];
    for (k = i + 1; k < n; ++k) x[i] -= u[i * n + k] * x[k];
    x[i] /= u[i * n + i];
  }
}

void maggi_dense_solve_transposed(const maggi_dense *f, double *x)
{
  const double *u = f->lu;
  double *y = f->work;
  int i, k, n = f->n;

  for (i = 0; i < n; ++i) {
    y[i] = x[i];
    for (k = 0; k < i; ++k) y[i] -= u[k * n + i] * y[k];
    y[i] /= u[i * n + i];
  }
  for (i = n - 1; i >= 0; --i)
    for (k = i + 1; k < n; ++k) y[i] -= u[k * n + i] * y[k];
  for (i = 0; i < n; ++i) x[f->row[i]] = f->scale[f->row[i]] * y[i];
}
