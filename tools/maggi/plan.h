/* How long, and in which steps. */
#ifndef TOOL_PLAN_H
#define TOOL_PLAN_H

#include <maggi/maggi.h>

/* Points of time for --time and --step (0: not given), else for what the model proposes, else the
 * usual ones: exit status, after a message when it is not STATUS_DONE. */
int plan_grid(const maggi_model_info *info, double time, double step, maggi_grid *grid);

/* Length of the last step [s]. */
double plan_last_step(const maggi_grid *grid);

/* Note it when it is shorter than the others. */
void plan_note(const maggi_grid *grid);

#endif
