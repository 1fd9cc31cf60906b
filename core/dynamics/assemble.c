/* Closing the loops: assembly and completion of the initial state, drift control, diagnosis.
 *
 * Newton's method moves the dependent coordinates only.  In assembly they are chosen anew in each
 * iteration, prescribed positions are never among them, and steps are shortened until the loops close
 * further. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "data.h"

enum {
  ASSEMBLY_STARTS = 30,
  ASSEMBLY_ITERATIONS = 200,
  PROJECTION_ITERATIONS = 20,
  HALVINGS = 12,
};

/* largest move of a coordinate in one iteration of assembly [rad or m] */
static const double assembly_step = 0.5;
/* pivots below which a position is close to singular: loops are kept closed to round-off there */
static const double singular_below = 0.05;

static void newton_step(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  int i;

  for (i = 0; i < t->nrow; ++i) d->gam[i] = -d->res[i];
  maggi_island_vector(t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->b, d->phi, d->chol,
                      d->gam, d->v1, d->y1, d->dq, d->space);
}

static void move(maggi_data *d, double factor)
{
  int i;

  for (i = 0; i < d->t.ndep; ++i)
    d->q[d->t.dep[i]] = d->q1[d->t.dep[i]] + factor * d->dq[d->t.dep[i]];
}

static double largest_move(const maggi_data *d)
{
  double largest = 0.0;
  int i;

  for (i = 0; i < d->t.ndep; ++i) {
    if (isnan(d->dq[d->t.dep[i]])) return NAN;
    largest = fmax(largest, fabs(d->dq[d->t.dep[i]]));
  }
  return largest;
}

static void remember(maggi_data *d)
{
  memcpy(d->q1, d->q, (size_t)d->t.nq * sizeof(double));
}

static const char *loop_word(const maggi_data *d, int loop)
{
  return strcmp(d->m->loop[loop].kind, "rod") == 0 ? "rod" : "loop";
}

static maggi_status fail_assembly(maggi_data *d, double violation)
{
  int loop = maggi_worst_loop(d);

  return maggi_data_fail(d, MAGGI_E_ASSEMBLY,
                         "%s \"%s\" cannot be closed in the initial position: %.3g remain open",
                         loop_word(d, loop), d->m->loop[loop].name, violation);
}

/* at least 1 */
static double largest_length(const maggi_data *d)
{
  double largest = 1.0;
  int i, k;

  for (i = 0; i < d->t.npointdyn; ++i)
    for (k = 0; k < 3; ++k) largest = fmax(largest, fabs(d->r[i][k]));
  return largest;
}

/* round-off of the loop equations, with lengths of the model as the scale */
static double roundoff(const maggi_data *d)
{
  return 4.0 * DBL_EPSILON * largest_length(d);
}

/* Newton from the present position; the loops are open by *violation after it.  Equations that are
 * redundant where the loops are closed are not so while they are open: when `relaxed`, pivots of the
 * size of the opening count as redundant. */
static maggi_status newton(maggi_data *d, double time, int avoid, int relaxed, double *violation)
{
  double before, factor;
  maggi_status status;
  int i, k;

  maggi_evaluate_positions(d, time);
  *violation = maggi_violation(d);
  for (i = 0; i < ASSEMBLY_ITERATIONS && !(*violation <= roundoff(d)); ++i) {
    if (isnan(*violation))
      return maggi_data_fail(d, MAGGI_E_NOT_FINITE, "the initial position is not finite");
    if (relaxed) d->rank_tolerance = fmin(fmax(*violation, MAGGI_RANK_TOLERANCE), 0.05);
    status = maggi_plan(d, avoid, 0.5);
    d->rank_tolerance = MAGGI_RANK_TOLERANCE;
    if (status != MAGGI_OK) return status;
    newton_step(d);
    remember(d);
    before = *violation;
    factor = largest_move(d);
    factor = factor > assembly_step ? assembly_step / factor : 1.0;
    for (k = 0; k < HALVINGS; ++k) {
      move(d, factor);
      maggi_evaluate_positions(d, time);
      *violation = maggi_violation(d);
      if (*violation < before) break;
      factor *= 0.5;
    }
    if (k == HALVINGS) {
      move(d, 0.0);
      maggi_evaluate_positions(d, time);
      *violation = before;
      break;
    }
  }
  return MAGGI_OK;
}

