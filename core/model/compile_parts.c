/* Parts of a model that are asked for by what they are: sensors, wheels, forces, roads,
 * functions. */
#include "compile.h"
#include "definition.h"

/* a copy of a text that may be missing: false without memory */
static int own(maggi_compile *c, const char **text)
{
  if (!*text) return 1;
  *text = maggi_arena_text(&c->m->arena, *text);
  return *text != NULL;
}

static void *room(maggi_compile *c, int n, size_t size)
{
  return maggi_arena_alloc(&c->m->arena, ((size_t)n + 1) * size);
}

static int own_sensor(maggi_compile *c, const maggi_sensor_def *from, maggi_sensor_def *to)
{
  *to = *from;
  return own(c, &to->name) && own(c, &to->body) && own(c, &to->element) &&
         maggi_sensor_own(&c->m->arena, to);
}

static int own_wheel(maggi_compile *c, const maggi_wheel_def *from, maggi_wheel_def *to)
{
  int k;

  maggi_wheel_def_init(to);
  to->name = from->name;
  to->body = from->body;
  to->carrier = from->carrier;
  to->tyre = from->tyre;
  to->road = from->road;
  to->side = from->side;
  for (k = 0; k < 3; ++k) to->point[k] = from->point[k];
  for (k = 0; k < 3; ++k) to->axis[k] = from->axis[k];
  return own(c, &to->name) && own(c, &to->body) && own(c, &to->carrier) && own(c, &to->tyre) &&
         own(c, &to->road);
}

static int own_force(maggi_compile *c, const maggi_force_def *from, maggi_force_def *to)
{
  maggi_force_def_init(to);
  to->name = from->name;
  to->type = from->type;
  to->body = from->body;
  to->reaction = from->reaction;
  to->coordinate = from->coordinate;
  to->function = from->function;
  return own(c, &to->name) && own(c, &to->body) && own(c, &to->reaction) &&
         own(c, &to->coordinate) && own(c, &to->function);
}

maggi_status maggi_compile_parts(maggi_compile *c)
{
  const maggi_builder *b = c->b;
  maggi_model *m = c->m;
  int i, owned = 1;

  m->sensor = room(c, b->nsensor, sizeof *m->sensor);
  m->wheel = room(c, b->nwheel, sizeof *m->wheel);
  m->road = room(c, b->nroad, sizeof *m->road);
  m->function = room(c, b->nfunction, sizeof *m->function);
  m->force = room(c, b->nforce, sizeof *m->force);
  if (!m->force || !m->sensor || !m->wheel || !m->road || !m->function) return MAGGI_E_MEMORY;
  for (i = 0; i < b->nsensor && owned; ++i) owned = own_sensor(c, &b->sensor[i], &m->sensor[i]);
  for (i = 0; i < b->nwheel && owned; ++i) owned = own_wheel(c, &b->wheel[i], &m->wheel[i]);
  for (i = 0; i < b->nforce && owned; ++i) owned = own_force(c, &b->force[i], &m->force[i]);
  for (i = 0; i < b->nroad && owned; ++i) {
    m->road[i].type = maggi_road_type_name(b->road[i].type);
    m->road[i].name = b->road[i].name;
    owned = own(c, &m->road[i].name);
  }
  for (i = 0; i < b->nfunction && owned; ++i) {
    m->function[i].type = maggi_function_type_name(b->function[i].type);
    m->function[i].name = b->function[i].name;
    owned = own(c, &m->function[i].name);
  }
  m->nwheel = b->nwheel;
  m->nforce = b->nforce;
  m->nroad = b->nroad;
  m->nfunction = b->nfunction;
  return owned ? MAGGI_OK : MAGGI_E_MEMORY;
}
