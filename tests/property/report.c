#include "report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { KINDS_MAX = 80, PRINT_MAX = 60 };

typedef struct line {
  const char *what;
  double limit, worst;
  uint64_t seed;
  long count, failed;
} line;

static line table[KINDS_MAX];
static int ntable;
static long failures;

static double scale(void)
{
  const char *text = getenv("MAGGI_TOL_SCALE");

  return text && *text ? strtod(text, NULL) : 1.0;
}

int report_parse(int argc, char **argv, report_options *options)
{
  char *end;
  int i;

  for (i = 1; i < argc; ++i) {
    if (strcmp(argv[i], "--verbose") == 0) {
      options->verbose = 1;
      continue;
    }
    if (i + 1 < argc && strcmp(argv[i], "--seed") == 0) {
      options->from = strtoull(argv[++i], &end, 10);
      options->count = 1;
      options->verbose = 1;
    } else if (i + 1 < argc && strcmp(argv[i], "--from") == 0) {
      options->from = strtoull(argv[++i], &end, 10);
    } else if (i + 1 < argc && strcmp(argv[i], "--count") == 0) {
      options->count = strtol(argv[++i], &end, 10);
    } else {
      fprintf(stderr, "usage: %s [--seed N] [--from N] [--count N] [--verbose]\n", argv[0]);
      return 0;
    }
    if (*end != '\0') {
      fprintf(stderr, "%s: \"%s\" is not a number\n", argv[0], argv[i]);
      return 0;
    }
  }
  return 1;
}

static line *find(const char *what, double limit)
{
  int i;

  for (i = 0; i < ntable; ++i)
    if (strcmp(table[i].what, what) == 0)
      return &table[i];
  if (ntable == KINDS_MAX)
    abort();
  table[ntable].what = what;
  table[ntable].limit = limit;
  table[ntable].worst = -1.0;
  return &table[ntable++];
}

int report_near(uint64_t seed, const char *what, double residual, double limit)
{
  line *l = find(what, limit);
  int ok = residual <= limit * scale();

  ++l->count;
  if (!(residual <= l->worst)) {
    l->worst = residual;
    l->seed = seed;
  }
  if (scale() == 0.0) {
    printf("seed %llu: %s: residual %.3g, limit %.3g\n", (unsigned long long)seed, what, residual,
           limit);
    return 1;
  }
  if (!ok) {
    ++l->failed;
    if (++failures <= PRINT_MAX)
      fprintf(stderr, "seed %llu: %s: residual %.3g exceeds %.3g\n", (unsigned long long)seed, what,
              residual, limit * scale());
  }
  return ok;
}

int report_true(uint64_t seed, const char *what, int ok)
{
  line *l = find(what, 0.0);

  ++l->count;
  if (!ok) {
    ++l->failed;
    l->seed = seed;
    if (++failures <= PRINT_MAX)
      fprintf(stderr, "seed %llu: not so: %s\n", (unsigned long long)seed, what);
  }
  return ok;
}

void report_count(const char *what)
{
  ++find(what, -1.0)->count;
}

int report_done(const char *program)
{
  int i;

  printf("%-62s %7s %9s %9s %8s %6s\n", program, "count", "worst", "limit", "seed", "failed");
  for (i = 0; i < ntable; ++i) {
    const line *l = &table[i];

    if (l->limit < 0.0)
      printf("%-62s %7ld\n", l->what, l->count);
    else if (l->worst < 0.0)
      printf("%-62s %7ld %9s %9s %8s %6ld\n", l->what, l->count, "", "", "", l->failed);
    else
      printf("%-62s %7ld %9.2g %9.2g %8llu %6ld\n", l->what, l->count, l->worst, l->limit,
             (unsigned long long)l->seed, l->failed);
  }
  if (failures > PRINT_MAX)
    fprintf(stderr, "... and %ld more\n", failures - PRINT_MAX);
  printf("%s: %ld failed\n", program, failures);
  return failures != 0 || ntable == 0;
}
