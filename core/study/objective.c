/* Objectives: signals, terms of a sum, units. */
#include "objective.h"

#include <stdlib.h>
#include <string.h>

#include "definition.h"
#include "message.h"

/* ---------------------------------------------------------------------------------------- units */

static const char *square(maggi_arena *arena, const char *unit)
{
  if (!unit || strcmp(unit, "-") == 0) return unit;
  return maggi_arena_format(arena, strpbrk(unit, " /^") ? "(%s)^2" : "%s^2", unit);
}

static const char *times(maggi_arena *arena, const char *unit, const char *factor)
{
  if (!unit || strcmp(unit, "-") == 0) return unit ? factor : NULL;
  return maggi_arena_format(arena, *unit != '(' && strchr(unit, '/') ? "(%s) %s" : "%s %s", unit,
                            factor);
}

static const char *per(maggi_arena *arena, const char *unit, const char *other)
{
  if (!unit || strcmp(other, "-") == 0) return unit;
  if (strcmp(unit, other) == 0) return "-";
  if (strcmp(unit, "-") == 0) unit = "1";
  return maggi_arena_format(arena, strpbrk(other, " /") ? "%s/(%s)" : "%s/%s", unit, other);
}

/* that of an objective of a signal with this unit; NULL without memory */
static const char *unit_of(maggi_arena *arena, maggi_objective_type type, const char *unit)
{
  switch (type) {
  case MAGGI_OBJECTIVE_INTEGRAL:
    return times(arena, unit, "s");
  case MAGGI_OBJECTIVE_INTEGRAL_SQUARE:
  case MAGGI_OBJECTIVE_VIOLATION:
    return times(arena, square(arena, unit), "s");
  case MAGGI_OBJECTIVE_MEAN_SQUARE:
  case MAGGI_OBJECTIVE_LEAST_SQUARES:
    return square(arena, unit);
  case MAGGI_OBJECTIVE_NORM:
    return times(arena, unit, "s^(1/2)");
  case MAGGI_OBJECTIVE_VDV:
    return times(arena, unit, "s^(1/4)");
  default:
    return unit;
  }
}

/* ------------------------------------------------------------------------------------- creation */

static int slot_of(maggi_objective *o, int signal)
{
  int i;

  for (i = 0; i < o->nsignal; ++i)
    if (o->signal[i] == signal) return i;
  o->signal[o->nsignal] = signal;
  return o->nsignal++;
}

static int signals_of(const maggi_objective_def *d)
{
  return d->function ? d->nsignal : 1;
}

static maggi_status add_signal(maggi_objective *o, const maggi_objective_def *d, const char *name,
                               int *slot, char *message, size_t n)
{
  int signal = maggi_signal_find(o->m, name);

  if (signal < 0)
    return maggi_message(MAGGI_E_NAME, message, n, "objective \"%s\": no signal \"%s\"", d->name,
                         name);
  *slot = slot_of(o, signal);
  return MAGGI_OK;
}

static maggi_status add_signals(maggi_objective *o, maggi_summand *s, const maggi_objective_def *d,
                                char *message, size_t n)
{
  maggi_status status = MAGGI_OK;
  int i;

  s->nsignal = signals_of(d);
  s->slot = maggi_arena_alloc(&o->arena, (size_t)s->nsignal * sizeof *s->slot);
  if (!s->slot) return maggi_message_memory(message, n);
  for (i = 0; i < s->nsignal && status == MAGGI_OK; ++i)
    status = add_signal(o, d, d->function ? d->signals[i] : d->signal, &s->slot[i], message, n);
  s->against = s->slot[0];
  if (status == MAGGI_OK && d->type == MAGGI_OBJECTIVE_SLOPE)
    status = add_signal(o, d, d->against, &s->against, message, n);
  return status;
}

static maggi_status add_summand(maggi_objective *o, const maggi_objective_def *def, double weight,
                                char *message, size_t n)
{
  maggi_objective_def d = *def;
  maggi_summand *s = &o->summand[o->nsummand++];
  const char *unit = "-"; /* of a function: not known */
  maggi_status status;

  d.name = maggi_arena_text(&o->arena, def->name);
  if (!d.name || !maggi_objective_own(&o->arena, &d)) return maggi_message_memory(message, n);
  s->name = d.name;
  s->weight = weight;
  s->function = d.function;
  s->context = d.context;
  s->term.type = d.type;
  s->term.target = d.target;
  s->term.sharpness = d.sharpness;
  s->term.reference = d.reference;
  s->term.from = d.from;
  s->term.to = d.to;
  s->term.number = d.number;
  s->term.times = d.times;
  s->term.values = d.values;
  s->term.residual = maggi_arena_alloc(&o->arena, (size_t)d.number * sizeof *s->term.residual);
  if (!s->term.residual) return maggi_message_memory(message, n);
  status = add_signals(o, s, &d, message, n);
  if (status != MAGGI_OK) return status;
  if (!d.function) unit = maggi_signal_unit(o->m, o->signal[s->slot[0]]);
  unit = d.type == MAGGI_OBJECTIVE_SLOPE
             ? per(&o->arena, unit, maggi_signal_unit(o->m, o->signal[s->against]))
             : unit_of(&o->arena, d.type, unit);
  if (!unit) return maggi_message_memory(message, n);
  o->unit = !o->unit || strcmp(o->unit, unit) == 0 ? unit : "-"; /* of a sum: that of its terms */
  return MAGGI_OK;
}

