/* Tangent of the adjoint.  The sweep over the stages holds the solutions of the adjoint equations; by
 * what these change is one more adjoint sweep, over the tangents that the first has left. */
#include <string.h>

#include "implicit.h"

#define MODE(f) f##_b_d
#define WITH(x) (void *)d->x, (void *)D->tangent.x, (void *)s->x, (void *)D->second.x
#define LAST
#include "stages.h"
/* after the stages that it calls */
#include "reverse.h"

void maggi_second_motion(maggi_derivative *D)
{
  const maggi_companion *s = &D->adjoint, *second = &D->second;
  const maggi_topo *t = &D->d->t;

  maggi_independents_b_d(D, s);
  reverse_accelerations(D, s);
  memset(second->Fr, 0, ((size_t)t->nbody + 1) * 6 * sizeof(double));
  maggi_adjoint_accelerations(D, second, t->ndep > 0 ? D->omega_p : NULL);
  reverse_velocities(D, s);
  reverse_rates(D, s);
  maggi_adjoint_rates(D, second);
  reverse_positions(D, s);
}

void maggi_second_constants(maggi_derivative *D)
{
  reverse_constants(D, &D->adjoint);
}
