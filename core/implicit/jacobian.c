/* J = [dQ/dz dQ/dz'] by differences, tangents or adjoints.  A direction is a sum of columns, which
 * are those of one colour, or a single one. */
#include "jacobian.h"

#include <stdlib.h>
#include <string.h>

#include "chain.h"

enum { W = MAGGI_NDIR };

static const char *const words[] = {"difference", "difference-coloured", "tangent",
                                    "tangent-coloured", "adjoint"};

const char *maggi_jacobian_name(maggi_jacobian way)
{
  return (int)way >= 0 && way < MAGGI_JACOBIAN_COUNT ? words[way] : NULL;
}

int maggi_jacobian_find(const char *name)
{
  int i;

  for (i = 0; i < MAGGI_JACOBIAN_COUNT; ++i)
    if (strcmp(words[i], name) == 0) return i;
  return -1;
}

static int is_coloured(maggi_jacobian way)
{
  return way == MAGGI_JACOBIAN_DIFFERENCE_COLOURED || way == MAGGI_JACOBIAN_TANGENT_COLOURED;
}

static int is_difference(maggi_jacobian way)
{
  return way == MAGGI_JACOBIAN_DIFFERENCE || way == MAGGI_JACOBIAN_DIFFERENCE_COLOURED;
}

/* ---------------------------------------------------------------------------------- directions */

static int directions(const maggi_force_jacobian *j)
{
  return j->colouring ? j->colouring->ncolour : j->pattern->J.ncol;
}

/* columns of direction k */
static const int *columns_of(const maggi_force_jacobian *j, const int *k, int *n)
{
  const maggi_colouring *c = j->colouring;

  *n = c ? c->colouradr[*k + 1] - c->colouradr[*k] : 1;
  return c ? c->column + c->colouradr[*k] : k;
}

/* entries of the columns of directions begin .. end - 1 from products (n x (end - begin)) */
static void recover(maggi_force_jacobian *j, int begin, int end)
{
  const maggi_sparsity *a = &j->pattern->J;
  int c, k;

  if (j->colouring) {
    maggi_colour_recover(a, j->colouring, begin, end, j->product, j->value);
    return;
  }
  for (c = begin; c < end; ++c)
    for (k = a->coladr[c]; k < a->coladr[c + 1]; ++k)
      j->value[k] = j->product[a->row[k] * (end - begin) + c - begin];
}

/* ---------------------------------------------------------------------------------- differences */

/* the coordinates and velocities of the columns of a direction, moved by `step` */
static void move(maggi_force_jacobian *j, const int *column, int n, double step)
{
  maggi_data *d = j->d;
  int i, c;

  for (i = 0; i < n; ++i) {
    c = column[i];
    if (c < j->pattern->n)
      d->q[j->pattern->q[c]] += step;
    else
      d->v[j->pattern->q[c - j->pattern->n]] += step;
  }
}

static void by_differences(maggi_force_jacobian *j, double time)
{
  static const double step = 6.0554544523933395e-06; /* cube root of the round-off */
  maggi_data *d = j->d;
  size_t bytes = (size_t)d->t.nq * sizeof(double);
  double *q = j->product + j->pattern->n, *v = q + d->t.nq;
  const int *column;
  int k, i, n;

  memcpy(q, d->q, bytes);
  memcpy(v, d->v, bytes);
  for (k = 0; k < directions(j); ++k) {
    column = columns_of(j, &k, &n);
    move(j, column, n, step);
    maggi_chain_forces(d, time);
    for (i = 0; i < j->pattern->n; ++i) j->ahead[i] = d->w[j->pattern->q[i]];
    memcpy(d->q, q, bytes);
    memcpy(d->v, v, bytes);
    move(j, column, n, -step);
    maggi_chain_forces(d, time);
    for (i = 0; i < j->pattern->n; ++i)
      j->product[i] = (j->ahead[i] - d->w[j->pattern->q[i]]) / (2.0 * step);
    memcpy(d->q, q, bytes);
    memcpy(d->v, v, bytes);
    recover(j, k, k + 1);
  }
  maggi_chain_forces(d, time);
}

/* ------------------------------------------------------------------------ tangents and adjoints */

