/* The formula of a tyre: PAC2002 in steady state, pure and combined slip.
 *
 * Axes at the contact point: x along the line of the wheel plane on the road, z the road's normal, y to
 * the left.  Forces act on the wheel.
 *
 * [1] 3.4;  [2] H. B. Pacejka, Tyre and Vehicle Dynamics, 2002, 4.3;  [3] MSC Adams/Tire, PAC2002.
 */
#include "kernel.h"
#include "maggi/maggi.h"

#define C(name) p[adr + MAGGI_TYRE_##name]

/* a curve of pure slip,  d sin(c atan((1 - e) b x + e atan(b x))) + shift,  stiff = b c d */
enum { PEAK, SHAPE, BEND, STIFF, SLIP, SHIFT };

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

/* C atan(y - E (y - atan(y))), without a difference where E is 1 */
static double curve(double c, double e, double y)
{
  return c * atan((1.0 - e) * y + e * atan(y));
}

/* its derivative by y */
static double curve_slope(double c, double e, double y)
{
  double z;

  z = (1.0 - e) * y + e * atan(y);
  return c * (1.0 - e + e / (1.0 + y * y)) / (1.0 + z * z);
}

/* cos(atan(x)) */
static double lean(double x)
{
  return 1.0 / sqrt(1.0 + x * x);
}

/* b of b c d */
static double factor(const double m[6])
{
  return m[STIFF] / (m[SHAPE] * m[PEAK]);
}

static double pure(const double m[6])
{
  return m[PEAK] * sin(curve(m[SHAPE], m[BEND], factor(m) * m[SLIP])) + m[SHIFT];
}

/* its derivative by the slip */
static double pure_slope(const double m[6])
{
  double b, y;

  b = factor(m);
  y = b * m[SLIP];
  return m[PEAK] * cos(curve(m[SHAPE], m[BEND], y)) * curve_slope(m[SHAPE], m[BEND], y) * b;
}

/* share that the other slip x leaves of a force of pure slip: 1 at x = 0 */
static double share(double b, double c, double e, double shift, double x)
{
  return cos(curve(c, e, b * (x + shift))) / cos(curve(c, e, b * shift));
}

/* its derivatives by x and by b */
static void share_slopes(double b, double c, double e, double shift, double x, double g[2])
{
  double y, y0, z, z0, s, n;

  y = b * (x + shift);
  y0 = b * shift;
  z = curve(c, e, y);
  z0 = curve(c, e, y0);
  n = cos(z0);
  s = -sin(z) * curve_slope(c, e, y) / n;
  g[0] = s * b;
  g[1] = s * (x + shift) + cos(z) * sin(z0) / (n * n) * curve_slope(c, e, y0) * shift;
}

static void longitudinal(int np, const double p[np], int adr, double fz, double dfz, double kappa,
                         double gamma, double m[6])
{
  double kx, gx, mux, e, ex;

  kx = kappa + (C(PHX1) + C(PHX2) * dfz) * C(LHX);
  gx = gamma * C(LGAX);
  mux = (C(PDX1) + C(PDX2) * dfz) * (1.0 - C(PDX3) * gx * gx) * C(LMUX);
  e = (C(PEX1) + (C(PEX2) + C(PEX3) * dfz) * dfz) * C(LEX);
  if (MAGGI_RE(kx) > 0.0)
    ex = at_most_1(e * (1.0 - C(PEX4)));
  else
    ex = at_most_1(e * (1.0 + C(PEX4)));
  m[PEAK] = mux * fz;
  m[SHAPE] = C(PCX1) * C(LCX);
  m[BEND] = ex;
  m[STIFF] = fz * (C(PKX1) + C(PKX2) * dfz) * exp(C(PKX3) * dfz) * C(LKX);
  m[SLIP] = kx;
  m[SHIFT] = fz * (C(PVX1) + C(PVX2) * dfz) * C(LVX) * C(LMUX);
}

