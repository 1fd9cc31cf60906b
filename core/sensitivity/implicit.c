/* Rules of the linear solves, tangents.  Derivation of each above it; equations (1) to (3), G, K, R and M
 * as in derivative.h.
 *
 * Of G_d mu the part in the range of G only shifts mu_d; what matters is P G_d mu, P = 1 - G A^-1 G^T.
 * In a square island, with as many equations as dependents, P is zero, and so are rate and gama: there
 * G_d does not matter at all.  Near singular positions mu grows with the square of what lambda = G mu
 * grows with; there the other part is taken out, and so is what round-off has put into the range of G
 * elsewhere, before it is magnified.  Other islands do without. */
#include "implicit.h"

#include <string.h>

#include "island.h"

void maggi_project_rows(maggi_derivative *D, double *y_d, const double *phi_d, const double *y)
{
  island o;
  int k;

  for (k = 0; k < D->d->t.nisland; ++k) {
    o = island_of(D, k);
    if (!is_square(&o) && !is_delicate(&o)) continue;
    gather_rows(1, &o, y_d, D->rest);
    if (is_square(&o))
      clear(o.m, D->rest);
    else
      solve(1, 1, &o, D->rest, phi_d, 1.0, y, D->space, NULL);
    scatter_rows(1, &o, D->rest, y_d);
  }
}

void maggi_remainders(maggi_derivative *D)
{
  maggi_data *d = D->d;
  const maggi_topo *t = &d->t;

  if (!D->redundant) {
    memset(d->rate, 0, (size_t)t->nrow * sizeof(double));
    memset(d->gama, 0, (size_t)t->nrow * sizeof(double));
    return;
  }
  maggi_loop_rates(t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->rv, (void *)d->Z, d->rate);
  maggi_loop_gamma(t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->rv, (void *)d->ra,
                   (void *)d->Z, (void *)d->Za, d->gama);
  maggi_project_rows(D, d->rate, NULL, NULL);
  maggi_project_rows(D, d->gama, NULL, NULL);
}

/* ----------------------------------------------------------------------------- (1) and (2): tangent
 *
 *   sign G^T y(x) = 0,  dy/dx = -sign Phi  =>  K x_d = sign (G_d^T y + G^T y_d)
 *
 * with y_d at x_d = 0; K by forward substitution over the islands. */

/* x is zero on coordinates that are not dependent */
ALWAYS_INLINE void close_islands(int width, maggi_derivative *D, double sign, const double *y,
                                 const double *y_d, const double *phi_d, double *V, double *rest,
                                 double *x)
{
  const maggi_data *d = D->d;
  const maggi_topo *t = &d->t;
  double *Y;
  island o;
  int k, i;

  for (k = 0; k < t->nisland; ++k) {
    o = island_of(D, k);
    Y = rest + t->islrow[k] * width;
    /* Y = sign y_d - Phi x of earlier islands */
    if (D->coupled[k])
      maggi_island_rates(&D->t, k, width, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->b, x,
                         V, rest);
    else
      clear(o.m * width, Y);
    for (i = 0; i < o.m; ++i) axpy(width, sign, y_d + o.row[i] * width, Y + i * width);
    solve(width, 0, &o, Y, phi_d, sign, is_square(&o) ? NULL : y, D->space, x);
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
 *   w_d - M R y_d - Phi^T G mu_d = 0,  w_d at a_d of (2) and lambda_d = G_d mu
 *   R^T:  M^ y_d = R^T w_d;  dependents:  K^T mu_d = w_d - M R y_d
 *
 * With lambda_d = P G_d mu, mu_d is what this gives less A^-1 G^T G_d mu. */

/* lambda = G_d mu, or P G_d mu and range = A^-1 G^T G_d mu */
ALWAYS_INLINE void multipliers(int width, maggi_derivative *D, const double *phi_d, double *range,
                               double *lambda)
{
  island o;
  int k, i;

  for (k = 0; k < D->d->t.nisland; ++k) {
    o = island_of(D, k);
    island_product(width, &o, phi_d, D->d->mu, D->rest);
    for (i = 0; i < o.n && range; ++i) range[o.dep[i]] = 0.0;
    if (is_delicate(&o)) solve(width, 1, &o, D->rest, NULL, 0.0, NULL, D->space, range);
    scatter_rows(width, &o, D->rest, lambda);
  }
}

void maggi_multipliers_d(maggi_derivative *D, const maggi_companion *s)
{
  multipliers(1, D, s->phi, D->range, s->lambda);
}

void maggi_multipliers_dv(maggi_derivative *D, const maggi_companion *s)
{
  multipliers(MAGGI_NDIR, D, s->phi, NULL, s->lambda);
}

void maggi_move_independents(maggi_derivative *D, const double *w, double *x)
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

  maggi_move_independents(D, s->w, D->moved);
  for (i = 0; i < D->d->t.nq; ++i) s->a[i] += D->moved[i];
}

/* U^T U y = y in place, all directions; `first` of a column is where it begins */
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

/* ------------------------------------------------------------------------------ for second derivatives */

void maggi_multipliers_rest_d(maggi_derivative *D, const maggi_companion *s)
{
  const maggi_topo *t = &D->d->t;
  int i;

  memcpy(D->work, s->w, (size_t)t->nq * sizeof(double));
  maggi_subtract_inertia(D->d, D->moved, D->work);
  maggi_solve_transposed(D, D->work, D->mu_d, D->rows);
  for (i = 0; i < t->islrow[t->nisland]; ++i) s->lambda[D->rowloop[i]] += D->rows[D->rowloop[i]];
  for (i = 0; i < t->ndep; ++i) D->mu_d[t->dep[i]] -= D->range[t->dep[i]];
}

void maggi_multipliers_rest_dv(maggi_derivative *D, const maggi_companion *s)
{
  enum { W = MAGGI_NDIR };
  const maggi_topo *t = &D->d->t;
  int i, c;

  for (c = 0; c < W; ++c) {
    for (i = 0; i < t->nq; ++i) D->work[i] = s->w[i * W + c];
    maggi_solve_transposed(D, D->work, D->mu_d, D->rows);
    for (i = 0; i < t->islrow[t->nisland]; ++i)
      s->lambda[D->rowloop[i] * W + c] += D->rows[D->rowloop[i]];
  }
}

void maggi_remainders_d(maggi_derivative *D, const maggi_companion *s)
{
  maggi_project_rows(D, s->rate, s->phi, D->d->rate);
  maggi_project_rows(D, s->gama, s->phi, D->d->gama);
}

/* --------------------------------------------------------------------------- for adjoints as well */

void maggi_subtract_inertia(const maggi_data *d, const double *x, double *y)
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

void maggi_solve_transposed(const maggi_derivative *D, const double *w, double *x, double *y)
{
  const maggi_data *d = D->d;

  maggi_loop_multipliers(&D->t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->b, d->phi,
                         d->chol, w, d->G1, d->y1, x, y, d->space);
}
