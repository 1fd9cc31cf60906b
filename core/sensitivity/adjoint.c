/* Adjoint, on any companion: the sweep is linear in the adjoints that it starts from. */
#include "implicit.h"

#define MODE(f) f##_b
#define WITH(x) (void *)d->x, (void *)s->x
#define LAST
#include "stages.h"
/* after the stages that it calls */
#include "reverse.h"

void maggi_adjoint_accelerations(maggi_derivative *D, const maggi_companion *s,
                                 const double *omega_p)
{
  maggi_independents_b(D, s, omega_p);
  reverse_accelerations(D, s);
}

void maggi_adjoint_rates(maggi_derivative *D, const maggi_companion *s)
{
  reverse_rates(D, s);
}

void maggi_adjoint_closure(maggi_derivative *D)
{
  const maggi_companion *s = &D->adjoint;
  const maggi_topo *t = &D->d->t;
  int i;

  if (t->ndep == 0) return;
  maggi_close_positions_b(D, s);
  loop_residual(D, s);
  reverse_placement(D, s);
  for (i = 0; i < t->ndep; ++i) s->q[t->dep[i]] = 0.0;
}

void maggi_adjoint_motion(maggi_derivative *D)
{
  maggi_adjoint_accelerations(D, &D->adjoint, NULL);
  reverse_velocities(D, &D->adjoint);
  reverse_rates(D, &D->adjoint);
  reverse_positions(D, &D->adjoint);
}

void maggi_adjoint_constants(maggi_derivative *D)
{
  reverse_constants(D, &D->adjoint);
}

void maggi_adjoint_rolling(maggi_derivative *D, const double *v)
{
  const maggi_topo *t = &D->d->t;
  int i;

  for (i = 0; i < t->nwheel; ++i) D->adjoint.spin[i] = v[t->qid[t->wheelbody[i]]];
  rolling(D, &D->adjoint);
}
