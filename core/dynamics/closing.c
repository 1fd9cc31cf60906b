/* Newton's method on the loops moves the dependent coordinates only. */
#include "closing.h"

#include <float.h>
#include <math.h>
#include <string.h>

void maggi_close_step(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  int i;

  for (i = 0; i < t->nrow; ++i) d->gam[i] = -d->res[i];
  maggi_island_vector(t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->b, d->phi, d->chol,
                      d->gam, d->v1, d->y1, d->dq, d->space);
}

void maggi_close_move(maggi_data *d, double factor)
{
  int i;

  for (i = 0; i < d->t.ndep; ++i)
    d->q[d->t.dep[i]] = d->q1[d->t.dep[i]] + factor * d->dq[d->t.dep[i]];
}

double maggi_close_size(const maggi_data *d)
{
  double largest = 0.0;
  int i;

  for (i = 0; i < d->t.ndep; ++i) {
    if (isnan(d->dq[d->t.dep[i]])) return NAN;
    largest = fmax(largest, fabs(d->dq[d->t.dep[i]]));
  }
  return largest;
}

void maggi_close_begin(maggi_data *d)
{
  memcpy(d->q1, d->q, (size_t)d->t.nq * sizeof(double));
}

const char *maggi_loop_word(const maggi_data *d, int loop)
{
  return strcmp(d->m->loop[loop].kind, "rod") == 0 ? "rod" : "loop";
}

const char *maggi_name_of(const maggi_data *d, int q)
{
  int i;

  for (i = 0; i < d->m->ncoordinate; ++i)
    if (d->m->coordinate[i].q == q) return d->m->coordinate[i].name;
  return "";
}

/* at least 1 */
double maggi_largest_length(const maggi_data *d)
{
  double largest = 1.0;
  int i, k;

  for (i = 0; i < d->t.npointdyn; ++i)
    for (k = 0; k < 3; ++k) largest = fmax(largest, fabs(d->r[i][k]));
  return largest;
}

/* round-off of the loop equations, with lengths of the model as the scale */
double maggi_roundoff(const maggi_data *d)
{
  return 4.0 * DBL_EPSILON * maggi_largest_length(d);
}
