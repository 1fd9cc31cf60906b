#include "subject.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "data.h"
#include "report.h"
#include "vector.h"

enum { ATTEMPTS = 25 };

/* largest velocity of a coordinate at the start [rad/s, m/s] */
static const double fastest = 1.5;
/* a loop is close to singular when unit independent velocities make dependent ones this large, and
 * a guide drives it too fast when its own velocity does */
static const double largest_ratio = 20.0, too_fast = 4.0;

static void say(const subject *s, const char *what, const char *message)
{
  fprintf(stderr, "seed %llu: %s: %s: %s\n", (unsigned long long)s->m.seed,
          mech_kind_text(s->m.kind), what, message);
}

void subject_free(subject *s)
{
  maggi_data_free(s->data);
  maggi_model_free(s->model);
  s->data = NULL;
  s->model = NULL;
}

int subject_build(subject *s, mech_random *shuffle)
{
  char message[300];

  s->model = NULL;
  s->data = NULL;
  if (mech_build(&s->m, shuffle, &s->model, message, sizeof message) != MAGGI_OK) {
    say(s, "the model is refused", message);
    report_true(s->m.seed, "the model is accepted", 0);
    return 0;
  }
  if (!report_true(s->m.seed, "all names are found",
                   mech_coordinate_map(&s->m, s->model, s->q) &&
                       mech_body_map(&s->m, s->model, s->body)))
    return 0;
  return report_true(s->m.seed, "simulation created",
                     maggi_data_create(s->model, &s->data) == MAGGI_OK &&
                         maggi_data_set_tolerance(s->data, SUBJECT_TOLERANCE) == MAGGI_OK);
}

int subject_set(subject *s, double t, const double *q, const double *v)
{
  double fq[MECH_COORDINATES], fv[MECH_COORDINATES];
  int i;

  for (i = 0; i < s->m.nq; ++i) {
    fq[s->q[i]] = q[i];
    fv[s->q[i]] = v[i];
  }
  if (maggi_data_set_state(s->data, t, fq, fv) == MAGGI_OK) return 1;
  say(s, "set_state", maggi_data_message(s->data));
  return 0;
}

int subject_reset(subject *s)
{
  if (maggi_data_reset(s->data) == MAGGI_OK) return 1;
  say(s, "reset", maggi_data_message(s->data));
  return 0;
}

static void sort_out(const subject *s, const double *from, double *to)
{
  int i;

  for (i = 0; to && i < s->m.nq; ++i) to[i] = from[s->q[i]];
}

void subject_get(const subject *s, double *q, double *v, double *a)
{
  double fq[MECH_COORDINATES], fv[MECH_COORDINATES], fa[MECH_COORDINATES];

  maggi_get_coordinates(s->data, fq, fv, fa);
  sort_out(s, fq, q);
  sort_out(s, fv, v);
  sort_out(s, fa, a);
}

int subject_steps(subject *s, int n, double h)
{
  int i;

  for (i = 0; i < n; ++i) {
    if (maggi_step(s->data, h) == MAGGI_OK) continue;
    say(s, "step", maggi_data_message(s->data));
    return report_true(s->m.seed, "every step succeeds", 0);
  }
  return report_true(s->m.seed, "every step succeeds", 1);
}

/* ------------------------------------------------------------------------------- the start */

static double largest(const double *x, int n)
{
  double y = 0.0;
  int i;

  for (i = 0; i < n; ++i) y = fmax(y, fabs(x[i]));
  return y;
}

/* coordinate of the model that belongs to a column of R_z */
static int column_coordinate(const subject *s, int column)
{
  int i = 0;

  while (s->model->coordinate[i].q != s->data->t.colq[column]) ++i;
  return i;
}

static double largest_column(const subject *s)
{
  int n = s->m.nq * subject_columns(s);
  double *R = malloc(((size_t)n + 1) * sizeof *R), y;

  subject_velocity_columns(s, R);
  y = largest(R, n);
  free(R);
  return y;
}

static int random_velocities(subject *s)
{
  mech_random g = {s->m.seed * 77777u + 5u};
  double q[MECH_COORDINATES], v[MECH_COORDINATES], most;
  int i;

  subject_get(s, q, v, NULL);
  for (i = 0; i < s->m.nq; ++i) v[i] = mech_uniform(&g, -1.0, 1.0);
  if (!subject_set(s, 0.0, q, v)) return 0;
  subject_get(s, q, v, NULL);
  most = largest(v, s->m.nq);
  for (i = 0; i < s->m.nq && most > fastest; ++i) v[i] *= fastest / most;
  return subject_set(s, 0.0, q, v);
}

/* guides contradict the loops, whatever their rates are now, or set them in violent motion */
static int is_forced(const subject *s)
{
  int rows = subject_jacobian(s, NULL), n = subject_columns(s), nq = s->m.nq, i, k, c;
  double *phi = calloc((size_t)(rows * nq) + 1, sizeof *phi);
  double *R = calloc((size_t)(nq * n) + 1, sizeof *R);
  double v[MECH_COORDINATES], sum, open = 0.0;

  if (!phi || !R) abort();
  subject_jacobian(s, phi);
  subject_velocity_columns(s, R);
  for (i = 0; i < rows; ++i) {
    for (c = 0; c < n; ++c) {
      sum = 0.0;
      for (k = 0; k < nq; ++k) sum += phi[i * nq + k] * R[k * n + c];
      /* of the other columns it is a failure, which property_random reports */
      if (!maggi_coordinate_is_independent(s->data, column_coordinate(s, c)))
        open = fmax(open, fabs(sum));
    }
  }
  free(phi);
  free(R);
  subject_get(s, NULL, v, NULL);
  return open > 1e-6 || largest(v, nq) > too_fast;
}

