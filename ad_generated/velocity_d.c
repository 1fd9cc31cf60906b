/* Tangent of core/kernel/velocity.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* p begins with gravity */
void maggi_velocities_d(const maggi_topo *t, const double p[restrict t->np],
                        const double pd[restrict t->np], const double b[restrict t->nbody][6],
                        const double bd[restrict t->nbody][6], const double v[restrict t->nq],
                        const double vd[restrict t->nq], double Z[restrict t->nbody + 1][6],
                        double Zd[restrict t->nbody + 1][6], double Z0[restrict t->nbody + 1][6],
                        double Z0d[restrict t->nbody + 1][6])
{
  int i, k2, k3;
  double Z_i0, Z_i0d, Z_i1, Z_i1d, Z_i2, Z_i2d, Z_i3, Z_i3d, Z_i4, Z_i4d, Z_i5, Z_i5d, b_i0, b_i0d,
      b_i1, b_i1d, b_i2, b_i2d, b_i3, b_i3d, b_i4, b_i4d, b_i5, b_i5d, v_i, v_id;

  (void)p;
  (void)Z0;
  Zd[t->nbody][0] = 0.0;
  Zd[t->nbody][3] = 0.0;
  Z0d[t->nbody][0] = -pd[0];
  Z0d[t->nbody][3] = 0.0;
  Zd[t->nbody][1] = 0.0;
  Zd[t->nbody][4] = 0.0;
  Z0d[t->nbody][1] = -pd[1];
  Z0d[t->nbody][4] = 0.0;
  Zd[t->nbody][2] = 0.0;
  Zd[t->nbody][5] = 0.0;
  Z0d[t->nbody][2] = -pd[2];
  Z0d[t->nbody][5] = 0.0;
  for (i = t->nbody - 1; i >= 0; --i) {
    if (t->qid[i] >= 0) {
      Z_i0 = Z[t->parent[i]][0];
      Z_i0d = Zd[t->parent[i]][0];
      b_i0 = b[i][0];
      b_i0d = bd[i][0];
      v_i = v[t->qid[i]];
      v_id = vd[t->qid[i]];
      Zd[i][0] = Z_i0d + (b_i0d * v_i + b_i0 * v_id);
      Z_i1 = Z[t->parent[i]][1];
      Z_i1d = Zd[t->parent[i]][1];
      b_i1 = b[i][1];
      b_i1d = bd[i][1];
      Zd[i][1] = Z_i1d + (b_i1d * v_i + b_i1 * v_id);
      Z_i2 = Z[t->parent[i]][2];
      Z_i2d = Zd[t->parent[i]][2];
      b_i2 = b[i][2];
      b_i2d = bd[i][2];
      Zd[i][2] = Z_i2d + (b_i2d * v_i + b_i2 * v_id);
      Z_i3 = Z[t->parent[i]][3];
      Z_i3d = Zd[t->parent[i]][3];
      b_i3 = b[i][3];
      b_i3d = bd[i][3];
      Zd[i][3] = Z_i3d + (b_i3d * v_i + b_i3 * v_id);
      Z_i4 = Z[t->parent[i]][4];
      Z_i4d = Zd[t->parent[i]][4];
      b_i4 = b[i][4];
      b_i4d = bd[i][4];
      Zd[i][4] = Z_i4d + (b_i4d * v_i + b_i4 * v_id);
      Z_i5 = Z[t->parent[i]][5];
      Z_i5d = Zd[t->parent[i]][5];
      b_i5 = b[i][5];
      b_i5d = bd[i][5];
      Zd[i][5] = Z_i5d + (b_i5d * v_i + b_i5 * v_id);
      Z0d[i][0] = Z0d[t->parent[i]][0] + (v_id * (Z_i4 * b_i2 - Z_i5 * b_i1 + Z_i1 * b_i5 - Z_i2 *
          b_i4) + v_i * (Z_i4d * b_i2 + Z_i4 * b_i2d - (Z_i5d * b_i1 + Z_i5 * b_i1d) + (Z_i1d * b_i5
          + Z_i1 * b_i5d) - (Z_i2d * b_i4 + Z_i2 * b_i4d)));
      Z0d[i][1] = Z0d[t->parent[i]][1] + (v_id * (Z_i5 * b_i0 - Z_i3 * b_i2 + Z_i2 * b_i3 - Z_i0 *
          b_i5) + v_i * (Z_i5d * b_i0 + Z_i5 * b_i0d - (Z_i3d * b_i2 + Z_i3 * b_i2d) + (Z_i2d * b_i3
          + Z_i2 * b_i3d) - (Z_i0d * b_i5 + Z_i0 * b_i5d)));
      Z0d[i][2] = Z0d[t->parent[i]][2] + (v_id * (Z_i3 * b_i1 - Z_i4 * b_i0 + Z_i0 * b_i4 - Z_i1 *
          b_i3) + v_i * (Z_i3d * b_i1 + Z_i3 * b_i1d - (Z_i4d * b_i0 + Z_i4 * b_i0d) + (Z_i0d * b_i4
          + Z_i0 * b_i4d) - (Z_i1d * b_i3 + Z_i1 * b_i3d)));
      Z0d[i][3] = Z0d[t->parent[i]][3] + (v_id * (Z_i4 * b_i5 - Z_i5 * b_i4) + v_i * (Z_i4d * b_i5 +
          Z_i4 * b_i5d - (Z_i5d * b_i4 + Z_i5 * b_i4d)));
      Z0d[i][4] = Z0d[t->parent[i]][4] + (v_id * (Z_i5 * b_i3 - Z_i3 * b_i5) + v_i * (Z_i5d * b_i3 +
          Z_i5 * b_i3d - (Z_i3d * b_i5 + Z_i3 * b_i5d)));
      Z0d[i][5] = Z0d[t->parent[i]][5] + (v_id * (Z_i3 * b_i4 - Z_i4 * b_i3) + v_i * (Z_i3d * b_i4 +
          Z_i3 * b_i4d - (Z_i4d * b_i3 + Z_i4 * b_i3d)));
    } else {
      for (k2 = 0; k2 < 6; ++k2) {
        Zd[i][k2] = Zd[t->parent[i]][k2];
      }
      for (k3 = 0; k3 < 6; ++k3) {
        Z0d[i][k3] = Z0d[t->parent[i]][k3];
      }
    }
  }
}