/* a cylindrical or prismatic loop whose equations hold with one axis against the other, -1: none */
static int reversed_loop(const maggi_data *d)
{
  const maggi_topo *t = &d->t;
  double axis_b[3];
  int i;

  for (i = 0; i + 1 < t->nprim; ++i) {
    if (t->primkind[i] != MAGGI_PRIM_PLANE || t->primkind[i + 1] != MAGGI_PRIM_PLANE) continue;
    maggi_cross(d->dir[t->primdb[i]], d->dir[t->primdb[i + 1]], axis_b);
    if (maggi_dot(d->dir[t->primda[i]], axis_b) < 0.0) return t->primloop[i];
  }
  return -1;
}

/* between -1 and 1, the same in every run */
static double scattered(unsigned *seed)
{
  *seed = *seed * 1664525u + 1013904223u;
  return (double)(*seed >> 8) / (double)(1u << 23) - 1.0;
}

/* Newton from the position in q, then from points scattered wider and wider around it */
static maggi_status assemble(maggi_data *d, double time, int avoid)
{
  size_t bytes = (size_t)d->t.nq * sizeof(double);
  double violation, least = INFINITY, spread;
  maggi_status status;
  unsigned seed = 1;
  int n, i, loop, reversed = -1;

  memcpy(d->dqs, d->q, bytes);
  for (n = 0; n < ASSEMBLY_STARTS; ++n) {
    spread = n < 2 ? 0.0 : 3.2 * n / ASSEMBLY_STARTS;
    for (i = 0; n > 0 && i < d->t.nq; ++i)
      if (!(avoid & MAGGI_KEEP_POSITION) || !d->position_given[i])
        d->q[i] = d->dqs[i] + spread * scattered(&seed);
    status = newton(d, time, avoid, n % 2, &violation);
    if (status != MAGGI_OK) return status;
    if (violation <= d->tolerance) {
      loop = reversed_loop(d);
      if (loop < 0) return MAGGI_OK;
      reversed = loop;
    } else if (violation < least) {
      least = violation;
      memcpy(d->dus, d->q, bytes);
    }
  }
  if (reversed >= 0)
    return maggi_data_fail(d, MAGGI_E_ASSEMBLY, "loop \"%s\" closes only with its axis reversed",
                           d->m->loop[reversed].name);
  memcpy(d->q, d->dus, bytes);
  maggi_evaluate_positions(d, time);
  return fail_assembly(d, least);
}

/* a coordinate with a prescribed position that has become dependent */
static int is_position_dependent(const maggi_data *d)
{
  int i;

  for (i = 0; i < d->t.ndep; ++i)
    if (d->position_given[d->t.dep[i]]) return 1;
  return 0;
}

/* The independent coordinates go to where assembly started (dqs), the others close the loops around
 * them; false, and left as assembled, where that cannot be done. */
static int settle(maggi_data *d, double time)
{
  const maggi_topo *t = &d->t;
  double violation = INFINITY;
  int i, n;

  memcpy(d->dus, d->q, (size_t)t->nq * sizeof(double));
  for (i = 0; i < t->nind; ++i) d->q[t->colq[i]] = d->dqs[t->colq[i]];
  maggi_evaluate_positions(d, time);
  for (n = 0; n < PROJECTION_ITERATIONS; ++n) {
    violation = maggi_violation(d);
    if (!(violation > roundoff(d))) break;
    maggi_evaluate_factors(d);
    newton_step(d);
    if (!(largest_move(d) < assembly_step)) break;
    remember(d);
    move(d, 1.0);
    maggi_evaluate_positions(d, time);
  }
  if (violation <= d->tolerance) return 1;
  memcpy(d->q, d->dus, (size_t)t->nq * sizeof(double));
  maggi_evaluate_positions(d, time);
  return 0;
}

static const char *coordinate_name(const maggi_data *d, int q)
{
  int i;

  for (i = 0; i < d->m->ncoordinate; ++i)
    if (d->m->coordinate[i].q == q) return d->m->coordinate[i].name;
  return "";
}

/* dependent velocities that were prescribed too must be what the others make them */
static maggi_status check_velocities(maggi_data *d)
{
  double given, scale = 0.0;
  int i, q;

  for (i = 0; i < d->t.nq; ++i) scale = fmax(scale, fabs(d->v[i]));
  for (i = 0; i < d->t.ndep; ++i) {
    q = d->t.dep[i];
    if (!d->velocity_given[q] || d->m->initial_velocity[q] < 0) continue;
    given = d->p[d->m->initial_velocity[q]];
    if (!(fabs(given - d->v[q]) <= 1e-6 * fmax(scale, fabs(given))))
      return maggi_data_fail(d, MAGGI_E_ASSEMBLY,
                             "the velocity %.9g of \"%s\" contradicts the others, which make it "
                             "%.9g",
                             given, coordinate_name(d, q), d->v[q]);
  }
  return MAGGI_OK;
}

