/* Controllers of speed. */
#include "compile.h"

/* entry of p for d->key, forces.NAME.key */
#define NUMBER(key, unit, bound)                                                                   \
  maggi_parameter_add(c, d->key, unit, MAGGI_BOUND_##bound, "forces.%s." #key, d->name)

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

maggi_status maggi_compile_speed(maggi_compile *c, const maggi_force_def *d)
{
  maggi_status status;
  int linear = d->type == MAGGI_FORCE_SPEED_LINEAR, body, fun = -1, is_angle = 1, adr;

  status = maggi_compile_link(c, "forces", d->name, "body", d->body, &body);
  if (status == MAGGI_OK && d->function)
    status = maggi_compile_function(c, "forces", d->name, d->function, &fun);
  if (status == MAGGI_OK) status = add_coordinates(c, d, &is_angle);
  if (status != MAGGI_OK) return status;
  if (body == c->t->nbody) return maggi_fail_at(c->b, "forces", d->name, "the ground has no speed");
  adr = NUMBER(speed, "m/s", NONE);
  NUMBER(gain, linear ? "s/m" : "s^2/m^2", NONE);
  NUMBER(torque, is_angle ? "N m" : "N", NONE);
  NUMBER(low_speed, "m/s", POSITIVE);
  PUSH(speedadr, adr);
  adr = maggi_parameter_add3(c, d->point, "m", "forces.%s.point", d->name);
  PUSH(speedpoint, maggi_compile_point(c, body, adr));
  PUSH(speedlinear, linear);
  PUSH(speedfun, fun);
  PUSH(speedheld, 0);
  ++c->t->nspeed;
  c->t->nspeedq = c->speedq.n;
  return MAGGI_OK;
}
