/* maggi tyre: the formula of a tyre at given slips. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <maggi/maggi.h>

#include "commands.h"
#include "json.h"
#include "message.h"
#include "options.h"
#include "points.h"
#include "table.h"

enum { FORCES = 6, SLOPES = 3 };

typedef struct request {
  const char *tyre;
  const char *out, *file; /* or NULL */
  const char *sweep;
  int json;
  maggi_side side;
  int has_side;
  double slip[POINT_NUMBERS];
  int given[POINT_NUMBERS];
} request;

typedef struct result {
  double force[FORCES], slope[SLOPES];
} result;

static const struct {
  const char *name, *unit;
} columns[] = {{"fx", "N"},
               {"fy", "N"},
               {"fz", "N"},
               {"mx", "N m"},
               {"my", "N m"},
               {"mz", "N m"},
               {"dfy_dalpha", "N/rad"},
               {"dfx_dkappa", "N"},
               {"utilisation", "-"}};

enum { COLUMNS = sizeof columns / sizeof *columns, FZ = 2 };

static double number_of(const result *r, int k)
{
  return k < FORCES ? r->force[k] : r->slope[k - FORCES];
}

/* --------------------------------------------------------------------------------------- output */

static void print_point(const double *slip, const result *r)
{
  int k;

  for (k = 0; k < POINT_NUMBERS; ++k)
    printf("%-12s %22.15g  %s\n", point_name(k), slip[k], point_unit(k));
  for (k = 0; k < COLUMNS; ++k)
    if (k != FZ) printf("%-12s %22.15g  %s\n", columns[k].name, number_of(r, k), columns[k].unit);
}

static void json_points(const request *want, const points *p, const result *r)
{
  json j;
  int i, k;

  json_init(&j, stdout);
  json_open_object(&j, NULL);
  json_string(&j, "tyre", want->tyre);
  json_string(&j, "side", want->side == MAGGI_LEFT ? "left" : "right");
  json_open_array(&j, "points");
  for (i = 0; i < p->number; ++i) {
    json_open_object(&j, NULL);
    for (k = 0; k < POINT_NUMBERS; ++k) json_number(&j, point_name(k), p->slip[i][k]);
    for (k = 0; k < COLUMNS; ++k)
      if (k != FZ) json_number(&j, columns[k].name, number_of(&r[i], k));
    json_close_object(&j);
  }
  json_close_array(&j);
  json_close_object(&j);
}

static int write_table(const char *name, const points *p, const result *r)
{
  table t;
  int i, k, status;

  status = table_open(&t, name);
  if (status != STATUS_DONE) return status;
  for (k = 0; k < POINT_NUMBERS; ++k) table_title(&t, point_name(k), NULL);
  for (k = 0; k < COLUMNS; ++k)
    if (k != FZ) table_title(&t, columns[k].name, NULL);
  table_end_header(&t);
  for (i = 0; i < p->number && !table_has_failed(&t); ++i) {
    for (k = 0; k < POINT_NUMBERS; ++k) table_number(&t, p->slip[i][k]);
    for (k = 0; k < COLUMNS; ++k)
      if (k != FZ) table_number(&t, number_of(&r[i], k));
    table_end_row(&t);
  }
  return table_close(&t);
}

/* -------------------------------------------------------------------------------------- request */

static int output(const request *want, const points *p, const result *r)
{
  int status = STATUS_DONE;

  if (want->out) status = write_table(want->out, p, r);
  if (status != STATUS_DONE) return status;
  if (want->json)
    json_points(want, p, r);
  else if (!want->out && (want->file || want->sweep))
    status = write_table("-", p, r);
  else if (!want->out)
    print_point(p->slip[0], r);
  return status;
}

static int evaluate(const request *want, const maggi_tyre_def *def, points *p)
{
  result *r;
  int i, status;

  status = want->file ? points_read(p, want->file, want->slip, want->given)
                      : points_sweep(p, want->slip, want->sweep);
  if (status != STATUS_DONE) return status;
  r = calloc((size_t)p->number + 1, sizeof *r);
  if (!r) return message_fail(STATUS_FAILED, "out of memory");
  for (i = 0; i < p->number; ++i)
    maggi_tyre_forces(def, want->side, p->slip[i], r[i].force, r[i].slope);
  status = output(want, p, r);
  free(r);
  return status;
}

