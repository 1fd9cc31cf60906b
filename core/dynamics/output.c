/* What one can ask a simulation. */
#include "data.h"

double maggi_get_time(const maggi_data *d)
{
  return d->time;
}

void maggi_get_coordinates(const maggi_data *d, double *q, double *v, double *a)
{
  int i, k;

  for (i = 0; i < d->m->ncoordinate; ++i) {
    k = d->m->coordinate[i].q;
    if (q) q[i] = d->q[k];
    if (v) v[i] = d->v[k];
    if (a) a[i] = d->a[k];
  }
}

void maggi_get_sensors(maggi_data *d, double *values)
{
  int i, k;

  maggi_results(d);
  for (i = 0; i < d->t.nsensor; ++i)
    for (k = 0; k < 3; ++k) values[3 * i + k] = d->sensor[i][k];
}

void maggi_get_drives(maggi_data *d, double *drives)
{
  int i, c;

  for (i = 0; i < d->m->ncoordinate; ++i) {
    c = d->ready ? d->t.col[d->m->coordinate[i].q] : -1;
    drives[i] = c >= d->t.nind ? d->drive[c] : 0.0;
  }
}

void maggi_get_reactions(maggi_data *d, double *wrenches)
{
  int i, j, k;
  double moment[3], *w;

  maggi_results(d);
  for (i = 0; i < d->m->nbody; ++i) {
    j = d->m->body[i].body;
    w = wrenches + 6 * i;
    maggi_cross(d->x[j], d->FSr[j], moment);
    for (k = 0; k < 3; ++k) {
      w[k] = -d->FSr[j][k];
      w[k + 3] = moment[k] - d->FSr[j][k + 3];
    }
  }
}

void maggi_get_multipliers(maggi_data *d, double *lambda)
{
  int i;

  maggi_results(d);
  for (i = 0; i < d->t.nrow; ++i) lambda[i] = d->lambda[i];
}

void maggi_get_energy(maggi_data *d, maggi_energy *energy)
{
  double e[1];

  maggi_kinetic_energy(&d->t, d->p, (void *)d->I, (void *)d->Z, (void *)d->rv, e);
  energy->kinetic = e[0];
  maggi_potential_energy(&d->t, d->p, d->origin, (void *)d->body0, d->spring0, d->q, (void *)d->A,
                         (void *)d->x, (void *)d->r, e);
  energy->potential = e[0];
  energy->work = d->work;
}

void maggi_get_loop_state(const maggi_data *d, maggi_loop_state *state)
{
  state->rank = d->t.ndep;
  state->dof = d->t.nind;
  state->violation = maggi_violation(d);
  state->pivot_ratio = d->pivot_ratio;
  state->changes = d->changes;
  state->projections = d->projections;
  state->evaluations = d->evaluations;
}

int maggi_coordinate_is_independent(const maggi_data *d, int coordinate)
{
  int c;

  if (coordinate < 0 || coordinate >= d->m->ncoordinate || !d->ready) return 0;
  c = d->t.col[d->m->coordinate[coordinate].q];
  return c >= 0 && c < d->t.nind;
}
