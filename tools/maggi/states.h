/* Sensitivities over time, as a CSV. */
#ifndef TOOL_STATES_H
#define TOOL_STATES_H

#include "study.h"
#include "table.h"

/* Write a row of derivatives by all parameters at t = 0, every `every` steps and at the end: of all
 * coordinates, then of the other signals of the objectives.  Leaves the table open.  Exit status,
 * after a message when it is neither STATUS_DONE nor STATUS_INTERRUPTED; failures of the table are
 * left to table_close. */
int states_write(const study *s, table *t, long every);

#endif
