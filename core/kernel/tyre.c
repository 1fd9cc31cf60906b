/* Wheels: where a tyre meets the road, its slip, and what it exerts.
 *
 * Axes at the contact point: x along the line of the wheel plane on the road, z the road's normal, y to
 * the left.  Forces act on the wheel.  `mirror` exchanges left and right. */
#include "kernel.h"
#include "maggi/maggi.h"

#define C(name) p[adr + MAGGI_TYRE_##name]

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
 * g: centre c from the point of the road.  arm: r e; z: r, u.n, |u × n|, slope that the plane lacks */
static void contact(int kind, int roadadr, int n, int spline, int np, const double p[np],
                    int nspline, const double spline0[nspline][3], const double u[3],
                    const double g[3], double arm[3], double T[3], double L[3], double N[3],
                    double z[4])
{
  int k;
  double x, s, c, w, r;
  double h0[3], h1[3], normal[3], un[3], along[3];

  maggi_road_height(kind, roadadr, n, spline, np, p, nspline, spline0, g[0], h0);
  x = g[0] + u[2] * u[0] / (u[0] * u[0] + u[1] * u[1]) * (g[2] - h0[0]);
  maggi_road_height(kind, roadadr, n, spline, np, p, nspline, spline0, x, h1);
  s = sqrt(1.0 + h1[1] * h1[1]);
  normal[0] = -h1[1] / s;
  normal[1] = 0.0;
  normal[2] = 1.0 / s;
  c = maggi_dot(u, normal);
  maggi_cross(u, normal, un);
  w = sqrt(maggi_dot(un, un));
  r = ((g[0] - x) * normal[0] + (g[2] - h1[0]) * normal[2]) / w;
  for (k = 0; k < 3; ++k) along[k] = un[k] / w;
  maggi_cross(normal, along, L);
  for (k = 0; k < 3; ++k) {
    arm[k] = r * (c * u[k] - normal[k]) / w;
    T[k] = along[k];
    N[k] = normal[k];
  }
  z[0] = r;
  z[1] = c;
  z[2] = w;
  z[3] = h1[2];
}

/* Re = R0 - rho0 (D atan(B rd) + F rd),  rd = Fz / Fz0,  rho0 = Fz0 / Cz;  R0 in the air */
static double rolling_radius(int np, const double p[np], int adr, double fz)
{
  double fz0, ratio, re;

  fz0 = C(LFZO) * C(FNOMIN);
  if (MAGGI_RE(fz) > 0.0) {
    ratio = fz / fz0;
    re = C(UNLOADED_RADIUS) -
         fz0 / C(VERTICAL_STIFFNESS) * (C(DREFF) * atan(C(BREFF) * ratio) + C(FREFF) * ratio);
  } else {
    re = C(UNLOADED_RADIUS);
  }
  return re;
}

/* the formula on either side; f: Fx Fy Fz, Mx My Mz */
static void grip_forces(int adr, int np, const double p[np], double side,
                        const double slip[MAGGI_SLIP_NUMBERS], double f[6])
{
  double one[5], force[6];

  one[0] = slip[MAGGI_SLIP_KAPPA];
  one[1] = side * slip[MAGGI_SLIP_TAN_ALPHA];
  one[2] = side * slip[MAGGI_SLIP_GAMMA];
  one[3] = slip[MAGGI_SLIP_FZ];
  one[4] = slip[MAGGI_SLIP_VX];
  maggi_tyre(adr, np, p, one, force);
  f[0] = force[0];
  f[1] = side * force[1];
  f[2] = force[2];
  f[3] = side * force[3];
  f[4] = force[4];
  f[5] = side * force[5];
}

/* Slip and forces of a wheel.  V is the velocity of the place on the road below the wheel, which the turn of
 * neither wheel nor carrier about the axis moves:
 *   Omega = w.u,  V = v_C + (w - Omega u) × r e,  rho = R0 - r,  rho' = -V.n / |u × n|
 *   Fz = Cz rho + Cd rho'
 *   kappa = -(V.t - Omega Re) / |V.t|,  tan(alpha) = V.l / |V.t|,  sin(gamma) = u.n
 * No force without contact; without grip that of the spring alone, as at rest. */
static void wheel(int adr, double side, int grip, int np, const double p[np], const double u[3],
                  const double Z[6], const double cv[3], const double arm[3], const double T[3],
                  const double L[3], const double N[3], const double z[4],
                  double slip[MAGGI_SLIP_NUMBERS], double f[6])
{
  int k;
  double re, fz, omega, vx, speed, rhov;
  double v[3], vr[3], wr[3];

  omega = Z[3] * u[0] + Z[4] * u[1] + Z[5] * u[2];
  for (k = 0; k < 3; ++k) wr[k] = Z[k + 3] - omega * u[k];
  maggi_cross(wr, arm, vr);
  for (k = 0; k < 3; ++k) v[k] = cv[k] + vr[k];
  vx = maggi_dot(v, T);
  rhov = (z[3] * v[0] - maggi_dot(v, N)) / z[2];
  fz = C(VERTICAL_STIFFNESS) * (C(UNLOADED_RADIUS) - z[0]) + C(VERTICAL_DAMPING) * rhov;
  re = rolling_radius(np, p, adr, fz);
  speed = at_least(vx, C(VXLOW));
  slip[MAGGI_SLIP_KAPPA] = (omega * re - vx) / speed;
  slip[MAGGI_SLIP_TAN_ALPHA] = maggi_dot(v, L) / speed;
  slip[MAGGI_SLIP_GAMMA] = atan2(z[1], z[2]);
  slip[MAGGI_SLIP_FZ] = fz;
  slip[MAGGI_SLIP_VX] = vx;
  slip[MAGGI_SLIP_RADIUS] = z[0];
  slip[MAGGI_SLIP_ROLLING] = re;
  if (MAGGI_RE(fz) > 0.0 && MAGGI_RE(z[0]) < MAGGI_RE(C(UNLOADED_RADIUS))) {
    if (grip) {
      grip_forces(adr, np, p, side, slip, f);
    } else {
      for (k = 0; k < 6; ++k) f[k] = k == 2 ? fz : 0.0;
    }
  } else {
    for (k = 0; k < 6; ++k) f[k] = 0.0;
  }
}

