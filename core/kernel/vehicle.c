/* Motion of a body as who rides in it sees it: in axes that turn with it, across its path, in which
 * direction it goes.  All of it has derivatives at rest. */
#include "kernel.h"

/* u in axes that turn with the yaw of the body alone; tan(yaw) = A_3 / A_0 */
void maggi_level(const double A[9], const double u[3], double s[3])
{
  double h;

  h = sqrt(A[0] * A[0] + A[3] * A[3]);
  s[0] = (A[0] * u[0] + A[3] * u[1]) / h;
  s[1] = (A[0] * u[1] - A[3] * u[0]) / h;
  s[2] = u[2];
}

/* u in axes of the body */
void maggi_in_body(const double A[9], const double u[3], double s[3])
{
  s[0] = A[0] * u[0] + A[3] * u[1] + A[6] * u[2];
  s[1] = A[1] * u[0] + A[4] * u[1] + A[7] * u[2];
  s[2] = A[2] * u[0] + A[5] * u[1] + A[8] * u[2];
}

/* [1] 3.19-3.21.  |n| is n.n / sqrt(n.n + low^2), which is 0 at 0 and has derivatives there */
void maggi_lateral_acceleration(double low_speed, double low, const double v[3], const double a[3],
                                double s[3])
{
  int k;
  double c, w;
  double n[3];

  w = low_speed * low_speed;
  c = maggi_dot(a, v) / (maggi_dot(v, v) + w);
  for (k = 0; k < 3; ++k) n[k] = a[k] - c * v[k];
  s[0] = maggi_dot(n, n) / sqrt(maggi_dot(n, n) + low * low);
  s[1] = (v[0] * a[1] - v[1] * a[0]) / sqrt(v[0] * v[0] + v[1] * v[1] + w);
  s[2] = (a[0] * a[0] + a[1] * a[1]) / sqrt(a[0] * a[0] + a[1] * a[1] + low * low);
}

/* Angle of the velocity u = (u_x, u_y, ..) in level axes:  tan(angle/2) = u_y / (u_x + r),
 * r^2 = u_x^2 + u_y^2 + low^2; backwards, u_x + r = (u_y^2 + low^2) / (r - u_x).  Curvature of the path
 * to the left. */
void maggi_sideslip(double low, const double A[9], const double v[3], const double a[3],
                    double s[3])
{
  double r, d;
  double u[3];

  maggi_level(A, v, u);
  r = sqrt(u[0] * u[0] + u[1] * u[1] + low * low);
  if (MAGGI_RE(u[0]) < 0.0)
    d = (u[1] * u[1] + low * low) / (r - u[0]);
  else
    d = r + u[0];
  s[0] = 2.0 * atan2(u[1], d);
  s[1] = (u[0] * u[0] + u[1] * u[1]) / r;
  s[2] = (v[0] * a[1] - v[1] * a[0]) / (r * r * r);
}
