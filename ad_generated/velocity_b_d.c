/* Tangent of the adjoint of core/kernel/velocity.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* p begins with gravity */
void maggi_velocities_b_d(const maggi_topo *t, const double p[restrict t->np],
                          const double pd[restrict t->np], double pb[restrict t->np],
                          double pbd[restrict t->np], const double b[restrict t->nbody][6],
                          const double bd[restrict t->nbody][6], double bb[restrict t->nbody][6],
                          double bbd[restrict t->nbody][6], const double v[restrict t->nq],
                          const double vd[restrict t->nq], double vb[restrict t->nq],
                          double vbd[restrict t->nq], double Z[restrict t->nbody + 1][6],
                          double Zd[restrict t->nbody + 1][6], double Zb[restrict t->nbody + 1][6],
                          double Zbd[restrict t->nbody + 1][6], double Z0[restrict t->nbody + 1][6],
                          double Z0d[restrict t->nbody + 1][6],
                          double Z0b[restrict t->nbody + 1][6],
                          double Z0bd[restrict t->nbody + 1][6])
{
  int i, k2, k3;
  double Z_i0, Z_i0b, Z_i0bd, Z_i0d, Z_i1, Z_i1b, Z_i1bd, Z_i1d, Z_i2, Z_i2b, Z_i2bd, Z_i2d, Z_i3,
      Z_i3b, Z_i3bd, Z_i3d, Z_i4, Z_i4b, Z_i4bd, Z_i4d, Z_i5, Z_i5b, Z_i5bd, Z_i5d, b_i0, b_i0b,
      b_i0bd, b_i0d, b_i1, b_i1b, b_i1bd, b_i1d, b_i2, b_i2b, b_i2bd, b_i2d, b_i3, b_i3b, b_i3bd,
      b_i3d, b_i4, b_i4b, b_i4bd, b_i4d, b_i5, b_i5b, b_i5bd, b_i5d, tb10, tb10d, tb11, tb11d, tb12,
      tb12d, tb13, tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d, tb17, tb17d, tb18, tb18d, tb19,
      tb19d, tb2, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d,
      v_i, v_ib, v_ibd, v_id;

  (void)p;
  (void)pd;
  (void)Z0;
  (void)Z0d;
  for (i = 0; i < t->nbody; ++i) {
    if (t->qid[i] >= 0) {
      Z_i0 = Z[t->parent[i]][0];
      Z_i0d = Zd[t->parent[i]][0];
      b_i0 = b[i][0];
      b_i0d = bd[i][0];
      v_i = v[t->qid[i]];
      v_id = vd[t->qid[i]];
      Z_i1 = Z[t->parent[i]][1];
      Z_i1d = Zd[t->parent[i]][1];
      b_i1 = b[i][1];
      b_i1d = bd[i][1];
      Z_i2 = Z[t->parent[i]][2];
      Z_i2d = Zd[t->parent[i]][2];
      b_i2 = b[i][2];
      b_i2d = bd[i][2];
      Z_i3 = Z[t->parent[i]][3];
      Z_i3d = Zd[t->parent[i]][3];
      b_i3 = b[i][3];
      b_i3d = bd[i][3];
      Z_i4 = Z[t->parent[i]][4];
      Z_i4d = Zd[t->parent[i]][4];
      b_i4 = b[i][4];
      b_i4d = bd[i][4];
      Z_i5 = Z[t->parent[i]][5];
      Z_i5d = Zd[t->parent[i]][5];
      b_i5 = b[i][5];
      b_i5d = bd[i][5];
      tb18 = Z0b[i][5];
      tb18d = Z0bd[i][5];
      Z0b[i][5] = 0.0;
      Z0bd[i][5] = 0.0;
      Z0b[t->parent[i]][5] += tb18;
      Z0bd[t->parent[i]][5] += tb18d;
      v_ib = tb18 * (Z_i3 * b_i4 - Z_i4 * b_i3);
      v_ibd = tb18d * (Z_i3 * b_i4 - Z_i4 * b_i3) + tb18 * (Z_i3d * b_i4 + Z_i3 * b_i4d - (Z_i4d *
          b_i3 + Z_i4 * b_i3d));
      tb19 = tb18 * v_i;
      tb19d = tb18d * v_i + tb18 * v_id;
      Z_i3b = tb19 * b_i4;
      Z_i3bd = tb19d * b_i4 + tb19 * b_i4d;
      b_i4b = tb19 * Z_i3;
      b_i4bd = tb19d * Z_i3 + tb19 * Z_i3d;
      Z_i4b = -(tb19 * b_i3);
      Z_i4bd = -(tb19d * b_i3 + tb19 * b_i3d);
      b_i3b = -(tb19 * Z_i4);
      b_i3bd = -(tb19d * Z_i4 + tb19 * Z_i4d);
      tb16 = Z0b[i][4];
      tb16d = Z0bd[i][4];
      Z0b[i][4] = 0.0;
      Z0bd[i][4] = 0.0;
      Z0b[t->parent[i]][4] += tb16;
      Z0bd[t->parent[i]][4] += tb16d;
      v_ib += tb16 * (Z_i5 * b_i3 - Z_i3 * b_i5);
      v_ibd += tb16d * (Z_i5 * b_i3 - Z_i3 * b_i5) + tb16 * (Z_i5d * b_i3 + Z_i5 * b_i3d - (Z_i3d *
          b_i5 + Z_i3 * b_i5d));
      tb17 = tb16 * v_i;
      tb17d = tb16d * v_i + tb16 * v_id;
      Z_i5b = tb17 * b_i3;
      Z_i5bd = tb17d * b_i3 + tb17 * b_i3d;
      b_i3b += tb17 * Z_i5;
      b_i3bd += tb17d * Z_i5 + tb17 * Z_i5d;
      Z_i3b -= tb17 * b_i5;
      Z_i3bd -= tb17d * b_i5 + tb17 * b_i5d;
      b_i5b = -(tb17 * Z_i3);
      b_i5bd = -(tb17d * Z_i3 + tb17 * Z_i3d);
      tb14 = Z0b[i][3];
      tb14d = Z0bd[i][3];
      Z0b[i][3] = 0.0;
      Z0bd[i][3] = 0.0;
      Z0b[t->parent[i]][3] += tb14;
      Z0bd[t->parent[i]][3] += tb14d;
      v_ib += tb14 * (Z_i4 * b_i5 - Z_i5 * b_i4);
      v_ibd += tb14d * (Z_i4 * b_i5 - Z_i5 * b_i4) + tb14 * (Z_i4d * b_i5 + Z_i4 * b_i5d - (Z_i5d *
          b_i4 + Z_i5 * b_i4d));
      tb15 = tb14 * v_i;
      tb15d = tb14d * v_i + tb14 * v_id;
      Z_i4b += tb15 * b_i5;
      Z_i4bd += tb15d * b_i5 + tb15 * b_i5d;
      b_i5b += tb15 * Z_i4;
      b_i5bd += tb15d * Z_i4 + tb15 * Z_i4d;
      Z_i5b -= tb15 * b_i4;
      Z_i5bd -= tb15d * b_i4 + tb15 * b_i4d;
      b_i4b -= tb15 * Z_i5;
      b_i4bd -= tb15d * Z_i5 + tb15 * Z_i5d;
      tb12 = Z0b[i][2];
      tb12d = Z0bd[i][2];
      Z0b[i][2] = 0.0;
      Z0bd[i][2] = 0.0;
      Z0b[t->parent[i]][2] += tb12;
      Z0bd[t->parent[i]][2] += tb12d;
      v_ib += tb12 * (Z_i3 * b_i1 - Z_i4 * b_i0 + Z_i0 * b_i4 - Z_i1 * b_i3);
      v_ibd += tb12d * (Z_i3 * b_i1 - Z_i4 * b_i0 + Z_i0 * b_i4 - Z_i1 * b_i3) + tb12 * (Z_i3d *
          b_i1 + Z_i3 * b_i1d - (Z_i4d * b_i0 + Z_i4 * b_i0d) + (Z_i0d * b_i4 + Z_i0 * b_i4d) -
          (Z_i1d * b_i3 + Z_i1 * b_i3d));
      tb13 = tb12 * v_i;
      tb13d = tb12d * v_i + tb12 * v_id;
      Z_i3b += tb13 * b_i1;
      Z_i3bd += tb13d * b_i1 + tb13 * b_i1d;
      b_i1b = tb13 * Z_i3;
      b_i1bd = tb13d * Z_i3 + tb13 * Z_i3d;
      Z_i4b -= tb13 * b_i0;
      Z_i4bd -= tb13d * b_i0 + tb13 * b_i0d;
      b_i0b = -(tb13 * Z_i4);
      b_i0bd = -(tb13d * Z_i4 + tb13 * Z_i4d);
      Z_i0b = tb13 * b_i4;
      Z_i0bd = tb13d * b_i4 + tb13 * b_i4d;
      b_i4b += tb13 * Z_i0;
      b_i4bd += tb13d * Z_i0 + tb13 * Z_i0d;
      Z_i1b = -(tb13 * b_i3);
      Z_i1bd = -(tb13d * b_i3 + tb13 * b_i3d);
      b_i3b -= tb13 * Z_i1;
      b_i3bd -= tb13d * Z_i1 + tb13 * Z_i1d;
      tb10 = Z0b[i][1];
      tb10d = Z0bd[i][1];
      Z0b[i][1] = 0.0;
      Z0bd[i][1] = 0.0;
      Z0b[t->parent[i]][1] += tb10;
      Z0bd[t->parent[i]][1] += tb10d;
      v_ib += tb10 * (Z_i5 * b_i0 - Z_i3 * b_i2 + Z_i2 * b_i3 - Z_i0 * b_i5);
      v_ibd += tb10d * (Z_i5 * b_i0 - Z_i3 * b_i2 + Z_i2 * b_i3 - Z_i0 * b_i5) + tb10 * (Z_i5d *
          b_i0 + Z_i5 * b_i0d - (Z_i3d * b_i2 + Z_i3 * b_i2d) + (Z_i2d * b_i3 + Z_i2 * b_i3d) -
          (Z_i0d * b_i5 + Z_i0 * b_i5d));
      tb11 = tb10 * v_i;
      tb11d = tb10d * v_i + tb10 * v_id;
      Z_i5b += tb11 * b_i0;
      Z_i5bd += tb11d * b_i0 + tb11 * b_i0d;
      b_i0b += tb11 * Z_i5;
      b_i0bd += tb11d * Z_i5 + tb11 * Z_i5d;
      Z_i3b -= tb11 * b_i2;
      Z_i3bd -= tb11d * b_i2 + tb11 * b_i2d;
      b_i2b = -(tb11 * Z_i3);
      b_i2bd = -(tb11d * Z_i3 + tb11 * Z_i3d);
      Z_i2b = tb11 * b_i3;
      Z_i2bd = tb11d * b_i3 + tb11 * b_i3d;
      b_i3b += tb11 * Z_i2;
      b_i3bd += tb11d * Z_i2 + tb11 * Z_i2d;
      Z_i0b -= tb11 * b_i5;
      Z_i0bd -= tb11d * b_i5 + tb11 * b_i5d;
      b_i5b -= tb11 * Z_i0;
      b_i5bd -= tb11d * Z_i0 + tb11 * Z_i0d;
      tb8 = Z0b[i][0];
      tb8d = Z0bd[i][0];
      Z0b[i][0] = 0.0;
      Z0bd[i][0] = 0.0;
      Z0b[t->parent[i]][0] += tb8;
      Z0bd[t->parent[i]][0] += tb8d;
      v_ib += tb8 * (Z_i4 * b_i2 - Z_i5 * b_i1 + Z_i1 * b_i5 - Z_i2 * b_i4);
      v_ibd += tb8d * (Z_i4 * b_i2 - Z_i5 * b_i1 + Z_i1 * b_i5 - Z_i2 * b_i4) + tb8 * (Z_i4d * b_i2
          + Z_i4 * b_i2d - (Z_i5d * b_i1 + Z_i5 * b_i1d) + (Z_i1d * b_i5 + Z_i1 * b_i5d) - (Z_i2d *
          b_i4 + Z_i2 * b_i4d));
      tb9 = tb8 * v_i;
      tb9d = tb8d * v_i + tb8 * v_id;
      Z_i4b += tb9 * b_i2;
      Z_i4bd += tb9d * b_i2 + tb9 * b_i2d;
      b_i2b += tb9 * Z_i4;
      b_i2bd += tb9d * Z_i4 + tb9 * Z_i4d;
      Z_i5b -= tb9 * b_i1;
      Z_i5bd -= tb9d * b_i1 + tb9 * b_i1d;
      b_i1b -= tb9 * Z_i5;
      b_i1bd -= tb9d * Z_i5 + tb9 * Z_i5d;
      Z_i1b += tb9 * b_i5;
      Z_i1bd += tb9d * b_i5 + tb9 * b_i5d;
      b_i5b += tb9 * Z_i1;
      b_i5bd += tb9d * Z_i1 + tb9 * Z_i1d;
      Z_i2b -= tb9 * b_i4;
      Z_i2bd -= tb9d * b_i4 + tb9 * b_i4d;
      b_i4b -= tb9 * Z_i2;
      b_i4bd -= tb9d * Z_i2 + tb9 * Z_i2d;
      tb7 = Zb[i][5];
      tb7d = Zbd[i][5];
      Zb[i][5] = 0.0;
      Zbd[i][5] = 0.0;
      Z_i5b += tb7;
      Z_i5bd += tb7d;
      b_i5b += tb7 * v_i;
      b_i5bd += tb7d * v_i + tb7 * v_id;
      v_ib += tb7 * b_i5;
      v_ibd += tb7d * b_i5 + tb7 * b_i5d;
      bb[i][5] += b_i5b;
      bbd[i][5] += b_i5bd;
      Zb[t->parent[i]][5] += Z_i5b;
      Zbd[t->parent[i]][5] += Z_i5bd;
      tb6 = Zb[i][4];
      tb6d = Zbd[i][4];
      Zb[i][4] = 0.0;
      Zbd[i][4] = 0.0;
      Z_i4b += tb6;
      Z_i4bd += tb6d;
      b_i4b += tb6 * v_i;
      b_i4bd += tb6d * v_i + tb6 * v_id;
      v_ib += tb6 * b_i4;
      v_ibd += tb6d * b_i4 + tb6 * b_i4d;
      bb[i][4] += b_i4b;
      bbd[i][4] += b_i4bd;
      Zb[t->parent[i]][4] += Z_i4b;
      Zbd[t->parent[i]][4] += Z_i4bd;
      tb5 = Zb[i][3];
      tb5d = Zbd[i][3];
      Zb[i][3] = 0.0;
      Zbd[i][3] = 0.0;
      Z_i3b += tb5;
      Z_i3bd += tb5d;
      b_i3b += tb5 * v_i;
      b_i3bd += tb5d * v_i + tb5 * v_id;
      v_ib += tb5 * b_i3;
      v_ibd += tb5d * b_i3 + tb5 * b_i3d;
      bb[i][3] += b_i3b;
      bbd[i][3] += b_i3bd;
      Zb[t->parent[i]][3] += Z_i3b;
      Zbd[t->parent[i]][3] += Z_i3bd;
      tb4 = Zb[i][2];
      tb4d = Zbd[i][2];
      Zb[i][2] = 0.0;
      Zbd[i][2] = 0.0;
      Z_i2b += tb4;
      Z_i2bd += tb4d;
      b_i2b += tb4 * v_i;
      b_i2bd += tb4d * v_i + tb4 * v_id;
      v_ib += tb4 * b_i2;
      v_ibd += tb4d * b_i2 + tb4 * b_i2d;
      bb[i][2] += b_i2b;
      bbd[i][2] += b_i2bd;
      Zb[t->parent[i]][2] += Z_i2b;
      Zbd[t->parent[i]][2] += Z_i2bd;
      tb3 = Zb[i][1];
      tb3d = Zbd[i][1];
      Zb[i][1] = 0.0;
      Zbd[i][1] = 0.0;
      Z_i1b += tb3;
      Z_i1bd += tb3d;
      b_i1b += tb3 * v_i;
      b_i1bd += tb3d * v_i + tb3 * v_id;
      v_ib += tb3 * b_i1;
      v_ibd += tb3d * b_i1 + tb3 * b_i1d;
      bb[i][1] += b_i1b;
      bbd[i][1] += b_i1bd;
      Zb[t->parent[i]][1] += Z_i1b;
      Zbd[t->parent[i]][1] += Z_i1bd;
      tb2 = Zb[i][0];
      tb2d = Zbd[i][0];
      Zb[i][0] = 0.0;
      Zbd[i][0] = 0.0;
      Z_i0b += tb2;
      Z_i0bd += tb2d;
      b_i0b += tb2 * v_i;
      b_i0bd += tb2d * v_i + tb2 * v_id;
      v_ib += tb2 * b_i0;
      v_ibd += tb2d * b_i0 + tb2 * b_i0d;
      vb[t->qid[i]] += v_ib;
      vbd[t->qid[i]] += v_ibd;
      bb[i][0] += b_i0b;
      bbd[i][0] += b_i0bd;
      Zb[t->parent[i]][0] += Z_i0b;
      Zbd[t->parent[i]][0] += Z_i0bd;
    } else {
      for (k3 = 5; k3 >= 0; --k3) {
        Z0bd[t->parent[i]][k3] += Z0bd[i][k3];
        Z0b[t->parent[i]][k3] += Z0b[i][k3];
        Z0b[i][k3] = 0.0;
        Z0bd[i][k3] = 0.0;
      }
      for (k2 = 5; k2 >= 0; --k2) {
        Zbd[t->parent[i]][k2] += Zbd[i][k2];
        Zb[t->parent[i]][k2] += Zb[i][k2];
        Zb[i][k2] = 0.0;
        Zbd[i][k2] = 0.0;
      }
    }
  }
  Z0b[t->nbody][5] = 0.0;
  Z0bd[t->nbody][5] = 0.0;
  pb[2] -= Z0b[t->nbody][2];
  pbd[2] -= Z0bd[t->nbody][2];
  Z0b[t->nbody][2] = 0.0;
  Z0bd[t->nbody][2] = 0.0;
  Zb[t->nbody][5] = 0.0;
  Zbd[t->nbody][5] = 0.0;
  Zb[t->nbody][2] = 0.0;
  Zbd[t->nbody][2] = 0.0;
  Z0b[t->nbody][4] = 0.0;
  Z0bd[t->nbody][4] = 0.0;
  pb[1] -= Z0b[t->nbody][1];
  pbd[1] -= Z0bd[t->nbody][1];
  Z0b[t->nbody][1] = 0.0;
  Z0bd[t->nbody][1] = 0.0;
  Zb[t->nbody][4] = 0.0;
  Zbd[t->nbody][4] = 0.0;
  Zb[t->nbody][1] = 0.0;
  Zbd[t->nbody][1] = 0.0;
  Z0b[t->nbody][3] = 0.0;
  Z0bd[t->nbody][3] = 0.0;
  pb[0] -= Z0b[t->nbody][0];
  pbd[0] -= Z0bd[t->nbody][0];
  Z0b[t->nbody][0] = 0.0;
  Z0bd[t->nbody][0] = 0.0;
  Zb[t->nbody][3] = 0.0;
  Zbd[t->nbody][3] = 0.0;
  Zb[t->nbody][0] = 0.0;
  Zbd[t->nbody][0] = 0.0;
}

