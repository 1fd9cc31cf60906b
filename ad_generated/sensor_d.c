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
  int a, a3, a3_2, b, b7, i, j, k, k3, n2;
  double A_j0, A_j0_2, A_j0_2d, A_j0_3, A_j0_3d, A_j0_4, A_j0_4d, A_j0d, A_j3, A_j3_2, A_j3_2d,
      A_j3_3, A_j3_3d, A_j3_4, A_j3_4d, A_j3d, A_j7, A_j7d, A_j8, A_j8d, Z_j3, Z_j3d, Z_j4, Z_j4d,
      a2, a2d, ay, ayd, b2, b2d, b3, b3d, b4, b4d, b5, b5d, b6, b6d, c, c10, c11, c12, c13, c14,
      c15, c16, c17, c18, c19, c2, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c2d, c2inv, c3,
      c30, c31, c32, c33, c34, c35, c36, c37, c38, c39, c3d, c4, c40, c41, c42, c43, c44, c45, c46,
      c47, c48, c49, c4d, c5, c50, c51, c52, c53, c54, c55, c56, c57, c58, c59, c6, c60, c61, c62,
      c63, c64, c65, c66, c67, c68, c69, c7, c70, c71, c72, c73, c74, c75, c76, c77, c78, c79, c8,
      c9, cd, d, dampingd, dd, dfz, dfzd, dv, dvd, e0, e0d, e1, e10, e10d, e11, e11d, e12, e12d,
      e1d, e20, e20d, e21, e21d, e22, e22d, e2_2, e2_2d, e3, e3d, e4, e4d, e5, e5d, e6, e6d, e7,
      e7d, e8, e8d, e9, e9d, ev0, ev0d, ev1, ev1d, ev20, ev20d, ev21, ev21d, ev22, ev22d, ev2_2,
      ev2_2d, ex, exd, ey, eyd, f0d, f1d, f2d, fx, fxd, fy, fyd, fz, fz0, fz0_2, fz0_2d, fz0d,
      fz0inv, fzd, g0, g0_2, g0_2d, g0_3, g0_3d, g0_4, g0_4d, g0d, g1, g1_2, g1_2d, g1_3, g1_3d,
      g1_4, g1_4d, g1d, g20, g20d, g21, g21d, g22, g22d, g23, g23d, g24, g24d, g25, g25d, g26, g26d,
      g27, g27d, g28, g28d, g2_2, g2_2d, g2_4d, g2_5, g2_5d, gamma, gammad, gx, gx2, gx2d, gxd, gy,
      gy2, gy2d, gyd, h, h2, h2d, h2inv, h3, h3d, h3inv, hd, hinv, ka, kad, kappa, kappad, kx, kxd,
      l, l2, l2d, l2inv, l3, l3d, ld, linv, lv, lvd, m, md, mux, muxd, muy, muyd, n30, n30d, n31,
      n31d, n32, n32d, n40, n40d, n41, n41d, n42, n42d, n5, n5d, n5inv, n6, n6d, n6inv, one0, one0d,
      one1, one1d, one2, one2d, one3, one3d, p2, p2d, p3, p3d, p4, p4d, p5, p5d, p6, p6d, p_i, p_i1,
      p_i1d, p_i2, p_i2d, p_i3, p_i3d, p_id, p_k34, p_k34d, p_k35, p_k35d, peak, peakd, r2, r2d,
      r2inv, roll, rolld, rv_k0, rv_k0_2, rv_k0_2d, rv_k0_3, rv_k0_3d, rv_k0d, rv_k1, rv_k1_2,
      rv_k1_2d, rv_k1_3, rv_k1_3d, rv_k1d, rv_k2, rv_k2d, s2, s2d, s3, s3d, shift, shift2, shift2d,
      shiftd, side, slip_n2d, sumd, t10, t100, t100d, t100inv, t101, t101d, t102, t102d, t102inv,
      t103, t103d, t104, t104d, t104inv, t105, t105d, t106, t106d, t107, t107d, t108, t108d, t109,
      t109d, t10d, t11, t110, t110d, t111, t111d, t111inv, t112, t112d, t113, t113d, t114, t114d,
      t115, t115d, t116, t116d, t117, t117d, t118, t118d, t119, t119d, t119inv, t11d, t11inv, t12,
      t120, t120d, t121, t121d, t122, t122d, t122inv, t123, t123d, t124, t124d, t124inv, t125,
      t125d, t126, t126d, t127, t127d, t128, t128d, t129, t129d, t12d, t130, t130d, t131, t131d,
      t131inv, t132, t132d, t133, t133d, t133inv, t134, t134d, t135, t135d, t136, t136d, t136inv,
      t137, t137d, t138, t138d, t138inv, t139, t139d, t13d, t14, t140, t140d, t141, t141d, t142,
      t142d, t143, t143d, t144, t144d, t145, t145d, t145inv, t146, t146d, t147, t147d, t147inv,
      t148, t148d, t149d, t14d, t14inv, t15, t15d, t16, t16d, t17, t17d, t18, t18d, t19, t19d, t2,
      t20, t20d, t20inv, t21, t21d, t22, t22d, t23, t23d, t24, t24d, t25, t25d, t25inv, t26, t26d,
      t26inv, t27, t27d, t27inv, t28, t28d, t29, t29d, t2d, t2inv, t3, t30, t30d, t30inv, t31, t31d,
      t32, t32d, t33, t33d, t33inv, t34, t34d, t35, t35d, t36, t36d, t36inv, t37, t37d, t38, t38d,
      t39, t39d, t3d, t4, t40, t40d, t41, t41d, t42, t42d, t43, t43d, t44, t44d, t45, t45d, t46,
      t46d, t47, t47d, t48, t48d, t49, t49d, t4d, t4inv, t5, t50, t50d, t51, t51d, t51inv, t52,
      t52d, t53, t53d, t54, t54d, t55, t55d, t56, t56d, t57, t57d, t58, t58d, t59, t59d, t5d, t6,
      t60, t60d, t61, t61d, t61inv, t62, t62d, t63, t63d, t64, t64d, t65, t65d, t66, t66d, t67,
      t67d, t68, t68d, t69, t69d, t6d, t6inv, t7, t70, t70d, t70inv, t71, t71d, t72, t72d, t72inv,
      t73, t73d, t74, t74d, t75, t75d, t76, t76d, t77, t77d, t77inv, t78, t78d, t79, t79d, t79inv,
      t7d, t8, t80, t80d, t81, t81d, t81inv, t82, t82d, t83, t83d, t84, t84d, t85, t85d, t86, t86d,
      t87, t87d, t88, t88d, t89, t89d, t8d, t8inv, t9, t90, t90d, t91, t91d, t91inv, t92, t92d, t93,
      t93d, t93inv, t94, t94d, t95, t95d, t96, t96d, t97, t97d, t98, t98d, t98inv, t99, t99d, t9d,
      torque0d, u20, u20d, u21, u21d, ux, uxd, uy, uyd, v2, v2d, w, wd, wx1, wx1d, wy1, wy1d, x2,
      x2d, x30, x30d, x30inv, x31, x31d, x32, x32d, x33, x33d, x34, x34d, x35, x35d, x4, x4d, x5,
      x5d, x6, x6d, x7, x7d, x8, x8d, x9, x9d, xv, xvd, y0, y0_2, y0_2d, y0_3, y0_3d, y0_3inv, y0d,
      y1, y10, y10d, y11, y11d, y12, y12d, y13, y13d, y14, y14d, y15, y15d, y16, y16d, y17, y17d,
      y18, y18d, y1d, y2, y2_2, y2_2d, y2d, y3, y3_2, y3_2d, y3d, y4, y4_2, y4_2d, y4d, y5, y5_2,
      y5_2d, y5d, y6, y6d, y7, y7d, y8, y8d, y9, y9d, z0, z0_2, z0_2d, z0_3d, z0_4d, z0_5d, z0d,
      z10, z10d, z11, z11d, z1_2d, z1_3, z1_3d, z1d, z2, z2d, z3, z3d, z4, z4d, z5, z5d, z6, z6d,
      z7, z7d, z8, z8d, z9, z9d;

  (void)origin;
  (void)x;
  (void)Za;
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
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LATERAL_ACCELERATION) {
      g0 = ra[k][0] + p[0];
      g0d = rad[k][0] + pd[0];
      g1 = ra[k][1] + p[1];
      g1d = rad[k][1] + pd[1];
      g2_2 = ra[k][2] + p[2];
      g2_2d = rad[k][2] + pd[2];
      p_i = p[t->sensoradr[i]];
      p_id = pd[t->sensoradr[i]];
      w = p_i * p_i;
      wd = p_id * p_i + p_i * p_id;
      rv_k0 = rv[k][0];
      rv_k0d = rvd[k][0];
      rv_k1 = rv[k][1];
      rv_k1d = rvd[k][1];
      rv_k2 = rv[k][2];
      rv_k2d = rvd[k][2];
      t2 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + rv_k2 * rv_k2 + w;
      t2d = rv_k0d * rv_k0 + rv_k0 * rv_k0d + (rv_k1d * rv_k1 + rv_k1 * rv_k1d) + (rv_k2d * rv_k2 +
          rv_k2 * rv_k2d) + wd;
      c = (g0 * rv_k0 + g1 * rv_k1 + g2_2 * rv_k2) / t2;
      t2inv = 1.0 / t2;
      cd = (g0d * rv_k0 + g0 * rv_k0d + (g1d * rv_k1 + g1 * rv_k1d) + (g2_2d * rv_k2 + g2_2 *
          rv_k2d) - c * t2d) * t2inv;
      n30 = g0 - c * rv_k0;
      n30d = g0d - (cd * rv_k0 + c * rv_k0d);
      n31 = g1 - c * rv_k1;
      n31d = g1d - (cd * rv_k1 + c * rv_k1d);
      n32 = g2_2 - c * rv_k2;
      n32d = g2_2d - (cd * rv_k2 + c * rv_k2d);
      p_i1 = p[t->sensoradr[i] + 1];
      p_i1d = pd[t->sensoradr[i] + 1];
      t3 = n30 * n30 + n31 * n31 + n32 * n32 + p_i1 * p_i1;
      t3d = n30d * n30 + n30 * n30d + (n31d * n31 + n31 * n31d) + (n32d * n32 + n32 * n32d) + (p_i1d
          * p_i1 + p_i1 * p_i1d);
      t4 = sqrt(t3);
      c5 = 1.0 / (2.0 * t4);
      t4d = c5 * t3d;
      t4inv = 1.0 / t4;
      sd[i][0] = (n30d * n30 + n30 * n30d + (n31d * n31 + n31 * n31d) + (n32d * n32 + n32 * n32d) -
          s[i][0] * t4d) * t4inv;
      t5 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + w;
      t5d = rv_k0d * rv_k0 + rv_k0 * rv_k0d + (rv_k1d * rv_k1 + rv_k1 * rv_k1d) + wd;
      t6 = sqrt(t5);
      c6 = 1.0 / (2.0 * t6);
      t6d = c6 * t5d;
      t6inv = 1.0 / t6;
      sd[i][1] = (rv_k0d * g1 + rv_k0 * g1d - (rv_k1d * g0 + rv_k1 * g0d) - s[i][1] * t6d) * t6inv;
      t7 = g0 * g0 + g1 * g1 + p_i1 * p_i1;
      t7d = g0d * g0 + g0 * g0d + (g1d * g1 + g1 * g1d) + (p_i1d * p_i1 + p_i1 * p_i1d);
      t8 = sqrt(t7);
      c7 = 1.0 / (2.0 * t8);
      t8d = c7 * t7d;
      t8inv = 1.0 / t8;
      sd[i][2] = (g0d * g0 + g0 * g0d + (g1d * g1 + g1 * g1d) - s[i][2] * t8d) * t8inv;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SIDESLIP) {
      g0_2 = ra[k][0] + p[0];
      g0_2d = rad[k][0] + pd[0];
      g1_2 = ra[k][1] + p[1];
      g1_2d = rad[k][1] + pd[1];
      A_j0 = A[j][0];
      A_j0d = Ad[j][0];
      A_j3 = A[j][3];
      A_j3d = Ad[j][3];
      t9 = A_j0 * A_j0 + A_j3 * A_j3;
      t9d = A_j0d * A_j0 + A_j0 * A_j0d + (A_j3d * A_j3 + A_j3 * A_j3d);
      h = sqrt(t9);
      c8 = 1.0 / (2.0 * h);
      hd = c8 * t9d;
      rv_k0_2 = rv[k][0];
      rv_k0_2d = rvd[k][0];
      rv_k1_2 = rv[k][1];
      rv_k1_2d = rvd[k][1];
      u20 = (A_j0 * rv_k0_2 + A_j3 * rv_k1_2) / h;
      hinv = 1.0 / h;
      u20d = (A_j0d * rv_k0_2 + A_j0 * rv_k0_2d + (A_j3d * rv_k1_2 + A_j3 * rv_k1_2d) - u20 * hd) *
          hinv;
      u21 = (A_j0 * rv_k1_2 - A_j3 * rv_k0_2) / h;
      u21d = (A_j0d * rv_k1_2 + A_j0 * rv_k1_2d - (A_j3d * rv_k0_2 + A_j3 * rv_k0_2d) - u21 * hd) *
          hinv;
      p_i2 = p[t->sensoradr[i]];
      p_i2d = pd[t->sensoradr[i]];
      t10 = u20 * u20 + u21 * u21 + p_i2 * p_i2;
      t10d = u20d * u20 + u20 * u20d + (u21d * u21 + u21 * u21d) + (p_i2d * p_i2 + p_i2 * p_i2d);
      r2 = sqrt(t10);
      c9 = 1.0 / (2.0 * r2);
      r2d = c9 * t10d;
      if (MAGGI_RE(u20) < 0.0) {
        t11 = r2 - u20;
        t11d = r2d - u20d;
        p_i3 = p[t->sensoradr[i]];
        p_i3d = pd[t->sensoradr[i]];
        t12 = (u21 * u21 + p_i3 * p_i3) / t11;
        t11inv = 1.0 / t11;
        t12d = (u21d * u21 + u21 * u21d + (p_i3d * p_i3 + p_i3 * p_i3d) - t12 * t11d) * t11inv;
        d = t12;
        dd = t12d;
      } else {
        d = r2 + u20;
        dd = r2d + u20d;
      }
      c10 = d / (d * d + u21 * u21);
      c11 = -(u21 / (d * d + u21 * u21));
      t13d = c10 * u21d + c11 * dd;
      sd[i][0] = 2.0 * t13d;
      r2inv = 1.0 / r2;
      sd[i][1] = (u20d * u20 + u20 * u20d + (u21d * u21 + u21 * u21d) - s[i][1] * r2d) * r2inv;
      t14 = r2 * r2 * r2;
      t14d = (r2d * r2 + r2 * r2d) * r2 + r2 * r2 * r2d;
      t14inv = 1.0 / t14;
      sd[i][2] = (rvd[k][0] * g1_2 + rv[k][0] * g1_2d - (rvd[k][1] * g0_2 + rv[k][1] * g0_2d) -
          s[i][2] * t14d) * t14inv;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_VELOCITY) {
      A_j0_2 = A[j][0];
      A_j0_2d = Ad[j][0];
      A_j3_2 = A[j][3];
      A_j3_2d = Ad[j][3];
      t15 = A_j0_2 * A_j0_2 + A_j3_2 * A_j3_2;
      t15d = A_j0_2d * A_j0_2 + A_j0_2 * A_j0_2d + (A_j3_2d * A_j3_2 + A_j3_2 * A_j3_2d);
      h2 = sqrt(t15);
      c12 = 1.0 / (2.0 * h2);
      h2d = c12 * t15d;
      rv_k0_3 = rv[k][0];
      rv_k0_3d = rvd[k][0];
      rv_k1_3 = rv[k][1];
      rv_k1_3d = rvd[k][1];
      h2inv = 1.0 / h2;
      sd[i][0] = (A_j0_2d * rv_k0_3 + A_j0_2 * rv_k0_3d + (A_j3_2d * rv_k1_3 + A_j3_2 * rv_k1_3d) -
          s[i][0] * h2d) * h2inv;
      sd[i][1] = (A_j0_2d * rv_k1_3 + A_j0_2 * rv_k1_3d - (A_j3_2d * rv_k0_3 + A_j3_2 * rv_k0_3d) -
          s[i][1] * h2d) * h2inv;
      sd[i][2] = rvd[k][2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_ACCELERATION) {
      g0_3 = ra[k][0] + p[0];
      g0_3d = rad[k][0] + pd[0];
      g1_3 = ra[k][1] + p[1];
      g1_3d = rad[k][1] + pd[1];
      g2_4d = rad[k][2] + pd[2];
      A_j0_3 = A[j][0];
      A_j0_3d = Ad[j][0];
      A_j3_3 = A[j][3];
      A_j3_3d = Ad[j][3];
      t16 = A_j0_3 * A_j0_3 + A_j3_3 * A_j3_3;
      t16d = A_j0_3d * A_j0_3 + A_j0_3 * A_j0_3d + (A_j3_3d * A_j3_3 + A_j3_3 * A_j3_3d);
      h3 = sqrt(t16);
      c13 = 1.0 / (2.0 * h3);
      h3d = c13 * t16d;
      h3inv = 1.0 / h3;
      sd[i][0] = (A_j0_3d * g0_3 + A_j0_3 * g0_3d + (A_j3_3d * g1_3 + A_j3_3 * g1_3d) - s[i][0] *
          h3d) * h3inv;
      sd[i][1] = (A_j0_3d * g1_3 + A_j0_3 * g1_3d - (A_j3_3d * g0_3 + A_j3_3 * g0_3d) - s[i][1] *
          h3d) * h3inv;
      sd[i][2] = g2_4d;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_BODY_ACCELERATION) {
      g0_4 = ra[k][0] + p[0];
      g0_4d = rad[k][0] + pd[0];
      g1_4 = ra[k][1] + p[1];
      g1_4d = rad[k][1] + pd[1];
      g2_5 = ra[k][2] + p[2];
      g2_5d = rad[k][2] + pd[2];
      sd[i][0] = Ad[j][0] * g0_4 + A[j][0] * g0_4d + (Ad[j][3] * g1_4 + A[j][3] * g1_4d) + (Ad[j][6]
          * g2_5 + A[j][6] * g2_5d);
      sd[i][1] = Ad[j][1] * g0_4 + A[j][1] * g0_4d + (Ad[j][4] * g1_4 + A[j][4] * g1_4d) + (Ad[j][7]
          * g2_5 + A[j][7] * g2_5d);
      sd[i][2] = Ad[j][2] * g0_4 + A[j][2] * g0_4d + (Ad[j][5] * g1_4 + A[j][5] * g1_4d) + (Ad[j][8]
          * g2_5 + A[j][8] * g2_5d);
    } else if (t->sensorkind[i] == MAGGI_SENSOR_COMBINATION) {
      sumd = 0.0;
      for (a = 0; a < t->sensorterms[i]; ++a) {
        sumd += pd[t->sensoradr[i] + a] * s[t->termsensor[n2 + a]][t->termcolumn[n2 + a]] +
            p[t->sensoradr[i] + a] * sd[t->termsensor[n2 + a]][t->termcolumn[n2 + a]];
      }
      sd[i][0] = sumd;
      sd[i][1] = 0.0;
      sd[i][2] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      A_j7 = A[j][7];
      A_j7d = Ad[j][7];
      A_j8 = A[j][8];
      A_j8d = Ad[j][8];
      c14 = A_j8 / (A_j8 * A_j8 + A_j7 * A_j7);
      c15 = -(A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      sd[i][0] = c14 * A_j7d + c15 * A_j8d;
      t17 = -A[j][6];
      t17d = -Ad[j][6];
      t18 = A_j7 * A_j7 + A_j8 * A_j8;
      t18d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
      t19 = sqrt(t18);
      c16 = 1.0 / (2.0 * t19);
      t19d = c16 * t18d;
      c17 = t19 / (t19 * t19 + t17 * t17);
      c18 = -(t17 / (t19 * t19 + t17 * t17));
      sd[i][1] = c17 * t17d + c18 * t19d;
      c19 = A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]);
      c20 = -(A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      sd[i][2] = c19 * Ad[j][3] + c20 * Ad[j][0];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      A_j0_4 = A[j][0];
      A_j0_4d = Ad[j][0];
      A_j3_4 = A[j][3];
      A_j3_4d = Ad[j][3];
      c2 = A_j0_4 * A_j0_4 + A_j3_4 * A_j3_4;
      /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
       * A_6 = -sin(pitch) */
      c2d = A_j0_4d * A_j0_4 + A_j0_4 * A_j0_4d + (A_j3_4d * A_j3_4 + A_j3_4 * A_j3_4d);
      Z_j3 = Z[j][3];
      Z_j3d = Zd[j][3];
      Z_j4 = Z[j][4];
      Z_j4d = Zd[j][4];
      roll = s[i][0];
      c2inv = 1.0 / c2;
      rolld = (A_j0_4d * Z_j3 + A_j0_4 * Z_j3d + (A_j3_4d * Z_j4 + A_j3_4 * Z_j4d) - roll * c2d) *
          c2inv;
      sd[i][0] = rolld;
      t20 = sqrt(c2);
      c21 = 1.0 / (2.0 * t20);
      t20d = c21 * c2d;
      t20inv = 1.0 / t20;
      sd[i][1] = (A_j0_4d * Z_j4 + A_j0_4 * Z_j4d - (A_j3_4d * Z_j3 + A_j3_4 * Z_j3d) - s[i][1] *
          t20d) * t20inv;
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
      a3 = t->springpa[n2];
      b = t->springpb[n2];
      e0 = r[a3][0] - r[b][0];
      e0d = rd[a3][0] - rd[b][0];
      ev0 = rv[a3][0] - rv[b][0];
      ev0d = rvd[a3][0] - rvd[b][0];
      e1 = r[a3][1] - r[b][1];
      e1d = rd[a3][1] - rd[b][1];
      ev1 = rv[a3][1] - rv[b][1];
      ev1d = rvd[a3][1] - rvd[b][1];
      e2_2 = r[a3][2] - r[b][2];
      e2_2d = rd[a3][2] - rd[b][2];
      ev2_2 = rv[a3][2] - rv[b][2];
      ev2_2d = rvd[a3][2] - rvd[b][2];
      t21 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
      t21d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
      l = sqrt(t21);
      c22 = 1.0 / (2.0 * l);
      ld = c22 * t21d;
      n40 = e0 / l;
      linv = 1.0 / l;
      n40d = (e0d - n40 * ld) * linv;
      n41 = e1 / l;
      n41d = (e1d - n41 * ld) * linv;
      n42 = e2_2 / l;
      n42d = (e2_2d - n42 * ld) * linv;
      lv = n40 * ev0 + n41 * ev1 + n42 * ev2_2;
      lvd = n40d * ev0 + n40 * ev0d + (n41d * ev1 + n41 * ev1d) + (n42d * ev2_2 + n42 * ev2_2d);
      dampingd = pd[t->springadr[n2] + MAGGI_SPRING_C] * lv + p[t->springadr[n2] + MAGGI_SPRING_C] *
          lvd;
      if (t->springpreload[n2]) {
        f0d = pd[t->springadr[n2]] * (l - spring0[n2]) + p[t->springadr[n2]] * (ld - spring0d[n2]) +
            pd[t->springadr[n2] + MAGGI_SPRING_L];
      } else {
        f0d = pd[t->springadr[n2]] * (l - p[t->springadr[n2] + MAGGI_SPRING_L]) +
            p[t->springadr[n2]] * (ld - pd[t->springadr[n2] + MAGGI_SPRING_L]);
      }
      k3 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
      if (t->springslopes[n2]) {
        /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
        if (MAGGI_RE(lv) > MAGGI_RE(p[k3 + 4])) {
          p_k34 = p[k3 + 4];
          p_k34d = pd[k3 + 4];
          f2d = pd[k3] * p_k34 + p[k3] * p_k34d + (pd[k3 + 1] * (lv - p_k34) + p[k3 + 1] * (lvd -
              p_k34d));
        } else if (MAGGI_RE(lv) > 0.0) {
          f2d = pd[k3] * lv + p[k3] * lvd;
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k3 + 5])) {
          f2d = pd[k3 + 2] * lv + p[k3 + 2] * lvd;
        } else {
          p_k35 = p[k3 + 5];
          p_k35d = pd[k3 + 5];
          f2d = pd[k3 + 2] * p_k35 + p[k3 + 2] * p_k35d + (pd[k3 + 3] * (lv - p_k35) + p[k3 + 3] *
              (lvd - p_k35d));
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
      a3_2 = t->primpa[n2];
      b7 = t->primpb[n2];
      e20 = r[a3_2][0] - r[b7][0];
      /* distance of two points and its rate */
      e20d = rd[a3_2][0] - rd[b7][0];
      ev20 = rv[a3_2][0] - rv[b7][0];
      ev20d = rvd[a3_2][0] - rvd[b7][0];
      e21 = r[a3_2][1] - r[b7][1];
      e21d = rd[a3_2][1] - rd[b7][1];
      ev21 = rv[a3_2][1] - rv[b7][1];
      ev21d = rvd[a3_2][1] - rvd[b7][1];
      e22 = r[a3_2][2] - r[b7][2];
      e22d = rd[a3_2][2] - rd[b7][2];
      ev22 = rv[a3_2][2] - rv[b7][2];
      ev22d = rvd[a3_2][2] - rvd[b7][2];
      t22 = e20 * e20 + e21 * e21 + e22 * e22;
      t22d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 * e22d);
      l2 = sqrt(t22);
      c23 = 1.0 / (2.0 * l2);
      l2d = c23 * t22d;
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
      c24 = 1.0 / (1.0 + slip[n2][MAGGI_SLIP_TAN_ALPHA] * slip[n2][MAGGI_SLIP_TAN_ALPHA]);
      sd[i][1] = c24 * slipd[n2][MAGGI_SLIP_TAN_ALPHA];
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
        t23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
        t23d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfzd;
        t24 = exp(t23);
        t24d = t24 * t23d;
        x33 = fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t24 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
        x33d = ((fzd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz *
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t24 + fz * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t24d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + fz * (p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t24 *
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
        t25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2;
        t25d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_2d;
        z2 = fz / t25;
        t25inv = 1.0 / t25;
        z2d = (fzd - z2 * t25d) * t25inv;
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
          t26 = p2 * p2;
          t26d = p2d * p2 + p2 * p2d;
          z3 = gy2 * gy2 / t26;
          t26inv = 1.0 / t26;
          z3d = (gy2d * gy2 + gy2 * gy2d - z3 * t26d) * t26inv;
          y6 = 0.125 * p2 * z3 * (15.0 + z3 * (-10.0 + 3.0 * z3));
          y6d = (0.125 * p2d * z3 + 0.125 * p2 * z3d) * (15.0 + z3 * (-10.0 + 3.0 * z3)) + 0.125 *
              p2 * z3 * (z3d * (-10.0 + 3.0 * z3) + z3 * (3.0 * z3d));
        }
        t27 = 1.0 + z2 * z2;
        t27d = z2d * z2 + z2 * z2d;
        t28 = 2.0 * z2 / t27;
        t27inv = 1.0 / t27;
        t28d = (2.0 * z2d - t28 * t27d) * t27inv;
        y3_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28 * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) * p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_LKY];
        y3_2d = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2d) * t28 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_2 * t28d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6) - p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_PKY1] * fz0_2 * t28 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] *
            y6 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y6d)) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_PKY1] * fz0_2 * t28 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
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
        t29 = 1.0 + x4 * x4;
        t29d = x4d * x4 + x4 * x4d;
        t30 = sqrt(t29);
        c25 = 1.0 / (2.0 * t30);
        t30d = c25 * t29d;
        t31 = 1.0 / t30;
        t30inv = 1.0 / t30;
        t31d = -(t31 * t30d * t30inv);
        g20 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g20d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t31d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBX1] * t31 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
        g21 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
        g21d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
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
        g22 = y7;
        g22d = y7d;
        g23 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        g23d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
        x5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        x5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a2 -
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBY2] * (a2d - pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
        t32 = 1.0 + x5 * x5;
        t32d = x5d * x5 + x5 * x5d;
        t33 = sqrt(t32);
        c26 = 1.0 / (2.0 * t33);
        t33d = c26 * t32d;
        t34 = 1.0 / t33;
        t33inv = 1.0 / t33;
        t34d = -(t34 * t33d * t33inv);
        g24 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34 *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g24d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t34d) *
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RBY1] * t34 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
        g25 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
        g25d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
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
        g26 = y8;
        g26d = y8d;
        g27 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RHY2] * dfz;
        g27d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RHY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfzd);
        p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        p3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
        x6 = p3 * a2;
        x6d = p3d * a2 + p3 * a2d;
        t35 = 1.0 + x6 * x6;
        t35d = x6d * x6 + x6 * x6d;
        t36 = sqrt(t35);
        c27 = 1.0 / (2.0 * t36);
        t36d = c27 * t35d;
        t37 = 1.0 / t36;
        t36inv = 1.0 / t36;
        t37d = -(t37 * t36d * t36inv);
        dv = peak * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) * t37;
        dvd = (peakd * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]]
            + MAGGI_TYRE_RVY3] * gamma) + peak * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1]
            + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gammad))) * t37 + peak *
            (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma) *
            t37d;
        t38 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa;
        t38d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappad;
        t39 = atan(t38);
        c28 = 1.0 / (1.0 + t38 * t38);
        t39d = c28 * t38d;
        t40 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t39;
        t40d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t39 +
            p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t39d;
        t41 = sin(t40);
        c29 = cos(t40);
        t41d = c29 * t40d;
        g28 = dv * t41 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        g28d = (dvd * t41 + dv * t41d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + dv *
            t41 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
        y9 = g20 * (a2 + g23);
        y9d = g20d * (a2 + g23) + g20 * (a2d + g23d);
        y10 = g20 * g23;
        y10d = g20d * g23 + g20 * g23d;
        t42 = atan(y9);
        c30 = 1.0 / (1.0 + y9 * y9);
        t42d = c30 * y9d;
        t43 = (1.0 - g22) * y9 + g22 * t42;
        t43d = -(g22d * y9) + (1.0 - g22) * y9d + (g22d * t42 + g22 * t42d);
        t44 = atan(t43);
        c31 = 1.0 / (1.0 + t43 * t43);
        t44d = c31 * t43d;
        t45 = g21 * t44;
        t45d = g21d * t44 + g21 * t44d;
        t46 = cos(t45);
        c32 = -sin(t45);
        t46d = c32 * t45d;
        t47 = atan(y10);
        c33 = 1.0 / (1.0 + y10 * y10);
        t47d = c33 * y10d;
        t48 = (1.0 - g22) * y10 + g22 * t47;
        t48d = -(g22d * y10) + (1.0 - g22) * y10d + (g22d * t47 + g22 * t47d);
        t49 = atan(t48);
        c34 = 1.0 / (1.0 + t48 * t48);
        t49d = c34 * t48d;
        t50 = g21 * t49;
        t50d = g21d * t49 + g21 * t49d;
        t51 = cos(t50);
        c35 = -sin(t50);
        t51d = c35 * t50d;
        gx = t46 / t51;
        t51inv = 1.0 / t51;
        gxd = (t46d - gx * t51d) * t51inv;
        y11 = g24 * (kappa + g27);
        y11d = g24d * (kappa + g27) + g24 * (kappad + g27d);
        y12 = g24 * g27;
        y12d = g24d * g27 + g24 * g27d;
        t52 = atan(y11);
        c36 = 1.0 / (1.0 + y11 * y11);
        t52d = c36 * y11d;
        t53 = (1.0 - g26) * y11 + g26 * t52;
        t53d = -(g26d * y11) + (1.0 - g26) * y11d + (g26d * t52 + g26 * t52d);
        t54 = atan(t53);
        c37 = 1.0 / (1.0 + t53 * t53);
        t54d = c37 * t53d;
        t55 = g25 * t54;
        t55d = g25d * t54 + g25 * t54d;
        t56 = cos(t55);
        c38 = -sin(t55);
        t56d = c38 * t55d;
        t57 = atan(y12);
        c39 = 1.0 / (1.0 + y12 * y12);
        t57d = c39 * y12d;
        t58 = (1.0 - g26) * y12 + g26 * t57;
        t58d = -(g26d * y12) + (1.0 - g26) * y12d + (g26d * t57 + g26 * t57d);
        t59 = atan(t58);
        c40 = 1.0 / (1.0 + t58 * t58);
        t59d = c40 * t58d;
        t60 = g25 * t59;
        t60d = g25d * t59 + g25 * t59d;
        t61 = cos(t60);
        c41 = -sin(t60);
        t61d = c41 * t60d;
        gy = t56 / t61;
        t61inv = 1.0 / t61;
        gyd = (t56d - gy * t61d) * t61inv;
        b3 = g20;
        b3d = g20d;
        c3 = g21;
        c3d = g21d;
        e11 = g22;
        e11d = g22d;
        shift = g23;
        shiftd = g23d;
        y13 = b3 * (a2 + shift);
        /* its derivatives by x and by b */
        y13d = b3d * (a2 + shift) + b3 * (a2d + shiftd);
        y0 = b3 * shift;
        y0d = b3d * shift + b3 * shiftd;
        t62 = atan(y13);
        c42 = 1.0 / (1.0 + y13 * y13);
        t62d = c42 * y13d;
        t63 = (1.0 - e11) * y13 + e11 * t62;
        t63d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t62 + e11 * t62d);
        t64 = atan(t63);
        c43 = 1.0 / (1.0 + t63 * t63);
        t64d = c43 * t63d;
        z4 = c3 * t64;
        z4d = c3d * t64 + c3 * t64d;
        t65 = atan(y0);
        c44 = 1.0 / (1.0 + y0 * y0);
        t65d = c44 * y0d;
        t66 = (1.0 - e11) * y0 + e11 * t65;
        t66d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t65 + e11 * t65d);
        t67 = atan(t66);
        c45 = 1.0 / (1.0 + t66 * t66);
        t67d = c45 * t66d;
        z0 = c3 * t67;
        z0d = c3d * t67 + c3 * t67d;
        n5 = cos(z0);
        c46 = -sin(z0);
        n5d = c46 * z0d;
        t68 = atan(y13);
        c47 = 1.0 / (1.0 + y13 * y13);
        /* its derivative by y */
        t68d = c47 * y13d;
        z5 = (1.0 - e11) * y13 + e11 * t68;
        z5d = -(e11d * y13) + (1.0 - e11) * y13d + (e11d * t68 + e11 * t68d);
        t69 = sin(z4);
        c48 = cos(z4);
        t69d = c48 * z4d;
        t70 = 1.0 + y13 * y13;
        t70d = y13d * y13 + y13 * y13d;
        t71 = e11 / t70;
        t70inv = 1.0 / t70;
        t71d = (e11d - t71 * t70d) * t70inv;
        t72 = 1.0 + z5 * z5;
        t72d = z5d * z5 + z5 * z5d;
        t73 = c3 * (1.0 - e11 + t71) / t72;
        t72inv = 1.0 / t72;
        t73d = (c3d * (1.0 - e11 + t71) + c3 * (-e11d + t71d) - t73 * t72d) * t72inv;
        s2 = -t69 * t73 / n5;
        n5inv = 1.0 / n5;
        s2d = (-(t69d * t73) - t69 * t73d - s2 * n5d) * n5inv;
        t74 = atan(y0);
        c49 = 1.0 / (1.0 + y0 * y0);
        /* its derivative by y */
        t74d = c49 * y0d;
        z6 = (1.0 - e11) * y0 + e11 * t74;
        z6d = -(e11d * y0) + (1.0 - e11) * y0d + (e11d * t74 + e11 * t74d);
        t75 = cos(z4);
        c50 = -sin(z4);
        t75d = c50 * z4d;
        t76 = sin(z0);
        c51 = cos(z0);
        t76d = c51 * z0d;
        t77 = n5 * n5;
        t77d = n5d * n5 + n5 * n5d;
        t78 = t75 * t76 / t77;
        t77inv = 1.0 / t77;
        t78d = (t75d * t76 + t75 * t76d - t78 * t77d) * t77inv;
        t79 = 1.0 + y0 * y0;
        t79d = y0d * y0 + y0 * y0d;
        t80 = e11 / t79;
        t79inv = 1.0 / t79;
        t80d = (e11d - t80 * t79d) * t79inv;
        t81 = 1.0 + z6 * z6;
        t81d = z6d * z6 + z6 * z6d;
        t82 = c3 * (1.0 - e11 + t80) / t81;
        t81inv = 1.0 / t81;
        t82d = (c3d * (1.0 - e11 + t80) + c3 * (-e11d + t80d) - t82 * t81d) * t81inv;
        wx1 = s2 * (a2 + shift) + t78 * t82 * shift;
        wx1d = s2d * (a2 + shift) + s2 * (a2d + shiftd) + ((t78d * t82 + t78 * t82d) * shift + t78 *
            t82 * shiftd);
        b4 = g24;
        b4d = g24d;
        c4 = g25;
        c4d = g25d;
        e12 = g26;
        e12d = g26d;
        shift2 = g27;
        shift2d = g27d;
        y14 = b4 * (kappa + shift2);
        /* its derivatives by x and by b */
        y14d = b4d * (kappa + shift2) + b4 * (kappad + shift2d);
        y0_2 = b4 * shift2;
        y0_2d = b4d * shift2 + b4 * shift2d;
        t83 = atan(y14);
        c52 = 1.0 / (1.0 + y14 * y14);
        t83d = c52 * y14d;
        t84 = (1.0 - e12) * y14 + e12 * t83;
        t84d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t83 + e12 * t83d);
        t85 = atan(t84);
        c53 = 1.0 / (1.0 + t84 * t84);
        t85d = c53 * t84d;
        z7 = c4 * t85;
        z7d = c4d * t85 + c4 * t85d;
        t86 = atan(y0_2);
        c54 = 1.0 / (1.0 + y0_2 * y0_2);
        t86d = c54 * y0_2d;
        t87 = (1.0 - e12) * y0_2 + e12 * t86;
        t87d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t86 + e12 * t86d);
        t88 = atan(t87);
        c55 = 1.0 / (1.0 + t87 * t87);
        t88d = c55 * t87d;
        z0_2 = c4 * t88;
        z0_2d = c4d * t88 + c4 * t88d;
        n6 = cos(z0_2);
        c56 = -sin(z0_2);
        n6d = c56 * z0_2d;
        t89 = atan(y14);
        c57 = 1.0 / (1.0 + y14 * y14);
        /* its derivative by y */
        t89d = c57 * y14d;
        z8 = (1.0 - e12) * y14 + e12 * t89;
        z8d = -(e12d * y14) + (1.0 - e12) * y14d + (e12d * t89 + e12 * t89d);
        t90 = sin(z7);
        c58 = cos(z7);
        t90d = c58 * z7d;
        t91 = 1.0 + y14 * y14;
        t91d = y14d * y14 + y14 * y14d;
        t92 = e12 / t91;
        t91inv = 1.0 / t91;
        t92d = (e12d - t92 * t91d) * t91inv;
        t93 = 1.0 + z8 * z8;
        t93d = z8d * z8 + z8 * z8d;
        t94 = c4 * (1.0 - e12 + t92) / t93;
        t93inv = 1.0 / t93;
        t94d = (c4d * (1.0 - e12 + t92) + c4 * (-e12d + t92d) - t94 * t93d) * t93inv;
        s3 = -t90 * t94 / n6;
        n6inv = 1.0 / n6;
        s3d = (-(t90d * t94) - t90 * t94d - s3 * n6d) * n6inv;
        t95 = atan(y0_2);
        c59 = 1.0 / (1.0 + y0_2 * y0_2);
        /* its derivative by y */
        t95d = c59 * y0_2d;
        z9 = (1.0 - e12) * y0_2 + e12 * t95;
        z9d = -(e12d * y0_2) + (1.0 - e12) * y0_2d + (e12d * t95 + e12 * t95d);
        t96 = cos(z7);
        c60 = -sin(z7);
        t96d = c60 * z7d;
        t97 = sin(z0_2);
        c61 = cos(z0_2);
        t97d = c61 * z0_2d;
        t98 = n6 * n6;
        t98d = n6d * n6 + n6 * n6d;
        t99 = t96 * t97 / t98;
        t98inv = 1.0 / t98;
        t99d = (t96d * t97 + t96 * t97d - t99 * t98d) * t98inv;
        t100 = 1.0 + y0_2 * y0_2;
        t100d = y0_2d * y0_2 + y0_2 * y0_2d;
        t101 = e12 / t100;
        t100inv = 1.0 / t100;
        t101d = (e12d - t101 * t100d) * t100inv;
        t102 = 1.0 + z9 * z9;
        t102d = z9d * z9 + z9 * z9d;
        t103 = c4 * (1.0 - e12 + t101) / t102;
        t102inv = 1.0 / t102;
        t103d = (c4d * (1.0 - e12 + t101) + c4 * (-e12d + t101d) - t103 * t102d) * t102inv;
        wy1 = s3 * (kappa + shift2) + t99 * t103 * shift2;
        wy1d = s3d * (kappa + shift2) + s3 * (kappad + shift2d) + ((t99d * t103 + t99 * t103d) *
            shift2 + t99 * t103 * shift2d);
        t104 = x31 * x30;
        t104d = x31d * x30 + x31 * x30d;
        t105 = x33 / t104;
        t104inv = 1.0 / t104;
        t105d = (x33d - t105 * t104d) * t104inv;
        y15 = t105 * x34;
        y15d = t105d * x34 + t105 * x34d;
        t106 = atan(y15);
        c62 = 1.0 / (1.0 + y15 * y15);
        t106d = c62 * y15d;
        t107 = (1.0 - x32) * y15 + x32 * t106;
        t107d = -(x32d * y15) + (1.0 - x32) * y15d + (x32d * t106 + x32 * t106d);
        t108 = atan(t107);
        c63 = 1.0 / (1.0 + t107 * t107);
        t108d = c63 * t107d;
        t109 = x31 * t108;
        t109d = x31d * t108 + x31 * t108d;
        t110 = sin(t109);
        c64 = cos(t109);
        t110d = c64 * t109d;
        fx = x30 * t110 + x35;
        fxd = x30d * t110 + x30 * t110d + x35d;
        t111 = y1 * y0_3;
        t111d = y1d * y0_3 + y1 * y0_3d;
        t112 = y3_2 / t111;
        t111inv = 1.0 / t111;
        t112d = (y3_2d - t112 * t111d) * t111inv;
        y16 = t112 * y4_2;
        y16d = t112d * y4_2 + t112 * y4_2d;
        t113 = atan(y16);
        c65 = 1.0 / (1.0 + y16 * y16);
        t113d = c65 * y16d;
        t114 = (1.0 - y2_2) * y16 + y2_2 * t113;
        t114d = -(y2_2d * y16) + (1.0 - y2_2) * y16d + (y2_2d * t113 + y2_2 * t113d);
        t115 = atan(t114);
        c66 = 1.0 / (1.0 + t114 * t114);
        t115d = c66 * t114d;
        t116 = y1 * t115;
        t116d = y1d * t115 + y1 * t115d;
        t117 = sin(t116);
        c67 = cos(t116);
        t117d = c67 * t116d;
        fy = y0_3 * t117 + y5_2;
        fyd = y0_3d * t117 + y0_3 * t117d + y5_2d;
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
        p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        p5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3];
        x7 = p4 * (a2 - p5);
        /* b and the shift of Fy change with a by their cos(atan()) */
        x7d = p4d * (a2 - p5) + p4 * (a2d - p5d);
        t118 = 1.0 + x7 * x7;
        t118d = x7d * x7 + x7 * x7d;
        t119 = sqrt(t118);
        c68 = 1.0 / (2.0 * t119);
        t119d = c68 * t118d;
        t120 = 1.0 / t119;
        t119inv = 1.0 / t119;
        t120d = -(t120 * t119d * t119inv);
        l3 = p4 * t120;
        l3d = p4d * t120 + p4 * t120d;
        x8 = p3 * a2;
        x8d = p3d * a2 + p3 * a2d;
        t121 = 1.0 + x8 * x8;
        t121d = x8d * x8 + x8 * x8d;
        t122 = sqrt(t121);
        c69 = 1.0 / (2.0 * t122);
        t122d = c69 * t121d;
        t123 = 1.0 / t122;
        t122inv = 1.0 / t122;
        t123d = -(t123 * t122d * t122inv);
        v2 = p3 * t123;
        v2d = p3d * t123 + p3 * t123d;
        b2 = -g24 * l3 * l3 * (a2 - p5);
        b2d = ((-(g24d * l3) - g24 * l3d) * l3 + -g24 * l3 * l3d) * (a2 - p5) + -g24 * l3 * l3 *
            (a2d - p5d);
        t124 = y1 * y0_3;
        /* its derivative by the slip */
        t124d = y1d * y0_3 + y1 * y0_3d;
        b5 = y3_2 / t124;
        t124inv = 1.0 / t124;
        b5d = (y3_2d - b5 * t124d) * t124inv;
        y17 = b5 * y4_2;
        y17d = b5d * y4_2 + b5 * y4_2d;
        t125 = atan(y17);
        c70 = 1.0 / (1.0 + y17 * y17);
        /* its derivative by y */
        t125d = c70 * y17d;
        z10 = (1.0 - y2_2) * y17 + y2_2 * t125;
        z10d = -(y2_2d * y17) + (1.0 - y2_2) * y17d + (y2_2d * t125 + y2_2 * t125d);
        t126 = atan(y17);
        c71 = 1.0 / (1.0 + y17 * y17);
        t126d = c71 * y17d;
        t127 = (1.0 - y2_2) * y17 + y2_2 * t126;
        t127d = -(y2_2d * y17) + (1.0 - y2_2) * y17d + (y2_2d * t126 + y2_2 * t126d);
        t128 = atan(t127);
        c72 = 1.0 / (1.0 + t127 * t127);
        t128d = c72 * t127d;
        t129 = y1 * t128;
        t129d = y1d * t128 + y1 * t128d;
        t130 = cos(t129);
        c73 = -sin(t129);
        t130d = c73 * t129d;
        t131 = 1.0 + y17 * y17;
        t131d = y17d * y17 + y17 * y17d;
        t132 = y2_2 / t131;
        t131inv = 1.0 / t131;
        t132d = (y2_2d - t132 * t131d) * t131inv;
        t133 = 1.0 + z10 * z10;
        t133d = z10d * z10 + z10 * z10d;
        t134 = y1 * (1.0 - y2_2 + t132) / t133;
        t133inv = 1.0 / t133;
        t134d = (y1d * (1.0 - y2_2 + t132) + y1 * (-y2_2d + t132d) - t134 * t133d) * t133inv;
        sd[i][0] = (a2d * a2 + a2 * a2d) * (gy * (y0_3 * t130 * t134 * b5) + fy * wy1 * b2 - g28 *
            v2 * v2 * a2) + (1.0 + a2 * a2) * (gyd * (y0_3 * t130 * t134 * b5) + gy * (((y0_3d *
            t130 + y0_3 * t130d) * t134 + y0_3 * t130 * t134d) * b5 + y0_3 * t130 * t134 * b5d) +
            ((fyd * wy1 + fy * wy1d) * b2 + fy * wy1 * b2d) - (((g28d * v2 + g28 * v2d) * v2 + g28 *
            v2 * v2d) * a2 + g28 * v2 * v2 * a2d));
        p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        p6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
        x9 = p6 * kappa;
        x9d = p6d * kappa + p6 * kappad;
        t135 = 1.0 + x9 * x9;
        t135d = x9d * x9 + x9 * x9d;
        t136 = sqrt(t135);
        c74 = 1.0 / (2.0 * t136);
        t136d = c74 * t135d;
        t137 = 1.0 / t136;
        t136inv = 1.0 / t136;
        t137d = -(t137 * t136d * t136inv);
        m = p6 * t137;
        md = p6d * t137 + p6 * t137d;
        ka = -g20 * m * m * kappa;
        kad = ((-(g20d * m) - g20 * md) * m + -g20 * m * md) * kappa + -g20 * m * m * kappad;
        t138 = x31 * x30;
        /* its derivative by the slip */
        t138d = x31d * x30 + x31 * x30d;
        b6 = x33 / t138;
        t138inv = 1.0 / t138;
        b6d = (x33d - b6 * t138d) * t138inv;
        y18 = b6 * x34;
        y18d = b6d * x34 + b6 * x34d;
        t139 = atan(y18);
        c75 = 1.0 / (1.0 + y18 * y18);
        /* its derivative by y */
        t139d = c75 * y18d;
        z11 = (1.0 - x32) * y18 + x32 * t139;
        z11d = -(x32d * y18) + (1.0 - x32) * y18d + (x32d * t139 + x32 * t139d);
        t140 = atan(y18);
        c76 = 1.0 / (1.0 + y18 * y18);
        t140d = c76 * y18d;
        t141 = (1.0 - x32) * y18 + x32 * t140;
        t141d = -(x32d * y18) + (1.0 - x32) * y18d + (x32d * t140 + x32 * t140d);
        t142 = atan(t141);
        c77 = 1.0 / (1.0 + t141 * t141);
        t142d = c77 * t141d;
        t143 = x31 * t142;
        t143d = x31d * t142 + x31 * t142d;
        t144 = cos(t143);
        c78 = -sin(t143);
        t144d = c78 * t143d;
        t145 = 1.0 + y18 * y18;
        t145d = y18d * y18 + y18 * y18d;
        t146 = x32 / t145;
        t145inv = 1.0 / t145;
        t146d = (x32d - t146 * t145d) * t145inv;
        t147 = 1.0 + z11 * z11;
        t147d = z11d * z11 + z11 * z11d;
        t148 = x31 * (1.0 - x32 + t146) / t147;
        t147inv = 1.0 / t147;
        t148d = (x31d * (1.0 - x32 + t146) + x31 * (-x32d + t146d) - t148 * t147d) * t147inv;
        sd[i][1] = gxd * (x30 * t144 * t148 * b6) + gx * (((x30d * t144 + x30 * t144d) * t148 + x30
            * t144 * t148d) * b6 + x30 * t144 * t148 * b6d) + ((fxd * wx1 + fx * wx1d) * ka + fx *
            wx1 * kad);
        ux = fx * gx / x30;
        x30inv = 1.0 / x30;
        uxd = (fxd * gx + fx * gxd - ux * x30d) * x30inv;
        uy = (fy * gy + g28) / y0_3;
        y0_3inv = 1.0 / y0_3;
        uyd = (fyd * gy + fy * gyd + g28d - uy * y0_3d) * y0_3inv;
        t149d = uxd * ux + ux * uxd + (uyd * uy + uy * uyd);
        c79 = 1.0 / (2.0 * s[i][2]);
        sd[i][2] = c79 * t149d;
      } else {
        sd[i][0] = 0.0;
        sd[i][1] = 0.0;
        sd[i][2] = 0.0;
      }
    }
  }
}
