/* Tangent of core/kernel/position.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* joints that do not turn leave their row of turn alone */
void maggi_positions_d(const maggi_topo *t, const double offset0[restrict t->nbody][3],
                       const double offset0d[restrict t->nbody][3],
                       const double axis0[restrict t->nbody][3],
                       const double axis0d[restrict t->nbody][3], const double q[restrict t->nq],
                       const double qd[restrict t->nq], double turn[restrict t->nbody][2],
                       double turnd[restrict t->nbody][2], double A[restrict t->nbody + 1][9],
                       double Ad[restrict t->nbody + 1][9], double x[restrict t->nbody + 1][3],
                       double xd[restrict t->nbody + 1][3], double b[restrict t->nbody][6],
                       double bd[restrict t->nbody][6])
{
  int i, k, k3, k4, up;
  double A_up0, A_up0_2, A_up0_2d, A_up0d, A_up1, A_up1_2, A_up1_2d, A_up1d, A_up2, A_up2_2,
      A_up2_2d, A_up2d, A_up3, A_up3_2, A_up3_2d, A_up3d, A_up4, A_up4_2, A_up4_2d, A_up4d, A_up5,
      A_up5_2, A_up5_2d, A_up5d, A_up6, A_up6_2, A_up6_2d, A_up6d, A_up7, A_up7_2, A_up7_2d, A_up7d,
      A_up8, A_up8_2, A_up8_2d, A_up8d, R0, R0d, R1, R1d, R2, R2d, R3, R3d, R4, R4d, R5, R5d, R6,
      R6d, R7, R7d, R8, R8d, angled, axis0_i0, axis0_i0_2, axis0_i0_2d, axis0_i0d, axis0_i1,
      axis0_i1_2, axis0_i1_2d, axis0_i1d, axis0_i2, axis0_i2_2, axis0_i2_2d, axis0_i2d, c0d, c1d,
      c2d, e0, e0d, e1, e1d, e20d, e21d, e22d, e2_2, e2_2d, e30d, e31d, e32d, offset0_i0,
      offset0_i0_2, offset0_i0_2d, offset0_i0_3, offset0_i0_3d, offset0_i0d, offset0_i1,
      offset0_i1_2, offset0_i1_2d, offset0_i1_3, offset0_i1_3d, offset0_i1d, offset0_i2,
      offset0_i2_2, offset0_i2_2d, offset0_i2_3, offset0_i2_3d, offset0_i2d, q_i, q_i2, q_i2d, q_id,
      turn_i0, turn_i0d, turn_i1, turn_i1d, u0, u0d, u1, u1d, u20, u20d, u21, u21d, u22, u22d, u2_2,
      u2_2d, v, vd, vx, vxd, vy, vyd, vz, vzd, xi0, xi0d, xi1, xi1d, xi2, xi2d;

  for (k = 0; k < 9; ++k) {
    Ad[t->nbody][k] = 0.0;
  }
  xd[t->nbody][0] = 0.0;
  xd[t->nbody][1] = 0.0;
  xd[t->nbody][2] = 0.0;
  for (i = 0; i < t->nbase; ++i) {
    q_i = q[t->qid[t->base[i]]];
    q_id = qd[t->qid[t->base[i]]];
    xd[t->nbody][0] -= axis0d[t->base[i]][0] * q_i + axis0[t->base[i]][0] * q_id;
    xd[t->nbody][1] -= axis0d[t->base[i]][1] * q_i + axis0[t->base[i]][1] * q_id;
    xd[t->nbody][2] -= axis0d[t->base[i]][2] * q_i + axis0[t->base[i]][2] * q_id;
  }
  for (i = t->nbody - 1; i >= 0; --i) {
    up = t->parent[i];
    if (t->joint[i] == MAGGI_ONE_REVOLUTE) {
      angled = qd[t->qid[i]];
      turn_i0 = turn[i][0];
      turn_i0d = turn[i][1] * angled;
      turnd[i][0] = turn_i0d;
      turn_i1 = turn[i][1];
      turn_i1d = -(turn[i][0] * angled);
      turnd[i][1] = turn_i1d;
      A_up0 = A[up][0];
      A_up0d = Ad[up][0];
      offset0_i0 = offset0[i][0];
      offset0_i0d = offset0d[i][0];
      A_up1 = A[up][1];
      A_up1d = Ad[up][1];
      offset0_i1 = offset0[i][1];
      offset0_i1d = offset0d[i][1];
      A_up2 = A[up][2];
      A_up2d = Ad[up][2];
      offset0_i2 = offset0[i][2];
      offset0_i2d = offset0d[i][2];
      e0 = A_up0 * offset0_i0 + A_up1 * offset0_i1 + A_up2 * offset0_i2;
      /* b = (x × u, u) */
      e0d = A_up0d * offset0_i0 + A_up0 * offset0_i0d + (A_up1d * offset0_i1 + A_up1 * offset0_i1d)
          + (A_up2d * offset0_i2 + A_up2 * offset0_i2d);
      A_up3 = A[up][3];
      A_up3d = Ad[up][3];
      A_up4 = A[up][4];
      A_up4d = Ad[up][4];
      A_up5 = A[up][5];
      A_up5d = Ad[up][5];
      e1 = A_up3 * offset0_i0 + A_up4 * offset0_i1 + A_up5 * offset0_i2;
      e1d = A_up3d * offset0_i0 + A_up3 * offset0_i0d + (A_up4d * offset0_i1 + A_up4 * offset0_i1d)
          + (A_up5d * offset0_i2 + A_up5 * offset0_i2d);
      A_up6 = A[up][6];
      A_up6d = Ad[up][6];
      A_up7 = A[up][7];
      A_up7d = Ad[up][7];
      A_up8 = A[up][8];
      A_up8d = Ad[up][8];
      e2_2 = A_up6 * offset0_i0 + A_up7 * offset0_i1 + A_up8 * offset0_i2;
      e2_2d = A_up6d * offset0_i0 + A_up6 * offset0_i0d + (A_up7d * offset0_i1 + A_up7 *
          offset0_i1d) + (A_up8d * offset0_i2 + A_up8 * offset0_i2d);
      axis0_i0 = axis0[i][0];
      axis0_i0d = axis0d[i][0];
      axis0_i1 = axis0[i][1];
      axis0_i1d = axis0d[i][1];
      axis0_i2 = axis0[i][2];
      axis0_i2d = axis0d[i][2];
      u0 = b[i][3];
      u0d = A_up0d * axis0_i0 + A_up0 * axis0_i0d + (A_up1d * axis0_i1 + A_up1 * axis0_i1d) +
          (A_up2d * axis0_i2 + A_up2 * axis0_i2d);
      u1 = b[i][4];
      u1d = A_up3d * axis0_i0 + A_up3 * axis0_i0d + (A_up4d * axis0_i1 + A_up4 * axis0_i1d) +
          (A_up5d * axis0_i2 + A_up5 * axis0_i2d);
      u2_2 = b[i][5];
      u2_2d = A_up6d * axis0_i0 + A_up6 * axis0_i0d + (A_up7d * axis0_i1 + A_up7 * axis0_i1d) +
          (A_up8d * axis0_i2 + A_up8 * axis0_i2d);
      xi0 = x[up][0] + e0;
      xi0d = xd[up][0] + e0d;
      xi1 = x[up][1] + e1;
      xi1d = xd[up][1] + e1d;
      xi2 = x[up][2] + e2_2;
      xi2d = xd[up][2] + e2_2d;
      v = 1.0 - turn_i1;
      /* A = Ap Rot(u, q),  Rot = c I + s u~ + (1 - c) u u^T */
      vd = -turn_i1d;
      vx = v * axis0_i0;
      vxd = vd * axis0_i0 + v * axis0_i0d;
      vy = v * axis0_i1;
      vyd = vd * axis0_i1 + v * axis0_i1d;
      vz = v * axis0_i2;
      vzd = vd * axis0_i2 + v * axis0_i2d;
      R0 = turn_i1 + vx * axis0_i0;
      R0d = turn_i1d + (vxd * axis0_i0 + vx * axis0_i0d);
      R1 = vx * axis0_i1 - turn_i0 * axis0_i2;
      R1d = vxd * axis0_i1 + vx * axis0_i1d - (turn_i0d * axis0_i2 + turn_i0 * axis0_i2d);
      R2 = vx * axis0_i2 + turn_i0 * axis0_i1;
      R2d = vxd * axis0_i2 + vx * axis0_i2d + (turn_i0d * axis0_i1 + turn_i0 * axis0_i1d);
      R3 = vx * axis0_i1 + turn_i0 * axis0_i2;
      R3d = vxd * axis0_i1 + vx * axis0_i1d + (turn_i0d * axis0_i2 + turn_i0 * axis0_i2d);
      R4 = turn_i1 + vy * axis0_i1;
      R4d = turn_i1d + (vyd * axis0_i1 + vy * axis0_i1d);
      R5 = vy * axis0_i2 - turn_i0 * axis0_i0;
      R5d = vyd * axis0_i2 + vy * axis0_i2d - (turn_i0d * axis0_i0 + turn_i0 * axis0_i0d);
      R6 = vx * axis0_i2 - turn_i0 * axis0_i1;
      R6d = vxd * axis0_i2 + vx * axis0_i2d - (turn_i0d * axis0_i1 + turn_i0 * axis0_i1d);
      R7 = vy * axis0_i2 + turn_i0 * axis0_i0;
      R7d = vyd * axis0_i2 + vy * axis0_i2d + (turn_i0d * axis0_i0 + turn_i0 * axis0_i0d);
      R8 = turn_i1 + vz * axis0_i2;
      R8d = turn_i1d + (vzd * axis0_i2 + vz * axis0_i2d);
      Ad[i][0] = A_up0d * R0 + A_up0 * R0d + (A_up1d * R3 + A_up1 * R3d) + (A_up2d * R6 + A_up2 *
          R6d);
      Ad[i][1] = A_up0d * R1 + A_up0 * R1d + (A_up1d * R4 + A_up1 * R4d) + (A_up2d * R7 + A_up2 *
          R7d);
      Ad[i][2] = A_up0d * R2 + A_up0 * R2d + (A_up1d * R5 + A_up1 * R5d) + (A_up2d * R8 + A_up2 *
          R8d);
      Ad[i][3] = A_up3d * R0 + A_up3 * R0d + (A_up4d * R3 + A_up4 * R3d) + (A_up5d * R6 + A_up5 *
          R6d);
      Ad[i][4] = A_up3d * R1 + A_up3 * R1d + (A_up4d * R4 + A_up4 * R4d) + (A_up5d * R7 + A_up5 *
          R7d);
      Ad[i][5] = A_up3d * R2 + A_up3 * R2d + (A_up4d * R5 + A_up4 * R5d) + (A_up5d * R8 + A_up5 *
          R8d);
      Ad[i][6] = A_up6d * R0 + A_up6 * R0d + (A_up7d * R3 + A_up7 * R3d) + (A_up8d * R6 + A_up8 *
          R6d);
      Ad[i][7] = A_up6d * R1 + A_up6 * R1d + (A_up7d * R4 + A_up7 * R4d) + (A_up8d * R7 + A_up8 *
          R7d);
      Ad[i][8] = A_up6d * R2 + A_up6 * R2d + (A_up7d * R5 + A_up7 * R5d) + (A_up8d * R8 + A_up8 *
          R8d);
      c0d = xi1d * u2_2 + xi1 * u2_2d - (xi2d * u1 + xi2 * u1d);
      c1d = xi2d * u0 + xi2 * u0d - (xi0d * u2_2 + xi0 * u2_2d);
      c2d = xi0d * u1 + xi0 * u1d - (xi1d * u0 + xi1 * u0d);
      xd[i][0] = xi0d;
      xd[i][1] = xi1d;
      xd[i][2] = xi2d;
      bd[i][0] = c0d;
      bd[i][1] = c1d;
      bd[i][2] = c2d;
      bd[i][3] = u0d;
      bd[i][4] = u1d;
      bd[i][5] = u2_2d;
    } else if (t->joint[i] == MAGGI_ONE_PRISMATIC) {
      A_up0_2 = A[up][0];
      A_up0_2d = Ad[up][0];
      offset0_i0_2 = offset0[i][0];
      offset0_i0_2d = offset0d[i][0];
      A_up1_2 = A[up][1];
      A_up1_2d = Ad[up][1];
      offset0_i1_2 = offset0[i][1];
      offset0_i1_2d = offset0d[i][1];
      A_up2_2 = A[up][2];
      A_up2_2d = Ad[up][2];
      offset0_i2_2 = offset0[i][2];
      offset0_i2_2d = offset0d[i][2];
      /* b = (u, 0) */
      e20d = A_up0_2d * offset0_i0_2 + A_up0_2 * offset0_i0_2d + (A_up1_2d * offset0_i1_2 + A_up1_2
          * offset0_i1_2d) + (A_up2_2d * offset0_i2_2 + A_up2_2 * offset0_i2_2d);
      A_up3_2 = A[up][3];
      A_up3_2d = Ad[up][3];
      A_up4_2 = A[up][4];
      A_up4_2d = Ad[up][4];
      A_up5_2 = A[up][5];
      A_up5_2d = Ad[up][5];
      e21d = A_up3_2d * offset0_i0_2 + A_up3_2 * offset0_i0_2d + (A_up4_2d * offset0_i1_2 + A_up4_2
          * offset0_i1_2d) + (A_up5_2d * offset0_i2_2 + A_up5_2 * offset0_i2_2d);
      A_up6_2 = A[up][6];
      A_up6_2d = Ad[up][6];
      A_up7_2 = A[up][7];
      A_up7_2d = Ad[up][7];
      A_up8_2 = A[up][8];
      A_up8_2d = Ad[up][8];
      e22d = A_up6_2d * offset0_i0_2 + A_up6_2 * offset0_i0_2d + (A_up7_2d * offset0_i1_2 + A_up7_2
          * offset0_i1_2d) + (A_up8_2d * offset0_i2_2 + A_up8_2 * offset0_i2_2d);
      axis0_i0_2 = axis0[i][0];
      axis0_i0_2d = axis0d[i][0];
      axis0_i1_2 = axis0[i][1];
      axis0_i1_2d = axis0d[i][1];
      axis0_i2_2 = axis0[i][2];
      axis0_i2_2d = axis0d[i][2];
      u20 = b[i][0];
      u20d = A_up0_2d * axis0_i0_2 + A_up0_2 * axis0_i0_2d + (A_up1_2d * axis0_i1_2 + A_up1_2 *
          axis0_i1_2d) + (A_up2_2d * axis0_i2_2 + A_up2_2 * axis0_i2_2d);
      u21 = b[i][1];
      u21d = A_up3_2d * axis0_i0_2 + A_up3_2 * axis0_i0_2d + (A_up4_2d * axis0_i1_2 + A_up4_2 *
          axis0_i1_2d) + (A_up5_2d * axis0_i2_2 + A_up5_2 * axis0_i2_2d);
      u22 = b[i][2];
      u22d = A_up6_2d * axis0_i0_2 + A_up6_2 * axis0_i0_2d + (A_up7_2d * axis0_i1_2 + A_up7_2 *
          axis0_i1_2d) + (A_up8_2d * axis0_i2_2 + A_up8_2 * axis0_i2_2d);
      for (k3 = 0; k3 < 9; ++k3) {
        Ad[i][k3] = Ad[up][k3];
      }
      q_i2 = q[t->qid[i]];
      q_i2d = qd[t->qid[i]];
      xd[i][0] = xd[up][0] + e20d + (u20d * q_i2 + u20 * q_i2d);
      bd[i][0] = u20d;
      bd[i][3] = 0.0;
      xd[i][1] = xd[up][1] + e21d + (u21d * q_i2 + u21 * q_i2d);
      bd[i][1] = u21d;
      bd[i][4] = 0.0;
      xd[i][2] = xd[up][2] + e22d + (u22d * q_i2 + u22 * q_i2d);
      bd[i][2] = u22d;
      bd[i][5] = 0.0;
    } else {
      offset0_i0_3 = offset0[i][0];
      offset0_i0_3d = offset0d[i][0];
      offset0_i1_3 = offset0[i][1];
      offset0_i1_3d = offset0d[i][1];
      offset0_i2_3 = offset0[i][2];
      offset0_i2_3d = offset0d[i][2];
      e30d = Ad[up][0] * offset0_i0_3 + A[up][0] * offset0_i0_3d + (Ad[up][1] * offset0_i1_3 +
          A[up][1] * offset0_i1_3d) + (Ad[up][2] * offset0_i2_3 + A[up][2] * offset0_i2_3d);
      e31d = Ad[up][3] * offset0_i0_3 + A[up][3] * offset0_i0_3d + (Ad[up][4] * offset0_i1_3 +
          A[up][4] * offset0_i1_3d) + (Ad[up][5] * offset0_i2_3 + A[up][5] * offset0_i2_3d);
      e32d = Ad[up][6] * offset0_i0_3 + A[up][6] * offset0_i0_3d + (Ad[up][7] * offset0_i1_3 +
          A[up][7] * offset0_i1_3d) + (Ad[up][8] * offset0_i2_3 + A[up][8] * offset0_i2_3d);
      for (k4 = 0; k4 < 9; ++k4) {
        Ad[i][k4] = Ad[up][k4];
      }
      xd[i][0] = xd[up][0] + e30d;
      bd[i][0] = 0.0;
      bd[i][3] = 0.0;
      xd[i][1] = xd[up][1] + e31d;
      bd[i][1] = 0.0;
      bd[i][4] = 0.0;
      xd[i][2] = xd[up][2] + e32d;
      bd[i][2] = 0.0;
      bd[i][5] = 0.0;
    }
  }
}

