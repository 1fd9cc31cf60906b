/* Static equilibrium: positions at which the accelerations of the static twin of a model vanish at rest.
 *
 * With q_i the independent coordinates of the twin, J = da_i/dq_i with the dependent ones following the
 * loops, and an entry p that moves a_i by a_p at q_i held, the implicit function theorem says
 *
 *   J dq_i/dp = -a_p          and backwards          p += a_p^T w,  J^T w = -q_i
 *
 * w, q_i, p on the right adjoints. */
#ifndef MAGGI_EQUILIBRIUM_H
#define MAGGI_EQUILIBRIUM_H

#include "dense.h"
#include "derivative.h"

struct maggi_equilibrium {
  maggi_data *x; /* of the twin */
  maggi_derivative *D;
  maggi_dense factor;
  double *J;           /* (nind x nind) da_i/dq_i of the last linearisation */
  double *move, *next; /* (nq) Newton's corrections of independent coordinates */
  double *q;           /* (nq) position before a step */
  double *start;       /* (nq) where the search begins */
  int is_found;        /* x is in equilibrium, evaluated and linearised there */
  int iterations;      /* of Newton's method */
  int damped;          /* steps of the damped run */
};

/* x evaluated at rest where it is */
void maggi_equilibrium_rest(maggi_equilibrium *e);
/* J there */
maggi_status maggi_equilibrium_linearise(maggi_equilibrium *e);
/* From position e->q by `factor` times the correction `move` of the independent coordinates, the others follow;
 * evaluated at rest.  False where the loops cannot be closed: back at e->q. */
int maggi_equilibrium_move(maggi_equilibrium *e, const double *move, double factor);
double maggi_equilibrium_largest(const maggi_equilibrium *e, const double *move);

/* equilibrium_damped.c: nearer to an equilibrium; true where it seems near enough for Newton */
int maggi_equilibrium_damped(maggi_equilibrium *e);

/* Tangents of all positions, a strip, from those of the constants of another companion of MAGGI_NDIR
 * directions; after maggi_equilibrium_find. */
void maggi_equilibrium_strip(maggi_equilibrium *e, const maggi_companion *from, double *q);
/* Adjoint q of all positions to those of the constants of another companion of one direction. */
void maggi_equilibrium_adjoint(maggi_equilibrium *e, const maggi_companion *to, const double *q);

#endif
