/* Wall clock. */
#ifndef TOOL_STOPWATCH_H
#define TOOL_STOPWATCH_H

/* Seconds since some fixed moment; never runs back. */
double stopwatch_now(void);

#endif
