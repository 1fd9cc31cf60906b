/* A driver who follows a path: a natural cubic spline through points of the plane, its parameter s the
 * length of the polyline up to a point, straight beyond the ends.
 *
 * The point P a time ahead of the vehicle is projected on the path, (C(s) - P).C'(s) = 0, by Newton's method
 * from the nearest point of the polyline; six steps reach round-off where P is nearer to the path than
 * half its radius of curvature.  Steps are calls, each with a result of its own. */
#include "kernel.h"

/* of one of x, y, speed: as in function.c */
static void path_bend(int np, const double p[np], int adr, int n, int row, int col, int npath,
                      double path0[npath][8])
{
  int k;
  double h0, h1, e0, e1;

  path0[row][col + 1] = 0.0;
  for (k = 1; k < n - 1; ++k) {
    h0 = path0[row + k][MAGGI_PATH_S] - path0[row + k - 1][MAGGI_PATH_S];
    h1 = path0[row + k + 1][MAGGI_PATH_S] - path0[row + k][MAGGI_PATH_S];
    e0 = (p[adr + k] - p[adr + k - 1]) / h0;
    e1 = (p[adr + k + 1] - p[adr + k]) / h1;
    path0[row + k][col + 1] =
        (6.0 * (e1 - e0) - h0 * path0[row + k - 1][col + 1]) * path0[row + k][MAGGI_PATH_W] / h1;
  }
  path0[row][col] = 0.0;
  path0[row + n - 1][col] = 0.0;
  path0[row + n - 1][col + 1] = 0.0;
  for (k = n - 2; k > 0; --k)
    path0[row + k][col] =
        path0[row + k][col + 1] - path0[row + k][MAGGI_PATH_W] * path0[row + k + 1][col];
}

static void path_spline(int np, const double p[np], int adr, int withspeeds, int n, int row,
                        int npath, double path0[npath][8])
{
  int k;
  double h0, h1, dx, dy;

  path0[row][MAGGI_PATH_S] = 0.0;
  for (k = 1; k < n; ++k) {
    dx = p[adr + k] - p[adr + k - 1];
    dy = p[adr + n + k] - p[adr + n + k - 1];
    path0[row + k][MAGGI_PATH_S] = path0[row + k - 1][MAGGI_PATH_S] + sqrt(dx * dx + dy * dy);
  }
  path0[row][MAGGI_PATH_W] = 0.0;
  path0[row + n - 1][MAGGI_PATH_W] = 0.0;
  for (k = 1; k < n - 1; ++k) {
    h0 = path0[row + k][MAGGI_PATH_S] - path0[row + k - 1][MAGGI_PATH_S];
    h1 = path0[row + k + 1][MAGGI_PATH_S] - path0[row + k][MAGGI_PATH_S];
    path0[row + k][MAGGI_PATH_W] = h1 / (2.0 * (h0 + h1) - h0 * path0[row + k - 1][MAGGI_PATH_W]);
  }
  path_bend(np, p, adr, n, row, MAGGI_PATH_X, npath, path0);
  path_bend(np, p, adr + n, n, row, MAGGI_PATH_Y, npath, path0);
  if (withspeeds) {
    path_bend(np, p, adr + 2 * n, n, row, MAGGI_PATH_V, npath, path0);
  } else {
    for (k = 0; k < n; ++k) {
      path0[row + k][MAGGI_PATH_V] = 0.0;
      path0[row + k][MAGGI_PATH_VE] = 0.0;
    }
  }
}

void maggi_path_constants(const maggi_topo *t, const double p[t->np], double path0[t->npath0][8])
{
  int i;

  for (i = 0; i < t->ndriver; ++i)
    path_spline(t->np, p, t->driverpath[i], t->driverspeeds[i], t->drivern[i], t->driverrow[i],
                t->npath0, path0);
}

