/* Ways to compute the gradient of an objective of a simulation. */
#ifndef BENCH_WAYS_H
#define BENCH_WAYS_H

#include "maggi/maggi.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { PARAMETERS = 35, ALL = 0 };

/* a simulation and its objective */
typedef struct study {
  const maggi_model *m;
  maggi_data *d;
  const char *name; /* of the objective, which has one signal: the first coordinate */
  maggi_objective *objective;
  double step;
  int first;                 /* internal number of the first coordinate */
  const int *parameter;      /* (PARAMETERS) entries of p */
  const char *const *design; /* (PARAMETERS) names of design parameters in their place, or NULL */
} study;

/* numbers of an ADOL-C tape, as in the thesis' Table 5.2 */
typedef struct tape_size {
  long independents, dependents, operations, locations, values;
} tape_size;

/*   open      for the first n of the parameters, or for ALL of p; NULL on failure
 *   gradient  of a simulation of so many steps; false, with a line on stderr, on failure
 *   is_paced  its time is that of a step times their number: slow ones may be timed with fewer
 *   size      NULL where there is no tape */
typedef struct way {
  const char *name;
  void *(*open)(const study *of, int n);
  void (*close)(void *self);
  int (*gradient)(void *self, int steps, double *gradient);
  void (*size)(void *self, tape_size *size);
  int is_paced;
  int is_parallel;  /* of wall time, else of CPU time */
  double tolerance; /* of its gradient against that of the adjoint, relative to the largest entry */
} way;

extern const way way_direct, way_adjoint, way_continuous, way_differences, way_forward, way_threads;
extern const way way_jacobian;
extern const way way_adolc, way_adolc_unsolved, way_adolc_jacobian;

/* n parameters of a study from `first` on as a design for d, or ALL of p; NULL on failure */
maggi_design *study_design(const study *of, const maggi_data *d, int first, int n);
int complain(const char *what, const char *why); /* false */

#ifdef __cplusplus
}
#endif

#endif
