/* Definitions of objectives and design parameters. */
#if !defined(_WIN32) && !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* fnmatch */
#endif

#include "definition.h"

#include <fnmatch.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "builder.h"
#include "model.h"

/* fails with the text when ok is false */
#define REQUIRE(ok, ...)                                                                           \
  do {                                                                                             \
    if (!(ok)) {                                                                                   \
      snprintf(text, n, __VA_ARGS__);                                                              \
      return MAGGI_E_VALUE;                                                                        \
    }                                                                                              \
  } while (0)

/* --------------------------------------------------------------------------------- what is wrong */

static maggi_status wrong_times(const maggi_objective_def *d, char *text, size_t n)
{
  int i;

  REQUIRE(d->number >= 1 && d->times, "times are missing");
  REQUIRE(maggi_all_finite(d->times, d->number), "times are not finite");
  REQUIRE(d->times[0] >= 0.0, "times begin before 0 (%g)", d->times[0]);
  for (i = 1; i < d->number; ++i)
    REQUIRE(d->times[i] > d->times[i - 1], "times do not increase (%g after %g)", d->times[i],
            d->times[i - 1]);
  if (d->type == MAGGI_OBJECTIVE_LEAST_SQUARES)
    REQUIRE(d->values && maggi_all_finite(d->values, d->number), "values are not finite");
  return MAGGI_OK;
}

static maggi_status wrong_sum(const maggi_objective_def *d, char *text, size_t n)
{
  int i;

  REQUIRE(d->nterm >= 1 && d->terms, "terms are missing");
  for (i = 0; i < d->nterm; ++i) REQUIRE(d->terms[i], "terms: number %d is missing", i + 1);
  REQUIRE(!d->weights || maggi_all_finite(d->weights, d->nterm), "weights are not finite");
  return MAGGI_OK;
}

static int is_at_times(maggi_objective_type type)
{
  return type == MAGGI_OBJECTIVE_VALUE || type == MAGGI_OBJECTIVE_LEAST_SQUARES;
}

static int takes_reference(maggi_objective_type type)
{
  return type <= MAGGI_OBJECTIVE_VDV || type == MAGGI_OBJECTIVE_NORM;
}

static maggi_status wrong_window(const maggi_objective_def *d, char *text, size_t n)
{
  const char *type = maggi_objective_type_name(d->type);
  double from = isnan(d->from) ? 0.0 : d->from;

  REQUIRE((isnan(d->from) && isnan(d->to)) || !is_at_times(d->type), "a %s has no window", type);
  REQUIRE(isnan(d->from) || d->type != MAGGI_OBJECTIVE_TERMINAL,
          "a terminal is at the end of its window, so without from");
  REQUIRE(!isinf(d->from) && !isinf(d->to), "the window is not finite");
  REQUIRE(from >= 0.0, "the window begins before 0 (%g)", from);
  REQUIRE(!(d->to <= from), "the window is empty (from %g to %g)", from, d->to);
  REQUIRE((int)d->reference >= 0 && d->reference < MAGGI_REFERENCE_TYPE_COUNT,
          "reference %d does not exist", (int)d->reference);
  REQUIRE(d->reference == MAGGI_REFERENCE_NONE || takes_reference(d->type), "a %s has no reference",
          type);
  return MAGGI_OK;
}

maggi_status maggi_objective_wrong(const maggi_objective_def *d, char *text, size_t n)
{
  int i;

  REQUIRE((int)d->type >= 0 && d->type < MAGGI_OBJECTIVE_TYPE_COUNT,
          "objective type %d does not exist", (int)d->type);
  if (d->type == MAGGI_OBJECTIVE_SUM) return wrong_sum(d, text, n);
  REQUIRE(d->signal || d->function, "signal is missing");
  REQUIRE(!d->signal || !d->function, "signal and function exclude each other");
  if (d->function) {
    REQUIRE(d->nsignal >= 1 && d->signals, "signals of the function are missing");
    for (i = 0; i < d->nsignal; ++i) REQUIRE(d->signals[i], "signals: number %d is missing", i + 1);
  }
  REQUIRE(isfinite(d->target), "target is not finite");
  if (d->type == MAGGI_OBJECTIVE_SMOOTH_MAXIMUM)
    REQUIRE(isfinite(d->sharpness) && d->sharpness > 0.0, "sharpness is not positive (%g)",
            d->sharpness);
  REQUIRE(d->against || d->type != MAGGI_OBJECTIVE_SLOPE, "against is missing");
  if (wrong_window(d, text, n) != MAGGI_OK) return MAGGI_E_VALUE;
  return is_at_times(d->type) ? wrong_times(d, text, n) : MAGGI_OK;
}

