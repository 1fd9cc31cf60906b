/* A list of entries in any order and with repetitions, then sorted by rows and by columns. */
#include "pattern.h"

#include <stdlib.h>

typedef struct entries {
  const maggi_topo *t;
  int n;
  int *row, *col; /* internal coordinates; NULL: only count them */
} entries;

static void add(entries *e, int qi, int qj)
{
  if (e->t->qguide[qi] >= 0 || e->t->qguide[qj] >= 0) return;
  if (e->row) {
    e->row[e->n] = qi;
    e->col[e->n] = qj;
  }
  ++e->n;
}

static void add_both(entries *e, int qi, int qj)
{
  add(e, qi, qj);
  add(e, qj, qi);
}

static int common_body(const maggi_topo *t, int a, int b)
{
  while (a != b) {
    if (a < b)
      a = t->parent[a];
    else
      b = t->parent[b];
  }
  return a;
}

/* rows of what moves body a relative to the common body, columns of what moves b; or both ways */
static void add_bodies(entries *e, int a, int b, int both)
{
  const maggi_topo *t = e->t;
  int common = common_body(t, a, b), i, j;

  for (i = a; i != common; i = t->parent[i]) {
    if (t->qid[i] < 0) continue;
    for (j = b; j != common; j = t->parent[j]) {
      if (t->qid[j] < 0) continue;
      add(e, t->qid[i], t->qid[j]);
      if (both) add(e, t->qid[j], t->qid[i]);
    }
  }
}

/* torques of controllers depend on how a point moves */
static void add_controllers(entries *e)
{
  const maggi_topo *t = e->t;
  int i, k, body;

  for (i = 0; i < t->ndriver; ++i)
    for (body = t->pointbody[t->driverpoint[i]]; body != t->nbody; body = t->parent[body])
      if (t->qid[body] >= 0) add(e, t->driverq[i], t->qid[body]);
  for (i = 0; i < t->nspeed; ++i)
    for (k = t->speedqadr[i]; k < t->speedqadr[i] + t->speedqnum[i]; ++k)
      for (body = t->pointbody[t->speedpoint[i]]; body != t->nbody; body = t->parent[body])
        if (t->qid[body] >= 0) add(e, t->speedq[k], t->qid[body]);
  for (i = 0; i < t->nspeed; ++i)
    for (k = t->speedqadr[i]; t->speeddriver[i] >= 0 && k < t->speedqadr[i] + t->speedqnum[i]; ++k)
      for (body = t->pointbody[t->driverpoint[t->speeddriver[i]]]; body != t->nbody;
           body = t->parent[body])
        if (t->qid[body] >= 0) add(e, t->speedq[k], t->qid[body]);
}

static void add_all(entries *e)
{
  const maggi_topo *t = e->t;
  int i;

  e->n = 0;
  for (i = 0; i < t->npair; ++i) add_both(e, t->pairi[i], t->pairj[i]); /* bodies and rods */
  for (i = 0; i < t->nspring; ++i)
    add_bodies(e, t->pointbody[t->springpa[i]], t->pointbody[t->springpb[i]], 1);
  for (i = 0; i < t->njspring; ++i)
    if (t->jspringq2[i] >= 0) add_both(e, t->jspringq[i], t->jspringq2[i]);
  for (i = 0; i < t->nforce; ++i)
    if (t->forcekind[i] != MAGGI_FORCE_JOINT && t->forcekind[i] != MAGGI_TORQUE_GLOBAL)
      add_bodies(e, t->forcereaction[i], t->forcebody[i], 0);
  add_controllers(e);
}

/* the entries as a matrix of which the rows are listed */
static void list_rows(const entries *e, const int *index, maggi_sparsity *rows)
{
  int i, k;

  for (i = 0; i <= rows->ncol; ++i) rows->coladr[i] = 0;
  for (k = 0; k < e->n; ++k) ++rows->coladr[index[e->row[k]]];
  for (i = 0; i < rows->ncol; ++i) rows->coladr[i + 1] += rows->coladr[i];
  for (k = 0; k < e->n; ++k) rows->row[--rows->coladr[index[e->row[k]]]] = index[e->col[k]];
}

/* each entry once; seen: (nrow) */
static void drop_repeated(maggi_sparsity *a, int *seen)
{
  int j, k = 0, last = 0, n = 0;

  for (j = 0; j < a->nrow; ++j) seen[j] = -1;
  for (j = 0; j < a->ncol; ++j) {
    last = a->coladr[j + 1];
    a->coladr[j] = n;
    for (; k < last; ++k) {
      if (seen[a->row[k]] == j) continue;
      seen[a->row[k]] = j;
      a->row[n++] = a->row[k];
    }
  }
  a->coladr[a->ncol] = n;
}

/* the second block like the first */
static void repeat(maggi_sparsity *J)
{
  int n = J->ncol, size = J->coladr[n], k;

  J->ncol = 2 * n;
  for (k = 1; k <= n; ++k) J->coladr[n + k] = size + J->coladr[k];
  for (k = 0; k < size; ++k) J->row[size + k] = J->row[k];
}

static maggi_pattern *new_pattern(const maggi_topo *t, int n)
{
  size_t nq = (size_t)t->nq, size = 4 * nq + 1 + 2 * (size_t)n;
  maggi_pattern *p = malloc(sizeof *p + size * sizeof(int));
  int i;

  if (!p) return NULL;
  p->q = (int *)(p + 1);
  p->index = p->q + nq;
  p->J.coladr = p->index + nq;
  p->J.row = p->J.coladr + 2 * nq + 1;
  p->n = 0;
  for (i = 0; i < t->nq; ++i) {
    p->index[i] = t->qguide[i] < 0 ? p->n : -1;
    if (t->qguide[i] < 0) p->q[p->n++] = i;
  }
  return p;
}

maggi_status maggi_pattern_create(const maggi_topo *t, maggi_pattern **pattern)
{
  entries e = {.t = t};
  maggi_sparsity rows;
  maggi_pattern *p;
  int *work;

  *pattern = NULL;
  add_all(&e);
  p = new_pattern(t, e.n);
  work = malloc((3 * (size_t)e.n + 2 * (size_t)t->nq + 1) * sizeof *work);
  if (!p || !work) {
    free(p);
    free(work);
    return MAGGI_E_MEMORY;
  }
  e.row = work;
  e.col = e.row + e.n;
  rows = (maggi_sparsity){p->n, p->n, e.col + 2 * (size_t)e.n, e.col + e.n};
  add_all(&e);
  list_rows(&e, p->index, &rows);
  drop_repeated(&rows, rows.coladr + p->n + 1);
  maggi_sparsity_transpose(&rows, &p->J);
  repeat(&p->J);
  free(work);
  *pattern = p;
  return MAGGI_OK;
}

void maggi_pattern_free(maggi_pattern *pattern)
{
  free(pattern);
}
