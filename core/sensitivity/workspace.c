/* Memory of the derivatives. */
#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "derivative.h"

/* a multiple of a cache line */
static size_t block(size_t n)
{
  return (n + 7) / 8 * 8;
}

static double *numbers(size_t n)
{
  size_t size = (block(n) + 8) * sizeof(double);
  double *a = aligned_alloc(64, size);

  if (a) memset(a, 0, size);
  return a;
}

/* places of the constants of a companion, from `at` on; how many numbers these are */
size_t maggi_place_constants(maggi_companion *s, const maggi_topo *t, double *at)
{
  size_t n = 0;

#define X(name, numbers)                                                                           \
  s->name = at ? at + n : NULL;                                                                    \
  n += block((size_t)(numbers) * (size_t)s->width);
  MAGGI_ACTIVE_CONSTANTS(X)
#undef X
  return n;
}

static size_t place_motion(maggi_companion *s, const maggi_topo *t, double *at)
{
  size_t n = 0;

#define X(name, numbers)                                                                           \
  s->name = at ? at + n : NULL;                                                                    \
  n += block((size_t)(numbers) * (size_t)s->width);
  MAGGI_ACTIVE_LIST(X)
#undef X
  return n;
}

/* n sets of constants */
static int companion_create(maggi_companion *s, const maggi_topo *t, int width, int n)
{
  s->width = width;
  s->nconstants = maggi_place_constants(s, t, NULL);
  s->nmotion = place_motion(s, t, NULL);
  s->constants = numbers(s->nconstants * (size_t)n);
  s->motion = numbers(s->nmotion);
  if (!s->constants || !s->motion) return 0;
  maggi_place_constants(s, t, s->constants);
  place_motion(s, t, s->motion);
  return 1;
}

static void companion_free(maggi_companion *s)
{
  free(s->constants);
  free(s->motion);
  free(s->phi);
}

/* room for n numbers that the plan sizes, zeroed */
static int fit_numbers(double **a, size_t *cap, size_t n)
{
  if (*a && n <= *cap) {
    memset(*a, 0, n * sizeof(double));
    return 1;
  }
  free(*a);
  *cap = n + n / 4 + 64; /* room for another choice of coordinates */
  *a = numbers(*cap);
  if (!*a) *cap = 0;
  return *a != NULL;
}

/* blocks of Phi: what the plan does not list stays zero */
static int companion_fit(maggi_companion *s, const maggi_topo *t)
{
  s->nphi = (size_t)t->nphi * (size_t)s->width;
  return fit_numbers(&s->phi, &s->capphi, s->nphi);
}

void maggi_companion_clear(const maggi_companion *s)
{
  memset(s->motion, 0, s->nmotion * sizeof(double));
  memset(s->phi, 0, s->nphi * sizeof(double));
}

static int place_solves(maggi_derivative *D)
{
  const maggi_topo *t = &D->d->t;
  size_t n = 0;

#define X(name, numbers) n += block((size_t)(numbers));
  MAGGI_SOLVE_LIST(X)
#undef X
  D->memory = numbers(n);
  if (!D->memory) return 0;
  n = 0;
#define X(name, numbers)                                                                           \
  D->name = D->memory + n;                                                                         \
  n += block((size_t)(numbers));
  MAGGI_SOLVE_LIST(X)
#undef X
  return 1;
}

/* Lists of the islands with the dependent coordinates alone: where another one moves, a velocity row is
 * that of its source, and row 0 is at rest. */