/* v = s + w × r */
void maggi_point_velocities_b_d(const maggi_topo *t, int begin, int end,
                                const double r[restrict t->npoint][3],
                                const double rd[restrict t->npoint][3],
                                double rb[restrict t->npoint][3], double rbd[restrict t->npoint][3],
                                const double Z[restrict t->nbody + 1][6],
                                const double Zd[restrict t->nbody + 1][6],
                                double Zb[restrict t->nbody + 1][6],
                                double Zbd[restrict t->nbody + 1][6],
                                double rv[restrict t->npoint][3], double rvd[restrict t->npoint][3],
                                double rvb[restrict t->npoint][3],
                                double rvbd[restrict t->npoint][3])
{
  int i;
  double Z_i3, Z_i3b, Z_i3bd, Z_i3d, Z_i4, Z_i4b, Z_i4bd, Z_i4d, Z_i5, Z_i5b, Z_i5bd, Z_i5d, r_i0,
      r_i0b, r_i0bd, r_i0d, r_i1, r_i1b, r_i1bd, r_i1d, r_i2, r_i2b, r_i2bd, r_i2d, tb2, tb2d, tb3,
      tb3d, tb4, tb4d;

  (void)rv;
  (void)rvd;
  for (i = end - 1; i >= begin; --i) {
    Z_i4 = Z[t->pointbody[i]][4];
    Z_i4d = Zd[t->pointbody[i]][4];
    r_i2 = r[i][2];
    r_i2d = rd[i][2];
    Z_i5 = Z[t->pointbody[i]][5];
    Z_i5d = Zd[t->pointbody[i]][5];
    r_i1 = r[i][1];
    r_i1d = rd[i][1];
    r_i0 = r[i][0];
    r_i0d = rd[i][0];
    Z_i3 = Z[t->pointbody[i]][3];
    Z_i3d = Zd[t->pointbody[i]][3];
    tb4 = rvb[i][2];
    tb4d = rvbd[i][2];
    rvb[i][2] = 0.0;
    rvbd[i][2] = 0.0;
    Zb[t->pointbody[i]][2] += tb4;
    Zbd[t->pointbody[i]][2] += tb4d;
    Z_i3b = tb4 * r_i1;
    Z_i3bd = tb4d * r_i1 + tb4 * r_i1d;
    r_i1b = tb4 * Z_i3;
    r_i1bd = tb4d * Z_i3 + tb4 * Z_i3d;
    Z_i4b = -(tb4 * r_i0);
    Z_i4bd = -(tb4d * r_i0 + tb4 * r_i0d);
    r_i0b = -(tb4 * Z_i4);
    r_i0bd = -(tb4d * Z_i4 + tb4 * Z_i4d);
    tb3 = rvb[i][1];
    tb3d = rvbd[i][1];
    rvb[i][1] = 0.0;
    rvbd[i][1] = 0.0;
    Zb[t->pointbody[i]][1] += tb3;
    Zbd[t->pointbody[i]][1] += tb3d;
    Z_i5b = tb3 * r_i0;
    Z_i5bd = tb3d * r_i0 + tb3 * r_i0d;
    r_i0b += tb3 * Z_i5;
    r_i0bd += tb3d * Z_i5 + tb3 * Z_i5d;
    Z_i3b -= tb3 * r_i2;
    Z_i3bd -= tb3d * r_i2 + tb3 * r_i2d;
    r_i2b = -(tb3 * Z_i3);
    r_i2bd = -(tb3d * Z_i3 + tb3 * Z_i3d);
    Zb[t->pointbody[i]][3] += Z_i3b;
    Zbd[t->pointbody[i]][3] += Z_i3bd;
    rb[i][0] += r_i0b;
    rbd[i][0] += r_i0bd;
    tb2 = rvb[i][0];
    tb2d = rvbd[i][0];
    rvb[i][0] = 0.0;
    rvbd[i][0] = 0.0;
    Zb[t->pointbody[i]][0] += tb2;
    Zbd[t->pointbody[i]][0] += tb2d;
    Z_i4b += tb2 * r_i2;
    Z_i4bd += tb2d * r_i2 + tb2 * r_i2d;
    r_i2b += tb2 * Z_i4;
    r_i2bd += tb2d * Z_i4 + tb2 * Z_i4d;
    Z_i5b -= tb2 * r_i1;
    Z_i5bd -= tb2d * r_i1 + tb2 * r_i1d;
    r_i1b -= tb2 * Z_i5;
    r_i1bd -= tb2d * Z_i5 + tb2 * Z_i5d;
    rb[i][1] += r_i1b;
    rbd[i][1] += r_i1bd;
    Zb[t->pointbody[i]][5] += Z_i5b;
    Zbd[t->pointbody[i]][5] += Z_i5bd;
    rb[i][2] += r_i2b;
    rbd[i][2] += r_i2bd;
    Zb[t->pointbody[i]][4] += Z_i4b;
    Zbd[t->pointbody[i]][4] += Z_i4bd;
  }
}

