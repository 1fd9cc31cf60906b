/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/position.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* joints that do not turn leave their row of turn alone */
void maggi_positions_dv(const maggi_topo *t, const double offset0[restrict t->nbody][3],
                        const double offset0d[restrict t->nbody][3][MAGGI_NDIR],
                        const double axis0[restrict t->nbody][3],
                        const double axis0d[restrict t->nbody][3][MAGGI_NDIR],
                        const double q[restrict t->nq], const double qd[restrict t->nq][MAGGI_NDIR],
                        double turn[restrict t->nbody][2],
                        double turnd[restrict t->nbody][2][MAGGI_NDIR],
                        double A[restrict t->nbody + 1][9],
                        double Ad[restrict t->nbody + 1][9][MAGGI_NDIR],
                        double x[restrict t->nbody + 1][3],
                        double xd[restrict t->nbody + 1][3][MAGGI_NDIR],
                        double b[restrict t->nbody][6], double bd[restrict t->nbody][6][MAGGI_NDIR],
                        int nbdirs)
{
  int i, k, k3, k4, nd, up;
  double A_up0, A_up0_2, A_up1, A_up1_2, A_up2, A_up2_2, A_up3, A_up3_2, A_up4, A_up4_2, A_up5,
      A_up5_2, A_up6, A_up6_2, A_up7, A_up7_2, A_up8, A_up8_2, R0, R1, R2, R3, R4, R5, R6, R7, R8,
      axis0_i0, axis0_i0_2, axis0_i1, axis0_i1_2, axis0_i2, axis0_i2_2, e0, e1, e2_2, offset0_i0,
      offset0_i0_2, offset0_i0_3, offset0_i1, offset0_i1_2, offset0_i1_3, offset0_i2, offset0_i2_2,
      offset0_i2_3, q_i, q_i2, turn_i0, turn_i1, u0, u1, u20, u21, u22, u2_2, v, vx, vy, vz, xi0,
      xi1, xi2;
  double e20d[MAGGI_NDIR], e21d[MAGGI_NDIR], e22d[MAGGI_NDIR], e30d[MAGGI_NDIR], e31d[MAGGI_NDIR],
      e32d[MAGGI_NDIR], u20d[MAGGI_NDIR], u21d[MAGGI_NDIR], u22d[MAGGI_NDIR];

  (void)nbdirs;
  for (k = 0; k < 9; ++k) {
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      Ad[t->nbody][k][nd] = 0.0;
    }
  }
