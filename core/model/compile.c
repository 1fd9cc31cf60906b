/* Compiles a builder into a model: topology, parameter vector, names. */
#include "compile.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void maggi_push(maggi_compile *c, maggi_list *list, int value)
{
  int cap, *v;

  if (list->n == list->cap) {
    cap = list->cap ? 2 * list->cap : 16;
    v = realloc(list->v, (size_t)cap * sizeof *v);
    if (!v) {
      c->no_memory = 1;
      return;
    }
    list->v = v;
    list->cap = cap;
  }
  list->v[list->n++] = value;
}

static int add(maggi_compile *c, double value, const char *unit, maggi_bound bound, char *path)
{
  maggi_model *m = c->m;
  maggi_parameter *bigger;
  int cap;

  if (m->nparameter == m->capparameter) {
    cap = m->capparameter ? 2 * m->capparameter : 64;
    bigger = realloc(m->parameter, (size_t)cap * sizeof *bigger);
    if (!bigger) {
      c->no_memory = 1;
      return 0;
    }
    m->parameter = bigger;
    m->capparameter = cap;
  }
  if (!path) {
    c->no_memory = 1;
    return 0;
  }
  m->parameter[m->nparameter].path = path;
  m->parameter[m->nparameter].unit = unit;
  m->parameter[m->nparameter].value = value;
  m->parameter[m->nparameter].bound = bound;
  m->parameter[m->nparameter].coordinate = -1;
  return m->nparameter++;
}

int maggi_parameter_add(maggi_compile *c, double value, const char *unit, maggi_bound bound,
                        const char *format, ...)
{
  char path[400];
  va_list args;

  va_start(args, format);
  vsnprintf(path, sizeof path, format, args);
  va_end(args);
  return add(c, value, unit, bound, maggi_arena_text(&c->m->arena, path));
}

int maggi_parameter_add3(maggi_compile *c, const double value[3], const char *unit,
                         const char *format, ...)
{
  static const char *const axis[] = {"x", "y", "z"};
  char path[400];
  va_list args;
  int k, adr[3];

  va_start(args, format);
  vsnprintf(path, sizeof path, format, args);
  va_end(args);
  for (k = 0; k < 3; ++k)
    adr[k] = add(c, value[k], unit, MAGGI_BOUND_NONE,
                 maggi_arena_format(&c->m->arena, "%s.%s", path, axis[k]));
  return adr[0];
}

int maggi_compile_body(const maggi_compile *c, const char *name)
{
  int i;

  if (!name || strcmp(name, MAGGI_GROUND) == 0) return -1;
  for (i = 0; i < c->b->nbody; ++i)
    if (strcmp(c->b->body[i].name, name) == 0) return i;
  return -2;
}

maggi_status maggi_compile_link(maggi_compile *c, const char *section, const char *name,
                                const char *key, const char *body, int *id)
{
  int i;

  if (!body)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL, "%s.%s: %s is missing", section, name, key);
  i = maggi_compile_body(c, body);
  if (i == -2)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL, "%s.%s: %s \"%s\" does not exist", section, name,
                              key, body);
  *id = i < 0 ? c->t->nbody : c->m->body[i].body;
  return MAGGI_OK;
}

maggi_status maggi_compile_coordinate(maggi_compile *c, const char *section, const char *name,
                                      const char *key, const char *coordinate, int *q)
{
  int i, k;

  if (!coordinate)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL, "%s.%s: %s is missing", section, name, key);
  for (i = 0; i < c->m->ncoordinate; ++i) {
    if (strcmp(c->m->coordinate[i].name, coordinate) == 0) {
      *q = c->m->coordinate[i].q;
      return MAGGI_OK;
    }
  }
  k = maggi_compile_body(c, coordinate);
  if (k >= 0)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL, "%s.%s: %s \"%s\" has a %s joint, %s", section,
                              name, key, coordinate, maggi_joint_type_name(c->b->body[k].joint),
                              c->b->body[k].joint == MAGGI_JOINT_FIXED
                                  ? "without a coordinate"
                                  : "name one of its coordinates .1, .2 ..");
  return maggi_builder_fail(c->b, MAGGI_E_MODEL, "%s.%s: %s \"%s\" does not exist", section, name,
                            key, coordinate);
}

maggi_status maggi_compile_function(maggi_compile *c, const char *section, const char *name,
                                    const char *function, int *id)
{
  int i;

  for (i = 0; i < c->b->nfunction; ++i) {
    if (strcmp(c->b->function[i].name, function) == 0) {
      *id = i;
      return MAGGI_OK;
    }
  }
  return maggi_builder_fail(c->b, MAGGI_E_MODEL, "%s.%s: function \"%s\" does not exist", section,
                            name, function);
}

int maggi_compile_is_angle(const maggi_compile *c, int q)
{
  return c->joint.v[c->qbody.v[q]] == MAGGI_ONE_REVOLUTE;
}

