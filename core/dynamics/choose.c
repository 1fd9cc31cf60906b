/* Rank-revealing choice of the dependent coordinates, loop by loop.
 *
 * The rows of a loop are written in the coordinates that are still free: a coordinate that depends on
 * an earlier loop is replaced by its expression.  Gauss-Jordan elimination with pivoting then finds
 * the rank that the loop adds and the coordinates that will depend on it.  Among pivots not smaller
 * than `threshold` times the largest, the coordinate that moves the fewest loops is taken, so that
 * islands stay small. */
#include "plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS_MAX = 6 };

/* prescribed coordinates become dependent only when all other pivots are this much smaller */
static const double avoid_threshold = 1e-3;

static int pool_room(maggi_planner *pl, int n)
{
  int cap = pl->cappool ? pl->cappool : 1024, *q;
  double *c;

  if (pl->npool + n <= pl->cappool) return 1;
  while (cap < pl->npool + n) cap *= 2;
  q = realloc(pl->poolq, (size_t)cap * sizeof *q);
  if (q) pl->poolq = q;
  c = realloc(pl->poolc, (size_t)cap * sizeof *c);
  if (c) pl->poolc = c;
  if (!q || !c) return 0;
  pl->cappool = cap;
  return 1;
}

static int column_of(maggi_planner *pl, int q, int *n)
{
  if (pl->candidate[q] < 0) {
    pl->candidate[q] = *n;
    pl->columnq[(*n)++] = q;
  }
  return pl->candidate[q];
}

/* the coordinates in which the rows of a loop are written */
static int list_candidates(maggi_data *d, int loop)
{
  const maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int i, k, q, n = 0;

  for (i = t->pathadr[loop]; i < t->pathadr[loop + 1]; ++i) {
    q = t->pathq[i];
    if (t->qguide[q] >= 0) continue;
    if (pl->owner[q] < 0)
      column_of(pl, q, &n);
    else
      for (k = 0; k < pl->row[q].n; ++k) column_of(pl, pl->poolq[pl->row[q].begin + k], &n);
  }
  return n;
}

/* size that an entry of a coordinate has when it moves the loop at all: the arm of a turn, 1 for a
 * shift or the turn of a direction; an arm counts at least as a small part of the model */
static double natural_size(const maggi_data *d, int prim, int side, int q, double model_size)
{
  const maggi_topo *t = &d->t;
  int body = t->qbody[q], point = side == 0 ? t->primpa[prim] : t->primpb[prim], k;
  double arm = 0.0;

  if (t->joint[body] == MAGGI_ONE_PRISMATIC || t->primkind[prim] == MAGGI_PRIM_AXIS ||
      t->primkind[prim] == MAGGI_PRIM_ANGLE)
    return 1.0;
  for (k = 0; k < 3; ++k)
    arm += (d->r[point][k] - d->x[body][k]) * (d->r[point][k] - d->x[body][k]);
  return fmax(sqrt(arm), 1e-4 * model_size);
}

static double model_size(const maggi_data *d)
{
  double size = 0.0;
  int i, k;

  for (i = 0; i < d->t.npointdyn; ++i)
    for (k = 0; k < 3; ++k) size = fmax(size, fabs(d->r[i][k] - d->x[d->t.nbody][k]));
  return size;
}

/* rows of the loop by candidates; returns the size that entries have by nature */
static double fill_matrix(maggi_data *d, int loop, int n, double size, int *rows)
{
  const maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  double e[3], scale = 0.0, *m;
  int i, k, j, q, prim, first = t->primrow[pl->loopprim[loop]], nrow;

  *rows = 0;
  for (prim = pl->loopprim[loop]; prim < pl->loopprim[loop + 1]; ++prim) {
    nrow = maggi_prim_rows(t->primkind[prim]);
    *rows += nrow;
    for (i = t->pathadr[loop]; i < t->pathadr[loop + 1]; ++i) {
      q = t->pathq[i];
      if (t->qguide[q] >= 0) continue;
      maggi_path_entry(d, prim, i, e);
      scale = fmax(scale, natural_size(d, prim, t->pathside[i], q, size));
      for (k = 0; k < nrow; ++k) {
        m = pl->matrix + (size_t)(t->primrow[prim] - first + k) * (size_t)n;
        if (pl->owner[q] < 0) {
          m[pl->candidate[q]] += e[k];
          continue;
        }
        for (j = pl->row[q].begin; j < pl->row[q].begin + pl->row[q].n; ++j)
          m[pl->candidate[pl->poolq[j]]] += e[k] * pl->poolc[j];
      }
    }
  }
  return scale;
}

