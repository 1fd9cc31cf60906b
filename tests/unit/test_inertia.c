/* core/kernel/constants.c, inertia.c: bodies made of point masses, for which Newton is enough. */
#include "data.h"
#include "fixture.h"

enum { MASSES = 7 };

typedef struct cloud {
  double m[MASSES], r[MASSES][3];
  double mass, cog[3], inertia[6];
} cloud;

/* mass, centre of gravity and tensor about it */
static cloud random_cloud(unsigned long long seed)
{
  cloud c;
  double e[3];
  int i, k;

  memset(&c, 0, sizeof c);
  for (i = 0; i < MASSES; ++i) {
    c.m[i] = 0.2 + random01(&seed);
    c.mass += c.m[i];
    for (k = 0; k < 3; ++k) {
      c.r[i][k] = random11(&seed);
      c.cog[k] += c.m[i] * c.r[i][k];
    }
  }
  for (k = 0; k < 3; ++k) c.cog[k] /= c.mass;
  for (i = 0; i < MASSES; ++i) {
    for (k = 0; k < 3; ++k) e[k] = c.r[i][k] - c.cog[k];
    c.inertia[0] += c.m[i] * (e[1] * e[1] + e[2] * e[2]);
    c.inertia[1] += c.m[i] * (e[0] * e[0] + e[2] * e[2]);
    c.inertia[2] += c.m[i] * (e[0] * e[0] + e[1] * e[1]);
    c.inertia[3] -= c.m[i] * e[0] * e[1];
    c.inertia[4] -= c.m[i] * e[0] * e[2];
    c.inertia[5] -= c.m[i] * e[1] * e[2];
  }
  return c;
}

/* three bodies that carry clouds: c1 as a rigid body, c2 as point masses, c3 as both kinds of each;
 * and the fourth is a bar */
static maggi_model *model(const cloud c[3])
{
  char points[2048];
  int i, n = 0;

  for (i = 0; i < MASSES; ++i)
    n += snprintf(points + n, sizeof points - (size_t)n,
                  "%s{name: m%d, mass: %.17g, point: [%.17g, %.17g, %.17g]}", i ? ", " : "", i,
                  c[1].m[i], c[1].r[i][0], c[1].r[i][1], c[1].r[i][2]);
  return test_model(
      "gravity: [1, -2, 3]\n"
      "bodies:\n"
      "- {name: b1, mass: %.17g, cog: [%.17g, %.17g, %.17g], inertia: {xx: %.17g, yy: %.17g,"
      " zz: %.17g, xy: %.17g, xz: %.17g, yz: %.17g},"
      " joint: {type: revolute, point: [0.3, 1, 0.2], axis: [1, 0.2, -1]}}\n"
      "- {name: b2, parent: b1, joint: {type: cylindrical, point: [1, 1, 0.3], axis: [1, 2, 1]},"
      " point_masses: [%s]}\n"
      "- {name: b3, parent: b2, mass: %.17g, cog: [%.17g, %.17g, %.17g], inertia: {xx: %.17g,"
      " yy: %.17g, zz: %.17g, xy: %.17g, xz: %.17g, yz: %.17g},"
      " joint: {type: spherical, point: [-1, 0.3, 0.8]}, point_masses: [{name: m, mass: 0.7,"
      " point: [0.5, 0.9, -1.1]}]}\n"
      "- {name: b4, parent: b1, mass: 0.9, bar: {from: [0.1, 0.2, 0.3], to: [1.3, -0.4, 0.8]},"
      " joint: {type: revolute, point: [0.4, 0.4, 0.4], axis: [0, 1, -1]}}\n",
      c[0].mass, c[0].cog[0], c[0].cog[1], c[0].cog[2], c[0].inertia[0], c[0].inertia[1],
      c[0].inertia[2], c[0].inertia[3], c[0].inertia[4], c[0].inertia[5], points, c[2].mass,
      c[2].cog[0], c[2].cog[1], c[2].cog[2], c[2].inertia[0], c[2].inertia[1], c[2].inertia[2],
      c[2].inertia[3], c[2].inertia[4], c[2].inertia[5]);
}

