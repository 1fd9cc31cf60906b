/* A simulation and beside it the same with complex numbers (reference.h): what maggi_data_reset and
 * maggi_step compute, written anew.  The real one only says what it chose: the independent coordinates,
 * lengths of Runge-Kutta steps, when it projected.  The complex one has the derivatives of the whole
 * simulation along one direction of the parameters, by complex step. */
#ifndef MAGGI_TESTS_REPLAY_H
#define MAGGI_TESTS_REPLAY_H

#include "data.h"
#include "reference.h"

typedef struct replay replay;

/* a simulation of its own with parameters and tolerance as in d */
maggi_data *replay_copy(const maggi_data *d);

/* At the state after maggi_data_reset of a copy of d.  x: direction of the parameters.  NULL after a
 * failure, and where the independent coordinates are not at their initial positions. */
replay *replay_create(const maggi_data *d, const double *x);
void replay_free(replay *r);
maggi_status replay_step(replay *r, double h);

/* the real one, and how often the complex one changed its independent coordinates, closed its loops,
 * was between two nodes, took a step in parts */
maggi_data *replay_data(const replay *r);
typedef struct replay_counts {
  long changes, closures, between, parts;
} replay_counts;
replay_counts replay_count(const replay *r);

/* Present values of all signals (maggi.h), in their order: q, v, a of each coordinate; kinetic, potential,
 * total energy; reactions; sensors; filters. */
int replay_number(const replay *r);
void replay_values(replay *r, reference_number *values);

#endif