/* how little a coordinate should become dependent: 2 for a prescribed velocity, 1 for a prescribed
 * position */
static int reluctance(const maggi_data *d, int avoid, int q)
{
  if (!(avoid & MAGGI_AVOID_GIVEN)) return 0;
  return d->velocity_given[q] ? 2 : d->position_given[q] ? 1 : 0;
}

/* the column of least reach among those not smaller than limit; larger ones first among equals */
static int least_reach(const maggi_data *d, int avoid, int level, double limit, const double *size,
                       int n)
{
  const maggi_planner *pl = d->planner;
  const int *reach = d->m->reach;
  int c, q, best = -1, bestq = -1;

  for (c = 0; c < n; ++c) {
    q = pl->columnq[c];
    if (size[c] == 0.0 || size[c] < limit || reluctance(d, avoid, q) > level) continue;
    if (best < 0 || reach[q] < reach[bestq] || (reach[q] == reach[bestq] && size[c] > size[best])) {
      best = c;
      bestq = q;
    }
  }
  return best;
}

/* pivot column: one that is not prescribed, unless all of these are much smaller than the largest */
static int choose_column(const maggi_data *d, int avoid, double threshold, const double *size,
                         int n, double largest)
{
  double most;
  int c, level;

  for (level = 0;; ++level) {
    most = 0.0;
    for (c = 0; c < n; ++c)
      if (reluctance(d, avoid, d->planner->columnq[c]) <= level) most = fmax(most, size[c]);
    if (most >= avoid_threshold * largest)
      return least_reach(d, avoid, level, threshold * most, size, n);
  }
}

/* Gauss-Jordan; pivots[k] = column of row k; returns the rank */
static int eliminate(maggi_data *d, int avoid, double threshold, int rows, int n, double scale,
                     int *pivots)
{
  maggi_planner *pl = d->planner;
  double *m = pl->matrix, *size = pl->sum, largest, f;
  int rank, i, c, col, at;

  for (rank = 0; rank < rows; ++rank) {
    largest = 0.0;
    for (c = 0; c < n; ++c) {
      size[c] = 0.0;
      if ((avoid & MAGGI_KEEP_POSITION) && d->position_given[pl->columnq[c]]) continue;
      for (i = rank; i < rows; ++i) size[c] = fmax(size[c], fabs(m[i * n + c]));
      largest = fmax(largest, size[c]);
    }
    if (!(largest > d->rank_tolerance * scale)) break;
    col = choose_column(d, avoid, threshold, size, n, largest);
    at = rank;
    for (i = rank + 1; i < rows; ++i)
      if (fabs(m[i * n + col]) > fabs(m[at * n + col])) at = i;
    for (c = 0; c < n; ++c) {
      f = m[at * n + c];
      m[at * n + c] = m[rank * n + c];
      m[rank * n + c] = f;
    }
    f = 1.0 / m[rank * n + col];
    for (c = 0; c < n; ++c) m[rank * n + c] *= f;
    for (i = 0; i < rows; ++i) {
      f = m[i * n + col];
      if (i == rank || f == 0.0) continue;
      for (c = 0; c < n; ++c) m[i * n + c] -= f * m[rank * n + c];
      m[i * n + col] = 0.0;
    }
    pivots[rank] = col;
  }
  return rank;
}

