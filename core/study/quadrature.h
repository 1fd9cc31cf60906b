/* Samples on a grid as nodes of a piecewise polynomial of degree 5.
 *
 * Between nodes i and i + 1 it is the polynomial through the six nodes i - 2 .. i + 3, at the ends
 * through the first or last six, through all where there are fewer.  Nodes are h apart but for the
 * last: when the last step of the grid is shorter than 0.28 of the others, the sample before it is no
 * node.  So nothing is a difference over a short step, and all weights in an integral are positive but
 * for some on grids of less than eight samples.
 */
#ifndef MAGGI_QUADRATURE_H
#define MAGGI_QUADRATURE_H

#include "maggi/maggi.h"

enum { MAGGI_STENCIL = 6 };

typedef struct maggi_nodes {
  long n;                        /* number, at least 1 */
  long skipped;                  /* the sample that is none, -1: there is no such sample */
  double h;                      /* distance [s] */
  double gap;                    /* that of the last two [h] */
  double end[2 * MAGGI_STENCIL]; /* weights of the first and last ones in an integral [s] */
} maggi_nodes;

/* A value of the polynomial: sum of weight[j] times node first + j. */
typedef struct maggi_local {
  long first;
  int n;
  double weight[MAGGI_STENCIL];
} maggi_local;

void maggi_nodes_init(maggi_nodes *x, const maggi_grid *grid);
long maggi_nodes_of(const maggi_nodes *x, long sample);                /* -1: no node */
double maggi_nodes_weight(const maggi_nodes *x, long i);               /* in the integral [s] */
int maggi_nodes_stencil(const maggi_nodes *x);                         /* nodes of a polynomial */
long maggi_nodes_first(const maggi_nodes *x, long interval);           /* the first of them */
double maggi_nodes_position(const maggi_nodes *x, long first, long i); /* from the first [h] */
/* Interval of a time, and its position from the first node of the polynomial there [h]. */
long maggi_nodes_find(const maggi_nodes *x, double t, double *u);
/* The polynomial of an interval at such a position; its integral from one to another [s]. */
void maggi_nodes_at(const maggi_nodes *x, long interval, double u, maggi_local *value);
void maggi_nodes_integral(const maggi_nodes *x, long interval, double begin, double end,
                          maggi_local *value);

#endif
