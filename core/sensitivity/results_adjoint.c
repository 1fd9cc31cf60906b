/* Adjoints of results. */
#include "results.h"

#include "implicit.h"

#define MODE(f) f##_b
#define WITH(x) (void *)d->x, (void *)s->x
#define LAST
#include "stages.h"
/* after the stages that it calls */
#include "reverse.h"

/* to inertia, elements and multipliers */
static void forces(maggi_derivative *D, const maggi_companion *s)
{
  accumulate(D, s);
  if (D->d->t.ndep > 0) loop_forces(D, s);
  rod_forces(D, s);
  inertia_forces(D, s);
}

void maggi_adjoint_results(maggi_derivative *D, unsigned need)
{
  const maggi_companion *s = &D->adjoint;

  maggi_results(D->d);
  if (need & MAGGI_RESULT_FILTER) filter_outputs(D, s);
  if (need & MAGGI_RESULT_RATE) filter_rates(D, s);
  if (need & MAGGI_RESULT_ENERGY) {
    potential_energy(D, s);
    kinetic_energy(D, s);
  }
  if (need & MAGGI_RESULT_SENSOR) sensors(D, s);
  if (need & MAGGI_RESULT_FORCE) {
    reactions(D, s);
    forces(D, s);
    if (D->d->t.ndep > 0) {
      maggi_balance_multipliers_b(D, s);
      generalised_forces(D, s);
      forces(D, s);
      maggi_multipliers_b(D, s);
    }
  }
  if (need & MAGGI_RESULT_ACCELERATION) sensor_accelerations(D, s);
  if (need & (MAGGI_RESULT_ACCELERATION | MAGGI_RESULT_FORCE)) {
    point_accelerations(D, s);
    accelerations(D, s);
  }
  if (need & MAGGI_RESULT_SENSOR) {
    sensor_velocities(D, s);
    sensor_points(D, s);
  }
}

void maggi_adjoint_given(maggi_derivative *D, unsigned need)
{
  const maggi_companion *s = &D->adjoint;

  maggi_adjoint_results(D, need);
  reverse_velocities(D, s);
  reverse_positions(D, s);
}
