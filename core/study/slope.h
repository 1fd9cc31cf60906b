/* Slope of the straight line that fits s over r best, from weighted samples of both. */
#ifndef MAGGI_SLOPE_H
#define MAGGI_SLOPE_H

typedef struct maggi_slope {
  int n;                  /* samples */
  double s0, r0;          /* the first: sums are those of differences from it */
  double w, s, r, rs, rr; /* sums of weights, w s, w r, w r s, w r^2 */
  double value, spread;   /* spread: w rr - r^2 */
} maggi_slope;

void maggi_slope_begin(maggi_slope *f);
void maggi_slope_push(maggi_slope *f, double weight, double s, double r);
/* the slope; NAN when r is the same in all samples */
double maggi_slope_end(maggi_slope *f);
/* its derivatives by the two values of a sample */
void maggi_slope_weight(const maggi_slope *f, double weight, double s, double r, double *by_s,
                        double *by_r);

#endif
