/* LU factors of a small dense matrix, rows scaled, with partial pivoting. */
#ifndef MAGGI_DENSE_H
#define MAGGI_DENSE_H

typedef struct maggi_dense {
  int n;
  double *lu;    /* (n x n) */
  double *scale; /* (n) of rows */
  double *work;  /* (n) */
  int *row;      /* (n) row of the matrix that became row i of the factors */
} maggi_dense;

/* For matrices of at most n rows; false without memory.  Free also what failed. */
int maggi_dense_create(maggi_dense *f, int n);
void maggi_dense_free(maggi_dense *f);
/* Factors of the n x n matrix a: true, or false where it is singular to working precision: then a null vector
 * of it is in work. */
int maggi_dense_factor(maggi_dense *f, int n, const double *a);
/* A x = b in place; with the transposed matrix */
void maggi_dense_solve(const maggi_dense *f, double *x);
void maggi_dense_solve_transposed(const maggi_dense *f, double *x);

#endif
