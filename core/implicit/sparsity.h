/* Places of the nonzeros of a sparse matrix, by columns. */
#ifndef MAGGI_SPARSITY_H
#define MAGGI_SPARSITY_H

typedef struct maggi_sparsity {
  int nrow, ncol;
  int *coladr; /* (ncol + 1) first entry of a column, at last the number of entries */
  int *row;    /* (coladr[ncol]) rows, rising in each column */
} maggi_sparsity;

/* The transpose; its lists have room, its sizes are set.  Rows of `a` may be in any order. */
void maggi_sparsity_transpose(const maggi_sparsity *a, maggi_sparsity *at);

#endif