#pragma omp simd
  for (nd = 0; nd < MAGGI_NDIR; ++nd) {
    xd[t->nbody][0][nd] = 0.0;
    xd[t->nbody][1][nd] = 0.0;
    xd[t->nbody][2][nd] = 0.0;
  }
  for (i = 0; i < t->nbase; ++i) {
    q_i = q[t->qid[t->base[i]]];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double q_id;

      q_id = qd[t->qid[t->base[i]]][nd];
      xd[t->nbody][0][nd] -= axis0d[t->base[i]][0][nd] * q_i + axis0[t->base[i]][0] * q_id;
      xd[t->nbody][1][nd] -= axis0d[t->base[i]][1][nd] * q_i + axis0[t->base[i]][1] * q_id;
      xd[t->nbody][2][nd] -= axis0d[t->base[i]][2][nd] * q_i + axis0[t->base[i]][2] * q_id;
    }
  }
  for (i = t->nbody - 1; i >= 0; --i) {
    up = t->parent[i];
    if (t->joint[i] == MAGGI_ONE_REVOLUTE) {
      turn_i0 = turn[i][0];
      turn_i1 = turn[i][1];
      A_up0 = A[up][0];
      offset0_i0 = offset0[i][0];
      A_up1 = A[up][1];
      offset0_i1 = offset0[i][1];
      A_up2 = A[up][2];
      offset0_i2 = offset0[i][2];
      e0 = A_up0 * offset0_i0 + A_up1 * offset0_i1 + A_up2 * offset0_i2;
      A_up3 = A[up][3];
      A_up4 = A[up][4];
      A_up5 = A[up][5];
      e1 = A_up3 * offset0_i0 + A_up4 * offset0_i1 + A_up5 * offset0_i2;
      A_up6 = A[up][6];
      A_up7 = A[up][7];
      A_up8 = A[up][8];
      e2_2 = A_up6 * offset0_i0 + A_up7 * offset0_i1 + A_up8 * offset0_i2;
      axis0_i0 = axis0[i][0];
      axis0_i1 = axis0[i][1];
      axis0_i2 = axis0[i][2];
      u0 = b[i][3];
      u1 = b[i][4];
      u2_2 = b[i][5];
      xi0 = x[up][0] + e0;
      xi1 = x[up][1] + e1;
      xi2 = x[up][2] + e2_2;
      v = 1.0 - turn_i1;
      vx = v * axis0_i0;
      vy = v * axis0_i1;
      vz = v * axis0_i2;
      R0 = turn_i1 + vx * axis0_i0;
      R1 = vx * axis0_i1 - turn_i0 * axis0_i2;
      R2 = vx * axis0_i2 + turn_i0 * axis0_i1;
      R3 = vx * axis0_i1 + turn_i0 * axis0_i2;
      R4 = turn_i1 + vy * axis0_i1;
      R5 = vy * axis0_i2 - turn_i0 * axis0_i0;
      R6 = vx * axis0_i2 - turn_i0 * axis0_i1;
      R7 = vy * axis0_i2 + turn_i0 * axis0_i0;
      R8 = turn_i1 + vz * axis0_i2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_up0d, A_up1d, A_up2d, A_up3d, A_up4d, A_up5d, A_up6d, A_up7d, A_up8d, R0d, R1d,
            R2d, R3d, R4d, R5d, R6d, R7d, R8d, angled, axis0_i0d, axis0_i1d, axis0_i2d, c0d, c1d,
            c2d, e0d, e1d, e2_2d, offset0_i0d, offset0_i1d, offset0_i2d, turn_i0d, turn_i1d, u0d,
            u1d, u2_2d, vd, vxd, vyd, vzd, xi0d, xi1d, xi2d;

        angled = qd[t->qid[i]][nd];
        turn_i0d = turn[i][1] * angled;
        turnd[i][0][nd] = turn_i0d;
        turn_i1d = -(turn[i][0] * angled);
        turnd[i][1][nd] = turn_i1d;
        A_up0d = Ad[up][0][nd];
        offset0_i0d = offset0d[i][0][nd];
        A_up1d = Ad[up][1][nd];
        offset0_i1d = offset0d[i][1][nd];
        A_up2d = Ad[up][2][nd];
        offset0_i2d = offset0d[i][2][nd];
        /* b = (x × u, u) */
        e0d = A_up0d * offset0_i0 + A_up0 * offset0_i0d + (A_up1d * offset0_i1 + A_up1 *
            offset0_i1d) + (A_up2d * offset0_i2 + A_up2 * offset0_i2d);
        A_up3d = Ad[up][3][nd];
        A_up4d = Ad[up][4][nd];
        A_up5d = Ad[up][5][nd];
        e1d = A_up3d * offset0_i0 + A_up3 * offset0_i0d + (A_up4d * offset0_i1 + A_up4 *
            offset0_i1d) + (A_up5d * offset0_i2 + A_up5 * offset0_i2d);
        A_up6d = Ad[up][6][nd];
        A_up7d = Ad[up][7][nd];
        A_up8d = Ad[up][8][nd];
        e2_2d = A_up6d * offset0_i0 + A_up6 * offset0_i0d + (A_up7d * offset0_i1 + A_up7 *
            offset0_i1d) + (A_up8d * offset0_i2 + A_up8 * offset0_i2d);
        axis0_i0d = axis0d[i][0][nd];
        axis0_i1d = axis0d[i][1][nd];
        axis0_i2d = axis0d[i][2][nd];
        u0d = A_up0d * axis0_i0 + A_up0 * axis0_i0d + (A_up1d * axis0_i1 + A_up1 * axis0_i1d) +
            (A_up2d * axis0_i2 + A_up2 * axis0_i2d);
        u1d = A_up3d * axis0_i0 + A_up3 * axis0_i0d + (A_up4d * axis0_i1 + A_up4 * axis0_i1d) +
            (A_up5d * axis0_i2 + A_up5 * axis0_i2d);
        u2_2d = A_up6d * axis0_i0 + A_up6 * axis0_i0d + (A_up7d * axis0_i1 + A_up7 * axis0_i1d) +
            (A_up8d * axis0_i2 + A_up8 * axis0_i2d);
        xi0d = xd[up][0][nd] + e0d;
        xi1d = xd[up][1][nd] + e1d;
        xi2d = xd[up][2][nd] + e2_2d;
        /* A = Ap Rot(u, q),  Rot = c I + s u~ + (1 - c) u u^T */
        vd = -turn_i1d;
        vxd = vd * axis0_i0 + v * axis0_i0d;
        vyd = vd * axis0_i1 + v * axis0_i1d;
        vzd = vd * axis0_i2 + v * axis0_i2d;
        R0d = turn_i1d + (vxd * axis0_i0 + vx * axis0_i0d);
        R1d = vxd * axis0_i1 + vx * axis0_i1d - (turn_i0d * axis0_i2 + turn_i0 * axis0_i2d);
        R2d = vxd * axis0_i2 + vx * axis0_i2d + (turn_i0d * axis0_i1 + turn_i0 * axis0_i1d);
        R3d = vxd * axis0_i1 + vx * axis0_i1d + (turn_i0d * axis0_i2 + turn_i0 * axis0_i2d);
        R4d = turn_i1d + (vyd * axis0_i1 + vy * axis0_i1d);
        R5d = vyd * axis0_i2 + vy * axis0_i2d - (turn_i0d * axis0_i0 + turn_i0 * axis0_i0d);
        R6d = vxd * axis0_i2 + vx * axis0_i2d - (turn_i0d * axis0_i1 + turn_i0 * axis0_i1d);
        R7d = vyd * axis0_i2 + vy * axis0_i2d + (turn_i0d * axis0_i0 + turn_i0 * axis0_i0d);
        R8d = turn_i1d + (vzd * axis0_i2 + vz * axis0_i2d);
        Ad[i][0][nd] = A_up0d * R0 + A_up0 * R0d + (A_up1d * R3 + A_up1 * R3d) + (A_up2d * R6 +
            A_up2 * R6d);
        Ad[i][1][nd] = A_up0d * R1 + A_up0 * R1d + (A_up1d * R4 + A_up1 * R4d) + (A_up2d * R7 +
            A_up2 * R7d);
        Ad[i][2][nd] = A_up0d * R2 + A_up0 * R2d + (A_up1d * R5 + A_up1 * R5d) + (A_up2d * R8 +
            A_up2 * R8d);
        Ad[i][3][nd] = A_up3d * R0 + A_up3 * R0d + (A_up4d * R3 + A_up4 * R3d) + (A_up5d * R6 +
            A_up5 * R6d);
        Ad[i][4][nd] = A_up3d * R1 + A_up3 * R1d + (A_up4d * R4 + A_up4 * R4d) + (A_up5d * R7 +
            A_up5 * R7d);
        Ad[i][5][nd] = A_up3d * R2 + A_up3 * R2d + (A_up4d * R5 + A_up4 * R5d) + (A_up5d * R8 +
            A_up5 * R8d);
        Ad[i][6][nd] = A_up6d * R0 + A_up6 * R0d + (A_up7d * R3 + A_up7 * R3d) + (A_up8d * R6 +
            A_up8 * R6d);
        Ad[i][7][nd] = A_up6d * R1 + A_up6 * R1d + (A_up7d * R4 + A_up7 * R4d) + (A_up8d * R7 +
            A_up8 * R7d);
        Ad[i][8][nd] = A_up6d * R2 + A_up6 * R2d + (A_up7d * R5 + A_up7 * R5d) + (A_up8d * R8 +
            A_up8 * R8d);
        c0d = xi1d * u2_2 + xi1 * u2_2d - (xi2d * u1 + xi2 * u1d);
        c1d = xi2d * u0 + xi2 * u0d - (xi0d * u2_2 + xi0 * u2_2d);
        c2d = xi0d * u1 + xi0 * u1d - (xi1d * u0 + xi1 * u0d);
        xd[i][0][nd] = xi0d;
        xd[i][1][nd] = xi1d;
        xd[i][2][nd] = xi2d;
        bd[i][0][nd] = c0d;
        bd[i][1][nd] = c1d;
        bd[i][2][nd] = c2d;
        bd[i][3][nd] = u0d;
        bd[i][4][nd] = u1d;
        bd[i][5][nd] = u2_2d;
      }
    } else if (t->joint[i] == MAGGI_ONE_PRISMATIC) {
      A_up0_2 = A[up][0];
      offset0_i0_2 = offset0[i][0];
      A_up1_2 = A[up][1];
      offset0_i1_2 = offset0[i][1];
      A_up2_2 = A[up][2];
      offset0_i2_2 = offset0[i][2];
      A_up3_2 = A[up][3];
      A_up4_2 = A[up][4];
      A_up5_2 = A[up][5];
      A_up6_2 = A[up][6];
      A_up7_2 = A[up][7];
      A_up8_2 = A[up][8];
      axis0_i0_2 = axis0[i][0];
      axis0_i1_2 = axis0[i][1];
      axis0_i2_2 = axis0[i][2];
      u20 = b[i][0];
      u21 = b[i][1];
      u22 = b[i][2];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double A_up0_2d, A_up1_2d, A_up2_2d, A_up3_2d, A_up4_2d, A_up5_2d, A_up6_2d, A_up7_2d,
            A_up8_2d, axis0_i0_2d, axis0_i1_2d, axis0_i2_2d, offset0_i0_2d, offset0_i1_2d,
            offset0_i2_2d;

        A_up0_2d = Ad[up][0][nd];
        offset0_i0_2d = offset0d[i][0][nd];
        A_up1_2d = Ad[up][1][nd];
        offset0_i1_2d = offset0d[i][1][nd];
        A_up2_2d = Ad[up][2][nd];
        offset0_i2_2d = offset0d[i][2][nd];
        /* b = (u, 0) */
        e20d[nd] = A_up0_2d * offset0_i0_2 + A_up0_2 * offset0_i0_2d + (A_up1_2d * offset0_i1_2 +
            A_up1_2 * offset0_i1_2d) + (A_up2_2d * offset0_i2_2 + A_up2_2 * offset0_i2_2d);
        A_up3_2d = Ad[up][3][nd];
        A_up4_2d = Ad[up][4][nd];
        A_up5_2d = Ad[up][5][nd];
        e21d[nd] = A_up3_2d * offset0_i0_2 + A_up3_2 * offset0_i0_2d + (A_up4_2d * offset0_i1_2 +
            A_up4_2 * offset0_i1_2d) + (A_up5_2d * offset0_i2_2 + A_up5_2 * offset0_i2_2d);
        A_up6_2d = Ad[up][6][nd];
        A_up7_2d = Ad[up][7][nd];
        A_up8_2d = Ad[up][8][nd];
        e22d[nd] = A_up6_2d * offset0_i0_2 + A_up6_2 * offset0_i0_2d + (A_up7_2d * offset0_i1_2 +
            A_up7_2 * offset0_i1_2d) + (A_up8_2d * offset0_i2_2 + A_up8_2 * offset0_i2_2d);
        axis0_i0_2d = axis0d[i][0][nd];
        axis0_i1_2d = axis0d[i][1][nd];
        axis0_i2_2d = axis0d[i][2][nd];
        u20d[nd] = A_up0_2d * axis0_i0_2 + A_up0_2 * axis0_i0_2d + (A_up1_2d * axis0_i1_2 + A_up1_2
            * axis0_i1_2d) + (A_up2_2d * axis0_i2_2 + A_up2_2 * axis0_i2_2d);
        u21d[nd] = A_up3_2d * axis0_i0_2 + A_up3_2 * axis0_i0_2d + (A_up4_2d * axis0_i1_2 + A_up4_2
            * axis0_i1_2d) + (A_up5_2d * axis0_i2_2 + A_up5_2 * axis0_i2_2d);
        u22d[nd] = A_up6_2d * axis0_i0_2 + A_up6_2 * axis0_i0_2d + (A_up7_2d * axis0_i1_2 + A_up7_2
            * axis0_i1_2d) + (A_up8_2d * axis0_i2_2 + A_up8_2 * axis0_i2_2d);
      }
      for (k3 = 0; k3 < 9; ++k3) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          Ad[i][k3][nd] = Ad[up][k3][nd];
        }
      }
      q_i2 = q[t->qid[i]];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double q_i2d;

        q_i2d = qd[t->qid[i]][nd];
        xd[i][0][nd] = xd[up][0][nd] + e20d[nd] + (u20d[nd] * q_i2 + u20 * q_i2d);
        bd[i][0][nd] = u20d[nd];
        bd[i][3][nd] = 0.0;
        xd[i][1][nd] = xd[up][1][nd] + e21d[nd] + (u21d[nd] * q_i2 + u21 * q_i2d);
        bd[i][1][nd] = u21d[nd];
        bd[i][4][nd] = 0.0;
        xd[i][2][nd] = xd[up][2][nd] + e22d[nd] + (u22d[nd] * q_i2 + u22 * q_i2d);
        bd[i][2][nd] = u22d[nd];
        bd[i][5][nd] = 0.0;
      }
    } else {
      offset0_i0_3 = offset0[i][0];
      offset0_i1_3 = offset0[i][1];
      offset0_i2_3 = offset0[i][2];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double offset0_i0_3d, offset0_i1_3d, offset0_i2_3d;

        offset0_i0_3d = offset0d[i][0][nd];
        offset0_i1_3d = offset0d[i][1][nd];
        offset0_i2_3d = offset0d[i][2][nd];
        e30d[nd] = Ad[up][0][nd] * offset0_i0_3 + A[up][0] * offset0_i0_3d + (Ad[up][1][nd] *
            offset0_i1_3 + A[up][1] * offset0_i1_3d) + (Ad[up][2][nd] * offset0_i2_3 + A[up][2] *
            offset0_i2_3d);
        e31d[nd] = Ad[up][3][nd] * offset0_i0_3 + A[up][3] * offset0_i0_3d + (Ad[up][4][nd] *
            offset0_i1_3 + A[up][4] * offset0_i1_3d) + (Ad[up][5][nd] * offset0_i2_3 + A[up][5] *
            offset0_i2_3d);
        e32d[nd] = Ad[up][6][nd] * offset0_i0_3 + A[up][6] * offset0_i0_3d + (Ad[up][7][nd] *
            offset0_i1_3 + A[up][7] * offset0_i1_3d) + (Ad[up][8][nd] * offset0_i2_3 + A[up][8] *
            offset0_i2_3d);
      }
      for (k4 = 0; k4 < 9; ++k4) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          Ad[i][k4][nd] = Ad[up][k4][nd];
        }
      }
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        xd[i][0][nd] = xd[up][0][nd] + e30d[nd];
        bd[i][0][nd] = 0.0;
        bd[i][3][nd] = 0.0;
        xd[i][1][nd] = xd[up][1][nd] + e31d[nd];
        bd[i][1][nd] = 0.0;
        bd[i][4][nd] = 0.0;
        xd[i][2][nd] = xd[up][2][nd] + e32d[nd];
        bd[i][2][nd] = 0.0;
        bd[i][5][nd] = 0.0;
      }
    }
  }
}

