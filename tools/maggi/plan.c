/* Time and step of a simulation. */
#include "plan.h"

#include "message.h"

#define TIME_DEFAULT 1.0  /* [s], when the model proposes nothing */
#define STEP_DEFAULT 1e-3 /* [s] */

int plan_grid(const maggi_model_info *info, double time, double step, maggi_grid *grid)
{
  const maggi_simulation_def *file = &info->simulation;

  if (!(time > 0.0)) time = file->time > 0.0 ? file->time : TIME_DEFAULT;
  if (!(step > 0.0)) step = file->step > 0.0 ? file->step : STEP_DEFAULT;
  if (step > time)
    return message_fail(STATUS_USAGE, "--step: %.6g s is longer than the simulation, %.6g s", step,
                        time);
  if (maggi_grid_init(grid, time, step) != MAGGI_OK)
    return message_fail(STATUS_USAGE,
                        "--step: %.6g s in steps of %.6g s is more than 1000000000 steps", time,
                        step);
  return STATUS_DONE;
}

double plan_last_step(const maggi_grid *grid)
{
  return grid->is_multiple ? grid->step : grid->time - maggi_grid_time(grid, grid->steps - 1);
}

void plan_note(const maggi_grid *grid)
{
  if (!grid->is_multiple)
    message_note("%.6g s is not a multiple of the step of %.6g s: the last of %ld steps is %.6g s",
                 grid->time, grid->step, grid->steps, plan_last_step(grid));
}
