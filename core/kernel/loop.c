/* Loop closure: equations, their rates, Jacobian entries and right-hand side of the accelerations.
 * FORMULATION 4, [1] 2.39-2.50, for the building blocks
 *
 *   point  r_a - r_b             axis   u_a - u_b             angle  u_a.u_b - c
 *   plane  (r_a - r_b).u_b       rod    (|r_a - r_b|^2 - l^2) / (2 l)
 *
 * Joints that carry both sides are not in Phi_z.  All they could do is turn the vector of an open point
 * or axis; rates and accelerations leave that out too, so that Phi_z is their derivative with respect to
 * joint rates and accelerations whether the loops are closed or not.
 */
#include "kernel.h"

int maggi_prim_rows(int kind)
{
  return kind == MAGGI_PRIM_POINT || kind == MAGGI_PRIM_AXIS ? 3 : 1;
}

static void prim_residual(int kind, int row, double c, const double ra[3], const double rb[3],
                          const double da[3], const double db[3], int nrow, double res[nrow])
{
  int k;
  double e[3];

  for (k = 0; k < 3; ++k) e[k] = ra[k] - rb[k];
  if (kind == MAGGI_PRIM_POINT) {
    for (k = 0; k < 3; ++k) res[row + k] = e[k];
  } else if (kind == MAGGI_PRIM_AXIS) {
    for (k = 0; k < 3; ++k) res[row + k] = da[k] - db[k];
  } else if (kind == MAGGI_PRIM_ANGLE) {
    res[row] = maggi_dot(da, db) - c;
  } else if (kind == MAGGI_PRIM_PLANE) {
    res[row] = maggi_dot(e, db);
  } else {
    res[row] = (maggi_dot(e, e) - c * c) / (2.0 * c);
  }
}

void maggi_loop_residual(const maggi_topo *t, const double prim0[t->nprim],
                         const double r[t->npoint][3], const double dir[t->ndir][3],
                         double res[t->nrow])
{
  int i;

  for (i = 0; i < t->nprim; ++i)
    prim_residual(t->primkind[i], t->primrow[i], prim0[i], r[t->primpa[i]], r[t->primpb[i]],
                  dir[t->primda[i]], dir[t->primdb[i]], t->nrow, res);
}

/* column of Phi_z of a coordinate that moves one side only; b = its (b_lin, b_ang)
 *   point  ± (b_lin + b_ang × r)     axis  ± b_ang × u       angle  ± b_ang.(u_a × u_b)
 *   plane  ± u_b.(b_lin + b_ang × r_a)                       rod    ± e.(b_lin + b_ang × r) / l */
void maggi_prim_entry(int kind, int side, double length, const double b[6], const double ra[3],
                      const double rb[3], const double da[3], const double db[3], double e[3])
{
  double s;
  double j[3], w[3], c[3];

  s = side == 0 ? 1.0 : -1.0;
  w[0] = b[3];
  w[1] = b[4];
  w[2] = b[5];
  if (kind == MAGGI_PRIM_POINT) {
    if (side == 0)
      maggi_point_rate(b, ra, j);
    else
      maggi_point_rate(b, rb, j);
    e[0] = s * j[0];
    e[1] = s * j[1];
    e[2] = s * j[2];
  } else if (kind == MAGGI_PRIM_AXIS) {
    if (side == 0)
      maggi_cross(w, da, c);
    else
      maggi_cross(w, db, c);
    e[0] = s * c[0];
    e[1] = s * c[1];
    e[2] = s * c[2];
  } else if (kind == MAGGI_PRIM_ANGLE) {
    maggi_cross(da, db, c);
    e[0] = s * maggi_dot(w, c);
    e[1] = 0.0;
    e[2] = 0.0;
  } else if (kind == MAGGI_PRIM_PLANE) {
    maggi_point_rate(b, ra, j);
    e[0] = s * maggi_dot(db, j);
    e[1] = 0.0;
    e[2] = 0.0;
  } else {
    if (side == 0)
      maggi_point_rate(b, ra, j);
    else
      maggi_point_rate(b, rb, j);
    c[0] = ra[0] - rb[0];
    c[1] = ra[1] - rb[1];
    c[2] = ra[2] - rb[2];
    e[0] = s * maggi_dot(c, j) / length;
    e[1] = 0.0;
    e[2] = 0.0;
  }
}

