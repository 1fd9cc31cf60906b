/* Drift control, and whether a state can be trusted. */
#include <math.h>

#include "closing.h"

/* pivots below which a position is close to singular: loops are kept closed to round-off there */
static const double singular_below = 0.05;

static maggi_status fail_lockup(maggi_data *d, double time)
{
  int loop = maggi_worst_loop(d);

  return maggi_data_fail(d, MAGGI_E_LOCKUP,
                         "t = %.6g s: the mechanism locks up, or the step is too large for it: %s "
                         "\"%s\" cannot stay closed",
                         time, maggi_loop_word(d, loop), d->m->loop[loop].name);
}

/* Newton on the positions when the loops are open by more than the tolerance; the positions of `time`
 * are evaluated before and after. */
maggi_status maggi_project(maggi_data *d, double time)
{
  double violation, before, tolerance = d->pivot_ratio < singular_below ? 0.0 : d->tolerance;
  int i;

  maggi_evaluate_positions(d, time);
  violation = maggi_violation(d);
  if (isnan(violation))
    return maggi_data_fail(d, MAGGI_E_NOT_FINITE,
                           "t = %.6g s: the positions are not finite; is the step too large?",
                           time);
  if (violation <= tolerance) return MAGGI_OK;
  tolerance = fmax(tolerance, maggi_roundoff(d));
  for (i = 0; violation > tolerance; ++i) {
    if (i == MAGGI_CLOSING_ITERATIONS) return fail_lockup(d, time);
    maggi_evaluate_factors(d);
    if (maggi_is_singular(d)) break;
    maggi_close_step(d);
    ++d->projections;
    maggi_close_begin(d);
    maggi_close_move(d, 1.0);
    maggi_evaluate_positions(d, time);
    before = violation;
    violation = maggi_violation(d);
    if (isnan(violation) || (i > 4 && violation > 2.0 * before)) {
      maggi_close_move(d, 0.0);
      maggi_evaluate_positions(d, time);
      return fail_lockup(d, time);
    }
    /* no progress any more, close to round-off: as good as it gets */
    if (violation <= fmax(d->tolerance, 1e4 * maggi_roundoff(d)) && violation > 0.5 * before) break;
  }
  return MAGGI_OK;
}

/* whether the accelerations of `time` can be trusted; what is wrong if not */
maggi_status maggi_check(maggi_data *d, double time)
{
  const maggi_topo *t = &d->t;
  double pivot, whole;
  int i;

  for (i = 0; i < t->nind; ++i) {
    pivot = 1.0 / (d->dinv[i] * d->dinv[i]);
    whole = d->Mr[i * t->stride + i];
    if (isfinite(whole) && !(pivot > 1e-13 * whole))
      return maggi_data_fail(d, MAGGI_E_MASS,
                             "t = %.6g s: the mass matrix is singular: nothing resists \"%s\"; has "
                             "each body that it moves mass and inertia?",
                             time, maggi_name_of(d, t->colq[i]));
  }
  for (i = 0; i < t->nq; ++i) {
    if (isfinite(d->a[i]) && isfinite(d->v[i])) continue;
    if (t->ndep > 0 && !(d->pivot_ratio > 1e-6)) return fail_lockup(d, time);
    return maggi_data_fail(d, MAGGI_E_NOT_FINITE,
                           "t = %.6g s: the motion of \"%s\" is not finite; is the step too large?",
                           time, maggi_name_of(d, i));
  }
  return MAGGI_OK;
}