/* 1: moves, 0: another attempt, -1: a failure that has been reported */
static int try_start(subject *s)
{
  maggi_loop_state state;
  maggi_status status;

  if (!subject_build(s, NULL)) return -1;
  status = maggi_data_reset(s->data);
  if (status == MAGGI_E_ASSEMBLY && s->m.kind == MECH_LOOPS_OPEN) {
    report_count("generated anew: opened too far to be assembled");
    return 0;
  }
  if (status == MAGGI_E_ASSEMBLY &&
      strstr(maggi_data_message(s->data), "guided motions contradict")) {
    report_count("generated anew: guides force the loops, refused");
    return 0;
  }
  if (status != MAGGI_OK) {
    say(s, "reset", maggi_data_message(s->data));
    report_true(s->m.seed, "reset succeeds", 0);
    return -1;
  }
  maggi_get_loop_state(s->data, &state);
  if (state.dof == 0) {
    report_count("generated anew: cannot move");
    return 0;
  }
  if (largest_column(s) > largest_ratio) {
    report_count("generated anew: close to singular");
    return 0;
  }
  if (!report_true(s->m.seed, "random velocities are completed", random_velocities(s))) return -1;
  if (is_forced(s)) {
    report_count("generated anew: guides force the loops");
    return 0;
  }
  return 1;
}

int subject_create(uint64_t seed, subject *s)
{
  int attempt, result;

  for (attempt = 0; attempt < ATTEMPTS; ++attempt) {
    mech_generate(seed, attempt, &s->m);
    result = try_start(s);
    if (result > 0) return 1;
    subject_free(s);
    if (result < 0) return 0;
  }
  return report_true(seed, "the seed gives a mechanism that moves", 0);
}

/* ------------------------------------------------------------------------------- the inside */

/* internal coordinate of one of the description */
static int inner(const subject *s, int q)
{
  return s->model->coordinate[s->q[q]].q;
}

int subject_columns(const subject *s)
{
  return s->data->t.ncol;
}

void subject_velocity_columns(const subject *s, double *R)
{
  const maggi_topo *t = &s->data->t;
  int i, c;

  for (i = 0; i < s->m.nq; ++i)
    for (c = 0; c < t->ncol; ++c) R[i * t->ncol + c] = s->data->R[inner(s, i) * t->stride + c];
}

void subject_reduced_mass(const subject *s, double *M)
{
  const maggi_topo *t = &s->data->t;
  int i, c;

  for (i = 0; i < t->ncol; ++i)
    for (c = i; c < t->ncol; ++c)
      M[i * t->ncol + c] = M[c * t->ncol + i] = s->data->Mr[i * t->stride + c];
}

int subject_jacobian(const subject *s, double *phi)
{
  const maggi_data *d = s->data;
  const maggi_topo *t = &d->t;
  double e[3];
  int i, k, j, l, q, rows, outer[MECH_COORDINATES];

  if (!phi) return t->nrow;
  for (i = 0; i < s->m.nq; ++i) outer[inner(s, i)] = i;
  memset(phi, 0, (size_t)t->nrow * (size_t)t->nq * sizeof *phi);
  for (i = 0; i < t->nprim; ++i) {
    l = t->primloop[i];
    rows = maggi_prim_rows(t->primkind[i]);
    for (j = t->pathadr[l]; j < t->pathadr[l + 1]; ++j) {
      q = t->pathq[j];
      maggi_prim_entry(t->primkind[i], t->pathside[j], d->prim0[i], d->b[t->qbody[q]],
                       d->r[t->primpa[i]], d->r[t->primpb[i]], d->dir[t->primda[i]],
                       d->dir[t->primdb[i]], e);
      for (k = 0; k < rows; ++k) phi[(t->primrow[i] + k) * t->nq + outer[q]] = e[k];
    }
  }
  return t->nrow;
}

/* virtual work of - lambda on a motion of body a about its point:
 *   point  f = -l      axis  m = -u_a × l      angle  m = -l u_a × u_b      plane  f = -l u_b */
void subject_loop_wrench(subject *s, int loop, double wrench[6])
{
  const maggi_topo *t = &s->data->t;
  double *lambda = calloc((size_t)t->nrow + 1, sizeof *lambda), c[3];
  const double *l, *da, *db;
  int i;

  memset(wrench, 0, 6 * sizeof *wrench);
  maggi_get_multipliers(s->data, lambda);
  for (i = 0; i < t->nprim; ++i) {
    if (t->primloop[i] != loop) continue;
    l = lambda + t->primrow[i];
    da = s->data->dir[t->primda[i]];
    db = s->data->dir[t->primdb[i]];
    switch (t->primkind[i]) {
    case MAGGI_PRIM_POINT:
      v3_axpy(wrench, -1.0, l, wrench);
      break;
    case MAGGI_PRIM_AXIS:
      v3_cross(da, l, c);
      v3_axpy(wrench + 3, -1.0, c, wrench + 3);
      break;
    case MAGGI_PRIM_ANGLE:
      v3_cross(da, db, c);
      v3_axpy(wrench + 3, -l[0], c, wrench + 3);
      break;
    case MAGGI_PRIM_PLANE:
      v3_axpy(wrench, -l[0], db, wrench);
      break;
    default:
      wrench[0] = l[0];
      break;
    }
  }
  free(lambda);
}
