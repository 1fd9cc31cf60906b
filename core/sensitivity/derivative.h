/* Derivatives of one evaluation of the equations of motion.
 *
 * maggi_evaluate is explicit formulas (the kernel) with linear solves between them.  The formulas have
 * generated derivatives (ad_generated/); the solves have rules by hand, from the implicit function
 * theorem, with the factors of the evaluation.  maggi_data is the tape.  What the solves make exact,
 * with G the blocks Phi_bb of the islands on the diagonal, Phi v the rates of the loops:
 *
 *   (1)  G^T rate(v) = 0                dependent velocities
 *   (2)  G^T gama(a) = 0                dependent accelerations
 *   (3)  w(a, lambda) = 0               independent accelerations; on dependent coordinates mu,
 *        lambda = G mu                  which gives the multipliers
 *
 * These hold also where loops are open; rate and gama are zero only where they are closed.  With them
 *
 *   K = G^T Phi on dependents           block lower triangular, A_b = Phi_bb^T Phi_bb on the diagonal
 *   R = dependent by independent ones   R^T Phi^T G = 0
 *   dw/da = -M, dw/dlambda = -Phi^T, d(gama)/da = -Phi
 */
#ifndef MAGGI_DERIVATIVE_H
#define MAGGI_DERIVATIVE_H

#include "data.h"
#include "maggi_ad.h"

/* the active arrays of maggi_data: name, numbers */
#define MAGGI_ACTIVE_CONSTANTS(X)                                                                  \
  X(p, t->np)                                                                                      \
  X(offset0, t->nbody * 3)                                                                         \
  X(axis0, t->nbody * 3)                                                                           \
  X(body0, t->nbody * 10)                                                                          \
  X(point0, t->npoint * 3)                                                                         \
  X(dir0, t->ndir * 3)                                                                             \
  X(prim0, t->nprim)                                                                               \
  X(spring0, t->nspring)                                                                           \
  X(spline0, t->nspline * 3)

#define MAGGI_ACTIVE_LIST(X)                                                                       \
  X(fun, t->nfun * 3)                                                                              \
  X(q, t->nq)                                                                                      \
  X(turn, t->nbody * 2)                                                                            \
  X(A, (t->nbody + 1) * 9)                                                                         \
  X(x, (t->nbody + 1) * 3)                                                                         \
  X(b, t->nbody * 6)                                                                               \
  X(r, t->npoint * 3)                                                                              \
  X(dir, t->ndir * 3)                                                                              \
  X(res, t->nrow)                                                                                  \
  X(v, t->nq)                                                                                      \
  X(Z, (t->nbody + 1) * 6)                                                                         \
  X(Z0, (t->nbody + 1) * 6)                                                                        \
  X(rv, t->npoint * 3)                                                                             \
  X(rate, t->nrow)                                                                                 \
  X(a, t->nq)                                                                                      \
  X(Wa, (t->nbody + 1) * 6)                                                                        \
  X(Za, (t->nbody + 1) * 6)                                                                        \
  X(ra, t->npoint * 3)                                                                             \
  X(gama, t->nrow)                                                                                 \
  X(slip, t->nwheel *MAGGI_SLIP_NUMBERS)                                                           \
  X(grip, t->nwheel * 6)                                                                           \
  X(roll, t->nwheel * 6)                                                                           \
  X(I, t->nbody * 10)                                                                              \
  X(Q, (t->nbody + 1) * 6)                                                                         \
  X(speed, t->nspeed * 3)                                                                          \
  X(tau, t->nq)                                                                                    \
  X(lambda, t->nrow)                                                                               \
  X(Fr, (t->nbody + 1) * 6)                                                                        \
  X(FSr, (t->nbody + 1) * 6)                                                                       \
  X(w, t->nq)                                                                                      \
  X(wrench, t->nbody * 6)                                                                          \
  X(sensor, t->nsensor * 3)                                                                        \
  X(spin, t->nwheel)                                                                               \
  X(kinetic, 1)                                                                                    \
  X(potential, 1)

/* A derivative of every active array, of the same name; `width` numbers for each of its own. */
typedef struct maggi_companion {
  int width;
  size_t nconstants, nmotion, nphi; /* numbers */
  double *constants, *motion;       /* the memory of the two lists */
#define X(name, numbers) double *name;
  MAGGI_ACTIVE_CONSTANTS(X)
  MAGGI_ACTIVE_LIST(X)
#undef X
  double *phi; /* sized by the plan */
  size_t capphi;
} maggi_companion;

/* work space of the solves; what is named as in a derivation of implicit.c has its meaning */
#define MAGGI_SOLVE_LIST(X)                                                                        \
  X(x, t->nq)                                                                                      \
  X(xs, (t->nq * MAGGI_NDIR))                                                                      \
  X(rest, (t->nrow * MAGGI_NDIR))                                                                  \
  X(space, (2 * t->nq * MAGGI_NDIR))                                                               \
  X(columns, (t->nq * MAGGI_NDIR))                                                                 \
  X(column, t->nq + MAGGI_WIDTH)                                                                   \
  X(column2, t->nq + MAGGI_WIDTH)                                                                  \
  X(work, t->nq)                                                                                   \
  X(rows, t->nrow)                                                                                 \
  X(moved, t->nq) /* R y_d */                                                                      \
  X(range, t->nq)                                                                                  \
  X(mu_d, t->nq)                                                                                   \
  X(omega, t->nq)                                                                                  \
  X(omega_p, t->nq)                                                                                \
  X(nu, t->nq)

