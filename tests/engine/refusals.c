/* What the engine refuses, a function each: the line behind the comment REFUSED, in its words;
 * `@-2` is the number of the line that is two before it. */
#include "kernel.h"

void jump(const topo *t, const double q[t->n], double y[t->n])
{
  y[0] = q[0];
  /* REFUSED goto */
  goto end;
end:
  y[1] = q[1];
}

void while_loop(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  i = 0;
  /* REFUSED a while loop: its number of passes must come from the integers */
  while (i < t->n) {
    y[i] = q[i];
    i += 1;
  }
}

void do_loop(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  i = 0;
  /* REFUSED a do loop: its number of passes must come from the integers */
  do {
    y[i] = q[i];
    i += 1;
  } while (i < t->n);
}

void break_from_loop(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    /* REFUSED break out of a loop */
    if (t->kind[i] == 2) break;
  }
}

void next_pass(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    /* REFUSED continue */
    if (t->kind[i] == 2) continue;
    y[i] = q[i];
  }
}

void early_return(const topo *t, const double q[t->n], double y[t->n])
{
  y[0] = q[0];
  /* REFUSED early return in a differentiated function */
  if (t->n < 2) return;
  y[1] = q[1];
}

static double clip(double x)
{
  /* REFUSED early return in a differentiated function */
  if (MAGGI_RE(x) < 0.0) return 0.0;
  return x;
}

void early_return_of_a_value(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = clip(q[i]);
}

/* REFUSED `both` does not end with its return */
static double both(double x)
{
  if (MAGGI_RE(x) < 0.0)
    return 0.0;
  else
    return x;
}

void no_return(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = both(q[i]);
}

static double power(double x, int n)
{
  /* REFUSED `power` is recursive */
  return n > 0 ? x * power(x, n - 1) : 1.0;
}

void recursion(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = power(q[i], 3);
}

static double one(double x, int n);

static double two(double x, int n)
{
  /* REFUSED `one` is recursive */
  return n > 0 ? x * one(x, n - 1) : 1.0;
}

static double one(double x, int n)
{
  return two(x, n) + x;
}

void recursion_through_another(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = one(q[i], 3);
}

void falling_through_a_case(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    switch (t->kind[i]) {
    /* REFUSED a case that falls through */
    case 0:
      y[i] = q[i];
    case 1:
      y[i] = s;
      break;
    }
  }
}

void counter_changed(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  /* REFUSED the loop variable `i` is changed in the loop */
  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    i += 1;
  }
}

void bound_changed(const topo *t, const double q[t->n], double y[t->n])
{
  int i, m;

  m = t->n;
  /* REFUSED the loop bound `m` is changed in the loop */
  for (i = 0; i < m; ++i) {
    y[i] = q[i];
    if (t->kind[i] == 2) m = m - 1;
  }
}

void bound_from_an_active_value(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  /* REFUSED a loop bound that is not an expression of integers */
  for (i = 0; i < s; ++i) y[i] = q[i];
}

void loop_over_a_double(const topo *t, double s, double y[t->n])
{
  double a;

  y[0] = 0.0;
  /* REFUSED a for loop that is not `for (i = a; i < b; ++i)` */
  for (a = 0.0; a < 1.0; a += 0.25) y[0] += a * s;
}

void loop_with_two_counters(const topo *t, const double q[t->n], const double X[t->n + 1][3],
                            double y[t->n])
{
  int i, k;

  /* REFUSED a for loop that is not `for (i = a; i < b; ++i)` */
  for (i = 0, k = 2; i < t->n; ++i) y[i] = q[i] + X[0][k];
}

void loop_that_doubles(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  /* REFUSED a for loop that is not `for (i = a; i < b; ++i)` */
  for (i = 1; i < t->n; i *= 2) y[i] = q[i];
}

void loop_without_end(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  /* REFUSED a for loop that is not `for (i = a; i < b; ++i)` */
  for (i = 0;; ++i) y[i] = q[i];
}

static void cross(const double a[3], const double b[3], double r[3])
{
  r[0] = a[1] * b[2] - a[2] * b[1];
  r[1] = a[2] * b[0] - a[0] * b[2];
  r[2] = a[0] * b[1] - a[1] * b[0];
}

void address_of_an_element(const topo *t, const double p[t->np], const double X[t->n + 1][3],
                           double Y[t->n + 1][3])
{
  /* REFUSED an interior pointer: pass a row of a two-dimensional array, or the array and an index
   * */
  cross(&p[0], X[0], Y[0]);
}

