/* State sensitivities of whole simulations, maggi_direct_.., against the complex step of the whole
 * simulation (replay.h): q, v, a of all coordinates and all signals at every point of time, along
 * directions of all parameters.  What has to be differentiated (projections, changes of the independent
 * coordinates, ..) is counted: none may be missing. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "course.h"
#include "replay.h"

enum { LANES = 3, GROUPS_MAX = 80 };

/* Difference of real and complex simulation by which derivatives are good to 1e-10; larger ones let them
 * be worse in proportion, up to the one at which nothing is compared any more. */
#define ROUNDOFF 1e-12
#define DIVERGED 3e-11

/* A lane is a direction of the parameters: a design parameter that moves all of them, and a complex
 * simulation. */
typedef struct simulation {
  const course *c;
  const maggi_model *m;
  maggi_data *d;
  maggi_grid grid;
  int np, nsignal;
  int *signal; /* all of them */
  int *group;  /* signals whose derivatives are of one size */
  int ngroup;
  double *x[LANES];
  reference_number *value[LANES]; /* of all signals, at present */
  long samples;                   /* fewer than the grid has when the simulation fails */
} simulation;

static void *room(long n, size_t size)
{
  void *a = calloc((size_t)n + 1, size);

  if (!a) abort();
  return a;
}

static void near(const simulation *s, const char *what, double residual, double limit)
{
  if (!report_near(s->c->seed, what, residual, limit)) fprintf(stderr, "  %s\n", s->c->name);
}

static int succeeds(const simulation *s, const char *what, maggi_status status, const char *message)
{
  if (report_true(s->c->seed, what, status == MAGGI_OK)) return 1;
  fprintf(stderr, "  %s: %s\n", s->c->name, message);
  return 0;
}

/* ----------------------------------------------------------------------------------------- signals */

/* positions, velocities, accelerations, energies, forces, moments, each sensor and each filter */
static int group_of(const simulation *s, int signal)
{
  int n = 3 * s->m->ncoordinate;

  if (signal < n) return signal % 3;
  signal -= n;
  if (signal < 3) return 3;
  signal -= 3;
  if (signal < 6 * s->m->nbody) return 4 + signal % 6 / 3;
  signal -= 6 * s->m->nbody;
  if (signal < s->m->ncolumn) return 6 + s->m->sensorplace[signal] / 3;
  return 6 + s->d->t.nsensor + signal - s->m->ncolumn;
}

static void check_name(const simulation *s, int signal, const char *name, const char *suffix)
{
  char text[260];

  snprintf(text, sizeof text, "%s%s", name, suffix);
  report_true(s->c->seed, "signals have their names and order",
              strcmp(maggi_signal_name(s->m, signal), text) == 0);
}

static void check_names(const simulation *s)
{
  static const char *const motion[3] = {".q", ".v", ".a"};
  static const char *const energy[3] = {"kinetic", "potential", "total"};
  static const char *const wrench[6] = {".fx", ".fy", ".fz", ".mx", ".my", ".mz"};
  int i, n = 0, columns = s->m->ncolumn;

  for (i = 0; i < 3 * s->m->ncoordinate; ++i)
    check_name(s, n++, maggi_coordinate_name(s->m, i / 3), motion[i % 3]);
  for (i = 0; i < 3; ++i) check_name(s, n++, "energy.", energy[i]);
  for (i = 0; i < 6 * s->m->nbody; ++i)
    check_name(s, n++, maggi_body_name(s->m, i / 6), wrench[i % 6]);
  for (i = 0; i < columns; ++i) check_name(s, n++, maggi_sensor_column_name(s->m, i), "");
  for (i = 0; i < s->d->t.nfilter; ++i) check_name(s, n++, maggi_filter_column_name(s->m, i), "");
  report_true(s->c->seed, "signals have their number", n == maggi_signal_number(s->m));
}

/* ---------------------------------------------------------------------------------- state over time */

/* largest errors and derivatives of each group at a point of time; how far round-off has grown */
typedef struct judge {
  double error[GROUPS_MAX], size[GROUPS_MAX], distance;
} judge;

static void judge_sample(judge *j, const simulation *s, const double *y, int stride,
                         const reference_number *z)
{
  double exact, error;
  int i, g;

  for (i = 0; i < s->nsignal; ++i) {
    g = s->group[i];
    exact = (double)(cimagl(z[i]) / REFERENCE_STEP);
    error = fabs(y[i * stride] - exact);
    j->size[g] = fmax(j->size[g], fabs(exact));
    j->error[g] = error <= j->error[g] ? j->error[g] : error;
  }
}