static maggi_status check_constants(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  int i, k, body;

  for (i = 0; i < t->nbody; ++i)
    for (k = 0; k < 3; ++k)
      if (!isfinite(d->axis0[i][k]) || !isfinite(d->offset0[i][k])) {
        for (body = 0; body < d->m->nbody - 1 && d->m->body[body].body != i; ++body)
          ;
        return maggi_data_fail(d, MAGGI_E_VALUE,
                               "a joint axis of the model has no direction (body "
                               "\"%s\")",
                               d->m->body[body].name);
      }
  for (i = 0; i < t->ndir; ++i)
    for (k = 0; k < 3; ++k)
      if (!isfinite(d->dir0[i][k]))
        return maggi_data_fail(d, MAGGI_E_VALUE, "an axis of a loop has no direction");
  for (i = 0; i < t->nprim; ++i)
    if (!isfinite(d->prim0[i]) || (t->primkind[i] == MAGGI_PRIM_ROD && !(d->prim0[i] > 0.0)))
      return maggi_data_fail(d, MAGGI_E_VALUE, "%s \"%s\" has no length",
                             d->m->loop[t->primloop[i]].kind, d->m->loop[t->primloop[i]].name);
  return MAGGI_OK;
}

/* largest rate at which a loop opens, and which */
static double opening_rate(const maggi_data *d, int *loop)
{
  const maggi_topo *t = &d->t;
  double e[3], rate[3], largest = 0.0;
  int i, k, c;

  for (i = 0; i < t->nprim; ++i) {
    for (k = 0; k < 3; ++k) rate[k] = 0.0;
    for (c = t->pathadr[t->primloop[i]]; c < t->pathadr[t->primloop[i] + 1]; ++c) {
      maggi_path_entry(d, i, c, e);
      for (k = 0; k < maggi_prim_rows(t->primkind[i]); ++k) rate[k] += e[k] * d->v[t->pathq[c]];
    }
    for (k = 0; k < 3; ++k) {
      if (fabs(rate[k]) <= largest) continue;
      largest = fabs(rate[k]);
      *loop = t->primloop[i];
    }
  }
  return largest;
}

/* guides must move as the loops allow */
static maggi_status check_guides(maggi_data *d)
{
  double scale = 1.0, rate;
  int i, loop = 0;

  if (d->t.nguide == 0) return MAGGI_OK;
  for (i = 0; i < d->t.nq; ++i) scale = fmax(scale, fabs(d->v[i]));
  rate = opening_rate(d, &loop);
  if (rate <= 1e-8 * scale * fmax(1.0, roundoff(d) / (4.0 * DBL_EPSILON))) return MAGGI_OK;
  return maggi_data_fail(d, MAGGI_E_ASSEMBLY,
                         "the guided motions contradict loop \"%s\": they open it at %.3g m/s or "
                         "rad/s",
                         d->m->loop[loop].name, rate);
}

/* from q, the plan and vcol to a consistent state with its accelerations */
static maggi_status complete(maggi_data *d, double time)
{
  maggi_status status;

  d->time = time;
  d->work = 0.0;
  d->changes = d->projections = d->evaluations = 0;
  d->replan_below = MAGGI_RENEW_BELOW;
  d->is_ahead = 0;
  d->careless = 0;
  maggi_evaluate(d, time);
  d->pivot_ratio = d->stage_ratio;
  status = maggi_check(d, time);
  if (status == MAGGI_OK) status = check_guides(d);
  d->ready = status == MAGGI_OK;
  return status;
}

/* forget what was, constants from p */
static maggi_status begin(maggi_data *d)
{
  d->ready = 0;
  d->message[0] = '\0';
  d->follower = NULL;
  maggi_plan_restart(d);
  maggi_constants(d);
  return check_constants(d);
}

void maggi_hold_choice(maggi_data *d)
{
  int i;

  for (i = 0; i < d->t.nq && !d->is_kept; ++i)
    d->position_given[i] = d->velocity_given[i] = maggi_is_independent(&d->t, i);
}

static maggi_status plan_start(maggi_data *d)
{
  return maggi_plan(d, MAGGI_AVOID_GIVEN, 0.1);
}

