/* Mechanisms whose equations fit on a page, derived by hand: planar four-bar, slider-crank with an
 * offset, physical pendulum.
 *
 * A planar mechanism with one degree of freedom theta has
 *
 *   I(theta) theta'' + I'(theta) theta'^2 / 2 + V'(theta) = 0,   I = sum m k_c^2 + J k^2
 *
 * where k are the rates of angles and centres of gravity for theta' = 1, in closed form with their
 * derivatives by theta.  Joint forces follow body by body from Newton's and Euler's equations.
 * e(x) = (cos x, sin x), n(x) = (-sin x, cos x); gravity along -y, axes along z.
 */
#include <gsl/gsl_sf_ellint.h>

#include "fixture.h"

static const double g = 9.81;

/* a body in the plane: place of its centre of gravity and angle, first and second derivatives by
 * theta */
typedef struct body {
  double m, J;
  double c[2], k[2], dk[2]; /* centre of gravity: place, dc/dtheta, d2c/dtheta2 */
  double kw, dkw;           /* angle: derivatives */
} body;

/* adds length r at angle x with the rates k, dk of the angle */
static void add_link(body *b, double r, double x, double k, double dk)
{
  b->c[0] += r * cos(x);
  b->c[1] += r * sin(x);
  b->k[0] -= r * sin(x) * k;
  b->k[1] += r * cos(x) * k;
  b->dk[0] -= r * (cos(x) * k * k + sin(x) * dk);
  b->dk[1] += r * (-sin(x) * k * k + cos(x) * dk);
}

/* theta'' of the equation above */
static double acceleration(const body *b, int n, double rate)
{
  double I = 0.0, half = 0.0, dV = 0.0;
  int i;

  for (i = 0; i < n; ++i) {
    I += b[i].m * (b[i].k[0] * b[i].k[0] + b[i].k[1] * b[i].k[1]) + b[i].J * b[i].kw * b[i].kw;
    half +=
        b[i].m * (b[i].k[0] * b[i].dk[0] + b[i].k[1] * b[i].dk[1]) + b[i].J * b[i].kw * b[i].dkw;
    dV += b[i].m * g * b[i].k[1];
  }
  return -(half * rate * rate + dV) / I;
}

/* m (c'' - g) and J x'' */
static void inertia(const body *b, double rate, double acc, double f[2], double *moment)
{
  f[0] = b->m * (b->k[0] * acc + b->dk[0] * rate * rate);
  f[1] = b->m * (b->k[1] * acc + b->dk[1] * rate * rate + g);
  *moment = b->J * (b->kw * acc + b->dkw * rate * rate);
}

static double cross2(double ax, double ay, double bx, double by)
{
  return ax * by - ay * bx;
}

static void check_plane(const double w[6], double fx, double fy, double size)
{
  CHECK_NEAR(w[0], fx, 0.0, 1e-12 * size);
  CHECK_NEAR(w[1], fy, 0.0, 1e-12 * size);
  CHECK_NEAR(w[2], 0.0, 0.0, 1e-13 * size);
  CHECK_NEAR(w[5], 0.0, 0.0, 1e-12 * size);
}

/* ------------------------------------------------------------------------------------- four-bar */

/* crank a, coupler b, follower c, ground from (0, 0) to (dx, dy); centres of gravity at (radius,
 * angle) from the first end of each link, off its line */
typedef struct four_bar {
  double a, b, c, dx, dy;
  double r[3], off[3], m[3], J[3];
} four_bar;

/* follower angle on the branch `side` for the angle theta: from the triangle of the diagonal */
static void four_bar_angles(const four_bar *f, double theta, double side, double *phi, double *psi)
{
  double ex = f->a * cos(theta) - f->dx, ey = f->a * sin(theta) - f->dy, l = hypot(ex, ey);

  *psi = atan2(ey, ex) + side * acos((l * l + f->c * f->c - f->b * f->b) / (2.0 * l * f->c));
  *phi = atan2(f->c * sin(*psi) - ey, f->c * cos(*psi) - ex);
}

