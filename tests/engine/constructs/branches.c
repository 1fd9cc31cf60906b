/* Branches on integers and on values. */
#include "kernel.h"

void if_on_integers(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    if (t->kind[i] == 0) {
      y[i] = q[i] * s;
    } else if (t->kind[i] == 1 || i == 0) {
      y[i] = q[i] * q[i];
    } else {
      y[i] = sin(q[i]);
    }
  }
}

void if_on_active_values(const topo *t, const double p[t->np], const double q[t->n], double s,
                         double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    if (MAGGI_RE(q[i]) < MAGGI_RE(p[i]))
      y[i] = q[i] * s;
    else if (MAGGI_RE(q[i] * s) <= 0.25)
      y[i] = q[i] * q[i];
    else
      y[i] = s;
  }
}

void if_on_a_local_that_changes(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = q[i];
    if (MAGGI_RE(a) > 0.0) a = -2.0 * a * a;
    if (MAGGI_RE(a) > -1.0) a = a * s;
    y[i] = a;
  }
}

void if_on_a_local_array(const topo *t, const double X[t->n + 1][3], double y[t->n])
{
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k];
    if (MAGGI_RE(w[0]) < MAGGI_RE(w[1])) w[2] += w[0] * w[1];
    y[i] = w[2] * w[0];
  }
}

void if_on_an_integer_that_changes(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i, k;

  for (i = 0; i < t->n; ++i) {
    k = t->kind[i];
    if (k > 1) {
      k = 0;
      y[i] = q[i] * q[i];
    } else {
      y[i] = s;
    }
    if (k == 0) y[i] += q[i] * s;
  }
}

void loop_in_a_branch_in_a_loop(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i, k;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = s;
    if (t->kind[i] > 0) {
      for (k = 0; k < t->kind[i]; ++k) a = sin(a) * q[i];
    } else {
      a *= q[i];
    }
    y[i] = a;
  }
}

void empty_branch(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    if (t->kind[i] == 0) {
    } else {
      y[i] += s * s;
    }
    if (t->kind[i] == 1)
      ;
  }
}

void switch_on_integers(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    switch (t->kind[i]) {
    case 0:
      y[i] = q[i] * s;
      break;
    case 1:
      y[i] = sin(q[i]);
      break;
    default:
      y[i] = s;
      break;
    }
  }
}

void switch_on_enumerators(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = q[i];
    switch (t->kind[i]) {
    case KIND_ONE:
    case KIND_TWO: {
      a = a * a;
      break;
    }
    case KIND_THREE:
      a *= s;
      break;
    }
    if (t->kind[i] == KIND_ZERO) a = sin(a);
    y[i] = a;
  }
}

enum { HERE_ZERO, HERE_ONE, HERE_TWO };

void enumerators_of_the_file(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    if (t->kind[i] == HERE_TWO)
      y[i] = q[i] * q[HERE_ONE];
    else
      y[i] = s * HERE_TWO;
  }
}

void integer_operators(const topo *t, const double p[t->np], const double q[t->n], double s,
                       double y[t->n])
{
  int i, k, flag;

  for (i = 0; i < t->n; ++i) {
    flag = t->kind[i] > 1;
    k = (t->kind[i] & 1) + (1 << (i % 2)) + (t->kind[i] | 2) / 2;
    y[i] = p[t->kind[i] > 1 ? 0 : 3] * p[k] * q[i];
    if (flag) y[i] += s * s;
    if (!flag && k != 2) y[i] -= q[i] * s;
    y[i] += 0x2 * s - (-3) * q[i] * (k % 2 ? 1.0 : 2.0);
  }
}

void equal_and_unequal(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    if (MAGGI_RE(q[i]) == 0.5)
      y[i] = s;
    else
      y[i] = q[i] * q[i];
    if (MAGGI_RE(s) != MAGGI_RE(q[i])) y[i] += s * q[i];
  }
}

void conditions_that_change_what_they_ask(const topo *t, const double q[t->n], double s,
                                          double y[t->n])
{
  int i, k;
  double a, b;

  for (i = 0; i < t->n; ++i) {
    a = q[i];
    b = s;
    k = t->kind[i];
    if (MAGGI_RE(a) < MAGGI_RE(b)) {
      a = a * b;
      if (k > 1) {
        k = k - 1;
        b = a * a;
      } else {
        a = b - a;
      }
    } else if (MAGGI_RE(a) > 0.5) {
      b = sin(a);
      a = a * b;
    }
    if (k == 1) b = b * a;
    y[i] = a * b;
  }
}

void branches_in_carried_loops(const topo *t, const double X[t->n + 1][3], double s, double y[t->n],
                               double e[1])
{
  int i, k;
  double a, b;

  a = s;
  b = 0.5;
  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) {
      if (MAGGI_RE(a) > MAGGI_RE(X[i][k])) {
        a = 0.5 * a * a;
      } else {
        b = a * X[i][k] + 0.5 * b;
        a = sin(b);
      }
    }
    if (t->kind[i] != 1) {
      y[i] = a * b;
      b = 0.5 * a;
    } else {
      y[i] = a;
    }
  }
  e[0] = a * a + b;
}
