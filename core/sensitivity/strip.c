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

void maggi_strip_motion(maggi_derivative *D)
{
  forward(D, &D->strip);
}
