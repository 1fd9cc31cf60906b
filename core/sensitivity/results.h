/* Derivatives of signals at a state: by the motion of its evaluation, or with positions, velocities
 * and accelerations given.
 *
 * All on D after maggi_linearise_at.  Signals are numbered as in maggi.h.  `need` is what
 * maggi_signals_need says of the signals that are read or seeded; the others are not meaningful.
 */
#ifndef MAGGI_RESULTS_H
#define MAGGI_RESULTS_H

#include "derivative.h"

/* what signals need besides positions, velocities and accelerations of coordinates */
enum {
  MAGGI_RESULT_ACCELERATION = 1, /* accelerations of bodies and points */
  MAGGI_RESULT_FORCE = 2,        /* multipliers and reactions */
  MAGGI_RESULT_ENERGY = 4,
  MAGGI_RESULT_SENSOR = 8,  /* any sensor */
  MAGGI_RESULT_FILTER = 16, /* what filters say */
  MAGGI_RESULT_RATE = 32    /* rates of filters */
};

unsigned maggi_signals_need(const maggi_model *m, int n, const int *signal);
/* what rates of filters need, with MAGGI_RESULT_RATE; 0 without filters */
unsigned maggi_filters_need(const maggi_model *m);

/* Tangents, in D->strip.  results_strip.c
 *
 * given    at a state of maggi_evaluate or maggi_evaluate_given, whose tangents of q, v, a and y are in
 *          D->strip; those of guided coordinates follow from their functions
 * results  after maggi_strip_motion
 */
void maggi_strip_given(maggi_derivative *D, unsigned need);
void maggi_strip_results(maggi_derivative *D, unsigned need);
/* tangents of n signals after it, out[n][MAGGI_NDIR] */
void maggi_signals_strip(const maggi_derivative *D, int n, const int *signal, double *out);

/* Adjoints, in D->adjoint.  results_adjoint.c
 *
 * seed     adds weight[n] to the adjoints of n signals, after maggi_companion_clear
 * results  carries them to where maggi_adjoint_motion starts or adds to, and to those of y; adjoints of
 *          q, v, a may be added to D->adjoint.q, v, a before or after it, of yrate before it
 * given    at a state of maggi_evaluate_given: complete adjoints of q, v, a of all coordinates, zero
 *          of guided ones, of y and of the constants
 */
void maggi_signals_seed(maggi_derivative *D, int n, const int *signal, const double *weight);
void maggi_adjoint_results(maggi_derivative *D, unsigned need);
void maggi_adjoint_given(maggi_derivative *D, unsigned need);

#endif
