/* core/study/quadrature.c: weights of integrals, interpolation, all lengths of grids and last steps. */
#include "check.h"
#include "quadrature.h"

static maggi_grid grid(double time, double step)
{
  maggi_grid g;

  CHECK(maggi_grid_init(&g, time, step) == MAGGI_OK);
  return g;
}

/* exact for polynomials up to degree 5, or one less than the number of nodes */
static void check_exact(const maggi_grid *g)
{
  maggi_nodes x;
  maggi_local at;
  double sum, t, u, value, T = g->time;
  int degree, i, j;
  long k, node, interval;

  maggi_nodes_init(&x, g);
  CHECK(x.n == g->steps + 1 - (x.skipped >= 0));
  for (degree = 0; degree <= 5 && degree < x.n; ++degree) {
    sum = 0.0;
    for (k = 0; k <= g->steps; ++k) {
      node = maggi_nodes_of(&x, k);
      if (node < 0) continue;
      CHECK(maggi_nodes_weight(&x, node) > 0.0 || x.n < 8);
      sum += maggi_nodes_weight(&x, node) * pow(maggi_grid_time(g, k) / T, degree);
    }
    CHECK_NEAR(sum, T / (degree + 1), 1e-14, 0.0);
    for (i = 0; i <= 100; ++i) {
      t = T * i / 100.0;
      interval = maggi_nodes_find(&x, t, &u);
      maggi_nodes_at(&x, interval, u, &at);
      value = 0.0;
      for (j = 0; j < at.n; ++j) {
        k = at.first + j;
        value += at.weight[j] * pow(maggi_grid_time(g, k == x.n - 1 ? g->steps : k) / T, degree);
      }
      CHECK_NEAR(value, pow(t / T, degree), 0.0, 1e-13);
    }
  }
}

static void test_exact(void)
{
  maggi_grid g;
  int n, i;

  for (n = 1; n <= 30; ++n) {
    g = grid(0.7, 0.7 / n);
    CHECK(g.steps == n);
    check_exact(&g);
    for (i = 1; i < 20; ++i) { /* a last step of i/20 of the others */
      g = grid(0.1 * (n - 1) + 0.005 * i, 0.1);
      CHECK(g.steps == n && (n == 1 || !g.is_multiple));
      check_exact(&g);
    }
  }
}

/* interior weights are h to the last bit, those of both ends mirror each other */
static void test_uniform(void)
{
  maggi_grid g = grid(3.0, 0.1);
  maggi_nodes x;
  long i;

  maggi_nodes_init(&x, &g);
  CHECK(x.n == 31);
  for (i = 6; i < 25; ++i) CHECK(maggi_nodes_weight(&x, i) == x.h);
  for (i = 0; i < 6; ++i) {
    CHECK(fabs(maggi_nodes_weight(&x, i) - x.h) > 1e-4 * x.h);
    CHECK_NEAR(maggi_nodes_weight(&x, i), maggi_nodes_weight(&x, 30 - i), 1e-14, 0.0);
  }
}

/* A sample so near to the end that differences over the last step were noise is left out: weights stay
 * of the size of h. */
static void test_short(void)
{
  maggi_grid g = grid(2.0 + 1e-13, 0.1);
  maggi_nodes x;
  long i;

  CHECK(g.steps == 21);
  maggi_nodes_init(&x, &g);
  CHECK(x.skipped == 20 && x.n == 21);
  CHECK(maggi_nodes_of(&x, 20) == -1);
  CHECK(maggi_nodes_of(&x, 19) == 19 && maggi_nodes_of(&x, 21) == 20);
  for (i = 0; i < x.n; ++i) CHECK(maggi_nodes_weight(&x, i) < 2.0 * x.h);
}

/* at a node the polynomial is its sample, whatever the rounding of its time */
static void test_nodes(void)
{
  maggi_grid g = grid(1.0, 1e-4);
  maggi_nodes x;
  maggi_local at;
  double u;
  long k, interval;
  int j;

  maggi_nodes_init(&x, &g);
  for (k = 0; k <= g.steps; k += 7) {
    interval = maggi_nodes_find(&x, maggi_grid_time(&g, k), &u);
    maggi_nodes_at(&x, interval, u, &at);
    for (j = 0; j < at.n; ++j) CHECK(at.weight[j] == (at.first + j == k ? 1.0 : 0.0));
  }
}

/* no interval at all */
static void test_one(void)
{
  maggi_grid g = {0.0, 0.1, 0, 1};
  maggi_nodes x;
  maggi_local at;
  double u;

  maggi_nodes_init(&x, &g);
  CHECK(x.n == 1 && maggi_nodes_weight(&x, 0) == 0.0);
  CHECK(maggi_nodes_find(&x, 0.0, &u) == 0);
  maggi_nodes_at(&x, 0, u, &at);
  CHECK(at.n == 1 && at.weight[0] == 1.0);
}

int main(void)
{
  test_exact();
  test_uniform();
  test_short();
  test_nodes();
  test_one();
  return check_done();
}
