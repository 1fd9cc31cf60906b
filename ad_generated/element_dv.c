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
                             const double r[restrict t->npoint][3],
                             const double rd[restrict t->npoint][3][MAGGI_NDIR],
                             const double rv[restrict t->npoint][3],
                             const double rvd[restrict t->npoint][3][MAGGI_NDIR],
                             const double roll[restrict t->nwheel][6],
                             const double rolld[restrict t->nwheel][6][MAGGI_NDIR],
                             double Q[restrict t->nbody + 1][6],
                             double Qd[restrict t->nbody + 1][6][MAGGI_NDIR],
                             double tau[restrict t->nq], double taud[restrict t->nq][MAGGI_NDIR],
                             double power[restrict 1], int nbdirs)
{
  int a, a2, a3, a3_2, a4, adr, adr2, b, b2, b3, i, k, k2, k8, nd;
  double back0, back1, back20, back21, back22, back2_2, c, c20, c21, c22, c3, c4, damping, e0, e1,
      e2, ev0, ev1, ev2, f0, f1, f2, f3, force0, force1, force2, g0, g1, g2, l, linv, lv, n20, n21,
      n22, p2, p_adr2, p_k24, p_k25, r_a0, r_a1, r_a2, r_b0, r_b1, r_b2, r_i0, r_i1, r_i2, s, speed,
      t2, t3, u0, u1, u20, u21, u22, u2_2, x, xv;
  double c20d[MAGGI_NDIR], c21d[MAGGI_NDIR], c22d[MAGGI_NDIR], dampingd[MAGGI_NDIR],
      f0d[MAGGI_NDIR], f1d[MAGGI_NDIR], f2d[MAGGI_NDIR], g0d[MAGGI_NDIR], g1d[MAGGI_NDIR],
      g2d[MAGGI_NDIR], ld[MAGGI_NDIR], lvd[MAGGI_NDIR], n20d[MAGGI_NDIR], n21d[MAGGI_NDIR],
      n22d[MAGGI_NDIR], sd[MAGGI_NDIR], torque0d[MAGGI_NDIR], xd[MAGGI_NDIR], xvd[MAGGI_NDIR];

  (void)Z;
  (void)roll;
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
    e2 = r[a][2] - r[b][2];
    ev2 = rv[a][2] - rv[b][2];
    t2 = e0 * e0 + e1 * e1 + e2 * e2;
    l = sqrt(t2);
    c3 = 1.0 / (2.0 * l);
    n20 = e0 / l;
    linv = 1.0 / l;
    n21 = e1 / l;
    n22 = e2 / l;
    lv = n20 * ev0 + n21 * ev1 + n22 * ev2;
    damping = p[t->springadr[i] + MAGGI_SPRING_C] * lv;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double e0d, e1d, e2d, ev0d, ev1d, ev2d, t2d;

      e0d = rd[a][0][nd] - rd[b][0][nd];
      ev0d = rvd[a][0][nd] - rvd[b][0][nd];
      e1d = rd[a][1][nd] - rd[b][1][nd];
      ev1d = rvd[a][1][nd] - rvd[b][1][nd];
      e2d = rd[a][2][nd] - rd[b][2][nd];
      ev2d = rvd[a][2][nd] - rvd[b][2][nd];
      t2d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2d * e2 + e2 * e2d);
      ld[nd] = c3 * t2d;
      n20d[nd] = (e0d - n20 * ld[nd]) * linv;
      n21d[nd] = (e1d - n21 * ld[nd]) * linv;
      n22d[nd] = (e2d - n22 * ld[nd]) * linv;
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
    force2 = f3 * u2_2;
    back2_2 = -f3 * u2_2;
    r_a1 = r[a][1];
    r_a2 = r[a][2];
    r_a0 = r[a][0];
    r_b1 = r[b][1];
    r_b2 = r[b][2];
    r_b0 = r[b][0];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double back0d, back1d, back2_2d, f3d, force0d, force1d, force2d, r_a0d, r_a1d, r_a2d, r_b0d,
          r_b1d, r_b2d, u0d, u1d, u2_2d;

      u0d = n20d[nd];
      u1d = n21d[nd];
      u2_2d = n22d[nd];
      f3d = f0d[nd] + f1d[nd];
      force0d = f3d * u0 + f3 * u0d;
      back0d = -(f3d * u0) - f3 * u0d;
      force1d = f3d * u1 + f3 * u1d;
      back1d = -(f3d * u1) - f3 * u1d;
      force2d = f3d * u2_2 + f3 * u2_2d;
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
      Qd[t->pointbody[b]][2][nd] += force2d;
      r_b1d = rd[b][1][nd];
      r_b2d = rd[b][2][nd];
      Qd[t->pointbody[b]][3][nd] += r_b1d * force2 + r_b1 * force2d - (r_b2d * force1 + r_b2 *
          force1d);
      r_b0d = rd[b][0][nd];
      Qd[t->pointbody[b]][4][nd] += r_b2d * force0 + r_b2 * force0d - (r_b0d * force2 + r_b0 *
          force2d);
      Qd[t->pointbody[b]][5][nd] += r_b0d * force1 + r_b0 * force1d - (r_b1d * force0 + r_b1 *
          force0d);
    }
  }
  for (i = 0; i < t->njspring; ++i) {
    a2 = t->jspringq[i];
    b2 = t->jspringq2[i];
    adr = t->jspringadr[i];
    if (b2 >= 0) {
      x = q[a2] - q[b2];
      xv = v[a2] - v[b2];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        xd[nd] = qd[a2][nd] - qd[b2][nd];
        xvd[nd] = vd[a2][nd] - vd[b2][nd];
      }
    } else {
      x = q[a2];
      xv = v[a2];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        xd[nd] = qd[a2][nd];
        xvd[nd] = vd[a2][nd];
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      torque0d[nd] = -(pd[adr][nd] * (x - p[adr + MAGGI_JSPRING_REST])) - p[adr] * (xd[nd] - pd[adr
          + MAGGI_JSPRING_REST][nd]) - (pd[adr + MAGGI_JSPRING_C][nd] * xv + p[adr +
          MAGGI_JSPRING_C] * xvd[nd]) - pd[adr + MAGGI_JSPRING_PRELOAD][nd];
      taud[a2][nd] += torque0d[nd];
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
      a3 = t->forceq[i];
      p_adr2 = p[adr2];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double p_adr2d;

        p_adr2d = pd[adr2][nd];
        taud[a3][nd] += p_adr2d * s + p_adr2 * sd[nd];
      }
    } else {
      a3_2 = t->forcebody[i];
      b3 = t->forcereaction[i];
      if (t->forcekind[i] == MAGGI_FORCE_DRAG) {
        u20 = rv[t->forcepoint[i]][0] - p[adr2 + MAGGI_DRAG_WIND];
        u21 = rv[t->forcepoint[i]][1] - p[adr2 + MAGGI_DRAG_WIND + 1];
        u22 = rv[t->forcepoint[i]][2] - p[adr2 + MAGGI_DRAG_WIND + 2];
        p2 = p[adr2 + MAGGI_DRAG_LOW];
        t3 = u20 * u20 + u21 * u21 + u22 * u22 + p2 * p2;
        speed = sqrt(t3);
        c4 = 1.0 / (2.0 * speed);
        c = 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * s;
        g0 = -c * speed * u20;
        g1 = -c * speed * u21;
        g2 = -c * speed * u22;
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
          speedd = c4 * t3d;
          cd = ((0.5 * pd[adr2][nd] * p[adr2 + MAGGI_DRAG_C] + 0.5 * p[adr2] * pd[adr2 +
              MAGGI_DRAG_C][nd]) * p[adr2 + MAGGI_DRAG_AREA] + 0.5 * p[adr2] * p[adr2 +
              MAGGI_DRAG_C] * pd[adr2 + MAGGI_DRAG_AREA][nd]) * s + 0.5 * p[adr2] * p[adr2 +
              MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * sd[nd];
          g0d[nd] = (-(cd * speed) - c * speedd) * u20 + -c * speed * u20d;
          g1d[nd] = (-(cd * speed) - c * speedd) * u21 + -c * speed * u21d;
          g2d[nd] = (-(cd * speed) - c * speedd) * u22 + -c * speed * u22d;
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
          g0 = A[a3_2][0] * c20 + A[a3_2][1] * c21 + A[a3_2][2] * c22;
          g1 = A[a3_2][3] * c20 + A[a3_2][4] * c21 + A[a3_2][5] * c22;
          g2 = A[a3_2][6] * c20 + A[a3_2][7] * c21 + A[a3_2][8] * c22;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            g0d[nd] = Ad[a3_2][0][nd] * c20 + A[a3_2][0] * c20d[nd] + (Ad[a3_2][1][nd] * c21 +
                A[a3_2][1] * c21d[nd]) + (Ad[a3_2][2][nd] * c22 + A[a3_2][2] * c22d[nd]);
            g1d[nd] = Ad[a3_2][3][nd] * c20 + A[a3_2][3] * c20d[nd] + (Ad[a3_2][4][nd] * c21 +
                A[a3_2][4] * c21d[nd]) + (Ad[a3_2][5][nd] * c22 + A[a3_2][5] * c22d[nd]);
            g2d[nd] = Ad[a3_2][6][nd] * c20 + A[a3_2][6] * c20d[nd] + (Ad[a3_2][7][nd] * c21 +
                A[a3_2][7] * c21d[nd]) + (Ad[a3_2][8][nd] * c22 + A[a3_2][8] * c22d[nd]);
          }
        } else {
          g0 = c20;
          g1 = c21;
          g2 = c22;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            g0d[nd] = c20d[nd];
            g1d[nd] = c21d[nd];
            g2d[nd] = c22d[nd];
          }
        }
      }
      if (t->forcepoint[i] >= 0) {
        back20 = -g0;
        back21 = -g1;
        back22 = -g2;
        r_i1 = r[t->forcepoint[i]][1];
        r_i2 = r[t->forcepoint[i]][2];
        r_i0 = r[t->forcepoint[i]][0];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double back20d, back21d, back22d, r_i0d, r_i1d, r_i2d;

          /* force at r, or pure torque, on one body and back on another; returns its power */
          back20d = -g0d[nd];
          back21d = -g1d[nd];
          back22d = -g2d[nd];
          Qd[a3_2][0][nd] += g0d[nd];
          Qd[a3_2][1][nd] += g1d[nd];
          Qd[a3_2][2][nd] += g2d[nd];
          r_i1d = rd[t->forcepoint[i]][1][nd];
          r_i2d = rd[t->forcepoint[i]][2][nd];
          Qd[a3_2][3][nd] += r_i1d * g2 + r_i1 * g2d[nd] - (r_i2d * g1 + r_i2 * g1d[nd]);
          r_i0d = rd[t->forcepoint[i]][0][nd];
          Qd[a3_2][4][nd] += r_i2d * g0 + r_i2 * g0d[nd] - (r_i0d * g2 + r_i0 * g2d[nd]);
          Qd[a3_2][5][nd] += r_i0d * g1 + r_i0 * g1d[nd] - (r_i1d * g0 + r_i1 * g0d[nd]);
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
          Qd[a3_2][3][nd] += g0d[nd];
          Qd[b3][3][nd] -= g0d[nd];
          Qd[a3_2][4][nd] += g1d[nd];
          Qd[b3][4][nd] -= g1d[nd];
          Qd[a3_2][5][nd] += g2d[nd];
          Qd[b3][5][nd] -= g2d[nd];
        }
      }
    }
  }
  /* power of all of it, springs of tyres too */
  for (i = 0; i < t->nwheel; ++i) {
    a4 = t->wheelbody[i];
    for (k8 = 0; k8 < 6; ++k8) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        Qd[a4][k8][nd] += rolld[i][k8][nd];
      }
    }
  }
}
