/* Adjoint of core/kernel/constants.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* offset0 = c0 - c0(parent), u0 = a0 / |a0| */
void maggi_joint_constants_b(const maggi_topo *t, const double p[restrict t->np],
                             double pb[restrict t->np], const double origin[restrict 3],
                             double offset0[restrict t->nbody][3],
                             double offset0b[restrict t->nbody][3],
                             double axis0[restrict t->nbody][3],
                             double axis0b[restrict t->nbody][3])
{
  int adr, i, up;
  double a0, a0_2, a0_2b, a0_3, a0_3b, a0b, a1, a1_2, a1_2b, a1_3, a1_3b, a1b, a20, a20b, a21, a21b,
      a22, a22b, a2_2, a2_2b, a2_3, a2_3b, a2_4, a2_4b, a30, a30b, a31, a31b, a32, a32b, c0, c0_2,
      c0_2b, c0b, c1, c1_2, c1_2b, c1b, c2, c2_2, c2_2b, c2_3, c2_3b, c2b, e0, e0b, e1, e1b, e2,
      e2b, f, fb, m0, m0b, m1, m1b, m2, m2b, n20, n20_2, n20_2b, n20b, n21, n21_2, n21_2b, n21b,
      n22, n22_2, n22_2b, n22b, n3, n3b, n4, n4b, n5, n5b, n6, n6b, n7, n7b, n8, n8b, s, s20, s20b,
      s21, s21b, s22, s22b, s3, s3b, sb, sv0b, sv1b, sv2b, t2, t2b, t3, t3b, t4, t4b, t5, t5b, t6,
      t6b, t7, t7b, t8, t8b, tb10, tb11, tb12, tb13, tb14, tb15, tb16, tb17, tb18, tb19, tb2, tb20,
      tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3, tb30, tb31, tb32, tb4, tb5, tb6,
      tb7, tb8, tb9, w0, w0_2, w0_2b, w1, w1_2, w1_2b, w2, w2_2, w2_2b;

  (void)origin;
  (void)offset0;
  for (i = t->nbody - 1; i >= 0; --i) {
    adr = t->jpointadr[i];
    up = t->parent[i];
    if (t->joint[i] != MAGGI_ONE_FIXED) {
      if (t->jdirkind[i] == MAGGI_DIR_GLOBAL) {
        axis0b[i][2] = 0.0;
        axis0b[i][1] = 0.0;
        axis0b[i][0] = 0.0;
      } else if (t->jdirkind[i] == MAGGI_DIR_PARAMETER) {
        a0 = p[t->jdiradr[i]];
        a1 = p[t->jdiradr[i] + 1];
        a2_2 = p[t->jdiradr[i] + 2];
        t2 = a0 * a0 + a1 * a1 + a2_2 * a2_2;
        n3 = sqrt(t2);
        tb9 = axis0b[i][2];
        axis0b[i][2] = 0.0;
        tb10 = tb9 / n3;
        a2_2b = tb10;
        n3b = -(tb10 * axis0[i][2]);
        tb7 = axis0b[i][1];
        axis0b[i][1] = 0.0;
        tb8 = tb7 / n3;
        a1b = tb8;
        n3b -= tb8 * axis0[i][1];
        tb5 = axis0b[i][0];
        axis0b[i][0] = 0.0;
        tb6 = tb5 / n3;
        a0b = tb6;
        n3b -= tb6 * axis0[i][0];
        t2b = n3b * (1.0 / (2.0 * n3));
        a0b += t2b * a0;
        a0b += t2b * a0;
        a1b += t2b * a1;
        a1b += t2b * a1;
        a2_2b += t2b * a2_2;
        a2_2b += t2b * a2_2;
        pb[t->jdiradr[i] + 2] += a2_2b;
        pb[t->jdiradr[i] + 1] += a1b;
        pb[t->jdiradr[i]] += a0b;
      } else if (t->jdirkind[i] == MAGGI_DIR_CARRIED) {
        a0_2 = p[t->jdiraux[i]];
        a1_2 = p[t->jdiraux[i] + 1];
        a2_3 = p[t->jdiraux[i] + 2];
        t3 = a0_2 * a0_2 + a1_2 * a1_2 + a2_3 * a2_3;
        n4 = sqrt(t3);
        n20 = a0_2 / n4;
        n21 = a1_2 / n4;
        n22 = a2_3 / n4;
        w0 = 1.0;
        w1 = 0.0;
        w2 = 0.0;
        s = w0 * n20 + w1 * n21 + w2 * n22;
        a20 = w0 - s * n20;
        a21 = w1 - s * n21;
        a22 = w2 - s * n22;
        t4 = a20 * a20 + a21 * a21 + a22 * a22;
        n5 = sqrt(t4);
        c0 = a20 / n5;
        c1 = a21 / n5;
        c2_2 = a22 / n5;
        e0 = p[t->jdiradr[i]];
        e1 = p[t->jdiradr[i] + 1];
        e2 = p[t->jdiradr[i] + 2];
        t5 = e0 * e0 + e1 * e1 + e2 * e2;
        n6 = sqrt(t5);
        m0 = e0 / n6;
        m1 = e1 / n6;
        m2 = e2 / n6;
        c2 = n20 * m0 + n21 * m1 + n22 * m2;
        s20 = n21 * m2 - n22 * m1;
        s21 = n22 * m0 - n20 * m2;
        s22 = n20 * m1 - n21 * m0;
        t6 = 1.0 + c2;
        f = (s20 * c0 + s21 * c1 + s22 * c2_2) / t6;
        tb23 = axis0b[i][2];
        axis0b[i][2] = 0.0;
        c2b = tb23 * c2_2;
        c2_2b = tb23 * c2;
        sv2b = tb23;
        fb = tb23 * s22;
        s22b = tb23 * f;
        tb22 = axis0b[i][1];
        axis0b[i][1] = 0.0;
        c2b += tb22 * c1;
        c1b = tb22 * c2;
        sv1b = tb22;
        fb += tb22 * s21;
        s21b = tb22 * f;
        tb21 = axis0b[i][0];
        axis0b[i][0] = 0.0;
        c2b += tb21 * c0;
        c0b = tb21 * c2;
        sv0b = tb21;
        fb += tb21 * s20;
        s20b = tb21 * f;
        tb20 = fb / t6;
        s20b += tb20 * c0;
        c0b += tb20 * s20;
        s21b += tb20 * c1;
        c1b += tb20 * s21;
        s22b += tb20 * c2_2;
        c2_2b += tb20 * s22;
        t6b = -(tb20 * f);
        c2b += t6b;
        s20b += sv2b * c1;
        c1b += sv2b * s20;
        s21b -= sv2b * c0;
        c0b -= sv2b * s21;
        s22b += sv1b * c0;
        c0b += sv1b * s22;
        s20b -= sv1b * c2_2;
        c2_2b -= sv1b * s20;
        s21b += sv0b * c2_2;
        c2_2b += sv0b * s21;
        s22b -= sv0b * c1;
        c1b -= sv0b * s22;
        n20b = s22b * m1;
        m1b = s22b * n20;
        n21b = -(s22b * m0);
        m0b = -(s22b * n21);
        n22b = s21b * m0;
        m0b += s21b * n22;
        n20b -= s21b * m2;
        m2b = -(s21b * n20);
        n21b += s20b * m2;
        m2b += s20b * n21;
        n22b -= s20b * m1;
        m1b -= s20b * n22;
        /* v turned by the smallest turn that takes the unit vector n to the unit vector m:
         *   c v + s × v + s (s.v) / (1 + c),  c = n.m,  s = n × m */
        n20b += c2b * m0;
        m0b += c2b * n20;
        n21b += c2b * m1;
        m1b += c2b * n21;
        n22b += c2b * m2;
        m2b += c2b * n22;
        tb19 = m2b / n6;
        e2b = tb19;
        n6b = -(tb19 * m2);
        tb18 = m1b / n6;
        e1b = tb18;
        n6b -= tb18 * m1;
        tb17 = m0b / n6;
        e0b = tb17;
        n6b -= tb17 * m0;
        t5b = n6b * (1.0 / (2.0 * n6));
        e0b += t5b * e0;
        e0b += t5b * e0;
        e1b += t5b * e1;
        e1b += t5b * e1;
        e2b += t5b * e2;
        e2b += t5b * e2;
        pb[t->jdiradr[i] + 2] += e2b;
        pb[t->jdiradr[i] + 1] += e1b;
        pb[t->jdiradr[i]] += e0b;
        tb16 = c2_2b / n5;
        a22b = tb16;
        n5b = -(tb16 * c2_2);
        tb15 = c1b / n5;
        a21b = tb15;
        n5b -= tb15 * c1;
        tb14 = c0b / n5;
        a20b = tb14;
        n5b -= tb14 * c0;
        t4b = n5b * (1.0 / (2.0 * n5));
        a20b += t4b * a20;
        a20b += t4b * a20;
        a21b += t4b * a21;
        a21b += t4b * a21;
        a22b += t4b * a22;
        a22b += t4b * a22;
        sb = -(a22b * n22);
        n22b -= a22b * s;
        sb -= a21b * n21;
        n21b -= a21b * s;
        sb -= a20b * n20;
        n20b -= a20b * s;
        /* the part of w across the unit vector n, made a unit vector */
        n20b += sb * w0;
        n21b += sb * w1;
        n22b += sb * w2;
        tb13 = n22b / n4;
        a2_3b = tb13;
        n4b = -(tb13 * n22);
        tb12 = n21b / n4;
        a1_2b = tb12;
        n4b -= tb12 * n21;
        tb11 = n20b / n4;
        a0_2b = tb11;
        n4b -= tb11 * n20;
        t3b = n4b * (1.0 / (2.0 * n4));
        a0_2b += t3b * a0_2;
        a0_2b += t3b * a0_2;
        a1_2b += t3b * a1_2;
        a1_2b += t3b * a1_2;
        a2_3b += t3b * a2_3;
        a2_3b += t3b * a2_3;
        pb[t->jdiraux[i] + 2] += a2_3b;
        pb[t->jdiraux[i] + 1] += a1_2b;
        pb[t->jdiraux[i]] += a0_2b;
      } else {
        a0_3 = p[t->jdiradr[i]];
        a1_3 = p[t->jdiradr[i] + 1];
        a2_4 = p[t->jdiradr[i] + 2];
        t7 = a0_3 * a0_3 + a1_3 * a1_3 + a2_4 * a2_4;
        n7 = sqrt(t7);
        n20_2 = a0_3 / n7;
        n21_2 = a1_3 / n7;
        n22_2 = a2_4 / n7;
        if (t->jdirkind[i] == MAGGI_DIR_ACROSS || t->jdirkind[i] == MAGGI_DIR_NORMAL) {
          w0_2 = p[t->jdiraux[i]];
          w1_2 = p[t->jdiraux[i] + 1];
          w2_2 = p[t->jdiraux[i] + 2];
        } else {
          w0_2 = t->jdiraux[i] == 0 ? 1.0 : 0.0;
          w1_2 = t->jdiraux[i] == 1 ? 1.0 : 0.0;
          w2_2 = t->jdiraux[i] == 2 ? 1.0 : 0.0;
        }
        s3 = w0_2 * n20_2 + w1_2 * n21_2 + w2_2 * n22_2;
        a30 = w0_2 - s3 * n20_2;
        a31 = w1_2 - s3 * n21_2;
        a32 = w2_2 - s3 * n22_2;
        t8 = a30 * a30 + a31 * a31 + a32 * a32;
        n8 = sqrt(t8);
        c0_2 = a30 / n8;
        c1_2 = a31 / n8;
        c2_3 = a32 / n8;
        c0_2b = 0.0;
        c1_2b = 0.0;
        c2_3b = 0.0;
        n20_2b = 0.0;
        n21_2b = 0.0;
        n22_2b = 0.0;
        if (t->jdirkind[i] == MAGGI_DIR_ACROSS || t->jdirkind[i] == MAGGI_DIR_ACROSS_GLOBAL) {
          c2_3b += axis0b[i][2];
          axis0b[i][2] = 0.0;
          c1_2b += axis0b[i][1];
          axis0b[i][1] = 0.0;
          c0_2b += axis0b[i][0];
          axis0b[i][0] = 0.0;
        } else {
          tb32 = axis0b[i][2];
          axis0b[i][2] = 0.0;
          n20_2b += tb32 * c1_2;
          c1_2b += tb32 * n20_2;
          n21_2b -= tb32 * c0_2;
          c0_2b -= tb32 * n21_2;
          tb31 = axis0b[i][1];
          axis0b[i][1] = 0.0;
          n22_2b += tb31 * c0_2;
          c0_2b += tb31 * n22_2;
          n20_2b -= tb31 * c2_3;
          c2_3b -= tb31 * n20_2;
          tb30 = axis0b[i][0];
          axis0b[i][0] = 0.0;
          n21_2b += tb30 * c2_3;
          c2_3b += tb30 * n21_2;
          n22_2b -= tb30 * c1_2;
          c1_2b -= tb30 * n22_2;
        }
        tb29 = c2_3b / n8;
        a32b = tb29;
        n8b = -(tb29 * c2_3);
        tb28 = c1_2b / n8;
        a31b = tb28;
        n8b -= tb28 * c1_2;
        tb27 = c0_2b / n8;
        a30b = tb27;
        n8b -= tb27 * c0_2;
        t8b = n8b * (1.0 / (2.0 * n8));
        a30b += t8b * a30;
        a30b += t8b * a30;
        a31b += t8b * a31;
        a31b += t8b * a31;
        a32b += t8b * a32;
        a32b += t8b * a32;
        w2_2b = a32b;
        s3b = -(a32b * n22_2);
        n22_2b -= a32b * s3;
        w1_2b = a31b;
        s3b -= a31b * n21_2;
        n21_2b -= a31b * s3;
        w0_2b = a30b;
        s3b -= a30b * n20_2;
        n20_2b -= a30b * s3;
        /* the part of w across the unit vector n, made a unit vector */
        w0_2b += s3b * n20_2;
        n20_2b += s3b * w0_2;
        w1_2b += s3b * n21_2;
        n21_2b += s3b * w1_2;
        w2_2b += s3b * n22_2;
        n22_2b += s3b * w2_2;
        if (t->jdirkind[i] == MAGGI_DIR_ACROSS || t->jdirkind[i] == MAGGI_DIR_NORMAL) {
          pb[t->jdiraux[i] + 2] += w2_2b;
          w2_2b = 0.0;
          pb[t->jdiraux[i] + 1] += w1_2b;
          w1_2b = 0.0;
          pb[t->jdiraux[i]] += w0_2b;
          w0_2b = 0.0;
        } else {
          w2_2b = 0.0;
          w1_2b = 0.0;
          w0_2b = 0.0;
        }
        tb26 = n22_2b / n7;
        a2_4b = tb26;
        n7b = -(tb26 * n22_2);
        tb25 = n21_2b / n7;
        a1_3b = tb25;
        n7b -= tb25 * n21_2;
        tb24 = n20_2b / n7;
        a0_3b = tb24;
        n7b -= tb24 * n20_2;
        t7b = n7b * (1.0 / (2.0 * n7));
        a0_3b += t7b * a0_3;
        a0_3b += t7b * a0_3;
        a1_3b += t7b * a1_3;
        a1_3b += t7b * a1_3;
        a2_4b += t7b * a2_4;
        a2_4b += t7b * a2_4;
        pb[t->jdiradr[i] + 2] += a2_4b;
        pb[t->jdiradr[i] + 1] += a1_3b;
        pb[t->jdiradr[i]] += a0_3b;
      }
    }
    if (up == t->nbody) {
      pb[adr + 2] += offset0b[i][2];
      offset0b[i][2] = 0.0;
    } else {
      tb4 = offset0b[i][2];
      offset0b[i][2] = 0.0;
      pb[adr + 2] += tb4;
      pb[t->jpointadr[up] + 2] -= tb4;
    }
    if (up == t->nbody) {
      pb[adr + 1] += offset0b[i][1];
      offset0b[i][1] = 0.0;
    } else {
      tb3 = offset0b[i][1];
      offset0b[i][1] = 0.0;
      pb[adr + 1] += tb3;
      pb[t->jpointadr[up] + 1] -= tb3;
    }
    if (up == t->nbody) {
      pb[adr] += offset0b[i][0];
      offset0b[i][0] = 0.0;
    } else {
      tb2 = offset0b[i][0];
      offset0b[i][0] = 0.0;
      pb[adr] += tb2;
      pb[t->jpointadr[up]] -= tb2;
    }
  }
}