/* sin(2 atan(z)) = 2 z / (1 + z^2) */
static void lateral(int np, const double p[np], int adr, double fz, double dfz, double a,
                    double gamma, double m[6])
{
  double fz0, gy, ay, muy, e, ey, z;

  fz0 = C(LFZO) * C(FNOMIN);
  gy = gamma * C(LGAY);
  ay = a + (C(PHY1) + C(PHY2) * dfz) * C(LHY) + C(PHY3) * gy;
  muy = (C(PDY1) + C(PDY2) * dfz) * (1.0 - C(PDY3) * gy * gy) * C(LMUY);
  e = (C(PEY1) + C(PEY2) * dfz) * C(LEY);
  if (MAGGI_RE(ay) > 0.0)
    ey = at_most_1(e * (1.0 - (C(PEY3) + C(PEY4) * gy)));
  else
    ey = at_most_1(e * (1.0 + (C(PEY3) + C(PEY4) * gy)));
  z = fz / (C(PKY2) * fz0);
  m[PEAK] = muy * fz;
  m[SHAPE] = C(PCY1) * C(LCY);
  m[BEND] = ey;
  m[STIFF] = C(PKY1) * fz0 * (2.0 * z / (1.0 + z * z)) *
             (1.0 - C(PKY3) * magnitude(gy, C(LOW_CAMBER))) * C(LKY);
  m[SLIP] = ay;
  m[SHIFT] = fz * ((C(PVY1) + C(PVY2) * dfz) * C(LVY) + (C(PVY3) + C(PVY4) * dfz) * gy) * C(LMUY);
}

/* what combined slip makes of the forces:  Fx = Gxa Fx0, Fy = Gyk Fy0 + SVyk.  g: b, c, e, shift of Gxa,
 * then of Gyk, SVyk */
static void combined(int np, const double p[np], int adr, double dfz, double kappa, double a,
                     double gamma, double peak, double g[9])
{
  double dv;

  g[0] = C(RBX1) * lean(C(RBX2) * kappa) * C(LXAL);
  g[1] = C(RCX1);
  g[2] = at_most_1(C(REX1) + C(REX2) * dfz);
  g[3] = C(RHX1);
  g[4] = C(RBY1) * lean(C(RBY2) * (a - C(RBY3))) * C(LYKA);
  g[5] = C(RCY1);
  g[6] = at_most_1(C(REY1) + C(REY2) * dfz);
  g[7] = C(RHY1) + C(RHY2) * dfz;
  dv = peak * (C(RVY1) + C(RVY2) * dfz + C(RVY3) * gamma) * lean(C(RVY4) * a);
  g[8] = dv * sin(C(RVY5) * atan(C(RVY6) * kappa)) * C(LVYKA);
}

/* trail t at the slip `at` and residual moment Mzr at `ar`, each with the part `ratio` of kappa:
 *   at_eq = sqrt(at^2 + ratio^2),  ar_eq likewise; sqrt has no derivative at 0, 1e-24 is added */
static void aligning(int np, const double p[np], int adr, double fz, double dfz, double a,
                     double gamma, double ratio, const double y[6], double f[2])
{
  double fz0, gz, at, ar, ateq, areq, scale, bt, dt, et, br, dr, ca;

  fz0 = C(LFZO) * C(FNOMIN);
  gz = gamma * C(LGAZ);
  at = a + C(QHZ1) + C(QHZ2) * dfz + (C(QHZ3) + C(QHZ4) * dfz) * gz;
  ar = y[SLIP] + y[SHIFT] / y[STIFF];
  ateq = sqrt(at * at + ratio * ratio + 1e-24);
  areq = sqrt(ar * ar + ratio * ratio + 1e-24);
  scale = C(LKY) / C(LMUY);
  bt = (C(QBZ1) + (C(QBZ2) + C(QBZ3) * dfz) * dfz) *
       (1.0 + C(QBZ4) * gz + C(QBZ5) * magnitude(gz, C(LOW_CAMBER))) * scale;
  dt = fz * (C(QDZ1) + C(QDZ2) * dfz) * (1.0 + (C(QDZ3) + C(QDZ4) * gz) * gz) *
       (C(UNLOADED_RADIUS) / fz0) * C(LTR);
  et = at_most_1(
      (C(QEZ1) + (C(QEZ2) + C(QEZ3) * dfz) * dfz) *
      (1.0 + (C(QEZ4) + C(QEZ5) * gz) * 0.63661977236758134308 * atan(bt * C(QCZ1) * at)));
  br = C(QBZ9) * scale + C(QBZ10) * y[STIFF] / y[PEAK];
  dr = fz * ((C(QDZ6) + C(QDZ7) * dfz) * C(LRES) + (C(QDZ8) + C(QDZ9) * dfz) * gz) *
       C(UNLOADED_RADIUS) * C(LMUY);
  ca = lean(a);
  f[0] = dt * cos(curve(C(QCZ1), et, bt * ateq)) * ca;
  f[1] = dr * lean(br * areq) * ca;
}

