/* From the dependent coordinates of each loop to islands and the lists that the kernel follows. */
#include "plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* room for n integers set to value; false when out of memory */
static int sized(maggi_ints *list, int n, int value)
{
  int i, *v;

  if (n > list->cap || !list->v) {
    v = realloc(list->v, (size_t)(n + n / 4 + 16) * sizeof *v);
    if (!v)
      return 0;
    list->v = v;
    list->cap = n + n / 4 + 16;
  }
  for (i = 0; i < n; ++i)
    list->v[i] = value;
  list->n = n;
  return 1;
}

static int push(maggi_ints *list, int value)
{
  int n = list->n, *v;

  if (n == list->cap) {
    v = realloc(list->v, (size_t)(2 * n + 16) * sizeof *v);
    if (!v)
      return 0;
    list->v = v;
    list->cap = 2 * n + 16;
  }
  list->v[list->n++] = value;
  return 1;
}

static int *ints(int n)
{
  return calloc((size_t)n + 1, sizeof(int));
}

static int prim_rows(int kind)
{
  return kind == MAGGI_PRIM_POINT || kind == MAGGI_PRIM_AXIS ? 3 : 1;
}

/* loops by the length of their path, in the order of the file among equals */
static void sort_loops(const maggi_topo *t, int *order)
{
  int length, n = 0, loop, longest = 0;

  for (loop = 0; loop < t->nloop; ++loop)
    if (t->pathadr[loop + 1] - t->pathadr[loop] > longest)
      longest = t->pathadr[loop + 1] - t->pathadr[loop];
  for (length = 0; length <= longest; ++length)
    for (loop = 0; loop < t->nloop; ++loop)
      if (t->pathadr[loop + 1] - t->pathadr[loop] == length)
        order[n++] = loop;
}

maggi_status maggi_planner_create(const maggi_model *m, maggi_planner **planner)
{
  const maggi_topo *t = &m->topo;
  maggi_planner *pl;
  int ok, i;

  *planner = NULL;
  pl = calloc(1, sizeof *pl);
  if (!pl)
    return MAGGI_E_MEMORY;
  pl->order = ints(t->nloop);
  pl->loopprim = ints(t->nloop + 1);
  pl->owner = ints(t->nq);
  pl->previous = ints(t->nq);
  pl->rank = ints(t->nloop);
  pl->row = calloc((size_t)t->nq + 1, sizeof *pl->row);
  pl->candidate = ints(t->nq);
  pl->columnq = ints(t->nq);
  pl->sum = calloc((size_t)t->nq + 1, sizeof *pl->sum);
  pl->component = ints(t->nloop);
  pl->low = ints(t->nloop);
  pl->index = ints(t->nloop);
  pl->stack = ints(t->nloop);
  pl->frame = ints(t->nloop);
  pl->at = ints(t->nloop);
  pl->loopisland = ints(t->nloop);
  pl->local = ints(t->nq);
  pl->vhead = ints(t->nbody);
  pl->climb = ints(t->nbody);
  ok = pl->order && pl->loopprim && pl->owner && pl->previous && pl->rank && pl->row &&
       pl->candidate && pl->columnq && pl->sum && pl->component && pl->low && pl->index &&
       pl->stack && pl->frame && pl->at && pl->loopisland && pl->local && pl->vhead && pl->climb;
  if (!ok) {
    maggi_planner_free(pl);
    return MAGGI_E_MEMORY;
  }
  sort_loops(t, pl->order);
  for (i = 0; i < t->nprim; ++i)
    pl->loopprim[t->primloop[i] + 1] = i + 1;
  *planner = pl;
  return MAGGI_OK;
}

void maggi_planner_free(maggi_planner *pl)
{
  if (!pl)
    return;
  free(pl->order);
  free(pl->loopprim);
  free(pl->owner);
  free(pl->previous);
  free(pl->rank);
  free(pl->row);
  free(pl->poolq);
  free(pl->poolc);
  free(pl->candidate);
  free(pl->columnq);
  free(pl->matrix);
  free(pl->sum);
  free(pl->component);
  free(pl->low);
  free(pl->index);
  free(pl->stack);
  free(pl->frame);
  free(pl->at);
  free(pl->loopisland);
  free(pl->local);
  free(pl->vhead);
  free(pl->climb);
  free(pl->vbase.v);
  free(pl->vnext.v);
#define X(name, size, text) free(pl->name.v);
  MAGGI_PLAN_LIST(X)
#undef X
  free(pl);
}

