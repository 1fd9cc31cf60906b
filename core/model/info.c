/* What one can ask a model. */
#include <math.h>
#include <string.h>

#include "model.h"

void maggi_model_get_info(const maggi_model *m, maggi_model_info *info)
{
  info->name = m->name;
  info->source = m->source;
  info->bodies = m->nbody;
  info->coordinates = m->ncoordinate;
  info->guided = m->topo.nguide;
  info->loops = m->nloop;
  info->loop_equations = m->topo.nrow;
  info->parameters = m->nparameter;
  info->sensors = m->topo.nsensor;
  info->sensor_columns = m->ncolumn;
  info->filters = m->topo.nfilter;
  info->filter_states = m->topo.nstate;
  info->simulation = m->simulation;
}

static int in(int i, int n)
{
  return i >= 0 && i < n;
}

const char *maggi_body_name(const maggi_model *m, int body)
{
  return in(body, m->nbody) ? m->body[body].name : NULL;
}

const char *maggi_body_parent(const maggi_model *m, int body)
{
  if (!in(body, m->nbody)) return NULL;
  return m->body[body].parent < 0 ? MAGGI_GROUND : m->body[m->body[body].parent].name;
}

maggi_joint_type maggi_body_joint(const maggi_model *m, int body)
{
  return in(body, m->nbody) ? m->body[body].joint : MAGGI_JOINT_TYPE_COUNT;
}

const char *maggi_coordinate_name(const maggi_model *m, int coordinate)
{
  return in(coordinate, m->ncoordinate) ? m->coordinate[coordinate].name : NULL;
}

int maggi_coordinate_is_guided(const maggi_model *m, int coordinate)
{
  return in(coordinate, m->ncoordinate) && m->coordinate[coordinate].guided;
}

int maggi_coordinate_is_angle(const maggi_model *m, int coordinate)
{
  return in(coordinate, m->ncoordinate) && m->coordinate[coordinate].is_angle;
}

const char *maggi_spring_name(const maggi_model *m, int spring)
{
  return in(spring, m->topo.nspring) ? m->springname[spring] : NULL;
}

const char *maggi_wheel_name(const maggi_model *m, int wheel)
{
  return in(wheel, m->topo.nwheel) ? m->wheelname[wheel] : NULL;
}

const char *maggi_loop_name(const maggi_model *m, int loop)
{
  return in(loop, m->nloop) ? m->loop[loop].name : NULL;
}

const char *maggi_loop_kind(const maggi_model *m, int loop)
{
  return in(loop, m->nloop) ? m->loop[loop].kind : NULL;
}

int maggi_loop_rows(const maggi_model *m, int loop)
{
  return in(loop, m->nloop) ? m->loop[loop].rows : 0;
}

const char *maggi_sensor_column_name(const maggi_model *m, int column)
{
  return in(column, m->ncolumn) ? m->sensorcolumn[column] : NULL;
}

const char *maggi_sensor_column_unit(const maggi_model *m, int column)
{
  return in(column, m->ncolumn) ? m->sensorunit[column] : NULL;
}

const char *maggi_coordinate_motion(const maggi_model *m, int coordinate)
{
  return in(coordinate, m->ncoordinate) ? m->coordinate[coordinate].motion : NULL;
}

static const char *kind_of(const maggi_model_kind *list, int n, int index, const char **type)
{
  if (!in(index, n)) return NULL;
  if (type) *type = list[index].type;
  return list[index].name;
}

const char *maggi_model_road(const maggi_model *m, int index, const char **type)
{
  return kind_of(m->road, m->nroad, index, type);
}

const char *maggi_model_function(const maggi_model *m, int index, const char **type)
{
  return kind_of(m->function, m->nfunction, index, type);
}

const maggi_sensor_def *maggi_model_sensor(const maggi_model *m, int column)
{
  return in(column, m->ncolumn) ? &m->sensor[m->sensorplace[column] / 3] : NULL;
}

const maggi_wheel_def *maggi_model_wheel(const maggi_model *m, int index)
{
  return in(index, m->nwheel) ? &m->wheel[index] : NULL;
}

const maggi_force_def *maggi_model_force(const maggi_model *m, int index)
{
  return in(index, m->nforce) ? &m->force[index] : NULL;
}

const maggi_objective_def *maggi_model_objective_def(const maggi_model *m, int index)
{
  return in(index, m->nobjective) ? &m->objective[index] : NULL;
}

const char *maggi_filter_column_name(const maggi_model *m, int filter)
{
  return in(filter, m->topo.nfilter) ? m->filtercolumn[filter] : NULL;
}

const char *maggi_filter_column_unit(const maggi_model *m, int filter)
{
  return in(filter, m->topo.nfilter) ? m->filterunit[filter] : NULL;
}

int maggi_body_find(const maggi_model *m, const char *name)
{
  int i;

  for (i = 0; i < m->nbody; ++i)
    if (strcmp(m->body[i].name, name) == 0) return i;
  return -1;
}

int maggi_coordinate_find(const maggi_model *m, const char *name)
{
  int i;

  for (i = 0; i < m->ncoordinate; ++i)
    if (strcmp(m->coordinate[i].name, name) == 0) return i;
  return -1;
}

const char *maggi_parameter_path(const maggi_model *m, int index)
{
  return in(index, m->nparameter) ? m->parameter[index].path : NULL;
}

const char *maggi_parameter_unit(const maggi_model *m, int index)
{
  return in(index, m->nparameter) ? m->parameter[index].unit : NULL;
}

double maggi_parameter_default(const maggi_model *m, int index)
{
  return in(index, m->nparameter) ? m->parameter[index].value : NAN;
}

const char *maggi_model_objective(const maggi_model *m, int index)
{
  return in(index, m->nobjective) ? m->objective[index].name : NULL;
}

const char *maggi_model_design(const maggi_model *m, int index)
{
  return in(index, m->ndesign) ? m->design[index].name : NULL;
}

const char *maggi_parameter_wrong(const maggi_parameter *p, double value)
{
  if (!isfinite(value)) return "must be finite";
  if (p->bound == MAGGI_BOUND_NOT_NEGATIVE && value < 0.0) return "must not be negative";
  if (p->bound == MAGGI_BOUND_NOT_POSITIVE && value > 0.0) return "must not be positive";
  if (p->bound == MAGGI_BOUND_POSITIVE && value <= 0.0) return "must be positive";
  return NULL;
}

int maggi_parameter_find(const maggi_model *m, const char *path)
{
  int low = 0, high = m->nparameter, mid, order;

  while (low < high) {
    mid = low + (high - low) / 2;
    order = strcmp(m->parameter[m->pathindex[mid]].path, path);
    if (order == 0) return m->pathindex[mid];
    if (order < 0)
      low = mid + 1;
    else
      high = mid;
  }
  return -1;
}
