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
                            const double r[restrict t->npoint][3],
                            const double rd[restrict t->npoint][3],
                            const double rv[restrict t->npoint][3],
                            const double rvd[restrict t->npoint][3],
                            const double roll[restrict t->nwheel][6],
                            const double rolld[restrict t->nwheel][6],
                            double Q[restrict t->nbody + 1][6], double Qd[restrict t->nbody + 1][6],
                            double tau[restrict t->nq], double taud[restrict t->nq],
                            double power[restrict 1])
{
  int a, a2, a3, a3_2, a4, adr, adr2, b, b2, b3, i, k, k2, k8;
  double back0, back0d, back1, back1d, back20, back20d, back21, back21d, back22, back22d, back2_2,
      back2_2d, c, c20, c20d, c21, c21d, c22, c22d, c3, c4, cd, damping, dampingd, e0, e0d, e1, e1d,
      e2, e2d, ev0, ev0d, ev1, ev1d, ev2, ev2d, f0, f0d, f1, f1d, f2, f2d, f3, f3d, force0, force0d,
      force1, force1d, force2, force2d, g0, g0d, g1, g1d, g2, g2d, l, ld, linv, lv, lvd, n20, n20d,
      n21, n21d, n22, n22d, p2, p2d, p_adr2, p_adr2d, p_k24, p_k24d, p_k25, p_k25d, r_a0, r_a0d,
      r_a1, r_a1d, r_a2, r_a2d, r_b0, r_b0d, r_b1, r_b1d, r_b2, r_b2d, r_i0, r_i0d, r_i1, r_i1d,
      r_i2, r_i2d, s, sd, speed, speedd, t2, t2d, t3, t3d, torque0d, u0, u0d, u1, u1d, u20, u20d,
      u21, u21d, u22, u22d, u2_2, u2_2d, x, xd, xv, xvd;

  (void)Z;
  (void)roll;
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
    e2 = r[a][2] - r[b][2];
    e2d = rd[a][2] - rd[b][2];
    ev2 = rv[a][2] - rv[b][2];
    ev2d = rvd[a][2] - rvd[b][2];
    t2 = e0 * e0 + e1 * e1 + e2 * e2;
    t2d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2d * e2 + e2 * e2d);
    l = sqrt(t2);
    c3 = 1.0 / (2.0 * l);
    ld = c3 * t2d;
    n20 = e0 / l;
    linv = 1.0 / l;
    n20d = (e0d - n20 * ld) * linv;
    n21 = e1 / l;
    n21d = (e1d - n21 * ld) * linv;
    n22 = e2 / l;
    n22d = (e2d - n22 * ld) * linv;
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
    force2 = f3 * u2_2;
    force2d = f3d * u2_2 + f3 * u2_2d;
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
    Qd[t->pointbody[b]][2] += force2d;
    r_b1 = r[b][1];
    r_b1d = rd[b][1];
    r_b2 = r[b][2];
    r_b2d = rd[b][2];
    Qd[t->pointbody[b]][3] += r_b1d * force2 + r_b1 * force2d - (r_b2d * force1 + r_b2 * force1d);
    r_b0 = r[b][0];
    r_b0d = rd[b][0];
    Qd[t->pointbody[b]][4] += r_b2d * force0 + r_b2 * force0d - (r_b0d * force2 + r_b0 * force2d);
    Qd[t->pointbody[b]][5] += r_b0d * force1 + r_b0 * force1d - (r_b1d * force0 + r_b1 * force0d);
  }
  for (i = 0; i < t->njspring; ++i) {
    a2 = t->jspringq[i];
    b2 = t->jspringq2[i];
    adr = t->jspringadr[i];
    if (b2 >= 0) {
      x = q[a2] - q[b2];
      xd = qd[a2] - qd[b2];
      xv = v[a2] - v[b2];
      xvd = vd[a2] - vd[b2];
    } else {
      x = q[a2];
      xd = qd[a2];
      xv = v[a2];
      xvd = vd[a2];
    }
    torque0d = -(pd[adr] * (x - p[adr + MAGGI_JSPRING_REST])) - p[adr] * (xd - pd[adr +
        MAGGI_JSPRING_REST]) - (pd[adr + MAGGI_JSPRING_C] * xv + p[adr + MAGGI_JSPRING_C] * xvd) -
        pd[adr + MAGGI_JSPRING_PRELOAD];
    taud[a2] += torque0d;
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
      a3 = t->forceq[i];
      p_adr2 = p[adr2];
      p_adr2d = pd[adr2];
      taud[a3] += p_adr2d * s + p_adr2 * sd;
    } else {
      a3_2 = t->forcebody[i];
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
        c4 = 1.0 / (2.0 * speed);
        speedd = c4 * t3d;
        c = 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * s;
        cd = ((0.5 * pd[adr2] * p[adr2 + MAGGI_DRAG_C] + 0.5 * p[adr2] * pd[adr2 + MAGGI_DRAG_C]) *
            p[adr2 + MAGGI_DRAG_AREA] + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * pd[adr2 +
            MAGGI_DRAG_AREA]) * s + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 +
            MAGGI_DRAG_AREA] * sd;
        g0 = -c * speed * u20;
        g0d = (-(cd * speed) - c * speedd) * u20 + -c * speed * u20d;
        g1 = -c * speed * u21;
        g1d = (-(cd * speed) - c * speedd) * u21 + -c * speed * u21d;
        g2 = -c * speed * u22;
        g2d = (-(cd * speed) - c * speedd) * u22 + -c * speed * u22d;
      } else {
        c20 = p[adr2] * s;
        c20d = pd[adr2] * s + p[adr2] * sd;
        c21 = p[adr2 + 1] * s;
        c21d = pd[adr2 + 1] * s + p[adr2 + 1] * sd;
        c22 = p[adr2 + 2] * s;
        c22d = pd[adr2 + 2] * s + p[adr2 + 2] * sd;
        if (t->forcekind[i] == MAGGI_FORCE_BODY || t->forcekind[i] == MAGGI_TORQUE_BODY) {
          g0 = A[a3_2][0] * c20 + A[a3_2][1] * c21 + A[a3_2][2] * c22;
          g0d = Ad[a3_2][0] * c20 + A[a3_2][0] * c20d + (Ad[a3_2][1] * c21 + A[a3_2][1] * c21d) +
              (Ad[a3_2][2] * c22 + A[a3_2][2] * c22d);
          g1 = A[a3_2][3] * c20 + A[a3_2][4] * c21 + A[a3_2][5] * c22;
          g1d = Ad[a3_2][3] * c20 + A[a3_2][3] * c20d + (Ad[a3_2][4] * c21 + A[a3_2][4] * c21d) +
              (Ad[a3_2][5] * c22 + A[a3_2][5] * c22d);
          g2 = A[a3_2][6] * c20 + A[a3_2][7] * c21 + A[a3_2][8] * c22;
          g2d = Ad[a3_2][6] * c20 + A[a3_2][6] * c20d + (Ad[a3_2][7] * c21 + A[a3_2][7] * c21d) +
              (Ad[a3_2][8] * c22 + A[a3_2][8] * c22d);
        } else {
          g0 = c20;
          g0d = c20d;
          g1 = c21;
          g1d = c21d;
          g2 = c22;
          g2d = c22d;
        }
      }
      if (t->forcepoint[i] >= 0) {
        back20 = -g0;
        /* force at r, or pure torque, on one body and back on another; returns its power */
        back20d = -g0d;
        back21 = -g1;
        back21d = -g1d;
        back22 = -g2;
        back22d = -g2d;
        Qd[a3_2][0] += g0d;
        Qd[a3_2][1] += g1d;
        Qd[a3_2][2] += g2d;
        r_i1 = r[t->forcepoint[i]][1];
        r_i1d = rd[t->forcepoint[i]][1];
        r_i2 = r[t->forcepoint[i]][2];
        r_i2d = rd[t->forcepoint[i]][2];
        Qd[a3_2][3] += r_i1d * g2 + r_i1 * g2d - (r_i2d * g1 + r_i2 * g1d);
        r_i0 = r[t->forcepoint[i]][0];
        r_i0d = rd[t->forcepoint[i]][0];
        Qd[a3_2][4] += r_i2d * g0 + r_i2 * g0d - (r_i0d * g2 + r_i0 * g2d);
        Qd[a3_2][5] += r_i0d * g1 + r_i0 * g1d - (r_i1d * g0 + r_i1 * g0d);
        Qd[b3][0] += back20d;
        Qd[b3][1] += back21d;
        Qd[b3][2] += back22d;
        Qd[b3][3] += r_i1d * back22 + r_i1 * back22d - (r_i2d * back21 + r_i2 * back21d);
        Qd[b3][4] += r_i2d * back20 + r_i2 * back20d - (r_i0d * back22 + r_i0 * back22d);
        Qd[b3][5] += r_i0d * back21 + r_i0 * back21d - (r_i1d * back20 + r_i1 * back20d);
      } else {
        /* force at r, or pure torque, on one body and back on another; returns its power */
        Qd[a3_2][3] += g0d;
        Qd[b3][3] -= g0d;
        Qd[a3_2][4] += g1d;
        Qd[b3][4] -= g1d;
        Qd[a3_2][5] += g2d;
        Qd[b3][5] -= g2d;
      }
    }
  }
  /* power of all of it, springs of tyres too */
  for (i = 0; i < t->nwheel; ++i) {
    a4 = t->wheelbody[i];
    for (k8 = 0; k8 < 6; ++k8) {
      Qd[a4][k8] += rolld[i][k8];
    }
  }
}
