/* Sensors: what each looks at, and its columns. */
#include <string.h>

#include "compile.h"

typedef struct titles {
  const char *name[3], *unit[3];
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
    [MAGGI_SENSOR_TYRE_CONTACT] = {{"deflection", "loaded_radius", "rolling_radius"},
                                   {"m", "m", "m"}},
    [MAGGI_SENSOR_TYRE_SLOPE] = {{"dfy_dalpha", "dfx_dkappa", "utilisation"}, {"N/rad", "N", "-"}}};

static const titles columns_of_angle = {{"value", "rate", "torque"}, {"rad", "rad/s", "N m"}};

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

static maggi_status add_sensor(maggi_compile *c, const maggi_sensor_def *d, const titles **columns)
{
  maggi_status status;
  int body = c->t->nbody, point = -1, element = -1;

  *columns = &columns_of[d->type];
  if (d->type < MAGGI_SENSOR_SPRING) {
    status = maggi_compile_link(c, "sensors", d->name, "body", d->body, &body);
    if (status == MAGGI_OK && d->type <= MAGGI_SENSOR_ACCELERATION) {
      point = c->pointbody.n;
      status = add_point(c, d, body);
    }
  } else {
    status = find_element(c, d, &element);
  }
  if (status != MAGGI_OK) return status;
  if (d->type == MAGGI_SENSOR_ROD) element = prim_of_rod(c, element);
  if (d->type == MAGGI_SENSOR_JOINT_SPRING && maggi_compile_is_angle(c, c->jspringq.v[element]))
    *columns = &columns_of_angle;
  PUSH(sensorkind, d->type);
  PUSH(sensorbody, body);
  PUSH(sensorpoint, point);
  PUSH(sensorelement, element);
  return MAGGI_OK;
}

maggi_status maggi_compile_sensors(maggi_compile *c)
{
  maggi_builder *b = c->b;
  maggi_model *m = c->m;
  maggi_status status;
  const titles *columns;
  size_t n = (size_t)b->nsensor * 3 + 1;
  int i, k;

  m->sensorcolumn = maggi_arena_alloc(&m->arena, n * sizeof *m->sensorcolumn);
  m->sensorunit = maggi_arena_alloc(&m->arena, n * sizeof *m->sensorunit);
  if (!m->sensorcolumn || !m->sensorunit) return MAGGI_E_MEMORY;
  for (i = 0; i < b->nsensor; ++i) {
    status = add_sensor(c, &b->sensor[i], &columns);
    if (status != MAGGI_OK) return status;
    for (k = 0; k < 3; ++k) {
      m->sensorcolumn[3 * i + k] =
          maggi_arena_format(&m->arena, "%s.%s", b->sensor[i].name, columns->name[k]);
      m->sensorunit[3 * i + k] = columns->unit[k];
      if (!m->sensorcolumn[3 * i + k]) return MAGGI_E_MEMORY;
    }
  }
  c->t->nsensor = b->nsensor;
  c->t->npoint = c->pointbody.n;
  return c->no_memory ? MAGGI_E_MEMORY : MAGGI_OK;
}
