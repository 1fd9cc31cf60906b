/* Tyres: PAC2002 in steady state, pure and combined slip, and the contact of a wheel with the road.
 *
 * Axes at the contact point: x along the line of the wheel plane on the road, z the road's normal, y to
 * the left.  Forces act on the wheel.  `mirror` exchanges left and right.
 *
 * [1] 3.4;  [2] H. B. Pacejka, Tyre and Vehicle Dynamics, 2002, 4.3;  [3] MSC Adams/Tire, PAC2002.
 */
#include "kernel.h"
#include "maggi/maggi.h"

#define C(name) p[adr + MAGGI_TYRE_##name]

/* a curvature: more than 1 would turn the curve around */
static double at_most_1(double e)
{
  double y;

  if (MAGGI_RE(e) > 1.0)
    y = 1.0;
  else
    y = e;
  return y;
}

/* |x|, with two continuous derivatives:  w (15 y^2 - 10 y^4 + 3 y^6) / 8,  y = x / w,  in |x| < w;  0 at 0,
 * where straight running is, and exact from w on */
static double magnitude(double x, double w)
{
  double y, z;

  if (MAGGI_RE(x) > MAGGI_RE(w)) {
    y = x;
  } else if (MAGGI_RE(x) < -MAGGI_RE(w)) {
    y = -x;
  } else {
    z = x * x / (w * w);
    y = 0.125 * w * z * (15.0 + z * (-10.0 + 3.0 * z));
  }
  return y;
}

/* C atan(B x - E (B x - atan(B x))), without a difference where E is 1 */
static double curve(double stiff, double c, double e, double x)
{
  double y;

  y = stiff * x;
  return c * atan((1.0 - e) * y + e * atan(y));
}

/* cos(atan(x)) */
static double lean(double x)
{
  return 1.0 / sqrt(1.0 + x * x);
}

/* Fx0, Kx */
static void longitudinal(int np, const double p[np], int adr, double fz, double dfz, double kappa,
                         double gamma, double f[2])
{
  double kx, gx, cx, mux, dx, e, ex, stiff, bx, svx;

  kx = kappa + (C(PHX1) + C(PHX2) * dfz) * C(LHX);
  gx = gamma * C(LGAX);
  cx = C(PCX1) * C(LCX);
  mux = (C(PDX1) + C(PDX2) * dfz) * (1.0 - C(PDX3) * gx * gx) * C(LMUX);
  dx = mux * fz;
  e = (C(PEX1) + C(PEX2) * dfz + C(PEX3) * dfz * dfz) * C(LEX);
  if (MAGGI_RE(kx) > 0.0)
    ex = at_most_1(e * (1.0 - C(PEX4)));
  else
    ex = at_most_1(e * (1.0 + C(PEX4)));
  stiff = fz * (C(PKX1) + C(PKX2) * dfz) * exp(C(PKX3) * dfz) * C(LKX);
  bx = stiff / (cx * dx);
  svx = fz * (C(PVX1) + C(PVX2) * dfz) * C(LVX) * C(LMUX);
  f[0] = dx * sin(curve(bx, cx, ex, kx)) + svx;
  f[1] = stiff;
}

