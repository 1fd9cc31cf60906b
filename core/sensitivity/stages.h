/* Calls of the derivatives of the stages of an evaluation, once for all modes of differentiation.
 * Who includes this says what they are:
 *
 *   MODE(f)   the derivative of the kernel function f
 *   WITH(x)   array x of the maggi_data d, then what belongs to it in the companion s
 *   LAST      arguments after the others, if any
 *
 * The stages are here in the order of an evaluation. */
#ifndef MAGGI_STAGES_H
#define MAGGI_STAGES_H

#define CALL(stage, name, ...)                                                                     \
  static inline void stage(maggi_derivative *D, const maggi_companion *s)                          \
  {                                                                                                \
    maggi_data *d = D->d;                                                                          \
    const maggi_topo *t = &d->t;                                                                   \
                                                                                                   \
    MODE(maggi_##name)(t, __VA_ARGS__ LAST);                                                       \
  }
#define STAGE(name, ...) CALL(name, name, __VA_ARGS__)

/* what depends on p alone */
STAGE(joint_constants, WITH(p), d->origin, WITH(offset0), WITH(axis0))
STAGE(inertia_constants, WITH(p), WITH(body0))
STAGE(point_constants, WITH(p), d->origin, WITH(point0), WITH(dir0), WITH(prim0), WITH(spring0))
STAGE(spline_constants, WITH(p), WITH(spline0))

/* positions */
STAGE(functions, WITH(p), WITH(spline0), D->time, WITH(fun))
STAGE(positions, WITH(offset0), WITH(axis0), WITH(q), WITH(turn), WITH(A), WITH(x), WITH(b))
STAGE(points, 0, t->npointdyn, WITH(point0), WITH(A), WITH(x), WITH(r))
STAGE(directions, WITH(dir0), WITH(A), WITH(dir))
STAGE(loop_residual, WITH(prim0), WITH(r), WITH(dir), WITH(res))
STAGE(loop_entries, WITH(prim0), WITH(r), WITH(dir), WITH(b), WITH(phi))

/* velocities */
STAGE(velocities, WITH(p), WITH(b), WITH(v), WITH(Z), WITH(Z0))
STAGE(point_velocities, 0, t->npointdyn, WITH(r), WITH(Z), WITH(rv))
STAGE(loop_rates, WITH(prim0), WITH(r), WITH(dir), WITH(rv), WITH(Z), WITH(rate))

/* accelerations */
STAGE(accelerations, WITH(b), WITH(Z0), WITH(a), WITH(Wa), WITH(Za))
STAGE(point_accelerations, 0, t->npointdyn, WITH(r), WITH(rv), WITH(Z), WITH(Za), WITH(ra))
STAGE(loop_gamma, WITH(prim0), WITH(r), WITH(dir), WITH(rv), WITH(ra), WITH(Z), WITH(Za),
      WITH(gama))

/* forces */
STAGE(wheel_forces, WITH(p), WITH(spline0), WITH(A), WITH(Z), WITH(r), WITH(rv), WITH(slip),
      WITH(grip), WITH(roll))
STAGE(element_forces, WITH(p), WITH(fun), WITH(spring0), WITH(q), WITH(v), WITH(A), (void *)d->Z,
      WITH(r), WITH(rv), WITH(roll), WITH(Q), WITH(tau), D->power)
STAGE(control_forces, WITH(p), WITH(fun), d->v, WITH(rv), WITH(speed), WITH(tau), D->power)
STAGE(body_inertias, WITH(body0), WITH(A), WITH(x), WITH(I))
STAGE(inertia_forces, WITH(I), WITH(Z), WITH(Za), WITH(Fr))
STAGE(rod_forces, WITH(p), WITH(r), WITH(ra), WITH(Fr))
STAGE(loop_forces, WITH(prim0), WITH(r), WITH(dir), WITH(lambda), WITH(Fr))
STAGE(accumulate, WITH(Fr), WITH(Q), WITH(FSr))
STAGE(generalised_forces, WITH(b), WITH(FSr), WITH(tau), WITH(w))

/* initial velocities */
STAGE(rolling, WITH(p), WITH(spline0), WITH(A), WITH(b), WITH(r), WITH(Z), WITH(spin))

/* results */
STAGE(reactions, WITH(x), WITH(FSr), WITH(wrench))
CALL(sensor_points, points, t->npointdyn, t->npoint, WITH(point0), WITH(A), WITH(x), WITH(r))
CALL(sensor_velocities, point_velocities, t->npointdyn, t->npoint, WITH(r), WITH(Z), WITH(rv))
CALL(sensor_accelerations, point_accelerations, t->npointdyn, t->npoint, WITH(r), WITH(rv), WITH(Z),
     WITH(Za), WITH(ra))
STAGE(sensors, WITH(p), d->origin, WITH(spring0), WITH(q), WITH(v), WITH(A), WITH(x), WITH(r),
      WITH(Z), WITH(rv), WITH(Za), WITH(ra), WITH(lambda), WITH(slip), WITH(grip), WITH(sensor))
STAGE(kinetic_energy, WITH(p), WITH(I), WITH(Z), WITH(rv), WITH(kinetic))
STAGE(potential_energy, WITH(p), d->origin, WITH(body0), WITH(spring0), WITH(q), WITH(A), WITH(x),
      WITH(r), WITH(potential))

#undef STAGE
#undef CALL

#endif