/* slip: kappa, tan(alpha), gamma, Fz > 0, Vx; f: Fx Fy Fz, Mx My Mz.  |Vx| is Vx tanh(Vx / low) */
void maggi_tyre(int adr, int np, const double p[np], const double slip[5], double f[6])
{
  double kappa, a, gamma, fz, fz0, r0, dfz, fx, fy, force, ratio, s, way, speed;
  double x[6], y[6], g[9], z[2];

  kappa = slip[0];
  a = slip[1];
  gamma = slip[2];
  fz = slip[3];
  fz0 = C(LFZO) * C(FNOMIN);
  r0 = C(UNLOADED_RADIUS);
  dfz = (fz - fz0) / fz0;
  longitudinal(np, p, adr, fz, dfz, kappa, gamma, x);
  lateral(np, p, adr, fz, dfz, a, gamma, y);
  combined(np, p, adr, dfz, kappa, a, gamma, y[PEAK], g);
  fx = pure(x) * share(g[0], g[1], g[2], g[3], a);
  fy = pure(y) * share(g[4], g[5], g[6], g[7], kappa);
  ratio = x[STIFF] * kappa / y[STIFF];
  aligning(np, p, adr, fz, dfz, a, gamma, ratio, y, z);
  force = fy + g[8];
  s = (C(SSZ1) + C(SSZ2) * force / fz0 + (C(SSZ3) + C(SSZ4) * dfz) * gamma) * r0 * C(LS);
  way = tanh(slip[4] / C(LOW_SPEED));
  speed = slip[4] / C(LONGVL);
  f[0] = fx;
  f[1] = force;
  f[2] = fz;
  f[3] = r0 * fz * (C(QSX1) * C(LVMX) + (-C(QSX2) * gamma + C(QSX3) * force / fz0) * C(LMX));
  f[4] = -way * r0 * fz *
         (C(QSY1) + C(QSY2) * fx / fz0 + C(QSY3) * way * speed +
          C(QSY4) * speed * speed * speed * speed) *
         C(LMY);
  f[5] = -z[0] * fy + z[1] + s * fx;
}

/* How the formula goes on at a slip, the same numbers as above:  dFy/dalpha, dFx/dkappa, and what part
 * of the grip is used,  sqrt((Fx / Dx)^2 + (Fy / Dy)^2),  D the peaks of pure slip at this load and
 * camber */
void maggi_tyre_slopes(int adr, int np, const double p[np], const double slip[5], double s[3])
{
  double kappa, a, gamma, fz, fz0, dfz, l, b, m, ka, v, fx, fy, gx, gy, ux, uy;
  double x[6], y[6], g[9], wx[2], wy[2];

  kappa = slip[0];
  a = slip[1];
  gamma = slip[2];
  fz = slip[3];
  fz0 = C(LFZO) * C(FNOMIN);
  dfz = (fz - fz0) / fz0;
  longitudinal(np, p, adr, fz, dfz, kappa, gamma, x);
  lateral(np, p, adr, fz, dfz, a, gamma, y);
  combined(np, p, adr, dfz, kappa, a, gamma, y[PEAK], g);
  gx = share(g[0], g[1], g[2], g[3], a);
  gy = share(g[4], g[5], g[6], g[7], kappa);
  share_slopes(g[0], g[1], g[2], g[3], a, wx);
  share_slopes(g[4], g[5], g[6], g[7], kappa, wy);
  fx = pure(x);
  fy = pure(y);

  /* b and the shift of Fy change with a by their cos(atan()) */
  l = C(RBY2) * lean(C(RBY2) * (a - C(RBY3)));
  v = C(RVY4) * lean(C(RVY4) * a);
  b = -g[4] * l * l * (a - C(RBY3));
  s[0] = (1.0 + a * a) * (gy * pure_slope(y) + fy * wy[1] * b - g[8] * v * v * a);
  m = C(RBX2) * lean(C(RBX2) * kappa);
  ka = -g[0] * m * m * kappa;
  s[1] = gx * pure_slope(x) + fx * wx[1] * ka;
  ux = fx * gx / x[PEAK];
  uy = (fy * gy + g[8]) / y[PEAK];
  s[2] = sqrt(ux * ux + uy * uy + 1e-24);
}
