/* Tangent of the adjoint of core/kernel/inertia.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

/* bodies without inertia keep the zeros they were given at the start */
void maggi_body_inertias_b_d(const maggi_topo *t, const double body0[restrict t->nbody][10],
                             const double body0d[restrict t->nbody][10],
                             double body0b[restrict t->nbody][10],
                             double body0bd[restrict t->nbody][10],
                             const double A[restrict t->nbody + 1][9],
                             const double Ad[restrict t->nbody + 1][9],
                             double Ab[restrict t->nbody + 1][9],
                             double Abd[restrict t->nbody + 1][9],
                             const double x[restrict t->nbody + 1][3],
                             const double xd[restrict t->nbody + 1][3],
                             double xb[restrict t->nbody + 1][3],
                             double xbd[restrict t->nbody + 1][3], double I[restrict t->nbody][10],
                             double Id[restrict t->nbody][10], double Ib[restrict t->nbody][10],
                             double Ibd[restrict t->nbody][10])
{
  int i;
  double A_i0, A_i0b, A_i0bd, A_i0d, A_i1, A_i1b, A_i1bd, A_i1d, A_i2, A_i2b, A_i2bd, A_i2d, A_i3,
      A_i3b, A_i3bd, A_i3d, A_i4, A_i4b, A_i4bd, A_i4d, A_i5, A_i5b, A_i5bd, A_i5d, A_i6, A_i6b,
      A_i6bd, A_i6d, A_i7, A_i7b, A_i7bd, A_i7d, A_i8, A_i8b, A_i8bd, A_i8d, B0, B0b, B0bd, B0d, B1,
      B1b, B1bd, B1d, B2, B2b, B2bd, B2d, B3, B3b, B3bd, B3d, B4, B4b, B4bd, B4d, B5, B5b, B5bd,
      B5d, B6, B6b, B6bd, B6d, B7, B7b, B7bd, B7d, B8, B8b, B8bd, B8d, body0_i4, body0_i4b,
      body0_i4bd, body0_i4d, body0_i5, body0_i5b, body0_i5bd, body0_i5d, body0_i6, body0_i6b,
      body0_i6bd, body0_i6d, body0_i7, body0_i7b, body0_i7bd, body0_i7d, body0_i8, body0_i8b,
      body0_i8bd, body0_i8d, body0_i9, body0_i9b, body0_i9bd, body0_i9d, h00, h00b, h00bd, h00d,
      h01, h01b, h01bd, h01d, h02, h02b, h02bd, h02d, h0_2, h0_2b, h0_2bd, h0_2d, h1, h1b, h1bd,
      h1d, h2, h2b, h2bd, h2d, m, mb, mbd, md, s0, s0b, s0bd, s0d, s1, s1b, s1bd, s1d, s2, s2b,
      s2bd, s2d, tb10, tb10d, tb11, tb11d, tb12, tb12d, tb13, tb13d, tb2, tb2d, tb3, tb3d, tb4,
      tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d, tb8, tb8d, tb9, tb9d, x_i0, x_i0b, x_i0bd, x_i0d, x_i1,
      x_i1b, x_i1bd, x_i1d, x_i2, x_i2b, x_i2bd, x_i2d, xsb, xsbd;

  for (i = t->nmassive - 1; i >= 0; --i) {
    m = I[t->massive[i]][0];
    md = Id[t->massive[i]][0];
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
    tb12 = Ib[t->massive[i]][9];
    tb12d = Ibd[t->massive[i]][9];
    Ib[t->massive[i]][9] = 0.0;
    Ibd[t->massive[i]][9] = 0.0;
    B3b = tb12 * A_i6;
    B3bd = tb12d * A_i6 + tb12 * A_i6d;
    A_i6b = tb12 * B3;
    A_i6bd = tb12d * B3 + tb12 * B3d;
    B4b = tb12 * A_i7;
    B4bd = tb12d * A_i7 + tb12 * A_i7d;
    A_i7b = tb12 * B4;
    A_i7bd = tb12d * B4 + tb12 * B4d;
    B5b = tb12 * A_i8;
    B5bd = tb12d * A_i8 + tb12 * A_i8d;
    A_i8b = tb12 * B5;
    A_i8bd = tb12d * B5 + tb12 * B5d;
    tb13 = tb12 * 0.5;
    tb13d = tb12d * 0.5;
    x_i1b = -(tb13 * s2);
    x_i1bd = -(tb13d * s2 + tb13 * s2d);
    s2b = -(tb13 * x_i1);
    s2bd = -(tb13d * x_i1 + tb13 * x_i1d);
    x_i2b = -(tb13 * s1);
    x_i2bd = -(tb13d * s1 + tb13 * s1d);
    s1b = -(tb13 * x_i2);
    s1bd = -(tb13d * x_i2 + tb13 * x_i2d);
    tb10 = Ib[t->massive[i]][8];
    tb10d = Ibd[t->massive[i]][8];
    Ib[t->massive[i]][8] = 0.0;
    Ibd[t->massive[i]][8] = 0.0;
    B0b = tb10 * A_i6;
    B0bd = tb10d * A_i6 + tb10 * A_i6d;
    A_i6b += tb10 * B0;
    A_i6bd += tb10d * B0 + tb10 * B0d;
    B1b = tb10 * A_i7;
    B1bd = tb10d * A_i7 + tb10 * A_i7d;
    A_i7b += tb10 * B1;
    A_i7bd += tb10d * B1 + tb10 * B1d;
    B2b = tb10 * A_i8;
    B2bd = tb10d * A_i8 + tb10 * A_i8d;
    A_i8b += tb10 * B2;
    A_i8bd += tb10d * B2 + tb10 * B2d;
    tb11 = tb10 * 0.5;
    tb11d = tb10d * 0.5;
    x_i0b = -(tb11 * s2);
    x_i0bd = -(tb11d * s2 + tb11 * s2d);
    s2b -= tb11 * x_i0;
    s2bd -= tb11d * x_i0 + tb11 * x_i0d;
    x_i2b -= tb11 * s0;
    x_i2bd -= tb11d * s0 + tb11 * s0d;
    s0b = -(tb11 * x_i2);
    s0bd = -(tb11d * x_i2 + tb11 * x_i2d);
    tb8 = Ib[t->massive[i]][7];
    tb8d = Ibd[t->massive[i]][7];
    Ib[t->massive[i]][7] = 0.0;
    Ibd[t->massive[i]][7] = 0.0;
    B0b += tb8 * A_i3;
    B0bd += tb8d * A_i3 + tb8 * A_i3d;
    A_i3b = tb8 * B0;
    A_i3bd = tb8d * B0 + tb8 * B0d;
    B1b += tb8 * A_i4;
    B1bd += tb8d * A_i4 + tb8 * A_i4d;
    A_i4b = tb8 * B1;
    A_i4bd = tb8d * B1 + tb8 * B1d;
    B2b += tb8 * A_i5;
    B2bd += tb8d * A_i5 + tb8 * A_i5d;
    A_i5b = tb8 * B2;
    A_i5bd = tb8d * B2 + tb8 * B2d;
    tb9 = tb8 * 0.5;
    tb9d = tb8d * 0.5;
    x_i0b -= tb9 * s1;
    x_i0bd -= tb9d * s1 + tb9 * s1d;
    s1b -= tb9 * x_i0;
    s1bd -= tb9d * x_i0 + tb9 * x_i0d;
    x_i1b -= tb9 * s0;
    x_i1bd -= tb9d * s0 + tb9 * s0d;
    s0b -= tb9 * x_i1;
    s0bd -= tb9d * x_i1 + tb9 * x_i1d;
    tb7 = Ib[t->massive[i]][6];
    tb7d = Ibd[t->massive[i]][6];
    Ib[t->massive[i]][6] = 0.0;
    Ibd[t->massive[i]][6] = 0.0;
    B6b = tb7 * A_i6;
    B6bd = tb7d * A_i6 + tb7 * A_i6d;
    A_i6b += tb7 * B6;
    A_i6bd += tb7d * B6 + tb7 * B6d;
    B7b = tb7 * A_i7;
    B7bd = tb7d * A_i7 + tb7 * A_i7d;
    A_i7b += tb7 * B7;
    A_i7bd += tb7d * B7 + tb7 * B7d;
    B8b = tb7 * A_i8;
    B8bd = tb7d * A_i8 + tb7 * A_i8d;
    A_i8b += tb7 * B8;
    A_i8bd += tb7d * B8 + tb7 * B8d;
    xsb = tb7;
    xsbd = tb7d;
    x_i2b -= tb7 * s2;
    x_i2bd -= tb7d * s2 + tb7 * s2d;
    s2b -= tb7 * x_i2;
    s2bd -= tb7d * x_i2 + tb7 * x_i2d;
    tb6 = Ib[t->massive[i]][5];
    tb6d = Ibd[t->massive[i]][5];
    Ib[t->massive[i]][5] = 0.0;
    Ibd[t->massive[i]][5] = 0.0;
    B3b += tb6 * A_i3;
    B3bd += tb6d * A_i3 + tb6 * A_i3d;
    A_i3b += tb6 * B3;
    A_i3bd += tb6d * B3 + tb6 * B3d;
    B4b += tb6 * A_i4;
    B4bd += tb6d * A_i4 + tb6 * A_i4d;
    A_i4b += tb6 * B4;
    A_i4bd += tb6d * B4 + tb6 * B4d;
    B5b += tb6 * A_i5;
    B5bd += tb6d * A_i5 + tb6 * A_i5d;
    A_i5b += tb6 * B5;
    A_i5bd += tb6d * B5 + tb6 * B5d;
    xsb += tb6;
    xsbd += tb6d;
    x_i1b -= tb6 * s1;
    x_i1bd -= tb6d * s1 + tb6 * s1d;
    s1b -= tb6 * x_i1;
    s1bd -= tb6d * x_i1 + tb6 * x_i1d;
    tb5 = Ib[t->massive[i]][4];
    tb5d = Ibd[t->massive[i]][4];
    Ib[t->massive[i]][4] = 0.0;
    Ibd[t->massive[i]][4] = 0.0;
    B0b += tb5 * A_i0;
    B0bd += tb5d * A_i0 + tb5 * A_i0d;
    A_i0b = tb5 * B0;
    A_i0bd = tb5d * B0 + tb5 * B0d;
    B1b += tb5 * A_i1;
    B1bd += tb5d * A_i1 + tb5 * A_i1d;
    A_i1b = tb5 * B1;
    A_i1bd = tb5d * B1 + tb5 * B1d;
    B2b += tb5 * A_i2;
    B2bd += tb5d * A_i2 + tb5 * A_i2d;
    A_i2b = tb5 * B2;
    A_i2bd = tb5d * B2 + tb5 * B2d;
    xsb += tb5;
    xsbd += tb5d;
    x_i0b -= tb5 * s0;
    x_i0bd -= tb5d * s0 + tb5 * s0d;
    s0b -= tb5 * x_i0;
    s0bd -= tb5d * x_i0 + tb5 * x_i0d;
    tb4 = Ib[t->massive[i]][3];
    tb4d = Ibd[t->massive[i]][3];
    Ib[t->massive[i]][3] = 0.0;
    Ibd[t->massive[i]][3] = 0.0;
    h2b = tb4;
    h2bd = tb4d;
    mb = tb4 * x_i2;
    mbd = tb4d * x_i2 + tb4 * x_i2d;
    x_i2b += tb4 * m;
    x_i2bd += tb4d * m + tb4 * md;
    tb3 = Ib[t->massive[i]][2];
    tb3d = Ibd[t->massive[i]][2];
    Ib[t->massive[i]][2] = 0.0;
    Ibd[t->massive[i]][2] = 0.0;
    h1b = tb3;
    h1bd = tb3d;
    mb += tb3 * x_i1;
    mbd += tb3d * x_i1 + tb3 * x_i1d;
    x_i1b += tb3 * m;
    x_i1bd += tb3d * m + tb3 * md;
    tb2 = Ib[t->massive[i]][1];
    tb2d = Ibd[t->massive[i]][1];
    Ib[t->massive[i]][1] = 0.0;
    Ibd[t->massive[i]][1] = 0.0;
    h0_2b = tb2;
    h0_2bd = tb2d;
    mb += tb2 * x_i0;
    mbd += tb2d * x_i0 + tb2 * x_i0d;
    x_i0b += tb2 * m;
    x_i0bd += tb2d * m + tb2 * md;
    mb += Ib[t->massive[i]][0];
    mbd += Ibd[t->massive[i]][0];
    Ib[t->massive[i]][0] = 0.0;
    Ibd[t->massive[i]][0] = 0.0;
    A_i6b += B8b * body0_i8;
    A_i6bd += B8bd * body0_i8 + B8b * body0_i8d;
    body0_i8b = B8b * A_i6;
    body0_i8bd = B8bd * A_i6 + B8b * A_i6d;
    A_i7b += B8b * body0_i9;
    A_i7bd += B8bd * body0_i9 + B8b * body0_i9d;
    body0_i9b = B8b * A_i7;
    body0_i9bd = B8bd * A_i7 + B8b * A_i7d;
    A_i8b += B8b * body0_i6;
    A_i8bd += B8bd * body0_i6 + B8b * body0_i6d;
    body0_i6b = B8b * A_i8;
    body0_i6bd = B8bd * A_i8 + B8b * A_i8d;
    A_i6b += B7b * body0_i7;
    A_i6bd += B7bd * body0_i7 + B7b * body0_i7d;
    body0_i7b = B7b * A_i6;
    body0_i7bd = B7bd * A_i6 + B7b * A_i6d;
    A_i7b += B7b * body0_i5;
    A_i7bd += B7bd * body0_i5 + B7b * body0_i5d;
    body0_i5b = B7b * A_i7;
    body0_i5bd = B7bd * A_i7 + B7b * A_i7d;
    A_i8b += B7b * body0_i9;
    A_i8bd += B7bd * body0_i9 + B7b * body0_i9d;
    body0_i9b += B7b * A_i8;
    body0_i9bd += B7bd * A_i8 + B7b * A_i8d;
    A_i6b += B6b * body0_i4;
    A_i6bd += B6bd * body0_i4 + B6b * body0_i4d;
    body0_i4b = B6b * A_i6;
    body0_i4bd = B6bd * A_i6 + B6b * A_i6d;
    A_i7b += B6b * body0_i7;
    A_i7bd += B6bd * body0_i7 + B6b * body0_i7d;
    body0_i7b += B6b * A_i7;
    body0_i7bd += B6bd * A_i7 + B6b * A_i7d;
    A_i8b += B6b * body0_i8;
    A_i8bd += B6bd * body0_i8 + B6b * body0_i8d;
    body0_i8b += B6b * A_i8;
    body0_i8bd += B6bd * A_i8 + B6b * A_i8d;
    A_i3b += B5b * body0_i8;
    A_i3bd += B5bd * body0_i8 + B5b * body0_i8d;
    body0_i8b += B5b * A_i3;
    body0_i8bd += B5bd * A_i3 + B5b * A_i3d;
    A_i4b += B5b * body0_i9;
    A_i4bd += B5bd * body0_i9 + B5b * body0_i9d;
    body0_i9b += B5b * A_i4;
    body0_i9bd += B5bd * A_i4 + B5b * A_i4d;
    A_i5b += B5b * body0_i6;
    A_i5bd += B5bd * body0_i6 + B5b * body0_i6d;
    body0_i6b += B5b * A_i5;
    body0_i6bd += B5bd * A_i5 + B5b * A_i5d;
    A_i3b += B4b * body0_i7;
    A_i3bd += B4bd * body0_i7 + B4b * body0_i7d;
    body0_i7b += B4b * A_i3;
    body0_i7bd += B4bd * A_i3 + B4b * A_i3d;
    A_i4b += B4b * body0_i5;
    A_i4bd += B4bd * body0_i5 + B4b * body0_i5d;
    body0_i5b += B4b * A_i4;
    body0_i5bd += B4bd * A_i4 + B4b * A_i4d;
    A_i5b += B4b * body0_i9;
    A_i5bd += B4bd * body0_i9 + B4b * body0_i9d;
    body0_i9b += B4b * A_i5;
    body0_i9bd += B4bd * A_i5 + B4b * A_i5d;
    A_i3b += B3b * body0_i4;
    A_i3bd += B3bd * body0_i4 + B3b * body0_i4d;
    body0_i4b += B3b * A_i3;
    body0_i4bd += B3bd * A_i3 + B3b * A_i3d;
    A_i4b += B3b * body0_i7;
    A_i4bd += B3bd * body0_i7 + B3b * body0_i7d;
    body0_i7b += B3b * A_i4;
    body0_i7bd += B3bd * A_i4 + B3b * A_i4d;
    A_i5b += B3b * body0_i8;
    A_i5bd += B3bd * body0_i8 + B3b * body0_i8d;
    body0_i8b += B3b * A_i5;
    body0_i8bd += B3bd * A_i5 + B3b * A_i5d;
    A_i0b += B2b * body0_i8;
    A_i0bd += B2bd * body0_i8 + B2b * body0_i8d;
    body0_i8b += B2b * A_i0;
    body0_i8bd += B2bd * A_i0 + B2b * A_i0d;
    A_i1b += B2b * body0_i9;
    A_i1bd += B2bd * body0_i9 + B2b * body0_i9d;
    body0_i9b += B2b * A_i1;
    body0_i9bd += B2bd * A_i1 + B2b * A_i1d;
    A_i2b += B2b * body0_i6;
    A_i2bd += B2bd * body0_i6 + B2b * body0_i6d;
    body0_i6b += B2b * A_i2;
    body0_i6bd += B2bd * A_i2 + B2b * A_i2d;
    body0b[t->massive[i]][6] += body0_i6b;
    body0bd[t->massive[i]][6] += body0_i6bd;
    A_i0b += B1b * body0_i7;
    A_i0bd += B1bd * body0_i7 + B1b * body0_i7d;
    body0_i7b += B1b * A_i0;
    body0_i7bd += B1bd * A_i0 + B1b * A_i0d;
    A_i1b += B1b * body0_i5;
    A_i1bd += B1bd * body0_i5 + B1b * body0_i5d;
    body0_i5b += B1b * A_i1;
    body0_i5bd += B1bd * A_i1 + B1b * A_i1d;
    A_i2b += B1b * body0_i9;
    A_i2bd += B1bd * body0_i9 + B1b * body0_i9d;
    body0_i9b += B1b * A_i2;
    body0_i9bd += B1bd * A_i2 + B1b * A_i2d;
    body0b[t->massive[i]][9] += body0_i9b;
    body0bd[t->massive[i]][9] += body0_i9bd;
    body0b[t->massive[i]][5] += body0_i5b;
    body0bd[t->massive[i]][5] += body0_i5bd;
    A_i0b += B0b * body0_i4;
    A_i0bd += B0bd * body0_i4 + B0b * body0_i4d;
    body0_i4b += B0b * A_i0;
    body0_i4bd += B0bd * A_i0 + B0b * A_i0d;
    A_i1b += B0b * body0_i7;
    A_i1bd += B0bd * body0_i7 + B0b * body0_i7d;
    body0_i7b += B0b * A_i1;
    body0_i7bd += B0bd * A_i1 + B0b * A_i1d;
    A_i2b += B0b * body0_i8;
    A_i2bd += B0bd * body0_i8 + B0b * body0_i8d;
    body0_i8b += B0b * A_i2;
    body0_i8bd += B0bd * A_i2 + B0b * A_i2d;
    body0b[t->massive[i]][8] += body0_i8b;
    body0bd[t->massive[i]][8] += body0_i8bd;
    body0b[t->massive[i]][7] += body0_i7b;
    body0bd[t->massive[i]][7] += body0_i7bd;
    body0b[t->massive[i]][4] += body0_i4b;
    body0bd[t->massive[i]][4] += body0_i4bd;
    x_i0b += xsb * s0;
    x_i0bd += xsbd * s0 + xsb * s0d;
    s0b += xsb * x_i0;
    s0bd += xsbd * x_i0 + xsb * x_i0d;
    x_i1b += xsb * s1;
    x_i1bd += xsbd * s1 + xsb * s1d;
    s1b += xsb * x_i1;
    s1bd += xsbd * x_i1 + xsb * x_i1d;
    x_i2b += xsb * s2;
    x_i2bd += xsbd * s2 + xsb * s2d;
    s2b += xsb * x_i2;
    s2bd += xsbd * x_i2 + xsb * x_i2d;
    mb += s2b * x_i2;
    mbd += s2bd * x_i2 + s2b * x_i2d;
    x_i2b += s2b * m;
    x_i2bd += s2bd * m + s2b * md;
    h2b += s2b * 2.0;
    h2bd += s2bd * 2.0;
    xb[t->massive[i]][2] += x_i2b;
    xbd[t->massive[i]][2] += x_i2bd;
    mb += s1b * x_i1;
    mbd += s1bd * x_i1 + s1b * x_i1d;
    x_i1b += s1b * m;
    x_i1bd += s1bd * m + s1b * md;
    h1b += s1b * 2.0;
    h1bd += s1bd * 2.0;
    xb[t->massive[i]][1] += x_i1b;
    xbd[t->massive[i]][1] += x_i1bd;
    mb += s0b * x_i0;
    mbd += s0bd * x_i0 + s0b * x_i0d;
    x_i0b += s0b * m;
    x_i0bd += s0bd * m + s0b * md;
    h0_2b += s0b * 2.0;
    h0_2bd += s0bd * 2.0;
    xb[t->massive[i]][0] += x_i0b;
    xbd[t->massive[i]][0] += x_i0bd;
    A_i6b += h2b * h00;
    A_i6bd += h2bd * h00 + h2b * h00d;
    h00b = h2b * A_i6;
    h00bd = h2bd * A_i6 + h2b * A_i6d;
    A_i7b += h2b * h01;
    A_i7bd += h2bd * h01 + h2b * h01d;
    h01b = h2b * A_i7;
    h01bd = h2bd * A_i7 + h2b * A_i7d;
    A_i8b += h2b * h02;
    A_i8bd += h2bd * h02 + h2b * h02d;
    h02b = h2b * A_i8;
    h02bd = h2bd * A_i8 + h2b * A_i8d;
    Ab[t->massive[i]][8] += A_i8b;
    Abd[t->massive[i]][8] += A_i8bd;
    Ab[t->massive[i]][7] += A_i7b;
    Abd[t->massive[i]][7] += A_i7bd;
    Ab[t->massive[i]][6] += A_i6b;
    Abd[t->massive[i]][6] += A_i6bd;
    A_i3b += h1b * h00;
    A_i3bd += h1bd * h00 + h1b * h00d;
    h00b += h1b * A_i3;
    h00bd += h1bd * A_i3 + h1b * A_i3d;
    A_i4b += h1b * h01;
    A_i4bd += h1bd * h01 + h1b * h01d;
    h01b += h1b * A_i4;
    h01bd += h1bd * A_i4 + h1b * A_i4d;
    A_i5b += h1b * h02;
    A_i5bd += h1bd * h02 + h1b * h02d;
    h02b += h1b * A_i5;
    h02bd += h1bd * A_i5 + h1b * A_i5d;
    Ab[t->massive[i]][5] += A_i5b;
    Abd[t->massive[i]][5] += A_i5bd;
    Ab[t->massive[i]][4] += A_i4b;
    Abd[t->massive[i]][4] += A_i4bd;
    Ab[t->massive[i]][3] += A_i3b;
    Abd[t->massive[i]][3] += A_i3bd;
    A_i0b += h0_2b * h00;
    A_i0bd += h0_2bd * h00 + h0_2b * h00d;
    h00b += h0_2b * A_i0;
    h00bd += h0_2bd * A_i0 + h0_2b * A_i0d;
    A_i1b += h0_2b * h01;
    A_i1bd += h0_2bd * h01 + h0_2b * h01d;
    h01b += h0_2b * A_i1;
    h01bd += h0_2bd * A_i1 + h0_2b * A_i1d;
    A_i2b += h0_2b * h02;
    A_i2bd += h0_2bd * h02 + h0_2b * h02d;
    h02b += h0_2b * A_i2;
    h02bd += h0_2bd * A_i2 + h0_2b * A_i2d;
    Ab[t->massive[i]][2] += A_i2b;
    Abd[t->massive[i]][2] += A_i2bd;
    Ab[t->massive[i]][1] += A_i1b;
    Abd[t->massive[i]][1] += A_i1bd;
    Ab[t->massive[i]][0] += A_i0b;
    Abd[t->massive[i]][0] += A_i0bd;
    body0b[t->massive[i]][3] += h02b;
    body0bd[t->massive[i]][3] += h02bd;
    body0b[t->massive[i]][2] += h01b;
    body0bd[t->massive[i]][2] += h01bd;
    body0b[t->massive[i]][1] += h00b;
    body0bd[t->massive[i]][1] += h00bd;
    body0b[t->massive[i]][0] += mb;
    /* J = A J0 A^T, h = A h0 about the joint point x, moved to P:
     *   h += m x,  J += (x.s) I - (x s^T + s x^T)/2,  s = m x + 2 A h0 */
    body0bd[t->massive[i]][0] += mbd;
  }
}

