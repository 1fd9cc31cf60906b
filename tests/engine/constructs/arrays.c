/* Elements of arrays: written once, added to; local arrays. */
#include "kernel.h"

void accumulation_in_elements(const topo *t, const double p[t->np], const double q[t->n], double s,
                              double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i] * s;
    y[i] += s * s;
    y[i] -= q[i] * p[i] * q[i];
  }
}

void element_added_to_in_branches(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    if (t->kind[i] > 1)
      y[i] = tanh(q[i]);
    else
      y[i] = exp(0.5 * q[i]);
    if (MAGGI_RE(q[i]) > MAGGI_RE(s)) y[i] += s * s;
    y[i] -= q[i] / (3.0 + s);
  }
}

void elementary_function_then_added_to(const topo *t, const double q[t->n], double s,
                                       double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = tanh(q[i]);
    y[i] += sqrt(2.0 + s);
    y[i] += exp(s) * s;
  }
}

void only_added_to(const topo *t, const double X[t->n + 1][3], double s, double F[t->n + 1][3])
{
  int i, k;

  for (i = 0; i < t->ne; ++i)
    for (k = 0; k < 3; ++k) {
      F[t->from[i]][k] += X[t->to[i]][k] * s;
      F[t->to[i]][2 - k] -= sin(X[t->from[i]][k]);
    }
}

void some_elements_stay_unwritten(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i)
    if (t->kind[i] != 1) y[i] = q[i] * q[i];
}

void elements_of_one_array_from_one_another(const topo *t, const double q[t->n], double s,
                                            double y[t->n])
{
  int i;

  y[0] = sin(s);
  y[1] = y[0] * y[0] * q[0];
  y[2] = y[1] * y[0];
  for (i = 3; i < t->n; ++i) y[i] = y[i - 1] * y[i - 2];
}

void outputs_read_by_later_outputs(const topo *t, const double q[t->n], const double X[t->n + 1][3],
                                   double y[t->n], double Y[t->n + 1][3], double e[1])
{
  int i, k;

  for (i = 0; i < t->n; ++i) y[i] = sin(q[i]);
  for (i = 0; i < t->n; ++i)
    for (k = 0; k < 3; ++k) Y[i][k] = y[i] * X[i][k] * y[t->perm[i]];
  for (k = 0; k < 3; ++k) Y[t->n][k] = 0.0;
  e[0] = 0.0;
  for (i = 0; i < t->n; ++i) e[0] += Y[i][0] * y[i];
}

void scatter_by_a_permutation(const topo *t, const double p[t->np], const double q[t->n],
                              double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[t->perm[i]] = q[i] * p[i];
}

void local_array(const topo *t, const double q[t->n], const double X[t->n + 1][3], double y[t->n])
{
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k] * q[i];
    y[i] = w[0] * w[1] + w[2];
  }
}

void local_array_of_two_dimensions(const topo *t, const double X[t->n + 1][3], double s,
                                   double y[t->n])
{
  int i, k, m;
  double w[3][2];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k)
      for (m = 0; m < 2; ++m) w[k][m] = X[i][k] * X[i + 1][m];
    y[i] = w[0][0] * w[2][1] + w[1][0] * s;
  }
}

void local_array_element_by_element(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    w[0] = q[i];
    w[1] = w[0] * s;
    w[2] = w[1] * w[0];
    y[i] = w[2] * w[1];
  }
}

void local_array_that_is_added_to(const topo *t, const double q[t->n], const double X[t->n + 1][3],
                                  double y[t->n])
{
  int i, k, m;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = 0.0;
    for (m = 0; m < t->ne; ++m)
      for (k = 0; k < 3; ++k) w[k] += X[t->from[m]][k] * q[i];
    y[i] = w[0] * w[1] * w[2];
  }
}

void local_array_that_is_added_to_in_loops_of_any_length(const topo *t, const double p[t->np],
                                                         const double q[t->n],
                                                         const double X[t->n + 1][3],
                                                         double y[t->n])
{
  int i, k, m;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k];
    for (m = 0; m < t->ne; ++m)
      for (k = 0; k < t->count[i]; ++k) w[k] += sin(p[k]) * q[i];
    y[i] = w[0] * w[1] * w[2];
  }
}

void long_local_array(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i, k;
  double w[12];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 12; ++k) w[k] = q[i] * (k + 1) + s;
    y[i] = 0.0;
    for (k = 0; k < 12; ++k) y[i] += w[k] * w[11 - k];
  }
}

