/* maggi info: what a model is made of. */
#include <fnmatch.h>
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
#include "tree.h"

#define LINE_MAX_NAMES 90 /* columns of a list of names */

typedef struct subject {
  const maggi_model *model;
  maggi_data *data;
  maggi_model_info info;
  int is_reset;           /* the loops are closed: rank and degrees of freedom are known */
  maggi_loop_state loops; /* if so */
} subject;

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

static int is_wanted(const char *path, const char *glob)
{
  return !glob || fnmatch(glob, path, 0) == 0;
}

/* Parameters that match glob (NULL: all). */
static void print_parameters(const subject *s, const char *glob, const char *indentation)
{
  const char *path;
  int i, width = 0;

  for (i = 0; i < s->info.parameters; ++i) {
    path = maggi_parameter_path(s->model, i);
    if (is_wanted(path, glob) && (int)strlen(path) > width) width = (int)strlen(path);
  }
  for (i = 0; i < s->info.parameters; ++i) {
    path = maggi_parameter_path(s->model, i);
    if (is_wanted(path, glob))
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

static void json_bodies(json *j, const subject *s)
{
  int i, k, coordinate;

  json_open_array(j, "bodies");
  for (i = 0; i < s->info.bodies; ++i) {
    json_open_object(j, NULL);
    json_string(j, "name", maggi_body_name(s->model, i));
    json_string(j, "parent", maggi_body_parent(s->model, i));
    json_string(j, "joint", maggi_joint_type_name(maggi_body_joint(s->model, i)));
    json_open_array(j, "coordinates");
    for (k = 0; (coordinate = tree_coordinate(s->model, i, k)) >= 0; ++k)
      json_string(j, NULL, maggi_coordinate_name(s->model, coordinate));
    json_close_array(j);
    json_close_object(j);
  }
  json_close_array(j);
}

static void json_coordinates(json *j, const subject *s)
{
  int i;

  json_open_array(j, "coordinates");
  for (i = 0; i < s->info.coordinates; ++i) {
    json_open_object(j, NULL);
    json_string(j, "name", maggi_coordinate_name(s->model, i));
    json_string(j, "unit", maggi_coordinate_is_angle(s->model, i) ? "rad" : "m");
    json_boolean(j, "guided", maggi_coordinate_is_guided(s->model, i));
    if (s->is_reset)
      json_boolean(j, "independent", maggi_coordinate_is_independent(s->data, i));
    else
      json_null(j, "independent");
    json_close_object(j);
  }
  json_close_array(j);
}

static void json_loops(json *j, const subject *s)
{
  int i;

  json_open_array(j, "loops");
  for (i = 0; i < s->info.loops; ++i) {
    json_open_object(j, NULL);
    json_string(j, "name", maggi_loop_name(s->model, i));
    json_string(j, "kind", maggi_loop_kind(s->model, i));
    json_integer(j, "rows", maggi_loop_rows(s->model, i));
    json_close_object(j);
  }
  json_close_array(j);
}

static void json_sensors(json *j, const subject *s)
{
  int i;

  json_open_array(j, "sensors");
  for (i = 0; i < s->info.sensor_columns; ++i) {
    json_open_object(j, NULL);
    json_string(j, "name", maggi_sensor_column_name(s->model, i));
    json_string(j, "unit", maggi_sensor_column_unit(s->model, i));
    json_close_object(j);
  }
  json_close_array(j);
}

static void json_filters(json *j, const subject *s)
{
  int i;

  json_integer(j, "filter_states", s->info.filter_states);
  json_open_array(j, "filters");
  for (i = 0; i < s->info.filters; ++i) {
    json_open_object(j, NULL);
    json_string(j, "name", maggi_filter_column_name(s->model, i));
    json_string(j, "unit", maggi_filter_column_unit(s->model, i));
    json_close_object(j);
  }
  json_close_array(j);
}

static void json_declared(json *j, const subject *s, const char *key,
                          const char *(*name)(const maggi_model *m, int index))
{
  int i;

  json_open_array(j, key);
  for (i = 0; name(s->model, i); ++i) json_string(j, NULL, name(s->model, i));
  json_close_array(j);
}

static void json_parameters(json *j, const subject *s, const char *glob)
{
  int i;

  json_open_array(j, "parameters");
  for (i = 0; i < s->info.parameters; ++i) {
    if (!is_wanted(maggi_parameter_path(s->model, i), glob)) continue;
    json_open_object(j, NULL);
    json_string(j, "path", maggi_parameter_path(s->model, i));
    json_string(j, "unit", maggi_parameter_unit(s->model, i));
    json_number(j, "value", maggi_data_get_parameter(s->data, i));
    json_number(j, "default", maggi_parameter_default(s->model, i));
    json_close_object(j);
  }
  json_close_array(j);
}

static void json_all(json *j, const subject *s)
{
  json_string(j, "source", s->info.source);
  json_open_object(j, "simulation");
  if (s->info.simulation.time > 0.0) json_number(j, "time", s->info.simulation.time);
  if (s->info.simulation.step > 0.0) json_number(j, "step", s->info.simulation.step);
  json_close_object(j);
  if (s->is_reset) {
    json_integer(j, "dof", s->loops.dof);
    json_integer(j, "rank", s->loops.rank);
  } else {
    json_null(j, "dof");
    json_null(j, "rank");
  }
  json_integer(j, "loop_equations", s->info.loop_equations);
  json_bodies(j, s);
  json_coordinates(j, s);
  json_loops(j, s);
  json_sensors(j, s);
  json_filters(j, s);
  json_declared(j, s, "objectives", maggi_model_objective);
  json_declared(j, s, "design", maggi_model_design);
  json_parameters(j, s, NULL);
}

static void json_subject(const subject *s, int only_parameters, const char *glob)
{
  json j;

  json_init(&j, stdout);
  json_open_object(&j, NULL);
  json_string(&j, "model", s->info.name);
  if (only_parameters)
    json_parameters(&j, s, glob);
  else
    json_all(&j, s);
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
    if (is_wanted(maggi_parameter_path(s->model, i), want->glob)) break;
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
