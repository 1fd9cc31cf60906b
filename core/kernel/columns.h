/* Rows of `width` numbers, one column each: a block of columns, or one.  For what is differentiated by
 * rule: with a constant width, and the size of a small system, all of it stays in registers. */
#ifndef MAGGI_COLUMNS_H
#define MAGGI_COLUMNS_H

#include "kernel.h"

/* sizes must be constants where these are used */
#if defined(__GNUC__)
#define ALWAYS_INLINE static inline __attribute__((always_inline))
#else
#define ALWAYS_INLINE static inline
#endif

ALWAYS_INLINE void load(int width, const double *from, double *x)
{
  int c;

#pragma omp simd
  for (c = 0; c < width; ++c) x[c] = from[c];
}

ALWAYS_INLINE void axpy(int width, double f, const double *x, double *y)
{
  int c;

#pragma omp simd
  for (c = 0; c < width; ++c) y[c] += f * x[c];
}

ALWAYS_INLINE void scale(int width, double f, double *x)
{
  int c;

#pragma omp simd
  for (c = 0; c < width; ++c) x[c] *= f;
}

ALWAYS_INLINE void clear(int n, double *x)
{
  int i;

  for (i = 0; i < n; ++i) x[i] = 0.0;
}

/* T = A^-1 T, L L^T = A, n rows; the diagonal of L holds inverse pivots */
ALWAYS_INLINE void substitute(int n, int width, const double *L, double *T)
{
  int i, j;

  for (i = 0; i < n; ++i) {
    for (j = 0; j < i; ++j) axpy(width, -L[i * n + j], T + j * width, T + i * width);
    scale(width, L[i * n + i], T + i * width);
  }
  for (i = n - 1; i >= 0; --i) {
    for (j = i + 1; j < n; ++j) axpy(width, -L[j * n + i], T + j * width, T + i * width);
    scale(width, L[i * n + i], T + i * width);
  }
}

/* whether the pivots of A differ by so much that one step of iterative refinement pays: normal
 * equations square the condition number */
ALWAYS_INLINE int has_small_pivots(int n, const double *L)
{
  int i;
  double least = L[0], most = L[0];

  for (i = 1; i < n; ++i) {
    least = MAGGI_RE(L[i * n + i]) < MAGGI_RE(least) ? L[i * n + i] : least;
    most = MAGGI_RE(L[i * n + i]) > MAGGI_RE(most) ? L[i * n + i] : most;
  }
  return !(MAGGI_RE(most) < 16.0 * MAGGI_RE(least));
}

#endif
