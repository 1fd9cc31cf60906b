/* What the command line of maggi simulate asks for. */
#ifndef TOOL_REQUEST_H
#define TOOL_REQUEST_H

#include "formulation.h"
#include "options.h"
#include "settings.h"

typedef struct request {
  const char *model;
  double time;      /* 0: not given */
  double step;      /* 0: not given */
  double tolerance; /* 0: not given */
  long every;       /* 0: not given */
  const char *out;
  const char *reactions;
  const char *report;
  char temporary[64]; /* folder of the table when only the report is wanted, or "" */
  char table[80];     /* the table in it                                          */
  int objectives;
  int energy;
  int json;
  settings set;
  formulation formulation;
} request;

/* to be given to options_init and request_take */
extern const option_def request_options[];

/* nothing asked for yet, of argc arguments at most: 0, or -1 after a message */
int request_init(request *want, int argc);
void request_free(request *want);

/* One option or argument into the request: 0, or -1 after a message. */
int request_take(request *want, options *o, int id);

#endif