/* the summands of a definition: itself, or the terms of a sum */
static maggi_status find_summands(const maggi_objective *o, const maggi_objective_def *def,
                                  const maggi_objective_def **list, char *message, size_t n)
{
  int i;

  if (def->type != MAGGI_OBJECTIVE_SUM) list[0] = def;
  for (i = 0; def->type == MAGGI_OBJECTIVE_SUM && i < def->nterm; ++i) {
    list[i] = maggi_model_find_objective(o->m, def->terms[i]);
    if (!list[i])
      return maggi_message(MAGGI_E_NAME, message, n, "objective \"%s\": no objective \"%s\"",
                           def->name, def->terms[i]);
    if (list[i]->type == MAGGI_OBJECTIVE_SUM)
      return maggi_message(MAGGI_E_VALUE, message, n, "objective \"%s\": \"%s\" is a sum itself",
                           def->name, def->terms[i]);
  }
  return MAGGI_OK;
}

static maggi_status fill(maggi_objective *o, const maggi_objective_def *def, char *message,
                         size_t n)
{
  int i, nsummand = def->type == MAGGI_OBJECTIVE_SUM ? def->nterm : 1;
  const maggi_objective_def **list;
  size_t signals = 0;
  maggi_status status;

  o->name = maggi_arena_text(&o->arena, def->name);
  list = maggi_arena_alloc(&o->arena, (size_t)nsummand * sizeof *list);
  o->summand = maggi_arena_alloc(&o->arena, (size_t)nsummand * sizeof *o->summand);
  if (!o->name || !list || !o->summand) return maggi_message_memory(message, n);
  status = find_summands(o, def, list, message, n);
  if (status != MAGGI_OK) return status;
  for (i = 0; i < nsummand; ++i) signals += (size_t)signals_of(list[i]) + 1;
  o->signal = maggi_arena_alloc(&o->arena, signals * sizeof *o->signal);
  o->arguments = maggi_arena_alloc(&o->arena, signals * sizeof *o->arguments);
  o->gradient = maggi_arena_alloc(&o->arena, signals * sizeof *o->gradient);
  if (!o->signal || !o->arguments || !o->gradient) return maggi_message_memory(message, n);
  for (i = 0; i < nsummand && status == MAGGI_OK; ++i)
    status =
        add_summand(o, list[i], list[i] != def && def->weights ? def->weights[i] : 1.0, message, n);
  return status;
}

maggi_status maggi_objective_create(const maggi_model *m, const maggi_objective_def *def,
                                    maggi_objective **objective, char *message, size_t nmessage)
{
  maggi_objective *o;
  maggi_status status;
  char text[200];

  *objective = NULL;
  if (!def->name || !*def->name)
    return maggi_message(MAGGI_E_VALUE, message, nmessage, "an objective has no name");
  status = maggi_objective_wrong(def, text, sizeof text);
  if (status != MAGGI_OK)
    return maggi_message(status, message, nmessage, "objective \"%s\": %s", def->name, text);
  o = calloc(1, sizeof *o);
  if (!o) return maggi_message_memory(message, nmessage);
  o->m = m;
  status = fill(o, def, message, nmessage);
  if (status != MAGGI_OK) {
    maggi_objective_free(o);
    return status;
  }
  *objective = o;
  return MAGGI_OK;
}

/* TYPE(SIGNAL) */
static maggi_status create_function(const maggi_model *m, const char *name,
                                    maggi_objective **objective, char *message, size_t n)
{
  const char *open = strchr(name, '('), *word;
  size_t length = strlen(name), head = (size_t)(open - name);
  maggi_arena arena = {0};
  maggi_objective_def def;
  maggi_status status;
  char *type, *signal;
  int t;

  maggi_objective_def_init(&def);
  type = maggi_arena_text(&arena, name);
  signal = maggi_arena_text(&arena, open + 1);
  if (!type || !signal) {
    maggi_arena_free(&arena);
    return maggi_message_memory(message, n);
  }
  type[head] = '\0';
  signal[length - head - 2] = '\0';
  t = maggi_objective_type_find(type);
  word = t == MAGGI_OBJECTIVE_SUM              ? "terms"
         : t == MAGGI_OBJECTIVE_SMOOTH_MAXIMUM ? "a sharpness"
         : t == MAGGI_OBJECTIVE_VALUE          ? "times"
         : t == MAGGI_OBJECTIVE_LEAST_SQUARES  ? "a record"
         : t == MAGGI_OBJECTIVE_SLOPE          ? "another signal"
                                               : NULL;
  if (t < 0) {
    status =
        maggi_message(MAGGI_E_NAME, message, n, "objective \"%s\": no type \"%s\"", name, type);
  } else if (word) {
    status =
        maggi_message(MAGGI_E_VALUE, message, n,
                      "objective \"%s\": a %s needs %s, declare it in the model", name, type, word);
  } else {
    def.name = name;
    def.type = (maggi_objective_type)t;
    def.signal = signal;
    status = maggi_objective_create(m, &def, objective, message, n);
  }
  maggi_arena_free(&arena);
  return status;
}

maggi_status maggi_objective_named(const maggi_model *m, const char *name,
                                   maggi_objective **objective, char *message, size_t nmessage)
{
  const maggi_objective_def *def = maggi_model_find_objective(m, name);
  size_t length = strlen(name);

  *objective = NULL;
  if (def) return maggi_objective_create(m, def, objective, message, nmessage);
  if (strchr(name, '(') && name[length - 1] == ')')
    return create_function(m, name, objective, message, nmessage);
  return maggi_message(MAGGI_E_NAME, message, nmessage, "no objective \"%s\"", name);
}

void maggi_objective_free(maggi_objective *objective)
{
  if (!objective) return;
  maggi_arena_free(&objective->arena);
  free(objective);
}

const char *maggi_objective_name(const maggi_objective *objective)
{
  return objective->name;
}

const char *maggi_objective_unit(const maggi_objective *objective)
{
  return objective->unit;
}
