/* Maximum of the polynomial through n values f at the positions u, between a and b, which are few
 * intervals of its nodes apart. */
#ifndef MAGGI_EXTREMUM_H
#define MAGGI_EXTREMUM_H

/* Value; *where is its position: at a, at b, or a zero of the derivative to the last digits. */
double maggi_local_maximum(int n, const double *u, const double *f, double a, double b,
                           double *where);

#endif
