#include "replay.h"

#include <stdlib.h>
#include <string.h>

#include "equilibrium.h"
#include "plan.h"

/* as maggi_node */
typedef struct node {
  reference_number *q, *v, *a, *y, *yrate;
} node;

struct replay {
  maggi_follower follower;
  maggi_data *d;
  maggi_topo t; /* with lists of its own: those of d have changed when a step is replayed */
  reference_motion *z;
  reference_number *vcol, *acol; /* of z */
  node place[MAGGI_PLACES];      /* the present one is that of z */
  reference_number *slope[3];    /* weighted sums of slopes of a step */
  int begun;                     /* parts of the present step */
  replay_counts count;
};

static void *room(int n, size_t size)
{
  void *a = calloc((size_t)n + 1, size);

  if (!a) abort();
  return a;
}

static size_t bytes(const replay *r)
{
  return (size_t)r->t.nq * sizeof(reference_number);
}

static size_t filter_bytes(const replay *r)
{
  return (size_t)r->t.nstate * sizeof(reference_number);
}

/* ---------------------------------------------------------------------------------------- memory */

static void copy_plan(maggi_topo *t, const maggi_data *d)
{
  const maggi_planner *pl = d->planner;

  *t = d->t;
#define X(name, size, text)                                                                        \
  t->name = room(pl->name.n, sizeof(int));                                                         \
  if (pl->name.n > 0) memcpy(t->name, pl->name.v, (size_t)pl->name.n * sizeof(int));
  MAGGI_PLAN_LIST(X)
#undef X
}

static void free_plan(maggi_topo *t)
{
#define X(name, size, text) free(t->name);
  MAGGI_PLAN_LIST(X)
#undef X
}

/* a motion with the present plan of d */
static void begin_motion(replay *r, const maggi_data *d)
{
  copy_plan(&r->t, d);
  r->z = reference_motion_create(&r->t, d->m->originadr);
  r->vcol = reference_motion_array(r->z, "vcol");
  r->acol = reference_motion_array(r->z, "acol");
  r->place[MAGGI_PRESENT].q = reference_motion_array(r->z, "q");
  r->place[MAGGI_PRESENT].v = reference_motion_array(r->z, "v");
  r->place[MAGGI_PRESENT].a = reference_motion_array(r->z, "a");
  r->place[MAGGI_PRESENT].y = reference_motion_array(r->z, "y");
  r->place[MAGGI_PRESENT].yrate = reference_motion_array(r->z, "yrate");
}

/* the plan of d at the same positions */
static void change_motion(replay *r, const maggi_data *d)
{
  reference_motion *old = r->z;
  node from = r->place[MAGGI_PRESENT];
  maggi_topo t = r->t;

  begin_motion(r, d);
  memcpy(reference_motion_array(r->z, "p"), reference_motion_array(old, "p"),
         (size_t)t.np * sizeof *from.q);
  memcpy(r->place[MAGGI_PRESENT].q, from.q, bytes(r));
  memcpy(r->place[MAGGI_PRESENT].v, from.v, bytes(r));
  memcpy(r->place[MAGGI_PRESENT].y, from.y, filter_bytes(r));
  reference_motion_free(old);
  free_plan(&t);
}

maggi_data *replay_copy(const maggi_data *d)
{
  size_t n = (size_t)d->t.nq * sizeof(int);
  maggi_data *copy;

  if (maggi_data_create(d->m, &copy) != MAGGI_OK) abort();
  memcpy(copy->p, d->p, (size_t)d->t.np * sizeof *d->p);
  memcpy(copy->position_given, d->position_given, n);
  memcpy(copy->velocity_given, d->velocity_given, n);
  copy->tolerance = d->tolerance;
  return copy;
}

void replay_free(replay *r)
{
  int i;

  if (!r) return;
  if (r->z) {
    reference_motion_free(r->z);
    free_plan(&r->t);
  }
  for (i = 0; i < 3; ++i) free(r->slope[i]);
  for (i = 0; i < MAGGI_PRESENT; ++i) {
    free(r->place[i].q);
    free(r->place[i].v);
    free(r->place[i].a);
    free(r->place[i].y);
    free(r->place[i].yrate);
  }
  maggi_data_free(r->d);
  free(r);
}

/* ----------------------------------------------------------------------------------------- steps */

/* a fourth of the method: the slopes of the last evaluation count `weight` times; the next one is `ahead`
 * from the start along them */
