/* The continuous adjoint method: adjoint equations of the motion y' = f(y, p), y = (q, u, filters), integrated
 * backwards over each step of the simulation.  [1] 5.4, FORMULATION 9.
 *
 *   mu' = -f_y^T mu,   dJ/dp = int mu^T f_p dt + what samples and the initial state add
 *
 * mu jumps at a sample by the derivatives of the objective by its signals, as the adjoints of the discrete
 * method do.  The classical Runge-Kutta method from node i + 1 to node i, F for f_y^T and h > 0,
 *
 *   K_1 = F(y_i+1) mu_i+1,            K_2 = F(y_m) (mu_i+1 + h/2 K_1)
 *   K_3 = F(y_m) (mu_i+1 + h/2 K_2),  K_4 = F(y_i) (mu_i+1 + h K_3)
 *   mu_i = mu_i+1 + h/6 (K_1 + 2 K_2 + 2 K_3 + K_4)
 *
 * and the same weights for the integral are the adjoint of the Runge-Kutta step of the simulation with its
 * stages 4, 3, 2, 1 evaluated at other states: the nodes, where the simulation is known, and the middle,
 * by cubic Hermite interpolation
 *
 *   y_m = (y_i + y_i+1)/2 + h/8 (y_i' - y_i+1')
 *
 * The result differs from the discrete one by O(h^4), the error of both.  The motion stays on the loops, so
 * that projections have no part in it. */
#include "reversal.h"

/* y_m from y_i, its stage 2, which is y_i + h/2 y_i', and y_i+1 with its slope */
static double middle(double y0, double y2, double y1, double slope, double h)
{
  return 0.25 * (y0 + y2) + 0.5 * y1 - 0.125 * h * slope;
}

/* d is evaluated at node i + 1 before stage 3, and in the middle before stage 1 */
static maggi_status evaluate(maggi_reversal *r, const maggi_tape *tape, long i, int stage)
{
  maggi_data *d = r->d;
  const double *y0 = maggi_tape_state(tape, i, 0), *y2 = maggi_tape_state(tape, i, 1);
  double h = tape->step[i].h, time = tape->step[i].time + 0.5 * h;
  int k, nq = d->t.nq, filters = nq + d->t.nind;

  if (stage != 2) return MAGGI_OK;
  for (k = 0; k < nq; ++k) d->q[k] = middle(y0[k], y2[k], d->q[k], d->v[k], h);
  for (k = 0; k < d->t.nind; ++k)
    d->vcol[k] = middle(y0[nq + k], y2[nq + k], d->vcol[k], d->acol[k], h);
  for (k = 0; k < d->t.nstate; ++k)
    d->y[k] = middle(y0[filters + k], y2[filters + k], d->y[k], d->yrate[k], h);
  maggi_evaluate(d, time);
  maggi_evaluate_filters(d);
  return maggi_linearise_at(r->D, time);
}

maggi_status maggi_continuous_step(maggi_reversal *r, const maggi_tape *tape, long i)
{
  return maggi_reversal_stages(r, tape, i, evaluate);
}
