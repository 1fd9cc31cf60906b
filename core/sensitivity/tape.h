/* What a simulation leaves on the way, so that one can go back through it: the states at which the
 * equations of motion were evaluated, and what was decided.
 *
 * Step i goes from node i to node i + 1 with stages 0 .. 3, the first at node i.  Samples are taken after
 * the reset, or a snapshot, and after every maggi_step: at a node, or between two (maggi_between). */
#ifndef MAGGI_TAPE_H
#define MAGGI_TAPE_H

#include "data.h"

typedef struct maggi_tape_step {
  double time, h; /* of its node */
  int is_projected;
} maggi_tape_step;

typedef struct maggi_tape_sample {
  long steps;     /* so far */
  double time;    /* [s] */
  int is_between; /* the last two nodes, with the coefficients: */
  double c[MAGGI_BETWEEN][6];
  long given; /* which state between nodes */
} maggi_tape_sample;

/* Another choice of the independent coordinates at a node, after what the tape has as its state. */
typedef struct maggi_tape_change {
  long node;
  void *plan; /* the choice before, maggi_saved_plan */
  double *u;  /* velocities of its independent coordinates */
} maggi_tape_change;

typedef struct maggi_tape {
  maggi_follower follower; /* first: the two addresses are one */
  maggi_data *d;
  size_t size;           /* numbers of a state: positions, independent velocities, filters */
  long at[MAGGI_PLACES]; /* nodes of the places */
  long nstep, nsample, ngiven, nchange; /* on the tape; its last node is nstep */
  long capstate, capstep, capsample, capgiven, capchange;
  double *state;             /* (capstate x 4 x size) */
  maggi_tape_step *step;     /* (capstep) */
  maggi_tape_sample *sample; /* (capsample) */
  double *given; /* (capgiven x maggi_tape_given_size) states between nodes: q, v, a, y */
  maggi_tape_change *change; /* (capchange) */
  void *plan;                /* the choice when the tape last looked */
  long plans;                /* d->plans then */
  int stage;                 /* of the step at work */
} maggi_tape;

size_t maggi_tape_step_size(const maggi_data *d); /* bytes of a step */

/* An empty tape, or MAGGI_E_MEMORY; free(NULL) does nothing. */
maggi_status maggi_tape_create(maggi_data *d, maggi_tape **tape);
void maggi_tape_free(maggi_tape *tape);
/* Begin anew at the present state, with its sample.  When that lies between two nodes these are the first
 * two, with a step between them that is not on the tape. */
maggi_status maggi_tape_begin(maggi_tape *tape);
/* maggi_step, and its sample. */
maggi_status maggi_tape_advance(maggi_tape *tape, double h);

static inline const double *maggi_tape_state(const maggi_tape *tape, long step, int stage)
{
  return tape->state + ((size_t)step * 4 + (size_t)stage) * tape->size;
}

static inline size_t maggi_tape_given_size(const maggi_topo *t)
{
  return 3 * (size_t)t->nq + (size_t)t->nstate;
}

/* d->q, d->vcol and d->y from a state */
void maggi_tape_load(const maggi_tape *tape, const double *state);

#endif
