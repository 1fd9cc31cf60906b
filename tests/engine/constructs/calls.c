/* Calls, file-scope constants, and names. */
#include "kernel.h"

static const double weight[3] = {0.5, 0.25, 0.125};

static const double third = 1.0 / 3.0;

static const int next[3] = {1, 2, 0};

void constants_of_the_file(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = q[i] * weight[i % 3] + s * third + q[next[i % 3]];
}

#define HALF 0.5

#define SQUARE(x) ((x) * (x))

void macros(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = SQUARE(q[i]) * HALF + s;
}

static double square(double a)
{
  return a * a;
}

void value_of_a_helper(const topo *t, const double p[t->np], const double q[t->n], double s,
                       double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = square(q[i]) * square(s + p[i]) + square(2.0);
}

static double twice(double a, int k)
{
  double b, d;

  b = square(a);
  d = b;
  if (k > 0) d = square(b) * a;
  return 2.0 * d + b;
}

void helper_of_helpers(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = twice(square(q[i]), i) - twice(s, 1);
}

static double slopes(double c1, double c2, double v1, double v2, double v)
{
  double f;

  if (MAGGI_RE(v) > MAGGI_RE(v1))
    f = c1 * v1 + c2 * (v - v1);
  else if (MAGGI_RE(v) > 0.0)
    f = c1 * v;
  else if (MAGGI_RE(v) > MAGGI_RE(v2))
    f = c2 * v;
  else
    f = c2 * v2 + c1 * (v - v2);
  return f;
}

void helper_with_branches(const topo *t, const double p[t->np], const double q[t->n], double s,
                          double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = slopes(p[0], p[1], p[2] * p[2], s, q[i]);
}

static void cross(const double a[3], const double b[3], double r[3])
{
  r[0] = a[1] * b[2] - a[2] * b[1];
  r[1] = a[2] * b[0] - a[0] * b[2];
  r[2] = a[0] * b[1] - a[1] * b[0];
}

void rows_as_arguments(const topo *t, const double X[t->n + 1][3], double Y[t->n + 1][3])
{
  int i;

  for (i = 0; i < t->n; ++i) cross(X[i], X[t->parent[i]], Y[i]);
}

void rows_of_one_array_in_and_out(const topo *t, const double X[t->n + 1][3], double Y[t->n + 1][3])
{
  int i, k;

  for (k = 0; k < 3; ++k) Y[t->n][k] = X[t->n][k];
  for (i = t->n - 1; i >= 0; --i) cross(Y[t->parent[i]], X[i], Y[i]);
}

static double dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void one_array_twice_as_an_argument(const topo *t, const double X[t->n + 1][3], double s,
                                    double y[t->n])
{
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k] * s;
    y[i] = dot(w, w) + dot(X[i], X[i]);
  }
}

void two_rows_that_may_be_one(const topo *t, const double X[t->n + 1][3], double y[t->n],
                              double Y[t->n + 1][3])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = dot(X[t->from[i]], X[t->to[i]]) + dot(X[0], X[i]);
    cross(X[t->perm[i]], X[i], Y[i]);
  }
}

void local_arrays_as_arguments(const topo *t, const double X[t->n + 1][3], double s, double y[t->n])
{
  int i, k;
  double a[3], b[3], r[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) {
      a[k] = X[i][k] * s;
      b[k] = sin(X[i][k]);
    }
    cross(a, b, r);
    y[i] = dot(r, X[t->n]) + dot(b, a) * dot(r, r);
  }
}

void local_array_written_by_a_call_in_each_pass(const topo *t, const double X[t->n + 1][3],
                                                double y[t->n])
{
  int i;
  double r[3], u[3];

  for (i = 0; i < t->n; ++i) {
    cross(X[i], X[t->parent[i]], r);
    cross(r, X[t->n], u);
    y[i] = dot(u, X[t->parent[i]]) * dot(r, r);
  }
}

