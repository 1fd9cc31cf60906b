#include "tangent_matrix.h"

#include <stdlib.h>
#include <string.h>

/* -------------------------------------------------------------------------------------- places */

/* lists of rows by columns, without order and with repetitions */
typedef struct entries {
  int n, *row, *col; /* NULL: only count */
} entries;

static void add(entries *e, int row, int col)
{
  if (row < 0 || col < 0) return;
  if (e->row) {
    e->row[e->n] = row;
    e->col[e->n] = col;
  }
  ++e->n;
}

/* loops couple all coordinates of their paths, forces and masses what the pattern has */
static void list_entries(const maggi_tangent_matrix *m, entries *e)
{
  const maggi_topo *t = &m->d->t;
  const maggi_sparsity *J = &m->pattern->J;
  const int *index = m->pattern->index;
  int i, j, k;

  e->n = 0;
  for (j = 0; j < m->pattern->n; ++j)
    for (k = J->coladr[j]; k < J->coladr[j + 1]; ++k) add(e, J->row[k], j);
  for (k = 0; k < t->npair; ++k) {
    add(e, index[t->pairi[k]], index[t->pairj[k]]);
    add(e, index[t->pairj[k]], index[t->pairi[k]]);
  }
  for (k = 0; k < t->nloop; ++k)
    for (i = t->pathadr[k]; i < t->pathadr[k + 1]; ++i)
      for (j = t->pathadr[k]; j < t->pathadr[k + 1]; ++j)
        add(e, index[t->pathq[i]], index[t->pathq[j]]);
}

/* columns with their rows rising, each once: sorted by rows, then by columns */
static int sort_entries(maggi_sparsity *a, const entries *e, int n)
{
  int *by_row = malloc(((size_t)e->n + 1) * sizeof(int));
  int *first = calloc((size_t)n + 2, sizeof(int)), *last = malloc(((size_t)n + 1) * sizeof(int));
  int i, k, ok;

  a->nrow = a->ncol = n;
  a->coladr = calloc((size_t)n + 2, sizeof(int));
  a->row = malloc(((size_t)e->n + 1) * sizeof(int));
  ok = by_row && first && last && a->coladr && a->row;
  for (k = 0; k < e->n && ok; ++k) ++first[e->row[k] + 1];
  for (i = 0; i < n && ok; ++i) first[i + 1] += first[i];
  for (k = 0; k < e->n && ok; ++k) by_row[first[e->row[k]]++] = k;
  for (i = 0; i < n && ok; ++i) last[i] = -1;
  for (k = 0; k < e->n && ok; ++k) {
    i = e->col[by_row[k]];
    if (last[i] == e->row[by_row[k]]) continue;
    last[i] = e->row[by_row[k]];
    ++a->coladr[i + 1];
  }
  for (i = 0; i < n && ok; ++i) {
    a->coladr[i + 1] += a->coladr[i];
    last[i] = -1;
    first[i] = a->coladr[i];
  }
  for (k = 0; k < e->n && ok; ++k) {
    i = e->col[by_row[k]];
    if (last[i] == e->row[by_row[k]]) continue;
    last[i] = e->row[by_row[k]];
    a->row[first[i]++] = last[i];
  }
  free(by_row);
  free(first);
  free(last);
  return ok;
}

static int find_places(maggi_tangent_matrix *m)
{
  entries e = {0};
  int ok;

  list_entries(m, &e);
  e.row = malloc(((size_t)e.n + 1) * sizeof(int));
  e.col = malloc(((size_t)e.n + 1) * sizeof(int));
  ok = e.row && e.col;
  if (ok) list_entries(m, &e);
  ok = ok && sort_entries(&m->places, &e, m->pattern->n);
  free(e.row);
  free(e.col);
  return ok;
}

static int place_of(const maggi_tangent_matrix *m, int row, int col)
{
  const maggi_sparsity *a = &m->places;
  int low, high, mid;

  if (row < 0 || col < 0) return -1;
  low = a->coladr[col];
  high = a->coladr[col + 1] - 1;
  while (low < high) {
    mid = low + (high - low) / 2;
    if (a->row[mid] < row)
      low = mid + 1;
    else
      high = mid;
  }
  return low;
}

static void list_places(maggi_tangent_matrix *m)
{
  const maggi_topo *t = &m->d->t;
  const maggi_sparsity *J = &m->pattern->J;
  const int *index = m->pattern->index;
  int i, j, k, n = 0;

  for (j = 0; j < m->pattern->n; ++j)
    for (k = J->coladr[j]; k < J->coladr[j + 1]; ++k) m->force[k] = place_of(m, J->row[k], j);
  for (k = 0; k < t->npair; ++k) {
    i = index[t->pairi[k]];
    j = index[t->pairj[k]];
    m->mass[2 * k] = place_of(m, i, j);
    m->mass[2 * k + 1] = i == j ? -1 : place_of(m, j, i);
  }
  for (k = 0; k < t->nloop; ++k) {
    m->loopadr[k] = n;
    for (i = t->pathadr[k]; i < t->pathadr[k + 1]; ++i)
      for (j = t->pathadr[k]; j < t->pathadr[k + 1]; ++j)
        m->loop[n++] = place_of(m, index[t->pathq[i]], index[t->pathq[j]]);
  }
  m->loopadr[t->nloop] = n;
}

