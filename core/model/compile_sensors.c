/* Sensors: what each looks at, and its columns. */
#include <string.h>

#include "compile.h"

typedef struct titles {
  const char *name[3], *unit[3]; /* NULL: there is no such column */
} titles;

static const titles columns_of[MAGGI_SENSOR_TYPE_COUNT] = {
    [MAGGI_SENSOR_POSITION] = {{"x", "y", "z"}, {"m", "m", "m"}},
    [MAGGI_SENSOR_VELOCITY] = {{"x", "y", "z"}, {"m/s", "m/s", "m/s"}},
    [MAGGI_SENSOR_ACCELERATION] = {{"x", "y", "z"}, {"m/s^2", "m/s^2", "m/s^2"}},
    [MAGGI_SENSOR_ANGLES] = {{"roll", "pitch", "yaw"}, {"rad", "rad", "rad"}},
    [MAGGI_SENSOR_ANGLE_RATES] = {{"roll_rate", "pitch_rate", "yaw_rate"},
                                  {"rad/s", "rad/s", "rad/s"}},
    [MAGGI_SENSOR_ANGULAR_VELOCITY] = {{"x", "y", "z"}, {"rad/s", "rad/s", "rad/s"}},
    [MAGGI_SENSOR_ANGULAR_ACCELERATION] = {{"x", "y", "z"}, {"rad/s^2", "rad/s^2", "rad/s^2"}},
    [MAGGI_SENSOR_SPRING] = {{"length", "rate", "force"}, {"m", "m/s", "N"}},
    [MAGGI_SENSOR_JOINT_SPRING] = {{"value", "rate", "torque"}, {"m", "m/s", "N"}},
    [MAGGI_SENSOR_ROD] = {{"length", "rate", "force"}, {"m", "m/s", "N"}},
    [MAGGI_SENSOR_TYRE_SLIP] = {{"kappa", "alpha", "gamma"}, {"-", "rad", "rad"}},
    [MAGGI_SENSOR_TYRE_FORCE] = {{"fx", "fy", "fz"}, {"N", "N", "N"}},
    [MAGGI_SENSOR_TYRE_MOMENT] = {{"mx", "my", "mz"}, {"N m", "N m", "N m"}},
    [MAGGI_SENSOR_LATERAL_ACCELERATION] = {{"exact", "planar", "approximate"},
                                           {"m/s^2", "m/s^2", "m/s^2"}},
    [MAGGI_SENSOR_SIDESLIP] = {{"angle", "speed", "curvature"}, {"rad", "m/s", "1/m"}},
    [MAGGI_SENSOR_LEVEL_VELOCITY] = {{"x", "y", "z"}, {"m/s", "m/s", "m/s"}},
    [MAGGI_SENSOR_LEVEL_ACCELERATION] = {{"x", "y", "z"}, {"m/s^2", "m/s^2", "m/s^2"}},
    [MAGGI_SENSOR_BODY_ACCELERATION] = {{"x", "y", "z"}, {"m/s^2", "m/s^2", "m/s^2"}},
    [MAGGI_SENSOR_COMBINATION] = {{"value"}, {"-"}},
    [MAGGI_SENSOR_TYRE_CONTACT] = {{"deflection", "loaded_radius", "rolling_radius"},
                                   {"m", "m", "m"}},
    [MAGGI_SENSOR_TYRE_SLOPE] = {{"dfy_dalpha", "dfx_dkappa", "utilisation"}, {"N/rad", "N", "-"}}};

static const titles columns_of_angle = {{"value", "rate", "torque"}, {"rad", "rad/s", "N m"}};

static int has_point(maggi_sensor_type type)
{
  return type <= MAGGI_SENSOR_ACCELERATION ||
         (type >= MAGGI_SENSOR_LATERAL_ACCELERATION && type <= MAGGI_SENSOR_BODY_ACCELERATION);
}

static int has_body(maggi_sensor_type type)
{
  return has_point(type) || type < MAGGI_SENSOR_SPRING;
}

static int need_of(maggi_sensor_type type)
{
  switch (type) {
  case MAGGI_SENSOR_ACCELERATION:
  case MAGGI_SENSOR_ANGULAR_ACCELERATION:
  case MAGGI_SENSOR_LATERAL_ACCELERATION:
  case MAGGI_SENSOR_SIDESLIP:
  case MAGGI_SENSOR_LEVEL_ACCELERATION:
  case MAGGI_SENSOR_BODY_ACCELERATION:
    return MAGGI_NEED_ACCELERATION;
  case MAGGI_SENSOR_ROD:
    return MAGGI_NEED_MULTIPLIER;
  default:
    return 0;
  }
}

