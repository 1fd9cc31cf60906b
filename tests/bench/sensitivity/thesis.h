/* Direct differentiation as in the thesis: y_b integrated with y by the classical Runge-Kutta method,
 * four evaluations of y' = f(y, b) and f_y y_b + f_b a step.  Without projections or changes of the
 * independent coordinates; positions of guided coordinates are overwritten by their functions in every
 * evaluation. */
#ifndef BENCH_THESIS_H
#define BENCH_THESIS_H

#include "topo.h"
#include "ways.h"

#ifdef __cplusplus
extern "C" {
#endif

/* y = (q of all coordinates, v of independent ones) in internal order; matrices row by row, parameter
 * last */
typedef struct motion {
  const study *of;
  maggi_data *d; /* reset, of this motion alone */
  int nq, nind, ny, n;
  double time;
  double *pb; /* (np x n) derivative of p */
  double *memory;
  double *y0, *yb0; /* at first */
  double *y, *yb, *x, *xb, *f, *fb, *sum, *sumb;
} motion;

/* f and fb from x and xb, at the time of the motion */
typedef void slopes(void *self, const double *x, const double *xb, double *f, double *fb);

int motion_open(motion *m, const study *of, int n);
void motion_close(motion *m);
int motion_gradient(motion *m, slopes *evaluate, void *self, int steps, double *gradient);

/* f by the library; x = M^-1 x with the factor of this evaluation; the plan and entries of p */
void motion_evaluate(motion *m, const double *x, double *f);
void motion_solve(const motion *m, double *x);
const maggi_topo *motion_topo(const motion *m);
int motion_origin(const motion *m);
const double *motion_parameters(const motion *m);
/* row of f_y y_b + f_b from a row of f_y and f_b */
void motion_multiply(const motion *m, const double *row, const double *xb, double *fb);

#ifdef __cplusplus
}
#endif

#endif
