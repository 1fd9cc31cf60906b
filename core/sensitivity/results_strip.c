/* Tangents of results along MAGGI_NDIR directions at once. */
#include "results.h"

#include "implicit.h"

#define MODE(f) f##_dv
#define WITH(x) (void *)d->x, (void *)s->x
#define LAST    , MAGGI_NDIR
#define WIDTH   MAGGI_NDIR
#include "stages.h"
/* after the stages that it calls */
#include "forward.h"

static void forces(maggi_derivative *D, const maggi_companion *s)
{
  inertia_forces(D, s);
  rod_forces(D, s);
  if (D->d->t.ndep > 0) loop_forces(D, s);
  accumulate(D, s);
}

/* from the tangents of q, v, a, of what goes with q and v, and of lambda */
static void results(maggi_derivative *D, const maggi_companion *s, unsigned need)
{
  if (need & (MAGGI_RESULT_ACCELERATION | MAGGI_RESULT_FORCE)) {
    accelerations(D, s);
    point_accelerations(D, s);
  }
  if (need & MAGGI_RESULT_FORCE) {
    forces(D, s);
    reactions(D, s);
  }
  if (need & MAGGI_RESULT_SENSOR) {
    sensor_points(D, s);
    sensor_velocities(D, s);
    if (need & MAGGI_RESULT_ACCELERATION) sensor_accelerations(D, s);
    sensors(D, s);
  }
  if (need & MAGGI_RESULT_ENERGY) {
    kinetic_energy(D, s);
    potential_energy(D, s);
  }
}

/* with lambda = G mu, of the mu that balances forces on dependent coordinates */
static void given_multipliers(maggi_derivative *D, const maggi_companion *s)
{
  if (D->redundant) loop_entries(D, s);
  maggi_multipliers_dv(D, s);
  accelerations(D, s);
  point_accelerations(D, s);
  forces(D, s);
  generalised_forces(D, s);
  maggi_multipliers_rest_dv(D, s);
}

void maggi_strip_given(maggi_derivative *D, unsigned need)
{
  const maggi_companion *s = &D->strip;
  const maggi_topo *t = &D->d->t;

  maggi_results(D->d);
  forward_positions(D, s);
  guide(t, s, 1, s->v);
  guide(t, s, 2, s->a);
  velocities(D, s);
  point_velocities(D, s);
  if (t->nwheel > 0) wheel_forces(D, s);
  body_inertias(D, s);
  if (need & (MAGGI_RESULT_FORCE | MAGGI_RESULT_SENSOR)) {
    element_forces(D, s);
    control_forces(D, s);
  }
  if (need & MAGGI_RESULT_FORCE) {
    if (t->ndep > 0) given_multipliers(D, s);
  }
  results(D, s, need);
}
