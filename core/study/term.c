/* Functionals of the samples of one scalar, in two passes: see functional.h. */
#include "term.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "extremum.h"
#include "term_kind.h"

/* the polynomial at that end of the window where its value counts, or NULL */
static const maggi_local *end_of(const maggi_term *f)
{
  if (f->reference == MAGGI_REFERENCE_INITIAL) return &f->window.initial;
  if (f->reference == MAGGI_REFERENCE_FINAL || f->type == MAGGI_OBJECTIVE_TERMINAL)
    return &f->window.final;
  return NULL;
}

/* weight of a node in the integral or the mean; the mean over no time is the sample */
static double node_weight(const maggi_term *f, long i)
{
  double weight = maggi_window_weight(&f->window, &f->nodes, i);

  if (!maggi_term_is_mean(f->type)) return weight;
  return f->window.length > 0.0 ? weight / f->window.length : 1.0;
}

int maggi_term_reached(const maggi_term *f, const maggi_grid *grid, char *text, size_t n)
{
  double last = f->number > 0 ? f->times[f->number - 1] : isnan(f->to) ? 0.0 : f->to;

  if (last > grid->time * (1.0 + 4.0 * DBL_EPSILON))
    snprintf(text, n, "the simulation ends at %g s, before %g s", grid->time, last);
  else if (f->from >= grid->time)
    snprintf(text, n, "the simulation ends at %g s, its window begins at %g s", grid->time,
             f->from);
  else
    return 1;
  return 0;
}

void maggi_term_begin(maggi_term *f, const maggi_grid *grid)
{
  maggi_nodes_init(&f->nodes, grid);
  maggi_window_init(&f->window, &f->nodes, grid, f->from, f->to);
  maggi_slope_begin(&f->slope);
  memset(&f->moments, 0, sizeof f->moments);
  f->moments.power = maggi_term_power(f->type);
  f->moments.can_shift = f->reference != MAGGI_REFERENCE_NONE;
  f->moments.origin = f->moments.can_shift ? NAN : f->target;
  f->at = f->pull = f->sum = 0.0;
  f->top = -INFINITY;
  f->next = 0;
  f->sign = 0.0;
  f->value = NAN;
}

/* ------------------------------------------------------------------------------------- intervals */

static void read_times(maggi_term *f, long interval)
{
  maggi_local at;
  double u, s;
  int j;

  for (; f->next < f->number; ++f->next) {
    if (maggi_nodes_find(&f->nodes, f->times[f->next], &u) != interval) return;
    maggi_nodes_at(&f->nodes, interval, u, &at);
    s = -f->target;
    for (j = 0; j < at.n; ++j) s += at.weight[j] * f->recent[j];
    if (f->type == MAGGI_OBJECTIVE_VALUE) {
      f->sum += s;
    } else {
      f->residual[f->next] = s - f->values[f->next];
      f->sum += f->residual[f->next] * f->residual[f->next];
    }
  }
}

/* node j of n is not lower than those beside it */
static int is_high(const double *s, int n, int j)
{
  return (j == 0 || s[j] >= s[j - 1]) && (j == n - 1 || s[j] >= s[j + 1]);
}

/* looks for a maximum of sign s in an interval, between nodes only beside one that is high */
static void search(maggi_term *f, long interval, double sign)
{
  long first = maggi_nodes_first(&f->nodes, interval);
  int n = maggi_nodes_stencil(&f->nodes), begin = (int)(interval - first), end, j;
  double u[MAGGI_STENCIL], s[MAGGI_STENCIL], top, where, from, to;

  if (!maggi_window_part(&f->window, &f->nodes, interval, &from, &to)) return;
  end = begin < n - 1 ? begin + 1 : begin;
  for (j = 0; j < n; ++j) {
    u[j] = maggi_nodes_position(&f->nodes, first, first + j);
    s[j] = sign * (f->recent[j] - f->target);
  }
  if (!maggi_window_edge(&f->window, interval) && !is_high(s, n, begin) && !is_high(s, n, end))
    return;
  top = maggi_local_maximum(n, u, s, from, to, &where);
  if (f->sign != 0.0 && !(top > f->value)) return;
  f->value = top;
  f->sign = sign;
  maggi_nodes_at(&f->nodes, interval, where, &f->best);
}

