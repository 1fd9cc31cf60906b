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
 * the method.
 *
 * States of filters go along: more components of y, whose slopes follow from the sensors of the same
 * evaluations. */
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

static size_t filter_bytes(const maggi_data *d)
{
  return (size_t)d->t.nstate * sizeof(double);
}

static maggi_node node_at(const maggi_data *d, maggi_place place)
{
  if (place == MAGGI_START) return d->start;
  if (place == MAGGI_NODE) return d->node;
  return (maggi_node){d->time, d->work, d->power[0], d->q, d->v, d->a, d->y, d->yrate};
}

static void copy(maggi_data *d, maggi_place to, maggi_place from)
{
  maggi_node source = node_at(d, from), target = node_at(d, to);

  memcpy(target.q, source.q, bytes(d));
  memcpy(target.v, source.v, bytes(d));
  memcpy(target.a, source.a, bytes(d));
  memcpy(target.y, source.y, filter_bytes(d));
  memcpy(target.yrate, source.yrate, filter_bytes(d));
  source.q = target.q;
  source.v = target.v;
  source.a = target.a;
  source.y = target.y;
  source.yrate = target.yrate;
  if (to == MAGGI_START) {
    d->start = source;
  } else if (to == MAGGI_NODE) {
    d->node = source;
  } else {
    d->time = source.time;
    d->work = source.work;
    d->power[0] = source.power;
  }
  if (d->follower) d->follower->copy(d->follower, to, from);
}

/* an evaluation, with the rates of filters where it can be trusted */
static int evaluate(maggi_data *d, double time, int careful)
{
  maggi_evaluate(d, time);
  if (careful && maggi_is_singular(d)) return SINGULAR;
  maggi_evaluate_filters(d);
  return MAGGI_OK;
}

/* slopes of the last evaluation enter the sums with `weight`, the next evaluation is at the start
 * plus `ahead` times them */
static int stage(maggi_data *d, double weight, double ahead, double time, int careful)
{
  const maggi_topo *t = &d->t;
  int i, status;

  for (i = 0; i < t->nq; ++i) {
    d->dqs[i] += weight * d->v[i];
    d->q[i] = d->q0[i] + ahead * d->v[i];
  }
  for (i = 0; i < t->nind; ++i) {
    d->dus[i] += weight * d->acol[i];
    d->vcol[i] = d->v0[t->colq[i]] + ahead * d->acol[i];
  }
  for (i = 0; i < t->nstate; ++i) {
    d->dys[i] += weight * d->yrate[i];
    d->y[i] = d->y0[i] + ahead * d->yrate[i];
  }
  status = evaluate(d, time, careful);
  if (status != MAGGI_OK || !d->follower) return status;
  return (int)d->follower->stage(d->follower, weight, ahead, time);
}

/* the state of an evaluation, by a new plan */
static maggi_status evaluate_again(maggi_data *d, double time)
{
  const maggi_topo *t = &d->t;
  int i;

  for (i = 0; i < t->nind; ++i) d->vcol[i] = d->v[t->colq[i]];
  evaluate(d, time, 0);
  d->pivot_ratio = d->stage_ratio;
  return d->follower ? d->follower->renewed(d->follower, time) : MAGGI_OK;
}

/* one step from the start saved before; SINGULAR when careful and a stage or the end falls there */
static int advance(maggi_data *d, double h, int careful)
{
  const maggi_topo *t = &d->t;
  double time = d->start.time, work = d->start.power;
  long projections = d->projections;
  int status, i, is_new;

  if (d->follower) d->follower->begin(d->follower);
  memcpy(d->v, d->v0, bytes(d));
  for (i = 0; i < t->nind; ++i) d->acol[i] = d->a0[t->colq[i]];
  memset(d->dqs, 0, bytes(d));
  memset(d->dus, 0, bytes(d));
  memcpy(d->yrate, d->yrate0, filter_bytes(d));
  memset(d->dys, 0, filter_bytes(d));
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
  for (i = 0; i < t->nstate; ++i) d->y[i] = d->y0[i] + h / 6.0 * (d->dys[i] + d->yrate[i]);
  status = maggi_project(d, time + h);
  if (status != MAGGI_OK) return status;
  status = evaluate(d, time + h, careful);
  if (status != MAGGI_OK) return status;
  if (d->follower) {
    status = (int)d->follower->end(d->follower, h, time + h, d->projections > projections);
    if (status != MAGGI_OK) return status;
  }
  status = maggi_plan_watch(d, &is_new);
  if (status == MAGGI_OK && is_new) status = evaluate_again(d, time + h);
  if (status != MAGGI_OK) return status;
  status = maggi_check(d, time + h);
  if (status != MAGGI_OK) return status;
  d->time = time + h;
  d->work = d->start.work + h / 6.0 * work;
  return MAGGI_OK;
}

