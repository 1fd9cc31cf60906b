/* The coach (models/coach): state sensitivities and gradients of whole manoeuvres that begin at static
 * equilibrium and rolling, against the complex step of all of it (replay.h), start included.
 *
 *   state      q, v, a of all coordinates at every point of time, by each declared design parameter, those
 *              of table 5.5 of the thesis among them, and along directions of all parameters
 *   objectives direct and adjoint against the complex step and against each other
 *
 * Running straight, many derivatives are zero by symmetry, so errors are relative to at least SMALL of the
 * derivative by the most relevant parameter, both times the size of their parameter: 1e-14 of that is
 * round-off.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "aim.h"
#include "course.h"
#include "design.h"
#include "replay.h"

#define SMALL       1e-4
#define STATES      1e-9
#define OBJECTIVES  1e-9
#define DIRECT_LIKE 1e-10

enum { DIRECTIONS = 2, SETTINGS = 5, KINDS = 3, AIMS = 9 };

typedef struct setting {
  const char *path;
  double value;
} setting;

typedef struct manoeuvre {
  const char *file;
  int first, number; /* declared design parameters */
  long steps;
  int naim; /* the norm of what is zero by symmetry has no derivative */
  setting set[SETTINGS];
} manoeuvre;

/* What happens after seconds happens at once.  Knots are between the ends of steps: there the jerk, which the
 * derivative by their times has, jumps.  Bumps have rounded edges. */
static const manoeuvre manoeuvres[] = {
    {"turn", 19, 38, 100, AIMS, {{NULL, 0.0}}},
    {"relevance", 19, 36, 100, AIMS - 2, {{NULL, 0.0}}}, /* straight on */
    {"double-lane-change",
     0,
     21,
     100,
     AIMS,
     {{"functions.steering.times.1", -0.0104},
      {"functions.steering.times.2", 0.0503},
      {"functions.steering.times.3", 0.0807},
      {"functions.steering.times.4", 0.2006}}},
    {"bumps", 0, 20, 100, AIMS - 2, {{"roads.road.first", 0.7}, {"roads.road.fillet", 0.05}}},
};

static const struct {
  maggi_objective_type type;
  const char *signal;
} aims[AIMS] = {{MAGGI_OBJECTIVE_INTEGRAL_SQUARE, "bodywork_acceleration.z"}, /* eq. 5.10 */
                {MAGGI_OBJECTIVE_INTEGRAL, "rear.roll"},
                {MAGGI_OBJECTIVE_TERMINAL, "rear_rates.roll_rate"},
                {MAGGI_OBJECTIVE_INTEGRAL, "rear_rates.yaw_rate"},
                {MAGGI_OBJECTIVE_INTEGRAL, "lateral.planar"},
                {MAGGI_OBJECTIVE_MEAN, "RRo.fz"},
                {MAGGI_OBJECTIVE_TERMINAL, "FL.fy"},
                {MAGGI_OBJECTIVE_NORM, "rear.roll"},
                {MAGGI_OBJECTIVE_NORM, "lateral.planar"}};

typedef struct study {
  const manoeuvre *of;
  maggi_model *m;
  maggi_data *d;
  course c;
  maggi_design *design;
  int nlane, np, nsignal;
  double **x;                            /* direction of all parameters, one for each lane */
  double *size;                          /* of the number that the lane changes */
  reference_number **value;              /* of all signals over time */
  double *error[KINDS], *largest[KINDS]; /* of q, v, a of each lane over time */
  aim aim[AIMS];
} study;

static void *room(long n, size_t size)
{
  void *a = calloc((size_t)n + 1, size);

  if (!a) abort();
  return a;
}

static int succeeds(const study *s, const char *what, maggi_status status, const char *message)
{
  if (report_true(0, what, status == MAGGI_OK)) return 1;
  fprintf(stderr, "  %s: %s\n", s->of->file, message);
  return 0;
}

static void near(const study *s, const char *what, const char *of, double residual, double limit)
{
  if (!report_near(0, what, residual, limit)) fprintf(stderr, "  %s: %s\n", s->of->file, of);
}

/* ------------------------------------------------------------------------------------------- lanes */

/* Directions of all entries in their own size, then the declared parameters.  Without initial velocities:
 * dampers are at the knee between compression and rebound at first, where these have no derivative;
 * `speed` is declared. */