static void take_interval(maggi_term *f, long interval)
{
  const maggi_local *end = end_of(f);
  int j;

  if (maggi_term_has_times(f->type)) read_times(f, interval);
  if (f->type == MAGGI_OBJECTIVE_MAXIMUM || f->type == MAGGI_OBJECTIVE_PEAK)
    search(f, interval, 1.0);
  if (f->type == MAGGI_OBJECTIVE_MINIMUM || f->type == MAGGI_OBJECTIVE_PEAK)
    search(f, interval, -1.0);
  if (end && interval == (end == &f->window.initial ? f->window.first : f->window.last))
    for (j = 0; j < end->n; ++j) f->at += end->weight[j] * f->recent[j];
}

/* keeps the last nodes, and takes the intervals whose polynomial goes through them */
static void take_node(maggi_term *f, long i, double s)
{
  int n = maggi_nodes_stencil(&f->nodes);
  long end = f->nodes.n - 1, interval = i - MAGGI_STENCIL / 2, last = interval;

  if (i >= n) memmove(f->recent, f->recent + 1, (size_t)(n - 1) * sizeof *f->recent);
  f->recent[i < n ? i : n - 1] = s;
  if (i < n - 1) return;
  if (i == n - 1) interval = 0;
  if (i == end) last = end > 0 ? end - 1 : 0;
  for (; interval <= last; ++interval) take_interval(f, interval);
}

/* -------------------------------------------------------------------------------------- samples */

void maggi_term_push(maggi_term *f, long k, double s, double r)
{
  double x = s - f->target, weight;
  long i = maggi_nodes_of(&f->nodes, k);

  if (i < 0) return;
  if (maggi_term_is_extremum(f->type) || maggi_term_has_times(f->type) || end_of(f))
    take_node(f, i, s);
  weight = node_weight(f, i);
  if (weight == 0.0) return;
  if (f->type == MAGGI_OBJECTIVE_VIOLATION) s = s < f->target ? f->target : s;
  if (maggi_term_power(f->type) > 0) maggi_moments_push(&f->moments, weight, s);
  if (f->type == MAGGI_OBJECTIVE_SLOPE) maggi_slope_push(&f->slope, weight, s, r);
  if (f->type == MAGGI_OBJECTIVE_SMOOTH_MAXIMUM) {
    if (x > f->top) { /* relative to it, so that nothing overflows */
      f->sum *= exp(f->sharpness * (f->top - x));
      f->top = x;
    }
    f->sum += weight * exp(f->sharpness * (x - f->top));
  }
}

/* the integral, and what it loses when the reference grows */
static void end_integral(maggi_term *f)
{
  maggi_moments *m = &f->moments;
  int n = m->power;

  if (m->can_shift) maggi_moments_shift(m, f->at + f->target);
  f->value = m->sum[n];
  f->pull = n * m->sum[n - 1];
  if (!maggi_term_is_root(f->type)) return;
  f->value = n == 2 ? sqrt(f->value) : sqrt(sqrt(f->value));
  f->pull /= n * pow(f->value, n - 1);
}

void maggi_term_end(maggi_term *f)
{
  switch (f->type) {
  case MAGGI_OBJECTIVE_SMOOTH_MAXIMUM:
    f->value = f->top + log(f->sum) / f->sharpness;
    break;
  case MAGGI_OBJECTIVE_LEAST_SQUARES:
    f->value = f->sum / f->number;
    break;
  case MAGGI_OBJECTIVE_VALUE:
    f->value = f->sum;
    break;
  case MAGGI_OBJECTIVE_MINIMUM:
    f->value = -f->value;
    break;
  case MAGGI_OBJECTIVE_MAXIMUM:
  case MAGGI_OBJECTIVE_PEAK:
    break;
  case MAGGI_OBJECTIVE_TERMINAL:
    f->value = f->at - f->target;
    break;
  case MAGGI_OBJECTIVE_SLOPE:
    f->value = maggi_slope_end(&f->slope);
    break;
  default:
    end_integral(f);
  }
}