static void four_bar_bodies(const four_bar *f, double theta, double phi, double psi, body b[3])
{
  double kf, kp, dkf, dkp, s = sin(psi - phi), ds;
  int i;

  /* a e(theta) + b e(phi) = d + c e(psi), times e(phi) and e(psi) */
  kp = f->a * sin(theta - phi) / (f->c * s);
  kf = f->a * sin(theta - psi) / (f->b * s);
  ds = cos(psi - phi) * (kp - kf) / s;
  dkp = f->a * cos(theta - phi) * (1.0 - kf) / (f->c * s) - kp * ds;
  dkf = f->a * cos(theta - psi) * (1.0 - kp) / (f->b * s) - kf * ds;
  memset(b, 0, 3 * sizeof *b);
  for (i = 0; i < 3; ++i) {
    b[i].m = f->m[i];
    b[i].J = f->J[i];
  }
  add_link(&b[0], f->r[0], theta + f->off[0], 1.0, 0.0);
  add_link(&b[1], f->a, theta, 1.0, 0.0);
  add_link(&b[1], f->r[1], phi + f->off[1], kf, dkf);
  b[2].c[0] = f->dx;
  b[2].c[1] = f->dy;
  add_link(&b[2], f->r[2], psi + f->off[2], kp, dkp);
  b[0].kw = 1.0;
  b[1].kw = kf;
  b[1].dkw = dkf;
  b[2].kw = kp;
  b[2].dkw = dkp;
}

static void four_bar_check(const four_bar *f, const maggi_model *m, maggi_data *d, double theta0,
                           double phi0, double psi0, double side)
{
  test_state s = test_get(d);
  body b[3];
  double theta = theta0 + s.q[0], phi, psi, acc, rate = s.v[0], F[3][2], M[3], w[3][6], lambda[6];
  double bx, by, cx, cy, det, r1, r2, FB[2], FA[2], size;
  int i;

  four_bar_angles(f, theta, side, &phi, &psi);
  /* the coordinates: coupler relative to crank */
  CHECK_NEAR(cos(phi0 + s.q[0] + s.q[1] - phi), 1.0, 0.0, 1e-15);
  CHECK_NEAR(sin(phi0 + s.q[0] + s.q[1] - phi), 0.0, 0.0, 1e-12);
  CHECK_NEAR(sin(psi0 + s.q[2] - psi), 0.0, 0.0, 1e-12);
  four_bar_bodies(f, theta, phi, psi, b);
  CHECK_NEAR(s.v[0] + s.v[1], b[1].kw * rate, 1e-12, 1e-12);
  CHECK_NEAR(s.v[2], b[2].kw * rate, 1e-12, 1e-12);
  acc = acceleration(b, 3, rate);
  CHECK_NEAR(s.a[0], acc, 1e-11, 1e-11);
  CHECK_NEAR(s.a[0] + s.a[1], b[1].kw * acc + b[1].dkw * rate * rate, 1e-11, 1e-11);
  CHECK_NEAR(s.a[2], b[2].kw * acc + b[2].dkw * rate * rate, 1e-11, 1e-11);

  size = 1.0;
  for (i = 0; i < 3; ++i) {
    inertia(&b[i], rate, acc, F[i], &M[i]);
    size += fabs(F[i][0]) + fabs(F[i][1]);
  }
  /* moments of coupler about A and of follower about D, FB is the force on the coupler at B:
   *   (B - A) x FB = M1 + (C1 - A) x F1,   - (B - D) x FB = M2 + (C2 - D) x F2 */
  bx = f->b * cos(phi);
  by = f->b * sin(phi);
  cx = f->c * cos(psi);
  cy = f->c * sin(psi);
  r1 =
      M[1] + cross2(b[1].c[0] - f->a * cos(theta), b[1].c[1] - f->a * sin(theta), F[1][0], F[1][1]);
  r2 = -M[2] - cross2(b[2].c[0] - f->dx, b[2].c[1] - f->dy, F[2][0], F[2][1]);
  det = -by * cx + bx * cy;
  FB[0] = (r1 * cx - bx * r2) / det;
  FB[1] = (-by * r2 + cy * r1) / det;
  FA[0] = F[1][0] - FB[0];
  FA[1] = F[1][1] - FB[1];
  size += fabs(FB[0]) + fabs(FB[1]);
  maggi_get_reactions(d, &w[0][0]);
  maggi_get_multipliers(d, lambda);
  check_plane(w[1], FA[0], FA[1], 10.0 * size);
  check_plane(w[0], F[0][0] + FA[0], F[0][1] + FA[1], 10.0 * size);
  check_plane(w[2], F[2][0] + FB[0], F[2][1] + FB[1], 10.0 * size);
  CHECK_NEAR(lambda[0], -FB[0], 0.0, 1e-11 * size); /* on body_b */
  CHECK_NEAR(lambda[1], -FB[1], 0.0, 1e-11 * size);
  CHECK(maggi_body_find(m, "follower") == 2);
}