static void add(const double a[3], double f, double r[3])
{
  int k;

  for (k = 0; k < 3; ++k) r[k] += f * a[k];
}

void output_that_a_helper_adds_to(const topo *t, const double X[t->n + 1][3], double s,
                                  double F[t->n + 1][3])
{
  int m;

  for (m = 0; m < t->ne; ++m) {
    add(X[t->from[m]], s, F[t->to[m]]);
    add(X[t->to[m]], -s * s, F[t->from[m]]);
  }
}

void local_array_that_a_helper_adds_to(const topo *t, const double q[t->n],
                                       const double X[t->n + 1][3], double s, double y[t->n])
{
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k];
    add(X[t->parent[i]], q[i], w);
    add(X[t->n], s, w);
    y[i] = w[0] * w[1] * w[2];
  }
}

static void fetch(int n, const double a[n], int adr, double r[3])
{
  r[0] = a[adr] * a[adr];
  r[1] = a[adr + 1];
  r[2] = a[adr + 2] * r[1];
}

static double horner(int n, const double a[n], int m, double x)
{
  int k;
  double f;

  f = a[0];
  for (k = 1; k < m; ++k) f = f * x + a[k];
  return f;
}

void arrays_and_their_length_as_arguments(const topo *t, const double p[t->np],
                                          const double q[t->n], double y[t->n],
                                          double Y[t->n + 1][3])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    fetch(t->np, p, t->adr[i], Y[i]);
    y[i] = horner(t->np, p, t->count[i] + 1, q[i]);
  }
}

static void row(const topo *t, int i, const double A[t->n + 1][3], double B[t->n + 1][3])
{
  int k;

  for (k = 0; k < 3; ++k) {
    if (i == t->n)
      B[i][k] = A[i][k];
    else
      B[i][k] = B[t->parent[i]][k] * A[i][(k + 1) % 3];
  }
}

void whole_arrays_of_two_dimensions_as_arguments(const topo *t, const double X[t->n + 1][3],
                                                 double Y[t->n + 1][3])
{
  int i;

  for (i = t->n; i >= 0; --i) row(t, i, X, Y);
}

static void put(int at, int n, const double a[3], double x, double r[n])
{
  if (at % 2 == 0)
    r[at] = a[0] * x;
  else
    r[at] = a[1] / (2.0 + x);
}

void outputs_at_an_index(const topo *t, const double q[t->n], const double X[t->n + 1][3],
                         double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) put(i, t->n, X[i], q[i], y);
}

static int rows(int kind)
{
  return kind == 1 || kind == 2 ? 3 : 1;
}

static int piece(int n, const double a[n], double x)
{
  int k;

  for (k = 0; k < n; ++k)
    if (MAGGI_RE(x) < MAGGI_RE(a[k])) return k;
  return n - 1;
}

void integer_helper(const topo *t, const double p[t->np], const double q[t->n], double s,
                    double y[t->n])
{
  int i, k;

  for (i = 0; i < t->n; ++i) {
    k = piece(t->np, p, q[i]);
    if (k < 0) k = 0;
    y[i] = p[k] * q[i] * p[k] + rows(t->kind[i]) * s;
  }
}

static double mix(double a, double b)
{
  double d;

  d = a * b;
  return sin(d) * a + b;
}

void one_helper_active_and_passive(const topo *t, const double q[t->n], double s,
                                   const double c[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = mix(c[i], q[i]) + mix(q[i], c[i]) + mix(c[i], c[0]) + mix(s, s);
}

static double mix_expressi(double a, double b, int k)
{
  return a * b / k + a * a;
}

void expressions_as_arguments(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i)
    y[i] = mix_expressi(q[i] * s + 1.0, t->kind[i] > 1 ? q[i] : sin(s), i + 1);
}

void a_call_in_a_condition(const topo *t, const double q[t->n], const double X[t->n + 1][3],
                           double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    if (MAGGI_RE(dot(X[i], X[t->n])) < MAGGI_RE(s))
      y[i] = dot(X[i], X[i]);
    else
      y[i] = s * q[i];
  }
}

