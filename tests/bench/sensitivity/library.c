/* maggi_gradient in its methods. */
#define _POSIX_C_SOURCE 200809L

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "ways.h"

typedef struct workspace {
  const study *of;
  maggi_design *design;
} workspace;

int complain(const char *what, const char *why)
{
  fprintf(stderr, "bench-sensitivity: %s: %s\n", what, why);
  return 0;
}

maggi_design *study_design(const study *of, const maggi_data *d, int first, int n)
{
  maggi_design *design;
  maggi_design_def def;
  maggi_status status;
  char message[256];
  const char *path;
  int i;

  if (maggi_design_create(d, &design) != MAGGI_OK) return NULL;
  status = n == ALL ? maggi_design_select(design, "all", message, sizeof message) : MAGGI_OK;
  for (i = 0; i < n && status == MAGGI_OK; ++i) {
    if (of->design) {
      status = maggi_design_select(design, of->design[first + i], message, sizeof message);
      continue;
    }
    path = maggi_parameter_path(of->m, of->parameter[first + i]);
    maggi_design_def_init(&def);
    def.name = path;
    def.number = 1;
    def.paths = &path;
    status = maggi_design_add(design, &def, message, sizeof message);
  }
  if (status == MAGGI_OK) return design;
  complain("design parameters", message);
  maggi_design_free(design);
  return NULL;
}

static void *open_workspace(const study *of, int n)
{
  workspace *m = calloc(1, sizeof *m);

  if (!m) return NULL;
  m->of = of;
  m->design = study_design(of, of->d, 0, n);
  if (m->design) return m;
  free(m);
  return NULL;
}

static void close_workspace(void *self)
{
  workspace *m = self;

  maggi_design_free(m->design);
  free(m);
}

static int compute(const study *of, maggi_data *d, const maggi_design *design,
                   maggi_objective *objective, maggi_method method, int steps, double *gradient)
{
  maggi_gradient_options options;
  double value;

  maggi_gradient_options_init(&options);
  options.time = steps * of->step;
  options.step = of->step;
  options.method = method;
  if (maggi_gradient(d, design, 1, &objective, &options, &value, gradient) == MAGGI_OK) return 1;
  return complain(maggi_method_name(method), maggi_data_message(d));
}

static int gradient_by(const workspace *m, maggi_method method, int steps, double *gradient)
{
  return compute(m->of, m->of->d, m->design, m->of->objective, method, steps, gradient);
}

static int direct(void *self, int steps, double *gradient)
{
  return gradient_by(self, MAGGI_METHOD_DIRECT, steps, gradient);
}

static int adjoint(void *self, int steps, double *gradient)
{
  return gradient_by(self, MAGGI_METHOD_ADJOINT, steps, gradient);
}

static int continuous(void *self, int steps, double *gradient)
{
  return gradient_by(self, MAGGI_METHOD_CONTINUOUS_ADJOINT, steps, gradient);
}

static int differences(void *self, int steps, double *gradient)
{
  return gradient_by(self, MAGGI_METHOD_DIFFERENCE, steps, gradient);
}

static int forward(void *self, int steps, double *gradient)
{
  return gradient_by(self, MAGGI_METHOD_FORWARD_DIFFERENCE, steps, gradient);
}

/* ---------------------------------------------------------------------------- threads */

enum { THREADS_MOST = 16 };

/* one thread: simulation, design parameters from `first` on and objective of its own */
typedef struct part {
  const study *of;
  pthread_t thread;
  maggi_data *d;
  maggi_design *design;
  maggi_objective *objective;
  int first, n, steps, ok;
  double *gradient;
} part;

typedef struct team {
  int number;
  part part[THREADS_MOST];
} team;

static int open_part(part *p, const study *of, int first, int n)
{
  char message[256];

  *p = (part){.of = of, .first = first, .n = n};
  if (maggi_data_create(of->m, &p->d) != MAGGI_OK) return 0;
  p->design = study_design(of, p->d, first, n);
  return p->design &&
         maggi_objective_named(of->m, of->name, &p->objective, message, sizeof message) == MAGGI_OK;
}

static void close_team(void *self)
{
  team *m = self;
  int i;

  for (i = 0; i < m->number; ++i) {
    maggi_objective_free(m->part[i].objective);
    maggi_design_free(m->part[i].design);
    maggi_data_free(m->part[i].d);
  }
  free(m);
}

static void *open_team(const study *of, int n)
{
  team *m = calloc(1, sizeof *m);
  int i, threads = (int)sysconf(_SC_NPROCESSORS_ONLN);

  if (!m) return NULL;
  if (threads > THREADS_MOST) threads = THREADS_MOST;
  for (i = 0; i < threads; ++i) {
    m->number = i + 1;
    if (open_part(&m->part[i], of, i * n / threads, (i + 1) * n / threads - i * n / threads))
      continue;
    close_team(m);
    return NULL;
  }
  return m;
}

static void *work(void *argument)
{
  part *p = argument;

  p->ok = compute(p->of, p->d, p->design, p->objective, MAGGI_METHOD_DIRECT, p->steps,
                  p->gradient + p->first);
  return NULL;
}

static int direct_in_threads(void *self, int steps, double *gradient)
{
  team *m = self;
  int i, ok = 1;

  for (i = 0; i < m->number; ++i) {
    m->part[i].steps = steps;
    m->part[i].gradient = gradient;
    m->part[i].ok = 0;
    if (pthread_create(&m->part[i].thread, NULL, work, &m->part[i]) != 0) break;
  }
  while (i-- > 0) pthread_join(m->part[i].thread, NULL);
  for (i = 0; i < m->number; ++i) ok = ok && m->part[i].ok;
  return ok;
}

#define LIBRARY open_workspace, close_workspace

const way way_direct = {"direct", LIBRARY, direct, NULL, 0, 0, 1e-9};
const way way_adjoint = {"adjoint", LIBRARY, adjoint, NULL, 0, 0, 0.0};
const way way_continuous = {"continuous adjoint", LIBRARY, continuous, NULL, 0, 0, 1e-6};
const way way_differences = {"centred differences", LIBRARY, differences, NULL, 0, 0, 1e-5};
const way way_forward = {"forward differences", LIBRARY, forward, NULL, 0, 0, 1e-3};
const way way_threads = {
    "direct, all processors", open_team, close_team, direct_in_threads, NULL, 0, 1, 1e-9};