/* Errors relative to the largest derivative until then; where all have been small, to a part of the
 * largest of all times, of forces and moments together, of all sensors.  In proportion to round-off. */
static double judge_worst(const judge *j, const simulation *s, int g)
{
  double all = 0.0, size = 0.0, grown = ROUNDOFF, error, worst = 0.0;
  int i, first = g < 4 ? g : g < 6 ? 4 : 6, last = g < 4 ? g : g < 6 ? 5 : s->ngroup - 1;
  long k;

  for (k = 0; k < s->samples; ++k)
    for (i = first; i <= last; ++i) all = fmax(all, j[k].size[i]);
  for (k = 0; k < s->samples; ++k) {
    size = fmax(size, j[k].size[g]);
    grown = fmax(grown, j[k].distance);
    error = j[k].error[g] > 0.0 ? j[k].error[g] / fmax(size, 1e-3 * all) : j[k].error[g];
    error *= ROUNDOFF / grown;
    worst = error <= worst ? worst : error;
  }
  return worst;
}

static void judge_report(const judge *j, const simulation *s)
{
  static const char *const what[] = {
      "direct: positions", "direct: velocities",        "direct: accelerations",
      "direct: energies",  "direct: reactions, forces", "direct: reactions, moments",
      "direct: sensors"};
  int g;

  for (g = 0; g < s->ngroup; ++g)
    near(s, what[g < 6 ? g : 6], judge_worst(j, s, g) / s->c->precision, 1e-10);
}

/* distance of the real simulation from the complex one, of positions and velocities relative to the
 * largest */
static double distance(const simulation *s, const reference_number *z)
{
  int n = s->m->ncoordinate, i, k;
  double *x = room(2 * n, sizeof *x), error[2] = {0.0}, size[2] = {1.0, 1.0};

  maggi_get_coordinates(s->d, x, x + n, NULL);
  for (i = 0; i < 2 * n; ++i) {
    k = i / n;
    size[k] = fmax(size[k], fabs(x[i]));
    error[k] = fmax(error[k], fabs(x[i] - (double)creall(z[3 * (i % n) + k])));
  }
  free(x);
  return fmax(error[0] / size[0], error[1] / size[1]);
}

static void check_state(const simulation *s, maggi_direct *direct, replay **r, long k, judge **j)
{
  double *y = room(s->nsignal * LANES, sizeof *y), *q = room(s->d->t.nq * LANES, sizeof *q);
  double *v = room(s->d->t.nq * LANES, sizeof *v), *a = room(s->d->t.nq * LANES, sizeof *a);
  const double *row;
  int lane, i, same = 1;

  maggi_direct_get_signals(direct, s->nsignal, s->signal, y);
  maggi_direct_get_coordinates(direct, q, v, a);
  for (i = 0; i < s->m->ncoordinate * LANES; ++i) {
    row = y + i / LANES * 3 * LANES + i % LANES;
    same = same && q[i] == row[0] && v[i] == row[LANES] && a[i] == row[2 * LANES];
  }
  report_true(s->c->seed, "direct: coordinates are signals", same);
  for (lane = 0; lane < LANES; ++lane) {
    replay_values(r[lane], s->value[lane]);
    judge_sample(&j[lane][k], s, y + lane, LANES, s->value[lane]);
  }
  free(y);
  free(q);
  free(v);
  free(a);
}

/* what has occurred, of all simulations */
static struct {
  long early, changes, closures, between, parts, kept, guided, redundant, knees, filters,
      filters_between;
} occurred;

static void count(const maggi_data *d, const replay *r, long bends)
{
  replay_counts n = replay_count(r);
  const maggi_topo *t = &d->t;
  int rows = t->nrow;

  occurred.changes += n.changes;
  occurred.closures += n.closures;
  occurred.between += n.between;
  occurred.parts += n.parts;
  occurred.kept += d->is_kept;
  occurred.guided += t->nguide > 0;
  occurred.redundant += rows > t->ndep;
  occurred.knees += bends;
  occurred.filters += t->nfilter > 0;
  occurred.filters_between += t->nfilter > 0 && n.between > 0;
}

/* Direct differentiation and complex simulations side by side.  Where motions diverge so
 * much that round-off of the real simulation becomes large, nothing more can be said; nor where a damper
 * stays at its knee. */