static void loop_entry(int kind, int side, int adr, int step, double length, const double b[6],
                       const double ra[3], const double rb[3], const double da[3],
                       const double db[3], int nphi, double phi[nphi])
{
  double e[3];

  maggi_prim_entry(kind, side, length, b, ra, rb, da, db, e);
  phi[adr] = e[0];
  if (kind == MAGGI_PRIM_POINT || kind == MAGGI_PRIM_AXIS) {
    phi[adr + step] = e[1];
    phi[adr + 2 * step] = e[2];
  }
}

/* entries of the blocks of Phi_d; what the plan does not list is zero */
void maggi_loop_entries(const maggi_topo *t, const double prim0[t->nprim],
                        const double r[t->npoint][3], const double dir[t->ndir][3],
                        const double b[t->nbody][6], double phi[t->nphi])
{
  int i, k;

  for (i = 0; i < t->nent; ++i) {
    k = t->entprim[i];
    loop_entry(t->primkind[k], t->entside[i], t->entadr[i], t->entstep[i], prim0[k],
               b[t->qbody[t->entq[i]]], r[t->primpa[k]], r[t->primpb[k]], dir[t->primda[k]],
               dir[t->primdb[k]], t->nphi, phi);
  }
}

/* u' = w × u */
static void direction_rate(const double Z[6], const double u[3], double u1[3])
{
  double w[3];

  w[0] = Z[3];
  w[1] = Z[4];
  w[2] = Z[5];
  maggi_cross(w, u, u1);
}

/* u'' = w' × u + w × u' */
static void direction_acceleration(const double Z[6], const double Z0[6], const double u[3],
                                   const double u1[3], double u2[3])
{
  double c[3], e[3];

  direction_rate(Z0, u, c);
  direction_rate(Z, u1, e);
  u2[0] = c[0] + e[0];
  u2[1] = c[1] + e[1];
  u2[2] = c[2] + e[2];
}

/* the first derivative of the equation */
static void prim_residual_rate(int kind, int row, double length, const double ra[3],
                               const double rb[3], const double da[3], const double db[3],
                               const double va[3], const double vb[3], const double Za[6],
                               const double Zb[6], int nrow, double rate[nrow])
{
  int k;
  double e[3], ev[3], da1[3], db1[3];

  for (k = 0; k < 3; ++k) {
    e[k] = ra[k] - rb[k];
    ev[k] = va[k] - vb[k];
  }
  if (kind == MAGGI_PRIM_POINT) {
    for (k = 0; k < 3; ++k) rate[row + k] = ev[k];
  } else if (kind == MAGGI_PRIM_ROD) {
    rate[row] = maggi_dot(ev, e) / length;
  } else {
    direction_rate(Za, da, da1);
    direction_rate(Zb, db, db1);
    if (kind == MAGGI_PRIM_AXIS) {
      for (k = 0; k < 3; ++k) rate[row + k] = da1[k] - db1[k];
    } else if (kind == MAGGI_PRIM_ANGLE) {
      rate[row] = maggi_dot(da1, db) + maggi_dot(da, db1);
    } else {
      rate[row] = maggi_dot(ev, db) + maggi_dot(e, db1);
    }
  }
}

/* y += s w × (a - b) */
static void turning_add(double s, int row, const double Z[6], const double a[3], const double b[3],
                        int nrow, double y[nrow])
{
  int k;
  double e[3], e1[3];

  for (k = 0; k < 3; ++k) e[k] = a[k] - b[k];
  direction_rate(Z, e, e1);
  for (k = 0; k < 3; ++k) y[row + k] += s * e1[k];
}