/* -------------------------------------------------------------------------------------- values */

static void add_mass(maggi_tangent_matrix *m)
{
  maggi_data *d = m->d;
  const maggi_topo *t = &d->t;
  int k;

  maggi_composite_inertias(t, d->p, (void *)d->r, (void *)d->I, d->IS);
  maggi_mass_matrix(t, d->p, (void *)d->b, (void *)d->r, (void *)d->IS, d->Fb, d->rodjac, d->M);
  for (k = 0; k < 2 * t->npair; ++k)
    if (m->mass[k] >= 0) m->projection[m->mass[k]] += d->M[k / 2];
}

/* f Phi_z^T Phi_z of rows of a loop, six at most */
static void add_rows(maggi_tangent_matrix *m, int loop, double f)
{
  const int *place = m->loop + m->loopadr[loop];
  int n = m->d->t.pathadr[loop + 1] - m->d->t.pathadr[loop], i, j, k;
  double sum;

  for (i = 0; i < n; ++i) {
    for (j = 0; j <= i; ++j) {
      if (place[i * n + j] < 0) continue;
      sum = 0.0;
      for (k = 0; k < 6; ++k) sum += m->row[i][k] * m->row[j][k];
      m->projection[place[i * n + j]] += f * sum;
      if (i != j) m->projection[place[j * n + i]] += f * sum;
    }
  }
}

static void add_loops(maggi_tangent_matrix *m, double f)
{
  const maggi_topo *t = &m->d->t;
  int loop, prim = 0, i, n, k, rows;
  double e[3];

  for (loop = 0; loop < t->nloop; ++loop) {
    n = t->pathadr[loop + 1] - t->pathadr[loop];
    while (prim < t->nprim && t->primloop[prim] == loop) {
      memset(m->row, 0, (size_t)n * sizeof *m->row);
      for (k = 0; k < 6 && prim < t->nprim && t->primloop[prim] == loop; k += rows, ++prim) {
        rows = maggi_prim_rows(t->primkind[prim]);
        if (k + rows > 6) break;
        for (i = 0; i < n; ++i) {
          maggi_path_entry(m->d, prim, t->pathadr[loop] + i, e);
          memcpy(m->row[i] + k, e, (size_t)rows * sizeof(double));
        }
      }
      add_rows(m, loop, f);
    }
  }
}

void maggi_tangent_matrix_project(maggi_tangent_matrix *m, double h, double alpha)
{
  memset(m->projection, 0, (size_t)m->places.coladr[m->places.ncol] * sizeof(double));
  add_mass(m);
  add_loops(m, 0.25 * h * h * alpha);
}

void maggi_tangent_matrix_newton(maggi_tangent_matrix *m, double h, const double *J)
{
  int k, half = m->pattern->J.coladr[m->pattern->n];

  memcpy(m->newton, m->projection, (size_t)m->places.coladr[m->places.ncol] * sizeof(double));
  for (k = 0; k < half; ++k) m->newton[m->force[k]] -= 0.25 * h * h * J[k] + 0.5 * h * J[half + k];
}

/* -------------------------------------------------------------------------------------- memory */

maggi_status maggi_tangent_matrix_create(maggi_data *d, const maggi_pattern *pattern,
                                         maggi_tangent_matrix **matrix)
{
  maggi_tangent_matrix *m = calloc(1, sizeof *m);
  const maggi_topo *t = &d->t;
  size_t squares = 0, longest = 0, n;
  int k, ok;

  *matrix = NULL;
  if (!m) return MAGGI_E_MEMORY;
  m->d = d;
  m->pattern = pattern;
  for (k = 0; k < t->nloop; ++k) {
    n = (size_t)(t->pathadr[k + 1] - t->pathadr[k]);
    squares += n * n;
    longest = n > longest ? n : longest;
  }
  ok = find_places(m);
  n = ok ? (size_t)m->places.coladr[m->places.ncol] : 0;
  m->projection = malloc((n + 1) * sizeof(double));
  m->newton = malloc((n + 1) * sizeof(double));
  m->force = malloc(((size_t)pattern->J.coladr[pattern->n] + 1) * sizeof(int));
  m->mass = malloc(2 * ((size_t)t->npair + 1) * sizeof(int));
  m->loop = malloc((squares + 1) * sizeof(int));
  m->loopadr = malloc(((size_t)t->nloop + 1) * sizeof(int));
  m->row = malloc((longest + 1) * sizeof *m->row);
  if (!ok || !m->projection || !m->newton || !m->force || !m->mass || !m->loop || !m->loopadr ||
      !m->row) {
    maggi_tangent_matrix_free(m);
    return MAGGI_E_MEMORY;
  }
  list_places(m);
  *matrix = m;
  return MAGGI_OK;
}

void maggi_tangent_matrix_free(maggi_tangent_matrix *m)
{
  if (!m) return;
  free(m->places.coladr);
  free(m->places.row);
  free(m->projection);
  free(m->newton);
  free(m->force);
  free(m->mass);
  free(m->loop);
  free(m->loopadr);
  free(m->row);
  free(m);
}
