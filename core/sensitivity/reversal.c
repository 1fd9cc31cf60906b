/* Going back through a simulation: nodes, samples, changes of coordinates, the initial state. */
#include "reversal.h"

#include <stdlib.h>
#include <string.h>

#include "equilibrium.h"
#include "results.h"

static size_t bytes(const maggi_data *d)
{
  return (size_t)d->t.nq * sizeof(double);
}

static size_t filter_bytes(const maggi_data *d)
{
  return (size_t)d->t.nstate * sizeof(double);
}

static void add(int n, double f, const double *x, double *y)
{
  int i;

  for (i = 0; i < n; ++i) y[i] += f * x[i];
}

maggi_status maggi_reversal_evaluate(maggi_reversal *r, const maggi_tape *tape, const double *state,
                                     double time)
{
  maggi_tape_load(tape, state);
  maggi_evaluate(r->d, time);
  maggi_evaluate_filters(r->d);
  return maggi_linearise_at(r->D, time);
}

void maggi_reversal_choose(maggi_reversal *r, const maggi_lane *lane, const double *v,
                           const double *a)
{
  maggi_companion *s = &r->D->adjoint;

  maggi_place_constants(s, &r->d->t, lane->constants);
  maggi_companion_clear(s);
  memcpy(s->v, v, bytes(r->d));
  memcpy(s->a, a, bytes(r->d));
}

void maggi_reversal_results(maggi_reversal *r, const maggi_lane *lane, unsigned need)
{
  need |= r->need;
  if (!need) return;
  memcpy(r->D->adjoint.yrate, lane->yrate, filter_bytes(r->d));
  maggi_adjoint_results(r->D, need);
}

/* what the sweep has left: positions, velocities of independent coordinates, states of filters */
static void add_state(const maggi_reversal *r, const maggi_lane *x)
{
  const maggi_topo *t = &r->d->t;
  int i;

  add(t->nq, 1.0, r->D->adjoint.q, x->q);
  add(t->nstate, 1.0, r->D->adjoint.y, x->y);
  for (i = 0; i < t->nind; ++i) x->u[t->colq[i]] += r->D->adjoint.v[t->colq[i]];
}

/* ------------------------------------------------------------------------------------- samples */

/* adjoints of the signals of sample k for a lane that has been chosen, and what they need; false if all are
 * zero */
static int seed(maggi_reversal *r, int lane, long k, unsigned *need)
{
  const int *signal;
  const double *weight;
  int n = r->seeds->of(r->seeds, lane, k, &signal, &weight);

  *need = n > 0 ? maggi_signals_need(r->d->m, n, signal) : 0;
  if (n == 0) return 0;
  maggi_signals_seed(r->D, n, signal, weight);
  return 1;
}

maggi_status maggi_reversal_sample(maggi_reversal *r, const double *given, double time, long k,
                                   const double c[MAGGI_BETWEEN][6])
{
  maggi_data *d = r->d;
  const maggi_companion *x = &r->D->adjoint;
  const double *from[3] = {x->q, x->v, x->a};
  maggi_status status;
  unsigned need;
  int i, m, nq = d->t.nq;

  memcpy(d->q, given, bytes(d));
  memcpy(d->v, given + nq, bytes(d));
  memcpy(d->a, given + 2 * nq, bytes(d));
  memcpy(d->y, given + 3 * nq, filter_bytes(d));
  maggi_evaluate_given(d, time);
  status = maggi_linearise_at(r->D, time);
  for (i = 0; i < r->n && status == MAGGI_OK; ++i) {
    maggi_lane *y = &r->lane[i];
    double *to[6] = {y->q0, y->v0, y->a0, y->q, y->v, y->a};
    double *filter_to[6] = {y->y0, y->yrate0, NULL, y->y, y->yrate, NULL};

    maggi_reversal_choose(r, y, d->zero, d->zero);
    if (!seed(r, i, k, &need)) continue;
    maggi_adjoint_given(r->D, need);
    for (m = 0; m < 18; ++m) add(nq, c[m / 6][m % 6], from[m / 6], to[m % 6]);
    for (m = 0; m < 6; ++m)
      if (filter_to[m]) add(d->t.nstate, c[3][m], x->y, filter_to[m]);
  }
  return status;
}

/* -------------------------------------------------------------------------------------- nodes */

