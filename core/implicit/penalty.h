/* A simulation by the penalty formulation: what its steps and their derivatives share. */
#ifndef MAGGI_PENALTY_H
#define MAGGI_PENALTY_H

#include "chain.h"
#include "direct.h"
#include "factor.h"
#include "jacobian.h"
#include "reversal.h"
#include "tangent_matrix.h"

struct maggi_penalty {
  maggi_data *d;
  maggi_penalty_options options;
  maggi_penalty_state state;
  maggi_force_jacobian *jacobian;
  maggi_tangent_matrix *matrix;
  maggi_factor *newton, *projection;
  int n;                /* coordinates that are not guided */
  double *memory;       /* (nq) each: */
  double *q0, *v0, *a0; /* start of the step */
  double *vs, *as;      /* velocities, accelerations of the trapezoidal rule, not projected */
  double *x;            /* correction */
  maggi_rest rest;      /* moved by what a projection changes */
};

/* What a step leaves for its derivatives: the exact derivative E of its equation, and its
 * projections. */
typedef struct maggi_penalty_derivative {
  maggi_penalty *s;
  maggi_derivative *D;
  maggi_colouring *colouring;        /* of the columns of E */
  maggi_factor *exact;               /* of E */
  double *value;                     /* of E */
  double *product;                   /* (n x MAGGI_NDIR) */
  double *column;                    /* (MAGGI_NDIR x n) right-hand sides */
  double *v, *a;                     /* (nq) of the end of the step */
  double *work;                      /* (3 nq MAGGI_NDIR) tangents of positions, velocities, .. */
  double *still;                     /* tangents of constants that do not move */
  maggi_rest velocity, acceleration; /* moved by the two projections */
} maggi_penalty_derivative;

/* velocities and accelerations that go with positions d->q by the trapezoidal rule */
void maggi_penalty_trapezoid(maggi_penalty *s, double h, double *v, double *a);
/* D of the simulation of s; status MAGGI_OK, MAGGI_E_MEMORY; free(NULL) does nothing */
maggi_status maggi_penalty_derivative_create(maggi_penalty *s, maggi_derivative *D,
                                             maggi_penalty_derivative **derivative);
void maggi_penalty_derivative_free(maggi_penalty_derivative *x);
/* At a step of size h from s->q0, v0, a0 to d->q, v, a, in this order:
 *   equation     E and its factors; d is evaluated with the velocities and accelerations of the
 *                trapezoidal rule after it
 *   projections  with those that the step ends with, which d had before */
maggi_status maggi_penalty_differentiate_equation(maggi_penalty_derivative *x, double h,
                                                  double time);
maggi_status maggi_penalty_differentiate_projections(maggi_penalty_derivative *x, double h,
                                                     double time);

/* penalty_direct.c: a step of s with the tangents of `direct`, which has reset the simulation */
maggi_status maggi_penalty_direct_step(maggi_penalty_derivative *x, maggi_direct *direct, double h);
/* penalty_adjoint.c: back over such a step; the lanes of r hold adjoints of q, v and a at its end,
 * then at its start */
maggi_status maggi_penalty_adjoint_step(maggi_penalty_derivative *x, maggi_reversal *r, double h,
                                        double time);

#endif
