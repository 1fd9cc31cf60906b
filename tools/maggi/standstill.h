/* A model in static equilibrium, for the commands about it. */
#ifndef TOOL_STANDSTILL_H
#define TOOL_STANDSTILL_H

#include <maggi/maggi.h>

#include "settings.h"

typedef struct standstill {
  const char *spec; /* MODEL of the command line, or NULL */
  int json;
  settings set;
  maggi_model *model;
  maggi_data *data;
  maggi_model_info info;
  maggi_equilibrium_state state;
} standstill;

/* The command with its options MODEL, --set, --json: `show` when all is there.  Returns the exit status. */
int standstill_run(int argc, char **argv, int (*show)(const standstill *s));

#endif
