/* What bench-derivatives measures. */
#ifndef BENCH_SUITES_H
#define BENCH_SUITES_H

#include <stdio.h>

enum { ROUNDS_MOST = 101 };

typedef struct options {
  int markdown, rounds;
  double time; /* of a simulation [s] */
  FILE *csv, *pattern;
} options;

#define CSV_HEAD                                                                                   \
  "suite,case,bodies,coordinates,nonzeros,step_s,method,directions,seconds,seconds_low,"           \
  "seconds_high,ratio,steps,jacobians,iterations,drift_percent,apart,jacobian_us,jacobian_low,"    \
  "jacobian_high,jacobian_ratio,differs,thesis_gcc1_s,thesis_gcc2_s,thesis_jacobians,"             \
  "thesis_drift_percent,step_us,matrix_us,factor_us,solve_us,force_us,end_us,dense_us,klu_us\n"
#define PATTERN_HEAD "case,coordinates,row,column,colour\n"

/* true if something is wrong */
int run_model(const options *o, const char *model);
int run_size(const options *o);   /* cost of a step against the number of bodies */
int run_factor(const options *o); /* dense factors against KLU */

/* samples: numbers, and ratios to something measured beside them */
typedef struct series {
  int every; /* rounds from one sample to the next */
  int n;
  double value[ROUNDS_MOST], ratio[ROUNDS_MOST];
} series;

/* for a sample that takes so many seconds, all of them at most `seconds` if that leaves three */
void series_begin(series *s, int rounds, double sample, double seconds);
void series_add(series *s, double value, double ratio);
void series_end(series *s); /* sorts */
double series_value(const series *s, double at);
double series_ratio(const series *s, double at);
double series_spread(const series *s); /* half of the middle half of the ratios [%] */

#endif
