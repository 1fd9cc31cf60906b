/* core/kernel/loop.c: equations of each kind of loop, their rates, entries and right-hand side.
 *
 * Two arms of three joints in general position are joined at their ends.  The coordinates are put
 * anywhere, with the loop wide open: the formulas must hold there too. */
#include "data.h"
#include "fixture.h"

static const char *const kinds[] = {
    "loops:\n- {name: l, type: spherical, body_a: a3, body_b: b3, point: [0.5, 1, 0.2]}\n",
    "loops:\n- {name: l, type: revolute, body_a: a3, body_b: b3, point: [0.5, 1, 0.2],"
    " axis: [1, 2, -1]}\n",
    "loops:\n- {name: l, type: universal, body_a: a3, body_b: b3, point: [0.5, 1, 0.2],"
    " axis_a: [1, 2, -1], axis_b: [0.3, -1, 0.2]}\n",
    "loops:\n- {name: l, type: cylindrical, body_a: a3, body_b: b3, point: [0.5, 1, 0.2],"
    " axis: [1, 2, -1]}\n",
    "loops:\n- {name: l, type: prismatic, body_a: a3, body_b: b3, point: [0.5, 1, 0.2],"
    " axis: [1, 2, -1]}\n",
    "rods:\n- {name: l, body_a: a3, body_b: b3, point_a: [0.5, 1, 0.2], point_b: [0.8, 1.5, 0],"
    " mass: 0.7}\n",
    /* one side is the parent of the other's branch, and one is the ground */
    "loops:\n- {name: l, type: revolute, body_a: a1, body_b: b3, point: [0.5, 1, 0.2],"
    " axis: [1, 2, -1]}\n",
    "loops:\n- {name: l, type: universal, body_a: b3, body_b: ground, point: [0.5, 1, 0.2],"
    " axis_a: [1, 2, -1], axis_b: [0.3, -1, 0.2]}\n",
    "loops:\n- {name: l, type: point_plane, body_a: a3, body_b: b3, point: [0.5, 1, 0.2],"
    " axis: [1, 2, -1]}\n",
    "loops:\n- {name: l, type: point_plane, body_a: b3, body_b: a1, point_a: [0.5, 1, 0.2],"
    " point_b: [0.7, 0.8, 0.1], axis: [2, 1, 2]}\n",
};
enum { KINDS = sizeof kinds / sizeof *kinds };
static const int rows[KINDS] = {3, 6, 4, 4, 5, 1, 6, 4, 1, 1};

static maggi_model *model(int kind)
{
  return test_model(
      "bodies:\n"
      "- {name: a1, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0.2, 0]}}\n"
      "- {name: a2, parent: a1, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: prismatic, point: [0, 0.3, 0], axis: [0.5, 1, 1]}}\n"
      "- {name: a3, parent: a2, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: spherical, point: [0.2, 0.6, 0.1]}}\n"
      "- {name: b1, parent: a1, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: universal, point: [1, 0, 0], axis: [0, 1, 0.4], axis2: [1, 0, 1]}}\n"
      "- {name: b2, parent: b1, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: revolute, point: [1, 0.3, 0], axis: [0.1, 0.4, 1]}}\n"
      "- {name: b3, parent: b2, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: cylindrical, point: [0.8, 0.6, 0.1], axis: [1, -1, 0.3]}}\n"
      "%s",
      kinds[kind]);
}

static void residual(maggi_data *d, const double *q, double *res)
{
  memcpy(d->q, q, (size_t)d->t.nq * sizeof *q);
  maggi_evaluate_positions(d, 0.0);
  memcpy(res, d->res, (size_t)d->t.nrow * sizeof *res);
}