/* bodies without inertia keep the zeros they were given at the start; rods and loops add to the ground */
void maggi_inertia_forces_b_d(const maggi_topo *t, const double I[restrict t->nbody][10],
                              const double Id[restrict t->nbody][10],
                              double Ib[restrict t->nbody][10], double Ibd[restrict t->nbody][10],
                              const double Z[restrict t->nbody + 1][6],
                              const double Zd[restrict t->nbody + 1][6],
                              double Zb[restrict t->nbody + 1][6],
                              double Zbd[restrict t->nbody + 1][6],
                              const double Za[restrict t->nbody + 1][6],
                              const double Zad[restrict t->nbody + 1][6],
                              double Zab[restrict t->nbody + 1][6],
                              double Zabd[restrict t->nbody + 1][6],
                              double F[restrict t->nbody + 1][6],
                              double Fd[restrict t->nbody + 1][6],
                              double Fb[restrict t->nbody + 1][6],
                              double Fbd[restrict t->nbody + 1][6])
{
  int i, k;
  double D0b, D0bd, D1b, D1bd, D2b, D2bd, D3b, D3bd, D4b, D4bd, D5b, D5bd, H0, H0b, H0bd, H0d, H1,
      H1b, H1bd, H1d, H2, H2b, H2bd, H2d, H3, H3b, H3bd, H3d, H4, H4b, H4bd, H4d, H5, H5b, H5bd,
      H5d, I_i0, I_i0b, I_i0bd, I_i0d, I_i1, I_i1b, I_i1bd, I_i1d, I_i2, I_i2b, I_i2bd, I_i2d, I_i3,
      I_i3b, I_i3bd, I_i3d, I_i4, I_i4b, I_i4bd, I_i4d, I_i5, I_i5b, I_i5bd, I_i5d, I_i6, I_i6b,
      I_i6bd, I_i6d, I_i7, I_i7b, I_i7bd, I_i7d, I_i8, I_i8b, I_i8bd, I_i8d, I_i9, I_i9b, I_i9bd,
      I_i9d, Z_i0, Z_i0b, Z_i0bd, Z_i0d, Z_i1, Z_i1b, Z_i1bd, Z_i1d, Z_i2, Z_i2b, Z_i2bd, Z_i2d,
      Z_i3, Z_i3b, Z_i3bd, Z_i3d, Z_i4, Z_i4b, Z_i4bd, Z_i4d, Z_i5, Z_i5b, Z_i5bd, Z_i5d, Za_i0,
      Za_i0b, Za_i0bd, Za_i0d, Za_i1, Za_i1b, Za_i1bd, Za_i1d, Za_i2, Za_i2b, Za_i2bd, Za_i2d,
      Za_i3, Za_i3b, Za_i3bd, Za_i3d, Za_i4, Za_i4b, Za_i4bd, Za_i4d, Za_i5, Za_i5b, Za_i5bd,
      Za_i5d, tb2, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d;

  (void)F;
  (void)Fd;
  for (i = t->nmassive - 1; i >= 0; --i) {
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
    Za_i1 = Za[t->massive[i]][1];
    Za_i1d = Zad[t->massive[i]][1];
    Za_i3 = Za[t->massive[i]][3];
    Za_i3d = Zad[t->massive[i]][3];
    Za_i2 = Za[t->massive[i]][2];
    Za_i2d = Zad[t->massive[i]][2];
    tb7 = Fb[t->massive[i]][5];
    tb7d = Fbd[t->massive[i]][5];
    Fb[t->massive[i]][5] = 0.0;
    Fbd[t->massive[i]][5] = 0.0;
    D5b = -tb7;
    D5bd = -tb7d;
    Z_i3b = -(tb7 * H4);
    Z_i3bd = -(tb7d * H4 + tb7 * H4d);
    H4b = -(tb7 * Z_i3);
    H4bd = -(tb7d * Z_i3 + tb7 * Z_i3d);
    Z_i4b = tb7 * H3;
    Z_i4bd = tb7d * H3 + tb7 * H3d;
    H3b = tb7 * Z_i4;
    H3bd = tb7d * Z_i4 + tb7 * Z_i4d;
    Z_i0b = -(tb7 * H1);
    Z_i0bd = -(tb7d * H1 + tb7 * H1d);
    H1b = -(tb7 * Z_i0);
    H1bd = -(tb7d * Z_i0 + tb7 * Z_i0d);
    Z_i1b = tb7 * H0;
    Z_i1bd = tb7d * H0 + tb7 * H0d;
    H0b = tb7 * Z_i1;
    H0bd = tb7d * Z_i1 + tb7 * Z_i1d;
    tb6 = Fb[t->massive[i]][4];
    tb6d = Fbd[t->massive[i]][4];
    Fb[t->massive[i]][4] = 0.0;
    Fbd[t->massive[i]][4] = 0.0;
    D4b = -tb6;
    D4bd = -tb6d;
    Z_i5b = -(tb6 * H3);
    Z_i5bd = -(tb6d * H3 + tb6 * H3d);
    H3b -= tb6 * Z_i5;
    H3bd -= tb6d * Z_i5 + tb6 * Z_i5d;
    Z_i3b += tb6 * H5;
    Z_i3bd += tb6d * H5 + tb6 * H5d;
    H5b = tb6 * Z_i3;
    H5bd = tb6d * Z_i3 + tb6 * Z_i3d;
    Z_i2b = -(tb6 * H0);
    Z_i2bd = -(tb6d * H0 + tb6 * H0d);
    H0b -= tb6 * Z_i2;
    H0bd -= tb6d * Z_i2 + tb6 * Z_i2d;
    Z_i0b += tb6 * H2;
    Z_i0bd += tb6d * H2 + tb6 * H2d;
    H2b = tb6 * Z_i0;
    H2bd = tb6d * Z_i0 + tb6 * Z_i0d;
    tb5 = Fb[t->massive[i]][3];
    tb5d = Fbd[t->massive[i]][3];
    Fb[t->massive[i]][3] = 0.0;
    Fbd[t->massive[i]][3] = 0.0;
    D3b = -tb5;
    D3bd = -tb5d;
    Z_i4b -= tb5 * H5;
    Z_i4bd -= tb5d * H5 + tb5 * H5d;
    H5b -= tb5 * Z_i4;
    H5bd -= tb5d * Z_i4 + tb5 * Z_i4d;
    Z_i5b += tb5 * H4;
    Z_i5bd += tb5d * H4 + tb5 * H4d;
    H4b += tb5 * Z_i5;
    H4bd += tb5d * Z_i5 + tb5 * Z_i5d;
    Z_i1b -= tb5 * H2;
    Z_i1bd -= tb5d * H2 + tb5 * H2d;
    H2b -= tb5 * Z_i1;
    H2bd -= tb5d * Z_i1 + tb5 * Z_i1d;
    Z_i2b += tb5 * H1;
    Z_i2bd += tb5d * H1 + tb5 * H1d;
    H1b += tb5 * Z_i2;
    H1bd += tb5d * Z_i2 + tb5 * Z_i2d;
    tb4 = Fb[t->massive[i]][2];
    tb4d = Fbd[t->massive[i]][2];
    Fb[t->massive[i]][2] = 0.0;
    Fbd[t->massive[i]][2] = 0.0;
    D2b = -tb4;
    D2bd = -tb4d;
    Z_i3b -= tb4 * H1;
    Z_i3bd -= tb4d * H1 + tb4 * H1d;
    H1b -= tb4 * Z_i3;
    H1bd -= tb4d * Z_i3 + tb4 * Z_i3d;
    Z_i4b += tb4 * H0;
    Z_i4bd += tb4d * H0 + tb4 * H0d;
    H0b += tb4 * Z_i4;
    H0bd += tb4d * Z_i4 + tb4 * Z_i4d;
    tb3 = Fb[t->massive[i]][1];
    tb3d = Fbd[t->massive[i]][1];
    Fb[t->massive[i]][1] = 0.0;
    Fbd[t->massive[i]][1] = 0.0;
    D1b = -tb3;
    D1bd = -tb3d;
    Z_i5b -= tb3 * H0;
    Z_i5bd -= tb3d * H0 + tb3 * H0d;
    H0b -= tb3 * Z_i5;
    H0bd -= tb3d * Z_i5 + tb3 * Z_i5d;
    Z_i3b += tb3 * H2;
    Z_i3bd += tb3d * H2 + tb3 * H2d;
    H2b += tb3 * Z_i3;
    H2bd += tb3d * Z_i3 + tb3 * Z_i3d;
    tb2 = Fb[t->massive[i]][0];
    tb2d = Fbd[t->massive[i]][0];
    Fb[t->massive[i]][0] = 0.0;
    Fbd[t->massive[i]][0] = 0.0;
    D0b = -tb2;
    D0bd = -tb2d;
    Z_i4b -= tb2 * H2;
    Z_i4bd -= tb2d * H2 + tb2 * H2d;
    H2b -= tb2 * Z_i4;
    H2bd -= tb2d * Z_i4 + tb2 * Z_i4d;
    Z_i5b += tb2 * H1;
    Z_i5bd += tb2d * H1 + tb2 * H1d;
    H1b += tb2 * Z_i5;
    H1bd += tb2d * Z_i5 + tb2 * Z_i5d;
    I_i1b = D5b * Za_i1;
    I_i1bd = D5bd * Za_i1 + D5b * Za_i1d;
    Za_i1b = D5b * I_i1;
    Za_i1bd = D5bd * I_i1 + D5b * I_i1d;
    I_i2b = -(D5b * Za_i0);
    I_i2bd = -(D5bd * Za_i0 + D5b * Za_i0d);
    Za_i0b = -(D5b * I_i2);
    Za_i0bd = -(D5bd * I_i2 + D5b * I_i2d);
    I_i8b = D5b * Za_i3;
    I_i8bd = D5bd * Za_i3 + D5b * Za_i3d;
    Za_i3b = D5b * I_i8;
    Za_i3bd = D5bd * I_i8 + D5b * I_i8d;
    I_i9b = D5b * Za_i4;
    I_i9bd = D5bd * Za_i4 + D5b * Za_i4d;
    Za_i4b = D5b * I_i9;
    Za_i4bd = D5bd * I_i9 + D5b * I_i9d;
    I_i6b = D5b * Za_i5;
    I_i6bd = D5bd * Za_i5 + D5b * Za_i5d;
    Za_i5b = D5b * I_i6;
    Za_i5bd = D5bd * I_i6 + D5b * I_i6d;
    I_i3b = D4b * Za_i0;
    I_i3bd = D4bd * Za_i0 + D4b * Za_i0d;
    Za_i0b += D4b * I_i3;
    Za_i0bd += D4bd * I_i3 + D4b * I_i3d;
    I_i1b -= D4b * Za_i2;
    I_i1bd -= D4bd * Za_i2 + D4b * Za_i2d;
    Za_i2b = -(D4b * I_i1);
    Za_i2bd = -(D4bd * I_i1 + D4b * I_i1d);
    I_i7b = D4b * Za_i3;
    I_i7bd = D4bd * Za_i3 + D4b * Za_i3d;
    Za_i3b += D4b * I_i7;
    Za_i3bd += D4bd * I_i7 + D4b * I_i7d;
    I_i5b = D4b * Za_i4;
    I_i5bd = D4bd * Za_i4 + D4b * Za_i4d;
    Za_i4b += D4b * I_i5;
    Za_i4bd += D4bd * I_i5 + D4b * I_i5d;
    I_i9b += D4b * Za_i5;
    I_i9bd += D4bd * Za_i5 + D4b * Za_i5d;
    Za_i5b += D4b * I_i9;
    Za_i5bd += D4bd * I_i9 + D4b * I_i9d;
    I_i2b += D3b * Za_i2;
    I_i2bd += D3bd * Za_i2 + D3b * Za_i2d;
    Za_i2b += D3b * I_i2;
    Za_i2bd += D3bd * I_i2 + D3b * I_i2d;
    I_i3b -= D3b * Za_i1;
    I_i3bd -= D3bd * Za_i1 + D3b * Za_i1d;
    Za_i1b -= D3b * I_i3;
    Za_i1bd -= D3bd * I_i3 + D3b * I_i3d;
    I_i4b = D3b * Za_i3;
    I_i4bd = D3bd * Za_i3 + D3b * Za_i3d;
    Za_i3b += D3b * I_i4;
    Za_i3bd += D3bd * I_i4 + D3b * I_i4d;
    I_i7b += D3b * Za_i4;
    I_i7bd += D3bd * Za_i4 + D3b * Za_i4d;
    Za_i4b += D3b * I_i7;
    Za_i4bd += D3bd * I_i7 + D3b * I_i7d;
    I_i8b += D3b * Za_i5;
    I_i8bd += D3bd * Za_i5 + D3b * Za_i5d;
    Za_i5b += D3b * I_i8;
    Za_i5bd += D3bd * I_i8 + D3b * I_i8d;
    I_i0b = D2b * Za_i2;
    I_i0bd = D2bd * Za_i2 + D2b * Za_i2d;
    Za_i2b += D2b * I_i0;
    Za_i2bd += D2bd * I_i0 + D2b * I_i0d;
    Za_i3b += D2b * I_i2;
    Za_i3bd += D2bd * I_i2 + D2b * I_i2d;
    I_i2b += D2b * Za_i3;
    I_i2bd += D2bd * Za_i3 + D2b * Za_i3d;
    Za_i4b -= D2b * I_i1;
    Za_i4bd -= D2bd * I_i1 + D2b * I_i1d;
    I_i1b -= D2b * Za_i4;
    I_i1bd -= D2bd * Za_i4 + D2b * Za_i4d;
    Zab[t->massive[i]][2] += Za_i2b;
    Zabd[t->massive[i]][2] += Za_i2bd;
    I_i0b += D1b * Za_i1;
    I_i0bd += D1bd * Za_i1 + D1b * Za_i1d;
    Za_i1b += D1b * I_i0;
    Za_i1bd += D1bd * I_i0 + D1b * I_i0d;
    Za_i5b += D1b * I_i1;
    Za_i5bd += D1bd * I_i1 + D1b * I_i1d;
    I_i1b += D1b * Za_i5;
    I_i1bd += D1bd * Za_i5 + D1b * Za_i5d;
    Za_i3b -= D1b * I_i3;
    Za_i3bd -= D1bd * I_i3 + D1b * I_i3d;
    I_i3b -= D1b * Za_i3;
    I_i3bd -= D1bd * Za_i3 + D1b * Za_i3d;
    Zab[t->massive[i]][3] += Za_i3b;
    Zabd[t->massive[i]][3] += Za_i3bd;
    Zab[t->massive[i]][1] += Za_i1b;
    Zabd[t->massive[i]][1] += Za_i1bd;
    I_i0b += D0b * Za_i0;
    I_i0bd += D0bd * Za_i0 + D0b * Za_i0d;
    Za_i0b += D0b * I_i0;
    Za_i0bd += D0bd * I_i0 + D0b * I_i0d;
    Za_i4b += D0b * I_i3;
    Za_i4bd += D0bd * I_i3 + D0b * I_i3d;
    I_i3b += D0b * Za_i4;
    I_i3bd += D0bd * Za_i4 + D0b * Za_i4d;
    Za_i5b -= D0b * I_i2;
    Za_i5bd -= D0bd * I_i2 + D0b * I_i2d;
    I_i2b -= D0b * Za_i5;
    I_i2bd -= D0bd * Za_i5 + D0b * Za_i5d;
    Zab[t->massive[i]][5] += Za_i5b;
    Zabd[t->massive[i]][5] += Za_i5bd;
    Zab[t->massive[i]][4] += Za_i4b;
    Zabd[t->massive[i]][4] += Za_i4bd;
    Zab[t->massive[i]][0] += Za_i0b;
    Zabd[t->massive[i]][0] += Za_i0bd;
    I_i1b += H5b * Z_i1;
    I_i1bd += H5bd * Z_i1 + H5b * Z_i1d;
    Z_i1b += H5b * I_i1;
    Z_i1bd += H5bd * I_i1 + H5b * I_i1d;
    I_i2b -= H5b * Z_i0;
    I_i2bd -= H5bd * Z_i0 + H5b * Z_i0d;
    Z_i0b -= H5b * I_i2;
    Z_i0bd -= H5bd * I_i2 + H5b * I_i2d;
    I_i8b += H5b * Z_i3;
    I_i8bd += H5bd * Z_i3 + H5b * Z_i3d;
    Z_i3b += H5b * I_i8;
    Z_i3bd += H5bd * I_i8 + H5b * I_i8d;
    I_i9b += H5b * Z_i4;
    I_i9bd += H5bd * Z_i4 + H5b * Z_i4d;
    Z_i4b += H5b * I_i9;
    Z_i4bd += H5bd * I_i9 + H5b * I_i9d;
    I_i6b += H5b * Z_i5;
    I_i6bd += H5bd * Z_i5 + H5b * Z_i5d;
    Z_i5b += H5b * I_i6;
    Z_i5bd += H5bd * I_i6 + H5b * I_i6d;
    Ib[t->massive[i]][6] += I_i6b;
    Ibd[t->massive[i]][6] += I_i6bd;
    I_i3b += H4b * Z_i0;
    I_i3bd += H4bd * Z_i0 + H4b * Z_i0d;
    Z_i0b += H4b * I_i3;
    Z_i0bd += H4bd * I_i3 + H4b * I_i3d;
    I_i1b -= H4b * Z_i2;
    I_i1bd -= H4bd * Z_i2 + H4b * Z_i2d;
    Z_i2b -= H4b * I_i1;
    Z_i2bd -= H4bd * I_i1 + H4b * I_i1d;
    I_i7b += H4b * Z_i3;
    I_i7bd += H4bd * Z_i3 + H4b * Z_i3d;
    Z_i3b += H4b * I_i7;
    Z_i3bd += H4bd * I_i7 + H4b * I_i7d;
    I_i5b += H4b * Z_i4;
    I_i5bd += H4bd * Z_i4 + H4b * Z_i4d;
    Z_i4b += H4b * I_i5;
    Z_i4bd += H4bd * I_i5 + H4b * I_i5d;
    I_i9b += H4b * Z_i5;
    I_i9bd += H4bd * Z_i5 + H4b * Z_i5d;
    Z_i5b += H4b * I_i9;
    Z_i5bd += H4bd * I_i9 + H4b * I_i9d;
    Ib[t->massive[i]][9] += I_i9b;
    Ibd[t->massive[i]][9] += I_i9bd;
    Ib[t->massive[i]][5] += I_i5b;
    Ibd[t->massive[i]][5] += I_i5bd;
    I_i2b += H3b * Z_i2;
    I_i2bd += H3bd * Z_i2 + H3b * Z_i2d;
    Z_i2b += H3b * I_i2;
    Z_i2bd += H3bd * I_i2 + H3b * I_i2d;
    I_i3b -= H3b * Z_i1;
    I_i3bd -= H3bd * Z_i1 + H3b * Z_i1d;
    Z_i1b -= H3b * I_i3;
    Z_i1bd -= H3bd * I_i3 + H3b * I_i3d;
    I_i4b += H3b * Z_i3;
    I_i4bd += H3bd * Z_i3 + H3b * Z_i3d;
    Z_i3b += H3b * I_i4;
    Z_i3bd += H3bd * I_i4 + H3b * I_i4d;
    I_i7b += H3b * Z_i4;
    I_i7bd += H3bd * Z_i4 + H3b * Z_i4d;
    Z_i4b += H3b * I_i7;
    Z_i4bd += H3bd * I_i7 + H3b * I_i7d;
    I_i8b += H3b * Z_i5;
    I_i8bd += H3bd * Z_i5 + H3b * Z_i5d;
    Z_i5b += H3b * I_i8;
    Z_i5bd += H3bd * I_i8 + H3b * I_i8d;
    Ib[t->massive[i]][8] += I_i8b;
    Ibd[t->massive[i]][8] += I_i8bd;
    Ib[t->massive[i]][7] += I_i7b;
    Ibd[t->massive[i]][7] += I_i7bd;
    Ib[t->massive[i]][4] += I_i4b;
    Ibd[t->massive[i]][4] += I_i4bd;
    I_i0b += H2b * Z_i2;
    I_i0bd += H2bd * Z_i2 + H2b * Z_i2d;
    Z_i2b += H2b * I_i0;
    Z_i2bd += H2bd * I_i0 + H2b * I_i0d;
    Z_i3b += H2b * I_i2;
    Z_i3bd += H2bd * I_i2 + H2b * I_i2d;
    I_i2b += H2b * Z_i3;
    I_i2bd += H2bd * Z_i3 + H2b * Z_i3d;
    Z_i4b -= H2b * I_i1;
    Z_i4bd -= H2bd * I_i1 + H2b * I_i1d;
    I_i1b -= H2b * Z_i4;
    I_i1bd -= H2bd * Z_i4 + H2b * Z_i4d;
    Zb[t->massive[i]][2] += Z_i2b;
    Zbd[t->massive[i]][2] += Z_i2bd;
    I_i0b += H1b * Z_i1;
    I_i0bd += H1bd * Z_i1 + H1b * Z_i1d;
    Z_i1b += H1b * I_i0;
    Z_i1bd += H1bd * I_i0 + H1b * I_i0d;
    Z_i5b += H1b * I_i1;
    Z_i5bd += H1bd * I_i1 + H1b * I_i1d;
    I_i1b += H1b * Z_i5;
    I_i1bd += H1bd * Z_i5 + H1b * Z_i5d;
    Z_i3b -= H1b * I_i3;
    Z_i3bd -= H1bd * I_i3 + H1b * I_i3d;
    I_i3b -= H1b * Z_i3;
    I_i3bd -= H1bd * Z_i3 + H1b * Z_i3d;
    Zb[t->massive[i]][3] += Z_i3b;
    Zbd[t->massive[i]][3] += Z_i3bd;
    Ib[t->massive[i]][1] += I_i1b;
    Ibd[t->massive[i]][1] += I_i1bd;
    Zb[t->massive[i]][1] += Z_i1b;
    Zbd[t->massive[i]][1] += Z_i1bd;
    I_i0b += H0b * Z_i0;
    /* minus d/dt of the momentum H = I Z about the fixed P:
     *   F = I Z' + (w × H_lin, w × H_ang + s × H_lin) */
    I_i0bd += H0bd * Z_i0 + H0b * Z_i0d;
    Z_i0b += H0b * I_i0;
    Z_i0bd += H0bd * I_i0 + H0b * I_i0d;
    Z_i4b += H0b * I_i3;
    Z_i4bd += H0bd * I_i3 + H0b * I_i3d;
    I_i3b += H0b * Z_i4;
    I_i3bd += H0bd * Z_i4 + H0b * Z_i4d;
    Z_i5b -= H0b * I_i2;
    Z_i5bd -= H0bd * I_i2 + H0b * I_i2d;
    I_i2b -= H0b * Z_i5;
    I_i2bd -= H0bd * Z_i5 + H0b * Z_i5d;
    Ib[t->massive[i]][2] += I_i2b;
    Ibd[t->massive[i]][2] += I_i2bd;
    Zb[t->massive[i]][5] += Z_i5b;
    Zbd[t->massive[i]][5] += Z_i5bd;
    Ib[t->massive[i]][3] += I_i3b;
    Ibd[t->massive[i]][3] += I_i3bd;
    Zb[t->massive[i]][4] += Z_i4b;
    Zbd[t->massive[i]][4] += Z_i4bd;
    Zb[t->massive[i]][0] += Z_i0b;
    Zbd[t->massive[i]][0] += Z_i0bd;
    Ib[t->massive[i]][0] += I_i0b;
    Ibd[t->massive[i]][0] += I_i0bd;
  }
  for (k = 5; k >= 0; --k) {
    Fb[t->nbody][k] = 0.0;
    Fbd[t->nbody][k] = 0.0;
  }
}

