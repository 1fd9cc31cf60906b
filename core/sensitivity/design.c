/* Design parameters: linear maps onto the parameters of a model. */
#include "design.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "data.h"
#include "definition.h"
#include "message.h"

typedef struct design_parameter {
  const char *name, *unit;
  double nominal, lower, upper;
  int n;
  int *entry;     /* (n) of p */
  double *factor; /* (n) */
} design_parameter;

struct maggi_design {
  const maggi_model *m;
  maggi_arena arena;
  double *p0; /* (np) */
  int number, cap;
  design_parameter *parameter;
};

maggi_status maggi_design_create(const maggi_data *d, maggi_design **design)
{
  maggi_design *g = calloc(1, sizeof *g);

  *design = NULL;
  if (!g) return MAGGI_E_MEMORY;
  g->m = d->m;
  g->p0 = maggi_arena_numbers(&g->arena, d->p, d->m->nparameter);
  if (!g->p0) {
    maggi_design_free(g);
    return MAGGI_E_MEMORY;
  }
  *design = g;
  return MAGGI_OK;
}

void maggi_design_free(maggi_design *design)
{
  if (!design) return;
  free(design->parameter);
  maggi_arena_free(&design->arena);
  free(design);
}

/* ------------------------------------------------------------------------------------ additions */

/* room for one more with n entries at the end, NULL without memory; it counts when it is filled */
static design_parameter *room(maggi_design *g, const char *name, int n)
{
  design_parameter *q;
  int cap;

  if (g->number == g->cap) {
    cap = g->cap ? 2 * g->cap : 16;
    q = realloc(g->parameter, (size_t)cap * sizeof *q);
    if (!q) return NULL;
    g->parameter = q;
    g->cap = cap;
  }
  q = &g->parameter[g->number];
  q->n = 0;
  q->name = maggi_arena_text(&g->arena, name);
  q->entry = maggi_arena_alloc(&g->arena, (size_t)n * sizeof *q->entry);
  q->factor = maggi_arena_alloc(&g->arena, (size_t)n * sizeof *q->factor);
  return q->name && q->entry && q->factor ? q : NULL;
}

/* Whether one of the first `number` has the name. */
static int is_there(const maggi_design *g, int number, const char *name)
{
  int i;

  for (i = 0; i < number; ++i)
    if (strcmp(g->parameter[i].name, name) == 0) return 1;
  return 0;
}

static maggi_status fail_there(const char *name, char *message, size_t n)
{
  return maggi_message(MAGGI_E_NAME, message, n, "design parameter \"%s\" is there already", name);
}

/* entries of all paths of a definition: at most as many as p has */
static maggi_status add_entries(maggi_design *g, design_parameter *q, const maggi_design_def *d,
                                char *message, size_t n)
{
  int i, j, k;

  for (i = 0; i < d->number; ++i) {
    k = maggi_parameter_match(g->m, d->paths[i], 0);
    if (k < 0)
      return maggi_message(MAGGI_E_NAME, message, n, "design parameter \"%s\": no parameter \"%s\"",
                           d->name, d->paths[i]);
    for (; k >= 0; k = maggi_parameter_match(g->m, d->paths[i], k + 1)) {
      for (j = 0; j < q->n; ++j)
        if (q->entry[j] == k)
          return maggi_message(MAGGI_E_VALUE, message, n,
                               "design parameter \"%s\": \"%s\" is there twice", d->name,
                               g->m->parameter[k].path);
      q->entry[q->n] = k;
      q->factor[q->n++] = d->factors ? d->factors[i] : 1.0;
    }
  }
  return MAGGI_OK;
}

maggi_status maggi_design_add(maggi_design *design, const maggi_design_def *def, char *message,
                              size_t nmessage)
{
  maggi_design *g = design;
  design_parameter *q;
  maggi_status status;
  char text[200];

  if (!def->name || !*def->name)
    return maggi_message(MAGGI_E_VALUE, message, nmessage, "a design parameter has no name");
  status = maggi_design_wrong(def, text, sizeof text);
  if (status != MAGGI_OK)
    return maggi_message(status, message, nmessage, "design parameter \"%s\": %s", def->name, text);
  if (is_there(g, g->number, def->name)) return fail_there(def->name, message, nmessage);
  q = room(g, def->name, g->m->nparameter);
  if (!q) return maggi_message_memory(message, nmessage);
  status = add_entries(g, q, def, message, nmessage);
  if (status != MAGGI_OK) return status;
  q->unit = maggi_arena_text(&g->arena, def->unit ? def->unit : g->m->parameter[q->entry[0]].unit);
  if (!q->unit) return maggi_message_memory(message, nmessage);
  q->nominal = isnan(def->nominal) ? g->p0[q->entry[0]] / q->factor[0] : def->nominal;
  q->lower = def->lower;
  q->upper = def->upper;
  ++g->number;
  return MAGGI_OK;
}

