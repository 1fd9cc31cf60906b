/* A description becomes a model, its parts in any order. */
#include <math.h>
#include <stdio.h>

#include "mechanism.h"

static const char *body_name(int body, char name[MECH_NAME])
{
  if (body == MECH_GROUND)
    return MAGGI_GROUND;
  snprintf(name, MECH_NAME, "b%d", body);
  return name;
}

static const char *coordinate_name(const mechanism *m, int q, char name[MECH_NAME])
{
  int i = mech_body_of(m, q);

  if (m->body[i].dof > 1)
    snprintf(name, MECH_NAME, "b%d.%d", i, q - m->body[i].q + 1);
  else
    snprintf(name, MECH_NAME, "b%d", i);
  return name;
}

static void shuffled(mech_random *g, int n, int *order)
{
  int i, k, swap;

  for (i = 0; i < n; ++i)
    order[i] = i;
  for (i = n - 1; g && i > 0; --i) {
    k = mech_integer(g, i + 1);
    swap = order[i];
    order[i] = order[k];
    order[k] = swap;
  }
}

static maggi_status add_body(maggi_builder *b, const mechanism *m, int i)
{
  maggi_body_def d = m->body[i].def;
  char name[MECH_NAME], parent[MECH_NAME], motion[MAGGI_JOINT_DOF_MAX][MECH_NAME];
  int k;

  d.name = body_name(i, name);
  d.parent = body_name(m->body[i].parent, parent);
  for (k = 0; k < m->body[i].dof; ++k) {
    if (m->body[i].motion[k] >= 0) {
      snprintf(motion[k], MECH_NAME, "f%d", m->body[i].motion[k]);
      d.motion[k] = motion[k];
    }
  }
  return maggi_builder_body(b, &d);
}

static maggi_status add_loop(maggi_builder *b, const mechanism *m, int i)
{
  maggi_loop_def d = m->loop[i].def;
  char name[MECH_NAME], na[MECH_NAME], nb[MECH_NAME];

  snprintf(name, sizeof name, "l%d", i);
  d.name = name;
  d.body_a = body_name(m->loop[i].a, na);
  d.body_b = body_name(m->loop[i].b, nb);
  return maggi_builder_loop(b, &d);
}

static maggi_status add_rod(maggi_builder *b, const mechanism *m, int i)
{
  maggi_rod_def d = m->rod[i].def;
  char name[MECH_NAME], na[MECH_NAME], nb[MECH_NAME];

  snprintf(name, sizeof name, "r%d", i);
  d.name = name;
  d.body_a = body_name(m->rod[i].a, na);
  d.body_b = body_name(m->rod[i].b, nb);
  return maggi_builder_rod(b, &d);
}

static maggi_status add_point_mass(maggi_builder *b, const mechanism *m, int i)
{
  maggi_point_mass_def d = m->point_mass[i].def;
  char name[MECH_NAME], body[MECH_NAME];

  snprintf(name, sizeof name, "m%d", i);
  d.name = name;
  d.body = body_name(m->point_mass[i].body, body);
  return maggi_builder_point_mass(b, &d);
}

static maggi_status add_spring(maggi_builder *b, const mechanism *m, int i)
{
  maggi_spring_def d = m->spring[i].def;
  char name[MECH_NAME], na[MECH_NAME], nb[MECH_NAME];

  snprintf(name, sizeof name, "s%d", i);
  d.name = name;
  d.body_a = body_name(m->spring[i].a, na);
  d.body_b = body_name(m->spring[i].b, nb);
  return maggi_builder_spring(b, &d);
}

static maggi_status add_joint_spring(maggi_builder *b, const mechanism *m, int i)
{
  maggi_joint_spring_def d = m->joint_spring[i].def;
  char name[MECH_NAME], q[MECH_NAME], q2[MECH_NAME];

  snprintf(name, sizeof name, "t%d", i);
  d.name = name;
  d.coordinate = coordinate_name(m, m->joint_spring[i].q, q);
  d.coordinate2 = m->joint_spring[i].q2 < 0 ? NULL : coordinate_name(m, m->joint_spring[i].q2, q2);
  return maggi_builder_joint_spring(b, &d);
}

