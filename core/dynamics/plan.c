/* From islands to the lists that the kernel follows. */
#include "plan.h"

#include <string.h>

/* ---------------------------------------------------------------------------------- velocities */

static void widen(int *begin, int *end, int b, int e)
{
  if (b >= e) return;
  if (*begin >= *end) {
    *begin = b;
    *end = e;
    return;
  }
  *begin = b < *begin ? b : *begin;
  *end = e > *end ? e : *end;
}

/* a new velocity row = row src + b_q R_q; -1 when out of memory */
static int add_row(maggi_data *d, int base, int src, int q)
{
  maggi_planner *pl = d->planner;
  int begin = pl->vrowbeg.v[src], end = pl->vrowend.v[src];
  int row = pl->vrowbeg.n;

  widen(&begin, &end, pl->rbeg.v[q], pl->rend.v[q]);
  if (!maggi_push_int(&pl->vrowbeg, begin) || !maggi_push_int(&pl->vrowend, end) ||
      !maggi_push_int(&pl->vbase, base) || !maggi_push_int(&pl->vnext, -1) ||
      !maggi_push_int(&pl->vopdst, row) || !maggi_push_int(&pl->vopsrc, src) ||
      !maggi_push_int(&pl->vopq, q))
    return -1;
  return row;
}

/* row of the velocity of a body relative to the body `base` that carries it */
static int row_of_body(maggi_data *d, int body, int base)
{
  const maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int n = 0, row = 0, k;

  for (; body != base; body = t->parent[body]) {
    if (t->qid[body] < 0) continue;
    for (k = pl->vhead[body]; k >= 0 && pl->vbase.v[k] != base; k = pl->vnext.v[k])
      ;
    if (k >= 0) {
      row = k;
      break;
    }
    pl->climb[n++] = body;
  }
  while (n > 0 && row >= 0) {
    body = pl->climb[--n];
    row = add_row(d, base, row, t->qid[body]);
    if (row >= 0) {
      pl->vnext.v[row] = pl->vhead[body];
      pl->vhead[body] = row;
    }
  }
  return row;
}

/* row of one side of a loop with the dependents of its island at rest */
static int row_of_side(maggi_data *d, int loop, int side, int end)
{
  const maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int island = pl->loopisland[loop], base = t->loopcommon[loop], i, q, row = -1;

  for (i = t->pathadr[loop]; i < t->pathadr[loop + 1]; ++i) {
    q = t->pathq[i];
    if (t->pathside[i] != side) continue;
    if (pl->owner[q] >= 0 && pl->loopisland[pl->owner[q]] == island) {
      if (row < 0) row = row_of_body(d, t->parent[t->qbody[q]], base);
    } else if (row >= 0) {
      row = add_row(d, -1, row, q);
    } else {
      continue;
    }
    if (row < 0) return -1;
  }
  return row >= 0 ? row : row_of_body(d, end, base);
}

static int push_entries(maggi_data *d, int prim, int island)
{
  const maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int n = pl->isldep.v[island + 1] - pl->isldep.v[island], loop = t->primloop[prim], i, q, adr;

  for (i = t->pathadr[loop]; i < t->pathadr[loop + 1]; ++i) {
    q = t->pathq[i];
    if (pl->owner[q] < 0 || pl->loopisland[pl->owner[q]] != island) continue;
    adr = pl->islphi.v[island] + (pl->primy.v[prim] - pl->islrow.v[island]) * n + pl->local[q];
    if (!maggi_push_int(&pl->entprim, prim) || !maggi_push_int(&pl->entside, t->pathside[i]) ||
        !maggi_push_int(&pl->entq, q) || !maggi_push_int(&pl->entadr, adr) ||
        !maggi_push_int(&pl->entstep, n))
      return 0;
  }
  return 1;
}

