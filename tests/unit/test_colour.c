/* core/implicit/colour.c: the numbers of [1] table 4.4; colourings of random matrices are valid,
 * hold each column once and give back every entry; the fewest colours of small ones by trying all;
 * graphs on which one order is good and another is not.
 */
#include "colour.h"
#include "fixture.h"
#include "model.h"
#include "pattern.h"

enum { ROWS = 40, COLUMNS = 60 };

typedef struct matrix {
  int coladr[COLUMNS + 1], row[ROWS * COLUMNS];
  maggi_sparsity a;
} matrix;

static void random_matrix(matrix *m, int nrow, int ncol, double density, unsigned long long *seed)
{
  int i, j, n = 0;

  for (j = 0; j < ncol; ++j) {
    m->coladr[j] = n;
    for (i = 0; i < nrow; ++i)
      if (random01(seed) < density) m->row[n++] = i;
  }
  m->coladr[ncol] = n;
  m->a = (maggi_sparsity){nrow, ncol, m->coladr, m->row};
}

/* whether two columns have a row in common */
static int meet(const maggi_sparsity *a, int i, int j)
{
  int k = a->coladr[i], l = a->coladr[j];

  while (k < a->coladr[i + 1] && l < a->coladr[j + 1]) {
    if (a->row[k] == a->row[l]) return 1;
    if (a->row[k] < a->row[l])
      ++k;
    else
      ++l;
  }
  return 0;
}

static maggi_colouring *colour(const maggi_sparsity *a, maggi_colour_order order)
{
  maggi_colouring *c;

  if (!CHECK(maggi_colouring_create(a, order, &c) == MAGGI_OK)) exit(1);
  return c;
}

static int colours(const maggi_sparsity *a, maggi_colour_order order)
{
  maggi_colouring *c = colour(a, order);
  int n = c->ncolour;

  maggi_colouring_free(c);
  return n;
}

/* ------------------------------------------------------------------------------------- numbers */

static void check_numbers(maggi_model *m, int least)
{
  maggi_pattern *p;
  int order;

  if (!CHECK(maggi_pattern_create(&m->topo, &p) == MAGGI_OK)) exit(1);
  for (order = 0; order <= MAGGI_COLOUR_BEST; ++order)
    CHECK(colours(&p->J, (maggi_colour_order)order) == least);
  maggi_pattern_free(p);
  maggi_model_free(m);
}

static void test_numbers(void)
{
  static const int ny[] = {1, 4, 7, 20, 60};
  char message[512] = "";
  maggi_model *m;
  int i;

  if (!CHECK(maggi_model_load(MAGGI_MODELS_DIR "/spatial-four-bar.yaml", &m, message,
                              sizeof message) == MAGGI_OK))
    exit(1);
  check_numbers(m, 6);
  for (i = 0; i < (int)(sizeof ny / sizeof *ny); ++i) {
    if (!CHECK(maggi_model_multiple_four_bar(ny[i], 15, &m) == MAGGI_OK)) exit(1);
    check_numbers(m, 60);
  }
}

/* ------------------------------------------------------------------------- validity, recovery */

static void check_valid(const maggi_sparsity *a, const maggi_colouring *c)
{
  int i, j, k, ok = 1, n = 0;

  for (i = 0; i < a->ncol; ++i) {
    ok = ok && c->colour[i] >= 0 && c->colour[i] < c->ncolour;
    for (j = 0; j < i; ++j) ok = ok && (c->colour[i] != c->colour[j] || !meet(a, i, j));
  }
  CHECK(ok);
  ok = c->colouradr[0] == 0 && c->colouradr[c->ncolour] == a->ncol;
  for (i = 0; i < c->ncolour && ok; ++i) {
    ok = c->colouradr[i] < c->colouradr[i + 1];
    for (k = c->colouradr[i]; k < c->colouradr[i + 1]; ++k, ++n)
      ok = ok && c->colour[c->column[k]] == i &&
           (k == c->colouradr[i] || c->column[k] > c->column[k - 1]);
  }
  CHECK(ok && n == a->ncol);
}

/* products with the sums of columns, so many colours at a time */
static void check_recovery(const maggi_sparsity *a, const maggi_colouring *c, int width,
                           unsigned long long *seed)
{
  static double value[ROWS * COLUMNS], found[ROWS * COLUMNS], B[ROWS * COLUMNS];
  int begin, end, i, k, n, j;

  for (k = 0; k < a->coladr[a->ncol]; ++k) {
    value[k] = random11(seed);
    found[k] = NAN;
  }
  for (begin = 0; begin < c->ncolour; begin = end) {
    end = begin + width < c->ncolour ? begin + width : c->ncolour;
    n = end - begin;
    for (i = 0; i < a->nrow * n; ++i) B[i] = 0.0;
    for (j = 0; j < a->ncol; ++j) {
      if (c->colour[j] < begin || c->colour[j] >= end) continue;
      for (k = a->coladr[j]; k < a->coladr[j + 1]; ++k)
        B[a->row[k] * n + c->colour[j] - begin] += value[k];
    }
    maggi_colour_recover(a, c, begin, end, B, found);
  }
  CHECK(memcmp(value, found, (size_t)a->coladr[a->ncol] * sizeof *value) == 0);
}

