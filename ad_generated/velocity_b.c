/* Adjoint of core/kernel/velocity.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* p begins with gravity */
void maggi_velocities_b(const maggi_topo *t, const double p[restrict t->np],
                        double pb[restrict t->np], const double b[restrict t->nbody][6],
                        double bb[restrict t->nbody][6], const double v[restrict t->nq],
                        double vb[restrict t->nq], double Z[restrict t->nbody + 1][6],
                        double Zb[restrict t->nbody + 1][6], double Z0[restrict t->nbody + 1][6],
                        double Z0b[restrict t->nbody + 1][6])
{
  int i, k2, k3;
  double Z_i0, Z_i0b, Z_i1, Z_i1b, Z_i2, Z_i2b, Z_i3, Z_i3b, Z_i4, Z_i4b, Z_i5, Z_i5b, b_i0, b_i0b,
      b_i1, b_i1b, b_i2, b_i2b, b_i3, b_i3b, b_i4, b_i4b, b_i5, b_i5b, tb10, tb11, tb12, tb13, tb14,
      tb15, tb16, tb17, tb18, tb19, tb2, tb3, tb4, tb5, tb6, tb7, tb8, tb9, v_i, v_ib;

  (void)p;
  (void)Z0;
  for (i = 0; i < t->nbody; ++i) {
    if (t->qid[i] >= 0) {
      Z_i0 = Z[t->parent[i]][0];
      b_i0 = b[i][0];
      v_i = v[t->qid[i]];
      Z_i1 = Z[t->parent[i]][1];
      b_i1 = b[i][1];
      Z_i2 = Z[t->parent[i]][2];
      b_i2 = b[i][2];
      Z_i3 = Z[t->parent[i]][3];
      b_i3 = b[i][3];
      Z_i4 = Z[t->parent[i]][4];
      b_i4 = b[i][4];
      Z_i5 = Z[t->parent[i]][5];
      b_i5 = b[i][5];
      tb18 = Z0b[i][5];
      Z0b[i][5] = 0.0;
      Z0b[t->parent[i]][5] += tb18;
      v_ib = tb18 * (Z_i3 * b_i4 - Z_i4 * b_i3);
      tb19 = tb18 * v_i;
      Z_i3b = tb19 * b_i4;
      b_i4b = tb19 * Z_i3;
      Z_i4b = -(tb19 * b_i3);
      b_i3b = -(tb19 * Z_i4);
      tb16 = Z0b[i][4];
      Z0b[i][4] = 0.0;
      Z0b[t->parent[i]][4] += tb16;
      v_ib += tb16 * (Z_i5 * b_i3 - Z_i3 * b_i5);
      tb17 = tb16 * v_i;
      Z_i5b = tb17 * b_i3;
      b_i3b += tb17 * Z_i5;
      Z_i3b -= tb17 * b_i5;
      b_i5b = -(tb17 * Z_i3);
      tb14 = Z0b[i][3];
      Z0b[i][3] = 0.0;
      Z0b[t->parent[i]][3] += tb14;
      v_ib += tb14 * (Z_i4 * b_i5 - Z_i5 * b_i4);
      tb15 = tb14 * v_i;
      Z_i4b += tb15 * b_i5;
      b_i5b += tb15 * Z_i4;
      Z_i5b -= tb15 * b_i4;
      b_i4b -= tb15 * Z_i5;
      tb12 = Z0b[i][2];
      Z0b[i][2] = 0.0;
      Z0b[t->parent[i]][2] += tb12;
      v_ib += tb12 * (Z_i3 * b_i1 - Z_i4 * b_i0 + Z_i0 * b_i4 - Z_i1 * b_i3);
      tb13 = tb12 * v_i;
      Z_i3b += tb13 * b_i1;
      b_i1b = tb13 * Z_i3;
      Z_i4b -= tb13 * b_i0;
      b_i0b = -(tb13 * Z_i4);
      Z_i0b = tb13 * b_i4;
      b_i4b += tb13 * Z_i0;
      Z_i1b = -(tb13 * b_i3);
      b_i3b -= tb13 * Z_i1;
      tb10 = Z0b[i][1];
      Z0b[i][1] = 0.0;
      Z0b[t->parent[i]][1] += tb10;
      v_ib += tb10 * (Z_i5 * b_i0 - Z_i3 * b_i2 + Z_i2 * b_i3 - Z_i0 * b_i5);
      tb11 = tb10 * v_i;
      Z_i5b += tb11 * b_i0;
      b_i0b += tb11 * Z_i5;
      Z_i3b -= tb11 * b_i2;
      b_i2b = -(tb11 * Z_i3);
      Z_i2b = tb11 * b_i3;
      b_i3b += tb11 * Z_i2;
      Z_i0b -= tb11 * b_i5;
      b_i5b -= tb11 * Z_i0;
      tb8 = Z0b[i][0];
      Z0b[i][0] = 0.0;
      Z0b[t->parent[i]][0] += tb8;
      v_ib += tb8 * (Z_i4 * b_i2 - Z_i5 * b_i1 + Z_i1 * b_i5 - Z_i2 * b_i4);
      tb9 = tb8 * v_i;
      Z_i4b += tb9 * b_i2;
      b_i2b += tb9 * Z_i4;
      Z_i5b -= tb9 * b_i1;
      b_i1b -= tb9 * Z_i5;
      Z_i1b += tb9 * b_i5;
      b_i5b += tb9 * Z_i1;
      Z_i2b -= tb9 * b_i4;
      b_i4b -= tb9 * Z_i2;
      tb7 = Zb[i][5];
      Zb[i][5] = 0.0;
      Z_i5b += tb7;
      b_i5b += tb7 * v_i;
      v_ib += tb7 * b_i5;
      bb[i][5] += b_i5b;
      Zb[t->parent[i]][5] += Z_i5b;
      tb6 = Zb[i][4];
      Zb[i][4] = 0.0;
      Z_i4b += tb6;
      b_i4b += tb6 * v_i;
      v_ib += tb6 * b_i4;
      bb[i][4] += b_i4b;
      Zb[t->parent[i]][4] += Z_i4b;
      tb5 = Zb[i][3];
      Zb[i][3] = 0.0;
      Z_i3b += tb5;
      b_i3b += tb5 * v_i;
      v_ib += tb5 * b_i3;
      bb[i][3] += b_i3b;
      Zb[t->parent[i]][3] += Z_i3b;
      tb4 = Zb[i][2];
      Zb[i][2] = 0.0;
      Z_i2b += tb4;
      b_i2b += tb4 * v_i;
      v_ib += tb4 * b_i2;
      bb[i][2] += b_i2b;
      Zb[t->parent[i]][2] += Z_i2b;
      tb3 = Zb[i][1];
      Zb[i][1] = 0.0;
      Z_i1b += tb3;
      b_i1b += tb3 * v_i;
      v_ib += tb3 * b_i1;
      bb[i][1] += b_i1b;
      Zb[t->parent[i]][1] += Z_i1b;
      tb2 = Zb[i][0];
      Zb[i][0] = 0.0;
      Z_i0b += tb2;
      b_i0b += tb2 * v_i;
      v_ib += tb2 * b_i0;
      vb[t->qid[i]] += v_ib;
      bb[i][0] += b_i0b;
      Zb[t->parent[i]][0] += Z_i0b;
    } else {
      for (k3 = 5; k3 >= 0; --k3) {
        Z0b[t->parent[i]][k3] += Z0b[i][k3];
        Z0b[i][k3] = 0.0;
      }
      for (k2 = 5; k2 >= 0; --k2) {
        Zb[t->parent[i]][k2] += Zb[i][k2];
        Zb[i][k2] = 0.0;
      }
    }
  }
  Z0b[t->nbody][5] = 0.0;
  pb[2] -= Z0b[t->nbody][2];
  Z0b[t->nbody][2] = 0.0;
  Zb[t->nbody][5] = 0.0;
  Zb[t->nbody][2] = 0.0;
  Z0b[t->nbody][4] = 0.0;
  pb[1] -= Z0b[t->nbody][1];
  Z0b[t->nbody][1] = 0.0;
  Zb[t->nbody][4] = 0.0;
  Zb[t->nbody][1] = 0.0;
  Z0b[t->nbody][3] = 0.0;
  pb[0] -= Z0b[t->nbody][0];
  Z0b[t->nbody][0] = 0.0;
  Zb[t->nbody][3] = 0.0;
  Zb[t->nbody][0] = 0.0;
}

