/* maggi simulate: from the command line to a CSV and a summary. */
#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700 /* mkdtemp */
#endif
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <maggi/maggi.h>

#include "commands.h"
#include "formulation.h"
#include "interrupt.h"
#include "message.h"
#include "models.h"
#include "options.h"
#include "page.h"
#include "plan.h"
#include "record.h"
#include "request.h"
#include "rows.h"
#include "run.h"
#include "settings.h"
#include "summary.h"
#include "table.h"

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

static FILE *summary_file(const request *want)
{
  return want->out && strcmp(want->out, "-") == 0 ? stderr : stdout;
}

/* The objectives that the model declares, if they are wanted. */
static int evaluate(run *r, const request *want, values *v)
{
  int status;

  if (!want->objectives && !want->report) return STATUS_DONE;
  status = values_compute(v, r->rows->model, &want->set, &want->formulation, want->tolerance,
                          &r->grid, want->model, want->objectives);
  if (status == STATUS_DONE) r->values = v;
  if (status != STATUS_INTERRUPTED) return status;
  r->interrupted = 1; /* the rows are there all the same */
  return STATUS_DONE;
}

/* The table and what stands beside it: both appear, or none. */
static int write_files(run *r, record *log)
{
  int status = record_write(log, r);

  if (status == STATUS_DONE) status = table_close(&r->rows->table);
  if (status == STATUS_DONE) status = record_close(log);
  return status;
}

/* Simulate with the table open; leaves it closed. */
static int simulate_rows(run *r, const request *want, record *log)
{
  maggi_status status;
  values found;
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
  memset(&found, 0, sizeof found);
  written = r->interrupted ? STATUS_DONE : evaluate(r, want, &found);
  if (written == STATUS_DONE && want->out) written = write_files(r, log);
  if (written == STATUS_DONE) {
    note_surprises(r, want);
    (want->json ? summary_json : summary_text)(r, want->temporary[0] ? NULL : want->out,
                                               summary_file(want));
  }
  table_discard(&r->rows->table);
  values_free(&found);
  r->values = NULL;
  if (written != STATUS_DONE) return written;
  return r->interrupted ? STATUS_INTERRUPTED : STATUS_DONE;
}

static int simulate_data(run *r, const request *want, record *log)
{
  int status;

  status = formulation_tolerance(&want->formulation, r->data, want->tolerance);
  if (status == STATUS_DONE) status = settings_apply(&want->set, r->rows->model, r->data);
  if (status != STATUS_DONE) return status;
  if (want->out && table_is_same_file(want->out, log->path))
    return message_fail(STATUS_FAILED, "%s: is the model file", want->out);
  interrupt_catch(); /* before there is a file to leave behind */
  if (want->out) {
    status = table_open(&r->rows->table, want->out);
    if (status != STATUS_DONE) return status;
  }
  r->every = want->every > 0 ? want->every : 1;
  r->each_energy = want->energy || want->json;
  r->show_progress = !(summary_file(want) == stderr && isatty(STDOUT_FILENO));
  return simulate_rows(r, want, log);
}

static int simulate_model(const request *want, record *log)
{
  char path[MODELS_PATH_MAX];
  maggi_model *m = NULL;
  run r;
  rows w;
  int status;

  status = models_open(want->model, &m, path);
  if (status != STATUS_DONE) return status;
  log->model = want->model;
  log->path = path;
  log->out = want->temporary[0] ? NULL : want->out;
  log->set = &want->set;
  log->tolerance = want->tolerance;
  memset(&r, 0, sizeof r);
  r.rows = &w;
  status = rows_init(&w, m, want->energy || want->temporary[0], want->reactions);
  if (status == STATUS_DONE) status = plan_grid(&w.info, want->time, want->step, &r.grid);
  if (status == STATUS_DONE && maggi_data_create(m, &r.data) != MAGGI_OK)
    status = message_fail(STATUS_FAILED, "%s: out of memory", want->model);
  if (status == STATUS_DONE) status = simulate_data(&r, want, log);
  maggi_penalty_free(r.penalty);
  maggi_data_free(r.data);
  rows_free(&w);
  maggi_model_free(m);
  return status;
}

/* Somewhere for the table of a report alone. */
static int make_temporary(request *want)
{
  const char *place = getenv("TMPDIR");
  int n;

  if (!place || !place[0] || strlen(place) > 32) place = "/tmp";
  n = snprintf(want->temporary, sizeof want->temporary, "%s/maggi-XXXXXX", place);
  if (n >= (int)sizeof want->temporary || !mkdtemp(want->temporary)) {
    want->temporary[0] = '\0';
    return message_fail(STATUS_FAILED, "%s: %s", place, strerror(errno));
  }
  snprintf(want->table, sizeof want->table, "%s/run.csv", want->temporary);
  want->out = want->table;
  return STATUS_DONE;
}

static void remove_temporary(const request *want)
{
  char *name;

  if (!want->temporary[0]) return;
  name = record_name(want->table);
  unlink(want->table);
  if (name) unlink(name);
  rmdir(want->temporary);
  free(name);
}

/* The report is looked at first: a run may be long. */
static int simulate_report(request *want, record *log)
{
  int status = page_check(want->report);

  if (status == STATUS_DONE && !want->out) status = make_temporary(want);
  if (status == STATUS_DONE) status = simulate_model(want, log);
  if (status == STATUS_DONE)
    status = page_draw(1, (const char *const *)&want->out, want->report, NULL, NULL);
  remove_temporary(want);
  return status;
}

static int simulate(request *want, int argc, char **argv)
{
  options o;
  record log;
  int id, status;

  if (record_init(&log, argc, argv)) return STATUS_FAILED;
  options_init(&o, request_options, argc, argv);
  while ((id = options_next(&o)) != OPTIONS_END) {
    if (id == OPTIONS_HELP) {
      fputs(help_text("simulate"), stdout);
      record_free(&log);
      return STATUS_DONE;
    }
    if (request_take(want, &o, id)) {
      record_free(&log);
      return STATUS_USAGE;
    }
  }
  if (!want->model)
    status = message_fail(STATUS_USAGE, "simulate: no MODEL given");
  else if (want->report && summary_file(want) == stderr)
    status = message_fail(STATUS_USAGE, "--report: the table must be a file, not standard output");
  else
    status = formulation_check(&want->formulation, want->tolerance);
  if (status == STATUS_DONE)
    status = want->report ? simulate_report(want, &log) : simulate_model(want, &log);
  record_free(&log);
  return status;
}

int command_simulate(int argc, char **argv)
{
  request want;
  int status;

  if (request_init(&want, argc)) return STATUS_FAILED;
  status = simulate(&want, argc, argv);
  request_free(&want);
  return status;
}
