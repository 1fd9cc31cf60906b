/* Sizes, to which errors are relative, and errors. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ranking.h"
#include "verify.h"

#define SMALL 1e-6 /* of the value: no gradient is smaller than that */

/* |b|; of a parameter that is 0 the largest |b| with its unit, else 1. */
static void find_scales(verify *v)
{
  const maggi_design *design = v->study->parameters.design;
  int n = v->study->parameters.number, i, k;
  double b;

  for (i = 0; i < n; ++i) {
    v->scale[i] = fabs(maggi_design_value(design, i));
    if (v->scale[i] > 0.0) continue;
    for (k = 0; k < n; ++k) {
      b = fabs(maggi_design_value(design, k));
      if (b > v->scale[i] &&
          strcmp(maggi_design_unit(design, k), maggi_design_unit(design, i)) == 0)
        v->scale[i] = b;
    }
    if (v->scale[i] == 0.0) v->scale[i] = 1.0;
  }
}

/* Largest entry of each gradient, and for each parameter its largest part of one of them. */
static void find_sizes(verify *v, double *weight)
{
  int n = v->study->parameters.number, i, k;
  const double *g = v->trial[TRIAL_ADJOINT].gradient;

  for (i = 0; i < v->study->objectives.number; ++i, g += n) {
    v->size[i] = SMALL * fabs(v->value[i]);
    for (k = 0; k < n; ++k) v->size[i] = fmax(v->size[i], v->scale[k] * fabs(g[k]));
    for (k = 0; k < n; ++k)
      if (v->size[i] > 0.0) weight[k] = fmax(weight[k], v->scale[k] * fabs(g[k]) / v->size[i]);
  }
}

int verify_sizes(verify *v)
{
  int n = v->study->parameters.number, failed;
  double *weight = calloc((size_t)n, sizeof *weight);

  if (!weight) return -1;
  find_scales(v);
  find_sizes(v, weight);
  failed = ranking(n, weight, NULL, v->order);
  free(weight);
  return failed;
}

double verify_distance(const verify *v, const double *a, const double *b, int n, int *objective)
{
  size_t number = (size_t)v->study->parameters.number, at;
  double largest = 0.0, difference;
  int i, k;

  if (objective) *objective = 0;
  for (i = 0; i < v->study->objectives.number; ++i)
    for (k = 0; k < n; ++k) {
      at = (size_t)i * number + (size_t)v->order[k];
      difference = v->scale[v->order[k]] * fabs(a[at] - b[at]);
      if (difference > 0.0) difference /= v->size[i]; /* 0/0 of a gradient that is zero */
      if (difference <= largest) continue;
      largest = difference;
      if (objective) *objective = i;
      if (isnan(difference)) return NAN;
    }
  return largest;
}
