/* The classical Runge-Kutta method on y = (z, z'_i).  FORMULATION 6, [1] 2.62-2.66.
 *
 * A step starts from an evaluation of its first point and ends with one of its last, which is the
 * first of the next: four evaluations a step.  At the end the positions are projected when the loops
 * have opened by more than the tolerance, and after every step close to a singular position; the
 * independent coordinates are chosen anew when their pivots have become small and a better choice
 * exists. */
#include <math.h>
#include <string.h>

#include "data.h"

/* pivots of the loops relative to those at the choice of the independent coordinates */
static const double renew_below = 0.2;     /* look for a better choice */
static const double singular_below = 0.05; /* keep the loops closed to round-off */

/* one stage: slopes of the last evaluation enter the sums with `weight`, the next evaluation is at
 * the start plus `ahead` times them */
static void stage(maggi_data *d, double weight, double ahead, double time)
{
  const maggi_topo *t = &d->t;
  int i;

  for (i = 0; i < t->nq; ++i) {
    d->dqs[i] += weight * d->v[i];
    d->q[i] = d->q0[i] + ahead * d->v[i];
  }
  for (i = 0; i < t->nind; ++i) {
    d->dus[i] += weight * d->acol[i];
    d->vcol[i] = d->u0[i] + ahead * d->acol[i];
  }
  maggi_evaluate(d, time);
}

static void finish(maggi_data *d, double h)
{
  const maggi_topo *t = &d->t;
  int i;

  for (i = 0; i < t->nq; ++i)
    d->q[i] = d->q0[i] + h / 6.0 * (d->dqs[i] + d->v[i]);
  for (i = 0; i < t->nind; ++i)
    d->vcol[i] = d->u0[i] + h / 6.0 * (d->dus[i] + d->acol[i]);
}

/* the independent coordinates have become bad ones */
static maggi_status renew(maggi_data *d, double time)
{
  const maggi_topo *t = &d->t;
  maggi_status status;
  int i, changed;

  for (i = 0; i < t->nq; ++i)
    d->u0[i] = d->v[i];
  status = maggi_plan_renew(d, &changed);
  if (status != MAGGI_OK)
    return status;
  for (i = 0; i < t->nind; ++i)
    d->vcol[i] = d->u0[t->colq[i]];
  if (changed) {
    ++d->changes;
    d->replan_below = renew_below;
  } else {
    d->replan_below = 0.5 * d->pivot_ratio;
  }
  maggi_evaluate(d, time);
  return MAGGI_OK;
}

maggi_status maggi_step(maggi_data *d, double h)
{
  const maggi_topo *t = &d->t;
  double time = d->time, work;
  maggi_status status;
  int dep;

  if (!d->ready)
    return maggi_data_fail(d, MAGGI_E_MODEL, "a step needs a successful reset before it");
  if (!isfinite(h) || h == 0.0)
    return maggi_data_fail(d, MAGGI_E_VALUE, "the step must be finite and not zero");

  memcpy(d->q0, d->q, (size_t)t->nq * sizeof(double));
  memcpy(d->u0, d->vcol, (size_t)t->nind * sizeof(double));
  memset(d->dqs, 0, (size_t)t->nq * sizeof(double));
  memset(d->dus, 0, (size_t)t->nq * sizeof(double));
  work = d->power[0];
  stage(d, 1.0, 0.5 * h, time + 0.5 * h);
  work += 2.0 * d->power[0];
  stage(d, 2.0, 0.5 * h, time + 0.5 * h);
  work += 2.0 * d->power[0];
  stage(d, 2.0, h, time + h);
  work += d->power[0];
  finish(d, h);

  d->ready = 0;
  status = maggi_project(d, time + h, d->pivot_ratio < singular_below ? 0.0 : d->tolerance);
  if (status != MAGGI_OK)
    return status;
  maggi_evaluate(d, time + h);
  if (t->ndep > 0) {
    maggi_smallest_pivot(d, &d->pivot_ratio, &dep);
    if (d->pivot_ratio > 2.0 * renew_below)
      d->replan_below = renew_below;
    if (d->pivot_ratio < d->replan_below) {
      status = renew(d, time + h);
      if (status != MAGGI_OK)
        return status;
      maggi_smallest_pivot(d, &d->pivot_ratio, &dep);
    }
  }
  status = maggi_check(d, time + h);
  if (status != MAGGI_OK)
    return status;
  d->time = time + h;
  d->work += h / 6.0 * work;
  d->ready = 1;
  return MAGGI_OK;
}
