/* Memory that is freed all at once: strings and small arrays of a builder or a model. */
#ifndef MAGGI_ARENA_H
#define MAGGI_ARENA_H

#include <stddef.h>

typedef struct maggi_arena {
  struct maggi_block *blocks;
} maggi_arena;

void *maggi_arena_alloc(maggi_arena *arena, size_t size); /* zeroed; NULL when out of memory */
char *maggi_arena_text(maggi_arena *arena, const char *text);
double *maggi_arena_numbers(maggi_arena *arena, const double *numbers, int n);
const char **maggi_arena_texts(maggi_arena *arena, const char *const *texts, int n);
char *maggi_arena_format(maggi_arena *arena, const char *format, ...);
void maggi_arena_free(maggi_arena *arena);

#endif
