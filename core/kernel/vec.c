#include "vec.h"

double maggi_dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double maggi_dot6(const double a[6], const double b[6])
{
  return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) + (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

void maggi_cross(const double a[3], const double b[3], double c[3])
{
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

void maggi_mul(const double A[9], const double a[3], double c[3])
{
  c[0] = A[0] * a[0] + A[1] * a[1] + A[2] * a[2];
  c[1] = A[3] * a[0] + A[4] * a[1] + A[5] * a[2];
  c[2] = A[6] * a[0] + A[7] * a[1] + A[8] * a[2];
}

void maggi_point_rate(const double Z[6], const double r[3], double c[3])
{
  c[0] = Z[0] + Z[4] * r[2] - Z[5] * r[1];
  c[1] = Z[1] + Z[5] * r[0] - Z[3] * r[2];
  c[2] = Z[2] + Z[3] * r[1] - Z[4] * r[0];
}

/* momentum (m s + w × h, h × s + J w) of an inertia m, h, J xx yy zz xy xz yz */
void maggi_inertia_mul(const double I[10], const double Z[6], double H[6])
{
  H[0] = I[0] * Z[0] + Z[4] * I[3] - Z[5] * I[2];
  H[1] = I[0] * Z[1] + Z[5] * I[1] - Z[3] * I[3];
  H[2] = I[0] * Z[2] + Z[3] * I[2] - Z[4] * I[1];
  H[3] = I[2] * Z[2] - I[3] * Z[1] + I[4] * Z[3] + I[7] * Z[4] + I[8] * Z[5];
  H[4] = I[3] * Z[0] - I[1] * Z[2] + I[7] * Z[3] + I[5] * Z[4] + I[9] * Z[5];
  H[5] = I[1] * Z[1] - I[2] * Z[0] + I[8] * Z[3] + I[9] * Z[4] + I[6] * Z[5];
}

void maggi_wrench_add(const double force[3], const double r[3], double F[6])
{
  F[0] += force[0];
  F[1] += force[1];
  F[2] += force[2];
  F[3] += r[1] * force[2] - r[2] * force[1];
  F[4] += r[2] * force[0] - r[0] * force[2];
  F[5] += r[0] * force[1] - r[1] * force[0];
}