/* rods: -m a_b / 6 at end a and -m a_a / 6 at end b; the thirds are point masses of the bodies */
void maggi_rod_forces_b_d(const maggi_topo *t, const double p[restrict t->np],
                          const double pd[restrict t->np], double pb[restrict t->np],
                          double pbd[restrict t->np], const double r[restrict t->npoint][3],
                          const double rd[restrict t->npoint][3], double rb[restrict t->npoint][3],
                          double rbd[restrict t->npoint][3], const double ra[restrict t->npoint][3],
                          const double rad[restrict t->npoint][3],
                          double rab[restrict t->npoint][3], double rabd[restrict t->npoint][3],
                          double F[restrict t->nbody + 1][6], double Fd[restrict t->nbody + 1][6],
                          double Fb[restrict t->nbody + 1][6], double Fbd[restrict t->nbody + 1][6])
{
  int a, b, i;
  double f0, f0b, f0bd, f0d, f1, f1b, f1bd, f1d, f20, f20b, f20bd, f20d, f21, f21b, f21bd, f21d,
      f22, f22b, f22bd, f22d, f2_2, f2_2b, f2_2bd, f2_2d, p_i, p_ib, p_ibd, p_id, tb2, tb2d, tb3,
      tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d;

  (void)F;
  (void)Fd;
  for (i = t->nrod - 1; i >= 0; --i) {
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
    f20 = -p_i / 6.0 * ra[a][0];
    f20d = -(p_id / 6.0 * ra[a][0]) + -p_i / 6.0 * rad[a][0];
    f21 = -p_i / 6.0 * ra[a][1];
    f21d = -(p_id / 6.0 * ra[a][1]) + -p_i / 6.0 * rad[a][1];
    f22 = -p_i / 6.0 * ra[a][2];
    f22d = -(p_id / 6.0 * ra[a][2]) + -p_i / 6.0 * rad[a][2];
    tb7 = Fb[t->pointbody[b]][5];
    tb7d = Fbd[t->pointbody[b]][5];
    rb[b][0] += tb7 * f21;
    rbd[b][0] += tb7d * f21 + tb7 * f21d;
    f21b = tb7 * r[b][0];
    f21bd = tb7d * r[b][0] + tb7 * rd[b][0];
    rb[b][1] -= tb7 * f20;
    rbd[b][1] -= tb7d * f20 + tb7 * f20d;
    f20b = -(tb7 * r[b][1]);
    f20bd = -(tb7d * r[b][1] + tb7 * rd[b][1]);
    tb6 = Fb[t->pointbody[b]][4];
    tb6d = Fbd[t->pointbody[b]][4];
    rb[b][2] += tb6 * f20;
    rbd[b][2] += tb6d * f20 + tb6 * f20d;
    f20b += tb6 * r[b][2];
    f20bd += tb6d * r[b][2] + tb6 * rd[b][2];
    rb[b][0] -= tb6 * f22;
    rbd[b][0] -= tb6d * f22 + tb6 * f22d;
    f22b = -(tb6 * r[b][0]);
    f22bd = -(tb6d * r[b][0] + tb6 * rd[b][0]);
    tb5 = Fb[t->pointbody[b]][3];
    tb5d = Fbd[t->pointbody[b]][3];
    rb[b][1] += tb5 * f22;
    rbd[b][1] += tb5d * f22 + tb5 * f22d;
    f22b += tb5 * r[b][1];
    f22bd += tb5d * r[b][1] + tb5 * rd[b][1];
    rb[b][2] -= tb5 * f21;
    rbd[b][2] -= tb5d * f21 + tb5 * f21d;
    f21b -= tb5 * r[b][2];
    f21bd -= tb5d * r[b][2] + tb5 * rd[b][2];
    f22b += Fb[t->pointbody[b]][2];
    f22bd += Fbd[t->pointbody[b]][2];
    f21b += Fb[t->pointbody[b]][1];
    f21bd += Fbd[t->pointbody[b]][1];
    f20b += Fb[t->pointbody[b]][0];
    f20bd += Fbd[t->pointbody[b]][0];
    p_ib = -(f22b * ra[a][2] / 6.0);
    p_ibd = -((f22bd * ra[a][2] + f22b * rad[a][2]) / 6.0);
    rab[a][2] += f22b * (-p_i / 6.0);
    rabd[a][2] += f22bd * (-p_i / 6.0) - f22b * (p_id / 6.0);
    p_ib -= f21b * ra[a][1] / 6.0;
    p_ibd -= (f21bd * ra[a][1] + f21b * rad[a][1]) / 6.0;
    rab[a][1] += f21b * (-p_i / 6.0);
    rabd[a][1] += f21bd * (-p_i / 6.0) - f21b * (p_id / 6.0);
    p_ib -= f20b * ra[a][0] / 6.0;
    p_ibd -= (f20bd * ra[a][0] + f20b * rad[a][0]) / 6.0;
    rab[a][0] += f20b * (-p_i / 6.0);
    rabd[a][0] += f20bd * (-p_i / 6.0) - f20b * (p_id / 6.0);
    tb4 = Fb[t->pointbody[a]][5];
    tb4d = Fbd[t->pointbody[a]][5];
    rb[a][0] += tb4 * f1;
    rbd[a][0] += tb4d * f1 + tb4 * f1d;
    f1b = tb4 * r[a][0];
    f1bd = tb4d * r[a][0] + tb4 * rd[a][0];
    rb[a][1] -= tb4 * f0;
    rbd[a][1] -= tb4d * f0 + tb4 * f0d;
    f0b = -(tb4 * r[a][1]);
    f0bd = -(tb4d * r[a][1] + tb4 * rd[a][1]);
    tb3 = Fb[t->pointbody[a]][4];
    tb3d = Fbd[t->pointbody[a]][4];
    rb[a][2] += tb3 * f0;
    rbd[a][2] += tb3d * f0 + tb3 * f0d;
    f0b += tb3 * r[a][2];
    f0bd += tb3d * r[a][2] + tb3 * rd[a][2];
    rb[a][0] -= tb3 * f2_2;
    rbd[a][0] -= tb3d * f2_2 + tb3 * f2_2d;
    f2_2b = -(tb3 * r[a][0]);
    f2_2bd = -(tb3d * r[a][0] + tb3 * rd[a][0]);
    tb2 = Fb[t->pointbody[a]][3];
    tb2d = Fbd[t->pointbody[a]][3];
    rb[a][1] += tb2 * f2_2;
    rbd[a][1] += tb2d * f2_2 + tb2 * f2_2d;
    f2_2b += tb2 * r[a][1];
    f2_2bd += tb2d * r[a][1] + tb2 * rd[a][1];
    rb[a][2] -= tb2 * f1;
    rbd[a][2] -= tb2d * f1 + tb2 * f1d;
    f1b -= tb2 * r[a][2];
    f1bd -= tb2d * r[a][2] + tb2 * rd[a][2];
    f2_2b += Fb[t->pointbody[a]][2];
    f2_2bd += Fbd[t->pointbody[a]][2];
    f1b += Fb[t->pointbody[a]][1];
    f1bd += Fbd[t->pointbody[a]][1];
    f0b += Fb[t->pointbody[a]][0];
    f0bd += Fbd[t->pointbody[a]][0];
    p_ib -= f2_2b * ra[b][2] / 6.0;
    p_ibd -= (f2_2bd * ra[b][2] + f2_2b * rad[b][2]) / 6.0;
    rab[b][2] += f2_2b * (-p_i / 6.0);
    rabd[b][2] += f2_2bd * (-p_i / 6.0) - f2_2b * (p_id / 6.0);
    p_ib -= f1b * ra[b][1] / 6.0;
    p_ibd -= (f1bd * ra[b][1] + f1b * rad[b][1]) / 6.0;
    rab[b][1] += f1b * (-p_i / 6.0);
    rabd[b][1] += f1bd * (-p_i / 6.0) - f1b * (p_id / 6.0);
    p_ib -= f0b * ra[b][0] / 6.0;
    p_ibd -= (f0bd * ra[b][0] + f0b * rad[b][0]) / 6.0;
    rab[b][0] += f0b * (-p_i / 6.0);
    rabd[b][0] += f0bd * (-p_i / 6.0) - f0b * (p_id / 6.0);
    pb[t->rodadr[i]] += p_ib;
    pbd[t->rodadr[i]] += p_ibd;
  }
}