static void stage(replay *r, double weight, double ahead, double time)
{
  const node *start = &r->place[MAGGI_START], *now = &r->place[MAGGI_PRESENT];
  const maggi_topo *t = &r->t;
  int i;

  for (i = 0; i < t->nq; ++i) {
    r->slope[0][i] += weight * now->v[i];
    r->slope[1][i] += weight * now->a[i];
    now->q[i] = start->q[i] + ahead * now->v[i];
  }
  for (i = 0; i < t->nind; ++i) r->vcol[i] = start->v[t->colq[i]] + ahead * now->a[t->colq[i]];
  for (i = 0; i < t->nstate; ++i) {
    r->slope[2][i] += weight * now->yrate[i];
    now->y[i] = start->y[i] + ahead * now->yrate[i];
  }
  reference_motion_stage(r->z, time);
}

static maggi_status end(maggi_follower *follower, double h, double time, int is_projected)
{
  replay *r = (replay *)follower;
  const node *start = &r->place[MAGGI_START], *now = &r->place[MAGGI_PRESENT];
  const maggi_topo *t = &r->t;
  double from = r->d->start.time;
  int i, k;

  memset(r->slope[0], 0, bytes(r));
  memset(r->slope[1], 0, bytes(r));
  memset(r->slope[2], 0, filter_bytes(r));
  memcpy(now->v, start->v, bytes(r));
  memcpy(now->a, start->a, bytes(r));
  memcpy(now->yrate, start->yrate, filter_bytes(r));
  stage(r, 1.0, 0.5 * h, from + 0.5 * h);
  stage(r, 2.0, 0.5 * h, from + 0.5 * h);
  stage(r, 2.0, h, from + h);
  for (i = 0; i < t->nq; ++i) now->q[i] = start->q[i] + h / 6.0L * (r->slope[0][i] + now->v[i]);
  for (i = 0; i < t->nind; ++i) {
    k = t->colq[i];
    r->vcol[i] = start->v[k] + h / 6.0L * (r->slope[1][k] + now->a[k]);
  }
  for (i = 0; i < t->nstate; ++i)
    now->y[i] = start->y[i] + h / 6.0L * (r->slope[2][i] + now->yrate[i]);
  r->count.closures += is_projected;
  if (is_projected && !reference_motion_close(r->z, time)) return MAGGI_E_LOCKUP;
  reference_motion_evaluate(r->z, time);
  return MAGGI_OK;
}

/* the new independent coordinates have the velocities that the old ones made */
static maggi_status renewed(maggi_follower *follower, double time)
{
  replay *r = (replay *)follower;
  int i;

  change_motion(r, r->d);
  for (i = 0; i < r->t.nind; ++i) r->vcol[i] = r->place[MAGGI_PRESENT].v[r->t.colq[i]];
  reference_motion_evaluate(r->z, time);
  r->count.changes = r->d->changes;
  return MAGGI_OK;
}

static void begin(maggi_follower *follower)
{
  (void)follower;
}

/* stages are known when their step has ended */
static maggi_status ignore(maggi_follower *follower, double weight, double ahead, double time)
{
  (void)follower, (void)weight, (void)ahead, (void)time;
  return MAGGI_OK;
}

static void copy(maggi_follower *follower, maggi_place to, maggi_place from)
{
  replay *r = (replay *)follower;

  /* once before each step, again before its second part */
  if (to == MAGGI_START && from == MAGGI_PRESENT) r->count.parts += r->begun++;
  memcpy(r->place[to].q, r->place[from].q, bytes(r));
  memcpy(r->place[to].v, r->place[from].v, bytes(r));
  memcpy(r->place[to].a, r->place[from].a, bytes(r));
  memcpy(r->place[to].y, r->place[from].y, filter_bytes(r));
  memcpy(r->place[to].yrate, r->place[from].yrate, filter_bytes(r));
}

