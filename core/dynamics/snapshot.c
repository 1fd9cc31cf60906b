/* Snapshots: what the next steps of a simulation depend on, so that they can be taken again bit by
 * bit. */
#include <string.h>

#include "data.h"

struct maggi_snapshot {
  double time, work, power, pivot_ratio, stage_ratio, replan_below;
  maggi_node start, node;
  int is_ahead, careless;
};

/* rows of nq numbers, then of nstate: the present state, start and node */
enum { ROWS = 9, FILTER_ROWS = 6 };

static size_t numbers(const maggi_topo *t)
{
  return (size_t)t->nq * ROWS + (size_t)t->nstate * FILTER_ROWS;
}

size_t maggi_snapshot_size(const maggi_topo *t)
{
  return sizeof(maggi_snapshot) + numbers(t) * sizeof(double) + maggi_saved_plan_size(t);
}

/* its rows, the plan behind them */
static double *parts(const maggi_data *d, const void *memory, maggi_saved_plan *plan)
{
  double *rows = (double *)((const maggi_snapshot *)memory + 1);

  maggi_saved_plan_place(plan, &d->t, rows + numbers(&d->t));
  return rows;
}

/* between the simulation and the rows of a snapshot, with what copies from one to the other */
static void each_row(const maggi_data *d, double *row,
                     void (*move)(double *of_data, double *of_snapshot, size_t bytes))
{
  double *x[ROWS] = {d->q, d->v, d->a, d->q0, d->v0, d->a0, d->qn, d->vn, d->an};
  double *y[FILTER_ROWS] = {d->y, d->yrate, d->y0, d->yrate0, d->yn, d->yraten};
  int i;

  for (i = 0; i < ROWS; ++i, row += d->t.nq) move(x[i], row, (size_t)d->t.nq * sizeof(double));
  for (i = 0; i < FILTER_ROWS; ++i, row += d->t.nstate)
    move(y[i], row, (size_t)d->t.nstate * sizeof(double));
}

static void save(double *of_data, double *of_snapshot, size_t bytes)
{
  memcpy(of_snapshot, of_data, bytes);
}

static void load(double *of_data, double *of_snapshot, size_t bytes)
{
  memcpy(of_data, of_snapshot, bytes);
}

void maggi_snapshot_save(const maggi_data *d, void *memory)
{
  maggi_snapshot *s = memory;
  maggi_saved_plan plan;
  double *rows = parts(d, memory, &plan);

  *s = (maggi_snapshot){.time = d->time,
                        .work = d->work,
                        .power = d->power[0],
                        .pivot_ratio = d->pivot_ratio,
                        .stage_ratio = d->stage_ratio,
                        .replan_below = d->replan_below,
                        .start = d->start,
                        .node = d->node,
                        .is_ahead = d->is_ahead,
                        .careless = d->careless};
  each_row(d, rows, save);
  maggi_plan_save(d, &plan);
}

maggi_status maggi_snapshot_load(maggi_data *d, const void *memory)
{
  const maggi_snapshot *s = memory;
  maggi_saved_plan plan;
  double *rows = parts(d, memory, &plan);
  maggi_status status = MAGGI_OK;

  if (!maggi_plan_is_saved(d, &plan)) status = maggi_plan_load(d, &plan);
  memcpy(d->piv0, plan.piv0, (size_t)d->t.nq * sizeof(double));
  each_row(d, rows, load);
  d->time = s->time;
  d->work = s->work;
  d->power[0] = s->power;
  d->pivot_ratio = s->pivot_ratio;
  d->stage_ratio = s->stage_ratio;
  d->replan_below = s->replan_below;
  d->start = s->start;
  d->node = s->node;
  d->is_ahead = s->is_ahead;
  d->careless = s->careless;
  d->fresh = MAGGI_STALE;
  d->ready = status == MAGGI_OK;
  return status;
}