/* v = s + w × r */
void maggi_point_velocities_b(const maggi_topo *t, int begin, int end,
                              const double r[restrict t->npoint][3],
                              double rb[restrict t->npoint][3],
                              const double Z[restrict t->nbody + 1][6],
                              double Zb[restrict t->nbody + 1][6], double rv[restrict t->npoint][3],
                              double rvb[restrict t->npoint][3])
{
  int i;
  double Z_i3, Z_i3b, Z_i4, Z_i4b, Z_i5, Z_i5b, r_i0, r_i0b, r_i1, r_i1b, r_i2, r_i2b, tb2, tb3,
      tb4;

  (void)rv;
  for (i = end - 1; i >= begin; --i) {
    Z_i4 = Z[t->pointbody[i]][4];
    r_i2 = r[i][2];
    Z_i5 = Z[t->pointbody[i]][5];
    r_i1 = r[i][1];
    r_i0 = r[i][0];
    Z_i3 = Z[t->pointbody[i]][3];
    tb4 = rvb[i][2];
    rvb[i][2] = 0.0;
    Zb[t->pointbody[i]][2] += tb4;
    Z_i3b = tb4 * r_i1;
    r_i1b = tb4 * Z_i3;
    Z_i4b = -(tb4 * r_i0);
    r_i0b = -(tb4 * Z_i4);
    tb3 = rvb[i][1];
    rvb[i][1] = 0.0;
    Zb[t->pointbody[i]][1] += tb3;
    Z_i5b = tb3 * r_i0;
    r_i0b += tb3 * Z_i5;
    Z_i3b -= tb3 * r_i2;
    r_i2b = -(tb3 * Z_i3);
    Zb[t->pointbody[i]][3] += Z_i3b;
    rb[i][0] += r_i0b;
    tb2 = rvb[i][0];
    rvb[i][0] = 0.0;
    Zb[t->pointbody[i]][0] += tb2;
    Z_i4b += tb2 * r_i2;
    r_i2b += tb2 * Z_i4;
    Z_i5b -= tb2 * r_i1;
    r_i1b -= tb2 * Z_i5;
    rb[i][1] += r_i1b;
    Zb[t->pointbody[i]][5] += Z_i5b;
    rb[i][2] += r_i2b;
    Zb[t->pointbody[i]][4] += Z_i4b;
  }
}

