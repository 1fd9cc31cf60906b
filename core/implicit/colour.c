/* Neighbours are not kept: those of a column are the other columns of its rows, found again. */
#include "colour.h"

#include <stdlib.h>
#include <string.h>

/* rounds of colouring again that save nothing before it is given up */
enum { ROUNDS = 100 };

typedef struct colourer {
  const maggi_sparsity *a;
  maggi_sparsity rows;        /* its transpose */
  int most;                   /* the largest number of neighbours */
  int *degree;                /* (ncol) number of neighbours */
  int *order;                 /* (ncol) in which columns are coloured */
  int *colour, *best;         /* (ncol) */
  int *near;                  /* (ncol) neighbours of one column */
  int *seen, *used;           /* (ncol) last column that met a column, a colour */
  int *key, *next, *previous; /* (ncol) lists of the columns that have the same key */
  int *head;                  /* (ncol + 2) first one with a key, -1: none; also work of sort */
  unsigned random;
} colourer;

/* in one piece; false when out of memory */
static int colourer_create(colourer *c, const maggi_sparsity *a)
{
  size_t n = (size_t)a->ncol, size = 11 * n + (size_t)a->nrow + 3 + (size_t)a->coladr[n];
  int *v = malloc(size * sizeof *v);
  int **lists[] = {&c->degree, &c->order, &c->colour, &c->best,     &c->near, &c->seen,
                   &c->used,   &c->key,   &c->next,   &c->previous, &c->head};
  size_t i;

  if (!v) return 0;
  for (i = 0; i < sizeof lists / sizeof *lists; ++i) *lists[i] = v + i * n;
  c->rows.coladr = c->head + n + 2;
  c->rows.row = c->rows.coladr + a->nrow + 1;
  c->a = a;
  c->random = 1;
  maggi_sparsity_transpose(a, &c->rows);
  return 1;
}

static void fill(int *v, int n, int value)
{
  int i;

  for (i = 0; i < n; ++i) v[i] = value;
}

/* 0 .. n - 1 by rising key < nkey, and where those of a key begin: adr (nkey + 1) */
static void sort(int n, const int *key, int nkey, int *adr, int *sorted)
{
  int i;

  fill(adr, nkey + 1, 0);
  for (i = 0; i < n; ++i) ++adr[key[i]];
  for (i = 0; i < nkey; ++i) adr[i + 1] += adr[i];
  for (i = n - 1; i >= 0; --i) sorted[--adr[key[i]]] = i;
}

/* fills near, returns how many; once a column after seen was reset */
static int neighbours(colourer *c, int column)
{
  const maggi_sparsity *a = c->a, *rows = &c->rows;
  int i, k, other, n = 0;

  c->seen[column] = column;
  for (i = a->coladr[column]; i < a->coladr[column + 1]; ++i) {
    for (k = rows->coladr[a->row[i]]; k < rows->coladr[a->row[i] + 1]; ++k) {
      other = rows->row[k];
      if (c->seen[other] == column) continue;
      c->seen[other] = column;
      c->near[n++] = other;
    }
  }
  return n;
}

static void count_neighbours(colourer *c)
{
  int j;

  c->most = 0;
  fill(c->seen, c->a->ncol, -1);
  for (j = 0; j < c->a->ncol; ++j) {
    c->degree[j] = neighbours(c, j);
    if (c->degree[j] > c->most) c->most = c->degree[j];
  }
}

static int longest_row(const colourer *c)
{
  int i, n, longest = 0;

  for (i = 0; i < c->rows.ncol; ++i) {
    n = c->rows.coladr[i + 1] - c->rows.coladr[i];
    if (n > longest) longest = n;
  }
  return longest;
}

/* --------------------------------------------------------------------------------------- orders */

static void insert(colourer *c, int j)
{
  int first = c->head[c->key[j]];

  c->next[j] = first;
  c->previous[j] = -1;
  if (first >= 0) c->previous[first] = j;
  c->head[c->key[j]] = j;
}

static void withdraw(colourer *c, int j)
{
  if (c->previous[j] >= 0)
    c->next[c->previous[j]] = c->next[j];
  else
    c->head[c->key[j]] = c->next[j];
  if (c->next[j] >= 0) c->previous[c->next[j]] = c->previous[j];
}

/* One column after the other, always one with the smallest key; each lowers those of its neighbours
 * that are left by one.  From `at` on into order, by steps of 1 or -1. */
static void peel(colourer *c, int at, int step)
{
  int ncol = c->a->ncol, i, j, k, n, least = 0;

  fill(c->head, c->most + 1, -1);
  fill(c->seen, ncol, -1);
  for (i = ncol - 1; i >= 0; --i) insert(c, c->order[i]);
  for (i = 0; i < ncol; ++i) {
    while (c->head[least] < 0) ++least;
    j = c->head[least];
    withdraw(c, j);
    c->key[j] = -1;
    c->order[at] = j;
    at += step;
    n = neighbours(c, j);
    for (k = 0; k < n; ++k) {
      if (c->key[c->near[k]] < 0) continue;
      withdraw(c, c->near[k]);
      --c->key[c->near[k]];
      insert(c, c->near[k]);
    }
    if (least > 0) --least;
  }
}

