/* Collects the parts of a model and checks each for itself. */
#include "builder.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "definition.h"

maggi_status maggi_builder_fail(maggi_builder *b, maggi_status status, const char *format, ...)
{
  va_list args;

  va_start(args, format);
  vsnprintf(b->message, sizeof b->message, format, args);
  va_end(args);
  return status;
}

static maggi_status no_memory(maggi_builder *b)
{
  return maggi_builder_fail(b, MAGGI_E_MEMORY, "out of memory");
}

maggi_status maggi_builder_create(const char *name, maggi_builder **builder)
{
  maggi_builder *b;

  *builder = NULL;
  b = calloc(1, sizeof *b);
  if (!b) return MAGGI_E_MEMORY;
  b->name = maggi_arena_text(&b->arena, name ? name : "");
  b->source = maggi_arena_text(&b->arena, "");
  b->gravity[2] = -9.81;
  if (!b->name || !b->source) {
    maggi_builder_free(b);
    return MAGGI_E_MEMORY;
  }
  *builder = b;
  return MAGGI_OK;
}

void maggi_builder_free(maggi_builder *builder)
{
  if (!builder) return;
#define X(kind, section) free(builder->kind);
  MAGGI_BUILDER_LIST(X)
#undef X
  free(builder->setting);
  maggi_arena_free(&builder->arena);
  free(builder);
}

const char *maggi_builder_message(const maggi_builder *builder)
{
  return builder->message;
}

/* ------------------------------------------------------------------------------------- copies */

/* replaces a string by a copy that the builder owns; 0 from the function when out of memory */
#define OWN(field)                                                                                 \
  do {                                                                                             \
    if (d->field) {                                                                                \
      d->field = maggi_arena_text(&b->arena, d->field);                                            \
      if (!d->field) return 0;                                                                     \
    }                                                                                              \
  } while (0)

static int own_body(maggi_builder *b, maggi_body_def *d)
{
  int i;

  OWN(parent);
  for (i = 0; i < MAGGI_JOINT_DOF_MAX; ++i) OWN(motion[i]);
  return 1;
}

static int own_point_mass(maggi_builder *b, maggi_point_mass_def *d)
{
  OWN(body);
  return 1;
}

static int own_loop(maggi_builder *b, maggi_loop_def *d)
{
  OWN(body_a);
  OWN(body_b);
  return 1;
}

static int own_rod(maggi_builder *b, maggi_rod_def *d)
{
  OWN(body_a);
  OWN(body_b);
  return 1;
}

static int own_spring(maggi_builder *b, maggi_spring_def *d)
{
  OWN(body_a);
  OWN(body_b);
  return 1;
}

static int own_joint_spring(maggi_builder *b, maggi_joint_spring_def *d)
{
  OWN(coordinate);
  OWN(coordinate2);
  return 1;
}

static int own_force(maggi_builder *b, maggi_force_def *d)
{
  OWN(body);
  OWN(reaction);
  OWN(coordinate);
  OWN(function);
  OWN(driver);
  if (d->ncoordinate > 0)
    d->coordinates = maggi_arena_texts(&b->arena, d->coordinates, d->ncoordinate);
  return d->ncoordinate <= 0 || d->coordinates;
}

static int own_tyre(maggi_builder *b, maggi_tyre_def *d)
{
  (void)b;
  (void)d;
  return 1;
}

static int own_road(maggi_builder *b, maggi_road_def *d)
{
  if (d->type != MAGGI_ROAD_PROFILE) {
    d->x = d->z = NULL;
    return 1;
  }
  d->x = maggi_arena_numbers(&b->arena, d->x, d->number);
  d->z = maggi_arena_numbers(&b->arena, d->z, d->number);
  return d->x && d->z;
}

static int own_wheel(maggi_builder *b, maggi_wheel_def *d)
{
  OWN(body);
  OWN(carrier);
  OWN(tyre);
  OWN(road);
  return 1;
}

static int own_driver(maggi_builder *b, maggi_driver_def *d)
{
  OWN(body);
  OWN(coordinate);
  d->x = maggi_arena_numbers(&b->arena, d->x, d->number);
  d->y = maggi_arena_numbers(&b->arena, d->y, d->number);
  if (!d->speeds) return d->x && d->y;
  d->speeds = maggi_arena_numbers(&b->arena, d->speeds, d->number);
  return d->x && d->y && d->speeds;
}