/* Fy0, Ky, muy, By Cy, SHy + SVy / Ky;  sin(2 atan(z)) = 2 z / (1 + z^2) */
static void lateral(int np, const double p[np], int adr, double fz, double dfz, double a,
                    double gamma, double f[5])
{
  double fz0, gy, shy, ay, cy, muy, dy, e, ey, z, stiff, by, svy;

  fz0 = C(LFZO) * C(FNOMIN);
  gy = gamma * C(LGAY);
  shy = (C(PHY1) + C(PHY2) * dfz) * C(LHY) + C(PHY3) * gy;
  ay = a + shy;
  cy = C(PCY1) * C(LCY);
  muy = (C(PDY1) + C(PDY2) * dfz) * (1.0 - C(PDY3) * gy * gy) * C(LMUY);
  dy = muy * fz;
  e = (C(PEY1) + C(PEY2) * dfz) * C(LEY);
  if (MAGGI_RE(ay) > 0.0)
    ey = at_most_1(e * (1.0 - (C(PEY3) + C(PEY4) * gy)));
  else
    ey = at_most_1(e * (1.0 + (C(PEY3) + C(PEY4) * gy)));
  z = fz / (C(PKY2) * fz0);
  stiff = C(PKY1) * fz0 * (2.0 * z / (1.0 + z * z)) *
          (1.0 - C(PKY3) * magnitude(gy, C(LOW_CAMBER))) * C(LKY);
  by = stiff / (cy * dy);
  svy = fz * ((C(PVY1) + C(PVY2) * dfz) * C(LVY) + (C(PVY3) + C(PVY4) * dfz) * gy) * C(LMUY);
  f[0] = dy * sin(curve(by, cy, ey, ay)) + svy;
  f[1] = stiff;
  f[2] = muy;
  f[3] = by * cy;
  f[4] = shy + svy / stiff;
}

/* Gxa = Fx / Fx0 */
static double longitudinal_weight(int np, const double p[np], int adr, double dfz, double kappa,
                                  double a)
{
  double stiff, e;

  stiff = C(RBX1) * lean(C(RBX2) * kappa) * C(LXAL);
  e = at_most_1(C(REX1) + C(REX2) * dfz);
  return cos(curve(stiff, C(RCX1), e, a + C(RHX1))) / cos(curve(stiff, C(RCX1), e, C(RHX1)));
}

/* Gyk, SVyk:  Fy = Gyk Fy0 + SVyk */
static void lateral_weight(int np, const double p[np], int adr, double fz, double dfz, double kappa,
                           double a, double gamma, double muy, double f[2])
{
  double stiff, e, s, dv;

  stiff = C(RBY1) * lean(C(RBY2) * (a - C(RBY3))) * C(LYKA);
  e = at_most_1(C(REY1) + C(REY2) * dfz);
  s = C(RHY1) + C(RHY2) * dfz;
  dv = muy * fz * (C(RVY1) + C(RVY2) * dfz + C(RVY3) * gamma) * lean(C(RVY4) * a);
  f[0] = cos(curve(stiff, C(RCY1), e, kappa + s)) / cos(curve(stiff, C(RCY1), e, s));
  f[1] = dv * sin(C(RVY5) * atan(C(RVY6) * kappa)) * C(LVYKA);
}

/* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
 *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
static void aligning(int np, const double p[np], int adr, double fz, double dfz, double a,
                     double gamma, double ratio, double bycy, double shift, double f[2])
{
  double fz0, gz, at, ar, ateq, areq, bt, dt, et, br, dr, ca;

  fz0 = C(LFZO) * C(FNOMIN);
  gz = gamma * C(LGAZ);
  at = a + C(QHZ1) + C(QHZ2) * dfz + (C(QHZ3) + C(QHZ4) * dfz) * gz;
  ar = a + shift;
  ateq = sqrt(at * at + ratio * ratio + 1e-24);
  areq = sqrt(ar * ar + ratio * ratio + 1e-24);
  bt = (C(QBZ1) + C(QBZ2) * dfz + C(QBZ3) * dfz * dfz) *
       (1.0 + C(QBZ4) * gz + C(QBZ5) * magnitude(gz, C(LOW_CAMBER))) * C(LKY) / C(LMUY);
  dt = fz * (C(QDZ1) + C(QDZ2) * dfz) * (1.0 + C(QDZ3) * gz + C(QDZ4) * gz * gz) *
       (C(UNLOADED_RADIUS) / fz0) * C(LTR);
  et = at_most_1(
      (C(QEZ1) + C(QEZ2) * dfz + C(QEZ3) * dfz * dfz) *
      (1.0 + (C(QEZ4) + C(QEZ5) * gz) * 0.63661977236758134308 * atan(bt * C(QCZ1) * at)));
  br = C(QBZ9) * C(LKY) / C(LMUY) + C(QBZ10) * bycy;
  dr = fz * ((C(QDZ6) + C(QDZ7) * dfz) * C(LRES) + (C(QDZ8) + C(QDZ9) * dfz) * gz) *
       C(UNLOADED_RADIUS) * C(LMUY);
  ca = lean(a);
  f[0] = dt * cos(curve(bt, C(QCZ1), et, ateq)) * ca;
  f[1] = dr * lean(br * areq) * ca;
}

/* slip: kappa, tan(alpha), gamma, Fz > 0, Vx; f: Fx Fy Fz, Mx My Mz.  |Vx| is Vx tanh(Vx / low) */
void maggi_tyre(int adr, int np, const double p[np], const double slip[5], double f[6])
{
  double kappa, a, gamma, fz, fz0, r0, dfz, fx, fy, ratio, s, way, speed;
  double x[2], y[5], g[2], z[2];

  kappa = slip[0];
  a = slip[1];
  gamma = slip[2];
  fz = slip[3];
  fz0 = C(LFZO) * C(FNOMIN);
  r0 = C(UNLOADED_RADIUS);
  dfz = (fz - fz0) / fz0;
  longitudinal(np, p, adr, fz, dfz, kappa, gamma, x);
  lateral(np, p, adr, fz, dfz, a, gamma, y);
  lateral_weight(np, p, adr, fz, dfz, kappa, a, gamma, y[2], g);
  fx = x[0] * longitudinal_weight(np, p, adr, dfz, kappa, a);
  fy = g[0] * y[0] + g[1];
  ratio = x[1] * kappa / y[1];
  aligning(np, p, adr, fz, dfz, a, gamma, ratio, y[3], y[4], z);
  s = (C(SSZ1) + C(SSZ2) * fy / fz0 + (C(SSZ3) + C(SSZ4) * dfz) * gamma) * r0 * C(LS);
  way = tanh(slip[4] / C(LOW_SPEED));
  speed = slip[4] / C(LONGVL);
  f[0] = fx;
  f[1] = fy;
  f[2] = fz;
  f[3] = r0 * fz * (C(QSX1) * C(LVMX) + (-C(QSX2) * gamma + C(QSX3) * fy / fz0) * C(LMX));
  f[4] = -way * r0 * fz *
         (C(QSY1) + C(QSY2) * fx / fz0 + C(QSY3) * way * speed +
          C(QSY4) * speed * speed * speed * speed) *
         C(LMY);
  f[5] = -z[0] * (fy - g[1]) + z[1] + s * fx;
}

/* the formula of every tyre at a slip of its own */
void maggi_tyres(const maggi_topo *t, const double p[t->np], const double slip[t->ntyre][5],
                 double f[t->ntyre][6])
{
  int i;

  for (i = 0; i < t->ntyre; ++i) maggi_tyre(t->tyreadr[i], t->np, p, slip[i], f[i]);
}

/* height of the road above its point at x ahead of it, and its slope */
static void road_height(int kind, int adr, int np, const double p[np], double x, double h[2])
{
  if (kind == MAGGI_ROAD_FLAT) {
    h[0] = p[adr] * x;
    h[1] = p[adr];
  } else {
    h[0] = p[adr] * sin(6.28318530717958647693 * x / p[adr + 1]);
    h[1] =
        p[adr] * 6.28318530717958647693 / p[adr + 1] * cos(6.28318530717958647693 * x / p[adr + 1]);
  }
}

/* |v|; less than low gives way to (low + v^2 / low) / 2, which is not 0 at rest */
static double at_least(double v, double low)
{
  double y;

  if (MAGGI_RE(v) > MAGGI_RE(low))
    y = v;
  else if (MAGGI_RE(v) < -MAGGI_RE(low))
    y = -v;
  else
    y = 0.5 * (low + v * v / low);
  return y;
}

