/* The semi-recursive penalty formulation with the trapezoidal rule.  FORMULATION 8, [1] 4.3-4.16.
 *
 *   z' = 2/h (z - z_0) - z_0',   z'' = 4/h^2 (z - z_0) - 4/h z_0' - z_0''
 *   F(z) = h^2/4 (M z'' + Phi_z^T alpha Phi - Q) = 0      by Newton's method with W
 *
 * Then velocities and accelerations are projected onto those that the loops allow, with the mass
 * matrix as the weight and B = M + h^2/4 alpha Phi_z^T Phi_z:
 *
 *   B (z' - z'*)   = -h^2/4 Phi_z^T alpha (Phi_z z'* + Phi_t)
 *   B (z'' - z''*) = -h^2/4 Phi_z^T alpha (Phi_z z''* + Phi_z' z' + Phi_t')
 *
 * [1] has W in the place of B, whose factors it has; but B is symmetric, and a derivative of the
 * projection needs no second derivatives of forces.  The motions differ by less than the error of
 * the rule. */
#include "penalty.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "chain.h"

void maggi_penalty_options_init(maggi_penalty_options *options)
{
  options->penalty = 1e8;
  options->tolerance = 1e-8;
  options->jacobian = MAGGI_JACOBIAN_TANGENT_COLOURED;
  options->reuse = 3;
  options->iterations = 30;
}

void maggi_penalty_trapezoid(maggi_penalty *s, double h, double *v, double *a)
{
  const double *q = s->d->q;
  int i;

  for (i = 0; i < s->d->t.nq; ++i) {
    v[i] = 2.0 / h * (q[i] - s->q0[i]) - s->v0[i];
    a[i] = 4.0 / (h * h) * (q[i] - s->q0[i]) - 4.0 / h * s->v0[i] - s->a0[i];
  }
}

/* ---------------------------------------------------------------------------------------- step */

static const int *free_coordinates(const maggi_penalty *s)
{
  return s->matrix->pattern->q;
}

static maggi_status fail_singular(maggi_penalty *s, double time)
{
  return maggi_data_fail(s->d, MAGGI_E_MASS,
                         "t = %.6g s: the tangent matrix of the penalty formulation is singular",
                         time);
}

/* one iteration; *change is the largest move of a coordinate */
static maggi_status iterate(maggi_penalty *s, double h, double time, int iteration, double *change)
{
  maggi_data *d = s->d;
  const int *q = free_coordinates(s);
  int i;

  maggi_penalty_trapezoid(s, h, d->v, d->a);
  if (iteration % s->options.reuse == 0) {
    maggi_force_jacobian_compute(s->jacobian, time);
    maggi_chain_accelerate(d, s->options.penalty);
    ++s->state.jacobians;
  } else {
    maggi_chain_evaluate(d, time, s->options.penalty);
  }
  maggi_tangent_matrix_project(s->matrix, h, s->options.penalty);
  maggi_tangent_matrix_newton(s->matrix, h, s->jacobian->value);
  if (!maggi_factor_compute(s->newton, s->matrix->newton)) return fail_singular(s, time);
  for (i = 0; i < s->n; ++i) s->x[i] = 0.25 * h * h * d->w[q[i]];
  maggi_factor_solve(s->newton, 1, s->x);
  *change = 0.0;
  for (i = 0; i < s->n; ++i) {
    d->q[q[i]] += s->x[i];
    *change = isfinite(s->x[i]) ? fmax(*change, fabs(s->x[i])) : NAN;
    if (isnan(*change)) break;
  }
  ++s->state.iterations;
  return MAGGI_OK;
}

static maggi_status solve(maggi_penalty *s, double h, double time)
{
  maggi_status status;
  double change = INFINITY;
  int i;

  for (i = 0; i < s->options.iterations; ++i) {
    status = iterate(s, h, time, i, &change);
    if (status != MAGGI_OK) return status;
    if (change <= s->options.tolerance) return MAGGI_OK;
    if (!(change < 1e6)) break;
  }
  return maggi_data_fail(s->d, MAGGI_E_NOT_FINITE,
                         "t = %.6g s: Newton's method does not converge (last move %.3g after %d "
                         "iterations); is the step too large?",
                         time, change, i < s->options.iterations ? i + 1 : i);
}

