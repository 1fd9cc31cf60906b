/* Signals and what they need. */
#include "results.h"

static unsigned need_of_sensor(int need)
{
  return MAGGI_RESULT_SENSOR | (need & MAGGI_NEED_ACCELERATION ? MAGGI_RESULT_ACCELERATION : 0u) |
         (need & MAGGI_NEED_MULTIPLIER ? MAGGI_RESULT_FORCE : 0u);
}

unsigned maggi_signals_need(const maggi_model *m, int n, const int *signal)
{
  maggi_signal_place place;
  unsigned need = 0;
  int i;

  for (i = 0; i < n; ++i) {
    place = maggi_signal_at(m, signal[i]);
    if (place.kind == MAGGI_SIGNAL_SENSOR)
      need |= need_of_sensor(m->topo.sensorneed[place.index / 3]);
    else if (place.kind == MAGGI_SIGNAL_FILTER)
      need |= MAGGI_RESULT_FILTER;
    else if (place.kind == MAGGI_SIGNAL_WRENCH)
      need |= MAGGI_RESULT_FORCE;
    else if (place.kind >= MAGGI_SIGNAL_KINETIC)
      need |= MAGGI_RESULT_ENERGY;
  }
  return need;
}

unsigned maggi_filters_need(const maggi_model *m)
{
  unsigned need = 0;
  int i;

  for (i = 0; i < m->topo.nfilter; ++i)
    need |= MAGGI_RESULT_RATE | need_of_sensor(m->topo.sensorneed[m->topo.filtersensor[i]]);
  return need;
}

/* derivatives of a signal, or of the first part of one; *second: of the other part, NULL if none */
static double *numbers_of(const maggi_companion *s, maggi_signal_place place, double **second)
{
  *second = NULL;
  switch (place.kind) {
  case MAGGI_SIGNAL_POSITION:
    return s->q + place.index * s->width;
  case MAGGI_SIGNAL_VELOCITY:
    return s->v + place.index * s->width;
  case MAGGI_SIGNAL_ACCELERATION:
    return s->a + place.index * s->width;
  case MAGGI_SIGNAL_KINETIC:
    return s->kinetic;
  case MAGGI_SIGNAL_POTENTIAL:
    return s->potential;
  case MAGGI_SIGNAL_TOTAL:
    *second = s->potential;
    return s->kinetic;
  case MAGGI_SIGNAL_WRENCH:
    return s->wrench + place.index * s->width;
  case MAGGI_SIGNAL_FILTER:
    return s->weighted + place.index * s->width;
  default:
    return s->sensor + place.index * s->width;
  }
}

void maggi_signals_strip(const maggi_derivative *D, int n, const int *signal, double *out)
{
  enum { W = MAGGI_NDIR };
  const double *x;
  double *second;
  int i, c;

  for (i = 0; i < n; ++i) {
    x = numbers_of(&D->strip, maggi_signal_at(D->d->m, signal[i]), &second);
    for (c = 0; c < W; ++c) out[i * W + c] = x[c] + (second ? second[c] : 0.0);
  }
}

void maggi_signals_seed(maggi_derivative *D, int n, const int *signal, const double *weight)
{
  double *second;
  int i;

  for (i = 0; i < n; ++i) {
    *numbers_of(&D->adjoint, maggi_signal_at(D->d->m, signal[i]), &second) += weight[i];
    if (second) *second += weight[i];
  }
}
