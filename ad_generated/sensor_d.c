/* Tangent of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra and Za carry minus gravity; p begins with gravity */
void maggi_sensors_d(const maggi_topo *t, const double p[restrict t->np],
                     const double pd[restrict t->np], const double origin[restrict 3],
                     const double spring0[restrict t->nspring],
                     const double spring0d[restrict t->nspring], const double q[restrict t->nq],
                     const double qd[restrict t->nq], const double v[restrict t->nq],
                     const double vd[restrict t->nq], const double A[restrict t->nbody + 1][9],
                     const double Ad[restrict t->nbody + 1][9],
                     const double x[restrict t->nbody + 1][3],
                     const double xd[restrict t->nbody + 1][3],
                     const double r[restrict t->npoint][3], const double rd[restrict t->npoint][3],
                     const double Z[restrict t->nbody + 1][6],
                     const double Zd[restrict t->nbody + 1][6],
                     const double rv[restrict t->npoint][3],
                     const double rvd[restrict t->npoint][3],
                     const double Za[restrict t->nbody + 1][6],
                     const double Zad[restrict t->nbody + 1][6],
                     const double ra[restrict t->npoint][3],
                     const double rad[restrict t->npoint][3], const double lambda[restrict t->nrow],
                     const double lambdad[restrict t->nrow],
                     const double slip[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                     const double slipd[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                     const double grip[restrict t->nwheel][6],
                     const double gripd[restrict t->nwheel][6], double s[restrict t->nsensor][3],
                     double sd[restrict t->nsensor][3])
{
  int a, a3, b, b7, i, j, k, k2, n2;
  double A_j0, A_j0d, A_j3, A_j3d, A_j7, A_j7d, A_j8, A_j8d, Z_j3, Z_j3d, Z_j4, Z_j4d, a2, a2d, ay,
      ayd, b2, b2d, b3, b3d, b4, b4d, b5, b5d, b6, b6d, c, c10, c11, c12, c13, c14, c15, c16, c17,
      c18, c19, c2, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c2d, c2inv, c3, c30, c31, c32,
      c33, c34, c35, c36, c37, c38, c39, c3d, c4, c40, c41, c42, c43, c44, c45, c46, c47, c48, c49,
      c5, c50, c51, c52, c53, c54, c55, c56, c57, c58, c59, c6, c60, c61, c62, c63, c64, c65, c66,
      c67, c68, c69, c7, c8, c9, cd, dampingd, dfz, dfzd, dv, dvd, e0, e0d, e1, e10, e10d, e11,
      e11d, e12, e12d, e1d, e20, e20d, e21, e21d, e22, e22d, e2_2, e2_2d, e3, e3d, e4, e4d, e5, e5d,
      e6, e6d, e7, e7d, e8, e8d, e9, e9d, ev0, ev0d, ev1, ev1d, ev20, ev20d, ev21, ev21d, ev22,
      ev22d, ev2_2, ev2_2d, ex, exd, ey, eyd, f0d, f1d, f2d, fx, fxd, fy, fyd, fz, fz0, fz0_2,
      fz0_2d, fz0d, fz0inv, fzd, g0, g0d, g1, g1d, g2, g2d, g3, g3d, g4, g4d, g5, g5d, g6, g6d, g7,
      g7d, g8, g8d, gamma, gammad, gx, gx2, gx2d, gxd, gy, gy2, gy2d, gyd, ka, kad, kappa, kappad,
      kx, kxd, l, l2, l2d, l2inv, l3, l3d, ld, linv, lv, lvd, m, md, mux, muxd, muy, muyd, n30,
      n30d, n31, n31d, n32, n32d, n4, n4d, n4inv, n5, n5d, n5inv, one0, one0d, one1, one1d, one2,
      one2d, one3, one3d, p2, p2d, p3, p3d, p4, p4d, p5, p5d, p6, p6d, p_k24, p_k24d, p_k25, p_k25d,
      peak, peakd, roll, rolld, s2, s2d, s3, s3d, shift, shift2, shift2d, shiftd, side, slip_n2d,
      t10, t100, t100d, t101, t101d, t102, t102d, t103, t103d, t104, t104d, t104inv, t105, t105d,
      t106, t106d, t107, t107d, t107inv, t108, t108d, t109, t109d, t109inv, t10d, t10inv, t11, t110,
      t110d, t111, t111d, t112, t112d, t113, t113d, t114, t114d, t115, t115d, t116, t116d, t116inv,
      t117, t117d, t118, t118d, t118inv, t119, t119d, t11d, t11inv, t12, t120, t120d, t121, t121d,
      t121inv, t122, t122d, t123, t123d, t123inv, t124, t124d, t125, t125d, t126, t126d, t127,
      t127d, t128, t128d, t129, t129d, t12d, t12inv, t13, t130, t130d, t130inv, t131, t131d, t132,
      t132d, t132inv, t133, t133d, t134d, t13d, t14, t14d, t15, t15d, t15inv, t16, t16d, t17, t17d,
      t18, t18d, t18inv, t19, t19d, t2, t20, t20d, t21, t21d, t21inv, t22, t22d, t23, t23d, t24,
      t24d, t25, t25d, t26, t26d, t27, t27d, t28, t28d, t29, t29d, t2d, t3, t30, t30d, t31, t31d,
      t32, t32d, t33, t33d, t34, t34d, t35, t35d, t36, t36d, t36inv, t37, t37d, t38, t38d, t39,
      t39d, t3d, t4, t40, t40d, t41, t41d, t42, t42d, t43, t43d, t44, t44d, t45, t45d, t46, t46d,
      t46inv, t47, t47d, t48, t48d, t49, t49d, t4d, t5, t50, t50d, t51, t51d, t52, t52d, t53, t53d,
      t54, t54d, t55, t55d, t55inv, t56, t56d, t57, t57d, t57inv, t58, t58d, t59, t59d, t5d, t5inv,
      t6, t60, t60d, t61, t61d, t62, t62d, t62inv, t63, t63d, t64, t64d, t64inv, t65, t65d, t66,
      t66d, t66inv, t67, t67d, t68, t68d, t69, t69d, t6d, t7, t70, t70d, t71, t71d, t72, t72d, t73,
      t73d, t74, t74d, t75, t75d, t76, t76d, t76inv, t77, t77d, t78, t78d, t78inv, t79, t79d, t7d,
      t8, t80, t80d, t81, t81d, t82, t82d, t83, t83d, t83inv, t84, t84d, t85, t85d, t85inv, t86,
      t86d, t87, t87d, t87inv, t88, t88d, t89, t89d, t89inv, t8d, t9, t90, t90d, t91, t91d, t92,
      t92d, t93, t93d, t94, t94d, t95, t95d, t96, t96d, t96inv, t97, t97d, t98, t98d, t99, t99d,
      t9d, torque0d, ux, uxd, uy, uyd, v2, v2d, wx1, wx1d, wy1, wy1d, x2, x2d, x30, x30d, x30inv,
      x31, x31d, x32, x32d, x33, x33d, x34, x34d, x35, x35d, x4, x4d, x5, x5d, x6, x6d, x7, x7d, x8,
      x8d, x9, x9d, xv, xvd, y0, y0_2, y0_2d, y0_3, y0_3d, y0_3inv, y0d, y1, y10, y10d, y11, y11d,
      y12, y12d, y13, y13d, y14, y14d, y15, y15d, y16, y16d, y17, y17d, y18, y18d, y1d, y2, y2_2,
      y2_2d, y2d, y3, y3_2, y3_2d, y3d, y4, y4_2, y4_2d, y4d, y5, y5_2, y5_2d, y5d, y6, y6d, y7,
      y7d, y8, y8d, y9, y9d, z0, z0_2, z0_2d, z0_3d, z0_4d, z0_5d, z0d, z10, z10d, z11, z11d, z1_2d,
      z1_3, z1_3d, z1d, z2, z2d, z3, z3d, z4, z4d, z5, z5d, z6, z6d, z7, z7d, z8, z8d, z9, z9d;

  (void)origin;
  (void)x;
  (void)Za;
  (void)ra;
  (void)lambda;
  for (i = 0; i < t->nsensor; ++i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n2 = t->sensorelement[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
      sd[i][0] = rd[k][0] - xd[t->nbody][0];
      sd[i][1] = rd[k][1] - xd[t->nbody][1];
      sd[i][2] = rd[k][2] - xd[t->nbody][2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
      sd[i][0] = rvd[k][0];
      sd[i][1] = rvd[k][1];
      sd[i][2] = rvd[k][2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ACCELERATION) {
      sd[i][0] = rad[k][0] + pd[0];
      sd[i][1] = rad[k][1] + pd[1];
      sd[i][2] = rad[k][2] + pd[2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j7d = Ad[j][7];
      A_j8 = A[j][8];
      A_j8d = Ad[j][8];
      c4 = A_j8 / (A_j8 * A_j8 + A_j7 * A_j7);
      c5 = -(A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      sd[i][0] = c4 * A_j7d + c5 * A_j8d;
      t2 = -A[j][6];
      t2d = -Ad[j][6];
      t3 = A_j7 * A_j7 + A_j8 * A_j8;
      t3d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
      t4 = sqrt(t3);
      c6 = 1.0 / (2.0 * t4);
      t4d = c6 * t3d;
      c7 = t4 / (t4 * t4 + t2 * t2);
      c8 = -(t2 / (t4 * t4 + t2 * t2));
      sd[i][1] = c7 * t2d + c8 * t4d;
      c9 = A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]);
      c10 = -(A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      sd[i][2] = c9 * Ad[j][3] + c10 * Ad[j][0];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      A_j0 = A[j][0];
      A_j0d = Ad[j][0];
      A_j3 = A[j][3];
      A_j3d = Ad[j][3];
      c2 = A_j0 * A_j0 + A_j3 * A_j3;
      /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
       * A_6 = -sin(pitch) */
      c2d = A_j0d * A_j0 + A_j0 * A_j0d + (A_j3d * A_j3 + A_j3 * A_j3d);
      Z_j3 = Z[j][3];
      Z_j3d = Zd[j][3];
      Z_j4 = Z[j][4];
      Z_j4d = Zd[j][4];
      roll = s[i][0];
      c2inv = 1.0 / c2;
      rolld = (A_j0d * Z_j3 + A_j0 * Z_j3d + (A_j3d * Z_j4 + A_j3 * Z_j4d) - roll * c2d) * c2inv;
      sd[i][0] = rolld;
      t5 = sqrt(c2);
      c11 = 1.0 / (2.0 * t5);
      t5d = c11 * c2d;
      t5inv = 1.0 / t5;
      sd[i][1] = (A_j0d * Z_j4 + A_j0 * Z_j4d - (A_j3d * Z_j3 + A_j3 * Z_j3d) - s[i][1] * t5d) *
          t5inv;
      sd[i][2] = Zd[j][5] - (Ad[j][6] * roll + A[j][6] * rolld);
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_VELOCITY) {
      sd[i][0] = Zd[j][3];
      sd[i][1] = Zd[j][4];
      sd[i][2] = Zd[j][5];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_ACCELERATION) {
      sd[i][0] = Zad[j][3];
      sd[i][1] = Zad[j][4];
      sd[i][2] = Zad[j][5];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SPRING) {
      a = t->springpa[n2];
      b = t->springpb[n2];
      e0 = r[a][0] - r[b][0];
      e0d = rd[a][0] - rd[b][0];
      ev0 = rv[a][0] - rv[b][0];
      ev0d = rvd[a][0] - rvd[b][0];
      e1 = r[a][1] - r[b][1];
      e1d = rd[a][1] - rd[b][1];
      ev1 = rv[a][1] - rv[b][1];
      ev1d = rvd[a][1] - rvd[b][1];
      e2_2 = r[a][2] - r[b][2];
      e2_2d = rd[a][2] - rd[b][2];
      ev2_2 = rv[a][2] - rv[b][2];
      ev2_2d = rvd[a][2] - rvd[b][2];
      t6 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
      t6d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
      l = sqrt(t6);
      c12 = 1.0 / (2.0 * l);
      ld = c12 * t6d;
      n30 = e0 / l;
      linv = 1.0 / l;
      n30d = (e0d - n30 * ld) * linv;
      n31 = e1 / l;
      n31d = (e1d - n31 * ld) * linv;
      n32 = e2_2 / l;
      n32d = (e2_2d - n32 * ld) * linv;
      lv = n30 * ev0 + n31 * ev1 + n32 * ev2_2;
      lvd = n30d * ev0 + n30 * ev0d + (n31d * ev1 + n31 * ev1d) + (n32d * ev2_2 + n32 * ev2_2d);
      dampingd = pd[t->springadr[n2] + MAGGI_SPRING_C] * lv + p[t->springadr[n2] + MAGGI_SPRING_C] *
          lvd;
      if (t->springpreload[n2]) {
        f0d = pd[t->springadr[n2]] * (l - spring0[n2]) + p[t->springadr[n2]] * (ld - spring0d[n2]) +
            pd[t->springadr[n2] + MAGGI_SPRING_L];
      } else {
        f0d = pd[t->springadr[n2]] * (l - p[t->springadr[n2] + MAGGI_SPRING_L]) +
            p[t->springadr[n2]] * (ld - pd[t->springadr[n2] + MAGGI_SPRING_L]);
      }
      k2 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
      if (t->springslopes[n2]) {
        /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
        if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
          p_k24 = p[k2 + 4];
          p_k24d = pd[k2 + 4];
          f2d = pd[k2] * p_k24 + p[k2] * p_k24d + (pd[k2 + 1] * (lv - p_k24) + p[k2 + 1] * (lvd -
              p_k24d));
        } else if (MAGGI_RE(lv) > 0.0) {
          f2d = pd[k2] * lv + p[k2] * lvd;
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
          f2d = pd[k2 + 2] * lv + p[k2 + 2] * lvd;
        } else {
          p_k25 = p[k2 + 5];
          p_k25d = pd[k2 + 5];
          f2d = pd[k2 + 2] * p_k25 + p[k2 + 2] * p_k25d + (pd[k2 + 3] * (lv - p_k25) + p[k2 + 3] *
              (lvd - p_k25d));
        }
        f1d = dampingd + f2d;
      } else {
        f1d = dampingd;
      }
      z0_3d = ld;
      z1d = lvd;
      sd[i][0] = z0_3d;
      sd[i][1] = z1d;
      sd[i][2] = f0d + f1d;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_JOINT_SPRING) {
      if (t->jspringq2[n2] >= 0) {
        x2 = q[t->jspringq[n2]] - q[t->jspringq2[n2]];
        x2d = qd[t->jspringq[n2]] - qd[t->jspringq2[n2]];
        xv = v[t->jspringq[n2]] - v[t->jspringq2[n2]];
        xvd = vd[t->jspringq[n2]] - vd[t->jspringq2[n2]];
      } else {
        x2 = q[t->jspringq[n2]];
        x2d = qd[t->jspringq[n2]];
        xv = v[t->jspringq[n2]];
        xvd = vd[t->jspringq[n2]];
      }
      torque0d = -(pd[t->jspringadr[n2]] * (x2 - p[t->jspringadr[n2] + MAGGI_JSPRING_REST])) -
          p[t->jspringadr[n2]] * (x2d - pd[t->jspringadr[n2] + MAGGI_JSPRING_REST]) -
          (pd[t->jspringadr[n2] + MAGGI_JSPRING_C] * xv + p[t->jspringadr[n2] + MAGGI_JSPRING_C] *
          xvd) - pd[t->jspringadr[n2] + MAGGI_JSPRING_PRELOAD];
      z0_4d = x2d;
      z1_2d = xvd;
      sd[i][0] = z0_4d;
      sd[i][1] = z1_2d;
      sd[i][2] = torque0d;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ROD) {
      a3 = t->primpa[n2];
      b7 = t->primpb[n2];
      e20 = r[a3][0] - r[b7][0];
      /* distance of two points and its rate */
      e20d = rd[a3][0] - rd[b7][0];
      ev20 = rv[a3][0] - rv[b7][0];
      ev20d = rvd[a3][0] - rvd[b7][0];
      e21 = r[a3][1] - r[b7][1];
      e21d = rd[a3][1] - rd[b7][1];
      ev21 = rv[a3][1] - rv[b7][1];
      ev21d = rvd[a3][1] - rvd[b7][1];
      e22 = r[a3][2] - r[b7][2];
      e22d = rd[a3][2] - rd[b7][2];
      ev22 = rv[a3][2] - rv[b7][2];
      ev22d = rvd[a3][2] - rvd[b7][2];
      t7 = e20 * e20 + e21 * e21 + e22 * e22;
      t7d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 * e22d);
      l2 = sqrt(t7);
      c13 = 1.0 / (2.0 * l2);
      l2d = c13 * t7d;
      z0_5d = l2d;
      z1_3 = s[i][1];
      l2inv = 1.0 / l2;
      z1_3d = (e20d * ev20 + e20 * ev20d + (e21d * ev21 + e21 * ev21d) + (e22d * ev22 + e22 * ev22d)
          - z1_3 * l2d) * l2inv;
      sd[i][0] = z0_5d;
      sd[i][1] = z1_3d;
      sd[i][2] = lambdad[t->primrow[n2]];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_SLIP) {
      sd[i][0] = slipd[n2][MAGGI_SLIP_KAPPA];
      c14 = 1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] * slip[n2][MAGGI_SLIP_TAN_ALPHA]);
      sd[i][1] = c14 * slipd[n2][MAGGI_SLIP_TAN_ALPHA];
      sd[i][2] = slipd[n2][MAGGI_SLIP_GAMMA];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_FORCE) {
      sd[i][0] = gripd[n2][0];
      sd[i][1] = gripd[n2][1];
      sd[i][2] = gripd[n2][2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_MOMENT) {
      sd[i][0] = gripd[n2][3];
      sd[i][1] = gripd[n2][4];
      sd[i][2] = gripd[n2][5];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_CONTACT) {
      slip_n2d = slipd[n2][MAGGI_SLIP_RADIUS];
      sd[i][0] = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] - slip_n2d;
      sd[i][1] = slip_n2d;
      sd[i][2] = slipd[n2][MAGGI_SLIP_ROLLING];
    } else {
      side = t->wheelmirror[n2] ? -1.0 : 1.0;
      /* slopes of the formula, which a tyre of the other side has as well; 0 in the air */
      if (MAGGI_RE(grip[n2][2]) > 0.0) {
        one0 = slip[n2][MAGGI_SLIP_KAPPA];
        one0d = slipd[n2][MAGGI_SLIP_KAPPA];
        one1 = side * slip[n2][MAGGI_SLIP_TAN_ALPHA];
        one1d = side * slipd[n2][MAGGI_SLIP_TAN_ALPHA];
        one2 = side * slip[n2][MAGGI_SLIP_GAMMA];
        one2d = side * slipd[n2][MAGGI_SLIP_GAMMA];
        one3 = grip[n2][2];
        one3d = gripd[n2][2];
        kappa = one0;
        kappad = one0d;
        a2 = one1;
        a2d = one1d;
        gamma = one2;
        gammad = one2d;
        fz = one3;
        fzd = one3d;
        fz0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]];
        fz0d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]]
            + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[n2]]];
        dfz = (fz - fz0) / fz0;
        fz0inv = 1.0 / fz0;
        dfzd = (fzd - fz0d - dfz * fz0d) * fz0inv;
        kx = kappa + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
        kxd = kappad + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX]);
        gx2 = gamma * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
        gx2d = gammad * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] + gamma *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
        mux = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2
            * gx2) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        muxd = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd)) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2) -
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2d) * gx2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2d)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        e3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
        e3d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] +
            ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PEX3] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfzd)) *
            dfz + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
        if (MAGGI_RE(kx) > 0.0) {
          e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          e4d = e3d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) - e3 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e4) > 1.0) {
            y2 = 1.0;
            y2d = 0.0;
          } else {
            y2 = e4;
            y2d = e4d;
          }
          ex = y2;
          exd = y2d;
        } else {
          e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          e5d = e3d * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) + e3 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e5) > 1.0) {
            y3 = 1.0;
            y3d = 0.0;
          } else {
            y3 = e5;
            y3d = e5d;
          }
          ex = y3;
          exd = y3d;
        }
        x30 = mux * fz;
        x30d = muxd * fz + mux * fzd;
        x31 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCX];
        x31d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX];
        x32 = ex;
        x32d = exd;
        t8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
        t8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfzd;
        t9 = exp(t8);
        t9d = t9 * t8d;
        x33 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t9 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        x33d = ((fzd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t9 + fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t9d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + fz * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t9 *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        x34 = kx;
        x34d = kxd;
        x35 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LMUX];
        x35d = ((fzd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + fz *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd))) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + fz * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]) * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LMUX] + fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LMUX];
        fz0_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]];
        /* sin(2 atan(z)) = 2 z / (1 + z^2) */
        fz0_2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
            p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
            pd[t->tyreadr[t->wheeltyre[n2]]];
        gy2 = gamma * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
        gy2d = gammad * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] + gamma *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
        ay = a2 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHY3] * gy2;
        ayd = a2d + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY]) + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHY3] * gy2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] * gy2d);
        muy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2
            * gy2) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        muyd = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd)) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2) -
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2d) * gy2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2d)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        e6 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
        e6d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PEY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
        if (MAGGI_RE(ay) > 0.0) {
          e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          e7d = e6d * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2)) - e6 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEY4] * gy2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2d));
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e7) > 1.0) {
            y4 = 1.0;
            y4d = 0.0;
          } else {
            y4 = e7;
            y4d = e7d;
          }
          ey = y4;
          eyd = y4d;
        } else {
          e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          e8d = e6d * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2)) + e6 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEY4] * gy2 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2d));
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e8) > 1.0) {
            y5 = 1.0;
            y5d = 0.0;
          } else {
            y5 = e8;
            y5d = e8d;
          }
          ey = y5;
          eyd = y5d;
        }
        t10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2;
        t10d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2d;
        z2 = fz / t10;
        t10inv = 1.0 / t10;
        z2d = (fzd - z2 * t10d) * t10inv;
        y0_3 = muy * fz;
        y0_3d = muyd * fz + muy * fzd;
        y1 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCY];
        y1d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY];
        y2_2 = ey;
        y2_2d = eyd;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gy2) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
          y6 = gy2;
          y6d = gy2d;
        } else if (MAGGI_RE(gy2) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LOW_CAMBER])) {
          y6 = -gy2;
          y6d = -gy2d;
        } else {
          p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
          p2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
          t11 = p2 * p2;
          t11d = p2d * p2 + p2 * p2d;
          z3 = gy2 * gy2 / t11;
          t11inv = 1.0 / t11;
          z3d = (gy2d * gy2 + gy2 * gy2d - z3 * t11d) * t11inv;
          y6 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
          y6d = (0.125 * p2d * z3 + 0.125 * p2 * z3d) * (15.0 + z3 * (-10.0 + 3.0 * z3)) + 0.125 *
              p2 * z3 * (z3d * (-10.0 + 3.0 * z3) + z3 * (3.0 * z3d));
        }
        t12 = 1.0 + z2 * z2;
        t12d = z2d * z2 + z2 * z2d;
        t13 = 2.0 * z2 / t12;
        t12inv = 1.0 / t12;
        t13d = (2.0 * z2d - t13 * t12d) * t12inv;
        y3_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) * p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_LKY];
        y3_2d = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d) * t13 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) - p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] *
            y6 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6d)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKY3] * y6) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
        y4_2 = ay;
        y4_2d = ayd;
        y5_2 = fz * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        y5_2d = (fzd * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) + fz
            * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd)) * gy2 +
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY4] * dfz) * gy2d))) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] +
            fz * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) *
            pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        peak = y0_3;
        peakd = y0_3d;
        x4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa;
        /* what combined slip makes of the forces:  Fx = Gxa Fx0, Fy = Gyk Fy0 + SVyk.  g: b, c, e, shift of Gxa,
         * then of Gyk, SVyk */
        x4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappad;
        t14 = 1.0 + x4 * x4;
        t14d = x4d * x4 + x4 * x4d;
        t15 = sqrt(t14);
        c15 = 1.0 / (2.0 * t15);
        t15d = c15 * t14d;
        t16 = 1.0 / t15;
        t15inv = 1.0 / t15;
        t16d = -(t16 * t15d * t15inv);
        g0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g0d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBX1] * t16 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g1 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
        g1d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
        e9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REX2] * dfz;
        e9d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_REX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] * dfzd);
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e9) > 1.0) {
          y7 = 1.0;
          y7d = 0.0;
        } else {
          y7 = e9;
          y7d = e9d;
        }
        g2 = y7;
        g2d = y7d;
        g3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        g3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        x5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        x5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBY2] * (a2d - pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        t17 = 1.0 + x5 * x5;
        t17d = x5d * x5 + x5 * x5d;
        t18 = sqrt(t17);
        c16 = 1.0 / (2.0 * t18);
        t18d = c16 * t17d;
        t19 = 1.0 / t18;
        t18inv = 1.0 / t18;
        t19d = -(t19 * t18d * t18inv);
        g4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g4d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBY1] * t19 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
        g5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
        e10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REY2] * dfz;
        e10d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_REY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] * dfzd);
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e10) > 1.0) {
          y8 = 1.0;
          y8d = 0.0;
        } else {
          y8 = e10;
          y8d = e10d;
        }
        g6 = y8;
        g6d = y8d;
        g7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RHY2] * dfz;
        g7d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RHY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfzd);
        p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        p3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        x6 = p3 * a2;
        x6d = p3d * a2 + p3 * a2d;
        t20 = 1.0 + x6 * x6;
        t20d = x6d * x6 + x6 * x6d;
        t21 = sqrt(t20);
        c17 = 1.0 / (2.0 * t21);
        t21d = c17 * t20d;
        t22 = 1.0 / t21;
        t21inv = 1.0 / t21;
        t22d = -(t22 * t21d * t21inv);
        dv = peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) * t22;
        dvd = (peakd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) + peak * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1]
            + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gammad))) * t22 + peak *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma) *
            t22d;
        t23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa;
        t23d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappad;
        t24 = atan(t23);
        c18 = 1.0 / (1.0 + t23 * t23);
        t24d = c18 * t23d;
        t25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t24;
        t25d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t24 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t24d;
        t26 = sin(t25);
        c19 = cos(t25);
        t26d = c19 * t25d;
        g8 = dv * t26 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        g8d = (dvd * t26 + dv * t26d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + dv *
            t26 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        y9 = g0 * (a2 + g3);
        y9d = g0d * (a2 + g3) + g0 * (a2d + g3d);
        y10 = g0 * g3;
        y10d = g0d * g3 + g0 * g3d;
        t27 = atan(y9);
        c20 = 1.0 / (1.0 + y9 * y9);
        t27d = c20 * y9d;
        t28 = (1.0 - g2) * y9 + g2 * t27;
        t28d = -(g2d * y9) + (1.0 - g2) * y9d + (g2d * t27 + g2 * t27d);
        t29 = atan(t28);
        c21 = 1.0 / (1.0 + t28 * t28);
        t29d = c21 * t28d;
        t30 = g1 * t29;
        t30d = g1d * t29 + g1 * t29d;
        t31 = cos(t30);
        c22 = -sin(t30);
        t31d = c22 * t30d;
        t32 = atan(y10);
        c23 = 1.0 / (1.0 + y10 * y10);
        t32d = c23 * y10d;
        t33 = (1.0 - g2) * y10 + g2 * t32;
        t33d = -(g2d * y10) + (1.0 - g2) * y10d + (g2d * t32 + g2 * t32d);
        t34 = atan(t33);
        c24 = 1.0 / (1.0 + t33 * t33);
        t34d = c24 * t33d;
        t35 = g1 * t34;
        t35d = g1d * t34 + g1 * t34d;
        t36 = cos(t35);
        c25 = -sin(t35);
        t36d = c25 * t35d;
        gx = t31 / t36;
        t36inv = 1.0 / t36;
        gxd = (t31d - gx * t36d) * t36inv;
        y11 = g4 * (kappa + g7);
        y11d = g4d * (kappa + g7) + g4 * (kappad + g7d);
        y12 = g4 * g7;
        y12d = g4d * g7 + g4 * g7d;
        t37 = atan(y11);
        c26 = 1.0 / (1.0 + y11 * y11);
        t37d = c26 * y11d;
        t38 = (1.0 - g6) * y11 + g6 * t37;
        t38d = -(g6d * y11) + (1.0 - g6) * y11d + (g6d * t37 + g6 * t37d);
        t39 = atan(t38);
        c27 = 1.0 / (1.0 + t38 * t38);
        t39d = c27 * t38d;
        t40 = g5 * t39;
        t40d = g5d * t39 + g5 * t39d;
        t41 = cos(t40);
        c28 = -sin(t40);
        t41d = c28 * t40d;
        t42 = atan(y12);
        c29 = 1.0 / (1.0 + y12 * y12);
        t42d = c29 * y12d;
        t43 = (1.0 - g6) * y12 + g6 * t42;
        t43d = -(g6d * y12) + (1.0 - g6) * y12d + (g6d * t42 + g6 * t42d);
        t44 = atan(t43);
        c30 = 1.0 / (1.0 + t43 * t43);
        t44d = c30 * t43d;
        t45 = g5 * t44;
        t45d = g5d * t44 + g5 * t44d;
        t46 = cos(t45);
        c31 = -sin(t45);
        t46d = c31 * t45d;
        gy = t41 / t46;
        t46inv = 1.0 / t46;
        gyd = (t41d - gy * t46d) * t46inv;
        b3 = g0;
        b3d = g0d;
        c = g1;
        cd = g1d;
        e11 = g2;
        e11d = g2d;
        shift = g3;
        shiftd = g3d;
        y13 = b3 * (a2 + shift);
        /* its derivatives by x and by b */
        y13d = b3d * (a2 + shift) + b3 * (a2d + shiftd);
        y0 = b3 * shift;
        y0d = b3d * shift + b3 * shiftd;
        t47 = atan(y13);
        c32 = 1.0 / (1.0 + y13 * y13);
        t47d = c32 * y13d;
        t48 = (1.0 - e11) * y13 + e11 * t47;
        t48d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t47 + e11 * t47d);
        t49 = atan(t48);
        c33 = 1.0 / (1.0 + t48 * t48);
        t49d = c33 * t48d;
        z4 = c * t49;
        z4d = cd * t49 + c * t49d;
        t50 = atan(y0);
        c34 = 1.0 / (1.0 + y0 * y0);
        t50d = c34 * y0d;
        t51 = (1.0 - e11) * y0 + e11 * t50;
        t51d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t50 + e11 * t50d);
        t52 = atan(t51);
        c35 = 1.0 / (1.0 + t51 * t51);
        t52d = c35 * t51d;
        z0 = c * t52;
        z0d = cd * t52 + c * t52d;
        n4 = cos(z0);
        c36 = -sin(z0);
        n4d = c36 * z0d;
        t53 = atan(y13);
        c37 = 1.0 / (1.0 + y13 * y13);
        /* its derivative by y */
        t53d = c37 * y13d;
        z5 = (1.0 - e11) * y13 + e11 * t53;
        z5d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t53 + e11 * t53d);
        t54 = sin(z4);
        c38 = cos(z4);
        t54d = c38 * z4d;
        t55 = 1.0 + y13 * y13;
        t55d = y13d * y13 + y13 * y13d;
        t56 = e11 / t55;
        t55inv = 1.0 / t55;
        t56d = (e11d - t56 * t55d) * t55inv;
        t57 = 1.0 + z5 * z5;
        t57d = z5d * z5 + z5 * z5d;
        t58 = c * (1.0 - e11 + t56) / t57;
        t57inv = 1.0 / t57;
        t58d = (cd * (1.0 - e11 + t56) + c * (-e11d + t56d) - t58 * t57d) * t57inv;
        s2 = -t54 * t58 / n4;
        n4inv = 1.0 / n4;
        s2d = (-(t54d * t58) - t54 * t58d - s2 * n4d) * n4inv;
        t59 = atan(y0);
        c39 = 1.0 / (1.0 + y0 * y0);
        /* its derivative by y */
        t59d = c39 * y0d;
        z6 = (1.0 - e11) * y0 + e11 * t59;
        z6d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t59 + e11 * t59d);
        t60 = cos(z4);
        c40 = -sin(z4);
        t60d = c40 * z4d;
        t61 = sin(z0);
        c41 = cos(z0);
        t61d = c41 * z0d;
        t62 = n4 * n4;
        t62d = n4d * n4 + n4 * n4d;
        t63 = t60 * t61 / t62;
        t62inv = 1.0 / t62;
        t63d = (t60d * t61 + t60 * t61d - t63 * t62d) * t62inv;
        t64 = 1.0 + y0 * y0;
        t64d = y0d * y0 + y0 * y0d;
        t65 = e11 / t64;
        t64inv = 1.0 / t64;
        t65d = (e11d - t65 * t64d) * t64inv;
        t66 = 1.0 + z6 * z6;
        t66d = z6d * z6 + z6 * z6d;
        t67 = c * (1.0 - e11 + t65) / t66;
        t66inv = 1.0 / t66;
        t67d = (cd * (1.0 - e11 + t65) + c * (-e11d + t65d) - t67 * t66d) * t66inv;
        wx1 = s2 * (a2 + shift) + t63 * t67 * shift;
        wx1d = s2d * (a2 + shift) + s2 * (a2d + shiftd) + ((t63d * t67 + t63 * t67d) * shift + t63 *
            t67 * shiftd);
        b4 = g4;
        b4d = g4d;
        c3 = g5;
        c3d = g5d;
        e12 = g6;
        e12d = g6d;
        shift2 = g7;
        shift2d = g7d;
        y14 = b4 * (kappa + shift2);
        /* its derivatives by x and by b */
        y14d = b4d * (kappa + shift2) + b4 * (kappad + shift2d);
        y0_2 = b4 * shift2;
        y0_2d = b4d * shift2 + b4 * shift2d;
        t68 = atan(y14);
        c42 = 1.0 / (1.0 + y14 * y14);
        t68d = c42 * y14d;
        t69 = (1.0 - e12) * y14 + e12 * t68;
        t69d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t68 + e12 * t68d);
        t70 = atan(t69);
        c43 = 1.0 / (1.0 + t69 * t69);
        t70d = c43 * t69d;
        z7 = c3 * t70;
        z7d = c3d * t70 + c3 * t70d;
        t71 = atan(y0_2);
        c44 = 1.0 / (1.0 + y0_2 * y0_2);
        t71d = c44 * y0_2d;
        t72 = (1.0 - e12) * y0_2 + e12 * t71;
        t72d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t71 + e12 * t71d);
        t73 = atan(t72);
        c45 = 1.0 / (1.0 + t72 * t72);
        t73d = c45 * t72d;
        z0_2 = c3 * t73;
        z0_2d = c3d * t73 + c3 * t73d;
        n5 = cos(z0_2);
        c46 = -sin(z0_2);
        n5d = c46 * z0_2d;
        t74 = atan(y14);
        c47 = 1.0 / (1.0 + y14 * y14);
        /* its derivative by y */
        t74d = c47 * y14d;
        z8 = (1.0 - e12) * y14 + e12 * t74;
        z8d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t74 + e12 * t74d);
        t75 = sin(z7);
        c48 = cos(z7);
        t75d = c48 * z7d;
        t76 = 1.0 + y14 * y14;
        t76d = y14d * y14 + y14 * y14d;
        t77 = e12 / t76;
        t76inv = 1.0 / t76;
        t77d = (e12d - t77 * t76d) * t76inv;
        t78 = 1.0 + z8 * z8;
        t78d = z8d * z8 + z8 * z8d;
        t79 = c3 * (1.0 - e12 + t77) / t78;
        t78inv = 1.0 / t78;
        t79d = (c3d * (1.0 - e12 + t77) + c3 * (-e12d + t77d) - t79 * t78d) * t78inv;
        s3 = -t75 * t79 / n5;
        n5inv = 1.0 / n5;
        s3d = (-(t75d * t79) - t75 * t79d - s3 * n5d) * n5inv;
        t80 = atan(y0_2);
        c49 = 1.0 / (1.0 + y0_2 * y0_2);
        /* its derivative by y */
        t80d = c49 * y0_2d;
        z9 = (1.0 - e12) * y0_2 + e12 * t80;
        z9d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t80 + e12 * t80d);
        t81 = cos(z7);
        c50 = -sin(z7);
        t81d = c50 * z7d;
        t82 = sin(z0_2);
        c51 = cos(z0_2);
        t82d = c51 * z0_2d;
        t83 = n5 * n5;
        t83d = n5d * n5 + n5 * n5d;
        t84 = t81 * t82 / t83;
        t83inv = 1.0 / t83;
        t84d = (t81d * t82 + t81 * t82d - t84 * t83d) * t83inv;
        t85 = 1.0 + y0_2 * y0_2;
        t85d = y0_2d * y0_2 + y0_2 * y0_2d;
        t86 = e12 / t85;
        t85inv = 1.0 / t85;
        t86d = (e12d - t86 * t85d) * t85inv;
        t87 = 1.0 + z9 * z9;
        t87d = z9d * z9 + z9 * z9d;
        t88 = c3 * (1.0 - e12 + t86) / t87;
        t87inv = 1.0 / t87;
        t88d = (c3d * (1.0 - e12 + t86) + c3 * (-e12d + t86d) - t88 * t87d) * t87inv;
        wy1 = s3 * (kappa + shift2) + t84 * t88 * shift2;
        wy1d = s3d * (kappa + shift2) + s3 * (kappad + shift2d) + ((t84d * t88 + t84 * t88d) *
            shift2 + t84 * t88 * shift2d);
        t89 = x31 * x30;
        t89d = x31d * x30 + x31 * x30d;
        t90 = x33 / t89;
        t89inv = 1.0 / t89;
        t90d = (x33d - t90 * t89d) * t89inv;
        y15 = t90 * x34;
        y15d = t90d * x34 + t90 * x34d;
        t91 = atan(y15);
        c52 = 1.0 / (1.0 + y15 * y15);
        t91d = c52 * y15d;
        t92 = (1.0 - x32) * y15 + x32 * t91;
        t92d = -(x32d * y15) + (1.0 - x32) * y15d + (x32d * t91 + x32 * t91d);
        t93 = atan(t92);
        c53 = 1.0 / (1.0 + t92 * t92);
        t93d = c53 * t92d;
        t94 = x31 * t93;
        t94d = x31d * t93 + x31 * t93d;
        t95 = sin(t94);
        c54 = cos(t94);
        t95d = c54 * t94d;
        fx = x30 * t95 + x35;
        fxd = x30d * t95 + x30 * t95d + x35d;
        t96 = y1 * y0_3;
        t96d = y1d * y0_3 + y1 * y0_3d;
        t97 = y3_2 / t96;
        t96inv = 1.0 / t96;
        t97d = (y3_2d - t97 * t96d) * t96inv;
        y16 = t97 * y4_2;
        y16d = t97d * y4_2 + t97 * y4_2d;
        t98 = atan(y16);
        c55 = 1.0 / (1.0 + y16 * y16);
        t98d = c55 * y16d;
        t99 = (1.0 - y2_2) * y16 + y2_2 * t98;
        t99d = -(y2_2d * y16) + (1.0 - y2_2) * y16d + (y2_2d * t98 + y2_2 * t98d);
        t100 = atan(t99);
        c56 = 1.0 / (1.0 + t99 * t99);
        t100d = c56 * t99d;
        t101 = y1 * t100;
        t101d = y1d * t100 + y1 * t100d;
        t102 = sin(t101);
        c57 = cos(t101);
        t102d = c57 * t101d;
        fy = y0_3 * t102 + y5_2;
        fyd = y0_3d * t102 + y0_3 * t102d + y5_2d;
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        p5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        x7 = p4 * (a2 - p5);
        /* b and the shift of Fy change with a by their cos(atan()) */
        x7d = p4d * (a2 - p5) + p4 * (a2d - p5d);
        t103 = 1.0 + x7 * x7;
        t103d = x7d * x7 + x7 * x7d;
        t104 = sqrt(t103);
        c58 = 1.0 / (2.0 * t104);
        t104d = c58 * t103d;
        t105 = 1.0 / t104;
        t104inv = 1.0 / t104;
        t105d = -(t105 * t104d * t104inv);
        l3 = p4 * t105;
        l3d = p4d * t105 + p4 * t105d;
        x8 = p3 * a2;
        x8d = p3d * a2 + p3 * a2d;
        t106 = 1.0 + x8 * x8;
        t106d = x8d * x8 + x8 * x8d;
        t107 = sqrt(t106);
        c59 = 1.0 / (2.0 * t107);
        t107d = c59 * t106d;
        t108 = 1.0 / t107;
        t107inv = 1.0 / t107;
        t108d = -(t108 * t107d * t107inv);
        v2 = p3 * t108;
        v2d = p3d * t108 + p3 * t108d;
        b2 = -g4 * l3 * l3 * (a2 - p5);
        b2d = ((-(g4d * l3) - g4 * l3d) * l3 + -g4 * l3 * l3d) * (a2 - p5) + -g4 * l3 * l3 * (a2d -
            p5d);
        t109 = y1 * y0_3;
        /* its derivative by the slip */
        t109d = y1d * y0_3 + y1 * y0_3d;
        b5 = y3_2 / t109;
        t109inv = 1.0 / t109;
        b5d = (y3_2d - b5 * t109d) * t109inv;
        y17 = b5 * y4_2;
        y17d = b5d * y4_2 + b5 * y4_2d;
        t110 = atan(y17);
        c60 = 1.0 / (1.0 + y17 * y17);
        /* its derivative by y */
        t110d = c60 * y17d;
        z10 = (1.0 - y2_2) * y17 + y2_2 * t110;
        z10d = -(y2_2d * y17) + (1.0 - y2_2) * y17d + (y2_2d * t110 + y2_2 * t110d);
        t111 = atan(y17);
        c61 = 1.0 / (1.0 + y17 * y17);
        t111d = c61 * y17d;
        t112 = (1.0 - y2_2) * y17 + y2_2 * t111;
        t112d = -(y2_2d * y17) + (1.0 - y2_2) * y17d + (y2_2d * t111 + y2_2 * t111d);
        t113 = atan(t112);
        c62 = 1.0 / (1.0 + t112 * t112);
        t113d = c62 * t112d;
        t114 = y1 * t113;
        t114d = y1d * t113 + y1 * t113d;
        t115 = cos(t114);
        c63 = -sin(t114);
        t115d = c63 * t114d;
        t116 = 1.0 + y17 * y17;
        t116d = y17d * y17 + y17 * y17d;
        t117 = y2_2 / t116;
        t116inv = 1.0 / t116;
        t117d = (y2_2d - t117 * t116d) * t116inv;
        t118 = 1.0 + z10 * z10;
        t118d = z10d * z10 + z10 * z10d;
        t119 = y1 * (1.0 - y2_2 + t117) / t118;
        t118inv = 1.0 / t118;
        t119d = (y1d * (1.0 - y2_2 + t117) + y1 * (-y2_2d + t117d) - t119 * t118d) * t118inv;
        sd[i][0] = (a2d * a2 + a2 * a2d) * (gy * (y0_3 * t115 * t119 * b5) + fy * wy1 * b2 - g8 * v2
            * v2 * a2) + (1.0 + a2 * a2) * (gyd * (y0_3 * t115 * t119 * b5) + gy * (((y0_3d * t115 +
            y0_3 * t115d) * t119 + y0_3 * t115 * t119d) * b5 + y0_3 * t115 * t119 * b5d) + ((fyd *
            wy1 + fy * wy1d) * b2 + fy * wy1 * b2d) - (((g8d * v2 + g8 * v2d) * v2 + g8 * v2 * v2d)
            * a2 + g8 * v2 * v2 * a2d));
        p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        p6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        x9 = p6 * kappa;
        x9d = p6d * kappa + p6 * kappad;
        t120 = 1.0 + x9 * x9;
        t120d = x9d * x9 + x9 * x9d;
        t121 = sqrt(t120);
        c64 = 1.0 / (2.0 * t121);
        t121d = c64 * t120d;
        t122 = 1.0 / t121;
        t121inv = 1.0 / t121;
        t122d = -(t122 * t121d * t121inv);
        m = p6 * t122;
        md = p6d * t122 + p6 * t122d;
        ka = -g0 * m * m * kappa;
        kad = ((-(g0d * m) - g0 * md) * m + -g0 * m * md) * kappa + -g0 * m * m * kappad;
        t123 = x31 * x30;
        /* its derivative by the slip */
        t123d = x31d * x30 + x31 * x30d;
        b6 = x33 / t123;
        t123inv = 1.0 / t123;
        b6d = (x33d - b6 * t123d) * t123inv;
        y18 = b6 * x34;
        y18d = b6d * x34 + b6 * x34d;
        t124 = atan(y18);
        c65 = 1.0 / (1.0 + y18 * y18);
        /* its derivative by y */
        t124d = c65 * y18d;
        z11 = (1.0 - x32) * y18 + x32 * t124;
        z11d = -(x32d * y18) + (1.0 - x32) * y18d + (x32d * t124 + x32 * t124d);
        t125 = atan(y18);
        c66 = 1.0 / (1.0 + y18 * y18);
        t125d = c66 * y18d;
        t126 = (1.0 - x32) * y18 + x32 * t125;
        t126d = -(x32d * y18) + (1.0 - x32) * y18d + (x32d * t125 + x32 * t125d);
        t127 = atan(t126);
        c67 = 1.0 / (1.0 + t126 * t126);
        t127d = c67 * t126d;
        t128 = x31 * t127;
        t128d = x31d * t127 + x31 * t127d;
        t129 = cos(t128);
        c68 = -sin(t128);
        t129d = c68 * t128d;
        t130 = 1.0 + y18 * y18;
        t130d = y18d * y18 + y18 * y18d;
        t131 = x32 / t130;
        t130inv = 1.0 / t130;
        t131d = (x32d - t131 * t130d) * t130inv;
        t132 = 1.0 + z11 * z11;
        t132d = z11d * z11 + z11 * z11d;
        t133 = x31 * (1.0 - x32 + t131) / t132;
        t132inv = 1.0 / t132;
        t133d = (x31d * (1.0 - x32 + t131) + x31 * (-x32d + t131d) - t133 * t132d) * t132inv;
        sd[i][1] = gxd * (x30 * t129 * t133 * b6) + gx * (((x30d * t129 + x30 * t129d) * t133 + x30
            * t129 * t133d) * b6 + x30 * t129 * t133 * b6d) + ((fxd * wx1 + fx * wx1d) * ka + fx *
            wx1 * kad);
        ux = fx * gx / x30;
        x30inv = 1.0 / x30;
        uxd = (fxd * gx + fx * gxd - ux * x30d) * x30inv;
        uy = (fy * gy + g8) / y0_3;
        y0_3inv = 1.0 / y0_3;
        uyd = (fyd * gy + fy * gyd + g8d - uy * y0_3d) * y0_3inv;
        t134d = uxd * ux + ux * uxd + (uyd * uy + uy * uyd);
        c69 = 1.0 / (2.0 * s[i][2]);
        sd[i][2] = c69 * t134d;
      } else {
        sd[i][0] = 0.0;
        sd[i][1] = 0.0;
        sd[i][2] = 0.0;
      }
    }
  }
}
