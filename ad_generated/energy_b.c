/* Adjoint of core/kernel/energy.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* T = sum Z.(I Z) / 2 + sum over rods m v_a.v_b / 6 */
void maggi_kinetic_energy_b(const maggi_topo *t, const double p[restrict t->np],
                            double pb[restrict t->np], const double I[restrict t->nbody][10],
                            double Ib[restrict t->nbody][10],
                            const double Z[restrict t->nbody + 1][6],
                            double Zb[restrict t->nbody + 1][6],
                            const double rv[restrict t->npoint][3],
                            double rvb[restrict t->npoint][3], double energy[restrict 1],
                            double energyb[restrict 1])
{
  int i, k;
  double H0, H0b, H1, H1b, H2, H2b, H3, H3b, H4, H4b, H5, H5b, tb2, tb3, tb4, tb5;

  (void)energy;
  for (i = t->nrod - 1; i >= 0; --i) {
    tb4 = energyb[0];
    pb[t->rodadr[i]] += tb4 * (rv[t->rodpa[i]][0] * rv[t->rodpb[i]][0] + rv[t->rodpa[i]][1] *
        rv[t->rodpb[i]][1] + rv[t->rodpa[i]][2] * rv[t->rodpb[i]][2]) / 6.0;
    tb5 = tb4 * (p[t->rodadr[i]] / 6.0);
    rvb[t->rodpa[i]][0] += tb5 * rv[t->rodpb[i]][0];
    rvb[t->rodpb[i]][0] += tb5 * rv[t->rodpa[i]][0];
    rvb[t->rodpa[i]][1] += tb5 * rv[t->rodpb[i]][1];
    rvb[t->rodpb[i]][1] += tb5 * rv[t->rodpa[i]][1];
    rvb[t->rodpa[i]][2] += tb5 * rv[t->rodpb[i]][2];
    rvb[t->rodpb[i]][2] += tb5 * rv[t->rodpa[i]][2];
  }
  for (i = t->nmassive - 1; i >= 0; --i) {
    k = t->massive[i];
    H0 = I[k][0] * Z[k][0] + Z[k][4] * I[k][3] - Z[k][5] * I[k][2];
    H1 = I[k][0] * Z[k][1] + Z[k][5] * I[k][1] - Z[k][3] * I[k][3];
    H2 = I[k][0] * Z[k][2] + Z[k][3] * I[k][2] - Z[k][4] * I[k][1];
    H3 = I[k][2] * Z[k][2] - I[k][3] * Z[k][1] + I[k][4] * Z[k][3] + I[k][7] * Z[k][4] + I[k][8] *
        Z[k][5];
    H4 = I[k][3] * Z[k][0] - I[k][1] * Z[k][2] + I[k][7] * Z[k][3] + I[k][5] * Z[k][4] + I[k][9] *
        Z[k][5];
    H5 = I[k][1] * Z[k][1] - I[k][2] * Z[k][0] + I[k][8] * Z[k][3] + I[k][9] * Z[k][4] + I[k][6] *
        Z[k][5];
    tb2 = energyb[0];
    tb3 = tb2 * 0.5;
    H0b = tb3 * Z[k][0];
    Zb[k][0] += tb3 * H0;
    H1b = tb3 * Z[k][1];
    Zb[k][1] += tb3 * H1;
    H2b = tb3 * Z[k][2];
    Zb[k][2] += tb3 * H2;
    H3b = tb3 * Z[k][3];
    Zb[k][3] += tb3 * H3;
    H4b = tb3 * Z[k][4];
    Zb[k][4] += tb3 * H4;
    H5b = tb3 * Z[k][5];
    Zb[k][5] += tb3 * H5;
    Ib[k][1] += H5b * Z[k][1];
    Zb[k][1] += H5b * I[k][1];
    Ib[k][2] -= H5b * Z[k][0];
    Zb[k][0] -= H5b * I[k][2];
    Ib[k][8] += H5b * Z[k][3];
    Zb[k][3] += H5b * I[k][8];
    Ib[k][9] += H5b * Z[k][4];
    Zb[k][4] += H5b * I[k][9];
    Ib[k][6] += H5b * Z[k][5];
    Zb[k][5] += H5b * I[k][6];
    Ib[k][3] += H4b * Z[k][0];
    Zb[k][0] += H4b * I[k][3];
    Ib[k][1] -= H4b * Z[k][2];
    Zb[k][2] -= H4b * I[k][1];
    Ib[k][7] += H4b * Z[k][3];
    Zb[k][3] += H4b * I[k][7];
    Ib[k][5] += H4b * Z[k][4];
    Zb[k][4] += H4b * I[k][5];
    Ib[k][9] += H4b * Z[k][5];
    Zb[k][5] += H4b * I[k][9];
    Ib[k][2] += H3b * Z[k][2];
    Zb[k][2] += H3b * I[k][2];
    Ib[k][3] -= H3b * Z[k][1];
    Zb[k][1] -= H3b * I[k][3];
    Ib[k][4] += H3b * Z[k][3];
    Zb[k][3] += H3b * I[k][4];
    Ib[k][7] += H3b * Z[k][4];
    Zb[k][4] += H3b * I[k][7];
    Ib[k][8] += H3b * Z[k][5];
    Zb[k][5] += H3b * I[k][8];
    Ib[k][0] += H2b * Z[k][2];
    Zb[k][2] += H2b * I[k][0];
    Zb[k][3] += H2b * I[k][2];
    Ib[k][2] += H2b * Z[k][3];
    Zb[k][4] -= H2b * I[k][1];
    Ib[k][1] -= H2b * Z[k][4];
    Ib[k][0] += H1b * Z[k][1];
    Zb[k][1] += H1b * I[k][0];
    Zb[k][5] += H1b * I[k][1];
    Ib[k][1] += H1b * Z[k][5];
    Zb[k][3] -= H1b * I[k][3];
    Ib[k][3] -= H1b * Z[k][3];
    Ib[k][0] += H0b * Z[k][0];
    Zb[k][0] += H0b * I[k][0];
    Zb[k][4] += H0b * I[k][3];
    Ib[k][3] += H0b * Z[k][4];
    Zb[k][5] -= H0b * I[k][2];
    Ib[k][2] -= H0b * Z[k][5];
  }
  energyb[0] = 0.0;
}

