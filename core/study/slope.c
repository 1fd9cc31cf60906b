/* Weighted least squares: min sum w (s - c - slope r)^2 over c and slope. */
#include "slope.h"

#include <math.h>
#include <string.h>

void maggi_slope_begin(maggi_slope *f)
{
  memset(f, 0, sizeof *f);
}

void maggi_slope_push(maggi_slope *f, double weight, double s, double r)
{
  if (f->n++ == 0) {
    f->s0 = s;
    f->r0 = r;
  }
  s -= f->s0;
  r -= f->r0;
  f->w += weight;
  f->s += weight * s;
  f->r += weight * r;
  f->rs += weight * r * s;
  f->rr += weight * r * r;
}

double maggi_slope_end(maggi_slope *f)
{
  f->spread = f->w * f->rr - f->r * f->r;
  f->value = f->spread > 0.0 ? (f->w * f->rs - f->r * f->s) / f->spread : NAN;
  return f->value;
}

void maggi_slope_weight(const maggi_slope *f, double weight, double s, double r, double *by_s,
                        double *by_r)
{
  double away = f->w * (r - f->r0) - f->r;

  *by_s = weight * away / f->spread;
  *by_r = weight * (f->w * (s - f->s0) - f->s - 2.0 * f->value * away) / f->spread;
}
