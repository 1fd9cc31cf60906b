/* The workspace of one simulation: every intermediate result has a place of its own, written once an
 * evaluation, so that a reverse sweep finds it there. */
#ifndef MAGGI_DATA_H
#define MAGGI_DATA_H

#include "kernel.h"
#include "maggi/maggi.h"
#include "model.h"

/* name, rows, columns: what the model alone sizes */
#define MAGGI_DATA_LIST(X)                                                                         \
  /* from p, by maggi_constants */                                                                 \
  X(offset0, nbody, 3, "joint point from that of the parent, initial axes [m]")                    \
  X(axis0, nbody, 3, "unit axis of the joint, initial")                                            \
  X(body0, nbody, 10, "inertia about the joint point, initial axes")                               \
  X(point0, npoint, 3, "points from the joint point of their body [m]")                            \
  X(dir0, ndir, 3, "unit vectors, initial")                                                        \
  X(spline0, nspline, 3, "splines: second derivatives and elimination")                            \
  X(path0, npath0, 8, "paths of drivers: splines by points")                                       \
  /* by maggi_evaluate */                                                                          \
  X(fun, nfun, 3, "functions of time: value, first and second derivative")                         \
  X(turn, nbody, 2, "sine and cosine of the angle of a revolute joint")                            \
  X(A, nbody1, 9, "rotation of a body since the initial position")                                 \
  X(x, nbody1, 3, "joint point from P, global axes [m]")                                           \
  X(b, nbody, 6, "velocity of a body by its coordinate")                                           \
  X(r, npoint, 3, "points from P [m]")                                                             \
  X(dir, ndir, 3, "unit vectors")                                                                  \
  X(Z, nbody1, 6, "velocity of a body at P [m/s, rad/s]")                                          \
  X(Z0, nbody1, 6, "acceleration less gravity with all joint accelerations zero")                  \
  X(W, nbody1, 6, "acceleration by those of the dependent coordinates")                            \
  X(Zb, nbody1, 6, "Z0 + W")                                                                       \
  X(rv, npoint, 3, "velocities of points [m/s]")                                                   \
  X(r0a, npoint, 3, "accelerations of points by Z0")                                               \
  X(rba, npoint, 3, "accelerations of points by Zb")                                               \
  X(slip, nwheel, MAGGI_SLIP_NUMBERS, "slip of wheels, MAGGI_SLIP_..")                             \
  X(grip, nwheel, 6, "forces and moments of tyres, in axes of the contact")                        \
  X(roll, nwheel, 6, "the same at P")                                                              \
  X(I, nbody, 10, "inertia at P: mass, first moment, J")                                           \
  X(IS, nbody1, 10, "the same of the whole subtree")                                               \
  X(F, nbody1, 6, "inertia forces at P, with a minus")                                             \
  X(Q, nbody1, 6, "forces of elements at P")                                                       \
  X(driver, ndriver, 4, "drivers: lateral error, place on the path, demand, speed")                \
  X(speed, nspeed, 3, "controllers of speed: error, torque, speed")                                \
  X(FS, nbody1, 6, "F + Q of the whole subtree")                                                   \
  X(Fb, nq, 6, "IS b")                                                                             \
  X(rodjac, nrodjac, 3, "velocity of ends of rods by coordinates, at a times m/6")                 \
  /* by maggi_balance and maggi_results */                                                         \
  X(Wa, nbody1, 6, "acceleration by those of all coordinates")                                     \
  X(Za, nbody1, 6, "acceleration less gravity")                                                    \
  X(ra, npoint, 3, "accelerations of points less gravity")                                         \
  X(Fr, nbody1, 6, "inertia forces, rods and loops")                                               \
  X(FSr, nbody1, 6, "Fr + Q of the whole subtree")                                                 \
  X(wrench, nbody, 6, "reactions of joints, at the joint point")                                   \
  X(sensor, nsensor, 3, "sensors")

