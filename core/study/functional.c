/* Objectives over the samples of a simulation. */
#include "functional.h"

#include <math.h>
#include <string.h>

#include "message.h"
#include "objective.h"

int maggi_objective_signals(const maggi_objective *o, const int **signal)
{
  *signal = o->signal;
  return o->nsignal;
}

/* what a summand is a functional of, at sample k; of a function, with its gradient */
static double scalar(const maggi_objective *o, const maggi_summand *u, long k, const double *s)
{
  int i;

  if (!u->function) return s[u->slot[0]];
  for (i = 0; i < u->nsignal; ++i) o->arguments[i] = s[u->slot[i]];
  return u->function(u->context, maggi_grid_time(&o->grid, k), u->nsignal, o->arguments,
                     o->gradient);
}

maggi_status maggi_objective_begin(maggi_objective *o, const maggi_grid *grid, char *message,
                                   size_t n)
{
  char why[100];
  int i;

  o->grid = *grid;
  for (i = 0; i < o->nsummand; ++i) {
    maggi_term *t = &o->summand[i].term;

    if (!maggi_term_reached(t, grid, why, sizeof why))
      return maggi_message(MAGGI_E_VALUE, message, n, "objective \"%s\": %s", o->summand[i].name,
                           why);
    maggi_term_begin(t, grid);
  }
  return MAGGI_OK;
}

void maggi_objective_push(maggi_objective *o, long k, const double *s)
{
  int i;

  for (i = 0; i < o->nsummand; ++i)
    maggi_term_push(&o->summand[i].term, k, scalar(o, &o->summand[i], k, s),
                    s[o->summand[i].against]);
}

maggi_status maggi_objective_end(maggi_objective *o, double *value, char *message, size_t n)
{
  int i;

  *value = 0.0;
  for (i = 0; i < o->nsummand; ++i) {
    maggi_term_end(&o->summand[i].term);
    if (o->summand[i].term.type == MAGGI_OBJECTIVE_SLOPE &&
        !(o->summand[i].term.slope.spread > 0.0))
      return maggi_message(MAGGI_E_VALUE, message, n,
                           "objective \"%s\": the signal that it is against does not change",
                           o->summand[i].name);
    *value += o->summand[i].weight * o->summand[i].term.value;
  }
  if (!isfinite(*value))
    return maggi_message(MAGGI_E_VALUE, message, n, "objective \"%s\": its value is not finite",
                         o->name);
  return MAGGI_OK;
}

maggi_status maggi_objective_differentiable(const maggi_objective *o, char *message, size_t n)
{
  const char *why;
  int i;

  for (i = 0; i < o->nsummand; ++i) {
    why = o->summand[i].weight != 0.0 ? maggi_term_no_derivative(&o->summand[i].term) : NULL;
    if (why)
      return maggi_message(MAGGI_E_VALUE, message, n, "objective \"%s\": %s", o->summand[i].name,
                           why);
  }
  return MAGGI_OK;
}

int maggi_objective_weights(const maggi_objective *o, long k, const double *s, double *weight)
{
  double x, w, by_r;
  int i, j, any = 0;

  for (i = 0; i < o->nsummand; ++i) {
    const maggi_summand *u = &o->summand[i];

    if (u->weight == 0.0) continue;
    x = scalar(o, u, k, s);
    by_r = 0.0;
    w = u->weight * maggi_term_weight(&u->term, k, x, s[u->against], &by_r);
    by_r *= u->weight;
    if (w == 0.0 && by_r == 0.0) continue;
    if (!any) memset(weight, 0, (size_t)o->nsignal * sizeof *weight);
    any = 1;
    for (j = 0; j < u->nsignal; ++j) weight[u->slot[j]] += u->function ? w * o->gradient[j] : w;
    weight[u->against] += by_r;
  }
  return any;
}
