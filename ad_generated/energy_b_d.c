/* Tangent of the adjoint of core/kernel/energy.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* T = sum Z.(I Z) / 2 + sum over rods m v_a.v_b / 6 */
void maggi_kinetic_energy_b_d(const maggi_topo *t, const double p[restrict t->np],
                              const double pd[restrict t->np], double pb[restrict t->np],
                              double pbd[restrict t->np], const double I[restrict t->nbody][10],
                              const double Id[restrict t->nbody][10],
                              double Ib[restrict t->nbody][10], double Ibd[restrict t->nbody][10],
                              const double Z[restrict t->nbody + 1][6],
                              const double Zd[restrict t->nbody + 1][6],
                              double Zb[restrict t->nbody + 1][6],
                              double Zbd[restrict t->nbody + 1][6],
                              const double rv[restrict t->npoint][3],
                              const double rvd[restrict t->npoint][3],
                              double rvb[restrict t->npoint][3], double rvbd[restrict t->npoint][3],
                              double energy[restrict 1], double energyd[restrict 1],
                              double energyb[restrict 1], double energybd[restrict 1])
{
  int i, k;
  double H0, H0b, H0bd, H0d, H1, H1b, H1bd, H1d, H2, H2b, H2bd, H2d, H3, H3b, H3bd, H3d, H4, H4b,
      H4bd, H4d, H5, H5b, H5bd, H5d, tb2, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d;

  (void)energy;
  (void)energyd;
  for (i = t->nrod - 1; i >= 0; --i) {
    tb4 = energyb[0];
    tb4d = energybd[0];
    pb[t->rodadr[i]] += tb4 * (rv[t->rodpa[i]][0] * rv[t->rodpb[i]][0] + rv[t->rodpa[i]][1] *
        rv[t->rodpb[i]][1] + rv[t->rodpa[i]][2] * rv[t->rodpb[i]][2]) / 6.0;
    pbd[t->rodadr[i]] += (tb4d * (rv[t->rodpa[i]][0] * rv[t->rodpb[i]][0] + rv[t->rodpa[i]][1] *
        rv[t->rodpb[i]][1] + rv[t->rodpa[i]][2] * rv[t->rodpb[i]][2]) + tb4 * (rvd[t->rodpa[i]][0] *
        rv[t->rodpb[i]][0] + rv[t->rodpa[i]][0] * rvd[t->rodpb[i]][0] + (rvd[t->rodpa[i]][1] *
        rv[t->rodpb[i]][1] + rv[t->rodpa[i]][1] * rvd[t->rodpb[i]][1]) + (rvd[t->rodpa[i]][2] *
        rv[t->rodpb[i]][2] + rv[t->rodpa[i]][2] * rvd[t->rodpb[i]][2]))) / 6.0;
    tb5 = tb4 * (p[t->rodadr[i]] / 6.0);
    tb5d = tb4d * (p[t->rodadr[i]] / 6.0) + tb4 * (pd[t->rodadr[i]] / 6.0);
    rvb[t->rodpa[i]][0] += tb5 * rv[t->rodpb[i]][0];
    rvbd[t->rodpa[i]][0] += tb5d * rv[t->rodpb[i]][0] + tb5 * rvd[t->rodpb[i]][0];
    rvb[t->rodpb[i]][0] += tb5 * rv[t->rodpa[i]][0];
    rvbd[t->rodpb[i]][0] += tb5d * rv[t->rodpa[i]][0] + tb5 * rvd[t->rodpa[i]][0];
    rvb[t->rodpa[i]][1] += tb5 * rv[t->rodpb[i]][1];
    rvbd[t->rodpa[i]][1] += tb5d * rv[t->rodpb[i]][1] + tb5 * rvd[t->rodpb[i]][1];
    rvb[t->rodpb[i]][1] += tb5 * rv[t->rodpa[i]][1];
    rvbd[t->rodpb[i]][1] += tb5d * rv[t->rodpa[i]][1] + tb5 * rvd[t->rodpa[i]][1];
    rvb[t->rodpa[i]][2] += tb5 * rv[t->rodpb[i]][2];
    rvbd[t->rodpa[i]][2] += tb5d * rv[t->rodpb[i]][2] + tb5 * rvd[t->rodpb[i]][2];
    rvb[t->rodpb[i]][2] += tb5 * rv[t->rodpa[i]][2];
    rvbd[t->rodpb[i]][2] += tb5d * rv[t->rodpa[i]][2] + tb5 * rvd[t->rodpa[i]][2];
  }
  for (i = t->nmassive - 1; i >= 0; --i) {
    k = t->massive[i];
    H0 = I[k][0] * Z[k][0] + Z[k][4] * I[k][3] - Z[k][5] * I[k][2];
    H0d = Id[k][0] * Z[k][0] + I[k][0] * Zd[k][0] + (Zd[k][4] * I[k][3] + Z[k][4] * Id[k][3]) -
        (Zd[k][5] * I[k][2] + Z[k][5] * Id[k][2]);
    H1 = I[k][0] * Z[k][1] + Z[k][5] * I[k][1] - Z[k][3] * I[k][3];
    H1d = Id[k][0] * Z[k][1] + I[k][0] * Zd[k][1] + (Zd[k][5] * I[k][1] + Z[k][5] * Id[k][1]) -
        (Zd[k][3] * I[k][3] + Z[k][3] * Id[k][3]);
    H2 = I[k][0] * Z[k][2] + Z[k][3] * I[k][2] - Z[k][4] * I[k][1];
    H2d = Id[k][0] * Z[k][2] + I[k][0] * Zd[k][2] + (Zd[k][3] * I[k][2] + Z[k][3] * Id[k][2]) -
        (Zd[k][4] * I[k][1] + Z[k][4] * Id[k][1]);
    H3 = I[k][2] * Z[k][2] - I[k][3] * Z[k][1] + I[k][4] * Z[k][3] + I[k][7] * Z[k][4] + I[k][8] *
        Z[k][5];
    H3d = Id[k][2] * Z[k][2] + I[k][2] * Zd[k][2] - (Id[k][3] * Z[k][1] + I[k][3] * Zd[k][1]) +
        (Id[k][4] * Z[k][3] + I[k][4] * Zd[k][3]) + (Id[k][7] * Z[k][4] + I[k][7] * Zd[k][4]) +
        (Id[k][8] * Z[k][5] + I[k][8] * Zd[k][5]);
    H4 = I[k][3] * Z[k][0] - I[k][1] * Z[k][2] + I[k][7] * Z[k][3] + I[k][5] * Z[k][4] + I[k][9] *
        Z[k][5];
    H4d = Id[k][3] * Z[k][0] + I[k][3] * Zd[k][0] - (Id[k][1] * Z[k][2] + I[k][1] * Zd[k][2]) +
        (Id[k][7] * Z[k][3] + I[k][7] * Zd[k][3]) + (Id[k][5] * Z[k][4] + I[k][5] * Zd[k][4]) +
        (Id[k][9] * Z[k][5] + I[k][9] * Zd[k][5]);
    H5 = I[k][1] * Z[k][1] - I[k][2] * Z[k][0] + I[k][8] * Z[k][3] + I[k][9] * Z[k][4] + I[k][6] *
        Z[k][5];
    H5d = Id[k][1] * Z[k][1] + I[k][1] * Zd[k][1] - (Id[k][2] * Z[k][0] + I[k][2] * Zd[k][0]) +
        (Id[k][8] * Z[k][3] + I[k][8] * Zd[k][3]) + (Id[k][9] * Z[k][4] + I[k][9] * Zd[k][4]) +
        (Id[k][6] * Z[k][5] + I[k][6] * Zd[k][5]);
    tb2 = energyb[0];
    tb2d = energybd[0];
    tb3 = tb2 * 0.5;
    tb3d = tb2d * 0.5;
    H0b = tb3 * Z[k][0];
    H0bd = tb3d * Z[k][0] + tb3 * Zd[k][0];
    Zb[k][0] += tb3 * H0;
    Zbd[k][0] += tb3d * H0 + tb3 * H0d;
    H1b = tb3 * Z[k][1];
    H1bd = tb3d * Z[k][1] + tb3 * Zd[k][1];
    Zb[k][1] += tb3 * H1;
    Zbd[k][1] += tb3d * H1 + tb3 * H1d;
    H2b = tb3 * Z[k][2];
    H2bd = tb3d * Z[k][2] + tb3 * Zd[k][2];
    Zb[k][2] += tb3 * H2;
    Zbd[k][2] += tb3d * H2 + tb3 * H2d;
    H3b = tb3 * Z[k][3];
    H3bd = tb3d * Z[k][3] + tb3 * Zd[k][3];
    Zb[k][3] += tb3 * H3;
    Zbd[k][3] += tb3d * H3 + tb3 * H3d;
    H4b = tb3 * Z[k][4];
    H4bd = tb3d * Z[k][4] + tb3 * Zd[k][4];
    Zb[k][4] += tb3 * H4;
    Zbd[k][4] += tb3d * H4 + tb3 * H4d;
    H5b = tb3 * Z[k][5];
    H5bd = tb3d * Z[k][5] + tb3 * Zd[k][5];
    Zb[k][5] += tb3 * H5;
    Zbd[k][5] += tb3d * H5 + tb3 * H5d;
    Ib[k][1] += H5b * Z[k][1];
    Ibd[k][1] += H5bd * Z[k][1] + H5b * Zd[k][1];
    Zb[k][1] += H5b * I[k][1];
    Zbd[k][1] += H5bd * I[k][1] + H5b * Id[k][1];
    Ib[k][2] -= H5b * Z[k][0];
    Ibd[k][2] -= H5bd * Z[k][0] + H5b * Zd[k][0];
    Zb[k][0] -= H5b * I[k][2];
    Zbd[k][0] -= H5bd * I[k][2] + H5b * Id[k][2];
    Ib[k][8] += H5b * Z[k][3];
    Ibd[k][8] += H5bd * Z[k][3] + H5b * Zd[k][3];
    Zb[k][3] += H5b * I[k][8];
    Zbd[k][3] += H5bd * I[k][8] + H5b * Id[k][8];
    Ib[k][9] += H5b * Z[k][4];
    Ibd[k][9] += H5bd * Z[k][4] + H5b * Zd[k][4];
    Zb[k][4] += H5b * I[k][9];
    Zbd[k][4] += H5bd * I[k][9] + H5b * Id[k][9];
    Ib[k][6] += H5b * Z[k][5];
    Ibd[k][6] += H5bd * Z[k][5] + H5b * Zd[k][5];
    Zb[k][5] += H5b * I[k][6];
    Zbd[k][5] += H5bd * I[k][6] + H5b * Id[k][6];
    Ib[k][3] += H4b * Z[k][0];
    Ibd[k][3] += H4bd * Z[k][0] + H4b * Zd[k][0];
    Zb[k][0] += H4b * I[k][3];
    Zbd[k][0] += H4bd * I[k][3] + H4b * Id[k][3];
    Ib[k][1] -= H4b * Z[k][2];
    Ibd[k][1] -= H4bd * Z[k][2] + H4b * Zd[k][2];
    Zb[k][2] -= H4b * I[k][1];
    Zbd[k][2] -= H4bd * I[k][1] + H4b * Id[k][1];
    Ib[k][7] += H4b * Z[k][3];
    Ibd[k][7] += H4bd * Z[k][3] + H4b * Zd[k][3];
    Zb[k][3] += H4b * I[k][7];
    Zbd[k][3] += H4bd * I[k][7] + H4b * Id[k][7];
    Ib[k][5] += H4b * Z[k][4];
    Ibd[k][5] += H4bd * Z[k][4] + H4b * Zd[k][4];
    Zb[k][4] += H4b * I[k][5];
    Zbd[k][4] += H4bd * I[k][5] + H4b * Id[k][5];
    Ib[k][9] += H4b * Z[k][5];
    Ibd[k][9] += H4bd * Z[k][5] + H4b * Zd[k][5];
    Zb[k][5] += H4b * I[k][9];
    Zbd[k][5] += H4bd * I[k][9] + H4b * Id[k][9];
    Ib[k][2] += H3b * Z[k][2];
    Ibd[k][2] += H3bd * Z[k][2] + H3b * Zd[k][2];
    Zb[k][2] += H3b * I[k][2];
    Zbd[k][2] += H3bd * I[k][2] + H3b * Id[k][2];
    Ib[k][3] -= H3b * Z[k][1];
    Ibd[k][3] -= H3bd * Z[k][1] + H3b * Zd[k][1];
    Zb[k][1] -= H3b * I[k][3];
    Zbd[k][1] -= H3bd * I[k][3] + H3b * Id[k][3];
    Ib[k][4] += H3b * Z[k][3];
    Ibd[k][4] += H3bd * Z[k][3] + H3b * Zd[k][3];
    Zb[k][3] += H3b * I[k][4];
    Zbd[k][3] += H3bd * I[k][4] + H3b * Id[k][4];
    Ib[k][7] += H3b * Z[k][4];
    Ibd[k][7] += H3bd * Z[k][4] + H3b * Zd[k][4];
    Zb[k][4] += H3b * I[k][7];
    Zbd[k][4] += H3bd * I[k][7] + H3b * Id[k][7];
    Ib[k][8] += H3b * Z[k][5];
    Ibd[k][8] += H3bd * Z[k][5] + H3b * Zd[k][5];
    Zb[k][5] += H3b * I[k][8];
    Zbd[k][5] += H3bd * I[k][8] + H3b * Id[k][8];
    Ib[k][0] += H2b * Z[k][2];
    Ibd[k][0] += H2bd * Z[k][2] + H2b * Zd[k][2];
    Zb[k][2] += H2b * I[k][0];
    Zbd[k][2] += H2bd * I[k][0] + H2b * Id[k][0];
    Zb[k][3] += H2b * I[k][2];
    Zbd[k][3] += H2bd * I[k][2] + H2b * Id[k][2];
    Ib[k][2] += H2b * Z[k][3];
    Ibd[k][2] += H2bd * Z[k][3] + H2b * Zd[k][3];
    Zb[k][4] -= H2b * I[k][1];
    Zbd[k][4] -= H2bd * I[k][1] + H2b * Id[k][1];
    Ib[k][1] -= H2b * Z[k][4];
    Ibd[k][1] -= H2bd * Z[k][4] + H2b * Zd[k][4];
    Ib[k][0] += H1b * Z[k][1];
    Ibd[k][0] += H1bd * Z[k][1] + H1b * Zd[k][1];
    Zb[k][1] += H1b * I[k][0];
    Zbd[k][1] += H1bd * I[k][0] + H1b * Id[k][0];
    Zb[k][5] += H1b * I[k][1];
    Zbd[k][5] += H1bd * I[k][1] + H1b * Id[k][1];
    Ib[k][1] += H1b * Z[k][5];
    Ibd[k][1] += H1bd * Z[k][5] + H1b * Zd[k][5];
    Zb[k][3] -= H1b * I[k][3];
    Zbd[k][3] -= H1bd * I[k][3] + H1b * Id[k][3];
    Ib[k][3] -= H1b * Z[k][3];
    Ibd[k][3] -= H1bd * Z[k][3] + H1b * Zd[k][3];
    Ib[k][0] += H0b * Z[k][0];
    Ibd[k][0] += H0bd * Z[k][0] + H0b * Zd[k][0];
    Zb[k][0] += H0b * I[k][0];
    Zbd[k][0] += H0bd * I[k][0] + H0b * Id[k][0];
    Zb[k][4] += H0b * I[k][3];
    Zbd[k][4] += H0bd * I[k][3] + H0b * Id[k][3];
    Ib[k][3] += H0b * Z[k][4];
    Ibd[k][3] += H0bd * Z[k][4] + H0b * Zd[k][4];
    Zb[k][5] -= H0b * I[k][2];
    Zbd[k][5] -= H0bd * I[k][2] + H0b * Id[k][2];
    Ib[k][2] -= H0b * Z[k][5];
    Ibd[k][2] -= H0bd * Z[k][5] + H0b * Zd[k][5];
  }
  energyb[0] = 0.0;
  energybd[0] = 0.0;
}