static double after(int n, const double a[n], int k, int by)
{
  k = (k + by) % n;
  if (k < 1) k = 1;
  return a[k] * a[k - 1];
}

void integer_arguments_changed_by_a_helper(const topo *t, const double p[t->np],
                                           const double q[t->n], double y[t->n])
{
  int i, k;

  for (i = 0; i < t->n; ++i) {
    k = t->adr[i];
    y[i] = after(t->np, p, k, 1) * q[i] + after(t->np, p, t->kind[i], 2) * p[k];
  }
}

static double twice_real_arg(double a, double b)
{
  a = a * b;
  b += sin(a) * b;
  if (MAGGI_RE(a) > 0.0) a *= b;
  return a + b;
}

void real_arguments_changed_by_a_helper(const topo *t, const double q[t->n], double s,
                                        double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = twice_real_arg(q[i], s) * twice_real_arg(s, q[i]) + q[i];
}

static double f(double a, double b)
{
  double d;

  d = sin(a) * b;
  return d * a + b;
}

void a_helper_of_itself(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = f(f(f(q[i], s), f(s, q[i])), f(1.0, f(q[i], 2.0)));
}

static double sixth(void)
{
  return 1.0 / 6.0;
}

void helper_without_arguments(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = q[i] * q[i] * sixth() + s;
}

void names_of_the_engine(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i, nd, is_a;
  double a, tb, nbdirs, c2, w0, inv, q_i, t2;

  nd = 1;
  for (i = 0; i < t->n; ++i) {
    is_a = t->kind[i];
    q_i = q[i] * s;
    tb = sin(q_i);
    nbdirs = tb * tb;
    c2 = exp(0.1 * nbdirs) / (2.0 + tb);
    w0 = c2 * c2;
    inv = w0 / (3.0 + c2);
    t2 = inv;
    a = t2 * t2;
    if (MAGGI_RE(a) > 0.1 && is_a > nd) a = a * inv;
    y[i] = a + tb;
  }
}

void rows_that_helpers_add_to_one_after_the_other(const topo *t, const double q[t->n],
                                                  const double X[t->n + 1][3], double s,
                                                  double Y[t->n + 1][3])
{
  int i, k;

  for (i = 0; i <= t->n; ++i)
    for (k = 0; k < 3; ++k) Y[i][k] = X[i][k] * s;
  for (i = 0; i < t->n; ++i) {
    add(X[i], q[i], Y[t->parent[i]]);
    add(X[t->parent[i]], s, Y[i]);
    add(X[0], 2.0, Y[0]);
  }
}

void names_that_a_derivative_could_take(const topo *t, const double q[t->n], double s,
                                        double y[t->n])
{
  int i;
  double qd, yb, qb0, a, ad, sd, t1, inv;

  for (i = 0; i < t->n; ++i) {
    qd = q[i] * q[i];
    yb = qd * s;
    qb0 = sin(yb);
    a = qb0 * qd;
    ad = a / (2.0 + qd * qd);
    sd = ad * a;
    t1 = sd * sd;
    inv = tanh(t1);
    y[i] = inv * inv + ad;
  }
}

void all_together(const topo *t, const double q[t->n], const double X[t->n + 1][3], double s,
                  double y[t->n], double F[t->n + 1][3])
{
  int i, k, m;
  double a, r[3], w[3];

  for (i = 0; i < t->n; ++i) {
    cross(X[t->perm[i]], X[i], r);
    for (k = 0; k < 3; ++k) w[k] = r[k] * q[i];
    add(r, s, w);
    a = s;
    for (m = t->first[i]; m < t->first[i + 1]; ++m) a = 0.5 * a * dot(X[t->from[m]], w) + sin(a);
    if (MAGGI_RE(a) < MAGGI_RE(s)) a = tanh(a * a);
    y[i] = a + dot(w, w) / (2.0 + s);
    add(w, a, F[t->parent[i]]);
  }
}
