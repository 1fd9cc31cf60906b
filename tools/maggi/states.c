/* Columns d(SIGNAL)/d(PARAMETER): signals in order, the parameters of each together. */
#include "states.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "interrupt.h"
#include "message.h"
#include "progress.h"
#include "stopwatch.h"

typedef struct states {
  const study *study;
  maggi_direct *direct;
  table *table;
  int nsignal;
  int *signal;   /* wanted          (nsignal)              */
  double *value; /* of the present  (nsignal x parameters) */
} states;

static int is_there(const states *w, int signal)
{
  int i;

  for (i = 0; i < w->nsignal && w->signal[i] != signal; ++i)
    ;
  return i < w->nsignal;
}

/* Positions, velocities and accelerations are the first signals. */
static int choose_signals(states *w)
{
  const objectives *o = &w->study->objectives;
  const int *own;
  int i, k, n;

  w->signal = calloc((size_t)maggi_signal_number(w->study->model) + 1, sizeof *w->signal);
  if (!w->signal) return -1;
  for (i = 0; i < 3 * w->study->info.coordinates; ++i) w->signal[w->nsignal++] = i;
  for (i = 0; i < o->number; ++i) {
    n = maggi_objective_signals(o->objective[i], &own);
    for (k = 0; k < n; ++k)
      if (!is_there(w, own[k])) w->signal[w->nsignal++] = own[k];
  }
  w->value = calloc((size_t)w->nsignal * (size_t)w->study->parameters.number + 1, sizeof *w->value);
  return w->value ? 0 : -1;
}

static void write_header(states *w)
{
  const parameters *p = &w->study->parameters;
  char title[1024];
  int i, k;

  table_title(w->table, "t", NULL);
  for (i = 0; i < w->nsignal; ++i)
    for (k = 0; k < p->number; ++k) {
      snprintf(title, sizeof title, "d(%s)/d(%s)", maggi_signal_name(w->study->model, w->signal[i]),
               maggi_design_name(p->design, k));
      table_title(w->table, title, NULL);
    }
  table_end_header(w->table);
}

static void write_row(states *w)
{
  int i, n = w->nsignal * w->study->parameters.number;

  maggi_direct_get_signals(w->direct, w->nsignal, w->signal, w->value);
  table_number(w->table, maggi_get_time(w->study->data));
  for (i = 0; i < n; ++i) table_number(w->table, w->value[i]);
  table_end_row(w->table);
}

static maggi_status simulate(states *w, long every)
{
  const maggi_grid *grid = &w->study->grid;
  maggi_status status;
  progress p;
  double t = 0.0, next;
  long k;

  status = maggi_direct_reset(w->direct);
  if (status == MAGGI_OK) write_row(w);
  progress_begin(&p, 1);
  for (k = 1; k <= grid->steps && status == MAGGI_OK && !table_has_failed(w->table); ++k) {
    next = maggi_grid_time(grid, k);
    status = interrupt_seen() ? MAGGI_E_STOPPED : maggi_direct_step(w->direct, next - t);
    t = next;
    if (status == MAGGI_OK && (k % every == 0 || k == grid->steps)) write_row(w);
    progress_part(&p, stopwatch_now(), (double)k / (double)grid->steps);
  }
  progress_end(&p);
  return status;
}

int states_write(const study *s, table *t, long every)
{
  maggi_status status = MAGGI_E_MEMORY;
  states w;
  int result;

  memset(&w, 0, sizeof w);
  w.study = s;
  w.table = t;
  if (choose_signals(&w) == 0)
    status = maggi_direct_create(s->data, s->parameters.design, &w.direct);
  if (status == MAGGI_OK) {
    write_header(&w);
    status = simulate(&w, every);
    result = status == MAGGI_OK ? STATUS_DONE : study_fail(s, s->data, status);
  } else {
    result = message_fail(STATUS_FAILED, "%s: %s", s->want->model, maggi_status_text(status));
  }
  maggi_direct_free(w.direct);
  free(w.signal);
  free(w.value);
  return result;
}
