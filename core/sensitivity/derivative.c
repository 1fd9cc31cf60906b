/* Memory of the derivatives, and the functions of the user. */
#include "derivative.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "implicit.h"

/* ---------------------------------------------------------------------------------------- memory */

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
static size_t place_constants(maggi_companion *s, const maggi_topo *t, double *at)
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
  s->nconstants = place_constants(s, t, NULL);
  s->nmotion = place_motion(s, t, NULL);
  s->constants = numbers(s->nconstants * (size_t)n);
  s->motion = numbers(s->nmotion);
  if (!s->constants || !s->motion) return 0;
  place_constants(s, t, s->constants);
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

static void companion_clear(const maggi_companion *s)
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
static maggi_status fit(maggi_derivative *D)
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
  if (!ok || (d->plans > 0 && fit(D) != MAGGI_OK)) {
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

/* ------------------------------------------------------------------------------- the evaluation */

maggi_status maggi_linearise_at(maggi_derivative *D, double time)
{
  maggi_status status = fit(D);

  if (status != MAGGI_OK) return status;
  D->time = time;
  maggi_balance(D->d);
  if (D->d->t.ndep > 0) maggi_remainders(D->d);
  return MAGGI_OK;
}

maggi_status maggi_linearise(maggi_derivative *D)
{
  maggi_data *d = D->d;

  if (!d->ready)
    return maggi_data_fail(d, MAGGI_E_MODEL, "derivatives need a successful reset before them");
  if (d->is_ahead) maggi_evaluate(d, d->time);
  if (!(d->stage_ratio > 0.0))
    return maggi_data_fail(d, MAGGI_E_NOT_FINITE, "a singular position has no derivatives");
  return maggi_linearise_at(D, d->time);
}

/* -------------------------------------------------------------------------------- parameters */

void maggi_parameters_jvp(maggi_derivative *D, const double *p)
{
  if (p) {
    memcpy(D->tangent.p, p, (size_t)D->d->t.np * sizeof(double));
    maggi_tangent_constants(D);
  } else if (D->tangent_moves) {
    memset(D->tangent.constants, 0, D->tangent.nconstants * sizeof(double));
  }
  D->tangent_moves = p != NULL;
}

/* constants of the strip that holds the direction `first` */
static void choose_strip(maggi_derivative *D, int first)
{
  place_constants(&D->strip, &D->d->t,
                  D->strip.constants + (size_t)(first / MAGGI_NDIR) * D->strip.nconstants);
}

/* row of at most MAGGI_NDIR directions, zeros after them */
static void load_row(int n, const double *from, double *to)
{
  int c;

  for (c = 0; c < MAGGI_NDIR; ++c) to[c] = c < n ? from[c] : 0.0;
}

void maggi_parameters_jac(maggi_derivative *D, int n, int ld, const double *p)
{
  int i, first;

  assert(n <= D->nkept * MAGGI_NDIR);
  if (!p && D->kept_move)
    memset(D->strip.constants, 0, D->strip.nconstants * (size_t)D->nkept * sizeof(double));
  for (first = 0; p && first < n; first += MAGGI_NDIR) {
    choose_strip(D, first);
    for (i = 0; i < D->d->t.np; ++i)
      load_row(n - first, p + (size_t)i * (size_t)ld + first, D->strip.p + i * MAGGI_NDIR);
    maggi_strip_constants(D);
  }
  D->kept_move = p != NULL;
}

void maggi_parameters_clear(maggi_derivative *D)
{
  memset(D->adjoint.constants, 0, D->adjoint.nconstants * sizeof(double));
}

void maggi_parameters_vjp(maggi_derivative *D, double *p)
{
  maggi_adjoint_constants(D);
  memcpy(p, D->adjoint.p, (size_t)D->d->t.np * sizeof(double));
}

/* ------------------------------------------------------------------------------------- states */

/* internal order from that of the user; x may be NULL: zeros */
static void scatter(const maggi_data *d, const double *x, double *to)
{
  int i;

  for (i = 0; i < d->m->ncoordinate; ++i) to[d->m->coordinate[i].q] = x ? x[i] : 0.0;
}

static void gather(const maggi_data *d, const double *from, double *x)
{
  int i;

  for (i = 0; i < d->m->ncoordinate && x; ++i) x[i] = from[d->m->coordinate[i].q];
}

/* only of independent coordinates */
static void gather_independent(const maggi_data *d, const double *from, double *x)
{
  int i, q;

  for (i = 0; i < d->m->ncoordinate && x; ++i) {
    q = d->m->coordinate[i].q;
    x[i] = d->t.col[q] >= 0 && d->t.col[q] < d->t.nind ? from[q] : 0.0;
  }
}

void maggi_state_jvp(maggi_derivative *D, const double *q, const double *v, double *v_out,
                     double *a_out)
{
  scatter(D->d, q, D->tangent.q);
  scatter(D->d, v, D->tangent.v);
  maggi_tangent_motion(D);
  gather(D->d, D->tangent.v, v_out);
  gather(D->d, D->tangent.a, a_out);
}

static void scatter_strip(const maggi_data *d, int n, int ld, const double *x, double *to)
{
  static const double zeros[MAGGI_NDIR];
  int i;

  for (i = 0; i < d->m->ncoordinate; ++i)
    load_row(x ? n : 0, x ? x + (size_t)i * (size_t)ld : zeros,
             to + d->m->coordinate[i].q * MAGGI_NDIR);
}

static void gather_strip(const maggi_data *d, int n, int ld, const double *from, double *x)
{
  int i, c;

  n = n < MAGGI_NDIR ? n : MAGGI_NDIR;
  for (i = 0; i < d->m->ncoordinate; ++i)
    for (c = 0; c < n; ++c)
      x[(size_t)i * (size_t)ld + (size_t)c] = from[d->m->coordinate[i].q * MAGGI_NDIR + c];
}

void maggi_state_jac(maggi_derivative *D, int n, int ld, const double *q, const double *v,
                     double *v_out, double *a_out)
{
  int first;

  for (first = 0; first < n; first += MAGGI_NDIR) {
    choose_strip(D, first);
    scatter_strip(D->d, n - first, ld, q ? q + first : NULL, D->strip.q);
    scatter_strip(D->d, n - first, ld, v ? v + first : NULL, D->strip.v);
    maggi_strip_motion(D);
    if (v_out) gather_strip(D->d, n - first, ld, D->strip.v, v_out + first);
    if (a_out) gather_strip(D->d, n - first, ld, D->strip.a, a_out + first);
  }
}

static void start_adjoint(maggi_derivative *D, const double *v_bar, const double *a_bar)
{
  companion_clear(&D->adjoint);
  scatter(D->d, v_bar, D->adjoint.v);
  scatter(D->d, a_bar, D->adjoint.a);
}

void maggi_state_vjp(maggi_derivative *D, const double *v_bar, const double *a_bar, double *q_out,
                     double *v_out)
{
  start_adjoint(D, v_bar, a_bar);
  maggi_adjoint_motion(D);
  gather(D->d, D->adjoint.q, q_out);
  gather_independent(D->d, D->adjoint.v, v_out);
}

/* -------------------------------------------------------------------------- functions of the user */

void maggi_motion_jvp(maggi_derivative *D, const double *q, const double *v, const double *p,
                      double *v_out, double *a_out)
{
  maggi_parameters_jvp(D, p);
  maggi_state_jvp(D, q, v, v_out, a_out);
}

void maggi_motion_jac(maggi_derivative *D, int n, const double *q, const double *v, const double *p,
                      double *v_out, double *a_out)
{
  int first, part, kept = D->nkept * MAGGI_NDIR;

  for (first = 0; first < n; first += kept) {
    part = n - first < kept ? n - first : kept;
    maggi_parameters_jac(D, part, n, p ? p + first : NULL);
    maggi_state_jac(D, part, n, q ? q + first : NULL, v ? v + first : NULL,
                    v_out ? v_out + first : NULL, a_out ? a_out + first : NULL);
  }
}

void maggi_motion_vjp(maggi_derivative *D, const double *v_bar, const double *a_bar, double *q_out,
                      double *v_out, double *p_out)
{
  maggi_parameters_clear(D);
  maggi_state_vjp(D, v_bar, a_bar, q_out, v_out);
  if (p_out) maggi_parameters_vjp(D, p_out);
}

void maggi_motion_hvp(maggi_derivative *D, const double *v_bar, const double *a_bar,
                      const double *q, const double *v, const double *p, double *q_out,
                      double *v_out, double *p_out)
{
  maggi_parameters_jvp(D, p);
  maggi_state_jvp(D, q, v, NULL, NULL);
  maggi_tangent_forces(D);
  maggi_parameters_clear(D);
  start_adjoint(D, v_bar, a_bar);
  companion_clear(&D->second);
  memset(D->second.constants, 0, D->second.nconstants * sizeof(double));
  maggi_second_motion(D);
  gather(D->d, D->second.q, q_out);
  gather_independent(D->d, D->second.v, v_out);
  if (!p_out) return;
  maggi_second_constants(D);
  memcpy(p_out, D->second.p, (size_t)D->d->t.np * sizeof(double));
}
