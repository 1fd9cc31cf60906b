/* One evaluation of the equations of motion: the kernel, stage by stage. */
#include "data.h"

#include <math.h>

/* C before C23 does not convert double (*)[n] to const double (*)[n] */
#define ARRAY(x) ((void *)(x))

void maggi_constants(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  int k;

  for (k = 0; k < 3; ++k) d->origin[k] = d->p[d->m->originadr + k];
  maggi_joint_constants(t, d->p, d->origin, d->offset0, d->axis0);
  maggi_inertia_constants(t, d->p, d->body0);
  maggi_point_constants(t, d->p, d->origin, d->point0, d->dir0, d->prim0, d->spring0);
  maggi_spline_constants(t, d->p, d->spline0);
}

void maggi_evaluate_positions(maggi_data *d, double time)
{
  const maggi_topo *t = &d->t;
  int i;

  maggi_functions(t, d->p, ARRAY(d->spline0), time, d->fun);
  for (i = 0; i < t->nq; ++i)
    if (t->qguide[i] >= 0) d->q[i] = d->fun[t->qguide[i]][0];
  maggi_positions(t, ARRAY(d->offset0), ARRAY(d->axis0), d->q, d->turn, d->A, d->x, d->b);
  maggi_points(t, 0, t->npointdyn, ARRAY(d->point0), ARRAY(d->A), ARRAY(d->x), d->r);
  maggi_directions(t, ARRAY(d->dir0), ARRAY(d->A), d->dir);
  maggi_loop_residual(t, d->prim0, ARRAY(d->r), ARRAY(d->dir), d->res);
}

void maggi_evaluate_factors(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  int dep;

  maggi_loop_entries(t, d->prim0, ARRAY(d->r), ARRAY(d->dir), ARRAY(d->b), d->phi);
  maggi_island_factors(t, d->phi, d->chol);
  maggi_smallest_pivot(d, &d->stage_ratio, &dep);
}

static void move(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  int i;

  for (i = t->nind; i < t->ncol; ++i) d->vcol[i] = d->fun[t->qguide[t->colq[i]]][1];
  maggi_island_columns(t, d->prim0, ARRAY(d->r), ARRAY(d->dir), ARRAY(d->b), d->phi, d->chol, d->V,
                       d->Y, d->R, d->space);
  maggi_expand(t, d->R, d->vcol, d->zero, d->v);
  maggi_velocities(t, d->p, ARRAY(d->b), d->v, d->Z, d->Z0);
  maggi_point_velocities(t, 0, t->npointdyn, ARRAY(d->r), ARRAY(d->Z), d->rv);
}

static void accelerate(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  void *Zb = t->ndep > 0 ? d->Zb : d->Z0;
  int i;

  if (t->ndep > 0) {
    maggi_point_accelerations(t, 0, t->npointdyn, ARRAY(d->r), ARRAY(d->rv), ARRAY(d->Z),
                              ARRAY(d->Z0), d->r0a);
    maggi_loop_gamma(t, d->prim0, ARRAY(d->r), ARRAY(d->dir), ARRAY(d->rv), ARRAY(d->r0a),
                     ARRAY(d->Z), ARRAY(d->Z0), d->gam);
    maggi_island_vector(t, d->prim0, ARRAY(d->r), ARRAY(d->dir), ARRAY(d->b), d->phi, d->chol,
                        d->gam, d->v1, d->y1, d->ab, d->space);
    maggi_accelerations(t, ARRAY(d->b), ARRAY(d->Z0), d->ab, d->W, d->Zb);
  }
  if (t->nwheel > 0)
    maggi_wheel_forces(t, d->p, ARRAY(d->spline0), ARRAY(d->A), ARRAY(d->Z), ARRAY(d->r),
                       ARRAY(d->rv), d->slip, d->grip, d->roll);
  maggi_element_forces(t, d->p, ARRAY(d->fun), d->spring0, d->q, d->v, ARRAY(d->A), ARRAY(d->Z),
                       ARRAY(d->r), ARRAY(d->rv), ARRAY(d->roll), d->Q, d->tau, d->power);
  maggi_control_forces(t, d->p, ARRAY(d->fun), d->v, ARRAY(d->rv), d->speed, d->tau, d->power);
  maggi_body_inertias(t, ARRAY(d->body0), ARRAY(d->A), ARRAY(d->x), d->I);
  maggi_inertia_forces(t, ARRAY(d->I), ARRAY(d->Z), Zb, d->F);
  if (t->nrod > 0) {
    maggi_point_accelerations(t, 0, t->npointdyn, ARRAY(d->r), ARRAY(d->rv), ARRAY(d->Z), Zb,
                              d->rba);
    maggi_rod_forces(t, d->p, ARRAY(d->r), ARRAY(d->rba), d->F);
  }
  maggi_accumulate(t, ARRAY(d->F), ARRAY(d->Q), d->FS);
  maggi_composite_inertias(t, d->p, ARRAY(d->r), ARRAY(d->I), d->IS);
  maggi_mass_matrix(t, d->p, ARRAY(d->b), ARRAY(d->r), ARRAY(d->IS), d->Fb, d->rodjac, d->M);
  maggi_reduced_mass(t, d->M, d->R, d->MR, d->Mr);
  maggi_generalised_forces(t, ARRAY(d->b), ARRAY(d->FS), d->tau, d->f);
  maggi_reduced_force(t, d->f, d->R, d->fr);
  for (i = t->nind; i < t->ncol; ++i) d->acol[i] = d->fun[t->qguide[t->colq[i]]][2];
  maggi_factor_mass(t, d->Mr, d->Ur, d->dinv);
  maggi_solve_mass(t, d->Mr, d->fr, d->Ur, d->dinv, d->acol);
  maggi_expand(t, d->R, d->acol, d->ab, d->a);
  if (t->nguide > 0) {
    maggi_drives(t, d->Mr, d->fr, d->acol, d->drive);
    for (i = t->nind; i < t->ncol; ++i) d->power[0] += d->drive[i] * d->vcol[i];
  }
}