static void test_four_bar(const four_bar *f, double theta0, double side, double rate, double time)
{
  maggi_model *m;
  maggi_data *d;
  double phi, psi, bx, by;
  int i;

  four_bar_angles(f, theta0, side, &phi, &psi);
  bx = f->a * cos(theta0) + f->b * cos(phi);
  by = f->a * sin(theta0) + f->b * sin(phi);
  m = test_model(
      "gravity: [0, -9.81, 0]\n"
      "bodies:\n"
      "- {name: crank, mass: %.17g, cog: [%.17g, %.17g, 0], inertia: {xx: 9, yy: 9, zz: %.17g},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1], velocity: %.17g}}\n"
      "- {name: coupler, parent: crank, mass: %.17g, cog: [%.17g, %.17g, 0],"
      " inertia: {xx: 9, yy: 9, zz: %.17g},"
      " joint: {type: revolute, point: [%.17g, %.17g, 0], axis: [0, 0, 1]}}\n"
      "- {name: follower, mass: %.17g, cog: [%.17g, %.17g, 0], inertia: {xx: 9, yy: 9, zz: %.17g},"
      " joint: {type: revolute, point: [%.17g, %.17g, 0], axis: [0, 0, 1]}}\n"
      "loops: [{name: l, type: revolute, body_a: coupler, body_b: follower,"
      " point: [%.17g, %.17g, 0], axis: [0, 0, 1]}]\n",
      f->m[0], f->r[0] * cos(theta0 + f->off[0]), f->r[0] * sin(theta0 + f->off[0]), f->J[0], rate,
      f->m[1], f->a * cos(theta0) + f->r[1] * cos(phi + f->off[1]),
      f->a * sin(theta0) + f->r[1] * sin(phi + f->off[1]), f->J[1], f->a * cos(theta0),
      f->a * sin(theta0), f->m[2], f->dx + f->r[2] * cos(psi + f->off[2]),
      f->dy + f->r[2] * sin(psi + f->off[2]), f->J[2], f->dx, f->dy, bx, by);
  d = test_start(m);
  CHECK(maggi_data_set_tolerance(d, 1e-14) == MAGGI_OK);
  CHECK(test_loops(d).dof == 1 && test_loops(d).rank == 2);
  for (i = 0; i < 100; ++i) {
    four_bar_check(f, m, d, theta0, phi, psi, side);
    test_step(d, time / 1000.0, 10);
  }
  test_free(d, m);
}

/* --------------------------------------------------------------------------------- slider-crank */

