/* Entries of `objectives`, `design` and `set`. */
#include "load_build.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* the two parts of a load_key */
#define KEY(entry, key) #key, entry->key != NULL

static const char *objective_word(int i)
{
  return maggi_objective_type_name((maggi_objective_type)i);
}

static const char *reference_word(int i)
{
  return maggi_reference_type_name((maggi_reference_type)i);
}

static const load_words objective_words = {objective_word, maggi_objective_type_find};
static const load_words reference_words = {reference_word, maggi_reference_type_find};

/* --------------------------------------------------------------------------------------- records */

/* what is wrong in the record has its own FILE:LINE: */
static maggi_status read_record(const load_build *b, const load_objective *o, load_record *record)
{
  char *path = maggi_load_path(b, o->file), text[400] = "";
  const load_error in_record = {path, text, sizeof text};
  maggi_status status = MAGGI_E_MEMORY;

  if (path) status = maggi_load_record(&in_record, o->column ? o->column : o->signal, record);
  if (status == MAGGI_E_FILE)
    maggi_load_fail_at(b, ".file", "%s", text);
  else if (status == MAGGI_E_MEMORY)
    maggi_load_fail(b->error, 0, "out of memory");
  else if (status != MAGGI_OK && b->error->message)
    snprintf(b->error->message, b->error->nmessage, "%s", text);
  free(path);
  return status;
}

static maggi_status check_points(const load_build *b, const load_objective *o)
{
  if (o->file && (o->times || o->values))
    return maggi_load_fail_at(b, "",
                              "\"file\" has the points, so without \"times\" and \"values\"");
  if (!o->file && !(o->times && o->values))
    return maggi_load_fail_at(b, "", "key \"file\" is missing, or \"times\" and \"values\"");
  if (!o->file && o->column) return maggi_load_fail_at(b, ".column", "a column without a file");
  if (o->times_count != o->values_count)
    return maggi_load_fail_at(b, ".values", "%u values for %u times", o->values_count,
                              o->times_count);
  return MAGGI_OK;
}

/* ------------------------------------------------------------------------------------ objectives */

/* signal, target, sharpness, times, values, file, column, terms, weights, reference, from, to, against */
static const char *rule_of(int type)
{
  switch (type) {
  case MAGGI_OBJECTIVE_SMOOTH_MAXIMUM:
    return "ror-------oo";
  case MAGGI_OBJECTIVE_VALUE:
    return "ro-r";
  case MAGGI_OBJECTIVE_LEAST_SQUARES:
    return "ro-oooo";
  case MAGGI_OBJECTIVE_SUM:
    return "-------ro";
  case MAGGI_OBJECTIVE_MAXIMUM:
  case MAGGI_OBJECTIVE_MINIMUM:
  case MAGGI_OBJECTIVE_PEAK:
  case MAGGI_OBJECTIVE_VIOLATION:
    return "ro--------oo";
  case MAGGI_OBJECTIVE_TERMINAL:
    return "ro---------o";
  case MAGGI_OBJECTIVE_SLOPE:
    return "r---------oor";
  default:
    return "ro-------ooo";
  }
}

maggi_status maggi_load_objective(const load_build *b, const load_objective *o)
{
  const load_key keys[] = {{KEY(o, signal)},    {KEY(o, target)}, {KEY(o, sharpness)},
                           {KEY(o, times)},     {KEY(o, values)}, {KEY(o, file)},
                           {KEY(o, column)},    {KEY(o, terms)},  {KEY(o, weights)},
                           {KEY(o, reference)}, {KEY(o, from)},   {KEY(o, to)},
                           {KEY(o, against)},   {NULL, 0}};
  load_record record = {0};
  maggi_objective_def def;
  int type, reference = MAGGI_REFERENCE_NONE;
  maggi_status status;

  maggi_objective_def_init(&def);
  status = maggi_load_word(b, ".type", o->type, &objective_words, &type);
  if (status == MAGGI_OK) status = maggi_load_keys(b, "", o->type, rule_of(type), keys);
  if (status == MAGGI_OK && type == MAGGI_OBJECTIVE_LEAST_SQUARES) status = check_points(b, o);
  if (status == MAGGI_OK && o->reference)
    status = maggi_load_word(b, ".reference", o->reference, &reference_words, &reference);
  if (status) return status;
  if (o->weights && o->weights_count != o->terms_count)
    return maggi_load_fail_at(b, ".weights", "%u weights for %u terms", o->weights_count,
                              o->terms_count);
  def.name = o->name;
  def.type = (maggi_objective_type)type;
  def.signal = o->signal;
  if (o->target) def.target = *o->target;
  if (o->sharpness) def.sharpness = *o->sharpness;
  if (o->from) def.from = *o->from;
  if (o->to) def.to = *o->to;
  def.reference = (maggi_reference_type)reference;
  def.against = o->against;
  def.number = (int)o->times_count;
  def.times = o->times;
  def.values = o->values;
  def.nterm = (int)o->terms_count;
  def.terms = (const char *const *)o->terms;
  def.weights = o->weights;
  if (o->file) {
    status = read_record(b, o, &record);
    def.number = record.n;
    def.times = record.times;
    def.values = record.values;
  }
  if (status == MAGGI_OK)
    status = maggi_load_added(b, "", maggi_builder_objective(b->builder, &def));
  maggi_load_record_free(&record);
  return status;
}

/* ---------------------------------------------------------------------------------------- design */

maggi_status maggi_load_design(const load_build *b, const load_design *g)
{
  maggi_design_def def;

  maggi_design_def_init(&def);
  if (g->factors && g->factors_count != g->parameters_count)
    return maggi_load_fail_at(b, ".factors", "%u factors for %u parameters", g->factors_count,
                              g->parameters_count);
  def.name = g->name;
  def.unit = g->unit;
  def.number = (int)g->parameters_count;
  def.paths = (const char *const *)g->parameters;
  def.factors = g->factors;
  if (g->nominal) def.nominal = *g->nominal;
  if (g->lower) def.lower = *g->lower;
  if (g->upper) def.upper = *g->upper;
  return maggi_load_added(b, "", maggi_builder_design(b->builder, &def));
}

maggi_status maggi_load_set(const load_build *b, const load_set *set)
{
  return maggi_load_added(b, "", maggi_builder_set(b->builder, set->name, set->value));
}
