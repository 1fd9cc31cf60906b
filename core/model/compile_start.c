/* How a simulation starts: coordinates held, wheels that roll, and the static twin of a model, whose
 * accelerations at rest vanish in equilibrium: the same parameters, bodies and elements under other
 * integers.  Functions are held, held coordinates are guided by their initial positions, wheels have
 * but their vertical springs. */
#include <stdlib.h>
#include <string.h>

#include "compile.h"

/* lists of the topology that the twin has for itself */
#define TWIN_LIST(X)                                                                               \
  X(qguide)                                                                                        \
  X(wheelgrip)                                                                                     \
  X(funkind)                                                                                       \
  X(funadr)                                                                                        \
  X(funn)                                                                                          \
  X(funspline)                                                                                     \
  X(funheld)

static maggi_status hold(maggi_compile *c, const char *name)
{
  maggi_model *m = c->m;
  int i, k;

  for (i = 0; i < m->ncoordinate && strcmp(m->coordinate[i].name, name) != 0; ++i)
    ;
  if (i < m->ncoordinate) {
    m->hold[m->nhold++] = m->coordinate[i].q;
    return MAGGI_OK;
  }
  k = maggi_compile_body(c, name);
  if (k < 0)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL, "start.hold: coordinate \"%s\" does not exist",
                              name);
  if (c->b->body[k].joint == MAGGI_JOINT_FIXED)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL,
                              "start.hold: \"%s\" has a fixed joint, without a coordinate", name);
  for (i = 0; i < maggi_joint_dof(c->b->body[k].joint); ++i)
    m->hold[m->nhold++] = m->coordinate[m->body[k].coordinate + i].q;
  return MAGGI_OK;
}

/* the body of a wheel turns on its carrier, about its own coordinate and for no other wheel */
static maggi_status check_rolling(const maggi_compile *c, int wheel)
{
  const maggi_topo *t = c->t;
  const char *name = c->b->wheel[wheel].name;
  int body = t->wheelbody[wheel], q = t->qid[body], i;

  if (t->joint[body] != MAGGI_ONE_REVOLUTE || t->parent[body] != t->wheelcarrier[wheel])
    return maggi_builder_fail(c->b, MAGGI_E_MODEL,
                              "wheels.%s: a wheel that starts rolling needs a body that turns on "
                              "its carrier by a revolute joint",
                              name);
  if (t->qguide[q] >= 0 || c->m->reach[q] > 0)
    return maggi_builder_fail(c->b, MAGGI_E_MODEL,
                              "wheels.%s: a wheel that starts rolling cannot be guided or be part "
                              "of a loop",
                              name);
  for (i = 0; i < wheel; ++i)
    if (t->wheelbody[i] == body)
      return maggi_builder_fail(c->b, MAGGI_E_MODEL,
                                "wheels.%s: of two wheels on one body only one can start rolling",
                                name);
  return MAGGI_OK;
}

maggi_status maggi_compile_start(maggi_compile *c)
{
  const maggi_start_def *d = &c->b->start;
  maggi_model *m = c->m;
  maggi_status status = MAGGI_OK;
  int i;

  m->rolling = d->rolling != 0;
  m->hold =
      maggi_arena_alloc(&m->arena, ((size_t)d->nhold * MAGGI_JOINT_DOF_MAX + 1) * sizeof *m->hold);
  if (!m->hold) return MAGGI_E_MEMORY;
  for (i = 0; i < d->nhold && status == MAGGI_OK; ++i) status = hold(c, d->hold[i]);
  for (i = 0; i < c->t->nwheel && m->rolling && status == MAGGI_OK; ++i)
    status = check_rolling(c, i);
  return status == MAGGI_OK && d->equilibrium ? maggi_twin_create(m) : status;
}

static int *copy(const int *from, int n, int more)
{
  int *to = calloc((size_t)(n + more) + 1, sizeof *to);

  if (to && n > 0) memcpy(to, from, (size_t)n * sizeof *to);
  return to;
}

/* a constant function that guides a coordinate to its initial position */
static void hold_coordinate(maggi_model *twin, int q)
{
  maggi_topo *t = &twin->topo;

  if (t->qguide[q] >= 0) return;
  t->qguide[q] = t->nfun;
  t->funkind[t->nfun] = MAGGI_FUNCTION_CONSTANT;
  t->funadr[t->nfun] = twin->initial_position[q];
  t->funn[t->nfun] = 1;
  ++t->nfun;
  ++t->nguide;
}

maggi_status maggi_twin_create(maggi_model *m)
{
  maggi_model *twin = calloc(1, sizeof *twin);
  maggi_topo *t;
  int i;

  if (!twin) return MAGGI_E_MEMORY;
  *twin = *m;
  twin->twin = NULL;
  twin->rolling = 0;
  t = &twin->topo;
  t->qguide = copy(m->topo.qguide, t->nq, 0);
  t->wheelgrip = copy(NULL, 0, t->nwheel);
  t->funkind = copy(m->topo.funkind, t->nfun, m->nhold);
  t->funadr = copy(m->topo.funadr, t->nfun, m->nhold);
  t->funn = copy(m->topo.funn, t->nfun, m->nhold);
  t->funspline = copy(m->topo.funspline, t->nfun, m->nhold);
  t->funheld = copy(NULL, 0, t->nfun + m->nhold);
  m->twin = twin;
#define X(name)                                                                                    \
  if (!t->name) return MAGGI_E_MEMORY;
  TWIN_LIST(X)
#undef X
  for (i = 0; i < t->nfun; ++i) t->funheld[i] = 1;
  for (i = 0; i < m->nhold; ++i) hold_coordinate(twin, m->hold[i]);
  return MAGGI_OK;
}

void maggi_twin_free(maggi_model *twin)
{
  if (!twin) return;
#define X(name) free(twin->topo.name);
  TWIN_LIST(X)
#undef X
  free(twin);
}
