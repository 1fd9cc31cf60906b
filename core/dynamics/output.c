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
  for (i = 0; i < d->m->ncolumn; ++i) {
    k = d->m->sensorplace[i];
    values[i] = d->sensor[k / 3][k % 3];
  }
}

void maggi_get_filters(maggi_data *d, double *values)
{
  int i;

  maggi_results(d);
  for (i = 0; i < d->t.nfilter; ++i) values[i] = d->weighted[i];
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
  int i, k;

  maggi_results(d);
  for (i = 0; i < d->m->nbody; ++i)
    for (k = 0; k < 6; ++k) wrenches[6 * i + k] = d->wrench[d->m->body[i].body][k];
}

void maggi_get_multipliers(maggi_data *d, double *lambda)
{
  int i;

  maggi_results(d);
  for (i = 0; i < d->t.nrow; ++i) lambda[i] = d->lambda[i];
}

void maggi_get_energy(maggi_data *d, maggi_energy *energy)
{
  maggi_kinetic_energy(&d->t, d->p, (void *)d->I, (void *)d->Z, (void *)d->rv, d->kinetic);
  maggi_potential_energy(&d->t, d->p, d->origin, (void *)d->body0, d->spring0, d->q, (void *)d->A,
                         (void *)d->x, (void *)d->r, d->potential);
  energy->kinetic = d->kinetic[0];
  energy->potential = d->potential[0];
  energy->work = d->work;
}

/* what maggi_results and maggi_get_energy have computed, or the state itself */
static double signal_value(const maggi_data *d, maggi_signal_place s)
{
  switch (s.kind) {
  case MAGGI_SIGNAL_POSITION:
    return d->q[s.index];
  case MAGGI_SIGNAL_VELOCITY:
    return d->v[s.index];
  case MAGGI_SIGNAL_ACCELERATION:
    return d->a[s.index];
  case MAGGI_SIGNAL_KINETIC:
    return d->kinetic[0];
  case MAGGI_SIGNAL_POTENTIAL:
    return d->potential[0];
  case MAGGI_SIGNAL_TOTAL:
    return d->kinetic[0] + d->potential[0];
  case MAGGI_SIGNAL_WRENCH:
    return d->wrench[s.index / 6][s.index % 6];
  case MAGGI_SIGNAL_FILTER:
    return d->weighted[s.index];
  default:
    return d->sensor[s.index / 3][s.index % 3];
  }
}

void maggi_get_signals(maggi_data *d, int n, const int *signal, double *values)
{
  maggi_signal_place s;
  maggi_energy energy;
  int i, has_energy = 0;

  for (i = 0; i < n; ++i) {
    s = maggi_signal_at(d->m, signal[i]);
    if (s.kind >= MAGGI_SIGNAL_WRENCH)
      maggi_results(d);
    else if (s.kind >= MAGGI_SIGNAL_KINETIC && !has_energy++)
      maggi_get_energy(d, &energy);
    values[i] = signal_value(d, s);
  }
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
  if (coordinate < 0 || coordinate >= d->m->ncoordinate || !d->ready) return 0;
  return maggi_is_independent(&d->t, d->m->coordinate[coordinate].q);
}
