/* Recording a simulation: a follower that keeps the states of the stages. */
#include "tape.h"

#include <stdlib.h>
#include <string.h>

/* steps that one maggi_step may take, and the node at the end */
enum { STEPS_AT_ONCE = 3 };

static maggi_tape *of(maggi_follower *f)
{
  return (maggi_tape *)f;
}

static double *place(const maggi_tape *tape, long step, int stage)
{
  return tape->state + ((size_t)step * 4 + (size_t)stage) * tape->size;
}

/* ----------------------------------------------------------------------------------- states */

static void keep(const maggi_tape *tape, long step, int stage)
{
  const maggi_data *d = tape->d;
  double *x = place(tape, step, stage);

  memcpy(x, d->q, (size_t)d->t.nq * sizeof(double));
  memcpy(x + d->t.nq, d->vcol, (size_t)d->t.nind * sizeof(double));
  memcpy(x + d->t.nq + d->t.nind, d->y, (size_t)d->t.nstate * sizeof(double));
}

void maggi_tape_load(const maggi_tape *tape, const double *state)
{
  maggi_data *d = tape->d;

  memcpy(d->q, state, (size_t)d->t.nq * sizeof(double));
  memcpy(d->vcol, state + d->t.nq, (size_t)d->t.nind * sizeof(double));
  memcpy(d->y, state + d->t.nq + d->t.nind, (size_t)d->t.nstate * sizeof(double));
}

/* a node by the present choice */
static void keep_node(const maggi_tape *tape, long step, const double *q, const double *v,
                      const double *y)
{
  const maggi_data *d = tape->d;
  double *x = place(tape, step, 0);
  int i;

  memcpy(x, q, (size_t)d->t.nq * sizeof(double));
  for (i = 0; i < d->t.nind; ++i) x[d->t.nq + i] = v[d->t.colq[i]];
  memcpy(x + d->t.nq + d->t.nind, y, (size_t)d->t.nstate * sizeof(double));
}

/* --------------------------------------------------------------------------------- changes */

static void save_plan(maggi_tape *tape, void *memory)
{
  maggi_saved_plan plan;

  maggi_saved_plan_place(&plan, &tape->d->t, memory);
  maggi_plan_save(tape->d, &plan);
}

static int is_same_plan(const maggi_tape *tape, void *memory)
{
  maggi_saved_plan plan;

  maggi_saved_plan_place(&plan, &tape->d->t, memory);
  return maggi_plan_is_saved(tape->d, &plan);
}

/* The choice is another one than when the tape last looked, or has been made at a node beyond this one,
 * from which the simulation has come back: then it counts as made here. */
static void look_for_change(maggi_tape *tape, long node, const double *q, const double *v,
                            const double *y)
{
  const maggi_data *d = tape->d;
  maggi_tape_change *c;
  size_t bytes = maggi_saved_plan_size(&d->t);
  long first = tape->nchange;

  while (first > 0 && tape->change[first - 1].node > node) --first;
  c = &tape->change[first];
  if (first == tape->nchange) {
    if (tape->plans == d->plans || is_same_plan(tape, tape->plan)) return;
    memcpy(c->plan, tape->plan, bytes);
  }
  c->node = node;
  memcpy(c->u, place(tape, node, 0) + d->t.nq, (size_t)d->t.nind * sizeof(double));
  tape->nchange = first + 1;
  tape->plans = d->plans;
  save_plan(tape, tape->plan);
  keep_node(tape, node, q, v, y);
}

/* --------------------------------------------------------------------------------- follower */

static void begin(maggi_follower *f)
{
  maggi_tape *tape = of(f);
  long node = tape->at[MAGGI_START];

  look_for_change(tape, node, tape->d->q0, tape->d->v0, tape->d->y0);
  tape->step[node].time = tape->d->start.time;
  tape->stage = 0;
}

static maggi_status stage(maggi_follower *f, double weight, double ahead, double time)
{
  maggi_tape *tape = of(f);

  (void)weight, (void)ahead, (void)time;
  keep(tape, tape->at[MAGGI_START], ++tape->stage);
  return MAGGI_OK;
}

static maggi_status end(maggi_follower *f, double h, double time, int is_projected)
{
  maggi_tape *tape = of(f);
  long node = tape->at[MAGGI_START];

  tape->step[node].h = h;
  tape->step[node].is_projected = is_projected;
  tape->at[MAGGI_PRESENT] = node + 1;
  tape->step[node + 1].time = time;
  keep(tape, node + 1, 0);
  return MAGGI_OK;
}

static maggi_status renewed(maggi_follower *f, double time)
{
  (void)f, (void)time;
  return MAGGI_OK;
}

static void copy(maggi_follower *f, maggi_place to, maggi_place from)
{
  maggi_tape *tape = of(f);

  tape->at[to] = tape->at[from];
}

static void interpolate(maggi_follower *f, const double c[MAGGI_BETWEEN][6])
{
  (void)f, (void)c;
}

/* ------------------------------------------------------------------------------------ samples */

