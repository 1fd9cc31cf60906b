/* Tangent of the adjoint of core/kernel/element.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

void maggi_element_forces_b_d(const maggi_topo *t, const double p[restrict t->np],
                              const double pd[restrict t->np], double pb[restrict t->np],
                              double pbd[restrict t->np], const double fun[restrict t->nfun][3],
                              const double fund[restrict t->nfun][3],
                              double funb[restrict t->nfun][3], double funbd[restrict t->nfun][3],
                              const double spring0[restrict t->nspring],
                              const double spring0d[restrict t->nspring],
                              double spring0b[restrict t->nspring],
                              double spring0bd[restrict t->nspring], const double q[restrict t->nq],
                              const double qd[restrict t->nq], double qb[restrict t->nq],
                              double qbd[restrict t->nq], const double v[restrict t->nq],
                              const double vd[restrict t->nq], double vb[restrict t->nq],
                              double vbd[restrict t->nq], const double A[restrict t->nbody + 1][9],
                              const double Ad[restrict t->nbody + 1][9],
                              double Ab[restrict t->nbody + 1][9],
                              double Abd[restrict t->nbody + 1][9],
                              const double Z[restrict t->nbody + 1][6],
                              const double r[restrict t->npoint][3],
                              const double rd[restrict t->npoint][3],
                              double rb[restrict t->npoint][3], double rbd[restrict t->npoint][3],
                              const double rv[restrict t->npoint][3],
                              const double rvd[restrict t->npoint][3],
                              double rvb[restrict t->npoint][3], double rvbd[restrict t->npoint][3],
                              const double roll[restrict t->nwheel][6],
                              const double rolld[restrict t->nwheel][6],
                              double rollb[restrict t->nwheel][6],
                              double rollbd[restrict t->nwheel][6],
                              double Q[restrict t->nbody + 1][6],
                              double Qd[restrict t->nbody + 1][6],
                              double Qb[restrict t->nbody + 1][6],
                              double Qbd[restrict t->nbody + 1][6], double tau[restrict t->nq],
                              double taud[restrict t->nq], double taub[restrict t->nq],
                              double taubd[restrict t->nq], double power[restrict 1])
{
  int a, a2, a3, a3_2, a4, adr, adr2, b, b2, b3, i, k, k2, k8;
  double back0, back0b, back0bd, back0d, back1, back1b, back1bd, back1d, back20, back20b, back20bd,
      back20d, back21, back21b, back21bd, back21d, back22, back22b, back22bd, back22d, back2_2,
      back2_2b, back2_2bd, back2_2d, c, c20, c20b, c20bd, c20d, c21, c21b, c21bd, c21d, c22, c22b,
      c22bd, c22d, cb, cbd, cd, damping, dampingb, dampingbd, dampingd, e0, e0b, e0bd, e0d, e1, e1b,
      e1bd, e1d, e2, e2b, e2bd, e2d, ev0, ev0b, ev0bd, ev0d, ev1, ev1b, ev1bd, ev1d, ev2, ev2b,
      ev2bd, ev2d, f0, f0b, f0bd, f0d, f1, f1b, f1bd, f1d, f2, f2b, f2bd, f2d, f3, f3b, f3bd, f3d,
      force0, force0b, force0bd, force0d, force1, force1b, force1bd, force1d, force2, force2b,
      force2bd, force2d, g0, g0b, g0bd, g0d, g1, g1b, g1bd, g1d, g2, g2b, g2bd, g2d, l, lb, lbd, ld,
      lv, lvb, lvbd, lvd, n20, n20b, n20bd, n20d, n21, n21b, n21bd, n21d, n22, n22b, n22bd, n22d,
      p2, p2b, p2bd, p2d, p_adr2, p_adr2b, p_adr2bd, p_adr2d, p_k24, p_k24b, p_k24bd, p_k24d, p_k25,
      p_k25b, p_k25bd, p_k25d, r_a0, r_a0b, r_a0bd, r_a0d, r_a1, r_a1b, r_a1bd, r_a1d, r_a2, r_a2b,
      r_a2bd, r_a2d, r_b0, r_b0b, r_b0bd, r_b0d, r_b1, r_b1b, r_b1bd, r_b1d, r_b2, r_b2b, r_b2bd,
      r_b2d, r_i0, r_i0b, r_i0bd, r_i0d, r_i1, r_i1b, r_i1bd, r_i1d, r_i2, r_i2b, r_i2bd, r_i2d, s,
      sb, sbd, sd, speed, speedb, speedbd, speedd, t2, t2b, t2bd, t2d, t3, t3b, t3bd, t3d, tb10,
      tb10d, tb11, tb11d, tb12, tb12d, tb13, tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d, tb17,
      tb17d, tb18, tb18d, tb19, tb19d, tb2, tb20, tb20d, tb21, tb21d, tb22, tb22d, tb23, tb23d,
      tb24, tb24d, tb25, tb25d, tb26, tb26d, tb27, tb27d, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d,
      tb6, tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d, torque0b, torque0bd, u0, u0b, u0bd, u0d, u1, u1b,
      u1bd, u1d, u20, u20b, u20bd, u20d, u21, u21b, u21bd, u21d, u22, u22b, u22bd, u22d, u2_2,
      u2_2b, u2_2bd, u2_2d, x, xb, xbd, xd, xv, xvb, xvbd, xvd;

  (void)Z;
  (void)roll;
  (void)rolld;
  (void)Q;
  (void)Qd;
  (void)tau;
  (void)taud;
  (void)power;
  /* power of all of it, springs of tyres too */
  for (i = t->nwheel - 1; i >= 0; --i) {
    a4 = t->wheelbody[i];
    for (k8 = 5; k8 >= 0; --k8) {
      rollb[i][k8] += Qb[a4][k8];
      rollbd[i][k8] += Qbd[a4][k8];
    }
  }
  for (i = t->nforce - 1; i >= 0; --i) {
    adr2 = t->forceadr[i];
    if (t->forcefun[i] >= 0) {
      s = fun[t->forcefun[i]][0];
      sd = fund[t->forcefun[i]][0];
    } else {
      s = 1.0;
      sd = 0.0;
    }
    sb = 0.0;
    sbd = 0.0;
    if (t->forcekind[i] == MAGGI_FORCE_JOINT) {
      a3 = t->forceq[i];
      p_adr2 = p[adr2];
      p_adr2d = pd[adr2];
      tb16 = taub[a3];
      tb16d = taubd[a3];
      p_adr2b = tb16 * s;
      p_adr2bd = tb16d * s + tb16 * sd;
      sb += tb16 * p_adr2;
      sbd += tb16d * p_adr2 + tb16 * p_adr2d;
      pb[adr2] += p_adr2b;
      pbd[adr2] += p_adr2bd;
    } else {
      a3_2 = t->forcebody[i];
      b3 = t->forcereaction[i];
      if (t->forcekind[i] == MAGGI_FORCE_DRAG) {
        u20 = rv[t->forcepoint[i]][0] - p[adr2 + MAGGI_DRAG_WIND];
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
        speedd = 1.0 / (2.0 * speed) * t3d;
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
      g0b = 0.0;
      g0bd = 0.0;
      g1b = 0.0;
      g1bd = 0.0;
      g2b = 0.0;
      g2bd = 0.0;
      if (t->forcepoint[i] >= 0) {
        back20 = -g0;
        back20d = -g0d;
        back21 = -g1;
        back21d = -g1d;
        back22 = -g2;
        back22d = -g2d;
        r_i1 = r[t->forcepoint[i]][1];
        r_i1d = rd[t->forcepoint[i]][1];
        r_i2 = r[t->forcepoint[i]][2];
        r_i2d = rd[t->forcepoint[i]][2];
        r_i0 = r[t->forcepoint[i]][0];
        r_i0d = rd[t->forcepoint[i]][0];
        tb27 = Qb[b3][5];
        tb27d = Qbd[b3][5];
        r_i0b = tb27 * back21;
        r_i0bd = tb27d * back21 + tb27 * back21d;
        back21b = tb27 * r_i0;
        back21bd = tb27d * r_i0 + tb27 * r_i0d;
        r_i1b = -(tb27 * back20);
        r_i1bd = -(tb27d * back20 + tb27 * back20d);
        back20b = -(tb27 * r_i1);
        back20bd = -(tb27d * r_i1 + tb27 * r_i1d);
        tb26 = Qb[b3][4];
        tb26d = Qbd[b3][4];
        r_i2b = tb26 * back20;
        r_i2bd = tb26d * back20 + tb26 * back20d;
        back20b += tb26 * r_i2;
        back20bd += tb26d * r_i2 + tb26 * r_i2d;
        r_i0b -= tb26 * back22;
        r_i0bd -= tb26d * back22 + tb26 * back22d;
        back22b = -(tb26 * r_i0);
        back22bd = -(tb26d * r_i0 + tb26 * r_i0d);
        tb25 = Qb[b3][3];
        tb25d = Qbd[b3][3];
        r_i1b += tb25 * back22;
        r_i1bd += tb25d * back22 + tb25 * back22d;
        back22b += tb25 * r_i1;
        back22bd += tb25d * r_i1 + tb25 * r_i1d;
        r_i2b -= tb25 * back21;
        r_i2bd -= tb25d * back21 + tb25 * back21d;
        back21b -= tb25 * r_i2;
        back21bd -= tb25d * r_i2 + tb25 * r_i2d;
        back22b += Qb[b3][2];
        back22bd += Qbd[b3][2];
        back21b += Qb[b3][1];
        back21bd += Qbd[b3][1];
        back20b += Qb[b3][0];
        back20bd += Qbd[b3][0];
        tb24 = Qb[a3_2][5];
        tb24d = Qbd[a3_2][5];
        r_i0b += tb24 * g1;
        r_i0bd += tb24d * g1 + tb24 * g1d;
        g1b += tb24 * r_i0;
        g1bd += tb24d * r_i0 + tb24 * r_i0d;
        r_i1b -= tb24 * g0;
        r_i1bd -= tb24d * g0 + tb24 * g0d;
        g0b -= tb24 * r_i1;
        g0bd -= tb24d * r_i1 + tb24 * r_i1d;
        tb23 = Qb[a3_2][4];
        tb23d = Qbd[a3_2][4];
        r_i2b += tb23 * g0;
        r_i2bd += tb23d * g0 + tb23 * g0d;
        g0b += tb23 * r_i2;
        g0bd += tb23d * r_i2 + tb23 * r_i2d;
        r_i0b -= tb23 * g2;
        r_i0bd -= tb23d * g2 + tb23 * g2d;
        g2b -= tb23 * r_i0;
        g2bd -= tb23d * r_i0 + tb23 * r_i0d;
        rb[t->forcepoint[i]][0] += r_i0b;
        rbd[t->forcepoint[i]][0] += r_i0bd;
        tb22 = Qb[a3_2][3];
        tb22d = Qbd[a3_2][3];
        r_i1b += tb22 * g2;
        r_i1bd += tb22d * g2 + tb22 * g2d;
        g2b += tb22 * r_i1;
        g2bd += tb22d * r_i1 + tb22 * r_i1d;
        r_i2b -= tb22 * g1;
        r_i2bd -= tb22d * g1 + tb22 * g1d;
        g1b -= tb22 * r_i2;
        g1bd -= tb22d * r_i2 + tb22 * r_i2d;
        rb[t->forcepoint[i]][2] += r_i2b;
        rbd[t->forcepoint[i]][2] += r_i2bd;
        rb[t->forcepoint[i]][1] += r_i1b;
        rbd[t->forcepoint[i]][1] += r_i1bd;
        g2b += Qb[a3_2][2];
        g2bd += Qbd[a3_2][2];
        g1b += Qb[a3_2][1];
        g1bd += Qbd[a3_2][1];
        g0b += Qb[a3_2][0];
        g0bd += Qbd[a3_2][0];
        g2b -= back22b;
        g2bd -= back22bd;
        g1b -= back21b;
        g1bd -= back21bd;
        g0b -= back20b;
        /* force at r, or pure torque, on one body and back on another; returns its power */
        g0bd -= back20bd;
      } else {
        g2b -= Qb[b3][5];
        g2bd -= Qbd[b3][5];
        g2b += Qb[a3_2][5];
        g2bd += Qbd[a3_2][5];
        g1b -= Qb[b3][4];
        g1bd -= Qbd[b3][4];
        g1b += Qb[a3_2][4];
        g1bd += Qbd[a3_2][4];
        g0b -= Qb[b3][3];
        g0bd -= Qbd[b3][3];
        g0b += Qb[a3_2][3];
        g0bd += Qbd[a3_2][3];
      }
      if (t->forcekind[i] == MAGGI_FORCE_DRAG) {
        u20 = rv[t->forcepoint[i]][0] - p[adr2 + MAGGI_DRAG_WIND];
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
        speedd = 1.0 / (2.0 * speed) * t3d;
        c = 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA] * s;
        cd = ((0.5 * pd[adr2] * p[adr2 + MAGGI_DRAG_C] + 0.5 * p[adr2] * pd[adr2 + MAGGI_DRAG_C]) *
            p[adr2 + MAGGI_DRAG_AREA] + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * pd[adr2 +
            MAGGI_DRAG_AREA]) * s + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 +
            MAGGI_DRAG_AREA] * sd;
        tb21 = g2b * u22;
        tb21d = g2bd * u22 + g2b * u22d;
        cb = -(tb21 * speed);
        cbd = -(tb21d * speed + tb21 * speedd);
        speedb = -(tb21 * c);
        speedbd = -(tb21d * c + tb21 * cd);
        u22b = g2b * (-c * speed);
        u22bd = g2bd * (-c * speed) + g2b * (-(cd * speed) - c * speedd);
        g2b = 0.0;
        g2bd = 0.0;
        tb20 = g1b * u21;
        tb20d = g1bd * u21 + g1b * u21d;
        cb -= tb20 * speed;
        cbd -= tb20d * speed + tb20 * speedd;
        speedb -= tb20 * c;
        speedbd -= tb20d * c + tb20 * cd;
        u21b = g1b * (-c * speed);
        u21bd = g1bd * (-c * speed) + g1b * (-(cd * speed) - c * speedd);
        g1b = 0.0;
        g1bd = 0.0;
        tb19 = g0b * u20;
        tb19d = g0bd * u20 + g0b * u20d;
        cb -= tb19 * speed;
        cbd -= tb19d * speed + tb19 * speedd;
        speedb -= tb19 * c;
        speedbd -= tb19d * c + tb19 * cd;
        u20b = g0b * (-c * speed);
        u20bd = g0bd * (-c * speed) + g0b * (-(cd * speed) - c * speedd);
        g0b = 0.0;
        g0bd = 0.0;
        tb17 = cb * s;
        tb17d = cbd * s + cb * sd;
        tb18 = tb17 * p[adr2 + MAGGI_DRAG_AREA];
        tb18d = tb17d * p[adr2 + MAGGI_DRAG_AREA] + tb17 * pd[adr2 + MAGGI_DRAG_AREA];
        pb[adr2] += tb18 * p[adr2 + MAGGI_DRAG_C] * 0.5;
        pbd[adr2] += (tb18d * p[adr2 + MAGGI_DRAG_C] + tb18 * pd[adr2 + MAGGI_DRAG_C]) * 0.5;
        pb[adr2 + MAGGI_DRAG_C] += tb18 * (0.5 * p[adr2]);
        pbd[adr2 + MAGGI_DRAG_C] += tb18d * (0.5 * p[adr2]) + tb18 * (0.5 * pd[adr2]);
        pb[adr2 + MAGGI_DRAG_AREA] += tb17 * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C]);
        pbd[adr2 + MAGGI_DRAG_AREA] += tb17d * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C]) + tb17 *
            (0.5 * pd[adr2] * p[adr2 + MAGGI_DRAG_C] + 0.5 * p[adr2] * pd[adr2 + MAGGI_DRAG_C]);
        sb += cb * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA]);
        sbd += cbd * (0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * p[adr2 + MAGGI_DRAG_AREA]) + cb *
            ((0.5 * pd[adr2] * p[adr2 + MAGGI_DRAG_C] + 0.5 * p[adr2] * pd[adr2 + MAGGI_DRAG_C]) *
            p[adr2 + MAGGI_DRAG_AREA] + 0.5 * p[adr2] * p[adr2 + MAGGI_DRAG_C] * pd[adr2 +
            MAGGI_DRAG_AREA]);
        t3b = speedb * (1.0 / (2.0 * speed));
        t3bd = speedbd * (1.0 / (2.0 * speed)) - speedb * (1.0 / (2.0 * speed) * (2.0 * speedd) /
            (2.0 * speed));
        u20b += t3b * u20;
        u20bd += t3bd * u20 + t3b * u20d;
        u20b += t3b * u20;
        u20bd += t3bd * u20 + t3b * u20d;
        u21b += t3b * u21;
        u21bd += t3bd * u21 + t3b * u21d;
        u21b += t3b * u21;
        u21bd += t3bd * u21 + t3b * u21d;
        u22b += t3b * u22;
        u22bd += t3bd * u22 + t3b * u22d;
        u22b += t3b * u22;
        u22bd += t3bd * u22 + t3b * u22d;
        p2b = t3b * p2;
        p2bd = t3bd * p2 + t3b * p2d;
        p2b += t3b * p2;
        p2bd += t3bd * p2 + t3b * p2d;
        pb[adr2 + MAGGI_DRAG_LOW] += p2b;
        pbd[adr2 + MAGGI_DRAG_LOW] += p2bd;
        rvb[t->forcepoint[i]][2] += u22b;
        rvbd[t->forcepoint[i]][2] += u22bd;
        pb[adr2 + MAGGI_DRAG_WIND + 2] -= u22b;
        pbd[adr2 + MAGGI_DRAG_WIND + 2] -= u22bd;
        rvb[t->forcepoint[i]][1] += u21b;
        rvbd[t->forcepoint[i]][1] += u21bd;
        pb[adr2 + MAGGI_DRAG_WIND + 1] -= u21b;
        pbd[adr2 + MAGGI_DRAG_WIND + 1] -= u21bd;
        rvb[t->forcepoint[i]][0] += u20b;
        /* - rho/2 c A |u| u,  u = v - wind,  |u| = sqrt(u.u + low^2) */
        rvbd[t->forcepoint[i]][0] += u20bd;
        pb[adr2 + MAGGI_DRAG_WIND] -= u20b;
        pbd[adr2 + MAGGI_DRAG_WIND] -= u20bd;
      } else {
        c20 = p[adr2] * s;
        c20d = pd[adr2] * s + p[adr2] * sd;
        c21 = p[adr2 + 1] * s;
        c21d = pd[adr2 + 1] * s + p[adr2 + 1] * sd;
        c22 = p[adr2 + 2] * s;
        c22d = pd[adr2 + 2] * s + p[adr2 + 2] * sd;
        c20b = 0.0;
        c20bd = 0.0;
        c21b = 0.0;
        c21bd = 0.0;
        c22b = 0.0;
        c22bd = 0.0;
        if (t->forcekind[i] == MAGGI_FORCE_BODY || t->forcekind[i] == MAGGI_TORQUE_BODY) {
          Ab[a3_2][6] += g2b * c20;
          Abd[a3_2][6] += g2bd * c20 + g2b * c20d;
          c20b += g2b * A[a3_2][6];
          c20bd += g2bd * A[a3_2][6] + g2b * Ad[a3_2][6];
          Ab[a3_2][7] += g2b * c21;
          Abd[a3_2][7] += g2bd * c21 + g2b * c21d;
          c21b += g2b * A[a3_2][7];
          c21bd += g2bd * A[a3_2][7] + g2b * Ad[a3_2][7];
          Ab[a3_2][8] += g2b * c22;
          Abd[a3_2][8] += g2bd * c22 + g2b * c22d;
          c22b += g2b * A[a3_2][8];
          c22bd += g2bd * A[a3_2][8] + g2b * Ad[a3_2][8];
          g2b = 0.0;
          g2bd = 0.0;
          Ab[a3_2][3] += g1b * c20;
          Abd[a3_2][3] += g1bd * c20 + g1b * c20d;
          c20b += g1b * A[a3_2][3];
          c20bd += g1bd * A[a3_2][3] + g1b * Ad[a3_2][3];
          Ab[a3_2][4] += g1b * c21;
          Abd[a3_2][4] += g1bd * c21 + g1b * c21d;
          c21b += g1b * A[a3_2][4];
          c21bd += g1bd * A[a3_2][4] + g1b * Ad[a3_2][4];
          Ab[a3_2][5] += g1b * c22;
          Abd[a3_2][5] += g1bd * c22 + g1b * c22d;
          c22b += g1b * A[a3_2][5];
          c22bd += g1bd * A[a3_2][5] + g1b * Ad[a3_2][5];
          g1b = 0.0;
          g1bd = 0.0;
          Ab[a3_2][0] += g0b * c20;
          Abd[a3_2][0] += g0bd * c20 + g0b * c20d;
          c20b += g0b * A[a3_2][0];
          c20bd += g0bd * A[a3_2][0] + g0b * Ad[a3_2][0];
          Ab[a3_2][1] += g0b * c21;
          Abd[a3_2][1] += g0bd * c21 + g0b * c21d;
          c21b += g0b * A[a3_2][1];
          c21bd += g0bd * A[a3_2][1] + g0b * Ad[a3_2][1];
          Ab[a3_2][2] += g0b * c22;
          Abd[a3_2][2] += g0bd * c22 + g0b * c22d;
          c22b += g0b * A[a3_2][2];
          c22bd += g0bd * A[a3_2][2] + g0b * Ad[a3_2][2];
          g0b = 0.0;
          g0bd = 0.0;
        } else {
          c22b += g2b;
          c22bd += g2bd;
          g2b = 0.0;
          g2bd = 0.0;
          c21b += g1b;
          c21bd += g1bd;
          g1b = 0.0;
          g1bd = 0.0;
          c20b += g0b;
          c20bd += g0bd;
          g0b = 0.0;
          g0bd = 0.0;
        }
        pb[adr2 + 2] += c22b * s;
        pbd[adr2 + 2] += c22bd * s + c22b * sd;
        sb += c22b * p[adr2 + 2];
        sbd += c22bd * p[adr2 + 2] + c22b * pd[adr2 + 2];
        pb[adr2 + 1] += c21b * s;
        pbd[adr2 + 1] += c21bd * s + c21b * sd;
        sb += c21b * p[adr2 + 1];
        sbd += c21bd * p[adr2 + 1] + c21b * pd[adr2 + 1];
        pb[adr2] += c20b * s;
        pbd[adr2] += c20bd * s + c20b * sd;
        sb += c20b * p[adr2];
        sbd += c20bd * p[adr2] + c20b * pd[adr2];
      }
    }
    if (t->forcefun[i] >= 0) {
      funb[t->forcefun[i]][0] += sb;
      funbd[t->forcefun[i]][0] += sbd;
      sb = 0.0;
      sbd = 0.0;
    } else {
      sb = 0.0;
      sbd = 0.0;
    }
  }
  for (i = t->njspring - 1; i >= 0; --i) {
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
    torque0b = 0.0;
    torque0bd = 0.0;
    if (b2 >= 0) {
      torque0b -= taub[b2];
      torque0bd -= taubd[b2];
    }
    torque0b += taub[a2];
    torque0bd += taubd[a2];
    pb[adr] -= torque0b * (x - p[adr + MAGGI_JSPRING_REST]);
    pbd[adr] -= torque0bd * (x - p[adr + MAGGI_JSPRING_REST]) + torque0b * (xd - pd[adr +
        MAGGI_JSPRING_REST]);
    tb15 = torque0b * p[adr];
    tb15d = torque0bd * p[adr] + torque0b * pd[adr];
    xb = -tb15;
    xbd = -tb15d;
    pb[adr + MAGGI_JSPRING_REST] += tb15;
    pbd[adr + MAGGI_JSPRING_REST] += tb15d;
    pb[adr + MAGGI_JSPRING_C] -= torque0b * xv;
    pbd[adr + MAGGI_JSPRING_C] -= torque0bd * xv + torque0b * xvd;
    xvb = -(torque0b * p[adr + MAGGI_JSPRING_C]);
    xvbd = -(torque0bd * p[adr + MAGGI_JSPRING_C] + torque0b * pd[adr + MAGGI_JSPRING_C]);
    pb[adr + MAGGI_JSPRING_PRELOAD] -= torque0b;
    pbd[adr + MAGGI_JSPRING_PRELOAD] -= torque0bd;
    if (b2 >= 0) {
      vb[a2] += xvb;
      vbd[a2] += xvbd;
      vb[b2] -= xvb;
      vbd[b2] -= xvbd;
      xvb = 0.0;
      xvbd = 0.0;
      qb[a2] += xb;
      qbd[a2] += xbd;
      qb[b2] -= xb;
      qbd[b2] -= xbd;
      xb = 0.0;
      xbd = 0.0;
    } else {
      vb[a2] += xvb;
      vbd[a2] += xvbd;
      xvb = 0.0;
      xvbd = 0.0;
      qb[a2] += xb;
      qbd[a2] += xbd;
      xb = 0.0;
      xbd = 0.0;
    }
  }
  for (i = t->nspring - 1; i >= 0; --i) {
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
    ld = 1.0 / (2.0 * l) * t2d;
    n20 = e0 / l;
    n20d = (e0d - n20 * ld) * (1.0 / l);
    n21 = e1 / l;
    n21d = (e1d - n21 * ld) * (1.0 / l);
    n22 = e2 / l;
    n22d = (e2d - n22 * ld) * (1.0 / l);
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
    r_a1 = r[a][1];
    r_a1d = rd[a][1];
    r_a2 = r[a][2];
    r_a2d = rd[a][2];
    r_a0 = r[a][0];
    r_a0d = rd[a][0];
    r_b1 = r[b][1];
    r_b1d = rd[b][1];
    r_b2 = r[b][2];
    r_b2d = rd[b][2];
    r_b0 = r[b][0];
    r_b0d = rd[b][0];
    tb14 = Qb[t->pointbody[b]][5];
    tb14d = Qbd[t->pointbody[b]][5];
    r_b0b = tb14 * force1;
    r_b0bd = tb14d * force1 + tb14 * force1d;
    force1b = tb14 * r_b0;
    force1bd = tb14d * r_b0 + tb14 * r_b0d;
    r_b1b = -(tb14 * force0);
    r_b1bd = -(tb14d * force0 + tb14 * force0d);
    force0b = -(tb14 * r_b1);
    force0bd = -(tb14d * r_b1 + tb14 * r_b1d);
    tb13 = Qb[t->pointbody[b]][4];
    tb13d = Qbd[t->pointbody[b]][4];
    r_b2b = tb13 * force0;
    r_b2bd = tb13d * force0 + tb13 * force0d;
    force0b += tb13 * r_b2;
    force0bd += tb13d * r_b2 + tb13 * r_b2d;
    r_b0b -= tb13 * force2;
    r_b0bd -= tb13d * force2 + tb13 * force2d;
    force2b = -(tb13 * r_b0);
    force2bd = -(tb13d * r_b0 + tb13 * r_b0d);
    rb[b][0] += r_b0b;
    rbd[b][0] += r_b0bd;
    tb12 = Qb[t->pointbody[b]][3];
    tb12d = Qbd[t->pointbody[b]][3];
    r_b1b += tb12 * force2;
    r_b1bd += tb12d * force2 + tb12 * force2d;
    force2b += tb12 * r_b1;
    force2bd += tb12d * r_b1 + tb12 * r_b1d;
    r_b2b -= tb12 * force1;
    r_b2bd -= tb12d * force1 + tb12 * force1d;
    force1b -= tb12 * r_b2;
    force1bd -= tb12d * r_b2 + tb12 * r_b2d;
    rb[b][2] += r_b2b;
    rbd[b][2] += r_b2bd;
    rb[b][1] += r_b1b;
    rbd[b][1] += r_b1bd;
    force2b += Qb[t->pointbody[b]][2];
    force2bd += Qbd[t->pointbody[b]][2];
    force1b += Qb[t->pointbody[b]][1];
    force1bd += Qbd[t->pointbody[b]][1];
    force0b += Qb[t->pointbody[b]][0];
    force0bd += Qbd[t->pointbody[b]][0];
    tb11 = Qb[t->pointbody[a]][5];
    tb11d = Qbd[t->pointbody[a]][5];
    r_a0b = tb11 * back1;
    r_a0bd = tb11d * back1 + tb11 * back1d;
    back1b = tb11 * r_a0;
    back1bd = tb11d * r_a0 + tb11 * r_a0d;
    r_a1b = -(tb11 * back0);
    r_a1bd = -(tb11d * back0 + tb11 * back0d);
    back0b = -(tb11 * r_a1);
    back0bd = -(tb11d * r_a1 + tb11 * r_a1d);
    tb10 = Qb[t->pointbody[a]][4];
    tb10d = Qbd[t->pointbody[a]][4];
    r_a2b = tb10 * back0;
    r_a2bd = tb10d * back0 + tb10 * back0d;
    back0b += tb10 * r_a2;
    back0bd += tb10d * r_a2 + tb10 * r_a2d;
    r_a0b -= tb10 * back2_2;
    r_a0bd -= tb10d * back2_2 + tb10 * back2_2d;
    back2_2b = -(tb10 * r_a0);
    back2_2bd = -(tb10d * r_a0 + tb10 * r_a0d);
    rb[a][0] += r_a0b;
    rbd[a][0] += r_a0bd;
    tb9 = Qb[t->pointbody[a]][3];
    tb9d = Qbd[t->pointbody[a]][3];
    r_a1b += tb9 * back2_2;
    r_a1bd += tb9d * back2_2 + tb9 * back2_2d;
    back2_2b += tb9 * r_a1;
    back2_2bd += tb9d * r_a1 + tb9 * r_a1d;
    r_a2b -= tb9 * back1;
    r_a2bd -= tb9d * back1 + tb9 * back1d;
    back1b -= tb9 * r_a2;
    back1bd -= tb9d * r_a2 + tb9 * r_a2d;
    rb[a][2] += r_a2b;
    rbd[a][2] += r_a2bd;
    rb[a][1] += r_a1b;
    rbd[a][1] += r_a1bd;
    back2_2b += Qb[t->pointbody[a]][2];
    back2_2bd += Qbd[t->pointbody[a]][2];
    back1b += Qb[t->pointbody[a]][1];
    back1bd += Qbd[t->pointbody[a]][1];
    back0b += Qb[t->pointbody[a]][0];
    back0bd += Qbd[t->pointbody[a]][0];
    f3b = -(back2_2b * u2_2);
    f3bd = -(back2_2bd * u2_2 + back2_2b * u2_2d);
    u2_2b = -(back2_2b * f3);
    u2_2bd = -(back2_2bd * f3 + back2_2b * f3d);
    f3b += force2b * u2_2;
    f3bd += force2bd * u2_2 + force2b * u2_2d;
    u2_2b += force2b * f3;
    u2_2bd += force2bd * f3 + force2b * f3d;
    f3b -= back1b * u1;
    f3bd -= back1bd * u1 + back1b * u1d;
    u1b = -(back1b * f3);
    u1bd = -(back1bd * f3 + back1b * f3d);
    f3b += force1b * u1;
    f3bd += force1bd * u1 + force1b * u1d;
    u1b += force1b * f3;
    u1bd += force1bd * f3 + force1b * f3d;
    f3b -= back0b * u0;
    f3bd -= back0bd * u0 + back0b * u0d;
    u0b = -(back0b * f3);
    u0bd = -(back0bd * f3 + back0b * f3d);
    f3b += force0b * u0;
    f3bd += force0bd * u0 + force0b * u0d;
    u0b += force0b * f3;
    u0bd += force0bd * f3 + force0b * f3d;
    f0b = f3b;
    f0bd = f3bd;
    f1b = f3b;
    f1bd = f3bd;
    n22b = u2_2b;
    n22bd = u2_2bd;
    n21b = u1b;
    n21bd = u1bd;
    n20b = u0b;
    n20bd = u0bd;
    dampingb = 0.0;
    dampingbd = 0.0;
    lvb = 0.0;
    lvbd = 0.0;
    if (t->springslopes[i]) {
      dampingb += f1b;
      dampingbd += f1bd;
      f2b = f1b;
      f2bd = f1bd;
      f1b = 0.0;
      f1bd = 0.0;
      /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
      if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
        p_k24 = p[k2 + 4];
        p_k24d = pd[k2 + 4];
        pb[k2] += f2b * p_k24;
        pbd[k2] += f2bd * p_k24 + f2b * p_k24d;
        p_k24b = f2b * p[k2];
        p_k24bd = f2bd * p[k2] + f2b * pd[k2];
        pb[k2 + 1] += f2b * (lv - p_k24);
        pbd[k2 + 1] += f2bd * (lv - p_k24) + f2b * (lvd - p_k24d);
        tb7 = f2b * p[k2 + 1];
        tb7d = f2bd * p[k2 + 1] + f2b * pd[k2 + 1];
        lvb += tb7;
        lvbd += tb7d;
        p_k24b -= tb7;
        p_k24bd -= tb7d;
        f2b = 0.0;
        f2bd = 0.0;
        pb[k2 + 4] += p_k24b;
        pbd[k2 + 4] += p_k24bd;
      } else if (MAGGI_RE(lv) > 0.0) {
        pb[k2] += f2b * lv;
        pbd[k2] += f2bd * lv + f2b * lvd;
        lvb += f2b * p[k2];
        lvbd += f2bd * p[k2] + f2b * pd[k2];
        f2b = 0.0;
        f2bd = 0.0;
      } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
        pb[k2 + 2] += f2b * lv;
        pbd[k2 + 2] += f2bd * lv + f2b * lvd;
        lvb += f2b * p[k2 + 2];
        lvbd += f2bd * p[k2 + 2] + f2b * pd[k2 + 2];
        f2b = 0.0;
        f2bd = 0.0;
      } else {
        p_k25 = p[k2 + 5];
        p_k25d = pd[k2 + 5];
        pb[k2 + 2] += f2b * p_k25;
        pbd[k2 + 2] += f2bd * p_k25 + f2b * p_k25d;
        p_k25b = f2b * p[k2 + 2];
        p_k25bd = f2bd * p[k2 + 2] + f2b * pd[k2 + 2];
        pb[k2 + 3] += f2b * (lv - p_k25);
        pbd[k2 + 3] += f2bd * (lv - p_k25) + f2b * (lvd - p_k25d);
        tb8 = f2b * p[k2 + 3];
        tb8d = f2bd * p[k2 + 3] + f2b * pd[k2 + 3];
        lvb += tb8;
        lvbd += tb8d;
        p_k25b -= tb8;
        p_k25bd -= tb8d;
        f2b = 0.0;
        f2bd = 0.0;
        pb[k2 + 5] += p_k25b;
        pbd[k2 + 5] += p_k25bd;
      }
    } else {
      dampingb += f1b;
      dampingbd += f1bd;
      f1b = 0.0;
      f1bd = 0.0;
    }
    lb = 0.0;
    lbd = 0.0;
    if (t->springpreload[i]) {
      pb[t->springadr[i]] += f0b * (l - spring0[i]);
      pbd[t->springadr[i]] += f0bd * (l - spring0[i]) + f0b * (ld - spring0d[i]);
      tb5 = f0b * p[t->springadr[i]];
      tb5d = f0bd * p[t->springadr[i]] + f0b * pd[t->springadr[i]];
      lb += tb5;
      lbd += tb5d;
      spring0b[i] -= tb5;
      spring0bd[i] -= tb5d;
      pb[t->springadr[i] + MAGGI_SPRING_L] += f0b;
      pbd[t->springadr[i] + MAGGI_SPRING_L] += f0bd;
      f0b = 0.0;
      f0bd = 0.0;
    } else {
      pb[t->springadr[i]] += f0b * (l - p[t->springadr[i] + MAGGI_SPRING_L]);
      pbd[t->springadr[i]] += f0bd * (l - p[t->springadr[i] + MAGGI_SPRING_L]) + f0b * (ld -
          pd[t->springadr[i] + MAGGI_SPRING_L]);
      tb6 = f0b * p[t->springadr[i]];
      tb6d = f0bd * p[t->springadr[i]] + f0b * pd[t->springadr[i]];
      lb += tb6;
      lbd += tb6d;
      pb[t->springadr[i] + MAGGI_SPRING_L] -= tb6;
      pbd[t->springadr[i] + MAGGI_SPRING_L] -= tb6d;
      f0b = 0.0;
      f0bd = 0.0;
    }
    pb[t->springadr[i] + MAGGI_SPRING_C] += dampingb * lv;
    pbd[t->springadr[i] + MAGGI_SPRING_C] += dampingbd * lv + dampingb * lvd;
    lvb += dampingb * p[t->springadr[i] + MAGGI_SPRING_C];
    lvbd += dampingbd * p[t->springadr[i] + MAGGI_SPRING_C] + dampingb * pd[t->springadr[i] +
        MAGGI_SPRING_C];
    n20b += lvb * ev0;
    n20bd += lvbd * ev0 + lvb * ev0d;
    ev0b = lvb * n20;
    ev0bd = lvbd * n20 + lvb * n20d;
    n21b += lvb * ev1;
    n21bd += lvbd * ev1 + lvb * ev1d;
    ev1b = lvb * n21;
    ev1bd = lvbd * n21 + lvb * n21d;
    n22b += lvb * ev2;
    n22bd += lvbd * ev2 + lvb * ev2d;
    ev2b = lvb * n22;
    ev2bd = lvbd * n22 + lvb * n22d;
    tb4 = n22b / l;
    tb4d = (n22bd - tb4 * ld) * (1.0 / l);
    e2b = tb4;
    e2bd = tb4d;
    lb -= tb4 * n22;
    lbd -= tb4d * n22 + tb4 * n22d;
    tb3 = n21b / l;
    tb3d = (n21bd - tb3 * ld) * (1.0 / l);
    e1b = tb3;
    e1bd = tb3d;
    lb -= tb3 * n21;
    lbd -= tb3d * n21 + tb3 * n21d;
    tb2 = n20b / l;
    tb2d = (n20bd - tb2 * ld) * (1.0 / l);
    e0b = tb2;
    e0bd = tb2d;
    lb -= tb2 * n20;
    lbd -= tb2d * n20 + tb2 * n20d;
    t2b = lb * (1.0 / (2.0 * l));
    t2bd = lbd * (1.0 / (2.0 * l)) - lb * (1.0 / (2.0 * l) * (2.0 * ld) / (2.0 * l));
    e0b += t2b * e0;
    e0bd += t2bd * e0 + t2b * e0d;
    e0b += t2b * e0;
    e0bd += t2bd * e0 + t2b * e0d;
    e1b += t2b * e1;
    e1bd += t2bd * e1 + t2b * e1d;
    e1b += t2b * e1;
    e1bd += t2bd * e1 + t2b * e1d;
    e2b += t2b * e2;
    e2bd += t2bd * e2 + t2b * e2d;
    e2b += t2b * e2;
    e2bd += t2bd * e2 + t2b * e2d;
    rvb[a][2] += ev2b;
    rvbd[a][2] += ev2bd;
    rvb[b][2] -= ev2b;
    rvbd[b][2] -= ev2bd;
    rb[a][2] += e2b;
    rbd[a][2] += e2bd;
    rb[b][2] -= e2b;
    rbd[b][2] -= e2bd;
    rvb[a][1] += ev1b;
    rvbd[a][1] += ev1bd;
    rvb[b][1] -= ev1b;
    rvbd[b][1] -= ev1bd;
    rb[a][1] += e1b;
    rbd[a][1] += e1bd;
    rb[b][1] -= e1b;
    rbd[b][1] -= e1bd;
    rvb[a][0] += ev0b;
    rvbd[a][0] += ev0bd;
    rvb[b][0] -= ev0b;
    rvbd[b][0] -= ev0bd;
    rb[a][0] += e0b;
    rbd[a][0] += e0bd;
    rb[b][0] -= e0b;
    rbd[b][0] -= e0bd;
  }
  for (i = t->nq - 1; i >= 0; --i) {
    taub[i] = 0.0;
    taubd[i] = 0.0;
  }
  for (i = t->nbody; i >= 0; --i) {
    for (k = 5; k >= 0; --k) {
      Qb[i][k] = 0.0;
      Qbd[i][k] = 0.0;
    }
  }
}
