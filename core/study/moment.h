/* Weighted sums of powers of samples less an origin, which may be moved after the last one. */
#ifndef MAGGI_MOMENT_H
#define MAGGI_MOMENT_H

enum { MAGGI_MOMENTS = 5 };

typedef struct maggi_moments {
  int power;     /* of the sum that is wanted, 0: none */
  int can_shift; /* whether the origin will be moved */
  double origin; /* NAN: the first sample */
  double sum[MAGGI_MOMENTS];
} maggi_moments;

void maggi_moments_push(maggi_moments *m, double weight, double x);
void maggi_moments_shift(maggi_moments *m, double origin);

#endif