int maggi_least_axis(const double a[3])
{
  double x = a[0] * a[0], y = a[1] * a[1], z = a[2] * a[2];

  return x <= y && x <= z ? 0 : y <= z ? 1 : 2;
}

/* points are shared when body and address agree */
int maggi_compile_point(maggi_compile *c, int body, int adr)
{
  int i;

  for (i = 0; i < c->pointbody.n; ++i)
    if (c->pointbody.v[i] == body && c->pointadr.v[i] == adr) return i;
  PUSH(pointbody, body);
  PUSH(pointadr, adr);
  PUSH(pointadr2, -1);
  return c->pointbody.n - 1;
}

/* Shell sort of the parameter indices by path */
static void sort_paths(const maggi_model *m, int *index)
{
  int gap, i, k, x;

  for (i = 0; i < m->nparameter; ++i) index[i] = i;
  for (gap = m->nparameter / 2; gap > 0; gap /= 2) {
    for (i = gap; i < m->nparameter; ++i) {
      x = index[i];
      for (k = i; k >= gap && strcmp(m->parameter[index[k - gap]].path, m->parameter[x].path) > 0;
           k -= gap)
        index[k] = index[k - gap];
      index[k] = x;
    }
  }
}

/* what check.c has left to the bounds */
static maggi_status check_parameters(const maggi_compile *c)
{
  const maggi_parameter *p = c->m->parameter;
  const char *wrong;
  int i;

  for (i = 0; i < c->m->nparameter; ++i) {
    wrong = maggi_parameter_wrong(&p[i], p[i].value);
    if (wrong)
      return maggi_builder_fail(c->b, MAGGI_E_MODEL, "%s %s (%g)", p[i].path, wrong, p[i].value);
  }
  return MAGGI_OK;
}

static maggi_status compile(maggi_compile *c)
{
  maggi_status status;
  maggi_model *m = c->m;

  m->name = maggi_arena_text(&m->arena, c->b->name);
  m->source = maggi_arena_text(&m->arena, c->b->source);
  m->simulation = c->b->simulation;
  if (!m->name || !m->source) return MAGGI_E_MEMORY;
  if (c->b->nbody == 0)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL, "bodies: a model needs at least one body");
  maggi_parameter_add3(c, c->b->gravity, "m/s^2", "gravity");

  status = maggi_compile_tree(c);
  if (status == MAGGI_OK) status = maggi_compile_functions(c);
  if (status == MAGGI_OK) status = maggi_compile_loops(c);
  if (status == MAGGI_OK) status = maggi_compile_elements(c);
  if (status == MAGGI_OK) status = maggi_compile_sensors(c);
  if (status == MAGGI_OK) status = maggi_compile_filters(c);
  if (status == MAGGI_OK) status = maggi_compile_signals(c->m);
  if (status != MAGGI_OK) return status;

  c->t->np = m->nparameter;
  m->pathindex = maggi_arena_alloc(&m->arena, (size_t)m->nparameter * sizeof *m->pathindex);
  if (!m->pathindex) return MAGGI_E_MEMORY;
  sort_paths(m, m->pathindex);
  if (c->no_memory) return MAGGI_E_MEMORY;
  status = maggi_compile_definitions(c);
  if (status == MAGGI_OK) status = maggi_compile_parts(c);
  if (status == MAGGI_OK) status = maggi_compile_settings(c);
  return status == MAGGI_OK ? check_parameters(c) : status;
}

maggi_status maggi_model_create(maggi_builder *b, maggi_model **model)
{
  maggi_compile compile_state = {0}, *c = &compile_state;
  maggi_status status;

  *model = NULL;
  b->message[0] = '\0';
  c->b = b;
  c->m = calloc(1, sizeof *c->m);
  if (!c->m) return maggi_builder_fail(b, MAGGI_E_MEMORY, "out of memory");
  c->t = &c->m->topo;
  status = compile(c);
#define X(name, size, text) c->t->name = c->name.v;
  MAGGI_TOPO_LIST(X)
#undef X
  if (status == MAGGI_OK && c->no_memory) status = MAGGI_E_MEMORY;
  if (status == MAGGI_OK) status = maggi_compile_start(c);
  if (status != MAGGI_OK) {
    if (status == MAGGI_E_MEMORY) maggi_builder_fail(b, status, "out of memory");
    maggi_model_free(c->m);
    return status;
  }
  *model = c->m;
  return MAGGI_OK;
}

void maggi_model_free(maggi_model *model)
{
  if (!model) return;
#define X(name, size, text) free(model->topo.name);
  MAGGI_TOPO_LIST(X)
#undef X
  maggi_twin_free(model->twin);
  free(model->parameter);
  maggi_arena_free(&model->arena);
  free(model);
}
