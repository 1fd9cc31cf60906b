/* Tangent of the adjoint of core/kernel/control.c.
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
void maggi_control_forces_b_d(const maggi_topo *t, const double p[restrict t->np],
                              const double pd[restrict t->np], double pb[restrict t->np],
                              double pbd[restrict t->np], const double fun[restrict t->nfun][3],
                              const double fund[restrict t->nfun][3],
                              double funb[restrict t->nfun][3], double funbd[restrict t->nfun][3],
                              const double path0[restrict t->npath0][8],
                              const double path0d[restrict t->npath0][8],
                              double path0b[restrict t->npath0][8],
                              double path0bd[restrict t->npath0][8], const double q[restrict t->nq],
                              const double qd[restrict t->nq], double qb[restrict t->nq],
                              double qbd[restrict t->nq], const double v[restrict t->nq],
                              const double vd[restrict t->nq], double vb[restrict t->nq],
                              double vbd[restrict t->nq], const double r[restrict t->npoint][3],
                              const double rd[restrict t->npoint][3],
                              double rb[restrict t->npoint][3], double rbd[restrict t->npoint][3],
                              const double rv[restrict t->npoint][3],
                              const double rvd[restrict t->npoint][3],
                              double rvb[restrict t->npoint][3], double rvbd[restrict t->npoint][3],
                              double driver[restrict t->ndriver][4],
                              double driverd[restrict t->ndriver][4],
                              double driverb[restrict t->ndriver][4],
                              double driverbd[restrict t->ndriver][4],
                              double speed[restrict t->nspeed][3],
                              double speedd[restrict t->nspeed][3],
                              double speedb[restrict t->nspeed][3],
                              double speedbd[restrict t->nspeed][3], double tau[restrict t->nq],
                              double taud[restrict t->nq], double taub[restrict t->nq],
                              double taubd[restrict t->nq], double power[restrict 1])
{
  int a, b, i, k, k10, k11, k12, k13, k14, k15, k16, k17, k18, k19, k20, k3, k4, k5, k6, k7, k8, k9;
  double a10, a10b, a10bd, a10d, a11, a11b, a11bd, a11d, a12, a12b, a12bd, a12d, a13, a13b, a13bd,
      a13d, a14, a14b, a14bd, a14d, a15, a15b, a15bd, a15d, a16, a16b, a16bd, a16d, a2, a2b, a2bd,
      a2d, a3, a3b, a3bd, a3d, a4, a4b, a4bd, a4d, a5, a5b, a5bd, a5d, a6, a6b, a6bd, a6d, a7, a7b,
      a7bd, a7d, a8, a8b, a8bd, a8d, a9, a9b, a9bd, a9d, c, c10, c10b, c10bd, c10d, c11, c11b,
      c11bd, c11d, c12, c12b, c12bd, c12d, c13, c13b, c13bd, c13d, c14, c14b, c14bd, c14d, c15,
      c15b, c15bd, c15d, c2, c2b, c2bd, c2d, c3, c3b, c3bd, c3d, c4, c4b, c4bd, c4d, c5, c5b, c5bd,
      c5d, c6, c6b, c6bd, c6d, c7, c7b, c7bd, c7d, c8, c8b, c8bd, c8d, c9, c9b, c9bd, c9d, cb, cbd,
      cd, curvature, curvatureb, curvaturebd, curvatured, demand, demandb, demandbd, demandd, dx,
      dxb, dxbd, dxd, dy, dyb, dybd, dyd, e, e10, e10b, e10bd, e10d, e11, e11b, e11bd, e11d, e12,
      e12b, e12bd, e12d, e13, e13b, e13bd, e13d, e14, e14b, e14bd, e14d, e15, e15b, e15bd, e15d,
      e16, e16b, e16bd, e16d, e2, e2b, e2bd, e2d, e3, e3b, e3bd, e3d, e4, e4b, e4bd, e4d, e5, e5b,
      e5bd, e5d, e6, e6b, e6bd, e6d, e7, e7b, e7bd, e7d, e8, e8b, e8bd, e8d, e9, e9b, e9bd, e9d, eb,
      ebd, ed, error, errorb, errorbd, errord, factor, factorb, factorbd, factord, g, g2, g2b, g2bd,
      g2d, g3, g3b, g3bd, g3d, g4, g4b, g4bd, g4d, g5, g5b, g5bd, g5d, g6, g6b, g6bd, g6d, gain,
      gainb, gainbd, gaind, gb, gbd, gd, h, h10, h10b, h10bd, h10d, h11, h11b, h11bd, h11d, h12,
      h12b, h12bd, h12d, h13, h13b, h13bd, h13d, h14, h14b, h14bd, h14d, h15, h15b, h15bd, h15d, h2,
      h2b, h2bd, h2d, h3, h3b, h3bd, h3d, h4, h4b, h4bd, h4d, h5, h5b, h5bd, h5d, h6, h6b, h6bd,
      h6d, h7, h7b, h7bd, h7d, h8, h8b, h8bd, h8d, h9, h9b, h9bd, h9d, hb, hbd, hd, length, lengthb,
      lengthbd, lengthd, limit, limitb, limitbd, limitd, m0, m0_10, m0_10b, m0_10bd, m0_10d, m0_11,
      m0_11b, m0_11bd, m0_11d, m0_12, m0_12b, m0_12bd, m0_12d, m0_13, m0_13b, m0_13bd, m0_13d,
      m0_14, m0_14b, m0_14bd, m0_14d, m0_15, m0_15b, m0_15bd, m0_15d, m0_2, m0_2b, m0_2bd, m0_2d,
      m0_3, m0_3b, m0_3bd, m0_3d, m0_4, m0_4b, m0_4bd, m0_4d, m0_5, m0_5b, m0_5bd, m0_5d, m0_6,
      m0_6b, m0_6bd, m0_6d, m0_7, m0_7b, m0_7bd, m0_7d, m0_8, m0_8b, m0_8bd, m0_8d, m0_9, m0_9b,
      m0_9bd, m0_9d, m0b, m0bd, m0d, m1, m1_10, m1_10b, m1_10bd, m1_10d, m1_11, m1_11b, m1_11bd,
      m1_11d, m1_12, m1_12b, m1_12bd, m1_12d, m1_13, m1_13b, m1_13bd, m1_13d, m1_14, m1_14b,
      m1_14bd, m1_14d, m1_15, m1_15b, m1_15bd, m1_15d, m1_2, m1_2b, m1_2bd, m1_2d, m1_3, m1_3b,
      m1_3bd, m1_3d, m1_4, m1_4b, m1_4bd, m1_4d, m1_5, m1_5b, m1_5bd, m1_5d, m1_6, m1_6b, m1_6bd,
      m1_6d, m1_7, m1_7b, m1_7bd, m1_7d, m1_8, m1_8b, m1_8bd, m1_8d, m1_9, m1_9b, m1_9bd, m1_9d,
      m1b, m1bd, m1d, p2, p2b, p2bd, p2d, p_i, p_ib, p_ibd, p_id, rv_i0, rv_i0b, rv_i0bd, rv_i0d,
      rv_i1, rv_i1b, rv_i1bd, rv_i1d, rv_i2, rv_i2b, rv_i2bd, rv_i2d, s, s0, s0b, s0bd, s0d, s1,
      s1b, s1bd, s1d, s2, s2b, s2bd, s2d, s3, s3b, s3bd, s3d, s4, s4b, s4bd, s4d, s5, s5b, s5bd,
      s5d, s6, s6b, s6bd, s6d, sb, sbd, sd, slope, slope10, slope10_2, slope10_2b, slope10_2bd,
      slope10_2d, slope10_3, slope10_3b, slope10_3bd, slope10_3d, slope10b, slope10bd, slope10d,
      slope11, slope11_2, slope11_2b, slope11_2bd, slope11_2d, slope11_3, slope11_3b, slope11_3bd,
      slope11_3d, slope11b, slope11bd, slope11d, slope12, slope12b, slope12bd, slope12d, slope13,
      slope13_2, slope13_2b, slope13_2bd, slope13_2d, slope13_3, slope13_3b, slope13_3bd,
      slope13_3d, slope13b, slope13bd, slope13d, slope14, slope14_2, slope14_2b, slope14_2bd,
      slope14_2d, slope14_3, slope14_3b, slope14_3bd, slope14_3d, slope14b, slope14bd, slope14d,
      slope15, slope15b, slope15bd, slope15d, slope16, slope16_2, slope16_2b, slope16_2bd,
      slope16_2d, slope16_3, slope16_3b, slope16_3bd, slope16_3d, slope16b, slope16bd, slope16d,
      slope17, slope17_2, slope17_2b, slope17_2bd, slope17_2d, slope17_3, slope17_3b, slope17_3bd,
      slope17_3d, slope17b, slope17bd, slope17d, slope18, slope18b, slope18bd, slope18d, slope19,
      slope19_2, slope19_2b, slope19_2bd, slope19_2d, slope19_3, slope19_3b, slope19_3bd,
      slope19_3d, slope19b, slope19bd, slope19d, slope2, slope20, slope20_2, slope20_2b,
      slope20_2bd, slope20_2d, slope20_3, slope20_3b, slope20_3bd, slope20_3d, slope20b, slope20bd,
      slope20d, slope21, slope21_2, slope21_2b, slope21_2bd, slope21_2d, slope21_3, slope21_3b,
      slope21_3bd, slope21_3d, slope21b, slope21bd, slope21d, slope22, slope22_2, slope22_2b,
      slope22_2bd, slope22_2d, slope22b, slope22bd, slope22d, slope2_2, slope2_2b, slope2_2bd,
      slope2_2d, slope2_3, slope2_3b, slope2_3bd, slope2_3d, slope2b, slope2bd, slope2d, slope3,
      slope3b, slope3bd, slope3d, slope4, slope4_2, slope4_2b, slope4_2bd, slope4_2d, slope4_3,
      slope4_3b, slope4_3bd, slope4_3d, slope4b, slope4bd, slope4d, slope5, slope5_2, slope5_2b,
      slope5_2bd, slope5_2d, slope5_3, slope5_3b, slope5_3bd, slope5_3d, slope5b, slope5bd, slope5d,
      slope6, slope6b, slope6bd, slope6d, slope7, slope7_2, slope7_2b, slope7_2bd, slope7_2d,
      slope7_3, slope7_3b, slope7_3bd, slope7_3d, slope7b, slope7bd, slope7d, slope8, slope8_2,
      slope8_2b, slope8_2bd, slope8_2d, slope8_3, slope8_3b, slope8_3bd, slope8_3d, slope8b,
      slope8bd, slope8d, slope9, slope9b, slope9bd, slope9d, slopeb, slopebd, sloped, speed2,
      speed2b, speed2bd, speed2d, steer0b, steer0bd, t10, t10b, t10bd, t10d, t11, t11b, t11bd, t11d,
      t12, t12b, t12bd, t12d, t13, t13b, t13bd, t13d, t14, t14b, t14bd, t14d, t15, t15b, t15bd,
      t15d, t16, t16b, t16bd, t16d, t17, t17b, t17bd, t17d, t18, t18b, t18bd, t18d, t19, t19b,
      t19bd, t19d, t2, t20, t20b, t20bd, t20d, t21, t21b, t21bd, t21d, t22, t22b, t22bd, t22d, t23,
      t23b, t23bd, t23d, t24, t24b, t24bd, t24d, t25, t25b, t25bd, t25d, t26, t26b, t26bd, t26d,
      t27, t27b, t27bd, t27d, t28, t28b, t28bd, t28d, t29, t29b, t29bd, t29d, t2b, t2bd, t2d, t3,
      t30, t30b, t30bd, t30d, t31, t31b, t31bd, t31d, t32, t32b, t32bd, t32d, t33, t33b, t33bd,
      t33d, t34, t34b, t34bd, t34d, t35, t35b, t35bd, t35d, t36, t36b, t36bd, t36d, t37, t37b,
      t37bd, t37d, t38, t38b, t38bd, t38d, t39, t39b, t39bd, t39d, t3b, t3bd, t3d, t4, t40, t40b,
      t40bd, t40d, t41, t41b, t41bd, t41d, t42, t42b, t42bd, t42d, t43, t43b, t43bd, t43d, t44,
      t44b, t44bd, t44d, t45, t45b, t45bd, t45d, t46, t46b, t46bd, t46d, t47, t47b, t47bd, t47d,
      t48, t48b, t48bd, t48d, t49, t49b, t49bd, t49d, t4b, t4bd, t4d, t5, t50, t50b, t50bd, t50d,
      t51, t51b, t51bd, t51d, t52, t52b, t52bd, t52d, t53, t53b, t53bd, t53d, t54, t54b, t54bd,
      t54d, t55, t55b, t55bd, t55d, t56, t56b, t56bd, t56d, t57, t57b, t57bd, t57d, t58, t58b,
      t58bd, t58d, t59, t59b, t59bd, t59d, t5b, t5bd, t5d, t6, t60, t60b, t60bd, t60d, t61, t61b,
      t61bd, t61d, t62, t62b, t62bd, t62d, t63, t63b, t63bd, t63d, t64, t64b, t64bd, t64d, t65,
      t65b, t65bd, t65d, t66, t66b, t66bd, t66d, t67, t67b, t67bd, t67d, t68, t68b, t68bd, t68d,
      t69, t69b, t69bd, t69d, t6b, t6bd, t6d, t7, t70, t70b, t70bd, t70d, t71, t71b, t71bd, t71d,
      t72, t72b, t72bd, t72d, t73, t73b, t73bd, t73d, t74, t74b, t74bd, t74d, t75, t75b, t75bd,
      t75d, t76, t76b, t76bd, t76d, t77, t77b, t77bd, t77d, t78, t78b, t78bd, t78d, t79, t79b,
      t79bd, t79d, t7b, t7bd, t7d, t8, t80, t80b, t80bd, t80d, t81, t81b, t81bd, t81d, t82, t82b,
      t82bd, t82d, t83, t83b, t83bd, t83d, t84, t84b, t84bd, t84d, t85, t85b, t85bd, t85d, t86b,
      t86bd, t87, t87b, t87bd, t87d, t8b, t8bd, t8d, t9, t9b, t9bd, t9d, targetb, targetbd, tb10,
      tb100, tb100d, tb101, tb101d, tb102, tb102d, tb103, tb103d, tb104, tb104d, tb105, tb105d,
      tb106, tb106d, tb107, tb107d, tb108, tb108d, tb109, tb109d, tb10d, tb11, tb110, tb110d, tb111,
      tb111d, tb112, tb112d, tb113, tb113d, tb114, tb114d, tb115, tb115d, tb116, tb116d, tb117,
      tb117d, tb118, tb118d, tb119, tb119d, tb11d, tb12, tb120, tb120d, tb121, tb121d, tb122,
      tb122d, tb123, tb123d, tb124, tb124d, tb125, tb125d, tb126, tb126d, tb127, tb127d, tb128,
      tb128d, tb129, tb129d, tb12d, tb13, tb130, tb130d, tb131, tb131d, tb132, tb132d, tb133,
      tb133d, tb134, tb134d, tb135, tb135d, tb136, tb136d, tb137, tb137d, tb138, tb138d, tb139,
      tb139d, tb13d, tb14, tb140, tb140d, tb141, tb141d, tb142, tb142d, tb143, tb143d, tb144,
      tb144d, tb145, tb145d, tb146, tb146d, tb147, tb147d, tb148, tb148d, tb149, tb149d, tb14d,
      tb15, tb150, tb150d, tb151, tb151d, tb152, tb152d, tb153, tb153d, tb154, tb154d, tb155,
      tb155d, tb156, tb156d, tb157, tb157d, tb158, tb158d, tb159, tb159d, tb15d, tb16, tb160,
      tb160d, tb161, tb161d, tb162, tb162d, tb163, tb163d, tb164, tb164d, tb165, tb165d, tb166,
      tb166d, tb167, tb167d, tb168, tb168d, tb169, tb169d, tb16d, tb17, tb170, tb170d, tb171,
      tb171d, tb172, tb172d, tb173, tb173d, tb174, tb174d, tb175, tb175d, tb176, tb176d, tb177,
      tb177d, tb178, tb178d, tb179, tb179d, tb17d, tb18, tb180, tb180d, tb181, tb181d, tb182,
      tb182d, tb183, tb183d, tb184, tb184d, tb185, tb185d, tb186, tb186d, tb187, tb187d, tb188,
      tb188d, tb189, tb189d, tb18d, tb19, tb190, tb190d, tb191, tb191d, tb192, tb192d, tb193,
      tb193d, tb194, tb194d, tb195, tb195d, tb196, tb196d, tb197, tb197d, tb198, tb198d, tb199,
      tb199d, tb19d, tb2, tb20, tb200, tb200d, tb201, tb201d, tb202, tb202d, tb203, tb203d, tb204,
      tb204d, tb205, tb205d, tb206, tb206d, tb207, tb207d, tb208, tb208d, tb209, tb209d, tb20d,
      tb21, tb210, tb210d, tb211, tb211d, tb212, tb212d, tb213, tb213d, tb214, tb214d, tb215,
      tb215d, tb216, tb216d, tb217, tb217d, tb218, tb218d, tb219, tb219d, tb21d, tb22, tb220,
      tb220d, tb221, tb221d, tb222, tb222d, tb223, tb223d, tb224, tb224d, tb225, tb225d, tb226,
      tb226d, tb227, tb227d, tb228, tb228d, tb229, tb229d, tb22d, tb23, tb230, tb230d, tb231,
      tb231d, tb232, tb232d, tb233, tb233d, tb234, tb234d, tb235, tb235d, tb236, tb236d, tb237,
      tb237d, tb238, tb238d, tb239, tb239d, tb23d, tb24, tb240, tb240d, tb241, tb241d, tb242,
      tb242d, tb243, tb243d, tb244, tb244d, tb245, tb245d, tb246, tb246d, tb247, tb247d, tb248,
      tb248d, tb249, tb249d, tb24d, tb25, tb250, tb250d, tb251, tb251d, tb252, tb252d, tb253,
      tb253d, tb254, tb254d, tb255, tb255d, tb256, tb256d, tb257, tb257d, tb258, tb258d, tb259,
      tb259d, tb25d, tb26, tb260, tb260d, tb261, tb261d, tb262, tb262d, tb263, tb263d, tb264,
      tb264d, tb265, tb265d, tb266, tb266d, tb267, tb267d, tb268, tb268d, tb26d, tb27, tb27d, tb28,
      tb28d, tb29, tb29d, tb2d, tb3, tb30, tb30d, tb31, tb31d, tb32, tb32d, tb33, tb33d, tb34,
      tb34d, tb35, tb35d, tb36, tb36d, tb37, tb37d, tb38, tb38d, tb39, tb39d, tb3d, tb4, tb40,
      tb40d, tb41, tb41d, tb42, tb42d, tb43, tb43d, tb44, tb44d, tb45, tb45d, tb46, tb46d, tb47,
      tb47d, tb48, tb48d, tb49, tb49d, tb4d, tb5, tb50, tb50d, tb51, tb51d, tb52, tb52d, tb53,
      tb53d, tb54, tb54d, tb55, tb55d, tb56, tb56d, tb57, tb57d, tb58, tb58d, tb59, tb59d, tb5d,
      tb6, tb60, tb60d, tb61, tb61d, tb62, tb62d, tb63, tb63d, tb64, tb64d, tb65, tb65d, tb66,
      tb66d, tb67, tb67d, tb68, tb68d, tb69, tb69d, tb6d, tb7, tb70, tb70d, tb71, tb71d, tb72,
      tb72d, tb73, tb73d, tb74, tb74d, tb75, tb75d, tb76, tb76d, tb77, tb77d, tb78, tb78d, tb79,
      tb79d, tb7d, tb8, tb80, tb80d, tb81, tb81d, tb82, tb82d, tb83, tb83d, tb84, tb84d, tb85,
      tb85d, tb86, tb86d, tb87, tb87d, tb88, tb88d, tb89, tb89d, tb8d, tb9, tb90, tb90d, tb91,
      tb91d, tb92, tb92d, tb93, tb93d, tb94, tb94d, tb95, tb95d, tb96, tb96d, tb97, tb97d, tb98,
      tb98d, tb99, tb99d, tb9d, torqueb, torquebd, x00, x00b, x00bd, x00d, x01, x01b, x01bd, x01d,
      x02, x02b, x02bd, x02d, x0_2, x0_2b, x0_2bd, x0_2d, x10, x10b, x10bd, x10d, x11, x11b, x11bd,
      x11d, x12, x12b, x12bd, x12d, x1_2, x1_2b, x1_2bd, x1_2d, x20, x20b, x20bd, x20d, x21, x21b,
      x21bd, x21d, x22, x22b, x22bd, x22d, x2_4, x2_4b, x2_4bd, x2_4d, x2_5, x2_5b, x2_5bd, x2_5d,
      x2_6, x2_6b, x2_6bd, x2_6d, x30, x30b, x30bd, x30d, x31, x31b, x31bd, x31d, x32, x32b, x32bd,
      x32d, x40, x40b, x40bd, x40d, x41, x41b, x41bd, x41d, x42, x42b, x42bd, x42d, x50, x50b,
      x50bd, x50d, x51, x51b, x51bd, x51d, x52, x52b, x52bd, x52d, y00, y00b, y00bd, y00d, y01,
      y01b, y01bd, y01d, y02, y02b, y02bd, y02d, y0_2, y0_2b, y0_2bd, y0_2d, y10, y10b, y10bd, y10d,
      y11, y11b, y11bd, y11d, y12, y12b, y12bd, y12d, y1_2, y1_2b, y1_2bd, y1_2d, y20, y20b, y20bd,
      y20d, y21, y21b, y21bd, y21d, y22, y22b, y22bd, y22d, y2_2, y2_2b, y2_2bd, y2_2d, y30, y30b,
      y30bd, y30d, y31, y31b, y31bd, y31d, y32, y32b, y32bd, y32d, y40, y40b, y40bd, y40d, y41,
      y41b, y41bd, y41d, y42, y42b, y42bd, y42d, y50, y50b, y50bd, y50d, y51, y51b, y51bd, y51d,
      y52, y52b, y52bd, y52d, z0b, z0bd;
  double P[2], Pb[2], Pbd[2], Pd[2];

  (void)tau;
  (void)taud;
  (void)power;
  for (i = t->nspeed - 1; i >= 0; --i) {
    if (t->speedfun[i] >= 0) {
      factor = fun[t->speedfun[i]][0];
      factord = fund[t->speedfun[i]][0];
    } else {
      factor = 1.0;
      factord = 0.0;
    }
    rv_i0 = rv[t->speedpoint[i]][0];
    rv_i0d = rvd[t->speedpoint[i]][0];
    rv_i1 = rv[t->speedpoint[i]][1];
    rv_i1d = rvd[t->speedpoint[i]][1];
    rv_i2 = rv[t->speedpoint[i]][2];
    rv_i2d = rvd[t->speedpoint[i]][2];
    p2 = p[t->speedadr[i] + MAGGI_SPEED_LOW];
    p2d = pd[t->speedadr[i] + MAGGI_SPEED_LOW];
    speed2 = speed[i][2];
    speed2d = speedd[i][2];
    e16 = speed[i][0];
    e16d = speedd[i][0];
    gain = p[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    gaind = pd[t->speedadr[i] + MAGGI_SPEED_GAIN] * p[t->speedadr[i] + MAGGI_SPEED_TORQUE] +
        p[t->speedadr[i] + MAGGI_SPEED_GAIN] * pd[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    torqueb = 0.0;
    torquebd = 0.0;
    for (k19 = t->speedqadr[i] + t->speedqnum[i] - 1; k19 >= t->speedqadr[i]; --k19) {
      torqueb += taub[t->speedq[k19]];
      torquebd += taubd[t->speedq[k19]];
    }
    if (t->speedheld[i]) {
      torqueb = 0.0;
      torquebd = 0.0;
    } else {
      speedb[i][1] += torqueb;
      speedbd[i][1] += torquebd;
      torqueb = 0.0;
      torquebd = 0.0;
    }
    speed2b = speedb[i][2];
    speed2bd = speedbd[i][2];
    speedb[i][2] = 0.0;
    speedbd[i][2] = 0.0;
    e16b = 0.0;
    e16bd = 0.0;
    gainb = 0.0;
    gainbd = 0.0;
    if (t->speedlinear[i]) {
      tb266 = speedb[i][1];
      tb266d = speedbd[i][1];
      speedb[i][1] = 0.0;
      speedbd[i][1] = 0.0;
      gainb += tb266 * e16;
      gainbd += tb266d * e16 + tb266 * e16d;
      e16b += tb266 * gain;
      e16bd += tb266d * gain + tb266 * gaind;
    } else {
      t87 = fabs(e16);
      t87d = (MAGGI_RE(e16) < 0.0 ? -1.0 : 1.0) * e16d;
      tb267 = speedb[i][1];
      tb267d = speedbd[i][1];
      speedb[i][1] = 0.0;
      speedbd[i][1] = 0.0;
      tb268 = tb267 * t87;
      tb268d = tb267d * t87 + tb267 * t87d;
      gainb += tb268 * e16;
      gainbd += tb268d * e16 + tb268 * e16d;
      e16b += tb268 * gain;
      e16bd += tb268d * gain + tb268 * gaind;
      t87b = tb267 * (gain * e16);
      t87bd = tb267d * (gain * e16) + tb267 * (gaind * e16 + gain * e16d);
      e16b += t87b * (MAGGI_RE(e16) < 0.0 ? -1.0 : 1.0);
      e16bd += t87bd * (MAGGI_RE(e16) < 0.0 ? -1.0 : 1.0);
    }
    e16b += speedb[i][0];
    e16bd += speedbd[i][0];
    speedb[i][0] = 0.0;
    speedbd[i][0] = 0.0;
    pb[t->speedadr[i] + MAGGI_SPEED_GAIN] += gainb * p[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    pbd[t->speedadr[i] + MAGGI_SPEED_GAIN] += gainbd * p[t->speedadr[i] + MAGGI_SPEED_TORQUE] +
        gainb * pd[t->speedadr[i] + MAGGI_SPEED_TORQUE];
    pb[t->speedadr[i] + MAGGI_SPEED_TORQUE] += gainb * p[t->speedadr[i] + MAGGI_SPEED_GAIN];
    pbd[t->speedadr[i] + MAGGI_SPEED_TORQUE] += gainbd * p[t->speedadr[i] + MAGGI_SPEED_GAIN] +
        gainb * pd[t->speedadr[i] + MAGGI_SPEED_GAIN];
    targetb = e16b;
    targetbd = e16bd;
    speed2b -= e16b;
    speed2bd -= e16bd;
    t86b = speed2b * (1.0 / (2.0 * speed2));
    t86bd = speed2bd * (1.0 / (2.0 * speed2)) - speed2b * (1.0 / (2.0 * speed2) * (2.0 * speed2d) /
        (2.0 * speed2));
    rv_i0b = t86b * rv_i0;
    /* error, torque on each coordinate, speed */
    rv_i0bd = t86bd * rv_i0 + t86b * rv_i0d;
    rv_i0b += t86b * rv_i0;
    rv_i0bd += t86bd * rv_i0 + t86b * rv_i0d;
    rv_i1b = t86b * rv_i1;
    rv_i1bd = t86bd * rv_i1 + t86b * rv_i1d;
    rv_i1b += t86b * rv_i1;
    rv_i1bd += t86bd * rv_i1 + t86b * rv_i1d;
    rv_i2b = t86b * rv_i2;
    rv_i2bd = t86bd * rv_i2 + t86b * rv_i2d;
    rv_i2b += t86b * rv_i2;
    rv_i2bd += t86bd * rv_i2 + t86b * rv_i2d;
    p2b = t86b * p2;
    p2bd = t86bd * p2 + t86b * p2d;
    p2b += t86b * p2;
    p2bd += t86bd * p2 + t86b * p2d;
    pb[t->speedadr[i] + MAGGI_SPEED_LOW] += p2b;
    pbd[t->speedadr[i] + MAGGI_SPEED_LOW] += p2bd;
    rvb[t->speedpoint[i]][2] += rv_i2b;
    rvbd[t->speedpoint[i]][2] += rv_i2bd;
    rvb[t->speedpoint[i]][1] += rv_i1b;
    rvbd[t->speedpoint[i]][1] += rv_i1bd;
    rvb[t->speedpoint[i]][0] += rv_i0b;
    rvbd[t->speedpoint[i]][0] += rv_i0bd;
    factorb = 0.0;
    factorbd = 0.0;
    if (t->speeddriver[i] >= 0) {
      driverb[t->speeddriver[i]][3] += targetb * factor;
      driverbd[t->speeddriver[i]][3] += targetbd * factor + targetb * factord;
      factorb += targetb * driver[t->speeddriver[i]][3];
      factorbd += targetbd * driver[t->speeddriver[i]][3] + targetb * driverd[t->speeddriver[i]][3];
      targetb = 0.0;
      targetbd = 0.0;
    } else {
      pb[t->speedadr[i]] += targetb * factor;
      pbd[t->speedadr[i]] += targetbd * factor + targetb * factord;
      factorb += targetb * p[t->speedadr[i]];
      factorbd += targetbd * p[t->speedadr[i]] + targetb * pd[t->speedadr[i]];
      targetb = 0.0;
      targetbd = 0.0;
    }
    if (t->speedfun[i] >= 0) {
      funb[t->speedfun[i]][0] += factorb;
      funbd[t->speedfun[i]][0] += factorbd;
      factorb = 0.0;
      factorbd = 0.0;
    } else {
      factorb = 0.0;
      factorbd = 0.0;
    }
  }
  for (i = t->ndriver - 1; i >= 0; --i) {
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
    k3 = path_nearest_nodiff(t->np, p, t->driverpath[i], t->drivern[i], P);
    dx = p[t->driverpath[i] + k3 + 1] - p[t->driverpath[i] + k3];
    dxd = pd[t->driverpath[i] + k3 + 1] - pd[t->driverpath[i] + k3];
    dy = p[t->driverpath[i] + t->drivern[i] + k3 + 1] - p[t->driverpath[i] + t->drivern[i] + k3];
    dyd = pd[t->driverpath[i] + t->drivern[i] + k3 + 1] - pd[t->driverpath[i] + t->drivern[i] + k3];
    t2 = dx * dx + dy * dy;
    t2d = dxd * dx + dx * dxd + (dyd * dy + dy * dyd);
    t3 = ((P[0] - p[t->driverpath[i] + k3]) * dx + (P[1] - p[t->driverpath[i] + t->drivern[i] + k3])
        * dy) / t2;
    t3d = ((Pd[0] - pd[t->driverpath[i] + k3]) * dx + (P[0] - p[t->driverpath[i] + k3]) * dxd +
        ((Pd[1] - pd[t->driverpath[i] + t->drivern[i] + k3]) * dy + (P[1] - p[t->driverpath[i] +
        t->drivern[i] + k3]) * dyd) - t3 * t2d) * (1.0 / t2);
    s0 = path0[t->driverrow[i] + k3][MAGGI_PATH_S] + t3 * (path0[t->driverrow[i] + k3 +
        1][MAGGI_PATH_S] - path0[t->driverrow[i] + k3][MAGGI_PATH_S]);
    s0d = path0d[t->driverrow[i] + k3][MAGGI_PATH_S] + (t3d * (path0[t->driverrow[i] + k3 +
        1][MAGGI_PATH_S] - path0[t->driverrow[i] + k3][MAGGI_PATH_S]) + t3 * (path0d[t->driverrow[i]
        + k3 + 1][MAGGI_PATH_S] - path0d[t->driverrow[i] + k3][MAGGI_PATH_S]));
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
    ed = (pd[t->driverpath[i] + k4 + 1] - pd[t->driverpath[i] + k4] - e * hd) * (1.0 / h);
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
      t5d = (((m0d * a2 + m0 * a2d) * a2 + m0 * a2 * a2d) * a2 + m0 * a2 * a2 * a2d + (((m1d * c +
          m1 * cd) * c + m1 * c * cd) * c + m1 * c * c * cd) - t5 * t4d) * (1.0 / t4);
      x00 = t5 + p[t->driverpath[i] + k4] - m0 * h * h / 6.0 + slope22_2 * c;
      x00d = t5d + pd[t->driverpath[i] + k4] - ((m0d * h + m0 * hd) * h + m0 * h * hd) / 6.0 +
          (slope22_2d * c + slope22_2 * cd);
      t6 = 2.0 * h;
      t6d = 2.0 * hd;
      t7 = (m1 * c * c - m0 * a2 * a2) / t6;
      t7d = ((m1d * c + m1 * cd) * c + m1 * c * cd - ((m0d * a2 + m0 * a2d) * a2 + m0 * a2 * a2d) -
          t7 * t6d) * (1.0 / t6);
      x01 = t7 + slope22_2;
      x01d = t7d + slope22_2d;
      t8 = (m0 * a2 + m1 * c) / h;
      t8d = (m0d * a2 + m0 * a2d + (m1d * c + m1 * cd) - t8 * hd) * (1.0 / h);
      x02 = t8;
      x02d = t8d;
    }
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
    e2d = (pd[t->driverpath[i] + t->drivern[i] + k5 + 1] - pd[t->driverpath[i] + t->drivern[i] + k5]
        - e2 * h2d) * (1.0 / h2);
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
      t10d = (((m0_2d * a3 + m0_2 * a3d) * a3 + m0_2 * a3 * a3d) * a3 + m0_2 * a3 * a3 * a3d +
          (((m1_2d * c2 + m1_2 * c2d) * c2 + m1_2 * c2 * c2d) * c2 + m1_2 * c2 * c2 * c2d) - t10 *
          t9d) * (1.0 / t9);
      y00 = t10 + p[t->driverpath[i] + t->drivern[i] + k5] - m0_2 * h2 * h2 / 6.0 + slope2_3 * c2;
      y00d = t10d + pd[t->driverpath[i] + t->drivern[i] + k5] - ((m0_2d * h2 + m0_2 * h2d) * h2 +
          m0_2 * h2 * h2d) / 6.0 + (slope2_3d * c2 + slope2_3 * c2d);
      t11 = 2.0 * h2;
      t11d = 2.0 * h2d;
      t12 = (m1_2 * c2 * c2 - m0_2 * a3 * a3) / t11;
      t12d = ((m1_2d * c2 + m1_2 * c2d) * c2 + m1_2 * c2 * c2d - ((m0_2d * a3 + m0_2 * a3d) * a3 +
          m0_2 * a3 * a3d) - t12 * t11d) * (1.0 / t11);
      y01 = t12 + slope2_3;
      y01d = t12d + slope2_3d;
      t13 = (m0_2 * a3 + m1_2 * c2) / h2;
      t13d = (m0_2d * a3 + m0_2 * a3d + (m1_2d * c2 + m1_2 * c2d) - t13 * h2d) * (1.0 / h2);
      y02 = t13;
      y02d = t13d;
    }
    g = (x00 - P[0]) * x01 + (y00 - P[1]) * y01;
    gd = (x00d - Pd[0]) * x01 + (x00 - P[0]) * x01d + ((y00d - Pd[1]) * y01 + (y00 - P[1]) * y01d);
    slope3 = x01 * x01 + y01 * y01 + (x00 - P[0]) * x02 + (y00 - P[1]) * y02;
    slope3d = x01d * x01 + x01 * x01d + (y01d * y01 + y01 * y01d) + ((x00d - Pd[0]) * x02 + (x00 -
        P[0]) * x02d) + ((y00d - Pd[1]) * y02 + (y00 - P[1]) * y02d);
    t14 = g / slope3;
    t14d = (gd - t14 * slope3d) * (1.0 / slope3);
    s1 = s0 - t14;
    s1d = s0d - t14d;
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
    e3d = (pd[t->driverpath[i] + k6 + 1] - pd[t->driverpath[i] + k6] - e3 * h3d) * (1.0 / h3);
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
      t16d = (((m0_3d * a4 + m0_3 * a4d) * a4 + m0_3 * a4 * a4d) * a4 + m0_3 * a4 * a4 * a4d +
          (((m1_3d * c3 + m1_3 * c3d) * c3 + m1_3 * c3 * c3d) * c3 + m1_3 * c3 * c3 * c3d) - t16 *
          t15d) * (1.0 / t15);
      x10 = t16 + p[t->driverpath[i] + k6] - m0_3 * h3 * h3 / 6.0 + slope4_3 * c3;
      x10d = t16d + pd[t->driverpath[i] + k6] - ((m0_3d * h3 + m0_3 * h3d) * h3 + m0_3 * h3 * h3d) /
          6.0 + (slope4_3d * c3 + slope4_3 * c3d);
      t17 = 2.0 * h3;
      t17d = 2.0 * h3d;
      t18 = (m1_3 * c3 * c3 - m0_3 * a4 * a4) / t17;
      t18d = ((m1_3d * c3 + m1_3 * c3d) * c3 + m1_3 * c3 * c3d - ((m0_3d * a4 + m0_3 * a4d) * a4 +
          m0_3 * a4 * a4d) - t18 * t17d) * (1.0 / t17);
      x11 = t18 + slope4_3;
      x11d = t18d + slope4_3d;
      t19 = (m0_3 * a4 + m1_3 * c3) / h3;
      t19d = (m0_3d * a4 + m0_3 * a4d + (m1_3d * c3 + m1_3 * c3d) - t19 * h3d) * (1.0 / h3);
      x12 = t19;
      x12d = t19d;
    }
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
    e4d = (pd[t->driverpath[i] + t->drivern[i] + k7 + 1] - pd[t->driverpath[i] + t->drivern[i] + k7]
        - e4 * h4d) * (1.0 / h4);
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
      t21d = (((m0_4d * a5 + m0_4 * a5d) * a5 + m0_4 * a5 * a5d) * a5 + m0_4 * a5 * a5 * a5d +
          (((m1_4d * c4 + m1_4 * c4d) * c4 + m1_4 * c4 * c4d) * c4 + m1_4 * c4 * c4 * c4d) - t21 *
          t20d) * (1.0 / t20);
      y10 = t21 + p[t->driverpath[i] + t->drivern[i] + k7] - m0_4 * h4 * h4 / 6.0 + slope5_3 * c4;
      y10d = t21d + pd[t->driverpath[i] + t->drivern[i] + k7] - ((m0_4d * h4 + m0_4 * h4d) * h4 +
          m0_4 * h4 * h4d) / 6.0 + (slope5_3d * c4 + slope5_3 * c4d);
      t22 = 2.0 * h4;
      t22d = 2.0 * h4d;
      t23 = (m1_4 * c4 * c4 - m0_4 * a5 * a5) / t22;
      t23d = ((m1_4d * c4 + m1_4 * c4d) * c4 + m1_4 * c4 * c4d - ((m0_4d * a5 + m0_4 * a5d) * a5 +
          m0_4 * a5 * a5d) - t23 * t22d) * (1.0 / t22);
      y11 = t23 + slope5_3;
      y11d = t23d + slope5_3d;
      t24 = (m0_4 * a5 + m1_4 * c4) / h4;
      t24d = (m0_4d * a5 + m0_4 * a5d + (m1_4d * c4 + m1_4 * c4d) - t24 * h4d) * (1.0 / h4);
      y12 = t24;
      y12d = t24d;
    }
    g2 = (x10 - P[0]) * x11 + (y10 - P[1]) * y11;
    g2d = (x10d - Pd[0]) * x11 + (x10 - P[0]) * x11d + ((y10d - Pd[1]) * y11 + (y10 - P[1]) * y11d);
    slope6 = x11 * x11 + y11 * y11 + (x10 - P[0]) * x12 + (y10 - P[1]) * y12;
    slope6d = x11d * x11 + x11 * x11d + (y11d * y11 + y11 * y11d) + ((x10d - Pd[0]) * x12 + (x10 -
        P[0]) * x12d) + ((y10d - Pd[1]) * y12 + (y10 - P[1]) * y12d);
    t25 = g2 / slope6;
    t25d = (g2d - t25 * slope6d) * (1.0 / slope6);
    s2 = s1 - t25;
    s2d = s1d - t25d;
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
    e5d = (pd[t->driverpath[i] + k8 + 1] - pd[t->driverpath[i] + k8] - e5 * h5d) * (1.0 / h5);
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
      t27d = (((m0_5d * a6 + m0_5 * a6d) * a6 + m0_5 * a6 * a6d) * a6 + m0_5 * a6 * a6 * a6d +
          (((m1_5d * c5 + m1_5 * c5d) * c5 + m1_5 * c5 * c5d) * c5 + m1_5 * c5 * c5 * c5d) - t27 *
          t26d) * (1.0 / t26);
      x2_4 = t27 + p[t->driverpath[i] + k8] - m0_5 * h5 * h5 / 6.0 + slope7_3 * c5;
      x2_4d = t27d + pd[t->driverpath[i] + k8] - ((m0_5d * h5 + m0_5 * h5d) * h5 + m0_5 * h5 * h5d)
          / 6.0 + (slope7_3d * c5 + slope7_3 * c5d);
      t28 = 2.0 * h5;
      t28d = 2.0 * h5d;
      t29 = (m1_5 * c5 * c5 - m0_5 * a6 * a6) / t28;
      t29d = ((m1_5d * c5 + m1_5 * c5d) * c5 + m1_5 * c5 * c5d - ((m0_5d * a6 + m0_5 * a6d) * a6 +
          m0_5 * a6 * a6d) - t29 * t28d) * (1.0 / t28);
      x2_5 = t29 + slope7_3;
      x2_5d = t29d + slope7_3d;
      t30 = (m0_5 * a6 + m1_5 * c5) / h5;
      t30d = (m0_5d * a6 + m0_5 * a6d + (m1_5d * c5 + m1_5 * c5d) - t30 * h5d) * (1.0 / h5);
      x2_6 = t30;
      x2_6d = t30d;
    }
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
    e6d = (pd[t->driverpath[i] + t->drivern[i] + k9 + 1] - pd[t->driverpath[i] + t->drivern[i] + k9]
        - e6 * h6d) * (1.0 / h6);
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
      t32d = (((m0_6d * a7 + m0_6 * a7d) * a7 + m0_6 * a7 * a7d) * a7 + m0_6 * a7 * a7 * a7d +
          (((m1_6d * c6 + m1_6 * c6d) * c6 + m1_6 * c6 * c6d) * c6 + m1_6 * c6 * c6 * c6d) - t32 *
          t31d) * (1.0 / t31);
      y20 = t32 + p[t->driverpath[i] + t->drivern[i] + k9] - m0_6 * h6 * h6 / 6.0 + slope8_3 * c6;
      y20d = t32d + pd[t->driverpath[i] + t->drivern[i] + k9] - ((m0_6d * h6 + m0_6 * h6d) * h6 +
          m0_6 * h6 * h6d) / 6.0 + (slope8_3d * c6 + slope8_3 * c6d);
      t33 = 2.0 * h6;
      t33d = 2.0 * h6d;
      t34 = (m1_6 * c6 * c6 - m0_6 * a7 * a7) / t33;
      t34d = ((m1_6d * c6 + m1_6 * c6d) * c6 + m1_6 * c6 * c6d - ((m0_6d * a7 + m0_6 * a7d) * a7 +
          m0_6 * a7 * a7d) - t34 * t33d) * (1.0 / t33);
      y21 = t34 + slope8_3;
      y21d = t34d + slope8_3d;
      t35 = (m0_6 * a7 + m1_6 * c6) / h6;
      t35d = (m0_6d * a7 + m0_6 * a7d + (m1_6d * c6 + m1_6 * c6d) - t35 * h6d) * (1.0 / h6);
      y22 = t35;
      y22d = t35d;
    }
    g3 = (x2_4 - P[0]) * x2_5 + (y20 - P[1]) * y21;
    g3d = (x2_4d - Pd[0]) * x2_5 + (x2_4 - P[0]) * x2_5d + ((y20d - Pd[1]) * y21 + (y20 - P[1]) *
        y21d);
    slope9 = x2_5 * x2_5 + y21 * y21 + (x2_4 - P[0]) * x2_6 + (y20 - P[1]) * y22;
    slope9d = x2_5d * x2_5 + x2_5 * x2_5d + (y21d * y21 + y21 * y21d) + ((x2_4d - Pd[0]) * x2_6 +
        (x2_4 - P[0]) * x2_6d) + ((y20d - Pd[1]) * y22 + (y20 - P[1]) * y22d);
    t36 = g3 / slope9;
    t36d = (g3d - t36 * slope9d) * (1.0 / slope9);
    s3 = s2 - t36;
    s3d = s2d - t36d;
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
    e7d = (pd[t->driverpath[i] + k10 + 1] - pd[t->driverpath[i] + k10] - e7 * h7d) * (1.0 / h7);
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
      t38d = (((m0_7d * a8 + m0_7 * a8d) * a8 + m0_7 * a8 * a8d) * a8 + m0_7 * a8 * a8 * a8d +
          (((m1_7d * c7 + m1_7 * c7d) * c7 + m1_7 * c7 * c7d) * c7 + m1_7 * c7 * c7 * c7d) - t38 *
          t37d) * (1.0 / t37);
      x30 = t38 + p[t->driverpath[i] + k10] - m0_7 * h7 * h7 / 6.0 + slope10_3 * c7;
      x30d = t38d + pd[t->driverpath[i] + k10] - ((m0_7d * h7 + m0_7 * h7d) * h7 + m0_7 * h7 * h7d)
          / 6.0 + (slope10_3d * c7 + slope10_3 * c7d);
      t39 = 2.0 * h7;
      t39d = 2.0 * h7d;
      t40 = (m1_7 * c7 * c7 - m0_7 * a8 * a8) / t39;
      t40d = ((m1_7d * c7 + m1_7 * c7d) * c7 + m1_7 * c7 * c7d - ((m0_7d * a8 + m0_7 * a8d) * a8 +
          m0_7 * a8 * a8d) - t40 * t39d) * (1.0 / t39);
      x31 = t40 + slope10_3;
      x31d = t40d + slope10_3d;
      t41 = (m0_7 * a8 + m1_7 * c7) / h7;
      t41d = (m0_7d * a8 + m0_7 * a8d + (m1_7d * c7 + m1_7 * c7d) - t41 * h7d) * (1.0 / h7);
      x32 = t41;
      x32d = t41d;
    }
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
    e8d = (pd[t->driverpath[i] + t->drivern[i] + k11 + 1] - pd[t->driverpath[i] + t->drivern[i] +
        k11] - e8 * h8d) * (1.0 / h8);
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
      t43d = (((m0_8d * a9 + m0_8 * a9d) * a9 + m0_8 * a9 * a9d) * a9 + m0_8 * a9 * a9 * a9d +
          (((m1_8d * c8 + m1_8 * c8d) * c8 + m1_8 * c8 * c8d) * c8 + m1_8 * c8 * c8 * c8d) - t43 *
          t42d) * (1.0 / t42);
      y30 = t43 + p[t->driverpath[i] + t->drivern[i] + k11] - m0_8 * h8 * h8 / 6.0 + slope11_3 * c8;
      y30d = t43d + pd[t->driverpath[i] + t->drivern[i] + k11] - ((m0_8d * h8 + m0_8 * h8d) * h8 +
          m0_8 * h8 * h8d) / 6.0 + (slope11_3d * c8 + slope11_3 * c8d);
      t44 = 2.0 * h8;
      t44d = 2.0 * h8d;
      t45 = (m1_8 * c8 * c8 - m0_8 * a9 * a9) / t44;
      t45d = ((m1_8d * c8 + m1_8 * c8d) * c8 + m1_8 * c8 * c8d - ((m0_8d * a9 + m0_8 * a9d) * a9 +
          m0_8 * a9 * a9d) - t45 * t44d) * (1.0 / t44);
      y31 = t45 + slope11_3;
      y31d = t45d + slope11_3d;
      t46 = (m0_8 * a9 + m1_8 * c8) / h8;
      t46d = (m0_8d * a9 + m0_8 * a9d + (m1_8d * c8 + m1_8 * c8d) - t46 * h8d) * (1.0 / h8);
      y32 = t46;
      y32d = t46d;
    }
    g4 = (x30 - P[0]) * x31 + (y30 - P[1]) * y31;
    g4d = (x30d - Pd[0]) * x31 + (x30 - P[0]) * x31d + ((y30d - Pd[1]) * y31 + (y30 - P[1]) * y31d);
    slope12 = x31 * x31 + y31 * y31 + (x30 - P[0]) * x32 + (y30 - P[1]) * y32;
    slope12d = x31d * x31 + x31 * x31d + (y31d * y31 + y31 * y31d) + ((x30d - Pd[0]) * x32 + (x30 -
        P[0]) * x32d) + ((y30d - Pd[1]) * y32 + (y30 - P[1]) * y32d);
    t47 = g4 / slope12;
    t47d = (g4d - t47 * slope12d) * (1.0 / slope12);
    s4 = s3 - t47;
    s4d = s3d - t47d;
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
    e9d = (pd[t->driverpath[i] + k12 + 1] - pd[t->driverpath[i] + k12] - e9 * h9d) * (1.0 / h9);
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
      t49d = (((m0_9d * a10 + m0_9 * a10d) * a10 + m0_9 * a10 * a10d) * a10 + m0_9 * a10 * a10 *
          a10d + (((m1_9d * c9 + m1_9 * c9d) * c9 + m1_9 * c9 * c9d) * c9 + m1_9 * c9 * c9 * c9d) -
          t49 * t48d) * (1.0 / t48);
      x40 = t49 + p[t->driverpath[i] + k12] - m0_9 * h9 * h9 / 6.0 + slope13_3 * c9;
      x40d = t49d + pd[t->driverpath[i] + k12] - ((m0_9d * h9 + m0_9 * h9d) * h9 + m0_9 * h9 * h9d)
          / 6.0 + (slope13_3d * c9 + slope13_3 * c9d);
      t50 = 2.0 * h9;
      t50d = 2.0 * h9d;
      t51 = (m1_9 * c9 * c9 - m0_9 * a10 * a10) / t50;
      t51d = ((m1_9d * c9 + m1_9 * c9d) * c9 + m1_9 * c9 * c9d - ((m0_9d * a10 + m0_9 * a10d) * a10
          + m0_9 * a10 * a10d) - t51 * t50d) * (1.0 / t50);
      x41 = t51 + slope13_3;
      x41d = t51d + slope13_3d;
      t52 = (m0_9 * a10 + m1_9 * c9) / h9;
      t52d = (m0_9d * a10 + m0_9 * a10d + (m1_9d * c9 + m1_9 * c9d) - t52 * h9d) * (1.0 / h9);
      x42 = t52;
      x42d = t52d;
    }
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
    e10d = (pd[t->driverpath[i] + t->drivern[i] + k13 + 1] - pd[t->driverpath[i] + t->drivern[i] +
        k13] - e10 * h10d) * (1.0 / h10);
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
      t54d = (((m0_10d * a11 + m0_10 * a11d) * a11 + m0_10 * a11 * a11d) * a11 + m0_10 * a11 * a11 *
          a11d + (((m1_10d * c10 + m1_10 * c10d) * c10 + m1_10 * c10 * c10d) * c10 + m1_10 * c10 *
          c10 * c10d) - t54 * t53d) * (1.0 / t53);
      y40 = t54 + p[t->driverpath[i] + t->drivern[i] + k13] - m0_10 * h10 * h10 / 6.0 + slope14_3 *
          c10;
      y40d = t54d + pd[t->driverpath[i] + t->drivern[i] + k13] - ((m0_10d * h10 + m0_10 * h10d) *
          h10 + m0_10 * h10 * h10d) / 6.0 + (slope14_3d * c10 + slope14_3 * c10d);
      t55 = 2.0 * h10;
      t55d = 2.0 * h10d;
      t56 = (m1_10 * c10 * c10 - m0_10 * a11 * a11) / t55;
      t56d = ((m1_10d * c10 + m1_10 * c10d) * c10 + m1_10 * c10 * c10d - ((m0_10d * a11 + m0_10 *
          a11d) * a11 + m0_10 * a11 * a11d) - t56 * t55d) * (1.0 / t55);
      y41 = t56 + slope14_3;
      y41d = t56d + slope14_3d;
      t57 = (m0_10 * a11 + m1_10 * c10) / h10;
      t57d = (m0_10d * a11 + m0_10 * a11d + (m1_10d * c10 + m1_10 * c10d) - t57 * h10d) * (1.0 /
          h10);
      y42 = t57;
      y42d = t57d;
    }
    g5 = (x40 - P[0]) * x41 + (y40 - P[1]) * y41;
    g5d = (x40d - Pd[0]) * x41 + (x40 - P[0]) * x41d + ((y40d - Pd[1]) * y41 + (y40 - P[1]) * y41d);
    slope15 = x41 * x41 + y41 * y41 + (x40 - P[0]) * x42 + (y40 - P[1]) * y42;
    slope15d = x41d * x41 + x41 * x41d + (y41d * y41 + y41 * y41d) + ((x40d - Pd[0]) * x42 + (x40 -
        P[0]) * x42d) + ((y40d - Pd[1]) * y42 + (y40 - P[1]) * y42d);
    t58 = g5 / slope15;
    t58d = (g5d - t58 * slope15d) * (1.0 / slope15);
    s5 = s4 - t58;
    s5d = s4d - t58d;
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
    e11d = (pd[t->driverpath[i] + k14 + 1] - pd[t->driverpath[i] + k14] - e11 * h11d) * (1.0 / h11);
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
      t60d = (((m0_11d * a12 + m0_11 * a12d) * a12 + m0_11 * a12 * a12d) * a12 + m0_11 * a12 * a12 *
          a12d + (((m1_11d * c11 + m1_11 * c11d) * c11 + m1_11 * c11 * c11d) * c11 + m1_11 * c11 *
          c11 * c11d) - t60 * t59d) * (1.0 / t59);
      x50 = t60 + p[t->driverpath[i] + k14] - m0_11 * h11 * h11 / 6.0 + slope16_3 * c11;
      x50d = t60d + pd[t->driverpath[i] + k14] - ((m0_11d * h11 + m0_11 * h11d) * h11 + m0_11 * h11
          * h11d) / 6.0 + (slope16_3d * c11 + slope16_3 * c11d);
      t61 = 2.0 * h11;
      t61d = 2.0 * h11d;
      t62 = (m1_11 * c11 * c11 - m0_11 * a12 * a12) / t61;
      t62d = ((m1_11d * c11 + m1_11 * c11d) * c11 + m1_11 * c11 * c11d - ((m0_11d * a12 + m0_11 *
          a12d) * a12 + m0_11 * a12 * a12d) - t62 * t61d) * (1.0 / t61);
      x51 = t62 + slope16_3;
      x51d = t62d + slope16_3d;
      t63 = (m0_11 * a12 + m1_11 * c11) / h11;
      t63d = (m0_11d * a12 + m0_11 * a12d + (m1_11d * c11 + m1_11 * c11d) - t63 * h11d) * (1.0 /
          h11);
      x52 = t63;
      x52d = t63d;
    }
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
    e12d = (pd[t->driverpath[i] + t->drivern[i] + k15 + 1] - pd[t->driverpath[i] + t->drivern[i] +
        k15] - e12 * h12d) * (1.0 / h12);
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
      t65d = (((m0_12d * a13 + m0_12 * a13d) * a13 + m0_12 * a13 * a13d) * a13 + m0_12 * a13 * a13 *
          a13d + (((m1_12d * c12 + m1_12 * c12d) * c12 + m1_12 * c12 * c12d) * c12 + m1_12 * c12 *
          c12 * c12d) - t65 * t64d) * (1.0 / t64);
      y50 = t65 + p[t->driverpath[i] + t->drivern[i] + k15] - m0_12 * h12 * h12 / 6.0 + slope17_3 *
          c12;
      y50d = t65d + pd[t->driverpath[i] + t->drivern[i] + k15] - ((m0_12d * h12 + m0_12 * h12d) *
          h12 + m0_12 * h12 * h12d) / 6.0 + (slope17_3d * c12 + slope17_3 * c12d);
      t66 = 2.0 * h12;
      t66d = 2.0 * h12d;
      t67 = (m1_12 * c12 * c12 - m0_12 * a13 * a13) / t66;
      t67d = ((m1_12d * c12 + m1_12 * c12d) * c12 + m1_12 * c12 * c12d - ((m0_12d * a13 + m0_12 *
          a13d) * a13 + m0_12 * a13 * a13d) - t67 * t66d) * (1.0 / t66);
      y51 = t67 + slope17_3;
      y51d = t67d + slope17_3d;
      t68 = (m0_12 * a13 + m1_12 * c12) / h12;
      t68d = (m0_12d * a13 + m0_12 * a13d + (m1_12d * c12 + m1_12 * c12d) - t68 * h12d) * (1.0 /
          h12);
      y52 = t68;
      y52d = t68d;
    }
    g6 = (x50 - P[0]) * x51 + (y50 - P[1]) * y51;
    g6d = (x50d - Pd[0]) * x51 + (x50 - P[0]) * x51d + ((y50d - Pd[1]) * y51 + (y50 - P[1]) * y51d);
    slope18 = x51 * x51 + y51 * y51 + (x50 - P[0]) * x52 + (y50 - P[1]) * y52;
    slope18d = x51d * x51 + x51 * x51d + (y51d * y51 + y51 * y51d) + ((x50d - Pd[0]) * x52 + (x50 -
        P[0]) * x52d) + ((y50d - Pd[1]) * y52 + (y50 - P[1]) * y52d);
    t69 = g6 / slope18;
    t69d = (g6d - t69 * slope18d) * (1.0 / slope18);
    s6 = s5 - t69;
    s6d = s5d - t69d;
    s = s6;
    sd = s6d;
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
    e13d = (pd[t->driverpath[i] + k16 + 1] - pd[t->driverpath[i] + k16] - e13 * h13d) * (1.0 / h13);
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
      t71d = (((m0_13d * a14 + m0_13 * a14d) * a14 + m0_13 * a14 * a14d) * a14 + m0_13 * a14 * a14 *
          a14d + (((m1_13d * c13 + m1_13 * c13d) * c13 + m1_13 * c13 * c13d) * c13 + m1_13 * c13 *
          c13 * c13d) - t71 * t70d) * (1.0 / t70);
      x20 = t71 + p[t->driverpath[i] + k16] - m0_13 * h13 * h13 / 6.0 + slope19_3 * c13;
      x20d = t71d + pd[t->driverpath[i] + k16] - ((m0_13d * h13 + m0_13 * h13d) * h13 + m0_13 * h13
          * h13d) / 6.0 + (slope19_3d * c13 + slope19_3 * c13d);
      t72 = 2.0 * h13;
      t72d = 2.0 * h13d;
      t73 = (m1_13 * c13 * c13 - m0_13 * a14 * a14) / t72;
      t73d = ((m1_13d * c13 + m1_13 * c13d) * c13 + m1_13 * c13 * c13d - ((m0_13d * a14 + m0_13 *
          a14d) * a14 + m0_13 * a14 * a14d) - t73 * t72d) * (1.0 / t72);
      x21 = t73 + slope19_3;
      x21d = t73d + slope19_3d;
      t74 = (m0_13 * a14 + m1_13 * c13) / h13;
      t74d = (m0_13d * a14 + m0_13 * a14d + (m1_13d * c13 + m1_13 * c13d) - t74 * h13d) * (1.0 /
          h13);
      x22 = t74;
      x22d = t74d;
    }
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
    e14d = (pd[t->driverpath[i] + t->drivern[i] + k17 + 1] - pd[t->driverpath[i] + t->drivern[i] +
        k17] - e14 * h14d) * (1.0 / h14);
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
      t76d = (((m0_14d * a15 + m0_14 * a15d) * a15 + m0_14 * a15 * a15d) * a15 + m0_14 * a15 * a15 *
          a15d + (((m1_14d * c14 + m1_14 * c14d) * c14 + m1_14 * c14 * c14d) * c14 + m1_14 * c14 *
          c14 * c14d) - t76 * t75d) * (1.0 / t75);
      y0_2 = t76 + p[t->driverpath[i] + t->drivern[i] + k17] - m0_14 * h14 * h14 / 6.0 + slope20_3 *
          c14;
      y0_2d = t76d + pd[t->driverpath[i] + t->drivern[i] + k17] - ((m0_14d * h14 + m0_14 * h14d) *
          h14 + m0_14 * h14 * h14d) / 6.0 + (slope20_3d * c14 + slope20_3 * c14d);
      t77 = 2.0 * h14;
      t77d = 2.0 * h14d;
      t78 = (m1_14 * c14 * c14 - m0_14 * a15 * a15) / t77;
      t78d = ((m1_14d * c14 + m1_14 * c14d) * c14 + m1_14 * c14 * c14d - ((m0_14d * a15 + m0_14 *
          a15d) * a15 + m0_14 * a15 * a15d) - t78 * t77d) * (1.0 / t77);
      y1_2 = t78 + slope20_3;
      y1_2d = t78d + slope20_3d;
      t79 = (m0_14 * a15 + m1_14 * c14) / h14;
      t79d = (m0_14d * a15 + m0_14 * a15d + (m1_14d * c14 + m1_14 * c14d) - t79 * h14d) * (1.0 /
          h14);
      y2_2 = t79;
      y2_2d = t79d;
    }
    t80 = x21 * x21 + y1_2 * y1_2;
    t80d = x21d * x21 + x21 * x21d + (y1_2d * y1_2 + y1_2 * y1_2d);
    length = sqrt(t80);
    lengthd = 1.0 / (2.0 * length) * t80d;
    error = driver[i][0];
    errord = driverd[i][0];
    t81 = length * length * length;
    t81d = (lengthd * length + length * lengthd) * length + length * length * lengthd;
    curvature = (x21 * y2_2 - y1_2 * x22) / t81;
    curvatured = (x21d * y2_2 + x21 * y2_2d - (y1_2d * x22 + y1_2 * x22d) - curvature * t81d) * (1.0
        / t81);
    limit = p[t->driveradr[i] + MAGGI_DRIVER_LIMIT];
    limitd = pd[t->driveradr[i] + MAGGI_DRIVER_LIMIT];
    t82 = (p[t->driveradr[i] + MAGGI_DRIVER_GAIN] * error + p[t->driveradr[i] +
        MAGGI_DRIVER_FEEDFORWARD] * curvature) / limit;
    t82d = (pd[t->driveradr[i] + MAGGI_DRIVER_GAIN] * error + p[t->driveradr[i] + MAGGI_DRIVER_GAIN]
        * errord + (pd[t->driveradr[i] + MAGGI_DRIVER_FEEDFORWARD] * curvature + p[t->driveradr[i] +
        MAGGI_DRIVER_FEEDFORWARD] * curvatured) - t82 * limitd) * (1.0 / limit);
    t83 = tanh(t82);
    t83d = (1.0 - t83 * t83) * t82d;
    demand = driver[i][2];
    demandd = driverd[i][2];
    steer0b = 0.0;
    steer0bd = 0.0;
    if (t->driverheld[i] == 0) {
      steer0b += taub[k];
      steer0bd += taubd[k];
    }
    sb = 0.0;
    sbd = 0.0;
    if (t->driverspeeds[i]) {
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
      e15d = (pd[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] - pd[t->driverpath[i] + 2 *
          t->drivern[i] + k18] - e15 * h15d) * (1.0 / h15);
      z0b = driverb[i][3];
      z0bd = driverbd[i][3];
      driverb[i][3] = 0.0;
      driverbd[i][3] = 0.0;
      a16b = 0.0;
      a16bd = 0.0;
      c15b = 0.0;
      c15bd = 0.0;
      e15b = 0.0;
      e15bd = 0.0;
      h15b = 0.0;
      h15bd = 0.0;
      m0_15b = 0.0;
      m0_15bd = 0.0;
      m1_15b = 0.0;
      m1_15bd = 0.0;
      if (MAGGI_RE(c15) < 0.0) {
        slope21 = e15 - h15 / 6.0 * (2.0 * m0_15 + m1_15);
        slope21d = e15d - (h15d / 6.0 * (2.0 * m0_15 + m1_15) + h15 / 6.0 * (2.0 * m0_15d +
            m1_15d));
        pb[t->driverpath[i] + 2 * t->drivern[i] + k18] += z0b;
        pbd[t->driverpath[i] + 2 * t->drivern[i] + k18] += z0bd;
        slope21b = z0b * c15;
        slope21bd = z0bd * c15 + z0b * c15d;
        c15b += z0b * slope21;
        c15bd += z0bd * slope21 + z0b * slope21d;
        z0b = 0.0;
        z0bd = 0.0;
        e15b += slope21b;
        e15bd += slope21bd;
        h15b -= slope21b * (2.0 * m0_15 + m1_15) / 6.0;
        h15bd -= (slope21bd * (2.0 * m0_15 + m1_15) + slope21b * (2.0 * m0_15d + m1_15d)) / 6.0;
        tb256 = slope21b * (h15 / 6.0);
        tb256d = slope21bd * (h15 / 6.0) + slope21b * (h15d / 6.0);
        m0_15b -= tb256 * 2.0;
        m0_15bd -= tb256d * 2.0;
        m1_15b -= tb256;
        m1_15bd -= tb256d;
      } else if (MAGGI_RE(a16) < 0.0) {
        slope21_2 = e15 + h15 / 6.0 * (m0_15 + 2.0 * m1_15);
        slope21_2d = e15d + (h15d / 6.0 * (m0_15 + 2.0 * m1_15) + h15 / 6.0 * (m0_15d + 2.0 *
            m1_15d));
        pb[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] += z0b;
        pbd[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] += z0bd;
        slope21_2b = -(z0b * a16);
        slope21_2bd = -(z0bd * a16 + z0b * a16d);
        a16b -= z0b * slope21_2;
        a16bd -= z0bd * slope21_2 + z0b * slope21_2d;
        z0b = 0.0;
        z0bd = 0.0;
        e15b += slope21_2b;
        e15bd += slope21_2bd;
        h15b += slope21_2b * (m0_15 + 2.0 * m1_15) / 6.0;
        h15bd += (slope21_2bd * (m0_15 + 2.0 * m1_15) + slope21_2b * (m0_15d + 2.0 * m1_15d)) / 6.0;
        tb257 = slope21_2b * (h15 / 6.0);
        tb257d = slope21_2bd * (h15 / 6.0) + slope21_2b * (h15d / 6.0);
        m0_15b += tb257;
        m0_15bd += tb257d;
        m1_15b += tb257 * 2.0;
        m1_15bd += tb257d * 2.0;
      } else {
        slope21_3 = e15 - h15 / 6.0 * (m1_15 - m0_15);
        slope21_3d = e15d - (h15d / 6.0 * (m1_15 - m0_15) + h15 / 6.0 * (m1_15d - m0_15d));
        t84 = 6.0 * h15;
        t84d = 6.0 * h15d;
        t85 = (m0_15 * a16 * a16 * a16 + m1_15 * c15 * c15 * c15) / t84;
        t85d = (((m0_15d * a16 + m0_15 * a16d) * a16 + m0_15 * a16 * a16d) * a16 + m0_15 * a16 * a16
            * a16d + (((m1_15d * c15 + m1_15 * c15d) * c15 + m1_15 * c15 * c15d) * c15 + m1_15 * c15
            * c15 * c15d) - t85 * t84d) * (1.0 / t84);
        t85b = z0b;
        t85bd = z0bd;
        pb[t->driverpath[i] + 2 * t->drivern[i] + k18] += z0b;
        pbd[t->driverpath[i] + 2 * t->drivern[i] + k18] += z0bd;
        tb264 = z0b / 6.0;
        tb264d = z0bd / 6.0;
        tb265 = tb264 * h15;
        tb265d = tb264d * h15 + tb264 * h15d;
        m0_15b -= tb265 * h15;
        m0_15bd -= tb265d * h15 + tb265 * h15d;
        h15b -= tb265 * m0_15;
        h15bd -= tb265d * m0_15 + tb265 * m0_15d;
        h15b -= tb264 * (m0_15 * h15);
        h15bd -= tb264d * (m0_15 * h15) + tb264 * (m0_15d * h15 + m0_15 * h15d);
        slope21_3b = z0b * c15;
        slope21_3bd = z0bd * c15 + z0b * c15d;
        c15b += z0b * slope21_3;
        c15bd += z0bd * slope21_3 + z0b * slope21_3d;
        z0b = 0.0;
        z0bd = 0.0;
        tb259 = t85b / t84;
        tb259d = (t85bd - tb259 * t84d) * (1.0 / t84);
        tb260 = tb259 * a16;
        tb260d = tb259d * a16 + tb259 * a16d;
        tb261 = tb260 * a16;
        tb261d = tb260d * a16 + tb260 * a16d;
        m0_15b += tb261 * a16;
        m0_15bd += tb261d * a16 + tb261 * a16d;
        a16b += tb261 * m0_15;
        a16bd += tb261d * m0_15 + tb261 * m0_15d;
        a16b += tb260 * (m0_15 * a16);
        a16bd += tb260d * (m0_15 * a16) + tb260 * (m0_15d * a16 + m0_15 * a16d);
        a16b += tb259 * (m0_15 * a16 * a16);
        a16bd += tb259d * (m0_15 * a16 * a16) + tb259 * ((m0_15d * a16 + m0_15 * a16d) * a16 + m0_15
            * a16 * a16d);
        tb262 = tb259 * c15;
        tb262d = tb259d * c15 + tb259 * c15d;
        tb263 = tb262 * c15;
        tb263d = tb262d * c15 + tb262 * c15d;
        m1_15b += tb263 * c15;
        m1_15bd += tb263d * c15 + tb263 * c15d;
        c15b += tb263 * m1_15;
        c15bd += tb263d * m1_15 + tb263 * m1_15d;
        c15b += tb262 * (m1_15 * c15);
        c15bd += tb262d * (m1_15 * c15) + tb262 * (m1_15d * c15 + m1_15 * c15d);
        c15b += tb259 * (m1_15 * c15 * c15);
        c15bd += tb259d * (m1_15 * c15 * c15) + tb259 * ((m1_15d * c15 + m1_15 * c15d) * c15 + m1_15
            * c15 * c15d);
        t84b = -(tb259 * t85);
        t84bd = -(tb259d * t85 + tb259 * t85d);
        h15b += t84b * 6.0;
        h15bd += t84bd * 6.0;
        e15b += slope21_3b;
        e15bd += slope21_3bd;
        h15b -= slope21_3b * (m1_15 - m0_15) / 6.0;
        h15bd -= (slope21_3bd * (m1_15 - m0_15) + slope21_3b * (m1_15d - m0_15d)) / 6.0;
        tb258 = slope21_3b * (h15 / 6.0);
        tb258d = slope21_3bd * (h15 / 6.0) + slope21_3b * (h15d / 6.0);
        m1_15b -= tb258;
        m1_15bd -= tb258d;
        m0_15b += tb258;
        m0_15bd += tb258d;
      }
      tb255 = e15b / h15;
      tb255d = (e15bd - tb255 * h15d) * (1.0 / h15);
      pb[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] += tb255;
      pbd[t->driverpath[i] + 2 * t->drivern[i] + k18 + 1] += tb255d;
      pb[t->driverpath[i] + 2 * t->drivern[i] + k18] -= tb255;
      pbd[t->driverpath[i] + 2 * t->drivern[i] + k18] -= tb255d;
      h15b -= tb255 * e15;
      h15bd -= tb255d * e15 + tb255 * e15d;
      path0b[t->driverrow[i] + k18 + 1][MAGGI_PATH_V] += m1_15b;
      path0bd[t->driverrow[i] + k18 + 1][MAGGI_PATH_V] += m1_15bd;
      path0b[t->driverrow[i] + k18][MAGGI_PATH_V] += m0_15b;
      path0bd[t->driverrow[i] + k18][MAGGI_PATH_V] += m0_15bd;
      sb += c15b;
      sbd += c15bd;
      path0b[t->driverrow[i] + k18][MAGGI_PATH_S] -= c15b;
      path0bd[t->driverrow[i] + k18][MAGGI_PATH_S] -= c15bd;
      path0b[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] += a16b;
      path0bd[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] += a16bd;
      sb -= a16b;
      sbd -= a16bd;
      path0b[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] += h15b;
      path0bd[t->driverrow[i] + k18 + 1][MAGGI_PATH_S] += h15bd;
      path0b[t->driverrow[i] + k18][MAGGI_PATH_S] -= h15b;
      path0bd[t->driverrow[i] + k18][MAGGI_PATH_S] -= h15bd;
    } else {
      driverb[i][3] = 0.0;
      driverbd[i][3] = 0.0;
    }
    demandb = driverb[i][2];
    demandbd = driverbd[i][2];
    driverb[i][2] = 0.0;
    driverbd[i][2] = 0.0;
    sb += driverb[i][1];
    sbd += driverbd[i][1];
    driverb[i][1] = 0.0;
    driverbd[i][1] = 0.0;
    errorb = driverb[i][0];
    errorbd = driverbd[i][0];
    driverb[i][0] = 0.0;
    driverbd[i][0] = 0.0;
    pb[t->driveradr[i] + MAGGI_DRIVER_STIFFNESS] += steer0b * (demand - q[k]);
    pbd[t->driveradr[i] + MAGGI_DRIVER_STIFFNESS] += steer0bd * (demand - q[k]) + steer0b * (demandd
        - qd[k]);
    tb254 = steer0b * p[t->driveradr[i] + MAGGI_DRIVER_STIFFNESS];
    tb254d = steer0bd * p[t->driveradr[i] + MAGGI_DRIVER_STIFFNESS] + steer0b * pd[t->driveradr[i] +
        MAGGI_DRIVER_STIFFNESS];
    demandb += tb254;
    demandbd += tb254d;
    qb[k] -= tb254;
    qbd[k] -= tb254d;
    pb[t->driveradr[i] + MAGGI_DRIVER_DAMPING] -= steer0b * v[k];
    pbd[t->driveradr[i] + MAGGI_DRIVER_DAMPING] -= steer0bd * v[k] + steer0b * vd[k];
    vb[k] -= steer0b * p[t->driveradr[i] + MAGGI_DRIVER_DAMPING];
    vbd[k] -= steer0bd * p[t->driveradr[i] + MAGGI_DRIVER_DAMPING] + steer0b * pd[t->driveradr[i] +
        MAGGI_DRIVER_DAMPING];
    limitb = demandb * t83;
    limitbd = demandbd * t83 + demandb * t83d;
    t83b = demandb * limit;
    t83bd = demandbd * limit + demandb * limitd;
    t82b = t83b * (1.0 - t83 * t83);
    t82bd = t83bd * (1.0 - t83 * t83) - t83b * (t83d * t83 + t83 * t83d);
    tb253 = t82b / limit;
    tb253d = (t82bd - tb253 * limitd) * (1.0 / limit);
    pb[t->driveradr[i] + MAGGI_DRIVER_GAIN] += tb253 * error;
    pbd[t->driveradr[i] + MAGGI_DRIVER_GAIN] += tb253d * error + tb253 * errord;
    errorb += tb253 * p[t->driveradr[i] + MAGGI_DRIVER_GAIN];
    errorbd += tb253d * p[t->driveradr[i] + MAGGI_DRIVER_GAIN] + tb253 * pd[t->driveradr[i] +
        MAGGI_DRIVER_GAIN];
    pb[t->driveradr[i] + MAGGI_DRIVER_FEEDFORWARD] += tb253 * curvature;
    pbd[t->driveradr[i] + MAGGI_DRIVER_FEEDFORWARD] += tb253d * curvature + tb253 * curvatured;
    curvatureb = tb253 * p[t->driveradr[i] + MAGGI_DRIVER_FEEDFORWARD];
    curvaturebd = tb253d * p[t->driveradr[i] + MAGGI_DRIVER_FEEDFORWARD] + tb253 *
        pd[t->driveradr[i] + MAGGI_DRIVER_FEEDFORWARD];
    limitb -= tb253 * t82;
    limitbd -= tb253d * t82 + tb253 * t82d;
    pb[t->driveradr[i] + MAGGI_DRIVER_LIMIT] += limitb;
    pbd[t->driveradr[i] + MAGGI_DRIVER_LIMIT] += limitbd;
    tb252 = curvatureb / t81;
    tb252d = (curvaturebd - tb252 * t81d) * (1.0 / t81);
    x21b = tb252 * y2_2;
    x21bd = tb252d * y2_2 + tb252 * y2_2d;
    y2_2b = tb252 * x21;
    y2_2bd = tb252d * x21 + tb252 * x21d;
    y1_2b = -(tb252 * x22);
    y1_2bd = -(tb252d * x22 + tb252 * x22d);
    x22b = -(tb252 * y1_2);
    x22bd = -(tb252d * y1_2 + tb252 * y1_2d);
    t81b = -(tb252 * curvature);
    t81bd = -(tb252d * curvature + tb252 * curvatured);
    tb251 = t81b * length;
    tb251d = t81bd * length + t81b * lengthd;
    lengthb = tb251 * length;
    lengthbd = tb251d * length + tb251 * lengthd;
    lengthb += tb251 * length;
    lengthbd += tb251d * length + tb251 * lengthd;
    lengthb += t81b * (length * length);
    lengthbd += t81bd * (length * length) + t81b * (lengthd * length + length * lengthd);
    tb248 = errorb / length;
    tb248d = (errorbd - tb248 * lengthd) * (1.0 / length);
    tb249 = tb248 * x21;
    tb249d = tb248d * x21 + tb248 * x21d;
    y0_2b = tb249;
    y0_2bd = tb249d;
    for (k20 = 0; k20 < 2; ++k20) {
      Pb[k20] = 0.0;
      Pbd[k20] = 0.0;
    }
    Pb[1] -= tb249;
    Pbd[1] -= tb249d;
    x21b += tb248 * (y0_2 - P[1]);
    x21bd += tb248d * (y0_2 - P[1]) + tb248 * (y0_2d - Pd[1]);
    tb250 = tb248 * y1_2;
    tb250d = tb248d * y1_2 + tb248 * y1_2d;
    x20b = -tb250;
    x20bd = -tb250d;
    Pb[0] += tb250;
    Pbd[0] += tb250d;
    y1_2b -= tb248 * (x20 - P[0]);
    y1_2bd -= tb248d * (x20 - P[0]) + tb248 * (x20d - Pd[0]);
    lengthb -= tb248 * error;
    lengthbd -= tb248d * error + tb248 * errord;
    t80b = lengthb * (1.0 / (2.0 * length));
    t80bd = lengthbd * (1.0 / (2.0 * length)) - lengthb * (1.0 / (2.0 * length) * (2.0 * lengthd) /
        (2.0 * length));
    x21b += t80b * x21;
    x21bd += t80bd * x21 + t80b * x21d;
    x21b += t80b * x21;
    x21bd += t80bd * x21 + t80b * x21d;
    y1_2b += t80b * y1_2;
    y1_2bd += t80bd * y1_2 + t80b * y1_2d;
    y1_2b += t80b * y1_2;
    y1_2bd += t80bd * y1_2 + t80b * y1_2d;
    a15b = 0.0;
    a15bd = 0.0;
    c14b = 0.0;
    c14bd = 0.0;
    e14b = 0.0;
    e14bd = 0.0;
    h14b = 0.0;
    h14bd = 0.0;
    m0_14b = 0.0;
    m0_14bd = 0.0;
    m1_14b = 0.0;
    m1_14bd = 0.0;
    if (MAGGI_RE(c14) < 0.0) {
      slope20 = e14 - h14 / 6.0 * (2.0 * m0_14 + m1_14);
      slope20d = e14d - (h14d / 6.0 * (2.0 * m0_14 + m1_14) + h14 / 6.0 * (2.0 * m0_14d + m1_14d));
      y2_2b = 0.0;
      y2_2bd = 0.0;
      slope20b = y1_2b;
      slope20bd = y1_2bd;
      y1_2b = 0.0;
      y1_2bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k17] += y0_2b;
      pbd[t->driverpath[i] + t->drivern[i] + k17] += y0_2bd;
      slope20b += y0_2b * c14;
      slope20bd += y0_2bd * c14 + y0_2b * c14d;
      c14b += y0_2b * slope20;
      c14bd += y0_2bd * slope20 + y0_2b * slope20d;
      y0_2b = 0.0;
      y0_2bd = 0.0;
      e14b += slope20b;
      e14bd += slope20bd;
      h14b -= slope20b * (2.0 * m0_14 + m1_14) / 6.0;
      h14bd -= (slope20bd * (2.0 * m0_14 + m1_14) + slope20b * (2.0 * m0_14d + m1_14d)) / 6.0;
      tb234 = slope20b * (h14 / 6.0);
      tb234d = slope20bd * (h14 / 6.0) + slope20b * (h14d / 6.0);
      m0_14b -= tb234 * 2.0;
      m0_14bd -= tb234d * 2.0;
      m1_14b -= tb234;
      m1_14bd -= tb234d;
    } else if (MAGGI_RE(a15) < 0.0) {
      slope20_2 = e14 + h14 / 6.0 * (m0_14 + 2.0 * m1_14);
      slope20_2d = e14d + (h14d / 6.0 * (m0_14 + 2.0 * m1_14) + h14 / 6.0 * (m0_14d + 2.0 *
          m1_14d));
      y2_2b = 0.0;
      y2_2bd = 0.0;
      slope20_2b = y1_2b;
      slope20_2bd = y1_2bd;
      y1_2b = 0.0;
      y1_2bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k17 + 1] += y0_2b;
      pbd[t->driverpath[i] + t->drivern[i] + k17 + 1] += y0_2bd;
      slope20_2b -= y0_2b * a15;
      slope20_2bd -= y0_2bd * a15 + y0_2b * a15d;
      a15b -= y0_2b * slope20_2;
      a15bd -= y0_2bd * slope20_2 + y0_2b * slope20_2d;
      y0_2b = 0.0;
      y0_2bd = 0.0;
      e14b += slope20_2b;
      e14bd += slope20_2bd;
      h14b += slope20_2b * (m0_14 + 2.0 * m1_14) / 6.0;
      h14bd += (slope20_2bd * (m0_14 + 2.0 * m1_14) + slope20_2b * (m0_14d + 2.0 * m1_14d)) / 6.0;
      tb235 = slope20_2b * (h14 / 6.0);
      tb235d = slope20_2bd * (h14 / 6.0) + slope20_2b * (h14d / 6.0);
      m0_14b += tb235;
      m0_14bd += tb235d;
      m1_14b += tb235 * 2.0;
      m1_14bd += tb235d * 2.0;
    } else {
      slope20_3 = e14 - h14 / 6.0 * (m1_14 - m0_14);
      slope20_3d = e14d - (h14d / 6.0 * (m1_14 - m0_14) + h14 / 6.0 * (m1_14d - m0_14d));
      t75 = 6.0 * h14;
      t75d = 6.0 * h14d;
      t76 = (m0_14 * a15 * a15 * a15 + m1_14 * c14 * c14 * c14) / t75;
      t76d = (((m0_14d * a15 + m0_14 * a15d) * a15 + m0_14 * a15 * a15d) * a15 + m0_14 * a15 * a15 *
          a15d + (((m1_14d * c14 + m1_14 * c14d) * c14 + m1_14 * c14 * c14d) * c14 + m1_14 * c14 *
          c14 * c14d) - t76 * t75d) * (1.0 / t75);
      t77 = 2.0 * h14;
      t77d = 2.0 * h14d;
      t78 = (m1_14 * c14 * c14 - m0_14 * a15 * a15) / t77;
      t78d = ((m1_14d * c14 + m1_14 * c14d) * c14 + m1_14 * c14 * c14d - ((m0_14d * a15 + m0_14 *
          a15d) * a15 + m0_14 * a15 * a15d) - t78 * t77d) * (1.0 / t77);
      t79 = (m0_14 * a15 + m1_14 * c14) / h14;
      t79d = (m0_14d * a15 + m0_14 * a15d + (m1_14d * c14 + m1_14 * c14d) - t79 * h14d) * (1.0 /
          h14);
      t79b = y2_2b;
      t79bd = y2_2bd;
      y2_2b = 0.0;
      y2_2bd = 0.0;
      tb247 = t79b / h14;
      tb247d = (t79bd - tb247 * h14d) * (1.0 / h14);
      m0_14b += tb247 * a15;
      m0_14bd += tb247d * a15 + tb247 * a15d;
      a15b += tb247 * m0_14;
      a15bd += tb247d * m0_14 + tb247 * m0_14d;
      m1_14b += tb247 * c14;
      m1_14bd += tb247d * c14 + tb247 * c14d;
      c14b += tb247 * m1_14;
      c14bd += tb247d * m1_14 + tb247 * m1_14d;
      h14b -= tb247 * t79;
      h14bd -= tb247d * t79 + tb247 * t79d;
      t78b = y1_2b;
      t78bd = y1_2bd;
      slope20_3b = y1_2b;
      slope20_3bd = y1_2bd;
      y1_2b = 0.0;
      y1_2bd = 0.0;
      tb244 = t78b / t77;
      tb244d = (t78bd - tb244 * t77d) * (1.0 / t77);
      tb245 = tb244 * c14;
      tb245d = tb244d * c14 + tb244 * c14d;
      m1_14b += tb245 * c14;
      m1_14bd += tb245d * c14 + tb245 * c14d;
      c14b += tb245 * m1_14;
      c14bd += tb245d * m1_14 + tb245 * m1_14d;
      c14b += tb244 * (m1_14 * c14);
      c14bd += tb244d * (m1_14 * c14) + tb244 * (m1_14d * c14 + m1_14 * c14d);
      tb246 = tb244 * a15;
      tb246d = tb244d * a15 + tb244 * a15d;
      m0_14b -= tb246 * a15;
      m0_14bd -= tb246d * a15 + tb246 * a15d;
      a15b -= tb246 * m0_14;
      a15bd -= tb246d * m0_14 + tb246 * m0_14d;
      a15b -= tb244 * (m0_14 * a15);
      a15bd -= tb244d * (m0_14 * a15) + tb244 * (m0_14d * a15 + m0_14 * a15d);
      t77b = -(tb244 * t78);
      t77bd = -(tb244d * t78 + tb244 * t78d);
      h14b += t77b * 2.0;
      h14bd += t77bd * 2.0;
      t76b = y0_2b;
      t76bd = y0_2bd;
      pb[t->driverpath[i] + t->drivern[i] + k17] += y0_2b;
      pbd[t->driverpath[i] + t->drivern[i] + k17] += y0_2bd;
      tb242 = y0_2b / 6.0;
      tb242d = y0_2bd / 6.0;
      tb243 = tb242 * h14;
      tb243d = tb242d * h14 + tb242 * h14d;
      m0_14b -= tb243 * h14;
      m0_14bd -= tb243d * h14 + tb243 * h14d;
      h14b -= tb243 * m0_14;
      h14bd -= tb243d * m0_14 + tb243 * m0_14d;
      h14b -= tb242 * (m0_14 * h14);
      h14bd -= tb242d * (m0_14 * h14) + tb242 * (m0_14d * h14 + m0_14 * h14d);
      slope20_3b += y0_2b * c14;
      slope20_3bd += y0_2bd * c14 + y0_2b * c14d;
      c14b += y0_2b * slope20_3;
      c14bd += y0_2bd * slope20_3 + y0_2b * slope20_3d;
      y0_2b = 0.0;
      y0_2bd = 0.0;
      tb237 = t76b / t75;
      tb237d = (t76bd - tb237 * t75d) * (1.0 / t75);
      tb238 = tb237 * a15;
      tb238d = tb237d * a15 + tb237 * a15d;
      tb239 = tb238 * a15;
      tb239d = tb238d * a15 + tb238 * a15d;
      m0_14b += tb239 * a15;
      m0_14bd += tb239d * a15 + tb239 * a15d;
      a15b += tb239 * m0_14;
      a15bd += tb239d * m0_14 + tb239 * m0_14d;
      a15b += tb238 * (m0_14 * a15);
      a15bd += tb238d * (m0_14 * a15) + tb238 * (m0_14d * a15 + m0_14 * a15d);
      a15b += tb237 * (m0_14 * a15 * a15);
      a15bd += tb237d * (m0_14 * a15 * a15) + tb237 * ((m0_14d * a15 + m0_14 * a15d) * a15 + m0_14 *
          a15 * a15d);
      tb240 = tb237 * c14;
      tb240d = tb237d * c14 + tb237 * c14d;
      tb241 = tb240 * c14;
      tb241d = tb240d * c14 + tb240 * c14d;
      m1_14b += tb241 * c14;
      m1_14bd += tb241d * c14 + tb241 * c14d;
      c14b += tb241 * m1_14;
      c14bd += tb241d * m1_14 + tb241 * m1_14d;
      c14b += tb240 * (m1_14 * c14);
      c14bd += tb240d * (m1_14 * c14) + tb240 * (m1_14d * c14 + m1_14 * c14d);
      c14b += tb237 * (m1_14 * c14 * c14);
      c14bd += tb237d * (m1_14 * c14 * c14) + tb237 * ((m1_14d * c14 + m1_14 * c14d) * c14 + m1_14 *
          c14 * c14d);
      t75b = -(tb237 * t76);
      t75bd = -(tb237d * t76 + tb237 * t76d);
      h14b += t75b * 6.0;
      h14bd += t75bd * 6.0;
      e14b += slope20_3b;
      e14bd += slope20_3bd;
      h14b -= slope20_3b * (m1_14 - m0_14) / 6.0;
      h14bd -= (slope20_3bd * (m1_14 - m0_14) + slope20_3b * (m1_14d - m0_14d)) / 6.0;
      tb236 = slope20_3b * (h14 / 6.0);
      tb236d = slope20_3bd * (h14 / 6.0) + slope20_3b * (h14d / 6.0);
      m1_14b -= tb236;
      m1_14bd -= tb236d;
      m0_14b += tb236;
      m0_14bd += tb236d;
    }
    tb233 = e14b / h14;
    tb233d = (e14bd - tb233 * h14d) * (1.0 / h14);
    pb[t->driverpath[i] + t->drivern[i] + k17 + 1] += tb233;
    pbd[t->driverpath[i] + t->drivern[i] + k17 + 1] += tb233d;
    pb[t->driverpath[i] + t->drivern[i] + k17] -= tb233;
    pbd[t->driverpath[i] + t->drivern[i] + k17] -= tb233d;
    h14b -= tb233 * e14;
    h14bd -= tb233d * e14 + tb233 * e14d;
    path0b[t->driverrow[i] + k17 + 1][MAGGI_PATH_Y] += m1_14b;
    path0bd[t->driverrow[i] + k17 + 1][MAGGI_PATH_Y] += m1_14bd;
    path0b[t->driverrow[i] + k17][MAGGI_PATH_Y] += m0_14b;
    path0bd[t->driverrow[i] + k17][MAGGI_PATH_Y] += m0_14bd;
    sb += c14b;
    sbd += c14bd;
    path0b[t->driverrow[i] + k17][MAGGI_PATH_S] -= c14b;
    path0bd[t->driverrow[i] + k17][MAGGI_PATH_S] -= c14bd;
    path0b[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] += a15b;
    path0bd[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] += a15bd;
    sb -= a15b;
    sbd -= a15bd;
    path0b[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] += h14b;
    path0bd[t->driverrow[i] + k17 + 1][MAGGI_PATH_S] += h14bd;
    path0b[t->driverrow[i] + k17][MAGGI_PATH_S] -= h14b;
    path0bd[t->driverrow[i] + k17][MAGGI_PATH_S] -= h14bd;
    a14b = 0.0;
    a14bd = 0.0;
    c13b = 0.0;
    c13bd = 0.0;
    e13b = 0.0;
    e13bd = 0.0;
    h13b = 0.0;
    h13bd = 0.0;
    m0_13b = 0.0;
    m0_13bd = 0.0;
    m1_13b = 0.0;
    m1_13bd = 0.0;
    if (MAGGI_RE(c13) < 0.0) {
      slope19 = e13 - h13 / 6.0 * (2.0 * m0_13 + m1_13);
      slope19d = e13d - (h13d / 6.0 * (2.0 * m0_13 + m1_13) + h13 / 6.0 * (2.0 * m0_13d + m1_13d));
      x22b = 0.0;
      x22bd = 0.0;
      slope19b = x21b;
      slope19bd = x21bd;
      x21b = 0.0;
      x21bd = 0.0;
      pb[t->driverpath[i] + k16] += x20b;
      pbd[t->driverpath[i] + k16] += x20bd;
      slope19b += x20b * c13;
      slope19bd += x20bd * c13 + x20b * c13d;
      c13b += x20b * slope19;
      c13bd += x20bd * slope19 + x20b * slope19d;
      x20b = 0.0;
      x20bd = 0.0;
      e13b += slope19b;
      e13bd += slope19bd;
      h13b -= slope19b * (2.0 * m0_13 + m1_13) / 6.0;
      h13bd -= (slope19bd * (2.0 * m0_13 + m1_13) + slope19b * (2.0 * m0_13d + m1_13d)) / 6.0;
      tb219 = slope19b * (h13 / 6.0);
      tb219d = slope19bd * (h13 / 6.0) + slope19b * (h13d / 6.0);
      m0_13b -= tb219 * 2.0;
      m0_13bd -= tb219d * 2.0;
      m1_13b -= tb219;
      m1_13bd -= tb219d;
    } else if (MAGGI_RE(a14) < 0.0) {
      slope19_2 = e13 + h13 / 6.0 * (m0_13 + 2.0 * m1_13);
      slope19_2d = e13d + (h13d / 6.0 * (m0_13 + 2.0 * m1_13) + h13 / 6.0 * (m0_13d + 2.0 *
          m1_13d));
      x22b = 0.0;
      x22bd = 0.0;
      slope19_2b = x21b;
      slope19_2bd = x21bd;
      x21b = 0.0;
      x21bd = 0.0;
      pb[t->driverpath[i] + k16 + 1] += x20b;
      pbd[t->driverpath[i] + k16 + 1] += x20bd;
      slope19_2b -= x20b * a14;
      slope19_2bd -= x20bd * a14 + x20b * a14d;
      a14b -= x20b * slope19_2;
      a14bd -= x20bd * slope19_2 + x20b * slope19_2d;
      x20b = 0.0;
      x20bd = 0.0;
      e13b += slope19_2b;
      e13bd += slope19_2bd;
      h13b += slope19_2b * (m0_13 + 2.0 * m1_13) / 6.0;
      h13bd += (slope19_2bd * (m0_13 + 2.0 * m1_13) + slope19_2b * (m0_13d + 2.0 * m1_13d)) / 6.0;
      tb220 = slope19_2b * (h13 / 6.0);
      tb220d = slope19_2bd * (h13 / 6.0) + slope19_2b * (h13d / 6.0);
      m0_13b += tb220;
      m0_13bd += tb220d;
      m1_13b += tb220 * 2.0;
      m1_13bd += tb220d * 2.0;
    } else {
      slope19_3 = e13 - h13 / 6.0 * (m1_13 - m0_13);
      slope19_3d = e13d - (h13d / 6.0 * (m1_13 - m0_13) + h13 / 6.0 * (m1_13d - m0_13d));
      t70 = 6.0 * h13;
      t70d = 6.0 * h13d;
      t71 = (m0_13 * a14 * a14 * a14 + m1_13 * c13 * c13 * c13) / t70;
      t71d = (((m0_13d * a14 + m0_13 * a14d) * a14 + m0_13 * a14 * a14d) * a14 + m0_13 * a14 * a14 *
          a14d + (((m1_13d * c13 + m1_13 * c13d) * c13 + m1_13 * c13 * c13d) * c13 + m1_13 * c13 *
          c13 * c13d) - t71 * t70d) * (1.0 / t70);
      t72 = 2.0 * h13;
      t72d = 2.0 * h13d;
      t73 = (m1_13 * c13 * c13 - m0_13 * a14 * a14) / t72;
      t73d = ((m1_13d * c13 + m1_13 * c13d) * c13 + m1_13 * c13 * c13d - ((m0_13d * a14 + m0_13 *
          a14d) * a14 + m0_13 * a14 * a14d) - t73 * t72d) * (1.0 / t72);
      t74 = (m0_13 * a14 + m1_13 * c13) / h13;
      t74d = (m0_13d * a14 + m0_13 * a14d + (m1_13d * c13 + m1_13 * c13d) - t74 * h13d) * (1.0 /
          h13);
      t74b = x22b;
      t74bd = x22bd;
      x22b = 0.0;
      x22bd = 0.0;
      tb232 = t74b / h13;
      tb232d = (t74bd - tb232 * h13d) * (1.0 / h13);
      m0_13b += tb232 * a14;
      m0_13bd += tb232d * a14 + tb232 * a14d;
      a14b += tb232 * m0_13;
      a14bd += tb232d * m0_13 + tb232 * m0_13d;
      m1_13b += tb232 * c13;
      m1_13bd += tb232d * c13 + tb232 * c13d;
      c13b += tb232 * m1_13;
      c13bd += tb232d * m1_13 + tb232 * m1_13d;
      h13b -= tb232 * t74;
      h13bd -= tb232d * t74 + tb232 * t74d;
      t73b = x21b;
      t73bd = x21bd;
      slope19_3b = x21b;
      slope19_3bd = x21bd;
      x21b = 0.0;
      x21bd = 0.0;
      tb229 = t73b / t72;
      tb229d = (t73bd - tb229 * t72d) * (1.0 / t72);
      tb230 = tb229 * c13;
      tb230d = tb229d * c13 + tb229 * c13d;
      m1_13b += tb230 * c13;
      m1_13bd += tb230d * c13 + tb230 * c13d;
      c13b += tb230 * m1_13;
      c13bd += tb230d * m1_13 + tb230 * m1_13d;
      c13b += tb229 * (m1_13 * c13);
      c13bd += tb229d * (m1_13 * c13) + tb229 * (m1_13d * c13 + m1_13 * c13d);
      tb231 = tb229 * a14;
      tb231d = tb229d * a14 + tb229 * a14d;
      m0_13b -= tb231 * a14;
      m0_13bd -= tb231d * a14 + tb231 * a14d;
      a14b -= tb231 * m0_13;
      a14bd -= tb231d * m0_13 + tb231 * m0_13d;
      a14b -= tb229 * (m0_13 * a14);
      a14bd -= tb229d * (m0_13 * a14) + tb229 * (m0_13d * a14 + m0_13 * a14d);
      t72b = -(tb229 * t73);
      t72bd = -(tb229d * t73 + tb229 * t73d);
      h13b += t72b * 2.0;
      h13bd += t72bd * 2.0;
      t71b = x20b;
      t71bd = x20bd;
      pb[t->driverpath[i] + k16] += x20b;
      pbd[t->driverpath[i] + k16] += x20bd;
      tb227 = x20b / 6.0;
      tb227d = x20bd / 6.0;
      tb228 = tb227 * h13;
      tb228d = tb227d * h13 + tb227 * h13d;
      m0_13b -= tb228 * h13;
      m0_13bd -= tb228d * h13 + tb228 * h13d;
      h13b -= tb228 * m0_13;
      h13bd -= tb228d * m0_13 + tb228 * m0_13d;
      h13b -= tb227 * (m0_13 * h13);
      h13bd -= tb227d * (m0_13 * h13) + tb227 * (m0_13d * h13 + m0_13 * h13d);
      slope19_3b += x20b * c13;
      slope19_3bd += x20bd * c13 + x20b * c13d;
      c13b += x20b * slope19_3;
      c13bd += x20bd * slope19_3 + x20b * slope19_3d;
      x20b = 0.0;
      x20bd = 0.0;
      tb222 = t71b / t70;
      tb222d = (t71bd - tb222 * t70d) * (1.0 / t70);
      tb223 = tb222 * a14;
      tb223d = tb222d * a14 + tb222 * a14d;
      tb224 = tb223 * a14;
      tb224d = tb223d * a14 + tb223 * a14d;
      m0_13b += tb224 * a14;
      m0_13bd += tb224d * a14 + tb224 * a14d;
      a14b += tb224 * m0_13;
      a14bd += tb224d * m0_13 + tb224 * m0_13d;
      a14b += tb223 * (m0_13 * a14);
      a14bd += tb223d * (m0_13 * a14) + tb223 * (m0_13d * a14 + m0_13 * a14d);
      a14b += tb222 * (m0_13 * a14 * a14);
      a14bd += tb222d * (m0_13 * a14 * a14) + tb222 * ((m0_13d * a14 + m0_13 * a14d) * a14 + m0_13 *
          a14 * a14d);
      tb225 = tb222 * c13;
      tb225d = tb222d * c13 + tb222 * c13d;
      tb226 = tb225 * c13;
      tb226d = tb225d * c13 + tb225 * c13d;
      m1_13b += tb226 * c13;
      m1_13bd += tb226d * c13 + tb226 * c13d;
      c13b += tb226 * m1_13;
      c13bd += tb226d * m1_13 + tb226 * m1_13d;
      c13b += tb225 * (m1_13 * c13);
      c13bd += tb225d * (m1_13 * c13) + tb225 * (m1_13d * c13 + m1_13 * c13d);
      c13b += tb222 * (m1_13 * c13 * c13);
      c13bd += tb222d * (m1_13 * c13 * c13) + tb222 * ((m1_13d * c13 + m1_13 * c13d) * c13 + m1_13 *
          c13 * c13d);
      t70b = -(tb222 * t71);
      t70bd = -(tb222d * t71 + tb222 * t71d);
      h13b += t70b * 6.0;
      h13bd += t70bd * 6.0;
      e13b += slope19_3b;
      e13bd += slope19_3bd;
      h13b -= slope19_3b * (m1_13 - m0_13) / 6.0;
      h13bd -= (slope19_3bd * (m1_13 - m0_13) + slope19_3b * (m1_13d - m0_13d)) / 6.0;
      tb221 = slope19_3b * (h13 / 6.0);
      tb221d = slope19_3bd * (h13 / 6.0) + slope19_3b * (h13d / 6.0);
      m1_13b -= tb221;
      m1_13bd -= tb221d;
      m0_13b += tb221;
      m0_13bd += tb221d;
    }
    tb218 = e13b / h13;
    tb218d = (e13bd - tb218 * h13d) * (1.0 / h13);
    pb[t->driverpath[i] + k16 + 1] += tb218;
    pbd[t->driverpath[i] + k16 + 1] += tb218d;
    pb[t->driverpath[i] + k16] -= tb218;
    pbd[t->driverpath[i] + k16] -= tb218d;
    h13b -= tb218 * e13;
    h13bd -= tb218d * e13 + tb218 * e13d;
    path0b[t->driverrow[i] + k16 + 1][MAGGI_PATH_X] += m1_13b;
    path0bd[t->driverrow[i] + k16 + 1][MAGGI_PATH_X] += m1_13bd;
    path0b[t->driverrow[i] + k16][MAGGI_PATH_X] += m0_13b;
    path0bd[t->driverrow[i] + k16][MAGGI_PATH_X] += m0_13bd;
    sb += c13b;
    sbd += c13bd;
    path0b[t->driverrow[i] + k16][MAGGI_PATH_S] -= c13b;
    path0bd[t->driverrow[i] + k16][MAGGI_PATH_S] -= c13bd;
    path0b[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] += a14b;
    path0bd[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] += a14bd;
    sb -= a14b;
    sbd -= a14bd;
    path0b[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] += h13b;
    path0bd[t->driverrow[i] + k16 + 1][MAGGI_PATH_S] += h13bd;
    path0b[t->driverrow[i] + k16][MAGGI_PATH_S] -= h13b;
    path0bd[t->driverrow[i] + k16][MAGGI_PATH_S] -= h13bd;
    s6b = sb;
    s6bd = sbd;
    s5b = s6b;
    s5bd = s6bd;
    t69b = -s6b;
    t69bd = -s6bd;
    tb217 = t69b / slope18;
    tb217d = (t69bd - tb217 * slope18d) * (1.0 / slope18);
    g6b = tb217;
    g6bd = tb217d;
    slope18b = -(tb217 * t69);
    slope18bd = -(tb217d * t69 + tb217 * t69d);
    x51b = slope18b * x51;
    x51bd = slope18bd * x51 + slope18b * x51d;
    x51b += slope18b * x51;
    x51bd += slope18bd * x51 + slope18b * x51d;
    y51b = slope18b * y51;
    y51bd = slope18bd * y51 + slope18b * y51d;
    y51b += slope18b * y51;
    y51bd += slope18bd * y51 + slope18b * y51d;
    tb215 = slope18b * x52;
    tb215d = slope18bd * x52 + slope18b * x52d;
    x50b = tb215;
    x50bd = tb215d;
    Pb[0] -= tb215;
    Pbd[0] -= tb215d;
    x52b = slope18b * (x50 - P[0]);
    x52bd = slope18bd * (x50 - P[0]) + slope18b * (x50d - Pd[0]);
    tb216 = slope18b * y52;
    tb216d = slope18bd * y52 + slope18b * y52d;
    y50b = tb216;
    y50bd = tb216d;
    Pb[1] -= tb216;
    Pbd[1] -= tb216d;
    y52b = slope18b * (y50 - P[1]);
    y52bd = slope18bd * (y50 - P[1]) + slope18b * (y50d - Pd[1]);
    tb213 = g6b * x51;
    /* one step of Newton's method; C, C', C'' at s */
    tb213d = g6bd * x51 + g6b * x51d;
    x50b += tb213;
    x50bd += tb213d;
    Pb[0] -= tb213;
    Pbd[0] -= tb213d;
    x51b += g6b * (x50 - P[0]);
    x51bd += g6bd * (x50 - P[0]) + g6b * (x50d - Pd[0]);
    tb214 = g6b * y51;
    tb214d = g6bd * y51 + g6b * y51d;
    y50b += tb214;
    y50bd += tb214d;
    Pb[1] -= tb214;
    Pbd[1] -= tb214d;
    y51b += g6b * (y50 - P[1]);
    y51bd += g6bd * (y50 - P[1]) + g6b * (y50d - Pd[1]);
    a13b = 0.0;
    a13bd = 0.0;
    c12b = 0.0;
    c12bd = 0.0;
    e12b = 0.0;
    e12bd = 0.0;
    h12b = 0.0;
    h12bd = 0.0;
    m0_12b = 0.0;
    m0_12bd = 0.0;
    m1_12b = 0.0;
    m1_12bd = 0.0;
    if (MAGGI_RE(c12) < 0.0) {
      slope17 = e12 - h12 / 6.0 * (2.0 * m0_12 + m1_12);
      slope17d = e12d - (h12d / 6.0 * (2.0 * m0_12 + m1_12) + h12 / 6.0 * (2.0 * m0_12d + m1_12d));
      y52b = 0.0;
      y52bd = 0.0;
      slope17b = y51b;
      slope17bd = y51bd;
      y51b = 0.0;
      y51bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k15] += y50b;
      pbd[t->driverpath[i] + t->drivern[i] + k15] += y50bd;
      slope17b += y50b * c12;
      slope17bd += y50bd * c12 + y50b * c12d;
      c12b += y50b * slope17;
      c12bd += y50bd * slope17 + y50b * slope17d;
      y50b = 0.0;
      y50bd = 0.0;
      e12b += slope17b;
      e12bd += slope17bd;
      h12b -= slope17b * (2.0 * m0_12 + m1_12) / 6.0;
      h12bd -= (slope17bd * (2.0 * m0_12 + m1_12) + slope17b * (2.0 * m0_12d + m1_12d)) / 6.0;
      tb199 = slope17b * (h12 / 6.0);
      tb199d = slope17bd * (h12 / 6.0) + slope17b * (h12d / 6.0);
      m0_12b -= tb199 * 2.0;
      m0_12bd -= tb199d * 2.0;
      m1_12b -= tb199;
      m1_12bd -= tb199d;
    } else if (MAGGI_RE(a13) < 0.0) {
      slope17_2 = e12 + h12 / 6.0 * (m0_12 + 2.0 * m1_12);
      slope17_2d = e12d + (h12d / 6.0 * (m0_12 + 2.0 * m1_12) + h12 / 6.0 * (m0_12d + 2.0 *
          m1_12d));
      y52b = 0.0;
      y52bd = 0.0;
      slope17_2b = y51b;
      slope17_2bd = y51bd;
      y51b = 0.0;
      y51bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k15 + 1] += y50b;
      pbd[t->driverpath[i] + t->drivern[i] + k15 + 1] += y50bd;
      slope17_2b -= y50b * a13;
      slope17_2bd -= y50bd * a13 + y50b * a13d;
      a13b -= y50b * slope17_2;
      a13bd -= y50bd * slope17_2 + y50b * slope17_2d;
      y50b = 0.0;
      y50bd = 0.0;
      e12b += slope17_2b;
      e12bd += slope17_2bd;
      h12b += slope17_2b * (m0_12 + 2.0 * m1_12) / 6.0;
      h12bd += (slope17_2bd * (m0_12 + 2.0 * m1_12) + slope17_2b * (m0_12d + 2.0 * m1_12d)) / 6.0;
      tb200 = slope17_2b * (h12 / 6.0);
      tb200d = slope17_2bd * (h12 / 6.0) + slope17_2b * (h12d / 6.0);
      m0_12b += tb200;
      m0_12bd += tb200d;
      m1_12b += tb200 * 2.0;
      m1_12bd += tb200d * 2.0;
    } else {
      slope17_3 = e12 - h12 / 6.0 * (m1_12 - m0_12);
      slope17_3d = e12d - (h12d / 6.0 * (m1_12 - m0_12) + h12 / 6.0 * (m1_12d - m0_12d));
      t64 = 6.0 * h12;
      t64d = 6.0 * h12d;
      t65 = (m0_12 * a13 * a13 * a13 + m1_12 * c12 * c12 * c12) / t64;
      t65d = (((m0_12d * a13 + m0_12 * a13d) * a13 + m0_12 * a13 * a13d) * a13 + m0_12 * a13 * a13 *
          a13d + (((m1_12d * c12 + m1_12 * c12d) * c12 + m1_12 * c12 * c12d) * c12 + m1_12 * c12 *
          c12 * c12d) - t65 * t64d) * (1.0 / t64);
      t66 = 2.0 * h12;
      t66d = 2.0 * h12d;
      t67 = (m1_12 * c12 * c12 - m0_12 * a13 * a13) / t66;
      t67d = ((m1_12d * c12 + m1_12 * c12d) * c12 + m1_12 * c12 * c12d - ((m0_12d * a13 + m0_12 *
          a13d) * a13 + m0_12 * a13 * a13d) - t67 * t66d) * (1.0 / t66);
      t68 = (m0_12 * a13 + m1_12 * c12) / h12;
      t68d = (m0_12d * a13 + m0_12 * a13d + (m1_12d * c12 + m1_12 * c12d) - t68 * h12d) * (1.0 /
          h12);
      t68b = y52b;
      t68bd = y52bd;
      y52b = 0.0;
      y52bd = 0.0;
      tb212 = t68b / h12;
      tb212d = (t68bd - tb212 * h12d) * (1.0 / h12);
      m0_12b += tb212 * a13;
      m0_12bd += tb212d * a13 + tb212 * a13d;
      a13b += tb212 * m0_12;
      a13bd += tb212d * m0_12 + tb212 * m0_12d;
      m1_12b += tb212 * c12;
      m1_12bd += tb212d * c12 + tb212 * c12d;
      c12b += tb212 * m1_12;
      c12bd += tb212d * m1_12 + tb212 * m1_12d;
      h12b -= tb212 * t68;
      h12bd -= tb212d * t68 + tb212 * t68d;
      t67b = y51b;
      t67bd = y51bd;
      slope17_3b = y51b;
      slope17_3bd = y51bd;
      y51b = 0.0;
      y51bd = 0.0;
      tb209 = t67b / t66;
      tb209d = (t67bd - tb209 * t66d) * (1.0 / t66);
      tb210 = tb209 * c12;
      tb210d = tb209d * c12 + tb209 * c12d;
      m1_12b += tb210 * c12;
      m1_12bd += tb210d * c12 + tb210 * c12d;
      c12b += tb210 * m1_12;
      c12bd += tb210d * m1_12 + tb210 * m1_12d;
      c12b += tb209 * (m1_12 * c12);
      c12bd += tb209d * (m1_12 * c12) + tb209 * (m1_12d * c12 + m1_12 * c12d);
      tb211 = tb209 * a13;
      tb211d = tb209d * a13 + tb209 * a13d;
      m0_12b -= tb211 * a13;
      m0_12bd -= tb211d * a13 + tb211 * a13d;
      a13b -= tb211 * m0_12;
      a13bd -= tb211d * m0_12 + tb211 * m0_12d;
      a13b -= tb209 * (m0_12 * a13);
      a13bd -= tb209d * (m0_12 * a13) + tb209 * (m0_12d * a13 + m0_12 * a13d);
      t66b = -(tb209 * t67);
      t66bd = -(tb209d * t67 + tb209 * t67d);
      h12b += t66b * 2.0;
      h12bd += t66bd * 2.0;
      t65b = y50b;
      t65bd = y50bd;
      pb[t->driverpath[i] + t->drivern[i] + k15] += y50b;
      pbd[t->driverpath[i] + t->drivern[i] + k15] += y50bd;
      tb207 = y50b / 6.0;
      tb207d = y50bd / 6.0;
      tb208 = tb207 * h12;
      tb208d = tb207d * h12 + tb207 * h12d;
      m0_12b -= tb208 * h12;
      m0_12bd -= tb208d * h12 + tb208 * h12d;
      h12b -= tb208 * m0_12;
      h12bd -= tb208d * m0_12 + tb208 * m0_12d;
      h12b -= tb207 * (m0_12 * h12);
      h12bd -= tb207d * (m0_12 * h12) + tb207 * (m0_12d * h12 + m0_12 * h12d);
      slope17_3b += y50b * c12;
      slope17_3bd += y50bd * c12 + y50b * c12d;
      c12b += y50b * slope17_3;
      c12bd += y50bd * slope17_3 + y50b * slope17_3d;
      y50b = 0.0;
      y50bd = 0.0;
      tb202 = t65b / t64;
      tb202d = (t65bd - tb202 * t64d) * (1.0 / t64);
      tb203 = tb202 * a13;
      tb203d = tb202d * a13 + tb202 * a13d;
      tb204 = tb203 * a13;
      tb204d = tb203d * a13 + tb203 * a13d;
      m0_12b += tb204 * a13;
      m0_12bd += tb204d * a13 + tb204 * a13d;
      a13b += tb204 * m0_12;
      a13bd += tb204d * m0_12 + tb204 * m0_12d;
      a13b += tb203 * (m0_12 * a13);
      a13bd += tb203d * (m0_12 * a13) + tb203 * (m0_12d * a13 + m0_12 * a13d);
      a13b += tb202 * (m0_12 * a13 * a13);
      a13bd += tb202d * (m0_12 * a13 * a13) + tb202 * ((m0_12d * a13 + m0_12 * a13d) * a13 + m0_12 *
          a13 * a13d);
      tb205 = tb202 * c12;
      tb205d = tb202d * c12 + tb202 * c12d;
      tb206 = tb205 * c12;
      tb206d = tb205d * c12 + tb205 * c12d;
      m1_12b += tb206 * c12;
      m1_12bd += tb206d * c12 + tb206 * c12d;
      c12b += tb206 * m1_12;
      c12bd += tb206d * m1_12 + tb206 * m1_12d;
      c12b += tb205 * (m1_12 * c12);
      c12bd += tb205d * (m1_12 * c12) + tb205 * (m1_12d * c12 + m1_12 * c12d);
      c12b += tb202 * (m1_12 * c12 * c12);
      c12bd += tb202d * (m1_12 * c12 * c12) + tb202 * ((m1_12d * c12 + m1_12 * c12d) * c12 + m1_12 *
          c12 * c12d);
      t64b = -(tb202 * t65);
      t64bd = -(tb202d * t65 + tb202 * t65d);
      h12b += t64b * 6.0;
      h12bd += t64bd * 6.0;
      e12b += slope17_3b;
      e12bd += slope17_3bd;
      h12b -= slope17_3b * (m1_12 - m0_12) / 6.0;
      h12bd -= (slope17_3bd * (m1_12 - m0_12) + slope17_3b * (m1_12d - m0_12d)) / 6.0;
      tb201 = slope17_3b * (h12 / 6.0);
      tb201d = slope17_3bd * (h12 / 6.0) + slope17_3b * (h12d / 6.0);
      m1_12b -= tb201;
      m1_12bd -= tb201d;
      m0_12b += tb201;
      m0_12bd += tb201d;
    }
    tb198 = e12b / h12;
    tb198d = (e12bd - tb198 * h12d) * (1.0 / h12);
    pb[t->driverpath[i] + t->drivern[i] + k15 + 1] += tb198;
    pbd[t->driverpath[i] + t->drivern[i] + k15 + 1] += tb198d;
    pb[t->driverpath[i] + t->drivern[i] + k15] -= tb198;
    pbd[t->driverpath[i] + t->drivern[i] + k15] -= tb198d;
    h12b -= tb198 * e12;
    h12bd -= tb198d * e12 + tb198 * e12d;
    path0b[t->driverrow[i] + k15 + 1][MAGGI_PATH_Y] += m1_12b;
    path0bd[t->driverrow[i] + k15 + 1][MAGGI_PATH_Y] += m1_12bd;
    path0b[t->driverrow[i] + k15][MAGGI_PATH_Y] += m0_12b;
    path0bd[t->driverrow[i] + k15][MAGGI_PATH_Y] += m0_12bd;
    s5b += c12b;
    s5bd += c12bd;
    path0b[t->driverrow[i] + k15][MAGGI_PATH_S] -= c12b;
    path0bd[t->driverrow[i] + k15][MAGGI_PATH_S] -= c12bd;
    path0b[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] += a13b;
    path0bd[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] += a13bd;
    s5b -= a13b;
    s5bd -= a13bd;
    path0b[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] += h12b;
    path0bd[t->driverrow[i] + k15 + 1][MAGGI_PATH_S] += h12bd;
    path0b[t->driverrow[i] + k15][MAGGI_PATH_S] -= h12b;
    path0bd[t->driverrow[i] + k15][MAGGI_PATH_S] -= h12bd;
    a12b = 0.0;
    a12bd = 0.0;
    c11b = 0.0;
    c11bd = 0.0;
    e11b = 0.0;
    e11bd = 0.0;
    h11b = 0.0;
    h11bd = 0.0;
    m0_11b = 0.0;
    m0_11bd = 0.0;
    m1_11b = 0.0;
    m1_11bd = 0.0;
    if (MAGGI_RE(c11) < 0.0) {
      slope16 = e11 - h11 / 6.0 * (2.0 * m0_11 + m1_11);
      slope16d = e11d - (h11d / 6.0 * (2.0 * m0_11 + m1_11) + h11 / 6.0 * (2.0 * m0_11d + m1_11d));
      x52b = 0.0;
      x52bd = 0.0;
      slope16b = x51b;
      slope16bd = x51bd;
      x51b = 0.0;
      x51bd = 0.0;
      pb[t->driverpath[i] + k14] += x50b;
      pbd[t->driverpath[i] + k14] += x50bd;
      slope16b += x50b * c11;
      slope16bd += x50bd * c11 + x50b * c11d;
      c11b += x50b * slope16;
      c11bd += x50bd * slope16 + x50b * slope16d;
      x50b = 0.0;
      x50bd = 0.0;
      e11b += slope16b;
      e11bd += slope16bd;
      h11b -= slope16b * (2.0 * m0_11 + m1_11) / 6.0;
      h11bd -= (slope16bd * (2.0 * m0_11 + m1_11) + slope16b * (2.0 * m0_11d + m1_11d)) / 6.0;
      tb184 = slope16b * (h11 / 6.0);
      tb184d = slope16bd * (h11 / 6.0) + slope16b * (h11d / 6.0);
      m0_11b -= tb184 * 2.0;
      m0_11bd -= tb184d * 2.0;
      m1_11b -= tb184;
      m1_11bd -= tb184d;
    } else if (MAGGI_RE(a12) < 0.0) {
      slope16_2 = e11 + h11 / 6.0 * (m0_11 + 2.0 * m1_11);
      slope16_2d = e11d + (h11d / 6.0 * (m0_11 + 2.0 * m1_11) + h11 / 6.0 * (m0_11d + 2.0 *
          m1_11d));
      x52b = 0.0;
      x52bd = 0.0;
      slope16_2b = x51b;
      slope16_2bd = x51bd;
      x51b = 0.0;
      x51bd = 0.0;
      pb[t->driverpath[i] + k14 + 1] += x50b;
      pbd[t->driverpath[i] + k14 + 1] += x50bd;
      slope16_2b -= x50b * a12;
      slope16_2bd -= x50bd * a12 + x50b * a12d;
      a12b -= x50b * slope16_2;
      a12bd -= x50bd * slope16_2 + x50b * slope16_2d;
      x50b = 0.0;
      x50bd = 0.0;
      e11b += slope16_2b;
      e11bd += slope16_2bd;
      h11b += slope16_2b * (m0_11 + 2.0 * m1_11) / 6.0;
      h11bd += (slope16_2bd * (m0_11 + 2.0 * m1_11) + slope16_2b * (m0_11d + 2.0 * m1_11d)) / 6.0;
      tb185 = slope16_2b * (h11 / 6.0);
      tb185d = slope16_2bd * (h11 / 6.0) + slope16_2b * (h11d / 6.0);
      m0_11b += tb185;
      m0_11bd += tb185d;
      m1_11b += tb185 * 2.0;
      m1_11bd += tb185d * 2.0;
    } else {
      slope16_3 = e11 - h11 / 6.0 * (m1_11 - m0_11);
      slope16_3d = e11d - (h11d / 6.0 * (m1_11 - m0_11) + h11 / 6.0 * (m1_11d - m0_11d));
      t59 = 6.0 * h11;
      t59d = 6.0 * h11d;
      t60 = (m0_11 * a12 * a12 * a12 + m1_11 * c11 * c11 * c11) / t59;
      t60d = (((m0_11d * a12 + m0_11 * a12d) * a12 + m0_11 * a12 * a12d) * a12 + m0_11 * a12 * a12 *
          a12d + (((m1_11d * c11 + m1_11 * c11d) * c11 + m1_11 * c11 * c11d) * c11 + m1_11 * c11 *
          c11 * c11d) - t60 * t59d) * (1.0 / t59);
      t61 = 2.0 * h11;
      t61d = 2.0 * h11d;
      t62 = (m1_11 * c11 * c11 - m0_11 * a12 * a12) / t61;
      t62d = ((m1_11d * c11 + m1_11 * c11d) * c11 + m1_11 * c11 * c11d - ((m0_11d * a12 + m0_11 *
          a12d) * a12 + m0_11 * a12 * a12d) - t62 * t61d) * (1.0 / t61);
      t63 = (m0_11 * a12 + m1_11 * c11) / h11;
      t63d = (m0_11d * a12 + m0_11 * a12d + (m1_11d * c11 + m1_11 * c11d) - t63 * h11d) * (1.0 /
          h11);
      t63b = x52b;
      t63bd = x52bd;
      x52b = 0.0;
      x52bd = 0.0;
      tb197 = t63b / h11;
      tb197d = (t63bd - tb197 * h11d) * (1.0 / h11);
      m0_11b += tb197 * a12;
      m0_11bd += tb197d * a12 + tb197 * a12d;
      a12b += tb197 * m0_11;
      a12bd += tb197d * m0_11 + tb197 * m0_11d;
      m1_11b += tb197 * c11;
      m1_11bd += tb197d * c11 + tb197 * c11d;
      c11b += tb197 * m1_11;
      c11bd += tb197d * m1_11 + tb197 * m1_11d;
      h11b -= tb197 * t63;
      h11bd -= tb197d * t63 + tb197 * t63d;
      t62b = x51b;
      t62bd = x51bd;
      slope16_3b = x51b;
      slope16_3bd = x51bd;
      x51b = 0.0;
      x51bd = 0.0;
      tb194 = t62b / t61;
      tb194d = (t62bd - tb194 * t61d) * (1.0 / t61);
      tb195 = tb194 * c11;
      tb195d = tb194d * c11 + tb194 * c11d;
      m1_11b += tb195 * c11;
      m1_11bd += tb195d * c11 + tb195 * c11d;
      c11b += tb195 * m1_11;
      c11bd += tb195d * m1_11 + tb195 * m1_11d;
      c11b += tb194 * (m1_11 * c11);
      c11bd += tb194d * (m1_11 * c11) + tb194 * (m1_11d * c11 + m1_11 * c11d);
      tb196 = tb194 * a12;
      tb196d = tb194d * a12 + tb194 * a12d;
      m0_11b -= tb196 * a12;
      m0_11bd -= tb196d * a12 + tb196 * a12d;
      a12b -= tb196 * m0_11;
      a12bd -= tb196d * m0_11 + tb196 * m0_11d;
      a12b -= tb194 * (m0_11 * a12);
      a12bd -= tb194d * (m0_11 * a12) + tb194 * (m0_11d * a12 + m0_11 * a12d);
      t61b = -(tb194 * t62);
      t61bd = -(tb194d * t62 + tb194 * t62d);
      h11b += t61b * 2.0;
      h11bd += t61bd * 2.0;
      t60b = x50b;
      t60bd = x50bd;
      pb[t->driverpath[i] + k14] += x50b;
      pbd[t->driverpath[i] + k14] += x50bd;
      tb192 = x50b / 6.0;
      tb192d = x50bd / 6.0;
      tb193 = tb192 * h11;
      tb193d = tb192d * h11 + tb192 * h11d;
      m0_11b -= tb193 * h11;
      m0_11bd -= tb193d * h11 + tb193 * h11d;
      h11b -= tb193 * m0_11;
      h11bd -= tb193d * m0_11 + tb193 * m0_11d;
      h11b -= tb192 * (m0_11 * h11);
      h11bd -= tb192d * (m0_11 * h11) + tb192 * (m0_11d * h11 + m0_11 * h11d);
      slope16_3b += x50b * c11;
      slope16_3bd += x50bd * c11 + x50b * c11d;
      c11b += x50b * slope16_3;
      c11bd += x50bd * slope16_3 + x50b * slope16_3d;
      x50b = 0.0;
      x50bd = 0.0;
      tb187 = t60b / t59;
      tb187d = (t60bd - tb187 * t59d) * (1.0 / t59);
      tb188 = tb187 * a12;
      tb188d = tb187d * a12 + tb187 * a12d;
      tb189 = tb188 * a12;
      tb189d = tb188d * a12 + tb188 * a12d;
      m0_11b += tb189 * a12;
      m0_11bd += tb189d * a12 + tb189 * a12d;
      a12b += tb189 * m0_11;
      a12bd += tb189d * m0_11 + tb189 * m0_11d;
      a12b += tb188 * (m0_11 * a12);
      a12bd += tb188d * (m0_11 * a12) + tb188 * (m0_11d * a12 + m0_11 * a12d);
      a12b += tb187 * (m0_11 * a12 * a12);
      a12bd += tb187d * (m0_11 * a12 * a12) + tb187 * ((m0_11d * a12 + m0_11 * a12d) * a12 + m0_11 *
          a12 * a12d);
      tb190 = tb187 * c11;
      tb190d = tb187d * c11 + tb187 * c11d;
      tb191 = tb190 * c11;
      tb191d = tb190d * c11 + tb190 * c11d;
      m1_11b += tb191 * c11;
      m1_11bd += tb191d * c11 + tb191 * c11d;
      c11b += tb191 * m1_11;
      c11bd += tb191d * m1_11 + tb191 * m1_11d;
      c11b += tb190 * (m1_11 * c11);
      c11bd += tb190d * (m1_11 * c11) + tb190 * (m1_11d * c11 + m1_11 * c11d);
      c11b += tb187 * (m1_11 * c11 * c11);
      c11bd += tb187d * (m1_11 * c11 * c11) + tb187 * ((m1_11d * c11 + m1_11 * c11d) * c11 + m1_11 *
          c11 * c11d);
      t59b = -(tb187 * t60);
      t59bd = -(tb187d * t60 + tb187 * t60d);
      h11b += t59b * 6.0;
      h11bd += t59bd * 6.0;
      e11b += slope16_3b;
      e11bd += slope16_3bd;
      h11b -= slope16_3b * (m1_11 - m0_11) / 6.0;
      h11bd -= (slope16_3bd * (m1_11 - m0_11) + slope16_3b * (m1_11d - m0_11d)) / 6.0;
      tb186 = slope16_3b * (h11 / 6.0);
      tb186d = slope16_3bd * (h11 / 6.0) + slope16_3b * (h11d / 6.0);
      m1_11b -= tb186;
      m1_11bd -= tb186d;
      m0_11b += tb186;
      m0_11bd += tb186d;
    }
    tb183 = e11b / h11;
    tb183d = (e11bd - tb183 * h11d) * (1.0 / h11);
    pb[t->driverpath[i] + k14 + 1] += tb183;
    pbd[t->driverpath[i] + k14 + 1] += tb183d;
    pb[t->driverpath[i] + k14] -= tb183;
    pbd[t->driverpath[i] + k14] -= tb183d;
    h11b -= tb183 * e11;
    h11bd -= tb183d * e11 + tb183 * e11d;
    path0b[t->driverrow[i] + k14 + 1][MAGGI_PATH_X] += m1_11b;
    path0bd[t->driverrow[i] + k14 + 1][MAGGI_PATH_X] += m1_11bd;
    path0b[t->driverrow[i] + k14][MAGGI_PATH_X] += m0_11b;
    path0bd[t->driverrow[i] + k14][MAGGI_PATH_X] += m0_11bd;
    s5b += c11b;
    s5bd += c11bd;
    path0b[t->driverrow[i] + k14][MAGGI_PATH_S] -= c11b;
    path0bd[t->driverrow[i] + k14][MAGGI_PATH_S] -= c11bd;
    path0b[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] += a12b;
    path0bd[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] += a12bd;
    s5b -= a12b;
    s5bd -= a12bd;
    path0b[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] += h11b;
    path0bd[t->driverrow[i] + k14 + 1][MAGGI_PATH_S] += h11bd;
    path0b[t->driverrow[i] + k14][MAGGI_PATH_S] -= h11b;
    path0bd[t->driverrow[i] + k14][MAGGI_PATH_S] -= h11bd;
    s4b = s5b;
    s4bd = s5bd;
    t58b = -s5b;
    t58bd = -s5bd;
    tb182 = t58b / slope15;
    tb182d = (t58bd - tb182 * slope15d) * (1.0 / slope15);
    g5b = tb182;
    g5bd = tb182d;
    slope15b = -(tb182 * t58);
    slope15bd = -(tb182d * t58 + tb182 * t58d);
    x41b = slope15b * x41;
    x41bd = slope15bd * x41 + slope15b * x41d;
    x41b += slope15b * x41;
    x41bd += slope15bd * x41 + slope15b * x41d;
    y41b = slope15b * y41;
    y41bd = slope15bd * y41 + slope15b * y41d;
    y41b += slope15b * y41;
    y41bd += slope15bd * y41 + slope15b * y41d;
    tb180 = slope15b * x42;
    tb180d = slope15bd * x42 + slope15b * x42d;
    x40b = tb180;
    x40bd = tb180d;
    Pb[0] -= tb180;
    Pbd[0] -= tb180d;
    x42b = slope15b * (x40 - P[0]);
    x42bd = slope15bd * (x40 - P[0]) + slope15b * (x40d - Pd[0]);
    tb181 = slope15b * y42;
    tb181d = slope15bd * y42 + slope15b * y42d;
    y40b = tb181;
    y40bd = tb181d;
    Pb[1] -= tb181;
    Pbd[1] -= tb181d;
    y42b = slope15b * (y40 - P[1]);
    y42bd = slope15bd * (y40 - P[1]) + slope15b * (y40d - Pd[1]);
    tb178 = g5b * x41;
    /* one step of Newton's method; C, C', C'' at s */
    tb178d = g5bd * x41 + g5b * x41d;
    x40b += tb178;
    x40bd += tb178d;
    Pb[0] -= tb178;
    Pbd[0] -= tb178d;
    x41b += g5b * (x40 - P[0]);
    x41bd += g5bd * (x40 - P[0]) + g5b * (x40d - Pd[0]);
    tb179 = g5b * y41;
    tb179d = g5bd * y41 + g5b * y41d;
    y40b += tb179;
    y40bd += tb179d;
    Pb[1] -= tb179;
    Pbd[1] -= tb179d;
    y41b += g5b * (y40 - P[1]);
    y41bd += g5bd * (y40 - P[1]) + g5b * (y40d - Pd[1]);
    a11b = 0.0;
    a11bd = 0.0;
    c10b = 0.0;
    c10bd = 0.0;
    e10b = 0.0;
    e10bd = 0.0;
    h10b = 0.0;
    h10bd = 0.0;
    m0_10b = 0.0;
    m0_10bd = 0.0;
    m1_10b = 0.0;
    m1_10bd = 0.0;
    if (MAGGI_RE(c10) < 0.0) {
      slope14 = e10 - h10 / 6.0 * (2.0 * m0_10 + m1_10);
      slope14d = e10d - (h10d / 6.0 * (2.0 * m0_10 + m1_10) + h10 / 6.0 * (2.0 * m0_10d + m1_10d));
      y42b = 0.0;
      y42bd = 0.0;
      slope14b = y41b;
      slope14bd = y41bd;
      y41b = 0.0;
      y41bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k13] += y40b;
      pbd[t->driverpath[i] + t->drivern[i] + k13] += y40bd;
      slope14b += y40b * c10;
      slope14bd += y40bd * c10 + y40b * c10d;
      c10b += y40b * slope14;
      c10bd += y40bd * slope14 + y40b * slope14d;
      y40b = 0.0;
      y40bd = 0.0;
      e10b += slope14b;
      e10bd += slope14bd;
      h10b -= slope14b * (2.0 * m0_10 + m1_10) / 6.0;
      h10bd -= (slope14bd * (2.0 * m0_10 + m1_10) + slope14b * (2.0 * m0_10d + m1_10d)) / 6.0;
      tb164 = slope14b * (h10 / 6.0);
      tb164d = slope14bd * (h10 / 6.0) + slope14b * (h10d / 6.0);
      m0_10b -= tb164 * 2.0;
      m0_10bd -= tb164d * 2.0;
      m1_10b -= tb164;
      m1_10bd -= tb164d;
    } else if (MAGGI_RE(a11) < 0.0) {
      slope14_2 = e10 + h10 / 6.0 * (m0_10 + 2.0 * m1_10);
      slope14_2d = e10d + (h10d / 6.0 * (m0_10 + 2.0 * m1_10) + h10 / 6.0 * (m0_10d + 2.0 *
          m1_10d));
      y42b = 0.0;
      y42bd = 0.0;
      slope14_2b = y41b;
      slope14_2bd = y41bd;
      y41b = 0.0;
      y41bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k13 + 1] += y40b;
      pbd[t->driverpath[i] + t->drivern[i] + k13 + 1] += y40bd;
      slope14_2b -= y40b * a11;
      slope14_2bd -= y40bd * a11 + y40b * a11d;
      a11b -= y40b * slope14_2;
      a11bd -= y40bd * slope14_2 + y40b * slope14_2d;
      y40b = 0.0;
      y40bd = 0.0;
      e10b += slope14_2b;
      e10bd += slope14_2bd;
      h10b += slope14_2b * (m0_10 + 2.0 * m1_10) / 6.0;
      h10bd += (slope14_2bd * (m0_10 + 2.0 * m1_10) + slope14_2b * (m0_10d + 2.0 * m1_10d)) / 6.0;
      tb165 = slope14_2b * (h10 / 6.0);
      tb165d = slope14_2bd * (h10 / 6.0) + slope14_2b * (h10d / 6.0);
      m0_10b += tb165;
      m0_10bd += tb165d;
      m1_10b += tb165 * 2.0;
      m1_10bd += tb165d * 2.0;
    } else {
      slope14_3 = e10 - h10 / 6.0 * (m1_10 - m0_10);
      slope14_3d = e10d - (h10d / 6.0 * (m1_10 - m0_10) + h10 / 6.0 * (m1_10d - m0_10d));
      t53 = 6.0 * h10;
      t53d = 6.0 * h10d;
      t54 = (m0_10 * a11 * a11 * a11 + m1_10 * c10 * c10 * c10) / t53;
      t54d = (((m0_10d * a11 + m0_10 * a11d) * a11 + m0_10 * a11 * a11d) * a11 + m0_10 * a11 * a11 *
          a11d + (((m1_10d * c10 + m1_10 * c10d) * c10 + m1_10 * c10 * c10d) * c10 + m1_10 * c10 *
          c10 * c10d) - t54 * t53d) * (1.0 / t53);
      t55 = 2.0 * h10;
      t55d = 2.0 * h10d;
      t56 = (m1_10 * c10 * c10 - m0_10 * a11 * a11) / t55;
      t56d = ((m1_10d * c10 + m1_10 * c10d) * c10 + m1_10 * c10 * c10d - ((m0_10d * a11 + m0_10 *
          a11d) * a11 + m0_10 * a11 * a11d) - t56 * t55d) * (1.0 / t55);
      t57 = (m0_10 * a11 + m1_10 * c10) / h10;
      t57d = (m0_10d * a11 + m0_10 * a11d + (m1_10d * c10 + m1_10 * c10d) - t57 * h10d) * (1.0 /
          h10);
      t57b = y42b;
      t57bd = y42bd;
      y42b = 0.0;
      y42bd = 0.0;
      tb177 = t57b / h10;
      tb177d = (t57bd - tb177 * h10d) * (1.0 / h10);
      m0_10b += tb177 * a11;
      m0_10bd += tb177d * a11 + tb177 * a11d;
      a11b += tb177 * m0_10;
      a11bd += tb177d * m0_10 + tb177 * m0_10d;
      m1_10b += tb177 * c10;
      m1_10bd += tb177d * c10 + tb177 * c10d;
      c10b += tb177 * m1_10;
      c10bd += tb177d * m1_10 + tb177 * m1_10d;
      h10b -= tb177 * t57;
      h10bd -= tb177d * t57 + tb177 * t57d;
      t56b = y41b;
      t56bd = y41bd;
      slope14_3b = y41b;
      slope14_3bd = y41bd;
      y41b = 0.0;
      y41bd = 0.0;
      tb174 = t56b / t55;
      tb174d = (t56bd - tb174 * t55d) * (1.0 / t55);
      tb175 = tb174 * c10;
      tb175d = tb174d * c10 + tb174 * c10d;
      m1_10b += tb175 * c10;
      m1_10bd += tb175d * c10 + tb175 * c10d;
      c10b += tb175 * m1_10;
      c10bd += tb175d * m1_10 + tb175 * m1_10d;
      c10b += tb174 * (m1_10 * c10);
      c10bd += tb174d * (m1_10 * c10) + tb174 * (m1_10d * c10 + m1_10 * c10d);
      tb176 = tb174 * a11;
      tb176d = tb174d * a11 + tb174 * a11d;
      m0_10b -= tb176 * a11;
      m0_10bd -= tb176d * a11 + tb176 * a11d;
      a11b -= tb176 * m0_10;
      a11bd -= tb176d * m0_10 + tb176 * m0_10d;
      a11b -= tb174 * (m0_10 * a11);
      a11bd -= tb174d * (m0_10 * a11) + tb174 * (m0_10d * a11 + m0_10 * a11d);
      t55b = -(tb174 * t56);
      t55bd = -(tb174d * t56 + tb174 * t56d);
      h10b += t55b * 2.0;
      h10bd += t55bd * 2.0;
      t54b = y40b;
      t54bd = y40bd;
      pb[t->driverpath[i] + t->drivern[i] + k13] += y40b;
      pbd[t->driverpath[i] + t->drivern[i] + k13] += y40bd;
      tb172 = y40b / 6.0;
      tb172d = y40bd / 6.0;
      tb173 = tb172 * h10;
      tb173d = tb172d * h10 + tb172 * h10d;
      m0_10b -= tb173 * h10;
      m0_10bd -= tb173d * h10 + tb173 * h10d;
      h10b -= tb173 * m0_10;
      h10bd -= tb173d * m0_10 + tb173 * m0_10d;
      h10b -= tb172 * (m0_10 * h10);
      h10bd -= tb172d * (m0_10 * h10) + tb172 * (m0_10d * h10 + m0_10 * h10d);
      slope14_3b += y40b * c10;
      slope14_3bd += y40bd * c10 + y40b * c10d;
      c10b += y40b * slope14_3;
      c10bd += y40bd * slope14_3 + y40b * slope14_3d;
      y40b = 0.0;
      y40bd = 0.0;
      tb167 = t54b / t53;
      tb167d = (t54bd - tb167 * t53d) * (1.0 / t53);
      tb168 = tb167 * a11;
      tb168d = tb167d * a11 + tb167 * a11d;
      tb169 = tb168 * a11;
      tb169d = tb168d * a11 + tb168 * a11d;
      m0_10b += tb169 * a11;
      m0_10bd += tb169d * a11 + tb169 * a11d;
      a11b += tb169 * m0_10;
      a11bd += tb169d * m0_10 + tb169 * m0_10d;
      a11b += tb168 * (m0_10 * a11);
      a11bd += tb168d * (m0_10 * a11) + tb168 * (m0_10d * a11 + m0_10 * a11d);
      a11b += tb167 * (m0_10 * a11 * a11);
      a11bd += tb167d * (m0_10 * a11 * a11) + tb167 * ((m0_10d * a11 + m0_10 * a11d) * a11 + m0_10 *
          a11 * a11d);
      tb170 = tb167 * c10;
      tb170d = tb167d * c10 + tb167 * c10d;
      tb171 = tb170 * c10;
      tb171d = tb170d * c10 + tb170 * c10d;
      m1_10b += tb171 * c10;
      m1_10bd += tb171d * c10 + tb171 * c10d;
      c10b += tb171 * m1_10;
      c10bd += tb171d * m1_10 + tb171 * m1_10d;
      c10b += tb170 * (m1_10 * c10);
      c10bd += tb170d * (m1_10 * c10) + tb170 * (m1_10d * c10 + m1_10 * c10d);
      c10b += tb167 * (m1_10 * c10 * c10);
      c10bd += tb167d * (m1_10 * c10 * c10) + tb167 * ((m1_10d * c10 + m1_10 * c10d) * c10 + m1_10 *
          c10 * c10d);
      t53b = -(tb167 * t54);
      t53bd = -(tb167d * t54 + tb167 * t54d);
      h10b += t53b * 6.0;
      h10bd += t53bd * 6.0;
      e10b += slope14_3b;
      e10bd += slope14_3bd;
      h10b -= slope14_3b * (m1_10 - m0_10) / 6.0;
      h10bd -= (slope14_3bd * (m1_10 - m0_10) + slope14_3b * (m1_10d - m0_10d)) / 6.0;
      tb166 = slope14_3b * (h10 / 6.0);
      tb166d = slope14_3bd * (h10 / 6.0) + slope14_3b * (h10d / 6.0);
      m1_10b -= tb166;
      m1_10bd -= tb166d;
      m0_10b += tb166;
      m0_10bd += tb166d;
    }
    tb163 = e10b / h10;
    tb163d = (e10bd - tb163 * h10d) * (1.0 / h10);
    pb[t->driverpath[i] + t->drivern[i] + k13 + 1] += tb163;
    pbd[t->driverpath[i] + t->drivern[i] + k13 + 1] += tb163d;
    pb[t->driverpath[i] + t->drivern[i] + k13] -= tb163;
    pbd[t->driverpath[i] + t->drivern[i] + k13] -= tb163d;
    h10b -= tb163 * e10;
    h10bd -= tb163d * e10 + tb163 * e10d;
    path0b[t->driverrow[i] + k13 + 1][MAGGI_PATH_Y] += m1_10b;
    path0bd[t->driverrow[i] + k13 + 1][MAGGI_PATH_Y] += m1_10bd;
    path0b[t->driverrow[i] + k13][MAGGI_PATH_Y] += m0_10b;
    path0bd[t->driverrow[i] + k13][MAGGI_PATH_Y] += m0_10bd;
    s4b += c10b;
    s4bd += c10bd;
    path0b[t->driverrow[i] + k13][MAGGI_PATH_S] -= c10b;
    path0bd[t->driverrow[i] + k13][MAGGI_PATH_S] -= c10bd;
    path0b[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] += a11b;
    path0bd[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] += a11bd;
    s4b -= a11b;
    s4bd -= a11bd;
    path0b[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] += h10b;
    path0bd[t->driverrow[i] + k13 + 1][MAGGI_PATH_S] += h10bd;
    path0b[t->driverrow[i] + k13][MAGGI_PATH_S] -= h10b;
    path0bd[t->driverrow[i] + k13][MAGGI_PATH_S] -= h10bd;
    a10b = 0.0;
    a10bd = 0.0;
    c9b = 0.0;
    c9bd = 0.0;
    e9b = 0.0;
    e9bd = 0.0;
    h9b = 0.0;
    h9bd = 0.0;
    m0_9b = 0.0;
    m0_9bd = 0.0;
    m1_9b = 0.0;
    m1_9bd = 0.0;
    if (MAGGI_RE(c9) < 0.0) {
      slope13 = e9 - h9 / 6.0 * (2.0 * m0_9 + m1_9);
      slope13d = e9d - (h9d / 6.0 * (2.0 * m0_9 + m1_9) + h9 / 6.0 * (2.0 * m0_9d + m1_9d));
      x42b = 0.0;
      x42bd = 0.0;
      slope13b = x41b;
      slope13bd = x41bd;
      x41b = 0.0;
      x41bd = 0.0;
      pb[t->driverpath[i] + k12] += x40b;
      pbd[t->driverpath[i] + k12] += x40bd;
      slope13b += x40b * c9;
      slope13bd += x40bd * c9 + x40b * c9d;
      c9b += x40b * slope13;
      c9bd += x40bd * slope13 + x40b * slope13d;
      x40b = 0.0;
      x40bd = 0.0;
      e9b += slope13b;
      e9bd += slope13bd;
      h9b -= slope13b * (2.0 * m0_9 + m1_9) / 6.0;
      h9bd -= (slope13bd * (2.0 * m0_9 + m1_9) + slope13b * (2.0 * m0_9d + m1_9d)) / 6.0;
      tb149 = slope13b * (h9 / 6.0);
      tb149d = slope13bd * (h9 / 6.0) + slope13b * (h9d / 6.0);
      m0_9b -= tb149 * 2.0;
      m0_9bd -= tb149d * 2.0;
      m1_9b -= tb149;
      m1_9bd -= tb149d;
    } else if (MAGGI_RE(a10) < 0.0) {
      slope13_2 = e9 + h9 / 6.0 * (m0_9 + 2.0 * m1_9);
      slope13_2d = e9d + (h9d / 6.0 * (m0_9 + 2.0 * m1_9) + h9 / 6.0 * (m0_9d + 2.0 * m1_9d));
      x42b = 0.0;
      x42bd = 0.0;
      slope13_2b = x41b;
      slope13_2bd = x41bd;
      x41b = 0.0;
      x41bd = 0.0;
      pb[t->driverpath[i] + k12 + 1] += x40b;
      pbd[t->driverpath[i] + k12 + 1] += x40bd;
      slope13_2b -= x40b * a10;
      slope13_2bd -= x40bd * a10 + x40b * a10d;
      a10b -= x40b * slope13_2;
      a10bd -= x40bd * slope13_2 + x40b * slope13_2d;
      x40b = 0.0;
      x40bd = 0.0;
      e9b += slope13_2b;
      e9bd += slope13_2bd;
      h9b += slope13_2b * (m0_9 + 2.0 * m1_9) / 6.0;
      h9bd += (slope13_2bd * (m0_9 + 2.0 * m1_9) + slope13_2b * (m0_9d + 2.0 * m1_9d)) / 6.0;
      tb150 = slope13_2b * (h9 / 6.0);
      tb150d = slope13_2bd * (h9 / 6.0) + slope13_2b * (h9d / 6.0);
      m0_9b += tb150;
      m0_9bd += tb150d;
      m1_9b += tb150 * 2.0;
      m1_9bd += tb150d * 2.0;
    } else {
      slope13_3 = e9 - h9 / 6.0 * (m1_9 - m0_9);
      slope13_3d = e9d - (h9d / 6.0 * (m1_9 - m0_9) + h9 / 6.0 * (m1_9d - m0_9d));
      t48 = 6.0 * h9;
      t48d = 6.0 * h9d;
      t49 = (m0_9 * a10 * a10 * a10 + m1_9 * c9 * c9 * c9) / t48;
      t49d = (((m0_9d * a10 + m0_9 * a10d) * a10 + m0_9 * a10 * a10d) * a10 + m0_9 * a10 * a10 *
          a10d + (((m1_9d * c9 + m1_9 * c9d) * c9 + m1_9 * c9 * c9d) * c9 + m1_9 * c9 * c9 * c9d) -
          t49 * t48d) * (1.0 / t48);
      t50 = 2.0 * h9;
      t50d = 2.0 * h9d;
      t51 = (m1_9 * c9 * c9 - m0_9 * a10 * a10) / t50;
      t51d = ((m1_9d * c9 + m1_9 * c9d) * c9 + m1_9 * c9 * c9d - ((m0_9d * a10 + m0_9 * a10d) * a10
          + m0_9 * a10 * a10d) - t51 * t50d) * (1.0 / t50);
      t52 = (m0_9 * a10 + m1_9 * c9) / h9;
      t52d = (m0_9d * a10 + m0_9 * a10d + (m1_9d * c9 + m1_9 * c9d) - t52 * h9d) * (1.0 / h9);
      t52b = x42b;
      t52bd = x42bd;
      x42b = 0.0;
      x42bd = 0.0;
      tb162 = t52b / h9;
      tb162d = (t52bd - tb162 * h9d) * (1.0 / h9);
      m0_9b += tb162 * a10;
      m0_9bd += tb162d * a10 + tb162 * a10d;
      a10b += tb162 * m0_9;
      a10bd += tb162d * m0_9 + tb162 * m0_9d;
      m1_9b += tb162 * c9;
      m1_9bd += tb162d * c9 + tb162 * c9d;
      c9b += tb162 * m1_9;
      c9bd += tb162d * m1_9 + tb162 * m1_9d;
      h9b -= tb162 * t52;
      h9bd -= tb162d * t52 + tb162 * t52d;
      t51b = x41b;
      t51bd = x41bd;
      slope13_3b = x41b;
      slope13_3bd = x41bd;
      x41b = 0.0;
      x41bd = 0.0;
      tb159 = t51b / t50;
      tb159d = (t51bd - tb159 * t50d) * (1.0 / t50);
      tb160 = tb159 * c9;
      tb160d = tb159d * c9 + tb159 * c9d;
      m1_9b += tb160 * c9;
      m1_9bd += tb160d * c9 + tb160 * c9d;
      c9b += tb160 * m1_9;
      c9bd += tb160d * m1_9 + tb160 * m1_9d;
      c9b += tb159 * (m1_9 * c9);
      c9bd += tb159d * (m1_9 * c9) + tb159 * (m1_9d * c9 + m1_9 * c9d);
      tb161 = tb159 * a10;
      tb161d = tb159d * a10 + tb159 * a10d;
      m0_9b -= tb161 * a10;
      m0_9bd -= tb161d * a10 + tb161 * a10d;
      a10b -= tb161 * m0_9;
      a10bd -= tb161d * m0_9 + tb161 * m0_9d;
      a10b -= tb159 * (m0_9 * a10);
      a10bd -= tb159d * (m0_9 * a10) + tb159 * (m0_9d * a10 + m0_9 * a10d);
      t50b = -(tb159 * t51);
      t50bd = -(tb159d * t51 + tb159 * t51d);
      h9b += t50b * 2.0;
      h9bd += t50bd * 2.0;
      t49b = x40b;
      t49bd = x40bd;
      pb[t->driverpath[i] + k12] += x40b;
      pbd[t->driverpath[i] + k12] += x40bd;
      tb157 = x40b / 6.0;
      tb157d = x40bd / 6.0;
      tb158 = tb157 * h9;
      tb158d = tb157d * h9 + tb157 * h9d;
      m0_9b -= tb158 * h9;
      m0_9bd -= tb158d * h9 + tb158 * h9d;
      h9b -= tb158 * m0_9;
      h9bd -= tb158d * m0_9 + tb158 * m0_9d;
      h9b -= tb157 * (m0_9 * h9);
      h9bd -= tb157d * (m0_9 * h9) + tb157 * (m0_9d * h9 + m0_9 * h9d);
      slope13_3b += x40b * c9;
      slope13_3bd += x40bd * c9 + x40b * c9d;
      c9b += x40b * slope13_3;
      c9bd += x40bd * slope13_3 + x40b * slope13_3d;
      x40b = 0.0;
      x40bd = 0.0;
      tb152 = t49b / t48;
      tb152d = (t49bd - tb152 * t48d) * (1.0 / t48);
      tb153 = tb152 * a10;
      tb153d = tb152d * a10 + tb152 * a10d;
      tb154 = tb153 * a10;
      tb154d = tb153d * a10 + tb153 * a10d;
      m0_9b += tb154 * a10;
      m0_9bd += tb154d * a10 + tb154 * a10d;
      a10b += tb154 * m0_9;
      a10bd += tb154d * m0_9 + tb154 * m0_9d;
      a10b += tb153 * (m0_9 * a10);
      a10bd += tb153d * (m0_9 * a10) + tb153 * (m0_9d * a10 + m0_9 * a10d);
      a10b += tb152 * (m0_9 * a10 * a10);
      a10bd += tb152d * (m0_9 * a10 * a10) + tb152 * ((m0_9d * a10 + m0_9 * a10d) * a10 + m0_9 * a10
          * a10d);
      tb155 = tb152 * c9;
      tb155d = tb152d * c9 + tb152 * c9d;
      tb156 = tb155 * c9;
      tb156d = tb155d * c9 + tb155 * c9d;
      m1_9b += tb156 * c9;
      m1_9bd += tb156d * c9 + tb156 * c9d;
      c9b += tb156 * m1_9;
      c9bd += tb156d * m1_9 + tb156 * m1_9d;
      c9b += tb155 * (m1_9 * c9);
      c9bd += tb155d * (m1_9 * c9) + tb155 * (m1_9d * c9 + m1_9 * c9d);
      c9b += tb152 * (m1_9 * c9 * c9);
      c9bd += tb152d * (m1_9 * c9 * c9) + tb152 * ((m1_9d * c9 + m1_9 * c9d) * c9 + m1_9 * c9 *
          c9d);
      t48b = -(tb152 * t49);
      t48bd = -(tb152d * t49 + tb152 * t49d);
      h9b += t48b * 6.0;
      h9bd += t48bd * 6.0;
      e9b += slope13_3b;
      e9bd += slope13_3bd;
      h9b -= slope13_3b * (m1_9 - m0_9) / 6.0;
      h9bd -= (slope13_3bd * (m1_9 - m0_9) + slope13_3b * (m1_9d - m0_9d)) / 6.0;
      tb151 = slope13_3b * (h9 / 6.0);
      tb151d = slope13_3bd * (h9 / 6.0) + slope13_3b * (h9d / 6.0);
      m1_9b -= tb151;
      m1_9bd -= tb151d;
      m0_9b += tb151;
      m0_9bd += tb151d;
    }
    tb148 = e9b / h9;
    tb148d = (e9bd - tb148 * h9d) * (1.0 / h9);
    pb[t->driverpath[i] + k12 + 1] += tb148;
    pbd[t->driverpath[i] + k12 + 1] += tb148d;
    pb[t->driverpath[i] + k12] -= tb148;
    pbd[t->driverpath[i] + k12] -= tb148d;
    h9b -= tb148 * e9;
    h9bd -= tb148d * e9 + tb148 * e9d;
    path0b[t->driverrow[i] + k12 + 1][MAGGI_PATH_X] += m1_9b;
    path0bd[t->driverrow[i] + k12 + 1][MAGGI_PATH_X] += m1_9bd;
    path0b[t->driverrow[i] + k12][MAGGI_PATH_X] += m0_9b;
    path0bd[t->driverrow[i] + k12][MAGGI_PATH_X] += m0_9bd;
    s4b += c9b;
    s4bd += c9bd;
    path0b[t->driverrow[i] + k12][MAGGI_PATH_S] -= c9b;
    path0bd[t->driverrow[i] + k12][MAGGI_PATH_S] -= c9bd;
    path0b[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] += a10b;
    path0bd[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] += a10bd;
    s4b -= a10b;
    s4bd -= a10bd;
    path0b[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] += h9b;
    path0bd[t->driverrow[i] + k12 + 1][MAGGI_PATH_S] += h9bd;
    path0b[t->driverrow[i] + k12][MAGGI_PATH_S] -= h9b;
    path0bd[t->driverrow[i] + k12][MAGGI_PATH_S] -= h9bd;
    s3b = s4b;
    s3bd = s4bd;
    t47b = -s4b;
    t47bd = -s4bd;
    tb147 = t47b / slope12;
    tb147d = (t47bd - tb147 * slope12d) * (1.0 / slope12);
    g4b = tb147;
    g4bd = tb147d;
    slope12b = -(tb147 * t47);
    slope12bd = -(tb147d * t47 + tb147 * t47d);
    x31b = slope12b * x31;
    x31bd = slope12bd * x31 + slope12b * x31d;
    x31b += slope12b * x31;
    x31bd += slope12bd * x31 + slope12b * x31d;
    y31b = slope12b * y31;
    y31bd = slope12bd * y31 + slope12b * y31d;
    y31b += slope12b * y31;
    y31bd += slope12bd * y31 + slope12b * y31d;
    tb145 = slope12b * x32;
    tb145d = slope12bd * x32 + slope12b * x32d;
    x30b = tb145;
    x30bd = tb145d;
    Pb[0] -= tb145;
    Pbd[0] -= tb145d;
    x32b = slope12b * (x30 - P[0]);
    x32bd = slope12bd * (x30 - P[0]) + slope12b * (x30d - Pd[0]);
    tb146 = slope12b * y32;
    tb146d = slope12bd * y32 + slope12b * y32d;
    y30b = tb146;
    y30bd = tb146d;
    Pb[1] -= tb146;
    Pbd[1] -= tb146d;
    y32b = slope12b * (y30 - P[1]);
    y32bd = slope12bd * (y30 - P[1]) + slope12b * (y30d - Pd[1]);
    tb143 = g4b * x31;
    /* one step of Newton's method; C, C', C'' at s */
    tb143d = g4bd * x31 + g4b * x31d;
    x30b += tb143;
    x30bd += tb143d;
    Pb[0] -= tb143;
    Pbd[0] -= tb143d;
    x31b += g4b * (x30 - P[0]);
    x31bd += g4bd * (x30 - P[0]) + g4b * (x30d - Pd[0]);
    tb144 = g4b * y31;
    tb144d = g4bd * y31 + g4b * y31d;
    y30b += tb144;
    y30bd += tb144d;
    Pb[1] -= tb144;
    Pbd[1] -= tb144d;
    y31b += g4b * (y30 - P[1]);
    y31bd += g4bd * (y30 - P[1]) + g4b * (y30d - Pd[1]);
    a9b = 0.0;
    a9bd = 0.0;
    c8b = 0.0;
    c8bd = 0.0;
    e8b = 0.0;
    e8bd = 0.0;
    h8b = 0.0;
    h8bd = 0.0;
    m0_8b = 0.0;
    m0_8bd = 0.0;
    m1_8b = 0.0;
    m1_8bd = 0.0;
    if (MAGGI_RE(c8) < 0.0) {
      slope11 = e8 - h8 / 6.0 * (2.0 * m0_8 + m1_8);
      slope11d = e8d - (h8d / 6.0 * (2.0 * m0_8 + m1_8) + h8 / 6.0 * (2.0 * m0_8d + m1_8d));
      y32b = 0.0;
      y32bd = 0.0;
      slope11b = y31b;
      slope11bd = y31bd;
      y31b = 0.0;
      y31bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k11] += y30b;
      pbd[t->driverpath[i] + t->drivern[i] + k11] += y30bd;
      slope11b += y30b * c8;
      slope11bd += y30bd * c8 + y30b * c8d;
      c8b += y30b * slope11;
      c8bd += y30bd * slope11 + y30b * slope11d;
      y30b = 0.0;
      y30bd = 0.0;
      e8b += slope11b;
      e8bd += slope11bd;
      h8b -= slope11b * (2.0 * m0_8 + m1_8) / 6.0;
      h8bd -= (slope11bd * (2.0 * m0_8 + m1_8) + slope11b * (2.0 * m0_8d + m1_8d)) / 6.0;
      tb129 = slope11b * (h8 / 6.0);
      tb129d = slope11bd * (h8 / 6.0) + slope11b * (h8d / 6.0);
      m0_8b -= tb129 * 2.0;
      m0_8bd -= tb129d * 2.0;
      m1_8b -= tb129;
      m1_8bd -= tb129d;
    } else if (MAGGI_RE(a9) < 0.0) {
      slope11_2 = e8 + h8 / 6.0 * (m0_8 + 2.0 * m1_8);
      slope11_2d = e8d + (h8d / 6.0 * (m0_8 + 2.0 * m1_8) + h8 / 6.0 * (m0_8d + 2.0 * m1_8d));
      y32b = 0.0;
      y32bd = 0.0;
      slope11_2b = y31b;
      slope11_2bd = y31bd;
      y31b = 0.0;
      y31bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k11 + 1] += y30b;
      pbd[t->driverpath[i] + t->drivern[i] + k11 + 1] += y30bd;
      slope11_2b -= y30b * a9;
      slope11_2bd -= y30bd * a9 + y30b * a9d;
      a9b -= y30b * slope11_2;
      a9bd -= y30bd * slope11_2 + y30b * slope11_2d;
      y30b = 0.0;
      y30bd = 0.0;
      e8b += slope11_2b;
      e8bd += slope11_2bd;
      h8b += slope11_2b * (m0_8 + 2.0 * m1_8) / 6.0;
      h8bd += (slope11_2bd * (m0_8 + 2.0 * m1_8) + slope11_2b * (m0_8d + 2.0 * m1_8d)) / 6.0;
      tb130 = slope11_2b * (h8 / 6.0);
      tb130d = slope11_2bd * (h8 / 6.0) + slope11_2b * (h8d / 6.0);
      m0_8b += tb130;
      m0_8bd += tb130d;
      m1_8b += tb130 * 2.0;
      m1_8bd += tb130d * 2.0;
    } else {
      slope11_3 = e8 - h8 / 6.0 * (m1_8 - m0_8);
      slope11_3d = e8d - (h8d / 6.0 * (m1_8 - m0_8) + h8 / 6.0 * (m1_8d - m0_8d));
      t42 = 6.0 * h8;
      t42d = 6.0 * h8d;
      t43 = (m0_8 * a9 * a9 * a9 + m1_8 * c8 * c8 * c8) / t42;
      t43d = (((m0_8d * a9 + m0_8 * a9d) * a9 + m0_8 * a9 * a9d) * a9 + m0_8 * a9 * a9 * a9d +
          (((m1_8d * c8 + m1_8 * c8d) * c8 + m1_8 * c8 * c8d) * c8 + m1_8 * c8 * c8 * c8d) - t43 *
          t42d) * (1.0 / t42);
      t44 = 2.0 * h8;
      t44d = 2.0 * h8d;
      t45 = (m1_8 * c8 * c8 - m0_8 * a9 * a9) / t44;
      t45d = ((m1_8d * c8 + m1_8 * c8d) * c8 + m1_8 * c8 * c8d - ((m0_8d * a9 + m0_8 * a9d) * a9 +
          m0_8 * a9 * a9d) - t45 * t44d) * (1.0 / t44);
      t46 = (m0_8 * a9 + m1_8 * c8) / h8;
      t46d = (m0_8d * a9 + m0_8 * a9d + (m1_8d * c8 + m1_8 * c8d) - t46 * h8d) * (1.0 / h8);
      t46b = y32b;
      t46bd = y32bd;
      y32b = 0.0;
      y32bd = 0.0;
      tb142 = t46b / h8;
      tb142d = (t46bd - tb142 * h8d) * (1.0 / h8);
      m0_8b += tb142 * a9;
      m0_8bd += tb142d * a9 + tb142 * a9d;
      a9b += tb142 * m0_8;
      a9bd += tb142d * m0_8 + tb142 * m0_8d;
      m1_8b += tb142 * c8;
      m1_8bd += tb142d * c8 + tb142 * c8d;
      c8b += tb142 * m1_8;
      c8bd += tb142d * m1_8 + tb142 * m1_8d;
      h8b -= tb142 * t46;
      h8bd -= tb142d * t46 + tb142 * t46d;
      t45b = y31b;
      t45bd = y31bd;
      slope11_3b = y31b;
      slope11_3bd = y31bd;
      y31b = 0.0;
      y31bd = 0.0;
      tb139 = t45b / t44;
      tb139d = (t45bd - tb139 * t44d) * (1.0 / t44);
      tb140 = tb139 * c8;
      tb140d = tb139d * c8 + tb139 * c8d;
      m1_8b += tb140 * c8;
      m1_8bd += tb140d * c8 + tb140 * c8d;
      c8b += tb140 * m1_8;
      c8bd += tb140d * m1_8 + tb140 * m1_8d;
      c8b += tb139 * (m1_8 * c8);
      c8bd += tb139d * (m1_8 * c8) + tb139 * (m1_8d * c8 + m1_8 * c8d);
      tb141 = tb139 * a9;
      tb141d = tb139d * a9 + tb139 * a9d;
      m0_8b -= tb141 * a9;
      m0_8bd -= tb141d * a9 + tb141 * a9d;
      a9b -= tb141 * m0_8;
      a9bd -= tb141d * m0_8 + tb141 * m0_8d;
      a9b -= tb139 * (m0_8 * a9);
      a9bd -= tb139d * (m0_8 * a9) + tb139 * (m0_8d * a9 + m0_8 * a9d);
      t44b = -(tb139 * t45);
      t44bd = -(tb139d * t45 + tb139 * t45d);
      h8b += t44b * 2.0;
      h8bd += t44bd * 2.0;
      t43b = y30b;
      t43bd = y30bd;
      pb[t->driverpath[i] + t->drivern[i] + k11] += y30b;
      pbd[t->driverpath[i] + t->drivern[i] + k11] += y30bd;
      tb137 = y30b / 6.0;
      tb137d = y30bd / 6.0;
      tb138 = tb137 * h8;
      tb138d = tb137d * h8 + tb137 * h8d;
      m0_8b -= tb138 * h8;
      m0_8bd -= tb138d * h8 + tb138 * h8d;
      h8b -= tb138 * m0_8;
      h8bd -= tb138d * m0_8 + tb138 * m0_8d;
      h8b -= tb137 * (m0_8 * h8);
      h8bd -= tb137d * (m0_8 * h8) + tb137 * (m0_8d * h8 + m0_8 * h8d);
      slope11_3b += y30b * c8;
      slope11_3bd += y30bd * c8 + y30b * c8d;
      c8b += y30b * slope11_3;
      c8bd += y30bd * slope11_3 + y30b * slope11_3d;
      y30b = 0.0;
      y30bd = 0.0;
      tb132 = t43b / t42;
      tb132d = (t43bd - tb132 * t42d) * (1.0 / t42);
      tb133 = tb132 * a9;
      tb133d = tb132d * a9 + tb132 * a9d;
      tb134 = tb133 * a9;
      tb134d = tb133d * a9 + tb133 * a9d;
      m0_8b += tb134 * a9;
      m0_8bd += tb134d * a9 + tb134 * a9d;
      a9b += tb134 * m0_8;
      a9bd += tb134d * m0_8 + tb134 * m0_8d;
      a9b += tb133 * (m0_8 * a9);
      a9bd += tb133d * (m0_8 * a9) + tb133 * (m0_8d * a9 + m0_8 * a9d);
      a9b += tb132 * (m0_8 * a9 * a9);
      a9bd += tb132d * (m0_8 * a9 * a9) + tb132 * ((m0_8d * a9 + m0_8 * a9d) * a9 + m0_8 * a9 *
          a9d);
      tb135 = tb132 * c8;
      tb135d = tb132d * c8 + tb132 * c8d;
      tb136 = tb135 * c8;
      tb136d = tb135d * c8 + tb135 * c8d;
      m1_8b += tb136 * c8;
      m1_8bd += tb136d * c8 + tb136 * c8d;
      c8b += tb136 * m1_8;
      c8bd += tb136d * m1_8 + tb136 * m1_8d;
      c8b += tb135 * (m1_8 * c8);
      c8bd += tb135d * (m1_8 * c8) + tb135 * (m1_8d * c8 + m1_8 * c8d);
      c8b += tb132 * (m1_8 * c8 * c8);
      c8bd += tb132d * (m1_8 * c8 * c8) + tb132 * ((m1_8d * c8 + m1_8 * c8d) * c8 + m1_8 * c8 *
          c8d);
      t42b = -(tb132 * t43);
      t42bd = -(tb132d * t43 + tb132 * t43d);
      h8b += t42b * 6.0;
      h8bd += t42bd * 6.0;
      e8b += slope11_3b;
      e8bd += slope11_3bd;
      h8b -= slope11_3b * (m1_8 - m0_8) / 6.0;
      h8bd -= (slope11_3bd * (m1_8 - m0_8) + slope11_3b * (m1_8d - m0_8d)) / 6.0;
      tb131 = slope11_3b * (h8 / 6.0);
      tb131d = slope11_3bd * (h8 / 6.0) + slope11_3b * (h8d / 6.0);
      m1_8b -= tb131;
      m1_8bd -= tb131d;
      m0_8b += tb131;
      m0_8bd += tb131d;
    }
    tb128 = e8b / h8;
    tb128d = (e8bd - tb128 * h8d) * (1.0 / h8);
    pb[t->driverpath[i] + t->drivern[i] + k11 + 1] += tb128;
    pbd[t->driverpath[i] + t->drivern[i] + k11 + 1] += tb128d;
    pb[t->driverpath[i] + t->drivern[i] + k11] -= tb128;
    pbd[t->driverpath[i] + t->drivern[i] + k11] -= tb128d;
    h8b -= tb128 * e8;
    h8bd -= tb128d * e8 + tb128 * e8d;
    path0b[t->driverrow[i] + k11 + 1][MAGGI_PATH_Y] += m1_8b;
    path0bd[t->driverrow[i] + k11 + 1][MAGGI_PATH_Y] += m1_8bd;
    path0b[t->driverrow[i] + k11][MAGGI_PATH_Y] += m0_8b;
    path0bd[t->driverrow[i] + k11][MAGGI_PATH_Y] += m0_8bd;
    s3b += c8b;
    s3bd += c8bd;
    path0b[t->driverrow[i] + k11][MAGGI_PATH_S] -= c8b;
    path0bd[t->driverrow[i] + k11][MAGGI_PATH_S] -= c8bd;
    path0b[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] += a9b;
    path0bd[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] += a9bd;
    s3b -= a9b;
    s3bd -= a9bd;
    path0b[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] += h8b;
    path0bd[t->driverrow[i] + k11 + 1][MAGGI_PATH_S] += h8bd;
    path0b[t->driverrow[i] + k11][MAGGI_PATH_S] -= h8b;
    path0bd[t->driverrow[i] + k11][MAGGI_PATH_S] -= h8bd;
    a8b = 0.0;
    a8bd = 0.0;
    c7b = 0.0;
    c7bd = 0.0;
    e7b = 0.0;
    e7bd = 0.0;
    h7b = 0.0;
    h7bd = 0.0;
    m0_7b = 0.0;
    m0_7bd = 0.0;
    m1_7b = 0.0;
    m1_7bd = 0.0;
    if (MAGGI_RE(c7) < 0.0) {
      slope10 = e7 - h7 / 6.0 * (2.0 * m0_7 + m1_7);
      slope10d = e7d - (h7d / 6.0 * (2.0 * m0_7 + m1_7) + h7 / 6.0 * (2.0 * m0_7d + m1_7d));
      x32b = 0.0;
      x32bd = 0.0;
      slope10b = x31b;
      slope10bd = x31bd;
      x31b = 0.0;
      x31bd = 0.0;
      pb[t->driverpath[i] + k10] += x30b;
      pbd[t->driverpath[i] + k10] += x30bd;
      slope10b += x30b * c7;
      slope10bd += x30bd * c7 + x30b * c7d;
      c7b += x30b * slope10;
      c7bd += x30bd * slope10 + x30b * slope10d;
      x30b = 0.0;
      x30bd = 0.0;
      e7b += slope10b;
      e7bd += slope10bd;
      h7b -= slope10b * (2.0 * m0_7 + m1_7) / 6.0;
      h7bd -= (slope10bd * (2.0 * m0_7 + m1_7) + slope10b * (2.0 * m0_7d + m1_7d)) / 6.0;
      tb114 = slope10b * (h7 / 6.0);
      tb114d = slope10bd * (h7 / 6.0) + slope10b * (h7d / 6.0);
      m0_7b -= tb114 * 2.0;
      m0_7bd -= tb114d * 2.0;
      m1_7b -= tb114;
      m1_7bd -= tb114d;
    } else if (MAGGI_RE(a8) < 0.0) {
      slope10_2 = e7 + h7 / 6.0 * (m0_7 + 2.0 * m1_7);
      slope10_2d = e7d + (h7d / 6.0 * (m0_7 + 2.0 * m1_7) + h7 / 6.0 * (m0_7d + 2.0 * m1_7d));
      x32b = 0.0;
      x32bd = 0.0;
      slope10_2b = x31b;
      slope10_2bd = x31bd;
      x31b = 0.0;
      x31bd = 0.0;
      pb[t->driverpath[i] + k10 + 1] += x30b;
      pbd[t->driverpath[i] + k10 + 1] += x30bd;
      slope10_2b -= x30b * a8;
      slope10_2bd -= x30bd * a8 + x30b * a8d;
      a8b -= x30b * slope10_2;
      a8bd -= x30bd * slope10_2 + x30b * slope10_2d;
      x30b = 0.0;
      x30bd = 0.0;
      e7b += slope10_2b;
      e7bd += slope10_2bd;
      h7b += slope10_2b * (m0_7 + 2.0 * m1_7) / 6.0;
      h7bd += (slope10_2bd * (m0_7 + 2.0 * m1_7) + slope10_2b * (m0_7d + 2.0 * m1_7d)) / 6.0;
      tb115 = slope10_2b * (h7 / 6.0);
      tb115d = slope10_2bd * (h7 / 6.0) + slope10_2b * (h7d / 6.0);
      m0_7b += tb115;
      m0_7bd += tb115d;
      m1_7b += tb115 * 2.0;
      m1_7bd += tb115d * 2.0;
    } else {
      slope10_3 = e7 - h7 / 6.0 * (m1_7 - m0_7);
      slope10_3d = e7d - (h7d / 6.0 * (m1_7 - m0_7) + h7 / 6.0 * (m1_7d - m0_7d));
      t37 = 6.0 * h7;
      t37d = 6.0 * h7d;
      t38 = (m0_7 * a8 * a8 * a8 + m1_7 * c7 * c7 * c7) / t37;
      t38d = (((m0_7d * a8 + m0_7 * a8d) * a8 + m0_7 * a8 * a8d) * a8 + m0_7 * a8 * a8 * a8d +
          (((m1_7d * c7 + m1_7 * c7d) * c7 + m1_7 * c7 * c7d) * c7 + m1_7 * c7 * c7 * c7d) - t38 *
          t37d) * (1.0 / t37);
      t39 = 2.0 * h7;
      t39d = 2.0 * h7d;
      t40 = (m1_7 * c7 * c7 - m0_7 * a8 * a8) / t39;
      t40d = ((m1_7d * c7 + m1_7 * c7d) * c7 + m1_7 * c7 * c7d - ((m0_7d * a8 + m0_7 * a8d) * a8 +
          m0_7 * a8 * a8d) - t40 * t39d) * (1.0 / t39);
      t41 = (m0_7 * a8 + m1_7 * c7) / h7;
      t41d = (m0_7d * a8 + m0_7 * a8d + (m1_7d * c7 + m1_7 * c7d) - t41 * h7d) * (1.0 / h7);
      t41b = x32b;
      t41bd = x32bd;
      x32b = 0.0;
      x32bd = 0.0;
      tb127 = t41b / h7;
      tb127d = (t41bd - tb127 * h7d) * (1.0 / h7);
      m0_7b += tb127 * a8;
      m0_7bd += tb127d * a8 + tb127 * a8d;
      a8b += tb127 * m0_7;
      a8bd += tb127d * m0_7 + tb127 * m0_7d;
      m1_7b += tb127 * c7;
      m1_7bd += tb127d * c7 + tb127 * c7d;
      c7b += tb127 * m1_7;
      c7bd += tb127d * m1_7 + tb127 * m1_7d;
      h7b -= tb127 * t41;
      h7bd -= tb127d * t41 + tb127 * t41d;
      t40b = x31b;
      t40bd = x31bd;
      slope10_3b = x31b;
      slope10_3bd = x31bd;
      x31b = 0.0;
      x31bd = 0.0;
      tb124 = t40b / t39;
      tb124d = (t40bd - tb124 * t39d) * (1.0 / t39);
      tb125 = tb124 * c7;
      tb125d = tb124d * c7 + tb124 * c7d;
      m1_7b += tb125 * c7;
      m1_7bd += tb125d * c7 + tb125 * c7d;
      c7b += tb125 * m1_7;
      c7bd += tb125d * m1_7 + tb125 * m1_7d;
      c7b += tb124 * (m1_7 * c7);
      c7bd += tb124d * (m1_7 * c7) + tb124 * (m1_7d * c7 + m1_7 * c7d);
      tb126 = tb124 * a8;
      tb126d = tb124d * a8 + tb124 * a8d;
      m0_7b -= tb126 * a8;
      m0_7bd -= tb126d * a8 + tb126 * a8d;
      a8b -= tb126 * m0_7;
      a8bd -= tb126d * m0_7 + tb126 * m0_7d;
      a8b -= tb124 * (m0_7 * a8);
      a8bd -= tb124d * (m0_7 * a8) + tb124 * (m0_7d * a8 + m0_7 * a8d);
      t39b = -(tb124 * t40);
      t39bd = -(tb124d * t40 + tb124 * t40d);
      h7b += t39b * 2.0;
      h7bd += t39bd * 2.0;
      t38b = x30b;
      t38bd = x30bd;
      pb[t->driverpath[i] + k10] += x30b;
      pbd[t->driverpath[i] + k10] += x30bd;
      tb122 = x30b / 6.0;
      tb122d = x30bd / 6.0;
      tb123 = tb122 * h7;
      tb123d = tb122d * h7 + tb122 * h7d;
      m0_7b -= tb123 * h7;
      m0_7bd -= tb123d * h7 + tb123 * h7d;
      h7b -= tb123 * m0_7;
      h7bd -= tb123d * m0_7 + tb123 * m0_7d;
      h7b -= tb122 * (m0_7 * h7);
      h7bd -= tb122d * (m0_7 * h7) + tb122 * (m0_7d * h7 + m0_7 * h7d);
      slope10_3b += x30b * c7;
      slope10_3bd += x30bd * c7 + x30b * c7d;
      c7b += x30b * slope10_3;
      c7bd += x30bd * slope10_3 + x30b * slope10_3d;
      x30b = 0.0;
      x30bd = 0.0;
      tb117 = t38b / t37;
      tb117d = (t38bd - tb117 * t37d) * (1.0 / t37);
      tb118 = tb117 * a8;
      tb118d = tb117d * a8 + tb117 * a8d;
      tb119 = tb118 * a8;
      tb119d = tb118d * a8 + tb118 * a8d;
      m0_7b += tb119 * a8;
      m0_7bd += tb119d * a8 + tb119 * a8d;
      a8b += tb119 * m0_7;
      a8bd += tb119d * m0_7 + tb119 * m0_7d;
      a8b += tb118 * (m0_7 * a8);
      a8bd += tb118d * (m0_7 * a8) + tb118 * (m0_7d * a8 + m0_7 * a8d);
      a8b += tb117 * (m0_7 * a8 * a8);
      a8bd += tb117d * (m0_7 * a8 * a8) + tb117 * ((m0_7d * a8 + m0_7 * a8d) * a8 + m0_7 * a8 *
          a8d);
      tb120 = tb117 * c7;
      tb120d = tb117d * c7 + tb117 * c7d;
      tb121 = tb120 * c7;
      tb121d = tb120d * c7 + tb120 * c7d;
      m1_7b += tb121 * c7;
      m1_7bd += tb121d * c7 + tb121 * c7d;
      c7b += tb121 * m1_7;
      c7bd += tb121d * m1_7 + tb121 * m1_7d;
      c7b += tb120 * (m1_7 * c7);
      c7bd += tb120d * (m1_7 * c7) + tb120 * (m1_7d * c7 + m1_7 * c7d);
      c7b += tb117 * (m1_7 * c7 * c7);
      c7bd += tb117d * (m1_7 * c7 * c7) + tb117 * ((m1_7d * c7 + m1_7 * c7d) * c7 + m1_7 * c7 *
          c7d);
      t37b = -(tb117 * t38);
      t37bd = -(tb117d * t38 + tb117 * t38d);
      h7b += t37b * 6.0;
      h7bd += t37bd * 6.0;
      e7b += slope10_3b;
      e7bd += slope10_3bd;
      h7b -= slope10_3b * (m1_7 - m0_7) / 6.0;
      h7bd -= (slope10_3bd * (m1_7 - m0_7) + slope10_3b * (m1_7d - m0_7d)) / 6.0;
      tb116 = slope10_3b * (h7 / 6.0);
      tb116d = slope10_3bd * (h7 / 6.0) + slope10_3b * (h7d / 6.0);
      m1_7b -= tb116;
      m1_7bd -= tb116d;
      m0_7b += tb116;
      m0_7bd += tb116d;
    }
    tb113 = e7b / h7;
    tb113d = (e7bd - tb113 * h7d) * (1.0 / h7);
    pb[t->driverpath[i] + k10 + 1] += tb113;
    pbd[t->driverpath[i] + k10 + 1] += tb113d;
    pb[t->driverpath[i] + k10] -= tb113;
    pbd[t->driverpath[i] + k10] -= tb113d;
    h7b -= tb113 * e7;
    h7bd -= tb113d * e7 + tb113 * e7d;
    path0b[t->driverrow[i] + k10 + 1][MAGGI_PATH_X] += m1_7b;
    path0bd[t->driverrow[i] + k10 + 1][MAGGI_PATH_X] += m1_7bd;
    path0b[t->driverrow[i] + k10][MAGGI_PATH_X] += m0_7b;
    path0bd[t->driverrow[i] + k10][MAGGI_PATH_X] += m0_7bd;
    s3b += c7b;
    s3bd += c7bd;
    path0b[t->driverrow[i] + k10][MAGGI_PATH_S] -= c7b;
    path0bd[t->driverrow[i] + k10][MAGGI_PATH_S] -= c7bd;
    path0b[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] += a8b;
    path0bd[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] += a8bd;
    s3b -= a8b;
    s3bd -= a8bd;
    path0b[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] += h7b;
    path0bd[t->driverrow[i] + k10 + 1][MAGGI_PATH_S] += h7bd;
    path0b[t->driverrow[i] + k10][MAGGI_PATH_S] -= h7b;
    path0bd[t->driverrow[i] + k10][MAGGI_PATH_S] -= h7bd;
    s2b = s3b;
    s2bd = s3bd;
    t36b = -s3b;
    t36bd = -s3bd;
    tb112 = t36b / slope9;
    tb112d = (t36bd - tb112 * slope9d) * (1.0 / slope9);
    g3b = tb112;
    g3bd = tb112d;
    slope9b = -(tb112 * t36);
    slope9bd = -(tb112d * t36 + tb112 * t36d);
    x2_5b = slope9b * x2_5;
    x2_5bd = slope9bd * x2_5 + slope9b * x2_5d;
    x2_5b += slope9b * x2_5;
    x2_5bd += slope9bd * x2_5 + slope9b * x2_5d;
    y21b = slope9b * y21;
    y21bd = slope9bd * y21 + slope9b * y21d;
    y21b += slope9b * y21;
    y21bd += slope9bd * y21 + slope9b * y21d;
    tb110 = slope9b * x2_6;
    tb110d = slope9bd * x2_6 + slope9b * x2_6d;
    x2_4b = tb110;
    x2_4bd = tb110d;
    Pb[0] -= tb110;
    Pbd[0] -= tb110d;
    x2_6b = slope9b * (x2_4 - P[0]);
    x2_6bd = slope9bd * (x2_4 - P[0]) + slope9b * (x2_4d - Pd[0]);
    tb111 = slope9b * y22;
    tb111d = slope9bd * y22 + slope9b * y22d;
    y20b = tb111;
    y20bd = tb111d;
    Pb[1] -= tb111;
    Pbd[1] -= tb111d;
    y22b = slope9b * (y20 - P[1]);
    y22bd = slope9bd * (y20 - P[1]) + slope9b * (y20d - Pd[1]);
    tb108 = g3b * x2_5;
    /* one step of Newton's method; C, C', C'' at s */
    tb108d = g3bd * x2_5 + g3b * x2_5d;
    x2_4b += tb108;
    x2_4bd += tb108d;
    Pb[0] -= tb108;
    Pbd[0] -= tb108d;
    x2_5b += g3b * (x2_4 - P[0]);
    x2_5bd += g3bd * (x2_4 - P[0]) + g3b * (x2_4d - Pd[0]);
    tb109 = g3b * y21;
    tb109d = g3bd * y21 + g3b * y21d;
    y20b += tb109;
    y20bd += tb109d;
    Pb[1] -= tb109;
    Pbd[1] -= tb109d;
    y21b += g3b * (y20 - P[1]);
    y21bd += g3bd * (y20 - P[1]) + g3b * (y20d - Pd[1]);
    a7b = 0.0;
    a7bd = 0.0;
    c6b = 0.0;
    c6bd = 0.0;
    e6b = 0.0;
    e6bd = 0.0;
    h6b = 0.0;
    h6bd = 0.0;
    m0_6b = 0.0;
    m0_6bd = 0.0;
    m1_6b = 0.0;
    m1_6bd = 0.0;
    if (MAGGI_RE(c6) < 0.0) {
      slope8 = e6 - h6 / 6.0 * (2.0 * m0_6 + m1_6);
      slope8d = e6d - (h6d / 6.0 * (2.0 * m0_6 + m1_6) + h6 / 6.0 * (2.0 * m0_6d + m1_6d));
      y22b = 0.0;
      y22bd = 0.0;
      slope8b = y21b;
      slope8bd = y21bd;
      y21b = 0.0;
      y21bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k9] += y20b;
      pbd[t->driverpath[i] + t->drivern[i] + k9] += y20bd;
      slope8b += y20b * c6;
      slope8bd += y20bd * c6 + y20b * c6d;
      c6b += y20b * slope8;
      c6bd += y20bd * slope8 + y20b * slope8d;
      y20b = 0.0;
      y20bd = 0.0;
      e6b += slope8b;
      e6bd += slope8bd;
      h6b -= slope8b * (2.0 * m0_6 + m1_6) / 6.0;
      h6bd -= (slope8bd * (2.0 * m0_6 + m1_6) + slope8b * (2.0 * m0_6d + m1_6d)) / 6.0;
      tb94 = slope8b * (h6 / 6.0);
      tb94d = slope8bd * (h6 / 6.0) + slope8b * (h6d / 6.0);
      m0_6b -= tb94 * 2.0;
      m0_6bd -= tb94d * 2.0;
      m1_6b -= tb94;
      m1_6bd -= tb94d;
    } else if (MAGGI_RE(a7) < 0.0) {
      slope8_2 = e6 + h6 / 6.0 * (m0_6 + 2.0 * m1_6);
      slope8_2d = e6d + (h6d / 6.0 * (m0_6 + 2.0 * m1_6) + h6 / 6.0 * (m0_6d + 2.0 * m1_6d));
      y22b = 0.0;
      y22bd = 0.0;
      slope8_2b = y21b;
      slope8_2bd = y21bd;
      y21b = 0.0;
      y21bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k9 + 1] += y20b;
      pbd[t->driverpath[i] + t->drivern[i] + k9 + 1] += y20bd;
      slope8_2b -= y20b * a7;
      slope8_2bd -= y20bd * a7 + y20b * a7d;
      a7b -= y20b * slope8_2;
      a7bd -= y20bd * slope8_2 + y20b * slope8_2d;
      y20b = 0.0;
      y20bd = 0.0;
      e6b += slope8_2b;
      e6bd += slope8_2bd;
      h6b += slope8_2b * (m0_6 + 2.0 * m1_6) / 6.0;
      h6bd += (slope8_2bd * (m0_6 + 2.0 * m1_6) + slope8_2b * (m0_6d + 2.0 * m1_6d)) / 6.0;
      tb95 = slope8_2b * (h6 / 6.0);
      tb95d = slope8_2bd * (h6 / 6.0) + slope8_2b * (h6d / 6.0);
      m0_6b += tb95;
      m0_6bd += tb95d;
      m1_6b += tb95 * 2.0;
      m1_6bd += tb95d * 2.0;
    } else {
      slope8_3 = e6 - h6 / 6.0 * (m1_6 - m0_6);
      slope8_3d = e6d - (h6d / 6.0 * (m1_6 - m0_6) + h6 / 6.0 * (m1_6d - m0_6d));
      t31 = 6.0 * h6;
      t31d = 6.0 * h6d;
      t32 = (m0_6 * a7 * a7 * a7 + m1_6 * c6 * c6 * c6) / t31;
      t32d = (((m0_6d * a7 + m0_6 * a7d) * a7 + m0_6 * a7 * a7d) * a7 + m0_6 * a7 * a7 * a7d +
          (((m1_6d * c6 + m1_6 * c6d) * c6 + m1_6 * c6 * c6d) * c6 + m1_6 * c6 * c6 * c6d) - t32 *
          t31d) * (1.0 / t31);
      t33 = 2.0 * h6;
      t33d = 2.0 * h6d;
      t34 = (m1_6 * c6 * c6 - m0_6 * a7 * a7) / t33;
      t34d = ((m1_6d * c6 + m1_6 * c6d) * c6 + m1_6 * c6 * c6d - ((m0_6d * a7 + m0_6 * a7d) * a7 +
          m0_6 * a7 * a7d) - t34 * t33d) * (1.0 / t33);
      t35 = (m0_6 * a7 + m1_6 * c6) / h6;
      t35d = (m0_6d * a7 + m0_6 * a7d + (m1_6d * c6 + m1_6 * c6d) - t35 * h6d) * (1.0 / h6);
      t35b = y22b;
      t35bd = y22bd;
      y22b = 0.0;
      y22bd = 0.0;
      tb107 = t35b / h6;
      tb107d = (t35bd - tb107 * h6d) * (1.0 / h6);
      m0_6b += tb107 * a7;
      m0_6bd += tb107d * a7 + tb107 * a7d;
      a7b += tb107 * m0_6;
      a7bd += tb107d * m0_6 + tb107 * m0_6d;
      m1_6b += tb107 * c6;
      m1_6bd += tb107d * c6 + tb107 * c6d;
      c6b += tb107 * m1_6;
      c6bd += tb107d * m1_6 + tb107 * m1_6d;
      h6b -= tb107 * t35;
      h6bd -= tb107d * t35 + tb107 * t35d;
      t34b = y21b;
      t34bd = y21bd;
      slope8_3b = y21b;
      slope8_3bd = y21bd;
      y21b = 0.0;
      y21bd = 0.0;
      tb104 = t34b / t33;
      tb104d = (t34bd - tb104 * t33d) * (1.0 / t33);
      tb105 = tb104 * c6;
      tb105d = tb104d * c6 + tb104 * c6d;
      m1_6b += tb105 * c6;
      m1_6bd += tb105d * c6 + tb105 * c6d;
      c6b += tb105 * m1_6;
      c6bd += tb105d * m1_6 + tb105 * m1_6d;
      c6b += tb104 * (m1_6 * c6);
      c6bd += tb104d * (m1_6 * c6) + tb104 * (m1_6d * c6 + m1_6 * c6d);
      tb106 = tb104 * a7;
      tb106d = tb104d * a7 + tb104 * a7d;
      m0_6b -= tb106 * a7;
      m0_6bd -= tb106d * a7 + tb106 * a7d;
      a7b -= tb106 * m0_6;
      a7bd -= tb106d * m0_6 + tb106 * m0_6d;
      a7b -= tb104 * (m0_6 * a7);
      a7bd -= tb104d * (m0_6 * a7) + tb104 * (m0_6d * a7 + m0_6 * a7d);
      t33b = -(tb104 * t34);
      t33bd = -(tb104d * t34 + tb104 * t34d);
      h6b += t33b * 2.0;
      h6bd += t33bd * 2.0;
      t32b = y20b;
      t32bd = y20bd;
      pb[t->driverpath[i] + t->drivern[i] + k9] += y20b;
      pbd[t->driverpath[i] + t->drivern[i] + k9] += y20bd;
      tb102 = y20b / 6.0;
      tb102d = y20bd / 6.0;
      tb103 = tb102 * h6;
      tb103d = tb102d * h6 + tb102 * h6d;
      m0_6b -= tb103 * h6;
      m0_6bd -= tb103d * h6 + tb103 * h6d;
      h6b -= tb103 * m0_6;
      h6bd -= tb103d * m0_6 + tb103 * m0_6d;
      h6b -= tb102 * (m0_6 * h6);
      h6bd -= tb102d * (m0_6 * h6) + tb102 * (m0_6d * h6 + m0_6 * h6d);
      slope8_3b += y20b * c6;
      slope8_3bd += y20bd * c6 + y20b * c6d;
      c6b += y20b * slope8_3;
      c6bd += y20bd * slope8_3 + y20b * slope8_3d;
      y20b = 0.0;
      y20bd = 0.0;
      tb97 = t32b / t31;
      tb97d = (t32bd - tb97 * t31d) * (1.0 / t31);
      tb98 = tb97 * a7;
      tb98d = tb97d * a7 + tb97 * a7d;
      tb99 = tb98 * a7;
      tb99d = tb98d * a7 + tb98 * a7d;
      m0_6b += tb99 * a7;
      m0_6bd += tb99d * a7 + tb99 * a7d;
      a7b += tb99 * m0_6;
      a7bd += tb99d * m0_6 + tb99 * m0_6d;
      a7b += tb98 * (m0_6 * a7);
      a7bd += tb98d * (m0_6 * a7) + tb98 * (m0_6d * a7 + m0_6 * a7d);
      a7b += tb97 * (m0_6 * a7 * a7);
      a7bd += tb97d * (m0_6 * a7 * a7) + tb97 * ((m0_6d * a7 + m0_6 * a7d) * a7 + m0_6 * a7 * a7d);
      tb100 = tb97 * c6;
      tb100d = tb97d * c6 + tb97 * c6d;
      tb101 = tb100 * c6;
      tb101d = tb100d * c6 + tb100 * c6d;
      m1_6b += tb101 * c6;
      m1_6bd += tb101d * c6 + tb101 * c6d;
      c6b += tb101 * m1_6;
      c6bd += tb101d * m1_6 + tb101 * m1_6d;
      c6b += tb100 * (m1_6 * c6);
      c6bd += tb100d * (m1_6 * c6) + tb100 * (m1_6d * c6 + m1_6 * c6d);
      c6b += tb97 * (m1_6 * c6 * c6);
      c6bd += tb97d * (m1_6 * c6 * c6) + tb97 * ((m1_6d * c6 + m1_6 * c6d) * c6 + m1_6 * c6 * c6d);
      t31b = -(tb97 * t32);
      t31bd = -(tb97d * t32 + tb97 * t32d);
      h6b += t31b * 6.0;
      h6bd += t31bd * 6.0;
      e6b += slope8_3b;
      e6bd += slope8_3bd;
      h6b -= slope8_3b * (m1_6 - m0_6) / 6.0;
      h6bd -= (slope8_3bd * (m1_6 - m0_6) + slope8_3b * (m1_6d - m0_6d)) / 6.0;
      tb96 = slope8_3b * (h6 / 6.0);
      tb96d = slope8_3bd * (h6 / 6.0) + slope8_3b * (h6d / 6.0);
      m1_6b -= tb96;
      m1_6bd -= tb96d;
      m0_6b += tb96;
      m0_6bd += tb96d;
    }
    tb93 = e6b / h6;
    tb93d = (e6bd - tb93 * h6d) * (1.0 / h6);
    pb[t->driverpath[i] + t->drivern[i] + k9 + 1] += tb93;
    pbd[t->driverpath[i] + t->drivern[i] + k9 + 1] += tb93d;
    pb[t->driverpath[i] + t->drivern[i] + k9] -= tb93;
    pbd[t->driverpath[i] + t->drivern[i] + k9] -= tb93d;
    h6b -= tb93 * e6;
    h6bd -= tb93d * e6 + tb93 * e6d;
    path0b[t->driverrow[i] + k9 + 1][MAGGI_PATH_Y] += m1_6b;
    path0bd[t->driverrow[i] + k9 + 1][MAGGI_PATH_Y] += m1_6bd;
    path0b[t->driverrow[i] + k9][MAGGI_PATH_Y] += m0_6b;
    path0bd[t->driverrow[i] + k9][MAGGI_PATH_Y] += m0_6bd;
    s2b += c6b;
    s2bd += c6bd;
    path0b[t->driverrow[i] + k9][MAGGI_PATH_S] -= c6b;
    path0bd[t->driverrow[i] + k9][MAGGI_PATH_S] -= c6bd;
    path0b[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] += a7b;
    path0bd[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] += a7bd;
    s2b -= a7b;
    s2bd -= a7bd;
    path0b[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] += h6b;
    path0bd[t->driverrow[i] + k9 + 1][MAGGI_PATH_S] += h6bd;
    path0b[t->driverrow[i] + k9][MAGGI_PATH_S] -= h6b;
    path0bd[t->driverrow[i] + k9][MAGGI_PATH_S] -= h6bd;
    a6b = 0.0;
    a6bd = 0.0;
    c5b = 0.0;
    c5bd = 0.0;
    e5b = 0.0;
    e5bd = 0.0;
    h5b = 0.0;
    h5bd = 0.0;
    m0_5b = 0.0;
    m0_5bd = 0.0;
    m1_5b = 0.0;
    m1_5bd = 0.0;
    if (MAGGI_RE(c5) < 0.0) {
      slope7 = e5 - h5 / 6.0 * (2.0 * m0_5 + m1_5);
      slope7d = e5d - (h5d / 6.0 * (2.0 * m0_5 + m1_5) + h5 / 6.0 * (2.0 * m0_5d + m1_5d));
      x2_6b = 0.0;
      x2_6bd = 0.0;
      slope7b = x2_5b;
      slope7bd = x2_5bd;
      x2_5b = 0.0;
      x2_5bd = 0.0;
      pb[t->driverpath[i] + k8] += x2_4b;
      pbd[t->driverpath[i] + k8] += x2_4bd;
      slope7b += x2_4b * c5;
      slope7bd += x2_4bd * c5 + x2_4b * c5d;
      c5b += x2_4b * slope7;
      c5bd += x2_4bd * slope7 + x2_4b * slope7d;
      x2_4b = 0.0;
      x2_4bd = 0.0;
      e5b += slope7b;
      e5bd += slope7bd;
      h5b -= slope7b * (2.0 * m0_5 + m1_5) / 6.0;
      h5bd -= (slope7bd * (2.0 * m0_5 + m1_5) + slope7b * (2.0 * m0_5d + m1_5d)) / 6.0;
      tb79 = slope7b * (h5 / 6.0);
      tb79d = slope7bd * (h5 / 6.0) + slope7b * (h5d / 6.0);
      m0_5b -= tb79 * 2.0;
      m0_5bd -= tb79d * 2.0;
      m1_5b -= tb79;
      m1_5bd -= tb79d;
    } else if (MAGGI_RE(a6) < 0.0) {
      slope7_2 = e5 + h5 / 6.0 * (m0_5 + 2.0 * m1_5);
      slope7_2d = e5d + (h5d / 6.0 * (m0_5 + 2.0 * m1_5) + h5 / 6.0 * (m0_5d + 2.0 * m1_5d));
      x2_6b = 0.0;
      x2_6bd = 0.0;
      slope7_2b = x2_5b;
      slope7_2bd = x2_5bd;
      x2_5b = 0.0;
      x2_5bd = 0.0;
      pb[t->driverpath[i] + k8 + 1] += x2_4b;
      pbd[t->driverpath[i] + k8 + 1] += x2_4bd;
      slope7_2b -= x2_4b * a6;
      slope7_2bd -= x2_4bd * a6 + x2_4b * a6d;
      a6b -= x2_4b * slope7_2;
      a6bd -= x2_4bd * slope7_2 + x2_4b * slope7_2d;
      x2_4b = 0.0;
      x2_4bd = 0.0;
      e5b += slope7_2b;
      e5bd += slope7_2bd;
      h5b += slope7_2b * (m0_5 + 2.0 * m1_5) / 6.0;
      h5bd += (slope7_2bd * (m0_5 + 2.0 * m1_5) + slope7_2b * (m0_5d + 2.0 * m1_5d)) / 6.0;
      tb80 = slope7_2b * (h5 / 6.0);
      tb80d = slope7_2bd * (h5 / 6.0) + slope7_2b * (h5d / 6.0);
      m0_5b += tb80;
      m0_5bd += tb80d;
      m1_5b += tb80 * 2.0;
      m1_5bd += tb80d * 2.0;
    } else {
      slope7_3 = e5 - h5 / 6.0 * (m1_5 - m0_5);
      slope7_3d = e5d - (h5d / 6.0 * (m1_5 - m0_5) + h5 / 6.0 * (m1_5d - m0_5d));
      t26 = 6.0 * h5;
      t26d = 6.0 * h5d;
      t27 = (m0_5 * a6 * a6 * a6 + m1_5 * c5 * c5 * c5) / t26;
      t27d = (((m0_5d * a6 + m0_5 * a6d) * a6 + m0_5 * a6 * a6d) * a6 + m0_5 * a6 * a6 * a6d +
          (((m1_5d * c5 + m1_5 * c5d) * c5 + m1_5 * c5 * c5d) * c5 + m1_5 * c5 * c5 * c5d) - t27 *
          t26d) * (1.0 / t26);
      t28 = 2.0 * h5;
      t28d = 2.0 * h5d;
      t29 = (m1_5 * c5 * c5 - m0_5 * a6 * a6) / t28;
      t29d = ((m1_5d * c5 + m1_5 * c5d) * c5 + m1_5 * c5 * c5d - ((m0_5d * a6 + m0_5 * a6d) * a6 +
          m0_5 * a6 * a6d) - t29 * t28d) * (1.0 / t28);
      t30 = (m0_5 * a6 + m1_5 * c5) / h5;
      t30d = (m0_5d * a6 + m0_5 * a6d + (m1_5d * c5 + m1_5 * c5d) - t30 * h5d) * (1.0 / h5);
      t30b = x2_6b;
      t30bd = x2_6bd;
      x2_6b = 0.0;
      x2_6bd = 0.0;
      tb92 = t30b / h5;
      tb92d = (t30bd - tb92 * h5d) * (1.0 / h5);
      m0_5b += tb92 * a6;
      m0_5bd += tb92d * a6 + tb92 * a6d;
      a6b += tb92 * m0_5;
      a6bd += tb92d * m0_5 + tb92 * m0_5d;
      m1_5b += tb92 * c5;
      m1_5bd += tb92d * c5 + tb92 * c5d;
      c5b += tb92 * m1_5;
      c5bd += tb92d * m1_5 + tb92 * m1_5d;
      h5b -= tb92 * t30;
      h5bd -= tb92d * t30 + tb92 * t30d;
      t29b = x2_5b;
      t29bd = x2_5bd;
      slope7_3b = x2_5b;
      slope7_3bd = x2_5bd;
      x2_5b = 0.0;
      x2_5bd = 0.0;
      tb89 = t29b / t28;
      tb89d = (t29bd - tb89 * t28d) * (1.0 / t28);
      tb90 = tb89 * c5;
      tb90d = tb89d * c5 + tb89 * c5d;
      m1_5b += tb90 * c5;
      m1_5bd += tb90d * c5 + tb90 * c5d;
      c5b += tb90 * m1_5;
      c5bd += tb90d * m1_5 + tb90 * m1_5d;
      c5b += tb89 * (m1_5 * c5);
      c5bd += tb89d * (m1_5 * c5) + tb89 * (m1_5d * c5 + m1_5 * c5d);
      tb91 = tb89 * a6;
      tb91d = tb89d * a6 + tb89 * a6d;
      m0_5b -= tb91 * a6;
      m0_5bd -= tb91d * a6 + tb91 * a6d;
      a6b -= tb91 * m0_5;
      a6bd -= tb91d * m0_5 + tb91 * m0_5d;
      a6b -= tb89 * (m0_5 * a6);
      a6bd -= tb89d * (m0_5 * a6) + tb89 * (m0_5d * a6 + m0_5 * a6d);
      t28b = -(tb89 * t29);
      t28bd = -(tb89d * t29 + tb89 * t29d);
      h5b += t28b * 2.0;
      h5bd += t28bd * 2.0;
      t27b = x2_4b;
      t27bd = x2_4bd;
      pb[t->driverpath[i] + k8] += x2_4b;
      pbd[t->driverpath[i] + k8] += x2_4bd;
      tb87 = x2_4b / 6.0;
      tb87d = x2_4bd / 6.0;
      tb88 = tb87 * h5;
      tb88d = tb87d * h5 + tb87 * h5d;
      m0_5b -= tb88 * h5;
      m0_5bd -= tb88d * h5 + tb88 * h5d;
      h5b -= tb88 * m0_5;
      h5bd -= tb88d * m0_5 + tb88 * m0_5d;
      h5b -= tb87 * (m0_5 * h5);
      h5bd -= tb87d * (m0_5 * h5) + tb87 * (m0_5d * h5 + m0_5 * h5d);
      slope7_3b += x2_4b * c5;
      slope7_3bd += x2_4bd * c5 + x2_4b * c5d;
      c5b += x2_4b * slope7_3;
      c5bd += x2_4bd * slope7_3 + x2_4b * slope7_3d;
      x2_4b = 0.0;
      x2_4bd = 0.0;
      tb82 = t27b / t26;
      tb82d = (t27bd - tb82 * t26d) * (1.0 / t26);
      tb83 = tb82 * a6;
      tb83d = tb82d * a6 + tb82 * a6d;
      tb84 = tb83 * a6;
      tb84d = tb83d * a6 + tb83 * a6d;
      m0_5b += tb84 * a6;
      m0_5bd += tb84d * a6 + tb84 * a6d;
      a6b += tb84 * m0_5;
      a6bd += tb84d * m0_5 + tb84 * m0_5d;
      a6b += tb83 * (m0_5 * a6);
      a6bd += tb83d * (m0_5 * a6) + tb83 * (m0_5d * a6 + m0_5 * a6d);
      a6b += tb82 * (m0_5 * a6 * a6);
      a6bd += tb82d * (m0_5 * a6 * a6) + tb82 * ((m0_5d * a6 + m0_5 * a6d) * a6 + m0_5 * a6 * a6d);
      tb85 = tb82 * c5;
      tb85d = tb82d * c5 + tb82 * c5d;
      tb86 = tb85 * c5;
      tb86d = tb85d * c5 + tb85 * c5d;
      m1_5b += tb86 * c5;
      m1_5bd += tb86d * c5 + tb86 * c5d;
      c5b += tb86 * m1_5;
      c5bd += tb86d * m1_5 + tb86 * m1_5d;
      c5b += tb85 * (m1_5 * c5);
      c5bd += tb85d * (m1_5 * c5) + tb85 * (m1_5d * c5 + m1_5 * c5d);
      c5b += tb82 * (m1_5 * c5 * c5);
      c5bd += tb82d * (m1_5 * c5 * c5) + tb82 * ((m1_5d * c5 + m1_5 * c5d) * c5 + m1_5 * c5 * c5d);
      t26b = -(tb82 * t27);
      t26bd = -(tb82d * t27 + tb82 * t27d);
      h5b += t26b * 6.0;
      h5bd += t26bd * 6.0;
      e5b += slope7_3b;
      e5bd += slope7_3bd;
      h5b -= slope7_3b * (m1_5 - m0_5) / 6.0;
      h5bd -= (slope7_3bd * (m1_5 - m0_5) + slope7_3b * (m1_5d - m0_5d)) / 6.0;
      tb81 = slope7_3b * (h5 / 6.0);
      tb81d = slope7_3bd * (h5 / 6.0) + slope7_3b * (h5d / 6.0);
      m1_5b -= tb81;
      m1_5bd -= tb81d;
      m0_5b += tb81;
      m0_5bd += tb81d;
    }
    tb78 = e5b / h5;
    tb78d = (e5bd - tb78 * h5d) * (1.0 / h5);
    pb[t->driverpath[i] + k8 + 1] += tb78;
    pbd[t->driverpath[i] + k8 + 1] += tb78d;
    pb[t->driverpath[i] + k8] -= tb78;
    pbd[t->driverpath[i] + k8] -= tb78d;
    h5b -= tb78 * e5;
    h5bd -= tb78d * e5 + tb78 * e5d;
    path0b[t->driverrow[i] + k8 + 1][MAGGI_PATH_X] += m1_5b;
    path0bd[t->driverrow[i] + k8 + 1][MAGGI_PATH_X] += m1_5bd;
    path0b[t->driverrow[i] + k8][MAGGI_PATH_X] += m0_5b;
    path0bd[t->driverrow[i] + k8][MAGGI_PATH_X] += m0_5bd;
    s2b += c5b;
    s2bd += c5bd;
    path0b[t->driverrow[i] + k8][MAGGI_PATH_S] -= c5b;
    path0bd[t->driverrow[i] + k8][MAGGI_PATH_S] -= c5bd;
    path0b[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] += a6b;
    path0bd[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] += a6bd;
    s2b -= a6b;
    s2bd -= a6bd;
    path0b[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] += h5b;
    path0bd[t->driverrow[i] + k8 + 1][MAGGI_PATH_S] += h5bd;
    path0b[t->driverrow[i] + k8][MAGGI_PATH_S] -= h5b;
    path0bd[t->driverrow[i] + k8][MAGGI_PATH_S] -= h5bd;
    s1b = s2b;
    s1bd = s2bd;
    t25b = -s2b;
    t25bd = -s2bd;
    tb77 = t25b / slope6;
    tb77d = (t25bd - tb77 * slope6d) * (1.0 / slope6);
    g2b = tb77;
    g2bd = tb77d;
    slope6b = -(tb77 * t25);
    slope6bd = -(tb77d * t25 + tb77 * t25d);
    x11b = slope6b * x11;
    x11bd = slope6bd * x11 + slope6b * x11d;
    x11b += slope6b * x11;
    x11bd += slope6bd * x11 + slope6b * x11d;
    y11b = slope6b * y11;
    y11bd = slope6bd * y11 + slope6b * y11d;
    y11b += slope6b * y11;
    y11bd += slope6bd * y11 + slope6b * y11d;
    tb75 = slope6b * x12;
    tb75d = slope6bd * x12 + slope6b * x12d;
    x10b = tb75;
    x10bd = tb75d;
    Pb[0] -= tb75;
    Pbd[0] -= tb75d;
    x12b = slope6b * (x10 - P[0]);
    x12bd = slope6bd * (x10 - P[0]) + slope6b * (x10d - Pd[0]);
    tb76 = slope6b * y12;
    tb76d = slope6bd * y12 + slope6b * y12d;
    y10b = tb76;
    y10bd = tb76d;
    Pb[1] -= tb76;
    Pbd[1] -= tb76d;
    y12b = slope6b * (y10 - P[1]);
    y12bd = slope6bd * (y10 - P[1]) + slope6b * (y10d - Pd[1]);
    tb73 = g2b * x11;
    /* one step of Newton's method; C, C', C'' at s */
    tb73d = g2bd * x11 + g2b * x11d;
    x10b += tb73;
    x10bd += tb73d;
    Pb[0] -= tb73;
    Pbd[0] -= tb73d;
    x11b += g2b * (x10 - P[0]);
    x11bd += g2bd * (x10 - P[0]) + g2b * (x10d - Pd[0]);
    tb74 = g2b * y11;
    tb74d = g2bd * y11 + g2b * y11d;
    y10b += tb74;
    y10bd += tb74d;
    Pb[1] -= tb74;
    Pbd[1] -= tb74d;
    y11b += g2b * (y10 - P[1]);
    y11bd += g2bd * (y10 - P[1]) + g2b * (y10d - Pd[1]);
    a5b = 0.0;
    a5bd = 0.0;
    c4b = 0.0;
    c4bd = 0.0;
    e4b = 0.0;
    e4bd = 0.0;
    h4b = 0.0;
    h4bd = 0.0;
    m0_4b = 0.0;
    m0_4bd = 0.0;
    m1_4b = 0.0;
    m1_4bd = 0.0;
    if (MAGGI_RE(c4) < 0.0) {
      slope5 = e4 - h4 / 6.0 * (2.0 * m0_4 + m1_4);
      slope5d = e4d - (h4d / 6.0 * (2.0 * m0_4 + m1_4) + h4 / 6.0 * (2.0 * m0_4d + m1_4d));
      y12b = 0.0;
      y12bd = 0.0;
      slope5b = y11b;
      slope5bd = y11bd;
      y11b = 0.0;
      y11bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k7] += y10b;
      pbd[t->driverpath[i] + t->drivern[i] + k7] += y10bd;
      slope5b += y10b * c4;
      slope5bd += y10bd * c4 + y10b * c4d;
      c4b += y10b * slope5;
      c4bd += y10bd * slope5 + y10b * slope5d;
      y10b = 0.0;
      y10bd = 0.0;
      e4b += slope5b;
      e4bd += slope5bd;
      h4b -= slope5b * (2.0 * m0_4 + m1_4) / 6.0;
      h4bd -= (slope5bd * (2.0 * m0_4 + m1_4) + slope5b * (2.0 * m0_4d + m1_4d)) / 6.0;
      tb59 = slope5b * (h4 / 6.0);
      tb59d = slope5bd * (h4 / 6.0) + slope5b * (h4d / 6.0);
      m0_4b -= tb59 * 2.0;
      m0_4bd -= tb59d * 2.0;
      m1_4b -= tb59;
      m1_4bd -= tb59d;
    } else if (MAGGI_RE(a5) < 0.0) {
      slope5_2 = e4 + h4 / 6.0 * (m0_4 + 2.0 * m1_4);
      slope5_2d = e4d + (h4d / 6.0 * (m0_4 + 2.0 * m1_4) + h4 / 6.0 * (m0_4d + 2.0 * m1_4d));
      y12b = 0.0;
      y12bd = 0.0;
      slope5_2b = y11b;
      slope5_2bd = y11bd;
      y11b = 0.0;
      y11bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k7 + 1] += y10b;
      pbd[t->driverpath[i] + t->drivern[i] + k7 + 1] += y10bd;
      slope5_2b -= y10b * a5;
      slope5_2bd -= y10bd * a5 + y10b * a5d;
      a5b -= y10b * slope5_2;
      a5bd -= y10bd * slope5_2 + y10b * slope5_2d;
      y10b = 0.0;
      y10bd = 0.0;
      e4b += slope5_2b;
      e4bd += slope5_2bd;
      h4b += slope5_2b * (m0_4 + 2.0 * m1_4) / 6.0;
      h4bd += (slope5_2bd * (m0_4 + 2.0 * m1_4) + slope5_2b * (m0_4d + 2.0 * m1_4d)) / 6.0;
      tb60 = slope5_2b * (h4 / 6.0);
      tb60d = slope5_2bd * (h4 / 6.0) + slope5_2b * (h4d / 6.0);
      m0_4b += tb60;
      m0_4bd += tb60d;
      m1_4b += tb60 * 2.0;
      m1_4bd += tb60d * 2.0;
    } else {
      slope5_3 = e4 - h4 / 6.0 * (m1_4 - m0_4);
      slope5_3d = e4d - (h4d / 6.0 * (m1_4 - m0_4) + h4 / 6.0 * (m1_4d - m0_4d));
      t20 = 6.0 * h4;
      t20d = 6.0 * h4d;
      t21 = (m0_4 * a5 * a5 * a5 + m1_4 * c4 * c4 * c4) / t20;
      t21d = (((m0_4d * a5 + m0_4 * a5d) * a5 + m0_4 * a5 * a5d) * a5 + m0_4 * a5 * a5 * a5d +
          (((m1_4d * c4 + m1_4 * c4d) * c4 + m1_4 * c4 * c4d) * c4 + m1_4 * c4 * c4 * c4d) - t21 *
          t20d) * (1.0 / t20);
      t22 = 2.0 * h4;
      t22d = 2.0 * h4d;
      t23 = (m1_4 * c4 * c4 - m0_4 * a5 * a5) / t22;
      t23d = ((m1_4d * c4 + m1_4 * c4d) * c4 + m1_4 * c4 * c4d - ((m0_4d * a5 + m0_4 * a5d) * a5 +
          m0_4 * a5 * a5d) - t23 * t22d) * (1.0 / t22);
      t24 = (m0_4 * a5 + m1_4 * c4) / h4;
      t24d = (m0_4d * a5 + m0_4 * a5d + (m1_4d * c4 + m1_4 * c4d) - t24 * h4d) * (1.0 / h4);
      t24b = y12b;
      t24bd = y12bd;
      y12b = 0.0;
      y12bd = 0.0;
      tb72 = t24b / h4;
      tb72d = (t24bd - tb72 * h4d) * (1.0 / h4);
      m0_4b += tb72 * a5;
      m0_4bd += tb72d * a5 + tb72 * a5d;
      a5b += tb72 * m0_4;
      a5bd += tb72d * m0_4 + tb72 * m0_4d;
      m1_4b += tb72 * c4;
      m1_4bd += tb72d * c4 + tb72 * c4d;
      c4b += tb72 * m1_4;
      c4bd += tb72d * m1_4 + tb72 * m1_4d;
      h4b -= tb72 * t24;
      h4bd -= tb72d * t24 + tb72 * t24d;
      t23b = y11b;
      t23bd = y11bd;
      slope5_3b = y11b;
      slope5_3bd = y11bd;
      y11b = 0.0;
      y11bd = 0.0;
      tb69 = t23b / t22;
      tb69d = (t23bd - tb69 * t22d) * (1.0 / t22);
      tb70 = tb69 * c4;
      tb70d = tb69d * c4 + tb69 * c4d;
      m1_4b += tb70 * c4;
      m1_4bd += tb70d * c4 + tb70 * c4d;
      c4b += tb70 * m1_4;
      c4bd += tb70d * m1_4 + tb70 * m1_4d;
      c4b += tb69 * (m1_4 * c4);
      c4bd += tb69d * (m1_4 * c4) + tb69 * (m1_4d * c4 + m1_4 * c4d);
      tb71 = tb69 * a5;
      tb71d = tb69d * a5 + tb69 * a5d;
      m0_4b -= tb71 * a5;
      m0_4bd -= tb71d * a5 + tb71 * a5d;
      a5b -= tb71 * m0_4;
      a5bd -= tb71d * m0_4 + tb71 * m0_4d;
      a5b -= tb69 * (m0_4 * a5);
      a5bd -= tb69d * (m0_4 * a5) + tb69 * (m0_4d * a5 + m0_4 * a5d);
      t22b = -(tb69 * t23);
      t22bd = -(tb69d * t23 + tb69 * t23d);
      h4b += t22b * 2.0;
      h4bd += t22bd * 2.0;
      t21b = y10b;
      t21bd = y10bd;
      pb[t->driverpath[i] + t->drivern[i] + k7] += y10b;
      pbd[t->driverpath[i] + t->drivern[i] + k7] += y10bd;
      tb67 = y10b / 6.0;
      tb67d = y10bd / 6.0;
      tb68 = tb67 * h4;
      tb68d = tb67d * h4 + tb67 * h4d;
      m0_4b -= tb68 * h4;
      m0_4bd -= tb68d * h4 + tb68 * h4d;
      h4b -= tb68 * m0_4;
      h4bd -= tb68d * m0_4 + tb68 * m0_4d;
      h4b -= tb67 * (m0_4 * h4);
      h4bd -= tb67d * (m0_4 * h4) + tb67 * (m0_4d * h4 + m0_4 * h4d);
      slope5_3b += y10b * c4;
      slope5_3bd += y10bd * c4 + y10b * c4d;
      c4b += y10b * slope5_3;
      c4bd += y10bd * slope5_3 + y10b * slope5_3d;
      y10b = 0.0;
      y10bd = 0.0;
      tb62 = t21b / t20;
      tb62d = (t21bd - tb62 * t20d) * (1.0 / t20);
      tb63 = tb62 * a5;
      tb63d = tb62d * a5 + tb62 * a5d;
      tb64 = tb63 * a5;
      tb64d = tb63d * a5 + tb63 * a5d;
      m0_4b += tb64 * a5;
      m0_4bd += tb64d * a5 + tb64 * a5d;
      a5b += tb64 * m0_4;
      a5bd += tb64d * m0_4 + tb64 * m0_4d;
      a5b += tb63 * (m0_4 * a5);
      a5bd += tb63d * (m0_4 * a5) + tb63 * (m0_4d * a5 + m0_4 * a5d);
      a5b += tb62 * (m0_4 * a5 * a5);
      a5bd += tb62d * (m0_4 * a5 * a5) + tb62 * ((m0_4d * a5 + m0_4 * a5d) * a5 + m0_4 * a5 * a5d);
      tb65 = tb62 * c4;
      tb65d = tb62d * c4 + tb62 * c4d;
      tb66 = tb65 * c4;
      tb66d = tb65d * c4 + tb65 * c4d;
      m1_4b += tb66 * c4;
      m1_4bd += tb66d * c4 + tb66 * c4d;
      c4b += tb66 * m1_4;
      c4bd += tb66d * m1_4 + tb66 * m1_4d;
      c4b += tb65 * (m1_4 * c4);
      c4bd += tb65d * (m1_4 * c4) + tb65 * (m1_4d * c4 + m1_4 * c4d);
      c4b += tb62 * (m1_4 * c4 * c4);
      c4bd += tb62d * (m1_4 * c4 * c4) + tb62 * ((m1_4d * c4 + m1_4 * c4d) * c4 + m1_4 * c4 * c4d);
      t20b = -(tb62 * t21);
      t20bd = -(tb62d * t21 + tb62 * t21d);
      h4b += t20b * 6.0;
      h4bd += t20bd * 6.0;
      e4b += slope5_3b;
      e4bd += slope5_3bd;
      h4b -= slope5_3b * (m1_4 - m0_4) / 6.0;
      h4bd -= (slope5_3bd * (m1_4 - m0_4) + slope5_3b * (m1_4d - m0_4d)) / 6.0;
      tb61 = slope5_3b * (h4 / 6.0);
      tb61d = slope5_3bd * (h4 / 6.0) + slope5_3b * (h4d / 6.0);
      m1_4b -= tb61;
      m1_4bd -= tb61d;
      m0_4b += tb61;
      m0_4bd += tb61d;
    }
    tb58 = e4b / h4;
    tb58d = (e4bd - tb58 * h4d) * (1.0 / h4);
    pb[t->driverpath[i] + t->drivern[i] + k7 + 1] += tb58;
    pbd[t->driverpath[i] + t->drivern[i] + k7 + 1] += tb58d;
    pb[t->driverpath[i] + t->drivern[i] + k7] -= tb58;
    pbd[t->driverpath[i] + t->drivern[i] + k7] -= tb58d;
    h4b -= tb58 * e4;
    h4bd -= tb58d * e4 + tb58 * e4d;
    path0b[t->driverrow[i] + k7 + 1][MAGGI_PATH_Y] += m1_4b;
    path0bd[t->driverrow[i] + k7 + 1][MAGGI_PATH_Y] += m1_4bd;
    path0b[t->driverrow[i] + k7][MAGGI_PATH_Y] += m0_4b;
    path0bd[t->driverrow[i] + k7][MAGGI_PATH_Y] += m0_4bd;
    s1b += c4b;
    s1bd += c4bd;
    path0b[t->driverrow[i] + k7][MAGGI_PATH_S] -= c4b;
    path0bd[t->driverrow[i] + k7][MAGGI_PATH_S] -= c4bd;
    path0b[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] += a5b;
    path0bd[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] += a5bd;
    s1b -= a5b;
    s1bd -= a5bd;
    path0b[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] += h4b;
    path0bd[t->driverrow[i] + k7 + 1][MAGGI_PATH_S] += h4bd;
    path0b[t->driverrow[i] + k7][MAGGI_PATH_S] -= h4b;
    path0bd[t->driverrow[i] + k7][MAGGI_PATH_S] -= h4bd;
    a4b = 0.0;
    a4bd = 0.0;
    c3b = 0.0;
    c3bd = 0.0;
    e3b = 0.0;
    e3bd = 0.0;
    h3b = 0.0;
    h3bd = 0.0;
    m0_3b = 0.0;
    m0_3bd = 0.0;
    m1_3b = 0.0;
    m1_3bd = 0.0;
    if (MAGGI_RE(c3) < 0.0) {
      slope4 = e3 - h3 / 6.0 * (2.0 * m0_3 + m1_3);
      slope4d = e3d - (h3d / 6.0 * (2.0 * m0_3 + m1_3) + h3 / 6.0 * (2.0 * m0_3d + m1_3d));
      x12b = 0.0;
      x12bd = 0.0;
      slope4b = x11b;
      slope4bd = x11bd;
      x11b = 0.0;
      x11bd = 0.0;
      pb[t->driverpath[i] + k6] += x10b;
      pbd[t->driverpath[i] + k6] += x10bd;
      slope4b += x10b * c3;
      slope4bd += x10bd * c3 + x10b * c3d;
      c3b += x10b * slope4;
      c3bd += x10bd * slope4 + x10b * slope4d;
      x10b = 0.0;
      x10bd = 0.0;
      e3b += slope4b;
      e3bd += slope4bd;
      h3b -= slope4b * (2.0 * m0_3 + m1_3) / 6.0;
      h3bd -= (slope4bd * (2.0 * m0_3 + m1_3) + slope4b * (2.0 * m0_3d + m1_3d)) / 6.0;
      tb44 = slope4b * (h3 / 6.0);
      tb44d = slope4bd * (h3 / 6.0) + slope4b * (h3d / 6.0);
      m0_3b -= tb44 * 2.0;
      m0_3bd -= tb44d * 2.0;
      m1_3b -= tb44;
      m1_3bd -= tb44d;
    } else if (MAGGI_RE(a4) < 0.0) {
      slope4_2 = e3 + h3 / 6.0 * (m0_3 + 2.0 * m1_3);
      slope4_2d = e3d + (h3d / 6.0 * (m0_3 + 2.0 * m1_3) + h3 / 6.0 * (m0_3d + 2.0 * m1_3d));
      x12b = 0.0;
      x12bd = 0.0;
      slope4_2b = x11b;
      slope4_2bd = x11bd;
      x11b = 0.0;
      x11bd = 0.0;
      pb[t->driverpath[i] + k6 + 1] += x10b;
      pbd[t->driverpath[i] + k6 + 1] += x10bd;
      slope4_2b -= x10b * a4;
      slope4_2bd -= x10bd * a4 + x10b * a4d;
      a4b -= x10b * slope4_2;
      a4bd -= x10bd * slope4_2 + x10b * slope4_2d;
      x10b = 0.0;
      x10bd = 0.0;
      e3b += slope4_2b;
      e3bd += slope4_2bd;
      h3b += slope4_2b * (m0_3 + 2.0 * m1_3) / 6.0;
      h3bd += (slope4_2bd * (m0_3 + 2.0 * m1_3) + slope4_2b * (m0_3d + 2.0 * m1_3d)) / 6.0;
      tb45 = slope4_2b * (h3 / 6.0);
      tb45d = slope4_2bd * (h3 / 6.0) + slope4_2b * (h3d / 6.0);
      m0_3b += tb45;
      m0_3bd += tb45d;
      m1_3b += tb45 * 2.0;
      m1_3bd += tb45d * 2.0;
    } else {
      slope4_3 = e3 - h3 / 6.0 * (m1_3 - m0_3);
      slope4_3d = e3d - (h3d / 6.0 * (m1_3 - m0_3) + h3 / 6.0 * (m1_3d - m0_3d));
      t15 = 6.0 * h3;
      t15d = 6.0 * h3d;
      t16 = (m0_3 * a4 * a4 * a4 + m1_3 * c3 * c3 * c3) / t15;
      t16d = (((m0_3d * a4 + m0_3 * a4d) * a4 + m0_3 * a4 * a4d) * a4 + m0_3 * a4 * a4 * a4d +
          (((m1_3d * c3 + m1_3 * c3d) * c3 + m1_3 * c3 * c3d) * c3 + m1_3 * c3 * c3 * c3d) - t16 *
          t15d) * (1.0 / t15);
      t17 = 2.0 * h3;
      t17d = 2.0 * h3d;
      t18 = (m1_3 * c3 * c3 - m0_3 * a4 * a4) / t17;
      t18d = ((m1_3d * c3 + m1_3 * c3d) * c3 + m1_3 * c3 * c3d - ((m0_3d * a4 + m0_3 * a4d) * a4 +
          m0_3 * a4 * a4d) - t18 * t17d) * (1.0 / t17);
      t19 = (m0_3 * a4 + m1_3 * c3) / h3;
      t19d = (m0_3d * a4 + m0_3 * a4d + (m1_3d * c3 + m1_3 * c3d) - t19 * h3d) * (1.0 / h3);
      t19b = x12b;
      t19bd = x12bd;
      x12b = 0.0;
      x12bd = 0.0;
      tb57 = t19b / h3;
      tb57d = (t19bd - tb57 * h3d) * (1.0 / h3);
      m0_3b += tb57 * a4;
      m0_3bd += tb57d * a4 + tb57 * a4d;
      a4b += tb57 * m0_3;
      a4bd += tb57d * m0_3 + tb57 * m0_3d;
      m1_3b += tb57 * c3;
      m1_3bd += tb57d * c3 + tb57 * c3d;
      c3b += tb57 * m1_3;
      c3bd += tb57d * m1_3 + tb57 * m1_3d;
      h3b -= tb57 * t19;
      h3bd -= tb57d * t19 + tb57 * t19d;
      t18b = x11b;
      t18bd = x11bd;
      slope4_3b = x11b;
      slope4_3bd = x11bd;
      x11b = 0.0;
      x11bd = 0.0;
      tb54 = t18b / t17;
      tb54d = (t18bd - tb54 * t17d) * (1.0 / t17);
      tb55 = tb54 * c3;
      tb55d = tb54d * c3 + tb54 * c3d;
      m1_3b += tb55 * c3;
      m1_3bd += tb55d * c3 + tb55 * c3d;
      c3b += tb55 * m1_3;
      c3bd += tb55d * m1_3 + tb55 * m1_3d;
      c3b += tb54 * (m1_3 * c3);
      c3bd += tb54d * (m1_3 * c3) + tb54 * (m1_3d * c3 + m1_3 * c3d);
      tb56 = tb54 * a4;
      tb56d = tb54d * a4 + tb54 * a4d;
      m0_3b -= tb56 * a4;
      m0_3bd -= tb56d * a4 + tb56 * a4d;
      a4b -= tb56 * m0_3;
      a4bd -= tb56d * m0_3 + tb56 * m0_3d;
      a4b -= tb54 * (m0_3 * a4);
      a4bd -= tb54d * (m0_3 * a4) + tb54 * (m0_3d * a4 + m0_3 * a4d);
      t17b = -(tb54 * t18);
      t17bd = -(tb54d * t18 + tb54 * t18d);
      h3b += t17b * 2.0;
      h3bd += t17bd * 2.0;
      t16b = x10b;
      t16bd = x10bd;
      pb[t->driverpath[i] + k6] += x10b;
      pbd[t->driverpath[i] + k6] += x10bd;
      tb52 = x10b / 6.0;
      tb52d = x10bd / 6.0;
      tb53 = tb52 * h3;
      tb53d = tb52d * h3 + tb52 * h3d;
      m0_3b -= tb53 * h3;
      m0_3bd -= tb53d * h3 + tb53 * h3d;
      h3b -= tb53 * m0_3;
      h3bd -= tb53d * m0_3 + tb53 * m0_3d;
      h3b -= tb52 * (m0_3 * h3);
      h3bd -= tb52d * (m0_3 * h3) + tb52 * (m0_3d * h3 + m0_3 * h3d);
      slope4_3b += x10b * c3;
      slope4_3bd += x10bd * c3 + x10b * c3d;
      c3b += x10b * slope4_3;
      c3bd += x10bd * slope4_3 + x10b * slope4_3d;
      x10b = 0.0;
      x10bd = 0.0;
      tb47 = t16b / t15;
      tb47d = (t16bd - tb47 * t15d) * (1.0 / t15);
      tb48 = tb47 * a4;
      tb48d = tb47d * a4 + tb47 * a4d;
      tb49 = tb48 * a4;
      tb49d = tb48d * a4 + tb48 * a4d;
      m0_3b += tb49 * a4;
      m0_3bd += tb49d * a4 + tb49 * a4d;
      a4b += tb49 * m0_3;
      a4bd += tb49d * m0_3 + tb49 * m0_3d;
      a4b += tb48 * (m0_3 * a4);
      a4bd += tb48d * (m0_3 * a4) + tb48 * (m0_3d * a4 + m0_3 * a4d);
      a4b += tb47 * (m0_3 * a4 * a4);
      a4bd += tb47d * (m0_3 * a4 * a4) + tb47 * ((m0_3d * a4 + m0_3 * a4d) * a4 + m0_3 * a4 * a4d);
      tb50 = tb47 * c3;
      tb50d = tb47d * c3 + tb47 * c3d;
      tb51 = tb50 * c3;
      tb51d = tb50d * c3 + tb50 * c3d;
      m1_3b += tb51 * c3;
      m1_3bd += tb51d * c3 + tb51 * c3d;
      c3b += tb51 * m1_3;
      c3bd += tb51d * m1_3 + tb51 * m1_3d;
      c3b += tb50 * (m1_3 * c3);
      c3bd += tb50d * (m1_3 * c3) + tb50 * (m1_3d * c3 + m1_3 * c3d);
      c3b += tb47 * (m1_3 * c3 * c3);
      c3bd += tb47d * (m1_3 * c3 * c3) + tb47 * ((m1_3d * c3 + m1_3 * c3d) * c3 + m1_3 * c3 * c3d);
      t15b = -(tb47 * t16);
      t15bd = -(tb47d * t16 + tb47 * t16d);
      h3b += t15b * 6.0;
      h3bd += t15bd * 6.0;
      e3b += slope4_3b;
      e3bd += slope4_3bd;
      h3b -= slope4_3b * (m1_3 - m0_3) / 6.0;
      h3bd -= (slope4_3bd * (m1_3 - m0_3) + slope4_3b * (m1_3d - m0_3d)) / 6.0;
      tb46 = slope4_3b * (h3 / 6.0);
      tb46d = slope4_3bd * (h3 / 6.0) + slope4_3b * (h3d / 6.0);
      m1_3b -= tb46;
      m1_3bd -= tb46d;
      m0_3b += tb46;
      m0_3bd += tb46d;
    }
    tb43 = e3b / h3;
    tb43d = (e3bd - tb43 * h3d) * (1.0 / h3);
    pb[t->driverpath[i] + k6 + 1] += tb43;
    pbd[t->driverpath[i] + k6 + 1] += tb43d;
    pb[t->driverpath[i] + k6] -= tb43;
    pbd[t->driverpath[i] + k6] -= tb43d;
    h3b -= tb43 * e3;
    h3bd -= tb43d * e3 + tb43 * e3d;
    path0b[t->driverrow[i] + k6 + 1][MAGGI_PATH_X] += m1_3b;
    path0bd[t->driverrow[i] + k6 + 1][MAGGI_PATH_X] += m1_3bd;
    path0b[t->driverrow[i] + k6][MAGGI_PATH_X] += m0_3b;
    path0bd[t->driverrow[i] + k6][MAGGI_PATH_X] += m0_3bd;
    s1b += c3b;
    s1bd += c3bd;
    path0b[t->driverrow[i] + k6][MAGGI_PATH_S] -= c3b;
    path0bd[t->driverrow[i] + k6][MAGGI_PATH_S] -= c3bd;
    path0b[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] += a4b;
    path0bd[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] += a4bd;
    s1b -= a4b;
    s1bd -= a4bd;
    path0b[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] += h3b;
    path0bd[t->driverrow[i] + k6 + 1][MAGGI_PATH_S] += h3bd;
    path0b[t->driverrow[i] + k6][MAGGI_PATH_S] -= h3b;
    path0bd[t->driverrow[i] + k6][MAGGI_PATH_S] -= h3bd;
    s0b = s1b;
    s0bd = s1bd;
    t14b = -s1b;
    t14bd = -s1bd;
    tb42 = t14b / slope3;
    tb42d = (t14bd - tb42 * slope3d) * (1.0 / slope3);
    gb = tb42;
    gbd = tb42d;
    slope3b = -(tb42 * t14);
    slope3bd = -(tb42d * t14 + tb42 * t14d);
    x01b = slope3b * x01;
    x01bd = slope3bd * x01 + slope3b * x01d;
    x01b += slope3b * x01;
    x01bd += slope3bd * x01 + slope3b * x01d;
    y01b = slope3b * y01;
    y01bd = slope3bd * y01 + slope3b * y01d;
    y01b += slope3b * y01;
    y01bd += slope3bd * y01 + slope3b * y01d;
    tb40 = slope3b * x02;
    tb40d = slope3bd * x02 + slope3b * x02d;
    x00b = tb40;
    x00bd = tb40d;
    Pb[0] -= tb40;
    Pbd[0] -= tb40d;
    x02b = slope3b * (x00 - P[0]);
    x02bd = slope3bd * (x00 - P[0]) + slope3b * (x00d - Pd[0]);
    tb41 = slope3b * y02;
    tb41d = slope3bd * y02 + slope3b * y02d;
    y00b = tb41;
    y00bd = tb41d;
    Pb[1] -= tb41;
    Pbd[1] -= tb41d;
    y02b = slope3b * (y00 - P[1]);
    y02bd = slope3bd * (y00 - P[1]) + slope3b * (y00d - Pd[1]);
    tb38 = gb * x01;
    /* one step of Newton's method; C, C', C'' at s */
    tb38d = gbd * x01 + gb * x01d;
    x00b += tb38;
    x00bd += tb38d;
    Pb[0] -= tb38;
    Pbd[0] -= tb38d;
    x01b += gb * (x00 - P[0]);
    x01bd += gbd * (x00 - P[0]) + gb * (x00d - Pd[0]);
    tb39 = gb * y01;
    tb39d = gbd * y01 + gb * y01d;
    y00b += tb39;
    y00bd += tb39d;
    Pb[1] -= tb39;
    Pbd[1] -= tb39d;
    y01b += gb * (y00 - P[1]);
    y01bd += gbd * (y00 - P[1]) + gb * (y00d - Pd[1]);
    a3b = 0.0;
    a3bd = 0.0;
    c2b = 0.0;
    c2bd = 0.0;
    e2b = 0.0;
    e2bd = 0.0;
    h2b = 0.0;
    h2bd = 0.0;
    m0_2b = 0.0;
    m0_2bd = 0.0;
    m1_2b = 0.0;
    m1_2bd = 0.0;
    if (MAGGI_RE(c2) < 0.0) {
      slope2 = e2 - h2 / 6.0 * (2.0 * m0_2 + m1_2);
      slope2d = e2d - (h2d / 6.0 * (2.0 * m0_2 + m1_2) + h2 / 6.0 * (2.0 * m0_2d + m1_2d));
      y02b = 0.0;
      y02bd = 0.0;
      slope2b = y01b;
      slope2bd = y01bd;
      y01b = 0.0;
      y01bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k5] += y00b;
      pbd[t->driverpath[i] + t->drivern[i] + k5] += y00bd;
      slope2b += y00b * c2;
      slope2bd += y00bd * c2 + y00b * c2d;
      c2b += y00b * slope2;
      c2bd += y00bd * slope2 + y00b * slope2d;
      y00b = 0.0;
      y00bd = 0.0;
      e2b += slope2b;
      e2bd += slope2bd;
      h2b -= slope2b * (2.0 * m0_2 + m1_2) / 6.0;
      h2bd -= (slope2bd * (2.0 * m0_2 + m1_2) + slope2b * (2.0 * m0_2d + m1_2d)) / 6.0;
      tb24 = slope2b * (h2 / 6.0);
      tb24d = slope2bd * (h2 / 6.0) + slope2b * (h2d / 6.0);
      m0_2b -= tb24 * 2.0;
      m0_2bd -= tb24d * 2.0;
      m1_2b -= tb24;
      m1_2bd -= tb24d;
    } else if (MAGGI_RE(a3) < 0.0) {
      slope2_2 = e2 + h2 / 6.0 * (m0_2 + 2.0 * m1_2);
      slope2_2d = e2d + (h2d / 6.0 * (m0_2 + 2.0 * m1_2) + h2 / 6.0 * (m0_2d + 2.0 * m1_2d));
      y02b = 0.0;
      y02bd = 0.0;
      slope2_2b = y01b;
      slope2_2bd = y01bd;
      y01b = 0.0;
      y01bd = 0.0;
      pb[t->driverpath[i] + t->drivern[i] + k5 + 1] += y00b;
      pbd[t->driverpath[i] + t->drivern[i] + k5 + 1] += y00bd;
      slope2_2b -= y00b * a3;
      slope2_2bd -= y00bd * a3 + y00b * a3d;
      a3b -= y00b * slope2_2;
      a3bd -= y00bd * slope2_2 + y00b * slope2_2d;
      y00b = 0.0;
      y00bd = 0.0;
      e2b += slope2_2b;
      e2bd += slope2_2bd;
      h2b += slope2_2b * (m0_2 + 2.0 * m1_2) / 6.0;
      h2bd += (slope2_2bd * (m0_2 + 2.0 * m1_2) + slope2_2b * (m0_2d + 2.0 * m1_2d)) / 6.0;
      tb25 = slope2_2b * (h2 / 6.0);
      tb25d = slope2_2bd * (h2 / 6.0) + slope2_2b * (h2d / 6.0);
      m0_2b += tb25;
      m0_2bd += tb25d;
      m1_2b += tb25 * 2.0;
      m1_2bd += tb25d * 2.0;
    } else {
      slope2_3 = e2 - h2 / 6.0 * (m1_2 - m0_2);
      slope2_3d = e2d - (h2d / 6.0 * (m1_2 - m0_2) + h2 / 6.0 * (m1_2d - m0_2d));
      t9 = 6.0 * h2;
      t9d = 6.0 * h2d;
      t10 = (m0_2 * a3 * a3 * a3 + m1_2 * c2 * c2 * c2) / t9;
      t10d = (((m0_2d * a3 + m0_2 * a3d) * a3 + m0_2 * a3 * a3d) * a3 + m0_2 * a3 * a3 * a3d +
          (((m1_2d * c2 + m1_2 * c2d) * c2 + m1_2 * c2 * c2d) * c2 + m1_2 * c2 * c2 * c2d) - t10 *
          t9d) * (1.0 / t9);
      t11 = 2.0 * h2;
      t11d = 2.0 * h2d;
      t12 = (m1_2 * c2 * c2 - m0_2 * a3 * a3) / t11;
      t12d = ((m1_2d * c2 + m1_2 * c2d) * c2 + m1_2 * c2 * c2d - ((m0_2d * a3 + m0_2 * a3d) * a3 +
          m0_2 * a3 * a3d) - t12 * t11d) * (1.0 / t11);
      t13 = (m0_2 * a3 + m1_2 * c2) / h2;
      t13d = (m0_2d * a3 + m0_2 * a3d + (m1_2d * c2 + m1_2 * c2d) - t13 * h2d) * (1.0 / h2);
      t13b = y02b;
      t13bd = y02bd;
      y02b = 0.0;
      y02bd = 0.0;
      tb37 = t13b / h2;
      tb37d = (t13bd - tb37 * h2d) * (1.0 / h2);
      m0_2b += tb37 * a3;
      m0_2bd += tb37d * a3 + tb37 * a3d;
      a3b += tb37 * m0_2;
      a3bd += tb37d * m0_2 + tb37 * m0_2d;
      m1_2b += tb37 * c2;
      m1_2bd += tb37d * c2 + tb37 * c2d;
      c2b += tb37 * m1_2;
      c2bd += tb37d * m1_2 + tb37 * m1_2d;
      h2b -= tb37 * t13;
      h2bd -= tb37d * t13 + tb37 * t13d;
      t12b = y01b;
      t12bd = y01bd;
      slope2_3b = y01b;
      slope2_3bd = y01bd;
      y01b = 0.0;
      y01bd = 0.0;
      tb34 = t12b / t11;
      tb34d = (t12bd - tb34 * t11d) * (1.0 / t11);
      tb35 = tb34 * c2;
      tb35d = tb34d * c2 + tb34 * c2d;
      m1_2b += tb35 * c2;
      m1_2bd += tb35d * c2 + tb35 * c2d;
      c2b += tb35 * m1_2;
      c2bd += tb35d * m1_2 + tb35 * m1_2d;
      c2b += tb34 * (m1_2 * c2);
      c2bd += tb34d * (m1_2 * c2) + tb34 * (m1_2d * c2 + m1_2 * c2d);
      tb36 = tb34 * a3;
      tb36d = tb34d * a3 + tb34 * a3d;
      m0_2b -= tb36 * a3;
      m0_2bd -= tb36d * a3 + tb36 * a3d;
      a3b -= tb36 * m0_2;
      a3bd -= tb36d * m0_2 + tb36 * m0_2d;
      a3b -= tb34 * (m0_2 * a3);
      a3bd -= tb34d * (m0_2 * a3) + tb34 * (m0_2d * a3 + m0_2 * a3d);
      t11b = -(tb34 * t12);
      t11bd = -(tb34d * t12 + tb34 * t12d);
      h2b += t11b * 2.0;
      h2bd += t11bd * 2.0;
      t10b = y00b;
      t10bd = y00bd;
      pb[t->driverpath[i] + t->drivern[i] + k5] += y00b;
      pbd[t->driverpath[i] + t->drivern[i] + k5] += y00bd;
      tb32 = y00b / 6.0;
      tb32d = y00bd / 6.0;
      tb33 = tb32 * h2;
      tb33d = tb32d * h2 + tb32 * h2d;
      m0_2b -= tb33 * h2;
      m0_2bd -= tb33d * h2 + tb33 * h2d;
      h2b -= tb33 * m0_2;
      h2bd -= tb33d * m0_2 + tb33 * m0_2d;
      h2b -= tb32 * (m0_2 * h2);
      h2bd -= tb32d * (m0_2 * h2) + tb32 * (m0_2d * h2 + m0_2 * h2d);
      slope2_3b += y00b * c2;
      slope2_3bd += y00bd * c2 + y00b * c2d;
      c2b += y00b * slope2_3;
      c2bd += y00bd * slope2_3 + y00b * slope2_3d;
      y00b = 0.0;
      y00bd = 0.0;
      tb27 = t10b / t9;
      tb27d = (t10bd - tb27 * t9d) * (1.0 / t9);
      tb28 = tb27 * a3;
      tb28d = tb27d * a3 + tb27 * a3d;
      tb29 = tb28 * a3;
      tb29d = tb28d * a3 + tb28 * a3d;
      m0_2b += tb29 * a3;
      m0_2bd += tb29d * a3 + tb29 * a3d;
      a3b += tb29 * m0_2;
      a3bd += tb29d * m0_2 + tb29 * m0_2d;
      a3b += tb28 * (m0_2 * a3);
      a3bd += tb28d * (m0_2 * a3) + tb28 * (m0_2d * a3 + m0_2 * a3d);
      a3b += tb27 * (m0_2 * a3 * a3);
      a3bd += tb27d * (m0_2 * a3 * a3) + tb27 * ((m0_2d * a3 + m0_2 * a3d) * a3 + m0_2 * a3 * a3d);
      tb30 = tb27 * c2;
      tb30d = tb27d * c2 + tb27 * c2d;
      tb31 = tb30 * c2;
      tb31d = tb30d * c2 + tb30 * c2d;
      m1_2b += tb31 * c2;
      m1_2bd += tb31d * c2 + tb31 * c2d;
      c2b += tb31 * m1_2;
      c2bd += tb31d * m1_2 + tb31 * m1_2d;
      c2b += tb30 * (m1_2 * c2);
      c2bd += tb30d * (m1_2 * c2) + tb30 * (m1_2d * c2 + m1_2 * c2d);
      c2b += tb27 * (m1_2 * c2 * c2);
      c2bd += tb27d * (m1_2 * c2 * c2) + tb27 * ((m1_2d * c2 + m1_2 * c2d) * c2 + m1_2 * c2 * c2d);
      t9b = -(tb27 * t10);
      t9bd = -(tb27d * t10 + tb27 * t10d);
      h2b += t9b * 6.0;
      h2bd += t9bd * 6.0;
      e2b += slope2_3b;
      e2bd += slope2_3bd;
      h2b -= slope2_3b * (m1_2 - m0_2) / 6.0;
      h2bd -= (slope2_3bd * (m1_2 - m0_2) + slope2_3b * (m1_2d - m0_2d)) / 6.0;
      tb26 = slope2_3b * (h2 / 6.0);
      tb26d = slope2_3bd * (h2 / 6.0) + slope2_3b * (h2d / 6.0);
      m1_2b -= tb26;
      m1_2bd -= tb26d;
      m0_2b += tb26;
      m0_2bd += tb26d;
    }
    tb23 = e2b / h2;
    tb23d = (e2bd - tb23 * h2d) * (1.0 / h2);
    pb[t->driverpath[i] + t->drivern[i] + k5 + 1] += tb23;
    pbd[t->driverpath[i] + t->drivern[i] + k5 + 1] += tb23d;
    pb[t->driverpath[i] + t->drivern[i] + k5] -= tb23;
    pbd[t->driverpath[i] + t->drivern[i] + k5] -= tb23d;
    h2b -= tb23 * e2;
    h2bd -= tb23d * e2 + tb23 * e2d;
    path0b[t->driverrow[i] + k5 + 1][MAGGI_PATH_Y] += m1_2b;
    path0bd[t->driverrow[i] + k5 + 1][MAGGI_PATH_Y] += m1_2bd;
    path0b[t->driverrow[i] + k5][MAGGI_PATH_Y] += m0_2b;
    path0bd[t->driverrow[i] + k5][MAGGI_PATH_Y] += m0_2bd;
    s0b += c2b;
    s0bd += c2bd;
    path0b[t->driverrow[i] + k5][MAGGI_PATH_S] -= c2b;
    path0bd[t->driverrow[i] + k5][MAGGI_PATH_S] -= c2bd;
    path0b[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] += a3b;
    path0bd[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] += a3bd;
    s0b -= a3b;
    s0bd -= a3bd;
    path0b[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] += h2b;
    path0bd[t->driverrow[i] + k5 + 1][MAGGI_PATH_S] += h2bd;
    path0b[t->driverrow[i] + k5][MAGGI_PATH_S] -= h2b;
    path0bd[t->driverrow[i] + k5][MAGGI_PATH_S] -= h2bd;
    a2b = 0.0;
    a2bd = 0.0;
    cb = 0.0;
    cbd = 0.0;
    eb = 0.0;
    ebd = 0.0;
    hb = 0.0;
    hbd = 0.0;
    m0b = 0.0;
    m0bd = 0.0;
    m1b = 0.0;
    m1bd = 0.0;
    if (MAGGI_RE(c) < 0.0) {
      slope = e - h / 6.0 * (2.0 * m0 + m1);
      sloped = ed - (hd / 6.0 * (2.0 * m0 + m1) + h / 6.0 * (2.0 * m0d + m1d));
      x02b = 0.0;
      x02bd = 0.0;
      slopeb = x01b;
      slopebd = x01bd;
      x01b = 0.0;
      x01bd = 0.0;
      pb[t->driverpath[i] + k4] += x00b;
      pbd[t->driverpath[i] + k4] += x00bd;
      slopeb += x00b * c;
      slopebd += x00bd * c + x00b * cd;
      cb += x00b * slope;
      cbd += x00bd * slope + x00b * sloped;
      x00b = 0.0;
      x00bd = 0.0;
      eb += slopeb;
      ebd += slopebd;
      hb -= slopeb * (2.0 * m0 + m1) / 6.0;
      hbd -= (slopebd * (2.0 * m0 + m1) + slopeb * (2.0 * m0d + m1d)) / 6.0;
      tb9 = slopeb * (h / 6.0);
      tb9d = slopebd * (h / 6.0) + slopeb * (hd / 6.0);
      m0b -= tb9 * 2.0;
      m0bd -= tb9d * 2.0;
      m1b -= tb9;
      m1bd -= tb9d;
    } else if (MAGGI_RE(a2) < 0.0) {
      slope22 = e + h / 6.0 * (m0 + 2.0 * m1);
      slope22d = ed + (hd / 6.0 * (m0 + 2.0 * m1) + h / 6.0 * (m0d + 2.0 * m1d));
      x02b = 0.0;
      x02bd = 0.0;
      slope22b = x01b;
      slope22bd = x01bd;
      x01b = 0.0;
      x01bd = 0.0;
      pb[t->driverpath[i] + k4 + 1] += x00b;
      pbd[t->driverpath[i] + k4 + 1] += x00bd;
      slope22b -= x00b * a2;
      slope22bd -= x00bd * a2 + x00b * a2d;
      a2b -= x00b * slope22;
      a2bd -= x00bd * slope22 + x00b * slope22d;
      x00b = 0.0;
      x00bd = 0.0;
      eb += slope22b;
      ebd += slope22bd;
      hb += slope22b * (m0 + 2.0 * m1) / 6.0;
      hbd += (slope22bd * (m0 + 2.0 * m1) + slope22b * (m0d + 2.0 * m1d)) / 6.0;
      tb10 = slope22b * (h / 6.0);
      tb10d = slope22bd * (h / 6.0) + slope22b * (hd / 6.0);
      m0b += tb10;
      m0bd += tb10d;
      m1b += tb10 * 2.0;
      m1bd += tb10d * 2.0;
    } else {
      slope22_2 = e - h / 6.0 * (m1 - m0);
      slope22_2d = ed - (hd / 6.0 * (m1 - m0) + h / 6.0 * (m1d - m0d));
      t4 = 6.0 * h;
      t4d = 6.0 * hd;
      t5 = (m0 * a2 * a2 * a2 + m1 * c * c * c) / t4;
      t5d = (((m0d * a2 + m0 * a2d) * a2 + m0 * a2 * a2d) * a2 + m0 * a2 * a2 * a2d + (((m1d * c +
          m1 * cd) * c + m1 * c * cd) * c + m1 * c * c * cd) - t5 * t4d) * (1.0 / t4);
      t6 = 2.0 * h;
      t6d = 2.0 * hd;
      t7 = (m1 * c * c - m0 * a2 * a2) / t6;
      t7d = ((m1d * c + m1 * cd) * c + m1 * c * cd - ((m0d * a2 + m0 * a2d) * a2 + m0 * a2 * a2d) -
          t7 * t6d) * (1.0 / t6);
      t8 = (m0 * a2 + m1 * c) / h;
      t8d = (m0d * a2 + m0 * a2d + (m1d * c + m1 * cd) - t8 * hd) * (1.0 / h);
      t8b = x02b;
      t8bd = x02bd;
      x02b = 0.0;
      x02bd = 0.0;
      tb22 = t8b / h;
      tb22d = (t8bd - tb22 * hd) * (1.0 / h);
      m0b += tb22 * a2;
      m0bd += tb22d * a2 + tb22 * a2d;
      a2b += tb22 * m0;
      a2bd += tb22d * m0 + tb22 * m0d;
      m1b += tb22 * c;
      m1bd += tb22d * c + tb22 * cd;
      cb += tb22 * m1;
      cbd += tb22d * m1 + tb22 * m1d;
      hb -= tb22 * t8;
      hbd -= tb22d * t8 + tb22 * t8d;
      t7b = x01b;
      t7bd = x01bd;
      slope22_2b = x01b;
      slope22_2bd = x01bd;
      x01b = 0.0;
      x01bd = 0.0;
      tb19 = t7b / t6;
      tb19d = (t7bd - tb19 * t6d) * (1.0 / t6);
      tb20 = tb19 * c;
      tb20d = tb19d * c + tb19 * cd;
      m1b += tb20 * c;
      m1bd += tb20d * c + tb20 * cd;
      cb += tb20 * m1;
      cbd += tb20d * m1 + tb20 * m1d;
      cb += tb19 * (m1 * c);
      cbd += tb19d * (m1 * c) + tb19 * (m1d * c + m1 * cd);
      tb21 = tb19 * a2;
      tb21d = tb19d * a2 + tb19 * a2d;
      m0b -= tb21 * a2;
      m0bd -= tb21d * a2 + tb21 * a2d;
      a2b -= tb21 * m0;
      a2bd -= tb21d * m0 + tb21 * m0d;
      a2b -= tb19 * (m0 * a2);
      a2bd -= tb19d * (m0 * a2) + tb19 * (m0d * a2 + m0 * a2d);
      t6b = -(tb19 * t7);
      t6bd = -(tb19d * t7 + tb19 * t7d);
      hb += t6b * 2.0;
      hbd += t6bd * 2.0;
      t5b = x00b;
      t5bd = x00bd;
      pb[t->driverpath[i] + k4] += x00b;
      pbd[t->driverpath[i] + k4] += x00bd;
      tb17 = x00b / 6.0;
      tb17d = x00bd / 6.0;
      tb18 = tb17 * h;
      tb18d = tb17d * h + tb17 * hd;
      m0b -= tb18 * h;
      m0bd -= tb18d * h + tb18 * hd;
      hb -= tb18 * m0;
      hbd -= tb18d * m0 + tb18 * m0d;
      hb -= tb17 * (m0 * h);
      hbd -= tb17d * (m0 * h) + tb17 * (m0d * h + m0 * hd);
      slope22_2b += x00b * c;
      slope22_2bd += x00bd * c + x00b * cd;
      cb += x00b * slope22_2;
      cbd += x00bd * slope22_2 + x00b * slope22_2d;
      x00b = 0.0;
      x00bd = 0.0;
      tb12 = t5b / t4;
      tb12d = (t5bd - tb12 * t4d) * (1.0 / t4);
      tb13 = tb12 * a2;
      tb13d = tb12d * a2 + tb12 * a2d;
      tb14 = tb13 * a2;
      tb14d = tb13d * a2 + tb13 * a2d;
      m0b += tb14 * a2;
      m0bd += tb14d * a2 + tb14 * a2d;
      a2b += tb14 * m0;
      a2bd += tb14d * m0 + tb14 * m0d;
      a2b += tb13 * (m0 * a2);
      a2bd += tb13d * (m0 * a2) + tb13 * (m0d * a2 + m0 * a2d);
      a2b += tb12 * (m0 * a2 * a2);
      a2bd += tb12d * (m0 * a2 * a2) + tb12 * ((m0d * a2 + m0 * a2d) * a2 + m0 * a2 * a2d);
      tb15 = tb12 * c;
      tb15d = tb12d * c + tb12 * cd;
      tb16 = tb15 * c;
      tb16d = tb15d * c + tb15 * cd;
      m1b += tb16 * c;
      m1bd += tb16d * c + tb16 * cd;
      cb += tb16 * m1;
      cbd += tb16d * m1 + tb16 * m1d;
      cb += tb15 * (m1 * c);
      cbd += tb15d * (m1 * c) + tb15 * (m1d * c + m1 * cd);
      cb += tb12 * (m1 * c * c);
      cbd += tb12d * (m1 * c * c) + tb12 * ((m1d * c + m1 * cd) * c + m1 * c * cd);
      t4b = -(tb12 * t5);
      t4bd = -(tb12d * t5 + tb12 * t5d);
      hb += t4b * 6.0;
      hbd += t4bd * 6.0;
      eb += slope22_2b;
      ebd += slope22_2bd;
      hb -= slope22_2b * (m1 - m0) / 6.0;
      hbd -= (slope22_2bd * (m1 - m0) + slope22_2b * (m1d - m0d)) / 6.0;
      tb11 = slope22_2b * (h / 6.0);
      tb11d = slope22_2bd * (h / 6.0) + slope22_2b * (hd / 6.0);
      m1b -= tb11;
      m1bd -= tb11d;
      m0b += tb11;
      m0bd += tb11d;
    }
    tb8 = eb / h;
    tb8d = (ebd - tb8 * hd) * (1.0 / h);
    pb[t->driverpath[i] + k4 + 1] += tb8;
    pbd[t->driverpath[i] + k4 + 1] += tb8d;
    pb[t->driverpath[i] + k4] -= tb8;
    pbd[t->driverpath[i] + k4] -= tb8d;
    hb -= tb8 * e;
    hbd -= tb8d * e + tb8 * ed;
    path0b[t->driverrow[i] + k4 + 1][MAGGI_PATH_X] += m1b;
    path0bd[t->driverrow[i] + k4 + 1][MAGGI_PATH_X] += m1bd;
    path0b[t->driverrow[i] + k4][MAGGI_PATH_X] += m0b;
    path0bd[t->driverrow[i] + k4][MAGGI_PATH_X] += m0bd;
    s0b += cb;
    s0bd += cbd;
    path0b[t->driverrow[i] + k4][MAGGI_PATH_S] -= cb;
    path0bd[t->driverrow[i] + k4][MAGGI_PATH_S] -= cbd;
    path0b[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] += a2b;
    path0bd[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] += a2bd;
    s0b -= a2b;
    s0bd -= a2bd;
    path0b[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] += hb;
    path0bd[t->driverrow[i] + k4 + 1][MAGGI_PATH_S] += hbd;
    path0b[t->driverrow[i] + k4][MAGGI_PATH_S] -= hb;
    path0bd[t->driverrow[i] + k4][MAGGI_PATH_S] -= hbd;
    path0b[t->driverrow[i] + k3][MAGGI_PATH_S] += s0b;
    path0bd[t->driverrow[i] + k3][MAGGI_PATH_S] += s0bd;
    t3b = s0b * (path0[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k3][MAGGI_PATH_S]);
    t3bd = s0bd * (path0[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] - path0[t->driverrow[i] +
        k3][MAGGI_PATH_S]) + s0b * (path0d[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] -
        path0d[t->driverrow[i] + k3][MAGGI_PATH_S]);
    tb7 = s0b * t3;
    tb7d = s0bd * t3 + s0b * t3d;
    path0b[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] += tb7;
    path0bd[t->driverrow[i] + k3 + 1][MAGGI_PATH_S] += tb7d;
    path0b[t->driverrow[i] + k3][MAGGI_PATH_S] -= tb7;
    path0bd[t->driverrow[i] + k3][MAGGI_PATH_S] -= tb7d;
    tb4 = t3b / t2;
    tb4d = (t3bd - tb4 * t2d) * (1.0 / t2);
    tb5 = tb4 * dx;
    tb5d = tb4d * dx + tb4 * dxd;
    Pb[0] += tb5;
    Pbd[0] += tb5d;
    pb[t->driverpath[i] + k3] -= tb5;
    pbd[t->driverpath[i] + k3] -= tb5d;
    dxb = tb4 * (P[0] - p[t->driverpath[i] + k3]);
    dxbd = tb4d * (P[0] - p[t->driverpath[i] + k3]) + tb4 * (Pd[0] - pd[t->driverpath[i] + k3]);
    tb6 = tb4 * dy;
    tb6d = tb4d * dy + tb4 * dyd;
    Pb[1] += tb6;
    Pbd[1] += tb6d;
    pb[t->driverpath[i] + t->drivern[i] + k3] -= tb6;
    pbd[t->driverpath[i] + t->drivern[i] + k3] -= tb6d;
    dyb = tb4 * (P[1] - p[t->driverpath[i] + t->drivern[i] + k3]);
    dybd = tb4d * (P[1] - p[t->driverpath[i] + t->drivern[i] + k3]) + tb4 * (Pd[1] -
        pd[t->driverpath[i] + t->drivern[i] + k3]);
    t2b = -(tb4 * t3);
    t2bd = -(tb4d * t3 + tb4 * t3d);
    dxb += t2b * dx;
    dxbd += t2bd * dx + t2b * dxd;
    dxb += t2b * dx;
    dxbd += t2bd * dx + t2b * dxd;
    dyb += t2b * dy;
    dybd += t2bd * dy + t2b * dyd;
    dyb += t2b * dy;
    dybd += t2bd * dy + t2b * dyd;
    pb[t->driverpath[i] + t->drivern[i] + k3 + 1] += dyb;
    pbd[t->driverpath[i] + t->drivern[i] + k3 + 1] += dybd;
    pb[t->driverpath[i] + t->drivern[i] + k3] -= dyb;
    pbd[t->driverpath[i] + t->drivern[i] + k3] -= dybd;
    pb[t->driverpath[i] + k3 + 1] += dxb;
    /* where P is nearest to the line through piece k of the polyline, as a part of the piece */
    pbd[t->driverpath[i] + k3 + 1] += dxbd;
    pb[t->driverpath[i] + k3] -= dxb;
    pbd[t->driverpath[i] + k3] -= dxbd;
    tb3 = Pb[1];
    tb3d = Pbd[1];
    Pb[1] = 0.0;
    Pbd[1] = 0.0;
    x1_2b = tb3;
    x1_2bd = tb3d;
    p_ib = tb3 * rv[a][1];
    p_ibd = tb3d * rv[a][1] + tb3 * rvd[a][1];
    rvb[a][1] += tb3 * p_i;
    rvbd[a][1] += tb3d * p_i + tb3 * p_id;
    tb2 = Pb[0];
    tb2d = Pbd[0];
    Pb[0] = 0.0;
    Pbd[0] = 0.0;
    x0_2b = tb2;
    x0_2bd = tb2d;
    p_ib += tb2 * rv[a][0];
    p_ibd += tb2d * rv[a][0] + tb2 * rvd[a][0];
    rvb[a][0] += tb2 * p_i;
    rvbd[a][0] += tb2d * p_i + tb2 * p_id;
    pb[t->driveradr[i]] += p_ib;
    pbd[t->driveradr[i]] += p_ibd;
    rb[a][1] += x1_2b;
    rbd[a][1] += x1_2bd;
    rb[b][1] -= x1_2b;
    rbd[b][1] -= x1_2bd;
    rb[a][0] += x0_2b;
    rbd[a][0] += x0_2bd;
    rb[b][0] -= x0_2b;
    rbd[b][0] -= x0_2bd;
  }
}
