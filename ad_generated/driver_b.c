/* Adjoint of core/kernel/driver.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

void maggi_path_constants_b(const maggi_topo *t, const double p[restrict t->np],
                            double pb[restrict t->np], double path0[restrict t->npath0][8],
                            double path0b[restrict t->npath0][8])
{
  int i, k, k2, k3, k4;
  double dx, dxb, dy, dyb, e0, e0_2, e0_2b, e0_3, e0_3b, e0b, e1, e1_2, e1_2b, e1_3, e1_3b, e1b, h0,
      h0_2, h0_2b, h0_3, h0_3b, h0_4, h0_4b, h0b, h1, h1_2, h1_2b, h1_3, h1_3b, h1_4, h1_4b, h1b,
      p_i2ik4, p_i2ik4b, p_iik3, p_iik3b, p_ik2, p_ik2b, path0_ik, path0_ik2, path0_ik2b, path0_ik3,
      path0_ik3b, path0_ik4, path0_ik4b, path0_ikb, t2, t2b, t3, t3b, t4, t4b, t5, t5b, t6, t6b, t7,
      t7b, t8, t8b, tb10, tb11, tb12, tb13, tb14, tb15, tb16, tb17, tb18, tb19, tb2, tb20, tb21,
      tb22, tb3, tb4, tb5, tb6, tb7, tb8, tb9;

  for (i = t->ndriver - 1; i >= 0; --i) {
    if (t->driverspeeds[i]) {
      for (k4 = 1; k4 <= t->drivern[i] - 2; ++k4) {
        tb22 = path0b[t->driverrow[i] + k4][MAGGI_PATH_V];
        path0b[t->driverrow[i] + k4][MAGGI_PATH_V] = 0.0;
        path0b[t->driverrow[i] + k4][7] += tb22;
        path0b[t->driverrow[i] + k4][MAGGI_PATH_W] -= tb22 * path0[t->driverrow[i] + k4 +
            1][MAGGI_PATH_V];
        path0b[t->driverrow[i] + k4 + 1][MAGGI_PATH_V] -= tb22 * path0[t->driverrow[i] +
            k4][MAGGI_PATH_W];
      }
      path0b[t->driverrow[i] + t->drivern[i] - 1][7] = 0.0;
      path0b[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_V] = 0.0;
      path0b[t->driverrow[i]][MAGGI_PATH_V] = 0.0;
      for (k4 = t->drivern[i] - 2; k4 >= 1; --k4) {
        path0_ik4 = path0[t->driverrow[i] + k4][MAGGI_PATH_S];
        h0_4 = path0_ik4 - path0[t->driverrow[i] + k4 - 1][MAGGI_PATH_S];
        h1_4 = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - path0_ik4;
        p_i2ik4 = p[t->driverpath[i] + 2 * t->drivern[i] + k4];
        e0_3 = (p_i2ik4 - p[t->driverpath[i] + 2 * t->drivern[i] + k4 - 1]) / h0_4;
        e1_3 = (p[t->driverpath[i] + 2 * t->drivern[i] + k4 + 1] - p_i2ik4) / h1_4;
        t8 = path0[t->driverrow[i] + k4][7];
        t8b = path0b[t->driverrow[i] + k4][7];
        path0b[t->driverrow[i] + k4][7] = 0.0;
        tb19 = t8b / h1_4;
        tb20 = tb19 * path0[t->driverrow[i] + k4][MAGGI_PATH_W];
        tb21 = tb20 * 6.0;
        e1_3b = tb21;
        e0_3b = -tb21;
        h0_4b = -(tb20 * path0[t->driverrow[i] + k4 - 1][7]);
        path0b[t->driverrow[i] + k4 - 1][7] -= tb20 * h0_4;
        path0b[t->driverrow[i] + k4][MAGGI_PATH_W] += tb19 * (6.0 * (e1_3 - e0_3) - h0_4 *
            path0[t->driverrow[i] + k4 - 1][7]);
        h1_4b = -(tb19 * t8);
        tb18 = e1_3b / h1_4;
        pb[t->driverpath[i] + 2 * t->drivern[i] + k4 + 1] += tb18;
        p_i2ik4b = -tb18;
        h1_4b -= tb18 * e1_3;
        tb17 = e0_3b / h0_4;
        p_i2ik4b += tb17;
        pb[t->driverpath[i] + 2 * t->drivern[i] + k4 - 1] -= tb17;
        h0_4b -= tb17 * e0_3;
        pb[t->driverpath[i] + 2 * t->drivern[i] + k4] += p_i2ik4b;
        path0b[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] += h1_4b;
        path0_ik4b = -h1_4b;
        path0_ik4b += h0_4b;
        path0b[t->driverrow[i] + k4 - 1][MAGGI_PATH_S] -= h0_4b;
        path0b[t->driverrow[i] + k4][MAGGI_PATH_S] += path0_ik4b;
      }
      /* of one of x, y, speed: as in function.c */
      path0b[t->driverrow[i]][7] = 0.0;
    } else {
      for (k = t->drivern[i] - 1; k >= 0; --k) {
        path0b[t->driverrow[i] + k][MAGGI_PATH_VE] = 0.0;
        path0b[t->driverrow[i] + k][MAGGI_PATH_V] = 0.0;
      }
    }
    for (k3 = 1; k3 <= t->drivern[i] - 2; ++k3) {
      tb16 = path0b[t->driverrow[i] + k3][MAGGI_PATH_Y];
      path0b[t->driverrow[i] + k3][MAGGI_PATH_Y] = 0.0;
      path0b[t->driverrow[i] + k3][5] += tb16;
      path0b[t->driverrow[i] + k3][MAGGI_PATH_W] -= tb16 * path0[t->driverrow[i] + k3 +
          1][MAGGI_PATH_Y];
      path0b[t->driverrow[i] + k3 + 1][MAGGI_PATH_Y] -= tb16 * path0[t->driverrow[i] +
          k3][MAGGI_PATH_W];
    }
    path0b[t->driverrow[i] + t->drivern[i] - 1][5] = 0.0;
    path0b[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_Y] = 0.0;
    path0b[t->driverrow[i]][MAGGI_PATH_Y] = 0.0;
    for (k3 = t->drivern[i] - 2; k3 >= 1; --k3) {
      path0_ik3 = path0[t->driverrow[i] + k3][MAGGI_PATH_S];
      h0_3 = path0_ik3 - path0[t->driverrow[i] + k3 - 1][MAGGI_PATH_S];
      h1_3 = path0[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] - path0_ik3;
      p_iik3 = p[t->driverpath[i] + t->drivern[i] + k3];
      e0_2 = (p_iik3 - p[t->driverpath[i] + t->drivern[i] + k3 - 1]) / h0_3;
      e1_2 = (p[t->driverpath[i] + t->drivern[i] + k3 + 1] - p_iik3) / h1_3;
      t7 = path0[t->driverrow[i] + k3][5];
      t7b = path0b[t->driverrow[i] + k3][5];
      path0b[t->driverrow[i] + k3][5] = 0.0;
      tb13 = t7b / h1_3;
      tb14 = tb13 * path0[t->driverrow[i] + k3][MAGGI_PATH_W];
      tb15 = tb14 * 6.0;
      e1_2b = tb15;
      e0_2b = -tb15;
      h0_3b = -(tb14 * path0[t->driverrow[i] + k3 - 1][5]);
      path0b[t->driverrow[i] + k3 - 1][5] -= tb14 * h0_3;
      path0b[t->driverrow[i] + k3][MAGGI_PATH_W] += tb13 * (6.0 * (e1_2 - e0_2) - h0_3 *
          path0[t->driverrow[i] + k3 - 1][5]);
      h1_3b = -(tb13 * t7);
      tb12 = e1_2b / h1_3;
      pb[t->driverpath[i] + t->drivern[i] + k3 + 1] += tb12;
      p_iik3b = -tb12;
      h1_3b -= tb12 * e1_2;
      tb11 = e0_2b / h0_3;
      p_iik3b += tb11;
      pb[t->driverpath[i] + t->drivern[i] + k3 - 1] -= tb11;
      h0_3b -= tb11 * e0_2;
      pb[t->driverpath[i] + t->drivern[i] + k3] += p_iik3b;
      path0b[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] += h1_3b;
      path0_ik3b = -h1_3b;
      path0_ik3b += h0_3b;
      path0b[t->driverrow[i] + k3 - 1][MAGGI_PATH_S] -= h0_3b;
      path0b[t->driverrow[i] + k3][MAGGI_PATH_S] += path0_ik3b;
    }
    /* of one of x, y, speed: as in function.c */
    path0b[t->driverrow[i]][5] = 0.0;
    for (k2 = 1; k2 <= t->drivern[i] - 2; ++k2) {
      tb10 = path0b[t->driverrow[i] + k2][MAGGI_PATH_X];
      path0b[t->driverrow[i] + k2][MAGGI_PATH_X] = 0.0;
      path0b[t->driverrow[i] + k2][3] += tb10;
      path0b[t->driverrow[i] + k2][MAGGI_PATH_W] -= tb10 * path0[t->driverrow[i] + k2 +
          1][MAGGI_PATH_X];
      path0b[t->driverrow[i] + k2 + 1][MAGGI_PATH_X] -= tb10 * path0[t->driverrow[i] +
          k2][MAGGI_PATH_W];
    }
    path0b[t->driverrow[i] + t->drivern[i] - 1][3] = 0.0;
    path0b[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_X] = 0.0;
    path0b[t->driverrow[i]][MAGGI_PATH_X] = 0.0;
    for (k2 = t->drivern[i] - 2; k2 >= 1; --k2) {
      path0_ik2 = path0[t->driverrow[i] + k2][MAGGI_PATH_S];
      h0_2 = path0_ik2 - path0[t->driverrow[i] + k2 - 1][MAGGI_PATH_S];
      h1_2 = path0[t->driverrow[i] + k2 + 1][MAGGI_PATH_S] - path0_ik2;
      p_ik2 = p[t->driverpath[i] + k2];
      e0 = (p_ik2 - p[t->driverpath[i] + k2 - 1]) / h0_2;
      e1 = (p[t->driverpath[i] + k2 + 1] - p_ik2) / h1_2;
      t6 = path0[t->driverrow[i] + k2][3];
      t6b = path0b[t->driverrow[i] + k2][3];
      path0b[t->driverrow[i] + k2][3] = 0.0;
      tb7 = t6b / h1_2;
      tb8 = tb7 * path0[t->driverrow[i] + k2][MAGGI_PATH_W];
      tb9 = tb8 * 6.0;
      e1b = tb9;
      e0b = -tb9;
      h0_2b = -(tb8 * path0[t->driverrow[i] + k2 - 1][3]);
      path0b[t->driverrow[i] + k2 - 1][3] -= tb8 * h0_2;
      path0b[t->driverrow[i] + k2][MAGGI_PATH_W] += tb7 * (6.0 * (e1 - e0) - h0_2 *
          path0[t->driverrow[i] + k2 - 1][3]);
      h1_2b = -(tb7 * t6);
      tb6 = e1b / h1_2;
      pb[t->driverpath[i] + k2 + 1] += tb6;
      p_ik2b = -tb6;
      h1_2b -= tb6 * e1;
      tb5 = e0b / h0_2;
      p_ik2b += tb5;
      pb[t->driverpath[i] + k2 - 1] -= tb5;
      h0_2b -= tb5 * e0;
      pb[t->driverpath[i] + k2] += p_ik2b;
      path0b[t->driverrow[i] + k2 + 1][MAGGI_PATH_S] += h1_2b;
      path0_ik2b = -h1_2b;
      path0_ik2b += h0_2b;
      path0b[t->driverrow[i] + k2 - 1][MAGGI_PATH_S] -= h0_2b;
      path0b[t->driverrow[i] + k2][MAGGI_PATH_S] += path0_ik2b;
    }
    /* of one of x, y, speed: as in function.c */
    path0b[t->driverrow[i]][3] = 0.0;
    for (k = t->drivern[i] - 2; k >= 1; --k) {
      path0_ik = path0[t->driverrow[i] + k][MAGGI_PATH_S];
      h0 = path0_ik - path0[t->driverrow[i] + k - 1][MAGGI_PATH_S];
      h1 = path0[t->driverrow[i] + k + 1][MAGGI_PATH_S] - path0_ik;
      t4 = 2.0 * (h0 + h1) - h0 * path0[t->driverrow[i] + k - 1][MAGGI_PATH_W];
      t5 = path0[t->driverrow[i] + k][MAGGI_PATH_W];
      t5b = path0b[t->driverrow[i] + k][MAGGI_PATH_W];
      path0b[t->driverrow[i] + k][MAGGI_PATH_W] = 0.0;
      tb4 = t5b / t4;
      h1b = tb4;
      t4b = -(tb4 * t5);
      tb3 = t4b * 2.0;
      h0b = tb3;
      h1b += tb3;
      h0b -= t4b * path0[t->driverrow[i] + k - 1][MAGGI_PATH_W];
      path0b[t->driverrow[i] + k - 1][MAGGI_PATH_W] -= t4b * h0;
      path0b[t->driverrow[i] + k + 1][MAGGI_PATH_S] += h1b;
      path0_ikb = -h1b;
      path0_ikb += h0b;
      path0b[t->driverrow[i] + k - 1][MAGGI_PATH_S] -= h0b;
      path0b[t->driverrow[i] + k][MAGGI_PATH_S] += path0_ikb;
    }
    path0b[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_W] = 0.0;
    path0b[t->driverrow[i]][MAGGI_PATH_W] = 0.0;
    for (k = t->drivern[i] - 1; k >= 1; --k) {
      dx = p[t->driverpath[i] + k] - p[t->driverpath[i] + k - 1];
      dy = p[t->driverpath[i] + t->drivern[i] + k] - p[t->driverpath[i] + t->drivern[i] + k - 1];
      t2 = dx * dx + dy * dy;
      t3 = sqrt(t2);
      tb2 = path0b[t->driverrow[i] + k][MAGGI_PATH_S];
      path0b[t->driverrow[i] + k][MAGGI_PATH_S] = 0.0;
      path0b[t->driverrow[i] + k - 1][MAGGI_PATH_S] += tb2;
      t3b = tb2;
      t2b = t3b * (1.0 / (2.0 * t3));
      dxb = t2b * dx;
      dxb += t2b * dx;
      dyb = t2b * dy;
      dyb += t2b * dy;
      pb[t->driverpath[i] + t->drivern[i] + k] += dyb;
      pb[t->driverpath[i] + t->drivern[i] + k - 1] -= dyb;
      pb[t->driverpath[i] + k] += dxb;
      pb[t->driverpath[i] + k - 1] -= dxb;
    }
    path0b[t->driverrow[i]][MAGGI_PATH_S] = 0.0;
  }
}
