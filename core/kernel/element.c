/* Springs, dampers and loads.  [1] 3.5-3.9.
 *
 * Wrenches at P on bodies, torques or forces on coordinates, and the power of what takes energy out
 * of the model or feeds it in (dampers, loads); springs store theirs. */
#include "kernel.h"
#include "maggi/maggi.h"

/* four slopes: rebound c1 up to v11, then c2; compression c3 down to v22, then c4 */
static double slopes(double c1, double c2, double c3, double c4, double v11, double v22, double v)
{
  double f;

  if (MAGGI_RE(v) > MAGGI_RE(v11))
    f = c1 * v11 + c2 * (v - v11);
  else if (MAGGI_RE(v) > 0.0)
    f = c1 * v;
  else if (MAGGI_RE(v) > MAGGI_RE(v22))
    f = c3 * v;
  else
    f = c3 * v22 + c4 * (v - v22);
  return f;
}

static void pull(double f, const double u[3], const double ra[3], const double rb[3], double Fa[6],
                 double Fb[6])
{
  int k;
  double force[3], back[3];

  for (k = 0; k < 3; ++k) {
    force[k] = f * u[k];
    back[k] = -f * u[k];
  }
  maggi_wrench_add(back, ra, Fa);
  maggi_wrench_add(force, rb, Fb);
}

/* u from b to a; elastic and damping force, tension positive */
static void spring(int adr, int preload, int withslopes, int np, const double p[np], double l0,
                   const double ra[3], const double rb[3], const double va[3], const double vb[3],
                   double u[3], double f[2], double rate[1])
{
  int k;
  double l, lv, damping;
  double e[3], ev[3], n[3];

  for (k = 0; k < 3; ++k) {
    e[k] = ra[k] - rb[k];
    ev[k] = va[k] - vb[k];
  }
  l = sqrt(maggi_dot(e, e));
  n[0] = e[0] / l;
  n[1] = e[1] / l;
  n[2] = e[2] / l;
  lv = maggi_dot(n, ev);
  damping = p[adr + MAGGI_SPRING_C] * lv;
  if (preload)
    f[0] = p[adr + MAGGI_SPRING_K] * (l - l0) + p[adr + MAGGI_SPRING_L];
  else
    f[0] = p[adr + MAGGI_SPRING_K] * (l - p[adr + MAGGI_SPRING_L]);
  k = adr + MAGGI_SPRING_SLOPES;
  if (withslopes)
    f[1] = damping + slopes(p[k], p[k + 1], p[k + 2], p[k + 3], p[k + 4], p[k + 5], lv);
  else
    f[1] = damping;
  u[0] = n[0];
  u[1] = n[1];
  u[2] = n[2];
  rate[0] = lv;
}

static void load_value(int kind, int np, const double p[np], int adr, double s, const double A[9],
                       double f[3])
{
  int k;
  double c[3];

  for (k = 0; k < 3; ++k) c[k] = p[adr + k] * s;
  if (kind == MAGGI_FORCE_BODY || kind == MAGGI_TORQUE_BODY) {
    maggi_mul(A, c, f);
  } else {
    for (k = 0; k < 3; ++k) f[k] = c[k];
  }
}

/* - rho/2 c A |u| u,  u = v - wind,  |u| = sqrt(u.u + low^2) */
static void drag(int np, const double p[np], int adr, double s, const double v[3], double f[3])
{
  int k;
  double c, speed;
  double u[3];

  for (k = 0; k < 3; ++k) u[k] = v[k] - p[adr + MAGGI_DRAG_WIND + k];
  speed = sqrt(maggi_dot(u, u) + p[adr + MAGGI_DRAG_LOW] * p[adr + MAGGI_DRAG_LOW]);
  c = 0.5 * p[adr + MAGGI_DRAG_RHO] * p[adr + MAGGI_DRAG_C] * p[adr + MAGGI_DRAG_AREA] * s;
  for (k = 0; k < 3; ++k) f[k] = -c * speed * u[k];
}

