/* Tangent of the adjoint of core/kernel/position.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* joints that do not turn leave their row of turn alone */
void maggi_positions_b_d(const maggi_topo *t, const double offset0[restrict t->nbody][3],
                         const double offset0d[restrict t->nbody][3],
                         double offset0b[restrict t->nbody][3],
                         double offset0bd[restrict t->nbody][3],
                         const double axis0[restrict t->nbody][3],
                         const double axis0d[restrict t->nbody][3],
                         double axis0b[restrict t->nbody][3], double axis0bd[restrict t->nbody][3],
                         const double q[restrict t->nq], const double qd[restrict t->nq],
                         double qb[restrict t->nq], double qbd[restrict t->nq],
                         double turn[restrict t->nbody][2], double turnd[restrict t->nbody][2],
                         double turnb[restrict t->nbody][2], double turnbd[restrict t->nbody][2],
                         double A[restrict t->nbody + 1][9], double Ad[restrict t->nbody + 1][9],
                         double Ab[restrict t->nbody + 1][9], double Abd[restrict t->nbody + 1][9],
                         double x[restrict t->nbody + 1][3], double xd[restrict t->nbody + 1][3],
                         double xb[restrict t->nbody + 1][3], double xbd[restrict t->nbody + 1][3],
                         double b[restrict t->nbody][6], double bd[restrict t->nbody][6],
                         double bb[restrict t->nbody][6], double bbd[restrict t->nbody][6])
{
  int i, k, k3, k4, up;
  double A_up0, A_up0_2, A_up0_2b, A_up0_2bd, A_up0_2d, A_up0b, A_up0bd, A_up0d, A_up1, A_up1_2,
      A_up1_2b, A_up1_2bd, A_up1_2d, A_up1b, A_up1bd, A_up1d, A_up2, A_up2_2, A_up2_2b, A_up2_2bd,
      A_up2_2d, A_up2b, A_up2bd, A_up2d, A_up3, A_up3_2, A_up3_2b, A_up3_2bd, A_up3_2d, A_up3b,
      A_up3bd, A_up3d, A_up4, A_up4_2, A_up4_2b, A_up4_2bd, A_up4_2d, A_up4b, A_up4bd, A_up4d,
      A_up5, A_up5_2, A_up5_2b, A_up5_2bd, A_up5_2d, A_up5b, A_up5bd, A_up5d, A_up6, A_up6_2,
      A_up6_2b, A_up6_2bd, A_up6_2d, A_up6b, A_up6bd, A_up6d, A_up7, A_up7_2, A_up7_2b, A_up7_2bd,
      A_up7_2d, A_up7b, A_up7bd, A_up7d, A_up8, A_up8_2, A_up8_2b, A_up8_2bd, A_up8_2d, A_up8b,
      A_up8bd, A_up8d, R0, R0b, R0bd, R0d, R1, R1b, R1bd, R1d, R2, R2b, R2bd, R2d, R3, R3b, R3bd,
      R3d, R4, R4b, R4bd, R4d, R5, R5b, R5bd, R5d, R6, R6b, R6bd, R6d, R7, R7b, R7bd, R7d, R8, R8b,
      R8bd, R8d, angleb, anglebd, axis0_i0, axis0_i0_2, axis0_i0_2b, axis0_i0_2bd, axis0_i0_2d,
      axis0_i0b, axis0_i0bd, axis0_i0d, axis0_i1, axis0_i1_2, axis0_i1_2b, axis0_i1_2bd,
      axis0_i1_2d, axis0_i1b, axis0_i1bd, axis0_i1d, axis0_i2, axis0_i2_2, axis0_i2_2b,
      axis0_i2_2bd, axis0_i2_2d, axis0_i2b, axis0_i2bd, axis0_i2d, c0b, c0bd, c1b, c1bd, c2b, c2bd,
      e0, e0b, e0bd, e0d, e1, e1b, e1bd, e1d, e20b, e20bd, e21b, e21bd, e22b, e22bd, e2_2, e2_2b,
      e2_2bd, e2_2d, e30b, e30bd, e31b, e31bd, e32b, e32bd, offset0_i0, offset0_i0_2, offset0_i0_2b,
      offset0_i0_2bd, offset0_i0_2d, offset0_i0_3, offset0_i0_3b, offset0_i0_3bd, offset0_i0_3d,
      offset0_i0b, offset0_i0bd, offset0_i0d, offset0_i1, offset0_i1_2, offset0_i1_2b,
      offset0_i1_2bd, offset0_i1_2d, offset0_i1_3, offset0_i1_3b, offset0_i1_3bd, offset0_i1_3d,
      offset0_i1b, offset0_i1bd, offset0_i1d, offset0_i2, offset0_i2_2, offset0_i2_2b,
      offset0_i2_2bd, offset0_i2_2d, offset0_i2_3, offset0_i2_3b, offset0_i2_3bd, offset0_i2_3d,
      offset0_i2b, offset0_i2bd, offset0_i2d, q_i, q_i2, q_i2b, q_i2bd, q_i2d, q_ib, q_ibd, q_id,
      tb10, tb10d, tb11, tb11d, tb12, tb12d, tb13, tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d,
      tb17, tb17d, tb18, tb18d, tb19, tb19d, tb2, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d,
      tb7, tb7d, tb8, tb8d, tb9, tb9d, turn_i0, turn_i0b, turn_i0bd, turn_i0d, turn_i1, turn_i1b,
      turn_i1bd, turn_i1d, u0, u0b, u0bd, u0d, u1, u1b, u1bd, u1d, u20, u20b, u20bd, u20d, u21,
      u21b, u21bd, u21d, u22, u22b, u22bd, u22d, u2_2, u2_2b, u2_2bd, u2_2d, v, vb, vbd, vd, vx,
      vxb, vxbd, vxd, vy, vyb, vybd, vyd, vz, vzb, vzbd, vzd, xi0, xi0b, xi0bd, xi0d, xi1, xi1b,
      xi1bd, xi1d, xi2, xi2b, xi2bd, xi2d;

  for (i = 0; i < t->nbody; ++i) {
    up = t->parent[i];
    if (t->joint[i] == MAGGI_ONE_REVOLUTE) {
      turn_i0 = turn[i][0];
      turn_i0d = turnd[i][0];
      turn_i1 = turn[i][1];
      turn_i1d = turnd[i][1];
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
      u0d = bd[i][3];
      u1 = b[i][4];
      u1d = bd[i][4];
      u2_2 = b[i][5];
      u2_2d = bd[i][5];
      xi0 = x[up][0] + e0;
      xi0d = xd[up][0] + e0d;
      xi1 = x[up][1] + e1;
      xi1d = xd[up][1] + e1d;
      xi2 = x[up][2] + e2_2;
      xi2d = xd[up][2] + e2_2d;
      v = 1.0 - turn_i1;
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
      u2_2b = bb[i][5];
      u2_2bd = bbd[i][5];
      bb[i][5] = 0.0;
      bbd[i][5] = 0.0;
      u1b = bb[i][4];
      u1bd = bbd[i][4];
      bb[i][4] = 0.0;
      bbd[i][4] = 0.0;
      u0b = bb[i][3];
      u0bd = bbd[i][3];
      bb[i][3] = 0.0;
      bbd[i][3] = 0.0;
      c2b = bb[i][2];
      c2bd = bbd[i][2];
      bb[i][2] = 0.0;
      bbd[i][2] = 0.0;
      c1b = bb[i][1];
      c1bd = bbd[i][1];
      bb[i][1] = 0.0;
      bbd[i][1] = 0.0;
      c0b = bb[i][0];
      c0bd = bbd[i][0];
      bb[i][0] = 0.0;
      bbd[i][0] = 0.0;
      xi2b = xb[i][2];
      xi2bd = xbd[i][2];
      xb[i][2] = 0.0;
      xbd[i][2] = 0.0;
      xi1b = xb[i][1];
      xi1bd = xbd[i][1];
      xb[i][1] = 0.0;
      xbd[i][1] = 0.0;
      xi0b = xb[i][0];
      xi0bd = xbd[i][0];
      xb[i][0] = 0.0;
      xbd[i][0] = 0.0;
      xi0b += c2b * u1;
      xi0bd += c2bd * u1 + c2b * u1d;
      u1b += c2b * xi0;
      u1bd += c2bd * xi0 + c2b * xi0d;
      xi1b -= c2b * u0;
      xi1bd -= c2bd * u0 + c2b * u0d;
      u0b -= c2b * xi1;
      u0bd -= c2bd * xi1 + c2b * xi1d;
      xi2b += c1b * u0;
      xi2bd += c1bd * u0 + c1b * u0d;
      u0b += c1b * xi2;
      u0bd += c1bd * xi2 + c1b * xi2d;
      xi0b -= c1b * u2_2;
      xi0bd -= c1bd * u2_2 + c1b * u2_2d;
      u2_2b -= c1b * xi0;
      u2_2bd -= c1bd * xi0 + c1b * xi0d;
      xi1b += c0b * u2_2;
      xi1bd += c0bd * u2_2 + c0b * u2_2d;
      u2_2b += c0b * xi1;
      u2_2bd += c0bd * xi1 + c0b * xi1d;
      xi2b -= c0b * u1;
      xi2bd -= c0bd * u1 + c0b * u1d;
      u1b -= c0b * xi2;
      u1bd -= c0bd * xi2 + c0b * xi2d;
      tb13 = Ab[i][8];
      tb13d = Abd[i][8];
      Ab[i][8] = 0.0;
      Abd[i][8] = 0.0;
      A_up6b = tb13 * R2;
      A_up6bd = tb13d * R2 + tb13 * R2d;
      R2b = tb13 * A_up6;
      R2bd = tb13d * A_up6 + tb13 * A_up6d;
      A_up7b = tb13 * R5;
      A_up7bd = tb13d * R5 + tb13 * R5d;
      R5b = tb13 * A_up7;
      R5bd = tb13d * A_up7 + tb13 * A_up7d;
      A_up8b = tb13 * R8;
      A_up8bd = tb13d * R8 + tb13 * R8d;
      R8b = tb13 * A_up8;
      R8bd = tb13d * A_up8 + tb13 * A_up8d;
      tb12 = Ab[i][7];
      tb12d = Abd[i][7];
      Ab[i][7] = 0.0;
      Abd[i][7] = 0.0;
      A_up6b += tb12 * R1;
      A_up6bd += tb12d * R1 + tb12 * R1d;
      R1b = tb12 * A_up6;
      R1bd = tb12d * A_up6 + tb12 * A_up6d;
      A_up7b += tb12 * R4;
      A_up7bd += tb12d * R4 + tb12 * R4d;
      R4b = tb12 * A_up7;
      R4bd = tb12d * A_up7 + tb12 * A_up7d;
      A_up8b += tb12 * R7;
      A_up8bd += tb12d * R7 + tb12 * R7d;
      R7b = tb12 * A_up8;
      R7bd = tb12d * A_up8 + tb12 * A_up8d;
      tb11 = Ab[i][6];
      tb11d = Abd[i][6];
      Ab[i][6] = 0.0;
      Abd[i][6] = 0.0;
      A_up6b += tb11 * R0;
      A_up6bd += tb11d * R0 + tb11 * R0d;
      R0b = tb11 * A_up6;
      R0bd = tb11d * A_up6 + tb11 * A_up6d;
      A_up7b += tb11 * R3;
      A_up7bd += tb11d * R3 + tb11 * R3d;
      R3b = tb11 * A_up7;
      R3bd = tb11d * A_up7 + tb11 * A_up7d;
      A_up8b += tb11 * R6;
      A_up8bd += tb11d * R6 + tb11 * R6d;
      R6b = tb11 * A_up8;
      R6bd = tb11d * A_up8 + tb11 * A_up8d;
      tb10 = Ab[i][5];
      tb10d = Abd[i][5];
      Ab[i][5] = 0.0;
      Abd[i][5] = 0.0;
      A_up3b = tb10 * R2;
      A_up3bd = tb10d * R2 + tb10 * R2d;
      R2b += tb10 * A_up3;
      R2bd += tb10d * A_up3 + tb10 * A_up3d;
      A_up4b = tb10 * R5;
      A_up4bd = tb10d * R5 + tb10 * R5d;
      R5b += tb10 * A_up4;
      R5bd += tb10d * A_up4 + tb10 * A_up4d;
      A_up5b = tb10 * R8;
      A_up5bd = tb10d * R8 + tb10 * R8d;
      R8b += tb10 * A_up5;
      R8bd += tb10d * A_up5 + tb10 * A_up5d;
      tb9 = Ab[i][4];
      tb9d = Abd[i][4];
      Ab[i][4] = 0.0;
      Abd[i][4] = 0.0;
      A_up3b += tb9 * R1;
      A_up3bd += tb9d * R1 + tb9 * R1d;
      R1b += tb9 * A_up3;
      R1bd += tb9d * A_up3 + tb9 * A_up3d;
      A_up4b += tb9 * R4;
      A_up4bd += tb9d * R4 + tb9 * R4d;
      R4b += tb9 * A_up4;
      R4bd += tb9d * A_up4 + tb9 * A_up4d;
      A_up5b += tb9 * R7;
      A_up5bd += tb9d * R7 + tb9 * R7d;
      R7b += tb9 * A_up5;
      R7bd += tb9d * A_up5 + tb9 * A_up5d;
      tb8 = Ab[i][3];
      tb8d = Abd[i][3];
      Ab[i][3] = 0.0;
      Abd[i][3] = 0.0;
      A_up3b += tb8 * R0;
      A_up3bd += tb8d * R0 + tb8 * R0d;
      R0b += tb8 * A_up3;
      R0bd += tb8d * A_up3 + tb8 * A_up3d;
      A_up4b += tb8 * R3;
      A_up4bd += tb8d * R3 + tb8 * R3d;
      R3b += tb8 * A_up4;
      R3bd += tb8d * A_up4 + tb8 * A_up4d;
      A_up5b += tb8 * R6;
      A_up5bd += tb8d * R6 + tb8 * R6d;
      R6b += tb8 * A_up5;
      R6bd += tb8d * A_up5 + tb8 * A_up5d;
      tb7 = Ab[i][2];
      tb7d = Abd[i][2];
      Ab[i][2] = 0.0;
      Abd[i][2] = 0.0;
      A_up0b = tb7 * R2;
      A_up0bd = tb7d * R2 + tb7 * R2d;
      R2b += tb7 * A_up0;
      R2bd += tb7d * A_up0 + tb7 * A_up0d;
      A_up1b = tb7 * R5;
      A_up1bd = tb7d * R5 + tb7 * R5d;
      R5b += tb7 * A_up1;
      R5bd += tb7d * A_up1 + tb7 * A_up1d;
      A_up2b = tb7 * R8;
      A_up2bd = tb7d * R8 + tb7 * R8d;
      R8b += tb7 * A_up2;
      R8bd += tb7d * A_up2 + tb7 * A_up2d;
      tb6 = Ab[i][1];
      tb6d = Abd[i][1];
      Ab[i][1] = 0.0;
      Abd[i][1] = 0.0;
      A_up0b += tb6 * R1;
      A_up0bd += tb6d * R1 + tb6 * R1d;
      R1b += tb6 * A_up0;
      R1bd += tb6d * A_up0 + tb6 * A_up0d;
      A_up1b += tb6 * R4;
      A_up1bd += tb6d * R4 + tb6 * R4d;
      R4b += tb6 * A_up1;
      R4bd += tb6d * A_up1 + tb6 * A_up1d;
      A_up2b += tb6 * R7;
      A_up2bd += tb6d * R7 + tb6 * R7d;
      R7b += tb6 * A_up2;
      R7bd += tb6d * A_up2 + tb6 * A_up2d;
      tb5 = Ab[i][0];
      tb5d = Abd[i][0];
      Ab[i][0] = 0.0;
      Abd[i][0] = 0.0;
      A_up0b += tb5 * R0;
      A_up0bd += tb5d * R0 + tb5 * R0d;
      R0b += tb5 * A_up0;
      R0bd += tb5d * A_up0 + tb5 * A_up0d;
      A_up1b += tb5 * R3;
      A_up1bd += tb5d * R3 + tb5 * R3d;
      R3b += tb5 * A_up1;
      R3bd += tb5d * A_up1 + tb5 * A_up1d;
      A_up2b += tb5 * R6;
      A_up2bd += tb5d * R6 + tb5 * R6d;
      R6b += tb5 * A_up2;
      R6bd += tb5d * A_up2 + tb5 * A_up2d;
      turn_i1b = R8b;
      turn_i1bd = R8bd;
      vzb = R8b * axis0_i2;
      vzbd = R8bd * axis0_i2 + R8b * axis0_i2d;
      axis0_i2b = R8b * vz;
      axis0_i2bd = R8bd * vz + R8b * vzd;
      vyb = R7b * axis0_i2;
      vybd = R7bd * axis0_i2 + R7b * axis0_i2d;
      axis0_i2b += R7b * vy;
      axis0_i2bd += R7bd * vy + R7b * vyd;
      turn_i0b = R7b * axis0_i0;
      turn_i0bd = R7bd * axis0_i0 + R7b * axis0_i0d;
      axis0_i0b = R7b * turn_i0;
      axis0_i0bd = R7bd * turn_i0 + R7b * turn_i0d;
      vxb = R6b * axis0_i2;
      vxbd = R6bd * axis0_i2 + R6b * axis0_i2d;
      axis0_i2b += R6b * vx;
      axis0_i2bd += R6bd * vx + R6b * vxd;
      turn_i0b -= R6b * axis0_i1;
      turn_i0bd -= R6bd * axis0_i1 + R6b * axis0_i1d;
      axis0_i1b = -(R6b * turn_i0);
      axis0_i1bd = -(R6bd * turn_i0 + R6b * turn_i0d);
      vyb += R5b * axis0_i2;
      vybd += R5bd * axis0_i2 + R5b * axis0_i2d;
      axis0_i2b += R5b * vy;
      axis0_i2bd += R5bd * vy + R5b * vyd;
      turn_i0b -= R5b * axis0_i0;
      turn_i0bd -= R5bd * axis0_i0 + R5b * axis0_i0d;
      axis0_i0b -= R5b * turn_i0;
      axis0_i0bd -= R5bd * turn_i0 + R5b * turn_i0d;
      turn_i1b += R4b;
      turn_i1bd += R4bd;
      vyb += R4b * axis0_i1;
      vybd += R4bd * axis0_i1 + R4b * axis0_i1d;
      axis0_i1b += R4b * vy;
      axis0_i1bd += R4bd * vy + R4b * vyd;
      vxb += R3b * axis0_i1;
      vxbd += R3bd * axis0_i1 + R3b * axis0_i1d;
      axis0_i1b += R3b * vx;
      axis0_i1bd += R3bd * vx + R3b * vxd;
      turn_i0b += R3b * axis0_i2;
      turn_i0bd += R3bd * axis0_i2 + R3b * axis0_i2d;
      axis0_i2b += R3b * turn_i0;
      axis0_i2bd += R3bd * turn_i0 + R3b * turn_i0d;
      vxb += R2b * axis0_i2;
      vxbd += R2bd * axis0_i2 + R2b * axis0_i2d;
      axis0_i2b += R2b * vx;
      axis0_i2bd += R2bd * vx + R2b * vxd;
      turn_i0b += R2b * axis0_i1;
      turn_i0bd += R2bd * axis0_i1 + R2b * axis0_i1d;
      axis0_i1b += R2b * turn_i0;
      axis0_i1bd += R2bd * turn_i0 + R2b * turn_i0d;
      vxb += R1b * axis0_i1;
      vxbd += R1bd * axis0_i1 + R1b * axis0_i1d;
      axis0_i1b += R1b * vx;
      axis0_i1bd += R1bd * vx + R1b * vxd;
      turn_i0b -= R1b * axis0_i2;
      turn_i0bd -= R1bd * axis0_i2 + R1b * axis0_i2d;
      axis0_i2b -= R1b * turn_i0;
      axis0_i2bd -= R1bd * turn_i0 + R1b * turn_i0d;
      turn_i1b += R0b;
      turn_i1bd += R0bd;
      vxb += R0b * axis0_i0;
      vxbd += R0bd * axis0_i0 + R0b * axis0_i0d;
      axis0_i0b += R0b * vx;
      axis0_i0bd += R0bd * vx + R0b * vxd;
      vb = vzb * axis0_i2;
      vbd = vzbd * axis0_i2 + vzb * axis0_i2d;
      axis0_i2b += vzb * v;
      axis0_i2bd += vzbd * v + vzb * vd;
      vb += vyb * axis0_i1;
      vbd += vybd * axis0_i1 + vyb * axis0_i1d;
      axis0_i1b += vyb * v;
      axis0_i1bd += vybd * v + vyb * vd;
      vb += vxb * axis0_i0;
      vbd += vxbd * axis0_i0 + vxb * axis0_i0d;
      axis0_i0b += vxb * v;
      axis0_i0bd += vxbd * v + vxb * vd;
      turn_i1b -= vb;
      /* A = Ap Rot(u, q),  Rot = c I + s u~ + (1 - c) u u^T */
      turn_i1bd -= vbd;
      xb[up][2] += xi2b;
      xbd[up][2] += xi2bd;
      e2_2b = xi2b;
      e2_2bd = xi2bd;
      xb[up][1] += xi1b;
      xbd[up][1] += xi1bd;
      e1b = xi1b;
      e1bd = xi1bd;
      xb[up][0] += xi0b;
      xbd[up][0] += xi0bd;
      e0b = xi0b;
      e0bd = xi0bd;
      A_up6b += u2_2b * axis0_i0;
      A_up6bd += u2_2bd * axis0_i0 + u2_2b * axis0_i0d;
      axis0_i0b += u2_2b * A_up6;
      axis0_i0bd += u2_2bd * A_up6 + u2_2b * A_up6d;
      A_up7b += u2_2b * axis0_i1;
      A_up7bd += u2_2bd * axis0_i1 + u2_2b * axis0_i1d;
      axis0_i1b += u2_2b * A_up7;
      axis0_i1bd += u2_2bd * A_up7 + u2_2b * A_up7d;
      A_up8b += u2_2b * axis0_i2;
      A_up8bd += u2_2bd * axis0_i2 + u2_2b * axis0_i2d;
      axis0_i2b += u2_2b * A_up8;
      axis0_i2bd += u2_2bd * A_up8 + u2_2b * A_up8d;
      A_up3b += u1b * axis0_i0;
      A_up3bd += u1bd * axis0_i0 + u1b * axis0_i0d;
      axis0_i0b += u1b * A_up3;
      axis0_i0bd += u1bd * A_up3 + u1b * A_up3d;
      A_up4b += u1b * axis0_i1;
      A_up4bd += u1bd * axis0_i1 + u1b * axis0_i1d;
      axis0_i1b += u1b * A_up4;
      axis0_i1bd += u1bd * A_up4 + u1b * A_up4d;
      A_up5b += u1b * axis0_i2;
      A_up5bd += u1bd * axis0_i2 + u1b * axis0_i2d;
      axis0_i2b += u1b * A_up5;
      axis0_i2bd += u1bd * A_up5 + u1b * A_up5d;
      A_up0b += u0b * axis0_i0;
      A_up0bd += u0bd * axis0_i0 + u0b * axis0_i0d;
      axis0_i0b += u0b * A_up0;
      axis0_i0bd += u0bd * A_up0 + u0b * A_up0d;
      A_up1b += u0b * axis0_i1;
      A_up1bd += u0bd * axis0_i1 + u0b * axis0_i1d;
      axis0_i1b += u0b * A_up1;
      axis0_i1bd += u0bd * A_up1 + u0b * A_up1d;
      A_up2b += u0b * axis0_i2;
      A_up2bd += u0bd * axis0_i2 + u0b * axis0_i2d;
      axis0_i2b += u0b * A_up2;
      axis0_i2bd += u0bd * A_up2 + u0b * A_up2d;
      axis0b[i][2] += axis0_i2b;
      axis0bd[i][2] += axis0_i2bd;
      axis0b[i][1] += axis0_i1b;
      axis0bd[i][1] += axis0_i1bd;
      axis0b[i][0] += axis0_i0b;
      axis0bd[i][0] += axis0_i0bd;
      A_up6b += e2_2b * offset0_i0;
      A_up6bd += e2_2bd * offset0_i0 + e2_2b * offset0_i0d;
      offset0_i0b = e2_2b * A_up6;
      offset0_i0bd = e2_2bd * A_up6 + e2_2b * A_up6d;
      A_up7b += e2_2b * offset0_i1;
      A_up7bd += e2_2bd * offset0_i1 + e2_2b * offset0_i1d;
      offset0_i1b = e2_2b * A_up7;
      offset0_i1bd = e2_2bd * A_up7 + e2_2b * A_up7d;
      A_up8b += e2_2b * offset0_i2;
      A_up8bd += e2_2bd * offset0_i2 + e2_2b * offset0_i2d;
      offset0_i2b = e2_2b * A_up8;
      offset0_i2bd = e2_2bd * A_up8 + e2_2b * A_up8d;
      Ab[up][8] += A_up8b;
      Abd[up][8] += A_up8bd;
      Ab[up][7] += A_up7b;
      Abd[up][7] += A_up7bd;
      Ab[up][6] += A_up6b;
      Abd[up][6] += A_up6bd;
      A_up3b += e1b * offset0_i0;
      A_up3bd += e1bd * offset0_i0 + e1b * offset0_i0d;
      offset0_i0b += e1b * A_up3;
      offset0_i0bd += e1bd * A_up3 + e1b * A_up3d;
      A_up4b += e1b * offset0_i1;
      A_up4bd += e1bd * offset0_i1 + e1b * offset0_i1d;
      offset0_i1b += e1b * A_up4;
      offset0_i1bd += e1bd * A_up4 + e1b * A_up4d;
      A_up5b += e1b * offset0_i2;
      A_up5bd += e1bd * offset0_i2 + e1b * offset0_i2d;
      offset0_i2b += e1b * A_up5;
      offset0_i2bd += e1bd * A_up5 + e1b * A_up5d;
      Ab[up][5] += A_up5b;
      Abd[up][5] += A_up5bd;
      Ab[up][4] += A_up4b;
      Abd[up][4] += A_up4bd;
      Ab[up][3] += A_up3b;
      Abd[up][3] += A_up3bd;
      A_up0b += e0b * offset0_i0;
      /* b = (x × u, u) */
      A_up0bd += e0bd * offset0_i0 + e0b * offset0_i0d;
      offset0_i0b += e0b * A_up0;
      offset0_i0bd += e0bd * A_up0 + e0b * A_up0d;
      A_up1b += e0b * offset0_i1;
      A_up1bd += e0bd * offset0_i1 + e0b * offset0_i1d;
      offset0_i1b += e0b * A_up1;
      offset0_i1bd += e0bd * A_up1 + e0b * A_up1d;
      A_up2b += e0b * offset0_i2;
      A_up2bd += e0bd * offset0_i2 + e0b * offset0_i2d;
      offset0_i2b += e0b * A_up2;
      offset0_i2bd += e0bd * A_up2 + e0b * A_up2d;
      offset0b[i][2] += offset0_i2b;
      offset0bd[i][2] += offset0_i2bd;
      Ab[up][2] += A_up2b;
      Abd[up][2] += A_up2bd;
      offset0b[i][1] += offset0_i1b;
      offset0bd[i][1] += offset0_i1bd;
      Ab[up][1] += A_up1b;
      Abd[up][1] += A_up1bd;
      offset0b[i][0] += offset0_i0b;
      offset0bd[i][0] += offset0_i0bd;
      Ab[up][0] += A_up0b;
      Abd[up][0] += A_up0bd;
      turn_i1b += turnb[i][1];
      turn_i1bd += turnbd[i][1];
      turnb[i][1] = 0.0;
      turnbd[i][1] = 0.0;
      angleb = -(turn_i1b * turn[i][0]);
      anglebd = -(turn_i1bd * turn[i][0] + turn_i1b * turnd[i][0]);
      turn_i0b += turnb[i][0];
      turn_i0bd += turnbd[i][0];
      turnb[i][0] = 0.0;
      turnbd[i][0] = 0.0;
      angleb += turn_i0b * turn[i][1];
      anglebd += turn_i0bd * turn[i][1] + turn_i0b * turnd[i][1];
      qb[t->qid[i]] += angleb;
      qbd[t->qid[i]] += anglebd;
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
      A_up3_2 = A[up][3];
      A_up3_2d = Ad[up][3];
      A_up4_2 = A[up][4];
      A_up4_2d = Ad[up][4];
      A_up5_2 = A[up][5];
      A_up5_2d = Ad[up][5];
      A_up6_2 = A[up][6];
      A_up6_2d = Ad[up][6];
      A_up7_2 = A[up][7];
      A_up7_2d = Ad[up][7];
      A_up8_2 = A[up][8];
      A_up8_2d = Ad[up][8];
      axis0_i0_2 = axis0[i][0];
      axis0_i0_2d = axis0d[i][0];
      axis0_i1_2 = axis0[i][1];
      axis0_i1_2d = axis0d[i][1];
      axis0_i2_2 = axis0[i][2];
      axis0_i2_2d = axis0d[i][2];
      u20 = b[i][0];
      u20d = bd[i][0];
      u21 = b[i][1];
      u21d = bd[i][1];
      u22 = b[i][2];
      u22d = bd[i][2];
      q_i2 = q[t->qid[i]];
      q_i2d = qd[t->qid[i]];
      bb[i][5] = 0.0;
      bbd[i][5] = 0.0;
      u22b = bb[i][2];
      u22bd = bbd[i][2];
      bb[i][2] = 0.0;
      bbd[i][2] = 0.0;
      tb16 = xb[i][2];
      tb16d = xbd[i][2];
      xb[i][2] = 0.0;
      xbd[i][2] = 0.0;
      xb[up][2] += tb16;
      xbd[up][2] += tb16d;
      e22b = tb16;
      e22bd = tb16d;
      u22b += tb16 * q_i2;
      u22bd += tb16d * q_i2 + tb16 * q_i2d;
      q_i2b = tb16 * u22;
      q_i2bd = tb16d * u22 + tb16 * u22d;
      bb[i][4] = 0.0;
      bbd[i][4] = 0.0;
      u21b = bb[i][1];
      u21bd = bbd[i][1];
      bb[i][1] = 0.0;
      bbd[i][1] = 0.0;
      tb15 = xb[i][1];
      tb15d = xbd[i][1];
      xb[i][1] = 0.0;
      xbd[i][1] = 0.0;
      xb[up][1] += tb15;
      xbd[up][1] += tb15d;
      e21b = tb15;
      e21bd = tb15d;
      u21b += tb15 * q_i2;
      u21bd += tb15d * q_i2 + tb15 * q_i2d;
      q_i2b += tb15 * u21;
      q_i2bd += tb15d * u21 + tb15 * u21d;
      bb[i][3] = 0.0;
      bbd[i][3] = 0.0;
      u20b = bb[i][0];
      u20bd = bbd[i][0];
      bb[i][0] = 0.0;
      bbd[i][0] = 0.0;
      tb14 = xb[i][0];
      tb14d = xbd[i][0];
      xb[i][0] = 0.0;
      xbd[i][0] = 0.0;
      xb[up][0] += tb14;
      xbd[up][0] += tb14d;
      e20b = tb14;
      e20bd = tb14d;
      u20b += tb14 * q_i2;
      u20bd += tb14d * q_i2 + tb14 * q_i2d;
      q_i2b += tb14 * u20;
      q_i2bd += tb14d * u20 + tb14 * u20d;
      qb[t->qid[i]] += q_i2b;
      qbd[t->qid[i]] += q_i2bd;
      for (k3 = 8; k3 >= 0; --k3) {
        Abd[up][k3] += Abd[i][k3];
        Ab[up][k3] += Ab[i][k3];
        Ab[i][k3] = 0.0;
        Abd[i][k3] = 0.0;
      }
      A_up6_2b = u22b * axis0_i0_2;
      A_up6_2bd = u22bd * axis0_i0_2 + u22b * axis0_i0_2d;
      axis0_i0_2b = u22b * A_up6_2;
      axis0_i0_2bd = u22bd * A_up6_2 + u22b * A_up6_2d;
      A_up7_2b = u22b * axis0_i1_2;
      A_up7_2bd = u22bd * axis0_i1_2 + u22b * axis0_i1_2d;
      axis0_i1_2b = u22b * A_up7_2;
      axis0_i1_2bd = u22bd * A_up7_2 + u22b * A_up7_2d;
      A_up8_2b = u22b * axis0_i2_2;
      A_up8_2bd = u22bd * axis0_i2_2 + u22b * axis0_i2_2d;
      axis0_i2_2b = u22b * A_up8_2;
      axis0_i2_2bd = u22bd * A_up8_2 + u22b * A_up8_2d;
      A_up3_2b = u21b * axis0_i0_2;
      A_up3_2bd = u21bd * axis0_i0_2 + u21b * axis0_i0_2d;
      axis0_i0_2b += u21b * A_up3_2;
      axis0_i0_2bd += u21bd * A_up3_2 + u21b * A_up3_2d;
      A_up4_2b = u21b * axis0_i1_2;
      A_up4_2bd = u21bd * axis0_i1_2 + u21b * axis0_i1_2d;
      axis0_i1_2b += u21b * A_up4_2;
      axis0_i1_2bd += u21bd * A_up4_2 + u21b * A_up4_2d;
      A_up5_2b = u21b * axis0_i2_2;
      A_up5_2bd = u21bd * axis0_i2_2 + u21b * axis0_i2_2d;
      axis0_i2_2b += u21b * A_up5_2;
      axis0_i2_2bd += u21bd * A_up5_2 + u21b * A_up5_2d;
      A_up0_2b = u20b * axis0_i0_2;
      A_up0_2bd = u20bd * axis0_i0_2 + u20b * axis0_i0_2d;
      axis0_i0_2b += u20b * A_up0_2;
      axis0_i0_2bd += u20bd * A_up0_2 + u20b * A_up0_2d;
      A_up1_2b = u20b * axis0_i1_2;
      A_up1_2bd = u20bd * axis0_i1_2 + u20b * axis0_i1_2d;
      axis0_i1_2b += u20b * A_up1_2;
      axis0_i1_2bd += u20bd * A_up1_2 + u20b * A_up1_2d;
      A_up2_2b = u20b * axis0_i2_2;
      A_up2_2bd = u20bd * axis0_i2_2 + u20b * axis0_i2_2d;
      axis0_i2_2b += u20b * A_up2_2;
      axis0_i2_2bd += u20bd * A_up2_2 + u20b * A_up2_2d;
      axis0b[i][2] += axis0_i2_2b;
      axis0bd[i][2] += axis0_i2_2bd;
      axis0b[i][1] += axis0_i1_2b;
      axis0bd[i][1] += axis0_i1_2bd;
      axis0b[i][0] += axis0_i0_2b;
      axis0bd[i][0] += axis0_i0_2bd;
      A_up6_2b += e22b * offset0_i0_2;
      A_up6_2bd += e22bd * offset0_i0_2 + e22b * offset0_i0_2d;
      offset0_i0_2b = e22b * A_up6_2;
      offset0_i0_2bd = e22bd * A_up6_2 + e22b * A_up6_2d;
      A_up7_2b += e22b * offset0_i1_2;
      A_up7_2bd += e22bd * offset0_i1_2 + e22b * offset0_i1_2d;
      offset0_i1_2b = e22b * A_up7_2;
      offset0_i1_2bd = e22bd * A_up7_2 + e22b * A_up7_2d;
      A_up8_2b += e22b * offset0_i2_2;
      A_up8_2bd += e22bd * offset0_i2_2 + e22b * offset0_i2_2d;
      offset0_i2_2b = e22b * A_up8_2;
      offset0_i2_2bd = e22bd * A_up8_2 + e22b * A_up8_2d;
      Ab[up][8] += A_up8_2b;
      Abd[up][8] += A_up8_2bd;
      Ab[up][7] += A_up7_2b;
      Abd[up][7] += A_up7_2bd;
      Ab[up][6] += A_up6_2b;
      Abd[up][6] += A_up6_2bd;
      A_up3_2b += e21b * offset0_i0_2;
      A_up3_2bd += e21bd * offset0_i0_2 + e21b * offset0_i0_2d;
      offset0_i0_2b += e21b * A_up3_2;
      offset0_i0_2bd += e21bd * A_up3_2 + e21b * A_up3_2d;
      A_up4_2b += e21b * offset0_i1_2;
      A_up4_2bd += e21bd * offset0_i1_2 + e21b * offset0_i1_2d;
      offset0_i1_2b += e21b * A_up4_2;
      offset0_i1_2bd += e21bd * A_up4_2 + e21b * A_up4_2d;
      A_up5_2b += e21b * offset0_i2_2;
      A_up5_2bd += e21bd * offset0_i2_2 + e21b * offset0_i2_2d;
      offset0_i2_2b += e21b * A_up5_2;
      offset0_i2_2bd += e21bd * A_up5_2 + e21b * A_up5_2d;
      Ab[up][5] += A_up5_2b;
      Abd[up][5] += A_up5_2bd;
      Ab[up][4] += A_up4_2b;
      Abd[up][4] += A_up4_2bd;
      Ab[up][3] += A_up3_2b;
      Abd[up][3] += A_up3_2bd;
      A_up0_2b += e20b * offset0_i0_2;
      /* b = (u, 0) */
      A_up0_2bd += e20bd * offset0_i0_2 + e20b * offset0_i0_2d;
      offset0_i0_2b += e20b * A_up0_2;
      offset0_i0_2bd += e20bd * A_up0_2 + e20b * A_up0_2d;
      A_up1_2b += e20b * offset0_i1_2;
      A_up1_2bd += e20bd * offset0_i1_2 + e20b * offset0_i1_2d;
      offset0_i1_2b += e20b * A_up1_2;
      offset0_i1_2bd += e20bd * A_up1_2 + e20b * A_up1_2d;
      A_up2_2b += e20b * offset0_i2_2;
      A_up2_2bd += e20bd * offset0_i2_2 + e20b * offset0_i2_2d;
      offset0_i2_2b += e20b * A_up2_2;
      offset0_i2_2bd += e20bd * A_up2_2 + e20b * A_up2_2d;
      offset0b[i][2] += offset0_i2_2b;
      offset0bd[i][2] += offset0_i2_2bd;
      Ab[up][2] += A_up2_2b;
      Abd[up][2] += A_up2_2bd;
      offset0b[i][1] += offset0_i1_2b;
      offset0bd[i][1] += offset0_i1_2bd;
      Ab[up][1] += A_up1_2b;
      Abd[up][1] += A_up1_2bd;
      offset0b[i][0] += offset0_i0_2b;
      offset0bd[i][0] += offset0_i0_2bd;
      Ab[up][0] += A_up0_2b;
      Abd[up][0] += A_up0_2bd;
    } else {
      offset0_i0_3 = offset0[i][0];
      offset0_i0_3d = offset0d[i][0];
      offset0_i1_3 = offset0[i][1];
      offset0_i1_3d = offset0d[i][1];
      offset0_i2_3 = offset0[i][2];
      offset0_i2_3d = offset0d[i][2];
      bb[i][5] = 0.0;
      bbd[i][5] = 0.0;
      bb[i][2] = 0.0;
      bbd[i][2] = 0.0;
      tb19 = xb[i][2];
      tb19d = xbd[i][2];
      xb[i][2] = 0.0;
      xbd[i][2] = 0.0;
      xb[up][2] += tb19;
      xbd[up][2] += tb19d;
      e32b = tb19;
      e32bd = tb19d;
      bb[i][4] = 0.0;
      bbd[i][4] = 0.0;
      bb[i][1] = 0.0;
      bbd[i][1] = 0.0;
      tb18 = xb[i][1];
      tb18d = xbd[i][1];
      xb[i][1] = 0.0;
      xbd[i][1] = 0.0;
      xb[up][1] += tb18;
      xbd[up][1] += tb18d;
      e31b = tb18;
      e31bd = tb18d;
      bb[i][3] = 0.0;
      bbd[i][3] = 0.0;
      bb[i][0] = 0.0;
      bbd[i][0] = 0.0;
      tb17 = xb[i][0];
      tb17d = xbd[i][0];
      xb[i][0] = 0.0;
      xbd[i][0] = 0.0;
      xb[up][0] += tb17;
      xbd[up][0] += tb17d;
      e30b = tb17;
      e30bd = tb17d;
      for (k4 = 8; k4 >= 0; --k4) {
        Abd[up][k4] += Abd[i][k4];
        Ab[up][k4] += Ab[i][k4];
        Ab[i][k4] = 0.0;
        Abd[i][k4] = 0.0;
      }
      Ab[up][6] += e32b * offset0_i0_3;
      Abd[up][6] += e32bd * offset0_i0_3 + e32b * offset0_i0_3d;
      offset0_i0_3b = e32b * A[up][6];
      offset0_i0_3bd = e32bd * A[up][6] + e32b * Ad[up][6];
      Ab[up][7] += e32b * offset0_i1_3;
      Abd[up][7] += e32bd * offset0_i1_3 + e32b * offset0_i1_3d;
      offset0_i1_3b = e32b * A[up][7];
      offset0_i1_3bd = e32bd * A[up][7] + e32b * Ad[up][7];
      Ab[up][8] += e32b * offset0_i2_3;
      Abd[up][8] += e32bd * offset0_i2_3 + e32b * offset0_i2_3d;
      offset0_i2_3b = e32b * A[up][8];
      offset0_i2_3bd = e32bd * A[up][8] + e32b * Ad[up][8];
      Ab[up][3] += e31b * offset0_i0_3;
      Abd[up][3] += e31bd * offset0_i0_3 + e31b * offset0_i0_3d;
      offset0_i0_3b += e31b * A[up][3];
      offset0_i0_3bd += e31bd * A[up][3] + e31b * Ad[up][3];
      Ab[up][4] += e31b * offset0_i1_3;
      Abd[up][4] += e31bd * offset0_i1_3 + e31b * offset0_i1_3d;
      offset0_i1_3b += e31b * A[up][4];
      offset0_i1_3bd += e31bd * A[up][4] + e31b * Ad[up][4];
      Ab[up][5] += e31b * offset0_i2_3;
      Abd[up][5] += e31bd * offset0_i2_3 + e31b * offset0_i2_3d;
      offset0_i2_3b += e31b * A[up][5];
      offset0_i2_3bd += e31bd * A[up][5] + e31b * Ad[up][5];
      Ab[up][0] += e30b * offset0_i0_3;
      Abd[up][0] += e30bd * offset0_i0_3 + e30b * offset0_i0_3d;
      offset0_i0_3b += e30b * A[up][0];
      offset0_i0_3bd += e30bd * A[up][0] + e30b * Ad[up][0];
      Ab[up][1] += e30b * offset0_i1_3;
      Abd[up][1] += e30bd * offset0_i1_3 + e30b * offset0_i1_3d;
      offset0_i1_3b += e30b * A[up][1];
      offset0_i1_3bd += e30bd * A[up][1] + e30b * Ad[up][1];
      Ab[up][2] += e30b * offset0_i2_3;
      Abd[up][2] += e30bd * offset0_i2_3 + e30b * offset0_i2_3d;
      offset0_i2_3b += e30b * A[up][2];
      offset0_i2_3bd += e30bd * A[up][2] + e30b * Ad[up][2];
      offset0b[i][2] += offset0_i2_3b;
      offset0bd[i][2] += offset0_i2_3bd;
      offset0b[i][1] += offset0_i1_3b;
      offset0bd[i][1] += offset0_i1_3bd;
      offset0b[i][0] += offset0_i0_3b;
      offset0bd[i][0] += offset0_i0_3bd;
    }
  }
  for (i = t->nbase - 1; i >= 0; --i) {
    q_i = q[t->qid[t->base[i]]];
    q_id = qd[t->qid[t->base[i]]];
    tb4 = xb[t->nbody][2];
    tb4d = xbd[t->nbody][2];
    axis0b[t->base[i]][2] -= tb4 * q_i;
    axis0bd[t->base[i]][2] -= tb4d * q_i + tb4 * q_id;
    q_ib = -(tb4 * axis0[t->base[i]][2]);
    q_ibd = -(tb4d * axis0[t->base[i]][2] + tb4 * axis0d[t->base[i]][2]);
    tb3 = xb[t->nbody][1];
    tb3d = xbd[t->nbody][1];
    axis0b[t->base[i]][1] -= tb3 * q_i;
    axis0bd[t->base[i]][1] -= tb3d * q_i + tb3 * q_id;
    q_ib -= tb3 * axis0[t->base[i]][1];
    q_ibd -= tb3d * axis0[t->base[i]][1] + tb3 * axis0d[t->base[i]][1];
    tb2 = xb[t->nbody][0];
    tb2d = xbd[t->nbody][0];
    axis0b[t->base[i]][0] -= tb2 * q_i;
    axis0bd[t->base[i]][0] -= tb2d * q_i + tb2 * q_id;
    q_ib -= tb2 * axis0[t->base[i]][0];
    q_ibd -= tb2d * axis0[t->base[i]][0] + tb2 * axis0d[t->base[i]][0];
    qb[t->qid[t->base[i]]] += q_ib;
    qbd[t->qid[t->base[i]]] += q_ibd;
  }
  xb[t->nbody][2] = 0.0;
  xbd[t->nbody][2] = 0.0;
  xb[t->nbody][1] = 0.0;
  xbd[t->nbody][1] = 0.0;
  xb[t->nbody][0] = 0.0;
  xbd[t->nbody][0] = 0.0;
  for (k = 8; k >= 0; --k) {
    Ab[t->nbody][k] = 0.0;
    Abd[t->nbody][k] = 0.0;
  }
}

