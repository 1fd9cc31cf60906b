/* FILE.csv.json beside a table: what the table says and how it was made, so that it can be made again. */
#ifndef TOOL_RECORD_H
#define TOOL_RECORD_H

#include "run.h"
#include "settings.h"

typedef struct record {
  char *command;     /* the command line, as for a shell */
  const char *model; /* as the user named it             */
  const char *path;  /* file it was read from, or ""     */
  const char *out;   /* the table, NULL: it will not stay */
  const settings *set;
  double tolerance; /* 0: not given */
  table table;      /* where it is written; table.file NULL: nowhere */
  char *name;
} record;

/* Keep the command line, before options are read from it: 0, or -1 after a message; record_free in
 * either case. */
int record_init(record *r, int argc, char **argv);
void record_free(record *r);

/* Write it beside the table of the run, if that is a file: exit status, after a message when it is not
 * STATUS_DONE.  It appears with record_close; record_free discards it. */
int record_write(record *r, const run *what);
int record_close(record *r);

/* Name of the record of a table: allocated, or NULL after a message. */
char *record_name(const char *csv);

#endif
