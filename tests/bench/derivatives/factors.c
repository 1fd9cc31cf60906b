/* Dense factors against KLU, both of factor.c at any size: the matrix of Newton's method factorised again and one
 * system solved, as an iteration does. */
#define maggi_factor_create           library_create
#define maggi_factor_free             library_free
#define maggi_factor_compute          library_compute
#define maggi_factor_solve            library_solve
#define maggi_factor_solve_transposed library_solve_transposed
#include "../../../core/implicit/factor.c"

#include <stdio.h>

#include "cases.h"
#include "simulation.h"
#include "suites.h"
#include "table.h"
#include "timing.h"

#ifdef MAGGI_WITH_KLU
static const double h = 1e-3;
static const double sample_seconds = 2e-4;
enum { SHIPPED_MOST = 27 };
static const int columns[] = {1, 2, 4, 7}, rows[] = {1, 2, 3, 4, 6, 8, 10, 12, 15};
enum { NCOLUMN = sizeof columns / sizeof columns[0], NROW = sizeof rows / sizeof rows[0] };

typedef struct pair {
  char name[CASE_NAME];
  int n, nonzeros;
  double flops; /* estimate of KLU, over those of dense factors */
  series dense; /* seconds, and ratio to KLU */
  series klu;   /* seconds */
} pair;

static maggi_factor *create_pair(const maggi_sparsity *a, int is_dense)
{
  maggi_factor *f = calloc(1, sizeof *f);
  size_t n = (size_t)a->ncol;

  if (!f) return NULL;
  f->a = a;
  f->n = a->ncol;
  if (is_dense) {
    f->dense = malloc(n * n * sizeof(double) + 1);
    f->pivot = malloc(n * sizeof(int) + 1);
  }
  if (is_dense ? f->dense && f->pivot : analyse(f)) return f;
  library_free(f);
  return NULL;
}

static double seconds_of(maggi_factor *f, const double *value, double *x, int n)
{
  double begin = cpu_seconds();
  int i, k;

  for (i = 0; i < n; ++i) {
    for (k = 0; k < f->n; ++k) x[k] = 1.0;
    library_compute(f, value);
    library_solve(f, 1, x);
  }
  return (cpu_seconds() - begin) / n;
}

static void time_pair(pair *p, maggi_factor *dense, maggi_factor *klu, const double *value,
                      double *x, int rounds)
{
  double one;
  int i, n = 1;

  while (n * seconds_of(klu, value, x, n) < sample_seconds) n *= 2;
  for (i = 0; i < rounds; ++i) {
    series_add(&p->klu, seconds_of(klu, value, x, n), 1.0);
    one = seconds_of(dense, value, x, n);
    series_add(&p->dense, one, one / p->klu.value[i]);
  }
  series_end(&p->klu);
  series_end(&p->dense);
}

/* after one step; models that the penalty formulation does not move are left out */
static int measure(pair *p, const char *name, int rounds)
{
  bench_case c;
  simulation x;
  course one;
  maggi_tangent_matrix *m;
  maggi_factor *dense, *klu;

  memset(p, 0, sizeof *p);
  if (!case_open(&c, name)) return 0;
  snprintf(p->name, sizeof p->name, "%s", name);
  if (simulation_open(&x, &ways[reference], c.m, NULL) && simulation_coordinates(&x) > 0 &&
      simulation_run(&x, h, 1, &one)) {
    m = x.s->matrix;
    p->n = simulation_coordinates(&x);
    p->nonzeros = m->places.coladr[p->n];
    dense = create_pair(&m->places, 1);
    klu = create_pair(&m->places, 0);
    if (dense && klu) {
      time_pair(p, dense, klu, m->newton, x.s->x, rounds);
      p->flops = klu->symbolic->est_flops / (2.0 / 3.0 * p->n * p->n * p->n);
    }
    if (dense) library_free(dense);
    if (klu) library_free(klu);
  }
  simulation_close(&x);
  case_close(&c);
  return p->klu.n > 0;
}

static int by_size(const void *a, const void *b)
{
  const pair *x = a, *y = b;

  return (x->n > y->n) - (x->n < y->n);
}

static void print_pairs(const options *o, int n, const pair pairs[])
{
  static table t;
  const pair *p;
  int i;

  table_begin(&t, "model|n|nonzeros|% full|% flops|dense us|KLU us|dense / KLU|+- %");
  for (i = 0; i < n; ++i) {
    p = &pairs[i];
    table_row(&t);
    table_cell(&t, "%s", p->name);
    table_cell(&t, "%d", p->n);
    table_cell(&t, "%d", p->nonzeros);
    table_cell(&t, "%.0f", 100.0 * p->nonzeros / ((double)p->n * p->n));
    table_cell(&t, "%.0f", 100.0 * p->flops);
    table_cell(&t, "%.3f", 1e6 * series_value(&p->dense, 0.5));
    table_cell(&t, "%.3f", 1e6 * series_value(&p->klu, 0.5));
    table_cell(&t, "%.2f", series_ratio(&p->dense, 0.5));
    table_cell(&t, "%.0f", series_spread(&p->dense));
    if (o->csv)
      fprintf(o->csv, "factor,%s,,%d,%d,%g,,,,,,,,,,,,,,,,,,,,,,,,,,,%.9g,%.9g\n", p->name, p->n,
              p->nonzeros, h, 1e6 * series_value(&p->dense, 0.5), 1e6 * series_value(&p->klu, 0.5));
  }
  printf("%sfactors and one solution, dense against KLU (factor.c takes dense ones up to %d "
         "unknowns, and "
         "where KLU has more than %.0f %% of their operations)\n\n",
         o->markdown ? "## " : "", DENSE_UNKNOWNS, 100.0 * DENSE_SHARE);
  table_print(&t, o->markdown);
}

/* arrays of four-bars and the models that are shipped */
int run_factor(const options *o)
{
  static pair pairs[NCOLUMN * NROW + SHIPPED_MOST];
  static char shipped[SHIPPED_MOST][CASE_NAME];
  char name[CASE_NAME];
  int i, k, n = 0, models = shipped_models(SHIPPED_MOST, shipped);

  for (i = 0; i < NCOLUMN; ++i) {
    for (k = 0; k < NROW; ++k) {
      snprintf(name, sizeof name, "multiple-four-bar:%dx%d", columns[i], rows[k]);
      n += measure(&pairs[n], name, o->rounds);
    }
  }
  for (i = 0; i < models; ++i) n += measure(&pairs[n], shipped[i], o->rounds);
  qsort(pairs, (size_t)n, sizeof *pairs, by_size);
  print_pairs(o, n, pairs);
  return n == 0;
}
#else
int run_factor(const options *o)
{
  printf("%sKLU is not here: apt-get install libsuitesparse-dev, and configure again\n\n",
         o->markdown ? "- " : "");
  return 0;
}
#endif