/* Za_i = Z0_i + W_i,  W_i = W_p + b_i a_i */
void maggi_accelerations_b_d(const maggi_topo *t, const double b[restrict t->nbody][6],
                             const double bd[restrict t->nbody][6], double bb[restrict t->nbody][6],
                             double bbd[restrict t->nbody][6],
                             const double Z0[restrict t->nbody + 1][6],
                             const double Z0d[restrict t->nbody + 1][6],
                             double Z0b[restrict t->nbody + 1][6],
                             double Z0bd[restrict t->nbody + 1][6], const double a[restrict t->nq],
                             const double ad[restrict t->nq], double ab[restrict t->nq],
                             double abd[restrict t->nq], double W[restrict t->nbody + 1][6],
                             double Wd[restrict t->nbody + 1][6],
                             double Wb[restrict t->nbody + 1][6],
                             double Wbd[restrict t->nbody + 1][6],
                             double Za[restrict t->nbody + 1][6],
                             double Zad[restrict t->nbody + 1][6],
                             double Zab[restrict t->nbody + 1][6],
                             double Zabd[restrict t->nbody + 1][6])
{
  int i, k, k2, k3, k4;
  double tb2, tb2d, tb3, tb3d;

  (void)Z0;
  (void)Z0d;
  (void)W;
  (void)Wd;
  (void)Za;
  (void)Zad;
  for (i = 0; i < t->nbody; ++i) {
    for (k4 = 5; k4 >= 0; --k4) {
      tb3 = Zab[i][k4];
      tb3d = Zabd[i][k4];
      Zab[i][k4] = 0.0;
      Zabd[i][k4] = 0.0;
      Z0b[i][k4] += tb3;
      Z0bd[i][k4] += tb3d;
      Wb[i][k4] += tb3;
      Wbd[i][k4] += tb3d;
    }
    if (t->qid[i] >= 0) {
      for (k2 = 5; k2 >= 0; --k2) {
        tb2 = Wb[i][k2];
        tb2d = Wbd[i][k2];
        Wb[i][k2] = 0.0;
        Wbd[i][k2] = 0.0;
        Wb[t->parent[i]][k2] += tb2;
        Wbd[t->parent[i]][k2] += tb2d;
        bb[i][k2] += tb2 * a[t->qid[i]];
        bbd[i][k2] += tb2d * a[t->qid[i]] + tb2 * ad[t->qid[i]];
        ab[t->qid[i]] += tb2 * b[i][k2];
        abd[t->qid[i]] += tb2d * b[i][k2] + tb2 * bd[i][k2];
      }
    } else {
      for (k3 = 5; k3 >= 0; --k3) {
        Wbd[t->parent[i]][k3] += Wbd[i][k3];
        Wb[t->parent[i]][k3] += Wb[i][k3];
        Wb[i][k3] = 0.0;
        Wbd[i][k3] = 0.0;
      }
    }
  }
  for (k = 5; k >= 0; --k) {
    Z0b[t->nbody][k] += Zab[t->nbody][k];
    Z0bd[t->nbody][k] += Zabd[t->nbody][k];
    Zab[t->nbody][k] = 0.0;
    Zabd[t->nbody][k] = 0.0;
    Wb[t->nbody][k] = 0.0;
    Wbd[t->nbody][k] = 0.0;
  }
}

