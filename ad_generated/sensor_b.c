/* Adjoint of core/kernel/sensor.c.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "maggi_ad.h"
#include "maggi/maggi.h"

/* ra and Za carry minus gravity; p begins with gravity */
void maggi_sensors_b(const maggi_topo *t, const double p[restrict t->np], double pb[restrict t->np],
                     const double origin[restrict 3], const double spring0[restrict t->nspring],
                     double spring0b[restrict t->nspring], const double q[restrict t->nq],
                     double qb[restrict t->nq], const double v[restrict t->nq],
                     double vb[restrict t->nq], const double A[restrict t->nbody + 1][9],
                     double Ab[restrict t->nbody + 1][9], const double x[restrict t->nbody + 1][3],
                     double xb[restrict t->nbody + 1][3], const double r[restrict t->npoint][3],
                     double rb[restrict t->npoint][3], const double Z[restrict t->nbody + 1][6],
                     double Zb[restrict t->nbody + 1][6], const double rv[restrict t->npoint][3],
                     double rvb[restrict t->npoint][3], const double Za[restrict t->nbody + 1][6],
                     double Zab[restrict t->nbody + 1][6], const double ra[restrict t->npoint][3],
                     double rab[restrict t->npoint][3], const double driver[restrict t->ndriver][4],
                     double driverb[restrict t->ndriver][4],
                     const double speed[restrict t->nspeed][3],
                     double speedb[restrict t->nspeed][3], const double lambda[restrict t->nrow],
                     double lambdab[restrict t->nrow], double s[restrict t->nsensor][3],
                     double sb[restrict t->nsensor][3])
{
  int a, a4, a4_2, b, b2, b2_2, i, j, k, k2, n2;
  double A_j0, A_j0b, A_j3, A_j3b, A_j7, A_j7b, A_j8, A_j8b, L0, L0b, L1, L1b, L2, L2b, N0, N0b, N1,
      N2, N2b, T0, T0b, T1, T1b, T2, T2b, Z_j3, Z_j3b, Z_j4, Z_j4b, Z_k3, Z_k3b, Z_k4, Z_k4b, Z_k5,
      Z_k5b, a00, a00b, a01, a01b, a02, a02b, a2, a2b, a3, a3b, along0, along0b, along1, along1b,
      along2, along2b, ar, arb, areq, areqb, arm0, arm0b, arm1, arm1b, arm2, arm2b, at, atb, ateq,
      ateqb, ay, ayb, br, brb, bt, btb, bx, bxb, by, byb, bycy, bycyb, c, c2, c2b, ca, cab, cb, cx,
      cxb, cy, cyb, dampingb, dfz, dfzb, dr, drb, dt, dtb, dv, dvb, dx, dxb, dy, dyb, e0, e0b, e1,
      e10, e10b, e11, e11b, e12, e12b, e13, e13b, e1b, e20, e20b, e21, e21b, e22, e22b, e2_2, e2_2b,
      e3, e3b, e4, e4b, e5, e5b, e6, e6b, e7, e7b, e8, e8b, e9, e9b, et, etb, ev0, ev0b, ev1, ev1b,
      ev20, ev20b, ev21, ev21b, ev22, ev22b, ev2_2, ev2_2b, ex, exb, ey, eyb, f0b, f1b, f2b,
      force0b, force1b, force2b, force3b, force4b, force5b, fx, fxb, fy, fyb, fz, fz0, fz0_2,
      fz0_2b, fz0_3, fz0_3b, fz0_4, fz0_4b, fz0b, fz2, fz2b, fzb, g0, g0b, g20, g20b, g21, g21b,
      g2_2, g2_2b, gamma, gamma2, gamma2b, gammab, gx, gxb, gy, gyb, gz, gzb, h00, h00b, h10, h10b,
      h11, h11b, kappa, kappa2, kappa2b, kappab, kx, kxb, l, l2, l2b, lb, lv, lvb, mux, muxb, muy,
      muy2, muy2b, muyb, n30, n30b, n31, n31b, n32, n32b, n4, n4b, n50, n50b, n51, n52, n52b, omega,
      omegab, one0, one0b, one1, one1b, one2, one2b, one3, one3b, one4, one4b, p10, p10b, p2, p2b,
      p3, p3b, p4, p4b, p5, p5b, p6, p6b, p7, p7b, p8, p8b, p9, p9b, p_b2, p_b2_2, p_b2_2b, p_b2_3,
      p_b2_3b, p_b2_4, p_b2_4b, p_b2_5, p_b2_5b, p_b2_6, p_b2_6b, p_b2b, p_k24, p_k24b, p_k25,
      p_k25b, r0, r0b, r2, r2b, ratio, ratio2, ratio2b, ratiob, re, reb, rhov, rhovb, roll, rollb,
      rolling0b, rolling1b, rolling2b, rolling3b, rolling4b, rolling5b, s2, s2b, s3, s3b, s4, s4b,
      shift, shiftb, shy, shyb, side, slip0b, slip1, slip1b, slip2b, speed2, speed2b, speed3,
      speed3b, stiff, stiff2, stiff2b, stiff3, stiff3b, stiff4, stiff4b, stiffb, svx, svxb, svy,
      svyb, t10, t10b, t11, t11b, t12, t12b, t13, t13b, t14, t14b, t15, t15b, t16, t16b, t17, t17b,
      t18, t18b, t19, t19b, t2, t20, t20b, t21, t21b, t22, t22b, t23, t23b, t24, t24b, t25, t25b,
      t26, t26b, t27, t27b, t28, t28b, t29, t29b, t2b, t3, t30, t30b, t31, t31b, t32, t32b, t33,
      t33b, t34, t34b, t35, t35b, t36, t36b, t37, t37b, t38, t38b, t39, t39b, t3b, t4, t40, t40b,
      t41, t41b, t42, t42b, t43, t43b, t44, t44b, t45, t45b, t46, t46b, t47, t47b, t48, t48b, t49,
      t49b, t4b, t5, t50, t50b, t51, t51b, t52, t52b, t53, t53b, t54, t54b, t55, t55b, t56, t56b,
      t57, t57b, t58, t58b, t59, t59b, t5b, t6, t60, t60b, t61, t61b, t62, t62b, t63, t63b, t64,
      t64b, t65, t65b, t66, t66b, t67, t67b, t68, t68b, t69, t69b, t6b, t7, t70, t70b, t71, t71b,
      t72, t72b, t73, t73b, t74, t74b, t75, t75b, t76, t76b, t77, t77b, t78, t78b, t79, t79b, t7b,
      t8, t80, t80b, t81, t81b, t82, t82b, t83, t83b, t84, t84b, t85, t85b, t86, t86b, t87, t87b,
      t88, t88b, t89, t89b, t8b, t9, t90, t90b, t91, t91b, t92, t92b, t93, t93b, t94, t94b, t95,
      t95b, t96, t96b, t97, t97b, t9b, tb10, tb100, tb101, tb102, tb103, tb104, tb105, tb106, tb107,
      tb108, tb109, tb11, tb110, tb111, tb112, tb113, tb114, tb115, tb116, tb117, tb118, tb119,
      tb12, tb120, tb121, tb122, tb123, tb124, tb125, tb126, tb127, tb128, tb129, tb13, tb130,
      tb131, tb132, tb133, tb134, tb135, tb136, tb137, tb138, tb139, tb14, tb140, tb141, tb142,
      tb143, tb144, tb145, tb146, tb147, tb148, tb149, tb15, tb150, tb151, tb152, tb153, tb154,
      tb155, tb156, tb157, tb158, tb159, tb16, tb160, tb161, tb162, tb163, tb164, tb165, tb17, tb18,
      tb19, tb2, tb20, tb21, tb22, tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3, tb30, tb31, tb32,
      tb33, tb34, tb35, tb36, tb37, tb38, tb39, tb4, tb40, tb41, tb42, tb43, tb44, tb45, tb46, tb47,
      tb48, tb49, tb5, tb50, tb51, tb52, tb53, tb54, tb55, tb56, tb57, tb58, tb59, tb6, tb60, tb61,
      tb62, tb63, tb64, tb65, tb66, tb67, tb68, tb69, tb7, tb70, tb71, tb72, tb73, tb74, tb75, tb76,
      tb77, tb78, tb79, tb8, tb80, tb81, tb82, tb83, tb84, tb85, tb86, tb87, tb88, tb89, tb9, tb90,
      tb91, tb92, tb93, tb94, tb95, tb96, tb97, tb98, tb99, torque0b, u20, u20b, u21, u21b, u22,
      u22b, ua0, ua0b, ua1, ua1b, ua2, ua2b, un0, un0b, un1, un1b, un2, un2b, v20, v20b, v21, v21b,
      v22, v22b, vr0, vr0b, vr1, vr1b, vr2, vr2b, vx, vxb, w, way, wayb, wb, wr0, wr0b, wr1, wr1b,
      wr2, wr2b, x2, x2b, x3, x3b, x4, x4b, x50, x50b, x51, x51b, x6, x6b, x7, x7b, x8, x8b, x9,
      x9b, xv, xvb, y, y10, y10b, y11, y11b, y12, y12b, y13, y13b, y14, y14b, y15, y15b, y16, y16b,
      y17, y17b, y18, y18b, y20, y20b, y21, y21b, y22, y22b, y23, y23b, y24, y24b, y3, y3b, y4, y4b,
      y5, y5b, y6, y6b, y7, y7b, y8, y8b, y9, y9b, yb, z0_2b, z0_3b, z0b, z1_2b, z1_3, z1_3b, z1b,
      z20, z20b, z21, z21b, z22, z22b, z30, z30b, z31b, z4, z4b, z5, z5b, z6, z6b;

  (void)origin;
  (void)x;
  (void)Za;
  (void)ra;
  (void)driver;
  (void)speed;
  (void)lambda;
  A_j0 = 0.0;
  A_j3 = 0.0;
  A_j7 = 0.0;
  A_j8 = 0.0;
  L0 = 0.0;
  L1 = 0.0;
  L2 = 0.0;
  N0 = 0.0;
  N1 = 0.0;
  N2 = 0.0;
  T0 = 0.0;
  T1 = 0.0;
  T2 = 0.0;
  Z_j3 = 0.0;
  Z_j4 = 0.0;
  Z_k3 = 0.0;
  Z_k4 = 0.0;
  Z_k5 = 0.0;
  a00 = 0.0;
  a01 = 0.0;
  a02 = 0.0;
  a2 = 0.0;
  along0 = 0.0;
  along1 = 0.0;
  along2 = 0.0;
  arm0 = 0.0;
  arm1 = 0.0;
  arm2 = 0.0;
  c = 0.0;
  c2 = 0.0;
  e0 = 0.0;
  e1 = 0.0;
  e20 = 0.0;
  e21 = 0.0;
  e22 = 0.0;
  e2_2 = 0.0;
  ev0 = 0.0;
  ev1 = 0.0;
  ev20 = 0.0;
  ev21 = 0.0;
  ev22 = 0.0;
  ev2_2 = 0.0;
  fz = 0.0;
  fz0 = 0.0;
  g0 = 0.0;
  g2_2 = 0.0;
  gamma = 0.0;
  h00 = 0.0;
  h10 = 0.0;
  h11 = 0.0;
  kappa = 0.0;
  l = 0.0;
  l2 = 0.0;
  lv = 0.0;
  n30 = 0.0;
  n31 = 0.0;
  n32 = 0.0;
  n4 = 0.0;
  n50 = 0.0;
  n51 = 0.0;
  n52 = 0.0;
  omega = 0.0;
  p2 = 0.0;
  p3 = 0.0;
  r2 = 0.0;
  ratio = 0.0;
  re = 0.0;
  rhov = 0.0;
  roll = 0.0;
  s2 = 0.0;
  side = 0.0;
  slip1 = 0.0;
  speed2 = 0.0;
  t11 = 0.0;
  t12 = 0.0;
  t2 = 0.0;
  t20 = 0.0;
  t21 = 0.0;
  t22 = 0.0;
  t4 = 0.0;
  t5 = 0.0;
  u20 = 0.0;
  u21 = 0.0;
  u22 = 0.0;
  ua0 = 0.0;
  ua1 = 0.0;
  ua2 = 0.0;
  un0 = 0.0;
  un1 = 0.0;
  un2 = 0.0;
  v20 = 0.0;
  v21 = 0.0;
  v22 = 0.0;
  vx = 0.0;
  w = 0.0;
  wr0 = 0.0;
  wr1 = 0.0;
  wr2 = 0.0;
  x2 = 0.0;
  x3 = 0.0;
  x4 = 0.0;
  xv = 0.0;
  z1_3 = 0.0;
  z20 = 0.0;
  z21 = 0.0;
  z22 = 0.0;
  a = 0;
  a4 = 0;
  a4_2 = 0;
  b = 0;
  b2 = 0;
  b2_2 = 0;
  k2 = 0;
  for (i = t->nsensor - 1; i >= 0; --i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n2 = t->sensorelement[i];
    if (t->sensorkind[i] != MAGGI_SENSOR_POSITION) {
      if (t->sensorkind[i] != MAGGI_SENSOR_VELOCITY) {
        if (t->sensorkind[i] != MAGGI_SENSOR_ACCELERATION) {
          if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
            A_j7 = A[j][7];
            A_j8 = A[j][8];
            t2 = -A[j][6];
            t3 = A_j7 * A_j7 + A_j8 * A_j8;
            t4 = sqrt(t3);
          } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
            A_j0 = A[j][0];
            A_j3 = A[j][3];
            c2 = A_j0 * A_j0 + A_j3 * A_j3;
            Z_j3 = Z[j][3];
            Z_j4 = Z[j][4];
            roll = s[i][0];
            t5 = sqrt(c2);
          } else {
            if (t->sensorkind[i] != MAGGI_SENSOR_ANGULAR_VELOCITY) {
              if (t->sensorkind[i] != MAGGI_SENSOR_ANGULAR_ACCELERATION) {
                if (t->sensorkind[i] == MAGGI_SENSOR_SPRING) {
                  a = t->springpa[n2];
                  b = t->springpb[n2];
                  e0 = r[a][0] - r[b][0];
                  ev0 = rv[a][0] - rv[b][0];
                  e1 = r[a][1] - r[b][1];
                  ev1 = rv[a][1] - rv[b][1];
                  e2_2 = r[a][2] - r[b][2];
                  ev2_2 = rv[a][2] - rv[b][2];
                  t6 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
                  l = sqrt(t6);
                  n30 = e0 / l;
                  n31 = e1 / l;
                  n32 = e2_2 / l;
                  lv = n30 * ev0 + n31 * ev1 + n32 * ev2_2;
                  k2 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
                } else if (t->sensorkind[i] == MAGGI_SENSOR_JOINT_SPRING) {
                  if (t->jspringq2[n2] >= 0) {
                    x2 = q[t->jspringq[n2]] - q[t->jspringq2[n2]];
                    xv = v[t->jspringq[n2]] - v[t->jspringq2[n2]];
                  } else {
                    x2 = q[t->jspringq[n2]];
                    xv = v[t->jspringq[n2]];
                  }
                } else if (t->sensorkind[i] == MAGGI_SENSOR_ROD) {
                  a4 = t->primpa[n2];
                  b2 = t->primpb[n2];
                  e20 = r[a4][0] - r[b2][0];
                  ev20 = rv[a4][0] - rv[b2][0];
                  e21 = r[a4][1] - r[b2][1];
                  ev21 = rv[a4][1] - rv[b2][1];
                  e22 = r[a4][2] - r[b2][2];
                  ev22 = rv[a4][2] - rv[b2][2];
                  t7 = e20 * e20 + e21 * e21 + e22 * e22;
                  l2 = sqrt(t7);
                  z1_3 = s[i][1];
                } else {
                  if (t->sensorkind[i] != MAGGI_SENSOR_SPEED) {
                    if (t->sensorkind[i] != MAGGI_SENSOR_DRIVER) {
                      a4_2 = t->wheelpoint[n2];
                      b2_2 = t->wheelroad[n2];
                      j = t->wheelbody[n2];
                      k = t->wheelcarrier[n2];
                      side = t->wheelmirror[n2] ? -1.0 : 1.0;
                      a00 = p[t->wheelaxis[n2]];
                      a01 = p[t->wheelaxis[n2] + 1];
                      a02 = p[t->wheelaxis[n2] + 2];
                      ua0 = A[j][0] * a00 + A[j][1] * a01 + A[j][2] * a02;
                      ua1 = A[j][3] * a00 + A[j][4] * a01 + A[j][5] * a02;
                      ua2 = A[j][6] * a00 + A[j][7] * a01 + A[j][8] * a02;
                      t8 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
                      n4 = sqrt(t8);
                      u20 = ua0 / n4;
                      u21 = ua1 / n4;
                      u22 = ua2 / n4;
                      g0 = r[a4_2][0] - r[t->roadpoint[b2_2]][0];
                      g2_2 = r[a4_2][2] - r[t->roadpoint[b2_2]][2];
                      x4 = g0;
                      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
                        p_b2 = p[t->roadadr[b2_2]];
                        h00 = p_b2 * x4;
                      } else {
                        p_b2_2 = p[t->roadadr[b2_2] + 1];
                        t9 = 6.28318530717958647693 * x4 / p_b2_2;
                        t10 = sin(t9);
                        p_b2_3 = p[t->roadadr[b2_2]];
                        h00 = p_b2_3 * t10;
                      }
                      t11 = u20 * u20 + u21 * u21;
                      t12 = u22 * u20 / t11;
                      x3 = g0 + t12 * (g2_2 - h00);
                      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
                        p_b2_4 = p[t->roadadr[b2_2]];
                        h10 = p_b2_4 * x3;
                        h11 = p_b2_4;
                      } else {
                        p_b2_5 = p[t->roadadr[b2_2] + 1];
                        t13 = 6.28318530717958647693 * x3 / p_b2_5;
                        t14 = sin(t13);
                        p_b2_6 = p[t->roadadr[b2_2]];
                        h10 = p_b2_6 * t14;
                        t15 = p_b2_6 * 6.28318530717958647693 / p_b2_5;
                        t16 = 6.28318530717958647693 * x3 / p_b2_5;
                        t17 = cos(t16);
                        h11 = t15 * t17;
                      }
                      t18 = 1.0 + h11 * h11;
                      s2 = sqrt(t18);
                      n50 = -h11 / s2;
                      n51 = 0.0;
                      n52 = 1.0 / s2;
                      c = u20 * n50 + u21 * n51 + u22 * n52;
                      un0 = u21 * n52 - u22 * n51;
                      un1 = u22 * n50 - u20 * n52;
                      un2 = u20 * n51 - u21 * n50;
                      t19 = un0 * un0 + un1 * un1 + un2 * un2;
                      w = sqrt(t19);
                      r2 = ((g0 - x3) * n50 + (g2_2 - h10) * n52) / w;
                      along0 = un0 / w;
                      along1 = un1 / w;
                      along2 = un2 / w;
                      L0 = n51 * along2 - n52 * along1;
                      L1 = n52 * along0 - n50 * along2;
                      L2 = n50 * along1 - n51 * along0;
                      arm0 = r2 * (c * u20 - n50) / w;
                      T0 = along0;
                      N0 = n50;
                      arm1 = r2 * (c * u21 - n51) / w;
                      T1 = along1;
                      N1 = n51;
                      arm2 = r2 * (c * u22 - n52) / w;
                      T2 = along2;
                      N2 = n52;
                      z20 = r2;
                      z21 = c;
                      z22 = w;
                      Z_k3 = Z[k][3];
                      wr0 = Z_k3;
                      Z_k4 = Z[k][4];
                      wr1 = Z_k4;
                      Z_k5 = Z[k][5];
                      wr2 = Z_k5;
                      vr0 = wr1 * arm2 - wr2 * arm1;
                      vr1 = wr2 * arm0 - wr0 * arm2;
                      vr2 = wr0 * arm1 - wr1 * arm0;
                      v20 = rv[a4_2][0] + vr0;
                      v21 = rv[a4_2][1] + vr1;
                      v22 = rv[a4_2][2] + vr2;
                      vx = v20 * T0 + v21 * T1 + v22 * T2;
                      rhov = -(v20 * N0 + v21 * N1 + v22 * N2) / z22;
                      omega = (Z[j][3] - Z_k3) * u20 + (Z[j][4] - Z_k4) * u21 + (Z[j][5] - Z_k5) *
                          u22;
                      p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
                      p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
                      fz = p2 * (p3 - z20) + p[t->tyreadr[t->wheeltyre[n2]] +
                          MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
                      fz0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
                          p[t->tyreadr[t->wheeltyre[n2]]];
                      ratio = fz / fz0;
                      t20 = fz0 / p2;
                      t21 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratio;
                      t22 = atan(t21);
                      re = p3 - t20 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22 +
                          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio);
                      if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
                          MAGGI_TYRE_VXLOW])) {
                        y = vx;
                      } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
                          MAGGI_TYRE_VXLOW])) {
                        y = -vx;
                      } else {
                        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW];
                        t23 = vx * vx / p4;
                        y = 0.5 * (p4 + t23);
                      }
                      speed2 = y;
                      kappa = (omega * re - vx) / speed2;
                      a2 = (v20 * L0 + v21 * L1 + v22 * L2) / speed2;
                      gamma = atan2(z21, z22);
                      slip1 = a2;
                    }
                  }
                }
              }
            }
          }
        }
      }
    }
    A_j0b = 0.0;
    A_j3b = 0.0;
    A_j7b = 0.0;
    A_j8b = 0.0;
    L0b = 0.0;
    L1b = 0.0;
    L2b = 0.0;
    N0b = 0.0;
    N2b = 0.0;
    T0b = 0.0;
    T1b = 0.0;
    T2b = 0.0;
    Z_j3b = 0.0;
    Z_j4b = 0.0;
    Z_k3b = 0.0;
    Z_k4b = 0.0;
    Z_k5b = 0.0;
    a00b = 0.0;
    a01b = 0.0;
    a02b = 0.0;
    a2b = 0.0;
    along0b = 0.0;
    along1b = 0.0;
    along2b = 0.0;
    arm0b = 0.0;
    arm1b = 0.0;
    arm2b = 0.0;
    c2b = 0.0;
    cb = 0.0;
    dampingb = 0.0;
    e0b = 0.0;
    e1b = 0.0;
    e20b = 0.0;
    e21b = 0.0;
    e22b = 0.0;
    e2_2b = 0.0;
    ev0b = 0.0;
    ev1b = 0.0;
    ev20b = 0.0;
    ev21b = 0.0;
    ev22b = 0.0;
    ev2_2b = 0.0;
    f0b = 0.0;
    f1b = 0.0;
    fz0b = 0.0;
    fzb = 0.0;
    g0b = 0.0;
    g2_2b = 0.0;
    gammab = 0.0;
    h00b = 0.0;
    h10b = 0.0;
    h11b = 0.0;
    kappab = 0.0;
    l2b = 0.0;
    lb = 0.0;
    lvb = 0.0;
    n30b = 0.0;
    n31b = 0.0;
    n32b = 0.0;
    n4b = 0.0;
    n50b = 0.0;
    n52b = 0.0;
    omegab = 0.0;
    p2b = 0.0;
    p3b = 0.0;
    r2b = 0.0;
    ratiob = 0.0;
    reb = 0.0;
    rhovb = 0.0;
    rollb = 0.0;
    rolling0b = 0.0;
    rolling1b = 0.0;
    rolling2b = 0.0;
    rolling3b = 0.0;
    rolling4b = 0.0;
    rolling5b = 0.0;
    s2b = 0.0;
    slip0b = 0.0;
    slip1b = 0.0;
    slip2b = 0.0;
    speed2b = 0.0;
    t11b = 0.0;
    t12b = 0.0;
    t18b = 0.0;
    t19b = 0.0;
    t20b = 0.0;
    t21b = 0.0;
    t22b = 0.0;
    t2b = 0.0;
    t3b = 0.0;
    t4b = 0.0;
    t5b = 0.0;
    t6b = 0.0;
    t7b = 0.0;
    t8b = 0.0;
    torque0b = 0.0;
    u20b = 0.0;
    u21b = 0.0;
    u22b = 0.0;
    ua0b = 0.0;
    ua1b = 0.0;
    ua2b = 0.0;
    un0b = 0.0;
    un1b = 0.0;
    un2b = 0.0;
    v20b = 0.0;
    v21b = 0.0;
    v22b = 0.0;
    vr0b = 0.0;
    vr1b = 0.0;
    vr2b = 0.0;
    vxb = 0.0;
    wb = 0.0;
    wr0b = 0.0;
    wr1b = 0.0;
    wr2b = 0.0;
    x2b = 0.0;
    x3b = 0.0;
    x4b = 0.0;
    xvb = 0.0;
    yb = 0.0;
    z0_2b = 0.0;
    z0_3b = 0.0;
    z0b = 0.0;
    z1_2b = 0.0;
    z1_3b = 0.0;
    z1b = 0.0;
    z20b = 0.0;
    z21b = 0.0;
    z22b = 0.0;
    if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
      tb4 = sb[i][2];
      sb[i][2] = 0.0;
      rb[k][2] += tb4;
      xb[t->nbody][2] -= tb4;
      tb3 = sb[i][1];
      sb[i][1] = 0.0;
      rb[k][1] += tb3;
      xb[t->nbody][1] -= tb3;
      tb2 = sb[i][0];
      sb[i][0] = 0.0;
      rb[k][0] += tb2;
      xb[t->nbody][0] -= tb2;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
      rvb[k][2] += sb[i][2];
      sb[i][2] = 0.0;
      rvb[k][1] += sb[i][1];
      sb[i][1] = 0.0;
      rvb[k][0] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ACCELERATION) {
      tb7 = sb[i][2];
      sb[i][2] = 0.0;
      rab[k][2] += tb7;
      pb[2] += tb7;
      tb6 = sb[i][1];
      sb[i][1] = 0.0;
      rab[k][1] += tb6;
      pb[1] += tb6;
      tb5 = sb[i][0];
      sb[i][0] = 0.0;
      rab[k][0] += tb5;
      pb[0] += tb5;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      tb10 = sb[i][2];
      sb[i][2] = 0.0;
      Ab[j][3] += tb10 * (A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      Ab[j][0] -= tb10 * (A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      tb9 = sb[i][1];
      sb[i][1] = 0.0;
      t2b += tb9 * (t4 / (t4 * t4 + t2 * t2));
      t4b -= tb9 * (t2 / (t4 * t4 + t2 * t2));
      t3b += t4b * (1.0 / (2.0 * t4));
      A_j7b += t3b * A_j7;
      A_j7b += t3b * A_j7;
      A_j8b += t3b * A_j8;
      A_j8b += t3b * A_j8;
      Ab[j][6] -= t2b;
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      tb8 = sb[i][0];
      sb[i][0] = 0.0;
      A_j7b += tb8 * (A_j8 / (A_j8 * A_j8 + A_j7 * A_j7));
      A_j8b -= tb8 * (A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      Ab[j][8] += A_j8b;
      Ab[j][7] += A_j7b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      tb14 = sb[i][2];
      sb[i][2] = 0.0;
      Zb[j][5] += tb14;
      Ab[j][6] -= tb14 * roll;
      rollb -= tb14 * A[j][6];
      tb12 = sb[i][1];
      sb[i][1] = 0.0;
      tb13 = tb12 / t5;
      A_j0b += tb13 * Z_j4;
      Z_j4b += tb13 * A_j0;
      A_j3b -= tb13 * Z_j3;
      Z_j3b -= tb13 * A_j3;
      t5b -= tb13 * s[i][1];
      c2b += t5b * (1.0 / (2.0 * t5));
      rollb += sb[i][0];
      sb[i][0] = 0.0;
      tb11 = rollb / c2;
      A_j0b += tb11 * Z_j3;
      Z_j3b += tb11 * A_j0;
      A_j3b += tb11 * Z_j4;
      Z_j4b += tb11 * A_j3;
      c2b -= tb11 * roll;
      Zb[j][4] += Z_j4b;
      Zb[j][3] += Z_j3b;
      /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
       * A_6 = -sin(pitch) */
      A_j0b += c2b * A_j0;
      A_j0b += c2b * A_j0;
      A_j3b += c2b * A_j3;
      A_j3b += c2b * A_j3;
      Ab[j][3] += A_j3b;
      Ab[j][0] += A_j0b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_VELOCITY) {
      Zb[j][5] += sb[i][2];
      sb[i][2] = 0.0;
      Zb[j][4] += sb[i][1];
      sb[i][1] = 0.0;
      Zb[j][3] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_ACCELERATION) {
      Zab[j][5] += sb[i][2];
      sb[i][2] = 0.0;
      Zab[j][4] += sb[i][1];
      sb[i][1] = 0.0;
      Zab[j][3] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SPRING) {
      tb22 = sb[i][2];
      sb[i][2] = 0.0;
      f0b += tb22;
      f1b += tb22;
      z1b += sb[i][1];
      sb[i][1] = 0.0;
      z0b += sb[i][0];
      sb[i][0] = 0.0;
      lvb += z1b;
      lb += z0b;
      if (t->springslopes[n2]) {
        dampingb += f1b;
        f2b = f1b;
        f1b = 0.0;
        /* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
        if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 4])) {
          p_k24 = p[k2 + 4];
          pb[k2] += f2b * p_k24;
          p_k24b = f2b * p[k2];
          pb[k2 + 1] += f2b * (lv - p_k24);
          tb20 = f2b * p[k2 + 1];
          lvb += tb20;
          p_k24b -= tb20;
          f2b = 0.0;
          pb[k2 + 4] += p_k24b;
        } else if (MAGGI_RE(lv) > 0.0) {
          pb[k2] += f2b * lv;
          lvb += f2b * p[k2];
          f2b = 0.0;
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k2 + 5])) {
          pb[k2 + 2] += f2b * lv;
          lvb += f2b * p[k2 + 2];
          f2b = 0.0;
        } else {
          p_k25 = p[k2 + 5];
          pb[k2 + 2] += f2b * p_k25;
          p_k25b = f2b * p[k2 + 2];
          pb[k2 + 3] += f2b * (lv - p_k25);
          tb21 = f2b * p[k2 + 3];
          lvb += tb21;
          p_k25b -= tb21;
          f2b = 0.0;
          pb[k2 + 5] += p_k25b;
        }
      } else {
        dampingb += f1b;
        f1b = 0.0;
      }
      if (t->springpreload[n2]) {
        pb[t->springadr[n2]] += f0b * (l - spring0[n2]);
        tb18 = f0b * p[t->springadr[n2]];
        lb += tb18;
        spring0b[n2] -= tb18;
        pb[t->springadr[n2] + MAGGI_SPRING_L] += f0b;
        f0b = 0.0;
      } else {
        pb[t->springadr[n2]] += f0b * (l - p[t->springadr[n2] + MAGGI_SPRING_L]);
        tb19 = f0b * p[t->springadr[n2]];
        lb += tb19;
        pb[t->springadr[n2] + MAGGI_SPRING_L] -= tb19;
        f0b = 0.0;
      }
      pb[t->springadr[n2] + MAGGI_SPRING_C] += dampingb * lv;
      lvb += dampingb * p[t->springadr[n2] + MAGGI_SPRING_C];
      n30b += lvb * ev0;
      ev0b += lvb * n30;
      n31b += lvb * ev1;
      ev1b += lvb * n31;
      n32b += lvb * ev2_2;
      ev2_2b += lvb * n32;
      tb17 = n32b / l;
      e2_2b += tb17;
      lb -= tb17 * n32;
      tb16 = n31b / l;
      e1b += tb16;
      lb -= tb16 * n31;
      tb15 = n30b / l;
      e0b += tb15;
      lb -= tb15 * n30;
      t6b += lb * (1.0 / (2.0 * l));
      e0b += t6b * e0;
      e0b += t6b * e0;
      e1b += t6b * e1;
      e1b += t6b * e1;
      e2_2b += t6b * e2_2;
      e2_2b += t6b * e2_2;
      rvb[a][2] += ev2_2b;
      rvb[b][2] -= ev2_2b;
      rb[a][2] += e2_2b;
      rb[b][2] -= e2_2b;
      rvb[a][1] += ev1b;
      rvb[b][1] -= ev1b;
      rb[a][1] += e1b;
      rb[b][1] -= e1b;
      rvb[a][0] += ev0b;
      rvb[b][0] -= ev0b;
      rb[a][0] += e0b;
      rb[b][0] -= e0b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_JOINT_SPRING) {
      torque0b += sb[i][2];
      sb[i][2] = 0.0;
      z1_2b += sb[i][1];
      sb[i][1] = 0.0;
      z0_2b += sb[i][0];
      sb[i][0] = 0.0;
      xvb += z1_2b;
      x2b += z0_2b;
      pb[t->jspringadr[n2]] -= torque0b * (x2 - p[t->jspringadr[n2] + MAGGI_JSPRING_REST]);
      tb23 = torque0b * p[t->jspringadr[n2]];
      x2b -= tb23;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_REST] += tb23;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_C] -= torque0b * xv;
      xvb -= torque0b * p[t->jspringadr[n2] + MAGGI_JSPRING_C];
      pb[t->jspringadr[n2] + MAGGI_JSPRING_PRELOAD] -= torque0b;
      if (t->jspringq2[n2] >= 0) {
        vb[t->jspringq[n2]] += xvb;
        vb[t->jspringq2[n2]] -= xvb;
        xvb = 0.0;
        qb[t->jspringq[n2]] += x2b;
        qb[t->jspringq2[n2]] -= x2b;
        x2b = 0.0;
      } else {
        vb[t->jspringq[n2]] += xvb;
        xvb = 0.0;
        qb[t->jspringq[n2]] += x2b;
        x2b = 0.0;
      }
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ROD) {
      lambdab[t->primrow[n2]] += sb[i][2];
      sb[i][2] = 0.0;
      z1_3b += sb[i][1];
      sb[i][1] = 0.0;
      z0_3b += sb[i][0];
      sb[i][0] = 0.0;
      tb24 = z1_3b / l2;
      e20b += tb24 * ev20;
      ev20b += tb24 * e20;
      e21b += tb24 * ev21;
      ev21b += tb24 * e21;
      e22b += tb24 * ev22;
      ev22b += tb24 * e22;
      l2b -= tb24 * z1_3;
      l2b += z0_3b;
      t7b += l2b * (1.0 / (2.0 * l2));
      e20b += t7b * e20;
      e20b += t7b * e20;
      e21b += t7b * e21;
      e21b += t7b * e21;
      e22b += t7b * e22;
      e22b += t7b * e22;
      rvb[a4][2] += ev22b;
      rvb[b2][2] -= ev22b;
      rb[a4][2] += e22b;
      rb[b2][2] -= e22b;
      rvb[a4][1] += ev21b;
      rvb[b2][1] -= ev21b;
      rb[a4][1] += e21b;
      rb[b2][1] -= e21b;
      rvb[a4][0] += ev20b;
      rvb[b2][0] -= ev20b;
      /* distance of two points and its rate */
      rb[a4][0] += e20b;
      rb[b2][0] -= e20b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SPEED) {
      speedb[n2][2] += sb[i][2];
      sb[i][2] = 0.0;
      speedb[n2][1] += sb[i][1];
      sb[i][1] = 0.0;
      speedb[n2][0] += sb[i][0];
      sb[i][0] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_DRIVER) {
      driverb[n2][2] += sb[i][2];
      sb[i][2] = 0.0;
      driverb[n2][1] += sb[i][1];
      sb[i][1] = 0.0;
      driverb[n2][0] += sb[i][0];
      sb[i][0] = 0.0;
    } else {
      if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_SLIP) {
        slip2b += sb[i][2];
        sb[i][2] = 0.0;
        tb165 = sb[i][1];
        sb[i][1] = 0.0;
        slip1b += tb165 * (1.0 / (1.0 + slip1 * slip1));
        slip0b += sb[i][0];
        sb[i][0] = 0.0;
      } else if (t->sensorkind[i] == MAGGI_SENSOR_TYRE_FORCE) {
        rolling2b += sb[i][2];
        sb[i][2] = 0.0;
        rolling1b += sb[i][1];
        sb[i][1] = 0.0;
        rolling0b += sb[i][0];
        sb[i][0] = 0.0;
      } else {
        rolling5b += sb[i][2];
        sb[i][2] = 0.0;
        rolling4b += sb[i][1];
        sb[i][1] = 0.0;
        rolling3b += sb[i][0];
        sb[i][0] = 0.0;
      }
      gammab += slip2b;
      a2b += slip1b;
      kappab += slip0b;
      if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z20) < MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
          MAGGI_TYRE_UNLOADED_RADIUS])) {
        one0 = kappa;
        one1 = side * a2;
        one2 = side * gamma;
        one3 = fz;
        one4 = vx;
        one0b = 0.0;
        one1b = 0.0;
        one2b = 0.0;
        one3b = 0.0;
        one4b = 0.0;
        if (t->wheelgrip[n2]) {
          kappa2 = one0;
          a3 = one1;
          gamma2 = one2;
          fz2 = one3;
          fz0_2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          r0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          dfz = (fz2 - fz0_2) / fz0_2;
          kx = kappa2 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
          gx = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
          cx = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LCX];
          mux = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] *
              gx * gx) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          dx = mux * fz2;
          e3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEX2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz *
              dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
          if (MAGGI_RE(kx) > 0.0) {
            e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            if (MAGGI_RE(e4) > 1.0) {
              y3 = 1.0;
            } else {
              y3 = e4;
            }
            ex = y3;
          } else {
            e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            if (MAGGI_RE(e5) > 1.0) {
              y4 = 1.0;
            } else {
              y4 = e5;
            }
            ex = y4;
          }
          t24 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
          t25 = exp(t24);
          stiff = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t25 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          t26 = cx * dx;
          bx = stiff / t26;
          svx = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUX];
          y5 = bx * kx;
          t27 = atan(y5);
          t28 = (1.0 - ex) * y5 + ex * t27;
          t29 = atan(t28);
          t30 = cx * t29;
          t31 = sin(t30);
          x50 = dx * t31 + svx;
          x51 = stiff;
          fz0_3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          gy = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
          shy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PHY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] * gy;
          ay = a3 + shy;
          cy = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LCY];
          muy = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] *
              gy * gy) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          dy = muy * fz2;
          e6 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PEY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
          if (MAGGI_RE(ay) > 0.0) {
            e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            if (MAGGI_RE(e7) > 1.0) {
              y6 = 1.0;
            } else {
              y6 = e7;
            }
            ey = y6;
          } else {
            e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            if (MAGGI_RE(e8) > 1.0) {
              y7 = 1.0;
            } else {
              y7 = e8;
            }
            ey = y7;
          }
          t32 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3;
          z4 = fz2 / t32;
          if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            y8 = gy;
          } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            y8 = -gy;
          } else {
            p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t33 = p5 * p5;
            z5 = gy * gy / t33;
            y8 = 0.125 * p5 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
          }
          t34 = 1.0 + z4 * z4;
          t35 = 2.0 * z4 / t34;
          stiff2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          t36 = cy * dy;
          by = stiff2 / t36;
          svy = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          y9 = by * ay;
          t37 = atan(y9);
          t38 = (1.0 - ey) * y9 + ey * t37;
          t39 = atan(t38);
          t40 = cy * t39;
          t41 = sin(t40);
          y20 = dy * t41 + svy;
          y21 = stiff2;
          y22 = muy;
          y23 = by * cy;
          t42 = svy / stiff2;
          y24 = shy + t42;
          muy2 = y22;
          x6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          t43 = 1.0 + x6 * x6;
          t44 = sqrt(t43);
          t45 = 1.0 / t44;
          stiff3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t45 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          e10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_REY2] * dfz;
          if (MAGGI_RE(e10) > 1.0) {
            y10 = 1.0;
          } else {
            y10 = e10;
          }
          e9 = y10;
          s4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_RHY2] * dfz;
          x7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] * a3;
          t46 = 1.0 + x7 * x7;
          t47 = sqrt(t46);
          t48 = 1.0 / t47;
          dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) * t48;
          y11 = stiff3 * (kappa2 + s4);
          y12 = stiff3 * s4;
          t49 = atan(y11);
          t50 = (1.0 - e9) * y11 + e9 * t49;
          t51 = atan(t50);
          p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
          t52 = p6 * t51;
          t53 = cos(t52);
          t54 = atan(y12);
          t55 = (1.0 - e9) * y12 + e9 * t54;
          t56 = atan(t55);
          t57 = p6 * t56;
          t58 = cos(t57);
          g20 = t53 / t58;
          t59 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2;
          t60 = atan(t59);
          t61 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t60;
          t62 = sin(t61);
          g21 = dv * t62 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          x8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2;
          t63 = 1.0 + x8 * x8;
          t64 = sqrt(t63);
          t65 = 1.0 / t64;
          stiff4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t65 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          e12 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_REX2] * dfz;
          if (MAGGI_RE(e12) > 1.0) {
            y13 = 1.0;
          } else {
            y13 = e12;
          }
          e11 = y13;
          p7 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1];
          y14 = stiff4 * (a3 + p7);
          y15 = stiff4 * p7;
          t66 = atan(y14);
          t67 = (1.0 - e11) * y14 + e11 * t66;
          t68 = atan(t67);
          p8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
          t69 = p8 * t68;
          t70 = cos(t69);
          t71 = atan(y15);
          t72 = (1.0 - e11) * y15 + e11 * t71;
          t73 = atan(t72);
          t74 = p8 * t73;
          t75 = cos(t74);
          t76 = t70 / t75;
          fx = x50 * t76;
          fy = g20 * y20 + g21;
          ratio2 = x51 * kappa2 / y21;
          bycy = y23;
          shift = y24;
          fz0_4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
              p[t->tyreadr[t->wheeltyre[n2]]];
          gz = gamma2 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ];
          at = a3 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] * dfz +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QHZ4] * dfz) * gz;
          ar = a3 + shift;
          t77 = at * at + ratio2 * ratio2 + 1e-24;
          ateq = sqrt(t77);
          t78 = ar * ar + ratio2 * ratio2 + 1e-24;
          areq = sqrt(t78);
          if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            y16 = gz;
          } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            y16 = -gz;
          } else {
            p9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t79 = p9 * p9;
            z6 = gz * gz / t79;
            y16 = 0.125 * p9 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
          }
          bt = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUY];
          t80 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
          dt = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t80 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          t81 = bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * at;
          t82 = atan(t81);
          e13 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
              dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t82);
          if (MAGGI_RE(e13) > 1.0) {
            y17 = 1.0;
          } else {
            y17 = e13;
          }
          et = y17;
          p10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          t83 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LKY] / p10;
          br = t83 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycy;
          dr = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] * p10;
          t84 = 1.0 + a3 * a3;
          t85 = sqrt(t84);
          ca = 1.0 / t85;
          y18 = bt * ateq;
          t86 = atan(y18);
          t87 = (1.0 - et) * y18 + et * t86;
          t88 = atan(t87);
          t89 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t88;
          t90 = cos(t89);
          z30 = dt * t90 * ca;
          x9 = br * areq;
          t91 = 1.0 + x9 * x9;
          t92 = sqrt(t91);
          t93 = 1.0 / t92;
          t94 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
          s3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t94 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LS];
          t95 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          way = tanh(t95);
          speed3 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          t96 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
          t97 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
          force5b = rolling5b * side;
          rolling5b = 0.0;
          force4b = rolling4b;
          rolling4b = 0.0;
          force3b = rolling3b * side;
          rolling3b = 0.0;
          force2b = rolling2b;
          rolling2b = 0.0;
          force1b = rolling1b * side;
          rolling1b = 0.0;
          force0b = rolling0b;
          rolling0b = 0.0;
          z30b = -(force5b * (fy - g21));
          tb164 = force5b * z30;
          fyb = -tb164;
          g21b = tb164;
          z31b = force5b;
          s3b = force5b * fx;
          fxb = force5b * s3;
          tb156 = force4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY];
          tb157 = tb156 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t97 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
              speed3);
          tb158 = tb157 * fz2;
          wayb = -(tb158 * r0);
          r0b = -(tb158 * way);
          fz2b = tb157 * (-way * r0);
          tb159 = tb156 * (-way * r0 * fz2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] += tb159;
          t97b = tb159;
          tb160 = tb159 * speed3;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] += tb160 * way;
          wayb += tb160 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3];
          speed3b = tb159 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way);
          tb161 = tb159 * speed3;
          tb162 = tb161 * speed3;
          tb163 = tb162 * speed3;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] += tb163 * speed3;
          speed3b += tb163 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4];
          speed3b += tb162 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3);
          speed3b += tb161 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3);
          speed3b += tb159 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 *
              speed3);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY] += force4b * (-way * r0 * fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t97 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
              speed3));
          tb155 = t97b / fz0_2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] += tb155 * fx;
          fxb += tb155 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2];
          fz0_2b = -(tb155 * t97);
          tb152 = force3b * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX2] * gamma2 + t96) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX]);
          r0b += tb152 * fz2;
          fz2b += tb152 * r0;
          tb153 = force3b * (r0 * fz2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] += tb153 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] += tb153 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1];
          tb154 = tb153 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] -= tb154 * gamma2;
          gamma2b = -(tb154 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2]);
          t96b = tb154;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] += tb153 *
              (-p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2 + t96);
          tb151 = t96b / fz0_2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] += tb151 * fy;
          fyb += tb151 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3];
          fz0_2b -= tb151 * t96;
          fz2b += force2b;
          fyb += force1b;
          fxb += force0b;
          tb150 = speed3b / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          one4b += tb150;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL] -= tb150 * speed3;
          t95b = wayb * (1.0 - way * way);
          tb149 = t95b / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          one4b += tb149;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED] -= tb149 * t95;
          tb146 = s3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS];
          tb147 = tb146 * r0;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] += tb147;
          t94b = tb147;
          tb148 = tb147 * gamma2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] += tb148;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] += tb148 * dfz;
          dfzb = tb148 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4];
          gamma2b += tb147 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz);
          r0b += tb146 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t94 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] += s3b * ((p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_SSZ1] + t94 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0);
          tb145 = t94b / fz0_2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] += tb145 * fy;
          fyb += tb145 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2];
          fz0_2b -= tb145 * t94;
          tb144 = z31b * ca;
          drb = tb144 * t93;
          t93b = tb144 * dr;
          cab = z31b * (dr * t93);
          tb143 = t93b / t92;
          t92b = -(tb143 * t93);
          t91b = t92b * (1.0 / (2.0 * t92));
          x9b = t91b * x9;
          x9b += t91b * x9;
          brb = x9b * areq;
          areqb = x9b * br;
          tb142 = z30b * ca;
          dtb = tb142 * t90;
          t90b = tb142 * dt;
          cab += z30b * (dt * t90);
          t89b = -(t90b * sin(t89));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += t89b * t88;
          t88b = t89b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          t87b = t88b * (1.0 / (1.0 + t87 * t87));
          etb = -(t87b * y18);
          y18b = t87b * (1.0 - et);
          etb += t87b * t86;
          t86b = t87b * et;
          y18b += t86b * (1.0 / (1.0 + y18 * y18));
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          btb = y18b * ateq;
          ateqb = y18b * bt;
          tb141 = cab / t85;
          t85b = -(tb141 * ca);
          t84b = t85b * (1.0 / (2.0 * t85));
          a3b = t84b * a3;
          a3b += t84b * a3;
          tb136 = drb * p10;
          tb137 = tb136 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          fz2b += tb137 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz);
          tb138 = tb137 * fz2;
          tb139 = tb138 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] += tb139;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] += tb139 * dfz;
          dfzb += tb139 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] += tb138 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz);
          tb140 = tb138 * gz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] += tb140;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] += tb140 * dfz;
          dfzb += tb140 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9];
          gzb = tb138 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb136 * (fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gz));
          p10b = drb * (fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS]);
          t83b = brb;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] += brb * bycy;
          bycyb = brb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10];
          tb135 = t83b / p10;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] += tb135 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb135 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9];
          p10b -= tb135 * t83;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += p10b;
          y17b = etb;
          e13b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e13) > 1.0) {
            y17b = 0.0;
          } else {
            e13b += y17b;
            y17b = 0.0;
          }
          tb130 = e13b * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t82);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] += tb130;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] += tb130 * dfz;
          dfzb += tb130 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2];
          tb131 = tb130 * dfz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] += tb131 * dfz;
          dfzb += tb131 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3];
          dfzb += tb130 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz);
          tb132 = e13b * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfz);
          tb133 = tb132 * t82;
          tb134 = tb133 * 0.63661977236758134308;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] += tb134;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] += tb134 * gz;
          gzb += tb134 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5];
          t82b = tb132 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308);
          t81b = t82b * (1.0 / (1.0 + t81 * t81));
          tb129 = t81b * at;
          btb += tb129 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += tb129 * bt;
          atb = t81b * (bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1]);
          tb123 = dtb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          tb124 = tb123 * t80;
          tb125 = tb124 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz);
          fz2b += tb125 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz);
          tb126 = tb125 * fz2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] += tb126;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] += tb126 * dfz;
          dfzb += tb126 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2];
          tb127 = tb124 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] += tb127 * gz;
          gzb += tb127 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3];
          tb128 = tb127 * gz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] += tb128 * gz;
          gzb += tb128 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4];
          gzb += tb127 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz);
          t80b = tb123 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] += dtb * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t80);
          tb122 = t80b / fz0_4;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb122;
          fz0_4b = -(tb122 * t80);
          tb117 = btb / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb118 = tb117 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb119 = tb118 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] += tb119;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] += tb119 * dfz;
          dfzb += tb119 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2];
          tb120 = tb119 * dfz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] += tb120 * dfz;
          dfzb += tb120 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3];
          dfzb += tb119 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz);
          tb121 = tb118 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfz);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] += tb121 * gz;
          gzb += tb121 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] += tb121 * y16;
          y16b = tb121 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb117 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] -= tb117 * bt;
          /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
           * where straight running is, and exact from w on */
          if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            gzb += y16b;
            y16b = 0.0;
          } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            gzb -= y16b;
            y16b = 0.0;
          } else {
            p9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t79 = p9 * p9;
            z6 = gz * gz / t79;
            tb115 = y16b * (15.0 + z6 * (-10.0 + 3.0 * z6));
            p9b = tb115 * z6 * 0.125;
            z6b = tb115 * (0.125 * p9);
            tb116 = y16b * (0.125 * p9 * z6);
            z6b += tb116 * (-10.0 + 3.0 * z6);
            z6b += tb116 * z6 * 3.0;
            y16b = 0.0;
            tb114 = z6b / t79;
            gzb += tb114 * gz;
            gzb += tb114 * gz;
            t79b = -(tb114 * z6);
            p9b += t79b * p9;
            p9b += t79b * p9;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p9b;
          }
          t78b = areqb * (1.0 / (2.0 * areq));
          arb = t78b * ar;
          arb += t78b * ar;
          ratio2b = t78b * ratio2;
          ratio2b += t78b * ratio2;
          t77b = ateqb * (1.0 / (2.0 * ateq));
          atb += t77b * at;
          atb += t77b * at;
          ratio2b += t77b * ratio2;
          ratio2b += t77b * ratio2;
          a3b += arb;
          shiftb = arb;
          a3b += atb;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ1] += atb;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] += atb * dfz;
          dfzb += atb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2];
          tb113 = atb * gz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] += tb113;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] += tb113 * dfz;
          dfzb += tb113 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4];
          gzb += atb * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] * dfz);
          gamma2b += gzb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAZ] += gzb * gamma2;
          /* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
           *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_4b *
              p[t->tyreadr[t->wheeltyre[n2]]];
          pb[t->tyreadr[t->wheeltyre[n2]]] += fz0_4b * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LFZO];
          y24b = shiftb;
          y23b = bycyb;
          tb112 = ratio2b / y21;
          x51b = tb112 * kappa2;
          kappa2b = tb112 * x51;
          y21b = -(tb112 * ratio2);
          g20b = fyb * y20;
          y20b = fyb * g20;
          g21b += fyb;
          x50b = fxb * t76;
          t76b = fxb * x50;
          tb111 = t76b / t75;
          t70b = tb111;
          t75b = -(tb111 * t76);
          t74b = -(t75b * sin(t74));
          p8b = t74b * t73;
          t73b = t74b * p8;
          t72b = t73b * (1.0 / (1.0 + t72 * t72));
          e11b = -(t72b * y15);
          y15b = t72b * (1.0 - e11);
          e11b += t72b * t71;
          t71b = t72b * e11;
          y15b += t71b * (1.0 / (1.0 + y15 * y15));
          t69b = -(t70b * sin(t69));
          p8b += t69b * t68;
          t68b = t69b * p8;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += p8b;
          t67b = t68b * (1.0 / (1.0 + t67 * t67));
          e11b -= t67b * y14;
          y14b = t67b * (1.0 - e11);
          e11b += t67b * t66;
          t66b = t67b * e11;
          y14b += t66b * (1.0 / (1.0 + y14 * y14));
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff4b = y15b * p7;
          p7b = y15b * stiff4;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff4b += y14b * (a3 + p7);
          tb110 = y14b * stiff4;
          a3b += tb110;
          p7b += tb110;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHX1] += p7b;
          y13b = e11b;
          e12b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e12) > 1.0) {
            y13b = 0.0;
          } else {
            e12b += y13b;
            y13b = 0.0;
          }
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX1] += e12b;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2] += e12b * dfz;
          dfzb += e12b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REX2];
          tb109 = stiff4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb109 * t65;
          t65b = tb109 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += stiff4b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t65);
          tb108 = t65b / t64;
          t64b = -(tb108 * t65);
          t63b = t64b * (1.0 / (2.0 * t64));
          x8b = t63b * x8;
          x8b += t63b * x8;
          /* Gxa = Fx / Fx0 */
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x8b * kappa2;
          kappa2b += x8b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
          tb107 = g21b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          dvb = tb107 * t62;
          t62b = tb107 * dv;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g21b * (dv * t62);
          t61b = t62b * cos(t61);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t61b * t60;
          t60b = t61b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
          t59b = t60b * (1.0 / (1.0 + t59 * t59));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t59b * kappa2;
          kappa2b += t59b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
          tb106 = g20b / t58;
          t53b = tb106;
          t58b = -(tb106 * g20);
          t57b = -(t58b * sin(t57));
          p6b = t57b * t56;
          t56b = t57b * p6;
          t55b = t56b * (1.0 / (1.0 + t55 * t55));
          e9b = -(t55b * y12);
          y12b = t55b * (1.0 - e9);
          e9b += t55b * t54;
          t54b = t55b * e9;
          y12b += t54b * (1.0 / (1.0 + y12 * y12));
          t52b = -(t53b * sin(t52));
          p6b += t52b * t51;
          t51b = t52b * p6;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += p6b;
          t50b = t51b * (1.0 / (1.0 + t50 * t50));
          e9b -= t50b * y11;
          y11b = t50b * (1.0 - e9);
          e9b += t50b * t49;
          t49b = t50b * e9;
          y11b += t49b * (1.0 / (1.0 + y11 * y11));
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff3b = y12b * s4;
          s4b = y12b * stiff3;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff3b += y11b * (kappa2 + s4);
          tb105 = y11b * stiff3;
          kappa2b += tb105;
          s4b += tb105;
          tb102 = dvb * t48;
          tb103 = tb102 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2);
          muy2b = tb103 * fz2;
          fz2b += tb103 * muy2;
          tb104 = tb102 * (muy2 * fz2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb104;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb104 * dfz;
          dfzb += tb104 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb104 * gamma2;
          gamma2b += tb104 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
          t48b = dvb * (muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2));
          tb101 = t48b / t47;
          t47b = -(tb101 * t48);
          t46b = t47b * (1.0 / (2.0 * t47));
          x7b = t46b * x7;
          x7b += t46b * x7;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4] += x7b * a3;
          a3b += x7b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY4];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY1] += s4b;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2] += s4b * dfz;
          dfzb += s4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RHY2];
          y10b = e9b;
          e10b = 0.0;
          /* a curvature: more than 1 would turn the curve around */
          if (MAGGI_RE(e10) > 1.0) {
            y10b = 0.0;
          } else {
            e10b += y10b;
            y10b = 0.0;
          }
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY1] += e10b;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2] += e10b * dfz;
          dfzb += e10b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_REY2];
          tb100 = stiff3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb100 * t45;
          t45b = tb100 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += stiff3b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t45);
          tb99 = t45b / t44;
          t44b = -(tb99 * t45);
          t43b = t44b * (1.0 / (2.0 * t44));
          x6b = t43b * x6;
          x6b += t43b * x6;
          /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x6b * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          tb98 = x6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
          a3b += tb98;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb98;
          y22b = muy2b;
          shyb = y24b;
          t42b = y24b;
          tb97 = t42b / stiff2;
          svyb = tb97;
          stiff2b = -(tb97 * t42);
          byb = y23b * cy;
          cyb = y23b * by;
          muyb = y22b;
          stiff2b += y21b;
          dyb = y20b * t41;
          t41b = y20b * dy;
          svyb += y20b;
          t40b = t41b * cos(t40);
          cyb += t40b * t39;
          t39b = t40b * cy;
          t38b = t39b * (1.0 / (1.0 + t38 * t38));
          eyb = -(t38b * y9);
          y9b = t38b * (1.0 - ey);
          eyb += t38b * t37;
          t37b = t38b * ey;
          y9b += t37b * (1.0 / (1.0 + y9 * y9));
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          byb += y9b * ay;
          ayb = y9b * by;
          tb93 = svyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          fz2b += tb93 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy);
          tb94 = tb93 * fz2;
          tb95 = tb94 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb95;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb95 * dfz;
          dfzb += tb95 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb94 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY2] * dfz);
          tb96 = tb94 * gy;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb96;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb96 * dfz;
          dfzb += tb96 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
          gyb = tb94 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += svyb * (fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY4] * dfz) * gy));
          tb92 = byb / t36;
          stiff2b += tb92;
          t36b = -(tb92 * by);
          cyb += t36b * dy;
          dyb += t36b * cy;
          tb88 = stiff2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb89 = tb88 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8);
          tb90 = tb89 * t35;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb90 * fz0_3;
          fz0_3b = tb90 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
          t35b = tb89 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3);
          tb91 = tb88 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb91 * y8;
          y8b = -(tb91 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += stiff2b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t35 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8));
          tb87 = t35b / t34;
          z4b = tb87 * 2.0;
          t34b = -(tb87 * t35);
          z4b += t34b * z4;
          z4b += t34b * z4;
          /* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
           * where straight running is, and exact from w on */
          if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            gyb += y8b;
            y8b = 0.0;
          } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            gyb -= y8b;
            y8b = 0.0;
          } else {
            p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t33 = p5 * p5;
            z5 = gy * gy / t33;
            tb85 = y8b * (15.0 + z5 * (-10.0 + 3.0 * z5));
            p5b = tb85 * z5 * 0.125;
            z5b = tb85 * (0.125 * p5);
            tb86 = y8b * (0.125 * p5 * z5);
            z5b += tb86 * (-10.0 + 3.0 * z5);
            z5b += tb86 * z5 * 3.0;
            y8b = 0.0;
            tb84 = z5b / t33;
            gyb += tb84 * gy;
            gyb += tb84 * gy;
            t33b = -(tb84 * z5);
            p5b += t33b * p5;
            p5b += t33b * p5;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p5b;
          }
          tb83 = z4b / t32;
          fz2b += tb83;
          t32b = -(tb83 * z4);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t32b * fz0_3;
          fz0_3b += t32b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2];
          e6b = 0.0;
          if (MAGGI_RE(ay) > 0.0) {
            e7 = e6 * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            y6b = eyb;
            eyb = 0.0;
            e7b = 0.0;
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e7) > 1.0) {
              y6b = 0.0;
            } else {
              e7b += y6b;
              y6b = 0.0;
            }
            e6b += e7b * (1.0 - (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            tb81 = e7b * e6;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb81;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb81 * gy;
            gyb -= tb81 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
          } else {
            e8 = e6 * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            y7b = eyb;
            eyb = 0.0;
            e8b = 0.0;
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e8) > 1.0) {
              y7b = 0.0;
            } else {
              e8b += y7b;
              y7b = 0.0;
            }
            e6b += e8b * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] +
                p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] * gy));
            tb82 = e8b * e6;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb82;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb82 * gy;
            gyb += tb82 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
          }
          tb80 = e6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb80;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb80 * dfz;
          dfzb += tb80 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] += e6b * (p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz);
          muyb += dyb * fz2;
          fz2b += dyb * muy;
          tb76 = muyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb77 = tb76 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb77;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb77 * dfz;
          dfzb += tb77 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
          tb78 = tb76 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz);
          tb79 = tb78 * gy;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb79 * gy;
          gyb -= tb79 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
          gyb -= tb78 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += muyb *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDY2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] *
              gy * gy));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCY1] += cyb * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_LCY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCY] += cyb * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PCY1];
          a3b += ayb;
          shyb += ayb;
          tb75 = shyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb75;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb75 * dfz;
          dfzb += tb75 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY] += shyb *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PHY2] * dfz);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3] += shyb * gy;
          gyb += shyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY3];
          gamma2b += gyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAY] += gyb * gamma2;
          /* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_3b *
              p[t->tyreadr[t->wheeltyre[n2]]];
          pb[t->tyreadr[t->wheeltyre[n2]]] += fz0_3b * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LFZO];
          stiffb = x51b;
          dxb = x50b * t31;
          t31b = x50b * dx;
          svxb = x50b;
          t30b = t31b * cos(t30);
          cxb = t30b * t29;
          t29b = t30b * cx;
          t28b = t29b * (1.0 / (1.0 + t28 * t28));
          exb = -(t28b * y5);
          y5b = t28b * (1.0 - ex);
          exb += t28b * t27;
          t27b = t28b * ex;
          y5b += t27b * (1.0 / (1.0 + y5 * y5));
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          bxb = y5b * kx;
          kxb = y5b * bx;
          tb72 = svxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb73 = tb72 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
          fz2b += tb73 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz);
          tb74 = tb73 * fz2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb74;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb74 * dfz;
          dfzb += tb74 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb72 * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += svxb * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]);
          tb71 = bxb / t26;
          stiffb += tb71;
          t26b = -(tb71 * bx);
          cxb += t26b * dx;
          dxb += t26b * cx;
          tb68 = stiffb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          tb69 = tb68 * t25;
          fz2b += tb69 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz);
          tb70 = tb69 * fz2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb70;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb70 * dfz;
          dfzb += tb70 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
          t25b = tb68 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += stiffb * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) * t25);
          t24b = t25b * t25;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t24b * dfz;
          dfzb += t24b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3];
          e3b = 0.0;
          if (MAGGI_RE(kx) > 0.0) {
            e4 = e3 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            y3b = exb;
            exb = 0.0;
            e4b = 0.0;
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e4) > 1.0) {
              y3b = 0.0;
            } else {
              e4b += y3b;
              y3b = 0.0;
            }
            e3b += e4b * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4] -= e4b * e3;
          } else {
            e5 = e3 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            y4b = exb;
            exb = 0.0;
            e5b = 0.0;
            /* a curvature: more than 1 would turn the curve around */
            if (MAGGI_RE(e5) > 1.0) {
              y4b = 0.0;
            } else {
              e5b += y4b;
              y4b = 0.0;
            }
            e3b += e5b * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4]);
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX4] += e5b * e3;
          }
          tb66 = e3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb66;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb66 * dfz;
          dfzb += tb66 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2];
          tb67 = tb66 * dfz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb67 * dfz;
          dfzb += tb67 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
          dfzb += tb66 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] += e3b * (p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz * dfz);
          muxb = dxb * fz2;
          fz2b += dxb * mux;
          tb62 = muxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb63 = tb62 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb63;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb63 * dfz;
          dfzb += tb63 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
          tb64 = tb62 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz);
          tb65 = tb64 * gx;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb65 * gx;
          gxb = -(tb65 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
          gxb -= tb64 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += muxb *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PDX2] * dfz) * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] *
              gx * gx));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PCX1] += cxb * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_LCX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LCX] += cxb * p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PCX1];
          gamma2b += gxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LGAX] += gxb * gamma2;
          /* Fx0, Kx */
          kappa2b += kxb;
          tb61 = kxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb61;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb61 * dfz;
          dfzb += tb61 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz);
          tb60 = dfzb / fz0_2;
          fz2b += tb60;
          fz0_2b -= tb60;
          fz0_2b -= tb60 * dfz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += r0b;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0_2b *
              p[t->tyreadr[t->wheeltyre[n2]]];
          pb[t->tyreadr[t->wheeltyre[n2]]] += fz0_2b * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LFZO];
          one3b += fz2b;
          one2b += gamma2b;
          one1b += a3b;
          one0b += kappa2b;
        } else {
          rolling5b = 0.0;
          rolling4b = 0.0;
          rolling3b = 0.0;
          fzb += rolling2b;
          rolling2b = 0.0;
          rolling1b = 0.0;
          rolling0b = 0.0;
        }
        vxb += one4b;
        fzb += one3b;
        gammab += one2b * side;
        a2b += one1b * side;
        kappab += one0b;
      } else {
        rolling5b = 0.0;
        rolling4b = 0.0;
        rolling3b = 0.0;
        rolling2b = 0.0;
        rolling1b = 0.0;
        rolling0b = 0.0;
      }
      z21b += gammab * (z22 / (z22 * z22 + z21 * z21));
      z22b -= gammab * (z21 / (z22 * z22 + z21 * z21));
      tb59 = a2b / speed2;
      v20b += tb59 * L0;
      L0b += tb59 * v20;
      v21b += tb59 * L1;
      L1b += tb59 * v21;
      v22b += tb59 * L2;
      L2b += tb59 * v22;
      speed2b -= tb59 * a2;
      tb58 = kappab / speed2;
      omegab += tb58 * re;
      reb += tb58 * omega;
      vxb -= tb58;
      speed2b -= tb58 * kappa;
      yb += speed2b;
      /* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
      if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW])) {
        vxb += yb;
        yb = 0.0;
      } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW])) {
        vxb -= yb;
        yb = 0.0;
      } else {
        p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW];
        t23 = vx * vx / p4;
        tb57 = yb * 0.5;
        p4b = tb57;
        t23b = tb57;
        yb = 0.0;
        tb56 = t23b / p4;
        vxb += tb56 * vx;
        vxb += tb56 * vx;
        p4b -= tb56 * t23;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW] += p4b;
      }
      p3b += reb;
      t20b -= reb * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t22 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio);
      tb55 = reb * t20;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] -= tb55 * t22;
      t22b -= tb55 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF];
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] -= tb55 * ratio;
      ratiob -= tb55 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF];
      t21b += t22b * (1.0 / (1.0 + t21 * t21));
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] += t21b * ratio;
      ratiob += t21b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF];
      tb54 = t20b / p2;
      fz0b += tb54;
      p2b -= tb54 * t20;
      tb53 = ratiob / fz0;
      fzb += tb53;
      fz0b -= tb53 * ratio;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0b * p[t->tyreadr[t->wheeltyre[n2]]];
      pb[t->tyreadr[t->wheeltyre[n2]]] += fz0b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO];
      p2b += fzb * (p3 - z20);
      tb52 = fzb * p2;
      p3b += tb52;
      z20b -= tb52;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
      rhovb += fzb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING];
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += p3b;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += p2b;
      tb49 = omegab * u20;
      Zb[j][3] += tb49;
      Z_k3b -= tb49;
      u20b += omegab * (Z[j][3] - Z_k3);
      tb50 = omegab * u21;
      Zb[j][4] += tb50;
      Z_k4b -= tb50;
      u21b += omegab * (Z[j][4] - Z_k4);
      tb51 = omegab * u22;
      Zb[j][5] += tb51;
      Z_k5b -= tb51;
      u22b += omegab * (Z[j][5] - Z_k5);
      tb48 = rhovb / z22;
      v20b -= tb48 * N0;
      N0b -= tb48 * v20;
      v21b -= tb48 * N1;
      v22b -= tb48 * N2;
      N2b -= tb48 * v22;
      z22b -= tb48 * rhov;
      v20b += vxb * T0;
      T0b += vxb * v20;
      v21b += vxb * T1;
      T1b += vxb * v21;
      v22b += vxb * T2;
      T2b += vxb * v22;
      rvb[a4_2][2] += v22b;
      vr2b += v22b;
      rvb[a4_2][1] += v21b;
      vr1b += v21b;
      rvb[a4_2][0] += v20b;
      vr0b += v20b;
      wr0b += vr2b * arm1;
      arm1b += vr2b * wr0;
      wr1b -= vr2b * arm0;
      arm0b -= vr2b * wr1;
      wr2b += vr1b * arm0;
      arm0b += vr1b * wr2;
      wr0b -= vr1b * arm2;
      arm2b -= vr1b * wr0;
      wr1b += vr0b * arm2;
      arm2b += vr0b * wr1;
      wr2b -= vr0b * arm1;
      arm1b -= vr0b * wr2;
      Z_k5b += wr2b;
      Zb[k][5] += Z_k5b;
      Z_k4b += wr1b;
      Zb[k][4] += Z_k4b;
      Z_k3b += wr0b;
      Zb[k][3] += Z_k3b;
      wb += z22b;
      cb += z21b;
      r2b += z20b;
      n52b += N2b;
      along2b += T2b;
      tb46 = arm2b / w;
      r2b += tb46 * (c * u22 - n52);
      tb47 = tb46 * r2;
      cb += tb47 * u22;
      u22b += tb47 * c;
      n52b -= tb47;
      wb -= tb46 * arm2;
      along1b += T1b;
      tb44 = arm1b / w;
      r2b += tb44 * (c * u21 - n51);
      tb45 = tb44 * r2;
      cb += tb45 * u21;
      u21b += tb45 * c;
      wb -= tb44 * arm1;
      n50b += N0b;
      along0b += T0b;
      tb42 = arm0b / w;
      r2b += tb42 * (c * u20 - n50);
      tb43 = tb42 * r2;
      cb += tb43 * u20;
      u20b += tb43 * c;
      n50b -= tb43;
      wb -= tb42 * arm0;
      n50b += L2b * along1;
      along1b += L2b * n50;
      along0b -= L2b * n51;
      n52b += L1b * along0;
      along0b += L1b * n52;
      n50b -= L1b * along2;
      along2b -= L1b * n50;
      along2b += L0b * n51;
      n52b -= L0b * along1;
      along1b -= L0b * n52;
      tb41 = along2b / w;
      un2b += tb41;
      wb -= tb41 * along2;
      tb40 = along1b / w;
      un1b += tb40;
      wb -= tb40 * along1;
      tb39 = along0b / w;
      un0b += tb39;
      wb -= tb39 * along0;
      tb36 = r2b / w;
      tb37 = tb36 * n50;
      g0b += tb37;
      x3b -= tb37;
      n50b += tb36 * (g0 - x3);
      tb38 = tb36 * n52;
      g2_2b += tb38;
      h10b -= tb38;
      n52b += tb36 * (g2_2 - h10);
      wb -= tb36 * r2;
      t19b += wb * (1.0 / (2.0 * w));
      un0b += t19b * un0;
      un0b += t19b * un0;
      un1b += t19b * un1;
      un1b += t19b * un1;
      un2b += t19b * un2;
      un2b += t19b * un2;
      u20b += un2b * n51;
      u21b -= un2b * n50;
      n50b -= un2b * u21;
      u22b += un1b * n50;
      n50b += un1b * u22;
      u20b -= un1b * n52;
      n52b -= un1b * u20;
      u21b += un0b * n52;
      n52b += un0b * u21;
      u22b -= un0b * n51;
      u20b += cb * n50;
      n50b += cb * u20;
      u21b += cb * n51;
      u22b += cb * n52;
      n52b += cb * u22;
      tb35 = n52b / s2;
      s2b -= tb35 * n52;
      tb34 = n50b / s2;
      h11b -= tb34;
      s2b -= tb34 * n50;
      t18b += s2b * (1.0 / (2.0 * s2));
      h11b += t18b * h11;
      h11b += t18b * h11;
      /* height of the road above its point at x ahead of it, and its slope */
      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
        p_b2_4 = p[t->roadadr[b2_2]];
        p_b2_4b = h11b;
        h11b = 0.0;
        p_b2_4b += h10b * x3;
        x3b += h10b * p_b2_4;
        h10b = 0.0;
        pb[t->roadadr[b2_2]] += p_b2_4b;
      } else {
        p_b2_5 = p[t->roadadr[b2_2] + 1];
        t13 = 6.28318530717958647693 * x3 / p_b2_5;
        t14 = sin(t13);
        p_b2_6 = p[t->roadadr[b2_2]];
        t15 = p_b2_6 * 6.28318530717958647693 / p_b2_5;
        t16 = 6.28318530717958647693 * x3 / p_b2_5;
        t17 = cos(t16);
        t15b = h11b * t17;
        t17b = h11b * t15;
        h11b = 0.0;
        t16b = -(t17b * sin(t16));
        tb33 = t16b / p_b2_5;
        x3b += tb33 * 6.28318530717958647693;
        p_b2_5b = -(tb33 * t16);
        tb32 = t15b / p_b2_5;
        p_b2_6b = tb32 * 6.28318530717958647693;
        p_b2_5b -= tb32 * t15;
        p_b2_6b += h10b * t14;
        t14b = h10b * p_b2_6;
        h10b = 0.0;
        pb[t->roadadr[b2_2]] += p_b2_6b;
        t13b = t14b * cos(t13);
        tb31 = t13b / p_b2_5;
        x3b += tb31 * 6.28318530717958647693;
        p_b2_5b -= tb31 * t13;
        pb[t->roadadr[b2_2] + 1] += p_b2_5b;
      }
      g0b += x3b;
      t12b += x3b * (g2_2 - h00);
      tb30 = x3b * t12;
      g2_2b += tb30;
      h00b -= tb30;
      tb29 = t12b / t11;
      u22b += tb29 * u20;
      u20b += tb29 * u22;
      t11b -= tb29 * t12;
      u20b += t11b * u20;
      u20b += t11b * u20;
      u21b += t11b * u21;
      u21b += t11b * u21;
      /* height of the road above its point at x ahead of it, and its slope */
      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
        p_b2 = p[t->roadadr[b2_2]];
        p_b2b = h00b * x4;
        x4b += h00b * p_b2;
        h00b = 0.0;
        pb[t->roadadr[b2_2]] += p_b2b;
      } else {
        p_b2_2 = p[t->roadadr[b2_2] + 1];
        t9 = 6.28318530717958647693 * x4 / p_b2_2;
        t10 = sin(t9);
        p_b2_3 = p[t->roadadr[b2_2]];
        p_b2_3b = h00b * t10;
        t10b = h00b * p_b2_3;
        h00b = 0.0;
        pb[t->roadadr[b2_2]] += p_b2_3b;
        t9b = t10b * cos(t9);
        tb28 = t9b / p_b2_2;
        x4b += tb28 * 6.28318530717958647693;
        p_b2_2b = -(tb28 * t9);
        pb[t->roadadr[b2_2] + 1] += p_b2_2b;
      }
      /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
       * the centre down the disc meets it, n its normal; then down the disc to that plane,
       *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
       * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
      g0b += x4b;
      rb[a4_2][2] += g2_2b;
      rb[t->roadpoint[b2_2]][2] -= g2_2b;
      rb[a4_2][0] += g0b;
      rb[t->roadpoint[b2_2]][0] -= g0b;
      tb27 = u22b / n4;
      ua2b += tb27;
      n4b -= tb27 * u22;
      tb26 = u21b / n4;
      ua1b += tb26;
      n4b -= tb26 * u21;
      tb25 = u20b / n4;
      ua0b += tb25;
      n4b -= tb25 * u20;
      t8b += n4b * (1.0 / (2.0 * n4));
      ua0b += t8b * ua0;
      ua0b += t8b * ua0;
      ua1b += t8b * ua1;
      ua1b += t8b * ua1;
      ua2b += t8b * ua2;
      ua2b += t8b * ua2;
      Ab[j][6] += ua2b * a00;
      a00b += ua2b * A[j][6];
      Ab[j][7] += ua2b * a01;
      a01b += ua2b * A[j][7];
      Ab[j][8] += ua2b * a02;
      a02b += ua2b * A[j][8];
      Ab[j][3] += ua1b * a00;
      a00b += ua1b * A[j][3];
      Ab[j][4] += ua1b * a01;
      a01b += ua1b * A[j][4];
      Ab[j][5] += ua1b * a02;
      a02b += ua1b * A[j][5];
      Ab[j][0] += ua0b * a00;
      a00b += ua0b * A[j][0];
      Ab[j][1] += ua0b * a01;
      a01b += ua0b * A[j][1];
      Ab[j][2] += ua0b * a02;
      a02b += ua0b * A[j][2];
      pb[t->wheelaxis[n2] + 2] += a02b;
      pb[t->wheelaxis[n2] + 1] += a01b;
      pb[t->wheelaxis[n2]] += a00b;
    }
  }
}
