/* Tangent along one direction. */
#include "implicit.h"

#define MODE(f) f##_d
#define WITH(x) (void *)d->x, (void *)s->x
#define LAST
#define WIDTH 1
#include "stages.h"
/* after the stages that it calls */
#include "forward.h"

void maggi_tangent_constants(maggi_derivative *D)
{
  forward_constants(D, &D->tangent);
}

void maggi_tangent_motion(maggi_derivative *D)
{
  forward(D, &D->tangent);
}

void maggi_tangent_forces(maggi_derivative *D)
{
  const maggi_companion *s = &D->tangent;
  const maggi_topo *t = &D->d->t;

  if (t->ndep > 0) maggi_multipliers_rest_d(D, s);
  accelerations(D, s);
  if (t->ndep > 0 || t->nrod > 0) point_accelerations(D, s);
  if (t->ndep > 0) {
    loop_rates(D, s);
    loop_gamma(D, s);
    maggi_remainders_d(D, s);
  }
  inertia_forces(D, s);
  rod_forces(D, s);
  if (t->ndep > 0) loop_forces(D, s);
  accumulate(D, s);
}
