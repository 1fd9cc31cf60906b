/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/energy.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* T = sum Z.(I Z) / 2 + sum over rods m v_a.v_b / 6 */
void maggi_kinetic_energy_dv(const maggi_topo *t, const double p[restrict t->np],
                             const double pd[restrict t->np][MAGGI_NDIR],
                             const double I[restrict t->nbody][10],
                             const double Id[restrict t->nbody][10][MAGGI_NDIR],
                             const double Z[restrict t->nbody + 1][6],
                             const double Zd[restrict t->nbody + 1][6][MAGGI_NDIR],
                             const double rv[restrict t->npoint][3],
                             const double rvd[restrict t->npoint][3][MAGGI_NDIR],
                             double energy[restrict 1], double energyd[restrict 1][MAGGI_NDIR],
                             int nbdirs)
{
  int i, k, nd;
  double H0, H1, H2, H3, H4, H5;

  (void)energy;
  (void)nbdirs;
#pragma omp simd
  for (nd = 0; nd < MAGGI_NDIR; ++nd) {
    energyd[0][nd] = 0.0;
  }
  for (i = 0; i < t->nmassive; ++i) {
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
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double H0d, H1d, H2d, H3d, H4d, H5d;

      H0d = Id[k][0][nd] * Z[k][0] + I[k][0] * Zd[k][0][nd] + (Zd[k][4][nd] * I[k][3] + Z[k][4] *
          Id[k][3][nd]) - (Zd[k][5][nd] * I[k][2] + Z[k][5] * Id[k][2][nd]);
      H1d = Id[k][0][nd] * Z[k][1] + I[k][0] * Zd[k][1][nd] + (Zd[k][5][nd] * I[k][1] + Z[k][5] *
          Id[k][1][nd]) - (Zd[k][3][nd] * I[k][3] + Z[k][3] * Id[k][3][nd]);
      H2d = Id[k][0][nd] * Z[k][2] + I[k][0] * Zd[k][2][nd] + (Zd[k][3][nd] * I[k][2] + Z[k][3] *
          Id[k][2][nd]) - (Zd[k][4][nd] * I[k][1] + Z[k][4] * Id[k][1][nd]);
      H3d = Id[k][2][nd] * Z[k][2] + I[k][2] * Zd[k][2][nd] - (Id[k][3][nd] * Z[k][1] + I[k][3] *
          Zd[k][1][nd]) + (Id[k][4][nd] * Z[k][3] + I[k][4] * Zd[k][3][nd]) + (Id[k][7][nd] *
          Z[k][4] + I[k][7] * Zd[k][4][nd]) + (Id[k][8][nd] * Z[k][5] + I[k][8] * Zd[k][5][nd]);
      H4d = Id[k][3][nd] * Z[k][0] + I[k][3] * Zd[k][0][nd] - (Id[k][1][nd] * Z[k][2] + I[k][1] *
          Zd[k][2][nd]) + (Id[k][7][nd] * Z[k][3] + I[k][7] * Zd[k][3][nd]) + (Id[k][5][nd] *
          Z[k][4] + I[k][5] * Zd[k][4][nd]) + (Id[k][9][nd] * Z[k][5] + I[k][9] * Zd[k][5][nd]);
      H5d = Id[k][1][nd] * Z[k][1] + I[k][1] * Zd[k][1][nd] - (Id[k][2][nd] * Z[k][0] + I[k][2] *
          Zd[k][0][nd]) + (Id[k][8][nd] * Z[k][3] + I[k][8] * Zd[k][3][nd]) + (Id[k][9][nd] *
          Z[k][4] + I[k][9] * Zd[k][4][nd]) + (Id[k][6][nd] * Z[k][5] + I[k][6] * Zd[k][5][nd]);
      energyd[0][nd] += 0.5 * (H0d * Z[k][0] + H0 * Zd[k][0][nd] + (H1d * Z[k][1] + H1 *
          Zd[k][1][nd]) + (H2d * Z[k][2] + H2 * Zd[k][2][nd]) + (H3d * Z[k][3] + H3 * Zd[k][3][nd] +
          (H4d * Z[k][4] + H4 * Zd[k][4][nd]) + (H5d * Z[k][5] + H5 * Zd[k][5][nd])));
    }
  }
  for (i = 0; i < t->nrod; ++i) {
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      energyd[0][nd] += pd[t->rodadr[i]][nd] / 6.0 * (rv[t->rodpa[i]][0] * rv[t->rodpb[i]][0] +
          rv[t->rodpa[i]][1] * rv[t->rodpb[i]][1] + rv[t->rodpa[i]][2] * rv[t->rodpb[i]][2]) +
          p[t->rodadr[i]] / 6.0 * (rvd[t->rodpa[i]][0][nd] * rv[t->rodpb[i]][0] + rv[t->rodpa[i]][0]
          * rvd[t->rodpb[i]][0][nd] + (rvd[t->rodpa[i]][1][nd] * rv[t->rodpb[i]][1] +
          rv[t->rodpa[i]][1] * rvd[t->rodpb[i]][1][nd]) + (rvd[t->rodpa[i]][2][nd] *
          rv[t->rodpb[i]][2] + rv[t->rodpa[i]][2] * rvd[t->rodpb[i]][2][nd]));
    }
  }
}

