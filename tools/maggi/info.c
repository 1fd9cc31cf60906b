/* maggi info: what a model is made of. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <maggi/maggi.h>

#include "commands.h"
#include "json.h"
#include "message.h"
#include "models.h"
#include "options.h"
#include "settings.h"
#include "sheet.h"
#include "tree.h"

#define LINE_MAX_NAMES 90 /* columns of a list of names */

/* ------------------------------------------------------------------------------ as text */

/* Names between commas, in lines that begin with the same indentation. */
static void print_name(const char *name, int *column)
{
  int n = (int)strlen(name);

  if (*column > 0 && *column + n + 2 > LINE_MAX_NAMES) {
    fputs(",\n  ", stdout);
    *column = 0;
  } else if (*column > 0) {
    fputs(", ", stdout);
  } else {
    fputs("  ", stdout);
  }
  fputs(name, stdout);
  *column += n + 2;
}

static void print_counts(const subject *s)
{
  printf("%s\n", s->info.name);
  if (s->info.source[0]) printf("  source: %s\n", s->info.source);
  printf("  %d bodies, %d coordinates (%d guided), %d loops with %d equations\n", s->info.bodies,
         s->info.coordinates, s->info.guided, s->info.loops, s->info.loop_equations);
  if (s->is_reset) printf("  rank %d, %d degrees of freedom\n", s->loops.rank, s->loops.dof);
  if (s->info.simulation.time > 0.0) printf("  proposed time %.6g s\n", s->info.simulation.time);
  if (s->info.simulation.step > 0.0) printf("  proposed step %.6g s\n", s->info.simulation.step);
}

static void print_loops(const subject *s)
{
  int i;

  if (s->info.loops > 0) puts("\nloops");
  for (i = 0; i < s->info.loops; ++i)
    printf("  %-20s %-12s %d equations\n", maggi_loop_name(s->model, i),
           maggi_loop_kind(s->model, i), maggi_loop_rows(s->model, i));
}

static void print_independent(const subject *s)
{
  int i, column = 0;

  if (!s->is_reset) return;
  puts("\nindependent coordinates");
  for (i = 0; i < s->info.coordinates; ++i)
    if (maggi_coordinate_is_independent(s->data, i))
      print_name(maggi_coordinate_name(s->model, i), &column);
  puts(column > 0 ? "" : "  none");
}

static void print_sensors(const subject *s)
{
  int i;

  if (s->info.sensor_columns > 0) puts("\nsensors");
  for (i = 0; i < s->info.sensor_columns; ++i)
    printf("  %-30s %s\n", maggi_sensor_column_name(s->model, i),
           maggi_sensor_column_unit(s->model, i));
}

static void print_filters(const subject *s)
{
  int i;

  if (s->info.filters > 0) printf("\nfilters, %d states\n", s->info.filter_states);
  for (i = 0; i < s->info.filters; ++i)
    printf("  %-30s %s\n", maggi_filter_column_name(s->model, i),
           maggi_filter_column_unit(s->model, i));
}

/* Names that `name` gives for 0, 1, .. */
static void print_declared(const subject *s, const char *title,
                           const char *(*name)(const maggi_model *m, int index))
{
  int i, column = 0;

  if (!name(s->model, 0)) return;
  printf("\n%s\n", title);
  for (i = 0; name(s->model, i); ++i) print_name(name(s->model, i), &column);
  putchar('\n');
}

/* Parameters that match glob (NULL: all). */
static void print_parameters(const subject *s, const char *glob, const char *indentation)
{
  const char *path;
  int i, width = 0;

  for (i = 0; i < s->info.parameters; ++i) {
    path = maggi_parameter_path(s->model, i);
    if (sheet_wants(path, glob) && (int)strlen(path) > width) width = (int)strlen(path);
  }
  for (i = 0; i < s->info.parameters; ++i) {
    path = maggi_parameter_path(s->model, i);
    if (sheet_wants(path, glob))
      printf("%s%-*s  %22.15g  %s\n", indentation, width, path,
             maggi_data_get_parameter(s->data, i), maggi_parameter_unit(s->model, i));
  }
}

static int print_all(const subject *s)
{
  print_counts(s);
  puts("\nbodies");
  if (tree_print(s->model, stdout)) return message_fail(STATUS_FAILED, "out of memory");
  print_loops(s);
  print_independent(s);
  print_sensors(s);
  print_filters(s);
  print_declared(s, "objectives", maggi_model_objective);
  print_declared(s, "design parameters", maggi_model_design);
  if (s->info.parameters > 0) puts("\nparameters");
  print_parameters(s, NULL, "  ");
  return STATUS_DONE;
}