/* expression of the new dependents: minus their row of the reduced matrix */
static int write_rows(maggi_planner *pl, int n, int rank, const int *pivots)
{
  double v;
  int i, c, k, q, is_pivot;

  for (i = 0; i < rank; ++i) {
    if (!pool_room(pl, n)) return 0;
    q = pl->columnq[pivots[i]];
    pl->row[q].begin = pl->npool;
    for (c = 0; c < n; ++c) {
      is_pivot = 0;
      for (k = 0; k < rank; ++k) is_pivot = is_pivot || pivots[k] == c;
      v = -pl->matrix[i * n + c];
      if (is_pivot || v == 0.0) continue;
      pl->poolq[pl->npool] = pl->columnq[c];
      pl->poolc[pl->npool++] = v;
    }
    pl->row[q].n = pl->npool - pl->row[q].begin;
  }
  return 1;
}

/* earlier expressions lose coordinates that have just become dependent */
static int substitute(maggi_data *d, int loop)
{
  maggi_planner *pl = d->planner;
  int nq = d->t.nq, i, j, k, q, n, hit;

  for (i = 0; i < nq; ++i) {
    if (pl->owner[i] < 0 || pl->owner[i] == loop) continue;
    hit = 0;
    for (j = pl->row[i].begin; j < pl->row[i].begin + pl->row[i].n; ++j)
      hit = hit || pl->owner[pl->poolq[j]] >= 0;
    if (!hit) continue;
    n = 0;
    for (j = pl->row[i].begin; j < pl->row[i].begin + pl->row[i].n; ++j) {
      q = pl->poolq[j];
      if (pl->owner[q] < 0) {
        pl->sum[column_of(pl, q, &n)] = 0.0;
        continue;
      }
      for (k = pl->row[q].begin; k < pl->row[q].begin + pl->row[q].n; ++k)
        pl->sum[column_of(pl, pl->poolq[k], &n)] = 0.0;
    }
    for (j = pl->row[i].begin; j < pl->row[i].begin + pl->row[i].n; ++j) {
      q = pl->poolq[j];
      if (pl->owner[q] < 0) {
        pl->sum[pl->candidate[q]] += pl->poolc[j];
        continue;
      }
      for (k = pl->row[q].begin; k < pl->row[q].begin + pl->row[q].n; ++k)
        pl->sum[pl->candidate[pl->poolq[k]]] += pl->poolc[j] * pl->poolc[k];
    }
    if (!pool_room(pl, n)) return 0;
    pl->row[i].begin = pl->npool;
    pl->row[i].n = n;
    for (k = 0; k < n; ++k) {
      pl->poolq[pl->npool] = pl->columnq[k];
      pl->poolc[pl->npool++] = pl->sum[k];
      pl->candidate[pl->columnq[k]] = -1;
    }
  }
  return 1;
}

maggi_status maggi_choose(maggi_data *d, int avoid, double threshold)
{
  const maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int pivots[ROWS_MAX], i, k, c, n, rows, loop;
  double scale, size = model_size(d), *bigger;
  size_t need;

  pl->npool = 0;
  for (i = 0; i < t->nq; ++i) pl->owner[i] = pl->candidate[i] = -1;
  for (i = 0; i < t->nloop; ++i) {
    loop = pl->order[i];
    n = list_candidates(d, loop);
    need = (size_t)n * ROWS_MAX;
    if (need > pl->capmatrix) {
      bigger = realloc(pl->matrix, (2 * need + 256) * sizeof *bigger);
      if (!bigger) return maggi_data_fail(d, MAGGI_E_MEMORY, "out of memory");
      pl->matrix = bigger;
      pl->capmatrix = 2 * need + 256;
    }
    if (need > 0) memset(pl->matrix, 0, need * sizeof *pl->matrix);
    scale = fill_matrix(d, loop, n, size, &rows);
    pl->rank[loop] = eliminate(d, avoid, threshold, rows, n, scale, pivots);
    if (!write_rows(pl, n, pl->rank[loop], pivots))
      return maggi_data_fail(d, MAGGI_E_MEMORY, "out of memory");
    for (c = 0; c < n; ++c) pl->candidate[pl->columnq[c]] = -1;
    for (k = 0; k < pl->rank[loop]; ++k) pl->owner[pl->columnq[pivots[k]]] = loop;
    if (pl->rank[loop] > 0 && !substitute(d, loop))
      return maggi_data_fail(d, MAGGI_E_MEMORY, "out of memory");
  }
  return MAGGI_OK;
}
