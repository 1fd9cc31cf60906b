/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/constants.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* offset0 = c0 - c0(parent), u0 = a0 / |a0| */
void maggi_joint_constants_dv(const maggi_topo *t, const double p[restrict t->np],
                              const double pd[restrict t->np][MAGGI_NDIR],
                              const double origin[restrict 3], double offset0[restrict t->nbody][3],
                              double offset0d[restrict t->nbody][3][MAGGI_NDIR],
                              double axis0[restrict t->nbody][3],
                              double axis0d[restrict t->nbody][3][MAGGI_NDIR], int nbdirs)
{
  int adr, i, nd, up;
  double a0, a0_2, a0_3, a1, a1_2, a1_3, a20, a21, a22, a2_2, a2_3, a2_4, a30, a31, a32, c0, c0_2,
      c1, c1_2, c2, c2_2, c2_3, c3, c4, c5, c6, c7, c8, e0, e1, e2, f, m0, m1, m2, n20, n20_2, n21,
      n21_2, n22, n22_2, n3, n3inv, n4, n4inv, n5, n5inv, n6, n6inv, n7, n7inv, n8, n8inv, s, s20,
      s21, s22, s3, t2, t3, t4, t5, t6, t6inv, t7, t8, w0, w0_2, w1, w1_2, w2, w2_2;
  double c0_2d[MAGGI_NDIR], c1_2d[MAGGI_NDIR], c2_3d[MAGGI_NDIR], n20_2d[MAGGI_NDIR],
      n21_2d[MAGGI_NDIR], n22_2d[MAGGI_NDIR], w0_2d[MAGGI_NDIR], w1_2d[MAGGI_NDIR],
      w2_2d[MAGGI_NDIR];

  (void)origin;
  (void)offset0;
  (void)nbdirs;
  for (i = 0; i < t->nbody; ++i) {
    adr = t->jpointadr[i];
    up = t->parent[i];
    if (up == t->nbody) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        offset0d[i][0][nd] = pd[adr][nd];
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        offset0d[i][0][nd] = pd[adr][nd] - pd[t->jpointadr[up]][nd];
      }
    }
    if (up == t->nbody) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        offset0d[i][1][nd] = pd[adr + 1][nd];
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        offset0d[i][1][nd] = pd[adr + 1][nd] - pd[t->jpointadr[up] + 1][nd];
      }
    }
    if (up == t->nbody) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        offset0d[i][2][nd] = pd[adr + 2][nd];
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        offset0d[i][2][nd] = pd[adr + 2][nd] - pd[t->jpointadr[up] + 2][nd];
      }
    }
    if (t->joint[i] != MAGGI_ONE_FIXED) {
      if (t->jdirkind[i] == MAGGI_DIR_GLOBAL) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          axis0d[i][0][nd] = 0.0;
          axis0d[i][1][nd] = 0.0;
          axis0d[i][2][nd] = 0.0;
        }
      } else if (t->jdirkind[i] == MAGGI_DIR_PARAMETER) {
        a0 = p[t->jdiradr[i]];
        a1 = p[t->jdiradr[i] + 1];
        a2_2 = p[t->jdiradr[i] + 2];
        t2 = a0 * a0 + a1 * a1 + a2_2 * a2_2;
        n3 = sqrt(t2);
        c3 = 1.0 / (2.0 * n3);
        n3inv = 1.0 / n3;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double a0d, a1d, a2_2d, n3d, t2d;

          a0d = pd[t->jdiradr[i]][nd];
          a1d = pd[t->jdiradr[i] + 1][nd];
          a2_2d = pd[t->jdiradr[i] + 2][nd];
          t2d = a0d * a0 + a0 * a0d + (a1d * a1 + a1 * a1d) + (a2_2d * a2_2 + a2_2 * a2_2d);
          n3d = c3 * t2d;
          axis0d[i][0][nd] = (a0d - axis0[i][0] * n3d) * n3inv;
          axis0d[i][1][nd] = (a1d - axis0[i][1] * n3d) * n3inv;
          axis0d[i][2][nd] = (a2_2d - axis0[i][2] * n3d) * n3inv;
        }
      } else if (t->jdirkind[i] == MAGGI_DIR_CARRIED) {
        a0_2 = p[t->jdiraux[i]];
        a1_2 = p[t->jdiraux[i] + 1];
        a2_3 = p[t->jdiraux[i] + 2];
        t3 = a0_2 * a0_2 + a1_2 * a1_2 + a2_3 * a2_3;
        n4 = sqrt(t3);
        c4 = 1.0 / (2.0 * n4);
        n20 = a0_2 / n4;
        n4inv = 1.0 / n4;
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
        c5 = 1.0 / (2.0 * n5);
        c0 = a20 / n5;
        n5inv = 1.0 / n5;
        c1 = a21 / n5;
        c2_2 = a22 / n5;
        e0 = p[t->jdiradr[i]];
        e1 = p[t->jdiradr[i] + 1];
        e2 = p[t->jdiradr[i] + 2];
        t5 = e0 * e0 + e1 * e1 + e2 * e2;
        n6 = sqrt(t5);
        c6 = 1.0 / (2.0 * n6);
        m0 = e0 / n6;
        n6inv = 1.0 / n6;
        m1 = e1 / n6;
        m2 = e2 / n6;
        c2 = n20 * m0 + n21 * m1 + n22 * m2;
        s20 = n21 * m2 - n22 * m1;
        s21 = n22 * m0 - n20 * m2;
        s22 = n20 * m1 - n21 * m0;
        t6 = 1.0 + c2;
        f = (s20 * c0 + s21 * c1 + s22 * c2_2) / t6;
        t6inv = 1.0 / t6;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double a0_2d, a1_2d, a20d, a21d, a22d, a2_3d, c0d, c1d, c2_2d, c2d, e0d, e1d, e2d, fd,
              m0d, m1d, m2d, n20d, n21d, n22d, n4d, n5d, n6d, s20d, s21d, s22d, sd, sv0d, sv1d,
              sv2d, t3d, t4d, t5d, t6d;

          a0_2d = pd[t->jdiraux[i]][nd];
          a1_2d = pd[t->jdiraux[i] + 1][nd];
          a2_3d = pd[t->jdiraux[i] + 2][nd];
          t3d = a0_2d * a0_2 + a0_2 * a0_2d + (a1_2d * a1_2 + a1_2 * a1_2d) + (a2_3d * a2_3 + a2_3 *
              a2_3d);
          n4d = c4 * t3d;
          n20d = (a0_2d - n20 * n4d) * n4inv;
          n21d = (a1_2d - n21 * n4d) * n4inv;
          n22d = (a2_3d - n22 * n4d) * n4inv;
          /* the part of w across the unit vector n, made a unit vector */
          sd = w0 * n20d + w1 * n21d + w2 * n22d;
          a20d = -(sd * n20 + s * n20d);
          a21d = -(sd * n21 + s * n21d);
          a22d = -(sd * n22 + s * n22d);
          t4d = a20d * a20 + a20 * a20d + (a21d * a21 + a21 * a21d) + (a22d * a22 + a22 * a22d);
          n5d = c5 * t4d;
          c0d = (a20d - c0 * n5d) * n5inv;
          c1d = (a21d - c1 * n5d) * n5inv;
          c2_2d = (a22d - c2_2 * n5d) * n5inv;
          e0d = pd[t->jdiradr[i]][nd];
          e1d = pd[t->jdiradr[i] + 1][nd];
          e2d = pd[t->jdiradr[i] + 2][nd];
          t5d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2d * e2 + e2 * e2d);
          n6d = c6 * t5d;
          m0d = (e0d - m0 * n6d) * n6inv;
          m1d = (e1d - m1 * n6d) * n6inv;
          m2d = (e2d - m2 * n6d) * n6inv;
          /* v turned by the smallest turn that takes the unit vector n to the unit vector m:
           *   c v + s × v + s (s.v) / (1 + c),  c = n.m,  s = n × m */
          c2d = n20d * m0 + n20 * m0d + (n21d * m1 + n21 * m1d) + (n22d * m2 + n22 * m2d);
          s20d = n21d * m2 + n21 * m2d - (n22d * m1 + n22 * m1d);
          s21d = n22d * m0 + n22 * m0d - (n20d * m2 + n20 * m2d);
          s22d = n20d * m1 + n20 * m1d - (n21d * m0 + n21 * m0d);
          sv0d = s21d * c2_2 + s21 * c2_2d - (s22d * c1 + s22 * c1d);
          sv1d = s22d * c0 + s22 * c0d - (s20d * c2_2 + s20 * c2_2d);
          sv2d = s20d * c1 + s20 * c1d - (s21d * c0 + s21 * c0d);
          t6d = c2d;
          fd = (s20d * c0 + s20 * c0d + (s21d * c1 + s21 * c1d) + (s22d * c2_2 + s22 * c2_2d) - f *
              t6d) * t6inv;
          axis0d[i][0][nd] = c2d * c0 + c2 * c0d + sv0d + (fd * s20 + f * s20d);
          axis0d[i][1][nd] = c2d * c1 + c2 * c1d + sv1d + (fd * s21 + f * s21d);
          axis0d[i][2][nd] = c2d * c2_2 + c2 * c2_2d + sv2d + (fd * s22 + f * s22d);
        }
      } else {
        a0_3 = p[t->jdiradr[i]];
        a1_3 = p[t->jdiradr[i] + 1];
        a2_4 = p[t->jdiradr[i] + 2];
        t7 = a0_3 * a0_3 + a1_3 * a1_3 + a2_4 * a2_4;
        n7 = sqrt(t7);
        c7 = 1.0 / (2.0 * n7);
        n20_2 = a0_3 / n7;
        n7inv = 1.0 / n7;
        n21_2 = a1_3 / n7;
        n22_2 = a2_4 / n7;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double a0_3d, a1_3d, a2_4d, n7d, t7d;

          a0_3d = pd[t->jdiradr[i]][nd];
          a1_3d = pd[t->jdiradr[i] + 1][nd];
          a2_4d = pd[t->jdiradr[i] + 2][nd];
          t7d = a0_3d * a0_3 + a0_3 * a0_3d + (a1_3d * a1_3 + a1_3 * a1_3d) + (a2_4d * a2_4 + a2_4 *
              a2_4d);
          n7d = c7 * t7d;
          n20_2d[nd] = (a0_3d - n20_2 * n7d) * n7inv;
          n21_2d[nd] = (a1_3d - n21_2 * n7d) * n7inv;
          n22_2d[nd] = (a2_4d - n22_2 * n7d) * n7inv;
        }
        if (t->jdirkind[i] == MAGGI_DIR_ACROSS || t->jdirkind[i] == MAGGI_DIR_NORMAL) {
          w0_2 = p[t->jdiraux[i]];
          w1_2 = p[t->jdiraux[i] + 1];
          w2_2 = p[t->jdiraux[i] + 2];
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            w0_2d[nd] = pd[t->jdiraux[i]][nd];
            w1_2d[nd] = pd[t->jdiraux[i] + 1][nd];
            w2_2d[nd] = pd[t->jdiraux[i] + 2][nd];
          }
        } else {
          w0_2 = t->jdiraux[i] == 0 ? 1.0 : 0.0;
          w1_2 = t->jdiraux[i] == 1 ? 1.0 : 0.0;
          w2_2 = t->jdiraux[i] == 2 ? 1.0 : 0.0;
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            w0_2d[nd] = 0.0;
            w1_2d[nd] = 0.0;
            w2_2d[nd] = 0.0;
          }
        }
        s3 = w0_2 * n20_2 + w1_2 * n21_2 + w2_2 * n22_2;
        a30 = w0_2 - s3 * n20_2;
        a31 = w1_2 - s3 * n21_2;
        a32 = w2_2 - s3 * n22_2;
        t8 = a30 * a30 + a31 * a31 + a32 * a32;
        n8 = sqrt(t8);
        c8 = 1.0 / (2.0 * n8);
        c0_2 = a30 / n8;
        n8inv = 1.0 / n8;
        c1_2 = a31 / n8;
        c2_3 = a32 / n8;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double a30d, a31d, a32d, n8d, s3d, t8d;

          /* the part of w across the unit vector n, made a unit vector */
          s3d = w0_2d[nd] * n20_2 + w0_2 * n20_2d[nd] + (w1_2d[nd] * n21_2 + w1_2 * n21_2d[nd]) +
              (w2_2d[nd] * n22_2 + w2_2 * n22_2d[nd]);
          a30d = w0_2d[nd] - (s3d * n20_2 + s3 * n20_2d[nd]);
          a31d = w1_2d[nd] - (s3d * n21_2 + s3 * n21_2d[nd]);
          a32d = w2_2d[nd] - (s3d * n22_2 + s3 * n22_2d[nd]);
          t8d = a30d * a30 + a30 * a30d + (a31d * a31 + a31 * a31d) + (a32d * a32 + a32 * a32d);
          n8d = c8 * t8d;
          c0_2d[nd] = (a30d - c0_2 * n8d) * n8inv;
          c1_2d[nd] = (a31d - c1_2 * n8d) * n8inv;
          c2_3d[nd] = (a32d - c2_3 * n8d) * n8inv;
        }
        if (t->jdirkind[i] == MAGGI_DIR_ACROSS || t->jdirkind[i] == MAGGI_DIR_ACROSS_GLOBAL) {
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            axis0d[i][0][nd] = c0_2d[nd];
            axis0d[i][1][nd] = c1_2d[nd];
            axis0d[i][2][nd] = c2_3d[nd];
          }
        } else {
#pragma omp simd
          for (nd = 0; nd < MAGGI_NDIR; ++nd) {
            axis0d[i][0][nd] = n21_2d[nd] * c2_3 + n21_2 * c2_3d[nd] - (n22_2d[nd] * c1_2 + n22_2 *
                c1_2d[nd]);
            axis0d[i][1][nd] = n22_2d[nd] * c0_2 + n22_2 * c0_2d[nd] - (n20_2d[nd] * c2_3 + n20_2 *
                c2_3d[nd]);
            axis0d[i][2][nd] = n20_2d[nd] * c1_2 + n20_2 * c1_2d[nd] - (n21_2d[nd] * c0_2 + n21_2 *
                c0_2d[nd]);
          }
        }
      }
    }
  }
}