/* x of the coordinates that are not guided, from y, the rate or the acceleration at which loops
 * open, to where the loops allow it */
static void project(maggi_penalty *s, double h, const double *y, double *x)
{
  const int *q = free_coordinates(s);
  int i;

  for (i = 0; i < s->d->t.nrow; ++i)
    s->rest.data.lambda[i] = 0.25 * h * h * s->options.penalty * y[i];
  maggi_rest_evaluate(&s->rest);
  for (i = 0; i < s->n; ++i) s->x[i] = s->rest.data.w[q[i]];
  maggi_factor_solve(s->projection, 1, s->x);
  for (i = 0; i < s->n; ++i) x[q[i]] += s->x[i];
}

/* velocities, then accelerations, of a position that has been found */
static maggi_status finish(maggi_penalty *s, double h, double time)
{
  maggi_data *d = s->d;
  const maggi_topo *t = &d->t;
  int i;

  maggi_penalty_trapezoid(s, h, d->v, d->a);
  maggi_chain_evaluate(d, time, s->options.penalty);
  memcpy(s->vs, d->v, (size_t)t->nq * sizeof(double));
  memcpy(s->as, d->a, (size_t)t->nq * sizeof(double));
  if (t->nrow == 0) return MAGGI_OK;
  maggi_tangent_matrix_project(s->matrix, h, s->options.penalty);
  if (!maggi_factor_compute(s->projection, s->matrix->projection)) return fail_singular(s, time);
  maggi_chain_rates(d);
  project(s, h, d->rate, d->v);
  maggi_chain_evaluate(d, time, s->options.penalty);
  maggi_chain_gamma(d);
  for (i = 0; i < t->nrow; ++i) d->gama[i] = -d->gama[i];
  project(s, h, d->gama, d->a);
  return MAGGI_OK;
}

/* torques and forces of guides, what is left of w on their coordinates, and their power */
static void drive(maggi_penalty *s)
{
  maggi_data *d = s->d;
  const maggi_topo *t = &d->t;
  int i, q;

  maggi_balance(d);
  maggi_generalised_forces(t, (void *)d->b, (void *)d->FSr, d->tau, s->x);
  for (i = t->nind; i < t->ncol; ++i) {
    q = t->colq[i];
    d->drive[i] = -s->x[q];
    d->power[0] += d->drive[i] * d->v[q];
  }
}

/* The results of a state.  Multipliers are those of the dependent coordinates: other ones when these have
 * become bad, as by maggi_step. */
static maggi_status evaluate(maggi_data *d, double time)
{
  maggi_status status;
  int is_new;

  maggi_evaluate_given(d, time);
  status = maggi_plan_watch(d, &is_new);
  if (status != MAGGI_OK || !is_new) return status;
  maggi_evaluate_given(d, time);
  d->pivot_ratio = d->stage_ratio;
  return MAGGI_OK;
}

maggi_status maggi_penalty_step(maggi_penalty *s, double h)
{
  maggi_data *d = s->d;
  size_t bytes = (size_t)d->t.nq * sizeof(double);
  double time = d->time + h, power = d->power[0];
  maggi_status status;
  int i;

  if (!d->ready)
    return maggi_data_fail(d, MAGGI_E_MODEL, "a step needs a successful reset before it");
  if (!isfinite(h) || h == 0.0)
    return maggi_data_fail(d, MAGGI_E_VALUE, "the step must be finite and not zero");
  d->ready = d->is_ahead = 0;
  memcpy(s->q0, d->q, bytes);
  memcpy(s->v0, d->v, bytes);
  memcpy(s->a0, d->a, bytes);
  for (i = 0; i < d->t.nq; ++i) d->q[i] += h * (s->v0[i] + 0.5 * h * s->a0[i]);
  status = solve(s, h, time);
  if (status == MAGGI_OK) status = finish(s, h, time);
  if (status == MAGGI_OK) status = evaluate(d, time);
  if (status != MAGGI_OK) return status;
  if (d->t.nguide > 0) drive(s);
  d->work += 0.5 * h * (power + d->power[0]);
  d->time = time;
  d->ready = 1;
  ++s->state.steps;
  return MAGGI_OK;
}

