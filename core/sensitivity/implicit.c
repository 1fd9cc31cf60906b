/* Rules of the linear solves.  Derivation of each above it; equations (1) to (3), G, K, R and M as in
 * derivative.h. */
#include "implicit.h"

#include <string.h>

#include "columns.h"

enum { SMALL = 3 }; /* islands of so many dependents stay in registers */

/* ----------------------------------------------------------------------------- (1) and (2): tangent
 *
 *   sign G^T y(x) = 0,  dy/dx = -sign Phi  =>  K x_d = sign (G_d^T y + G^T y_d)
 *
 * with y_d at x_d = 0; K by forward substitution over the islands. */

/* X = sign G_d^T y + G^T rest */
ALWAYS_INLINE void normal_side(int width, int m, int n, const double *phi, const double *phi_d,
                               double sign, const double *y, const int *rowloop, const double *rest,
                               double *X)
{
  int i, row;

  clear(n * width, X);
  for (row = 0; row < m; ++row) {
    for (i = 0; i < n; ++i) {
      axpy(width, sign * y[rowloop[row]], phi_d + (row * n + i) * width, X + i * width);
      axpy(width, phi[row * n + i], rest + row * width, X + i * width);
    }
  }
}

ALWAYS_INLINE void solve_island(int width, int m, int n, const double *phi, const double *L,
                                const double *phi_d, double sign, const double *y,
                                const int *rowloop, double *rest, double *X, double *T)
{
  int i, row;

  normal_side(width, m, n, phi, phi_d, sign, y, rowloop, rest, X);
  substitute(n, width, L, X);
  if (!has_small_pivots(n, L)) return;
  for (row = 0; row < m; ++row)
    for (i = 0; i < n; ++i) axpy(width, -phi[row * n + i], X + i * width, rest + row * width);
  normal_side(width, m, n, phi, phi_d, sign, y, rowloop, rest, T);
  substitute(n, width, L, T);
  for (i = 0; i < n; ++i) axpy(width, 1.0, T + i * width, X + i * width);
}

/* n is a constant of the caller */
ALWAYS_INLINE void solve_small(int width, int m, int n, const double *phi, const double *L,
                               const double *phi_d, double sign, const double *y,
                               const int *rowloop, double *rest, const int *dep, double *x)
{
  double X[SMALL * MAGGI_NDIR], T[SMALL * MAGGI_NDIR];
  int i;

  solve_island(width, m, n, phi, L, phi_d, sign, y, rowloop, rest, X, T);
  for (i = 0; i < n; ++i) load(width, X + i * width, x + dep[i] * width);
}

/* x is zero on coordinates that are not dependent; rest = sign y_d - Phi x_d of earlier islands */
ALWAYS_INLINE void close_islands(int width, maggi_derivative *D, double sign, const double *y,
                                 const double *y_d, const double *phi_d, double *V, double *rest,
                                 double *x)
{
  const maggi_data *d = D->d;
  const maggi_topo *t = &d->t;
  const double *phi, *phid, *L;
  const int *dep, *rowloop;
  double *island;
  int k, m, n, i;

  for (k = 0; k < t->nisland; ++k) {
    m = t->islrow[k + 1] - t->islrow[k];
    n = t->isldep[k + 1] - t->isldep[k];
    phi = d->phi + t->islphi[k];
    phid = phi_d + (size_t)t->islphi[k] * (size_t)width;
    L = d->chol + t->islchol[k];
    dep = t->dep + t->isldep[k];
    rowloop = D->rowloop + t->islrow[k];
    island = rest + t->islrow[k] * width;
    if (D->coupled[k])
      maggi_island_rates(&D->t, k, width, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->b, x,
                         V, rest);
    else
      clear(m * width, island);
    for (i = 0; i < m; ++i) axpy(width, sign, y_d + rowloop[i] * width, island + i * width);
    if (n == 1) {
      solve_small(width, m, 1, phi, L, phid, sign, y, rowloop, island, dep, x);
    } else if (n == 2) {
      solve_small(width, m, 2, phi, L, phid, sign, y, rowloop, island, dep, x);
    } else if (n == 3) {
      solve_small(width, m, 3, phi, L, phid, sign, y, rowloop, island, dep, x);
    } else {
      solve_island(width, m, n, phi, L, phid, sign, y, rowloop, island, D->space,
                   D->space + n * width);
      for (i = 0; i < n; ++i) load(width, D->space + i * width, x + dep[i] * width);
    }
  }
}

