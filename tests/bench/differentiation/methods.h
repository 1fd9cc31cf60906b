/* Ways to differentiate one evaluation of the equations of motion. */
#ifndef BENCH_METHODS_H
#define BENCH_METHODS_H

#include "problem.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { DIRECTIONS = 35 };

/* Each call includes all that it needs besides x: a plain evaluation, factors, a sweep over the
 * tape.  NULL for what a method does not offer.
 *
 *   directions   yd = f' xd for DIRECTIONS of them, one after the other
 *   direction    the same for one
 *   gradient     xb = f'^T yb
 *   hessian      xbd = (f'^T yb)' xd                                                              */
typedef struct method {
  const char *name;
  void *(*open)(const problem *of);
  void (*close)(void *self);
  void (*directions)(void *self, const double *xd, double *yd);
  void (*direction)(void *self, const double *xd, double *yd);
  void (*gradient)(void *self, const double *yb, double *xb);
  void (*hessian)(void *self, const double *yb, const double *xd, double *xbd);
  double tolerance; /* of its derivatives against ours */
} method;

extern const method method_maggi, method_maggi_once, method_differences;
extern const method method_adolc, method_adolc_retaping;
extern const method method_cppad, method_cppad_retaping;
extern const method method_eigen;

/* What maggi's derivatives are made of, in this order. */
#define PART_LIST(X)                                                                               \
  X(EVALUATION, "evaluation")                                                                      \
  X(LINEARISATION, "linearisation")                                                                \
  X(DIRECTIONS_CONSTANTS, "35 directions: constants")                                              \
  X(DIRECTIONS_MOTION, "35 directions: motion")                                                    \
  X(DIRECTION_CONSTANTS, "one direction: constants")                                               \
  X(DIRECTION_MOTION, "one direction: motion")                                                     \
  X(GRADIENT_MOTION, "gradient: motion")                                                           \
  X(GRADIENT_CONSTANTS, "gradient: constants")                                                     \
  X(HESSIAN, "Hessian-vector")

enum {
#define X(part, name) PART_##part,
  PART_LIST(X)
#undef X
      NPART
};

/* one of them for the open method_maggi */
void maggi_part(void *self, int part, const double *xds, const double *xd, const double *yb,
                double *result);

#ifdef __cplusplus
}
#endif

#endif