/* ------------------------------------------------------------------------------ as JSON */

static void json_subject(const subject *s, int only_parameters, const char *glob)
{
  json j;

  json_init(&j, stdout);
  json_open_object(&j, NULL);
  json_string(&j, "model", s->info.name);
  if (only_parameters)
    sheet_parameters(&j, s, glob);
  else
    sheet_json(&j, s);
  json_close_object(&j);
}

/* ------------------------------------------------------------------------------ the command */

typedef struct request {
  const char *model;
  int json;
  int parameters;
  const char *glob; /* or NULL */
  settings set;
} request;

enum { SET, PARAMETERS, JSON };

static const option_def info_options[] = {[SET] = {"--set", OPTION_LIST, "PATH=VALUE"},
                                          [PARAMETERS] = {"--parameters", OPTION_OPTIONAL, NULL},
                                          [JSON] = {"--json", OPTION_FLAG, NULL},
                                          {NULL, OPTION_FLAG, NULL}};

static int info_parameters(const subject *s, const request *want)
{
  int i;

  for (i = 0; i < s->info.parameters; ++i)
    if (sheet_wants(maggi_parameter_path(s->model, i), want->glob)) break;
  if (want->glob && i == s->info.parameters)
    return message_fail(STATUS_USAGE, "--parameters: no parameter of model %s matches \"%s\"",
                        s->info.name, want->glob);
  if (want->json)
    json_subject(s, 1, want->glob);
  else
    print_parameters(s, want->glob, "");
  return STATUS_DONE;
}

/* A model whose loops do not close is described all the same, without its rank, then fails. */
static int info_model(subject *s, const request *want)
{
  const char *reason;
  maggi_status reset;
  int status = STATUS_DONE;

  reset = maggi_data_reset(s->data);
  s->is_reset = reset == MAGGI_OK;
  if (s->is_reset) maggi_get_loop_state(s->data, &s->loops);
  if (want->json)
    json_subject(s, 0, NULL);
  else
    status = print_all(s);
  if (status != STATUS_DONE || s->is_reset) return status;
  reason = maggi_data_message(s->data);
  return message_fail(STATUS_FAILED, "%s: %s", want->model,
                      reason[0] ? reason : maggi_status_text(reset));
}

static int info_request(const request *want)
{
  char path[MODELS_PATH_MAX];
  maggi_model *m = NULL;
  subject s;
  int status;

  status = models_open(want->model, &m, path);
  if (status != STATUS_DONE) return status;
  memset(&s, 0, sizeof s);
  s.model = m;
  maggi_model_get_info(m, &s.info);
  if (maggi_data_create(m, &s.data) != MAGGI_OK)
    status = message_fail(STATUS_FAILED, "%s: out of memory", want->model);
  else
    status = settings_apply(&want->set, m, s.data);
  if (status == STATUS_DONE)
    status = want->parameters ? info_parameters(&s, want) : info_model(&s, want);
  maggi_data_free(s.data);
  maggi_model_free(m);
  return status;
}

/* One option or argument into the request: 0, or -1 after a message. */
static int take(request *r, options *o, int id)
{
  switch (id) {
  case OPTIONS_ARGUMENT:
    return options_argument(o, "MODEL", &r->model);
  case SET:
    return settings_add(&r->set, o->value);
  case PARAMETERS:
    r->parameters = 1;
    r->glob = o->value;
    return 0;
  case JSON:
    r->json = 1;
    return 0;
  default: /* OPTIONS_WRONG */
    return -1;
  }
}

int command_info(int argc, char **argv)
{
  request want;
  options o;
  int id, status = STATUS_DONE;

  memset(&want, 0, sizeof want);
  if (settings_init(&want.set, argc)) return STATUS_FAILED;
  options_init(&o, info_options, argc, argv);
  while ((id = options_next(&o)) != OPTIONS_END) {
    if (id == OPTIONS_HELP) {
      fputs(help_text("info"), stdout);
      break;
    }
    if (take(&want, &o, id)) {
      status = STATUS_USAGE;
      break;
    }
  }
  if (id == OPTIONS_END && !want.model) status = message_fail(STATUS_USAGE, "info: no MODEL given");
  if (id == OPTIONS_END && want.model) status = info_request(&want);
  settings_free(&want.set);
  return status;
}
