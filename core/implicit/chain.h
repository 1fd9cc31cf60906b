/* Forces of the open chain, from positions, velocities and accelerations of all coordinates as they
 * are:
 *
 *   w(z, z', z'', lambda) = Q(z, z') - M(z) z'' - Phi_z^T lambda
 *
 * with the stages of core/kernel on the workspace of a simulation, and derivatives of w. */
#ifndef MAGGI_CHAIN_H
#define MAGGI_CHAIN_H

#include "derivative.h"

/* d->w and all on the way from d->q, d->v, d->a at a time, with lambda = alpha Phi; guided
 * coordinates follow their functions */
void maggi_chain_evaluate(maggi_data *d, double time, double alpha);
/* d->w = Q(z, z'): z'' = 0 and no loops; d->Za and what follows from it are those of z'' = 0 */
void maggi_chain_forces(maggi_data *d, double time);
/* d->w for other accelerations, at positions and velocities that have been evaluated, with
 * lambda = alpha Phi, or with d->lambda as it is */
void maggi_chain_accelerate(maggi_data *d, double alpha);
void maggi_chain_balance(maggi_data *d);
/* after one of these: how fast loops open, d->rate; and minus how fast that changes, d->gama */
void maggi_chain_rates(maggi_data *d);
void maggi_chain_gamma(maggi_data *d);

/* Bodies that nothing but z'' = x moves, at the positions of a simulation:
 *
 *   w(x, lambda) = - M(z) x - Phi_z^T lambda
 *
 * `data` is that simulation with arrays of its own for x and what follows from it; `strip` and
 * `adjoint` are the companions of D, likewise. */
typedef struct maggi_rest {
  maggi_data data;
  maggi_companion strip, adjoint;
  double *memory;
} maggi_rest;

/* status MAGGI_OK, MAGGI_E_MEMORY; D of the simulation d, NULL: without derivatives */
maggi_status maggi_rest_create(maggi_data *d, const maggi_derivative *D, maggi_rest *rest);
void maggi_rest_free(maggi_rest *rest);
/* data.w from data.a and data.lambda, at positions that have been evaluated in d */
void maggi_rest_evaluate(maggi_rest *rest);
/* the constants that D has chosen; adjoints zero */
void maggi_rest_choose(maggi_derivative *D, maggi_rest *rest);
void maggi_rest_clear(maggi_rest *rest);
/* strip.w from strip.a and .lambda, with the tangents of positions and inertias in D->strip;
 * adjoint.a and .lambda, and what is added to those of positions and inertias in D->adjoint, from
 * adjoint.w */
void maggi_strip_rest(maggi_derivative *D, maggi_rest *rest);
void maggi_adjoint_rest(maggi_derivative *D, maggi_rest *rest);

/* Tangents of w along a strip, s->w from s->q, s->v, and, in a balance, from s->a and
 * lambda = alpha Phi; Q alone is that at z'' = 0, after maggi_chain_forces, where functions of time
 * and constants are held.  chain_strip.c */
void maggi_strip_forces(maggi_derivative *D);
void maggi_strip_balance(maggi_derivative *D, double alpha);
/* positions, inertias; then rates of loops from s->v; then their opening accelerations s->gama,
 * s->a */
void maggi_strip_positions(maggi_derivative *D);
void maggi_strip_rates(maggi_derivative *D);
void maggi_strip_gamma(maggi_derivative *D);
/* Adjoint of Q: D->adjoint.q and .v from .w, all others zero before.  chain_adjoint.c */
void maggi_adjoint_forces(maggi_derivative *D);
/* of the others, from .w, or .gama, .rate: .a and .v are complete after it, the rest is added to */
void maggi_adjoint_balance(maggi_derivative *D, double alpha);
void maggi_adjoint_gamma(maggi_derivative *D);
void maggi_adjoint_rates_of(maggi_derivative *D);
/* at last: to positions of coordinates, functions of time and constants */
void maggi_adjoint_positions(maggi_derivative *D);

#endif