/* r = x + A point0 */
void maggi_points_dv(const maggi_topo *t, int begin, int end,
                     const double point0[restrict t->npoint][3],
                     const double point0d[restrict t->npoint][3][MAGGI_NDIR],
                     const double A[restrict t->nbody + 1][9],
                     const double Ad[restrict t->nbody + 1][9][MAGGI_NDIR],
                     const double x[restrict t->nbody + 1][3],
                     const double xd[restrict t->nbody + 1][3][MAGGI_NDIR],
                     double r[restrict t->npoint][3], double rd[restrict t->npoint][3][MAGGI_NDIR],
                     int nbdirs)
{
  int i, nd;
  double point0_i0, point0_i1, point0_i2;

  (void)x;
  (void)r;
  (void)nbdirs;
  for (i = begin; i < end; ++i) {
    point0_i0 = point0[i][0];
    point0_i1 = point0[i][1];
    point0_i2 = point0[i][2];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double e0d, e1d, e2d, point0_i0d, point0_i1d, point0_i2d;

      point0_i0d = point0d[i][0][nd];
      point0_i1d = point0d[i][1][nd];
      point0_i2d = point0d[i][2][nd];
      e0d = Ad[t->pointbody[i]][0][nd] * point0_i0 + A[t->pointbody[i]][0] * point0_i0d +
          (Ad[t->pointbody[i]][1][nd] * point0_i1 + A[t->pointbody[i]][1] * point0_i1d) +
          (Ad[t->pointbody[i]][2][nd] * point0_i2 + A[t->pointbody[i]][2] * point0_i2d);
      e1d = Ad[t->pointbody[i]][3][nd] * point0_i0 + A[t->pointbody[i]][3] * point0_i0d +
          (Ad[t->pointbody[i]][4][nd] * point0_i1 + A[t->pointbody[i]][4] * point0_i1d) +
          (Ad[t->pointbody[i]][5][nd] * point0_i2 + A[t->pointbody[i]][5] * point0_i2d);
      e2d = Ad[t->pointbody[i]][6][nd] * point0_i0 + A[t->pointbody[i]][6] * point0_i0d +
          (Ad[t->pointbody[i]][7][nd] * point0_i1 + A[t->pointbody[i]][7] * point0_i1d) +
          (Ad[t->pointbody[i]][8][nd] * point0_i2 + A[t->pointbody[i]][8] * point0_i2d);
      rd[i][0][nd] = xd[t->pointbody[i]][0][nd] + e0d;
      rd[i][1][nd] = xd[t->pointbody[i]][1][nd] + e1d;
      rd[i][2][nd] = xd[t->pointbody[i]][2][nd] + e2d;
    }
  }
}

