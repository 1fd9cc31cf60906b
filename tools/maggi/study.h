/* What sensitivity and verify begin with: a model, its objectives and its design parameters. */
#ifndef TOOL_STUDY_H
#define TOOL_STUDY_H

#include <maggi/maggi.h>

#include "formulation.h"
#include "models.h"
#include "objectives.h"
#include "options.h"
#include "parameters.h"
#include "settings.h"

typedef struct study_request {
  const char *model;
  const char *objectives; /* or NULL */
  const char *parameters; /* or NULL */
  double time;            /* 0: not given */
  double step;            /* 0: not given */
  double tolerance;       /* 0: not given */
  const char *plot;       /* or NULL */
  int json;
  settings set;
  formulation formulation;
} study_request;

/* Their options; those of a command itself follow from STUDY_OPTIONS on. */
enum {
  STUDY_OBJECTIVE,
  STUDY_PARAMETERS,
  STUDY_TIME,
  STUDY_STEP,
  STUDY_SET,
  STUDY_TOLERANCE,
  STUDY_PLOT,
  STUDY_JSON,
  STUDY_OPTIONS
};

/* clang-format off */
#define STUDY_OPTION_LIST                                                                       \
  [STUDY_OBJECTIVE] = {"--objective", OPTION_VALUE, "names of objectives, or TYPE(SIGNAL)"},    \
  [STUDY_PARAMETERS] = {"--parameters", OPTION_VALUE, "names or paths of parameters, or all"},  \
  [STUDY_TIME] = {"--time", OPTION_VALUE, "a time in seconds"},                                 \
  [STUDY_STEP] = {"--step", OPTION_VALUE, "a time in seconds"},                                 \
  [STUDY_SET] = {"--set", OPTION_LIST, "PATH=VALUE"},                                           \
  [STUDY_TOLERANCE] = {"--tolerance", OPTION_VALUE, "a length in meters"},                      \
  [STUDY_PLOT] = {"--plot", OPTION_VALUE, "a file name"},                                       \
  [STUDY_JSON] = {"--json", OPTION_FLAG, NULL}
/* clang-format on */

/* One of these options, or an argument, into the request: 0, or -1 after a message. */
int study_take(study_request *r, options *o, int id);

typedef struct study {
  const study_request *want;
  char path[MODELS_PATH_MAX]; /* of the model, "" if it was generated */
  maggi_model *model;
  maggi_model_info info;
  maggi_data *data;
  maggi_grid grid;
  names objective_names;
  names items; /* of the parameters */
  objectives objectives;
  parameters parameters;
} study;

/* Open the model, choose objectives and parameters.  Objectives that the command line does not name
 * are those of the model, else what `propose` adds to s->objective_names (NULL: there must be some).
 * Exit status, after a message when it is not STATUS_DONE; study_close in either case. */
int study_open(study *s, const study_request *want, int (*propose)(study *s));
void study_close(study *s);

/* Another simulation with the same parameters and tolerance on loops: exit status as above. */
int study_data(const study *s, maggi_data **data);

/* Whether `name`, NULL for none, may be written: exit status, after a message if it is the model file. */
int study_output(const study *s, const char *name);

/* One simulation by the formulation asked for, nothing but its steps.  seconds: the best of a few when they are short.
 * MAGGI_E_STOPPED after a signal. */
maggi_status study_simulate(const study *s, double *seconds);

/* Exit status after a failure of d, with a message unless a signal stopped it. */
int study_fail(const study *s, const maggi_data *d, maggi_status status);

#endif
