/* Stepping through a simulation. */
#include "run.h"

#include <math.h>

#include "interrupt.h"
#include "progress.h"
#include "stopwatch.h"

#define RUN_BLOCK 64 /* steps between looks at the clock, when nothing asks for each step */

static void watch_loops(run *r)
{
  maggi_get_loop_state(r->data, &r->loops);
  if (r->loops.violation > r->violation_max) r->violation_max = r->loops.violation;
  if (r->loops.pivot_ratio < r->pivot_ratio_min) {
    r->pivot_ratio_min = r->loops.pivot_ratio;
    r->pivot_ratio_time = maggi_get_time(r->data);
  }
}

static void watch_energy(run *r)
{
  double change;

  maggi_get_energy(r->data, &r->energy);
  change = fabs(r->energy.kinetic + r->energy.potential - r->energy.work - r->energy_start);
  if (change > r->energy_change) r->energy_change = change;
  if (r->energy.kinetic > r->kinetic_max) r->kinetic_max = r->energy.kinetic;
}

/* n steps on the clock.  A single step is timed alone; in a block the clock also sees the look at
 * the loops, which reads what the step has left there. */
static maggi_status advance(run *r, long n)
{
  maggi_status status = MAGGI_OK;
  double begin, next, t = maggi_grid_time(&r->grid, r->done);
  long k;

  begin = stopwatch_now();
  for (k = 0; k < n && !interrupt_seen(); ++k) {
    if (k > 0) watch_loops(r);
    next = maggi_grid_time(&r->grid, r->done + 1);
    status = formulation_step(r->data, r->penalty, next - t);
    if (status != MAGGI_OK) break;
    t = next;
    ++r->done;
  }
  r->wall += stopwatch_now() - begin;
  watch_loops(r);
  return status;
}

/* Steps until something other than the loops wants to look. */
static long block_length(const run *r)
{
  long n = r->each_energy ? 1 : RUN_BLOCK;
  long row = r->every - r->done % r->every;

  if (r->rows->table.file && row < n) n = row;
  return r->grid.steps - r->done < n ? r->grid.steps - r->done : n;
}

static void start(run *r)
{
  r->done = 0;
  r->interrupted = 0;
  r->wall = 0.0;
  r->violation_max = 0.0;
  r->pivot_ratio_min = INFINITY;
  r->pivot_ratio_time = 0.0;
  watch_loops(r);
  r->evaluations = -r->loops.evaluations; /* those of the reset do not count */
  maggi_get_energy(r->data, &r->energy);
  r->energy_start = r->energy.kinetic + r->energy.potential - r->energy.work;
  r->energy_change = 0.0;
  r->kinetic_max = r->energy.kinetic;
}

maggi_status run_simulate(run *r)
{
  table *t = &r->rows->table;
  maggi_status status = MAGGI_OK;
  progress p;
  long last_row = 0;

  start(r);
  if (t->file) {
    rows_header(r->rows);
    rows_write(r->rows, r->data);
  }
  progress_begin(&p, r->show_progress);
  while (r->done < r->grid.steps && !interrupt_seen() && !table_has_failed(t)) {
    status = advance(r, block_length(r));
    if (status != MAGGI_OK) break;
    watch_energy(r);
    if (t->file && r->done % r->every == 0 && r->done > last_row) {
      rows_write(r->rows, r->data);
      last_row = r->done;
    }
    progress_update(&p, stopwatch_now(), maggi_grid_time(&r->grid, r->done), r->grid.time);
  }
  if (t->file && status == MAGGI_OK && r->done > last_row && !table_has_failed(t))
    rows_write(r->rows, r->data);
  progress_end(&p);
  r->interrupted = interrupt_seen() && r->done < r->grid.steps;
  r->evaluations += r->loops.evaluations;
  return status;
}

double run_energy_drift(const run *r)
{
  double scale = fabs(r->energy_start);

  if (scale < 1e-6 * r->kinetic_max) scale = r->kinetic_max;
  return r->energy_change > 0.0 ? r->energy_change / scale : 0.0;
}
