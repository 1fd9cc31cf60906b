#include "suites.h"
#include "timing.h"

enum { LEAST = 3 };

void series_begin(series *s, int rounds, double sample, double seconds)
{
  s->n = 0;
  s->every = 1 + (int)(rounds * sample / seconds);
  if (s->every > rounds / LEAST) s->every = rounds / LEAST;
  if (s->every < 1) s->every = 1;
}

void series_add(series *s, double value, double ratio)
{
  s->value[s->n] = value;
  s->ratio[s->n] = ratio;
  ++s->n;
}

void series_end(series *s)
{
  sort_samples(s->n, s->value);
  sort_samples(s->n, s->ratio);
}

double series_value(const series *s, double at)
{
  return quantile(s->n, s->value, at);
}

double series_ratio(const series *s, double at)
{
  return quantile(s->n, s->ratio, at);
}

double series_spread(const series *s)
{
  return 50.0 * (series_ratio(s, 0.75) - series_ratio(s, 0.25)) / series_ratio(s, 0.5);
}
