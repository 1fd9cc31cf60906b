/* Memory of the planner and its lists. */
#include "plan.h"

#include <stdlib.h>

/* room for n integers set to value; false when out of memory */
int maggi_sized(maggi_ints *list, int n, int value)
{
  int i, *v;

  if (n > list->cap || !list->v) {
    v = realloc(list->v, (size_t)(n + n / 4 + 16) * sizeof *v);
    if (!v) return 0;
    list->v = v;
    list->cap = n + n / 4 + 16;
  }
  for (i = 0; i < n; ++i) list->v[i] = value;
  list->n = n;
  return 1;
}

int maggi_push_int(maggi_ints *list, int value)
{
  int n = list->n, *v;

  if (n == list->cap) {
    v = realloc(list->v, (size_t)(2 * n + 16) * sizeof *v);
    if (!v) return 0;
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

/* loops by the length of their path, in the order of the file among equals */
void maggi_planner_sort(const maggi_topo *t, int *order)
{
  int length, n = 0, loop, longest = 0;

  for (loop = 0; loop < t->nloop; ++loop)
    if (t->pathadr[loop + 1] - t->pathadr[loop] > longest)
      longest = t->pathadr[loop + 1] - t->pathadr[loop];
  for (length = 0; length <= longest; ++length)
    for (loop = 0; loop < t->nloop; ++loop)
      if (t->pathadr[loop + 1] - t->pathadr[loop] == length) order[n++] = loop;
}

/* the longest that the lists can become, so that another choice while running allocates nothing */
static int reserve(maggi_planner *pl, const maggi_topo *t)
{
  maggi_ints *pairs[] = {&pl->iipair, &pl->iirow, &pl->iicol,  &pl->idpair,
                         &pl->iddep,  &pl->idcol, &pl->ddpair, &pl->ddsrc};
  maggi_ints *rows[] = {&pl->vrowbeg, &pl->vrowend, &pl->vbase, &pl->vnext,
                        &pl->vopdst,  &pl->vopsrc,  &pl->vopq};
  maggi_ints *entries[] = {&pl->entprim, &pl->entside, &pl->entq, &pl->entadr, &pl->entstep};
  int i, ok = 1, nrow = 1 + 2 * t->npath, nent = 0;

  for (i = 0; i < t->nprim; ++i)
    nent += t->pathadr[t->primloop[i] + 1] - t->pathadr[t->primloop[i]];
  for (i = 0; i < (int)(sizeof pairs / sizeof *pairs); ++i)
    ok = maggi_sized(pairs[i], t->npair, 0) && ok;
  for (i = 0; i < (int)(sizeof rows / sizeof *rows); ++i) ok = maggi_sized(rows[i], nrow, 0) && ok;
  for (i = 0; i < (int)(sizeof entries / sizeof *entries); ++i)
    ok = maggi_sized(entries[i], nent, 0) && ok;
  return ok;
}

maggi_status maggi_planner_create(const maggi_model *m, maggi_planner **planner)
{
  const maggi_topo *t = &m->topo;
  maggi_planner *pl;
  int ok, i;

  *planner = NULL;
  pl = calloc(1, sizeof *pl);
  if (!pl) return MAGGI_E_MEMORY;
  pl->order = ints(t->nloop);
  pl->loopprim = ints(t->nloop + 1);
  pl->owner = ints(t->nq);
  pl->previous = ints(t->nq);
  pl->previous_order = ints(t->nloop);
  pl->previous_island = ints(t->nloop);
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
  pl->group = ints(t->nq);
  pl->groupsize = ints(t->nq);
  ok = pl->order && pl->loopprim && pl->owner && pl->previous && pl->previous_order &&
       pl->previous_island && pl->rank && pl->row && pl->candidate && pl->columnq && pl->sum &&
       pl->component && pl->low && pl->index && pl->stack && pl->frame && pl->at &&
       pl->loopisland && pl->local && pl->vhead && pl->climb && pl->group && pl->groupsize &&
       reserve(pl, t);
  if (!ok) {
    maggi_planner_free(pl);
    return MAGGI_E_MEMORY;
  }
  maggi_planner_sort(t, pl->order);
  for (i = 0; i < t->nprim; ++i) pl->loopprim[t->primloop[i] + 1] = i + 1;
  *planner = pl;
  return MAGGI_OK;
}

void maggi_planner_free(maggi_planner *pl)
{
  if (!pl) return;
  free(pl->order);
  free(pl->loopprim);
  free(pl->owner);
  free(pl->previous);
  free(pl->previous_order);
  free(pl->previous_island);
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
  free(pl->group);
  free(pl->groupsize);
  free(pl->vbase.v);
  free(pl->vnext.v);
#define X(name, size, text) free(pl->name.v);
  MAGGI_PLAN_LIST(X)
#undef X
  free(pl);
}
