/* Random mechanisms: bodies, loops, elements, and what a seed makes of them. */
#include "mechanism.h"

#include <math.h>
#include <string.h>

#include "vector.h"

static const double pi = 3.14159265358979323846;

/* ---------------------------------------------------------------------------------- randomness */

static uint64_t next(mech_random *g)
{
  uint64_t z = (g->state += 0x9e3779b97f4a7c15u);

  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double mech_uniform(mech_random *g, double low, double high)
{
  return low + (high - low) * (double)(next(g) >> 11) / 9007199254740992.0;
}

int mech_integer(mech_random *g, int n)
{
  return (int)(next(g) % (uint64_t)n);
}

static int chance(mech_random *g, double probability)
{
  return mech_uniform(g, 0.0, 1.0) < probability;
}

/* Points lie on a grid of 2^-16 m: moving them by whole kilometres is then exact, and what the
 * translated model does differently is the library's round-off and not that of its input. */
static double on_grid(double x)
{
  return floor(x * 65536.0 + 0.5) / 65536.0;
}

static void grid3(double x[3])
{
  int k;

  for (k = 0; k < 3; ++k) x[k] = on_grid(x[k]);
}

static void direction(mech_random *g, double u[3])
{
  double n;
  int k;

  do {
    for (k = 0; k < 3; ++k) u[k] = mech_uniform(g, -1.0, 1.0);
    n = v3_norm(u);
  } while (n > 1.0 || n < 0.1);
  v3_unit(u, u);
}

/* a point at a distance from another */
static void point_near(mech_random *g, const double from[3], double low, double high, double x[3])
{
  double u[3];

  direction(g, u);
  v3_axpy(from, mech_uniform(g, low, high), u, x);
  grid3(x);
}

/* unit vector across n, at an angle in the plane */
static void across(const double n[3], double angle, double u[3])
{
  double e[3] = {0.0, 0.0, 0.0}, a[3], b[3], c[3];
  double x = fabs(n[0]), y = fabs(n[1]), z = fabs(n[2]);
  int k = x <= y && x <= z ? 0 : y <= z ? 1 : 2;

  e[k] = 1.0;
  v3_unit(n, c);
  v3_cross(c, e, a);
  v3_unit(a, a);
  v3_cross(c, a, b);
  for (k = 0; k < 3; ++k) u[k] = cos(angle) * a[k] + sin(angle) * b[k];
}

static void random_across(mech_random *g, const double n[3], double u[3])
{
  across(n, mech_uniform(g, 0.0, 2.0 * pi), u);
}

static void scale3(double s, double a[3])
{
  int k;

  for (k = 0; k < 3; ++k) a[k] *= s;
}

const char *mech_kind_text(mech_kind kind)
{
  static const char *const text[] = {
#define X(name, words) words,
      MECH_KIND_LIST(X)
#undef X
  };

  return text[kind];
}

/* ---------------------------------------------------------------------------------- bodies */

/* second moments of mass of three random vectors: J = (tr P) I - P */
static void random_inertia(mech_random *g, double mass, double size, double J[6])
{
  double P[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, x[3], trace;
  int i, k;

  for (i = 0; i < 3; ++i) {
    direction(g, x);
    scale3(mech_uniform(g, 0.5, 1.0) * size, x);
    for (k = 0; k < 3; ++k) P[k] += mass * x[k] * x[k];
    P[3] += mass * x[0] * x[1];
    P[4] += mass * x[0] * x[2];
    P[5] += mass * x[1] * x[2];
  }
  trace = P[0] + P[1] + P[2];
  for (k = 0; k < 3; ++k) J[k] = trace - P[k];
  for (k = 3; k < 6; ++k) J[k] = -P[k];
}

static int new_body(mechanism *m, mech_random *g, int parent, maggi_joint_type joint,
                    const double point[3])
{
  mech_body *b = &m->body[m->nbody];
  int k;

  maggi_body_def_init(&b->def);
  b->parent = parent;
  b->def.joint = joint;
  memcpy(b->def.point, point, sizeof b->def.point);
  b->def.mass = mech_uniform(g, 0.3, 4.0);
  point_near(g, point, 0.1, 0.5, b->def.cog);
  random_inertia(g, b->def.mass, mech_uniform(g, 0.1, 0.3), b->def.inertia);
  for (k = 0; k < MAGGI_JOINT_DOF_MAX; ++k) b->motion[k] = -1;
  b->dof = maggi_joint_dof(joint);
  b->q = m->nq;
  m->nq += b->dof;
  return m->nbody++;
}

static maggi_joint_type random_joint(mech_random *g)
{
  static const maggi_joint_type bag[] = {
      MAGGI_JOINT_REVOLUTE,  MAGGI_JOINT_REVOLUTE,    MAGGI_JOINT_REVOLUTE,
      MAGGI_JOINT_REVOLUTE,  MAGGI_JOINT_REVOLUTE,    MAGGI_JOINT_PRISMATIC,
      MAGGI_JOINT_PRISMATIC, MAGGI_JOINT_CYLINDRICAL, MAGGI_JOINT_CYLINDRICAL,
      MAGGI_JOINT_UNIVERSAL, MAGGI_JOINT_UNIVERSAL,   MAGGI_JOINT_SPHERICAL,
      MAGGI_JOINT_SPHERICAL, MAGGI_JOINT_PLANAR,      MAGGI_JOINT_FIXED,
      MAGGI_JOINT_FREE};

  return bag[mech_integer(g, (int)(sizeof bag / sizeof *bag))];
}

static void make_bar(mech_random *g, maggi_body_def *d)
{
  double e[3];

  /* only a revolute across it leaves no turn without inertia */
  random_across(g, d->axis, e);
  v3_axpy(e, 0.3, d->axis, e);
  scale3(mech_uniform(g, 0.4, 1.0), e);
  d->is_bar = 1;
  memcpy(d->bar_from, d->point, sizeof d->point);
  v3_axpy(d->point, 1.0, e, d->bar_to);
  grid3(d->bar_to);
}

static int body_in_space(mechanism *m, mech_random *g, int parent)
{
  double zero[3] = {0.0, 0.0, 0.0}, point[3], *axis, *axis2;
  maggi_joint_type joint = random_joint(g);
  int i;

  if (joint == MAGGI_JOINT_FREE && parent != MECH_GROUND && chance(g, 0.7))
    joint = MAGGI_JOINT_REVOLUTE;
  point_near(g, parent == MECH_GROUND ? zero : m->body[parent].def.point, 0.3, 0.9, point);
  i = new_body(m, g, parent, joint, point);
  axis = m->body[i].def.axis;
  axis2 = m->body[i].def.axis2;
  direction(g, axis);
  if (joint == MAGGI_JOINT_UNIVERSAL) {
    random_across(g, axis, axis2);
    v3_axpy(axis2, mech_uniform(g, -0.5, 0.5), axis, axis2);
    scale3(mech_uniform(g, 0.5, 3.0), axis2);
  } else if (joint == MAGGI_JOINT_PLANAR && chance(g, 0.5)) {
    random_across(g, axis, axis2);
  }
  scale3(mech_uniform(g, 0.5, 3.0), axis);
  if (joint == MAGGI_JOINT_REVOLUTE && chance(g, 0.2)) make_bar(g, &m->body[i].def);
  return i;
}

static int random_parent(const mechanism *m, mech_random *g, int first, double ground)
{
  if (m->nbody == first || chance(g, ground)) return MECH_GROUND;
  return chance(g, 0.5) ? m->nbody - 1 : first + mech_integer(g, m->nbody - first);
}

static void tree_in_space(mechanism *m, mech_random *g, int n)
{
  int first = m->nbody;

  while (m->nbody < first + n) body_in_space(m, g, random_parent(m, g, first, 0.08));
}

static int body_in_plane(mechanism *m, mech_random *g, int parent, const double n[3])
{
  static const maggi_joint_type bag[] = {
      MAGGI_JOINT_REVOLUTE, MAGGI_JOINT_REVOLUTE,  MAGGI_JOINT_REVOLUTE, MAGGI_JOINT_REVOLUTE,
      MAGGI_JOINT_REVOLUTE, MAGGI_JOINT_PRISMATIC, MAGGI_JOINT_PLANAR,   MAGGI_JOINT_FIXED};
  double zero[3] = {0.0, 0.0, 0.0}, point[3];
  maggi_joint_type joint = bag[mech_integer(g, (int)(sizeof bag / sizeof *bag))];
  maggi_body_def *d;
  int i;

  point_near(g, parent == MECH_GROUND ? zero : m->body[parent].def.point, 0.3, 0.9, point);
  i = new_body(m, g, parent, joint, point);
  d = &m->body[i].def;
  memcpy(d->axis, n, sizeof d->axis);
  if (joint == MAGGI_JOINT_PRISMATIC) random_across(g, n, d->axis);
  if (joint == MAGGI_JOINT_PLANAR && chance(g, 0.5)) random_across(g, n, d->axis2);
  return i;
}

static void tree_in_plane(mechanism *m, mech_random *g, int n, const double normal[3])
{
  int first = m->nbody;

  while (m->nbody < first + n) body_in_plane(m, g, random_parent(m, g, first, 0.15), normal);
}

static int link_body(mechanism *m, mech_random *g, int parent, const double point[3],
                     const double axis[3])
{
  int i = new_body(m, g, parent, MAGGI_JOINT_REVOLUTE, point);

  memcpy(m->body[i].def.axis, axis, sizeof m->body[i].def.axis);
  return i;
}

/* ---------------------------------------------------------------------------------- loops */

static mech_loop *new_loop(mechanism *m, maggi_loop_type type, int a, int b, const double point[3],
                           const double axis[3])
{
  mech_loop *l = &m->loop[m->nloop++];

  maggi_loop_def_init(&l->def);
  l->def.type = type;
  l->a = a;
  l->b = b;
  memcpy(l->def.point_a, point, sizeof l->def.point_a);
  memcpy(l->def.axis_a, axis, sizeof l->def.axis_a);
  return l;
}

static int depth_of(const mechanism *m, int body)
{
  int n = 0;

  for (; body != MECH_GROUND; body = m->body[body].parent) ++n;
  return n;
}

/* coordinates on the way from a to b that no loop has used; in list */
static int free_path(const mechanism *m, const int *used, int a, int b, int *list)
{
  int da = depth_of(m, a), db = depth_of(m, b), n = 0, k, *end;

  while (a != b) {
    end = da >= db ? &a : &b;
    for (k = 0; k < m->body[*end].dof; ++k)
      if (!used[m->body[*end].q + k]) list[n++] = m->body[*end].q + k;
    *end = m->body[*end].parent;
    if (end == &a)
      --da;
    else
      --db;
  }
  return n;
}

/* two bodies whose way has more unused coordinates than the loop needs; marks those it needs */
static int choose_ends(const mechanism *m, mech_random *g, int first, int need, int *used, int *a,
                       int *b)
{
  int list[MECH_COORDINATES], n, i, k, attempt, swap;

  for (attempt = 0; attempt < 60; ++attempt) {
    *a = first + mech_integer(g, m->nbody - first);
    *b = chance(g, 0.3) ? MECH_GROUND : first + mech_integer(g, m->nbody - first);
    n = *a == *b ? 0 : free_path(m, used, *a, *b, list);
    if (n <= need) continue;
    for (i = 0; i < need; ++i) {
      k = i + mech_integer(g, n - i);
      swap = list[i];
      list[i] = list[k];
      list[k] = swap;
      used[list[i]] = 1;
    }
    if (chance(g, 0.5)) {
      i = *a;
      *a = *b;
      *b = i;
    }
    return 1;
  }
  return 0;
}

static void point_between(const mechanism *m, mech_random *g, int a, int b, double x[3])
{
  double zero[3] = {0.0, 0.0, 0.0}, mid[3];
  const double *pa = a == MECH_GROUND ? zero : m->body[a].def.cog;
  const double *pb = b == MECH_GROUND ? zero : m->body[b].def.cog;
  int k;

  for (k = 0; k < 3; ++k) mid[k] = 0.5 * (pa[k] + pb[k]);
  point_near(g, mid, 0.2, 0.6, x);
}

static void loops_in_space(mechanism *m, mech_random *g, int first, int n, int *used)
{
  static const int need[] = {3, 5, 4, 4, 5};
  double x[3], axis[3];
  mech_loop *l;
  int i, type, a, b;

  for (i = 0; i < n && m->nloop < MECH_LOOPS; ++i) {
    type = mech_integer(g, MAGGI_LOOP_PRISMATIC + 1);
    if (!choose_ends(m, g, first, need[type], used, &a, &b)) continue;
    point_between(m, g, a, b, x);
    direction(g, axis);
    l = new_loop(m, (maggi_loop_type)type, a, b, x, axis);
    if (type == MAGGI_LOOP_UNIVERSAL) {
      random_across(g, axis, l->def.axis_b);
      v3_axpy(l->def.axis_b, mech_uniform(g, -0.4, 0.4), axis, l->def.axis_b);
    }
    scale3(mech_uniform(g, 0.5, 3.0), l->def.axis_a);
    if (type != MAGGI_LOOP_UNIVERSAL && chance(g, 0.3)) {
      l->def.has_b = 1;
      memcpy(l->def.point_b, l->def.point_a, sizeof x);
      memcpy(l->def.axis_b, l->def.axis_a, sizeof x);
      scale3(2.0, l->def.axis_b);
    }
  }
}

static void rods(mechanism *m, mech_random *g, int first, int n, int *used)
{
  double zero[3] = {0.0, 0.0, 0.0};
  mech_rod *r;
  int i, a, b;

  for (i = 0; i < n && m->nrod < MECH_RODS; ++i) {
    if (!choose_ends(m, g, first, 1, used, &a, &b)) continue;
    r = &m->rod[m->nrod++];
    maggi_rod_def_init(&r->def);
    r->a = a;
    r->b = b;
    point_near(g, a == MECH_GROUND ? zero : m->body[a].def.cog, 0.1, 0.4, r->def.point_a);
    do point_near(g, b == MECH_GROUND ? zero : m->body[b].def.cog, 0.1, 0.4, r->def.point_b);
    while (fabs(r->def.point_a[0] - r->def.point_b[0]) < 0.1);
    r->def.mass = chance(g, 0.3) ? 0.0 : mech_uniform(g, 0.2, 3.0);
  }
}

/* in the plane: two equations of rank, whatever the cut */
static void loops_in_plane(mechanism *m, mech_random *g, int first, int n, const double normal[3],
                           int *used)
{
  double x[3], axis[3];
  mech_loop *l;
  int i, a, b, type;

  for (i = 0; i < n && m->nloop < MECH_LOOPS; ++i) {
    if (!choose_ends(m, g, first, 2, used, &a, &b)) continue;
    point_between(m, g, a, b, x);
    type = mech_integer(g, MAGGI_LOOP_PRISMATIC + 1);
    if (chance(g, 0.4)) type = MAGGI_LOOP_REVOLUTE;
    memcpy(axis, normal, sizeof axis);
    if (type == MAGGI_LOOP_PRISMATIC || (type == MAGGI_LOOP_CYLINDRICAL && chance(g, 0.5)))
      random_across(g, normal, axis);
    l = new_loop(m, (maggi_loop_type)type, a, b, x, axis);
    if (type == MAGGI_LOOP_UNIVERSAL) random_across(g, normal, l->def.axis_b);
  }
}

/* windows: cranks on the ground, couplers between the tips; most are parallelograms */
static void parallelograms(mechanism *m, mech_random *g, int windows)
{
  double n[3], foot[3], c[3], e[3], tip[3], step[3], angle;
  int i, crank, coupler;
  static const maggi_loop_type cut[] = {MAGGI_LOOP_REVOLUTE, MAGGI_LOOP_REVOLUTE,
                                        MAGGI_LOOP_SPHERICAL, MAGGI_LOOP_CYLINDRICAL};

  direction(g, n);
  point_near(g, n, 0.1, 1.0, foot);
  angle = mech_uniform(g, 0.0, 2.0 * pi);
  across(n, angle, e);
  across(n, angle + mech_uniform(g, 0.25, 0.75) * pi, c);
  scale3(mech_uniform(g, 0.5, 1.0), c);
  grid3(c);
  grid3(e);
  crank = link_body(m, g, MECH_GROUND, foot, n);
  for (i = 0; i < windows; ++i) {
    v3_axpy(foot, 1.0, c, tip);
    coupler = link_body(m, g, crank, tip, n);
    v3_axpy(tip, 1.0, e, tip);
    v3_axpy(foot, 1.0, e, foot);
    if (chance(g, 0.3)) {
      across(n, angle, step);
      v3_axpy(foot, mech_uniform(g, 0.1, 0.25), step, foot);
      grid3(foot);
    }
    v3_axpy(tip, -1.0, foot, c);
    crank = link_body(m, g, MECH_GROUND, foot, n);
    new_loop(m, cut[mech_integer(g, 4)], coupler, crank, tip, n);
  }
}

/* one platform on equal cranks: each crank after the second adds equations of no rank */
static void platform(mechanism *m, mech_random *g, int cranks)
{
  double n[3], foot[3], c[3], tip[3], angle;
  int i, crank, plate;

  direction(g, n);
  point_near(g, n, 0.1, 1.0, foot);
  angle = mech_uniform(g, 0.0, 2.0 * pi);
  across(n, angle, c);
  grid3(c);
  crank = link_body(m, g, MECH_GROUND, foot, n);
  v3_axpy(foot, 1.0, c, tip);
  plate = link_body(m, g, crank, tip, n);
  for (i = 1; i < cranks; ++i) {
    double u[3];

    across(n, angle + mech_uniform(g, 0.3, 0.7) * pi, u);
    v3_axpy(foot, mech_uniform(g, 0.4, 0.8), u, foot);
    grid3(foot);
    v3_axpy(foot, 1.0, c, tip);
    crank = link_body(m, g, MECH_GROUND, foot, n);
    if (chance(g, 0.5))
      new_loop(m, MAGGI_LOOP_REVOLUTE, crank, plate, tip, n);
    else
      new_loop(m, MAGGI_LOOP_SPHERICAL, plate, crank, tip, n);
  }
}

/* a plate on hinged legs, axes parallel within each leg and all across one direction */
static void sarrus(mechanism *m, mech_random *g, int legs)
{
  double up[3], d[3], out[3], foot[3], knee[3], hip[3], angle;
  int i, low, high, plate = -1;

  direction(g, up);
  angle = mech_uniform(g, 0.0, 2.0 * pi);
  for (i = 0; i < legs; ++i) {
    across(up, angle, d);
    angle += mech_uniform(g, 0.35, 0.65) * pi;
    v3_cross(d, up, out);
    point_near(g, out, 0.0, 0.2, foot);
    v3_axpy(foot, mech_uniform(g, 0.4, 0.6), up, hip);
    v3_axpy(foot, mech_uniform(g, 0.2, 0.3), up, knee);
    v3_axpy(knee, mech_uniform(g, 0.3, 0.6), out, knee);
    grid3(knee);
    grid3(hip);
    low = link_body(m, g, MECH_GROUND, foot, d);
    high = link_body(m, g, low, knee, d);
    if (plate < 0)
      plate = link_body(m, g, high, hip, d);
    else
      new_loop(m, MAGGI_LOOP_REVOLUTE, high, plate, hip, d);
  }
}

/* second hinges on the axes of joints that are there */
static void hinges(mechanism *m, mech_random *g)
{
  static const maggi_loop_type turn[] = {MAGGI_LOOP_REVOLUTE, MAGGI_LOOP_SPHERICAL,
                                         MAGGI_LOOP_CYLINDRICAL};
  static const maggi_loop_type shift[] = {MAGGI_LOOP_PRISMATIC, MAGGI_LOOP_CYLINDRICAL};
  double x[3];
  int i;

  for (i = 0; i < m->nbody && m->nloop < MECH_LOOPS; ++i) {
    maggi_body_def *d = &m->body[i].def;

    if (!chance(g, 0.6)) continue;
    if (d->joint == MAGGI_JOINT_REVOLUTE) {
      grid3(d->axis);
      v3_axpy(d->point, 0.5, d->axis, x);
      new_loop(m, turn[mech_integer(g, 3)], i, m->body[i].parent, x, d->axis);
    } else if (d->joint == MAGGI_JOINT_PRISMATIC) {
      point_near(g, d->point, 0.2, 0.5, x);
      new_loop(m, shift[mech_integer(g, 2)], m->body[i].parent, i, x, d->axis);
    } else if (d->joint == MAGGI_JOINT_SPHERICAL) {
      new_loop(m, MAGGI_LOOP_SPHERICAL, i, m->body[i].parent, d->point, d->axis);
    }
  }
}

/* ---------------------------------------------------------------------------------- elements */

static int random_end(const mechanism *m, mech_random *g)
{
  return chance(g, 0.2) ? MECH_GROUND : mech_integer(g, m->nbody);
}

static const double *middle_of(const mechanism *m, int body)
{
  static const double zero[3] = {0.0, 0.0, 0.0};

  return body == MECH_GROUND ? zero : m->body[body].def.point;
}

static void add_springs(mechanism *m, mech_random *g, int n)
{
  mech_spring *s;
  double e[3];
  int k, i;

  for (i = 0; i < n; ++i) {
    s = &m->spring[m->nspring];
    maggi_spring_def_init(&s->def);
    s->a = random_end(m, g);
    s->b = random_end(m, g);
    if (s->a == s->b) continue;
    do {
      point_near(g, middle_of(m, s->a), 0.2, 0.8, s->def.point_a);
      point_near(g, middle_of(m, s->b), 0.2, 0.8, s->def.point_b);
      v3_axpy(s->def.point_a, -1.0, s->def.point_b, e);
    } while (v3_norm(e) < 0.4);
    s->def.stiffness = mech_uniform(g, 5.0, 60.0);
    if (chance(g, 0.5))
      s->def.free_length = mech_uniform(g, 0.3, 1.2);
    else
      s->def.preload = mech_uniform(g, -5.0, 5.0);
    s->def.damping = chance(g, 0.5) ? mech_uniform(g, 0.1, 2.0) : 0.0;
    if (chance(g, 0.25)) {
      s->def.has_slopes = 1;
      for (k = 0; k < 4; ++k) s->def.c[k] = mech_uniform(g, 0.1, 3.0);
      s->def.v11 = mech_uniform(g, 0.1, 0.5);
      s->def.v22 = -mech_uniform(g, 0.1, 0.5);
    }
    ++m->nspring;
  }
}

int mech_body_of(const mechanism *m, int q)
{
  int i = 0;

  while (q >= m->body[i].q + m->body[i].dof) ++i;
  return i;
}

static void add_joint_springs(mechanism *m, mech_random *g, int n)
{
  mech_joint_spring *s;
  int i;

  for (i = 0; i < n && m->nq > 0; ++i) {
    s = &m->joint_spring[m->njoint_spring++];
    maggi_joint_spring_def_init(&s->def);
    s->q = mech_integer(g, m->nq);
    s->q2 = chance(g, 0.3) ? mech_integer(g, m->nq) : -1;
    if (s->q2 == s->q) s->q2 = -1;
    s->def.stiffness = mech_uniform(g, 1.0, 20.0);
    s->def.damping = chance(g, 0.5) ? mech_uniform(g, 0.05, 1.0) : 0.0;
    s->def.rest = mech_uniform(g, -0.3, 0.3);
    s->def.preload = mech_uniform(g, -2.0, 2.0);
  }
}

static int new_function(mechanism *m, mech_random *g, maggi_function_type type, double size,
                        int from_zero)
{
  mech_function *f = &m->function[m->nfunction];
  double *y = f->values;
  int k;

  memset(f, 0, sizeof *f);
  maggi_function_def_init(&f->def);
  f->def.type = type;
  if (type == MAGGI_FUNCTION_CONSTANT) {
    f->def.number = 1;
    y[0] = from_zero ? 0.0 : mech_uniform(g, -size, size);
  } else if (type == MAGGI_FUNCTION_POLYNOMIAL) {
    f->def.number = 4;
    for (k = 0; k < 4; ++k) y[k] = k == 0 && from_zero ? 0.0 : mech_uniform(g, -size, size);
  } else if (type == MAGGI_FUNCTION_SINE) {
    f->def.number = 4;
    y[0] = mech_uniform(g, 0.3 * size, size);
    y[1] = mech_uniform(g, 1.0, 6.0);
    y[2] = mech_uniform(g, -1.0, 1.0);
    y[3] = from_zero ? -y[0] * sin(y[2]) : mech_uniform(g, -size, size);
  } else if (type == MAGGI_FUNCTION_STEP || type == MAGGI_FUNCTION_RAMP) {
    f->def.number = 4;
    y[0] = mech_uniform(g, -0.3, 0.0);
    y[1] = mech_uniform(g, 0.3, 0.6);
    y[2] = mech_uniform(g, -size, size);
    y[3] = mech_uniform(g, -size, size);
  } else {
    f->def.number = MECH_KNOTS;
    for (k = 0; k < MECH_KNOTS; ++k) {
      f->times[k] = -0.2 + 0.2 * k + mech_uniform(g, 0.0, 0.1);
      y[k] = mech_uniform(g, -size, size);
    }
  }
  return m->nfunction++;
}

static void add_forces(mechanism *m, mech_random *g, int n)
{
  mech_force *f;
  int i, k;

  for (i = 0; i < n; ++i) {
    f = &m->force[m->nforce++];
    maggi_force_def_init(&f->def);
    f->def.type = (maggi_force_type)mech_integer(g, MAGGI_FORCE_DRAG + 1);
    if (m->nq == 0) f->def.type = MAGGI_FORCE_GLOBAL;
    f->body = mech_integer(g, m->nbody);
    f->reaction = chance(g, 0.5) ? mech_integer(g, m->nbody) : MECH_GROUND;
    if (f->reaction == f->body) f->reaction = MECH_GROUND;
    f->q = m->nq > 0 ? mech_integer(g, m->nq) : 0;
    point_near(g, middle_of(m, f->body), 0.1, 0.6, f->def.point);
    for (k = 0; k < 3; ++k) f->def.value[k] = mech_uniform(g, -5.0, 5.0);
    if (f->def.type == MAGGI_FORCE_DRAG) {
      f->def.density = mech_uniform(g, 0.5, 1.5);
      f->def.coefficient = mech_uniform(g, 0.3, 1.2);
      f->def.area = mech_uniform(g, 0.2, 1.0);
      f->def.low_speed = mech_uniform(g, 0.1, 0.5);
      for (k = 0; k < 3; ++k) f->def.wind[k] = mech_uniform(g, -3.0, 3.0);
    }
    f->function = -1;
    if (m->nfunction < MECH_FUNCTIONS && chance(g, 0.4)) {
      k = mech_integer(g, MAGGI_FUNCTION_TYPE_COUNT);
      f->function = new_function(m, g, (maggi_function_type)k, 1.0, 0);
    }
  }
}

/* a controller of speed, on two coordinates if they are alike */
static void add_controller(mechanism *m, mech_random *g)
{
  mech_force *f = &m->force[m->nforce++];
  const mech_body *a, *b;

  maggi_force_def_init(&f->def);
  f->def.type = chance(g, 0.5) ? MAGGI_FORCE_SPEED : MAGGI_FORCE_SPEED_LINEAR;
  f->body = mech_integer(g, m->nbody);
  f->reaction = MECH_GROUND;
  f->q = mech_integer(g, m->nq);
  f->q2 = mech_integer(g, m->nq);
  a = &m->body[mech_body_of(m, f->q)];
  b = &m->body[mech_body_of(m, f->q2)];
  if (f->q == f->q2 || a->def.joint != MAGGI_JOINT_REVOLUTE || b->def.joint != MAGGI_JOINT_REVOLUTE)
    f->q2 = -1;
  point_near(g, middle_of(m, f->body), 0.1, 0.6, f->def.point);
  f->def.speed = mech_uniform(g, 0.0, 3.0);
  f->def.gain = mech_uniform(g, 0.1, 0.5);
  f->def.torque = mech_uniform(g, 0.5, 2.0);
  f->def.low_speed = mech_uniform(g, 0.1, 0.5);
  f->function = m->nfunction > 0 && chance(g, 0.5) ? mech_integer(g, m->nfunction) : -1;
}

static void add_point_masses(mechanism *m, mech_random *g, int n)
{
  mech_point_mass *p;
  int i;

  for (i = 0; i < n; ++i) {
    p = &m->point_mass[m->npoint_mass++];
    maggi_point_mass_def_init(&p->def);
    p->body = mech_integer(g, m->nbody);
    p->def.mass = mech_uniform(g, 0.1, 1.0);
    point_near(g, middle_of(m, p->body), 0.1, 0.6, p->def.point);
  }
}

static mech_sensor *new_sensor(mechanism *m, mech_random *g, maggi_sensor_type type)
{
  mech_sensor *s = &m->sensor[m->nsensor++];

  maggi_sensor_def_init(&s->def);
  s->def.type = type;
  s->body = mech_integer(g, m->nbody);
  s->element = -1;
  return s;
}

static void add_sensors(mechanism *m, mech_random *g)
{
  mech_sensor *s;
  int i;

  for (i = MAGGI_SENSOR_POSITION; i <= MAGGI_SENSOR_ANGLES; ++i) {
    s = new_sensor(m, g, (maggi_sensor_type)i);
    point_near(g, middle_of(m, s->body), 0.1, 0.6, s->def.point);
  }
}

/* of centres of gravity, of other motions of bodies, one of each kind of element that there is */
static void add_more_sensors(mechanism *m, mech_random *g)
{
  int number[] = {m->nspring, m->njoint_spring, m->nrod}, i;

  for (i = MAGGI_SENSOR_POSITION; i <= MAGGI_SENSOR_ACCELERATION; ++i)
    new_sensor(m, g, (maggi_sensor_type)i)->def.at_cog = 1;
  for (i = MAGGI_SENSOR_ANGLE_RATES; i <= MAGGI_SENSOR_ANGULAR_ACCELERATION; ++i)
    new_sensor(m, g, (maggi_sensor_type)i);
  for (i = 0; i < 3; ++i)
    if (number[i] > 0)
      new_sensor(m, g, (maggi_sensor_type)(MAGGI_SENSOR_SPRING + i))->element =
          mech_integer(g, number[i]);
}

static void add_elements(mechanism *m, mech_random *g)
{
  add_springs(m, g, mech_integer(g, MECH_SPRINGS));
  add_joint_springs(m, g, mech_integer(g, MECH_JOINT_SPRINGS));
  add_point_masses(m, g, mech_integer(g, MECH_POINT_MASSES));
  add_sensors(m, g);
}

/* zero at t = 0 where loops are: they stay closed as drawn */
static void guide(mechanism *m, mech_random *g, int q, int from_zero)
{
  static const maggi_function_type zero[] = {MAGGI_FUNCTION_CONSTANT, MAGGI_FUNCTION_POLYNOMIAL,
                                             MAGGI_FUNCTION_SINE};
  maggi_function_type type = (maggi_function_type)mech_integer(g, MAGGI_FUNCTION_TYPE_COUNT);
  mech_body *b = &m->body[mech_body_of(m, q)];

  if (m->nfunction < MECH_FUNCTIONS)
    b->motion[q - b->q] =
        new_function(m, g, from_zero ? zero[mech_integer(g, 3)] : type, 0.3, from_zero);
}

static void add_guides(mechanism *m, mech_random *g, int n, const int *used, int from_zero)
{
  const mech_body *b;
  int i, q;

  for (i = 0; i < 20 * n && m->nfunction < n; ++i) {
    q = mech_integer(g, m->nq);
    b = &m->body[mech_body_of(m, q)];
    if (!used[q] && b->motion[q - b->q] < 0) guide(m, g, q, from_zero);
  }
}

/* ---------------------------------------------------------------------------------- kinds */

/* 3 .. 40 bodies, small ones more often */
static int random_size(mech_random *g, int low, int high)
{
  int n = (int)floor(exp(mech_uniform(g, log(low), log(high + 1.0))));

  return n > high ? high : n;
}

/* open what the drawing closes, by little: the model has to be assembled */
static void open_loops(mechanism *m, mech_random *g)
{
  double u[3];
  int i;

  for (i = 0; i < m->nloop; ++i) {
    maggi_loop_def *d = &m->loop[i].def;

    if (d->type != MAGGI_LOOP_UNIVERSAL && !d->has_b)
      memcpy(d->axis_b, d->axis_a, sizeof d->axis_b);
    d->has_b = 1;
    point_near(g, d->point_a, 0.0, 0.03, d->point_b);
    direction(g, u);
    v3_axpy(d->axis_b, 0.03 * v3_norm(d->axis_b), u, d->axis_b);
  }
  for (i = 0; i < m->nrod; ++i) {
    maggi_rod_def *d = &m->rod[i].def;

    v3_axpy(d->point_a, -1.0, d->point_b, u);
    d->length = v3_norm(u) * mech_uniform(g, 0.98, 1.02);
  }
}

static void free_base(mechanism *m, mech_random *g)
{
  double zero[3] = {0.0, 0.0, 0.0}, point[3];

  point_near(g, zero, 0.3, 0.9, point);
  new_body(m, g, MECH_GROUND, MAGGI_JOINT_FREE, point);
}

void mech_generate(uint64_t seed, int attempt, mechanism *m)
{
  mech_random random = {seed * 1000003u + (uint64_t)attempt * 7919u + 12345u}, *g = &random;
  int used[MECH_COORDINATES] = {0}, n, first;
  double normal[3];

  memset(m, 0, sizeof *m);
  m->seed = seed;
  m->kind = (mech_kind)(seed % MECH_KINDS);
  direction(g, m->gravity);
  scale3(9.81, m->gravity);
  n = random_size(g, 3, MECH_BODIES);
  direction(g, normal);

  switch (m->kind) {
  case MECH_TREE:
    tree_in_space(m, g, n);
    break;
  case MECH_TREE_GUIDED:
    tree_in_space(m, g, n);
    if (m->nq > 1) add_guides(m, g, 1 + mech_integer(g, m->nq < 5 ? m->nq - 1 : 4), used, 0);
    break;
  case MECH_FLOATING:
    free_base(m, g);
    while (m->nbody < n)
      body_in_space(m, g, chance(g, 0.5) ? m->nbody - 1 : mech_integer(g, m->nbody));
    break;
  case MECH_LOOPS_SPACE:
  case MECH_LOOPS_OPEN:
    tree_in_space(m, g, n < 4 ? 4 : n);
    loops_in_space(m, g, 0, 1 + n / 4, used);
    rods(m, g, 0, mech_integer(g, 3), used);
    if (m->kind == MECH_LOOPS_OPEN) open_loops(m, g);
    break;
  case MECH_LOOPS_RODS:
    tree_in_space(m, g, n);
    rods(m, g, 0, 1 + mech_integer(g, 1 + n / 3), used);
    loops_in_space(m, g, 0, mech_integer(g, 2), used);
    break;
  case MECH_LOOPS_GUIDED:
    tree_in_space(m, g, n < 5 ? 5 : n);
    loops_in_space(m, g, 0, 1 + n / 6, used);
    rods(m, g, 0, mech_integer(g, 2), used);
    add_guides(m, g, 1 + mech_integer(g, 2), used, 1);
    break;
  case MECH_PLANE:
  case MECH_PLANE_GUIDED:
    tree_in_plane(m, g, n < 4 ? 4 : n, normal);
    loops_in_plane(m, g, 0, 1 + n / 4, normal, used);
    rods(m, g, 0, mech_integer(g, 3), used);
    if (m->kind == MECH_PLANE_GUIDED) add_guides(m, g, 1 + mech_integer(g, 2), used, 1);
    break;
  case MECH_PARALLELOGRAMS:
    parallelograms(m, g, (n - 1) / 2);
    break;
  case MECH_PLATFORM:
    first = 3 + mech_integer(g, 5);
    platform(m, g, first < n ? first : 3);
    memcpy(normal, m->body[0].def.axis, sizeof normal);
    while (m->nbody < n) body_in_plane(m, g, mech_integer(g, m->nbody), normal);
    break;
  case MECH_SARRUS:
    sarrus(m, g, 2 + mech_integer(g, 3));
    while (m->nbody < n) body_in_space(m, g, mech_integer(g, m->nbody));
    break;
  case MECH_HINGES:
    tree_in_space(m, g, n);
    hinges(m, g);
    break;
  case MECH_MIXED:
    sarrus(m, g, 2);
    first = m->nbody;
    tree_in_space(m, g, n < 4 ? 4 : n > 30 ? 30 : n);
    loops_in_space(m, g, first, 1 + n / 5, used);
    break;
  default:
    break;
  }
  add_elements(m, g);
  add_forces(m, g, mech_integer(g, MECH_FORCES - 1));
  if (chance(g, 0.2) && m->kind == MECH_FLOATING) memset(m->gravity, 0, sizeof m->gravity);
  /* last, so that a seed goes on to mean the same motion */
  add_more_sensors(m, g);
  if (m->nq > 0 && chance(g, 0.3)) add_controller(m, g);
}