const char *maggi_term_no_derivative(const maggi_term *f)
{
  if (maggi_term_is_root(f->type) && f->value == 0.0) return "the root of zero has no derivative";
  if (f->type == MAGGI_OBJECTIVE_PEAK && f->value == 0.0)
    return "the absolute value of zero has no derivative";
  return NULL;
}

/* -------------------------------------------------------------------------------------- weights */

/* by the times whose polynomial goes through node i */
static double times_weight(const maggi_term *f, long i)
{
  double reach = (MAGGI_STENCIL + 1) * f->nodes.h, begin = (double)i * f->nodes.h - reach;
  double end = (double)i * f->nodes.h + reach, sum = 0.0, u;
  maggi_local at;
  int low = 0, high = f->number, mid;
  long interval;

  while (low < high) {
    mid = low + (high - low) / 2;
    if (f->times[mid] < begin)
      low = mid + 1;
    else
      high = mid;
  }
  for (; low < f->number && f->times[low] <= end; ++low) {
    interval = maggi_nodes_find(&f->nodes, f->times[low], &u);
    maggi_nodes_at(&f->nodes, interval, u, &at);
    if (i < at.first || i >= at.first + at.n) continue;
    sum += f->type == MAGGI_OBJECTIVE_VALUE
               ? at.weight[i - at.first]
               : 2.0 * f->residual[low] * at.weight[i - at.first] / f->number;
  }
  return sum;
}

/* by sample s at node i of an integral, whose origin is that of the end */
static double integral_weight(const maggi_term *f, long i, double s)
{
  const maggi_local *end = end_of(f);
  double x = s - f->moments.origin, by, part = x / f->value;

  if (f->type == MAGGI_OBJECTIVE_VIOLATION) x = x < 0.0 ? 0.0 : x;
  switch (f->type) {
  case MAGGI_OBJECTIVE_INTEGRAL:
  case MAGGI_OBJECTIVE_MEAN:
    by = 1.0;
    break;
  case MAGGI_OBJECTIVE_RMS:
  case MAGGI_OBJECTIVE_NORM:
    by = part;
    break;
  case MAGGI_OBJECTIVE_RMQ:
  case MAGGI_OBJECTIVE_VDV:
    by = part * part * part;
    break;
  default: /* a square */
    by = 2.0 * x;
  }
  by *= node_weight(f, i);
  return end ? by - f->pull * maggi_local_weight(end, i) : by;
}

double maggi_term_weight(const maggi_term *f, long k, double s, double r, double *by_r)
{
  long i = maggi_nodes_of(&f->nodes, k);
  double by_s = 0.0;

  if (f->type == MAGGI_OBJECTIVE_SLOPE) *by_r = 0.0;
  if (i < 0) return 0.0;
  if (maggi_term_is_extremum(f->type))
    return (f->type == MAGGI_OBJECTIVE_PEAK ? f->sign : 1.0) * maggi_local_weight(&f->best, i);
  switch (f->type) {
  case MAGGI_OBJECTIVE_TERMINAL:
    return maggi_local_weight(&f->window.final, i);
  case MAGGI_OBJECTIVE_SMOOTH_MAXIMUM:
    return node_weight(f, i) * exp(f->sharpness * (s - f->target - f->value));
  case MAGGI_OBJECTIVE_VALUE:
  case MAGGI_OBJECTIVE_LEAST_SQUARES:
    return times_weight(f, i);
  case MAGGI_OBJECTIVE_SLOPE:
    maggi_slope_weight(&f->slope, node_weight(f, i), s, r, &by_s, by_r);
    return by_s;
  default:
    return integral_weight(f, i, s);
  }
}
