/* What functionals of a scalar have in common, by their types. */
#ifndef MAGGI_TERM_KIND_H
#define MAGGI_TERM_KIND_H

#include "maggi/maggi.h"

/* the power of s in the integral; 0: no such integral */
int maggi_term_power(maggi_objective_type type);
int maggi_term_is_mean(maggi_objective_type type);     /* over the window */
int maggi_term_is_root(maggi_objective_type type);     /* of an integral or a mean */
int maggi_term_is_extremum(maggi_objective_type type); /* at one place */
int maggi_term_has_times(maggi_objective_type type);   /* of its own */

#endif
