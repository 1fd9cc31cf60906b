/* Stepping through a simulation, and what is watched on the way. */
#ifndef TOOL_RUN_H
#define TOOL_RUN_H

#include <maggi/maggi.h>

#include "formulation.h"
#include "rows.h"
#include "values.h"

typedef struct run {
  /* asked for */
  maggi_data *data;
  maggi_penalty *penalty; /* NULL: Maggi's formulation                                   */
  const formulation *formulation;
  const values *values; /* of objectives, NULL: not wanted                               */
  rows *rows;           /* rows->table.file NULL: no rows                                     */
  maggi_grid grid;      /* points of time                                                     */
  long every;           /* steps from row to row                                              */
  int each_energy;      /* look at the energy after each step, else every few                 */
  int show_progress;

  /* found */
  long done; /* steps                                                                     */
  int interrupted;
  double wall;             /* of the steps alone [s]                                      */
  maggi_energy energy;     /* at the end [J]                                              */
  double energy_start;     /* kinetic + potential - work at t = 0 [J]                     */
  double energy_change;    /* largest distance from it [J]                                */
  double kinetic_max;      /* [J]                                                         */
  double violation_max;    /* of the loop equations [m, rad]                              */
  double pivot_ratio_min;  /* and when it was there:                                      */
  double pivot_ratio_time; /* [s]                                                         */
  maggi_loop_state loops;  /* at the end                                                  */
  long evaluations;        /* by the steps                                                */
} run;

/* Step from a fresh reset to the end: status of the step that failed.  Also ends, without a failure
 * of the model, when the table cannot be written or the run is interrupted. */
maggi_status run_simulate(run *r);

/* Largest relative change of kinetic + potential - work, see help. */
double run_energy_drift(const run *r);

#endif