/* ------------------------------------------------------------------------------------ columns */

/* independent coordinates from the leaves to the root, then guided ones */
static int number_columns(maggi_data *d)
{
  maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int i, pass;

  if (!sized(&pl->col, t->nq, -1) || !sized(&pl->colq, t->nq, -1))
    return 0;
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
    if (pass == 0)
      t->nind = t->ncol;
  }
  t->stride = (t->ncol + MAGGI_WIDTH - 1) / MAGGI_WIDTH * MAGGI_WIDTH;
  return 1;
}

/* ------------------------------------------------------------------------------------ islands */

/* Tarjan: a loop needs the loops on which coordinates of its path depend.  Components come out in
 * the order in which they can be solved. */
static int find_components(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int i, l, k, to, count = 0, n = 0, nstack = 0, depth;

  for (i = 0; i < t->nloop; ++i)
    pl->index[i] = pl->component[i] = -1;
  for (i = 0; i < t->nloop; ++i) {
    if (pl->index[i] >= 0)
      continue;
    depth = 0;
    pl->frame[0] = i;
    pl->at[i] = t->pathadr[i];
    pl->index[i] = pl->low[i] = count++;
    pl->stack[nstack++] = i;
    while (depth >= 0) {
      l = pl->frame[depth];
      if (pl->at[l] < t->pathadr[l + 1]) {
        to = pl->owner[t->pathq[pl->at[l]++]];
        if (to < 0 || to == l)
          continue;
        if (pl->index[to] < 0) {
          pl->frame[++depth] = to;
          pl->at[to] = t->pathadr[to];
          pl->index[to] = pl->low[to] = count++;
          pl->stack[nstack++] = to;
        } else if (pl->component[to] < 0 && pl->index[to] < pl->low[l]) {
          pl->low[l] = pl->index[to];
        }
        continue;
      }
      if (pl->low[l] == pl->index[l]) {
        do {
          k = pl->stack[--nstack];
          pl->component[k] = n;
        } while (k != l);
        ++n;
      }
      if (--depth >= 0 && pl->low[l] < pl->low[pl->frame[depth]])
        pl->low[pl->frame[depth]] = pl->low[l];
    }
  }
  return n;
}

/* islands are the components that determine something; their loops, rows and dependents */
static int list_islands(maggi_data *d)
{
  maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int *island = pl->stack, *adr = pl->at, *fill = pl->frame; /* free again */
  int n = find_components(d), i, k, ok, rows;

  ok = sized(&pl->isldep, t->nloop1, 0) && sized(&pl->islprim, t->nloop1, 0) &&
       sized(&pl->islrow, t->nloop1, 0) && sized(&pl->islvop, t->nloop1, 0) &&
       sized(&pl->islent, t->nloop1, 0) && sized(&pl->islphi, t->nloop1, 0) &&
       sized(&pl->islchol, t->nloop1, 0) && sized(&pl->islbeg, t->nloop1, 0) &&
       sized(&pl->islend, t->nloop1, 0) && sized(&pl->dep, t->nq, 0) &&
       sized(&pl->primorder, t->nprim, 0) && sized(&pl->primy, t->nprim, 0) &&
       sized(&pl->primva, t->nprim, 0) && sized(&pl->primvb, t->nprim, 0);
  if (!ok)
    return 0;
  for (i = 0; i < n; ++i)
    island[i] = 0;
  for (i = 0; i < t->nloop; ++i)
    island[pl->component[i]] += pl->rank[i];
  k = 0;
  for (i = 0; i < n; ++i)
    island[i] = island[i] > 0 ? k++ : -1;
  t->nisland = k;
  for (i = 0; i < t->nloop; ++i)
    pl->loopisland[i] = island[pl->component[i]];

  /* counts, then addresses */
  for (i = 0; i < t->nq; ++i)
    if (pl->owner[i] >= 0)
      ++pl->isldep.v[pl->loopisland[pl->owner[i]] + 1];
  for (i = 0; i < t->nprim; ++i) {
    k = pl->loopisland[t->primloop[i]];
    if (k < 0)
      continue;
    ++pl->islprim.v[k + 1];
    pl->islrow.v[k + 1] += prim_rows(t->primkind[i]);
  }
  for (k = 0; k < t->nisland; ++k) {
    n = pl->isldep.v[k + 1];
    rows = pl->islrow.v[k + 1];
    pl->islphi.v[k + 1] = pl->islphi.v[k] + rows * n;
    pl->islchol.v[k + 1] = pl->islchol.v[k] + n * n;
    pl->isldep.v[k + 1] += pl->isldep.v[k];
    pl->islprim.v[k + 1] += pl->islprim.v[k];
    pl->islrow.v[k + 1] += pl->islrow.v[k];
  }
  t->nphi = pl->islphi.v[t->nisland];
  t->nchol = pl->islchol.v[t->nisland];
  for (k = 0; k < t->nisland; ++k)
    adr[k] = fill[k] = 0;
  for (i = 0; i < t->nq; ++i) {
    if (pl->owner[i] < 0)
      continue;
    k = pl->loopisland[pl->owner[i]];
    pl->local[i] = adr[k];
    pl->dep.v[pl->isldep.v[k] + adr[k]++] = i;
  }
  for (k = 0; k < t->nisland; ++k)
    adr[k] = 0;
  for (i = 0; i < t->nprim; ++i) {
    k = pl->loopisland[t->primloop[i]];
    if (k < 0)
      continue;
    pl->primorder.v[pl->islprim.v[k] + adr[k]++] = i;
    pl->primy.v[i] = pl->islrow.v[k] + fill[k];
    fill[k] += prim_rows(t->primkind[i]);
  }
  return 1;
}