static void add_sample(maggi_tape *tape)
{
  const maggi_data *d = tape->d;
  maggi_tape_sample *s = &tape->sample[tape->nsample++];
  size_t nq = (size_t)d->t.nq;
  double H, *given;

  s->time = d->time;
  s->is_between = d->is_ahead;
  if (!d->is_ahead) {
    look_for_change(tape, tape->at[MAGGI_PRESENT], d->q, d->v, d->y);
    s->steps = tape->at[MAGGI_PRESENT];
  } else {
    look_for_change(tape, tape->at[MAGGI_NODE], d->qn, d->vn, d->yn);
    s->steps = tape->at[MAGGI_NODE];
    H = d->node.time - d->start.time;
    maggi_between((d->time - d->start.time) / H, H, s->c);
    given = tape->given + maggi_tape_given_size(&d->t) * (size_t)tape->ngiven;
    memcpy(given, d->q, nq * sizeof(double));
    memcpy(given + nq, d->v, nq * sizeof(double));
    memcpy(given + 2 * nq, d->a, nq * sizeof(double));
    memcpy(given + 3 * nq, d->y, (size_t)d->t.nstate * sizeof(double));
    s->given = tape->ngiven++;
  }
  tape->nstep = s->steps;
}

/* ------------------------------------------------------------------------------------- memory */

/* room for `need` items, some more if it must grow */
static int fit(void **array, long *cap, long need, size_t size)
{
  long larger = need + need / 4;
  void *bigger;

  if (need <= *cap) return 1;
  bigger = realloc(*array, (size_t)larger * size);
  if (!bigger) return 0;
  *array = bigger;
  *cap = larger;
  return 1;
}

#define FIT(array, cap, need, numbers)                                                             \
  fit((void **)&tape->array, &tape->cap, need, (size_t)(numbers) * sizeof *tape->array)

/* for one more maggi_step */
static maggi_status make_room(maggi_tape *tape)
{
  const maggi_topo *t = &tape->d->t;
  size_t plan = maggi_saved_plan_size(t);
  maggi_tape_change *c;
  long old = tape->capchange;
  char *memory;
  int ok;

  ok = FIT(state, capstate, tape->nstep + STEPS_AT_ONCE, 4 * tape->size) &&
       FIT(step, capstep, tape->nstep + STEPS_AT_ONCE, 1) &&
       FIT(sample, capsample, tape->nsample + 1, 1) &&
       FIT(given, capgiven, tape->ngiven + 1, maggi_tape_given_size(t) + 1) &&
       FIT(change, capchange, tape->nchange + STEPS_AT_ONCE, 1);
  for (; ok && old < tape->capchange; ++old) {
    c = &tape->change[old];
    memory = malloc(plan + (size_t)t->nq * sizeof(double) + 1);
    c->plan = memory;
    c->u = (double *)(memory + plan);
    ok = memory != NULL;
    if (!ok) tape->capchange = old;
  }
  return ok ? MAGGI_OK : maggi_data_fail(tape->d, MAGGI_E_MEMORY, "out of memory");
}

size_t maggi_tape_step_size(const maggi_data *d)
{
  return (8 * (size_t)d->t.nq + 4 * (size_t)d->t.nstate) * sizeof(double) +
         sizeof(maggi_tape_step) + sizeof(maggi_tape_sample);
}

maggi_status maggi_tape_create(maggi_data *d, maggi_tape **tape_out)
{
  maggi_tape *tape = calloc(1, sizeof *tape);

  *tape_out = NULL;
  if (!tape) return MAGGI_E_MEMORY;
  tape->d = d;
  tape->size = (size_t)(d->t.nq + d->t.nq + d->t.nstate);
  tape->follower = (maggi_follower){begin, stage, end, renewed, copy, interpolate};
  tape->plan = malloc(maggi_saved_plan_size(&d->t) + 1);
  if (!tape->plan) {
    maggi_tape_free(tape);
    return MAGGI_E_MEMORY;
  }
  *tape_out = tape;
  return MAGGI_OK;
}

void maggi_tape_free(maggi_tape *tape)
{
  long i;

  if (!tape) return;
  if (tape->d->follower == &tape->follower) tape->d->follower = NULL;
  for (i = 0; i < tape->capchange; ++i) free(tape->change[i].plan);
  free(tape->state);
  free(tape->step);
  free(tape->sample);
  free(tape->given);
  free(tape->change);
  free(tape->plan);
  free(tape);
}

/* ---------------------------------------------------------------------------------- recording */

maggi_status maggi_tape_begin(maggi_tape *tape)
{
  maggi_data *d = tape->d;
  maggi_status status;

  tape->size = (size_t)(d->t.nq + d->t.nind + d->t.nstate);
  tape->nstep = tape->nsample = tape->ngiven = tape->nchange = 0;
  status = make_room(tape);
  if (status != MAGGI_OK) return status;
  save_plan(tape, tape->plan);
  tape->plans = d->plans;
  tape->at[MAGGI_START] = tape->at[MAGGI_PRESENT] = 0;
  tape->at[MAGGI_NODE] = 1;
  if (d->is_ahead) {
    keep_node(tape, 0, d->q0, d->v0, d->y0);
    keep_node(tape, 1, d->qn, d->vn, d->yn);
    tape->step[0].time = d->start.time;
    tape->step[1].time = d->node.time;
  } else {
    keep_node(tape, 0, d->q, d->v, d->y);
    tape->step[0].time = d->time;
  }
  add_sample(tape);
  d->follower = &tape->follower;
  return MAGGI_OK;
}

maggi_status maggi_tape_advance(maggi_tape *tape, double h)
{
  maggi_status status = make_room(tape);

  if (status == MAGGI_OK) status = maggi_step(tape->d, h);
  if (status == MAGGI_OK) add_sample(tape);
  return status;
}
