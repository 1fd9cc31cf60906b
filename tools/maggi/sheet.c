/* The sheet of a model. */
#include "sheet.h"

#include <fnmatch.h>
#include <string.h>

#include "tree.h"

int sheet_wants(const char *path, const char *glob)
{
  return !glob || fnmatch(glob, path, 0) == 0;
}

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
    if (maggi_coordinate_motion(s->model, i))
      json_string(j, "motion", maggi_coordinate_motion(s->model, i));
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

static void json_point(json *j, const char *key, const double x[3])
{
  int k;

  json_open_array(j, key);
  for (k = 0; k < 3; ++k) json_number(j, NULL, x[k]);
  json_close_array(j);
}

static void json_sensors(json *j, const subject *s)
{
  const maggi_sensor_def *d;
  int i;

  json_open_array(j, "sensors");
  for (i = 0; i < s->info.sensor_columns; ++i) {
    d = maggi_model_sensor(s->model, i);
    json_open_object(j, NULL);
    json_string(j, "name", maggi_sensor_column_name(s->model, i));
    json_string(j, "unit", maggi_sensor_column_unit(s->model, i));
    if (d) json_string(j, "sensor", d->name);
    if (d) json_string(j, "type", maggi_sensor_type_name(d->type));
    if (d && d->body) json_string(j, "body", d->body);
    if (d && d->element) json_string(j, "element", d->element);
    if (d && d->body && d->at_cog) json_boolean(j, "at_cog", 1);
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

static void json_wheels(json *j, const subject *s)
{
  const maggi_wheel_def *d;
  int i;

  json_open_array(j, "wheels");
  for (i = 0; (d = maggi_model_wheel(s->model, i)) != NULL; ++i) {
    json_open_object(j, NULL);
    json_string(j, "name", d->name);
    json_string(j, "body", d->body);
    json_string(j, "carrier", d->carrier);
    json_string(j, "tyre", d->tyre);
    json_string(j, "road", d->road);
    json_string(j, "side", d->side == MAGGI_LEFT ? "left" : "right");
    json_point(j, "point", d->point);
    json_close_object(j);
  }
  json_close_array(j);
}

static void json_forces(json *j, const subject *s)
{
  const maggi_force_def *d;
  int i;

  json_open_array(j, "forces");
  for (i = 0; (d = maggi_model_force(s->model, i)) != NULL; ++i) {
    json_open_object(j, NULL);
    json_string(j, "name", d->name);
    json_string(j, "type", maggi_force_type_name(d->type));
    if (d->body) json_string(j, "body", d->body);
    if (d->coordinate) json_string(j, "coordinate", d->coordinate);
    if (d->function) json_string(j, "function", d->function);
    json_close_object(j);
  }
  json_close_array(j);
}

/* Names and types that `kind` gives for 0, 1, .. */
static void json_kinds(json *j, const subject *s, const char *key,
                       const char *(*kind)(const maggi_model *m, int index, const char **type))
{
  const char *name, *type;
  int i;

  json_open_array(j, key);
  for (i = 0; (name = kind(s->model, i, &type)) != NULL; ++i) {
    json_open_object(j, NULL);
    json_string(j, "name", name);
    json_string(j, "type", type);
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

void sheet_parameters(json *j, const subject *s, const char *glob)
{
  int i;

  json_open_array(j, "parameters");
  for (i = 0; i < s->info.parameters; ++i) {
    if (!sheet_wants(maggi_parameter_path(s->model, i), glob)) continue;
    json_open_object(j, NULL);
    json_string(j, "path", maggi_parameter_path(s->model, i));
    json_string(j, "unit", maggi_parameter_unit(s->model, i));
    json_number(j, "value", maggi_data_get_parameter(s->data, i));
    json_number(j, "default", maggi_parameter_default(s->model, i));
    json_close_object(j);
  }
  json_close_array(j);
}

void sheet_json(json *j, const subject *s)
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
  json_wheels(j, s);
  json_forces(j, s);
  json_kinds(j, s, "roads", maggi_model_road);
  json_kinds(j, s, "functions", maggi_model_function);
  json_declared(j, s, "objectives", maggi_model_objective);
  json_declared(j, s, "design", maggi_model_design);
  sheet_parameters(j, s, NULL);
}
