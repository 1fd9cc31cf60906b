/* Derivatives of the linear solves of an evaluation, by hand.  The names say the mode, as those of
 * generated functions: _d tangent, _dv MAGGI_NDIR tangents, _b adjoint, _b_d tangent of the adjoint. */
#ifndef MAGGI_IMPLICIT_H
#define MAGGI_IMPLICIT_H

#include "derivative.h"

/* y_d = P y_d - G A^-1 G_d^T y where that is worth it, by loop equations: what keeps G^T y = 0.  phi_d and
 * y may be NULL: y_d = P y_d. */
void maggi_project_rows(maggi_derivative *D, double *y_d, const double *phi_d, const double *y);
/* x = R (R^T M R)^-1 R^T w on independent and dependent coordinates, 0 on guided ones */
void maggi_move_independents(maggi_derivative *D, const double *w, double *x);
/* y -= M x */
void maggi_subtract_inertia(const maggi_data *d, const double *x, double *y);
/* K^T x = w on dependent coordinates, y = G x by loop equations */
void maggi_solve_transposed(const maggi_derivative *D, const double *w, double *x, double *y);

/* rate and gama of the evaluation */
void maggi_remainders(maggi_derivative *D);

/* Equations (1) and (2), sign G^T y = 0 with y = rate and sign = -1, or y = gama and sign = 1: tangent x
 * of the dependent velocities or accelerations, from the tangent of y with these at rest. */
void maggi_close_d(maggi_derivative *D, double sign, const double *y, const double *y_d,
                   const double *phi_d, double *x);
void maggi_close_dv(maggi_derivative *D, double sign, const double *y, const double *y_d,
                    const double *phi_d, double *x);

/* The positions that projections and assembly find, G^T res = 0 with res = 0: the same equation, whatever
 * moves the residual; -1 for the sign, NULL for y and phi_d.  Adjoint: s->res from s->q. */
void maggi_close_positions_b(maggi_derivative *D, const maggi_companion *s);

/* tangent of lambda = G mu as far as it matters for (3): s->lambda */
void maggi_multipliers_d(maggi_derivative *D, const maggi_companion *s);
void maggi_multipliers_dv(maggi_derivative *D, const maggi_companion *s);

/* Equation (3): the tangent s->w with independent accelerations at rest sets them in motion, s->a. */
void maggi_independents_d(maggi_derivative *D, const maggi_companion *s);
void maggi_independents_dv(maggi_derivative *D, const maggi_companion *s);

/* the tangents that only second derivatives need: of mu, with the rest of s->lambda; of rate and gama */
void maggi_multipliers_rest_d(maggi_derivative *D, const maggi_companion *s);
void maggi_remainders_d(maggi_derivative *D, const maggi_companion *s);
/* The rest of s->lambda, added to what maggi_multipliers_dv has left there, where accelerations are
 * given. */
void maggi_multipliers_rest_dv(maggi_derivative *D, const maggi_companion *s);

/* Adjoint of (3): s->w from s->a.  omega_p: what the adjoint of w must be on dependent coordinates
 * for an adjoint of mu; NULL if none. */
void maggi_independents_b(maggi_derivative *D, const maggi_companion *s, const double *omega_p);

/* Adjoint of lambda where it is a result: s->w on dependent coordinates such that, with what its
 * sweep adds to s->lambda, G^T s->lambda = 0.  (3) holds, so that this may count for all forces. */
void maggi_balance_multipliers_b(maggi_derivative *D, const maggi_companion *s);
/* Then the adjoint of lambda = G mu goes on to G: s->lambda to s->phi. */
void maggi_multipliers_b(maggi_derivative *D, const maggi_companion *s);

/* Adjoints of (2) and (1): s->gama from s->a, s->rate from s->v, and their shares of s->phi. */
void maggi_close_accelerations_b(maggi_derivative *D, const maggi_companion *s);
void maggi_close_velocities_b(maggi_derivative *D, const maggi_companion *s);

/* adjoints of guided coordinates go to their functions */
void maggi_guides_b(maggi_derivative *D, const maggi_companion *s);

/* The same for s, and tangents in D->second along D->tangent, with the solutions of the adjoint
 * equations held; by what these change is an adjoint solve of its own, with the adjoint of mu in
 * D->omega_p. */
void maggi_independents_b_d(maggi_derivative *D, const maggi_companion *s);
void maggi_close_accelerations_b_d(maggi_derivative *D, const maggi_companion *s);
void maggi_close_velocities_b_d(maggi_derivative *D, const maggi_companion *s);
void maggi_guides_b_d(maggi_derivative *D, const maggi_companion *s);

#endif
