/* Gradients by going back through a simulation of the penalty formulation, whose states are all
 * kept. */
#include <stdlib.h>
#include <string.h>

#include "reversal.h"
#include "study.h"

typedef struct work {
  maggi_seeds seeds; /* first: the two addresses are one */
  maggi_study *s;
  maggi_tape *start; /* of the first node alone */
  maggi_reversal *reversal;
  maggi_penalty_derivative *implicit;
  double *state; /* (samples x 3 x nq) q, v, a */
  double *p;     /* gradient by parameters */
  int nchoice;   /* choices of independent coordinates */
  long *from;    /* (nchoice) first sample that has it */
  char *choice;  /* (nchoice) maggi_saved_plan */
  long plans;    /* d->plans at the last of them */
} work;

static int seeds_of(maggi_seeds *seeds, int lane, long k, const int **signal, const double **weight)
{
  maggi_study *s = ((work *)seeds)->s;

  if (lane == 0) maggi_get_signals(s->d, s->nsignal, s->signal, s->sample);
  return maggi_study_weights(s, lane, k, signal, weight);
}

static double *state_at(const work *w, long k)
{
  return w->state + (size_t)k * 3 * (size_t)w->s->d->t.nq;
}

static void keep(work *w, long k)
{
  const maggi_data *d = w->s->d;
  size_t nq = (size_t)d->t.nq;
  double *x = state_at(w, k);

  memcpy(x, d->q, nq * sizeof(double));
  memcpy(x + nq, d->v, nq * sizeof(double));
  memcpy(x + 2 * nq, d->a, nq * sizeof(double));
}

static maggi_saved_plan choice_at(const work *w, int i)
{
  const maggi_topo *t = &w->s->d->t;
  maggi_saved_plan plan;

  maggi_saved_plan_place(&plan, t, w->choice + (size_t)i * maggi_saved_plan_size(t));
  return plan;
}

/* the choice at sample k, if it is another one than before */
static maggi_status keep_choice(work *w, long k)
{
  maggi_data *d = w->s->d;
  size_t n = (size_t)w->nchoice + 1;
  maggi_saved_plan plan;
  void *memory;

  if (k > 0 && w->plans == d->plans) return MAGGI_OK;
  memory = realloc(w->from, n * sizeof *w->from);
  if (!memory) return MAGGI_E_MEMORY;
  w->from = memory;
  memory = realloc(w->choice, n * maggi_saved_plan_size(&d->t));
  if (!memory) return MAGGI_E_MEMORY;
  w->choice = memory;
  plan = choice_at(w, w->nchoice);
  maggi_plan_save(d, &plan);
  w->from[w->nchoice++] = k;
  w->plans = d->plans;
  return MAGGI_OK;
}

/* back to the choice at sample k */
static maggi_status load_choice(work *w, long k)
{
  maggi_saved_plan plan;

  if (w->from[w->nchoice - 1] <= k) return MAGGI_OK;
  while (w->from[w->nchoice - 1] > k) --w->nchoice;
  plan = choice_at(w, w->nchoice - 1);
  return maggi_plan_load(w->s->d, &plan);
}

static void load(const double *x, int nq, double *q, double *v, double *a)
{
  memcpy(q, x, (size_t)nq * sizeof(double));
  memcpy(v, x + nq, (size_t)nq * sizeof(double));
  memcpy(a, x + 2 * nq, (size_t)nq * sizeof(double));
}

static maggi_status simulate(work *w)
{
  maggi_study *s = w->s;
  maggi_status status = maggi_penalty_reset(s->penalty);
  long k;

  if (status == MAGGI_OK) status = maggi_study_begin(s);
  if (status == MAGGI_OK) status = maggi_tape_begin(w->start);
  s->d->follower = NULL;
  for (k = 0; k <= s->grid.steps && status == MAGGI_OK; ++k) {
    if (k > 0) status = maggi_study_advance(s, k - 1);
    if (status != MAGGI_OK) return status;
    maggi_study_push(s, k);
    keep(w, k);
    status = keep_choice(w, k);
    if (status == MAGGI_OK)
      status = maggi_study_progress(s, 0.3 * (double)k / (double)s->grid.steps);
  }
  if (status == MAGGI_OK) status = maggi_study_end(s);
  return status == MAGGI_OK ? maggi_study_differentiable(s) : status;
}

/* from sample k, and with it, to the one before */
static maggi_status go_back(work *w, long k)
{
  static const double node[MAGGI_BETWEEN][6] = {
      {0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 1}, {0, 0, 0, 1, 0, 0}};
  maggi_study *s = w->s;
  maggi_penalty *penalty = s->penalty;
  maggi_data *d = s->d;
  double time = maggi_grid_time(&s->grid, k);
  maggi_status status = load_choice(w, k);

  if (status == MAGGI_OK)
    status = maggi_reversal_sample(w->reversal, state_at(w, k), time, k, node);
  if (status != MAGGI_OK) return status;
  load(state_at(w, k - 1), d->t.nq, penalty->q0, penalty->v0, penalty->a0);
  load(state_at(w, k), d->t.nq, d->q, d->v, d->a);
  return maggi_penalty_adjoint_step(w->implicit, w->reversal, maggi_study_step(s, k - 1), time);
}

static maggi_status run(work *w)
{
  maggi_study *s = w->s;
  maggi_status status = simulate(w);
  long k;

  if (status == MAGGI_OK) status = maggi_reversal_create(s->d, s->n, &w->seeds, 0, &w->reversal);
  if (status == MAGGI_OK)
    status = maggi_penalty_derivative_create(s->penalty, w->reversal->D, &w->implicit);
  for (k = s->grid.steps; k > 0 && status == MAGGI_OK; --k) {
    status = go_back(w, k);
    if (status == MAGGI_OK)
      status = maggi_study_progress(s, 1.0 - 0.7 * (double)(k - 1) / (double)s->grid.steps);
  }
  if (status == MAGGI_OK) status = load_choice(w, 0);
  return status == MAGGI_OK ? maggi_reversal_finish(w->reversal, w->start) : status;
}

maggi_status maggi_gradient_penalty_adjoint(maggi_study *s)
{
  size_t numbers = (size_t)(s->grid.steps + 1) * 3 * (size_t)s->d->t.nq;
  work w = {.seeds = {seeds_of}, .s = s};
  maggi_status status;

  if (numbers > s->options->memory / sizeof(double))
    return maggi_data_fail(s->d, MAGGI_E_MEMORY,
                           "the states of the simulation do not fit into the memory allowed");
  status = maggi_tape_create(s->d, &w.start);
  w.state = malloc((numbers + 1) * sizeof(double));
  w.p = malloc(((size_t)s->d->t.np + 1) * sizeof(double));
  if (!w.state || !w.p) status = MAGGI_E_MEMORY;
  s->options->kept = s->grid.steps;
  if (status == MAGGI_OK) status = run(&w);
  if (status == MAGGI_E_MEMORY) maggi_data_fail(s->d, status, "out of memory");
  if (status == MAGGI_OK) maggi_study_gather(s, w.reversal, w.p);
  maggi_penalty_derivative_free(w.implicit);
  maggi_reversal_free(w.reversal);
  maggi_tape_free(w.start);
  free(w.state);
  free(w.p);
  free(w.from);
  free(w.choice);
  return status;
}
