/* Adjoint of core/kernel/inertia.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* bodies without inertia keep the zeros they were given at the start */
void maggi_body_inertias_b(const maggi_topo *t, const double body0[restrict t->nbody][10],
                           double body0b[restrict t->nbody][10],
                           const double A[restrict t->nbody + 1][9],
                           double Ab[restrict t->nbody + 1][9],
                           const double x[restrict t->nbody + 1][3],
                           double xb[restrict t->nbody + 1][3], double I[restrict t->nbody][10],
                           double Ib[restrict t->nbody][10])
{
  int i;
  double A_i0, A_i0b, A_i1, A_i1b, A_i2, A_i2b, A_i3, A_i3b, A_i4, A_i4b, A_i5, A_i5b, A_i6, A_i6b,
      A_i7, A_i7b, A_i8, A_i8b, B0, B0b, B1, B1b, B2, B2b, B3, B3b, B4, B4b, B5, B5b, B6, B6b, B7,
      B7b, B8, B8b, body0_i4, body0_i4b, body0_i5, body0_i5b, body0_i6, body0_i6b, body0_i7,
      body0_i7b, body0_i8, body0_i8b, body0_i9, body0_i9b, h00, h00b, h01, h01b, h02, h02b, h0_2,
      h0_2b, h1, h1b, h2, h2b, m, mb, s0, s0b, s1, s1b, s2, s2b, tb10, tb11, tb12, tb13, tb2, tb3,
      tb4, tb5, tb6, tb7, tb8, tb9, x_i0, x_i0b, x_i1, x_i1b, x_i2, x_i2b, xsb;

  for (i = t->nmassive - 1; i >= 0; --i) {
    m = I[t->massive[i]][0];
    h00 = body0[t->massive[i]][1];
    h01 = body0[t->massive[i]][2];
    h02 = body0[t->massive[i]][3];
    A_i0 = A[t->massive[i]][0];
    A_i1 = A[t->massive[i]][1];
    A_i2 = A[t->massive[i]][2];
    h0_2 = A_i0 * h00 + A_i1 * h01 + A_i2 * h02;
    A_i3 = A[t->massive[i]][3];
    A_i4 = A[t->massive[i]][4];
    A_i5 = A[t->massive[i]][5];
    h1 = A_i3 * h00 + A_i4 * h01 + A_i5 * h02;
    A_i6 = A[t->massive[i]][6];
    A_i7 = A[t->massive[i]][7];
    A_i8 = A[t->massive[i]][8];
    h2 = A_i6 * h00 + A_i7 * h01 + A_i8 * h02;
    x_i0 = x[t->massive[i]][0];
    s0 = m * x_i0 + 2.0 * h0_2;
    x_i1 = x[t->massive[i]][1];
    s1 = m * x_i1 + 2.0 * h1;
    x_i2 = x[t->massive[i]][2];
    s2 = m * x_i2 + 2.0 * h2;
    body0_i4 = body0[t->massive[i]][4];
    body0_i7 = body0[t->massive[i]][7];
    body0_i8 = body0[t->massive[i]][8];
    B0 = A_i0 * body0_i4 + A_i1 * body0_i7 + A_i2 * body0_i8;
    body0_i5 = body0[t->massive[i]][5];
    body0_i9 = body0[t->massive[i]][9];
    B1 = A_i0 * body0_i7 + A_i1 * body0_i5 + A_i2 * body0_i9;
    body0_i6 = body0[t->massive[i]][6];
    B2 = A_i0 * body0_i8 + A_i1 * body0_i9 + A_i2 * body0_i6;
    B3 = A_i3 * body0_i4 + A_i4 * body0_i7 + A_i5 * body0_i8;
    B4 = A_i3 * body0_i7 + A_i4 * body0_i5 + A_i5 * body0_i9;
    B5 = A_i3 * body0_i8 + A_i4 * body0_i9 + A_i5 * body0_i6;
    B6 = A_i6 * body0_i4 + A_i7 * body0_i7 + A_i8 * body0_i8;
    B7 = A_i6 * body0_i7 + A_i7 * body0_i5 + A_i8 * body0_i9;
    B8 = A_i6 * body0_i8 + A_i7 * body0_i9 + A_i8 * body0_i6;
    tb12 = Ib[t->massive[i]][9];
    Ib[t->massive[i]][9] = 0.0;
    B3b = tb12 * A_i6;
    A_i6b = tb12 * B3;
    B4b = tb12 * A_i7;
    A_i7b = tb12 * B4;
    B5b = tb12 * A_i8;
    A_i8b = tb12 * B5;
    tb13 = tb12 * 0.5;
    x_i1b = -(tb13 * s2);
    s2b = -(tb13 * x_i1);
    x_i2b = -(tb13 * s1);
    s1b = -(tb13 * x_i2);
    tb10 = Ib[t->massive[i]][8];
    Ib[t->massive[i]][8] = 0.0;
    B0b = tb10 * A_i6;
    A_i6b += tb10 * B0;
    B1b = tb10 * A_i7;
    A_i7b += tb10 * B1;
    B2b = tb10 * A_i8;
    A_i8b += tb10 * B2;
    tb11 = tb10 * 0.5;
    x_i0b = -(tb11 * s2);
    s2b -= tb11 * x_i0;
    x_i2b -= tb11 * s0;
    s0b = -(tb11 * x_i2);
    tb8 = Ib[t->massive[i]][7];
    Ib[t->massive[i]][7] = 0.0;
    B0b += tb8 * A_i3;
    A_i3b = tb8 * B0;
    B1b += tb8 * A_i4;
    A_i4b = tb8 * B1;
    B2b += tb8 * A_i5;
    A_i5b = tb8 * B2;
    tb9 = tb8 * 0.5;
    x_i0b -= tb9 * s1;
    s1b -= tb9 * x_i0;
    x_i1b -= tb9 * s0;
    s0b -= tb9 * x_i1;
    tb7 = Ib[t->massive[i]][6];
    Ib[t->massive[i]][6] = 0.0;
    B6b = tb7 * A_i6;
    A_i6b += tb7 * B6;
    B7b = tb7 * A_i7;
    A_i7b += tb7 * B7;
    B8b = tb7 * A_i8;
    A_i8b += tb7 * B8;
    xsb = tb7;
    x_i2b -= tb7 * s2;
    s2b -= tb7 * x_i2;
    tb6 = Ib[t->massive[i]][5];
    Ib[t->massive[i]][5] = 0.0;
    B3b += tb6 * A_i3;
    A_i3b += tb6 * B3;
    B4b += tb6 * A_i4;
    A_i4b += tb6 * B4;
    B5b += tb6 * A_i5;
    A_i5b += tb6 * B5;
    xsb += tb6;
    x_i1b -= tb6 * s1;
    s1b -= tb6 * x_i1;
    tb5 = Ib[t->massive[i]][4];
    Ib[t->massive[i]][4] = 0.0;
    B0b += tb5 * A_i0;
    A_i0b = tb5 * B0;
    B1b += tb5 * A_i1;
    A_i1b = tb5 * B1;
    B2b += tb5 * A_i2;
    A_i2b = tb5 * B2;
    xsb += tb5;
    x_i0b -= tb5 * s0;
    s0b -= tb5 * x_i0;
    tb4 = Ib[t->massive[i]][3];
    Ib[t->massive[i]][3] = 0.0;
    h2b = tb4;
    mb = tb4 * x_i2;
    x_i2b += tb4 * m;
    tb3 = Ib[t->massive[i]][2];
    Ib[t->massive[i]][2] = 0.0;
    h1b = tb3;
    mb += tb3 * x_i1;
    x_i1b += tb3 * m;
    tb2 = Ib[t->massive[i]][1];
    Ib[t->massive[i]][1] = 0.0;
    h0_2b = tb2;
    mb += tb2 * x_i0;
    x_i0b += tb2 * m;
    mb += Ib[t->massive[i]][0];
    Ib[t->massive[i]][0] = 0.0;
    A_i6b += B8b * body0_i8;
    body0_i8b = B8b * A_i6;
    A_i7b += B8b * body0_i9;
    body0_i9b = B8b * A_i7;
    A_i8b += B8b * body0_i6;
    body0_i6b = B8b * A_i8;
    A_i6b += B7b * body0_i7;
    body0_i7b = B7b * A_i6;
    A_i7b += B7b * body0_i5;
    body0_i5b = B7b * A_i7;
    A_i8b += B7b * body0_i9;
    body0_i9b += B7b * A_i8;
    A_i6b += B6b * body0_i4;
    body0_i4b = B6b * A_i6;
    A_i7b += B6b * body0_i7;
    body0_i7b += B6b * A_i7;
    A_i8b += B6b * body0_i8;
    body0_i8b += B6b * A_i8;
    A_i3b += B5b * body0_i8;
    body0_i8b += B5b * A_i3;
    A_i4b += B5b * body0_i9;
    body0_i9b += B5b * A_i4;
    A_i5b += B5b * body0_i6;
    body0_i6b += B5b * A_i5;
    A_i3b += B4b * body0_i7;
    body0_i7b += B4b * A_i3;
    A_i4b += B4b * body0_i5;
    body0_i5b += B4b * A_i4;
    A_i5b += B4b * body0_i9;
    body0_i9b += B4b * A_i5;
    A_i3b += B3b * body0_i4;
    body0_i4b += B3b * A_i3;
    A_i4b += B3b * body0_i7;
    body0_i7b += B3b * A_i4;
    A_i5b += B3b * body0_i8;
    body0_i8b += B3b * A_i5;
    A_i0b += B2b * body0_i8;
    body0_i8b += B2b * A_i0;
    A_i1b += B2b * body0_i9;
    body0_i9b += B2b * A_i1;
    A_i2b += B2b * body0_i6;
    body0_i6b += B2b * A_i2;
    body0b[t->massive[i]][6] += body0_i6b;
    A_i0b += B1b * body0_i7;
    body0_i7b += B1b * A_i0;
    A_i1b += B1b * body0_i5;
    body0_i5b += B1b * A_i1;
    A_i2b += B1b * body0_i9;
    body0_i9b += B1b * A_i2;
    body0b[t->massive[i]][9] += body0_i9b;
    body0b[t->massive[i]][5] += body0_i5b;
    A_i0b += B0b * body0_i4;
    body0_i4b += B0b * A_i0;
    A_i1b += B0b * body0_i7;
    body0_i7b += B0b * A_i1;
    A_i2b += B0b * body0_i8;
    body0_i8b += B0b * A_i2;
    body0b[t->massive[i]][8] += body0_i8b;
    body0b[t->massive[i]][7] += body0_i7b;
    body0b[t->massive[i]][4] += body0_i4b;
    x_i0b += xsb * s0;
    s0b += xsb * x_i0;
    x_i1b += xsb * s1;
    s1b += xsb * x_i1;
    x_i2b += xsb * s2;
    s2b += xsb * x_i2;
    mb += s2b * x_i2;
    x_i2b += s2b * m;
    h2b += s2b * 2.0;
    xb[t->massive[i]][2] += x_i2b;
    mb += s1b * x_i1;
    x_i1b += s1b * m;
    h1b += s1b * 2.0;
    xb[t->massive[i]][1] += x_i1b;
    mb += s0b * x_i0;
    x_i0b += s0b * m;
    h0_2b += s0b * 2.0;
    xb[t->massive[i]][0] += x_i0b;
    A_i6b += h2b * h00;
    h00b = h2b * A_i6;
    A_i7b += h2b * h01;
    h01b = h2b * A_i7;
    A_i8b += h2b * h02;
    h02b = h2b * A_i8;
    Ab[t->massive[i]][8] += A_i8b;
    Ab[t->massive[i]][7] += A_i7b;
    Ab[t->massive[i]][6] += A_i6b;
    A_i3b += h1b * h00;
    h00b += h1b * A_i3;
    A_i4b += h1b * h01;
    h01b += h1b * A_i4;
    A_i5b += h1b * h02;
    h02b += h1b * A_i5;
    Ab[t->massive[i]][5] += A_i5b;
    Ab[t->massive[i]][4] += A_i4b;
    Ab[t->massive[i]][3] += A_i3b;
    A_i0b += h0_2b * h00;
    h00b += h0_2b * A_i0;
    A_i1b += h0_2b * h01;
    h01b += h0_2b * A_i1;
    A_i2b += h0_2b * h02;
    h02b += h0_2b * A_i2;
    Ab[t->massive[i]][2] += A_i2b;
    Ab[t->massive[i]][1] += A_i1b;
    Ab[t->massive[i]][0] += A_i0b;
    body0b[t->massive[i]][3] += h02b;
    body0b[t->massive[i]][2] += h01b;
    body0b[t->massive[i]][1] += h00b;
    /* J = A J0 A^T, h = A h0 about the joint point x, moved to P:
     *   h += m x,  J += (x.s) I - (x s^T + s x^T)/2,  s = m x + 2 A h0 */
    body0b[t->massive[i]][0] += mb;
  }
}