void maggi_potential_energy_b(const maggi_topo *t, const double p[restrict t->np],
                              double pb[restrict t->np], const double origin[restrict 3],
                              const double body0[restrict t->nbody][10],
                              double body0b[restrict t->nbody][10],
                              const double spring0[restrict t->nspring],
                              double spring0b[restrict t->nspring], const double q[restrict t->nq],
                              double qb[restrict t->nq], const double A[restrict t->nbody + 1][9],
                              double Ab[restrict t->nbody + 1][9],
                              const double x[restrict t->nbody + 1][3],
                              double xb[restrict t->nbody + 1][3],
                              const double r[restrict t->npoint][3],
                              double rb[restrict t->npoint][3], double energy[restrict 1],
                              double energyb[restrict 1])
{
  int a, a2, a3, adr, adr2, b, b2, b3, i, k;
  double e0, e0b, e1, e1b, e2_2, e2_2b, e2b, g0, g0b, g1, g1b, g2, g2b, h00, h00b, h01, h01b, h02,
      h02b, h0_2, h0_2b, h1, h1b, h2, h2b, l, lb, p2, p2b, p3, p3b, p_i, p_ib, sharea, shareb,
      spring0_i, spring0_ib, t2, t2b, tb10, tb11, tb12, tb13, tb14, tb15, tb16, tb17, tb18, tb19,
      tb2, tb20, tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3, tb30, tb31, tb32, tb33,
      tb34, tb35, tb4, tb5, tb6, tb7, tb8, tb9, x_nbody0, x_nbody0b, x_nbody1, x_nbody1b, x_nbody2,
      x_nbody2b, z, zb;

  (void)energy;
  for (i = t->njspring - 1; i >= 0; --i) {
    a3 = t->jspringq[i];
    b3 = t->jspringq2[i];
    adr2 = t->jspringadr[i];
    if (b3 >= 0) {
      z = q[a3] - q[b3];
    } else {
      z = q[a3];
    }
    p3 = p[adr2 + MAGGI_JSPRING_REST];
    tb32 = energyb[0];
    tb33 = tb32 * (z - p3);
    pb[adr2] += tb33 * (z - p3) * 0.5;
    tb34 = tb33 * (0.5 * p[adr2]);
    zb = tb34;
    p3b = -tb34;
    tb35 = tb32 * (0.5 * p[adr2] * (z - p3));
    zb += tb35;
    p3b -= tb35;
    pb[adr2 + MAGGI_JSPRING_PRELOAD] += tb32 * z;
    zb += tb32 * p[adr2 + MAGGI_JSPRING_PRELOAD];
    pb[adr2 + MAGGI_JSPRING_REST] += p3b;
    if (b3 >= 0) {
      qb[a3] += zb;
      qb[b3] -= zb;
      zb = 0.0;
    } else {
      qb[a3] += zb;
      zb = 0.0;
    }
  }
  for (i = t->nspring - 1; i >= 0; --i) {
    a2 = t->springpa[i];
    b2 = t->springpb[i];
    adr = t->springadr[i];
    e0 = r[a2][0] - r[b2][0];
    e1 = r[a2][1] - r[b2][1];
    e2_2 = r[a2][2] - r[b2][2];
    t2 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
    l = sqrt(t2);
    lb = 0.0;
    if (t->springpreload[i]) {
      spring0_i = spring0[i];
      tb23 = energyb[0];
      tb24 = tb23 * (l - spring0_i);
      pb[adr] += tb24 * (l - spring0_i) * 0.5;
      tb25 = tb24 * (0.5 * p[adr]);
      lb += tb25;
      spring0_ib = -tb25;
      tb26 = tb23 * (0.5 * p[adr] * (l - spring0_i));
      lb += tb26;
      spring0_ib -= tb26;
      pb[adr + MAGGI_SPRING_L] += tb23 * (l - spring0_i);
      tb27 = tb23 * p[adr + MAGGI_SPRING_L];
      lb += tb27;
      spring0_ib -= tb27;
      spring0b[i] += spring0_ib;
    } else {
      p2 = p[adr + MAGGI_SPRING_L];
      tb28 = energyb[0];
      tb29 = tb28 * (l - p2);
      pb[adr] += tb29 * (l - p2) * 0.5;
      tb30 = tb29 * (0.5 * p[adr]);
      lb += tb30;
      p2b = -tb30;
      tb31 = tb28 * (0.5 * p[adr] * (l - p2));
      lb += tb31;
      p2b -= tb31;
      pb[adr + MAGGI_SPRING_L] += p2b;
    }
    t2b = lb * (1.0 / (2.0 * l));
    e0b = t2b * e0;
    e0b += t2b * e0;
    e1b = t2b * e1;
    e1b += t2b * e1;
    e2_2b = t2b * e2_2;
    e2_2b += t2b * e2_2;
    rb[a2][2] += e2_2b;
    rb[b2][2] -= e2_2b;
    rb[a2][1] += e1b;
    rb[b2][1] -= e1b;
    rb[a2][0] += e0b;
    rb[b2][0] -= e0b;
  }
  for (i = t->nrod - 1; i >= 0; --i) {
    a = t->rodpa[i];
    b = t->rodpb[i];
    sharea = t->pointbody[a] == t->nbody ? 0.5 : 1.0 / 6.0;
    shareb = t->pointbody[b] == t->nbody ? 0.5 : 1.0 / 6.0;
    p_i = p[t->rodadr[i]];
    x_nbody0 = x[t->nbody][0];
    x_nbody1 = x[t->nbody][1];
    x_nbody2 = x[t->nbody][2];
    tb18 = energyb[0];
    tb19 = tb18 * (sharea * (r[a][2] - x_nbody2 + origin[2]) + shareb * (r[b][2] - x_nbody2 +
        origin[2]));
    p_ib = -(tb19 * p[2]);
    pb[2] -= tb19 * p_i;
    tb20 = tb18 * (p_i * p[2]);
    tb21 = tb20 * sharea;
    rb[a][2] -= tb21;
    x_nbody2b = tb21;
    tb22 = tb20 * shareb;
    rb[b][2] -= tb22;
    x_nbody2b += tb22;
    xb[t->nbody][2] += x_nbody2b;
    tb13 = energyb[0];
    tb14 = tb13 * (sharea * (r[a][1] - x_nbody1 + origin[1]) + shareb * (r[b][1] - x_nbody1 +
        origin[1]));
    p_ib -= tb14 * p[1];
    pb[1] -= tb14 * p_i;
    tb15 = tb13 * (p_i * p[1]);
    tb16 = tb15 * sharea;
    rb[a][1] -= tb16;
    x_nbody1b = tb16;
    tb17 = tb15 * shareb;
    rb[b][1] -= tb17;
    x_nbody1b += tb17;
    xb[t->nbody][1] += x_nbody1b;
    tb8 = energyb[0];
    tb9 = tb8 * (sharea * (r[a][0] - x_nbody0 + origin[0]) + shareb * (r[b][0] - x_nbody0 +
        origin[0]));
    p_ib -= tb9 * p[0];
    pb[0] -= tb9 * p_i;
    tb10 = tb8 * (p_i * p[0]);
    tb11 = tb10 * sharea;
    rb[a][0] -= tb11;
    x_nbody0b = tb11;
    tb12 = tb10 * shareb;
    rb[b][0] -= tb12;
    x_nbody0b += tb12;
    xb[t->nbody][0] += x_nbody0b;
    pb[t->rodadr[i]] += p_ib;
  }
  for (i = t->nmassive - 1; i >= 0; --i) {
    k = t->massive[i];
    g0 = p[0];
    g1 = p[1];
    g2 = p[2];
    h00 = body0[k][1];
    h01 = body0[k][2];
    h02 = body0[k][3];
    h0_2 = A[k][0] * h00 + A[k][1] * h01 + A[k][2] * h02;
    h1 = A[k][3] * h00 + A[k][4] * h01 + A[k][5] * h02;
    h2 = A[k][6] * h00 + A[k][7] * h01 + A[k][8] * h02;
    e2b = energyb[0];
    g2b = -(e2b * (body0[k][0] * (x[k][2] - x[t->nbody][2] + origin[2]) + h2));
    tb6 = e2b * g2;
    body0b[k][0] -= tb6 * (x[k][2] - x[t->nbody][2] + origin[2]);
    tb7 = tb6 * body0[k][0];
    xb[k][2] -= tb7;
    xb[t->nbody][2] += tb7;
    h2b = -tb6;
    g1b = -(e2b * (body0[k][0] * (x[k][1] - x[t->nbody][1] + origin[1]) + h1));
    tb4 = e2b * g1;
    body0b[k][0] -= tb4 * (x[k][1] - x[t->nbody][1] + origin[1]);
    tb5 = tb4 * body0[k][0];
    xb[k][1] -= tb5;
    xb[t->nbody][1] += tb5;
    h1b = -tb4;
    g0b = -(e2b * (body0[k][0] * (x[k][0] - x[t->nbody][0] + origin[0]) + h0_2));
    tb2 = e2b * g0;
    body0b[k][0] -= tb2 * (x[k][0] - x[t->nbody][0] + origin[0]);
    tb3 = tb2 * body0[k][0];
    xb[k][0] -= tb3;
    xb[t->nbody][0] += tb3;
    h0_2b = -tb2;
    e2b = 0.0;
    Ab[k][6] += h2b * h00;
    h00b = h2b * A[k][6];
    Ab[k][7] += h2b * h01;
    h01b = h2b * A[k][7];
    Ab[k][8] += h2b * h02;
    h02b = h2b * A[k][8];
    Ab[k][3] += h1b * h00;
    h00b += h1b * A[k][3];
    Ab[k][4] += h1b * h01;
    h01b += h1b * A[k][4];
    Ab[k][5] += h1b * h02;
    h02b += h1b * A[k][5];
    Ab[k][0] += h0_2b * h00;
    h00b += h0_2b * A[k][0];
    Ab[k][1] += h0_2b * h01;
    h01b += h0_2b * A[k][1];
    Ab[k][2] += h0_2b * h02;
    h02b += h0_2b * A[k][2];
    body0b[k][3] += h02b;
    body0b[k][2] += h01b;
    /* - g.(m (x - x_ground + origin) + A h0) */
    body0b[k][1] += h00b;
    pb[2] += g2b;
    pb[1] += g1b;
    /* p begins with gravity */
    pb[0] += g0b;
  }
  energyb[0] = 0.0;
}
