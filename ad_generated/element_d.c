/* Tangent of core/kernel/element.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

void maggi_element_forces_d(const maggi_topo *t, const double p[restrict t->np],
                            const double pd[restrict t->np], const double fun[restrict t->nfun][3],
                            const double fund[restrict t->nfun][3],
                            const double spring0[restrict t->nspring],
                            const double spring0d[restrict t->nspring],
                            const double q[restrict t->nq], const double qd[restrict t->nq],
                            const double v[restrict t->nq], const double vd[restrict t->nq],
                            const double A[restrict t->nbody + 1][9],
                            const double Ad[restrict t->nbody + 1][9],
                            const double Z[restrict t->nbody + 1][6],
                            const double Zd[restrict t->nbody + 1][6],
                            const double r[restrict t->npoint][3],
                            const double rd[restrict t->npoint][3],
                            const double rv[restrict t->npoint][3],
                            const double rvd[restrict t->npoint][3],
                            double Q[restrict t->nbody + 1][6], double Qd[restrict t->nbody + 1][6],
                            double tau[restrict t->nq], double taud[restrict t->nq],
                            double power[restrict 1])
{
  int a, a4, a5, a5_2, a6, adr, adr2, b, b2, b3, b4, i, k, k11, k2;
  double L0, L0d, L1, L1d, L2, L2d, N0, N0d, N1, N2, N2d, T0, T0d, T1, T1d, T2, T2d, Z_b43, Z_b43d,
      Z_b44, Z_b44d, Z_b45, Z_b45d, a00, a00d, a01, a01d, a02, a02d, a2, a2d, a3, a3d, along0,
      along0d, along1, along1d, along2, along2d, ar, ard, areq, areqd, arm0, arm0d, arm1, arm1d,
      arm2, arm2d, at, atd, ateq, ateqd, ay, ayd, back0, back0d, back1, back1d, back20, back20d,
      back21, back21d, back22, back22d, back2_2, back2_2d, br, brd, bt, btd, bx, bxd, by, bycy,
      bycyd, byd, c, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c20d, c21, c21d, c22,
      c22d, c23, c24, c25, c26, c27, c28, c29, c3, c30, c31, c32, c33, c34, c35, c36, c37, c38, c39,
      c3d, c4, c40, c41, c42, c43, c44, c45, c46, c47, c48, c5, c6, c7, c8, c9, ca, cad, cd, cx,
      cxd, cy, cyd, damping, dampingd, dfz, dfzd, dr, drd, dt, dtd, dv, dvd, dx, dxd, dy, dyd, e0,
      e0d, e1, e10, e10d, e11, e11d, e12, e12d, e1d, e2, e2_2, e2_2d, e2d, e3, e3d, e4, e4d, e5,
      e5d, e6, e6d, e7, e7d, e8, e8d, e9, e9d, et, etd, ev0, ev0d, ev1, ev1d, ev2, ev2d, ex, exd,
      ey, eyd, f0, f0d, f1, f1d, f2, f2d, f3, f3d, force0, force0d, force1, force1d, force20,
      force20d, force21, force21d, force22, force22d, force23, force23d, force24, force24d, force25,
      force25d, force2_2, force2_2d, force30, force30d, force31, force31d, force32, force32d, fx,
      fxd, fy, fyd, fz, fz0, fz0_2, fz0_2d, fz0_2inv, fz0_3, fz0_3d, fz0_4, fz0_4d, fz0_4inv, fz0d,
      fz0inv, fz2, fz2d, fzd, g0, g0d, g1, g1d, g20, g20d, g22, g22d, g2_2, g2_2d, g30, g30d, g31,
      g31d, gamma, gamma2, gamma2d, gammad, gx, gxd, gy, gyd, gz, gzd, h00, h00d, h10, h10d, h11,
      h11d, inv, inv2, inv3, kappa, kappa2, kappa2d, kappad, kx, kxd, l, ld, linv, lv, lvd,
      moment0d, moment1d, moment2d, mux, muxd, muy, muy2, muy2d, muyd, n20, n20d, n21, n21d, n22,
      n22d, n3, n3d, n3inv, n40, n40d, n41, n42, n42d, omega, omegad, one0, one0d, one1, one1d,
      one2, one2d, one3, one3d, one4, one4d, p10, p10d, p11, p11d, p11inv, p2, p2d, p3, p3d, p3inv,
      p4, p4d, p5, p5d, p5inv, p6, p6d, p7, p7d, p8, p8d, p9, p9d, p_adr2, p_adr2d, p_k11, p_k111,
      p_k111_2, p_k111_2d, p_k111_2inv, p_k111d, p_k111inv, p_k11_2, p_k11_2d, p_k11_3, p_k11_3d,
      p_k11_4, p_k11_4d, p_k11d, p_k24, p_k24d, p_k25, p_k25d, r0, r0d, r2, r2d, r30, r30d, r31,
      r31d, r32, r32d, r_a0, r_a0d, r_a1, r_a1d, r_a2, r_a2d, r_b0, r_b0d, r_b1, r_b1d, r_b2, r_b2d,
      r_i0, r_i0d, r_i1, r_i1d, r_i2, r_i2d, ratio, ratio2, ratio2d, ratiod, re, red, rhov, rhovd,
      rolling0, rolling0d, rolling1, rolling1d, rolling2, rolling2d, rolling3, rolling3d, rolling4,
      rolling4d, rolling5, rolling5d, s, s2, s2d, s2inv, s3, s3d, s4, s4d, sd, shift, shiftd, shy,
      shyd, side, speed, speed2, speed2d, speed2inv, speed3, speed3d, speedd, stiff, stiff2,
      stiff2d, stiff2inv, stiff3, stiff3d, stiff4, stiff4d, stiffd, svx, svxd, svy, svyd, t10, t10d,
      t11, t11d, t12, t12d, t13, t13d, t14, t14d, t15, t15d, t16, t16d, t17, t17d, t18, t18d, t19,
      t19d, t2, t20, t20d, t21, t21d, t22, t22d, t22inv, t23, t23d, t24, t24d, t25, t25d, t26, t26d,
      t27, t27d, t28, t28d, t28inv, t29, t29d, t29inv, t2d, t3, t30, t30d, t30inv, t31, t31d, t32,
      t32d, t32inv, t33, t33d, t34, t34d, t35, t35d, t36, t36d, t37, t37d, t38, t38d, t39, t39d,
      t3d, t4, t40, t40d, t40inv, t41, t41d, t42, t42d, t43, t43d, t43inv, t44, t44d, t45, t45d,
      t46, t46d, t47, t47d, t48, t48d, t49, t49d, t4d, t5, t50, t50d, t51, t51d, t52, t52d, t53,
      t53d, t54, t54d, t54inv, t55, t55d, t56, t56d, t57, t57d, t58, t58d, t59, t59d, t5d, t6, t60,
      t60d, t60inv, t61, t61d, t62, t62d, t63, t63d, t64, t64d, t65, t65d, t66, t66d, t67, t67d,
      t68, t68d, t69, t69d, t6d, t7, t70, t70d, t71, t71d, t71inv, t72, t72d, t73, t73d, t74, t74d,
      t75, t75d, t75inv, t76, t76d, t77, t77d, t78, t78d, t79, t79d, t7d, t7inv, t8, t80, t80d, t81,
      t81d, t81inv, t82, t82d, t83, t83d, t84, t84d, t85, t85d, t86, t86d, t87, t87d, t88, t88d,
      t88inv, t89, t89d, t8d, t9, t90, t90d, t91, t91d, t92, t92d, t93, t93d, t9d, torque0d, u0,
      u0d, u1, u1d, u20, u20d, u21, u21d, u22, u22d, u2_2, u2_2d, u30, u30d, u31, u31d, u32, u32d,
      ua0, ua0d, ua1, ua1d, ua2, ua2d, un0, un0d, un1, un1d, un2, un2d, v40, v40d, v41, v41d, v42,
      v42d, vr0, vr0d, vr1, vr1d, vr2, vr2d, vx, vxd, w, way, wayd, wd, winv, wr0, wr0d, wr1, wr1d,
      wr2, wr2d, x, x2, x2d, x3, x3d, x40, x40d, x41, x41d, x5, x5d, x6, x6d, x7, x7d, x8, x8d, xd,
      xv, xvd, y, y10, y10d, y11, y11d, y12, y12d, y13, y13d, y14, y14d, y15, y15d, y16, y16d, y17,
      y17d, y18, y18d, y20, y20d, y21, y21d, y21inv, y22, y22d, y23, y23d, y24, y24d, y3, y3d, y4,
      y4d, y5, y5d, y6, y6d, y7, y7d, y8, y8d, y9, y9d, yd, z20, z20d, z21, z21d, z22, z22d, z22inv,
      z30, z30d, z31, z31d, z4, z4d, z5, z5d, z6, z6d;

  (void)Q;
  (void)tau;
  (void)power;
  for (i = 0; i <= t->nbody; ++i) {
    for (k = 0; k < 6; ++k) {
      Qd[i][k] = 0.0;
    }
  }
  for (i = 0; i < t->nq; ++i) {
    taud[i] = 0.0;
  }
  for (i = 0; i < t->nspring; ++i) {
    a = t->springpa[i];
    b = t->springpb[i];
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
    ev2 = rv[a][2] - rv[b][2];
    ev2d = rvd[a][2] - rvd[b][2];
    t2 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
    t2d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
    l = sqrt(t2);
    c4 = 1.0 / (2.0 * l);
    ld = c4 * t2d;
    n20 = e0 / l;
    linv = 1.0 / l;
    n20d = (e0d - n20 * ld) * linv;
    n21 = e1 / l;
    n21d = (e1d - n21 * ld) * linv;
    n22 = e2_2 / l;
    n22d = (e2_2d - n22 * ld) * linv;
    lv = n20 * ev0 + n21 * ev1 + n22 * ev2;
    lvd = n20d * ev0 + n20 * ev0d + (n21d * ev1 + n21 * ev1d) + (n22d * ev2 + n22 * ev2d);
    damping = p[t->springadr[i] + MAGGI_SPRING_C] * lv;
    dampingd = pd[t->springadr[i] + MAGGI_SPRING_C] * lv + p[t->springadr[i] + MAGGI_SPRING_C] *
        lvd;
    if (t->springpreload[i]) {
      f0 = p[t->springadr[i]] * (l - spring0[i]) + p[t->springadr[i] + MAGGI_SPRING_L];
      f0d = pd[t->springadr[i]] * (l - spring0[i]) + p[t->springadr[i]] * (ld - spring0d[i]) +
          pd[t->springadr[i] + MAGGI_SPRING_L];
    } else {
      f0 = p[t->springadr[i]] * (l - p[t->springadr[i] + MAGGI_SPRING_L]);
      f0d = pd[t->springadr[i]] * (l - p[t->springadr[i] + MAGGI_SPRING_L]) + p[t->springadr[i]] *
          (ld - pd[t->springadr[i] + MAGGI_SPRING_L]);
    }
    k2 = t->springadr[i] + MAGGI_SPRING_SLOPES;
    if (t->springslopes[i]) {
      /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
      if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
        p_k24 = p[k2 + 4];
        p_k24d = pd[k2 + 4];
        f2 = p[k2] * p_k24 + p[k2 + 1] * (lv - p_k24);
        f2d = pd[k2] * p_k24 + p[k2] * p_k24d + (pd[k2 + 1] * (lv - p_k24) + p[k2 + 1] * (lvd -
            p_k24d));
      } else if (MAGGI_RE(lv) > 0.0) {
        f2 = p[k2] * lv;
        f2d = pd[k2] * lv + p[k2] * lvd;
      } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
        f2 = p[k2 + 2] * lv;
        f2d = pd[k2 + 2] * lv + p[k2 + 2] * lvd;
      } else {
        p_k25 = p[k2 + 5];
        p_k25d = pd[k2 + 5];
        f2 = p[k2 + 2] * p_k25 + p[k2 + 3] * (lv - p_k25);
        f2d = pd[k2 + 2] * p_k25 + p[k2 + 2] * p_k25d + (pd[k2 + 3] * (lv - p_k25) + p[k2 + 3] *
            (lvd - p_k25d));
      }
      f1 = damping + f2;
      f1d = dampingd + f2d;
    } else {
      f1 = damping;
      f1d = dampingd;
    }
    u0 = n20;
    u0d = n20d;
    u1 = n21;
    u1d = n21d;
    u2_2 = n22;
    u2_2d = n22d;
    f3 = f0 + f1;
    f3d = f0d + f1d;
    force0 = f3 * u0;
    force0d = f3d * u0 + f3 * u0d;
    back0 = -f3 * u0;
    back0d = -(f3d * u0) - f3 * u0d;
    force1 = f3 * u1;
    force1d = f3d * u1 + f3 * u1d;
    back1 = -f3 * u1;
    back1d = -(f3d * u1) - f3 * u1d;
    force2_2 = f3 * u2_2;
    force2_2d = f3d * u2_2 + f3 * u2_2d;
    back2_2 = -f3 * u2_2;
    back2_2d = -(f3d * u2_2) - f3 * u2_2d;
    Qd[t->pointbody[a]][0] += back0d;
    Qd[t->pointbody[a]][1] += back1d;
    Qd[t->pointbody[a]][2] += back2_2d;
    r_a1 = r[a][1];
    r_a1d = rd[a][1];
    r_a2 = r[a][2];
    r_a2d = rd[a][2];
    Qd[t->pointbody[a]][3] += r_a1d * back2_2 + r_a1 * back2_2d - (r_a2d * back1 + r_a2 * back1d);
    r_a0 = r[a][0];
    r_a0d = rd[a][0];
    Qd[t->pointbody[a]][4] += r_a2d * back0 + r_a2 * back0d - (r_a0d * back2_2 + r_a0 * back2_2d);
    Qd[t->pointbody[a]][5] += r_a0d * back1 + r_a0 * back1d - (r_a1d * back0 + r_a1 * back0d);
    Qd[t->pointbody[b]][0] += force0d;
    Qd[t->pointbody[b]][1] += force1d;
    Qd[t->pointbody[b]][2] += force2_2d;
    r_b1 = r[b][1];
    r_b1d = rd[b][1];
    r_b2 = r[b][2];
    r_b2d = rd[b][2];
    Qd[t->pointbody[b]][3] += r_b1d * force2_2 + r_b1 * force2_2d - (r_b2d * force1 + r_b2 *
        force1d);
    r_b0 = r[b][0];
    r_b0d = rd[b][0];
    Qd[t->pointbody[b]][4] += r_b2d * force0 + r_b2 * force0d - (r_b0d * force2_2 + r_b0 *
        force2_2d);
    Qd[t->pointbody[b]][5] += r_b0d * force1 + r_b0 * force1d - (r_b1d * force0 + r_b1 * force0d);
  }
  for (i = 0; i < t->njspring; ++i) {
    a4 = t->jspringq[i];
    b2 = t->jspringq2[i];
    adr = t->jspringadr[i];
    if (b2 >= 0) {
      x = q[a4] - q[b2];
      xd = qd[a4] - qd[b2];
      xv = v[a4] - v[b2];
      xvd = vd[a4] - vd[b2];
    } else {
      x = q[a4];
      xd = qd[a4];
      xv = v[a4];
      xvd = vd[a4];
    }
    torque0d = -(pd[adr] * (x - p[adr + MAGGI_JSPRING_REST])) - p[adr] * (xd - pd[adr +
        MAGGI_JSPRING_REST]) - (pd[adr + MAGGI_JSPRING_C] * xv + p[adr + MAGGI_JSPRING_C] * xvd) -
        pd[adr + MAGGI_JSPRING_PRELOAD];
    taud[a4] += torque0d;
    if (b2 >= 0) {
      taud[b2] -= torque0d;
    }
  }
  for (i = 0; i < t->nforce; ++i) {
    adr2 = t->forceadr[i];
    if (t->forcefun[i] >= 0) {
      s = fun[t->forcefun[i]][0];
      sd = fund[t->forcefun[i]][0];
    } else {
      s = 1.0;
      sd = 0.0;
    }
    if (t->forcekind[i] == MAGGI_FORCE_JOINT) {
      a5 = t->forceq[i];
      p_adr2 = p[adr2];
      p_adr2d = pd[adr2];
      taud[a5] += p_adr2d * s + p_adr2 * sd;
    } else {
      a5_2 = t->forcebody[i];
      b3 = t->forcereaction[i];
      if (t->forcekind[i] == MAGGI_FORCE_DRAG) {
        u20 = rv[t->forcepoint[i]][0] - p[adr2 + MAGGI_DRAG_WIND];
        /* - rho/2 c A |u| u,  u = v - wind,  |u| = sqrt(u.u + low^2) */
        u20d = rvd[t->forcepoint[i]][0] - pd[adr2 + MAGGI_DRAG_WIND];
        u21 = rv[t->forcepoint[i]][1] - p[adr2 + MAGGI_DRAG_WIND + 1];
        u21d = rvd[t->forcepoint[i]][1] - pd[adr2 + MAGGI_DRAG_WIND + 1];
        u22 = rv[t->forcepoint[i]][2] - p[adr2 + MAGGI_DRAG_WIND + 2];
        u22d = rvd[t->forcepoint[i]][2] - pd[adr2 + MAGGI_DRAG_WIND + 2];
        p2 = p[adr2 + MAGGI_DRAG_LOW];
        p2d = pd[adr2 + MAGGI_DRAG_LOW];
        t3 = u20 * u20 + u21 * u21 + u22 * u22 + p2 * p2;
        t3d = u20d * u20 + u20 * u20d + (u21d * u21 + u21 * u21d) + (u22d * u22 + u22 * u22d) + (p2d
            * p2 + p2 * p2d);
        speed = sqrt(t3);
        c5 = 1.0 / (2.0 * speed);
        speedd = c5 * t3d;
        c = 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * s;
        cd = ((0.5 * pd[adr2] * p[adr2 + MAGGI_DRAG_C] + 0.5 * p[adr2] * pd[adr2 + MAGGI_DRAG_C]) *
            p[adr2 + MAGGI_DRAG_AREA] + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * pd[adr2 +
            MAGGI_DRAG_AREA]) * s + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 +
            MAGGI_DRAG_AREA] * sd;
        g0 = -c * speed * u20;
        g0d = (-(cd * speed) - c * speedd) * u20 + -c * speed * u20d;
        g1 = -c * speed * u21;
        g1d = (-(cd * speed) - c * speedd) * u21 + -c * speed * u21d;
        g2_2 = -c * speed * u22;
        g2_2d = (-(cd * speed) - c * speedd) * u22 + -c * speed * u22d;
      } else {
        c20 = p[adr2] * s;
        c20d = pd[adr2] * s + p[adr2] * sd;
        c21 = p[adr2 + 1] * s;
        c21d = pd[adr2 + 1] * s + p[adr2 + 1] * sd;
        c22 = p[adr2 + 2] * s;
        c22d = pd[adr2 + 2] * s + p[adr2 + 2] * sd;
        if (t->forcekind[i] == MAGGI_FORCE_BODY || t->forcekind[i] == MAGGI_TORQUE_BODY) {
          g0 = A[a5_2][0] * c20 + A[a5_2][1] * c21 + A[a5_2][2] * c22;
          g0d = Ad[a5_2][0] * c20 + A[a5_2][0] * c20d + (Ad[a5_2][1] * c21 + A[a5_2][1] * c21d) +
              (Ad[a5_2][2] * c22 + A[a5_2][2] * c22d);
          g1 = A[a5_2][3] * c20 + A[a5_2][4] * c21 + A[a5_2][5] * c22;
          g1d = Ad[a5_2][3] * c20 + A[a5_2][3] * c20d + (Ad[a5_2][4] * c21 + A[a5_2][4] * c21d) +
              (Ad[a5_2][5] * c22 + A[a5_2][5] * c22d);
          g2_2 = A[a5_2][6] * c20 + A[a5_2][7] * c21 + A[a5_2][8] * c22;
          g2_2d = Ad[a5_2][6] * c20 + A[a5_2][6] * c20d + (Ad[a5_2][7] * c21 + A[a5_2][7] * c21d) +
              (Ad[a5_2][8] * c22 + A[a5_2][8] * c22d);
        } else {
          g0 = c20;
          g0d = c20d;
          g1 = c21;
          g1d = c21d;
          g2_2 = c22;
          g2_2d = c22d;
        }
      }
      if (t->forcepoint[i] >= 0) {
        back20 = -g0;
        /* force at r, or pure torque, on one body and back on another; returns its power */
        back20d = -g0d;
        back21 = -g1;
        back21d = -g1d;
        back22 = -g2_2;
        back22d = -g2_2d;
        Qd[a5_2][0] += g0d;
        Qd[a5_2][1] += g1d;
        Qd[a5_2][2] += g2_2d;
        r_i1 = r[t->forcepoint[i]][1];
        r_i1d = rd[t->forcepoint[i]][1];
        r_i2 = r[t->forcepoint[i]][2];
        r_i2d = rd[t->forcepoint[i]][2];
        Qd[a5_2][3] += r_i1d * g2_2 + r_i1 * g2_2d - (r_i2d * g1 + r_i2 * g1d);
        r_i0 = r[t->forcepoint[i]][0];
        r_i0d = rd[t->forcepoint[i]][0];
        Qd[a5_2][4] += r_i2d * g0 + r_i2 * g0d - (r_i0d * g2_2 + r_i0 * g2_2d);
        Qd[a5_2][5] += r_i0d * g1 + r_i0 * g1d - (r_i1d * g0 + r_i1 * g0d);
        Qd[b3][0] += back20d;
        Qd[b3][1] += back21d;
        Qd[b3][2] += back22d;
        Qd[b3][3] += r_i1d * back22 + r_i1 * back22d - (r_i2d * back21 + r_i2 * back21d);
        Qd[b3][4] += r_i2d * back20 + r_i2 * back20d - (r_i0d * back22 + r_i0 * back22d);
        Qd[b3][5] += r_i0d * back21 + r_i0 * back21d - (r_i1d * back20 + r_i1 * back20d);
      } else {
        /* force at r, or pure torque, on one body and back on another; returns its power */
        Qd[a5_2][3] += g0d;
        Qd[b3][3] -= g0d;
        Qd[a5_2][4] += g1d;
        Qd[b3][4] -= g1d;
        Qd[a5_2][5] += g2_2d;
        Qd[b3][5] -= g2_2d;
      }
    }
  }
  for (i = 0; i < t->nwheel; ++i) {
    a6 = t->wheelbody[i];
    b4 = t->wheelcarrier[i];
    k11 = t->wheelroad[i];
    side = t->wheelmirror[i] ? -1.0 : 1.0;
    a00 = p[t->wheelaxis[i]];
    a00d = pd[t->wheelaxis[i]];
    a01 = p[t->wheelaxis[i] + 1];
    a01d = pd[t->wheelaxis[i] + 1];
    a02 = p[t->wheelaxis[i] + 2];
    a02d = pd[t->wheelaxis[i] + 2];
    ua0 = A[a6][0] * a00 + A[a6][1] * a01 + A[a6][2] * a02;
    ua0d = Ad[a6][0] * a00 + A[a6][0] * a00d + (Ad[a6][1] * a01 + A[a6][1] * a01d) + (Ad[a6][2] *
        a02 + A[a6][2] * a02d);
    ua1 = A[a6][3] * a00 + A[a6][4] * a01 + A[a6][5] * a02;
    ua1d = Ad[a6][3] * a00 + A[a6][3] * a00d + (Ad[a6][4] * a01 + A[a6][4] * a01d) + (Ad[a6][5] *
        a02 + A[a6][5] * a02d);
    ua2 = A[a6][6] * a00 + A[a6][7] * a01 + A[a6][8] * a02;
    ua2d = Ad[a6][6] * a00 + A[a6][6] * a00d + (Ad[a6][7] * a01 + A[a6][7] * a01d) + (Ad[a6][8] *
        a02 + A[a6][8] * a02d);
    t4 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
    t4d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
    n3 = sqrt(t4);
    c6 = 1.0 / (2.0 * n3);
    n3d = c6 * t4d;
    u30 = ua0 / n3;
    n3inv = 1.0 / n3;
    u30d = (ua0d - u30 * n3d) * n3inv;
    u31 = ua1 / n3;
    u31d = (ua1d - u31 * n3d) * n3inv;
    u32 = ua2 / n3;
    u32d = (ua2d - u32 * n3d) * n3inv;
    g20 = r[t->wheelpoint[i]][0] - r[t->roadpoint[k11]][0];
    g20d = rd[t->wheelpoint[i]][0] - rd[t->roadpoint[k11]][0];
    g22 = r[t->wheelpoint[i]][2] - r[t->roadpoint[k11]][2];
    g22d = rd[t->wheelpoint[i]][2] - rd[t->roadpoint[k11]][2];
    x3 = g20;
    /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
     * the centre down the disc meets it, n its normal; then down the disc to that plane,
     *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
     * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
    x3d = g20d;
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11 = p[t->roadadr[k11]];
      p_k11d = pd[t->roadadr[k11]];
      h00 = p_k11 * x3;
      h00d = p_k11d * x3 + p_k11 * x3d;
    } else {
      p_k111 = p[t->roadadr[k11] + 1];
      p_k111d = pd[t->roadadr[k11] + 1];
      t5 = 6.28318530717958647693 * x3 / p_k111;
      p_k111inv = 1.0 / p_k111;
      t5d = (6.28318530717958647693 * x3d - t5 * p_k111d) * p_k111inv;
      t6 = sin(t5);
      c7 = cos(t5);
      t6d = c7 * t5d;
      p_k11_2 = p[t->roadadr[k11]];
      p_k11_2d = pd[t->roadadr[k11]];
      h00 = p_k11_2 * t6;
      h00d = p_k11_2d * t6 + p_k11_2 * t6d;
    }
    t7 = u30 * u30 + u31 * u31;
    t7d = u30d * u30 + u30 * u30d + (u31d * u31 + u31 * u31d);
    t8 = u32 * u30 / t7;
    t7inv = 1.0 / t7;
    t8d = (u32d * u30 + u32 * u30d - t8 * t7d) * t7inv;
    x2 = g20 + t8 * (g22 - h00);
    x2d = g20d + (t8d * (g22 - h00) + t8 * (g22d - h00d));
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11_3 = p[t->roadadr[k11]];
      p_k11_3d = pd[t->roadadr[k11]];
      h10 = p_k11_3 * x2;
      h10d = p_k11_3d * x2 + p_k11_3 * x2d;
      h11 = p_k11_3;
      h11d = p_k11_3d;
    } else {
      p_k111_2 = p[t->roadadr[k11] + 1];
      p_k111_2d = pd[t->roadadr[k11] + 1];
      t9 = 6.28318530717958647693 * x2 / p_k111_2;
      p_k111_2inv = 1.0 / p_k111_2;
      t9d = (6.28318530717958647693 * x2d - t9 * p_k111_2d) * p_k111_2inv;
      t10 = sin(t9);
      c8 = cos(t9);
      t10d = c8 * t9d;
      p_k11_4 = p[t->roadadr[k11]];
      p_k11_4d = pd[t->roadadr[k11]];
      h10 = p_k11_4 * t10;
      h10d = p_k11_4d * t10 + p_k11_4 * t10d;
      t11 = p_k11_4 * 6.28318530717958647693 / p_k111_2;
      t11d = (p_k11_4d * 6.28318530717958647693 - t11 * p_k111_2d) * p_k111_2inv;
      t12 = 6.28318530717958647693 * x2 / p_k111_2;
      t12d = (6.28318530717958647693 * x2d - t12 * p_k111_2d) * p_k111_2inv;
      t13 = cos(t12);
      c9 = -sin(t12);
      t13d = c9 * t12d;
      h11 = t11 * t13;
      h11d = t11d * t13 + t11 * t13d;
    }
    t14 = 1.0 + h11 * h11;
    t14d = h11d * h11 + h11 * h11d;
    s2 = sqrt(t14);
    c10 = 1.0 / (2.0 * s2);
    s2d = c10 * t14d;
    n40 = -h11 / s2;
    s2inv = 1.0 / s2;
    n40d = (-h11d - n40 * s2d) * s2inv;
    n41 = 0.0;
    n42 = 1.0 / s2;
    n42d = -(n42 * s2d * s2inv);
    c3 = u30 * n40 + u31 * n41 + u32 * n42;
    c3d = u30d * n40 + u30 * n40d + u31d * n41 + (u32d * n42 + u32 * n42d);
    un0 = u31 * n42 - u32 * n41;
    un0d = u31d * n42 + u31 * n42d - u32d * n41;
    un1 = u32 * n40 - u30 * n42;
    un1d = u32d * n40 + u32 * n40d - (u30d * n42 + u30 * n42d);
    un2 = u30 * n41 - u31 * n40;
    un2d = u30d * n41 - (u31d * n40 + u31 * n40d);
    t15 = un0 * un0 + un1 * un1 + un2 * un2;
    t15d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
    w = sqrt(t15);
    c11 = 1.0 / (2.0 * w);
    wd = c11 * t15d;
    r2 = ((g20 - x2) * n40 + (g22 - h10) * n42) / w;
    winv = 1.0 / w;
    r2d = ((g20d - x2d) * n40 + (g20 - x2) * n40d + ((g22d - h10d) * n42 + (g22 - h10) * n42d) - r2
        * wd) * winv;
    along0 = un0 / w;
    along0d = (un0d - along0 * wd) * winv;
    along1 = un1 / w;
    along1d = (un1d - along1 * wd) * winv;
    along2 = un2 / w;
    along2d = (un2d - along2 * wd) * winv;
    L0 = n41 * along2 - n42 * along1;
    L0d = n41 * along2d - (n42d * along1 + n42 * along1d);
    L1 = n42 * along0 - n40 * along2;
    L1d = n42d * along0 + n42 * along0d - (n40d * along2 + n40 * along2d);
    L2 = n40 * along1 - n41 * along0;
    L2d = n40d * along1 + n40 * along1d - n41 * along0d;
    arm0 = r2 * (c3 * u30 - n40) / w;
    arm0d = (r2d * (c3 * u30 - n40) + r2 * (c3d * u30 + c3 * u30d - n40d) - arm0 * wd) * winv;
    T0 = along0;
    T0d = along0d;
    N0 = n40;
    N0d = n40d;
    arm1 = r2 * (c3 * u31 - n41) / w;
    arm1d = (r2d * (c3 * u31 - n41) + r2 * (c3d * u31 + c3 * u31d) - arm1 * wd) * winv;
    T1 = along1;
    T1d = along1d;
    N1 = n41;
    arm2 = r2 * (c3 * u32 - n42) / w;
    arm2d = (r2d * (c3 * u32 - n42) + r2 * (c3d * u32 + c3 * u32d - n42d) - arm2 * wd) * winv;
    T2 = along2;
    T2d = along2d;
    N2 = n42;
    N2d = n42d;
    z20 = r2;
    z20d = r2d;
    z21 = c3;
    z21d = c3d;
    z22 = w;
    z22d = wd;
    Z_b43 = Z[b4][3];
    Z_b43d = Zd[b4][3];
    wr0 = Z_b43;
    wr0d = Z_b43d;
    Z_b44 = Z[b4][4];
    Z_b44d = Zd[b4][4];
    wr1 = Z_b44;
    wr1d = Z_b44d;
    Z_b45 = Z[b4][5];
    Z_b45d = Zd[b4][5];
    wr2 = Z_b45;
    wr2d = Z_b45d;
    vr0 = wr1 * arm2 - wr2 * arm1;
    vr0d = wr1d * arm2 + wr1 * arm2d - (wr2d * arm1 + wr2 * arm1d);
    vr1 = wr2 * arm0 - wr0 * arm2;
    vr1d = wr2d * arm0 + wr2 * arm0d - (wr0d * arm2 + wr0 * arm2d);
    vr2 = wr0 * arm1 - wr1 * arm0;
    vr2d = wr0d * arm1 + wr0 * arm1d - (wr1d * arm0 + wr1 * arm0d);
    v40 = rv[t->wheelpoint[i]][0] + vr0;
    v40d = rvd[t->wheelpoint[i]][0] + vr0d;
    v41 = rv[t->wheelpoint[i]][1] + vr1;
    v41d = rvd[t->wheelpoint[i]][1] + vr1d;
    v42 = rv[t->wheelpoint[i]][2] + vr2;
    v42d = rvd[t->wheelpoint[i]][2] + vr2d;
    vx = v40 * T0 + v41 * T1 + v42 * T2;
    vxd = v40d * T0 + v40 * T0d + (v41d * T1 + v41 * T1d) + (v42d * T2 + v42 * T2d);
    rhov = -(v40 * N0 + v41 * N1 + v42 * N2) / z22;
    z22inv = 1.0 / z22;
    rhovd = (-(v40d * N0 + v40 * N0d + v41d * N1 + (v42d * N2 + v42 * N2d)) - rhov * z22d) * z22inv;
    omega = (Z[a6][3] - Z_b43) * u30 + (Z[a6][4] - Z_b44) * u31 + (Z[a6][5] - Z_b45) * u32;
    omegad = (Zd[a6][3] - Z_b43d) * u30 + (Z[a6][3] - Z_b43) * u30d + ((Zd[a6][4] - Z_b44d) * u31 +
        (Z[a6][4] - Z_b44) * u31d) + ((Zd[a6][5] - Z_b45d) * u32 + (Z[a6][5] - Z_b45) * u32d);
    p3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
    p3d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
    p4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
    p4d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
    fz = p3 * (p4 - z20) + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
    fzd = p3d * (p4 - z20) + p3 * (p4d - z20d) + (pd[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_VERTICAL_DAMPING] * rhov + p[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
    fz0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
    fz0d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]] +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
    ratio = fz / fz0;
    fz0inv = 1.0 / fz0;
    ratiod = (fzd - ratio * fz0d) * fz0inv;
    t16 = fz0 / p3;
    p3inv = 1.0 / p3;
    t16d = (fz0d - t16 * p3d) * p3inv;
    t17 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio;
    t17d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratiod;
    t18 = atan(t17);
    c12 = 1.0 / (1.0 + t17 * t17);
    t18d = c12 * t17d;
    re = p4 - t16 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio);
    red = p4d - (t16d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio) + t16 *
        (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 + p[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_DREFF] * t18d + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratiod)));
    /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
    if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y = vx;
      yd = vxd;
    } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y = -vx;
      yd = -vxd;
    } else {
      p5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      p5d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      t19 = vx * vx / p5;
      p5inv = 1.0 / p5;
      t19d = (vxd * vx + vx * vxd - t19 * p5d) * p5inv;
      y = 0.5 * (p5 + t19);
      yd = 0.5 * (p5d + t19d);
    }
    speed2 = y;
    speed2d = yd;
    kappa = (omega * re - vx) / speed2;
    speed2inv = 1.0 / speed2;
    kappad = (omegad * re + omega * red - vxd - kappa * speed2d) * speed2inv;
    a2 = (v40 * L0 + v41 * L1 + v42 * L2) / speed2;
    a2d = (v40d * L0 + v40 * L0d + (v41d * L1 + v41 * L1d) + (v42d * L2 + v42 * L2d) - a2 * speed2d)
        * speed2inv;
    gamma = atan2(z21, z22);
    c13 = z22 / (z22 * z22 + z21 * z21);
    c14 = -(z21 / (z22 * z22 + z21 * z21));
    gammad = c13 * z21d + c14 * z22d;
    if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z20) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] +
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
      if (t->wheelgrip[i]) {
        kappa2 = one0;
        kappa2d = one0d;
        a3 = one1;
        a3d = one1d;
        gamma2 = one2;
        gamma2d = one2d;
        fz2 = one3;
        fz2d = one3d;
        fz0_2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        fz0_2d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        r0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        r0d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        dfz = (fz2 - fz0_2) / fz0_2;
        fz0_2inv = 1.0 / fz0_2;
        dfzd = (fz2d - fz0_2d - dfz * fz0_2d) * fz0_2inv;
        kx = kappa2 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LHX];
        /* Fx0, Kx */
        kxd = kappa2d + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHX2] * dfzd)) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHX2] * dfz) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX]);
        gx = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        gxd = gamma2d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] + gamma2 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        cx = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        cxd = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX];
        mux = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx *
            gx) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        muxd = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfzd)) *
            (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) -
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gxd) * gx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gxd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        dx = mux * fz2;
        dxd = muxd * fz2 + mux * fz2d;
        e2 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        e2d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
        if (MAGGI_RE(kx) > 0.0) {
          e3 = e2 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e3d = e2d * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) - e2 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e3) > 1.0) {
            y3 = 1.0;
            y3d = 0.0;
          } else {
            y3 = e3;
            y3d = e3d;
          }
          ex = y3;
          exd = y3d;
        } else {
          e4 = e2 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
          e4d = e2d * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) + e2 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4];
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e4) > 1.0) {
            y4 = 1.0;
            y4d = 0.0;
          } else {
            y4 = e4;
            y4d = e4d;
          }
          ex = y4;
          exd = y4d;
        }
        t20 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz;
        t20d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfzd;
        t21 = exp(t20);
        t21d = t21 * t20d;
        stiff = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        stiffd = ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfzd))) *
            t21 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21d) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        t22 = cx * dx;
        t22d = cxd * dx + cx * dxd;
        bx = stiff / t22;
        t22inv = 1.0 / t22;
        bxd = (stiffd - bx * t22d) * t22inv;
        svx = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        svxd = ((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd))) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX]) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LMUX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        y5 = bx * kx;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        y5d = bxd * kx + bx * kxd;
        t23 = atan(y5);
        c15 = 1.0 / (1.0 + y5 * y5);
        t23d = c15 * y5d;
        t24 = (1.0 - ex) * y5 + ex * t23;
        t24d = -(exd * y5) + (1.0 - ex) * y5d + (exd * t23 + ex * t23d);
        t25 = atan(t24);
        c16 = 1.0 / (1.0 + t24 * t24);
        t25d = c16 * t24d;
        t26 = cx * t25;
        t26d = cxd * t25 + cx * t25d;
        t27 = sin(t26);
        c17 = cos(t26);
        t27d = c17 * t26d;
        x40 = dx * t27 + svx;
        x40d = dxd * t27 + dx * t27d + svxd;
        x41 = stiff;
        x41d = stiffd;
        fz0_3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
        fz0_3d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        gy = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        gyd = gamma2d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] + gamma2 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        shy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gy;
        shyd = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PHY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY3] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gyd);
        ay = a3 + shy;
        ayd = a3d + shyd;
        cy = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        cyd = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY];
        muy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy *
            gy) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        muyd = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PDY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfzd)) *
            (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) -
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gyd) * gy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gyd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        dy = muy * fz2;
        dyd = muyd * fz2 + muy * fz2d;
        e5 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        e5d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
        if (MAGGI_RE(ay) > 0.0) {
          e6 = e5 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e6d = e5d * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) - e5 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e6) > 1.0) {
            y6 = 1.0;
            y6d = 0.0;
          } else {
            y6 = e6;
            y6d = e6d;
          }
          ey = y6;
          eyd = y6d;
        } else {
          e7 = e5 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
          e7d = e5d * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) + e5 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] + (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY4] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd));
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e7) > 1.0) {
            y7 = 1.0;
            y7d = 0.0;
          } else {
            y7 = e7;
            y7d = e7d;
          }
          ey = y7;
          eyd = y7d;
        }
        t28 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3;
        t28d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3d;
        z4 = fz2 / t28;
        t28inv = 1.0 / t28;
        z4d = (fz2d - z4 * t28d) * t28inv;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y8 = gy;
          y8d = gyd;
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y8 = -gy;
          y8d = -gyd;
        } else {
          p6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t29 = p6 * p6;
          t29d = p6d * p6 + p6 * p6d;
          z5 = gy * gy / t29;
          t29inv = 1.0 / t29;
          z5d = (gyd * gy + gy * gyd - z5 * t29d) * t29inv;
          y8 = 0.125 * p6 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
          y8d = (0.125 * p6d * z5 + 0.125 * p6 * z5d) * (15.0 + z5 * (-10.0 + 3.0 * z5)) + 0.125 *
              p6 * z5 * (z5d * (-10.0 + 3.0 * z5) + z5 * (3.0 * z5d));
        }
        t30 = 1.0 + z4 * z4;
        t30d = z4d * z4 + z4 * z4d;
        t31 = 2.0 * z4 / t30;
        t30inv = 1.0 / t30;
        t31d = (2.0 * z4d - t31 * t30d) * t30inv;
        stiff2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY];
        stiff2d = (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d) * t31 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31d) * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) - p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t31 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8d)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3]
            * y8) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY];
        t32 = cy * dy;
        t32d = cyd * dy + cy * dyd;
        by = stiff2 / t32;
        t32inv = 1.0 / t32;
        byd = (stiff2d - by * t32d) * t32inv;
        svy = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        svyd = (fz2d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) + fz2 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY3] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfzd)) * gy +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gyd))) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] +
            fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PVY4] * dfz) * gy) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        y9 = by * ay;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        y9d = byd * ay + by * ayd;
        t33 = atan(y9);
        c18 = 1.0 / (1.0 + y9 * y9);
        t33d = c18 * y9d;
        t34 = (1.0 - ey) * y9 + ey * t33;
        t34d = -(eyd * y9) + (1.0 - ey) * y9d + (eyd * t33 + ey * t33d);
        t35 = atan(t34);
        c19 = 1.0 / (1.0 + t34 * t34);
        t35d = c19 * t34d;
        t36 = cy * t35;
        t36d = cyd * t35 + cy * t35d;
        t37 = sin(t36);
        c23 = cos(t36);
        t37d = c23 * t36d;
        y20 = dy * t37 + svy;
        y20d = dyd * t37 + dy * t37d + svyd;
        y21 = stiff2;
        y21d = stiff2d;
        y22 = muy;
        y22d = muyd;
        y23 = by * cy;
        y23d = byd * cy + by * cyd;
        t38 = svy / stiff2;
        stiff2inv = 1.0 / stiff2;
        t38d = (svyd - t38 * stiff2d) * stiff2inv;
        y24 = shy + t38;
        y24d = shyd + t38d;
        muy2 = y22;
        muy2d = y22d;
        x5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a3 - p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBY3]);
        /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
        x5d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a3 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RBY2] * (a3d - pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]);
        t39 = 1.0 + x5 * x5;
        t39d = x5d * x5 + x5 * x5d;
        t40 = sqrt(t39);
        c24 = 1.0 / (2.0 * t40);
        t40d = c24 * t39d;
        t41 = 1.0 / t40;
        t40inv = 1.0 / t40;
        t41d = -(t41 * t40d * t40inv);
        stiff3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        stiff3d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41d) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        e9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz;
        e9d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] * dfzd);
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e9) > 1.0) {
          y10 = 1.0;
          y10d = 0.0;
        } else {
          y10 = e9;
          y10d = e9d;
        }
        e8 = y10;
        e8d = y10d;
        s4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz;
        s4d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] * dfzd);
        x6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a3;
        x6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a3 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RVY4] * a3d;
        t42 = 1.0 + x6 * x6;
        t42d = x6d * x6 + x6 * x6d;
        t43 = sqrt(t42);
        c25 = 1.0 / (2.0 * t43);
        t43d = c25 * t42d;
        t44 = 1.0 / t43;
        t43inv = 1.0 / t43;
        t44d = -(t44 * t43d * t43inv);
        dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2) * t44;
        dvd = ((muy2d * fz2 + muy2 * fz2d) * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2) + muy2 * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY1] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfzd) +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2d))) * t44 + muy2 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2) *
            t44d;
        y11 = stiff3 * (kappa2 + s4);
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        y11d = stiff3d * (kappa2 + s4) + stiff3 * (kappa2d + s4d);
        y12 = stiff3 * s4;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        y12d = stiff3d * s4 + stiff3 * s4d;
        t45 = atan(y11);
        c26 = 1.0 / (1.0 + y11 * y11);
        t45d = c26 * y11d;
        t46 = (1.0 - e8) * y11 + e8 * t45;
        t46d = -(e8d * y11) + (1.0 - e8) * y11d + (e8d * t45 + e8 * t45d);
        t47 = atan(t46);
        c27 = 1.0 / (1.0 + t46 * t46);
        t47d = c27 * t46d;
        p7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        p7d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        t48 = p7 * t47;
        t48d = p7d * t47 + p7 * t47d;
        t49 = cos(t48);
        c28 = -sin(t48);
        t49d = c28 * t48d;
        t50 = atan(y12);
        c29 = 1.0 / (1.0 + y12 * y12);
        t50d = c29 * y12d;
        t51 = (1.0 - e8) * y12 + e8 * t50;
        t51d = -(e8d * y12) + (1.0 - e8) * y12d + (e8d * t50 + e8 * t50d);
        t52 = atan(t51);
        c30 = 1.0 / (1.0 + t51 * t51);
        t52d = c30 * t51d;
        t53 = p7 * t52;
        t53d = p7d * t52 + p7 * t52d;
        t54 = cos(t53);
        c31 = -sin(t53);
        t54d = c31 * t53d;
        g30 = t49 / t54;
        t54inv = 1.0 / t54;
        g30d = (t49d - g30 * t54d) * t54inv;
        t55 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2;
        t55d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2d;
        t56 = atan(t55);
        c32 = 1.0 / (1.0 + t55 * t55);
        t56d = c32 * t55d;
        t57 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56;
        t57d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56d;
        t58 = sin(t57);
        c33 = cos(t57);
        t58d = c33 * t57d;
        g31 = dv * t58 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        g31d = (dvd * t58 + dv * t58d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] + dv *
            t58 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        x7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2;
        /* Gxa = Fx / Fx0 */
        x7d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2d;
        t59 = 1.0 + x7 * x7;
        t59d = x7d * x7 + x7 * x7d;
        t60 = sqrt(t59);
        c34 = 1.0 / (2.0 * t60);
        t60d = c34 * t59d;
        t61 = 1.0 / t60;
        t60inv = 1.0 / t60;
        t61d = -(t61 * t60d * t60inv);
        stiff4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        stiff4d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61d) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        e11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz;
        e11d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] * dfzd);
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e11) > 1.0) {
          y13 = 1.0;
          y13d = 0.0;
        } else {
          y13 = e11;
          y13d = e11d;
        }
        e10 = y13;
        e10d = y13d;
        p8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        p8d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        y14 = stiff4 * (a3 + p8);
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        y14d = stiff4d * (a3 + p8) + stiff4 * (a3d + p8d);
        y15 = stiff4 * p8;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        y15d = stiff4d * p8 + stiff4 * p8d;
        t62 = atan(y14);
        c35 = 1.0 / (1.0 + y14 * y14);
        t62d = c35 * y14d;
        t63 = (1.0 - e10) * y14 + e10 * t62;
        t63d = -(e10d * y14) + (1.0 - e10) * y14d + (e10d * t62 + e10 * t62d);
        t64 = atan(t63);
        c36 = 1.0 / (1.0 + t63 * t63);
        t64d = c36 * t63d;
        p9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        p9d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        t65 = p9 * t64;
        t65d = p9d * t64 + p9 * t64d;
        t66 = cos(t65);
        c37 = -sin(t65);
        t66d = c37 * t65d;
        t67 = atan(y15);
        c38 = 1.0 / (1.0 + y15 * y15);
        t67d = c38 * y15d;
        t68 = (1.0 - e10) * y15 + e10 * t67;
        t68d = -(e10d * y15) + (1.0 - e10) * y15d + (e10d * t67 + e10 * t67d);
        t69 = atan(t68);
        c39 = 1.0 / (1.0 + t68 * t68);
        t69d = c39 * t68d;
        t70 = p9 * t69;
        t70d = p9d * t69 + p9 * t69d;
        t71 = cos(t70);
        c40 = -sin(t70);
        t71d = c40 * t70d;
        t72 = t66 / t71;
        t71inv = 1.0 / t71;
        t72d = (t66d - t72 * t71d) * t71inv;
        fx = x40 * t72;
        fxd = x40d * t72 + x40 * t72d;
        fy = g30 * y20 + g31;
        fyd = g30d * y20 + g30 * y20d + g31d;
        ratio2 = x41 * kappa2 / y21;
        y21inv = 1.0 / y21;
        ratio2d = (x41d * kappa2 + x41 * kappa2d - ratio2 * y21d) * y21inv;
        bycy = y23;
        bycyd = y23d;
        shift = y24;
        shiftd = y24d;
        fz0_4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
         *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
        fz0_4d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]]
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]];
        gz = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        gzd = gamma2d * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] + gamma2 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        at = a3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QHZ2] * dfz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gz;
        atd = a3d + pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QHZ2] * dfzd) + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QHZ4] * dfzd)) * gz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gzd);
        ar = a3 + shift;
        ard = a3d + shiftd;
        t73 = at * at + ratio2 * ratio2 + 1e-24;
        t73d = atd * at + at * atd + (ratio2d * ratio2 + ratio2 * ratio2d);
        ateq = sqrt(t73);
        c41 = 1.0 / (2.0 * ateq);
        ateqd = c41 * t73d;
        t74 = ar * ar + ratio2 * ratio2 + 1e-24;
        t74d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
        areq = sqrt(t74);
        c42 = 1.0 / (2.0 * areq);
        areqd = c42 * t74d;
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y16 = gz;
          y16d = gzd;
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y16 = -gz;
          y16d = -gzd;
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          p10d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t75 = p10 * p10;
          t75d = p10d * p10 + p10 * p10d;
          z6 = gz * gz / t75;
          t75inv = 1.0 / t75;
          z6d = (gzd * gz + gz * gzd - z6 * t75d) * t75inv;
          y16 = 0.125 * p10 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
          y16d = (0.125 * p10d * z6 + 0.125 * p10 * z6d) * (15.0 + z6 * (-10.0 + 3.0 * z6)) + 0.125
              * p10 * z6 * (z6d * (-10.0 + 3.0 * z6) + z6 * (3.0 * z6d));
        }
        bt = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        inv = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        btd = (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfzd)) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ5] * y16) + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ3] * dfz * dfz) * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gzd +
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QBZ5] * y16d))) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16) * pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LKY] - bt * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY]) * inv;
        t76 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
        fz0_4inv = 1.0 / fz0_4;
        t76d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] - t76 * fz0_4d) *
            fz0_4inv;
        dt = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        dtd = (((fz2d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
            (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfzd))) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) + fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ2] * dfz) * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gzd +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ4] * gzd) * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz *
            gzd))) * t76 + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ4] * gz * gz) * t76d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] +
            fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        t77 = bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * at;
        t77d = (btd * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + bt *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1]) * at + bt *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * atd;
        t78 = atan(t77);
        c43 = 1.0 / (1.0 + t77 * t77);
        t78d = c43 * t77d;
        e12 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfz) *
            (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78);
        e12d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + (pd[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfzd) +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfzd) * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfzd)) * (1.0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78) + (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfz) *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ5] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gzd)) *
            0.63661977236758134308 * t78 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78d);
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e12) > 1.0) {
          y17 = 1.0;
          y17d = 0.0;
        } else {
          y17 = e12;
          y17d = e12d;
        }
        et = y17;
        etd = y17d;
        p11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        p11d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t79 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY] / p11;
        p11inv = 1.0 / p11;
        t79d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] - t79 * p11d) * p11inv;
        br = t79 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycy;
        brd = t79d + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycyd);
        dr = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] * p11;
        drd = ((fz2d * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) + fz2 *
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfzd)) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + ((pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ8] + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfzd)) * gz +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gzd))) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_UNLOADED_RADIUS] + fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS]) * p11 + fz2 *
            ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_UNLOADED_RADIUS] * p11d;
        t80 = 1.0 + a3 * a3;
        t80d = a3d * a3 + a3 * a3d;
        t81 = sqrt(t80);
        c44 = 1.0 / (2.0 * t81);
        t81d = c44 * t80d;
        ca = 1.0 / t81;
        t81inv = 1.0 / t81;
        cad = -(ca * t81d * t81inv);
        y18 = bt * ateq;
        /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
        y18d = btd * ateq + bt * ateqd;
        t82 = atan(y18);
        c45 = 1.0 / (1.0 + y18 * y18);
        t82d = c45 * y18d;
        t83 = (1.0 - et) * y18 + et * t82;
        t83d = -(etd * y18) + (1.0 - et) * y18d + (etd * t82 + et * t82d);
        t84 = atan(t83);
        c46 = 1.0 / (1.0 + t83 * t83);
        t84d = c46 * t83d;
        t85 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84;
        t85d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84d;
        t86 = cos(t85);
        c47 = -sin(t85);
        t86d = c47 * t85d;
        z30 = dt * t86 * ca;
        z30d = (dtd * t86 + dt * t86d) * ca + dt * t86 * cad;
        x8 = br * areq;
        x8d = brd * areq + br * areqd;
        t87 = 1.0 + x8 * x8;
        t87d = x8d * x8 + x8 * x8d;
        t88 = sqrt(t87);
        c48 = 1.0 / (2.0 * t88);
        t88d = c48 * t87d;
        t89 = 1.0 / t88;
        t88inv = 1.0 / t88;
        t89d = -(t89 * t88d * t88inv);
        z31 = dr * t89 * ca;
        z31d = (drd * t89 + dr * t89d) * ca + dr * t89 * cad;
        t90 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
        t90d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fyd - t90 * fz0_2d) * fz0_2inv;
        s3 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        s3d = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90d +
            ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfzd)) *
            gamma2 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2d)) * r0 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) *
            r0d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] + (p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 *
            pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        t91 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        inv2 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        t91d = (one4d - t91 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED]) * inv2;
        way = tanh(t91);
        wayd = (1.0 - way * way) * t91d;
        speed3 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        inv3 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        speed3d = (one4d - speed3 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL]) * inv3;
        force20 = fx;
        force20d = fxd;
        force21 = fy;
        force21d = fyd;
        force22 = fz2;
        force22d = fz2d;
        t92 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
        t92d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fy +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fyd - t92 * fz0_2d) * fz0_2inv;
        force23 = r0 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]);
        force23d = (r0d * fz2 + r0 * fz2d) * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]) + r0
            * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX1] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] +
            ((-(pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma2) -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma2d + t92d) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]));
        t93 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
        t93d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fxd - t93 * fz0_2d) * fz0_2inv;
        force24 = -way * r0 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        force24d = (((-(wayd * r0) - way * r0d) * fz2 + -way * r0 * fz2d) *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way * speed3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed3 * speed3 * speed3 * speed3) + -way * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSY1] + t93d + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3d) +
            ((((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3d)))
            * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] + -way * r0 * fz2 *
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QSY3] * way * speed3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] *
            speed3 * speed3 * speed3 * speed3) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        force25 = -z30 * (fy - g31) + z31 + s3 * fx;
        force25d = -(z30d * (fy - g31)) - z30 * (fyd - g31d) + z31d + (s3d * fx + s3 * fxd);
        rolling0 = force20;
        rolling0d = force20d;
        rolling1 = side * force21;
        rolling1d = side * force21d;
        rolling2 = force22;
        rolling2d = force22d;
        rolling3 = side * force23;
        rolling3d = side * force23d;
        rolling4 = force24;
        rolling4d = force24d;
        rolling5 = side * force25;
        rolling5d = side * force25d;
      } else {
        rolling0 = 0.0;
        rolling0d = 0.0;
        rolling1 = 0.0;
        rolling1d = 0.0;
        rolling2 = fz;
        rolling2d = fzd;
        rolling3 = 0.0;
        rolling3d = 0.0;
        rolling4 = 0.0;
        rolling4d = 0.0;
        rolling5 = 0.0;
        rolling5d = 0.0;
      }
    } else {
      rolling0 = 0.0;
      rolling0d = 0.0;
      rolling1 = 0.0;
      rolling1d = 0.0;
      rolling2 = 0.0;
      rolling2d = 0.0;
      rolling3 = 0.0;
      rolling3d = 0.0;
      rolling4 = 0.0;
      rolling4d = 0.0;
      rolling5 = 0.0;
      rolling5d = 0.0;
    }
    r30 = r[t->wheelpoint[i]][0] + arm0;
    /* at the contact point on the wheel:  f_x T + f_y L + f_z N;  power of all of it, springs of tyres too */
    r30d = rd[t->wheelpoint[i]][0] + arm0d;
    force30 = rolling0 * T0 + rolling1 * L0 + rolling2 * N0;
    force30d = rolling0d * T0 + rolling0 * T0d + (rolling1d * L0 + rolling1 * L0d) + (rolling2d * N0
        + rolling2 * N0d);
    moment0d = rolling3d * T0 + rolling3 * T0d + (rolling4d * L0 + rolling4 * L0d) + (rolling5d * N0
        + rolling5 * N0d);
    r31 = r[t->wheelpoint[i]][1] + arm1;
    r31d = rd[t->wheelpoint[i]][1] + arm1d;
    force31 = rolling0 * T1 + rolling1 * L1 + rolling2 * N1;
    force31d = rolling0d * T1 + rolling0 * T1d + (rolling1d * L1 + rolling1 * L1d) + rolling2d * N1;
    moment1d = rolling3d * T1 + rolling3 * T1d + (rolling4d * L1 + rolling4 * L1d) + rolling5d * N1;
    r32 = r[t->wheelpoint[i]][2] + arm2;
    r32d = rd[t->wheelpoint[i]][2] + arm2d;
    force32 = rolling0 * T2 + rolling1 * L2 + rolling2 * N2;
    force32d = rolling0d * T2 + rolling0 * T2d + (rolling1d * L2 + rolling1 * L2d) + (rolling2d * N2
        + rolling2 * N2d);
    moment2d = rolling3d * T2 + rolling3 * T2d + (rolling4d * L2 + rolling4 * L2d) + (rolling5d * N2
        + rolling5 * N2d);
    Qd[a6][0] += force30d;
    Qd[a6][1] += force31d;
    Qd[a6][2] += force32d;
    Qd[a6][3] += r31d * force32 + r31 * force32d - (r32d * force31 + r32 * force31d);
    Qd[a6][4] += r32d * force30 + r32 * force30d - (r30d * force32 + r30 * force32d);
    Qd[a6][5] += r30d * force31 + r30 * force31d - (r31d * force30 + r31 * force30d);
    Qd[a6][3] += moment0d;
    Qd[a6][4] += moment1d;
    Qd[a6][5] += moment2d;
  }
}
