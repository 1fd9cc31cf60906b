/* Checks of the tests in C: what fails is printed with file, line, values and error.
 *
 *   CHECK(ok)                     a condition
 *   CHECK_NEAR(a, b, rel, abs)    |a - b| <= abs + rel max(|a|, |b|); not finite fails
 *   CHECK_TEXT(a, b)              equal strings
 *   return check_done();          prints the count, 0 when all passed
 *
 * Environment: MAGGI_TOL_SCALE multiplies rel and abs (default 1).  With 0 the residual of every
 * CHECK_NEAR is printed and does not count.
 */
#ifndef MAGGI_TEST_CHECK_H
#define MAGGI_TEST_CHECK_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK(ok)                  check_true(__FILE__, __LINE__, #ok, !!(ok))
#define CHECK_NEAR(a, b, rel, abs) check_near(__FILE__, __LINE__, #a, a, b, rel, abs)
#define CHECK_TEXT(a, b)           check_text(__FILE__, __LINE__, #a, a, b)

enum { CHECK_SKIPPED = 77, CHECK_PRINT_MAX = 50 };

static long check_count, check_failed;

static inline const char *check_file(const char *file)
{
  const char *slash = strrchr(file, '/');

  return slash ? slash + 1 : file;
}

/* one failure; after the first few only counted */
static inline int check_fail(void)
{
  return ++check_failed <= CHECK_PRINT_MAX;
}

static inline int check_true(const char *file, int line, const char *text, int ok)
{
  ++check_count;
  if (!ok && check_fail()) fprintf(stderr, "%s:%d: not so: %s\n", check_file(file), line, text);
  return ok;
}

static inline double check_scale(void)
{
  static double scale = -1.0;
  const char *text;

  if (scale < 0.0) {
    text = getenv("MAGGI_TOL_SCALE");
    scale = text && *text ? strtod(text, NULL) : 1.0;
  }
  return scale;
}

static inline int check_near(const char *file, int line, const char *text, double a, double b,
                             double rel, double abs)
{
  double size = fabs(a) > fabs(b) ? fabs(a) : fabs(b), error = fabs(a - b);
  double limit = abs + rel * size;
  int ok = error <= check_scale() * limit;

  ++check_count;
  if (check_scale() == 0.0)
    printf("%s:%d: %s = %.17g, %.17g: error %.3g, limit %.3g\n", check_file(file), line, text, a, b,
           error, limit);
  else if (!ok && check_fail())
    fprintf(stderr, "%s:%d: %s = %.17g, should be %.17g: error %.3g, relative %.3g, limit %.3g\n",
            check_file(file), line, text, a, b, error, size > 0.0 ? error / size : 0.0,
            check_scale() * limit);
  return ok || check_scale() == 0.0;
}

static inline int check_text(const char *file, int line, const char *text, const char *a,
                             const char *b)
{
  int ok = a && b && strcmp(a, b) == 0;

  ++check_count;
  if (!ok && check_fail())
    fprintf(stderr, "%s:%d: %s =\n  %s\nshould be\n  %s\n", check_file(file), line, text,
            a ? a : "(null)", b ? b : "(null)");
  return ok;
}

static inline int check_done(void)
{
  if (check_failed > CHECK_PRINT_MAX)
    fprintf(stderr, "... and %ld more\n", check_failed - CHECK_PRINT_MAX);
  printf("%ld checks, %ld failed\n", check_count, check_failed);
  return check_failed != 0 || check_count == 0;
}

#endif
