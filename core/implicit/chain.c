/* Forces of the open chain.  FORMULATION 3, 4 and 8. */
#include "chain.h"

#include <string.h>

/* C before C23 does not convert double (*)[n] to const double (*)[n] */
#define ARRAY(x) ((void *)(x))

static void guide(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  int i;

  for (i = 0; i < t->nq; ++i) {
    if (t->qguide[i] < 0) continue;
    d->v[i] = d->fun[t->qguide[i]][1];
    d->a[i] = d->fun[t->qguide[i]][2];
  }
}

static void move(maggi_data *d, double time)
{
  const maggi_topo *t = &d->t;

  maggi_evaluate_positions(d, time);
  guide(d);
  maggi_velocities(t, d->p, ARRAY(d->b), d->v, d->Z, d->Z0);
  maggi_point_velocities(t, 0, t->npointdyn, ARRAY(d->r), ARRAY(d->Z), d->rv);
  if (t->nwheel > 0)
    maggi_wheel_forces(t, d->p, ARRAY(d->spline0), ARRAY(d->A), ARRAY(d->Z), ARRAY(d->r),
                       ARRAY(d->rv), d->slip, d->grip, d->roll);
  maggi_element_forces(t, d->p, ARRAY(d->fun), d->spring0, d->q, d->v, ARRAY(d->A), ARRAY(d->Z),
                       ARRAY(d->r), ARRAY(d->rv), ARRAY(d->roll), d->Q, d->tau, d->power);
  maggi_control_forces(t, d->p, ARRAY(d->fun), d->v, ARRAY(d->rv), d->speed, d->tau, d->power);
  maggi_body_inertias(t, ARRAY(d->body0), ARRAY(d->A), ARRAY(d->x), d->I);
}

/* forces that go with the accelerations Za of bodies, without those of loops */
static void resist(maggi_data *d)
{
  const maggi_topo *t = &d->t;

  if (t->nrod > 0)
    maggi_point_accelerations(t, 0, t->npointdyn, ARRAY(d->r), ARRAY(d->rv), ARRAY(d->Z),
                              ARRAY(d->Za), d->ra);
  maggi_inertia_forces(t, ARRAY(d->I), ARRAY(d->Z), ARRAY(d->Za), d->Fr);
  maggi_rod_forces(t, d->p, ARRAY(d->r), ARRAY(d->ra), d->Fr);
}

static void sum(maggi_data *d)
{
  const maggi_topo *t = &d->t;

  maggi_accumulate(t, ARRAY(d->Fr), ARRAY(d->Q), d->FSr);
  maggi_generalised_forces(t, ARRAY(d->b), ARRAY(d->FSr), d->tau, d->w);
}

void maggi_chain_balance(maggi_data *d)
{
  const maggi_topo *t = &d->t;

  maggi_accelerations(t, ARRAY(d->b), ARRAY(d->Z0), d->a, d->Wa, d->Za);
  resist(d);
  maggi_loop_forces(t, d->prim0, ARRAY(d->r), ARRAY(d->dir), d->lambda, d->Fr);
  sum(d);
}

void maggi_chain_accelerate(maggi_data *d, double alpha)
{
  int i;

  for (i = 0; i < d->t.nrow; ++i) d->lambda[i] = alpha * d->res[i];
  maggi_chain_balance(d);
}

void maggi_chain_evaluate(maggi_data *d, double time, double alpha)
{
  move(d, time);
  maggi_chain_accelerate(d, alpha);
}

void maggi_chain_forces(maggi_data *d, double time)
{
  move(d, time);
  memcpy(d->Za, d->Z0, ((size_t)d->t.nbody + 1) * sizeof *d->Za);
  resist(d);
  sum(d);
}

void maggi_chain_rates(maggi_data *d)
{
  maggi_loop_rates(&d->t, d->prim0, ARRAY(d->r), ARRAY(d->dir), ARRAY(d->rv), ARRAY(d->Z), d->rate);
}

void maggi_chain_gamma(maggi_data *d)
{
  const maggi_topo *t = &d->t;

  maggi_point_accelerations(t, 0, t->npointdyn, ARRAY(d->r), ARRAY(d->rv), ARRAY(d->Z),
                            ARRAY(d->Za), d->ra);
  maggi_loop_gamma(t, d->prim0, ARRAY(d->r), ARRAY(d->dir), ARRAY(d->rv), ARRAY(d->ra), ARRAY(d->Z),
                   ARRAY(d->Za), d->gama);
}
