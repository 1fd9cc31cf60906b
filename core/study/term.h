/* One functional of the samples of one scalar s: an objective without its signals, or a term of a sum. */
#ifndef MAGGI_TERM_H
#define MAGGI_TERM_H

#include "moment.h"
#include "slope.h"
#include "window.h"

typedef struct maggi_term {
  maggi_objective_type type; /* no sum */
  double target;
  double sharpness;
  maggi_reference_type reference;
  double from, to; /* NAN: ends of the simulation */
  int number;
  const double *times, *values; /* (number) */
  double *residual;             /* (number) of least_squares */

  /* of a pass */
  maggi_nodes nodes;
  maggi_window window;
  double recent[MAGGI_STENCIL]; /* the last nodes */
  maggi_moments moments;        /* of an integral; their origin: reference + target */
  double at;                    /* s at an end of the window: the reference, terminal */
  double pull;                  /* of the reference on the value, per unit */
  double sum;
  double top; /* smooth_maximum: largest sample so far */
  maggi_slope slope;
  int next;         /* of the times */
  maggi_local best; /* maximum, minimum, peak: where it is, */
  double sign;      /* and that of s there in the search for a maximum */
  double value;
} maggi_term;

/* whether the simulation reaches its times and its window; text, what is wrong (n) */
int maggi_term_reached(const maggi_term *f, const maggi_grid *grid, char *text, size_t n);
/* as those of maggi_objective in functional.h; r: what a slope is against, else not used */
void maggi_term_begin(maggi_term *f, const maggi_grid *grid);
void maggi_term_push(maggi_term *f, long k, double s, double r);
void maggi_term_end(maggi_term *f);
const char *maggi_term_no_derivative(const maggi_term *f); /* why, NULL: it has one */
/* derivative by s of sample k; *by_r: by r, set for a slope alone */
double maggi_term_weight(const maggi_term *f, long k, double s, double r, double *by_r);

#endif