/* bodies without inertia keep the zeros they were given at the start; rods and loops add to the ground */
void maggi_inertia_forces_b(const maggi_topo *t, const double I[restrict t->nbody][10],
                            double Ib[restrict t->nbody][10],
                            const double Z[restrict t->nbody + 1][6],
                            double Zb[restrict t->nbody + 1][6],
                            const double Za[restrict t->nbody + 1][6],
                            double Zab[restrict t->nbody + 1][6],
                            double F[restrict t->nbody + 1][6], double Fb[restrict t->nbody + 1][6])
{
  int i, k;
  double D0b, D1b, D2b, D3b, D4b, D5b, H0, H0b, H1, H1b, H2, H2b, H3, H3b, H4, H4b, H5, H5b, I_i0,
      I_i0b, I_i1, I_i1b, I_i2, I_i2b, I_i3, I_i3b, I_i4, I_i4b, I_i5, I_i5b, I_i6, I_i6b, I_i7,
      I_i7b, I_i8, I_i8b, I_i9, I_i9b, Z_i0, Z_i0b, Z_i1, Z_i1b, Z_i2, Z_i2b, Z_i3, Z_i3b, Z_i4,
      Z_i4b, Z_i5, Z_i5b, Za_i0, Za_i0b, Za_i1, Za_i1b, Za_i2, Za_i2b, Za_i3, Za_i3b, Za_i4, Za_i4b,
      Za_i5, Za_i5b, tb2, tb3, tb4, tb5, tb6, tb7;

  (void)F;
  for (i = t->nmassive - 1; i >= 0; --i) {
    I_i0 = I[t->massive[i]][0];
    Z_i0 = Z[t->massive[i]][0];
    Z_i4 = Z[t->massive[i]][4];
    I_i3 = I[t->massive[i]][3];
    Z_i5 = Z[t->massive[i]][5];
    I_i2 = I[t->massive[i]][2];
    H0 = I_i0 * Z_i0 + Z_i4 * I_i3 - Z_i5 * I_i2;
    Z_i1 = Z[t->massive[i]][1];
    I_i1 = I[t->massive[i]][1];
    Z_i3 = Z[t->massive[i]][3];
    H1 = I_i0 * Z_i1 + Z_i5 * I_i1 - Z_i3 * I_i3;
    Z_i2 = Z[t->massive[i]][2];
    H2 = I_i0 * Z_i2 + Z_i3 * I_i2 - Z_i4 * I_i1;
    I_i4 = I[t->massive[i]][4];
    I_i7 = I[t->massive[i]][7];
    I_i8 = I[t->massive[i]][8];
    H3 = I_i2 * Z_i2 - I_i3 * Z_i1 + I_i4 * Z_i3 + I_i7 * Z_i4 + I_i8 * Z_i5;
    I_i5 = I[t->massive[i]][5];
    I_i9 = I[t->massive[i]][9];
    H4 = I_i3 * Z_i0 - I_i1 * Z_i2 + I_i7 * Z_i3 + I_i5 * Z_i4 + I_i9 * Z_i5;
    I_i6 = I[t->massive[i]][6];
    H5 = I_i1 * Z_i1 - I_i2 * Z_i0 + I_i8 * Z_i3 + I_i9 * Z_i4 + I_i6 * Z_i5;
    Za_i0 = Za[t->massive[i]][0];
    Za_i4 = Za[t->massive[i]][4];
    Za_i5 = Za[t->massive[i]][5];
    Za_i1 = Za[t->massive[i]][1];
    Za_i3 = Za[t->massive[i]][3];
    Za_i2 = Za[t->massive[i]][2];
    tb7 = Fb[t->massive[i]][5];
    Fb[t->massive[i]][5] = 0.0;
    D5b = -tb7;
    Z_i3b = -(tb7 * H4);
    H4b = -(tb7 * Z_i3);
    Z_i4b = tb7 * H3;
    H3b = tb7 * Z_i4;
    Z_i0b = -(tb7 * H1);
    H1b = -(tb7 * Z_i0);
    Z_i1b = tb7 * H0;
    H0b = tb7 * Z_i1;
    tb6 = Fb[t->massive[i]][4];
    Fb[t->massive[i]][4] = 0.0;
    D4b = -tb6;
    Z_i5b = -(tb6 * H3);
    H3b -= tb6 * Z_i5;
    Z_i3b += tb6 * H5;
    H5b = tb6 * Z_i3;
    Z_i2b = -(tb6 * H0);
    H0b -= tb6 * Z_i2;
    Z_i0b += tb6 * H2;
    H2b = tb6 * Z_i0;
    tb5 = Fb[t->massive[i]][3];
    Fb[t->massive[i]][3] = 0.0;
    D3b = -tb5;
    Z_i4b -= tb5 * H5;
    H5b -= tb5 * Z_i4;
    Z_i5b += tb5 * H4;
    H4b += tb5 * Z_i5;
    Z_i1b -= tb5 * H2;
    H2b -= tb5 * Z_i1;
    Z_i2b += tb5 * H1;
    H1b += tb5 * Z_i2;
    tb4 = Fb[t->massive[i]][2];
    Fb[t->massive[i]][2] = 0.0;
    D2b = -tb4;
    Z_i3b -= tb4 * H1;
    H1b -= tb4 * Z_i3;
    Z_i4b += tb4 * H0;
    H0b += tb4 * Z_i4;
    tb3 = Fb[t->massive[i]][1];
    Fb[t->massive[i]][1] = 0.0;
    D1b = -tb3;
    Z_i5b -= tb3 * H0;
    H0b -= tb3 * Z_i5;
    Z_i3b += tb3 * H2;
    H2b += tb3 * Z_i3;
    tb2 = Fb[t->massive[i]][0];
    Fb[t->massive[i]][0] = 0.0;
    D0b = -tb2;
    Z_i4b -= tb2 * H2;
    H2b -= tb2 * Z_i4;
    Z_i5b += tb2 * H1;
    H1b += tb2 * Z_i5;
    I_i1b = D5b * Za_i1;
    Za_i1b = D5b * I_i1;
    I_i2b = -(D5b * Za_i0);
    Za_i0b = -(D5b * I_i2);
    I_i8b = D5b * Za_i3;
    Za_i3b = D5b * I_i8;
    I_i9b = D5b * Za_i4;
    Za_i4b = D5b * I_i9;
    I_i6b = D5b * Za_i5;
    Za_i5b = D5b * I_i6;
    I_i3b = D4b * Za_i0;
    Za_i0b += D4b * I_i3;
    I_i1b -= D4b * Za_i2;
    Za_i2b = -(D4b * I_i1);
    I_i7b = D4b * Za_i3;
    Za_i3b += D4b * I_i7;
    I_i5b = D4b * Za_i4;
    Za_i4b += D4b * I_i5;
    I_i9b += D4b * Za_i5;
    Za_i5b += D4b * I_i9;
    I_i2b += D3b * Za_i2;
    Za_i2b += D3b * I_i2;
    I_i3b -= D3b * Za_i1;
    Za_i1b -= D3b * I_i3;
    I_i4b = D3b * Za_i3;
    Za_i3b += D3b * I_i4;
    I_i7b += D3b * Za_i4;
    Za_i4b += D3b * I_i7;
    I_i8b += D3b * Za_i5;
    Za_i5b += D3b * I_i8;
    I_i0b = D2b * Za_i2;
    Za_i2b += D2b * I_i0;
    Za_i3b += D2b * I_i2;
    I_i2b += D2b * Za_i3;
    Za_i4b -= D2b * I_i1;
    I_i1b -= D2b * Za_i4;
    Zab[t->massive[i]][2] += Za_i2b;
    I_i0b += D1b * Za_i1;
    Za_i1b += D1b * I_i0;
    Za_i5b += D1b * I_i1;
    I_i1b += D1b * Za_i5;
    Za_i3b -= D1b * I_i3;
    I_i3b -= D1b * Za_i3;
    Zab[t->massive[i]][3] += Za_i3b;
    Zab[t->massive[i]][1] += Za_i1b;
    I_i0b += D0b * Za_i0;
    Za_i0b += D0b * I_i0;
    Za_i4b += D0b * I_i3;
    I_i3b += D0b * Za_i4;
    Za_i5b -= D0b * I_i2;
    I_i2b -= D0b * Za_i5;
    Zab[t->massive[i]][5] += Za_i5b;
    Zab[t->massive[i]][4] += Za_i4b;
    Zab[t->massive[i]][0] += Za_i0b;
    I_i1b += H5b * Z_i1;
    Z_i1b += H5b * I_i1;
    I_i2b -= H5b * Z_i0;
    Z_i0b -= H5b * I_i2;
    I_i8b += H5b * Z_i3;
    Z_i3b += H5b * I_i8;
    I_i9b += H5b * Z_i4;
    Z_i4b += H5b * I_i9;
    I_i6b += H5b * Z_i5;
    Z_i5b += H5b * I_i6;
    Ib[t->massive[i]][6] += I_i6b;
    I_i3b += H4b * Z_i0;
    Z_i0b += H4b * I_i3;
    I_i1b -= H4b * Z_i2;
    Z_i2b -= H4b * I_i1;
    I_i7b += H4b * Z_i3;
    Z_i3b += H4b * I_i7;
    I_i5b += H4b * Z_i4;
    Z_i4b += H4b * I_i5;
    I_i9b += H4b * Z_i5;
    Z_i5b += H4b * I_i9;
    Ib[t->massive[i]][9] += I_i9b;
    Ib[t->massive[i]][5] += I_i5b;
    I_i2b += H3b * Z_i2;
    Z_i2b += H3b * I_i2;
    I_i3b -= H3b * Z_i1;
    Z_i1b -= H3b * I_i3;
    I_i4b += H3b * Z_i3;
    Z_i3b += H3b * I_i4;
    I_i7b += H3b * Z_i4;
    Z_i4b += H3b * I_i7;
    I_i8b += H3b * Z_i5;
    Z_i5b += H3b * I_i8;
    Ib[t->massive[i]][8] += I_i8b;
    Ib[t->massive[i]][7] += I_i7b;
    Ib[t->massive[i]][4] += I_i4b;
    I_i0b += H2b * Z_i2;
    Z_i2b += H2b * I_i0;
    Z_i3b += H2b * I_i2;
    I_i2b += H2b * Z_i3;
    Z_i4b -= H2b * I_i1;
    I_i1b -= H2b * Z_i4;
    Zb[t->massive[i]][2] += Z_i2b;
    I_i0b += H1b * Z_i1;
    Z_i1b += H1b * I_i0;
    Z_i5b += H1b * I_i1;
    I_i1b += H1b * Z_i5;
    Z_i3b -= H1b * I_i3;
    I_i3b -= H1b * Z_i3;
    Zb[t->massive[i]][3] += Z_i3b;
    Ib[t->massive[i]][1] += I_i1b;
    Zb[t->massive[i]][1] += Z_i1b;
    /* minus d/dt of the momentum H = I Z about the fixed P:
     *   F = I Z' + (w × H_lin, w × H_ang + s × H_lin) */
    I_i0b += H0b * Z_i0;
    Z_i0b += H0b * I_i0;
    Z_i4b += H0b * I_i3;
    I_i3b += H0b * Z_i4;
    Z_i5b -= H0b * I_i2;
    I_i2b -= H0b * Z_i5;
    Ib[t->massive[i]][2] += I_i2b;
    Zb[t->massive[i]][5] += Z_i5b;
    Ib[t->massive[i]][3] += I_i3b;
    Zb[t->massive[i]][4] += Z_i4b;
    Zb[t->massive[i]][0] += Z_i0b;
    Ib[t->massive[i]][0] += I_i0b;
  }
  for (k = 5; k >= 0; --k) {
    Fb[t->nbody][k] = 0.0;
  }
}

