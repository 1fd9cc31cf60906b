/* A part of the time of a simulation: see window.h. */
#include "window.h"

#include <math.h>

void maggi_window_init(maggi_window *w, const maggi_nodes *x, const maggi_grid *grid, double from,
                       double to)
{
  w->is_whole = isnan(from) && isnan(to);
  if (isnan(from)) from = 0.0;
  if (isnan(to)) to = grid->time;
  w->length = to - from;
  w->first = maggi_nodes_find(x, from, &w->begin);
  w->last = maggi_nodes_find(x, to, &w->end);
  maggi_nodes_at(x, w->first, w->begin, &w->initial);
  maggi_nodes_at(x, w->last, w->end, &w->final);
}

int maggi_window_part(const maggi_window *w, const maggi_nodes *x, long interval, double *begin,
                      double *end)
{
  long first = maggi_nodes_first(x, interval);

  *begin = maggi_nodes_position(x, first, interval);
  *end = maggi_nodes_position(x, first, x->n > 1 ? interval + 1 : interval);
  if (w->is_whole) return 1;
  if (interval < w->first || interval > w->last) return 0;
  if (interval == w->first) *begin = w->begin;
  if (interval == w->last) *end = w->end;
  return *end > *begin;
}

int maggi_window_edge(const maggi_window *w, long interval)
{
  return !w->is_whole && (interval <= w->first + 1 || interval >= w->last - 1);
}

double maggi_window_weight(const maggi_window *w, const maggi_nodes *x, long i)
{
  long low = i - MAGGI_STENCIL, high = i + MAGGI_STENCIL,
       interval; /* polynomials through the node */
  double begin, end, sum = 0.0;
  maggi_local value;

  if (w->is_whole || (low > w->first && high < w->last)) return maggi_nodes_weight(x, i);
  if (low < w->first) low = w->first;
  if (high > w->last) high = w->last;
  for (interval = low; interval <= high; ++interval) {
    if (!maggi_window_part(w, x, interval, &begin, &end)) continue;
    maggi_nodes_integral(x, interval, begin, end, &value);
    sum += maggi_local_weight(&value, i);
  }
  return sum;
}

double maggi_local_weight(const maggi_local *value, long i)
{
  long j = i - value->first;

  return j >= 0 && j < value->n ? value->weight[j] : 0.0;
}
