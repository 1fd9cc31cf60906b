#include "course.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef DERIVATIVE_YAML
#include <dirent.h>
#endif

#include "property/subject.h"
#include "property/vector.h"

long course_segments(const maggi_data *d, double *margin)
{
  const maggi_topo *t = &d->t;
  double e[3], ev[3], rate, knee[3] = {0.0, 0.0, 0.0};
  long code = 0;
  int i, k;

  *margin = INFINITY;
  for (i = 0; i < t->nspring; ++i) {
    if (!t->springslopes[i]) continue;
    v3_axpy(d->r[t->springpa[i]], -1.0, d->r[t->springpb[i]], e);
    v3_axpy(d->rv[t->springpa[i]], -1.0, d->rv[t->springpb[i]], ev);
    rate = v3_dot(e, ev) / v3_norm(e);
    knee[1] = d->p[t->springadr[i] + MAGGI_SPRING_SLOPES + 4];
    knee[2] = d->p[t->springadr[i] + MAGGI_SPRING_SLOPES + 5];
    for (k = 0; k < 3; ++k) {
      code = 2 * code + (rate > knee[k]);
      *margin = fmin(*margin, fabs(rate - knee[k]));
    }
  }
  return code;
}

static void *room(int n, size_t size)
{
  void *a = calloc((size_t)n + 1, size);

  if (!a) abort();
  return a;
}

double *course_direction(const course *c, mech_random *random)
{
  const maggi_data *d = c->data;
  double *x = room(d->t.np, sizeof *x), size;
  int i;

  for (i = 0; i < d->t.np; ++i) {
    size = fabs(d->p[i]);
    x[i] = mech_uniform(random, -1.0, 1.0) * (size > 0.0 ? size : 0.1);
    if (!strstr(maggi_parameter_path(d->m, i), c->paths)) x[i] = 0.0;
  }
  return x;
}

maggi_design *course_design(const course *c, int n, double *const *x)
{
  const maggi_data *d = c->data;
  const char **path = room(d->t.np, sizeof *path);
  double *factor = room(d->t.np, sizeof *factor);
  char name[32], message[300];
  maggi_design *design;
  maggi_design_def def;
  int k, i;

  if (maggi_design_create(d, &design) != MAGGI_OK) abort();
  for (k = 0; k < n; ++k) {
    snprintf(name, sizeof name, "direction%d", k);
    maggi_design_def_init(&def);
    def.name = name;
    def.paths = path;
    def.factors = factor;
    for (i = 0; i < d->t.np; ++i) {
      if (x[k][i] == 0.0) continue;
      path[def.number] = maggi_parameter_path(d->m, i);
      factor[def.number++] = x[k][i];
    }
    if (!report_true(c->seed, "a design parameter of all entries is accepted",
                     maggi_design_add(design, &def, message, sizeof message) == MAGGI_OK))
      fprintf(stderr, "  %s: %s\n", c->name, message);
  }
  free(path);
  free(factor);
  return design;
}

/* ------------------------------------------------------------------------------ random mechanisms */

/* The motion of the subject as an initial state: velocities of independent coordinates, and some
 * positions.  One of a dependent coordinate may leave no choice but to start with other independent
 * coordinates than loops are closed with. */
static void prescribe(subject *s, mech_random *g)
{
  double q[MECH_COORDINATES], v[MECH_COORDINATES];
  int independent[MECH_COORDINATES], i, k, dependent = 0;
  maggi_data *d = s->data;

  maggi_get_coordinates(d, q, v, NULL);
  for (i = 0; i < s->m.nq; ++i) independent[i] = maggi_coordinate_is_independent(d, i);
  for (i = 0; i < s->m.nq; ++i) {
    k = s->model->coordinate[i].q;
    if (independent[i]) maggi_data_set_parameter(d, s->model->initial_velocity[k], v[i]);
    if (s->model->initial_position[k] < 0) continue;
    if (independent[i] ? mech_integer(g, 3) == 0 : mech_integer(g, 4) == 0 && !dependent++)
      maggi_data_set_parameter(d, s->model->initial_position[k], q[i]);
  }
}