/* the point masses of all four bodies: where in the initial position, of which body */
typedef struct masses {
  int n, body[64];
  double m[64], r[64][3];
} masses;

static void add(masses *s, int body, double m, const double r[3])
{
  s->body[s->n] = body;
  s->m[s->n] = m;
  memcpy(s->r[s->n++], r, 3 * sizeof *r);
}

static masses all_masses(const maggi_model *m, const cloud c[3])
{
  static const double extra[3] = {0.5, 0.9, -1.1};
  /* a bar is like its ends and its middle with 1/6, 1/6 and 4/6 of its mass (Simpson) */
  static const double bar[3][3] = {{0.1, 0.2, 0.3}, {1.3, -0.4, 0.8}, {0.7, -0.1, 0.55}};
  masses s;
  int b, i;

  s.n = 0;
  for (b = 0; b < 3; ++b)
    for (i = 0; i < MASSES; ++i) add(&s, m->body[b].body, c[b].m[i], c[b].r[i]);
  add(&s, m->body[2].body, 0.7, extra);
  for (i = 0; i < 3; ++i) add(&s, m->body[3].body, i < 2 ? 0.15 : 0.6, bar[i]);
  return s;
}

/* place of a mass relative to P, from the pose of its body */
static void place(const maggi_data *d, const masses *s, int i, double r[3])
{
  const maggi_topo *t = &d->t;
  int b = s->body[i], k, l;

  for (k = 0; k < 3; ++k) {
    r[k] = d->x[b][k];
    for (l = 0; l < 3; ++l) r[k] += d->A[b][3 * k + l] * (s->r[i][l] - d->p[t->jpointadr[b] + l]);
  }
}

static void add_mass(double m, const double r[3], double I[10])
{
  I[0] += m;
  I[1] += m * r[0];
  I[2] += m * r[1];
  I[3] += m * r[2];
  I[4] += m * (r[1] * r[1] + r[2] * r[2]);
  I[5] += m * (r[0] * r[0] + r[2] * r[2]);
  I[6] += m * (r[0] * r[0] + r[1] * r[1]);
  I[7] -= m * r[0] * r[1];
  I[8] -= m * r[0] * r[2];
  I[9] -= m * r[1] * r[2];
}

static int is_below(const maggi_topo *t, int body, int up)
{
  while (body < up) body = t->parent[body];
  return body == up;
}

/* I and IS of each body are those of its masses, and of those of its subtree */
static void test_inertias(const maggi_data *d, const masses *s)
{
  const maggi_topo *t = &d->t;
  double I[10], IS[10], r[3];
  int b, i, k;

  for (b = 0; b <= t->nbody; ++b) {
    memset(I, 0, sizeof I);
    memset(IS, 0, sizeof IS);
    for (i = 0; i < s->n; ++i) {
      place(d, s, i, r);
      if (s->body[i] == b) add_mass(s->m[i], r, I);
      if (is_below(t, s->body[i], b)) add_mass(s->m[i], r, IS);
    }
    for (k = 0; k < 10; ++k) {
      if (b < t->nbody) CHECK_NEAR(d->I[b][k], I[k], 1e-13, 1e-13);
      CHECK_NEAR(d->IS[b][k], IS[k], 1e-13, 1e-13);
    }
  }
}

/* acceleration of a point of a body: a = s' + w' x r + w x (s + w x r), less gravity as Za */
static void acceleration(const double Z[6], const double Za[6], const double r[3], double a[3])
{
  double v[3], c[3], e[3];
  int k;

  cross3(Z + 3, r, v);
  for (k = 0; k < 3; ++k) v[k] += Z[k];
  cross3(Z + 3, v, c);
  cross3(Za + 3, r, e);
  for (k = 0; k < 3; ++k) a[k] = Za[k] + e[k] + c[k];
}

