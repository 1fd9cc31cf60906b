/* Tangent of core/kernel/inertia.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* bodies without inertia keep the zeros they were given at the start */
void maggi_body_inertias_d(const maggi_topo *t, const double body0[restrict t->nbody][10],
                           const double body0d[restrict t->nbody][10],
                           const double A[restrict t->nbody + 1][9],
                           const double Ad[restrict t->nbody + 1][9],
                           const double x[restrict t->nbody + 1][3],
                           const double xd[restrict t->nbody + 1][3],
                           double I[restrict t->nbody][10], double Id[restrict t->nbody][10])
{
  int i;
  double A_i0, A_i0d, A_i1, A_i1d, A_i2, A_i2d, A_i3, A_i3d, A_i4, A_i4d, A_i5, A_i5d, A_i6, A_i6d,
      A_i7, A_i7d, A_i8, A_i8d, B0, B0d, B1, B1d, B2, B2d, B3, B3d, B4, B4d, B5, B5d, B6, B6d, B7,
      B7d, B8, B8d, body0_i4, body0_i4d, body0_i5, body0_i5d, body0_i6, body0_i6d, body0_i7,
      body0_i7d, body0_i8, body0_i8d, body0_i9, body0_i9d, h00, h00d, h01, h01d, h02, h02d, h0_2,
      h0_2d, h1, h1d, h2, h2d, m, md, s0, s0d, s1, s1d, s2, s2d, x_i0, x_i0d, x_i1, x_i1d, x_i2,
      x_i2d, xsd;

  for (i = 0; i < t->nmassive; ++i) {
    m = I[t->massive[i]][0];
    /* J = A J0 A^T, h = A h0 about the joint point x, moved to P:
     *   h += m x,  J += (x.s) I - (x s^T + s x^T)/2,  s = m x + 2 A h0 */
    md = body0d[t->massive[i]][0];
    h00 = body0[t->massive[i]][1];
    h00d = body0d[t->massive[i]][1];
    h01 = body0[t->massive[i]][2];
    h01d = body0d[t->massive[i]][2];
    h02 = body0[t->massive[i]][3];
    h02d = body0d[t->massive[i]][3];
    A_i0 = A[t->massive[i]][0];
    A_i0d = Ad[t->massive[i]][0];
    A_i1 = A[t->massive[i]][1];
    A_i1d = Ad[t->massive[i]][1];
    A_i2 = A[t->massive[i]][2];
    A_i2d = Ad[t->massive[i]][2];
    h0_2 = A_i0 * h00 + A_i1 * h01 + A_i2 * h02;
    h0_2d = A_i0d * h00 + A_i0 * h00d + (A_i1d * h01 + A_i1 * h01d) + (A_i2d * h02 + A_i2 * h02d);
    A_i3 = A[t->massive[i]][3];
    A_i3d = Ad[t->massive[i]][3];
    A_i4 = A[t->massive[i]][4];
    A_i4d = Ad[t->massive[i]][4];
    A_i5 = A[t->massive[i]][5];
    A_i5d = Ad[t->massive[i]][5];
    h1 = A_i3 * h00 + A_i4 * h01 + A_i5 * h02;
    h1d = A_i3d * h00 + A_i3 * h00d + (A_i4d * h01 + A_i4 * h01d) + (A_i5d * h02 + A_i5 * h02d);
    A_i6 = A[t->massive[i]][6];
    A_i6d = Ad[t->massive[i]][6];
    A_i7 = A[t->massive[i]][7];
    A_i7d = Ad[t->massive[i]][7];
    A_i8 = A[t->massive[i]][8];
    A_i8d = Ad[t->massive[i]][8];
    h2 = A_i6 * h00 + A_i7 * h01 + A_i8 * h02;
    h2d = A_i6d * h00 + A_i6 * h00d + (A_i7d * h01 + A_i7 * h01d) + (A_i8d * h02 + A_i8 * h02d);
    x_i0 = x[t->massive[i]][0];
    x_i0d = xd[t->massive[i]][0];
    s0 = m * x_i0 + 2.0 * h0_2;
    s0d = md * x_i0 + m * x_i0d + 2.0 * h0_2d;
    x_i1 = x[t->massive[i]][1];
    x_i1d = xd[t->massive[i]][1];
    s1 = m * x_i1 + 2.0 * h1;
    s1d = md * x_i1 + m * x_i1d + 2.0 * h1d;
    x_i2 = x[t->massive[i]][2];
    x_i2d = xd[t->massive[i]][2];
    s2 = m * x_i2 + 2.0 * h2;
    s2d = md * x_i2 + m * x_i2d + 2.0 * h2d;
    xsd = x_i0d * s0 + x_i0 * s0d + (x_i1d * s1 + x_i1 * s1d) + (x_i2d * s2 + x_i2 * s2d);
    body0_i4 = body0[t->massive[i]][4];
    body0_i4d = body0d[t->massive[i]][4];
    body0_i7 = body0[t->massive[i]][7];
    body0_i7d = body0d[t->massive[i]][7];
    body0_i8 = body0[t->massive[i]][8];
    body0_i8d = body0d[t->massive[i]][8];
    B0 = A_i0 * body0_i4 + A_i1 * body0_i7 + A_i2 * body0_i8;
    B0d = A_i0d * body0_i4 + A_i0 * body0_i4d + (A_i1d * body0_i7 + A_i1 * body0_i7d) + (A_i2d *
        body0_i8 + A_i2 * body0_i8d);
    body0_i5 = body0[t->massive[i]][5];
    body0_i5d = body0d[t->massive[i]][5];
    body0_i9 = body0[t->massive[i]][9];
    body0_i9d = body0d[t->massive[i]][9];
    B1 = A_i0 * body0_i7 + A_i1 * body0_i5 + A_i2 * body0_i9;
    B1d = A_i0d * body0_i7 + A_i0 * body0_i7d + (A_i1d * body0_i5 + A_i1 * body0_i5d) + (A_i2d *
        body0_i9 + A_i2 * body0_i9d);
    body0_i6 = body0[t->massive[i]][6];
    body0_i6d = body0d[t->massive[i]][6];
    B2 = A_i0 * body0_i8 + A_i1 * body0_i9 + A_i2 * body0_i6;
    B2d = A_i0d * body0_i8 + A_i0 * body0_i8d + (A_i1d * body0_i9 + A_i1 * body0_i9d) + (A_i2d *
        body0_i6 + A_i2 * body0_i6d);
    B3 = A_i3 * body0_i4 + A_i4 * body0_i7 + A_i5 * body0_i8;
    B3d = A_i3d * body0_i4 + A_i3 * body0_i4d + (A_i4d * body0_i7 + A_i4 * body0_i7d) + (A_i5d *
        body0_i8 + A_i5 * body0_i8d);
    B4 = A_i3 * body0_i7 + A_i4 * body0_i5 + A_i5 * body0_i9;
    B4d = A_i3d * body0_i7 + A_i3 * body0_i7d + (A_i4d * body0_i5 + A_i4 * body0_i5d) + (A_i5d *
        body0_i9 + A_i5 * body0_i9d);
    B5 = A_i3 * body0_i8 + A_i4 * body0_i9 + A_i5 * body0_i6;
    B5d = A_i3d * body0_i8 + A_i3 * body0_i8d + (A_i4d * body0_i9 + A_i4 * body0_i9d) + (A_i5d *
        body0_i6 + A_i5 * body0_i6d);
    B6 = A_i6 * body0_i4 + A_i7 * body0_i7 + A_i8 * body0_i8;
    B6d = A_i6d * body0_i4 + A_i6 * body0_i4d + (A_i7d * body0_i7 + A_i7 * body0_i7d) + (A_i8d *
        body0_i8 + A_i8 * body0_i8d);
    B7 = A_i6 * body0_i7 + A_i7 * body0_i5 + A_i8 * body0_i9;
    B7d = A_i6d * body0_i7 + A_i6 * body0_i7d + (A_i7d * body0_i5 + A_i7 * body0_i5d) + (A_i8d *
        body0_i9 + A_i8 * body0_i9d);
    B8 = A_i6 * body0_i8 + A_i7 * body0_i9 + A_i8 * body0_i6;
    B8d = A_i6d * body0_i8 + A_i6 * body0_i8d + (A_i7d * body0_i9 + A_i7 * body0_i9d) + (A_i8d *
        body0_i6 + A_i8 * body0_i6d);
    Id[t->massive[i]][0] = md;
    Id[t->massive[i]][1] = h0_2d + (md * x_i0 + m * x_i0d);
    Id[t->massive[i]][2] = h1d + (md * x_i1 + m * x_i1d);
    Id[t->massive[i]][3] = h2d + (md * x_i2 + m * x_i2d);
    Id[t->massive[i]][4] = B0d * A_i0 + B0 * A_i0d + (B1d * A_i1 + B1 * A_i1d) + (B2d * A_i2 + B2 *
        A_i2d) + xsd - (x_i0d * s0 + x_i0 * s0d);
    Id[t->massive[i]][5] = B3d * A_i3 + B3 * A_i3d + (B4d * A_i4 + B4 * A_i4d) + (B5d * A_i5 + B5 *
        A_i5d) + xsd - (x_i1d * s1 + x_i1 * s1d);
    Id[t->massive[i]][6] = B6d * A_i6 + B6 * A_i6d + (B7d * A_i7 + B7 * A_i7d) + (B8d * A_i8 + B8 *
        A_i8d) + xsd - (x_i2d * s2 + x_i2 * s2d);
    Id[t->massive[i]][7] = B0d * A_i3 + B0 * A_i3d + (B1d * A_i4 + B1 * A_i4d) + (B2d * A_i5 + B2 *
        A_i5d) - 0.5 * (x_i0d * s1 + x_i0 * s1d + (x_i1d * s0 + x_i1 * s0d));
    Id[t->massive[i]][8] = B0d * A_i6 + B0 * A_i6d + (B1d * A_i7 + B1 * A_i7d) + (B2d * A_i8 + B2 *
        A_i8d) - 0.5 * (x_i0d * s2 + x_i0 * s2d + (x_i2d * s0 + x_i2 * s0d));
    Id[t->massive[i]][9] = B3d * A_i6 + B3 * A_i6d + (B4d * A_i7 + B4 * A_i7d) + (B5d * A_i8 + B5 *
        A_i8d) - 0.5 * (x_i1d * s2 + x_i1 * s2d + (x_i2d * s1 + x_i2 * s1d));
  }
}

