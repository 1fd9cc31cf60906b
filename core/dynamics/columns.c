/* The order of columns.
 *
 * By the tree: independent coordinates from the leaves to the root, then guided ones.  Rows of dependents
 * are worked on from their first to their last column, so those that depend on few columns far apart cost
 * as much as if they depended on all between.  By groups: what loops connect stands together, the largest
 * groups first, where they fill whole blocks, what they connect with guided coordinates last.  The plan
 * takes the cheaper order. */
#include "plan.h"

int maggi_number_columns(maggi_data *d)
{
  maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int i, pass;

  if (!maggi_sized(&pl->col, t->nq, -1) || !maggi_sized(&pl->colq, t->nq, -1)) return 0;
  t->ncol = 0;
  t->ndep = 0;
  for (pass = 0; pass < 2; ++pass) {
    for (i = 0; i < t->nq; ++i) {
      if (pl->owner[i] >= 0) {
        t->ndep += pass;
      } else if ((t->qguide[i] >= 0) == pass) {
        pl->col.v[i] = t->ncol;
        pl->colq.v[t->ncol++] = i;
      }
    }
    if (pass == 0) t->nind = t->ncol;
  }
  t->stride = (t->ncol + MAGGI_WIDTH - 1) / MAGGI_WIDTH * MAGGI_WIDTH;
  return 1;
}

static int group_of(const int *group, int q)
{
  while (group[q] != q) q = group[q];
  return q;
}

/* coordinates that loops connect have the same group; size: independent coordinates of a group, negative
 * with guided ones */
static void find_groups(const maggi_topo *t, const int *owner, int *group, int *size)
{
  int loop, i, a, b;

  for (i = 0; i < t->nq; ++i) {
    group[i] = i;
    size[i] = 0;
  }
  for (loop = 0; loop < t->nloop; ++loop) {
    for (i = t->pathadr[loop] + 1; i < t->pathadr[loop + 1]; ++i) {
      a = group_of(group, t->pathq[i - 1]);
      b = group_of(group, t->pathq[i]);
      group[a < b ? b : a] = a < b ? a : b;
    }
  }
  for (i = 0; i < t->nq; ++i) group[i] = group_of(group, i);
  for (i = 0; i < t->nq; ++i)
    if (owner[i] < 0 && t->qguide[i] < 0) ++size[group[i]];
  for (i = 0; i < t->nq; ++i)
    if (t->qguide[i] >= 0 && size[group[i]] > 0) size[group[i]] = -size[group[i]];
}

static int next_size(int n, const int *size, int below)
{
  int i, next = -n - 1;

  for (i = 0; i < n; ++i)
    if (size[i] < below && size[i] > next) next = size[i];
  return next;
}

int maggi_group_columns(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  const int *group = pl->group, *size = pl->groupsize;
  int i, q, now, left, c = 0, differs = 0;

  find_groups(t, pl->owner, pl->group, pl->groupsize);
  for (now = next_size(t->nq, size, t->nq + 1); c < t->nind; now = next_size(t->nq, size, now)) {
    for (i = 0; i < t->nq; ++i) {
      if (size[i] != now || now == 0) continue;
      left = now < 0 ? -now : now;
      for (q = i; left > 0; ++q) {
        if (group[q] != i || pl->owner[q] >= 0 || t->qguide[q] >= 0) continue;
        --left;
        differs = differs || pl->col.v[q] != c;
        pl->col.v[q] = c;
        pl->colq.v[c++] = q;
      }
    }
  }
  return differs;
}

/* columns that work on begin..end touches */
static double wide(int begin, int end)
{
  int from = begin / MAGGI_WIDTH * MAGGI_WIDTH;

  return end > from ? (end - from + MAGGI_WIDTH - 1) / MAGGI_WIDTH * MAGGI_WIDTH : 0;
}

double maggi_columns_cost(const maggi_data *d)
{
  const maggi_topo *t = &d->t;
  const maggi_planner *pl = d->planner;
  const int *rbeg = pl->rbeg.v, *rend = pl->rend.v, *zbeg = pl->zbeg.v, *zend = pl->zend.v;
  int i, k, c, m, n;
  double flops = 0.0;

  for (i = 0; i < t->nvop; ++i) {
    k = pl->vopdst.v[i];
    flops += 12.0 * wide(pl->vrowbeg.v[k], pl->vrowend.v[k]);
  }
  for (k = 0; k < t->nisland; ++k) {
    m = pl->islrow.v[k + 1] - pl->islrow.v[k];
    n = pl->isldep.v[k + 1] - pl->isldep.v[k];
    flops += (20.0 * m + 6.0 * m * n + 4.0 * n * n) * wide(pl->islbeg.v[k], pl->islend.v[k]);
  }
  for (i = 0; i < t->ndep; ++i) {
    k = pl->dep.v[i];
    flops += 2.0 * (pl->ddadr.v[i + 1] - pl->ddadr.v[i]) * wide(zbeg[k], zend[k]);
    flops += 2.0 * (rbeg[k] - zbeg[k]) * wide(rbeg[k], rend[k]);
    for (c = rbeg[k]; c < rend[k]; ++c) flops += 2.0 * (wide(c, zend[k]) + wide(c, rend[k]));
  }
  for (i = 0; i < t->nind; ++i) flops += 2.0 * (i - pl->first.v[i]) * wide(i, t->nind);
  return flops;
}