void maggi_evaluate(maggi_data *d, double time)
{
  maggi_evaluate_positions(d, time);
  maggi_evaluate_factors(d);
  move(d);
  accelerate(d);
  ++d->evaluations;
  d->fresh = MAGGI_STALE;
}

void maggi_evaluate_given(maggi_data *d, double time)
{
  const maggi_topo *t = &d->t;
  int i, q;

  maggi_evaluate_positions(d, time);
  maggi_evaluate_factors(d);
  for (i = 0; i < t->ncol; ++i) {
    q = t->colq[i];
    if (i >= t->nind) {
      d->v[q] = d->fun[t->qguide[q]][1];
      d->a[q] = d->fun[t->qguide[q]][2];
    }
    d->vcol[i] = d->v[q];
    d->acol[i] = d->a[q];
  }
  maggi_velocities(t, d->p, ARRAY(d->b), d->v, d->Z, d->Z0);
  maggi_point_velocities(t, 0, t->npointdyn, ARRAY(d->r), ARRAY(d->Z), d->rv);
  if (t->nwheel > 0)
    maggi_wheel_forces(t, d->p, ARRAY(d->spline0), ARRAY(d->A), ARRAY(d->Z), ARRAY(d->r),
                       ARRAY(d->rv), d->slip, d->grip, d->roll);
  maggi_element_forces(t, d->p, ARRAY(d->fun), d->spring0, d->q, d->v, ARRAY(d->A), ARRAY(d->Z),
                       ARRAY(d->r), ARRAY(d->rv), ARRAY(d->roll), d->Q, d->tau, d->power);
  maggi_control_forces(t, d->p, ARRAY(d->fun), d->v, ARRAY(d->rv), d->speed, d->tau, d->power);
  maggi_body_inertias(t, ARRAY(d->body0), ARRAY(d->A), ARRAY(d->x), d->I);
  d->fresh = MAGGI_STALE;
}

/* Where a loop loses rank its Jacobian cannot tell the dependent velocities: a loop that is open by
 * rho displaces them by rho / sigma^2, sigma its smallest singular value, and rho is round-off at
 * best.  Measured by pivots relative to those at the choice of the independent coordinates. */
int maggi_is_singular(const maggi_data *d)
{
  return !(MAGGI_RE(d->stage_ratio) > 6e-4);
}

/* Accelerations of bodies as they are, and the forces that go with them: inertia, elements, rods and
 * loops are in balance but for the drives of guided coordinates. */