/* the formulas of maggi.h with what the other kernels have computed */
static void test_residual(int kind, maggi_data *d)
{
  const maggi_topo *t = &d->t;
  double e[3], x, expected;
  int i, k, p;

  CHECK(t->nrow == rows[kind]);
  for (i = 0; i < t->nprim; ++i) {
    p = t->primkind[i];
    for (k = 0; k < 3; ++k) e[k] = d->r[t->primpa[i]][k] - d->r[t->primpb[i]][k];
    if (p == MAGGI_PRIM_POINT || p == MAGGI_PRIM_AXIS) {
      for (k = 0; k < 3; ++k) {
        expected = p == MAGGI_PRIM_POINT ? e[k] : d->dir[t->primda[i]][k] - d->dir[t->primdb[i]][k];
        CHECK_NEAR(d->res[t->primrow[i] + k], expected, 0.0, 1e-15);
      }
      continue;
    }
    if (p == MAGGI_PRIM_ROD) {
      x = sqrt(0.3 * 0.3 + 0.5 * 0.5 + 0.2 * 0.2);
      expected = (dot3(e, e) - x * x) / (2.0 * x);
    } else if (p == MAGGI_PRIM_PLANE) {
      expected = dot3(e, d->dir[t->primdb[i]]);
    } else {
      expected = dot3(d->dir[t->primda[i]], d->dir[t->primdb[i]]) -
                 dot3(d->dir0[t->primda[i]], d->dir0[t->primdb[i]]);
    }
    CHECK_NEAR(d->res[t->primrow[i]], expected, 1e-14, 2e-15);
  }
}

static int is_vector(const maggi_topo *t, int prim)
{
  return t->primkind[prim] == MAGGI_PRIM_POINT || t->primkind[prim] == MAGGI_PRIM_AXIS;
}

/* columns of Phi_z of a loop by the building blocks */
static void jacobian(const maggi_data *d, double phi[6][TEST_COORDINATES_MAX])
{
  const maggi_topo *t = &d->t;
  double e[3];
  int i, k, c;

  memset(phi, 0, 6 * sizeof *phi);
  for (i = 0; i < t->nprim; ++i)
    for (c = 0; c < t->pathadr[1]; ++c) {
      maggi_prim_entry(t->primkind[i], t->pathside[c], d->prim0[i], d->b[t->qbody[t->pathq[c]]],
                       d->r[t->primpa[i]], d->r[t->primpb[i]], d->dir[t->primda[i]],
                       d->dir[t->primdb[i]], e);
      for (k = 0; k < (is_vector(t, i) ? 3 : 1); ++k) phi[t->primrow[i] + k][t->pathq[c]] = e[k];
    }
}

/* A joint below both sides is not in the path: it turns an open vector, w x (r_a - r_b), and leaves
 * scalars and closed loops alone. */
static void add_carriers(const maggi_data *d, double phi[6][TEST_COORDINATES_MAX])
{
  const maggi_topo *t = &d->t;
  double e[3];
  int i, k, c;

  for (i = 0; i < t->nprim; ++i)
    for (k = t->loopcommon[0]; k < t->nbody && is_vector(t, i); k = t->parent[k]) {
      cross3(d->b[k] + 3, d->res + t->primrow[i], e);
      for (c = 0; c < 3; ++c) phi[t->primrow[i] + c][t->qid[k]] = e[c];
    }
}

/* all columns, those of coordinates outside the path as zeros */
static void test_entries(maggi_data *d, const double *q0)
{
  const double h = 1e-3;
  double phi[6][TEST_COORDINATES_MAX], q[TEST_COORDINATES_MAX];
  double l1[6], r1[6], l2[6], r2[6], f1, f2, e1 = 0.0, e2 = 0.0;
  int i, k;

  residual(d, q0, l1);
  jacobian(d, phi);
  add_carriers(d, phi);
  memcpy(q, q0, sizeof q);
  for (i = 0; i < d->t.nq; ++i) {
    q[i] = q0[i] - h;
    residual(d, q, l1);
    q[i] = q0[i] + h;
    residual(d, q, r1);
    q[i] = q0[i] - 2.0 * h;
    residual(d, q, l2);
    q[i] = q0[i] + 2.0 * h;
    residual(d, q, r2);
    q[i] = q0[i];
    for (k = 0; k < d->t.nrow; ++k) {
      f1 = (r1[k] - l1[k]) / (2.0 * h);
      f2 = (r2[k] - l2[k]) / (4.0 * h);
      e1 += fabs(f1 - phi[k][i]);
      e2 += fabs(f2 - phi[k][i]);
      /* order 4: h^4, and round-off 1e-16 / h */
      CHECK_NEAR((4.0 * f1 - f2) / 3.0, phi[k][i], 0.0, 5e-11);
    }
  }
  CHECK(e1 > 1e-9);
  CHECK_NEAR(e2 / e1, 4.0, 1e-3, 0.0);
}

