/* Direct differentiation with ADOL-C in the ways of the thesis, 5.5.2: the tape is recorded once, with
 * the state, the parameters and time as independent variables.  Comparisons stay as they were then. */
#include <string.h>

#include <vector>

#include <adolc/adolc.h>

#include "problem.h"
#include "thesis.h"

namespace
{
typedef adouble real;
#define MAGGI_RE(x) (x).value() /* a comparison need not go on the tape */
#include "evaluation.inc"

/* entries of the buffers, so many that no tape goes to a file */
const unsigned buffer = 1u << 23;

struct tape {
  motion m;
  short tag;
  std::vector<double> x, y, yb, identity;
  std::vector<double *> xrow, yrow;
};

/* what is recorded besides velocities: accelerations, or what is solved for them: fr, then Mr by rows of
 * its upper half */
void solved(const motion *m, maggi_data *d, tape *self)
{
  int i, n = (int)self->y.size();

  self->y.resize(n + m->nind);
  for (i = 0; i < m->nind; ++i) d->acol[i] >>= self->y[n + i];
}

/* whether an entry of the upper half of Mr can be other than zero */
bool is_entry(const maggi_topo *t, int i, int k)
{
  return t->first[k] <= i;
}

void unsolved(const motion *m, maggi_data *d, tape *self)
{
  const maggi_topo *t = &d->t;
  double y;
  int i, k;

  for (i = 0; i < m->nind; ++i) {
    d->fr[i] >>= y;
    self->y.push_back(y);
  }
  for (i = 0; i < m->nind; ++i) {
    for (k = i; k < m->nind; ++k) {
      if (!is_entry(t, i, k)) continue;
      d->Mr[i * t->stride + k] >>= y;
      self->y.push_back(y);
    }
  }
}

void record(tape *self, bool is_solved)
{
  const motion *m = &self->m;
  const problem of = {NULL, motion_topo(m), motion_origin(m), NULL, 0.0, 0, 0, NULL};
  maggi_data *d = create(&of);
  real b;
  int i, k;

  for (i = 0; i < d->t.np; ++i) d->p[i] = motion_parameters(m)[i];
  trace_on(self->tag, 0, buffer, buffer, buffer, buffer);
  for (i = 0; i < m->nq; ++i) d->q[i] <<= self->x[i];
  for (i = 0; i < m->nind; ++i) d->vcol[i] <<= self->x[m->nq + i];
  for (i = 0; i < m->n; ++i) {
    b <<= self->x[m->ny + i];
    for (k = 0; k < d->t.np; ++k)
      if (m->pb[k * m->n + i] != 0.0) d->p[k] += m->pb[k * m->n + i] * b;
  }
  d->time <<= self->x[m->ny + m->n];
  if (is_solved)
    evaluate(d);
  else
    evaluate_unsolved(d);
  self->y.resize(m->nq);
  for (i = 0; i < m->nq; ++i) d->v[i] >>= self->y[i];
  if (is_solved)
    solved(m, d, self);
  else
    unsolved(m, d, self);
  trace_off();
  destroy(d);
}

/* columns of the derivatives: n of y_b, or all independent variables */
tape *start(const study *of, int n, bool is_solved, bool is_jacobian)
{
  static short tags;
  tape *self = new tape;
  motion *m = &self->m;
  int i, nx, columns;

  if (!motion_open(m, of, n)) {
    motion_close(m);
    delete self;
    return NULL;
  }
  nx = m->ny + n + 1;
  self->tag = ++tags;
  self->x.assign(m->y0, m->y0 + m->ny);
  self->x.resize(nx); /* changes of the parameters, and time */
  record(self, is_solved);
  columns = is_jacobian ? nx : n;
  self->yb.resize(self->y.size() * columns);
  self->yrow.resize(self->y.size());
  for (i = 0; i < (int)self->y.size(); ++i) self->yrow[i] = &self->yb[i * columns];
  self->identity.resize((n + 1) * n);
  self->xrow.resize(nx);
  for (i = 0; i < n; ++i) {
    self->identity[i * n + i] = 1.0;
    self->xrow[m->ny + i] = &self->identity[i * n];
  }
  self->xrow[m->ny + n] = &self->identity[n * n];
  return self;
}

void *open_solved(const study *of, int n)
{
  return start(of, n, true, false);
}

void *open_unsolved(const study *of, int n)
{
  return start(of, n, false, false);
}

void *open_jacobian(const study *of, int n)
{
  return start(of, n, true, true);
}

void close_tape(void *self)
{
  tape *m = (tape *)self;

  motion_close(&m->m);
  delete m;
}

/* tangent of the tape along x_b */
void forward(tape *self, const double *x, const double *xb)
{
  int i, ny = self->m.ny, n = self->m.n;

  memcpy(self->x.data(), x, ny * sizeof(double));
  self->x[ny + n] = self->m.time;
  for (i = 0; i < ny; ++i) self->xrow[i] = (double *)xb + i * n;
  fov_forward(self->tag, (int)self->y.size(), (int)self->x.size(), n, self->x.data(),
              self->xrow.data(), self->y.data(), self->yrow.data());
}

void solved_slopes(void *self, const double *x, const double *xb, double *f, double *fb)
{
  tape *m = (tape *)self;

  forward(m, x, xb);
  memcpy(f, m->y.data(), m->y.size() * sizeof(double));
  memcpy(fb, m->yb.data(), m->yb.size() * sizeof(double));
}

/* M a_b = fr_b - M_b a */
void unsolved_slopes(void *self, const double *x, const double *xb, double *f, double *fb)
{
  tape *tp = (tape *)self;
  motion *m = &tp->m;
  const maggi_topo *t = motion_topo(m);
  int i, k, c, n = m->n, entry = m->nq + m->nind;
  const double *a = f + m->nq, *row;
  double *rhs = fb + m->nq * n;
  std::vector<double> column(m->nind);

  motion_evaluate(m, x, f);
  forward(tp, x, xb);
  memcpy(fb, tp->yb.data(), (m->nq + m->nind) * n * sizeof(double));
  for (i = 0; i < m->nind; ++i) {
    for (k = i; k < m->nind; ++k) {
      if (!is_entry(t, i, k)) continue;
      row = tp->yrow[entry++];
      for (c = 0; c < n; ++c) rhs[i * n + c] -= row[c] * a[k];
      for (c = 0; c < n && k > i; ++c) rhs[k * n + c] -= row[c] * a[i];
    }
  }
  for (c = 0; c < n; ++c) {
    for (i = 0; i < m->nind; ++i) column[i] = rhs[i * n + c];
    motion_solve(m, column.data());
    for (i = 0; i < m->nind; ++i) rhs[i * n + c] = column[i];
  }
}

void jacobian_slopes(void *self, const double *x, const double *xb, double *f, double *fb)
{
  tape *tp = (tape *)self;
  motion *m = &tp->m;
  int i;

  motion_evaluate(m, x, f);
  memcpy(tp->x.data(), x, m->ny * sizeof(double));
  tp->x[m->ny + m->n] = m->time;
  jacobian(tp->tag, (int)tp->y.size(), (int)tp->x.size(), tp->x.data(), tp->yrow.data());
  for (i = 0; i < m->ny; ++i) motion_multiply(m, tp->yrow[i], xb, fb + i * m->n);
}

int solved_gradient(void *self, int steps, double *gradient)
{
  return motion_gradient(&((tape *)self)->m, solved_slopes, self, steps, gradient);
}

int unsolved_gradient(void *self, int steps, double *gradient)
{
  return motion_gradient(&((tape *)self)->m, unsolved_slopes, self, steps, gradient);
}

int jacobian_gradient(void *self, int steps, double *gradient)
{
  return motion_gradient(&((tape *)self)->m, jacobian_slopes, self, steps, gradient);
}

void size(void *self, tape_size *s)
{
  size_t counts[STAT_SIZE];

  tapestats(((tape *)self)->tag, counts);
  *s = {(long)counts[NUM_INDEPENDENTS], (long)counts[NUM_DEPENDENTS], (long)counts[NUM_OPERATIONS],
        (long)counts[NUM_LOCATIONS], (long)counts[NUM_VALUES]};
}
} // namespace

extern "C" {
const way way_adolc = {
    "ADOL-C: tape of f", open_solved, close_tape, solved_gradient, size, 1, 0, 1e-8};
const way way_adolc_unsolved = {
    "ADOL-C: f without solve", open_unsolved, close_tape, unsolved_gradient, size, 1, 0, 1e-8};
const way way_adolc_jacobian = {
    "ADOL-C: Jacobian, product", open_jacobian, close_tape, jacobian_gradient, size, 1, 0, 1e-8};
}