/* a = s' + w' × r + w × v; less gravity when Za begins with it */
void maggi_point_accelerations_b_d(const maggi_topo *t, int begin, int end,
                                   const double r[restrict t->npoint][3],
                                   const double rd[restrict t->npoint][3],
                                   double rb[restrict t->npoint][3],
                                   double rbd[restrict t->npoint][3],
                                   const double rv[restrict t->npoint][3],
                                   const double rvd[restrict t->npoint][3],
                                   double rvb[restrict t->npoint][3],
                                   double rvbd[restrict t->npoint][3],
                                   const double Z[restrict t->nbody + 1][6],
                                   const double Zd[restrict t->nbody + 1][6],
                                   double Zb[restrict t->nbody + 1][6],
                                   double Zbd[restrict t->nbody + 1][6],
                                   const double Za[restrict t->nbody + 1][6],
                                   const double Zad[restrict t->nbody + 1][6],
                                   double Zab[restrict t->nbody + 1][6],
                                   double Zabd[restrict t->nbody + 1][6],
                                   double ra[restrict t->npoint][3],
                                   double rad[restrict t->npoint][3],
                                   double rab[restrict t->npoint][3],
                                   double rabd[restrict t->npoint][3])
{
  int i;
  double Z_i3, Z_i3b, Z_i3bd, Z_i3d, Z_i4, Z_i4b, Z_i4bd, Z_i4d, Z_i5, Z_i5b, Z_i5bd, Z_i5d, Za_i3,
      Za_i3b, Za_i3bd, Za_i3d, Za_i4, Za_i4b, Za_i4bd, Za_i4d, Za_i5, Za_i5b, Za_i5bd, Za_i5d, c0b,
      c0bd, c1b, c1bd, c2b, c2bd, r_i0, r_i0b, r_i0bd, r_i0d, r_i1, r_i1b, r_i1bd, r_i1d, r_i2,
      r_i2b, r_i2bd, r_i2d, rv_i0, rv_i0b, rv_i0bd, rv_i0d, rv_i1, rv_i1b, rv_i1bd, rv_i1d, rv_i2,
      rv_i2b, rv_i2bd, rv_i2d, tb2, tb2d, tb3, tb3d, tb4, tb4d;

  (void)ra;
  (void)rad;
  for (i = end - 1; i >= begin; --i) {
    Za_i4 = Za[t->pointbody[i]][4];
    Za_i4d = Zad[t->pointbody[i]][4];
    r_i2 = r[i][2];
    r_i2d = rd[i][2];
    Za_i5 = Za[t->pointbody[i]][5];
    Za_i5d = Zad[t->pointbody[i]][5];
    r_i1 = r[i][1];
    r_i1d = rd[i][1];
    r_i0 = r[i][0];
    r_i0d = rd[i][0];
    Za_i3 = Za[t->pointbody[i]][3];
    Za_i3d = Zad[t->pointbody[i]][3];
    Z_i4 = Z[t->pointbody[i]][4];
    Z_i4d = Zd[t->pointbody[i]][4];
    rv_i2 = rv[i][2];
    rv_i2d = rvd[i][2];
    Z_i5 = Z[t->pointbody[i]][5];
    Z_i5d = Zd[t->pointbody[i]][5];
    rv_i1 = rv[i][1];
    rv_i1d = rvd[i][1];
    rv_i0 = rv[i][0];
    rv_i0d = rvd[i][0];
    Z_i3 = Z[t->pointbody[i]][3];
    Z_i3d = Zd[t->pointbody[i]][3];
    tb4 = rab[i][2];
    tb4d = rabd[i][2];
    rab[i][2] = 0.0;
    rabd[i][2] = 0.0;
    c2b = tb4;
    c2bd = tb4d;
    Z_i3b = tb4 * rv_i1;
    Z_i3bd = tb4d * rv_i1 + tb4 * rv_i1d;
    rv_i1b = tb4 * Z_i3;
    rv_i1bd = tb4d * Z_i3 + tb4 * Z_i3d;
    Z_i4b = -(tb4 * rv_i0);
    Z_i4bd = -(tb4d * rv_i0 + tb4 * rv_i0d);
    rv_i0b = -(tb4 * Z_i4);
    rv_i0bd = -(tb4d * Z_i4 + tb4 * Z_i4d);
    tb3 = rab[i][1];
    tb3d = rabd[i][1];
    rab[i][1] = 0.0;
    rabd[i][1] = 0.0;
    c1b = tb3;
    c1bd = tb3d;
    Z_i5b = tb3 * rv_i0;
    Z_i5bd = tb3d * rv_i0 + tb3 * rv_i0d;
    rv_i0b += tb3 * Z_i5;
    rv_i0bd += tb3d * Z_i5 + tb3 * Z_i5d;
    Z_i3b -= tb3 * rv_i2;
    Z_i3bd -= tb3d * rv_i2 + tb3 * rv_i2d;
    rv_i2b = -(tb3 * Z_i3);
    rv_i2bd = -(tb3d * Z_i3 + tb3 * Z_i3d);
    Zb[t->pointbody[i]][3] += Z_i3b;
    Zbd[t->pointbody[i]][3] += Z_i3bd;
    rvb[i][0] += rv_i0b;
    rvbd[i][0] += rv_i0bd;
    tb2 = rab[i][0];
    tb2d = rabd[i][0];
    rab[i][0] = 0.0;
    rabd[i][0] = 0.0;
    c0b = tb2;
    c0bd = tb2d;
    Z_i4b += tb2 * rv_i2;
    Z_i4bd += tb2d * rv_i2 + tb2 * rv_i2d;
    rv_i2b += tb2 * Z_i4;
    rv_i2bd += tb2d * Z_i4 + tb2 * Z_i4d;
    Z_i5b -= tb2 * rv_i1;
    Z_i5bd -= tb2d * rv_i1 + tb2 * rv_i1d;
    rv_i1b -= tb2 * Z_i5;
    rv_i1bd -= tb2d * Z_i5 + tb2 * Z_i5d;
    rvb[i][1] += rv_i1b;
    rvbd[i][1] += rv_i1bd;
    Zb[t->pointbody[i]][5] += Z_i5b;
    Zbd[t->pointbody[i]][5] += Z_i5bd;
    rvb[i][2] += rv_i2b;
    rvbd[i][2] += rv_i2bd;
    Zb[t->pointbody[i]][4] += Z_i4b;
    Zbd[t->pointbody[i]][4] += Z_i4bd;
    Zab[t->pointbody[i]][2] += c2b;
    Zabd[t->pointbody[i]][2] += c2bd;
    Za_i3b = c2b * r_i1;
    Za_i3bd = c2bd * r_i1 + c2b * r_i1d;
    r_i1b = c2b * Za_i3;
    r_i1bd = c2bd * Za_i3 + c2b * Za_i3d;
    Za_i4b = -(c2b * r_i0);
    Za_i4bd = -(c2bd * r_i0 + c2b * r_i0d);
    r_i0b = -(c2b * Za_i4);
    r_i0bd = -(c2bd * Za_i4 + c2b * Za_i4d);
    Zab[t->pointbody[i]][1] += c1b;
    Zabd[t->pointbody[i]][1] += c1bd;
    Za_i5b = c1b * r_i0;
    Za_i5bd = c1bd * r_i0 + c1b * r_i0d;
    r_i0b += c1b * Za_i5;
    r_i0bd += c1bd * Za_i5 + c1b * Za_i5d;
    Za_i3b -= c1b * r_i2;
    Za_i3bd -= c1bd * r_i2 + c1b * r_i2d;
    r_i2b = -(c1b * Za_i3);
    r_i2bd = -(c1bd * Za_i3 + c1b * Za_i3d);
    Zab[t->pointbody[i]][3] += Za_i3b;
    Zabd[t->pointbody[i]][3] += Za_i3bd;
    rb[i][0] += r_i0b;
    rbd[i][0] += r_i0bd;
    Zab[t->pointbody[i]][0] += c0b;
    Zabd[t->pointbody[i]][0] += c0bd;
    Za_i4b += c0b * r_i2;
    Za_i4bd += c0bd * r_i2 + c0b * r_i2d;
    r_i2b += c0b * Za_i4;
    r_i2bd += c0bd * Za_i4 + c0b * Za_i4d;
    Za_i5b -= c0b * r_i1;
    Za_i5bd -= c0bd * r_i1 + c0b * r_i1d;
    r_i1b -= c0b * Za_i5;
    r_i1bd -= c0bd * Za_i5 + c0b * Za_i5d;
    rb[i][1] += r_i1b;
    rbd[i][1] += r_i1bd;
    Zab[t->pointbody[i]][5] += Za_i5b;
    Zabd[t->pointbody[i]][5] += Za_i5bd;
    rb[i][2] += r_i2b;
    rbd[i][2] += r_i2bd;
    Zab[t->pointbody[i]][4] += Za_i4b;
    Zabd[t->pointbody[i]][4] += Za_i4bd;
  }
}
