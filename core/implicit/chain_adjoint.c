/* Adjoints of the forces of the open chain. */
#include "chain.h"
#include "implicit.h"

#define MODE(f) f##_b
#define WITH(x) (void *)d->x, (void *)s->x
#define LAST
#include "stages.h"
/* after the stages that it calls */
#include "reverse.h"

void maggi_adjoint_forces(maggi_derivative *D)
{
  const maggi_companion *s = &D->adjoint;
  int i;

  generalised_forces(D, s);
  accumulate(D, s);
  rod_forces(D, s);
  inertia_forces(D, s);
  if (D->d->t.nrod > 0) point_accelerations(D, s);
  for (i = 0; i < (D->d->t.nbody + 1) * 6; ++i) {
    s->Z0[i] += s->Za[i];
    s->Za[i] = 0.0;
  }
  body_inertias(D, s);
  control_forces(D, s);
  element_forces(D, s);
  if (D->d->t.nwheel > 0) wheel_forces(D, s);
  point_velocities(D, s);
  velocities(D, s);
  points(D, s);
  positions(D, s);
}

void maggi_adjoint_rest(maggi_derivative *D, maggi_rest *rest)
{
  const maggi_companion *s = &rest->adjoint;
  maggi_data *d = D->d;

  D->d = &rest->data;
  generalised_forces(D, s);
  accumulate(D, s);
  loop_forces(D, s);
  rod_forces(D, s);
  inertia_forces(D, s);
  if (d->t.nrod > 0) point_accelerations(D, s);
  accelerations(D, s);
  D->d = d;
}

void maggi_adjoint_balance(maggi_derivative *D, double alpha)
{
  const maggi_companion *s = &D->adjoint;
  const maggi_topo *t = &D->d->t;
  int i;

  generalised_forces(D, s);
  accumulate(D, s);
  if (t->nrow > 0) {
    loop_forces(D, s);
    for (i = 0; i < t->nrow; ++i) {
      s->res[i] += alpha * s->lambda[i];
      s->lambda[i] = 0.0;
    }
    loop_residual(D, s);
  }
  rod_forces(D, s);
  inertia_forces(D, s);
  if (t->nrod > 0) point_accelerations(D, s);
  accelerations(D, s);
  control_forces(D, s);
  element_forces(D, s);
  if (D->d->t.nwheel > 0) wheel_forces(D, s);
  point_velocities(D, s);
  velocities(D, s);
}

void maggi_adjoint_gamma(maggi_derivative *D)
{
  const maggi_companion *s = &D->adjoint;

  loop_gamma(D, s);
  point_accelerations(D, s);
  accelerations(D, s);
  point_velocities(D, s);
  velocities(D, s);
}

void maggi_adjoint_rates_of(maggi_derivative *D)
{
  const maggi_companion *s = &D->adjoint;

  loop_rates(D, s);
  point_velocities(D, s);
  velocities(D, s);
}

void maggi_adjoint_positions(maggi_derivative *D)
{
  body_inertias(D, &D->adjoint);
  reverse_placement(D, &D->adjoint);
}
