/* Models to be timed, and how an evaluation of them is timed. */
#ifndef BENCH_CASES_H
#define BENCH_CASES_H

#include "maggi/maggi.h"
#include "staged.h"

enum { CASE_SAMPLES = 128, CASE_NAME = 64 };

typedef struct bench_case {
  char name[CASE_NAME];
  int ny, nz; /* of a multiple four-bar, else 0 */
  maggi_model *m;
  maggi_data *d;
  double time;
  int coordinates, dof;
  int batch;    /* evaluations a sample */
  int nsample;
  double sample[CASE_SAMPLES]; /* microseconds an evaluation */
  double us, low, high;        /* median and quartiles */
  long flops;                  /* that the equations need, from topology and plan */
  long blocks;                 /* with whole blocks of columns, from the same */
  long executed;               /* counted; 0 where that is not possible */
} bench_case;

/* Open a model as the command names it (a shipped model, a file, multiple-four-bar:NYxNZ) and take
 * a few steps, to stand in a state of motion; false with a line on stderr. */
int case_open(bench_case *c, const char *spec);
void case_close(bench_case *c);

/* Time the evaluation of all cases, in rounds over them, so that a disturbance of the machine does
 * not meet one of them alone.  Each sample is a batch of evaluations of at least half a millisecond
 * of CPU time of this thread. */
void cases_measure(int n, bench_case cases[], int rounds, int samples);

/* Flops of one evaluation by kernel function: needed, with whole blocks, and executed in `s` (zero
 * where they cannot be counted); sums go to the case. */
typedef struct bench_flops {
  long needed[STAGED_COUNT], blocks[STAGED_COUNT], executed[STAGED_COUNT];
} bench_flops;

void case_count(bench_case *c, bench_flops *f);

/* Names of the shipped models, sorted; returns their number, 0 in a build without YAML. */
int shipped_models(int max, char names[][CASE_NAME]);

/* Five seconds of 1x15: CPU seconds, drift of energy, error of the first and last angle [rad]. */
typedef struct bench_run {
  double step, cpu, drift, error;
  long evaluations, projections;
} bench_run;

maggi_status run_array(maggi_data *d, double step, bench_run *r);  /* all but drift */
maggi_status run_energy(maggi_data *d, double step, bench_run *r); /* drift */

#endif
