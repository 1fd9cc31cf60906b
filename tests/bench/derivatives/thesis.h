/* Numbers of the thesis: Tables 4.4 and 4.5. */
#ifndef BENCH_THESIS_H
#define BENCH_THESIS_H

enum {
  THESIS_ND,
  THESIS_ADOLC_FORWARD,
  THESIS_ADOLC_REVERSE,
  THESIS_ADOLC_SPARSE,
  THESIS_ADIC2_FORWARD,
  THESIS_ADIC2_SPARSE,
  THESIS_COLUMNS
};
enum { THESIS_GCC_1, THESIS_GCC_2, THESIS_PLATFORMS };

/* one step of one mechanism, 5 s */
typedef struct thesis_run {
  double step;
  double seconds[THESIS_PLATFORMS][THESIS_COLUMNS]; /* NAN: infeasible */
  double drift;                                     /* % */
  int jacobians;
} thesis_run;

typedef struct thesis_case {
  const char *name;
  int independents, dependents, nonzeros, colours;
  thesis_run run[3];
} thesis_case;

/* NULL: not there */
const thesis_case *thesis_find(const char *name);
const thesis_run *thesis_find_run(const thesis_case *c, double step);

#endif