void local_array_indexed_by_integers(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i, k;
  double w[4];

  for (k = 0; k < 4; ++k) w[k] = sin(s + k);
  for (i = 0; i < t->n; ++i) y[i] = w[t->kind[i]] * q[i] * w[t->kind[i]];
}

void local_array_through_a_loop(const topo *t, const double q[t->n], const double X[t->n + 1][3],
                                double y[t->n], double e[1])
{
  int i, k;
  double w[3];

  for (k = 0; k < 3; ++k) w[k] = X[0][k];
  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    for (k = 0; k < 3; ++k) w[k] += q[i] * X[i][k];
  }
  e[0] = w[0] * w[1] * w[2];
}

void local_array_written_in_branches(const topo *t, const double q[t->n],
                                     const double X[t->n + 1][3], double s, double y[t->n])
{
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k)
      if (t->kind[i] > k)
        w[k] = X[i][k] * s;
      else
        w[k] = 0.5 * q[i];
    y[i] = w[0] * w[1] * w[2];
  }
}

void local_array_of_variable_index(const topo *t, const double q[t->n], double y[t->n])
{
  int i;
  double g[5];

  for (i = 0; i < t->n; ++i) g[i] = q[i] * q[i];
  for (i = 0; i < t->n; ++i) y[i] = g[t->perm[i]] * g[i] * g[0];
}

void local_array_of_variable_index_in_each_pass(const topo *t, const double q[t->n],
                                                const double X[t->n + 1][3], double s,
                                                double y[t->n])
{
  int i, k;
  double g[5];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < t->n; ++k) g[k] = X[k][0] * q[i] + sin(s);
    y[i] = g[t->perm[i]] * g[0];
  }
}

void local_array_of_variable_index_each_from_the_one_before(const topo *t, const double q[t->n],
                                                            double s, double y[t->n])
{
  int i;
  double g[5];

  g[0] = s;
  for (i = 1; i < t->n; ++i) g[i] = sin(g[i - 1]) * q[i];
  for (i = 0; i < t->n; ++i) y[i] = g[i] * g[i];
}

static void cross(const double a[3], const double b[3], double r[3])
{
  r[0] = a[1] * b[2] - a[2] * b[1];
  r[1] = a[2] * b[0] - a[0] * b[2];
  r[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void local_rows(const topo *t, const double X[t->n + 1][3], double y[t->n])
{
  int i;
  double G[5][3];

  for (i = t->n; i >= 0; --i) {
    if (i == t->n)
      cross(X[0], X[1], G[i]);
    else
      cross(G[t->parent[i]], X[i], G[i]);
  }
  for (i = 0; i < t->n; ++i) y[i] = dot(G[i], X[t->perm[i]]) + G[i][0] * G[i][1];
}

void passive_local_array(const topo *t, const double q[t->n], const double c[t->n], double y[t->n])
{
  int i, k;
  double w[3];

  for (k = 0; k < 3; ++k) w[k] = k == 1 ? 2.0 : 0.5 * c[k];
  for (i = 0; i < t->n; ++i) y[i] = w[0] * q[i] + w[1] * q[i] * q[i] + w[2];
}

void local_array_reused(const topo *t, const double q[t->n], const double X[t->n + 1][3], double s,
                        double y[t->n], double e[1])
{
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k] * q[i];
    y[i] = w[0] * w[1] * w[2];
  }
  e[0] = 0.0;
  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k] * s;
    e[0] += w[0] * w[1] * w[2];
  }
}

void elements_without_a_derivative(const topo *t, const double q[t->n], double s, double y[t->n],
                                   double e[1])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = 0.0;
  e[0] = 1.0;
  for (i = 0; i < t->n; ++i)
    if (t->kind[i] > 0) y[i] += q[i] * q[i] * s;
  e[0] += s * s;
}

void an_input_that_is_not_used(const topo *t, const double q[t->n], const double X[t->n + 1][3],
                               double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = q[i] * q[i];
  (void)X[0];
  (void)s;
}

void local_array_of_integers(const topo *t, const double p[t->np], double y[t->n])
{
  int i, k;
  int w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = (t->adr[i] + k * k) % t->np;
    y[i] = p[w[0]] * p[w[1]] * p[w[2]];
  }
}
