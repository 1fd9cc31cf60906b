/* Tangent of core/kernel/energy.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* T = sum Z.(I Z) / 2 + sum over rods m v_a.v_b / 6 */
void maggi_kinetic_energy_d(const maggi_topo *t, const double p[restrict t->np],
                            const double pd[restrict t->np], const double I[restrict t->nbody][10],
                            const double Id[restrict t->nbody][10],
                            const double Z[restrict t->nbody + 1][6],
                            const double Zd[restrict t->nbody + 1][6],
                            const double rv[restrict t->npoint][3],
                            const double rvd[restrict t->npoint][3], double energy[restrict 1],
                            double energyd[restrict 1])
{
  int i, k;
  double H0, H0d, H1, H1d, H2, H2d, H3, H3d, H4, H4d, H5, H5d;

  (void)energy;
  energyd[0] = 0.0;
  for (i = 0; i < t->nmassive; ++i) {
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
    energyd[0] += 0.5 * (H0d * Z[k][0] + H0 * Zd[k][0] + (H1d * Z[k][1] + H1 * Zd[k][1]) + (H2d *
        Z[k][2] + H2 * Zd[k][2]) + (H3d * Z[k][3] + H3 * Zd[k][3] + (H4d * Z[k][4] + H4 * Zd[k][4])
        + (H5d * Z[k][5] + H5 * Zd[k][5])));
  }
  for (i = 0; i < t->nrod; ++i) {
    energyd[0] += pd[t->rodadr[i]] / 6.0 * (rv[t->rodpa[i]][0] * rv[t->rodpb[i]][0] +
        rv[t->rodpa[i]][1] * rv[t->rodpb[i]][1] + rv[t->rodpa[i]][2] * rv[t->rodpb[i]][2]) +
        p[t->rodadr[i]] / 6.0 * (rvd[t->rodpa[i]][0] * rv[t->rodpb[i]][0] + rv[t->rodpa[i]][0] *
        rvd[t->rodpb[i]][0] + (rvd[t->rodpa[i]][1] * rv[t->rodpb[i]][1] + rv[t->rodpa[i]][1] *
        rvd[t->rodpb[i]][1]) + (rvd[t->rodpa[i]][2] * rv[t->rodpb[i]][2] + rv[t->rodpa[i]][2] *
        rvd[t->rodpb[i]][2]));
  }
}

