/* Vectors and 3x3 matrices (row major) of the property tests. */
#ifndef MAGGI_TESTS_VECTOR_H
#define MAGGI_TESTS_VECTOR_H

#include <math.h>

static inline double v3_dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double v3_norm(const double a[3])
{
  return sqrt(v3_dot(a, a));
}

static inline void v3_cross(const double a[3], const double b[3], double c[3])
{
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

/* c = a + s b */
static inline void v3_axpy(const double a[3], double s, const double b[3], double c[3])
{
  int k;

  for (k = 0; k < 3; ++k)
    c[k] = a[k] + s * b[k];
}

static inline void v3_unit(const double a[3], double u[3])
{
  double n = v3_norm(a);
  int k;

  for (k = 0; k < 3; ++k)
    u[k] = a[k] / n;
}

static inline void m3_mul(const double A[9], const double x[3], double y[3])
{
  int k;

  for (k = 0; k < 3; ++k)
    y[k] = A[3 * k] * x[0] + A[3 * k + 1] * x[1] + A[3 * k + 2] * x[2];
}

static inline void m3_mul_t(const double A[9], const double x[3], double y[3])
{
  int k;

  for (k = 0; k < 3; ++k)
    y[k] = A[k] * x[0] + A[k + 3] * x[1] + A[k + 6] * x[2];
}

static inline void m3_mul3(const double A[9], const double B[9], double C[9])
{
  int i, k;

  for (i = 0; i < 3; ++i)
    for (k = 0; k < 3; ++k)
      C[3 * i + k] = A[3 * i] * B[k] + A[3 * i + 1] * B[k + 3] + A[3 * i + 2] * B[k + 6];
}

/* rotation about the unit vector u */
static inline void m3_rotation(const double u[3], double angle, double R[9])
{
  double s = sin(angle), h = sin(0.5 * angle), c1 = 2.0 * h * h;
  int i, k;

  for (i = 0; i < 3; ++i)
    for (k = 0; k < 3; ++k)
      R[3 * i + k] = i == k ? 1.0 - c1 * (1.0 - u[i] * u[i]) : c1 * u[i] * u[k];
  R[1] -= s * u[2];
  R[2] += s * u[1];
  R[3] += s * u[2];
  R[5] -= s * u[0];
  R[6] -= s * u[1];
  R[7] += s * u[0];
}

#endif