/* F: force f_x T + f_y L + f_z N at the contact point, with its moment, as one about P */
static void wrench(const double f[6], const double c[3], const double arm[3], const double T[3],
                   const double L[3], const double N[3], double F[6])
{
  int k;
  double r[3], force[3], moment[3];

  for (k = 0; k < 3; ++k) {
    r[k] = c[k] + arm[k];
    force[k] = f[0] * T[k] + f[1] * L[k] + f[2] * N[k];
  }
  maggi_cross(r, force, moment);
  for (k = 0; k < 3; ++k) {
    F[k] = force[k];
    F[k + 3] = moment[k] + f[3] * T[k] + f[4] * L[k] + f[5] * N[k];
  }
}

/* the unit axis u of wheel i, and where it meets its road */
static void stand(const maggi_topo *t, int i, const double p[t->np],
                  const double spline0[t->nspline][3], const double A[t->nbody + 1][9],
                  const double r[t->npoint][3], double u[3], double arm[3], double T[3],
                  double L[3], double N[3], double z[4])
{
  int k, road;
  double n;
  double axis[3], ua[3], g[3];

  road = t->wheelroad[i];
  for (k = 0; k < 3; ++k) axis[k] = p[t->wheelaxis[i] + k];
  maggi_mul(A[t->wheelbody[i]], axis, ua);
  n = sqrt(maggi_dot(ua, ua));
  for (k = 0; k < 3; ++k) u[k] = ua[k] / n;
  for (k = 0; k < 3; ++k) g[k] = r[t->wheelpoint[i]][k] - r[t->roadpoint[road]][k];
  contact(t->roadkind[road], t->roadadr[road], t->roadn[road], t->roadspline[road], t->np, p,
          t->nspline, spline0, u, g, arm, T, L, N, z);
}

/* slip: MAGGI_SLIP_..; f: Fx Fy Fz, Mx My Mz at the contact point, in its axes; F: the same at P */
void maggi_wheel_forces(const maggi_topo *t, const double p[t->np],
                        const double spline0[t->nspline][3], const double A[t->nbody + 1][9],
                        const double Z[t->nbody + 1][6], const double r[t->npoint][3],
                        const double rv[t->npoint][3], double slip[t->nwheel][MAGGI_SLIP_NUMBERS],
                        double f[t->nwheel][6], double F[t->nwheel][6])
{
  int i;
  double u[3], arm[3], T[3], L[3], N[3], z[4];

  for (i = 0; i < t->nwheel; ++i) {
    stand(t, i, p, spline0, A, r, u, arm, T, L, N, z);
    wheel(t->tyreadr[t->wheeltyre[i]], t->wheelmirror[i] ? -1.0 : 1.0, t->wheelgrip[i], t->np, p, u,
          Z[t->wheelbody[i]], rv[t->wheelpoint[i]], arm, T, L, N, z, slip[i], f[i]);
    wrench(f[i], r[t->wheelpoint[i]], arm, T, L, N, F[i]);
  }
}

/* Rates of the coordinates on which wheels turn at which they roll freely, kappa = 0: with w that of the
 * carrier and w_q that of the wheel on it at the rate 1
 *   v = (V.t / Re - w.u) / (w_q.u) */
void maggi_rolling(const maggi_topo *t, const double p[t->np], const double spline0[t->nspline][3],
                   const double A[t->nbody + 1][9], const double b[t->nbody][6],
                   const double r[t->npoint][3], const double Z[t->nbody + 1][6],
                   double spin[t->nwheel])
{
  int i, k, adr, body, carrier;
  double turn, fz, rhov, re;
  double u[3], arm[3], T[3], L[3], N[3], z[4], w[3], vc[3], vr[3], v[3], wr[3];

  for (i = 0; i < t->nwheel; ++i) {
    adr = t->tyreadr[t->wheeltyre[i]];
    body = t->wheelbody[i];
    carrier = t->wheelcarrier[i];
    stand(t, i, p, spline0, A, r, u, arm, T, L, N, z);
    for (k = 0; k < 3; ++k) w[k] = Z[carrier][k + 3];
    turn = maggi_dot(w, u);
    for (k = 0; k < 3; ++k) wr[k] = w[k] - turn * u[k];
    maggi_cross(w, r[t->wheelpoint[i]], vc);
    maggi_cross(wr, arm, vr);
    for (k = 0; k < 3; ++k) v[k] = Z[carrier][k] + vc[k] + vr[k];
    rhov = (z[3] * v[0] - maggi_dot(v, N)) / z[2];
    fz = C(VERTICAL_STIFFNESS) * (C(UNLOADED_RADIUS) - z[0]) + C(VERTICAL_DAMPING) * rhov;
    re = rolling_radius(t->np, p, adr, fz);
    spin[i] =
        (maggi_dot(v, T) / re - turn) / (b[body][3] * u[0] + b[body][4] * u[1] + b[body][5] * u[2]);
  }
}
