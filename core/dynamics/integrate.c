/* The classical Runge-Kutta method on y = (z, z'_i).  FORMULATION 6, [1] 2.62-2.66.
 *
 * A step starts from an evaluation of its first point and ends with one of its last, which is the
 * first of the next: four evaluations a step.  At the end the positions are projected when the loops
 * have opened by more than the tolerance, and after every step close to a singular position; the
 * independent coordinates are chosen anew when their pivots have become small and a better choice
 * exists.
 *
 * Singular positions (a parallelogram that lies flat) are crossed without evaluating next to them:
 * a step one of whose stages falls there is taken in two parts, or goes beyond its end to a node
 * from which the next step starts; the state at the end is then interpolated between both nodes by
 * the quintic through positions, velocities and accelerations, which is exact to a higher order than
 * the method. */
#include <math.h>
#include <string.h>

#include "data.h"

/* ways around a singular position: first part of a step in two, then how far to go beyond its end */
static const double first_part[] = {0.6180339887, 0.3819660113, 0.8, 0.2};
static const double beyond[] = {0.13, 0.21, 0.34, 0.55, 0.77, 1.0,  1.3,  1.7,  2.2,  3.0,
                                4.0,  5.5,  7.0,  9.0,  12.0, 16.0, 22.0, 30.0, 42.0, 60.0};

enum {
  SINGULAR = -1,       /* instead of a status: a stage fell on a singular position */
  CARELESS_STEPS = 32, /* without care after no way around was found: the motion stays there */
};

static size_t bytes(const maggi_data *d)
{
  return (size_t)d->t.nq * sizeof(double);
}

static void copy_node(const maggi_data *d, maggi_node *to, const maggi_node *from)
{
  memcpy(to->q, from->q, bytes(d));
  memcpy(to->v, from->v, bytes(d));
  memcpy(to->a, from->a, bytes(d));
  to->time = from->time;
  to->work = from->work;
  to->power = from->power;
}

/* the present evaluation */
static maggi_node present(const maggi_data *d)
{
  return (maggi_node){d->time, d->work, d->power[0], d->q, d->v, d->a};
}

static void save(maggi_data *d, maggi_node *node)
{
  maggi_node now = present(d);

  copy_node(d, node, &now);
}

static void load_node(maggi_data *d)
{
  maggi_node now = present(d);

  copy_node(d, &now, &d->node);
  d->time = now.time;
  d->work = now.work;
  d->power[0] = now.power;
  d->is_ahead = 0;
}

static int finish_stage(const maggi_data *d, int careful)
{
  return careful && maggi_is_singular(d) ? SINGULAR : MAGGI_OK;
}

/* slopes of the last evaluation enter the sums with `weight`, the next evaluation is at the start
 * plus `ahead` times them */
static int stage(maggi_data *d, double weight, double ahead, double time, int careful)
{
  const maggi_topo *t = &d->t;
  int i;

  for (i = 0; i < t->nq; ++i) {
    d->dqs[i] += weight * d->v[i];
    d->q[i] = d->q0[i] + ahead * d->v[i];
  }
  for (i = 0; i < t->nind; ++i) {
    d->dus[i] += weight * d->acol[i];
    d->vcol[i] = d->v0[t->colq[i]] + ahead * d->acol[i];
  }
  maggi_evaluate(d, time);
  return finish_stage(d, careful);
}

/* the independent coordinates have become bad ones */
static maggi_status renew(maggi_data *d, double time)
{
  const maggi_topo *t = &d->t;
  maggi_status status;
  int i, changed;

  memcpy(d->dqs, d->v, bytes(d));
  status = maggi_plan_renew(d, &changed);
  if (status != MAGGI_OK) return status;
  for (i = 0; i < t->nind; ++i) d->vcol[i] = d->dqs[t->colq[i]];
  d->changes += changed;
  d->replan_below = changed ? MAGGI_RENEW_BELOW : 0.5 * d->pivot_ratio;
  maggi_evaluate(d, time);
  return MAGGI_OK;
}

/* one step from the start saved before; SINGULAR when careful and a stage or the end falls there */
static int advance(maggi_data *d, double h, int careful)
{
  const maggi_topo *t = &d->t;
  double time = d->start.time, work = d->start.power;
  int status, i;

  memcpy(d->v, d->v0, bytes(d));
  for (i = 0; i < t->nind; ++i) d->acol[i] = d->a0[t->colq[i]];
  memset(d->dqs, 0, bytes(d));
  memset(d->dus, 0, bytes(d));
  status = stage(d, 1.0, 0.5 * h, time + 0.5 * h, careful);
  if (status != MAGGI_OK) return status;
  work += 2.0 * d->power[0];
  status = stage(d, 2.0, 0.5 * h, time + 0.5 * h, careful);
  if (status != MAGGI_OK) return status;
  work += 2.0 * d->power[0];
  status = stage(d, 2.0, h, time + h, careful);
  if (status != MAGGI_OK) return status;
  work += d->power[0];
  for (i = 0; i < t->nq; ++i) d->q[i] = d->q0[i] + h / 6.0 * (d->dqs[i] + d->v[i]);
  for (i = 0; i < t->nind; ++i) d->vcol[i] = d->v0[t->colq[i]] + h / 6.0 * (d->dus[i] + d->acol[i]);
  status = maggi_project(d, time + h);
  if (status != MAGGI_OK) return status;
  maggi_evaluate(d, time + h);
  status = finish_stage(d, careful);
  if (status != MAGGI_OK) return status;
  d->pivot_ratio = d->stage_ratio;
  if (d->pivot_ratio > 2.0 * MAGGI_RENEW_BELOW) d->replan_below = MAGGI_RENEW_BELOW;
  if (t->ndep > 0 && d->pivot_ratio < d->replan_below) {
    status = renew(d, time + h);
    if (status != MAGGI_OK) return status;
    d->pivot_ratio = d->stage_ratio;
  }
  status = maggi_check(d, time + h);
  if (status != MAGGI_OK) return status;
  d->time = time + h;
  d->work = d->start.work + h / 6.0 * work;
  return MAGGI_OK;
}