#define MAGGI_DATA_VECTORS(X)                                                                      \
  X(p, np, "parameters")                                                                           \
  X(prim0, nprim, "lengths of rods, cosines of angles")                                            \
  X(spring0, nspring, "lengths of springs as drawn [m]")                                           \
  X(q, nq, "positions, internal order")                                                            \
  X(v, nq, "velocities")                                                                           \
  X(a, nq, "accelerations")                                                                        \
  X(zero, nq, "zeros")                                                                             \
  X(res, nrow, "loop equations")                                                                   \
  X(rate, nrow, "their first derivative")                                                          \
  X(gam, nrow, "their second derivative with joint accelerations zero, with a minus")              \
  X(gama, nrow, "the same with joint accelerations as they are")                                   \
  X(y1, nrow, "right-hand sides of islands, one column")                                           \
  X(ab, nq, "dependent accelerations with independent ones zero")                                  \
  X(dq, nq, "correction of positions")                                                             \
  X(M, npair, "mass matrix by pairs")                                                              \
  X(tau, nq, "torques and forces of elements on coordinates")                                      \
  X(f, nq, "generalised forces")                                                                   \
  X(vcol, nqblock, "velocities of columns")                                                        \
  X(acol, nqblock, "accelerations of columns")                                                     \
  X(fr, nqblock, "reduced forces")                                                                 \
  X(spin, nwheel, "rates of coordinates at which wheels roll freely")                              \
  X(dinv, nq, "inverse pivots of the reduced mass matrix")                                         \
  X(drive, nq, "torques and forces of guides by columns")                                          \
  X(space, nq16, "work space of solves")                                                           \
  X(w, nq, "forces not balanced by inertia")                                                       \
  X(mu, nq, "least multipliers of the loops, by dependent coordinates")                            \
  X(lambda, nrow, "multipliers")                                                                   \
  X(piv0, nq, "pivots of islands when the dependents were chosen")                                 \
  X(piv1, nq, "the same of the choice before")                                                     \
  X(q0, nq, "Runge-Kutta: start of the step, positions")                                           \
  X(v0, nq, "velocities")                                                                          \
  X(a0, nq, "accelerations")                                                                       \
  X(dqs, nq, "sums of velocities")                                                                 \
  X(dus, nq, "sums of accelerations of columns")                                                   \
  X(qn, nq, "node from which the next step starts, positions")                                     \
  X(vn, nq, "velocities")                                                                          \
  X(an, nq, "accelerations")                                                                       \
  X(q1, nq, "Newton: position before a step")                                                      \
  X(y, nstate, "states of filters")                                                                \
  X(yrate, nstate, "their rates, by maggi_evaluate_filters")                                       \
  X(weighted, nfilter, "what filters say, by maggi_results")                                       \
  X(y0, nstate, "start of the step: states of filters")                                            \
  X(yrate0, nstate, "their rates")                                                                 \
  X(dys, nstate, "sums of their rates")                                                            \
  X(yn, nstate, "node from which the next step starts: states of filters")                         \
  X(yraten, nstate, "their rates")

/* what the plan sizes */
#define MAGGI_PLAN_VECTORS(X)                                                                      \
  X(phi, nphi, "blocks of Phi_d")                                                                  \
  X(chol, nchol, "factors of Phi_d^T Phi_d")                                                       \
  X(V, nvrow * 6 * t->stride, "velocities of bodies by columns")                                   \
  X(v1, nvrow * 6, "the same, one column")                                                         \
  X(G1, nvrow * 6, "wrenches of multipliers on these")                                             \
  X(Y, nrow * t->stride, "right-hand sides of islands by columns")                                 \
  X(R, nq * t->stride, "R_z")                                                                      \
  X(MR, nq * t->stride, "M R_z, part")                                                             \
  X(Mr, ncol * t->stride, "reduced mass matrix")                                                   \
  X(Ur, ncol * t->stride, "its factor")

#define MAGGI_RANK_TOLERANCE 1e-8
/* pivots of the loops relative to those at the choice of the independent coordinates, below which a
 * better choice is looked for */
#define MAGGI_RENEW_BELOW 0.2

typedef struct maggi_planner maggi_planner;
typedef struct maggi_equilibrium maggi_equilibrium;

static inline int maggi_is_independent(const maggi_topo *t, int q)
{
  return t->col[q] >= 0 && t->col[q] < t->nind;
}

/* what has been computed of a state besides its evaluation: nothing; accelerations of bodies; by maggi_balance;
 * all results */
enum { MAGGI_STALE, MAGGI_MOVED, MAGGI_BALANCED, MAGGI_FRESH };

/* a point of the integration: positions, velocities, accelerations of coordinates, states of filters and
 * their rates in the lists above */
