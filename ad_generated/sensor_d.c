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
                     const double rad[restrict t->npoint][3],
                     const double driver[restrict t->ndriver][4],
                     const double driverd[restrict t->ndriver][4],
                     const double speed[restrict t->nspeed][3],
                     const double speedd[restrict t->nspeed][3],
                     const double lambda[restrict t->nrow], const double lambdad[restrict t->nrow],
                     double s[restrict t->nsensor][3], double sd[restrict t->nsensor][3])
{
  int a, a4, a4_2, a4_3, b, b2, b2_2, i, j, k, k3, n2;
  double A_j0, A_j0_2, A_j0_2d, A_j0_3, A_j0_3d, A_j0_4, A_j0_4d, A_j0d, A_j3, A_j3_2, A_j3_2d,
      A_j3_3, A_j3_3d, A_j3_4, A_j3_4d, A_j3d, A_j7, A_j7d, A_j8, A_j8d, L0, L0d, L1, L1d, L2, L2d,
      N0, N0d, N1, N2, N2d, T0, T0d, T1, T1d, T2, T2d, Z_j3, Z_j3d, Z_j4, Z_j4d, Z_k3, Z_k3d, Z_k4,
      Z_k4d, Z_k5, Z_k5d, a00, a00d, a01, a01d, a02, a02d, a2, a2d, a3, a3d, along0, along0d,
      along1, along1d, along2, along2d, ar, ard, areq, areqd, arm0, arm0d, arm1, arm1d, arm2, arm2d,
      at, atd, ateq, ateqd, ay, ayd, br, brd, bt, btd, bx, bxd, by, bycy, bycyd, byd, c, c10, c11,
      c12, c13, c14, c15, c16, c17, c18, c19, c2, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29,
      c2d, c2inv, c3, c30, c31, c32, c33, c34, c35, c36, c37, c38, c39, c3d, c4, c40, c41, c42, c43,
      c44, c45, c46, c47, c48, c49, c5, c50, c51, c52, c53, c54, c55, c56, c57, c58, c59, c6, c60,
      c61, c62, c63, c7, c8, c9, ca, cad, cd, cx, cxd, cy, cyd, d, dampingd, dd, dfz, dfzd, dr, drd,
      dt, dtd, dv, dvd, dx, dxd, dy, dyd, e0, e0d, e1, e10, e10d, e11, e11d, e12, e12d, e13, e13d,
      e1d, e20, e20d, e21, e21d, e22, e22d, e2_2, e2_2d, e3, e3d, e4, e4d, e5, e5d, e6, e6d, e7,
      e7d, e8, e8d, e9, e9d, et, etd, ev0, ev0d, ev1, ev1d, ev20, ev20d, ev21, ev21d, ev22, ev22d,
      ev2_2, ev2_2d, ex, exd, ey, eyd, f0d, f1d, f2d, force0d, force1d, force2d, force3d, force4d,
      force5d, fx, fxd, fy, fyd, fz, fz0, fz0_2, fz0_2d, fz0_2inv, fz0_3, fz0_3d, fz0_4, fz0_4d,
      fz0_4inv, fz0d, fz0inv, fz2, fz2d, fzd, g0, g0_2, g0_2d, g0_3, g0_3d, g0_4, g0_4d, g0d, g1,
      g1_2, g1_2d, g1_3, g1_3d, g1_4, g1_4d, g1d, g20, g20d, g22, g22d, g2_2, g2_2d, g2_4d, g2_5,
      g2_5d, g30, g30d, g31, g31d, gamma, gamma2, gamma2d, gammad, gx, gxd, gy, gyd, gz, gzd, h,
      h00, h00d, h10, h10d, h11, h11d, h2, h2d, h2inv, h3, h3d, h3inv, hd, hinv, inv, inv2, inv3,
      kappa, kappa2, kappa2d, kappad, kx, kxd, l, l2, l2d, l2inv, ld, linv, lv, lvd, mux, muxd, muy,
      muy2, muy2d, muyd, n30, n30d, n31, n31d, n32, n32d, n40, n40d, n41, n41d, n42, n42d, n5, n5d,
      n5inv, n60, n60d, n61, n62, n62d, omega, omegad, one0, one0d, one1, one1d, one2, one2d, one3,
      one3d, one4, one4d, p10, p10d, p10inv, p2, p2d, p2inv, p3, p3d, p4, p4d, p4inv, p5, p5d, p6,
      p6d, p7, p7d, p8, p8d, p9, p9d, p_b2, p_b2_2, p_b2_2d, p_b2_2inv, p_b2_3, p_b2_3d, p_b2_4,
      p_b2_4d, p_b2_5, p_b2_5d, p_b2_5inv, p_b2_6, p_b2_6d, p_b2d, p_i, p_i1, p_i1d, p_i2, p_i2d,
      p_i3, p_i3d, p_id, p_k34, p_k34d, p_k35, p_k35d, r0, r0d, r2, r2d, r2inv, r3, r3d, ratio,
      ratio2, ratio2d, ratiod, re, red, rhov, rhovd, roll, rolld, rolling0d, rolling1d, rolling2d,
      rolling3d, rolling4d, rolling5d, rv_k0, rv_k0_2, rv_k0_2d, rv_k0_3, rv_k0_3d, rv_k0d, rv_k1,
      rv_k1_2, rv_k1_2d, rv_k1_3, rv_k1_3d, rv_k1d, rv_k2, rv_k2d, s2, s2d, s2inv, s3, s3d, s4, s4d,
      shift, shiftd, shy, shyd, side, slip0d, slip1, slip1d, slip2d, speed2, speed2d, speed2inv,
      speed3, speed3d, stiff, stiff2, stiff2d, stiff2inv, stiff3, stiff3d, stiff4, stiff4d, stiffd,
      sumd, svx, svxd, svy, svyd, t10, t100, t100d, t100inv, t101, t101d, t102, t102d, t103, t103d,
      t104, t104d, t105, t105d, t106, t106d, t107, t107d, t107inv, t108, t108d, t109, t109d, t10d,
      t11, t110, t110d, t111, t111d, t112, t112d, t11d, t11inv, t12, t12d, t13d, t14, t14d, t14inv,
      t15, t15d, t16, t16d, t17, t17d, t18, t18d, t19, t19d, t2, t20, t20d, t20inv, t21, t21d, t22,
      t22d, t23, t23d, t24, t24d, t25, t25d, t26, t26d, t26inv, t27, t27d, t28, t28d, t29, t29d,
      t2d, t2inv, t3, t30, t30d, t31, t31d, t32, t32d, t33, t33d, t34, t34d, t35, t35d, t36, t36d,
      t37, t37d, t38, t38d, t39, t39d, t3d, t4, t40, t40d, t41, t41d, t41inv, t42, t42d, t43, t43d,
      t44, t44d, t45, t45d, t46, t46d, t47, t47d, t47inv, t48, t48d, t48inv, t49, t49d, t49inv, t4d,
      t4inv, t5, t50, t50d, t51, t51d, t51inv, t52, t52d, t53, t53d, t54, t54d, t55, t55d, t56,
      t56d, t57, t57d, t58, t58d, t59, t59d, t59inv, t5d, t6, t60, t60d, t61, t61d, t62, t62d,
      t62inv, t63, t63d, t64, t64d, t65, t65d, t66, t66d, t67, t67d, t68, t68d, t69, t69d, t6d,
      t6inv, t7, t70, t70d, t71, t71d, t72, t72d, t73, t73d, t73inv, t74, t74d, t75, t75d, t76,
      t76d, t77, t77d, t78, t78d, t79, t79d, t79inv, t7d, t8, t80, t80d, t81, t81d, t82, t82d, t83,
      t83d, t84, t84d, t85, t85d, t86, t86d, t87, t87d, t88, t88d, t89, t89d, t8d, t8inv, t9, t90,
      t90d, t90inv, t91, t91d, t92, t92d, t93, t93d, t94, t94d, t94inv, t95, t95d, t96, t96d, t97,
      t97d, t98, t98d, t99, t99d, t9d, torque0d, u20, u20d, u21, u21d, u30, u30d, u31, u31d, u32,
      u32d, ua0, ua0d, ua1, ua1d, ua2, ua2d, un0, un0d, un1, un1d, un2, un2d, v20, v20d, v21, v21d,
      v22, v22d, vr0, vr0d, vr1, vr1d, vr2, vr2d, vx, vxd, w, w2, w2d, w2inv, way, wayd, wd, wr0,
      wr0d, wr1, wr1d, wr2, wr2d, x2, x2d, x3, x3d, x4, x4d, x50, x50d, x51, x51d, x6, x6d, x7, x7d,
      x8, x8d, x9, x9d, xv, xvd, y, y10, y10d, y11, y11d, y12, y12d, y13, y13d, y14, y14d, y15,
      y15d, y16, y16d, y17, y17d, y18, y18d, y20, y20d, y21, y21d, y21inv, y22, y22d, y23, y23d,
      y24, y24d, y3, y3d, y4, y4d, y5, y5d, y6, y6d, y7, y7d, y8, y8d, y9, y9d, yd, z0_2d, z0_3d,
      z0d, z1_2d, z1_3, z1_3d, z1d, z20, z20d, z21, z21d, z22, z22d, z22inv, z30, z30d, z31d, z4,
      z4d, z5, z5d, z6, z6d;

  (void)origin;
  (void)x;
  (void)Za;
  (void)driver;
  (void)speed;
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
      c4 = 1.0 / (2.0 * t4);
      t4d = c4 * t3d;
      t4inv = 1.0 / t4;
      sd[i][0] = (n30d * n30 + n30 * n30d + (n31d * n31 + n31 * n31d) + (n32d * n32 + n32 * n32d) -
          s[i][0] * t4d) * t4inv;
      t5 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + w;
      t5d = rv_k0d * rv_k0 + rv_k0 * rv_k0d + (rv_k1d * rv_k1 + rv_k1 * rv_k1d) + wd;
      t6 = sqrt(t5);
      c5 = 1.0 / (2.0 * t6);
      t6d = c5 * t5d;
      t6inv = 1.0 / t6;
      sd[i][1] = (rv_k0d * g1 + rv_k0 * g1d - (rv_k1d * g0 + rv_k1 * g0d) - s[i][1] * t6d) * t6inv;
      t7 = g0 * g0 + g1 * g1 + p_i1 * p_i1;
      t7d = g0d * g0 + g0 * g0d + (g1d * g1 + g1 * g1d) + (p_i1d * p_i1 + p_i1 * p_i1d);
      t8 = sqrt(t7);
      c6 = 1.0 / (2.0 * t8);
      t8d = c6 * t7d;
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
      c7 = 1.0 / (2.0 * h);
      hd = c7 * t9d;
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
      c8 = 1.0 / (2.0 * r2);
      r2d = c8 * t10d;
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
      c9 = d / (d * d + u21 * u21);
      c10 = -(u21 / (d * d + u21 * u21));
      t13d = c9 * u21d + c10 * dd;
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
      c11 = 1.0 / (2.0 * h2);
      h2d = c11 * t15d;
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
      c12 = 1.0 / (2.0 * h3);
      h3d = c12 * t16d;
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
      c13 = A_j8 / (A_j8 * A_j8 + A_j7 * A_j7);
      c14 = -(A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      sd[i][0] = c13 * A_j7d + c14 * A_j8d;
      t17 = -A[j][6];
      t17d = -Ad[j][6];
      t18 = A_j7 * A_j7 + A_j8 * A_j8;
      t18d = A_j7d * A_j7 + A_j7 * A_j7d + (A_j8d * A_j8 + A_j8 * A_j8d);
      t19 = sqrt(t18);
      c15 = 1.0 / (2.0 * t19);
      t19d = c15 * t18d;
      c16 = t19 / (t19 * t19 + t17 * t17);
      c17 = -(t17 / (t19 * t19 + t17 * t17));
      sd[i][1] = c16 * t17d + c17 * t19d;
      c18 = A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]);
      c19 = -(A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      sd[i][2] = c18 * Ad[j][3] + c19 * Ad[j][0];
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
      c20 = 1.0 / (2.0 * t20);
      t20d = c20 * c2d;
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
      a4 = t->springpa[n2];
      b = t->springpb[n2];
      e0 = r[a4][0] - r[b][0];
      e0d = rd[a4][0] - rd[b][0];
      ev0 = rv[a4][0] - rv[b][0];
      ev0d = rvd[a4][0] - rvd[b][0];
      e1 = r[a4][1] - r[b][1];
      e1d = rd[a4][1] - rd[b][1];
      ev1 = rv[a4][1] - rv[b][1];
      ev1d = rvd[a4][1] - rvd[b][1];
      e2_2 = r[a4][2] - r[b][2];
      e2_2d = rd[a4][2] - rd[b][2];
      ev2_2 = rv[a4][2] - rv[b][2];
      ev2_2d = rvd[a4][2] - rvd[b][2];
      t21 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
      t21d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
      l = sqrt(t21);
      c21 = 1.0 / (2.0 * l);
      ld = c21 * t21d;
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
      z0d = ld;
      z1d = lvd;
      sd[i][0] = z0d;
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
      z0_2d = x2d;
      z1_2d = xvd;
      sd[i][0] = z0_2d;
      sd[i][1] = z1_2d;
      sd[i][2] = torque0d;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ROD) {
      a4_2 = t->primpa[n2];
      b2 = t->primpb[n2];
      e20 = r[a4_2][0] - r[b2][0];
      /* distance of two points and its rate */
      e20d = rd[a4_2][0] - rd[b2][0];
      ev20 = rv[a4_2][0] - rv[b2][0];
      ev20d = rvd[a4_2][0] - rvd[b2][0];
      e21 = r[a4_2][1] - r[b2][1];
      e21d = rd[a4_2][1] - rd[b2][1];
      ev21 = rv[a4_2][1] - rv[b2][1];
      ev21d = rvd[a4_2][1] - rvd[b2][1];
      e22 = r[a4_2][2] - r[b2][2];
      e22d = rd[a4_2][2] - rd[b2][2];
      ev22 = rv[a4_2][2] - rv[b2][2];
      ev22d = rvd[a4_2][2] - rvd[b2][2];
      t22 = e20 * e20 + e21 * e21 + e22 * e22;
      t22d = e20d * e20 + e20 * e20d + (e21d * e21 + e21 * e21d) + (e22d * e22 + e22 * e22d);
      l2 = sqrt(t22);
      c22 = 1.0 / (2.0 * l2);
      l2d = c22 * t22d;
      z0_3d = l2d;
      z1_3 = s[i][1];
      l2inv = 1.0 / l2;
      z1_3d = (e20d * ev20 + e20 * ev20d + (e21d * ev21 + e21 * ev21d) + (e22d * ev22 + e22 * ev22d)
          - z1_3 * l2d) * l2inv;
      sd[i][0] = z0_3d;
      sd[i][1] = z1_3d;
      sd[i][2] = lambdad[t->primrow[n2]];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SPEED) {
      sd[i][0] = speedd[n2][0];
      sd[i][1] = speedd[n2][1];
      sd[i][2] = speedd[n2][2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_DRIVER) {
      sd[i][0] = driverd[n2][0];
      sd[i][1] = driverd[n2][1];
      sd[i][2] = driverd[n2][2];
    } else {
      a4_3 = t->wheelpoint[n2];
      b2_2 = t->wheelroad[n2];
      j = t->wheelbody[n2];
      k = t->wheelcarrier[n2];
      side = t->wheelmirror[n2] ? -1.0 : 1.0;
      a00 = p[t->wheelaxis[n2]];
      a00d = pd[t->wheelaxis[n2]];
      a01 = p[t->wheelaxis[n2] + 1];
      a01d = pd[t->wheelaxis[n2] + 1];
      a02 = p[t->wheelaxis[n2] + 2];
      a02d = pd[t->wheelaxis[n2] + 2];
      ua0 = A[j][0] * a00 + A[j][1] * a01 + A[j][2] * a02;
      ua0d = Ad[j][0] * a00 + A[j][0] * a00d + (Ad[j][1] * a01 + A[j][1] * a01d) + (Ad[j][2] * a02 +
          A[j][2] * a02d);
      ua1 = A[j][3] * a00 + A[j][4] * a01 + A[j][5] * a02;
      ua1d = Ad[j][3] * a00 + A[j][3] * a00d + (Ad[j][4] * a01 + A[j][4] * a01d) + (Ad[j][5] * a02 +
          A[j][5] * a02d);
      ua2 = A[j][6] * a00 + A[j][7] * a01 + A[j][8] * a02;
      ua2d = Ad[j][6] * a00 + A[j][6] * a00d + (Ad[j][7] * a01 + A[j][7] * a01d) + (Ad[j][8] * a02 +
          A[j][8] * a02d);
      t23 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
      t23d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
      n5 = sqrt(t23);
      c23 = 1.0 / (2.0 * n5);
      n5d = c23 * t23d;
      u30 = ua0 / n5;
      n5inv = 1.0 / n5;
      u30d = (ua0d - u30 * n5d) * n5inv;
      u31 = ua1 / n5;
      u31d = (ua1d - u31 * n5d) * n5inv;
      u32 = ua2 / n5;
      u32d = (ua2d - u32 * n5d) * n5inv;
      g20 = r[a4_3][0] - r[t->roadpoint[b2_2]][0];
      g20d = rd[a4_3][0] - rd[t->roadpoint[b2_2]][0];
      g22 = r[a4_3][2] - r[t->roadpoint[b2_2]][2];
      g22d = rd[a4_3][2] - rd[t->roadpoint[b2_2]][2];
      x4 = g20;
      /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
       * the centre down the disc meets it, n its normal; then down the disc to that plane,
       *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
       * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
      x4d = g20d;
      /* height of the road above its point at x ahead of it, and its slope */
      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
        p_b2 = p[t->roadadr[b2_2]];
        p_b2d = pd[t->roadadr[b2_2]];
        h00 = p_b2 * x4;
        h00d = p_b2d * x4 + p_b2 * x4d;
      } else {
        p_b2_2 = p[t->roadadr[b2_2] + 1];
        p_b2_2d = pd[t->roadadr[b2_2] + 1];
        t24 = 6.28318530717958647693 * x4 / p_b2_2;
        p_b2_2inv = 1.0 / p_b2_2;
        t24d = (6.28318530717958647693 * x4d - t24 * p_b2_2d) * p_b2_2inv;
        t25 = sin(t24);
        c24 = cos(t24);
        t25d = c24 * t24d;
        p_b2_3 = p[t->roadadr[b2_2]];
        p_b2_3d = pd[t->roadadr[b2_2]];
        h00 = p_b2_3 * t25;
        h00d = p_b2_3d * t25 + p_b2_3 * t25d;
      }
      t26 = u30 * u30 + u31 * u31;
      t26d = u30d * u30 + u30 * u30d + (u31d * u31 + u31 * u31d);
      t27 = u32 * u30 / t26;
      t26inv = 1.0 / t26;
      t27d = (u32d * u30 + u32 * u30d - t27 * t26d) * t26inv;
      x3 = g20 + t27 * (g22 - h00);
      x3d = g20d + (t27d * (g22 - h00) + t27 * (g22d - h00d));
      /* height of the road above its point at x ahead of it, and its slope */
      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
        p_b2_4 = p[t->roadadr[b2_2]];
        p_b2_4d = pd[t->roadadr[b2_2]];
        h10 = p_b2_4 * x3;
        h10d = p_b2_4d * x3 + p_b2_4 * x3d;
        h11 = p_b2_4;
        h11d = p_b2_4d;
      } else {
        p_b2_5 = p[t->roadadr[b2_2] + 1];
        p_b2_5d = pd[t->roadadr[b2_2] + 1];
        t28 = 6.28318530717958647693 * x3 / p_b2_5;
        p_b2_5inv = 1.0 / p_b2_5;
        t28d = (6.28318530717958647693 * x3d - t28 * p_b2_5d) * p_b2_5inv;
        t29 = sin(t28);
        c25 = cos(t28);
        t29d = c25 * t28d;
        p_b2_6 = p[t->roadadr[b2_2]];
        p_b2_6d = pd[t->roadadr[b2_2]];
        h10 = p_b2_6 * t29;
        h10d = p_b2_6d * t29 + p_b2_6 * t29d;
        t30 = p_b2_6 * 6.28318530717958647693 / p_b2_5;
        t30d = (p_b2_6d * 6.28318530717958647693 - t30 * p_b2_5d) * p_b2_5inv;
        t31 = 6.28318530717958647693 * x3 / p_b2_5;
        t31d = (6.28318530717958647693 * x3d - t31 * p_b2_5d) * p_b2_5inv;
        t32 = cos(t31);
        c26 = -sin(t31);
        t32d = c26 * t31d;
        h11 = t30 * t32;
        h11d = t30d * t32 + t30 * t32d;
      }
      t33 = 1.0 + h11 * h11;
      t33d = h11d * h11 + h11 * h11d;
      s2 = sqrt(t33);
      c27 = 1.0 / (2.0 * s2);
      s2d = c27 * t33d;
      n60 = -h11 / s2;
      s2inv = 1.0 / s2;
      n60d = (-h11d - n60 * s2d) * s2inv;
      n61 = 0.0;
      n62 = 1.0 / s2;
      n62d = -(n62 * s2d * s2inv);
      c3 = u30 * n60 + u31 * n61 + u32 * n62;
      c3d = u30d * n60 + u30 * n60d + u31d * n61 + (u32d * n62 + u32 * n62d);
      un0 = u31 * n62 - u32 * n61;
      un0d = u31d * n62 + u31 * n62d - u32d * n61;
      un1 = u32 * n60 - u30 * n62;
      un1d = u32d * n60 + u32 * n60d - (u30d * n62 + u30 * n62d);
      un2 = u30 * n61 - u31 * n60;
      un2d = u30d * n61 - (u31d * n60 + u31 * n60d);
      t34 = un0 * un0 + un1 * un1 + un2 * un2;
      t34d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
      w2 = sqrt(t34);
      c28 = 1.0 / (2.0 * w2);
      w2d = c28 * t34d;
      r3 = ((g20 - x3) * n60 + (g22 - h10) * n62) / w2;
      w2inv = 1.0 / w2;
      r3d = ((g20d - x3d) * n60 + (g20 - x3) * n60d + ((g22d - h10d) * n62 + (g22 - h10) * n62d) -
          r3 * w2d) * w2inv;
      along0 = un0 / w2;
      along0d = (un0d - along0 * w2d) * w2inv;
      along1 = un1 / w2;
      along1d = (un1d - along1 * w2d) * w2inv;
      along2 = un2 / w2;
      along2d = (un2d - along2 * w2d) * w2inv;
      L0 = n61 * along2 - n62 * along1;
      L0d = n61 * along2d - (n62d * along1 + n62 * along1d);
      L1 = n62 * along0 - n60 * along2;
      L1d = n62d * along0 + n62 * along0d - (n60d * along2 + n60 * along2d);
      L2 = n60 * along1 - n61 * along0;
      L2d = n60d * along1 + n60 * along1d - n61 * along0d;
      arm0 = r3 * (c3 * u30 - n60) / w2;
      arm0d = (r3d * (c3 * u30 - n60) + r3 * (c3d * u30 + c3 * u30d - n60d) - arm0 * w2d) * w2inv;
      T0 = along0;
      T0d = along0d;
      N0 = n60;
      N0d = n60d;
      arm1 = r3 * (c3 * u31 - n61) / w2;
      arm1d = (r3d * (c3 * u31 - n61) + r3 * (c3d * u31 + c3 * u31d) - arm1 * w2d) * w2inv;
      T1 = along1;
      T1d = along1d;
      N1 = n61;
      arm2 = r3 * (c3 * u32 - n62) / w2;
      arm2d = (r3d * (c3 * u32 - n62) + r3 * (c3d * u32 + c3 * u32d - n62d) - arm2 * w2d) * w2inv;
      T2 = along2;
      T2d = along2d;
      N2 = n62;
      N2d = n62d;
      z20 = r3;
      z20d = r3d;
      z21 = c3;
      z21d = c3d;
      z22 = w2;
      z22d = w2d;
      Z_k3 = Z[k][3];
      Z_k3d = Zd[k][3];
      wr0 = Z_k3;
      wr0d = Z_k3d;
      Z_k4 = Z[k][4];
      Z_k4d = Zd[k][4];
      wr1 = Z_k4;
      wr1d = Z_k4d;
      Z_k5 = Z[k][5];
      Z_k5d = Zd[k][5];
      wr2 = Z_k5;
      wr2d = Z_k5d;
      vr0 = wr1 * arm2 - wr2 * arm1;
      vr0d = wr1d * arm2 + wr1 * arm2d - (wr2d * arm1 + wr2 * arm1d);
      vr1 = wr2 * arm0 - wr0 * arm2;
      vr1d = wr2d * arm0 + wr2 * arm0d - (wr0d * arm2 + wr0 * arm2d);
      vr2 = wr0 * arm1 - wr1 * arm0;
      vr2d = wr0d * arm1 + wr0 * arm1d - (wr1d * arm0 + wr1 * arm0d);
      v20 = rv[a4_3][0] + vr0;
      v20d = rvd[a4_3][0] + vr0d;
      v21 = rv[a4_3][1] + vr1;
      v21d = rvd[a4_3][1] + vr1d;
      v22 = rv[a4_3][2] + vr2;
      v22d = rvd[a4_3][2] + vr2d;
      vx = v20 * T0 + v21 * T1 + v22 * T2;
      vxd = v20d * T0 + v20 * T0d + (v21d * T1 + v21 * T1d) + (v22d * T2 + v22 * T2d);
      rhov = -(v20 * N0 + v21 * N1 + v22 * N2) / z22;
      z22inv = 1.0 / z22;
      rhovd = (-(v20d * N0 + v20 * N0d + v21d * N1 + (v22d * N2 + v22 * N2d)) - rhov * z22d) *
          z22inv;
      omega = (Z[j][3] - Z_k3) * u30 + (Z[j][4] - Z_k4) * u31 + (Z[j][5] - Z_k5) * u32;
      omegad = (Zd[j][3] - Z_k3d) * u30 + (Z[j][3] - Z_k3) * u30d + ((Zd[j][4] - Z_k4d) * u31 +
          (Z[j][4] - Z_k4) * u31d) + ((Zd[j][5] - Z_k5d) * u32 + (Z[j][5] - Z_k5) * u32d);
      p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      p2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
      p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
      p3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
      fz = p2 * (p3 - z20) + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
      fzd = p2d * (p3 - z20) + p2 * (p3d - z20d) + (pd[t->tyreadr[t->wheeltyre[n2]] +
          MAGGI_TYRE_VERTICAL_DAMPING] * rhov + p[t->tyreadr[t->wheeltyre[n2]] +
          MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
      fz0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]];
      fz0d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[n2]]] +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[n2]]];
      ratio = fz / fz0;
      fz0inv = 1.0 / fz0;
      ratiod = (fzd - ratio * fz0d) * fz0inv;
      t35 = fz0 / p2;
      p2inv = 1.0 / p2;
      t35d = (fz0d - t35 * p2d) * p2inv;
      t36 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratio;
      t36d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratio +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratiod;
      t37 = atan(t36);
      c29 = 1.0 / (1.0 + t36 * t36);
      t37d = c29 * t36d;
      re = p3 - t35 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio);
      red = p3d - (t35d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio) + t35 *
          (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37d +
          (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratiod)));
      /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
      if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW])) {
        y = vx;
        yd = vxd;
      } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW])) {
        y = -vx;
        yd = -vxd;
      } else {
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW];
        p4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW];
        t38 = vx * vx / p4;
        p4inv = 1.0 / p4;
        t38d = (vxd * vx + vx * vxd - t38 * p4d) * p4inv;
        y = 0.5 * (p4 + t38);
        yd = 0.5 * (p4d + t38d);
      }
      speed2 = y;
      speed2d = yd;
      kappa = (omega * re - vx) / speed2;
      speed2inv = 1.0 / speed2;
      kappad = (omegad * re + omega * red - vxd - kappa * speed2d) * speed2inv;
      a2 = (v20 * L0 + v21 * L1 + v22 * L2) / speed2;
      a2d = (v20d * L0 + v20 * L0d + (v21d * L1 + v21 * L1d) + (v22d * L2 + v22 * L2d) - a2 *
          speed2d) * speed2inv;
      gamma = atan2(z21, z22);
      c30 = z22 / (z22 * z22 + z21 * z21);
      c31 = -(z21 / (z22 * z22 + z21 * z21));
      gammad = c30 * z21d + c31 * z22d;
      if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z20) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
          MAGGI_TYRE_UNLOADED_RADIUS])) {
        one0 = kappa;
        one0d = kappad;
        one1 = side * a2;
        one1d = side * a2d;
        one2 = side * gamma;
        one2d = side * gammad;
        one3 = fz;
        one3d = fzd;
        one4 = vx;
        one4d = vxd;
        if (t->wheelgrip[n2]) {
          kappa2 = one0;
          kappa2d = one0d;
          a3 = one1;
          a3d = one1d;
          gamma2 = one2;
          gamma2d = one2d;
          fz2 = one3;
          fz2d = one3d;
          fz0_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          fz0_2d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[n2]]];
          r0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          r0d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          dfz = (fz2 - fz0_2) / fz0_2;
          fz0_2inv = 1.0 / fz0_2;
          dfzd = (fz2d - fz0_2d - dfz * fz0_2d) * fz0_2inv;
          kx = kappa2 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
          /* Fx0, Kx */
          kxd = kappa2d + ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX]);
          gx = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
          gxd = gamma2d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] + gamma2 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
          cx = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LCX];
          cxd = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX];
          mux = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] *
              gx * gx) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          muxd = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfzd)) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx) -
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gxd) * gx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gxd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          dx = mux * fz2;
          dxd = muxd * fz2 + mux * fz2d;
          e3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz *
              dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
          e3d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
          if (MAGGI_RE(kx) > 0.0) {
            e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            e4d = e3d * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) - e3 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e4) > 1.0) {
              y3 = 1.0;
              y3d = 0.0;
            } else {
              y3 = e4;
              y3d = e4d;
            }
            ex = y3;
            exd = y3d;
          } else {
            e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            e5d = e3d * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]) + e3 *
                pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4];
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e5) > 1.0) {
              y4 = 1.0;
              y4d = 0.0;
            } else {
              y4 = e5;
              y4d = e5d;
            }
            ex = y4;
            exd = y4d;
          }
          t39 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
          t39d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfzd;
          t40 = exp(t39);
          t40d = t40 * t39d;
          stiff = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t40 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          stiffd = ((fz2d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfzd)))
              * t40 + fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t40d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) * t40 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          t41 = cx * dx;
          t41d = cxd * dx + cx * dxd;
          bx = stiff / t41;
          t41inv = 1.0 / t41;
          bxd = (stiffd - bx * t41d) * t41inv;
          svx = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUX];
          svxd = ((fz2d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfzd)))
              * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          y5 = bx * kx;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y5d = bxd * kx + bx * kxd;
          t42 = atan(y5);
          c32 = 1.0 / (1.0 + y5 * y5);
          t42d = c32 * y5d;
          t43 = (1.0 - ex) * y5 + ex * t42;
          t43d = -(exd * y5) + (1.0 - ex) * y5d + (exd * t42 + ex * t42d);
          t44 = atan(t43);
          c33 = 1.0 / (1.0 + t43 * t43);
          t44d = c33 * t43d;
          t45 = cx * t44;
          t45d = cxd * t44 + cx * t44d;
          t46 = sin(t45);
          c34 = cos(t45);
          t46d = c34 * t45d;
          x50 = dx * t46 + svx;
          x50d = dxd * t46 + dx * t46d + svxd;
          x51 = stiff;
          x51d = stiffd;
          fz0_3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
          fz0_3d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[n2]]];
          gy = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
          gyd = gamma2d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] + gamma2 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
          shy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] * gy;
          shyd = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] + (pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHY3] * gy + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] * gyd);
          ay = a3 + shy;
          ayd = a3d + shyd;
          cy = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LCY];
          cyd = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY];
          muy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] *
              gy * gy) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          muyd = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfzd)) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy) -
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gyd) * gy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gyd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          dy = muy * fz2;
          dyd = muyd * fz2 + muy * fz2d;
          e6 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
          e6d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
          if (MAGGI_RE(ay) > 0.0) {
            e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            e7d = e6d * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy)) - e6 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gyd));
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e7) > 1.0) {
              y6 = 1.0;
              y6d = 0.0;
            } else {
              y6 = e7;
              y6d = e7d;
            }
            ey = y6;
            eyd = y6d;
          } else {
            e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            e8d = e6d * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy)) + e6 *
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gyd));
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e8) > 1.0) {
              y7 = 1.0;
              y7d = 0.0;
            } else {
              y7 = e8;
              y7d = e8d;
            }
            ey = y7;
            eyd = y7d;
          }
          t47 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3;
          t47d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3d;
          z4 = fz2 / t47;
          t47inv = 1.0 / t47;
          z4d = (fz2d - z4 * t47d) * t47inv;
          /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
           * where straight running is, and exact from w on */
          if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            y8 = gy;
            y8d = gyd;
          } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            y8 = -gy;
            y8d = -gyd;
          } else {
            p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            p5d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t48 = p5 * p5;
            t48d = p5d * p5 + p5 * p5d;
            z5 = gy * gy / t48;
            t48inv = 1.0 / t48;
            z5d = (gyd * gy + gy * gyd - z5 * t48d) * t48inv;
            y8 = 0.125 * p5 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
            y8d = (0.125 * p5d * z5 + 0.125 * p5 * z5d) * (15.0 + z5 * (-10.0 + 3.0 * z5)) + 0.125 *
                p5 * z5 * (z5d * (-10.0 + 3.0 * z5) + z5 * (3.0 * z5d));
          }
          t49 = 1.0 + z4 * z4;
          t49d = z4d * z4 + z4 * z4d;
          t50 = 2.0 * z4 / t49;
          t49inv = 1.0 / t49;
          t50d = (2.0 * z4d - t50 * t49d) * t49inv;
          stiff2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          stiff2d = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3d) * t50 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50d) * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8d)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKY1] * fz0_3 * t50 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKY3] * y8) * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          t51 = cy * dy;
          t51d = cyd * dy + cy * dyd;
          by = stiff2 / t51;
          t51inv = 1.0 / t51;
          byd = (stiff2d - by * t51d) * t51inv;
          svy = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          svyd = (fz2d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) +
              fz2 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfzd)) * gy +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY4] * dfz) * gyd))) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] +
              fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          y9 = by * ay;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y9d = byd * ay + by * ayd;
          t52 = atan(y9);
          c35 = 1.0 / (1.0 + y9 * y9);
          t52d = c35 * y9d;
          t53 = (1.0 - ey) * y9 + ey * t52;
          t53d = -(eyd * y9) + (1.0 - ey) * y9d + (eyd * t52 + ey * t52d);
          t54 = atan(t53);
          c36 = 1.0 / (1.0 + t53 * t53);
          t54d = c36 * t53d;
          t55 = cy * t54;
          t55d = cyd * t54 + cy * t54d;
          t56 = sin(t55);
          c37 = cos(t55);
          t56d = c37 * t55d;
          y20 = dy * t56 + svy;
          y20d = dyd * t56 + dy * t56d + svyd;
          y21 = stiff2;
          y21d = stiff2d;
          y22 = muy;
          y22d = muyd;
          y23 = by * cy;
          y23d = byd * cy + by * cyd;
          t57 = svy / stiff2;
          stiff2inv = 1.0 / stiff2;
          t57d = (svyd - t57 * stiff2d) * stiff2inv;
          y24 = shy + t57;
          y24d = shyd + t57d;
          muy2 = y22;
          muy2d = y22d;
          x6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
          x6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBY2] * (a3d - pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          t58 = 1.0 + x6 * x6;
          t58d = x6d * x6 + x6 * x6d;
          t59 = sqrt(t58);
          c38 = 1.0 / (2.0 * t59);
          t59d = c38 * t58d;
          t60 = 1.0 / t59;
          t59inv = 1.0 / t59;
          t60d = -(t60 * t59d * t59inv);
          stiff3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          stiff3d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBY1] * t60 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          e10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_REY2] * dfz;
          e10d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] * dfzd);
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e10) > 1.0) {
            y10 = 1.0;
            y10d = 0.0;
          } else {
            y10 = e10;
            y10d = e10d;
          }
          e9 = y10;
          e9d = y10d;
          s4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RHY2] * dfz;
          s4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] * dfzd);
          x7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] * a3;
          x7d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] * a3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] * a3d;
          t61 = 1.0 + x7 * x7;
          t61d = x7d * x7 + x7 * x7d;
          t62 = sqrt(t61);
          c39 = 1.0 / (2.0 * t62);
          t62d = c39 * t61d;
          t63 = 1.0 / t62;
          t62inv = 1.0 / t62;
          t63d = -(t63 * t62d * t62inv);
          dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) * t63;
          dvd = ((muy2d * fz2 + muy2 * fz2d) * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) + muy2 * fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfzd) +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2d))) * t63 + muy2 * fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) *
              t63d;
          y11 = stiff3 * (kappa2 + s4);
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y11d = stiff3d * (kappa2 + s4) + stiff3 * (kappa2d + s4d);
          y12 = stiff3 * s4;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y12d = stiff3d * s4 + stiff3 * s4d;
          t64 = atan(y11);
          c40 = 1.0 / (1.0 + y11 * y11);
          t64d = c40 * y11d;
          t65 = (1.0 - e9) * y11 + e9 * t64;
          t65d = -(e9d * y11) + (1.0 - e9) * y11d + (e9d * t64 + e9 * t64d);
          t66 = atan(t65);
          c41 = 1.0 / (1.0 + t65 * t65);
          t66d = c41 * t65d;
          p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
          p6d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
          t67 = p6 * t66;
          t67d = p6d * t66 + p6 * t66d;
          t68 = cos(t67);
          c42 = -sin(t67);
          t68d = c42 * t67d;
          t69 = atan(y12);
          c43 = 1.0 / (1.0 + y12 * y12);
          t69d = c43 * y12d;
          t70 = (1.0 - e9) * y12 + e9 * t69;
          t70d = -(e9d * y12) + (1.0 - e9) * y12d + (e9d * t69 + e9 * t69d);
          t71 = atan(t70);
          c44 = 1.0 / (1.0 + t70 * t70);
          t71d = c44 * t70d;
          t72 = p6 * t71;
          t72d = p6d * t71 + p6 * t71d;
          t73 = cos(t72);
          c45 = -sin(t72);
          t73d = c45 * t72d;
          g30 = t68 / t73;
          t73inv = 1.0 / t73;
          g30d = (t68d - g30 * t73d) * t73inv;
          t74 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2;
          t74d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2d;
          t75 = atan(t74);
          c46 = 1.0 / (1.0 + t74 * t74);
          t75d = c46 * t74d;
          t76 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t75;
          t76d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t75 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t75d;
          t77 = sin(t76);
          c47 = cos(t76);
          t77d = c47 * t76d;
          g31 = dv * t77 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          g31d = (dvd * t77 + dv * t77d) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] + dv *
              t77 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          x8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2;
          /* Gxa = Fx / Fx0 */
          x8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2d;
          t78 = 1.0 + x8 * x8;
          t78d = x8d * x8 + x8 * x8d;
          t79 = sqrt(t78);
          c48 = 1.0 / (2.0 * t79);
          t79d = c48 * t78d;
          t80 = 1.0 / t79;
          t79inv = 1.0 / t79;
          t80d = -(t80 * t79d * t79inv);
          stiff4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          stiff4d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RBX1] * t80 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          e12 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_REX2] * dfz;
          e12d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] * dfzd);
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e12) > 1.0) {
            y13 = 1.0;
            y13d = 0.0;
          } else {
            y13 = e12;
            y13d = e12d;
          }
          e11 = y13;
          e11d = y13d;
          p7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
          p7d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
          y14 = stiff4 * (a3 + p7);
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y14d = stiff4d * (a3 + p7) + stiff4 * (a3d + p7d);
          y15 = stiff4 * p7;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y15d = stiff4d * p7 + stiff4 * p7d;
          t81 = atan(y14);
          c49 = 1.0 / (1.0 + y14 * y14);
          t81d = c49 * y14d;
          t82 = (1.0 - e11) * y14 + e11 * t81;
          t82d = -(e11d * y14) + (1.0 - e11) * y14d + (e11d * t81 + e11 * t81d);
          t83 = atan(t82);
          c50 = 1.0 / (1.0 + t82 * t82);
          t83d = c50 * t82d;
          p8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
          p8d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
          t84 = p8 * t83;
          t84d = p8d * t83 + p8 * t83d;
          t85 = cos(t84);
          c51 = -sin(t84);
          t85d = c51 * t84d;
          t86 = atan(y15);
          c52 = 1.0 / (1.0 + y15 * y15);
          t86d = c52 * y15d;
          t87 = (1.0 - e11) * y15 + e11 * t86;
          t87d = -(e11d * y15) + (1.0 - e11) * y15d + (e11d * t86 + e11 * t86d);
          t88 = atan(t87);
          c53 = 1.0 / (1.0 + t87 * t87);
          t88d = c53 * t87d;
          t89 = p8 * t88;
          t89d = p8d * t88 + p8 * t88d;
          t90 = cos(t89);
          c54 = -sin(t89);
          t90d = c54 * t89d;
          t91 = t85 / t90;
          t90inv = 1.0 / t90;
          t91d = (t85d - t91 * t90d) * t90inv;
          fx = x50 * t91;
          fxd = x50d * t91 + x50 * t91d;
          fy = g30 * y20 + g31;
          fyd = g30d * y20 + g30 * y20d + g31d;
          ratio2 = x51 * kappa2 / y21;
          y21inv = 1.0 / y21;
          ratio2d = (x51d * kappa2 + x51 * kappa2d - ratio2 * y21d) * y21inv;
          bycy = y23;
          bycyd = y23d;
          shift = y24;
          shiftd = y24d;
          fz0_4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
           *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
          fz0_4d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[n2]]];
          gz = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ];
          gzd = gamma2d * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ] + gamma2 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ];
          at = a3 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] * dfz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QHZ4] * dfz) * gz;
          atd = a3d + pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] * dfzd)) * gz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QHZ4] * dfz) * gzd);
          ar = a3 + shift;
          ard = a3d + shiftd;
          t92 = at * at + ratio2 * ratio2 + 1e-24;
          t92d = atd * at + at * atd + (ratio2d * ratio2 + ratio2 * ratio2d);
          ateq = sqrt(t92);
          c55 = 1.0 / (2.0 * ateq);
          ateqd = c55 * t92d;
          t93 = ar * ar + ratio2 * ratio2 + 1e-24;
          t93d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
          areq = sqrt(t93);
          c56 = 1.0 / (2.0 * areq);
          areqd = c56 * t93d;
          /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
           * where straight running is, and exact from w on */
          if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            y16 = gz;
            y16d = gzd;
          } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            y16 = -gz;
            y16d = -gzd;
          } else {
            p9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            p9d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t94 = p9 * p9;
            t94d = p9d * p9 + p9 * p9d;
            z6 = gz * gz / t94;
            t94inv = 1.0 / t94;
            z6d = (gzd * gz + gz * gzd - z6 * t94d) * t94inv;
            y16 = 0.125 * p9 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
            y16d = (0.125 * p9d * z6 + 0.125 * p9 * z6d) * (15.0 + z6 * (-10.0 + 3.0 * z6)) + 0.125
                * p9 * z6 * (z6d * (-10.0 + 3.0 * z6) + z6 * (3.0 * z6d));
          }
          bt = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUY];
          inv = 1.0 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          btd = (((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfzd)) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gzd +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16d))) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] - bt *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY]) * inv;
          t95 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
          fz0_4inv = 1.0 / fz0_4;
          t95d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] - t95 * fz0_4d) *
              fz0_4inv;
          dt = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          dtd = (((fz2d * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfzd)))
              * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gzd +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gzd) * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gzd))) * t95 + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] + fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          t96 = bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * at;
          t96d = (btd * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] + bt *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1]) * at + bt *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * atd;
          t97 = atan(t96);
          c57 = 1.0 / (1.0 + t96 * t96);
          t97d = c57 * t96d;
          e13 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
              dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t97);
          e13d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfzd) +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfzd) * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfzd)) * (1.0 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t97) +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
              dfz) * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gzd)) * 0.63661977236758134308 *
              t97 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t97d);
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e13) > 1.0) {
            y17 = 1.0;
            y17d = 0.0;
          } else {
            y17 = e13;
            y17d = e13d;
          }
          et = y17;
          etd = y17d;
          p10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          p10d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          t98 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LKY] / p10;
          p10inv = 1.0 / p10;
          t98d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ9] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] - t98 * p10d) *
              p10inv;
          br = t98 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycy;
          brd = t98d + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycyd);
          dr = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] * p10;
          drd = ((fz2d * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) +
              fz2 * ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfzd)) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gzd))) * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_UNLOADED_RADIUS] + fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS]) * p10 + fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_UNLOADED_RADIUS] * p10d;
          t99 = 1.0 + a3 * a3;
          t99d = a3d * a3 + a3 * a3d;
          t100 = sqrt(t99);
          c58 = 1.0 / (2.0 * t100);
          t100d = c58 * t99d;
          ca = 1.0 / t100;
          t100inv = 1.0 / t100;
          cad = -(ca * t100d * t100inv);
          y18 = bt * ateq;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y18d = btd * ateq + bt * ateqd;
          t101 = atan(y18);
          c59 = 1.0 / (1.0 + y18 * y18);
          t101d = c59 * y18d;
          t102 = (1.0 - et) * y18 + et * t101;
          t102d = -(etd * y18) + (1.0 - et) * y18d + (etd * t101 + et * t101d);
          t103 = atan(t102);
          c60 = 1.0 / (1.0 + t102 * t102);
          t103d = c60 * t102d;
          t104 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t103;
          t104d = pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t103 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t103d;
          t105 = cos(t104);
          c61 = -sin(t104);
          t105d = c61 * t104d;
          z30 = dt * t105 * ca;
          z30d = (dtd * t105 + dt * t105d) * ca + dt * t105 * cad;
          x9 = br * areq;
          x9d = brd * areq + br * areqd;
          t106 = 1.0 + x9 * x9;
          t106d = x9d * x9 + x9 * x9d;
          t107 = sqrt(t106);
          c62 = 1.0 / (2.0 * t107);
          t107d = c62 * t106d;
          t108 = 1.0 / t107;
          t107inv = 1.0 / t107;
          t108d = -(t108 * t107d * t107inv);
          z31d = (drd * t108 + dr * t108d) * ca + dr * t108 * cad;
          t109 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
          t109d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fyd - t109 * fz0_2d) * fz0_2inv;
          s3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t109 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LS];
          s3d = ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t109d +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfzd)) * gamma2 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2d)) * r0 + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t109 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ1] + t109 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 *
              pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS];
          t110 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          inv2 = 1.0 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          t110d = (one4d - t110 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED]) * inv2;
          way = tanh(t110);
          wayd = (1.0 - way * way) * t110d;
          speed3 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          inv3 = 1.0 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          speed3d = (one4d - speed3 * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL]) * inv3;
          force0d = fxd;
          force1d = fyd;
          force2d = fz2d;
          t111 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
          t111d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fy +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fyd - t111 * fz0_2d) * fz0_2inv;
          force3d = (r0d * fz2 + r0 * fz2d) * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX2] * gamma2 + t111) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX])
              + r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX1] * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] +
              ((-(pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2) -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2d + t111d) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX2] * gamma2 + t111) * pd[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMX]));
          t112 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
          t112d = (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fx +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fxd - t112 * fz0_2d) * fz0_2inv;
          force4d = (((-(wayd * r0) - way * r0d) * fz2 + -way * r0 * fz2d) *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3)
              + -way * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112d +
              ((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3d) +
              ((((pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) *
              speed3 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3
              * speed3d))) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY] + -way * r0 * fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3)
              * pd[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY];
          force5d = -(z30d * (fy - g31)) - z30 * (fyd - g31d) + z31d + (s3d * fx + s3 * fxd);
          rolling0d = force0d;
          rolling1d = side * force1d;
          rolling2d = force2d;
          rolling3d = side * force3d;
          rolling4d = force4d;
          rolling5d = side * force5d;
        } else {
          rolling0d = 0.0;
          rolling1d = 0.0;
          rolling2d = fzd;
          rolling3d = 0.0;
          rolling4d = 0.0;
          rolling5d = 0.0;
        }
      } else {
        rolling0d = 0.0;
        rolling1d = 0.0;
        rolling2d = 0.0;
        rolling3d = 0.0;
        rolling4d = 0.0;
        rolling5d = 0.0;
      }
      slip0d = kappad;
      slip1 = a2;
      slip1d = a2d;
      slip2d = gammad;
      if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_SLIP) {
        sd[i][0] = slip0d;
        c63 = 1.0 / (1.0 + slip1 * slip1);
        sd[i][1] = c63 * slip1d;
        sd[i][2] = slip2d;
      } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_FORCE) {
        sd[i][0] = rolling0d;
        sd[i][1] = rolling1d;
        sd[i][2] = rolling2d;
      } else {
        sd[i][0] = rolling3d;
        sd[i][1] = rolling4d;
        sd[i][2] = rolling5d;
      }
    }
  }
}
