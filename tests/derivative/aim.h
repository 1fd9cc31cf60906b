/* Objectives of a simulation with complex numbers (reference.h): what core/study computes, written anew. */
#ifndef MAGGI_TESTS_AIM_H
#define MAGGI_TESTS_AIM_H

#include "maggi/maggi.h"
#include "reference.h"

/* samples that an integral between two of them is made of; times of an objective */
enum { AIM_SAMPLES = 6, AIM_TIMES = 3 };

/* An objective of one signal, or of the product of two. */
typedef struct aim {
  maggi_objective_def def;
  int signal[2];
  const char *name[2];
  double times[AIM_TIMES], values[AIM_TIMES];
  maggi_objective *objective;
} aim;

/* Values of all signals at the ends of all steps, steps + 1 times. */
typedef struct trace {
  double step;
  long steps;
  int nsignal;
  const reference_number *values;
} trace;

reference_number aim_outcome(const aim *a, const trace *s);

#endif
