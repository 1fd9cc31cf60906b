/* Velocities and accelerations from the root to the leaves.  FORMULATION 2, [1] 2.13-2.20.
 *
 *   Z_i  = Z_p + b_i v_i
 *   Z'_i = Z'_p + b_i v'_i + d_i,   d_i = b'_i v_i,   b'_i = (w_p × b_lin + s_p × b_ang, w_p × b_ang)
 * Z0 is Z' with all v' = 0; the ground accelerates with minus gravity.
 */
#include "kernel.h"

static void joint_rate(const double Zp[6], const double Z0p[6], const double b[6], double v,
                       double Z[6], double Z0[6])
{
  Z[0] = Zp[0] + b[0] * v;
  Z[1] = Zp[1] + b[1] * v;
  Z[2] = Zp[2] + b[2] * v;
  Z[3] = Zp[3] + b[3] * v;
  Z[4] = Zp[4] + b[4] * v;
  Z[5] = Zp[5] + b[5] * v;
  Z0[0] = Z0p[0] + v * (Zp[4] * b[2] - Zp[5] * b[1] + Zp[1] * b[5] - Zp[2] * b[4]);
  Z0[1] = Z0p[1] + v * (Zp[5] * b[0] - Zp[3] * b[2] + Zp[2] * b[3] - Zp[0] * b[5]);
  Z0[2] = Z0p[2] + v * (Zp[3] * b[1] - Zp[4] * b[0] + Zp[0] * b[4] - Zp[1] * b[3]);
  Z0[3] = Z0p[3] + v * (Zp[4] * b[5] - Zp[5] * b[4]);
  Z0[4] = Z0p[4] + v * (Zp[5] * b[3] - Zp[3] * b[5]);
  Z0[5] = Z0p[5] + v * (Zp[3] * b[4] - Zp[4] * b[3]);
}

static void copy6(const double a[6], double c[6])
{
  int k;

  for (k = 0; k < 6; ++k) c[k] = a[k];
}

/* p begins with gravity */
void maggi_velocities(const maggi_topo *t, const double p[t->np], const double b[t->nbody][6],
                      const double v[t->nq], double Z[t->nbody + 1][6], double Z0[t->nbody + 1][6])
{
  int i, k;

  for (k = 0; k < 3; ++k) {
    Z[t->nbody][k] = 0.0;
    Z[t->nbody][k + 3] = 0.0;
    Z0[t->nbody][k] = -p[k];
    Z0[t->nbody][k + 3] = 0.0;
  }
  for (i = t->nbody - 1; i >= 0; --i) {
    if (t->qid[i] >= 0) {
      joint_rate(Z[t->parent[i]], Z0[t->parent[i]], b[i], v[t->qid[i]], Z[i], Z0[i]);
    } else {
      copy6(Z[t->parent[i]], Z[i]);
      copy6(Z0[t->parent[i]], Z0[i]);
    }
  }
}

static void axpy6(const double a[6], const double b[6], double s, double c[6])
{
  int k;

  for (k = 0; k < 6; ++k) c[k] = a[k] + b[k] * s;
}

/* Za_i = Z0_i + W_i,  W_i = W_p + b_i a_i */
void maggi_accelerations(const maggi_topo *t, const double b[t->nbody][6],
                         const double Z0[t->nbody + 1][6], const double a[t->nq],
                         double W[t->nbody + 1][6], double Za[t->nbody + 1][6])
{
  int i, k;

  for (k = 0; k < 6; ++k) {
    W[t->nbody][k] = 0.0;
    Za[t->nbody][k] = Z0[t->nbody][k];
  }
  for (i = t->nbody - 1; i >= 0; --i) {
    if (t->qid[i] >= 0)
      axpy6(W[t->parent[i]], b[i], a[t->qid[i]], W[i]);
    else
      copy6(W[t->parent[i]], W[i]);
    axpy6(Z0[i], W[i], 1.0, Za[i]);
  }
}

/* v = s + w × r */
void maggi_point_velocities(const maggi_topo *t, int begin, int end, const double r[t->npoint][3],
                            const double Z[t->nbody + 1][6], double rv[t->npoint][3])
{
  int i;

  for (i = begin; i < end; ++i) maggi_point_rate(Z[t->pointbody[i]], r[i], rv[i]);
}

static void point_acceleration(const double Z[6], const double Za[6], const double r[3],
                               const double rv[3], double a[3])
{
  double c[3];

  maggi_point_rate(Za, r, c);
  a[0] = c[0] + Z[4] * rv[2] - Z[5] * rv[1];
  a[1] = c[1] + Z[5] * rv[0] - Z[3] * rv[2];
  a[2] = c[2] + Z[3] * rv[1] - Z[4] * rv[0];
}

/* a = s' + w' × r + w × v; less gravity when Za begins with it */
void maggi_point_accelerations(const maggi_topo *t, int begin, int end,
                               const double r[t->npoint][3], const double rv[t->npoint][3],
                               const double Z[t->nbody + 1][6], const double Za[t->nbody + 1][6],
                               double ra[t->npoint][3])
{
  int i;

  for (i = begin; i < end; ++i)
    point_acceleration(Z[t->pointbody[i]], Za[t->pointbody[i]], r[i], rv[i], ra[i]);
}
