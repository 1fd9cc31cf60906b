/* Sensors, three numbers each: motion of body points in global axes and in those of a vehicle, rotation
 * of bodies, springs, rods, wheels, and sums of others. */
#include "kernel.h"
#include "maggi/maggi.h"

/* R = Rz(yaw) Ry(pitch) Rx(roll) */
static void angles(const double A[9], double s[3])
{
  s[0] = atan2(A[7], A[8]);
  s[1] = atan2(-A[6], sqrt(A[7] * A[7] + A[8] * A[8]));
  s[2] = atan2(A[3], A[0]);
}

/* w = yaw' e_z + pitch' Rz e_y + roll' Rz Ry e_x,  A_0 = cos(pitch) cos(yaw), A_3 = cos(pitch) sin(yaw),
 * A_6 = -sin(pitch) */
static void angle_rates(const double A[9], const double Z[6], double s[3])
{
  double c2, roll;

  c2 = A[0] * A[0] + A[3] * A[3];
  roll = (A[0] * Z[3] + A[3] * Z[4]) / c2;
  s[0] = roll;
  s[1] = (A[0] * Z[4] - A[3] * Z[3]) / sqrt(c2);
  s[2] = Z[5] - A[6] * roll;
}

/* distance of two points and its rate */
static void span(const double ra[3], const double rb[3], const double va[3], const double vb[3],
                 double z[2])
{
  int k;
  double l;
  double e[3], ev[3];

  for (k = 0; k < 3; ++k) {
    e[k] = ra[k] - rb[k];
    ev[k] = va[k] - vb[k];
  }
  l = sqrt(maggi_dot(e, e));
  z[0] = l;
  z[1] = maggi_dot(e, ev) / l;
}

/* slopes of the formula, which a tyre of the other side has as well; 0 in the air */
static void slopes_of_tyre(int adr, double side, int np, const double p[np],
                           const double slip[MAGGI_SLIP_NUMBERS], double fz, double s[3])
{
  double one[5];

  if (MAGGI_RE(fz) > 0.0) {
    one[0] = slip[MAGGI_SLIP_KAPPA];
    one[1] = side * slip[MAGGI_SLIP_TAN_ALPHA];
    one[2] = side * slip[MAGGI_SLIP_GAMMA];
    one[3] = fz;
    one[4] = slip[MAGGI_SLIP_VX];
    maggi_tyre_slopes(adr, np, p, one, s);
  } else {
    s[0] = 0.0;
    s[1] = 0.0;
    s[2] = 0.0;
  }
}

static void wheel_columns(int kind, int adr, double side, int np, const double p[np],
                          const double slip[MAGGI_SLIP_NUMBERS], const double f[6], double s[3])
{
  if (kind == MAGGI_SENSOR_TYRE_SLIP) {
    s[0] = slip[MAGGI_SLIP_KAPPA];
    s[1] = atan(slip[MAGGI_SLIP_TAN_ALPHA]);
    s[2] = slip[MAGGI_SLIP_GAMMA];
  } else if (kind == MAGGI_SENSOR_TYRE_FORCE) {
    s[0] = f[0];
    s[1] = f[1];
    s[2] = f[2];
  } else if (kind == MAGGI_SENSOR_TYRE_MOMENT) {
    s[0] = f[3];
    s[1] = f[4];
    s[2] = f[5];
  } else if (kind == MAGGI_SENSOR_TYRE_CONTACT) {
    s[0] = p[adr + MAGGI_TYRE_UNLOADED_RADIUS] - slip[MAGGI_SLIP_RADIUS];
    s[1] = slip[MAGGI_SLIP_RADIUS];
    s[2] = slip[MAGGI_SLIP_ROLLING];
  } else {
    slopes_of_tyre(adr, side, np, p, slip, f[2], s);
  }
}

