/* Adjoint of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra and Za carry minus gravity; p begins with gravity */
void maggi_sensors_b(const maggi_topo *t, const double p[restrict t->np], double pb[restrict t->np],
                     const double origin[restrict 3], const double spring0[restrict t->nspring],
                     double spring0b[restrict t->nspring], const double q[restrict t->nq],
                     double qb[restrict t->nq], const double v[restrict t->nq],
                     double vb[restrict t->nq], const double A[restrict t->nbody + 1][9],
                     double Ab[restrict t->nbody + 1][9], const double x[restrict t->nbody + 1][3],
                     double xb[restrict t->nbody + 1][3], const double r[restrict t->npoint][3],
                     double rb[restrict t->npoint][3], const double Z[restrict t->nbody + 1][6],
                     double Zb[restrict t->nbody + 1][6], const double rv[restrict t->npoint][3],
                     double rvb[restrict t->npoint][3], const double Za[restrict t->nbody + 1][6],
                     double Zab[restrict t->nbody + 1][6], const double ra[restrict t->npoint][3],
                     double rab[restrict t->npoint][3], const double lambda[restrict t->nrow],
                     double lambdab[restrict t->nrow],
                     const double slip[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                     double slipb[restrict t->nwheel][MAGGI_SLIP_NUMBERS],
                     const double grip[restrict t->nwheel][6], double gripb[restrict t->nwheel][6],
                     double s[restrict t->nsensor][3], double sb[restrict t->nsensor][3])
{
  int a, a3, b, b7, i, j, k, k2, n2;
  double A_j0, A_j0b, A_j3, A_j3b, A_j7, A_j7b, A_j8, A_j8b, Z_j3, Z_j3b, Z_j4, Z_j4b, a2, a2b, ay,
      ayb, b2, b2b, b3, b3b, b4, b4b, b5, b5b, b6, b6b, c, c2, c2b, c3, c3b, cb, dampingb, dfz,
      dfzb, dv, dvb, e0, e0b, e1, e10, e10b, e11, e11b, e12, e12b, e1b, e20, e20b, e21, e21b, e22,
      e22b, e2_2, e2_2b, e3, e3b, e4, e4b, e5, e5b, e6, e6b, e7, e7b, e8, e8b, e9, e9b, ev0, ev0b,
      ev1, ev1b, ev20, ev20b, ev21, ev21b, ev22, ev22b, ev2_2, ev2_2b, ex, exb, ey, eyb, f0b, f1b,
      f2b, fx, fxb, fy, fyb, fz, fz0, fz0_2, fz0_2b, fz0b, fzb, g0, g0b, g1, g1b, g2, g2b, g3, g3b,
      g4, g4b, g5, g5b, g6, g6b, g7, g7b, g8, g8b, gamma, gammab, gx, gx2, gx2b, gxb, gy, gy2, gy2b,
      gyb, ka, kab, kappa, kappab, kx, kxb, l, l2, l2b, l3, l3b, lb, lv, lvb, m, mb, mux, muxb, muy,
      muyb, n30, n30b, n31, n31b, n32, n32b, n4, n4b, n5, n5b, one0, one0b, one1, one1b, one2,
      one2b, one3, one3b, p2, p2b, p3, p3b, p4, p4b, p5, p5b, p6, p6b, p_k24, p_k24b, p_k25, p_k25b,
      peak, peakb, roll, rollb, s2, s2b, s3, s3b, shift, shift2, shift2b, shiftb, side, slip_n2b,
      t10, t100, t100b, t101, t101b, t102, t102b, t103, t103b, t104, t104b, t105, t105b, t106,
      t106b, t107, t107b, t108, t108b, t109, t109b, t10b, t11, t110, t110b, t111, t111b, t112,
      t112b, t113, t113b, t114, t114b, t115, t115b, t116, t116b, t117, t117b, t118, t118b, t119,
      t119b, t11b, t12, t120, t120b, t121, t121b, t122, t122b, t123, t123b, t124, t124b, t125,
      t125b, t126, t126b, t127, t127b, t128, t128b, t129, t129b, t12b, t13, t130, t130b, t131,
      t131b, t132, t132b, t133, t133b, t134b, t13b, t14, t14b, t15, t15b, t16, t16b, t17, t17b, t18,
      t18b, t19, t19b, t2, t20, t20b, t21, t21b, t22, t22b, t23, t23b, t24, t24b, t25, t25b, t26,
      t26b, t27, t27b, t28, t28b, t29, t29b, t2b, t3, t30, t30b, t31, t31b, t32, t32b, t33, t33b,
      t34, t34b, t35, t35b, t36, t36b, t37, t37b, t38, t38b, t39, t39b, t3b, t4, t40, t40b, t41,
      t41b, t42, t42b, t43, t43b, t44, t44b, t45, t45b, t46, t46b, t47, t47b, t48, t48b, t49, t49b,
      t4b, t5, t50, t50b, t51, t51b, t52, t52b, t53, t53b, t54, t54b, t55, t55b, t56, t56b, t57,
      t57b, t58, t58b, t59, t59b, t5b, t6, t60, t60b, t61, t61b, t62, t62b, t63, t63b, t64, t64b,
      t65, t65b, t66, t66b, t67, t67b, t68, t68b, t69, t69b, t6b, t7, t70, t70b, t71, t71b, t72,
      t72b, t73, t73b, t74, t74b, t75, t75b, t76, t76b, t77, t77b, t78, t78b, t79, t79b, t7b, t8,
      t80, t80b, t81, t81b, t82, t82b, t83, t83b, t84, t84b, t85, t85b, t86, t86b, t87, t87b, t88,
      t88b, t89, t89b, t8b, t9, t90, t90b, t91, t91b, t92, t92b, t93, t93b, t94, t94b, t95, t95b,
      t96, t96b, t97, t97b, t98, t98b, t99, t99b, t9b, tb10, tb100, tb101, tb102, tb103, tb104,
      tb105, tb106, tb107, tb108, tb109, tb11, tb110, tb111, tb112, tb113, tb114, tb115, tb116,
      tb117, tb118, tb119, tb12, tb120, tb121, tb122, tb123, tb124, tb125, tb126, tb127, tb128,
      tb129, tb13, tb130, tb131, tb132, tb14, tb15, tb16, tb17, tb18, tb19, tb2, tb20, tb21, tb22,
      tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3, tb30, tb31, tb32, tb33, tb34, tb35, tb36, tb37,
      tb38, tb39, tb4, tb40, tb41, tb42, tb43, tb44, tb45, tb46, tb47, tb48, tb49, tb5, tb50, tb51,
      tb52, tb53, tb54, tb55, tb56, tb57, tb58, tb59, tb6, tb60, tb61, tb62, tb63, tb64, tb65, tb66,
      tb67, tb68, tb69, tb7, tb70, tb71, tb72, tb73, tb74, tb75, tb76, tb77, tb78, tb79, tb8, tb80,
      tb81, tb82, tb83, tb84, tb85, tb86, tb87, tb88, tb89, tb9, tb90, tb91, tb92, tb93, tb94, tb95,
      tb96, tb97, tb98, tb99, torque0b, ux, uxb, uy, uyb, v2, v2b, wx1, wx1b, wy1, wy1b, x2, x2b,
      x30, x30b, x31, x31b, x32, x32b, x33, x33b, x34, x34b, x35, x35b, x4, x4b, x5, x5b, x6, x6b,
      x7, x7b, x8, x8b, x9, x9b, xv, xvb, y0, y0_2, y0_2b, y0_3, y0_3b, y0b, y1, y10, y10b, y11,
      y11b, y12, y12b, y13, y13b, y14, y14b, y15, y15b, y16, y16b, y17, y17b, y18, y18b, y1b, y2,
      y2_2, y2_2b, y2b, y3, y3_2, y3_2b, y3b, y4, y4_2, y4_2b, y4b, y5, y5_2, y5_2b, y5b, y6, y6b,
      y7, y7b, y8, y8b, y9, y9b, z0, z0_2, z0_2b, z0_3b, z0_4b, z0_5b, z0b, z10, z10b, z11, z11b,
      z1_2b, z1_3, z1_3b, z1b, z2, z2b, z3, z3b, z4, z4b, z5, z5b, z6, z6b, z7, z7b, z8, z8b, z9,
      z9b;

  (void)origin;
  (void)x;
  (void)Za;
  (void)ra;
  (void)lambda;
  for (i = t->nsensor - 1; i >= 0; --i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n2 = t->sensorelement[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
      tb4 = sb[i][2];
      sb[i][2] = 0.0;
      rb[k][2] += tb4;
      xb[t->nbody][2] -= tb4;
      tb3 = sb[i][1];
      sb[i][1] = 0.0;
      rb[k][1] += tb3;
      xb[t->nbody][1] -= tb3;
      tb2 = sb[i][0];
      sb[i][0] = 0.0;
      rb[k][0] += tb2;
      xb[t->nbody][0] -= tb2;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
      rvb[k][2] += sb[i][2];
      sb[i][2] = 0.0;
      rvb[k][1] += sb[i][1];
      sb[i][1] = 0.0;
      rvb[k][0] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ACCELERATION) {
      tb7 = sb[i][2];
      sb[i][2] = 0.0;
      rab[k][2] += tb7;
      pb[2] += tb7;
      tb6 = sb[i][1];
      sb[i][1] = 0.0;
      rab[k][1] += tb6;
      pb[1] += tb6;
      tb5 = sb[i][0];
      sb[i][0] = 0.0;
      rab[k][0] += tb5;
      pb[0] += tb5;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j8 = A[j][8];
      t2 = -A[j][6];
      t3 = A_j7 * A_j7 + A_j8 * A_j8;
      t4 = sqrt(t3);
      tb10 = sb[i][2];
      sb[i][2] = 0.0;
      Ab[j][3] += tb10 * (A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      Ab[j][0] -= tb10 * (A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      tb9 = sb[i][1];
      sb[i][1] = 0.0;
      t2b = tb9 * (t4 / (t4 * t4 + t2 * t2));
      t4b = -(tb9 * (t2 / (t4 * t4 + t2 * t2)));
      t3b = t4b * (1.0 / (2.0 * t4));
      A_j7b = t3b * A_j7;
      A_j7b += t3b * A_j7;
      A_j8b = t3b * A_j8;
      A_j8b += t3b * A_j8;
      Ab[j][6] -= t2b;
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      tb8 = sb[i][0];
      sb[i][0] = 0.0;
      A_j7b += tb8 * (A_j8 / (A_j8 * A_j8 + A_j7 * A_j7));
      A_j8b -= tb8 * (A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      Ab[j][8] += A_j8b;
      Ab[j][7] += A_j7b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      A_j0 = A[j][0];
      A_j3 = A[j][3];
      c2 = A_j0 * A_j0 + A_j3 * A_j3;
      Z_j3 = Z[j][3];
      Z_j4 = Z[j][4];
      roll = s[i][0];
      t5 = sqrt(c2);
      tb14 = sb[i][2];
      sb[i][2] = 0.0;
      Zb[j][5] += tb14;
      Ab[j][6] -= tb14 * roll;
      rollb = -(tb14 * A[j][6]);
      tb12 = sb[i][1];
      sb[i][1] = 0.0;
      tb13 = tb12 / t5;
      A_j0b = tb13 * Z_j4;
      Z_j4b = tb13 * A_j0;
      A_j3b = -(tb13 * Z_j3);
      Z_j3b = -(tb13 * A_j3);
      t5b = -(tb13 * s[i][1]);
      c2b = t5b * (1.0 / (2.0 * t5));
      rollb += sb[i][0];
      sb[i][0] = 0.0;
      tb11 = rollb / c2;
      A_j0b += tb11 * Z_j3;
      Z_j3b += tb11 * A_j0;
      A_j3b += tb11 * Z_j4;
      Z_j4b += tb11 * A_j3;
      c2b -= tb11 * roll;
      Zb[j][4] += Z_j4b;
      Zb[j][3] += Z_j3b;
      /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
       * A_6 = -sin(pitch) */
      A_j0b += c2b * A_j0;
      A_j0b += c2b * A_j0;
      A_j3b += c2b * A_j3;
      A_j3b += c2b * A_j3;
      Ab[j][3] += A_j3b;
      Ab[j][0] += A_j0b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_VELOCITY) {
      Zb[j][5] += sb[i][2];
      sb[i][2] = 0.0;
      Zb[j][4] += sb[i][1];
      sb[i][1] = 0.0;
      Zb[j][3] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_ACCELERATION) {
      Zab[j][5] += sb[i][2];
      sb[i][2] = 0.0;
      Zab[j][4] += sb[i][1];
      sb[i][1] = 0.0;
      Zab[j][3] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SPRING) {
      a = t->springpa[n2];
      b = t->springpb[n2];
      e0 = r[a][0] - r[b][0];
      ev0 = rv[a][0] - rv[b][0];
      e1 = r[a][1] - r[b][1];
      ev1 = rv[a][1] - rv[b][1];
      e2_2 = r[a][2] - r[b][2];
      ev2_2 = rv[a][2] - rv[b][2];
      t6 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
      l = sqrt(t6);
      n30 = e0 / l;
      n31 = e1 / l;
      n32 = e2_2 / l;
      lv = n30 * ev0 + n31 * ev1 + n32 * ev2_2;
      k2 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
      tb22 = sb[i][2];
      sb[i][2] = 0.0;
      f0b = tb22;
      f1b = tb22;
      z1b = sb[i][1];
      sb[i][1] = 0.0;
      z0_3b = sb[i][0];
      sb[i][0] = 0.0;
      lvb = z1b;
      lb = z0_3b;
      dampingb = 0.0;
      if (t->springslopes[n2]) {
        dampingb += f1b;
        f2b = f1b;
        f1b = 0.0;
        /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
        if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
          p_k24 = p[k2 + 4];
          pb[k2] += f2b * p_k24;
          p_k24b = f2b * p[k2];
          pb[k2 + 1] += f2b * (lv - p_k24);
          tb20 = f2b * p[k2 + 1];
          lvb += tb20;
          p_k24b -= tb20;
          f2b = 0.0;
          pb[k2 + 4] += p_k24b;
        } else if (MAGGI_RE(lv) > 0.0) {
          pb[k2] += f2b * lv;
          lvb += f2b * p[k2];
          f2b = 0.0;
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
          pb[k2 + 2] += f2b * lv;
          lvb += f2b * p[k2 + 2];
          f2b = 0.0;
        } else {
          p_k25 = p[k2 + 5];
          pb[k2 + 2] += f2b * p_k25;
          p_k25b = f2b * p[k2 + 2];
          pb[k2 + 3] += f2b * (lv - p_k25);
          tb21 = f2b * p[k2 + 3];
          lvb += tb21;
          p_k25b -= tb21;
          f2b = 0.0;
          pb[k2 + 5] += p_k25b;
        }
      } else {
        dampingb += f1b;
        f1b = 0.0;
      }
      if (t->springpreload[n2]) {
        pb[t->springadr[n2]] += f0b * (l - spring0[n2]);
        tb18 = f0b * p[t->springadr[n2]];
        lb += tb18;
        spring0b[n2] -= tb18;
        pb[t->springadr[n2] + MAGGI_SPRING_L] += f0b;
        f0b = 0.0;
      } else {
        pb[t->springadr[n2]] += f0b * (l - p[t->springadr[n2] + MAGGI_SPRING_L]);
        tb19 = f0b * p[t->springadr[n2]];
        lb += tb19;
        pb[t->springadr[n2] + MAGGI_SPRING_L] -= tb19;
        f0b = 0.0;
      }
      pb[t->springadr[n2] + MAGGI_SPRING_C] += dampingb * lv;
      lvb += dampingb * p[t->springadr[n2] + MAGGI_SPRING_C];
      n30b = lvb * ev0;
      ev0b = lvb * n30;
      n31b = lvb * ev1;
      ev1b = lvb * n31;
      n32b = lvb * ev2_2;
      ev2_2b = lvb * n32;
      tb17 = n32b / l;
      e2_2b = tb17;
      lb -= tb17 * n32;
      tb16 = n31b / l;
      e1b = tb16;
      lb -= tb16 * n31;
      tb15 = n30b / l;
      e0b = tb15;
      lb -= tb15 * n30;
      t6b = lb * (1.0 / (2.0 * l));
      e0b += t6b * e0;
      e0b += t6b * e0;
      e1b += t6b * e1;
      e1b += t6b * e1;
      e2_2b += t6b * e2_2;
      e2_2b += t6b * e2_2;
      rvb[a][2] += ev2_2b;
      rvb[b][2] -= ev2_2b;
      rb[a][2] += e2_2b;
      rb[b][2] -= e2_2b;
      rvb[a][1] += ev1b;
      rvb[b][1] -= ev1b;
      rb[a][1] += e1b;
      rb[b][1] -= e1b;
      rvb[a][0] += ev0b;
      rvb[b][0] -= ev0b;
      rb[a][0] += e0b;
      rb[b][0] -= e0b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_JOINT_SPRING) {
      if (t->jspringq2[n2] >= 0) {
        x2 = q[t->jspringq[n2]] - q[t->jspringq2[n2]];
        xv = v[t->jspringq[n2]] - v[t->jspringq2[n2]];
      } else {
        x2 = q[t->jspringq[n2]];
        xv = v[t->jspringq[n2]];
      }
      torque0b = sb[i][2];
      sb[i][2] = 0.0;
      z1_2b = sb[i][1];
      sb[i][1] = 0.0;
      z0_4b = sb[i][0];
      sb[i][0] = 0.0;
      xvb = z1_2b;
      x2b = z0_4b;
      pb[t->jspringadr[n2]] -= torque0b * (x2 - p[t->jspringadr[n2] + MAGGI_JSPRING_REST]);
      tb23 = torque0b * p[t->jspringadr[n2]];
      x2b -= tb23;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_REST] += tb23;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_C] -= torque0b * xv;
      xvb -= torque0b * p[t->jspringadr[n2] + MAGGI_JSPRING_C];
      pb[t->jspringadr[n2] + MAGGI_JSPRING_PRELOAD] -= torque0b;
      if (t->jspringq2[n2] >= 0) {
        vb[t->jspringq[n2]] += xvb;
        vb[t->jspringq2[n2]] -= xvb;
        xvb = 0.0;
        qb[t->jspringq[n2]] += x2b;
        qb[t->jspringq2[n2]] -= x2b;
        x2b = 0.0;
      } else {
        vb[t->jspringq[n2]] += xvb;
        xvb = 0.0;
        qb[t->jspringq[n2]] += x2b;
        x2b = 0.0;
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ROD) {
      a3 = t->primpa[n2];
      b7 = t->primpb[n2];
      e20 = r[a3][0] - r[b7][0];
      ev20 = rv[a3][0] - rv[b7][0];
      e21 = r[a3][1] - r[b7][1];
      ev21 = rv[a3][1] - rv[b7][1];
      e22 = r[a3][2] - r[b7][2];
      ev22 = rv[a3][2] - rv[b7][2];
      t7 = e20 * e20 + e21 * e21 + e22 * e22;
      l2 = sqrt(t7);
      z1_3 = s[i][1];
      lambdab[t->primrow[n2]] += sb[i][2];
      sb[i][2] = 0.0;
      z1_3b = sb[i][1];
      sb[i][1] = 0.0;
      z0_5b = sb[i][0];
      sb[i][0] = 0.0;
      tb24 = z1_3b / l2;
      e20b = tb24 * ev20;
      ev20b = tb24 * e20;
      e21b = tb24 * ev21;
      ev21b = tb24 * e21;
      e22b = tb24 * ev22;
      ev22b = tb24 * e22;
      l2b = -(tb24 * z1_3);
      l2b += z0_5b;
      t7b = l2b * (1.0 / (2.0 * l2));
      e20b += t7b * e20;
      e20b += t7b * e20;
      e21b += t7b * e21;
      e21b += t7b * e21;
      e22b += t7b * e22;
      e22b += t7b * e22;
      rvb[a3][2] += ev22b;
      rvb[b7][2] -= ev22b;
      rb[a3][2] += e22b;
      rb[b7][2] -= e22b;
      rvb[a3][1] += ev21b;
      rvb[b7][1] -= ev21b;
      rb[a3][1] += e21b;
      rb[b7][1] -= e21b;
      rvb[a3][0] += ev20b;
      rvb[b7][0] -= ev20b;
      /* distance of two points and its rate */
      rb[a3][0] += e20b;
      rb[b7][0] -= e20b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_SLIP) {
      slipb[n2][MAGGI_SLIP_GAMMA] += sb[i][2];
      sb[i][2] = 0.0;
      tb25 = sb[i][1];
      sb[i][1] = 0.0;
      slipb[n2][MAGGI_SLIP_TAN_ALPHA] += tb25 * (1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] *
          slip[n2][MAGGI_SLIP_TAN_ALPHA]));
      slipb[n2][MAGGI_SLIP_KAPPA] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_FORCE) {
      gripb[n2][2] += sb[i][2];
      sb[i][2] = 0.0;
      gripb[n2][1] += sb[i][1];
      sb[i][1] = 0.0;
      gripb[n2][0] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_MOMENT) {
      gripb[n2][5] += sb[i][2];
      sb[i][2] = 0.0;
      gripb[n2][4] += sb[i][1];
      sb[i][1] = 0.0;
      gripb[n2][3] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_CONTACT) {
      slipb[n2][MAGGI_SLIP_ROLLING] += sb[i][2];
      sb[i][2] = 0.0;
      slip_n2b = sb[i][1];
      sb[i][1] = 0.0;
      tb26 = sb[i][0];
      sb[i][0] = 0.0;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb26;
      slip_n2b -= tb26;
      slipb[n2][MAGGI_SLIP_RADIUS] += slip_n2b;
    } else {
      side = t->wheelmirror[n2] ? -1.0 : 1.0;
      /* slopes of the formula, which a tyre of the other side has as well; 0 in the air */
      if (MAGGI_RE(grip[n2][2]) > 0.0) {
        one0 = slip[n2][MAGGI_SLIP_KAPPA];
        one1 = side * slip[n2][MAGGI_SLIP_TAN_ALPHA];
        one2 = side * slip[n2][MAGGI_SLIP_GAMMA];
        one3 = grip[n2][2];
        kappa = one0;
        a2 = one1;
        gamma = one2;
        fz = one3;
        fz0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]];
        dfz = (fz - fz0) / fz0;
        kx = kappa + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
        gx2 = gamma * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
        mux = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2
            * gx2) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        e3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEX2] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
        if (MAGGI_RE(kx) > 0.0) {
          e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          if (MAGGI_RE(e4) > 1.0) {
            y2 = 1.0;
          } else {
            y2 = e4;
          }
          ex = y2;
        } else {
          e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          if (MAGGI_RE(e5) > 1.0) {
            y3 = 1.0;
          } else {
            y3 = e5;
          }
          ex = y3;
        }
        x30 = mux * fz;
        x31 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCX];
        x32 = ex;
        t8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
        t9 = exp(t8);
        x33 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t9 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        x34 = kx;
        x35 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LMUX];
        fz0_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]];
        gy2 = gamma * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
        ay = a2 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHY3] * gy2;
        muy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2
            * gy2) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        e6 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
        if (MAGGI_RE(ay) > 0.0) {
          e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          if (MAGGI_RE(e7) > 1.0) {
            y4 = 1.0;
          } else {
            y4 = e7;
          }
          ey = y4;
        } else {
          e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          if (MAGGI_RE(e8) > 1.0) {
            y5 = 1.0;
          } else {
            y5 = e8;
          }
          ey = y5;
        }
        t10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2;
        z2 = fz / t10;
        y0_3 = muy * fz;
        y1 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCY];
        y2_2 = ey;
        if (MAGGI_RE(gy2) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
          y6 = gy2;
        } else if (MAGGI_RE(gy2) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LOW_CAMBER])) {
          y6 = -gy2;
        } else {
          p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
          t11 = p2 * p2;
          z3 = gy2 * gy2 / t11;
          y6 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
        }
        t12 = 1.0 + z2 * z2;
        t13 = 2.0 * z2 / t12;
        y3_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) * p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_LKY];
        y4_2 = ay;
        y5_2 = fz * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        peak = y0_3;
        x4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa;
        t14 = 1.0 + x4 * x4;
        t15 = sqrt(t14);
        t16 = 1.0 / t15;
        g0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t16 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g1 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
        e9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REX2] * dfz;
        if (MAGGI_RE(e9) > 1.0) {
          y7 = 1.0;
        } else {
          y7 = e9;
        }
        g2 = y7;
        g3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        x5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        t17 = 1.0 + x5 * x5;
        t18 = sqrt(t17);
        t19 = 1.0 / t18;
        g4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t19 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
        e10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REY2] * dfz;
        if (MAGGI_RE(e10) > 1.0) {
          y8 = 1.0;
        } else {
          y8 = e10;
        }
        g6 = y8;
        g7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RHY2] * dfz;
        p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        x6 = p3 * a2;
        t20 = 1.0 + x6 * x6;
        t21 = sqrt(t20);
        t22 = 1.0 / t21;
        dv = peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) * t22;
        t23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa;
        t24 = atan(t23);
        t25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t24;
        t26 = sin(t25);
        g8 = dv * t26 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        y9 = g0 * (a2 + g3);
        y10 = g0 * g3;
        t27 = atan(y9);
        t28 = (1.0 - g2) * y9 + g2 * t27;
        t29 = atan(t28);
        t30 = g1 * t29;
        t31 = cos(t30);
        t32 = atan(y10);
        t33 = (1.0 - g2) * y10 + g2 * t32;
        t34 = atan(t33);
        t35 = g1 * t34;
        t36 = cos(t35);
        gx = t31 / t36;
        y11 = g4 * (kappa + g7);
        y12 = g4 * g7;
        t37 = atan(y11);
        t38 = (1.0 - g6) * y11 + g6 * t37;
        t39 = atan(t38);
        t40 = g5 * t39;
        t41 = cos(t40);
        t42 = atan(y12);
        t43 = (1.0 - g6) * y12 + g6 * t42;
        t44 = atan(t43);
        t45 = g5 * t44;
        t46 = cos(t45);
        gy = t41 / t46;
        b3 = g0;
        c = g1;
        e11 = g2;
        shift = g3;
        y13 = b3 * (a2 + shift);
        y0 = b3 * shift;
        t47 = atan(y13);
        t48 = (1.0 - e11) * y13 + e11 * t47;
        t49 = atan(t48);
        z4 = c * t49;
        t50 = atan(y0);
        t51 = (1.0 - e11) * y0 + e11 * t50;
        t52 = atan(t51);
        z0 = c * t52;
        n4 = cos(z0);
        t53 = atan(y13);
        z5 = (1.0 - e11) * y13 + e11 * t53;
        t54 = sin(z4);
        t55 = 1.0 + y13 * y13;
        t56 = e11 / t55;
        t57 = 1.0 + z5 * z5;
        t58 = c * (1.0 - e11 + t56) / t57;
        s2 = -t54 * t58 / n4;
        t59 = atan(y0);
        z6 = (1.0 - e11) * y0 + e11 * t59;
        t60 = cos(z4);
        t61 = sin(z0);
        t62 = n4 * n4;
        t63 = t60 * t61 / t62;
        t64 = 1.0 + y0 * y0;
        t65 = e11 / t64;
        t66 = 1.0 + z6 * z6;
        t67 = c * (1.0 - e11 + t65) / t66;
        wx1 = s2 * (a2 + shift) + t63 * t67 * shift;
        b4 = g4;
        c3 = g5;
        e12 = g6;
        shift2 = g7;
        y14 = b4 * (kappa + shift2);
        y0_2 = b4 * shift2;
        t68 = atan(y14);
        t69 = (1.0 - e12) * y14 + e12 * t68;
        t70 = atan(t69);
        z7 = c3 * t70;
        t71 = atan(y0_2);
        t72 = (1.0 - e12) * y0_2 + e12 * t71;
        t73 = atan(t72);
        z0_2 = c3 * t73;
        n5 = cos(z0_2);
        t74 = atan(y14);
        z8 = (1.0 - e12) * y14 + e12 * t74;
        t75 = sin(z7);
        t76 = 1.0 + y14 * y14;
        t77 = e12 / t76;
        t78 = 1.0 + z8 * z8;
        t79 = c3 * (1.0 - e12 + t77) / t78;
        s3 = -t75 * t79 / n5;
        t80 = atan(y0_2);
        z9 = (1.0 - e12) * y0_2 + e12 * t80;
        t81 = cos(z7);
        t82 = sin(z0_2);
        t83 = n5 * n5;
        t84 = t81 * t82 / t83;
        t85 = 1.0 + y0_2 * y0_2;
        t86 = e12 / t85;
        t87 = 1.0 + z9 * z9;
        t88 = c3 * (1.0 - e12 + t86) / t87;
        wy1 = s3 * (kappa + shift2) + t84 * t88 * shift2;
        t89 = x31 * x30;
        t90 = x33 / t89;
        y15 = t90 * x34;
        t91 = atan(y15);
        t92 = (1.0 - x32) * y15 + x32 * t91;
        t93 = atan(t92);
        t94 = x31 * t93;
        t95 = sin(t94);
        fx = x30 * t95 + x35;
        t96 = y1 * y0_3;
        t97 = y3_2 / t96;
        y16 = t97 * y4_2;
        t98 = atan(y16);
        t99 = (1.0 - y2_2) * y16 + y2_2 * t98;
        t100 = atan(t99);
        t101 = y1 * t100;
        t102 = sin(t101);
        fy = y0_3 * t102 + y5_2;
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        x7 = p4 * (a2 - p5);
        t103 = 1.0 + x7 * x7;
        t104 = sqrt(t103);
        t105 = 1.0 / t104;
        l3 = p4 * t105;
        x8 = p3 * a2;
        t106 = 1.0 + x8 * x8;
        t107 = sqrt(t106);
        t108 = 1.0 / t107;
        v2 = p3 * t108;
        b2 = -g4 * l3 * l3 * (a2 - p5);
        t109 = y1 * y0_3;
        b5 = y3_2 / t109;
        y17 = b5 * y4_2;
        t110 = atan(y17);
        z10 = (1.0 - y2_2) * y17 + y2_2 * t110;
        t111 = atan(y17);
        t112 = (1.0 - y2_2) * y17 + y2_2 * t111;
        t113 = atan(t112);
        t114 = y1 * t113;
        t115 = cos(t114);
        t116 = 1.0 + y17 * y17;
        t117 = y2_2 / t116;
        t118 = 1.0 + z10 * z10;
        t119 = y1 * (1.0 - y2_2 + t117) / t118;
        p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        x9 = p6 * kappa;
        t120 = 1.0 + x9 * x9;
        t121 = sqrt(t120);
        t122 = 1.0 / t121;
        m = p6 * t122;
        ka = -g0 * m * m * kappa;
        t123 = x31 * x30;
        b6 = x33 / t123;
        y18 = b6 * x34;
        t124 = atan(y18);
        z11 = (1.0 - x32) * y18 + x32 * t124;
        t125 = atan(y18);
        t126 = (1.0 - x32) * y18 + x32 * t125;
        t127 = atan(t126);
        t128 = x31 * t127;
        t129 = cos(t128);
        t130 = 1.0 + y18 * y18;
        t131 = x32 / t130;
        t132 = 1.0 + z11 * z11;
        t133 = x31 * (1.0 - x32 + t131) / t132;
        ux = fx * gx / x30;
        uy = (fy * gy + g8) / y0_3;
        tb132 = sb[i][2];
        sb[i][2] = 0.0;
        t134b = tb132 * (1.0 / (2.0 * s[i][2]));
        uxb = t134b * ux;
        uxb += t134b * ux;
        uyb = t134b * uy;
        uyb += t134b * uy;
        tb131 = uyb / y0_3;
        fyb = tb131 * gy;
        gyb = tb131 * fy;
        g8b = tb131;
        y0_3b = -(tb131 * uy);
        tb130 = uxb / x30;
        fxb = tb130 * gx;
        gxb = tb130 * fx;
        x30b = -(tb130 * ux);
        tb125 = sb[i][1];
        sb[i][1] = 0.0;
        gxb += tb125 * (x30 * t129 * t133 * b6);
        tb126 = tb125 * gx;
        tb127 = tb126 * b6;
        tb128 = tb127 * t133;
        x30b += tb128 * t129;
        t129b = tb128 * x30;
        t133b = tb127 * (x30 * t129);
        b6b = tb126 * (x30 * t129 * t133);
        tb129 = tb125 * ka;
        fxb += tb129 * wx1;
        wx1b = tb129 * fx;
        kab = tb125 * (fx * wx1);
        tb123 = t133b / t132;
        x31b = tb123 * (1.0 - x32 + t131);
        tb124 = tb123 * x31;
        x32b = -tb124;
        t131b = tb124;
        t132b = -(tb123 * t133);
        z11b = t132b * z11;
        z11b += t132b * z11;
        tb122 = t131b / t130;
        x32b += tb122;
        t130b = -(tb122 * t131);
        y18b = t130b * y18;
        y18b += t130b * y18;
        t128b = -(t129b * sin(t128));
        x31b += t128b * t127;
        t127b = t128b * x31;
        t126b = t127b * (1.0 / (1.0 + t126 * t126));
        x32b -= t126b * y18;
        y18b += t126b * (1.0 - x32);
        x32b += t126b * t125;
        t125b = t126b * x32;
        y18b += t125b * (1.0 / (1.0 + y18 * y18));
        x32b -= z11b * y18;
        y18b += z11b * (1.0 - x32);
        x32b += z11b * t124;
        t124b = z11b * x32;
        /* its derivative by y */
        y18b += t124b * (1.0 / (1.0 + y18 * y18));
        b6b += y18b * x34;
        x34b = y18b * b6;
        tb121 = b6b / t123;
        x33b = tb121;
        t123b = -(tb121 * b6);
        /* its derivative by the slip */
        x31b += t123b * x30;
        x30b += t123b * x31;
        tb119 = kab * kappa;
        tb120 = tb119 * m;
        g0b = -(tb120 * m);
        mb = -(tb120 * g0);
        mb += tb119 * (-g0 * m);
        kappab = kab * (-g0 * m * m);
        p6b = mb * t122;
        t122b = mb * p6;
        tb118 = t122b / t121;
        t121b = -(tb118 * t122);
        t120b = t121b * (1.0 / (2.0 * t121));
        x9b = t120b * x9;
        x9b += t120b * x9;
        p6b += x9b * kappa;
        kappab += x9b * p6;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += p6b;
        tb109 = sb[i][0];
        sb[i][0] = 0.0;
        tb110 = tb109 * (gy * (y0_3 * t115 * t119 * b5) + fy * wy1 * b2 - g8 * v2 * v2 * a2);
        a2b = tb110 * a2;
        a2b += tb110 * a2;
        tb111 = tb109 * (1.0 + a2 * a2);
        gyb += tb111 * (y0_3 * t115 * t119 * b5);
        tb112 = tb111 * gy;
        tb113 = tb112 * b5;
        tb114 = tb113 * t119;
        y0_3b += tb114 * t115;
        t115b = tb114 * y0_3;
        t119b = tb113 * (y0_3 * t115);
        b5b = tb112 * (y0_3 * t115 * t119);
        tb115 = tb111 * b2;
        fyb += tb115 * wy1;
        wy1b = tb115 * fy;
        b2b = tb111 * (fy * wy1);
        tb116 = tb111 * a2;
        tb117 = tb116 * v2;
        g8b -= tb117 * v2;
        v2b = -(tb117 * g8);
        v2b -= tb116 * (g8 * v2);
        a2b -= tb111 * (g8 * v2 * v2);
        tb107 = t119b / t118;
        y1b = tb107 * (1.0 - y2_2 + t117);
        tb108 = tb107 * y1;
        y2_2b = -tb108;
        t117b = tb108;
        t118b = -(tb107 * t119);
        z10b = t118b * z10;
        z10b += t118b * z10;
        tb106 = t117b / t116;
        y2_2b += tb106;
        t116b = -(tb106 * t117);
        y17b = t116b * y17;
        y17b += t116b * y17;
        t114b = -(t115b * sin(t114));
        y1b += t114b * t113;
        t113b = t114b * y1;
        t112b = t113b * (1.0 / (1.0 + t112 * t112));
        y2_2b -= t112b * y17;
        y17b += t112b * (1.0 - y2_2);
        y2_2b += t112b * t111;
        t111b = t112b * y2_2;
        y17b += t111b * (1.0 / (1.0 + y17 * y17));
        y2_2b -= z10b * y17;
        y17b += z10b * (1.0 - y2_2);
        y2_2b += z10b * t110;
        t110b = z10b * y2_2;
        /* its derivative by y */
        y17b += t110b * (1.0 / (1.0 + y17 * y17));
        b5b += y17b * y4_2;
        y4_2b = y17b * b5;
        tb105 = b5b / t109;
        y3_2b = tb105;
        t109b = -(tb105 * b5);
        /* its derivative by the slip */
        y1b += t109b * y0_3;
        y0_3b += t109b * y1;
        tb102 = b2b * (a2 - p5);
        tb103 = tb102 * l3;
        g4b = -(tb103 * l3);
        l3b = -(tb103 * g4);
        l3b += tb102 * (-g4 * l3);
        tb104 = b2b * (-g4 * l3 * l3);
        a2b += tb104;
        p5b = -tb104;
        p3b = v2b * t108;
        t108b = v2b * p3;
        tb101 = t108b / t107;
        t107b = -(tb101 * t108);
        t106b = t107b * (1.0 / (2.0 * t107));
        x8b = t106b * x8;
        x8b += t106b * x8;
        p3b += x8b * a2;
        a2b += x8b * p3;
        p4b = l3b * t105;
        t105b = l3b * p4;
        tb100 = t105b / t104;
        t104b = -(tb100 * t105);
        t103b = t104b * (1.0 / (2.0 * t104));
        x7b = t103b * x7;
        x7b += t103b * x7;
        /* b and the shift of Fy change with a by their cos(atan()) */
        p4b += x7b * (a2 - p5);
        tb99 = x7b * p4;
        a2b += tb99;
        p5b -= tb99;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] += p5b;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += p4b;
        y0_3b += fyb * t102;
        t102b = fyb * y0_3;
        y5_2b = fyb;
        t101b = t102b * cos(t101);
        y1b += t101b * t100;
        t100b = t101b * y1;
        t99b = t100b * (1.0 / (1.0 + t99 * t99));
        y2_2b -= t99b * y16;
        y16b = t99b * (1.0 - y2_2);
        y2_2b += t99b * t98;
        t98b = t99b * y2_2;
        y16b += t98b * (1.0 / (1.0 + y16 * y16));
        t97b = y16b * y4_2;
        y4_2b += y16b * t97;
        tb98 = t97b / t96;
        y3_2b += tb98;
        t96b = -(tb98 * t97);
        y1b += t96b * y0_3;
        y0_3b += t96b * y1;
        x30b += fxb * t95;
        t95b = fxb * x30;
        x35b = fxb;
        t94b = t95b * cos(t94);
        x31b += t94b * t93;
        t93b = t94b * x31;
        t92b = t93b * (1.0 / (1.0 + t92 * t92));
        x32b -= t92b * y15;
        y15b = t92b * (1.0 - x32);
        x32b += t92b * t91;
        t91b = t92b * x32;
        y15b += t91b * (1.0 / (1.0 + y15 * y15));
        t90b = y15b * x34;
        x34b += y15b * t90;
        tb97 = t90b / t89;
        x33b += tb97;
        t89b = -(tb97 * t90);
        x31b += t89b * x30;
        x30b += t89b * x31;
        s3b = wy1b * (kappa + shift2);
        tb95 = wy1b * s3;
        kappab += tb95;
        shift2b = tb95;
        tb96 = wy1b * shift2;
        t84b = tb96 * t88;
        t88b = tb96 * t84;
        shift2b += wy1b * (t84 * t88);
        tb93 = t88b / t87;
        c3b = tb93 * (1.0 - e12 + t86);
        tb94 = tb93 * c3;
        e12b = -tb94;
        t86b = tb94;
        t87b = -(tb93 * t88);
        z9b = t87b * z9;
        z9b += t87b * z9;
        tb92 = t86b / t85;
        e12b += tb92;
        t85b = -(tb92 * t86);
        y0_2b = t85b * y0_2;
        y0_2b += t85b * y0_2;
        tb91 = t84b / t83;
        t81b = tb91 * t82;
        t82b = tb91 * t81;
        t83b = -(tb91 * t84);
        n5b = t83b * n5;
        n5b += t83b * n5;
        z0_2b = t82b * cos(z0_2);
        z7b = -(t81b * sin(z7));
        e12b -= z9b * y0_2;
        y0_2b += z9b * (1.0 - e12);
        e12b += z9b * t80;
        t80b = z9b * e12;
        /* its derivative by y */
        y0_2b += t80b * (1.0 / (1.0 + y0_2 * y0_2));
        tb90 = s3b / n5;
        t75b = -(tb90 * t79);
        t79b = -(tb90 * t75);
        n5b -= tb90 * s3;
        tb88 = t79b / t78;
        c3b += tb88 * (1.0 - e12 + t77);
        tb89 = tb88 * c3;
        e12b -= tb89;
        t77b = tb89;
        t78b = -(tb88 * t79);
        z8b = t78b * z8;
        z8b += t78b * z8;
        tb87 = t77b / t76;
        e12b += tb87;
        t76b = -(tb87 * t77);
        y14b = t76b * y14;
        y14b += t76b * y14;
        z7b += t75b * cos(z7);
        e12b -= z8b * y14;
        y14b += z8b * (1.0 - e12);
        e12b += z8b * t74;
        t74b = z8b * e12;
        /* its derivative by y */
        y14b += t74b * (1.0 / (1.0 + y14 * y14));
        z0_2b -= n5b * sin(z0_2);
        c3b += z0_2b * t73;
        t73b = z0_2b * c3;
        t72b = t73b * (1.0 / (1.0 + t72 * t72));
        e12b -= t72b * y0_2;
        y0_2b += t72b * (1.0 - e12);
        e12b += t72b * t71;
        t71b = t72b * e12;
        y0_2b += t71b * (1.0 / (1.0 + y0_2 * y0_2));
        c3b += z7b * t70;
        t70b = z7b * c3;
        t69b = t70b * (1.0 / (1.0 + t69 * t69));
        e12b -= t69b * y14;
        y14b += t69b * (1.0 - e12);
        e12b += t69b * t68;
        t68b = t69b * e12;
        y14b += t68b * (1.0 / (1.0 + y14 * y14));
        b4b = y0_2b * shift2;
        shift2b += y0_2b * b4;
        /* its derivatives by x and by b */
        b4b += y14b * (kappa + shift2);
        tb86 = y14b * b4;
        kappab += tb86;
        shift2b += tb86;
        g7b = shift2b;
        g6b = e12b;
        g5b = c3b;
        g4b += b4b;
        s2b = wx1b * (a2 + shift);
        tb84 = wx1b * s2;
        a2b += tb84;
        shiftb = tb84;
        tb85 = wx1b * shift;
        t63b = tb85 * t67;
        t67b = tb85 * t63;
        shiftb += wx1b * (t63 * t67);
        tb82 = t67b / t66;
        cb = tb82 * (1.0 - e11 + t65);
        tb83 = tb82 * c;
        e11b = -tb83;
        t65b = tb83;
        t66b = -(tb82 * t67);
        z6b = t66b * z6;
        z6b += t66b * z6;
        tb81 = t65b / t64;
        e11b += tb81;
        t64b = -(tb81 * t65);
        y0b = t64b * y0;
        y0b += t64b * y0;
        tb80 = t63b / t62;
        t60b = tb80 * t61;
        t61b = tb80 * t60;
        t62b = -(tb80 * t63);
        n4b = t62b * n4;
        n4b += t62b * n4;
        z0b = t61b * cos(z0);
        z4b = -(t60b * sin(z4));
        e11b -= z6b * y0;
        y0b += z6b * (1.0 - e11);
        e11b += z6b * t59;
        t59b = z6b * e11;
        /* its derivative by y */
        y0b += t59b * (1.0 / (1.0 + y0 * y0));
        tb79 = s2b / n4;
        t54b = -(tb79 * t58);
        t58b = -(tb79 * t54);
        n4b -= tb79 * s2;
        tb77 = t58b / t57;
        cb += tb77 * (1.0 - e11 + t56);
        tb78 = tb77 * c;
        e11b -= tb78;
        t56b = tb78;
        t57b = -(tb77 * t58);
        z5b = t57b * z5;
        z5b += t57b * z5;
        tb76 = t56b / t55;
        e11b += tb76;
        t55b = -(tb76 * t56);
        y13b = t55b * y13;
        y13b += t55b * y13;
        z4b += t54b * cos(z4);
        e11b -= z5b * y13;
        y13b += z5b * (1.0 - e11);
        e11b += z5b * t53;
        t53b = z5b * e11;
        /* its derivative by y */
        y13b += t53b * (1.0 / (1.0 + y13 * y13));
        z0b -= n4b * sin(z0);
        cb += z0b * t52;
        t52b = z0b * c;
        t51b = t52b * (1.0 / (1.0 + t51 * t51));
        e11b -= t51b * y0;
        y0b += t51b * (1.0 - e11);
        e11b += t51b * t50;
        t50b = t51b * e11;
        y0b += t50b * (1.0 / (1.0 + y0 * y0));
        cb += z4b * t49;
        t49b = z4b * c;
        t48b = t49b * (1.0 / (1.0 + t48 * t48));
        e11b -= t48b * y13;
        y13b += t48b * (1.0 - e11);
        e11b += t48b * t47;
        t47b = t48b * e11;
        y13b += t47b * (1.0 / (1.0 + y13 * y13));
        b3b = y0b * shift;
        shiftb += y0b * b3;
        /* its derivatives by x and by b */
        b3b += y13b * (a2 + shift);
        tb75 = y13b * b3;
        a2b += tb75;
        shiftb += tb75;
        g3b = shiftb;
        g2b = e11b;
        g1b = cb;
        g0b += b3b;
        tb74 = gyb / t46;
        t41b = tb74;
        t46b = -(tb74 * gy);
        t45b = -(t46b * sin(t45));
        g5b += t45b * t44;
        t44b = t45b * g5;
        t43b = t44b * (1.0 / (1.0 + t43 * t43));
        g6b -= t43b * y12;
        y12b = t43b * (1.0 - g6);
        g6b += t43b * t42;
        t42b = t43b * g6;
        y12b += t42b * (1.0 / (1.0 + y12 * y12));
        t40b = -(t41b * sin(t40));
        g5b += t40b * t39;
        t39b = t40b * g5;
        t38b = t39b * (1.0 / (1.0 + t38 * t38));
        g6b -= t38b * y11;
        y11b = t38b * (1.0 - g6);
        g6b += t38b * t37;
        t37b = t38b * g6;
        y11b += t37b * (1.0 / (1.0 + y11 * y11));
        g4b += y12b * g7;
        g7b += y12b * g4;
        g4b += y11b * (kappa + g7);
        tb73 = y11b * g4;
        kappab += tb73;
        g7b += tb73;
        tb72 = gxb / t36;
        t31b = tb72;
        t36b = -(tb72 * gx);
        t35b = -(t36b * sin(t35));
        g1b += t35b * t34;
        t34b = t35b * g1;
        t33b = t34b * (1.0 / (1.0 + t33 * t33));
        g2b -= t33b * y10;
        y10b = t33b * (1.0 - g2);
        g2b += t33b * t32;
        t32b = t33b * g2;
        y10b += t32b * (1.0 / (1.0 + y10 * y10));
        t30b = -(t31b * sin(t30));
        g1b += t30b * t29;
        t29b = t30b * g1;
        t28b = t29b * (1.0 / (1.0 + t28 * t28));
        g2b -= t28b * y9;
        y9b = t28b * (1.0 - g2);
        g2b += t28b * t27;
        t27b = t28b * g2;
        y9b += t27b * (1.0 / (1.0 + y9 * y9));
        g0b += y10b * g3;
        g3b += y10b * g0;
        g0b += y9b * (a2 + g3);
        tb71 = y9b * g0;
        a2b += tb71;
        g3b += tb71;
        tb70 = g8b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        dvb = tb70 * t26;
        t26b = tb70 * dv;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g8b * (dv * t26);
        t25b = t26b * cos(t25);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t25b * t24;
        t24b = t25b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
        t23b = t24b * (1.0 / (1.0 + t23 * t23));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t23b * kappa;
        kappab += t23b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
        tb68 = dvb * t22;
        peakb = tb68 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma);
        tb69 = tb68 * peak;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb69;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb69 * dfz;
        dfzb = tb69 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb69 * gamma;
        gammab = tb69 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
        t22b = dvb * (peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma));
        tb67 = t22b / t21;
        t21b = -(tb67 * t22);
        t20b = t21b * (1.0 / (2.0 * t21));
        x6b = t20b * x6;
        x6b += t20b * x6;
        p3b += x6b * a2;
        a2b += x6b * p3;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] += p3b;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] += g7b;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] += g7b * dfz;
        dfzb += g7b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2];
        y8b = g6b;
        e10b = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e10) > 1.0) {
          y8b = 0.0;
        } else {
          e10b += y8b;
          y8b = 0.0;
        }
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] += e10b;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] += e10b * dfz;
        dfzb += e10b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += g5b;
        tb66 = g4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb66 * t19;
        t19b = tb66 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += g4b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RBY1] * t19);
        tb65 = t19b / t18;
        t18b = -(tb65 * t19);
        t17b = t18b * (1.0 / (2.0 * t18));
        x5b = t17b * x5;
        x5b += t17b * x5;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x5b * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        tb64 = x5b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        a2b += tb64;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb64;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1] += g3b;
        y7b = g2b;
        e9b = 0.0;
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e9) > 1.0) {
          y7b = 0.0;
        } else {
          e9b += y7b;
          y7b = 0.0;
        }
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] += e9b;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] += e9b * dfz;
        dfzb += e9b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += g1b;
        tb63 = g0b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb63 * t16;
        t16b = tb63 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += g0b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RBX1] * t16);
        tb62 = t16b / t15;
        t15b = -(tb62 * t16);
        t14b = t15b * (1.0 / (2.0 * t15));
        x4b = t14b * x4;
        x4b += t14b * x4;
        /* what combined slip makes of the forces:  Fx = Gxa Fx0, Fy = Gyk Fy0 + SVyk.  g: b, c, e, shift of Gxa,
         * then of Gyk, SVyk */
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x4b * kappa;
        kappab += x4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        y0_3b += peakb;
        tb58 = y5_2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        fzb = tb58 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2);
        tb59 = tb58 * fz;
        tb60 = tb59 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb60;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb60 * dfz;
        dfzb += tb60 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb59 * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz);
        tb61 = tb59 * gy2;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb61;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb61 * dfz;
        dfzb += tb61 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
        gy2b = tb59 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += y5_2b * (fz *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY4] * dfz) * gy2));
        ayb = y4_2b;
        tb54 = y3_2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
        tb55 = tb54 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6);
        tb56 = tb55 * t13;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb56 * fz0_2;
        fz0_2b = tb56 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
        t13b = tb55 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2);
        tb57 = tb54 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t13);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb57 * y6;
        y6b = -(tb57 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += y3_2b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKY1] * fz0_2 * t13 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKY3] * y6));
        tb53 = t13b / t12;
        z2b = tb53 * 2.0;
        t12b = -(tb53 * t13);
        z2b += t12b * z2;
        z2b += t12b * z2;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gy2) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
          gy2b += y6b;
          y6b = 0.0;
        } else if (MAGGI_RE(gy2) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LOW_CAMBER])) {
          gy2b -= y6b;
          y6b = 0.0;
        } else {
          p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
          t11 = p2 * p2;
          z3 = gy2 * gy2 / t11;
          tb51 = y6b * (15.0 + z3 * (-10.0 + 3.0 * z3));
          p2b = tb51 * z3 * 0.125;
          z3b = tb51 * (0.125 * p2);
          tb52 = y6b * (0.125 * p2 * z3);
          z3b += tb52 * (-10.0 + 3.0 * z3);
          z3b += tb52 * z3 * 3.0;
          y6b = 0.0;
          tb50 = z3b / t11;
          gy2b += tb50 * gy2;
          gy2b += tb50 * gy2;
          t11b = -(tb50 * z3);
          p2b += t11b * p2;
          p2b += t11b * p2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p2b;
        }
        eyb = y2_2b;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] += y1b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY] += y1b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PCY1];
        muyb = y0_3b * fz;
        fzb += y0_3b * muy;
        tb49 = z2b / t10;
        fzb += tb49;
        t10b = -(tb49 * z2);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t10b * fz0_2;
        fz0_2b += t10b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2];
        e6b = 0.0;
        if (MAGGI_RE(ay) > 0.0) {
          e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          y4b = eyb;
          eyb = 0.0;
          e7b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e7) > 1.0) {
            y4b = 0.0;
          } else {
            e7b += y4b;
            y4b = 0.0;
          }
          e6b += e7b * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          tb47 = e7b * e6;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb47;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb47 * gy2;
          gy2b -= tb47 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
        } else {
          e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          y5b = eyb;
          eyb = 0.0;
          e8b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e8) > 1.0) {
            y5b = 0.0;
          } else {
            e8b += y5b;
            y5b = 0.0;
          }
          e6b += e8b * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy2));
          tb48 = e8b * e6;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb48;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb48 * gy2;
          gy2b += tb48 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
        }
        tb46 = e6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb46;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb46 * dfz;
        dfzb += tb46 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] += e6b * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz);
        tb42 = muyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        tb43 = tb42 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb43;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb43 * dfz;
        dfzb += tb43 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
        tb44 = tb42 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz);
        tb45 = tb44 * gy2;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb45 * gy2;
        gy2b -= tb45 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
        gy2b -= tb44 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += muyb *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2
            * gy2));
        a2b += ayb;
        tb41 = ayb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb41;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb41 * dfz;
        dfzb += tb41 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] += ayb * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] += ayb * gy2;
        gy2b += ayb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3];
        gammab += gy2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] += gy2b * gamma;
        /* sin(2 atan(z)) = 2 z / (1 + z^2) */
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_2b *
            p[t->tyreadr[t->wheeltyre[n2]]];
        pb[t->tyreadr[t->wheeltyre[n2]]] += fz0_2b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LFZO];
        tb38 = x35b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb39 = tb38 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
        fzb += tb39 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz);
        tb40 = tb39 * fz;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb40;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb40 * dfz;
        dfzb += tb40 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb38 * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += x35b * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]);
        kxb = x34b;
        tb35 = x33b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        tb36 = tb35 * t9;
        fzb += tb36 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz);
        tb37 = tb36 * fz;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb37;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb37 * dfz;
        dfzb += tb37 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
        t9b = tb35 * (fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += x33b * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz) * t9);
        t8b = t9b * t9;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t8b * dfz;
        dfzb += t8b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3];
        exb = x32b;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] += x31b * p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_LCX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX] += x31b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PCX1];
        muxb = x30b * fz;
        fzb += x30b * mux;
        e3b = 0.0;
        if (MAGGI_RE(kx) > 0.0) {
          e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          y2b = exb;
          exb = 0.0;
          e4b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e4) > 1.0) {
            y2b = 0.0;
          } else {
            e4b += y2b;
            y2b = 0.0;
          }
          e3b += e4b * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4] -= e4b * e3;
        } else {
          e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          y3b = exb;
          exb = 0.0;
          e5b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e5) > 1.0) {
            y3b = 0.0;
          } else {
            e5b += y3b;
            y3b = 0.0;
          }
          e3b += e5b * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4] += e5b * e3;
        }
        tb33 = e3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb33;
        tb34 = tb33 * dfz;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb34;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb34 * dfz;
        dfzb += tb34 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
        dfzb += tb33 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] += e3b * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfz);
        tb29 = muxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb30 = tb29 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb30;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb30 * dfz;
        dfzb += tb30 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
        tb31 = tb29 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz);
        tb32 = tb31 * gx2;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb32 * gx2;
        gx2b = -(tb32 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
        gx2b -= tb31 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += muxb *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2
            * gx2));
        gammab += gx2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] += gx2b * gamma;
        kappab += kxb;
        tb28 = kxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb28;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb28 * dfz;
        dfzb += tb28 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz);
        tb27 = dfzb / fz0;
        fzb += tb27;
        fz0b = -tb27;
        fz0b -= tb27 * dfz;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0b *
            p[t->tyreadr[t->wheeltyre[n2]]];
        pb[t->tyreadr[t->wheeltyre[n2]]] += fz0b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LFZO];
        one3b = fzb;
        one2b = gammab;
        one1b = a2b;
        one0b = kappab;
        gripb[n2][2] += one3b;
        slipb[n2][MAGGI_SLIP_GAMMA] += one2b * side;
        slipb[n2][MAGGI_SLIP_TAN_ALPHA] += one1b * side;
        slipb[n2][MAGGI_SLIP_KAPPA] += one0b;
      } else {
        sb[i][2] = 0.0;
        sb[i][1] = 0.0;
        sb[i][0] = 0.0;
      }
    }
  }
}