maggi_status maggi_design_wrong(const maggi_design_def *d, char *text, size_t n)
{
  int i;

  REQUIRE(d->number >= 1 && d->paths, "parameters are missing");
  for (i = 0; i < d->number; ++i) {
    REQUIRE(d->paths[i], "parameters: number %d is missing", i + 1);
    if (!d->factors) continue;
    REQUIRE(isfinite(d->factors[i]), "factors are not finite");
    REQUIRE(d->factors[i] != 0.0, "factors: number %d is zero", i + 1);
  }
  REQUIRE(!isinf(d->nominal), "nominal is not finite");
  REQUIRE(!isnan(d->lower), "lower is not a number");
  REQUIRE(!isnan(d->upper), "upper is not a number");
  REQUIRE(d->lower <= d->upper, "lower is above upper (%g, %g)", d->lower, d->upper);
  REQUIRE(isnan(d->nominal) || (d->lower <= d->nominal && d->nominal <= d->upper),
          "nominal is not between lower and upper (%g)", d->nominal);
  return MAGGI_OK;
}

/* ---------------------------------------------------------------------------------------- copies */

static int own_text(maggi_arena *arena, const char **text)
{
  if (*text) *text = maggi_arena_text(arena, *text);
  return *text != NULL;
}

static int own_texts(maggi_arena *arena, const char *const **texts, int n)
{
  *texts = maggi_arena_texts(arena, *texts, n);
  return *texts != NULL;
}

static int own_numbers(maggi_arena *arena, const double **numbers, int n)
{
  *numbers = maggi_arena_numbers(arena, *numbers, n);
  return *numbers != NULL;
}

int maggi_objective_own(maggi_arena *arena, maggi_objective_def *d)
{
  if (!is_at_times(d->type)) d->number = 0;
  if (d->type != MAGGI_OBJECTIVE_SLOPE) d->against = NULL;
  if (d->type == MAGGI_OBJECTIVE_SUM) {
    d->signal = NULL;
    d->function = NULL;
  } else {
    d->nterm = 0;
  }
  if (!d->function) d->nsignal = 0;
  return (!d->signal || own_text(arena, &d->signal)) &&
         (!d->against || own_text(arena, &d->against)) &&
         (d->nsignal == 0 || own_texts(arena, &d->signals, d->nsignal)) &&
         (d->number == 0 || own_numbers(arena, &d->times, d->number)) &&
         (d->number == 0 || !d->values || own_numbers(arena, &d->values, d->number)) &&
         (d->nterm == 0 || own_texts(arena, &d->terms, d->nterm)) &&
         (d->nterm == 0 || !d->weights || own_numbers(arena, &d->weights, d->nterm));
}

int maggi_sensor_own(maggi_arena *arena, maggi_sensor_def *d)
{
  if (d->type != MAGGI_SENSOR_COMBINATION) d->nterm = 0;
  return (!d->unit || own_text(arena, &d->unit)) &&
         (d->nterm == 0 || own_texts(arena, &d->terms, d->nterm)) &&
         (d->nterm == 0 || !d->weights || own_numbers(arena, &d->weights, d->nterm));
}

int maggi_design_own(maggi_arena *arena, maggi_design_def *d)
{
  return (!d->unit || own_text(arena, &d->unit)) && own_texts(arena, &d->paths, d->number) &&
         (!d->factors || own_numbers(arena, &d->factors, d->number));
}

/* ----------------------------------------------------------------------------------------- names */

const maggi_objective_def *maggi_model_find_objective(const maggi_model *m, const char *name)
{
  int i;

  for (i = 0; i < m->nobjective; ++i)
    if (strcmp(m->objective[i].name, name) == 0) return &m->objective[i];
  return NULL;
}

int maggi_matches(const char *glob, const char *text)
{
  return fnmatch(glob, text, 0) == 0;
}

int maggi_parameter_match(const maggi_model *m, const char *glob, int from)
{
  for (; from < m->nparameter; ++from)
    if (maggi_matches(glob, m->parameter[from].path)) return from;
  return -1;
}
