/* Eigen's AutoDiffScalar: operator overloading forward, a value with all its directions, no tape. */
#include <math.h>
#include <string.h>

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include "methods.h"

/* what AutoDiffScalar lacks of the functions of the kernel */
namespace Eigen
{
template <typename D>
AutoDiffScalar<typename internal::remove_all<D>::type::PlainObject> atan(const AutoDiffScalar<D> &x)
{
  return {std::atan(x.value()), x.derivatives() / (1.0 + x.value() * x.value())};
}

template <typename D>
AutoDiffScalar<typename internal::remove_all<D>::type::PlainObject> fabs(const AutoDiffScalar<D> &x)
{
  return {std::fabs(x.value()), x.derivatives() * (x.value() < 0.0 ? -1.0 : 1.0)};
}
} // namespace Eigen

namespace
{
namespace many
{
typedef Eigen::AutoDiffScalar<Eigen::Matrix<double, DIRECTIONS, 1>> real;
#include "evaluation.inc"
} // namespace many

namespace one
{
typedef Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>> real;
#include "evaluation.inc"
} // namespace one

struct workspaces {
  const problem *of;
  many::maggi_data *many;
  one::maggi_data *one;
};

void *open_workspaces(const problem *of)
{
  return new workspaces{of, many::create(of), one::create(of)};
}

void close_workspaces(void *self)
{
  workspaces *m = (workspaces *)self;

  many::destroy(m->many);
  one::destroy(m->one);
  delete m;
}

void directions(void *self, const double *xd, double *yd)
{
  workspaces *m = (workspaces *)self;
  typedef Eigen::Map<const Eigen::Matrix<double, DIRECTIONS, 1>> row;
  int i, k;

  for (i = 0; i < m->of->nx; ++i) {
    many::input(m->many, i).value() = m->of->x[i];
    many::input(m->many, i).derivatives() = row(xd + i * DIRECTIONS);
  }
  many::evaluate(m->many);
  for (i = 0; i < m->of->ny; ++i)
    for (k = 0; k < DIRECTIONS; ++k)
      yd[i * DIRECTIONS + k] = many::output(m->many, i).derivatives()[k];
}

void direction(void *self, const double *xd, double *yd)
{
  workspaces *m = (workspaces *)self;
  int i;

  for (i = 0; i < m->of->nx; ++i) {
    one::input(m->one, i).value() = m->of->x[i];
    one::input(m->one, i).derivatives()[0] = xd[i];
  }
  one::evaluate(m->one);
  for (i = 0; i < m->of->ny; ++i) yd[i] = one::output(m->one, i).derivatives()[0];
}
} // namespace

extern "C" {
const method method_eigen = {
    "Eigen AutoDiff", open_workspaces, close_workspaces, directions, direction, NULL, NULL, 1e-9};
}
