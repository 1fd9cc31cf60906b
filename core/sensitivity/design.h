/* Design parameters as linear maps onto the parameters p: directions forward, gradients back. */
#ifndef MAGGI_DESIGN_H
#define MAGGI_DESIGN_H

#include "maggi/maggi.h"

/* Directions dp/db of the design parameters first .. first + n - 1, as the first columns of
 * out (np x ld), which is zeroed here. */
void maggi_design_directions(const maggi_design *g, int first, int n, int ld, double *out);
/* Gradient by the design parameters, out (number), of a gradient by p. */
void maggi_design_pull(const maggi_design *g, const double *p_bar, double *out);

#endif