/* number of the element of a list with the name */
#define FIND(list, n, element)                                                                     \
  for (i = 0; i < (n) && d->element; ++i)                                                          \
    if (strcmp((list)[i].name, d->element) == 0) *element = i;

static maggi_status find_element(maggi_compile *c, const maggi_sensor_def *d, int *element)
{
  const char *what = "rod";
  int i;

  *element = -1;
  if (d->type == MAGGI_SENSOR_SPRING) {
    what = "spring";
    FIND(c->b->spring, c->b->nspring, element)
  } else if (d->type == MAGGI_SENSOR_JOINT_SPRING) {
    what = "joint spring";
    FIND(c->b->joint_spring, c->b->njoint_spring, element)
  } else if (d->type >= MAGGI_SENSOR_TYRE_SLIP && d->type <= MAGGI_SENSOR_TYRE_SLOPE) {
    what = "wheel";
    FIND(c->b->wheel, c->b->nwheel, element)
  } else {
    FIND(c->b->rod, c->b->nrod, element)
  }
  if (*element >= 0) return MAGGI_OK;
  if (!d->element)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL, "sensors.%s: element is missing", d->name);
  return maggi_builder_fail(c->b, MAGGI_E_MODEL, "sensors.%s: element \"%s\" is no %s", d->name,
                            d->element, what);
}

/* rods are the last loops, each of one building block */
static int prim_of_rod(const maggi_compile *c, int rod)
{
  return c->primkind.n - c->b->nrod + rod;
}

/* lumps begin with those of the bodies, in the order of the file */
static maggi_status add_cog(maggi_compile *c, const maggi_sensor_def *d, int body)
{
  int i = maggi_compile_body(c, d->body), adr;

  if (i < 0)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL,
                              "sensors.%s: point is missing, and the ground has no centre of "
                              "gravity",
                              d->name);
  if (c->no_memory) return MAGGI_E_MEMORY;
  adr = c->lumpadr.v[i] + 1;
  PUSH(pointbody, body);
  PUSH(pointadr, adr);
  PUSH(pointadr2, c->b->body[i].is_bar ? adr + 3 : -1);
  return MAGGI_OK;
}

static maggi_status add_point(maggi_compile *c, const maggi_sensor_def *d, int body)
{
  if (d->at_cog) return add_cog(c, d, body);
  PUSH(pointbody, body);
  PUSH(pointadr, maggi_parameter_add3(c, d->point, "m", "sensors.%s.point", d->name));
  PUSH(pointadr2, -1);
  return MAGGI_OK;
}

/* ---------------------------------------------------------------------------------- combinations */

static int find_column(const maggi_model *m, const char *name)
{
  int i;

  for (i = 0; i < m->ncolumn; ++i)
    if (strcmp(m->sensorcolumn[i], name) == 0) return i;
  return -1;
}

/* that of the weight of a term; NULL without memory */
static const char *unit_of_weight(maggi_arena *arena, const char *sum, const char *term)
{
  return strcmp(sum, term) == 0 ? "-" : maggi_arena_format(arena, "(%s)/(%s)", sum, term);
}

static maggi_status add_weights(maggi_compile *c, const maggi_sensor_def *d, const char *sum,
                                int *adr)
{
  const char *unit;
  int i, at, column;

  for (i = 0; i < d->nterm; ++i) {
    column = find_column(c->m, d->terms[i]);
    unit = unit_of_weight(&c->m->arena, sum, c->m->sensorunit[column]);
    if (!unit || c->no_memory) return MAGGI_E_MEMORY;
    at = maggi_parameter_add(c, d->weights ? d->weights[i] : 1.0, unit, MAGGI_BOUND_NONE,
                             "sensors.%s.weights.%d", d->name, i + 1);
    if (i == 0) *adr = at;
  }
  return MAGGI_OK;
}

static maggi_status add_combination(maggi_compile *c, const maggi_sensor_def *d, titles *columns,
                                    int *adr, int *need)
{
  maggi_model *m = c->m;
  const char *unit = NULL;
  int i, column, place;

  for (i = 0; i < d->nterm; ++i) {
    column = find_column(m, d->terms[i]);
    if (column < 0)
      return maggi_builder_fail(c->b, MAGGI_E_MODEL,
                                "sensors.%s: terms: \"%s\" is no column of a sensor before it",
                                d->name, d->terms[i]);
    unit = !unit || strcmp(unit, m->sensorunit[column]) == 0 ? m->sensorunit[column] : "-";
    place = m->sensorplace[column];
    PUSH(termsensor, place / 3);
    PUSH(termcolumn, place % 3);
    if (c->no_memory) return MAGGI_E_MEMORY;
    *need |= c->sensorneed.v[place / 3];
  }
  if (d->unit) unit = maggi_arena_text(&m->arena, d->unit);
  if (!unit) return MAGGI_E_MEMORY;
  columns->unit[0] = unit;
  return add_weights(c, d, unit, adr);
}

