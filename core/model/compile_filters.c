/* Filters: weightings of ISO 8041, and which column of a sensor each weights. */
#include <math.h>
#include <string.h>

#include "compile.h"

/* f1 f2 f3 f4 q4 f5 q5 f6 q6 gain; infinite where a section has none.  ISO 8041-1 tables of parameters of
 * transfer functions, as printed in the manual of the Larson Davis HVM200. */
static const double weightings[MAGGI_WEIGHTING_TYPE_COUNT][10] = {
    [MAGGI_WEIGHTING_WK] = {0.4, 100.0, 12.5, 12.5, 0.63, 2.37, 0.91, 3.35, 0.91, 1.0},
    [MAGGI_WEIGHTING_WD] = {0.4, 100.0, 2.0, 2.0, 0.63, INFINITY, 1.0, INFINITY, 1.0, 1.0},
    [MAGGI_WEIGHTING_WF] = {0.08, 0.63, INFINITY, 0.25, 0.86, 0.0625, 0.8, 0.1, 0.8, 1.0},
    [MAGGI_WEIGHTING_WC] = {0.4, 100.0, 8.0, 8.0, 0.63, INFINITY, 1.0, INFINITY, 1.0, 1.0},
    [MAGGI_WEIGHTING_WE] = {0.4, 100.0, 1.0, 1.0, 0.63, INFINITY, 1.0, INFINITY, 1.0, 1.0},
    [MAGGI_WEIGHTING_WJ] = {0.4, 100.0, INFINITY, INFINITY, 1.0, 3.75, 0.91, 5.32, 0.91, 1.0},
    [MAGGI_WEIGHTING_WB] = {0.4, 100.0, 16.0, 16.0, 0.55, 2.5, 0.9, 4.0, 0.95, 1.024},
    [MAGGI_WEIGHTING_WG] = {0.8, 100.0, 1.5, 5.3, 0.68, INFINITY, 1.0, INFINITY, 1.0, 0.42}};

void maggi_filter_def_weighting(maggi_filter_def *def, maggi_weighting_type weighting)
{
  const double *x = weightings[weighting];

  def->f1 = x[0];
  def->f2 = x[1];
  def->f3 = x[2];
  def->f4 = x[3];
  def->q4 = x[4];
  def->f5 = x[5];
  def->q5 = x[6];
  def->f6 = x[7];
  def->q6 = x[8];
  def->gain = x[9];
}

/* address of an entry of p that must be positive, -1 if it is infinite */
static int add_positive(maggi_compile *c, const maggi_filter_def *d, const char *key,
                        const char *unit, double value)
{
  if (isinf(value)) return -1;
  return maggi_parameter_add(c, value, unit, MAGGI_BOUND_POSITIVE, "filters.%s.%s", d->name, key);
}

/* the order of the paths is that of weightings */
static void add_numbers(maggi_compile *c, const maggi_filter_def *d)
{
  PUSH(filteradr, add_positive(c, d, "f1", "Hz", d->f1));
  add_positive(c, d, "f2", "Hz", d->f2);
  PUSH(filterf3, add_positive(c, d, "f3", "Hz", d->f3));
  PUSH(filterf4, add_positive(c, d, "f4", "Hz", d->f4));
  if (isfinite(d->f4)) add_positive(c, d, "q4", "-", d->q4);
  PUSH(filterf5, add_positive(c, d, "f5", "Hz", d->f5));
  if (isfinite(d->f5)) {
    add_positive(c, d, "q5", "-", d->q5);
    add_positive(c, d, "f6", "Hz", d->f6);
    add_positive(c, d, "q6", "-", d->q6);
  }
  PUSH(filtergain,
       maggi_parameter_add(c, d->gain, "-", MAGGI_BOUND_NONE, "filters.%s.gain", d->name));
}

static maggi_status add_filter(maggi_compile *c, const maggi_filter_def *d, int i)
{
  maggi_model *m = c->m;
  int column;

  if (!d->signal)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL, "filters.%s: signal is missing", d->name);
  column = maggi_compile_column(c->m, d->signal);
  if (column < 0)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL,
                              "filters.%s: signal \"%s\" is no column of a sensor", d->name,
                              d->signal);
  PUSH(filtersensor, m->sensorplace[column] / 3);
  PUSH(filtercolumn, m->sensorplace[column] % 3);
  PUSH(filterstate, c->t->nstate);
  add_numbers(c, d);
  c->t->nstate += 4 + (isfinite(d->f4) ? 2 : 0) + (isfinite(d->f5) ? 2 : 0);
  m->filterunit[i] = m->sensorunit[column];
  m->filtercolumn[i] = maggi_arena_format(&m->arena, "%s.weighted", d->name);
  return m->filtercolumn[i] ? MAGGI_OK : MAGGI_E_MEMORY;
}

maggi_status maggi_compile_filters(maggi_compile *c)
{
  maggi_builder *b = c->b;
  maggi_model *m = c->m;
  size_t n = (size_t)b->nfilter + 1;
  maggi_status status;
  int i;

  m->filtercolumn = maggi_arena_alloc(&m->arena, n * sizeof *m->filtercolumn);
  m->filterunit = maggi_arena_alloc(&m->arena, n * sizeof *m->filterunit);
  if (!m->filtercolumn || !m->filterunit) return MAGGI_E_MEMORY;
  for (i = 0; i < b->nfilter; ++i) {
    status = add_filter(c, &b->filter[i], i);
    if (status != MAGGI_OK) return status;
  }
  c->t->nfilter = b->nfilter;
  return c->no_memory ? MAGGI_E_MEMORY : MAGGI_OK;
}
