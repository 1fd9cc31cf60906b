/* A part of the time of a simulation, whose ends may fall between its samples. */
#ifndef MAGGI_WINDOW_H
#define MAGGI_WINDOW_H

#include "quadrature.h"

typedef struct maggi_window {
  double length;     /* [s] */
  int is_whole;      /* all of the simulation */
  long first, last;  /* intervals of its ends */
  double begin, end; /* positions of the ends there, from the first node of the polynomial [h] */
  maggi_local initial, final; /* the polynomial at the ends */
} maggi_window;

/* from, to [s]: NAN where it begins or ends with the simulation */
void maggi_window_init(maggi_window *w, const maggi_nodes *x, const maggi_grid *grid, double from,
                       double to);
/* weight of node i in the integral of the polynomial over the window [s] */
double maggi_window_weight(const maggi_window *w, const maggi_nodes *x, long i);
/* Positions between which an interval is in the window; false: it is not. */
int maggi_window_part(const maggi_window *w, const maggi_nodes *x, long interval, double *begin,
                      double *end);
/* whether an end of the window that is none of the simulation is in an interval or next to it */
int maggi_window_edge(const maggi_window *w, long interval);
/* what node i weighs in a value of the polynomial */
double maggi_local_weight(const maggi_local *value, long i);

#endif