static void by_tangents(maggi_force_jacobian *j, double time)
{
  const maggi_companion *s = &j->D->strip;
  size_t bytes = (size_t)j->d->t.nq * W * sizeof(double);
  const int *column;
  int k, i, c, n, m, first, end;

  maggi_chain_forces(j->d, time);
  for (first = 0; first < directions(j); first = end) {
    end = first + W < directions(j) ? first + W : directions(j);
    memset(s->q, 0, bytes);
    memset(s->v, 0, bytes);
    for (k = first; k < end; ++k) {
      column = columns_of(j, &k, &n);
      for (i = 0; i < n; ++i) {
        c = column[i];
        m = j->pattern->q[c % j->pattern->n];
        (c < j->pattern->n ? s->q : s->v)[m * W + k - first] = 1.0;
      }
    }
    maggi_strip_forces(j->D);
    for (i = 0; i < j->pattern->n; ++i)
      for (k = first; k < end; ++k)
        j->product[i * (end - first) + k - first] = s->w[j->pattern->q[i] * W + k - first];
    recover(j, first, end);
  }
}

/* row by row; `next` of a column is its first entry in this row or below */
static void by_adjoints(maggi_force_jacobian *j, double time)
{
  const maggi_companion *s = &j->D->adjoint;
  const maggi_sparsity *a = &j->pattern->J;
  int *next = j->next, i, c, m, n = j->pattern->n;

  maggi_chain_forces(j->d, time);
  for (c = 0; c < a->ncol; ++c) next[c] = a->coladr[c];
  for (i = 0; i < n; ++i) {
    memset(s->motion, 0, s->nmotion * sizeof(double));
    s->w[j->pattern->q[i]] = 1.0;
    maggi_adjoint_forces(j->D);
    for (c = 0; c < a->ncol; ++c) {
      if (next[c] == a->coladr[c + 1] || a->row[next[c]] != i) continue;
      m = j->pattern->q[c % n];
      j->value[next[c]++] = c < n ? s->q[m] : s->v[m];
    }
  }
}

void maggi_force_jacobian_compute(maggi_force_jacobian *j, double time)
{
  j->compute(j, time);
}

/* -------------------------------------------------------------------------------------- memory */

maggi_status maggi_force_jacobian_create(maggi_data *d, maggi_jacobian way,
                                         maggi_force_jacobian **jacobian)
{
  maggi_force_jacobian *j = calloc(1, sizeof *j);
  maggi_status status = MAGGI_E_MEMORY;
  size_t n;

  *jacobian = NULL;
  if (!j) return status;
  j->d = d;
  if (is_difference(way))
    j->compute = by_differences;
  else
    j->compute = way == MAGGI_JACOBIAN_ADJOINT ? by_adjoints : by_tangents;
  status = maggi_pattern_create(&d->t, &j->pattern);
  if (status == MAGGI_OK && is_coloured(way))
    status = maggi_colouring_create(&j->pattern->J, MAGGI_COLOUR_BEST, &j->colouring);
  if (status == MAGGI_OK && !is_difference(way)) status = maggi_derivative_create(d, 0, &j->D);
  if (status == MAGGI_OK) {
    n = (size_t)j->pattern->n;
    j->value = calloc((size_t)j->pattern->J.coladr[j->pattern->J.ncol] + 1, sizeof(double));
    j->ahead = calloc(n + 1, sizeof(double));
    j->product = calloc(n * W + 2 * (size_t)d->t.nq + 1, sizeof(double));
    j->next = calloc(2 * n + 1, sizeof(int));
    if (!j->value || !j->ahead || !j->product || !j->next) status = MAGGI_E_MEMORY;
  }
  if (status != MAGGI_OK) {
    maggi_force_jacobian_free(j);
    return status;
  }
  *jacobian = j;
  return MAGGI_OK;
}

void maggi_force_jacobian_free(maggi_force_jacobian *j)
{
  if (!j) return;
  maggi_pattern_free(j->pattern);
  maggi_colouring_free(j->colouring);
  maggi_derivative_free(j->D);
  free(j->value);
  free(j->ahead);
  free(j->product);
  free(j->next);
  free(j);
}
