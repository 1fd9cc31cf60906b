/* What depends on the parameters alone: unit axes, offsets between joints, inertias and points in the
 * initial position.  Computed once a simulation.  A body's reference point is its joint point, so
 * its numbers stay small wherever the model stands.  FORMULATION 1. */
#include "kernel.h"

static void normalise(const double a[3], double u[3])
{
  double n;

  n = sqrt(maggi_dot(a, a));
  u[0] = a[0] / n;
  u[1] = a[1] / n;
  u[2] = a[2] / n;
}

/* the part of w across the unit vector n, made a unit vector */
static void across(const double w[3], const double n[3], double u[3])
{
  double s;
  double a[3];

  s = maggi_dot(w, n);
  a[0] = w[0] - s * n[0];
  a[1] = w[1] - s * n[1];
  a[2] = w[2] - s * n[2];
  normalise(a, u);
}

static void fetch(int np, const double p[np], int adr, double a[3])
{
  a[0] = p[adr];
  a[1] = p[adr + 1];
  a[2] = p[adr + 2];
}

static void global_axis(int axis, double a[3])
{
  a[0] = axis == 0 ? 1.0 : 0.0;
  a[1] = axis == 1 ? 1.0 : 0.0;
  a[2] = axis == 2 ? 1.0 : 0.0;
}

/* v turned by the smallest turn that takes the unit vector n to the unit vector m:
 *   c v + s × v + s (s.v) / (1 + c),  c = n.m,  s = n × m */
static void carry(const double n[3], const double m[3], const double v[3], double u[3])
{
  int k;
  double c, f;
  double s[3], sv[3];

  c = maggi_dot(n, m);
  maggi_cross(n, m, s);
  maggi_cross(s, v, sv);
  f = maggi_dot(s, v) / (1.0 + c);
  for (k = 0; k < 3; ++k) u[k] = c * v[k] + sv[k] + f * s[k];
}

static void direction(int np, const double p[np], int kind, int adr, int aux, int lean, double u[3])
{
  double a[3], e[3], n[3], m[3], w[3], c[3];

  if (kind == MAGGI_DIR_GLOBAL) {
    global_axis(adr, u);
  } else if (kind == MAGGI_DIR_PARAMETER) {
    fetch(np, p, adr, a);
    normalise(a, u);
  } else if (kind == MAGGI_DIR_CARRIED) {
    fetch(np, p, aux, a);
    normalise(a, n);
    global_axis(lean, w);
    across(w, n, c);
    fetch(np, p, adr, e);
    normalise(e, m);
    carry(n, m, c, u);
  } else {
    fetch(np, p, adr, a);
    normalise(a, n);
    if (kind == MAGGI_DIR_ACROSS || kind == MAGGI_DIR_NORMAL)
      fetch(np, p, aux, w);
    else
      global_axis(aux, w);
    across(w, n, c);
    if (kind == MAGGI_DIR_ACROSS || kind == MAGGI_DIR_ACROSS_GLOBAL) {
      u[0] = c[0];
      u[1] = c[1];
      u[2] = c[2];
    } else {
      maggi_cross(n, c, u);
    }
  }
}

/* offset0 = c0 - c0(parent), u0 = a0 / |a0| */
void maggi_joint_constants(const maggi_topo *t, const double p[t->np], const double origin[3],
                           double offset0[t->nbody][3], double axis0[t->nbody][3])
{
  int i, k, adr, up;

  for (i = 0; i < t->nbody; ++i) {
    adr = t->jpointadr[i];
    up = t->parent[i];
    for (k = 0; k < 3; ++k) {
      if (up == t->nbody)
        offset0[i][k] = p[adr + k] - origin[k];
      else
        offset0[i][k] = p[adr + k] - p[t->jpointadr[up] + k];
    }
    if (t->joint[i] != MAGGI_ONE_FIXED)
      direction(t->np, p, t->jdirkind[i], t->jdiradr[i], t->jdiraux[i], 0, axis0[i]);
  }
}

/* inertia of a mass m at g and of J about it, about the reference point:
 *   m,  m g,  J + m (g.g I - g g^T) */
static void lump_add(double m, const double g[3], const double J[6], double body[10])
{
  body[0] += m;
  body[1] += m * g[0];
  body[2] += m * g[1];
  body[3] += m * g[2];
  body[4] += J[0] + m * (g[1] * g[1] + g[2] * g[2]);
  body[5] += J[1] + m * (g[0] * g[0] + g[2] * g[2]);
  body[6] += J[2] + m * (g[0] * g[0] + g[1] * g[1]);
  body[7] += J[3] - m * g[0] * g[1];
  body[8] += J[4] - m * g[0] * g[2];
  body[9] += J[5] - m * g[1] * g[2];
}

