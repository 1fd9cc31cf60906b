/* A description elsewhere and in a turned world. */
#include <string.h>

#include "mechanism.h"
#include "vector.h"

static void move3(const double d[3], double x[3])
{
  v3_axpy(x, 1.0, d, x);
}

void mech_translate(mechanism *m, const double d[3])
{
  int i;

  for (i = 0; i < m->nbody; ++i) {
    move3(d, m->body[i].def.point);
    move3(d, m->body[i].def.cog);
    move3(d, m->body[i].def.bar_from);
    move3(d, m->body[i].def.bar_to);
  }
  for (i = 0; i < m->nloop; ++i) {
    move3(d, m->loop[i].def.point_a);
    move3(d, m->loop[i].def.point_b);
  }
  for (i = 0; i < m->nrod; ++i) {
    move3(d, m->rod[i].def.point_a);
    move3(d, m->rod[i].def.point_b);
  }
  for (i = 0; i < m->nspring; ++i) {
    move3(d, m->spring[i].def.point_a);
    move3(d, m->spring[i].def.point_b);
  }
  for (i = 0; i < m->npoint_mass; ++i)
    move3(d, m->point_mass[i].def.point);
  for (i = 0; i < m->nforce; ++i)
    move3(d, m->force[i].def.point);
  for (i = 0; i < m->nsensor; ++i)
    move3(d, m->sensor[i].def.point);
}

static void turn3(const double R[9], double x[3])
{
  double y[3];

  m3_mul(R, x, y);
  memcpy(x, y, sizeof y);
}

/* R J R^T of a tensor given by xx yy zz xy xz yz */
static void turn_tensor(const double R[9], double J[6])
{
  double S[9] = {J[0], J[3], J[4], J[3], J[1], J[5], J[4], J[5], J[2]}, T[9], Rt[9], U[9];
  int i, k;

  for (i = 0; i < 3; ++i)
    for (k = 0; k < 3; ++k)
      Rt[3 * i + k] = R[3 * k + i];
  m3_mul3(R, S, T);
  m3_mul3(T, Rt, U);
  J[0] = U[0];
  J[1] = U[4];
  J[2] = U[8];
  J[3] = U[1];
  J[4] = U[2];
  J[5] = U[5];
}

void mech_rotate(mechanism *m, const double R[9])
{
  int i;

  turn3(R, m->gravity);
  for (i = 0; i < m->nbody; ++i) {
    maggi_body_def *d = &m->body[i].def;

    turn3(R, d->point);
    turn3(R, d->axis);
    turn3(R, d->axis2);
    turn3(R, d->cog);
    turn3(R, d->bar_from);
    turn3(R, d->bar_to);
    turn_tensor(R, d->inertia);
  }
  for (i = 0; i < m->nloop; ++i) {
    turn3(R, m->loop[i].def.point_a);
    turn3(R, m->loop[i].def.point_b);
    turn3(R, m->loop[i].def.axis_a);
    turn3(R, m->loop[i].def.axis_b);
  }
  for (i = 0; i < m->nrod; ++i) {
    turn3(R, m->rod[i].def.point_a);
    turn3(R, m->rod[i].def.point_b);
  }
  for (i = 0; i < m->nspring; ++i) {
    turn3(R, m->spring[i].def.point_a);
    turn3(R, m->spring[i].def.point_b);
  }
  for (i = 0; i < m->npoint_mass; ++i)
    turn3(R, m->point_mass[i].def.point);
  for (i = 0; i < m->nforce; ++i) {
    turn3(R, m->force[i].def.point);
    if (m->force[i].def.type != MAGGI_FORCE_JOINT)
      turn3(R, m->force[i].def.value);
    turn3(R, m->force[i].def.wind);
  }
  for (i = 0; i < m->nsensor; ++i)
    turn3(R, m->sensor[i].def.point);
}

/* its axis is not part of the description */
static int is_axis_bound(const mechanism *m, int q)
{
  const mech_body *b = &m->body[mech_body_of(m, q)];

  return b->def.joint == MAGGI_JOINT_SPHERICAL || b->def.joint == MAGGI_JOINT_FREE ||
         (b->def.joint == MAGGI_JOINT_PLANAR && q < b->q + 2 && v3_norm(b->def.axis2) == 0.0);
}

static int is_force_axis_bound(const mechanism *m, const mech_force *f)
{
  if (f->def.type >= MAGGI_FORCE_SPEED && f->q2 >= 0 && is_axis_bound(m, f->q2))
    return 1;
  return (f->def.type == MAGGI_FORCE_JOINT || f->def.type >= MAGGI_FORCE_SPEED) &&
         is_axis_bound(m, f->q);
}

int mech_drop_axis_bound(mechanism *m)
{
  int i, n = m->njoint_spring + m->nforce;

  for (i = m->nsensor - 1; i >= 0; --i)
    if (m->sensor[i].def.type == MAGGI_SENSOR_JOINT_SPRING) m->sensor[i] = m->sensor[--m->nsensor];
  for (i = 0; i < m->nq; ++i) {
    const mech_body *b = &m->body[mech_body_of(m, i)];

    if (b->motion[i - b->q] >= 0 && is_axis_bound(m, i))
      return -1;
  }
  for (i = m->njoint_spring - 1; i >= 0; --i) {
    const mech_joint_spring *s = &m->joint_spring[i];

    if (is_axis_bound(m, s->q) || (s->q2 >= 0 && is_axis_bound(m, s->q2)))
      m->joint_spring[i] = m->joint_spring[--m->njoint_spring];
  }
  for (i = m->nforce - 1; i >= 0; --i)
    if (is_force_axis_bound(m, &m->force[i]))
      m->force[i] = m->force[--m->nforce];
  return n - m->njoint_spring - m->nforce;
}
