/* Tangent of an evaluation, written once for one direction and for a strip of WIDTH of them.
 * In: constants, positions, velocities of independent coordinates.  Out: all velocities and
 * accelerations, and every tangent on the way with the forces of independent accelerations at rest. */
#ifndef MAGGI_FORWARD_H
#define MAGGI_FORWARD_H

static inline void forward_constants(maggi_derivative *D, const maggi_companion *s)
{
  joint_constants(D, s);
  inertia_constants(D, s);
  point_constants(D, s);
  spline_constants(D, s);
}

static inline void zero(double *x)
{
  int c;

  for (c = 0; c < WIDTH; ++c) x[c] = 0.0;
}

/* guided coordinates of x follow the derivative of their functions of the given order */
static inline void guide(const maggi_topo *t, const maggi_companion *s, int order, double *x)
{
  int i, c, q;

  for (i = t->nind; i < t->ncol; ++i) {
    q = t->colq[i];
    for (c = 0; c < WIDTH; ++c) x[q * WIDTH + c] = s->fun[(t->qguide[q] * 3 + order) * WIDTH + c];
  }
}

/* positions that follow from those of the coordinates that are not dependent */
static inline void forward_positions(maggi_derivative *D, const maggi_companion *s)
{
  functions(D, s);
  guide(&D->d->t, s, 0, s->q);
  positions(D, s);
  points(D, s);
  directions(D, s);
}

static inline void forward(maggi_derivative *D, const maggi_companion *s)
{
  const maggi_data *d = D->d;
  const maggi_topo *t = &d->t;
  int i;

  forward_positions(D, s);
  guide(t, s, 1, s->v);
  for (i = 0; i < t->ndep; ++i) zero(s->v + t->dep[i] * WIDTH);
  velocities(D, s);
  point_velocities(D, s);
  if (t->ndep > 0) {
    if (D->redundant) loop_entries(D, s);
    loop_rates(D, s);
    MODE(maggi_close)(D, -1.0, d->rate, s->rate, s->phi, s->v);
    velocities(D, s);
    point_velocities(D, s);
  }

  for (i = 0; i < t->nq; ++i) zero(s->a + i * WIDTH);
  guide(t, s, 2, s->a);
  accelerations(D, s);
  if (t->ndep > 0 || t->nrod > 0) point_accelerations(D, s);
  if (t->ndep > 0) {
    loop_gamma(D, s);
    MODE(maggi_close)(D, 1.0, d->gama, s->gama, s->phi, s->a);
    accelerations(D, s);
    if (t->nrod > 0) point_accelerations(D, s);
  }

  if (t->nwheel > 0) wheel_forces(D, s);
  element_forces(D, s);
  control_forces(D, s);
  body_inertias(D, s);
  inertia_forces(D, s);
  rod_forces(D, s);
  if (t->ndep > 0) {
    MODE(maggi_multipliers)(D, s);
    loop_forces(D, s);
  }
  accumulate(D, s);
  generalised_forces(D, s);
  MODE(maggi_independents)(D, s);
}

#endif
