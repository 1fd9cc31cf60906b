/* Direct differentiation: tangents of the state along the design parameters, in strips of MAGGI_NDIR,
 * follow the simulation step by step.  [1] 5.3, FORMULATION 9.
 *
 * The tangent of a Runge-Kutta step is the Runge-Kutta step of the tangents; of a projection and of the
 * assembly, the implicit function theorem; of a change of the independent coordinates, the tangents of
 * the velocities that the evaluation before it has. */
#include <stdlib.h>
#include <string.h>

#include "direct.h"
#include "equilibrium.h"
#include "results.h"

enum { W = MAGGI_NDIR, ARRAYS = 3 * MAGGI_PLACES + 2, FILTER_ARRAYS = 2 * MAGGI_PLACES + 1 };

static maggi_direct *of(maggi_follower *f)
{
  return (maggi_direct *)f;
}

void maggi_direct_choose(maggi_direct *s, int first)
{
  size_t i = (size_t)(first / W) * s->strip, k = (size_t)(first / W) * s->filter_strip;

  maggi_strip_choose(s->D, first);
  s->D->strip.q = s->at[MAGGI_PRESENT].q + i;
  s->D->strip.v = s->at[MAGGI_PRESENT].v + i;
  s->D->strip.a = s->at[MAGGI_PRESENT].a + i;
  s->D->strip.y = s->at[MAGGI_PRESENT].y + k;
  s->D->strip.yrate = s->at[MAGGI_PRESENT].yrate + k;
}

/* velocities and accelerations from positions and velocities of independent coordinates, then rates of
 * filters */
static maggi_status move(maggi_direct *s, double time, int is_projected)
{
  maggi_status status = maggi_linearise_at(s->D, time);
  int first;

  for (first = 0; first < s->n && status == MAGGI_OK; first += W) {
    maggi_direct_choose(s, first);
    if (is_projected) maggi_strip_closure(s->D);
    maggi_strip_motion(s->D);
    if (s->need) maggi_strip_results(s->D, s->need);
  }
  return status;
}

/* ------------------------------------------------------------------------------------ follower */

static void begin(maggi_follower *f)
{
  maggi_direct *s = of(f);
  size_t bytes = s->nx * sizeof(double);

  memcpy(s->at[MAGGI_PRESENT].v, s->at[MAGGI_START].v, bytes);
  memcpy(s->at[MAGGI_PRESENT].a, s->at[MAGGI_START].a, bytes);
  memset(s->qsum, 0, bytes);
  memset(s->vsum, 0, bytes);
  memcpy(s->at[MAGGI_PRESENT].yrate, s->at[MAGGI_START].yrate, s->ny * sizeof(double));
  memset(s->ysum, 0, s->ny * sizeof(double));
}

static maggi_status stage(maggi_follower *f, double weight, double ahead, double time)
{
  maggi_direct *s = of(f);
  const maggi_direct_state *x = &s->at[MAGGI_PRESENT], *start = &s->at[MAGGI_START];
  size_t i;

  for (i = 0; i < s->nx; ++i) {
    s->qsum[i] += weight * x->v[i];
    x->q[i] = start->q[i] + ahead * x->v[i];
  }
  for (i = 0; i < s->nx; ++i) {
    s->vsum[i] += weight * x->a[i];
    x->v[i] = start->v[i] + ahead * x->a[i];
  }
  for (i = 0; i < s->ny; ++i) {
    s->ysum[i] += weight * x->yrate[i];
    x->y[i] = start->y[i] + ahead * x->yrate[i];
  }
  return move(s, time, 0);
}

static maggi_status end(maggi_follower *f, double h, double time, int is_projected)
{
  maggi_direct *s = of(f);
  const maggi_direct_state *x = &s->at[MAGGI_PRESENT], *start = &s->at[MAGGI_START];
  size_t i;

  for (i = 0; i < s->nx; ++i) x->q[i] = start->q[i] + h / 6.0 * (s->qsum[i] + x->v[i]);
  for (i = 0; i < s->nx; ++i) x->v[i] = start->v[i] + h / 6.0 * (s->vsum[i] + x->a[i]);
  for (i = 0; i < s->ny; ++i) x->y[i] = start->y[i] + h / 6.0 * (s->ysum[i] + x->yrate[i]);
  return move(s, time, is_projected);
}

