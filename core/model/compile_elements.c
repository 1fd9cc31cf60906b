/* Functions of time, springs, loads, tyres and wheels. */
#include <math.h>
#include <string.h>

#include "compile.h"

/* entry of p for d->key, SECTION.NAME.key */
#define NUMBER(section, key, unit, bound)                                                          \
  maggi_parameter_add(c, d->key, unit, MAGGI_BOUND_##bound, #section ".%s." #key, d->name)

static const char *const sine_names[] = {"amplitude", "omega", "phase", "offset"};
static const char *const step_names[] = {"t0", "t1", "y0", "y1"};
static const char *const ramp_names[] = {"t0", "t1", "y0", "rate"};

static int add_function(maggi_compile *c, const maggi_function_def *d)
{
  int k, adr, is_ramp, first = -1;
  const char *unit;

  for (k = 0; d->times && k < d->number; ++k) {
    adr = maggi_parameter_add(c, d->times[k], "s", MAGGI_BOUND_NONE, "functions.%s.times.%d",
                              d->name, k + 1);
    first = k == 0 ? adr : first;
  }
  for (k = 0; k < d->number; ++k) {
    unit = "-";
    if (d->type == MAGGI_FUNCTION_CONSTANT) {
      adr = maggi_parameter_add(c, d->values[k], unit, MAGGI_BOUND_NONE, "functions.%s.value",
                                d->name);
    } else if (d->type == MAGGI_FUNCTION_SINE) {
      unit = k == 1 ? "rad/s" : k == 2 ? "rad" : "-";
      adr = maggi_parameter_add(c, d->values[k], unit, MAGGI_BOUND_NONE, "functions.%s.%s", d->name,
                                sine_names[k]);
    } else if (d->type == MAGGI_FUNCTION_STEP || d->type == MAGGI_FUNCTION_RAMP) {
      is_ramp = d->type == MAGGI_FUNCTION_RAMP;
      unit = k < 2 ? "s" : is_ramp && k == 3 ? "1/s" : "-";
      adr = maggi_parameter_add(c, d->values[k], unit, MAGGI_BOUND_NONE, "functions.%s.%s", d->name,
                                is_ramp ? ramp_names[k] : step_names[k]);
    } else if (d->type == MAGGI_FUNCTION_POLYNOMIAL) {
      adr = maggi_parameter_add(c, d->values[k], unit, MAGGI_BOUND_NONE,
                                "functions.%s.coefficients.%d", d->name, k);
    } else {
      adr = maggi_parameter_add(c, d->values[k], unit, MAGGI_BOUND_NONE, "functions.%s.values.%d",
                                d->name, k + 1);
    }
    first = first < 0 ? adr : first;
  }
  return first;
}

/* functions, and which coordinates they guide */
maggi_status maggi_compile_functions(maggi_compile *c)
{
  maggi_builder *b = c->b;
  maggi_status status;
  int i, k, id;

  for (i = 0; i < b->nfunction; ++i) {
    PUSH(funkind, b->function[i].type);
    PUSH(funadr, add_function(c, &b->function[i]));
    PUSH(funn, b->function[i].number);
    PUSH(funspline, c->t->nspline);
    PUSH(funheld, 0);
    if (b->function[i].type == MAGGI_FUNCTION_SPLINE) c->t->nspline += b->function[i].number;
  }
  c->t->nfun = b->nfunction;
  for (i = 0; i < c->t->nq; ++i) PUSH(qguide, -1);
  if (c->no_memory) return MAGGI_E_MEMORY;
  for (i = 0; i < b->nbody; ++i) {
    for (k = 0; k < maggi_joint_dof(b->body[i].joint); ++k) {
      if (!b->body[i].motion[k]) continue;
      status = maggi_compile_function(c, "bodies", b->body[i].name, b->body[i].motion[k], &id);
      if (status != MAGGI_OK) return status;
      c->qguide.v[c->m->coordinate[c->m->body[i].coordinate + k].q] = id;
      ++c->t->nguide;
    }
  }
  return MAGGI_OK;
}

static maggi_status add_spring(maggi_compile *c, const maggi_spring_def *d)
{
  static const char *const slope[] = {"c1", "c2", "c3", "c4", "v11", "v22"};
  maggi_status status;
  double values[6];
  int ba, bb, adr, k, preload = isnan(d->free_length);

  status = maggi_compile_link(c, "springs", d->name, "body_a", d->body_a, &ba);
  if (status == MAGGI_OK)
    status = maggi_compile_link(c, "springs", d->name, "body_b", d->body_b, &bb);
  if (status != MAGGI_OK) return status;
  if (ba == bb)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL,
                              "springs.%s: body_a and body_b are the same body", d->name);
  adr = NUMBER(springs, stiffness, "N/m", NONE);
  if (preload)
    NUMBER(springs, preload, "N", NONE);
  else
    NUMBER(springs, free_length, "m", NOT_NEGATIVE);
  NUMBER(springs, damping, "N s/m", NONE);
  if (d->has_slopes) {
    for (k = 0; k < 4; ++k) values[k] = d->c[k];
    values[4] = d->v11;
    values[5] = d->v22;
    for (k = 0; k < 6; ++k)
      maggi_parameter_add(c, values[k], k < 4 ? "N s/m" : "m/s",
                          k < 4    ? MAGGI_BOUND_NONE
                          : k == 4 ? MAGGI_BOUND_NOT_NEGATIVE
                                   : MAGGI_BOUND_NOT_POSITIVE,
                          "springs.%s.%s", d->name, slope[k]);
  }
  PUSH(springadr, adr);
  PUSH(springpreload, preload);
  PUSH(springslopes, d->has_slopes != 0);
  adr = maggi_parameter_add3(c, d->point_a, "m", "springs.%s.point_a", d->name);
  PUSH(springpa, maggi_compile_point(c, ba, adr));
  adr = maggi_parameter_add3(c, d->point_b, "m", "springs.%s.point_b", d->name);
  PUSH(springpb, maggi_compile_point(c, bb, adr));
  return MAGGI_OK;
}

