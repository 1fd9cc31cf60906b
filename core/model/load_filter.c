/* Entries of `filters`: a weighting by name, or its numbers. */
#include "load_build.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *weighting_word(int i)
{
  return maggi_weighting_type_name((maggi_weighting_type)i);
}

static const load_words weighting_words = {weighting_word, maggi_weighting_type_find};

/* a number, or `inf` */
static maggi_status read_frequency(const load_build *b, const char *rest, const char *text,
                                   double *value)
{
  if (!text) return MAGGI_OK;
  if (!maggi_load_is_decimal(text) && strcmp(text, "inf") != 0)
    return maggi_load_fail_at(b, rest, "\"%.40s\" is neither a number nor inf", text);
  *value = strtod(text, NULL);
  return MAGGI_OK;
}

static void read_number(const double *from, double *to)
{
  if (from) *to = *from;
}

static maggi_status read_weighting(const load_build *b, const load_filter *f, maggi_filter_def *def)
{
  maggi_status status;
  int type;

  if (f->f1 || f->f2 || f->f3 || f->f4 || f->q4 || f->f5 || f->q5 || f->f6 || f->q6 || f->gain)
    return maggi_load_fail_at(b, ".weighting", "with the numbers of another one");
  status = maggi_load_word(b, ".weighting", f->weighting, &weighting_words, &type);
  if (status == MAGGI_OK) maggi_filter_def_weighting(def, (maggi_weighting_type)type);
  return status;
}

static maggi_status read_numbers(const load_build *b, const load_filter *f, maggi_filter_def *def)
{
  maggi_status status;

  if (!f->f1 || !f->f2)
    return maggi_load_fail_at(b, "", "key \"weighting\" is missing, or \"f1\" and \"f2\"");
  read_number(f->f1, &def->f1);
  read_number(f->f2, &def->f2);
  read_number(f->q4, &def->q4);
  read_number(f->q5, &def->q5);
  read_number(f->q6, &def->q6);
  read_number(f->gain, &def->gain);
  status = read_frequency(b, ".f3", f->f3, &def->f3);
  if (status == MAGGI_OK) status = read_frequency(b, ".f4", f->f4, &def->f4);
  if (status == MAGGI_OK) status = read_frequency(b, ".f5", f->f5, &def->f5);
  if (status == MAGGI_OK) status = read_frequency(b, ".f6", f->f6, &def->f6);
  return status;
}

maggi_status maggi_load_filter(const load_build *b, const load_filter *f)
{
  maggi_filter_def def;
  maggi_status status;

  maggi_filter_def_init(&def);
  status = f->weighting ? read_weighting(b, f, &def) : read_numbers(b, f, &def);
  if (status) return status;
  def.name = f->name;
  def.signal = f->signal;
  return maggi_load_added(b, "", maggi_builder_filter(b->builder, &def));
}