/* crank r, rod l to a slider on the line y = e; centres of gravity as above */
static void test_slider_crank(double theta0, double rate, double time)
{
  const double r = 0.4, l = 1.1, e = 0.15, m[3] = {1.3, 0.9, 2.1}, J[2] = {0.05, 0.12};
  const double rc = 0.17, oc = 0.3, rr = 0.6, oro = -0.2;
  double phi0 = asin((e - r * sin(theta0)) / l), s0 = r * cos(theta0) + l * cos(phi0);
  maggi_model *model = test_model(
      "gravity: [0, -9.81, 0]\n"
      "bodies:\n"
      "- {name: crank, mass: %.17g, cog: [%.17g, %.17g, 0], inertia: {xx: 9, yy: 9, zz: %.17g},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1], velocity: %.17g}}\n"
      "- {name: rod, parent: crank, mass: %.17g, cog: [%.17g, %.17g, 0],"
      " inertia: {xx: 9, yy: 9, zz: %.17g},"
      " joint: {type: revolute, point: [%.17g, %.17g, 0], axis: [0, 0, 1]}}\n"
      "- {name: slider, mass: %.17g, cog: [%.17g, %.17g, 0],"
      " joint: {type: prismatic, point: [%.17g, %.17g, 0], axis: [1, 0, 0]}}\n"
      "loops: [{name: pin, type: revolute, body_a: rod, body_b: slider,"
      " point: [%.17g, %.17g, 0], axis: [0, 0, 1]}]\n",
      m[0], rc * cos(theta0 + oc), rc * sin(theta0 + oc), J[0], rate, m[1],
      r * cos(theta0) + rr * cos(phi0 + oro), r * sin(theta0) + rr * sin(phi0 + oro), J[1],
      r * cos(theta0), r * sin(theta0), m[2], s0, e, s0, e, s0, e);
  maggi_data *d = test_start(model);
  test_state s;
  body b[3];
  double theta, phi, kf, dkf, ks, dks, acc, F[3][2], M[3], P[2], FA[2], w[3][6], lambda[6], size;
  double R, v;
  int i, n;

  CHECK(maggi_data_set_tolerance(d, 1e-14) == MAGGI_OK);
  for (n = 0; n < 100; ++n) {
    s = test_get(d);
    theta = theta0 + s.q[0];
    phi = asin((e - r * sin(theta)) / l);
    /* r e(theta) + l e(phi) = (s, e): y and x components, and their derivatives */
    kf = -r * cos(theta) / (l * cos(phi));
    dkf = (r * sin(theta) + l * sin(phi) * kf * kf) / (l * cos(phi));
    ks = -r * sin(theta) - l * sin(phi) * kf;
    dks = -r * cos(theta) - l * cos(phi) * kf * kf - l * sin(phi) * dkf;
    memset(b, 0, sizeof b);
    add_link(&b[0], rc, theta + oc, 1.0, 0.0);
    add_link(&b[1], r, theta, 1.0, 0.0);
    add_link(&b[1], rr, phi + oro, kf, dkf);
    b[0].kw = 1.0;
    b[1].kw = kf;
    b[1].dkw = dkf;
    b[2].k[0] = ks;
    b[2].dk[0] = dks;
    for (i = 0; i < 3; ++i) {
      b[i].m = m[i];
      b[i].J = i < 2 ? J[i] : 0.0;
    }
    v = s.v[0];
    acc = acceleration(b, 3, v);
    CHECK_NEAR(s.q[2] + s0, r * cos(theta) + l * cos(phi), 1e-13, 0.0);
    CHECK_NEAR(s.q[0] + s.q[1], phi - phi0, 0.0, 1e-13);
    CHECK_NEAR(s.v[2], ks * v, 1e-12, 1e-12);
    CHECK_NEAR(s.v[0] + s.v[1], kf * v, 1e-12, 1e-12);
    CHECK_NEAR(s.a[0], acc, 1e-11, 1e-11);
    CHECK_NEAR(s.a[2], ks * acc + dks * v * v, 1e-11, 1e-11);

    size = 1.0;
    for (i = 0; i < 3; ++i) {
      inertia(&b[i], v, acc, F[i], &M[i]);
      size += fabs(F[i][0]) + fabs(F[i][1]);
    }
    /* pin force P on the slider: Px from its motion, Py from moments of the rod about its crank
     * end,
     *   - (B - A) x P = M1 + (C1 - A) x F1 */
    P[0] = F[2][0];
    R = M[1] + cross2(b[1].c[0] - r * cos(theta), b[1].c[1] - r * sin(theta), F[1][0], F[1][1]);
    P[1] = (l * sin(phi) * P[0] - R) / (l * cos(phi));
    FA[0] = F[1][0] + P[0];
    FA[1] = F[1][1] + P[1];
    maggi_get_reactions(d, &w[0][0]);
    maggi_get_multipliers(d, lambda);
    check_plane(w[2], 0.0, F[2][1] - P[1], 10.0 * size);
    check_plane(w[1], FA[0], FA[1], 10.0 * size);
    check_plane(w[0], F[0][0] + FA[0], F[0][1] + FA[1], 10.0 * size);
    CHECK_NEAR(lambda[0], P[0], 0.0, 1e-11 * size);
    CHECK_NEAR(lambda[1], P[1], 0.0, 1e-11 * size);
    test_step(d, time / 1000.0, 10);
  }
  test_free(d, model);
}

