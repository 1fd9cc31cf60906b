/* core/kernel/mass.c, island.c: the reduced mass matrix from kinetic energies, R_z from the loops,
 * accelerations and drives from Lagrange's equations. */
#include "data.h"
#include "fixture.h"

/* a tree with branches, rods and loops: 13 coordinates of which one is guided */
static const char mechanism[] =
    "gravity: [0.5, -1, -9]\n"
    "bodies:\n"
    "- {name: a, mass: 1.1, cog: [0.2, 0.1, 0.4], inertia: {xx: 0.2, yy: 0.3, zz: 0.25, xy: 0.02},"
    " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0.3, 0]}}\n"
    "- {name: b, parent: a, mass: 0.7, cog: [0, 0.9, 0.2], inertia: {xx: 0.1, yy: 0.12, zz: 0.08},"
    " joint: {type: universal, point: [0, 0.5, 0.3], axis: [0, 0.2, 1], axis2: [1, 0, 0]}}\n"
    "- {name: c, parent: b, mass: 0.4, cog: [0.3, 1.2, 0.1], inertia: {xx: 0.1, yy: 0.1, zz: 0.1},"
    " joint: {type: spherical, point: [0.1, 1, 0.2]}}\n"
    "- {name: e, parent: a, mass: 0.9, bar: {from: [0.5, 0, 0], to: [1, 0.8, 0.3]},"
    " joint: {type: revolute, point: [0.5, 0, 0], axis: [0, 0.1, 1]}}\n"
    "- {name: f, mass: 1.4, cog: [1.5, 0.5, 0], inertia: {xx: 0.3, yy: 0.3, zz: 0.4},"
    " joint: {type: planar, point: [1.5, 0.5, 0], axis: [0, 0, 1]}}\n"
    "- {name: g, parent: f, mass: 0.3, cog: [1.5, 1, 0.3], inertia: {xx: 0.1, yy: 0.1, zz: 0.1},"
    " joint: {type: prismatic, point: [1.5, 1, 0], axis: [0, 1, 1], motion: wave}}\n"
    "- {name: h, parent: f, mass: 0.5, bar: {from: [2, 0.5, 0.1], to: [2, 1.5, 0.4]},"
    " joint: {type: cylindrical, point: [2, 0.5, 0.1], axis: [0, 0.2, 1]}}\n"
    "functions:\n"
    "- {name: wave, type: sine, amplitude: 0.2, omega: 3, phase: 0.5}\n";
static const char loops[] =
    "loops:\n"
    "- {name: l1, type: spherical, body_a: c, body_b: f, point: [1.1, 1.1, 0.1]}\n"
    "- {name: l2, type: cylindrical, body_a: e, body_b: h, point: [1.6, 1, 0.3],"
    " axis: [1, 0.3, 0.1]}\n"
    "rods:\n"
    "- {name: r1, body_a: e, body_b: g, point_a: [1, 0.8, 0.3], point_b: [1.5, 1.2, 0.5],"
    " mass: 0.6}\n";
/* rods couple branches without a loop equation: their mass is the parameter here */
static const char rods[] =
    "rods:\n"
    "- {name: r1, body_a: c, body_b: e, point_a: [0.2, 1, 0.2], point_b: [1, 0.8, 0.3],"
    " mass: 0.8}\n"
    "- {name: r2, body_a: b, body_b: ground, point_a: [0, 0.8, 0.2], point_b: [0, 1.5, 1],"
    " mass: 0.5}\n"
    "- {name: r3, body_a: h, body_b: f, point_a: [2, 1.5, 0.4], point_b: [1.5, 0.5, 1],"
    " mass: 0.9}\n";

enum { NQ = 13, GUIDED = 10 };

/* independent coordinates as bits */
static unsigned independent(const maggi_data *d)
{
  unsigned bits = 0;
  int i;

  for (i = 0; i < NQ; ++i) bits |= maggi_coordinate_is_independent(d, i) ? 1u << i : 0u;
  return bits;
}

static maggi_energy energy_at(maggi_data *d, const double *q, const double *v)
{
  maggi_energy e;

  CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
  maggi_get_energy(d, &e);
  return e;
}

static double kinetic(maggi_data *d, const double *q, const double *v)
{
  return energy_at(d, q, v).kinetic;
}

/* internal number of a coordinate */
static int internal(const maggi_model *m, int i)
{
  return m->coordinate[i].q;
}