/* v = s + w × r */
void maggi_point_velocities_d(const maggi_topo *t, int begin, int end,
                              const double r[restrict t->npoint][3],
                              const double rd[restrict t->npoint][3],
                              const double Z[restrict t->nbody + 1][6],
                              const double Zd[restrict t->nbody + 1][6],
                              double rv[restrict t->npoint][3], double rvd[restrict t->npoint][3])
{
  int i;
  double Z_i3, Z_i3d, Z_i4, Z_i4d, Z_i5, Z_i5d, r_i0, r_i0d, r_i1, r_i1d, r_i2, r_i2d;

  (void)rv;
  for (i = begin; i < end; ++i) {
    Z_i4 = Z[t->pointbody[i]][4];
    Z_i4d = Zd[t->pointbody[i]][4];
    r_i2 = r[i][2];
    r_i2d = rd[i][2];
    Z_i5 = Z[t->pointbody[i]][5];
    Z_i5d = Zd[t->pointbody[i]][5];
    r_i1 = r[i][1];
    r_i1d = rd[i][1];
    rvd[i][0] = Zd[t->pointbody[i]][0] + (Z_i4d * r_i2 + Z_i4 * r_i2d) - (Z_i5d * r_i1 + Z_i5 *
        r_i1d);
    r_i0 = r[i][0];
    r_i0d = rd[i][0];
    Z_i3 = Z[t->pointbody[i]][3];
    Z_i3d = Zd[t->pointbody[i]][3];
    rvd[i][1] = Zd[t->pointbody[i]][1] + (Z_i5d * r_i0 + Z_i5 * r_i0d) - (Z_i3d * r_i2 + Z_i3 *
        r_i2d);
    rvd[i][2] = Zd[t->pointbody[i]][2] + (Z_i3d * r_i1 + Z_i3 * r_i1d) - (Z_i4d * r_i0 + Z_i4 *
        r_i0d);
  }
}

