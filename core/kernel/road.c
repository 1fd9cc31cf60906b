/* Roads: their height above their point, by x ahead of it. */
#include "kernel.h"
#include "maggi/maggi.h"

static void wave(double amplitude, double length, double x, double h[3])
{
  double k;

  k = 6.28318530717958647693 / length;
  h[0] = amplitude * sin(k * x);
  h[1] = k * amplitude * cos(k * x);
  h[2] = 0.0;
}

/* the bump whose axis is nearest to x */
static int nearest(int np, const double p[np], int adr, int n, double x)
{
  int i, k;

  k = 0;
  for (i = 1; i < n; ++i)
    if (MAGGI_RE(x) >
        MAGGI_RE(p[adr + MAGGI_BUMPS_FIRST] + (i - 0.5) * p[adr + MAGGI_BUMPS_SPACING]))
      k = i;
  return k;
}

/* A cylinder across the road, at x from its axis:  h = sqrt(R^2 - x^2) - (R - height), up to where it
 * meets the road, |x| = c.  From c - f to c + f a fillet with two continuous derivatives,
 *   h = u^3 (h0 + a (1 - u) + b (1 - u)^2),  u = (c + f - |x|) / (2 f),  h0, a, b: h, h', h'' at u = 1 */
static void bump(int np, const double p[np], int adr, double x, double h[2])
{
  double radius, base, c, f, way, y, z, u, w, h0, h1, a, b;

  radius = p[adr + MAGGI_BUMPS_RADIUS];
  base = radius - p[adr + MAGGI_BUMPS_HEIGHT];
  c = sqrt(radius * radius - base * base);
  f = 0.5 * p[adr + MAGGI_BUMPS_FILLET];
  if (MAGGI_RE(x) > 0.0)
    way = 1.0;
  else
    way = -1.0;
  y = way * x;
  if (MAGGI_RE(y) >= MAGGI_RE(c + f)) {
    h[0] = 0.0;
    h[1] = 0.0;
  } else if (MAGGI_RE(y) > MAGGI_RE(c - f)) {
    z = sqrt(radius * radius - (c - f) * (c - f));
    h0 = z - base;
    h1 = 2.0 * f * (c - f) / z;
    a = 3.0 * h0 - h1;
    b = 6.0 * h0 - 3.0 * h1 - 2.0 * f * f * radius * radius / (z * z * z);
    u = (c + f - y) / (2.0 * f);
    w = 1.0 - u;
    h[0] = u * u * u * (h0 + w * (a + w * b));
    h[1] = -way * u * u * (3.0 * (h0 + w * (a + w * b)) - u * (a + 2.0 * w * b)) / (2.0 * f);
  } else {
    z = sqrt(radius * radius - y * y);
    h[0] = z - base;
    h[1] = -x / z;
  }
}

/* h: height; slope of the plane on which a wheel stands there; slope that this plane lacks.  A bump is felt by
 * how it lifts the road, not by how it leans: the plane stays level. */
void maggi_road_height(int kind, int adr, int n, int spline, int np, const double p[np],
                       int nspline, const double spline0[nspline][3], double x, double h[3])
{
  int k;
  double s[3], b[2];

  if (kind == MAGGI_ROAD_FLAT) {
    h[0] = p[adr] * x;
    h[1] = p[adr];
    h[2] = 0.0;
  } else if (kind == MAGGI_ROAD_SINE) {
    wave(p[adr], p[adr + 1], x, h);
  } else if (kind == MAGGI_ROAD_BUMPS) {
    k = nearest(np, p, adr, n, x);
    bump(np, p, adr, x - p[adr + MAGGI_BUMPS_FIRST] - k * p[adr + MAGGI_BUMPS_SPACING], b);
    h[0] = b[0];
    h[1] = 0.0;
    h[2] = b[1];
  } else {
    maggi_spline_value(np, p, adr, n, spline, nspline, spline0, x, s);
    h[0] = s[0];
    h[1] = s[1];
    h[2] = 0.0;
  }
}
