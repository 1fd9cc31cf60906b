/* Colouring of the columns of a sparse matrix: columns of one colour share no row, so that one
 * product of the matrix with their sum holds the entries of all of them (Curtis et al. 1974).
 *
 * Greedy: column by column the first colour that no neighbour has, which is a column with a common
 * row.  The orders in which columns are taken [1]:
 *
 *   natural           as they are
 *   largest first     by falling number of neighbours
 *   smallest last     the last one has the fewest neighbours, the one before it the fewest
 *                     among those that are left, ..
 *   incidence degree  next the one with the most neighbours before it
 *
 * The best of them has the fewest colours.  When these are more than the entries of the longest
 * row, which no colouring undercuts, columns are coloured again, colour after colour: that never
 * takes more of them and sometimes fewer [2].  Each time costs the sum over rows of the square of
 * their length.
 *
 * [1] A. Gebremedhin, F. Manne, A. Pothen, What color is your Jacobian?, SIAM Review 47, 2005.
 * [2] J. Culberson, Iterated greedy graph coloring and the difficulty landscape, 1992. */
#ifndef MAGGI_COLOUR_H
#define MAGGI_COLOUR_H

#include "maggi/maggi.h"
#include "sparsity.h"

typedef enum maggi_colour_order {
  MAGGI_COLOUR_NATURAL,
  MAGGI_COLOUR_LARGEST_FIRST,
  MAGGI_COLOUR_SMALLEST_LAST,
  MAGGI_COLOUR_INCIDENCE_DEGREE,
  MAGGI_COLOUR_BEST
} maggi_colour_order;

typedef struct maggi_colouring {
  int ncolour;
  int *colour;    /* (ncol) colour of a column */
  int *colouradr; /* (ncolour + 1) first column of a colour in `column` */
  int *column;    /* (ncol) columns by colour, rising in each */
} maggi_colouring;

/* MAGGI_OK, MAGGI_E_MEMORY */
maggi_status maggi_colouring_create(const maggi_sparsity *a, maggi_colour_order order,
                                    maggi_colouring **colouring);
void maggi_colouring_free(maggi_colouring *colouring);

/* Entries of the columns of colours begin .. end - 1, in the order of a->row, from the products
 * B (nrow x (end - begin)) of the matrix with the sums of the columns of each of them. */
void maggi_colour_recover(const maggi_sparsity *a, const maggi_colouring *c, int begin, int end,
                          const double *B, double *value);

#endif
