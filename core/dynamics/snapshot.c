/* Snapshots: what the next steps of a simulation depend on, so that they can be taken again bit by
 * bit. */
#include <string.h>

#include "data.h"

struct maggi_snapshot {
  double time, work, power, pivot_ratio, stage_ratio, replan_below;
  maggi_node start, node;
  int is_ahead, careless;
};

/* rows of nq numbers: the present state, start and node */
enum { ROWS = 9 };

size_t maggi_snapshot_size(const maggi_topo *t)
{
  return sizeof(maggi_snapshot) + (size_t)t->nq * ROWS * sizeof(double) + maggi_saved_plan_size(t);
}

/* its rows, the plan behind them */
static double *parts(const maggi_data *d, const void *memory, maggi_saved_plan *plan)
{
  double *rows = (double *)((const maggi_snapshot *)memory + 1);

  maggi_saved_plan_place(plan, &d->t, rows + d->t.nq * ROWS);
  return rows;
}

static void list_rows(const maggi_data *d, double *x[ROWS])
{
  double *all[ROWS] = {d->q, d->v, d->a, d->q0, d->v0, d->a0, d->qn, d->vn, d->an};

  memcpy(x, all, sizeof all);
}

void maggi_snapshot_save(const maggi_data *d, void *memory)
{
  maggi_snapshot *s = memory;
  maggi_saved_plan plan;
  double *rows = parts(d, memory, &plan), *x[ROWS];
  int i, nq = d->t.nq;

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
  list_rows(d, x);
  for (i = 0; i < ROWS; ++i) memcpy(rows + i * nq, x[i], (size_t)nq * sizeof(double));
  maggi_plan_save(d, &plan);
}

maggi_status maggi_snapshot_load(maggi_data *d, const void *memory)
{
  const maggi_snapshot *s = memory;
  maggi_saved_plan plan;
  double *rows = parts(d, memory, &plan), *x[ROWS];
  maggi_status status = MAGGI_OK;
  int i, nq = d->t.nq;

  if (!maggi_plan_is_saved(d, &plan)) status = maggi_plan_load(d, &plan);
  memcpy(d->piv0, plan.piv0, (size_t)nq * sizeof(double));
  list_rows(d, x);
  for (i = 0; i < ROWS; ++i) memcpy(x[i], rows + i * nq, (size_t)nq * sizeof(double));
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
