/* Adjoint of core/kernel/control.c.
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
void maggi_control_forces_b(const maggi_topo *t, const double p[restrict t->np],
                            double pb[restrict t->np], const double fun[restrict t->nfun][3],
                            double funb[restrict t->nfun][3],
                            const double path0[restrict t->npath0][8],
                            double path0b[restrict t->npath0][8], const double q[restrict t->nq],
                            double qb[restrict t->nq], const double v[restrict t->nq],
                            double vb[restrict t->nq], const double r[restrict t->npoint][3],
                            double rb[restrict t->npoint][3],
                            const double rv[restrict t->npoint][3],
                            double rvb[restrict t->npoint][3],
                            double driver[restrict t->ndriver][4],
                            double driverb[restrict t->ndriver][4],
                            double speed[restrict t->nspeed][3],
                            double speedb[restrict t->nspeed][3], double tau[restrict t->nq],
                            double taub[restrict t->nq], double power[restrict 1])
{
  int a, b, i, k, k10, k11, k12, k13, k14, k15, k16, k17, k18, k19, k20, k3, k4, k5, k6, k7, k8, k9;
  double a10, a10b, a11, a11b, a12, a12b, a13, a13b, a14, a14b, a15, a15b, a16, a16b, a2, a2b, a3,
      a3b, a4, a4b, a5, a5b, a6, a6b, a7, a7b, a8, a8b, a9, a9b, c, c10, c10b, c11, c11b, c12, c12b,
      c13, c13b, c14, c14b, c15, c15b, c2, c2b, c3, c3b, c4, c4b, c5, c5b, c6, c6b, c7, c7b, c8,
      c8b, c9, c9b, cb, curvature, curvatureb, demand, demandb, dx, dxb, dy, dyb, e, e10, e10b, e11,
      e11b, e12, e12b, e13, e13b, e14, e14b, e15, e15b, e16, e16b, e2, e2b, e3, e3b, e4, e4b, e5,
      e5b, e6, e6b, e7, e7b, e8, e8b, e9, e9b, eb, error, errorb, factor, factorb, g, g2, g2b, g3,
      g3b, g4, g4b, g5, g5b, g6, g6b, gain, gainb, gb, h, h10, h10b, h11, h11b, h12, h12b, h13,
      h13b, h14, h14b, h15, h15b, h2, h2b, h3, h3b, h4, h4b, h5, h5b, h6, h6b, h7, h7b, h8, h8b, h9,
      h9b, hb, length, lengthb, limit, limitb, m0, m0_10, m0_10b, m0_11, m0_11b, m0_12, m0_12b,
      m0_13, m0_13b, m0_14, m0_14b, m0_15, m0_15b, m0_2, m0_2b, m0_3, m0_3b, m0_4, m0_4b, m0_5,
      m0_5b, m0_6, m0_6b, m0_7, m0_7b, m0_8, m0_8b, m0_9, m0_9b, m0b, m1, m1_10, m1_10b, m1_11,
      m1_11b, m1_12, m1_12b, m1_13, m1_13b, m1_14, m1_14b, m1_15, m1_15b, m1_2, m1_2b, m1_3, m1_3b,
      m1_4, m1_4b, m1_5, m1_5b, m1_6, m1_6b, m1_7, m1_7b, m1_8, m1_8b, m1_9, m1_9b, m1b, p2, p2b,
      p_i, p_ib, rv_i0, rv_i0b, rv_i1, rv_i1b, rv_i2, rv_i2b, s, s0, s0b, s1, s1b, s2, s2b, s3, s3b,
      s4, s4b, s5, s5b, s6, s6b, sb, slope, slope10, slope10_2, slope10_2b, slope10_3, slope10_3b,
      slope10b, slope11, slope11_2, slope11_2b, slope11_3, slope11_3b, slope11b, slope12, slope12b,
      slope13, slope13_2, slope13_2b, slope13_3, slope13_3b, slope13b, slope14, slope14_2,
      slope14_2b, slope14_3, slope14_3b, slope14b, slope15, slope15b, slope16, slope16_2,
      slope16_2b, slope16_3, slope16_3b, slope16b, slope17, slope17_2, slope17_2b, slope17_3,
      slope17_3b, slope17b, slope18, slope18b, slope19, slope19_2, slope19_2b, slope19_3,
      slope19_3b, slope19b, slope2, slope20, slope20_2, slope20_2b, slope20_3, slope20_3b, slope20b,
      slope21, slope21_2, slope21_2b, slope21_3, slope21_3b, slope21b, slope22, slope22_2,
      slope22_2b, slope22b, slope2_2, slope2_2b, slope2_3, slope2_3b, slope2b, slope3, slope3b,
      slope4, slope4_2, slope4_2b, slope4_3, slope4_3b, slope4b, slope5, slope5_2, slope5_2b,
      slope5_3, slope5_3b, slope5b, slope6, slope6b, slope7, slope7_2, slope7_2b, slope7_3,
      slope7_3b, slope7b, slope8, slope8_2, slope8_2b, slope8_3, slope8_3b, slope8b, slope9,
      slope9b, slopeb, speed2, speed2b, steer0b, t10, t10b, t11, t11b, t12, t12b, t13, t13b, t14,
      t14b, t15, t15b, t16, t16b, t17, t17b, t18, t18b, t19, t19b, t2, t20, t20b, t21, t21b, t22,
      t22b, t23, t23b, t24, t24b, t25, t25b, t26, t26b, t27, t27b, t28, t28b, t29, t29b, t2b, t3,
      t30, t30b, t31, t31b, t32, t32b, t33, t33b, t34, t34b, t35, t35b, t36, t36b, t37, t37b, t38,
      t38b, t39, t39b, t3b, t4, t40, t40b, t41, t41b, t42, t42b, t43, t43b, t44, t44b, t45, t45b,
      t46, t46b, t47, t47b, t48, t48b, t49, t49b, t4b, t5, t50, t50b, t51, t51b, t52, t52b, t53,
      t53b, t54, t54b, t55, t55b, t56, t56b, t57, t57b, t58, t58b, t59, t59b, t5b, t6, t60, t60b,
      t61, t61b, t62, t62b, t63, t63b, t64, t64b, t65, t65b, t66, t66b, t67, t67b, t68, t68b, t69,
      t69b, t6b, t7, t70, t70b, t71, t71b, t72, t72b, t73, t73b, t74, t74b, t75, t75b, t76, t76b,
      t77, t77b, t78, t78b, t79, t79b, t7b, t8, t80, t80b, t81, t81b, t82, t82b, t83, t83b, t84,
      t84b, t85, t85b, t86b, t87, t87b, t8b, t9, t9b, targetb, tb10, tb100, tb101, tb102, tb103,
      tb104, tb105, tb106, tb107, tb108, tb109, tb11, tb110, tb111, tb112, tb113, tb114, tb115,
      tb116, tb117, tb118, tb119, tb12, tb120, tb121, tb122, tb123, tb124, tb125, tb126, tb127,
      tb128, tb129, tb13, tb130, tb131, tb132, tb133, tb134, tb135, tb136, tb137, tb138, tb139,
      tb14, tb140, tb141, tb142, tb143, tb144, tb145, tb146, tb147, tb148, tb149, tb15, tb150,
      tb151, tb152, tb153, tb154, tb155, tb156, tb157, tb158, tb159, tb16, tb160, tb161, tb162,
      tb163, tb164, tb165, tb166, tb167, tb168, tb169, tb17, tb170, tb171, tb172, tb173, tb174,
      tb175, tb176, tb177, tb178, tb179, tb18, tb180, tb181, tb182, tb183, tb184, tb185, tb186,
      tb187, tb188, tb189, tb19, tb190, tb191, tb192, tb193, tb194, tb195, tb196, tb197, tb198,
      tb199, tb2, tb20, tb200, tb201, tb202, tb203, tb204, tb205, tb206, tb207, tb208, tb209, tb21,
      tb210, tb211, tb212, tb213, tb214, tb215, tb216, tb217, tb218, tb219, tb22, tb220, tb221,
      tb222, tb223, tb224, tb225, tb226, tb227, tb228, tb229, tb23, tb230, tb231, tb232, tb233,
      tb234, tb235, tb236, tb237, tb238, tb239, tb24, tb240, tb241, tb242, tb243, tb244, tb245,
      tb246, tb247, tb248, tb249, tb25, tb250, tb251, tb252, tb253, tb254, tb255, tb256, tb257,
      tb258, tb259, tb26, tb260, tb261, tb262, tb263, tb264, tb265, tb266, tb267, tb268, tb27, tb28,
      tb29, tb3, tb30, tb31, tb32, tb33, tb34, tb35, tb36, tb37, tb38, tb39, tb4, tb40, tb41, tb42,
      tb43, tb44, tb45, tb46, tb47, tb48, tb49, tb5, tb50, tb51, tb52, tb53, tb54, tb55, tb56, tb57,
      tb58, tb59, tb6, tb60, tb61, tb62, tb63, tb64, tb65, tb66, tb67, tb68, tb69, tb7, tb70, tb71,
      tb72, tb73, tb74, tb75, tb76, tb77, tb78, tb79, tb8, tb80, tb81, tb82, tb83, tb84, tb85, tb86,
      tb87, tb88, tb89, tb9, tb90, tb91, tb92, tb93, tb94, tb95, tb96, tb97, tb98, tb99, torqueb,
      x00, x00b, x01, x01b, x02, x02b, x0_2, x0_2b, x10, x10b, x11, x11b, x12, x12b, x1_2, x1_2b,
      x20, x20b, x21, x21b, x22, x22b, x2_4, x2_4b, x2_5, x2_5b, x2_6, x2_6b, x30, x30b, x31, x31b,
      x32, x32b, x40, x40b, x41, x41b, x42, x42b, x50, x50b, x51, x51b, x52, x52b, y00, y00b, y01,
      y01b, y02, y02b, y0_2, y0_2b, y10, y10b, y11, y11b, y12, y12b, y1_2, y1_2b, y20, y20b, y21,
      y21b, y22, y22b, y2_2, y2_2b, y30, y30b, y31, y31b, y32, y32b, y40, y40b, y41, y41b, y42,
      y42b, y50, y50b, y51, y51b, y52, y52b, z0b;
  double P[2], Pb[2];

  (void)tau;
  (void)power;
  for (i = t->nspeed - 1; i >= 0; --i) {
    if (t->speedfun[i] >= 0) {
      factor = fun[t->speedfun[i]][0];
    } else {
      factor = 1.0;
    }
    rv_i0 = rv[t->speedpoint[i]][0];
    rv_i1 = rv[t->speedpoint[i]][1];
    rv_i2 = rv[t->speedpoint[i]][2];
    p2 = p[t->speedadr[i] + MAGGI_SPEED_LOW];
    speed2 = speed[i][2];
    e16 = speed[i][0];
    gain = p[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    torqueb = 0.0;
    for (k19 = t->speedqadr[i] + t->speedqnum[i] - 1; k19 >= t->speedqadr[i]; --k19) {
      torqueb += taub[t->speedq[k19]];
    }
    if (t->speedheld[i]) {
      torqueb = 0.0;
    } else {
      speedb[i][1] += torqueb;
      torqueb = 0.0;
    }
    speed2b = speedb[i][2];
    speedb[i][2] = 0.0;
    e16b = 0.0;
    gainb = 0.0;
    if (t->speedlinear[i]) {
      tb266 = speedb[i][1];
      speedb[i][1] = 0.0;
      gainb += tb266 * e16;
      e16b += tb266 * gain;
    } else {
      t87 = fabs(e16);
      tb267 = speedb[i][1];
      speedb[i][1] = 0.0;
      tb268 = tb267 * t87;
      gainb += tb268 * e16;
      e16b += tb268 * gain;
      t87b = tb267 * (gain * e16);
      e16b += t87b * (MAGGI_RE(e16) < 0.0 ? -1.0 : 1.0);
    }
    e16b += speedb[i][0];
    speedb[i][0] = 0.0;
    pb[t->speedadr[i] + MAGGI_SPEED_GAIN] += gainb * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    pb[t->speedadr[i] + MAGGI_SPEED_TORQUE] += gainb * p[t->speedadr[i] + MAGGI_SPEED_GAIN];
    targetb = e16b;
    speed2b -= e16b;
    t86b = speed2b * (1.0 / (2.0 * speed2));
    /* error, torque on each coordinate, speed */
    rv_i0b = t86b * rv_i0;
    rv_i0b += t86b * rv_i0;
    rv_i1b = t86b * rv_i1;
    rv_i1b += t86b * rv_i1;
    rv_i2b = t86b * rv_i2;
    rv_i2b += t86b * rv_i2;
    p2b = t86b * p2;
    p2b += t86b * p2;
    pb[t->speedadr[i] + MAGGI_SPEED_LOW] += p2b;
    rvb[t->speedpoint[i]][2] += rv_i2b;
    rvb[t->speedpoint[i]][1] += rv_i1b;
    rvb[t->speedpoint[i]][0] += rv_i0b;
    factorb = 0.0;
    if (t->speeddriver[i] >= 0) {
      driverb[t->speeddriver[i]][3] += targetb * factor;
      factorb += targetb * driver[t->speeddriver[i]][3];
      targetb = 0.0;
    } else {
      pb[t->speedadr[i]] += targetb * factor;
      factorb += targetb * p[t->speedadr[i]];
      targetb = 0.0;
    }
    if (t->speedfun[i] >= 0) {
      funb[t->speedfun[i]][0] += factorb;
      factorb = 0.0;
    } else {
      factorb = 0.0;
    }
  }
  for (i = t->ndriver - 1; i >= 0; --i) {
    a = t->driverpoint[i];
    b = t->driverorigin[i];
    x0_2 = r[a][0] - r[b][0];
    x1_2 = r[a][1] - r[b][1];
    k = t->driverq[i];
    p_i = p[t->driveradr[i]];
    P[0] = x0_2 + p_i * rv[a][0];
    P[1] = x1_2 + p_i * rv[a][1];
    k3 = path_nearest_nodiff(t->np, p, t->driverpath[i], t->drivern[i], P);
    dx = p[t->driverpath[i] + k3 + 1] - p[t->driverpath[i] + k3];
    dy = p[t->driverpath[i] + t->drivern[i] + k3 + 1] - p[t->driverpath[i] + t->drivern[i] + k3];
    t2 = dx * dx + dy * dy;
    t3 = ((P[0] - p[t->driverpath[i] + k3]) * dx + (P[1] - p[t->driverpath[i] + t->drivern[i] + k3])
        * dy) / t2;
    s0 = path0[t->driverrow[i] + k3][MAGGI_PATH_S] + t3 * (path0[t->driverrow[i] + k3 +
        1][MAGGI_PATH_S] - path0[t->driverrow[i] + k3][MAGGI_PATH_S]);
    k4 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s0);
    h = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k4][MAGGI_PATH_S];
    a2 = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] - s0;
    c = s0 - path0[t->driverrow[i] + k4][MAGGI_PATH_S];
    m0 = path0[t->driverrow[i] + k4][MAGGI_PATH_X];
    m1 = path0[t->driverrow[i] + k4 + 1][MAGGI_PATH_X];
    e = (p[t->driverpath[i] + k4 + 1] - p[t->driverpath[i] + k4]) / h;
    if (MAGGI_RE(c) < 0.0) {
      slope = e - h / 6.0 * (2.0 * m0 + m1);
      x00 = p[t->driverpath[i] + k4] + slope * c;
      x01 = slope;
      x02 = 0.0;
    } else if (MAGGI_RE(a2) < 0.0) {
      slope22 = e + h / 6.0 * (m0 + 2.0 * m1);
      x00 = p[t->driverpath[i] + k4 + 1] - slope22 * a2;
      x01 = slope22;
      x02 = 0.0;
    } else {
      slope22_2 = e - h / 6.0 * (m1 - m0);
      t4 = 6.0 * h;
      t5 = (m0 * a2 * a2 * a2 + m1 * c * c * c) / t4;
      x00 = t5 + p[t->driverpath[i] + k4] - m0 * h * h / 6.0 + slope22_2 * c;
      t6 = 2.0 * h;
      t7 = (m1 * c * c - m0 * a2 * a2) / t6;
      x01 = t7 + slope22_2;
      t8 = (m0 * a2 + m1 * c) / h;
      x02 = t8;
    }
    k5 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s0);
    h2 = path0[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k5][MAGGI_PATH_S];
    a3 = path0[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] - s0;
    c2 = s0 - path0[t->driverrow[i] + k5][MAGGI_PATH_S];
    m0_2 = path0[t->driverrow[i] + k5][MAGGI_PATH_Y];
    m1_2 = path0[t->driverrow[i] + k5 + 1][MAGGI_PATH_Y];
    e2 = (p[t->driverpath[i] + t->drivern[i] + k5 + 1] - p[t->driverpath[i] + t->drivern[i] + k5]) /
        h2;
    if (MAGGI_RE(c2) < 0.0) {
      slope2 = e2 - h2 / 6.0 * (2.0 * m0_2 + m1_2);
      y00 = p[t->driverpath[i] + t->drivern[i] + k5] + slope2 * c2;
      y01 = slope2;
      y02 = 0.0;
    } else if (MAGGI_RE(a3) < 0.0) {
      slope2_2 = e2 + h2 / 6.0 * (m0_2 + 2.0 * m1_2);
      y00 = p[t->driverpath[i] + t->drivern[i] + k5 + 1] - slope2_2 * a3;
      y01 = slope2_2;
      y02 = 0.0;
    } else {
      slope2_3 = e2 - h2 / 6.0 * (m1_2 - m0_2);
      t9 = 6.0 * h2;
      t10 = (m0_2 * a3 * a3 * a3 + m1_2 * c2 * c2 * c2) / t9;
      y00 = t10 + p[t->driverpath[i] + t->drivern[i] + k5] - m0_2 * h2 * h2 / 6.0 + slope2_3 * c2;
      t11 = 2.0 * h2;
      t12 = (m1_2 * c2 * c2 - m0_2 * a3 * a3) / t11;
      y01 = t12 + slope2_3;
      t13 = (m0_2 * a3 + m1_2 * c2) / h2;
      y02 = t13;
    }
    g = (x00 - P[0]) * x01 + (y00 - P[1]) * y01;
    slope3 = x01 * x01 + y01 * y01 + (x00 - P[0]) * x02 + (y00 - P[1]) * y02;
    t14 = g / slope3;
    s1 = s0 - t14;
    k6 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s1);
    h3 = path0[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k6][MAGGI_PATH_S];
    a4 = path0[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] - s1;
    c3 = s1 - path0[t->driverrow[i] + k6][MAGGI_PATH_S];
    m0_3 = path0[t->driverrow[i] + k6][MAGGI_PATH_X];
    m1_3 = path0[t->driverrow[i] + k6 + 1][MAGGI_PATH_X];
    e3 = (p[t->driverpath[i] + k6 + 1] - p[t->driverpath[i] + k6]) / h3;
    if (MAGGI_RE(c3) < 0.0) {
      slope4 = e3 - h3 / 6.0 * (2.0 * m0_3 + m1_3);
      x10 = p[t->driverpath[i] + k6] + slope4 * c3;
      x11 = slope4;
      x12 = 0.0;
    } else if (MAGGI_RE(a4) < 0.0) {
      slope4_2 = e3 + h3 / 6.0 * (m0_3 + 2.0 * m1_3);
      x10 = p[t->driverpath[i] + k6 + 1] - slope4_2 * a4;
      x11 = slope4_2;
      x12 = 0.0;
    } else {
      slope4_3 = e3 - h3 / 6.0 * (m1_3 - m0_3);
      t15 = 6.0 * h3;
      t16 = (m0_3 * a4 * a4 * a4 + m1_3 * c3 * c3 * c3) / t15;
      x10 = t16 + p[t->driverpath[i] + k6] - m0_3 * h3 * h3 / 6.0 + slope4_3 * c3;
      t17 = 2.0 * h3;
      t18 = (m1_3 * c3 * c3 - m0_3 * a4 * a4) / t17;
      x11 = t18 + slope4_3;
      t19 = (m0_3 * a4 + m1_3 * c3) / h3;
      x12 = t19;
    }
    k7 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s1);
    h4 = path0[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k7][MAGGI_PATH_S];
    a5 = path0[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] - s1;
    c4 = s1 - path0[t->driverrow[i] + k7][MAGGI_PATH_S];
    m0_4 = path0[t->driverrow[i] + k7][MAGGI_PATH_Y];
    m1_4 = path0[t->driverrow[i] + k7 + 1][MAGGI_PATH_Y];
    e4 = (p[t->driverpath[i] + t->drivern[i] + k7 + 1] - p[t->driverpath[i] + t->drivern[i] + k7]) /
        h4;
    if (MAGGI_RE(c4) < 0.0) {
      slope5 = e4 - h4 / 6.0 * (2.0 * m0_4 + m1_4);
      y10 = p[t->driverpath[i] + t->drivern[i] + k7] + slope5 * c4;
      y11 = slope5;
      y12 = 0.0;
    } else if (MAGGI_RE(a5) < 0.0) {
      slope5_2 = e4 + h4 / 6.0 * (m0_4 + 2.0 * m1_4);
      y10 = p[t->driverpath[i] + t->drivern[i] + k7 + 1] - slope5_2 * a5;
      y11 = slope5_2;
      y12 = 0.0;
    } else {
      slope5_3 = e4 - h4 / 6.0 * (m1_4 - m0_4);
      t20 = 6.0 * h4;
      t21 = (m0_4 * a5 * a5 * a5 + m1_4 * c4 * c4 * c4) / t20;
      y10 = t21 + p[t->driverpath[i] + t->drivern[i] + k7] - m0_4 * h4 * h4 / 6.0 + slope5_3 * c4;
      t22 = 2.0 * h4;
      t23 = (m1_4 * c4 * c4 - m0_4 * a5 * a5) / t22;
      y11 = t23 + slope5_3;
      t24 = (m0_4 * a5 + m1_4 * c4) / h4;
      y12 = t24;
    }
    g2 = (x10 - P[0]) * x11 + (y10 - P[1]) * y11;
    slope6 = x11 * x11 + y11 * y11 + (x10 - P[0]) * x12 + (y10 - P[1]) * y12;
    t25 = g2 / slope6;
    s2 = s1 - t25;
    k8 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s2);
    h5 = path0[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k8][MAGGI_PATH_S];
    a6 = path0[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] - s2;
    c5 = s2 - path0[t->driverrow[i] + k8][MAGGI_PATH_S];
    m0_5 = path0[t->driverrow[i] + k8][MAGGI_PATH_X];
    m1_5 = path0[t->driverrow[i] + k8 + 1][MAGGI_PATH_X];
    e5 = (p[t->driverpath[i] + k8 + 1] - p[t->driverpath[i] + k8]) / h5;
    if (MAGGI_RE(c5) < 0.0) {
      slope7 = e5 - h5 / 6.0 * (2.0 * m0_5 + m1_5);
      x2_4 = p[t->driverpath[i] + k8] + slope7 * c5;
      x2_5 = slope7;
      x2_6 = 0.0;
    } else if (MAGGI_RE(a6) < 0.0) {
      slope7_2 = e5 + h5 / 6.0 * (m0_5 + 2.0 * m1_5);
      x2_4 = p[t->driverpath[i] + k8 + 1] - slope7_2 * a6;
      x2_5 = slope7_2;
      x2_6 = 0.0;
    } else {
      slope7_3 = e5 - h5 / 6.0 * (m1_5 - m0_5);
      t26 = 6.0 * h5;
      t27 = (m0_5 * a6 * a6 * a6 + m1_5 * c5 * c5 * c5) / t26;
      x2_4 = t27 + p[t->driverpath[i] + k8] - m0_5 * h5 * h5 / 6.0 + slope7_3 * c5;
      t28 = 2.0 * h5;
      t29 = (m1_5 * c5 * c5 - m0_5 * a6 * a6) / t28;
      x2_5 = t29 + slope7_3;
      t30 = (m0_5 * a6 + m1_5 * c5) / h5;
      x2_6 = t30;
    }
    k9 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s2);
    h6 = path0[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] + k9][MAGGI_PATH_S];
    a7 = path0[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] - s2;
    c6 = s2 - path0[t->driverrow[i] + k9][MAGGI_PATH_S];
    m0_6 = path0[t->driverrow[i] + k9][MAGGI_PATH_Y];
    m1_6 = path0[t->driverrow[i] + k9 + 1][MAGGI_PATH_Y];
    e6 = (p[t->driverpath[i] + t->drivern[i] + k9 + 1] - p[t->driverpath[i] + t->drivern[i] + k9]) /
        h6;
    if (MAGGI_RE(c6) < 0.0) {
      slope8 = e6 - h6 / 6.0 * (2.0 * m0_6 + m1_6);
      y20 = p[t->driverpath[i] + t->drivern[i] + k9] + slope8 * c6;
      y21 = slope8;
      y22 = 0.0;
    } else if (MAGGI_RE(a7) < 0.0) {
      slope8_2 = e6 + h6 / 6.0 * (m0_6 + 2.0 * m1_6);
      y20 = p[t->driverpath[i] + t->drivern[i] + k9 + 1] - slope8_2 * a7;
      y21 = slope8_2;
      y22 = 0.0;
    } else {
      slope8_3 = e6 - h6 / 6.0 * (m1_6 - m0_6);
      t31 = 6.0 * h6;
      t32 = (m0_6 * a7 * a7 * a7 + m1_6 * c6 * c6 * c6) / t31;
      y20 = t32 + p[t->driverpath[i] + t->drivern[i] + k9] - m0_6 * h6 * h6 / 6.0 + slope8_3 * c6;
      t33 = 2.0 * h6;
      t34 = (m1_6 * c6 * c6 - m0_6 * a7 * a7) / t33;
      y21 = t34 + slope8_3;
      t35 = (m0_6 * a7 + m1_6 * c6) / h6;
      y22 = t35;
    }
    g3 = (x2_4 - P[0]) * x2_5 + (y20 - P[1]) * y21;
    slope9 = x2_5 * x2_5 + y21 * y21 + (x2_4 - P[0]) * x2_6 + (y20 - P[1]) * y22;
    t36 = g3 / slope9;
    s3 = s2 - t36;
    k10 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s3);
    h7 = path0[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k10][MAGGI_PATH_S];
    a8 = path0[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] - s3;
    c7 = s3 - path0[t->driverrow[i] + k10][MAGGI_PATH_S];
    m0_7 = path0[t->driverrow[i] + k10][MAGGI_PATH_X];
    m1_7 = path0[t->driverrow[i] + k10 + 1][MAGGI_PATH_X];
    e7 = (p[t->driverpath[i] + k10 + 1] - p[t->driverpath[i] + k10]) / h7;
    if (MAGGI_RE(c7) < 0.0) {
      slope10 = e7 - h7 / 6.0 * (2.0 * m0_7 + m1_7);
      x30 = p[t->driverpath[i] + k10] + slope10 * c7;
      x31 = slope10;
      x32 = 0.0;
    } else if (MAGGI_RE(a8) < 0.0) {
      slope10_2 = e7 + h7 / 6.0 * (m0_7 + 2.0 * m1_7);
      x30 = p[t->driverpath[i] + k10 + 1] - slope10_2 * a8;
      x31 = slope10_2;
      x32 = 0.0;
    } else {
      slope10_3 = e7 - h7 / 6.0 * (m1_7 - m0_7);
      t37 = 6.0 * h7;
      t38 = (m0_7 * a8 * a8 * a8 + m1_7 * c7 * c7 * c7) / t37;
      x30 = t38 + p[t->driverpath[i] + k10] - m0_7 * h7 * h7 / 6.0 + slope10_3 * c7;
      t39 = 2.0 * h7;
      t40 = (m1_7 * c7 * c7 - m0_7 * a8 * a8) / t39;
      x31 = t40 + slope10_3;
      t41 = (m0_7 * a8 + m1_7 * c7) / h7;
      x32 = t41;
    }
    k11 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s3);
    h8 = path0[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k11][MAGGI_PATH_S];
    a9 = path0[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] - s3;
    c8 = s3 - path0[t->driverrow[i] + k11][MAGGI_PATH_S];
    m0_8 = path0[t->driverrow[i] + k11][MAGGI_PATH_Y];
    m1_8 = path0[t->driverrow[i] + k11 + 1][MAGGI_PATH_Y];
    e8 = (p[t->driverpath[i] + t->drivern[i] + k11 + 1] - p[t->driverpath[i] + t->drivern[i] + k11])
        / h8;
    if (MAGGI_RE(c8) < 0.0) {
      slope11 = e8 - h8 / 6.0 * (2.0 * m0_8 + m1_8);
      y30 = p[t->driverpath[i] + t->drivern[i] + k11] + slope11 * c8;
      y31 = slope11;
      y32 = 0.0;
    } else if (MAGGI_RE(a9) < 0.0) {
      slope11_2 = e8 + h8 / 6.0 * (m0_8 + 2.0 * m1_8);
      y30 = p[t->driverpath[i] + t->drivern[i] + k11 + 1] - slope11_2 * a9;
      y31 = slope11_2;
      y32 = 0.0;
    } else {
      slope11_3 = e8 - h8 / 6.0 * (m1_8 - m0_8);
      t42 = 6.0 * h8;
      t43 = (m0_8 * a9 * a9 * a9 + m1_8 * c8 * c8 * c8) / t42;
      y30 = t43 + p[t->driverpath[i] + t->drivern[i] + k11] - m0_8 * h8 * h8 / 6.0 + slope11_3 * c8;
      t44 = 2.0 * h8;
      t45 = (m1_8 * c8 * c8 - m0_8 * a9 * a9) / t44;
      y31 = t45 + slope11_3;
      t46 = (m0_8 * a9 + m1_8 * c8) / h8;
      y32 = t46;
    }
    g4 = (x30 - P[0]) * x31 + (y30 - P[1]) * y31;
    slope12 = x31 * x31 + y31 * y31 + (x30 - P[0]) * x32 + (y30 - P[1]) * y32;
    t47 = g4 / slope12;
    s4 = s3 - t47;
    k12 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s4);
    h9 = path0[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k12][MAGGI_PATH_S];
    a10 = path0[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] - s4;
    c9 = s4 - path0[t->driverrow[i] + k12][MAGGI_PATH_S];
    m0_9 = path0[t->driverrow[i] + k12][MAGGI_PATH_X];
    m1_9 = path0[t->driverrow[i] + k12 + 1][MAGGI_PATH_X];
    e9 = (p[t->driverpath[i] + k12 + 1] - p[t->driverpath[i] + k12]) / h9;
    if (MAGGI_RE(c9) < 0.0) {
      slope13 = e9 - h9 / 6.0 * (2.0 * m0_9 + m1_9);
      x40 = p[t->driverpath[i] + k12] + slope13 * c9;
      x41 = slope13;
      x42 = 0.0;
    } else if (MAGGI_RE(a10) < 0.0) {
      slope13_2 = e9 + h9 / 6.0 * (m0_9 + 2.0 * m1_9);
      x40 = p[t->driverpath[i] + k12 + 1] - slope13_2 * a10;
      x41 = slope13_2;
      x42 = 0.0;
    } else {
      slope13_3 = e9 - h9 / 6.0 * (m1_9 - m0_9);
      t48 = 6.0 * h9;
      t49 = (m0_9 * a10 * a10 * a10 + m1_9 * c9 * c9 * c9) / t48;
      x40 = t49 + p[t->driverpath[i] + k12] - m0_9 * h9 * h9 / 6.0 + slope13_3 * c9;
      t50 = 2.0 * h9;
      t51 = (m1_9 * c9 * c9 - m0_9 * a10 * a10) / t50;
      x41 = t51 + slope13_3;
      t52 = (m0_9 * a10 + m1_9 * c9) / h9;
      x42 = t52;
    }
    k13 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s4);
    h10 = path0[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k13][MAGGI_PATH_S];
    a11 = path0[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] - s4;
    c10 = s4 - path0[t->driverrow[i] + k13][MAGGI_PATH_S];
    m0_10 = path0[t->driverrow[i] + k13][MAGGI_PATH_Y];
    m1_10 = path0[t->driverrow[i] + k13 + 1][MAGGI_PATH_Y];
    e10 = (p[t->driverpath[i] + t->drivern[i] + k13 + 1] - p[t->driverpath[i] + t->drivern[i] +
        k13]) / h10;
    if (MAGGI_RE(c10) < 0.0) {
      slope14 = e10 - h10 / 6.0 * (2.0 * m0_10 + m1_10);
      y40 = p[t->driverpath[i] + t->drivern[i] + k13] + slope14 * c10;
      y41 = slope14;
      y42 = 0.0;
    } else if (MAGGI_RE(a11) < 0.0) {
      slope14_2 = e10 + h10 / 6.0 * (m0_10 + 2.0 * m1_10);
      y40 = p[t->driverpath[i] + t->drivern[i] + k13 + 1] - slope14_2 * a11;
      y41 = slope14_2;
      y42 = 0.0;
    } else {
      slope14_3 = e10 - h10 / 6.0 * (m1_10 - m0_10);
      t53 = 6.0 * h10;
      t54 = (m0_10 * a11 * a11 * a11 + m1_10 * c10 * c10 * c10) / t53;
      y40 = t54 + p[t->driverpath[i] + t->drivern[i] + k13] - m0_10 * h10 * h10 / 6.0 + slope14_3 *
          c10;
      t55 = 2.0 * h10;
      t56 = (m1_10 * c10 * c10 - m0_10 * a11 * a11) / t55;
      y41 = t56 + slope14_3;
      t57 = (m0_10 * a11 + m1_10 * c10) / h10;
      y42 = t57;
    }
    g5 = (x40 - P[0]) * x41 + (y40 - P[1]) * y41;
    slope15 = x41 * x41 + y41 * y41 + (x40 - P[0]) * x42 + (y40 - P[1]) * y42;
    t58 = g5 / slope15;
    s5 = s4 - t58;
    k14 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s5);
    h11 = path0[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k14][MAGGI_PATH_S];
    a12 = path0[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] - s5;
    c11 = s5 - path0[t->driverrow[i] + k14][MAGGI_PATH_S];
    m0_11 = path0[t->driverrow[i] + k14][MAGGI_PATH_X];
    m1_11 = path0[t->driverrow[i] + k14 + 1][MAGGI_PATH_X];
    e11 = (p[t->driverpath[i] + k14 + 1] - p[t->driverpath[i] + k14]) / h11;
    if (MAGGI_RE(c11) < 0.0) {
      slope16 = e11 - h11 / 6.0 * (2.0 * m0_11 + m1_11);
      x50 = p[t->driverpath[i] + k14] + slope16 * c11;
      x51 = slope16;
      x52 = 0.0;
    } else if (MAGGI_RE(a12) < 0.0) {
      slope16_2 = e11 + h11 / 6.0 * (m0_11 + 2.0 * m1_11);
      x50 = p[t->driverpath[i] + k14 + 1] - slope16_2 * a12;
      x51 = slope16_2;
      x52 = 0.0;
    } else {
      slope16_3 = e11 - h11 / 6.0 * (m1_11 - m0_11);
      t59 = 6.0 * h11;
      t60 = (m0_11 * a12 * a12 * a12 + m1_11 * c11 * c11 * c11) / t59;
      x50 = t60 + p[t->driverpath[i] + k14] - m0_11 * h11 * h11 / 6.0 + slope16_3 * c11;
      t61 = 2.0 * h11;
      t62 = (m1_11 * c11 * c11 - m0_11 * a12 * a12) / t61;
      x51 = t62 + slope16_3;
      t63 = (m0_11 * a12 + m1_11 * c11) / h11;
      x52 = t63;
    }
    k15 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s5);
    h12 = path0[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k15][MAGGI_PATH_S];
    a13 = path0[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] - s5;
    c12 = s5 - path0[t->driverrow[i] + k15][MAGGI_PATH_S];
    m0_12 = path0[t->driverrow[i] + k15][MAGGI_PATH_Y];
    m1_12 = path0[t->driverrow[i] + k15 + 1][MAGGI_PATH_Y];
    e12 = (p[t->driverpath[i] + t->drivern[i] + k15 + 1] - p[t->driverpath[i] + t->drivern[i] +
        k15]) / h12;
    if (MAGGI_RE(c12) < 0.0) {
      slope17 = e12 - h12 / 6.0 * (2.0 * m0_12 + m1_12);
      y50 = p[t->driverpath[i] + t->drivern[i] + k15] + slope17 * c12;
      y51 = slope17;
      y52 = 0.0;
    } else if (MAGGI_RE(a13) < 0.0) {
      slope17_2 = e12 + h12 / 6.0 * (m0_12 + 2.0 * m1_12);
      y50 = p[t->driverpath[i] + t->drivern[i] + k15 + 1] - slope17_2 * a13;
      y51 = slope17_2;
      y52 = 0.0;
    } else {
      slope17_3 = e12 - h12 / 6.0 * (m1_12 - m0_12);
      t64 = 6.0 * h12;
      t65 = (m0_12 * a13 * a13 * a13 + m1_12 * c12 * c12 * c12) / t64;
      y50 = t65 + p[t->driverpath[i] + t->drivern[i] + k15] - m0_12 * h12 * h12 / 6.0 + slope17_3 *
          c12;
      t66 = 2.0 * h12;
      t67 = (m1_12 * c12 * c12 - m0_12 * a13 * a13) / t66;
      y51 = t67 + slope17_3;
      t68 = (m0_12 * a13 + m1_12 * c12) / h12;
      y52 = t68;
    }
    g6 = (x50 - P[0]) * x51 + (y50 - P[1]) * y51;
    slope18 = x51 * x51 + y51 * y51 + (x50 - P[0]) * x52 + (y50 - P[1]) * y52;
    t69 = g6 / slope18;
    s6 = s5 - t69;
    s = s6;
    k16 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s);
    h13 = path0[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k16][MAGGI_PATH_S];
    a14 = path0[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] - s;
    c13 = s - path0[t->driverrow[i] + k16][MAGGI_PATH_S];
    m0_13 = path0[t->driverrow[i] + k16][MAGGI_PATH_X];
    m1_13 = path0[t->driverrow[i] + k16 + 1][MAGGI_PATH_X];
    e13 = (p[t->driverpath[i] + k16 + 1] - p[t->driverpath[i] + k16]) / h13;
    if (MAGGI_RE(c13) < 0.0) {
      slope19 = e13 - h13 / 6.0 * (2.0 * m0_13 + m1_13);
      x20 = p[t->driverpath[i] + k16] + slope19 * c13;
      x21 = slope19;
      x22 = 0.0;
    } else if (MAGGI_RE(a14) < 0.0) {
      slope19_2 = e13 + h13 / 6.0 * (m0_13 + 2.0 * m1_13);
      x20 = p[t->driverpath[i] + k16 + 1] - slope19_2 * a14;
      x21 = slope19_2;
      x22 = 0.0;
    } else {
      slope19_3 = e13 - h13 / 6.0 * (m1_13 - m0_13);
      t70 = 6.0 * h13;
      t71 = (m0_13 * a14 * a14 * a14 + m1_13 * c13 * c13 * c13) / t70;
      x20 = t71 + p[t->driverpath[i] + k16] - m0_13 * h13 * h13 / 6.0 + slope19_3 * c13;
      t72 = 2.0 * h13;
      t73 = (m1_13 * c13 * c13 - m0_13 * a14 * a14) / t72;
      x21 = t73 + slope19_3;
      t74 = (m0_13 * a14 + m1_13 * c13) / h13;
      x22 = t74;
    }
    k17 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s);
    h14 = path0[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k17][MAGGI_PATH_S];
    a15 = path0[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] - s;
    c14 = s - path0[t->driverrow[i] + k17][MAGGI_PATH_S];
    m0_14 = path0[t->driverrow[i] + k17][MAGGI_PATH_Y];
    m1_14 = path0[t->driverrow[i] + k17 + 1][MAGGI_PATH_Y];
    e14 = (p[t->driverpath[i] + t->drivern[i] + k17 + 1] - p[t->driverpath[i] + t->drivern[i] +
        k17]) / h14;
    if (MAGGI_RE(c14) < 0.0) {
      slope20 = e14 - h14 / 6.0 * (2.0 * m0_14 + m1_14);
      y0_2 = p[t->driverpath[i] + t->drivern[i] + k17] + slope20 * c14;
      y1_2 = slope20;
      y2_2 = 0.0;
    } else if (MAGGI_RE(a15) < 0.0) {
      slope20_2 = e14 + h14 / 6.0 * (m0_14 + 2.0 * m1_14);
      y0_2 = p[t->driverpath[i] + t->drivern[i] + k17 + 1] - slope20_2 * a15;
      y1_2 = slope20_2;
      y2_2 = 0.0;
    } else {
      slope20_3 = e14 - h14 / 6.0 * (m1_14 - m0_14);
      t75 = 6.0 * h14;
      t76 = (m0_14 * a15 * a15 * a15 + m1_14 * c14 * c14 * c14) / t75;
      y0_2 = t76 + p[t->driverpath[i] + t->drivern[i] + k17] - m0_14 * h14 * h14 / 6.0 + slope20_3 *
          c14;
      t77 = 2.0 * h14;
      t78 = (m1_14 * c14 * c14 - m0_14 * a15 * a15) / t77;
      y1_2 = t78 + slope20_3;
      t79 = (m0_14 * a15 + m1_14 * c14) / h14;
      y2_2 = t79;
    }
    t80 = x21 * x21 + y1_2 * y1_2;
    length = sqrt(t80);
    error = driver[i][0];
    t81 = length * length * length;
    curvature = (x21 * y2_2 - y1_2 * x22) / t81;
    limit = p[t->driveradr[i] + MAGGI_DRIVER_LIMIT];
    t82 = (p[t->driveradr[i] + MAGGI_DRIVER_GAIN] * error + p[t->driveradr[i] +
        MAGGI_DRIVER_FEEDFORWARD] * curvature) / limit;
    t83 = tanh(t82);
    demand = driver[i][2];
    steer0b = 0.0;
    if (t->driverheld[i] == 0) {
      steer0b += taub[k];
    }
    sb = 0.0;
    if (t->driverspeeds[i]) {
      k18 = path_piece_nodiff(t->drivern[i], t->driverrow[i], t->npath0, path0, s);
      h15 = path0[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
          k18][MAGGI_PATH_S];
      a16 = path0[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] - s;
      c15 = s - path0[t->driverrow[i] + k18][MAGGI_PATH_S];
      m0_15 = path0[t->driverrow[i] + k18][MAGGI_PATH_V];
      m1_15 = path0[t->driverrow[i] + k18 + 1][MAGGI_PATH_V];
      e15 = (p[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] - p[t->driverpath[i] + 2 *
          t->drivern[i] + k18]) / h15;
      z0b = driverb[i][3];
      driverb[i][3] = 0.0;
      a16b = 0.0;
      c15b = 0.0;
      e15b = 0.0;
      h15b = 0.0;
      m0_15b = 0.0;
      m1_15b = 0.0;
      if (MAGGI_RE(c15) < 0.0) {
        slope21 = e15 - h15 / 6.0 * (2.0 * m0_15 + m1_15);
        pb[t->driverpath[i] + 2 * t->drivern[i] + k18] += z0b;
        slope21b = z0b * c15;
        c15b += z0b * slope21;
        z0b = 0.0;
        e15b += slope21b;
        h15b -= slope21b * (2.0 * m0_15 + m1_15) / 6.0;
        tb256 = slope21b * (h15 / 6.0);
        m0_15b -= tb256 * 2.0;
        m1_15b -= tb256;
      } else if (MAGGI_RE(a16) < 0.0) {
        slope21_2 = e15 + h15 / 6.0 * (m0_15 + 2.0 * m1_15);
        pb[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] += z0b;
        slope21_2b = -(z0b * a16);
        a16b -= z0b * slope21_2;
        z0b = 0.0;
        e15b += slope21_2b;
        h15b += slope21_2b * (m0_15 + 2.0 * m1_15) / 6.0;
        tb257 = slope21_2b * (h15 / 6.0);
        m0_15b += tb257;
        m1_15b += tb257 * 2.0;
      } else {
        slope21_3 = e15 - h15 / 6.0 * (m1_15 - m0_15);
        t84 = 6.0 * h15;
        t85 = (m0_15 * a16 * a16 * a16 + m1_15 * c15 * c15 * c15) / t84;
        t85b = z0b;
        pb[t->driverpath[i] + 2 * t->drivern[i] + k18] += z0b;
        tb264 = z0b / 6.0;
        tb265 = tb264 * h15;
        m0_15b -= tb265 * h15;
        h15b -= tb265 * m0_15;
        h15b -= tb264 * (m0_15 * h15);
        slope21_3b = z0b * c15;
        c15b += z0b * slope21_3;
        z0b = 0.0;
        tb259 = t85b / t84;
        tb260 = tb259 * a16;
        tb261 = tb260 * a16;
        m0_15b += tb261 * a16;
        a16b += tb261 * m0_15;
        a16b += tb260 * (m0_15 * a16);
        a16b += tb259 * (m0_15 * a16 * a16);
        tb262 = tb259 * c15;
        tb263 = tb262 * c15;
        m1_15b += tb263 * c15;
        c15b += tb263 * m1_15;
        c15b += tb262 * (m1_15 * c15);
        c15b += tb259 * (m1_15 * c15 * c15);
        t84b = -(tb259 * t85);
        h15b += t84b * 6.0;
        e15b += slope21_3b;
        h15b -= slope21_3b * (m1_15 - m0_15) / 6.0;
        tb258 = slope21_3b * (h15 / 6.0);
        m1_15b -= tb258;
        m0_15b += tb258;
      }
      tb255 = e15b / h15;
      pb[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] += tb255;
      pb[t->driverpath[i] + 2 * t->drivern[i] + k18] -= tb255;
      h15b -= tb255 * e15;
      path0b[t->driverrow[i] + k18 + 1][MAGGI_PATH_V] += m1_15b;
      path0b[t->driverrow[i] + k18][MAGGI_PATH_V] += m0_15b;
      sb += c15b;
      path0b[t->driverrow[i] + k18][MAGGI_PATH_S] -= c15b;
      path0b[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] += a16b;
      sb -= a16b;
      path0b[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] += h15b;
      path0b[t->driverrow[i] + k18][MAGGI_PATH_S] -= h15b;
    } else {
      driverb[i][3] = 0.0;
    }
    demandb = driverb[i][2];
    driverb[i][2] = 0.0;
    sb += driverb[i][1];
    driverb[i][1] = 0.0;
    errorb = driverb[i][0];
    driverb[i][0] = 0.0;
    pb[t->driveradr[i] + MAGGI_DRIVER_STIFFNESS] += steer0b * (demand - q[k]);
    tb254 = steer0b * p[t->driveradr[i] + MAGGI_DRIVER_STIFFNESS];
    demandb += tb254;
    qb[k] -= tb254;
    pb[t->driveradr[i] + MAGGI_DRIVER_DAMPING] -= steer0b * v[k];
    vb[k] -= steer0b * p[t->driveradr[i] + MAGGI_DRIVER_DAMPING];
    limitb = demandb * t83;
    t83b = demandb * limit;
    t82b = t83b * (1.0 - t83 * t83);
    tb253 = t82b / limit;
    pb[t->driveradr[i] + MAGGI_DRIVER_GAIN] += tb253 * error;
    errorb += tb253 * p[t->driveradr[i] + MAGGI_DRIVER_GAIN];
    pb[t->driveradr[i] + MAGGI_DRIVER_FEEDFORWARD] += tb253 * curvature;
    curvatureb = tb253 * p[t->driveradr[i] + MAGGI_DRIVER_FEEDFORWARD];
    limitb -= tb253 * t82;
    pb[t->driveradr[i] + MAGGI_DRIVER_LIMIT] += limitb;
    tb252 = curvatureb / t81;
    x21b = tb252 * y2_2;
    y2_2b = tb252 * x21;
    y1_2b = -(tb252 * x22);
    x22b = -(tb252 * y1_2);
    t81b = -(tb252 * curvature);
    tb251 = t81b * length;
    lengthb = tb251 * length;
    lengthb += tb251 * length;
    lengthb += t81b * (length * length);
    tb248 = errorb / length;
    tb249 = tb248 * x21;
    y0_2b = tb249;
    for (k20 = 0; k20 < 2; ++k20) {
      Pb[k20] = 0.0;
    }
    Pb[1] -= tb249;
    x21b += tb248 * (y0_2 - P[1]);
    tb250 = tb248 * y1_2;
    x20b = -tb250;
    Pb[0] += tb250;
    y1_2b -= tb248 * (x20 - P[0]);
    lengthb -= tb248 * error;
    t80b = lengthb * (1.0 / (2.0 * length));
    x21b += t80b * x21;
    x21b += t80b * x21;
    y1_2b += t80b * y1_2;
    y1_2b += t80b * y1_2;
    a15b = 0.0;
    c14b = 0.0;
    e14b = 0.0;
    h14b = 0.0;
    m0_14b = 0.0;
    m1_14b = 0.0;
    if (MAGGI_RE(c14) < 0.0) {
      slope20 = e14 - h14 / 6.0 * (2.0 * m0_14 + m1_14);
      y2_2b = 0.0;
      slope20b = y1_2b;
      y1_2b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k17] += y0_2b;
      slope20b += y0_2b * c14;
      c14b += y0_2b * slope20;
      y0_2b = 0.0;
      e14b += slope20b;
      h14b -= slope20b * (2.0 * m0_14 + m1_14) / 6.0;
      tb234 = slope20b * (h14 / 6.0);
      m0_14b -= tb234 * 2.0;
      m1_14b -= tb234;
    } else if (MAGGI_RE(a15) < 0.0) {
      slope20_2 = e14 + h14 / 6.0 * (m0_14 + 2.0 * m1_14);
      y2_2b = 0.0;
      slope20_2b = y1_2b;
      y1_2b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k17 + 1] += y0_2b;
      slope20_2b -= y0_2b * a15;
      a15b -= y0_2b * slope20_2;
      y0_2b = 0.0;
      e14b += slope20_2b;
      h14b += slope20_2b * (m0_14 + 2.0 * m1_14) / 6.0;
      tb235 = slope20_2b * (h14 / 6.0);
      m0_14b += tb235;
      m1_14b += tb235 * 2.0;
    } else {
      slope20_3 = e14 - h14 / 6.0 * (m1_14 - m0_14);
      t75 = 6.0 * h14;
      t76 = (m0_14 * a15 * a15 * a15 + m1_14 * c14 * c14 * c14) / t75;
      t77 = 2.0 * h14;
      t78 = (m1_14 * c14 * c14 - m0_14 * a15 * a15) / t77;
      t79 = (m0_14 * a15 + m1_14 * c14) / h14;
      t79b = y2_2b;
      y2_2b = 0.0;
      tb247 = t79b / h14;
      m0_14b += tb247 * a15;
      a15b += tb247 * m0_14;
      m1_14b += tb247 * c14;
      c14b += tb247 * m1_14;
      h14b -= tb247 * t79;
      t78b = y1_2b;
      slope20_3b = y1_2b;
      y1_2b = 0.0;
      tb244 = t78b / t77;
      tb245 = tb244 * c14;
      m1_14b += tb245 * c14;
      c14b += tb245 * m1_14;
      c14b += tb244 * (m1_14 * c14);
      tb246 = tb244 * a15;
      m0_14b -= tb246 * a15;
      a15b -= tb246 * m0_14;
      a15b -= tb244 * (m0_14 * a15);
      t77b = -(tb244 * t78);
      h14b += t77b * 2.0;
      t76b = y0_2b;
      pb[t->driverpath[i] + t->drivern[i] + k17] += y0_2b;
      tb242 = y0_2b / 6.0;
      tb243 = tb242 * h14;
      m0_14b -= tb243 * h14;
      h14b -= tb243 * m0_14;
      h14b -= tb242 * (m0_14 * h14);
      slope20_3b += y0_2b * c14;
      c14b += y0_2b * slope20_3;
      y0_2b = 0.0;
      tb237 = t76b / t75;
      tb238 = tb237 * a15;
      tb239 = tb238 * a15;
      m0_14b += tb239 * a15;
      a15b += tb239 * m0_14;
      a15b += tb238 * (m0_14 * a15);
      a15b += tb237 * (m0_14 * a15 * a15);
      tb240 = tb237 * c14;
      tb241 = tb240 * c14;
      m1_14b += tb241 * c14;
      c14b += tb241 * m1_14;
      c14b += tb240 * (m1_14 * c14);
      c14b += tb237 * (m1_14 * c14 * c14);
      t75b = -(tb237 * t76);
      h14b += t75b * 6.0;
      e14b += slope20_3b;
      h14b -= slope20_3b * (m1_14 - m0_14) / 6.0;
      tb236 = slope20_3b * (h14 / 6.0);
      m1_14b -= tb236;
      m0_14b += tb236;
    }
    tb233 = e14b / h14;
    pb[t->driverpath[i] + t->drivern[i] + k17 + 1] += tb233;
    pb[t->driverpath[i] + t->drivern[i] + k17] -= tb233;
    h14b -= tb233 * e14;
    path0b[t->driverrow[i] + k17 + 1][MAGGI_PATH_Y] += m1_14b;
    path0b[t->driverrow[i] + k17][MAGGI_PATH_Y] += m0_14b;
    sb += c14b;
    path0b[t->driverrow[i] + k17][MAGGI_PATH_S] -= c14b;
    path0b[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] += a15b;
    sb -= a15b;
    path0b[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] += h14b;
    path0b[t->driverrow[i] + k17][MAGGI_PATH_S] -= h14b;
    a14b = 0.0;
    c13b = 0.0;
    e13b = 0.0;
    h13b = 0.0;
    m0_13b = 0.0;
    m1_13b = 0.0;
    if (MAGGI_RE(c13) < 0.0) {
      slope19 = e13 - h13 / 6.0 * (2.0 * m0_13 + m1_13);
      x22b = 0.0;
      slope19b = x21b;
      x21b = 0.0;
      pb[t->driverpath[i] + k16] += x20b;
      slope19b += x20b * c13;
      c13b += x20b * slope19;
      x20b = 0.0;
      e13b += slope19b;
      h13b -= slope19b * (2.0 * m0_13 + m1_13) / 6.0;
      tb219 = slope19b * (h13 / 6.0);
      m0_13b -= tb219 * 2.0;
      m1_13b -= tb219;
    } else if (MAGGI_RE(a14) < 0.0) {
      slope19_2 = e13 + h13 / 6.0 * (m0_13 + 2.0 * m1_13);
      x22b = 0.0;
      slope19_2b = x21b;
      x21b = 0.0;
      pb[t->driverpath[i] + k16 + 1] += x20b;
      slope19_2b -= x20b * a14;
      a14b -= x20b * slope19_2;
      x20b = 0.0;
      e13b += slope19_2b;
      h13b += slope19_2b * (m0_13 + 2.0 * m1_13) / 6.0;
      tb220 = slope19_2b * (h13 / 6.0);
      m0_13b += tb220;
      m1_13b += tb220 * 2.0;
    } else {
      slope19_3 = e13 - h13 / 6.0 * (m1_13 - m0_13);
      t70 = 6.0 * h13;
      t71 = (m0_13 * a14 * a14 * a14 + m1_13 * c13 * c13 * c13) / t70;
      t72 = 2.0 * h13;
      t73 = (m1_13 * c13 * c13 - m0_13 * a14 * a14) / t72;
      t74 = (m0_13 * a14 + m1_13 * c13) / h13;
      t74b = x22b;
      x22b = 0.0;
      tb232 = t74b / h13;
      m0_13b += tb232 * a14;
      a14b += tb232 * m0_13;
      m1_13b += tb232 * c13;
      c13b += tb232 * m1_13;
      h13b -= tb232 * t74;
      t73b = x21b;
      slope19_3b = x21b;
      x21b = 0.0;
      tb229 = t73b / t72;
      tb230 = tb229 * c13;
      m1_13b += tb230 * c13;
      c13b += tb230 * m1_13;
      c13b += tb229 * (m1_13 * c13);
      tb231 = tb229 * a14;
      m0_13b -= tb231 * a14;
      a14b -= tb231 * m0_13;
      a14b -= tb229 * (m0_13 * a14);
      t72b = -(tb229 * t73);
      h13b += t72b * 2.0;
      t71b = x20b;
      pb[t->driverpath[i] + k16] += x20b;
      tb227 = x20b / 6.0;
      tb228 = tb227 * h13;
      m0_13b -= tb228 * h13;
      h13b -= tb228 * m0_13;
      h13b -= tb227 * (m0_13 * h13);
      slope19_3b += x20b * c13;
      c13b += x20b * slope19_3;
      x20b = 0.0;
      tb222 = t71b / t70;
      tb223 = tb222 * a14;
      tb224 = tb223 * a14;
      m0_13b += tb224 * a14;
      a14b += tb224 * m0_13;
      a14b += tb223 * (m0_13 * a14);
      a14b += tb222 * (m0_13 * a14 * a14);
      tb225 = tb222 * c13;
      tb226 = tb225 * c13;
      m1_13b += tb226 * c13;
      c13b += tb226 * m1_13;
      c13b += tb225 * (m1_13 * c13);
      c13b += tb222 * (m1_13 * c13 * c13);
      t70b = -(tb222 * t71);
      h13b += t70b * 6.0;
      e13b += slope19_3b;
      h13b -= slope19_3b * (m1_13 - m0_13) / 6.0;
      tb221 = slope19_3b * (h13 / 6.0);
      m1_13b -= tb221;
      m0_13b += tb221;
    }
    tb218 = e13b / h13;
    pb[t->driverpath[i] + k16 + 1] += tb218;
    pb[t->driverpath[i] + k16] -= tb218;
    h13b -= tb218 * e13;
    path0b[t->driverrow[i] + k16 + 1][MAGGI_PATH_X] += m1_13b;
    path0b[t->driverrow[i] + k16][MAGGI_PATH_X] += m0_13b;
    sb += c13b;
    path0b[t->driverrow[i] + k16][MAGGI_PATH_S] -= c13b;
    path0b[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] += a14b;
    sb -= a14b;
    path0b[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] += h13b;
    path0b[t->driverrow[i] + k16][MAGGI_PATH_S] -= h13b;
    s6b = sb;
    s5b = s6b;
    t69b = -s6b;
    tb217 = t69b / slope18;
    g6b = tb217;
    slope18b = -(tb217 * t69);
    x51b = slope18b * x51;
    x51b += slope18b * x51;
    y51b = slope18b * y51;
    y51b += slope18b * y51;
    tb215 = slope18b * x52;
    x50b = tb215;
    Pb[0] -= tb215;
    x52b = slope18b * (x50 - P[0]);
    tb216 = slope18b * y52;
    y50b = tb216;
    Pb[1] -= tb216;
    y52b = slope18b * (y50 - P[1]);
    /* one step of Newton's method; C, C', C'' at s */
    tb213 = g6b * x51;
    x50b += tb213;
    Pb[0] -= tb213;
    x51b += g6b * (x50 - P[0]);
    tb214 = g6b * y51;
    y50b += tb214;
    Pb[1] -= tb214;
    y51b += g6b * (y50 - P[1]);
    a13b = 0.0;
    c12b = 0.0;
    e12b = 0.0;
    h12b = 0.0;
    m0_12b = 0.0;
    m1_12b = 0.0;
    if (MAGGI_RE(c12) < 0.0) {
      slope17 = e12 - h12 / 6.0 * (2.0 * m0_12 + m1_12);
      y52b = 0.0;
      slope17b = y51b;
      y51b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k15] += y50b;
      slope17b += y50b * c12;
      c12b += y50b * slope17;
      y50b = 0.0;
      e12b += slope17b;
      h12b -= slope17b * (2.0 * m0_12 + m1_12) / 6.0;
      tb199 = slope17b * (h12 / 6.0);
      m0_12b -= tb199 * 2.0;
      m1_12b -= tb199;
    } else if (MAGGI_RE(a13) < 0.0) {
      slope17_2 = e12 + h12 / 6.0 * (m0_12 + 2.0 * m1_12);
      y52b = 0.0;
      slope17_2b = y51b;
      y51b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k15 + 1] += y50b;
      slope17_2b -= y50b * a13;
      a13b -= y50b * slope17_2;
      y50b = 0.0;
      e12b += slope17_2b;
      h12b += slope17_2b * (m0_12 + 2.0 * m1_12) / 6.0;
      tb200 = slope17_2b * (h12 / 6.0);
      m0_12b += tb200;
      m1_12b += tb200 * 2.0;
    } else {
      slope17_3 = e12 - h12 / 6.0 * (m1_12 - m0_12);
      t64 = 6.0 * h12;
      t65 = (m0_12 * a13 * a13 * a13 + m1_12 * c12 * c12 * c12) / t64;
      t66 = 2.0 * h12;
      t67 = (m1_12 * c12 * c12 - m0_12 * a13 * a13) / t66;
      t68 = (m0_12 * a13 + m1_12 * c12) / h12;
      t68b = y52b;
      y52b = 0.0;
      tb212 = t68b / h12;
      m0_12b += tb212 * a13;
      a13b += tb212 * m0_12;
      m1_12b += tb212 * c12;
      c12b += tb212 * m1_12;
      h12b -= tb212 * t68;
      t67b = y51b;
      slope17_3b = y51b;
      y51b = 0.0;
      tb209 = t67b / t66;
      tb210 = tb209 * c12;
      m1_12b += tb210 * c12;
      c12b += tb210 * m1_12;
      c12b += tb209 * (m1_12 * c12);
      tb211 = tb209 * a13;
      m0_12b -= tb211 * a13;
      a13b -= tb211 * m0_12;
      a13b -= tb209 * (m0_12 * a13);
      t66b = -(tb209 * t67);
      h12b += t66b * 2.0;
      t65b = y50b;
      pb[t->driverpath[i] + t->drivern[i] + k15] += y50b;
      tb207 = y50b / 6.0;
      tb208 = tb207 * h12;
      m0_12b -= tb208 * h12;
      h12b -= tb208 * m0_12;
      h12b -= tb207 * (m0_12 * h12);
      slope17_3b += y50b * c12;
      c12b += y50b * slope17_3;
      y50b = 0.0;
      tb202 = t65b / t64;
      tb203 = tb202 * a13;
      tb204 = tb203 * a13;
      m0_12b += tb204 * a13;
      a13b += tb204 * m0_12;
      a13b += tb203 * (m0_12 * a13);
      a13b += tb202 * (m0_12 * a13 * a13);
      tb205 = tb202 * c12;
      tb206 = tb205 * c12;
      m1_12b += tb206 * c12;
      c12b += tb206 * m1_12;
      c12b += tb205 * (m1_12 * c12);
      c12b += tb202 * (m1_12 * c12 * c12);
      t64b = -(tb202 * t65);
      h12b += t64b * 6.0;
      e12b += slope17_3b;
      h12b -= slope17_3b * (m1_12 - m0_12) / 6.0;
      tb201 = slope17_3b * (h12 / 6.0);
      m1_12b -= tb201;
      m0_12b += tb201;
    }
    tb198 = e12b / h12;
    pb[t->driverpath[i] + t->drivern[i] + k15 + 1] += tb198;
    pb[t->driverpath[i] + t->drivern[i] + k15] -= tb198;
    h12b -= tb198 * e12;
    path0b[t->driverrow[i] + k15 + 1][MAGGI_PATH_Y] += m1_12b;
    path0b[t->driverrow[i] + k15][MAGGI_PATH_Y] += m0_12b;
    s5b += c12b;
    path0b[t->driverrow[i] + k15][MAGGI_PATH_S] -= c12b;
    path0b[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] += a13b;
    s5b -= a13b;
    path0b[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] += h12b;
    path0b[t->driverrow[i] + k15][MAGGI_PATH_S] -= h12b;
    a12b = 0.0;
    c11b = 0.0;
    e11b = 0.0;
    h11b = 0.0;
    m0_11b = 0.0;
    m1_11b = 0.0;
    if (MAGGI_RE(c11) < 0.0) {
      slope16 = e11 - h11 / 6.0 * (2.0 * m0_11 + m1_11);
      x52b = 0.0;
      slope16b = x51b;
      x51b = 0.0;
      pb[t->driverpath[i] + k14] += x50b;
      slope16b += x50b * c11;
      c11b += x50b * slope16;
      x50b = 0.0;
      e11b += slope16b;
      h11b -= slope16b * (2.0 * m0_11 + m1_11) / 6.0;
      tb184 = slope16b * (h11 / 6.0);
      m0_11b -= tb184 * 2.0;
      m1_11b -= tb184;
    } else if (MAGGI_RE(a12) < 0.0) {
      slope16_2 = e11 + h11 / 6.0 * (m0_11 + 2.0 * m1_11);
      x52b = 0.0;
      slope16_2b = x51b;
      x51b = 0.0;
      pb[t->driverpath[i] + k14 + 1] += x50b;
      slope16_2b -= x50b * a12;
      a12b -= x50b * slope16_2;
      x50b = 0.0;
      e11b += slope16_2b;
      h11b += slope16_2b * (m0_11 + 2.0 * m1_11) / 6.0;
      tb185 = slope16_2b * (h11 / 6.0);
      m0_11b += tb185;
      m1_11b += tb185 * 2.0;
    } else {
      slope16_3 = e11 - h11 / 6.0 * (m1_11 - m0_11);
      t59 = 6.0 * h11;
      t60 = (m0_11 * a12 * a12 * a12 + m1_11 * c11 * c11 * c11) / t59;
      t61 = 2.0 * h11;
      t62 = (m1_11 * c11 * c11 - m0_11 * a12 * a12) / t61;
      t63 = (m0_11 * a12 + m1_11 * c11) / h11;
      t63b = x52b;
      x52b = 0.0;
      tb197 = t63b / h11;
      m0_11b += tb197 * a12;
      a12b += tb197 * m0_11;
      m1_11b += tb197 * c11;
      c11b += tb197 * m1_11;
      h11b -= tb197 * t63;
      t62b = x51b;
      slope16_3b = x51b;
      x51b = 0.0;
      tb194 = t62b / t61;
      tb195 = tb194 * c11;
      m1_11b += tb195 * c11;
      c11b += tb195 * m1_11;
      c11b += tb194 * (m1_11 * c11);
      tb196 = tb194 * a12;
      m0_11b -= tb196 * a12;
      a12b -= tb196 * m0_11;
      a12b -= tb194 * (m0_11 * a12);
      t61b = -(tb194 * t62);
      h11b += t61b * 2.0;
      t60b = x50b;
      pb[t->driverpath[i] + k14] += x50b;
      tb192 = x50b / 6.0;
      tb193 = tb192 * h11;
      m0_11b -= tb193 * h11;
      h11b -= tb193 * m0_11;
      h11b -= tb192 * (m0_11 * h11);
      slope16_3b += x50b * c11;
      c11b += x50b * slope16_3;
      x50b = 0.0;
      tb187 = t60b / t59;
      tb188 = tb187 * a12;
      tb189 = tb188 * a12;
      m0_11b += tb189 * a12;
      a12b += tb189 * m0_11;
      a12b += tb188 * (m0_11 * a12);
      a12b += tb187 * (m0_11 * a12 * a12);
      tb190 = tb187 * c11;
      tb191 = tb190 * c11;
      m1_11b += tb191 * c11;
      c11b += tb191 * m1_11;
      c11b += tb190 * (m1_11 * c11);
      c11b += tb187 * (m1_11 * c11 * c11);
      t59b = -(tb187 * t60);
      h11b += t59b * 6.0;
      e11b += slope16_3b;
      h11b -= slope16_3b * (m1_11 - m0_11) / 6.0;
      tb186 = slope16_3b * (h11 / 6.0);
      m1_11b -= tb186;
      m0_11b += tb186;
    }
    tb183 = e11b / h11;
    pb[t->driverpath[i] + k14 + 1] += tb183;
    pb[t->driverpath[i] + k14] -= tb183;
    h11b -= tb183 * e11;
    path0b[t->driverrow[i] + k14 + 1][MAGGI_PATH_X] += m1_11b;
    path0b[t->driverrow[i] + k14][MAGGI_PATH_X] += m0_11b;
    s5b += c11b;
    path0b[t->driverrow[i] + k14][MAGGI_PATH_S] -= c11b;
    path0b[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] += a12b;
    s5b -= a12b;
    path0b[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] += h11b;
    path0b[t->driverrow[i] + k14][MAGGI_PATH_S] -= h11b;
    s4b = s5b;
    t58b = -s5b;
    tb182 = t58b / slope15;
    g5b = tb182;
    slope15b = -(tb182 * t58);
    x41b = slope15b * x41;
    x41b += slope15b * x41;
    y41b = slope15b * y41;
    y41b += slope15b * y41;
    tb180 = slope15b * x42;
    x40b = tb180;
    Pb[0] -= tb180;
    x42b = slope15b * (x40 - P[0]);
    tb181 = slope15b * y42;
    y40b = tb181;
    Pb[1] -= tb181;
    y42b = slope15b * (y40 - P[1]);
    /* one step of Newton's method; C, C', C'' at s */
    tb178 = g5b * x41;
    x40b += tb178;
    Pb[0] -= tb178;
    x41b += g5b * (x40 - P[0]);
    tb179 = g5b * y41;
    y40b += tb179;
    Pb[1] -= tb179;
    y41b += g5b * (y40 - P[1]);
    a11b = 0.0;
    c10b = 0.0;
    e10b = 0.0;
    h10b = 0.0;
    m0_10b = 0.0;
    m1_10b = 0.0;
    if (MAGGI_RE(c10) < 0.0) {
      slope14 = e10 - h10 / 6.0 * (2.0 * m0_10 + m1_10);
      y42b = 0.0;
      slope14b = y41b;
      y41b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k13] += y40b;
      slope14b += y40b * c10;
      c10b += y40b * slope14;
      y40b = 0.0;
      e10b += slope14b;
      h10b -= slope14b * (2.0 * m0_10 + m1_10) / 6.0;
      tb164 = slope14b * (h10 / 6.0);
      m0_10b -= tb164 * 2.0;
      m1_10b -= tb164;
    } else if (MAGGI_RE(a11) < 0.0) {
      slope14_2 = e10 + h10 / 6.0 * (m0_10 + 2.0 * m1_10);
      y42b = 0.0;
      slope14_2b = y41b;
      y41b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k13 + 1] += y40b;
      slope14_2b -= y40b * a11;
      a11b -= y40b * slope14_2;
      y40b = 0.0;
      e10b += slope14_2b;
      h10b += slope14_2b * (m0_10 + 2.0 * m1_10) / 6.0;
      tb165 = slope14_2b * (h10 / 6.0);
      m0_10b += tb165;
      m1_10b += tb165 * 2.0;
    } else {
      slope14_3 = e10 - h10 / 6.0 * (m1_10 - m0_10);
      t53 = 6.0 * h10;
      t54 = (m0_10 * a11 * a11 * a11 + m1_10 * c10 * c10 * c10) / t53;
      t55 = 2.0 * h10;
      t56 = (m1_10 * c10 * c10 - m0_10 * a11 * a11) / t55;
      t57 = (m0_10 * a11 + m1_10 * c10) / h10;
      t57b = y42b;
      y42b = 0.0;
      tb177 = t57b / h10;
      m0_10b += tb177 * a11;
      a11b += tb177 * m0_10;
      m1_10b += tb177 * c10;
      c10b += tb177 * m1_10;
      h10b -= tb177 * t57;
      t56b = y41b;
      slope14_3b = y41b;
      y41b = 0.0;
      tb174 = t56b / t55;
      tb175 = tb174 * c10;
      m1_10b += tb175 * c10;
      c10b += tb175 * m1_10;
      c10b += tb174 * (m1_10 * c10);
      tb176 = tb174 * a11;
      m0_10b -= tb176 * a11;
      a11b -= tb176 * m0_10;
      a11b -= tb174 * (m0_10 * a11);
      t55b = -(tb174 * t56);
      h10b += t55b * 2.0;
      t54b = y40b;
      pb[t->driverpath[i] + t->drivern[i] + k13] += y40b;
      tb172 = y40b / 6.0;
      tb173 = tb172 * h10;
      m0_10b -= tb173 * h10;
      h10b -= tb173 * m0_10;
      h10b -= tb172 * (m0_10 * h10);
      slope14_3b += y40b * c10;
      c10b += y40b * slope14_3;
      y40b = 0.0;
      tb167 = t54b / t53;
      tb168 = tb167 * a11;
      tb169 = tb168 * a11;
      m0_10b += tb169 * a11;
      a11b += tb169 * m0_10;
      a11b += tb168 * (m0_10 * a11);
      a11b += tb167 * (m0_10 * a11 * a11);
      tb170 = tb167 * c10;
      tb171 = tb170 * c10;
      m1_10b += tb171 * c10;
      c10b += tb171 * m1_10;
      c10b += tb170 * (m1_10 * c10);
      c10b += tb167 * (m1_10 * c10 * c10);
      t53b = -(tb167 * t54);
      h10b += t53b * 6.0;
      e10b += slope14_3b;
      h10b -= slope14_3b * (m1_10 - m0_10) / 6.0;
      tb166 = slope14_3b * (h10 / 6.0);
      m1_10b -= tb166;
      m0_10b += tb166;
    }
    tb163 = e10b / h10;
    pb[t->driverpath[i] + t->drivern[i] + k13 + 1] += tb163;
    pb[t->driverpath[i] + t->drivern[i] + k13] -= tb163;
    h10b -= tb163 * e10;
    path0b[t->driverrow[i] + k13 + 1][MAGGI_PATH_Y] += m1_10b;
    path0b[t->driverrow[i] + k13][MAGGI_PATH_Y] += m0_10b;
    s4b += c10b;
    path0b[t->driverrow[i] + k13][MAGGI_PATH_S] -= c10b;
    path0b[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] += a11b;
    s4b -= a11b;
    path0b[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] += h10b;
    path0b[t->driverrow[i] + k13][MAGGI_PATH_S] -= h10b;
    a10b = 0.0;
    c9b = 0.0;
    e9b = 0.0;
    h9b = 0.0;
    m0_9b = 0.0;
    m1_9b = 0.0;
    if (MAGGI_RE(c9) < 0.0) {
      slope13 = e9 - h9 / 6.0 * (2.0 * m0_9 + m1_9);
      x42b = 0.0;
      slope13b = x41b;
      x41b = 0.0;
      pb[t->driverpath[i] + k12] += x40b;
      slope13b += x40b * c9;
      c9b += x40b * slope13;
      x40b = 0.0;
      e9b += slope13b;
      h9b -= slope13b * (2.0 * m0_9 + m1_9) / 6.0;
      tb149 = slope13b * (h9 / 6.0);
      m0_9b -= tb149 * 2.0;
      m1_9b -= tb149;
    } else if (MAGGI_RE(a10) < 0.0) {
      slope13_2 = e9 + h9 / 6.0 * (m0_9 + 2.0 * m1_9);
      x42b = 0.0;
      slope13_2b = x41b;
      x41b = 0.0;
      pb[t->driverpath[i] + k12 + 1] += x40b;
      slope13_2b -= x40b * a10;
      a10b -= x40b * slope13_2;
      x40b = 0.0;
      e9b += slope13_2b;
      h9b += slope13_2b * (m0_9 + 2.0 * m1_9) / 6.0;
      tb150 = slope13_2b * (h9 / 6.0);
      m0_9b += tb150;
      m1_9b += tb150 * 2.0;
    } else {
      slope13_3 = e9 - h9 / 6.0 * (m1_9 - m0_9);
      t48 = 6.0 * h9;
      t49 = (m0_9 * a10 * a10 * a10 + m1_9 * c9 * c9 * c9) / t48;
      t50 = 2.0 * h9;
      t51 = (m1_9 * c9 * c9 - m0_9 * a10 * a10) / t50;
      t52 = (m0_9 * a10 + m1_9 * c9) / h9;
      t52b = x42b;
      x42b = 0.0;
      tb162 = t52b / h9;
      m0_9b += tb162 * a10;
      a10b += tb162 * m0_9;
      m1_9b += tb162 * c9;
      c9b += tb162 * m1_9;
      h9b -= tb162 * t52;
      t51b = x41b;
      slope13_3b = x41b;
      x41b = 0.0;
      tb159 = t51b / t50;
      tb160 = tb159 * c9;
      m1_9b += tb160 * c9;
      c9b += tb160 * m1_9;
      c9b += tb159 * (m1_9 * c9);
      tb161 = tb159 * a10;
      m0_9b -= tb161 * a10;
      a10b -= tb161 * m0_9;
      a10b -= tb159 * (m0_9 * a10);
      t50b = -(tb159 * t51);
      h9b += t50b * 2.0;
      t49b = x40b;
      pb[t->driverpath[i] + k12] += x40b;
      tb157 = x40b / 6.0;
      tb158 = tb157 * h9;
      m0_9b -= tb158 * h9;
      h9b -= tb158 * m0_9;
      h9b -= tb157 * (m0_9 * h9);
      slope13_3b += x40b * c9;
      c9b += x40b * slope13_3;
      x40b = 0.0;
      tb152 = t49b / t48;
      tb153 = tb152 * a10;
      tb154 = tb153 * a10;
      m0_9b += tb154 * a10;
      a10b += tb154 * m0_9;
      a10b += tb153 * (m0_9 * a10);
      a10b += tb152 * (m0_9 * a10 * a10);
      tb155 = tb152 * c9;
      tb156 = tb155 * c9;
      m1_9b += tb156 * c9;
      c9b += tb156 * m1_9;
      c9b += tb155 * (m1_9 * c9);
      c9b += tb152 * (m1_9 * c9 * c9);
      t48b = -(tb152 * t49);
      h9b += t48b * 6.0;
      e9b += slope13_3b;
      h9b -= slope13_3b * (m1_9 - m0_9) / 6.0;
      tb151 = slope13_3b * (h9 / 6.0);
      m1_9b -= tb151;
      m0_9b += tb151;
    }
    tb148 = e9b / h9;
    pb[t->driverpath[i] + k12 + 1] += tb148;
    pb[t->driverpath[i] + k12] -= tb148;
    h9b -= tb148 * e9;
    path0b[t->driverrow[i] + k12 + 1][MAGGI_PATH_X] += m1_9b;
    path0b[t->driverrow[i] + k12][MAGGI_PATH_X] += m0_9b;
    s4b += c9b;
    path0b[t->driverrow[i] + k12][MAGGI_PATH_S] -= c9b;
    path0b[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] += a10b;
    s4b -= a10b;
    path0b[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] += h9b;
    path0b[t->driverrow[i] + k12][MAGGI_PATH_S] -= h9b;
    s3b = s4b;
    t47b = -s4b;
    tb147 = t47b / slope12;
    g4b = tb147;
    slope12b = -(tb147 * t47);
    x31b = slope12b * x31;
    x31b += slope12b * x31;
    y31b = slope12b * y31;
    y31b += slope12b * y31;
    tb145 = slope12b * x32;
    x30b = tb145;
    Pb[0] -= tb145;
    x32b = slope12b * (x30 - P[0]);
    tb146 = slope12b * y32;
    y30b = tb146;
    Pb[1] -= tb146;
    y32b = slope12b * (y30 - P[1]);
    /* one step of Newton's method; C, C', C'' at s */
    tb143 = g4b * x31;
    x30b += tb143;
    Pb[0] -= tb143;
    x31b += g4b * (x30 - P[0]);
    tb144 = g4b * y31;
    y30b += tb144;
    Pb[1] -= tb144;
    y31b += g4b * (y30 - P[1]);
    a9b = 0.0;
    c8b = 0.0;
    e8b = 0.0;
    h8b = 0.0;
    m0_8b = 0.0;
    m1_8b = 0.0;
    if (MAGGI_RE(c8) < 0.0) {
      slope11 = e8 - h8 / 6.0 * (2.0 * m0_8 + m1_8);
      y32b = 0.0;
      slope11b = y31b;
      y31b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k11] += y30b;
      slope11b += y30b * c8;
      c8b += y30b * slope11;
      y30b = 0.0;
      e8b += slope11b;
      h8b -= slope11b * (2.0 * m0_8 + m1_8) / 6.0;
      tb129 = slope11b * (h8 / 6.0);
      m0_8b -= tb129 * 2.0;
      m1_8b -= tb129;
    } else if (MAGGI_RE(a9) < 0.0) {
      slope11_2 = e8 + h8 / 6.0 * (m0_8 + 2.0 * m1_8);
      y32b = 0.0;
      slope11_2b = y31b;
      y31b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k11 + 1] += y30b;
      slope11_2b -= y30b * a9;
      a9b -= y30b * slope11_2;
      y30b = 0.0;
      e8b += slope11_2b;
      h8b += slope11_2b * (m0_8 + 2.0 * m1_8) / 6.0;
      tb130 = slope11_2b * (h8 / 6.0);
      m0_8b += tb130;
      m1_8b += tb130 * 2.0;
    } else {
      slope11_3 = e8 - h8 / 6.0 * (m1_8 - m0_8);
      t42 = 6.0 * h8;
      t43 = (m0_8 * a9 * a9 * a9 + m1_8 * c8 * c8 * c8) / t42;
      t44 = 2.0 * h8;
      t45 = (m1_8 * c8 * c8 - m0_8 * a9 * a9) / t44;
      t46 = (m0_8 * a9 + m1_8 * c8) / h8;
      t46b = y32b;
      y32b = 0.0;
      tb142 = t46b / h8;
      m0_8b += tb142 * a9;
      a9b += tb142 * m0_8;
      m1_8b += tb142 * c8;
      c8b += tb142 * m1_8;
      h8b -= tb142 * t46;
      t45b = y31b;
      slope11_3b = y31b;
      y31b = 0.0;
      tb139 = t45b / t44;
      tb140 = tb139 * c8;
      m1_8b += tb140 * c8;
      c8b += tb140 * m1_8;
      c8b += tb139 * (m1_8 * c8);
      tb141 = tb139 * a9;
      m0_8b -= tb141 * a9;
      a9b -= tb141 * m0_8;
      a9b -= tb139 * (m0_8 * a9);
      t44b = -(tb139 * t45);
      h8b += t44b * 2.0;
      t43b = y30b;
      pb[t->driverpath[i] + t->drivern[i] + k11] += y30b;
      tb137 = y30b / 6.0;
      tb138 = tb137 * h8;
      m0_8b -= tb138 * h8;
      h8b -= tb138 * m0_8;
      h8b -= tb137 * (m0_8 * h8);
      slope11_3b += y30b * c8;
      c8b += y30b * slope11_3;
      y30b = 0.0;
      tb132 = t43b / t42;
      tb133 = tb132 * a9;
      tb134 = tb133 * a9;
      m0_8b += tb134 * a9;
      a9b += tb134 * m0_8;
      a9b += tb133 * (m0_8 * a9);
      a9b += tb132 * (m0_8 * a9 * a9);
      tb135 = tb132 * c8;
      tb136 = tb135 * c8;
      m1_8b += tb136 * c8;
      c8b += tb136 * m1_8;
      c8b += tb135 * (m1_8 * c8);
      c8b += tb132 * (m1_8 * c8 * c8);
      t42b = -(tb132 * t43);
      h8b += t42b * 6.0;
      e8b += slope11_3b;
      h8b -= slope11_3b * (m1_8 - m0_8) / 6.0;
      tb131 = slope11_3b * (h8 / 6.0);
      m1_8b -= tb131;
      m0_8b += tb131;
    }
    tb128 = e8b / h8;
    pb[t->driverpath[i] + t->drivern[i] + k11 + 1] += tb128;
    pb[t->driverpath[i] + t->drivern[i] + k11] -= tb128;
    h8b -= tb128 * e8;
    path0b[t->driverrow[i] + k11 + 1][MAGGI_PATH_Y] += m1_8b;
    path0b[t->driverrow[i] + k11][MAGGI_PATH_Y] += m0_8b;
    s3b += c8b;
    path0b[t->driverrow[i] + k11][MAGGI_PATH_S] -= c8b;
    path0b[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] += a9b;
    s3b -= a9b;
    path0b[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] += h8b;
    path0b[t->driverrow[i] + k11][MAGGI_PATH_S] -= h8b;
    a8b = 0.0;
    c7b = 0.0;
    e7b = 0.0;
    h7b = 0.0;
    m0_7b = 0.0;
    m1_7b = 0.0;
    if (MAGGI_RE(c7) < 0.0) {
      slope10 = e7 - h7 / 6.0 * (2.0 * m0_7 + m1_7);
      x32b = 0.0;
      slope10b = x31b;
      x31b = 0.0;
      pb[t->driverpath[i] + k10] += x30b;
      slope10b += x30b * c7;
      c7b += x30b * slope10;
      x30b = 0.0;
      e7b += slope10b;
      h7b -= slope10b * (2.0 * m0_7 + m1_7) / 6.0;
      tb114 = slope10b * (h7 / 6.0);
      m0_7b -= tb114 * 2.0;
      m1_7b -= tb114;
    } else if (MAGGI_RE(a8) < 0.0) {
      slope10_2 = e7 + h7 / 6.0 * (m0_7 + 2.0 * m1_7);
      x32b = 0.0;
      slope10_2b = x31b;
      x31b = 0.0;
      pb[t->driverpath[i] + k10 + 1] += x30b;
      slope10_2b -= x30b * a8;
      a8b -= x30b * slope10_2;
      x30b = 0.0;
      e7b += slope10_2b;
      h7b += slope10_2b * (m0_7 + 2.0 * m1_7) / 6.0;
      tb115 = slope10_2b * (h7 / 6.0);
      m0_7b += tb115;
      m1_7b += tb115 * 2.0;
    } else {
      slope10_3 = e7 - h7 / 6.0 * (m1_7 - m0_7);
      t37 = 6.0 * h7;
      t38 = (m0_7 * a8 * a8 * a8 + m1_7 * c7 * c7 * c7) / t37;
      t39 = 2.0 * h7;
      t40 = (m1_7 * c7 * c7 - m0_7 * a8 * a8) / t39;
      t41 = (m0_7 * a8 + m1_7 * c7) / h7;
      t41b = x32b;
      x32b = 0.0;
      tb127 = t41b / h7;
      m0_7b += tb127 * a8;
      a8b += tb127 * m0_7;
      m1_7b += tb127 * c7;
      c7b += tb127 * m1_7;
      h7b -= tb127 * t41;
      t40b = x31b;
      slope10_3b = x31b;
      x31b = 0.0;
      tb124 = t40b / t39;
      tb125 = tb124 * c7;
      m1_7b += tb125 * c7;
      c7b += tb125 * m1_7;
      c7b += tb124 * (m1_7 * c7);
      tb126 = tb124 * a8;
      m0_7b -= tb126 * a8;
      a8b -= tb126 * m0_7;
      a8b -= tb124 * (m0_7 * a8);
      t39b = -(tb124 * t40);
      h7b += t39b * 2.0;
      t38b = x30b;
      pb[t->driverpath[i] + k10] += x30b;
      tb122 = x30b / 6.0;
      tb123 = tb122 * h7;
      m0_7b -= tb123 * h7;
      h7b -= tb123 * m0_7;
      h7b -= tb122 * (m0_7 * h7);
      slope10_3b += x30b * c7;
      c7b += x30b * slope10_3;
      x30b = 0.0;
      tb117 = t38b / t37;
      tb118 = tb117 * a8;
      tb119 = tb118 * a8;
      m0_7b += tb119 * a8;
      a8b += tb119 * m0_7;
      a8b += tb118 * (m0_7 * a8);
      a8b += tb117 * (m0_7 * a8 * a8);
      tb120 = tb117 * c7;
      tb121 = tb120 * c7;
      m1_7b += tb121 * c7;
      c7b += tb121 * m1_7;
      c7b += tb120 * (m1_7 * c7);
      c7b += tb117 * (m1_7 * c7 * c7);
      t37b = -(tb117 * t38);
      h7b += t37b * 6.0;
      e7b += slope10_3b;
      h7b -= slope10_3b * (m1_7 - m0_7) / 6.0;
      tb116 = slope10_3b * (h7 / 6.0);
      m1_7b -= tb116;
      m0_7b += tb116;
    }
    tb113 = e7b / h7;
    pb[t->driverpath[i] + k10 + 1] += tb113;
    pb[t->driverpath[i] + k10] -= tb113;
    h7b -= tb113 * e7;
    path0b[t->driverrow[i] + k10 + 1][MAGGI_PATH_X] += m1_7b;
    path0b[t->driverrow[i] + k10][MAGGI_PATH_X] += m0_7b;
    s3b += c7b;
    path0b[t->driverrow[i] + k10][MAGGI_PATH_S] -= c7b;
    path0b[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] += a8b;
    s3b -= a8b;
    path0b[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] += h7b;
    path0b[t->driverrow[i] + k10][MAGGI_PATH_S] -= h7b;
    s2b = s3b;
    t36b = -s3b;
    tb112 = t36b / slope9;
    g3b = tb112;
    slope9b = -(tb112 * t36);
    x2_5b = slope9b * x2_5;
    x2_5b += slope9b * x2_5;
    y21b = slope9b * y21;
    y21b += slope9b * y21;
    tb110 = slope9b * x2_6;
    x2_4b = tb110;
    Pb[0] -= tb110;
    x2_6b = slope9b * (x2_4 - P[0]);
    tb111 = slope9b * y22;
    y20b = tb111;
    Pb[1] -= tb111;
    y22b = slope9b * (y20 - P[1]);
    /* one step of Newton's method; C, C', C'' at s */
    tb108 = g3b * x2_5;
    x2_4b += tb108;
    Pb[0] -= tb108;
    x2_5b += g3b * (x2_4 - P[0]);
    tb109 = g3b * y21;
    y20b += tb109;
    Pb[1] -= tb109;
    y21b += g3b * (y20 - P[1]);
    a7b = 0.0;
    c6b = 0.0;
    e6b = 0.0;
    h6b = 0.0;
    m0_6b = 0.0;
    m1_6b = 0.0;
    if (MAGGI_RE(c6) < 0.0) {
      slope8 = e6 - h6 / 6.0 * (2.0 * m0_6 + m1_6);
      y22b = 0.0;
      slope8b = y21b;
      y21b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k9] += y20b;
      slope8b += y20b * c6;
      c6b += y20b * slope8;
      y20b = 0.0;
      e6b += slope8b;
      h6b -= slope8b * (2.0 * m0_6 + m1_6) / 6.0;
      tb94 = slope8b * (h6 / 6.0);
      m0_6b -= tb94 * 2.0;
      m1_6b -= tb94;
    } else if (MAGGI_RE(a7) < 0.0) {
      slope8_2 = e6 + h6 / 6.0 * (m0_6 + 2.0 * m1_6);
      y22b = 0.0;
      slope8_2b = y21b;
      y21b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k9 + 1] += y20b;
      slope8_2b -= y20b * a7;
      a7b -= y20b * slope8_2;
      y20b = 0.0;
      e6b += slope8_2b;
      h6b += slope8_2b * (m0_6 + 2.0 * m1_6) / 6.0;
      tb95 = slope8_2b * (h6 / 6.0);
      m0_6b += tb95;
      m1_6b += tb95 * 2.0;
    } else {
      slope8_3 = e6 - h6 / 6.0 * (m1_6 - m0_6);
      t31 = 6.0 * h6;
      t32 = (m0_6 * a7 * a7 * a7 + m1_6 * c6 * c6 * c6) / t31;
      t33 = 2.0 * h6;
      t34 = (m1_6 * c6 * c6 - m0_6 * a7 * a7) / t33;
      t35 = (m0_6 * a7 + m1_6 * c6) / h6;
      t35b = y22b;
      y22b = 0.0;
      tb107 = t35b / h6;
      m0_6b += tb107 * a7;
      a7b += tb107 * m0_6;
      m1_6b += tb107 * c6;
      c6b += tb107 * m1_6;
      h6b -= tb107 * t35;
      t34b = y21b;
      slope8_3b = y21b;
      y21b = 0.0;
      tb104 = t34b / t33;
      tb105 = tb104 * c6;
      m1_6b += tb105 * c6;
      c6b += tb105 * m1_6;
      c6b += tb104 * (m1_6 * c6);
      tb106 = tb104 * a7;
      m0_6b -= tb106 * a7;
      a7b -= tb106 * m0_6;
      a7b -= tb104 * (m0_6 * a7);
      t33b = -(tb104 * t34);
      h6b += t33b * 2.0;
      t32b = y20b;
      pb[t->driverpath[i] + t->drivern[i] + k9] += y20b;
      tb102 = y20b / 6.0;
      tb103 = tb102 * h6;
      m0_6b -= tb103 * h6;
      h6b -= tb103 * m0_6;
      h6b -= tb102 * (m0_6 * h6);
      slope8_3b += y20b * c6;
      c6b += y20b * slope8_3;
      y20b = 0.0;
      tb97 = t32b / t31;
      tb98 = tb97 * a7;
      tb99 = tb98 * a7;
      m0_6b += tb99 * a7;
      a7b += tb99 * m0_6;
      a7b += tb98 * (m0_6 * a7);
      a7b += tb97 * (m0_6 * a7 * a7);
      tb100 = tb97 * c6;
      tb101 = tb100 * c6;
      m1_6b += tb101 * c6;
      c6b += tb101 * m1_6;
      c6b += tb100 * (m1_6 * c6);
      c6b += tb97 * (m1_6 * c6 * c6);
      t31b = -(tb97 * t32);
      h6b += t31b * 6.0;
      e6b += slope8_3b;
      h6b -= slope8_3b * (m1_6 - m0_6) / 6.0;
      tb96 = slope8_3b * (h6 / 6.0);
      m1_6b -= tb96;
      m0_6b += tb96;
    }
    tb93 = e6b / h6;
    pb[t->driverpath[i] + t->drivern[i] + k9 + 1] += tb93;
    pb[t->driverpath[i] + t->drivern[i] + k9] -= tb93;
    h6b -= tb93 * e6;
    path0b[t->driverrow[i] + k9 + 1][MAGGI_PATH_Y] += m1_6b;
    path0b[t->driverrow[i] + k9][MAGGI_PATH_Y] += m0_6b;
    s2b += c6b;
    path0b[t->driverrow[i] + k9][MAGGI_PATH_S] -= c6b;
    path0b[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] += a7b;
    s2b -= a7b;
    path0b[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] += h6b;
    path0b[t->driverrow[i] + k9][MAGGI_PATH_S] -= h6b;
    a6b = 0.0;
    c5b = 0.0;
    e5b = 0.0;
    h5b = 0.0;
    m0_5b = 0.0;
    m1_5b = 0.0;
    if (MAGGI_RE(c5) < 0.0) {
      slope7 = e5 - h5 / 6.0 * (2.0 * m0_5 + m1_5);
      x2_6b = 0.0;
      slope7b = x2_5b;
      x2_5b = 0.0;
      pb[t->driverpath[i] + k8] += x2_4b;
      slope7b += x2_4b * c5;
      c5b += x2_4b * slope7;
      x2_4b = 0.0;
      e5b += slope7b;
      h5b -= slope7b * (2.0 * m0_5 + m1_5) / 6.0;
      tb79 = slope7b * (h5 / 6.0);
      m0_5b -= tb79 * 2.0;
      m1_5b -= tb79;
    } else if (MAGGI_RE(a6) < 0.0) {
      slope7_2 = e5 + h5 / 6.0 * (m0_5 + 2.0 * m1_5);
      x2_6b = 0.0;
      slope7_2b = x2_5b;
      x2_5b = 0.0;
      pb[t->driverpath[i] + k8 + 1] += x2_4b;
      slope7_2b -= x2_4b * a6;
      a6b -= x2_4b * slope7_2;
      x2_4b = 0.0;
      e5b += slope7_2b;
      h5b += slope7_2b * (m0_5 + 2.0 * m1_5) / 6.0;
      tb80 = slope7_2b * (h5 / 6.0);
      m0_5b += tb80;
      m1_5b += tb80 * 2.0;
    } else {
      slope7_3 = e5 - h5 / 6.0 * (m1_5 - m0_5);
      t26 = 6.0 * h5;
      t27 = (m0_5 * a6 * a6 * a6 + m1_5 * c5 * c5 * c5) / t26;
      t28 = 2.0 * h5;
      t29 = (m1_5 * c5 * c5 - m0_5 * a6 * a6) / t28;
      t30 = (m0_5 * a6 + m1_5 * c5) / h5;
      t30b = x2_6b;
      x2_6b = 0.0;
      tb92 = t30b / h5;
      m0_5b += tb92 * a6;
      a6b += tb92 * m0_5;
      m1_5b += tb92 * c5;
      c5b += tb92 * m1_5;
      h5b -= tb92 * t30;
      t29b = x2_5b;
      slope7_3b = x2_5b;
      x2_5b = 0.0;
      tb89 = t29b / t28;
      tb90 = tb89 * c5;
      m1_5b += tb90 * c5;
      c5b += tb90 * m1_5;
      c5b += tb89 * (m1_5 * c5);
      tb91 = tb89 * a6;
      m0_5b -= tb91 * a6;
      a6b -= tb91 * m0_5;
      a6b -= tb89 * (m0_5 * a6);
      t28b = -(tb89 * t29);
      h5b += t28b * 2.0;
      t27b = x2_4b;
      pb[t->driverpath[i] + k8] += x2_4b;
      tb87 = x2_4b / 6.0;
      tb88 = tb87 * h5;
      m0_5b -= tb88 * h5;
      h5b -= tb88 * m0_5;
      h5b -= tb87 * (m0_5 * h5);
      slope7_3b += x2_4b * c5;
      c5b += x2_4b * slope7_3;
      x2_4b = 0.0;
      tb82 = t27b / t26;
      tb83 = tb82 * a6;
      tb84 = tb83 * a6;
      m0_5b += tb84 * a6;
      a6b += tb84 * m0_5;
      a6b += tb83 * (m0_5 * a6);
      a6b += tb82 * (m0_5 * a6 * a6);
      tb85 = tb82 * c5;
      tb86 = tb85 * c5;
      m1_5b += tb86 * c5;
      c5b += tb86 * m1_5;
      c5b += tb85 * (m1_5 * c5);
      c5b += tb82 * (m1_5 * c5 * c5);
      t26b = -(tb82 * t27);
      h5b += t26b * 6.0;
      e5b += slope7_3b;
      h5b -= slope7_3b * (m1_5 - m0_5) / 6.0;
      tb81 = slope7_3b * (h5 / 6.0);
      m1_5b -= tb81;
      m0_5b += tb81;
    }
    tb78 = e5b / h5;
    pb[t->driverpath[i] + k8 + 1] += tb78;
    pb[t->driverpath[i] + k8] -= tb78;
    h5b -= tb78 * e5;
    path0b[t->driverrow[i] + k8 + 1][MAGGI_PATH_X] += m1_5b;
    path0b[t->driverrow[i] + k8][MAGGI_PATH_X] += m0_5b;
    s2b += c5b;
    path0b[t->driverrow[i] + k8][MAGGI_PATH_S] -= c5b;
    path0b[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] += a6b;
    s2b -= a6b;
    path0b[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] += h5b;
    path0b[t->driverrow[i] + k8][MAGGI_PATH_S] -= h5b;
    s1b = s2b;
    t25b = -s2b;
    tb77 = t25b / slope6;
    g2b = tb77;
    slope6b = -(tb77 * t25);
    x11b = slope6b * x11;
    x11b += slope6b * x11;
    y11b = slope6b * y11;
    y11b += slope6b * y11;
    tb75 = slope6b * x12;
    x10b = tb75;
    Pb[0] -= tb75;
    x12b = slope6b * (x10 - P[0]);
    tb76 = slope6b * y12;
    y10b = tb76;
    Pb[1] -= tb76;
    y12b = slope6b * (y10 - P[1]);
    /* one step of Newton's method; C, C', C'' at s */
    tb73 = g2b * x11;
    x10b += tb73;
    Pb[0] -= tb73;
    x11b += g2b * (x10 - P[0]);
    tb74 = g2b * y11;
    y10b += tb74;
    Pb[1] -= tb74;
    y11b += g2b * (y10 - P[1]);
    a5b = 0.0;
    c4b = 0.0;
    e4b = 0.0;
    h4b = 0.0;
    m0_4b = 0.0;
    m1_4b = 0.0;
    if (MAGGI_RE(c4) < 0.0) {
      slope5 = e4 - h4 / 6.0 * (2.0 * m0_4 + m1_4);
      y12b = 0.0;
      slope5b = y11b;
      y11b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k7] += y10b;
      slope5b += y10b * c4;
      c4b += y10b * slope5;
      y10b = 0.0;
      e4b += slope5b;
      h4b -= slope5b * (2.0 * m0_4 + m1_4) / 6.0;
      tb59 = slope5b * (h4 / 6.0);
      m0_4b -= tb59 * 2.0;
      m1_4b -= tb59;
    } else if (MAGGI_RE(a5) < 0.0) {
      slope5_2 = e4 + h4 / 6.0 * (m0_4 + 2.0 * m1_4);
      y12b = 0.0;
      slope5_2b = y11b;
      y11b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k7 + 1] += y10b;
      slope5_2b -= y10b * a5;
      a5b -= y10b * slope5_2;
      y10b = 0.0;
      e4b += slope5_2b;
      h4b += slope5_2b * (m0_4 + 2.0 * m1_4) / 6.0;
      tb60 = slope5_2b * (h4 / 6.0);
      m0_4b += tb60;
      m1_4b += tb60 * 2.0;
    } else {
      slope5_3 = e4 - h4 / 6.0 * (m1_4 - m0_4);
      t20 = 6.0 * h4;
      t21 = (m0_4 * a5 * a5 * a5 + m1_4 * c4 * c4 * c4) / t20;
      t22 = 2.0 * h4;
      t23 = (m1_4 * c4 * c4 - m0_4 * a5 * a5) / t22;
      t24 = (m0_4 * a5 + m1_4 * c4) / h4;
      t24b = y12b;
      y12b = 0.0;
      tb72 = t24b / h4;
      m0_4b += tb72 * a5;
      a5b += tb72 * m0_4;
      m1_4b += tb72 * c4;
      c4b += tb72 * m1_4;
      h4b -= tb72 * t24;
      t23b = y11b;
      slope5_3b = y11b;
      y11b = 0.0;
      tb69 = t23b / t22;
      tb70 = tb69 * c4;
      m1_4b += tb70 * c4;
      c4b += tb70 * m1_4;
      c4b += tb69 * (m1_4 * c4);
      tb71 = tb69 * a5;
      m0_4b -= tb71 * a5;
      a5b -= tb71 * m0_4;
      a5b -= tb69 * (m0_4 * a5);
      t22b = -(tb69 * t23);
      h4b += t22b * 2.0;
      t21b = y10b;
      pb[t->driverpath[i] + t->drivern[i] + k7] += y10b;
      tb67 = y10b / 6.0;
      tb68 = tb67 * h4;
      m0_4b -= tb68 * h4;
      h4b -= tb68 * m0_4;
      h4b -= tb67 * (m0_4 * h4);
      slope5_3b += y10b * c4;
      c4b += y10b * slope5_3;
      y10b = 0.0;
      tb62 = t21b / t20;
      tb63 = tb62 * a5;
      tb64 = tb63 * a5;
      m0_4b += tb64 * a5;
      a5b += tb64 * m0_4;
      a5b += tb63 * (m0_4 * a5);
      a5b += tb62 * (m0_4 * a5 * a5);
      tb65 = tb62 * c4;
      tb66 = tb65 * c4;
      m1_4b += tb66 * c4;
      c4b += tb66 * m1_4;
      c4b += tb65 * (m1_4 * c4);
      c4b += tb62 * (m1_4 * c4 * c4);
      t20b = -(tb62 * t21);
      h4b += t20b * 6.0;
      e4b += slope5_3b;
      h4b -= slope5_3b * (m1_4 - m0_4) / 6.0;
      tb61 = slope5_3b * (h4 / 6.0);
      m1_4b -= tb61;
      m0_4b += tb61;
    }
    tb58 = e4b / h4;
    pb[t->driverpath[i] + t->drivern[i] + k7 + 1] += tb58;
    pb[t->driverpath[i] + t->drivern[i] + k7] -= tb58;
    h4b -= tb58 * e4;
    path0b[t->driverrow[i] + k7 + 1][MAGGI_PATH_Y] += m1_4b;
    path0b[t->driverrow[i] + k7][MAGGI_PATH_Y] += m0_4b;
    s1b += c4b;
    path0b[t->driverrow[i] + k7][MAGGI_PATH_S] -= c4b;
    path0b[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] += a5b;
    s1b -= a5b;
    path0b[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] += h4b;
    path0b[t->driverrow[i] + k7][MAGGI_PATH_S] -= h4b;
    a4b = 0.0;
    c3b = 0.0;
    e3b = 0.0;
    h3b = 0.0;
    m0_3b = 0.0;
    m1_3b = 0.0;
    if (MAGGI_RE(c3) < 0.0) {
      slope4 = e3 - h3 / 6.0 * (2.0 * m0_3 + m1_3);
      x12b = 0.0;
      slope4b = x11b;
      x11b = 0.0;
      pb[t->driverpath[i] + k6] += x10b;
      slope4b += x10b * c3;
      c3b += x10b * slope4;
      x10b = 0.0;
      e3b += slope4b;
      h3b -= slope4b * (2.0 * m0_3 + m1_3) / 6.0;
      tb44 = slope4b * (h3 / 6.0);
      m0_3b -= tb44 * 2.0;
      m1_3b -= tb44;
    } else if (MAGGI_RE(a4) < 0.0) {
      slope4_2 = e3 + h3 / 6.0 * (m0_3 + 2.0 * m1_3);
      x12b = 0.0;
      slope4_2b = x11b;
      x11b = 0.0;
      pb[t->driverpath[i] + k6 + 1] += x10b;
      slope4_2b -= x10b * a4;
      a4b -= x10b * slope4_2;
      x10b = 0.0;
      e3b += slope4_2b;
      h3b += slope4_2b * (m0_3 + 2.0 * m1_3) / 6.0;
      tb45 = slope4_2b * (h3 / 6.0);
      m0_3b += tb45;
      m1_3b += tb45 * 2.0;
    } else {
      slope4_3 = e3 - h3 / 6.0 * (m1_3 - m0_3);
      t15 = 6.0 * h3;
      t16 = (m0_3 * a4 * a4 * a4 + m1_3 * c3 * c3 * c3) / t15;
      t17 = 2.0 * h3;
      t18 = (m1_3 * c3 * c3 - m0_3 * a4 * a4) / t17;
      t19 = (m0_3 * a4 + m1_3 * c3) / h3;
      t19b = x12b;
      x12b = 0.0;
      tb57 = t19b / h3;
      m0_3b += tb57 * a4;
      a4b += tb57 * m0_3;
      m1_3b += tb57 * c3;
      c3b += tb57 * m1_3;
      h3b -= tb57 * t19;
      t18b = x11b;
      slope4_3b = x11b;
      x11b = 0.0;
      tb54 = t18b / t17;
      tb55 = tb54 * c3;
      m1_3b += tb55 * c3;
      c3b += tb55 * m1_3;
      c3b += tb54 * (m1_3 * c3);
      tb56 = tb54 * a4;
      m0_3b -= tb56 * a4;
      a4b -= tb56 * m0_3;
      a4b -= tb54 * (m0_3 * a4);
      t17b = -(tb54 * t18);
      h3b += t17b * 2.0;
      t16b = x10b;
      pb[t->driverpath[i] + k6] += x10b;
      tb52 = x10b / 6.0;
      tb53 = tb52 * h3;
      m0_3b -= tb53 * h3;
      h3b -= tb53 * m0_3;
      h3b -= tb52 * (m0_3 * h3);
      slope4_3b += x10b * c3;
      c3b += x10b * slope4_3;
      x10b = 0.0;
      tb47 = t16b / t15;
      tb48 = tb47 * a4;
      tb49 = tb48 * a4;
      m0_3b += tb49 * a4;
      a4b += tb49 * m0_3;
      a4b += tb48 * (m0_3 * a4);
      a4b += tb47 * (m0_3 * a4 * a4);
      tb50 = tb47 * c3;
      tb51 = tb50 * c3;
      m1_3b += tb51 * c3;
      c3b += tb51 * m1_3;
      c3b += tb50 * (m1_3 * c3);
      c3b += tb47 * (m1_3 * c3 * c3);
      t15b = -(tb47 * t16);
      h3b += t15b * 6.0;
      e3b += slope4_3b;
      h3b -= slope4_3b * (m1_3 - m0_3) / 6.0;
      tb46 = slope4_3b * (h3 / 6.0);
      m1_3b -= tb46;
      m0_3b += tb46;
    }
    tb43 = e3b / h3;
    pb[t->driverpath[i] + k6 + 1] += tb43;
    pb[t->driverpath[i] + k6] -= tb43;
    h3b -= tb43 * e3;
    path0b[t->driverrow[i] + k6 + 1][MAGGI_PATH_X] += m1_3b;
    path0b[t->driverrow[i] + k6][MAGGI_PATH_X] += m0_3b;
    s1b += c3b;
    path0b[t->driverrow[i] + k6][MAGGI_PATH_S] -= c3b;
    path0b[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] += a4b;
    s1b -= a4b;
    path0b[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] += h3b;
    path0b[t->driverrow[i] + k6][MAGGI_PATH_S] -= h3b;
    s0b = s1b;
    t14b = -s1b;
    tb42 = t14b / slope3;
    gb = tb42;
    slope3b = -(tb42 * t14);
    x01b = slope3b * x01;
    x01b += slope3b * x01;
    y01b = slope3b * y01;
    y01b += slope3b * y01;
    tb40 = slope3b * x02;
    x00b = tb40;
    Pb[0] -= tb40;
    x02b = slope3b * (x00 - P[0]);
    tb41 = slope3b * y02;
    y00b = tb41;
    Pb[1] -= tb41;
    y02b = slope3b * (y00 - P[1]);
    /* one step of Newton's method; C, C', C'' at s */
    tb38 = gb * x01;
    x00b += tb38;
    Pb[0] -= tb38;
    x01b += gb * (x00 - P[0]);
    tb39 = gb * y01;
    y00b += tb39;
    Pb[1] -= tb39;
    y01b += gb * (y00 - P[1]);
    a3b = 0.0;
    c2b = 0.0;
    e2b = 0.0;
    h2b = 0.0;
    m0_2b = 0.0;
    m1_2b = 0.0;
    if (MAGGI_RE(c2) < 0.0) {
      slope2 = e2 - h2 / 6.0 * (2.0 * m0_2 + m1_2);
      y02b = 0.0;
      slope2b = y01b;
      y01b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k5] += y00b;
      slope2b += y00b * c2;
      c2b += y00b * slope2;
      y00b = 0.0;
      e2b += slope2b;
      h2b -= slope2b * (2.0 * m0_2 + m1_2) / 6.0;
      tb24 = slope2b * (h2 / 6.0);
      m0_2b -= tb24 * 2.0;
      m1_2b -= tb24;
    } else if (MAGGI_RE(a3) < 0.0) {
      slope2_2 = e2 + h2 / 6.0 * (m0_2 + 2.0 * m1_2);
      y02b = 0.0;
      slope2_2b = y01b;
      y01b = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k5 + 1] += y00b;
      slope2_2b -= y00b * a3;
      a3b -= y00b * slope2_2;
      y00b = 0.0;
      e2b += slope2_2b;
      h2b += slope2_2b * (m0_2 + 2.0 * m1_2) / 6.0;
      tb25 = slope2_2b * (h2 / 6.0);
      m0_2b += tb25;
      m1_2b += tb25 * 2.0;
    } else {
      slope2_3 = e2 - h2 / 6.0 * (m1_2 - m0_2);
      t9 = 6.0 * h2;
      t10 = (m0_2 * a3 * a3 * a3 + m1_2 * c2 * c2 * c2) / t9;
      t11 = 2.0 * h2;
      t12 = (m1_2 * c2 * c2 - m0_2 * a3 * a3) / t11;
      t13 = (m0_2 * a3 + m1_2 * c2) / h2;
      t13b = y02b;
      y02b = 0.0;
      tb37 = t13b / h2;
      m0_2b += tb37 * a3;
      a3b += tb37 * m0_2;
      m1_2b += tb37 * c2;
      c2b += tb37 * m1_2;
      h2b -= tb37 * t13;
      t12b = y01b;
      slope2_3b = y01b;
      y01b = 0.0;
      tb34 = t12b / t11;
      tb35 = tb34 * c2;
      m1_2b += tb35 * c2;
      c2b += tb35 * m1_2;
      c2b += tb34 * (m1_2 * c2);
      tb36 = tb34 * a3;
      m0_2b -= tb36 * a3;
      a3b -= tb36 * m0_2;
      a3b -= tb34 * (m0_2 * a3);
      t11b = -(tb34 * t12);
      h2b += t11b * 2.0;
      t10b = y00b;
      pb[t->driverpath[i] + t->drivern[i] + k5] += y00b;
      tb32 = y00b / 6.0;
      tb33 = tb32 * h2;
      m0_2b -= tb33 * h2;
      h2b -= tb33 * m0_2;
      h2b -= tb32 * (m0_2 * h2);
      slope2_3b += y00b * c2;
      c2b += y00b * slope2_3;
      y00b = 0.0;
      tb27 = t10b / t9;
      tb28 = tb27 * a3;
      tb29 = tb28 * a3;
      m0_2b += tb29 * a3;
      a3b += tb29 * m0_2;
      a3b += tb28 * (m0_2 * a3);
      a3b += tb27 * (m0_2 * a3 * a3);
      tb30 = tb27 * c2;
      tb31 = tb30 * c2;
      m1_2b += tb31 * c2;
      c2b += tb31 * m1_2;
      c2b += tb30 * (m1_2 * c2);
      c2b += tb27 * (m1_2 * c2 * c2);
      t9b = -(tb27 * t10);
      h2b += t9b * 6.0;
      e2b += slope2_3b;
      h2b -= slope2_3b * (m1_2 - m0_2) / 6.0;
      tb26 = slope2_3b * (h2 / 6.0);
      m1_2b -= tb26;
      m0_2b += tb26;
    }
    tb23 = e2b / h2;
    pb[t->driverpath[i] + t->drivern[i] + k5 + 1] += tb23;
    pb[t->driverpath[i] + t->drivern[i] + k5] -= tb23;
    h2b -= tb23 * e2;
    path0b[t->driverrow[i] + k5 + 1][MAGGI_PATH_Y] += m1_2b;
    path0b[t->driverrow[i] + k5][MAGGI_PATH_Y] += m0_2b;
    s0b += c2b;
    path0b[t->driverrow[i] + k5][MAGGI_PATH_S] -= c2b;
    path0b[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] += a3b;
    s0b -= a3b;
    path0b[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] += h2b;
    path0b[t->driverrow[i] + k5][MAGGI_PATH_S] -= h2b;
    a2b = 0.0;
    cb = 0.0;
    eb = 0.0;
    hb = 0.0;
    m0b = 0.0;
    m1b = 0.0;
    if (MAGGI_RE(c) < 0.0) {
      slope = e - h / 6.0 * (2.0 * m0 + m1);
      x02b = 0.0;
      slopeb = x01b;
      x01b = 0.0;
      pb[t->driverpath[i] + k4] += x00b;
      slopeb += x00b * c;
      cb += x00b * slope;
      x00b = 0.0;
      eb += slopeb;
      hb -= slopeb * (2.0 * m0 + m1) / 6.0;
      tb9 = slopeb * (h / 6.0);
      m0b -= tb9 * 2.0;
      m1b -= tb9;
    } else if (MAGGI_RE(a2) < 0.0) {
      slope22 = e + h / 6.0 * (m0 + 2.0 * m1);
      x02b = 0.0;
      slope22b = x01b;
      x01b = 0.0;
      pb[t->driverpath[i] + k4 + 1] += x00b;
      slope22b -= x00b * a2;
      a2b -= x00b * slope22;
      x00b = 0.0;
      eb += slope22b;
      hb += slope22b * (m0 + 2.0 * m1) / 6.0;
      tb10 = slope22b * (h / 6.0);
      m0b += tb10;
      m1b += tb10 * 2.0;
    } else {
      slope22_2 = e - h / 6.0 * (m1 - m0);
      t4 = 6.0 * h;
      t5 = (m0 * a2 * a2 * a2 + m1 * c * c * c) / t4;
      t6 = 2.0 * h;
      t7 = (m1 * c * c - m0 * a2 * a2) / t6;
      t8 = (m0 * a2 + m1 * c) / h;
      t8b = x02b;
      x02b = 0.0;
      tb22 = t8b / h;
      m0b += tb22 * a2;
      a2b += tb22 * m0;
      m1b += tb22 * c;
      cb += tb22 * m1;
      hb -= tb22 * t8;
      t7b = x01b;
      slope22_2b = x01b;
      x01b = 0.0;
      tb19 = t7b / t6;
      tb20 = tb19 * c;
      m1b += tb20 * c;
      cb += tb20 * m1;
      cb += tb19 * (m1 * c);
      tb21 = tb19 * a2;
      m0b -= tb21 * a2;
      a2b -= tb21 * m0;
      a2b -= tb19 * (m0 * a2);
      t6b = -(tb19 * t7);
      hb += t6b * 2.0;
      t5b = x00b;
      pb[t->driverpath[i] + k4] += x00b;
      tb17 = x00b / 6.0;
      tb18 = tb17 * h;
      m0b -= tb18 * h;
      hb -= tb18 * m0;
      hb -= tb17 * (m0 * h);
      slope22_2b += x00b * c;
      cb += x00b * slope22_2;
      x00b = 0.0;
      tb12 = t5b / t4;
      tb13 = tb12 * a2;
      tb14 = tb13 * a2;
      m0b += tb14 * a2;
      a2b += tb14 * m0;
      a2b += tb13 * (m0 * a2);
      a2b += tb12 * (m0 * a2 * a2);
      tb15 = tb12 * c;
      tb16 = tb15 * c;
      m1b += tb16 * c;
      cb += tb16 * m1;
      cb += tb15 * (m1 * c);
      cb += tb12 * (m1 * c * c);
      t4b = -(tb12 * t5);
      hb += t4b * 6.0;
      eb += slope22_2b;
      hb -= slope22_2b * (m1 - m0) / 6.0;
      tb11 = slope22_2b * (h / 6.0);
      m1b -= tb11;
      m0b += tb11;
    }
    tb8 = eb / h;
    pb[t->driverpath[i] + k4 + 1] += tb8;
    pb[t->driverpath[i] + k4] -= tb8;
    hb -= tb8 * e;
    path0b[t->driverrow[i] + k4 + 1][MAGGI_PATH_X] += m1b;
    path0b[t->driverrow[i] + k4][MAGGI_PATH_X] += m0b;
    s0b += cb;
    path0b[t->driverrow[i] + k4][MAGGI_PATH_S] -= cb;
    path0b[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] += a2b;
    s0b -= a2b;
    path0b[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] += hb;
    path0b[t->driverrow[i] + k4][MAGGI_PATH_S] -= hb;
    path0b[t->driverrow[i] + k3][MAGGI_PATH_S] += s0b;
    t3b = s0b * (path0[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k3][MAGGI_PATH_S]);
    tb7 = s0b * t3;
    path0b[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] += tb7;
    path0b[t->driverrow[i] + k3][MAGGI_PATH_S] -= tb7;
    tb4 = t3b / t2;
    tb5 = tb4 * dx;
    Pb[0] += tb5;
    pb[t->driverpath[i] + k3] -= tb5;
    dxb = tb4 * (P[0] - p[t->driverpath[i] + k3]);
    tb6 = tb4 * dy;
    Pb[1] += tb6;
    pb[t->driverpath[i] + t->drivern[i] + k3] -= tb6;
    dyb = tb4 * (P[1] - p[t->driverpath[i] + t->drivern[i] + k3]);
    t2b = -(tb4 * t3);
    dxb += t2b * dx;
    dxb += t2b * dx;
    dyb += t2b * dy;
    dyb += t2b * dy;
    pb[t->driverpath[i] + t->drivern[i] + k3 + 1] += dyb;
    pb[t->driverpath[i] + t->drivern[i] + k3] -= dyb;
    /* where P is nearest to the line through piece k of the polyline, as a part of the piece */
    pb[t->driverpath[i] + k3 + 1] += dxb;
    pb[t->driverpath[i] + k3] -= dxb;
    tb3 = Pb[1];
    Pb[1] = 0.0;
    x1_2b = tb3;
    p_ib = tb3 * rv[a][1];
    rvb[a][1] += tb3 * p_i;
    tb2 = Pb[0];
    Pb[0] = 0.0;
    x0_2b = tb2;
    p_ib += tb2 * rv[a][0];
    rvb[a][0] += tb2 * p_i;
    pb[t->driveradr[i]] += p_ib;
    rb[a][1] += x1_2b;
    rb[b][1] -= x1_2b;
    rb[a][0] += x0_2b;
    rb[b][0] -= x0_2b;
  }
}
