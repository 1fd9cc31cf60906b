/* A damped run towards equilibrium: motion through thick oil, in which velocities follow accelerations,
 *
 *   q_i' = a_i(q),      by implicit Euler steps      (1/h - J) dq = a_i
 *
 * It goes down the potential energy, from wherever it starts and through positions where J is singular
 * (a wheel off the road).  Steps grow while they do not move much: at last they are those of Newton. */
#include <math.h>
#include <string.h>

#include "equilibrium.h"

enum { STEPS = 2000, SETTLED = 3 };

static const double begin = 1e-4; /* s^2, as h multiplies an acceleration */
static const double long_h = 1e9; /* as good as Newton's method */
static const double far = 0.1;    /* largest move of a coordinate in a step [m, rad] */
static const double near = 1e-5;  /* moves of long steps that end it */
static const double growth = 2.0;
static const double shorter = 0.25;

/* (1/h - J) dq = a_i; false where that cannot be solved or goes too far */
static int step(maggi_equilibrium *e, double h)
{
  maggi_data *x = e->x;
  int i, n = x->t.nind;

  for (i = 0; i < n * n; ++i) e->J[i] = -e->J[i];
  for (i = 0; i < n; ++i) e->J[i * n + i] += 1.0 / h;
  if (!maggi_dense_factor(&e->factor, n, e->J)) return 0;
  for (i = 0; i < n; ++i) e->move[i] = x->acol[i];
  maggi_dense_solve(&e->factor, e->move);
  if (!(maggi_equilibrium_largest(e, e->move) <= far)) return 0;
  memcpy(e->q, x->q, (size_t)x->t.nq * sizeof(double));
  return maggi_equilibrium_move(e, e->move, 1.0);
}

int maggi_equilibrium_damped(maggi_equilibrium *e)
{
  double h = begin;
  int k, settled = 0;

  for (k = 0; k < STEPS && settled < SETTLED; ++k) {
    if (maggi_equilibrium_linearise(e) != MAGGI_OK) return 0;
    if (step(e, h)) {
      ++e->damped;
      settled = h >= 1.0 && maggi_equilibrium_largest(e, e->move) <= near ? settled + 1 : 0;
      h = fmin(growth * h, long_h);
    } else {
      h *= shorter;
      if (!(h > 1e-300)) return 0;
    }
  }
  return settled == SETTLED;
}
