/* Generalised forces Q(z, z') of the open chain from the kernel, their Jacobian by differences, and
 * its pattern by the definition. */
#ifndef MAGGI_TEST_OPEN_CHAIN_H
#define MAGGI_TEST_OPEN_CHAIN_H

#include <math.h>
#include <stdlib.h>

#include "data.h"
#include "pattern.h"

#define CHAIN_ARRAY(x) ((void *)(x))

/* d->f from d->q and d->v, of guided coordinates too */
static inline void open_chain_forces(maggi_data *d)
{
  const maggi_topo *t = &d->t;

  maggi_positions(t, CHAIN_ARRAY(d->offset0), CHAIN_ARRAY(d->axis0), d->q, d->turn, d->A, d->x,
                  d->b);
  maggi_points(t, 0, t->npointdyn, CHAIN_ARRAY(d->point0), CHAIN_ARRAY(d->A), CHAIN_ARRAY(d->x),
               d->r);
  maggi_velocities(t, d->p, CHAIN_ARRAY(d->b), d->v, d->Z, d->Z0);
  maggi_point_velocities(t, 0, t->npointdyn, CHAIN_ARRAY(d->r), CHAIN_ARRAY(d->Z), d->rv);
  maggi_point_accelerations(t, 0, t->npointdyn, CHAIN_ARRAY(d->r), CHAIN_ARRAY(d->rv),
                            CHAIN_ARRAY(d->Z), CHAIN_ARRAY(d->Z0), d->r0a);
  maggi_wheel_forces(t, d->p, CHAIN_ARRAY(d->spline0), CHAIN_ARRAY(d->A), CHAIN_ARRAY(d->Z),
                     CHAIN_ARRAY(d->r), CHAIN_ARRAY(d->rv), d->slip, d->grip, d->roll);
  maggi_element_forces(t, d->p, CHAIN_ARRAY(d->fun), d->spring0, d->q, d->v, CHAIN_ARRAY(d->A),
                       CHAIN_ARRAY(d->Z), CHAIN_ARRAY(d->r), CHAIN_ARRAY(d->rv),
                       CHAIN_ARRAY(d->roll), d->Q, d->tau, d->power);
  maggi_control_forces(t, d->p, CHAIN_ARRAY(d->fun), CHAIN_ARRAY(d->path0), d->q, d->v,
                       CHAIN_ARRAY(d->r), CHAIN_ARRAY(d->rv), d->driver, d->speed, d->tau,
                       d->power);
  maggi_body_inertias(t, CHAIN_ARRAY(d->body0), CHAIN_ARRAY(d->A), CHAIN_ARRAY(d->x), d->I);
  maggi_inertia_forces(t, CHAIN_ARRAY(d->I), CHAIN_ARRAY(d->Z), CHAIN_ARRAY(d->Z0), d->F);
  maggi_rod_forces(t, d->p, CHAIN_ARRAY(d->r), CHAIN_ARRAY(d->r0a), d->F);
  maggi_accumulate(t, CHAIN_ARRAY(d->F), CHAIN_ARRAY(d->Q), d->FS);
  maggi_generalised_forces(t, CHAIN_ARRAY(d->b), CHAIN_ARRAY(d->FS), d->tau, d->f);
}

static inline int open_chain_moves(const maggi_topo *t, int q, int body)
{
  while (body < t->qbody[q]) body = t->parent[body];
  return body == t->qbody[q];
}

/* size of what a number of d->f is a sum of: forces count in moments too, at levers of a metre */
static inline double open_chain_terms(const maggi_data *d, int q)
{
  const double *b = d->b[d->t.qbody[q]];
  double sum = 0.0, arm = 0.0;
  int i, k;

  for (k = 0; k < 6; ++k) arm += fabs(b[k]);
  for (i = 0; i < d->t.nbody; ++i)
    for (k = 0; k < 6 && open_chain_moves(&d->t, q, i); ++k)
      sum += fabs(d->F[i][k]) + fabs(d->Q[i][k]);
  return arm * sum + fabs(d->tau[q]);
}