/* velocity rows in the order of the islands, column ranges of the dependents */
static int list_velocities(maggi_data *d)
{
  maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int i, k, prim, last, va = 0, vb = 0, begin, end;

  if (!maggi_sized(&pl->rbeg, t->nq, 0) || !maggi_sized(&pl->rend, t->nq, 0)) return 0;
  for (i = 0; i < t->ncol; ++i) {
    pl->rbeg.v[pl->colq.v[i]] = i;
    pl->rend.v[pl->colq.v[i]] = i + 1;
  }
  for (i = 0; i < t->nbody; ++i) pl->vhead[i] = -1;
  pl->vrowbeg.n = pl->vrowend.n = pl->vbase.n = pl->vnext.n = 0;
  pl->vopdst.n = pl->vopsrc.n = pl->vopq.n = 0;
  pl->entprim.n = pl->entside.n = pl->entq.n = pl->entadr.n = pl->entstep.n = 0;
  if (!maggi_push_int(&pl->vrowbeg, 0) || !maggi_push_int(&pl->vrowend, 0) ||
      !maggi_push_int(&pl->vbase, -1) || !maggi_push_int(&pl->vnext, -1))
    return 0;
  for (k = 0; k < t->nisland; ++k) {
    begin = end = 0;
    last = -1;
    pl->islvop.v[k] = pl->vopdst.n;
    pl->islent.v[k] = pl->entprim.n;
    for (i = pl->islprim.v[k]; i < pl->islprim.v[k + 1]; ++i) {
      prim = pl->primorder.v[i];
      if (t->primloop[prim] != last) {
        last = t->primloop[prim];
        va = row_of_side(d, last, 0, t->primba[prim]);
        vb = row_of_side(d, last, 1, t->primbb[prim]);
        if (va < 0 || vb < 0) return 0;
        widen(&begin, &end, pl->vrowbeg.v[va], pl->vrowend.v[va]);
        widen(&begin, &end, pl->vrowbeg.v[vb], pl->vrowend.v[vb]);
      }
      pl->primva.v[prim] = va;
      pl->primvb.v[prim] = vb;
      if (!push_entries(d, prim, k)) return 0;
    }
    pl->islbeg.v[k] = begin;
    pl->islend.v[k] = end;
    for (i = pl->isldep.v[k]; i < pl->isldep.v[k + 1]; ++i) {
      pl->rbeg.v[pl->dep.v[i]] = begin;
      pl->rend.v[pl->dep.v[i]] = end;
    }
  }
  pl->islvop.v[t->nisland] = pl->vopdst.n;
  pl->islent.v[t->nisland] = pl->entprim.n;
  t->nvrow = pl->vrowbeg.n;
  t->nvop = pl->vopdst.n;
  t->nent = pl->entprim.n;
  return 1;
}

/* ----------------------------------------------------------------------------------- mass matrix */

static void lower(int *first, int value)
{
  if (value < *first) *first = value;
}

/* of two dependents, the one with fewer columns multiplies its row of R_z into the row of the other */
static int source_of(const maggi_planner *pl, int i, int j)
{
  return pl->rend.v[i] - pl->rbeg.v[i] < pl->rend.v[j] - pl->rbeg.v[j] ? i : j;
}

/* place of a dependent coordinate in dep */
static int place_of(const maggi_planner *pl, int q)
{
  return pl->isldep.v[pl->loopisland[pl->owner[q]]] + pl->local[q];
}

/* pairs of two dependents, sorted by the row of M R_z that takes them; ddadr holds the counts */
static int list_dependent_pairs(maggi_data *d)
{
  maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int *next = pl->climb, i, j, k, at;

  for (i = 0; i < t->ndep; ++i) {
    pl->ddadr.v[i + 1] += pl->ddadr.v[i];
    next[i] = pl->ddadr.v[i];
  }
  t->ndd = pl->ddadr.v[t->ndep];
  if (!maggi_sized(&pl->ddpair, t->ndd, 0) || !maggi_sized(&pl->ddsrc, t->ndd, 0)) return 0;
  for (k = 0; k < t->npair; ++k) {
    i = t->pairi[k];
    j = t->pairj[k];
    if (pl->col.v[i] >= 0 || pl->col.v[j] >= 0) continue;
    at = next[place_of(pl, i + j - source_of(pl, i, j))]++;
    pl->ddpair.v[at] = k;
    pl->ddsrc.v[at] = source_of(pl, i, j);
  }
  return 1;
}

