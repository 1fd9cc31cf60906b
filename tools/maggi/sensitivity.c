/* maggi sensitivity: gradients of objectives, and the parameters that matter. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <maggi/maggi.h>

#include "commands.h"
#include "gradients.h"
#include "interrupt.h"
#include "message.h"
#include "nearest.h"
#include "options.h"
#include "plan.h"
#include "report.h"
#include "script.h"
#include "states.h"
#include "study.h"
#include "table.h"

typedef struct request {
  study_request study;
  maggi_gradient_options options;
  long threads;
  long every; /* 0: not given */
  const char *states;
  const char *csv;
  int all_rows;
  char given[OPTIONS_MAX];
} request;

enum {
  METHOD = STUDY_OPTIONS,
  PERTURBATION,
  SNAPSHOTS,
  MEMORY,
  THREADS,
  STATES,
  EVERY,
  CSV,
  ALL_ROWS,
  FORMULATION,
  PENALTY,
  JACOBIAN
};

static const option_def sensitivity_options[] = {
    STUDY_OPTION_LIST,
    [METHOD] = {"--method", OPTION_VALUE, "a method, as adjoint"},
    [PERTURBATION] = {"--perturbation", OPTION_VALUE, "a relative perturbation"},
    [SNAPSHOTS] = {"--snapshots", OPTION_VALUE, "a number of snapshots"},
    [MEMORY] = {"--memory", OPTION_VALUE, "a number of bytes"},
    [THREADS] = {"--threads", OPTION_VALUE, "a number of threads"},
    [STATES] = {"--states", OPTION_VALUE, "a file name"},
    [EVERY] = {"--every", OPTION_VALUE, "a number of steps"},
    [CSV] = {"--csv", OPTION_VALUE, "a file name"},
    [ALL_ROWS] = {"--all-rows", OPTION_FLAG, NULL},
    [FORMULATION] = {"--formulation", OPTION_VALUE, "maggi or penalty"},
    [PENALTY] = {"--penalty", OPTION_VALUE, "a stiffness"},
    [JACOBIAN] = {"--jacobian", OPTION_VALUE, "a way to the Jacobian, as adjoint"},
    {NULL, OPTION_FLAG, NULL}};

#define THREADS_MAX 1024

static int take_method(const char *text, maggi_method *method)
{
  nearest n;
  int i, found = maggi_method_find(text);

  if (found >= 0) {
    *method = (maggi_method)found;
    return 0;
  }
  nearest_init(&n, text);
  for (i = 0; i < MAGGI_METHOD_COUNT; ++i) nearest_offer(&n, maggi_method_name((maggi_method)i));
  message_fail(STATUS_USAGE, "--method: no method \"%s\"%s", text, nearest_hint(&n));
  return -1;
}

static int take_threads(const char *text, long *threads)
{
  if (options_count("--threads", text, 1, threads)) return -1;
  if (*threads <= THREADS_MAX) return 0;
  message_fail(STATUS_USAGE, "--threads: %s is more than %d", text, THREADS_MAX);
  return -1;
}

static int take_snapshots(const char *text, int *snapshots)
{
  if (options_size(text, snapshots) == 0) return 0;
  message_fail(STATUS_USAGE, "--snapshots: \"%s\" is not a number from 1 on", text);
  return -1;
}

/* One option or argument into the request: 0, or -1 after a message. */
static int take(request *r, options *o, int id)
{
  switch (id) {
  case METHOD:
    return take_method(o->value, &r->options.method);
  case PERTURBATION:
    return options_positive("--perturbation", o->value, &r->options.perturbation);
  case SNAPSHOTS:
    return take_snapshots(o->value, &r->options.snapshots);
  case MEMORY:
    return options_bytes("--memory", o->value, &r->options.memory);
  case THREADS:
    return take_threads(o->value, &r->threads);
  case STATES:
    return options_file("--states", o->value, &r->states);
  case EVERY:
    return options_count("--every", o->value, 1, &r->every);
  case CSV:
    return options_file("--csv", o->value, &r->csv);
  case ALL_ROWS:
    r->all_rows = 1;
    return 0;
  case FORMULATION:
    return formulation_name(&r->study.formulation, o->value);
  case PENALTY:
    return formulation_penalty(&r->study.formulation, o->value);
  case JACOBIAN:
    return formulation_jacobian(&r->study.formulation, o->value);
  default:
    return study_take(&r->study, o, id);
  }
}