/* piece k with s_k <= s < s_k+1, the first and the last one beyond the ends */
static int path_piece(int n, int row, int npath, const double path0[npath][8], double s)
{
  int k, found;

  found = 0;
  for (k = 1; k < n - 1; ++k)
    if (MAGGI_RE(s) >= MAGGI_RE(path0[row + k][MAGGI_PATH_S])) found = k;
  return found;
}

/* value and two derivatives at s */
static void path_value(int np, const double p[np], int adr, int n, int row, int col, int npath,
                       const double path0[npath][8], double s, double f[3])
{
  int k;
  double h, a, c, e, slope, m0, m1;

  k = path_piece(n, row, npath, path0, s);
  h = path0[row + k + 1][MAGGI_PATH_S] - path0[row + k][MAGGI_PATH_S];
  a = path0[row + k + 1][MAGGI_PATH_S] - s;
  c = s - path0[row + k][MAGGI_PATH_S];
  m0 = path0[row + k][col];
  m1 = path0[row + k + 1][col];
  e = (p[adr + k + 1] - p[adr + k]) / h;
  if (MAGGI_RE(c) < 0.0) {
    slope = e - h / 6.0 * (2.0 * m0 + m1);
    f[0] = p[adr + k] + slope * c;
    f[1] = slope;
    f[2] = 0.0;
  } else if (MAGGI_RE(a) < 0.0) {
    slope = e + h / 6.0 * (m0 + 2.0 * m1);
    f[0] = p[adr + k + 1] - slope * a;
    f[1] = slope;
    f[2] = 0.0;
  } else {
    slope = e - h / 6.0 * (m1 - m0);
    f[0] =
        (m0 * a * a * a + m1 * c * c * c) / (6.0 * h) + p[adr + k] - m0 * h * h / 6.0 + slope * c;
    f[1] = (m1 * c * c - m0 * a * a) / (2.0 * h) + slope;
    f[2] = (m0 * a + m1 * c) / h;
  }
}

/* where P is nearest to the line through piece k of the polyline, as a part of the piece */
static double path_part(int np, const double p[np], int adr, int n, int k, const double P[2])
{
  double dx, dy;

  dx = p[adr + k + 1] - p[adr + k];
  dy = p[adr + n + k + 1] - p[adr + n + k];
  return ((P[0] - p[adr + k]) * dx + (P[1] - p[adr + n + k]) * dy) / (dx * dx + dy * dy);
}

/* the piece that is nearest to P; the first and the last one are lines without an end */
static int path_nearest(int np, const double p[np], int adr, int n, const double P[2])
{
  int k, found;
  double u, x, y, d, least;

  found = 0;
  least = 0.0;
  for (k = 0; k < n - 1; ++k) {
    u = path_part(np, p, adr, n, k, P);
    if (k > 0 && MAGGI_RE(u) < 0.0) u = 0.0;
    if (k < n - 2 && MAGGI_RE(u) > 1.0) u = 1.0;
    x = p[adr + k] + u * (p[adr + k + 1] - p[adr + k]) - P[0];
    y = p[adr + n + k] + u * (p[adr + n + k + 1] - p[adr + n + k]) - P[1];
    d = x * x + y * y;
    if (k == 0 || MAGGI_RE(d) < MAGGI_RE(least)) {
      least = d;
      found = k;
    }
  }
  return found;
}

/* one step of Newton's method; C, C', C'' at s */
static double path_nearer(const double x[3], const double y[3], const double P[2], double s)
{
  double g, slope;

  g = (x[0] - P[0]) * x[1] + (y[0] - P[1]) * y[1];
  slope = x[1] * x[1] + y[1] * y[1] + (x[0] - P[0]) * x[2] + (y[0] - P[1]) * y[2];
  return s - g / slope;
}