/* r = x + A point0 */
void maggi_points_d(const maggi_topo *t, int begin, int end,
                    const double point0[restrict t->npoint][3],
                    const double point0d[restrict t->npoint][3],
                    const double A[restrict t->nbody + 1][9],
                    const double Ad[restrict t->nbody + 1][9],
                    const double x[restrict t->nbody + 1][3],
                    const double xd[restrict t->nbody + 1][3], double r[restrict t->npoint][3],
                    double rd[restrict t->npoint][3])
{
  int i;
  double e0d, e1d, e2d, point0_i0, point0_i0d, point0_i1, point0_i1d, point0_i2, point0_i2d;

  (void)x;
  (void)r;
  for (i = begin; i < end; ++i) {
    point0_i0 = point0[i][0];
    point0_i0d = point0d[i][0];
    point0_i1 = point0[i][1];
    point0_i1d = point0d[i][1];
    point0_i2 = point0[i][2];
    point0_i2d = point0d[i][2];
    e0d = Ad[t->pointbody[i]][0] * point0_i0 + A[t->pointbody[i]][0] * point0_i0d +
        (Ad[t->pointbody[i]][1] * point0_i1 + A[t->pointbody[i]][1] * point0_i1d) +
        (Ad[t->pointbody[i]][2] * point0_i2 + A[t->pointbody[i]][2] * point0_i2d);
    e1d = Ad[t->pointbody[i]][3] * point0_i0 + A[t->pointbody[i]][3] * point0_i0d +
        (Ad[t->pointbody[i]][4] * point0_i1 + A[t->pointbody[i]][4] * point0_i1d) +
        (Ad[t->pointbody[i]][5] * point0_i2 + A[t->pointbody[i]][5] * point0_i2d);
    e2d = Ad[t->pointbody[i]][6] * point0_i0 + A[t->pointbody[i]][6] * point0_i0d +
        (Ad[t->pointbody[i]][7] * point0_i1 + A[t->pointbody[i]][7] * point0_i1d) +
        (Ad[t->pointbody[i]][8] * point0_i2 + A[t->pointbody[i]][8] * point0_i2d);
    rd[i][0] = xd[t->pointbody[i]][0] + e0d;
    rd[i][1] = xd[t->pointbody[i]][1] + e1d;
    rd[i][2] = xd[t->pointbody[i]][2] + e2d;
  }
}

