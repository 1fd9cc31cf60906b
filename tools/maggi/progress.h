/* One line of progress on the terminal, for runs that take a while. */
#ifndef TOOL_PROGRESS_H
#define TOOL_PROGRESS_H

typedef struct progress {
  int on;       /* stderr is a terminal              */
  double begin; /* wall clock [s]                    */
  double next;  /* nothing is written before [s]     */
  int width;    /* of the line that stands there now */
} progress;

/* show: 0 keeps it silent even on a terminal. */
void progress_begin(progress *p, int show);

/* now: wall clock; t of time: simulated [s]. */
void progress_update(progress *p, double now, double t, double time);

/* part: of the work that is done, 0 to 1. */
void progress_part(progress *p, double now, double part);

/* Erase the line; may be called again. */
void progress_end(progress *p);

#endif
