/* The equations of one island, in columns: for one vector, or for a strip of directions. */
#ifndef MAGGI_ISLAND_H
#define MAGGI_ISLAND_H

#include "columns.h"
#include "derivative.h"

enum { SMALL = 3 }; /* islands of so many dependents stay in registers */

typedef struct island {
  int m, n;              /* equations, dependents */
  int adr;               /* of its block in Phi_d */
  const double *phi, *L; /* block, factor */
  const int *dep, *row;  /* dependent coordinates, loop equations */
} island;

static inline island island_of(const maggi_derivative *D, int k)
{
  const maggi_data *d = D->d;
  const maggi_topo *t = &d->t;

  return (island){.m = t->islrow[k + 1] - t->islrow[k],
                  .n = t->isldep[k + 1] - t->isldep[k],
                  .adr = t->islphi[k],
                  .phi = d->phi + t->islphi[k],
                  .L = d->chol + t->islchol[k],
                  .dep = t->dep + t->isldep[k],
                  .row = D->rowloop + t->islrow[k]};
}

static inline int is_square(const island *o)
{
  return o->m == o->n;
}

static inline int is_delicate(const island *o)
{
  return !is_square(o) && has_small_pivots(o->n, o->L);
}

/* X = A^-1 (Phi^T Y + Phi_d^T y); y by loop equations, NULL: zero */
ALWAYS_INLINE void least_squares(int width, int n, const island *o, const double *Y,
                                 const double *phi_d, double sign, const double *y, double *X)
{
  const double *block = y ? phi_d + (size_t)o->adr * (size_t)width : NULL;
  int i, row;

  clear(n * width, X);
  for (row = 0; row < o->m; ++row) {
    for (i = 0; i < n; ++i) {
      axpy(width, o->phi[row * n + i], Y + row * width, X + i * width);
      if (y) axpy(width, sign * y[o->row[row]], block + (row * n + i) * width, X + i * width);
    }
  }
  substitute(n, width, o->L, X);
}

/* Y -= Phi X */
ALWAYS_INLINE void subtract_range(int width, int n, const island *o, const double *X, double *Y)
{
  int i, row;

  for (row = 0; row < o->m; ++row)
    for (i = 0; i < n; ++i) axpy(width, -o->phi[row * n + i], X + i * width, Y + row * width);
}

/* the same X, refined where the pivots of A differ much; Y -= Phi X is complete if `reduce`; x = X on
 * the dependent coordinates unless that is NULL */
ALWAYS_INLINE void solve_sized(int width, int n, int reduce, const island *o, double *Y,
                               const double *phi_d, double sign, const double *y, double *X,
                               double *T, double *x)
{
  int i, refine = has_small_pivots(n, o->L);

  least_squares(width, n, o, Y, phi_d, sign, y, X);
  if (reduce || refine) subtract_range(width, n, o, X, Y);
  if (refine) {
    least_squares(width, n, o, Y, phi_d, sign, y, T);
    if (reduce) subtract_range(width, n, o, T, Y);
    for (i = 0; i < n; ++i) axpy(width, 1.0, T + i * width, X + i * width);
  }
  for (i = 0; i < n && x; ++i) load(width, X + i * width, x + o->dep[i] * width);
}

ALWAYS_INLINE void solve(int width, int reduce, const island *o, double *Y, const double *phi_d,
                         double sign, const double *y, double *space, double *x)
{
  double X[SMALL * MAGGI_NDIR], T[SMALL * MAGGI_NDIR];

  if (o->n == 1)
    solve_sized(width, 1, reduce, o, Y, phi_d, sign, y, X, T, x);
  else if (o->n == 2)
    solve_sized(width, 2, reduce, o, Y, phi_d, sign, y, X, T, x);
  else if (o->n == 3)
    solve_sized(width, 3, reduce, o, Y, phi_d, sign, y, X, T, x);
  else
    solve_sized(width, o->n, reduce, o, Y, phi_d, sign, y, space, space + o->n * width, x);
}

/* Y = y on its equations */
ALWAYS_INLINE void gather_rows(int width, const island *o, const double *y, double *Y)
{
  int i;

  for (i = 0; i < o->m; ++i) load(width, y + o->row[i] * width, Y + i * width);
}

ALWAYS_INLINE void scatter_rows(int width, const island *o, const double *Y, double *y)
{
  int i;

  for (i = 0; i < o->m; ++i) load(width, Y + i * width, y + o->row[i] * width);
}

/* Y = G_d x on one island, zero in a square one */
ALWAYS_INLINE void island_product(int width, const island *o, const double *phi_d, const double *x,
                                  double *Y)
{
  const double *block = phi_d + (size_t)o->adr * (size_t)width;
  int i, row;

  clear(o->m * width, Y);
  for (row = 0; row < o->m && !is_square(o); ++row)
    for (i = 0; i < o->n; ++i)
      axpy(width, x[o->dep[i]], block + (row * o->n + i) * width, Y + row * width);
}

#endif
