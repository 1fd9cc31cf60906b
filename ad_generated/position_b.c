/* Adjoint of core/kernel/position.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* joints that do not turn leave their row of turn alone */
void maggi_positions_b(const maggi_topo *t, const double offset0[restrict t->nbody][3],
                       double offset0b[restrict t->nbody][3],
                       const double axis0[restrict t->nbody][3],
                       double axis0b[restrict t->nbody][3], const double q[restrict t->nq],
                       double qb[restrict t->nq], double turn[restrict t->nbody][2],
                       double turnb[restrict t->nbody][2], double A[restrict t->nbody + 1][9],
                       double Ab[restrict t->nbody + 1][9], double x[restrict t->nbody + 1][3],
                       double xb[restrict t->nbody + 1][3], double b[restrict t->nbody][6],
                       double bb[restrict t->nbody][6])
{
  int i, k, k3, k4, up;
  double A_up0, A_up0_2, A_up0_2b, A_up0b, A_up1, A_up1_2, A_up1_2b, A_up1b, A_up2, A_up2_2,
      A_up2_2b, A_up2b, A_up3, A_up3_2, A_up3_2b, A_up3b, A_up4, A_up4_2, A_up4_2b, A_up4b, A_up5,
      A_up5_2, A_up5_2b, A_up5b, A_up6, A_up6_2, A_up6_2b, A_up6b, A_up7, A_up7_2, A_up7_2b, A_up7b,
      A_up8, A_up8_2, A_up8_2b, A_up8b, R0, R0b, R1, R1b, R2, R2b, R3, R3b, R4, R4b, R5, R5b, R6,
      R6b, R7, R7b, R8, R8b, angleb, axis0_i0, axis0_i0_2, axis0_i0_2b, axis0_i0b, axis0_i1,
      axis0_i1_2, axis0_i1_2b, axis0_i1b, axis0_i2, axis0_i2_2, axis0_i2_2b, axis0_i2b, c0b, c1b,
      c2b, e0, e0b, e1, e1b, e20b, e21b, e22b, e2_2, e2_2b, e30b, e31b, e32b, offset0_i0,
      offset0_i0_2, offset0_i0_2b, offset0_i0_3, offset0_i0_3b, offset0_i0b, offset0_i1,
      offset0_i1_2, offset0_i1_2b, offset0_i1_3, offset0_i1_3b, offset0_i1b, offset0_i2,
      offset0_i2_2, offset0_i2_2b, offset0_i2_3, offset0_i2_3b, offset0_i2b, q_i, q_i2, q_i2b, q_ib,
      tb10, tb11, tb12, tb13, tb14, tb15, tb16, tb17, tb18, tb19, tb2, tb3, tb4, tb5, tb6, tb7, tb8,
      tb9, turn_i0, turn_i0b, turn_i1, turn_i1b, u0, u0b, u1, u1b, u20, u20b, u21, u21b, u22, u22b,
      u2_2, u2_2b, v, vb, vx, vxb, vy, vyb, vz, vzb, xi0, xi0b, xi1, xi1b, xi2, xi2b;

  for (i = 0; i < t->nbody; ++i) {
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
      u2_2b = bb[i][5];
      bb[i][5] = 0.0;
      u1b = bb[i][4];
      bb[i][4] = 0.0;
      u0b = bb[i][3];
      bb[i][3] = 0.0;
      c2b = bb[i][2];
      bb[i][2] = 0.0;
      c1b = bb[i][1];
      bb[i][1] = 0.0;
      c0b = bb[i][0];
      bb[i][0] = 0.0;
      xi2b = xb[i][2];
      xb[i][2] = 0.0;
      xi1b = xb[i][1];
      xb[i][1] = 0.0;
      xi0b = xb[i][0];
      xb[i][0] = 0.0;
      xi0b += c2b * u1;
      u1b += c2b * xi0;
      xi1b -= c2b * u0;
      u0b -= c2b * xi1;
      xi2b += c1b * u0;
      u0b += c1b * xi2;
      xi0b -= c1b * u2_2;
      u2_2b -= c1b * xi0;
      xi1b += c0b * u2_2;
      u2_2b += c0b * xi1;
      xi2b -= c0b * u1;
      u1b -= c0b * xi2;
      tb13 = Ab[i][8];
      Ab[i][8] = 0.0;
      A_up6b = tb13 * R2;
      R2b = tb13 * A_up6;
      A_up7b = tb13 * R5;
      R5b = tb13 * A_up7;
      A_up8b = tb13 * R8;
      R8b = tb13 * A_up8;
      tb12 = Ab[i][7];
      Ab[i][7] = 0.0;
      A_up6b += tb12 * R1;
      R1b = tb12 * A_up6;
      A_up7b += tb12 * R4;
      R4b = tb12 * A_up7;
      A_up8b += tb12 * R7;
      R7b = tb12 * A_up8;
      tb11 = Ab[i][6];
      Ab[i][6] = 0.0;
      A_up6b += tb11 * R0;
      R0b = tb11 * A_up6;
      A_up7b += tb11 * R3;
      R3b = tb11 * A_up7;
      A_up8b += tb11 * R6;
      R6b = tb11 * A_up8;
      tb10 = Ab[i][5];
      Ab[i][5] = 0.0;
      A_up3b = tb10 * R2;
      R2b += tb10 * A_up3;
      A_up4b = tb10 * R5;
      R5b += tb10 * A_up4;
      A_up5b = tb10 * R8;
      R8b += tb10 * A_up5;
      tb9 = Ab[i][4];
      Ab[i][4] = 0.0;
      A_up3b += tb9 * R1;
      R1b += tb9 * A_up3;
      A_up4b += tb9 * R4;
      R4b += tb9 * A_up4;
      A_up5b += tb9 * R7;
      R7b += tb9 * A_up5;
      tb8 = Ab[i][3];
      Ab[i][3] = 0.0;
      A_up3b += tb8 * R0;
      R0b += tb8 * A_up3;
      A_up4b += tb8 * R3;
      R3b += tb8 * A_up4;
      A_up5b += tb8 * R6;
      R6b += tb8 * A_up5;
      tb7 = Ab[i][2];
      Ab[i][2] = 0.0;
      A_up0b = tb7 * R2;
      R2b += tb7 * A_up0;
      A_up1b = tb7 * R5;
      R5b += tb7 * A_up1;
      A_up2b = tb7 * R8;
      R8b += tb7 * A_up2;
      tb6 = Ab[i][1];
      Ab[i][1] = 0.0;
      A_up0b += tb6 * R1;
      R1b += tb6 * A_up0;
      A_up1b += tb6 * R4;
      R4b += tb6 * A_up1;
      A_up2b += tb6 * R7;
      R7b += tb6 * A_up2;
      tb5 = Ab[i][0];
      Ab[i][0] = 0.0;
      A_up0b += tb5 * R0;
      R0b += tb5 * A_up0;
      A_up1b += tb5 * R3;
      R3b += tb5 * A_up1;
      A_up2b += tb5 * R6;
      R6b += tb5 * A_up2;
      turn_i1b = R8b;
      vzb = R8b * axis0_i2;
      axis0_i2b = R8b * vz;
      vyb = R7b * axis0_i2;
      axis0_i2b += R7b * vy;
      turn_i0b = R7b * axis0_i0;
      axis0_i0b = R7b * turn_i0;
      vxb = R6b * axis0_i2;
      axis0_i2b += R6b * vx;
      turn_i0b -= R6b * axis0_i1;
      axis0_i1b = -(R6b * turn_i0);
      vyb += R5b * axis0_i2;
      axis0_i2b += R5b * vy;
      turn_i0b -= R5b * axis0_i0;
      axis0_i0b -= R5b * turn_i0;
      turn_i1b += R4b;
      vyb += R4b * axis0_i1;
      axis0_i1b += R4b * vy;
      vxb += R3b * axis0_i1;
      axis0_i1b += R3b * vx;
      turn_i0b += R3b * axis0_i2;
      axis0_i2b += R3b * turn_i0;
      vxb += R2b * axis0_i2;
      axis0_i2b += R2b * vx;
      turn_i0b += R2b * axis0_i1;
      axis0_i1b += R2b * turn_i0;
      vxb += R1b * axis0_i1;
      axis0_i1b += R1b * vx;
      turn_i0b -= R1b * axis0_i2;
      axis0_i2b -= R1b * turn_i0;
      turn_i1b += R0b;
      vxb += R0b * axis0_i0;
      axis0_i0b += R0b * vx;
      vb = vzb * axis0_i2;
      axis0_i2b += vzb * v;
      vb += vyb * axis0_i1;
      axis0_i1b += vyb * v;
      vb += vxb * axis0_i0;
      axis0_i0b += vxb * v;
      /* A = Ap Rot(u, q),  Rot = c I + s u~ + (1 - c) u u^T */
      turn_i1b -= vb;
      xb[up][2] += xi2b;
      e2_2b = xi2b;
      xb[up][1] += xi1b;
      e1b = xi1b;
      xb[up][0] += xi0b;
      e0b = xi0b;
      A_up6b += u2_2b * axis0_i0;
      axis0_i0b += u2_2b * A_up6;
      A_up7b += u2_2b * axis0_i1;
      axis0_i1b += u2_2b * A_up7;
      A_up8b += u2_2b * axis0_i2;
      axis0_i2b += u2_2b * A_up8;
      A_up3b += u1b * axis0_i0;
      axis0_i0b += u1b * A_up3;
      A_up4b += u1b * axis0_i1;
      axis0_i1b += u1b * A_up4;
      A_up5b += u1b * axis0_i2;
      axis0_i2b += u1b * A_up5;
      A_up0b += u0b * axis0_i0;
      axis0_i0b += u0b * A_up0;
      A_up1b += u0b * axis0_i1;
      axis0_i1b += u0b * A_up1;
      A_up2b += u0b * axis0_i2;
      axis0_i2b += u0b * A_up2;
      axis0b[i][2] += axis0_i2b;
      axis0b[i][1] += axis0_i1b;
      axis0b[i][0] += axis0_i0b;
      A_up6b += e2_2b * offset0_i0;
      offset0_i0b = e2_2b * A_up6;
      A_up7b += e2_2b * offset0_i1;
      offset0_i1b = e2_2b * A_up7;
      A_up8b += e2_2b * offset0_i2;
      offset0_i2b = e2_2b * A_up8;
      Ab[up][8] += A_up8b;
      Ab[up][7] += A_up7b;
      Ab[up][6] += A_up6b;
      A_up3b += e1b * offset0_i0;
      offset0_i0b += e1b * A_up3;
      A_up4b += e1b * offset0_i1;
      offset0_i1b += e1b * A_up4;
      A_up5b += e1b * offset0_i2;
      offset0_i2b += e1b * A_up5;
      Ab[up][5] += A_up5b;
      Ab[up][4] += A_up4b;
      Ab[up][3] += A_up3b;
      /* b = (x × u, u) */
      A_up0b += e0b * offset0_i0;
      offset0_i0b += e0b * A_up0;
      A_up1b += e0b * offset0_i1;
      offset0_i1b += e0b * A_up1;
      A_up2b += e0b * offset0_i2;
      offset0_i2b += e0b * A_up2;
      offset0b[i][2] += offset0_i2b;
      Ab[up][2] += A_up2b;
      offset0b[i][1] += offset0_i1b;
      Ab[up][1] += A_up1b;
      offset0b[i][0] += offset0_i0b;
      Ab[up][0] += A_up0b;
      turn_i1b += turnb[i][1];
      turnb[i][1] = 0.0;
      angleb = -(turn_i1b * turn[i][0]);
      turn_i0b += turnb[i][0];
      turnb[i][0] = 0.0;
      angleb += turn_i0b * turn[i][1];
      qb[t->qid[i]] += angleb;
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
      q_i2 = q[t->qid[i]];
      bb[i][5] = 0.0;
      u22b = bb[i][2];
      bb[i][2] = 0.0;
      tb16 = xb[i][2];
      xb[i][2] = 0.0;
      xb[up][2] += tb16;
      e22b = tb16;
      u22b += tb16 * q_i2;
      q_i2b = tb16 * u22;
      bb[i][4] = 0.0;
      u21b = bb[i][1];
      bb[i][1] = 0.0;
      tb15 = xb[i][1];
      xb[i][1] = 0.0;
      xb[up][1] += tb15;
      e21b = tb15;
      u21b += tb15 * q_i2;
      q_i2b += tb15 * u21;
      bb[i][3] = 0.0;
      u20b = bb[i][0];
      bb[i][0] = 0.0;
      tb14 = xb[i][0];
      xb[i][0] = 0.0;
      xb[up][0] += tb14;
      e20b = tb14;
      u20b += tb14 * q_i2;
      q_i2b += tb14 * u20;
      qb[t->qid[i]] += q_i2b;
      for (k3 = 8; k3 >= 0; --k3) {
        Ab[up][k3] += Ab[i][k3];
        Ab[i][k3] = 0.0;
      }
      A_up6_2b = u22b * axis0_i0_2;
      axis0_i0_2b = u22b * A_up6_2;
      A_up7_2b = u22b * axis0_i1_2;
      axis0_i1_2b = u22b * A_up7_2;
      A_up8_2b = u22b * axis0_i2_2;
      axis0_i2_2b = u22b * A_up8_2;
      A_up3_2b = u21b * axis0_i0_2;
      axis0_i0_2b += u21b * A_up3_2;
      A_up4_2b = u21b * axis0_i1_2;
      axis0_i1_2b += u21b * A_up4_2;
      A_up5_2b = u21b * axis0_i2_2;
      axis0_i2_2b += u21b * A_up5_2;
      A_up0_2b = u20b * axis0_i0_2;
      axis0_i0_2b += u20b * A_up0_2;
      A_up1_2b = u20b * axis0_i1_2;
      axis0_i1_2b += u20b * A_up1_2;
      A_up2_2b = u20b * axis0_i2_2;
      axis0_i2_2b += u20b * A_up2_2;
      axis0b[i][2] += axis0_i2_2b;
      axis0b[i][1] += axis0_i1_2b;
      axis0b[i][0] += axis0_i0_2b;
      A_up6_2b += e22b * offset0_i0_2;
      offset0_i0_2b = e22b * A_up6_2;
      A_up7_2b += e22b * offset0_i1_2;
      offset0_i1_2b = e22b * A_up7_2;
      A_up8_2b += e22b * offset0_i2_2;
      offset0_i2_2b = e22b * A_up8_2;
      Ab[up][8] += A_up8_2b;
      Ab[up][7] += A_up7_2b;
      Ab[up][6] += A_up6_2b;
      A_up3_2b += e21b * offset0_i0_2;
      offset0_i0_2b += e21b * A_up3_2;
      A_up4_2b += e21b * offset0_i1_2;
      offset0_i1_2b += e21b * A_up4_2;
      A_up5_2b += e21b * offset0_i2_2;
      offset0_i2_2b += e21b * A_up5_2;
      Ab[up][5] += A_up5_2b;
      Ab[up][4] += A_up4_2b;
      Ab[up][3] += A_up3_2b;
      /* b = (u, 0) */
      A_up0_2b += e20b * offset0_i0_2;
      offset0_i0_2b += e20b * A_up0_2;
      A_up1_2b += e20b * offset0_i1_2;
      offset0_i1_2b += e20b * A_up1_2;
      A_up2_2b += e20b * offset0_i2_2;
      offset0_i2_2b += e20b * A_up2_2;
      offset0b[i][2] += offset0_i2_2b;
      Ab[up][2] += A_up2_2b;
      offset0b[i][1] += offset0_i1_2b;
      Ab[up][1] += A_up1_2b;
      offset0b[i][0] += offset0_i0_2b;
      Ab[up][0] += A_up0_2b;
    } else {
      offset0_i0_3 = offset0[i][0];
      offset0_i1_3 = offset0[i][1];
      offset0_i2_3 = offset0[i][2];
      bb[i][5] = 0.0;
      bb[i][2] = 0.0;
      tb19 = xb[i][2];
      xb[i][2] = 0.0;
      xb[up][2] += tb19;
      e32b = tb19;
      bb[i][4] = 0.0;
      bb[i][1] = 0.0;
      tb18 = xb[i][1];
      xb[i][1] = 0.0;
      xb[up][1] += tb18;
      e31b = tb18;
      bb[i][3] = 0.0;
      bb[i][0] = 0.0;
      tb17 = xb[i][0];
      xb[i][0] = 0.0;
      xb[up][0] += tb17;
      e30b = tb17;
      for (k4 = 8; k4 >= 0; --k4) {
        Ab[up][k4] += Ab[i][k4];
        Ab[i][k4] = 0.0;
      }
      Ab[up][6] += e32b * offset0_i0_3;
      offset0_i0_3b = e32b * A[up][6];
      Ab[up][7] += e32b * offset0_i1_3;
      offset0_i1_3b = e32b * A[up][7];
      Ab[up][8] += e32b * offset0_i2_3;
      offset0_i2_3b = e32b * A[up][8];
      Ab[up][3] += e31b * offset0_i0_3;
      offset0_i0_3b += e31b * A[up][3];
      Ab[up][4] += e31b * offset0_i1_3;
      offset0_i1_3b += e31b * A[up][4];
      Ab[up][5] += e31b * offset0_i2_3;
      offset0_i2_3b += e31b * A[up][5];
      Ab[up][0] += e30b * offset0_i0_3;
      offset0_i0_3b += e30b * A[up][0];
      Ab[up][1] += e30b * offset0_i1_3;
      offset0_i1_3b += e30b * A[up][1];
      Ab[up][2] += e30b * offset0_i2_3;
      offset0_i2_3b += e30b * A[up][2];
      offset0b[i][2] += offset0_i2_3b;
      offset0b[i][1] += offset0_i1_3b;
      offset0b[i][0] += offset0_i0_3b;
    }
  }
  for (i = t->nbase - 1; i >= 0; --i) {
    q_i = q[t->qid[t->base[i]]];
    tb4 = xb[t->nbody][2];
    axis0b[t->base[i]][2] -= tb4 * q_i;
    q_ib = -(tb4 * axis0[t->base[i]][2]);
    tb3 = xb[t->nbody][1];
    axis0b[t->base[i]][1] -= tb3 * q_i;
    q_ib -= tb3 * axis0[t->base[i]][1];
    tb2 = xb[t->nbody][0];
    axis0b[t->base[i]][0] -= tb2 * q_i;
    q_ib -= tb2 * axis0[t->base[i]][0];
    qb[t->qid[t->base[i]]] += q_ib;
  }
  xb[t->nbody][2] = 0.0;
  xb[t->nbody][1] = 0.0;
  xb[t->nbody][0] = 0.0;
  for (k = 8; k >= 0; --k) {
    Ab[t->nbody][k] = 0.0;
  }
}

