/* Drivers and controllers of speed. */
#include <string.h>

#include "compile.h"

/* entry of p for d->key, SECTION.NAME.key */
#define NUMBER(section, key, unit, bound)                                                          \
  maggi_parameter_add(c, d->key, unit, MAGGI_BOUND_##bound, #section ".%s." #key, d->name)

/* appends to speedq */
static maggi_status add_coordinates(maggi_compile *c, const maggi_force_def *d, int *is_angle)
{
  maggi_status status;
  int first = c->speedq.n, i, k, q;

  for (i = 0; i < d->ncoordinate; ++i) {
    status = maggi_compile_coordinate(c, "forces", d->name, "coordinates:", d->coordinates[i], &q);
    if (status != MAGGI_OK) return status;
    if (i == 0) *is_angle = maggi_compile_is_angle(c, q);
    if (maggi_compile_is_angle(c, q) != *is_angle)
      return maggi_fail_at(c->b, "forces", d->name,
                           "coordinates: \"%s\" is an angle and \"%s\" a length, or conversely",
                           d->coordinates[0], d->coordinates[i]);
    for (k = first; k < c->speedq.n; ++k)
      if (c->speedq.v[k] == q)
        return maggi_fail_at(c->b, "forces", d->name, "coordinates: \"%s\" is there twice",
                             d->coordinates[i]);
    PUSH(speedq, q);
    if (c->no_memory) return MAGGI_E_MEMORY;
  }
  PUSH(speedqadr, first);
  PUSH(speedqnum, d->ncoordinate);
  return MAGGI_OK;
}

static maggi_status find_driver(maggi_compile *c, const maggi_force_def *d, int *driver)
{
  int i;

  for (i = 0; d->driver && i < c->b->ndriver; ++i)
    if (strcmp(c->b->driver[i].name, d->driver) == 0) *driver = i;
  if (d->driver && *driver < 0)
    return maggi_fail_at(c->b, "forces", d->name, "driver \"%s\" does not exist", d->driver);
  if (d->driver && !c->b->driver[*driver].speeds)
    return maggi_fail_at(c->b, "forces", d->name, "driver \"%s\" has no speeds", d->driver);
  return MAGGI_OK;
}

maggi_status maggi_compile_speed(maggi_compile *c, const maggi_force_def *d)
{
  maggi_status status;
  int linear = d->type == MAGGI_FORCE_SPEED_LINEAR, body, fun = -1, driver = -1;
  int is_angle = 1, adr;

  status = maggi_compile_link(c, "forces", d->name, "body", d->body, &body);
  if (status == MAGGI_OK && d->function)
    status = maggi_compile_function(c, "forces", d->name, d->function, &fun);
  if (status == MAGGI_OK) status = find_driver(c, d, &driver);
  if (status == MAGGI_OK) status = add_coordinates(c, d, &is_angle);
  if (status != MAGGI_OK) return status;
  if (body == c->t->nbody) return maggi_fail_at(c->b, "forces", d->name, "the ground has no speed");
  adr = NUMBER(forces, speed, "m/s", NONE);
  NUMBER(forces, gain, linear ? "s/m" : "s^2/m^2", NONE);
  NUMBER(forces, torque, is_angle ? "N m" : "N", NONE);
  NUMBER(forces, low_speed, "m/s", POSITIVE);
  PUSH(speedadr, adr);
  adr = maggi_parameter_add3(c, d->point, "m", "forces.%s.point", d->name);
  PUSH(speedpoint, maggi_compile_point(c, body, adr));
  PUSH(speedlinear, linear);
  PUSH(speedfun, fun);
  PUSH(speedheld, 0);
  PUSH(speeddriver, driver);
  ++c->t->nspeed;
  c->t->nspeedq = c->speedq.n;
  return MAGGI_OK;
}

/* address of the first of a list of numbers drivers.NAME.key.1, .2 .. */
static int add_list(maggi_compile *c, const maggi_driver_def *d, const char *key, const char *unit,
                    const double *x)
{
  int k, first = c->m->nparameter;

  for (k = 0; k < d->number; ++k)
    maggi_parameter_add(c, x[k], unit, MAGGI_BOUND_NONE, "drivers.%s.%s.%d", d->name, key, k + 1);
  return first;
}

maggi_status maggi_compile_driver(maggi_compile *c, const maggi_driver_def *d)
{
  maggi_status status;
  int body, q, adr;

  status = maggi_compile_link(c, "drivers", d->name, "body", d->body, &body);
  if (status == MAGGI_OK)
    status = maggi_compile_coordinate(c, "drivers", d->name, "coordinate", d->coordinate, &q);
  if (status != MAGGI_OK) return status;
  if (body == c->t->nbody) return maggi_fail_at(c->b, "drivers", d->name, "body is the ground");
  adr = NUMBER(drivers, preview, "s", NOT_NEGATIVE);
  NUMBER(drivers, gain, "rad/m", NONE);
  NUMBER(drivers, feedforward, "rad m", NONE);
  NUMBER(drivers, limit, "rad", POSITIVE);
  NUMBER(drivers, stiffness, "N m/rad", NONE);
  NUMBER(drivers, damping, "N m s/rad", NONE);
  PUSH(driveradr, adr);
  adr = maggi_parameter_add3(c, d->point, "m", "drivers.%s.point", d->name);
  PUSH(driverpoint, maggi_compile_point(c, body, adr));
  adr = maggi_parameter_add3(c, d->origin, "m", "drivers.%s.origin", d->name);
  PUSH(driverorigin, maggi_compile_point(c, c->t->nbody, adr));
  PUSH(driverpath, add_list(c, d, "x", "m", d->x));
  add_list(c, d, "y", "m", d->y);
  if (d->speeds) add_list(c, d, "speeds", "m/s", d->speeds);
  PUSH(driverq, q);
  PUSH(driverspeeds, d->speeds != NULL);
  PUSH(drivern, d->number);
  PUSH(driverrow, c->t->npath0);
  PUSH(driverheld, 0);
  c->t->npath0 += d->number;
  ++c->t->ndriver;
  return MAGGI_OK;
}