void array_plus_a_number(const topo *t, const double p[t->np], const double X[t->n + 1][3],
                         double Y[t->n + 1][3])
{
  /* REFUSED an interior pointer: `p` in an expression; pass a row of a two-dimensional array, or
   * the array and an index */
  cross(p + 3, X[0], Y[0]);
}

void local_pointer(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED `u` is a local pointer */
  const double *u;

  u = q;
  y[0] = u[0];
}

void local_pointer_with_a_value(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED `u` is a local pointer */
  const double *u = q;

  y[0] = u[0];
}

void pointer_followed(const topo *t, const double q[t->n], double s, double y[t->n])
{
  /* REFUSED a pointer is followed */
  y[0] = *q * s;
}

/* REFUSED `a` is a bare pointer: say how long the array is */
static double first(const double *a)
{
  return a[0];
}

void bare_pointer(const topo *t, const double q[t->n], double s, double y[t->n])
{
  y[0] = first(q) * s;
}

/* REFUSED `a` is a bare pointer: say how long the array is */
static double second(const double *restrict a)
{
  return a[0];
}

void restrict_pointer(const topo *t, const double q[t->n], double s, double y[t->n])
{
  y[0] = second(q) * s;
}

/* REFUSED `a`: `static` in brackets */
static double third(const double a[static 3])
{
  return a[0];
}

void static_in_brackets(const topo *t, const double q[t->n], double s, double y[t->n])
{
  y[0] = third(q) * s;
}

/* REFUSED `a` is a pointer to a pointer */
static void touch(double **a)
{
  (void)a;
}

void pointer_to_a_pointer(const topo *t, const double q[t->n], double s, double y[t->n])
{
  y[0] = q[0] * s;
  touch(0);
}

/* REFUSED `f` is a pointer to a function */
static double apply(double (*f)(double), double x)
{
  return f(x);
}

void function_pointer(const topo *t, const double q[t->n], double y[t->n])
{
  y[0] = apply(sin, q[0]);
}

/* REFUSED `A` has more than two dimensions */
static void touch_3(double A[2][3][3])
{
  (void)A;
}

void three_dimensions(const topo *t, const double q[t->n], double s, double y[t->n])
{
  y[0] = q[0] * s;
  touch_3(0);
}

void *malloc(unsigned long size);

void free(void *p);

void memory_allocated(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED `a` is a local pointer */
  double *a = malloc(3 * sizeof(double));

  a[0] = q[0];
  y[0] = a[0];
  free(a);
}

void *memcpy(void *to, const void *from, unsigned long size);

void memory_copied(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED `memcpy` on active data */
  memcpy(y, q, t->n * 8);
}

void *memset(void *to, int c, unsigned long size);

void memory_set(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED `memset` on active data */
  memset(y, 0, t->n * 8);
  y[0] += q[0];
}

void output_is_an_input(const topo *t, const double q[t->n], const double X[t->n + 1][3], double s,
                        double y[t->n])
{
  double r[3];

  r[0] = q[0];
  r[1] = s;
  r[2] = q[1];
  /* REFUSED output `r` of `cross` is an input as well: `b` */
  cross(X[0], r, r);
  y[0] = r[0];
}

void output_row_is_an_input_row(const topo *t, const double X[t->n + 1][3], double Y[t->n + 1][3])
{
  int i, k;

  for (k = 0; k < 3; ++k) Y[t->n][k] = X[0][k];
  /* REFUSED output `r` of `cross` is an input as well: `b` */
  for (i = 0; i < t->n; ++i) cross(X[i], Y[i], Y[i]);
}

static void copies(const double a[3], double u[3], double v[3])
{
  int k;

  for (k = 0; k < 3; ++k) {
    u[k] = a[k];
    v[k] = 2.0 * a[k];
  }
}

void output_is_another_output(const topo *t, const double X[t->n + 1][3], double y[t->n])
{
  double r[3];

  /* REFUSED output `u` of `copies` is another output as well: `v` */
  copies(X[0], r, r);
  y[0] = r[0];
}

static void row(const topo *t, int i, const double a[3], double B[t->n + 1][3])
{
  int k;

  for (k = 0; k < 3; ++k) B[i + 1][k] = a[k];
}

void whole_array_and_its_row(const topo *t, double Y[t->n + 1][3])
{
  int i;

  /* REFUSED output `B` of `row` is an input as well: `a` */
  for (i = 0; i < t->n; ++i) row(t, i, Y[i], Y);
}

