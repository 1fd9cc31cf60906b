/* Inertias and inertia forces at the reference point.  FORMULATION 3 and 5. */
#include "kernel.h"

/* J = A J0 A^T, h = A h0 about the joint point x, moved to P:
 *   h += m x,  J += (x.s) I - (x s^T + s x^T)/2,  s = m x + 2 A h0 */
static void body_inertia(const double body0[10], const double A[9], const double x[3], double I[10])
{
  int k;
  double m, xs;
  double h0[3], h[3], s[3], B[9];

  m = body0[0];
  h0[0] = body0[1];
  h0[1] = body0[2];
  h0[2] = body0[3];
  maggi_mul(A, h0, h);
  s[0] = m * x[0] + 2.0 * h[0];
  s[1] = m * x[1] + 2.0 * h[1];
  s[2] = m * x[2] + 2.0 * h[2];
  xs = maggi_dot(x, s);
  for (k = 0; k < 9; k += 3) {
    B[k] = A[k] * body0[4] + A[k + 1] * body0[7] + A[k + 2] * body0[8];
    B[k + 1] = A[k] * body0[7] + A[k + 1] * body0[5] + A[k + 2] * body0[9];
    B[k + 2] = A[k] * body0[8] + A[k + 1] * body0[9] + A[k + 2] * body0[6];
  }
  I[0] = m;
  I[1] = h[0] + m * x[0];
  I[2] = h[1] + m * x[1];
  I[3] = h[2] + m * x[2];
  I[4] = B[0] * A[0] + B[1] * A[1] + B[2] * A[2] + xs - x[0] * s[0];
  I[5] = B[3] * A[3] + B[4] * A[4] + B[5] * A[5] + xs - x[1] * s[1];
  I[6] = B[6] * A[6] + B[7] * A[7] + B[8] * A[8] + xs - x[2] * s[2];
  I[7] = B[0] * A[3] + B[1] * A[4] + B[2] * A[5] - 0.5 * (x[0] * s[1] + x[1] * s[0]);
  I[8] = B[0] * A[6] + B[1] * A[7] + B[2] * A[8] - 0.5 * (x[0] * s[2] + x[2] * s[0]);
  I[9] = B[3] * A[6] + B[4] * A[7] + B[5] * A[8] - 0.5 * (x[1] * s[2] + x[2] * s[1]);
}

/* bodies without inertia keep the zeros they were given at the start */
void maggi_body_inertias(const maggi_topo *t, const double body0[t->nbody][10],
                         const double A[t->nbody + 1][9], const double x[t->nbody + 1][3],
                         double I[t->nbody][10])
{
  int i;

  for (i = 0; i < t->nmassive; ++i)
    body_inertia(body0[t->massive[i]], A[t->massive[i]], x[t->massive[i]], I[t->massive[i]]);
}

/* minus d/dt of the momentum H = I Z about the fixed P:
 *   F = I Z' + (w × H_lin, w × H_ang + s × H_lin) */
static void inertia_force(const double I[10], const double Z[6], const double Za[6], double F[6])
{
  double H[6], D[6];

  maggi_inertia_mul(I, Z, H);
  maggi_inertia_mul(I, Za, D);
  F[0] = -D[0] - (Z[4] * H[2] - Z[5] * H[1]);
  F[1] = -D[1] - (Z[5] * H[0] - Z[3] * H[2]);
  F[2] = -D[2] - (Z[3] * H[1] - Z[4] * H[0]);
  F[3] = -D[3] - (Z[4] * H[5] - Z[5] * H[4] + Z[1] * H[2] - Z[2] * H[1]);
  F[4] = -D[4] - (Z[5] * H[3] - Z[3] * H[5] + Z[2] * H[0] - Z[0] * H[2]);
  F[5] = -D[5] - (Z[3] * H[4] - Z[4] * H[3] + Z[0] * H[1] - Z[1] * H[0]);
}

