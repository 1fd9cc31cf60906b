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
  int a, a3, a3_2, b, b7, i, j, k, k3, n2;
  double A_j0, A_j0_2, A_j0_2b, A_j0_3, A_j0_3b, A_j0_4, A_j0_4b, A_j0b, A_j3, A_j3_2, A_j3_2b,
      A_j3_3, A_j3_3b, A_j3_4, A_j3_4b, A_j3b, A_j7, A_j7b, A_j8, A_j8b, Z_j3, Z_j3b, Z_j4, Z_j4b,
      a2, a2b, ay, ayb, b2, b2b, b3, b3b, b4, b4b, b5, b5b, b6, b6b, c, c2, c2b, c3, c3b, c4, c4b,
      cb, d, dampingb, db, dfz, dfzb, dv, dvb, e0, e0b, e1, e10, e10b, e11, e11b, e12, e12b, e1b,
      e20, e20b, e21, e21b, e22, e22b, e2_2, e2_2b, e3, e3b, e4, e4b, e5, e5b, e6, e6b, e7, e7b, e8,
      e8b, e9, e9b, ev0, ev0b, ev1, ev1b, ev20, ev20b, ev21, ev21b, ev22, ev22b, ev2_2, ev2_2b, ex,
      exb, ey, eyb, f0b, f1b, f2b, fx, fxb, fy, fyb, fz, fz0, fz0_2, fz0_2b, fz0b, fzb, g0, g0_2,
      g0_2b, g0_3, g0_3b, g0_4, g0_4b, g0b, g1, g1_2, g1_2b, g1_3, g1_3b, g1_4, g1_4b, g1b, g20,
      g20b, g21, g21b, g22, g22b, g23, g23b, g24, g24b, g25, g25b, g26, g26b, g27, g27b, g28, g28b,
      g2_2, g2_2b, g2_4b, g2_5, g2_5b, gamma, gammab, gx, gx2, gx2b, gxb, gy, gy2, gy2b, gyb, h, h2,
      h2b, h3, h3b, hb, ka, kab, kappa, kappab, kx, kxb, l, l2, l2b, l3, l3b, lb, lv, lvb, m, mb,
      mux, muxb, muy, muyb, n30, n30b, n31, n31b, n32, n32b, n40, n40b, n41, n41b, n42, n42b, n5,
      n5b, n6, n6b, one0, one0b, one1, one1b, one2, one2b, one3, one3b, p2, p2b, p3, p3b, p4, p4b,
      p5, p5b, p6, p6b, p_i, p_i1, p_i1b, p_i2, p_i2b, p_i3, p_i3b, p_ib, p_k34, p_k34b, p_k35,
      p_k35b, peak, peakb, r2, r2b, roll, rollb, rv_k0, rv_k0_2, rv_k0_2b, rv_k0_3, rv_k0_3b,
      rv_k0b, rv_k1, rv_k1_2, rv_k1_2b, rv_k1_3, rv_k1_3b, rv_k1b, rv_k2, rv_k2b, s2, s2b, s3, s3b,
      shift, shift2, shift2b, shiftb, side, slip_n2b, sumb, t10, t100, t100b, t101, t101b, t102,
      t102b, t103, t103b, t104, t104b, t105, t105b, t106, t106b, t107, t107b, t108, t108b, t109,
      t109b, t10b, t11, t110, t110b, t111, t111b, t112, t112b, t113, t113b, t114, t114b, t115,
      t115b, t116, t116b, t117, t117b, t118, t118b, t119, t119b, t11b, t12, t120, t120b, t121,
      t121b, t122, t122b, t123, t123b, t124, t124b, t125, t125b, t126, t126b, t127, t127b, t128,
      t128b, t129, t129b, t12b, t130, t130b, t131, t131b, t132, t132b, t133, t133b, t134, t134b,
      t135, t135b, t136, t136b, t137, t137b, t138, t138b, t139, t139b, t13b, t14, t140, t140b, t141,
      t141b, t142, t142b, t143, t143b, t144, t144b, t145, t145b, t146, t146b, t147, t147b, t148,
      t148b, t149b, t14b, t15, t15b, t16, t16b, t17, t17b, t18, t18b, t19, t19b, t2, t20, t20b, t21,
      t21b, t22, t22b, t23, t23b, t24, t24b, t25, t25b, t26, t26b, t27, t27b, t28, t28b, t29, t29b,
      t2b, t3, t30, t30b, t31, t31b, t32, t32b, t33, t33b, t34, t34b, t35, t35b, t36, t36b, t37,
      t37b, t38, t38b, t39, t39b, t3b, t4, t40, t40b, t41, t41b, t42, t42b, t43, t43b, t44, t44b,
      t45, t45b, t46, t46b, t47, t47b, t48, t48b, t49, t49b, t4b, t5, t50, t50b, t51, t51b, t52,
      t52b, t53, t53b, t54, t54b, t55, t55b, t56, t56b, t57, t57b, t58, t58b, t59, t59b, t5b, t6,
      t60, t60b, t61, t61b, t62, t62b, t63, t63b, t64, t64b, t65, t65b, t66, t66b, t67, t67b, t68,
      t68b, t69, t69b, t6b, t7, t70, t70b, t71, t71b, t72, t72b, t73, t73b, t74, t74b, t75, t75b,
      t76, t76b, t77, t77b, t78, t78b, t79, t79b, t7b, t8, t80, t80b, t81, t81b, t82, t82b, t83,
      t83b, t84, t84b, t85, t85b, t86, t86b, t87, t87b, t88, t88b, t89, t89b, t8b, t9, t90, t90b,
      t91, t91b, t92, t92b, t93, t93b, t94, t94b, t95, t95b, t96, t96b, t97, t97b, t98, t98b, t99,
      t99b, t9b, tb10, tb100, tb101, tb102, tb103, tb104, tb105, tb106, tb107, tb108, tb109, tb11,
      tb110, tb111, tb112, tb113, tb114, tb115, tb116, tb117, tb118, tb119, tb12, tb120, tb121,
      tb122, tb123, tb124, tb125, tb126, tb127, tb128, tb129, tb13, tb130, tb131, tb132, tb133,
      tb134, tb135, tb136, tb137, tb138, tb139, tb14, tb140, tb141, tb142, tb143, tb144, tb145,
      tb146, tb147, tb148, tb149, tb15, tb150, tb151, tb152, tb153, tb154, tb155, tb156, tb157,
      tb158, tb16, tb17, tb18, tb19, tb2, tb20, tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28,
      tb29, tb3, tb30, tb31, tb32, tb33, tb34, tb35, tb36, tb37, tb38, tb39, tb4, tb40, tb41, tb42,
      tb43, tb44, tb45, tb46, tb47, tb48, tb49, tb5, tb50, tb51, tb52, tb53, tb54, tb55, tb56, tb57,
      tb58, tb59, tb6, tb60, tb61, tb62, tb63, tb64, tb65, tb66, tb67, tb68, tb69, tb7, tb70, tb71,
      tb72, tb73, tb74, tb75, tb76, tb77, tb78, tb79, tb8, tb80, tb81, tb82, tb83, tb84, tb85, tb86,
      tb87, tb88, tb89, tb9, tb90, tb91, tb92, tb93, tb94, tb95, tb96, tb97, tb98, tb99, torque0b,
      u20, u20b, u21, u21b, ux, uxb, uy, uyb, v2, v2b, w, wb, wx1, wx1b, wy1, wy1b, x2, x2b, x30,
      x30b, x31, x31b, x32, x32b, x33, x33b, x34, x34b, x35, x35b, x4, x4b, x5, x5b, x6, x6b, x7,
      x7b, x8, x8b, x9, x9b, xv, xvb, y0, y0_2, y0_2b, y0_3, y0_3b, y0b, y1, y10, y10b, y11, y11b,
      y12, y12b, y13, y13b, y14, y14b, y15, y15b, y16, y16b, y17, y17b, y18, y18b, y1b, y2, y2_2,
      y2_2b, y2b, y3, y3_2, y3_2b, y3b, y4, y4_2, y4_2b, y4b, y5, y5_2, y5_2b, y5b, y6, y6b, y7,
      y7b, y8, y8b, y9, y9b, z0, z0_2, z0_2b, z0_3b, z0_4b, z0_5b, z0b, z10, z10b, z11, z11b, z1_2b,
      z1_3, z1_3b, z1b, z2, z2b, z3, z3b, z4, z4b, z5, z5b, z6, z6b, z7, z7b, z8, z8b, z9, z9b;

  (void)origin;
  (void)x;
  (void)Za;
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
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LATERAL_ACCELERATION) {
      g0 = ra[k][0] + p[0];
      g1 = ra[k][1] + p[1];
      g2_2 = ra[k][2] + p[2];
      p_i = p[t->sensoradr[i]];
      w = p_i * p_i;
      rv_k0 = rv[k][0];
      rv_k1 = rv[k][1];
      rv_k2 = rv[k][2];
      t2 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + rv_k2 * rv_k2 + w;
      c = (g0 * rv_k0 + g1 * rv_k1 + g2_2 * rv_k2) / t2;
      n30 = g0 - c * rv_k0;
      n31 = g1 - c * rv_k1;
      n32 = g2_2 - c * rv_k2;
      p_i1 = p[t->sensoradr[i] + 1];
      t3 = n30 * n30 + n31 * n31 + n32 * n32 + p_i1 * p_i1;
      t4 = sqrt(t3);
      t5 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + w;
      t6 = sqrt(t5);
      t7 = g0 * g0 + g1 * g1 + p_i1 * p_i1;
      t8 = sqrt(t7);
      tb13 = sb[i][2];
      sb[i][2] = 0.0;
      tb14 = tb13 / t8;
      g0b = tb14 * g0;
      g0b += tb14 * g0;
      g1b = tb14 * g1;
      g1b += tb14 * g1;
      t8b = -(tb14 * s[i][2]);
      t7b = t8b * (1.0 / (2.0 * t8));
      g0b += t7b * g0;
      g0b += t7b * g0;
      g1b += t7b * g1;
      g1b += t7b * g1;
      p_i1b = t7b * p_i1;
      p_i1b += t7b * p_i1;
      tb11 = sb[i][1];
      sb[i][1] = 0.0;
      tb12 = tb11 / t6;
      rv_k0b = tb12 * g1;
      g1b += tb12 * rv_k0;
      rv_k1b = -(tb12 * g0);
      g0b -= tb12 * rv_k1;
      t6b = -(tb12 * s[i][1]);
      t5b = t6b * (1.0 / (2.0 * t6));
      rv_k0b += t5b * rv_k0;
      rv_k0b += t5b * rv_k0;
      rv_k1b += t5b * rv_k1;
      rv_k1b += t5b * rv_k1;
      wb = t5b;
      tb9 = sb[i][0];
      sb[i][0] = 0.0;
      tb10 = tb9 / t4;
      n30b = tb10 * n30;
      n30b += tb10 * n30;
      n31b = tb10 * n31;
      n31b += tb10 * n31;
      n32b = tb10 * n32;
      n32b += tb10 * n32;
      t4b = -(tb10 * s[i][0]);
      t3b = t4b * (1.0 / (2.0 * t4));
      n30b += t3b * n30;
      n30b += t3b * n30;
      n31b += t3b * n31;
      n31b += t3b * n31;
      n32b += t3b * n32;
      n32b += t3b * n32;
      p_i1b += t3b * p_i1;
      p_i1b += t3b * p_i1;
      pb[t->sensoradr[i] + 1] += p_i1b;
      g2_2b = n32b;
      cb = -(n32b * rv_k2);
      rv_k2b = -(n32b * c);
      g1b += n31b;
      cb -= n31b * rv_k1;
      rv_k1b -= n31b * c;
      g0b += n30b;
      cb -= n30b * rv_k0;
      rv_k0b -= n30b * c;
      tb8 = cb / t2;
      g0b += tb8 * rv_k0;
      rv_k0b += tb8 * g0;
      g1b += tb8 * rv_k1;
      rv_k1b += tb8 * g1;
      g2_2b += tb8 * rv_k2;
      rv_k2b += tb8 * g2_2;
      t2b = -(tb8 * c);
      rv_k0b += t2b * rv_k0;
      rv_k0b += t2b * rv_k0;
      rv_k1b += t2b * rv_k1;
      rv_k1b += t2b * rv_k1;
      rv_k2b += t2b * rv_k2;
      rv_k2b += t2b * rv_k2;
      wb += t2b;
      rvb[k][2] += rv_k2b;
      rvb[k][1] += rv_k1b;
      rvb[k][0] += rv_k0b;
      p_ib = wb * p_i;
      p_ib += wb * p_i;
      pb[t->sensoradr[i]] += p_ib;
      rab[k][2] += g2_2b;
      pb[2] += g2_2b;
      rab[k][1] += g1b;
      pb[1] += g1b;
      rab[k][0] += g0b;
      pb[0] += g0b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SIDESLIP) {
      g0_2 = ra[k][0] + p[0];
      g1_2 = ra[k][1] + p[1];
      A_j0 = A[j][0];
      A_j3 = A[j][3];
      t9 = A_j0 * A_j0 + A_j3 * A_j3;
      h = sqrt(t9);
      rv_k0_2 = rv[k][0];
      rv_k1_2 = rv[k][1];
      u20 = (A_j0 * rv_k0_2 + A_j3 * rv_k1_2) / h;
      u21 = (A_j0 * rv_k1_2 - A_j3 * rv_k0_2) / h;
      p_i2 = p[t->sensoradr[i]];
      t10 = u20 * u20 + u21 * u21 + p_i2 * p_i2;
      r2 = sqrt(t10);
      if (MAGGI_RE(u20) < 0.0) {
        t11 = r2 - u20;
        p_i3 = p[t->sensoradr[i]];
        t12 = (u21 * u21 + p_i3 * p_i3) / t11;
        d = t12;
      } else {
        d = r2 + u20;
      }
      t14 = r2 * r2 * r2;
      tb21 = sb[i][2];
      sb[i][2] = 0.0;
      tb22 = tb21 / t14;
      rvb[k][0] += tb22 * g1_2;
      g1_2b = tb22 * rv[k][0];
      rvb[k][1] -= tb22 * g0_2;
      g0_2b = -(tb22 * rv[k][1]);
      t14b = -(tb22 * s[i][2]);
      tb20 = t14b * r2;
      r2b = tb20 * r2;
      r2b += tb20 * r2;
      r2b += t14b * (r2 * r2);
      tb18 = sb[i][1];
      sb[i][1] = 0.0;
      tb19 = tb18 / r2;
      u20b = tb19 * u20;
      u20b += tb19 * u20;
      u21b = tb19 * u21;
      u21b += tb19 * u21;
      r2b -= tb19 * s[i][1];
      t13b = sb[i][0] * 2.0;
      sb[i][0] = 0.0;
      u21b += t13b * (d / (d * d + u21 * u21));
      db = -(t13b * (u21 / (d * d + u21 * u21)));
      if (MAGGI_RE(u20) < 0.0) {
        t11 = r2 - u20;
        p_i3 = p[t->sensoradr[i]];
        t12 = (u21 * u21 + p_i3 * p_i3) / t11;
        t12b = db;
        db = 0.0;
        tb17 = t12b / t11;
        u21b += tb17 * u21;
        u21b += tb17 * u21;
        p_i3b = tb17 * p_i3;
        p_i3b += tb17 * p_i3;
        t11b = -(tb17 * t12);
        pb[t->sensoradr[i]] += p_i3b;
        r2b += t11b;
        u20b -= t11b;
      } else {
        r2b += db;
        u20b += db;
        db = 0.0;
      }
      t10b = r2b * (1.0 / (2.0 * r2));
      u20b += t10b * u20;
      u20b += t10b * u20;
      u21b += t10b * u21;
      u21b += t10b * u21;
      p_i2b = t10b * p_i2;
      p_i2b += t10b * p_i2;
      pb[t->sensoradr[i]] += p_i2b;
      tb16 = u21b / h;
      A_j0b = tb16 * rv_k1_2;
      rv_k1_2b = tb16 * A_j0;
      A_j3b = -(tb16 * rv_k0_2);
      rv_k0_2b = -(tb16 * A_j3);
      hb = -(tb16 * u21);
      tb15 = u20b / h;
      A_j0b += tb15 * rv_k0_2;
      rv_k0_2b += tb15 * A_j0;
      A_j3b += tb15 * rv_k1_2;
      rv_k1_2b += tb15 * A_j3;
      hb -= tb15 * u20;
      rvb[k][1] += rv_k1_2b;
      rvb[k][0] += rv_k0_2b;
      t9b = hb * (1.0 / (2.0 * h));
      A_j0b += t9b * A_j0;
      A_j0b += t9b * A_j0;
      A_j3b += t9b * A_j3;
      A_j3b += t9b * A_j3;
      Ab[j][3] += A_j3b;
      Ab[j][0] += A_j0b;
      rab[k][1] += g1_2b;
      pb[1] += g1_2b;
      rab[k][0] += g0_2b;
      pb[0] += g0_2b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_VELOCITY) {
      A_j0_2 = A[j][0];
      A_j3_2 = A[j][3];
      t15 = A_j0_2 * A_j0_2 + A_j3_2 * A_j3_2;
      h2 = sqrt(t15);
      rv_k0_3 = rv[k][0];
      rv_k1_3 = rv[k][1];
      rvb[k][2] += sb[i][2];
      sb[i][2] = 0.0;
      tb25 = sb[i][1];
      sb[i][1] = 0.0;
      tb26 = tb25 / h2;
      A_j0_2b = tb26 * rv_k1_3;
      rv_k1_3b = tb26 * A_j0_2;
      A_j3_2b = -(tb26 * rv_k0_3);
      rv_k0_3b = -(tb26 * A_j3_2);
      h2b = -(tb26 * s[i][1]);
      tb23 = sb[i][0];
      sb[i][0] = 0.0;
      tb24 = tb23 / h2;
      A_j0_2b += tb24 * rv_k0_3;
      rv_k0_3b += tb24 * A_j0_2;
      A_j3_2b += tb24 * rv_k1_3;
      rv_k1_3b += tb24 * A_j3_2;
      h2b -= tb24 * s[i][0];
      rvb[k][1] += rv_k1_3b;
      rvb[k][0] += rv_k0_3b;
      t15b = h2b * (1.0 / (2.0 * h2));
      A_j0_2b += t15b * A_j0_2;
      A_j0_2b += t15b * A_j0_2;
      A_j3_2b += t15b * A_j3_2;
      A_j3_2b += t15b * A_j3_2;
      Ab[j][3] += A_j3_2b;
      Ab[j][0] += A_j0_2b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_ACCELERATION) {
      g0_3 = ra[k][0] + p[0];
      g1_3 = ra[k][1] + p[1];
      A_j0_3 = A[j][0];
      A_j3_3 = A[j][3];
      t16 = A_j0_3 * A_j0_3 + A_j3_3 * A_j3_3;
      h3 = sqrt(t16);
      g2_4b = sb[i][2];
      sb[i][2] = 0.0;
      tb29 = sb[i][1];
      sb[i][1] = 0.0;
      tb30 = tb29 / h3;
      A_j0_3b = tb30 * g1_3;
      g1_3b = tb30 * A_j0_3;
      A_j3_3b = -(tb30 * g0_3);
      g0_3b = -(tb30 * A_j3_3);
      h3b = -(tb30 * s[i][1]);
      tb27 = sb[i][0];
      sb[i][0] = 0.0;
      tb28 = tb27 / h3;
      A_j0_3b += tb28 * g0_3;
      g0_3b += tb28 * A_j0_3;
      A_j3_3b += tb28 * g1_3;
      g1_3b += tb28 * A_j3_3;
      h3b -= tb28 * s[i][0];
      t16b = h3b * (1.0 / (2.0 * h3));
      A_j0_3b += t16b * A_j0_3;
      A_j0_3b += t16b * A_j0_3;
      A_j3_3b += t16b * A_j3_3;
      A_j3_3b += t16b * A_j3_3;
      Ab[j][3] += A_j3_3b;
      Ab[j][0] += A_j0_3b;
      rab[k][2] += g2_4b;
      pb[2] += g2_4b;
      rab[k][1] += g1_3b;
      pb[1] += g1_3b;
      rab[k][0] += g0_3b;
      pb[0] += g0_3b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_BODY_ACCELERATION) {
      g0_4 = ra[k][0] + p[0];
      g1_4 = ra[k][1] + p[1];
      g2_5 = ra[k][2] + p[2];
      tb33 = sb[i][2];
      sb[i][2] = 0.0;
      Ab[j][2] += tb33 * g0_4;
      g0_4b = tb33 * A[j][2];
      Ab[j][5] += tb33 * g1_4;
      g1_4b = tb33 * A[j][5];
      Ab[j][8] += tb33 * g2_5;
      g2_5b = tb33 * A[j][8];
      tb32 = sb[i][1];
      sb[i][1] = 0.0;
      Ab[j][1] += tb32 * g0_4;
      g0_4b += tb32 * A[j][1];
      Ab[j][4] += tb32 * g1_4;
      g1_4b += tb32 * A[j][4];
      Ab[j][7] += tb32 * g2_5;
      g2_5b += tb32 * A[j][7];
      tb31 = sb[i][0];
      sb[i][0] = 0.0;
      Ab[j][0] += tb31 * g0_4;
      g0_4b += tb31 * A[j][0];
      Ab[j][3] += tb31 * g1_4;
      g1_4b += tb31 * A[j][3];
      Ab[j][6] += tb31 * g2_5;
      g2_5b += tb31 * A[j][6];
      rab[k][2] += g2_5b;
      pb[2] += g2_5b;
      rab[k][1] += g1_4b;
      pb[1] += g1_4b;
      rab[k][0] += g0_4b;
      pb[0] += g0_4b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_COMBINATION) {
      sb[i][2] = 0.0;
      sb[i][1] = 0.0;
      sumb = sb[i][0];
      sb[i][0] = 0.0;
      for (a = t->sensorterms[i] - 1; a >= 0; --a) {
        pb[t->sensoradr[i] + a] += sumb * s[t->termsensor[n2 + a]][t->termcolumn[n2 + a]];
        sb[t->termsensor[n2 + a]][t->termcolumn[n2 + a]] += sumb * p[t->sensoradr[i] + a];
      }
      sumb = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j8 = A[j][8];
      t17 = -A[j][6];
      t18 = A_j7 * A_j7 + A_j8 * A_j8;
      t19 = sqrt(t18);
      tb36 = sb[i][2];
      sb[i][2] = 0.0;
      Ab[j][3] += tb36 * (A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      Ab[j][0] -= tb36 * (A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      tb35 = sb[i][1];
      sb[i][1] = 0.0;
      t17b = tb35 * (t19 / (t19 * t19 + t17 * t17));
      t19b = -(tb35 * (t17 / (t19 * t19 + t17 * t17)));
      t18b = t19b * (1.0 / (2.0 * t19));
      A_j7b = t18b * A_j7;
      A_j7b += t18b * A_j7;
      A_j8b = t18b * A_j8;
      A_j8b += t18b * A_j8;
      Ab[j][6] -= t17b;
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      tb34 = sb[i][0];
      sb[i][0] = 0.0;
      A_j7b += tb34 * (A_j8 / (A_j8 * A_j8 + A_j7 * A_j7));
      A_j8b -= tb34 * (A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      Ab[j][8] += A_j8b;
      Ab[j][7] += A_j7b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      A_j0_4 = A[j][0];
      A_j3_4 = A[j][3];
      c2 = A_j0_4 * A_j0_4 + A_j3_4 * A_j3_4;
      Z_j3 = Z[j][3];
      Z_j4 = Z[j][4];
      roll = s[i][0];
      t20 = sqrt(c2);
      tb40 = sb[i][2];
      sb[i][2] = 0.0;
      Zb[j][5] += tb40;
      Ab[j][6] -= tb40 * roll;
      rollb = -(tb40 * A[j][6]);
      tb38 = sb[i][1];
      sb[i][1] = 0.0;
      tb39 = tb38 / t20;
      A_j0_4b = tb39 * Z_j4;
      Z_j4b = tb39 * A_j0_4;
      A_j3_4b = -(tb39 * Z_j3);
      Z_j3b = -(tb39 * A_j3_4);
      t20b = -(tb39 * s[i][1]);
      c2b = t20b * (1.0 / (2.0 * t20));
      rollb += sb[i][0];
      sb[i][0] = 0.0;
      tb37 = rollb / c2;
      A_j0_4b += tb37 * Z_j3;
      Z_j3b += tb37 * A_j0_4;
      A_j3_4b += tb37 * Z_j4;
      Z_j4b += tb37 * A_j3_4;
      c2b -= tb37 * roll;
      Zb[j][4] += Z_j4b;
      Zb[j][3] += Z_j3b;
      /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
       * A_6 = -sin(pitch) */
      A_j0_4b += c2b * A_j0_4;
      A_j0_4b += c2b * A_j0_4;
      A_j3_4b += c2b * A_j3_4;
      A_j3_4b += c2b * A_j3_4;
      Ab[j][3] += A_j3_4b;
      Ab[j][0] += A_j0_4b;
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
      a3 = t->springpa[n2];
      b = t->springpb[n2];
      e0 = r[a3][0] - r[b][0];
      ev0 = rv[a3][0] - rv[b][0];
      e1 = r[a3][1] - r[b][1];
      ev1 = rv[a3][1] - rv[b][1];
      e2_2 = r[a3][2] - r[b][2];
      ev2_2 = rv[a3][2] - rv[b][2];
      t21 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
      l = sqrt(t21);
      n40 = e0 / l;
      n41 = e1 / l;
      n42 = e2_2 / l;
      lv = n40 * ev0 + n41 * ev1 + n42 * ev2_2;
      k3 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
      tb48 = sb[i][2];
      sb[i][2] = 0.0;
      f0b = tb48;
      f1b = tb48;
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
        if (MAGGI_RE(lv) > MAGGI_RE(p[k3 + 4])) {
          p_k34 = p[k3 + 4];
          pb[k3] += f2b * p_k34;
          p_k34b = f2b * p[k3];
          pb[k3 + 1] += f2b * (lv - p_k34);
          tb46 = f2b * p[k3 + 1];
          lvb += tb46;
          p_k34b -= tb46;
          f2b = 0.0;
          pb[k3 + 4] += p_k34b;
        } else if (MAGGI_RE(lv) > 0.0) {
          pb[k3] += f2b * lv;
          lvb += f2b * p[k3];
          f2b = 0.0;
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k3 + 5])) {
          pb[k3 + 2] += f2b * lv;
          lvb += f2b * p[k3 + 2];
          f2b = 0.0;
        } else {
          p_k35 = p[k3 + 5];
          pb[k3 + 2] += f2b * p_k35;
          p_k35b = f2b * p[k3 + 2];
          pb[k3 + 3] += f2b * (lv - p_k35);
          tb47 = f2b * p[k3 + 3];
          lvb += tb47;
          p_k35b -= tb47;
          f2b = 0.0;
          pb[k3 + 5] += p_k35b;
        }
      } else {
        dampingb += f1b;
        f1b = 0.0;
      }
      if (t->springpreload[n2]) {
        pb[t->springadr[n2]] += f0b * (l - spring0[n2]);
        tb44 = f0b * p[t->springadr[n2]];
        lb += tb44;
        spring0b[n2] -= tb44;
        pb[t->springadr[n2] + MAGGI_SPRING_L] += f0b;
        f0b = 0.0;
      } else {
        pb[t->springadr[n2]] += f0b * (l - p[t->springadr[n2] + MAGGI_SPRING_L]);
        tb45 = f0b * p[t->springadr[n2]];
        lb += tb45;
        pb[t->springadr[n2] + MAGGI_SPRING_L] -= tb45;
        f0b = 0.0;
      }
      pb[t->springadr[n2] + MAGGI_SPRING_C] += dampingb * lv;
      lvb += dampingb * p[t->springadr[n2] + MAGGI_SPRING_C];
      n40b = lvb * ev0;
      ev0b = lvb * n40;
      n41b = lvb * ev1;
      ev1b = lvb * n41;
      n42b = lvb * ev2_2;
      ev2_2b = lvb * n42;
      tb43 = n42b / l;
      e2_2b = tb43;
      lb -= tb43 * n42;
      tb42 = n41b / l;
      e1b = tb42;
      lb -= tb42 * n41;
      tb41 = n40b / l;
      e0b = tb41;
      lb -= tb41 * n40;
      t21b = lb * (1.0 / (2.0 * l));
      e0b += t21b * e0;
      e0b += t21b * e0;
      e1b += t21b * e1;
      e1b += t21b * e1;
      e2_2b += t21b * e2_2;
      e2_2b += t21b * e2_2;
      rvb[a3][2] += ev2_2b;
      rvb[b][2] -= ev2_2b;
      rb[a3][2] += e2_2b;
      rb[b][2] -= e2_2b;
      rvb[a3][1] += ev1b;
      rvb[b][1] -= ev1b;
      rb[a3][1] += e1b;
      rb[b][1] -= e1b;
      rvb[a3][0] += ev0b;
      rvb[b][0] -= ev0b;
      rb[a3][0] += e0b;
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
      tb49 = torque0b * p[t->jspringadr[n2]];
      x2b -= tb49;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_REST] += tb49;
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
      a3_2 = t->primpa[n2];
      b7 = t->primpb[n2];
      e20 = r[a3_2][0] - r[b7][0];
      ev20 = rv[a3_2][0] - rv[b7][0];
      e21 = r[a3_2][1] - r[b7][1];
      ev21 = rv[a3_2][1] - rv[b7][1];
      e22 = r[a3_2][2] - r[b7][2];
      ev22 = rv[a3_2][2] - rv[b7][2];
      t22 = e20 * e20 + e21 * e21 + e22 * e22;
      l2 = sqrt(t22);
      z1_3 = s[i][1];
      lambdab[t->primrow[n2]] += sb[i][2];
      sb[i][2] = 0.0;
      z1_3b = sb[i][1];
      sb[i][1] = 0.0;
      z0_5b = sb[i][0];
      sb[i][0] = 0.0;
      tb50 = z1_3b / l2;
      e20b = tb50 * ev20;
      ev20b = tb50 * e20;
      e21b = tb50 * ev21;
      ev21b = tb50 * e21;
      e22b = tb50 * ev22;
      ev22b = tb50 * e22;
      l2b = -(tb50 * z1_3);
      l2b += z0_5b;
      t22b = l2b * (1.0 / (2.0 * l2));
      e20b += t22b * e20;
      e20b += t22b * e20;
      e21b += t22b * e21;
      e21b += t22b * e21;
      e22b += t22b * e22;
      e22b += t22b * e22;
      rvb[a3_2][2] += ev22b;
      rvb[b7][2] -= ev22b;
      rb[a3_2][2] += e22b;
      rb[b7][2] -= e22b;
      rvb[a3_2][1] += ev21b;
      rvb[b7][1] -= ev21b;
      rb[a3_2][1] += e21b;
      rb[b7][1] -= e21b;
      rvb[a3_2][0] += ev20b;
      rvb[b7][0] -= ev20b;
      /* distance of two points and its rate */
      rb[a3_2][0] += e20b;
      rb[b7][0] -= e20b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_SLIP) {
      slipb[n2][MAGGI_SLIP_GAMMA] += sb[i][2];
      sb[i][2] = 0.0;
      tb51 = sb[i][1];
      sb[i][1] = 0.0;
      slipb[n2][MAGGI_SLIP_TAN_ALPHA] += tb51 * (1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] *
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
      tb52 = sb[i][0];
      sb[i][0] = 0.0;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb52;
      slip_n2b -= tb52;
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
        t23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
        t24 = exp(t23);
        x33 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t24 *
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
        t25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2;
        z2 = fz / t25;
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
          t26 = p2 * p2;
          z3 = gy2 * gy2 / t26;
          y6 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
        }
        t27 = 1.0 + z2 * z2;
        t28 = 2.0 * z2 / t27;
        y3_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28 * (1.0 -
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
        t29 = 1.0 + x4 * x4;
        t30 = sqrt(t29);
        t31 = 1.0 / t30;
        g20 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g21 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
        e9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REX2] * dfz;
        if (MAGGI_RE(e9) > 1.0) {
          y7 = 1.0;
        } else {
          y7 = e9;
        }
        g22 = y7;
        g23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        x5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        t32 = 1.0 + x5 * x5;
        t33 = sqrt(t32);
        t34 = 1.0 / t33;
        g24 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
        e10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_REY2] * dfz;
        if (MAGGI_RE(e10) > 1.0) {
          y8 = 1.0;
        } else {
          y8 = e10;
        }
        g26 = y8;
        g27 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RHY2] * dfz;
        p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        x6 = p3 * a2;
        t35 = 1.0 + x6 * x6;
        t36 = sqrt(t35);
        t37 = 1.0 / t36;
        dv = peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) * t37;
        t38 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa;
        t39 = atan(t38);
        t40 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t39;
        t41 = sin(t40);
        g28 = dv * t41 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        y9 = g20 * (a2 + g23);
        y10 = g20 * g23;
        t42 = atan(y9);
        t43 = (1.0 - g22) * y9 + g22 * t42;
        t44 = atan(t43);
        t45 = g21 * t44;
        t46 = cos(t45);
        t47 = atan(y10);
        t48 = (1.0 - g22) * y10 + g22 * t47;
        t49 = atan(t48);
        t50 = g21 * t49;
        t51 = cos(t50);
        gx = t46 / t51;
        y11 = g24 * (kappa + g27);
        y12 = g24 * g27;
        t52 = atan(y11);
        t53 = (1.0 - g26) * y11 + g26 * t52;
        t54 = atan(t53);
        t55 = g25 * t54;
        t56 = cos(t55);
        t57 = atan(y12);
        t58 = (1.0 - g26) * y12 + g26 * t57;
        t59 = atan(t58);
        t60 = g25 * t59;
        t61 = cos(t60);
        gy = t56 / t61;
        b3 = g20;
        c3 = g21;
        e11 = g22;
        shift = g23;
        y13 = b3 * (a2 + shift);
        y0 = b3 * shift;
        t62 = atan(y13);
        t63 = (1.0 - e11) * y13 + e11 * t62;
        t64 = atan(t63);
        z4 = c3 * t64;
        t65 = atan(y0);
        t66 = (1.0 - e11) * y0 + e11 * t65;
        t67 = atan(t66);
        z0 = c3 * t67;
        n5 = cos(z0);
        t68 = atan(y13);
        z5 = (1.0 - e11) * y13 + e11 * t68;
        t69 = sin(z4);
        t70 = 1.0 + y13 * y13;
        t71 = e11 / t70;
        t72 = 1.0 + z5 * z5;
        t73 = c3 * (1.0 - e11 + t71) / t72;
        s2 = -t69 * t73 / n5;
        t74 = atan(y0);
        z6 = (1.0 - e11) * y0 + e11 * t74;
        t75 = cos(z4);
        t76 = sin(z0);
        t77 = n5 * n5;
        t78 = t75 * t76 / t77;
        t79 = 1.0 + y0 * y0;
        t80 = e11 / t79;
        t81 = 1.0 + z6 * z6;
        t82 = c3 * (1.0 - e11 + t80) / t81;
        wx1 = s2 * (a2 + shift) + t78 * t82 * shift;
        b4 = g24;
        c4 = g25;
        e12 = g26;
        shift2 = g27;
        y14 = b4 * (kappa + shift2);
        y0_2 = b4 * shift2;
        t83 = atan(y14);
        t84 = (1.0 - e12) * y14 + e12 * t83;
        t85 = atan(t84);
        z7 = c4 * t85;
        t86 = atan(y0_2);
        t87 = (1.0 - e12) * y0_2 + e12 * t86;
        t88 = atan(t87);
        z0_2 = c4 * t88;
        n6 = cos(z0_2);
        t89 = atan(y14);
        z8 = (1.0 - e12) * y14 + e12 * t89;
        t90 = sin(z7);
        t91 = 1.0 + y14 * y14;
        t92 = e12 / t91;
        t93 = 1.0 + z8 * z8;
        t94 = c4 * (1.0 - e12 + t92) / t93;
        s3 = -t90 * t94 / n6;
        t95 = atan(y0_2);
        z9 = (1.0 - e12) * y0_2 + e12 * t95;
        t96 = cos(z7);
        t97 = sin(z0_2);
        t98 = n6 * n6;
        t99 = t96 * t97 / t98;
        t100 = 1.0 + y0_2 * y0_2;
        t101 = e12 / t100;
        t102 = 1.0 + z9 * z9;
        t103 = c4 * (1.0 - e12 + t101) / t102;
        wy1 = s3 * (kappa + shift2) + t99 * t103 * shift2;
        t104 = x31 * x30;
        t105 = x33 / t104;
        y15 = t105 * x34;
        t106 = atan(y15);
        t107 = (1.0 - x32) * y15 + x32 * t106;
        t108 = atan(t107);
        t109 = x31 * t108;
        t110 = sin(t109);
        fx = x30 * t110 + x35;
        t111 = y1 * y0_3;
        t112 = y3_2 / t111;
        y16 = t112 * y4_2;
        t113 = atan(y16);
        t114 = (1.0 - y2_2) * y16 + y2_2 * t113;
        t115 = atan(t114);
        t116 = y1 * t115;
        t117 = sin(t116);
        fy = y0_3 * t117 + y5_2;
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        x7 = p4 * (a2 - p5);
        t118 = 1.0 + x7 * x7;
        t119 = sqrt(t118);
        t120 = 1.0 / t119;
        l3 = p4 * t120;
        x8 = p3 * a2;
        t121 = 1.0 + x8 * x8;
        t122 = sqrt(t121);
        t123 = 1.0 / t122;
        v2 = p3 * t123;
        b2 = -g24 * l3 * l3 * (a2 - p5);
        t124 = y1 * y0_3;
        b5 = y3_2 / t124;
        y17 = b5 * y4_2;
        t125 = atan(y17);
        z10 = (1.0 - y2_2) * y17 + y2_2 * t125;
        t126 = atan(y17);
        t127 = (1.0 - y2_2) * y17 + y2_2 * t126;
        t128 = atan(t127);
        t129 = y1 * t128;
        t130 = cos(t129);
        t131 = 1.0 + y17 * y17;
        t132 = y2_2 / t131;
        t133 = 1.0 + z10 * z10;
        t134 = y1 * (1.0 - y2_2 + t132) / t133;
        p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        x9 = p6 * kappa;
        t135 = 1.0 + x9 * x9;
        t136 = sqrt(t135);
        t137 = 1.0 / t136;
        m = p6 * t137;
        ka = -g20 * m * m * kappa;
        t138 = x31 * x30;
        b6 = x33 / t138;
        y18 = b6 * x34;
        t139 = atan(y18);
        z11 = (1.0 - x32) * y18 + x32 * t139;
        t140 = atan(y18);
        t141 = (1.0 - x32) * y18 + x32 * t140;
        t142 = atan(t141);
        t143 = x31 * t142;
        t144 = cos(t143);
        t145 = 1.0 + y18 * y18;
        t146 = x32 / t145;
        t147 = 1.0 + z11 * z11;
        t148 = x31 * (1.0 - x32 + t146) / t147;
        ux = fx * gx / x30;
        uy = (fy * gy + g28) / y0_3;
        tb158 = sb[i][2];
        sb[i][2] = 0.0;
        t149b = tb158 * (1.0 / (2.0 * s[i][2]));
        uxb = t149b * ux;
        uxb += t149b * ux;
        uyb = t149b * uy;
        uyb += t149b * uy;
        tb157 = uyb / y0_3;
        fyb = tb157 * gy;
        gyb = tb157 * fy;
        g28b = tb157;
        y0_3b = -(tb157 * uy);
        tb156 = uxb / x30;
        fxb = tb156 * gx;
        gxb = tb156 * fx;
        x30b = -(tb156 * ux);
        tb151 = sb[i][1];
        sb[i][1] = 0.0;
        gxb += tb151 * (x30 * t144 * t148 * b6);
        tb152 = tb151 * gx;
        tb153 = tb152 * b6;
        tb154 = tb153 * t148;
        x30b += tb154 * t144;
        t144b = tb154 * x30;
        t148b = tb153 * (x30 * t144);
        b6b = tb152 * (x30 * t144 * t148);
        tb155 = tb151 * ka;
        fxb += tb155 * wx1;
        wx1b = tb155 * fx;
        kab = tb151 * (fx * wx1);
        tb149 = t148b / t147;
        x31b = tb149 * (1.0 - x32 + t146);
        tb150 = tb149 * x31;
        x32b = -tb150;
        t146b = tb150;
        t147b = -(tb149 * t148);
        z11b = t147b * z11;
        z11b += t147b * z11;
        tb148 = t146b / t145;
        x32b += tb148;
        t145b = -(tb148 * t146);
        y18b = t145b * y18;
        y18b += t145b * y18;
        t143b = -(t144b * sin(t143));
        x31b += t143b * t142;
        t142b = t143b * x31;
        t141b = t142b * (1.0 / (1.0 + t141 * t141));
        x32b -= t141b * y18;
        y18b += t141b * (1.0 - x32);
        x32b += t141b * t140;
        t140b = t141b * x32;
        y18b += t140b * (1.0 / (1.0 + y18 * y18));
        x32b -= z11b * y18;
        y18b += z11b * (1.0 - x32);
        x32b += z11b * t139;
        t139b = z11b * x32;
        /* its derivative by y */
        y18b += t139b * (1.0 / (1.0 + y18 * y18));
        b6b += y18b * x34;
        x34b = y18b * b6;
        tb147 = b6b / t138;
        x33b = tb147;
        t138b = -(tb147 * b6);
        /* its derivative by the slip */
        x31b += t138b * x30;
        x30b += t138b * x31;
        tb145 = kab * kappa;
        tb146 = tb145 * m;
        g20b = -(tb146 * m);
        mb = -(tb146 * g20);
        mb += tb145 * (-g20 * m);
        kappab = kab * (-g20 * m * m);
        p6b = mb * t137;
        t137b = mb * p6;
        tb144 = t137b / t136;
        t136b = -(tb144 * t137);
        t135b = t136b * (1.0 / (2.0 * t136));
        x9b = t135b * x9;
        x9b += t135b * x9;
        p6b += x9b * kappa;
        kappab += x9b * p6;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += p6b;
        tb135 = sb[i][0];
        sb[i][0] = 0.0;
        tb136 = tb135 * (gy * (y0_3 * t130 * t134 * b5) + fy * wy1 * b2 - g28 * v2 * v2 * a2);
        a2b = tb136 * a2;
        a2b += tb136 * a2;
        tb137 = tb135 * (1.0 + a2 * a2);
        gyb += tb137 * (y0_3 * t130 * t134 * b5);
        tb138 = tb137 * gy;
        tb139 = tb138 * b5;
        tb140 = tb139 * t134;
        y0_3b += tb140 * t130;
        t130b = tb140 * y0_3;
        t134b = tb139 * (y0_3 * t130);
        b5b = tb138 * (y0_3 * t130 * t134);
        tb141 = tb137 * b2;
        fyb += tb141 * wy1;
        wy1b = tb141 * fy;
        b2b = tb137 * (fy * wy1);
        tb142 = tb137 * a2;
        tb143 = tb142 * v2;
        g28b -= tb143 * v2;
        v2b = -(tb143 * g28);
        v2b -= tb142 * (g28 * v2);
        a2b -= tb137 * (g28 * v2 * v2);
        tb133 = t134b / t133;
        y1b = tb133 * (1.0 - y2_2 + t132);
        tb134 = tb133 * y1;
        y2_2b = -tb134;
        t132b = tb134;
        t133b = -(tb133 * t134);
        z10b = t133b * z10;
        z10b += t133b * z10;
        tb132 = t132b / t131;
        y2_2b += tb132;
        t131b = -(tb132 * t132);
        y17b = t131b * y17;
        y17b += t131b * y17;
        t129b = -(t130b * sin(t129));
        y1b += t129b * t128;
        t128b = t129b * y1;
        t127b = t128b * (1.0 / (1.0 + t127 * t127));
        y2_2b -= t127b * y17;
        y17b += t127b * (1.0 - y2_2);
        y2_2b += t127b * t126;
        t126b = t127b * y2_2;
        y17b += t126b * (1.0 / (1.0 + y17 * y17));
        y2_2b -= z10b * y17;
        y17b += z10b * (1.0 - y2_2);
        y2_2b += z10b * t125;
        t125b = z10b * y2_2;
        /* its derivative by y */
        y17b += t125b * (1.0 / (1.0 + y17 * y17));
        b5b += y17b * y4_2;
        y4_2b = y17b * b5;
        tb131 = b5b / t124;
        y3_2b = tb131;
        t124b = -(tb131 * b5);
        /* its derivative by the slip */
        y1b += t124b * y0_3;
        y0_3b += t124b * y1;
        tb128 = b2b * (a2 - p5);
        tb129 = tb128 * l3;
        g24b = -(tb129 * l3);
        l3b = -(tb129 * g24);
        l3b += tb128 * (-g24 * l3);
        tb130 = b2b * (-g24 * l3 * l3);
        a2b += tb130;
        p5b = -tb130;
        p3b = v2b * t123;
        t123b = v2b * p3;
        tb127 = t123b / t122;
        t122b = -(tb127 * t123);
        t121b = t122b * (1.0 / (2.0 * t122));
        x8b = t121b * x8;
        x8b += t121b * x8;
        p3b += x8b * a2;
        a2b += x8b * p3;
        p4b = l3b * t120;
        t120b = l3b * p4;
        tb126 = t120b / t119;
        t119b = -(tb126 * t120);
        t118b = t119b * (1.0 / (2.0 * t119));
        x7b = t118b * x7;
        x7b += t118b * x7;
        /* b and the shift of Fy change with a by their cos(atan()) */
        p4b += x7b * (a2 - p5);
        tb125 = x7b * p4;
        a2b += tb125;
        p5b -= tb125;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] += p5b;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += p4b;
        y0_3b += fyb * t117;
        t117b = fyb * y0_3;
        y5_2b = fyb;
        t116b = t117b * cos(t116);
        y1b += t116b * t115;
        t115b = t116b * y1;
        t114b = t115b * (1.0 / (1.0 + t114 * t114));
        y2_2b -= t114b * y16;
        y16b = t114b * (1.0 - y2_2);
        y2_2b += t114b * t113;
        t113b = t114b * y2_2;
        y16b += t113b * (1.0 / (1.0 + y16 * y16));
        t112b = y16b * y4_2;
        y4_2b += y16b * t112;
        tb124 = t112b / t111;
        y3_2b += tb124;
        t111b = -(tb124 * t112);
        y1b += t111b * y0_3;
        y0_3b += t111b * y1;
        x30b += fxb * t110;
        t110b = fxb * x30;
        x35b = fxb;
        t109b = t110b * cos(t109);
        x31b += t109b * t108;
        t108b = t109b * x31;
        t107b = t108b * (1.0 / (1.0 + t107 * t107));
        x32b -= t107b * y15;
        y15b = t107b * (1.0 - x32);
        x32b += t107b * t106;
        t106b = t107b * x32;
        y15b += t106b * (1.0 / (1.0 + y15 * y15));
        t105b = y15b * x34;
        x34b += y15b * t105;
        tb123 = t105b / t104;
        x33b += tb123;
        t104b = -(tb123 * t105);
        x31b += t104b * x30;
        x30b += t104b * x31;
        s3b = wy1b * (kappa + shift2);
        tb121 = wy1b * s3;
        kappab += tb121;
        shift2b = tb121;
        tb122 = wy1b * shift2;
        t99b = tb122 * t103;
        t103b = tb122 * t99;
        shift2b += wy1b * (t99 * t103);
        tb119 = t103b / t102;
        c4b = tb119 * (1.0 - e12 + t101);
        tb120 = tb119 * c4;
        e12b = -tb120;
        t101b = tb120;
        t102b = -(tb119 * t103);
        z9b = t102b * z9;
        z9b += t102b * z9;
        tb118 = t101b / t100;
        e12b += tb118;
        t100b = -(tb118 * t101);
        y0_2b = t100b * y0_2;
        y0_2b += t100b * y0_2;
        tb117 = t99b / t98;
        t96b = tb117 * t97;
        t97b = tb117 * t96;
        t98b = -(tb117 * t99);
        n6b = t98b * n6;
        n6b += t98b * n6;
        z0_2b = t97b * cos(z0_2);
        z7b = -(t96b * sin(z7));
        e12b -= z9b * y0_2;
        y0_2b += z9b * (1.0 - e12);
        e12b += z9b * t95;
        t95b = z9b * e12;
        /* its derivative by y */
        y0_2b += t95b * (1.0 / (1.0 + y0_2 * y0_2));
        tb116 = s3b / n6;
        t90b = -(tb116 * t94);
        t94b = -(tb116 * t90);
        n6b -= tb116 * s3;
        tb114 = t94b / t93;
        c4b += tb114 * (1.0 - e12 + t92);
        tb115 = tb114 * c4;
        e12b -= tb115;
        t92b = tb115;
        t93b = -(tb114 * t94);
        z8b = t93b * z8;
        z8b += t93b * z8;
        tb113 = t92b / t91;
        e12b += tb113;
        t91b = -(tb113 * t92);
        y14b = t91b * y14;
        y14b += t91b * y14;
        z7b += t90b * cos(z7);
        e12b -= z8b * y14;
        y14b += z8b * (1.0 - e12);
        e12b += z8b * t89;
        t89b = z8b * e12;
        /* its derivative by y */
        y14b += t89b * (1.0 / (1.0 + y14 * y14));
        z0_2b -= n6b * sin(z0_2);
        c4b += z0_2b * t88;
        t88b = z0_2b * c4;
        t87b = t88b * (1.0 / (1.0 + t87 * t87));
        e12b -= t87b * y0_2;
        y0_2b += t87b * (1.0 - e12);
        e12b += t87b * t86;
        t86b = t87b * e12;
        y0_2b += t86b * (1.0 / (1.0 + y0_2 * y0_2));
        c4b += z7b * t85;
        t85b = z7b * c4;
        t84b = t85b * (1.0 / (1.0 + t84 * t84));
        e12b -= t84b * y14;
        y14b += t84b * (1.0 - e12);
        e12b += t84b * t83;
        t83b = t84b * e12;
        y14b += t83b * (1.0 / (1.0 + y14 * y14));
        b4b = y0_2b * shift2;
        shift2b += y0_2b * b4;
        /* its derivatives by x and by b */
        b4b += y14b * (kappa + shift2);
        tb112 = y14b * b4;
        kappab += tb112;
        shift2b += tb112;
        g27b = shift2b;
        g26b = e12b;
        g25b = c4b;
        g24b += b4b;
        s2b = wx1b * (a2 + shift);
        tb110 = wx1b * s2;
        a2b += tb110;
        shiftb = tb110;
        tb111 = wx1b * shift;
        t78b = tb111 * t82;
        t82b = tb111 * t78;
        shiftb += wx1b * (t78 * t82);
        tb108 = t82b / t81;
        c3b = tb108 * (1.0 - e11 + t80);
        tb109 = tb108 * c3;
        e11b = -tb109;
        t80b = tb109;
        t81b = -(tb108 * t82);
        z6b = t81b * z6;
        z6b += t81b * z6;
        tb107 = t80b / t79;
        e11b += tb107;
        t79b = -(tb107 * t80);
        y0b = t79b * y0;
        y0b += t79b * y0;
        tb106 = t78b / t77;
        t75b = tb106 * t76;
        t76b = tb106 * t75;
        t77b = -(tb106 * t78);
        n5b = t77b * n5;
        n5b += t77b * n5;
        z0b = t76b * cos(z0);
        z4b = -(t75b * sin(z4));
        e11b -= z6b * y0;
        y0b += z6b * (1.0 - e11);
        e11b += z6b * t74;
        t74b = z6b * e11;
        /* its derivative by y */
        y0b += t74b * (1.0 / (1.0 + y0 * y0));
        tb105 = s2b / n5;
        t69b = -(tb105 * t73);
        t73b = -(tb105 * t69);
        n5b -= tb105 * s2;
        tb103 = t73b / t72;
        c3b += tb103 * (1.0 - e11 + t71);
        tb104 = tb103 * c3;
        e11b -= tb104;
        t71b = tb104;
        t72b = -(tb103 * t73);
        z5b = t72b * z5;
        z5b += t72b * z5;
        tb102 = t71b / t70;
        e11b += tb102;
        t70b = -(tb102 * t71);
        y13b = t70b * y13;
        y13b += t70b * y13;
        z4b += t69b * cos(z4);
        e11b -= z5b * y13;
        y13b += z5b * (1.0 - e11);
        e11b += z5b * t68;
        t68b = z5b * e11;
        /* its derivative by y */
        y13b += t68b * (1.0 / (1.0 + y13 * y13));
        z0b -= n5b * sin(z0);
        c3b += z0b * t67;
        t67b = z0b * c3;
        t66b = t67b * (1.0 / (1.0 + t66 * t66));
        e11b -= t66b * y0;
        y0b += t66b * (1.0 - e11);
        e11b += t66b * t65;
        t65b = t66b * e11;
        y0b += t65b * (1.0 / (1.0 + y0 * y0));
        c3b += z4b * t64;
        t64b = z4b * c3;
        t63b = t64b * (1.0 / (1.0 + t63 * t63));
        e11b -= t63b * y13;
        y13b += t63b * (1.0 - e11);
        e11b += t63b * t62;
        t62b = t63b * e11;
        y13b += t62b * (1.0 / (1.0 + y13 * y13));
        b3b = y0b * shift;
        shiftb += y0b * b3;
        /* its derivatives by x and by b */
        b3b += y13b * (a2 + shift);
        tb101 = y13b * b3;
        a2b += tb101;
        shiftb += tb101;
        g23b = shiftb;
        g22b = e11b;
        g21b = c3b;
        g20b += b3b;
        tb100 = gyb / t61;
        t56b = tb100;
        t61b = -(tb100 * gy);
        t60b = -(t61b * sin(t60));
        g25b += t60b * t59;
        t59b = t60b * g25;
        t58b = t59b * (1.0 / (1.0 + t58 * t58));
        g26b -= t58b * y12;
        y12b = t58b * (1.0 - g26);
        g26b += t58b * t57;
        t57b = t58b * g26;
        y12b += t57b * (1.0 / (1.0 + y12 * y12));
        t55b = -(t56b * sin(t55));
        g25b += t55b * t54;
        t54b = t55b * g25;
        t53b = t54b * (1.0 / (1.0 + t53 * t53));
        g26b -= t53b * y11;
        y11b = t53b * (1.0 - g26);
        g26b += t53b * t52;
        t52b = t53b * g26;
        y11b += t52b * (1.0 / (1.0 + y11 * y11));
        g24b += y12b * g27;
        g27b += y12b * g24;
        g24b += y11b * (kappa + g27);
        tb99 = y11b * g24;
        kappab += tb99;
        g27b += tb99;
        tb98 = gxb / t51;
        t46b = tb98;
        t51b = -(tb98 * gx);
        t50b = -(t51b * sin(t50));
        g21b += t50b * t49;
        t49b = t50b * g21;
        t48b = t49b * (1.0 / (1.0 + t48 * t48));
        g22b -= t48b * y10;
        y10b = t48b * (1.0 - g22);
        g22b += t48b * t47;
        t47b = t48b * g22;
        y10b += t47b * (1.0 / (1.0 + y10 * y10));
        t45b = -(t46b * sin(t45));
        g21b += t45b * t44;
        t44b = t45b * g21;
        t43b = t44b * (1.0 / (1.0 + t43 * t43));
        g22b -= t43b * y9;
        y9b = t43b * (1.0 - g22);
        g22b += t43b * t42;
        t42b = t43b * g22;
        y9b += t42b * (1.0 / (1.0 + y9 * y9));
        g20b += y10b * g23;
        g23b += y10b * g20;
        g20b += y9b * (a2 + g23);
        tb97 = y9b * g20;
        a2b += tb97;
        g23b += tb97;
        tb96 = g28b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        dvb = tb96 * t41;
        t41b = tb96 * dv;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g28b * (dv * t41);
        t40b = t41b * cos(t40);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t40b * t39;
        t39b = t40b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
        t38b = t39b * (1.0 / (1.0 + t38 * t38));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t38b * kappa;
        kappab += t38b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
        tb94 = dvb * t37;
        peakb = tb94 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma);
        tb95 = tb94 * peak;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb95;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb95 * dfz;
        dfzb = tb95 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb95 * gamma;
        gammab = tb95 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
        t37b = dvb * (peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma));
        tb93 = t37b / t36;
        t36b = -(tb93 * t37);
        t35b = t36b * (1.0 / (2.0 * t36));
        x6b = t35b * x6;
        x6b += t35b * x6;
        p3b += x6b * a2;
        a2b += x6b * p3;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] += p3b;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] += g27b;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] += g27b * dfz;
        dfzb += g27b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2];
        y8b = g26b;
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
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += g25b;
        tb92 = g24b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb92 * t34;
        t34b = tb92 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += g24b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RBY1] * t34);
        tb91 = t34b / t33;
        t33b = -(tb91 * t34);
        t32b = t33b * (1.0 / (2.0 * t33));
        x5b = t32b * x5;
        x5b += t32b * x5;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x5b * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        tb90 = x5b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        a2b += tb90;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb90;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1] += g23b;
        y7b = g22b;
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
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += g21b;
        tb89 = g20b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb89 * t31;
        t31b = tb89 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += g20b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RBX1] * t31);
        tb88 = t31b / t30;
        t30b = -(tb88 * t31);
        t29b = t30b * (1.0 / (2.0 * t30));
        x4b = t29b * x4;
        x4b += t29b * x4;
        /* what combined slip makes of the forces:  Fx = Gxa Fx0, Fy = Gyk Fy0 + SVyk.  g: b, c, e, shift of Gxa,
         * then of Gyk, SVyk */
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x4b * kappa;
        kappab += x4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        y0_3b += peakb;
        tb84 = y5_2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        fzb = tb84 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy2);
        tb85 = tb84 * fz;
        tb86 = tb85 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb86;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb86 * dfz;
        dfzb += tb86 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb85 * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz);
        tb87 = tb85 * gy2;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb87;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb87 * dfz;
        dfzb += tb87 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
        gy2b = tb85 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += y5_2b * (fz *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVY4] * dfz) * gy2));
        ayb = y4_2b;
        tb80 = y3_2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
        tb81 = tb80 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6);
        tb82 = tb81 * t28;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb82 * fz0_2;
        fz0_2b = tb82 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
        t28b = tb81 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2);
        tb83 = tb80 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb83 * y6;
        y6b = -(tb83 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += y3_2b * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKY1] * fz0_2 * t28 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKY3] * y6));
        tb79 = t28b / t27;
        z2b = tb79 * 2.0;
        t27b = -(tb79 * t28);
        z2b += t27b * z2;
        z2b += t27b * z2;
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
          t26 = p2 * p2;
          z3 = gy2 * gy2 / t26;
          tb77 = y6b * (15.0 + z3 * (-10.0 + 3.0 * z3));
          p2b = tb77 * z3 * 0.125;
          z3b = tb77 * (0.125 * p2);
          tb78 = y6b * (0.125 * p2 * z3);
          z3b += tb78 * (-10.0 + 3.0 * z3);
          z3b += tb78 * z3 * 3.0;
          y6b = 0.0;
          tb76 = z3b / t26;
          gy2b += tb76 * gy2;
          gy2b += tb76 * gy2;
          t26b = -(tb76 * z3);
          p2b += t26b * p2;
          p2b += t26b * p2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p2b;
        }
        eyb = y2_2b;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] += y1b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_LCY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY] += y1b * p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PCY1];
        muyb = y0_3b * fz;
        fzb += y0_3b * muy;
        tb75 = z2b / t25;
        fzb += tb75;
        t25b = -(tb75 * z2);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t25b * fz0_2;
        fz0_2b += t25b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2];
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
          tb73 = e7b * e6;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb73;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb73 * gy2;
          gy2b -= tb73 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
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
          tb74 = e8b * e6;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb74;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb74 * gy2;
          gy2b += tb74 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
        }
        tb72 = e6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb72;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb72 * dfz;
        dfzb += tb72 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] += e6b * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz);
        tb68 = muyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
        tb69 = tb68 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2 * gy2);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb69;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb69 * dfz;
        dfzb += tb69 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
        tb70 = tb68 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz);
        tb71 = tb70 * gy2;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb71 * gy2;
        gy2b -= tb71 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
        gy2b -= tb70 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += muyb *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy2
            * gy2));
        a2b += ayb;
        tb67 = ayb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb67;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb67 * dfz;
        dfzb += tb67 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2];
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
        tb64 = x35b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb65 = tb64 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
        fzb += tb65 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz);
        tb66 = tb65 * fz;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb66;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb66 * dfz;
        dfzb += tb66 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb64 * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += x35b * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]);
        kxb = x34b;
        tb61 = x33b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        tb62 = tb61 * t24;
        fzb += tb62 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz);
        tb63 = tb62 * fz;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb63;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb63 * dfz;
        dfzb += tb63 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
        t24b = tb61 * (fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz));
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += x33b * (fz *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz) * t24);
        t23b = t24b * t24;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t23b * dfz;
        dfzb += t23b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3];
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
        tb59 = e3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb59;
        tb60 = tb59 * dfz;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb60;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb60 * dfz;
        dfzb += tb60 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
        dfzb += tb59 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] += e3b * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PEX1] + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz) * dfz);
        tb55 = muxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
        tb56 = tb55 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2 * gx2);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb56;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb56 * dfz;
        dfzb += tb56 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
        tb57 = tb55 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz);
        tb58 = tb57 * gx2;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb58 * gx2;
        gx2b = -(tb58 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
        gx2b -= tb57 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2);
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += muxb *
            ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx2
            * gx2));
        gammab += gx2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] += gx2b * gamma;
        kappab += kxb;
        tb54 = kxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb54;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb54 * dfz;
        dfzb += tb54 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz);
        tb53 = dfzb / fz0;
        fzb += tb53;
        fz0b = -tb53;
        fz0b -= tb53 * dfz;
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
