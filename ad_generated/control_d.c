/* Tangent of core/kernel/control.c.
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
void maggi_control_forces_d(const maggi_topo *t, const double p[restrict t->np],
                            const double pd[restrict t->np], const double fun[restrict t->nfun][3],
                            const double fund[restrict t->nfun][3],
                            const double path0[restrict t->npath0][8],
                            const double path0d[restrict t->npath0][8],
                            const double q[restrict t->nq], const double qd[restrict t->nq],
                            const double v[restrict t->nq], const double vd[restrict t->nq],
                            const double r[restrict t->npoint][3],
                            const double rd[restrict t->npoint][3],
                            const double rv[restrict t->npoint][3],
                            const double rvd[restrict t->npoint][3],
                            double driver[restrict t->ndriver][4],
                            double driverd[restrict t->ndriver][4],
                            double speed[restrict t->nspeed][3],
                            double speedd[restrict t->nspeed][3], double tau[restrict t->nq],
                            double taud[restrict t->nq], double power[restrict 1])
{
  int a, b, i, k, k10, k11, k12, k13, k14, k15, k16, k17, k18, k19, k3, k4, k5, k6, k7, k8, k9;
  double a10, a10d, a11, a11d, a12, a12d, a13, a13d, a14, a14d, a15, a15d, a16, a16d, a2, a2d, a3,
      a3d, a4, a4d, a5, a5d, a6, a6d, a7, a7d, a8, a8d, a9, a9d, c, c10, c10d, c11, c11d, c12, c12d,
      c13, c13d, c14, c14d, c15, c15d, c16, c17, c18, c2, c2d, c3, c3d, c4, c4d, c5, c5d, c6, c6d,
      c7, c7d, c8, c8d, c9, c9d, cd, curvature, curvatured, demand, demandd, dx, dxd, dy, dyd, e,
      e10, e10d, e11, e11d, e12, e12d, e13, e13d, e14, e14d, e15, e15d, e16, e16d, e2, e2d, e3, e3d,
      e4, e4d, e5, e5d, e6, e6d, e7, e7d, e8, e8d, e9, e9d, ed, error, errord, factor, factord, g,
      g2, g2d, g3, g3d, g4, g4d, g5, g5d, g6, g6d, gain, gaind, gd, h, h10, h10d, h10inv, h11, h11d,
      h11inv, h12, h12d, h12inv, h13, h13d, h13inv, h14, h14d, h14inv, h15, h15d, h15inv, h2, h2d,
      h2inv, h3, h3d, h3inv, h4, h4d, h4inv, h5, h5d, h5inv, h6, h6d, h6inv, h7, h7d, h7inv, h8,
      h8d, h8inv, h9, h9d, h9inv, hd, hinv, length, lengthd, lengthinv, limit, limitd, limitinv, m0,
      m0_10, m0_10d, m0_11, m0_11d, m0_12, m0_12d, m0_13, m0_13d, m0_14, m0_14d, m0_15, m0_15d,
      m0_2, m0_2d, m0_3, m0_3d, m0_4, m0_4d, m0_5, m0_5d, m0_6, m0_6d, m0_7, m0_7d, m0_8, m0_8d,
      m0_9, m0_9d, m0d, m1, m1_10, m1_10d, m1_11, m1_11d, m1_12, m1_12d, m1_13, m1_13d, m1_14,
      m1_14d, m1_15, m1_15d, m1_2, m1_2d, m1_3, m1_3d, m1_4, m1_4d, m1_5, m1_5d, m1_6, m1_6d, m1_7,
      m1_7d, m1_8, m1_8d, m1_9, m1_9d, m1d, p2, p2d, p_i, p_id, rv_i0, rv_i0d, rv_i1, rv_i1d, rv_i2,
      rv_i2d, s, s0, s0d, s1, s1d, s2, s2d, s3, s3d, s4, s4d, s5, s5d, s6, s6d, sd, slope, slope10,
      slope10_2, slope10_2d, slope10_3, slope10_3d, slope10d, slope11, slope11_2, slope11_2d,
      slope11_3, slope11_3d, slope11d, slope12, slope12d, slope12inv, slope13, slope13_2,
      slope13_2d, slope13_3, slope13_3d, slope13d, slope14, slope14_2, slope14_2d, slope14_3,
      slope14_3d, slope14d, slope15, slope15d, slope15inv, slope16, slope16_2, slope16_2d,
      slope16_3, slope16_3d, slope16d, slope17, slope17_2, slope17_2d, slope17_3, slope17_3d,
      slope17d, slope18, slope18d, slope18inv, slope19, slope19_2, slope19_2d, slope19_3,
      slope19_3d, slope19d, slope2, slope20, slope20_2, slope20_2d, slope20_3, slope20_3d, slope20d,
      slope21, slope21_2, slope21_2d, slope21_3, slope21_3d, slope21d, slope22, slope22_2,
      slope22_2d, slope22d, slope2_2, slope2_2d, slope2_3, slope2_3d, slope2d, slope3, slope3d,
      slope3inv, slope4, slope4_2, slope4_2d, slope4_3, slope4_3d, slope4d, slope5, slope5_2,
      slope5_2d, slope5_3, slope5_3d, slope5d, slope6, slope6d, slope6inv, slope7, slope7_2,
      slope7_2d, slope7_3, slope7_3d, slope7d, slope8, slope8_2, slope8_2d, slope8_3, slope8_3d,
      slope8d, slope9, slope9d, slope9inv, sloped, speed2, speed2d, steer0d, t10, t10d, t11, t11d,
      t11inv, t12, t12d, t13, t13d, t14, t14d, t15, t15d, t15inv, t16, t16d, t17, t17d, t17inv, t18,
      t18d, t19, t19d, t2, t20, t20d, t20inv, t21, t21d, t22, t22d, t22inv, t23, t23d, t24, t24d,
      t25, t25d, t26, t26d, t26inv, t27, t27d, t28, t28d, t28inv, t29, t29d, t2d, t2inv, t3, t30,
      t30d, t31, t31d, t31inv, t32, t32d, t33, t33d, t33inv, t34, t34d, t35, t35d, t36, t36d, t37,
      t37d, t37inv, t38, t38d, t39, t39d, t39inv, t3d, t4, t40, t40d, t41, t41d, t42, t42d, t42inv,
      t43, t43d, t44, t44d, t44inv, t45, t45d, t46, t46d, t47, t47d, t48, t48d, t48inv, t49, t49d,
      t4d, t4inv, t5, t50, t50d, t50inv, t51, t51d, t52, t52d, t53, t53d, t53inv, t54, t54d, t55,
      t55d, t55inv, t56, t56d, t57, t57d, t58, t58d, t59, t59d, t59inv, t5d, t6, t60, t60d, t61,
      t61d, t61inv, t62, t62d, t63, t63d, t64, t64d, t64inv, t65, t65d, t66, t66d, t66inv, t67,
      t67d, t68, t68d, t69, t69d, t6d, t6inv, t7, t70, t70d, t70inv, t71, t71d, t72, t72d, t72inv,
      t73, t73d, t74, t74d, t75, t75d, t75inv, t76, t76d, t77, t77d, t77inv, t78, t78d, t79, t79d,
      t7d, t8, t80, t80d, t81, t81d, t81inv, t82, t82d, t83, t83d, t84, t84d, t84inv, t85, t85d,
      t86d, t87, t87d, t8d, t9, t9d, t9inv, targetd, torqued, x00, x00d, x01, x01d, x02, x02d, x0_2,
      x0_2d, x10, x10d, x11, x11d, x12, x12d, x1_2, x1_2d, x20, x20d, x21, x21d, x22, x22d, x2_4,
      x2_4d, x2_5, x2_5d, x2_6, x2_6d, x30, x30d, x31, x31d, x32, x32d, x40, x40d, x41, x41d, x42,
      x42d, x50, x50d, x51, x51d, x52, x52d, y00, y00d, y01, y01d, y02, y02d, y0_2, y0_2d, y10,
      y10d, y11, y11d, y12, y12d, y1_2, y1_2d, y20, y20d, y21, y21d, y22, y22d, y2_2, y2_2d, y30,
      y30d, y31, y31d, y32, y32d, y40, y40d, y41, y41d, y42, y42d, y50, y50d, y51, y51d, y52, y52d,
      z0d;
  double P[2], Pd[2];

  (void)tau;
  (void)power;
  for (i = 0; i < t->ndriver; ++i) {
    a = t->driverpoint[i];
    b = t->driverorigin[i];
    x0_2 = r[a][0] - r[b][0];
    x0_2d = rd[a][0] - rd[b][0];
    x1_2 = r[a][1] - r[b][1];
    x1_2d = rd[a][1] - rd[b][1];
    k = t->driverq[i];
    p_i = p[t->driveradr[i]];
    p_id = pd[t->driveradr[i]];
    P[0] = x0_2 + p_i * rv[a][0];
    Pd[0] = x0_2d + (p_id * rv[a][0] + p_i * rvd[a][0]);
    P[1] = x1_2 + p_i * rv[a][1];
    Pd[1] = x1_2d + (p_id * rv[a][1] + p_i * rvd[a][1]);
    /* the parameter of the point of the path nearest to P */
    k3 = path_nearest_nodiff(t->np, p, t->driverpath[i], t->drivern[i], P);
    dx = p[t->driverpath[i] + k3 + 1] - p[t->driverpath[i] + k3];
    /* where P is nearest to the line through piece k of the polyline, as a part of the piece */
    dxd = pd[t->driverpath[i] + k3 + 1] - pd[t->driverpath[i] + k3];
    dy = p[t->driverpath[i] + t->drivern[i] + k3 + 1] - p[t->driverpath[i] + t->drivern[i] + k3];
    dyd = pd[t->driverpath[i] + t->drivern[i] + k3 + 1] - pd[t->driverpath[i] + t->drivern[i] + k3];
    t2 = dx * dx + dy * dy;
    t2d = dxd * dx + dx * dxd + (dyd * dy + dy * dyd);
    t3 = ((P[0] - p[t->driverpath[i] + k3]) * dx + (P[1] - p[t->driverpath[i] + t->drivern[i] + k3])
        * dy) / t2;
    t2inv = 1.0 / t2;
    t3d = ((Pd[0] - pd[t->driverpath[i] + k3]) * dx + (P[0] - p[t->driverpath[i] + k3]) * dxd +
        ((Pd[1] - pd[t->driverpath[i] + t->drivern[i] + k3]) * dy + (P[1] - p[t->driverpath[i] +
        t->drivern[i] + k3]) * dyd) - t3 * t2d) * t2inv;
    s0 = path0[t->driverrow[i] + k3][MAGGI_PATH_S] + t3 * (path0[t->driverrow[i] + k3 +
        1][MAGGI_PATH_S] - path0[t->driverrow[i] + k3][MAGGI_PATH_S]);
    s0d = path0d[t->driverrow[i] + k3][MAGGI_PATH_S] + (t3d * (path0[t->driverrow[i] + k3 +
        1][MAGGI_PATH_S] - path0[t->driverrow[i] + k3][MAGGI_PATH_S]) + t3 * (path0d[t->driverrow[i]
        + k3 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] + k3][MAGGI_PATH_S]));
    /* value and two derivatives at s */
    k4 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s0);
    h = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k4][MAGGI_PATH_S];
    hd = path0d[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k4][MAGGI_PATH_S];
    a2 = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - s0;
    a2d = path0d[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - s0d;
    c = s0 - path0[t->driverrow[i] + k4][MAGGI_PATH_S];
    cd = s0d - path0d[t->driverrow[i] + k4][MAGGI_PATH_S];
    m0 = path0[t->driverrow[i] + k4][MAGGI_PATH_X];
    m0d = path0d[t->driverrow[i] + k4][MAGGI_PATH_X];
    m1 = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_X];
    m1d = path0d[t->driverrow[i] + k4 + 1][MAGGI_PATH_X];
    e = (p[t->driverpath[i] + k4 + 1] - p[t->driverpath[i] + k4]) / h;
    hinv = 1.0 / h;
    ed = (pd[t->driverpath[i] + k4 + 1] - pd[t->driverpath[i] + k4] - e * hd) * hinv;
    if (MAGGI_RE(c) < 0.0) {
      slope = e - h / 6.0 * (2.0 * m0 + m1);
      sloped = ed - (hd / 6.0 * (2.0 * m0 + m1) + h / 6.0 * (2.0 * m0d + m1d));
      x00 = p[t->driverpath[i] + k4] + slope * c;
      x00d = pd[t->driverpath[i] + k4] + (sloped * c + slope * cd);
      x01 = slope;
      x01d = sloped;
      x02 = 0.0;
      x02d = 0.0;
    } else if (MAGGI_RE(a2) < 0.0) {
      slope22 = e + h / 6.0 * (m0 + 2.0 * m1);
      slope22d = ed + (hd / 6.0 * (m0 + 2.0 * m1) + h / 6.0 * (m0d + 2.0 * m1d));
      x00 = p[t->driverpath[i] + k4 + 1] - slope22 * a2;
      x00d = pd[t->driverpath[i] + k4 + 1] - (slope22d * a2 + slope22 * a2d);
      x01 = slope22;
      x01d = slope22d;
      x02 = 0.0;
      x02d = 0.0;
    } else {
      slope22_2 = e - h / 6.0 * (m1 - m0);
      slope22_2d = ed - (hd / 6.0 * (m1 - m0) + h / 6.0 * (m1d - m0d));
      t4 = 6.0 * h;
      t4d = 6.0 * hd;
      t5 = (m0 * a2 * a2 * a2 + m1 * c * c * c) / t4;
      t4inv = 1.0 / t4;
      t5d = (((m0d * a2 + m0 * a2d) * a2 + m0 * a2 * a2d) * a2 + m0 * a2 * a2 * a2d + (((m1d * c +
          m1 * cd) * c + m1 * c * cd) * c + m1 * c * c * cd) - t5 * t4d) * t4inv;
      x00 = t5 + p[t->driverpath[i] + k4] - m0 * h * h / 6.0 + slope22_2 * c;
      x00d = t5d + pd[t->driverpath[i] + k4] - ((m0d * h + m0 * hd) * h + m0 * h * hd) / 6.0 +
          (slope22_2d * c + slope22_2 * cd);
      t6 = 2.0 * h;
      t6d = 2.0 * hd;
      t7 = (m1 * c * c - m0 * a2 * a2) / t6;
      t6inv = 1.0 / t6;
      t7d = ((m1d * c + m1 * cd) * c + m1 * c * cd - ((m0d * a2 + m0 * a2d) * a2 + m0 * a2 * a2d) -
          t7 * t6d) * t6inv;
      x01 = t7 + slope22_2;
      x01d = t7d + slope22_2d;
      t8 = (m0 * a2 + m1 * c) / h;
      t8d = (m0d * a2 + m0 * a2d + (m1d * c + m1 * cd) - t8 * hd) * hinv;
      x02 = t8;
      x02d = t8d;
    }
    /* value and two derivatives at s */
    k5 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s0);
    h2 = path0[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k5][MAGGI_PATH_S];
    h2d = path0d[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k5][MAGGI_PATH_S];
    a3 = path0[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] - s0;
    a3d = path0d[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] - s0d;
    c2 = s0 - path0[t->driverrow[i] + k5][MAGGI_PATH_S];
    c2d = s0d - path0d[t->driverrow[i] + k5][MAGGI_PATH_S];
    m0_2 = path0[t->driverrow[i] + k5][MAGGI_PATH_Y];
    m0_2d = path0d[t->driverrow[i] + k5][MAGGI_PATH_Y];
    m1_2 = path0[t->driverrow[i] + k5 + 1][MAGGI_PATH_Y];
    m1_2d = path0d[t->driverrow[i] + k5 + 1][MAGGI_PATH_Y];
    e2 = (p[t->driverpath[i] + t->drivern[i] + k5 + 1] - p[t->driverpath[i] + t->drivern[i] + k5]) /
        h2;
    h2inv = 1.0 / h2;
    e2d = (pd[t->driverpath[i] + t->drivern[i] + k5 + 1] - pd[t->driverpath[i] + t->drivern[i] + k5]
        - e2 * h2d) * h2inv;
    if (MAGGI_RE(c2) < 0.0) {
      slope2 = e2 - h2 / 6.0 * (2.0 * m0_2 + m1_2);
      slope2d = e2d - (h2d / 6.0 * (2.0 * m0_2 + m1_2) + h2 / 6.0 * (2.0 * m0_2d + m1_2d));
      y00 = p[t->driverpath[i] + t->drivern[i] + k5] + slope2 * c2;
      y00d = pd[t->driverpath[i] + t->drivern[i] + k5] + (slope2d * c2 + slope2 * c2d);
      y01 = slope2;
      y01d = slope2d;
      y02 = 0.0;
      y02d = 0.0;
    } else if (MAGGI_RE(a3) < 0.0) {
      slope2_2 = e2 + h2 / 6.0 * (m0_2 + 2.0 * m1_2);
      slope2_2d = e2d + (h2d / 6.0 * (m0_2 + 2.0 * m1_2) + h2 / 6.0 * (m0_2d + 2.0 * m1_2d));
      y00 = p[t->driverpath[i] + t->drivern[i] + k5 + 1] - slope2_2 * a3;
      y00d = pd[t->driverpath[i] + t->drivern[i] + k5 + 1] - (slope2_2d * a3 + slope2_2 * a3d);
      y01 = slope2_2;
      y01d = slope2_2d;
      y02 = 0.0;
      y02d = 0.0;
    } else {
      slope2_3 = e2 - h2 / 6.0 * (m1_2 - m0_2);
      slope2_3d = e2d - (h2d / 6.0 * (m1_2 - m0_2) + h2 / 6.0 * (m1_2d - m0_2d));
      t9 = 6.0 * h2;
      t9d = 6.0 * h2d;
      t10 = (m0_2 * a3 * a3 * a3 + m1_2 * c2 * c2 * c2) / t9;
      t9inv = 1.0 / t9;
      t10d = (((m0_2d * a3 + m0_2 * a3d) * a3 + m0_2 * a3 * a3d) * a3 + m0_2 * a3 * a3 * a3d +
          (((m1_2d * c2 + m1_2 * c2d) * c2 + m1_2 * c2 * c2d) * c2 + m1_2 * c2 * c2 * c2d) - t10 *
          t9d) * t9inv;
      y00 = t10 + p[t->driverpath[i] + t->drivern[i] + k5] - m0_2 * h2 * h2 / 6.0 + slope2_3 * c2;
      y00d = t10d + pd[t->driverpath[i] + t->drivern[i] + k5] - ((m0_2d * h2 + m0_2 * h2d) * h2 +
          m0_2 * h2 * h2d) / 6.0 + (slope2_3d * c2 + slope2_3 * c2d);
      t11 = 2.0 * h2;
      t11d = 2.0 * h2d;
      t12 = (m1_2 * c2 * c2 - m0_2 * a3 * a3) / t11;
      t11inv = 1.0 / t11;
      t12d = ((m1_2d * c2 + m1_2 * c2d) * c2 + m1_2 * c2 * c2d - ((m0_2d * a3 + m0_2 * a3d) * a3 +
          m0_2 * a3 * a3d) - t12 * t11d) * t11inv;
      y01 = t12 + slope2_3;
      y01d = t12d + slope2_3d;
      t13 = (m0_2 * a3 + m1_2 * c2) / h2;
      t13d = (m0_2d * a3 + m0_2 * a3d + (m1_2d * c2 + m1_2 * c2d) - t13 * h2d) * h2inv;
      y02 = t13;
      y02d = t13d;
    }
    g = (x00 - P[0]) * x01 + (y00 - P[1]) * y01;
    /* one step of Newton's method; C, C', C'' at s */
    gd = (x00d - Pd[0]) * x01 + (x00 - P[0]) * x01d + ((y00d - Pd[1]) * y01 + (y00 - P[1]) * y01d);
    slope3 = x01 * x01 + y01 * y01 + (x00 - P[0]) * x02 + (y00 - P[1]) * y02;
    slope3d = x01d * x01 + x01 * x01d + (y01d * y01 + y01 * y01d) + ((x00d - Pd[0]) * x02 + (x00 -
        P[0]) * x02d) + ((y00d - Pd[1]) * y02 + (y00 - P[1]) * y02d);
    t14 = g / slope3;
    slope3inv = 1.0 / slope3;
    t14d = (gd - t14 * slope3d) * slope3inv;
    s1 = s0 - t14;
    s1d = s0d - t14d;
    /* value and two derivatives at s */
    k6 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s1);
    h3 = path0[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k6][MAGGI_PATH_S];
    h3d = path0d[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k6][MAGGI_PATH_S];
    a4 = path0[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] - s1;
    a4d = path0d[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] - s1d;
    c3 = s1 - path0[t->driverrow[i] + k6][MAGGI_PATH_S];
    c3d = s1d - path0d[t->driverrow[i] + k6][MAGGI_PATH_S];
    m0_3 = path0[t->driverrow[i] + k6][MAGGI_PATH_X];
    m0_3d = path0d[t->driverrow[i] + k6][MAGGI_PATH_X];
    m1_3 = path0[t->driverrow[i] + k6 + 1][MAGGI_PATH_X];
    m1_3d = path0d[t->driverrow[i] + k6 + 1][MAGGI_PATH_X];
    e3 = (p[t->driverpath[i] + k6 + 1] - p[t->driverpath[i] + k6]) / h3;
    h3inv = 1.0 / h3;
    e3d = (pd[t->driverpath[i] + k6 + 1] - pd[t->driverpath[i] + k6] - e3 * h3d) * h3inv;
    if (MAGGI_RE(c3) < 0.0) {
      slope4 = e3 - h3 / 6.0 * (2.0 * m0_3 + m1_3);
      slope4d = e3d - (h3d / 6.0 * (2.0 * m0_3 + m1_3) + h3 / 6.0 * (2.0 * m0_3d + m1_3d));
      x10 = p[t->driverpath[i] + k6] + slope4 * c3;
      x10d = pd[t->driverpath[i] + k6] + (slope4d * c3 + slope4 * c3d);
      x11 = slope4;
      x11d = slope4d;
      x12 = 0.0;
      x12d = 0.0;
    } else if (MAGGI_RE(a4) < 0.0) {
      slope4_2 = e3 + h3 / 6.0 * (m0_3 + 2.0 * m1_3);
      slope4_2d = e3d + (h3d / 6.0 * (m0_3 + 2.0 * m1_3) + h3 / 6.0 * (m0_3d + 2.0 * m1_3d));
      x10 = p[t->driverpath[i] + k6 + 1] - slope4_2 * a4;
      x10d = pd[t->driverpath[i] + k6 + 1] - (slope4_2d * a4 + slope4_2 * a4d);
      x11 = slope4_2;
      x11d = slope4_2d;
      x12 = 0.0;
      x12d = 0.0;
    } else {
      slope4_3 = e3 - h3 / 6.0 * (m1_3 - m0_3);
      slope4_3d = e3d - (h3d / 6.0 * (m1_3 - m0_3) + h3 / 6.0 * (m1_3d - m0_3d));
      t15 = 6.0 * h3;
      t15d = 6.0 * h3d;
      t16 = (m0_3 * a4 * a4 * a4 + m1_3 * c3 * c3 * c3) / t15;
      t15inv = 1.0 / t15;
      t16d = (((m0_3d * a4 + m0_3 * a4d) * a4 + m0_3 * a4 * a4d) * a4 + m0_3 * a4 * a4 * a4d +
          (((m1_3d * c3 + m1_3 * c3d) * c3 + m1_3 * c3 * c3d) * c3 + m1_3 * c3 * c3 * c3d) - t16 *
          t15d) * t15inv;
      x10 = t16 + p[t->driverpath[i] + k6] - m0_3 * h3 * h3 / 6.0 + slope4_3 * c3;
      x10d = t16d + pd[t->driverpath[i] + k6] - ((m0_3d * h3 + m0_3 * h3d) * h3 + m0_3 * h3 * h3d) /
          6.0 + (slope4_3d * c3 + slope4_3 * c3d);
      t17 = 2.0 * h3;
      t17d = 2.0 * h3d;
      t18 = (m1_3 * c3 * c3 - m0_3 * a4 * a4) / t17;
      t17inv = 1.0 / t17;
      t18d = ((m1_3d * c3 + m1_3 * c3d) * c3 + m1_3 * c3 * c3d - ((m0_3d * a4 + m0_3 * a4d) * a4 +
          m0_3 * a4 * a4d) - t18 * t17d) * t17inv;
      x11 = t18 + slope4_3;
      x11d = t18d + slope4_3d;
      t19 = (m0_3 * a4 + m1_3 * c3) / h3;
      t19d = (m0_3d * a4 + m0_3 * a4d + (m1_3d * c3 + m1_3 * c3d) - t19 * h3d) * h3inv;
      x12 = t19;
      x12d = t19d;
    }
    /* value and two derivatives at s */
    k7 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s1);
    h4 = path0[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k7][MAGGI_PATH_S];
    h4d = path0d[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k7][MAGGI_PATH_S];
    a5 = path0[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] - s1;
    a5d = path0d[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] - s1d;
    c4 = s1 - path0[t->driverrow[i] + k7][MAGGI_PATH_S];
    c4d = s1d - path0d[t->driverrow[i] + k7][MAGGI_PATH_S];
    m0_4 = path0[t->driverrow[i] + k7][MAGGI_PATH_Y];
    m0_4d = path0d[t->driverrow[i] + k7][MAGGI_PATH_Y];
    m1_4 = path0[t->driverrow[i] + k7 + 1][MAGGI_PATH_Y];
    m1_4d = path0d[t->driverrow[i] + k7 + 1][MAGGI_PATH_Y];
    e4 = (p[t->driverpath[i] + t->drivern[i] + k7 + 1] - p[t->driverpath[i] + t->drivern[i] + k7]) /
        h4;
    h4inv = 1.0 / h4;
    e4d = (pd[t->driverpath[i] + t->drivern[i] + k7 + 1] - pd[t->driverpath[i] + t->drivern[i] + k7]
        - e4 * h4d) * h4inv;
    if (MAGGI_RE(c4) < 0.0) {
      slope5 = e4 - h4 / 6.0 * (2.0 * m0_4 + m1_4);
      slope5d = e4d - (h4d / 6.0 * (2.0 * m0_4 + m1_4) + h4 / 6.0 * (2.0 * m0_4d + m1_4d));
      y10 = p[t->driverpath[i] + t->drivern[i] + k7] + slope5 * c4;
      y10d = pd[t->driverpath[i] + t->drivern[i] + k7] + (slope5d * c4 + slope5 * c4d);
      y11 = slope5;
      y11d = slope5d;
      y12 = 0.0;
      y12d = 0.0;
    } else if (MAGGI_RE(a5) < 0.0) {
      slope5_2 = e4 + h4 / 6.0 * (m0_4 + 2.0 * m1_4);
      slope5_2d = e4d + (h4d / 6.0 * (m0_4 + 2.0 * m1_4) + h4 / 6.0 * (m0_4d + 2.0 * m1_4d));
      y10 = p[t->driverpath[i] + t->drivern[i] + k7 + 1] - slope5_2 * a5;
      y10d = pd[t->driverpath[i] + t->drivern[i] + k7 + 1] - (slope5_2d * a5 + slope5_2 * a5d);
      y11 = slope5_2;
      y11d = slope5_2d;
      y12 = 0.0;
      y12d = 0.0;
    } else {
      slope5_3 = e4 - h4 / 6.0 * (m1_4 - m0_4);
      slope5_3d = e4d - (h4d / 6.0 * (m1_4 - m0_4) + h4 / 6.0 * (m1_4d - m0_4d));
      t20 = 6.0 * h4;
      t20d = 6.0 * h4d;
      t21 = (m0_4 * a5 * a5 * a5 + m1_4 * c4 * c4 * c4) / t20;
      t20inv = 1.0 / t20;
      t21d = (((m0_4d * a5 + m0_4 * a5d) * a5 + m0_4 * a5 * a5d) * a5 + m0_4 * a5 * a5 * a5d +
          (((m1_4d * c4 + m1_4 * c4d) * c4 + m1_4 * c4 * c4d) * c4 + m1_4 * c4 * c4 * c4d) - t21 *
          t20d) * t20inv;
      y10 = t21 + p[t->driverpath[i] + t->drivern[i] + k7] - m0_4 * h4 * h4 / 6.0 + slope5_3 * c4;
      y10d = t21d + pd[t->driverpath[i] + t->drivern[i] + k7] - ((m0_4d * h4 + m0_4 * h4d) * h4 +
          m0_4 * h4 * h4d) / 6.0 + (slope5_3d * c4 + slope5_3 * c4d);
      t22 = 2.0 * h4;
      t22d = 2.0 * h4d;
      t23 = (m1_4 * c4 * c4 - m0_4 * a5 * a5) / t22;
      t22inv = 1.0 / t22;
      t23d = ((m1_4d * c4 + m1_4 * c4d) * c4 + m1_4 * c4 * c4d - ((m0_4d * a5 + m0_4 * a5d) * a5 +
          m0_4 * a5 * a5d) - t23 * t22d) * t22inv;
      y11 = t23 + slope5_3;
      y11d = t23d + slope5_3d;
      t24 = (m0_4 * a5 + m1_4 * c4) / h4;
      t24d = (m0_4d * a5 + m0_4 * a5d + (m1_4d * c4 + m1_4 * c4d) - t24 * h4d) * h4inv;
      y12 = t24;
      y12d = t24d;
    }
    g2 = (x10 - P[0]) * x11 + (y10 - P[1]) * y11;
    /* one step of Newton's method; C, C', C'' at s */
    g2d = (x10d - Pd[0]) * x11 + (x10 - P[0]) * x11d + ((y10d - Pd[1]) * y11 + (y10 - P[1]) * y11d);
    slope6 = x11 * x11 + y11 * y11 + (x10 - P[0]) * x12 + (y10 - P[1]) * y12;
    slope6d = x11d * x11 + x11 * x11d + (y11d * y11 + y11 * y11d) + ((x10d - Pd[0]) * x12 + (x10 -
        P[0]) * x12d) + ((y10d - Pd[1]) * y12 + (y10 - P[1]) * y12d);
    t25 = g2 / slope6;
    slope6inv = 1.0 / slope6;
    t25d = (g2d - t25 * slope6d) * slope6inv;
    s2 = s1 - t25;
    s2d = s1d - t25d;
    /* value and two derivatives at s */
    k8 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s2);
    h5 = path0[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k8][MAGGI_PATH_S];
    h5d = path0d[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k8][MAGGI_PATH_S];
    a6 = path0[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] - s2;
    a6d = path0d[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] - s2d;
    c5 = s2 - path0[t->driverrow[i] + k8][MAGGI_PATH_S];
    c5d = s2d - path0d[t->driverrow[i] + k8][MAGGI_PATH_S];
    m0_5 = path0[t->driverrow[i] + k8][MAGGI_PATH_X];
    m0_5d = path0d[t->driverrow[i] + k8][MAGGI_PATH_X];
    m1_5 = path0[t->driverrow[i] + k8 + 1][MAGGI_PATH_X];
    m1_5d = path0d[t->driverrow[i] + k8 + 1][MAGGI_PATH_X];
    e5 = (p[t->driverpath[i] + k8 + 1] - p[t->driverpath[i] + k8]) / h5;
    h5inv = 1.0 / h5;
    e5d = (pd[t->driverpath[i] + k8 + 1] - pd[t->driverpath[i] + k8] - e5 * h5d) * h5inv;
    if (MAGGI_RE(c5) < 0.0) {
      slope7 = e5 - h5 / 6.0 * (2.0 * m0_5 + m1_5);
      slope7d = e5d - (h5d / 6.0 * (2.0 * m0_5 + m1_5) + h5 / 6.0 * (2.0 * m0_5d + m1_5d));
      x2_4 = p[t->driverpath[i] + k8] + slope7 * c5;
      x2_4d = pd[t->driverpath[i] + k8] + (slope7d * c5 + slope7 * c5d);
      x2_5 = slope7;
      x2_5d = slope7d;
      x2_6 = 0.0;
      x2_6d = 0.0;
    } else if (MAGGI_RE(a6) < 0.0) {
      slope7_2 = e5 + h5 / 6.0 * (m0_5 + 2.0 * m1_5);
      slope7_2d = e5d + (h5d / 6.0 * (m0_5 + 2.0 * m1_5) + h5 / 6.0 * (m0_5d + 2.0 * m1_5d));
      x2_4 = p[t->driverpath[i] + k8 + 1] - slope7_2 * a6;
      x2_4d = pd[t->driverpath[i] + k8 + 1] - (slope7_2d * a6 + slope7_2 * a6d);
      x2_5 = slope7_2;
      x2_5d = slope7_2d;
      x2_6 = 0.0;
      x2_6d = 0.0;
    } else {
      slope7_3 = e5 - h5 / 6.0 * (m1_5 - m0_5);
      slope7_3d = e5d - (h5d / 6.0 * (m1_5 - m0_5) + h5 / 6.0 * (m1_5d - m0_5d));
      t26 = 6.0 * h5;
      t26d = 6.0 * h5d;
      t27 = (m0_5 * a6 * a6 * a6 + m1_5 * c5 * c5 * c5) / t26;
      t26inv = 1.0 / t26;
      t27d = (((m0_5d * a6 + m0_5 * a6d) * a6 + m0_5 * a6 * a6d) * a6 + m0_5 * a6 * a6 * a6d +
          (((m1_5d * c5 + m1_5 * c5d) * c5 + m1_5 * c5 * c5d) * c5 + m1_5 * c5 * c5 * c5d) - t27 *
          t26d) * t26inv;
      x2_4 = t27 + p[t->driverpath[i] + k8] - m0_5 * h5 * h5 / 6.0 + slope7_3 * c5;
      x2_4d = t27d + pd[t->driverpath[i] + k8] - ((m0_5d * h5 + m0_5 * h5d) * h5 + m0_5 * h5 * h5d)
          / 6.0 + (slope7_3d * c5 + slope7_3 * c5d);
      t28 = 2.0 * h5;
      t28d = 2.0 * h5d;
      t29 = (m1_5 * c5 * c5 - m0_5 * a6 * a6) / t28;
      t28inv = 1.0 / t28;
      t29d = ((m1_5d * c5 + m1_5 * c5d) * c5 + m1_5 * c5 * c5d - ((m0_5d * a6 + m0_5 * a6d) * a6 +
          m0_5 * a6 * a6d) - t29 * t28d) * t28inv;
      x2_5 = t29 + slope7_3;
      x2_5d = t29d + slope7_3d;
      t30 = (m0_5 * a6 + m1_5 * c5) / h5;
      t30d = (m0_5d * a6 + m0_5 * a6d + (m1_5d * c5 + m1_5 * c5d) - t30 * h5d) * h5inv;
      x2_6 = t30;
      x2_6d = t30d;
    }
    /* value and two derivatives at s */
    k9 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s2);
    h6 = path0[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k9][MAGGI_PATH_S];
    h6d = path0d[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k9][MAGGI_PATH_S];
    a7 = path0[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] - s2;
    a7d = path0d[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] - s2d;
    c6 = s2 - path0[t->driverrow[i] + k9][MAGGI_PATH_S];
    c6d = s2d - path0d[t->driverrow[i] + k9][MAGGI_PATH_S];
    m0_6 = path0[t->driverrow[i] + k9][MAGGI_PATH_Y];
    m0_6d = path0d[t->driverrow[i] + k9][MAGGI_PATH_Y];
    m1_6 = path0[t->driverrow[i] + k9 + 1][MAGGI_PATH_Y];
    m1_6d = path0d[t->driverrow[i] + k9 + 1][MAGGI_PATH_Y];
    e6 = (p[t->driverpath[i] + t->drivern[i] + k9 + 1] - p[t->driverpath[i] + t->drivern[i] + k9]) /
        h6;
    h6inv = 1.0 / h6;
    e6d = (pd[t->driverpath[i] + t->drivern[i] + k9 + 1] - pd[t->driverpath[i] + t->drivern[i] + k9]
        - e6 * h6d) * h6inv;
    if (MAGGI_RE(c6) < 0.0) {
      slope8 = e6 - h6 / 6.0 * (2.0 * m0_6 + m1_6);
      slope8d = e6d - (h6d / 6.0 * (2.0 * m0_6 + m1_6) + h6 / 6.0 * (2.0 * m0_6d + m1_6d));
      y20 = p[t->driverpath[i] + t->drivern[i] + k9] + slope8 * c6;
      y20d = pd[t->driverpath[i] + t->drivern[i] + k9] + (slope8d * c6 + slope8 * c6d);
      y21 = slope8;
      y21d = slope8d;
      y22 = 0.0;
      y22d = 0.0;
    } else if (MAGGI_RE(a7) < 0.0) {
      slope8_2 = e6 + h6 / 6.0 * (m0_6 + 2.0 * m1_6);
      slope8_2d = e6d + (h6d / 6.0 * (m0_6 + 2.0 * m1_6) + h6 / 6.0 * (m0_6d + 2.0 * m1_6d));
      y20 = p[t->driverpath[i] + t->drivern[i] + k9 + 1] - slope8_2 * a7;
      y20d = pd[t->driverpath[i] + t->drivern[i] + k9 + 1] - (slope8_2d * a7 + slope8_2 * a7d);
      y21 = slope8_2;
      y21d = slope8_2d;
      y22 = 0.0;
      y22d = 0.0;
    } else {
      slope8_3 = e6 - h6 / 6.0 * (m1_6 - m0_6);
      slope8_3d = e6d - (h6d / 6.0 * (m1_6 - m0_6) + h6 / 6.0 * (m1_6d - m0_6d));
      t31 = 6.0 * h6;
      t31d = 6.0 * h6d;
      t32 = (m0_6 * a7 * a7 * a7 + m1_6 * c6 * c6 * c6) / t31;
      t31inv = 1.0 / t31;
      t32d = (((m0_6d * a7 + m0_6 * a7d) * a7 + m0_6 * a7 * a7d) * a7 + m0_6 * a7 * a7 * a7d +
          (((m1_6d * c6 + m1_6 * c6d) * c6 + m1_6 * c6 * c6d) * c6 + m1_6 * c6 * c6 * c6d) - t32 *
          t31d) * t31inv;
      y20 = t32 + p[t->driverpath[i] + t->drivern[i] + k9] - m0_6 * h6 * h6 / 6.0 + slope8_3 * c6;
      y20d = t32d + pd[t->driverpath[i] + t->drivern[i] + k9] - ((m0_6d * h6 + m0_6 * h6d) * h6 +
          m0_6 * h6 * h6d) / 6.0 + (slope8_3d * c6 + slope8_3 * c6d);
      t33 = 2.0 * h6;
      t33d = 2.0 * h6d;
      t34 = (m1_6 * c6 * c6 - m0_6 * a7 * a7) / t33;
      t33inv = 1.0 / t33;
      t34d = ((m1_6d * c6 + m1_6 * c6d) * c6 + m1_6 * c6 * c6d - ((m0_6d * a7 + m0_6 * a7d) * a7 +
          m0_6 * a7 * a7d) - t34 * t33d) * t33inv;
      y21 = t34 + slope8_3;
      y21d = t34d + slope8_3d;
      t35 = (m0_6 * a7 + m1_6 * c6) / h6;
      t35d = (m0_6d * a7 + m0_6 * a7d + (m1_6d * c6 + m1_6 * c6d) - t35 * h6d) * h6inv;
      y22 = t35;
      y22d = t35d;
    }
    g3 = (x2_4 - P[0]) * x2_5 + (y20 - P[1]) * y21;
    /* one step of Newton's method; C, C', C'' at s */
    g3d = (x2_4d - Pd[0]) * x2_5 + (x2_4 - P[0]) * x2_5d + ((y20d - Pd[1]) * y21 + (y20 - P[1]) *
        y21d);
    slope9 = x2_5 * x2_5 + y21 * y21 + (x2_4 - P[0]) * x2_6 + (y20 - P[1]) * y22;
    slope9d = x2_5d * x2_5 + x2_5 * x2_5d + (y21d * y21 + y21 * y21d) + ((x2_4d - Pd[0]) * x2_6 +
        (x2_4 - P[0]) * x2_6d) + ((y20d - Pd[1]) * y22 + (y20 - P[1]) * y22d);
    t36 = g3 / slope9;
    slope9inv = 1.0 / slope9;
    t36d = (g3d - t36 * slope9d) * slope9inv;
    s3 = s2 - t36;
    s3d = s2d - t36d;
    /* value and two derivatives at s */
    k10 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s3);
    h7 = path0[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k10][MAGGI_PATH_S];
    h7d = path0d[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k10][MAGGI_PATH_S];
    a8 = path0[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] - s3;
    a8d = path0d[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] - s3d;
    c7 = s3 - path0[t->driverrow[i] + k10][MAGGI_PATH_S];
    c7d = s3d - path0d[t->driverrow[i] + k10][MAGGI_PATH_S];
    m0_7 = path0[t->driverrow[i] + k10][MAGGI_PATH_X];
    m0_7d = path0d[t->driverrow[i] + k10][MAGGI_PATH_X];
    m1_7 = path0[t->driverrow[i] + k10 + 1][MAGGI_PATH_X];
    m1_7d = path0d[t->driverrow[i] + k10 + 1][MAGGI_PATH_X];
    e7 = (p[t->driverpath[i] + k10 + 1] - p[t->driverpath[i] + k10]) / h7;
    h7inv = 1.0 / h7;
    e7d = (pd[t->driverpath[i] + k10 + 1] - pd[t->driverpath[i] + k10] - e7 * h7d) * h7inv;
    if (MAGGI_RE(c7) < 0.0) {
      slope10 = e7 - h7 / 6.0 * (2.0 * m0_7 + m1_7);
      slope10d = e7d - (h7d / 6.0 * (2.0 * m0_7 + m1_7) + h7 / 6.0 * (2.0 * m0_7d + m1_7d));
      x30 = p[t->driverpath[i] + k10] + slope10 * c7;
      x30d = pd[t->driverpath[i] + k10] + (slope10d * c7 + slope10 * c7d);
      x31 = slope10;
      x31d = slope10d;
      x32 = 0.0;
      x32d = 0.0;
    } else if (MAGGI_RE(a8) < 0.0) {
      slope10_2 = e7 + h7 / 6.0 * (m0_7 + 2.0 * m1_7);
      slope10_2d = e7d + (h7d / 6.0 * (m0_7 + 2.0 * m1_7) + h7 / 6.0 * (m0_7d + 2.0 * m1_7d));
      x30 = p[t->driverpath[i] + k10 + 1] - slope10_2 * a8;
      x30d = pd[t->driverpath[i] + k10 + 1] - (slope10_2d * a8 + slope10_2 * a8d);
      x31 = slope10_2;
      x31d = slope10_2d;
      x32 = 0.0;
      x32d = 0.0;
    } else {
      slope10_3 = e7 - h7 / 6.0 * (m1_7 - m0_7);
      slope10_3d = e7d - (h7d / 6.0 * (m1_7 - m0_7) + h7 / 6.0 * (m1_7d - m0_7d));
      t37 = 6.0 * h7;
      t37d = 6.0 * h7d;
      t38 = (m0_7 * a8 * a8 * a8 + m1_7 * c7 * c7 * c7) / t37;
      t37inv = 1.0 / t37;
      t38d = (((m0_7d * a8 + m0_7 * a8d) * a8 + m0_7 * a8 * a8d) * a8 + m0_7 * a8 * a8 * a8d +
          (((m1_7d * c7 + m1_7 * c7d) * c7 + m1_7 * c7 * c7d) * c7 + m1_7 * c7 * c7 * c7d) - t38 *
          t37d) * t37inv;
      x30 = t38 + p[t->driverpath[i] + k10] - m0_7 * h7 * h7 / 6.0 + slope10_3 * c7;
      x30d = t38d + pd[t->driverpath[i] + k10] - ((m0_7d * h7 + m0_7 * h7d) * h7 + m0_7 * h7 * h7d)
          / 6.0 + (slope10_3d * c7 + slope10_3 * c7d);
      t39 = 2.0 * h7;
      t39d = 2.0 * h7d;
      t40 = (m1_7 * c7 * c7 - m0_7 * a8 * a8) / t39;
      t39inv = 1.0 / t39;
      t40d = ((m1_7d * c7 + m1_7 * c7d) * c7 + m1_7 * c7 * c7d - ((m0_7d * a8 + m0_7 * a8d) * a8 +
          m0_7 * a8 * a8d) - t40 * t39d) * t39inv;
      x31 = t40 + slope10_3;
      x31d = t40d + slope10_3d;
      t41 = (m0_7 * a8 + m1_7 * c7) / h7;
      t41d = (m0_7d * a8 + m0_7 * a8d + (m1_7d * c7 + m1_7 * c7d) - t41 * h7d) * h7inv;
      x32 = t41;
      x32d = t41d;
    }
    /* value and two derivatives at s */
    k11 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s3);
    h8 = path0[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k11][MAGGI_PATH_S];
    h8d = path0d[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k11][MAGGI_PATH_S];
    a9 = path0[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] - s3;
    a9d = path0d[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] - s3d;
    c8 = s3 - path0[t->driverrow[i] + k11][MAGGI_PATH_S];
    c8d = s3d - path0d[t->driverrow[i] + k11][MAGGI_PATH_S];
    m0_8 = path0[t->driverrow[i] + k11][MAGGI_PATH_Y];
    m0_8d = path0d[t->driverrow[i] + k11][MAGGI_PATH_Y];
    m1_8 = path0[t->driverrow[i] + k11 + 1][MAGGI_PATH_Y];
    m1_8d = path0d[t->driverrow[i] + k11 + 1][MAGGI_PATH_Y];
    e8 = (p[t->driverpath[i] + t->drivern[i] + k11 + 1] - p[t->driverpath[i] + t->drivern[i] + k11])
        / h8;
    h8inv = 1.0 / h8;
    e8d = (pd[t->driverpath[i] + t->drivern[i] + k11 + 1] - pd[t->driverpath[i] + t->drivern[i] +
        k11] - e8 * h8d) * h8inv;
    if (MAGGI_RE(c8) < 0.0) {
      slope11 = e8 - h8 / 6.0 * (2.0 * m0_8 + m1_8);
      slope11d = e8d - (h8d / 6.0 * (2.0 * m0_8 + m1_8) + h8 / 6.0 * (2.0 * m0_8d + m1_8d));
      y30 = p[t->driverpath[i] + t->drivern[i] + k11] + slope11 * c8;
      y30d = pd[t->driverpath[i] + t->drivern[i] + k11] + (slope11d * c8 + slope11 * c8d);
      y31 = slope11;
      y31d = slope11d;
      y32 = 0.0;
      y32d = 0.0;
    } else if (MAGGI_RE(a9) < 0.0) {
      slope11_2 = e8 + h8 / 6.0 * (m0_8 + 2.0 * m1_8);
      slope11_2d = e8d + (h8d / 6.0 * (m0_8 + 2.0 * m1_8) + h8 / 6.0 * (m0_8d + 2.0 * m1_8d));
      y30 = p[t->driverpath[i] + t->drivern[i] + k11 + 1] - slope11_2 * a9;
      y30d = pd[t->driverpath[i] + t->drivern[i] + k11 + 1] - (slope11_2d * a9 + slope11_2 * a9d);
      y31 = slope11_2;
      y31d = slope11_2d;
      y32 = 0.0;
      y32d = 0.0;
    } else {
      slope11_3 = e8 - h8 / 6.0 * (m1_8 - m0_8);
      slope11_3d = e8d - (h8d / 6.0 * (m1_8 - m0_8) + h8 / 6.0 * (m1_8d - m0_8d));
      t42 = 6.0 * h8;
      t42d = 6.0 * h8d;
      t43 = (m0_8 * a9 * a9 * a9 + m1_8 * c8 * c8 * c8) / t42;
      t42inv = 1.0 / t42;
      t43d = (((m0_8d * a9 + m0_8 * a9d) * a9 + m0_8 * a9 * a9d) * a9 + m0_8 * a9 * a9 * a9d +
          (((m1_8d * c8 + m1_8 * c8d) * c8 + m1_8 * c8 * c8d) * c8 + m1_8 * c8 * c8 * c8d) - t43 *
          t42d) * t42inv;
      y30 = t43 + p[t->driverpath[i] + t->drivern[i] + k11] - m0_8 * h8 * h8 / 6.0 + slope11_3 * c8;
      y30d = t43d + pd[t->driverpath[i] + t->drivern[i] + k11] - ((m0_8d * h8 + m0_8 * h8d) * h8 +
          m0_8 * h8 * h8d) / 6.0 + (slope11_3d * c8 + slope11_3 * c8d);
      t44 = 2.0 * h8;
      t44d = 2.0 * h8d;
      t45 = (m1_8 * c8 * c8 - m0_8 * a9 * a9) / t44;
      t44inv = 1.0 / t44;
      t45d = ((m1_8d * c8 + m1_8 * c8d) * c8 + m1_8 * c8 * c8d - ((m0_8d * a9 + m0_8 * a9d) * a9 +
          m0_8 * a9 * a9d) - t45 * t44d) * t44inv;
      y31 = t45 + slope11_3;
      y31d = t45d + slope11_3d;
      t46 = (m0_8 * a9 + m1_8 * c8) / h8;
      t46d = (m0_8d * a9 + m0_8 * a9d + (m1_8d * c8 + m1_8 * c8d) - t46 * h8d) * h8inv;
      y32 = t46;
      y32d = t46d;
    }
    g4 = (x30 - P[0]) * x31 + (y30 - P[1]) * y31;
    /* one step of Newton's method; C, C', C'' at s */
    g4d = (x30d - Pd[0]) * x31 + (x30 - P[0]) * x31d + ((y30d - Pd[1]) * y31 + (y30 - P[1]) * y31d);
    slope12 = x31 * x31 + y31 * y31 + (x30 - P[0]) * x32 + (y30 - P[1]) * y32;
    slope12d = x31d * x31 + x31 * x31d + (y31d * y31 + y31 * y31d) + ((x30d - Pd[0]) * x32 + (x30 -
        P[0]) * x32d) + ((y30d - Pd[1]) * y32 + (y30 - P[1]) * y32d);
    t47 = g4 / slope12;
    slope12inv = 1.0 / slope12;
    t47d = (g4d - t47 * slope12d) * slope12inv;
    s4 = s3 - t47;
    s4d = s3d - t47d;
    /* value and two derivatives at s */
    k12 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s4);
    h9 = path0[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k12][MAGGI_PATH_S];
    h9d = path0d[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k12][MAGGI_PATH_S];
    a10 = path0[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] - s4;
    a10d = path0d[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] - s4d;
    c9 = s4 - path0[t->driverrow[i] + k12][MAGGI_PATH_S];
    c9d = s4d - path0d[t->driverrow[i] + k12][MAGGI_PATH_S];
    m0_9 = path0[t->driverrow[i] + k12][MAGGI_PATH_X];
    m0_9d = path0d[t->driverrow[i] + k12][MAGGI_PATH_X];
    m1_9 = path0[t->driverrow[i] + k12 + 1][MAGGI_PATH_X];
    m1_9d = path0d[t->driverrow[i] + k12 + 1][MAGGI_PATH_X];
    e9 = (p[t->driverpath[i] + k12 + 1] - p[t->driverpath[i] + k12]) / h9;
    h9inv = 1.0 / h9;
    e9d = (pd[t->driverpath[i] + k12 + 1] - pd[t->driverpath[i] + k12] - e9 * h9d) * h9inv;
    if (MAGGI_RE(c9) < 0.0) {
      slope13 = e9 - h9 / 6.0 * (2.0 * m0_9 + m1_9);
      slope13d = e9d - (h9d / 6.0 * (2.0 * m0_9 + m1_9) + h9 / 6.0 * (2.0 * m0_9d + m1_9d));
      x40 = p[t->driverpath[i] + k12] + slope13 * c9;
      x40d = pd[t->driverpath[i] + k12] + (slope13d * c9 + slope13 * c9d);
      x41 = slope13;
      x41d = slope13d;
      x42 = 0.0;
      x42d = 0.0;
    } else if (MAGGI_RE(a10) < 0.0) {
      slope13_2 = e9 + h9 / 6.0 * (m0_9 + 2.0 * m1_9);
      slope13_2d = e9d + (h9d / 6.0 * (m0_9 + 2.0 * m1_9) + h9 / 6.0 * (m0_9d + 2.0 * m1_9d));
      x40 = p[t->driverpath[i] + k12 + 1] - slope13_2 * a10;
      x40d = pd[t->driverpath[i] + k12 + 1] - (slope13_2d * a10 + slope13_2 * a10d);
      x41 = slope13_2;
      x41d = slope13_2d;
      x42 = 0.0;
      x42d = 0.0;
    } else {
      slope13_3 = e9 - h9 / 6.0 * (m1_9 - m0_9);
      slope13_3d = e9d - (h9d / 6.0 * (m1_9 - m0_9) + h9 / 6.0 * (m1_9d - m0_9d));
      t48 = 6.0 * h9;
      t48d = 6.0 * h9d;
      t49 = (m0_9 * a10 * a10 * a10 + m1_9 * c9 * c9 * c9) / t48;
      t48inv = 1.0 / t48;
      t49d = (((m0_9d * a10 + m0_9 * a10d) * a10 + m0_9 * a10 * a10d) * a10 + m0_9 * a10 * a10 *
          a10d + (((m1_9d * c9 + m1_9 * c9d) * c9 + m1_9 * c9 * c9d) * c9 + m1_9 * c9 * c9 * c9d) -
          t49 * t48d) * t48inv;
      x40 = t49 + p[t->driverpath[i] + k12] - m0_9 * h9 * h9 / 6.0 + slope13_3 * c9;
      x40d = t49d + pd[t->driverpath[i] + k12] - ((m0_9d * h9 + m0_9 * h9d) * h9 + m0_9 * h9 * h9d)
          / 6.0 + (slope13_3d * c9 + slope13_3 * c9d);
      t50 = 2.0 * h9;
      t50d = 2.0 * h9d;
      t51 = (m1_9 * c9 * c9 - m0_9 * a10 * a10) / t50;
      t50inv = 1.0 / t50;
      t51d = ((m1_9d * c9 + m1_9 * c9d) * c9 + m1_9 * c9 * c9d - ((m0_9d * a10 + m0_9 * a10d) * a10
          + m0_9 * a10 * a10d) - t51 * t50d) * t50inv;
      x41 = t51 + slope13_3;
      x41d = t51d + slope13_3d;
      t52 = (m0_9 * a10 + m1_9 * c9) / h9;
      t52d = (m0_9d * a10 + m0_9 * a10d + (m1_9d * c9 + m1_9 * c9d) - t52 * h9d) * h9inv;
      x42 = t52;
      x42d = t52d;
    }
    /* value and two derivatives at s */
    k13 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s4);
    h10 = path0[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k13][MAGGI_PATH_S];
    h10d = path0d[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k13][MAGGI_PATH_S];
    a11 = path0[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] - s4;
    a11d = path0d[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] - s4d;
    c10 = s4 - path0[t->driverrow[i] + k13][MAGGI_PATH_S];
    c10d = s4d - path0d[t->driverrow[i] + k13][MAGGI_PATH_S];
    m0_10 = path0[t->driverrow[i] + k13][MAGGI_PATH_Y];
    m0_10d = path0d[t->driverrow[i] + k13][MAGGI_PATH_Y];
    m1_10 = path0[t->driverrow[i] + k13 + 1][MAGGI_PATH_Y];
    m1_10d = path0d[t->driverrow[i] + k13 + 1][MAGGI_PATH_Y];
    e10 = (p[t->driverpath[i] + t->drivern[i] + k13 + 1] - p[t->driverpath[i] + t->drivern[i] +
        k13]) / h10;
    h10inv = 1.0 / h10;
    e10d = (pd[t->driverpath[i] + t->drivern[i] + k13 + 1] - pd[t->driverpath[i] + t->drivern[i] +
        k13] - e10 * h10d) * h10inv;
    if (MAGGI_RE(c10) < 0.0) {
      slope14 = e10 - h10 / 6.0 * (2.0 * m0_10 + m1_10);
      slope14d = e10d - (h10d / 6.0 * (2.0 * m0_10 + m1_10) + h10 / 6.0 * (2.0 * m0_10d + m1_10d));
      y40 = p[t->driverpath[i] + t->drivern[i] + k13] + slope14 * c10;
      y40d = pd[t->driverpath[i] + t->drivern[i] + k13] + (slope14d * c10 + slope14 * c10d);
      y41 = slope14;
      y41d = slope14d;
      y42 = 0.0;
      y42d = 0.0;
    } else if (MAGGI_RE(a11) < 0.0) {
      slope14_2 = e10 + h10 / 6.0 * (m0_10 + 2.0 * m1_10);
      slope14_2d = e10d + (h10d / 6.0 * (m0_10 + 2.0 * m1_10) + h10 / 6.0 * (m0_10d + 2.0 *
          m1_10d));
      y40 = p[t->driverpath[i] + t->drivern[i] + k13 + 1] - slope14_2 * a11;
      y40d = pd[t->driverpath[i] + t->drivern[i] + k13 + 1] - (slope14_2d * a11 + slope14_2 * a11d);
      y41 = slope14_2;
      y41d = slope14_2d;
      y42 = 0.0;
      y42d = 0.0;
    } else {
      slope14_3 = e10 - h10 / 6.0 * (m1_10 - m0_10);
      slope14_3d = e10d - (h10d / 6.0 * (m1_10 - m0_10) + h10 / 6.0 * (m1_10d - m0_10d));
      t53 = 6.0 * h10;
      t53d = 6.0 * h10d;
      t54 = (m0_10 * a11 * a11 * a11 + m1_10 * c10 * c10 * c10) / t53;
      t53inv = 1.0 / t53;
      t54d = (((m0_10d * a11 + m0_10 * a11d) * a11 + m0_10 * a11 * a11d) * a11 + m0_10 * a11 * a11 *
          a11d + (((m1_10d * c10 + m1_10 * c10d) * c10 + m1_10 * c10 * c10d) * c10 + m1_10 * c10 *
          c10 * c10d) - t54 * t53d) * t53inv;
      y40 = t54 + p[t->driverpath[i] + t->drivern[i] + k13] - m0_10 * h10 * h10 / 6.0 + slope14_3 *
          c10;
      y40d = t54d + pd[t->driverpath[i] + t->drivern[i] + k13] - ((m0_10d * h10 + m0_10 * h10d) *
          h10 + m0_10 * h10 * h10d) / 6.0 + (slope14_3d * c10 + slope14_3 * c10d);
      t55 = 2.0 * h10;
      t55d = 2.0 * h10d;
      t56 = (m1_10 * c10 * c10 - m0_10 * a11 * a11) / t55;
      t55inv = 1.0 / t55;
      t56d = ((m1_10d * c10 + m1_10 * c10d) * c10 + m1_10 * c10 * c10d - ((m0_10d * a11 + m0_10 *
          a11d) * a11 + m0_10 * a11 * a11d) - t56 * t55d) * t55inv;
      y41 = t56 + slope14_3;
      y41d = t56d + slope14_3d;
      t57 = (m0_10 * a11 + m1_10 * c10) / h10;
      t57d = (m0_10d * a11 + m0_10 * a11d + (m1_10d * c10 + m1_10 * c10d) - t57 * h10d) * h10inv;
      y42 = t57;
      y42d = t57d;
    }
    g5 = (x40 - P[0]) * x41 + (y40 - P[1]) * y41;
    /* one step of Newton's method; C, C', C'' at s */
    g5d = (x40d - Pd[0]) * x41 + (x40 - P[0]) * x41d + ((y40d - Pd[1]) * y41 + (y40 - P[1]) * y41d);
    slope15 = x41 * x41 + y41 * y41 + (x40 - P[0]) * x42 + (y40 - P[1]) * y42;
    slope15d = x41d * x41 + x41 * x41d + (y41d * y41 + y41 * y41d) + ((x40d - Pd[0]) * x42 + (x40 -
        P[0]) * x42d) + ((y40d - Pd[1]) * y42 + (y40 - P[1]) * y42d);
    t58 = g5 / slope15;
    slope15inv = 1.0 / slope15;
    t58d = (g5d - t58 * slope15d) * slope15inv;
    s5 = s4 - t58;
    s5d = s4d - t58d;
    /* value and two derivatives at s */
    k14 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s5);
    h11 = path0[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k14][MAGGI_PATH_S];
    h11d = path0d[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k14][MAGGI_PATH_S];
    a12 = path0[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] - s5;
    a12d = path0d[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] - s5d;
    c11 = s5 - path0[t->driverrow[i] + k14][MAGGI_PATH_S];
    c11d = s5d - path0d[t->driverrow[i] + k14][MAGGI_PATH_S];
    m0_11 = path0[t->driverrow[i] + k14][MAGGI_PATH_X];
    m0_11d = path0d[t->driverrow[i] + k14][MAGGI_PATH_X];
    m1_11 = path0[t->driverrow[i] + k14 + 1][MAGGI_PATH_X];
    m1_11d = path0d[t->driverrow[i] + k14 + 1][MAGGI_PATH_X];
    e11 = (p[t->driverpath[i] + k14 + 1] - p[t->driverpath[i] + k14]) / h11;
    h11inv = 1.0 / h11;
    e11d = (pd[t->driverpath[i] + k14 + 1] - pd[t->driverpath[i] + k14] - e11 * h11d) * h11inv;
    if (MAGGI_RE(c11) < 0.0) {
      slope16 = e11 - h11 / 6.0 * (2.0 * m0_11 + m1_11);
      slope16d = e11d - (h11d / 6.0 * (2.0 * m0_11 + m1_11) + h11 / 6.0 * (2.0 * m0_11d + m1_11d));
      x50 = p[t->driverpath[i] + k14] + slope16 * c11;
      x50d = pd[t->driverpath[i] + k14] + (slope16d * c11 + slope16 * c11d);
      x51 = slope16;
      x51d = slope16d;
      x52 = 0.0;
      x52d = 0.0;
    } else if (MAGGI_RE(a12) < 0.0) {
      slope16_2 = e11 + h11 / 6.0 * (m0_11 + 2.0 * m1_11);
      slope16_2d = e11d + (h11d / 6.0 * (m0_11 + 2.0 * m1_11) + h11 / 6.0 * (m0_11d + 2.0 *
          m1_11d));
      x50 = p[t->driverpath[i] + k14 + 1] - slope16_2 * a12;
      x50d = pd[t->driverpath[i] + k14 + 1] - (slope16_2d * a12 + slope16_2 * a12d);
      x51 = slope16_2;
      x51d = slope16_2d;
      x52 = 0.0;
      x52d = 0.0;
    } else {
      slope16_3 = e11 - h11 / 6.0 * (m1_11 - m0_11);
      slope16_3d = e11d - (h11d / 6.0 * (m1_11 - m0_11) + h11 / 6.0 * (m1_11d - m0_11d));
      t59 = 6.0 * h11;
      t59d = 6.0 * h11d;
      t60 = (m0_11 * a12 * a12 * a12 + m1_11 * c11 * c11 * c11) / t59;
      t59inv = 1.0 / t59;
      t60d = (((m0_11d * a12 + m0_11 * a12d) * a12 + m0_11 * a12 * a12d) * a12 + m0_11 * a12 * a12 *
          a12d + (((m1_11d * c11 + m1_11 * c11d) * c11 + m1_11 * c11 * c11d) * c11 + m1_11 * c11 *
          c11 * c11d) - t60 * t59d) * t59inv;
      x50 = t60 + p[t->driverpath[i] + k14] - m0_11 * h11 * h11 / 6.0 + slope16_3 * c11;
      x50d = t60d + pd[t->driverpath[i] + k14] - ((m0_11d * h11 + m0_11 * h11d) * h11 + m0_11 * h11
          * h11d) / 6.0 + (slope16_3d * c11 + slope16_3 * c11d);
      t61 = 2.0 * h11;
      t61d = 2.0 * h11d;
      t62 = (m1_11 * c11 * c11 - m0_11 * a12 * a12) / t61;
      t61inv = 1.0 / t61;
      t62d = ((m1_11d * c11 + m1_11 * c11d) * c11 + m1_11 * c11 * c11d - ((m0_11d * a12 + m0_11 *
          a12d) * a12 + m0_11 * a12 * a12d) - t62 * t61d) * t61inv;
      x51 = t62 + slope16_3;
      x51d = t62d + slope16_3d;
      t63 = (m0_11 * a12 + m1_11 * c11) / h11;
      t63d = (m0_11d * a12 + m0_11 * a12d + (m1_11d * c11 + m1_11 * c11d) - t63 * h11d) * h11inv;
      x52 = t63;
      x52d = t63d;
    }
    /* value and two derivatives at s */
    k15 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s5);
    h12 = path0[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k15][MAGGI_PATH_S];
    h12d = path0d[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k15][MAGGI_PATH_S];
    a13 = path0[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] - s5;
    a13d = path0d[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] - s5d;
    c12 = s5 - path0[t->driverrow[i] + k15][MAGGI_PATH_S];
    c12d = s5d - path0d[t->driverrow[i] + k15][MAGGI_PATH_S];
    m0_12 = path0[t->driverrow[i] + k15][MAGGI_PATH_Y];
    m0_12d = path0d[t->driverrow[i] + k15][MAGGI_PATH_Y];
    m1_12 = path0[t->driverrow[i] + k15 + 1][MAGGI_PATH_Y];
    m1_12d = path0d[t->driverrow[i] + k15 + 1][MAGGI_PATH_Y];
    e12 = (p[t->driverpath[i] + t->drivern[i] + k15 + 1] - p[t->driverpath[i] + t->drivern[i] +
        k15]) / h12;
    h12inv = 1.0 / h12;
    e12d = (pd[t->driverpath[i] + t->drivern[i] + k15 + 1] - pd[t->driverpath[i] + t->drivern[i] +
        k15] - e12 * h12d) * h12inv;
    if (MAGGI_RE(c12) < 0.0) {
      slope17 = e12 - h12 / 6.0 * (2.0 * m0_12 + m1_12);
      slope17d = e12d - (h12d / 6.0 * (2.0 * m0_12 + m1_12) + h12 / 6.0 * (2.0 * m0_12d + m1_12d));
      y50 = p[t->driverpath[i] + t->drivern[i] + k15] + slope17 * c12;
      y50d = pd[t->driverpath[i] + t->drivern[i] + k15] + (slope17d * c12 + slope17 * c12d);
      y51 = slope17;
      y51d = slope17d;
      y52 = 0.0;
      y52d = 0.0;
    } else if (MAGGI_RE(a13) < 0.0) {
      slope17_2 = e12 + h12 / 6.0 * (m0_12 + 2.0 * m1_12);
      slope17_2d = e12d + (h12d / 6.0 * (m0_12 + 2.0 * m1_12) + h12 / 6.0 * (m0_12d + 2.0 *
          m1_12d));
      y50 = p[t->driverpath[i] + t->drivern[i] + k15 + 1] - slope17_2 * a13;
      y50d = pd[t->driverpath[i] + t->drivern[i] + k15 + 1] - (slope17_2d * a13 + slope17_2 * a13d);
      y51 = slope17_2;
      y51d = slope17_2d;
      y52 = 0.0;
      y52d = 0.0;
    } else {
      slope17_3 = e12 - h12 / 6.0 * (m1_12 - m0_12);
      slope17_3d = e12d - (h12d / 6.0 * (m1_12 - m0_12) + h12 / 6.0 * (m1_12d - m0_12d));
      t64 = 6.0 * h12;
      t64d = 6.0 * h12d;
      t65 = (m0_12 * a13 * a13 * a13 + m1_12 * c12 * c12 * c12) / t64;
      t64inv = 1.0 / t64;
      t65d = (((m0_12d * a13 + m0_12 * a13d) * a13 + m0_12 * a13 * a13d) * a13 + m0_12 * a13 * a13 *
          a13d + (((m1_12d * c12 + m1_12 * c12d) * c12 + m1_12 * c12 * c12d) * c12 + m1_12 * c12 *
          c12 * c12d) - t65 * t64d) * t64inv;
      y50 = t65 + p[t->driverpath[i] + t->drivern[i] + k15] - m0_12 * h12 * h12 / 6.0 + slope17_3 *
          c12;
      y50d = t65d + pd[t->driverpath[i] + t->drivern[i] + k15] - ((m0_12d * h12 + m0_12 * h12d) *
          h12 + m0_12 * h12 * h12d) / 6.0 + (slope17_3d * c12 + slope17_3 * c12d);
      t66 = 2.0 * h12;
      t66d = 2.0 * h12d;
      t67 = (m1_12 * c12 * c12 - m0_12 * a13 * a13) / t66;
      t66inv = 1.0 / t66;
      t67d = ((m1_12d * c12 + m1_12 * c12d) * c12 + m1_12 * c12 * c12d - ((m0_12d * a13 + m0_12 *
          a13d) * a13 + m0_12 * a13 * a13d) - t67 * t66d) * t66inv;
      y51 = t67 + slope17_3;
      y51d = t67d + slope17_3d;
      t68 = (m0_12 * a13 + m1_12 * c12) / h12;
      t68d = (m0_12d * a13 + m0_12 * a13d + (m1_12d * c12 + m1_12 * c12d) - t68 * h12d) * h12inv;
      y52 = t68;
      y52d = t68d;
    }
    g6 = (x50 - P[0]) * x51 + (y50 - P[1]) * y51;
    /* one step of Newton's method; C, C', C'' at s */
    g6d = (x50d - Pd[0]) * x51 + (x50 - P[0]) * x51d + ((y50d - Pd[1]) * y51 + (y50 - P[1]) * y51d);
    slope18 = x51 * x51 + y51 * y51 + (x50 - P[0]) * x52 + (y50 - P[1]) * y52;
    slope18d = x51d * x51 + x51 * x51d + (y51d * y51 + y51 * y51d) + ((x50d - Pd[0]) * x52 + (x50 -
        P[0]) * x52d) + ((y50d - Pd[1]) * y52 + (y50 - P[1]) * y52d);
    t69 = g6 / slope18;
    slope18inv = 1.0 / slope18;
    t69d = (g6d - t69 * slope18d) * slope18inv;
    s6 = s5 - t69;
    s6d = s5d - t69d;
    s = s6;
    sd = s6d;
    /* value and two derivatives at s */
    k16 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s);
    h13 = path0[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k16][MAGGI_PATH_S];
    h13d = path0d[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k16][MAGGI_PATH_S];
    a14 = path0[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] - s;
    a14d = path0d[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] - sd;
    c13 = s - path0[t->driverrow[i] + k16][MAGGI_PATH_S];
    c13d = sd - path0d[t->driverrow[i] + k16][MAGGI_PATH_S];
    m0_13 = path0[t->driverrow[i] + k16][MAGGI_PATH_X];
    m0_13d = path0d[t->driverrow[i] + k16][MAGGI_PATH_X];
    m1_13 = path0[t->driverrow[i] + k16 + 1][MAGGI_PATH_X];
    m1_13d = path0d[t->driverrow[i] + k16 + 1][MAGGI_PATH_X];
    e13 = (p[t->driverpath[i] + k16 + 1] - p[t->driverpath[i] + k16]) / h13;
    h13inv = 1.0 / h13;
    e13d = (pd[t->driverpath[i] + k16 + 1] - pd[t->driverpath[i] + k16] - e13 * h13d) * h13inv;
    if (MAGGI_RE(c13) < 0.0) {
      slope19 = e13 - h13 / 6.0 * (2.0 * m0_13 + m1_13);
      slope19d = e13d - (h13d / 6.0 * (2.0 * m0_13 + m1_13) + h13 / 6.0 * (2.0 * m0_13d + m1_13d));
      x20 = p[t->driverpath[i] + k16] + slope19 * c13;
      x20d = pd[t->driverpath[i] + k16] + (slope19d * c13 + slope19 * c13d);
      x21 = slope19;
      x21d = slope19d;
      x22 = 0.0;
      x22d = 0.0;
    } else if (MAGGI_RE(a14) < 0.0) {
      slope19_2 = e13 + h13 / 6.0 * (m0_13 + 2.0 * m1_13);
      slope19_2d = e13d + (h13d / 6.0 * (m0_13 + 2.0 * m1_13) + h13 / 6.0 * (m0_13d + 2.0 *
          m1_13d));
      x20 = p[t->driverpath[i] + k16 + 1] - slope19_2 * a14;
      x20d = pd[t->driverpath[i] + k16 + 1] - (slope19_2d * a14 + slope19_2 * a14d);
      x21 = slope19_2;
      x21d = slope19_2d;
      x22 = 0.0;
      x22d = 0.0;
    } else {
      slope19_3 = e13 - h13 / 6.0 * (m1_13 - m0_13);
      slope19_3d = e13d - (h13d / 6.0 * (m1_13 - m0_13) + h13 / 6.0 * (m1_13d - m0_13d));
      t70 = 6.0 * h13;
      t70d = 6.0 * h13d;
      t71 = (m0_13 * a14 * a14 * a14 + m1_13 * c13 * c13 * c13) / t70;
      t70inv = 1.0 / t70;
      t71d = (((m0_13d * a14 + m0_13 * a14d) * a14 + m0_13 * a14 * a14d) * a14 + m0_13 * a14 * a14 *
          a14d + (((m1_13d * c13 + m1_13 * c13d) * c13 + m1_13 * c13 * c13d) * c13 + m1_13 * c13 *
          c13 * c13d) - t71 * t70d) * t70inv;
      x20 = t71 + p[t->driverpath[i] + k16] - m0_13 * h13 * h13 / 6.0 + slope19_3 * c13;
      x20d = t71d + pd[t->driverpath[i] + k16] - ((m0_13d * h13 + m0_13 * h13d) * h13 + m0_13 * h13
          * h13d) / 6.0 + (slope19_3d * c13 + slope19_3 * c13d);
      t72 = 2.0 * h13;
      t72d = 2.0 * h13d;
      t73 = (m1_13 * c13 * c13 - m0_13 * a14 * a14) / t72;
      t72inv = 1.0 / t72;
      t73d = ((m1_13d * c13 + m1_13 * c13d) * c13 + m1_13 * c13 * c13d - ((m0_13d * a14 + m0_13 *
          a14d) * a14 + m0_13 * a14 * a14d) - t73 * t72d) * t72inv;
      x21 = t73 + slope19_3;
      x21d = t73d + slope19_3d;
      t74 = (m0_13 * a14 + m1_13 * c13) / h13;
      t74d = (m0_13d * a14 + m0_13 * a14d + (m1_13d * c13 + m1_13 * c13d) - t74 * h13d) * h13inv;
      x22 = t74;
      x22d = t74d;
    }
    /* value and two derivatives at s */
    k17 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s);
    h14 = path0[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k17][MAGGI_PATH_S];
    h14d = path0d[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
        k17][MAGGI_PATH_S];
    a15 = path0[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] - s;
    a15d = path0d[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] - sd;
    c14 = s - path0[t->driverrow[i] + k17][MAGGI_PATH_S];
    c14d = sd - path0d[t->driverrow[i] + k17][MAGGI_PATH_S];
    m0_14 = path0[t->driverrow[i] + k17][MAGGI_PATH_Y];
    m0_14d = path0d[t->driverrow[i] + k17][MAGGI_PATH_Y];
    m1_14 = path0[t->driverrow[i] + k17 + 1][MAGGI_PATH_Y];
    m1_14d = path0d[t->driverrow[i] + k17 + 1][MAGGI_PATH_Y];
    e14 = (p[t->driverpath[i] + t->drivern[i] + k17 + 1] - p[t->driverpath[i] + t->drivern[i] +
        k17]) / h14;
    h14inv = 1.0 / h14;
    e14d = (pd[t->driverpath[i] + t->drivern[i] + k17 + 1] - pd[t->driverpath[i] + t->drivern[i] +
        k17] - e14 * h14d) * h14inv;
    if (MAGGI_RE(c14) < 0.0) {
      slope20 = e14 - h14 / 6.0 * (2.0 * m0_14 + m1_14);
      slope20d = e14d - (h14d / 6.0 * (2.0 * m0_14 + m1_14) + h14 / 6.0 * (2.0 * m0_14d + m1_14d));
      y0_2 = p[t->driverpath[i] + t->drivern[i] + k17] + slope20 * c14;
      y0_2d = pd[t->driverpath[i] + t->drivern[i] + k17] + (slope20d * c14 + slope20 * c14d);
      y1_2 = slope20;
      y1_2d = slope20d;
      y2_2 = 0.0;
      y2_2d = 0.0;
    } else if (MAGGI_RE(a15) < 0.0) {
      slope20_2 = e14 + h14 / 6.0 * (m0_14 + 2.0 * m1_14);
      slope20_2d = e14d + (h14d / 6.0 * (m0_14 + 2.0 * m1_14) + h14 / 6.0 * (m0_14d + 2.0 *
          m1_14d));
      y0_2 = p[t->driverpath[i] + t->drivern[i] + k17 + 1] - slope20_2 * a15;
      y0_2d = pd[t->driverpath[i] + t->drivern[i] + k17 + 1] - (slope20_2d * a15 + slope20_2 *
          a15d);
      y1_2 = slope20_2;
      y1_2d = slope20_2d;
      y2_2 = 0.0;
      y2_2d = 0.0;
    } else {
      slope20_3 = e14 - h14 / 6.0 * (m1_14 - m0_14);
      slope20_3d = e14d - (h14d / 6.0 * (m1_14 - m0_14) + h14 / 6.0 * (m1_14d - m0_14d));
      t75 = 6.0 * h14;
      t75d = 6.0 * h14d;
      t76 = (m0_14 * a15 * a15 * a15 + m1_14 * c14 * c14 * c14) / t75;
      t75inv = 1.0 / t75;
      t76d = (((m0_14d * a15 + m0_14 * a15d) * a15 + m0_14 * a15 * a15d) * a15 + m0_14 * a15 * a15 *
          a15d + (((m1_14d * c14 + m1_14 * c14d) * c14 + m1_14 * c14 * c14d) * c14 + m1_14 * c14 *
          c14 * c14d) - t76 * t75d) * t75inv;
      y0_2 = t76 + p[t->driverpath[i] + t->drivern[i] + k17] - m0_14 * h14 * h14 / 6.0 + slope20_3 *
          c14;
      y0_2d = t76d + pd[t->driverpath[i] + t->drivern[i] + k17] - ((m0_14d * h14 + m0_14 * h14d) *
          h14 + m0_14 * h14 * h14d) / 6.0 + (slope20_3d * c14 + slope20_3 * c14d);
      t77 = 2.0 * h14;
      t77d = 2.0 * h14d;
      t78 = (m1_14 * c14 * c14 - m0_14 * a15 * a15) / t77;
      t77inv = 1.0 / t77;
      t78d = ((m1_14d * c14 + m1_14 * c14d) * c14 + m1_14 * c14 * c14d - ((m0_14d * a15 + m0_14 *
          a15d) * a15 + m0_14 * a15 * a15d) - t78 * t77d) * t77inv;
      y1_2 = t78 + slope20_3;
      y1_2d = t78d + slope20_3d;
      t79 = (m0_14 * a15 + m1_14 * c14) / h14;
      t79d = (m0_14d * a15 + m0_14 * a15d + (m1_14d * c14 + m1_14 * c14d) - t79 * h14d) * h14inv;
      y2_2 = t79;
      y2_2d = t79d;
    }
    t80 = x21 * x21 + y1_2 * y1_2;
    t80d = x21d * x21 + x21 * x21d + (y1_2d * y1_2 + y1_2 * y1_2d);
    length = sqrt(t80);
    c16 = 1.0 / (2.0 * length);
    lengthd = c16 * t80d;
    error = driver[i][0];
    lengthinv = 1.0 / length;
    errord = ((y0_2d - Pd[1]) * x21 + (y0_2 - P[1]) * x21d - ((x20d - Pd[0]) * y1_2 + (x20 - P[0]) *
        y1_2d) - error * lengthd) * lengthinv;
    t81 = length * length * length;
    t81d = (lengthd * length + length * lengthd) * length + length * length * lengthd;
    curvature = (x21 * y2_2 - y1_2 * x22) / t81;
    t81inv = 1.0 / t81;
    curvatured = (x21d * y2_2 + x21 * y2_2d - (y1_2d * x22 + y1_2 * x22d) - curvature * t81d) *
        t81inv;
    limit = p[t->driveradr[i] + MAGGI_DRIVER_LIMIT];
    limitd = pd[t->driveradr[i] + MAGGI_DRIVER_LIMIT];
    t82 = (p[t->driveradr[i] + MAGGI_DRIVER_GAIN] * error + p[t->driveradr[i] +
        MAGGI_DRIVER_FEEDFORWARD] * curvature) / limit;
    limitinv = 1.0 / limit;
    t82d = (pd[t->driveradr[i] + MAGGI_DRIVER_GAIN] * error + p[t->driveradr[i] + MAGGI_DRIVER_GAIN]
        * errord + (pd[t->driveradr[i] + MAGGI_DRIVER_FEEDFORWARD] * curvature + p[t->driveradr[i] +
        MAGGI_DRIVER_FEEDFORWARD] * curvatured) - t82 * limitd) * limitinv;
    t83 = tanh(t82);
    t83d = (1.0 - t83 * t83) * t82d;
    demand = driver[i][2];
    demandd = limitd * t83 + limit * t83d;
    steer0d = pd[t->driveradr[i] + MAGGI_DRIVER_STIFFNESS] * (demand - q[k]) + p[t->driveradr[i] +
        MAGGI_DRIVER_STIFFNESS] * (demandd - qd[k]) - (pd[t->driveradr[i] + MAGGI_DRIVER_DAMPING] *
        v[k] + p[t->driveradr[i] + MAGGI_DRIVER_DAMPING] * vd[k]);
    driverd[i][0] = errord;
    driverd[i][1] = sd;
    driverd[i][2] = demandd;
    if (t->driverspeeds[i]) {
      /* value and two derivatives at s */
      k18 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s);
      h15 = path0[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
          k18][MAGGI_PATH_S];
      h15d = path0d[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] +
          k18][MAGGI_PATH_S];
      a16 = path0[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] - s;
      a16d = path0d[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] - sd;
      c15 = s - path0[t->driverrow[i] + k18][MAGGI_PATH_S];
      c15d = sd - path0d[t->driverrow[i] + k18][MAGGI_PATH_S];
      m0_15 = path0[t->driverrow[i] + k18][MAGGI_PATH_V];
      m0_15d = path0d[t->driverrow[i] + k18][MAGGI_PATH_V];
      m1_15 = path0[t->driverrow[i] + k18 + 1][MAGGI_PATH_V];
      m1_15d = path0d[t->driverrow[i] + k18 + 1][MAGGI_PATH_V];
      e15 = (p[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] - p[t->driverpath[i] + 2 *
          t->drivern[i] + k18]) / h15;
      h15inv = 1.0 / h15;
      e15d = (pd[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] - pd[t->driverpath[i] + 2 *
          t->drivern[i] + k18] - e15 * h15d) * h15inv;
      if (MAGGI_RE(c15) < 0.0) {
        slope21 = e15 - h15 / 6.0 * (2.0 * m0_15 + m1_15);
        slope21d = e15d - (h15d / 6.0 * (2.0 * m0_15 + m1_15) + h15 / 6.0 * (2.0 * m0_15d +
            m1_15d));
        z0d = pd[t->driverpath[i] + 2 * t->drivern[i] + k18] + (slope21d * c15 + slope21 * c15d);
      } else if (MAGGI_RE(a16) < 0.0) {
        slope21_2 = e15 + h15 / 6.0 * (m0_15 + 2.0 * m1_15);
        slope21_2d = e15d + (h15d / 6.0 * (m0_15 + 2.0 * m1_15) + h15 / 6.0 * (m0_15d + 2.0 *
            m1_15d));
        z0d = pd[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] - (slope21_2d * a16 + slope21_2 *
            a16d);
      } else {
        slope21_3 = e15 - h15 / 6.0 * (m1_15 - m0_15);
        slope21_3d = e15d - (h15d / 6.0 * (m1_15 - m0_15) + h15 / 6.0 * (m1_15d - m0_15d));
        t84 = 6.0 * h15;
        t84d = 6.0 * h15d;
        t85 = (m0_15 * a16 * a16 * a16 + m1_15 * c15 * c15 * c15) / t84;
        t84inv = 1.0 / t84;
        t85d = (((m0_15d * a16 + m0_15 * a16d) * a16 + m0_15 * a16 * a16d) * a16 + m0_15 * a16 * a16
            * a16d + (((m1_15d * c15 + m1_15 * c15d) * c15 + m1_15 * c15 * c15d) * c15 + m1_15 * c15
            * c15 * c15d) - t85 * t84d) * t84inv;
        z0d = t85d + pd[t->driverpath[i] + 2 * t->drivern[i] + k18] - ((m0_15d * h15 + m0_15 * h15d)
            * h15 + m0_15 * h15 * h15d) / 6.0 + (slope21_3d * c15 + slope21_3 * c15d);
      }
      driverd[i][3] = z0d;
    } else {
      driverd[i][3] = 0.0;
    }
    if (t->driverheld[i] == 0) {
      taud[k] += steer0d;
    }
  }
  for (i = 0; i < t->nspeed; ++i) {
    if (t->speedfun[i] >= 0) {
      factor = fun[t->speedfun[i]][0];
      factord = fund[t->speedfun[i]][0];
    } else {
      factor = 1.0;
      factord = 0.0;
    }
    if (t->speeddriver[i] >= 0) {
      targetd = driverd[t->speeddriver[i]][3] * factor + driver[t->speeddriver[i]][3] * factord;
    } else {
      targetd = pd[t->speedadr[i]] * factor + p[t->speedadr[i]] * factord;
    }
    rv_i0 = rv[t->speedpoint[i]][0];
    rv_i0d = rvd[t->speedpoint[i]][0];
    rv_i1 = rv[t->speedpoint[i]][1];
    rv_i1d = rvd[t->speedpoint[i]][1];
    rv_i2 = rv[t->speedpoint[i]][2];
    rv_i2d = rvd[t->speedpoint[i]][2];
    p2 = p[t->speedadr[i] + MAGGI_SPEED_LOW];
    p2d = pd[t->speedadr[i] + MAGGI_SPEED_LOW];
    /* error, torque on each coordinate, speed */
    t86d = rv_i0d * rv_i0 + rv_i0 * rv_i0d + (rv_i1d * rv_i1 + rv_i1 * rv_i1d) + (rv_i2d * rv_i2 +
        rv_i2 * rv_i2d) + (p2d * p2 + p2 * p2d);
    speed2 = speed[i][2];
    c17 = 1.0 / (2.0 * speed2);
    speed2d = c17 * t86d;
    e16 = speed[i][0];
    e16d = targetd - speed2d;
    gain = p[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    gaind = pd[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE] +
        p[t->speedadr[i] + MAGGI_SPEED_GAIN] * pd[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    speedd[i][0] = e16d;
    if (t->speedlinear[i]) {
      speedd[i][1] = gaind * e16 + gain * e16d;
    } else {
      t87 = fabs(e16);
      c18 = MAGGI_RE(e16) < 0.0 ? -1.0 : 1.0;
      t87d = c18 * e16d;
      speedd[i][1] = (gaind * e16 + gain * e16d) * t87 + gain * e16 * t87d;
    }
    speedd[i][2] = speed2d;
    if (t->speedheld[i]) {
      torqued = 0.0;
    } else {
      torqued = speedd[i][1];
    }
    for (k19 = t->speedqadr[i]; k19 < t->speedqadr[i] + t->speedqnum[i]; ++k19) {
      taud[t->speedq[k19]] += torqued;
    }
  }
}
