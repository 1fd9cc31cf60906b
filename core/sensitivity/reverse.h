/* Adjoint of an evaluation in four parts, written once for the adjoint and for its tangent.
 * In: adjoints of velocities and accelerations.  Out: those of positions, of velocities of independent
 * coordinates and of constants. */
#ifndef MAGGI_REVERSE_H
#define MAGGI_REVERSE_H

/* s->w holds the adjoint of w: forces, then accelerations from the leaves to the root */
static inline void reverse_accelerations(maggi_derivative *D, const maggi_companion *s)
{
  const maggi_topo *t = &D->d->t;

  generalised_forces(D, s);
  accumulate(D, s);
  if (t->ndep > 0) loop_forces(D, s);
  rod_forces(D, s);
  inertia_forces(D, s);
  if (t->ndep > 0) {
    MODE(maggi_close_accelerations)(D, s);
    loop_gamma(D, s);
  }
  if (t->ndep > 0 || t->nrod > 0) point_accelerations(D, s);
  accelerations(D, s);
}

static inline void reverse_velocities(maggi_derivative *D, const maggi_companion *s)
{
  control_forces(D, s);
  element_forces(D, s);
  if (D->d->t.nwheel > 0) wheel_forces(D, s);
  point_velocities(D, s);
  velocities(D, s);
}

static inline void reverse_rates(maggi_derivative *D, const maggi_companion *s)
{
  if (D->d->t.ndep == 0) return;
  MODE(maggi_close_velocities)(D, s);
  loop_rates(D, s);
  point_velocities(D, s);
  velocities(D, s);
}

static inline void reverse_placement(maggi_derivative *D, const maggi_companion *s)
{
  directions(D, s);
  points(D, s);
  positions(D, s);
  MODE(maggi_guides)(D, s);
  functions(D, s);
}

static inline void reverse_positions(maggi_derivative *D, const maggi_companion *s)
{
  body_inertias(D, s);
  if (D->redundant) loop_entries(D, s);
  reverse_placement(D, s);
}

static inline void reverse_constants(maggi_derivative *D, const maggi_companion *s)
{
  spline_constants(D, s);
  point_constants(D, s);
  inertia_constants(D, s);
  joint_constants(D, s);
}

#endif
