/* Edit distance: insertions, deletions, substitutions, exchanges of neighbours count one each. */
#include "nearest.h"

#include <stdio.h>
#include <string.h>

#define WORD_MAX 200 /* longer words get no hint */

static size_t smaller(size_t a, size_t b)
{
  return a < b ? a : b;
}

/* Rows i-2, i-1 and i of the table D(i, j): the distance of the first i of a and first j of b. */
static size_t edit_distance(const char *a, const char *b)
{
  size_t row[3][WORD_MAX + 1];
  size_t na = strlen(a), nb = strlen(b), i, j;
  size_t *two = row[0], *one = row[1], *now = row[2], *free_row;

  if (na > WORD_MAX || nb > WORD_MAX) return WORD_MAX;
  for (j = 0; j <= nb; ++j) one[j] = j;
  for (i = 1; i <= na; ++i) {
    now[0] = i;
    for (j = 1; j <= nb; ++j) {
      now[j] = smaller(one[j], now[j - 1]) + 1;
      now[j] = smaller(now[j], one[j - 1] + (a[i - 1] != b[j - 1]));
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        now[j] = smaller(now[j], two[j - 2] + 1);
    }
    free_row = two;
    two = one;
    one = now;
    now = free_row;
  }
  return one[nb];
}

/* "crank.mass" is meant for "bodies.crank.mass". */
static int is_tail(const char *word, const char *candidate)
{
  size_t nword = strlen(word), n = strlen(candidate);

  return nword > 0 && n > nword && candidate[n - nword - 1] == '.' &&
         strcmp(candidate + n - nword, word) == 0;
}

void nearest_init(nearest *n, const char *word)
{
  n->word = word;
  n->best = NULL;
  n->distance = strlen(word) < 6 ? 2 : strlen(word) / 3 + 1; /* a third of the letters, or one */
  n->hint[0] = '\0';
}

void nearest_offer(nearest *n, const char *candidate)
{
  size_t distance;

  if (!candidate) return;
  distance = is_tail(n->word, candidate) ? 1 : edit_distance(n->word, candidate);
  if (distance >= n->distance || distance >= strlen(candidate)) return;
  n->distance = distance;
  n->best = candidate;
}

const char *nearest_hint(nearest *n)
{
  if (n->best) snprintf(n->hint, sizeof n->hint, "; did you mean \"%s\"?", n->best);
  return n->hint;
}
