/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/driver.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

void maggi_path_constants_dv(const maggi_topo *t, const double p[restrict t->np],
                             const double pd[restrict t->np][MAGGI_NDIR],
                             double path0[restrict t->npath0][8],
                             double path0d[restrict t->npath0][8][MAGGI_NDIR], int nbdirs)
{
  int i, k, k2, k3, k4, nd;
  double c, dx, dy, e0, e0_2, e0_3, e1, e1_2, e1_3, h0, h0_2, h0_2inv, h0_3, h0_3inv, h0_4, h0_4inv,
      h1, h1_2, h1_2inv, h1_3, h1_3inv, h1_4, h1_4inv, p_i2ik4, p_iik3, p_ik2, path0_ik, path0_ik2,
      path0_ik3, path0_ik4, t2, t3, t4, t4inv, t5, t6, t7, t8;

  (void)nbdirs;
  for (i = 0; i < t->ndriver; ++i) {
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      path0d[t->driverrow[i]][MAGGI_PATH_S][nd] = 0.0;
    }
    for (k = 1; k < t->drivern[i]; ++k) {
      dx = p[t->driverpath[i] + k] - p[t->driverpath[i] + k - 1];
      dy = p[t->driverpath[i] + t->drivern[i] + k] - p[t->driverpath[i] + t->drivern[i] + k - 1];
      t2 = dx * dx + dy * dy;
      t3 = sqrt(t2);
      c = 1.0 / (2.0 * t3);
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double dxd, dyd, t2d, t3d;

        dxd = pd[t->driverpath[i] + k][nd] - pd[t->driverpath[i] + k - 1][nd];
        dyd = pd[t->driverpath[i] + t->drivern[i] + k][nd] - pd[t->driverpath[i] + t->drivern[i] + k
            - 1][nd];
        t2d = dxd * dx + dx * dxd + (dyd * dy + dy * dyd);
        t3d = c * t2d;
        path0d[t->driverrow[i] + k][MAGGI_PATH_S][nd] = path0d[t->driverrow[i] + k -
            1][MAGGI_PATH_S][nd] + t3d;
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      path0d[t->driverrow[i]][MAGGI_PATH_W][nd] = 0.0;
      path0d[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_W][nd] = 0.0;
    }
    for (k = 1; k < t->drivern[i] - 1; ++k) {
      path0_ik = path0[t->driverrow[i] + k][MAGGI_PATH_S];
      h0 = path0_ik - path0[t->driverrow[i] + k - 1][MAGGI_PATH_S];
      h1 = path0[t->driverrow[i] + k + 1][MAGGI_PATH_S] - path0_ik;
      t4 = 2.0 * (h0 + h1) - h0 * path0[t->driverrow[i] + k - 1][MAGGI_PATH_W];
      t5 = path0[t->driverrow[i] + k][MAGGI_PATH_W];
      t4inv = 1.0 / t4;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double h0d, h1d, path0_ikd, t4d, t5d;

        path0_ikd = path0d[t->driverrow[i] + k][MAGGI_PATH_S][nd];
        h0d = path0_ikd - path0d[t->driverrow[i] + k - 1][MAGGI_PATH_S][nd];
        h1d = path0d[t->driverrow[i] + k + 1][MAGGI_PATH_S][nd] - path0_ikd;
        t4d = 2.0 * (h0d + h1d) - (h0d * path0[t->driverrow[i] + k - 1][MAGGI_PATH_W] + h0 *
            path0d[t->driverrow[i] + k - 1][MAGGI_PATH_W][nd]);
        t5d = (h1d - t5 * t4d) * t4inv;
        path0d[t->driverrow[i] + k][MAGGI_PATH_W][nd] = t5d;
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      /* of one of x, y, speed: as in function.c */
      path0d[t->driverrow[i]][3][nd] = 0.0;
    }
    for (k2 = 1; k2 < t->drivern[i] - 1; ++k2) {
      path0_ik2 = path0[t->driverrow[i] + k2][MAGGI_PATH_S];
      h0_2 = path0_ik2 - path0[t->driverrow[i] + k2 - 1][MAGGI_PATH_S];
      h1_2 = path0[t->driverrow[i] + k2 + 1][MAGGI_PATH_S] - path0_ik2;
      p_ik2 = p[t->driverpath[i] + k2];
      e0 = (p_ik2 - p[t->driverpath[i] + k2 - 1]) / h0_2;
      h0_2inv = 1.0 / h0_2;
      e1 = (p[t->driverpath[i] + k2 + 1] - p_ik2) / h1_2;
      h1_2inv = 1.0 / h1_2;
      t6 = path0[t->driverrow[i] + k2][3];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e0d, e1d, h0_2d, h1_2d, p_ik2d, path0_ik2d, t6d;

        path0_ik2d = path0d[t->driverrow[i] + k2][MAGGI_PATH_S][nd];
        h0_2d = path0_ik2d - path0d[t->driverrow[i] + k2 - 1][MAGGI_PATH_S][nd];
        h1_2d = path0d[t->driverrow[i] + k2 + 1][MAGGI_PATH_S][nd] - path0_ik2d;
        p_ik2d = pd[t->driverpath[i] + k2][nd];
        e0d = (p_ik2d - pd[t->driverpath[i] + k2 - 1][nd] - e0 * h0_2d) * h0_2inv;
        e1d = (pd[t->driverpath[i] + k2 + 1][nd] - p_ik2d - e1 * h1_2d) * h1_2inv;
        t6d = ((6.0 * (e1d - e0d) - (h0_2d * path0[t->driverrow[i] + k2 - 1][3] + h0_2 *
            path0d[t->driverrow[i] + k2 - 1][3][nd])) * path0[t->driverrow[i] + k2][MAGGI_PATH_W] +
            (6.0 * (e1 - e0) - h0_2 * path0[t->driverrow[i] + k2 - 1][3]) * path0d[t->driverrow[i] +
            k2][MAGGI_PATH_W][nd] - t6 * h1_2d) * h1_2inv;
        path0d[t->driverrow[i] + k2][3][nd] = t6d;
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      path0d[t->driverrow[i]][MAGGI_PATH_X][nd] = 0.0;
      path0d[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_X][nd] = 0.0;
      path0d[t->driverrow[i] + t->drivern[i] - 1][3][nd] = 0.0;
    }
    for (k2 = t->drivern[i] - 2; k2 > 0; --k2) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        path0d[t->driverrow[i] + k2][MAGGI_PATH_X][nd] = path0d[t->driverrow[i] + k2][3][nd] -
            (path0d[t->driverrow[i] + k2][MAGGI_PATH_W][nd] * path0[t->driverrow[i] + k2 +
            1][MAGGI_PATH_X] + path0[t->driverrow[i] + k2][MAGGI_PATH_W] * path0d[t->driverrow[i] +
            k2 + 1][MAGGI_PATH_X][nd]);
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      /* of one of x, y, speed: as in function.c */
      path0d[t->driverrow[i]][5][nd] = 0.0;
    }
    for (k3 = 1; k3 < t->drivern[i] - 1; ++k3) {
      path0_ik3 = path0[t->driverrow[i] + k3][MAGGI_PATH_S];
      h0_3 = path0_ik3 - path0[t->driverrow[i] + k3 - 1][MAGGI_PATH_S];
      h1_3 = path0[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] - path0_ik3;
      p_iik3 = p[t->driverpath[i] + t->drivern[i] + k3];
      e0_2 = (p_iik3 - p[t->driverpath[i] + t->drivern[i] + k3 - 1]) / h0_3;
      h0_3inv = 1.0 / h0_3;
      e1_2 = (p[t->driverpath[i] + t->drivern[i] + k3 + 1] - p_iik3) / h1_3;
      h1_3inv = 1.0 / h1_3;
      t7 = path0[t->driverrow[i] + k3][5];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double e0_2d, e1_2d, h0_3d, h1_3d, p_iik3d, path0_ik3d, t7d;

        path0_ik3d = path0d[t->driverrow[i] + k3][MAGGI_PATH_S][nd];
        h0_3d = path0_ik3d - path0d[t->driverrow[i] + k3 - 1][MAGGI_PATH_S][nd];
        h1_3d = path0d[t->driverrow[i] + k3 + 1][MAGGI_PATH_S][nd] - path0_ik3d;
        p_iik3d = pd[t->driverpath[i] + t->drivern[i] + k3][nd];
        e0_2d = (p_iik3d - pd[t->driverpath[i] + t->drivern[i] + k3 - 1][nd] - e0_2 * h0_3d) *
            h0_3inv;
        e1_2d = (pd[t->driverpath[i] + t->drivern[i] + k3 + 1][nd] - p_iik3d - e1_2 * h1_3d) *
            h1_3inv;
        t7d = ((6.0 * (e1_2d - e0_2d) - (h0_3d * path0[t->driverrow[i] + k3 - 1][5] + h0_3 *
            path0d[t->driverrow[i] + k3 - 1][5][nd])) * path0[t->driverrow[i] + k3][MAGGI_PATH_W] +
            (6.0 * (e1_2 - e0_2) - h0_3 * path0[t->driverrow[i] + k3 - 1][5]) *
            path0d[t->driverrow[i] + k3][MAGGI_PATH_W][nd] - t7 * h1_3d) * h1_3inv;
        path0d[t->driverrow[i] + k3][5][nd] = t7d;
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      path0d[t->driverrow[i]][MAGGI_PATH_Y][nd] = 0.0;
      path0d[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_Y][nd] = 0.0;
      path0d[t->driverrow[i] + t->drivern[i] - 1][5][nd] = 0.0;
    }
    for (k3 = t->drivern[i] - 2; k3 > 0; --k3) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        path0d[t->driverrow[i] + k3][MAGGI_PATH_Y][nd] = path0d[t->driverrow[i] + k3][5][nd] -
            (path0d[t->driverrow[i] + k3][MAGGI_PATH_W][nd] * path0[t->driverrow[i] + k3 +
            1][MAGGI_PATH_Y] + path0[t->driverrow[i] + k3][MAGGI_PATH_W] * path0d[t->driverrow[i] +
            k3 + 1][MAGGI_PATH_Y][nd]);
      }
    }
    if (t->driverspeeds[i]) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        /* of one of x, y, speed: as in function.c */
        path0d[t->driverrow[i]][7][nd] = 0.0;
      }
      for (k4 = 1; k4 < t->drivern[i] - 1; ++k4) {
        path0_ik4 = path0[t->driverrow[i] + k4][MAGGI_PATH_S];
        h0_4 = path0_ik4 - path0[t->driverrow[i] + k4 - 1][MAGGI_PATH_S];
        h1_4 = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - path0_ik4;
        p_i2ik4 = p[t->driverpath[i] + 2 * t->drivern[i] + k4];
        e0_3 = (p_i2ik4 - p[t->driverpath[i] + 2 * t->drivern[i] + k4 - 1]) / h0_4;
        h0_4inv = 1.0 / h0_4;
        e1_3 = (p[t->driverpath[i] + 2 * t->drivern[i] + k4 + 1] - p_i2ik4) / h1_4;
        h1_4inv = 1.0 / h1_4;
        t8 = path0[t->driverrow[i] + k4][7];
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double e0_3d, e1_3d, h0_4d, h1_4d, p_i2ik4d, path0_ik4d, t8d;

          path0_ik4d = path0d[t->driverrow[i] + k4][MAGGI_PATH_S][nd];
          h0_4d = path0_ik4d - path0d[t->driverrow[i] + k4 - 1][MAGGI_PATH_S][nd];
          h1_4d = path0d[t->driverrow[i] + k4 + 1][MAGGI_PATH_S][nd] - path0_ik4d;
          p_i2ik4d = pd[t->driverpath[i] + 2 * t->drivern[i] + k4][nd];
          e0_3d = (p_i2ik4d - pd[t->driverpath[i] + 2 * t->drivern[i] + k4 - 1][nd] - e0_3 * h0_4d)
              * h0_4inv;
          e1_3d = (pd[t->driverpath[i] + 2 * t->drivern[i] + k4 + 1][nd] - p_i2ik4d - e1_3 * h1_4d)
              * h1_4inv;
          t8d = ((6.0 * (e1_3d - e0_3d) - (h0_4d * path0[t->driverrow[i] + k4 - 1][7] + h0_4 *
              path0d[t->driverrow[i] + k4 - 1][7][nd])) * path0[t->driverrow[i] + k4][MAGGI_PATH_W]
              + (6.0 * (e1_3 - e0_3) - h0_4 * path0[t->driverrow[i] + k4 - 1][7]) *
              path0d[t->driverrow[i] + k4][MAGGI_PATH_W][nd] - t8 * h1_4d) * h1_4inv;
          path0d[t->driverrow[i] + k4][7][nd] = t8d;
        }
      }
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        path0d[t->driverrow[i]][MAGGI_PATH_V][nd] = 0.0;
        path0d[t->driverrow[i] + t->drivern[i] - 1][MAGGI_PATH_V][nd] = 0.0;
        path0d[t->driverrow[i] + t->drivern[i] - 1][7][nd] = 0.0;
      }
      for (k4 = t->drivern[i] - 2; k4 > 0; --k4) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          path0d[t->driverrow[i] + k4][MAGGI_PATH_V][nd] = path0d[t->driverrow[i] + k4][7][nd] -
              (path0d[t->driverrow[i] + k4][MAGGI_PATH_W][nd] * path0[t->driverrow[i] + k4 +
              1][MAGGI_PATH_V] + path0[t->driverrow[i] + k4][MAGGI_PATH_W] * path0d[t->driverrow[i]
              + k4 + 1][MAGGI_PATH_V][nd]);
        }
      }
    } else {
      for (k = 0; k < t->drivern[i]; ++k) {
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          path0d[t->driverrow[i] + k][MAGGI_PATH_V][nd] = 0.0;
          path0d[t->driverrow[i] + k][MAGGI_PATH_VE][nd] = 0.0;
        }
      }
    }
  }
}
