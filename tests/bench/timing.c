#define _POSIX_C_SOURCE 200809L

#include "timing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static double seconds(clockid_t clock)
{
  struct timespec at;

  clock_gettime(clock, &at);
  return (double)at.tv_sec + 1e-9 * (double)at.tv_nsec;
}

double cpu_seconds(void)
{
  return seconds(CLOCK_THREAD_CPUTIME_ID);
}

double wall_seconds(void)
{
  return seconds(CLOCK_MONOTONIC);
}

static int by_value(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;

  return (x > y) - (x < y);
}

void sort_samples(int n, double samples[])
{
  qsort(samples, (size_t)n, sizeof *samples, by_value);
}

double quantile(int n, const double sorted[], double at)
{
  double place = at * (n - 1);
  int i = (int)place;

  if (n == 0)
    return NAN;
  if (i >= n - 1)
    return sorted[n - 1];
  return sorted[i] + (place - i) * (sorted[i + 1] - sorted[i]);
}

double log_slope(int n, const double x[], const double y[])
{
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  int i;

  for (i = 0; i < n; ++i) {
    sx += log(x[i]);
    sy += log(y[i]);
    sxx += log(x[i]) * log(x[i]);
    sxy += log(x[i]) * log(y[i]);
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double clock_mhz(void)
{
#if defined(__x86_64__) && defined(__GNUC__)
  enum { REPEATS = 20, CHAINS = 100000 };
  unsigned long x = 0;
  double begin, passed, best = INFINITY;
  int i, k;

  for (k = 0; k < REPEATS; ++k) {
    begin = cpu_seconds();
    for (i = 0; i < CHAINS; ++i) /* ten additions, one cycle each */
      __asm__ volatile("add $1, %0; add $1, %0; add $1, %0; add $1, %0; add $1, %0;"
                       "add $1, %0; add $1, %0; add $1, %0; add $1, %0; add $1, %0"
                       : "+r"(x));
    passed = cpu_seconds() - begin;
    best = passed < best ? passed : best;
  }
  return 1e-6 * 10.0 * CHAINS / best;
#else
  return NAN;
#endif
}

/* text after the colon of a line that begins with key */
static const char *value_of(const char *line, const char *key)
{
  const char *colon = strchr(line, ':');

  if (strncmp(line, key, strlen(key)) != 0 || !colon)
    return NULL;
  return colon + 1 + strspn(colon + 1, " \t");
}

void machine(int nmodel, char model[], double *mhz, int *processors)
{
  FILE *file = fopen("/proc/cpuinfo", "r");
  char line[512];
  const char *value;

  snprintf(model, (size_t)nmodel, "unknown");
  *mhz = NAN;
  *processors = (int)sysconf(_SC_NPROCESSORS_ONLN);
  if (!file)
    return;
  while (fgets(line, sizeof line, file)) {
    line[strcspn(line, "\n")] = '\0';
    value = value_of(line, "model name");
    if (value)
      snprintf(model, (size_t)nmodel, "%s", value);
    value = value_of(line, "cpu MHz");
    if (value && isnan(*mhz))
      *mhz = atof(value);
  }
  fclose(file);
}
