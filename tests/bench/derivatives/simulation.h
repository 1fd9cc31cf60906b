/* A simulation by the penalty formulation, with one of the ways to the Jacobian of the forces. */
#ifndef BENCH_SIMULATION_H
#define BENCH_SIMULATION_H

#include "chain_tape.h"
#include "penalty.h"
#include "thesis.h"

typedef struct way {
  const char *name;
  maggi_jacobian library; /* the way of the library, or that with the same places and directions */
  int is_taped;           /* by ADOL-C */
  double tolerance; /* of its Jacobian against tangents by colours, relative to the largest entry */
  int column;       /* of the thesis, -1: none */
} way;

extern const way ways[];
extern const int nway, nlibrary, reference; /* all; without ADOL-C; tangents by colours */

typedef struct simulation {
  const way *of;
  maggi_data *d;
  maggi_penalty *s;
  struct taped *taped; /* NULL: library */
} simulation;

/* what a simulation from the start on has been */
typedef struct course {
  int steps;
  double seconds, drift; /* extreme of the change of energy, relative to that at the start */
  long jacobians, iterations;
} course;

/* after a reset; the tape stays that of the caller */
int simulation_open(simulation *x, const way *of, const maggi_model *m, chain_tape *recorded);
void simulation_close(simulation *x);
int simulation_coordinates(const simulation *x); /* that are not guided */
int simulation_directions(const simulation *x);  /* of a Jacobian, adjoints: rows */
/* the state as a tape begins there; NULL for models with functions of time */
chain_tape *simulation_record(const simulation *x);

/* From the start on; seconds are those of the steps, without the reset.  false with a line on stderr */
int simulation_run(simulation *x, double h, int steps, course *c);
/* the same with energies, and `n` states on the way: time, q, v, one after the other */
int simulation_follow(simulation *x, double h, int steps, course *c, int n, double *states);
size_t simulation_state_size(const simulation *x); /* numbers of a state */
/* the Jacobian at a state: (entries) in the order of the pattern */
const double *simulation_jacobian(simulation *x, const double *state);

int complain(const char *what, const char *why); /* false */

#endif