/* bodies without inertia keep the zeros they were given at the start; rods and loops add to the ground */
void maggi_inertia_forces(const maggi_topo *t, const double I[t->nbody][10],
                          const double Z[t->nbody + 1][6], const double Za[t->nbody + 1][6],
                          double F[t->nbody + 1][6])
{
  int i, k;

  for (k = 0; k < 6; ++k) F[t->nbody][k] = 0.0;
  for (i = 0; i < t->nmassive; ++i)
    inertia_force(I[t->massive[i]], Z[t->massive[i]], Za[t->massive[i]], F[t->massive[i]]);
}

static void coupled_force(double m, const double a[3], const double r[3], double F[6])
{
  double f[3];

  f[0] = -m / 6.0 * a[0];
  f[1] = -m / 6.0 * a[1];
  f[2] = -m / 6.0 * a[2];
  maggi_wrench_add(f, r, F);
}

/* rods: -m a_b / 6 at end a and -m a_a / 6 at end b; the thirds are point masses of the bodies */
void maggi_rod_forces(const maggi_topo *t, const double p[t->np], const double r[t->npoint][3],
                      const double ra[t->npoint][3], double F[t->nbody + 1][6])
{
  int i, a, b;

  for (i = 0; i < t->nrod; ++i) {
    a = t->rodpa[i];
    b = t->rodpb[i];
    coupled_force(p[t->rodadr[i]], ra[b], r[a], F[t->pointbody[a]]);
    coupled_force(p[t->rodadr[i]], ra[a], r[b], F[t->pointbody[b]]);
  }
}

/* both ends of a rod on one rigid body: mass m/3, first moment m/6 (a + b),
 * J = m/6 (2 a.b I - a b^T - b a^T) */
static void rod_inertia_add(double m, const double a[3], const double b[3], double I[10])
{
  double f, ab;

  f = m / 6.0;
  ab = maggi_dot(a, b);
  I[0] += 2.0 * f;
  I[1] += f * (a[0] + b[0]);
  I[2] += f * (a[1] + b[1]);
  I[3] += f * (a[2] + b[2]);
  I[4] += 2.0 * f * (ab - a[0] * b[0]);
  I[5] += 2.0 * f * (ab - a[1] * b[1]);
  I[6] += 2.0 * f * (ab - a[2] * b[2]);
  I[7] -= f * (a[0] * b[1] + a[1] * b[0]);
  I[8] -= f * (a[0] * b[2] + a[2] * b[0]);
  I[9] -= f * (a[1] * b[2] + a[2] * b[1]);
}

static void inertia_add(const double I[10], double IS[10])
{
  int k;

  for (k = 0; k < 10; ++k) IS[k] += I[k];
}

static void inertia_copy(const double I[10], double IS[10])
{
  int k;

  for (k = 0; k < 10; ++k) IS[k] = I[k];
}

/* IS_i = I_i + sum over children; a rod counts once, on the body that carries both its ends */
void maggi_composite_inertias(const maggi_topo *t, const double p[t->np],
                              const double r[t->npoint][3], const double I[t->nbody][10],
                              double IS[t->nbody + 1][10])
{
  int i, k;

  for (k = 0; k < 10; ++k) IS[t->nbody][k] = 0.0;
  for (i = 0; i < t->nbody; ++i) inertia_copy(I[i], IS[i]);
  for (i = 0; i < t->nrod; ++i)
    rod_inertia_add(p[t->rodadr[i]], r[t->rodpa[i]], r[t->rodpb[i]], IS[t->rodcommon[i]]);
  for (i = 0; i < t->nbody; ++i) inertia_add(IS[i], IS[t->parent[i]]);
}

static void wrench_sum(const double F[6], double FS[6])
{
  int k;

  for (k = 0; k < 6; ++k) FS[k] += F[k];
}

static void wrench_first(const double F[6], const double Q[6], double FS[6])
{
  int k;

  for (k = 0; k < 6; ++k) FS[k] = F[k] + Q[k];
}

/* FS_i = F_i + Q_i + sum over children */
void maggi_accumulate(const maggi_topo *t, const double F[t->nbody + 1][6],
                      const double Q[t->nbody + 1][6], double FS[t->nbody + 1][6])
{
  int i;

  for (i = 0; i <= t->nbody; ++i) wrench_first(F[i], Q[i], FS[i]);
  for (i = 0; i < t->nbody; ++i) wrench_sum(FS[i], FS[t->parent[i]]);
}
