/* Wall clock. */
#include "stopwatch.h"

#include <math.h>
#include <time.h>

#define LAPS_MAX  5
#define LONG_LAPS 0.25 /* no further lap after so long [s] */

double stopwatch_now(void)
{
  struct timespec now;

  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void stopwatch_start(stopwatch *w)
{
  w->first = w->begin = stopwatch_now();
  w->best = INFINITY;
  w->laps = 0;
}

int stopwatch_again(const stopwatch *w)
{
  return w->laps == 0 || (w->laps < LAPS_MAX && w->begin - w->first < LONG_LAPS);
}

void stopwatch_lap(stopwatch *w)
{
  double now = stopwatch_now();

  w->best = fmin(w->best, now - w->begin);
  w->begin = now;
  ++w->laps;
}