/* FS_i = F_i + Q_i + sum over children */
void maggi_accumulate_b_d(const maggi_topo *t, const double F[restrict t->nbody + 1][6],
                          const double Fd[restrict t->nbody + 1][6],
                          double Fb[restrict t->nbody + 1][6], double Fbd[restrict t->nbody + 1][6],
                          const double Q[restrict t->nbody + 1][6],
                          const double Qd[restrict t->nbody + 1][6],
                          double Qb[restrict t->nbody + 1][6], double Qbd[restrict t->nbody + 1][6],
                          double FS[restrict t->nbody + 1][6], double FSd[restrict t->nbody + 1][6],
                          double FSb[restrict t->nbody + 1][6],
                          double FSbd[restrict t->nbody + 1][6])
{
  int i, k, k2;
  double tb2, tb2d;

  (void)F;
  (void)Fd;
  (void)Q;
  (void)Qd;
  (void)FS;
  (void)FSd;
  for (i = t->nbody - 1; i >= 0; --i) {
    for (k2 = 5; k2 >= 0; --k2) {
      FSbd[i][k2] += FSbd[t->parent[i]][k2];
      FSb[i][k2] += FSb[t->parent[i]][k2];
    }
  }
  for (i = t->nbody; i >= 0; --i) {
    for (k = 5; k >= 0; --k) {
      tb2 = FSb[i][k];
      tb2d = FSbd[i][k];
      FSb[i][k] = 0.0;
      FSbd[i][k] = 0.0;
      Fb[i][k] += tb2;
      Fbd[i][k] += tb2d;
      Qb[i][k] += tb2;
      Qbd[i][k] += tb2d;
    }
  }
}
