/* Lists of names. */
#include "names.h"

#include <stdlib.h>
#include <string.h>

#include "message.h"

int names_add(names *list, const char *text, size_t n)
{
  char **grown, *copy;

  grown = realloc(list->name, ((size_t)list->number + 1) * sizeof *grown);
  if (!grown) return -1;
  list->name = grown;
  copy = malloc(n + 1);
  if (!copy) return -1;
  memcpy(copy, text, n);
  copy[n] = '\0';
  list->name[list->number++] = copy;
  return 0;
}

int names_has(const names *list, const char *text, size_t n)
{
  int i;

  for (i = 0; i < list->number; ++i)
    if (strlen(list->name[i]) == n && memcmp(list->name[i], text, n) == 0) return 1;
  return 0;
}

int names_split(names *list, const char *option, const char *text)
{
  size_t n;

  for (;; text += n + 1) {
    n = strcspn(text, ",");
    if (n == 0) return message_fail(STATUS_USAGE, "%s: an empty name in the list", option);
    if (names_has(list, text, n))
      return message_fail(STATUS_USAGE, "%s: %.*s is named twice", option, (int)n, text);
    if (names_add(list, text, n)) return message_fail(STATUS_FAILED, "out of memory");
    if (text[n] == '\0') return STATUS_DONE;
  }
}

void names_free(names *list)
{
  int i;

  for (i = 0; i < list->number; ++i) free(list->name[i]);
  free(list->name);
  memset(list, 0, sizeof *list);
}
