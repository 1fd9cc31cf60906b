/* Motion of a description by the formulas of moving frames, from the parents to the children:
 *
 *   r = o_p + A_p (x0 - o0_p)      v = v_p + w_p × r      a = a_p + w'_p × r + w_p × (w_p × r)
 *   shift along u:  a += 2 w × u z' + u z''        turn about u:  w' += u z'' + w × u z'
 */
#include <math.h>
#include <string.h>

#include "mechanism.h"
#include "vector.h"

/* unit axes of the coordinates of a joint in the drawing and whether they turn */
static void joint_axes(const maggi_body_def *d, double axis[][3], int *turns)
{
  static const double global[3][3] = {{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};
  double n[3], e[3] = {0.0, 0.0, 0.0};
  int k, least;

  for (k = 0; k < MAGGI_JOINT_DOF_MAX; ++k) turns[k] = 1;
  switch (d->joint) {
  case MAGGI_JOINT_REVOLUTE:
  case MAGGI_JOINT_PRISMATIC:
    v3_unit(d->axis, axis[0]);
    turns[0] = d->joint == MAGGI_JOINT_REVOLUTE;
    break;
  case MAGGI_JOINT_CYLINDRICAL:
    v3_unit(d->axis, axis[0]);
    v3_unit(d->axis, axis[1]);
    turns[0] = 0;
    break;
  case MAGGI_JOINT_UNIVERSAL:
    v3_unit(d->axis, axis[0]);
    v3_unit(d->axis2, axis[1]);
    break;
  case MAGGI_JOINT_PLANAR:
    v3_unit(d->axis, n);
    if (v3_norm(d->axis2) > 0.0) {
      memcpy(e, d->axis2, sizeof e);
    } else {
      /* what the library chooses: the global axis that leans least on the normal */
      least = n[0] * n[0] <= n[1] * n[1] && n[0] * n[0] <= n[2] * n[2] ? 0
              : n[1] * n[1] <= n[2] * n[2]                             ? 1
                                                                       : 2;
      e[least] = 1.0;
    }
    v3_axpy(e, -v3_dot(e, n), n, e);
    v3_unit(e, axis[0]);
    v3_cross(n, axis[0], axis[1]);
    memcpy(axis[2], n, sizeof n);
    turns[0] = turns[1] = 0;
    break;
  case MAGGI_JOINT_SPHERICAL:
    memcpy(axis, global, sizeof global);
    break;
  case MAGGI_JOINT_FREE:
    memcpy(axis, global, sizeof global);
    memcpy(axis + 3, global, sizeof global);
    turns[0] = turns[1] = turns[2] = 0;
    break;
  default:
    break;
  }
}

/* a body that would be welded to its parent, seen at a point */
static void carried(const mech_pose *p, const double x[3], mech_pose *b)
{
  double r[3], c[3];
  int k;

  v3_axpy(x, -1.0, p->o, r);
  *b = *p;
  v3_cross(p->w, r, c);
  v3_axpy(p->v, 1.0, c, b->v);
  v3_cross(p->w, c, b->a);
  v3_cross(p->dw, r, c);
  for (k = 0; k < 3; ++k) {
    b->a[k] += p->a[k] + c[k];
    b->o[k] = x[k];
  }
}

static void shift(mech_pose *b, const double u[3], double z, double zv, double za)
{
  double s[3], c[3], cc[3], co[3];
  int k;

  for (k = 0; k < 3; ++k) s[k] = u[k] * z;
  v3_cross(b->w, s, c);
  v3_cross(b->w, c, cc);
  v3_cross(b->w, u, co);
  for (k = 0; k < 3; ++k) {
    b->o[k] += s[k];
    b->v[k] += c[k] + u[k] * zv;
    b->a[k] += cc[k] + 2.0 * co[k] * zv + u[k] * za;
  }
  v3_cross(b->dw, s, c);
  v3_axpy(b->a, 1.0, c, b->a);
}

static void turn(mech_pose *b, const double u[3], double z, double zv, double za)
{
  double c[3], R[9], A[9];
  int k;

  v3_cross(b->w, u, c);
  for (k = 0; k < 3; ++k) {
    b->dw[k] += u[k] * za + c[k] * zv;
    b->w[k] += u[k] * zv;
  }
  m3_rotation(u, z, R);
  m3_mul3(R, b->A, A);
  memcpy(b->A, A, sizeof A);
}

static void chain(const mech_body *body, const mech_pose *up, const double x[3], const double *q,
                  const double *v, const double *a, mech_pose *b)
{
  double axis[MAGGI_JOINT_DOF_MAX][3], u[3];
  int turns[MAGGI_JOINT_DOF_MAX], k, i;

  joint_axes(&body->def, axis, turns);
  carried(up, x, b);
  for (k = 0; k < body->dof; ++k) {
    m3_mul(b->A, axis[k], u);
    if (turns[k])
      turn(b, u, q[k], v[k], a ? a[k] : 0.0);
    else
      shift(b, u, q[k], v[k], a ? a[k] : 0.0);
    for (i = 0; i < 3; ++i) {
      b->screw[k][i] = turns[k] ? 0.0 : u[i];
      b->screw[k][i + 3] = turns[k] ? u[i] : 0.0;
    }
  }
}

void mech_motion(const mechanism *m, const double *q, const double *v, const double *a,
                 mech_pose *pose)
{
  static const mech_pose ground = {.A = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}};
  const mech_body *b;
  const mech_pose *up;
  mech_pose at_rest, weld;
  double x[3], r[3];
  int done[MECH_BODIES] = {0}, n = 0, i, k;

  while (n < m->nbody) {
    for (i = 0; i < m->nbody; ++i) {
      b = &m->body[i];
      if (done[i] || (b->parent != MECH_GROUND && !done[b->parent])) continue;
      up = b->parent == MECH_GROUND ? &ground : &pose[b->parent];
      memcpy(r, b->def.point, sizeof r);
      if (b->parent != MECH_GROUND) v3_axpy(r, -1.0, m->body[b->parent].def.point, r);
      m3_mul(up->A, r, x);
      v3_axpy(up->o, 1.0, x, x);
      chain(b, up, x, q + b->q, v + b->q, a ? a + b->q : NULL, &pose[i]);
      chain(b, up, x, q + b->q, v + b->q, NULL, &at_rest);
      carried(up, at_rest.o, &weld);
      for (k = 0; k < 3; ++k) {
        pose[i].bias[k] = at_rest.a[k] - weld.a[k];
        pose[i].bias[k + 3] = at_rest.dw[k] - weld.dw[k];
      }
      done[i] = 1;
      ++n;
    }
  }
}

