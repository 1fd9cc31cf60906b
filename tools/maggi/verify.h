/* Every method against every other on one model. */
#ifndef TOOL_VERIFY_H
#define TOOL_VERIFY_H

#include <stdio.h>

#include "study.h"

/* The gradients that are compared, in the order of the report. */
typedef enum trial_kind {
  TRIAL_ADJOINT, /* what the others are compared with                       */
  TRIAL_SNAPSHOTS,
  TRIAL_DIRECT,
  TRIAL_CONTINUOUS,
  TRIAL_DIFFERENCE,
  TRIAL_FORWARD,
  TRIAL_BACKWARD,
  TRIAL_COUNT
} trial_kind;

#define VERIFY_SNAPSHOTS     10 /* few                                  */
#define VERIFY_PERTURBATIONS 13 /* of differences: 1e-2, 1e-3 .. 1e-14 */

typedef struct trial {
  const char *name;
  int parameters;   /* the so many most relevant ones                          */
  double *gradient; /* (objectives x parameters of the study); NAN: not there  */
  double limit;     /* of the error                                            */
  double error;     /* from the adjoint, NAN: it failed                        */
  int objective;    /* where that is                                           */
  double wall;      /* [s]                                                     */
  char failure[512];
  int pass;
} trial;

typedef struct verify {
  study *study;
  double limit;           /* between direct and adjoint                              */
  int *order;             /* most relevant parameters first           (parameters)   */
  double *scale;          /* size of each parameter                   (parameters)   */
  double *size;           /* of each gradient, to which errors are relative (objectives) */
  double *value;          /* (objectives)                                            */
  double simulation_wall; /* [s]                                               */
  long steps, recomputed; /* of the adjoint with few snapshots                 */
  trial trial[TRIAL_COUNT];
  double perturbation_error[3][VERIFY_PERTURBATIONS]; /* centred, forward, backward */
  int best[3];       /* the perturbation with the smallest error             */
  double half_error; /* of the continuous adjoint with half the step         */
  double order_seen; /* at which that has fallen                             */
  double truncation; /* between the adjoints of the step and of half of it   */
  int pass;
} verify;

/* Compute all of it: exit status, after a message when it is neither STATUS_DONE nor
 * STATUS_INTERRUPTED; verify_free in either case.  study and limit are given, the rest is zero. */
int verify_run(verify *v);
void verify_free(verify *v);

/* From the adjoint: scale, size and order.  0, or -1 without memory. */
int verify_sizes(verify *v);

/* Relative difference of two gradients by the first n of the most relevant parameters, the largest of
 * all objectives; objective (may be NULL): which. */
double verify_distance(const verify *v, const double *a, const double *b, int n, int *objective);

double verify_perturbation(int k);

void verify_text(const verify *v, FILE *out);
void verify_json(const verify *v, FILE *out);

#endif