void maggi_inertia_constants_dv(const maggi_topo *t, const double p[restrict t->np],
                                const double pd[restrict t->np][MAGGI_NDIR],
                                double body0[restrict t->nbody][10],
                                double body0d[restrict t->nbody][10][MAGGI_NDIR], int nbdirs)
{
  int i, k, nd;
  double e0, e1, e2, g0, g0_2, g0_3, g0_4, g0_5, g1, g1_2, g1_3, g1_4, g1_5, g2, g2_2, g2_3, g2_4,
      g2_5, m, m2, p_i, p_i1, p_i2, p_i3, p_i4, p_i5, p_i6, p_i7, p_i8;

  (void)body0;
  (void)nbdirs;
  for (i = 0; i < t->nbody; ++i) {
    for (k = 0; k < 10; ++k) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        body0d[i][k][nd] = 0.0;
      }
    }
  }
  for (i = 0; i < t->nlump; ++i) {
    if (t->lumpkind[i] == MAGGI_LUMP_RIGID) {
      g0 = p[t->lumpadr[i] + 1] - p[t->jpointadr[t->lumpbody[i]]];
      g1 = p[t->lumpadr[i] + 2] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g2 = p[t->lumpadr[i] + 3] - p[t->jpointadr[t->lumpbody[i]] + 2];
      p_i = p[t->lumpadr[i]];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double J0d, J1d, J2_2d, J3_2d, J4_2d, J5d, g0d, g1d, g2d, p_id;

        g0d = pd[t->lumpadr[i] + 1][nd] - pd[t->jpointadr[t->lumpbody[i]]][nd];
        g1d = pd[t->lumpadr[i] + 2][nd] - pd[t->jpointadr[t->lumpbody[i]] + 1][nd];
        g2d = pd[t->lumpadr[i] + 3][nd] - pd[t->jpointadr[t->lumpbody[i]] + 2][nd];
        J0d = pd[t->lumpadr[i] + 4][nd];
        J1d = pd[t->lumpadr[i] + 5][nd];
        J2_2d = pd[t->lumpadr[i] + 6][nd];
        J3_2d = pd[t->lumpadr[i] + 7][nd];
        J4_2d = pd[t->lumpadr[i] + 8][nd];
        J5d = pd[t->lumpadr[i] + 9][nd];
        p_id = pd[t->lumpadr[i]][nd];
        /* inertia of a mass m at g and of J about it, about the reference point:
         *   m,  m g,  J + m (g.g I - g g^T) */
        body0d[t->lumpbody[i]][0][nd] += p_id;
        body0d[t->lumpbody[i]][1][nd] += p_id * g0 + p_i * g0d;
        body0d[t->lumpbody[i]][2][nd] += p_id * g1 + p_i * g1d;
        body0d[t->lumpbody[i]][3][nd] += p_id * g2 + p_i * g2d;
        body0d[t->lumpbody[i]][4][nd] += J0d + (p_id * (g1 * g1 + g2 * g2) + p_i * (g1d * g1 + g1 *
            g1d + (g2d * g2 + g2 * g2d)));
        body0d[t->lumpbody[i]][5][nd] += J1d + (p_id * (g0 * g0 + g2 * g2) + p_i * (g0d * g0 + g0 *
            g0d + (g2d * g2 + g2 * g2d)));
        body0d[t->lumpbody[i]][6][nd] += J2_2d + (p_id * (g0 * g0 + g1 * g1) + p_i * (g0d * g0 + g0
            * g0d + (g1d * g1 + g1 * g1d)));
        body0d[t->lumpbody[i]][7][nd] += J3_2d - ((p_id * g0 + p_i * g0d) * g1 + p_i * g0 * g1d);
        body0d[t->lumpbody[i]][8][nd] += J4_2d - ((p_id * g0 + p_i * g0d) * g2 + p_i * g0 * g2d);
        body0d[t->lumpbody[i]][9][nd] += J5d - ((p_id * g1 + p_i * g1d) * g2 + p_i * g1 * g2d);
      }
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
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double J0_2d, J1_2d, J2_3d, J3_3d, J4_3d, J5_2d, e0d, e1d, e2d, g0_2d, g1_2d, g2_2d, p_i1d,
            p_i2d, p_i3d, p_i4d, p_i5d, p_i6d, p_i7d;

        p_i1d = pd[t->lumpadr[i] + 1][nd];
        p_i4d = pd[t->lumpadr[i] + 4][nd];
        g0_2d = 0.5 * (p_i1d + p_i4d) - pd[t->jpointadr[t->lumpbody[i]]][nd];
        e0d = p_i4d - p_i1d;
        p_i2d = pd[t->lumpadr[i] + 2][nd];
        p_i5d = pd[t->lumpadr[i] + 5][nd];
        g1_2d = 0.5 * (p_i2d + p_i5d) - pd[t->jpointadr[t->lumpbody[i]] + 1][nd];
        e1d = p_i5d - p_i2d;
        p_i3d = pd[t->lumpadr[i] + 3][nd];
        p_i6d = pd[t->lumpadr[i] + 6][nd];
        g2_2d = 0.5 * (p_i3d + p_i6d) - pd[t->jpointadr[t->lumpbody[i]] + 2][nd];
        e2d = p_i6d - p_i3d;
        p_i7d = pd[t->lumpadr[i]][nd];
        /* uniform thin bar along e: J = m/12 (e.e I - e e^T) */
        J0_2d = p_i7d / 12.0 * (e1 * e1 + e2 * e2) + p_i7 / 12.0 * (e1d * e1 + e1 * e1d + (e2d * e2
            + e2 * e2d));
        J1_2d = p_i7d / 12.0 * (e0 * e0 + e2 * e2) + p_i7 / 12.0 * (e0d * e0 + e0 * e0d + (e2d * e2
            + e2 * e2d));
        J2_3d = p_i7d / 12.0 * (e0 * e0 + e1 * e1) + p_i7 / 12.0 * (e0d * e0 + e0 * e0d + (e1d * e1
            + e1 * e1d));
        J3_3d = (-(p_i7d / 12.0 * e0) + -p_i7 / 12.0 * e0d) * e1 + -p_i7 / 12.0 * e0 * e1d;
        J4_3d = (-(p_i7d / 12.0 * e0) + -p_i7 / 12.0 * e0d) * e2 + -p_i7 / 12.0 * e0 * e2d;
        J5_2d = (-(p_i7d / 12.0 * e1) + -p_i7 / 12.0 * e1d) * e2 + -p_i7 / 12.0 * e1 * e2d;
        /* inertia of a mass m at g and of J about it, about the reference point:
         *   m,  m g,  J + m (g.g I - g g^T) */
        body0d[t->lumpbody[i]][0][nd] += p_i7d;
        body0d[t->lumpbody[i]][1][nd] += p_i7d * g0_2 + p_i7 * g0_2d;
        body0d[t->lumpbody[i]][2][nd] += p_i7d * g1_2 + p_i7 * g1_2d;
        body0d[t->lumpbody[i]][3][nd] += p_i7d * g2_2 + p_i7 * g2_2d;
        body0d[t->lumpbody[i]][4][nd] += J0_2d + (p_i7d * (g1_2 * g1_2 + g2_2 * g2_2) + p_i7 *
            (g1_2d * g1_2 + g1_2 * g1_2d + (g2_2d * g2_2 + g2_2 * g2_2d)));
        body0d[t->lumpbody[i]][5][nd] += J1_2d + (p_i7d * (g0_2 * g0_2 + g2_2 * g2_2) + p_i7 *
            (g0_2d * g0_2 + g0_2 * g0_2d + (g2_2d * g2_2 + g2_2 * g2_2d)));
        body0d[t->lumpbody[i]][6][nd] += J2_3d + (p_i7d * (g0_2 * g0_2 + g1_2 * g1_2) + p_i7 *
            (g0_2d * g0_2 + g0_2 * g0_2d + (g1_2d * g1_2 + g1_2 * g1_2d)));
        body0d[t->lumpbody[i]][7][nd] += J3_3d - ((p_i7d * g0_2 + p_i7 * g0_2d) * g1_2 + p_i7 * g0_2
            * g1_2d);
        body0d[t->lumpbody[i]][8][nd] += J4_3d - ((p_i7d * g0_2 + p_i7 * g0_2d) * g2_2 + p_i7 * g0_2
            * g2_2d);
        body0d[t->lumpbody[i]][9][nd] += J5_2d - ((p_i7d * g1_2 + p_i7 * g1_2d) * g2_2 + p_i7 * g1_2
            * g2_2d);
      }
    } else if (t->lumpkind[i] == MAGGI_LUMP_POINT) {
      g0_3 = p[t->lumpadr[i] + 1] - p[t->jpointadr[t->lumpbody[i]]];
      g1_3 = p[t->lumpadr[i] + 2] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g2_3 = p[t->lumpadr[i] + 3] - p[t->jpointadr[t->lumpbody[i]] + 2];
      p_i8 = p[t->lumpadr[i]];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double g0_3d, g1_3d, g2_3d, p_i8d;

        g0_3d = pd[t->lumpadr[i] + 1][nd] - pd[t->jpointadr[t->lumpbody[i]]][nd];
        g1_3d = pd[t->lumpadr[i] + 2][nd] - pd[t->jpointadr[t->lumpbody[i]] + 1][nd];
        g2_3d = pd[t->lumpadr[i] + 3][nd] - pd[t->jpointadr[t->lumpbody[i]] + 2][nd];
        p_i8d = pd[t->lumpadr[i]][nd];
        /* inertia of a mass m at g and of J about it, about the reference point:
         *   m,  m g,  J + m (g.g I - g g^T) */
        body0d[t->lumpbody[i]][0][nd] += p_i8d;
        body0d[t->lumpbody[i]][1][nd] += p_i8d * g0_3 + p_i8 * g0_3d;
        body0d[t->lumpbody[i]][2][nd] += p_i8d * g1_3 + p_i8 * g1_3d;
        body0d[t->lumpbody[i]][3][nd] += p_i8d * g2_3 + p_i8 * g2_3d;
        body0d[t->lumpbody[i]][4][nd] += p_i8d * (g1_3 * g1_3 + g2_3 * g2_3) + p_i8 * (g1_3d * g1_3
            + g1_3 * g1_3d + (g2_3d * g2_3 + g2_3 * g2_3d));
        body0d[t->lumpbody[i]][5][nd] += p_i8d * (g0_3 * g0_3 + g2_3 * g2_3) + p_i8 * (g0_3d * g0_3
            + g0_3 * g0_3d + (g2_3d * g2_3 + g2_3 * g2_3d));
        body0d[t->lumpbody[i]][6][nd] += p_i8d * (g0_3 * g0_3 + g1_3 * g1_3) + p_i8 * (g0_3d * g0_3
            + g0_3 * g0_3d + (g1_3d * g1_3 + g1_3 * g1_3d));
        body0d[t->lumpbody[i]][7][nd] += -((p_i8d * g0_3 + p_i8 * g0_3d) * g1_3 + p_i8 * g0_3 *
            g1_3d);
        body0d[t->lumpbody[i]][8][nd] += -((p_i8d * g0_3 + p_i8 * g0_3d) * g2_3 + p_i8 * g0_3 *
            g2_3d);
        body0d[t->lumpbody[i]][9][nd] += -((p_i8d * g1_3 + p_i8 * g1_3d) * g2_3 + p_i8 * g1_3 *
            g2_3d);
      }
    } else if (t->lumpkind[i] == MAGGI_LUMP_ROD_A) {
      g0_4 = p[t->lumpadr[i] + 1] - p[t->jpointadr[t->lumpbody[i]]];
      g1_4 = p[t->lumpadr[i] + 2] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g2_4 = p[t->lumpadr[i] + 3] - p[t->jpointadr[t->lumpbody[i]] + 2];
      m = p[t->lumpadr[i]] / 3.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double g0_4d, g1_4d, g2_4d, md;

        g0_4d = pd[t->lumpadr[i] + 1][nd] - pd[t->jpointadr[t->lumpbody[i]]][nd];
        g1_4d = pd[t->lumpadr[i] + 2][nd] - pd[t->jpointadr[t->lumpbody[i]] + 1][nd];
        g2_4d = pd[t->lumpadr[i] + 3][nd] - pd[t->jpointadr[t->lumpbody[i]] + 2][nd];
        md = pd[t->lumpadr[i]][nd] / 3.0;
        /* inertia of a mass m at g and of J about it, about the reference point:
         *   m,  m g,  J + m (g.g I - g g^T) */
        body0d[t->lumpbody[i]][0][nd] += md;
        body0d[t->lumpbody[i]][1][nd] += md * g0_4 + m * g0_4d;
        body0d[t->lumpbody[i]][2][nd] += md * g1_4 + m * g1_4d;
        body0d[t->lumpbody[i]][3][nd] += md * g2_4 + m * g2_4d;
        body0d[t->lumpbody[i]][4][nd] += md * (g1_4 * g1_4 + g2_4 * g2_4) + m * (g1_4d * g1_4 + g1_4
            * g1_4d + (g2_4d * g2_4 + g2_4 * g2_4d));
        body0d[t->lumpbody[i]][5][nd] += md * (g0_4 * g0_4 + g2_4 * g2_4) + m * (g0_4d * g0_4 + g0_4
            * g0_4d + (g2_4d * g2_4 + g2_4 * g2_4d));
        body0d[t->lumpbody[i]][6][nd] += md * (g0_4 * g0_4 + g1_4 * g1_4) + m * (g0_4d * g0_4 + g0_4
            * g0_4d + (g1_4d * g1_4 + g1_4 * g1_4d));
        body0d[t->lumpbody[i]][7][nd] += -((md * g0_4 + m * g0_4d) * g1_4 + m * g0_4 * g1_4d);
        body0d[t->lumpbody[i]][8][nd] += -((md * g0_4 + m * g0_4d) * g2_4 + m * g0_4 * g2_4d);
        body0d[t->lumpbody[i]][9][nd] += -((md * g1_4 + m * g1_4d) * g2_4 + m * g1_4 * g2_4d);
      }
    } else {
      g0_5 = p[t->lumpadr[i] + 4] - p[t->jpointadr[t->lumpbody[i]]];
      g1_5 = p[t->lumpadr[i] + 5] - p[t->jpointadr[t->lumpbody[i]] + 1];
      g2_5 = p[t->lumpadr[i] + 6] - p[t->jpointadr[t->lumpbody[i]] + 2];
      m2 = p[t->lumpadr[i]] / 3.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double g0_5d, g1_5d, g2_5d, m2d;

        g0_5d = pd[t->lumpadr[i] + 4][nd] - pd[t->jpointadr[t->lumpbody[i]]][nd];
        g1_5d = pd[t->lumpadr[i] + 5][nd] - pd[t->jpointadr[t->lumpbody[i]] + 1][nd];
        g2_5d = pd[t->lumpadr[i] + 6][nd] - pd[t->jpointadr[t->lumpbody[i]] + 2][nd];
        m2d = pd[t->lumpadr[i]][nd] / 3.0;
        /* inertia of a mass m at g and of J about it, about the reference point:
         *   m,  m g,  J + m (g.g I - g g^T) */
        body0d[t->lumpbody[i]][0][nd] += m2d;
        body0d[t->lumpbody[i]][1][nd] += m2d * g0_5 + m2 * g0_5d;
        body0d[t->lumpbody[i]][2][nd] += m2d * g1_5 + m2 * g1_5d;
        body0d[t->lumpbody[i]][3][nd] += m2d * g2_5 + m2 * g2_5d;
        body0d[t->lumpbody[i]][4][nd] += m2d * (g1_5 * g1_5 + g2_5 * g2_5) + m2 * (g1_5d * g1_5 +
            g1_5 * g1_5d + (g2_5d * g2_5 + g2_5 * g2_5d));
        body0d[t->lumpbody[i]][5][nd] += m2d * (g0_5 * g0_5 + g2_5 * g2_5) + m2 * (g0_5d * g0_5 +
            g0_5 * g0_5d + (g2_5d * g2_5 + g2_5 * g2_5d));
        body0d[t->lumpbody[i]][6][nd] += m2d * (g0_5 * g0_5 + g1_5 * g1_5) + m2 * (g0_5d * g0_5 +
            g0_5 * g0_5d + (g1_5d * g1_5 + g1_5 * g1_5d));
        body0d[t->lumpbody[i]][7][nd] += -((m2d * g0_5 + m2 * g0_5d) * g1_5 + m2 * g0_5 * g1_5d);
        body0d[t->lumpbody[i]][8][nd] += -((m2d * g0_5 + m2 * g0_5d) * g2_5 + m2 * g0_5 * g2_5d);
        body0d[t->lumpbody[i]][9][nd] += -((m2d * g1_5 + m2 * g1_5d) * g2_5 + m2 * g1_5 * g2_5d);
      }
    }
  }
}