/* ---------------------------------------------------------------------------------- velocities */

static void widen(int *begin, int *end, int b, int e)
{
  if (b >= e)
    return;
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
  if (!push(&pl->vrowbeg, begin) || !push(&pl->vrowend, end) || !push(&pl->vbase, base) ||
      !push(&pl->vnext, -1) || !push(&pl->vopdst, row) || !push(&pl->vopsrc, src) ||
      !push(&pl->vopq, q))
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
    if (t->qid[body] < 0)
      continue;
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
    if (t->pathside[i] != side)
      continue;
    if (pl->owner[q] >= 0 && pl->loopisland[pl->owner[q]] == island) {
      if (row < 0)
        row = row_of_body(d, t->parent[t->qbody[q]], base);
    } else if (row >= 0) {
      row = add_row(d, -1, row, q);
    } else {
      continue;
    }
    if (row < 0)
      return -1;
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
    if (pl->owner[q] < 0 || pl->loopisland[pl->owner[q]] != island)
      continue;
    adr = pl->islphi.v[island] + (pl->primy.v[prim] - pl->islrow.v[island]) * n + pl->local[q];
    if (!push(&pl->entprim, prim) || !push(&pl->entside, t->pathside[i]) || !push(&pl->entq, q) ||
        !push(&pl->entadr, adr) || !push(&pl->entstep, n))
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

  if (!sized(&pl->rbeg, t->nq, 0) || !sized(&pl->rend, t->nq, 0))
    return 0;
  for (i = 0; i < t->ncol; ++i) {
    pl->rbeg.v[pl->colq.v[i]] = i;
    pl->rend.v[pl->colq.v[i]] = i + 1;
  }
  for (i = 0; i < t->nbody; ++i)
    pl->vhead[i] = -1;
  pl->vrowbeg.n = pl->vrowend.n = pl->vbase.n = pl->vnext.n = 0;
  pl->vopdst.n = pl->vopsrc.n = pl->vopq.n = 0;
  pl->entprim.n = pl->entside.n = pl->entq.n = pl->entadr.n = pl->entstep.n = 0;
  if (!push(&pl->vrowbeg, 0) || !push(&pl->vrowend, 0) || !push(&pl->vbase, -1) ||
      !push(&pl->vnext, -1))
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
        if (va < 0 || vb < 0)
          return 0;
        widen(&begin, &end, pl->vrowbeg.v[va], pl->vrowend.v[va]);
        widen(&begin, &end, pl->vrowbeg.v[vb], pl->vrowend.v[vb]);
      }
      pl->primva.v[prim] = va;
      pl->primvb.v[prim] = vb;
      if (!push_entries(d, prim, k))
        return 0;
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
  if (value < *first)
    *first = value;
}