/* F = sum of - m a and of its moment about P */
static void test_forces(maggi_data *d, const masses *s)
{
  const maggi_topo *t = &d->t;
  double F[6], r[3], a[3], c[3], reactions[6 * 4];
  int b, i, k;

  maggi_get_reactions(d, reactions); /* fills Za and Fr */
  for (b = 0; b < t->nbody; ++b) {
    memset(F, 0, sizeof F);
    for (i = 0; i < s->n; ++i) {
      if (s->body[i] != b) continue;
      place(d, s, i, r);
      acceleration(d->Z[b], d->Za[b], r, a);
      cross3(r, a, c);
      for (k = 0; k < 3; ++k) {
        F[k] -= s->m[i] * a[k];
        F[k + 3] -= s->m[i] * c[k];
      }
    }
    for (k = 0; k < 6; ++k) CHECK_NEAR(d->Fr[b][k], F[k], 1e-12, 1e-12);
  }
}

/* D'Alembert: no virtual motion of one coordinate does work, sum m a . dr/dz = 0 without loads */
static void test_motion(const maggi_data *d, const masses *s)
{
  const maggi_topo *t = &d->t;
  double r[3], a[3], j[3], work, size;
  int q, i, k, b;

  for (q = 0; q < t->nq; ++q) {
    b = t->qbody[q];
    work = size = 0.0;
    for (i = 0; i < s->n; ++i) {
      if (!is_below(t, s->body[i], b)) continue;
      place(d, s, i, r);
      acceleration(d->Z[s->body[i]], d->Za[s->body[i]], r, a);
      cross3(d->b[b] + 3, r, j);
      for (k = 0; k < 3; ++k) j[k] += d->b[b][k];
      work += s->m[i] * dot3(a, j);
      size += s->m[i] * norm3(a) * norm3(j);
    }
    CHECK_NEAR(work / size, 0.0, 0.0, 1e-14);
  }
}

/* both ends of a rod on one arm turning about the origin: m l^2/3 about its end, by the three parts
 * m/3, m/6 and m/6 of it */
static void test_rod(void)
{
  maggi_model *m = test_model(
      "gravity: [0, 0, 0]\n"
      "bodies:\n"
      "- {name: arm, joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]}}\n"
      "- {name: slide, parent: arm, joint: {type: prismatic, axis: [1, 0, 0], motion: still}}\n"
      "functions: [{name: still, type: constant, value: 0}]\n"
      "rods: [{name: rod, body_a: arm, body_b: slide, point_a: [0, 0, 0], point_b: [1.5, 0, 0],"
      " mass: 0.8}]\n"
      "forces: [{name: load, type: joint, coordinate: arm, effort: 2}]\n");
  maggi_data *d = test_start(m);

  CHECK_NEAR(test_get(d).a[0], 2.0 / (0.8 * 1.5 * 1.5 / 3.0), 1e-15, 0.0);
  test_free(d, m);
}

int main(void)
{
  cloud c[3];
  double q[7], v[7];
  unsigned long long seed = 23;
  maggi_model *m;
  maggi_data *d;
  masses s;
  int n, i;

  for (n = 0; n < 10; ++n) {
    for (i = 0; i < 3; ++i) c[i] = random_cloud((unsigned)(3 * n + i + 1));
    m = model(c);
    d = test_start(m);
    s = all_masses(m, c);
    CHECK(test_coordinates(m) == 7);
    for (i = 0; i < 7; ++i) {
      q[i] = 2.0 * random11(&seed);
      v[i] = 2.0 * random11(&seed);
    }
    CHECK(maggi_data_set_state(d, 0.0, q, v) == MAGGI_OK);
    test_inertias(d, &s);
    test_forces(d, &s);
    test_motion(d, &s);
    test_free(d, m);
  }
  test_rod();
  return check_done();
}