static int tyre_request(request *want)
{
  const int fz = point_find("fz"), vx = point_find("vx");
  char message[512];
  maggi_tyre_def def;
  points p = {0};
  int status;

  if (want->file && want->sweep)
    return message_fail(STATUS_USAGE, "--file and --sweep do not go together");
  if (want->json && want->out && strcmp(want->out, "-") == 0)
    return message_fail(STATUS_USAGE, "--json and --out - both write to standard output");
  if (maggi_tyre_load(want->tyre, &def, message, sizeof message) != MAGGI_OK)
    return message_fail(STATUS_FAILED, "%s", message);
  if (!want->has_side) want->side = def.side;
  if (!want->given[fz]) want->slip[fz] = def.value[MAGGI_TYRE_LFZO] * def.value[MAGGI_TYRE_FNOMIN];
  if (!want->given[vx]) want->slip[vx] = def.value[MAGGI_TYRE_LONGVL];
  status = evaluate(want, &def, &p);
  points_free(&p);
  return status;
}

enum { SIDE = POINT_NUMBERS, SWEEP, POINTS, OUT, JSON };

static const option_def tyre_options[] = {{"--kappa", OPTION_VALUE, "a number"},
                                          {"--alpha", OPTION_VALUE, "a number"},
                                          {"--gamma", OPTION_VALUE, "a number"},
                                          {"--fz", OPTION_VALUE, "a number"},
                                          {"--vx", OPTION_VALUE, "a number"},
                                          [SIDE] = {"--side", OPTION_VALUE, "left or right"},
                                          [SWEEP] = {"--sweep", OPTION_VALUE, "NAME=FROM:TO:N"},
                                          [POINTS] = {"--file", OPTION_VALUE, "FILE.csv"},
                                          [OUT] = {"--out", OPTION_VALUE, "FILE.csv"},
                                          [JSON] = {"--json", OPTION_FLAG, NULL},
                                          {NULL, OPTION_FLAG, NULL}};

static int take_side(request *r, const char *text)
{
  r->has_side = 1;
  r->side = strcmp(text, "right") == 0 ? MAGGI_RIGHT : MAGGI_LEFT;
  if (r->side == MAGGI_RIGHT || strcmp(text, "left") == 0) return 0;
  message_fail(STATUS_USAGE, "--side: \"%s\" is none of left, right", text);
  return -1;
}

/* One option or argument into the request: 0, or -1 after a message. */
static int take(request *r, options *o, int id)
{
  if (id >= 0 && id < POINT_NUMBERS) {
    r->given[id] = 1;
    return options_number(tyre_options[id].name, o->value, &r->slip[id]);
  }
  switch (id) {
  case OPTIONS_ARGUMENT:
    return options_argument(o, "FILE.tir", &r->tyre);
  case SIDE:
    return take_side(r, o->value);
  case SWEEP:
    r->sweep = o->value;
    return 0;
  case POINTS:
    return options_file("--file", o->value, &r->file);
  case OUT:
    return options_file("--out", o->value, &r->out);
  case JSON:
    r->json = 1;
    return 0;
  default: /* OPTIONS_WRONG */
    return -1;
  }
}

int command_tyre(int argc, char **argv)
{
  request want = {0};
  options o;
  int id;

  options_init(&o, tyre_options, argc, argv);
  while ((id = options_next(&o)) != OPTIONS_END) {
    if (id == OPTIONS_HELP) {
      fputs(help_text("tyre"), stdout);
      return STATUS_DONE;
    }
    if (take(&want, &o, id)) return STATUS_USAGE;
  }
  if (!want.tyre) return message_fail(STATUS_USAGE, "tyre: no FILE.tir given");
  return tyre_request(&want);
}
