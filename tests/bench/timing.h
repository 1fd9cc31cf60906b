/* Clocks and statistics of samples. */
#ifndef BENCH_TIMING_H
#define BENCH_TIMING_H

double cpu_seconds(void);  /* of the calling thread */
double wall_seconds(void);

/* Sort the samples in place; quantile interpolates between sorted ones, 0 <= at <= 1. */
void sort_samples(int n, double samples[]);
double quantile(int n, const double sorted[], double at);

/* slope of log y over log x by least squares */
double log_slope(int n, const double x[], const double y[]);

/* Clock of the core in MHz at this moment, from a chain of additions; NAN where it is not known. */
double clock_mhz(void);

/* Processor of /proc/cpuinfo, "unknown" where there is none. */
void machine(int nmodel, char model[], double *mhz, int *processors);

#endif
