/* The kernel and its derivatives once more with complex numbers: included before everything else in
 * each of these sources, the system headers before `double` changes its meaning.
 *
 * Numbers are long double, so that the round-off of the reference is below that of what it judges.
 * Imaginary parts are so small (reference.h) that only their first power counts; fabs, atan2 and pow,
 * which have no analytic or no accurate form in <complex.h>, are written to that order. */
#ifndef MAGGI_TESTS_COMPLEX_STEP_H
#define MAGGI_TESTS_COMPLEX_STEP_H

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"
/* by CMake: reference_NAME for each function maggi_NAME, whose own names are those of real numbers */
#include "reference_names.h"

static inline reference_number step_fabs(reference_number x)
{
  return creall(x) < 0.0L ? -x : x;
}

static inline reference_number step_atan2(reference_number y, reference_number x)
{
  long double a = creall(y), b = creall(x);

  return atan2l(a, b) + _Complex_I * ((b * cimagl(y) - a * cimagl(x)) / (a * a + b * b));
}

static inline reference_number step_pow(reference_number x, reference_number n)
{
  long double a = creall(x), b = creall(n), im = 0.0L;

  if (b != 0.0L) im += b * powl(a, b - 1.0L) * cimagl(x);
  if (cimagl(n) != 0.0L) im += powl(a, b) * logl(a) * cimagl(n);
  return powl(a, b) + _Complex_I * im;
}

#undef isnan
#undef isfinite
#define MAGGI_COMPLEX
#define MAGGI_RE(x) creall(x)
#define double long double _Complex
#define isnan(x)    __builtin_isnan(creall(x))
#define isfinite(x) __builtin_isfinite(creall(x))
#define sin(x)      csinl(x)
#define cos(x)      ccosl(x)
#define tan(x)      ctanl(x)
#define asin(x)     casinl(x)
#define acos(x)     cacosl(x)
#define atan(x)     catanl(x)
#define sinh(x)     csinhl(x)
#define cosh(x)     ccoshl(x)
#define tanh(x)     ctanhl(x)
#define exp(x)      cexpl(x)
#define log(x)      clogl(x)
#define sqrt(x)     csqrtl(x)
#define fabs(x)     step_fabs(x)
#define atan2(y, x) step_atan2(y, x)
#define pow(x, n)   step_pow(x, n)

#endif
