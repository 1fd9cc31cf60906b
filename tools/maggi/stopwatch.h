/* Wall clock. */
#ifndef TOOL_STOPWATCH_H
#define TOOL_STOPWATCH_H

/* Seconds since some fixed moment; never runs back. */
double stopwatch_now(void);

/* The best of a few runs, when they are short:
 *
 *   for (stopwatch_start(&w); stopwatch_again(&w); stopwatch_lap(&w)) run();
 */
typedef struct stopwatch {
  double first; /* when it was started            */
  double begin; /* of this lap                    */
  double best;  /* shortest lap so far [s]        */
  int laps;
} stopwatch;

void stopwatch_start(stopwatch *w);
int stopwatch_again(const stopwatch *w);
void stopwatch_lap(stopwatch *w);

#endif
