#include "sparsity.h"

void maggi_sparsity_transpose(const maggi_sparsity *a, maggi_sparsity *at)
{
  int j, k;

  at->nrow = a->ncol;
  at->ncol = a->nrow;
  for (k = 0; k <= a->nrow; ++k) at->coladr[k] = 0;
  for (k = 0; k < a->coladr[a->ncol]; ++k) ++at->coladr[a->row[k]];
  for (k = 0; k < a->nrow; ++k) at->coladr[k + 1] += at->coladr[k];
  /* from the ends of the columns to their beginnings */
  for (j = a->ncol - 1; j >= 0; --j)
    for (k = a->coladr[j]; k < a->coladr[j + 1]; ++k) at->row[--at->coladr[a->row[k]]] = j;
}