static int is_standard_output(const char *name)
{
  return name && strcmp(name, "-") == 0;
}

/* What the options have to do with each other: exit status. */
static int check(const request *r)
{
  maggi_method method = r->options.method;
  int is_penalty = r->study.formulation.is_penalty;

  if (r->states && is_penalty)
    return message_fail(STATUS_USAGE, "--states: not with --formulation penalty");
  if (method == MAGGI_METHOD_CONTINUOUS_ADJOINT && is_penalty)
    return message_fail(STATUS_USAGE,
                        "--method: continuous-adjoint not with --formulation penalty");
  if (r->states && method != MAGGI_METHOD_DIRECT)
    return message_fail(STATUS_USAGE, "--states: only with --method direct");
  if (is_standard_output(r->study.plot))
    return message_fail(STATUS_USAGE, "--plot: a picture does not go to standard output");
  if (r->states && r->csv && strcmp(r->states, r->csv) == 0)
    return message_fail(STATUS_USAGE, "--csv: %s is the file of --states", r->csv);
  return STATUS_DONE;
}

/* What the user may not expect. */
static void note_surprises(const request *r, const study *s)
{
  maggi_method method = r->options.method;
  int is_adjoint = method == MAGGI_METHOD_ADJOINT || method == MAGGI_METHOD_CONTINUOUS_ADJOINT;
  int is_difference = !is_adjoint && method != MAGGI_METHOD_DIRECT;
  const char *name = maggi_method_name(method);

  plan_note(&s->grid);
  if (r->given[PERTURBATION] && !is_difference)
    message_note("--perturbation has no effect with the method %s", name);
  if (r->given[SNAPSHOTS] && r->study.formulation.is_penalty)
    message_note("--snapshots has no effect with the penalty formulation");
  else if (r->given[SNAPSHOTS] && method != MAGGI_METHOD_ADJOINT)
    message_note("--snapshots has no effect with the method %s", name);
  if (r->given[MEMORY] && !is_adjoint)
    message_note("--memory has no effect with the method %s", name);
  if (r->threads > 1 && is_adjoint)
    message_note("--threads has no effect with the method %s", name);
  if (r->every > 0 && !r->states) message_note("--every has no effect without --states");
}

/* The files, opened before the work and closed after it. */
typedef struct files {
  table states, csv;
} files;

static int open_files(files *f, const request *want, const study *s)
{
  int status;

  status = study_output(s, want->states);
  if (status == STATUS_DONE) status = study_output(s, want->csv);
  if (status == STATUS_DONE) status = study_output(s, want->study.plot);
  if (status == STATUS_DONE && want->study.plot)
    status = script_check(&script_plot, want->study.plot);
  interrupt_catch(); /* before there is a file to leave behind */
  if (status == STATUS_DONE && want->states) status = table_open(&f->states, want->states);
  if (status == STATUS_DONE && want->csv) status = table_open(&f->csv, want->csv);
  return status;
}

/* Everything that takes time: exit status. */
static int compute(report *r, gradients *g, files *f, const request *want)
{
  maggi_status status;
  int result;

  status = study_simulate(r->study, &r->simulation_wall);
  if (status != MAGGI_OK) return study_fail(r->study, r->study->data, status);
  result = gradients_run(g, r->study);
  if (result == STATUS_DONE && want->states)
    result = states_write(r->study, &f->states, want->every > 0 ? want->every : 1);
  if (result == STATUS_DONE && report_init(r))
    result = message_fail(STATUS_FAILED, "%s: out of memory", want->study.model);
  return result;
}

static int draw(const report *r, const char *out)
{
  FILE *input = script_input(&script_plot);

  if (!input) return STATUS_FAILED;
  report_json(r, input);
  return script_draw(&script_plot, input, out);
}

