/* Centred differences of the plain evaluation. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "data.h"
#include "methods.h"

typedef struct differences {
  const problem *of;
  double *x, *column, *y, *y2;
} differences;

/* cube root of the round-off, half of the distance relative to a number */
static const double relative_step = 6e-6;

static void *open_differences(const problem *of)
{
  differences *m = malloc(sizeof *m);
  size_t nx = (size_t)of->nx, ny = (size_t)of->ny;

  if (!m) return NULL;
  m->of = of;
  m->x = calloc(2 * (nx + ny), sizeof(double));
  if (!m->x) {
    free(m);
    return NULL;
  }
  m->column = m->x + nx;
  m->y = m->column + nx;
  m->y2 = m->y + ny;
  memcpy(m->x, of->x, nx * sizeof(double));
  return m;
}

static void close_differences(void *self)
{
  differences *m = self;

  free(m->x);
  free(m);
}

static void set(const problem *of, const double *x)
{
  maggi_data *d = of->d;
  const maggi_topo *t = &d->t;
  int i, q, n = t->nq;

  for (i = 0; i < n; ++i) {
    q = of->q[i];
    d->q[q] = x[i];
    if (t->col[q] >= 0) d->vcol[t->col[q]] = x[n + i];
  }
  memcpy(d->p, x + 2 * n, (size_t)t->np * sizeof(double));
  maggi_constants(d);
}

static void evaluate(const problem *of, const double *x, double *y)
{
  const maggi_data *d = of->d;
  int i, n = d->t.nq;

  set(of, x);
  maggi_evaluate(of->d, of->time);
  for (i = 0; i < n; ++i) {
    y[i] = d->v[of->q[i]];
    y[n + i] = d->a[of->q[i]];
  }
}

/* yd = (f(x + h xd) - f(x - h xd)) / (2 h) */
static void derive(differences *m, const double *xd, double h, double *yd, int stride)
{
  const problem *of = m->of;
  int i;

  for (i = 0; i < of->nx; ++i) m->x[i] = of->x[i] + h * xd[i];
  evaluate(of, m->x, m->y);
  for (i = 0; i < of->nx; ++i) m->x[i] = of->x[i] - h * xd[i];
  evaluate(of, m->x, m->y2);
  for (i = 0; i < of->ny; ++i) yd[i * stride] = (m->y[i] - m->y2[i]) / (2.0 * h);
}

static void directions(void *self, const double *xd, double *yd)
{
  differences *m = self;
  int i, k;

  for (k = 0; k < DIRECTIONS; ++k) {
    for (i = 0; i < m->of->nx; ++i) m->column[i] = xd[i * DIRECTIONS + k];
    derive(m, m->column, relative_step, yd + k, DIRECTIONS);
  }
  set(m->of, m->of->x);
}

static void direction(void *self, const double *xd, double *yd)
{
  differences *m = self;

  derive(m, xd, relative_step, yd, 1);
  set(m->of, m->of->x);
}

/* whether the input i counts */
static int is_active(const problem *of, int i)
{
  const maggi_topo *t = of->t;
  int n = t->nq, column;

  if (i >= 2 * n) return 1;
  column = t->col[of->q[i % n]];
  return column < t->nind && (i < n || column >= 0);
}

/* one input after the other */
static void gradient(void *self, const double *yb, double *xb)
{
  differences *m = self;
  const problem *of = m->of;
  double h;
  int i, k;

  memcpy(m->x, of->x, (size_t)of->nx * sizeof(double));
  for (i = 0; i < of->nx; ++i) {
    xb[i] = 0.0;
    if (!is_active(of, i)) continue;
    h = relative_step * fmax(1.0, fabs(of->x[i]));
    m->x[i] = of->x[i] + h;
    evaluate(of, m->x, m->y);
    m->x[i] = of->x[i] - h;
    evaluate(of, m->x, m->y2);
    m->x[i] = of->x[i];
    for (k = 0; k < of->ny; ++k) xb[i] += yb[k] * (m->y[k] - m->y2[k]) / (2.0 * h);
  }
  set(m->of, m->of->x);
}

const method method_differences = {"centred differences",
                                   open_differences,
                                   close_differences,
                                   directions,
                                   direction,
                                   gradient,
                                   NULL,
                                   1e-5};
