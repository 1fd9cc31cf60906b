/* Objectives and design parameters of a model: copies, after a look at the names in them. */
#include <string.h>

#include "compile.h"
#include "definition.h"

static maggi_status check_signals(maggi_compile *c, const maggi_objective_def *d)
{
  int i;

  if (d->signal && maggi_signal_find(c->m, d->signal) < 0)
    return maggi_fail_at(c->b, "objectives", d->name, "signal \"%s\" does not exist", d->signal);
  if (d->type == MAGGI_OBJECTIVE_SLOPE && maggi_signal_find(c->m, d->against) < 0)
    return maggi_fail_at(c->b, "objectives", d->name, "against \"%s\" does not exist", d->against);
  for (i = 0; i < d->nsignal; ++i)
    if (maggi_signal_find(c->m, d->signals[i]) < 0)
      return maggi_fail_at(c->b, "objectives", d->name, "signals: \"%s\" does not exist",
                           d->signals[i]);
  return MAGGI_OK;
}

static maggi_status check_terms(maggi_compile *c, const maggi_objective_def *d)
{
  const maggi_objective_def *term;
  int i;

  for (i = 0; i < d->nterm; ++i) {
    term = maggi_model_find_objective(c->m, d->terms[i]);
    if (!term)
      return maggi_fail_at(c->b, "objectives", d->name, "terms: \"%s\" does not exist",
                           d->terms[i]);
    if (term->type == MAGGI_OBJECTIVE_SUM)
      return maggi_fail_at(c->b, "objectives", d->name, "terms: \"%s\" is a sum itself",
                           d->terms[i]);
  }
  return MAGGI_OK;
}

static maggi_status add_objectives(maggi_compile *c)
{
  maggi_model *m = c->m;
  size_t n = (size_t)c->b->nobjective;
  maggi_status status = MAGGI_OK;
  int i;

  m->objective = maggi_arena_alloc(&m->arena, n * sizeof *m->objective);
  if (!m->objective) return MAGGI_E_MEMORY;
  for (; m->nobjective < c->b->nobjective; ++m->nobjective) {
    maggi_objective_def *d = &m->objective[m->nobjective];

    *d = c->b->objective[m->nobjective];
    status = check_signals(c, d);
    if (status != MAGGI_OK) return status;
    d->name = maggi_arena_text(&m->arena, d->name);
    if (!d->name || !maggi_objective_own(&m->arena, d)) return MAGGI_E_MEMORY;
  }
  for (i = 0; i < m->nobjective && status == MAGGI_OK; ++i)
    status = check_terms(c, &m->objective[i]);
  return status;
}

/* each glob means something, and no entry twice */
static maggi_status check_paths(maggi_compile *c, const maggi_design_def *d)
{
  int *seen = maggi_arena_alloc(&c->m->arena, (size_t)c->m->nparameter * sizeof *seen);
  int i, k;

  if (!seen) return MAGGI_E_MEMORY;
  for (i = 0; i < d->number; ++i) {
    k = maggi_parameter_match(c->m, d->paths[i], 0);
    if (k < 0)
      return maggi_fail_at(c->b, "design", d->name, "parameters: \"%s\" does not exist",
                           d->paths[i]);
    for (; k >= 0; k = maggi_parameter_match(c->m, d->paths[i], k + 1))
      if (seen[k]++)
        return maggi_fail_at(c->b, "design", d->name, "parameters: \"%s\" is there twice",
                             c->m->parameter[k].path);
  }
  return MAGGI_OK;
}

static maggi_status add_design(maggi_compile *c)
{
  maggi_model *m = c->m;
  size_t n = (size_t)c->b->ndesign;
  maggi_status status;

  m->design = maggi_arena_alloc(&m->arena, n * sizeof *m->design);
  if (!m->design) return MAGGI_E_MEMORY;
  for (; m->ndesign < c->b->ndesign; ++m->ndesign) {
    maggi_design_def *d = &m->design[m->ndesign];

    *d = c->b->design[m->ndesign];
    status = check_paths(c, d);
    if (status != MAGGI_OK) return status;
    d->name = maggi_arena_text(&m->arena, d->name);
    if (!d->name || !maggi_design_own(&m->arena, d)) return MAGGI_E_MEMORY;
  }
  return MAGGI_OK;
}

maggi_status maggi_compile_definitions(maggi_compile *c)
{
  maggi_status status = add_objectives(c);

  return status == MAGGI_OK ? add_design(c) : status;
}
