/* Stepping through a simulation, and what is watched on the way. */
#ifndef TOOL_RUN_H
#define TOOL_RUN_H

#include <maggi/maggi.h>

#include "rows.h"

typedef struct run {
  /* asked for */
  maggi_data *data;
  rows *rows;       /* rows->table.file NULL: no rows                                     */
  double time;      /* end [s]                                                            */
  double step;      /* [s]                                                                */
  long steps;       /* run_plan                                                           */
  int is_multiple;  /* run_plan: time is a multiple of step                               */
  double last_step; /* run_plan [s]                                                       */
  long every;       /* steps from row to row                                              */
  int each_energy;  /* look at the energy after each step, else every few                 */
  int show_progress;

  /* found */
  long done; /* steps                                                                     */
  int interrupted;
  double wall;             /* of maggi_step alone [s]                                     */
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

#define RUN_STEPS_MAX 1000000000L

/* Fill steps, is_multiple and last_step from time and step: 0, or -1 if there are too many. */
int run_plan(run *r);

/* Let SIGINT and SIGTERM end run_simulate after the step in progress. */
void run_catch_signals(void);

/* Step from a fresh reset to the end: status of the step that failed.  Also ends, without a failure
 * of the model, when the table cannot be written or the run is interrupted. */
maggi_status run_simulate(run *r);

/* Largest relative change of kinetic + potential - work, see help. */
double run_energy_drift(const run *r);

#endif