void maggi_close_d(maggi_derivative *D, double sign, const double *y, const double *y_d,
                   const double *phi_d, double *x)
{
  const maggi_topo *t = &D->d->t;
  int i;

  close_islands(1, D, sign, y, y_d, phi_d, D->d->v1, D->d->y1, D->x);
  for (i = 0; i < t->ndep; ++i) x[t->dep[i]] = D->x[t->dep[i]];
}

void maggi_close_dv(maggi_derivative *D, double sign, const double *y, const double *y_d,
                    const double *phi_d, double *x)
{
  enum { W = MAGGI_NDIR };
  const maggi_topo *t = &D->d->t;
  int i;

  close_islands(W, D, sign, y, y_d, phi_d, D->V, D->rest, D->xs);
  for (i = 0; i < t->ndep; ++i) load(W, D->xs + t->dep[i] * W, x + t->dep[i] * W);
}

/* ------------------------------------------------------------------------------------ (3): tangent
 *
 *   w_d - M R y_d - Phi^T G mu_d = 0,  w_d at a_d of (2), G_d mu in lambda_d
 *   R^T:  M^ y_d = R^T w_d;  dependents:  K^T mu_d = w_d - M R y_d */

/* lambda = G_d x, by islands */
ALWAYS_INLINE void island_product(int width, const maggi_derivative *D, const double *phi,
                                  const double *x, double *lambda)
{
  const maggi_topo *t = &D->d->t;
  const double *block;
  int k, i, n, row, m;

  for (k = 0; k < t->nisland; ++k) {
    m = t->islrow[k + 1] - t->islrow[k];
    n = t->isldep[k + 1] - t->isldep[k];
    block = phi + (size_t)t->islphi[k] * (size_t)width;
    for (row = 0; row < m; ++row) {
      double sum[MAGGI_NDIR] = {0.0};

      for (i = 0; i < n; ++i)
        axpy(width, x[t->dep[t->isldep[k] + i]], block + (row * n + i) * width, sum);
      load(width, sum, lambda + D->rowloop[t->islrow[k] + row] * width);
    }
  }
}

void maggi_multipliers_d(maggi_derivative *D, const maggi_companion *s)
{
  island_product(1, D, s->phi, D->d->mu, s->lambda);
}

void maggi_multipliers_dv(maggi_derivative *D, const maggi_companion *s)
{
  island_product(MAGGI_NDIR, D, s->phi, D->d->mu, s->lambda);
}

/* x = R (R^T M R)^-1 R^T w on independent and dependent coordinates, 0 on guided ones */
static void move_independents(maggi_derivative *D, const double *w, double *x)
{
  maggi_data *d = D->d;
  const maggi_topo *t = &d->t;
  int i;

  maggi_reduced_force(t, w, d->R, D->column);
  for (i = t->nind; i < t->ncol; ++i) D->column2[i] = 0.0;
  maggi_solve_mass(t, d->Mr, D->column, d->Ur, d->dinv, D->column2);
  maggi_expand(t, d->R, D->column2, d->zero, x);
}

void maggi_independents_d(maggi_derivative *D, const maggi_companion *s)
{
  int i;

  move_independents(D, s->w, D->moved);
  for (i = 0; i < D->d->t.nq; ++i) s->a[i] += D->moved[i];
}