static maggi_status renewed(maggi_follower *f, double time)
{
  return move(of(f), time, 0);
}

static void copy(maggi_follower *f, maggi_place to, maggi_place from)
{
  maggi_direct *s = of(f);
  size_t bytes = s->nx * sizeof(double);

  memcpy(s->at[to].q, s->at[from].q, bytes);
  memcpy(s->at[to].v, s->at[from].v, bytes);
  memcpy(s->at[to].a, s->at[from].a, bytes);
  memcpy(s->at[to].y, s->at[from].y, s->ny * sizeof(double));
  memcpy(s->at[to].yrate, s->at[from].yrate, s->ny * sizeof(double));
}

static void interpolate(maggi_follower *f, const double c[MAGGI_BETWEEN][6])
{
  maggi_direct *s = of(f);
  const maggi_direct_state *x = &s->at[MAGGI_PRESENT], *start = &s->at[MAGGI_START],
                           *node = &s->at[MAGGI_NODE];
  double *out[3] = {x->q, x->v, x->a};
  size_t i;
  int k;

  for (k = 0; k < 3; ++k)
    for (i = 0; i < s->nx; ++i)
      out[k][i] = c[k][0] * start->q[i] + c[k][1] * start->v[i] + c[k][2] * start->a[i] +
                  c[k][3] * node->q[i] + c[k][4] * node->v[i] + c[k][5] * node->a[i];
  for (i = 0; i < s->ny; ++i)
    x->y[i] = c[3][0] * start->y[i] + c[3][1] * start->yrate[i] + c[3][3] * node->y[i] +
              c[3][4] * node->yrate[i];
}

/* ------------------------------------------------------------------------------ initial state */

/* directions of the parameters, all strips, and the tangents of the constants */
static void load_parameters(maggi_direct *s)
{
  int first, n;

  for (first = 0; first < s->n; first += W) {
    maggi_direct_choose(s, first);
    n = s->n - first < W ? s->n - first : W;
    maggi_design_directions(s->design, first, n, W, s->D->strip.p);
    maggi_strip_constants(s->D);
  }
}

/* row of x: those of an entry of p, or zero */
static void start_row(const double *p, int adr, double *x)
{
  if (adr >= 0)
    memcpy(x, p + adr * W, W * sizeof(double));
  else
    memset(x, 0, W * sizeof(double));
}

/* positions of the coordinates that are not dependent, velocities of the independent ones */
static void start_strip(maggi_direct *s)
{
  const maggi_companion *x = &s->D->strip;
  int i;

  if (s->d->equilibrium) maggi_equilibrium_strip(s->d->equilibrium, x, x->q);
  for (i = 0; i < s->d->t.nq; ++i) {
    if (!s->d->equilibrium) start_row(x->p, maggi_initial_position(s->d, i), x->q + i * W);
    start_row(x->p, s->d->m->initial_velocity[i], x->v + i * W);
  }
}

static maggi_status close_loops(maggi_direct *s)
{
  maggi_status status = maggi_linearise_at(s->D, s->d->time);
  int first;

  for (first = 0; first < s->n && status == MAGGI_OK; first += W) {
    maggi_direct_choose(s, first);
    start_strip(s);
    maggi_strip_closure(s->D);
  }
  return status;
}

/* velocities of wheels that start rolling by those of the others */
static maggi_status roll(maggi_direct *s)
{
  maggi_status status = maggi_linearise_at(s->D, s->d->time);
  int first;

  for (first = 0; first < s->n && status == MAGGI_OK; first += W) {
    maggi_direct_choose(s, first);
    maggi_strip_motion(s->D);
    maggi_strip_rolling(s->D);
  }
  return status;
}

maggi_status maggi_direct_reset(maggi_direct *s)
{
  maggi_data *d = s->d;
  maggi_status status;

  status = maggi_data_reset(d);
  if (status == MAGGI_OK) status = maggi_derivative_fit(s->D);
  if (status != MAGGI_OK) return status;
  load_parameters(s);
  memset(s->at[MAGGI_PRESENT].y, 0, s->ny * sizeof(double));
  if (d->is_kept) status = maggi_evaluate_start(d, 1);
  if (status == MAGGI_OK) status = close_loops(s);
  if (d->is_kept && status == MAGGI_OK) status = maggi_evaluate_start(d, 0);
  if (d->m->rolling && status == MAGGI_OK) status = roll(s);
  if (status == MAGGI_OK) status = move(s, d->time, 0);
  d->ready = status == MAGGI_OK;
  d->follower = &s->follower;
  return status;
}

