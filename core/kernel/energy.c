/* Kinetic and potential energy. */
#include "kernel.h"

static double twice_kinetic(const double I[10], const double Z[6])
{
  double H[6];

  maggi_inertia_mul(I, Z, H);
  return maggi_dot6(H, Z);
}

/* T = sum Z.(I Z) / 2 + sum over rods m v_a.v_b / 6 */
void maggi_kinetic_energy(const maggi_topo *t, const double p[t->np], const double I[t->nbody][10],
                          const double Z[t->nbody + 1][6], const double rv[t->npoint][3],
                          double energy[1])
{
  int i, k;

  energy[0] = 0.0;
  for (i = 0; i < t->nmassive; ++i) {
    k = t->massive[i];
    energy[0] += 0.5 * twice_kinetic(I[k], Z[k]);
  }
  for (i = 0; i < t->nrod; ++i)
    energy[0] += p[t->rodadr[i]] / 6.0 * maggi_dot(rv[t->rodpa[i]], rv[t->rodpb[i]]);
}

/* - g.(m (x - x_ground + origin) + A h0) */
static double weight(const double g[3], const double body0[10], const double A[9],
                     const double x[3], const double ground[3], const double origin[3])
{
  int k;
  double e;
  double h0[3], h[3];

  h0[0] = body0[1];
  h0[1] = body0[2];
  h0[2] = body0[3];
  maggi_mul(A, h0, h);
  e = 0.0;
  for (k = 0; k < 3; ++k) e -= g[k] * (body0[0] * (x[k] - ground[k] + origin[k]) + h[k]);
  return e;
}

void maggi_potential_energy(const maggi_topo *t, const double p[t->np], const double origin[3],
                            const double body0[t->nbody][10], const double spring0[t->nspring],
                            const double q[t->nq], const double A[t->nbody + 1][9],
                            const double x[t->nbody + 1][3], const double r[t->npoint][3],
                            double energy[1])
{
  int i, k, a, b, adr;
  double sharea, shareb, l, z;
  double g[3], e[3];

  energy[0] = 0.0;
  for (i = 0; i < t->nmassive; ++i) {
    k = t->massive[i];
    /* p begins with gravity */
    g[0] = p[0];
    g[1] = p[1];
    g[2] = p[2];
    energy[0] += weight(g, body0[k], A[k], x[k], x[t->nbody], origin);
  }
  for (i = 0; i < t->nrod; ++i) {
    a = t->rodpa[i];
    b = t->rodpb[i];
    /* half of the mass at each end, a third of it in the body there unless that is the ground */
    sharea = t->pointbody[a] == t->nbody ? 0.5 : 1.0 / 6.0;
    shareb = t->pointbody[b] == t->nbody ? 0.5 : 1.0 / 6.0;
    for (k = 0; k < 3; ++k)
      energy[0] -= p[t->rodadr[i]] * p[k] *
                   (sharea * (r[a][k] - x[t->nbody][k] + origin[k]) +
                    shareb * (r[b][k] - x[t->nbody][k] + origin[k]));
  }
  for (i = 0; i < t->nspring; ++i) {
    a = t->springpa[i];
    b = t->springpb[i];
    adr = t->springadr[i];
    for (k = 0; k < 3; ++k) e[k] = r[a][k] - r[b][k];
    l = sqrt(maggi_dot(e, e));
    if (t->springpreload[i])
      energy[0] += 0.5 * p[adr + MAGGI_SPRING_K] * (l - spring0[i]) * (l - spring0[i]) +
                   p[adr + MAGGI_SPRING_L] * (l - spring0[i]);
    else
      energy[0] += 0.5 * p[adr + MAGGI_SPRING_K] * (l - p[adr + MAGGI_SPRING_L]) *
                   (l - p[adr + MAGGI_SPRING_L]);
  }
  for (i = 0; i < t->njspring; ++i) {
    a = t->jspringq[i];
    b = t->jspringq2[i];
    adr = t->jspringadr[i];
    if (b >= 0)
      z = q[a] - q[b];
    else
      z = q[a];
    energy[0] += 0.5 * p[adr + MAGGI_JSPRING_K] * (z - p[adr + MAGGI_JSPRING_REST]) *
                     (z - p[adr + MAGGI_JSPRING_REST]) +
                 p[adr + MAGGI_JSPRING_PRELOAD] * z;
  }
}