/* Za_i = Z0_i + W_i,  W_i = W_p + b_i a_i */
void maggi_accelerations_d(const maggi_topo *t, const double b[restrict t->nbody][6],
                           const double bd[restrict t->nbody][6],
                           const double Z0[restrict t->nbody + 1][6],
                           const double Z0d[restrict t->nbody + 1][6],
                           const double a[restrict t->nq], const double ad[restrict t->nq],
                           double W[restrict t->nbody + 1][6], double Wd[restrict t->nbody + 1][6],
                           double Za[restrict t->nbody + 1][6],
                           double Zad[restrict t->nbody + 1][6])
{
  int i, k, k2, k3, k4;

  (void)Z0;
  (void)W;
  (void)Za;
  for (k = 0; k < 6; ++k) {
    Wd[t->nbody][k] = 0.0;
    Zad[t->nbody][k] = Z0d[t->nbody][k];
  }
  for (i = t->nbody - 1; i >= 0; --i) {
    if (t->qid[i] >= 0) {
      for (k2 = 0; k2 < 6; ++k2) {
        Wd[i][k2] = Wd[t->parent[i]][k2] + (bd[i][k2] * a[t->qid[i]] + b[i][k2] * ad[t->qid[i]]);
      }
    } else {
      for (k3 = 0; k3 < 6; ++k3) {
        Wd[i][k3] = Wd[t->parent[i]][k3];
      }
    }
    for (k4 = 0; k4 < 6; ++k4) {
      Zad[i][k4] = Z0d[i][k4] + Wd[i][k4];
    }
  }
}

/* a = s' + w' × r + w × v; less gravity when Za begins with it */
void maggi_point_accelerations_d(const maggi_topo *t, int begin, int end,
                                 const double r[restrict t->npoint][3],
                                 const double rd[restrict t->npoint][3],
                                 const double rv[restrict t->npoint][3],
                                 const double rvd[restrict t->npoint][3],
                                 const double Z[restrict t->nbody + 1][6],
                                 const double Zd[restrict t->nbody + 1][6],
                                 const double Za[restrict t->nbody + 1][6],
                                 const double Zad[restrict t->nbody + 1][6],
                                 double ra[restrict t->npoint][3],
                                 double rad[restrict t->npoint][3])
{
  int i;
  double Z_i3, Z_i3d, Z_i4, Z_i4d, Z_i5, Z_i5d, Za_i3, Za_i3d, Za_i4, Za_i4d, Za_i5, Za_i5d, c0d,
      c1d, c2d, r_i0, r_i0d, r_i1, r_i1d, r_i2, r_i2d, rv_i0, rv_i0d, rv_i1, rv_i1d, rv_i2, rv_i2d;

  (void)ra;
  for (i = begin; i < end; ++i) {
    Za_i4 = Za[t->pointbody[i]][4];
    Za_i4d = Zad[t->pointbody[i]][4];
    r_i2 = r[i][2];
    r_i2d = rd[i][2];
    Za_i5 = Za[t->pointbody[i]][5];
    Za_i5d = Zad[t->pointbody[i]][5];
    r_i1 = r[i][1];
    r_i1d = rd[i][1];
    c0d = Zad[t->pointbody[i]][0] + (Za_i4d * r_i2 + Za_i4 * r_i2d) - (Za_i5d * r_i1 + Za_i5 *
        r_i1d);
    r_i0 = r[i][0];
    r_i0d = rd[i][0];
    Za_i3 = Za[t->pointbody[i]][3];
    Za_i3d = Zad[t->pointbody[i]][3];
    c1d = Zad[t->pointbody[i]][1] + (Za_i5d * r_i0 + Za_i5 * r_i0d) - (Za_i3d * r_i2 + Za_i3 *
        r_i2d);
    c2d = Zad[t->pointbody[i]][2] + (Za_i3d * r_i1 + Za_i3 * r_i1d) - (Za_i4d * r_i0 + Za_i4 *
        r_i0d);
    Z_i4 = Z[t->pointbody[i]][4];
    Z_i4d = Zd[t->pointbody[i]][4];
    rv_i2 = rv[i][2];
    rv_i2d = rvd[i][2];
    Z_i5 = Z[t->pointbody[i]][5];
    Z_i5d = Zd[t->pointbody[i]][5];
    rv_i1 = rv[i][1];
    rv_i1d = rvd[i][1];
    rad[i][0] = c0d + (Z_i4d * rv_i2 + Z_i4 * rv_i2d) - (Z_i5d * rv_i1 + Z_i5 * rv_i1d);
    rv_i0 = rv[i][0];
    rv_i0d = rvd[i][0];
    Z_i3 = Z[t->pointbody[i]][3];
    Z_i3d = Zd[t->pointbody[i]][3];
    rad[i][1] = c1d + (Z_i5d * rv_i0 + Z_i5 * rv_i0d) - (Z_i3d * rv_i2 + Z_i3 * rv_i2d);
    rad[i][2] = c2d + (Z_i3d * rv_i1 + Z_i3 * rv_i1d) - (Z_i4d * rv_i0 + Z_i4 * rv_i0d);
  }
}
