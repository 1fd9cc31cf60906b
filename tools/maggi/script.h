/* Pictures and pages, which scripts in Python draw. */
#ifndef TOOL_SCRIPT_H
#define TOOL_SCRIPT_H

#include <stdio.h>

typedef struct script {
  const char *name;  /* of its file                                        */
  const char *where; /* what messages begin with, "" if the script says so */
  const char *needs; /* a module that it needs                             */
} script;

extern const script script_plot;   /* plot-sensitivity, for --plot */
extern const script script_report; /* report                       */

/* Whether it can draw `out`: it is there, runs, has its modules, may write the file.  Exit status,
 * after a message when it is not STATUS_DONE. */
int script_check(const script *s, const char *out);

/* Let it run with n arguments: exit status as above.  What it notes is passed on. */
int script_run(const script *s, int n, const char *const *arguments);

/* A file for what is to be drawn, or NULL after a message; let the script draw `out` from the JSON in
 * it, from its beginning, and close it: exit status as above. */
FILE *script_input(const script *s);
int script_draw(const script *s, FILE *input, const char *out);

#endif
