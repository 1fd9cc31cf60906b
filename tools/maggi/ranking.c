/* Sorting by size. */
#include "ranking.h"

#include <math.h>
#include <stdlib.h>

typedef struct entry {
  double first, second;
  int index;
} entry;

/* Above all for qsort, which wants -1, 0, 1. */
static int falling(double a, double b)
{
  return (a < b) - (a > b);
}

static int compare(const void *x, const void *y)
{
  const entry *a = x, *b = y;

  if (a->first != b->first) return falling(a->first, b->first);
  if (a->second != b->second) return falling(a->second, b->second);
  return (a->index > b->index) - (a->index < b->index);
}

int ranking(int n, const double *first, const double *second, int *order)
{
  entry *e = calloc((size_t)n + 1, sizeof *e);
  int i;

  if (!e) return -1;
  for (i = 0; i < n; ++i) {
    e[i].first = fabs(first[i]);
    e[i].second = second ? fabs(second[i]) : 0.0;
    e[i].index = i;
  }
  qsort(e, (size_t)n, sizeof *e, compare);
  for (i = 0; i < n; ++i) order[i] = e[i].index;
  free(e);
  return 0;
}
