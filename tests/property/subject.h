/* A random mechanism in the library: model, simulation, and views on its inside that the tests
 * need.  All coordinates and bodies are in the order of the description. */
#ifndef MAGGI_TESTS_SUBJECT_H
#define MAGGI_TESTS_SUBJECT_H

#include "mechanism.h"

#ifdef __cplusplus
extern "C" {
#endif

/* closed to round-off, so that two ways to write a closed loop agree; 1e-10 is the default */
#define SUBJECT_TOLERANCE 1e-13

typedef struct subject {
  mechanism m;
  maggi_model *model;
  maggi_data *data;
  int q[MECH_COORDINATES]; /* index in the model */
  int body[MECH_BODIES];
} subject;

/* A mechanism that moves, with random velocities at t = 0; 0 after a failure, which is reported.
 * Mechanisms that cannot move, are close to singular or forced by guides are made anew and
 * counted. */
int subject_create(uint64_t seed, subject *s);
/* model and simulation of s->m; 0 after a failure, which is reported */
int subject_build(subject *s, mech_random *shuffle);
void subject_free(subject *s);

/* 0 and a line on stderr after a failure */
int subject_reset(subject *s);
int subject_set(subject *s, double t, const double *q, const double *v);
void subject_get(const subject *s, double *q, double *v, double *a);
int subject_steps(subject *s, int n, double h); /* 0 after a failure, which is reported */

/* columns of R_z: ncol of them, nq x ncol row major; the first ones are independent, then guided */
int subject_columns(const subject *s);
void subject_velocity_columns(const subject *s, double *R);
/* reduced mass matrix, ncol x ncol, from the upper half that the library keeps */
void subject_reduced_mass(const subject *s, double *M);
/* Phi_z, rows x nq; returns the number of rows; rows NULL: only that */
int subject_jacobian(const subject *s, double *phi);
/* wrench on body a at its point (force, moment; global axes) that the multipliers of a loop, as
 * documented, stand for; rods: axial force in [0] */
void subject_loop_wrench(subject *s, int loop, double wrench[6]);

#ifdef __cplusplus
}
#endif

#endif
