/* The integration of the thesis, and the Jacobian of f by maggi in it. */
#include "thesis.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "derivative.h"
#include "design.h"
#include "functional.h"

/* ------------------------------------------------------------------------------ motion */

/* state and its derivatives after a reset */
static int start(motion *m, maggi_design *design)
{
  const maggi_topo *t = &m->d->t;
  maggi_direct *s;
  double *qb = m->xb, *vb = m->fb;
  int i, q;

  if (maggi_direct_create(m->d, design, &s) != MAGGI_OK) return 0;
  if (maggi_direct_reset(s) != MAGGI_OK) {
    maggi_direct_free(s);
    return complain("initial state", maggi_data_message(m->d));
  }
  maggi_direct_get_coordinates(s, qb, vb, NULL);
  for (i = 0; i < m->nq; ++i) {
    q = m->d->m->coordinate[i].q;
    m->y0[q] = m->d->q[q];
    memcpy(m->yb0 + q * m->n, qb + i * m->n, (size_t)m->n * sizeof(double));
    if (t->col[q] < 0) continue;
    m->y0[m->nq + t->col[q]] = m->d->v[q];
    memcpy(m->yb0 + (m->nq + t->col[q]) * m->n, vb + i * m->n, (size_t)m->n * sizeof(double));
  }
  maggi_direct_free(s);
  return 1;
}

int motion_open(motion *m, const study *of, int n)
{
  const maggi_topo *t;
  maggi_design *design = NULL;
  size_t ny, nyb;
  int ok;

  memset(m, 0, sizeof *m);
  m->of = of;
  m->n = n;
  if (maggi_data_create(of->m, &m->d) != MAGGI_OK) return 0;
  if (maggi_data_reset(m->d) != MAGGI_OK) return complain("reset", maggi_data_message(m->d));
  t = &m->d->t;
  assert(t->nstate == 0);
  m->nq = t->nq;
  m->nind = t->nind;
  m->ny = m->nq + m->nind;
  ny = (size_t)m->ny;
  nyb = 2 * (size_t)m->nq * (size_t)n; /* room for all velocities */
  m->memory = calloc(5 * (ny + nyb), sizeof(double));
  m->pb = malloc((size_t)t->np * (size_t)n * sizeof(double));
  design = study_design(of, m->d, 0, n);
  if (!m->memory || !m->pb || !design) {
    maggi_design_free(design);
    return 0;
  }
  maggi_design_directions(design, 0, n, n, m->pb);
  m->y0 = m->memory;
  m->y = m->y0 + ny;
  m->x = m->y + ny;
  m->f = m->x + ny;
  m->sum = m->f + ny;
  m->yb0 = m->sum + ny;
  m->yb = m->yb0 + nyb;
  m->xb = m->yb + nyb;
  m->fb = m->xb + nyb;
  m->sumb = m->fb + nyb;
  ok = start(m, design);
  maggi_design_free(design);
  return ok;
}

void motion_close(motion *m)
{
  maggi_data_free(m->d);
  free(m->pb);
  free(m->memory);
}

/* z = x + h f */
static void ahead(int n, const double *x, double h, const double *f, double *z)
{
  int i;

  for (i = 0; i < n; ++i) z[i] = x[i] + h * f[i];
}

static void step(motion *m, slopes *evaluate, void *self, double time, double h)
{
  static const double weight[4] = {1.0, 2.0, 2.0, 1.0}, part[4] = {0.0, 0.5, 0.5, 1.0};
  int i, ny = m->ny, nyb = m->ny * m->n;

  memset(m->sum, 0, (size_t)ny * sizeof(double));
  memset(m->sumb, 0, (size_t)nyb * sizeof(double));
  for (i = 0; i < 4; ++i) {
    ahead(ny, m->y, part[i] * h, m->f, m->x);
    ahead(nyb, m->yb, part[i] * h, m->fb, m->xb);
    m->time = time + part[i] * h;
    evaluate(self, m->x, m->xb, m->f, m->fb);
    ahead(ny, m->sum, weight[i], m->f, m->sum);
    ahead(nyb, m->sumb, weight[i], m->fb, m->sumb);
  }
  ahead(ny, m->y, h / 6.0, m->sum, m->y);
  ahead(nyb, m->yb, h / 6.0, m->sumb, m->yb);
}

/* samples of the signal and, behind each, its derivatives */
static void integrate(motion *m, slopes *evaluate, void *self, int steps, double *samples)
{
  int k, row = 1 + m->n, first = m->of->first;

  memcpy(m->y, m->y0, (size_t)m->ny * sizeof(double));
  memcpy(m->yb, m->yb0, (size_t)(m->ny * m->n) * sizeof(double));
  memset(m->f, 0, (size_t)m->ny * sizeof(double));
  memset(m->fb, 0, (size_t)(m->ny * m->n) * sizeof(double));
  for (k = 0; k <= steps; ++k, samples += row) {
    if (k > 0) step(m, evaluate, self, (k - 1) * m->of->step, m->of->step);
    samples[0] = m->y[first];
    memcpy(samples + 1, m->yb + first * m->n, (size_t)m->n * sizeof(double));
  }
}

