/* Residuals of the property tests: each is compared with its limit, the worst of each kind is kept
 * with its seed, a failure prints seed and what failed.
 *
 * Environment: MAGGI_TOL_SCALE multiplies the limits (default 1); with 0 every residual is printed
 * and none counts.
 */
#ifndef MAGGI_TESTS_REPORT_H
#define MAGGI_TESTS_REPORT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct report_options {
  uint64_t from; /* first seed */
  long count;    /* number of seeds */
  int verbose;   /* say what each seed is */
} report_options;

/* --seed N, --from N, --count N, --verbose; returns 0 and explains itself on anything else */
int report_parse(int argc, char **argv, report_options *options);

/* residual <= limit; NAN fails; returns whether it passes */
int report_near(uint64_t seed, const char *what, double residual, double limit);
int report_true(uint64_t seed, const char *what, int ok);
/* something to be counted, neither good nor bad */
void report_count(const char *what);

/* table of all residuals and counts; exit status of the program */
int report_done(const char *program);

#ifdef __cplusplus
}
#endif

#endif
