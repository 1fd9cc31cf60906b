/* maggi: an evaluation, its linearisation, a derivative.  Constants depend on the parameters alone, so
 * that an integrator takes their derivatives once and not in each evaluation: a second method. */
#include <stdlib.h>

#include "derivative.h"
#include "methods.h"

typedef struct workspace {
  const problem *of;
  maggi_derivative *D;
  int once;                   /* derivatives of constants are kept .. */
  int has_strips, has_column; /* .. when they are there */
} workspace;

static void *open_workspace(const problem *of)
{
  workspace *m = calloc(1, sizeof *m);

  if (!m) return NULL;
  m->of = of;
  if (maggi_derivative_create(of->d, DIRECTIONS, &m->D) == MAGGI_OK) return m;
  free(m);
  return NULL;
}

static void *open_once(const problem *of)
{
  workspace *m = open_workspace(of);

  if (m) m->once = 1;
  return m;
}

static void close_workspace(void *self)
{
  workspace *m = self;

  maggi_derivative_free(m->D);
  free(m);
}

static void evaluation(workspace *m)
{
  maggi_evaluate(m->of->d, m->of->time);
}

static void linearisation(workspace *m)
{
  m->of->d->fresh = MAGGI_STALE; /* as after an evaluation */
  maggi_linearise(m->D);
}

static void constants_of_directions(workspace *m, const double *xds)
{
  maggi_parameters_jac(m->D, DIRECTIONS, DIRECTIONS, xds + 2 * m->of->t->nq * DIRECTIONS);
}

static void motion_of_directions(workspace *m, const double *xds, double *yd)
{
  int rows = m->of->t->nq * DIRECTIONS;

  maggi_state_jac(m->D, DIRECTIONS, DIRECTIONS, xds, xds + rows, yd, yd + rows);
}

static void constants_of_direction(workspace *m, const double *xd)
{
  maggi_parameters_jvp(m->D, xd + 2 * m->of->t->nq);
}

static void motion_of_direction(workspace *m, const double *xd, double *yd)
{
  int n = m->of->t->nq;

  maggi_state_jvp(m->D, xd, xd + n, yd, yd + n);
}

static void motion_of_gradient(workspace *m, const double *yb, double *xb)
{
  int n = m->of->t->nq;

  maggi_parameters_clear(m->D);
  maggi_state_vjp(m->D, yb, yb + n, xb, xb + n);
}

static void constants_of_gradient(workspace *m, double *xb)
{
  maggi_parameters_vjp(m->D, xb + 2 * m->of->t->nq);
}

static void second(workspace *m, const double *yb, const double *xd, double *xbd)
{
  int n = m->of->t->nq;

  maggi_motion_hvp(m->D, yb, yb + n, xd, xd + n, xd + 2 * n, xbd, xbd + n, xbd + 2 * n);
}

/* ---------------------------------------------------------------------------- methods */

static void directions(void *self, const double *xds, double *yd)
{
  workspace *m = self;
  int rows = m->of->t->nq * DIRECTIONS;

  evaluation(m);
  maggi_linearise(m->D);
  if (!m->once) {
    maggi_motion_jac(m->D, DIRECTIONS, xds, xds + rows, xds + 2 * rows, yd, yd + rows);
  } else {
    if (!m->has_strips) constants_of_directions(m, xds);
    m->has_strips = 1;
    motion_of_directions(m, xds, yd);
  }
}

static void direction(void *self, const double *xd, double *yd)
{
  workspace *m = self;
  int n = m->of->t->nq;

  evaluation(m);
  maggi_linearise(m->D);
  if (!m->once) {
    maggi_motion_jvp(m->D, xd, xd + n, xd + 2 * n, yd, yd + n);
  } else {
    if (!m->has_column) constants_of_direction(m, xd);
    m->has_column = 1;
    motion_of_direction(m, xd, yd);
  }
}

static void gradient(void *self, const double *yb, double *xb)
{
  workspace *m = self;
  int n = m->of->t->nq;

  evaluation(m);
  maggi_linearise(m->D);
  maggi_motion_vjp(m->D, yb, yb + n, xb, xb + n, xb + 2 * n);
}

static void hessian(void *self, const double *yb, const double *xd, double *xbd)
{
  workspace *m = self;

  evaluation(m);
  maggi_linearise(m->D);
  second(m, yb, xd, xbd);
}

const method method_maggi = {"maggi",   open_workspace, close_workspace, directions,
                             direction, gradient,       hessian,         0.0};
const method method_maggi_once = {
    "maggi, constants once", open_once, close_workspace, directions, direction, NULL, NULL, 1e-12};

/* ------------------------------------------------------------------------------ parts */

void maggi_part(void *self, int part, const double *xds, const double *xd, const double *yb,
                double *result)
{
  workspace *m = self;

  if (part == PART_EVALUATION)
    evaluation(m);
  else if (part == PART_LINEARISATION)
    linearisation(m);
  else if (part == PART_DIRECTIONS_CONSTANTS)
    constants_of_directions(m, xds);
  else if (part == PART_DIRECTIONS_MOTION)
    motion_of_directions(m, xds, result);
  else if (part == PART_DIRECTION_CONSTANTS)
    constants_of_direction(m, xd);
  else if (part == PART_DIRECTION_MOTION)
    motion_of_direction(m, xd, result);
  else if (part == PART_GRADIENT_MOTION)
    motion_of_gradient(m, yb, result);
  else if (part == PART_GRADIENT_CONSTANTS)
    constants_of_gradient(m, result);
  else
    second(m, yb, xd, result);
}
