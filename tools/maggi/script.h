/* Pictures, which a script in Python draws. */
#ifndef TOOL_SCRIPT_H
#define TOOL_SCRIPT_H

#include <stdio.h>

/* Whether it can draw `out`: it is there, runs, has matplotlib, may write the file.  Exit status, after
 * a message when it is not STATUS_DONE. */
int script_check(const char *out);

/* A file for what is to be drawn, or NULL after a message; let the script draw `out` from the JSON in
 * it, from its beginning, and close it: exit status as above. */
FILE *script_input(void);
int script_draw(FILE *input, const char *out);

#endif