/* T = v M v / 2 of the whole tree: by polarisation M_ij = T(e_i + e_j) - T(e_i) - T(e_j); against
 * the list of pairs of the library */
static void test_tree(void)
{
  maggi_model *m = test_model("%s", mechanism);
  maggi_data *d;
  double q[NQ], v[NQ] = {0}, M[NQ][NQ], T[NQ], x;
  unsigned long long seed = 5;
  int i, j, k;

  d = test_data(m);
  CHECK(test_coordinates(m) == NQ && maggi_coordinate_is_guided(m, GUIDED));
  CHECK(test_set(m, d, "functions.wave.amplitude", 0.0)); /* the guide stands still */
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  for (i = 0; i < NQ; ++i) q[i] = i == GUIDED ? 0.0 : random11(&seed);
  for (i = 0; i < NQ; ++i) {
    v[i] = 1.0;
    T[i] = kinetic(d, q, v);
    for (j = 0; j < i; ++j) {
      v[j] = 1.0;
      M[i][j] = M[j][i] = kinetic(d, q, v) - T[i] - T[j];
      v[j] = 0.0;
    }
    M[i][i] = 2.0 * T[i];
    v[i] = 0.0;
  }
  for (i = 0; i < NQ; ++i) {
    for (j = 0; j <= i; ++j) {
      if (i == GUIDED || j == GUIDED) continue;
      x = 0.0;
      for (k = 0; k < d->t.npair; ++k)
        if ((d->t.pairi[k] == internal(m, i) && d->t.pairj[k] == internal(m, j)) ||
            (d->t.pairi[k] == internal(m, j) && d->t.pairj[k] == internal(m, i)))
          x = d->M[k];
      CHECK_NEAR(x, M[i][j], 1e-12, 1e-13);
    }
  }
  test_free(d, m);
}

/* Lagrange's equations in the independent coordinates, from energies alone:
 *
 *   d/dt dT/dv_i - d(T - V)/dq_i = 0
 *
 * T is quadratic in v, so that dT/dv is exact by central differences; the others have errors of
 * h^2, extrapolated to h^4.  The library closes the loops; where it holds other coordinates than
 * at the state itself, the derivative is another one and the result NAN. */
static double momentum(maggi_data *d, const double *q, const double *v, int i, unsigned set)
{
  double w[NQ], l, r;

  memcpy(w, v, sizeof w);
  w[i] = v[i] + 0.5;
  r = kinetic(d, q, w);
  w[i] = v[i] - 0.5;
  l = kinetic(d, q, w);
  return independent(d) == set ? r - l : NAN;
}

static double lagrangian(maggi_data *d, const double *q, const double *v, unsigned set)
{
  maggi_energy e = energy_at(d, q, v);
  test_state s = test_get(d);
  int i;

  for (i = 0; i < NQ; ++i)
    if (set & 1u << i && s.q[i] != q[i]) return NAN;
  return independent(d) == set ? e.kinetic - e.potential : NAN;
}

static double lagrange(maggi_data *d, const test_state *s, int i, double h, unsigned set)
{
  double q[NQ], v[NQ], p[2], l[2];
  int side, k;

  for (side = 0; side < 2; ++side) {
    for (k = 0; k < NQ; ++k) {
      q[k] = s->q[k] + h * s->v[k] + 0.5 * h * h * s->a[k];
      v[k] = s->v[k] + h * s->a[k];
    }
    p[side] = momentum(d, q, v, i, set);
    memcpy(q, s->q, sizeof q);
    q[i] += h;
    l[side] = lagrangian(d, q, s->v, set);
    h = -h;
  }
  return (p[0] - p[1]) / (2.0 * h) - (l[0] - l[1]) / (2.0 * h);
}