/* the parameter of the point of the path nearest to P */
static double path_project(int np, const double p[np], int adr, int n, int row, int npath,
                           const double path0[npath][8], const double P[2])
{
  int k;
  double s0, s1, s2, s3, s4, s5, s6;
  double x0[3], x1[3], x2[3], x3[3], x4[3], x5[3], y0[3], y1[3], y2[3], y3[3], y4[3], y5[3];

  k = path_nearest(np, p, adr, n, P);
  s0 = path0[row + k][MAGGI_PATH_S] +
       path_part(np, p, adr, n, k, P) *
           (path0[row + k + 1][MAGGI_PATH_S] - path0[row + k][MAGGI_PATH_S]);
  path_value(np, p, adr, n, row, MAGGI_PATH_X, npath, path0, s0, x0);
  path_value(np, p, adr + n, n, row, MAGGI_PATH_Y, npath, path0, s0, y0);
  s1 = path_nearer(x0, y0, P, s0);
  path_value(np, p, adr, n, row, MAGGI_PATH_X, npath, path0, s1, x1);
  path_value(np, p, adr + n, n, row, MAGGI_PATH_Y, npath, path0, s1, y1);
  s2 = path_nearer(x1, y1, P, s1);
  path_value(np, p, adr, n, row, MAGGI_PATH_X, npath, path0, s2, x2);
  path_value(np, p, adr + n, n, row, MAGGI_PATH_Y, npath, path0, s2, y2);
  s3 = path_nearer(x2, y2, P, s2);
  path_value(np, p, adr, n, row, MAGGI_PATH_X, npath, path0, s3, x3);
  path_value(np, p, adr + n, n, row, MAGGI_PATH_Y, npath, path0, s3, y3);
  s4 = path_nearer(x3, y3, P, s3);
  path_value(np, p, adr, n, row, MAGGI_PATH_X, npath, path0, s4, x4);
  path_value(np, p, adr + n, n, row, MAGGI_PATH_Y, npath, path0, s4, y4);
  s5 = path_nearer(x4, y4, P, s4);
  path_value(np, p, adr, n, row, MAGGI_PATH_X, npath, path0, s5, x5);
  path_value(np, p, adr + n, n, row, MAGGI_PATH_Y, npath, path0, s5, y5);
  s6 = path_nearer(x5, y5, P, s5);
  return s6;
}

/* r from where the path counts; coordinate q and rate: lateral error, s, demand, speed; torque */
void maggi_driver(int adr, int pathadr, int withspeeds, int n, int row, int np, const double p[np],
                  int npath, const double path0[npath][8], const double r[3], const double v[3],
                  double q, double qv, double driver[4], double torque[1])
{
  int k;
  double s, length, error, curvature, limit, demand;
  double P[2], x[3], y[3], z[3];

  for (k = 0; k < 2; ++k) P[k] = r[k] + p[adr + MAGGI_DRIVER_PREVIEW] * v[k];
  s = path_project(np, p, pathadr, n, row, npath, path0, P);
  path_value(np, p, pathadr, n, row, MAGGI_PATH_X, npath, path0, s, x);
  path_value(np, p, pathadr + n, n, row, MAGGI_PATH_Y, npath, path0, s, y);
  length = sqrt(x[1] * x[1] + y[1] * y[1]);
  error = ((y[0] - P[1]) * x[1] - (x[0] - P[0]) * y[1]) / length;
  curvature = (x[1] * y[2] - y[1] * x[2]) / (length * length * length);
  limit = p[adr + MAGGI_DRIVER_LIMIT];
  demand =
      limit *
      tanh((p[adr + MAGGI_DRIVER_GAIN] * error + p[adr + MAGGI_DRIVER_FEEDFORWARD] * curvature) /
           limit);
  torque[0] = p[adr + MAGGI_DRIVER_STIFFNESS] * (demand - q) - p[adr + MAGGI_DRIVER_DAMPING] * qv;
  driver[0] = error;
  driver[1] = s;
  driver[2] = demand;
  if (withspeeds) {
    path_value(np, p, pathadr + 2 * n, n, row, MAGGI_PATH_V, npath, path0, s, z);
    driver[3] = z[0];
  } else {
    driver[3] = 0.0;
  }
}