/* the first derivative of the equations is Phi_z v, less what carriers do to open vectors */
static void test_rates(maggi_data *d, const double *q0, const double *v)
{
  double phi[6][TEST_COORDINATES_MAX], expected, res[6];
  const maggi_topo *t = &d->t;
  int i, k;

  residual(d, q0, res);
  jacobian(d, phi);
  maggi_velocities(t, d->p, (void *)d->b, v, d->Z, d->Z0);
  maggi_point_velocities(t, 0, t->npointdyn, (void *)d->r, (void *)d->Z, d->rv);
  maggi_loop_rates(t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->rv, (void *)d->Z, d->rate);
  for (k = 0; k < t->nrow; ++k) {
    expected = 0.0;
    for (i = 0; i < t->nq; ++i) expected += phi[k][i] * v[i];
    CHECK(fabs(expected) > 1e-4);
    CHECK_NEAR(d->rate[k], expected, 1e-13, 1e-14);
  }
}

/* along q0 + v t the second derivative of the equations is minus gamma, by two differences of
 * order 2: h^4, and round-off 1e-16 / h^2; less what the acceleration of carriers does to open
 * vectors */
static void test_gamma(maggi_data *d, const double *q0, const double *v)
{
  const double h = 4e-3;
  double q[TEST_COORDINATES_MAX], gam[6], res[5][6], turning[6] = {0}, f1, f2, e1 = 0.0, e2 = 0.0;
  const maggi_topo *t = &d->t;
  int i, k;

  for (i = 0; i < 5; ++i) {
    for (k = 0; k < t->nq; ++k) q[k] = q0[k] + (i - 2) * h * v[k];
    residual(d, q, res[i]);
  }
  residual(d, q0, gam);
  maggi_velocities(t, d->p, (void *)d->b, v, d->Z, d->Z0);
  maggi_point_velocities(t, 0, t->npointdyn, (void *)d->r, (void *)d->Z, d->rv);
  maggi_point_accelerations(t, 0, t->npointdyn, (void *)d->r, (void *)d->rv, (void *)d->Z,
                            (void *)d->Z0, d->r0a);
  maggi_loop_gamma(t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->rv, (void *)d->r0a,
                   (void *)d->Z, (void *)d->Z0, gam);
  for (i = 0; i < t->nprim; ++i)
    if (is_vector(t, i))
      cross3(d->Z0[t->loopcommon[0]] + 3, d->res + t->primrow[i], turning + t->primrow[i]);
  for (k = 0; k < t->nrow; ++k) {
    gam[k] -= turning[k];
    f1 = (res[3][k] - 2.0 * res[2][k] + res[1][k]) / (h * h);
    f2 = (res[4][k] - 2.0 * res[2][k] + res[0][k]) / (4.0 * h * h);
    e1 += fabs(f1 + gam[k]);
    e2 += fabs(f2 + gam[k]);
    CHECK(fabs(gam[k]) > 1e-3);
    CHECK_NEAR((4.0 * f1 - f2) / 3.0, -gam[k], 1e-9, 2e-8);
  }
  CHECK(e1 > 1e-7);
  CHECK_NEAR(e2 / e1, 4.0, 0.01, 0.0);
}

static void test_kind(int kind)
{
  maggi_model *m = model(kind);
  maggi_data *d = test_start(m);
  double q[TEST_COORDINATES_MAX] = {0}, v[TEST_COORDINATES_MAX], res[6];
  unsigned long long seed = 11 + (unsigned)kind;
  int i, k;

  /* closed in the file */
  residual(d, q, res);
  for (k = 0; k < d->t.nrow; ++k) CHECK_NEAR(res[k], 0.0, 0.0, 1e-15);
  for (i = 0; i < 10; ++i) {
    for (k = 0; k < d->t.nq; ++k) {
      q[k] = 1.5 * random11(&seed);
      v[k] = 1.5 * random11(&seed);
    }
    residual(d, q, res);
    test_residual(kind, d);
    test_entries(d, q);
    test_rates(d, q, v);
    test_gamma(d, q, v);
  }
  test_free(d, m);
}

int main(void)
{
  int kind;

  for (kind = 0; kind < KINDS; ++kind) test_kind(kind);
  return check_done();
}
