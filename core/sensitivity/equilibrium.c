/* Newton's method for static equilibrium, and its derivatives. */
#include "equilibrium.h"

#include "closing.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { W = MAGGI_NDIR, ITERATIONS = 40, HALVINGS = 6, ROUNDS = 4 };

/* how Newton's method ends */
enum { FOUND, SINGULAR, STUCK };

static const double too_far = 0.5; /* correction of a coordinate [m, rad] */
static const double small_enough = 1e-12;
static const double round_off = 1e-9; /* corrections that do not become smaller any more */

/* ------------------------------------------------------------------------------------ evaluation */

void maggi_equilibrium_rest(maggi_equilibrium *e)
{
  memset(e->x->vcol, 0, (size_t)e->x->t.nind * sizeof(double));
  maggi_evaluate(e->x, 0.0);
}

maggi_status maggi_equilibrium_linearise(maggi_equilibrium *e)
{
  const maggi_topo *t = &e->x->t;
  const maggi_companion *s = &e->D->strip;
  maggi_status status = maggi_linearise_at(e->D, 0.0);
  int first, c, i, n = t->nind;

  maggi_strip_choose(e->D, 0); /* constants at rest */
  for (first = 0; first < n && status == MAGGI_OK; first += W) {
    memset(s->q, 0, (size_t)t->nq * W * sizeof(double));
    memset(s->v, 0, (size_t)t->nq * W * sizeof(double));
    for (c = 0; c < W && first + c < n; ++c) s->q[t->colq[first + c] * W + c] = 1.0;
    maggi_strip_closure(e->D);
    maggi_strip_motion(e->D);
    for (i = 0; i < n; ++i)
      for (c = 0; c < W && first + c < n; ++c) e->J[i * n + first + c] = s->a[t->colq[i] * W + c];
  }
  return status;
}

double maggi_equilibrium_largest(const maggi_equilibrium *e, const double *move)
{
  double largest = 0.0;
  int i;

  for (i = 0; i < e->x->t.nind; ++i)
    if (!(fabs(move[i]) <= largest)) largest = fabs(move[i]);
  return largest;
}

/* the present choice of coordinates, or a better one */
static int evaluate_watched(maggi_equilibrium *e)
{
  maggi_data *x = e->x;
  int i, is_new;

  maggi_equilibrium_rest(e);
  if (maggi_plan_watch(x, &is_new) != MAGGI_OK) return 0;
  if (is_new) maggi_equilibrium_rest(e);
  for (i = 0; i < x->t.nind; ++i)
    if (!isfinite(x->acol[i])) return 0;
  return !maggi_is_singular(x);
}

int maggi_equilibrium_move(maggi_equilibrium *e, const double *move, double factor)
{
  maggi_data *x = e->x;
  const maggi_topo *t = &x->t;
  size_t bytes = (size_t)t->nq * sizeof(double);
  int i;

  for (i = 0; i < t->ncol; ++i) x->vcol[i] = i < t->nind ? factor * move[i] : 0.0;
  maggi_expand(t, x->R, x->vcol, x->zero, x->v);
  for (i = 0; i < t->nq; ++i) x->q[i] = e->q[i] + x->v[i];
  if (maggi_project(x, 0.0) == MAGGI_OK && evaluate_watched(e)) return 1;
  memcpy(x->q, e->q, bytes);
  maggi_equilibrium_rest(e);
  return 0;
}

/* ---------------------------------------------------------------------------------------- Newton */

/* factors of J, or false with a direction in `next` in which no acceleration changes */
static int factor(maggi_equilibrium *e)
{
  if (maggi_dense_factor(&e->factor, e->x->t.nind, e->J)) return 1;
  memcpy(e->next, e->factor.work, (size_t)e->x->t.nind * sizeof(double));
  return 0;
}

static void correct(const maggi_equilibrium *e, double *move)
{
  int i;

  for (i = 0; i < e->x->t.nind; ++i) move[i] = -e->x->acol[i];
  maggi_dense_solve(&e->factor, move);
}

/* one step of Newton's method, shortened until the correction that would follow with the same J is smaller
 * (the natural monotonicity test, which does not depend on units of forces) */