static int list_mass(maggi_data *d)
{
  maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int k, i, j, ci, cj, c, q, src, dst, ok = 1;

  pl->iipair.n = pl->iirow.n = pl->iicol.n = 0;
  pl->idpair.n = pl->iddep.n = pl->idcol.n = 0;
  if (!maggi_sized(&pl->first, t->nq, 0) || !maggi_sized(&pl->zbeg, t->nq, 0) ||
      !maggi_sized(&pl->zend, t->nq, 0) || !maggi_sized(&pl->ddadr, t->nq1, 0))
    return 0;
  for (i = 0; i < t->nq; ++i) {
    pl->first.v[i] = i;
    if (pl->owner[i] >= 0) {
      pl->zbeg.v[i] = pl->rbeg.v[i];
      pl->zend.v[i] = pl->rend.v[i];
    }
  }
  for (k = 0; k < t->npair && ok; ++k) {
    i = t->pairi[k];
    j = t->pairj[k];
    ci = pl->col.v[i];
    cj = pl->col.v[j];
    if (ci >= 0 && cj >= 0) {
      ok = maggi_push_int(&pl->iipair, k) && maggi_push_int(&pl->iirow, ci > cj ? cj : ci) &&
           maggi_push_int(&pl->iicol, ci > cj ? ci : cj);
      lower(&pl->first.v[ci > cj ? ci : cj], ci > cj ? cj : ci);
    } else if (ci >= 0 || cj >= 0) {
      q = ci >= 0 ? j : i;
      c = ci >= 0 ? ci : cj;
      ok = maggi_push_int(&pl->idpair, k) && maggi_push_int(&pl->iddep, q) &&
           maggi_push_int(&pl->idcol, c);
      widen(&pl->zbeg.v[q], &pl->zend.v[q], c, c + 1);
    } else {
      src = source_of(pl, i, j);
      dst = i + j - src;
      ++pl->ddadr.v[place_of(pl, dst) + 1];
      widen(&pl->zbeg.v[dst], &pl->zend.v[dst], pl->rbeg.v[src], pl->rend.v[src]);
    }
  }
  for (i = 0; i < t->ndep; ++i) {
    q = pl->dep.v[i];
    for (c = pl->rbeg.v[q]; c < pl->rend.v[q]; ++c) lower(&pl->first.v[c], pl->zbeg.v[q]);
    for (c = pl->rend.v[q]; c < pl->zend.v[q] && pl->rbeg.v[q] < pl->rend.v[q]; ++c)
      lower(&pl->first.v[c], pl->rbeg.v[q]);
  }
  t->nii = pl->iipair.n;
  t->nid = pl->idpair.n;
  return ok && list_dependent_pairs(d);
}

static int list_columns(maggi_data *d)
{
  return list_velocities(d) && list_mass(d);
}

/* all lists, with columns in the cheaper order */
static int list(maggi_data *d)
{
  double by_tree;

  if (!maggi_number_columns(d) || !maggi_list_islands(d) || !list_columns(d)) return 0;
  by_tree = maggi_columns_cost(d);
  if (!maggi_group_columns(d)) return 1;
  if (!list_columns(d)) return 0;
  if (maggi_columns_cost(d) < 0.9 * by_tree) return 1;
  return maggi_number_columns(d) && list_columns(d);
}

/* all lists from owner and rank, factors of the present position */
static maggi_status compile(maggi_data *d)
{
  maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  maggi_status status;
  int i, k, n;

  if (!list(d)) return maggi_data_fail(d, MAGGI_E_MEMORY, "out of memory");
#define X(name, size, text) t->name = pl->name.v;
  MAGGI_PLAN_LIST(X)
#undef X
  status = maggi_data_fit(d);
  if (status != MAGGI_OK) return status;
  maggi_evaluate_factors(d);
  for (k = 0; k < t->nisland; ++k) {
    n = t->isldep[k + 1] - t->isldep[k];
    for (i = 0; i < n; ++i) d->piv0[t->isldep[k] + i] = 1.0 / d->chol[t->islchol[k] + i * n + i];
  }
  return MAGGI_OK;
}

void maggi_plan_restart(maggi_data *d)
{
  maggi_planner_sort(&d->t, d->planner->order);
}

maggi_status maggi_plan(maggi_data *d, int avoid, double threshold)
{
  maggi_status status = maggi_choose(d, avoid, threshold);

  return status == MAGGI_OK ? compile(d) : status;
}

/* loops of an island go to the end of the order in which loops take their dependents */
static void demote(maggi_data *d, int island)
{
  maggi_planner *pl = d->planner;
  int i, n = 0, pass;

  for (pass = 0; pass < 2; ++pass)
    for (i = 0; i < d->t.nloop; ++i)
      if ((pl->loopisland[pl->previous_order[i]] == island) == pass)
        pl->order[n++] = pl->previous_order[i];
}

/* a choice in the present order of loops; whether its smallest pivot is much better than `old` */
static maggi_status try_choice(maggi_data *d, double old, int *better)
{
  maggi_planner *pl = d->planner;
  maggi_status status;
  int i, dep, rank = 0, old_rank = d->t.ndep;
  double ratio;

  *better = 0;
  status = maggi_choose(d, 0, 0.5);
  if (status != MAGGI_OK) return status;
  for (i = 0; i < d->t.nloop; ++i) rank += pl->rank[i];
  if (rank != old_rank || memcmp(pl->owner, pl->previous, (size_t)d->t.nq * sizeof(int)) == 0)
    return MAGGI_OK;
  status = compile(d);
  if (status != MAGGI_OK) return status;
  *better = maggi_smallest_pivot(d, &ratio, &dep) > 2.0 * old;
  return MAGGI_OK;
}