static void find_order(colourer *c, maggi_colour_order order)
{
  int ncol = c->a->ncol, j;

  for (j = 0; j < ncol; ++j) {
    c->order[j] = j;
    c->key[j] = c->most - c->degree[j];
  }
  if (order == MAGGI_COLOUR_NATURAL) return;
  sort(ncol, c->key, c->most + 1, c->head, c->order);
  if (order == MAGGI_COLOUR_SMALLEST_LAST) {
    memcpy(c->key, c->degree, (size_t)ncol * sizeof *c->key);
    peel(c, ncol - 1, -1);
  } else if (order == MAGGI_COLOUR_INCIDENCE_DEGREE) {
    fill(c->key, ncol, c->most); /* less the neighbours before it */
    peel(c, 0, 1);
  }
}

/* ------------------------------------------------------------------------------------ colouring */

/* in the order found; returns the number of colours */
static int greedy(colourer *c)
{
  int ncol = c->a->ncol, ncolour = 0, i, j, k, n, colour;

  fill(c->colour, ncol, -1);
  fill(c->seen, ncol, -1);
  fill(c->used, ncol, -1);
  for (i = 0; i < ncol; ++i) {
    j = c->order[i];
    n = neighbours(c, j);
    for (k = 0; k < n; ++k)
      if (c->colour[c->near[k]] >= 0) c->used[c->colour[c->near[k]]] = j;
    for (colour = 0; c->used[colour] == j; ++colour)
      ;
    c->colour[j] = colour;
    if (colour >= ncolour) ncolour = colour + 1;
  }
  return ncolour;
}

/* a random permutation of 0 .. n - 1, the same in each run */
static void shuffle(colourer *c, int n, int *v)
{
  int i, k;

  for (i = 0; i < n; ++i) {
    c->random = c->random * 1664525u + 1013904223u;
    k = (int)((c->random >> 8) % (unsigned)(i + 1));
    v[i] = v[k];
    v[k] = i;
  }
}

/* Columns of one colour after those of another: each can at least keep the colour that it had, by
 * whatever name.  The last colours first, or at random. */
static int colour_again(colourer *c, int ncolour, int at_random)
{
  int ncol = c->a->ncol, j;

  if (at_random)
    shuffle(c, ncolour, c->used);
  else
    for (j = 0; j < ncolour; ++j) c->used[j] = ncolour - 1 - j;
  for (j = 0; j < ncol; ++j) c->key[j] = c->used[c->colour[j]];
  sort(ncol, c->key, ncolour, c->head, c->order);
  return greedy(c);
}

static int colour_by(colourer *c, maggi_colour_order order, int bound, int rounds)
{
  int least, n, round;

  find_order(c, order);
  least = greedy(c);
  for (round = 0; round < rounds && least > bound; ++round) {
    n = colour_again(c, least, round % 2);
    if (n < least) round = 0;
    least = n;
  }
  return least;
}

/* with rounds only when no order finds the fewest possible */
static int colour_best(colourer *c)
{
  size_t size = (size_t)c->a->ncol * sizeof(int);
  int bound = longest_row(c), least = c->a->ncol + 1, n, order, rounds;

  for (rounds = 0; rounds <= ROUNDS; rounds += ROUNDS) {
    for (order = 0; order < MAGGI_COLOUR_BEST && least > bound; ++order) {
      n = colour_by(c, (maggi_colour_order)order, bound, rounds);
      if (n >= least) continue;
      least = n;
      memcpy(c->best, c->colour, size);
    }
  }
  memcpy(c->colour, c->best, size);
  return least;
}

maggi_status maggi_colouring_create(const maggi_sparsity *a, maggi_colour_order order,
                                    maggi_colouring **colouring)
{
  size_t size = 3 * (size_t)a->ncol + 1;
  maggi_colouring *p = malloc(sizeof *p + size * sizeof(int));
  colourer c;

  *colouring = NULL;
  if (!p || !colourer_create(&c, a)) {
    free(p);
    return MAGGI_E_MEMORY;
  }
  p->colour = (int *)(p + 1);
  p->column = p->colour + a->ncol;
  p->colouradr = p->column + a->ncol;
  count_neighbours(&c);
  p->ncolour = order == MAGGI_COLOUR_BEST ? colour_best(&c) : colour_by(&c, order, 0, 0);
  memcpy(p->colour, c.colour, (size_t)a->ncol * sizeof(int));
  sort(a->ncol, p->colour, p->ncolour, p->colouradr, p->column);
  free(c.degree); /* all of its lists */
  *colouring = p;
  return MAGGI_OK;
}

void maggi_colouring_free(maggi_colouring *colouring)
{
  free(colouring);
}

void maggi_colour_recover(const maggi_sparsity *a, const maggi_colouring *c, int begin, int end,
                          const double *B, double *value)
{
  int i, k, colour;

  for (colour = begin; colour < end; ++colour)
    for (i = c->colouradr[colour]; i < c->colouradr[colour + 1]; ++i)
      for (k = a->coladr[c->column[i]]; k < a->coladr[c->column[i] + 1]; ++k)
        value[k] = B[a->row[k] * (end - begin) + colour - begin];
}