static void choose_lanes(study *s)
{
  mech_random random = {4711};
  double *along[DIRECTIONS];
  char message[300];
  const char *name;
  int lane, i;

  s->c = (course){s->of->file, 0, s->d, "", 1.0, 1e-3, s->of->steps};
  for (lane = 0; lane < DIRECTIONS; ++lane) {
    along[lane] = course_direction(&s->c, &random);
    for (i = 0; i < s->np; ++i)
      if (strstr(maggi_parameter_path(s->m, i), ".joint.velocity")) along[lane][i] = 0.0;
  }
  s->design = course_design(&s->c, DIRECTIONS, along);
  for (i = 0; i < DIRECTIONS; ++i) free(along[i]);
  for (i = s->of->first; (name = maggi_model_design(s->m, i)); ++i)
    succeeds(s, "a declared design parameter",
             maggi_design_select(s->design, name, message, sizeof message), message);
  report_true(0, "declared design parameters have their number", i == s->of->first + s->of->number);
  s->nlane = maggi_design_number(s->design);
  s->x = room(s->nlane, sizeof *s->x);
  s->size = room(s->nlane, sizeof *s->size);
  for (lane = 0; lane < s->nlane; ++lane) {
    s->x[lane] = room(s->np, sizeof **s->x);
    maggi_design_directions(s->design, lane, 1, 1, s->x[lane]);
    s->size[lane] = fabs(maggi_design_value(s->design, lane));
    if (lane < DIRECTIONS || s->size[lane] == 0.0) s->size[lane] = 1.0;
  }
}

static reference_number *simulate(study *s, const double *x)
{
  reference_number *values = room((s->of->steps + 1) * s->nsignal, sizeof *values);
  replay *r = replay_create(s->d, x);
  long k;

  for (k = 0; r && k <= s->of->steps; ++k) {
    replay_values(r, values + k * s->nsignal);
    if (k < s->of->steps && replay_step(r, s->c.step) != MAGGI_OK) {
      replay_free(r);
      r = NULL;
    }
  }
  if (!report_true(0, "a manoeuvre is replayed", r != NULL))
    fprintf(stderr, "  %s: at step %ld\n", s->of->file, k);
  replay_free(r);
  return values;
}

/* ------------------------------------------------------------------------------------------ states */

/* All coordinates at step k */
static void compare_states(study *s, maggi_direct *direct, long k)
{
  int n = s->m->ncoordinate, kind, lane, i;
  double *y[KINDS], exact;

  for (kind = 0; kind < KINDS; ++kind) y[kind] = room(n * s->nlane, sizeof(double));
  maggi_direct_get_coordinates(direct, y[0], y[1], y[2]);
  for (kind = 0; kind < KINDS; ++kind) {
    for (i = 0; i < n * s->nlane; ++i) {
      lane = i % s->nlane;
      exact = (double)(cimagl(s->value[lane][k * s->nsignal + 3 * (i / s->nlane) + kind]) /
                       REFERENCE_STEP);
      s->largest[kind][lane] = fmax(s->largest[kind][lane], fabs(exact));
      s->error[kind][lane] = fmax(s->error[kind][lane], fabs(y[kind][i] - exact));
    }
    free(y[kind]);
  }
}

static void check_states(study *s)
{
  static const char *const what[KINDS] = {"dq/db", "dv/db", "da/db"};
  double most, scale;
  maggi_direct *direct;
  int kind, lane;
  long k;

  if (!succeeds(s, "direct: create", maggi_direct_create(s->d, s->design, &direct), "")) return;
  succeeds(s, "direct: reset", maggi_direct_reset(direct), maggi_data_message(s->d));
  for (kind = 0; kind < KINDS; ++kind) {
    s->error[kind] = room(s->nlane, sizeof(double));
    s->largest[kind] = room(s->nlane, sizeof(double));
  }
  for (k = 0; k <= s->of->steps; ++k) {
    compare_states(s, direct, k);
    if (k < s->of->steps)
      succeeds(s, "direct: a step", maggi_direct_step(direct, s->c.step), maggi_data_message(s->d));
  }
  for (kind = 0; kind < KINDS; ++kind) {
    most = 0.0;
    for (lane = 0; lane < s->nlane; ++lane)
      most = fmax(most, s->size[lane] * s->largest[kind][lane]);
    for (lane = 0; lane < s->nlane; ++lane) {
      scale = fmax(s->largest[kind][lane], SMALL * most / s->size[lane]);
      near(s, what[kind], maggi_design_name(s->design, lane), s->error[kind][lane] / scale, STATES);
    }
    free(s->error[kind]);
    free(s->largest[kind]);
  }
  maggi_direct_free(direct);
}

/* -------------------------------------------------------------------------------------- objectives */

