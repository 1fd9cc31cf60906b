/* ADOL-C: operator overloading, one tape, sweeps over the tape. */
#include <math.h>
#include <string.h>

#include <vector>

#include <adolc/adolc.h>

#include "methods.h"

namespace
{
typedef adouble real;
#define MAGGI_RE(x) (x).value() /* a comparison need not go on the tape */
#include "evaluation.inc"

/* entries of the buffers, so many that no tape goes to a file */
const unsigned buffer = 1u << 23;

struct tape {
  const problem *of;
  short tag;
  maggi_data *d; /* NULL where nothing is recorded any more: all numbers alive go on a tape */
  std::vector<double> y, yd, keep;
  std::vector<double *> xrow, yrow; /* rows of directions, and of Taylor coefficients */
  std::vector<double> taylor;
};

void record(tape *m)
{
  const problem *of = m->of;
  int i;

  trace_on(m->tag, 0, buffer, buffer, buffer, buffer);
  for (i = 0; i < of->nx; ++i) input(m->d, i) <<= of->x[i];
  evaluate(m->d);
  for (i = 0; i < of->ny; ++i) output(m->d, i) >>= m->y[i];
  trace_off();
}

tape *start(const problem *of, short tag)
{
  tape *m = new tape;

  m->of = of;
  m->tag = tag;
  m->d = create(of);
  m->y.resize(of->ny);
  m->yd.resize(of->ny);
  m->xrow.resize(of->nx);
  m->yrow.resize(of->ny);
  m->taylor.resize(2 * of->nx);
  record(m);
  return m;
}

void *open_tape(const problem *of)
{
  tape *m = start(of, 1);

  destroy(m->d);
  m->d = NULL;
  return m;
}

void *open_retaping(const problem *of)
{
  return start(of, 2);
}

void close_tape(void *self)
{
  tape *m = (tape *)self;

  if (m->d) destroy(m->d);
  delete m;
}

void directions(void *self, const double *xd, double *yd)
{
  tape *m = (tape *)self;
  const problem *of = m->of;
  int i;

  if (m->d) record(m);
  for (i = 0; i < of->nx; ++i) m->xrow[i] = (double *)xd + i * DIRECTIONS;
  for (i = 0; i < of->ny; ++i) m->yrow[i] = yd + i * DIRECTIONS;
  fov_forward(m->tag, of->ny, of->nx, DIRECTIONS, of->x, m->xrow.data(), m->y.data(),
              m->yrow.data());
}

void direction(void *self, const double *xd, double *yd)
{
  tape *m = (tape *)self;
  const problem *of = m->of;

  if (m->d) record(m);
  fos_forward(m->tag, of->ny, of->nx, 0, of->x, (double *)xd, m->y.data(), yd);
}

void gradient(void *self, const double *yb, double *xb)
{
  tape *m = (tape *)self;
  const problem *of = m->of;

  if (m->d) record(m);
  zos_forward(m->tag, of->ny, of->nx, 1, of->x, m->y.data());
  fos_reverse(m->tag, of->ny, of->nx, (double *)yb, xb);
}

/* the adjoint of a Taylor polynomial of degree 1: xb and its derivative along xd */
void hessian(void *self, const double *yb, const double *xd, double *xbd)
{
  tape *m = (tape *)self;
  const problem *of = m->of;
  int i;

  if (m->d) record(m);
  for (i = 0; i < of->nx; ++i) m->xrow[i] = &m->taylor[2 * i];
  fos_forward(m->tag, of->ny, of->nx, 2, of->x, (double *)xd, m->y.data(), m->yd.data());
  hos_reverse(m->tag, of->ny, of->nx, 1, (double *)yb, m->xrow.data());
  for (i = 0; i < of->nx; ++i) xbd[i] = m->taylor[2 * i + 1];
}
} // namespace

extern "C" {
const method method_adolc = {"ADOL-C",  open_tape, close_tape, directions,
                             direction, gradient,  hessian,    1e-9};
const method method_adolc_retaping = {"ADOL-C, retaping", open_retaping, close_tape, directions,
                                      direction,          gradient,      hessian,    1e-9};
}
