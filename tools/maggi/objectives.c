/* Objectives of the command line. */
#include "objectives.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"
#include "nearest.h"

#define NAME_MAX_LENGTH 512
#define CALL_MAX_LENGTH (2 * NAME_MAX_LENGTH + 8) /* TYPE(SIGNAL) */

/* Nearest to TYPE( for a type, or to SIGNAL) for a signal, written out as TYPE(SIGNAL). */
static void offer_function(nearest *n, const maggi_model *m, const char *name, char *best)
{
  const char *open = strchr(name, '(');
  char type[NAME_MAX_LENGTH], signal[NAME_MAX_LENGTH];
  nearest of_type, of_signal;
  size_t length = strlen(name);
  int i;

  if (!open || name[length - 1] != ')' || length >= NAME_MAX_LENGTH) return;
  snprintf(type, sizeof type, "%.*s", (int)(open - name), name);
  snprintf(signal, sizeof signal, "%.*s", (int)(length - (size_t)(open - name) - 2), open + 1);
  nearest_init(&of_type, type);
  nearest_init(&of_signal, signal);
  for (i = 0; i < MAGGI_OBJECTIVE_TYPE_COUNT; ++i)
    nearest_offer(&of_type, maggi_objective_type_name((maggi_objective_type)i));
  for (i = 0; i < maggi_signal_number(m); ++i) nearest_offer(&of_signal, maggi_signal_name(m, i));
  if (maggi_objective_type_find(type) < 0 && !of_type.best) return;
  if (maggi_signal_find(m, signal) < 0 && !of_signal.best) return;
  snprintf(best, CALL_MAX_LENGTH, "%s(%s)",
           maggi_objective_type_find(type) < 0 ? of_type.best : type,
           maggi_signal_find(m, signal) < 0 ? of_signal.best : signal);
  if (strcmp(best, name) != 0) n->best = best;
}

/* What the library says, and a name that may be meant. */
static int refuse(const maggi_model *m, const char *name, maggi_status status, const char *text)
{
  char best[CALL_MAX_LENGTH];
  nearest n;
  int i;

  if (status == MAGGI_E_MEMORY) return message_fail(STATUS_FAILED, "out of memory");
  nearest_init(&n, name);
  for (i = 0; maggi_model_objective(m, i); ++i) nearest_offer(&n, maggi_model_objective(m, i));
  if (!n.best) offer_function(&n, m, name, best);
  return message_fail(STATUS_USAGE, "--objective: %s%s", text, nearest_hint(&n));
}

int objectives_create(objectives *o, const maggi_model *m, const names *list)
{
  char text[1024];
  maggi_status status;

  o->number = 0;
  o->objective = calloc((size_t)list->number + 1, sizeof *o->objective);
  if (!o->objective) return message_fail(STATUS_FAILED, "out of memory");
  for (; o->number < list->number; ++o->number) {
    text[0] = '\0';
    status = maggi_objective_named(m, list->name[o->number], &o->objective[o->number], text,
                                   sizeof text);
    if (status != MAGGI_OK) return refuse(m, list->name[o->number], status, text);
  }
  return STATUS_DONE;
}

void objectives_free(objectives *o)
{
  while (o->number > 0) maggi_objective_free(o->objective[--o->number]);
  free(o->objective);
  o->objective = NULL;
}