void maggi_directions_dv(const maggi_topo *t, const double dir0[restrict t->ndir][3],
                         const double dir0d[restrict t->ndir][3][MAGGI_NDIR],
                         const double A[restrict t->nbody + 1][9],
                         const double Ad[restrict t->nbody + 1][9][MAGGI_NDIR],
                         double dir[restrict t->ndir][3],
                         double dird[restrict t->ndir][3][MAGGI_NDIR], int nbdirs)
{
  int i, nd;
  double dir0_i0, dir0_i1, dir0_i2;

  (void)dir;
  (void)nbdirs;
  for (i = 0; i < t->ndir; ++i) {
    dir0_i0 = dir0[i][0];
    dir0_i1 = dir0[i][1];
    dir0_i2 = dir0[i][2];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double dir0_i0d, dir0_i1d, dir0_i2d;

      dir0_i0d = dir0d[i][0][nd];
      dir0_i1d = dir0d[i][1][nd];
      dir0_i2d = dir0d[i][2][nd];
      dird[i][0][nd] = Ad[t->dirbody[i]][0][nd] * dir0_i0 + A[t->dirbody[i]][0] * dir0_i0d +
          (Ad[t->dirbody[i]][1][nd] * dir0_i1 + A[t->dirbody[i]][1] * dir0_i1d) +
          (Ad[t->dirbody[i]][2][nd] * dir0_i2 + A[t->dirbody[i]][2] * dir0_i2d);
      dird[i][1][nd] = Ad[t->dirbody[i]][3][nd] * dir0_i0 + A[t->dirbody[i]][3] * dir0_i0d +
          (Ad[t->dirbody[i]][4][nd] * dir0_i1 + A[t->dirbody[i]][4] * dir0_i1d) +
          (Ad[t->dirbody[i]][5][nd] * dir0_i2 + A[t->dirbody[i]][5] * dir0_i2d);
      dird[i][2][nd] = Ad[t->dirbody[i]][6][nd] * dir0_i0 + A[t->dirbody[i]][6] * dir0_i0d +
          (Ad[t->dirbody[i]][7][nd] * dir0_i1 + A[t->dirbody[i]][7] * dir0_i1d) +
          (Ad[t->dirbody[i]][8][nd] * dir0_i2 + A[t->dirbody[i]][8] * dir0_i2d);
    }
  }
}