typedef struct maggi_node {
  double time, work, power;
  double *q, *v, *a, *y, *yrate;
} maggi_node;

/* rows of coefficients of a state between two nodes: q, v, a by q, v, a of the start, then of the end; states
 * of filters by these and their rates, in columns 0, 1, 3, 4 */
enum { MAGGI_BETWEEN = 4 };

/* places that a node is copied between: `start`, `node`, the present state */
typedef enum maggi_place { MAGGI_START, MAGGI_NODE, MAGGI_PRESENT, MAGGI_PLACES } maggi_place;

/* Who follows a simulation step by step, to differentiate or to record it.  A step that a singular
 * position stops begins again. */
typedef struct maggi_follower maggi_follower;
struct maggi_follower {
  /* a Runge-Kutta step begins at `start` */
  void (*begin)(maggi_follower *f);
  /* after the evaluation of a stage at start + ahead * slopes of the one before, whose slopes count
   * `weight` sixths of the step */
  maggi_status (*stage)(maggi_follower *f, double weight, double ahead, double time);
  /* after the evaluation at the end of the step, to which loops have perhaps been projected */
  maggi_status (*end)(maggi_follower *f, double h, double time, int is_projected);
  /* after another evaluation there, with a new choice of coordinates */
  maggi_status (*renewed)(maggi_follower *f, double time);
  void (*copy)(maggi_follower *f, maggi_place to, maggi_place from);
  /* the present state is c (q, v, a of `start`; q, v, a of `node`), see maggi_between */
  void (*interpolate)(maggi_follower *f, const double c[MAGGI_BETWEEN][6]);
};

struct maggi_data {
  const maggi_model *m;
  maggi_topo t;
  maggi_planner *planner;
  double origin[3];
  double tolerance;
  double time;
  double power[1];                 /* of dampers, loads and drives */
  double kinetic[1], potential[1]; /* energies, by maggi_get_energy */
  double work;
  double
      rank_tolerance; /* smaller pivots, in the natural size of a loop, are redundant equations */
  double pivot_ratio; /* at the last step */
  double stage_ratio; /* at the last evaluation */
  maggi_node start;   /* of the last Runge-Kutta step: q0, v0, a0 */
  maggi_node node;    /* its end: qn, vn, an; later than the state of `time` if is_ahead */
  int is_ahead;
  maggi_follower *follower;       /* or NULL */
  int careless;                   /* steps still taken without care at singular positions */
  double replan_below;            /* pivot ratio at which a better choice is looked for */
  int ready;                      /* after a successful reset */
  maggi_equilibrium *equilibrium; /* at which a reset starts, or NULL */
  int is_settled;                 /* by reset: independent coordinates are where p says */
  int is_kept;     /* by reset: these were those of another plan, with MAGGI_KEEP_POSITION: */
  void *kept_plan; /* maggi_saved_plan */
  int fresh;       /* MAGGI_STALE, .. */
  long plans;      /* choices of coordinates so far */
  long changes, projections, evaluations;
  int *position_given, *velocity_given; /* (nq) */
#define X(name, rows, cols, text) double(*name)[cols];
  MAGGI_DATA_LIST(X)
#undef X
#define X(name, size, text) double *name;
  MAGGI_DATA_VECTORS(X)
  MAGGI_PLAN_VECTORS(X)
#undef X
#define X(name, size, text) size_t cap##name;
  MAGGI_PLAN_VECTORS(X)
#undef X
  char message[256];
};

maggi_status maggi_data_fail(maggi_data *d, maggi_status status, const char *format, ...);
/* room for what the plan sizes, zeroed; R of independent and guided coordinates */
maggi_status maggi_data_fit(maggi_data *d);

/* plan.c: which coordinates depend on which loops, and the lists of the kernel that follow.
 * avoid: MAGGI_AVOID_.. bits; threshold: how much smaller than the largest a pivot may be to keep
 * the structure fine. */
enum { MAGGI_AVOID_GIVEN = 1, MAGGI_KEEP_POSITION = 2 };
maggi_status maggi_planner_create(const maggi_model *m, maggi_planner **planner);
void maggi_planner_free(maggi_planner *planner);
void maggi_plan_restart(maggi_data *d); /* forget earlier choices */
maggi_status maggi_plan(maggi_data *d, int avoid, double threshold);
/* After an evaluation: its pivot ratio, and where the independent coordinates have become bad ones a better
 * plan if there is one.  *is_new says that the state must be evaluated again, by the plan that there is
 * now. */
