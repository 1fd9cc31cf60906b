/* Loops, and sums in loops. */
#include "kernel.h"

void loop_up(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = q[i] * q[i];
}

void loop_up_to_and_with(const topo *t, const double X[t->n + 1][3], double Y[t->n + 1][3])
{
  int i, k;

  for (i = 0; i <= t->n; i++)
    for (k = 0; k <= 2; k += 1) Y[i][k] = X[i][k] * X[i][2 - k];
}

void loop_down(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  y[t->n - 1] = sin(s);
  for (i = t->n - 2; i >= 0; --i) y[i] = y[i + 1] * q[i];
}

void loop_down_above(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  y[0] = s;
  for (i = t->n - 1; i > 0; i--) y[i] = q[i] * q[i - 1];
}

void loop_with_step(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; i += 2) y[i] = sin(q[i]);
  for (i = t->n - 1 - t->n % 2; i >= 0; i -= 2) y[i] = cos(q[i]);
}

void loop_with_large_step(const topo *t, const double p[t->np], double s, double e[1])
{
  int i;

  e[0] = 0.0;
  for (i = 0; i < t->np; i += 3) e[0] += p[i] * p[i];
  for (i = t->np - 1; i >= 1; i -= 4) e[0] -= p[i] * s;
}

void loop_without_passes(const topo *t, const double q[t->n], double s, double e[1])
{
  int i;

  e[0] = s * s;
  for (i = 2; i < 2; ++i) e[0] += q[i];
  for (i = 0; i < t->kind[1] - 2; ++i) e[0] += q[i];
}

void counter_declared_in_the_loop(const topo *t, const double q[t->n], double s, double y[t->n],
                                  double e[1])
{
  for (int i = 0; i < t->n; ++i) {
    for (int k = 0; k < t->kind[i]; ++k) (void)k;
    y[i] = q[i] * s;
  }
  e[0] = 2.0 * s;
}

void bounds_from_another_loop(const topo *t, const double q[t->n], double e[1])
{
  int i, k;

  e[0] = 0.0;
  for (i = 0; i < t->n; ++i)
    for (k = i; k < t->n; ++k) e[0] += q[i] * q[k];
}

void bounds_from_integers(const topo *t, const double p[t->np], const double X[t->n + 1][3],
                          double y[t->n])
{
  int i, k, m;

  for (i = 0; i < t->n; ++i) y[i] = p[0];
  for (i = 0; i < t->n; ++i) {
    m = t->count[i];
    for (k = 0; k < m; ++k) y[i] += p[t->adr[i] + k] * p[k];
    for (k = t->first[i]; k < t->first[i + 1]; ++k) y[i] -= X[t->from[k]][0] * X[t->to[k]][1];
  }
}

void sum_over_edges(const topo *t, const double X[t->n + 1][3], double s, double Y[t->n + 1][3])
{
  int k, m;

  for (m = 0; m <= t->n; ++m)
    for (k = 0; k < 3; ++k) Y[m][k] = 0.0;
  for (m = 0; m < t->ne; ++m)
    for (k = 0; k < 3; ++k) {
      Y[t->from[m]][k] += X[t->from[m]][k] * X[t->to[m]][k];
      Y[t->to[m]][k] -= X[t->from[m]][k] * s;
    }
}

void sum_over_a_tree(const topo *t, const double X[t->n + 1][3], double Y[t->n + 1][3])
{
  int i, k;

  for (i = 0; i <= t->n; ++i)
    for (k = 0; k < 3; ++k) Y[i][k] = X[i][k] * X[i][k];
  for (i = 0; i < t->n; ++i)
    for (k = 0; k < 3; ++k) Y[t->parent[i]][k] += Y[i][k];
}

void nonlinear_sum_over_a_tree(const topo *t, const double X[t->n + 1][3], double s,
                               double Y[t->n + 1][3])
{
  int i, k;

  for (i = 0; i <= t->n; ++i)
    for (k = 0; k < 3; ++k) Y[i][k] = X[i][k] * X[i][k];
  for (i = 0; i < t->n; ++i)
    for (k = 0; k < 3; ++k) Y[t->parent[i]][k] += sin(Y[i][k]) * s;
}

void recursion_from_the_root(const topo *t, const double q[t->n], const double X[t->n + 1][3],
                             double s, double Y[t->n + 1][3])
{
  int i, k;

  for (k = 0; k < 3; ++k) Y[t->n][k] = k == 0 ? s : 1.0;
  for (i = t->n - 1; i >= 0; --i)
    for (k = 0; k < 3; ++k)
      Y[i][k] = Y[t->parent[i]][k] * cos(q[i]) + Y[t->parent[i]][(k + 1) % 3] * X[i][k];
}

void loop_without_braces_in_a_branch(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i)
    if (t->kind[i] == 1)
      y[i] = q[i];
    else
      y[i] = s * q[i];
}

void pragma(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

#pragma omp simd
  for (i = 0; i < t->n; ++i) y[i] = q[i] * s;
}

void loops_of_any_range(const topo *t, const double p[t->np], const double q[t->n], double s,
                        double e[1])
{
  int i, k, m;

  e[0] = s;
  for (i = 0; i < t->n; ++i) {
    m = t->count[i];
    for (k = m; k <= 5; k += 2) e[0] += p[k] * p[m];
    for (k = m + 1; k < 4; k += 3) e[0] -= p[k] * q[i];
    for (k = 4; k > m; k -= 2) e[0] += p[k] * s;
    for (k = m; k >= 2; k -= 3) e[0] -= p[k] * p[k];
    for (k = m - 1; k >= t->kind[i]; --k) e[0] += p[k] * p[0];
    m = 0;
  }
}

void a_bound_that_changes_after_the_loop(const topo *t, const double p[t->np], const double q[t->n],
                                         double s, double y[t->n])
{
  int i, k, m;
  double a;

  for (i = 0; i < t->n; ++i) {
    m = t->count[i];
    a = s;
    for (k = 0; k < m; ++k) a = sin(a) * p[k];
    m = m + 1;
    for (k = 0; k < m; ++k) a = a * p[k] + q[i];
    m = 0;
    y[i] = a * p[m];
  }
}
