/* Springs, dampers and loads: what they exert, and where that of wheels goes.  [1] 3.4-3.9.
 *
 * Wrenches at P on bodies, torques or forces on coordinates, and the power of what takes energy out
 * of the model or feeds it in (dampers, loads, wheels); springs store theirs. */
#include "kernel.h"
#include "maggi/maggi.h"

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
                          const double rv[t->npoint][3], const double roll[t->nwheel][6],
                          double Q[t->nbody + 1][6], double tau[t->nq], double power[1])
{
  int i, k, a, b, adr;
  double s;
  double u[3], z[2], f[2], torque[1], g[3], zero[3];

  power[0] = 0.0;
  for (i = 0; i <= t->nbody; ++i)
    for (k = 0; k < 6; ++k) Q[i][k] = 0.0;
  for (i = 0; i < t->nq; ++i) tau[i] = 0.0;
  for (k = 0; k < 3; ++k) zero[k] = 0.0;

  for (i = 0; i < t->nspring; ++i) {
    a = t->springpa[i];
    b = t->springpb[i];
    maggi_spring(t->springadr[i], t->springpreload[i], t->springslopes[i], t->np, p, spring0[i],
                 r[a], r[b], rv[a], rv[b], u, z, f);
    pull(f[0] + f[1], u, r[a], r[b], Q[t->pointbody[a]], Q[t->pointbody[b]]);
    power[0] -= f[1] * z[1];
  }

  for (i = 0; i < t->njspring; ++i) {
    a = t->jspringq[i];
    b = t->jspringq2[i];
    adr = t->jspringadr[i];
    maggi_joint_spring(a, b, adr, t->np, p, t->nq, q, v, z, torque);
    tau[a] += torque[0];
    if (b >= 0) tau[b] -= torque[0];
    power[0] -= p[adr + MAGGI_JSPRING_C] * z[1] * z[1];
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

  /* power of all of it, springs of tyres too */
  for (i = 0; i < t->nwheel; ++i) {
    a = t->wheelbody[i];
    for (k = 0; k < 6; ++k) Q[a][k] += roll[i][k];
    power[0] += maggi_dot6(roll[i], Z[a]);
  }
}