static int own_function(maggi_builder *b, maggi_function_def *d)
{
  if (d->type == MAGGI_FUNCTION_CONSTANT)
    d->number = 1;
  else if (d->type == MAGGI_FUNCTION_SINE || d->type == MAGGI_FUNCTION_STEP ||
           d->type == MAGGI_FUNCTION_RAMP)
    d->number = 4;
  if (d->type != MAGGI_FUNCTION_KNOTS && d->type != MAGGI_FUNCTION_SPLINE) d->times = NULL;
  d->values = maggi_arena_numbers(&b->arena, d->values, d->number);
  if (!d->values || !d->times) return d->values != NULL;
  d->times = maggi_arena_numbers(&b->arena, d->times, d->number);
  return d->times != NULL;
}

static int own_sensor(maggi_builder *b, maggi_sensor_def *d)
{
  OWN(body);
  OWN(element);
  return maggi_sensor_own(&b->arena, d);
}

static int own_filter(maggi_builder *b, maggi_filter_def *d)
{
  OWN(signal);
  return 1;
}

static int own_objective(maggi_builder *b, maggi_objective_def *d)
{
  return maggi_objective_own(&b->arena, d);
}

static int own_design(maggi_builder *b, maggi_design_def *d)
{
  return maggi_design_own(&b->arena, d);
}

static void *grown(void *array, int n, int *capacity, size_t size)
{
  void *bigger;
  int cap;

  if (n < *capacity) return array;
  cap = *capacity ? 2 * *capacity : 8;
  bigger = realloc(array, (size_t)cap * size);
  if (bigger) *capacity = cap;
  return bigger;
}

/* names are unique in their section; those of point masses, in their body */
#define SCOPE_body(d)         ""
#define SCOPE_point_mass(d)   ((d)->body ? (d)->body : "")
#define SCOPE_loop(d)         ""
#define SCOPE_rod(d)          ""
#define SCOPE_spring(d)       ""
#define SCOPE_joint_spring(d) ""
#define SCOPE_force(d)        ""
#define SCOPE_tyre(d)         ""
#define SCOPE_road(d)         ""
#define SCOPE_wheel(d)        ""
#define SCOPE_driver(d)       ""
#define SCOPE_function(d)     ""
#define SCOPE_sensor(d)       ""
#define SCOPE_filter(d)       ""
#define SCOPE_objective(d)    ""
#define SCOPE_design(d)       ""