/* the entry of p by its path, unless one of the first `number` has this name */
static maggi_status add_entry(maggi_design *g, int number, int entry, char *message, size_t n)
{
  const maggi_parameter *p = &g->m->parameter[entry];
  design_parameter *q;

  if (is_there(g, number, p->path)) return fail_there(p->path, message, n);
  q = room(g, p->path, 1);
  if (!q) return maggi_message_memory(message, n);
  q->unit = p->unit;
  q->nominal = g->p0[entry];
  q->lower = -INFINITY;
  q->upper = INFINITY;
  q->n = 1;
  q->entry[0] = entry;
  q->factor[0] = 1.0;
  ++g->number;
  return MAGGI_OK;
}

static maggi_status select_entries(maggi_design *g, const char *pattern, char *message, size_t n)
{
  maggi_status status = MAGGI_OK;
  int k, before = g->number;

  k = maggi_parameter_match(g->m, pattern, 0);
  if (k < 0) return maggi_message(MAGGI_E_NAME, message, n, "no parameter \"%s\"", pattern);
  for (; k >= 0 && status == MAGGI_OK; k = maggi_parameter_match(g->m, pattern, k + 1))
    status = add_entry(g, before, k, message, n);
  return status;
}

maggi_status maggi_design_select(maggi_design *design, const char *pattern, char *message,
                                 size_t nmessage)
{
  maggi_design *g = design;
  maggi_status status = MAGGI_OK;
  int i, before = g->number, any = 0;

  if (strcmp(pattern, "all") == 0) {
    status = select_entries(g, "*", message, nmessage);
  } else {
    for (i = 0; i < g->m->ndesign && status == MAGGI_OK; ++i) {
      if (!maggi_matches(pattern, g->m->design[i].name)) continue;
      status = maggi_design_add(g, &g->m->design[i], message, nmessage);
      any = 1;
    }
    if (!any) status = select_entries(g, pattern, message, nmessage);
  }
  if (status != MAGGI_OK) g->number = before;
  return status;
}

/* ------------------------------------------------------------------------------------------ use */

/* p of d at p_0 in all entries that a design moves */
static void set_nominal(const maggi_design *g, maggi_data *d)
{
  int i, j;

  for (i = 0; i < g->number; ++i)
    for (j = 0; j < g->parameter[i].n; ++j)
      d->p[g->parameter[i].entry[j]] = g->p0[g->parameter[i].entry[j]];
}

maggi_status maggi_design_set(const maggi_design *design, maggi_data *d, const double *b)
{
  const maggi_design *g = design;
  const maggi_parameter *p;
  const char *wrong;
  double value;
  int i, j, k;

  set_nominal(g, d);
  for (i = 0; i < g->number; ++i)
    for (j = 0; j < g->parameter[i].n; ++j)
      d->p[g->parameter[i].entry[j]] +=
          g->parameter[i].factor[j] * (b[i] - g->parameter[i].nominal);
  for (i = 0; i < g->number; ++i) {
    for (j = 0; j < g->parameter[i].n; ++j) {
      k = g->parameter[i].entry[j];
      p = &g->m->parameter[k];
      value = d->p[k];
      wrong = maggi_parameter_wrong(p, value);
      if (!wrong) continue;
      set_nominal(g, d);
      return maggi_data_fail(d, MAGGI_E_VALUE, "%s %s (%g)", p->path, wrong, value);
    }
  }
  return MAGGI_OK;
}

void maggi_design_directions(const maggi_design *g, int first, int n, int ld, double *out)
{
  const design_parameter *q;
  int i, j;

  memset(out, 0, (size_t)g->m->nparameter * (size_t)ld * sizeof *out);
  for (i = 0; i < n; ++i) {
    q = &g->parameter[first + i];
    for (j = 0; j < q->n; ++j) out[(size_t)q->entry[j] * (size_t)ld + (size_t)i] = q->factor[j];
  }
}

void maggi_design_pull(const maggi_design *g, const double *p_bar, double *out)
{
  int i, j;

  for (i = 0; i < g->number; ++i) {
    out[i] = 0.0;
    for (j = 0; j < g->parameter[i].n; ++j)
      out[i] += g->parameter[i].factor[j] * p_bar[g->parameter[i].entry[j]];
  }
}

int maggi_design_number(const maggi_design *design)
{
  return design->number;
}

static const design_parameter *at(const maggi_design *g, int index)
{
  return index >= 0 && index < g->number ? &g->parameter[index] : NULL;
}

const char *maggi_design_name(const maggi_design *design, int index)
{
  const design_parameter *q = at(design, index);

  return q ? q->name : NULL;
}

const char *maggi_design_unit(const maggi_design *design, int index)
{
  const design_parameter *q = at(design, index);

  return q ? q->unit : NULL;
}

double maggi_design_value(const maggi_design *design, int index)
{
  const design_parameter *q = at(design, index);

  return q ? q->nominal : NAN;
}

double maggi_design_lower(const maggi_design *design, int index)
{
  const design_parameter *q = at(design, index);

  return q ? q->lower : NAN;
}

double maggi_design_upper(const maggi_design *design, int index)
{
  const design_parameter *q = at(design, index);

  return q ? q->upper : NAN;
}