void maggi_potential_energy_b_d(const maggi_topo *t, const double p[restrict t->np],
                                const double pd[restrict t->np], double pb[restrict t->np],
                                double pbd[restrict t->np], const double origin[restrict 3],
                                const double body0[restrict t->nbody][10],
                                const double body0d[restrict t->nbody][10],
                                double body0b[restrict t->nbody][10],
                                double body0bd[restrict t->nbody][10],
                                const double spring0[restrict t->nspring],
                                const double spring0d[restrict t->nspring],
                                double spring0b[restrict t->nspring],
                                double spring0bd[restrict t->nspring],
                                const double q[restrict t->nq], const double qd[restrict t->nq],
                                double qb[restrict t->nq], double qbd[restrict t->nq],
                                const double A[restrict t->nbody + 1][9],
                                const double Ad[restrict t->nbody + 1][9],
                                double Ab[restrict t->nbody + 1][9],
                                double Abd[restrict t->nbody + 1][9],
                                const double x[restrict t->nbody + 1][3],
                                const double xd[restrict t->nbody + 1][3],
                                double xb[restrict t->nbody + 1][3],
                                double xbd[restrict t->nbody + 1][3],
                                const double r[restrict t->npoint][3],
                                const double rd[restrict t->npoint][3],
                                double rb[restrict t->npoint][3], double rbd[restrict t->npoint][3],
                                double energy[restrict 1], double energyd[restrict 1],
                                double energyb[restrict 1], double energybd[restrict 1])
{
  int a, a2, a3, adr, adr2, b, b2, b3, i, k;
  double e0, e0b, e0bd, e0d, e1, e1b, e1bd, e1d, e2_2, e2_2b, e2_2bd, e2_2d, e2b, e2bd, g0, g0b,
      g0bd, g0d, g1, g1b, g1bd, g1d, g2, g2b, g2bd, g2d, h00, h00b, h00bd, h00d, h01, h01b, h01bd,
      h01d, h02, h02b, h02bd, h02d, h0_2, h0_2b, h0_2bd, h0_2d, h1, h1b, h1bd, h1d, h2, h2b, h2bd,
      h2d, l, lb, lbd, ld, p2, p2b, p2bd, p2d, p3, p3b, p3bd, p3d, p_i, p_ib, p_ibd, p_id, sharea,
      shareb, spring0_i, spring0_ib, spring0_ibd, spring0_id, t2, t2b, t2bd, t2d, tb10, tb10d, tb11,
      tb11d, tb12, tb12d, tb13, tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d, tb17, tb17d, tb18,
      tb18d, tb19, tb19d, tb2, tb20, tb20d, tb21, tb21d, tb22, tb22d, tb23, tb23d, tb24, tb24d,
      tb25, tb25d, tb26, tb26d, tb27, tb27d, tb28, tb28d, tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31,
      tb31d, tb32, tb32d, tb33, tb33d, tb34, tb34d, tb35, tb35d, tb3d, tb4, tb4d, tb5, tb5d, tb6,
      tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d, x_nbody0, x_nbody0b, x_nbody0bd, x_nbody0d, x_nbody1,
      x_nbody1b, x_nbody1bd, x_nbody1d, x_nbody2, x_nbody2b, x_nbody2bd, x_nbody2d, z, zb, zbd, zd;

  (void)energy;
  (void)energyd;
  for (i = t->njspring - 1; i >= 0; --i) {
    a3 = t->jspringq[i];
    b3 = t->jspringq2[i];
    adr2 = t->jspringadr[i];
    if (b3 >= 0) {
      z = q[a3] - q[b3];
      zd = qd[a3] - qd[b3];
    } else {
      z = q[a3];
      zd = qd[a3];
    }
    p3 = p[adr2 + MAGGI_JSPRING_REST];
    p3d = pd[adr2 + MAGGI_JSPRING_REST];
    tb32 = energyb[0];
    tb32d = energybd[0];
    tb33 = tb32 * (z - p3);
    tb33d = tb32d * (z - p3) + tb32 * (zd - p3d);
    pb[adr2] += tb33 * (z - p3) * 0.5;
    pbd[adr2] += (tb33d * (z - p3) + tb33 * (zd - p3d)) * 0.5;
    tb34 = tb33 * (0.5 * p[adr2]);
    tb34d = tb33d * (0.5 * p[adr2]) + tb33 * (0.5 * pd[adr2]);
    zb = tb34;
    zbd = tb34d;
    p3b = -tb34;
    p3bd = -tb34d;
    tb35 = tb32 * (0.5 * p[adr2] * (z - p3));
    tb35d = tb32d * (0.5 * p[adr2] * (z - p3)) + tb32 * (0.5 * pd[adr2] * (z - p3) + 0.5 * p[adr2] *
        (zd - p3d));
    zb += tb35;
    zbd += tb35d;
    p3b -= tb35;
    p3bd -= tb35d;
    pb[adr2 + MAGGI_JSPRING_PRELOAD] += tb32 * z;
    pbd[adr2 + MAGGI_JSPRING_PRELOAD] += tb32d * z + tb32 * zd;
    zb += tb32 * p[adr2 + MAGGI_JSPRING_PRELOAD];
    zbd += tb32d * p[adr2 + MAGGI_JSPRING_PRELOAD] + tb32 * pd[adr2 + MAGGI_JSPRING_PRELOAD];
    pb[adr2 + MAGGI_JSPRING_REST] += p3b;
    pbd[adr2 + MAGGI_JSPRING_REST] += p3bd;
    if (b3 >= 0) {
      qb[a3] += zb;
      qbd[a3] += zbd;
      qb[b3] -= zb;
      qbd[b3] -= zbd;
      zb = 0.0;
      zbd = 0.0;
    } else {
      qb[a3] += zb;
      qbd[a3] += zbd;
      zb = 0.0;
      zbd = 0.0;
    }
  }
  for (i = t->nspring - 1; i >= 0; --i) {
    a2 = t->springpa[i];
    b2 = t->springpb[i];
    adr = t->springadr[i];
    e0 = r[a2][0] - r[b2][0];
    e0d = rd[a2][0] - rd[b2][0];
    e1 = r[a2][1] - r[b2][1];
    e1d = rd[a2][1] - rd[b2][1];
    e2_2 = r[a2][2] - r[b2][2];
    e2_2d = rd[a2][2] - rd[b2][2];
    t2 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
    t2d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
    l = sqrt(t2);
    ld = 1.0 / (2.0 * l) * t2d;
    lb = 0.0;
    lbd = 0.0;
    if (t->springpreload[i]) {
      spring0_i = spring0[i];
      spring0_id = spring0d[i];
      tb23 = energyb[0];
      tb23d = energybd[0];
      tb24 = tb23 * (l - spring0_i);
      tb24d = tb23d * (l - spring0_i) + tb23 * (ld - spring0_id);
      pb[adr] += tb24 * (l - spring0_i) * 0.5;
      pbd[adr] += (tb24d * (l - spring0_i) + tb24 * (ld - spring0_id)) * 0.5;
      tb25 = tb24 * (0.5 * p[adr]);
      tb25d = tb24d * (0.5 * p[adr]) + tb24 * (0.5 * pd[adr]);
      lb += tb25;
      lbd += tb25d;
      spring0_ib = -tb25;
      spring0_ibd = -tb25d;
      tb26 = tb23 * (0.5 * p[adr] * (l - spring0_i));
      tb26d = tb23d * (0.5 * p[adr] * (l - spring0_i)) + tb23 * (0.5 * pd[adr] * (l - spring0_i) +
          0.5 * p[adr] * (ld - spring0_id));
      lb += tb26;
      lbd += tb26d;
      spring0_ib -= tb26;
      spring0_ibd -= tb26d;
      pb[adr + MAGGI_SPRING_L] += tb23 * (l - spring0_i);
      pbd[adr + MAGGI_SPRING_L] += tb23d * (l - spring0_i) + tb23 * (ld - spring0_id);
      tb27 = tb23 * p[adr + MAGGI_SPRING_L];
      tb27d = tb23d * p[adr + MAGGI_SPRING_L] + tb23 * pd[adr + MAGGI_SPRING_L];
      lb += tb27;
      lbd += tb27d;
      spring0_ib -= tb27;
      spring0_ibd -= tb27d;
      spring0b[i] += spring0_ib;
      spring0bd[i] += spring0_ibd;
    } else {
      p2 = p[adr + MAGGI_SPRING_L];
      p2d = pd[adr + MAGGI_SPRING_L];
      tb28 = energyb[0];
      tb28d = energybd[0];
      tb29 = tb28 * (l - p2);
      tb29d = tb28d * (l - p2) + tb28 * (ld - p2d);
      pb[adr] += tb29 * (l - p2) * 0.5;
      pbd[adr] += (tb29d * (l - p2) + tb29 * (ld - p2d)) * 0.5;
      tb30 = tb29 * (0.5 * p[adr]);
      tb30d = tb29d * (0.5 * p[adr]) + tb29 * (0.5 * pd[adr]);
      lb += tb30;
      lbd += tb30d;
      p2b = -tb30;
      p2bd = -tb30d;
      tb31 = tb28 * (0.5 * p[adr] * (l - p2));
      tb31d = tb28d * (0.5 * p[adr] * (l - p2)) + tb28 * (0.5 * pd[adr] * (l - p2) + 0.5 * p[adr] *
          (ld - p2d));
      lb += tb31;
      lbd += tb31d;
      p2b -= tb31;
      p2bd -= tb31d;
      pb[adr + MAGGI_SPRING_L] += p2b;
      pbd[adr + MAGGI_SPRING_L] += p2bd;
    }
    t2b = lb * (1.0 / (2.0 * l));
    t2bd = lbd * (1.0 / (2.0 * l)) - lb * (1.0 / (2.0 * l) * (2.0 * ld) / (2.0 * l));
    e0b = t2b * e0;
    e0bd = t2bd * e0 + t2b * e0d;
    e0b += t2b * e0;
    e0bd += t2bd * e0 + t2b * e0d;
    e1b = t2b * e1;
    e1bd = t2bd * e1 + t2b * e1d;
    e1b += t2b * e1;
    e1bd += t2bd * e1 + t2b * e1d;
    e2_2b = t2b * e2_2;
    e2_2bd = t2bd * e2_2 + t2b * e2_2d;
    e2_2b += t2b * e2_2;
    e2_2bd += t2bd * e2_2 + t2b * e2_2d;
    rb[a2][2] += e2_2b;
    rbd[a2][2] += e2_2bd;
    rb[b2][2] -= e2_2b;
    rbd[b2][2] -= e2_2bd;
    rb[a2][1] += e1b;
    rbd[a2][1] += e1bd;
    rb[b2][1] -= e1b;
    rbd[b2][1] -= e1bd;
    rb[a2][0] += e0b;
    rbd[a2][0] += e0bd;
    rb[b2][0] -= e0b;
    rbd[b2][0] -= e0bd;
  }
  for (i = t->nrod - 1; i >= 0; --i) {
    a = t->rodpa[i];
    b = t->rodpb[i];
    sharea = t->pointbody[a] == t->nbody ? 0.5 : 1.0 / 6.0;
    shareb = t->pointbody[b] == t->nbody ? 0.5 : 1.0 / 6.0;
    p_i = p[t->rodadr[i]];
    p_id = pd[t->rodadr[i]];
    x_nbody0 = x[t->nbody][0];
    x_nbody0d = xd[t->nbody][0];
    x_nbody1 = x[t->nbody][1];
    x_nbody1d = xd[t->nbody][1];
    x_nbody2 = x[t->nbody][2];
    x_nbody2d = xd[t->nbody][2];
    tb18 = energyb[0];
    tb18d = energybd[0];
    tb19 = tb18 * (sharea * (r[a][2] - x_nbody2 + origin[2]) + shareb * (r[b][2] - x_nbody2 +
        origin[2]));
    tb19d = tb18d * (sharea * (r[a][2] - x_nbody2 + origin[2]) + shareb * (r[b][2] - x_nbody2 +
        origin[2])) + tb18 * (sharea * (rd[a][2] - x_nbody2d) + shareb * (rd[b][2] - x_nbody2d));
    p_ib = -(tb19 * p[2]);
    p_ibd = -(tb19d * p[2] + tb19 * pd[2]);
    pb[2] -= tb19 * p_i;
    pbd[2] -= tb19d * p_i + tb19 * p_id;
    tb20 = tb18 * (p_i * p[2]);
    tb20d = tb18d * (p_i * p[2]) + tb18 * (p_id * p[2] + p_i * pd[2]);
    tb21 = tb20 * sharea;
    tb21d = tb20d * sharea;
    rb[a][2] -= tb21;
    rbd[a][2] -= tb21d;
    x_nbody2b = tb21;
    x_nbody2bd = tb21d;
    tb22 = tb20 * shareb;
    tb22d = tb20d * shareb;
    rb[b][2] -= tb22;
    rbd[b][2] -= tb22d;
    x_nbody2b += tb22;
    x_nbody2bd += tb22d;
    xb[t->nbody][2] += x_nbody2b;
    xbd[t->nbody][2] += x_nbody2bd;
    tb13 = energyb[0];
    tb13d = energybd[0];
    tb14 = tb13 * (sharea * (r[a][1] - x_nbody1 + origin[1]) + shareb * (r[b][1] - x_nbody1 +
        origin[1]));
    tb14d = tb13d * (sharea * (r[a][1] - x_nbody1 + origin[1]) + shareb * (r[b][1] - x_nbody1 +
        origin[1])) + tb13 * (sharea * (rd[a][1] - x_nbody1d) + shareb * (rd[b][1] - x_nbody1d));
    p_ib -= tb14 * p[1];
    p_ibd -= tb14d * p[1] + tb14 * pd[1];
    pb[1] -= tb14 * p_i;
    pbd[1] -= tb14d * p_i + tb14 * p_id;
    tb15 = tb13 * (p_i * p[1]);
    tb15d = tb13d * (p_i * p[1]) + tb13 * (p_id * p[1] + p_i * pd[1]);
    tb16 = tb15 * sharea;
    tb16d = tb15d * sharea;
    rb[a][1] -= tb16;
    rbd[a][1] -= tb16d;
    x_nbody1b = tb16;
    x_nbody1bd = tb16d;
    tb17 = tb15 * shareb;
    tb17d = tb15d * shareb;
    rb[b][1] -= tb17;
    rbd[b][1] -= tb17d;
    x_nbody1b += tb17;
    x_nbody1bd += tb17d;
    xb[t->nbody][1] += x_nbody1b;
    xbd[t->nbody][1] += x_nbody1bd;
    tb8 = energyb[0];
    tb8d = energybd[0];
    tb9 = tb8 * (sharea * (r[a][0] - x_nbody0 + origin[0]) + shareb * (r[b][0] - x_nbody0 +
        origin[0]));
    tb9d = tb8d * (sharea * (r[a][0] - x_nbody0 + origin[0]) + shareb * (r[b][0] - x_nbody0 +
        origin[0])) + tb8 * (sharea * (rd[a][0] - x_nbody0d) + shareb * (rd[b][0] - x_nbody0d));
    p_ib -= tb9 * p[0];
    p_ibd -= tb9d * p[0] + tb9 * pd[0];
    pb[0] -= tb9 * p_i;
    pbd[0] -= tb9d * p_i + tb9 * p_id;
    tb10 = tb8 * (p_i * p[0]);
    tb10d = tb8d * (p_i * p[0]) + tb8 * (p_id * p[0] + p_i * pd[0]);
    tb11 = tb10 * sharea;
    tb11d = tb10d * sharea;
    rb[a][0] -= tb11;
    rbd[a][0] -= tb11d;
    x_nbody0b = tb11;
    x_nbody0bd = tb11d;
    tb12 = tb10 * shareb;
    tb12d = tb10d * shareb;
    rb[b][0] -= tb12;
    rbd[b][0] -= tb12d;
    x_nbody0b += tb12;
    x_nbody0bd += tb12d;
    xb[t->nbody][0] += x_nbody0b;
    xbd[t->nbody][0] += x_nbody0bd;
    pb[t->rodadr[i]] += p_ib;
    pbd[t->rodadr[i]] += p_ibd;
  }
  for (i = t->nmassive - 1; i >= 0; --i) {
    k = t->massive[i];
    g0 = p[0];
    g0d = pd[0];
    g1 = p[1];
    g1d = pd[1];
    g2 = p[2];
    g2d = pd[2];
    h00 = body0[k][1];
    h00d = body0d[k][1];
    h01 = body0[k][2];
    h01d = body0d[k][2];
    h02 = body0[k][3];
    h02d = body0d[k][3];
    h0_2 = A[k][0] * h00 + A[k][1] * h01 + A[k][2] * h02;
    h0_2d = Ad[k][0] * h00 + A[k][0] * h00d + (Ad[k][1] * h01 + A[k][1] * h01d) + (Ad[k][2] * h02 +
        A[k][2] * h02d);
    h1 = A[k][3] * h00 + A[k][4] * h01 + A[k][5] * h02;
    h1d = Ad[k][3] * h00 + A[k][3] * h00d + (Ad[k][4] * h01 + A[k][4] * h01d) + (Ad[k][5] * h02 +
        A[k][5] * h02d);
    h2 = A[k][6] * h00 + A[k][7] * h01 + A[k][8] * h02;
    h2d = Ad[k][6] * h00 + A[k][6] * h00d + (Ad[k][7] * h01 + A[k][7] * h01d) + (Ad[k][8] * h02 +
        A[k][8] * h02d);
    e2b = energyb[0];
    e2bd = energybd[0];
    g2b = -(e2b * (body0[k][0] * (x[k][2] - x[t->nbody][2] + origin[2]) + h2));
    g2bd = -(e2bd * (body0[k][0] * (x[k][2] - x[t->nbody][2] + origin[2]) + h2) + e2b *
        (body0d[k][0] * (x[k][2] - x[t->nbody][2] + origin[2]) + body0[k][0] * (xd[k][2] -
        xd[t->nbody][2]) + h2d));
    tb6 = e2b * g2;
    tb6d = e2bd * g2 + e2b * g2d;
    body0b[k][0] -= tb6 * (x[k][2] - x[t->nbody][2] + origin[2]);
    body0bd[k][0] -= tb6d * (x[k][2] - x[t->nbody][2] + origin[2]) + tb6 * (xd[k][2] -
        xd[t->nbody][2]);
    tb7 = tb6 * body0[k][0];
    tb7d = tb6d * body0[k][0] + tb6 * body0d[k][0];
    xb[k][2] -= tb7;
    xbd[k][2] -= tb7d;
    xb[t->nbody][2] += tb7;
    xbd[t->nbody][2] += tb7d;
    h2b = -tb6;
    h2bd = -tb6d;
    g1b = -(e2b * (body0[k][0] * (x[k][1] - x[t->nbody][1] + origin[1]) + h1));
    g1bd = -(e2bd * (body0[k][0] * (x[k][1] - x[t->nbody][1] + origin[1]) + h1) + e2b *
        (body0d[k][0] * (x[k][1] - x[t->nbody][1] + origin[1]) + body0[k][0] * (xd[k][1] -
        xd[t->nbody][1]) + h1d));
    tb4 = e2b * g1;
    tb4d = e2bd * g1 + e2b * g1d;
    body0b[k][0] -= tb4 * (x[k][1] - x[t->nbody][1] + origin[1]);
    body0bd[k][0] -= tb4d * (x[k][1] - x[t->nbody][1] + origin[1]) + tb4 * (xd[k][1] -
        xd[t->nbody][1]);
    tb5 = tb4 * body0[k][0];
    tb5d = tb4d * body0[k][0] + tb4 * body0d[k][0];
    xb[k][1] -= tb5;
    xbd[k][1] -= tb5d;
    xb[t->nbody][1] += tb5;
    xbd[t->nbody][1] += tb5d;
    h1b = -tb4;
    h1bd = -tb4d;
    g0b = -(e2b * (body0[k][0] * (x[k][0] - x[t->nbody][0] + origin[0]) + h0_2));
    g0bd = -(e2bd * (body0[k][0] * (x[k][0] - x[t->nbody][0] + origin[0]) + h0_2) + e2b *
        (body0d[k][0] * (x[k][0] - x[t->nbody][0] + origin[0]) + body0[k][0] * (xd[k][0] -
        xd[t->nbody][0]) + h0_2d));
    tb2 = e2b * g0;
    tb2d = e2bd * g0 + e2b * g0d;
    body0b[k][0] -= tb2 * (x[k][0] - x[t->nbody][0] + origin[0]);
    body0bd[k][0] -= tb2d * (x[k][0] - x[t->nbody][0] + origin[0]) + tb2 * (xd[k][0] -
        xd[t->nbody][0]);
    tb3 = tb2 * body0[k][0];
    tb3d = tb2d * body0[k][0] + tb2 * body0d[k][0];
    xb[k][0] -= tb3;
    xbd[k][0] -= tb3d;
    xb[t->nbody][0] += tb3;
    xbd[t->nbody][0] += tb3d;
    h0_2b = -tb2;
    h0_2bd = -tb2d;
    e2b = 0.0;
    e2bd = 0.0;
    Ab[k][6] += h2b * h00;
    Abd[k][6] += h2bd * h00 + h2b * h00d;
    h00b = h2b * A[k][6];
    h00bd = h2bd * A[k][6] + h2b * Ad[k][6];
    Ab[k][7] += h2b * h01;
    Abd[k][7] += h2bd * h01 + h2b * h01d;
    h01b = h2b * A[k][7];
    h01bd = h2bd * A[k][7] + h2b * Ad[k][7];
    Ab[k][8] += h2b * h02;
    Abd[k][8] += h2bd * h02 + h2b * h02d;
    h02b = h2b * A[k][8];
    h02bd = h2bd * A[k][8] + h2b * Ad[k][8];
    Ab[k][3] += h1b * h00;
    Abd[k][3] += h1bd * h00 + h1b * h00d;
    h00b += h1b * A[k][3];
    h00bd += h1bd * A[k][3] + h1b * Ad[k][3];
    Ab[k][4] += h1b * h01;
    Abd[k][4] += h1bd * h01 + h1b * h01d;
    h01b += h1b * A[k][4];
    h01bd += h1bd * A[k][4] + h1b * Ad[k][4];
    Ab[k][5] += h1b * h02;
    Abd[k][5] += h1bd * h02 + h1b * h02d;
    h02b += h1b * A[k][5];
    h02bd += h1bd * A[k][5] + h1b * Ad[k][5];
    Ab[k][0] += h0_2b * h00;
    Abd[k][0] += h0_2bd * h00 + h0_2b * h00d;
    h00b += h0_2b * A[k][0];
    h00bd += h0_2bd * A[k][0] + h0_2b * Ad[k][0];
    Ab[k][1] += h0_2b * h01;
    Abd[k][1] += h0_2bd * h01 + h0_2b * h01d;
    h01b += h0_2b * A[k][1];
    h01bd += h0_2bd * A[k][1] + h0_2b * Ad[k][1];
    Ab[k][2] += h0_2b * h02;
    Abd[k][2] += h0_2bd * h02 + h0_2b * h02d;
    h02b += h0_2b * A[k][2];
    h02bd += h0_2bd * A[k][2] + h0_2b * Ad[k][2];
    body0b[k][3] += h02b;
    body0bd[k][3] += h02bd;
    body0b[k][2] += h01b;
    body0bd[k][2] += h01bd;
    body0b[k][1] += h00b;
    /* - g.(m (x - x_ground + origin) + A h0) */
    body0bd[k][1] += h00bd;
    pb[2] += g2b;
    pbd[2] += g2bd;
    pb[1] += g1b;
    pbd[1] += g1bd;
    pb[0] += g0b;
    /* p begins with gravity */
    pbd[0] += g0bd;
  }
  energyb[0] = 0.0;
  energybd[0] = 0.0;
}