static maggi_status add_joint_spring(maggi_compile *c, const maggi_joint_spring_def *d)
{
  static const char *const units[2][4] = {{"N/m", "N s/m", "m", "N"},
                                          {"N m/rad", "N m s/rad", "rad", "N m"}};
  maggi_status status;
  int q, q2 = -1, adr;
  const char *const *unit;

  status = maggi_compile_coordinate(c, "joint_springs", d->name, "coordinate", d->coordinate, &q);
  if (status == MAGGI_OK && d->coordinate2)
    status =
        maggi_compile_coordinate(c, "joint_springs", d->name, "coordinate2", d->coordinate2, &q2);
  if (status != MAGGI_OK) return status;
  if (q == q2)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL,
                              "joint_springs.%s: the two coordinates are the same", d->name);
  unit = units[maggi_compile_is_angle(c, q)];
  adr = NUMBER(joint_springs, stiffness, unit[0], NONE);
  NUMBER(joint_springs, damping, unit[1], NONE);
  NUMBER(joint_springs, rest, unit[2], NONE);
  NUMBER(joint_springs, preload, unit[3], NONE);
  PUSH(jspringq, q);
  PUSH(jspringq2, q2);
  PUSH(jspringadr, adr);
  return MAGGI_OK;
}

static maggi_status add_force(maggi_compile *c, const maggi_force_def *d)
{
  maggi_status status = MAGGI_OK;
  int body = -1, reaction = c->t->nbody, q = -1, fun = -1, point = -1, adr;
  int is_force =
      d->type == MAGGI_FORCE_GLOBAL || d->type == MAGGI_FORCE_BODY || d->type == MAGGI_FORCE_DRAG;

  if (d->type == MAGGI_FORCE_SPEED || d->type == MAGGI_FORCE_SPEED_LINEAR)
    return maggi_compile_speed(c, d);
  if (d->function) status = maggi_compile_function(c, "forces", d->name, d->function, &fun);
  if (status == MAGGI_OK && d->type == MAGGI_FORCE_JOINT)
    status = maggi_compile_coordinate(c, "forces", d->name, "coordinate", d->coordinate, &q);
  if (status == MAGGI_OK && d->type != MAGGI_FORCE_JOINT)
    status = maggi_compile_link(c, "forces", d->name, "body", d->body, &body);
  if (status == MAGGI_OK && d->type != MAGGI_FORCE_JOINT && d->reaction)
    status = maggi_compile_link(c, "forces", d->name, "reaction", d->reaction, &reaction);
  if (status != MAGGI_OK) return status;
  if (body == c->t->nbody)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL, "forces.%s: a load on the ground does nothing",
                              d->name);
  if (body == reaction)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL, "forces.%s: body and reaction are the same body",
                              d->name);
  if (d->type == MAGGI_FORCE_JOINT) {
    adr = maggi_parameter_add(c, d->value[0], maggi_compile_is_angle(c, q) ? "N m" : "N",
                              MAGGI_BOUND_NONE, "forces.%s.value", d->name);
  } else if (d->type == MAGGI_FORCE_DRAG) {
    adr = NUMBER(forces, density, "kg/m^3", NOT_NEGATIVE);
    NUMBER(forces, coefficient, "-", NOT_NEGATIVE);
    NUMBER(forces, area, "m^2", NOT_NEGATIVE);
    NUMBER(forces, low_speed, "m/s", POSITIVE);
    maggi_parameter_add3(c, d->wind, "m/s", "forces.%s.wind", d->name);
  } else {
    adr = maggi_parameter_add3(c, d->value, is_force ? "N" : "N m", "forces.%s.value", d->name);
  }
  PUSH(forceadr, adr);
  if (is_force) {
    adr = maggi_parameter_add3(c, d->point, "m", "forces.%s.point", d->name);
    point = maggi_compile_point(c, body, adr);
  }
  PUSH(forcekind, d->type);
  PUSH(forcebody, body);
  PUSH(forcereaction, reaction);
  PUSH(forcepoint, point);
  PUSH(forceq, q);
  PUSH(forcefun, fun);
  return MAGGI_OK;
}

