/* Bodies that nothing but accelerations moves: a copy of a simulation and of its derivatives in
 * which what depends on motion has a place of its own. */
#include <stdlib.h>
#include <string.h>

#include "chain.h"

/* the arrays of its own: name, numbers; those before `a` stay zero */
#define REST_LIST(X)                                                                               \
  X(Z, (t->nbody + 1) * 6)                                                                         \
  X(Z0, (t->nbody + 1) * 6)                                                                        \
  X(rv, t->npoint * 3)                                                                             \
  X(Q, (t->nbody + 1) * 6)                                                                         \
  X(tau, t->nq)                                                                                    \
  X(a, t->nq)                                                                                      \
  X(Wa, (t->nbody + 1) * 6)                                                                        \
  X(Za, (t->nbody + 1) * 6)                                                                        \
  X(ra, t->npoint * 3)                                                                             \
  X(lambda, t->nrow)                                                                               \
  X(Fr, (t->nbody + 1) * 6)                                                                        \
  X(FSr, (t->nbody + 1) * 6)                                                                       \
  X(w, t->nq)

static size_t block(int numbers)
{
  return ((size_t)numbers + 7) / 8 * 8;
}

static size_t size_of(const maggi_topo *t)
{
  size_t n = 0;

#define X(name, numbers) n += block(numbers);
  REST_LIST(X)
#undef X
  return n;
}

/* from `at` on, `width` numbers for one */
static void place_companion(maggi_companion *s, const maggi_topo *t, double *at)
{
#define X(name, numbers)                                                                           \
  s->name = at;                                                                                    \
  at += block(numbers) * (size_t)s->width;
  REST_LIST(X)
#undef X
}

static void place_data(maggi_data *d, double *at)
{
  const maggi_topo *t = &d->t;

#define X(name, numbers)                                                                           \
  d->name = (void *)at;                                                                            \
  at += block(numbers);
  REST_LIST(X)
#undef X
}

maggi_status maggi_rest_create(maggi_data *d, const maggi_derivative *D, maggi_rest *rest)
{
  size_t n = size_of(&d->t), width = D ? (size_t)D->strip.width : 0, all = n * (2 + width);

  memset(rest, 0, sizeof *rest);
  rest->memory = aligned_alloc(64, (all + 8) * sizeof(double));
  if (!rest->memory) return MAGGI_E_MEMORY;
  memset(rest->memory, 0, all * sizeof(double));
  rest->data = *d;
  if (D) {
    rest->strip = D->strip;
    rest->adjoint = D->adjoint;
    place_companion(&rest->strip, &d->t, rest->memory);
    place_companion(&rest->adjoint, &d->t, rest->memory + n * width);
  }
  place_data(&rest->data, rest->memory + n * (width + 1));
  return MAGGI_OK;
}

void maggi_rest_free(maggi_rest *rest)
{
  free(rest->memory);
}

void maggi_rest_evaluate(maggi_rest *rest)
{
  maggi_chain_balance(&rest->data);
}

/* the constants of the companion at work */
static void follow(maggi_companion *s, const maggi_companion *of)
{
#define X(name, numbers) s->name = of->name;
  MAGGI_ACTIVE_CONSTANTS(X)
#undef X
}

void maggi_rest_choose(maggi_derivative *D, maggi_rest *rest)
{
  follow(&rest->strip, &D->strip);
  follow(&rest->adjoint, &D->adjoint);
}

void maggi_rest_clear(maggi_rest *rest)
{
  memset(rest->adjoint.Z, 0, size_of(&rest->data.t) * sizeof(double));
}