static maggi_saved_plan kept_plan(const maggi_data *d)
{
  maggi_saved_plan plan;

  maggi_saved_plan_place(&plan, &d->t, d->kept_plan);
  return plan;
}

maggi_status maggi_evaluate_start(maggi_data *d, int is_kept)
{
  maggi_saved_plan plan = kept_plan(d);
  maggi_status status = is_kept ? maggi_plan_load(d, &plan) : plan_start(d);
  int i;

  if (status != MAGGI_OK) return status;
  for (i = 0; i < d->t.nind; ++i) d->vcol[i] = d->v0[d->t.colq[i]];
  maggi_evaluate(d, d->time);
  return MAGGI_OK;
}

int maggi_initial_position(const maggi_data *d, int q)
{
  return d->is_settled || d->position_given[q] ? d->m->initial_position[q] : -1;
}

static void load_positions(maggi_data *d)
{
  int i, adr;

  for (i = 0; i < d->t.nq; ++i) {
    adr = d->m->initial_position[i];
    if (adr >= 0) d->q[i] = d->p[adr];
  }
}

maggi_status maggi_assemble_guess(maggi_data *d)
{
  maggi_status status = begin(d);

  if (status != MAGGI_OK) return status;
  load_positions(d);
  status = assemble(d, 0.0, 0);
  return status == MAGGI_OK ? maggi_plan(d, 0, 0.1) : status;
}

/* at the equilibrium of the static twin, which closes the loops; its held coordinates are where p says */
static maggi_status place_at_equilibrium(maggi_data *d)
{
  maggi_status status = maggi_equilibrium_find(d->equilibrium, d);

  if (status != MAGGI_OK) return status;
  maggi_evaluate_positions(d, 0.0);
  d->is_kept = 0;
  d->is_settled = 1;
  return plan_start(d);
}

/* at the positions of p, as far as the loops allow */
static maggi_status place(maggi_data *d)
{
  maggi_saved_plan plan;
  maggi_status status;

  load_positions(d);
  status = assemble(d, 0.0, MAGGI_KEEP_POSITION);
  if (status == MAGGI_OK) status = plan_start(d);
  if (status != MAGGI_OK) return status;
  d->is_kept = is_position_dependent(d);
  if (d->is_kept) status = maggi_plan(d, MAGGI_KEEP_POSITION, 0.1);
  if (status != MAGGI_OK) return status;
  d->is_settled = settle(d, 0.0);
  if (d->is_kept) {
    plan = kept_plan(d);
    maggi_plan_save(d, &plan);
    status = plan_start(d);
  }
  return status;
}

/* Wheels roll: velocities of their coordinates from those of all others.  The centre of a wheel is on the
 * axis on which it turns, so that the velocity at its contact is that of the carrier. */
static maggi_status roll(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  double v[3], w[3];
  int i, k, q;

  maggi_evaluate(d, 0.0);
  maggi_rolling(t, d->p, (void *)d->spline0, (void *)d->A, (void *)d->b, (void *)d->r, (void *)d->Z,
                d->spin);
  for (i = 0; i < t->nwheel; ++i) {
    q = t->qid[t->wheelbody[i]];
    for (k = 0; k < 3; ++k) w[k] = d->b[t->wheelbody[i]][k + 3];
    maggi_cross(w, d->r[t->wheelpoint[i]], v);
    for (k = 0; k < 3; ++k) v[k] += d->b[t->wheelbody[i]][k];
    if (!(maggi_dot(v, v) < 1e-20 * largest_length(d) * largest_length(d)))
      return maggi_data_fail(
          d, MAGGI_E_ASSEMBLY,
          "\"%s\" cannot start rolling: the centre of a wheel on it is not on its "
          "axis",
          coordinate_name(d, q));
    if (!isfinite(d->spin[i]))
      return maggi_data_fail(d, MAGGI_E_ASSEMBLY, "\"%s\" cannot start rolling",
                             coordinate_name(d, q));
    d->vcol[t->col[q]] = d->spin[i];
  }
  return MAGGI_OK;
}

maggi_status maggi_data_reset(maggi_data *d)
{
  const maggi_model *m = d->m;
  maggi_status status;
  int i;

  status = begin(d);
  if (status == MAGGI_OK) status = (d->equilibrium ? place_at_equilibrium : place)(d);
  if (status != MAGGI_OK) return status;
  for (i = 0; i < d->t.nind; ++i) d->vcol[i] = d->p[m->initial_velocity[d->t.colq[i]]];
  if (m->rolling) status = roll(d);
  if (status != MAGGI_OK) return status;
  status = complete(d, 0.0);
  memcpy(d->v0, d->v, (size_t)d->t.nq * sizeof(double));
  if (status == MAGGI_OK) status = check_velocities(d);
  d->ready = status == MAGGI_OK;
  return status;
}

