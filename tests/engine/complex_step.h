/* The same C once more with complex numbers: this header is included before everything else, the
 * system headers before `double` changes its meaning.
 *
 * The imaginary parts are so small that only their first power counts; fabs, atan2 and pow, which
 * have no analytic or no accurate form in <complex.h>, are written to that order. */
#ifndef COMPLEX_STEP_H
#define COMPLEX_STEP_H

#include <complex.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static inline double _Complex step_fabs(double _Complex x)
{
  return creal(x) < 0.0 ? -x : x;
}

static inline double _Complex step_atan2(double _Complex y, double _Complex x)
{
  double a, b;

  a = creal(y);
  b = creal(x);
  return __builtin_complex(atan2(a, b), (b * cimag(y) - a * cimag(x)) / (a * a + b * b));
}

static inline double _Complex step_pow(double _Complex x, double _Complex n)
{
  double a, b, im;

  a = creal(x);
  b = creal(n);
  im = b == 0.0 ? 0.0 : b * pow(a, b - 1.0) * cimag(x);
  if (cimag(n) != 0.0) im += pow(a, b) * log(a) * cimag(n);
  return __builtin_complex(pow(a, b), im);
}

#define MAGGI_COMPLEX
#define MAGGI_RE(x) creal(x)
#define double double _Complex
#define sin(x) csin(x)
#define cos(x) ccos(x)
#define tan(x) ctan(x)
#define asin(x) casin(x)
#define acos(x) cacos(x)
#define atan(x) catan(x)
#define sinh(x) csinh(x)
#define cosh(x) ccosh(x)
#define tanh(x) ctanh(x)
#define exp(x) cexp(x)
#define log(x) clog(x)
#define sqrt(x) csqrt(x)
#define fabs(x) step_fabs(x)
#define atan2(y, x) step_atan2(y, x)
#define pow(x, n) step_pow(x, n)

#endif