void maggi_potential_energy_d(const maggi_topo *t, const double p[restrict t->np],
                              const double pd[restrict t->np], const double origin[restrict 3],
                              const double body0[restrict t->nbody][10],
                              const double body0d[restrict t->nbody][10],
                              const double spring0[restrict t->nspring],
                              const double spring0d[restrict t->nspring],
                              const double q[restrict t->nq], const double qd[restrict t->nq],
                              const double A[restrict t->nbody + 1][9],
                              const double Ad[restrict t->nbody + 1][9],
                              const double x[restrict t->nbody + 1][3],
                              const double xd[restrict t->nbody + 1][3],
                              const double r[restrict t->npoint][3],
                              const double rd[restrict t->npoint][3], double energy[restrict 1],
                              double energyd[restrict 1])
{
  int a, a2, a3, adr, adr2, b, b2, b3, i, k;
  double c, e0, e0d, e1, e1d, e2_2, e2_2d, e2d, g0, g0d, g1, g1d, g2, g2d, h00, h00d, h01, h01d,
      h02, h02d, h0_2, h0_2d, h1, h1d, h2, h2d, l, ld, p2, p2d, p3, p3d, p_i, p_id, sharea, shareb,
      spring0_i, spring0_id, t2, t2d, x_nbody0, x_nbody0d, x_nbody1, x_nbody1d, x_nbody2, x_nbody2d,
      z, zd;

  (void)energy;
  energyd[0] = 0.0;
  for (i = 0; i < t->nmassive; ++i) {
    k = t->massive[i];
    g0 = p[0];
    /* p begins with gravity */
    g0d = pd[0];
    g1 = p[1];
    g1d = pd[1];
    g2 = p[2];
    g2d = pd[2];
    h00 = body0[k][1];
    /* - g.(m (x - x_ground + origin) + A h0) */
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
    e2d = 0.0;
    e2d -= g0d * (body0[k][0] * (x[k][0] - x[t->nbody][0] + origin[0]) + h0_2) + g0 * (body0d[k][0]
        * (x[k][0] - x[t->nbody][0] + origin[0]) + body0[k][0] * (xd[k][0] - xd[t->nbody][0]) +
        h0_2d);
    e2d -= g1d * (body0[k][0] * (x[k][1] - x[t->nbody][1] + origin[1]) + h1) + g1 * (body0d[k][0] *
        (x[k][1] - x[t->nbody][1] + origin[1]) + body0[k][0] * (xd[k][1] - xd[t->nbody][1]) + h1d);
    e2d -= g2d * (body0[k][0] * (x[k][2] - x[t->nbody][2] + origin[2]) + h2) + g2 * (body0d[k][0] *
        (x[k][2] - x[t->nbody][2] + origin[2]) + body0[k][0] * (xd[k][2] - xd[t->nbody][2]) + h2d);
    energyd[0] += e2d;
  }
  for (i = 0; i < t->nrod; ++i) {
    a = t->rodpa[i];
    b = t->rodpb[i];
    /* half of the mass at each end, a third of it in the body there unless that is the ground */
    sharea = t->pointbody[a] == t->nbody ? 0.5 : 1.0 / 6.0;
    shareb = t->pointbody[b] == t->nbody ? 0.5 : 1.0 / 6.0;
    p_i = p[t->rodadr[i]];
    p_id = pd[t->rodadr[i]];
    x_nbody0 = x[t->nbody][0];
    x_nbody0d = xd[t->nbody][0];
    energyd[0] -= (p_id * p[0] + p_i * pd[0]) * (sharea * (r[a][0] - x_nbody0 + origin[0]) + shareb
        * (r[b][0] - x_nbody0 + origin[0])) + p_i * p[0] * (sharea * (rd[a][0] - x_nbody0d) + shareb
        * (rd[b][0] - x_nbody0d));
    x_nbody1 = x[t->nbody][1];
    x_nbody1d = xd[t->nbody][1];
    energyd[0] -= (p_id * p[1] + p_i * pd[1]) * (sharea * (r[a][1] - x_nbody1 + origin[1]) + shareb
        * (r[b][1] - x_nbody1 + origin[1])) + p_i * p[1] * (sharea * (rd[a][1] - x_nbody1d) + shareb
        * (rd[b][1] - x_nbody1d));
    x_nbody2 = x[t->nbody][2];
    x_nbody2d = xd[t->nbody][2];
    energyd[0] -= (p_id * p[2] + p_i * pd[2]) * (sharea * (r[a][2] - x_nbody2 + origin[2]) + shareb
        * (r[b][2] - x_nbody2 + origin[2])) + p_i * p[2] * (sharea * (rd[a][2] - x_nbody2d) + shareb
        * (rd[b][2] - x_nbody2d));
  }
  for (i = 0; i < t->nspring; ++i) {
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
    c = 1.0 / (2.0 * l);
    ld = c * t2d;
    if (t->springpreload[i]) {
      spring0_i = spring0[i];
      spring0_id = spring0d[i];
      energyd[0] += (0.5 * pd[adr] * (l - spring0_i) + 0.5 * p[adr] * (ld - spring0_id)) * (l -
          spring0_i) + 0.5 * p[adr] * (l - spring0_i) * (ld - spring0_id) + (pd[adr +
          MAGGI_SPRING_L] * (l - spring0_i) + p[adr + MAGGI_SPRING_L] * (ld - spring0_id));
    } else {
      p2 = p[adr + MAGGI_SPRING_L];
      p2d = pd[adr + MAGGI_SPRING_L];
      energyd[0] += (0.5 * pd[adr] * (l - p2) + 0.5 * p[adr] * (ld - p2d)) * (l - p2) + 0.5 * p[adr]
          * (l - p2) * (ld - p2d);
    }
  }
  for (i = 0; i < t->njspring; ++i) {
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
    energyd[0] += (0.5 * pd[adr2] * (z - p3) + 0.5 * p[adr2] * (zd - p3d)) * (z - p3) + 0.5 *
        p[adr2] * (z - p3) * (zd - p3d) + (pd[adr2 + MAGGI_JSPRING_PRELOAD] * z + p[adr2 +
        MAGGI_JSPRING_PRELOAD] * zd);
  }
}