void maggi_directions_d(const maggi_topo *t, const double dir0[restrict t->ndir][3],
                        const double dir0d[restrict t->ndir][3],
                        const double A[restrict t->nbody + 1][9],
                        const double Ad[restrict t->nbody + 1][9], double dir[restrict t->ndir][3],
                        double dird[restrict t->ndir][3])
{
  int i;
  double dir0_i0, dir0_i0d, dir0_i1, dir0_i1d, dir0_i2, dir0_i2d;

  (void)dir;
  for (i = 0; i < t->ndir; ++i) {
    dir0_i0 = dir0[i][0];
    dir0_i0d = dir0d[i][0];
    dir0_i1 = dir0[i][1];
    dir0_i1d = dir0d[i][1];
    dir0_i2 = dir0[i][2];
    dir0_i2d = dir0d[i][2];
    dird[i][0] = Ad[t->dirbody[i]][0] * dir0_i0 + A[t->dirbody[i]][0] * dir0_i0d +
        (Ad[t->dirbody[i]][1] * dir0_i1 + A[t->dirbody[i]][1] * dir0_i1d) + (Ad[t->dirbody[i]][2] *
        dir0_i2 + A[t->dirbody[i]][2] * dir0_i2d);
    dird[i][1] = Ad[t->dirbody[i]][3] * dir0_i0 + A[t->dirbody[i]][3] * dir0_i0d +
        (Ad[t->dirbody[i]][4] * dir0_i1 + A[t->dirbody[i]][4] * dir0_i1d) + (Ad[t->dirbody[i]][5] *
        dir0_i2 + A[t->dirbody[i]][5] * dir0_i2d);
    dird[i][2] = Ad[t->dirbody[i]][6] * dir0_i0 + A[t->dirbody[i]][6] * dir0_i0d +
        (Ad[t->dirbody[i]][7] * dir0_i1 + A[t->dirbody[i]][7] * dir0_i1d) + (Ad[t->dirbody[i]][8] *
        dir0_i2 + A[t->dirbody[i]][8] * dir0_i2d);
  }
}
