/* Signals: coordinates, energies, reactions and sensors as one list. */
#include <string.h>

#include "compile.h"

static const char *const rate[] = {"q", "v", "a"};
static const char *const angle_unit[] = {"rad", "rad/s", "rad/s^2"};
static const char *const length_unit[] = {"m", "m/s", "m/s^2"};
static const char *const energy[] = {"energy.kinetic", "energy.potential", "energy.total"};
static const char *const wrench[] = {"fx", "fy", "fz", "mx", "my", "mz"};

maggi_signal_place maggi_signal_at(const maggi_model *m, int signal)
{
  int i = signal;

  if (i < 3 * m->ncoordinate)
    return (maggi_signal_place){(maggi_signal_kind)(MAGGI_SIGNAL_POSITION + i % 3),
                                m->coordinate[i / 3].q};
  i -= 3 * m->ncoordinate;
  if (i < 3) return (maggi_signal_place){(maggi_signal_kind)(MAGGI_SIGNAL_KINETIC + i), 0};
  i -= 3;
  if (i < 6 * m->nbody)
    return (maggi_signal_place){MAGGI_SIGNAL_WRENCH, 6 * m->body[i / 6].body + i % 6};
  i -= 6 * m->nbody;
  if (i < m->ncolumn) return (maggi_signal_place){MAGGI_SIGNAL_SENSOR, m->sensorplace[i]};
  return (maggi_signal_place){MAGGI_SIGNAL_FILTER, i - m->ncolumn};
}

static void add(maggi_model *m, const char *name, const char *unit)
{
  m->signalname[m->nsignal] = name;
  m->signalunit[m->nsignal++] = unit;
}

/* in the order that maggi_signal_at knows */
maggi_status maggi_compile_signals(maggi_model *m)
{
  size_t n = 3 * (size_t)m->ncoordinate + 3 + 6 * (size_t)m->nbody + (size_t)m->ncolumn +
             (size_t)m->topo.nfilter;
  int i;

  m->signalname = maggi_arena_alloc(&m->arena, n * sizeof *m->signalname);
  m->signalunit = maggi_arena_alloc(&m->arena, n * sizeof *m->signalunit);
  if (!m->signalname || !m->signalunit) return MAGGI_E_MEMORY;
  for (i = 0; i < 3 * m->ncoordinate; ++i)
    add(m, maggi_arena_format(&m->arena, "%s.%s", m->coordinate[i / 3].name, rate[i % 3]),
        m->coordinate[i / 3].is_angle ? angle_unit[i % 3] : length_unit[i % 3]);
  for (i = 0; i < 3; ++i) add(m, energy[i], "J");
  for (i = 0; i < 6 * m->nbody; ++i)
    add(m, maggi_arena_format(&m->arena, "%s.%s", m->body[i / 6].name, wrench[i % 6]),
        i % 6 < 3 ? "N" : "N m");
  for (i = 0; i < m->ncolumn; ++i) add(m, m->sensorcolumn[i], m->sensorunit[i]);
  for (i = 0; i < m->topo.nfilter; ++i) add(m, m->filtercolumn[i], m->filterunit[i]);
  for (i = 0; i < m->nsignal; ++i)
    if (!m->signalname[i]) return MAGGI_E_MEMORY;
  return MAGGI_OK;
}

int maggi_signal_number(const maggi_model *m)
{
  return m->nsignal;
}

const char *maggi_signal_name(const maggi_model *m, int signal)
{
  return signal >= 0 && signal < m->nsignal ? m->signalname[signal] : NULL;
}

const char *maggi_signal_unit(const maggi_model *m, int signal)
{
  return signal >= 0 && signal < m->nsignal ? m->signalunit[signal] : NULL;
}

int maggi_signal_find(const maggi_model *m, const char *name)
{
  int i;

  for (i = 0; i < m->nsignal; ++i)
    if (strcmp(m->signalname[i], name) == 0) return i;
  return -1;
}