static void check_motion(simulation *s, maggi_direct *direct, replay **r)
{
  judge *j[LANES];
  maggi_status status = MAGGI_OK, other;
  double h, error = 0.0, margin;
  long k, was = course_segments(s->d, &margin), bends = 0;
  int lane;

  for (lane = 0; lane < LANES; ++lane) j[lane] = room(s->grid.steps, sizeof *j[lane]);
  for (k = 0; margin > COURSE_KNEE; ++k) {
    check_state(s, direct, r, k, j);
    error = distance(s, s->value[0]) / s->c->precision;
    for (lane = 0; lane < LANES; ++lane) j[lane][k].distance = error;
    near(s, "values of the complex simulation", error, 1e-7);
    if (k == s->grid.steps || error > DIVERGED) break;
    h = maggi_grid_time(&s->grid, k + 1) - maggi_grid_time(&s->grid, k);
    status = maggi_direct_step(direct, h);
    for (lane = 0; lane < LANES; ++lane) {
      other = replay_step(r[lane], h);
      report_true(s->c->seed, "direct: fails when the simulation fails", status == other);
    }
    if (status != MAGGI_OK) break;
    bends += course_segments(s->d, &margin) != was;
    was = course_segments(s->d, &margin);
  }
  s->samples = k + (k == s->grid.steps || status != MAGGI_OK);
  occurred.early += s->samples < s->grid.steps;
  if (s->c->seed == 0) report_true(0, "models do not diverge", s->samples > s->grid.steps);
  for (lane = 0; lane < LANES; ++lane) {
    judge_report(j[lane], s);
    free(j[lane]);
  }
  count(s->d, r[0], bends);
}

static int check_direct(simulation *s)
{
  maggi_design *design = course_design(s->c, LANES, s->x);
  maggi_direct *direct;
  replay *r[LANES] = {NULL};
  int lane, ok = 1;

  for (lane = 0; lane < LANES && ok; ++lane) {
    r[lane] = replay_create(s->d, s->x[lane]);
    ok = r[lane] != NULL;
  }
  if (!ok) {
    report_count("not replayed: not at the initial positions");
  } else if (maggi_direct_create(s->d, design, &direct) != MAGGI_OK) {
    ok = succeeds(s, "direct: create", MAGGI_E_MEMORY, "");
  } else {
    ok = succeeds(s, "direct: reset", maggi_direct_reset(direct), maggi_data_message(s->d));
    if (ok) check_motion(s, direct, r);
    maggi_direct_free(direct);
  }
  for (lane = 0; lane < LANES; ++lane) replay_free(r[lane]);
  maggi_design_free(design);
  return ok;
}

/* --------------------------------------------------------------------------------------------- main */

static void check_course(const course *c)
{
  simulation s = {.c = c, .m = c->data->m};
  mech_random random = {c->seed + 1000};
  int lane, i;

  s.d = replay_copy(c->data);
  s.np = s.d->t.np;
  s.nsignal = maggi_signal_number(s.m);
  s.signal = room(s.nsignal, sizeof *s.signal);
  s.group = room(s.nsignal, sizeof *s.group);
  for (i = 0; i < s.nsignal; ++i) {
    s.signal[i] = i;
    s.group[i] = group_of(&s, i);
  }
  s.ngroup = 6 + s.d->t.nsensor + s.d->t.nfilter;
  if (s.ngroup > GROUPS_MAX || maggi_grid_init(&s.grid, c->steps * c->step, c->step) != MAGGI_OK)
    abort();
  check_names(&s);
  for (lane = 0; lane < LANES; ++lane) {
    s.x[lane] = course_direction(c, &random);
    s.value[lane] = room(s.nsignal, sizeof *s.value[lane]);
  }
  check_direct(&s);
  for (lane = 0; lane < LANES; ++lane) {
    free(s.x[lane]);
    free(s.value[lane]);
  }
  maggi_data_free(s.d);
  free(s.signal);
  free(s.group);
}

int main(int argc, char **argv)
{
  report_options options = {1, 112, 0};

  if (!report_parse(argc, argv, &options)) return 2;
  course_each(&options, check_course);
  if (options.count >= 112) {
    report_true(0, "few simulations diverge", occurred.early < options.count / 8);
    report_true(0, "independent coordinates were changed", occurred.changes > 0);
    report_true(0, "loops were projected", occurred.closures > 0);
    report_true(0, "states between two nodes", occurred.between > 0);
    report_true(0, "steps in parts", occurred.parts > 0);
    report_true(0, "starts with other independent coordinates than loops are closed with",
                occurred.kept > 0);
    report_true(0, "guided motion", occurred.guided > 0);
    report_true(0, "redundant loops", occurred.redundant > 0);
    report_true(0, "knees of dampers were crossed", occurred.knees > 0);
    report_true(0, "filters", occurred.filters > 30);
    report_true(0, "filters between two nodes", occurred.filters_between > 0);
  }
  return report_done("derivative_simulation");
}
