/* The formula of a tyre, without a model. */
#include <math.h>
#include <string.h>

#include "kernel.h"
#include "maggi/maggi.h"

void maggi_tyre_forces(const maggi_tyre_def *def, maggi_side side, const double slip[5],
                       double force[6], double slope[3])
{
  double way = side == def->side ? 1.0 : -1.0;
  const double one[5] = {slip[0], way * tan(slip[1]), way * slip[2], slip[3], slip[4]};
  int k;

  memset(force, 0, 6 * sizeof *force);
  if (slope) memset(slope, 0, 3 * sizeof *slope);
  if (!(slip[3] > 0.0)) return;
  maggi_tyre(0, MAGGI_TYRE_NUMBERS, def->value, one, force);
  for (k = 1; k < 6; k += 2) force[k] *= way;
  if (slope) maggi_tyre_slopes(0, MAGGI_TYRE_NUMBERS, def->value, one, slope);
}