maggi_status maggi_data_set_state(maggi_data *d, double t, const double *q, const double *v)
{
  const maggi_model *m = d->m;
  maggi_status status;
  int i;

  status = begin(d);
  if (status != MAGGI_OK) return status;
  if (!isfinite(t)) return maggi_data_fail(d, MAGGI_E_VALUE, "the time must be finite");
  for (i = 0; i < m->ncoordinate; ++i) {
    if (!isfinite(q[i]) || !isfinite(v[i]))
      return maggi_data_fail(d, MAGGI_E_VALUE, "the state of \"%s\" must be finite",
                             m->coordinate[i].name);
    d->q[m->coordinate[i].q] = q[i];
    d->v[m->coordinate[i].q] = v[i];
  }
  status = assemble(d, t, 0);
  if (status == MAGGI_OK) status = maggi_plan(d, 0, 0.1);
  if (status != MAGGI_OK) return status;
  settle(d, t);
  for (i = 0; i < d->t.nind; ++i) d->vcol[i] = d->v[d->t.colq[i]];
  return complete(d, t);
}

/* ------------------------------------------------------------------------------- while it runs */

static maggi_status fail_lockup(maggi_data *d, double time)
{
  int loop = maggi_worst_loop(d);

  return maggi_data_fail(d, MAGGI_E_LOCKUP,
                         "t = %.6g s: the mechanism locks up, or the step is too large for it: %s "
                         "\"%s\" cannot stay closed",
                         time, loop_word(d, loop), d->m->loop[loop].name);
}

/* Newton on the positions when the loops are open by more than the tolerance; the positions of `time`
 * are evaluated before and after. */
maggi_status maggi_project(maggi_data *d, double time)
{
  double violation, before, tolerance = d->pivot_ratio < singular_below ? 0.0 : d->tolerance;
  int i;

  maggi_evaluate_positions(d, time);
  violation = maggi_violation(d);
  if (isnan(violation))
    return maggi_data_fail(d, MAGGI_E_NOT_FINITE,
                           "t = %.6g s: the positions are not finite; is the step too large?",
                           time);
  if (violation <= tolerance) return MAGGI_OK;
  tolerance = fmax(tolerance, roundoff(d));
  for (i = 0; violation > tolerance; ++i) {
    if (i == PROJECTION_ITERATIONS) return fail_lockup(d, time);
    maggi_evaluate_factors(d);
    if (maggi_is_singular(d)) break;
    newton_step(d);
    ++d->projections;
    remember(d);
    move(d, 1.0);
    maggi_evaluate_positions(d, time);
    before = violation;
    violation = maggi_violation(d);
    if (isnan(violation) || (i > 4 && violation > 2.0 * before)) {
      move(d, 0.0);
      maggi_evaluate_positions(d, time);
      return fail_lockup(d, time);
    }
    /* no progress any more, close to round-off: as good as it gets */
    if (violation <= fmax(d->tolerance, 1e4 * roundoff(d)) && violation > 0.5 * before) break;
  }
  return MAGGI_OK;
}

/* whether the accelerations of `time` can be trusted; what is wrong if not */
maggi_status maggi_check(maggi_data *d, double time)
{
  const maggi_topo *t = &d->t;
  double pivot, whole;
  int i;

  for (i = 0; i < t->nind; ++i) {
    pivot = 1.0 / (d->dinv[i] * d->dinv[i]);
    whole = d->Mr[i * t->stride + i];
    if (isfinite(whole) && !(pivot > 1e-13 * whole))
      return maggi_data_fail(d, MAGGI_E_MASS,
                             "t = %.6g s: the mass matrix is singular: nothing resists \"%s\"; has "
                             "each body that it moves mass and inertia?",
                             time, coordinate_name(d, t->colq[i]));
  }
  for (i = 0; i < t->nq; ++i) {
    if (isfinite(d->a[i]) && isfinite(d->v[i])) continue;
    if (t->ndep > 0 && !(d->pivot_ratio > 1e-6)) return fail_lockup(d, time);
    return maggi_data_fail(d, MAGGI_E_NOT_FINITE,
                           "t = %.6g s: the motion of \"%s\" is not finite; is the step too large?",
                           time, coordinate_name(d, i));
  }
  return MAGGI_OK;
}