static void test_random(void)
{
  static matrix m;
  unsigned long long seed = 3;
  maggi_colouring *c;
  int i, order, least, n = 0, fewer = 0;

  for (i = 0; i < 400; ++i) {
    random_matrix(&m, 1 + i % ROWS, 1 + i * 7 % COLUMNS, 0.3 * random01(&seed), &seed);
    least = COLUMNS + 1;
    for (order = 0; order <= MAGGI_COLOUR_BEST; ++order) {
      c = colour(&m.a, (maggi_colour_order)order);
      n = c->ncolour;
      check_valid(&m.a, c);
      check_recovery(&m.a, c, i % 2 ? 8 : COLUMNS, &seed);
      maggi_colouring_free(c);
      if (order < MAGGI_COLOUR_BEST && n < least) least = n;
    }
    CHECK(n <= least);
    fewer += n < least;
  }
  CHECK(fewer > 10); /* by colouring again */
}

/* ----------------------------------------------------------------------------- fewest of all */

/* whether columns from j on can be coloured with n colours, so many of which are used before */
static int can_colour(const maggi_sparsity *a, int j, int n, int used, int *colour)
{
  int i, k;

  if (j == a->ncol) return 1;
  for (k = 0; k < n && k <= used; ++k) {
    for (i = 0; i < j && (colour[i] != k || !meet(a, i, j)); ++i)
      ;
    if (i < j) continue;
    colour[j] = k;
    if (can_colour(a, j + 1, n, k == used ? used + 1 : used, colour)) return 1;
  }
  return 0;
}

static int fewest(const maggi_sparsity *a)
{
  int colour[COLUMNS], n = 0;

  while (!can_colour(a, 0, n, 0, colour)) ++n;
  return n;
}

static void test_fewest(void)
{
  static matrix m;
  unsigned long long seed = 11;
  int i, n, worse = 0;

  for (i = 0; i < 3000; ++i) {
    random_matrix(&m, 1 + i % 14, i / 7 % 11, 0.1 + 0.4 * random01(&seed), &seed);
    n = fewest(&m.a);
    CHECK(colours(&m.a, MAGGI_COLOUR_BEST) == n);
    worse += colours(&m.a, MAGGI_COLOUR_NATURAL) > n;
  }
  CHECK(worse > 50); /* it is not always easy */
}

/* ------------------------------------------------------------------------------------- orders */

/* a matrix with a row for each pair of columns that are to meet */
static void matrix_of_graph(matrix *m, int ncol, int npair, const int pair[][2])
{
  int j, k, n = 0;

  for (j = 0; j < ncol; ++j) {
    m->coladr[j] = n;
    for (k = 0; k < npair; ++k)
      if (pair[k][0] == j || pair[k][1] == j) m->row[n++] = k;
  }
  m->coladr[ncol] = n;
  m->a = (maggi_sparsity){npair, ncol, m->coladr, m->row};
}

static void check_orders(const matrix *m, int natural, int largest, int smallest, int incidence)
{
  CHECK(colours(&m->a, MAGGI_COLOUR_NATURAL) == natural);
  CHECK(colours(&m->a, MAGGI_COLOUR_LARGEST_FIRST) == largest);
  CHECK(colours(&m->a, MAGGI_COLOUR_SMALLEST_LAST) == smallest);
  CHECK(colours(&m->a, MAGGI_COLOUR_INCIDENCE_DEGREE) == incidence);
}

static void test_orders(void)
{
  static const int path[][2] = {{0, 2}, {2, 3}, {3, 1}};
  static matrix m;
  int crown[20][2], i, j, n = 0;

  /* its ends first, then the middle needs a third colour */
  matrix_of_graph(&m, 4, 3, path);
  check_orders(&m, 3, 2, 2, 2);
  /* crown: two sets of five, each column meets all of the other set but its partner, which in the
   * natural order comes next to it and takes its colour; all have as many neighbours */
  for (i = 0; i < 5; ++i) {
    for (j = 0; j < 5; ++j) {
      if (i == j) continue;
      crown[n][0] = 2 * i;
      crown[n++][1] = 2 * j + 1;
    }
  }
  matrix_of_graph(&m, 10, n, (const int(*)[2])crown);
  check_orders(&m, 5, 5, 2, 2);
}

/* trees take two colours when each column meets at most one before it, as in these two orders */
static void test_trees(void)
{
  static matrix m;
  unsigned long long seed = 5;
  int edge[ROWS - 1][2], name[ROWS], i, j, k, x, worse = 0;

  for (i = 0; i < 200; ++i) {
    for (j = 0; j < ROWS; ++j) {
      k = (int)((j + 1) * random01(&seed));
      name[j] = name[k];
      name[k] = j;
    }
    for (j = 1; j < ROWS; ++j) {
      x = (int)(j * random01(&seed));
      edge[j - 1][0] = name[j];
      edge[j - 1][1] = name[x];
    }
    matrix_of_graph(&m, ROWS, ROWS - 1, (const int(*)[2])edge);
    CHECK(colours(&m.a, MAGGI_COLOUR_SMALLEST_LAST) == 2);
    CHECK(colours(&m.a, MAGGI_COLOUR_INCIDENCE_DEGREE) == 2);
    worse += colours(&m.a, MAGGI_COLOUR_NATURAL) > 2;
  }
  CHECK(worse > 100);
}

static void test_empty(void)
{
  static matrix m;
  unsigned long long seed = 1;
  maggi_colouring *c;

  random_matrix(&m, 5, 0, 0.5, &seed);
  CHECK(colours(&m.a, MAGGI_COLOUR_BEST) == 0);
  random_matrix(&m, 0, 4, 0.5, &seed);
  CHECK(colours(&m.a, MAGGI_COLOUR_BEST) == 1);
  random_matrix(&m, 4, 6, 2.0, &seed);
  c = colour(&m.a, MAGGI_COLOUR_BEST);
  CHECK(c->ncolour == 6);
  check_valid(&m.a, c);
  maggi_colouring_free(c);
}

int main(void)
{
  test_numbers();
  test_random();
  test_fewest();
  test_orders();
  test_trees();
  test_empty();
  return check_done();
}
