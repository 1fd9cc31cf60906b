#include "simulation.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "timing.h"

const way ways[] = {
    {"difference", MAGGI_JACOBIAN_DIFFERENCE, 0, 1e-6, THESIS_ND},
    {"difference-coloured", MAGGI_JACOBIAN_DIFFERENCE_COLOURED, 0, 1e-6, -1},
    {"tangent", MAGGI_JACOBIAN_TANGENT, 0, 1e-9, THESIS_ADIC2_FORWARD},
    {"tangent-coloured", MAGGI_JACOBIAN_TANGENT_COLOURED, 0, 1e-9, THESIS_ADIC2_SPARSE},
    {"adjoint", MAGGI_JACOBIAN_ADJOINT, 0, 1e-9, THESIS_ADOLC_REVERSE},
#ifdef BENCH_ADOLC
    {"adolc", MAGGI_JACOBIAN_DIFFERENCE, 1, 1e-9, THESIS_ADOLC_FORWARD},
    {"adolc-sparse", MAGGI_JACOBIAN_DIFFERENCE_COLOURED, 1, 1e-9, THESIS_ADOLC_SPARSE},
#endif
};
const int nway = sizeof ways / sizeof ways[0], nlibrary = 5, reference = 3;

int complain(const char *what, const char *why)
{
  fprintf(stderr, "bench-derivatives: %s: %s\n", what, why);
  return 0;
}

/* ------------------------------------------------------------------------------- ADOL-C */

/* stands in for the Jacobian of the library, which lends it its memory */
typedef struct taped {
  maggi_force_jacobian base;
  maggi_force_jacobian *library;
  chain_tape *recorded;
  int directions;
  double *x;       /* (2 n) */
  double *seed;    /* (2 n x directions) */
  double *product; /* (n x directions) */
} taped;

#ifdef BENCH_ADOLC
static void by_tape(maggi_force_jacobian *j, double time)
{
  taped *m = (taped *)j;
  const maggi_pattern *pattern = j->pattern;
  const maggi_sparsity *J = &pattern->J;
  int c, k, n = pattern->n;

  maggi_chain_forces(j->d, time);
  for (k = 0; k < n; ++k) {
    m->x[k] = j->d->q[pattern->q[k]];
    m->x[n + k] = j->d->v[pattern->q[k]];
  }
  tape_product(m->recorded, m->x, m->directions, m->seed, m->product);
  if (j->colouring) {
    maggi_colour_recover(J, j->colouring, 0, m->directions, m->product, j->value);
    return;
  }
  for (c = 0; c < J->ncol; ++c)
    for (k = J->coladr[c]; k < J->coladr[c + 1]; ++k)
      j->value[k] = m->product[(size_t)J->row[k] * (size_t)J->ncol + (size_t)c];
}

static int stand_in(simulation *x, chain_tape *recorded)
{
  taped *m = calloc(1, sizeof *m);
  maggi_force_jacobian *j = x->s->jacobian;
  size_t c, n = (size_t)j->pattern->n, directions;

  if (!m) return 0;
  x->taped = m;
  m->base = *j;
  m->base.compute = by_tape;
  m->library = j;
  m->recorded = recorded;
  x->s->jacobian = &m->base;
  m->directions = j->colouring ? j->colouring->ncolour : j->pattern->J.ncol;
  directions = (size_t)m->directions;
  m->x = malloc(2 * n * sizeof(double));
  m->seed = calloc(2 * n * directions, sizeof(double));
  m->product = malloc(n * directions * sizeof(double));
  if (!m->x || !m->seed || !m->product) return 0;
  for (c = 0; c < 2 * n; ++c)
    m->seed[c * directions + (j->colouring ? (size_t)j->colouring->colour[c] : c)] = 1.0;
  return 1;
}