static void check_random(uint64_t seed, int verbose, course_check *check)
{
  subject *s = calloc(1, sizeof *s);
  mech_random g = {seed * 7919u};
  char name[40];
  course c = {name, seed, NULL, "", 1.0, 0.0, 40};

  if (!s) abort();
  snprintf(name, sizeof name, "seed %llu", (unsigned long long)seed);
  if (verbose) printf("%s: %s\n", name, mech_kind_text((mech_kind)(seed % MECH_KINDS)));
  if (subject_create(seed, s)) {
    prescribe(s, &g);
    /* small steps seldom open loops, large ones always; they also reach bad independent coordinates */
    c.step = mech_integer(&g, 2) ? 1e-3 : 6e-3;
    if (mech_integer(&g, 2)) maggi_data_set_tolerance(s->data, 1e-10);
    c.data = s->data;
    check(&c);
  }
  subject_free(s);
  free(s);
}

/* ----------------------------------------------------------------------------------- four-bars */

static void check_model(const char *name, maggi_model *m, double precision, double step, long steps,
                        course_check *check)
{
  course c = {name, 0, NULL, "", precision, step, steps};

  if (maggi_data_create(m, &c.data) != MAGGI_OK) abort();
  check(&c);
  maggi_data_free(c.data);
}

static void check_multiple(const char *name, int ny, int nz, course_check *check)
{
  maggi_model *m;

  if (maggi_model_multiple_four_bar(ny, nz, &m) != MAGGI_OK) abort();
  check_model(name, m, 1.0, 1e-3, 60, check);
  maggi_model_free(m);
}

static void add_bar(maggi_builder *b, const char *name, const char *parent, double y0, double z0,
                    double y1, double z1)
{
  maggi_body_def d;

  maggi_body_def_init(&d);
  d.name = name;
  d.parent = parent;
  d.mass = 1.0;
  d.is_bar = 1;
  d.point[1] = d.bar_from[1] = y0;
  d.point[2] = d.bar_from[2] = z0;
  d.bar_to[1] = y1;
  d.bar_to[2] = z1;
  maggi_builder_body(b, &d);
}

/* "drive": a body that a function of that name guides */
static void add_guided(maggi_builder *b)
{
  const double values[4] = {0.3, 2.0, 0.0, 0.0};
  maggi_function_def function;
  maggi_body_def body;

  maggi_function_def_init(&function);
  function.name = "drive";
  function.type = MAGGI_FUNCTION_SINE;
  function.number = 4;
  function.values = values;
  maggi_builder_function(b, &function);
  maggi_body_def_init(&body);
  body.name = body.motion[0] = "drive";
  body.mass = 1.0;
  body.cog[1] = 0.5;
  maggi_builder_body(b, &body);
}

/* "drive": its acceleration and what a filter makes of that */
static void add_filter(maggi_builder *b)
{
  maggi_sensor_def sensor;
  maggi_filter_def filter;

  maggi_sensor_def_init(&sensor);
  sensor.name = sensor.body = "drive";
  sensor.type = MAGGI_SENSOR_ACCELERATION;
  sensor.point[1] = 1.0;
  maggi_builder_sensor(b, &sensor);
  maggi_filter_def_init(&filter);
  maggi_filter_def_weighting(&filter, MAGGI_WEIGHTING_WK);
  filter.name = "drive";
  filter.signal = "drive.z";
  filter.f2 = 10.0;
  maggi_builder_filter(b, &filter);
}

/* Turns evenly, by 1 rad/s, without gravity, into the flat position where its loop is singular, at the
 * end of a step or amid it.  What moves is a spring, which is none, and the guide of another body: so it
 * stays a parallelogram. */
