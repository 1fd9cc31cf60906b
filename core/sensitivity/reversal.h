/* Going back through a simulation with adjoints: what the discrete and the continuous method share.
 * FORMULATION 9, [1] 5.4.
 *
 * A lane is one scalar whose gradient is wanted; all lanes share the evaluations.  At a node its adjoints
 * are those of the state, positions and independent velocities, and those of what the evaluation there
 * computes, all velocities and accelerations.  The evaluation is gone back through once: with the slopes
 * of the step that begins there and with the sample that is taken there. */
#ifndef MAGGI_REVERSAL_H
#define MAGGI_REVERSAL_H

#include "derivative.h"
#include "tape.h"

/* adjoints of a lane, (nq) each */
#define MAGGI_LANE_LIST(X)                                                                         \
  X(q)  /* at the node that was reached: positions */                                              \
  X(u)  /* velocities of independent coordinates */                                                \
  X(v)  /* what the evaluation computes: velocities */                                             \
  X(a)  /* accelerations */                                                                        \
  X(q0) /* the same at the node before */                                                          \
  X(v0)                                                                                            \
  X(a0)                                                                                            \
  X(dq) /* of a stage */                                                                           \
  X(du)                                                                                            \
  X(qsum)                                                                                          \
  X(usum)

/* of states of filters, (nstate) each */
#define MAGGI_LANE_FILTER_LIST(X)                                                                  \
  X(y)     /* at the node */                                                                       \
  X(yrate) /* of their rates, which the evaluation computes */                                     \
  X(y0)    /* the same at the node before */                                                       \
  X(yrate0)                                                                                        \
  X(dy) /* of a stage */                                                                           \
  X(ysum)

typedef struct maggi_lane {
#define X(name) double *name;
  MAGGI_LANE_LIST(X)
  MAGGI_LANE_FILTER_LIST(X)
#undef X
  double *constants; /* adjoints of what depends on p alone */
} maggi_lane;

/* Derivatives of a lane's scalar by the signals of sample k, at which d is evaluated: how many, 0 if all are
 * zero.  `of` is the first member of what knows the answer. */
typedef struct maggi_seeds maggi_seeds;
struct maggi_seeds {
  int (*of)(maggi_seeds *s, int lane, long k, const int **signal, const double **weight);
};

typedef struct maggi_reversal {
  maggi_data *d;
  maggi_derivative *D;
  maggi_seeds *seeds;
  int is_continuous;
  unsigned need; /* of rates of filters */
  int n;         /* lanes */
  maggi_lane *lane;
  double *memory, *constants;
} maggi_reversal;

/* status MAGGI_OK, MAGGI_E_MEMORY; after a reset of d; free(NULL) does nothing */
maggi_status maggi_reversal_create(maggi_data *d, int n, maggi_seeds *seeds, int is_continuous,
                                   maggi_reversal **reversal);
void maggi_reversal_free(maggi_reversal *r);

/* Back from sample j of the tape to the one before, which is not counted yet; k is the number of sample j
 * in the simulation.  d stands at the end of the tape at first. */
maggi_status maggi_reversal_step(maggi_reversal *r, maggi_tape *tape, long j, long k);
/* Sample k at a state given as q, v, a, y, which is c (q, v, a of the node before; q, v, a of the one that was
 * reached), see maggi_between. */
maggi_status maggi_reversal_sample(maggi_reversal *r, const double *given, double time, long k,
                                   const double c[MAGGI_BETWEEN][6]);
/* The sample at the start of the simulation, which is the first of the tape, and the initial state. */
maggi_status maggi_reversal_finish(maggi_reversal *r, maggi_tape *tape);
/* gradients by p, after the end (np) */
void maggi_reversal_gradient(maggi_reversal *r, int lane, double *p);

/* discrete.c, continuous.c: from node i + 1, whose evaluation has been gone back through, to node i */
maggi_status maggi_discrete_step(maggi_reversal *r, const maggi_tape *tape, long i);
maggi_status maggi_continuous_step(maggi_reversal *r, const maggi_tape *tape, long i);
/* Both: the adjoint of the stages of step i, each with the evaluation and linearisation that `evaluate`
 * makes for it, for stage 3, 2, 1 in turn. */
typedef maggi_status maggi_stage_evaluation(maggi_reversal *r, const maggi_tape *tape, long i,
                                            int stage);
maggi_status maggi_reversal_stages(maggi_reversal *r, const maggi_tape *tape, long i,
                                   maggi_stage_evaluation *evaluate);

/* evaluation and linearisation at a state of the tape */
maggi_status maggi_reversal_evaluate(maggi_reversal *r, const maggi_tape *tape, const double *state,
                                     double time);
/* D->adjoint for a lane: zero but for the constants, which go on; v and a as given (nq) */
void maggi_reversal_choose(maggi_reversal *r, const maggi_lane *lane, const double *v,
                           const double *a);
/* Before maggi_adjoint_motion: back through the rates of filters, whose adjoints are lane->yrate, and through
 * results with the adjoints of D->adjoint that `need` names.  Adjoints of y are then in D->adjoint.y. */
void maggi_reversal_results(maggi_reversal *r, const maggi_lane *lane, unsigned need);

#endif
