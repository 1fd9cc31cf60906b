/* Tangents of the forces of the open chain along MAGGI_NDIR directions at once. */
#include <string.h>

#include "chain.h"
#include "implicit.h"

#define MODE(f) f##_dv
#define WITH(x) (void *)d->x, (void *)s->x
#define LAST    , MAGGI_NDIR
#define WIDTH   MAGGI_NDIR
#include "stages.h"
/* after the stages that it calls */
#include "forward.h"

static void move(maggi_derivative *D, const maggi_companion *s)
{
  velocities(D, s);
  point_velocities(D, s);
  if (D->d->t.nwheel > 0) wheel_forces(D, s);
  element_forces(D, s);
  control_forces(D, s);
  body_inertias(D, s);
}

static void resist(maggi_derivative *D, const maggi_companion *s)
{
  if (D->d->t.nrod > 0) point_accelerations(D, s);
  inertia_forces(D, s);
  rod_forces(D, s);
}

static void sum(maggi_derivative *D, const maggi_companion *s)
{
  accumulate(D, s);
  generalised_forces(D, s);
}

void maggi_strip_forces(maggi_derivative *D)
{
  const maggi_companion *s = &D->strip;

  positions(D, s);
  points(D, s);
  move(D, s);
  memcpy(s->Za, s->Z0, ((size_t)D->d->t.nbody + 1) * 6 * WIDTH * sizeof(double));
  resist(D, s);
  sum(D, s);
}

void maggi_strip_positions(maggi_derivative *D)
{
  forward_positions(D, &D->strip);
  body_inertias(D, &D->strip);
}

void maggi_strip_rates(maggi_derivative *D)
{
  const maggi_companion *s = &D->strip;

  guide(&D->d->t, s, 1, s->v);
  velocities(D, s);
  point_velocities(D, s);
  loop_rates(D, s);
}

void maggi_strip_gamma(maggi_derivative *D)
{
  const maggi_companion *s = &D->strip;

  guide(&D->d->t, s, 2, s->a);
  velocities(D, s);
  point_velocities(D, s);
  accelerations(D, s);
  point_accelerations(D, s);
  loop_gamma(D, s);
}

void maggi_strip_rest(maggi_derivative *D, maggi_rest *rest)
{
  const maggi_companion *s = &rest->strip;
  maggi_data *d = D->d;

  D->d = &rest->data;
  accelerations(D, s);
  resist(D, s);
  loop_forces(D, s);
  sum(D, s);
  D->d = d;
}

void maggi_strip_balance(maggi_derivative *D, double alpha)
{
  const maggi_companion *s = &D->strip;
  const maggi_topo *t = &D->d->t;
  int i;

  forward_positions(D, s);
  guide(t, s, 1, s->v);
  guide(t, s, 2, s->a);
  move(D, s);
  accelerations(D, s);
  resist(D, s);
  if (t->nrow > 0) {
    loop_residual(D, s);
    for (i = 0; i < t->nrow * WIDTH; ++i) s->lambda[i] = alpha * s->res[i];
    loop_forces(D, s);
  }
  sum(D, s);
}
