/* A CSV file that is there as a whole or not at all.
 *
 * Rows go to FILE.part.PID beside FILE, which table_close renames to FILE.  What is no regular file
 * (a device, a pipe) is written directly, and "-" is standard output.
 */
#ifndef TOOL_TABLE_H
#define TOOL_TABLE_H

#include <stdio.h>

typedef struct table {
  FILE *file;       /* NULL: no table           */
  const char *name; /* as the user named it     */
  char *path;       /* where it goes at the end */
  char *part;       /* where it grows, or NULL  */
  int column;       /* cells in this row so far */
  long rows;        /* without the header       */
  int error;        /* errno of the first failure */
} table;

/* Create it: exit status, after a message when it is not STATUS_DONE.  name must stay. */
int table_open(table *t, const char *name);

/* Whether two names are one file that exists. */
int table_is_same_file(const char *a, const char *b);

/* Cells of the header, name with suffix (may be NULL), and of rows; then the end of the line. */
void table_title(table *t, const char *name, const char *suffix);
void table_number(table *t, double x);
void table_text(table *t, const char *text); /* in quotes where it needs them */
void table_end_header(table *t);
void table_end_row(table *t);

/* Whether writing has failed so far (it is reported by table_close). */
int table_has_failed(const table *t);

/* Finish and rename: exit status, after a message when it is not STATUS_DONE and then without a
 * file left behind. */
int table_close(table *t);

/* Remove what is there.  Does nothing on a closed table. */
void table_discard(table *t);

#endif