/* Where the rigid disc of a wheel meets the road: the plane that touches the road where the line from
 * the centre down the disc meets it, n its normal; then down the disc to that plane,
 *   e = (u.n u - n) / |u × n|,  r = (c - q).n / |u × n|,  T = u × n / |u × n|,  L = n × T
 * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n| */
static void contact(int kind, int adr, int np, const double p[np], const double u[3],
                    const double g[3], double arm[3], double T[3], double L[3], double N[3],
                    double z[3])
{
  int k;
  double x, s, c, w, r;
  double h0[2], h1[2], n[3], un[3], along[3];

  road_height(kind, adr, np, p, g[0], h0);
  x = g[0] + u[2] * u[0] / (u[0] * u[0] + u[1] * u[1]) * (g[2] - h0[0]);
  road_height(kind, adr, np, p, x, h1);
  s = sqrt(1.0 + h1[1] * h1[1]);
  n[0] = -h1[1] / s;
  n[1] = 0.0;
  n[2] = 1.0 / s;
  c = maggi_dot(u, n);
  maggi_cross(u, n, un);
  w = sqrt(maggi_dot(un, un));
  r = ((g[0] - x) * n[0] + (g[2] - h1[0]) * n[2]) / w;
  for (k = 0; k < 3; ++k) along[k] = un[k] / w;
  maggi_cross(n, along, L);
  for (k = 0; k < 3; ++k) {
    arm[k] = r * (c * u[k] - n[k]) / w;
    T[k] = along[k];
    N[k] = n[k];
  }
  z[0] = r;
  z[1] = c;
  z[2] = w;
}

/* Slip and forces of a wheel.
 *   V = v_C + w_carrier × r e,  Omega = (w - w_carrier).u,  rho = R0 - r,  rho' = -V.n / |u × n|
 *   Fz = Cz rho + Cd rho',  Re = R0 - rho0 (D atan(B rd) + F rd),  rd = Fz / Fz0,  rho0 = Fz0 / Cz
 *   kappa = -(V.t - Omega Re) / |V.t|,  tan(alpha) = V.l / |V.t|,  sin(gamma) = u.n
 * No force without contact; without grip that of the spring alone, as at rest. */
void maggi_wheel(int axis, int adr, int mirror, int grip, int kind, int roadadr, int np,
                 const double p[np], const double A[9], const double Z[6], const double Zc[6],
                 const double c[3], const double cv[3], const double road[3], double slip[5],
                 double f[6], double arm[3], double T[3], double L[3], double N[3])
{
  int k;
  double fz, fz0, ratio, re, omega, vx, speed, kappa, a, gamma, rhov, side, n;
  double a0[3], ua[3], u[3], g[3], vr[3], v[3], wr[3], z[3], one[5], force[6];

  side = mirror ? -1.0 : 1.0;
  for (k = 0; k < 3; ++k) a0[k] = p[axis + k];
  maggi_mul(A, a0, ua);
  n = sqrt(maggi_dot(ua, ua));
  for (k = 0; k < 3; ++k) u[k] = ua[k] / n;
  for (k = 0; k < 3; ++k) g[k] = c[k] - road[k];
  contact(kind, roadadr, np, p, u, g, arm, T, L, N, z);
  for (k = 0; k < 3; ++k) wr[k] = Zc[k + 3];
  maggi_cross(wr, arm, vr);
  for (k = 0; k < 3; ++k) v[k] = cv[k] + vr[k];
  vx = maggi_dot(v, T);
  rhov = -maggi_dot(v, N) / z[2];
  omega = (Z[3] - Zc[3]) * u[0] + (Z[4] - Zc[4]) * u[1] + (Z[5] - Zc[5]) * u[2];
  fz = C(VERTICAL_STIFFNESS) * (C(UNLOADED_RADIUS) - z[0]) + C(VERTICAL_DAMPING) * rhov;
  fz0 = C(LFZO) * C(FNOMIN);
  ratio = fz / fz0;
  re = C(UNLOADED_RADIUS) -
       fz0 / C(VERTICAL_STIFFNESS) * (C(DREFF) * atan(C(BREFF) * ratio) + C(FREFF) * ratio);
  speed = at_least(vx, C(VXLOW));
  kappa = (omega * re - vx) / speed;
  a = maggi_dot(v, L) / speed;
  gamma = atan2(z[1], z[2]);
  if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z[0]) < MAGGI_RE(C(UNLOADED_RADIUS))) {
    one[0] = kappa;
    one[1] = side * a;
    one[2] = side * gamma;
    one[3] = fz;
    one[4] = vx;
    if (grip) {
      maggi_tyre(adr, np, p, one, force);
      f[0] = force[0];
      f[1] = side * force[1];
      f[2] = force[2];
      f[3] = side * force[3];
      f[4] = force[4];
      f[5] = side * force[5];
    } else {
      for (k = 0; k < 6; ++k) f[k] = k == 2 ? fz : 0.0;
    }
  } else {
    for (k = 0; k < 6; ++k) f[k] = 0.0;
  }
  slip[0] = kappa;
  slip[1] = a;
  slip[2] = gamma;
  slip[3] = fz;
  slip[4] = vx;
}

