/* LU factors of a sparse matrix whose places do not change: SuiteSparse KLU, or dense with partial
 * pivoting where the matrix is small or the library was built without KLU. */
#ifndef MAGGI_FACTOR_H
#define MAGGI_FACTOR_H

#include "maggi/maggi.h"
#include "sparsity.h"

typedef struct maggi_factor maggi_factor;

/* For the places of `a`, which must stay and be square.  status MAGGI_OK, MAGGI_E_MEMORY;
 * free(NULL) does nothing. */
maggi_status maggi_factor_create(const maggi_sparsity *a, maggi_factor **factor);
void maggi_factor_free(maggi_factor *f);
/* Factors of the matrix with these values, in the order of a->row: true, or false if it is singular
 * or memory is short. */
int maggi_factor_compute(maggi_factor *f, const double *value);
/* A x = b in place, n columns one after the other; the same with the transposed matrix. */
void maggi_factor_solve(const maggi_factor *f, int n, double *x);
void maggi_factor_solve_transposed(const maggi_factor *f, int n, double *x);

#endif