/* r = x + A point0 */
void maggi_points_b(const maggi_topo *t, int begin, int end,
                    const double point0[restrict t->npoint][3],
                    double point0b[restrict t->npoint][3], const double A[restrict t->nbody + 1][9],
                    double Ab[restrict t->nbody + 1][9], const double x[restrict t->nbody + 1][3],
                    double xb[restrict t->nbody + 1][3], double r[restrict t->npoint][3],
                    double rb[restrict t->npoint][3])
{
  int i;
  double e0b, e1b, e2b, point0_i0, point0_i0b, point0_i1, point0_i1b, point0_i2, point0_i2b, tb2,
      tb3, tb4;

  (void)x;
  (void)r;
  for (i = end - 1; i >= begin; --i) {
    point0_i0 = point0[i][0];
    point0_i1 = point0[i][1];
    point0_i2 = point0[i][2];
    tb4 = rb[i][2];
    rb[i][2] = 0.0;
    xb[t->pointbody[i]][2] += tb4;
    e2b = tb4;
    tb3 = rb[i][1];
    rb[i][1] = 0.0;
    xb[t->pointbody[i]][1] += tb3;
    e1b = tb3;
    tb2 = rb[i][0];
    rb[i][0] = 0.0;
    xb[t->pointbody[i]][0] += tb2;
    e0b = tb2;
    Ab[t->pointbody[i]][6] += e2b * point0_i0;
    point0_i0b = e2b * A[t->pointbody[i]][6];
    Ab[t->pointbody[i]][7] += e2b * point0_i1;
    point0_i1b = e2b * A[t->pointbody[i]][7];
    Ab[t->pointbody[i]][8] += e2b * point0_i2;
    point0_i2b = e2b * A[t->pointbody[i]][8];
    Ab[t->pointbody[i]][3] += e1b * point0_i0;
    point0_i0b += e1b * A[t->pointbody[i]][3];
    Ab[t->pointbody[i]][4] += e1b * point0_i1;
    point0_i1b += e1b * A[t->pointbody[i]][4];
    Ab[t->pointbody[i]][5] += e1b * point0_i2;
    point0_i2b += e1b * A[t->pointbody[i]][5];
    Ab[t->pointbody[i]][0] += e0b * point0_i0;
    point0_i0b += e0b * A[t->pointbody[i]][0];
    Ab[t->pointbody[i]][1] += e0b * point0_i1;
    point0_i1b += e0b * A[t->pointbody[i]][1];
    Ab[t->pointbody[i]][2] += e0b * point0_i2;
    point0_i2b += e0b * A[t->pointbody[i]][2];
    point0b[i][2] += point0_i2b;
    point0b[i][1] += point0_i1b;
    point0b[i][0] += point0_i0b;
  }
}