/* of the objective from the samples */
static int weigh(const motion *m, int steps, const double *samples, double *gradient)
{
  maggi_objective *o = m->of->objective;
  maggi_grid grid;
  char message[256];
  double value, weight;
  int i, k, row = 1 + m->n;

  memset(gradient, 0, (size_t)m->n * sizeof(double));
  if (maggi_grid_init(&grid, steps * m->of->step, m->of->step) != MAGGI_OK ||
      maggi_objective_begin(o, &grid, message, sizeof message) != MAGGI_OK)
    return complain("objective", message);
  for (k = 0; k <= steps; ++k) maggi_objective_push(o, k, samples + k * row);
  if (maggi_objective_end(o, &value, message, sizeof message) != MAGGI_OK)
    return complain("objective", message);
  for (k = 0; k <= steps; ++k) {
    if (!maggi_objective_weights(o, k, samples + k * row, &weight)) continue;
    for (i = 0; i < m->n; ++i) gradient[i] += weight * samples[k * row + 1 + i];
  }
  return 1;
}

int motion_gradient(motion *m, slopes *evaluate, void *self, int steps, double *gradient)
{
  double *samples = malloc((size_t)(steps + 1) * (size_t)(1 + m->n) * sizeof(double));
  int ok;

  if (!samples) return complain("samples", "out of memory");
  integrate(m, evaluate, self, steps, samples);
  ok = weigh(m, steps, samples, gradient);
  free(samples);
  return ok;
}

void motion_evaluate(motion *m, const double *x, double *f)
{
  maggi_data *d = m->d;
  size_t nq = (size_t)m->nq, nind = (size_t)m->nind;

  memcpy(d->q, x, nq * sizeof(double));
  memcpy(d->vcol, x + nq, nind * sizeof(double));
  maggi_evaluate(d, m->time);
  memcpy(f, d->v, nq * sizeof(double));
  memcpy(f + nq, d->acol, nind * sizeof(double));
}

void motion_solve(const motion *m, double *x)
{
  const maggi_data *d = m->d;
  double *acol = d->space;

  maggi_solve_mass(&d->t, d->Mr, x, d->Ur, d->dinv, acol);
  memcpy(x, acol, (size_t)m->nind * sizeof(double));
}

const maggi_topo *motion_topo(const motion *m)
{
  return &m->d->t;
}

int motion_origin(const motion *m)
{
  return m->d->m->originadr;
}

const double *motion_parameters(const motion *m)
{
  return m->d->p;
}

void motion_multiply(const motion *m, const double *row, const double *xb, double *fb)
{
  int i, k, n = m->n;

  memcpy(fb, row + m->ny, (size_t)n * sizeof(double));
  for (i = 0; i < m->ny; ++i)
    for (k = 0; k < n; ++k) fb[k] += row[i] * xb[i * n + k];
}

/* --------------------------------------------------------------------------- the Jacobian */

/* f_y and f_b whole, by maggi_motion_jac, then f_y y_b + f_b */
typedef struct jacobian {
  motion m;
  maggi_derivative *D;
  int columns;       /* ny + n */
  double *q, *v, *p; /* directions, order of the user */
  double *v_out, *a_out;
} jacobian;

static int fill(jacobian *m)
{
  const maggi_data *d = m->m.d;
  const maggi_topo *t = &d->t;
  int i, q, columns = m->columns, nq = m->m.nq;

  for (i = 0; i < nq; ++i) {
    q = d->m->coordinate[i].q;
    m->q[i * columns + q] = 1.0;
    if (t->col[q] >= 0) m->v[i * columns + nq + t->col[q]] = 1.0;
  }
  for (i = 0; i < t->np; ++i)
    memcpy(m->p + i * columns + m->m.ny, m->m.pb + i * m->m.n, (size_t)m->m.n * sizeof(double));
  return maggi_derivative_create(m->m.d, columns, &m->D) == MAGGI_OK;
}

static void close_jacobian(void *self)
{
  jacobian *m = self;

  maggi_derivative_free(m->D);
  motion_close(&m->m);
  free(m->q);
  free(m);
}

static void *open_jacobian(const study *of, int n)
{
  jacobian *m = calloc(1, sizeof *m);
  size_t rows, columns;

  if (!m) return NULL;
  if (motion_open(&m->m, of, n)) {
    m->columns = m->m.ny + n;
    rows = (size_t)m->m.nq;
    columns = (size_t)m->columns;
    m->q = calloc((4 * rows + (size_t)m->m.d->t.np) * columns, sizeof(double));
    m->v = m->q + rows * columns;
    m->v_out = m->v + rows * columns;
    m->a_out = m->v_out + rows * columns;
    m->p = m->a_out + rows * columns;
    if (m->q && fill(m)) {
      maggi_parameters_jac(m->D, m->columns, m->columns, m->p);
      return m;
    }
  }
  close_jacobian(m);
  return NULL;
}

static void jacobian_slopes(void *self, const double *x, const double *xb, double *f, double *fb)
{
  jacobian *m = self;
  maggi_data *d = m->m.d;
  const maggi_topo *t = &d->t;
  int i, q, nq = m->m.nq, n = m->m.n;

  motion_evaluate(&m->m, x, f);
  if (maggi_linearise_at(m->D, m->m.time) != MAGGI_OK) return;
  maggi_state_jac(m->D, m->columns, m->columns, m->q, m->v, m->v_out, m->a_out);
  for (i = 0; i < nq; ++i) {
    q = d->m->coordinate[i].q;
    motion_multiply(&m->m, m->v_out + i * m->columns, xb, fb + q * n);
    if (t->col[q] < 0) continue;
    motion_multiply(&m->m, m->a_out + i * m->columns, xb, fb + (nq + t->col[q]) * n);
  }
}

static int jacobian_gradient(void *self, int steps, double *gradient)
{
  jacobian *m = self;

  return motion_gradient(&m->m, jacobian_slopes, m, steps, gradient);
}

const way way_jacobian = {
    "Jacobian of f, product", open_jacobian, close_jacobian, jacobian_gradient, NULL, 1, 0, 1e-8};
