/* Tangent of the adjoint of core/kernel/constants.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* offset0 = c0 - c0(parent), u0 = a0 / |a0| */
void maggi_joint_constants_b_d(const maggi_topo *t, const double p[restrict t->np],
                               const double pd[restrict t->np], double pb[restrict t->np],
                               double pbd[restrict t->np], const double origin[restrict 3],
                               double offset0[restrict t->nbody][3],
                               double offset0d[restrict t->nbody][3],
                               double offset0b[restrict t->nbody][3],
                               double offset0bd[restrict t->nbody][3],
                               double axis0[restrict t->nbody][3],
                               double axis0d[restrict t->nbody][3],
                               double axis0b[restrict t->nbody][3],
                               double axis0bd[restrict t->nbody][3])
{
  int adr, i, up;
  double a0, a0_2, a0_2b, a0_2bd, a0_2d, a0_3, a0_3b, a0_3bd, a0_3d, a0b, a0bd, a0d, a1, a1_2,
      a1_2b, a1_2bd, a1_2d, a1_3, a1_3b, a1_3bd, a1_3d, a1b, a1bd, a1d, a20, a20b, a20bd, a20d, a21,
      a21b, a21bd, a21d, a22, a22b, a22bd, a22d, a2_2, a2_2b, a2_2bd, a2_2d, a2_3, a2_3b, a2_3bd,
      a2_3d, a2_4, a2_4b, a2_4bd, a2_4d, a30, a30b, a30bd, a30d, a31, a31b, a31bd, a31d, a32, a32b,
      a32bd, a32d, c0, c0_2, c0_2b, c0_2bd, c0_2d, c0b, c0bd, c0d, c1, c1_2, c1_2b, c1_2bd, c1_2d,
      c1b, c1bd, c1d, c2, c2_2, c2_2b, c2_2bd, c2_2d, c2_3, c2_3b, c2_3bd, c2_3d, c2b, c2bd, c2d,
      e0, e0b, e0bd, e0d, e1, e1b, e1bd, e1d, e2, e2b, e2bd, e2d, f, fb, fbd, fd, m0, m0b, m0bd,
      m0d, m1, m1b, m1bd, m1d, m2, m2b, m2bd, m2d, n20, n20_2, n20_2b, n20_2bd, n20_2d, n20b, n20bd,
      n20d, n21, n21_2, n21_2b, n21_2bd, n21_2d, n21b, n21bd, n21d, n22, n22_2, n22_2b, n22_2bd,
      n22_2d, n22b, n22bd, n22d, n3, n3b, n3bd, n3d, n4, n4b, n4bd, n4d, n5, n5b, n5bd, n5d, n6,
      n6b, n6bd, n6d, n7, n7b, n7bd, n7d, n8, n8b, n8bd, n8d, s, s20, s20b, s20bd, s20d, s21, s21b,
      s21bd, s21d, s22, s22b, s22bd, s22d, s3, s3b, s3bd, s3d, sb, sbd, sd, sv0b, sv0bd, sv1b,
      sv1bd, sv2b, sv2bd, t2, t2b, t2bd, t2d, t3, t3b, t3bd, t3d, t4, t4b, t4bd, t4d, t5, t5b, t5bd,
      t5d, t6, t6b, t6bd, t6d, t7, t7b, t7bd, t7d, t8, t8b, t8bd, t8d, tb10, tb10d, tb11, tb11d,
      tb12, tb12d, tb13, tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d, tb17, tb17d, tb18, tb18d,
      tb19, tb19d, tb2, tb20, tb20d, tb21, tb21d, tb22, tb22d, tb23, tb23d, tb24, tb24d, tb25,
      tb25d, tb26, tb26d, tb27, tb27d, tb28, tb28d, tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31,
      tb31d, tb32, tb32d, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d,
      w0, w0_2, w0_2b, w0_2bd, w0_2d, w1, w1_2, w1_2b, w1_2bd, w1_2d, w2, w2_2, w2_2b, w2_2bd,
      w2_2d;

  (void)origin;
  (void)offset0;
  (void)offset0d;
  for (i = t->nbody - 1; i >= 0; --i) {
    adr = t->jpointadr[i];
    up = t->parent[i];
    if (t->joint[i] != MAGGI_ONE_FIXED) {
      if (t->jdirkind[i] == MAGGI_DIR_GLOBAL) {
        axis0b[i][2] = 0.0;
        axis0bd[i][2] = 0.0;
        axis0b[i][1] = 0.0;
        axis0bd[i][1] = 0.0;
        axis0b[i][0] = 0.0;
        axis0bd[i][0] = 0.0;
      } else if (t->jdirkind[i] == MAGGI_DIR_PARAMETER) {
        a0 = p[t->jdiradr[i]];
        a0d = pd[t->jdiradr[i]];
        a1 = p[t->jdiradr[i] + 1];
        a1d = pd[t->jdiradr[i] + 1];
        a2_2 = p[t->jdiradr[i] + 2];
        a2_2d = pd[t->jdiradr[i] + 2];
        t2 = a0 * a0 + a1 * a1 + a2_2 * a2_2;
        t2d = a0d * a0 + a0 * a0d + (a1d * a1 + a1 * a1d) + (a2_2d * a2_2 + a2_2 * a2_2d);
        n3 = sqrt(t2);
        n3d = 1.0 / (2.0 * n3) * t2d;
        tb9 = axis0b[i][2];
        tb9d = axis0bd[i][2];
        axis0b[i][2] = 0.0;
        axis0bd[i][2] = 0.0;
        tb10 = tb9 / n3;
        tb10d = (tb9d - tb10 * n3d) * (1.0 / n3);
        a2_2b = tb10;
        a2_2bd = tb10d;
        n3b = -(tb10 * axis0[i][2]);
        n3bd = -(tb10d * axis0[i][2] + tb10 * axis0d[i][2]);
        tb7 = axis0b[i][1];
        tb7d = axis0bd[i][1];
        axis0b[i][1] = 0.0;
        axis0bd[i][1] = 0.0;
        tb8 = tb7 / n3;
        tb8d = (tb7d - tb8 * n3d) * (1.0 / n3);
        a1b = tb8;
        a1bd = tb8d;
        n3b -= tb8 * axis0[i][1];
        n3bd -= tb8d * axis0[i][1] + tb8 * axis0d[i][1];
        tb5 = axis0b[i][0];
        tb5d = axis0bd[i][0];
        axis0b[i][0] = 0.0;
        axis0bd[i][0] = 0.0;
        tb6 = tb5 / n3;
        tb6d = (tb5d - tb6 * n3d) * (1.0 / n3);
        a0b = tb6;
        a0bd = tb6d;
        n3b -= tb6 * axis0[i][0];
        n3bd -= tb6d * axis0[i][0] + tb6 * axis0d[i][0];
        t2b = n3b * (1.0 / (2.0 * n3));
        t2bd = n3bd * (1.0 / (2.0 * n3)) - n3b * (1.0 / (2.0 * n3) * (2.0 * n3d) / (2.0 * n3));
        a0b += t2b * a0;
        a0bd += t2bd * a0 + t2b * a0d;
        a0b += t2b * a0;
        a0bd += t2bd * a0 + t2b * a0d;
        a1b += t2b * a1;
        a1bd += t2bd * a1 + t2b * a1d;
        a1b += t2b * a1;
        a1bd += t2bd * a1 + t2b * a1d;
        a2_2b += t2b * a2_2;
        a2_2bd += t2bd * a2_2 + t2b * a2_2d;
        a2_2b += t2b * a2_2;
        a2_2bd += t2bd * a2_2 + t2b * a2_2d;
        pb[t->jdiradr[i] + 2] += a2_2b;
        pbd[t->jdiradr[i] + 2] += a2_2bd;
        pb[t->jdiradr[i] + 1] += a1b;
        pbd[t->jdiradr[i] + 1] += a1bd;
        pb[t->jdiradr[i]] += a0b;
        pbd[t->jdiradr[i]] += a0bd;
      } else if (t->jdirkind[i] == MAGGI_DIR_CARRIED) {
        a0_2 = p[t->jdiraux[i]];
        a0_2d = pd[t->jdiraux[i]];
        a1_2 = p[t->jdiraux[i] + 1];
        a1_2d = pd[t->jdiraux[i] + 1];
        a2_3 = p[t->jdiraux[i] + 2];
        a2_3d = pd[t->jdiraux[i] + 2];
        t3 = a0_2 * a0_2 + a1_2 * a1_2 + a2_3 * a2_3;
        t3d = a0_2d * a0_2 + a0_2 * a0_2d + (a1_2d * a1_2 + a1_2 * a1_2d) + (a2_3d * a2_3 + a2_3 *
            a2_3d);
        n4 = sqrt(t3);
        n4d = 1.0 / (2.0 * n4) * t3d;
        n20 = a0_2 / n4;
        n20d = (a0_2d - n20 * n4d) * (1.0 / n4);
        n21 = a1_2 / n4;
        n21d = (a1_2d - n21 * n4d) * (1.0 / n4);
        n22 = a2_3 / n4;
        n22d = (a2_3d - n22 * n4d) * (1.0 / n4);
        w0 = 1.0;
        w1 = 0.0;
        w2 = 0.0;
        s = w0 * n20 + w1 * n21 + w2 * n22;
        sd = w0 * n20d + w1 * n21d + w2 * n22d;
        a20 = w0 - s * n20;
        a20d = -(sd * n20 + s * n20d);
        a21 = w1 - s * n21;
        a21d = -(sd * n21 + s * n21d);
        a22 = w2 - s * n22;
        a22d = -(sd * n22 + s * n22d);
        t4 = a20 * a20 + a21 * a21 + a22 * a22;
        t4d = a20d * a20 + a20 * a20d + (a21d * a21 + a21 * a21d) + (a22d * a22 + a22 * a22d);
        n5 = sqrt(t4);
        n5d = 1.0 / (2.0 * n5) * t4d;
        c0 = a20 / n5;
        c0d = (a20d - c0 * n5d) * (1.0 / n5);
        c1 = a21 / n5;
        c1d = (a21d - c1 * n5d) * (1.0 / n5);
        c2_2 = a22 / n5;
        c2_2d = (a22d - c2_2 * n5d) * (1.0 / n5);
        e0 = p[t->jdiradr[i]];
        e0d = pd[t->jdiradr[i]];
        e1 = p[t->jdiradr[i] + 1];
        e1d = pd[t->jdiradr[i] + 1];
        e2 = p[t->jdiradr[i] + 2];
        e2d = pd[t->jdiradr[i] + 2];
        t5 = e0 * e0 + e1 * e1 + e2 * e2;
        t5d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2d * e2 + e2 * e2d);
        n6 = sqrt(t5);
        n6d = 1.0 / (2.0 * n6) * t5d;
        m0 = e0 / n6;
        m0d = (e0d - m0 * n6d) * (1.0 / n6);
        m1 = e1 / n6;
        m1d = (e1d - m1 * n6d) * (1.0 / n6);
        m2 = e2 / n6;
        m2d = (e2d - m2 * n6d) * (1.0 / n6);
        c2 = n20 * m0 + n21 * m1 + n22 * m2;
        c2d = n20d * m0 + n20 * m0d + (n21d * m1 + n21 * m1d) + (n22d * m2 + n22 * m2d);
        s20 = n21 * m2 - n22 * m1;
        s20d = n21d * m2 + n21 * m2d - (n22d * m1 + n22 * m1d);
        s21 = n22 * m0 - n20 * m2;
        s21d = n22d * m0 + n22 * m0d - (n20d * m2 + n20 * m2d);
        s22 = n20 * m1 - n21 * m0;
        s22d = n20d * m1 + n20 * m1d - (n21d * m0 + n21 * m0d);
        t6 = 1.0 + c2;
        t6d = c2d;
        f = (s20 * c0 + s21 * c1 + s22 * c2_2) / t6;
        fd = (s20d * c0 + s20 * c0d + (s21d * c1 + s21 * c1d) + (s22d * c2_2 + s22 * c2_2d) - f *
            t6d) * (1.0 / t6);
        tb23 = axis0b[i][2];
        tb23d = axis0bd[i][2];
        axis0b[i][2] = 0.0;
        axis0bd[i][2] = 0.0;
        c2b = tb23 * c2_2;
        c2bd = tb23d * c2_2 + tb23 * c2_2d;
        c2_2b = tb23 * c2;
        c2_2bd = tb23d * c2 + tb23 * c2d;
        sv2b = tb23;
        sv2bd = tb23d;
        fb = tb23 * s22;
        fbd = tb23d * s22 + tb23 * s22d;
        s22b = tb23 * f;
        s22bd = tb23d * f + tb23 * fd;
        tb22 = axis0b[i][1];
        tb22d = axis0bd[i][1];
        axis0b[i][1] = 0.0;
        axis0bd[i][1] = 0.0;
        c2b += tb22 * c1;
        c2bd += tb22d * c1 + tb22 * c1d;
        c1b = tb22 * c2;
        c1bd = tb22d * c2 + tb22 * c2d;
        sv1b = tb22;
        sv1bd = tb22d;
        fb += tb22 * s21;
        fbd += tb22d * s21 + tb22 * s21d;
        s21b = tb22 * f;
        s21bd = tb22d * f + tb22 * fd;
        tb21 = axis0b[i][0];
        tb21d = axis0bd[i][0];
        axis0b[i][0] = 0.0;
        axis0bd[i][0] = 0.0;
        c2b += tb21 * c0;
        c2bd += tb21d * c0 + tb21 * c0d;
        c0b = tb21 * c2;
        c0bd = tb21d * c2 + tb21 * c2d;
        sv0b = tb21;
        sv0bd = tb21d;
        fb += tb21 * s20;
        fbd += tb21d * s20 + tb21 * s20d;
        s20b = tb21 * f;
        s20bd = tb21d * f + tb21 * fd;
        tb20 = fb / t6;
        tb20d = (fbd - tb20 * t6d) * (1.0 / t6);
        s20b += tb20 * c0;
        s20bd += tb20d * c0 + tb20 * c0d;
        c0b += tb20 * s20;
        c0bd += tb20d * s20 + tb20 * s20d;
        s21b += tb20 * c1;
        s21bd += tb20d * c1 + tb20 * c1d;
        c1b += tb20 * s21;
        c1bd += tb20d * s21 + tb20 * s21d;
        s22b += tb20 * c2_2;
        s22bd += tb20d * c2_2 + tb20 * c2_2d;
        c2_2b += tb20 * s22;
        c2_2bd += tb20d * s22 + tb20 * s22d;
        t6b = -(tb20 * f);
        t6bd = -(tb20d * f + tb20 * fd);
        c2b += t6b;
        c2bd += t6bd;
        s20b += sv2b * c1;
        s20bd += sv2bd * c1 + sv2b * c1d;
        c1b += sv2b * s20;
        c1bd += sv2bd * s20 + sv2b * s20d;
        s21b -= sv2b * c0;
        s21bd -= sv2bd * c0 + sv2b * c0d;
        c0b -= sv2b * s21;
        c0bd -= sv2bd * s21 + sv2b * s21d;
        s22b += sv1b * c0;
        s22bd += sv1bd * c0 + sv1b * c0d;
        c0b += sv1b * s22;
        c0bd += sv1bd * s22 + sv1b * s22d;
        s20b -= sv1b * c2_2;
        s20bd -= sv1bd * c2_2 + sv1b * c2_2d;
        c2_2b -= sv1b * s20;
        c2_2bd -= sv1bd * s20 + sv1b * s20d;
        s21b += sv0b * c2_2;
        s21bd += sv0bd * c2_2 + sv0b * c2_2d;
        c2_2b += sv0b * s21;
        c2_2bd += sv0bd * s21 + sv0b * s21d;
        s22b -= sv0b * c1;
        s22bd -= sv0bd * c1 + sv0b * c1d;
        c1b -= sv0b * s22;
        c1bd -= sv0bd * s22 + sv0b * s22d;
        n20b = s22b * m1;
        n20bd = s22bd * m1 + s22b * m1d;
        m1b = s22b * n20;
        m1bd = s22bd * n20 + s22b * n20d;
        n21b = -(s22b * m0);
        n21bd = -(s22bd * m0 + s22b * m0d);
        m0b = -(s22b * n21);
        m0bd = -(s22bd * n21 + s22b * n21d);
        n22b = s21b * m0;
        n22bd = s21bd * m0 + s21b * m0d;
        m0b += s21b * n22;
        m0bd += s21bd * n22 + s21b * n22d;
        n20b -= s21b * m2;
        n20bd -= s21bd * m2 + s21b * m2d;
        m2b = -(s21b * n20);
        m2bd = -(s21bd * n20 + s21b * n20d);
        n21b += s20b * m2;
        n21bd += s20bd * m2 + s20b * m2d;
        m2b += s20b * n21;
        m2bd += s20bd * n21 + s20b * n21d;
        n22b -= s20b * m1;
        n22bd -= s20bd * m1 + s20b * m1d;
        m1b -= s20b * n22;
        m1bd -= s20bd * n22 + s20b * n22d;
        n20b += c2b * m0;
        /* v turned by the smallest turn that takes the unit vector n to the unit vector m:
         *   c v + s × v + s (s.v) / (1 + c),  c = n.m,  s = n × m */
        n20bd += c2bd * m0 + c2b * m0d;
        m0b += c2b * n20;
        m0bd += c2bd * n20 + c2b * n20d;
        n21b += c2b * m1;
        n21bd += c2bd * m1 + c2b * m1d;
        m1b += c2b * n21;
        m1bd += c2bd * n21 + c2b * n21d;
        n22b += c2b * m2;
        n22bd += c2bd * m2 + c2b * m2d;
        m2b += c2b * n22;
        m2bd += c2bd * n22 + c2b * n22d;
        tb19 = m2b / n6;
        tb19d = (m2bd - tb19 * n6d) * (1.0 / n6);
        e2b = tb19;
        e2bd = tb19d;
        n6b = -(tb19 * m2);
        n6bd = -(tb19d * m2 + tb19 * m2d);
        tb18 = m1b / n6;
        tb18d = (m1bd - tb18 * n6d) * (1.0 / n6);
        e1b = tb18;
        e1bd = tb18d;
        n6b -= tb18 * m1;
        n6bd -= tb18d * m1 + tb18 * m1d;
        tb17 = m0b / n6;
        tb17d = (m0bd - tb17 * n6d) * (1.0 / n6);
        e0b = tb17;
        e0bd = tb17d;
        n6b -= tb17 * m0;
        n6bd -= tb17d * m0 + tb17 * m0d;
        t5b = n6b * (1.0 / (2.0 * n6));
        t5bd = n6bd * (1.0 / (2.0 * n6)) - n6b * (1.0 / (2.0 * n6) * (2.0 * n6d) / (2.0 * n6));
        e0b += t5b * e0;
        e0bd += t5bd * e0 + t5b * e0d;
        e0b += t5b * e0;
        e0bd += t5bd * e0 + t5b * e0d;
        e1b += t5b * e1;
        e1bd += t5bd * e1 + t5b * e1d;
        e1b += t5b * e1;
        e1bd += t5bd * e1 + t5b * e1d;
        e2b += t5b * e2;
        e2bd += t5bd * e2 + t5b * e2d;
        e2b += t5b * e2;
        e2bd += t5bd * e2 + t5b * e2d;
        pb[t->jdiradr[i] + 2] += e2b;
        pbd[t->jdiradr[i] + 2] += e2bd;
        pb[t->jdiradr[i] + 1] += e1b;
        pbd[t->jdiradr[i] + 1] += e1bd;
        pb[t->jdiradr[i]] += e0b;
        pbd[t->jdiradr[i]] += e0bd;
        tb16 = c2_2b / n5;
        tb16d = (c2_2bd - tb16 * n5d) * (1.0 / n5);
        a22b = tb16;
        a22bd = tb16d;
        n5b = -(tb16 * c2_2);
        n5bd = -(tb16d * c2_2 + tb16 * c2_2d);
        tb15 = c1b / n5;
        tb15d = (c1bd - tb15 * n5d) * (1.0 / n5);
        a21b = tb15;
        a21bd = tb15d;
        n5b -= tb15 * c1;
        n5bd -= tb15d * c1 + tb15 * c1d;
        tb14 = c0b / n5;
        tb14d = (c0bd - tb14 * n5d) * (1.0 / n5);
        a20b = tb14;
        a20bd = tb14d;
        n5b -= tb14 * c0;
        n5bd -= tb14d * c0 + tb14 * c0d;
        t4b = n5b * (1.0 / (2.0 * n5));
        t4bd = n5bd * (1.0 / (2.0 * n5)) - n5b * (1.0 / (2.0 * n5) * (2.0 * n5d) / (2.0 * n5));
        a20b += t4b * a20;
        a20bd += t4bd * a20 + t4b * a20d;
        a20b += t4b * a20;
        a20bd += t4bd * a20 + t4b * a20d;
        a21b += t4b * a21;
        a21bd += t4bd * a21 + t4b * a21d;
        a21b += t4b * a21;
        a21bd += t4bd * a21 + t4b * a21d;
        a22b += t4b * a22;
        a22bd += t4bd * a22 + t4b * a22d;
        a22b += t4b * a22;
        a22bd += t4bd * a22 + t4b * a22d;
        sb = -(a22b * n22);
        sbd = -(a22bd * n22 + a22b * n22d);
        n22b -= a22b * s;
        n22bd -= a22bd * s + a22b * sd;
        sb -= a21b * n21;
        sbd -= a21bd * n21 + a21b * n21d;
        n21b -= a21b * s;
        n21bd -= a21bd * s + a21b * sd;
        sb -= a20b * n20;
        sbd -= a20bd * n20 + a20b * n20d;
        n20b -= a20b * s;
        n20bd -= a20bd * s + a20b * sd;
        n20b += sb * w0;
        /* the part of w across the unit vector n, made a unit vector */
        n20bd += sbd * w0;
        n21b += sb * w1;
        n21bd += sbd * w1;
        n22b += sb * w2;
        n22bd += sbd * w2;
        tb13 = n22b / n4;
        tb13d = (n22bd - tb13 * n4d) * (1.0 / n4);
        a2_3b = tb13;
        a2_3bd = tb13d;
        n4b = -(tb13 * n22);
        n4bd = -(tb13d * n22 + tb13 * n22d);
        tb12 = n21b / n4;
        tb12d = (n21bd - tb12 * n4d) * (1.0 / n4);
        a1_2b = tb12;
        a1_2bd = tb12d;
        n4b -= tb12 * n21;
        n4bd -= tb12d * n21 + tb12 * n21d;
        tb11 = n20b / n4;
        tb11d = (n20bd - tb11 * n4d) * (1.0 / n4);
        a0_2b = tb11;
        a0_2bd = tb11d;
        n4b -= tb11 * n20;
        n4bd -= tb11d * n20 + tb11 * n20d;
        t3b = n4b * (1.0 / (2.0 * n4));
        t3bd = n4bd * (1.0 / (2.0 * n4)) - n4b * (1.0 / (2.0 * n4) * (2.0 * n4d) / (2.0 * n4));
        a0_2b += t3b * a0_2;
        a0_2bd += t3bd * a0_2 + t3b * a0_2d;
        a0_2b += t3b * a0_2;
        a0_2bd += t3bd * a0_2 + t3b * a0_2d;
        a1_2b += t3b * a1_2;
        a1_2bd += t3bd * a1_2 + t3b * a1_2d;
        a1_2b += t3b * a1_2;
        a1_2bd += t3bd * a1_2 + t3b * a1_2d;
        a2_3b += t3b * a2_3;
        a2_3bd += t3bd * a2_3 + t3b * a2_3d;
        a2_3b += t3b * a2_3;
        a2_3bd += t3bd * a2_3 + t3b * a2_3d;
        pb[t->jdiraux[i] + 2] += a2_3b;
        pbd[t->jdiraux[i] + 2] += a2_3bd;
        pb[t->jdiraux[i] + 1] += a1_2b;
        pbd[t->jdiraux[i] + 1] += a1_2bd;
        pb[t->jdiraux[i]] += a0_2b;
        pbd[t->jdiraux[i]] += a0_2bd;
      } else {
        a0_3 = p[t->jdiradr[i]];
        a0_3d = pd[t->jdiradr[i]];
        a1_3 = p[t->jdiradr[i] + 1];
        a1_3d = pd[t->jdiradr[i] + 1];
        a2_4 = p[t->jdiradr[i] + 2];
        a2_4d = pd[t->jdiradr[i] + 2];
        t7 = a0_3 * a0_3 + a1_3 * a1_3 + a2_4 * a2_4;
        t7d = a0_3d * a0_3 + a0_3 * a0_3d + (a1_3d * a1_3 + a1_3 * a1_3d) + (a2_4d * a2_4 + a2_4 *
            a2_4d);
        n7 = sqrt(t7);
        n7d = 1.0 / (2.0 * n7) * t7d;
        n20_2 = a0_3 / n7;
        n20_2d = (a0_3d - n20_2 * n7d) * (1.0 / n7);
        n21_2 = a1_3 / n7;
        n21_2d = (a1_3d - n21_2 * n7d) * (1.0 / n7);
        n22_2 = a2_4 / n7;
        n22_2d = (a2_4d - n22_2 * n7d) * (1.0 / n7);
        if (t->jdirkind[i] == MAGGI_DIR_ACROSS || t->jdirkind[i] == MAGGI_DIR_NORMAL) {
          w0_2 = p[t->jdiraux[i]];
          w0_2d = pd[t->jdiraux[i]];
          w1_2 = p[t->jdiraux[i] + 1];
          w1_2d = pd[t->jdiraux[i] + 1];
          w2_2 = p[t->jdiraux[i] + 2];
          w2_2d = pd[t->jdiraux[i] + 2];
        } else {
          w0_2 = t->jdiraux[i] == 0 ? 1.0 : 0.0;
          w0_2d = 0.0;
          w1_2 = t->jdiraux[i] == 1 ? 1.0 : 0.0;
          w1_2d = 0.0;
          w2_2 = t->jdiraux[i] == 2 ? 1.0 : 0.0;
          w2_2d = 0.0;
        }
        s3 = w0_2 * n20_2 + w1_2 * n21_2 + w2_2 * n22_2;
        s3d = w0_2d * n20_2 + w0_2 * n20_2d + (w1_2d * n21_2 + w1_2 * n21_2d) + (w2_2d * n22_2 +
            w2_2 * n22_2d);
        a30 = w0_2 - s3 * n20_2;
        a30d = w0_2d - (s3d * n20_2 + s3 * n20_2d);
        a31 = w1_2 - s3 * n21_2;
        a31d = w1_2d - (s3d * n21_2 + s3 * n21_2d);
        a32 = w2_2 - s3 * n22_2;
        a32d = w2_2d - (s3d * n22_2 + s3 * n22_2d);
        t8 = a30 * a30 + a31 * a31 + a32 * a32;
        t8d = a30d * a30 + a30 * a30d + (a31d * a31 + a31 * a31d) + (a32d * a32 + a32 * a32d);
        n8 = sqrt(t8);
        n8d = 1.0 / (2.0 * n8) * t8d;
        c0_2 = a30 / n8;
        c0_2d = (a30d - c0_2 * n8d) * (1.0 / n8);
        c1_2 = a31 / n8;
        c1_2d = (a31d - c1_2 * n8d) * (1.0 / n8);
        c2_3 = a32 / n8;
        c2_3d = (a32d - c2_3 * n8d) * (1.0 / n8);
        c0_2b = 0.0;
        c0_2bd = 0.0;
        c1_2b = 0.0;
        c1_2bd = 0.0;
        c2_3b = 0.0;
        c2_3bd = 0.0;
        n20_2b = 0.0;
        n20_2bd = 0.0;
        n21_2b = 0.0;
        n21_2bd = 0.0;
        n22_2b = 0.0;
        n22_2bd = 0.0;
        if (t->jdirkind[i] == MAGGI_DIR_ACROSS || t->jdirkind[i] == MAGGI_DIR_ACROSS_GLOBAL) {
          c2_3b += axis0b[i][2];
          c2_3bd += axis0bd[i][2];
          axis0b[i][2] = 0.0;
          axis0bd[i][2] = 0.0;
          c1_2b += axis0b[i][1];
          c1_2bd += axis0bd[i][1];
          axis0b[i][1] = 0.0;
          axis0bd[i][1] = 0.0;
          c0_2b += axis0b[i][0];
          c0_2bd += axis0bd[i][0];
          axis0b[i][0] = 0.0;
          axis0bd[i][0] = 0.0;
        } else {
          tb32 = axis0b[i][2];
          tb32d = axis0bd[i][2];
          axis0b[i][2] = 0.0;
          axis0bd[i][2] = 0.0;
          n20_2b += tb32 * c1_2;
          n20_2bd += tb32d * c1_2 + tb32 * c1_2d;
          c1_2b += tb32 * n20_2;
          c1_2bd += tb32d * n20_2 + tb32 * n20_2d;
          n21_2b -= tb32 * c0_2;
          n21_2bd -= tb32d * c0_2 + tb32 * c0_2d;
          c0_2b -= tb32 * n21_2;
          c0_2bd -= tb32d * n21_2 + tb32 * n21_2d;
          tb31 = axis0b[i][1];
          tb31d = axis0bd[i][1];
          axis0b[i][1] = 0.0;
          axis0bd[i][1] = 0.0;
          n22_2b += tb31 * c0_2;
          n22_2bd += tb31d * c0_2 + tb31 * c0_2d;
          c0_2b += tb31 * n22_2;
          c0_2bd += tb31d * n22_2 + tb31 * n22_2d;
          n20_2b -= tb31 * c2_3;
          n20_2bd -= tb31d * c2_3 + tb31 * c2_3d;
          c2_3b -= tb31 * n20_2;
          c2_3bd -= tb31d * n20_2 + tb31 * n20_2d;
          tb30 = axis0b[i][0];
          tb30d = axis0bd[i][0];
          axis0b[i][0] = 0.0;
          axis0bd[i][0] = 0.0;
          n21_2b += tb30 * c2_3;
          n21_2bd += tb30d * c2_3 + tb30 * c2_3d;
          c2_3b += tb30 * n21_2;
          c2_3bd += tb30d * n21_2 + tb30 * n21_2d;
          n22_2b -= tb30 * c1_2;
          n22_2bd -= tb30d * c1_2 + tb30 * c1_2d;
          c1_2b -= tb30 * n22_2;
          c1_2bd -= tb30d * n22_2 + tb30 * n22_2d;
        }
        tb29 = c2_3b / n8;
        tb29d = (c2_3bd - tb29 * n8d) * (1.0 / n8);
        a32b = tb29;
        a32bd = tb29d;
        n8b = -(tb29 * c2_3);
        n8bd = -(tb29d * c2_3 + tb29 * c2_3d);
        tb28 = c1_2b / n8;
        tb28d = (c1_2bd - tb28 * n8d) * (1.0 / n8);
        a31b = tb28;
        a31bd = tb28d;
        n8b -= tb28 * c1_2;
        n8bd -= tb28d * c1_2 + tb28 * c1_2d;
        tb27 = c0_2b / n8;
        tb27d = (c0_2bd - tb27 * n8d) * (1.0 / n8);
        a30b = tb27;
        a30bd = tb27d;
        n8b -= tb27 * c0_2;
        n8bd -= tb27d * c0_2 + tb27 * c0_2d;
        t8b = n8b * (1.0 / (2.0 * n8));
        t8bd = n8bd * (1.0 / (2.0 * n8)) - n8b * (1.0 / (2.0 * n8) * (2.0 * n8d) / (2.0 * n8));
        a30b += t8b * a30;
        a30bd += t8bd * a30 + t8b * a30d;
        a30b += t8b * a30;
        a30bd += t8bd * a30 + t8b * a30d;
        a31b += t8b * a31;
        a31bd += t8bd * a31 + t8b * a31d;
        a31b += t8b * a31;
        a31bd += t8bd * a31 + t8b * a31d;
        a32b += t8b * a32;
        a32bd += t8bd * a32 + t8b * a32d;
        a32b += t8b * a32;
        a32bd += t8bd * a32 + t8b * a32d;
        w2_2b = a32b;
        w2_2bd = a32bd;
        s3b = -(a32b * n22_2);
        s3bd = -(a32bd * n22_2 + a32b * n22_2d);
        n22_2b -= a32b * s3;
        n22_2bd -= a32bd * s3 + a32b * s3d;
        w1_2b = a31b;
        w1_2bd = a31bd;
        s3b -= a31b * n21_2;
        s3bd -= a31bd * n21_2 + a31b * n21_2d;
        n21_2b -= a31b * s3;
        n21_2bd -= a31bd * s3 + a31b * s3d;
        w0_2b = a30b;
        w0_2bd = a30bd;
        s3b -= a30b * n20_2;
        s3bd -= a30bd * n20_2 + a30b * n20_2d;
        n20_2b -= a30b * s3;
        n20_2bd -= a30bd * s3 + a30b * s3d;
        w0_2b += s3b * n20_2;
        /* the part of w across the unit vector n, made a unit vector */
        w0_2bd += s3bd * n20_2 + s3b * n20_2d;
        n20_2b += s3b * w0_2;
        n20_2bd += s3bd * w0_2 + s3b * w0_2d;
        w1_2b += s3b * n21_2;
        w1_2bd += s3bd * n21_2 + s3b * n21_2d;
        n21_2b += s3b * w1_2;
        n21_2bd += s3bd * w1_2 + s3b * w1_2d;
        w2_2b += s3b * n22_2;
        w2_2bd += s3bd * n22_2 + s3b * n22_2d;
        n22_2b += s3b * w2_2;
        n22_2bd += s3bd * w2_2 + s3b * w2_2d;
        if (t->jdirkind[i] == MAGGI_DIR_ACROSS || t->jdirkind[i] == MAGGI_DIR_NORMAL) {
          pb[t->jdiraux[i] + 2] += w2_2b;
          pbd[t->jdiraux[i] + 2] += w2_2bd;
          w2_2b = 0.0;
          w2_2bd = 0.0;
          pb[t->jdiraux[i] + 1] += w1_2b;
          pbd[t->jdiraux[i] + 1] += w1_2bd;
          w1_2b = 0.0;
          w1_2bd = 0.0;
          pb[t->jdiraux[i]] += w0_2b;
          pbd[t->jdiraux[i]] += w0_2bd;
          w0_2b = 0.0;
          w0_2bd = 0.0;
        } else {
          w2_2b = 0.0;
          w2_2bd = 0.0;
          w1_2b = 0.0;
          w1_2bd = 0.0;
          w0_2b = 0.0;
          w0_2bd = 0.0;
        }
        tb26 = n22_2b / n7;
        tb26d = (n22_2bd - tb26 * n7d) * (1.0 / n7);
        a2_4b = tb26;
        a2_4bd = tb26d;
        n7b = -(tb26 * n22_2);
        n7bd = -(tb26d * n22_2 + tb26 * n22_2d);
        tb25 = n21_2b / n7;
        tb25d = (n21_2bd - tb25 * n7d) * (1.0 / n7);
        a1_3b = tb25;
        a1_3bd = tb25d;
        n7b -= tb25 * n21_2;
        n7bd -= tb25d * n21_2 + tb25 * n21_2d;
        tb24 = n20_2b / n7;
        tb24d = (n20_2bd - tb24 * n7d) * (1.0 / n7);
        a0_3b = tb24;
        a0_3bd = tb24d;
        n7b -= tb24 * n20_2;
        n7bd -= tb24d * n20_2 + tb24 * n20_2d;
        t7b = n7b * (1.0 / (2.0 * n7));
        t7bd = n7bd * (1.0 / (2.0 * n7)) - n7b * (1.0 / (2.0 * n7) * (2.0 * n7d) / (2.0 * n7));
        a0_3b += t7b * a0_3;
        a0_3bd += t7bd * a0_3 + t7b * a0_3d;
        a0_3b += t7b * a0_3;
        a0_3bd += t7bd * a0_3 + t7b * a0_3d;
        a1_3b += t7b * a1_3;
        a1_3bd += t7bd * a1_3 + t7b * a1_3d;
        a1_3b += t7b * a1_3;
        a1_3bd += t7bd * a1_3 + t7b * a1_3d;
        a2_4b += t7b * a2_4;
        a2_4bd += t7bd * a2_4 + t7b * a2_4d;
        a2_4b += t7b * a2_4;
        a2_4bd += t7bd * a2_4 + t7b * a2_4d;
        pb[t->jdiradr[i] + 2] += a2_4b;
        pbd[t->jdiradr[i] + 2] += a2_4bd;
        pb[t->jdiradr[i] + 1] += a1_3b;
        pbd[t->jdiradr[i] + 1] += a1_3bd;
        pb[t->jdiradr[i]] += a0_3b;
        pbd[t->jdiradr[i]] += a0_3bd;
      }
    }
    if (up == t->nbody) {
      pb[adr + 2] += offset0b[i][2];
      pbd[adr + 2] += offset0bd[i][2];
      offset0b[i][2] = 0.0;
      offset0bd[i][2] = 0.0;
    } else {
      tb4 = offset0b[i][2];
      tb4d = offset0bd[i][2];
      offset0b[i][2] = 0.0;
      offset0bd[i][2] = 0.0;
      pb[adr + 2] += tb4;
      pbd[adr + 2] += tb4d;
      pb[t->jpointadr[up] + 2] -= tb4;
      pbd[t->jpointadr[up] + 2] -= tb4d;
    }
    if (up == t->nbody) {
      pb[adr + 1] += offset0b[i][1];
      pbd[adr + 1] += offset0bd[i][1];
      offset0b[i][1] = 0.0;
      offset0bd[i][1] = 0.0;
    } else {
      tb3 = offset0b[i][1];
      tb3d = offset0bd[i][1];
      offset0b[i][1] = 0.0;
      offset0bd[i][1] = 0.0;
      pb[adr + 1] += tb3;
      pbd[adr + 1] += tb3d;
      pb[t->jpointadr[up] + 1] -= tb3;
      pbd[t->jpointadr[up] + 1] -= tb3d;
    }
    if (up == t->nbody) {
      pb[adr] += offset0b[i][0];
      pbd[adr] += offset0bd[i][0];
      offset0b[i][0] = 0.0;
      offset0bd[i][0] = 0.0;
    } else {
      tb2 = offset0b[i][0];
      tb2d = offset0bd[i][0];
      offset0b[i][0] = 0.0;
      offset0bd[i][0] = 0.0;
      pb[adr] += tb2;
      pbd[adr] += tb2d;
      pb[t->jpointadr[up]] -= tb2;
      pbd[t->jpointadr[up]] -= tb2d;
    }
  }
}