/* bodies without inertia keep the zeros they were given at the start; rods and loops add to the ground */
void maggi_inertia_forces_d(const maggi_topo *t, const double I[restrict t->nbody][10],
                            const double Id[restrict t->nbody][10],
                            const double Z[restrict t->nbody + 1][6],
                            const double Zd[restrict t->nbody + 1][6],
                            const double Za[restrict t->nbody + 1][6],
                            const double Zad[restrict t->nbody + 1][6],
                            double F[restrict t->nbody + 1][6], double Fd[restrict t->nbody + 1][6])
{
  int i, k;
  double D0d, D1d, D2d, D3d, D4d, D5d, H0, H0d, H1, H1d, H2, H2d, H3, H3d, H4, H4d, H5, H5d, I_i0,
      I_i0d, I_i1, I_i1d, I_i2, I_i2d, I_i3, I_i3d, I_i4, I_i4d, I_i5, I_i5d, I_i6, I_i6d, I_i7,
      I_i7d, I_i8, I_i8d, I_i9, I_i9d, Z_i0, Z_i0d, Z_i1, Z_i1d, Z_i2, Z_i2d, Z_i3, Z_i3d, Z_i4,
      Z_i4d, Z_i5, Z_i5d, Za_i0, Za_i0d, Za_i1, Za_i1d, Za_i2, Za_i2d, Za_i3, Za_i3d, Za_i4, Za_i4d,
      Za_i5, Za_i5d;

  (void)F;
  for (k = 0; k < 6; ++k) {
    Fd[t->nbody][k] = 0.0;
  }
  for (i = 0; i < t->nmassive; ++i) {
    I_i0 = I[t->massive[i]][0];
    I_i0d = Id[t->massive[i]][0];
    Z_i0 = Z[t->massive[i]][0];
    Z_i0d = Zd[t->massive[i]][0];
    Z_i4 = Z[t->massive[i]][4];
    Z_i4d = Zd[t->massive[i]][4];
    I_i3 = I[t->massive[i]][3];
    I_i3d = Id[t->massive[i]][3];
    Z_i5 = Z[t->massive[i]][5];
    Z_i5d = Zd[t->massive[i]][5];
    I_i2 = I[t->massive[i]][2];
    I_i2d = Id[t->massive[i]][2];
    H0 = I_i0 * Z_i0 + Z_i4 * I_i3 - Z_i5 * I_i2;
    /* minus d/dt of the momentum H = I Z about the fixed P:
     *   F = I Z' + (w × H_lin, w × H_ang + s × H_lin) */
    H0d = I_i0d * Z_i0 + I_i0 * Z_i0d + (Z_i4d * I_i3 + Z_i4 * I_i3d) - (Z_i5d * I_i2 + Z_i5 *
        I_i2d);
    Z_i1 = Z[t->massive[i]][1];
    Z_i1d = Zd[t->massive[i]][1];
    I_i1 = I[t->massive[i]][1];
    I_i1d = Id[t->massive[i]][1];
    Z_i3 = Z[t->massive[i]][3];
    Z_i3d = Zd[t->massive[i]][3];
    H1 = I_i0 * Z_i1 + Z_i5 * I_i1 - Z_i3 * I_i3;
    H1d = I_i0d * Z_i1 + I_i0 * Z_i1d + (Z_i5d * I_i1 + Z_i5 * I_i1d) - (Z_i3d * I_i3 + Z_i3 *
        I_i3d);
    Z_i2 = Z[t->massive[i]][2];
    Z_i2d = Zd[t->massive[i]][2];
    H2 = I_i0 * Z_i2 + Z_i3 * I_i2 - Z_i4 * I_i1;
    H2d = I_i0d * Z_i2 + I_i0 * Z_i2d + (Z_i3d * I_i2 + Z_i3 * I_i2d) - (Z_i4d * I_i1 + Z_i4 *
        I_i1d);
    I_i4 = I[t->massive[i]][4];
    I_i4d = Id[t->massive[i]][4];
    I_i7 = I[t->massive[i]][7];
    I_i7d = Id[t->massive[i]][7];
    I_i8 = I[t->massive[i]][8];
    I_i8d = Id[t->massive[i]][8];
    H3 = I_i2 * Z_i2 - I_i3 * Z_i1 + I_i4 * Z_i3 + I_i7 * Z_i4 + I_i8 * Z_i5;
    H3d = I_i2d * Z_i2 + I_i2 * Z_i2d - (I_i3d * Z_i1 + I_i3 * Z_i1d) + (I_i4d * Z_i3 + I_i4 *
        Z_i3d) + (I_i7d * Z_i4 + I_i7 * Z_i4d) + (I_i8d * Z_i5 + I_i8 * Z_i5d);
    I_i5 = I[t->massive[i]][5];
    I_i5d = Id[t->massive[i]][5];
    I_i9 = I[t->massive[i]][9];
    I_i9d = Id[t->massive[i]][9];
    H4 = I_i3 * Z_i0 - I_i1 * Z_i2 + I_i7 * Z_i3 + I_i5 * Z_i4 + I_i9 * Z_i5;
    H4d = I_i3d * Z_i0 + I_i3 * Z_i0d - (I_i1d * Z_i2 + I_i1 * Z_i2d) + (I_i7d * Z_i3 + I_i7 *
        Z_i3d) + (I_i5d * Z_i4 + I_i5 * Z_i4d) + (I_i9d * Z_i5 + I_i9 * Z_i5d);
    I_i6 = I[t->massive[i]][6];
    I_i6d = Id[t->massive[i]][6];
    H5 = I_i1 * Z_i1 - I_i2 * Z_i0 + I_i8 * Z_i3 + I_i9 * Z_i4 + I_i6 * Z_i5;
    H5d = I_i1d * Z_i1 + I_i1 * Z_i1d - (I_i2d * Z_i0 + I_i2 * Z_i0d) + (I_i8d * Z_i3 + I_i8 *
        Z_i3d) + (I_i9d * Z_i4 + I_i9 * Z_i4d) + (I_i6d * Z_i5 + I_i6 * Z_i5d);
    Za_i0 = Za[t->massive[i]][0];
    Za_i0d = Zad[t->massive[i]][0];
    Za_i4 = Za[t->massive[i]][4];
    Za_i4d = Zad[t->massive[i]][4];
    Za_i5 = Za[t->massive[i]][5];
    Za_i5d = Zad[t->massive[i]][5];
    D0d = I_i0d * Za_i0 + I_i0 * Za_i0d + (Za_i4d * I_i3 + Za_i4 * I_i3d) - (Za_i5d * I_i2 + Za_i5 *
        I_i2d);
    Za_i1 = Za[t->massive[i]][1];
    Za_i1d = Zad[t->massive[i]][1];
    Za_i3 = Za[t->massive[i]][3];
    Za_i3d = Zad[t->massive[i]][3];
    D1d = I_i0d * Za_i1 + I_i0 * Za_i1d + (Za_i5d * I_i1 + Za_i5 * I_i1d) - (Za_i3d * I_i3 + Za_i3 *
        I_i3d);
    Za_i2 = Za[t->massive[i]][2];
    Za_i2d = Zad[t->massive[i]][2];
    D2d = I_i0d * Za_i2 + I_i0 * Za_i2d + (Za_i3d * I_i2 + Za_i3 * I_i2d) - (Za_i4d * I_i1 + Za_i4 *
        I_i1d);
    D3d = I_i2d * Za_i2 + I_i2 * Za_i2d - (I_i3d * Za_i1 + I_i3 * Za_i1d) + (I_i4d * Za_i3 + I_i4 *
        Za_i3d) + (I_i7d * Za_i4 + I_i7 * Za_i4d) + (I_i8d * Za_i5 + I_i8 * Za_i5d);
    D4d = I_i3d * Za_i0 + I_i3 * Za_i0d - (I_i1d * Za_i2 + I_i1 * Za_i2d) + (I_i7d * Za_i3 + I_i7 *
        Za_i3d) + (I_i5d * Za_i4 + I_i5 * Za_i4d) + (I_i9d * Za_i5 + I_i9 * Za_i5d);
    D5d = I_i1d * Za_i1 + I_i1 * Za_i1d - (I_i2d * Za_i0 + I_i2 * Za_i0d) + (I_i8d * Za_i3 + I_i8 *
        Za_i3d) + (I_i9d * Za_i4 + I_i9 * Za_i4d) + (I_i6d * Za_i5 + I_i6 * Za_i5d);
    Fd[t->massive[i]][0] = -D0d - (Z_i4d * H2 + Z_i4 * H2d - (Z_i5d * H1 + Z_i5 * H1d));
    Fd[t->massive[i]][1] = -D1d - (Z_i5d * H0 + Z_i5 * H0d - (Z_i3d * H2 + Z_i3 * H2d));
    Fd[t->massive[i]][2] = -D2d - (Z_i3d * H1 + Z_i3 * H1d - (Z_i4d * H0 + Z_i4 * H0d));
    Fd[t->massive[i]][3] = -D3d - (Z_i4d * H5 + Z_i4 * H5d - (Z_i5d * H4 + Z_i5 * H4d) + (Z_i1d * H2
        + Z_i1 * H2d) - (Z_i2d * H1 + Z_i2 * H1d));
    Fd[t->massive[i]][4] = -D4d - (Z_i5d * H3 + Z_i5 * H3d - (Z_i3d * H5 + Z_i3 * H5d) + (Z_i2d * H0
        + Z_i2 * H0d) - (Z_i0d * H2 + Z_i0 * H2d));
    Fd[t->massive[i]][5] = -D5d - (Z_i3d * H4 + Z_i3 * H4d - (Z_i4d * H3 + Z_i4 * H3d) + (Z_i0d * H1
        + Z_i0 * H1d) - (Z_i1d * H0 + Z_i1 * H0d));
  }
}

