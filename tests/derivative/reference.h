/* The heads, their adjoints and the evaluation of the equations of motion with complex numbers, for
 * derivatives by complex step: the imaginary part of f(x + i h x') over h is the derivative of f along
 * x', without cancellation.
 *
 * reference.c and reference_motion.c are compiled with `double` complex (complex_step.h); here
 * `double` does not occur, so that both sides read the same declarations.
 */
#ifndef MAGGI_TESTS_REFERENCE_H
#define MAGGI_TESTS_REFERENCE_H

#include <complex.h>
#undef I /* an inertia in the kernel */

#include "topo.h"

typedef long double _Complex reference_number;
typedef long double reference_real;

/* h: its square is nothing beside 1, its fourth power still a number */
#define REFERENCE_STEP 1e-40L

/* head of maggi_heads; arguments as in tools/tapenade/runtime/heads.h */
void reference_head(int head, const maggi_topo *t, reference_number *x[]);
void reference_adjoint(int head, const maggi_topo *t, reference_number *x[],
                       reference_number *xb[]);

/* core/dynamics/evaluate.c: a workspace that shares the integers of a simulation, plan included;
 * address of the origin in p as in maggi_model */
typedef struct reference_motion reference_motion;
reference_motion *reference_motion_create(const maggi_topo *t, int originadr);
void reference_motion_free(reference_motion *m);
/* array of the lists of data.h, NULL if none has the name */
reference_number *reference_motion_array(reference_motion *m, const char *name);
/* velocities and accelerations from p, q and vcol */
void reference_motion_stage(reference_motion *m, reference_number time);
/* the same and all results */
void reference_motion_evaluate(reference_motion *m, reference_number time);
/* all results from p, q, v and a of all coordinates */
void reference_motion_given(reference_motion *m, reference_number time);
/* Newton on the dependent coordinates until neither their values nor their derivatives change; whether
 * it comes to an end */
int reference_motion_close(reference_motion *m, reference_number time);
/* after one of the carriers' velocities: velocities of wheels that roll, "spin" */
void reference_motion_roll(reference_motion *m);
/* after one with all results: kinetic and potential energy */
void reference_motion_energy(reference_motion *m, reference_number energy[2]);

#endif