/* column of U^T U y = fr in place for all directions; `first` of a column is where it begins */
static void solve_mass_dv(const maggi_topo *t, const double *Ur, const double *dinv, double *y)
{
  enum { W = MAGGI_NDIR };
  int i, k;
  double f[W];

  for (k = 0; k < t->nind; ++k) {
    scale(W, dinv[k], y + k * W);
    load(W, y + k * W, f);
    for (i = k + 1; i < t->nind; ++i)
      if (t->first[i] <= k) axpy(W, -Ur[k * t->stride + i], f, y + i * W);
  }
  for (k = t->nind - 1; k >= 0; --k) {
    load(W, y + k * W, f);
    for (i = k + 1; i < t->nind; ++i)
      if (t->first[i] <= k) axpy(W, -Ur[k * t->stride + i], y + i * W, f);
    scale(W, dinv[k], f);
    load(W, f, y + k * W);
  }
}

void maggi_independents_dv(maggi_derivative *D, const maggi_companion *s)
{
  enum { W = MAGGI_NDIR };
  const maggi_data *d = D->d;
  const maggi_topo *t = &d->t;
  double *y = D->columns, sum[W];
  int i, k, c, end;

  for (c = 0; c < t->nind; ++c) load(W, s->w + t->colq[c] * W, y + c * W);
  for (i = 0; i < t->ndep; ++i) {
    k = t->dep[i];
    end = t->rend[k] < t->nind ? t->rend[k] : t->nind;
    load(W, s->w + k * W, sum);
    for (c = t->rbeg[k]; c < end; ++c) axpy(W, d->R[k * t->stride + c], sum, y + c * W);
  }
  solve_mass_dv(t, d->Ur, d->dinv, y);
  for (c = 0; c < t->nind; ++c) axpy(W, 1.0, y + c * W, s->a + t->colq[c] * W);
  for (i = 0; i < t->ndep; ++i) {
    k = t->dep[i];
    end = t->rend[k] < t->nind ? t->rend[k] : t->nind;
    load(W, s->a + k * W, sum);
    for (c = t->rbeg[k]; c < end; ++c) axpy(W, d->R[k * t->stride + c], y + c * W, sum);
    load(W, sum, s->a + k * W);
  }
}

/* ------------------------------------------------------------------------------------ the transposes */

/* y -= M x */
static void subtract_inertia(const maggi_data *d, const double *x, double *y)
{
  const maggi_topo *t = &d->t;
  int k, i, j;

  for (k = 0; k < t->npair; ++k) {
    i = t->pairi[k];
    j = t->pairj[k];
    y[i] -= d->M[k] * x[j];
    if (i != j) y[j] -= d->M[k] * x[i];
  }
}

/* K^T x = w on dependent coordinates, y = G x by loop equations */
static void solve_transposed(const maggi_derivative *D, const double *w, double *x, double *y)
{
  const maggi_data *d = D->d;

  maggi_loop_multipliers(&D->t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->b, d->phi,
                         d->chol, w, d->G1, d->y1, x, y, d->space);
}

/* phi += f y x^T on the blocks */
static void add_products(const maggi_derivative *D, double f, const double *y, const double *x,
                         double *phi)
{
  const maggi_topo *t = &D->d->t;
  int k, i, n, row;

  for (k = 0; k < t->nisland; ++k) {
    n = t->isldep[k + 1] - t->isldep[k];
    for (row = t->islrow[k]; row < t->islrow[k + 1]; ++row)
      for (i = 0; i < n; ++i)
        phi[t->islphi[k] + (row - t->islrow[k]) * n + i] +=
            f * y[D->rowloop[row]] * x[t->dep[t->isldep[k] + i]];
  }
}

