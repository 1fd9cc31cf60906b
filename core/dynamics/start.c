/* The state with which a simulation starts: loops closed around what is prescribed, or static
 * equilibrium; wheels that roll; consistent velocities. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "closing.h"

/* a coordinate with a prescribed position that has become dependent */
static int is_position_dependent(const maggi_data *d)
{
  int i;

  for (i = 0; i < d->t.ndep; ++i)
    if (d->position_given[d->t.dep[i]]) return 1;
  return 0;
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
                             given, maggi_name_of(d, q), d->v[q]);
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
  if (rate <= 1e-8 * scale * fmax(1.0, maggi_roundoff(d) / (4.0 * DBL_EPSILON))) return MAGGI_OK;
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
  maggi_evaluate_filters(d);
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
  memset(d->y, 0, (size_t)d->t.nstate * sizeof(double));
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
  status = maggi_assemble(d, 0.0, 0);
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
  status = maggi_assemble(d, 0.0, MAGGI_KEEP_POSITION);
  if (status == MAGGI_OK) status = plan_start(d);
  if (status != MAGGI_OK) return status;
  d->is_kept = is_position_dependent(d);
  if (d->is_kept) status = maggi_plan(d, MAGGI_KEEP_POSITION, 0.1);
  if (status != MAGGI_OK) return status;
  d->is_settled = maggi_settle(d, 0.0);
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
    if (!(maggi_dot(v, v) < 1e-20 * maggi_largest_length(d) * maggi_largest_length(d)))
      return maggi_data_fail(
          d, MAGGI_E_ASSEMBLY,
          "\"%s\" cannot start rolling: the centre of a wheel on it is not on its "
          "axis",
          maggi_name_of(d, q));
    if (!isfinite(d->spin[i]))
      return maggi_data_fail(d, MAGGI_E_ASSEMBLY, "\"%s\" cannot start rolling",
                             maggi_name_of(d, q));
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
  status = maggi_assemble(d, t, 0);
  if (status == MAGGI_OK) status = maggi_plan(d, 0, 0.1);
  if (status != MAGGI_OK) return status;
  maggi_settle(d, t);
  for (i = 0; i < d->t.nind; ++i) d->vcol[i] = d->v[d->t.colq[i]];
  return complete(d, t);
}
