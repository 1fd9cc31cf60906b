/* Adjoint of core/kernel/element.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

void maggi_element_forces_b(const maggi_topo *t, const double p[restrict t->np],
                            double pb[restrict t->np], const double fun[restrict t->nfun][3],
                            double funb[restrict t->nfun][3],
                            const double spring0[restrict t->nspring],
                            double spring0b[restrict t->nspring], const double q[restrict t->nq],
                            double qb[restrict t->nq], const double v[restrict t->nq],
                            double vb[restrict t->nq], const double A[restrict t->nbody + 1][9],
                            double Ab[restrict t->nbody + 1][9],
                            const double Z[restrict t->nbody + 1][6],
                            const double r[restrict t->npoint][3], double rb[restrict t->npoint][3],
                            const double rv[restrict t->npoint][3],
                            double rvb[restrict t->npoint][3],
                            const double roll[restrict t->nwheel][6],
                            double rollb[restrict t->nwheel][6], double Q[restrict t->nbody + 1][6],
                            double Qb[restrict t->nbody + 1][6], double tau[restrict t->nq],
                            double taub[restrict t->nq], double power[restrict 1])
{
  int a, a2, a3, a3_2, a4, adr, adr2, b, b2, b3, i, k, k2, k8;
  double back0, back0b, back1, back1b, back20, back20b, back21, back21b, back22, back22b, back2_2,
      back2_2b, c, c20, c20b, c21, c21b, c22, c22b, cb, damping, dampingb, e0, e0b, e1, e1b, e2,
      e2b, ev0, ev0b, ev1, ev1b, ev2, ev2b, f0, f0b, f1, f1b, f2, f2b, f3, f3b, force0, force0b,
      force1, force1b, force2, force2b, g0, g0b, g1, g1b, g2, g2b, l, lb, lv, lvb, n20, n20b, n21,
      n21b, n22, n22b, p2, p2b, p_adr2, p_adr2b, p_k24, p_k24b, p_k25, p_k25b, r_a0, r_a0b, r_a1,
      r_a1b, r_a2, r_a2b, r_b0, r_b0b, r_b1, r_b1b, r_b2, r_b2b, r_i0, r_i0b, r_i1, r_i1b, r_i2,
      r_i2b, s, sb, speed, speedb, t2, t2b, t3, t3b, tb10, tb11, tb12, tb13, tb14, tb15, tb16, tb17,
      tb18, tb19, tb2, tb20, tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb3, tb4, tb5, tb6, tb7, tb8,
      tb9, torque0b, u0, u0b, u1, u1b, u20, u20b, u21, u21b, u22, u22b, u2_2, u2_2b, x, xb, xv, xvb;

  (void)Z;
  (void)roll;
  (void)Q;
  (void)tau;
  (void)power;
  /* power of all of it, springs of tyres too */
  for (i = t->nwheel - 1; i >= 0; --i) {
    a4 = t->wheelbody[i];
    for (k8 = 5; k8 >= 0; --k8) {
      rollb[i][k8] += Qb[a4][k8];
    }
  }
  for (i = t->nforce - 1; i >= 0; --i) {
    adr2 = t->forceadr[i];
    if (t->forcefun[i] >= 0) {
      s = fun[t->forcefun[i]][0];
    } else {
      s = 1.0;
    }
    sb = 0.0;
    if (t->forcekind[i] == MAGGI_FORCE_JOINT) {
      a3 = t->forceq[i];
      p_adr2 = p[adr2];
      tb16 = taub[a3];
      p_adr2b = tb16 * s;
      sb += tb16 * p_adr2;
      pb[adr2] += p_adr2b;
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
        c = 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * s;
        g0 = -c * speed * u20;
        g1 = -c * speed * u21;
        g2 = -c * speed * u22;
      } else {
        c20 = p[adr2] * s;
        c21 = p[adr2 + 1] * s;
        c22 = p[adr2 + 2] * s;
        if (t->forcekind[i] == MAGGI_FORCE_BODY || t->forcekind[i] == MAGGI_TORQUE_BODY) {
          g0 = A[a3_2][0] * c20 + A[a3_2][1] * c21 + A[a3_2][2] * c22;
          g1 = A[a3_2][3] * c20 + A[a3_2][4] * c21 + A[a3_2][5] * c22;
          g2 = A[a3_2][6] * c20 + A[a3_2][7] * c21 + A[a3_2][8] * c22;
        } else {
          g0 = c20;
          g1 = c21;
          g2 = c22;
        }
      }
      g0b = 0.0;
      g1b = 0.0;
      g2b = 0.0;
      if (t->forcepoint[i] >= 0) {
        back20 = -g0;
        back21 = -g1;
        back22 = -g2;
        r_i1 = r[t->forcepoint[i]][1];
        r_i2 = r[t->forcepoint[i]][2];
        r_i0 = r[t->forcepoint[i]][0];
        tb27 = Qb[b3][5];
        r_i0b = tb27 * back21;
        back21b = tb27 * r_i0;
        r_i1b = -(tb27 * back20);
        back20b = -(tb27 * r_i1);
        tb26 = Qb[b3][4];
        r_i2b = tb26 * back20;
        back20b += tb26 * r_i2;
        r_i0b -= tb26 * back22;
        back22b = -(tb26 * r_i0);
        tb25 = Qb[b3][3];
        r_i1b += tb25 * back22;
        back22b += tb25 * r_i1;
        r_i2b -= tb25 * back21;
        back21b -= tb25 * r_i2;
        back22b += Qb[b3][2];
        back21b += Qb[b3][1];
        back20b += Qb[b3][0];
        tb24 = Qb[a3_2][5];
        r_i0b += tb24 * g1;
        g1b += tb24 * r_i0;
        r_i1b -= tb24 * g0;
        g0b -= tb24 * r_i1;
        tb23 = Qb[a3_2][4];
        r_i2b += tb23 * g0;
        g0b += tb23 * r_i2;
        r_i0b -= tb23 * g2;
        g2b -= tb23 * r_i0;
        rb[t->forcepoint[i]][0] += r_i0b;
        tb22 = Qb[a3_2][3];
        r_i1b += tb22 * g2;
        g2b += tb22 * r_i1;
        r_i2b -= tb22 * g1;
        g1b -= tb22 * r_i2;
        rb[t->forcepoint[i]][2] += r_i2b;
        rb[t->forcepoint[i]][1] += r_i1b;
        g2b += Qb[a3_2][2];
        g1b += Qb[a3_2][1];
        g0b += Qb[a3_2][0];
        g2b -= back22b;
        g1b -= back21b;
        /* force at r, or pure torque, on one body and back on another; returns its power */
        g0b -= back20b;
      } else {
        g2b -= Qb[b3][5];
        g2b += Qb[a3_2][5];
        g1b -= Qb[b3][4];
        g1b += Qb[a3_2][4];
        g0b -= Qb[b3][3];
        g0b += Qb[a3_2][3];
      }
      if (t->forcekind[i] == MAGGI_FORCE_DRAG) {
        u20 = rv[t->forcepoint[i]][0] - p[adr2 + MAGGI_DRAG_WIND];
        u21 = rv[t->forcepoint[i]][1] - p[adr2 + MAGGI_DRAG_WIND + 1];
        u22 = rv[t->forcepoint[i]][2] - p[adr2 + MAGGI_DRAG_WIND + 2];
        p2 = p[adr2 + MAGGI_DRAG_LOW];
        t3 = u20 * u20 + u21 * u21 + u22 * u22 + p2 * p2;
        speed = sqrt(t3);
        c = 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * s;
        tb21 = g2b * u22;
        cb = -(tb21 * speed);
        speedb = -(tb21 * c);
        u22b = g2b * (-c * speed);
        g2b = 0.0;
        tb20 = g1b * u21;
        cb -= tb20 * speed;
        speedb -= tb20 * c;
        u21b = g1b * (-c * speed);
        g1b = 0.0;
        tb19 = g0b * u20;
        cb -= tb19 * speed;
        speedb -= tb19 * c;
        u20b = g0b * (-c * speed);
        g0b = 0.0;
        tb17 = cb * s;
        tb18 = tb17 * p[adr2 + MAGGI_DRAG_AREA];
        pb[adr2] += tb18 * p[adr2 + MAGGI_DRAG_C] * 0.5;
        pb[adr2 + MAGGI_DRAG_C] += tb18 * (0.5 * p[adr2]);
        pb[adr2 + MAGGI_DRAG_AREA] += tb17 * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C]);
        sb += cb * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA]);
        t3b = speedb * (1.0 / (2.0 * speed));
        u20b += t3b * u20;
        u20b += t3b * u20;
        u21b += t3b * u21;
        u21b += t3b * u21;
        u22b += t3b * u22;
        u22b += t3b * u22;
        p2b = t3b * p2;
        p2b += t3b * p2;
        pb[adr2 + MAGGI_DRAG_LOW] += p2b;
        rvb[t->forcepoint[i]][2] += u22b;
        pb[adr2 + MAGGI_DRAG_WIND + 2] -= u22b;
        rvb[t->forcepoint[i]][1] += u21b;
        pb[adr2 + MAGGI_DRAG_WIND + 1] -= u21b;
        /* - rho/2 c A |u| u,  u = v - wind,  |u| = sqrt(u.u + low^2) */
        rvb[t->forcepoint[i]][0] += u20b;
        pb[adr2 + MAGGI_DRAG_WIND] -= u20b;
      } else {
        c20 = p[adr2] * s;
        c21 = p[adr2 + 1] * s;
        c22 = p[adr2 + 2] * s;
        c20b = 0.0;
        c21b = 0.0;
        c22b = 0.0;
        if (t->forcekind[i] == MAGGI_FORCE_BODY || t->forcekind[i] == MAGGI_TORQUE_BODY) {
          Ab[a3_2][6] += g2b * c20;
          c20b += g2b * A[a3_2][6];
          Ab[a3_2][7] += g2b * c21;
          c21b += g2b * A[a3_2][7];
          Ab[a3_2][8] += g2b * c22;
          c22b += g2b * A[a3_2][8];
          g2b = 0.0;
          Ab[a3_2][3] += g1b * c20;
          c20b += g1b * A[a3_2][3];
          Ab[a3_2][4] += g1b * c21;
          c21b += g1b * A[a3_2][4];
          Ab[a3_2][5] += g1b * c22;
          c22b += g1b * A[a3_2][5];
          g1b = 0.0;
          Ab[a3_2][0] += g0b * c20;
          c20b += g0b * A[a3_2][0];
          Ab[a3_2][1] += g0b * c21;
          c21b += g0b * A[a3_2][1];
          Ab[a3_2][2] += g0b * c22;
          c22b += g0b * A[a3_2][2];
          g0b = 0.0;
        } else {
          c22b += g2b;
          g2b = 0.0;
          c21b += g1b;
          g1b = 0.0;
          c20b += g0b;
          g0b = 0.0;
        }
        pb[adr2 + 2] += c22b * s;
        sb += c22b * p[adr2 + 2];
        pb[adr2 + 1] += c21b * s;
        sb += c21b * p[adr2 + 1];
        pb[adr2] += c20b * s;
        sb += c20b * p[adr2];
      }
    }
    if (t->forcefun[i] >= 0) {
      funb[t->forcefun[i]][0] += sb;
      sb = 0.0;
    } else {
      sb = 0.0;
    }
  }
  for (i = t->njspring - 1; i >= 0; --i) {
    a2 = t->jspringq[i];
    b2 = t->jspringq2[i];
    adr = t->jspringadr[i];
    if (b2 >= 0) {
      x = q[a2] - q[b2];
      xv = v[a2] - v[b2];
    } else {
      x = q[a2];
      xv = v[a2];
    }
    torque0b = 0.0;
    if (b2 >= 0) {
      torque0b -= taub[b2];
    }
    torque0b += taub[a2];
    pb[adr] -= torque0b * (x - p[adr + MAGGI_JSPRING_REST]);
    tb15 = torque0b * p[adr];
    xb = -tb15;
    pb[adr + MAGGI_JSPRING_REST] += tb15;
    pb[adr + MAGGI_JSPRING_C] -= torque0b * xv;
    xvb = -(torque0b * p[adr + MAGGI_JSPRING_C]);
    pb[adr + MAGGI_JSPRING_PRELOAD] -= torque0b;
    if (b2 >= 0) {
      vb[a2] += xvb;
      vb[b2] -= xvb;
      xvb = 0.0;
      qb[a2] += xb;
      qb[b2] -= xb;
      xb = 0.0;
    } else {
      vb[a2] += xvb;
      xvb = 0.0;
      qb[a2] += xb;
      xb = 0.0;
    }
  }
  for (i = t->nspring - 1; i >= 0; --i) {
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
    n20 = e0 / l;
    n21 = e1 / l;
    n22 = e2 / l;
    lv = n20 * ev0 + n21 * ev1 + n22 * ev2;
    damping = p[t->springadr[i] + MAGGI_SPRING_C] * lv;
    if (t->springpreload[i]) {
      f0 = p[t->springadr[i]] * (l - spring0[i]) + p[t->springadr[i] + MAGGI_SPRING_L];
    } else {
      f0 = p[t->springadr[i]] * (l - p[t->springadr[i] + MAGGI_SPRING_L]);
    }
    k2 = t->springadr[i] + MAGGI_SPRING_SLOPES;
    if (t->springslopes[i]) {
      if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
        p_k24 = p[k2 + 4];
        f2 = p[k2] * p_k24 + p[k2 + 1] * (lv - p_k24);
      } else if (MAGGI_RE(lv) > 0.0) {
        f2 = p[k2] * lv;
      } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
        f2 = p[k2 + 2] * lv;
      } else {
        p_k25 = p[k2 + 5];
        f2 = p[k2 + 2] * p_k25 + p[k2 + 3] * (lv - p_k25);
      }
      f1 = damping + f2;
    } else {
      f1 = damping;
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
    tb14 = Qb[t->pointbody[b]][5];
    r_b0b = tb14 * force1;
    force1b = tb14 * r_b0;
    r_b1b = -(tb14 * force0);
    force0b = -(tb14 * r_b1);
    tb13 = Qb[t->pointbody[b]][4];
    r_b2b = tb13 * force0;
    force0b += tb13 * r_b2;
    r_b0b -= tb13 * force2;
    force2b = -(tb13 * r_b0);
    rb[b][0] += r_b0b;
    tb12 = Qb[t->pointbody[b]][3];
    r_b1b += tb12 * force2;
    force2b += tb12 * r_b1;
    r_b2b -= tb12 * force1;
    force1b -= tb12 * r_b2;
    rb[b][2] += r_b2b;
    rb[b][1] += r_b1b;
    force2b += Qb[t->pointbody[b]][2];
    force1b += Qb[t->pointbody[b]][1];
    force0b += Qb[t->pointbody[b]][0];
    tb11 = Qb[t->pointbody[a]][5];
    r_a0b = tb11 * back1;
    back1b = tb11 * r_a0;
    r_a1b = -(tb11 * back0);
    back0b = -(tb11 * r_a1);
    tb10 = Qb[t->pointbody[a]][4];
    r_a2b = tb10 * back0;
    back0b += tb10 * r_a2;
    r_a0b -= tb10 * back2_2;
    back2_2b = -(tb10 * r_a0);
    rb[a][0] += r_a0b;
    tb9 = Qb[t->pointbody[a]][3];
    r_a1b += tb9 * back2_2;
    back2_2b += tb9 * r_a1;
    r_a2b -= tb9 * back1;
    back1b -= tb9 * r_a2;
    rb[a][2] += r_a2b;
    rb[a][1] += r_a1b;
    back2_2b += Qb[t->pointbody[a]][2];
    back1b += Qb[t->pointbody[a]][1];
    back0b += Qb[t->pointbody[a]][0];
    f3b = -(back2_2b * u2_2);
    u2_2b = -(back2_2b * f3);
    f3b += force2b * u2_2;
    u2_2b += force2b * f3;
    f3b -= back1b * u1;
    u1b = -(back1b * f3);
    f3b += force1b * u1;
    u1b += force1b * f3;
    f3b -= back0b * u0;
    u0b = -(back0b * f3);
    f3b += force0b * u0;
    u0b += force0b * f3;
    f0b = f3b;
    f1b = f3b;
    n22b = u2_2b;
    n21b = u1b;
    n20b = u0b;
    dampingb = 0.0;
    lvb = 0.0;
    if (t->springslopes[i]) {
      dampingb += f1b;
      f2b = f1b;
      f1b = 0.0;
      /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
      if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
        p_k24 = p[k2 + 4];
        pb[k2] += f2b * p_k24;
        p_k24b = f2b * p[k2];
        pb[k2 + 1] += f2b * (lv - p_k24);
        tb7 = f2b * p[k2 + 1];
        lvb += tb7;
        p_k24b -= tb7;
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
        tb8 = f2b * p[k2 + 3];
        lvb += tb8;
        p_k25b -= tb8;
        f2b = 0.0;
        pb[k2 + 5] += p_k25b;
      }
    } else {
      dampingb += f1b;
      f1b = 0.0;
    }
    lb = 0.0;
    if (t->springpreload[i]) {
      pb[t->springadr[i]] += f0b * (l - spring0[i]);
      tb5 = f0b * p[t->springadr[i]];
      lb += tb5;
      spring0b[i] -= tb5;
      pb[t->springadr[i] + MAGGI_SPRING_L] += f0b;
      f0b = 0.0;
    } else {
      pb[t->springadr[i]] += f0b * (l - p[t->springadr[i] + MAGGI_SPRING_L]);
      tb6 = f0b * p[t->springadr[i]];
      lb += tb6;
      pb[t->springadr[i] + MAGGI_SPRING_L] -= tb6;
      f0b = 0.0;
    }
    pb[t->springadr[i] + MAGGI_SPRING_C] += dampingb * lv;
    lvb += dampingb * p[t->springadr[i] + MAGGI_SPRING_C];
    n20b += lvb * ev0;
    ev0b = lvb * n20;
    n21b += lvb * ev1;
    ev1b = lvb * n21;
    n22b += lvb * ev2;
    ev2b = lvb * n22;
    tb4 = n22b / l;
    e2b = tb4;
    lb -= tb4 * n22;
    tb3 = n21b / l;
    e1b = tb3;
    lb -= tb3 * n21;
    tb2 = n20b / l;
    e0b = tb2;
    lb -= tb2 * n20;
    t2b = lb * (1.0 / (2.0 * l));
    e0b += t2b * e0;
    e0b += t2b * e0;
    e1b += t2b * e1;
    e1b += t2b * e1;
    e2b += t2b * e2;
    e2b += t2b * e2;
    rvb[a][2] += ev2b;
    rvb[b][2] -= ev2b;
    rb[a][2] += e2b;
    rb[b][2] -= e2b;
    rvb[a][1] += ev1b;
    rvb[b][1] -= ev1b;
    rb[a][1] += e1b;
    rb[b][1] -= e1b;
    rvb[a][0] += ev0b;
    rvb[b][0] -= ev0b;
    rb[a][0] += e0b;
    rb[b][0] -= e0b;
  }
  for (i = t->nq - 1; i >= 0; --i) {
    taub[i] = 0.0;
  }
  for (i = t->nbody; i >= 0; --i) {
    for (k = 5; k >= 0; --k) {
      Qb[i][k] = 0.0;
    }
  }
}