static inline void open_chain_quotient(maggi_data *d, double *x, double h, double *out)
{
  double at = *x;
  int i;

  *x = at + h;
  open_chain_forces(d);
  for (i = 0; i < d->t.nq; ++i) out[i] = d->f[i];
  *x = at - h;
  open_chain_forces(d);
  for (i = 0; i < d->t.nq; ++i) out[i] = (out[i] - d->f[i]) / (2.0 * h);
  *x = at;
}

/* J (n x 2n, by rows) at d->q, d->v by two central differences, extrapolated; what is below error[i] in
 * row i may be rounding of f_i, to a part in 1e13 of its terms */
static inline void open_chain_jacobian(maggi_data *d, const maggi_pattern *p, double *J,
                                       double *error)
{
  const double h = 2e-3;
  int n = p->n, i, j;
  double *wide = malloc(2 * ((size_t)d->t.nq + 1) * sizeof *wide), *narrow = wide + d->t.nq, *x;

  if (!wide) abort();
  for (j = 0; j < 2 * n; ++j) {
    x = j < n ? &d->q[p->q[j]] : &d->v[p->q[j - n]];
    open_chain_quotient(d, x, h, wide);
    open_chain_quotient(d, x, 0.5 * h, narrow);
    for (i = 0; i < n; ++i) {
      J[i * 2 * n + j] = (4.0 * narrow[p->q[i]] - wide[p->q[i]]) / 3.0;
      error[i] = fmax(error[i], 1e-13 / h * open_chain_terms(d, p->q[i]));
    }
  }
  free(wide);
}

/* whether q moves body a, but not with it body b */
static inline int open_chain_parts(const maggi_topo *t, int q, int a, int b)
{
  return open_chain_moves(t, q, a) && !open_chain_moves(t, q, b);
}

static inline int open_chain_points_couple(const maggi_topo *t, int qi, int qj, int pa, int pb)
{
  int a = t->pointbody[pa], b = t->pointbody[pb];

  return (open_chain_parts(t, qi, a, b) || open_chain_parts(t, qi, b, a)) &&
         (open_chain_parts(t, qj, a, b) || open_chain_parts(t, qj, b, a));
}

/* whether an entry is one of the pattern, asked of each body, rod, element alone */
static inline int open_chain_couples(const maggi_topo *t, int qi, int qj)
{
  int i, a, b, yes;

  yes = open_chain_moves(t, qi, t->qbody[qj]) || open_chain_moves(t, qj, t->qbody[qi]);
  for (i = 0; i < t->nrod; ++i)
    yes = yes || open_chain_points_couple(t, qi, qj, t->rodpa[i], t->rodpb[i]);
  for (i = 0; i < t->nspring; ++i)
    yes = yes || open_chain_points_couple(t, qi, qj, t->springpa[i], t->springpb[i]);
  for (i = 0; i < t->njspring; ++i) {
    a = t->jspringq[i];
    b = t->jspringq2[i];
    yes = yes || (qi == a && qj == b) || (qi == b && qj == a);
  }
  for (i = 0; i < t->nforce; ++i) {
    if (t->forcekind[i] == MAGGI_FORCE_JOINT || t->forcekind[i] == MAGGI_TORQUE_GLOBAL) continue;
    a = t->forcebody[i];
    b = t->forcereaction[i];
    yes = yes || (open_chain_parts(t, qi, b, a) && open_chain_parts(t, qj, a, b));
  }
  for (i = 0; i < t->ndriver; ++i)
    yes = yes || (qi == t->driverq[i] && open_chain_moves(t, qj, t->pointbody[t->driverpoint[i]]));
  for (i = 0; i < t->nspeed; ++i)
    for (a = t->speedqadr[i]; a < t->speedqadr[i] + t->speedqnum[i]; ++a)
      yes = yes || (qi == t->speedq[a] &&
                    (open_chain_moves(t, qj, t->pointbody[t->speedpoint[i]]) ||
                     (t->speeddriver[i] >= 0 &&
                      open_chain_moves(t, qj, t->pointbody[t->driverpoint[t->speeddriver[i]]]))));
  return yes;
}

