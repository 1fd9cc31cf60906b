/* Laws of springs and dampers, for the forces of elements and for sensors.  [1] 3.5, 3.6. */
#include "kernel.h"

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

/* u from b to a; length and rate; elastic and damping force, tension positive */
void maggi_spring(int adr, int preload, int withslopes, int np, const double p[np], double l0,
                  const double ra[3], const double rb[3], const double va[3], const double vb[3],
                  double u[3], double z[2], double f[2])
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
  z[0] = l;
  z[1] = lv;
}

/* coordinate a, less b unless that is -1: value z and rate; torque or force on a */
void maggi_joint_spring(int a, int b, int adr, int np, const double p[np], int nq,
                        const double q[nq], const double v[nq], double z[2], double torque[1])
{
  double x, xv;

  if (b >= 0) {
    x = q[a] - q[b];
    xv = v[a] - v[b];
  } else {
    x = q[a];
    xv = v[a];
  }
  torque[0] = -p[adr + MAGGI_JSPRING_K] * (x - p[adr + MAGGI_JSPRING_REST]) -
              p[adr + MAGGI_JSPRING_C] * xv - p[adr + MAGGI_JSPRING_PRELOAD];
  z[0] = x;
  z[1] = xv;
}