/* Write the files, then the report: exit status. */
static int publish(const report *r, files *f, const request *want)
{
  FILE *out = is_standard_output(want->states) || is_standard_output(want->csv) ? stderr : stdout;
  int status;

  if (want->csv) report_csv(r, &f->csv);
  status = table_close(&f->states);
  if (status == STATUS_DONE) status = table_close(&f->csv);
  if (status == STATUS_DONE && want->study.plot) status = draw(r, want->study.plot);
  if (status != STATUS_DONE) return status;
  if (out == stdout) note_surprises(want, r->study);
  (want->study.json ? report_json : report_text)(r, out);
  return STATUS_DONE;
}

static int allocate(gradients *g, const study *s)
{
  size_t n = (size_t)s->parameters.number, nobjective = (size_t)s->objectives.number;

  g->value = calloc(nobjective, sizeof *g->value);
  g->gradient = calloc(nobjective * n, sizeof *g->gradient);
  if (g->options.method == MAGGI_METHOD_DIRECT) {
    g->relevance = calloc(n, sizeof *g->relevance);
    g->coordinate = calloc(n, sizeof *g->coordinate);
    if (!g->relevance || !g->coordinate) return -1;
  }
  return g->value && g->gradient ? 0 : -1;
}

static int analyse(const study *s, const request *want)
{
  int is_adjoint = want->options.method == MAGGI_METHOD_ADJOINT ||
                   want->options.method == MAGGI_METHOD_CONTINUOUS_ADJOINT;
  gradients g;
  report r;
  files f;
  int status;

  memset(&g, 0, sizeof g);
  memset(&r, 0, sizeof r);
  memset(&f, 0, sizeof f);
  g.options = want->options;
  g.options.time = s->grid.time;
  g.options.step = s->grid.step;
  if (want->study.formulation.is_penalty) g.options.penalty = &want->study.formulation.options;
  g.threads = is_adjoint ? 1 : (int)want->threads;
  r.study = s;
  r.gradients = &g;
  r.all_rows = want->all_rows;
  status = allocate(&g, s) ? message_fail(STATUS_FAILED, "%s: out of memory", want->study.model)
                           : open_files(&f, want, s);
  if (status == STATUS_DONE) status = compute(&r, &g, &f, want);
  if (status == STATUS_DONE) status = publish(&r, &f, want);
  table_discard(&f.states);
  table_discard(&f.csv);
  report_free(&r);
  free(g.value);
  free(g.gradient);
  free(g.relevance);
  free(g.coordinate);
  return status;
}

static int analyse_model(const request *want)
{
  study s;
  int status;

  status = check(want);
  if (status != STATUS_DONE) return status;
  status = study_open(&s, &want->study, NULL);
  if (status == STATUS_DONE) status = analyse(&s, want);
  study_close(&s);
  return status;
}

int command_sensitivity(int argc, char **argv)
{
  request want;
  options o;
  int id, status = STATUS_DONE;

  memset(&want, 0, sizeof want);
  maggi_gradient_options_init(&want.options);
  want.options.method = MAGGI_METHOD_ADJOINT;
  want.threads = 1;
  formulation_init(&want.study.formulation);
  if (settings_init(&want.study.set, argc)) return STATUS_FAILED;
  options_init(&o, sensitivity_options, argc, argv);
  while ((id = options_next(&o)) != OPTIONS_END) {
    if (id == OPTIONS_HELP) {
      fputs(help_text("sensitivity"), stdout);
      break;
    }
    if (take(&want, &o, id)) {
      status = STATUS_USAGE;
      break;
    }
  }
  memcpy(want.given, o.given, sizeof want.given);
  if (id == OPTIONS_END && !want.study.model)
    status = message_fail(STATUS_USAGE, "sensitivity: no MODEL given");
  if (id == OPTIONS_END && want.study.model) {
    status = formulation_check(&want.study.formulation, want.study.tolerance);
    if (status == STATUS_DONE) status = analyse_model(&want);
  }
  settings_free(&want.study.set);
  return status;
}
