/* Islands: loops whose dependent coordinates must be solved together, in the order in which that can be
 * done. */
#include "plan.h"

/* Tarjan: a loop needs the loops on which coordinates of its path depend.  Components come out in
 * the order in which they can be solved. */
static int find_components(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int i, l, k, to, count = 0, n = 0, nstack = 0, depth;

  for (i = 0; i < t->nloop; ++i) pl->index[i] = pl->component[i] = -1;
  for (i = 0; i < t->nloop; ++i) {
    if (pl->index[i] >= 0) continue;
    depth = 0;
    pl->frame[0] = i;
    pl->at[i] = t->pathadr[i];
    pl->index[i] = pl->low[i] = count++;
    pl->stack[nstack++] = i;
    while (depth >= 0) {
      l = pl->frame[depth];
      if (pl->at[l] < t->pathadr[l + 1]) {
        to = pl->owner[t->pathq[pl->at[l]++]];
        if (to < 0 || to == l) continue;
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

/* a loop that determines nothing joins the last island that moves it, to bear its share there */
static int island_of_redundant(const maggi_data *d, int loop)
{
  const maggi_planner *pl = d->planner;
  int i, owner, last = -1;

  for (i = d->t.pathadr[loop]; i < d->t.pathadr[loop + 1]; ++i) {
    owner = pl->owner[d->t.pathq[i]];
    if (owner >= 0 && pl->loopisland[owner] > last) last = pl->loopisland[owner];
  }
  return last;
}

/* islands are the components that determine something; their loops, rows and dependents */
int maggi_list_islands(maggi_data *d)
{
  maggi_topo *t = &d->t;
  maggi_planner *pl = d->planner;
  int *island = pl->stack, *adr = pl->at, *fill = pl->frame; /* free again */
  int n = find_components(d), i, k, ok, rows;

  ok = maggi_sized(&pl->isldep, t->nloop1, 0) && maggi_sized(&pl->islprim, t->nloop1, 0) &&
       maggi_sized(&pl->islrow, t->nloop1, 0) && maggi_sized(&pl->islvop, t->nloop1, 0) &&
       maggi_sized(&pl->islent, t->nloop1, 0) && maggi_sized(&pl->islphi, t->nloop1, 0) &&
       maggi_sized(&pl->islchol, t->nloop1, 0) && maggi_sized(&pl->islbeg, t->nloop1, 0) &&
       maggi_sized(&pl->islend, t->nloop1, 0) && maggi_sized(&pl->dep, t->nq, 0) &&
       maggi_sized(&pl->primorder, t->nprim, 0) && maggi_sized(&pl->primy, t->nprim, 0) &&
       maggi_sized(&pl->primva, t->nprim, 0) && maggi_sized(&pl->primvb, t->nprim, 0);
  if (!ok) return 0;
  for (i = 0; i < n; ++i) island[i] = 0;
  for (i = 0; i < t->nloop; ++i) island[pl->component[i]] += pl->rank[i];
  k = 0;
  for (i = 0; i < n; ++i) island[i] = island[i] > 0 ? k++ : -1;
  t->nisland = k;
  for (i = 0; i < t->nloop; ++i) pl->loopisland[i] = island[pl->component[i]];
  for (i = 0; i < t->nloop; ++i)
    if (pl->loopisland[i] < 0) pl->loopisland[i] = island_of_redundant(d, i);

  /* counts, then addresses */
  for (i = 0; i < t->nq; ++i)
    if (pl->owner[i] >= 0) ++pl->isldep.v[pl->loopisland[pl->owner[i]] + 1];
  for (i = 0; i < t->nprim; ++i) {
    k = pl->loopisland[t->primloop[i]];
    if (k < 0) continue;
    ++pl->islprim.v[k + 1];
    pl->islrow.v[k + 1] += maggi_prim_rows(t->primkind[i]);
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
  for (k = 0; k < t->nisland; ++k) adr[k] = fill[k] = 0;
  for (i = 0; i < t->nq; ++i) {
    if (pl->owner[i] < 0) continue;
    k = pl->loopisland[pl->owner[i]];
    pl->local[i] = adr[k];
    pl->dep.v[pl->isldep.v[k] + adr[k]++] = i;
  }
  for (k = 0; k < t->nisland; ++k) adr[k] = 0;
  for (i = 0; i < t->nprim; ++i) {
    k = pl->loopisland[t->primloop[i]];
    if (k < 0) continue;
    pl->primorder.v[pl->islprim.v[k] + adr[k]++] = i;
    pl->primy.v[i] = pl->islrow.v[k] + fill[k];
    fill[k] += maggi_prim_rows(t->primkind[i]);
  }
  return 1;
}
