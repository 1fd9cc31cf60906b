/* Piecewise polynomial of degree 5 through samples: integration and interpolation. */
#include "quadrature.h"

#include <float.h>
#include <math.h>

#define SHORTEST 0.28 /* last step, in others, before which a sample is a node */

/* Lengths of both ends of a grid, where weights in an integral differ from h: node i is in the
 * polynomials of intervals i - 3 .. i + 2, and those up to number 2 share the first six nodes. */
enum { BOTH_ENDS = 2 * MAGGI_STENCIL };

int maggi_nodes_stencil(const maggi_nodes *x)
{
  return x->n < MAGGI_STENCIL ? (int)x->n : MAGGI_STENCIL;
}

long maggi_nodes_first(const maggi_nodes *x, long interval)
{
  long first = interval - (MAGGI_STENCIL / 2 - 1), highest = x->n - MAGGI_STENCIL;

  if (first > highest) first = highest;
  return first > 0 ? first : 0;
}

double maggi_nodes_position(const maggi_nodes *x, long first, long i)
{
  return i > 0 && i == x->n - 1 ? (double)(i - 1 - first) + x->gap : (double)(i - first);
}

/* L_j(u) = prod (u - u_k)/(u_j - u_k) over k other than j */
void maggi_nodes_at(const maggi_nodes *x, long interval, double u, maggi_local *value)
{
  long first = maggi_nodes_first(x, interval);
  double node[MAGGI_STENCIL], above, below;
  int j, k, n = maggi_nodes_stencil(x);

  for (j = 0; j < n; ++j) node[j] = maggi_nodes_position(x, first, first + j);
  for (j = 0; j < n; ++j) {
    above = below = 1.0;
    for (k = 0; k < n; ++k) {
      if (k == j) continue;
      above *= u - node[k];
      below *= node[j] - node[k];
    }
    value->weight[j] = above / below;
  }
  value->first = first;
  value->n = n;
}

/* Gauss-Legendre, exact for degree 5 */
void maggi_nodes_integral(const maggi_nodes *x, long interval, double begin, double end,
                          maggi_local *value)
{
  static const double point[] = {0.11270166537925831, 0.5, 0.88729833462074169};
  static const double share[] = {5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0};
  double length = end - begin, weight[MAGGI_STENCIL] = {0.0};
  int i, j;

  for (i = 0; i < 3; ++i) {
    maggi_nodes_at(x, interval, begin + point[i] * length, value);
    for (j = 0; j < value->n; ++j) weight[j] += share[i] * length * x->h * value->weight[j];
  }
  for (j = 0; j < value->n; ++j) value->weight[j] = weight[j];
}

/* Adds the integral over one interval to the weights. */
static void add_interval(const maggi_nodes *x, long interval, double *weight)
{
  long first = maggi_nodes_first(x, interval);
  maggi_local value;
  int j;

  maggi_nodes_integral(x, interval, maggi_nodes_position(x, first, interval),
                       maggi_nodes_position(x, first, interval + 1), &value);
  for (j = 0; j < value.n; ++j) weight[first + j] += value.weight[j];
}

void maggi_nodes_init(maggi_nodes *x, const maggi_grid *grid)
{
  maggi_nodes ends;
  long i;

  x->skipped = -1;
  x->n = grid->steps + 1;
  x->h = grid->step;
  x->gap = 1.0;
  if (grid->steps > 0 && grid->is_multiple) {
    x->h = grid->time / (double)grid->steps;
  } else if (grid->steps == 1) {
    x->h = grid->time;
  } else if (grid->steps > 1) {
    x->gap = (grid->time - maggi_grid_time(grid, grid->steps - 1)) / x->h;
    if (x->gap < SHORTEST) {
      x->skipped = grid->steps - 1;
      x->gap += 1.0;
      --x->n;
    }
  }
  for (i = 0; i < BOTH_ENDS; ++i) x->end[i] = 0.0;
  ends = *x; /* a grid of both ends alone has the same weights */
  if (ends.n > BOTH_ENDS) ends.n = BOTH_ENDS;
  for (i = 0; i < ends.n - 1; ++i) add_interval(&ends, i, x->end);
}

long maggi_nodes_of(const maggi_nodes *x, long sample)
{
  if (sample == x->skipped) return -1;
  return x->skipped >= 0 && sample > x->skipped ? sample - 1 : sample;
}

double maggi_nodes_weight(const maggi_nodes *x, long i)
{
  if (i < MAGGI_STENCIL) return x->end[i];
  if (i < x->n - MAGGI_STENCIL) return x->h;
  return x->end[x->n < BOTH_ENDS ? i : i - x->n + BOTH_ENDS];
}

/* a time that is that of a node but for rounding counts as it */
long maggi_nodes_find(const maggi_nodes *x, double t, double *u)
{
  double at = t / x->h, whole = round(at), end;
  long interval, first;

  if (fabs(at - whole) <= 4.0 * DBL_EPSILON * at) at = whole;
  interval = (long)fmin(at, (double)x->n - 2.0);
  if (interval < 0) interval = 0;
  first = maggi_nodes_first(x, interval);
  end = maggi_nodes_position(x, first, x->n - 1);
  *u = at - (double)first;
  if (*u > end || fabs(*u - end) <= 4.0 * DBL_EPSILON * at) *u = end;
  return interval;
}
