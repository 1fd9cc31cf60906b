/* Vector tangent, one strip of MAGGI_NDIR directions of core/kernel/control.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"

static double path_part_nodiff(int np, const double p[np], int adr, int n, int k, const double P[2])
{
  double dx, dy;

  dx = p[adr + k + 1] - p[adr + k];
  dy = p[adr + n + k + 1] - p[adr + n + k];
  return ((P[0] - p[adr + k]) * dx + (P[1] - p[adr + n + k]) * dy) / (dx * dx + dy * dy);
}

static int path_nearest_nodiff(int np, const double p[np], int adr, int n, const double P[2])
{
  int k, found;
  double u, x, y, d, least;

  found = 0;
  least = 0.0;
  for (k = 0; k < n - 1; ++k) {
    u = path_part_nodiff(np, p, adr, n, k, P);
    if (k > 0 && MAGGI_RE(u) < 0.0) u = 0.0;
    if (k < n - 2 && MAGGI_RE(u) > 1.0) u = 1.0;
    x = p[adr + k] + u * (p[adr + k + 1] - p[adr + k]) - P[0];
    y = p[adr + n + k] + u * (p[adr + n + k + 1] - p[adr + n + k]) - P[1];
    d = x * x + y * y;
    if (k == 0 || MAGGI_RE(d) < MAGGI_RE(least)) {
      least = d;
      found = k;
    }
  }
  return found;
}

static int path_piece_nodiff(int n, int row, int npath, const double path0[npath][8], double s)
{
  int k, found;

  found = 0;
  for (k = 1; k < n - 1; ++k)
    if (MAGGI_RE(s) >= MAGGI_RE(path0[row + k][MAGGI_PATH_S])) found = k;
  return found;
}

/* adds to what elements exert on coordinates */
void maggi_control_forces_dv(const maggi_topo *t, const double p[restrict t->np],
                             const double pd[restrict t->np][MAGGI_NDIR],
                             const double fun[restrict t->nfun][3],
                             const double fund[restrict t->nfun][3][MAGGI_NDIR],
                             const double path0[restrict t->npath0][8],
                             const double path0d[restrict t->npath0][8][MAGGI_NDIR],
                             const double q[restrict t->nq],
                             const double qd[restrict t->nq][MAGGI_NDIR],
                             const double v[restrict t->nq],
                             const double vd[restrict t->nq][MAGGI_NDIR],
                             const double r[restrict t->npoint][3],
                             const double rd[restrict t->npoint][3][MAGGI_NDIR],
                             const double rv[restrict t->npoint][3],
                             const double rvd[restrict t->npoint][3][MAGGI_NDIR],
                             double driver[restrict t->ndriver][4],
                             double driverd[restrict t->ndriver][4][MAGGI_NDIR],
                             double speed[restrict t->nspeed][3],
                             double speedd[restrict t->nspeed][3][MAGGI_NDIR],
                             double tau[restrict t->nq], double taud[restrict t->nq][MAGGI_NDIR],
                             double power[restrict 1], int nbdirs)
{
  int a, b, i, k, k10, k11, k12, k13, k14, k15, k16, k17, k18, k19, k3, k4, k5, k6, k7, k8, k9, nd;
  double a10, a11, a12, a13, a14, a15, a16, a2, a3, a4, a5, a6, a7, a8, a9, c, c10, c11, c12, c13,
      c14, c15, c16, c17, c18, c2, c3, c4, c5, c6, c7, c8, c9, curvature, demand, dx, dy, e, e10,
      e11, e12, e13, e14, e15, e16, e2, e3, e4, e5, e6, e7, e8, e9, error, factor, g, g2, g3, g4,
      g5, g6, gain, h, h10, h10inv, h11, h11inv, h12, h12inv, h13, h13inv, h14, h14inv, h15, h15inv,
      h2, h2inv, h3, h3inv, h4, h4inv, h5, h5inv, h6, h6inv, h7, h7inv, h8, h8inv, h9, h9inv, hinv,
      length, lengthinv, limit, limitinv, m0, m0_10, m0_11, m0_12, m0_13, m0_14, m0_15, m0_2, m0_3,
      m0_4, m0_5, m0_6, m0_7, m0_8, m0_9, m1, m1_10, m1_11, m1_12, m1_13, m1_14, m1_15, m1_2, m1_3,
      m1_4, m1_5, m1_6, m1_7, m1_8, m1_9, p2, p_i, rv_i0, rv_i1, rv_i2, s, s0, s1, s2, s3, s4, s5,
      s6, slope, slope10, slope10_2, slope10_3, slope11, slope11_2, slope11_3, slope12, slope12inv,
      slope13, slope13_2, slope13_3, slope14, slope14_2, slope14_3, slope15, slope15inv, slope16,
      slope16_2, slope16_3, slope17, slope17_2, slope17_3, slope18, slope18inv, slope19, slope19_2,
      slope19_3, slope2, slope20, slope20_2, slope20_3, slope21, slope21_2, slope21_3, slope22,
      slope22_2, slope2_2, slope2_3, slope3, slope3inv, slope4, slope4_2, slope4_3, slope5,
      slope5_2, slope5_3, slope6, slope6inv, slope7, slope7_2, slope7_3, slope8, slope8_2, slope8_3,
      slope9, slope9inv, speed2, t10, t11, t11inv, t12, t13, t14, t15, t15inv, t16, t17, t17inv,
      t18, t19, t2, t20, t20inv, t21, t22, t22inv, t23, t24, t25, t26, t26inv, t27, t28, t28inv,
      t29, t2inv, t3, t30, t31, t31inv, t32, t33, t33inv, t34, t35, t36, t37, t37inv, t38, t39,
      t39inv, t4, t40, t41, t42, t42inv, t43, t44, t44inv, t45, t46, t47, t48, t48inv, t49, t4inv,
      t5, t50, t50inv, t51, t52, t53, t53inv, t54, t55, t55inv, t56, t57, t58, t59, t59inv, t6, t60,
      t61, t61inv, t62, t63, t64, t64inv, t65, t66, t66inv, t67, t68, t69, t6inv, t7, t70, t70inv,
      t71, t72, t72inv, t73, t74, t75, t75inv, t76, t77, t77inv, t78, t79, t8, t80, t81, t81inv,
      t82, t83, t84, t84inv, t85, t87, t9, t9inv, x00, x01, x02, x0_2, x10, x11, x12, x1_2, x20,
      x21, x22, x2_4, x2_5, x2_6, x30, x31, x32, x40, x41, x42, x50, x51, x52, y00, y01, y02, y0_2,
      y10, y11, y12, y1_2, y20, y21, y22, y2_2, y30, y31, y32, y40, y41, y42, y50, y51, y52;
  double P[2], Pd[2][MAGGI_NDIR], a10d[MAGGI_NDIR], a11d[MAGGI_NDIR], a12d[MAGGI_NDIR],
      a13d[MAGGI_NDIR], a14d[MAGGI_NDIR], a15d[MAGGI_NDIR], a16d[MAGGI_NDIR], a2d[MAGGI_NDIR],
      a3d[MAGGI_NDIR], a4d[MAGGI_NDIR], a5d[MAGGI_NDIR], a6d[MAGGI_NDIR], a7d[MAGGI_NDIR],
      a8d[MAGGI_NDIR], a9d[MAGGI_NDIR], c10d[MAGGI_NDIR], c11d[MAGGI_NDIR], c12d[MAGGI_NDIR],
      c13d[MAGGI_NDIR], c14d[MAGGI_NDIR], c15d[MAGGI_NDIR], c2d[MAGGI_NDIR], c3d[MAGGI_NDIR],
      c4d[MAGGI_NDIR], c5d[MAGGI_NDIR], c6d[MAGGI_NDIR], c7d[MAGGI_NDIR], c8d[MAGGI_NDIR],
      c9d[MAGGI_NDIR], cd[MAGGI_NDIR], e10d[MAGGI_NDIR], e11d[MAGGI_NDIR], e12d[MAGGI_NDIR],
      e13d[MAGGI_NDIR], e14d[MAGGI_NDIR], e15d[MAGGI_NDIR], e16d[MAGGI_NDIR], e2d[MAGGI_NDIR],
      e3d[MAGGI_NDIR], e4d[MAGGI_NDIR], e5d[MAGGI_NDIR], e6d[MAGGI_NDIR], e7d[MAGGI_NDIR],
      e8d[MAGGI_NDIR], e9d[MAGGI_NDIR], ed[MAGGI_NDIR], factord[MAGGI_NDIR], gaind[MAGGI_NDIR],
      h10d[MAGGI_NDIR], h11d[MAGGI_NDIR], h12d[MAGGI_NDIR], h13d[MAGGI_NDIR], h14d[MAGGI_NDIR],
      h15d[MAGGI_NDIR], h2d[MAGGI_NDIR], h3d[MAGGI_NDIR], h4d[MAGGI_NDIR], h5d[MAGGI_NDIR],
      h6d[MAGGI_NDIR], h7d[MAGGI_NDIR], h8d[MAGGI_NDIR], h9d[MAGGI_NDIR], hd[MAGGI_NDIR],
      m0_10d[MAGGI_NDIR], m0_11d[MAGGI_NDIR], m0_12d[MAGGI_NDIR], m0_13d[MAGGI_NDIR],
      m0_14d[MAGGI_NDIR], m0_15d[MAGGI_NDIR], m0_2d[MAGGI_NDIR], m0_3d[MAGGI_NDIR],
      m0_4d[MAGGI_NDIR], m0_5d[MAGGI_NDIR], m0_6d[MAGGI_NDIR], m0_7d[MAGGI_NDIR], m0_8d[MAGGI_NDIR],
      m0_9d[MAGGI_NDIR], m0d[MAGGI_NDIR], m1_10d[MAGGI_NDIR], m1_11d[MAGGI_NDIR],
      m1_12d[MAGGI_NDIR], m1_13d[MAGGI_NDIR], m1_14d[MAGGI_NDIR], m1_15d[MAGGI_NDIR],
      m1_2d[MAGGI_NDIR], m1_3d[MAGGI_NDIR], m1_4d[MAGGI_NDIR], m1_5d[MAGGI_NDIR], m1_6d[MAGGI_NDIR],
      m1_7d[MAGGI_NDIR], m1_8d[MAGGI_NDIR], m1_9d[MAGGI_NDIR], m1d[MAGGI_NDIR], s0d[MAGGI_NDIR],
      s1d[MAGGI_NDIR], s2d[MAGGI_NDIR], s3d[MAGGI_NDIR], s4d[MAGGI_NDIR], s5d[MAGGI_NDIR],
      sd[MAGGI_NDIR], speed2d[MAGGI_NDIR], steer0d[MAGGI_NDIR], targetd[MAGGI_NDIR],
      torqued[MAGGI_NDIR], x00d[MAGGI_NDIR], x01d[MAGGI_NDIR], x02d[MAGGI_NDIR], x10d[MAGGI_NDIR],
      x11d[MAGGI_NDIR], x12d[MAGGI_NDIR], x20d[MAGGI_NDIR], x21d[MAGGI_NDIR], x22d[MAGGI_NDIR],
      x2_4d[MAGGI_NDIR], x2_5d[MAGGI_NDIR], x2_6d[MAGGI_NDIR], x30d[MAGGI_NDIR], x31d[MAGGI_NDIR],
      x32d[MAGGI_NDIR], x40d[MAGGI_NDIR], x41d[MAGGI_NDIR], x42d[MAGGI_NDIR], x50d[MAGGI_NDIR],
      x51d[MAGGI_NDIR], x52d[MAGGI_NDIR], y00d[MAGGI_NDIR], y01d[MAGGI_NDIR], y02d[MAGGI_NDIR],
      y0_2d[MAGGI_NDIR], y10d[MAGGI_NDIR], y11d[MAGGI_NDIR], y12d[MAGGI_NDIR], y1_2d[MAGGI_NDIR],
      y20d[MAGGI_NDIR], y21d[MAGGI_NDIR], y22d[MAGGI_NDIR], y2_2d[MAGGI_NDIR], y30d[MAGGI_NDIR],
      y31d[MAGGI_NDIR], y32d[MAGGI_NDIR], y40d[MAGGI_NDIR], y41d[MAGGI_NDIR], y42d[MAGGI_NDIR],
      y50d[MAGGI_NDIR], y51d[MAGGI_NDIR], y52d[MAGGI_NDIR], z0d[MAGGI_NDIR];

  (void)tau;
  (void)power;
  (void)nbdirs;
  for (i = 0; i < t->ndriver; ++i) {
    a = t->driverpoint[i];
    b = t->driverorigin[i];
    x0_2 = r[a][0] - r[b][0];
    x1_2 = r[a][1] - r[b][1];
    k = t->driverq[i];
    p_i = p[t->driveradr[i]];
    P[0] = x0_2 + p_i * rv[a][0];
    P[1] = x1_2 + p_i * rv[a][1];
    /* the parameter of the point of the path nearest to P */
    k3 = path_nearest_nodiff(t->np, p, t->driverpath[i], t->drivern[i], P);
    dx = p[t->driverpath[i] + k3 + 1] - p[t->driverpath[i] + k3];
    dy = p[t->driverpath[i] + t->drivern[i] + k3 + 1] - p[t->driverpath[i] + t->drivern[i] + k3];
    t2 = dx * dx + dy * dy;
    t3 = ((P[0] - p[t->driverpath[i] + k3]) * dx + (P[1] - p[t->driverpath[i] + t->drivern[i] + k3])
        * dy) / t2;
    t2inv = 1.0 / t2;
    s0 = path0[t->driverrow[i] + k3][MAGGI_PATH_S] + t3 * (path0[t->driverrow[i] + k3 +
        1][MAGGI_PATH_S] - path0[t->driverrow[i] + k3][MAGGI_PATH_S]);
    /* value and two derivatives at s */
    k4 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s0);
    h = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k4][MAGGI_PATH_S];
    a2 = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - s0;
    c = s0 - path0[t->driverrow[i] + k4][MAGGI_PATH_S];
    m0 = path0[t->driverrow[i] + k4][MAGGI_PATH_X];
    m1 = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_X];
    e = (p[t->driverpath[i] + k4 + 1] - p[t->driverpath[i] + k4]) / h;
    hinv = 1.0 / h;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double dxd, dyd, p_id, t2d, t3d, x0_2d, x1_2d;

      x0_2d = rd[a][0][nd] - rd[b][0][nd];
      x1_2d = rd[a][1][nd] - rd[b][1][nd];
      p_id = pd[t->driveradr[i]][nd];
      Pd[0][nd] = x0_2d + (p_id * rv[a][0] + p_i * rvd[a][0][nd]);
      Pd[1][nd] = x1_2d + (p_id * rv[a][1] + p_i * rvd[a][1][nd]);
      /* where P is nearest to the line through piece k of the polyline, as a part of the piece */
      dxd = pd[t->driverpath[i] + k3 + 1][nd] - pd[t->driverpath[i] + k3][nd];
      dyd = pd[t->driverpath[i] + t->drivern[i] + k3 + 1][nd] - pd[t->driverpath[i] + t->drivern[i]
          + k3][nd];
      t2d = dxd * dx + dx * dxd + (dyd * dy + dy * dyd);
      t3d = ((Pd[0][nd] - pd[t->driverpath[i] + k3][nd]) * dx + (P[0] - p[t->driverpath[i] + k3]) *
          dxd + ((Pd[1][nd] - pd[t->driverpath[i] + t->drivern[i] + k3][nd]) * dy + (P[1] -
          p[t->driverpath[i] + t->drivern[i] + k3]) * dyd) - t3 * t2d) * t2inv;
      s0d[nd] = path0d[t->driverrow[i] + k3][MAGGI_PATH_S][nd] + (t3d * (path0[t->driverrow[i] + k3
          + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k3][MAGGI_PATH_S]) + t3 *
          (path0d[t->driverrow[i] + k3 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k3][MAGGI_PATH_S][nd]));
      hd[nd] = path0d[t->driverrow[i] + k4 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k4][MAGGI_PATH_S][nd];
      a2d[nd] = path0d[t->driverrow[i] + k4 + 1][MAGGI_PATH_S][nd] - s0d[nd];
      cd[nd] = s0d[nd] - path0d[t->driverrow[i] + k4][MAGGI_PATH_S][nd];
      m0d[nd] = path0d[t->driverrow[i] + k4][MAGGI_PATH_X][nd];
      m1d[nd] = path0d[t->driverrow[i] + k4 + 1][MAGGI_PATH_X][nd];
      ed[nd] = (pd[t->driverpath[i] + k4 + 1][nd] - pd[t->driverpath[i] + k4][nd] - e * hd[nd]) *
          hinv;
    }
    if (MAGGI_RE(c) < 0.0) {
      slope = e - h / 6.0 * (2.0 * m0 + m1);
      x00 = p[t->driverpath[i] + k4] + slope * c;
      x01 = slope;
      x02 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double sloped;

        sloped = ed[nd] - (hd[nd] / 6.0 * (2.0 * m0 + m1) + h / 6.0 * (2.0 * m0d[nd] + m1d[nd]));
        x00d[nd] = pd[t->driverpath[i] + k4][nd] + (sloped * c + slope * cd[nd]);
        x01d[nd] = sloped;
        x02d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a2) < 0.0) {
      slope22 = e + h / 6.0 * (m0 + 2.0 * m1);
      x00 = p[t->driverpath[i] + k4 + 1] - slope22 * a2;
      x01 = slope22;
      x02 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope22d;

        slope22d = ed[nd] + (hd[nd] / 6.0 * (m0 + 2.0 * m1) + h / 6.0 * (m0d[nd] + 2.0 * m1d[nd]));
        x00d[nd] = pd[t->driverpath[i] + k4 + 1][nd] - (slope22d * a2 + slope22 * a2d[nd]);
        x01d[nd] = slope22d;
        x02d[nd] = 0.0;
      }
    } else {
      slope22_2 = e - h / 6.0 * (m1 - m0);
      t4 = 6.0 * h;
      t5 = (m0 * a2 * a2 * a2 + m1 * c * c * c) / t4;
      t4inv = 1.0 / t4;
      x00 = t5 + p[t->driverpath[i] + k4] - m0 * h * h / 6.0 + slope22_2 * c;
      t6 = 2.0 * h;
      t7 = (m1 * c * c - m0 * a2 * a2) / t6;
      t6inv = 1.0 / t6;
      x01 = t7 + slope22_2;
      t8 = (m0 * a2 + m1 * c) / h;
      x02 = t8;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope22_2d, t4d, t5d, t6d, t7d, t8d;

        slope22_2d = ed[nd] - (hd[nd] / 6.0 * (m1 - m0) + h / 6.0 * (m1d[nd] - m0d[nd]));
        t4d = 6.0 * hd[nd];
        t5d = (((m0d[nd] * a2 + m0 * a2d[nd]) * a2 + m0 * a2 * a2d[nd]) * a2 + m0 * a2 * a2 *
            a2d[nd] + (((m1d[nd] * c + m1 * cd[nd]) * c + m1 * c * cd[nd]) * c + m1 * c * c *
            cd[nd]) - t5 * t4d) * t4inv;
        x00d[nd] = t5d + pd[t->driverpath[i] + k4][nd] - ((m0d[nd] * h + m0 * hd[nd]) * h + m0 * h *
            hd[nd]) / 6.0 + (slope22_2d * c + slope22_2 * cd[nd]);
        t6d = 2.0 * hd[nd];
        t7d = ((m1d[nd] * c + m1 * cd[nd]) * c + m1 * c * cd[nd] - ((m0d[nd] * a2 + m0 * a2d[nd]) *
            a2 + m0 * a2 * a2d[nd]) - t7 * t6d) * t6inv;
        x01d[nd] = t7d + slope22_2d;
        t8d = (m0d[nd] * a2 + m0 * a2d[nd] + (m1d[nd] * c + m1 * cd[nd]) - t8 * hd[nd]) * hinv;
        x02d[nd] = t8d;
      }
    }
    /* value and two derivatives at s */
    k5 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s0);
    h2 = path0[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k5][MAGGI_PATH_S];
    a3 = path0[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] - s0;
    c2 = s0 - path0[t->driverrow[i] + k5][MAGGI_PATH_S];
    m0_2 = path0[t->driverrow[i] + k5][MAGGI_PATH_Y];
    m1_2 = path0[t->driverrow[i] + k5 + 1][MAGGI_PATH_Y];
    e2 = (p[t->driverpath[i] + t->drivern[i] + k5 + 1] - p[t->driverpath[i] + t->drivern[i] + k5]) /
        h2;
    h2inv = 1.0 / h2;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      h2d[nd] = path0d[t->driverrow[i] + k5 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k5][MAGGI_PATH_S][nd];
      a3d[nd] = path0d[t->driverrow[i] + k5 + 1][MAGGI_PATH_S][nd] - s0d[nd];
      c2d[nd] = s0d[nd] - path0d[t->driverrow[i] + k5][MAGGI_PATH_S][nd];
      m0_2d[nd] = path0d[t->driverrow[i] + k5][MAGGI_PATH_Y][nd];
      m1_2d[nd] = path0d[t->driverrow[i] + k5 + 1][MAGGI_PATH_Y][nd];
      e2d[nd] = (pd[t->driverpath[i] + t->drivern[i] + k5 + 1][nd] - pd[t->driverpath[i] +
          t->drivern[i] + k5][nd] - e2 * h2d[nd]) * h2inv;
    }
    if (MAGGI_RE(c2) < 0.0) {
      slope2 = e2 - h2 / 6.0 * (2.0 * m0_2 + m1_2);
      y00 = p[t->driverpath[i] + t->drivern[i] + k5] + slope2 * c2;
      y01 = slope2;
      y02 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope2d;

        slope2d = e2d[nd] - (h2d[nd] / 6.0 * (2.0 * m0_2 + m1_2) + h2 / 6.0 * (2.0 * m0_2d[nd] +
            m1_2d[nd]));
        y00d[nd] = pd[t->driverpath[i] + t->drivern[i] + k5][nd] + (slope2d * c2 + slope2 *
            c2d[nd]);
        y01d[nd] = slope2d;
        y02d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a3) < 0.0) {
      slope2_2 = e2 + h2 / 6.0 * (m0_2 + 2.0 * m1_2);
      y00 = p[t->driverpath[i] + t->drivern[i] + k5 + 1] - slope2_2 * a3;
      y01 = slope2_2;
      y02 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope2_2d;

        slope2_2d = e2d[nd] + (h2d[nd] / 6.0 * (m0_2 + 2.0 * m1_2) + h2 / 6.0 * (m0_2d[nd] + 2.0 *
            m1_2d[nd]));
        y00d[nd] = pd[t->driverpath[i] + t->drivern[i] + k5 + 1][nd] - (slope2_2d * a3 + slope2_2 *
            a3d[nd]);
        y01d[nd] = slope2_2d;
        y02d[nd] = 0.0;
      }
    } else {
      slope2_3 = e2 - h2 / 6.0 * (m1_2 - m0_2);
      t9 = 6.0 * h2;
      t10 = (m0_2 * a3 * a3 * a3 + m1_2 * c2 * c2 * c2) / t9;
      t9inv = 1.0 / t9;
      y00 = t10 + p[t->driverpath[i] + t->drivern[i] + k5] - m0_2 * h2 * h2 / 6.0 + slope2_3 * c2;
      t11 = 2.0 * h2;
      t12 = (m1_2 * c2 * c2 - m0_2 * a3 * a3) / t11;
      t11inv = 1.0 / t11;
      y01 = t12 + slope2_3;
      t13 = (m0_2 * a3 + m1_2 * c2) / h2;
      y02 = t13;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope2_3d, t10d, t11d, t12d, t13d, t9d;

        slope2_3d = e2d[nd] - (h2d[nd] / 6.0 * (m1_2 - m0_2) + h2 / 6.0 * (m1_2d[nd] - m0_2d[nd]));
        t9d = 6.0 * h2d[nd];
        t10d = (((m0_2d[nd] * a3 + m0_2 * a3d[nd]) * a3 + m0_2 * a3 * a3d[nd]) * a3 + m0_2 * a3 * a3
            * a3d[nd] + (((m1_2d[nd] * c2 + m1_2 * c2d[nd]) * c2 + m1_2 * c2 * c2d[nd]) * c2 + m1_2
            * c2 * c2 * c2d[nd]) - t10 * t9d) * t9inv;
        y00d[nd] = t10d + pd[t->driverpath[i] + t->drivern[i] + k5][nd] - ((m0_2d[nd] * h2 + m0_2 *
            h2d[nd]) * h2 + m0_2 * h2 * h2d[nd]) / 6.0 + (slope2_3d * c2 + slope2_3 * c2d[nd]);
        t11d = 2.0 * h2d[nd];
        t12d = ((m1_2d[nd] * c2 + m1_2 * c2d[nd]) * c2 + m1_2 * c2 * c2d[nd] - ((m0_2d[nd] * a3 +
            m0_2 * a3d[nd]) * a3 + m0_2 * a3 * a3d[nd]) - t12 * t11d) * t11inv;
        y01d[nd] = t12d + slope2_3d;
        t13d = (m0_2d[nd] * a3 + m0_2 * a3d[nd] + (m1_2d[nd] * c2 + m1_2 * c2d[nd]) - t13 * h2d[nd])
            * h2inv;
        y02d[nd] = t13d;
      }
    }
    g = (x00 - P[0]) * x01 + (y00 - P[1]) * y01;
    slope3 = x01 * x01 + y01 * y01 + (x00 - P[0]) * x02 + (y00 - P[1]) * y02;
    t14 = g / slope3;
    slope3inv = 1.0 / slope3;
    s1 = s0 - t14;
    /* value and two derivatives at s */
    k6 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s1);
    h3 = path0[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k6][MAGGI_PATH_S];
    a4 = path0[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] - s1;
    c3 = s1 - path0[t->driverrow[i] + k6][MAGGI_PATH_S];
    m0_3 = path0[t->driverrow[i] + k6][MAGGI_PATH_X];
    m1_3 = path0[t->driverrow[i] + k6 + 1][MAGGI_PATH_X];
    e3 = (p[t->driverpath[i] + k6 + 1] - p[t->driverpath[i] + k6]) / h3;
    h3inv = 1.0 / h3;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double gd, slope3d, t14d;

      /* one step of Newton's method; C, C', C'' at s */
      gd = (x00d[nd] - Pd[0][nd]) * x01 + (x00 - P[0]) * x01d[nd] + ((y00d[nd] - Pd[1][nd]) * y01 +
          (y00 - P[1]) * y01d[nd]);
      slope3d = x01d[nd] * x01 + x01 * x01d[nd] + (y01d[nd] * y01 + y01 * y01d[nd]) + ((x00d[nd] -
          Pd[0][nd]) * x02 + (x00 - P[0]) * x02d[nd]) + ((y00d[nd] - Pd[1][nd]) * y02 + (y00 - P[1])
          * y02d[nd]);
      t14d = (gd - t14 * slope3d) * slope3inv;
      s1d[nd] = s0d[nd] - t14d;
      h3d[nd] = path0d[t->driverrow[i] + k6 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k6][MAGGI_PATH_S][nd];
      a4d[nd] = path0d[t->driverrow[i] + k6 + 1][MAGGI_PATH_S][nd] - s1d[nd];
      c3d[nd] = s1d[nd] - path0d[t->driverrow[i] + k6][MAGGI_PATH_S][nd];
      m0_3d[nd] = path0d[t->driverrow[i] + k6][MAGGI_PATH_X][nd];
      m1_3d[nd] = path0d[t->driverrow[i] + k6 + 1][MAGGI_PATH_X][nd];
      e3d[nd] = (pd[t->driverpath[i] + k6 + 1][nd] - pd[t->driverpath[i] + k6][nd] - e3 * h3d[nd]) *
          h3inv;
    }
    if (MAGGI_RE(c3) < 0.0) {
      slope4 = e3 - h3 / 6.0 * (2.0 * m0_3 + m1_3);
      x10 = p[t->driverpath[i] + k6] + slope4 * c3;
      x11 = slope4;
      x12 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope4d;

        slope4d = e3d[nd] - (h3d[nd] / 6.0 * (2.0 * m0_3 + m1_3) + h3 / 6.0 * (2.0 * m0_3d[nd] +
            m1_3d[nd]));
        x10d[nd] = pd[t->driverpath[i] + k6][nd] + (slope4d * c3 + slope4 * c3d[nd]);
        x11d[nd] = slope4d;
        x12d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a4) < 0.0) {
      slope4_2 = e3 + h3 / 6.0 * (m0_3 + 2.0 * m1_3);
      x10 = p[t->driverpath[i] + k6 + 1] - slope4_2 * a4;
      x11 = slope4_2;
      x12 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope4_2d;

        slope4_2d = e3d[nd] + (h3d[nd] / 6.0 * (m0_3 + 2.0 * m1_3) + h3 / 6.0 * (m0_3d[nd] + 2.0 *
            m1_3d[nd]));
        x10d[nd] = pd[t->driverpath[i] + k6 + 1][nd] - (slope4_2d * a4 + slope4_2 * a4d[nd]);
        x11d[nd] = slope4_2d;
        x12d[nd] = 0.0;
      }
    } else {
      slope4_3 = e3 - h3 / 6.0 * (m1_3 - m0_3);
      t15 = 6.0 * h3;
      t16 = (m0_3 * a4 * a4 * a4 + m1_3 * c3 * c3 * c3) / t15;
      t15inv = 1.0 / t15;
      x10 = t16 + p[t->driverpath[i] + k6] - m0_3 * h3 * h3 / 6.0 + slope4_3 * c3;
      t17 = 2.0 * h3;
      t18 = (m1_3 * c3 * c3 - m0_3 * a4 * a4) / t17;
      t17inv = 1.0 / t17;
      x11 = t18 + slope4_3;
      t19 = (m0_3 * a4 + m1_3 * c3) / h3;
      x12 = t19;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope4_3d, t15d, t16d, t17d, t18d, t19d;

        slope4_3d = e3d[nd] - (h3d[nd] / 6.0 * (m1_3 - m0_3) + h3 / 6.0 * (m1_3d[nd] - m0_3d[nd]));
        t15d = 6.0 * h3d[nd];
        t16d = (((m0_3d[nd] * a4 + m0_3 * a4d[nd]) * a4 + m0_3 * a4 * a4d[nd]) * a4 + m0_3 * a4 * a4
            * a4d[nd] + (((m1_3d[nd] * c3 + m1_3 * c3d[nd]) * c3 + m1_3 * c3 * c3d[nd]) * c3 + m1_3
            * c3 * c3 * c3d[nd]) - t16 * t15d) * t15inv;
        x10d[nd] = t16d + pd[t->driverpath[i] + k6][nd] - ((m0_3d[nd] * h3 + m0_3 * h3d[nd]) * h3 +
            m0_3 * h3 * h3d[nd]) / 6.0 + (slope4_3d * c3 + slope4_3 * c3d[nd]);
        t17d = 2.0 * h3d[nd];
        t18d = ((m1_3d[nd] * c3 + m1_3 * c3d[nd]) * c3 + m1_3 * c3 * c3d[nd] - ((m0_3d[nd] * a4 +
            m0_3 * a4d[nd]) * a4 + m0_3 * a4 * a4d[nd]) - t18 * t17d) * t17inv;
        x11d[nd] = t18d + slope4_3d;
        t19d = (m0_3d[nd] * a4 + m0_3 * a4d[nd] + (m1_3d[nd] * c3 + m1_3 * c3d[nd]) - t19 * h3d[nd])
            * h3inv;
        x12d[nd] = t19d;
      }
    }
    /* value and two derivatives at s */
    k7 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s1);
    h4 = path0[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k7][MAGGI_PATH_S];
    a5 = path0[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] - s1;
    c4 = s1 - path0[t->driverrow[i] + k7][MAGGI_PATH_S];
    m0_4 = path0[t->driverrow[i] + k7][MAGGI_PATH_Y];
    m1_4 = path0[t->driverrow[i] + k7 + 1][MAGGI_PATH_Y];
    e4 = (p[t->driverpath[i] + t->drivern[i] + k7 + 1] - p[t->driverpath[i] + t->drivern[i] + k7]) /
        h4;
    h4inv = 1.0 / h4;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      h4d[nd] = path0d[t->driverrow[i] + k7 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k7][MAGGI_PATH_S][nd];
      a5d[nd] = path0d[t->driverrow[i] + k7 + 1][MAGGI_PATH_S][nd] - s1d[nd];
      c4d[nd] = s1d[nd] - path0d[t->driverrow[i] + k7][MAGGI_PATH_S][nd];
      m0_4d[nd] = path0d[t->driverrow[i] + k7][MAGGI_PATH_Y][nd];
      m1_4d[nd] = path0d[t->driverrow[i] + k7 + 1][MAGGI_PATH_Y][nd];
      e4d[nd] = (pd[t->driverpath[i] + t->drivern[i] + k7 + 1][nd] - pd[t->driverpath[i] +
          t->drivern[i] + k7][nd] - e4 * h4d[nd]) * h4inv;
    }
    if (MAGGI_RE(c4) < 0.0) {
      slope5 = e4 - h4 / 6.0 * (2.0 * m0_4 + m1_4);
      y10 = p[t->driverpath[i] + t->drivern[i] + k7] + slope5 * c4;
      y11 = slope5;
      y12 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope5d;

        slope5d = e4d[nd] - (h4d[nd] / 6.0 * (2.0 * m0_4 + m1_4) + h4 / 6.0 * (2.0 * m0_4d[nd] +
            m1_4d[nd]));
        y10d[nd] = pd[t->driverpath[i] + t->drivern[i] + k7][nd] + (slope5d * c4 + slope5 *
            c4d[nd]);
        y11d[nd] = slope5d;
        y12d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a5) < 0.0) {
      slope5_2 = e4 + h4 / 6.0 * (m0_4 + 2.0 * m1_4);
      y10 = p[t->driverpath[i] + t->drivern[i] + k7 + 1] - slope5_2 * a5;
      y11 = slope5_2;
      y12 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope5_2d;

        slope5_2d = e4d[nd] + (h4d[nd] / 6.0 * (m0_4 + 2.0 * m1_4) + h4 / 6.0 * (m0_4d[nd] + 2.0 *
            m1_4d[nd]));
        y10d[nd] = pd[t->driverpath[i] + t->drivern[i] + k7 + 1][nd] - (slope5_2d * a5 + slope5_2 *
            a5d[nd]);
        y11d[nd] = slope5_2d;
        y12d[nd] = 0.0;
      }
    } else {
      slope5_3 = e4 - h4 / 6.0 * (m1_4 - m0_4);
      t20 = 6.0 * h4;
      t21 = (m0_4 * a5 * a5 * a5 + m1_4 * c4 * c4 * c4) / t20;
      t20inv = 1.0 / t20;
      y10 = t21 + p[t->driverpath[i] + t->drivern[i] + k7] - m0_4 * h4 * h4 / 6.0 + slope5_3 * c4;
      t22 = 2.0 * h4;
      t23 = (m1_4 * c4 * c4 - m0_4 * a5 * a5) / t22;
      t22inv = 1.0 / t22;
      y11 = t23 + slope5_3;
      t24 = (m0_4 * a5 + m1_4 * c4) / h4;
      y12 = t24;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope5_3d, t20d, t21d, t22d, t23d, t24d;

        slope5_3d = e4d[nd] - (h4d[nd] / 6.0 * (m1_4 - m0_4) + h4 / 6.0 * (m1_4d[nd] - m0_4d[nd]));
        t20d = 6.0 * h4d[nd];
        t21d = (((m0_4d[nd] * a5 + m0_4 * a5d[nd]) * a5 + m0_4 * a5 * a5d[nd]) * a5 + m0_4 * a5 * a5
            * a5d[nd] + (((m1_4d[nd] * c4 + m1_4 * c4d[nd]) * c4 + m1_4 * c4 * c4d[nd]) * c4 + m1_4
            * c4 * c4 * c4d[nd]) - t21 * t20d) * t20inv;
        y10d[nd] = t21d + pd[t->driverpath[i] + t->drivern[i] + k7][nd] - ((m0_4d[nd] * h4 + m0_4 *
            h4d[nd]) * h4 + m0_4 * h4 * h4d[nd]) / 6.0 + (slope5_3d * c4 + slope5_3 * c4d[nd]);
        t22d = 2.0 * h4d[nd];
        t23d = ((m1_4d[nd] * c4 + m1_4 * c4d[nd]) * c4 + m1_4 * c4 * c4d[nd] - ((m0_4d[nd] * a5 +
            m0_4 * a5d[nd]) * a5 + m0_4 * a5 * a5d[nd]) - t23 * t22d) * t22inv;
        y11d[nd] = t23d + slope5_3d;
        t24d = (m0_4d[nd] * a5 + m0_4 * a5d[nd] + (m1_4d[nd] * c4 + m1_4 * c4d[nd]) - t24 * h4d[nd])
            * h4inv;
        y12d[nd] = t24d;
      }
    }
    g2 = (x10 - P[0]) * x11 + (y10 - P[1]) * y11;
    slope6 = x11 * x11 + y11 * y11 + (x10 - P[0]) * x12 + (y10 - P[1]) * y12;
    t25 = g2 / slope6;
    slope6inv = 1.0 / slope6;
    s2 = s1 - t25;
    /* value and two derivatives at s */
    k8 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s2);
    h5 = path0[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k8][MAGGI_PATH_S];
    a6 = path0[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] - s2;
    c5 = s2 - path0[t->driverrow[i] + k8][MAGGI_PATH_S];
    m0_5 = path0[t->driverrow[i] + k8][MAGGI_PATH_X];
    m1_5 = path0[t->driverrow[i] + k8 + 1][MAGGI_PATH_X];
    e5 = (p[t->driverpath[i] + k8 + 1] - p[t->driverpath[i] + k8]) / h5;
    h5inv = 1.0 / h5;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double g2d, slope6d, t25d;

      /* one step of Newton's method; C, C', C'' at s */
      g2d = (x10d[nd] - Pd[0][nd]) * x11 + (x10 - P[0]) * x11d[nd] + ((y10d[nd] - Pd[1][nd]) * y11 +
          (y10 - P[1]) * y11d[nd]);
      slope6d = x11d[nd] * x11 + x11 * x11d[nd] + (y11d[nd] * y11 + y11 * y11d[nd]) + ((x10d[nd] -
          Pd[0][nd]) * x12 + (x10 - P[0]) * x12d[nd]) + ((y10d[nd] - Pd[1][nd]) * y12 + (y10 - P[1])
          * y12d[nd]);
      t25d = (g2d - t25 * slope6d) * slope6inv;
      s2d[nd] = s1d[nd] - t25d;
      h5d[nd] = path0d[t->driverrow[i] + k8 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k8][MAGGI_PATH_S][nd];
      a6d[nd] = path0d[t->driverrow[i] + k8 + 1][MAGGI_PATH_S][nd] - s2d[nd];
      c5d[nd] = s2d[nd] - path0d[t->driverrow[i] + k8][MAGGI_PATH_S][nd];
      m0_5d[nd] = path0d[t->driverrow[i] + k8][MAGGI_PATH_X][nd];
      m1_5d[nd] = path0d[t->driverrow[i] + k8 + 1][MAGGI_PATH_X][nd];
      e5d[nd] = (pd[t->driverpath[i] + k8 + 1][nd] - pd[t->driverpath[i] + k8][nd] - e5 * h5d[nd]) *
          h5inv;
    }
    if (MAGGI_RE(c5) < 0.0) {
      slope7 = e5 - h5 / 6.0 * (2.0 * m0_5 + m1_5);
      x2_4 = p[t->driverpath[i] + k8] + slope7 * c5;
      x2_5 = slope7;
      x2_6 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope7d;

        slope7d = e5d[nd] - (h5d[nd] / 6.0 * (2.0 * m0_5 + m1_5) + h5 / 6.0 * (2.0 * m0_5d[nd] +
            m1_5d[nd]));
        x2_4d[nd] = pd[t->driverpath[i] + k8][nd] + (slope7d * c5 + slope7 * c5d[nd]);
        x2_5d[nd] = slope7d;
        x2_6d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a6) < 0.0) {
      slope7_2 = e5 + h5 / 6.0 * (m0_5 + 2.0 * m1_5);
      x2_4 = p[t->driverpath[i] + k8 + 1] - slope7_2 * a6;
      x2_5 = slope7_2;
      x2_6 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope7_2d;

        slope7_2d = e5d[nd] + (h5d[nd] / 6.0 * (m0_5 + 2.0 * m1_5) + h5 / 6.0 * (m0_5d[nd] + 2.0 *
            m1_5d[nd]));
        x2_4d[nd] = pd[t->driverpath[i] + k8 + 1][nd] - (slope7_2d * a6 + slope7_2 * a6d[nd]);
        x2_5d[nd] = slope7_2d;
        x2_6d[nd] = 0.0;
      }
    } else {
      slope7_3 = e5 - h5 / 6.0 * (m1_5 - m0_5);
      t26 = 6.0 * h5;
      t27 = (m0_5 * a6 * a6 * a6 + m1_5 * c5 * c5 * c5) / t26;
      t26inv = 1.0 / t26;
      x2_4 = t27 + p[t->driverpath[i] + k8] - m0_5 * h5 * h5 / 6.0 + slope7_3 * c5;
      t28 = 2.0 * h5;
      t29 = (m1_5 * c5 * c5 - m0_5 * a6 * a6) / t28;
      t28inv = 1.0 / t28;
      x2_5 = t29 + slope7_3;
      t30 = (m0_5 * a6 + m1_5 * c5) / h5;
      x2_6 = t30;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope7_3d, t26d, t27d, t28d, t29d, t30d;

        slope7_3d = e5d[nd] - (h5d[nd] / 6.0 * (m1_5 - m0_5) + h5 / 6.0 * (m1_5d[nd] - m0_5d[nd]));
        t26d = 6.0 * h5d[nd];
        t27d = (((m0_5d[nd] * a6 + m0_5 * a6d[nd]) * a6 + m0_5 * a6 * a6d[nd]) * a6 + m0_5 * a6 * a6
            * a6d[nd] + (((m1_5d[nd] * c5 + m1_5 * c5d[nd]) * c5 + m1_5 * c5 * c5d[nd]) * c5 + m1_5
            * c5 * c5 * c5d[nd]) - t27 * t26d) * t26inv;
        x2_4d[nd] = t27d + pd[t->driverpath[i] + k8][nd] - ((m0_5d[nd] * h5 + m0_5 * h5d[nd]) * h5 +
            m0_5 * h5 * h5d[nd]) / 6.0 + (slope7_3d * c5 + slope7_3 * c5d[nd]);
        t28d = 2.0 * h5d[nd];
        t29d = ((m1_5d[nd] * c5 + m1_5 * c5d[nd]) * c5 + m1_5 * c5 * c5d[nd] - ((m0_5d[nd] * a6 +
            m0_5 * a6d[nd]) * a6 + m0_5 * a6 * a6d[nd]) - t29 * t28d) * t28inv;
        x2_5d[nd] = t29d + slope7_3d;
        t30d = (m0_5d[nd] * a6 + m0_5 * a6d[nd] + (m1_5d[nd] * c5 + m1_5 * c5d[nd]) - t30 * h5d[nd])
            * h5inv;
        x2_6d[nd] = t30d;
      }
    }
    /* value and two derivatives at s */
    k9 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s2);
    h6 = path0[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k9][MAGGI_PATH_S];
    a7 = path0[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] - s2;
    c6 = s2 - path0[t->driverrow[i] + k9][MAGGI_PATH_S];
    m0_6 = path0[t->driverrow[i] + k9][MAGGI_PATH_Y];
    m1_6 = path0[t->driverrow[i] + k9 + 1][MAGGI_PATH_Y];
    e6 = (p[t->driverpath[i] + t->drivern[i] + k9 + 1] - p[t->driverpath[i] + t->drivern[i] + k9]) /
        h6;
    h6inv = 1.0 / h6;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      h6d[nd] = path0d[t->driverrow[i] + k9 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k9][MAGGI_PATH_S][nd];
      a7d[nd] = path0d[t->driverrow[i] + k9 + 1][MAGGI_PATH_S][nd] - s2d[nd];
      c6d[nd] = s2d[nd] - path0d[t->driverrow[i] + k9][MAGGI_PATH_S][nd];
      m0_6d[nd] = path0d[t->driverrow[i] + k9][MAGGI_PATH_Y][nd];
      m1_6d[nd] = path0d[t->driverrow[i] + k9 + 1][MAGGI_PATH_Y][nd];
      e6d[nd] = (pd[t->driverpath[i] + t->drivern[i] + k9 + 1][nd] - pd[t->driverpath[i] +
          t->drivern[i] + k9][nd] - e6 * h6d[nd]) * h6inv;
    }
    if (MAGGI_RE(c6) < 0.0) {
      slope8 = e6 - h6 / 6.0 * (2.0 * m0_6 + m1_6);
      y20 = p[t->driverpath[i] + t->drivern[i] + k9] + slope8 * c6;
      y21 = slope8;
      y22 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope8d;

        slope8d = e6d[nd] - (h6d[nd] / 6.0 * (2.0 * m0_6 + m1_6) + h6 / 6.0 * (2.0 * m0_6d[nd] +
            m1_6d[nd]));
        y20d[nd] = pd[t->driverpath[i] + t->drivern[i] + k9][nd] + (slope8d * c6 + slope8 *
            c6d[nd]);
        y21d[nd] = slope8d;
        y22d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a7) < 0.0) {
      slope8_2 = e6 + h6 / 6.0 * (m0_6 + 2.0 * m1_6);
      y20 = p[t->driverpath[i] + t->drivern[i] + k9 + 1] - slope8_2 * a7;
      y21 = slope8_2;
      y22 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope8_2d;

        slope8_2d = e6d[nd] + (h6d[nd] / 6.0 * (m0_6 + 2.0 * m1_6) + h6 / 6.0 * (m0_6d[nd] + 2.0 *
            m1_6d[nd]));
        y20d[nd] = pd[t->driverpath[i] + t->drivern[i] + k9 + 1][nd] - (slope8_2d * a7 + slope8_2 *
            a7d[nd]);
        y21d[nd] = slope8_2d;
        y22d[nd] = 0.0;
      }
    } else {
      slope8_3 = e6 - h6 / 6.0 * (m1_6 - m0_6);
      t31 = 6.0 * h6;
      t32 = (m0_6 * a7 * a7 * a7 + m1_6 * c6 * c6 * c6) / t31;
      t31inv = 1.0 / t31;
      y20 = t32 + p[t->driverpath[i] + t->drivern[i] + k9] - m0_6 * h6 * h6 / 6.0 + slope8_3 * c6;
      t33 = 2.0 * h6;
      t34 = (m1_6 * c6 * c6 - m0_6 * a7 * a7) / t33;
      t33inv = 1.0 / t33;
      y21 = t34 + slope8_3;
      t35 = (m0_6 * a7 + m1_6 * c6) / h6;
      y22 = t35;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope8_3d, t31d, t32d, t33d, t34d, t35d;

        slope8_3d = e6d[nd] - (h6d[nd] / 6.0 * (m1_6 - m0_6) + h6 / 6.0 * (m1_6d[nd] - m0_6d[nd]));
        t31d = 6.0 * h6d[nd];
        t32d = (((m0_6d[nd] * a7 + m0_6 * a7d[nd]) * a7 + m0_6 * a7 * a7d[nd]) * a7 + m0_6 * a7 * a7
            * a7d[nd] + (((m1_6d[nd] * c6 + m1_6 * c6d[nd]) * c6 + m1_6 * c6 * c6d[nd]) * c6 + m1_6
            * c6 * c6 * c6d[nd]) - t32 * t31d) * t31inv;
        y20d[nd] = t32d + pd[t->driverpath[i] + t->drivern[i] + k9][nd] - ((m0_6d[nd] * h6 + m0_6 *
            h6d[nd]) * h6 + m0_6 * h6 * h6d[nd]) / 6.0 + (slope8_3d * c6 + slope8_3 * c6d[nd]);
        t33d = 2.0 * h6d[nd];
        t34d = ((m1_6d[nd] * c6 + m1_6 * c6d[nd]) * c6 + m1_6 * c6 * c6d[nd] - ((m0_6d[nd] * a7 +
            m0_6 * a7d[nd]) * a7 + m0_6 * a7 * a7d[nd]) - t34 * t33d) * t33inv;
        y21d[nd] = t34d + slope8_3d;
        t35d = (m0_6d[nd] * a7 + m0_6 * a7d[nd] + (m1_6d[nd] * c6 + m1_6 * c6d[nd]) - t35 * h6d[nd])
            * h6inv;
        y22d[nd] = t35d;
      }
    }
    g3 = (x2_4 - P[0]) * x2_5 + (y20 - P[1]) * y21;
    slope9 = x2_5 * x2_5 + y21 * y21 + (x2_4 - P[0]) * x2_6 + (y20 - P[1]) * y22;
    t36 = g3 / slope9;
    slope9inv = 1.0 / slope9;
    s3 = s2 - t36;
    /* value and two derivatives at s */
    k10 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s3);
    h7 = path0[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k10][MAGGI_PATH_S];
    a8 = path0[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] - s3;
    c7 = s3 - path0[t->driverrow[i] + k10][MAGGI_PATH_S];
    m0_7 = path0[t->driverrow[i] + k10][MAGGI_PATH_X];
    m1_7 = path0[t->driverrow[i] + k10 + 1][MAGGI_PATH_X];
    e7 = (p[t->driverpath[i] + k10 + 1] - p[t->driverpath[i] + k10]) / h7;
    h7inv = 1.0 / h7;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double g3d, slope9d, t36d;

      /* one step of Newton's method; C, C', C'' at s */
      g3d = (x2_4d[nd] - Pd[0][nd]) * x2_5 + (x2_4 - P[0]) * x2_5d[nd] + ((y20d[nd] - Pd[1][nd]) *
          y21 + (y20 - P[1]) * y21d[nd]);
      slope9d = x2_5d[nd] * x2_5 + x2_5 * x2_5d[nd] + (y21d[nd] * y21 + y21 * y21d[nd]) +
          ((x2_4d[nd] - Pd[0][nd]) * x2_6 + (x2_4 - P[0]) * x2_6d[nd]) + ((y20d[nd] - Pd[1][nd]) *
          y22 + (y20 - P[1]) * y22d[nd]);
      t36d = (g3d - t36 * slope9d) * slope9inv;
      s3d[nd] = s2d[nd] - t36d;
      h7d[nd] = path0d[t->driverrow[i] + k10 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k10][MAGGI_PATH_S][nd];
      a8d[nd] = path0d[t->driverrow[i] + k10 + 1][MAGGI_PATH_S][nd] - s3d[nd];
      c7d[nd] = s3d[nd] - path0d[t->driverrow[i] + k10][MAGGI_PATH_S][nd];
      m0_7d[nd] = path0d[t->driverrow[i] + k10][MAGGI_PATH_X][nd];
      m1_7d[nd] = path0d[t->driverrow[i] + k10 + 1][MAGGI_PATH_X][nd];
      e7d[nd] = (pd[t->driverpath[i] + k10 + 1][nd] - pd[t->driverpath[i] + k10][nd] - e7 * h7d[nd])
          * h7inv;
    }
    if (MAGGI_RE(c7) < 0.0) {
      slope10 = e7 - h7 / 6.0 * (2.0 * m0_7 + m1_7);
      x30 = p[t->driverpath[i] + k10] + slope10 * c7;
      x31 = slope10;
      x32 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope10d;

        slope10d = e7d[nd] - (h7d[nd] / 6.0 * (2.0 * m0_7 + m1_7) + h7 / 6.0 * (2.0 * m0_7d[nd] +
            m1_7d[nd]));
        x30d[nd] = pd[t->driverpath[i] + k10][nd] + (slope10d * c7 + slope10 * c7d[nd]);
        x31d[nd] = slope10d;
        x32d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a8) < 0.0) {
      slope10_2 = e7 + h7 / 6.0 * (m0_7 + 2.0 * m1_7);
      x30 = p[t->driverpath[i] + k10 + 1] - slope10_2 * a8;
      x31 = slope10_2;
      x32 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope10_2d;

        slope10_2d = e7d[nd] + (h7d[nd] / 6.0 * (m0_7 + 2.0 * m1_7) + h7 / 6.0 * (m0_7d[nd] + 2.0 *
            m1_7d[nd]));
        x30d[nd] = pd[t->driverpath[i] + k10 + 1][nd] - (slope10_2d * a8 + slope10_2 * a8d[nd]);
        x31d[nd] = slope10_2d;
        x32d[nd] = 0.0;
      }
    } else {
      slope10_3 = e7 - h7 / 6.0 * (m1_7 - m0_7);
      t37 = 6.0 * h7;
      t38 = (m0_7 * a8 * a8 * a8 + m1_7 * c7 * c7 * c7) / t37;
      t37inv = 1.0 / t37;
      x30 = t38 + p[t->driverpath[i] + k10] - m0_7 * h7 * h7 / 6.0 + slope10_3 * c7;
      t39 = 2.0 * h7;
      t40 = (m1_7 * c7 * c7 - m0_7 * a8 * a8) / t39;
      t39inv = 1.0 / t39;
      x31 = t40 + slope10_3;
      t41 = (m0_7 * a8 + m1_7 * c7) / h7;
      x32 = t41;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope10_3d, t37d, t38d, t39d, t40d, t41d;

        slope10_3d = e7d[nd] - (h7d[nd] / 6.0 * (m1_7 - m0_7) + h7 / 6.0 * (m1_7d[nd] - m0_7d[nd]));
        t37d = 6.0 * h7d[nd];
        t38d = (((m0_7d[nd] * a8 + m0_7 * a8d[nd]) * a8 + m0_7 * a8 * a8d[nd]) * a8 + m0_7 * a8 * a8
            * a8d[nd] + (((m1_7d[nd] * c7 + m1_7 * c7d[nd]) * c7 + m1_7 * c7 * c7d[nd]) * c7 + m1_7
            * c7 * c7 * c7d[nd]) - t38 * t37d) * t37inv;
        x30d[nd] = t38d + pd[t->driverpath[i] + k10][nd] - ((m0_7d[nd] * h7 + m0_7 * h7d[nd]) * h7 +
            m0_7 * h7 * h7d[nd]) / 6.0 + (slope10_3d * c7 + slope10_3 * c7d[nd]);
        t39d = 2.0 * h7d[nd];
        t40d = ((m1_7d[nd] * c7 + m1_7 * c7d[nd]) * c7 + m1_7 * c7 * c7d[nd] - ((m0_7d[nd] * a8 +
            m0_7 * a8d[nd]) * a8 + m0_7 * a8 * a8d[nd]) - t40 * t39d) * t39inv;
        x31d[nd] = t40d + slope10_3d;
        t41d = (m0_7d[nd] * a8 + m0_7 * a8d[nd] + (m1_7d[nd] * c7 + m1_7 * c7d[nd]) - t41 * h7d[nd])
            * h7inv;
        x32d[nd] = t41d;
      }
    }
    /* value and two derivatives at s */
    k11 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s3);
    h8 = path0[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k11][MAGGI_PATH_S];
    a9 = path0[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] - s3;
    c8 = s3 - path0[t->driverrow[i] + k11][MAGGI_PATH_S];
    m0_8 = path0[t->driverrow[i] + k11][MAGGI_PATH_Y];
    m1_8 = path0[t->driverrow[i] + k11 + 1][MAGGI_PATH_Y];
    e8 = (p[t->driverpath[i] + t->drivern[i] + k11 + 1] - p[t->driverpath[i] + t->drivern[i] + k11])
        / h8;
    h8inv = 1.0 / h8;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      h8d[nd] = path0d[t->driverrow[i] + k11 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k11][MAGGI_PATH_S][nd];
      a9d[nd] = path0d[t->driverrow[i] + k11 + 1][MAGGI_PATH_S][nd] - s3d[nd];
      c8d[nd] = s3d[nd] - path0d[t->driverrow[i] + k11][MAGGI_PATH_S][nd];
      m0_8d[nd] = path0d[t->driverrow[i] + k11][MAGGI_PATH_Y][nd];
      m1_8d[nd] = path0d[t->driverrow[i] + k11 + 1][MAGGI_PATH_Y][nd];
      e8d[nd] = (pd[t->driverpath[i] + t->drivern[i] + k11 + 1][nd] - pd[t->driverpath[i] +
          t->drivern[i] + k11][nd] - e8 * h8d[nd]) * h8inv;
    }
    if (MAGGI_RE(c8) < 0.0) {
      slope11 = e8 - h8 / 6.0 * (2.0 * m0_8 + m1_8);
      y30 = p[t->driverpath[i] + t->drivern[i] + k11] + slope11 * c8;
      y31 = slope11;
      y32 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope11d;

        slope11d = e8d[nd] - (h8d[nd] / 6.0 * (2.0 * m0_8 + m1_8) + h8 / 6.0 * (2.0 * m0_8d[nd] +
            m1_8d[nd]));
        y30d[nd] = pd[t->driverpath[i] + t->drivern[i] + k11][nd] + (slope11d * c8 + slope11 *
            c8d[nd]);
        y31d[nd] = slope11d;
        y32d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a9) < 0.0) {
      slope11_2 = e8 + h8 / 6.0 * (m0_8 + 2.0 * m1_8);
      y30 = p[t->driverpath[i] + t->drivern[i] + k11 + 1] - slope11_2 * a9;
      y31 = slope11_2;
      y32 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope11_2d;

        slope11_2d = e8d[nd] + (h8d[nd] / 6.0 * (m0_8 + 2.0 * m1_8) + h8 / 6.0 * (m0_8d[nd] + 2.0 *
            m1_8d[nd]));
        y30d[nd] = pd[t->driverpath[i] + t->drivern[i] + k11 + 1][nd] - (slope11_2d * a9 + slope11_2
            * a9d[nd]);
        y31d[nd] = slope11_2d;
        y32d[nd] = 0.0;
      }
    } else {
      slope11_3 = e8 - h8 / 6.0 * (m1_8 - m0_8);
      t42 = 6.0 * h8;
      t43 = (m0_8 * a9 * a9 * a9 + m1_8 * c8 * c8 * c8) / t42;
      t42inv = 1.0 / t42;
      y30 = t43 + p[t->driverpath[i] + t->drivern[i] + k11] - m0_8 * h8 * h8 / 6.0 + slope11_3 * c8;
      t44 = 2.0 * h8;
      t45 = (m1_8 * c8 * c8 - m0_8 * a9 * a9) / t44;
      t44inv = 1.0 / t44;
      y31 = t45 + slope11_3;
      t46 = (m0_8 * a9 + m1_8 * c8) / h8;
      y32 = t46;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope11_3d, t42d, t43d, t44d, t45d, t46d;

        slope11_3d = e8d[nd] - (h8d[nd] / 6.0 * (m1_8 - m0_8) + h8 / 6.0 * (m1_8d[nd] - m0_8d[nd]));
        t42d = 6.0 * h8d[nd];
        t43d = (((m0_8d[nd] * a9 + m0_8 * a9d[nd]) * a9 + m0_8 * a9 * a9d[nd]) * a9 + m0_8 * a9 * a9
            * a9d[nd] + (((m1_8d[nd] * c8 + m1_8 * c8d[nd]) * c8 + m1_8 * c8 * c8d[nd]) * c8 + m1_8
            * c8 * c8 * c8d[nd]) - t43 * t42d) * t42inv;
        y30d[nd] = t43d + pd[t->driverpath[i] + t->drivern[i] + k11][nd] - ((m0_8d[nd] * h8 + m0_8 *
            h8d[nd]) * h8 + m0_8 * h8 * h8d[nd]) / 6.0 + (slope11_3d * c8 + slope11_3 * c8d[nd]);
        t44d = 2.0 * h8d[nd];
        t45d = ((m1_8d[nd] * c8 + m1_8 * c8d[nd]) * c8 + m1_8 * c8 * c8d[nd] - ((m0_8d[nd] * a9 +
            m0_8 * a9d[nd]) * a9 + m0_8 * a9 * a9d[nd]) - t45 * t44d) * t44inv;
        y31d[nd] = t45d + slope11_3d;
        t46d = (m0_8d[nd] * a9 + m0_8 * a9d[nd] + (m1_8d[nd] * c8 + m1_8 * c8d[nd]) - t46 * h8d[nd])
            * h8inv;
        y32d[nd] = t46d;
      }
    }
    g4 = (x30 - P[0]) * x31 + (y30 - P[1]) * y31;
    slope12 = x31 * x31 + y31 * y31 + (x30 - P[0]) * x32 + (y30 - P[1]) * y32;
    t47 = g4 / slope12;
    slope12inv = 1.0 / slope12;
    s4 = s3 - t47;
    /* value and two derivatives at s */
    k12 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s4);
    h9 = path0[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k12][MAGGI_PATH_S];
    a10 = path0[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] - s4;
    c9 = s4 - path0[t->driverrow[i] + k12][MAGGI_PATH_S];
    m0_9 = path0[t->driverrow[i] + k12][MAGGI_PATH_X];
    m1_9 = path0[t->driverrow[i] + k12 + 1][MAGGI_PATH_X];
    e9 = (p[t->driverpath[i] + k12 + 1] - p[t->driverpath[i] + k12]) / h9;
    h9inv = 1.0 / h9;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double g4d, slope12d, t47d;

      /* one step of Newton's method; C, C', C'' at s */
      g4d = (x30d[nd] - Pd[0][nd]) * x31 + (x30 - P[0]) * x31d[nd] + ((y30d[nd] - Pd[1][nd]) * y31 +
          (y30 - P[1]) * y31d[nd]);
      slope12d = x31d[nd] * x31 + x31 * x31d[nd] + (y31d[nd] * y31 + y31 * y31d[nd]) + ((x30d[nd] -
          Pd[0][nd]) * x32 + (x30 - P[0]) * x32d[nd]) + ((y30d[nd] - Pd[1][nd]) * y32 + (y30 - P[1])
          * y32d[nd]);
      t47d = (g4d - t47 * slope12d) * slope12inv;
      s4d[nd] = s3d[nd] - t47d;
      h9d[nd] = path0d[t->driverrow[i] + k12 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k12][MAGGI_PATH_S][nd];
      a10d[nd] = path0d[t->driverrow[i] + k12 + 1][MAGGI_PATH_S][nd] - s4d[nd];
      c9d[nd] = s4d[nd] - path0d[t->driverrow[i] + k12][MAGGI_PATH_S][nd];
      m0_9d[nd] = path0d[t->driverrow[i] + k12][MAGGI_PATH_X][nd];
      m1_9d[nd] = path0d[t->driverrow[i] + k12 + 1][MAGGI_PATH_X][nd];
      e9d[nd] = (pd[t->driverpath[i] + k12 + 1][nd] - pd[t->driverpath[i] + k12][nd] - e9 * h9d[nd])
          * h9inv;
    }
    if (MAGGI_RE(c9) < 0.0) {
      slope13 = e9 - h9 / 6.0 * (2.0 * m0_9 + m1_9);
      x40 = p[t->driverpath[i] + k12] + slope13 * c9;
      x41 = slope13;
      x42 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope13d;

        slope13d = e9d[nd] - (h9d[nd] / 6.0 * (2.0 * m0_9 + m1_9) + h9 / 6.0 * (2.0 * m0_9d[nd] +
            m1_9d[nd]));
        x40d[nd] = pd[t->driverpath[i] + k12][nd] + (slope13d * c9 + slope13 * c9d[nd]);
        x41d[nd] = slope13d;
        x42d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a10) < 0.0) {
      slope13_2 = e9 + h9 / 6.0 * (m0_9 + 2.0 * m1_9);
      x40 = p[t->driverpath[i] + k12 + 1] - slope13_2 * a10;
      x41 = slope13_2;
      x42 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope13_2d;

        slope13_2d = e9d[nd] + (h9d[nd] / 6.0 * (m0_9 + 2.0 * m1_9) + h9 / 6.0 * (m0_9d[nd] + 2.0 *
            m1_9d[nd]));
        x40d[nd] = pd[t->driverpath[i] + k12 + 1][nd] - (slope13_2d * a10 + slope13_2 * a10d[nd]);
        x41d[nd] = slope13_2d;
        x42d[nd] = 0.0;
      }
    } else {
      slope13_3 = e9 - h9 / 6.0 * (m1_9 - m0_9);
      t48 = 6.0 * h9;
      t49 = (m0_9 * a10 * a10 * a10 + m1_9 * c9 * c9 * c9) / t48;
      t48inv = 1.0 / t48;
      x40 = t49 + p[t->driverpath[i] + k12] - m0_9 * h9 * h9 / 6.0 + slope13_3 * c9;
      t50 = 2.0 * h9;
      t51 = (m1_9 * c9 * c9 - m0_9 * a10 * a10) / t50;
      t50inv = 1.0 / t50;
      x41 = t51 + slope13_3;
      t52 = (m0_9 * a10 + m1_9 * c9) / h9;
      x42 = t52;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope13_3d, t48d, t49d, t50d, t51d, t52d;

        slope13_3d = e9d[nd] - (h9d[nd] / 6.0 * (m1_9 - m0_9) + h9 / 6.0 * (m1_9d[nd] - m0_9d[nd]));
        t48d = 6.0 * h9d[nd];
        t49d = (((m0_9d[nd] * a10 + m0_9 * a10d[nd]) * a10 + m0_9 * a10 * a10d[nd]) * a10 + m0_9 *
            a10 * a10 * a10d[nd] + (((m1_9d[nd] * c9 + m1_9 * c9d[nd]) * c9 + m1_9 * c9 * c9d[nd]) *
            c9 + m1_9 * c9 * c9 * c9d[nd]) - t49 * t48d) * t48inv;
        x40d[nd] = t49d + pd[t->driverpath[i] + k12][nd] - ((m0_9d[nd] * h9 + m0_9 * h9d[nd]) * h9 +
            m0_9 * h9 * h9d[nd]) / 6.0 + (slope13_3d * c9 + slope13_3 * c9d[nd]);
        t50d = 2.0 * h9d[nd];
        t51d = ((m1_9d[nd] * c9 + m1_9 * c9d[nd]) * c9 + m1_9 * c9 * c9d[nd] - ((m0_9d[nd] * a10 +
            m0_9 * a10d[nd]) * a10 + m0_9 * a10 * a10d[nd]) - t51 * t50d) * t50inv;
        x41d[nd] = t51d + slope13_3d;
        t52d = (m0_9d[nd] * a10 + m0_9 * a10d[nd] + (m1_9d[nd] * c9 + m1_9 * c9d[nd]) - t52 *
            h9d[nd]) * h9inv;
        x42d[nd] = t52d;
      }
    }
    /* value and two derivatives at s */
    k13 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s4);
    h10 = path0[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k13][MAGGI_PATH_S];
    a11 = path0[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] - s4;
    c10 = s4 - path0[t->driverrow[i] + k13][MAGGI_PATH_S];
    m0_10 = path0[t->driverrow[i] + k13][MAGGI_PATH_Y];
    m1_10 = path0[t->driverrow[i] + k13 + 1][MAGGI_PATH_Y];
    e10 = (p[t->driverpath[i] + t->drivern[i] + k13 + 1] - p[t->driverpath[i] + t->drivern[i] +
        k13]) / h10;
    h10inv = 1.0 / h10;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      h10d[nd] = path0d[t->driverrow[i] + k13 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k13][MAGGI_PATH_S][nd];
      a11d[nd] = path0d[t->driverrow[i] + k13 + 1][MAGGI_PATH_S][nd] - s4d[nd];
      c10d[nd] = s4d[nd] - path0d[t->driverrow[i] + k13][MAGGI_PATH_S][nd];
      m0_10d[nd] = path0d[t->driverrow[i] + k13][MAGGI_PATH_Y][nd];
      m1_10d[nd] = path0d[t->driverrow[i] + k13 + 1][MAGGI_PATH_Y][nd];
      e10d[nd] = (pd[t->driverpath[i] + t->drivern[i] + k13 + 1][nd] - pd[t->driverpath[i] +
          t->drivern[i] + k13][nd] - e10 * h10d[nd]) * h10inv;
    }
    if (MAGGI_RE(c10) < 0.0) {
      slope14 = e10 - h10 / 6.0 * (2.0 * m0_10 + m1_10);
      y40 = p[t->driverpath[i] + t->drivern[i] + k13] + slope14 * c10;
      y41 = slope14;
      y42 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope14d;

        slope14d = e10d[nd] - (h10d[nd] / 6.0 * (2.0 * m0_10 + m1_10) + h10 / 6.0 * (2.0 *
            m0_10d[nd] + m1_10d[nd]));
        y40d[nd] = pd[t->driverpath[i] + t->drivern[i] + k13][nd] + (slope14d * c10 + slope14 *
            c10d[nd]);
        y41d[nd] = slope14d;
        y42d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a11) < 0.0) {
      slope14_2 = e10 + h10 / 6.0 * (m0_10 + 2.0 * m1_10);
      y40 = p[t->driverpath[i] + t->drivern[i] + k13 + 1] - slope14_2 * a11;
      y41 = slope14_2;
      y42 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope14_2d;

        slope14_2d = e10d[nd] + (h10d[nd] / 6.0 * (m0_10 + 2.0 * m1_10) + h10 / 6.0 * (m0_10d[nd] +
            2.0 * m1_10d[nd]));
        y40d[nd] = pd[t->driverpath[i] + t->drivern[i] + k13 + 1][nd] - (slope14_2d * a11 +
            slope14_2 * a11d[nd]);
        y41d[nd] = slope14_2d;
        y42d[nd] = 0.0;
      }
    } else {
      slope14_3 = e10 - h10 / 6.0 * (m1_10 - m0_10);
      t53 = 6.0 * h10;
      t54 = (m0_10 * a11 * a11 * a11 + m1_10 * c10 * c10 * c10) / t53;
      t53inv = 1.0 / t53;
      y40 = t54 + p[t->driverpath[i] + t->drivern[i] + k13] - m0_10 * h10 * h10 / 6.0 + slope14_3 *
          c10;
      t55 = 2.0 * h10;
      t56 = (m1_10 * c10 * c10 - m0_10 * a11 * a11) / t55;
      t55inv = 1.0 / t55;
      y41 = t56 + slope14_3;
      t57 = (m0_10 * a11 + m1_10 * c10) / h10;
      y42 = t57;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope14_3d, t53d, t54d, t55d, t56d, t57d;

        slope14_3d = e10d[nd] - (h10d[nd] / 6.0 * (m1_10 - m0_10) + h10 / 6.0 * (m1_10d[nd] -
            m0_10d[nd]));
        t53d = 6.0 * h10d[nd];
        t54d = (((m0_10d[nd] * a11 + m0_10 * a11d[nd]) * a11 + m0_10 * a11 * a11d[nd]) * a11 + m0_10
            * a11 * a11 * a11d[nd] + (((m1_10d[nd] * c10 + m1_10 * c10d[nd]) * c10 + m1_10 * c10 *
            c10d[nd]) * c10 + m1_10 * c10 * c10 * c10d[nd]) - t54 * t53d) * t53inv;
        y40d[nd] = t54d + pd[t->driverpath[i] + t->drivern[i] + k13][nd] - ((m0_10d[nd] * h10 +
            m0_10 * h10d[nd]) * h10 + m0_10 * h10 * h10d[nd]) / 6.0 + (slope14_3d * c10 + slope14_3
            * c10d[nd]);
        t55d = 2.0 * h10d[nd];
        t56d = ((m1_10d[nd] * c10 + m1_10 * c10d[nd]) * c10 + m1_10 * c10 * c10d[nd] - ((m0_10d[nd]
            * a11 + m0_10 * a11d[nd]) * a11 + m0_10 * a11 * a11d[nd]) - t56 * t55d) * t55inv;
        y41d[nd] = t56d + slope14_3d;
        t57d = (m0_10d[nd] * a11 + m0_10 * a11d[nd] + (m1_10d[nd] * c10 + m1_10 * c10d[nd]) - t57 *
            h10d[nd]) * h10inv;
        y42d[nd] = t57d;
      }
    }
    g5 = (x40 - P[0]) * x41 + (y40 - P[1]) * y41;
    slope15 = x41 * x41 + y41 * y41 + (x40 - P[0]) * x42 + (y40 - P[1]) * y42;
    t58 = g5 / slope15;
    slope15inv = 1.0 / slope15;
    s5 = s4 - t58;
    /* value and two derivatives at s */
    k14 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s5);
    h11 = path0[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k14][MAGGI_PATH_S];
    a12 = path0[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] - s5;
    c11 = s5 - path0[t->driverrow[i] + k14][MAGGI_PATH_S];
    m0_11 = path0[t->driverrow[i] + k14][MAGGI_PATH_X];
    m1_11 = path0[t->driverrow[i] + k14 + 1][MAGGI_PATH_X];
    e11 = (p[t->driverpath[i] + k14 + 1] - p[t->driverpath[i] + k14]) / h11;
    h11inv = 1.0 / h11;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double g5d, slope15d, t58d;

      /* one step of Newton's method; C, C', C'' at s */
      g5d = (x40d[nd] - Pd[0][nd]) * x41 + (x40 - P[0]) * x41d[nd] + ((y40d[nd] - Pd[1][nd]) * y41 +
          (y40 - P[1]) * y41d[nd]);
      slope15d = x41d[nd] * x41 + x41 * x41d[nd] + (y41d[nd] * y41 + y41 * y41d[nd]) + ((x40d[nd] -
          Pd[0][nd]) * x42 + (x40 - P[0]) * x42d[nd]) + ((y40d[nd] - Pd[1][nd]) * y42 + (y40 - P[1])
          * y42d[nd]);
      t58d = (g5d - t58 * slope15d) * slope15inv;
      s5d[nd] = s4d[nd] - t58d;
      h11d[nd] = path0d[t->driverrow[i] + k14 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k14][MAGGI_PATH_S][nd];
      a12d[nd] = path0d[t->driverrow[i] + k14 + 1][MAGGI_PATH_S][nd] - s5d[nd];
      c11d[nd] = s5d[nd] - path0d[t->driverrow[i] + k14][MAGGI_PATH_S][nd];
      m0_11d[nd] = path0d[t->driverrow[i] + k14][MAGGI_PATH_X][nd];
      m1_11d[nd] = path0d[t->driverrow[i] + k14 + 1][MAGGI_PATH_X][nd];
      e11d[nd] = (pd[t->driverpath[i] + k14 + 1][nd] - pd[t->driverpath[i] + k14][nd] - e11 *
          h11d[nd]) * h11inv;
    }
    if (MAGGI_RE(c11) < 0.0) {
      slope16 = e11 - h11 / 6.0 * (2.0 * m0_11 + m1_11);
      x50 = p[t->driverpath[i] + k14] + slope16 * c11;
      x51 = slope16;
      x52 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope16d;

        slope16d = e11d[nd] - (h11d[nd] / 6.0 * (2.0 * m0_11 + m1_11) + h11 / 6.0 * (2.0 *
            m0_11d[nd] + m1_11d[nd]));
        x50d[nd] = pd[t->driverpath[i] + k14][nd] + (slope16d * c11 + slope16 * c11d[nd]);
        x51d[nd] = slope16d;
        x52d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a12) < 0.0) {
      slope16_2 = e11 + h11 / 6.0 * (m0_11 + 2.0 * m1_11);
      x50 = p[t->driverpath[i] + k14 + 1] - slope16_2 * a12;
      x51 = slope16_2;
      x52 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope16_2d;

        slope16_2d = e11d[nd] + (h11d[nd] / 6.0 * (m0_11 + 2.0 * m1_11) + h11 / 6.0 * (m0_11d[nd] +
            2.0 * m1_11d[nd]));
        x50d[nd] = pd[t->driverpath[i] + k14 + 1][nd] - (slope16_2d * a12 + slope16_2 * a12d[nd]);
        x51d[nd] = slope16_2d;
        x52d[nd] = 0.0;
      }
    } else {
      slope16_3 = e11 - h11 / 6.0 * (m1_11 - m0_11);
      t59 = 6.0 * h11;
      t60 = (m0_11 * a12 * a12 * a12 + m1_11 * c11 * c11 * c11) / t59;
      t59inv = 1.0 / t59;
      x50 = t60 + p[t->driverpath[i] + k14] - m0_11 * h11 * h11 / 6.0 + slope16_3 * c11;
      t61 = 2.0 * h11;
      t62 = (m1_11 * c11 * c11 - m0_11 * a12 * a12) / t61;
      t61inv = 1.0 / t61;
      x51 = t62 + slope16_3;
      t63 = (m0_11 * a12 + m1_11 * c11) / h11;
      x52 = t63;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope16_3d, t59d, t60d, t61d, t62d, t63d;

        slope16_3d = e11d[nd] - (h11d[nd] / 6.0 * (m1_11 - m0_11) + h11 / 6.0 * (m1_11d[nd] -
            m0_11d[nd]));
        t59d = 6.0 * h11d[nd];
        t60d = (((m0_11d[nd] * a12 + m0_11 * a12d[nd]) * a12 + m0_11 * a12 * a12d[nd]) * a12 + m0_11
            * a12 * a12 * a12d[nd] + (((m1_11d[nd] * c11 + m1_11 * c11d[nd]) * c11 + m1_11 * c11 *
            c11d[nd]) * c11 + m1_11 * c11 * c11 * c11d[nd]) - t60 * t59d) * t59inv;
        x50d[nd] = t60d + pd[t->driverpath[i] + k14][nd] - ((m0_11d[nd] * h11 + m0_11 * h11d[nd]) *
            h11 + m0_11 * h11 * h11d[nd]) / 6.0 + (slope16_3d * c11 + slope16_3 * c11d[nd]);
        t61d = 2.0 * h11d[nd];
        t62d = ((m1_11d[nd] * c11 + m1_11 * c11d[nd]) * c11 + m1_11 * c11 * c11d[nd] - ((m0_11d[nd]
            * a12 + m0_11 * a12d[nd]) * a12 + m0_11 * a12 * a12d[nd]) - t62 * t61d) * t61inv;
        x51d[nd] = t62d + slope16_3d;
        t63d = (m0_11d[nd] * a12 + m0_11 * a12d[nd] + (m1_11d[nd] * c11 + m1_11 * c11d[nd]) - t63 *
            h11d[nd]) * h11inv;
        x52d[nd] = t63d;
      }
    }
    /* value and two derivatives at s */
    k15 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s5);
    h12 = path0[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k15][MAGGI_PATH_S];
    a13 = path0[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] - s5;
    c12 = s5 - path0[t->driverrow[i] + k15][MAGGI_PATH_S];
    m0_12 = path0[t->driverrow[i] + k15][MAGGI_PATH_Y];
    m1_12 = path0[t->driverrow[i] + k15 + 1][MAGGI_PATH_Y];
    e12 = (p[t->driverpath[i] + t->drivern[i] + k15 + 1] - p[t->driverpath[i] + t->drivern[i] +
        k15]) / h12;
    h12inv = 1.0 / h12;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      h12d[nd] = path0d[t->driverrow[i] + k15 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k15][MAGGI_PATH_S][nd];
      a13d[nd] = path0d[t->driverrow[i] + k15 + 1][MAGGI_PATH_S][nd] - s5d[nd];
      c12d[nd] = s5d[nd] - path0d[t->driverrow[i] + k15][MAGGI_PATH_S][nd];
      m0_12d[nd] = path0d[t->driverrow[i] + k15][MAGGI_PATH_Y][nd];
      m1_12d[nd] = path0d[t->driverrow[i] + k15 + 1][MAGGI_PATH_Y][nd];
      e12d[nd] = (pd[t->driverpath[i] + t->drivern[i] + k15 + 1][nd] - pd[t->driverpath[i] +
          t->drivern[i] + k15][nd] - e12 * h12d[nd]) * h12inv;
    }
    if (MAGGI_RE(c12) < 0.0) {
      slope17 = e12 - h12 / 6.0 * (2.0 * m0_12 + m1_12);
      y50 = p[t->driverpath[i] + t->drivern[i] + k15] + slope17 * c12;
      y51 = slope17;
      y52 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope17d;

        slope17d = e12d[nd] - (h12d[nd] / 6.0 * (2.0 * m0_12 + m1_12) + h12 / 6.0 * (2.0 *
            m0_12d[nd] + m1_12d[nd]));
        y50d[nd] = pd[t->driverpath[i] + t->drivern[i] + k15][nd] + (slope17d * c12 + slope17 *
            c12d[nd]);
        y51d[nd] = slope17d;
        y52d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a13) < 0.0) {
      slope17_2 = e12 + h12 / 6.0 * (m0_12 + 2.0 * m1_12);
      y50 = p[t->driverpath[i] + t->drivern[i] + k15 + 1] - slope17_2 * a13;
      y51 = slope17_2;
      y52 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope17_2d;

        slope17_2d = e12d[nd] + (h12d[nd] / 6.0 * (m0_12 + 2.0 * m1_12) + h12 / 6.0 * (m0_12d[nd] +
            2.0 * m1_12d[nd]));
        y50d[nd] = pd[t->driverpath[i] + t->drivern[i] + k15 + 1][nd] - (slope17_2d * a13 +
            slope17_2 * a13d[nd]);
        y51d[nd] = slope17_2d;
        y52d[nd] = 0.0;
      }
    } else {
      slope17_3 = e12 - h12 / 6.0 * (m1_12 - m0_12);
      t64 = 6.0 * h12;
      t65 = (m0_12 * a13 * a13 * a13 + m1_12 * c12 * c12 * c12) / t64;
      t64inv = 1.0 / t64;
      y50 = t65 + p[t->driverpath[i] + t->drivern[i] + k15] - m0_12 * h12 * h12 / 6.0 + slope17_3 *
          c12;
      t66 = 2.0 * h12;
      t67 = (m1_12 * c12 * c12 - m0_12 * a13 * a13) / t66;
      t66inv = 1.0 / t66;
      y51 = t67 + slope17_3;
      t68 = (m0_12 * a13 + m1_12 * c12) / h12;
      y52 = t68;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope17_3d, t64d, t65d, t66d, t67d, t68d;

        slope17_3d = e12d[nd] - (h12d[nd] / 6.0 * (m1_12 - m0_12) + h12 / 6.0 * (m1_12d[nd] -
            m0_12d[nd]));
        t64d = 6.0 * h12d[nd];
        t65d = (((m0_12d[nd] * a13 + m0_12 * a13d[nd]) * a13 + m0_12 * a13 * a13d[nd]) * a13 + m0_12
            * a13 * a13 * a13d[nd] + (((m1_12d[nd] * c12 + m1_12 * c12d[nd]) * c12 + m1_12 * c12 *
            c12d[nd]) * c12 + m1_12 * c12 * c12 * c12d[nd]) - t65 * t64d) * t64inv;
        y50d[nd] = t65d + pd[t->driverpath[i] + t->drivern[i] + k15][nd] - ((m0_12d[nd] * h12 +
            m0_12 * h12d[nd]) * h12 + m0_12 * h12 * h12d[nd]) / 6.0 + (slope17_3d * c12 + slope17_3
            * c12d[nd]);
        t66d = 2.0 * h12d[nd];
        t67d = ((m1_12d[nd] * c12 + m1_12 * c12d[nd]) * c12 + m1_12 * c12 * c12d[nd] - ((m0_12d[nd]
            * a13 + m0_12 * a13d[nd]) * a13 + m0_12 * a13 * a13d[nd]) - t67 * t66d) * t66inv;
        y51d[nd] = t67d + slope17_3d;
        t68d = (m0_12d[nd] * a13 + m0_12 * a13d[nd] + (m1_12d[nd] * c12 + m1_12 * c12d[nd]) - t68 *
            h12d[nd]) * h12inv;
        y52d[nd] = t68d;
      }
    }
    g6 = (x50 - P[0]) * x51 + (y50 - P[1]) * y51;
    slope18 = x51 * x51 + y51 * y51 + (x50 - P[0]) * x52 + (y50 - P[1]) * y52;
    t69 = g6 / slope18;
    slope18inv = 1.0 / slope18;
    s6 = s5 - t69;
    s = s6;
    /* value and two derivatives at s */
    k16 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s);
    h13 = path0[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k16][MAGGI_PATH_S];
    a14 = path0[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] - s;
    c13 = s - path0[t->driverrow[i] + k16][MAGGI_PATH_S];
    m0_13 = path0[t->driverrow[i] + k16][MAGGI_PATH_X];
    m1_13 = path0[t->driverrow[i] + k16 + 1][MAGGI_PATH_X];
    e13 = (p[t->driverpath[i] + k16 + 1] - p[t->driverpath[i] + k16]) / h13;
    h13inv = 1.0 / h13;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double g6d, s6d, slope18d, t69d;

      /* one step of Newton's method; C, C', C'' at s */
      g6d = (x50d[nd] - Pd[0][nd]) * x51 + (x50 - P[0]) * x51d[nd] + ((y50d[nd] - Pd[1][nd]) * y51 +
          (y50 - P[1]) * y51d[nd]);
      slope18d = x51d[nd] * x51 + x51 * x51d[nd] + (y51d[nd] * y51 + y51 * y51d[nd]) + ((x50d[nd] -
          Pd[0][nd]) * x52 + (x50 - P[0]) * x52d[nd]) + ((y50d[nd] - Pd[1][nd]) * y52 + (y50 - P[1])
          * y52d[nd]);
      t69d = (g6d - t69 * slope18d) * slope18inv;
      s6d = s5d[nd] - t69d;
      sd[nd] = s6d;
      h13d[nd] = path0d[t->driverrow[i] + k16 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k16][MAGGI_PATH_S][nd];
      a14d[nd] = path0d[t->driverrow[i] + k16 + 1][MAGGI_PATH_S][nd] - sd[nd];
      c13d[nd] = sd[nd] - path0d[t->driverrow[i] + k16][MAGGI_PATH_S][nd];
      m0_13d[nd] = path0d[t->driverrow[i] + k16][MAGGI_PATH_X][nd];
      m1_13d[nd] = path0d[t->driverrow[i] + k16 + 1][MAGGI_PATH_X][nd];
      e13d[nd] = (pd[t->driverpath[i] + k16 + 1][nd] - pd[t->driverpath[i] + k16][nd] - e13 *
          h13d[nd]) * h13inv;
    }
    if (MAGGI_RE(c13) < 0.0) {
      slope19 = e13 - h13 / 6.0 * (2.0 * m0_13 + m1_13);
      x20 = p[t->driverpath[i] + k16] + slope19 * c13;
      x21 = slope19;
      x22 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope19d;

        slope19d = e13d[nd] - (h13d[nd] / 6.0 * (2.0 * m0_13 + m1_13) + h13 / 6.0 * (2.0 *
            m0_13d[nd] + m1_13d[nd]));
        x20d[nd] = pd[t->driverpath[i] + k16][nd] + (slope19d * c13 + slope19 * c13d[nd]);
        x21d[nd] = slope19d;
        x22d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a14) < 0.0) {
      slope19_2 = e13 + h13 / 6.0 * (m0_13 + 2.0 * m1_13);
      x20 = p[t->driverpath[i] + k16 + 1] - slope19_2 * a14;
      x21 = slope19_2;
      x22 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope19_2d;

        slope19_2d = e13d[nd] + (h13d[nd] / 6.0 * (m0_13 + 2.0 * m1_13) + h13 / 6.0 * (m0_13d[nd] +
            2.0 * m1_13d[nd]));
        x20d[nd] = pd[t->driverpath[i] + k16 + 1][nd] - (slope19_2d * a14 + slope19_2 * a14d[nd]);
        x21d[nd] = slope19_2d;
        x22d[nd] = 0.0;
      }
    } else {
      slope19_3 = e13 - h13 / 6.0 * (m1_13 - m0_13);
      t70 = 6.0 * h13;
      t71 = (m0_13 * a14 * a14 * a14 + m1_13 * c13 * c13 * c13) / t70;
      t70inv = 1.0 / t70;
      x20 = t71 + p[t->driverpath[i] + k16] - m0_13 * h13 * h13 / 6.0 + slope19_3 * c13;
      t72 = 2.0 * h13;
      t73 = (m1_13 * c13 * c13 - m0_13 * a14 * a14) / t72;
      t72inv = 1.0 / t72;
      x21 = t73 + slope19_3;
      t74 = (m0_13 * a14 + m1_13 * c13) / h13;
      x22 = t74;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope19_3d, t70d, t71d, t72d, t73d, t74d;

        slope19_3d = e13d[nd] - (h13d[nd] / 6.0 * (m1_13 - m0_13) + h13 / 6.0 * (m1_13d[nd] -
            m0_13d[nd]));
        t70d = 6.0 * h13d[nd];
        t71d = (((m0_13d[nd] * a14 + m0_13 * a14d[nd]) * a14 + m0_13 * a14 * a14d[nd]) * a14 + m0_13
            * a14 * a14 * a14d[nd] + (((m1_13d[nd] * c13 + m1_13 * c13d[nd]) * c13 + m1_13 * c13 *
            c13d[nd]) * c13 + m1_13 * c13 * c13 * c13d[nd]) - t71 * t70d) * t70inv;
        x20d[nd] = t71d + pd[t->driverpath[i] + k16][nd] - ((m0_13d[nd] * h13 + m0_13 * h13d[nd]) *
            h13 + m0_13 * h13 * h13d[nd]) / 6.0 + (slope19_3d * c13 + slope19_3 * c13d[nd]);
        t72d = 2.0 * h13d[nd];
        t73d = ((m1_13d[nd] * c13 + m1_13 * c13d[nd]) * c13 + m1_13 * c13 * c13d[nd] - ((m0_13d[nd]
            * a14 + m0_13 * a14d[nd]) * a14 + m0_13 * a14 * a14d[nd]) - t73 * t72d) * t72inv;
        x21d[nd] = t73d + slope19_3d;
        t74d = (m0_13d[nd] * a14 + m0_13 * a14d[nd] + (m1_13d[nd] * c13 + m1_13 * c13d[nd]) - t74 *
            h13d[nd]) * h13inv;
        x22d[nd] = t74d;
      }
    }
    /* value and two derivatives at s */
    k17 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s);
    h14 = path0[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k17][MAGGI_PATH_S];
    a15 = path0[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] - s;
    c14 = s - path0[t->driverrow[i] + k17][MAGGI_PATH_S];
    m0_14 = path0[t->driverrow[i] + k17][MAGGI_PATH_Y];
    m1_14 = path0[t->driverrow[i] + k17 + 1][MAGGI_PATH_Y];
    e14 = (p[t->driverpath[i] + t->drivern[i] + k17 + 1] - p[t->driverpath[i] + t->drivern[i] +
        k17]) / h14;
    h14inv = 1.0 / h14;
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      h14d[nd] = path0d[t->driverrow[i] + k17 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
          k17][MAGGI_PATH_S][nd];
      a15d[nd] = path0d[t->driverrow[i] + k17 + 1][MAGGI_PATH_S][nd] - sd[nd];
      c14d[nd] = sd[nd] - path0d[t->driverrow[i] + k17][MAGGI_PATH_S][nd];
      m0_14d[nd] = path0d[t->driverrow[i] + k17][MAGGI_PATH_Y][nd];
      m1_14d[nd] = path0d[t->driverrow[i] + k17 + 1][MAGGI_PATH_Y][nd];
      e14d[nd] = (pd[t->driverpath[i] + t->drivern[i] + k17 + 1][nd] - pd[t->driverpath[i] +
          t->drivern[i] + k17][nd] - e14 * h14d[nd]) * h14inv;
    }
    if (MAGGI_RE(c14) < 0.0) {
      slope20 = e14 - h14 / 6.0 * (2.0 * m0_14 + m1_14);
      y0_2 = p[t->driverpath[i] + t->drivern[i] + k17] + slope20 * c14;
      y1_2 = slope20;
      y2_2 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope20d;

        slope20d = e14d[nd] - (h14d[nd] / 6.0 * (2.0 * m0_14 + m1_14) + h14 / 6.0 * (2.0 *
            m0_14d[nd] + m1_14d[nd]));
        y0_2d[nd] = pd[t->driverpath[i] + t->drivern[i] + k17][nd] + (slope20d * c14 + slope20 *
            c14d[nd]);
        y1_2d[nd] = slope20d;
        y2_2d[nd] = 0.0;
      }
    } else if (MAGGI_RE(a15) < 0.0) {
      slope20_2 = e14 + h14 / 6.0 * (m0_14 + 2.0 * m1_14);
      y0_2 = p[t->driverpath[i] + t->drivern[i] + k17 + 1] - slope20_2 * a15;
      y1_2 = slope20_2;
      y2_2 = 0.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope20_2d;

        slope20_2d = e14d[nd] + (h14d[nd] / 6.0 * (m0_14 + 2.0 * m1_14) + h14 / 6.0 * (m0_14d[nd] +
            2.0 * m1_14d[nd]));
        y0_2d[nd] = pd[t->driverpath[i] + t->drivern[i] + k17 + 1][nd] - (slope20_2d * a15 +
            slope20_2 * a15d[nd]);
        y1_2d[nd] = slope20_2d;
        y2_2d[nd] = 0.0;
      }
    } else {
      slope20_3 = e14 - h14 / 6.0 * (m1_14 - m0_14);
      t75 = 6.0 * h14;
      t76 = (m0_14 * a15 * a15 * a15 + m1_14 * c14 * c14 * c14) / t75;
      t75inv = 1.0 / t75;
      y0_2 = t76 + p[t->driverpath[i] + t->drivern[i] + k17] - m0_14 * h14 * h14 / 6.0 + slope20_3 *
          c14;
      t77 = 2.0 * h14;
      t78 = (m1_14 * c14 * c14 - m0_14 * a15 * a15) / t77;
      t77inv = 1.0 / t77;
      y1_2 = t78 + slope20_3;
      t79 = (m0_14 * a15 + m1_14 * c14) / h14;
      y2_2 = t79;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double slope20_3d, t75d, t76d, t77d, t78d, t79d;

        slope20_3d = e14d[nd] - (h14d[nd] / 6.0 * (m1_14 - m0_14) + h14 / 6.0 * (m1_14d[nd] -
            m0_14d[nd]));
        t75d = 6.0 * h14d[nd];
        t76d = (((m0_14d[nd] * a15 + m0_14 * a15d[nd]) * a15 + m0_14 * a15 * a15d[nd]) * a15 + m0_14
            * a15 * a15 * a15d[nd] + (((m1_14d[nd] * c14 + m1_14 * c14d[nd]) * c14 + m1_14 * c14 *
            c14d[nd]) * c14 + m1_14 * c14 * c14 * c14d[nd]) - t76 * t75d) * t75inv;
        y0_2d[nd] = t76d + pd[t->driverpath[i] + t->drivern[i] + k17][nd] - ((m0_14d[nd] * h14 +
            m0_14 * h14d[nd]) * h14 + m0_14 * h14 * h14d[nd]) / 6.0 + (slope20_3d * c14 + slope20_3
            * c14d[nd]);
        t77d = 2.0 * h14d[nd];
        t78d = ((m1_14d[nd] * c14 + m1_14 * c14d[nd]) * c14 + m1_14 * c14 * c14d[nd] - ((m0_14d[nd]
            * a15 + m0_14 * a15d[nd]) * a15 + m0_14 * a15 * a15d[nd]) - t78 * t77d) * t77inv;
        y1_2d[nd] = t78d + slope20_3d;
        t79d = (m0_14d[nd] * a15 + m0_14 * a15d[nd] + (m1_14d[nd] * c14 + m1_14 * c14d[nd]) - t79 *
            h14d[nd]) * h14inv;
        y2_2d[nd] = t79d;
      }
    }
    t80 = x21 * x21 + y1_2 * y1_2;
    length = sqrt(t80);
    c16 = 1.0 / (2.0 * length);
    error = driver[i][0];
    lengthinv = 1.0 / length;
    t81 = length * length * length;
    curvature = (x21 * y2_2 - y1_2 * x22) / t81;
    t81inv = 1.0 / t81;
    limit = p[t->driveradr[i] + MAGGI_DRIVER_LIMIT];
    t82 = (p[t->driveradr[i] + MAGGI_DRIVER_GAIN] * error + p[t->driveradr[i] +
        MAGGI_DRIVER_FEEDFORWARD] * curvature) / limit;
    limitinv = 1.0 / limit;
    t83 = tanh(t82);
    demand = driver[i][2];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double curvatured, demandd, errord, lengthd, limitd, t80d, t81d, t82d, t83d;

      t80d = x21d[nd] * x21 + x21 * x21d[nd] + (y1_2d[nd] * y1_2 + y1_2 * y1_2d[nd]);
      lengthd = c16 * t80d;
      errord = ((y0_2d[nd] - Pd[1][nd]) * x21 + (y0_2 - P[1]) * x21d[nd] - ((x20d[nd] - Pd[0][nd]) *
          y1_2 + (x20 - P[0]) * y1_2d[nd]) - error * lengthd) * lengthinv;
      t81d = (lengthd * length + length * lengthd) * length + length * length * lengthd;
      curvatured = (x21d[nd] * y2_2 + x21 * y2_2d[nd] - (y1_2d[nd] * x22 + y1_2 * x22d[nd]) -
          curvature * t81d) * t81inv;
      limitd = pd[t->driveradr[i] + MAGGI_DRIVER_LIMIT][nd];
      t82d = (pd[t->driveradr[i] + MAGGI_DRIVER_GAIN][nd] * error + p[t->driveradr[i] +
          MAGGI_DRIVER_GAIN] * errord + (pd[t->driveradr[i] + MAGGI_DRIVER_FEEDFORWARD][nd] *
          curvature + p[t->driveradr[i] + MAGGI_DRIVER_FEEDFORWARD] * curvatured) - t82 * limitd) *
          limitinv;
      t83d = (1.0 - t83 * t83) * t82d;
      demandd = limitd * t83 + limit * t83d;
      steer0d[nd] = pd[t->driveradr[i] + MAGGI_DRIVER_STIFFNESS][nd] * (demand - q[k]) +
          p[t->driveradr[i] + MAGGI_DRIVER_STIFFNESS] * (demandd - qd[k][nd]) - (pd[t->driveradr[i]
          + MAGGI_DRIVER_DAMPING][nd] * v[k] + p[t->driveradr[i] + MAGGI_DRIVER_DAMPING] *
          vd[k][nd]);
      driverd[i][0][nd] = errord;
      driverd[i][1][nd] = sd[nd];
      driverd[i][2][nd] = demandd;
    }
    if (t->driverspeeds[i]) {
      /* value and two derivatives at s */
      k18 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s);
      h15 = path0[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
          k18][MAGGI_PATH_S];
      a16 = path0[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] - s;
      c15 = s - path0[t->driverrow[i] + k18][MAGGI_PATH_S];
      m0_15 = path0[t->driverrow[i] + k18][MAGGI_PATH_V];
      m1_15 = path0[t->driverrow[i] + k18 + 1][MAGGI_PATH_V];
      e15 = (p[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] - p[t->driverpath[i] + 2 *
          t->drivern[i] + k18]) / h15;
      h15inv = 1.0 / h15;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        h15d[nd] = path0d[t->driverrow[i] + k18 + 1][MAGGI_PATH_S][nd] - path0d[t->driverrow[i] +
            k18][MAGGI_PATH_S][nd];
        a16d[nd] = path0d[t->driverrow[i] + k18 + 1][MAGGI_PATH_S][nd] - sd[nd];
        c15d[nd] = sd[nd] - path0d[t->driverrow[i] + k18][MAGGI_PATH_S][nd];
        m0_15d[nd] = path0d[t->driverrow[i] + k18][MAGGI_PATH_V][nd];
        m1_15d[nd] = path0d[t->driverrow[i] + k18 + 1][MAGGI_PATH_V][nd];
        e15d[nd] = (pd[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1][nd] - pd[t->driverpath[i] + 2
            * t->drivern[i] + k18][nd] - e15 * h15d[nd]) * h15inv;
      }
      if (MAGGI_RE(c15) < 0.0) {
        slope21 = e15 - h15 / 6.0 * (2.0 * m0_15 + m1_15);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double slope21d;

          slope21d = e15d[nd] - (h15d[nd] / 6.0 * (2.0 * m0_15 + m1_15) + h15 / 6.0 * (2.0 *
              m0_15d[nd] + m1_15d[nd]));
          z0d[nd] = pd[t->driverpath[i] + 2 * t->drivern[i] + k18][nd] + (slope21d * c15 + slope21 *
              c15d[nd]);
        }
      } else if (MAGGI_RE(a16) < 0.0) {
        slope21_2 = e15 + h15 / 6.0 * (m0_15 + 2.0 * m1_15);
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double slope21_2d;

          slope21_2d = e15d[nd] + (h15d[nd] / 6.0 * (m0_15 + 2.0 * m1_15) + h15 / 6.0 * (m0_15d[nd]
              + 2.0 * m1_15d[nd]));
          z0d[nd] = pd[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1][nd] - (slope21_2d * a16 +
              slope21_2 * a16d[nd]);
        }
      } else {
        slope21_3 = e15 - h15 / 6.0 * (m1_15 - m0_15);
        t84 = 6.0 * h15;
        t85 = (m0_15 * a16 * a16 * a16 + m1_15 * c15 * c15 * c15) / t84;
        t84inv = 1.0 / t84;
#pragma omp simd
        for (nd = 0; nd < MAGGI_NDIR; ++nd) {
          double slope21_3d, t84d, t85d;

          slope21_3d = e15d[nd] - (h15d[nd] / 6.0 * (m1_15 - m0_15) + h15 / 6.0 * (m1_15d[nd] -
              m0_15d[nd]));
          t84d = 6.0 * h15d[nd];
          t85d = (((m0_15d[nd] * a16 + m0_15 * a16d[nd]) * a16 + m0_15 * a16 * a16d[nd]) * a16 +
              m0_15 * a16 * a16 * a16d[nd] + (((m1_15d[nd] * c15 + m1_15 * c15d[nd]) * c15 + m1_15 *
              c15 * c15d[nd]) * c15 + m1_15 * c15 * c15 * c15d[nd]) - t85 * t84d) * t84inv;
          z0d[nd] = t85d + pd[t->driverpath[i] + 2 * t->drivern[i] + k18][nd] - ((m0_15d[nd] * h15 +
              m0_15 * h15d[nd]) * h15 + m0_15 * h15 * h15d[nd]) / 6.0 + (slope21_3d * c15 +
              slope21_3 * c15d[nd]);
        }
      }
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        driverd[i][3][nd] = z0d[nd];
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        driverd[i][3][nd] = 0.0;
      }
    }
    if (t->driverheld[i] == 0) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        taud[k][nd] += steer0d[nd];
      }
    }
  }
  for (i = 0; i < t->nspeed; ++i) {
    if (t->speedfun[i] >= 0) {
      factor = fun[t->speedfun[i]][0];
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        factord[nd] = fund[t->speedfun[i]][0][nd];
      }
    } else {
      factor = 1.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        factord[nd] = 0.0;
      }
    }
    if (t->speeddriver[i] >= 0) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        targetd[nd] = driverd[t->speeddriver[i]][3][nd] * factor + driver[t->speeddriver[i]][3] *
            factord[nd];
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        targetd[nd] = pd[t->speedadr[i]][nd] * factor + p[t->speedadr[i]] * factord[nd];
      }
    }
    rv_i0 = rv[t->speedpoint[i]][0];
    rv_i1 = rv[t->speedpoint[i]][1];
    rv_i2 = rv[t->speedpoint[i]][2];
    p2 = p[t->speedadr[i] + MAGGI_SPEED_LOW];
    speed2 = speed[i][2];
    c17 = 1.0 / (2.0 * speed2);
    e16 = speed[i][0];
    gain = p[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      double p2d, rv_i0d, rv_i1d, rv_i2d, t86d;

      rv_i0d = rvd[t->speedpoint[i]][0][nd];
      rv_i1d = rvd[t->speedpoint[i]][1][nd];
      rv_i2d = rvd[t->speedpoint[i]][2][nd];
      p2d = pd[t->speedadr[i] + MAGGI_SPEED_LOW][nd];
      /* error, torque on each coordinate, speed */
      t86d = rv_i0d * rv_i0 + rv_i0 * rv_i0d + (rv_i1d * rv_i1 + rv_i1 * rv_i1d) + (rv_i2d * rv_i2 +
          rv_i2 * rv_i2d) + (p2d * p2 + p2 * p2d);
      speed2d[nd] = c17 * t86d;
      e16d[nd] = targetd[nd] - speed2d[nd];
      gaind[nd] = pd[t->speedadr[i] + MAGGI_SPEED_GAIN][nd] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE]
          + p[t->speedadr[i] + MAGGI_SPEED_GAIN] * pd[t->speedadr[i] + MAGGI_SPEED_TORQUE][nd];
      speedd[i][0][nd] = e16d[nd];
    }
    if (t->speedlinear[i]) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        speedd[i][1][nd] = gaind[nd] * e16 + gain * e16d[nd];
      }
    } else {
      t87 = fabs(e16);
      c18 = MAGGI_RE(e16) < 0.0 ? -1.0 : 1.0;
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        double t87d;

        t87d = c18 * e16d[nd];
        speedd[i][1][nd] = (gaind[nd] * e16 + gain * e16d[nd]) * t87 + gain * e16 * t87d;
      }
    }
#pragma omp simd
    for (nd = 0; nd < MAGGI_NDIR; ++nd) {
      speedd[i][2][nd] = speed2d[nd];
    }
    if (t->speedheld[i]) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        torqued[nd] = 0.0;
      }
    } else {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        torqued[nd] = speedd[i][1][nd];
      }
    }
    for (k19 = t->speedqadr[i]; k19 < t->speedqadr[i] + t->speedqnum[i]; ++k19) {
#pragma omp simd
      for (nd = 0; nd < MAGGI_NDIR; ++nd) {
        taud[t->speedq[k19]][nd] += torqued[nd];
      }
    }
  }
}