/* r = x + A point0 */
void maggi_points_b_d(const maggi_topo *t, int begin, int end,
                      const double point0[restrict t->npoint][3],
                      const double point0d[restrict t->npoint][3],
                      double point0b[restrict t->npoint][3], double point0bd[restrict t->npoint][3],
                      const double A[restrict t->nbody + 1][9],
                      const double Ad[restrict t->nbody + 1][9],
                      double Ab[restrict t->nbody + 1][9], double Abd[restrict t->nbody + 1][9],
                      const double x[restrict t->nbody + 1][3],
                      const double xd[restrict t->nbody + 1][3],
                      double xb[restrict t->nbody + 1][3], double xbd[restrict t->nbody + 1][3],
                      double r[restrict t->npoint][3], double rd[restrict t->npoint][3],
                      double rb[restrict t->npoint][3], double rbd[restrict t->npoint][3])
{
  int i;
  double e0b, e0bd, e1b, e1bd, e2b, e2bd, point0_i0, point0_i0b, point0_i0bd, point0_i0d, point0_i1,
      point0_i1b, point0_i1bd, point0_i1d, point0_i2, point0_i2b, point0_i2bd, point0_i2d, tb2,
      tb2d, tb3, tb3d, tb4, tb4d;

  (void)x;
  (void)xd;
  (void)r;
  (void)rd;
  for (i = end - 1; i >= begin; --i) {
    point0_i0 = point0[i][0];
    point0_i0d = point0d[i][0];
    point0_i1 = point0[i][1];
    point0_i1d = point0d[i][1];
    point0_i2 = point0[i][2];
    point0_i2d = point0d[i][2];
    tb4 = rb[i][2];
    tb4d = rbd[i][2];
    rb[i][2] = 0.0;
    rbd[i][2] = 0.0;
    xb[t->pointbody[i]][2] += tb4;
    xbd[t->pointbody[i]][2] += tb4d;
    e2b = tb4;
    e2bd = tb4d;
    tb3 = rb[i][1];
    tb3d = rbd[i][1];
    rb[i][1] = 0.0;
    rbd[i][1] = 0.0;
    xb[t->pointbody[i]][1] += tb3;
    xbd[t->pointbody[i]][1] += tb3d;
    e1b = tb3;
    e1bd = tb3d;
    tb2 = rb[i][0];
    tb2d = rbd[i][0];
    rb[i][0] = 0.0;
    rbd[i][0] = 0.0;
    xb[t->pointbody[i]][0] += tb2;
    xbd[t->pointbody[i]][0] += tb2d;
    e0b = tb2;
    e0bd = tb2d;
    Ab[t->pointbody[i]][6] += e2b * point0_i0;
    Abd[t->pointbody[i]][6] += e2bd * point0_i0 + e2b * point0_i0d;
    point0_i0b = e2b * A[t->pointbody[i]][6];
    point0_i0bd = e2bd * A[t->pointbody[i]][6] + e2b * Ad[t->pointbody[i]][6];
    Ab[t->pointbody[i]][7] += e2b * point0_i1;
    Abd[t->pointbody[i]][7] += e2bd * point0_i1 + e2b * point0_i1d;
    point0_i1b = e2b * A[t->pointbody[i]][7];
    point0_i1bd = e2bd * A[t->pointbody[i]][7] + e2b * Ad[t->pointbody[i]][7];
    Ab[t->pointbody[i]][8] += e2b * point0_i2;
    Abd[t->pointbody[i]][8] += e2bd * point0_i2 + e2b * point0_i2d;
    point0_i2b = e2b * A[t->pointbody[i]][8];
    point0_i2bd = e2bd * A[t->pointbody[i]][8] + e2b * Ad[t->pointbody[i]][8];
    Ab[t->pointbody[i]][3] += e1b * point0_i0;
    Abd[t->pointbody[i]][3] += e1bd * point0_i0 + e1b * point0_i0d;
    point0_i0b += e1b * A[t->pointbody[i]][3];
    point0_i0bd += e1bd * A[t->pointbody[i]][3] + e1b * Ad[t->pointbody[i]][3];
    Ab[t->pointbody[i]][4] += e1b * point0_i1;
    Abd[t->pointbody[i]][4] += e1bd * point0_i1 + e1b * point0_i1d;
    point0_i1b += e1b * A[t->pointbody[i]][4];
    point0_i1bd += e1bd * A[t->pointbody[i]][4] + e1b * Ad[t->pointbody[i]][4];
    Ab[t->pointbody[i]][5] += e1b * point0_i2;
    Abd[t->pointbody[i]][5] += e1bd * point0_i2 + e1b * point0_i2d;
    point0_i2b += e1b * A[t->pointbody[i]][5];
    point0_i2bd += e1bd * A[t->pointbody[i]][5] + e1b * Ad[t->pointbody[i]][5];
    Ab[t->pointbody[i]][0] += e0b * point0_i0;
    Abd[t->pointbody[i]][0] += e0bd * point0_i0 + e0b * point0_i0d;
    point0_i0b += e0b * A[t->pointbody[i]][0];
    point0_i0bd += e0bd * A[t->pointbody[i]][0] + e0b * Ad[t->pointbody[i]][0];
    Ab[t->pointbody[i]][1] += e0b * point0_i1;
    Abd[t->pointbody[i]][1] += e0bd * point0_i1 + e0b * point0_i1d;
    point0_i1b += e0b * A[t->pointbody[i]][1];
    point0_i1bd += e0bd * A[t->pointbody[i]][1] + e0b * Ad[t->pointbody[i]][1];
    Ab[t->pointbody[i]][2] += e0b * point0_i2;
    Abd[t->pointbody[i]][2] += e0bd * point0_i2 + e0b * point0_i2d;
    point0_i2b += e0b * A[t->pointbody[i]][2];
    point0_i2bd += e0bd * A[t->pointbody[i]][2] + e0b * Ad[t->pointbody[i]][2];
    point0b[i][2] += point0_i2b;
    point0bd[i][2] += point0_i2bd;
    point0b[i][1] += point0_i1b;
    point0bd[i][1] += point0_i1bd;
    point0b[i][0] += point0_i0b;
    point0bd[i][0] += point0_i0bd;
  }
}