typedef struct open_chain_findings {
  int n, entries;     /* of the pattern: rows, entries of a block */
  int wrong;          /* entries that the definition has and the pattern has not, or conversely */
  int vanished;       /* entries of a block that were rounding in both blocks at all states .. */
  int vanished_turns; /* .. of two joints that turn */
  double outside;     /* largest |J| outside the pattern, relative to the largest of all */
} open_chain_findings;

static inline double open_chain_random(unsigned long long *seed)
{
  *seed = *seed * 6364136223846793005ull + 1442695040888963407ull;
  return (double)(*seed >> 11) * 0x1p-52 - 1.0;
}

/* The pattern of a model against the definition, and against J at random states of a simulation
 * after its reset.  Rods are half a kilogram heavier, functions of loads are 1: none is switched
 * off. */
static inline open_chain_findings open_chain_examine(maggi_data *d, int states,
                                                     unsigned long long seed)
{
  const maggi_topo *t = &d->t;
  open_chain_findings f = {0};
  maggi_pattern *p;
  double *J, *size, *error, largest = 0.0, x;
  char *inside;
  int i, j, k, n, n2, state;

  if (maggi_pattern_create(t, &p) != MAGGI_OK) abort();
  f.n = n = p->n;
  n2 = 2 * n;
  J = calloc((size_t)n * (size_t)n2 + 1, sizeof *J);
  size = calloc((size_t)n * (size_t)n2 + 1, sizeof *size); /* largest |J| of all states */
  inside = calloc((size_t)n * (size_t)n2 + 1, 1);
  error = calloc((size_t)n + 1, sizeof *error);
  if (!J || !size || !inside || !error) abort();
  for (j = 0; j < n2; ++j)
    for (k = p->J.coladr[j]; k < p->J.coladr[j + 1]; ++k) inside[p->J.row[k] * n2 + j] = 1;

  for (i = 0; i < t->nrod; ++i) d->p[t->rodadr[i]] += 0.5;
  maggi_constants(d);
  for (i = 0; i < t->nfun; ++i) d->fun[i][0] = 1.0;
  for (state = 0; state < states; ++state) {
    for (i = 0; i < t->nq; ++i) d->q[i] = open_chain_random(&seed);
    for (i = 0; i < t->nq; ++i) d->v[i] = open_chain_random(&seed);
    open_chain_jacobian(d, p, J, error);
    for (k = 0; k < n * n2; ++k) size[k] = fmax(size[k], fabs(J[k]));
  }
  for (k = 0; k < n * n2; ++k) largest = fmax(largest, size[k]);
  for (i = 0; i < n; ++i) {
    for (j = 0; j < n; ++j) {
      k = i * n2 + j;
      x = fmax(size[k], size[k + n]);
      f.entries += inside[k];
      f.wrong += inside[k] != open_chain_couples(t, p->q[i], p->q[j]);
      f.wrong += inside[k + n] != inside[k];
      if (inside[k] && !(x > error[i])) {
        ++f.vanished;
        f.vanished_turns += t->joint[t->qbody[p->q[i]]] == MAGGI_ONE_REVOLUTE &&
                            t->joint[t->qbody[p->q[j]]] == MAGGI_ONE_REVOLUTE;
      }
      if (!inside[k] && !(x / largest <= f.outside)) f.outside = x / largest;
    }
  }
  free(J);
  free(size);
  free(error);
  free(inside);
  maggi_pattern_free(p);
  return f;
}

#endif