maggi_status maggi_plan_watch(maggi_data *d, int *is_new);

/* What a plan follows from. */
typedef struct maggi_saved_plan {
  int *owner, *order; /* (nq), (nloop) */
  double *piv0;       /* (nq) */
} maggi_saved_plan;
size_t maggi_saved_plan_size(const maggi_topo *t); /* bytes */
/* lists in memory of that size, aligned for numbers */
void maggi_saved_plan_place(maggi_saved_plan *saved, const maggi_topo *t, void *memory);
void maggi_plan_save(const maggi_data *d, const maggi_saved_plan *saved);
int maggi_plan_is_saved(const maggi_data *d, const maggi_saved_plan *saved); /* the same choice */
maggi_status maggi_plan_load(maggi_data *d, const maggi_saved_plan *saved);

/* evaluate.c */
void maggi_constants(maggi_data *d);
void maggi_evaluate_positions(maggi_data *d, double time);
void maggi_evaluate_factors(maggi_data *d); /* of the loops, and how near they are to singular */
void maggi_evaluate(maggi_data *d, double time);       /* all, from q and vcol */
void maggi_evaluate_given(maggi_data *d, double time); /* what results need, from q, v and a */
int maggi_is_singular(const maggi_data *d); /* whether the last evaluation cannot be trusted */
void maggi_balance(maggi_data *d);          /* accelerations of bodies, forces, multipliers */
void maggi_results(maggi_data *d);          /* what is computed only on demand */
void maggi_evaluate_filters(maggi_data *d); /* rates of filters from the sensors of an evaluation */
double maggi_violation(const maggi_data *d); /* largest |Phi|, NAN if one is */
double maggi_smallest_pivot(const maggi_data *d, double *ratio, int *dep);
int maggi_worst_loop(const maggi_data *d);
/* column of Phi_z of entry i of the path of a building block's loop */
void maggi_path_entry(const maggi_data *d, int prim, int i, double e[3]);

/* project.c: drift control when the loops are open by more than the tolerance; the positions of `time` are
 * evaluated before and after.  Whether the accelerations of `time` can be trusted */
maggi_status maggi_project(maggi_data *d, double time);
maggi_status maggi_check(maggi_data *d, double time);

/* start.c.  Initial state, after a reset: address in p of the position that a coordinate was set to, -1 if none; those
 * of velocities of independent coordinates are m->initial_velocity.  Hold makes later resets choose these
 * independent coordinates.  Evaluation with the plan by which assembly closed the loops, which is_kept says
 * is another one, or with the final one; velocities of independent coordinates are those of `start`. */
int maggi_initial_position(const maggi_data *d, int q);
void maggi_hold_choice(maggi_data *d);
maggi_status maggi_evaluate_start(maggi_data *d, int is_kept);

/* Near what p says, loops closed by whatever coordinates are good for it, with a plan; after it, rates are
 * undefined. */
maggi_status maggi_assemble_guess(maggi_data *d);

/* core/sensitivity/equilibrium.c: static equilibrium, of which the Jacobian is a derivative, on a maggi_data of
 * the static twin of a model.  Find gives the positions of d, with the text of a failure there;
 * free(NULL) does nothing. */
maggi_status maggi_equilibrium_create(const maggi_model *twin, maggi_equilibrium **equilibrium);
void maggi_equilibrium_free(maggi_equilibrium *e);
maggi_status maggi_equilibrium_find(maggi_equilibrium *e, maggi_data *d);

/* integrate.c: state at the part s of a step of length H from those at its ends: q, v, a by the quintic, states
 * of filters by the cubic */
void maggi_between(double s, double H, double c[MAGGI_BETWEEN][6]);

/* snapshot.c: all that the next steps depend on */
typedef struct maggi_snapshot maggi_snapshot;
size_t maggi_snapshot_size(const maggi_topo *t); /* bytes, a multiple of that of a number */
void maggi_snapshot_save(const maggi_data *d, void *memory);
maggi_status maggi_snapshot_load(maggi_data *d, const void *memory);

#endif