/* Other dependents, or, where loops are redundant in part, the same ones from other loops: those of
 * the island with the small pivot choose last. */
static maggi_status renew(maggi_data *d, int *changed)
{
  maggi_planner *pl = d->planner;
  maggi_status status;
  int dep, island;
  double old, ratio;

  old = maggi_smallest_pivot(d, &ratio, &dep);
  island = dep < 0 ? -1 : pl->loopisland[pl->owner[d->t.dep[dep]]];
  memcpy(pl->previous, pl->owner, (size_t)d->t.nq * sizeof(int));
  memcpy(pl->previous_order, pl->order, (size_t)d->t.nloop * sizeof(int));
  memcpy(pl->previous_island, pl->loopisland, (size_t)d->t.nloop * sizeof(int));
  memcpy(d->piv1, d->piv0, (size_t)d->t.nq * sizeof(double));
  status = try_choice(d, old, changed);
  if (status != MAGGI_OK || *changed) return status;
  memcpy(pl->loopisland, pl->previous_island, (size_t)d->t.nloop * sizeof(int));
  demote(d, island);
  status = try_choice(d, old, changed);
  if (status != MAGGI_OK || *changed) return status;

  /* nothing better: back to what was */
  return maggi_plan_load(d, &(maggi_saved_plan){pl->previous, pl->previous_order, d->piv1});
}

maggi_status maggi_plan_watch(maggi_data *d, int *is_new)
{
  maggi_status status;
  int changed;

  *is_new = 0;
  d->pivot_ratio = d->stage_ratio;
  if (d->pivot_ratio > 2.0 * MAGGI_RENEW_BELOW) d->replan_below = MAGGI_RENEW_BELOW;
  if (d->t.ndep == 0 || !(d->pivot_ratio < d->replan_below)) return MAGGI_OK;
  status = renew(d, &changed);
  if (status != MAGGI_OK) return status;
  d->changes += changed;
  d->replan_below = changed ? MAGGI_RENEW_BELOW : 0.5 * d->pivot_ratio;
  *is_new = 1;
  return MAGGI_OK;
}

/* ------------------------------------------------------------------------------ saved and loaded */

size_t maggi_saved_plan_size(const maggi_topo *t)
{
  size_t ints = (size_t)(t->nq + t->nloop) * sizeof(int);

  return (size_t)t->nq * sizeof(double) + (ints + 7) / 8 * 8;
}

void maggi_saved_plan_place(maggi_saved_plan *saved, const maggi_topo *t, void *memory)
{
  saved->piv0 = memory;
  saved->owner = (int *)(saved->piv0 + t->nq);
  saved->order = saved->owner + t->nq;
}

void maggi_plan_save(const maggi_data *d, const maggi_saved_plan *saved)
{
  const maggi_planner *pl = d->planner;
  const maggi_topo *t = &d->t;

  memcpy(saved->owner, pl->owner, (size_t)t->nq * sizeof(int));
  memcpy(saved->order, pl->order, (size_t)t->nloop * sizeof(int));
  memcpy(saved->piv0, d->piv0, (size_t)t->nq * sizeof(double));
}

int maggi_plan_is_saved(const maggi_data *d, const maggi_saved_plan *saved)
{
  const maggi_planner *pl = d->planner;
  const maggi_topo *t = &d->t;

  return memcmp(saved->owner, pl->owner, (size_t)t->nq * sizeof(int)) == 0 &&
         memcmp(saved->order, pl->order, (size_t)t->nloop * sizeof(int)) == 0;
}

maggi_status maggi_plan_load(maggi_data *d, const maggi_saved_plan *saved)
{
  maggi_planner *pl = d->planner;
  const maggi_topo *t = &d->t;
  maggi_status status;
  int i;

  memcpy(pl->order, saved->order, (size_t)t->nloop * sizeof(int));
  memcpy(pl->owner, saved->owner, (size_t)t->nq * sizeof(int));
  for (i = 0; i < t->nloop; ++i) pl->rank[i] = 0;
  for (i = 0; i < t->nq; ++i)
    if (pl->owner[i] >= 0) ++pl->rank[pl->owner[i]];
  status = compile(d);
  memcpy(d->piv0, saved->piv0, (size_t)t->nq * sizeof(double));
  return status;
}