/* force at r, or pure torque, on one body and back on another; returns its power */
static double apply(int is_force, const double f[3], const double r[3], const double Z[6],
                    const double Z2[6], double F[6], double F2[6])
{
  int k;
  double power;
  double back[3], v[3], v2[3];

  for (k = 0; k < 3; ++k) back[k] = -f[k];
  if (is_force) {
    maggi_wrench_add(f, r, F);
    maggi_wrench_add(back, r, F2);
    maggi_point_rate(Z, r, v);
    maggi_point_rate(Z2, r, v2);
    power = maggi_dot(f, v) - maggi_dot(f, v2);
  } else {
    for (k = 0; k < 3; ++k) {
      F[k + 3] += f[k];
      F2[k + 3] -= f[k];
    }
    power = f[0] * (Z[3] - Z2[3]) + f[1] * (Z[4] - Z2[4]) + f[2] * (Z[5] - Z2[5]);
  }
  return power;
}

void maggi_element_forces(const maggi_topo *t, const double p[t->np], const double fun[t->nfun][3],
                          const double spring0[t->nspring], const double q[t->nq],
                          const double v[t->nq], const double A[t->nbody + 1][9],
                          const double Z[t->nbody + 1][6], const double r[t->npoint][3],
                          const double rv[t->npoint][3], double Q[t->nbody + 1][6],
                          double tau[t->nq], double power[1])
{
  int i, k, a, b, adr;
  double z, zv, s, torque;
  double u[3], f[2], rate[1], g[3], zero[3];

  power[0] = 0.0;
  for (i = 0; i <= t->nbody; ++i)
    for (k = 0; k < 6; ++k) Q[i][k] = 0.0;
  for (i = 0; i < t->nq; ++i) tau[i] = 0.0;
  for (k = 0; k < 3; ++k) zero[k] = 0.0;

  for (i = 0; i < t->nspring; ++i) {
    a = t->springpa[i];
    b = t->springpb[i];
    spring(t->springadr[i], t->springpreload[i], t->springslopes[i], t->np, p, spring0[i], r[a],
           r[b], rv[a], rv[b], u, f, rate);
    pull(f[0] + f[1], u, r[a], r[b], Q[t->pointbody[a]], Q[t->pointbody[b]]);
    power[0] -= f[1] * rate[0];
  }

  for (i = 0; i < t->njspring; ++i) {
    a = t->jspringq[i];
    b = t->jspringq2[i];
    adr = t->jspringadr[i];
    if (b >= 0) {
      z = q[a] - q[b];
      zv = v[a] - v[b];
    } else {
      z = q[a];
      zv = v[a];
    }
    torque = -p[adr + MAGGI_JSPRING_K] * (z - p[adr + MAGGI_JSPRING_REST]) -
             p[adr + MAGGI_JSPRING_C] * zv - p[adr + MAGGI_JSPRING_PRELOAD];
    tau[a] += torque;
    if (b >= 0) tau[b] -= torque;
    power[0] -= p[adr + MAGGI_JSPRING_C] * zv * zv;
  }

  for (i = 0; i < t->nforce; ++i) {
    adr = t->forceadr[i];
    if (t->forcefun[i] >= 0)
      s = fun[t->forcefun[i]][0];
    else
      s = 1.0;
    if (t->forcekind[i] == MAGGI_FORCE_JOINT) {
      a = t->forceq[i];
      tau[a] += p[adr] * s;
      power[0] += p[adr] * s * v[a];
    } else {
      a = t->forcebody[i];
      b = t->forcereaction[i];
      if (t->forcekind[i] == MAGGI_FORCE_DRAG)
        drag(t->np, p, adr, s, rv[t->forcepoint[i]], g);
      else
        load_value(t->forcekind[i], t->np, p, adr, s, A[a], g);
      if (t->forcepoint[i] >= 0)
        power[0] += apply(1, g, r[t->forcepoint[i]], Z[a], Z[b], Q[a], Q[b]);
      else
        power[0] += apply(0, g, zero, Z[a], Z[b], Q[a], Q[b]);
    }
  }
}
