#include "state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

double *state_numbers(int n)
{
  double *a = calloc((size_t)n + 1, sizeof *a);

  if (!a) abort();
  return a;
}

double *state_direction(state *s, int n)
{
  double *x = state_weights(s, n + s->np), size;
  int i;

  for (i = 0; i < s->np; ++i) {
    size = fabs(s->d->p[i]);
    x[n + i] *= size > 0.0 ? size : 0.1;
  }
  return x;
}

double *state_balanced(state *s, int n, const double *g)
{
  double *x = state_direction(s, n), most = 0.0;
  int i;

  for (i = 0; i < n + s->np; ++i) most = fmax(most, fabs(g[i] * x[i]));
  for (i = 0; i < n + s->np; ++i)
    x[i] = fabs(g[i] * x[i]) > 1e-6 * most ? (x[i] > 0.0 ? 1.0 : -1.0) / g[i] : 0.0;
  return x;
}

double *state_weights(state *s, int n)
{
  double *y = state_numbers(n);
  int i;

  for (i = 0; i < n; ++i) y[i] = mech_uniform(&s->random, -1.0, 1.0);
  return y;
}

double state_dot(int n, const double *a, const double *b, double *terms)
{
  double sum = 0.0;
  int i;

  for (i = 0; i < n; ++i) {
    sum += a[i] * b[i];
    *terms += fabs(a[i] * b[i]);
  }
  return sum;
}

double state_distance(int n, const double *a, const double *b, const double *shaken)
{
  double error = 0.0, size = 0.0, change = 0.0;
  int i;

  for (i = 0; i < n; ++i) {
    if (!isfinite(a[i])) return NAN;
    error = fmax(error, fabs(a[i] - b[i]));
    size = fmax(size, fabs(b[i]));
    if (shaken) change = fmax(change, fabs(shaken[i] - b[i]));
  }
  return error > 0.0 ? error / (size + STATE_SHARE * change / STATE_TREMOR) : 0.0;
}

void state_near(const state *s, const char *what, double residual, double limit)
{
  if (!report_near(s->seed, what, residual, limit)) fprintf(stderr, "  %s\n", s->name);
}

void state_near_sum(const state *s, const char *what, double left, double right, double terms,
                    double limit)
{
  double error = fabs(left - right);

  state_near(s, what, error > 0.0 ? error / terms : error, limit);
}

/* Another time, other parameters and velocities; positions that do not close the loops.  Moves are halved
 * where a simulation would choose other independent coordinates: there the dependent ones are hundreds
 * of times as fast, and normal equations lose twice as many digits as the state. */
static void move_away(state *s)
{
  maggi_data *d = s->d;
  double *from = state_numbers(s->nq), *move = state_numbers(s->nq), share = 1.0;
  int i;

  if (d->t.nguide == 0) s->time = mech_uniform(&s->random, -0.2, 1.2);
  for (i = 0; i < s->np; ++i) d->p[i] *= mech_uniform(&s->random, 0.98, 1.02);
  for (i = 0; i < s->nq; ++i) from[i] = d->q[i];
  for (i = 0; i < s->nq; ++i) move[i] = mech_uniform(&s->random, -0.05, 0.05);
  for (i = 0; i < d->t.nind; ++i) d->vcol[i] += mech_uniform(&s->random, -1.0, 1.0);
  maggi_constants(d);
  for (; share > 0.1; share *= 0.5) {
    for (i = 0; i < s->nq; ++i) d->q[i] = from[i] + share * move[i];
    maggi_evaluate(d, s->time);
    if (d->stage_ratio > MAGGI_RENEW_BELOW) break;
    report_count("away from closed loops: half as far");
  }
  free(from);
  free(move);
}

static state_check *check;

static void check_sample(const sample *from)
{
  maggi_data *d = from->data;
  state s = {from->name, from->seed, d, NULL, d->time, {from->seed}, d->m->ncoordinate, d->t.np};
  int ok;

  ok = maggi_derivative_create(d, (int)(s.seed % 3) * 12, &s.D) == MAGGI_OK;
  if (!report_true(s.seed, "workspace", ok)) return;
  if (report_true(s.seed, "linearise", maggi_linearise(s.D) == MAGGI_OK)) check(&s);
  move_away(&s);
  if (maggi_is_singular(d))
    report_count("away from closed loops: singular");
  else if (report_true(s.seed, "linearise", maggi_linearise_at(s.D, s.time) == MAGGI_OK))
    check(&s);
  maggi_derivative_free(s.D);
}

void state_each(const report_options *options, state_check *each)
{
  check = each;
  sample_each(options, check_sample);
}