/* q = sum c_k s^k, with q, v, a at both ends of the step of length H; filters likewise, with two of them */
static void interpolate(maggi_follower *follower, const double factors[MAGGI_BETWEEN][6])
{
  replay *r = (replay *)follower;
  const node *a = &r->place[MAGGI_START], *b = &r->place[MAGGI_NODE];
  const node *now = &r->place[MAGGI_PRESENT];
  long double H = (long double)r->d->node.time - r->d->start.time;
  long double s = ((long double)r->d->time - r->d->start.time) / H;
  reference_number c[6], d[3];
  int i, k;

  (void)factors;
  for (i = 0; i < r->t.nq; ++i) {
    c[0] = a->q[i];
    c[1] = H * a->v[i];
    c[2] = 0.5L * H * H * a->a[i];
    /* what c_3 + c_4 + c_5 and its two derivatives have to be at s = 1 */
    d[0] = b->q[i] - c[0] - c[1] - c[2];
    d[1] = H * b->v[i] - c[1] - 2.0L * c[2];
    d[2] = H * H * b->a[i] - 2.0L * c[2];
    c[3] = 10.0L * d[0] - 4.0L * d[1] + 0.5L * d[2];
    c[4] = -15.0L * d[0] + 7.0L * d[1] - d[2];
    c[5] = 6.0L * d[0] - 3.0L * d[1] + 0.5L * d[2];
    now->q[i] = now->v[i] = now->a[i] = 0.0L;
    for (k = 5; k >= 0; --k) now->q[i] = now->q[i] * s + c[k];
    for (k = 5; k >= 1; --k) now->v[i] = now->v[i] * s + k * c[k] / H;
    for (k = 5; k >= 2; --k) now->a[i] = now->a[i] * s + k * (k - 1) * c[k] / (H * H);
  }
  for (i = 0; i < r->t.nstate; ++i) {
    c[0] = a->y[i];
    c[1] = H * a->yrate[i];
    d[0] = b->y[i] - c[0] - c[1];
    d[1] = H * b->yrate[i] - c[1];
    now->y[i] = c[0] + s * (c[1] + s * (3.0L * d[0] - d[1] + s * (d[1] - 2.0L * d[0])));
  }
  reference_motion_given(r->z, r->d->time);
  ++r->count.between;
}

maggi_status replay_step(replay *r, double h)
{
  r->begun = 0;
  return maggi_step(r->d, h);
}

/* ----------------------------------------------------------------------------------------- start */

static void set_parameters(replay *r, const double *x)
{
  reference_number *p = reference_motion_array(r->z, "p");
  int i;

  for (i = 0; i < r->t.np; ++i) p[i] = r->d->p[i] + _Complex_I * REFERENCE_STEP * x[i];
}

/* Positions q of static equilibrium, from those that e has found, along the direction x of the parameters:
 * Newton's method with the Jacobian there. */
static int find_equilibrium(const maggi_equilibrium *e, const double *x, reference_number *q)
{
  replay r = {.d = e->x};
  reference_number *to;
  double *move[2] = {room(e->x->t.nq, sizeof(double)), room(e->x->t.nq, sizeof(double))};
  int i, k, n, ok = 1;

  begin_motion(&r, e->x);
  set_parameters(&r, x);
  to = r.place[MAGGI_PRESENT].q;
  for (k = 0; k < r.t.nq; ++k) to[k] = e->x->q[k];
  for (n = 0; n < 4 && ok; ++n) {
    ok = reference_motion_close(r.z, 0.0L);
    memset(r.vcol, 0, (size_t)r.t.nind * sizeof *r.vcol);
    reference_motion_stage(r.z, 0.0L);
    for (i = 0; i < r.t.nind; ++i) {
      move[0][i] = (double)creall(r.acol[i]);
      move[1][i] = (double)(cimagl(r.acol[i]) / REFERENCE_STEP);
    }
    for (k = 0; k < 2; ++k) maggi_dense_solve(&e->factor, move[k]);
    for (i = 0; i < r.t.nind; ++i)
      to[r.t.colq[i]] -= move[0][i] + _Complex_I * REFERENCE_STEP * move[1][i];
  }
  ok = ok && reference_motion_close(r.z, 0.0L);
  memcpy(q, to, bytes(&r));
  reference_motion_free(r.z);
  free_plan(&r.t);
  free(move[0]);
  free(move[1]);
  return ok;
}

/* Wheels roll, by the velocities of all others. */
static void roll(replay *r)
{
  const maggi_topo *t = &r->t;
  reference_number *spin = reference_motion_array(r->z, "spin");
  int i;

  reference_motion_evaluate(r->z, 0.0L);
  reference_motion_roll(r->z);
  for (i = 0; i < t->nwheel; ++i) r->vcol[t->col[t->qid[t->wheelbody[i]]]] = spin[i];
}

/* Coordinates where the parameters say; those that depend on them from the real simulation, to be closed.
 * `assembled` is a simulation with the plan by which it closed them. */
