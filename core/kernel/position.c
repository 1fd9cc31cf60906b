/* Positions from the root to the leaves.  FORMULATION 1.
 *
 * x_i is the joint point of body i, fixed in the body, relative to the reference point P:
 *   revolute   A_i = A_p Rot(u0, q)   x_i = x_p + A_p offset0
 *   prismatic  A_i = A_p              x_i = x_p + A_p (offset0 + u0 q)
 * P rides with the prismatic joints that carry the whole model, so the ground moves the other way.
 */
#include "kernel.h"

/* A = Ap Rot(u, q),  Rot = c I + s u~ + (1 - c) u u^T */
static void rotate(const double Ap[9], const double u[3], double s, double c, double A[9])
{
  int k;
  double v;
  double vx, vy, vz;
  double R[9];

  v = 1.0 - c;
  vx = v * u[0];
  vy = v * u[1];
  vz = v * u[2];
  R[0] = c + vx * u[0];
  R[1] = vx * u[1] - s * u[2];
  R[2] = vx * u[2] + s * u[1];
  R[3] = vx * u[1] + s * u[2];
  R[4] = c + vy * u[1];
  R[5] = vy * u[2] - s * u[0];
  R[6] = vx * u[2] - s * u[1];
  R[7] = vy * u[2] + s * u[0];
  R[8] = c + vz * u[2];
  for (k = 0; k < 3; ++k) {
    A[3 * k] = Ap[3 * k] * R[0] + Ap[3 * k + 1] * R[3] + Ap[3 * k + 2] * R[6];
    A[3 * k + 1] = Ap[3 * k] * R[1] + Ap[3 * k + 1] * R[4] + Ap[3 * k + 2] * R[7];
    A[3 * k + 2] = Ap[3 * k] * R[2] + Ap[3 * k + 1] * R[5] + Ap[3 * k + 2] * R[8];
  }
}

/* b = (x × u, u) */
static void joint_revolute(const double Ap[9], const double xp[3], const double offset0[3],
                           const double axis0[3], const double turn[2], double A[9], double x[3],
                           double b[6])
{
  double e[3], u[3], xi[3], c[3];

  maggi_mul(Ap, offset0, e);
  maggi_mul(Ap, axis0, u);
  xi[0] = xp[0] + e[0];
  xi[1] = xp[1] + e[1];
  xi[2] = xp[2] + e[2];
  rotate(Ap, axis0, turn[0], turn[1], A);
  maggi_cross(xi, u, c);
  x[0] = xi[0];
  x[1] = xi[1];
  x[2] = xi[2];
  b[0] = c[0];
  b[1] = c[1];
  b[2] = c[2];
  b[3] = u[0];
  b[4] = u[1];
  b[5] = u[2];
}

/* b = (u, 0) */
static void joint_prismatic(const double Ap[9], const double xp[3], const double offset0[3],
                            const double axis0[3], double q, double A[9], double x[3], double b[6])
{
  int k;
  double e[3], u[3];

  maggi_mul(Ap, offset0, e);
  maggi_mul(Ap, axis0, u);
  for (k = 0; k < 9; ++k) A[k] = Ap[k];
  for (k = 0; k < 3; ++k) {
    x[k] = xp[k] + e[k] + u[k] * q;
    b[k] = u[k];
    b[k + 3] = 0.0;
  }
}

static void joint_fixed(const double Ap[9], const double xp[3], const double offset0[3],
                        double A[9], double x[3], double b[6])
{
  int k;
  double e[3];

  maggi_mul(Ap, offset0, e);
  for (k = 0; k < 9; ++k) A[k] = Ap[k];
  for (k = 0; k < 3; ++k) {
    x[k] = xp[k] + e[k];
    b[k] = 0.0;
    b[k + 3] = 0.0;
  }
}

/* joints that do not turn leave their row of turn alone */
void maggi_positions(const maggi_topo *t, const double offset0[t->nbody][3],
                     const double axis0[t->nbody][3], const double q[t->nq],
                     double turn[t->nbody][2], double A[t->nbody + 1][9], double x[t->nbody + 1][3],
                     double b[t->nbody][6])
{
  int i, k, up;
  double angle;

  for (k = 0; k < 9; ++k) A[t->nbody][k] = k % 4 == 0 ? 1.0 : 0.0;
  for (k = 0; k < 3; ++k) x[t->nbody][k] = 0.0;
  for (i = 0; i < t->nbase; ++i)
    for (k = 0; k < 3; ++k) x[t->nbody][k] -= axis0[t->base[i]][k] * q[t->qid[t->base[i]]];

  for (i = t->nbody - 1; i >= 0; --i) {
    up = t->parent[i];
    if (t->joint[i] == MAGGI_ONE_REVOLUTE) {
      angle = q[t->qid[i]]; /* one call for both */
      turn[i][0] = sin(angle);
      turn[i][1] = cos(angle);
      joint_revolute(A[up], x[up], offset0[i], axis0[i], turn[i], A[i], x[i], b[i]);
    } else if (t->joint[i] == MAGGI_ONE_PRISMATIC) {
      joint_prismatic(A[up], x[up], offset0[i], axis0[i], q[t->qid[i]], A[i], x[i], b[i]);
    } else {
      joint_fixed(A[up], x[up], offset0[i], A[i], x[i], b[i]);
    }
  }
}

static void place(const double A[9], const double x[3], const double point0[3], double r[3])
{
  double e[3];

  maggi_mul(A, point0, e);
  r[0] = x[0] + e[0];
  r[1] = x[1] + e[1];
  r[2] = x[2] + e[2];
}

/* r = x + A point0 */
void maggi_points(const maggi_topo *t, int begin, int end, const double point0[t->npoint][3],
                  const double A[t->nbody + 1][9], const double x[t->nbody + 1][3],
                  double r[t->npoint][3])
{
  int i;

  for (i = begin; i < end; ++i) place(A[t->pointbody[i]], x[t->pointbody[i]], point0[i], r[i]);
}

void maggi_directions(const maggi_topo *t, const double dir0[t->ndir][3],
                      const double A[t->nbody + 1][9], double dir[t->ndir][3])
{
  int i;

  for (i = 0; i < t->ndir; ++i) maggi_mul(A[t->dirbody[i]], dir0[i], dir[i]);
}