/* what turning with the bodies that carry both sides does to open points and axes */
static void carried_add(const maggi_topo *t, double s, const double r[t->npoint][3],
                        const double dir[t->ndir][3], const double Z[t->nbody + 1][6],
                        double y[t->nrow])
{
  int i, c;

  for (i = 0; i < t->nprim; ++i) {
    c = t->loopcommon[t->primloop[i]];
    if (c < t->nbody && t->primkind[i] == MAGGI_PRIM_POINT)
      turning_add(s, t->primrow[i], Z[c], r[t->primpa[i]], r[t->primpb[i]], t->nrow, y);
    else if (c < t->nbody && t->primkind[i] == MAGGI_PRIM_AXIS)
      turning_add(s, t->primrow[i], Z[c], dir[t->primda[i]], dir[t->primdb[i]], t->nrow, y);
  }
}

void maggi_loop_rates(const maggi_topo *t, const double prim0[t->nprim],
                      const double r[t->npoint][3], const double dir[t->ndir][3],
                      const double rv[t->npoint][3], const double Z[t->nbody + 1][6],
                      double rate[t->nrow])
{
  int i;

  for (i = 0; i < t->nprim; ++i)
    prim_residual_rate(t->primkind[i], t->primrow[i], prim0[i], r[t->primpa[i]], r[t->primpb[i]],
                       dir[t->primda[i]], dir[t->primdb[i]], rv[t->primpa[i]], rv[t->primpb[i]],
                       Z[t->primba[i]], Z[t->primbb[i]], t->nrow, rate);
  carried_add(t, -1.0, r, dir, Z, rate);
}

/* minus the second derivative of the equation with all joint accelerations zero */
static void prim_gamma(int kind, int row, double length, const double ra[3], const double rb[3],
                       const double da[3], const double db[3], const double va[3],
                       const double vb[3], const double aa[3], const double ab[3],
                       const double Za[6], const double Zb[6], const double Z0a[6],
                       const double Z0b[6], int nrow, double gam[nrow])
{
  int k;
  double e[3], ev[3], ea[3], da1[3], da2[3], db1[3], db2[3];

  for (k = 0; k < 3; ++k) {
    e[k] = ra[k] - rb[k];
    ev[k] = va[k] - vb[k];
    ea[k] = aa[k] - ab[k];
  }
  if (kind == MAGGI_PRIM_POINT) {
    for (k = 0; k < 3; ++k) gam[row + k] = -ea[k];
  } else if (kind == MAGGI_PRIM_ROD) {
    gam[row] = -(maggi_dot(ea, e) + maggi_dot(ev, ev)) / length;
  } else {
    direction_rate(Za, da, da1);
    direction_rate(Zb, db, db1);
    direction_acceleration(Za, Z0a, da, da1, da2);
    direction_acceleration(Zb, Z0b, db, db1, db2);
    if (kind == MAGGI_PRIM_AXIS) {
      for (k = 0; k < 3; ++k) gam[row + k] = db2[k] - da2[k];
    } else if (kind == MAGGI_PRIM_ANGLE) {
      gam[row] = -(maggi_dot(da2, db) + 2.0 * maggi_dot(da1, db1) + maggi_dot(da, db2));
    } else {
      gam[row] = -(maggi_dot(ea, db) + 2.0 * maggi_dot(ev, db1) + maggi_dot(e, db2));
    }
  }
}

void maggi_loop_gamma(const maggi_topo *t, const double prim0[t->nprim],
                      const double r[t->npoint][3], const double dir[t->ndir][3],
                      const double rv[t->npoint][3], const double ra[t->npoint][3],
                      const double Z[t->nbody + 1][6], const double Z0[t->nbody + 1][6],
                      double gam[t->nrow])
{
  int i, a, b;

  for (i = 0; i < t->nprim; ++i) {
    a = t->primba[i];
    b = t->primbb[i];
    prim_gamma(t->primkind[i], t->primrow[i], prim0[i], r[t->primpa[i]], r[t->primpb[i]],
               dir[t->primda[i]], dir[t->primdb[i]], rv[t->primpa[i]], rv[t->primpb[i]],
               ra[t->primpa[i]], ra[t->primpb[i]], Z[a], Z[b], Z0[a], Z0[b], t->nrow, gam);
  }
  carried_add(t, 1.0, r, dir, Z0, gam);
}