void maggi_multipliers_rest_d(maggi_derivative *D, const maggi_companion *s)
{
  const maggi_topo *t = &D->d->t;
  int i;

  memcpy(D->work, s->w, (size_t)t->nq * sizeof(double));
  subtract_inertia(D->d, D->moved, D->work);
  solve_transposed(D, D->work, D->mu_d, D->rows);
  for (i = 0; i < t->islrow[t->nisland]; ++i) s->lambda[D->rowloop[i]] += D->rows[D->rowloop[i]];
}

/* Lagrange's function  v_bar.v + a_bar.a + omega.w + alpha1.G^T rate + alpha2.G^T gama  is stationary
 *
 *   in mu    G^T Phi omega = 0, or  mu_bar  when mu has an adjoint of its own
 *            => omega = omega_p + R y,  K omega_p = mu_bar on dependents
 *   in a     a_bar - M omega - Phi^T G nu = 0,  nu = alpha2
 *            R^T:  M^ y = R^T (a_bar - M omega_p);  dependents:  K^T nu = a_bar - M omega */
void maggi_independents_b(maggi_derivative *D, const maggi_companion *s, const double *omega_p)
{
  const maggi_topo *t = &D->d->t;
  size_t bytes = (size_t)t->nq * sizeof(double);
  int i;

  memcpy(D->work, s->a, bytes);
  if (omega_p) subtract_inertia(D->d, omega_p, D->work);
  move_independents(D, D->work, D->omega);
  for (i = 0; i < t->ndep && omega_p; ++i) D->omega[t->dep[i]] += omega_p[t->dep[i]];
  memcpy(s->w, D->omega, bytes);
}

/* The adjoint of lambda = G mu is that of G; that of gama is G nu. */
void maggi_close_accelerations_b(maggi_derivative *D, const maggi_companion *s)
{
  const maggi_topo *t = &D->d->t;

  add_products(D, 1.0, s->lambda, D->d->mu, s->phi);
  memset(s->lambda, 0, (size_t)t->nrow * sizeof(double));
  memcpy(D->work, s->a, (size_t)t->nq * sizeof(double));
  subtract_inertia(D->d, D->omega, D->work);
  solve_transposed(D, D->work, D->nu, s->gama);
  add_products(D, 1.0, D->d->gama, D->nu, s->phi);
}

/*   in v     v_bar + Phi^T G alpha1 = 0 on dependents:  K^T nu = v_bar,  nu = -alpha1 */
void maggi_close_velocities_b(maggi_derivative *D, const maggi_companion *s)
{
  const maggi_topo *t = &D->d->t;
  int i;

  solve_transposed(D, s->v, D->nu, s->rate);
  for (i = 0; i < t->nrow; ++i) s->rate[i] = -s->rate[i];
  add_products(D, -1.0, D->d->rate, D->nu, s->phi);
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
 *   mu_bar = G_d^T lambda_bar + G^T lambda_bar_d,  lambda_bar = - Phi omega */
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
  add_products(D, 1.0, second->lambda, D->d->mu, second->phi);
  add_products(D, 1.0, s->lambda, D->mu_d, second->phi);
  memset(second->lambda, 0, (size_t)t->nrow * sizeof(double));
  maggi_close_accelerations_b(D, s);
  island_product(1, D, tangent->phi, D->nu, second->gama);
  add_products(D, 1.0, tangent->gama, D->nu, second->phi);
}

void maggi_close_velocities_b_d(maggi_derivative *D, const maggi_companion *s)
{
  const maggi_topo *t = &D->d->t;
  const maggi_companion *tangent = &D->tangent, *second = &D->second;
  int i;

  maggi_close_velocities_b(D, s);
  island_product(1, D, tangent->phi, D->nu, second->rate);
  for (i = 0; i < t->nrow; ++i) second->rate[i] = -second->rate[i];
  add_products(D, -1.0, tangent->rate, D->nu, second->phi);
}

void maggi_guides_b_d(maggi_derivative *D, const maggi_companion *s)
{
  maggi_guides_b(D, s);
  maggi_guides_b(D, &D->second);
}
