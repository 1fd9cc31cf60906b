/* core/study/extremum.c: maxima of polynomials on an interval. */
#include "check.h"
#include "extremum.h"

static const double node[6] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0};

/* p(u) = c - (u - z)^2 (1 + (u - z)^2/9): the maximum c is at z */
static void test_inside(void)
{
  double f[6], z, where, top;
  int i, j;

  for (i = 0; i <= 20; ++i) {
    z = 2.0 + 0.05 * i;
    for (j = 0; j < 6; ++j) f[j] = 7.0 - pow(node[j] - z, 2) * (1.0 + pow(node[j] - z, 2) / 9.0);
    top = maggi_local_maximum(6, node, f, 2.0, 3.0, &where);
    CHECK_NEAR(top, 7.0, 1e-14, 0.0);
    CHECK_NEAR(where, z, 0.0, 1e-13);
  }
}

/* a monotonic one has it at an end, a constant one anywhere */
static void test_ends(void)
{
  double up[6], down[6], flat[6], where;
  int j;

  for (j = 0; j < 6; ++j) {
    up[j] = exp(0.1 * node[j]);
    down[j] = -up[j];
    flat[j] = 3.0;
  }
  CHECK_NEAR(maggi_local_maximum(6, node, up, 1.0, 2.0, &where), up[2], 1e-15, 0.0);
  CHECK(where == 2.0);
  CHECK_NEAR(maggi_local_maximum(6, node, down, 1.0, 2.0, &where), down[1], 1e-15, 0.0);
  CHECK(where == 1.0);
  CHECK(maggi_local_maximum(6, node, flat, 1.0, 2.0, &where) == 3.0);
  CHECK(maggi_local_maximum(1, node, flat, 0.0, 0.0, &where) == 3.0 && where == 0.0);
  CHECK(maggi_local_maximum(2, node, up, 0.0, 1.0, &where) == up[1] && where == 1.0);
}

/* samples of a slow motion: differences are small, the position is still there */
static void test_slow(void)
{
  double f[6], where, top;
  int j;

  for (j = 0; j < 6; ++j) f[j] = 1.0 - 1e-6 * pow(node[j] - 2.3, 2);
  top = maggi_local_maximum(6, node, f, 2.0, 3.0, &where);
  CHECK_NEAR(top, 1.0, 1e-15, 0.0);
  CHECK_NEAR(where, 2.3, 0.0, 1e-9);
}

int main(void)
{
  test_inside();
  test_ends();
  test_slow();
  return check_done();
}