/* state of `time` between the start and the end of the last step */
static void interpolate(maggi_data *d, double time)
{
  const maggi_topo *t = &d->t;
  double H = d->node.time - d->start.time, s = (time - d->start.time) / H;
  double dq, c3, c4, c5, e0, e1, e2;
  int i;

  for (i = 0; i < t->nq; ++i) {
    /* q = q0 + v0 H s + a0 H^2 s^2/2 + c3 s^3 + c4 s^4 + c5 s^5 */
    dq = d->qn[i] - d->q0[i] - H * (d->v0[i] + 0.5 * H * d->a0[i]);
    e0 = dq;
    e1 = H * (d->vn[i] - d->v0[i] - H * d->a0[i]);
    e2 = H * H * (d->an[i] - d->a0[i]);
    c3 = 10.0 * e0 - 4.0 * e1 + 0.5 * e2;
    c4 = -15.0 * e0 + 7.0 * e1 - e2;
    c5 = 6.0 * e0 - 3.0 * e1 + 0.5 * e2;
    d->q[i] =
        d->q0[i] + s * (H * d->v0[i] + s * (0.5 * H * H * d->a0[i] + s * (c3 + s * (c4 + s * c5))));
    d->v[i] = d->v0[i] + s * H * d->a0[i] + s * s * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5)) / H;
    d->a[i] = d->a0[i] + s * (6.0 * c3 + s * (12.0 * c4 + s * 20.0 * c5)) / (H * H);
  }
  maggi_evaluate_given(d, time);
  e0 = d->node.work - d->start.work;
  e1 = H * d->start.power;
  e2 = H * d->node.power;
  d->work = d->start.work + s * (e1 + s * (3.0 * e0 - 2.0 * e1 - e2 + s * (e1 + e2 - 2.0 * e0)));
  d->time = time;
  d->pivot_ratio = d->stage_ratio;
  d->is_ahead = 1;
}

/* two parts that both keep away from the singular position; the node keeps the start meanwhile */
static int advance_in_parts(maggi_data *d, double h)
{
  int status = SINGULAR;
  size_t i;

  copy_node(d, &d->node, &d->start);
  for (i = 0; i < sizeof first_part / sizeof *first_part && status == SINGULAR; ++i) {
    status = advance(d, first_part[i] * h, 1);
    if (status == MAGGI_OK) {
      save(d, &d->start);
      status = advance(d, d->node.time + h - d->start.time, 1);
    }
    if (status == SINGULAR) copy_node(d, &d->start, &d->node);
  }
  return status;
}

static int advance_beyond(maggi_data *d, double h)
{
  double time = d->start.time + h;
  int status = SINGULAR;
  size_t i;

  for (i = 0; i < sizeof beyond / sizeof *beyond && status == SINGULAR; ++i)
    status = advance(d, (1.0 + beyond[i]) * h, 1);
  if (status == MAGGI_OK) {
    save(d, &d->node);
    interpolate(d, time);
  }
  return status;
}

maggi_status maggi_step(maggi_data *d, double h)
{
  double time = d->time + h, rest;
  int status;

  if (!d->ready)
    return maggi_data_fail(d, MAGGI_E_MODEL, "a step needs a successful reset before it");
  if (!isfinite(h) || h == 0.0)
    return maggi_data_fail(d, MAGGI_E_VALUE, "the step must be finite and not zero");

  if (d->is_ahead) {
    if ((time - d->start.time) * (time - d->node.time) <= 0.0) {
      interpolate(d, time);
      return MAGGI_OK;
    }
    load_node(d);
  }
  d->ready = 0;
  save(d, &d->start);
  rest = time - d->time;
  d->careless -= d->careless > 0;
  status = advance(d, rest, d->careless == 0);
  if (status == SINGULAR) status = advance_in_parts(d, rest);
  if (status == SINGULAR) status = advance_beyond(d, rest);
  if (status == SINGULAR) {
    d->careless = CARELESS_STEPS;
    status = advance(d, rest, 0);
  }
  if (status != MAGGI_OK) return (maggi_status)status;
  d->time = time;
  d->ready = 1;
  return MAGGI_OK;
}