void maggi_directions_b(const maggi_topo *t, const double dir0[restrict t->ndir][3],
                        double dir0b[restrict t->ndir][3], const double A[restrict t->nbody + 1][9],
                        double Ab[restrict t->nbody + 1][9], double dir[restrict t->ndir][3],
                        double dirb[restrict t->ndir][3])
{
  int i;
  double dir0_i0, dir0_i0b, dir0_i1, dir0_i1b, dir0_i2, dir0_i2b, tb2, tb3, tb4;

  (void)dir;
  for (i = t->ndir - 1; i >= 0; --i) {
    dir0_i0 = dir0[i][0];
    dir0_i1 = dir0[i][1];
    dir0_i2 = dir0[i][2];
    tb4 = dirb[i][2];
    dirb[i][2] = 0.0;
    Ab[t->dirbody[i]][6] += tb4 * dir0_i0;
    dir0_i0b = tb4 * A[t->dirbody[i]][6];
    Ab[t->dirbody[i]][7] += tb4 * dir0_i1;
    dir0_i1b = tb4 * A[t->dirbody[i]][7];
    Ab[t->dirbody[i]][8] += tb4 * dir0_i2;
    dir0_i2b = tb4 * A[t->dirbody[i]][8];
    tb3 = dirb[i][1];
    dirb[i][1] = 0.0;
    Ab[t->dirbody[i]][3] += tb3 * dir0_i0;
    dir0_i0b += tb3 * A[t->dirbody[i]][3];
    Ab[t->dirbody[i]][4] += tb3 * dir0_i1;
    dir0_i1b += tb3 * A[t->dirbody[i]][4];
    Ab[t->dirbody[i]][5] += tb3 * dir0_i2;
    dir0_i2b += tb3 * A[t->dirbody[i]][5];
    tb2 = dirb[i][0];
    dirb[i][0] = 0.0;
    Ab[t->dirbody[i]][0] += tb2 * dir0_i0;
    dir0_i0b += tb2 * A[t->dirbody[i]][0];
    Ab[t->dirbody[i]][1] += tb2 * dir0_i1;
    dir0_i1b += tb2 * A[t->dirbody[i]][1];
    Ab[t->dirbody[i]][2] += tb2 * dir0_i2;
    dir0_i2b += tb2 * A[t->dirbody[i]][2];
    dir0b[i][2] += dir0_i2b;
    dir0b[i][1] += dir0_i1b;
    dir0b[i][0] += dir0_i0b;
  }
}