void maggi_inertia_constants_b_d(const maggi_topo *t, const double p[restrict t->np],
                                 const double pd[restrict t->np], double pb[restrict t->np],
                                 double pbd[restrict t->np], double body0[restrict t->nbody][10],
                                 double body0d[restrict t->nbody][10],
                                 double body0b[restrict t->nbody][10],
                                 double body0bd[restrict t->nbody][10])
{
  int i, k;
  double J0_2b, J0_2bd, J0b, J0bd, J1_2b, J1_2bd, J1b, J1bd, J2_2b, J2_2bd, J2_3b, J2_3bd, J3_2b,
      J3_2bd, J3_3b, J3_3bd, J4_2b, J4_2bd, J4_3b, J4_3bd, J5_2b, J5_2bd, J5b, J5bd, e0, e0b, e0bd,
      e0d, e1, e1b, e1bd, e1d, e2, e2b, e2bd, e2d, g0, g0_2, g0_2b, g0_2bd, g0_2d, g0_3, g0_3b,
      g0_3bd, g0_3d, g0_4, g0_4b, g0_4bd, g0_4d, g0_5, g0_5b, g0_5bd, g0_5d, g0b, g0bd, g0d, g1,
      g1_2, g1_2b, g1_2bd, g1_2d, g1_3, g1_3b, g1_3bd, g1_3d, g1_4, g1_4b, g1_4bd, g1_4d, g1_5,
      g1_5b, g1_5bd, g1_5d, g1b, g1bd, g1d, g2, g2_2, g2_2b, g2_2bd, g2_2d, g2_3, g2_3b, g2_3bd,
      g2_3d, g2_4, g2_4b, g2_4bd, g2_4d, g2_5, g2_5b, g2_5bd, g2_5d, g2b, g2bd, g2d, m, m2, m2b,
      m2bd, m2d, mb, mbd, md, p_i, p_i1, p_i1b, p_i1bd, p_i1d, p_i2, p_i2b, p_i2bd, p_i2d, p_i3,
      p_i3b, p_i3bd, p_i3d, p_i4, p_i4b, p_i4bd, p_i4d, p_i5, p_i5b, p_i5bd, p_i5d, p_i6, p_i6b,
      p_i6bd, p_i6d, p_i7, p_i7b, p_i7bd, p_i7d, p_i8, p_i8b, p_i8bd, p_i8d, p_ib, p_ibd, p_id,
      tb10, tb10d, tb11, tb11d, tb12, tb12d, tb13, tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d,
      tb17, tb17d, tb18, tb18d, tb19, tb19d, tb2, tb20, tb20d, tb21, tb21d, tb22, tb22d, tb23,
      tb23d, tb24, tb24d, tb25, tb25d, tb26, tb26d, tb27, tb27d, tb28, tb28d, tb29, tb29d, tb2d,
      tb3, tb30, tb30d, tb31, tb31d, tb32, tb32d, tb33, tb33d, tb34, tb34d, tb35, tb35d, tb36,
      tb36d, tb37, tb37d, tb38, tb38d, tb39, tb39d, tb3d, tb4, tb40, tb40d, tb41, tb41d, tb42,
      tb42d, tb43, tb43d, tb44, tb44d, tb45, tb45d, tb46, tb46d, tb47, tb47d, tb48, tb48d, tb49,
      tb49d, tb4d, tb5, tb50, tb50d, tb51, tb51d, tb52, tb52d, tb53, tb53d, tb54, tb54d, tb55,
      tb55d, tb56, tb56d, tb57, tb57d, tb58, tb58d, tb59, tb59d, tb5d, tb6, tb60, tb60d, tb61,
      tb61d, tb62, tb62d, tb63, tb63d, tb64, tb64d, tb65, tb65d, tb66, tb66d, tb67, tb67d, tb68,
      tb68d, tb69, tb69d, tb6d, tb7, tb70, tb70d, tb71, tb71d, tb72, tb72d, tb73, tb73d, tb74,
      tb74d, tb75, tb75d, tb76, tb76d, tb77, tb77d, tb78, tb78d, tb79, tb79d, tb7d, tb8, tb80,
      tb80d, tb81, tb81d, tb82, tb82d, tb83, tb83d, tb84, tb84d, tb85, tb85d, tb8d, tb9, tb9d;

  (void)body0;
  (void)body0d;
  for (i = t->nlump - 1; i >= 0; --i) {
    if (t->lumpkind[i] == MAGGI_LUMP_RIGID) {
      g0 = p[t->lumpadr[i] + 1] - p[t->jpointadr[t->lumpbody[i]]];
      g0d = pd[t->lumpadr[i] + 1] - pd[t->jpointadr[t->lumpbody[i]]];
      g1 = p[t->lumpadr[i] + 2] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g1d = pd[t->lumpadr[i] + 2] - pd[t->jpointadr[t->lumpbody[i]] + 1];
      g2 = p[t->lumpadr[i] + 3] - p[t->jpointadr[t->lumpbody[i]] + 2];
      g2d = pd[t->lumpadr[i] + 3] - pd[t->jpointadr[t->lumpbody[i]] + 2];
      p_i = p[t->lumpadr[i]];
      p_id = pd[t->lumpadr[i]];
      tb15 = body0b[t->lumpbody[i]][9];
      tb15d = body0bd[t->lumpbody[i]][9];
      J5b = tb15;
      J5bd = tb15d;
      tb16 = tb15 * g2;
      tb16d = tb15d * g2 + tb15 * g2d;
      p_ib = -(tb16 * g1);
      p_ibd = -(tb16d * g1 + tb16 * g1d);
      g1b = -(tb16 * p_i);
      g1bd = -(tb16d * p_i + tb16 * p_id);
      g2b = -(tb15 * (p_i * g1));
      g2bd = -(tb15d * (p_i * g1) + tb15 * (p_id * g1 + p_i * g1d));
      tb13 = body0b[t->lumpbody[i]][8];
      tb13d = body0bd[t->lumpbody[i]][8];
      J4_2b = tb13;
      J4_2bd = tb13d;
      tb14 = tb13 * g2;
      tb14d = tb13d * g2 + tb13 * g2d;
      p_ib -= tb14 * g0;
      p_ibd -= tb14d * g0 + tb14 * g0d;
      g0b = -(tb14 * p_i);
      g0bd = -(tb14d * p_i + tb14 * p_id);
      g2b -= tb13 * (p_i * g0);
      g2bd -= tb13d * (p_i * g0) + tb13 * (p_id * g0 + p_i * g0d);
      tb11 = body0b[t->lumpbody[i]][7];
      tb11d = body0bd[t->lumpbody[i]][7];
      J3_2b = tb11;
      J3_2bd = tb11d;
      tb12 = tb11 * g1;
      tb12d = tb11d * g1 + tb11 * g1d;
      p_ib -= tb12 * g0;
      p_ibd -= tb12d * g0 + tb12 * g0d;
      g0b -= tb12 * p_i;
      g0bd -= tb12d * p_i + tb12 * p_id;
      g1b -= tb11 * (p_i * g0);
      g1bd -= tb11d * (p_i * g0) + tb11 * (p_id * g0 + p_i * g0d);
      tb9 = body0b[t->lumpbody[i]][6];
      tb9d = body0bd[t->lumpbody[i]][6];
      J2_2b = tb9;
      J2_2bd = tb9d;
      p_ib += tb9 * (g0 * g0 + g1 * g1);
      p_ibd += tb9d * (g0 * g0 + g1 * g1) + tb9 * (g0d * g0 + g0 * g0d + (g1d * g1 + g1 * g1d));
      tb10 = tb9 * p_i;
      tb10d = tb9d * p_i + tb9 * p_id;
      g0b += tb10 * g0;
      g0bd += tb10d * g0 + tb10 * g0d;
      g0b += tb10 * g0;
      g0bd += tb10d * g0 + tb10 * g0d;
      g1b += tb10 * g1;
      g1bd += tb10d * g1 + tb10 * g1d;
      g1b += tb10 * g1;
      g1bd += tb10d * g1 + tb10 * g1d;
      tb7 = body0b[t->lumpbody[i]][5];
      tb7d = body0bd[t->lumpbody[i]][5];
      J1b = tb7;
      J1bd = tb7d;
      p_ib += tb7 * (g0 * g0 + g2 * g2);
      p_ibd += tb7d * (g0 * g0 + g2 * g2) + tb7 * (g0d * g0 + g0 * g0d + (g2d * g2 + g2 * g2d));
      tb8 = tb7 * p_i;
      tb8d = tb7d * p_i + tb7 * p_id;
      g0b += tb8 * g0;
      g0bd += tb8d * g0 + tb8 * g0d;
      g0b += tb8 * g0;
      g0bd += tb8d * g0 + tb8 * g0d;
      g2b += tb8 * g2;
      g2bd += tb8d * g2 + tb8 * g2d;
      g2b += tb8 * g2;
      g2bd += tb8d * g2 + tb8 * g2d;
      tb5 = body0b[t->lumpbody[i]][4];
      tb5d = body0bd[t->lumpbody[i]][4];
      J0b = tb5;
      J0bd = tb5d;
      p_ib += tb5 * (g1 * g1 + g2 * g2);
      p_ibd += tb5d * (g1 * g1 + g2 * g2) + tb5 * (g1d * g1 + g1 * g1d + (g2d * g2 + g2 * g2d));
      tb6 = tb5 * p_i;
      tb6d = tb5d * p_i + tb5 * p_id;
      g1b += tb6 * g1;
      g1bd += tb6d * g1 + tb6 * g1d;
      g1b += tb6 * g1;
      g1bd += tb6d * g1 + tb6 * g1d;
      g2b += tb6 * g2;
      g2bd += tb6d * g2 + tb6 * g2d;
      g2b += tb6 * g2;
      g2bd += tb6d * g2 + tb6 * g2d;
      tb4 = body0b[t->lumpbody[i]][3];
      tb4d = body0bd[t->lumpbody[i]][3];
      p_ib += tb4 * g2;
      p_ibd += tb4d * g2 + tb4 * g2d;
      g2b += tb4 * p_i;
      g2bd += tb4d * p_i + tb4 * p_id;
      tb3 = body0b[t->lumpbody[i]][2];
      tb3d = body0bd[t->lumpbody[i]][2];
      p_ib += tb3 * g1;
      p_ibd += tb3d * g1 + tb3 * g1d;
      g1b += tb3 * p_i;
      g1bd += tb3d * p_i + tb3 * p_id;
      tb2 = body0b[t->lumpbody[i]][1];
      tb2d = body0bd[t->lumpbody[i]][1];
      p_ib += tb2 * g0;
      p_ibd += tb2d * g0 + tb2 * g0d;
      g0b += tb2 * p_i;
      g0bd += tb2d * p_i + tb2 * p_id;
      p_ib += body0b[t->lumpbody[i]][0];
      /* inertia of a mass m at g and of J about it, about the reference point:
       *   m,  m g,  J + m (g.g I - g g^T) */
      p_ibd += body0bd[t->lumpbody[i]][0];
      pb[t->lumpadr[i]] += p_ib;
      pbd[t->lumpadr[i]] += p_ibd;
      pb[t->lumpadr[i] + 9] += J5b;
      pbd[t->lumpadr[i] + 9] += J5bd;
      pb[t->lumpadr[i] + 8] += J4_2b;
      pbd[t->lumpadr[i] + 8] += J4_2bd;
      pb[t->lumpadr[i] + 7] += J3_2b;
      pbd[t->lumpadr[i] + 7] += J3_2bd;
      pb[t->lumpadr[i] + 6] += J2_2b;
      pbd[t->lumpadr[i] + 6] += J2_2bd;
      pb[t->lumpadr[i] + 5] += J1b;
      pbd[t->lumpadr[i] + 5] += J1bd;
      pb[t->lumpadr[i] + 4] += J0b;
      pbd[t->lumpadr[i] + 4] += J0bd;
      pb[t->lumpadr[i] + 3] += g2b;
      pbd[t->lumpadr[i] + 3] += g2bd;
      pb[t->jpointadr[t->lumpbody[i]] + 2] -= g2b;
      pbd[t->jpointadr[t->lumpbody[i]] + 2] -= g2bd;
      pb[t->lumpadr[i] + 2] += g1b;
      pbd[t->lumpadr[i] + 2] += g1bd;
      pb[t->jpointadr[t->lumpbody[i]] + 1] -= g1b;
      pbd[t->jpointadr[t->lumpbody[i]] + 1] -= g1bd;
      pb[t->lumpadr[i] + 1] += g0b;
      pbd[t->lumpadr[i] + 1] += g0bd;
      pb[t->jpointadr[t->lumpbody[i]]] -= g0b;
      pbd[t->jpointadr[t->lumpbody[i]]] -= g0bd;
    } else if (t->lumpkind[i] == MAGGI_LUMP_BAR) {
      p_i1 = p[t->lumpadr[i] + 1];
      p_i1d = pd[t->lumpadr[i] + 1];
      p_i4 = p[t->lumpadr[i] + 4];
      p_i4d = pd[t->lumpadr[i] + 4];
      g0_2 = 0.5 * (p_i1 + p_i4) - p[t->jpointadr[t->lumpbody[i]]];
      g0_2d = 0.5 * (p_i1d + p_i4d) - pd[t->jpointadr[t->lumpbody[i]]];
      e0 = p_i4 - p_i1;
      e0d = p_i4d - p_i1d;
      p_i2 = p[t->lumpadr[i] + 2];
      p_i2d = pd[t->lumpadr[i] + 2];
      p_i5 = p[t->lumpadr[i] + 5];
      p_i5d = pd[t->lumpadr[i] + 5];
      g1_2 = 0.5 * (p_i2 + p_i5) - p[t->jpointadr[t->lumpbody[i]] + 1];
      g1_2d = 0.5 * (p_i2d + p_i5d) - pd[t->jpointadr[t->lumpbody[i]] + 1];
      e1 = p_i5 - p_i2;
      e1d = p_i5d - p_i2d;
      p_i3 = p[t->lumpadr[i] + 3];
      p_i3d = pd[t->lumpadr[i] + 3];
      p_i6 = p[t->lumpadr[i] + 6];
      p_i6d = pd[t->lumpadr[i] + 6];
      g2_2 = 0.5 * (p_i3 + p_i6) - p[t->jpointadr[t->lumpbody[i]] + 2];
      g2_2d = 0.5 * (p_i3d + p_i6d) - pd[t->jpointadr[t->lumpbody[i]] + 2];
      e2 = p_i6 - p_i3;
      e2d = p_i6d - p_i3d;
      p_i7 = p[t->lumpadr[i]];
      p_i7d = pd[t->lumpadr[i]];
      tb39 = body0b[t->lumpbody[i]][9];
      tb39d = body0bd[t->lumpbody[i]][9];
      J5_2b = tb39;
      J5_2bd = tb39d;
      tb40 = tb39 * g2_2;
      tb40d = tb39d * g2_2 + tb39 * g2_2d;
      p_i7b = -(tb40 * g1_2);
      p_i7bd = -(tb40d * g1_2 + tb40 * g1_2d);
      g1_2b = -(tb40 * p_i7);
      g1_2bd = -(tb40d * p_i7 + tb40 * p_i7d);
      g2_2b = -(tb39 * (p_i7 * g1_2));
      g2_2bd = -(tb39d * (p_i7 * g1_2) + tb39 * (p_i7d * g1_2 + p_i7 * g1_2d));
      tb37 = body0b[t->lumpbody[i]][8];
      tb37d = body0bd[t->lumpbody[i]][8];
      J4_3b = tb37;
      J4_3bd = tb37d;
      tb38 = tb37 * g2_2;
      tb38d = tb37d * g2_2 + tb37 * g2_2d;
      p_i7b -= tb38 * g0_2;
      p_i7bd -= tb38d * g0_2 + tb38 * g0_2d;
      g0_2b = -(tb38 * p_i7);
      g0_2bd = -(tb38d * p_i7 + tb38 * p_i7d);
      g2_2b -= tb37 * (p_i7 * g0_2);
      g2_2bd -= tb37d * (p_i7 * g0_2) + tb37 * (p_i7d * g0_2 + p_i7 * g0_2d);
      tb35 = body0b[t->lumpbody[i]][7];
      tb35d = body0bd[t->lumpbody[i]][7];
      J3_3b = tb35;
      J3_3bd = tb35d;
      tb36 = tb35 * g1_2;
      tb36d = tb35d * g1_2 + tb35 * g1_2d;
      p_i7b -= tb36 * g0_2;
      p_i7bd -= tb36d * g0_2 + tb36 * g0_2d;
      g0_2b -= tb36 * p_i7;
      g0_2bd -= tb36d * p_i7 + tb36 * p_i7d;
      g1_2b -= tb35 * (p_i7 * g0_2);
      g1_2bd -= tb35d * (p_i7 * g0_2) + tb35 * (p_i7d * g0_2 + p_i7 * g0_2d);
      tb33 = body0b[t->lumpbody[i]][6];
      tb33d = body0bd[t->lumpbody[i]][6];
      J2_3b = tb33;
      J2_3bd = tb33d;
      p_i7b += tb33 * (g0_2 * g0_2 + g1_2 * g1_2);
      p_i7bd += tb33d * (g0_2 * g0_2 + g1_2 * g1_2) + tb33 * (g0_2d * g0_2 + g0_2 * g0_2d + (g1_2d *
          g1_2 + g1_2 * g1_2d));
      tb34 = tb33 * p_i7;
      tb34d = tb33d * p_i7 + tb33 * p_i7d;
      g0_2b += tb34 * g0_2;
      g0_2bd += tb34d * g0_2 + tb34 * g0_2d;
      g0_2b += tb34 * g0_2;
      g0_2bd += tb34d * g0_2 + tb34 * g0_2d;
      g1_2b += tb34 * g1_2;
      g1_2bd += tb34d * g1_2 + tb34 * g1_2d;
      g1_2b += tb34 * g1_2;
      g1_2bd += tb34d * g1_2 + tb34 * g1_2d;
      tb31 = body0b[t->lumpbody[i]][5];
      tb31d = body0bd[t->lumpbody[i]][5];
      J1_2b = tb31;
      J1_2bd = tb31d;
      p_i7b += tb31 * (g0_2 * g0_2 + g2_2 * g2_2);
      p_i7bd += tb31d * (g0_2 * g0_2 + g2_2 * g2_2) + tb31 * (g0_2d * g0_2 + g0_2 * g0_2d + (g2_2d *
          g2_2 + g2_2 * g2_2d));
      tb32 = tb31 * p_i7;
      tb32d = tb31d * p_i7 + tb31 * p_i7d;
      g0_2b += tb32 * g0_2;
      g0_2bd += tb32d * g0_2 + tb32 * g0_2d;
      g0_2b += tb32 * g0_2;
      g0_2bd += tb32d * g0_2 + tb32 * g0_2d;
      g2_2b += tb32 * g2_2;
      g2_2bd += tb32d * g2_2 + tb32 * g2_2d;
      g2_2b += tb32 * g2_2;
      g2_2bd += tb32d * g2_2 + tb32 * g2_2d;
      tb29 = body0b[t->lumpbody[i]][4];
      tb29d = body0bd[t->lumpbody[i]][4];
      J0_2b = tb29;
      J0_2bd = tb29d;
      p_i7b += tb29 * (g1_2 * g1_2 + g2_2 * g2_2);
      p_i7bd += tb29d * (g1_2 * g1_2 + g2_2 * g2_2) + tb29 * (g1_2d * g1_2 + g1_2 * g1_2d + (g2_2d *
          g2_2 + g2_2 * g2_2d));
      tb30 = tb29 * p_i7;
      tb30d = tb29d * p_i7 + tb29 * p_i7d;
      g1_2b += tb30 * g1_2;
      g1_2bd += tb30d * g1_2 + tb30 * g1_2d;
      g1_2b += tb30 * g1_2;
      g1_2bd += tb30d * g1_2 + tb30 * g1_2d;
      g2_2b += tb30 * g2_2;
      g2_2bd += tb30d * g2_2 + tb30 * g2_2d;
      g2_2b += tb30 * g2_2;
      g2_2bd += tb30d * g2_2 + tb30 * g2_2d;
      tb28 = body0b[t->lumpbody[i]][3];
      tb28d = body0bd[t->lumpbody[i]][3];
      p_i7b += tb28 * g2_2;
      p_i7bd += tb28d * g2_2 + tb28 * g2_2d;
      g2_2b += tb28 * p_i7;
      g2_2bd += tb28d * p_i7 + tb28 * p_i7d;
      tb27 = body0b[t->lumpbody[i]][2];
      tb27d = body0bd[t->lumpbody[i]][2];
      p_i7b += tb27 * g1_2;
      p_i7bd += tb27d * g1_2 + tb27 * g1_2d;
      g1_2b += tb27 * p_i7;
      g1_2bd += tb27d * p_i7 + tb27 * p_i7d;
      tb26 = body0b[t->lumpbody[i]][1];
      tb26d = body0bd[t->lumpbody[i]][1];
      p_i7b += tb26 * g0_2;
      p_i7bd += tb26d * g0_2 + tb26 * g0_2d;
      g0_2b += tb26 * p_i7;
      g0_2bd += tb26d * p_i7 + tb26 * p_i7d;
      p_i7b += body0b[t->lumpbody[i]][0];
      /* inertia of a mass m at g and of J about it, about the reference point:
       *   m,  m g,  J + m (g.g I - g g^T) */
      p_i7bd += body0bd[t->lumpbody[i]][0];
      tb25 = J5_2b * e2;
      tb25d = J5_2bd * e2 + J5_2b * e2d;
      p_i7b -= tb25 * e1 / 12.0;
      p_i7bd -= (tb25d * e1 + tb25 * e1d) / 12.0;
      e1b = tb25 * (-p_i7 / 12.0);
      e1bd = tb25d * (-p_i7 / 12.0) - tb25 * (p_i7d / 12.0);
      e2b = J5_2b * (-p_i7 / 12.0 * e1);
      e2bd = J5_2bd * (-p_i7 / 12.0 * e1) + J5_2b * (-(p_i7d / 12.0 * e1) + -p_i7 / 12.0 * e1d);
      tb24 = J4_3b * e2;
      tb24d = J4_3bd * e2 + J4_3b * e2d;
      p_i7b -= tb24 * e0 / 12.0;
      p_i7bd -= (tb24d * e0 + tb24 * e0d) / 12.0;
      e0b = tb24 * (-p_i7 / 12.0);
      e0bd = tb24d * (-p_i7 / 12.0) - tb24 * (p_i7d / 12.0);
      e2b += J4_3b * (-p_i7 / 12.0 * e0);
      e2bd += J4_3bd * (-p_i7 / 12.0 * e0) + J4_3b * (-(p_i7d / 12.0 * e0) + -p_i7 / 12.0 * e0d);
      tb23 = J3_3b * e1;
      tb23d = J3_3bd * e1 + J3_3b * e1d;
      p_i7b -= tb23 * e0 / 12.0;
      p_i7bd -= (tb23d * e0 + tb23 * e0d) / 12.0;
      e0b += tb23 * (-p_i7 / 12.0);
      e0bd += tb23d * (-p_i7 / 12.0) - tb23 * (p_i7d / 12.0);
      e1b += J3_3b * (-p_i7 / 12.0 * e0);
      e1bd += J3_3bd * (-p_i7 / 12.0 * e0) + J3_3b * (-(p_i7d / 12.0 * e0) + -p_i7 / 12.0 * e0d);
      p_i7b += J2_3b * (e0 * e0 + e1 * e1) / 12.0;
      p_i7bd += (J2_3bd * (e0 * e0 + e1 * e1) + J2_3b * (e0d * e0 + e0 * e0d + (e1d * e1 + e1 *
          e1d))) / 12.0;
      tb22 = J2_3b * (p_i7 / 12.0);
      tb22d = J2_3bd * (p_i7 / 12.0) + J2_3b * (p_i7d / 12.0);
      e0b += tb22 * e0;
      e0bd += tb22d * e0 + tb22 * e0d;
      e0b += tb22 * e0;
      e0bd += tb22d * e0 + tb22 * e0d;
      e1b += tb22 * e1;
      e1bd += tb22d * e1 + tb22 * e1d;
      e1b += tb22 * e1;
      e1bd += tb22d * e1 + tb22 * e1d;
      p_i7b += J1_2b * (e0 * e0 + e2 * e2) / 12.0;
      p_i7bd += (J1_2bd * (e0 * e0 + e2 * e2) + J1_2b * (e0d * e0 + e0 * e0d + (e2d * e2 + e2 *
          e2d))) / 12.0;
      tb21 = J1_2b * (p_i7 / 12.0);
      tb21d = J1_2bd * (p_i7 / 12.0) + J1_2b * (p_i7d / 12.0);
      e0b += tb21 * e0;
      e0bd += tb21d * e0 + tb21 * e0d;
      e0b += tb21 * e0;
      e0bd += tb21d * e0 + tb21 * e0d;
      e2b += tb21 * e2;
      e2bd += tb21d * e2 + tb21 * e2d;
      e2b += tb21 * e2;
      e2bd += tb21d * e2 + tb21 * e2d;
      p_i7b += J0_2b * (e1 * e1 + e2 * e2) / 12.0;
      /* uniform thin bar along e: J = m/12 (e.e I - e e^T) */
      p_i7bd += (J0_2bd * (e1 * e1 + e2 * e2) + J0_2b * (e1d * e1 + e1 * e1d + (e2d * e2 + e2 *
          e2d))) / 12.0;
      tb20 = J0_2b * (p_i7 / 12.0);
      tb20d = J0_2bd * (p_i7 / 12.0) + J0_2b * (p_i7d / 12.0);
      e1b += tb20 * e1;
      e1bd += tb20d * e1 + tb20 * e1d;
      e1b += tb20 * e1;
      e1bd += tb20d * e1 + tb20 * e1d;
      e2b += tb20 * e2;
      e2bd += tb20d * e2 + tb20 * e2d;
      e2b += tb20 * e2;
      e2bd += tb20d * e2 + tb20 * e2d;
      pb[t->lumpadr[i]] += p_i7b;
      pbd[t->lumpadr[i]] += p_i7bd;
      p_i6b = e2b;
      p_i6bd = e2bd;
      p_i3b = -e2b;
      p_i3bd = -e2bd;
      tb19 = g2_2b * 0.5;
      tb19d = g2_2bd * 0.5;
      p_i3b += tb19;
      p_i3bd += tb19d;
      p_i6b += tb19;
      p_i6bd += tb19d;
      pb[t->jpointadr[t->lumpbody[i]] + 2] -= g2_2b;
      pbd[t->jpointadr[t->lumpbody[i]] + 2] -= g2_2bd;
      pb[t->lumpadr[i] + 6] += p_i6b;
      pbd[t->lumpadr[i] + 6] += p_i6bd;
      pb[t->lumpadr[i] + 3] += p_i3b;
      pbd[t->lumpadr[i] + 3] += p_i3bd;
      p_i5b = e1b;
      p_i5bd = e1bd;
      p_i2b = -e1b;
      p_i2bd = -e1bd;
      tb18 = g1_2b * 0.5;
      tb18d = g1_2bd * 0.5;
      p_i2b += tb18;
      p_i2bd += tb18d;
      p_i5b += tb18;
      p_i5bd += tb18d;
      pb[t->jpointadr[t->lumpbody[i]] + 1] -= g1_2b;
      pbd[t->jpointadr[t->lumpbody[i]] + 1] -= g1_2bd;
      pb[t->lumpadr[i] + 5] += p_i5b;
      pbd[t->lumpadr[i] + 5] += p_i5bd;
      pb[t->lumpadr[i] + 2] += p_i2b;
      pbd[t->lumpadr[i] + 2] += p_i2bd;
      p_i4b = e0b;
      p_i4bd = e0bd;
      p_i1b = -e0b;
      p_i1bd = -e0bd;
      tb17 = g0_2b * 0.5;
      tb17d = g0_2bd * 0.5;
      p_i1b += tb17;
      p_i1bd += tb17d;
      p_i4b += tb17;
      p_i4bd += tb17d;
      pb[t->jpointadr[t->lumpbody[i]]] -= g0_2b;
      pbd[t->jpointadr[t->lumpbody[i]]] -= g0_2bd;
      pb[t->lumpadr[i] + 4] += p_i4b;
      pbd[t->lumpadr[i] + 4] += p_i4bd;
      pb[t->lumpadr[i] + 1] += p_i1b;
      pbd[t->lumpadr[i] + 1] += p_i1bd;
    } else if (t->lumpkind[i] == MAGGI_LUMP_POINT) {
      g0_3 = p[t->lumpadr[i] + 1] - p[t->jpointadr[t->lumpbody[i]]];
      g0_3d = pd[t->lumpadr[i] + 1] - pd[t->jpointadr[t->lumpbody[i]]];
      g1_3 = p[t->lumpadr[i] + 2] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g1_3d = pd[t->lumpadr[i] + 2] - pd[t->jpointadr[t->lumpbody[i]] + 1];
      g2_3 = p[t->lumpadr[i] + 3] - p[t->jpointadr[t->lumpbody[i]] + 2];
      g2_3d = pd[t->lumpadr[i] + 3] - pd[t->jpointadr[t->lumpbody[i]] + 2];
      p_i8 = p[t->lumpadr[i]];
      p_i8d = pd[t->lumpadr[i]];
      tb54 = body0b[t->lumpbody[i]][9];
      tb54d = body0bd[t->lumpbody[i]][9];
      tb55 = tb54 * g2_3;
      tb55d = tb54d * g2_3 + tb54 * g2_3d;
      p_i8b = -(tb55 * g1_3);
      p_i8bd = -(tb55d * g1_3 + tb55 * g1_3d);
      g1_3b = -(tb55 * p_i8);
      g1_3bd = -(tb55d * p_i8 + tb55 * p_i8d);
      g2_3b = -(tb54 * (p_i8 * g1_3));
      g2_3bd = -(tb54d * (p_i8 * g1_3) + tb54 * (p_i8d * g1_3 + p_i8 * g1_3d));
      tb52 = body0b[t->lumpbody[i]][8];
      tb52d = body0bd[t->lumpbody[i]][8];
      tb53 = tb52 * g2_3;
      tb53d = tb52d * g2_3 + tb52 * g2_3d;
      p_i8b -= tb53 * g0_3;
      p_i8bd -= tb53d * g0_3 + tb53 * g0_3d;
      g0_3b = -(tb53 * p_i8);
      g0_3bd = -(tb53d * p_i8 + tb53 * p_i8d);
      g2_3b -= tb52 * (p_i8 * g0_3);
      g2_3bd -= tb52d * (p_i8 * g0_3) + tb52 * (p_i8d * g0_3 + p_i8 * g0_3d);
      tb50 = body0b[t->lumpbody[i]][7];
      tb50d = body0bd[t->lumpbody[i]][7];
      tb51 = tb50 * g1_3;
      tb51d = tb50d * g1_3 + tb50 * g1_3d;
      p_i8b -= tb51 * g0_3;
      p_i8bd -= tb51d * g0_3 + tb51 * g0_3d;
      g0_3b -= tb51 * p_i8;
      g0_3bd -= tb51d * p_i8 + tb51 * p_i8d;
      g1_3b -= tb50 * (p_i8 * g0_3);
      g1_3bd -= tb50d * (p_i8 * g0_3) + tb50 * (p_i8d * g0_3 + p_i8 * g0_3d);
      tb48 = body0b[t->lumpbody[i]][6];
      tb48d = body0bd[t->lumpbody[i]][6];
      p_i8b += tb48 * (g0_3 * g0_3 + g1_3 * g1_3);
      p_i8bd += tb48d * (g0_3 * g0_3 + g1_3 * g1_3) + tb48 * (g0_3d * g0_3 + g0_3 * g0_3d + (g1_3d *
          g1_3 + g1_3 * g1_3d));
      tb49 = tb48 * p_i8;
      tb49d = tb48d * p_i8 + tb48 * p_i8d;
      g0_3b += tb49 * g0_3;
      g0_3bd += tb49d * g0_3 + tb49 * g0_3d;
      g0_3b += tb49 * g0_3;
      g0_3bd += tb49d * g0_3 + tb49 * g0_3d;
      g1_3b += tb49 * g1_3;
      g1_3bd += tb49d * g1_3 + tb49 * g1_3d;
      g1_3b += tb49 * g1_3;
      g1_3bd += tb49d * g1_3 + tb49 * g1_3d;
      tb46 = body0b[t->lumpbody[i]][5];
      tb46d = body0bd[t->lumpbody[i]][5];
      p_i8b += tb46 * (g0_3 * g0_3 + g2_3 * g2_3);
      p_i8bd += tb46d * (g0_3 * g0_3 + g2_3 * g2_3) + tb46 * (g0_3d * g0_3 + g0_3 * g0_3d + (g2_3d *
          g2_3 + g2_3 * g2_3d));
      tb47 = tb46 * p_i8;
      tb47d = tb46d * p_i8 + tb46 * p_i8d;
      g0_3b += tb47 * g0_3;
      g0_3bd += tb47d * g0_3 + tb47 * g0_3d;
      g0_3b += tb47 * g0_3;
      g0_3bd += tb47d * g0_3 + tb47 * g0_3d;
      g2_3b += tb47 * g2_3;
      g2_3bd += tb47d * g2_3 + tb47 * g2_3d;
      g2_3b += tb47 * g2_3;
      g2_3bd += tb47d * g2_3 + tb47 * g2_3d;
      tb44 = body0b[t->lumpbody[i]][4];
      tb44d = body0bd[t->lumpbody[i]][4];
      p_i8b += tb44 * (g1_3 * g1_3 + g2_3 * g2_3);
      p_i8bd += tb44d * (g1_3 * g1_3 + g2_3 * g2_3) + tb44 * (g1_3d * g1_3 + g1_3 * g1_3d + (g2_3d *
          g2_3 + g2_3 * g2_3d));
      tb45 = tb44 * p_i8;
      tb45d = tb44d * p_i8 + tb44 * p_i8d;
      g1_3b += tb45 * g1_3;
      g1_3bd += tb45d * g1_3 + tb45 * g1_3d;
      g1_3b += tb45 * g1_3;
      g1_3bd += tb45d * g1_3 + tb45 * g1_3d;
      g2_3b += tb45 * g2_3;
      g2_3bd += tb45d * g2_3 + tb45 * g2_3d;
      g2_3b += tb45 * g2_3;
      g2_3bd += tb45d * g2_3 + tb45 * g2_3d;
      tb43 = body0b[t->lumpbody[i]][3];
      tb43d = body0bd[t->lumpbody[i]][3];
      p_i8b += tb43 * g2_3;
      p_i8bd += tb43d * g2_3 + tb43 * g2_3d;
      g2_3b += tb43 * p_i8;
      g2_3bd += tb43d * p_i8 + tb43 * p_i8d;
      tb42 = body0b[t->lumpbody[i]][2];
      tb42d = body0bd[t->lumpbody[i]][2];
      p_i8b += tb42 * g1_3;
      p_i8bd += tb42d * g1_3 + tb42 * g1_3d;
      g1_3b += tb42 * p_i8;
      g1_3bd += tb42d * p_i8 + tb42 * p_i8d;
      tb41 = body0b[t->lumpbody[i]][1];
      tb41d = body0bd[t->lumpbody[i]][1];
      p_i8b += tb41 * g0_3;
      p_i8bd += tb41d * g0_3 + tb41 * g0_3d;
      g0_3b += tb41 * p_i8;
      g0_3bd += tb41d * p_i8 + tb41 * p_i8d;
      p_i8b += body0b[t->lumpbody[i]][0];
      /* inertia of a mass m at g and of J about it, about the reference point:
       *   m,  m g,  J + m (g.g I - g g^T) */
      p_i8bd += body0bd[t->lumpbody[i]][0];
      pb[t->lumpadr[i]] += p_i8b;
      pbd[t->lumpadr[i]] += p_i8bd;
      pb[t->lumpadr[i] + 3] += g2_3b;
      pbd[t->lumpadr[i] + 3] += g2_3bd;
      pb[t->jpointadr[t->lumpbody[i]] + 2] -= g2_3b;
      pbd[t->jpointadr[t->lumpbody[i]] + 2] -= g2_3bd;
      pb[t->lumpadr[i] + 2] += g1_3b;
      pbd[t->lumpadr[i] + 2] += g1_3bd;
      pb[t->jpointadr[t->lumpbody[i]] + 1] -= g1_3b;
      pbd[t->jpointadr[t->lumpbody[i]] + 1] -= g1_3bd;
      pb[t->lumpadr[i] + 1] += g0_3b;
      pbd[t->lumpadr[i] + 1] += g0_3bd;
      pb[t->jpointadr[t->lumpbody[i]]] -= g0_3b;
      pbd[t->jpointadr[t->lumpbody[i]]] -= g0_3bd;
    } else if (t->lumpkind[i] == MAGGI_LUMP_ROD_A) {
      g0_4 = p[t->lumpadr[i] + 1] - p[t->jpointadr[t->lumpbody[i]]];
      g0_4d = pd[t->lumpadr[i] + 1] - pd[t->jpointadr[t->lumpbody[i]]];
      g1_4 = p[t->lumpadr[i] + 2] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g1_4d = pd[t->lumpadr[i] + 2] - pd[t->jpointadr[t->lumpbody[i]] + 1];
      g2_4 = p[t->lumpadr[i] + 3] - p[t->jpointadr[t->lumpbody[i]] + 2];
      g2_4d = pd[t->lumpadr[i] + 3] - pd[t->jpointadr[t->lumpbody[i]] + 2];
      m = p[t->lumpadr[i]] / 3.0;
      md = pd[t->lumpadr[i]] / 3.0;
      tb69 = body0b[t->lumpbody[i]][9];
      tb69d = body0bd[t->lumpbody[i]][9];
      tb70 = tb69 * g2_4;
      tb70d = tb69d * g2_4 + tb69 * g2_4d;
      mb = -(tb70 * g1_4);
      mbd = -(tb70d * g1_4 + tb70 * g1_4d);
      g1_4b = -(tb70 * m);
      g1_4bd = -(tb70d * m + tb70 * md);
      g2_4b = -(tb69 * (m * g1_4));
      g2_4bd = -(tb69d * (m * g1_4) + tb69 * (md * g1_4 + m * g1_4d));
      tb67 = body0b[t->lumpbody[i]][8];
      tb67d = body0bd[t->lumpbody[i]][8];
      tb68 = tb67 * g2_4;
      tb68d = tb67d * g2_4 + tb67 * g2_4d;
      mb -= tb68 * g0_4;
      mbd -= tb68d * g0_4 + tb68 * g0_4d;
      g0_4b = -(tb68 * m);
      g0_4bd = -(tb68d * m + tb68 * md);
      g2_4b -= tb67 * (m * g0_4);
      g2_4bd -= tb67d * (m * g0_4) + tb67 * (md * g0_4 + m * g0_4d);
      tb65 = body0b[t->lumpbody[i]][7];
      tb65d = body0bd[t->lumpbody[i]][7];
      tb66 = tb65 * g1_4;
      tb66d = tb65d * g1_4 + tb65 * g1_4d;
      mb -= tb66 * g0_4;
      mbd -= tb66d * g0_4 + tb66 * g0_4d;
      g0_4b -= tb66 * m;
      g0_4bd -= tb66d * m + tb66 * md;
      g1_4b -= tb65 * (m * g0_4);
      g1_4bd -= tb65d * (m * g0_4) + tb65 * (md * g0_4 + m * g0_4d);
      tb63 = body0b[t->lumpbody[i]][6];
      tb63d = body0bd[t->lumpbody[i]][6];
      mb += tb63 * (g0_4 * g0_4 + g1_4 * g1_4);
      mbd += tb63d * (g0_4 * g0_4 + g1_4 * g1_4) + tb63 * (g0_4d * g0_4 + g0_4 * g0_4d + (g1_4d *
          g1_4 + g1_4 * g1_4d));
      tb64 = tb63 * m;
      tb64d = tb63d * m + tb63 * md;
      g0_4b += tb64 * g0_4;
      g0_4bd += tb64d * g0_4 + tb64 * g0_4d;
      g0_4b += tb64 * g0_4;
      g0_4bd += tb64d * g0_4 + tb64 * g0_4d;
      g1_4b += tb64 * g1_4;
      g1_4bd += tb64d * g1_4 + tb64 * g1_4d;
      g1_4b += tb64 * g1_4;
      g1_4bd += tb64d * g1_4 + tb64 * g1_4d;
      tb61 = body0b[t->lumpbody[i]][5];
      tb61d = body0bd[t->lumpbody[i]][5];
      mb += tb61 * (g0_4 * g0_4 + g2_4 * g2_4);
      mbd += tb61d * (g0_4 * g0_4 + g2_4 * g2_4) + tb61 * (g0_4d * g0_4 + g0_4 * g0_4d + (g2_4d *
          g2_4 + g2_4 * g2_4d));
      tb62 = tb61 * m;
      tb62d = tb61d * m + tb61 * md;
      g0_4b += tb62 * g0_4;
      g0_4bd += tb62d * g0_4 + tb62 * g0_4d;
      g0_4b += tb62 * g0_4;
      g0_4bd += tb62d * g0_4 + tb62 * g0_4d;
      g2_4b += tb62 * g2_4;
      g2_4bd += tb62d * g2_4 + tb62 * g2_4d;
      g2_4b += tb62 * g2_4;
      g2_4bd += tb62d * g2_4 + tb62 * g2_4d;
      tb59 = body0b[t->lumpbody[i]][4];
      tb59d = body0bd[t->lumpbody[i]][4];
      mb += tb59 * (g1_4 * g1_4 + g2_4 * g2_4);
      mbd += tb59d * (g1_4 * g1_4 + g2_4 * g2_4) + tb59 * (g1_4d * g1_4 + g1_4 * g1_4d + (g2_4d *
          g2_4 + g2_4 * g2_4d));
      tb60 = tb59 * m;
      tb60d = tb59d * m + tb59 * md;
      g1_4b += tb60 * g1_4;
      g1_4bd += tb60d * g1_4 + tb60 * g1_4d;
      g1_4b += tb60 * g1_4;
      g1_4bd += tb60d * g1_4 + tb60 * g1_4d;
      g2_4b += tb60 * g2_4;
      g2_4bd += tb60d * g2_4 + tb60 * g2_4d;
      g2_4b += tb60 * g2_4;
      g2_4bd += tb60d * g2_4 + tb60 * g2_4d;
      tb58 = body0b[t->lumpbody[i]][3];
      tb58d = body0bd[t->lumpbody[i]][3];
      mb += tb58 * g2_4;
      mbd += tb58d * g2_4 + tb58 * g2_4d;
      g2_4b += tb58 * m;
      g2_4bd += tb58d * m + tb58 * md;
      tb57 = body0b[t->lumpbody[i]][2];
      tb57d = body0bd[t->lumpbody[i]][2];
      mb += tb57 * g1_4;
      mbd += tb57d * g1_4 + tb57 * g1_4d;
      g1_4b += tb57 * m;
      g1_4bd += tb57d * m + tb57 * md;
      tb56 = body0b[t->lumpbody[i]][1];
      tb56d = body0bd[t->lumpbody[i]][1];
      mb += tb56 * g0_4;
      mbd += tb56d * g0_4 + tb56 * g0_4d;
      g0_4b += tb56 * m;
      g0_4bd += tb56d * m + tb56 * md;
      mb += body0b[t->lumpbody[i]][0];
      /* inertia of a mass m at g and of J about it, about the reference point:
       *   m,  m g,  J + m (g.g I - g g^T) */
      mbd += body0bd[t->lumpbody[i]][0];
      pb[t->lumpadr[i]] += mb / 3.0;
      pbd[t->lumpadr[i]] += mbd / 3.0;
      pb[t->lumpadr[i] + 3] += g2_4b;
      pbd[t->lumpadr[i] + 3] += g2_4bd;
      pb[t->jpointadr[t->lumpbody[i]] + 2] -= g2_4b;
      pbd[t->jpointadr[t->lumpbody[i]] + 2] -= g2_4bd;
      pb[t->lumpadr[i] + 2] += g1_4b;
      pbd[t->lumpadr[i] + 2] += g1_4bd;
      pb[t->jpointadr[t->lumpbody[i]] + 1] -= g1_4b;
      pbd[t->jpointadr[t->lumpbody[i]] + 1] -= g1_4bd;
      pb[t->lumpadr[i] + 1] += g0_4b;
      pbd[t->lumpadr[i] + 1] += g0_4bd;
      pb[t->jpointadr[t->lumpbody[i]]] -= g0_4b;
      pbd[t->jpointadr[t->lumpbody[i]]] -= g0_4bd;
    } else {
      g0_5 = p[t->lumpadr[i] + 4] - p[t->jpointadr[t->lumpbody[i]]];
      g0_5d = pd[t->lumpadr[i] + 4] - pd[t->jpointadr[t->lumpbody[i]]];
      g1_5 = p[t->lumpadr[i] + 5] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g1_5d = pd[t->lumpadr[i] + 5] - pd[t->jpointadr[t->lumpbody[i]] + 1];
      g2_5 = p[t->lumpadr[i] + 6] - p[t->jpointadr[t->lumpbody[i]] + 2];
      g2_5d = pd[t->lumpadr[i] + 6] - pd[t->jpointadr[t->lumpbody[i]] + 2];
      m2 = p[t->lumpadr[i]] / 3.0;
      m2d = pd[t->lumpadr[i]] / 3.0;
      tb84 = body0b[t->lumpbody[i]][9];
      tb84d = body0bd[t->lumpbody[i]][9];
      tb85 = tb84 * g2_5;
      tb85d = tb84d * g2_5 + tb84 * g2_5d;
      m2b = -(tb85 * g1_5);
      m2bd = -(tb85d * g1_5 + tb85 * g1_5d);
      g1_5b = -(tb85 * m2);
      g1_5bd = -(tb85d * m2 + tb85 * m2d);
      g2_5b = -(tb84 * (m2 * g1_5));
      g2_5bd = -(tb84d * (m2 * g1_5) + tb84 * (m2d * g1_5 + m2 * g1_5d));
      tb82 = body0b[t->lumpbody[i]][8];
      tb82d = body0bd[t->lumpbody[i]][8];
      tb83 = tb82 * g2_5;
      tb83d = tb82d * g2_5 + tb82 * g2_5d;
      m2b -= tb83 * g0_5;
      m2bd -= tb83d * g0_5 + tb83 * g0_5d;
      g0_5b = -(tb83 * m2);
      g0_5bd = -(tb83d * m2 + tb83 * m2d);
      g2_5b -= tb82 * (m2 * g0_5);
      g2_5bd -= tb82d * (m2 * g0_5) + tb82 * (m2d * g0_5 + m2 * g0_5d);
      tb80 = body0b[t->lumpbody[i]][7];
      tb80d = body0bd[t->lumpbody[i]][7];
      tb81 = tb80 * g1_5;
      tb81d = tb80d * g1_5 + tb80 * g1_5d;
      m2b -= tb81 * g0_5;
      m2bd -= tb81d * g0_5 + tb81 * g0_5d;
      g0_5b -= tb81 * m2;
      g0_5bd -= tb81d * m2 + tb81 * m2d;
      g1_5b -= tb80 * (m2 * g0_5);
      g1_5bd -= tb80d * (m2 * g0_5) + tb80 * (m2d * g0_5 + m2 * g0_5d);
      tb78 = body0b[t->lumpbody[i]][6];
      tb78d = body0bd[t->lumpbody[i]][6];
      m2b += tb78 * (g0_5 * g0_5 + g1_5 * g1_5);
      m2bd += tb78d * (g0_5 * g0_5 + g1_5 * g1_5) + tb78 * (g0_5d * g0_5 + g0_5 * g0_5d + (g1_5d *
          g1_5 + g1_5 * g1_5d));
      tb79 = tb78 * m2;
      tb79d = tb78d * m2 + tb78 * m2d;
      g0_5b += tb79 * g0_5;
      g0_5bd += tb79d * g0_5 + tb79 * g0_5d;
      g0_5b += tb79 * g0_5;
      g0_5bd += tb79d * g0_5 + tb79 * g0_5d;
      g1_5b += tb79 * g1_5;
      g1_5bd += tb79d * g1_5 + tb79 * g1_5d;
      g1_5b += tb79 * g1_5;
      g1_5bd += tb79d * g1_5 + tb79 * g1_5d;
      tb76 = body0b[t->lumpbody[i]][5];
      tb76d = body0bd[t->lumpbody[i]][5];
      m2b += tb76 * (g0_5 * g0_5 + g2_5 * g2_5);
      m2bd += tb76d * (g0_5 * g0_5 + g2_5 * g2_5) + tb76 * (g0_5d * g0_5 + g0_5 * g0_5d + (g2_5d *
          g2_5 + g2_5 * g2_5d));
      tb77 = tb76 * m2;
      tb77d = tb76d * m2 + tb76 * m2d;
      g0_5b += tb77 * g0_5;
      g0_5bd += tb77d * g0_5 + tb77 * g0_5d;
      g0_5b += tb77 * g0_5;
      g0_5bd += tb77d * g0_5 + tb77 * g0_5d;
      g2_5b += tb77 * g2_5;
      g2_5bd += tb77d * g2_5 + tb77 * g2_5d;
      g2_5b += tb77 * g2_5;
      g2_5bd += tb77d * g2_5 + tb77 * g2_5d;
      tb74 = body0b[t->lumpbody[i]][4];
      tb74d = body0bd[t->lumpbody[i]][4];
      m2b += tb74 * (g1_5 * g1_5 + g2_5 * g2_5);
      m2bd += tb74d * (g1_5 * g1_5 + g2_5 * g2_5) + tb74 * (g1_5d * g1_5 + g1_5 * g1_5d + (g2_5d *
          g2_5 + g2_5 * g2_5d));
      tb75 = tb74 * m2;
      tb75d = tb74d * m2 + tb74 * m2d;
      g1_5b += tb75 * g1_5;
      g1_5bd += tb75d * g1_5 + tb75 * g1_5d;
      g1_5b += tb75 * g1_5;
      g1_5bd += tb75d * g1_5 + tb75 * g1_5d;
      g2_5b += tb75 * g2_5;
      g2_5bd += tb75d * g2_5 + tb75 * g2_5d;
      g2_5b += tb75 * g2_5;
      g2_5bd += tb75d * g2_5 + tb75 * g2_5d;
      tb73 = body0b[t->lumpbody[i]][3];
      tb73d = body0bd[t->lumpbody[i]][3];
      m2b += tb73 * g2_5;
      m2bd += tb73d * g2_5 + tb73 * g2_5d;
      g2_5b += tb73 * m2;
      g2_5bd += tb73d * m2 + tb73 * m2d;
      tb72 = body0b[t->lumpbody[i]][2];
      tb72d = body0bd[t->lumpbody[i]][2];
      m2b += tb72 * g1_5;
      m2bd += tb72d * g1_5 + tb72 * g1_5d;
      g1_5b += tb72 * m2;
      g1_5bd += tb72d * m2 + tb72 * m2d;
      tb71 = body0b[t->lumpbody[i]][1];
      tb71d = body0bd[t->lumpbody[i]][1];
      m2b += tb71 * g0_5;
      m2bd += tb71d * g0_5 + tb71 * g0_5d;
      g0_5b += tb71 * m2;
      g0_5bd += tb71d * m2 + tb71 * m2d;
      m2b += body0b[t->lumpbody[i]][0];
      /* inertia of a mass m at g and of J about it, about the reference point:
       *   m,  m g,  J + m (g.g I - g g^T) */
      m2bd += body0bd[t->lumpbody[i]][0];
      pb[t->lumpadr[i]] += m2b / 3.0;
      pbd[t->lumpadr[i]] += m2bd / 3.0;
      pb[t->lumpadr[i] + 6] += g2_5b;
      pbd[t->lumpadr[i] + 6] += g2_5bd;
      pb[t->jpointadr[t->lumpbody[i]] + 2] -= g2_5b;
      pbd[t->jpointadr[t->lumpbody[i]] + 2] -= g2_5bd;
      pb[t->lumpadr[i] + 5] += g1_5b;
      pbd[t->lumpadr[i] + 5] += g1_5bd;
      pb[t->jpointadr[t->lumpbody[i]] + 1] -= g1_5b;
      pbd[t->jpointadr[t->lumpbody[i]] + 1] -= g1_5bd;
      pb[t->lumpadr[i] + 4] += g0_5b;
      pbd[t->lumpadr[i] + 4] += g0_5bd;
      pb[t->jpointadr[t->lumpbody[i]]] -= g0_5b;
      pbd[t->jpointadr[t->lumpbody[i]]] -= g0_5bd;
    }
  }
  for (i = t->nbody - 1; i >= 0; --i) {
    for (k = 9; k >= 0; --k) {
      body0b[i][k] = 0.0;
      body0bd[i][k] = 0.0;
    }
  }
}