/* Rates of the coordinates on which wheels turn at which they roll freely, kappa = 0: with V the velocity of
 * the contact point on the carrier and w the velocity of the wheel by its coordinate
 *   v = V.t / (Re w.u) */
void maggi_rolling(const maggi_topo *t, const double p[t->np], const double A[t->nbody + 1][9],
                   const double b[t->nbody][6], const double r[t->npoint][3],
                   const double Z[t->nbody + 1][6], double spin[t->nwheel])
{
  int i, k, adr, body, carrier, road;
  double n, fz, fz0, ratio, re, rhov;
  double a0[3], ua[3], u[3], g[3], arm[3], T[3], L[3], N[3], z[3], c[3], w[3], v[3], wr[3];

  for (i = 0; i < t->nwheel; ++i) {
    adr = t->tyreadr[t->wheeltyre[i]];
    body = t->wheelbody[i];
    carrier = t->wheelcarrier[i];
    road = t->wheelroad[i];
    for (k = 0; k < 3; ++k) a0[k] = p[t->wheelaxis[i] + k];
    maggi_mul(A[body], a0, ua);
    n = sqrt(maggi_dot(ua, ua));
    for (k = 0; k < 3; ++k) u[k] = ua[k] / n;
    for (k = 0; k < 3; ++k) g[k] = r[t->wheelpoint[i]][k] - r[t->roadpoint[road]][k];
    contact(t->roadkind[road], t->roadadr[road], t->np, p, u, g, arm, T, L, N, z);
    for (k = 0; k < 3; ++k) c[k] = r[t->wheelpoint[i]][k] + arm[k];
    for (k = 0; k < 3; ++k) wr[k] = Z[carrier][k + 3];
    maggi_cross(wr, c, w);
    for (k = 0; k < 3; ++k) v[k] = Z[carrier][k] + w[k];
    rhov = -maggi_dot(v, N) / z[2];
    fz = C(VERTICAL_STIFFNESS) * (C(UNLOADED_RADIUS) - z[0]) + C(VERTICAL_DAMPING) * rhov;
    fz0 = C(LFZO) * C(FNOMIN);
    ratio = fz / fz0;
    re = C(UNLOADED_RADIUS) -
         fz0 / C(VERTICAL_STIFFNESS) * (C(DREFF) * atan(C(BREFF) * ratio) + C(FREFF) * ratio);
    spin[i] = maggi_dot(v, T) / (re * (b[body][3] * u[0] + b[body][4] * u[1] + b[body][5] * u[2]));
  }
}
