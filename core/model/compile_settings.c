/* Numbers that a model has set after all definitions: by path or glob, then by design parameter. */
#include <math.h>
#include <string.h>

#include "compile.h"
#include "definition.h"

static maggi_status set(maggi_compile *c, const maggi_setting *s, int index, double value)
{
  maggi_parameter *p = &c->m->parameter[index];
  const char *wrong = maggi_parameter_wrong(p, value);

  if (wrong) return maggi_fail_at(c->b, "set", s->name, "%s %s (%g)", p->path, wrong, value);
  p->value = value;
  if (p->bound == MAGGI_BOUND_INITIAL_POSITION)
    c->m->position_given[p->coordinate] = MAGGI_INITIAL_GIVEN;
  if (p->bound == MAGGI_BOUND_INITIAL_VELOCITY)
    c->m->velocity_given[p->coordinate] = MAGGI_INITIAL_GIVEN;
  return MAGGI_OK;
}

/* of what two globs match the later decides */
static maggi_status set_paths(maggi_compile *c, const maggi_setting *s)
{
  maggi_status status = MAGGI_OK;
  int k = maggi_parameter_match(c->m, s->name, 0);

  if (k < 0)
    return maggi_fail_at(c->b, "set", s->name, "no number and no design parameter has this name");
  for (; k >= 0 && status == MAGGI_OK; k = maggi_parameter_match(c->m, s->name, k + 1))
    status = set(c, s, k, s->value);
  return status;
}

/* p_j = p_j0 + factor_j (b - nominal), p_0 being what it is so far */
static maggi_status set_design(maggi_compile *c, const maggi_setting *s, const maggi_design_def *d)
{
  double nominal = d->nominal, factor, now;
  maggi_status status = MAGGI_OK;
  int i, k;

  for (i = 0; i < d->number; ++i) {
    factor = d->factors ? d->factors[i] : 1.0;
    for (k = maggi_parameter_match(c->m, d->paths[i], 0); k >= 0 && status == MAGGI_OK;
         k = maggi_parameter_match(c->m, d->paths[i], k + 1)) {
      now = c->m->parameter[k].value;
      if (isnan(nominal)) nominal = now / factor;
      status = set(c, s, k, now + factor * (s->value - nominal));
    }
  }
  return status;
}

static const maggi_design_def *find_design(const maggi_compile *c, const char *name)
{
  int i;

  for (i = 0; i < c->m->ndesign; ++i)
    if (strcmp(c->m->design[i].name, name) == 0) return &c->m->design[i];
  return NULL;
}

maggi_status maggi_compile_settings(maggi_compile *c)
{
  const maggi_design_def *design;
  maggi_status status = MAGGI_OK;
  int i;

  for (i = 0; i < c->b->nsetting && status == MAGGI_OK; ++i)
    if (!find_design(c, c->b->setting[i].name)) status = set_paths(c, &c->b->setting[i]);
  for (i = 0; i < c->b->nsetting && status == MAGGI_OK; ++i) {
    design = find_design(c, c->b->setting[i].name);
    if (design) status = set_design(c, &c->b->setting[i], design);
  }
  return status;
}
