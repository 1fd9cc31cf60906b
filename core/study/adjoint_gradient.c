/* Gradients by going back through the simulation, which is on the tape as a whole, or step by step from
 * snapshots. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "checkpoint.h"
#include "reversal.h"
#include "study.h"

typedef struct work {
  maggi_seeds seeds; /* first: the two addresses are one */
  maggi_study *s;
  maggi_tape *tape;
  maggi_reversal *reversal;
  long looked_at; /* sample whose signals are in s->sample */
  char *snapshot; /* all */
  size_t size;    /* of one */
  double *p;      /* gradient by parameters */
} work;

static int seeds_of(maggi_seeds *seeds, int lane, long k, const int **signal, const double **weight)
{
  work *w = (work *)seeds;
  maggi_study *s = w->s;

  if (w->looked_at != k) maggi_get_signals(s->d, s->nsignal, s->signal, s->sample);
  w->looked_at = k;
  return maggi_study_weights(s, lane, k, signal, weight);
}

/* after the last sample of the simulation */
static maggi_status turn_round(work *w)
{
  maggi_study *s = w->s;
  maggi_status status = maggi_study_end(s);

  if (status == MAGGI_OK) status = maggi_study_differentiable(s);
  w->looked_at = -1;
  return status;
}

static maggi_status begin(work *w)
{
  maggi_study *s = w->s;
  maggi_status status = maggi_data_reset(s->d);

  if (status == MAGGI_OK) status = maggi_study_begin(s);
  if (status != MAGGI_OK) return status;
  maggi_study_push(s, 0);
  return maggi_reversal_create(s->d, s->n, &w->seeds,
                               s->options->method == MAGGI_METHOD_CONTINUOUS_ADJOINT, &w->reversal);
}

/* ------------------------------------------------------------------------------- whole tape */

static maggi_status run_tape(work *w)
{
  maggi_study *s = w->s;
  maggi_status status = begin(w);
  long k, l = s->grid.steps;

  if (status == MAGGI_OK) status = maggi_tape_begin(w->tape);
  for (k = 0; k < l && status == MAGGI_OK; ++k) {
    status = maggi_tape_advance(w->tape, maggi_study_step(s, k));
    if (status != MAGGI_OK) return status;
    maggi_study_push(s, k + 1);
    status = maggi_study_progress(s, 0.25 * (double)(k + 1) / (double)l);
  }
  if (status == MAGGI_OK) status = turn_round(w);
  for (k = l; k > 0 && status == MAGGI_OK; --k) {
    status = maggi_reversal_step(w->reversal, w->tape, k, k);
    if (status == MAGGI_OK)
      status = maggi_study_progress(s, 0.25 + 0.75 * (double)(l - k + 1) / (double)l);
  }
  return status;
}

/* -------------------------------------------------------------------------------- snapshots */

static maggi_status advance(work *w, const maggi_schedule *a, long *pushed)
{
  maggi_study *s = w->s;
  maggi_status status = MAGGI_OK;
  long k;

  s->d->follower = NULL;
  for (k = a->from; k < a->to && status == MAGGI_OK; ++k) {
    status = maggi_step(s->d, maggi_study_step(s, k));
    if (status != MAGGI_OK) return status;
    if (k + 1 > *pushed) {
      *pushed = k + 1;
      maggi_study_push(s, k + 1);
    } else {
      ++s->options->recomputed;
    }
    status = maggi_study_progress(s, 0.2 * (double)*pushed / (double)s->grid.steps +
                                         0.8 * (1.0 - (double)a->end / (double)s->grid.steps));
  }
  return status;
}

static maggi_status reverse(work *w, long k)
{
  maggi_study *s = w->s;
  maggi_status status = maggi_tape_begin(w->tape);

  if (status == MAGGI_OK) status = maggi_tape_advance(w->tape, maggi_study_step(s, k));
  if (status != MAGGI_OK) return status;
  if (k + 1 == s->grid.steps) {
    maggi_study_push(s, k + 1);
    status = turn_round(w);
  }
  if (status == MAGGI_OK) status = maggi_reversal_step(w->reversal, w->tape, 1, k + 1);
  return status;
}

static maggi_status run_schedule(work *w, maggi_schedule *a)
{
  maggi_data *d = w->s->d;
  maggi_status status = begin(w);
  long pushed = 0;

  while (status == MAGGI_OK) {
    switch (maggi_schedule_next(a)) {
    case MAGGI_SCHEDULE_STORE:
      maggi_snapshot_save(d, w->snapshot + (size_t)a->slot * w->size);
      break;
    case MAGGI_SCHEDULE_RESTORE:
      status = maggi_snapshot_load(d, w->snapshot + (size_t)a->slot * w->size);
      break;
    case MAGGI_SCHEDULE_ADVANCE:
      status = advance(w, a, &pushed);
      break;
    case MAGGI_SCHEDULE_REVERSE:
      status = reverse(w, a->from);
      break;
    default: /* MAGGI_SCHEDULE_DONE */
      return MAGGI_OK;
    }
  }
  return status;
}

static maggi_status run_snapshots(work *w, int snapshots)
{
  maggi_schedule a;
  maggi_status status = maggi_schedule_init(&a, w->s->grid.steps, snapshots);

  if (status != MAGGI_OK) return status;
  w->size = maggi_snapshot_size(&w->s->d->t);
  w->snapshot = malloc((size_t)a.slots * w->size);
  w->s->options->kept = a.slots;
  status = w->snapshot ? run_schedule(w, &a) : MAGGI_E_MEMORY;
  maggi_schedule_free(&a);
  return status;
}

/* ------------------------------------------------------------------------------------- method */

/* 0: the whole simulation fits */
static int count_snapshots(const maggi_study *s)
{
  const maggi_gradient_options *o = s->options;
  size_t n;

  if (o->snapshots > 0) return o->snapshots;
  if ((size_t)s->grid.steps <= o->memory / maggi_tape_step_size(s->d)) return 0;
  n = o->memory / maggi_snapshot_size(&s->d->t);
  return n < 1 ? 1 : n > INT_MAX ? INT_MAX : (int)n;
}

void maggi_study_gather(maggi_study *s, maggi_reversal *r, double *p)
{
  int i;

  for (i = 0; i < s->n; ++i) {
    maggi_reversal_gradient(r, i, p);
    maggi_design_pull(s->design, p, s->gradient + i * maggi_design_number(s->design));
  }
}

maggi_status maggi_gradient_adjoint(maggi_study *s)
{
  work w = {.seeds = {seeds_of}, .s = s};
  maggi_status status = maggi_tape_create(s->d, &w.tape);
  int snapshots = count_snapshots(s);

  w.p = malloc(((size_t)s->d->t.np + 1) * sizeof(double));
  if (!w.p) status = MAGGI_E_MEMORY;
  s->options->kept = s->grid.steps;
  if (status == MAGGI_OK) status = snapshots > 0 ? run_snapshots(&w, snapshots) : run_tape(&w);
  if (status == MAGGI_OK) status = maggi_reversal_finish(w.reversal, w.tape);
  if (status == MAGGI_OK) maggi_study_gather(s, w.reversal, w.p);
  if (status == MAGGI_E_MEMORY) maggi_data_fail(s->d, status, "out of memory");
  maggi_reversal_free(w.reversal);
  maggi_tape_free(w.tape);
  free(w.snapshot);
  free(w.p);
  return status;
}