static void check_parallelogram(const char *name, double before, double precision,
                                course_check *check)
{
  const double none[3] = {0.0, 0.0, 0.0}, y = cos(before), z = -sin(before);
  maggi_joint_spring_def spring;
  maggi_loop_def loop;
  maggi_builder *b;
  maggi_model *m;
  course c = {name, 0, NULL, "s.drive.", precision, 1e-2, 30 + (long)(100.0 * before)};
  int velocity;

  if (maggi_builder_create("parallelogram", &b) != MAGGI_OK) abort();
  maggi_builder_gravity(b, none);
  add_bar(b, "crank", MAGGI_GROUND, 0.0, 0.0, y, z);
  add_bar(b, "coupler", "crank", y, z, 2.0 + y, z);
  add_bar(b, "follower", MAGGI_GROUND, 2.0, 0.0, 2.0 + y, z);
  add_guided(b);
  add_filter(b);
  maggi_loop_def_init(&loop);
  loop.name = "pin";
  loop.type = MAGGI_LOOP_REVOLUTE;
  loop.body_a = "coupler";
  loop.body_b = "follower";
  loop.point_a[1] = 2.0 + y;
  loop.point_a[2] = z;
  loop.axis_a[0] = 1.0;
  maggi_builder_loop(b, &loop);
  maggi_joint_spring_def_init(&spring);
  spring.name = "drive";
  spring.coordinate = "crank";
  maggi_builder_joint_spring(b, &spring);
  if (maggi_model_create(b, &m) != MAGGI_OK || maggi_data_create(m, &c.data) != MAGGI_OK) abort();
  velocity = maggi_parameter_find(m, "bodies.crank.joint.velocity");
  if (maggi_data_set_parameter(c.data, velocity, 1.0) != MAGGI_OK) abort();
  check(&c);
  maggi_data_free(c.data);
  maggi_model_free(m);
  maggi_builder_free(b);
}

/* ---------------------------------------------------------------------------------- model files */

#ifdef DERIVATIVE_YAML
/* large models, those whose loops stay closed at their own step, one with small pivots, a stiff one */
static const struct {
  const char *file;
  double precision, step;
  long steps;
} own[] = {{"slider-crank.yaml", 1.0, 0.02, 150},
           {"spatial-four-bar.yaml", 1.0, 0.005, 150},
           {"chain-30.yaml", 1.0, 0.001, 40},
           {"flyball-governor.yaml", 100.0, 0.0001, 100},
           {"n-four-bar-40.yaml", 10.0, 0.001, 40}};

static void check_file(const char *file, course_check *check)
{
  char path[512], message[512];
  maggi_model_info info;
  maggi_model *m;
  double precision = 1.0, step;
  long steps = 100;
  size_t i;

  snprintf(path, sizeof path, "%s/%s", MAGGI_MODELS_DIR, file);
  if (!report_true(0, "a model file is loaded",
                   maggi_model_load(path, &m, message, sizeof message) == MAGGI_OK)) {
    fprintf(stderr, "%s\n", message);
    return;
  }
  maggi_model_get_info(m, &info);
  step = info.simulation.step > 0.0 ? info.simulation.step : 1e-3;
  for (i = 0; i < sizeof own / sizeof *own; ++i) {
    if (strcmp(own[i].file, file) != 0) continue;
    precision = own[i].precision;
    step = own[i].step;
    steps = own[i].steps;
  }
  check_model(file, m, precision, step, steps, check);
  maggi_model_free(m);
}

static int is_model(const struct dirent *entry)
{
  const char *end = strrchr(entry->d_name, '.');

  return end && strcmp(end, ".yaml") == 0;
}

static void check_files(course_check *check)
{
  struct dirent **file = NULL;
  int i, n = scandir(MAGGI_MODELS_DIR, &file, is_model, alphasort);

  report_true(0, "there are models", n > 0);
  for (i = 0; i < n; ++i) {
    check_file(file[i]->d_name, check);
    free(file[i]);
  }
  free(file);
}
#endif

void course_each(const report_options *options, course_check *check)
{
  long i;

  if (!options->verbose) {
#ifdef DERIVATIVE_YAML
    check_files(check);
#endif
    check_multiple("multiple-four-bar:1x15", 1, 15, check);
    check_multiple("multiple-four-bar:2x3", 2, 3, check);
    check_parallelogram("parallelogram, flat at the end of a step", 1.2005, 1e6, check);
    check_parallelogram("parallelogram, flat amid a step", 0.205, 1e3, check);
  }
  for (i = 0; i < options->count; ++i)
    check_random(options->from + (uint64_t)i, options->verbose, check);
}
