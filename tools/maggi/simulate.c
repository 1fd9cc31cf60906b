/* maggi simulate: from the command line to a CSV and a summary. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <maggi/maggi.h>

#include "commands.h"
#include "formulation.h"
#include "interrupt.h"
#include "message.h"
#include "models.h"
#include "options.h"
#include "plan.h"
#include "rows.h"
#include "run.h"
#include "settings.h"
#include "summary.h"
#include "table.h"

typedef struct request {
  const char *model;
  double time;      /* 0: not given */
  double step;      /* 0: not given */
  double tolerance; /* 0: not given */
  long every;       /* 0: not given */
  const char *out;
  const char *reactions;
  int energy;
  int json;
  settings set;
  formulation formulation;
} request;

enum {
  TIME,
  STEP,
  OUT,
  EVERY,
  ENERGY,
  REACTIONS,
  SET,
  FORMULATION,
  PENALTY,
  JACOBIAN,
  TOLERANCE,
  JSON
};

static const option_def simulate_options[] = {
    [TIME] = {"--time", OPTION_VALUE, "a time in seconds"},
    [STEP] = {"--step", OPTION_VALUE, "a time in seconds"},
    [OUT] = {"--out", OPTION_VALUE, "a file name, or - for standard output"},
    [EVERY] = {"--every", OPTION_VALUE, "a number of steps"},
    [ENERGY] = {"--energy", OPTION_FLAG, NULL},
    [REACTIONS] = {"--reactions", OPTION_VALUE, "names of bodies, or all"},
    [SET] = {"--set", OPTION_LIST, "PATH=VALUE"},
    [FORMULATION] = {"--formulation", OPTION_VALUE, "maggi or penalty"},
    [PENALTY] = {"--penalty", OPTION_VALUE, "a stiffness"},
    [JACOBIAN] = {"--jacobian", OPTION_VALUE, "a way to the Jacobian, as adjoint"},
    [TOLERANCE] = {"--tolerance", OPTION_VALUE, "a length in meters"},
    [JSON] = {"--json", OPTION_FLAG, NULL},
    {NULL, OPTION_FLAG, NULL}};

/* One option or argument into the request: 0, or -1 after a message. */
static int take(request *r, options *o, int id)
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

/* What the user may not expect; standard error must stay JSON where the summary goes there. */
static void note_surprises(const run *r, const request *want)
{
  int to_stdout = want->out && strcmp(want->out, "-") == 0;

  if (!(to_stdout && want->json)) plan_note(&r->grid);
  if (!want->out && (want->reactions || want->every > 0))
    message_note("%s has no effect without --out", want->reactions ? "--reactions" : "--every");
}

static int fail_data(const request *want, const maggi_data *d, maggi_status status)
{
  const char *reason = maggi_data_message(d);

  return message_fail(STATUS_FAILED, "%s: %s", want->model,
                      reason[0] ? reason : maggi_status_text(status));
}

/* Simulate with the table open; leaves it closed. */
static int simulate_rows(run *r, const request *want)
{
  maggi_status status;
  int written;

  r->formulation = &want->formulation;
  status = formulation_create(r->formulation, r->data, &r->penalty);
  if (status == MAGGI_OK) status = formulation_reset(r->data, r->penalty);
  if (status == MAGGI_OK) status = run_simulate(r);
  if (status != MAGGI_OK) {
    table_discard(&r->rows->table);
    return fail_data(want, r->data, status);
  }
  if (r->interrupted && r->rows->table.error == EINTR) { /* the signal ended a write */
    table_discard(&r->rows->table);
    return STATUS_INTERRUPTED;
  }
  written = table_close(&r->rows->table);
  if (written != STATUS_DONE) return written;
  return r->interrupted ? STATUS_INTERRUPTED : STATUS_DONE;
}

static int simulate_data(run *r, const request *want, const char *model_path)
{
  int to_stdout = want->out && strcmp(want->out, "-") == 0;
  FILE *summary = to_stdout ? stderr : stdout;
  int status;

  status = formulation_tolerance(&want->formulation, r->data, want->tolerance);
  if (status == STATUS_DONE) status = settings_apply(&want->set, r->rows->model, r->data);
  if (status != STATUS_DONE) return status;
  if (want->out && table_is_same_file(want->out, model_path))
    return message_fail(STATUS_FAILED, "%s: is the model file", want->out);
  interrupt_catch(); /* before there is a file to leave behind */
  if (want->out) {
    status = table_open(&r->rows->table, want->out);
    if (status != STATUS_DONE) return status;
  }
  r->every = want->every > 0 ? want->every : 1;
  r->each_energy = want->energy || want->json;
  r->show_progress = !(to_stdout && isatty(STDOUT_FILENO));

  status = simulate_rows(r, want);
  if (status != STATUS_DONE && status != STATUS_INTERRUPTED) return status;
  note_surprises(r, want);
  (want->json ? summary_json : summary_text)(r, want->out, summary);
  return status;
}

static int simulate_model(const request *want)
{
  char path[MODELS_PATH_MAX];
  maggi_model *m = NULL;
  run r;
  rows w;
  int status;

  status = models_open(want->model, &m, path);
  if (status != STATUS_DONE) return status;
  memset(&r, 0, sizeof r);
  r.rows = &w;
  status = rows_init(&w, m, want->energy, want->reactions);
  if (status == STATUS_DONE) status = plan_grid(&w.info, want->time, want->step, &r.grid);
  if (status == STATUS_DONE && maggi_data_create(m, &r.data) != MAGGI_OK)
    status = message_fail(STATUS_FAILED, "%s: out of memory", want->model);
  if (status == STATUS_DONE) status = simulate_data(&r, want, path);
  maggi_penalty_free(r.penalty);
  maggi_data_free(r.data);
  rows_free(&w);
  maggi_model_free(m);
  return status;
}

int command_simulate(int argc, char **argv)
{
  request want;
  options o;
  int id, status = STATUS_DONE;

  memset(&want, 0, sizeof want);
  formulation_init(&want.formulation);
  if (settings_init(&want.set, argc)) return STATUS_FAILED;
  options_init(&o, simulate_options, argc, argv);
  while ((id = options_next(&o)) != OPTIONS_END) {
    if (id == OPTIONS_HELP) {
      fputs(help_text("simulate"), stdout);
      break;
    }
    if (take(&want, &o, id)) {
      status = STATUS_USAGE;
      break;
    }
  }
  if (id == OPTIONS_END && !want.model)
    status = message_fail(STATUS_USAGE, "simulate: no MODEL given");
  if (id == OPTIONS_END && want.model) {
    status = formulation_check(&want.formulation, want.tolerance);
    if (status == STATUS_DONE) status = simulate_model(&want);
  }
  settings_free(&want.set);
  return status;
}
