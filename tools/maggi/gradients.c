/* Threads, each with a simulation, objectives and part of the parameters of its own. */
#include "gradients.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "interrupt.h"
#include "message.h"
#include "progress.h"
#include "stopwatch.h"

typedef struct worker {
  int first, number; /* its parameters */
  maggi_data *data;
  maggi_design *design;
  objectives objectives;
  maggi_gradient_options options;
  double *value;      /* (objectives)          */
  double *gradient;   /* (objectives x number) */
  progress *progress; /* of the first worker, else NULL */
  atomic_int *stop;   /* shared: one has failed         */
  maggi_status status;
} worker;

static int watch(void *context, double part)
{
  worker *w = context;

  if (w->progress) progress_part(w->progress, stopwatch_now(), part);
  return interrupt_seen() || atomic_load(w->stop);
}

static void *work(void *context)
{
  worker *w = context;

  w->status = maggi_gradient(w->data, w->design, w->objectives.number, w->objectives.objective,
                             &w->options, w->value, w->gradient);
  if (w->status != MAGGI_OK) atomic_store(w->stop, 1);
  return NULL;
}

static void worker_free(worker *w)
{
  objectives_free(&w->objectives);
  maggi_design_free(w->design);
  maggi_data_free(w->data);
  free(w->value);
  free(w->gradient);
}

/* Exit status; worker_free in either case. */
static int worker_init(worker *w, const gradients *g, const study *s, int first, int number)
{
  size_t nobjective = (size_t)s->objectives.number;
  int *index = calloc((size_t)number, sizeof *index);
  int i, status;

  w->first = first;
  w->number = number;
  w->value = calloc(nobjective, sizeof *w->value);
  w->gradient = calloc(nobjective * (size_t)number, sizeof *w->gradient);
  status =
      index && w->value && w->gradient ? STATUS_DONE : message_fail(STATUS_FAILED, "out of memory");
  if (status == STATUS_DONE) status = study_data(s, &w->data);
  if (status == STATUS_DONE)
    status = objectives_create(&w->objectives, s->model, &s->objective_names);
  if (status == STATUS_DONE) {
    for (i = 0; i < number; ++i) index[i] = first + i;
    status = parameters_pick(&s->parameters, w->data, number, index, &w->design);
  }
  free(index);
  w->options = g->options;
  w->options.progress = watch;
  w->options.context = w;
  w->options.relevance = g->relevance ? g->relevance + first : NULL;
  w->options.coordinate = g->coordinate ? g->coordinate + first : NULL;
  return status;
}

/* All workers at once, the first of them in this thread: 0, or -1 when there is no further thread. */
static int work_all(worker *w, int n)
{
  pthread_t *thread = calloc((size_t)n, sizeof *thread);
  int i, started;

  for (started = 1; thread && started < n; ++started)
    if (pthread_create(&thread[started], NULL, work, &w[started]) != 0) break;
  if (started == n)
    work(&w[0]);
  else
    atomic_store(w->stop, 1);
  for (i = 1; i < started && thread; ++i) pthread_join(thread[i], NULL);
  free(thread);
  return started == n ? 0 : -1;
}

/* Exit status of n workers: the first failure that is not that of another one. */
static int outcome(const study *s, const worker *w, int n)
{
  int i, stopped = 0;

  for (i = 0; i < n; ++i) {
    if (w[i].status == MAGGI_E_STOPPED)
      stopped = 1;
    else if (w[i].status != MAGGI_OK)
      return study_fail(s, w[i].data, w[i].status);
  }
  return stopped ? STATUS_INTERRUPTED : STATUS_DONE;
}

static void collect(gradients *g, const study *s, const worker *w)
{
  size_t n = (size_t)s->parameters.number, number = (size_t)w->number;
  int i;

  for (i = 0; i < s->objectives.number; ++i)
    memcpy(g->gradient + (size_t)i * n + (size_t)w->first, w->gradient + (size_t)i * number,
           number * sizeof *g->gradient);
}

static int run_workers(gradients *g, const study *s, worker *w, int n)
{
  progress p;
  stopwatch clock;
  int i, status = STATUS_DONE;

  progress_begin(&p, 1);
  w[0].progress = &p;
  stopwatch_start(&clock);
  while (status == STATUS_DONE && stopwatch_again(&clock)) {
    if (work_all(w, n)) status = message_fail(STATUS_FAILED, "--threads: no further thread");
    stopwatch_lap(&clock);
    progress_end(&p);
    if (status == STATUS_DONE) status = outcome(s, w, n);
  }
  if (status != STATUS_DONE) return status;
  for (i = 0; i < n; ++i) collect(g, s, &w[i]);
  memcpy(g->value, w[0].value, (size_t)s->objectives.number * sizeof *g->value);
  g->options = w[0].options;
  g->wall = clock.best;
  return STATUS_DONE;
}

int gradients_run(gradients *g, const study *s)
{
  int number = s->parameters.number, status = STATUS_DONE, first, i, n;
  atomic_int stop;
  worker *w;

  atomic_init(&stop, 0);
  n = g->threads < number ? g->threads : number;
  w = calloc((size_t)n, sizeof *w);
  if (!w) return message_fail(STATUS_FAILED, "out of memory");
  for (i = first = 0; i < n && status == STATUS_DONE; first += w[i++].number) {
    w[i].stop = &stop;
    status = worker_init(&w[i], g, s, first, (number - first) / (n - i));
  }
  if (status == STATUS_DONE) status = run_workers(g, s, w, n);
  for (i = 0; i < n; ++i) worker_free(&w[i]);
  free(w);
  g->threads = n;
  return status;
}