static int gradient(study *s, maggi_method method, double *value, double *g)
{
  maggi_objective *objective[AIMS];
  maggi_gradient_options options;
  int i;

  maggi_gradient_options_init(&options);
  options.time = s->of->steps * s->c.step;
  options.step = s->c.step;
  options.method = method;
  for (i = 0; i < s->of->naim; ++i) objective[i] = s->aim[i].objective;
  return succeeds(s, "a gradient is computed",
                  maggi_gradient(s->d, s->design, s->of->naim, objective, &options, value, g),
                  maggi_data_message(s->d));
}

static void choose_aims(study *s)
{
  char message[300];
  aim *a;
  int i;

  for (i = 0; i < s->of->naim; ++i) {
    a = &s->aim[i];
    maggi_objective_def_init(&a->def);
    a->def.type = aims[i].type;
    a->def.name = a->def.signal = aims[i].signal;
    a->signal[0] = maggi_signal_find(s->m, aims[i].signal);
    succeeds(s, "the objective is accepted",
             maggi_objective_create(s->m, &a->def, &a->objective, message, sizeof message),
             message);
  }
}

static void check_objectives(study *s)
{
  double *g[2], value[AIMS], exact, scale, most;
  trace whole = {s->c.step, s->of->steps, s->nsignal, NULL};
  int i, lane, k;

  choose_aims(s);
  for (i = 0; i < 2; ++i) g[i] = room(AIMS * s->nlane, sizeof(double));
  if (gradient(s, MAGGI_METHOD_DIRECT, value, g[0]) &&
      gradient(s, MAGGI_METHOD_ADJOINT, value, g[1])) {
    for (i = 0; i < s->of->naim; ++i) {
      most = 0.0;
      for (lane = 0; lane < s->nlane; ++lane)
        most = fmax(most, s->size[lane] * fabs(g[0][i * s->nlane + lane]));
      for (lane = 0; lane < s->nlane; ++lane) {
        k = i * s->nlane + lane;
        whole.values = s->value[lane];
        exact = (double)(cimagl(aim_outcome(&s->aim[i], &whole)) / REFERENCE_STEP);
        scale = fmax(fabs(exact), SMALL * most / s->size[lane]);
        near(s, "direct", aims[i].signal, fabs(g[0][k] - exact) / scale, OBJECTIVES);
        near(s, "adjoint", aims[i].signal, fabs(g[1][k] - exact) / scale, OBJECTIVES);
        near(s, "direct - adjoint", aims[i].signal, fabs(g[0][k] - g[1][k]) / scale, DIRECT_LIKE);
      }
    }
  }
  for (i = 0; i < s->of->naim; ++i) maggi_objective_free(s->aim[i].objective);
  free(g[0]);
  free(g[1]);
}

/* -------------------------------------------------------------------------------------------- main */

static int load(study *s)
{
  char path[512], message[512] = "";
  const setting *set;
  int i;

  snprintf(path, sizeof path, "%s/coach/%s.yaml", MAGGI_MODELS_DIR, s->of->file);
  if (!succeeds(s, "the model is loaded", maggi_model_load(path, &s->m, message, sizeof message),
                message) ||
      !succeeds(s, "create", maggi_data_create(s->m, &s->d), ""))
    return 0;
  for (set = s->of->set; set->path; ++set) {
    i = maggi_parameter_find(s->m, set->path);
    if (!succeeds(s, "a number is set", maggi_data_set_parameter(s->d, i, set->value), set->path))
      return 0;
  }
  s->np = s->d->t.np;
  s->nsignal = maggi_signal_number(s->m);
  return 1;
}

static void check_manoeuvre(const manoeuvre *of)
{
  study s = {.of = of};
  int lane;

  if (load(&s)) {
    choose_lanes(&s);
    s.value = room(s.nlane, sizeof *s.value);
    for (lane = 0; lane < s.nlane; ++lane) s.value[lane] = simulate(&s, s.x[lane]);
    check_states(&s);
    check_objectives(&s);
    for (lane = 0; lane < s.nlane; ++lane) {
      free(s.x[lane]);
      free(s.value[lane]);
    }
    free(s.x);
    free(s.size);
    free(s.value);
    maggi_design_free(s.design);
  }
  maggi_data_free(s.d);
  maggi_model_free(s.m);
}

int main(int argc, char **argv)
{
  size_t i;

  for (i = 0; i < sizeof manoeuvres / sizeof *manoeuvres; ++i)
    if (argc == 2 && strcmp(argv[1], manoeuvres[i].file) == 0) {
      check_manoeuvre(&manoeuvres[i]);
      return report_done("derivative_coach");
    }
  fprintf(stderr, "derivative_coach MANOEUVRE\n");
  return 2;
}