void maggi_inertia_constants_b(const maggi_topo *t, const double p[restrict t->np],
                               double pb[restrict t->np], double body0[restrict t->nbody][10],
                               double body0b[restrict t->nbody][10])
{
  int i, k;
  double J0_2b, J0b, J1_2b, J1b, J2_2b, J2_3b, J3_2b, J3_3b, J4_2b, J4_3b, J5_2b, J5b, e0, e0b, e1,
      e1b, e2, e2b, g0, g0_2, g0_2b, g0_3, g0_3b, g0_4, g0_4b, g0_5, g0_5b, g0b, g1, g1_2, g1_2b,
      g1_3, g1_3b, g1_4, g1_4b, g1_5, g1_5b, g1b, g2, g2_2, g2_2b, g2_3, g2_3b, g2_4, g2_4b, g2_5,
      g2_5b, g2b, m, m2, m2b, mb, p_i, p_i1, p_i1b, p_i2, p_i2b, p_i3, p_i3b, p_i4, p_i4b, p_i5,
      p_i5b, p_i6, p_i6b, p_i7, p_i7b, p_i8, p_i8b, p_ib, tb10, tb11, tb12, tb13, tb14, tb15, tb16,
      tb17, tb18, tb19, tb2, tb20, tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3, tb30,
      tb31, tb32, tb33, tb34, tb35, tb36, tb37, tb38, tb39, tb4, tb40, tb41, tb42, tb43, tb44, tb45,
      tb46, tb47, tb48, tb49, tb5, tb50, tb51, tb52, tb53, tb54, tb55, tb56, tb57, tb58, tb59, tb6,
      tb60, tb61, tb62, tb63, tb64, tb65, tb66, tb67, tb68, tb69, tb7, tb70, tb71, tb72, tb73, tb74,
      tb75, tb76, tb77, tb78, tb79, tb8, tb80, tb81, tb82, tb83, tb84, tb85, tb9;

  (void)body0;
  for (i = t->nlump - 1; i >= 0; --i) {
    if (t->lumpkind[i] == MAGGI_LUMP_RIGID) {
      g0 = p[t->lumpadr[i] + 1] - p[t->jpointadr[t->lumpbody[i]]];
      g1 = p[t->lumpadr[i] + 2] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g2 = p[t->lumpadr[i] + 3] - p[t->jpointadr[t->lumpbody[i]] + 2];
      p_i = p[t->lumpadr[i]];
      tb15 = body0b[t->lumpbody[i]][9];
      J5b = tb15;
      tb16 = tb15 * g2;
      p_ib = -(tb16 * g1);
      g1b = -(tb16 * p_i);
      g2b = -(tb15 * (p_i * g1));
      tb13 = body0b[t->lumpbody[i]][8];
      J4_2b = tb13;
      tb14 = tb13 * g2;
      p_ib -= tb14 * g0;
      g0b = -(tb14 * p_i);
      g2b -= tb13 * (p_i * g0);
      tb11 = body0b[t->lumpbody[i]][7];
      J3_2b = tb11;
      tb12 = tb11 * g1;
      p_ib -= tb12 * g0;
      g0b -= tb12 * p_i;
      g1b -= tb11 * (p_i * g0);
      tb9 = body0b[t->lumpbody[i]][6];
      J2_2b = tb9;
      p_ib += tb9 * (g0 * g0 + g1 * g1);
      tb10 = tb9 * p_i;
      g0b += tb10 * g0;
      g0b += tb10 * g0;
      g1b += tb10 * g1;
      g1b += tb10 * g1;
      tb7 = body0b[t->lumpbody[i]][5];
      J1b = tb7;
      p_ib += tb7 * (g0 * g0 + g2 * g2);
      tb8 = tb7 * p_i;
      g0b += tb8 * g0;
      g0b += tb8 * g0;
      g2b += tb8 * g2;
      g2b += tb8 * g2;
      tb5 = body0b[t->lumpbody[i]][4];
      J0b = tb5;
      p_ib += tb5 * (g1 * g1 + g2 * g2);
      tb6 = tb5 * p_i;
      g1b += tb6 * g1;
      g1b += tb6 * g1;
      g2b += tb6 * g2;
      g2b += tb6 * g2;
      tb4 = body0b[t->lumpbody[i]][3];
      p_ib += tb4 * g2;
      g2b += tb4 * p_i;
      tb3 = body0b[t->lumpbody[i]][2];
      p_ib += tb3 * g1;
      g1b += tb3 * p_i;
      tb2 = body0b[t->lumpbody[i]][1];
      p_ib += tb2 * g0;
      g0b += tb2 * p_i;
      /* inertia of a mass m at g and of J about it, about the reference point:
       *   m,  m g,  J + m (g.g I - g g^T) */
      p_ib += body0b[t->lumpbody[i]][0];
      pb[t->lumpadr[i]] += p_ib;
      pb[t->lumpadr[i] + 9] += J5b;
      pb[t->lumpadr[i] + 8] += J4_2b;
      pb[t->lumpadr[i] + 7] += J3_2b;
      pb[t->lumpadr[i] + 6] += J2_2b;
      pb[t->lumpadr[i] + 5] += J1b;
      pb[t->lumpadr[i] + 4] += J0b;
      pb[t->lumpadr[i] + 3] += g2b;
      pb[t->jpointadr[t->lumpbody[i]] + 2] -= g2b;
      pb[t->lumpadr[i] + 2] += g1b;
      pb[t->jpointadr[t->lumpbody[i]] + 1] -= g1b;
      pb[t->lumpadr[i] + 1] += g0b;
      pb[t->jpointadr[t->lumpbody[i]]] -= g0b;
    } else if (t->lumpkind[i] == MAGGI_LUMP_BAR) {
      p_i1 = p[t->lumpadr[i] + 1];
      p_i4 = p[t->lumpadr[i] + 4];
      g0_2 = 0.5 * (p_i1 + p_i4) - p[t->jpointadr[t->lumpbody[i]]];
      e0 = p_i4 - p_i1;
      p_i2 = p[t->lumpadr[i] + 2];
      p_i5 = p[t->lumpadr[i] + 5];
      g1_2 = 0.5 * (p_i2 + p_i5) - p[t->jpointadr[t->lumpbody[i]] + 1];
      e1 = p_i5 - p_i2;
      p_i3 = p[t->lumpadr[i] + 3];
      p_i6 = p[t->lumpadr[i] + 6];
      g2_2 = 0.5 * (p_i3 + p_i6) - p[t->jpointadr[t->lumpbody[i]] + 2];
      e2 = p_i6 - p_i3;
      p_i7 = p[t->lumpadr[i]];
      tb39 = body0b[t->lumpbody[i]][9];
      J5_2b = tb39;
      tb40 = tb39 * g2_2;
      p_i7b = -(tb40 * g1_2);
      g1_2b = -(tb40 * p_i7);
      g2_2b = -(tb39 * (p_i7 * g1_2));
      tb37 = body0b[t->lumpbody[i]][8];
      J4_3b = tb37;
      tb38 = tb37 * g2_2;
      p_i7b -= tb38 * g0_2;
      g0_2b = -(tb38 * p_i7);
      g2_2b -= tb37 * (p_i7 * g0_2);
      tb35 = body0b[t->lumpbody[i]][7];
      J3_3b = tb35;
      tb36 = tb35 * g1_2;
      p_i7b -= tb36 * g0_2;
      g0_2b -= tb36 * p_i7;
      g1_2b -= tb35 * (p_i7 * g0_2);
      tb33 = body0b[t->lumpbody[i]][6];
      J2_3b = tb33;
      p_i7b += tb33 * (g0_2 * g0_2 + g1_2 * g1_2);
      tb34 = tb33 * p_i7;
      g0_2b += tb34 * g0_2;
      g0_2b += tb34 * g0_2;
      g1_2b += tb34 * g1_2;
      g1_2b += tb34 * g1_2;
      tb31 = body0b[t->lumpbody[i]][5];
      J1_2b = tb31;
      p_i7b += tb31 * (g0_2 * g0_2 + g2_2 * g2_2);
      tb32 = tb31 * p_i7;
      g0_2b += tb32 * g0_2;
      g0_2b += tb32 * g0_2;
      g2_2b += tb32 * g2_2;
      g2_2b += tb32 * g2_2;
      tb29 = body0b[t->lumpbody[i]][4];
      J0_2b = tb29;
      p_i7b += tb29 * (g1_2 * g1_2 + g2_2 * g2_2);
      tb30 = tb29 * p_i7;
      g1_2b += tb30 * g1_2;
      g1_2b += tb30 * g1_2;
      g2_2b += tb30 * g2_2;
      g2_2b += tb30 * g2_2;
      tb28 = body0b[t->lumpbody[i]][3];
      p_i7b += tb28 * g2_2;
      g2_2b += tb28 * p_i7;
      tb27 = body0b[t->lumpbody[i]][2];
      p_i7b += tb27 * g1_2;
      g1_2b += tb27 * p_i7;
      tb26 = body0b[t->lumpbody[i]][1];
      p_i7b += tb26 * g0_2;
      g0_2b += tb26 * p_i7;
      /* inertia of a mass m at g and of J about it, about the reference point:
       *   m,  m g,  J + m (g.g I - g g^T) */
      p_i7b += body0b[t->lumpbody[i]][0];
      tb25 = J5_2b * e2;
      p_i7b -= tb25 * e1 / 12.0;
      e1b = tb25 * (-p_i7 / 12.0);
      e2b = J5_2b * (-p_i7 / 12.0 * e1);
      tb24 = J4_3b * e2;
      p_i7b -= tb24 * e0 / 12.0;
      e0b = tb24 * (-p_i7 / 12.0);
      e2b += J4_3b * (-p_i7 / 12.0 * e0);
      tb23 = J3_3b * e1;
      p_i7b -= tb23 * e0 / 12.0;
      e0b += tb23 * (-p_i7 / 12.0);
      e1b += J3_3b * (-p_i7 / 12.0 * e0);
      p_i7b += J2_3b * (e0 * e0 + e1 * e1) / 12.0;
      tb22 = J2_3b * (p_i7 / 12.0);
      e0b += tb22 * e0;
      e0b += tb22 * e0;
      e1b += tb22 * e1;
      e1b += tb22 * e1;
      p_i7b += J1_2b * (e0 * e0 + e2 * e2) / 12.0;
      tb21 = J1_2b * (p_i7 / 12.0);
      e0b += tb21 * e0;
      e0b += tb21 * e0;
      e2b += tb21 * e2;
      e2b += tb21 * e2;
      /* uniform thin bar along e: J = m/12 (e.e I - e e^T) */
      p_i7b += J0_2b * (e1 * e1 + e2 * e2) / 12.0;
      tb20 = J0_2b * (p_i7 / 12.0);
      e1b += tb20 * e1;
      e1b += tb20 * e1;
      e2b += tb20 * e2;
      e2b += tb20 * e2;
      pb[t->lumpadr[i]] += p_i7b;
      p_i6b = e2b;
      p_i3b = -e2b;
      tb19 = g2_2b * 0.5;
      p_i3b += tb19;
      p_i6b += tb19;
      pb[t->jpointadr[t->lumpbody[i]] + 2] -= g2_2b;
      pb[t->lumpadr[i] + 6] += p_i6b;
      pb[t->lumpadr[i] + 3] += p_i3b;
      p_i5b = e1b;
      p_i2b = -e1b;
      tb18 = g1_2b * 0.5;
      p_i2b += tb18;
      p_i5b += tb18;
      pb[t->jpointadr[t->lumpbody[i]] + 1] -= g1_2b;
      pb[t->lumpadr[i] + 5] += p_i5b;
      pb[t->lumpadr[i] + 2] += p_i2b;
      p_i4b = e0b;
      p_i1b = -e0b;
      tb17 = g0_2b * 0.5;
      p_i1b += tb17;
      p_i4b += tb17;
      pb[t->jpointadr[t->lumpbody[i]]] -= g0_2b;
      pb[t->lumpadr[i] + 4] += p_i4b;
      pb[t->lumpadr[i] + 1] += p_i1b;
    } else if (t->lumpkind[i] == MAGGI_LUMP_POINT) {
      g0_3 = p[t->lumpadr[i] + 1] - p[t->jpointadr[t->lumpbody[i]]];
      g1_3 = p[t->lumpadr[i] + 2] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g2_3 = p[t->lumpadr[i] + 3] - p[t->jpointadr[t->lumpbody[i]] + 2];
      p_i8 = p[t->lumpadr[i]];
      tb54 = body0b[t->lumpbody[i]][9];
      tb55 = tb54 * g2_3;
      p_i8b = -(tb55 * g1_3);
      g1_3b = -(tb55 * p_i8);
      g2_3b = -(tb54 * (p_i8 * g1_3));
      tb52 = body0b[t->lumpbody[i]][8];
      tb53 = tb52 * g2_3;
      p_i8b -= tb53 * g0_3;
      g0_3b = -(tb53 * p_i8);
      g2_3b -= tb52 * (p_i8 * g0_3);
      tb50 = body0b[t->lumpbody[i]][7];
      tb51 = tb50 * g1_3;
      p_i8b -= tb51 * g0_3;
      g0_3b -= tb51 * p_i8;
      g1_3b -= tb50 * (p_i8 * g0_3);
      tb48 = body0b[t->lumpbody[i]][6];
      p_i8b += tb48 * (g0_3 * g0_3 + g1_3 * g1_3);
      tb49 = tb48 * p_i8;
      g0_3b += tb49 * g0_3;
      g0_3b += tb49 * g0_3;
      g1_3b += tb49 * g1_3;
      g1_3b += tb49 * g1_3;
      tb46 = body0b[t->lumpbody[i]][5];
      p_i8b += tb46 * (g0_3 * g0_3 + g2_3 * g2_3);
      tb47 = tb46 * p_i8;
      g0_3b += tb47 * g0_3;
      g0_3b += tb47 * g0_3;
      g2_3b += tb47 * g2_3;
      g2_3b += tb47 * g2_3;
      tb44 = body0b[t->lumpbody[i]][4];
      p_i8b += tb44 * (g1_3 * g1_3 + g2_3 * g2_3);
      tb45 = tb44 * p_i8;
      g1_3b += tb45 * g1_3;
      g1_3b += tb45 * g1_3;
      g2_3b += tb45 * g2_3;
      g2_3b += tb45 * g2_3;
      tb43 = body0b[t->lumpbody[i]][3];
      p_i8b += tb43 * g2_3;
      g2_3b += tb43 * p_i8;
      tb42 = body0b[t->lumpbody[i]][2];
      p_i8b += tb42 * g1_3;
      g1_3b += tb42 * p_i8;
      tb41 = body0b[t->lumpbody[i]][1];
      p_i8b += tb41 * g0_3;
      g0_3b += tb41 * p_i8;
      /* inertia of a mass m at g and of J about it, about the reference point:
       *   m,  m g,  J + m (g.g I - g g^T) */
      p_i8b += body0b[t->lumpbody[i]][0];
      pb[t->lumpadr[i]] += p_i8b;
      pb[t->lumpadr[i] + 3] += g2_3b;
      pb[t->jpointadr[t->lumpbody[i]] + 2] -= g2_3b;
      pb[t->lumpadr[i] + 2] += g1_3b;
      pb[t->jpointadr[t->lumpbody[i]] + 1] -= g1_3b;
      pb[t->lumpadr[i] + 1] += g0_3b;
      pb[t->jpointadr[t->lumpbody[i]]] -= g0_3b;
    } else if (t->lumpkind[i] == MAGGI_LUMP_ROD_A) {
      g0_4 = p[t->lumpadr[i] + 1] - p[t->jpointadr[t->lumpbody[i]]];
      g1_4 = p[t->lumpadr[i] + 2] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g2_4 = p[t->lumpadr[i] + 3] - p[t->jpointadr[t->lumpbody[i]] + 2];
      m = p[t->lumpadr[i]] / 3.0;
      tb69 = body0b[t->lumpbody[i]][9];
      tb70 = tb69 * g2_4;
      mb = -(tb70 * g1_4);
      g1_4b = -(tb70 * m);
      g2_4b = -(tb69 * (m * g1_4));
      tb67 = body0b[t->lumpbody[i]][8];
      tb68 = tb67 * g2_4;
      mb -= tb68 * g0_4;
      g0_4b = -(tb68 * m);
      g2_4b -= tb67 * (m * g0_4);
      tb65 = body0b[t->lumpbody[i]][7];
      tb66 = tb65 * g1_4;
      mb -= tb66 * g0_4;
      g0_4b -= tb66 * m;
      g1_4b -= tb65 * (m * g0_4);
      tb63 = body0b[t->lumpbody[i]][6];
      mb += tb63 * (g0_4 * g0_4 + g1_4 * g1_4);
      tb64 = tb63 * m;
      g0_4b += tb64 * g0_4;
      g0_4b += tb64 * g0_4;
      g1_4b += tb64 * g1_4;
      g1_4b += tb64 * g1_4;
      tb61 = body0b[t->lumpbody[i]][5];
      mb += tb61 * (g0_4 * g0_4 + g2_4 * g2_4);
      tb62 = tb61 * m;
      g0_4b += tb62 * g0_4;
      g0_4b += tb62 * g0_4;
      g2_4b += tb62 * g2_4;
      g2_4b += tb62 * g2_4;
      tb59 = body0b[t->lumpbody[i]][4];
      mb += tb59 * (g1_4 * g1_4 + g2_4 * g2_4);
      tb60 = tb59 * m;
      g1_4b += tb60 * g1_4;
      g1_4b += tb60 * g1_4;
      g2_4b += tb60 * g2_4;
      g2_4b += tb60 * g2_4;
      tb58 = body0b[t->lumpbody[i]][3];
      mb += tb58 * g2_4;
      g2_4b += tb58 * m;
      tb57 = body0b[t->lumpbody[i]][2];
      mb += tb57 * g1_4;
      g1_4b += tb57 * m;
      tb56 = body0b[t->lumpbody[i]][1];
      mb += tb56 * g0_4;
      g0_4b += tb56 * m;
      /* inertia of a mass m at g and of J about it, about the reference point:
       *   m,  m g,  J + m (g.g I - g g^T) */
      mb += body0b[t->lumpbody[i]][0];
      pb[t->lumpadr[i]] += mb / 3.0;
      pb[t->lumpadr[i] + 3] += g2_4b;
      pb[t->jpointadr[t->lumpbody[i]] + 2] -= g2_4b;
      pb[t->lumpadr[i] + 2] += g1_4b;
      pb[t->jpointadr[t->lumpbody[i]] + 1] -= g1_4b;
      pb[t->lumpadr[i] + 1] += g0_4b;
      pb[t->jpointadr[t->lumpbody[i]]] -= g0_4b;
    } else {
      g0_5 = p[t->lumpadr[i] + 4] - p[t->jpointadr[t->lumpbody[i]]];
      g1_5 = p[t->lumpadr[i] + 5] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g2_5 = p[t->lumpadr[i] + 6] - p[t->jpointadr[t->lumpbody[i]] + 2];
      m2 = p[t->lumpadr[i]] / 3.0;
      tb84 = body0b[t->lumpbody[i]][9];
      tb85 = tb84 * g2_5;
      m2b = -(tb85 * g1_5);
      g1_5b = -(tb85 * m2);
      g2_5b = -(tb84 * (m2 * g1_5));
      tb82 = body0b[t->lumpbody[i]][8];
      tb83 = tb82 * g2_5;
      m2b -= tb83 * g0_5;
      g0_5b = -(tb83 * m2);
      g2_5b -= tb82 * (m2 * g0_5);
      tb80 = body0b[t->lumpbody[i]][7];
      tb81 = tb80 * g1_5;
      m2b -= tb81 * g0_5;
      g0_5b -= tb81 * m2;
      g1_5b -= tb80 * (m2 * g0_5);
      tb78 = body0b[t->lumpbody[i]][6];
      m2b += tb78 * (g0_5 * g0_5 + g1_5 * g1_5);
      tb79 = tb78 * m2;
      g0_5b += tb79 * g0_5;
      g0_5b += tb79 * g0_5;
      g1_5b += tb79 * g1_5;
      g1_5b += tb79 * g1_5;
      tb76 = body0b[t->lumpbody[i]][5];
      m2b += tb76 * (g0_5 * g0_5 + g2_5 * g2_5);
      tb77 = tb76 * m2;
      g0_5b += tb77 * g0_5;
      g0_5b += tb77 * g0_5;
      g2_5b += tb77 * g2_5;
      g2_5b += tb77 * g2_5;
      tb74 = body0b[t->lumpbody[i]][4];
      m2b += tb74 * (g1_5 * g1_5 + g2_5 * g2_5);
      tb75 = tb74 * m2;
      g1_5b += tb75 * g1_5;
      g1_5b += tb75 * g1_5;
      g2_5b += tb75 * g2_5;
      g2_5b += tb75 * g2_5;
      tb73 = body0b[t->lumpbody[i]][3];
      m2b += tb73 * g2_5;
      g2_5b += tb73 * m2;
      tb72 = body0b[t->lumpbody[i]][2];
      m2b += tb72 * g1_5;
      g1_5b += tb72 * m2;
      tb71 = body0b[t->lumpbody[i]][1];
      m2b += tb71 * g0_5;
      g0_5b += tb71 * m2;
      /* inertia of a mass m at g and of J about it, about the reference point:
       *   m,  m g,  J + m (g.g I - g g^T) */
      m2b += body0b[t->lumpbody[i]][0];
      pb[t->lumpadr[i]] += m2b / 3.0;
      pb[t->lumpadr[i] + 6] += g2_5b;
      pb[t->jpointadr[t->lumpbody[i]] + 2] -= g2_5b;
      pb[t->lumpadr[i] + 5] += g1_5b;
      pb[t->jpointadr[t->lumpbody[i]] + 1] -= g1_5b;
      pb[t->lumpadr[i] + 4] += g0_5b;
      pb[t->jpointadr[t->lumpbody[i]]] -= g0_5b;
    }
  }
  for (i = t->nbody - 1; i >= 0; --i) {
    for (k = 9; k >= 0; --k) {
      body0b[i][k] = 0.0;
    }
  }
}