/* ---------------------------------------------------------------------------------------- sensors */

static void add_numbers(maggi_compile *c, const maggi_sensor_def *d, int *adr)
{
  if (d->type == MAGGI_SENSOR_LATERAL_ACCELERATION || d->type == MAGGI_SENSOR_SIDESLIP)
    *adr = maggi_parameter_add(c, d->low_speed, "m/s", MAGGI_BOUND_POSITIVE, "sensors.%s.low_speed",
                               d->name);
  if (d->type == MAGGI_SENSOR_LATERAL_ACCELERATION)
    maggi_parameter_add(c, d->low_acceleration, "m/s^2", MAGGI_BOUND_POSITIVE,
                        "sensors.%s.low_acceleration", d->name);
}

static maggi_status add_sensor(maggi_compile *c, const maggi_sensor_def *d, titles *columns)
{
  maggi_status status;
  int body = c->t->nbody, point = -1, element = -1, adr = -1, need = need_of(d->type);

  *columns = columns_of[d->type];
  if (has_body(d->type)) {
    status = maggi_compile_link(c, "sensors", d->name, "body", d->body, &body);
    if (status == MAGGI_OK && has_point(d->type)) {
      point = c->pointbody.n;
      status = add_point(c, d, body);
    }
    add_numbers(c, d, &adr);
  } else if (d->type == MAGGI_SENSOR_COMBINATION) {
    element = c->termsensor.n;
    status = add_combination(c, d, columns, &adr, &need);
  } else {
    status = find_element(c, d, &element);
  }
  if (status != MAGGI_OK) return status;
  if (d->type == MAGGI_SENSOR_ROD) element = prim_of_rod(c, element);
  if (d->type == MAGGI_SENSOR_JOINT_SPRING && maggi_compile_is_angle(c, c->jspringq.v[element]))
    *columns = columns_of_angle;
  PUSH(sensorkind, d->type);
  PUSH(sensorbody, body);
  PUSH(sensorpoint, point);
  PUSH(sensorelement, element);
  PUSH(sensoradr, adr);
  PUSH(sensorterms, d->nterm);
  PUSH(sensorneed, need);
  return c->no_memory ? MAGGI_E_MEMORY : MAGGI_OK;
}

static maggi_status add_columns(maggi_model *m, const char *name, int sensor, const titles *columns)
{
  int k;

  for (k = 0; k < 3 && columns->name[k]; ++k, ++m->ncolumn) {
    m->sensorcolumn[m->ncolumn] = maggi_arena_format(&m->arena, "%s.%s", name, columns->name[k]);
    m->sensorunit[m->ncolumn] = columns->unit[k];
    m->sensorplace[m->ncolumn] = 3 * sensor + k;
    if (!m->sensorcolumn[m->ncolumn]) return MAGGI_E_MEMORY;
  }
  return MAGGI_OK;
}

maggi_status maggi_compile_sensors(maggi_compile *c)
{
  maggi_builder *b = c->b;
  maggi_model *m = c->m;
  maggi_status status;
  titles columns;
  size_t n = (size_t)b->nsensor * 3 + 1;
  int i;

  m->sensorcolumn = maggi_arena_alloc(&m->arena, n * sizeof *m->sensorcolumn);
  m->sensorunit = maggi_arena_alloc(&m->arena, n * sizeof *m->sensorunit);
  m->sensorplace = maggi_arena_alloc(&m->arena, n * sizeof *m->sensorplace);
  if (!m->sensorcolumn || !m->sensorunit || !m->sensorplace) return MAGGI_E_MEMORY;
  for (i = 0; i < b->nsensor; ++i) {
    status = add_sensor(c, &b->sensor[i], &columns);
    if (status == MAGGI_OK) status = add_columns(m, b->sensor[i].name, i, &columns);
    if (status != MAGGI_OK) return status;
  }
  c->t->nsensor = b->nsensor;
  c->t->nterm = c->termsensor.n;
  c->t->npoint = c->pointbody.n;
  return c->no_memory ? MAGGI_E_MEMORY : MAGGI_OK;
}
