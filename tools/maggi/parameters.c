/* Design parameters of the command line. */
#include "parameters.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"
#include "nearest.h"
#include "options.h"

#define OPTION "--parameters"

/* A definition, taken apart in a copy of its text. */
typedef struct definition {
  maggi_design_def def;
  char *text;
  const char **path; /* (def.number) */
  double *factor;    /* (def.number) */
} definition;

static int syntax_error(const char *item)
{
  message_fail(STATUS_USAGE,
               OPTION ": \"%s\" is not of the form NAME=[FACTOR*]PATH+..:NOMINAL:LOWER:UPPER:UNIT",
               item);
  return -1;
}

/* Up to the next `mark`, which becomes its end: the rest behind it, or NULL. */
static char *cut(char *text, char mark)
{
  char *end = strchr(text, mark);

  if (end) *end++ = '\0';
  return end;
}

/* A number for `what` of the item, which keeps its default when the text is empty. */
static int read_number(const definition *d, const char *what, const char *text, double *number)
{
  char option[256];

  if (!text || text[0] == '\0') return 0;
  snprintf(option, sizeof option, OPTION " %.100s, %s", d->def.name, what);
  return options_number(option, text, number);
}

/* [FACTOR*]PATH{+[FACTOR*]PATH}.  A + inside a factor, as in 1e+3, does not end a term. */
static int read_terms(definition *d, char *text, const char *item)
{
  char *next, *star, *path;

  for (; text; text = next) {
    path = text;
    d->factor[d->def.number] = 1.0;
    star = strchr("+-.0123456789", text[0]) && text[0] != '\0' ? cut(text, '*') : NULL;
    if (star) {
      if (read_number(d, "factor", text, &d->factor[d->def.number])) return -1;
      path = star;
    }
    next = cut(path, '+');
    if (path[0] == '\0') return syntax_error(item);
    d->path[d->def.number++] = path;
  }
  return 0;
}

/* :NOMINAL:LOWER:UPPER:UNIT, each of which may be empty. */
static int read_tail(definition *d, char *text, const char *item)
{
  char *lower = text ? cut(text, ':') : NULL;
  char *upper = lower ? cut(lower, ':') : NULL;
  char *unit = upper ? cut(upper, ':') : NULL;

  if (lower && !upper) return syntax_error(item);
  if (read_number(d, "nominal", text, &d->def.nominal) ||
      read_number(d, "lower bound", lower, &d->def.lower) ||
      read_number(d, "upper bound", upper, &d->def.upper))
    return -1;
  if (unit && unit[0] != '\0') d->def.unit = unit;
  return 0;
}

static int read_definition(definition *d, const char *item)
{
  size_t n = strlen(item) + 1;
  char *terms, *tail;

  maggi_design_def_init(&d->def);
  d->text = malloc(n);
  d->path = malloc(n * sizeof *d->path);
  d->factor = malloc(n * sizeof *d->factor);
  if (!d->text || !d->path || !d->factor) {
    message_fail(STATUS_FAILED, "out of memory");
    return -1;
  }
  memcpy(d->text, item, n);
  terms = cut(d->text, '=');
  d->def.name = d->text;
  d->def.number = 0;
  d->def.paths = d->path;
  d->def.factors = d->factor;
  if (!terms || d->text[0] == '\0') return syntax_error(item);
  tail = cut(terms, ':');
  return read_terms(d, terms, item) || read_tail(d, tail, item) ? -1 : 0;
}

static void definition_free(definition *d)
{
  free(d->text);
  free(d->path);
  free(d->factor);
}

static void offer_all(nearest *n, const maggi_model *m)
{
  int i;

  nearest_offer(n, "all");
  for (i = 0; maggi_model_design(m, i); ++i) nearest_offer(n, maggi_model_design(m, i));
  for (i = 0; maggi_parameter_path(m, i); ++i) nearest_offer(n, maggi_parameter_path(m, i));
}

static int refuse(const maggi_model *m, const char *word, maggi_status status, const char *text)
{
  nearest n;

  if (status == MAGGI_E_MEMORY) return message_fail(STATUS_FAILED, "out of memory");
  nearest_init(&n, word);
  if (status == MAGGI_E_NAME && !strpbrk(word, "*?[")) offer_all(&n, m);
  if (n.best && strcmp(n.best, word) == 0) n.best = NULL; /* there already */
  return message_fail(STATUS_USAGE, OPTION ": %s%s", text, nearest_hint(&n));
}

/* The path of a definition that the model does not have, for the hint. */
static const char *unknown_path(const definition *d, const maggi_model *m)
{
  int i;

  for (i = 0; i < d->def.number; ++i)
    if (maggi_parameter_find(m, d->path[i]) < 0) return d->path[i];
  return d->def.name;
}

static int add_definition(maggi_design *design, const maggi_model *m, const char *item)
{
  char text[1024] = "";
  definition d;
  maggi_status status;
  int exit_status = STATUS_USAGE;

  memset(&d, 0, sizeof d);
  if (read_definition(&d, item) == 0) {
    status = maggi_design_add(design, &d.def, text, sizeof text);
    exit_status = status == MAGGI_OK ? STATUS_DONE : refuse(m, unknown_path(&d, m), status, text);
  }
  definition_free(&d);
  return exit_status;
}

/* An item, or the name of a parameter. */
static int add_item(maggi_design *design, const maggi_model *m, const char *item)
{
  char text[1024] = "";
  maggi_status status;

  if (strchr(item, '=')) return add_definition(design, m, item);
  status = maggi_design_select(design, item, text, sizeof text);
  return status == MAGGI_OK ? STATUS_DONE : refuse(m, item, status, text);
}

int parameters_create(parameters *p, const maggi_model *m, const maggi_data *d, const names *list)
{
  const char **grown;
  int i, n, status;

  p->model = m;
  if (maggi_design_create(d, &p->design) != MAGGI_OK)
    return message_fail(STATUS_FAILED, "out of memory");
  for (i = 0; i < list->number; ++i) {
    status = add_item(p->design, m, list->name[i]);
    if (status != STATUS_DONE) return status;
    n = maggi_design_number(p->design);
    grown = realloc(p->item, ((size_t)n + 1) * sizeof *grown);
    if (!grown) return message_fail(STATUS_FAILED, "out of memory");
    p->item = grown;
    for (; p->number < n; ++p->number)
      p->item[p->number] = strchr(list->name[i], '=') ? list->name[i] : NULL;
  }
  return STATUS_DONE;
}

void parameters_free(parameters *p)
{
  maggi_design_free(p->design);
  free(p->item);
}

int parameters_pick(const parameters *p, const maggi_data *d, int n, const int *index,
                    maggi_design **design)
{
  const char *item;
  int i, status = STATUS_DONE;

  if (maggi_design_create(d, design) != MAGGI_OK)
    return message_fail(STATUS_FAILED, "out of memory");
  for (i = 0; i < n && status == STATUS_DONE; ++i) {
    item = p->item[index[i]];
    status = add_item(*design, p->model, item ? item : maggi_design_name(p->design, index[i]));
  }
  return status;
}
