/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/element.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

void maggi_element_forces_dv(const maggi_topo *t, const double p[restrict t->np],
                             const double pd[restrict t->np][MAGGI_NDIR],
                             const double fun[restrict t->nfun][3],
                             const double fund[restrict t->nfun][3][MAGGI_NDIR],
                             const double spring0[restrict t->nspring],
                             const double spring0d[restrict t->nspring][MAGGI_NDIR],
                             const double q[restrict t->nq],
                             const double qd[restrict t->nq][MAGGI_NDIR],
                             const double v[restrict t->nq],
                             const double vd[restrict t->nq][MAGGI_NDIR],
                             const double A[restrict t->nbody + 1][9],
                             const double Ad[restrict t->nbody + 1][9][MAGGI_NDIR],
                             const double Z[restrict t->nbody + 1][6],
                             const double Zd[restrict t->nbody + 1][6][MAGGI_NDIR],
                             const double r[restrict t->npoint][3],
                             const double rd[restrict t->npoint][3][MAGGI_NDIR],
                             const double rv[restrict t->npoint][3],
                             const double rvd[restrict t->npoint][3][MAGGI_NDIR],
                             double Q[restrict t->nbody + 1][6],
                             double Qd[restrict t->nbody + 1][6][MAGGI_NDIR],
                             double tau[restrict t->nq], double taud[restrict t->nq][MAGGI_NDIR],
                             double power[restrict 1], int nbdirs)
{
  int a, a4, a5, a5_2, a6, adr, adr2, b, b2, b3, b4, i, k, k11, k2, nd;
  double L0, L1, L2, N0, N1, N2, T0, T1, T2, Z_b43, Z_b44, Z_b45, a00, a01, a02, a2, a3, along0,
      along1, along2, ar, areq, arm0, arm1, arm2, at, ateq, ay, back0, back1, back20, back21,
      back22, back2_2, br, bt, bx, by, bycy, c, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19,
      c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c3, c30, c31, c32, c33, c34, c35, c36, c37,
      c38, c39, c4, c40, c41, c42, c43, c44, c45, c46, c47, c48, c5, c6, c7, c8, c9, ca, cx, cy,
      damping, dfz, dr, dt, dv, dx, dy, e0, e1, e10, e11, e12, e2, e2_2, e3, e4, e5, e6, e7, e8, e9,
      et, ev0, ev1, ev2, ex, ey, f0, f1, f2, f3, force0, force1, force20, force21, force22, force23,
      force24, force25, force2_2, force30, force31, force32, fx, fy, fz, fz0, fz0_2, fz0_2inv,
      fz0_3, fz0_4, fz0_4inv, fz0inv, fz2, g0, g1, g20, g22, g2_2, g30, g31, gamma, gamma2, gx, gy,
      gz, h00, h10, h11, inv, inv2, inv3, kappa, kappa2, kx, l, linv, lv, mux, muy, muy2, n20, n21,
      n22, n3, n3inv, n40, n41, n42, omega, one0, one1, one2, one3, one4, p10, p11, p11inv, p2, p3,
      p3inv, p4, p5, p5inv, p6, p7, p8, p9, p_adr2, p_k11, p_k111, p_k111_2, p_k111_2inv, p_k111inv,
      p_k11_2, p_k11_3, p_k11_4, p_k24, p_k25, r0, r2, r30, r31, r32, r_a0, r_a1, r_a2, r_b0, r_b1,
      r_b2, r_i0, r_i1, r_i2, ratio, ratio2, re, rhov, rolling0, rolling1, rolling2, rolling3,
      rolling4, rolling5, s, s2, s2inv, s3, s4, shift, shy, side, speed, speed2, speed2inv, speed3,
      stiff, stiff2, stiff2inv, stiff3, stiff4, svx, svy, t10, t11, t12, t13, t14, t15, t16, t17,
      t18, t19, t2, t20, t21, t22, t22inv, t23, t24, t25, t26, t27, t28, t28inv, t29, t29inv, t3,
      t30, t30inv, t31, t32, t32inv, t33, t34, t35, t36, t37, t38, t39, t4, t40, t40inv, t41, t42,
      t43, t43inv, t44, t45, t46, t47, t48, t49, t5, t50, t51, t52, t53, t54, t54inv, t55, t56, t57,
      t58, t59, t6, t60, t60inv, t61, t62, t63, t64, t65, t66, t67, t68, t69, t7, t70, t71, t71inv,
      t72, t73, t74, t75, t75inv, t76, t77, t78, t79, t7inv, t8, t80, t81, t81inv, t82, t83, t84,
      t85, t86, t87, t88, t88inv, t89, t9, t90, t91, t92, t93, u0, u1, u20, u21, u22, u2_2, u30,
      u31, u32, ua0, ua1, ua2, un0, un1, un2, v40, v41, v42, vr0, vr1, vr2, vx, w, way, winv, wr0,
      wr1, wr2, x, x2, x3, x40, x41, x5, x6, x7, x8, xv, y, y10, y11, y12, y13, y14, y15, y16, y17,
      y18, y20, y21, y21inv, y22, y23, y24, y3, y4, y5, y6, y7, y8, y9, z20, z21, z22, z22inv, z30,
      z31, z4, z5, z6;
  double L0d[MAGGI_NDIR], L1d[MAGGI_NDIR], L2d[MAGGI_NDIR], N0d[MAGGI_NDIR], N2d[MAGGI_NDIR],
      T0d[MAGGI_NDIR], T1d[MAGGI_NDIR], T2d[MAGGI_NDIR], a2d[MAGGI_NDIR], a3d[MAGGI_NDIR],
      areqd[MAGGI_NDIR], arm0d[MAGGI_NDIR], arm1d[MAGGI_NDIR], arm2d[MAGGI_NDIR], atd[MAGGI_NDIR],
      ateqd[MAGGI_NDIR], ayd[MAGGI_NDIR], btd[MAGGI_NDIR], bycyd[MAGGI_NDIR], c20d[MAGGI_NDIR],
      c21d[MAGGI_NDIR], c22d[MAGGI_NDIR], cxd[MAGGI_NDIR], cyd[MAGGI_NDIR], dampingd[MAGGI_NDIR],
      dfzd[MAGGI_NDIR], dtd[MAGGI_NDIR], dxd[MAGGI_NDIR], dyd[MAGGI_NDIR], e11d[MAGGI_NDIR],
      e12d[MAGGI_NDIR], e2d[MAGGI_NDIR], e3d[MAGGI_NDIR], e4d[MAGGI_NDIR], e5d[MAGGI_NDIR],
      e6d[MAGGI_NDIR], e7d[MAGGI_NDIR], e9d[MAGGI_NDIR], exd[MAGGI_NDIR], eyd[MAGGI_NDIR],
      f0d[MAGGI_NDIR], f1d[MAGGI_NDIR], f2d[MAGGI_NDIR], fxd[MAGGI_NDIR], fyd[MAGGI_NDIR],
      fz0_2d[MAGGI_NDIR], fz0_3d[MAGGI_NDIR], fz0_4d[MAGGI_NDIR], fz2d[MAGGI_NDIR], fzd[MAGGI_NDIR],
      g0d[MAGGI_NDIR], g1d[MAGGI_NDIR], g20d[MAGGI_NDIR], g22d[MAGGI_NDIR], g2_2d[MAGGI_NDIR],
      g30d[MAGGI_NDIR], g31d[MAGGI_NDIR], gamma2d[MAGGI_NDIR], gammad[MAGGI_NDIR], gyd[MAGGI_NDIR],
      gzd[MAGGI_NDIR], h00d[MAGGI_NDIR], h10d[MAGGI_NDIR], h11d[MAGGI_NDIR], kappa2d[MAGGI_NDIR],
      kappad[MAGGI_NDIR], kxd[MAGGI_NDIR], ld[MAGGI_NDIR], lvd[MAGGI_NDIR], muy2d[MAGGI_NDIR],
      muyd[MAGGI_NDIR], n20d[MAGGI_NDIR], n21d[MAGGI_NDIR], n22d[MAGGI_NDIR], omegad[MAGGI_NDIR],
      one0d[MAGGI_NDIR], one1d[MAGGI_NDIR], one2d[MAGGI_NDIR], one3d[MAGGI_NDIR], one4d[MAGGI_NDIR],
      r0d[MAGGI_NDIR], red[MAGGI_NDIR], rolling0d[MAGGI_NDIR], rolling1d[MAGGI_NDIR],
      rolling2d[MAGGI_NDIR], rolling3d[MAGGI_NDIR], rolling4d[MAGGI_NDIR], rolling5d[MAGGI_NDIR],
      sd[MAGGI_NDIR], shyd[MAGGI_NDIR], stiff3d[MAGGI_NDIR], stiff4d[MAGGI_NDIR],
      torque0d[MAGGI_NDIR], u30d[MAGGI_NDIR], u31d[MAGGI_NDIR], u32d[MAGGI_NDIR], v40d[MAGGI_NDIR],
      v41d[MAGGI_NDIR], v42d[MAGGI_NDIR], vxd[MAGGI_NDIR], x2d[MAGGI_NDIR], x3d[MAGGI_NDIR],
      x40d[MAGGI_NDIR], x41d[MAGGI_NDIR], xd[MAGGI_NDIR], xvd[MAGGI_NDIR], y10d[MAGGI_NDIR],
      y13d[MAGGI_NDIR], y16d[MAGGI_NDIR], y17d[MAGGI_NDIR], y20d[MAGGI_NDIR], y21d[MAGGI_NDIR],
      y23d[MAGGI_NDIR], y24d[MAGGI_NDIR], y3d[MAGGI_NDIR], y4d[MAGGI_NDIR], y6d[MAGGI_NDIR],
      y7d[MAGGI_NDIR], y8d[MAGGI_NDIR], yd[MAGGI_NDIR], z21d[MAGGI_NDIR], z22d[MAGGI_NDIR],
      z4d[MAGGI_NDIR];

  (void)Q;
  (void)tau;
  (void)power;
  (void)nbdirs;
  for (i = 0; i <= t->nbody; ++i) {
    for (k = 0; k < 6; ++k) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        Qd[i][k][nd] = 0.0;
      }
    }
  }
  for (i = 0; i < t->nq; ++i) {
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      taud[i][nd] = 0.0;
    }
  }
  for (i = 0; i < t->nspring; ++i) {
    a = t->springpa[i];
    b = t->springpb[i];
    e0 = r[a][0] - r[b][0];
    ev0 = rv[a][0] - rv[b][0];
    e1 = r[a][1] - r[b][1];
    ev1 = rv[a][1] - rv[b][1];
    e2_2 = r[a][2] - r[b][2];
    ev2 = rv[a][2] - rv[b][2];
    t2 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
    l = sqrt(t2);
    c4 = 1.0 / (2.0 * l);
    n20 = e0 / l;
    linv = 1.0 / l;
    n21 = e1 / l;
    n22 = e2_2 / l;
    lv = n20 * ev0 + n21 * ev1 + n22 * ev2;
    damping = p[t->springadr[i] + MAGGI_SPRING_C] * lv;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double e0d, e1d, e2_2d, ev0d, ev1d, ev2d, t2d;

      e0d = rd[a][0][nd] - rd[b][0][nd];
      ev0d = rvd[a][0][nd] - rvd[b][0][nd];
      e1d = rd[a][1][nd] - rd[b][1][nd];
      ev1d = rvd[a][1][nd] - rvd[b][1][nd];
      e2_2d = rd[a][2][nd] - rd[b][2][nd];
      ev2d = rvd[a][2][nd] - rvd[b][2][nd];
      t2d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2_2d * e2_2 + e2_2 * e2_2d);
      ld[nd] = c4 * t2d;
      n20d[nd] = (e0d - n20 * ld[nd]) * linv;
      n21d[nd] = (e1d - n21 * ld[nd]) * linv;
      n22d[nd] = (e2_2d - n22 * ld[nd]) * linv;
      lvd[nd] = n20d[nd] * ev0 + n20 * ev0d + (n21d[nd] * ev1 + n21 * ev1d) + (n22d[nd] * ev2 + n22
          * ev2d);
      dampingd[nd] = pd[t->springadr[i] + MAGGI_SPRING_C][nd] * lv + p[t->springadr[i] +
          MAGGI_SPRING_C] * lvd[nd];
    }
    if (t->springpreload[i]) {
      f0 = p[t->springadr[i]] * (l - spring0[i]) + p[t->springadr[i] + MAGGI_SPRING_L];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        f0d[nd] = pd[t->springadr[i]][nd] * (l - spring0[i]) + p[t->springadr[i]] * (ld[nd] -
            spring0d[i][nd]) + pd[t->springadr[i] + MAGGI_SPRING_L][nd];
      }
    } else {
      f0 = p[t->springadr[i]] * (l - p[t->springadr[i] + MAGGI_SPRING_L]);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        f0d[nd] = pd[t->springadr[i]][nd] * (l - p[t->springadr[i] + MAGGI_SPRING_L]) +
            p[t->springadr[i]] * (ld[nd] - pd[t->springadr[i] + MAGGI_SPRING_L][nd]);
      }
    }
    k2 = t->springadr[i] + MAGGI_SPRING_SLOPES;
    if (t->springslopes[i]) {
      /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
      if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
        p_k24 = p[k2 + 4];
        f2 = p[k2] * p_k24 + p[k2 + 1] * (lv - p_k24);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_k24d;

          p_k24d = pd[k2 + 4][nd];
          f2d[nd] = pd[k2][nd] * p_k24 + p[k2] * p_k24d + (pd[k2 + 1][nd] * (lv - p_k24) + p[k2 + 1]
              * (lvd[nd] - p_k24d));
        }
      } else if (MAGGI_RE(lv) > 0.0) {
        f2 = p[k2] * lv;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          f2d[nd] = pd[k2][nd] * lv + p[k2] * lvd[nd];
        }
      } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
        f2 = p[k2 + 2] * lv;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          f2d[nd] = pd[k2 + 2][nd] * lv + p[k2 + 2] * lvd[nd];
        }
      } else {
        p_k25 = p[k2 + 5];
        f2 = p[k2 + 2] * p_k25 + p[k2 + 3] * (lv - p_k25);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double p_k25d;

          p_k25d = pd[k2 + 5][nd];
          f2d[nd] = pd[k2 + 2][nd] * p_k25 + p[k2 + 2] * p_k25d + (pd[k2 + 3][nd] * (lv - p_k25) +
              p[k2 + 3] * (lvd[nd] - p_k25d));
        }
      }
      f1 = damping + f2;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        f1d[nd] = dampingd[nd] + f2d[nd];
      }
    } else {
      f1 = damping;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        f1d[nd] = dampingd[nd];
      }
    }
    u0 = n20;
    u1 = n21;
    u2_2 = n22;
    f3 = f0 + f1;
    force0 = f3 * u0;
    back0 = -f3 * u0;
    force1 = f3 * u1;
    back1 = -f3 * u1;
    force2_2 = f3 * u2_2;
    back2_2 = -f3 * u2_2;
    r_a1 = r[a][1];
    r_a2 = r[a][2];
    r_a0 = r[a][0];
    r_b1 = r[b][1];
    r_b2 = r[b][2];
    r_b0 = r[b][0];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double back0d, back1d, back2_2d, f3d, force0d, force1d, force2_2d, r_a0d, r_a1d, r_a2d, r_b0d,
          r_b1d, r_b2d, u0d, u1d, u2_2d;

      u0d = n20d[nd];
      u1d = n21d[nd];
      u2_2d = n22d[nd];
      f3d = f0d[nd] + f1d[nd];
      force0d = f3d * u0 + f3 * u0d;
      back0d = -(f3d * u0) - f3 * u0d;
      force1d = f3d * u1 + f3 * u1d;
      back1d = -(f3d * u1) - f3 * u1d;
      force2_2d = f3d * u2_2 + f3 * u2_2d;
      back2_2d = -(f3d * u2_2) - f3 * u2_2d;
      Qd[t->pointbody[a]][0][nd] += back0d;
      Qd[t->pointbody[a]][1][nd] += back1d;
      Qd[t->pointbody[a]][2][nd] += back2_2d;
      r_a1d = rd[a][1][nd];
      r_a2d = rd[a][2][nd];
      Qd[t->pointbody[a]][3][nd] += r_a1d * back2_2 + r_a1 * back2_2d - (r_a2d * back1 + r_a2 *
          back1d);
      r_a0d = rd[a][0][nd];
      Qd[t->pointbody[a]][4][nd] += r_a2d * back0 + r_a2 * back0d - (r_a0d * back2_2 + r_a0 *
          back2_2d);
      Qd[t->pointbody[a]][5][nd] += r_a0d * back1 + r_a0 * back1d - (r_a1d * back0 + r_a1 * back0d);
      Qd[t->pointbody[b]][0][nd] += force0d;
      Qd[t->pointbody[b]][1][nd] += force1d;
      Qd[t->pointbody[b]][2][nd] += force2_2d;
      r_b1d = rd[b][1][nd];
      r_b2d = rd[b][2][nd];
      Qd[t->pointbody[b]][3][nd] += r_b1d * force2_2 + r_b1 * force2_2d - (r_b2d * force1 + r_b2 *
          force1d);
      r_b0d = rd[b][0][nd];
      Qd[t->pointbody[b]][4][nd] += r_b2d * force0 + r_b2 * force0d - (r_b0d * force2_2 + r_b0 *
          force2_2d);
      Qd[t->pointbody[b]][5][nd] += r_b0d * force1 + r_b0 * force1d - (r_b1d * force0 + r_b1 *
          force0d);
    }
  }
  for (i = 0; i < t->njspring; ++i) {
    a4 = t->jspringq[i];
    b2 = t->jspringq2[i];
    adr = t->jspringadr[i];
    if (b2 >= 0) {
      x = q[a4] - q[b2];
      xv = v[a4] - v[b2];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        xd[nd] = qd[a4][nd] - qd[b2][nd];
        xvd[nd] = vd[a4][nd] - vd[b2][nd];
      }
    } else {
      x = q[a4];
      xv = v[a4];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        xd[nd] = qd[a4][nd];
        xvd[nd] = vd[a4][nd];
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      torque0d[nd] = -(pd[adr][nd] * (x - p[adr + MAGGI_JSPRING_REST])) - p[adr] * (xd[nd] - pd[adr
          + MAGGI_JSPRING_REST][nd]) - (pd[adr + MAGGI_JSPRING_C][nd] * xv + p[adr +
          MAGGI_JSPRING_C] * xvd[nd]) - pd[adr + MAGGI_JSPRING_PRELOAD][nd];
      taud[a4][nd] += torque0d[nd];
    }
    if (b2 >= 0) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        taud[b2][nd] -= torque0d[nd];
      }
    }
  }
  for (i = 0; i < t->nforce; ++i) {
    adr2 = t->forceadr[i];
    if (t->forcefun[i] >= 0) {
      s = fun[t->forcefun[i]][0];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[nd] = fund[t->forcefun[i]][0][nd];
      }
    } else {
      s = 1.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        sd[nd] = 0.0;
      }
    }
    if (t->forcekind[i] == MAGGI_FORCE_JOINT) {
      a5 = t->forceq[i];
      p_adr2 = p[adr2];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_adr2d;

        p_adr2d = pd[adr2][nd];
        taud[a5][nd] += p_adr2d * s + p_adr2 * sd[nd];
      }
    } else {
      a5_2 = t->forcebody[i];
      b3 = t->forcereaction[i];
      if (t->forcekind[i] == MAGGI_FORCE_DRAG) {
        u20 = rv[t->forcepoint[i]][0] - p[adr2 + MAGGI_DRAG_WIND];
        u21 = rv[t->forcepoint[i]][1] - p[adr2 + MAGGI_DRAG_WIND + 1];
        u22 = rv[t->forcepoint[i]][2] - p[adr2 + MAGGI_DRAG_WIND + 2];
        p2 = p[adr2 + MAGGI_DRAG_LOW];
        t3 = u20 * u20 + u21 * u21 + u22 * u22 + p2 * p2;
        speed = sqrt(t3);
        c5 = 1.0 / (2.0 * speed);
        c = 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * s;
        g0 = -c * speed * u20;
        g1 = -c * speed * u21;
        g2_2 = -c * speed * u22;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double cd, p2d, speedd, t3d, u20d, u21d, u22d;

          /* - rho/2 c A |u| u,  u = v - wind,  |u| = sqrt(u.u + low^2) */
          u20d = rvd[t->forcepoint[i]][0][nd] - pd[adr2 + MAGGI_DRAG_WIND][nd];
          u21d = rvd[t->forcepoint[i]][1][nd] - pd[adr2 + MAGGI_DRAG_WIND + 1][nd];
          u22d = rvd[t->forcepoint[i]][2][nd] - pd[adr2 + MAGGI_DRAG_WIND + 2][nd];
          p2d = pd[adr2 + MAGGI_DRAG_LOW][nd];
          t3d = u20d * u20 + u20 * u20d + (u21d * u21 + u21 * u21d) + (u22d * u22 + u22 * u22d) +
              (p2d * p2 + p2 * p2d);
          speedd = c5 * t3d;
          cd = ((0.5 * pd[adr2][nd] * p[adr2 + MAGGI_DRAG_C] + 0.5 * p[adr2] * pd[adr2 +
              MAGGI_DRAG_C][nd]) * p[adr2 + MAGGI_DRAG_AREA] + 0.5 * p[adr2] * p[adr2 +
              MAGGI_DRAG_C] * pd[adr2 + MAGGI_DRAG_AREA][nd]) * s + 0.5 * p[adr2] * p[adr2 +
              MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * sd[nd];
          g0d[nd] = (-(cd * speed) - c * speedd) * u20 + -c * speed * u20d;
          g1d[nd] = (-(cd * speed) - c * speedd) * u21 + -c * speed * u21d;
          g2_2d[nd] = (-(cd * speed) - c * speedd) * u22 + -c * speed * u22d;
        }
      } else {
        c20 = p[adr2] * s;
        c21 = p[adr2 + 1] * s;
        c22 = p[adr2 + 2] * s;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          c20d[nd] = pd[adr2][nd] * s + p[adr2] * sd[nd];
          c21d[nd] = pd[adr2 + 1][nd] * s + p[adr2 + 1] * sd[nd];
          c22d[nd] = pd[adr2 + 2][nd] * s + p[adr2 + 2] * sd[nd];
        }
        if (t->forcekind[i] == MAGGI_FORCE_BODY || t->forcekind[i] == MAGGI_TORQUE_BODY) {
          g0 = A[a5_2][0] * c20 + A[a5_2][1] * c21 + A[a5_2][2] * c22;
          g1 = A[a5_2][3] * c20 + A[a5_2][4] * c21 + A[a5_2][5] * c22;
          g2_2 = A[a5_2][6] * c20 + A[a5_2][7] * c21 + A[a5_2][8] * c22;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            g0d[nd] = Ad[a5_2][0][nd] * c20 + A[a5_2][0] * c20d[nd] + (Ad[a5_2][1][nd] * c21 +
                A[a5_2][1] * c21d[nd]) + (Ad[a5_2][2][nd] * c22 + A[a5_2][2] * c22d[nd]);
            g1d[nd] = Ad[a5_2][3][nd] * c20 + A[a5_2][3] * c20d[nd] + (Ad[a5_2][4][nd] * c21 +
                A[a5_2][4] * c21d[nd]) + (Ad[a5_2][5][nd] * c22 + A[a5_2][5] * c22d[nd]);
            g2_2d[nd] = Ad[a5_2][6][nd] * c20 + A[a5_2][6] * c20d[nd] + (Ad[a5_2][7][nd] * c21 +
                A[a5_2][7] * c21d[nd]) + (Ad[a5_2][8][nd] * c22 + A[a5_2][8] * c22d[nd]);
          }
        } else {
          g0 = c20;
          g1 = c21;
          g2_2 = c22;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            g0d[nd] = c20d[nd];
            g1d[nd] = c21d[nd];
            g2_2d[nd] = c22d[nd];
          }
        }
      }
      if (t->forcepoint[i] >= 0) {
        back20 = -g0;
        back21 = -g1;
        back22 = -g2_2;
        r_i1 = r[t->forcepoint[i]][1];
        r_i2 = r[t->forcepoint[i]][2];
        r_i0 = r[t->forcepoint[i]][0];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double back20d, back21d, back22d, r_i0d, r_i1d, r_i2d;

          /* force at r, or pure torque, on one body and back on another; returns its power */
          back20d = -g0d[nd];
          back21d = -g1d[nd];
          back22d = -g2_2d[nd];
          Qd[a5_2][0][nd] += g0d[nd];
          Qd[a5_2][1][nd] += g1d[nd];
          Qd[a5_2][2][nd] += g2_2d[nd];
          r_i1d = rd[t->forcepoint[i]][1][nd];
          r_i2d = rd[t->forcepoint[i]][2][nd];
          Qd[a5_2][3][nd] += r_i1d * g2_2 + r_i1 * g2_2d[nd] - (r_i2d * g1 + r_i2 * g1d[nd]);
          r_i0d = rd[t->forcepoint[i]][0][nd];
          Qd[a5_2][4][nd] += r_i2d * g0 + r_i2 * g0d[nd] - (r_i0d * g2_2 + r_i0 * g2_2d[nd]);
          Qd[a5_2][5][nd] += r_i0d * g1 + r_i0 * g1d[nd] - (r_i1d * g0 + r_i1 * g0d[nd]);
          Qd[b3][0][nd] += back20d;
          Qd[b3][1][nd] += back21d;
          Qd[b3][2][nd] += back22d;
          Qd[b3][3][nd] += r_i1d * back22 + r_i1 * back22d - (r_i2d * back21 + r_i2 * back21d);
          Qd[b3][4][nd] += r_i2d * back20 + r_i2 * back20d - (r_i0d * back22 + r_i0 * back22d);
          Qd[b3][5][nd] += r_i0d * back21 + r_i0 * back21d - (r_i1d * back20 + r_i1 * back20d);
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          /* force at r, or pure torque, on one body and back on another; returns its power */
          Qd[a5_2][3][nd] += g0d[nd];
          Qd[b3][3][nd] -= g0d[nd];
          Qd[a5_2][4][nd] += g1d[nd];
          Qd[b3][4][nd] -= g1d[nd];
          Qd[a5_2][5][nd] += g2_2d[nd];
          Qd[b3][5][nd] -= g2_2d[nd];
        }
      }
    }
  }
  for (i = 0; i < t->nwheel; ++i) {
    a6 = t->wheelbody[i];
    b4 = t->wheelcarrier[i];
    k11 = t->wheelroad[i];
    side = t->wheelmirror[i] ? -1.0 : 1.0;
    a00 = p[t->wheelaxis[i]];
    a01 = p[t->wheelaxis[i] + 1];
    a02 = p[t->wheelaxis[i] + 2];
    ua0 = A[a6][0] * a00 + A[a6][1] * a01 + A[a6][2] * a02;
    ua1 = A[a6][3] * a00 + A[a6][4] * a01 + A[a6][5] * a02;
    ua2 = A[a6][6] * a00 + A[a6][7] * a01 + A[a6][8] * a02;
    t4 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
    n3 = sqrt(t4);
    c6 = 1.0 / (2.0 * n3);
    u30 = ua0 / n3;
    n3inv = 1.0 / n3;
    u31 = ua1 / n3;
    u32 = ua2 / n3;
    g20 = r[t->wheelpoint[i]][0] - r[t->roadpoint[k11]][0];
    g22 = r[t->wheelpoint[i]][2] - r[t->roadpoint[k11]][2];
    x3 = g20;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double a00d, a01d, a02d, n3d, t4d, ua0d, ua1d, ua2d;

      a00d = pd[t->wheelaxis[i]][nd];
      a01d = pd[t->wheelaxis[i] + 1][nd];
      a02d = pd[t->wheelaxis[i] + 2][nd];
      ua0d = Ad[a6][0][nd] * a00 + A[a6][0] * a00d + (Ad[a6][1][nd] * a01 + A[a6][1] * a01d) +
          (Ad[a6][2][nd] * a02 + A[a6][2] * a02d);
      ua1d = Ad[a6][3][nd] * a00 + A[a6][3] * a00d + (Ad[a6][4][nd] * a01 + A[a6][4] * a01d) +
          (Ad[a6][5][nd] * a02 + A[a6][5] * a02d);
      ua2d = Ad[a6][6][nd] * a00 + A[a6][6] * a00d + (Ad[a6][7][nd] * a01 + A[a6][7] * a01d) +
          (Ad[a6][8][nd] * a02 + A[a6][8] * a02d);
      t4d = ua0d * ua0 + ua0 * ua0d + (ua1d * ua1 + ua1 * ua1d) + (ua2d * ua2 + ua2 * ua2d);
      n3d = c6 * t4d;
      u30d[nd] = (ua0d - u30 * n3d) * n3inv;
      u31d[nd] = (ua1d - u31 * n3d) * n3inv;
      u32d[nd] = (ua2d - u32 * n3d) * n3inv;
      g20d[nd] = rd[t->wheelpoint[i]][0][nd] - rd[t->roadpoint[k11]][0][nd];
      g22d[nd] = rd[t->wheelpoint[i]][2][nd] - rd[t->roadpoint[k11]][2][nd];
      /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
       * the centre down the disc meets it, n its normal; then down the disc to that plane,
       *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
       * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
      x3d[nd] = g20d[nd];
    }
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11 = p[t->roadadr[k11]];
      h00 = p_k11 * x3;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_k11d;

        p_k11d = pd[t->roadadr[k11]][nd];
        h00d[nd] = p_k11d * x3 + p_k11 * x3d[nd];
      }
    } else {
      p_k111 = p[t->roadadr[k11] + 1];
      t5 = 6.28318530717958647693 * x3 / p_k111;
      p_k111inv = 1.0 / p_k111;
      t6 = sin(t5);
      c7 = cos(t5);
      p_k11_2 = p[t->roadadr[k11]];
      h00 = p_k11_2 * t6;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_k111d, p_k11_2d, t5d, t6d;

        p_k111d = pd[t->roadadr[k11] + 1][nd];
        t5d = (6.28318530717958647693 * x3d[nd] - t5 * p_k111d) * p_k111inv;
        t6d = c7 * t5d;
        p_k11_2d = pd[t->roadadr[k11]][nd];
        h00d[nd] = p_k11_2d * t6 + p_k11_2 * t6d;
      }
    }
    t7 = u30 * u30 + u31 * u31;
    t8 = u32 * u30 / t7;
    t7inv = 1.0 / t7;
    x2 = g20 + t8 * (g22 - h00);
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double t7d, t8d;

      t7d = u30d[nd] * u30 + u30 * u30d[nd] + (u31d[nd] * u31 + u31 * u31d[nd]);
      t8d = (u32d[nd] * u30 + u32 * u30d[nd] - t8 * t7d) * t7inv;
      x2d[nd] = g20d[nd] + (t8d * (g22 - h00) + t8 * (g22d[nd] - h00d[nd]));
    }
    /* height of the road above its point at x ahead of it, and its slope */
    if (t->roadkind[k11] == MAGGI_ROAD_FLAT) {
      p_k11_3 = p[t->roadadr[k11]];
      h10 = p_k11_3 * x2;
      h11 = p_k11_3;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_k11_3d;

        p_k11_3d = pd[t->roadadr[k11]][nd];
        h10d[nd] = p_k11_3d * x2 + p_k11_3 * x2d[nd];
        h11d[nd] = p_k11_3d;
      }
    } else {
      p_k111_2 = p[t->roadadr[k11] + 1];
      t9 = 6.28318530717958647693 * x2 / p_k111_2;
      p_k111_2inv = 1.0 / p_k111_2;
      t10 = sin(t9);
      c8 = cos(t9);
      p_k11_4 = p[t->roadadr[k11]];
      h10 = p_k11_4 * t10;
      t11 = p_k11_4 * 6.28318530717958647693 / p_k111_2;
      t12 = 6.28318530717958647693 * x2 / p_k111_2;
      t13 = cos(t12);
      c9 = -sin(t12);
      h11 = t11 * t13;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_k111_2d, p_k11_4d, t10d, t11d, t12d, t13d, t9d;

        p_k111_2d = pd[t->roadadr[k11] + 1][nd];
        t9d = (6.28318530717958647693 * x2d[nd] - t9 * p_k111_2d) * p_k111_2inv;
        t10d = c8 * t9d;
        p_k11_4d = pd[t->roadadr[k11]][nd];
        h10d[nd] = p_k11_4d * t10 + p_k11_4 * t10d;
        t11d = (p_k11_4d * 6.28318530717958647693 - t11 * p_k111_2d) * p_k111_2inv;
        t12d = (6.28318530717958647693 * x2d[nd] - t12 * p_k111_2d) * p_k111_2inv;
        t13d = c9 * t12d;
        h11d[nd] = t11d * t13 + t11 * t13d;
      }
    }
    t14 = 1.0 + h11 * h11;
    s2 = sqrt(t14);
    c10 = 1.0 / (2.0 * s2);
    n40 = -h11 / s2;
    s2inv = 1.0 / s2;
    n41 = 0.0;
    n42 = 1.0 / s2;
    c3 = u30 * n40 + u31 * n41 + u32 * n42;
    un0 = u31 * n42 - u32 * n41;
    un1 = u32 * n40 - u30 * n42;
    un2 = u30 * n41 - u31 * n40;
    t15 = un0 * un0 + un1 * un1 + un2 * un2;
    w = sqrt(t15);
    c11 = 1.0 / (2.0 * w);
    r2 = ((g20 - x2) * n40 + (g22 - h10) * n42) / w;
    winv = 1.0 / w;
    along0 = un0 / w;
    along1 = un1 / w;
    along2 = un2 / w;
    L0 = n41 * along2 - n42 * along1;
    L1 = n42 * along0 - n40 * along2;
    L2 = n40 * along1 - n41 * along0;
    arm0 = r2 * (c3 * u30 - n40) / w;
    T0 = along0;
    N0 = n40;
    arm1 = r2 * (c3 * u31 - n41) / w;
    T1 = along1;
    N1 = n41;
    arm2 = r2 * (c3 * u32 - n42) / w;
    T2 = along2;
    N2 = n42;
    z20 = r2;
    z21 = c3;
    z22 = w;
    Z_b43 = Z[b4][3];
    wr0 = Z_b43;
    Z_b44 = Z[b4][4];
    wr1 = Z_b44;
    Z_b45 = Z[b4][5];
    wr2 = Z_b45;
    vr0 = wr1 * arm2 - wr2 * arm1;
    vr1 = wr2 * arm0 - wr0 * arm2;
    vr2 = wr0 * arm1 - wr1 * arm0;
    v40 = rv[t->wheelpoint[i]][0] + vr0;
    v41 = rv[t->wheelpoint[i]][1] + vr1;
    v42 = rv[t->wheelpoint[i]][2] + vr2;
    vx = v40 * T0 + v41 * T1 + v42 * T2;
    rhov = -(v40 * N0 + v41 * N1 + v42 * N2) / z22;
    z22inv = 1.0 / z22;
    omega = (Z[a6][3] - Z_b43) * u30 + (Z[a6][4] - Z_b44) * u31 + (Z[a6][5] - Z_b45) * u32;
    p3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
    p4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
    fz = p3 * (p4 - z20) + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
    fz0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
    ratio = fz / fz0;
    fz0inv = 1.0 / fz0;
    t16 = fz0 / p3;
    p3inv = 1.0 / p3;
    t17 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratio;
    t18 = atan(t17);
    c12 = 1.0 / (1.0 + t17 * t17);
    re = p4 - t16 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 +
        p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio);
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double Z_b43d, Z_b44d, Z_b45d, along0d, along1d, along2d, c3d, fz0d, n40d, n42d, p3d, p4d,
          r2d, ratiod, rhovd, s2d, t14d, t15d, t16d, t17d, t18d, un0d, un1d, un2d, vr0d, vr1d, vr2d,
          wd, wr0d, wr1d, wr2d, z20d;

      t14d = h11d[nd] * h11 + h11 * h11d[nd];
      s2d = c10 * t14d;
      n40d = (-h11d[nd] - n40 * s2d) * s2inv;
      n42d = -(n42 * s2d * s2inv);
      c3d = u30d[nd] * n40 + u30 * n40d + u31d[nd] * n41 + (u32d[nd] * n42 + u32 * n42d);
      un0d = u31d[nd] * n42 + u31 * n42d - u32d[nd] * n41;
      un1d = u32d[nd] * n40 + u32 * n40d - (u30d[nd] * n42 + u30 * n42d);
      un2d = u30d[nd] * n41 - (u31d[nd] * n40 + u31 * n40d);
      t15d = un0d * un0 + un0 * un0d + (un1d * un1 + un1 * un1d) + (un2d * un2 + un2 * un2d);
      wd = c11 * t15d;
      r2d = ((g20d[nd] - x2d[nd]) * n40 + (g20 - x2) * n40d + ((g22d[nd] - h10d[nd]) * n42 + (g22 -
          h10) * n42d) - r2 * wd) * winv;
      along0d = (un0d - along0 * wd) * winv;
      along1d = (un1d - along1 * wd) * winv;
      along2d = (un2d - along2 * wd) * winv;
      L0d[nd] = n41 * along2d - (n42d * along1 + n42 * along1d);
      L1d[nd] = n42d * along0 + n42 * along0d - (n40d * along2 + n40 * along2d);
      L2d[nd] = n40d * along1 + n40 * along1d - n41 * along0d;
      arm0d[nd] = (r2d * (c3 * u30 - n40) + r2 * (c3d * u30 + c3 * u30d[nd] - n40d) - arm0 * wd) *
          winv;
      T0d[nd] = along0d;
      N0d[nd] = n40d;
      arm1d[nd] = (r2d * (c3 * u31 - n41) + r2 * (c3d * u31 + c3 * u31d[nd]) - arm1 * wd) * winv;
      T1d[nd] = along1d;
      arm2d[nd] = (r2d * (c3 * u32 - n42) + r2 * (c3d * u32 + c3 * u32d[nd] - n42d) - arm2 * wd) *
          winv;
      T2d[nd] = along2d;
      N2d[nd] = n42d;
      z20d = r2d;
      z21d[nd] = c3d;
      z22d[nd] = wd;
      Z_b43d = Zd[b4][3][nd];
      wr0d = Z_b43d;
      Z_b44d = Zd[b4][4][nd];
      wr1d = Z_b44d;
      Z_b45d = Zd[b4][5][nd];
      wr2d = Z_b45d;
      vr0d = wr1d * arm2 + wr1 * arm2d[nd] - (wr2d * arm1 + wr2 * arm1d[nd]);
      vr1d = wr2d * arm0 + wr2 * arm0d[nd] - (wr0d * arm2 + wr0 * arm2d[nd]);
      vr2d = wr0d * arm1 + wr0 * arm1d[nd] - (wr1d * arm0 + wr1 * arm0d[nd]);
      v40d[nd] = rvd[t->wheelpoint[i]][0][nd] + vr0d;
      v41d[nd] = rvd[t->wheelpoint[i]][1][nd] + vr1d;
      v42d[nd] = rvd[t->wheelpoint[i]][2][nd] + vr2d;
      vxd[nd] = v40d[nd] * T0 + v40 * T0d[nd] + (v41d[nd] * T1 + v41 * T1d[nd]) + (v42d[nd] * T2 +
          v42 * T2d[nd]);
      rhovd = (-(v40d[nd] * N0 + v40 * N0d[nd] + v41d[nd] * N1 + (v42d[nd] * N2 + v42 * N2d[nd])) -
          rhov * z22d[nd]) * z22inv;
      omegad[nd] = (Zd[a6][3][nd] - Z_b43d) * u30 + (Z[a6][3] - Z_b43) * u30d[nd] + ((Zd[a6][4][nd]
          - Z_b44d) * u31 + (Z[a6][4] - Z_b44) * u31d[nd]) + ((Zd[a6][5][nd] - Z_b45d) * u32 +
          (Z[a6][5] - Z_b45) * u32d[nd]);
      p3d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VERTICAL_STIFFNESS][nd];
      p4d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS][nd];
      fzd[nd] = p3d * (p4 - z20) + p3 * (p4d - z20d) + (pd[t->tyreadr[t->wheeltyre[i]] +
          MAGGI_TYRE_VERTICAL_DAMPING][nd] * rhov + p[t->tyreadr[t->wheeltyre[i]] +
          MAGGI_TYRE_VERTICAL_DAMPING] * rhovd);
      fz0d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO][nd] * p[t->tyreadr[t->wheeltyre[i]]]
          + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * pd[t->tyreadr[t->wheeltyre[i]]][nd];
      ratiod = (fzd[nd] - ratio * fz0d) * fz0inv;
      t16d = (fz0d - t16 * p3d) * p3inv;
      t17d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF][nd] * ratio +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_BREFF] * ratiod;
      t18d = c12 * t17d;
      red[nd] = p4d - (t16d * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18 +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] * ratio) + t16 *
          (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF][nd] * t18 +
          p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_DREFF] * t18d + (pd[t->tyreadr[t->wheeltyre[i]]
          + MAGGI_TYRE_FREFF][nd] * ratio + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_FREFF] *
          ratiod)));
    }
    /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
    if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y = vx;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        yd[nd] = vxd[nd];
      }
    } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW])) {
      y = -vx;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        yd[nd] = -vxd[nd];
      }
    } else {
      p5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW];
      t19 = vx * vx / p5;
      p5inv = 1.0 / p5;
      y = 0.5 * (p5 + t19);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p5d, t19d;

        p5d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_VXLOW][nd];
        t19d = (vxd[nd] * vx + vx * vxd[nd] - t19 * p5d) * p5inv;
        yd[nd] = 0.5 * (p5d + t19d);
      }
    }
    speed2 = y;
    kappa = (omega * re - vx) / speed2;
    speed2inv = 1.0 / speed2;
    a2 = (v40 * L0 + v41 * L1 + v42 * L2) / speed2;
    gamma = atan2(z21, z22);
    c13 = z22 / (z22 * z22 + z21 * z21);
    c14 = -(z21 / (z22 * z22 + z21 * z21));
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double speed2d;

      speed2d = yd[nd];
      kappad[nd] = (omegad[nd] * re + omega * red[nd] - vxd[nd] - kappa * speed2d) * speed2inv;
      a2d[nd] = (v40d[nd] * L0 + v40 * L0d[nd] + (v41d[nd] * L1 + v41 * L1d[nd]) + (v42d[nd] * L2 +
          v42 * L2d[nd]) - a2 * speed2d) * speed2inv;
      gammad[nd] = c13 * z21d[nd] + c14 * z22d[nd];
    }
    if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z20) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] +
        MAGGI_TYRE_UNLOADED_RADIUS])) {
      one0 = kappa;
      one1 = side * a2;
      one2 = side * gamma;
      one3 = fz;
      one4 = vx;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        one0d[nd] = kappad[nd];
        one1d[nd] = side * a2d[nd];
        one2d[nd] = side * gammad[nd];
        one3d[nd] = fzd[nd];
        one4d[nd] = vxd[nd];
      }
      if (t->wheelgrip[i]) {
        kappa2 = one0;
        a3 = one1;
        gamma2 = one2;
        fz2 = one3;
        fz0_2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        r0 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS];
        dfz = (fz2 - fz0_2) / fz0_2;
        fz0_2inv = 1.0 / fz0_2;
        kx = kappa2 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LHX];
        gx = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX];
        cx = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCX];
        mux = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx *
            gx) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        dx = mux * fz2;
        e2 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double gxd, muxd;

          kappa2d[nd] = one0d[nd];
          a3d[nd] = one1d[nd];
          gamma2d[nd] = one2d[nd];
          fz2d[nd] = one3d[nd];
          fz0_2d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO][nd] *
              p[t->tyreadr[t->wheeltyre[i]]] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[i]]][nd];
          r0d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS][nd];
          dfzd[nd] = (fz2d[nd] - fz0_2d[nd] - dfz * fz0_2d[nd]) * fz0_2inv;
          /* Fx0, Kx */
          kxd[nd] = kappa2d[nd] + ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHX2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHX][nd]);
          gxd = gamma2d[nd] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX] + gamma2 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAX][nd];
          cxd[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCX1][nd] *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PCX1] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCX][nd];
          muxd = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfzd[nd])) * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) -
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PDX2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3][nd] * gx
              + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gxd) * gx +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gxd)) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX2] * dfz) * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDX3] * gx * gx) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX][nd];
          dxd[nd] = muxd * fz2 + mux * fz2d[nd];
          e2d[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfzd[nd]) +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfzd[nd]) * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX2] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX3] * dfz * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEX][nd];
        }
        if (MAGGI_RE(kx) > 0.0) {
          e3 = e2 * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            e3d[nd] = e2d[nd] * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) - e2 *
                pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4][nd];
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e3) > 1.0) {
            y3 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y3d[nd] = 0.0;
            }
          } else {
            y3 = e3;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y3d[nd] = e3d[nd];
            }
          }
          ex = y3;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            exd[nd] = y3d[nd];
          }
        } else {
          e4 = e2 * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]);
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            e4d[nd] = e2d[nd] * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4]) + e2 *
                pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEX4][nd];
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e4) > 1.0) {
            y4 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y4d[nd] = 0.0;
            }
          } else {
            y4 = e4;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y4d[nd] = e4d[nd];
            }
          }
          ex = y4;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            exd[nd] = y4d[nd];
          }
        }
        t20 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfz;
        t21 = exp(t20);
        stiff = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX];
        t22 = cx * dx;
        bx = stiff / t22;
        t22inv = 1.0 / t22;
        svx = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUX];
        y5 = bx * kx;
        t23 = atan(y5);
        c15 = 1.0 / (1.0 + y5 * y5);
        t24 = (1.0 - ex) * y5 + ex * t23;
        t25 = atan(t24);
        c16 = 1.0 / (1.0 + t24 * t24);
        t26 = cx * t25;
        t27 = sin(t26);
        c17 = cos(t26);
        x40 = dx * t27 + svx;
        x41 = stiff;
        fz0_3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        gy = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY];
        shy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] * gy;
        ay = a3 + shy;
        cy = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LCY];
        muy = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy *
            gy) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        dy = muy * fz2;
        e5 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double bxd, stiffd, svxd, t20d, t21d, t22d, t23d, t24d, t25d, t26d, t27d, y5d;

          t20d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX3] * dfzd[nd];
          t21d = t21 * t20d;
          stiffd = ((fz2d[nd] * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfzd[nd]))) * t21 + fz2 *
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PKX2] * dfz) * t21d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX] +
              fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKX2] * dfz) * t21 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKX][nd];
          t22d = cxd[nd] * dx + cx * dxd[nd];
          bxd = (stiffd - bx * t22d) * t22inv;
          svxd = ((fz2d[nd] * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfzd[nd]))) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX][nd]) * p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_LMUX] + fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVX] * pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_LMUX][nd];
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y5d = bxd * kx + bx * kxd[nd];
          t23d = c15 * y5d;
          t24d = -(exd[nd] * y5) + (1.0 - ex) * y5d + (exd[nd] * t23 + ex * t23d);
          t25d = c16 * t24d;
          t26d = cxd[nd] * t25 + cx * t25d;
          t27d = c17 * t26d;
          x40d[nd] = dxd[nd] * t27 + dx * t27d + svxd;
          x41d[nd] = stiffd;
          /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
          fz0_3d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO][nd] *
              p[t->tyreadr[t->wheeltyre[i]]] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[i]]][nd];
          gyd[nd] = gamma2d[nd] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY] + gamma2 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAY][nd];
          shyd[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LHY][nd] + (pd[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_PHY3][nd] * gy + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PHY3] *
              gyd[nd]);
          ayd[nd] = a3d[nd] + shyd[nd];
          cyd[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PCY1][nd] *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PCY1] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LCY][nd];
          muyd[nd] = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfzd[nd])) * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) -
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PDY2] * dfz) * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3][nd] * gy
              + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gyd[nd]) * gy +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gyd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY2] * dfz) * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PDY3] * gy * gy) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY][nd];
          dyd[nd] = muyd[nd] * fz2 + muy * fz2d[nd];
          e5d[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LEY][nd];
        }
        if (MAGGI_RE(ay) > 0.0) {
          e6 = e5 * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            e6d[nd] = e5d[nd] * (1.0 - (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) - e5 *
                (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3][nd] +
                (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4][nd] * gy +
                p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd[nd]));
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e6) > 1.0) {
            y6 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y6d[nd] = 0.0;
            }
          } else {
            y6 = e6;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y6d[nd] = e6d[nd];
            }
          }
          ey = y6;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            eyd[nd] = y6d[nd];
          }
        } else {
          e7 = e5 * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            e7d[nd] = e5d[nd] * (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gy)) + e5 *
                (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY3][nd] +
                (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4][nd] * gy +
                p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PEY4] * gyd[nd]));
          }
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e7) > 1.0) {
            y7 = 1.0;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y7d[nd] = 0.0;
            }
          } else {
            y7 = e7;
#pragma omp simd
            for (nd = 0; nd < MAGGI_NDIR; ++nd) {
              y7d[nd] = e7d[nd];
            }
          }
          ey = y7;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            eyd[nd] = y7d[nd];
          }
        }
        t28 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3;
        z4 = fz2 / t28;
        t28inv = 1.0 / t28;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t28d;

          t28d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2][nd] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY2] * fz0_3d[nd];
          z4d[nd] = (fz2d[nd] - z4 * t28d) * t28inv;
        }
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y8 = gy;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y8d[nd] = gyd[nd];
          }
        } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y8 = -gy;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y8d[nd] = -gyd[nd];
          }
        } else {
          p6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t29 = p6 * p6;
          z5 = gy * gy / t29;
          t29inv = 1.0 / t29;
          y8 = 0.125 * p6 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double p6d, t29d, z5d;

            p6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER][nd];
            t29d = p6d * p6 + p6 * p6d;
            z5d = (gyd[nd] * gy + gy * gyd[nd] - z5 * t29d) * t29inv;
            y8d[nd] = (0.125 * p6d * z5 + 0.125 * p6 * z5d) * (15.0 + z5 * (-10.0 + 3.0 * z5)) +
                0.125 * p6 * z5 * (z5d * (-10.0 + 3.0 * z5) + z5 * (3.0 * z5d));
          }
        }
        t30 = 1.0 + z4 * z4;
        t31 = 2.0 * z4 / t30;
        t30inv = 1.0 / t30;
        stiff2 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 -
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY];
        t32 = cy * dy;
        by = stiff2 / t32;
        t32inv = 1.0 / t32;
        svy = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        y9 = by * ay;
        t33 = atan(y9);
        c18 = 1.0 / (1.0 + y9 * y9);
        t34 = (1.0 - ey) * y9 + ey * t33;
        t35 = atan(t34);
        c19 = 1.0 / (1.0 + t34 * t34);
        t36 = cy * t35;
        t37 = sin(t36);
        c23 = cos(t36);
        y20 = dy * t37 + svy;
        y21 = stiff2;
        y22 = muy;
        y23 = by * cy;
        t38 = svy / stiff2;
        stiff2inv = 1.0 / stiff2;
        y24 = shy + t38;
        muy2 = y22;
        x5 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2] * (a3 - p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_RBY3]);
        t39 = 1.0 + x5 * x5;
        t40 = sqrt(t39);
        c24 = 1.0 / (2.0 * t40);
        t41 = 1.0 / t40;
        t40inv = 1.0 / t40;
        stiff3 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA];
        e9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REY2] * dfz;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double byd, stiff2d, svyd, t30d, t31d, t32d, t33d, t34d, t35d, t36d, t37d, t38d, t39d,
              t40d, t41d, x5d, y22d, y9d;

          t30d = z4d[nd] * z4 + z4 * z4d[nd];
          t31d = (2.0 * z4d[nd] - t31 * t30d) * t30inv;
          stiff2d = (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1][nd] * fz0_3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3d[nd]) * t31 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31d) * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) - p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_PKY1] * fz0_3 * t31 * (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PKY3][nd] * y8 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] *
              y8d[nd])) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY1] * fz0_3 * t31 * (1.0 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PKY3] * y8) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY][nd];
          t32d = cyd[nd] * dy + cy * dyd[nd];
          byd = (stiff2d - by * t32d) * t32inv;
          svyd = (fz2d[nd] * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) + fz2
              * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY][nd] +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfzd[nd])) * gy +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PVY4] * dfz) * gyd[nd]))) * p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_LMUY] + fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY][nd];
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y9d = byd * ay + by * ayd[nd];
          t33d = c18 * y9d;
          t34d = -(eyd[nd] * y9) + (1.0 - ey) * y9d + (eyd[nd] * t33 + ey * t33d);
          t35d = c19 * t34d;
          t36d = cyd[nd] * t35 + cy * t35d;
          t37d = c23 * t36d;
          y20d[nd] = dyd[nd] * t37 + dy * t37d + svyd;
          y21d[nd] = stiff2d;
          y22d = muyd[nd];
          y23d[nd] = byd * cy + by * cyd[nd];
          t38d = (svyd - t38 * stiff2d) * stiff2inv;
          y24d[nd] = shyd[nd] + t38d;
          muy2d[nd] = y22d;
          /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
          x5d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY2][nd] * (a3 -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3]) + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_RBY2] * (a3d[nd] - pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY3][nd]);
          t39d = x5d * x5 + x5 * x5d;
          t40d = c24 * t39d;
          t41d = -(t41 * t40d * t40inv);
          stiff3d[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1][nd] * t41 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBY1] * t41d) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_RBY1] * t41 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LYKA][nd];
          e9d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REY2] * dfzd[nd]);
        }
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e9) > 1.0) {
          y10 = 1.0;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y10d[nd] = 0.0;
          }
        } else {
          y10 = e9;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y10d[nd] = e9d[nd];
          }
        }
        e8 = y10;
        s4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RHY2] * dfz;
        x6 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a3;
        t42 = 1.0 + x6 * x6;
        t43 = sqrt(t42);
        c25 = 1.0 / (2.0 * t43);
        t44 = 1.0 / t43;
        t43inv = 1.0 / t43;
        dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_RVY3] * gamma2) * t44;
        y11 = stiff3 * (kappa2 + s4);
        y12 = stiff3 * s4;
        t45 = atan(y11);
        c26 = 1.0 / (1.0 + y11 * y11);
        t46 = (1.0 - e8) * y11 + e8 * t45;
        t47 = atan(t46);
        c27 = 1.0 / (1.0 + t46 * t46);
        p7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1];
        t48 = p7 * t47;
        t49 = cos(t48);
        c28 = -sin(t48);
        t50 = atan(y12);
        c29 = 1.0 / (1.0 + y12 * y12);
        t51 = (1.0 - e8) * y12 + e8 * t50;
        t52 = atan(t51);
        c30 = 1.0 / (1.0 + t51 * t51);
        t53 = p7 * t52;
        t54 = cos(t53);
        c31 = -sin(t53);
        g30 = t49 / t54;
        t54inv = 1.0 / t54;
        t55 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2;
        t56 = atan(t55);
        c32 = 1.0 / (1.0 + t55 * t55);
        t57 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56;
        t58 = sin(t57);
        c33 = cos(t57);
        g31 = dv * t58 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA];
        x7 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2;
        t59 = 1.0 + x7 * x7;
        t60 = sqrt(t59);
        c34 = 1.0 / (2.0 * t60);
        t61 = 1.0 / t60;
        t60inv = 1.0 / t60;
        stiff4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL];
        e11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_REX2] * dfz;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double dvd, e8d, p7d, s4d, t42d, t43d, t44d, t45d, t46d, t47d, t48d, t49d, t50d, t51d,
              t52d, t53d, t54d, t55d, t56d, t57d, t58d, t59d, t60d, t61d, x6d, x7d, y11d, y12d;

          e8d = y10d[nd];
          s4d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHY2] * dfzd[nd]);
          x6d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4][nd] * a3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY4] * a3d[nd];
          t42d = x6d * x6 + x6 * x6d;
          t43d = c25 * t42d;
          t44d = -(t44 * t43d * t43inv);
          dvd = ((muy2d[nd] * fz2 + muy2 * fz2d[nd]) * (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2) + muy2 * fz2 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY2] * dfzd[nd]) +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3][nd] * gamma2 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2d[nd]))) * t44 + muy2 * fz2 *
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY1] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_RVY2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY3] * gamma2) *
              t44d;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y11d = stiff3d[nd] * (kappa2 + s4) + stiff3 * (kappa2d[nd] + s4d);
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y12d = stiff3d[nd] * s4 + stiff3 * s4d;
          t45d = c26 * y11d;
          t46d = -(e8d * y11) + (1.0 - e8) * y11d + (e8d * t45 + e8 * t45d);
          t47d = c27 * t46d;
          p7d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCY1][nd];
          t48d = p7d * t47 + p7 * t47d;
          t49d = c28 * t48d;
          t50d = c29 * y12d;
          t51d = -(e8d * y12) + (1.0 - e8) * y12d + (e8d * t50 + e8 * t50d);
          t52d = c30 * t51d;
          t53d = p7d * t52 + p7 * t52d;
          t54d = c31 * t53d;
          g30d[nd] = (t49d - g30 * t54d) * t54inv;
          t55d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6][nd] * kappa2 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY6] * kappa2d[nd];
          t56d = c32 * t55d;
          t57d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5][nd] * t56 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RVY5] * t56d;
          t58d = c33 * t57d;
          g31d[nd] = (dvd * t58 + dv * t58d) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA] +
              dv * t58 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVYKA][nd];
          /* Gxa = Fx / Fx0 */
          x7d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2][nd] * kappa2 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX2] * kappa2d[nd];
          t59d = x7d * x7 + x7 * x7d;
          t60d = c34 * t59d;
          t61d = -(t61 * t60d * t60inv);
          stiff4d[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1][nd] * t61 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RBX1] * t61d) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_RBX1] * t61 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LXAL][nd];
          e11d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_REX2] * dfzd[nd]);
        }
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e11) > 1.0) {
          y13 = 1.0;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y13d[nd] = 0.0;
          }
        } else {
          y13 = e11;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y13d[nd] = e11d[nd];
          }
        }
        e10 = y13;
        p8 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1];
        y14 = stiff4 * (a3 + p8);
        y15 = stiff4 * p8;
        t62 = atan(y14);
        c35 = 1.0 / (1.0 + y14 * y14);
        t63 = (1.0 - e10) * y14 + e10 * t62;
        t64 = atan(t63);
        c36 = 1.0 / (1.0 + t63 * t63);
        p9 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1];
        t65 = p9 * t64;
        t66 = cos(t65);
        c37 = -sin(t65);
        t67 = atan(y15);
        c38 = 1.0 / (1.0 + y15 * y15);
        t68 = (1.0 - e10) * y15 + e10 * t67;
        t69 = atan(t68);
        c39 = 1.0 / (1.0 + t68 * t68);
        t70 = p9 * t69;
        t71 = cos(t70);
        c40 = -sin(t70);
        t72 = t66 / t71;
        t71inv = 1.0 / t71;
        fx = x40 * t72;
        fy = g30 * y20 + g31;
        ratio2 = x41 * kappa2 / y21;
        y21inv = 1.0 / y21;
        bycy = y23;
        shift = y24;
        fz0_4 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] * p[t->tyreadr[t->wheeltyre[i]]];
        gz = gamma2 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ];
        at = a3 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QHZ2] * dfz + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfz) * gz;
        ar = a3 + shift;
        t73 = at * at + ratio2 * ratio2 + 1e-24;
        ateq = sqrt(t73);
        c41 = 1.0 / (2.0 * ateq);
        t74 = ar * ar + ratio2 * ratio2 + 1e-24;
        areq = sqrt(t74);
        c42 = 1.0 / (2.0 * areq);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double ard, e10d, p8d, p9d, ratio2d, shiftd, t62d, t63d, t64d, t65d, t66d, t67d, t68d,
              t69d, t70d, t71d, t72d, t73d, t74d, y14d, y15d;

          e10d = y13d[nd];
          p8d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RHX1][nd];
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y14d = stiff4d[nd] * (a3 + p8) + stiff4 * (a3d[nd] + p8d);
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y15d = stiff4d[nd] * p8 + stiff4 * p8d;
          t62d = c35 * y14d;
          t63d = -(e10d * y14) + (1.0 - e10) * y14d + (e10d * t62 + e10 * t62d);
          t64d = c36 * t63d;
          p9d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_RCX1][nd];
          t65d = p9d * t64 + p9 * t64d;
          t66d = c37 * t65d;
          t67d = c38 * y15d;
          t68d = -(e10d * y15) + (1.0 - e10) * y15d + (e10d * t67 + e10 * t67d);
          t69d = c39 * t68d;
          t70d = p9d * t69 + p9 * t69d;
          t71d = c40 * t70d;
          t72d = (t66d - t72 * t71d) * t71inv;
          fxd[nd] = x40d[nd] * t72 + x40 * t72d;
          fyd[nd] = g30d[nd] * y20 + g30 * y20d[nd] + g31d[nd];
          ratio2d = (x41d[nd] * kappa2 + x41 * kappa2d[nd] - ratio2 * y21d[nd]) * y21inv;
          bycyd[nd] = y23d[nd];
          shiftd = y24d[nd];
          /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
           *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
          fz0_4d[nd] = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO][nd] *
              p[t->tyreadr[t->wheeltyre[i]]] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LFZO] *
              pd[t->tyreadr[t->wheeltyre[i]]][nd];
          gzd[nd] = gamma2d[nd] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ] + gamma2 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LGAZ][nd];
          atd[nd] = a3d[nd] + pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ2] * dfzd[nd]) +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ4] * dfzd[nd])) * gz +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QHZ4] * dfz) * gzd[nd]);
          ard = a3d[nd] + shiftd;
          t73d = atd[nd] * at + at * atd[nd] + (ratio2d * ratio2 + ratio2 * ratio2d);
          ateqd[nd] = c41 * t73d;
          t74d = ard * ar + ar * ard + (ratio2d * ratio2 + ratio2 * ratio2d);
          areqd[nd] = c42 * t74d;
        }
        /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
         * where straight running is, and exact from w on */
        if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER])) {
          y16 = gz;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y16d[nd] = gzd[nd];
          }
        } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER]))
            {
          y16 = -gz;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y16d[nd] = -gzd[nd];
          }
        } else {
          p10 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER];
          t75 = p10 * p10;
          z6 = gz * gz / t75;
          t75inv = 1.0 / t75;
          y16 = 0.125 * p10 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            double p10d, t75d, z6d;

            p10d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_CAMBER][nd];
            t75d = p10d * p10 + p10 * p10d;
            z6d = (gzd[nd] * gz + gz * gzd[nd] - z6 * t75d) * t75inv;
            y16d[nd] = (0.125 * p10d * z6 + 0.125 * p10 * z6d) * (15.0 + z6 * (-10.0 + 3.0 * z6)) +
                0.125 * p10 * z6 * (z6d * (-10.0 + 3.0 * z6) + z6 * (3.0 * z6d));
          }
        }
        bt = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) *
            (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        inv = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t76 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
        fz0_4inv = 1.0 / fz0_4;
        dt = fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz
            + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76 *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR];
        t77 = bt * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * at;
        t78 = atan(t77);
        c43 = 1.0 / (1.0 + t77 * t77);
        e12 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfz) *
            (1.0 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double t76d, t77d, t78d;

          btd[nd] = (((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfzd[nd]) +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfzd[nd]) * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfzd[nd])) * (1.0 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_QBZ5] * y16) + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_QBZ3] * dfz * dfz) * (pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QBZ4][nd] * gz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gzd[nd]
              + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5][nd] * y16 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ5] * y16d[nd]))) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ3] * dfz * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ4] * gz + p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_QBZ5] * y16) * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY][nd] - bt
              * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY][nd]) * inv;
          t76d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS][nd] - t76 *
              fz0_4d[nd]) * fz0_4inv;
          dtd[nd] = (((fz2d[nd] * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) + fz2 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfzd[nd]))) * (1.0 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_QDZ4] * gz * gz) + fz2 * (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3][nd] * gz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gzd[nd] +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4][nd] * gz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gzd[nd]) * gz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gzd[nd]))) * t76 + fz2 *
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz
              + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ4] * gz * gz) * t76d) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LTR] + fz2 * (p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ3] * gz + p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_QDZ4] * gz * gz) * t76 * pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_LTR][nd];
          t77d = (btd[nd] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] + bt *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1][nd]) * at + bt *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * atd[nd];
          t78d = c43 * t77d;
          e12d[nd] = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ2] * dfzd[nd]) +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfzd[nd]) * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfzd[nd])) * (1.0 +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 * t78) +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ3] * dfz * dfz)
              * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5][nd] * gz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gzd[nd])) * 0.63661977236758134308
              * t78 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t78d);
        }
        /* a curvature: more than 1 would turn the curve around */
        if (MAGGI_RE(e12) > 1.0) {
          y17 = 1.0;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y17d[nd] = 0.0;
          }
        } else {
          y17 = e12;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            y17d[nd] = e12d[nd];
          }
        }
        et = y17;
        p11 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY];
        t79 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_LKY] / p11;
        p11inv = 1.0 / p11;
        br = t79 + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycy;
        dr = fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]]
            + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS] * p11;
        t80 = 1.0 + a3 * a3;
        t81 = sqrt(t80);
        c44 = 1.0 / (2.0 * t81);
        ca = 1.0 / t81;
        t81inv = 1.0 / t81;
        y18 = bt * ateq;
        t82 = atan(y18);
        c45 = 1.0 / (1.0 + y18 * y18);
        t83 = (1.0 - et) * y18 + et * t82;
        t84 = atan(t83);
        c46 = 1.0 / (1.0 + t83 * t83);
        t85 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84;
        t86 = cos(t85);
        c47 = -sin(t85);
        z30 = dt * t86 * ca;
        x8 = br * areq;
        t87 = 1.0 + x8 * x8;
        t88 = sqrt(t87);
        c48 = 1.0 / (2.0 * t88);
        t89 = 1.0 / t88;
        t88inv = 1.0 / t88;
        z31 = dr * t89 * ca;
        t90 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
        s3 = (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1] + t90 +
            (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS];
        t91 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        inv2 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED];
        way = tanh(t91);
        speed3 = one4 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        inv3 = 1.0 / p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL];
        force20 = fx;
        force21 = fy;
        force22 = fz2;
        t92 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
        force23 = r0 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
            MAGGI_TYRE_QSX2] * gamma2 + t92) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]);
        t93 = p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
        force24 = -way * r0 * fz2 * (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3 +
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3) *
            p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY];
        force25 = -z30 * (fy - g31) + z31 + s3 * fx;
        rolling0 = force20;
        rolling1 = side * force21;
        rolling2 = force22;
        rolling3 = side * force23;
        rolling4 = force24;
        rolling5 = side * force25;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double brd, cad, drd, etd, force20d, force21d, force22d, force23d, force24d, force25d,
              p11d, s3d, speed3d, t79d, t80d, t81d, t82d, t83d, t84d, t85d, t86d, t87d, t88d, t89d,
              t90d, t91d, t92d, t93d, wayd, x8d, y18d, z30d, z31d;

          etd = y17d[nd];
          p11d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMUY][nd];
          t79d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ9][nd] *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QBZ9] * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LKY][nd] - t79 * p11d)
              * p11inv;
          brd = t79d + (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10][nd] * bycy +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QBZ10] * bycyd[nd]);
          drd = ((fz2d[nd] * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) + fz2
              * ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfzd[nd])) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES][nd] +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfzd[nd])) * gz +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ9] * dfz) * gzd[nd]))) * p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_UNLOADED_RADIUS] + fz2 * ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6]
              + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_UNLOADED_RADIUS][nd]) * p11 + fz2 *
              ((p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LRES] +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QDZ9] * dfz) * gz) * p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_UNLOADED_RADIUS] * p11d;
          t80d = a3d[nd] * a3 + a3 * a3d[nd];
          t81d = c44 * t80d;
          cad = -(ca * t81d * t81inv);
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          y18d = btd[nd] * ateq + bt * ateqd[nd];
          t82d = c45 * y18d;
          t83d = -(etd * y18) + (1.0 - et) * y18d + (etd * t82 + et * t82d);
          t84d = c46 * t83d;
          t85d = pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1][nd] * t84 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QCZ1] * t84d;
          t86d = c47 * t85d;
          z30d = (dtd[nd] * t86 + dt * t86d) * ca + dt * t86 * cad;
          x8d = brd * areq + br * areqd[nd];
          t87d = x8d * x8 + x8 * x8d;
          t88d = c48 * t87d;
          t89d = -(t89 * t88d * t88inv);
          z31d = (drd * t89 + dr * t89d) * ca + dr * t89 * cad;
          t90d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2][nd] * fy +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ2] * fyd[nd] - t90 * fz0_2d[nd]) *
              fz0_2inv;
          s3d = ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ1][nd] + t90d +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3][nd] +
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4][nd] * dfz +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfzd[nd])) * gamma2 +
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2d[nd])) * r0 + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0d[nd]) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS] + (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_SSZ1] + t90 + (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LS][nd];
          t91d = (one4d[nd] - t91 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LOW_SPEED][nd]) *
              inv2;
          wayd = (1.0 - way * way) * t91d;
          speed3d = (one4d[nd] - speed3 * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LONGVL][nd]) *
              inv3;
          force20d = fxd[nd];
          force21d = fyd[nd];
          force22d = fz2d[nd];
          t92d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3][nd] * fy +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX3] * fyd[nd] - t92 * fz0_2d[nd]) *
              fz0_2inv;
          force23d = (r0d[nd] * fz2 + r0 * fz2d[nd]) * (p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QSX1] * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX] +
              (-p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma2 + t92) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX]) + r0 * fz2 *
              (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1][nd] * p[t->tyreadr[t->wheeltyre[i]]
              + MAGGI_TYRE_LVMX] + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX1] *
              pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LVMX][nd] +
              ((-(pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2][nd] * gamma2) -
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSX2] * gamma2d[nd] + t92d) *
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMX] + (-p[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_QSX2] * gamma2 + t92) * pd[t->tyreadr[t->wheeltyre[i]] +
              MAGGI_TYRE_LMX][nd]));
          t93d = (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2][nd] * fx +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY2] * fxd[nd] - t93 * fz0_2d[nd]) *
              fz0_2inv;
          force24d = (((-(wayd * r0) - way * r0d[nd]) * fz2 + -way * r0 * fz2d[nd]) *
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3)
              + -way * r0 * fz2 * (pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1][nd] + t93d +
              ((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3][nd] * way +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * wayd) * speed3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3d) +
              ((((pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4][nd] * speed3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3d) * speed3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3d) * speed3
              + p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
              speed3d))) * p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY] + -way * r0 * fz2 *
              (p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY1] + t93 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 * speed3)
              * pd[t->tyreadr[t->wheeltyre[i]] + MAGGI_TYRE_LMY][nd];
          force25d = -(z30d * (fy - g31)) - z30 * (fyd[nd] - g31d[nd]) + z31d + (s3d * fx + s3 *
              fxd[nd]);
          rolling0d[nd] = force20d;
          rolling1d[nd] = side * force21d;
          rolling2d[nd] = force22d;
          rolling3d[nd] = side * force23d;
          rolling4d[nd] = force24d;
          rolling5d[nd] = side * force25d;
        }
      } else {
        rolling0 = 0.0;
        rolling1 = 0.0;
        rolling2 = fz;
        rolling3 = 0.0;
        rolling4 = 0.0;
        rolling5 = 0.0;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          rolling0d[nd] = 0.0;
          rolling1d[nd] = 0.0;
          rolling2d[nd] = fzd[nd];
          rolling3d[nd] = 0.0;
          rolling4d[nd] = 0.0;
          rolling5d[nd] = 0.0;
        }
      }
    } else {
      rolling0 = 0.0;
      rolling1 = 0.0;
      rolling2 = 0.0;
      rolling3 = 0.0;
      rolling4 = 0.0;
      rolling5 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        rolling0d[nd] = 0.0;
        rolling1d[nd] = 0.0;
        rolling2d[nd] = 0.0;
        rolling3d[nd] = 0.0;
        rolling4d[nd] = 0.0;
        rolling5d[nd] = 0.0;
      }
    }
    r30 = r[t->wheelpoint[i]][0] + arm0;
    force30 = rolling0 * T0 + rolling1 * L0 + rolling2 * N0;
    r31 = r[t->wheelpoint[i]][1] + arm1;
    force31 = rolling0 * T1 + rolling1 * L1 + rolling2 * N1;
    r32 = r[t->wheelpoint[i]][2] + arm2;
    force32 = rolling0 * T2 + rolling1 * L2 + rolling2 * N2;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double force30d, force31d, force32d, moment0d, moment1d, moment2d, r30d, r31d, r32d;

      /* at the contact point on the wheel:  f_x T + f_y L + f_z N;  power of all of it, springs of tyres too */
      r30d = rd[t->wheelpoint[i]][0][nd] + arm0d[nd];
      force30d = rolling0d[nd] * T0 + rolling0 * T0d[nd] + (rolling1d[nd] * L0 + rolling1 * L0d[nd])
          + (rolling2d[nd] * N0 + rolling2 * N0d[nd]);
      moment0d = rolling3d[nd] * T0 + rolling3 * T0d[nd] + (rolling4d[nd] * L0 + rolling4 * L0d[nd])
          + (rolling5d[nd] * N0 + rolling5 * N0d[nd]);
      r31d = rd[t->wheelpoint[i]][1][nd] + arm1d[nd];
      force31d = rolling0d[nd] * T1 + rolling0 * T1d[nd] + (rolling1d[nd] * L1 + rolling1 * L1d[nd])
          + rolling2d[nd] * N1;
      moment1d = rolling3d[nd] * T1 + rolling3 * T1d[nd] + (rolling4d[nd] * L1 + rolling4 * L1d[nd])
          + rolling5d[nd] * N1;
      r32d = rd[t->wheelpoint[i]][2][nd] + arm2d[nd];
      force32d = rolling0d[nd] * T2 + rolling0 * T2d[nd] + (rolling1d[nd] * L2 + rolling1 * L2d[nd])
          + (rolling2d[nd] * N2 + rolling2 * N2d[nd]);
      moment2d = rolling3d[nd] * T2 + rolling3 * T2d[nd] + (rolling4d[nd] * L2 + rolling4 * L2d[nd])
          + (rolling5d[nd] * N2 + rolling5 * N2d[nd]);
      Qd[a6][0][nd] += force30d;
      Qd[a6][1][nd] += force31d;
      Qd[a6][2][nd] += force32d;
      Qd[a6][3][nd] += r31d * force32 + r31 * force32d - (r32d * force31 + r32 * force31d);
      Qd[a6][4][nd] += r32d * force30 + r32 * force30d - (r30d * force32 + r30 * force32d);
      Qd[a6][5][nd] += r30d * force31 + r30 * force31d - (r31d * force30 + r31 * force30d);
      Qd[a6][3][nd] += moment0d;
      Qd[a6][4][nd] += moment1d;
      Qd[a6][5][nd] += moment2d;
    }
  }
}