static int shorten(maggi_equilibrium *e, double size)
{
  long plans = e->x->plans;
  double factor = 1.0;
  int k;

  memcpy(e->q, e->x->q, (size_t)e->x->t.nq * sizeof(double));
  for (k = 0; k < HALVINGS; ++k, factor *= 0.5) {
    if (!maggi_equilibrium_move(e, e->move, factor)) continue;
    if (size <= small_enough || e->x->plans != plans) return 1;
    correct(e, e->next);
    if (maggi_equilibrium_largest(e, e->next) <= (1.0 - 0.25 * factor) * size) return 1;
  }
  return 0;
}

static int newton(maggi_equilibrium *e, maggi_status *status)
{
  double size;
  int k;

  for (k = 0; k < ITERATIONS; ++k) {
    *status = maggi_equilibrium_linearise(e);
    if (*status != MAGGI_OK) return STUCK;
    if (!factor(e)) return SINGULAR;
    correct(e, e->move);
    size = maggi_equilibrium_largest(e, e->move);
    if (!(size <= too_far)) return STUCK;
    ++e->iterations;
    if (!shorten(e, size)) {
      maggi_equilibrium_move(e, e->move, 0.0);
      return size <= round_off ? FOUND : STUCK;
    }
    if (size <= small_enough) return FOUND;
  }
  return STUCK;
}

/* ---------------------------------------------------------------------------------------- search */

/* nothing holds the coordinate that moves most in the direction in `next` */
static maggi_status fail_free(const maggi_equilibrium *e, maggi_data *d)
{
  const maggi_topo *t = &e->x->t;
  int i, most = 0;

  for (i = 0; i < t->nind; ++i)
    if (fabs(e->next[i]) > fabs(e->next[most])) most = i;
  return maggi_data_fail(d, MAGGI_E_ASSEMBLY,
                         "static equilibrium: nothing holds \"%s\"; name it in start.hold",
                         maggi_name_of(d, t->colq[most]));
}

static maggi_status fail_search(const maggi_equilibrium *e, maggi_data *d)
{
  const maggi_topo *t = &e->x->t;
  int i, most = 0, body;

  for (i = 0; i < t->nind; ++i)
    if (!(fabs(e->x->acol[i]) <= fabs(e->x->acol[most]))) most = i;
  if (t->nind == 0) return maggi_data_fail(d, MAGGI_E_ASSEMBLY, "static equilibrium: not found");
  body = t->qbody[t->colq[most]];
  return maggi_data_fail(d, MAGGI_E_ASSEMBLY,
                         "static equilibrium: not found, \"%s\" still accelerates by %.3g %s",
                         maggi_name_of(d, t->colq[most]), e->x->acol[most],
                         t->joint[body] == MAGGI_ONE_REVOLUTE ? "rad/s^2" : "m/s^2");
}

/* back to where the search began */
static maggi_status restart(maggi_equilibrium *e)
{
  maggi_status status;

  memcpy(e->x->q, e->start, (size_t)e->x->t.nq * sizeof(double));
  maggi_evaluate_positions(e->x, 0.0);
  status = maggi_plan(e->x, 0, 0.1);
  if (status == MAGGI_OK) maggi_equilibrium_rest(e);
  return status;
}

/* Newton; where that leads nowhere, because it begins too far away, after a damped run */
static maggi_status search(maggi_equilibrium *e, maggi_data *d)
{
  maggi_status status = MAGGI_OK;
  int round, end;

  memcpy(e->start, e->x->q, (size_t)e->x->t.nq * sizeof(double));
  for (round = 0; round < ROUNDS; ++round) {
    end = newton(e, &status);
    if (end == FOUND) return MAGGI_OK;
    if (end == SINGULAR && round > 0) return fail_free(e, d);
    if (status == MAGGI_OK && round == 0) status = restart(e);
    if (status != MAGGI_OK) return maggi_data_fail(d, status, "%s", e->x->message);
    if (!maggi_equilibrium_damped(e)) break;
  }
  return fail_search(e, d);
}

