/* Functionals of the samples of one scalar, in two passes: see functional.h. */
#include "term.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "extremum.h"

/* the power of s in the integral; 0: no such integral */
static int power(maggi_objective_type type)
{
  switch (type) {
  case MAGGI_OBJECTIVE_INTEGRAL:
  case MAGGI_OBJECTIVE_MEAN:
    return 1;
  case MAGGI_OBJECTIVE_INTEGRAL_SQUARE:
  case MAGGI_OBJECTIVE_MEAN_SQUARE:
  case MAGGI_OBJECTIVE_RMS:
    return 2;
  case MAGGI_OBJECTIVE_RMQ:
  case MAGGI_OBJECTIVE_VDV:
    return 4;
  default:
    return 0;
  }
}

static int is_mean(maggi_objective_type type)
{
  return type == MAGGI_OBJECTIVE_MEAN || type == MAGGI_OBJECTIVE_MEAN_SQUARE ||
         type == MAGGI_OBJECTIVE_RMS || type == MAGGI_OBJECTIVE_RMQ ||
         type == MAGGI_OBJECTIVE_SMOOTH_MAXIMUM;
}

static int is_root(maggi_objective_type type)
{
  return type == MAGGI_OBJECTIVE_RMS || type == MAGGI_OBJECTIVE_RMQ || type == MAGGI_OBJECTIVE_VDV;
}

static int is_extremum(maggi_objective_type type)
{
  return type == MAGGI_OBJECTIVE_MAXIMUM || type == MAGGI_OBJECTIVE_MINIMUM ||
         type == MAGGI_OBJECTIVE_PEAK;
}

static int has_times(maggi_objective_type type)
{
  return type == MAGGI_OBJECTIVE_VALUE || type == MAGGI_OBJECTIVE_LEAST_SQUARES;
}

/* weight of a node in the integral or the mean; the mean over no time is the sample */
static double node_weight(const maggi_term *f, long i)
{
  if (!is_mean(f->type)) return maggi_nodes_weight(&f->nodes, i);
  return f->time > 0.0 ? maggi_nodes_weight(&f->nodes, i) / f->time : 1.0;
}

int maggi_term_reached(const maggi_term *f, const maggi_grid *grid)
{
  return f->number == 0 || f->times[f->number - 1] <= grid->time * (1.0 + 4.0 * DBL_EPSILON);
}

void maggi_term_begin(maggi_term *f, const maggi_grid *grid)
{
  maggi_nodes_init(&f->nodes, grid);
  f->steps = grid->steps;
  f->time = grid->time;
  f->sum = 0.0;
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

/* looks for a maximum of sign s beside nodes that are one */
static void search(maggi_term *f, long interval, double sign)
{
  long first = maggi_nodes_first(&f->nodes, interval);
  int n = maggi_nodes_stencil(&f->nodes), begin = (int)(interval - first), end, j;
  double u[MAGGI_STENCIL], s[MAGGI_STENCIL], top, where;

  end = begin < n - 1 ? begin + 1 : begin;
  for (j = 0; j < n; ++j) {
    u[j] = maggi_nodes_position(&f->nodes, first, first + j);
    s[j] = sign * (f->recent[j] - f->target);
  }
  if (!is_high(s, n, begin) && !is_high(s, n, end)) return;
  top = maggi_local_maximum(n, u, s, u[begin], u[end], &where);
  if (f->sign != 0.0 && !(top > f->value)) return;
  f->value = top;
  f->sign = sign;
  maggi_nodes_at(&f->nodes, interval, where, &f->best);
}

static void take_interval(maggi_term *f, long interval)
{
  if (has_times(f->type)) read_times(f, interval);
  if (f->type == MAGGI_OBJECTIVE_MAXIMUM || f->type == MAGGI_OBJECTIVE_PEAK)
    search(f, interval, 1.0);
  if (f->type == MAGGI_OBJECTIVE_MINIMUM || f->type == MAGGI_OBJECTIVE_PEAK)
    search(f, interval, -1.0);
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

void maggi_term_push(maggi_term *f, long k, double s)
{
  double x = s - f->target;
  long i = maggi_nodes_of(&f->nodes, k);
  int degree = power(f->type);

  if (f->type == MAGGI_OBJECTIVE_TERMINAL && k == f->steps) f->value = x;
  if (i < 0) return;
  if (is_extremum(f->type) || has_times(f->type)) take_node(f, i, s);
  if (degree > 0)
    f->sum += node_weight(f, i) * (degree == 1 ? x : degree == 2 ? x * x : x * x * x * x);
  if (f->type == MAGGI_OBJECTIVE_SMOOTH_MAXIMUM) {
    if (x > f->top) { /* relative to it, so that nothing overflows */
      f->sum *= exp(f->sharpness * (f->top - x));
      f->top = x;
    }
    f->sum += node_weight(f, i) * exp(f->sharpness * (x - f->top));
  }
}

void maggi_term_end(maggi_term *f)
{
  switch (f->type) {
  case MAGGI_OBJECTIVE_RMS:
    f->value = sqrt(f->sum);
    break;
  case MAGGI_OBJECTIVE_RMQ:
  case MAGGI_OBJECTIVE_VDV:
    f->value = sqrt(sqrt(f->sum));
    break;
  case MAGGI_OBJECTIVE_SMOOTH_MAXIMUM:
    f->value = f->top + log(f->sum) / f->sharpness;
    break;
  case MAGGI_OBJECTIVE_LEAST_SQUARES:
    f->value = f->sum / f->number;
    break;
  case MAGGI_OBJECTIVE_MINIMUM:
    f->value = -f->value;
    break;
  case MAGGI_OBJECTIVE_MAXIMUM:
  case MAGGI_OBJECTIVE_PEAK:
  case MAGGI_OBJECTIVE_TERMINAL:
    break;
  default:
    f->value = f->sum;
  }
}

const char *maggi_term_no_derivative(const maggi_term *f)
{
  if (is_root(f->type) && f->value == 0.0) return "the root of zero has no derivative";
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

double maggi_term_weight(const maggi_term *f, long k, double s)
{
  double x = s - f->target, part = x / f->value;
  long i = maggi_nodes_of(&f->nodes, k), j = i - f->best.first;

  if (f->type == MAGGI_OBJECTIVE_TERMINAL) return k == f->steps ? 1.0 : 0.0;
  if (i < 0) return 0.0;
  if (is_extremum(f->type)) {
    if (j < 0 || j >= f->best.n) return 0.0;
    return (f->type == MAGGI_OBJECTIVE_PEAK ? f->sign : 1.0) * f->best.weight[j];
  }
  switch (f->type) {
  case MAGGI_OBJECTIVE_INTEGRAL:
  case MAGGI_OBJECTIVE_MEAN:
    return node_weight(f, i);
  case MAGGI_OBJECTIVE_INTEGRAL_SQUARE:
  case MAGGI_OBJECTIVE_MEAN_SQUARE:
    return node_weight(f, i) * 2.0 * x;
  case MAGGI_OBJECTIVE_RMS:
    return node_weight(f, i) * part;
  case MAGGI_OBJECTIVE_RMQ:
  case MAGGI_OBJECTIVE_VDV:
    return node_weight(f, i) * part * part * part;
  case MAGGI_OBJECTIVE_SMOOTH_MAXIMUM:
    return node_weight(f, i) * exp(f->sharpness * (x - f->value));
  default: /* value, least_squares */
    return times_weight(f, i);
  }
}
