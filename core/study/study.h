/* A gradient at work: the simulation, the objectives and their samples. */
#ifndef MAGGI_STUDY_H
#define MAGGI_STUDY_H

#include "data.h"
#include "design.h"
#include "functional.h"
#include "penalty.h"

typedef struct maggi_study {
  maggi_data *d;
  const maggi_design *design;
  int n; /* objectives */
  maggi_objective *const *objective;
  maggi_gradient_options *options;
  maggi_grid grid;
  maggi_penalty *penalty;   /* NULL: maggi_step */
  double *value, *gradient; /* (n), (n x design parameters) */
  int nsignal;              /* of all objectives, one after the other */
  int *signal;
  int *first;              /* of an objective (n + 1) */
  double *sample, *weight; /* (nsignal) */
  double begin, share;     /* of the progress: what is done, what the work at hand adds */
} maggi_study;

/* The objectives from the present state on, sample by sample; text in maggi_data_message. */
maggi_status maggi_study_begin(maggi_study *s);
void maggi_study_push(maggi_study *s, long k); /* sample k of the present state */
maggi_status maggi_study_end(maggi_study *s);
/* one simulation, maggi_study_begin to _end */
maggi_status maggi_study_simulate(maggi_study *s);
/* length of the step from sample k to the next; the step itself */
double maggi_study_step(const maggi_study *s, long k);
maggi_status maggi_study_advance(maggi_study *s, long k);
/* status MAGGI_E_STOPPED if the user wants no more; done: part of the work at hand */
maggi_status maggi_study_progress(maggi_study *s, double done);
/* Derivatives of objective i by sample k, whose signals are in s->sample: number, 0 if all are zero. */
int maggi_study_weights(maggi_study *s, int i, long k, const int **signal, const double **weight);
/* whether all objectives have derivatives */
maggi_status maggi_study_differentiable(maggi_study *s);

/* gradients by the design parameters from the lanes of a reversal; p (np) is work space */
void maggi_study_gather(maggi_study *s, maggi_reversal *r, double *p);

maggi_status maggi_gradient_direct(maggi_study *s);
maggi_status maggi_gradient_adjoint(maggi_study *s);
maggi_status maggi_gradient_penalty_adjoint(maggi_study *s);
maggi_status maggi_gradient_difference(maggi_study *s);

#endif