/* ra and Za carry minus gravity; p begins with gravity */
void maggi_sensors(const maggi_topo *t, const double p[t->np], const double origin[3],
                   const double spring0[t->nspring], const double q[t->nq], const double v[t->nq],
                   const double A[t->nbody + 1][9], const double x[t->nbody + 1][3],
                   const double r[t->npoint][3], const double Z[t->nbody + 1][6],
                   const double rv[t->npoint][3], const double Za[t->nbody + 1][6],
                   const double ra[t->npoint][3], const double lambda[t->nrow],
                   const double slip[t->nwheel][MAGGI_SLIP_NUMBERS],
                   const double grip[t->nwheel][6], double s[t->nsensor][3])
{
  int i, j, k, n, a, b;
  double sum;
  double g[3], u[3], z[2], f[2], torque[1];

  for (i = 0; i < t->nsensor; ++i) {
    j = t->sensorbody[i];
    k = t->sensorpoint[i];
    n = t->sensorelement[i];
    if (t->sensorkind[i] == MAGGI_SENSOR_POSITION) {
      s[i][0] = r[k][0] - x[t->nbody][0] + origin[0];
      s[i][1] = r[k][1] - x[t->nbody][1] + origin[1];
      s[i][2] = r[k][2] - x[t->nbody][2] + origin[2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_VELOCITY) {
      s[i][0] = rv[k][0];
      s[i][1] = rv[k][1];
      s[i][2] = rv[k][2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ACCELERATION) {
      s[i][0] = ra[k][0] + p[0];
      s[i][1] = ra[k][1] + p[1];
      s[i][2] = ra[k][2] + p[2];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LATERAL_ACCELERATION) {
      for (a = 0; a < 3; ++a) g[a] = ra[k][a] + p[a];
      maggi_lateral_acceleration(p[t->sensoradr[i]], p[t->sensoradr[i] + 1], rv[k], g, s[i]);
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SIDESLIP) {
      for (a = 0; a < 3; ++a) g[a] = ra[k][a] + p[a];
      maggi_sideslip(p[t->sensoradr[i]], A[j], rv[k], g, s[i]);
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_VELOCITY) {
      maggi_level(A[j], rv[k], s[i]);
    } else if (t->sensorkind[i] == MAGGI_SENSOR_LEVEL_ACCELERATION) {
      for (a = 0; a < 3; ++a) g[a] = ra[k][a] + p[a];
      maggi_level(A[j], g, s[i]);
    } else if (t->sensorkind[i] == MAGGI_SENSOR_BODY_ACCELERATION) {
      for (a = 0; a < 3; ++a) g[a] = ra[k][a] + p[a];
      maggi_in_body(A[j], g, s[i]);
    } else if (t->sensorkind[i] == MAGGI_SENSOR_COMBINATION) {
      sum = 0.0;
      for (a = 0; a < t->sensorterms[i]; ++a)
        sum += p[t->sensoradr[i] + a] * s[t->termsensor[n + a]][t->termcolumn[n + a]];
      s[i][0] = sum;
      s[i][1] = 0.0;
      s[i][2] = 0.0;
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLES) {
      angles(A[j], s[i]);
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGLE_RATES) {
      angle_rates(A[j], Z[j], s[i]);
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_VELOCITY) {
      s[i][0] = Z[j][3];
      s[i][1] = Z[j][4];
      s[i][2] = Z[j][5];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ANGULAR_ACCELERATION) {
      s[i][0] = Za[j][3];
      s[i][1] = Za[j][4];
      s[i][2] = Za[j][5];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_SPRING) {
      a = t->springpa[n];
      b = t->springpb[n];
      maggi_spring(t->springadr[n], t->springpreload[n], t->springslopes[n], t->np, p, spring0[n],
                   r[a], r[b], rv[a], rv[b], u, z, f);
      s[i][0] = z[0];
      s[i][1] = z[1];
      s[i][2] = f[0] + f[1];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_JOINT_SPRING) {
      maggi_joint_spring(t->jspringq[n], t->jspringq2[n], t->jspringadr[n], t->np, p, t->nq, q, v,
                         z, torque);
      s[i][0] = z[0];
      s[i][1] = z[1];
      s[i][2] = torque[0];
    } else if (t->sensorkind[i] == MAGGI_SENSOR_ROD) {
      a = t->primpa[n];
      b = t->primpb[n];
      span(r[a], r[b], rv[a], rv[b], z);
      s[i][0] = z[0];
      s[i][1] = z[1];
      s[i][2] = lambda[t->primrow[n]];
    } else {
      wheel_columns(t->sensorkind[i], t->tyreadr[t->wheeltyre[n]], t->wheelmirror[n] ? -1.0 : 1.0,
                    t->np, p, slip[n], grip[n], s[i]);
    }
  }
}