static void quintic(double s, double H, double c[3][6])
{
  double s2 = s * s, s3 = s * s2;

  c[0][1] = H * (s - s3 * (6.0 - s * (8.0 - 3.0 * s)));
  c[0][2] = 0.5 * H * H * (s2 - s3 * (3.0 - s * (3.0 - s)));
  c[0][3] = s3 * (10.0 - s * (15.0 - 6.0 * s));
  c[0][4] = -H * s3 * (4.0 - s * (7.0 - 3.0 * s));
  c[0][5] = 0.5 * H * H * s3 * (1.0 - s * (2.0 - s));
  c[1][1] = 1.0 - s2 * (18.0 - s * (32.0 - 15.0 * s));
  c[1][2] = 0.5 * H * (2.0 * s - s2 * (9.0 - s * (12.0 - 5.0 * s)));
  c[1][3] = s2 * (30.0 - s * (60.0 - 30.0 * s)) / H;
  c[1][4] = -s2 * (12.0 - s * (28.0 - 15.0 * s));
  c[1][5] = 0.5 * H * s2 * (3.0 - s * (8.0 - 5.0 * s));
  c[2][1] = -s * (36.0 - s * (96.0 - 60.0 * s)) / H;
  c[2][2] = 0.5 * (2.0 - s * (18.0 - s * (36.0 - 20.0 * s)));
  c[2][3] = s * (60.0 - s * (180.0 - 120.0 * s)) / (H * H);
  c[2][4] = -s * (24.0 - s * (84.0 - 60.0 * s)) / H;
  c[2][5] = 0.5 * s * (6.0 - s * (24.0 - 20.0 * s));
  c[0][0] = 1.0 - c[0][3];
  c[1][0] = -c[1][3];
  c[2][0] = -c[2][3];
}

void maggi_between(double s, double H, double c[MAGGI_BETWEEN][6])
{
  double r = 1.0 - s;

  quintic(s, H, c);
  c[3][0] = r * r * (1.0 + 2.0 * s);
  c[3][1] = H * s * r * r;
  c[3][2] = 0.0;
  c[3][3] = s * s * (3.0 - 2.0 * s);
  c[3][4] = -H * s * s * r;
  c[3][5] = 0.0;
}

/* state of `time` between the start and the end of the last step */
static void interpolate(maggi_data *d, double time)
{
  double H = d->node.time - d->start.time, s = (time - d->start.time) / H;
  double c[MAGGI_BETWEEN][6], e0, e1, e2, *x[3] = {d->q, d->v, d->a};
  int i, k;

  maggi_between(s, H, c);
  for (k = 0; k < 3; ++k)
    for (i = 0; i < d->t.nq; ++i)
      x[k][i] = c[k][0] * d->q0[i] + c[k][1] * d->v0[i] + c[k][2] * d->a0[i] + c[k][3] * d->qn[i] +
                c[k][4] * d->vn[i] + c[k][5] * d->an[i];
  for (i = 0; i < d->t.nstate; ++i)
    d->y[i] =
        c[3][0] * d->y0[i] + c[3][1] * d->yrate0[i] + c[3][3] * d->yn[i] + c[3][4] * d->yraten[i];
  maggi_evaluate_given(d, time);
  e0 = d->node.work - d->start.work;
  e1 = H * d->start.power;
  e2 = H * d->node.power;
  d->work = d->start.work + s * (e1 + s * (3.0 * e0 - 2.0 * e1 - e2 + s * (e1 + e2 - 2.0 * e0)));
  d->time = time;
  d->pivot_ratio = d->stage_ratio;
  d->is_ahead = 1;
  if (d->follower) d->follower->interpolate(d->follower, (void *)c);
}

/* two parts that both keep away from the singular position; the node keeps the start meanwhile */
static int advance_in_parts(maggi_data *d, double h)
{
  int status = SINGULAR;
  size_t i;

  copy(d, MAGGI_NODE, MAGGI_START);
  for (i = 0; i < sizeof first_part / sizeof *first_part && status == SINGULAR; ++i) {
    status = advance(d, first_part[i] * h, 1);
    if (status == MAGGI_OK) {
      copy(d, MAGGI_START, MAGGI_PRESENT);
      status = advance(d, d->node.time + h - d->start.time, 1);
    }
    if (status == SINGULAR) copy(d, MAGGI_START, MAGGI_NODE);
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
    copy(d, MAGGI_NODE, MAGGI_PRESENT);
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
    copy(d, MAGGI_PRESENT, MAGGI_NODE);
    d->is_ahead = 0;
  }
  d->ready = 0;
  copy(d, MAGGI_START, MAGGI_PRESENT);
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
