/* core/dynamics/grid.c: steps, round numbers, the last step. */
#include <float.h>

#include "check.h"
#include "maggi/maggi.h"

static maggi_grid grid(double time, double step)
{
  maggi_grid g;

  CHECK(maggi_grid_init(&g, time, step) == MAGGI_OK);
  return g;
}

static void test_steps(void)
{
  maggi_grid g = grid(0.3, 0.1); /* 0.3/0.1 is 2.9999999999999996 */

  CHECK(g.steps == 3 && g.is_multiple);
  CHECK(maggi_grid_time(&g, 0) == 0.0);
  CHECK(maggi_grid_time(&g, 3) == 0.3);
  g = grid(1.0, 0.3);
  CHECK(g.steps == 4 && !g.is_multiple);
  CHECK(maggi_grid_time(&g, 3) == 3.0 * 0.3 && maggi_grid_time(&g, 4) == 1.0);
  g = grid(0.5, 2.0);
  CHECK(g.steps == 1 && !g.is_multiple && maggi_grid_time(&g, 1) == 0.5);
  g = grid(1e6, 1e-3);
  CHECK(g.steps == 1000000000L && g.is_multiple);
  g = grid(DBL_MIN, DBL_MAX); /* the quotient is 0 */
  CHECK(g.steps == 1 && !g.is_multiple);
}

/* rows stand at the numbers that one would write */
static void test_round(void)
{
  maggi_grid g = grid(10.0, 0.001);
  char text[32], expected[32];
  long k;

  CHECK(g.steps == 10000);
  for (k = 0; k <= g.steps; ++k) {
    snprintf(text, sizeof text, "%.15g", maggi_grid_time(&g, k));
    snprintf(expected, sizeof expected, "%ld.%03ld", k / 1000, k % 1000);
    CHECK(strtod(text, NULL) == strtod(expected, NULL));
  }
}

static void test_refused(void)
{
  static const double wrong[] = {0.0, -1.0, NAN, INFINITY};
  maggi_grid g;
  int i;

  for (i = 0; i < 4; ++i) {
    CHECK(maggi_grid_init(&g, wrong[i], 0.1) == MAGGI_E_VALUE);
    CHECK(maggi_grid_init(&g, 1.0, wrong[i]) == MAGGI_E_VALUE);
  }
  CHECK(maggi_grid_init(&g, 1e6, 0.99e-3) == MAGGI_E_VALUE);
}

int main(void)
{
  test_steps();
  test_round();
  test_refused();
  return check_done();
}