/* Za_i = Z0_i + W_i,  W_i = W_p + b_i a_i */
void maggi_accelerations_b(const maggi_topo *t, const double b[restrict t->nbody][6],
                           double bb[restrict t->nbody][6],
                           const double Z0[restrict t->nbody + 1][6],
                           double Z0b[restrict t->nbody + 1][6], const double a[restrict t->nq],
                           double ab[restrict t->nq], double W[restrict t->nbody + 1][6],
                           double Wb[restrict t->nbody + 1][6], double Za[restrict t->nbody + 1][6],
                           double Zab[restrict t->nbody + 1][6])
{
  int i, k, k2, k3, k4;
  double tb2, tb3;

  (void)Z0;
  (void)W;
  (void)Za;
  for (i = 0; i < t->nbody; ++i) {
    for (k4 = 5; k4 >= 0; --k4) {
      tb3 = Zab[i][k4];
      Zab[i][k4] = 0.0;
      Z0b[i][k4] += tb3;
      Wb[i][k4] += tb3;
    }
    if (t->qid[i] >= 0) {
      for (k2 = 5; k2 >= 0; --k2) {
        tb2 = Wb[i][k2];
        Wb[i][k2] = 0.0;
        Wb[t->parent[i]][k2] += tb2;
        bb[i][k2] += tb2 * a[t->qid[i]];
        ab[t->qid[i]] += tb2 * b[i][k2];
      }
    } else {
      for (k3 = 5; k3 >= 0; --k3) {
        Wb[t->parent[i]][k3] += Wb[i][k3];
        Wb[i][k3] = 0.0;
      }
    }
  }
  for (k = 5; k >= 0; --k) {
    Z0b[t->nbody][k] += Zab[t->nbody][k];
    Zab[t->nbody][k] = 0.0;
    Wb[t->nbody][k] = 0.0;
  }
}

