/* Rules of the linear solves, adjoints and their tangents.  Equations (1) to (3), G, K, R and M as in
 * derivative.h, square islands and P as in implicit.c.
 *
 * Lagrange's function  v_bar.v + a_bar.a + omega.w + alpha1.G^T rate + alpha2.G^T gama  is stationary
 *
 *   in mu    G^T Phi omega = 0, or  mu_bar  when mu has an adjoint of its own
 *            => omega = omega_p + R y,  K omega_p = mu_bar on dependents
 *   in a     a_bar - M omega - Phi^T G nu = 0,  nu = alpha2
 *            R^T:  M^ y = R^T (a_bar - M omega_p);  dependents:  K^T nu = a_bar - M omega
 *   in v     v_bar - Phi^T G nu = 0 on dependents,  nu = -alpha1:  K^T nu = v_bar */
#include <string.h>

#include "implicit.h"
#include "island.h"

/* phi += f y x^T on the blocks that are not square */
static void add_products(const maggi_derivative *D, double f, const double *y, const double *x,
                         double *phi)
{
  island o;
  int k, i, row;

  for (k = 0; k < D->d->t.nisland && D->redundant; ++k) {
    o = island_of(D, k);
    for (row = 0; row < o.m && !is_square(&o); ++row)
      for (i = 0; i < o.n; ++i) phi[o.adr + row * o.n + i] += f * y[o.row[row]] * x[o.dep[i]];
  }
}

void maggi_independents_b(maggi_derivative *D, const maggi_companion *s, const double *omega_p)
{
  const maggi_topo *t = &D->d->t;
  size_t bytes = (size_t)t->nq * sizeof(double);
  int i;

  memcpy(D->work, s->a, bytes);
  if (omega_p) maggi_subtract_inertia(D->d, omega_p, D->work);
  maggi_move_independents(D, D->work, D->omega);
  for (i = 0; i < t->ndep && omega_p; ++i) D->omega[t->dep[i]] += omega_p[t->dep[i]];
  memcpy(s->w, D->omega, bytes);
}

void maggi_balance_multipliers_b(maggi_derivative *D, const maggi_companion *s)
{
  maggi_close_d(D, 1.0, NULL, s->lambda, NULL, s->w);
}

void maggi_multipliers_b(maggi_derivative *D, const maggi_companion *s)
{
  if (D->redundant) maggi_project_rows(D, s->lambda, NULL, NULL);
  add_products(D, 1.0, s->lambda, D->d->mu, s->phi);
  memset(s->lambda, 0, (size_t)D->d->t.nrow * sizeof(double));
}

/* The adjoint of gama is G alpha2. */
void maggi_close_accelerations_b(maggi_derivative *D, const maggi_companion *s)
{
  const maggi_topo *t = &D->d->t;

  maggi_multipliers_b(D, s);
  memcpy(D->work, s->a, (size_t)t->nq * sizeof(double));
  maggi_subtract_inertia(D->d, D->omega, D->work);
  maggi_solve_transposed(D, D->work, D->nu, s->gama);
  add_products(D, 1.0, D->d->gama, D->nu, s->phi);
}

/* The adjoint of rate is G alpha1. */
void maggi_close_velocities_b(maggi_derivative *D, const maggi_companion *s)
{
  const maggi_topo *t = &D->d->t;
  int i;

  maggi_solve_transposed(D, s->v, D->nu, s->rate);
  for (i = 0; i < t->nrow; ++i) s->rate[i] = -s->rate[i];
  add_products(D, -1.0, D->d->rate, D->nu, s->phi);
}

void maggi_close_positions_b(maggi_derivative *D, const maggi_companion *s)
{
  int i;

  maggi_solve_transposed(D, s->q, D->nu, s->res);
  for (i = 0; i < D->d->t.nrow; ++i) s->res[i] = -s->res[i];
}

/* Guided coordinates follow functions of time. */
static void guide_b(const maggi_data *d, int order, double *x, double *fun)
{
  const maggi_topo *t = &d->t;
  int i, q;

  for (i = t->nind; i < t->ncol; ++i) {
    q = t->colq[i];
    fun[t->qguide[q] * 3 + order] += x[q];
    x[q] = 0.0;
  }
}

void maggi_guides_b(maggi_derivative *D, const maggi_companion *s)
{
  guide_b(D->d, 0, s->q, s->fun);
  guide_b(D->d, 1, s->v, s->fun);
  guide_b(D->d, 2, s->a, s->fun);
}

/* ------------------------------------------------------------------------- tangents of the adjoint
 *
 * The conditions above, differentiated, are the same equations for the tangents of omega, alpha1 and
 * alpha2.  On the right are the tangents with these held, which the sweep over the stages leaves in the
 * adjoints of mu, a and v:
 *
 *   mu_bar = G_d^T lambda_bar + G^T lambda_bar_d,  lambda_bar = - Phi omega
 *
 * In square islands G alpha is held instead. */

/* y = G_d x */
static void products(maggi_derivative *D, double f, const double *phi_d, const double *x, double *y)
{
  island o;
  int k;

  for (k = 0; k < D->d->t.nisland; ++k) {
    o = island_of(D, k);
    island_product(1, &o, phi_d, x, D->rest);
    scale(o.m, f, D->rest);
    scatter_rows(1, &o, D->rest, y);
  }
}

void maggi_independents_b_d(maggi_derivative *D, const maggi_companion *s)
{
  maggi_independents_b(D, s, NULL);
  memset(D->second.w, 0, (size_t)D->d->t.nq * sizeof(double));
}

void maggi_close_accelerations_b_d(maggi_derivative *D, const maggi_companion *s)
{
  const maggi_topo *t = &D->d->t;
  const maggi_companion *tangent = &D->tangent, *second = &D->second;

  memset(D->omega_p, 0, (size_t)t->nq * sizeof(double));
  maggi_close_d(D, 1.0, s->lambda, second->lambda, tangent->phi, D->omega_p);
  maggi_project_rows(D, second->lambda, tangent->phi, s->lambda);
  add_products(D, 1.0, second->lambda, D->d->mu, second->phi);
  add_products(D, 1.0, s->lambda, D->mu_d, second->phi);
  memset(second->lambda, 0, (size_t)t->nrow * sizeof(double));
  maggi_close_accelerations_b(D, s);
  products(D, 1.0, tangent->phi, D->nu, second->gama);
  add_products(D, 1.0, tangent->gama, D->nu, second->phi);
}

void maggi_close_velocities_b_d(maggi_derivative *D, const maggi_companion *s)
{
  const maggi_companion *tangent = &D->tangent, *second = &D->second;

  maggi_close_velocities_b(D, s);
  products(D, -1.0, tangent->phi, D->nu, second->rate);
  add_products(D, -1.0, tangent->rate, D->nu, second->phi);
}

void maggi_guides_b_d(maggi_derivative *D, const maggi_companion *s)
{
  maggi_guides_b(D, s);
  maggi_guides_b(D, &D->second);
}
