/* Small vectors and 3 x 3 matrices (rows, row major).  No output may be an input. */
#ifndef MAGGI_VEC_H
#define MAGGI_VEC_H

double maggi_dot(const double a[3], const double b[3]);
double maggi_dot6(const double a[6], const double b[6]);
void maggi_cross(const double a[3], const double b[3], double c[3]);
void maggi_mul(const double A[9], const double a[3], double c[3]);            /* c = A a */
void maggi_point_rate(const double Z[6], const double r[3], double c[3]);     /* c = s + w x r */
void maggi_inertia_mul(const double I[10], const double Z[6], double H[6]);   /* H = I Z */
void maggi_wrench_add(const double force[3], const double r[3], double F[6]); /* at P, of a force */

#endif