maggi_status maggi_penalty_reset(maggi_penalty *s)
{
  maggi_status status = maggi_data_reset(s->d);
  maggi_penalty_state *c = &s->state;

  c->steps = c->iterations = c->jacobians = 0;
  return status;
}

void maggi_penalty_get_state(const maggi_penalty *s, maggi_penalty_state *state)
{
  *state = s->state;
}

/* -------------------------------------------------------------------------------------- memory */

static int place_vectors(maggi_penalty *s)
{
  size_t nq = (size_t)s->d->t.nq + 1;
  double **vector[] = {&s->q0, &s->v0, &s->a0, &s->vs, &s->as, &s->x};
  size_t i, n = sizeof vector / sizeof *vector;

  s->memory = calloc(n * nq, sizeof(double));
  for (i = 0; i < n && s->memory; ++i) *vector[i] = s->memory + i * nq;
  return s->memory != NULL;
}

static maggi_status check(maggi_data *d, const maggi_penalty_options *o)
{
  if (d->t.nfilter > 0)
    return maggi_data_fail(
        d, MAGGI_E_MODEL,
        "the penalty formulation does not integrate filters, which the model has");
  if (!isfinite(o->penalty) || !(o->penalty > 0.0))
    return maggi_data_fail(d, MAGGI_E_VALUE, "the penalty must be positive");
  if (!isfinite(o->tolerance) || !(o->tolerance > 0.0))
    return maggi_data_fail(d, MAGGI_E_VALUE, "the tolerance of Newton's method must be positive");
  if ((int)o->jacobian < 0 || o->jacobian >= MAGGI_JACOBIAN_COUNT)
    return maggi_data_fail(d, MAGGI_E_VALUE, "way %d to the Jacobian does not exist",
                           (int)o->jacobian);
  if (o->reuse < 1 || o->iterations < 1)
    return maggi_data_fail(d, MAGGI_E_VALUE, "iterations and reuse must be at least 1");
  return MAGGI_OK;
}

maggi_status maggi_penalty_create(maggi_data *d, const maggi_penalty_options *options,
                                  maggi_penalty **penalty)
{
  maggi_penalty *s;
  maggi_status status = check(d, options);

  *penalty = NULL;
  if (status != MAGGI_OK) return status;
  s = calloc(1, sizeof *s);
  if (!s) return maggi_data_fail(d, MAGGI_E_MEMORY, "out of memory");
  s->d = d;
  s->options = *options;
  status = place_vectors(s) ? MAGGI_OK : MAGGI_E_MEMORY;
  if (status == MAGGI_OK) status = maggi_force_jacobian_create(d, options->jacobian, &s->jacobian);
  if (status == MAGGI_OK) status = maggi_rest_create(d, NULL, &s->rest);
  if (status == MAGGI_OK) status = maggi_tangent_matrix_create(d, s->jacobian->pattern, &s->matrix);
  if (status == MAGGI_OK) status = maggi_factor_create(&s->matrix->places, &s->newton);
  if (status == MAGGI_OK) status = maggi_factor_create(&s->matrix->places, &s->projection);
  if (status != MAGGI_OK) {
    maggi_penalty_free(s);
    return maggi_data_fail(d, status, "out of memory");
  }
  s->n = s->jacobian->pattern->n;
  s->state.nonzeros = s->jacobian->pattern->J.coladr[2 * s->n];
  s->state.colours = s->jacobian->colouring ? s->jacobian->colouring->ncolour : 2 * s->n;
  *penalty = s;
  return MAGGI_OK;
}

void maggi_penalty_free(maggi_penalty *s)
{
  if (!s) return;
  maggi_force_jacobian_free(s->jacobian);
  maggi_tangent_matrix_free(s->matrix);
  maggi_factor_free(s->newton);
  maggi_factor_free(s->projection);
  maggi_rest_free(&s->rest);
  free(s->memory);
  free(s);
}