static int list_mass(maggi_data *d)
{
  maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int k, i, j, ci, cj, c, q, src, dst, ok = 1;

  pl->iipair.n = pl->iirow.n = pl->iicol.n = 0;
  pl->idpair.n = pl->iddep.n = pl->idcol.n = 0;
  pl->ddpair.n = pl->dddst.n = pl->ddsrc.n = 0;
  if (!sized(&pl->first, t->nq, 0) || !sized(&pl->zbeg, t->nq, 0) || !sized(&pl->zend, t->nq, 0))
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
      ok = push(&pl->iipair, k) && push(&pl->iirow, ci > cj ? cj : ci) &&
           push(&pl->iicol, ci > cj ? ci : cj);
      lower(&pl->first.v[ci > cj ? ci : cj], ci > cj ? cj : ci);
    } else if (ci >= 0 || cj >= 0) {
      q = ci >= 0 ? j : i;
      c = ci >= 0 ? ci : cj;
      ok = push(&pl->idpair, k) && push(&pl->iddep, q) && push(&pl->idcol, c);
      widen(&pl->zbeg.v[q], &pl->zend.v[q], c, c + 1);
    } else {
      src = pl->rend.v[i] - pl->rbeg.v[i] < pl->rend.v[j] - pl->rbeg.v[j] ? i : j;
      dst = i + j - src;
      ok = push(&pl->ddpair, k) && push(&pl->dddst, dst) && push(&pl->ddsrc, src);
      widen(&pl->zbeg.v[dst], &pl->zend.v[dst], pl->rbeg.v[src], pl->rend.v[src]);
    }
  }
  for (i = 0; i < t->ndep; ++i) {
    q = pl->dep.v[i];
    for (c = pl->rbeg.v[q]; c < pl->rend.v[q]; ++c)
      lower(&pl->first.v[c], pl->zbeg.v[q]);
    for (c = pl->rend.v[q]; c < pl->zend.v[q] && pl->rbeg.v[q] < pl->rend.v[q]; ++c)
      lower(&pl->first.v[c], pl->rbeg.v[q]);
  }
  t->nii = pl->iipair.n;
  t->nid = pl->idpair.n;
  t->ndd = pl->ddpair.n;
  return ok;
}

/* all lists from owner and rank, factors of the present position */
static maggi_status compile(maggi_data *d)
{
  maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  maggi_status status;
  int i, k, n;

  if (!number_columns(d) || !list_islands(d) || !list_velocities(d) || !list_mass(d))
    return maggi_data_fail(d, MAGGI_E_MEMORY, "out of memory");
#define X(name, size, text) t->name = pl->name.v;
  MAGGI_PLAN_LIST(X)
#undef X
  status = maggi_data_fit(d);
  if (status != MAGGI_OK)
    return status;
  maggi_evaluate_factors(d);
  for (k = 0; k < t->nisland; ++k) {
    n = t->isldep[k + 1] - t->isldep[k];
    for (i = 0; i < n; ++i)
      d->piv0[t->isldep[k] + i] = 1.0 / d->chol[t->islchol[k] + i * n + i];
  }
  return MAGGI_OK;
}

maggi_status maggi_plan(maggi_data *d, int avoid, double threshold)
{
  maggi_status status = maggi_choose(d, avoid, threshold);

  return status == MAGGI_OK ? compile(d) : status;
}

static int same_choice(const maggi_data *d)
{
  const maggi_planner *pl = d->planner;
  int i;

  for (i = 0; i < d->t.nq; ++i)
    if ((pl->owner[i] < 0) != (pl->previous[i] < 0))
      return 0;
  return 1;
}

maggi_status maggi_plan_renew(maggi_data *d, int *changed)
{
  maggi_planner *pl = d->planner;
  maggi_status status;
  size_t size = (size_t)d->t.nq * sizeof(int);
  int i, dep, rank = 0, old_rank = d->t.ndep;
  double old, ratio;

  *changed = 0;
  old = maggi_smallest_pivot(d, &ratio, &dep);
  memcpy(pl->previous, pl->owner, size);
  memcpy(d->piv1, d->piv0, (size_t)d->t.nq * sizeof(double));
  status = maggi_choose(d, 0, 0.5);
  if (status != MAGGI_OK)
    return status;
  for (i = 0; i < d->t.nloop; ++i)
    rank += pl->rank[i];
  if (rank == old_rank && !same_choice(d)) {
    status = compile(d);
    if (status != MAGGI_OK)
      return status;
    *changed = maggi_smallest_pivot(d, &ratio, &dep) > 2.0 * old;
    if (*changed)
      return MAGGI_OK;
  }
  /* nothing better: back to what was */
  memcpy(pl->owner, pl->previous, size);
  for (i = 0; i < d->t.nloop; ++i)
    pl->rank[i] = 0;
  for (i = 0; i < d->t.nq; ++i)
    if (pl->owner[i] >= 0)
      ++pl->rank[pl->owner[i]];
  status = compile(d);
  memcpy(d->piv0, d->piv1, (size_t)d->t.nq * sizeof(double));
  return status;
}