/* points relative to the reference point of their body, unit vectors, lengths as drawn */
void maggi_point_constants_b_d(const maggi_topo *t, const double p[restrict t->np],
                               const double pd[restrict t->np], double pb[restrict t->np],
                               double pbd[restrict t->np], const double origin[restrict 3],
                               double point0[restrict t->npoint][3],
                               double point0d[restrict t->npoint][3],
                               double point0b[restrict t->npoint][3],
                               double point0bd[restrict t->npoint][3],
                               double dir0[restrict t->ndir][3], double dir0d[restrict t->ndir][3],
                               double dir0b[restrict t->ndir][3],
                               double dir0bd[restrict t->ndir][3], double prim0[restrict t->nprim],
                               double prim0d[restrict t->nprim], double prim0b[restrict t->nprim],
                               double prim0bd[restrict t->nprim],
                               double spring0[restrict t->nspring],
                               double spring0d[restrict t->nspring],
                               double spring0b[restrict t->nspring],
                               double spring0bd[restrict t->nspring])
{
  int i, ref, ref2, ref3;
  double a0, a0_2, a0_2b, a0_2bd, a0_2d, a0_3, a0_3b, a0_3bd, a0_3d, a0b, a0bd, a0d, a1, a1_2,
      a1_2b, a1_2bd, a1_2d, a1_3, a1_3b, a1_3bd, a1_3d, a1b, a1bd, a1d, a20, a20b, a20bd, a20d, a21,
      a21b, a21bd, a21d, a22, a22b, a22bd, a22d, a2_2, a2_2b, a2_2bd, a2_2d, a2_3, a2_3b, a2_3bd,
      a2_3d, a2_4, a2_4b, a2_4bd, a2_4d, a30, a30b, a30bd, a30d, a31, a31b, a31bd, a31d, a32, a32b,
      a32bd, a32d, c0b, c0bd, c1b, c1bd, c20, c20_2, c20_2b, c20_2bd, c20_2d, c20b, c20bd, c20d,
      c21, c21_2, c21_2b, c21_2bd, c21_2d, c21b, c21bd, c21d, c22, c22_2, c22_2b, c22_2bd, c22_2d,
      c22b, c22bd, c22d, c2_2b, c2_2bd, c3, c3b, c3bd, c3d, e0, e0b, e0bd, e0d, e1, e1b, e1bd, e1d,
      e2, e2b, e2bd, e2d, f, fb, fbd, fd, m0, m0b, m0bd, m0d, m1, m1b, m1bd, m1d, m2, m2b, m2bd,
      m2d, n20, n20_2, n20_2b, n20_2bd, n20_2d, n20b, n20bd, n20d, n21, n21_2, n21_2b, n21_2bd,
      n21_2d, n21b, n21bd, n21d, n22, n22_2, n22_2b, n22_2bd, n22_2d, n22b, n22bd, n22d, n3, n3b,
      n3bd, n3d, n4, n4b, n4bd, n4d, n5, n5b, n5bd, n5d, n6, n6b, n6bd, n6d, n7, n7b, n7bd, n7d, n8,
      n8b, n8bd, n8d, s, s20, s20b, s20bd, s20d, s21, s21b, s21bd, s21d, s22, s22b, s22bd, s22d, s3,
      s3b, s3bd, s3d, sb, sbd, sd, sv0b, sv0bd, sv1b, sv1bd, sv2b, sv2bd, t10b, t10bd, t2, t2b,
      t2bd, t2d, t3, t3b, t3bd, t3d, t4, t4b, t4bd, t4d, t5, t5b, t5bd, t5d, t6, t6b, t6bd, t6d, t7,
      t7b, t7bd, t7d, t8, t8b, t8bd, t8d, t9b, t9bd, tb10, tb10d, tb11, tb11d, tb12, tb12d, tb13,
      tb13d, tb14, tb14d, tb15, tb15d, tb16, tb16d, tb17, tb17d, tb18, tb18d, tb19, tb19d, tb2,
      tb20, tb20d, tb21, tb21d, tb22, tb22d, tb23, tb23d, tb24, tb24d, tb25, tb25d, tb26, tb26d,
      tb27, tb27d, tb28, tb28d, tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31, tb31d, tb32, tb32d, tb33,
      tb33d, tb34, tb34d, tb35, tb35d, tb36, tb36d, tb37, tb37d, tb38, tb38d, tb3d, tb4, tb4d, tb5,
      tb5d, tb6, tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d, w0, w0_2, w0_2b, w0_2bd, w0_2d, w1, w1_2,
      w1_2b, w1_2bd, w1_2d, w2, w2_2, w2_2b, w2_2bd, w2_2d, x, x2, x2b, x2bd, x2d, xb, xbd, xd, y,
      y2, y2b, y2bd, y2d, yb, ybd, yd, z, z2, z2b, z2bd, z2d, zb, zbd, zd;

  (void)origin;
  (void)point0;
  (void)point0d;
  for (i = t->nspring - 1; i >= 0; --i) {
    x2 = p[t->pointadr[t->springpa[i]]] - p[t->pointadr[t->springpb[i]]];
    x2d = pd[t->pointadr[t->springpa[i]]] - pd[t->pointadr[t->springpb[i]]];
    y2 = p[t->pointadr[t->springpa[i]] + 1] - p[t->pointadr[t->springpb[i]] + 1];
    y2d = pd[t->pointadr[t->springpa[i]] + 1] - pd[t->pointadr[t->springpb[i]] + 1];
    z2 = p[t->pointadr[t->springpa[i]] + 2] - p[t->pointadr[t->springpb[i]] + 2];
    z2d = pd[t->pointadr[t->springpa[i]] + 2] - pd[t->pointadr[t->springpb[i]] + 2];
    tb38 = spring0b[i];
    tb38d = spring0bd[i];
    spring0b[i] = 0.0;
    spring0bd[i] = 0.0;
    t10b = tb38 * (1.0 / (2.0 * spring0[i]));
    t10bd = tb38d * (1.0 / (2.0 * spring0[i])) - tb38 * (1.0 / (2.0 * spring0[i]) * (2.0 *
        spring0d[i]) / (2.0 * spring0[i]));
    x2b = t10b * x2;
    x2bd = t10bd * x2 + t10b * x2d;
    x2b += t10b * x2;
    x2bd += t10bd * x2 + t10b * x2d;
    y2b = t10b * y2;
    y2bd = t10bd * y2 + t10b * y2d;
    y2b += t10b * y2;
    y2bd += t10bd * y2 + t10b * y2d;
    z2b = t10b * z2;
    z2bd = t10bd * z2 + t10b * z2d;
    z2b += t10b * z2;
    z2bd += t10bd * z2 + t10b * z2d;
    pb[t->pointadr[t->springpa[i]] + 2] += z2b;
    pbd[t->pointadr[t->springpa[i]] + 2] += z2bd;
    pb[t->pointadr[t->springpb[i]] + 2] -= z2b;
    pbd[t->pointadr[t->springpb[i]] + 2] -= z2bd;
    pb[t->pointadr[t->springpa[i]] + 1] += y2b;
    pbd[t->pointadr[t->springpa[i]] + 1] += y2bd;
    pb[t->pointadr[t->springpb[i]] + 1] -= y2b;
    pbd[t->pointadr[t->springpb[i]] + 1] -= y2bd;
    pb[t->pointadr[t->springpa[i]]] += x2b;
    pbd[t->pointadr[t->springpa[i]]] += x2bd;
    pb[t->pointadr[t->springpb[i]]] -= x2b;
    pbd[t->pointadr[t->springpb[i]]] -= x2bd;
  }
  for (i = t->nprim - 1; i >= 0; --i) {
    if (t->primkind[i] == MAGGI_PRIM_ROD && t->primadr[i] >= 0) {
      pb[t->primadr[i]] += prim0b[i];
      pbd[t->primadr[i]] += prim0bd[i];
      prim0b[i] = 0.0;
      prim0bd[i] = 0.0;
    } else if (t->primkind[i] == MAGGI_PRIM_ROD) {
      x = p[t->pointadr[t->primpa[i]]] - p[t->pointadr[t->primpb[i]]];
      xd = pd[t->pointadr[t->primpa[i]]] - pd[t->pointadr[t->primpb[i]]];
      y = p[t->pointadr[t->primpa[i]] + 1] - p[t->pointadr[t->primpb[i]] + 1];
      yd = pd[t->pointadr[t->primpa[i]] + 1] - pd[t->pointadr[t->primpb[i]] + 1];
      z = p[t->pointadr[t->primpa[i]] + 2] - p[t->pointadr[t->primpb[i]] + 2];
      zd = pd[t->pointadr[t->primpa[i]] + 2] - pd[t->pointadr[t->primpb[i]] + 2];
      tb36 = prim0b[i];
      tb36d = prim0bd[i];
      prim0b[i] = 0.0;
      prim0bd[i] = 0.0;
      t9b = tb36 * (1.0 / (2.0 * prim0[i]));
      t9bd = tb36d * (1.0 / (2.0 * prim0[i])) - tb36 * (1.0 / (2.0 * prim0[i]) * (2.0 * prim0d[i]) /
          (2.0 * prim0[i]));
      xb = t9b * x;
      xbd = t9bd * x + t9b * xd;
      xb += t9b * x;
      xbd += t9bd * x + t9b * xd;
      yb = t9b * y;
      ybd = t9bd * y + t9b * yd;
      yb += t9b * y;
      ybd += t9bd * y + t9b * yd;
      zb = t9b * z;
      zbd = t9bd * z + t9b * zd;
      zb += t9b * z;
      zbd += t9bd * z + t9b * zd;
      pb[t->pointadr[t->primpa[i]] + 2] += zb;
      pbd[t->pointadr[t->primpa[i]] + 2] += zbd;
      pb[t->pointadr[t->primpb[i]] + 2] -= zb;
      pbd[t->pointadr[t->primpb[i]] + 2] -= zbd;
      pb[t->pointadr[t->primpa[i]] + 1] += yb;
      pbd[t->pointadr[t->primpa[i]] + 1] += ybd;
      pb[t->pointadr[t->primpb[i]] + 1] -= yb;
      pbd[t->pointadr[t->primpb[i]] + 1] -= ybd;
      pb[t->pointadr[t->primpa[i]]] += xb;
      pbd[t->pointadr[t->primpa[i]]] += xbd;
      pb[t->pointadr[t->primpb[i]]] -= xb;
      pbd[t->pointadr[t->primpb[i]]] -= xbd;
    } else if (t->primkind[i] == MAGGI_PRIM_ANGLE && t->primadr[i] == -1) {
      tb37 = prim0b[i];
      tb37d = prim0bd[i];
      prim0b[i] = 0.0;
      prim0bd[i] = 0.0;
      dir0b[t->primda[i]][0] += tb37 * dir0[t->primdb[i]][0];
      dir0bd[t->primda[i]][0] += tb37d * dir0[t->primdb[i]][0] + tb37 * dir0d[t->primdb[i]][0];
      dir0b[t->primdb[i]][0] += tb37 * dir0[t->primda[i]][0];
      dir0bd[t->primdb[i]][0] += tb37d * dir0[t->primda[i]][0] + tb37 * dir0d[t->primda[i]][0];
      dir0b[t->primda[i]][1] += tb37 * dir0[t->primdb[i]][1];
      dir0bd[t->primda[i]][1] += tb37d * dir0[t->primdb[i]][1] + tb37 * dir0d[t->primdb[i]][1];
      dir0b[t->primdb[i]][1] += tb37 * dir0[t->primda[i]][1];
      dir0bd[t->primdb[i]][1] += tb37d * dir0[t->primda[i]][1] + tb37 * dir0d[t->primda[i]][1];
      dir0b[t->primda[i]][2] += tb37 * dir0[t->primdb[i]][2];
      dir0bd[t->primda[i]][2] += tb37d * dir0[t->primdb[i]][2] + tb37 * dir0d[t->primdb[i]][2];
      dir0b[t->primdb[i]][2] += tb37 * dir0[t->primda[i]][2];
      dir0bd[t->primdb[i]][2] += tb37d * dir0[t->primda[i]][2] + tb37 * dir0d[t->primda[i]][2];
    } else {
      prim0b[i] = 0.0;
      prim0bd[i] = 0.0;
    }
  }
  for (i = t->ndir - 1; i >= 0; --i) {
    if (t->dirkind[i] == MAGGI_DIR_GLOBAL) {
      dir0b[i][2] = 0.0;
      dir0bd[i][2] = 0.0;
      dir0b[i][1] = 0.0;
      dir0bd[i][1] = 0.0;
      dir0b[i][0] = 0.0;
      dir0bd[i][0] = 0.0;
    } else if (t->dirkind[i] == MAGGI_DIR_PARAMETER) {
      a0 = p[t->diradr[i]];
      a0d = pd[t->diradr[i]];
      a1 = p[t->diradr[i] + 1];
      a1d = pd[t->diradr[i] + 1];
      a2_2 = p[t->diradr[i] + 2];
      a2_2d = pd[t->diradr[i] + 2];
      t2 = a0 * a0 + a1 * a1 + a2_2 * a2_2;
      t2d = a0d * a0 + a0 * a0d + (a1d * a1 + a1 * a1d) + (a2_2d * a2_2 + a2_2 * a2_2d);
      n3 = sqrt(t2);
      n3d = 1.0 / (2.0 * n3) * t2d;
      tb12 = dir0b[i][2];
      tb12d = dir0bd[i][2];
      dir0b[i][2] = 0.0;
      dir0bd[i][2] = 0.0;
      tb13 = tb12 / n3;
      tb13d = (tb12d - tb13 * n3d) * (1.0 / n3);
      a2_2b = tb13;
      a2_2bd = tb13d;
      n3b = -(tb13 * dir0[i][2]);
      n3bd = -(tb13d * dir0[i][2] + tb13 * dir0d[i][2]);
      tb10 = dir0b[i][1];
      tb10d = dir0bd[i][1];
      dir0b[i][1] = 0.0;
      dir0bd[i][1] = 0.0;
      tb11 = tb10 / n3;
      tb11d = (tb10d - tb11 * n3d) * (1.0 / n3);
      a1b = tb11;
      a1bd = tb11d;
      n3b -= tb11 * dir0[i][1];
      n3bd -= tb11d * dir0[i][1] + tb11 * dir0d[i][1];
      tb8 = dir0b[i][0];
      tb8d = dir0bd[i][0];
      dir0b[i][0] = 0.0;
      dir0bd[i][0] = 0.0;
      tb9 = tb8 / n3;
      tb9d = (tb8d - tb9 * n3d) * (1.0 / n3);
      a0b = tb9;
      a0bd = tb9d;
      n3b -= tb9 * dir0[i][0];
      n3bd -= tb9d * dir0[i][0] + tb9 * dir0d[i][0];
      t2b = n3b * (1.0 / (2.0 * n3));
      t2bd = n3bd * (1.0 / (2.0 * n3)) - n3b * (1.0 / (2.0 * n3) * (2.0 * n3d) / (2.0 * n3));
      a0b += t2b * a0;
      a0bd += t2bd * a0 + t2b * a0d;
      a0b += t2b * a0;
      a0bd += t2bd * a0 + t2b * a0d;
      a1b += t2b * a1;
      a1bd += t2bd * a1 + t2b * a1d;
      a1b += t2b * a1;
      a1bd += t2bd * a1 + t2b * a1d;
      a2_2b += t2b * a2_2;
      a2_2bd += t2bd * a2_2 + t2b * a2_2d;
      a2_2b += t2b * a2_2;
      a2_2bd += t2bd * a2_2 + t2b * a2_2d;
      pb[t->diradr[i] + 2] += a2_2b;
      pbd[t->diradr[i] + 2] += a2_2bd;
      pb[t->diradr[i] + 1] += a1b;
      pbd[t->diradr[i] + 1] += a1bd;
      pb[t->diradr[i]] += a0b;
      pbd[t->diradr[i]] += a0bd;
    } else if (t->dirkind[i] == MAGGI_DIR_CARRIED) {
      a0_2 = p[t->diraux[i]];
      a0_2d = pd[t->diraux[i]];
      a1_2 = p[t->diraux[i] + 1];
      a1_2d = pd[t->diraux[i] + 1];
      a2_3 = p[t->diraux[i] + 2];
      a2_3d = pd[t->diraux[i] + 2];
      t3 = a0_2 * a0_2 + a1_2 * a1_2 + a2_3 * a2_3;
      t3d = a0_2d * a0_2 + a0_2 * a0_2d + (a1_2d * a1_2 + a1_2 * a1_2d) + (a2_3d * a2_3 + a2_3 *
          a2_3d);
      n4 = sqrt(t3);
      n4d = 1.0 / (2.0 * n4) * t3d;
      n20 = a0_2 / n4;
      n20d = (a0_2d - n20 * n4d) * (1.0 / n4);
      n21 = a1_2 / n4;
      n21d = (a1_2d - n21 * n4d) * (1.0 / n4);
      n22 = a2_3 / n4;
      n22d = (a2_3d - n22 * n4d) * (1.0 / n4);
      w0 = t->dirlean[i] == 0 ? 1.0 : 0.0;
      w1 = t->dirlean[i] == 1 ? 1.0 : 0.0;
      w2 = t->dirlean[i] == 2 ? 1.0 : 0.0;
      s = w0 * n20 + w1 * n21 + w2 * n22;
      sd = w0 * n20d + w1 * n21d + w2 * n22d;
      a20 = w0 - s * n20;
      a20d = -(sd * n20 + s * n20d);
      a21 = w1 - s * n21;
      a21d = -(sd * n21 + s * n21d);
      a22 = w2 - s * n22;
      a22d = -(sd * n22 + s * n22d);
      t4 = a20 * a20 + a21 * a21 + a22 * a22;
      t4d = a20d * a20 + a20 * a20d + (a21d * a21 + a21 * a21d) + (a22d * a22 + a22 * a22d);
      n5 = sqrt(t4);
      n5d = 1.0 / (2.0 * n5) * t4d;
      c20 = a20 / n5;
      c20d = (a20d - c20 * n5d) * (1.0 / n5);
      c21 = a21 / n5;
      c21d = (a21d - c21 * n5d) * (1.0 / n5);
      c22 = a22 / n5;
      c22d = (a22d - c22 * n5d) * (1.0 / n5);
      e0 = p[t->diradr[i]];
      e0d = pd[t->diradr[i]];
      e1 = p[t->diradr[i] + 1];
      e1d = pd[t->diradr[i] + 1];
      e2 = p[t->diradr[i] + 2];
      e2d = pd[t->diradr[i] + 2];
      t5 = e0 * e0 + e1 * e1 + e2 * e2;
      t5d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2d * e2 + e2 * e2d);
      n6 = sqrt(t5);
      n6d = 1.0 / (2.0 * n6) * t5d;
      m0 = e0 / n6;
      m0d = (e0d - m0 * n6d) * (1.0 / n6);
      m1 = e1 / n6;
      m1d = (e1d - m1 * n6d) * (1.0 / n6);
      m2 = e2 / n6;
      m2d = (e2d - m2 * n6d) * (1.0 / n6);
      c3 = n20 * m0 + n21 * m1 + n22 * m2;
      c3d = n20d * m0 + n20 * m0d + (n21d * m1 + n21 * m1d) + (n22d * m2 + n22 * m2d);
      s20 = n21 * m2 - n22 * m1;
      s20d = n21d * m2 + n21 * m2d - (n22d * m1 + n22 * m1d);
      s21 = n22 * m0 - n20 * m2;
      s21d = n22d * m0 + n22 * m0d - (n20d * m2 + n20 * m2d);
      s22 = n20 * m1 - n21 * m0;
      s22d = n20d * m1 + n20 * m1d - (n21d * m0 + n21 * m0d);
      t6 = 1.0 + c3;
      t6d = c3d;
      f = (s20 * c20 + s21 * c21 + s22 * c22) / t6;
      fd = (s20d * c20 + s20 * c20d + (s21d * c21 + s21 * c21d) + (s22d * c22 + s22 * c22d) - f *
          t6d) * (1.0 / t6);
      tb26 = dir0b[i][2];
      tb26d = dir0bd[i][2];
      dir0b[i][2] = 0.0;
      dir0bd[i][2] = 0.0;
      c3b = tb26 * c22;
      c3bd = tb26d * c22 + tb26 * c22d;
      c22b = tb26 * c3;
      c22bd = tb26d * c3 + tb26 * c3d;
      sv2b = tb26;
      sv2bd = tb26d;
      fb = tb26 * s22;
      fbd = tb26d * s22 + tb26 * s22d;
      s22b = tb26 * f;
      s22bd = tb26d * f + tb26 * fd;
      tb25 = dir0b[i][1];
      tb25d = dir0bd[i][1];
      dir0b[i][1] = 0.0;
      dir0bd[i][1] = 0.0;
      c3b += tb25 * c21;
      c3bd += tb25d * c21 + tb25 * c21d;
      c21b = tb25 * c3;
      c21bd = tb25d * c3 + tb25 * c3d;
      sv1b = tb25;
      sv1bd = tb25d;
      fb += tb25 * s21;
      fbd += tb25d * s21 + tb25 * s21d;
      s21b = tb25 * f;
      s21bd = tb25d * f + tb25 * fd;
      tb24 = dir0b[i][0];
      tb24d = dir0bd[i][0];
      dir0b[i][0] = 0.0;
      dir0bd[i][0] = 0.0;
      c3b += tb24 * c20;
      c3bd += tb24d * c20 + tb24 * c20d;
      c20b = tb24 * c3;
      c20bd = tb24d * c3 + tb24 * c3d;
      sv0b = tb24;
      sv0bd = tb24d;
      fb += tb24 * s20;
      fbd += tb24d * s20 + tb24 * s20d;
      s20b = tb24 * f;
      s20bd = tb24d * f + tb24 * fd;
      tb23 = fb / t6;
      tb23d = (fbd - tb23 * t6d) * (1.0 / t6);
      s20b += tb23 * c20;
      s20bd += tb23d * c20 + tb23 * c20d;
      c20b += tb23 * s20;
      c20bd += tb23d * s20 + tb23 * s20d;
      s21b += tb23 * c21;
      s21bd += tb23d * c21 + tb23 * c21d;
      c21b += tb23 * s21;
      c21bd += tb23d * s21 + tb23 * s21d;
      s22b += tb23 * c22;
      s22bd += tb23d * c22 + tb23 * c22d;
      c22b += tb23 * s22;
      c22bd += tb23d * s22 + tb23 * s22d;
      t6b = -(tb23 * f);
      t6bd = -(tb23d * f + tb23 * fd);
      c3b += t6b;
      c3bd += t6bd;
      s20b += sv2b * c21;
      s20bd += sv2bd * c21 + sv2b * c21d;
      c21b += sv2b * s20;
      c21bd += sv2bd * s20 + sv2b * s20d;
      s21b -= sv2b * c20;
      s21bd -= sv2bd * c20 + sv2b * c20d;
      c20b -= sv2b * s21;
      c20bd -= sv2bd * s21 + sv2b * s21d;
      s22b += sv1b * c20;
      s22bd += sv1bd * c20 + sv1b * c20d;
      c20b += sv1b * s22;
      c20bd += sv1bd * s22 + sv1b * s22d;
      s20b -= sv1b * c22;
      s20bd -= sv1bd * c22 + sv1b * c22d;
      c22b -= sv1b * s20;
      c22bd -= sv1bd * s20 + sv1b * s20d;
      s21b += sv0b * c22;
      s21bd += sv0bd * c22 + sv0b * c22d;
      c22b += sv0b * s21;
      c22bd += sv0bd * s21 + sv0b * s21d;
      s22b -= sv0b * c21;
      s22bd -= sv0bd * c21 + sv0b * c21d;
      c21b -= sv0b * s22;
      c21bd -= sv0bd * s22 + sv0b * s22d;
      n20b = s22b * m1;
      n20bd = s22bd * m1 + s22b * m1d;
      m1b = s22b * n20;
      m1bd = s22bd * n20 + s22b * n20d;
      n21b = -(s22b * m0);
      n21bd = -(s22bd * m0 + s22b * m0d);
      m0b = -(s22b * n21);
      m0bd = -(s22bd * n21 + s22b * n21d);
      n22b = s21b * m0;
      n22bd = s21bd * m0 + s21b * m0d;
      m0b += s21b * n22;
      m0bd += s21bd * n22 + s21b * n22d;
      n20b -= s21b * m2;
      n20bd -= s21bd * m2 + s21b * m2d;
      m2b = -(s21b * n20);
      m2bd = -(s21bd * n20 + s21b * n20d);
      n21b += s20b * m2;
      n21bd += s20bd * m2 + s20b * m2d;
      m2b += s20b * n21;
      m2bd += s20bd * n21 + s20b * n21d;
      n22b -= s20b * m1;
      n22bd -= s20bd * m1 + s20b * m1d;
      m1b -= s20b * n22;
      m1bd -= s20bd * n22 + s20b * n22d;
      n20b += c3b * m0;
      /* v turned by the smallest turn that takes the unit vector n to the unit vector m:
       *   c v + s × v + s (s.v) / (1 + c),  c = n.m,  s = n × m */
      n20bd += c3bd * m0 + c3b * m0d;
      m0b += c3b * n20;
      m0bd += c3bd * n20 + c3b * n20d;
      n21b += c3b * m1;
      n21bd += c3bd * m1 + c3b * m1d;
      m1b += c3b * n21;
      m1bd += c3bd * n21 + c3b * n21d;
      n22b += c3b * m2;
      n22bd += c3bd * m2 + c3b * m2d;
      m2b += c3b * n22;
      m2bd += c3bd * n22 + c3b * n22d;
      tb22 = m2b / n6;
      tb22d = (m2bd - tb22 * n6d) * (1.0 / n6);
      e2b = tb22;
      e2bd = tb22d;
      n6b = -(tb22 * m2);
      n6bd = -(tb22d * m2 + tb22 * m2d);
      tb21 = m1b / n6;
      tb21d = (m1bd - tb21 * n6d) * (1.0 / n6);
      e1b = tb21;
      e1bd = tb21d;
      n6b -= tb21 * m1;
      n6bd -= tb21d * m1 + tb21 * m1d;
      tb20 = m0b / n6;
      tb20d = (m0bd - tb20 * n6d) * (1.0 / n6);
      e0b = tb20;
      e0bd = tb20d;
      n6b -= tb20 * m0;
      n6bd -= tb20d * m0 + tb20 * m0d;
      t5b = n6b * (1.0 / (2.0 * n6));
      t5bd = n6bd * (1.0 / (2.0 * n6)) - n6b * (1.0 / (2.0 * n6) * (2.0 * n6d) / (2.0 * n6));
      e0b += t5b * e0;
      e0bd += t5bd * e0 + t5b * e0d;
      e0b += t5b * e0;
      e0bd += t5bd * e0 + t5b * e0d;
      e1b += t5b * e1;
      e1bd += t5bd * e1 + t5b * e1d;
      e1b += t5b * e1;
      e1bd += t5bd * e1 + t5b * e1d;
      e2b += t5b * e2;
      e2bd += t5bd * e2 + t5b * e2d;
      e2b += t5b * e2;
      e2bd += t5bd * e2 + t5b * e2d;
      pb[t->diradr[i] + 2] += e2b;
      pbd[t->diradr[i] + 2] += e2bd;
      pb[t->diradr[i] + 1] += e1b;
      pbd[t->diradr[i] + 1] += e1bd;
      pb[t->diradr[i]] += e0b;
      pbd[t->diradr[i]] += e0bd;
      tb19 = c22b / n5;
      tb19d = (c22bd - tb19 * n5d) * (1.0 / n5);
      a22b = tb19;
      a22bd = tb19d;
      n5b = -(tb19 * c22);
      n5bd = -(tb19d * c22 + tb19 * c22d);
      tb18 = c21b / n5;
      tb18d = (c21bd - tb18 * n5d) * (1.0 / n5);
      a21b = tb18;
      a21bd = tb18d;
      n5b -= tb18 * c21;
      n5bd -= tb18d * c21 + tb18 * c21d;
      tb17 = c20b / n5;
      tb17d = (c20bd - tb17 * n5d) * (1.0 / n5);
      a20b = tb17;
      a20bd = tb17d;
      n5b -= tb17 * c20;
      n5bd -= tb17d * c20 + tb17 * c20d;
      t4b = n5b * (1.0 / (2.0 * n5));
      t4bd = n5bd * (1.0 / (2.0 * n5)) - n5b * (1.0 / (2.0 * n5) * (2.0 * n5d) / (2.0 * n5));
      a20b += t4b * a20;
      a20bd += t4bd * a20 + t4b * a20d;
      a20b += t4b * a20;
      a20bd += t4bd * a20 + t4b * a20d;
      a21b += t4b * a21;
      a21bd += t4bd * a21 + t4b * a21d;
      a21b += t4b * a21;
      a21bd += t4bd * a21 + t4b * a21d;
      a22b += t4b * a22;
      a22bd += t4bd * a22 + t4b * a22d;
      a22b += t4b * a22;
      a22bd += t4bd * a22 + t4b * a22d;
      sb = -(a22b * n22);
      sbd = -(a22bd * n22 + a22b * n22d);
      n22b -= a22b * s;
      n22bd -= a22bd * s + a22b * sd;
      sb -= a21b * n21;
      sbd -= a21bd * n21 + a21b * n21d;
      n21b -= a21b * s;
      n21bd -= a21bd * s + a21b * sd;
      sb -= a20b * n20;
      sbd -= a20bd * n20 + a20b * n20d;
      n20b -= a20b * s;
      n20bd -= a20bd * s + a20b * sd;
      n20b += sb * w0;
      /* the part of w across the unit vector n, made a unit vector */
      n20bd += sbd * w0;
      n21b += sb * w1;
      n21bd += sbd * w1;
      n22b += sb * w2;
      n22bd += sbd * w2;
      tb16 = n22b / n4;
      tb16d = (n22bd - tb16 * n4d) * (1.0 / n4);
      a2_3b = tb16;
      a2_3bd = tb16d;
      n4b = -(tb16 * n22);
      n4bd = -(tb16d * n22 + tb16 * n22d);
      tb15 = n21b / n4;
      tb15d = (n21bd - tb15 * n4d) * (1.0 / n4);
      a1_2b = tb15;
      a1_2bd = tb15d;
      n4b -= tb15 * n21;
      n4bd -= tb15d * n21 + tb15 * n21d;
      tb14 = n20b / n4;
      tb14d = (n20bd - tb14 * n4d) * (1.0 / n4);
      a0_2b = tb14;
      a0_2bd = tb14d;
      n4b -= tb14 * n20;
      n4bd -= tb14d * n20 + tb14 * n20d;
      t3b = n4b * (1.0 / (2.0 * n4));
      t3bd = n4bd * (1.0 / (2.0 * n4)) - n4b * (1.0 / (2.0 * n4) * (2.0 * n4d) / (2.0 * n4));
      a0_2b += t3b * a0_2;
      a0_2bd += t3bd * a0_2 + t3b * a0_2d;
      a0_2b += t3b * a0_2;
      a0_2bd += t3bd * a0_2 + t3b * a0_2d;
      a1_2b += t3b * a1_2;
      a1_2bd += t3bd * a1_2 + t3b * a1_2d;
      a1_2b += t3b * a1_2;
      a1_2bd += t3bd * a1_2 + t3b * a1_2d;
      a2_3b += t3b * a2_3;
      a2_3bd += t3bd * a2_3 + t3b * a2_3d;
      a2_3b += t3b * a2_3;
      a2_3bd += t3bd * a2_3 + t3b * a2_3d;
      pb[t->diraux[i] + 2] += a2_3b;
      pbd[t->diraux[i] + 2] += a2_3bd;
      pb[t->diraux[i] + 1] += a1_2b;
      pbd[t->diraux[i] + 1] += a1_2bd;
      pb[t->diraux[i]] += a0_2b;
      pbd[t->diraux[i]] += a0_2bd;
    } else {
      a0_3 = p[t->diradr[i]];
      a0_3d = pd[t->diradr[i]];
      a1_3 = p[t->diradr[i] + 1];
      a1_3d = pd[t->diradr[i] + 1];
      a2_4 = p[t->diradr[i] + 2];
      a2_4d = pd[t->diradr[i] + 2];
      t7 = a0_3 * a0_3 + a1_3 * a1_3 + a2_4 * a2_4;
      t7d = a0_3d * a0_3 + a0_3 * a0_3d + (a1_3d * a1_3 + a1_3 * a1_3d) + (a2_4d * a2_4 + a2_4 *
          a2_4d);
      n7 = sqrt(t7);
      n7d = 1.0 / (2.0 * n7) * t7d;
      n20_2 = a0_3 / n7;
      n20_2d = (a0_3d - n20_2 * n7d) * (1.0 / n7);
      n21_2 = a1_3 / n7;
      n21_2d = (a1_3d - n21_2 * n7d) * (1.0 / n7);
      n22_2 = a2_4 / n7;
      n22_2d = (a2_4d - n22_2 * n7d) * (1.0 / n7);
      if (t->dirkind[i] == MAGGI_DIR_ACROSS || t->dirkind[i] == MAGGI_DIR_NORMAL) {
        w0_2 = p[t->diraux[i]];
        w0_2d = pd[t->diraux[i]];
        w1_2 = p[t->diraux[i] + 1];
        w1_2d = pd[t->diraux[i] + 1];
        w2_2 = p[t->diraux[i] + 2];
        w2_2d = pd[t->diraux[i] + 2];
      } else {
        w0_2 = t->diraux[i] == 0 ? 1.0 : 0.0;
        w0_2d = 0.0;
        w1_2 = t->diraux[i] == 1 ? 1.0 : 0.0;
        w1_2d = 0.0;
        w2_2 = t->diraux[i] == 2 ? 1.0 : 0.0;
        w2_2d = 0.0;
      }
      s3 = w0_2 * n20_2 + w1_2 * n21_2 + w2_2 * n22_2;
      s3d = w0_2d * n20_2 + w0_2 * n20_2d + (w1_2d * n21_2 + w1_2 * n21_2d) + (w2_2d * n22_2 + w2_2
          * n22_2d);
      a30 = w0_2 - s3 * n20_2;
      a30d = w0_2d - (s3d * n20_2 + s3 * n20_2d);
      a31 = w1_2 - s3 * n21_2;
      a31d = w1_2d - (s3d * n21_2 + s3 * n21_2d);
      a32 = w2_2 - s3 * n22_2;
      a32d = w2_2d - (s3d * n22_2 + s3 * n22_2d);
      t8 = a30 * a30 + a31 * a31 + a32 * a32;
      t8d = a30d * a30 + a30 * a30d + (a31d * a31 + a31 * a31d) + (a32d * a32 + a32 * a32d);
      n8 = sqrt(t8);
      n8d = 1.0 / (2.0 * n8) * t8d;
      c20_2 = a30 / n8;
      c20_2d = (a30d - c20_2 * n8d) * (1.0 / n8);
      c21_2 = a31 / n8;
      c21_2d = (a31d - c21_2 * n8d) * (1.0 / n8);
      c22_2 = a32 / n8;
      c22_2d = (a32d - c22_2 * n8d) * (1.0 / n8);
      c20_2b = 0.0;
      c20_2bd = 0.0;
      c21_2b = 0.0;
      c21_2bd = 0.0;
      c22_2b = 0.0;
      c22_2bd = 0.0;
      n20_2b = 0.0;
      n20_2bd = 0.0;
      n21_2b = 0.0;
      n21_2bd = 0.0;
      n22_2b = 0.0;
      n22_2bd = 0.0;
      if (t->dirkind[i] == MAGGI_DIR_ACROSS || t->dirkind[i] == MAGGI_DIR_ACROSS_GLOBAL) {
        c22_2b += dir0b[i][2];
        c22_2bd += dir0bd[i][2];
        dir0b[i][2] = 0.0;
        dir0bd[i][2] = 0.0;
        c21_2b += dir0b[i][1];
        c21_2bd += dir0bd[i][1];
        dir0b[i][1] = 0.0;
        dir0bd[i][1] = 0.0;
        c20_2b += dir0b[i][0];
        c20_2bd += dir0bd[i][0];
        dir0b[i][0] = 0.0;
        dir0bd[i][0] = 0.0;
      } else {
        tb35 = dir0b[i][2];
        tb35d = dir0bd[i][2];
        dir0b[i][2] = 0.0;
        dir0bd[i][2] = 0.0;
        n20_2b += tb35 * c21_2;
        n20_2bd += tb35d * c21_2 + tb35 * c21_2d;
        c21_2b += tb35 * n20_2;
        c21_2bd += tb35d * n20_2 + tb35 * n20_2d;
        n21_2b -= tb35 * c20_2;
        n21_2bd -= tb35d * c20_2 + tb35 * c20_2d;
        c20_2b -= tb35 * n21_2;
        c20_2bd -= tb35d * n21_2 + tb35 * n21_2d;
        tb34 = dir0b[i][1];
        tb34d = dir0bd[i][1];
        dir0b[i][1] = 0.0;
        dir0bd[i][1] = 0.0;
        n22_2b += tb34 * c20_2;
        n22_2bd += tb34d * c20_2 + tb34 * c20_2d;
        c20_2b += tb34 * n22_2;
        c20_2bd += tb34d * n22_2 + tb34 * n22_2d;
        n20_2b -= tb34 * c22_2;
        n20_2bd -= tb34d * c22_2 + tb34 * c22_2d;
        c22_2b -= tb34 * n20_2;
        c22_2bd -= tb34d * n20_2 + tb34 * n20_2d;
        tb33 = dir0b[i][0];
        tb33d = dir0bd[i][0];
        dir0b[i][0] = 0.0;
        dir0bd[i][0] = 0.0;
        n21_2b += tb33 * c22_2;
        n21_2bd += tb33d * c22_2 + tb33 * c22_2d;
        c22_2b += tb33 * n21_2;
        c22_2bd += tb33d * n21_2 + tb33 * n21_2d;
        n22_2b -= tb33 * c21_2;
        n22_2bd -= tb33d * c21_2 + tb33 * c21_2d;
        c21_2b -= tb33 * n22_2;
        c21_2bd -= tb33d * n22_2 + tb33 * n22_2d;
      }
      tb32 = c22_2b / n8;
      tb32d = (c22_2bd - tb32 * n8d) * (1.0 / n8);
      a32b = tb32;
      a32bd = tb32d;
      n8b = -(tb32 * c22_2);
      n8bd = -(tb32d * c22_2 + tb32 * c22_2d);
      tb31 = c21_2b / n8;
      tb31d = (c21_2bd - tb31 * n8d) * (1.0 / n8);
      a31b = tb31;
      a31bd = tb31d;
      n8b -= tb31 * c21_2;
      n8bd -= tb31d * c21_2 + tb31 * c21_2d;
      tb30 = c20_2b / n8;
      tb30d = (c20_2bd - tb30 * n8d) * (1.0 / n8);
      a30b = tb30;
      a30bd = tb30d;
      n8b -= tb30 * c20_2;
      n8bd -= tb30d * c20_2 + tb30 * c20_2d;
      t8b = n8b * (1.0 / (2.0 * n8));
      t8bd = n8bd * (1.0 / (2.0 * n8)) - n8b * (1.0 / (2.0 * n8) * (2.0 * n8d) / (2.0 * n8));
      a30b += t8b * a30;
      a30bd += t8bd * a30 + t8b * a30d;
      a30b += t8b * a30;
      a30bd += t8bd * a30 + t8b * a30d;
      a31b += t8b * a31;
      a31bd += t8bd * a31 + t8b * a31d;
      a31b += t8b * a31;
      a31bd += t8bd * a31 + t8b * a31d;
      a32b += t8b * a32;
      a32bd += t8bd * a32 + t8b * a32d;
      a32b += t8b * a32;
      a32bd += t8bd * a32 + t8b * a32d;
      w2_2b = a32b;
      w2_2bd = a32bd;
      s3b = -(a32b * n22_2);
      s3bd = -(a32bd * n22_2 + a32b * n22_2d);
      n22_2b -= a32b * s3;
      n22_2bd -= a32bd * s3 + a32b * s3d;
      w1_2b = a31b;
      w1_2bd = a31bd;
      s3b -= a31b * n21_2;
      s3bd -= a31bd * n21_2 + a31b * n21_2d;
      n21_2b -= a31b * s3;
      n21_2bd -= a31bd * s3 + a31b * s3d;
      w0_2b = a30b;
      w0_2bd = a30bd;
      s3b -= a30b * n20_2;
      s3bd -= a30bd * n20_2 + a30b * n20_2d;
      n20_2b -= a30b * s3;
      n20_2bd -= a30bd * s3 + a30b * s3d;
      w0_2b += s3b * n20_2;
      /* the part of w across the unit vector n, made a unit vector */
      w0_2bd += s3bd * n20_2 + s3b * n20_2d;
      n20_2b += s3b * w0_2;
      n20_2bd += s3bd * w0_2 + s3b * w0_2d;
      w1_2b += s3b * n21_2;
      w1_2bd += s3bd * n21_2 + s3b * n21_2d;
      n21_2b += s3b * w1_2;
      n21_2bd += s3bd * w1_2 + s3b * w1_2d;
      w2_2b += s3b * n22_2;
      w2_2bd += s3bd * n22_2 + s3b * n22_2d;
      n22_2b += s3b * w2_2;
      n22_2bd += s3bd * w2_2 + s3b * w2_2d;
      if (t->dirkind[i] == MAGGI_DIR_ACROSS || t->dirkind[i] == MAGGI_DIR_NORMAL) {
        pb[t->diraux[i] + 2] += w2_2b;
        pbd[t->diraux[i] + 2] += w2_2bd;
        w2_2b = 0.0;
        w2_2bd = 0.0;
        pb[t->diraux[i] + 1] += w1_2b;
        pbd[t->diraux[i] + 1] += w1_2bd;
        w1_2b = 0.0;
        w1_2bd = 0.0;
        pb[t->diraux[i]] += w0_2b;
        pbd[t->diraux[i]] += w0_2bd;
        w0_2b = 0.0;
        w0_2bd = 0.0;
      } else {
        w2_2b = 0.0;
        w2_2bd = 0.0;
        w1_2b = 0.0;
        w1_2bd = 0.0;
        w0_2b = 0.0;
        w0_2bd = 0.0;
      }
      tb29 = n22_2b / n7;
      tb29d = (n22_2bd - tb29 * n7d) * (1.0 / n7);
      a2_4b = tb29;
      a2_4bd = tb29d;
      n7b = -(tb29 * n22_2);
      n7bd = -(tb29d * n22_2 + tb29 * n22_2d);
      tb28 = n21_2b / n7;
      tb28d = (n21_2bd - tb28 * n7d) * (1.0 / n7);
      a1_3b = tb28;
      a1_3bd = tb28d;
      n7b -= tb28 * n21_2;
      n7bd -= tb28d * n21_2 + tb28 * n21_2d;
      tb27 = n20_2b / n7;
      tb27d = (n20_2bd - tb27 * n7d) * (1.0 / n7);
      a0_3b = tb27;
      a0_3bd = tb27d;
      n7b -= tb27 * n20_2;
      n7bd -= tb27d * n20_2 + tb27 * n20_2d;
      t7b = n7b * (1.0 / (2.0 * n7));
      t7bd = n7bd * (1.0 / (2.0 * n7)) - n7b * (1.0 / (2.0 * n7) * (2.0 * n7d) / (2.0 * n7));
      a0_3b += t7b * a0_3;
      a0_3bd += t7bd * a0_3 + t7b * a0_3d;
      a0_3b += t7b * a0_3;
      a0_3bd += t7bd * a0_3 + t7b * a0_3d;
      a1_3b += t7b * a1_3;
      a1_3bd += t7bd * a1_3 + t7b * a1_3d;
      a1_3b += t7b * a1_3;
      a1_3bd += t7bd * a1_3 + t7b * a1_3d;
      a2_4b += t7b * a2_4;
      a2_4bd += t7bd * a2_4 + t7b * a2_4d;
      a2_4b += t7b * a2_4;
      a2_4bd += t7bd * a2_4 + t7b * a2_4d;
      pb[t->diradr[i] + 2] += a2_4b;
      pbd[t->diradr[i] + 2] += a2_4bd;
      pb[t->diradr[i] + 1] += a1_3b;
      pbd[t->diradr[i] + 1] += a1_3bd;
      pb[t->diradr[i]] += a0_3b;
      pbd[t->diradr[i]] += a0_3bd;
    }
  }
  for (i = t->npoint - 1; i >= 0; --i) {
    c2_2b = 0.0;
    c2_2bd = 0.0;
    if (t->pointbody[i] == t->nbody) {
      c2_2b += point0b[i][2];
      c2_2bd += point0bd[i][2];
      point0b[i][2] = 0.0;
      point0bd[i][2] = 0.0;
    } else {
      ref3 = t->jpointadr[t->pointbody[i]];
      tb7 = point0b[i][2];
      tb7d = point0bd[i][2];
      point0b[i][2] = 0.0;
      point0bd[i][2] = 0.0;
      c2_2b += tb7;
      c2_2bd += tb7d;
      pb[ref3 + 2] -= tb7;
      pbd[ref3 + 2] -= tb7d;
    }
    c1b = 0.0;
    c1bd = 0.0;
    if (t->pointbody[i] == t->nbody) {
      c1b += point0b[i][1];
      c1bd += point0bd[i][1];
      point0b[i][1] = 0.0;
      point0bd[i][1] = 0.0;
    } else {
      ref2 = t->jpointadr[t->pointbody[i]];
      tb6 = point0b[i][1];
      tb6d = point0bd[i][1];
      point0b[i][1] = 0.0;
      point0bd[i][1] = 0.0;
      c1b += tb6;
      c1bd += tb6d;
      pb[ref2 + 1] -= tb6;
      pbd[ref2 + 1] -= tb6d;
    }
    c0b = 0.0;
    c0bd = 0.0;
    if (t->pointbody[i] == t->nbody) {
      c0b += point0b[i][0];
      c0bd += point0bd[i][0];
      point0b[i][0] = 0.0;
      point0bd[i][0] = 0.0;
    } else {
      ref = t->jpointadr[t->pointbody[i]];
      tb5 = point0b[i][0];
      tb5d = point0bd[i][0];
      point0b[i][0] = 0.0;
      point0bd[i][0] = 0.0;
      c0b += tb5;
      c0bd += tb5d;
      pb[ref] -= tb5;
      pbd[ref] -= tb5d;
    }
    if (t->pointadr2[i] >= 0) {
      tb4 = c2_2b * 0.5;
      tb4d = c2_2bd * 0.5;
      pb[t->pointadr[i] + 2] += tb4;
      pbd[t->pointadr[i] + 2] += tb4d;
      pb[t->pointadr2[i] + 2] += tb4;
      pbd[t->pointadr2[i] + 2] += tb4d;
      c2_2b = 0.0;
      c2_2bd = 0.0;
    } else {
      pb[t->pointadr[i] + 2] += c2_2b;
      pbd[t->pointadr[i] + 2] += c2_2bd;
      c2_2b = 0.0;
      c2_2bd = 0.0;
    }
    if (t->pointadr2[i] >= 0) {
      tb3 = c1b * 0.5;
      tb3d = c1bd * 0.5;
      pb[t->pointadr[i] + 1] += tb3;
      pbd[t->pointadr[i] + 1] += tb3d;
      pb[t->pointadr2[i] + 1] += tb3;
      pbd[t->pointadr2[i] + 1] += tb3d;
      c1b = 0.0;
      c1bd = 0.0;
    } else {
      pb[t->pointadr[i] + 1] += c1b;
      pbd[t->pointadr[i] + 1] += c1bd;
      c1b = 0.0;
      c1bd = 0.0;
    }
    /* of a point, or the middle between two when the second address is not -1 */
    if (t->pointadr2[i] >= 0) {
      tb2 = c0b * 0.5;
      tb2d = c0bd * 0.5;
      pb[t->pointadr[i]] += tb2;
      pbd[t->pointadr[i]] += tb2d;
      pb[t->pointadr2[i]] += tb2;
      pbd[t->pointadr2[i]] += tb2d;
      c0b = 0.0;
      c0bd = 0.0;
    } else {
      pb[t->pointadr[i]] += c0b;
      pbd[t->pointadr[i]] += c0bd;
      c0b = 0.0;
      c0bd = 0.0;
    }
  }
}