/* points relative to the reference point of their body, unit vectors, lengths as drawn */
void maggi_point_constants_b(const maggi_topo *t, const double p[restrict t->np],
                             double pb[restrict t->np], const double origin[restrict 3],
                             double point0[restrict t->npoint][3],
                             double point0b[restrict t->npoint][3],
                             double dir0[restrict t->ndir][3], double dir0b[restrict t->ndir][3],
                             double prim0[restrict t->nprim], double prim0b[restrict t->nprim],
                             double spring0[restrict t->nspring],
                             double spring0b[restrict t->nspring])
{
  int i, ref, ref2, ref3;
  double a0, a0_2, a0_2b, a0_3, a0_3b, a0b, a1, a1_2, a1_2b, a1_3, a1_3b, a1b, a20, a20b, a21, a21b,
      a22, a22b, a2_2, a2_2b, a2_3, a2_3b, a2_4, a2_4b, a30, a30b, a31, a31b, a32, a32b, c0b, c1b,
      c20, c20_2, c20_2b, c20b, c21, c21_2, c21_2b, c21b, c22, c22_2, c22_2b, c22b, c2_2b, c3, c3b,
      e0, e0b, e1, e1b, e2, e2b, f, fb, m0, m0b, m1, m1b, m2, m2b, n20, n20_2, n20_2b, n20b, n21,
      n21_2, n21_2b, n21b, n22, n22_2, n22_2b, n22b, n3, n3b, n4, n4b, n5, n5b, n6, n6b, n7, n7b,
      n8, n8b, s, s20, s20b, s21, s21b, s22, s22b, s3, s3b, sb, sv0b, sv1b, sv2b, t10b, t2, t2b, t3,
      t3b, t4, t4b, t5, t5b, t6, t6b, t7, t7b, t8, t8b, t9b, tb10, tb11, tb12, tb13, tb14, tb15,
      tb16, tb17, tb18, tb19, tb2, tb20, tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3,
      tb30, tb31, tb32, tb33, tb34, tb35, tb36, tb37, tb38, tb4, tb5, tb6, tb7, tb8, tb9, w0, w0_2,
      w0_2b, w1, w1_2, w1_2b, w2, w2_2, w2_2b, x, x2, x2b, xb, y, y2, y2b, yb, z, z2, z2b, zb;

  (void)origin;
  (void)point0;
  for (i = t->nspring - 1; i >= 0; --i) {
    x2 = p[t->pointadr[t->springpa[i]]] - p[t->pointadr[t->springpb[i]]];
    y2 = p[t->pointadr[t->springpa[i]] + 1] - p[t->pointadr[t->springpb[i]] + 1];
    z2 = p[t->pointadr[t->springpa[i]] + 2] - p[t->pointadr[t->springpb[i]] + 2];
    tb38 = spring0b[i];
    spring0b[i] = 0.0;
    t10b = tb38 * (1.0 / (2.0 * spring0[i]));
    x2b = t10b * x2;
    x2b += t10b * x2;
    y2b = t10b * y2;
    y2b += t10b * y2;
    z2b = t10b * z2;
    z2b += t10b * z2;
    pb[t->pointadr[t->springpa[i]] + 2] += z2b;
    pb[t->pointadr[t->springpb[i]] + 2] -= z2b;
    pb[t->pointadr[t->springpa[i]] + 1] += y2b;
    pb[t->pointadr[t->springpb[i]] + 1] -= y2b;
    pb[t->pointadr[t->springpa[i]]] += x2b;
    pb[t->pointadr[t->springpb[i]]] -= x2b;
  }
  for (i = t->nprim - 1; i >= 0; --i) {
    if (t->primkind[i] == MAGGI_PRIM_ROD && t->primadr[i] >= 0) {
      pb[t->primadr[i]] += prim0b[i];
      prim0b[i] = 0.0;
    } else if (t->primkind[i] == MAGGI_PRIM_ROD) {
      x = p[t->pointadr[t->primpa[i]]] - p[t->pointadr[t->primpb[i]]];
      y = p[t->pointadr[t->primpa[i]] + 1] - p[t->pointadr[t->primpb[i]] + 1];
      z = p[t->pointadr[t->primpa[i]] + 2] - p[t->pointadr[t->primpb[i]] + 2];
      tb36 = prim0b[i];
      prim0b[i] = 0.0;
      t9b = tb36 * (1.0 / (2.0 * prim0[i]));
      xb = t9b * x;
      xb += t9b * x;
      yb = t9b * y;
      yb += t9b * y;
      zb = t9b * z;
      zb += t9b * z;
      pb[t->pointadr[t->primpa[i]] + 2] += zb;
      pb[t->pointadr[t->primpb[i]] + 2] -= zb;
      pb[t->pointadr[t->primpa[i]] + 1] += yb;
      pb[t->pointadr[t->primpb[i]] + 1] -= yb;
      pb[t->pointadr[t->primpa[i]]] += xb;
      pb[t->pointadr[t->primpb[i]]] -= xb;
    } else if (t->primkind[i] == MAGGI_PRIM_ANGLE && t->primadr[i] == -1) {
      tb37 = prim0b[i];
      prim0b[i] = 0.0;
      dir0b[t->primda[i]][0] += tb37 * dir0[t->primdb[i]][0];
      dir0b[t->primdb[i]][0] += tb37 * dir0[t->primda[i]][0];
      dir0b[t->primda[i]][1] += tb37 * dir0[t->primdb[i]][1];
      dir0b[t->primdb[i]][1] += tb37 * dir0[t->primda[i]][1];
      dir0b[t->primda[i]][2] += tb37 * dir0[t->primdb[i]][2];
      dir0b[t->primdb[i]][2] += tb37 * dir0[t->primda[i]][2];
    } else {
      prim0b[i] = 0.0;
    }
  }
  for (i = t->ndir - 1; i >= 0; --i) {
    if (t->dirkind[i] == MAGGI_DIR_GLOBAL) {
      dir0b[i][2] = 0.0;
      dir0b[i][1] = 0.0;
      dir0b[i][0] = 0.0;
    } else if (t->dirkind[i] == MAGGI_DIR_PARAMETER) {
      a0 = p[t->diradr[i]];
      a1 = p[t->diradr[i] + 1];
      a2_2 = p[t->diradr[i] + 2];
      t2 = a0 * a0 + a1 * a1 + a2_2 * a2_2;
      n3 = sqrt(t2);
      tb12 = dir0b[i][2];
      dir0b[i][2] = 0.0;
      tb13 = tb12 / n3;
      a2_2b = tb13;
      n3b = -(tb13 * dir0[i][2]);
      tb10 = dir0b[i][1];
      dir0b[i][1] = 0.0;
      tb11 = tb10 / n3;
      a1b = tb11;
      n3b -= tb11 * dir0[i][1];
      tb8 = dir0b[i][0];
      dir0b[i][0] = 0.0;
      tb9 = tb8 / n3;
      a0b = tb9;
      n3b -= tb9 * dir0[i][0];
      t2b = n3b * (1.0 / (2.0 * n3));
      a0b += t2b * a0;
      a0b += t2b * a0;
      a1b += t2b * a1;
      a1b += t2b * a1;
      a2_2b += t2b * a2_2;
      a2_2b += t2b * a2_2;
      pb[t->diradr[i] + 2] += a2_2b;
      pb[t->diradr[i] + 1] += a1b;
      pb[t->diradr[i]] += a0b;
    } else if (t->dirkind[i] == MAGGI_DIR_CARRIED) {
      a0_2 = p[t->diraux[i]];
      a1_2 = p[t->diraux[i] + 1];
      a2_3 = p[t->diraux[i] + 2];
      t3 = a0_2 * a0_2 + a1_2 * a1_2 + a2_3 * a2_3;
      n4 = sqrt(t3);
      n20 = a0_2 / n4;
      n21 = a1_2 / n4;
      n22 = a2_3 / n4;
      w0 = t->dirlean[i] == 0 ? 1.0 : 0.0;
      w1 = t->dirlean[i] == 1 ? 1.0 : 0.0;
      w2 = t->dirlean[i] == 2 ? 1.0 : 0.0;
      s = w0 * n20 + w1 * n21 + w2 * n22;
      a20 = w0 - s * n20;
      a21 = w1 - s * n21;
      a22 = w2 - s * n22;
      t4 = a20 * a20 + a21 * a21 + a22 * a22;
      n5 = sqrt(t4);
      c20 = a20 / n5;
      c21 = a21 / n5;
      c22 = a22 / n5;
      e0 = p[t->diradr[i]];
      e1 = p[t->diradr[i] + 1];
      e2 = p[t->diradr[i] + 2];
      t5 = e0 * e0 + e1 * e1 + e2 * e2;
      n6 = sqrt(t5);
      m0 = e0 / n6;
      m1 = e1 / n6;
      m2 = e2 / n6;
      c3 = n20 * m0 + n21 * m1 + n22 * m2;
      s20 = n21 * m2 - n22 * m1;
      s21 = n22 * m0 - n20 * m2;
      s22 = n20 * m1 - n21 * m0;
      t6 = 1.0 + c3;
      f = (s20 * c20 + s21 * c21 + s22 * c22) / t6;
      tb26 = dir0b[i][2];
      dir0b[i][2] = 0.0;
      c3b = tb26 * c22;
      c22b = tb26 * c3;
      sv2b = tb26;
      fb = tb26 * s22;
      s22b = tb26 * f;
      tb25 = dir0b[i][1];
      dir0b[i][1] = 0.0;
      c3b += tb25 * c21;
      c21b = tb25 * c3;
      sv1b = tb25;
      fb += tb25 * s21;
      s21b = tb25 * f;
      tb24 = dir0b[i][0];
      dir0b[i][0] = 0.0;
      c3b += tb24 * c20;
      c20b = tb24 * c3;
      sv0b = tb24;
      fb += tb24 * s20;
      s20b = tb24 * f;
      tb23 = fb / t6;
      s20b += tb23 * c20;
      c20b += tb23 * s20;
      s21b += tb23 * c21;
      c21b += tb23 * s21;
      s22b += tb23 * c22;
      c22b += tb23 * s22;
      t6b = -(tb23 * f);
      c3b += t6b;
      s20b += sv2b * c21;
      c21b += sv2b * s20;
      s21b -= sv2b * c20;
      c20b -= sv2b * s21;
      s22b += sv1b * c20;
      c20b += sv1b * s22;
      s20b -= sv1b * c22;
      c22b -= sv1b * s20;
      s21b += sv0b * c22;
      c22b += sv0b * s21;
      s22b -= sv0b * c21;
      c21b -= sv0b * s22;
      n20b = s22b * m1;
      m1b = s22b * n20;
      n21b = -(s22b * m0);
      m0b = -(s22b * n21);
      n22b = s21b * m0;
      m0b += s21b * n22;
      n20b -= s21b * m2;
      m2b = -(s21b * n20);
      n21b += s20b * m2;
      m2b += s20b * n21;
      n22b -= s20b * m1;
      m1b -= s20b * n22;
      /* v turned by the smallest turn that takes the unit vector n to the unit vector m:
       *   c v + s × v + s (s.v) / (1 + c),  c = n.m,  s = n × m */
      n20b += c3b * m0;
      m0b += c3b * n20;
      n21b += c3b * m1;
      m1b += c3b * n21;
      n22b += c3b * m2;
      m2b += c3b * n22;
      tb22 = m2b / n6;
      e2b = tb22;
      n6b = -(tb22 * m2);
      tb21 = m1b / n6;
      e1b = tb21;
      n6b -= tb21 * m1;
      tb20 = m0b / n6;
      e0b = tb20;
      n6b -= tb20 * m0;
      t5b = n6b * (1.0 / (2.0 * n6));
      e0b += t5b * e0;
      e0b += t5b * e0;
      e1b += t5b * e1;
      e1b += t5b * e1;
      e2b += t5b * e2;
      e2b += t5b * e2;
      pb[t->diradr[i] + 2] += e2b;
      pb[t->diradr[i] + 1] += e1b;
      pb[t->diradr[i]] += e0b;
      tb19 = c22b / n5;
      a22b = tb19;
      n5b = -(tb19 * c22);
      tb18 = c21b / n5;
      a21b = tb18;
      n5b -= tb18 * c21;
      tb17 = c20b / n5;
      a20b = tb17;
      n5b -= tb17 * c20;
      t4b = n5b * (1.0 / (2.0 * n5));
      a20b += t4b * a20;
      a20b += t4b * a20;
      a21b += t4b * a21;
      a21b += t4b * a21;
      a22b += t4b * a22;
      a22b += t4b * a22;
      sb = -(a22b * n22);
      n22b -= a22b * s;
      sb -= a21b * n21;
      n21b -= a21b * s;
      sb -= a20b * n20;
      n20b -= a20b * s;
      /* the part of w across the unit vector n, made a unit vector */
      n20b += sb * w0;
      n21b += sb * w1;
      n22b += sb * w2;
      tb16 = n22b / n4;
      a2_3b = tb16;
      n4b = -(tb16 * n22);
      tb15 = n21b / n4;
      a1_2b = tb15;
      n4b -= tb15 * n21;
      tb14 = n20b / n4;
      a0_2b = tb14;
      n4b -= tb14 * n20;
      t3b = n4b * (1.0 / (2.0 * n4));
      a0_2b += t3b * a0_2;
      a0_2b += t3b * a0_2;
      a1_2b += t3b * a1_2;
      a1_2b += t3b * a1_2;
      a2_3b += t3b * a2_3;
      a2_3b += t3b * a2_3;
      pb[t->diraux[i] + 2] += a2_3b;
      pb[t->diraux[i] + 1] += a1_2b;
      pb[t->diraux[i]] += a0_2b;
    } else {
      a0_3 = p[t->diradr[i]];
      a1_3 = p[t->diradr[i] + 1];
      a2_4 = p[t->diradr[i] + 2];
      t7 = a0_3 * a0_3 + a1_3 * a1_3 + a2_4 * a2_4;
      n7 = sqrt(t7);
      n20_2 = a0_3 / n7;
      n21_2 = a1_3 / n7;
      n22_2 = a2_4 / n7;
      if (t->dirkind[i] == MAGGI_DIR_ACROSS || t->dirkind[i] == MAGGI_DIR_NORMAL) {
        w0_2 = p[t->diraux[i]];
        w1_2 = p[t->diraux[i] + 1];
        w2_2 = p[t->diraux[i] + 2];
      } else {
        w0_2 = t->diraux[i] == 0 ? 1.0 : 0.0;
        w1_2 = t->diraux[i] == 1 ? 1.0 : 0.0;
        w2_2 = t->diraux[i] == 2 ? 1.0 : 0.0;
      }
      s3 = w0_2 * n20_2 + w1_2 * n21_2 + w2_2 * n22_2;
      a30 = w0_2 - s3 * n20_2;
      a31 = w1_2 - s3 * n21_2;
      a32 = w2_2 - s3 * n22_2;
      t8 = a30 * a30 + a31 * a31 + a32 * a32;
      n8 = sqrt(t8);
      c20_2 = a30 / n8;
      c21_2 = a31 / n8;
      c22_2 = a32 / n8;
      c20_2b = 0.0;
      c21_2b = 0.0;
      c22_2b = 0.0;
      n20_2b = 0.0;
      n21_2b = 0.0;
      n22_2b = 0.0;
      if (t->dirkind[i] == MAGGI_DIR_ACROSS || t->dirkind[i] == MAGGI_DIR_ACROSS_GLOBAL) {
        c22_2b += dir0b[i][2];
        dir0b[i][2] = 0.0;
        c21_2b += dir0b[i][1];
        dir0b[i][1] = 0.0;
        c20_2b += dir0b[i][0];
        dir0b[i][0] = 0.0;
      } else {
        tb35 = dir0b[i][2];
        dir0b[i][2] = 0.0;
        n20_2b += tb35 * c21_2;
        c21_2b += tb35 * n20_2;
        n21_2b -= tb35 * c20_2;
        c20_2b -= tb35 * n21_2;
        tb34 = dir0b[i][1];
        dir0b[i][1] = 0.0;
        n22_2b += tb34 * c20_2;
        c20_2b += tb34 * n22_2;
        n20_2b -= tb34 * c22_2;
        c22_2b -= tb34 * n20_2;
        tb33 = dir0b[i][0];
        dir0b[i][0] = 0.0;
        n21_2b += tb33 * c22_2;
        c22_2b += tb33 * n21_2;
        n22_2b -= tb33 * c21_2;
        c21_2b -= tb33 * n22_2;
      }
      tb32 = c22_2b / n8;
      a32b = tb32;
      n8b = -(tb32 * c22_2);
      tb31 = c21_2b / n8;
      a31b = tb31;
      n8b -= tb31 * c21_2;
      tb30 = c20_2b / n8;
      a30b = tb30;
      n8b -= tb30 * c20_2;
      t8b = n8b * (1.0 / (2.0 * n8));
      a30b += t8b * a30;
      a30b += t8b * a30;
      a31b += t8b * a31;
      a31b += t8b * a31;
      a32b += t8b * a32;
      a32b += t8b * a32;
      w2_2b = a32b;
      s3b = -(a32b * n22_2);
      n22_2b -= a32b * s3;
      w1_2b = a31b;
      s3b -= a31b * n21_2;
      n21_2b -= a31b * s3;
      w0_2b = a30b;
      s3b -= a30b * n20_2;
      n20_2b -= a30b * s3;
      /* the part of w across the unit vector n, made a unit vector */
      w0_2b += s3b * n20_2;
      n20_2b += s3b * w0_2;
      w1_2b += s3b * n21_2;
      n21_2b += s3b * w1_2;
      w2_2b += s3b * n22_2;
      n22_2b += s3b * w2_2;
      if (t->dirkind[i] == MAGGI_DIR_ACROSS || t->dirkind[i] == MAGGI_DIR_NORMAL) {
        pb[t->diraux[i] + 2] += w2_2b;
        w2_2b = 0.0;
        pb[t->diraux[i] + 1] += w1_2b;
        w1_2b = 0.0;
        pb[t->diraux[i]] += w0_2b;
        w0_2b = 0.0;
      } else {
        w2_2b = 0.0;
        w1_2b = 0.0;
        w0_2b = 0.0;
      }
      tb29 = n22_2b / n7;
      a2_4b = tb29;
      n7b = -(tb29 * n22_2);
      tb28 = n21_2b / n7;
      a1_3b = tb28;
      n7b -= tb28 * n21_2;
      tb27 = n20_2b / n7;
      a0_3b = tb27;
      n7b -= tb27 * n20_2;
      t7b = n7b * (1.0 / (2.0 * n7));
      a0_3b += t7b * a0_3;
      a0_3b += t7b * a0_3;
      a1_3b += t7b * a1_3;
      a1_3b += t7b * a1_3;
      a2_4b += t7b * a2_4;
      a2_4b += t7b * a2_4;
      pb[t->diradr[i] + 2] += a2_4b;
      pb[t->diradr[i] + 1] += a1_3b;
      pb[t->diradr[i]] += a0_3b;
    }
  }
  for (i = t->npoint - 1; i >= 0; --i) {
    c2_2b = 0.0;
    if (t->pointbody[i] == t->nbody) {
      c2_2b += point0b[i][2];
      point0b[i][2] = 0.0;
    } else {
      ref3 = t->jpointadr[t->pointbody[i]];
      tb7 = point0b[i][2];
      point0b[i][2] = 0.0;
      c2_2b += tb7;
      pb[ref3 + 2] -= tb7;
    }
    c1b = 0.0;
    if (t->pointbody[i] == t->nbody) {
      c1b += point0b[i][1];
      point0b[i][1] = 0.0;
    } else {
      ref2 = t->jpointadr[t->pointbody[i]];
      tb6 = point0b[i][1];
      point0b[i][1] = 0.0;
      c1b += tb6;
      pb[ref2 + 1] -= tb6;
    }
    c0b = 0.0;
    if (t->pointbody[i] == t->nbody) {
      c0b += point0b[i][0];
      point0b[i][0] = 0.0;
    } else {
      ref = t->jpointadr[t->pointbody[i]];
      tb5 = point0b[i][0];
      point0b[i][0] = 0.0;
      c0b += tb5;
      pb[ref] -= tb5;
    }
    if (t->pointadr2[i] >= 0) {
      tb4 = c2_2b * 0.5;
      pb[t->pointadr[i] + 2] += tb4;
      pb[t->pointadr2[i] + 2] += tb4;
      c2_2b = 0.0;
    } else {
      pb[t->pointadr[i] + 2] += c2_2b;
      c2_2b = 0.0;
    }
    if (t->pointadr2[i] >= 0) {
      tb3 = c1b * 0.5;
      pb[t->pointadr[i] + 1] += tb3;
      pb[t->pointadr2[i] + 1] += tb3;
      c1b = 0.0;
    } else {
      pb[t->pointadr[i] + 1] += c1b;
      c1b = 0.0;
    }
    /* of a point, or the middle between two when the second address is not -1 */
    if (t->pointadr2[i] >= 0) {
      tb2 = c0b * 0.5;
      pb[t->pointadr[i]] += tb2;
      pb[t->pointadr2[i]] += tb2;
      c0b = 0.0;
    } else {
      pb[t->pointadr[i]] += c0b;
      c0b = 0.0;
    }
  }
}