void mech_point(const mechanism *m, const mech_pose *pose, int body, const double point[3],
                double r[3], double v[3], double a[3])
{
  mech_pose at;
  double e[3], x[3];
  int k;

  if (body == MECH_GROUND) {
    for (k = 0; k < 3; ++k) {
      r[k] = point[k];
      v[k] = a[k] = 0.0;
    }
    return;
  }
  v3_axpy(point, -1.0, m->body[body].def.point, e);
  m3_mul(pose[body].A, e, x);
  v3_axpy(pose[body].o, 1.0, x, x);
  carried(&pose[body], x, &at);
  memcpy(r, at.o, sizeof at.o);
  memcpy(v, at.v, sizeof at.v);
  memcpy(a, at.a, sizeof at.a);
}

/* ------------------------------------------------------------------------- states, turned world */

static void cofactor_solve(double E[3][3], const double x[3], double y[3])
{
  double c[3], det;
  int k;

  /* columns E[k]: x = sum E[k] y[k] */
  for (k = 0; k < 3; ++k) {
    v3_cross(E[(k + 1) % 3], E[(k + 2) % 3], c);
    det = v3_dot(c, E[k]);
    y[k] = v3_dot(c, x) / det;
  }
}

/* columns of w = E (z', y', x') for Rz(z) Ry(y) Rx(x), and the product */
static void euler(const double q[3], double E[3][3], double A[9])
{
  static const double axis[3][3] = {{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};
  static const double one[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  double R[9], B[9];
  int k;

  memcpy(A, one, sizeof one);
  for (k = 0; k < 3; ++k) {
    m3_mul(A, axis[k], E[k]);
    m3_rotation(axis[k], q[k], R);
    m3_mul3(A, R, B);
    memcpy(A, B, sizeof B);
  }
}

static void rotate_euler(const double R[9], const double q[3], const double v[3], double q2[3],
                         double v2[3])
{
  double E[3][3], A[9], Rt[9], B[9], w[3] = {0.0, 0.0, 0.0}, w2[3];
  int i, k;

  euler(q, E, A);
  for (k = 0; k < 3; ++k) v3_axpy(w, v[k], E[k], w);
  for (i = 0; i < 3; ++i)
    for (k = 0; k < 3; ++k) Rt[3 * i + k] = R[3 * k + i];
  m3_mul3(R, A, B);
  m3_mul3(B, Rt, A);
  m3_mul(R, w, w2);
  q2[0] = atan2(A[3], A[0]);
  q2[1] = atan2(-A[6], sqrt(A[7] * A[7] + A[8] * A[8]));
  q2[2] = atan2(A[7], A[8]);
  euler(q2, E, A);
  cofactor_solve(E, w2, v2);
}

/* displacement along axes before and after the turn */
static void rotate_shift(const double R[9], int n, double axis[][3], double axis2[][3],
                         const double *q, double *q2)
{
  double x[3] = {0.0, 0.0, 0.0}, y[3];
  int k;

  for (k = 0; k < n; ++k) v3_axpy(x, q[k], axis[k], x);
  m3_mul(R, x, y);
  for (k = 0; k < n; ++k) q2[k] = v3_dot(axis2[k], y);
}

void mech_rotate_state(const mechanism *m, const mechanism *turned, const double R[9],
                       const double *q, const double *v, double *q2, double *v2)
{
  double axis[MAGGI_JOINT_DOF_MAX][3], axis2[MAGGI_JOINT_DOF_MAX][3];
  int turns[MAGGI_JOINT_DOF_MAX], i, n, at;

  for (i = 0; i < m->nbody; ++i) {
    at = m->body[i].q;
    n = m->body[i].dof;
    joint_axes(&m->body[i].def, axis, turns);
    joint_axes(&turned->body[i].def, axis2, turns);
    memcpy(q2 + at, q + at, (size_t)n * sizeof *q);
    memcpy(v2 + at, v + at, (size_t)n * sizeof *v);
    if (m->body[i].def.joint == MAGGI_JOINT_PLANAR) {
      rotate_shift(R, 2, axis, axis2, q + at, q2 + at);
      rotate_shift(R, 2, axis, axis2, v + at, v2 + at);
    } else if (m->body[i].def.joint == MAGGI_JOINT_SPHERICAL) {
      rotate_euler(R, q + at, v + at, q2 + at, v2 + at);
    } else if (m->body[i].def.joint == MAGGI_JOINT_FREE) {
      rotate_shift(R, 3, axis, axis2, q + at, q2 + at);
      rotate_shift(R, 3, axis, axis2, v + at, v2 + at);
      rotate_euler(R, q + at + 3, v + at + 3, q2 + at + 3, v2 + at + 3);
    }
  }
}

/* ------------------------------------------------------------------------------------ functions */

/* y0 at t0 to y1 at t1 with no slope and curvature at the ends */
static void quintic(double t0, double t1, double y0, double y1, double t, double y[3])
{
  double T = t1 - t0, s = (t - t0) / T, d = y1 - y0;

  y[0] = s <= 0.0 ? y0 : s >= 1.0 ? y1 : y0 + d * s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
  y[1] = s <= 0.0 || s >= 1.0 ? 0.0 : 30.0 * d / T * s * s * (1.0 - s) * (1.0 - s);
  y[2] = s <= 0.0 || s >= 1.0 ? 0.0 : 60.0 * d / (T * T) * s * (1.0 - s) * (1.0 - 2.0 * s);
}

/* natural spline: curvatures by elimination, then the cubic of the interval */
static void spline(int n, const double *x, const double *f, double t, double y[3])
{
  double c[MECH_KNOTS] = {0.0}, u[MECH_KNOTS] = {0.0}, p, h, l, r;
  int i;

  for (i = 1; i < n - 1; ++i) {
    p = (x[i] - x[i - 1]) / (x[i + 1] - x[i - 1]);
    h = p * c[i - 1] + 2.0;
    c[i] = (p - 1.0) / h;
    u[i] = (6.0 * ((f[i + 1] - f[i]) / (x[i + 1] - x[i]) - (f[i] - f[i - 1]) / (x[i] - x[i - 1])) /
                (x[i + 1] - x[i - 1]) -
            p * u[i - 1]) /
           h;
  }
  c[n - 1] = 0.0;
  for (i = n - 2; i >= 1; --i) c[i] = c[i] * c[i + 1] + u[i];
  c[0] = 0.0;
  for (i = 0; i < n - 2 && t > x[i + 1]; ++i)
    ;
  h = x[i + 1] - x[i];
  r = t < x[0] ? x[0] : t > x[n - 1] ? x[n - 1] : t;
  l = (x[i + 1] - r) / h;
  p = 1.0 - l;
  y[0] =
      l * f[i] + p * f[i + 1] + ((l * l * l - l) * c[i] + (p * p * p - p) * c[i + 1]) * h * h / 6.0;
  y[1] = (f[i + 1] - f[i]) / h +
         ((3.0 * p * p - 1.0) * c[i + 1] - (3.0 * l * l - 1.0) * c[i]) * h / 6.0;
  y[2] = r == t ? l * c[i] + p * c[i + 1] : 0.0;
  y[0] += y[1] * (t - r);
}

void mech_function_value(const mech_function *f, double t, double y[3])
{
  const double *c = f->values;
  double rate[3], x;
  int k, n = f->def.number;

  y[0] = y[1] = y[2] = 0.0;
  switch (f->def.type) {
  case MAGGI_FUNCTION_CONSTANT:
    y[0] = c[0];
    break;
  case MAGGI_FUNCTION_POLYNOMIAL:
    for (k = 0; k < n; ++k) {
      y[0] += c[k] * pow(t, k);
      y[1] += k > 0 ? k * c[k] * pow(t, k - 1) : 0.0;
      y[2] += k > 1 ? k * (k - 1) * c[k] * pow(t, k - 2) : 0.0;
    }
    break;
  case MAGGI_FUNCTION_SINE:
    y[0] = c[3] + c[0] * sin(c[1] * t + c[2]);
    y[1] = c[0] * c[1] * cos(c[1] * t + c[2]);
    y[2] = -c[0] * c[1] * c[1] * sin(c[1] * t + c[2]);
    break;
  case MAGGI_FUNCTION_STEP:
    quintic(c[0], c[1], c[2], c[3], t, y);
    break;
  case MAGGI_FUNCTION_RAMP:
    quintic(c[0], c[1], 0.0, c[3], t, rate);
    x = fmin(fmax((t - c[0]) / (c[1] - c[0]), 0.0), 1.0);
    y[0] =
        c[2] + c[3] * ((c[1] - c[0]) * pow(x, 4) * (2.5 - 3.0 * x + x * x) + fmax(t - c[1], 0.0));
    y[1] = rate[0];
    y[2] = rate[1];
    break;
  case MAGGI_FUNCTION_KNOTS:
    for (k = 0; k < n - 2 && t > f->times[k + 1]; ++k)
      ;
    quintic(f->times[k], f->times[k + 1], c[k], c[k + 1], t, y);
    break;
  default:
    spline(n, f->times, c, t, y);
    break;
  }
}