static void add_tyre(maggi_compile *c, const maggi_tyre_def *d)
{
  PUSH(tyreadr, c->m->nparameter);
#define X(number, key, unit, initial, bound)                                                       \
  maggi_parameter_add(c, d->value[MAGGI_TYRE_##number], unit, MAGGI_BOUND_##bound,                 \
                      "tyres.%s." #key, d->name);
  MAGGI_TYRE_LIST(X)
#undef X
}

static void add_road(maggi_compile *c, const maggi_road_def *d)
{
  int adr = maggi_parameter_add3(c, d->point, "m", "roads.%s.point", d->name), k;

  PUSH(roadkind, d->type);
  PUSH(roadn, d->number);
  PUSH(roadspline, c->t->nspline);
  PUSH(roadpoint, maggi_compile_point(c, c->t->nbody, adr));
  if (d->type == MAGGI_ROAD_FLAT) {
    PUSH(roadadr, NUMBER(roads, slope, "-", NONE));
  } else if (d->type == MAGGI_ROAD_SINE) {
    PUSH(roadadr, NUMBER(roads, amplitude, "m", NONE));
    NUMBER(roads, wavelength, "m", POSITIVE);
  } else if (d->type == MAGGI_ROAD_BUMPS) {
    PUSH(roadadr, NUMBER(roads, radius, "m", POSITIVE));
    NUMBER(roads, height, "m", POSITIVE);
    NUMBER(roads, first, "m", NONE);
    NUMBER(roads, spacing, "m", NOT_NEGATIVE);
    NUMBER(roads, fillet, "m", NOT_NEGATIVE);
  } else {
    PUSH(roadadr, c->m->nparameter);
    for (k = 0; k < d->number; ++k)
      maggi_parameter_add(c, d->x[k], "m", MAGGI_BOUND_NONE, "roads.%s.x.%d", d->name, k + 1);
    for (k = 0; k < d->number; ++k)
      maggi_parameter_add(c, d->z[k], "m", MAGGI_BOUND_NONE, "roads.%s.z.%d", d->name, k + 1);
    c->t->nspline += d->number;
  }
}

static maggi_status find_named(maggi_compile *c, const char *wheel, const char *key,
                               const char *name, int found)
{
  if (!name) return maggi_builder_fail(c->b, MAGGI_E_MODEL, "wheels.%s: %s is missing", wheel, key);
  if (found < 0)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL, "wheels.%s: %s \"%s\" does not exist", wheel,
                              key, name);
  return MAGGI_OK;
}

static maggi_status add_wheel(maggi_compile *c, const maggi_wheel_def *d)
{
  maggi_builder *b = c->b;
  maggi_status status;
  int body, carrier, tyre = -1, road = -1, adr, i;

  status = maggi_compile_link(c, "wheels", d->name, "body", d->body, &body);
  if (status == MAGGI_OK)
    status = maggi_compile_link(c, "wheels", d->name, "carrier", d->carrier, &carrier);
  for (i = 0; i < b->ntyre && d->tyre; ++i)
    if (strcmp(b->tyre[i].name, d->tyre) == 0) tyre = i;
  for (i = 0; i < b->nroad && d->road; ++i)
    if (strcmp(b->road[i].name, d->road) == 0) road = i;
  if (status == MAGGI_OK) status = find_named(c, d->name, "tyre", d->tyre, tyre);
  if (status == MAGGI_OK) status = find_named(c, d->name, "road", d->road, road);
  if (status != MAGGI_OK) return status;
  if (body == c->t->nbody)
    return maggi_builder_fail(b, MAGGI_E_MODEL, "wheels.%s: body is the ground", d->name);
  if (body == carrier)
    return maggi_builder_fail(b, MAGGI_E_MODEL, "wheels.%s: body and carrier are the same body",
                              d->name);
  adr = maggi_parameter_add3(c, d->point, "m", "wheels.%s.point", d->name);
  PUSH(wheelpoint, maggi_compile_point(c, body, adr));
  PUSH(wheelaxis, maggi_parameter_add3(c, d->axis, "-", "wheels.%s.axis", d->name));
  PUSH(wheelbody, body);
  PUSH(wheelcarrier, carrier);
  PUSH(wheeltyre, tyre);
  PUSH(wheelmirror, d->side != b->tyre[tyre].side);
  PUSH(wheelgrip, 1);
  PUSH(wheelroad, road);
  return MAGGI_OK;
}

static maggi_status name_elements(maggi_compile *c)
{
  maggi_model *m = c->m;
  int i;

  m->springname = maggi_arena_alloc(&m->arena, ((size_t)c->b->nspring + 1) * sizeof(char *));
  m->wheelname = maggi_arena_alloc(&m->arena, ((size_t)c->b->nwheel + 1) * sizeof(char *));
  if (!m->springname || !m->wheelname) return MAGGI_E_MEMORY;
  for (i = 0; i < c->b->nspring; ++i) {
    m->springname[i] = maggi_arena_text(&m->arena, c->b->spring[i].name);
    if (!m->springname[i]) return MAGGI_E_MEMORY;
  }
  for (i = 0; i < c->b->nwheel; ++i) {
    m->wheelname[i] = maggi_arena_text(&m->arena, c->b->wheel[i].name);
    if (!m->wheelname[i]) return MAGGI_E_MEMORY;
  }
  return MAGGI_OK;
}

maggi_status maggi_compile_elements(maggi_compile *c)
{
  maggi_builder *b = c->b;
  maggi_topo *t = c->t;
  maggi_status status = name_elements(c);
  int i;

  for (i = 0; i < b->nspring && status == MAGGI_OK; ++i) status = add_spring(c, &b->spring[i]);
  for (i = 0; i < b->njoint_spring && status == MAGGI_OK; ++i)
    status = add_joint_spring(c, &b->joint_spring[i]);
  for (i = 0; i < b->nforce && status == MAGGI_OK; ++i) status = add_force(c, &b->force[i]);
  for (i = 0; i < b->ntyre; ++i) add_tyre(c, &b->tyre[i]);
  for (i = 0; i < b->nroad; ++i) add_road(c, &b->road[i]);
  for (i = 0; i < b->nwheel && status == MAGGI_OK; ++i) status = add_wheel(c, &b->wheel[i]);
  for (i = 0; i < b->ndriver && status == MAGGI_OK; ++i)
    status = maggi_compile_driver(c, &b->driver[i]);
  t->ntyre = b->ntyre;
  t->nroad = b->nroad;
  t->nwheel = b->nwheel;
  t->nspring = b->nspring;
  t->njspring = b->njoint_spring;
  t->nforce = c->forcekind.n;
  t->npoint = t->npointdyn = c->pointbody.n;
  return status;
}
