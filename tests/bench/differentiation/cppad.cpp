/* CppAD: operator overloading, one tape, optimised unless it is recorded anew for each call. */
#include <math.h>
#include <string.h>

#include <vector>

#include <cppad/cppad.hpp>

#include "methods.h"

namespace
{
typedef CppAD::AD<double> real;
#include "evaluation.inc"

struct tape {
  const problem *of;
  maggi_data *d;
  int retaping;
  CppAD::ADFun<double> f;
  std::vector<real> ax, ay;
  std::vector<double> x, xd, xds, yd, yb;
};

void record(tape *m)
{
  const problem *of = m->of;
  int i;

  for (i = 0; i < of->nx; ++i) m->ax[i] = of->x[i];
  CppAD::Independent(m->ax, 0, false);
  for (i = 0; i < of->nx; ++i) input(m->d, i) = m->ax[i];
  evaluate(m->d);
  for (i = 0; i < of->ny; ++i) m->ay[i] = output(m->d, i);
  m->f.Dependent(m->ax, m->ay);
  m->f.check_for_nan(false);
}

tape *start(const problem *of, int retaping)
{
  tape *m = new tape;

  m->of = of;
  m->d = create(of);
  m->retaping = retaping;
  m->ax.resize(of->nx);
  m->ay.resize(of->ny);
  m->x.assign(of->x, of->x + of->nx);
  m->xd.resize(of->nx);
  m->xds.resize(of->nx * DIRECTIONS);
  m->yb.resize(of->ny);
  record(m);
  if (!retaping) m->f.optimize();
  return m;
}

void *open_tape(const problem *of)
{
  return start(of, 0);
}

void *open_retaping(const problem *of)
{
  return start(of, 1);
}

void close_tape(void *self)
{
  tape *m = (tape *)self;

  destroy(m->d);
  delete m;
}

void values(tape *m)
{
  if (m->retaping) record(m);
  m->f.Forward(0, m->x);
}

void directions(void *self, const double *xd, double *yd)
{
  tape *m = (tape *)self;

  values(m);
  m->xds.assign(xd, xd + m->xds.size());
  m->yd = m->f.Forward(1, DIRECTIONS, m->xds);
  memcpy(yd, m->yd.data(), m->yd.size() * sizeof(double));
}

void direction(void *self, const double *xd, double *yd)
{
  tape *m = (tape *)self;

  values(m);
  m->xd.assign(xd, xd + m->xd.size());
  m->yd = m->f.Forward(1, m->xd);
  memcpy(yd, m->yd.data(), m->yd.size() * sizeof(double));
}

void gradient(void *self, const double *yb, double *xb)
{
  tape *m = (tape *)self;

  values(m);
  m->yb.assign(yb, yb + m->of->ny);
  m->yd = m->f.Reverse(1, m->yb);
  memcpy(xb, m->yd.data(), m->yd.size() * sizeof(double));
}

/* two numbers an input: derivatives of yb.(f' xd) with respect to xd and to x */
void hessian(void *self, const double *yb, const double *xd, double *xbd)
{
  tape *m = (tape *)self;
  int i;

  values(m);
  m->xd.assign(xd, xd + m->xd.size());
  m->f.Forward(1, m->xd);
  m->yb.assign(yb, yb + m->of->ny);
  m->yd = m->f.Reverse(2, m->yb);
  for (i = 0; i < m->of->nx; ++i) xbd[i] = m->yd[2 * i + 1];
}
} // namespace

extern "C" {
const method method_cppad = {"CppAD",   open_tape, close_tape, directions,
                             direction, gradient,  hessian,    1e-9};
const method method_cppad_retaping = {"CppAD, retaping", open_retaping, close_tape, directions,
                                      direction,         gradient,      hessian,    1e-9};
}