static void test_lagrange(const char *links, int dof)
{
  const double h = 5e-4;
  maggi_model *m = test_model("%s%s", mechanism, links);
  maggi_data *d = test_data(m);
  test_state s;
  double q[NQ] = {0}, v[NQ], residual;
  unsigned long long seed = 9;
  unsigned set;
  int i, n, checked = 0;

  CHECK(test_set(m, d, "functions.wave.amplitude", 0.0));
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK(test_loops(d).dof == dof);
  for (n = 0; n < 12; ++n) {
    for (i = 0; i < NQ; ++i) {
      q[i] = 0.2 * random11(&seed);
      v[i] = random11(&seed);
    }
    CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
    set = independent(d);
    s = test_get(d);
    for (i = 0; i < NQ; ++i) {
      if (!(set & 1u << i)) continue;
      residual = (4.0 * lagrange(d, &s, i, h, set) - lagrange(d, &s, i, 2.0 * h, set)) / 3.0;
      if (isnan(residual)) continue;
      ++checked;
      CHECK_NEAR(residual, 0.0, 0.0, 1e-7);
    }
  }
  CHECK(checked >= 3 * dof);
  test_free(d, m);
}

/* Phi_z R_z = 0, and R_z is the identity on the independent coordinates */
static void test_null_space(void)
{
  maggi_model *m = test_model("%s%s", mechanism, loops);
  maggi_data *d = test_start(m);
  const maggi_topo *t = &d->t;
  double e[3], sum[16], size = 0.0;
  int c, i, k, j, n;

  CHECK(t->nrow == 8 && t->ndep == 8);
  for (c = 0; c < t->ncol; ++c) {
    memset(sum, 0, sizeof sum);
    for (i = 0; i < t->nprim; ++i) {
      n = t->primkind[i] == MAGGI_PRIM_POINT || t->primkind[i] == MAGGI_PRIM_AXIS ? 3 : 1;
      for (k = t->pathadr[t->primloop[i]]; k < t->pathadr[t->primloop[i] + 1]; ++k) {
        maggi_prim_entry(t->primkind[i], t->pathside[k], d->prim0[i], d->b[t->qbody[t->pathq[k]]],
                         d->r[t->primpa[i]], d->r[t->primpb[i]], d->dir[t->primda[i]],
                         d->dir[t->primdb[i]], e);
        for (j = 0; j < n; ++j) {
          sum[t->primrow[i] + j] += e[j] * d->R[t->pathq[k] * t->stride + c];
          size += fabs(e[j] * d->R[t->pathq[k] * t->stride + c]);
        }
      }
    }
    for (i = 0; i < t->nrow; ++i) CHECK_NEAR(sum[i], 0.0, 0.0, 1e-14);
    for (i = 0; i < t->ncol; ++i) CHECK(d->R[t->colq[i] * t->stride + c] == (i == c));
  }
  CHECK(size > 1.0);
  test_free(d, m);
}

/* a guided pendulum: torque J theta'' + m g l sin(theta); a cart drives it, force (m + M) x'' .. */
static void test_drives(void)
{
  maggi_model *m = test_model(
      "gravity: [0, 0, -9.81]\n"
      "bodies:\n"
      "- {name: cart, mass: 3, joint: {type: prismatic, axis: [0, 1, 0], motion: x}}\n"
      "- {name: bob, parent: cart, mass: 2, cog: [0, 0, -0.5], inertia: {xx: 0.3, yy: 0.3},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0], motion: phi}}\n"
      "functions:\n"
      "- {name: x, type: sine, amplitude: 0.3, omega: 2}\n"
      "- {name: phi, type: sine, amplitude: 0.8, omega: 3, phase: 0.2}\n");
  maggi_data *d = test_start(m);
  double drive[2], t, x2, phi, phi1, phi2, l = 0.5;
  int i;

  for (i = 0; i < 20; ++i) {
    test_step(d, 0.05, 1);
    t = maggi_get_time(d);
    x2 = -1.2 * sin(2.0 * t);
    phi = 0.8 * sin(3.0 * t + 0.2);
    phi1 = 2.4 * cos(3.0 * t + 0.2);
    phi2 = -7.2 * sin(3.0 * t + 0.2);
    maggi_get_drives(d, drive);
    CHECK_NEAR(drive[1],
               (0.3 + 2.0 * l * l) * phi2 + 2.0 * l * cos(phi) * x2 + 2.0 * 9.81 * l * sin(phi),
               1e-13, 1e-13);
    CHECK_NEAR(drive[0], 5.0 * x2 + 2.0 * l * (cos(phi) * phi2 - sin(phi) * phi1 * phi1), 1e-13,
               1e-13);
  }
  test_free(d, m);
}

int main(void)
{
  test_tree();
  test_null_space();
  test_lagrange("", 12);
  test_lagrange(rods, 9);
  test_lagrange(loops, 4);
  test_drives();
  return check_done();
}
