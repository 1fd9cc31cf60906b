/* Points of time of a simulation. */
#include <float.h>
#include <math.h>

#include "maggi/maggi.h"

#define STEPS_MAX 1000000000L

/* time/step carries the rounding of both and of the quotient: 0.3/0.1 is 3 steps */
maggi_status maggi_grid_init(maggi_grid *grid, double time, double step)
{
  double ratio = time / step, whole = round(ratio);

  if (!(time > 0.0 && step > 0.0 && isfinite(time) && isfinite(step))) return MAGGI_E_VALUE;
  if (!(ratio <= (double)STEPS_MAX)) return MAGGI_E_VALUE;
  grid->time = time;
  grid->step = step;
  grid->is_multiple = whole > 0.0 && fabs(ratio - whole) <= 4.0 * DBL_EPSILON * ratio;
  grid->steps = grid->is_multiple ? (long)whole : (long)floor(ratio) + 1;
  return MAGGI_OK;
}

/* Steps are differences of these times, so that samples stand at round numbers, without the sum of
 * 1e6 roundings, and the last one exactly at the end. */
double maggi_grid_time(const maggi_grid *grid, long k)
{
  if (k == grid->steps) return grid->time;
  if (grid->is_multiple) return (double)k * grid->time / (double)grid->steps;
  return (double)k * grid->step;
}
