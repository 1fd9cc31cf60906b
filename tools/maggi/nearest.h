/* The nearest of the known words, to help whoever mistyped one. */
#ifndef TOOL_NEAREST_H
#define TOOL_NEAREST_H

#include <stddef.h>

typedef struct nearest {
  const char *word; /* as typed                                        */
  const char *best; /* nearest candidate so far, or NULL; not owned    */
  size_t distance;  /* its distance; nothing farther is worth a hint   */
  char hint[256];
} nearest;

/* Start with what was typed, then offer every known word (NULL is passed over). */
void nearest_init(nearest *n, const char *word);
void nearest_offer(nearest *n, const char *candidate);

/* `; did you mean "best"?`, or "" when no candidate is near.  Lives in n. */
const char *nearest_hint(nearest *n);

#endif
