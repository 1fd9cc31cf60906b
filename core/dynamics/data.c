/* Memory of a simulation. */
#include "data.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

maggi_status maggi_data_fail(maggi_data *d, maggi_status status, const char *format, ...)
{
  va_list args;

  va_start(args, format);
  vsnprintf(d->message, sizeof d->message, format, args);
  va_end(args);
  return status;
}

/* zeroed, on a cache line; at least one line, so that an empty array has an address */
static double *numbers(size_t n)
{
  size_t size = (n * sizeof(double) + 127) / 64 * 64;
  double *a = aligned_alloc(64, size);

  if (a) memset(a, 0, size);
  return a;
}

/* the sizes named in the lists */
static size_t size_of(const char *name, const maggi_topo *t)
{
  if (strcmp(name, "nbody1") == 0) return (size_t)t->nbody + 1;
  if (strcmp(name, "nqblock") == 0)
    return ((size_t)t->nq + MAGGI_WIDTH - 1) / MAGGI_WIDTH * MAGGI_WIDTH;
  if (strcmp(name, "nq16") == 0) return (size_t)t->nq * MAGGI_WIDTH * 2;
#define X(size, text)                                                                              \
  if (strcmp(name, #size) == 0) return (size_t)t->size;
  MAGGI_TOPO_SIZES(X)
#undef X
  return 0;
}

maggi_status maggi_data_create(const maggi_model *m, maggi_data **data)
{
  maggi_data *d;
  size_t nq = (size_t)m->topo.nq + 1;
  int i, ok;

  *data = NULL;
  d = calloc(1, sizeof *d);
  if (!d) return MAGGI_E_MEMORY;
  d->m = m;
  d->t = m->topo;
  d->tolerance = 1e-10;
  d->rank_tolerance = MAGGI_RANK_TOLERANCE;
  d->position_given = calloc(nq, sizeof(int));
  d->velocity_given = calloc(nq, sizeof(int));
  d->kept_plan = malloc(maggi_saved_plan_size(&d->t) + 1);
  ok = d->kept_plan && d->position_given && d->velocity_given &&
       maggi_planner_create(m, &d->planner) == MAGGI_OK;
#define X(name, rows, cols, text)                                                                  \
  d->name = (double(*)[cols])numbers(size_of(#rows, &d->t) * cols);                                \
  ok = ok && d->name;
  MAGGI_DATA_LIST(X)
#undef X
#define X(name, size, text)                                                                        \
  d->name = numbers(size_of(#size, &d->t));                                                        \
  ok = ok && d->name;
  MAGGI_DATA_VECTORS(X)
#undef X
  if (!ok) {
    maggi_data_free(d);
    return MAGGI_E_MEMORY;
  }
  if (m->twin && maggi_equilibrium_create(m->twin, &d->equilibrium) != MAGGI_OK) {
    maggi_data_free(d);
    return MAGGI_E_MEMORY;
  }
  d->start = (maggi_node){.q = d->q0, .v = d->v0, .a = d->a0, .y = d->y0, .yrate = d->yrate0};
  d->node = (maggi_node){.q = d->qn, .v = d->vn, .a = d->an, .y = d->yn, .yrate = d->yraten};
  for (i = 0; i < m->nparameter; ++i) d->p[i] = m->parameter[i].value;
  memcpy(d->position_given, m->position_given, (nq - 1) * sizeof(int));
  memcpy(d->velocity_given, m->velocity_given, (nq - 1) * sizeof(int));
  *data = d;
  return MAGGI_OK;
}

void maggi_data_free(maggi_data *d)
{
  if (!d) return;
#define X(name, rows, cols, text) free(d->name);
  MAGGI_DATA_LIST(X)
#undef X
#define X(name, size, text) free(d->name);
  MAGGI_DATA_VECTORS(X)
  MAGGI_PLAN_VECTORS(X)
#undef X
  free(d->kept_plan);
  free(d->position_given);
  free(d->velocity_given);
  maggi_planner_free(d->planner);
  maggi_equilibrium_free(d->equilibrium);
  free(d);
}

static int fit(double **a, size_t *cap, size_t n)
{
  if (n > *cap || !*a) {
    free(*a);
    *a = numbers(n + n / 4 + 64); /* room for another choice of coordinates */
    *cap = *a ? n + n / 4 + 64 : 0;
  } else {
    memset(*a, 0, n * sizeof(double));
  }
  return *a != NULL;
}

maggi_status maggi_data_fit(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  int i, ok = 1;

#define X(name, size, text) ok = fit(&d->name, &d->cap##name, (size_t)t->size) && ok;
  MAGGI_PLAN_VECTORS(X)
#undef X
  if (!ok) return maggi_data_fail(d, MAGGI_E_MEMORY, "out of memory");
  for (i = 0; i < t->ncol; ++i) d->R[t->colq[i] * t->stride + i] = 1.0;
  memset(d->ab, 0, (size_t)t->nq * sizeof(double));
  memset(d->dq, 0, (size_t)t->nq * sizeof(double));
  ++d->plans;
  return MAGGI_OK;
}

const char *maggi_data_message(const maggi_data *d)
{
  return d->message;
}

maggi_status maggi_data_set_parameter(maggi_data *d, int index, double value)
{
  const maggi_parameter *p;
  const char *wrong;

  if (index < 0 || index >= d->m->nparameter)
    return maggi_data_fail(d, MAGGI_E_NAME, "no parameter has the index %d", index);
  p = &d->m->parameter[index];
  wrong = maggi_parameter_wrong(p, value);
  if (wrong) return maggi_data_fail(d, MAGGI_E_VALUE, "%s %s (%g)", p->path, wrong, value);
  d->p[index] = value;
  if (p->bound == MAGGI_BOUND_INITIAL_POSITION)
    d->position_given[p->coordinate] = MAGGI_INITIAL_GIVEN;
  if (p->bound == MAGGI_BOUND_INITIAL_VELOCITY)
    d->velocity_given[p->coordinate] = MAGGI_INITIAL_GIVEN;
  return MAGGI_OK;
}

double maggi_data_get_parameter(const maggi_data *d, int index)
{
  return index >= 0 && index < d->m->nparameter ? d->p[index] : NAN;
}

maggi_status maggi_data_set_tolerance(maggi_data *d, double tolerance)
{
  if (!(tolerance > 0.0) || !isfinite(tolerance))
    return maggi_data_fail(d, MAGGI_E_VALUE, "the tolerance must be positive (%g)", tolerance);
  d->tolerance = tolerance;
  return MAGGI_OK;
}
