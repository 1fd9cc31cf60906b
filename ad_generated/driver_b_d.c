/* Tangent of the adjoint of core/kernel/driver.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

void maggi_path_constants_b_d(const maggi_topo *t, const double p[restrict t->np],
                              const double pd[restrict t->np], double pb[restrict t->np],
                              double pbd[restrict t->np], double path0[restrict t->npath0][8],
                              double path0d[restrict t->npath0][8],
                              double path0b[restrict t->npath0][8],
                              double path0bd[restrict t->npath0][8])
{
  int i, k, k2, k3, k4;
  double dx, dxb, dxbd, dxd, dy, dyb, dybd, dyd, e0, e0_2, e0_2b, e0_2bd, e0_2d, e0_3, e0_3b,
      e0_3bd, e0_3d, e0b, e0bd, e0d, e1, e1_2, e1_2b, e1_2bd, e1_2d, e1_3, e1_3b, e1_3bd, e1_3d,
      e1b, e1bd, e1d, h0, h0_2, h0_2b, h0_2bd, h0_2d, h0_3, h0_3b, h0_3bd, h0_3d, h0_4, h0_4b,
      h0_4bd, h0_4d, h0b, h0bd, h0d, h1, h1_2, h1_2b, h1_2bd, h1_2d, h1_3, h1_3b, h1_3bd, h1_3d,
      h1_4, h1_4b, h1_4bd, h1_4d, h1b, h1bd, h1d, p_i2ik4, p_i2ik4b, p_i2ik4bd, p_i2ik4d, p_iik3,
      p_iik3b, p_iik3bd, p_iik3d, p_ik2, p_ik2b, p_ik2bd, p_ik2d, path0_ik, path0_ik2, path0_ik2b,
      path0_ik2bd, path0_ik2d, path0_ik3, path0_ik3b, path0_ik3bd, path0_ik3d, path0_ik4,
      path0_ik4b, path0_ik4bd, path0_ik4d, path0_ikb, path0_ikbd, path0_ikd, t2, t2b, t2bd, t2d, t3,
      t3b, t3bd, t3d, t4, t4b, t4bd, t4d, t5, t5b, t5bd, t5d, t6, t6b, t6bd, t6d, t7, t7b, t7bd,
      t7d, t8, t8b, t8bd, t8d, tb10, tb10d, tb11, tb11d, tb12, tb12d, tb13, tb13d, tb14, tb14d,
      tb15, tb15d, tb16, tb16d, tb17, tb17d, tb18, tb18d, tb19, tb19d, tb2, tb20, tb20d, tb21,
      tb21d, tb22, tb22d, tb2d, tb3, tb3d, tb4, tb4d, tb5, tb5d, tb6, tb6d, tb7, tb7d, tb8, tb8d,
      tb9, tb9d;

  for (i = t->ndriver - 1; i >= 0; --i) {
    if (t->driverspeeds[i]) {
      for (k4 = 1; k4 <= t->drivern[i] - 2; ++k4) {
        tb22 = path0b[t->driverrow[i] + k4][MAGGI_PATH_V];
        tb22d = path0bd[t->driverrow[i] + k4][MAGGI_PATH_V];
        path0b[t->driverrow[i] + k4][MAGGI_PATH_V] = 0.0;
        path0bd[t->driverrow[i] + k4][MAGGI_PATH_V] = 0.0;
        path0b[t->driverrow[i] + k4][7] += tb22;
        path0bd[t->driverrow[i] + k4][7] += tb22d;
        path0b[t->driverrow[i] + k4][MAGGI_PATH_W] -= tb22 * path0[t->driverrow[i] + k4 +
            1][MAGGI_PATH_V];
        path0bd[t->driverrow[i] + k4][MAGGI_PATH_W] -= tb22d * path0[t->driverrow[i] + k4 +
            1][MAGGI_PATH_V] + tb22 * path0d[t->driverrow[i] + k4 + 1][MAGGI_PATH_V];
        path0b[t->driverrow[i] + k4 + 1][MAGGI_PATH_V] -= tb22 * path0[t->driverrow[i] +
            k4][MAGGI_PATH_W];
        path0bd[t->driverrow[i] + k4 + 1][MAGGI_PATH_V] -= tb22d * path0[t->driverrow[i] +
            k4][MAGGI_PATH_W] + tb22 * path0d[t->driverrow[i] + k4][MAGGI_PATH_W];
      }
      path0b[t->driverrow[i] + t->drivern[i] - 1][7] = 0.0;
      path0bd[t->driverrow[i] + t->drivern[i] - 1][7] = 0.0;
      path0b[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_V] = 0.0;
      path0bd[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_V] = 0.0;
      path0b[t->driverrow[i]][MAGGI_PATH_V] = 0.0;
      path0bd[t->driverrow[i]][MAGGI_PATH_V] = 0.0;
      for (k4 = t->drivern[i] - 2; k4 >= 1; --k4) {
        path0_ik4 = path0[t->driverrow[i] + k4][MAGGI_PATH_S];
        path0_ik4d = path0d[t->driverrow[i] + k4][MAGGI_PATH_S];
        h0_4 = path0_ik4 - path0[t->driverrow[i] + k4 - 1][MAGGI_PATH_S];
        h0_4d = path0_ik4d - path0d[t->driverrow[i] + k4 - 1][MAGGI_PATH_S];
        h1_4 = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - path0_ik4;
        h1_4d = path0d[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - path0_ik4d;
        p_i2ik4 = p[t->driverpath[i] + 2 * t->drivern[i] + k4];
        p_i2ik4d = pd[t->driverpath[i] + 2 * t->drivern[i] + k4];
        e0_3 = (p_i2ik4 - p[t->driverpath[i] + 2 * t->drivern[i] + k4 - 1]) / h0_4;
        e0_3d = (p_i2ik4d - pd[t->driverpath[i] + 2 * t->drivern[i] + k4 - 1] - e0_3 * h0_4d) * (1.0
            / h0_4);
        e1_3 = (p[t->driverpath[i] + 2 * t->drivern[i] + k4 + 1] - p_i2ik4) / h1_4;
        e1_3d = (pd[t->driverpath[i] + 2 * t->drivern[i] + k4 + 1] - p_i2ik4d - e1_3 * h1_4d) * (1.0
            / h1_4);
        t8 = path0[t->driverrow[i] + k4][7];
        t8d = path0d[t->driverrow[i] + k4][7];
        t8b = path0b[t->driverrow[i] + k4][7];
        t8bd = path0bd[t->driverrow[i] + k4][7];
        path0b[t->driverrow[i] + k4][7] = 0.0;
        path0bd[t->driverrow[i] + k4][7] = 0.0;
        tb19 = t8b / h1_4;
        tb19d = (t8bd - tb19 * h1_4d) * (1.0 / h1_4);
        tb20 = tb19 * path0[t->driverrow[i] + k4][MAGGI_PATH_W];
        tb20d = tb19d * path0[t->driverrow[i] + k4][MAGGI_PATH_W] + tb19 * path0d[t->driverrow[i] +
            k4][MAGGI_PATH_W];
        tb21 = tb20 * 6.0;
        tb21d = tb20d * 6.0;
        e1_3b = tb21;
        e1_3bd = tb21d;
        e0_3b = -tb21;
        e0_3bd = -tb21d;
        h0_4b = -(tb20 * path0[t->driverrow[i] + k4 - 1][7]);
        h0_4bd = -(tb20d * path0[t->driverrow[i] + k4 - 1][7] + tb20 * path0d[t->driverrow[i] + k4 -
            1][7]);
        path0b[t->driverrow[i] + k4 - 1][7] -= tb20 * h0_4;
        path0bd[t->driverrow[i] + k4 - 1][7] -= tb20d * h0_4 + tb20 * h0_4d;
        path0b[t->driverrow[i] + k4][MAGGI_PATH_W] += tb19 * (6.0 * (e1_3 - e0_3) - h0_4 *
            path0[t->driverrow[i] + k4 - 1][7]);
        path0bd[t->driverrow[i] + k4][MAGGI_PATH_W] += tb19d * (6.0 * (e1_3 - e0_3) - h0_4 *
            path0[t->driverrow[i] + k4 - 1][7]) + tb19 * (6.0 * (e1_3d - e0_3d) - (h0_4d *
            path0[t->driverrow[i] + k4 - 1][7] + h0_4 * path0d[t->driverrow[i] + k4 - 1][7]));
        h1_4b = -(tb19 * t8);
        h1_4bd = -(tb19d * t8 + tb19 * t8d);
        tb18 = e1_3b / h1_4;
        tb18d = (e1_3bd - tb18 * h1_4d) * (1.0 / h1_4);
        pb[t->driverpath[i] + 2 * t->drivern[i] + k4 + 1] += tb18;
        pbd[t->driverpath[i] + 2 * t->drivern[i] + k4 + 1] += tb18d;
        p_i2ik4b = -tb18;
        p_i2ik4bd = -tb18d;
        h1_4b -= tb18 * e1_3;
        h1_4bd -= tb18d * e1_3 + tb18 * e1_3d;
        tb17 = e0_3b / h0_4;
        tb17d = (e0_3bd - tb17 * h0_4d) * (1.0 / h0_4);
        p_i2ik4b += tb17;
        p_i2ik4bd += tb17d;
        pb[t->driverpath[i] + 2 * t->drivern[i] + k4 - 1] -= tb17;
        pbd[t->driverpath[i] + 2 * t->drivern[i] + k4 - 1] -= tb17d;
        h0_4b -= tb17 * e0_3;
        h0_4bd -= tb17d * e0_3 + tb17 * e0_3d;
        pb[t->driverpath[i] + 2 * t->drivern[i] + k4] += p_i2ik4b;
        pbd[t->driverpath[i] + 2 * t->drivern[i] + k4] += p_i2ik4bd;
        path0b[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] += h1_4b;
        path0bd[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] += h1_4bd;
        path0_ik4b = -h1_4b;
        path0_ik4bd = -h1_4bd;
        path0_ik4b += h0_4b;
        path0_ik4bd += h0_4bd;
        path0b[t->driverrow[i] + k4 - 1][MAGGI_PATH_S] -= h0_4b;
        path0bd[t->driverrow[i] + k4 - 1][MAGGI_PATH_S] -= h0_4bd;
        path0b[t->driverrow[i] + k4][MAGGI_PATH_S] += path0_ik4b;
        path0bd[t->driverrow[i] + k4][MAGGI_PATH_S] += path0_ik4bd;
      }
      path0b[t->driverrow[i]][7] = 0.0;
      /* of one of x, y, speed: as in function.c */
      path0bd[t->driverrow[i]][7] = 0.0;
    } else {
      for (k = t->drivern[i] - 1; k >= 0; --k) {
        path0b[t->driverrow[i] + k][MAGGI_PATH_VE] = 0.0;
        path0bd[t->driverrow[i] + k][MAGGI_PATH_VE] = 0.0;
        path0b[t->driverrow[i] + k][MAGGI_PATH_V] = 0.0;
        path0bd[t->driverrow[i] + k][MAGGI_PATH_V] = 0.0;
      }
    }
    for (k3 = 1; k3 <= t->drivern[i] - 2; ++k3) {
      tb16 = path0b[t->driverrow[i] + k3][MAGGI_PATH_Y];
      tb16d = path0bd[t->driverrow[i] + k3][MAGGI_PATH_Y];
      path0b[t->driverrow[i] + k3][MAGGI_PATH_Y] = 0.0;
      path0bd[t->driverrow[i] + k3][MAGGI_PATH_Y] = 0.0;
      path0b[t->driverrow[i] + k3][5] += tb16;
      path0bd[t->driverrow[i] + k3][5] += tb16d;
      path0b[t->driverrow[i] + k3][MAGGI_PATH_W] -= tb16 * path0[t->driverrow[i] + k3 +
          1][MAGGI_PATH_Y];
      path0bd[t->driverrow[i] + k3][MAGGI_PATH_W] -= tb16d * path0[t->driverrow[i] + k3 +
          1][MAGGI_PATH_Y] + tb16 * path0d[t->driverrow[i] + k3 + 1][MAGGI_PATH_Y];
      path0b[t->driverrow[i] + k3 + 1][MAGGI_PATH_Y] -= tb16 * path0[t->driverrow[i] +
          k3][MAGGI_PATH_W];
      path0bd[t->driverrow[i] + k3 + 1][MAGGI_PATH_Y] -= tb16d * path0[t->driverrow[i] +
          k3][MAGGI_PATH_W] + tb16 * path0d[t->driverrow[i] + k3][MAGGI_PATH_W];
    }
    path0b[t->driverrow[i] + t->drivern[i] - 1][5] = 0.0;
    path0bd[t->driverrow[i] + t->drivern[i] - 1][5] = 0.0;
    path0b[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_Y] = 0.0;
    path0bd[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_Y] = 0.0;
    path0b[t->driverrow[i]][MAGGI_PATH_Y] = 0.0;
    path0bd[t->driverrow[i]][MAGGI_PATH_Y] = 0.0;
    for (k3 = t->drivern[i] - 2; k3 >= 1; --k3) {
      path0_ik3 = path0[t->driverrow[i] + k3][MAGGI_PATH_S];
      path0_ik3d = path0d[t->driverrow[i] + k3][MAGGI_PATH_S];
      h0_3 = path0_ik3 - path0[t->driverrow[i] + k3 - 1][MAGGI_PATH_S];
      h0_3d = path0_ik3d - path0d[t->driverrow[i] + k3 - 1][MAGGI_PATH_S];
      h1_3 = path0[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] - path0_ik3;
      h1_3d = path0d[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] - path0_ik3d;
      p_iik3 = p[t->driverpath[i] + t->drivern[i] + k3];
      p_iik3d = pd[t->driverpath[i] + t->drivern[i] + k3];
      e0_2 = (p_iik3 - p[t->driverpath[i] + t->drivern[i] + k3 - 1]) / h0_3;
      e0_2d = (p_iik3d - pd[t->driverpath[i] + t->drivern[i] + k3 - 1] - e0_2 * h0_3d) * (1.0 /
          h0_3);
      e1_2 = (p[t->driverpath[i] + t->drivern[i] + k3 + 1] - p_iik3) / h1_3;
      e1_2d = (pd[t->driverpath[i] + t->drivern[i] + k3 + 1] - p_iik3d - e1_2 * h1_3d) * (1.0 /
          h1_3);
      t7 = path0[t->driverrow[i] + k3][5];
      t7d = path0d[t->driverrow[i] + k3][5];
      t7b = path0b[t->driverrow[i] + k3][5];
      t7bd = path0bd[t->driverrow[i] + k3][5];
      path0b[t->driverrow[i] + k3][5] = 0.0;
      path0bd[t->driverrow[i] + k3][5] = 0.0;
      tb13 = t7b / h1_3;
      tb13d = (t7bd - tb13 * h1_3d) * (1.0 / h1_3);
      tb14 = tb13 * path0[t->driverrow[i] + k3][MAGGI_PATH_W];
      tb14d = tb13d * path0[t->driverrow[i] + k3][MAGGI_PATH_W] + tb13 * path0d[t->driverrow[i] +
          k3][MAGGI_PATH_W];
      tb15 = tb14 * 6.0;
      tb15d = tb14d * 6.0;
      e1_2b = tb15;
      e1_2bd = tb15d;
      e0_2b = -tb15;
      e0_2bd = -tb15d;
      h0_3b = -(tb14 * path0[t->driverrow[i] + k3 - 1][5]);
      h0_3bd = -(tb14d * path0[t->driverrow[i] + k3 - 1][5] + tb14 * path0d[t->driverrow[i] + k3 -
          1][5]);
      path0b[t->driverrow[i] + k3 - 1][5] -= tb14 * h0_3;
      path0bd[t->driverrow[i] + k3 - 1][5] -= tb14d * h0_3 + tb14 * h0_3d;
      path0b[t->driverrow[i] + k3][MAGGI_PATH_W] += tb13 * (6.0 * (e1_2 - e0_2) - h0_3 *
          path0[t->driverrow[i] + k3 - 1][5]);
      path0bd[t->driverrow[i] + k3][MAGGI_PATH_W] += tb13d * (6.0 * (e1_2 - e0_2) - h0_3 *
          path0[t->driverrow[i] + k3 - 1][5]) + tb13 * (6.0 * (e1_2d - e0_2d) - (h0_3d *
          path0[t->driverrow[i] + k3 - 1][5] + h0_3 * path0d[t->driverrow[i] + k3 - 1][5]));
      h1_3b = -(tb13 * t7);
      h1_3bd = -(tb13d * t7 + tb13 * t7d);
      tb12 = e1_2b / h1_3;
      tb12d = (e1_2bd - tb12 * h1_3d) * (1.0 / h1_3);
      pb[t->driverpath[i] + t->drivern[i] + k3 + 1] += tb12;
      pbd[t->driverpath[i] + t->drivern[i] + k3 + 1] += tb12d;
      p_iik3b = -tb12;
      p_iik3bd = -tb12d;
      h1_3b -= tb12 * e1_2;
      h1_3bd -= tb12d * e1_2 + tb12 * e1_2d;
      tb11 = e0_2b / h0_3;
      tb11d = (e0_2bd - tb11 * h0_3d) * (1.0 / h0_3);
      p_iik3b += tb11;
      p_iik3bd += tb11d;
      pb[t->driverpath[i] + t->drivern[i] + k3 - 1] -= tb11;
      pbd[t->driverpath[i] + t->drivern[i] + k3 - 1] -= tb11d;
      h0_3b -= tb11 * e0_2;
      h0_3bd -= tb11d * e0_2 + tb11 * e0_2d;
      pb[t->driverpath[i] + t->drivern[i] + k3] += p_iik3b;
      pbd[t->driverpath[i] + t->drivern[i] + k3] += p_iik3bd;
      path0b[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] += h1_3b;
      path0bd[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] += h1_3bd;
      path0_ik3b = -h1_3b;
      path0_ik3bd = -h1_3bd;
      path0_ik3b += h0_3b;
      path0_ik3bd += h0_3bd;
      path0b[t->driverrow[i] + k3 - 1][MAGGI_PATH_S] -= h0_3b;
      path0bd[t->driverrow[i] + k3 - 1][MAGGI_PATH_S] -= h0_3bd;
      path0b[t->driverrow[i] + k3][MAGGI_PATH_S] += path0_ik3b;
      path0bd[t->driverrow[i] + k3][MAGGI_PATH_S] += path0_ik3bd;
    }
    path0b[t->driverrow[i]][5] = 0.0;
    /* of one of x, y, speed: as in function.c */
    path0bd[t->driverrow[i]][5] = 0.0;
    for (k2 = 1; k2 <= t->drivern[i] - 2; ++k2) {
      tb10 = path0b[t->driverrow[i] + k2][MAGGI_PATH_X];
      tb10d = path0bd[t->driverrow[i] + k2][MAGGI_PATH_X];
      path0b[t->driverrow[i] + k2][MAGGI_PATH_X] = 0.0;
      path0bd[t->driverrow[i] + k2][MAGGI_PATH_X] = 0.0;
      path0b[t->driverrow[i] + k2][3] += tb10;
      path0bd[t->driverrow[i] + k2][3] += tb10d;
      path0b[t->driverrow[i] + k2][MAGGI_PATH_W] -= tb10 * path0[t->driverrow[i] + k2 +
          1][MAGGI_PATH_X];
      path0bd[t->driverrow[i] + k2][MAGGI_PATH_W] -= tb10d * path0[t->driverrow[i] + k2 +
          1][MAGGI_PATH_X] + tb10 * path0d[t->driverrow[i] + k2 + 1][MAGGI_PATH_X];
      path0b[t->driverrow[i] + k2 + 1][MAGGI_PATH_X] -= tb10 * path0[t->driverrow[i] +
          k2][MAGGI_PATH_W];
      path0bd[t->driverrow[i] + k2 + 1][MAGGI_PATH_X] -= tb10d * path0[t->driverrow[i] +
          k2][MAGGI_PATH_W] + tb10 * path0d[t->driverrow[i] + k2][MAGGI_PATH_W];
    }
    path0b[t->driverrow[i] + t->drivern[i] - 1][3] = 0.0;
    path0bd[t->driverrow[i] + t->drivern[i] - 1][3] = 0.0;
    path0b[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_X] = 0.0;
    path0bd[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_X] = 0.0;
    path0b[t->driverrow[i]][MAGGI_PATH_X] = 0.0;
    path0bd[t->driverrow[i]][MAGGI_PATH_X] = 0.0;
    for (k2 = t->drivern[i] - 2; k2 >= 1; --k2) {
      path0_ik2 = path0[t->driverrow[i] + k2][MAGGI_PATH_S];
      path0_ik2d = path0d[t->driverrow[i] + k2][MAGGI_PATH_S];
      h0_2 = path0_ik2 - path0[t->driverrow[i] + k2 - 1][MAGGI_PATH_S];
      h0_2d = path0_ik2d - path0d[t->driverrow[i] + k2 - 1][MAGGI_PATH_S];
      h1_2 = path0[t->driverrow[i] + k2 + 1][MAGGI_PATH_S] - path0_ik2;
      h1_2d = path0d[t->driverrow[i] + k2 + 1][MAGGI_PATH_S] - path0_ik2d;
      p_ik2 = p[t->driverpath[i] + k2];
      p_ik2d = pd[t->driverpath[i] + k2];
      e0 = (p_ik2 - p[t->driverpath[i] + k2 - 1]) / h0_2;
      e0d = (p_ik2d - pd[t->driverpath[i] + k2 - 1] - e0 * h0_2d) * (1.0 / h0_2);
      e1 = (p[t->driverpath[i] + k2 + 1] - p_ik2) / h1_2;
      e1d = (pd[t->driverpath[i] + k2 + 1] - p_ik2d - e1 * h1_2d) * (1.0 / h1_2);
      t6 = path0[t->driverrow[i] + k2][3];
      t6d = path0d[t->driverrow[i] + k2][3];
      t6b = path0b[t->driverrow[i] + k2][3];
      t6bd = path0bd[t->driverrow[i] + k2][3];
      path0b[t->driverrow[i] + k2][3] = 0.0;
      path0bd[t->driverrow[i] + k2][3] = 0.0;
      tb7 = t6b / h1_2;
      tb7d = (t6bd - tb7 * h1_2d) * (1.0 / h1_2);
      tb8 = tb7 * path0[t->driverrow[i] + k2][MAGGI_PATH_W];
      tb8d = tb7d * path0[t->driverrow[i] + k2][MAGGI_PATH_W] + tb7 * path0d[t->driverrow[i] +
          k2][MAGGI_PATH_W];
      tb9 = tb8 * 6.0;
      tb9d = tb8d * 6.0;
      e1b = tb9;
      e1bd = tb9d;
      e0b = -tb9;
      e0bd = -tb9d;
      h0_2b = -(tb8 * path0[t->driverrow[i] + k2 - 1][3]);
      h0_2bd = -(tb8d * path0[t->driverrow[i] + k2 - 1][3] + tb8 * path0d[t->driverrow[i] + k2 -
          1][3]);
      path0b[t->driverrow[i] + k2 - 1][3] -= tb8 * h0_2;
      path0bd[t->driverrow[i] + k2 - 1][3] -= tb8d * h0_2 + tb8 * h0_2d;
      path0b[t->driverrow[i] + k2][MAGGI_PATH_W] += tb7 * (6.0 * (e1 - e0) - h0_2 *
          path0[t->driverrow[i] + k2 - 1][3]);
      path0bd[t->driverrow[i] + k2][MAGGI_PATH_W] += tb7d * (6.0 * (e1 - e0) - h0_2 *
          path0[t->driverrow[i] + k2 - 1][3]) + tb7 * (6.0 * (e1d - e0d) - (h0_2d *
          path0[t->driverrow[i] + k2 - 1][3] + h0_2 * path0d[t->driverrow[i] + k2 - 1][3]));
      h1_2b = -(tb7 * t6);
      h1_2bd = -(tb7d * t6 + tb7 * t6d);
      tb6 = e1b / h1_2;
      tb6d = (e1bd - tb6 * h1_2d) * (1.0 / h1_2);
      pb[t->driverpath[i] + k2 + 1] += tb6;
      pbd[t->driverpath[i] + k2 + 1] += tb6d;
      p_ik2b = -tb6;
      p_ik2bd = -tb6d;
      h1_2b -= tb6 * e1;
      h1_2bd -= tb6d * e1 + tb6 * e1d;
      tb5 = e0b / h0_2;
      tb5d = (e0bd - tb5 * h0_2d) * (1.0 / h0_2);
      p_ik2b += tb5;
      p_ik2bd += tb5d;
      pb[t->driverpath[i] + k2 - 1] -= tb5;
      pbd[t->driverpath[i] + k2 - 1] -= tb5d;
      h0_2b -= tb5 * e0;
      h0_2bd -= tb5d * e0 + tb5 * e0d;
      pb[t->driverpath[i] + k2] += p_ik2b;
      pbd[t->driverpath[i] + k2] += p_ik2bd;
      path0b[t->driverrow[i] + k2 + 1][MAGGI_PATH_S] += h1_2b;
      path0bd[t->driverrow[i] + k2 + 1][MAGGI_PATH_S] += h1_2bd;
      path0_ik2b = -h1_2b;
      path0_ik2bd = -h1_2bd;
      path0_ik2b += h0_2b;
      path0_ik2bd += h0_2bd;
      path0b[t->driverrow[i] + k2 - 1][MAGGI_PATH_S] -= h0_2b;
      path0bd[t->driverrow[i] + k2 - 1][MAGGI_PATH_S] -= h0_2bd;
      path0b[t->driverrow[i] + k2][MAGGI_PATH_S] += path0_ik2b;
      path0bd[t->driverrow[i] + k2][MAGGI_PATH_S] += path0_ik2bd;
    }
    path0b[t->driverrow[i]][3] = 0.0;
    /* of one of x, y, speed: as in function.c */
    path0bd[t->driverrow[i]][3] = 0.0;
    for (k = t->drivern[i] - 2; k >= 1; --k) {
      path0_ik = path0[t->driverrow[i] + k][MAGGI_PATH_S];
      path0_ikd = path0d[t->driverrow[i] + k][MAGGI_PATH_S];
      h0 = path0_ik - path0[t->driverrow[i] + k - 1][MAGGI_PATH_S];
      h0d = path0_ikd - path0d[t->driverrow[i] + k - 1][MAGGI_PATH_S];
      h1 = path0[t->driverrow[i] + k + 1][MAGGI_PATH_S] - path0_ik;
      h1d = path0d[t->driverrow[i] + k + 1][MAGGI_PATH_S] - path0_ikd;
      t4 = 2.0 * (h0 + h1) - h0 * path0[t->driverrow[i] + k - 1][MAGGI_PATH_W];
      t4d = 2.0 * (h0d + h1d) - (h0d * path0[t->driverrow[i] + k - 1][MAGGI_PATH_W] + h0 *
          path0d[t->driverrow[i] + k - 1][MAGGI_PATH_W]);
      t5 = path0[t->driverrow[i] + k][MAGGI_PATH_W];
      t5d = path0d[t->driverrow[i] + k][MAGGI_PATH_W];
      t5b = path0b[t->driverrow[i] + k][MAGGI_PATH_W];
      t5bd = path0bd[t->driverrow[i] + k][MAGGI_PATH_W];
      path0b[t->driverrow[i] + k][MAGGI_PATH_W] = 0.0;
      path0bd[t->driverrow[i] + k][MAGGI_PATH_W] = 0.0;
      tb4 = t5b / t4;
      tb4d = (t5bd - tb4 * t4d) * (1.0 / t4);
      h1b = tb4;
      h1bd = tb4d;
      t4b = -(tb4 * t5);
      t4bd = -(tb4d * t5 + tb4 * t5d);
      tb3 = t4b * 2.0;
      tb3d = t4bd * 2.0;
      h0b = tb3;
      h0bd = tb3d;
      h1b += tb3;
      h1bd += tb3d;
      h0b -= t4b * path0[t->driverrow[i] + k - 1][MAGGI_PATH_W];
      h0bd -= t4bd * path0[t->driverrow[i] + k - 1][MAGGI_PATH_W] + t4b * path0d[t->driverrow[i] + k
          - 1][MAGGI_PATH_W];
      path0b[t->driverrow[i] + k - 1][MAGGI_PATH_W] -= t4b * h0;
      path0bd[t->driverrow[i] + k - 1][MAGGI_PATH_W] -= t4bd * h0 + t4b * h0d;
      path0b[t->driverrow[i] + k + 1][MAGGI_PATH_S] += h1b;
      path0bd[t->driverrow[i] + k + 1][MAGGI_PATH_S] += h1bd;
      path0_ikb = -h1b;
      path0_ikbd = -h1bd;
      path0_ikb += h0b;
      path0_ikbd += h0bd;
      path0b[t->driverrow[i] + k - 1][MAGGI_PATH_S] -= h0b;
      path0bd[t->driverrow[i] + k - 1][MAGGI_PATH_S] -= h0bd;
      path0b[t->driverrow[i] + k][MAGGI_PATH_S] += path0_ikb;
      path0bd[t->driverrow[i] + k][MAGGI_PATH_S] += path0_ikbd;
    }
    path0b[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_W] = 0.0;
    path0bd[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_W] = 0.0;
    path0b[t->driverrow[i]][MAGGI_PATH_W] = 0.0;
    path0bd[t->driverrow[i]][MAGGI_PATH_W] = 0.0;
    for (k = t->drivern[i] - 1; k >= 1; --k) {
      dx = p[t->driverpath[i] + k] - p[t->driverpath[i] + k - 1];
      dxd = pd[t->driverpath[i] + k] - pd[t->driverpath[i] + k - 1];
      dy = p[t->driverpath[i] + t->drivern[i] + k] - p[t->driverpath[i] + t->drivern[i] + k - 1];
      dyd = pd[t->driverpath[i] + t->drivern[i] + k] - pd[t->driverpath[i] + t->drivern[i] + k - 1];
      t2 = dx * dx + dy * dy;
      t2d = dxd * dx + dx * dxd + (dyd * dy + dy * dyd);
      t3 = sqrt(t2);
      t3d = 1.0 / (2.0 * t3) * t2d;
      tb2 = path0b[t->driverrow[i] + k][MAGGI_PATH_S];
      tb2d = path0bd[t->driverrow[i] + k][MAGGI_PATH_S];
      path0b[t->driverrow[i] + k][MAGGI_PATH_S] = 0.0;
      path0bd[t->driverrow[i] + k][MAGGI_PATH_S] = 0.0;
      path0b[t->driverrow[i] + k - 1][MAGGI_PATH_S] += tb2;
      path0bd[t->driverrow[i] + k - 1][MAGGI_PATH_S] += tb2d;
      t3b = tb2;
      t3bd = tb2d;
      t2b = t3b * (1.0 / (2.0 * t3));
      t2bd = t3bd * (1.0 / (2.0 * t3)) - t3b * (1.0 / (2.0 * t3) * (2.0 * t3d) / (2.0 * t3));
      dxb = t2b * dx;
      dxbd = t2bd * dx + t2b * dxd;
      dxb += t2b * dx;
      dxbd += t2bd * dx + t2b * dxd;
      dyb = t2b * dy;
      dybd = t2bd * dy + t2b * dyd;
      dyb += t2b * dy;
      dybd += t2bd * dy + t2b * dyd;
      pb[t->driverpath[i] + t->drivern[i] + k] += dyb;
      pbd[t->driverpath[i] + t->drivern[i] + k] += dybd;
      pb[t->driverpath[i] + t->drivern[i] + k - 1] -= dyb;
      pbd[t->driverpath[i] + t->drivern[i] + k - 1] -= dybd;
      pb[t->driverpath[i] + k] += dxb;
      pbd[t->driverpath[i] + k] += dxbd;
      pb[t->driverpath[i] + k - 1] -= dxb;
      pbd[t->driverpath[i] + k - 1] -= dxbd;
    }
    path0b[t->driverrow[i]][MAGGI_PATH_S] = 0.0;
    path0bd[t->driverrow[i]][MAGGI_PATH_S] = 0.0;
  }
}