/* of the islands, for the present plan */
#define MAGGI_ISLAND_LIST(X)                                                                       \
  X(rowloop, t->nrow)     /* loop equation of a row in the order of islands */                     \
  X(coupled, t->nloop)    /* whether an island needs dependents of earlier ones */                 \
  X(islvop, t->nloop + 1) /* as in maggi_topo, but of dependents alone */                          \
  X(vopdst, 2 * t->npath)                                                                          \
  X(vopsrc, 2 * t->npath)                                                                          \
  X(vopq, 2 * t->npath)                                                                            \
  X(primva, t->nprim)                                                                              \
  X(primvb, t->nprim)                                                                              \
  X(same, 2 * t->npath + 1) /* the row that moves like this one */

struct maggi_derivative {
  maggi_data *d;
  double time;     /* of the evaluation */
  double power[1]; /* of elements, not differentiated */
  long plan;       /* d->plans for which the lists below were made */
  maggi_companion tangent, strip, adjoint;
  maggi_companion second; /* tangent of the adjoint */
  int nkept;              /* sets of constants of D->strip, for as many strips */
  int tangent_moves;      /* whether tangents of constants are not all zero */
  int kept_move;
  maggi_topo t;  /* that of d with the lists below */
  int redundant; /* whether an island has more equations than dependents */
#define X(name, size) int *name;
  MAGGI_ISLAND_LIST(X)
#undef X
  double *memory; /* of the solves */
  double *V;      /* (nvrow x 6 x MAGGI_NDIR) velocities of bodies by dependent coordinates */
  size_t capV;
#define X(name, numbers) double *name;
  MAGGI_SOLVE_LIST(X)
#undef X
};

/* workspace.c */
maggi_status maggi_derivative_fit(maggi_derivative *D); /* to the present plan */
void maggi_companion_clear(const maggi_companion *s);   /* all but the constants */
/* constants of s from `at` on; how many numbers they are */
size_t maggi_place_constants(maggi_companion *s, const maggi_topo *t, double *at);

/* The sweeps, all on D after maggi_linearise_at.
 * tangent.c, strip.c: from constants, positions and velocities of independent coordinates to velocities
 * and accelerations; maggi_tangent_forces completes the other tangents for the second derivative */
void maggi_tangent_constants(maggi_derivative *D);
void maggi_tangent_motion(maggi_derivative *D);
void maggi_tangent_forces(maggi_derivative *D);
void maggi_strip_choose(maggi_derivative *D, int first); /* its constants: derivative.c */
void maggi_strip_constants(maggi_derivative *D);
void maggi_strip_motion(maggi_derivative *D);
/* positions of dependent coordinates where loops were closed by them: out of the others, in place */
void maggi_strip_closure(maggi_derivative *D);
/* velocities of wheels that start rolling, after maggi_strip_motion with theirs at rest */
void maggi_strip_rolling(maggi_derivative *D);
/* adjoint.c: back from adjoints of velocities and accelerations, all others zero; or the parts of it that
 * solve equations, omega_p as in implicit.h */
void maggi_adjoint_motion(maggi_derivative *D);
void maggi_adjoint_constants(maggi_derivative *D);
/* back from the adjoints of all positions to those of the coordinates that are not dependent */
void maggi_adjoint_closure(maggi_derivative *D);
/* from adjoints of the velocities of wheels that start rolling, (nq) with those of other coordinates, to where
 * maggi_adjoint_motion starts */
void maggi_adjoint_rolling(maggi_derivative *D, const double *v);
void maggi_adjoint_accelerations(maggi_derivative *D, const maggi_companion *s,
                                 const double *omega_p);
void maggi_adjoint_rates(maggi_derivative *D, const maggi_companion *s);
/* hessian.c: the adjoint and its tangent */
void maggi_second_motion(maggi_derivative *D);
void maggi_second_constants(maggi_derivative *D);

/* derivative.c: what the public functions are made of.  The constants depend on the parameters alone:
 * integrators take their tangents once, and pull their adjoints back once.  Coordinates in the order of
 * the user, matrices of n columns with rows `ld` long. */
maggi_status maggi_linearise_at(maggi_derivative *D,
                                double time);                    /* after maggi_evaluate(d, time) */
void maggi_parameters_jvp(maggi_derivative *D, const double *p); /* NULL: zero */
void maggi_parameters_jac(maggi_derivative *D, int n, int ld, const double *p); /* all strips */
void maggi_parameters_clear(maggi_derivative *D);          /* adjoints of constants */
void maggi_parameters_vjp(maggi_derivative *D, double *p); /* of all since then */
void maggi_state_jvp(maggi_derivative *D, const double *q, const double *v, double *v_out,
                     double *a_out);
void maggi_state_jac(maggi_derivative *D, int n, int ld, const double *q, const double *v,
                     double *v_out, double *a_out);
void maggi_state_vjp(maggi_derivative *D, const double *v_bar, const double *a_bar, double *q_out,
                     double *v_out);

#endif
