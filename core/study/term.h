/* One functional of the samples of one scalar s: an objective without its signals, or a term of a sum. */
#ifndef MAGGI_TERM_H
#define MAGGI_TERM_H

#include "quadrature.h"

typedef struct maggi_term {
  maggi_objective_type type; /* no sum */
  double target;
  double sharpness;
  int number;
  const double *times, *values; /* (number) */
  double *residual;             /* (number) of least_squares */

  /* of a pass */
  maggi_nodes nodes;
  long steps;
  double time;
  double recent[MAGGI_STENCIL]; /* the last nodes */
  double sum;
  double top;       /* smooth_maximum: largest sample so far */
  int next;         /* of the times */
  maggi_local best; /* maximum, minimum, peak: where it is, */
  double sign;      /* and that of s there in the search for a maximum */
  double value;
} maggi_term;

int maggi_term_reached(const maggi_term *f, const maggi_grid *grid); /* whether its times are */
/* as those of maggi_objective in functional.h */
void maggi_term_begin(maggi_term *f, const maggi_grid *grid);
void maggi_term_push(maggi_term *f, long k, double s);
void maggi_term_end(maggi_term *f);
const char *maggi_term_no_derivative(const maggi_term *f); /* why, NULL: it has one */
double maggi_term_weight(const maggi_term *f, long k, double s);

#endif
