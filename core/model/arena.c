#include "arena.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct maggi_block {
  struct maggi_block *next;
  max_align_t bytes[];
};

void *maggi_arena_alloc(maggi_arena *arena, size_t size)
{
  struct maggi_block *block;

  block = calloc(1, sizeof *block + size);
  if (!block) return NULL;
  block->next = arena->blocks;
  arena->blocks = block;
  return block->bytes;
}

char *maggi_arena_text(maggi_arena *arena, const char *text)
{
  size_t n = strlen(text) + 1;
  char *copy = maggi_arena_alloc(arena, n);

  if (copy) memcpy(copy, text, n);
  return copy;
}

double *maggi_arena_numbers(maggi_arena *arena, const double *numbers, int n)
{
  double *copy = maggi_arena_alloc(arena, (size_t)n * sizeof *copy);

  if (copy) memcpy(copy, numbers, (size_t)n * sizeof *copy);
  return copy;
}

const char **maggi_arena_texts(maggi_arena *arena, const char *const *texts, int n)
{
  const char **copy = maggi_arena_alloc(arena, (size_t)n * sizeof *copy);
  int i;

  for (i = 0; copy && i < n; ++i) {
    copy[i] = maggi_arena_text(arena, texts[i]);
    if (!copy[i]) return NULL;
  }
  return copy;
}

char *maggi_arena_format(maggi_arena *arena, const char *format, ...)
{
  va_list args;
  int n;
  char *text;

  va_start(args, format);
  n = vsnprintf(NULL, 0, format, args);
  va_end(args);
  if (n < 0) return NULL;
  text = maggi_arena_alloc(arena, (size_t)n + 1);
  if (!text) return NULL;
  va_start(args, format);
  vsnprintf(text, (size_t)n + 1, format, args);
  va_end(args);
  return text;
}

void maggi_arena_free(maggi_arena *arena)
{
  struct maggi_block *block, *next;

  for (block = arena->blocks; block; block = next) {
    next = block->next;
    free(block);
  }
  arena->blocks = NULL;
}
