/* Eigenvalues of [[0 1], [a_q a_v]], by GSL. */
#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>

#include "modes.h"

typedef struct work {
  gsl_matrix *a;
  gsl_eigen_nonsymmv_workspace *space;
  gsl_vector_complex *value;
  gsl_matrix_complex *vector;
} work;

static int create(work *w, int n, const double *a_q, const double *a_v)
{
  size_t i, k, size = 2 * (size_t)n, un = (size_t)n;

  w->a = gsl_matrix_calloc(size, size);
  w->space = gsl_eigen_nonsymmv_alloc(size);
  w->value = gsl_vector_complex_alloc(size);
  w->vector = gsl_matrix_complex_alloc(size, size);
  if (!w->a || !w->space || !w->value || !w->vector) return 0;
  for (i = 0; i < un; ++i) {
    gsl_matrix_set(w->a, i, un + i, 1.0);
    for (k = 0; k < un; ++k) {
      gsl_matrix_set(w->a, un + i, k, a_q[i * un + k]);
      gsl_matrix_set(w->a, un + i, un + k, a_v[i * un + k]);
    }
  }
  return 1;
}

static void destroy(work *w)
{
  gsl_matrix_free(w->a);
  if (w->space) gsl_eigen_nonsymmv_free(w->space);
  gsl_vector_complex_free(w->value);
  gsl_matrix_complex_free(w->vector);
}

/* the coordinate with the largest share y_i (mass y)_i of the kinetic energy of a mode */
static int most(const work *w, size_t k, int n, const double *mass)
{
  double share, largest = -1.0;
  gsl_complex y, z;
  int i, c, best = 0;

  for (i = 0; i < n; ++i) {
    y = gsl_matrix_complex_get(w->vector, (size_t)i, k);
    share = 0.0;
    for (c = 0; c < n; ++c) {
      z = gsl_matrix_complex_get(w->vector, (size_t)c, k);
      share += mass[i * n + c] * (GSL_REAL(y) * GSL_REAL(z) + GSL_IMAG(y) * GSL_IMAG(z));
    }
    if (share > largest) {
      largest = share;
      best = i;
    }
  }
  return best;
}

static int compare(const void *a, const void *b)
{
  const mode *x = a, *y = b;
  double u = hypot(x->real, x->imaginary), v = hypot(y->real, y->imaginary);

  return (u > v) - (u < v);
}

int modes_find(int n, const double *a_q, const double *a_v, const double *mass, mode *modes)
{
  gsl_error_handler_t *handler;
  work w = {NULL, NULL, NULL, NULL};
  int count = 0, ok;
  size_t k;
  gsl_complex z;

  if (n == 0) return 0;
  handler = gsl_set_error_handler_off();
  ok =
      create(&w, n, a_q, a_v) && gsl_eigen_nonsymmv(w.a, w.value, w.vector, w.space) == GSL_SUCCESS;
  for (k = 0; ok && k < 2 * (size_t)n; ++k) {
    z = gsl_vector_complex_get(w.value, k);
    if (GSL_IMAG(z) < 0.0) continue;
    modes[count++] = (mode){GSL_REAL(z), GSL_IMAG(z), most(&w, k, n, mass)};
  }
  destroy(&w);
  gsl_set_error_handler(handler);
  if (!ok) return -1;
  qsort(modes, (size_t)count, sizeof *modes, compare);
  return count;
}