maggi_status maggi_equilibrium_find(maggi_equilibrium *e, maggi_data *d)
{
  maggi_data *x = e->x;
  maggi_status status;

  e->is_found = e->iterations = e->damped = 0;
  memcpy(x->p, d->p, (size_t)d->t.np * sizeof(double));
  x->tolerance = 1e-14;
  status = maggi_assemble_guess(x);
  if (status == MAGGI_OK) {
    maggi_equilibrium_rest(e);
    status = maggi_check(x, 0.0);
  }
  if (status != MAGGI_OK)
    return maggi_data_fail(d, status, "static equilibrium: %.*s", (int)sizeof d->message - 30,
                           x->message);
  status = search(e, d);
  if (status != MAGGI_OK) return status;
  memcpy(d->q, x->q, (size_t)d->t.nq * sizeof(double));
  status = maggi_equilibrium_linearise(e);
  if (status != MAGGI_OK) return maggi_data_fail(d, status, "out of memory");
  e->is_found = factor(e);
  return e->is_found ? MAGGI_OK : fail_free(e, d);
}

/* ----------------------------------------------------------------------------------- derivatives */

void maggi_equilibrium_strip(maggi_equilibrium *e, const maggi_companion *from, double *q)
{
  const maggi_topo *t = &e->x->t;
  maggi_companion *s = &e->D->strip;
  size_t bytes = (size_t)t->nq * W * sizeof(double);
  int i, c;

  maggi_place_constants(s, t, from->p); /* p is the first of them */
  memset(s->q, 0, bytes);
  memset(s->v, 0, bytes);
  maggi_strip_closure(e->D);
  maggi_strip_motion(e->D);
  for (c = 0; c < W; ++c) {
    for (i = 0; i < t->nind; ++i) e->move[i] = -s->a[t->colq[i] * W + c];
    maggi_dense_solve(&e->factor, e->move);
    for (i = 0; i < t->nind; ++i) s->q[t->colq[i] * W + c] = e->move[i];
  }
  maggi_strip_closure(e->D);
  memcpy(q, s->q, bytes);
}

void maggi_equilibrium_adjoint(maggi_equilibrium *e, const maggi_companion *to, const double *q)
{
  const maggi_topo *t = &e->x->t;
  maggi_companion *s = &e->D->adjoint;
  size_t bytes = (size_t)t->nq * sizeof(double);
  int i;

  maggi_place_constants(s, t, to->p);
  maggi_companion_clear(s);
  memcpy(s->q, q, bytes);
  maggi_adjoint_closure(e->D);
  for (i = 0; i < t->nind; ++i) e->move[i] = -s->q[t->colq[i]];
  maggi_dense_solve_transposed(&e->factor, e->move);
  memcpy(e->q, s->q, bytes);
  maggi_companion_clear(s);
  for (i = 0; i < t->nind; ++i) s->a[t->colq[i]] = e->move[i];
  for (i = t->nind; i < t->ncol; ++i) s->q[t->colq[i]] = e->q[t->colq[i]];
  maggi_adjoint_motion(e->D);
  memcpy(e->q, s->q, bytes);
  maggi_companion_clear(s);
  memcpy(s->q, e->q, bytes); /* what is left on dependent coordinates */
  maggi_adjoint_closure(e->D);
}

/* ---------------------------------------------------------------------------------------- memory */

maggi_status maggi_equilibrium_create(const maggi_model *twin, maggi_equilibrium **equilibrium)
{
  maggi_equilibrium *e = calloc(1, sizeof *e);
  size_t n = (size_t)twin->topo.nq + 1;

  *equilibrium = NULL;
  if (!e) return MAGGI_E_MEMORY;
  if (maggi_data_create(twin, &e->x) == MAGGI_OK &&
      maggi_derivative_create(e->x, 0, &e->D) == MAGGI_OK &&
      maggi_dense_create(&e->factor, twin->topo.nq)) {
    e->J = calloc(n * n, sizeof(double));
    e->move = calloc(n, sizeof(double));
    e->next = calloc(n, sizeof(double));
    e->q = calloc(n, sizeof(double));
    e->start = calloc(n, sizeof(double));
  }
  if (!e->J || !e->move || !e->next || !e->q || !e->start) {
    maggi_equilibrium_free(e);
    return MAGGI_E_MEMORY;
  }
  *equilibrium = e;
  return MAGGI_OK;
}

void maggi_equilibrium_free(maggi_equilibrium *e)
{
  if (!e) return;
  maggi_derivative_free(e->D);
  maggi_data_free(e->x);
  maggi_dense_free(&e->factor);
  free(e->J);
  free(e->move);
  free(e->next);
  free(e->q);
  free(e->start);
  free(e);
}
