#include "data.h"

struct reference_motion {
  struct maggi_data data;
  maggi_model model;
};

/* the sizes named in the lists of data.h */
static size_t size_of(const maggi_topo *t, const char *name)
{
  if (strcmp(name, "nbody1") == 0) return (size_t)t->nbody + 1;
  if (strcmp(name, "nqblock") == 0) return (size_t)t->nq + MAGGI_WIDTH;
  if (strcmp(name, "nq16") == 0) return (size_t)t->nq * MAGGI_WIDTH * 2;
#define X(size, text)                                                                              \
  if (strcmp(name, #size) == 0) return (size_t)t->size;
  MAGGI_TOPO_SIZES(X)
#undef X
  fprintf(stderr, "data.h has an array of the size %s\n", name);
  exit(1);
}

static reference_number *numbers(size_t n)
{
  reference_number *a = calloc(n + 1, sizeof *a);

  if (!a) abort();
  return a;
}

reference_motion *reference_motion_create(const maggi_topo *topo, int originadr)
{
  reference_motion *m = calloc(1, sizeof *m);
  maggi_data *d = &m->data;
  const maggi_topo *t = &d->t;
  int i;

  d->m = &m->model;
  d->t = *topo;
  m->model.originadr = originadr;
#define X(name, rows, cols, text) d->name = (void *)numbers(size_of(t, #rows) * cols);
  MAGGI_DATA_LIST(X)
#undef X
#define X(name, size, text) d->name = numbers(size_of(t, #size));
  MAGGI_DATA_VECTORS(X)
#undef X
#define X(name, size, text) d->name = numbers((size_t)(t->size));
  MAGGI_PLAN_VECTORS(X)
#undef X
  for (i = 0; i < t->ncol; ++i) d->R[t->colq[i] * t->stride + i] = 1.0;
  return m;
}

void reference_motion_free(reference_motion *m)
{
  maggi_data *d = &m->data;

#define X(name, rows, cols, text) free(d->name);
  MAGGI_DATA_LIST(X)
#undef X
#define X(name, size, text) free(d->name);
  MAGGI_DATA_VECTORS(X)
  MAGGI_PLAN_VECTORS(X)
#undef X
  free(m);
}

reference_number *reference_motion_array(reference_motion *m, const char *name)
{
#define X(field, rows, cols, text)                                                                 \
  if (strcmp(name, #field) == 0) return (reference_number *)m->data.field;
  MAGGI_DATA_LIST(X)
#undef X
#define X(field, size, text)                                                                       \
  if (strcmp(name, #field) == 0) return m->data.field;
  MAGGI_DATA_VECTORS(X)
#undef X
  return NULL;
}

void reference_motion_stage(reference_motion *m, reference_number time)
{
  maggi_constants(&m->data);
  maggi_evaluate(&m->data, time);
  maggi_evaluate_filters(&m->data);
}

void reference_motion_evaluate(reference_motion *m, reference_number time)
{
  reference_motion_stage(m, time);
  maggi_results(&m->data);
}

void reference_motion_given(reference_motion *m, reference_number time)
{
  maggi_constants(&m->data);
  maggi_evaluate_given(&m->data, time);
  maggi_results(&m->data);
}

/* corrections dq of the dependents; the largest of its parts */
static reference_real newton_step(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  reference_real largest = 0.0L;
  int i;

  for (i = 0; i < t->nrow; ++i) d->gam[i] = -d->res[i];
  maggi_island_vector(t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->b, d->phi, d->chol,
                      d->gam, d->v1, d->y1, d->dq, d->space);
  for (i = 0; i < t->ndep; ++i) {
    largest = fmaxl(largest, fabsl(creall(d->dq[t->dep[i]])));
    largest = fmaxl(largest, fabsl(cimagl(d->dq[t->dep[i]])) / REFERENCE_STEP);
  }
  return largest;
}

int reference_motion_close(reference_motion *m, reference_number time)
{
  maggi_data *d = &m->data;
  reference_real move = INFINITY, before;
  int n, i;

  maggi_constants(d);
  for (n = 0; n < 60; ++n) {
    maggi_evaluate_positions(d, time);
    maggi_evaluate_factors(d);
    before = move;
    move = newton_step(d);
    for (i = 0; i < d->t.ndep; ++i) d->q[d->t.dep[i]] += d->dq[d->t.dep[i]];
    /* down to round-off, where it only trembles */
    if (move < 1e-9L && move >= 0.25L * before) return 1;
    if (move == 0.0L) return 1;
  }
  return 0;
}

void reference_motion_roll(reference_motion *m)
{
  maggi_data *d = &m->data;

  maggi_rolling(&d->t, d->p, (void *)d->spline0, (void *)d->A, (void *)d->b, (void *)d->r,
                (void *)d->Z, d->spin);
}

void reference_motion_energy(reference_motion *m, reference_number energy[2])
{
  maggi_data *d = &m->data;

  maggi_kinetic_energy(&d->t, d->p, (void *)d->I, (void *)d->Z, (void *)d->rv, energy);
  maggi_potential_energy(&d->t, d->p, d->origin, (void *)d->body0, d->spring0, d->q, (void *)d->A,
                         (void *)d->x, (void *)d->r, energy + 1);
}