/* --------------------------------------------------------------------------- public functions */

maggi_status maggi_direct_step(maggi_direct *s, double h)
{
  if (s->d->follower != &s->follower)
    return maggi_data_fail(s->d, MAGGI_E_MODEL, "sensitivities need a reset before a step");
  return maggi_step(s->d, h);
}

/* row of a strip to that of a matrix with n columns */
static void gather(int n, int first, const double *row, double *x)
{
  memcpy(x + first, row, (size_t)(n - first < W ? n - first : W) * sizeof(double));
}

void maggi_direct_get_coordinates(const maggi_direct *s, double *q, double *v, double *a)
{
  const maggi_direct_state *x = &s->at[MAGGI_PRESENT];
  const double *from[3] = {x->q, x->v, x->a};
  double *to[3] = {q, v, a};
  int i, k, first;
  size_t row;

  for (k = 0; k < 3; ++k) {
    for (i = 0; i < s->d->m->ncoordinate && to[k]; ++i) {
      for (first = 0; first < s->n; first += W) {
        row = (size_t)(first / W) * s->strip + (size_t)(s->d->m->coordinate[i].q * W);
        gather(s->n, first, from[k] + row, to[k] + (size_t)i * (size_t)s->n);
      }
    }
  }
}

void maggi_direct_get_signals(maggi_direct *s, int nsignal, const int *signal, double *values)
{
  unsigned need = maggi_signals_need(s->d->m, nsignal, signal);
  double row[W];
  int i, first;

  if (need) maggi_linearise_at(s->D, s->d->time);
  for (first = 0; first < s->n; first += W) {
    maggi_direct_choose(s, first);
    if (need) maggi_strip_given(s->D, need);
    for (i = 0; i < nsignal; ++i) {
      maggi_signals_strip(s->D, 1, signal + i, row);
      gather(s->n, first, row, values + (size_t)i * (size_t)s->n);
    }
  }
}

maggi_status maggi_direct_create(maggi_data *d, const maggi_design *design, maggi_direct **direct)
{
  maggi_direct *s = calloc(1, sizeof *s);
  double *at;
  size_t n;
  int i;

  *direct = NULL;
  if (!s) return MAGGI_E_MEMORY;
  s->d = d;
  s->design = design;
  s->n = maggi_design_number(design);
  s->strip = (size_t)d->t.nq * W;
  s->filter_strip = (size_t)d->t.nstate * W;
  s->nx = s->strip * (size_t)((s->n + W - 1) / W);
  s->ny = s->filter_strip * (size_t)((s->n + W - 1) / W);
  s->need = maggi_filters_need(d->m);
  s->follower = (maggi_follower){begin, stage, end, renewed, copy, interpolate};
  n = ARRAYS * s->nx + FILTER_ARRAYS * s->ny;
  s->memory = aligned_alloc(64, (n + W) * sizeof(double));
  if (!s->memory || maggi_derivative_create(d, s->n, &s->D) != MAGGI_OK) {
    maggi_direct_free(s);
    return MAGGI_E_MEMORY;
  }
  memset(s->memory, 0, n * sizeof(double));
  at = s->memory;
  for (i = 0; i < MAGGI_PLACES; ++i, at += 3 * s->nx + 2 * s->ny)
    s->at[i] = (maggi_direct_state){at, at + s->nx, at + 2 * s->nx, at + 3 * s->nx,
                                    at + 3 * s->nx + s->ny};
  s->qsum = at;
  s->vsum = at + s->nx;
  s->ysum = at + 2 * s->nx;
  *direct = s;
  return MAGGI_OK;
}

void maggi_direct_free(maggi_direct *s)
{
  if (!s) return;
  if (s->d->follower == &s->follower) s->d->follower = NULL;
  maggi_derivative_free(s->D);
  free(s->memory);
  free(s);
}
