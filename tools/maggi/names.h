/* A list of names. */
#ifndef TOOL_NAMES_H
#define TOOL_NAMES_H

#include <stddef.h>

typedef struct names {
  char **name;
  int number;
} names;

/* Add the first n characters of text: 0, or -1 without memory. */
int names_add(names *list, const char *text, size_t n);

/* Whether the first n characters of text are one of the names. */
int names_has(const names *list, const char *text, size_t n);

/* Add the names between the commas of `text`, value of an option: exit status, after a message when
 * it is not STATUS_DONE (an empty name, one that is there, no memory). */
int names_split(names *list, const char *option, const char *text);

void names_free(names *list);

#endif
