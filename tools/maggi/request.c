#include "request.h"

#include <string.h>

enum {
  TIME,
  STEP,
  OUT,
  EVERY,
  ENERGY,
  REACTIONS,
  REPORT,
  OBJECTIVES,
  SET,
  FORMULATION,
  PENALTY,
  JACOBIAN,
  TOLERANCE,
  JSON
};

const option_def request_options[] = {
    [TIME] = {"--time", OPTION_VALUE, "a time in seconds"},
    [STEP] = {"--step", OPTION_VALUE, "a time in seconds"},
    [OUT] = {"--out", OPTION_VALUE, "a file name, or - for standard output"},
    [EVERY] = {"--every", OPTION_VALUE, "a number of steps"},
    [ENERGY] = {"--energy", OPTION_FLAG, NULL},
    [REACTIONS] = {"--reactions", OPTION_VALUE, "names of bodies, or all"},
    [REPORT] = {"--report", OPTION_VALUE, "a file name"},
    [OBJECTIVES] = {"--objectives", OPTION_FLAG, NULL},
    [SET] = {"--set", OPTION_LIST, "PATH=VALUE"},
    [FORMULATION] = {"--formulation", OPTION_VALUE, "maggi or penalty"},
    [PENALTY] = {"--penalty", OPTION_VALUE, "a stiffness"},
    [JACOBIAN] = {"--jacobian", OPTION_VALUE, "a way to the Jacobian, as adjoint"},
    [TOLERANCE] = {"--tolerance", OPTION_VALUE, "a length in meters"},
    [JSON] = {"--json", OPTION_FLAG, NULL},
    {NULL, OPTION_FLAG, NULL}};

int request_init(request *r, int argc)
{
  memset(r, 0, sizeof *r);
  formulation_init(&r->formulation);
  return settings_init(&r->set, argc);
}

void request_free(request *r)
{
  settings_free(&r->set);
}

int request_take(request *r, options *o, int id)
{
  switch (id) {
  case OPTIONS_ARGUMENT:
    return options_argument(o, "MODEL", &r->model);
  case TIME:
    return options_positive("--time", o->value, &r->time);
  case STEP:
    return options_positive("--step", o->value, &r->step);
  case TOLERANCE:
    return options_positive("--tolerance", o->value, &r->tolerance);
  case FORMULATION:
    return formulation_name(&r->formulation, o->value);
  case PENALTY:
    return formulation_penalty(&r->formulation, o->value);
  case JACOBIAN:
    return formulation_jacobian(&r->formulation, o->value);
  case EVERY:
    return options_count("--every", o->value, 1, &r->every);
  case OUT:
    return options_file("--out", o->value, &r->out);
  case REACTIONS:
    r->reactions = o->value;
    return 0;
  case REPORT:
    return options_file("--report", o->value, &r->report);
  case OBJECTIVES:
    r->objectives = 1;
    return 0;
  case SET:
    return settings_add(&r->set, o->value);
  case ENERGY:
    r->energy = 1;
    return 0;
  case JSON:
    r->json = 1;
    return 0;
  default: /* OPTIONS_WRONG */
    return -1;
  }
}
