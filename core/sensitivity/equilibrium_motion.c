/* What one can ask about static equilibrium: springs and wheels there, small motions about it. */
#include <math.h>
#include <string.h>

#include "equilibrium.h"

static const maggi_equilibrium *found(const maggi_data *d)
{
  return d->equilibrium && d->equilibrium->is_found ? d->equilibrium : NULL;
}

maggi_status maggi_get_equilibrium(const maggi_data *d, maggi_equilibrium_state *state)
{
  const maggi_equilibrium *e = found(d);

  memset(state, 0, sizeof *state);
  if (!e) return MAGGI_E_MODEL;
  state->coordinates = e->x->t.nind;
  state->iterations = e->iterations;
  state->damped = e->damped;
  state->residual = maggi_equilibrium_largest(e, e->x->acol);
  return MAGGI_OK;
}

maggi_status maggi_equilibrium_get_springs(const maggi_data *d, double *length, double *force)
{
  const maggi_equilibrium *e = found(d);
  const maggi_data *x;
  const maggi_topo *t;
  double u[3], z[2], f[2];
  int i;

  if (!e) return MAGGI_E_MODEL;
  x = e->x;
  t = &x->t;
  for (i = 0; i < t->nspring; ++i) {
    maggi_spring(t->springadr[i], t->springpreload[i], t->springslopes[i], t->np, x->p,
                 x->spring0[i], x->r[t->springpa[i]], x->r[t->springpb[i]], x->rv[t->springpa[i]],
                 x->rv[t->springpb[i]], u, z, f);
    if (length) length[i] = z[0];
    if (force) force[i] = f[0];
  }
  return MAGGI_OK;
}

maggi_status maggi_equilibrium_get_wheels(const maggi_data *d, double *load)
{
  const maggi_equilibrium *e = found(d);
  int i;

  if (!e) return MAGGI_E_MODEL;
  for (i = 0; i < e->x->t.nwheel; ++i) load[i] = e->x->grip[i][2];
  return MAGGI_OK;
}

/* ---------------------------------------------------------------------------------- small motions */

/* Rates that are all different, so that no damper is at rest by chance. */
static void set_rates(maggi_data *x, double rate)
{
  int i;

  for (i = 0; i < x->t.nind; ++i) x->vcol[i] = rate * (1.0 + 0.618 * sin(1.0 + 2.0 * i));
  maggi_evaluate(x, 0.0);
}

/* adds half of da_i/dv_i at these rates */
static maggi_status add_slopes(maggi_equilibrium *e, double rate, double *a_v)
{
  const maggi_topo *t = &e->x->t;
  const maggi_companion *s = &e->D->strip;
  maggi_status status;
  int first, c, i, n = t->nind;

  set_rates(e->x, rate);
  status = maggi_linearise_at(e->D, 0.0);
  maggi_strip_choose(e->D, 0);
  for (first = 0; first < n && status == MAGGI_OK; first += MAGGI_NDIR) {
    memset(s->q, 0, (size_t)t->nq * MAGGI_NDIR * sizeof(double));
    memset(s->v, 0, (size_t)t->nq * MAGGI_NDIR * sizeof(double));
    for (c = 0; c < MAGGI_NDIR && first + c < n; ++c)
      s->v[t->colq[first + c] * MAGGI_NDIR + c] = 1.0;
    maggi_strip_motion(e->D);
    for (i = 0; i < n; ++i)
      for (c = 0; c < MAGGI_NDIR && first + c < n; ++c)
        a_v[i * n + first + c] += 0.5 * s->a[t->colq[i] * MAGGI_NDIR + c];
  }
  return status;
}

/* back to the state that derivatives of the start need */
static maggi_status rest(maggi_equilibrium *e)
{
  maggi_equilibrium_rest(e);
  return maggi_equilibrium_linearise(e);
}

/* what its search moves, the mass of these and how the others follow */
static void get_coordinates(const maggi_data *d, int *coordinate, double *mass, double *shape)
{
  const maggi_data *x = d->equilibrium->x;
  const maggi_topo *t = &x->t;
  int i, k, q, n = t->nind;

  for (i = 0; i < d->m->ncoordinate; ++i) {
    q = d->m->coordinate[i].q;
    if (coordinate && maggi_is_independent(t, q)) coordinate[t->col[q]] = i;
    for (k = 0; shape && k < n; ++k) shape[i * n + k] = x->R[q * t->stride + k];
  }
  for (i = 0; mass && i < n; ++i)
    for (k = 0; k < n; ++k) mass[i * n + k] = x->Mr[(i < k ? i : k) * t->stride + (i < k ? k : i)];
}

maggi_status maggi_equilibrium_motions(maggi_data *d, double rate, int *coordinate, double *a_q,
                                       double *a_v, double *mass, double *shape)
{
  maggi_equilibrium *e = d->equilibrium;
  maggi_status status = MAGGI_OK;
  size_t bytes;

  if (!found(d)) return maggi_data_fail(d, MAGGI_E_MODEL, "there is no static equilibrium");
  bytes = (size_t)e->x->t.nind * (size_t)e->x->t.nind * sizeof(double);
  get_coordinates(d, coordinate, mass, shape);
  if (a_q) memcpy(a_q, e->J, bytes);
  if (!a_v) return MAGGI_OK;
  memset(a_v, 0, bytes);
  status = add_slopes(e, rate, a_v);
  if (status == MAGGI_OK) status = add_slopes(e, -rate, a_v);
  if (status == MAGGI_OK) status = rest(e);
  return status;
}
