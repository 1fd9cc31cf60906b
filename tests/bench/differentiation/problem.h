/* One evaluation of the equations of motion, to be differentiated. */
#ifndef BENCH_PROBLEM_H
#define BENCH_PROBLEM_H

#include "maggi/maggi.h"
#include "topo.h"

/* y = f(x), the motion of maggi.h, with the constants from p; coordinates in the order of the user:
 *   x   q, v, p  (2 nq + np)   velocities of dependent and guided coordinates do not count
 *   y   v, a     (2 nq)                                                                          */
typedef struct problem {
  maggi_data *d; /* stands at x, and is left there */
  const maggi_topo *t;
  int originadr;
  const int *q; /* (nq) internal number of a coordinate */
  double time;
  int nx, ny;
  const double *x;
} problem;

#endif
