/* Newton's method on the loops, of which assembly and drift control are made. */
#ifndef MAGGI_CLOSING_H
#define MAGGI_CLOSING_H

#include "data.h"

enum { MAGGI_CLOSING_ITERATIONS = 20 }; /* from a position that is nearly closed */

/* corrections dq of the dependent coordinates, from the residual and the factors that there are */
void maggi_close_step(maggi_data *d);
double maggi_close_size(const maggi_data *d); /* the largest of them, NAN if one is */
void maggi_close_begin(maggi_data *d);        /* corrections count from the present position */
void maggi_close_move(maggi_data *d, double factor);

double maggi_largest_length(const maggi_data *d);           /* of the model, at least 1 m */
double maggi_roundoff(const maggi_data *d);                 /* of the loop equations */
const char *maggi_loop_word(const maggi_data *d, int loop); /* "rod" or "loop" */
const char *maggi_name_of(const maggi_data *d, int q);      /* of an internal coordinate */

/* assemble.c: from the position in q; the independent coordinates to where that began, false where the loops
 * do not close there */
maggi_status maggi_assemble(maggi_data *d, double time, int avoid);
int maggi_settle(maggi_data *d, double time);

#endif