/* a = s' + w' × r + w × v; less gravity when Za begins with it */
void maggi_point_accelerations_b(const maggi_topo *t, int begin, int end,
                                 const double r[restrict t->npoint][3],
                                 double rb[restrict t->npoint][3],
                                 const double rv[restrict t->npoint][3],
                                 double rvb[restrict t->npoint][3],
                                 const double Z[restrict t->nbody + 1][6],
                                 double Zb[restrict t->nbody + 1][6],
                                 const double Za[restrict t->nbody + 1][6],
                                 double Zab[restrict t->nbody + 1][6],
                                 double ra[restrict t->npoint][3],
                                 double rab[restrict t->npoint][3])
{
  int i;
  double Z_i3, Z_i3b, Z_i4, Z_i4b, Z_i5, Z_i5b, Za_i3, Za_i3b, Za_i4, Za_i4b, Za_i5, Za_i5b, c0b,
      c1b, c2b, r_i0, r_i0b, r_i1, r_i1b, r_i2, r_i2b, rv_i0, rv_i0b, rv_i1, rv_i1b, rv_i2, rv_i2b,
      tb2, tb3, tb4;

  (void)ra;
  for (i = end - 1; i >= begin; --i) {
    Za_i4 = Za[t->pointbody[i]][4];
    r_i2 = r[i][2];
    Za_i5 = Za[t->pointbody[i]][5];
    r_i1 = r[i][1];
    r_i0 = r[i][0];
    Za_i3 = Za[t->pointbody[i]][3];
    Z_i4 = Z[t->pointbody[i]][4];
    rv_i2 = rv[i][2];
    Z_i5 = Z[t->pointbody[i]][5];
    rv_i1 = rv[i][1];
    rv_i0 = rv[i][0];
    Z_i3 = Z[t->pointbody[i]][3];
    tb4 = rab[i][2];
    rab[i][2] = 0.0;
    c2b = tb4;
    Z_i3b = tb4 * rv_i1;
    rv_i1b = tb4 * Z_i3;
    Z_i4b = -(tb4 * rv_i0);
    rv_i0b = -(tb4 * Z_i4);
    tb3 = rab[i][1];
    rab[i][1] = 0.0;
    c1b = tb3;
    Z_i5b = tb3 * rv_i0;
    rv_i0b += tb3 * Z_i5;
    Z_i3b -= tb3 * rv_i2;
    rv_i2b = -(tb3 * Z_i3);
    Zb[t->pointbody[i]][3] += Z_i3b;
    rvb[i][0] += rv_i0b;
    tb2 = rab[i][0];
    rab[i][0] = 0.0;
    c0b = tb2;
    Z_i4b += tb2 * rv_i2;
    rv_i2b += tb2 * Z_i4;
    Z_i5b -= tb2 * rv_i1;
    rv_i1b -= tb2 * Z_i5;
    rvb[i][1] += rv_i1b;
    Zb[t->pointbody[i]][5] += Z_i5b;
    rvb[i][2] += rv_i2b;
    Zb[t->pointbody[i]][4] += Z_i4b;
    Zab[t->pointbody[i]][2] += c2b;
    Za_i3b = c2b * r_i1;
    r_i1b = c2b * Za_i3;
    Za_i4b = -(c2b * r_i0);
    r_i0b = -(c2b * Za_i4);
    Zab[t->pointbody[i]][1] += c1b;
    Za_i5b = c1b * r_i0;
    r_i0b += c1b * Za_i5;
    Za_i3b -= c1b * r_i2;
    r_i2b = -(c1b * Za_i3);
    Zab[t->pointbody[i]][3] += Za_i3b;
    rb[i][0] += r_i0b;
    Zab[t->pointbody[i]][0] += c0b;
    Za_i4b += c0b * r_i2;
    r_i2b += c0b * Za_i4;
    Za_i5b -= c0b * r_i1;
    r_i1b -= c0b * Za_i5;
    rb[i][1] += r_i1b;
    Zab[t->pointbody[i]][5] += Za_i5b;
    rb[i][2] += r_i2b;
    Zab[t->pointbody[i]][4] += Za_i4b;
  }
}