/* back through the evaluation at a node, with sample k unless k < 0 */
static maggi_status go_through(maggi_reversal *r, const maggi_tape *tape, long node, long k)
{
  maggi_data *d = r->d;
  maggi_status status =
      maggi_reversal_evaluate(r, tape, maggi_tape_state(tape, node, 0), tape->step[node].time);
  unsigned need;
  int i;

  for (i = 0; i < r->n && status == MAGGI_OK; ++i) {
    maggi_lane *x = &r->lane[i];

    need = 0;
    maggi_reversal_choose(r, x, x->v, x->a);
    if (k >= 0) seed(r, i, k, &need);
    maggi_reversal_results(r, x, need);
    maggi_adjoint_motion(r->D);
    add_state(r, x);
    memset(x->v, 0, bytes(d));
    memset(x->a, 0, bytes(d));
    memset(x->yrate, 0, filter_bytes(d));
  }
  return status;
}

/* before a change of coordinates at a node, the velocities of the new ones were those of an evaluation with
 * the old ones */
static maggi_status go_before_changes(maggi_reversal *r, maggi_tape *tape, long node)
{
  maggi_data *d = r->d;
  maggi_tape_change *c;
  maggi_saved_plan plan;
  maggi_status status = MAGGI_OK;
  int i;

  while (status == MAGGI_OK && tape->nchange > 0 && tape->change[tape->nchange - 1].node == node) {
    c = &tape->change[--tape->nchange];
    maggi_saved_plan_place(&plan, &d->t, c->plan);
    status = maggi_plan_load(d, &plan);
    if (status != MAGGI_OK) return status;
    memcpy(d->q, maggi_tape_state(tape, node, 0), bytes(d));
    memcpy(d->vcol, c->u, (size_t)d->t.nind * sizeof(double));
    maggi_evaluate(d, tape->step[node].time);
    status = maggi_linearise_at(r->D, tape->step[node].time);
    for (i = 0; i < r->n && status == MAGGI_OK; ++i) {
      maggi_lane *x = &r->lane[i];

      maggi_reversal_choose(r, x, x->u, d->zero);
      maggi_adjoint_motion(r->D);
      memset(x->u, 0, bytes(d));
      add_state(r, x);
    }
  }
  return status;
}

/* the evaluation there and what came before it becomes that of the node before */
static void step_back(maggi_reversal *r)
{
  int i, nq = r->d->t.nq, nstate = r->d->t.nstate;

  for (i = 0; i < r->n; ++i) {
    maggi_lane *x = &r->lane[i];

    add(nq, 1.0, x->q0, x->q);
    add(nq, 1.0, x->v0, x->v);
    add(nq, 1.0, x->a0, x->a);
    memset(x->q0, 0, bytes(r->d));
    memset(x->v0, 0, bytes(r->d));
    memset(x->a0, 0, bytes(r->d));
    add(nstate, 1.0, x->y0, x->y);
    add(nstate, 1.0, x->yrate0, x->yrate);
    memset(x->y0, 0, filter_bytes(r->d));
    memset(x->yrate0, 0, filter_bytes(r->d));
  }
}

maggi_status maggi_reversal_step(maggi_reversal *r, maggi_tape *tape, long j, long k)
{
  const maggi_tape_sample *s = &tape->sample[j];
  maggi_status status = MAGGI_OK;
  long i;

  if (s->is_between)
    status =
        maggi_reversal_sample(r, tape->given + maggi_tape_given_size(&r->d->t) * (size_t)s->given,
                              s->time, k, (void *)s->c);
  for (i = s->steps - 1; i >= tape->sample[j - 1].steps && status == MAGGI_OK; --i) {
    status = go_through(r, tape, i + 1, i + 1 == s->steps && !s->is_between ? k : -1);
    if (status == MAGGI_OK) status = go_before_changes(r, tape, i + 1);
    if (status != MAGGI_OK) return status;
    status = (r->is_continuous ? maggi_continuous_step : maggi_discrete_step)(r, tape, i);
    step_back(r);
  }
  return status;
}

/* -------------------------------------------------------------------------------- initial state */

static void start_lane(maggi_reversal *r, maggi_lane *x)
{
  const maggi_data *d = r->d;
  const maggi_companion *s = &r->D->adjoint;
  int i, adr;

  maggi_reversal_choose(r, x, d->zero, d->zero);
  memcpy(s->q, x->q, bytes(d));
  maggi_adjoint_closure(r->D);
  if (d->equilibrium) {
    maggi_equilibrium_adjoint(d->equilibrium, s, s->q);
    return;
  }
  for (i = 0; i < d->t.nq; ++i) {
    adr = maggi_initial_position(d, i);
    if (adr >= 0 && maggi_is_independent(&d->t, i)) s->p[adr] += s->q[i];
  }
}