/* rods: -m a_b / 6 at end a and -m a_a / 6 at end b; the thirds are point masses of the bodies */
void maggi_rod_forces_d(const maggi_topo *t, const double p[restrict t->np],
                        const double pd[restrict t->np], const double r[restrict t->npoint][3],
                        const double rd[restrict t->npoint][3],
                        const double ra[restrict t->npoint][3],
                        const double rad[restrict t->npoint][3], double F[restrict t->nbody + 1][6],
                        double Fd[restrict t->nbody + 1][6])
{
  int a, b, i;
  double f0, f0d, f1, f1d, f20, f20d, f21, f21d, f22, f22d, f2_2, f2_2d, p_i, p_id;

  (void)F;
  for (i = 0; i < t->nrod; ++i) {
    a = t->rodpa[i];
    b = t->rodpb[i];
    p_i = p[t->rodadr[i]];
    p_id = pd[t->rodadr[i]];
    f0 = -p_i / 6.0 * ra[b][0];
    f0d = -(p_id / 6.0 * ra[b][0]) + -p_i / 6.0 * rad[b][0];
    f1 = -p_i / 6.0 * ra[b][1];
    f1d = -(p_id / 6.0 * ra[b][1]) + -p_i / 6.0 * rad[b][1];
    f2_2 = -p_i / 6.0 * ra[b][2];
    f2_2d = -(p_id / 6.0 * ra[b][2]) + -p_i / 6.0 * rad[b][2];
    Fd[t->pointbody[a]][0] += f0d;
    Fd[t->pointbody[a]][1] += f1d;
    Fd[t->pointbody[a]][2] += f2_2d;
    Fd[t->pointbody[a]][3] += rd[a][1] * f2_2 + r[a][1] * f2_2d - (rd[a][2] * f1 + r[a][2] * f1d);
    Fd[t->pointbody[a]][4] += rd[a][2] * f0 + r[a][2] * f0d - (rd[a][0] * f2_2 + r[a][0] * f2_2d);
    Fd[t->pointbody[a]][5] += rd[a][0] * f1 + r[a][0] * f1d - (rd[a][1] * f0 + r[a][1] * f0d);
    f20 = -p_i / 6.0 * ra[a][0];
    f20d = -(p_id / 6.0 * ra[a][0]) + -p_i / 6.0 * rad[a][0];
    f21 = -p_i / 6.0 * ra[a][1];
    f21d = -(p_id / 6.0 * ra[a][1]) + -p_i / 6.0 * rad[a][1];
    f22 = -p_i / 6.0 * ra[a][2];
    f22d = -(p_id / 6.0 * ra[a][2]) + -p_i / 6.0 * rad[a][2];
    Fd[t->pointbody[b]][0] += f20d;
    Fd[t->pointbody[b]][1] += f21d;
    Fd[t->pointbody[b]][2] += f22d;
    Fd[t->pointbody[b]][3] += rd[b][1] * f22 + r[b][1] * f22d - (rd[b][2] * f21 + r[b][2] * f21d);
    Fd[t->pointbody[b]][4] += rd[b][2] * f20 + r[b][2] * f20d - (rd[b][0] * f22 + r[b][0] * f22d);
    Fd[t->pointbody[b]][5] += rd[b][0] * f21 + r[b][0] * f21d - (rd[b][1] * f20 + r[b][1] * f20d);
  }
}

/* FS_i = F_i + Q_i + sum over children */
void maggi_accumulate_d(const maggi_topo *t, const double F[restrict t->nbody + 1][6],
                        const double Fd[restrict t->nbody + 1][6],
                        const double Q[restrict t->nbody + 1][6],
                        const double Qd[restrict t->nbody + 1][6],
                        double FS[restrict t->nbody + 1][6], double FSd[restrict t->nbody + 1][6])
{
  int i, k, k2;

  (void)F;
  (void)Q;
  (void)FS;
  for (i = 0; i <= t->nbody; ++i) {
    for (k = 0; k < 6; ++k) {
      FSd[i][k] = Fd[i][k] + Qd[i][k];
    }
  }
  for (i = 0; i < t->nbody; ++i) {
    for (k2 = 0; k2 < 6; ++k2) {
      FSd[t->parent[i]][k2] += FSd[i][k2];
    }
  }
}