void maggi_balance(maggi_data *d)
{
  const maggi_topo *t = &d->t;

  if (d->fresh != MAGGI_STALE) return;
  maggi_accelerations(t, ARRAY(d->b), ARRAY(d->Z0), d->a, d->Wa, d->Za);
  maggi_point_accelerations(t, 0, t->npointdyn, ARRAY(d->r), ARRAY(d->rv), ARRAY(d->Z),
                            ARRAY(d->Za), d->ra);
  maggi_inertia_forces(t, ARRAY(d->I), ARRAY(d->Z), ARRAY(d->Za), d->Fr);
  maggi_rod_forces(t, d->p, ARRAY(d->r), ARRAY(d->ra), d->Fr);
  maggi_accumulate(t, ARRAY(d->Fr), ARRAY(d->Q), d->FSr);
  if (t->nrow > 0) {
    maggi_generalised_forces(t, ARRAY(d->b), ARRAY(d->FSr), d->tau, d->w);
    maggi_loop_multipliers(t, d->prim0, ARRAY(d->r), ARRAY(d->dir), ARRAY(d->b), d->phi, d->chol,
                           d->w, d->G1, d->y1, d->mu, d->lambda, d->space);
    maggi_loop_forces(t, d->prim0, ARRAY(d->r), ARRAY(d->dir), d->lambda, d->Fr);
    maggi_accumulate(t, ARRAY(d->Fr), ARRAY(d->Q), d->FSr);
  }
  d->fresh = MAGGI_BALANCED;
}

void maggi_results(maggi_data *d)
{
  const maggi_topo *t = &d->t;

  if (d->fresh == MAGGI_FRESH) return;
  maggi_balance(d);
  maggi_points(t, t->npointdyn, t->npoint, ARRAY(d->point0), ARRAY(d->A), ARRAY(d->x), d->r);
  maggi_point_velocities(t, t->npointdyn, t->npoint, ARRAY(d->r), ARRAY(d->Z), d->rv);
  maggi_point_accelerations(t, t->npointdyn, t->npoint, ARRAY(d->r), ARRAY(d->rv), ARRAY(d->Z),
                            ARRAY(d->Za), d->ra);
  maggi_reactions(t, ARRAY(d->x), ARRAY(d->FSr), d->wrench);
  maggi_sensors(t, d->p, d->origin, d->spring0, d->q, d->v, ARRAY(d->A), ARRAY(d->x), ARRAY(d->r),
                ARRAY(d->Z), ARRAY(d->rv), ARRAY(d->Za), ARRAY(d->ra), d->lambda, ARRAY(d->slip),
                ARRAY(d->grip), d->sensor);
  d->fresh = MAGGI_FRESH;
}

double maggi_violation(const maggi_data *d)
{
  double largest = 0.0;
  int i;

  for (i = 0; i < d->t.nrow; ++i) {
    if (isnan(d->res[i])) return NAN;
    if (MAGGI_RE(fabs(d->res[i])) > MAGGI_RE(largest)) largest = fabs(d->res[i]);
  }
  return largest;
}

/* smallest pivot; the smallest ratio of one to its size at the choice, and which dependent it is */
double maggi_smallest_pivot(const maggi_data *d, double *ratio, int *dep)
{
  const maggi_topo *t = &d->t;
  double largest = 0.0, inverse, worst = 0.0;
  int i, k, n;

  *dep = -1;
  for (k = 0; k < t->nisland; ++k) {
    n = t->isldep[k + 1] - t->isldep[k];
    for (i = 0; i < n; ++i) {
      inverse = d->chol[t->islchol[k] + i * n + i];
      if (isnan(inverse)) {
        *dep = t->isldep[k] + i;
        *ratio = NAN;
        return NAN;
      }
      largest = MAGGI_RE(inverse) > MAGGI_RE(largest) ? inverse : largest;
      inverse *= d->piv0[t->isldep[k] + i];
      if (MAGGI_RE(inverse) > MAGGI_RE(worst)) {
        worst = inverse;
        *dep = t->isldep[k] + i;
      }
    }
  }
  *ratio = t->ndep > 0 ? 1.0 / worst : 1.0;
  return 1.0 / largest;
}

void maggi_path_entry(const maggi_data *d, int prim, int i, double e[3])
{
  const maggi_topo *t = &d->t;

  maggi_prim_entry(t->primkind[prim], t->pathside[i], d->prim0[prim], d->b[t->qbody[t->pathq[i]]],
                   d->r[t->primpa[prim]], d->r[t->primpb[prim]], d->dir[t->primda[prim]],
                   d->dir[t->primdb[prim]], e);
}

/* loop with the largest residual */
int maggi_worst_loop(const maggi_data *d)
{
  int i, k, worst = 0;
  double largest = -1.0;

  for (i = 0; i < d->m->nloop; ++i) {
    for (k = d->m->loop[i].row; k < d->m->loop[i].row + d->m->loop[i].rows; ++k) {
      if (!(MAGGI_RE(fabs(d->res[k])) <= MAGGI_RE(largest))) {
        largest = fabs(d->res[k]);
        worst = i;
      }
    }
  }
  return worst;
}
