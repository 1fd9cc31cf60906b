/* States at which derivatives of an evaluation are tested, and how numbers are compared there. */
#ifndef MAGGI_TESTS_STATE_H
#define MAGGI_TESTS_STATE_H

#include "derivative.h"
#include "property/mechanism.h"
#include "sample.h"

typedef struct state {
  const char *name; /* for messages */
  uint64_t seed;
  maggi_data *d;
  maggi_derivative *D; /* linearised */
  double time;
  mech_random random;
  int nq, np;
} state;

typedef void state_check(state *s);

/* Check on every mechanism: at the state of a simulation and, with other parameters, velocities and
 * time, away from where the loops are closed. */
void state_each(const report_options *options, state_check *check);

double *state_numbers(int n); /* zeros */
/* a random direction of n coordinates and of the parameters, these in their own size */
double *state_direction(state *s, int n);
/* one in which every entry of the gradient g counts as much, where it is not zero */
double *state_balanced(state *s, int n, const double *g);
double *state_weights(state *s, int n);
/* y.w; adds the sizes of the products to *terms */
double state_dot(int n, const double *a, const double *b, double *terms);

/* Near a singular position derivatives depend much on the last digits of the state: beside 1e-11 of its
 * size a derivative may be wrong by 1e-15 of its change per relative change of the state, measured with
 * a small one. */
#define STATE_TREMOR 1e-6
#define STATE_SHARE  1e-4

/* Largest difference, relative to the largest number of b; not a number if one of a is not.  shaken: b at
 * a state moved by STATE_TREMOR, or NULL. */
double state_distance(int n, const double *a, const double *b, const double *shaken);
void state_near(const state *s, const char *what, double residual, double limit);
/* an identity of sums, relative to their terms */
void state_near_sum(const state *s, const char *what, double left, double right, double terms,
                    double limit);

#endif
