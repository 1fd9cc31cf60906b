/* Tangents along MAGGI_NDIR directions at once. */
#include "implicit.h"

#define MODE(f) f##_dv
#define WITH(x) (void *)d->x, (void *)s->x
#define LAST    , MAGGI_NDIR
#define WIDTH   MAGGI_NDIR
#include "stages.h"
/* after the stages that it calls */
#include "forward.h"

void maggi_strip_constants(maggi_derivative *D)
{
  forward_constants(D, &D->strip);
}

void maggi_strip_closure(maggi_derivative *D)
{
  const maggi_companion *s = &D->strip;
  const maggi_topo *t = &D->d->t;
  int i;

  if (t->ndep == 0) return;
  for (i = 0; i < t->ndep; ++i) zero(s->q + t->dep[i] * WIDTH);
  forward_positions(D, s);
  loop_residual(D, s);
  maggi_close_dv(D, -1.0, NULL, s->res, NULL, s->q);
}

void maggi_strip_rolling(maggi_derivative *D)
{
  const maggi_companion *s = &D->strip;
  const maggi_topo *t = &D->d->t;
  int i, c;

  rolling(D, s);
  for (i = 0; i < t->nwheel; ++i)
    for (c = 0; c < WIDTH; ++c) s->v[t->qid[t->wheelbody[i]] * WIDTH + c] = s->spin[i * WIDTH + c];
}

void maggi_strip_motion(maggi_derivative *D)
{
  forward(D, &D->strip);
}
