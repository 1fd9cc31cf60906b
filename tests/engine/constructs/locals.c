/* Locals: assigned once and again, carried from pass to pass; integers. */
#include "kernel.h"

void locals(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;
  double a, b, d;

  for (i = 0; i < t->n; ++i) {
    a = sin(q[i]);
    b = a * s;
    d = a * b + b;
    y[i] = d * a;
  }
}

void locals_before_a_loop(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;
  double a, b;

  a = s * s;
  b = sin(a);
  for (i = 0; i < t->n; ++i) y[i] = b * q[i] * a;
}

void assignments_to_locals(const topo *t, const double p[t->np], const double q[t->n], double s,
                           double y[t->n])
{
  int i;
  double a, b;

  for (i = 0; i < t->n; ++i) {
    a = q[i];
    a += s;
    a -= p[i] * a;
    a *= q[i] + 1.0;
    a /= 3.0 + s;
    b = a;
    a = b * a;
    a = a + 1.0;
    a = -a;
    y[i] = a * b;
  }
}

void local_carried_through_a_loop(const topo *t, const double q[t->n], double s, double e[1])
{
  int i;
  double a;

  a = s;
  for (i = 0; i < t->n; ++i) a = a * q[i] + sin(a);
  e[0] = a * a;
}

void carried_locals_that_need_one_another(const topo *t, const double p[t->np], double s,
                                          double e[1])
{
  int i;
  double a, b, d;

  a = s;
  b = 1.0;
  for (i = 0; i < t->np; ++i) {
    d = a * 0.5 + b * p[i];
    b = a * b * 0.5;
    a = sin(d) * b + 0.25 * a;
  }
  e[0] = a * b;
}

void carried_local_read_after_the_loop(const topo *t, const double q[t->n], double s,
                                       double y[t->n], double e[1])
{
  int i;
  double a;

  a = 1.0;
  for (i = 0; i < t->n; ++i) {
    y[i] = a * q[i];
    a = cos(a * q[i]);
  }
  e[0] = a * s;
}

void carried_through_two_loops(const topo *t, const double q[t->n], const double X[t->n + 1][3],
                               double s, double y[t->n])
{
  int i, k;
  double a;

  a = s;
  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) a = 0.5 * a * X[i][k] + sin(a);
    a *= cos(q[i]);
    y[i] = a;
  }
}

void carried_through_loops_with_different_ends(const topo *t, const double p[t->np], double s,
                                               double y[t->n])
{
  int i, k;
  double a, b;

  a = s;
  for (i = 0; i < t->n; ++i) {
    b = a;
    for (k = 0; k < t->count[i]; ++k) b = b * p[k] + a * b;
    if (t->kind[i] > 0) a = sin(b);
    y[i] = a * b;
  }
}

void sum_in_a_local(const topo *t, const double X[t->n + 1][3], double y[t->n])
{
  int i, k;
  double sum;

  for (i = 0; i < t->n; ++i) {
    sum = 0.0;
    for (k = 0; k < 3; ++k) sum += X[i][k] * X[i][k];
    y[i] = sqrt(1.0 + sum);
  }
}

void product_in_a_local(const topo *t, const double q[t->n], double e[1])
{
  int i;
  double prod;

  prod = 1.0;
  for (i = 0; i < t->n; ++i) prod *= q[i];
  e[0] = prod;
}

void local_assigned_conditionally(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = q[i];
    if (t->kind[i] > 1) a = a * a;
    if (MAGGI_RE(a) < MAGGI_RE(s)) a = a * s;
    y[i] = sin(a) * a;
  }
}

void local_assigned_in_all_branches(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;
  double a, b;

  for (i = 0; i < t->n; ++i) {
    if (t->kind[i] == 0) {
      a = q[i];
      b = a * s;
    } else if (t->kind[i] == 1) {
      b = cos(s);
      a = b;
    } else {
      a = 1.0;
      b = q[i] * q[i];
    }
    y[i] = a * b;
  }
}

void local_of_one_pass_kept_for_the_next(const topo *t, const double q[t->n], double s,
                                         double y[t->n])
{
  int i;
  double a, last;

  last = s;
  for (i = 0; i < t->n; ++i) {
    a = q[i] * last;
    y[i] = a * a;
    last = a;
  }
}

void same_local_in_several_loops(const topo *t, const double p[t->np], const double q[t->n],
                                 double s, double y[t->n], double e[1])
{
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = q[i] * q[i];
    y[i] = a * a;
  }
  e[0] = 0.0;
  for (i = 0; i < t->n; ++i) {
    a = p[i] * s;
    e[0] += a * a;
  }
  a = s;
  e[0] += a * a;
}

void integer_locals(const topo *t, const double p[t->np], const double X[t->n + 1][3], double s,
                    double y[t->n])
{
  int i, k, up, m = 0;

  for (i = 0; i < t->n; ++i) {
    up = t->parent[i];
    k = t->adr[i] + 1;
    k += 1;
    if (t->kind[i] == 1) k = 0;
    y[i] = X[up][0] * p[k] * X[up][1];
    m = k + i;
    y[i] += p[m % t->np] * s;
  }
}

void an_integer_overwritten_after_it_was_an_index(const topo *t, const double p[t->np],
                                                  const double X[t->n + 1][3], double y[t->n])
{
  int i, k;

  for (i = 0; i < t->n; ++i) {
    k = t->adr[i];
    y[i] = p[k] * p[k];
    k = t->parent[i];
    y[i] += X[k][0] * X[k][1];
    k = 0;
  }
}

void an_integer_carried_through_a_loop(const topo *t, const double p[t->np], const double q[t->n],
                                       double y[t->n])
{
  int i, k;

  k = 0;
  for (i = 0; i < t->n; ++i) {
    y[i] = p[k] * p[k] * q[i];
    k = (k + t->kind[i] + 1) % 5;
  }
}

void a_counter_that_is_an_integer_elsewhere(const topo *t, const double p[t->np],
                                            const double q[t->n], const double X[t->n + 1][3],
                                            double y[t->n])
{
  int i, k;
  double a;

  for (i = 0; i < t->n; ++i) {
    k = t->adr[i];
    a = p[k] * q[i];
    for (k = 0; k < 2; ++k) a = a * p[k];
    k = t->parent[i];
    y[i] = a * X[k][0];
  }
}

void locals_of_blocks(const topo *t, const double p[t->np], const double q[t->n], double s,
                      double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    double a, b;

    a = q[i] * s;
    b = a * a;
    y[i] = b;
  }
  for (i = 0; i < t->n; ++i) {
    double a;

    a = p[i];
    y[i] += a * a * q[i];
  }
}

void passive_values(const topo *t, const double q[t->n], double s, const double c[t->n],
                    double y[t->n])
{
  int i;
  double f, g;

  f = sin(c[0]) * 2.0;
  for (i = 0; i < t->n; ++i) {
    g = exp(c[i]) / (2.0 + f * f);
    if (MAGGI_RE(g) > 0.5) g = 0.5 * g;
    y[i] = g * q[i] * q[i] + f * pow(c[i] * c[i], 0.5) + sqrt(g) * s;
  }
}

void locals_of_blocks_that_hide_others(const topo *t, const double q[t->n], double s,
                                       double y[t->n], double e[1])
{
  int i;
  double a;

  a = s * s;
  for (i = 0; i < t->n; ++i) {
    double a;

    a = q[i] * q[i];
    if (t->kind[i] > 0) {
      double a;

      a = sin(s);
      y[i] = a * a;
    } else {
      y[i] = a * s;
    }
    y[i] += a * a;
  }
  e[0] = a * a;
}