/* the velocities of wheels that start rolling followed from those of the others */
static void go_before_rolling(maggi_reversal *r, maggi_lane *x)
{
  const maggi_topo *t = &r->d->t;
  int i;

  maggi_reversal_choose(r, x, r->d->zero, r->d->zero);
  maggi_adjoint_rolling(r->D, x->u);
  for (i = 0; i < t->nwheel; ++i) x->u[t->qid[t->wheelbody[i]]] = 0.0;
  maggi_adjoint_motion(r->D);
  add_state(r, x);
}

maggi_status maggi_reversal_finish(maggi_reversal *r, maggi_tape *tape)
{
  maggi_data *d = r->d;
  maggi_status status = go_through(r, tape, 0, 0);
  int i, c, q;

  if (status == MAGGI_OK) status = go_before_changes(r, tape, 0);
  if (status != MAGGI_OK) return status;
  for (i = 0; i < r->n; ++i) {
    if (d->m->rolling) go_before_rolling(r, &r->lane[i]);
    maggi_reversal_choose(r, &r->lane[i], d->zero, d->zero);
    for (c = 0; c < d->t.nind; ++c) {
      q = d->t.colq[c];
      r->D->adjoint.p[d->m->initial_velocity[q]] += r->lane[i].u[q];
    }
  }
  if (d->is_kept) {
    memcpy(d->v0, d->v, bytes(d));
    d->time = tape->step[0].time;
    status = maggi_evaluate_start(d, 1);
    if (status == MAGGI_OK) status = maggi_linearise_at(r->D, d->time);
  }
  for (i = 0; i < r->n && status == MAGGI_OK; ++i) start_lane(r, &r->lane[i]);
  return status;
}

void maggi_reversal_gradient(maggi_reversal *r, int lane, double *p)
{
  maggi_place_constants(&r->D->adjoint, &r->d->t, r->lane[lane].constants);
  maggi_parameters_vjp(r->D, p);
}

/* -------------------------------------------------------------------------------------- memory */

maggi_status maggi_reversal_create(maggi_data *d, int n, maggi_seeds *seeds, int is_continuous,
                                   maggi_reversal **reversal)
{
  maggi_reversal *r = calloc(1, sizeof *r);
  size_t nq = (size_t)d->t.nq, nstate = (size_t)d->t.nstate, size = 0;
  double *at;
  int i;

  *reversal = NULL;
  if (!r) return MAGGI_E_MEMORY;
  r->d = d;
  r->n = n;
  r->seeds = seeds;
  r->need = maggi_filters_need(d->m);
  r->is_continuous = is_continuous;
  if (maggi_derivative_create(d, 0, &r->D) != MAGGI_OK) {
    maggi_reversal_free(r);
    return MAGGI_E_MEMORY;
  }
#define X(name) size += nq;
  MAGGI_LANE_LIST(X)
#undef X
#define X(name) size += nstate;
  MAGGI_LANE_FILTER_LIST(X)
#undef X
  r->lane = calloc((size_t)n + 1, sizeof *r->lane);
  r->memory = calloc(size * (size_t)n + 1, sizeof(double));
  r->constants =
      aligned_alloc(64, (size_t)(n + 1) * r->D->adjoint.nconstants * sizeof(double) + 64);
  if (!r->lane || !r->memory || !r->constants) {
    maggi_reversal_free(r);
    return MAGGI_E_MEMORY;
  }
  memset(r->constants, 0, (size_t)n * r->D->adjoint.nconstants * sizeof(double));
  at = r->memory;
  for (i = 0; i < n; ++i) {
    r->lane[i].constants = r->constants + (size_t)i * r->D->adjoint.nconstants;
#define X(name)                                                                                    \
  r->lane[i].name = at;                                                                            \
  at += nq;
    MAGGI_LANE_LIST(X)
#undef X
#define X(name)                                                                                    \
  r->lane[i].name = at;                                                                            \
  at += nstate;
    MAGGI_LANE_FILTER_LIST(X)
#undef X
  }
  *reversal = r;
  return MAGGI_OK;
}

void maggi_reversal_free(maggi_reversal *r)
{
  if (!r) return;
  maggi_derivative_free(r->D);
  free(r->lane);
  free(r->memory);
  free(r->constants);
  free(r);
}
