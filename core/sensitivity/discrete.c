/* Adjoint of one Runge-Kutta step and of the projection at its end.  [1] 2.62-2.66, FORMULATION 9.
 *
 *   y_2 = y_1 + h/2 k_1,  y_3 = y_1 + h/2 k_2,  y_4 = y_1 + h k_3,  y = y_1 + h/6 (k_1 + 2 k_2 + 2 k_3 + k_4)
 *
 * with k_s the slopes at y_s: all velocities, independent accelerations, rates of filters.  Backwards, a bar for adjoints,
 *
 *   k_4 = h/6 y,  k_3 = h/3 y + h y_4,  k_2 = h/3 y + h/2 y_3,  k_1 = h/6 y + h/2 y_2
 *   y_1 = y + y_2 + y_3 + y_4 and what follows from k_1, which is left to the node. */
#include <string.h>

#include "reversal.h"

static void combine(int n, double f, const double *x, double g, const double *y, double *out)
{
  int i;

  for (i = 0; i < n; ++i) out[i] = f * x[i] + g * y[i];
}

/* d is evaluated at the end of the step */
static void go_before_projection(maggi_reversal *r, maggi_lane *x)
{
  const maggi_data *d = r->d;

  maggi_reversal_choose(r, x, d->zero, d->zero);
  memcpy(r->D->adjoint.q, x->q, (size_t)d->t.nq * sizeof(double));
  maggi_adjoint_closure(r->D);
  memcpy(x->q, r->D->adjoint.q, (size_t)d->t.nq * sizeof(double));
}

/* adjoint of y_s, in dq, du and dy, from that of k_s: f y + g y_(s + 1) */
static void go_through_stage(maggi_reversal *r, maggi_lane *x, double f, double g)
{
  const maggi_topo *t = &r->d->t;
  const maggi_companion *s = &r->D->adjoint;
  int i, q;

  combine(t->nq, f, x->q, g, x->dq, x->v);
  combine(t->nq, f, x->u, g, x->du, x->a);
  combine(t->nstate, f, x->y, g, x->dy, x->yrate);
  maggi_reversal_choose(r, x, x->v, x->a);
  maggi_reversal_results(r, x, 0);
  maggi_adjoint_motion(r->D);
  memcpy(x->dy, s->y, (size_t)t->nstate * sizeof(double));
  combine(t->nstate, 1.0, x->ysum, 1.0, s->y, x->ysum);
  memcpy(x->dq, s->q, (size_t)t->nq * sizeof(double));
  combine(t->nq, 1.0, x->qsum, 1.0, s->q, x->qsum);
  for (i = 0; i < t->nind; ++i) {
    q = t->colq[i];
    x->du[q] = s->v[q];
    x->usum[q] += s->v[q];
  }
}

maggi_status maggi_reversal_stages(maggi_reversal *r, const maggi_tape *tape, long i,
                                   maggi_stage_evaluation *evaluate)
{
  static const double part[] = {0.0, 0.5, 0.5, 1.0};
  const double weight[] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
  maggi_lane *x;
  maggi_status status = MAGGI_OK;
  size_t bytes = (size_t)r->d->t.nq * sizeof(double);
  double h = tape->step[i].h, ahead;
  int s, n = r->d->t.nq, nstate = r->d->t.nstate;

  for (x = r->lane; x < r->lane + r->n; ++x) {
    memset(x->dq, 0, bytes);
    memset(x->du, 0, bytes);
    memset(x->qsum, 0, bytes);
    memset(x->usum, 0, bytes);
    memset(x->dy, 0, (size_t)nstate * sizeof(double));
    memset(x->ysum, 0, (size_t)nstate * sizeof(double));
  }
  for (s = 3; s > 0 && status == MAGGI_OK; --s) {
    status = evaluate(r, tape, i, s);
    ahead = s < 3 ? part[s + 1] * h : 0.0;
    for (x = r->lane; x < r->lane + r->n && status == MAGGI_OK; ++x)
      go_through_stage(r, x, weight[s] * h, ahead);
  }
  for (x = r->lane; x < r->lane + r->n; ++x) {
    combine(n, weight[0] * h, x->q, part[1] * h, x->dq, x->v);
    combine(n, weight[0] * h, x->u, part[1] * h, x->du, x->a);
    combine(n, 1.0, x->q, 1.0, x->qsum, x->q);
    combine(n, 1.0, x->u, 1.0, x->usum, x->u);
    combine(nstate, weight[0] * h, x->y, part[1] * h, x->dy, x->yrate);
    combine(nstate, 1.0, x->y, 1.0, x->ysum, x->y);
  }
  return status;
}

static maggi_status evaluate(maggi_reversal *r, const maggi_tape *tape, long i, int stage)
{
  const maggi_tape_step *step = &tape->step[i];

  return maggi_reversal_evaluate(r, tape, maggi_tape_state(tape, i, stage),
                                 step->time + (stage < 3 ? 0.5 : 1.0) * step->h);
}

maggi_status maggi_discrete_step(maggi_reversal *r, const maggi_tape *tape, long i)
{
  maggi_lane *x;

  for (x = r->lane; x < r->lane + r->n && tape->step[i].is_projected; ++x)
    go_before_projection(r, x);
  return maggi_reversal_stages(r, tape, i, evaluate);
}