void initialiser(const topo *t, const double q[t->n], double s, double y[t->n])
{
  /* REFUSED `a` is initialised where it is declared: assign to it */
  double a = sin(q[0]);

  y[0] = a * s;
}

void initialiser_of_an_array(const topo *t, const double q[t->n], double s, double y[t->n])
{
  /* REFUSED `a` is initialised where it is declared: assign to it */
  double a[3] = {q[0], -s, 0.0};

  y[0] = a[0] * a[1];
}

void const_local(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    /* REFUSED `a` is a const local: the adjoint would read it unset */
    const double a = q[i] * s;
    y[i] = a * a;
  }
}

void const_integer_local(const topo *t, const double X[t->n + 1][3], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    /* REFUSED `k` is a const local: the adjoint would read it unset */
    const int k = t->parent[i];
    y[i] = X[k][0] * s;
  }
}

void static_local(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED `count` is static: it keeps a value between calls */
  static double count;

  count = q[0];
  y[0] = count;
}

static double scale = 2.0;

void global_variable_read(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED `scale` is a variable outside of functions */
  y[0] = scale * q[0];
}

double last;

void global_variable_written(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED `last` is a variable outside of functions */
  last = q[0];
  y[0] = q[0];
}

void variable_length(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;
  /* REFUSED `a` is a local array of variable length */
  double a[t->n];

  for (i = 0; i < t->n; ++i) a[i] = q[i];
  for (i = 0; i < t->n; ++i) y[i] = a[i] * s;
}

void float_local(const topo *t, const double q[t->n], double s, double y[t->n])
{
  /* REFUSED `a` is a local float */
  float a;

  a = q[0];
  y[0] = a * s;
}

typedef struct pair {
  double x, y;
} pair;

void struct_by_value(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED `a` is a local pair */
  pair a;

  a.x = q[0];
  y[0] = a.x;
}

static const pair m = {1.0, 2.0};

/* REFUSED `a` is passed by value and is neither int nor double (pair) */
static double sum(pair a)
{
  return a.x + a.y;
}

void struct_argument_by_value(const topo *t, const double q[t->n], double y[t->n])
{
  y[0] = sum(m) * q[0];
}

void member_of_type_double(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED a member of a structure */
  y[0] = q[0] * m.x;
}

union number {
  double x;
  int i;
};

void union_local(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED `u` is a local union number */
  union number u;

  u.x = q[0];
  y[0] = u.x;
}

/* REFUSED a variable number of arguments */
static double total(int n, ...)
{
  return n;
}

void variable_number_of_arguments(const topo *t, const double q[t->n], double s, double y[t->n])
{
  y[0] = total(2, q[0], s);
}

/* REFUSED `x` is passed by value and is neither int nor double (float) */
static double half(float x)
{
  return 0.5 * x;
}

void float_argument(const topo *t, const double q[t->n], double y[t->n])
{
  y[0] = half(q[0]);
}

/* REFUSED `half_of` returns neither double nor int nor void */
static float half_of(double x)
{
  return 0.5 * x;
}

void float_value(const topo *t, const double q[t->n], double y[t->n])
{
  y[0] = half_of(q[0]);
}

void argument_overwritten(const topo *t, const double q[t->n], double s, double y[t->n])
{
  /* REFUSED the parameter `s` is overwritten */
  s = sin(s);
  y[0] = s * q[0];
}

void index_with_a_side_effect(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  i = 0;
  /* REFUSED a side effect in an expression (++) */
  y[i++] = q[0];
}

void assignment_in_an_expression(const topo *t, const double q[t->n], double y[t->n])
{
  double a, b;

  /* REFUSED a side effect in an expression (an assignment) */
  a = b = q[0];
  y[0] = a * b;
}

void comma(const topo *t, const double q[t->n], double s, double y[t->n])
{
  double a;

  /* REFUSED the comma operator */
  a = (s, q[0]);
  y[0] = a;
}

void statement_with_a_comma(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED the comma operator */
  y[0] = q[0], y[1] = q[1];
}

void active_value_as_an_integer(const topo *t, const double p[t->np], const double q[t->n],
                                double s, double y[t->n])
{
  int k;

  /* REFUSED an active value is converted to int */
  k = (int)q[0];
  y[0] = p[k] * s;
}

void active_value_assigned_to_an_integer(const topo *t, const double p[t->np], const double q[t->n],
                                         double s, double y[t->n])
{
  int k;

  /* REFUSED `k` is an int and gets an active value */
  k = q[0];
  y[0] = p[k] * s;
}