/* points relative to the reference point of their body, unit vectors, lengths as drawn */
void maggi_point_constants_dv(const maggi_topo *t, const double p[restrict t->np],
                              const double pd[restrict t->np][MAGGI_NDIR],
                              const double origin[restrict 3], double point0[restrict t->npoint][3],
                              double point0d[restrict t->npoint][3][MAGGI_NDIR],
                              double dir0[restrict t->ndir][3],
                              double dir0d[restrict t->ndir][3][MAGGI_NDIR],
                              double prim0[restrict t->nprim],
                              double prim0d[restrict t->nprim][MAGGI_NDIR],
                              double spring0[restrict t->nspring],
                              double spring0d[restrict t->nspring][MAGGI_NDIR], int nbdirs)
{
  int i, nd, ref, ref2, ref3;
  double a0, a0_2, a0_3, a1, a1_2, a1_3, a20, a21, a22, a2_2, a2_3, a2_4, a30, a31, a32, c10, c11,
      c20, c20_2, c21, c21_2, c22, c22_2, c3, c4, c5, c6, c7, c8, c9, e0, e1, e2, f, m0, m1, m2,
      n20, n20_2, n21, n21_2, n22, n22_2, n3, n3inv, n4, n4inv, n5, n5inv, n6, n6inv, n7, n7inv, n8,
      n8inv, s, s20, s21, s22, s3, t2, t3, t4, t5, t6, t6inv, t7, t8, w0, w0_2, w1, w1_2, w2, w2_2,
      x, x2, y, y2, z, z2;
  double c0d[MAGGI_NDIR], c1d[MAGGI_NDIR], c20_2d[MAGGI_NDIR], c21_2d[MAGGI_NDIR],
      c22_2d[MAGGI_NDIR], c2_2d[MAGGI_NDIR], n20_2d[MAGGI_NDIR], n21_2d[MAGGI_NDIR],
      n22_2d[MAGGI_NDIR], w0_2d[MAGGI_NDIR], w1_2d[MAGGI_NDIR], w2_2d[MAGGI_NDIR];

  (void)origin;
  (void)point0;
  (void)nbdirs;
  for (i = 0; i < t->npoint; ++i) {
    /* of a point, or the middle between two when the second address is not -1 */
    if (t->pointadr2[i] >= 0) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        c0d[nd] = 0.5 * (pd[t->pointadr[i]][nd] + pd[t->pointadr2[i]][nd]);
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        c0d[nd] = pd[t->pointadr[i]][nd];
      }
    }
    if (t->pointadr2[i] >= 0) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        c1d[nd] = 0.5 * (pd[t->pointadr[i] + 1][nd] + pd[t->pointadr2[i] + 1][nd]);
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        c1d[nd] = pd[t->pointadr[i] + 1][nd];
      }
    }
    if (t->pointadr2[i] >= 0) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        c2_2d[nd] = 0.5 * (pd[t->pointadr[i] + 2][nd] + pd[t->pointadr2[i] + 2][nd]);
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        c2_2d[nd] = pd[t->pointadr[i] + 2][nd];
      }
    }
    if (t->pointbody[i] == t->nbody) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        point0d[i][0][nd] = c0d[nd];
      }
    } else {
      ref = t->jpointadr[t->pointbody[i]];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        point0d[i][0][nd] = c0d[nd] - pd[ref][nd];
      }
    }
    if (t->pointbody[i] == t->nbody) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        point0d[i][1][nd] = c1d[nd];
      }
    } else {
      ref2 = t->jpointadr[t->pointbody[i]];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        point0d[i][1][nd] = c1d[nd] - pd[ref2 + 1][nd];
      }
    }
    if (t->pointbody[i] == t->nbody) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        point0d[i][2][nd] = c2_2d[nd];
      }
    } else {
      ref3 = t->jpointadr[t->pointbody[i]];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        point0d[i][2][nd] = c2_2d[nd] - pd[ref3 + 2][nd];
      }
    }
  }
  for (i = 0; i < t->ndir; ++i) {
    if (t->dirkind[i] == MAGGI_DIR_GLOBAL) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        dir0d[i][0][nd] = 0.0;
        dir0d[i][1][nd] = 0.0;
        dir0d[i][2][nd] = 0.0;
      }
    } else if (t->dirkind[i] == MAGGI_DIR_PARAMETER) {
      a0 = p[t->diradr[i]];
      a1 = p[t->diradr[i] + 1];
      a2_2 = p[t->diradr[i] + 2];
      t2 = a0 * a0 + a1 * a1 + a2_2 * a2_2;
      n3 = sqrt(t2);
      c4 = 1.0 / (2.0 * n3);
      n3inv = 1.0 / n3;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double a0d, a1d, a2_2d, n3d, t2d;

        a0d = pd[t->diradr[i]][nd];
        a1d = pd[t->diradr[i] + 1][nd];
        a2_2d = pd[t->diradr[i] + 2][nd];
        t2d = a0d * a0 + a0 * a0d + (a1d * a1 + a1 * a1d) + (a2_2d * a2_2 + a2_2 * a2_2d);
        n3d = c4 * t2d;
        dir0d[i][0][nd] = (a0d - dir0[i][0] * n3d) * n3inv;
        dir0d[i][1][nd] = (a1d - dir0[i][1] * n3d) * n3inv;
        dir0d[i][2][nd] = (a2_2d - dir0[i][2] * n3d) * n3inv;
      }
    } else if (t->dirkind[i] == MAGGI_DIR_CARRIED) {
      a0_2 = p[t->diraux[i]];
      a1_2 = p[t->diraux[i] + 1];
      a2_3 = p[t->diraux[i] + 2];
      t3 = a0_2 * a0_2 + a1_2 * a1_2 + a2_3 * a2_3;
      n4 = sqrt(t3);
      c5 = 1.0 / (2.0 * n4);
      n20 = a0_2 / n4;
      n4inv = 1.0 / n4;
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
      c6 = 1.0 / (2.0 * n5);
      c20 = a20 / n5;
      n5inv = 1.0 / n5;
      c21 = a21 / n5;
      c22 = a22 / n5;
      e0 = p[t->diradr[i]];
      e1 = p[t->diradr[i] + 1];
      e2 = p[t->diradr[i] + 2];
      t5 = e0 * e0 + e1 * e1 + e2 * e2;
      n6 = sqrt(t5);
      c7 = 1.0 / (2.0 * n6);
      m0 = e0 / n6;
      n6inv = 1.0 / n6;
      m1 = e1 / n6;
      m2 = e2 / n6;
      c3 = n20 * m0 + n21 * m1 + n22 * m2;
      s20 = n21 * m2 - n22 * m1;
      s21 = n22 * m0 - n20 * m2;
      s22 = n20 * m1 - n21 * m0;
      t6 = 1.0 + c3;
      f = (s20 * c20 + s21 * c21 + s22 * c22) / t6;
      t6inv = 1.0 / t6;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double a0_2d, a1_2d, a20d, a21d, a22d, a2_3d, c20d, c21d, c22d, c3d, e0d, e1d, e2d, fd, m0d,
            m1d, m2d, n20d, n21d, n22d, n4d, n5d, n6d, s20d, s21d, s22d, sd, sv0d, sv1d, sv2d, t3d,
            t4d, t5d, t6d;

        a0_2d = pd[t->diraux[i]][nd];
        a1_2d = pd[t->diraux[i] + 1][nd];
        a2_3d = pd[t->diraux[i] + 2][nd];
        t3d = a0_2d * a0_2 + a0_2 * a0_2d + (a1_2d * a1_2 + a1_2 * a1_2d) + (a2_3d * a2_3 + a2_3 *
            a2_3d);
        n4d = c5 * t3d;
        n20d = (a0_2d - n20 * n4d) * n4inv;
        n21d = (a1_2d - n21 * n4d) * n4inv;
        n22d = (a2_3d - n22 * n4d) * n4inv;
        /* the part of w across the unit vector n, made a unit vector */
        sd = w0 * n20d + w1 * n21d + w2 * n22d;
        a20d = -(sd * n20 + s * n20d);
        a21d = -(sd * n21 + s * n21d);
        a22d = -(sd * n22 + s * n22d);
        t4d = a20d * a20 + a20 * a20d + (a21d * a21 + a21 * a21d) + (a22d * a22 + a22 * a22d);
        n5d = c6 * t4d;
        c20d = (a20d - c20 * n5d) * n5inv;
        c21d = (a21d - c21 * n5d) * n5inv;
        c22d = (a22d - c22 * n5d) * n5inv;
        e0d = pd[t->diradr[i]][nd];
        e1d = pd[t->diradr[i] + 1][nd];
        e2d = pd[t->diradr[i] + 2][nd];
        t5d = e0d * e0 + e0 * e0d + (e1d * e1 + e1 * e1d) + (e2d * e2 + e2 * e2d);
        n6d = c7 * t5d;
        m0d = (e0d - m0 * n6d) * n6inv;
        m1d = (e1d - m1 * n6d) * n6inv;
        m2d = (e2d - m2 * n6d) * n6inv;
        /* v turned by the smallest turn that takes the unit vector n to the unit vector m:
         *   c v + s × v + s (s.v) / (1 + c),  c = n.m,  s = n × m */
        c3d = n20d * m0 + n20 * m0d + (n21d * m1 + n21 * m1d) + (n22d * m2 + n22 * m2d);
        s20d = n21d * m2 + n21 * m2d - (n22d * m1 + n22 * m1d);
        s21d = n22d * m0 + n22 * m0d - (n20d * m2 + n20 * m2d);
        s22d = n20d * m1 + n20 * m1d - (n21d * m0 + n21 * m0d);
        sv0d = s21d * c22 + s21 * c22d - (s22d * c21 + s22 * c21d);
        sv1d = s22d * c20 + s22 * c20d - (s20d * c22 + s20 * c22d);
        sv2d = s20d * c21 + s20 * c21d - (s21d * c20 + s21 * c20d);
        t6d = c3d;
        fd = (s20d * c20 + s20 * c20d + (s21d * c21 + s21 * c21d) + (s22d * c22 + s22 * c22d) - f *
            t6d) * t6inv;
        dir0d[i][0][nd] = c3d * c20 + c3 * c20d + sv0d + (fd * s20 + f * s20d);
        dir0d[i][1][nd] = c3d * c21 + c3 * c21d + sv1d + (fd * s21 + f * s21d);
        dir0d[i][2][nd] = c3d * c22 + c3 * c22d + sv2d + (fd * s22 + f * s22d);
      }
    } else {
      a0_3 = p[t->diradr[i]];
      a1_3 = p[t->diradr[i] + 1];
      a2_4 = p[t->diradr[i] + 2];
      t7 = a0_3 * a0_3 + a1_3 * a1_3 + a2_4 * a2_4;
      n7 = sqrt(t7);
      c8 = 1.0 / (2.0 * n7);
      n20_2 = a0_3 / n7;
      n7inv = 1.0 / n7;
      n21_2 = a1_3 / n7;
      n22_2 = a2_4 / n7;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double a0_3d, a1_3d, a2_4d, n7d, t7d;

        a0_3d = pd[t->diradr[i]][nd];
        a1_3d = pd[t->diradr[i] + 1][nd];
        a2_4d = pd[t->diradr[i] + 2][nd];
        t7d = a0_3d * a0_3 + a0_3 * a0_3d + (a1_3d * a1_3 + a1_3 * a1_3d) + (a2_4d * a2_4 + a2_4 *
            a2_4d);
        n7d = c8 * t7d;
        n20_2d[nd] = (a0_3d - n20_2 * n7d) * n7inv;
        n21_2d[nd] = (a1_3d - n21_2 * n7d) * n7inv;
        n22_2d[nd] = (a2_4d - n22_2 * n7d) * n7inv;
      }
      if (t->dirkind[i] == MAGGI_DIR_ACROSS || t->dirkind[i] == MAGGI_DIR_NORMAL) {
        w0_2 = p[t->diraux[i]];
        w1_2 = p[t->diraux[i] + 1];
        w2_2 = p[t->diraux[i] + 2];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          w0_2d[nd] = pd[t->diraux[i]][nd];
          w1_2d[nd] = pd[t->diraux[i] + 1][nd];
          w2_2d[nd] = pd[t->diraux[i] + 2][nd];
        }
      } else {
        w0_2 = t->diraux[i] == 0 ? 1.0 : 0.0;
        w1_2 = t->diraux[i] == 1 ? 1.0 : 0.0;
        w2_2 = t->diraux[i] == 2 ? 1.0 : 0.0;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          w0_2d[nd] = 0.0;
          w1_2d[nd] = 0.0;
          w2_2d[nd] = 0.0;
        }
      }
      s3 = w0_2 * n20_2 + w1_2 * n21_2 + w2_2 * n22_2;
      a30 = w0_2 - s3 * n20_2;
      a31 = w1_2 - s3 * n21_2;
      a32 = w2_2 - s3 * n22_2;
      t8 = a30 * a30 + a31 * a31 + a32 * a32;
      n8 = sqrt(t8);
      c9 = 1.0 / (2.0 * n8);
      c20_2 = a30 / n8;
      n8inv = 1.0 / n8;
      c21_2 = a31 / n8;
      c22_2 = a32 / n8;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double a30d, a31d, a32d, n8d, s3d, t8d;

        /* the part of w across the unit vector n, made a unit vector */
        s3d = w0_2d[nd] * n20_2 + w0_2 * n20_2d[nd] + (w1_2d[nd] * n21_2 + w1_2 * n21_2d[nd]) +
            (w2_2d[nd] * n22_2 + w2_2 * n22_2d[nd]);
        a30d = w0_2d[nd] - (s3d * n20_2 + s3 * n20_2d[nd]);
        a31d = w1_2d[nd] - (s3d * n21_2 + s3 * n21_2d[nd]);
        a32d = w2_2d[nd] - (s3d * n22_2 + s3 * n22_2d[nd]);
        t8d = a30d * a30 + a30 * a30d + (a31d * a31 + a31 * a31d) + (a32d * a32 + a32 * a32d);
        n8d = c9 * t8d;
        c20_2d[nd] = (a30d - c20_2 * n8d) * n8inv;
        c21_2d[nd] = (a31d - c21_2 * n8d) * n8inv;
        c22_2d[nd] = (a32d - c22_2 * n8d) * n8inv;
      }
      if (t->dirkind[i] == MAGGI_DIR_ACROSS || t->dirkind[i] == MAGGI_DIR_ACROSS_GLOBAL) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          dir0d[i][0][nd] = c20_2d[nd];
          dir0d[i][1][nd] = c21_2d[nd];
          dir0d[i][2][nd] = c22_2d[nd];
        }
      } else {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          dir0d[i][0][nd] = n21_2d[nd] * c22_2 + n21_2 * c22_2d[nd] - (n22_2d[nd] * c21_2 + n22_2 *
              c21_2d[nd]);
          dir0d[i][1][nd] = n22_2d[nd] * c20_2 + n22_2 * c20_2d[nd] - (n20_2d[nd] * c22_2 + n20_2 *
              c22_2d[nd]);
          dir0d[i][2][nd] = n20_2d[nd] * c21_2 + n20_2 * c21_2d[nd] - (n21_2d[nd] * c20_2 + n21_2 *
              c20_2d[nd]);
        }
      }
    }
  }
  for (i = 0; i < t->nprim; ++i) {
    if (t->primkind[i] == MAGGI_PRIM_ROD && t->primadr[i] >= 0) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        prim0d[i][nd] = pd[t->primadr[i]][nd];
      }
    } else if (t->primkind[i] == MAGGI_PRIM_ROD) {
      x = p[t->pointadr[t->primpa[i]]] - p[t->pointadr[t->primpb[i]]];
      y = p[t->pointadr[t->primpa[i]] + 1] - p[t->pointadr[t->primpb[i]] + 1];
      z = p[t->pointadr[t->primpa[i]] + 2] - p[t->pointadr[t->primpb[i]] + 2];
      c10 = 1.0 / (2.0 * prim0[i]);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t9d, xd, yd, zd;

        xd = pd[t->pointadr[t->primpa[i]]][nd] - pd[t->pointadr[t->primpb[i]]][nd];
        yd = pd[t->pointadr[t->primpa[i]] + 1][nd] - pd[t->pointadr[t->primpb[i]] + 1][nd];
        zd = pd[t->pointadr[t->primpa[i]] + 2][nd] - pd[t->pointadr[t->primpb[i]] + 2][nd];
        t9d = xd * x + x * xd + (yd * y + y * yd) + (zd * z + z * zd);
        prim0d[i][nd] = c10 * t9d;
      }
    } else if (t->primkind[i] == MAGGI_PRIM_ANGLE && t->primadr[i] == -1) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        prim0d[i][nd] = dir0d[t->primda[i]][0][nd] * dir0[t->primdb[i]][0] + dir0[t->primda[i]][0] *
            dir0d[t->primdb[i]][0][nd] + (dir0d[t->primda[i]][1][nd] * dir0[t->primdb[i]][1] +
            dir0[t->primda[i]][1] * dir0d[t->primdb[i]][1][nd]) + (dir0d[t->primda[i]][2][nd] *
            dir0[t->primdb[i]][2] + dir0[t->primda[i]][2] * dir0d[t->primdb[i]][2][nd]);
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        prim0d[i][nd] = 0.0;
      }
    }
  }
  for (i = 0; i < t->nspring; ++i) {
    x2 = p[t->pointadr[t->springpa[i]]] - p[t->pointadr[t->springpb[i]]];
    y2 = p[t->pointadr[t->springpa[i]] + 1] - p[t->pointadr[t->springpb[i]] + 1];
    z2 = p[t->pointadr[t->springpa[i]] + 2] - p[t->pointadr[t->springpb[i]] + 2];
    c11 = 1.0 / (2.0 * spring0[i]);
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double t10d, x2d, y2d, z2d;

      x2d = pd[t->pointadr[t->springpa[i]]][nd] - pd[t->pointadr[t->springpb[i]]][nd];
      y2d = pd[t->pointadr[t->springpa[i]] + 1][nd] - pd[t->pointadr[t->springpb[i]] + 1][nd];
      z2d = pd[t->pointadr[t->springpa[i]] + 2][nd] - pd[t->pointadr[t->springpb[i]] + 2][nd];
      t10d = x2d * x2 + x2 * x2d + (y2d * y2 + y2 * y2d) + (z2d * z2 + z2 * z2d);
      spring0d[i][nd] = c11 * t10d;
    }
  }
}
