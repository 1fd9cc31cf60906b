/* Derivatives of an evaluation, in the order of the user. */
#include "derivative.h"

#include <assert.h>
#include <string.h>

#include "implicit.h"

/* ------------------------------------------------------------------------------- the evaluation */

maggi_status maggi_linearise_at(maggi_derivative *D, double time)
{
  maggi_status status = maggi_derivative_fit(D);

  if (status != MAGGI_OK) return status;
  D->time = time;
  maggi_balance(D->d);
  if (D->d->t.ndep > 0) maggi_remainders(D);
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
void maggi_strip_choose(maggi_derivative *D, int first)
{
  maggi_place_constants(&D->strip, &D->d->t,
                        D->strip.constants + (size_t)(first / MAGGI_NDIR) * D->strip.nconstants);
}

/* row of at most MAGGI_NDIR directions, zeros after them */
static inline void load_row(int n, const double *from, double *to)
{
  int c;

  if (n >= MAGGI_NDIR) {
    memcpy(to, from, MAGGI_NDIR * sizeof(double));
    return;
  }
  for (c = 0; c < n; ++c) to[c] = from[c];
  for (; c < MAGGI_NDIR; ++c) to[c] = 0.0;
}

void maggi_parameters_jac(maggi_derivative *D, int n, int ld, const double *p)
{
  int i, first;

  assert(n <= D->nkept * MAGGI_NDIR);
  if (!p && D->kept_move)
    memset(D->strip.constants, 0, D->strip.nconstants * (size_t)D->nkept * sizeof(double));
  for (first = 0; p && first < n; first += MAGGI_NDIR) {
    maggi_strip_choose(D, first);
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
    x[i] = maggi_is_independent(&d->t, q) ? from[q] : 0.0;
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
    maggi_strip_choose(D, first);
    scatter_strip(D->d, n - first, ld, q ? q + first : NULL, D->strip.q);
    scatter_strip(D->d, n - first, ld, v ? v + first : NULL, D->strip.v);
    maggi_strip_motion(D);
    if (v_out) gather_strip(D->d, n - first, ld, D->strip.v, v_out + first);
    if (a_out) gather_strip(D->d, n - first, ld, D->strip.a, a_out + first);
  }
}

static void start_adjoint(maggi_derivative *D, const double *v_bar, const double *a_bar)
{
  maggi_companion_clear(&D->adjoint);
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
  maggi_companion_clear(&D->second);
  memset(D->second.constants, 0, D->second.nconstants * sizeof(double));
  maggi_second_motion(D);
  gather(D->d, D->second.q, q_out);
  gather_independent(D->d, D->second.v, v_out);
  if (!p_out) return;
  maggi_second_constants(D);
  memcpy(p_out, D->second.p, (size_t)D->d->t.np * sizeof(double));
}