static maggi_status add_force(maggi_builder *b, const mechanism *m, int i)
{
  const mech_force *f = &m->force[i];
  maggi_force_def d = f->def;
  char name[MECH_NAME], body[MECH_NAME], reaction[MECH_NAME], q[MECH_NAME], fun[MECH_NAME];
  char q2[MECH_NAME];
  const char *both[2];

  snprintf(name, sizeof name, "p%d", i);
  d.name = name;
  if (d.type >= MAGGI_FORCE_SPEED) {
    d.body = body_name(f->body, body);
    both[0] = coordinate_name(m, f->q, q);
    both[1] = f->q2 < 0 ? NULL : coordinate_name(m, f->q2, q2);
    d.ncoordinate = f->q2 < 0 ? 1 : 2;
    d.coordinates = both;
  } else if (d.type == MAGGI_FORCE_JOINT) {
    d.coordinate = coordinate_name(m, f->q, q);
  } else {
    d.body = body_name(f->body, body);
    d.reaction = f->reaction == MECH_GROUND ? NULL : body_name(f->reaction, reaction);
  }
  if (f->function >= 0) {
    snprintf(fun, sizeof fun, "f%d", f->function);
    d.function = fun;
  }
  return maggi_builder_force(b, &d);
}

static maggi_status add_function(maggi_builder *b, const mechanism *m, int i)
{
  maggi_function_def d = m->function[i].def;
  char name[MECH_NAME];

  snprintf(name, sizeof name, "f%d", i);
  d.name = name;
  d.values = m->function[i].values;
  if (d.type == MAGGI_FUNCTION_KNOTS || d.type == MAGGI_FUNCTION_SPLINE)
    d.times = m->function[i].times;
  return maggi_builder_function(b, &d);
}

static maggi_status add_sensor(maggi_builder *b, const mechanism *m, int i)
{
  maggi_sensor_def d = m->sensor[i].def;
  char name[MECH_NAME], body[MECH_NAME], element[MECH_NAME];
  char letter = d.type == MAGGI_SENSOR_SPRING ? 's' : d.type == MAGGI_SENSOR_ROD ? 'r' : 't';

  snprintf(name, sizeof name, "x%d", i);
  snprintf(element, sizeof element, "%c%d", letter, m->sensor[i].element);
  d.name = name;
  d.body = body_name(m->sensor[i].body, body);
  d.element = element;
  return maggi_builder_sensor(b, &d);
}

/* of every third seed: two with numbers of their own, on any sensors */
static maggi_status add_filters(maggi_builder *b, const mechanism *m)
{
  static const char *const column[MAGGI_SENSOR_TYPE_COUNT] = {
      [MAGGI_SENSOR_POSITION] = "y",
      [MAGGI_SENSOR_VELOCITY] = "z",
      [MAGGI_SENSOR_ACCELERATION] = "z",
      [MAGGI_SENSOR_ANGLES] = "pitch",
      [MAGGI_SENSOR_ANGLE_RATES] = "pitch_rate",
      [MAGGI_SENSOR_ANGULAR_VELOCITY] = "x",
      [MAGGI_SENSOR_ANGULAR_ACCELERATION] = "y",
      [MAGGI_SENSOR_SPRING] = "force",
      [MAGGI_SENSOR_JOINT_SPRING] = "torque",
      [MAGGI_SENSOR_ROD] = "force"};
  mech_random g = {m->seed * 31u + 7u};
  maggi_status status = MAGGI_OK;
  maggi_filter_def d;
  char name[MECH_NAME], signal[2 * MECH_NAME];
  int i, sensor;

  for (i = 0; i < 2 && m->seed % 3 == 0 && status == MAGGI_OK; ++i) {
    sensor = mech_integer(&g, m->nsensor);
    snprintf(name, sizeof name, "y%d", i);
    snprintf(signal, sizeof signal, "x%d.%s", sensor, column[m->sensor[sensor].def.type]);
    maggi_filter_def_init(&d);
    d.name = name;
    d.signal = signal;
    d.f1 = mech_uniform(&g, 0.3, 1.0);
    d.f2 = mech_uniform(&g, 5.0, 15.0);
    if (mech_integer(&g, 3) > 0) d.f4 = mech_uniform(&g, 1.0, 6.0);
    if (isfinite(d.f4) && mech_integer(&g, 2) > 0) d.f3 = mech_uniform(&g, 1.0, 6.0);
    if (mech_integer(&g, 3) > 0) {
      d.f5 = mech_uniform(&g, 1.0, 3.0);
      d.f6 = mech_uniform(&g, 2.0, 5.0);
    }
    d.q4 = mech_uniform(&g, 0.5, 1.0);
    d.q5 = mech_uniform(&g, 0.5, 1.0);
    d.q6 = mech_uniform(&g, 0.5, 1.0);
    d.gain = mech_uniform(&g, 0.5, 2.0);
    status = maggi_builder_filter(b, &d);
  }
  return status;
}