#define ADD(kind, section)                                                                         \
  maggi_status maggi_builder_##kind(maggi_builder *b, const maggi_##kind##_def *def)               \
  {                                                                                                \
    maggi_##kind##_def *list, *d;                                                                  \
    maggi_status status;                                                                           \
    int i;                                                                                         \
                                                                                                   \
    status = maggi_check_name(b, #section, def->name);                                             \
    if (status == MAGGI_OK) status = maggi_check_##kind(b, def);                                   \
    if (status != MAGGI_OK) return status;                                                         \
    for (i = 0; i < b->n##kind; ++i)                                                               \
      if (strcmp(b->kind[i].name, def->name) == 0 &&                                               \
          strcmp(SCOPE_##kind(&b->kind[i]), SCOPE_##kind(def)) == 0)                               \
        return maggi_fail_at(b, #section, def->name, "this name is there already");                \
    list = grown(b->kind, b->n##kind, &b->cap##kind, sizeof *list);                                \
    if (!list) return no_memory(b);                                                                \
    b->kind = list;                                                                                \
    d = &list[b->n##kind];                                                                         \
    *d = *def;                                                                                     \
    d->name = maggi_arena_text(&b->arena, def->name);                                              \
    if (!d->name || !own_##kind(b, d)) return no_memory(b);                                        \
    ++b->n##kind;                                                                                  \
    return MAGGI_OK;                                                                               \
  }

MAGGI_BUILDER_LIST(ADD)

maggi_status maggi_builder_gravity(maggi_builder *b, const double gravity[3])
{
  if (!maggi_all_finite(gravity, 3))
    return maggi_builder_fail(b, MAGGI_E_MODEL, "gravity: a number is not finite");
  memcpy(b->gravity, gravity, sizeof b->gravity);
  return MAGGI_OK;
}

maggi_status maggi_builder_source(maggi_builder *b, const char *text)
{
  const char *copy = maggi_arena_text(&b->arena, text);

  if (!copy) return no_memory(b);
  b->source = copy;
  return MAGGI_OK;
}

maggi_status maggi_builder_set(maggi_builder *b, const char *name, double value)
{
  maggi_setting *list;
  int i;

  if (!isfinite(value)) return maggi_fail_at(b, "set", name, "the value is not finite");
  for (i = 0; i < b->nsetting; ++i)
    if (strcmp(b->setting[i].name, name) == 0)
      return maggi_fail_at(b, "set", name, "this name is there already");
  list = grown(b->setting, b->nsetting, &b->capsetting, sizeof *list);
  if (!list) return no_memory(b);
  b->setting = list;
  list[b->nsetting].name = maggi_arena_text(&b->arena, name);
  list[b->nsetting].value = value;
  if (!list[b->nsetting].name) return no_memory(b);
  ++b->nsetting;
  return MAGGI_OK;
}

maggi_status maggi_builder_simulation(maggi_builder *b, const maggi_simulation_def *def)
{
  if (!isfinite(def->time) || def->time < 0.0)
    return maggi_builder_fail(b, MAGGI_E_MODEL, "simulation: time is not a positive number (%g)",
                              def->time);
  if (!isfinite(def->step) || def->step < 0.0)
    return maggi_builder_fail(b, MAGGI_E_MODEL, "simulation: step is not a positive number (%g)",
                              def->step);
  b->simulation = *def;
  return MAGGI_OK;
}

maggi_status maggi_builder_start(maggi_builder *b, const maggi_start_def *def)
{
  maggi_start_def d = *def;
  const char **hold = maggi_arena_alloc(&b->arena, ((size_t)d.nhold + 1) * sizeof *hold);
  int i;

  if (!hold) return no_memory(b);
  for (i = 0; i < d.nhold; ++i) {
    hold[i] = maggi_arena_text(&b->arena, def->hold[i]);
    if (!hold[i]) return no_memory(b);
  }
  d.hold = hold;
  b->start = d;
  return MAGGI_OK;
}

/* ----------------------------------------------------------------------------------- defaults */

void maggi_body_def_init(maggi_body_def *def)
{
  memset(def, 0, sizeof *def);
  def->parent = MAGGI_GROUND;
  def->axis[0] = 1.0;
}

void maggi_point_mass_def_init(maggi_point_mass_def *def)
{
  memset(def, 0, sizeof *def);
}

void maggi_loop_def_init(maggi_loop_def *def)
{
  memset(def, 0, sizeof *def);
  def->body_b = MAGGI_GROUND;
  def->axis_a[0] = 1.0;
  def->axis_b[0] = 1.0;
}

void maggi_rod_def_init(maggi_rod_def *def)
{
  memset(def, 0, sizeof *def);
  def->body_b = MAGGI_GROUND;
  def->length = NAN;
}

void maggi_spring_def_init(maggi_spring_def *def)
{
  memset(def, 0, sizeof *def);
  def->body_b = MAGGI_GROUND;
  def->free_length = NAN;
}

void maggi_joint_spring_def_init(maggi_joint_spring_def *def)
{
  memset(def, 0, sizeof *def);
}

void maggi_force_def_init(maggi_force_def *def)
{
  memset(def, 0, sizeof *def);
}

void maggi_tyre_def_init(maggi_tyre_def *def)
{
  static const double values[MAGGI_TYRE_NUMBERS] = {
#define X(name, key, unit, value, bound) value,
      MAGGI_TYRE_LIST(X)
#undef X
  };

  memset(def, 0, sizeof *def);
  memcpy(def->value, values, sizeof values);
}

void maggi_road_def_init(maggi_road_def *def)
{
  memset(def, 0, sizeof *def);
  def->number = 1;
  def->fillet = 0.05;
}

void maggi_wheel_def_init(maggi_wheel_def *def)
{
  memset(def, 0, sizeof *def);
  def->axis[1] = 1.0;
}

void maggi_driver_def_init(maggi_driver_def *def)
{
  memset(def, 0, sizeof *def);
}

void maggi_function_def_init(maggi_function_def *def)
{
  memset(def, 0, sizeof *def);
}

void maggi_sensor_def_init(maggi_sensor_def *def)
{
  memset(def, 0, sizeof *def);
  def->low_speed = 1e-3;
  def->low_acceleration = 1e-3;
}

void maggi_start_def_init(maggi_start_def *def)
{
  memset(def, 0, sizeof *def);
}

void maggi_filter_def_init(maggi_filter_def *def)
{
  memset(def, 0, sizeof *def);
  def->f1 = def->f2 = def->q4 = def->q5 = def->q6 = NAN;
  def->f3 = def->f4 = def->f5 = def->f6 = INFINITY;
  def->gain = 1.0;
}

void maggi_objective_def_init(maggi_objective_def *def)
{
  memset(def, 0, sizeof *def);
  def->from = NAN;
  def->to = NAN;
}

void maggi_design_def_init(maggi_design_def *def)
{
  memset(def, 0, sizeof *def);
  def->nominal = NAN;
  def->lower = -INFINITY;
  def->upper = INFINITY;
}