static void list_islands(maggi_derivative *D)
{
  const maggi_topo *t = &D->d->t;
  int i, k, prim, row, y = 0, n = 0;

  D->t = *t;
  D->t.islvop = D->islvop;
  D->t.vopdst = D->vopdst;
  D->t.vopsrc = D->vopsrc;
  D->t.vopq = D->vopq;
  D->t.primva = D->primva;
  D->t.primvb = D->primvb;
  D->redundant = 0;
  D->same[0] = 0;
  for (k = 0; k < t->nisland; ++k) {
    D->islvop[k] = n;
    for (i = t->islvop[k]; i < t->islvop[k + 1]; ++i) {
      D->same[t->vopdst[i]] = D->same[t->vopsrc[i]];
      if (t->col[t->vopq[i]] >= 0) continue;
      D->same[t->vopdst[i]] = t->vopdst[i];
      D->vopdst[n] = t->vopdst[i];
      D->vopsrc[n] = D->same[t->vopsrc[i]];
      D->vopq[n++] = t->vopq[i];
    }
    if (t->islrow[k + 1] - t->islrow[k] > t->isldep[k + 1] - t->isldep[k]) D->redundant = 1;
    D->coupled[k] = 0;
    for (i = t->islprim[k]; i < t->islprim[k + 1]; ++i) {
      prim = t->primorder[i];
      D->primva[prim] = D->same[t->primva[prim]];
      D->primvb[prim] = D->same[t->primvb[prim]];
      if (D->primva[prim] > 0 || D->primvb[prim] > 0) D->coupled[k] = 1;
      for (row = 0; row < maggi_prim_rows(t->primkind[prim]); ++row)
        D->rowloop[y++] = t->primrow[prim] + row;
    }
  }
  D->islvop[t->nisland] = n;
}

/* what depends on the choice of the independent coordinates */
maggi_status maggi_derivative_fit(maggi_derivative *D)
{
  const maggi_topo *t = &D->d->t;

  if (D->plan == D->d->plans) return MAGGI_OK;
  if (!fit_numbers(&D->V, &D->capV, (size_t)t->nvrow * 6 * MAGGI_NDIR) ||
      !companion_fit(&D->tangent, t) || !companion_fit(&D->strip, t) ||
      !companion_fit(&D->adjoint, t) || !companion_fit(&D->second, t))
    return maggi_data_fail(D->d, MAGGI_E_MEMORY, "out of memory");
  memset(D->x, 0, (size_t)t->nq * sizeof(double));
  memset(D->xs, 0, (size_t)t->nq * MAGGI_NDIR * sizeof(double));
  list_islands(D);
  D->plan = D->d->plans;
  return MAGGI_OK;
}

maggi_status maggi_derivative_create(maggi_data *d, int ndirection, maggi_derivative **derivative)
{
  const maggi_topo *t = &d->t;
  maggi_derivative *D;
  int ok;

  assert(ndirection >= 0);
  *derivative = NULL;
  D = calloc(1, sizeof *D);
  if (!D) return MAGGI_E_MEMORY;
  D->d = d;
  D->nkept = ndirection > MAGGI_NDIR ? (ndirection + MAGGI_NDIR - 1) / MAGGI_NDIR : 1;
  ok = place_solves(D) && companion_create(&D->tangent, t, 1, 1) &&
       companion_create(&D->strip, t, MAGGI_NDIR, D->nkept) &&
       companion_create(&D->adjoint, t, 1, 1) && companion_create(&D->second, t, 1, 1);
#define X(name, size)                                                                              \
  D->name = calloc((size_t)(size) + 1, sizeof(int));                                               \
  ok = ok && D->name;
  MAGGI_ISLAND_LIST(X)
#undef X
  if (!ok || (d->plans > 0 && maggi_derivative_fit(D) != MAGGI_OK)) {
    maggi_derivative_free(D);
    return MAGGI_E_MEMORY;
  }
  *derivative = D;
  return MAGGI_OK;
}

void maggi_derivative_free(maggi_derivative *D)
{
  if (!D) return;
  companion_free(&D->tangent);
  companion_free(&D->strip);
  companion_free(&D->adjoint);
  companion_free(&D->second);
#define X(name, size) free(D->name);
  MAGGI_ISLAND_LIST(X)
#undef X
  free(D->V);
  free(D->memory);
  free(D);
}