typedef maggi_status add_part(maggi_builder *b, const mechanism *m, int i);

static maggi_status add_all(maggi_builder *b, const mechanism *m, mech_random *shuffle, int n,
                            add_part *add)
{
  int order[MECH_LOOPS > MECH_BODIES ? MECH_LOOPS : MECH_BODIES], i;
  maggi_status status = MAGGI_OK;

  shuffled(shuffle, n, order);
  for (i = 0; i < n && status == MAGGI_OK; ++i)
    status = add(b, m, order[i]);
  return status;
}

maggi_status mech_build(const mechanism *m, mech_random *shuffle, maggi_model **model,
                        char *message, size_t nmessage)
{
  maggi_builder *b;
  maggi_status status = maggi_builder_create("random", &b);

  *model = NULL;
  message[0] = '\0';
  if (status != MAGGI_OK)
    return status;
  status = maggi_builder_gravity(b, m->gravity);
  if (status == MAGGI_OK)
    status = add_all(b, m, shuffle, m->nbody, add_body);
  if (status == MAGGI_OK)
    status = add_all(b, m, shuffle, m->nloop, add_loop);
  if (status == MAGGI_OK)
    status = add_all(b, m, shuffle, m->nrod, add_rod);
  if (status == MAGGI_OK)
    status = add_all(b, m, shuffle, m->npoint_mass, add_point_mass);
  if (status == MAGGI_OK)
    status = add_all(b, m, shuffle, m->nspring, add_spring);
  if (status == MAGGI_OK)
    status = add_all(b, m, shuffle, m->njoint_spring, add_joint_spring);
  if (status == MAGGI_OK)
    status = add_all(b, m, shuffle, m->nforce, add_force);
  if (status == MAGGI_OK)
    status = add_all(b, m, shuffle, m->nfunction, add_function);
  if (status == MAGGI_OK)
    status = add_all(b, m, NULL, m->nsensor, add_sensor);
  if (status == MAGGI_OK)
    status = add_filters(b, m);
  if (status == MAGGI_OK)
    status = maggi_model_create(b, model);
  if (status != MAGGI_OK)
    snprintf(message, nmessage, "%s", maggi_builder_message(b));
  maggi_builder_free(b);
  return status;
}

int mech_coordinate_map(const mechanism *m, const maggi_model *model, int map[MECH_COORDINATES])
{
  char name[MECH_NAME];
  int i, ok = 1;

  for (i = 0; i < m->nq; ++i) {
    map[i] = maggi_coordinate_find(model, coordinate_name(m, i, name));
    ok = ok && map[i] >= 0;
  }
  return ok;
}

int mech_body_map(const mechanism *m, const maggi_model *model, int map[MECH_BODIES])
{
  char name[MECH_NAME];
  int i, ok = 1;

  for (i = 0; i < m->nbody; ++i) {
    map[i] = maggi_body_find(model, body_name(i, name));
    ok = ok && map[i] >= 0;
  }
  return ok;
}