/* rods: -m a_b / 6 at end a and -m a_a / 6 at end b; the thirds are point masses of the bodies */
void maggi_rod_forces_b(const maggi_topo *t, const double p[restrict t->np],
                        double pb[restrict t->np], const double r[restrict t->npoint][3],
                        double rb[restrict t->npoint][3], const double ra[restrict t->npoint][3],
                        double rab[restrict t->npoint][3], double F[restrict t->nbody + 1][6],
                        double Fb[restrict t->nbody + 1][6])
{
  int a, b, i;
  double f0, f0b, f1, f1b, f20, f20b, f21, f21b, f22, f22b, f2_2, f2_2b, p_i, p_ib, tb2, tb3, tb4,
      tb5, tb6, tb7;

  (void)F;
  for (i = t->nrod - 1; i >= 0; --i) {
    a = t->rodpa[i];
    b = t->rodpb[i];
    p_i = p[t->rodadr[i]];
    f0 = -p_i / 6.0 * ra[b][0];
    f1 = -p_i / 6.0 * ra[b][1];
    f2_2 = -p_i / 6.0 * ra[b][2];
    f20 = -p_i / 6.0 * ra[a][0];
    f21 = -p_i / 6.0 * ra[a][1];
    f22 = -p_i / 6.0 * ra[a][2];
    tb7 = Fb[t->pointbody[b]][5];
    rb[b][0] += tb7 * f21;
    f21b = tb7 * r[b][0];
    rb[b][1] -= tb7 * f20;
    f20b = -(tb7 * r[b][1]);
    tb6 = Fb[t->pointbody[b]][4];
    rb[b][2] += tb6 * f20;
    f20b += tb6 * r[b][2];
    rb[b][0] -= tb6 * f22;
    f22b = -(tb6 * r[b][0]);
    tb5 = Fb[t->pointbody[b]][3];
    rb[b][1] += tb5 * f22;
    f22b += tb5 * r[b][1];
    rb[b][2] -= tb5 * f21;
    f21b -= tb5 * r[b][2];
    f22b += Fb[t->pointbody[b]][2];
    f21b += Fb[t->pointbody[b]][1];
    f20b += Fb[t->pointbody[b]][0];
    p_ib = -(f22b * ra[a][2] / 6.0);
    rab[a][2] += f22b * (-p_i / 6.0);
    p_ib -= f21b * ra[a][1] / 6.0;
    rab[a][1] += f21b * (-p_i / 6.0);
    p_ib -= f20b * ra[a][0] / 6.0;
    rab[a][0] += f20b * (-p_i / 6.0);
    tb4 = Fb[t->pointbody[a]][5];
    rb[a][0] += tb4 * f1;
    f1b = tb4 * r[a][0];
    rb[a][1] -= tb4 * f0;
    f0b = -(tb4 * r[a][1]);
    tb3 = Fb[t->pointbody[a]][4];
    rb[a][2] += tb3 * f0;
    f0b += tb3 * r[a][2];
    rb[a][0] -= tb3 * f2_2;
    f2_2b = -(tb3 * r[a][0]);
    tb2 = Fb[t->pointbody[a]][3];
    rb[a][1] += tb2 * f2_2;
    f2_2b += tb2 * r[a][1];
    rb[a][2] -= tb2 * f1;
    f1b -= tb2 * r[a][2];
    f2_2b += Fb[t->pointbody[a]][2];
    f1b += Fb[t->pointbody[a]][1];
    f0b += Fb[t->pointbody[a]][0];
    p_ib -= f2_2b * ra[b][2] / 6.0;
    rab[b][2] += f2_2b * (-p_i / 6.0);
    p_ib -= f1b * ra[b][1] / 6.0;
    rab[b][1] += f1b * (-p_i / 6.0);
    p_ib -= f0b * ra[b][0] / 6.0;
    rab[b][0] += f0b * (-p_i / 6.0);
    pb[t->rodadr[i]] += p_ib;
  }
}

/* FS_i = F_i + Q_i + sum over children */
void maggi_accumulate_b(const maggi_topo *t, const double F[restrict t->nbody + 1][6],
                        double Fb[restrict t->nbody + 1][6],
                        const double Q[restrict t->nbody + 1][6],
                        double Qb[restrict t->nbody + 1][6], double FS[restrict t->nbody + 1][6],
                        double FSb[restrict t->nbody + 1][6])
{
  int i, k, k2;
  double tb2;

  (void)F;
  (void)Q;
  (void)FS;
  for (i = t->nbody - 1; i >= 0; --i) {
    for (k2 = 5; k2 >= 0; --k2) {
      FSb[i][k2] += FSb[t->parent[i]][k2];
    }
  }
  for (i = t->nbody; i >= 0; --i) {
    for (k = 5; k >= 0; --k) {
      tb2 = FSb[i][k];
      FSb[i][k] = 0.0;
      Fb[i][k] += tb2;
      Qb[i][k] += tb2;
    }
  }
}