/* ------------------------------------------------------------------------------------- pendulum */

/* time of the first passage through the rest position, found by Newton with steps of any length */
static double quarter(maggi_data *d)
{
  double h = 1e-3;
  test_state s;
  int i;

  do {
    test_step(d, h, 1);
    s = test_get(d);
  } while (s.q[0] > 0.0 && check_failed == 0);
  for (i = 0; i < 4; ++i) {
    s = test_get(d);
    if (s.q[0] == 0.0) break;
    test_step(d, -s.q[0] / s.v[0], 1);
  }
  CHECK_NEAR(test_get(d).q[0], 0.0, 0.0, 1e-15);
  return maggi_get_time(d);
}

/* T = 4 sqrt(J / m g l) K(sin(phi0/2)); the axis is inclined by beta, which leaves g cos(beta) */
static void test_pendulum(double phi0)
{
  const double beta = 0.3, l = 0.7, m = 1.7, J = 0.4;
  maggi_model *model = test_model(
      "bodies: [{name: p, mass: %.17g, cog: [0, 0, %.17g], inertia: {xx: %.17g, yy: %.17g},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [3, 0, 0], position: %.17g}}]\n"
      "gravity: [%.17g, 0, %.17g]\n",
      m, -l, J, J, phi0, g * sin(beta), -g * cos(beta));
  maggi_data *d = test_start(model);

  CHECK_NEAR(quarter(d),
             sqrt((J + m * l * l) / (m * g * cos(beta) * l)) *
                 gsl_sf_ellint_Kcomp(sin(0.5 * phi0), GSL_PREC_DOUBLE),
             2e-12, 0.0);
  test_free(d, model);
}

int main(void)
{
  /* crank-rocker, double crank, double rocker, of generic lengths; the last turns back and so
   * passes positions where the crank is the wrong coordinate */
  static const four_bar rocker = {0.4,
                                  1.3,
                                  0.9,
                                  1.1,
                                  0.2,
                                  {0.15, 0.7, 0.4},
                                  {0.3, -0.2, 0.5},
                                  {1.1, 1.7, 0.8},
                                  {0.1, 0.3, 0.2}};
  static const four_bar cranks = {1.0,
                                  0.9,
                                  1.1,
                                  0.35,
                                  -0.1,
                                  {0.4, 0.5, 0.6},
                                  {-0.4, 0.1, 0.2},
                                  {0.9, 0.6, 1.4},
                                  {0.2, 0.1, 0.3}};
  static const four_bar rockers = {
      0.9, 0.5, 1.0, 1.4, 0.1, {0.5, 0.2, 0.5}, {0.1, 0.4, -0.3}, {1.0, 0.7, 1.2}, {0.2, 0.1, 0.1}};

  test_four_bar(&rocker, 0.7, 1.0, 6.0, 3.0);
  test_four_bar(&rocker, 2.1, -1.0, -3.0, 3.0);
  test_four_bar(&cranks, 1.2, 1.0, 5.0, 2.0);
  test_four_bar(&cranks, 1.2, -1.0, 0.0, 1.0);
  test_four_bar(&rockers, 1.1, -1.0, 0.3, 0.3);
  test_slider_crank(0.6, 9.0, 3.0);
  test_slider_crank(-1.0, 0.0, 3.0);
  test_pendulum(1e-3);
  test_pendulum(0.5);
  test_pendulum(2.0);
  test_pendulum(3.1);
  return check_done();
}
