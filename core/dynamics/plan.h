/* Choice of the dependent coordinates and what follows from it.
 *
 * choose.c eliminates loop by loop, with the rows of each expressed in the coordinates that are still
 * free; the pivots are the dependent coordinates of the loop.  islands.c orders the loops into
 * islands, plan.c writes the lists of the kernel. */
#ifndef MAGGI_PLAN_H
#define MAGGI_PLAN_H

#include "data.h"

typedef struct maggi_row {
  int begin, n; /* entries in the pool: dependent coordinate = sum of coef * free coordinate */
} maggi_row;

typedef struct maggi_ints {
  int *v;
  int n, cap;
} maggi_ints;

struct maggi_planner {
  int *order;           /* (nloop) loops with short paths first */
  int *loopprim;        /* (nloop + 1) first building block of a loop */
  int *owner;           /* (nq) loop on which a coordinate depends, -1 if none */
  int *previous;        /* (nq) owner before the last choice */
  int *previous_order;  /* (nloop) */
  int *previous_island; /* (nloop) */
  int *rank;            /* (nloop) dependents of a loop */
  /* choose.c */
  maggi_row *row; /* (nq) */
  int *poolq;
  double *poolc;
  int npool, cappool;
  int *candidate; /* (nq) column of a coordinate in the small matrix, -1 if none */
  int *columnq;   /* (nq) its inverse */
  double *matrix; /* (rows of a loop x candidates) */
  size_t capmatrix;
  double *sum; /* (nq) */
  /* plan.c */
  int *component, *low, *index, *stack, *frame, *at; /* (nloop + 1) Tarjan */
  int *loopisland;                                   /* (nloop) island of a loop, -1 */
  int *local;                                        /* (nq) place of a dependent in its island */
  int *vhead;                                        /* (nbody) first velocity row of a body */
  int *climb;                                        /* (nbody) */
  int *group, *groupsize;                            /* (nq) columns.c */
  maggi_ints vbase, vnext;                           /* of velocity rows */
#define X(name, size, text) maggi_ints name;
  MAGGI_PLAN_LIST(X)
#undef X
};

/* planner.c: the order of loops at first; lists of integers, false when out of memory */
void maggi_planner_sort(const maggi_topo *t, int *order);
int maggi_sized(maggi_ints *list, int n, int value); /* n integers set to value */
int maggi_push_int(maggi_ints *list, int value);

/* columns.c: columns by the tree, false when out of memory; then by what depends on them, whether that is
 * another order; flops of what works with blocks of columns, from the lists of an order */
int maggi_number_columns(maggi_data *d);
int maggi_group_columns(maggi_data *d);
double maggi_columns_cost(const maggi_data *d);

/* islands.c: loops and dependents by island; false when out of memory */
int maggi_list_islands(maggi_data *d);

maggi_status maggi_choose(maggi_data *d, int avoid, double threshold);

#endif