/* uniform thin bar along e: J = m/12 (e.e I - e e^T) */
static void bar_inertia(double m, const double e[3], double J[6])
{
  J[0] = m / 12.0 * (e[1] * e[1] + e[2] * e[2]);
  J[1] = m / 12.0 * (e[0] * e[0] + e[2] * e[2]);
  J[2] = m / 12.0 * (e[0] * e[0] + e[1] * e[1]);
  J[3] = -m / 12.0 * e[0] * e[1];
  J[4] = -m / 12.0 * e[0] * e[2];
  J[5] = -m / 12.0 * e[1] * e[2];
}

static void point_add(double m, const double g[3], double body[10])
{
  int k;
  double J[6];

  for (k = 0; k < 6; ++k) J[k] = 0.0;
  lump_add(m, g, J, body);
}

static void lump(int kind, int adr, int np, const double p[np], int refadr, double body[10])
{
  int k;
  double g[3], e[3], J[6];

  if (kind == MAGGI_LUMP_RIGID) {
    for (k = 0; k < 3; ++k) g[k] = p[adr + 1 + k] - p[refadr + k];
    for (k = 0; k < 6; ++k) J[k] = p[adr + 4 + k];
    lump_add(p[adr], g, J, body);
  } else if (kind == MAGGI_LUMP_BAR) {
    for (k = 0; k < 3; ++k) {
      g[k] = 0.5 * (p[adr + 1 + k] + p[adr + 4 + k]) - p[refadr + k];
      e[k] = p[adr + 4 + k] - p[adr + 1 + k];
    }
    bar_inertia(p[adr], e, J);
    lump_add(p[adr], g, J, body);
  } else if (kind == MAGGI_LUMP_POINT) {
    for (k = 0; k < 3; ++k) g[k] = p[adr + 1 + k] - p[refadr + k];
    point_add(p[adr], g, body);
  } else if (kind == MAGGI_LUMP_ROD_A) {
    for (k = 0; k < 3; ++k) g[k] = p[adr + 1 + k] - p[refadr + k];
    point_add(p[adr] / 3.0, g, body);
  } else {
    for (k = 0; k < 3; ++k) g[k] = p[adr + 4 + k] - p[refadr + k];
    point_add(p[adr] / 3.0, g, body);
  }
}

void maggi_inertia_constants(const maggi_topo *t, const double p[t->np], double body0[t->nbody][10])
{
  int i, k;

  for (i = 0; i < t->nbody; ++i)
    for (k = 0; k < 10; ++k) body0[i][k] = 0.0;
  for (i = 0; i < t->nlump; ++i)
    lump(t->lumpkind[i], t->lumpadr[i], t->np, p, t->jpointadr[t->lumpbody[i]],
         body0[t->lumpbody[i]]);
}

/* of a point, or the middle between two when the second address is not -1 */
static void middle(int np, const double p[np], int adr, int adr2, double c[3])
{
  int k;

  for (k = 0; k < 3; ++k) {
    if (adr2 >= 0)
      c[k] = 0.5 * (p[adr + k] + p[adr2 + k]);
    else
      c[k] = p[adr + k];
  }
}

static double distance(int np, const double p[np], int adra, int adrb)
{
  double x, y, z;

  x = p[adra] - p[adrb];
  y = p[adra + 1] - p[adrb + 1];
  z = p[adra + 2] - p[adrb + 2];
  return sqrt(x * x + y * y + z * z);
}

/* points relative to the reference point of their body, unit vectors, lengths as drawn */
void maggi_point_constants(const maggi_topo *t, const double p[t->np], const double origin[3],
                           double point0[t->npoint][3], double dir0[t->ndir][3],
                           double prim0[t->nprim], double spring0[t->nspring])
{
  int i, k, ref;
  double c[3];

  for (i = 0; i < t->npoint; ++i) {
    middle(t->np, p, t->pointadr[i], t->pointadr2[i], c);
    for (k = 0; k < 3; ++k) {
      if (t->pointbody[i] == t->nbody) {
        point0[i][k] = c[k] - origin[k];
      } else {
        ref = t->jpointadr[t->pointbody[i]];
        point0[i][k] = c[k] - p[ref + k];
      }
    }
  }
  for (i = 0; i < t->ndir; ++i)
    direction(t->np, p, t->dirkind[i], t->diradr[i], t->diraux[i], t->dirlean[i], dir0[i]);
  for (i = 0; i < t->nprim; ++i) {
    if (t->primkind[i] == MAGGI_PRIM_ROD && t->primadr[i] >= 0)
      prim0[i] = p[t->primadr[i]];
    else if (t->primkind[i] == MAGGI_PRIM_ROD)
      prim0[i] = distance(t->np, p, t->pointadr[t->primpa[i]], t->pointadr[t->primpb[i]]);
    else if (t->primkind[i] == MAGGI_PRIM_ANGLE && t->primadr[i] == -1)
      prim0[i] = maggi_dot(dir0[t->primda[i]], dir0[t->primdb[i]]);
    else
      prim0[i] = 0.0;
  }
  for (i = 0; i < t->nspring; ++i)
    spring0[i] = distance(t->np, p, t->pointadr[t->springpa[i]], t->pointadr[t->springpb[i]]);
}
