/* An objective: a sum of weights times functionals, of which most objectives have one. */
#ifndef MAGGI_OBJECTIVE_H
#define MAGGI_OBJECTIVE_H

#include "arena.h"
#include "term.h"

/* weight times a functional of one signal, or of a function of several */
typedef struct maggi_summand {
  const char *name;
  double weight;
  maggi_term term;
  int nsignal;
  int *slot;   /* (nsignal) among the signals of the objective */
  int against; /* slot of the other signal of a slope; else one of them */
  maggi_signal_function function;
  void *context;
} maggi_summand;

struct maggi_objective {
  const maggi_model *m;
  maggi_arena arena;
  const char *name, *unit;
  int nsignal;
  int *signal;
  int nsummand;
  maggi_summand *summand;
  double *arguments, *gradient; /* (nsignal) of a function */
  maggi_grid grid;
};

#endif
