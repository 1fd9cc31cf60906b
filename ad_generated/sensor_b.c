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
  int a, a4, a4_2, a4_3, b, b2, b2_2, i, j, k, k3, n2;
  double A_j0, A_j0_2, A_j0_2b, A_j0_3, A_j0_3b, A_j0_4, A_j0_4b, A_j0b, A_j3, A_j3_2, A_j3_2b,
      A_j3_3, A_j3_3b, A_j3_4, A_j3_4b, A_j3b, A_j7, A_j7b, A_j8, A_j8b, L0, L0b, L1, L1b, L2, L2b,
      N0, N0b, N1, N2, N2b, T0, T0b, T1, T1b, T2, T2b, Z_j3, Z_j3b, Z_j4, Z_j4b, Z_k3, Z_k3b, Z_k4,
      Z_k4b, Z_k5, Z_k5b, a00, a00b, a01, a01b, a02, a02b, a2, a2b, a3, a3b, along0, along0b,
      along1, along1b, along2, along2b, ar, arb, areq, areqb, arm0, arm0b, arm1, arm1b, arm2, arm2b,
      at, atb, ateq, ateqb, ay, ayb, br, brb, bt, btb, bx, bxb, by, byb, bycy, bycyb, c, c2, c2b,
      c3, c3b, ca, cab, cb, cx, cxb, cy, cyb, d, dampingb, db, dfz, dfzb, dr, drb, dt, dtb, dv, dvb,
      dx, dxb, dy, dyb, e0, e0b, e1, e10, e10b, e11, e11b, e12, e12b, e13, e13b, e1b, e20, e20b,
      e21, e21b, e22, e22b, e2_2, e2_2b, e3, e3b, e4, e4b, e5, e5b, e6, e6b, e7, e7b, e8, e8b, e9,
      e9b, et, etb, ev0, ev0b, ev1, ev1b, ev20, ev20b, ev21, ev21b, ev22, ev22b, ev2_2, ev2_2b, ex,
      exb, ey, eyb, f0b, f1b, f2b, force0b, force1b, force2b, force3b, force4b, force5b, fx, fxb,
      fy, fyb, fz, fz0, fz0_2, fz0_2b, fz0_3, fz0_3b, fz0_4, fz0_4b, fz0b, fz2, fz2b, fzb, g0, g0_2,
      g0_2b, g0_3, g0_3b, g0_4, g0_4b, g0b, g1, g1_2, g1_2b, g1_3, g1_3b, g1_4, g1_4b, g1b, g20,
      g20b, g22, g22b, g2_2, g2_2b, g2_4b, g2_5, g2_5b, g30, g30b, g31, g31b, gamma, gamma2,
      gamma2b, gammab, gx, gxb, gy, gyb, gz, gzb, h, h00, h00b, h10, h10b, h11, h11b, h2, h2b, h3,
      h3b, hb, kappa, kappa2, kappa2b, kappab, kx, kxb, l, l2, l2b, lb, lv, lvb, mux, muxb, muy,
      muy2, muy2b, muyb, n30, n30b, n31, n31b, n32, n32b, n40, n40b, n41, n41b, n42, n42b, n5, n5b,
      n60, n60b, n61, n62, n62b, omega, omegab, one0, one0b, one1, one1b, one2, one2b, one3, one3b,
      one4, one4b, p10, p10b, p2, p2b, p3, p3b, p4, p4b, p5, p5b, p6, p6b, p7, p7b, p8, p8b, p9,
      p9b, p_b2, p_b2_2, p_b2_2b, p_b2_3, p_b2_3b, p_b2_4, p_b2_4b, p_b2_5, p_b2_5b, p_b2_6,
      p_b2_6b, p_b2b, p_i, p_i1, p_i1b, p_i2, p_i2b, p_i3, p_i3b, p_ib, p_k34, p_k34b, p_k35,
      p_k35b, r0, r0b, r2, r2b, r3, r3b, ratio, ratio2, ratio2b, ratiob, re, reb, rhov, rhovb, roll,
      rollb, rolling0b, rolling1b, rolling2b, rolling3b, rolling4b, rolling5b, rv_k0, rv_k0_2,
      rv_k0_2b, rv_k0_3, rv_k0_3b, rv_k0b, rv_k1, rv_k1_2, rv_k1_2b, rv_k1_3, rv_k1_3b, rv_k1b,
      rv_k2, rv_k2b, s2, s2b, s3, s3b, s4, s4b, shift, shiftb, shy, shyb, side, slip0b, slip1,
      slip1b, slip2b, speed2, speed2b, speed3, speed3b, stiff, stiff2, stiff2b, stiff3, stiff3b,
      stiff4, stiff4b, stiffb, sumb, svx, svxb, svy, svyb, t10, t100, t100b, t101, t101b, t102,
      t102b, t103, t103b, t104, t104b, t105, t105b, t106, t106b, t107, t107b, t108, t108b, t109,
      t109b, t10b, t11, t110, t110b, t111, t111b, t112, t112b, t11b, t12, t12b, t13b, t14, t14b,
      t15, t15b, t16, t16b, t17, t17b, t18, t18b, t19, t19b, t2, t20, t20b, t21, t21b, t22, t22b,
      t23, t23b, t24, t24b, t25, t25b, t26, t26b, t27, t27b, t28, t28b, t29, t29b, t2b, t3, t30,
      t30b, t31, t31b, t32, t32b, t33, t33b, t34, t34b, t35, t35b, t36, t36b, t37, t37b, t38, t38b,
      t39, t39b, t3b, t4, t40, t40b, t41, t41b, t42, t42b, t43, t43b, t44, t44b, t45, t45b, t46,
      t46b, t47, t47b, t48, t48b, t49, t49b, t4b, t5, t50, t50b, t51, t51b, t52, t52b, t53, t53b,
      t54, t54b, t55, t55b, t56, t56b, t57, t57b, t58, t58b, t59, t59b, t5b, t6, t60, t60b, t61,
      t61b, t62, t62b, t63, t63b, t64, t64b, t65, t65b, t66, t66b, t67, t67b, t68, t68b, t69, t69b,
      t6b, t7, t70, t70b, t71, t71b, t72, t72b, t73, t73b, t74, t74b, t75, t75b, t76, t76b, t77,
      t77b, t78, t78b, t79, t79b, t7b, t8, t80, t80b, t81, t81b, t82, t82b, t83, t83b, t84, t84b,
      t85, t85b, t86, t86b, t87, t87b, t88, t88b, t89, t89b, t8b, t9, t90, t90b, t91, t91b, t92,
      t92b, t93, t93b, t94, t94b, t95, t95b, t96, t96b, t97, t97b, t98, t98b, t99, t99b, t9b, tb10,
      tb100, tb101, tb102, tb103, tb104, tb105, tb106, tb107, tb108, tb109, tb11, tb110, tb111,
      tb112, tb113, tb114, tb115, tb116, tb117, tb118, tb119, tb12, tb120, tb121, tb122, tb123,
      tb124, tb125, tb126, tb127, tb128, tb129, tb13, tb130, tb131, tb132, tb133, tb134, tb135,
      tb136, tb137, tb138, tb139, tb14, tb140, tb141, tb142, tb143, tb144, tb145, tb146, tb147,
      tb148, tb149, tb15, tb150, tb151, tb152, tb153, tb154, tb155, tb156, tb157, tb158, tb159,
      tb16, tb160, tb161, tb162, tb163, tb164, tb165, tb166, tb167, tb168, tb169, tb17, tb170,
      tb171, tb172, tb173, tb174, tb175, tb176, tb177, tb178, tb179, tb18, tb180, tb181, tb182,
      tb183, tb184, tb185, tb186, tb187, tb188, tb189, tb19, tb190, tb191, tb2, tb20, tb21, tb22,
      tb23, tb24, tb25, tb26, tb27, tb28, tb29, tb3, tb30, tb31, tb32, tb33, tb34, tb35, tb36, tb37,
      tb38, tb39, tb4, tb40, tb41, tb42, tb43, tb44, tb45, tb46, tb47, tb48, tb49, tb5, tb50, tb51,
      tb52, tb53, tb54, tb55, tb56, tb57, tb58, tb59, tb6, tb60, tb61, tb62, tb63, tb64, tb65, tb66,
      tb67, tb68, tb69, tb7, tb70, tb71, tb72, tb73, tb74, tb75, tb76, tb77, tb78, tb79, tb8, tb80,
      tb81, tb82, tb83, tb84, tb85, tb86, tb87, tb88, tb89, tb9, tb90, tb91, tb92, tb93, tb94, tb95,
      tb96, tb97, tb98, tb99, torque0b, u20, u20b, u21, u21b, u30, u30b, u31, u31b, u32, u32b, ua0,
      ua0b, ua1, ua1b, ua2, ua2b, un0, un0b, un1, un1b, un2, un2b, v20, v20b, v21, v21b, v22, v22b,
      vr0, vr0b, vr1, vr1b, vr2, vr2b, vx, vxb, w, w2, w2b, way, wayb, wb, wr0, wr0b, wr1, wr1b,
      wr2, wr2b, x2, x2b, x3, x3b, x4, x4b, x50, x50b, x51, x51b, x6, x6b, x7, x7b, x8, x8b, x9,
      x9b, xv, xvb, y, y10, y10b, y11, y11b, y12, y12b, y13, y13b, y14, y14b, y15, y15b, y16, y16b,
      y17, y17b, y18, y18b, y20, y20b, y21, y21b, y22, y22b, y23, y23b, y24, y24b, y3, y3b, y4, y4b,
      y5, y5b, y6, y6b, y7, y7b, y8, y8b, y9, y9b, yb, z0_2b, z0_3b, z0b, z1_2b, z1_3, z1_3b, z1b,
      z20, z20b, z21, z21b, z22, z22b, z30, z30b, z31b, z4, z4b, z5, z5b, z6, z6b;

  (void)origin;
  (void)x;
  (void)Za;
  (void)driver;
  (void)speed;
  (void)lambda;
  A_j0 = 0.0;
  A_j0_2 = 0.0;
  A_j0_3 = 0.0;
  A_j0_4 = 0.0;
  A_j3 = 0.0;
  A_j3_2 = 0.0;
  A_j3_3 = 0.0;
  A_j3_4 = 0.0;
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
  c3 = 0.0;
  d = 0.0;
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
  g0_2 = 0.0;
  g0_3 = 0.0;
  g0_4 = 0.0;
  g1 = 0.0;
  g1_2 = 0.0;
  g1_3 = 0.0;
  g1_4 = 0.0;
  g20 = 0.0;
  g22 = 0.0;
  g2_2 = 0.0;
  g2_5 = 0.0;
  gamma = 0.0;
  h = 0.0;
  h00 = 0.0;
  h10 = 0.0;
  h11 = 0.0;
  h2 = 0.0;
  h3 = 0.0;
  kappa = 0.0;
  l = 0.0;
  l2 = 0.0;
  lv = 0.0;
  n30 = 0.0;
  n31 = 0.0;
  n32 = 0.0;
  n40 = 0.0;
  n41 = 0.0;
  n42 = 0.0;
  n5 = 0.0;
  n60 = 0.0;
  n61 = 0.0;
  n62 = 0.0;
  omega = 0.0;
  p2 = 0.0;
  p3 = 0.0;
  p_i = 0.0;
  p_i1 = 0.0;
  p_i2 = 0.0;
  r2 = 0.0;
  r3 = 0.0;
  ratio = 0.0;
  re = 0.0;
  rhov = 0.0;
  roll = 0.0;
  rv_k0 = 0.0;
  rv_k0_2 = 0.0;
  rv_k0_3 = 0.0;
  rv_k1 = 0.0;
  rv_k1_2 = 0.0;
  rv_k1_3 = 0.0;
  rv_k2 = 0.0;
  s2 = 0.0;
  side = 0.0;
  slip1 = 0.0;
  speed2 = 0.0;
  t14 = 0.0;
  t17 = 0.0;
  t19 = 0.0;
  t2 = 0.0;
  t20 = 0.0;
  t26 = 0.0;
  t27 = 0.0;
  t35 = 0.0;
  t36 = 0.0;
  t37 = 0.0;
  t4 = 0.0;
  t6 = 0.0;
  t8 = 0.0;
  u20 = 0.0;
  u21 = 0.0;
  u30 = 0.0;
  u31 = 0.0;
  u32 = 0.0;
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
  w2 = 0.0;
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
  a4 = 0;
  a4_2 = 0;
  a4_3 = 0;
  b = 0;
  b2 = 0;
  b2_2 = 0;
  k3 = 0;
  for (i = t->nsensor - 1; i >= 0; --i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n2 = t->sensorelement[i];
    if (t->sensorkind[i] != MAGGI_SENSOR_POSITION) {
      if (t->sensorkind[i] != MAGGI_SENSOR_VELOCITY) {
        if (t->sensorkind[i] != MAGGI_SENSOR_ACCELERATION) {
          if (t->sensorkind[i] == MAGGI_SENSOR_LATERAL_ACCELERATION) {
            g0 = ra[k][0] + p[0];
            g1 = ra[k][1] + p[1];
            g2_2 = ra[k][2] + p[2];
            p_i = p[t->sensoradr[i]];
            w = p_i * p_i;
            rv_k0 = rv[k][0];
            rv_k1 = rv[k][1];
            rv_k2 = rv[k][2];
            t2 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + rv_k2 * rv_k2 + w;
            c = (g0 * rv_k0 + g1 * rv_k1 + g2_2 * rv_k2) / t2;
            n30 = g0 - c * rv_k0;
            n31 = g1 - c * rv_k1;
            n32 = g2_2 - c * rv_k2;
            p_i1 = p[t->sensoradr[i] + 1];
            t3 = n30 * n30 + n31 * n31 + n32 * n32 + p_i1 * p_i1;
            t4 = sqrt(t3);
            t5 = rv_k0 * rv_k0 + rv_k1 * rv_k1 + w;
            t6 = sqrt(t5);
            t7 = g0 * g0 + g1 * g1 + p_i1 * p_i1;
            t8 = sqrt(t7);
          } else if (t->sensorkind[i] == MAGGI_SENSOR_SIDESLIP) {
            g0_2 = ra[k][0] + p[0];
            g1_2 = ra[k][1] + p[1];
            A_j0 = A[j][0];
            A_j3 = A[j][3];
            t9 = A_j0 * A_j0 + A_j3 * A_j3;
            h = sqrt(t9);
            rv_k0_2 = rv[k][0];
            rv_k1_2 = rv[k][1];
            u20 = (A_j0 * rv_k0_2 + A_j3 * rv_k1_2) / h;
            u21 = (A_j0 * rv_k1_2 - A_j3 * rv_k0_2) / h;
            p_i2 = p[t->sensoradr[i]];
            t10 = u20 * u20 + u21 * u21 + p_i2 * p_i2;
            r2 = sqrt(t10);
            if (MAGGI_RE(u20) < 0.0) {
              t11 = r2 - u20;
              p_i3 = p[t->sensoradr[i]];
              t12 = (u21 * u21 + p_i3 * p_i3) / t11;
              d = t12;
            } else {
              d = r2 + u20;
            }
            t14 = r2 * r2 * r2;
          } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_VELOCITY) {
            A_j0_2 = A[j][0];
            A_j3_2 = A[j][3];
            t15 = A_j0_2 * A_j0_2 + A_j3_2 * A_j3_2;
            h2 = sqrt(t15);
            rv_k0_3 = rv[k][0];
            rv_k1_3 = rv[k][1];
          } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_ACCELERATION) {
            g0_3 = ra[k][0] + p[0];
            g1_3 = ra[k][1] + p[1];
            A_j0_3 = A[j][0];
            A_j3_3 = A[j][3];
            t16 = A_j0_3 * A_j0_3 + A_j3_3 * A_j3_3;
            h3 = sqrt(t16);
          } else if (t->sensorkind[i] == MAGGI_SENSOR_BODY_ACCELERATION) {
            g0_4 = ra[k][0] + p[0];
            g1_4 = ra[k][1] + p[1];
            g2_5 = ra[k][2] + p[2];
          } else {
            if (t->sensorkind[i] != MAGGI_SENSOR_COMBINATION) {
              if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
                A_j7 = A[j][7];
                A_j8 = A[j][8];
                t17 = -A[j][6];
                t18 = A_j7 * A_j7 + A_j8 * A_j8;
                t19 = sqrt(t18);
              } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
                A_j0_4 = A[j][0];
                A_j3_4 = A[j][3];
                c2 = A_j0_4 * A_j0_4 + A_j3_4 * A_j3_4;
                Z_j3 = Z[j][3];
                Z_j4 = Z[j][4];
                roll = s[i][0];
                t20 = sqrt(c2);
              } else {
                if (t->sensorkind[i] != MAGGI_SENSOR_ANGULAR_VELOCITY) {
                  if (t->sensorkind[i] != MAGGI_SENSOR_ANGULAR_ACCELERATION) {
                    if (t->sensorkind[i] == MAGGI_SENSOR_SPRING) {
                      a4 = t->springpa[n2];
                      b = t->springpb[n2];
                      e0 = r[a4][0] - r[b][0];
                      ev0 = rv[a4][0] - rv[b][0];
                      e1 = r[a4][1] - r[b][1];
                      ev1 = rv[a4][1] - rv[b][1];
                      e2_2 = r[a4][2] - r[b][2];
                      ev2_2 = rv[a4][2] - rv[b][2];
                      t21 = e0 * e0 + e1 * e1 + e2_2 * e2_2;
                      l = sqrt(t21);
                      n40 = e0 / l;
                      n41 = e1 / l;
                      n42 = e2_2 / l;
                      lv = n40 * ev0 + n41 * ev1 + n42 * ev2_2;
                      k3 = t->springadr[n2] + MAGGI_SPRING_SLOPES;
                    } else if (t->sensorkind[i] == MAGGI_SENSOR_JOINT_SPRING) {
                      if (t->jspringq2[n2] >= 0) {
                        x2 = q[t->jspringq[n2]] - q[t->jspringq2[n2]];
                        xv = v[t->jspringq[n2]] - v[t->jspringq2[n2]];
                      } else {
                        x2 = q[t->jspringq[n2]];
                        xv = v[t->jspringq[n2]];
                      }
                    } else if (t->sensorkind[i] == MAGGI_SENSOR_ROD) {
                      a4_2 = t->primpa[n2];
                      b2 = t->primpb[n2];
                      e20 = r[a4_2][0] - r[b2][0];
                      ev20 = rv[a4_2][0] - rv[b2][0];
                      e21 = r[a4_2][1] - r[b2][1];
                      ev21 = rv[a4_2][1] - rv[b2][1];
                      e22 = r[a4_2][2] - r[b2][2];
                      ev22 = rv[a4_2][2] - rv[b2][2];
                      t22 = e20 * e20 + e21 * e21 + e22 * e22;
                      l2 = sqrt(t22);
                      z1_3 = s[i][1];
                    } else {
                      if (t->sensorkind[i] != MAGGI_SENSOR_SPEED) {
                        if (t->sensorkind[i] != MAGGI_SENSOR_DRIVER) {
                          a4_3 = t->wheelpoint[n2];
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
                          t23 = ua0 * ua0 + ua1 * ua1 + ua2 * ua2;
                          n5 = sqrt(t23);
                          u30 = ua0 / n5;
                          u31 = ua1 / n5;
                          u32 = ua2 / n5;
                          g20 = r[a4_3][0] - r[t->roadpoint[b2_2]][0];
                          g22 = r[a4_3][2] - r[t->roadpoint[b2_2]][2];
                          x4 = g20;
                          if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
                            p_b2 = p[t->roadadr[b2_2]];
                            h00 = p_b2 * x4;
                          } else {
                            p_b2_2 = p[t->roadadr[b2_2] + 1];
                            t24 = 6.28318530717958647693 * x4 / p_b2_2;
                            t25 = sin(t24);
                            p_b2_3 = p[t->roadadr[b2_2]];
                            h00 = p_b2_3 * t25;
                          }
                          t26 = u30 * u30 + u31 * u31;
                          t27 = u32 * u30 / t26;
                          x3 = g20 + t27 * (g22 - h00);
                          if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
                            p_b2_4 = p[t->roadadr[b2_2]];
                            h10 = p_b2_4 * x3;
                            h11 = p_b2_4;
                          } else {
                            p_b2_5 = p[t->roadadr[b2_2] + 1];
                            t28 = 6.28318530717958647693 * x3 / p_b2_5;
                            t29 = sin(t28);
                            p_b2_6 = p[t->roadadr[b2_2]];
                            h10 = p_b2_6 * t29;
                            t30 = p_b2_6 * 6.28318530717958647693 / p_b2_5;
                            t31 = 6.28318530717958647693 * x3 / p_b2_5;
                            t32 = cos(t31);
                            h11 = t30 * t32;
                          }
                          t33 = 1.0 + h11 * h11;
                          s2 = sqrt(t33);
                          n60 = -h11 / s2;
                          n61 = 0.0;
                          n62 = 1.0 / s2;
                          c3 = u30 * n60 + u31 * n61 + u32 * n62;
                          un0 = u31 * n62 - u32 * n61;
                          un1 = u32 * n60 - u30 * n62;
                          un2 = u30 * n61 - u31 * n60;
                          t34 = un0 * un0 + un1 * un1 + un2 * un2;
                          w2 = sqrt(t34);
                          r3 = ((g20 - x3) * n60 + (g22 - h10) * n62) / w2;
                          along0 = un0 / w2;
                          along1 = un1 / w2;
                          along2 = un2 / w2;
                          L0 = n61 * along2 - n62 * along1;
                          L1 = n62 * along0 - n60 * along2;
                          L2 = n60 * along1 - n61 * along0;
                          arm0 = r3 * (c3 * u30 - n60) / w2;
                          T0 = along0;
                          N0 = n60;
                          arm1 = r3 * (c3 * u31 - n61) / w2;
                          T1 = along1;
                          N1 = n61;
                          arm2 = r3 * (c3 * u32 - n62) / w2;
                          T2 = along2;
                          N2 = n62;
                          z20 = r3;
                          z21 = c3;
                          z22 = w2;
                          Z_k3 = Z[k][3];
                          wr0 = Z_k3;
                          Z_k4 = Z[k][4];
                          wr1 = Z_k4;
                          Z_k5 = Z[k][5];
                          wr2 = Z_k5;
                          vr0 = wr1 * arm2 - wr2 * arm1;
                          vr1 = wr2 * arm0 - wr0 * arm2;
                          vr2 = wr0 * arm1 - wr1 * arm0;
                          v20 = rv[a4_3][0] + vr0;
                          v21 = rv[a4_3][1] + vr1;
                          v22 = rv[a4_3][2] + vr2;
                          vx = v20 * T0 + v21 * T1 + v22 * T2;
                          rhov = -(v20 * N0 + v21 * N1 + v22 * N2) / z22;
                          omega = (Z[j][3] - Z_k3) * u30 + (Z[j][4] - Z_k4) * u31 + (Z[j][5] - Z_k5)
                              * u32;
                          p2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS];
                          p3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
                          fz = p2 * (p3 - z20) + p[t->tyreadr[t->wheeltyre[n2]] +
                              MAGGI_TYRE_VERTICAL_DAMPING] * rhov;
                          fz0 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] *
                              p[t->tyreadr[t->wheeltyre[n2]]];
                          ratio = fz / fz0;
                          t35 = fz0 / p2;
                          t36 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] * ratio;
                          t37 = atan(t36);
                          re = p3 - t35 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37
                              + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio);
                          if (MAGGI_RE(vx) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
                              MAGGI_TYRE_VXLOW])) {
                            y = vx;
                          } else if (MAGGI_RE(vx) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
                              MAGGI_TYRE_VXLOW])) {
                            y = -vx;
                          } else {
                            p4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW];
                            t38 = vx * vx / p4;
                            y = 0.5 * (p4 + t38);
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
      }
    }
    A_j0_2b = 0.0;
    A_j0_3b = 0.0;
    A_j0_4b = 0.0;
    A_j0b = 0.0;
    A_j3_2b = 0.0;
    A_j3_3b = 0.0;
    A_j3_4b = 0.0;
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
    c3b = 0.0;
    cb = 0.0;
    dampingb = 0.0;
    db = 0.0;
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
    g0_2b = 0.0;
    g0_3b = 0.0;
    g0_4b = 0.0;
    g0b = 0.0;
    g1_2b = 0.0;
    g1_3b = 0.0;
    g1_4b = 0.0;
    g1b = 0.0;
    g20b = 0.0;
    g22b = 0.0;
    g2_2b = 0.0;
    g2_4b = 0.0;
    g2_5b = 0.0;
    gammab = 0.0;
    h00b = 0.0;
    h10b = 0.0;
    h11b = 0.0;
    h2b = 0.0;
    h3b = 0.0;
    hb = 0.0;
    kappab = 0.0;
    l2b = 0.0;
    lb = 0.0;
    lvb = 0.0;
    n30b = 0.0;
    n31b = 0.0;
    n32b = 0.0;
    n40b = 0.0;
    n41b = 0.0;
    n42b = 0.0;
    n5b = 0.0;
    n60b = 0.0;
    n62b = 0.0;
    omegab = 0.0;
    p2b = 0.0;
    p3b = 0.0;
    p_i1b = 0.0;
    p_i2b = 0.0;
    p_ib = 0.0;
    r2b = 0.0;
    r3b = 0.0;
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
    rv_k0_2b = 0.0;
    rv_k0_3b = 0.0;
    rv_k0b = 0.0;
    rv_k1_2b = 0.0;
    rv_k1_3b = 0.0;
    rv_k1b = 0.0;
    rv_k2b = 0.0;
    s2b = 0.0;
    slip0b = 0.0;
    slip1b = 0.0;
    slip2b = 0.0;
    speed2b = 0.0;
    sumb = 0.0;
    t10b = 0.0;
    t13b = 0.0;
    t14b = 0.0;
    t15b = 0.0;
    t16b = 0.0;
    t17b = 0.0;
    t18b = 0.0;
    t19b = 0.0;
    t20b = 0.0;
    t21b = 0.0;
    t22b = 0.0;
    t23b = 0.0;
    t26b = 0.0;
    t27b = 0.0;
    t2b = 0.0;
    t33b = 0.0;
    t34b = 0.0;
    t35b = 0.0;
    t36b = 0.0;
    t37b = 0.0;
    t3b = 0.0;
    t4b = 0.0;
    t5b = 0.0;
    t6b = 0.0;
    t7b = 0.0;
    t8b = 0.0;
    t9b = 0.0;
    torque0b = 0.0;
    u20b = 0.0;
    u21b = 0.0;
    u30b = 0.0;
    u31b = 0.0;
    u32b = 0.0;
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
    w2b = 0.0;
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
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LATERAL_ACCELERATION) {
      tb13 = sb[i][2];
      sb[i][2] = 0.0;
      tb14 = tb13 / t8;
      g0b += tb14 * g0;
      g0b += tb14 * g0;
      g1b += tb14 * g1;
      g1b += tb14 * g1;
      t8b -= tb14 * s[i][2];
      t7b += t8b * (1.0 / (2.0 * t8));
      g0b += t7b * g0;
      g0b += t7b * g0;
      g1b += t7b * g1;
      g1b += t7b * g1;
      p_i1b += t7b * p_i1;
      p_i1b += t7b * p_i1;
      tb11 = sb[i][1];
      sb[i][1] = 0.0;
      tb12 = tb11 / t6;
      rv_k0b += tb12 * g1;
      g1b += tb12 * rv_k0;
      rv_k1b -= tb12 * g0;
      g0b -= tb12 * rv_k1;
      t6b -= tb12 * s[i][1];
      t5b += t6b * (1.0 / (2.0 * t6));
      rv_k0b += t5b * rv_k0;
      rv_k0b += t5b * rv_k0;
      rv_k1b += t5b * rv_k1;
      rv_k1b += t5b * rv_k1;
      wb += t5b;
      tb9 = sb[i][0];
      sb[i][0] = 0.0;
      tb10 = tb9 / t4;
      n30b += tb10 * n30;
      n30b += tb10 * n30;
      n31b += tb10 * n31;
      n31b += tb10 * n31;
      n32b += tb10 * n32;
      n32b += tb10 * n32;
      t4b -= tb10 * s[i][0];
      t3b += t4b * (1.0 / (2.0 * t4));
      n30b += t3b * n30;
      n30b += t3b * n30;
      n31b += t3b * n31;
      n31b += t3b * n31;
      n32b += t3b * n32;
      n32b += t3b * n32;
      p_i1b += t3b * p_i1;
      p_i1b += t3b * p_i1;
      pb[t->sensoradr[i] + 1] += p_i1b;
      g2_2b += n32b;
      cb -= n32b * rv_k2;
      rv_k2b -= n32b * c;
      g1b += n31b;
      cb -= n31b * rv_k1;
      rv_k1b -= n31b * c;
      g0b += n30b;
      cb -= n30b * rv_k0;
      rv_k0b -= n30b * c;
      tb8 = cb / t2;
      g0b += tb8 * rv_k0;
      rv_k0b += tb8 * g0;
      g1b += tb8 * rv_k1;
      rv_k1b += tb8 * g1;
      g2_2b += tb8 * rv_k2;
      rv_k2b += tb8 * g2_2;
      t2b -= tb8 * c;
      rv_k0b += t2b * rv_k0;
      rv_k0b += t2b * rv_k0;
      rv_k1b += t2b * rv_k1;
      rv_k1b += t2b * rv_k1;
      rv_k2b += t2b * rv_k2;
      rv_k2b += t2b * rv_k2;
      wb += t2b;
      rvb[k][2] += rv_k2b;
      rvb[k][1] += rv_k1b;
      rvb[k][0] += rv_k0b;
      p_ib += wb * p_i;
      p_ib += wb * p_i;
      pb[t->sensoradr[i]] += p_ib;
      rab[k][2] += g2_2b;
      pb[2] += g2_2b;
      rab[k][1] += g1b;
      pb[1] += g1b;
      rab[k][0] += g0b;
      pb[0] += g0b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SIDESLIP) {
      tb21 = sb[i][2];
      sb[i][2] = 0.0;
      tb22 = tb21 / t14;
      rvb[k][0] += tb22 * g1_2;
      g1_2b += tb22 * rv[k][0];
      rvb[k][1] -= tb22 * g0_2;
      g0_2b -= tb22 * rv[k][1];
      t14b -= tb22 * s[i][2];
      tb20 = t14b * r2;
      r2b += tb20 * r2;
      r2b += tb20 * r2;
      r2b += t14b * (r2 * r2);
      tb18 = sb[i][1];
      sb[i][1] = 0.0;
      tb19 = tb18 / r2;
      u20b += tb19 * u20;
      u20b += tb19 * u20;
      u21b += tb19 * u21;
      u21b += tb19 * u21;
      r2b -= tb19 * s[i][1];
      t13b += sb[i][0] * 2.0;
      sb[i][0] = 0.0;
      u21b += t13b * (d / (d * d + u21 * u21));
      db -= t13b * (u21 / (d * d + u21 * u21));
      if (MAGGI_RE(u20) < 0.0) {
        t11 = r2 - u20;
        p_i3 = p[t->sensoradr[i]];
        t12 = (u21 * u21 + p_i3 * p_i3) / t11;
        t12b = db;
        db = 0.0;
        tb17 = t12b / t11;
        u21b += tb17 * u21;
        u21b += tb17 * u21;
        p_i3b = tb17 * p_i3;
        p_i3b += tb17 * p_i3;
        t11b = -(tb17 * t12);
        pb[t->sensoradr[i]] += p_i3b;
        r2b += t11b;
        u20b -= t11b;
      } else {
        r2b += db;
        u20b += db;
        db = 0.0;
      }
      t10b += r2b * (1.0 / (2.0 * r2));
      u20b += t10b * u20;
      u20b += t10b * u20;
      u21b += t10b * u21;
      u21b += t10b * u21;
      p_i2b += t10b * p_i2;
      p_i2b += t10b * p_i2;
      pb[t->sensoradr[i]] += p_i2b;
      tb16 = u21b / h;
      A_j0b += tb16 * rv_k1_2;
      rv_k1_2b += tb16 * A_j0;
      A_j3b -= tb16 * rv_k0_2;
      rv_k0_2b -= tb16 * A_j3;
      hb -= tb16 * u21;
      tb15 = u20b / h;
      A_j0b += tb15 * rv_k0_2;
      rv_k0_2b += tb15 * A_j0;
      A_j3b += tb15 * rv_k1_2;
      rv_k1_2b += tb15 * A_j3;
      hb -= tb15 * u20;
      rvb[k][1] += rv_k1_2b;
      rvb[k][0] += rv_k0_2b;
      t9b += hb * (1.0 / (2.0 * h));
      A_j0b += t9b * A_j0;
      A_j0b += t9b * A_j0;
      A_j3b += t9b * A_j3;
      A_j3b += t9b * A_j3;
      Ab[j][3] += A_j3b;
      Ab[j][0] += A_j0b;
      rab[k][1] += g1_2b;
      pb[1] += g1_2b;
      rab[k][0] += g0_2b;
      pb[0] += g0_2b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_VELOCITY) {
      rvb[k][2] += sb[i][2];
      sb[i][2] = 0.0;
      tb25 = sb[i][1];
      sb[i][1] = 0.0;
      tb26 = tb25 / h2;
      A_j0_2b += tb26 * rv_k1_3;
      rv_k1_3b += tb26 * A_j0_2;
      A_j3_2b -= tb26 * rv_k0_3;
      rv_k0_3b -= tb26 * A_j3_2;
      h2b -= tb26 * s[i][1];
      tb23 = sb[i][0];
      sb[i][0] = 0.0;
      tb24 = tb23 / h2;
      A_j0_2b += tb24 * rv_k0_3;
      rv_k0_3b += tb24 * A_j0_2;
      A_j3_2b += tb24 * rv_k1_3;
      rv_k1_3b += tb24 * A_j3_2;
      h2b -= tb24 * s[i][0];
      rvb[k][1] += rv_k1_3b;
      rvb[k][0] += rv_k0_3b;
      t15b += h2b * (1.0 / (2.0 * h2));
      A_j0_2b += t15b * A_j0_2;
      A_j0_2b += t15b * A_j0_2;
      A_j3_2b += t15b * A_j3_2;
      A_j3_2b += t15b * A_j3_2;
      Ab[j][3] += A_j3_2b;
      Ab[j][0] += A_j0_2b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_ACCELERATION) {
      g2_4b += sb[i][2];
      sb[i][2] = 0.0;
      tb29 = sb[i][1];
      sb[i][1] = 0.0;
      tb30 = tb29 / h3;
      A_j0_3b += tb30 * g1_3;
      g1_3b += tb30 * A_j0_3;
      A_j3_3b -= tb30 * g0_3;
      g0_3b -= tb30 * A_j3_3;
      h3b -= tb30 * s[i][1];
      tb27 = sb[i][0];
      sb[i][0] = 0.0;
      tb28 = tb27 / h3;
      A_j0_3b += tb28 * g0_3;
      g0_3b += tb28 * A_j0_3;
      A_j3_3b += tb28 * g1_3;
      g1_3b += tb28 * A_j3_3;
      h3b -= tb28 * s[i][0];
      t16b += h3b * (1.0 / (2.0 * h3));
      A_j0_3b += t16b * A_j0_3;
      A_j0_3b += t16b * A_j0_3;
      A_j3_3b += t16b * A_j3_3;
      A_j3_3b += t16b * A_j3_3;
      Ab[j][3] += A_j3_3b;
      Ab[j][0] += A_j0_3b;
      rab[k][2] += g2_4b;
      pb[2] += g2_4b;
      rab[k][1] += g1_3b;
      pb[1] += g1_3b;
      rab[k][0] += g0_3b;
      pb[0] += g0_3b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_BODY_ACCELERATION) {
      tb33 = sb[i][2];
      sb[i][2] = 0.0;
      Ab[j][2] += tb33 * g0_4;
      g0_4b += tb33 * A[j][2];
      Ab[j][5] += tb33 * g1_4;
      g1_4b += tb33 * A[j][5];
      Ab[j][8] += tb33 * g2_5;
      g2_5b += tb33 * A[j][8];
      tb32 = sb[i][1];
      sb[i][1] = 0.0;
      Ab[j][1] += tb32 * g0_4;
      g0_4b += tb32 * A[j][1];
      Ab[j][4] += tb32 * g1_4;
      g1_4b += tb32 * A[j][4];
      Ab[j][7] += tb32 * g2_5;
      g2_5b += tb32 * A[j][7];
      tb31 = sb[i][0];
      sb[i][0] = 0.0;
      Ab[j][0] += tb31 * g0_4;
      g0_4b += tb31 * A[j][0];
      Ab[j][3] += tb31 * g1_4;
      g1_4b += tb31 * A[j][3];
      Ab[j][6] += tb31 * g2_5;
      g2_5b += tb31 * A[j][6];
      rab[k][2] += g2_5b;
      pb[2] += g2_5b;
      rab[k][1] += g1_4b;
      pb[1] += g1_4b;
      rab[k][0] += g0_4b;
      pb[0] += g0_4b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_COMBINATION) {
      sb[i][2] = 0.0;
      sb[i][1] = 0.0;
      sumb += sb[i][0];
      sb[i][0] = 0.0;
      for (a = t->sensorterms[i] - 1; a >= 0; --a) {
        pb[t->sensoradr[i] + a] += sumb * s[t->termsensor[n2 + a]][t->termcolumn[n2 + a]];
        sb[t->termsensor[n2 + a]][t->termcolumn[n2 + a]] += sumb * p[t->sensoradr[i] + a];
      }
      sumb = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      tb36 = sb[i][2];
      sb[i][2] = 0.0;
      Ab[j][3] += tb36 * (A[j][0] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      Ab[j][0] -= tb36 * (A[j][3] / (A[j][0] * A[j][0] + A[j][3] * A[j][3]));
      tb35 = sb[i][1];
      sb[i][1] = 0.0;
      t17b += tb35 * (t19 / (t19 * t19 + t17 * t17));
      t19b -= tb35 * (t17 / (t19 * t19 + t17 * t17));
      t18b += t19b * (1.0 / (2.0 * t19));
      A_j7b += t18b * A_j7;
      A_j7b += t18b * A_j7;
      A_j8b += t18b * A_j8;
      A_j8b += t18b * A_j8;
      Ab[j][6] -= t17b;
      /* R = Rz(yaw) Ry(pitch) Rx(roll) */
      tb34 = sb[i][0];
      sb[i][0] = 0.0;
      A_j7b += tb34 * (A_j8 / (A_j8 * A_j8 + A_j7 * A_j7));
      A_j8b -= tb34 * (A_j7 / (A_j8 * A_j8 + A_j7 * A_j7));
      Ab[j][8] += A_j8b;
      Ab[j][7] += A_j7b;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      tb40 = sb[i][2];
      sb[i][2] = 0.0;
      Zb[j][5] += tb40;
      Ab[j][6] -= tb40 * roll;
      rollb -= tb40 * A[j][6];
      tb38 = sb[i][1];
      sb[i][1] = 0.0;
      tb39 = tb38 / t20;
      A_j0_4b += tb39 * Z_j4;
      Z_j4b += tb39 * A_j0_4;
      A_j3_4b -= tb39 * Z_j3;
      Z_j3b -= tb39 * A_j3_4;
      t20b -= tb39 * s[i][1];
      c2b += t20b * (1.0 / (2.0 * t20));
      rollb += sb[i][0];
      sb[i][0] = 0.0;
      tb37 = rollb / c2;
      A_j0_4b += tb37 * Z_j3;
      Z_j3b += tb37 * A_j0_4;
      A_j3_4b += tb37 * Z_j4;
      Z_j4b += tb37 * A_j3_4;
      c2b -= tb37 * roll;
      Zb[j][4] += Z_j4b;
      Zb[j][3] += Z_j3b;
      /* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
       * A_6 = -sin(pitch) */
      A_j0_4b += c2b * A_j0_4;
      A_j0_4b += c2b * A_j0_4;
      A_j3_4b += c2b * A_j3_4;
      A_j3_4b += c2b * A_j3_4;
      Ab[j][3] += A_j3_4b;
      Ab[j][0] += A_j0_4b;
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
      tb48 = sb[i][2];
      sb[i][2] = 0.0;
      f0b += tb48;
      f1b += tb48;
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
        if (MAGGI_RE(lv) > MAGGI_RE(p[k3 + 4])) {
          p_k34 = p[k3 + 4];
          pb[k3] += f2b * p_k34;
          p_k34b = f2b * p[k3];
          pb[k3 + 1] += f2b * (lv - p_k34);
          tb46 = f2b * p[k3 + 1];
          lvb += tb46;
          p_k34b -= tb46;
          f2b = 0.0;
          pb[k3 + 4] += p_k34b;
        } else if (MAGGI_RE(lv) > 0.0) {
          pb[k3] += f2b * lv;
          lvb += f2b * p[k3];
          f2b = 0.0;
        } else if (MAGGI_RE(lv) > MAGGI_RE(p[k3 + 5])) {
          pb[k3 + 2] += f2b * lv;
          lvb += f2b * p[k3 + 2];
          f2b = 0.0;
        } else {
          p_k35 = p[k3 + 5];
          pb[k3 + 2] += f2b * p_k35;
          p_k35b = f2b * p[k3 + 2];
          pb[k3 + 3] += f2b * (lv - p_k35);
          tb47 = f2b * p[k3 + 3];
          lvb += tb47;
          p_k35b -= tb47;
          f2b = 0.0;
          pb[k3 + 5] += p_k35b;
        }
      } else {
        dampingb += f1b;
        f1b = 0.0;
      }
      if (t->springpreload[n2]) {
        pb[t->springadr[n2]] += f0b * (l - spring0[n2]);
        tb44 = f0b * p[t->springadr[n2]];
        lb += tb44;
        spring0b[n2] -= tb44;
        pb[t->springadr[n2] + MAGGI_SPRING_L] += f0b;
        f0b = 0.0;
      } else {
        pb[t->springadr[n2]] += f0b * (l - p[t->springadr[n2] + MAGGI_SPRING_L]);
        tb45 = f0b * p[t->springadr[n2]];
        lb += tb45;
        pb[t->springadr[n2] + MAGGI_SPRING_L] -= tb45;
        f0b = 0.0;
      }
      pb[t->springadr[n2] + MAGGI_SPRING_C] += dampingb * lv;
      lvb += dampingb * p[t->springadr[n2] + MAGGI_SPRING_C];
      n40b += lvb * ev0;
      ev0b += lvb * n40;
      n41b += lvb * ev1;
      ev1b += lvb * n41;
      n42b += lvb * ev2_2;
      ev2_2b += lvb * n42;
      tb43 = n42b / l;
      e2_2b += tb43;
      lb -= tb43 * n42;
      tb42 = n41b / l;
      e1b += tb42;
      lb -= tb42 * n41;
      tb41 = n40b / l;
      e0b += tb41;
      lb -= tb41 * n40;
      t21b += lb * (1.0 / (2.0 * l));
      e0b += t21b * e0;
      e0b += t21b * e0;
      e1b += t21b * e1;
      e1b += t21b * e1;
      e2_2b += t21b * e2_2;
      e2_2b += t21b * e2_2;
      rvb[a4][2] += ev2_2b;
      rvb[b][2] -= ev2_2b;
      rb[a4][2] += e2_2b;
      rb[b][2] -= e2_2b;
      rvb[a4][1] += ev1b;
      rvb[b][1] -= ev1b;
      rb[a4][1] += e1b;
      rb[b][1] -= e1b;
      rvb[a4][0] += ev0b;
      rvb[b][0] -= ev0b;
      rb[a4][0] += e0b;
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
      tb49 = torque0b * p[t->jspringadr[n2]];
      x2b -= tb49;
      pb[t->jspringadr[n2] + MAGGI_JSPRING_REST] += tb49;
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
      tb50 = z1_3b / l2;
      e20b += tb50 * ev20;
      ev20b += tb50 * e20;
      e21b += tb50 * ev21;
      ev21b += tb50 * e21;
      e22b += tb50 * ev22;
      ev22b += tb50 * e22;
      l2b -= tb50 * z1_3;
      l2b += z0_3b;
      t22b += l2b * (1.0 / (2.0 * l2));
      e20b += t22b * e20;
      e20b += t22b * e20;
      e21b += t22b * e21;
      e21b += t22b * e21;
      e22b += t22b * e22;
      e22b += t22b * e22;
      rvb[a4_2][2] += ev22b;
      rvb[b2][2] -= ev22b;
      rb[a4_2][2] += e22b;
      rb[b2][2] -= e22b;
      rvb[a4_2][1] += ev21b;
      rvb[b2][1] -= ev21b;
      rb[a4_2][1] += e21b;
      rb[b2][1] -= e21b;
      rvb[a4_2][0] += ev20b;
      rvb[b2][0] -= ev20b;
      /* distance of two points and its rate */
      rb[a4_2][0] += e20b;
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
        tb191 = sb[i][1];
        sb[i][1] = 0.0;
        slip1b += tb191 * (1.0 / (1.0 + slip1 * slip1));
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
          t39 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] * dfz;
          t40 = exp(t39);
          stiff = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz) * t40 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          t41 = cx * dx;
          bx = stiff / t41;
          svx = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUX];
          y5 = bx * kx;
          t42 = atan(y5);
          t43 = (1.0 - ex) * y5 + ex * t42;
          t44 = atan(t43);
          t45 = cx * t44;
          t46 = sin(t45);
          x50 = dx * t46 + svx;
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
          t47 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] * fz0_3;
          z4 = fz2 / t47;
          if (MAGGI_RE(gy) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            y8 = gy;
          } else if (MAGGI_RE(gy) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            y8 = -gy;
          } else {
            p5 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t48 = p5 * p5;
            z5 = gy * gy / t48;
            y8 = 0.125 * p5 * z5 * (15.0 + z5 * (-10.0 + 3.0 * z5));
          }
          t49 = 1.0 + z4 * z4;
          t50 = 2.0 * z4 / t49;
          stiff2 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          t51 = cy * dy;
          by = stiff2 / t51;
          svy = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          y9 = by * ay;
          t52 = atan(y9);
          t53 = (1.0 - ey) * y9 + ey * t52;
          t54 = atan(t53);
          t55 = cy * t54;
          t56 = sin(t55);
          y20 = dy * t56 + svy;
          y21 = stiff2;
          y22 = muy;
          y23 = by * cy;
          t57 = svy / stiff2;
          y24 = shy + t57;
          muy2 = y22;
          x6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          t58 = 1.0 + x6 * x6;
          t59 = sqrt(t58);
          t60 = 1.0 / t59;
          stiff3 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60 *
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
          t61 = 1.0 + x7 * x7;
          t62 = sqrt(t61);
          t63 = 1.0 / t62;
          dv = muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2) * t63;
          y11 = stiff3 * (kappa2 + s4);
          y12 = stiff3 * s4;
          t64 = atan(y11);
          t65 = (1.0 - e9) * y11 + e9 * t64;
          t66 = atan(t65);
          p6 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1];
          t67 = p6 * t66;
          t68 = cos(t67);
          t69 = atan(y12);
          t70 = (1.0 - e9) * y12 + e9 * t69;
          t71 = atan(t70);
          t72 = p6 * t71;
          t73 = cos(t72);
          g30 = t68 / t73;
          t74 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] * kappa2;
          t75 = atan(t74);
          t76 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] * t75;
          t77 = sin(t76);
          g31 = dv * t77 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          x8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] * kappa2;
          t78 = 1.0 + x8 * x8;
          t79 = sqrt(t78);
          t80 = 1.0 / t79;
          stiff4 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80 *
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
          t81 = atan(y14);
          t82 = (1.0 - e11) * y14 + e11 * t81;
          t83 = atan(t82);
          p8 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1];
          t84 = p8 * t83;
          t85 = cos(t84);
          t86 = atan(y15);
          t87 = (1.0 - e11) * y15 + e11 * t86;
          t88 = atan(t87);
          t89 = p8 * t88;
          t90 = cos(t89);
          t91 = t85 / t90;
          fx = x50 * t91;
          fy = g30 * y20 + g31;
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
          t92 = at * at + ratio2 * ratio2 + 1e-24;
          ateq = sqrt(t92);
          t93 = ar * ar + ratio2 * ratio2 + 1e-24;
          areq = sqrt(t93);
          if (MAGGI_RE(gz) > MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER])) {
            y16 = gz;
          } else if (MAGGI_RE(gz) < -MAGGI_RE(p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LOW_CAMBER])) {
            y16 = -gz;
          } else {
            p9 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER];
            t94 = p9 * p9;
            z6 = gz * gz / t94;
            y16 = 0.125 * p9 * z6 * (15.0 + z6 * (-10.0 + 3.0 * z6));
          }
          bt = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] / p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LMUY];
          t95 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] / fz0_4;
          dt = fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          t96 = bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * at;
          t97 = atan(t96);
          e13 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] + p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_QEZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz *
              dfz) * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t97);
          if (MAGGI_RE(e13) > 1.0) {
            y17 = 1.0;
          } else {
            y17 = e13;
          }
          et = y17;
          p10 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          t98 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LKY] / p10;
          br = t98 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] * bycy;
          dr = fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] * p10;
          t99 = 1.0 + a3 * a3;
          t100 = sqrt(t99);
          ca = 1.0 / t100;
          y18 = bt * ateq;
          t101 = atan(y18);
          t102 = (1.0 - et) * y18 + et * t101;
          t103 = atan(t102);
          t104 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] * t103;
          t105 = cos(t104);
          z30 = dt * t105 * ca;
          x9 = br * areq;
          t106 = 1.0 + x9 * x9;
          t107 = sqrt(t106);
          t108 = 1.0 / t107;
          t109 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] * fy / fz0_2;
          s3 = (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t109 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0 * p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_LS];
          t110 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          way = tanh(t110);
          speed3 = one4 / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          t111 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] * fy / fz0_2;
          t112 = p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] * fx / fz0_2;
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
          z30b = -(force5b * (fy - g31));
          tb190 = force5b * z30;
          fyb = -tb190;
          g31b = tb190;
          z31b = force5b;
          s3b = force5b * fx;
          fxb = force5b * s3;
          tb182 = force4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY];
          tb183 = tb182 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
              speed3);
          tb184 = tb183 * fz2;
          wayb = -(tb184 * r0);
          r0b = -(tb184 * way);
          fz2b = tb183 * (-way * r0);
          tb185 = tb182 * (-way * r0 * fz2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] += tb185;
          t112b = tb185;
          tb186 = tb185 * speed3;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] += tb186 * way;
          wayb += tb186 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3];
          speed3b = tb185 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way);
          tb187 = tb185 * speed3;
          tb188 = tb187 * speed3;
          tb189 = tb188 * speed3;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] += tb189 * speed3;
          speed3b += tb189 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4];
          speed3b += tb188 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3);
          speed3b += tb187 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3);
          speed3b += tb185 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 *
              speed3);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMY] += force4b * (-way * r0 * fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY1] + t112 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY3] * way * speed3 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY4] * speed3 * speed3 * speed3 *
              speed3));
          tb181 = t112b / fz0_2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2] += tb181 * fx;
          fxb += tb181 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSY2];
          fz0_2b = -(tb181 * t112);
          tb178 = force3b * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] + (-p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QSX2] * gamma2 + t111) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX]);
          r0b += tb178 * fz2;
          fz2b += tb178 * r0;
          tb179 = force3b * (r0 * fz2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1] += tb179 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVMX] += tb179 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX1];
          tb180 = tb179 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] -= tb180 * gamma2;
          gamma2b = -(tb180 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2]);
          t111b = tb180;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMX] += tb179 *
              (-p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX2] * gamma2 + t111);
          tb177 = t111b / fz0_2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3] += tb177 * fy;
          fyb += tb177 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QSX3];
          fz0_2b -= tb177 * t111;
          fz2b += force2b;
          fyb += force1b;
          fxb += force0b;
          tb176 = speed3b / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL];
          one4b += tb176;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LONGVL] -= tb176 * speed3;
          t110b = wayb * (1.0 - way * way);
          tb175 = t110b / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED];
          one4b += tb175;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_SPEED] -= tb175 * t110;
          tb172 = s3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS];
          tb173 = tb172 * r0;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] += tb173;
          t109b = tb173;
          tb174 = tb173 * gamma2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] += tb174;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] += tb174 * dfz;
          dfzb = tb174 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4];
          gamma2b += tb173 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz);
          r0b += tb172 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ1] + t109 +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_SSZ4] * dfz) * gamma2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LS] += s3b * ((p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_SSZ1] + t109 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ4] * dfz) * gamma2) * r0);
          tb171 = t109b / fz0_2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2] += tb171 * fy;
          fyb += tb171 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_SSZ2];
          fz0_2b -= tb171 * t109;
          tb170 = z31b * ca;
          drb = tb170 * t108;
          t108b = tb170 * dr;
          cab = z31b * (dr * t108);
          tb169 = t108b / t107;
          t107b = -(tb169 * t108);
          t106b = t107b * (1.0 / (2.0 * t107));
          x9b = t106b * x9;
          x9b += t106b * x9;
          brb = x9b * areq;
          areqb = x9b * br;
          tb168 = z30b * ca;
          dtb = tb168 * t105;
          t105b = tb168 * dt;
          cab += z30b * (dt * t105);
          t104b = -(t105b * sin(t104));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += t104b * t103;
          t103b = t104b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          t102b = t103b * (1.0 / (1.0 + t102 * t102));
          etb = -(t102b * y18);
          y18b = t102b * (1.0 - et);
          etb += t102b * t101;
          t101b = t102b * et;
          y18b += t101b * (1.0 / (1.0 + y18 * y18));
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          btb = y18b * ateq;
          ateqb = y18b * bt;
          tb167 = cab / t100;
          t100b = -(tb167 * ca);
          t99b = t100b * (1.0 / (2.0 * t100));
          a3b = t99b * a3;
          a3b += t99b * a3;
          tb162 = drb * p10;
          tb163 = tb162 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS];
          fz2b += tb163 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz);
          tb164 = tb163 * fz2;
          tb165 = tb164 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] += tb165;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] += tb165 * dfz;
          dfzb += tb165 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] += tb164 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz);
          tb166 = tb164 * gz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] += tb166;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] += tb166 * dfz;
          dfzb += tb166 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9];
          gzb = tb164 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb162 * (fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ7] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ9] * dfz) * gz));
          p10b = drb * (fz2 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ6] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ7] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LRES] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ8] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ9] * dfz) * gz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS]);
          t98b = brb;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10] += brb * bycy;
          bycyb = brb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ10];
          tb161 = t98b / p10;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9] += tb161 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb161 *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ9];
          p10b -= tb161 * t98;
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
          tb156 = e13b * (1.0 + (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308 *
              t97);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] += tb156;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] += tb156 * dfz;
          dfzb += tb156 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2];
          tb157 = tb156 * dfz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] += tb157 * dfz;
          dfzb += tb157 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3];
          dfzb += tb156 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz);
          tb158 = e13b * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ3] * dfz * dfz);
          tb159 = tb158 * t97;
          tb160 = tb159 * 0.63661977236758134308;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] += tb160;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] += tb160 * gz;
          gzb += tb160 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5];
          t97b = tb158 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ4] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QEZ5] * gz) * 0.63661977236758134308);
          t96b = t97b * (1.0 / (1.0 + t96 * t96));
          tb155 = t96b * at;
          btb += tb155 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1] += tb155 * bt;
          atb = t96b * (bt * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QCZ1]);
          tb149 = dtb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR];
          tb150 = tb149 * t95;
          tb151 = tb150 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz);
          fz2b += tb151 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz);
          tb152 = tb151 * fz2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] += tb152;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] += tb152 * dfz;
          dfzb += tb152 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2];
          tb153 = tb150 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] += tb153 * gz;
          gzb += tb153 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3];
          tb154 = tb153 * gz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] += tb154 * gz;
          gzb += tb154 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4];
          gzb += tb153 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz);
          t95b = tb149 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ2] * dfz) * (1.0 +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LTR] += dtb * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QDZ2] * dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ3] *
              gz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QDZ4] * gz * gz) * t95);
          tb148 = t95b / fz0_4;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += tb148;
          fz0_4b = -(tb148 * t95);
          tb143 = btb / p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb144 = tb143 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb145 = tb144 * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] += tb145;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] += tb145 * dfz;
          dfzb += tb145 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2];
          tb146 = tb145 * dfz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] += tb146 * dfz;
          dfzb += tb146 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3];
          dfzb += tb145 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz);
          tb147 = tb144 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz * dfz);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] += tb147 * gz;
          gzb += tb147 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] += tb147 * y16;
          y16b = tb147 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += tb143 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_QBZ2] * dfz + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ3] * dfz *
              dfz) * (1.0 + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ4] * gz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QBZ5] * y16));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] -= tb143 * bt;
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
            t94 = p9 * p9;
            z6 = gz * gz / t94;
            tb141 = y16b * (15.0 + z6 * (-10.0 + 3.0 * z6));
            p9b = tb141 * z6 * 0.125;
            z6b = tb141 * (0.125 * p9);
            tb142 = y16b * (0.125 * p9 * z6);
            z6b += tb142 * (-10.0 + 3.0 * z6);
            z6b += tb142 * z6 * 3.0;
            y16b = 0.0;
            tb140 = z6b / t94;
            gzb += tb140 * gz;
            gzb += tb140 * gz;
            t94b = -(tb140 * z6);
            p9b += t94b * p9;
            p9b += t94b * p9;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p9b;
          }
          t93b = areqb * (1.0 / (2.0 * areq));
          arb = t93b * ar;
          arb += t93b * ar;
          ratio2b = t93b * ratio2;
          ratio2b += t93b * ratio2;
          t92b = ateqb * (1.0 / (2.0 * ateq));
          atb += t92b * at;
          atb += t92b * at;
          ratio2b += t92b * ratio2;
          ratio2b += t92b * ratio2;
          a3b += arb;
          shiftb = arb;
          a3b += atb;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ1] += atb;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2] += atb * dfz;
          dfzb += atb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ2];
          tb139 = atb * gz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ3] += tb139;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4] += tb139 * dfz;
          dfzb += tb139 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_QHZ4];
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
          tb138 = ratio2b / y21;
          x51b = tb138 * kappa2;
          kappa2b = tb138 * x51;
          y21b = -(tb138 * ratio2);
          g30b = fyb * y20;
          y20b = fyb * g30;
          g31b += fyb;
          x50b = fxb * t91;
          t91b = fxb * x50;
          tb137 = t91b / t90;
          t85b = tb137;
          t90b = -(tb137 * t91);
          t89b = -(t90b * sin(t89));
          p8b = t89b * t88;
          t88b = t89b * p8;
          t87b = t88b * (1.0 / (1.0 + t87 * t87));
          e11b = -(t87b * y15);
          y15b = t87b * (1.0 - e11);
          e11b += t87b * t86;
          t86b = t87b * e11;
          y15b += t86b * (1.0 / (1.0 + y15 * y15));
          t84b = -(t85b * sin(t84));
          p8b += t84b * t83;
          t83b = t84b * p8;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCX1] += p8b;
          t82b = t83b * (1.0 / (1.0 + t82 * t82));
          e11b -= t82b * y14;
          y14b = t82b * (1.0 - e11);
          e11b += t82b * t81;
          t81b = t82b * e11;
          y14b += t81b * (1.0 / (1.0 + y14 * y14));
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff4b = y15b * p7;
          p7b = y15b * stiff4;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff4b += y14b * (a3 + p7);
          tb136 = y14b * stiff4;
          a3b += tb136;
          p7b += tb136;
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
          tb135 = stiff4b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] += tb135 * t80;
          t80b = tb135 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LXAL] += stiff4b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX1] * t80);
          tb134 = t80b / t79;
          t79b = -(tb134 * t80);
          t78b = t79b * (1.0 / (2.0 * t79));
          x8b = t78b * x8;
          x8b += t78b * x8;
          /* Gxa = Fx / Fx0 */
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2] += x8b * kappa2;
          kappa2b += x8b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBX2];
          tb133 = g31b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA];
          dvb = tb133 * t77;
          t77b = tb133 * dv;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVYKA] += g31b * (dv * t77);
          t76b = t77b * cos(t76);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5] += t76b * t75;
          t75b = t76b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY5];
          t74b = t75b * (1.0 / (1.0 + t74 * t74));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6] += t74b * kappa2;
          kappa2b += t74b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY6];
          tb132 = g30b / t73;
          t68b = tb132;
          t73b = -(tb132 * g30);
          t72b = -(t73b * sin(t72));
          p6b = t72b * t71;
          t71b = t72b * p6;
          t70b = t71b * (1.0 / (1.0 + t70 * t70));
          e9b = -(t70b * y12);
          y12b = t70b * (1.0 - e9);
          e9b += t70b * t69;
          t69b = t70b * e9;
          y12b += t69b * (1.0 / (1.0 + y12 * y12));
          t67b = -(t68b * sin(t67));
          p6b += t67b * t66;
          t66b = t67b * p6;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RCY1] += p6b;
          t65b = t66b * (1.0 / (1.0 + t65 * t65));
          e9b -= t65b * y11;
          y11b = t65b * (1.0 - e9);
          e9b += t65b * t64;
          t64b = t65b * e9;
          y11b += t64b * (1.0 / (1.0 + y11 * y11));
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff3b = y12b * s4;
          s4b = y12b * stiff3;
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          stiff3b += y11b * (kappa2 + s4);
          tb131 = y11b * stiff3;
          kappa2b += tb131;
          s4b += tb131;
          tb128 = dvb * t63;
          tb129 = tb128 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2);
          muy2b = tb129 * fz2;
          fz2b += tb129 * muy2;
          tb130 = tb128 * (muy2 * fz2);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] += tb130;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] += tb130 * dfz;
          dfzb += tb130 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] += tb130 * gamma2;
          gamma2b += tb130 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3];
          t63b = dvb * (muy2 * fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RVY3] * gamma2));
          tb127 = t63b / t62;
          t62b = -(tb127 * t63);
          t61b = t62b * (1.0 / (2.0 * t62));
          x7b = t61b * x7;
          x7b += t61b * x7;
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
          tb126 = stiff3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] += tb126 * t60;
          t60b = tb126 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LYKA] += stiff3b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY1] * t60);
          tb125 = t60b / t59;
          t59b = -(tb125 * t60);
          t58b = t59b * (1.0 / (2.0 * t59));
          x6b = t58b * x6;
          x6b += t58b * x6;
          /* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2] += x6b * (a3 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3]);
          tb124 = x6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY2];
          a3b += tb124;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_RBY3] -= tb124;
          y22b = muy2b;
          shyb = y24b;
          t57b = y24b;
          tb123 = t57b / stiff2;
          svyb = tb123;
          stiff2b = -(tb123 * t57);
          byb = y23b * cy;
          cyb = y23b * by;
          muyb = y22b;
          stiff2b += y21b;
          dyb = y20b * t56;
          t56b = y20b * dy;
          svyb += y20b;
          t55b = t56b * cos(t55);
          cyb += t55b * t54;
          t54b = t55b * cy;
          t53b = t54b * (1.0 / (1.0 + t53 * t53));
          eyb = -(t53b * y9);
          y9b = t53b * (1.0 - ey);
          eyb += t53b * t52;
          t52b = t53b * ey;
          y9b += t52b * (1.0 / (1.0 + y9 * y9));
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          byb += y9b * ay;
          ayb = y9b * by;
          tb119 = svyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          fz2b += tb119 * ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] * dfz) *
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] + (p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz) * gy);
          tb120 = tb119 * fz2;
          tb121 = tb120 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] += tb121;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2] += tb121 * dfz;
          dfzb += tb121 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] += tb120 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY2] * dfz);
          tb122 = tb120 * gy;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] += tb122;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] += tb122 * dfz;
          dfzb += tb122 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4];
          gyb = tb120 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY4] * dfz);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY] += svyb * (fz2 *
              ((p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVY] +
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVY3] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVY4] * dfz) * gy));
          tb118 = byb / t51;
          stiff2b += tb118;
          t51b = -(tb118 * by);
          cyb += t51b * dy;
          dyb += t51b * cy;
          tb114 = stiff2b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY];
          tb115 = tb114 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8);
          tb116 = tb115 * t50;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] += tb116 * fz0_3;
          fz0_3b = tb116 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1];
          t50b = tb115 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3);
          tb117 = tb114 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] -= tb117 * y8;
          y8b = -(tb117 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3]);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKY] += stiff2b *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY1] * fz0_3 * t50 * (1.0 -
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY3] * y8));
          tb113 = t50b / t49;
          z4b = tb113 * 2.0;
          t49b = -(tb113 * t50);
          z4b += t49b * z4;
          z4b += t49b * z4;
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
            t48 = p5 * p5;
            z5 = gy * gy / t48;
            tb111 = y8b * (15.0 + z5 * (-10.0 + 3.0 * z5));
            p5b = tb111 * z5 * 0.125;
            z5b = tb111 * (0.125 * p5);
            tb112 = y8b * (0.125 * p5 * z5);
            z5b += tb112 * (-10.0 + 3.0 * z5);
            z5b += tb112 * z5 * 3.0;
            y8b = 0.0;
            tb110 = z5b / t48;
            gyb += tb110 * gy;
            gyb += tb110 * gy;
            t48b = -(tb110 * z5);
            p5b += t48b * p5;
            p5b += t48b * p5;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LOW_CAMBER] += p5b;
          }
          tb109 = z4b / t47;
          fz2b += tb109;
          t47b = -(tb109 * z4);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2] += t47b * fz0_3;
          fz0_3b += t47b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKY2];
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
            tb107 = e7b * e6;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] -= tb107;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] -= tb107 * gy;
            gyb -= tb107 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
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
            tb108 = e8b * e6;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY3] += tb108;
            pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4] += tb108 * gy;
            gyb += tb108 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY4];
          }
          tb106 = e6b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY1] += tb106;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] += tb106 * dfz;
          dfzb += tb106 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEY] += e6b * (p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEY1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEY2] * dfz);
          muyb += dyb * fz2;
          fz2b += dyb * muy;
          tb102 = muyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUY];
          tb103 = tb102 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy * gy);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] += tb103;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] += tb103 * dfz;
          dfzb += tb103 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2];
          tb104 = tb102 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY2] * dfz);
          tb105 = tb104 * gy;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] -= tb105 * gy;
          gyb -= tb105 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3];
          gyb -= tb104 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDY3] * gy);
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
          tb101 = shyb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHY];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY1] += tb101;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2] += tb101 * dfz;
          dfzb += tb101 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHY2];
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
          dxb = x50b * t46;
          t46b = x50b * dx;
          svxb = x50b;
          t45b = t46b * cos(t45);
          cxb = t45b * t44;
          t44b = t45b * cx;
          t43b = t44b * (1.0 / (1.0 + t43 * t43));
          exb = -(t43b * y5);
          y5b = t43b * (1.0 - ex);
          exb += t43b * t42;
          t42b = t43b * ex;
          y5b += t42b * (1.0 / (1.0 + y5 * y5));
          /* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
          bxb = y5b * kx;
          kxb = y5b * bx;
          tb98 = svxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb99 = tb98 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX];
          fz2b += tb99 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] * dfz);
          tb100 = tb99 * fz2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] += tb100;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2] += tb100 * dfz;
          dfzb += tb100 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX] += tb98 * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX] += svxb * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PVX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PVX2] * dfz) * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LVX]);
          tb97 = bxb / t41;
          stiffb += tb97;
          t41b = -(tb97 * bx);
          cxb += t41b * dx;
          dxb += t41b * cx;
          tb94 = stiffb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX];
          tb95 = tb94 * t40;
          fz2b += tb95 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz);
          tb96 = tb95 * fz2;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] += tb96;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] += tb96 * dfz;
          dfzb += tb96 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2];
          t40b = tb94 * (fz2 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX2] * dfz));
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LKX] += stiffb * (fz2 *
              (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX1] + p[t->tyreadr[t->wheeltyre[n2]] +
              MAGGI_TYRE_PKX2] * dfz) * t40);
          t39b = t40b * t40;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3] += t39b * dfz;
          dfzb += t39b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PKX3];
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
          tb92 = e3b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX1] += tb92;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] += tb92 * dfz;
          dfzb += tb92 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2];
          tb93 = tb92 * dfz;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] += tb93 * dfz;
          dfzb += tb93 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3];
          dfzb += tb92 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LEX] += e3b * (p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PEX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX2] * dfz +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PEX3] * dfz * dfz);
          muxb = dxb * fz2;
          fz2b += dxb * mux;
          tb88 = muxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LMUX];
          tb89 = tb88 * (1.0 - p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx * gx);
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] += tb89;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] += tb89 * dfz;
          dfzb += tb89 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2];
          tb90 = tb88 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX1] +
              p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX2] * dfz);
          tb91 = tb90 * gx;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] -= tb91 * gx;
          gxb = -(tb91 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3]);
          gxb -= tb90 * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PDX3] * gx);
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
          tb87 = kxb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX1] += tb87;
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] += tb87 * dfz;
          dfzb += tb87 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2];
          pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LHX] += kxb * (p[t->tyreadr[t->wheeltyre[n2]]
              + MAGGI_TYRE_PHX1] + p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_PHX2] * dfz);
          tb86 = dfzb / fz0_2;
          fz2b += tb86;
          fz0_2b -= tb86;
          fz0_2b -= tb86 * dfz;
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
      tb85 = a2b / speed2;
      v20b += tb85 * L0;
      L0b += tb85 * v20;
      v21b += tb85 * L1;
      L1b += tb85 * v21;
      v22b += tb85 * L2;
      L2b += tb85 * v22;
      speed2b -= tb85 * a2;
      tb84 = kappab / speed2;
      omegab += tb84 * re;
      reb += tb84 * omega;
      vxb -= tb84;
      speed2b -= tb84 * kappa;
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
        t38 = vx * vx / p4;
        tb83 = yb * 0.5;
        p4b = tb83;
        t38b = tb83;
        yb = 0.0;
        tb82 = t38b / p4;
        vxb += tb82 * vx;
        vxb += tb82 * vx;
        p4b -= tb82 * t38;
        pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VXLOW] += p4b;
      }
      p3b += reb;
      t35b -= reb * (p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] * t37 +
          p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] * ratio);
      tb81 = reb * t35;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF] -= tb81 * t37;
      t37b -= tb81 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_DREFF];
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF] -= tb81 * ratio;
      ratiob -= tb81 * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_FREFF];
      t36b += t37b * (1.0 / (1.0 + t36 * t36));
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF] += t36b * ratio;
      ratiob += t36b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_BREFF];
      tb80 = t35b / p2;
      fz0b += tb80;
      p2b -= tb80 * t35;
      tb79 = ratiob / fz0;
      fzb += tb79;
      fz0b -= tb79 * ratio;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO] += fz0b * p[t->tyreadr[t->wheeltyre[n2]]];
      pb[t->tyreadr[t->wheeltyre[n2]]] += fz0b * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_LFZO];
      p2b += fzb * (p3 - z20);
      tb78 = fzb * p2;
      p3b += tb78;
      z20b -= tb78;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING] += fzb * rhov;
      rhovb += fzb * p[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_DAMPING];
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_UNLOADED_RADIUS] += p3b;
      pb[t->tyreadr[t->wheeltyre[n2]] + MAGGI_TYRE_VERTICAL_STIFFNESS] += p2b;
      tb75 = omegab * u30;
      Zb[j][3] += tb75;
      Z_k3b -= tb75;
      u30b += omegab * (Z[j][3] - Z_k3);
      tb76 = omegab * u31;
      Zb[j][4] += tb76;
      Z_k4b -= tb76;
      u31b += omegab * (Z[j][4] - Z_k4);
      tb77 = omegab * u32;
      Zb[j][5] += tb77;
      Z_k5b -= tb77;
      u32b += omegab * (Z[j][5] - Z_k5);
      tb74 = rhovb / z22;
      v20b -= tb74 * N0;
      N0b -= tb74 * v20;
      v21b -= tb74 * N1;
      v22b -= tb74 * N2;
      N2b -= tb74 * v22;
      z22b -= tb74 * rhov;
      v20b += vxb * T0;
      T0b += vxb * v20;
      v21b += vxb * T1;
      T1b += vxb * v21;
      v22b += vxb * T2;
      T2b += vxb * v22;
      rvb[a4_3][2] += v22b;
      vr2b += v22b;
      rvb[a4_3][1] += v21b;
      vr1b += v21b;
      rvb[a4_3][0] += v20b;
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
      w2b += z22b;
      c3b += z21b;
      r3b += z20b;
      n62b += N2b;
      along2b += T2b;
      tb72 = arm2b / w2;
      r3b += tb72 * (c3 * u32 - n62);
      tb73 = tb72 * r3;
      c3b += tb73 * u32;
      u32b += tb73 * c3;
      n62b -= tb73;
      w2b -= tb72 * arm2;
      along1b += T1b;
      tb70 = arm1b / w2;
      r3b += tb70 * (c3 * u31 - n61);
      tb71 = tb70 * r3;
      c3b += tb71 * u31;
      u31b += tb71 * c3;
      w2b -= tb70 * arm1;
      n60b += N0b;
      along0b += T0b;
      tb68 = arm0b / w2;
      r3b += tb68 * (c3 * u30 - n60);
      tb69 = tb68 * r3;
      c3b += tb69 * u30;
      u30b += tb69 * c3;
      n60b -= tb69;
      w2b -= tb68 * arm0;
      n60b += L2b * along1;
      along1b += L2b * n60;
      along0b -= L2b * n61;
      n62b += L1b * along0;
      along0b += L1b * n62;
      n60b -= L1b * along2;
      along2b -= L1b * n60;
      along2b += L0b * n61;
      n62b -= L0b * along1;
      along1b -= L0b * n62;
      tb67 = along2b / w2;
      un2b += tb67;
      w2b -= tb67 * along2;
      tb66 = along1b / w2;
      un1b += tb66;
      w2b -= tb66 * along1;
      tb65 = along0b / w2;
      un0b += tb65;
      w2b -= tb65 * along0;
      tb62 = r3b / w2;
      tb63 = tb62 * n60;
      g20b += tb63;
      x3b -= tb63;
      n60b += tb62 * (g20 - x3);
      tb64 = tb62 * n62;
      g22b += tb64;
      h10b -= tb64;
      n62b += tb62 * (g22 - h10);
      w2b -= tb62 * r3;
      t34b += w2b * (1.0 / (2.0 * w2));
      un0b += t34b * un0;
      un0b += t34b * un0;
      un1b += t34b * un1;
      un1b += t34b * un1;
      un2b += t34b * un2;
      un2b += t34b * un2;
      u30b += un2b * n61;
      u31b -= un2b * n60;
      n60b -= un2b * u31;
      u32b += un1b * n60;
      n60b += un1b * u32;
      u30b -= un1b * n62;
      n62b -= un1b * u30;
      u31b += un0b * n62;
      n62b += un0b * u31;
      u32b -= un0b * n61;
      u30b += c3b * n60;
      n60b += c3b * u30;
      u31b += c3b * n61;
      u32b += c3b * n62;
      n62b += c3b * u32;
      tb61 = n62b / s2;
      s2b -= tb61 * n62;
      tb60 = n60b / s2;
      h11b -= tb60;
      s2b -= tb60 * n60;
      t33b += s2b * (1.0 / (2.0 * s2));
      h11b += t33b * h11;
      h11b += t33b * h11;
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
        t28 = 6.28318530717958647693 * x3 / p_b2_5;
        t29 = sin(t28);
        p_b2_6 = p[t->roadadr[b2_2]];
        t30 = p_b2_6 * 6.28318530717958647693 / p_b2_5;
        t31 = 6.28318530717958647693 * x3 / p_b2_5;
        t32 = cos(t31);
        t30b = h11b * t32;
        t32b = h11b * t30;
        h11b = 0.0;
        t31b = -(t32b * sin(t31));
        tb59 = t31b / p_b2_5;
        x3b += tb59 * 6.28318530717958647693;
        p_b2_5b = -(tb59 * t31);
        tb58 = t30b / p_b2_5;
        p_b2_6b = tb58 * 6.28318530717958647693;
        p_b2_5b -= tb58 * t30;
        p_b2_6b += h10b * t29;
        t29b = h10b * p_b2_6;
        h10b = 0.0;
        pb[t->roadadr[b2_2]] += p_b2_6b;
        t28b = t29b * cos(t28);
        tb57 = t28b / p_b2_5;
        x3b += tb57 * 6.28318530717958647693;
        p_b2_5b -= tb57 * t28;
        pb[t->roadadr[b2_2] + 1] += p_b2_5b;
      }
      g20b += x3b;
      t27b += x3b * (g22 - h00);
      tb56 = x3b * t27;
      g22b += tb56;
      h00b -= tb56;
      tb55 = t27b / t26;
      u32b += tb55 * u30;
      u30b += tb55 * u32;
      t26b -= tb55 * t27;
      u30b += t26b * u30;
      u30b += t26b * u30;
      u31b += t26b * u31;
      u31b += t26b * u31;
      /* height of the road above its point at x ahead of it, and its slope */
      if (t->roadkind[b2_2] == MAGGI_ROAD_FLAT) {
        p_b2 = p[t->roadadr[b2_2]];
        p_b2b = h00b * x4;
        x4b += h00b * p_b2;
        h00b = 0.0;
        pb[t->roadadr[b2_2]] += p_b2b;
      } else {
        p_b2_2 = p[t->roadadr[b2_2] + 1];
        t24 = 6.28318530717958647693 * x4 / p_b2_2;
        t25 = sin(t24);
        p_b2_3 = p[t->roadadr[b2_2]];
        p_b2_3b = h00b * t25;
        t25b = h00b * p_b2_3;
        h00b = 0.0;
        pb[t->roadadr[b2_2]] += p_b2_3b;
        t24b = t25b * cos(t24);
        tb54 = t24b / p_b2_2;
        x4b += tb54 * 6.28318530717958647693;
        p_b2_2b = -(tb54 * t24);
        pb[t->roadadr[b2_2] + 1] += p_b2_2b;
      }
      /* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
       * the centre down the disc meets it, n its normal; then down the disc to that plane,
       *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
       * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
      g20b += x4b;
      rb[a4_3][2] += g22b;
      rb[t->roadpoint[b2_2]][2] -= g22b;
      rb[a4_3][0] += g20b;
      rb[t->roadpoint[b2_2]][0] -= g20b;
      tb53 = u32b / n5;
      ua2b += tb53;
      n5b -= tb53 * u32;
      tb52 = u31b / n5;
      ua1b += tb52;
      n5b -= tb52 * u31;
      tb51 = u30b / n5;
      ua0b += tb51;
      n5b -= tb51 * u30;
      t23b += n5b * (1.0 / (2.0 * n5));
      ua0b += t23b * ua0;
      ua0b += t23b * ua0;
      ua1b += t23b * ua1;
      ua1b += t23b * ua1;
      ua2b += t23b * ua2;
      ua2b += t23b * ua2;
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