void maggi_potential_energy_dv(const maggi_topo *t, const double p[restrict t->np],
                               const double pd[restrict t->np][MAGGI_NDIR],
                               const double origin[restrict 3],
                               const double body0[restrict t->nbody][10],
                               const double body0d[restrict t->nbody][10][MAGGI_NDIR],
                               const double spring0[restrict t->nspring],
                               const double spring0d[restrict t->nspring][MAGGI_NDIR],
                               const double q[restrict t->nq],
                               const double qd[restrict t->nq][MAGGI_NDIR],
                               const double A[restrict t->nbody + 1][9],
                               const double Ad[restrict t->nbody + 1][9][MAGGI_NDIR],
                               const double x[restrict t->nbody + 1][3],
                               const double xd[restrict t->nbody + 1][3][MAGGI_NDIR],
                               const double r[restrict t->npoint][3],
                               const double rd[restrict t->npoint][3][MAGGI_NDIR],
                               double energy[restrict 1], double energyd[restrict 1][MAGGI_NDIR],
                               int nbdirs)
{
  int a, a2, a3, adr, adr2, b, b2, b3, i, k, nd;
  double c, e0, e1, e2_2, g0, g1, g2, h00, h01, h02, h0_2, h1, h2, l, p2, p3, p_i, sharea, shareb,
      spring0_i, t2, x_nbody0, x_nbody1, x_nbody2, z;
  double ld[MAGGI_NDIR], zd[MAGGI_NDIR];

  (void)energy;
  (void)nbdirs;
#pragma omp simd
  for (nd = 0; nd < MAGGI_NDIR; ++nd) {
    energyd[0][nd] = 0.0;
  }
  for (i = 0; i < t->nmassive; ++i) {
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
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double e2d, g0d, g1d, g2d, h00d, h01d, h02d, h0_2d, h1d, h2d;

      /* p begins with gravity */
      g0d = pd[0][nd];
      g1d = pd[1][nd];
      g2d = pd[2][nd];
      /* - g.(m (x - x_ground + origin) + A h0) */
      h00d = body0d[k][1][nd];
      h01d = body0d[k][2][nd];
      h02d = body0d[k][3][nd];
      h0_2d = Ad[k][0][nd] * h00 + A[k][0] * h00d + (Ad[k][1][nd] * h01 + A[k][1] * h01d) +
          (Ad[k][2][nd] * h02 + A[k][2] * h02d);
      h1d = Ad[k][3][nd] * h00 + A[k][3] * h00d + (Ad[k][4][nd] * h01 + A[k][4] * h01d) +
          (Ad[k][5][nd] * h02 + A[k][5] * h02d);
      h2d = Ad[k][6][nd] * h00 + A[k][6] * h00d + (Ad[k][7][nd] * h01 + A[k][7] * h01d) +
          (Ad[k][8][nd] * h02 + A[k][8] * h02d);
      e2d = 0.0;
      e2d -= g0d * (body0[k][0] * (x[k][0] - x[t->nbody][0] + origin[0]) + h0_2) + g0 *
          (body0d[k][0][nd] * (x[k][0] - x[t->nbody][0] + origin[0]) + body0[k][0] * (xd[k][0][nd] -
          xd[t->nbody][0][nd]) + h0_2d);
      e2d -= g1d * (body0[k][0] * (x[k][1] - x[t->nbody][1] + origin[1]) + h1) + g1 *
          (body0d[k][0][nd] * (x[k][1] - x[t->nbody][1] + origin[1]) + body0[k][0] * (xd[k][1][nd] -
          xd[t->nbody][1][nd]) + h1d);
      e2d -= g2d * (body0[k][0] * (x[k][2] - x[t->nbody][2] + origin[2]) + h2) + g2 *
          (body0d[k][0][nd] * (x[k][2] - x[t->nbody][2] + origin[2]) + body0[k][0] * (xd[k][2][nd] -
          xd[t->nbody][2][nd]) + h2d);
      energyd[0][nd] += e2d;
    }
  }
  for (i = 0; i < t->nrod; ++i) {
    a = t->rodpa[i];
    b = t->rodpb[i];
    /* half of the mass at each end, a third of it in the body there unless that is the ground */
    sharea = t->pointbody[a] == t->nbody ? 0.5 : 1.0 / 6.0;
    shareb = t->pointbody[b] == t->nbody ? 0.5 : 1.0 / 6.0;
    p_i = p[t->rodadr[i]];
    x_nbody0 = x[t->nbody][0];
    x_nbody1 = x[t->nbody][1];
    x_nbody2 = x[t->nbody][2];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double p_id, x_nbody0d, x_nbody1d, x_nbody2d;

      p_id = pd[t->rodadr[i]][nd];
      x_nbody0d = xd[t->nbody][0][nd];
      energyd[0][nd] -= (p_id * p[0] + p_i * pd[0][nd]) * (sharea * (r[a][0] - x_nbody0 + origin[0])
          + shareb * (r[b][0] - x_nbody0 + origin[0])) + p_i * p[0] * (sharea * (rd[a][0][nd] -
          x_nbody0d) + shareb * (rd[b][0][nd] - x_nbody0d));
      x_nbody1d = xd[t->nbody][1][nd];
      energyd[0][nd] -= (p_id * p[1] + p_i * pd[1][nd]) * (sharea * (r[a][1] - x_nbody1 + origin[1])
          + shareb * (r[b][1] - x_nbody1 + origin[1])) + p_i * p[1] * (sharea * (rd[a][1][nd] -
          x_nbody1d) + shareb * (rd[b][1][nd] - x_nbody1d));
      x_nbody2d = xd[t->nbody][2][nd];
      energyd[0][nd] -= (p_id * p[2] + p_i * pd[2][nd]) * (sharea * (r[a][2] - x_nbody2 + origin[2])
          + shareb * (r[b][2] - x_nbody2 + origin[2])) + p_i * p[2] * (sharea * (rd[a][2][nd] -
          x_nbody2d) + shareb * (rd[b][2][nd] - x_nbody2d));
    }
  }
  for (i = 0; i < t->nspring; ++i) {
    a2 = t->springpa[i];
    b2 = t->springpb[i];
    adr = t->springadr[i];
    e0 = r[a2][0] - r[b2][0];
    e1 = r[a2][1] - r[b2][1];
    e2_2 = r[a2][2] - r[b2][2];
    t2 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
    l = sqrt(t2);
    c = 1.0 / (2.0 * l);
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double e0d, e1d, e2_2d, t2d;

      e0d = rd[a2][0][nd] - rd[b2][0][nd];
      e1d = rd[a2][1][nd] - rd[b2][1][nd];
      e2_2d = rd[a2][2][nd] - rd[b2][2][nd];
      t2d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
      ld[nd] = c * t2d;
    }
    if (t->springpreload[i]) {
      spring0_i = spring0[i];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double spring0_id;

        spring0_id = spring0d[i][nd];
        energyd[0][nd] += (0.5 * pd[adr][nd] * (l - spring0_i) + 0.5 * p[adr] * (ld[nd] -
            spring0_id)) * (l - spring0_i) + 0.5 * p[adr] * (l - spring0_i) * (ld[nd] - spring0_id)
            + (pd[adr + MAGGI_SPRING_L][nd] * (l - spring0_i) + p[adr + MAGGI_SPRING_L] * (ld[nd] -
            spring0_id));
      }
    } else {
      p2 = p[adr + MAGGI_SPRING_L];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p2d;

        p2d = pd[adr + MAGGI_SPRING_L][nd];
        energyd[0][nd] += (0.5 * pd[adr][nd] * (l - p2) + 0.5 * p[adr] * (ld[nd] - p2d)) * (l - p2)
            + 0.5 * p[adr] * (l - p2) * (ld[nd] - p2d);
      }
    }
  }
  for (i = 0; i < t->njspring; ++i) {
    a3 = t->jspringq[i];
    b3 = t->jspringq2[i];
    adr2 = t->jspringadr[i];
    if (b3 >= 0) {
      z = q[a3] - q[b3];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        zd[nd] = qd[a3][nd] - qd[b3][nd];
      }
    } else {
      z = q[a3];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        zd[nd] = qd[a3][nd];
      }
    }
    p3 = p[adr2 + MAGGI_JSPRING_REST];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double p3d;

      p3d = pd[adr2 + MAGGI_JSPRING_REST][nd];
      energyd[0][nd] += (0.5 * pd[adr2][nd] * (z - p3) + 0.5 * p[adr2] * (zd[nd] - p3d)) * (z - p3)
          + 0.5 * p[adr2] * (z - p3) * (zd[nd] - p3d) + (pd[adr2 + MAGGI_JSPRING_PRELOAD][nd] * z +
          p[adr2 + MAGGI_JSPRING_PRELOAD] * zd[nd]);
    }
  }
}
