#include "aim.h"

#include <math.h>
#include <string.h>

/* weights of samples in the polynomial of degree 5 at u, in its integral from u to v */
static void polynomial(long double u, long double v, long double at[AIM_SAMPLES],
                       long double integral[AIM_SAMPLES])
{
  long double c[AIM_SAMPLES + 1], scale, high, low, power;
  int i, j, k;

  for (i = 0; i < AIM_SAMPLES; ++i) {
    memset(c, 0, sizeof c);
    c[0] = 1.0L;
    for (j = 0; j < AIM_SAMPLES; ++j) {
      if (j == i) continue;
      scale = 1.0L / (i - j);
      for (k = AIM_SAMPLES - 1; k > 0; --k) c[k] = scale * (c[k - 1] - j * c[k]);
      c[0] *= -scale * j;
    }
    at[i] = integral[i] = 0.0L;
    power = 1.0L;
    for (k = 0, high = v, low = u; k < AIM_SAMPLES; ++k, high *= v, low *= u, power *= u) {
      at[i] += c[k] * power;
      integral[i] += c[k] * (high - low) / (k + 1);
    }
  }
}

static long stencil(const trace *s, long interval)
{
  long first = interval - 2, last = s->steps + 1 - AIM_SAMPLES;

  return first < 0 ? 0 : first > last ? last : first;
}

/* s(t) of an aim at a sample, without its reference */
static reference_number raw(const aim *a, const trace *s, long k)
{
  const reference_number *z = s->values + k * s->nsignal;

  return a->def.function ? z[a->signal[0]] * z[a->signal[1]] : z[a->signal[0]] - a->def.target;
}

static reference_number between(const aim *a, const trace *s, double time)
{
  long double at[AIM_SAMPLES], w[AIM_SAMPLES], u = (long double)time / s->step;
  long k = (long)u, first = stencil(s, k < s->steps ? k : s->steps - 1);
  reference_number sum = 0.0L;
  int i;

  polynomial(u - first, u - first, at, w);
  for (i = 0; i < AIM_SAMPLES; ++i) sum += at[i] * raw(a, s, first + i);
  return sum;
}

static double window_end(const aim *a, const trace *s, int last)
{
  if (last) return isnan(a->def.to) ? s->steps * s->step : a->def.to;
  return isnan(a->def.from) ? 0.0 : a->def.from;
}

/* less its reference */
static reference_number sample(const aim *a, const trace *s, long k)
{
  reference_number z = raw(a, s, k);

  if (a->def.reference != MAGGI_REFERENCE_NONE)
    z -= a->def.target + between(a, s, window_end(a, s, a->def.reference == MAGGI_REFERENCE_FINAL));
  return z;
}

/* g(s) in an integral */
static reference_number integrand(const aim *a, reference_number s)
{
  switch (a->def.type) {
  case MAGGI_OBJECTIVE_INTEGRAL_SQUARE:
  case MAGGI_OBJECTIVE_RMS:
  case MAGGI_OBJECTIVE_NORM:
    return s * s;
  case MAGGI_OBJECTIVE_VIOLATION:
    return creall(s) > 0.0L ? s * s : 0.0L;
  case MAGGI_OBJECTIVE_VDV:
    return s * s * s * s;
  case MAGGI_OBJECTIVE_SMOOTH_MAXIMUM:
    return cexpl(a->def.sharpness * s);
  default:
    return s;
  }
}

/* what is integrated at a sample; of a slope one of 1, s, r, r s, r^2 */
static reference_number value_at(const aim *a, const trace *s, long k, int which)
{
  reference_number r;

  if (a->def.type != MAGGI_OBJECTIVE_SLOPE) return integrand(a, sample(a, s, k));
  r = s->values[k * s->nsignal + a->signal[1]];
  switch (which) {
  case 1:
    return raw(a, s, k);
  case 2:
    return r;
  case 3:
    return r * raw(a, s, k);
  default:
    return r * r;
  }
}

static reference_number integral(const aim *a, const trace *s, int which)
{
  long double from = window_end(a, s, 0), to = window_end(a, s, 1), u, v;
  long double at[AIM_SAMPLES], w[AIM_SAMPLES];
  reference_number sum = 0.0L;
  long k, first;
  int i;

  for (k = 0; k < s->steps; ++k) {
    u = fmaxl(from / s->step, k);
    v = fminl(to / s->step, k + 1);
    if (v <= u) continue;
    first = stencil(s, k);
    polynomial(u - first, v - first, at, w);
    for (i = 0; i < AIM_SAMPLES; ++i) sum += w[i] * value_at(a, s, first + i, which);
  }
  return sum * s->step;
}

static reference_number straight_line(const aim *a, const trace *s, long double T)
{
  reference_number S = integral(a, s, 1), R = integral(a, s, 2);

  return (T * integral(a, s, 3) - R * S) / (T * integral(a, s, 4) - R * R);
}

reference_number aim_outcome(const aim *a, const trace *s)
{
  long double T = (long double)window_end(a, s, 1) - window_end(a, s, 0);
  reference_number sum = 0.0L, e;
  int i;

  switch (a->def.type) {
  case MAGGI_OBJECTIVE_MEAN:
    return integral(a, s, 0) / T;
  case MAGGI_OBJECTIVE_RMS:
    return csqrtl(integral(a, s, 0) / T);
  case MAGGI_OBJECTIVE_VDV:
    return csqrtl(csqrtl(integral(a, s, 0)));
  case MAGGI_OBJECTIVE_SMOOTH_MAXIMUM:
    return clogl(integral(a, s, 0) / T) / a->def.sharpness;
  case MAGGI_OBJECTIVE_NORM:
    return csqrtl(integral(a, s, 0));
  case MAGGI_OBJECTIVE_SLOPE:
    return straight_line(a, s, T);
  case MAGGI_OBJECTIVE_TERMINAL:
    return between(a, s, window_end(a, s, 1));
  case MAGGI_OBJECTIVE_VALUE:
    for (i = 0; i < a->def.number; ++i) sum += between(a, s, a->times[i]);
    return sum;
  case MAGGI_OBJECTIVE_LEAST_SQUARES:
    for (i = 0; i < a->def.number; ++i) {
      e = between(a, s, a->times[i]) - a->values[i];
      sum += e * e;
    }
    return sum / a->def.number;
  default:
    return integral(a, s, 0);
  }
}