void active_value_as_an_index(const topo *t, const double p[t->np], const double q[t->n], double s,
                              double y[t->n])
{
  /* REFUSED an active value is converted to int */
  y[0] = p[(int)q[0]] * s;
}

double mystery(double x);

void unknown_function(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED no derivative is known of `mystery`, which is neither in these sources nor
   * elementary */
  y[0] = mystery(q[0]);
}

void mystery_of_arrays(const double a[3], double r[3]);

void unknown_function_without_value(const topo *t, const double q[t->n], double y[t->n])
{
  /* REFUSED no derivative is known of `mystery_of_arrays`, which is neither in these sources nor
   * elementary */
  mystery_of_arrays(q, y);
}

void written_again(const topo *t, const double q[t->n], double s, double y[t->n])
{
  y[0] = q[0];
  y[1] = q[1];
  /* REFUSED an element of `y` is written again, first in line @-3 */
  y[0] = q[0] * s;
}

void written_again_from_itself(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    /* REFUSED an element of `y` is written again, first in line @-2 */
    y[i] = y[i] * s;
  }
}

void written_after_it_was_added_to(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] += q[i];
    /* REFUSED an element of `y` is written again, first in line @-2 */
    y[i] = q[i] * s;
  }
}

void written_in_each_pass(const topo *t, const double q[t->n], double y[t->n])
{
  int i;

  /* REFUSED an element of `y` is written in each pass of the loop over `i` */
  for (i = 0; i < t->n; ++i) y[0] = q[i];
}

void written_in_each_pass_of_the_outer_loop(const topo *t, const double X[t->n + 1][3],
                                            double Y[t->n + 1][3])
{
  int i, k;

  for (i = 0; i < t->n; ++i)
    /* REFUSED an element of `Y` is written in each pass of the loop over `i` */
    for (k = 0; k < 3; ++k) Y[0][k] = X[i][k];
}

void multiplied(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    /* REFUSED `y` is overwritten: *= on an array element */
    y[i] *= s;
  }
}

void divided(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    /* REFUSED `y` is overwritten: /= on an array element */
    y[i] /= s;
  }
}

void local_array_added_to_after_it_was_read(const topo *t, const double q[t->n], double s,
                                            double y[t->n])
{
  int i;
  double g[5];

  for (i = 0; i < t->n; ++i) g[i] = q[i];
  for (i = 0; i < t->n; ++i) {
    y[i] = g[i] * g[i];
    /* REFUSED `g` changes after its values were used: give the new ones an array of their own */
    g[t->perm[i]] += s * q[i];
  }
}

void local_array_written_again(const topo *t, const double q[t->n], double s, double y[t->n])
{
  int i;
  double g[5];

  for (i = 0; i < t->n; ++i) g[i] = q[i] * s;
  for (i = 0; i < t->n; ++i) y[i] = g[i] * g[i];
  /* REFUSED `g` changes after its values were used: give the new ones an array of their own */
  for (i = 0; i < t->n; ++i) g[i] = sin(q[i]);
  for (i = 0; i < t->n; ++i) y[i] += g[i] * g[i];
}

void local_array_carried(const topo *t, const double q[t->n], const double X[t->n + 1][3],
                         double y[t->n])
{
  int i, k;
  double g[5];

  for (k = 0; k < t->n; ++k) g[k] = q[k];
  for (i = 0; i < t->n; ++i) {
    y[i] = g[i] * g[0];
    /* REFUSED `g` changes after its values were used: give the new ones an array of their own */
    for (k = 0; k < t->n; ++k) g[k] = 0.5 * g[k] * g[k] + X[i][0];
  }
}

void read_before_it_is_complete(const topo *t, const double q[t->n], double s, double y[t->n],
                                double Y[t->n + 1][3])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i] * s;
    Y[i][0] = y[i] * y[i];
    /* REFUSED an element of `y` changes after its value was used in line @-2 */
    y[i] += q[i];
  }
}

void counter_after_its_loop(const topo *t, const double p[t->np], const double q[t->n], double s,
                            double y[t->n])
{
  int i, k;

  for (i = 0; i < t->n; ++i) {
    y[i] = s;
    for (k = 0; k < t->count[i]; ++k) y[i] += p[k] * q[i];
    /* REFUSED the loop variable `k` is read outside of its loop */
    y[i] += p[k] * q[i] * p[k];
  }
}