chain_tape *simulation_record(const simulation *x)
{
  const maggi_data *d = x->d;
  const maggi_pattern *pattern = x->s->jacobian->pattern;
  const chain_state at = {&d->t, d->m->originadr, d->p, d->q, d->v, pattern->n, pattern->q};

  return d->t.nfun == 0 ? tape_record(&at) : NULL;
}
#else
static int stand_in(simulation *x, chain_tape *recorded)
{
  (void)x, (void)recorded;
  return 0;
}

chain_tape *simulation_record(const simulation *x)
{
  (void)x;
  return NULL;
}
#endif

/* --------------------------------------------------------------------------- simulation */

int simulation_open(simulation *x, const way *of, const maggi_model *m, chain_tape *recorded)
{
  maggi_penalty_options options;

  memset(x, 0, sizeof *x);
  x->of = of;
  maggi_penalty_options_init(&options);
  options.jacobian = of->library;
  if (maggi_data_create(m, &x->d) != MAGGI_OK) return complain(of->name, "out of memory");
  if (maggi_data_reset(x->d) != MAGGI_OK || maggi_penalty_create(x->d, &options, &x->s) != MAGGI_OK)
    return complain(of->name, maggi_data_message(x->d));
  return !of->is_taped || stand_in(x, recorded) || complain(of->name, "out of memory");
}

void simulation_close(simulation *x)
{
  taped *m = x->taped;

  if (m) {
    x->s->jacobian = m->library;
    free(m->x);
    free(m->seed);
    free(m->product);
    free(m);
  }
  maggi_penalty_free(x->s);
  maggi_data_free(x->d);
}

int simulation_coordinates(const simulation *x)
{
  return x->s->jacobian->pattern->n;
}

int simulation_directions(const simulation *x)
{
  const maggi_colouring *c = x->s->jacobian->colouring;
  int n = simulation_coordinates(x);

  if (x->of->library == MAGGI_JACOBIAN_ADJOINT) return n;
  return c ? c->ncolour : 2 * n;
}

size_t simulation_state_size(const simulation *x)
{
  return 1 + 2 * (size_t)x->d->t.nq;
}

static void keep(const simulation *x, double *state)
{
  size_t nq = (size_t)x->d->t.nq;

  state[0] = x->d->time;
  memcpy(state + 1, x->d->q, nq * sizeof(double));
  memcpy(state + 1 + nq, x->d->v, nq * sizeof(double));
}

const double *simulation_jacobian(simulation *x, const double *state)
{
  size_t nq = (size_t)x->d->t.nq;

  memcpy(x->d->q, state + 1, nq * sizeof(double));
  memcpy(x->d->v, state + 1 + nq, nq * sizeof(double));
  maggi_force_jacobian_compute(x->s->jacobian, state[0]);
  return x->s->jacobian->value;
}

static double total(maggi_data *d)
{
  maggi_energy e;

  maggi_get_energy(d, &e);
  return e.kinetic + e.potential - e.work;
}

int simulation_run(simulation *x, double h, int steps, course *c)
{
  return simulation_follow(x, h, steps, c, -1, NULL);
}

int simulation_follow(simulation *x, double h, int steps, course *c, int n, double *states)
{
  maggi_status status = maggi_penalty_reset(x->s);
  maggi_penalty_state count;
  double begin, first = 0.0, change;
  int i, k = 0;

  c->steps = steps;
  c->drift = 0.0;
  if (status == MAGGI_OK && n >= 0) first = total(x->d);
  begin = cpu_seconds();
  for (i = 1; i <= steps && status == MAGGI_OK; ++i) {
    status = maggi_penalty_step(x->s, h);
    if (n < 0) continue;
    change = (total(x->d) - first) / fabs(first);
    if (!(fabs(change) <= fabs(c->drift))) c->drift = change;
    for (; k < n && (k + 1) * (long)steps <= i * (long)n; ++k)
      keep(x, states + (size_t)k * simulation_state_size(x));
  }
  c->seconds = cpu_seconds() - begin;
  maggi_penalty_get_state(x->s, &count);
  c->jacobians = count.jacobians;
  c->iterations = count.iterations;
  return status == MAGGI_OK || complain(x->of->name, maggi_data_message(x->d));
}