void maggi_directions_b_d(const maggi_topo *t, const double dir0[restrict t->ndir][3],
                          const double dir0d[restrict t->ndir][3],
                          double dir0b[restrict t->ndir][3], double dir0bd[restrict t->ndir][3],
                          const double A[restrict t->nbody + 1][9],
                          const double Ad[restrict t->nbody + 1][9],
                          double Ab[restrict t->nbody + 1][9], double Abd[restrict t->nbody + 1][9],
                          double dir[restrict t->ndir][3], double dird[restrict t->ndir][3],
                          double dirb[restrict t->ndir][3], double dirbd[restrict t->ndir][3])
{
  int i;
  double dir0_i0, dir0_i0b, dir0_i0bd, dir0_i0d, dir0_i1, dir0_i1b, dir0_i1bd, dir0_i1d, dir0_i2,
      dir0_i2b, dir0_i2bd, dir0_i2d, tb2, tb2d, tb3, tb3d, tb4, tb4d;

  (void)dir;
  (void)dird;
  for (i = t->ndir - 1; i >= 0; --i) {
    dir0_i0 = dir0[i][0];
    dir0_i0d = dir0d[i][0];
    dir0_i1 = dir0[i][1];
    dir0_i1d = dir0d[i][1];
    dir0_i2 = dir0[i][2];
    dir0_i2d = dir0d[i][2];
    tb4 = dirb[i][2];
    tb4d = dirbd[i][2];
    dirb[i][2] = 0.0;
    dirbd[i][2] = 0.0;
    Ab[t->dirbody[i]][6] += tb4 * dir0_i0;
    Abd[t->dirbody[i]][6] += tb4d * dir0_i0 + tb4 * dir0_i0d;
    dir0_i0b = tb4 * A[t->dirbody[i]][6];
    dir0_i0bd = tb4d * A[t->dirbody[i]][6] + tb4 * Ad[t->dirbody[i]][6];
    Ab[t->dirbody[i]][7] += tb4 * dir0_i1;
    Abd[t->dirbody[i]][7] += tb4d * dir0_i1 + tb4 * dir0_i1d;
    dir0_i1b = tb4 * A[t->dirbody[i]][7];
    dir0_i1bd = tb4d * A[t->dirbody[i]][7] + tb4 * Ad[t->dirbody[i]][7];
    Ab[t->dirbody[i]][8] += tb4 * dir0_i2;
    Abd[t->dirbody[i]][8] += tb4d * dir0_i2 + tb4 * dir0_i2d;
    dir0_i2b = tb4 * A[t->dirbody[i]][8];
    dir0_i2bd = tb4d * A[t->dirbody[i]][8] + tb4 * Ad[t->dirbody[i]][8];
    tb3 = dirb[i][1];
    tb3d = dirbd[i][1];
    dirb[i][1] = 0.0;
    dirbd[i][1] = 0.0;
    Ab[t->dirbody[i]][3] += tb3 * dir0_i0;
    Abd[t->dirbody[i]][3] += tb3d * dir0_i0 + tb3 * dir0_i0d;
    dir0_i0b += tb3 * A[t->dirbody[i]][3];
    dir0_i0bd += tb3d * A[t->dirbody[i]][3] + tb3 * Ad[t->dirbody[i]][3];
    Ab[t->dirbody[i]][4] += tb3 * dir0_i1;
    Abd[t->dirbody[i]][4] += tb3d * dir0_i1 + tb3 * dir0_i1d;
    dir0_i1b += tb3 * A[t->dirbody[i]][4];
    dir0_i1bd += tb3d * A[t->dirbody[i]][4] + tb3 * Ad[t->dirbody[i]][4];
    Ab[t->dirbody[i]][5] += tb3 * dir0_i2;
    Abd[t->dirbody[i]][5] += tb3d * dir0_i2 + tb3 * dir0_i2d;
    dir0_i2b += tb3 * A[t->dirbody[i]][5];
    dir0_i2bd += tb3d * A[t->dirbody[i]][5] + tb3 * Ad[t->dirbody[i]][5];
    tb2 = dirb[i][0];
    tb2d = dirbd[i][0];
    dirb[i][0] = 0.0;
    dirbd[i][0] = 0.0;
    Ab[t->dirbody[i]][0] += tb2 * dir0_i0;
    Abd[t->dirbody[i]][0] += tb2d * dir0_i0 + tb2 * dir0_i0d;
    dir0_i0b += tb2 * A[t->dirbody[i]][0];
    dir0_i0bd += tb2d * A[t->dirbody[i]][0] + tb2 * Ad[t->dirbody[i]][0];
    Ab[t->dirbody[i]][1] += tb2 * dir0_i1;
    Abd[t->dirbody[i]][1] += tb2d * dir0_i1 + tb2 * dir0_i1d;
    dir0_i1b += tb2 * A[t->dirbody[i]][1];
    dir0_i1bd += tb2d * A[t->dirbody[i]][1] + tb2 * Ad[t->dirbody[i]][1];
    Ab[t->dirbody[i]][2] += tb2 * dir0_i2;
    Abd[t->dirbody[i]][2] += tb2d * dir0_i2 + tb2 * dir0_i2d;
    dir0_i2b += tb2 * A[t->dirbody[i]][2];
    dir0_i2bd += tb2d * A[t->dirbody[i]][2] + tb2 * Ad[t->dirbody[i]][2];
    dir0b[i][2] += dir0_i2b;
    dir0bd[i][2] += dir0_i2bd;
    dir0b[i][1] += dir0_i1b;
    dir0bd[i][1] += dir0_i1bd;
    dir0b[i][0] += dir0_i0b;
    dir0bd[i][0] += dir0_i0bd;
  }
}