static int set_start(replay *r, const maggi_data *assembled, const double *x)
{
  const maggi_data *d = r->d;
  const maggi_model *m = d->m;
  const reference_number *p;
  int i, k;

  begin_motion(r, assembled);
  set_parameters(r, x);
  p = reference_motion_array(r->z, "p");
  for (k = 0; k < r->t.nq; ++k) {
    r->place[MAGGI_PRESENT].q[k] = d->q[k];
    if (r->t.col[k] >= 0 && m->initial_position[k] >= 0)
      r->place[MAGGI_PRESENT].q[k] = p[m->initial_position[k]];
  }
  if (d->equilibrium && !find_equilibrium(d->equilibrium, x, r->place[MAGGI_PRESENT].q)) return 0;
  if (!reference_motion_close(r->z, 0.0L)) return 0;
  change_motion(r, d);
  p = reference_motion_array(r->z, "p");
  for (i = 0; i < r->t.nind; ++i) {
    k = r->t.colq[i];
    r->vcol[i] = p[m->initial_velocity[k]];
  }
  if (m->rolling) roll(r);
  reference_motion_evaluate(r->z, 0.0L);
  return 1;
}

replay *replay_create(const maggi_data *d, const double *x)
{
  replay *r = room(1, sizeof *r);
  maggi_data *assembled = replay_copy(d);
  int i, nq = d->t.nq, ok;

  r->follower = (maggi_follower){begin, ignore, end, renewed, copy, interpolate};
  r->d = replay_copy(d);
  r->slope[0] = room(nq, sizeof(reference_number));
  r->slope[1] = room(nq, sizeof(reference_number));
  r->slope[2] = room(d->t.nstate, sizeof(reference_number));
  for (i = 0; i < MAGGI_PRESENT; ++i) {
    r->place[i].q = room(nq, sizeof(reference_number));
    r->place[i].v = room(nq, sizeof(reference_number));
    r->place[i].a = room(nq, sizeof(reference_number));
    r->place[i].y = room(d->t.nstate, sizeof(reference_number));
    r->place[i].yrate = room(d->t.nstate, sizeof(reference_number));
  }
  ok = maggi_data_reset(r->d) == MAGGI_OK && maggi_data_reset(assembled) == MAGGI_OK &&
       r->d->is_settled;
  if (ok && r->d->is_kept) ok = maggi_evaluate_start(assembled, 1) == MAGGI_OK;
  ok = ok && set_start(r, assembled, x);
  maggi_data_free(assembled);
  if (!ok) {
    replay_free(r);
    return NULL;
  }
  r->d->follower = &r->follower;
  return r;
}

/* ---------------------------------------------------------------------------------------- values */

maggi_data *replay_data(const replay *r)
{
  return r->d;
}

replay_counts replay_count(const replay *r)
{
  return r->count;
}

int replay_number(const replay *r)
{
  return 3 * r->d->m->ncoordinate + 3 + 6 * r->d->m->nbody + r->d->m->ncolumn + r->t.nfilter;
}

/* what the parent exerts, at the joint point x of the body; wrench: of all else, at the origin */
static void reaction(const reference_number *x, const reference_number *wrench,
                     reference_number *values)
{
  int k, l, m;

  for (k = 0; k < 3; ++k) {
    l = (k + 1) % 3;
    m = (k + 2) % 3;
    values[k] = -wrench[k];
    values[3 + k] = -wrench[3 + k] + x[l] * wrench[m] - x[m] * wrench[l];
  }
}

void replay_values(replay *r, reference_number *values)
{
  const maggi_model *m = r->d->m;
  const node *now = &r->place[MAGGI_PRESENT];
  const reference_number *x = reference_motion_array(r->z, "x");
  const reference_number *wrench = reference_motion_array(r->z, "FSr");
  int i, k;

  for (i = 0; i < m->ncoordinate; ++i) {
    k = m->coordinate[i].q;
    *values++ = now->q[k];
    *values++ = now->v[k];
    *values++ = now->a[k];
  }
  reference_motion_energy(r->z, values);
  values[2] = values[0] + values[1];
  values += 3;
  for (i = 0; i < m->nbody; ++i, values += 6) {
    k = m->body[i].body;
    reaction(x + 3 * k, wrench + 6 * k, values);
  }
  for (i = 0; i < m->ncolumn; ++i)
    values[i] = reference_motion_array(r->z, "sensor")[m->sensorplace[i]];
  values += m->ncolumn;
  memcpy(values, reference_motion_array(r->z, "weighted"), (size_t)r->t.nfilter * sizeof *values);
}
