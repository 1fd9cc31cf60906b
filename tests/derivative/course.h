/* The simulations on which derivatives of whole simulations are tested: short ones, so that motions that
 * diverge do not make round-off large.  Models of models/, multiple four-bars, a parallelogram through
 * its flat position, random mechanisms. */
#ifndef MAGGI_TESTS_COURSE_H
#define MAGGI_TESTS_COURSE_H

#include "data.h"
#include "property/mechanism.h"
#include "property/report.h"

typedef struct course {
  const char *name;  /* for messages */
  uint64_t seed;     /* of random numbers that belong to it */
  maggi_data *data;  /* with its parameters, not reset */
  const char *paths; /* what its parameters are moved by: all, or those whose path contains this */
  double precision;  /* 1; larger near singular positions, where round-off becomes large */
  double step;
  long steps;
} course;

typedef void course_check(const course *c);

/* A direction of its parameters, entries in their own size; a design whose parameters move all entries
 * along n directions. */
double *course_direction(const course *c, mech_random *random);
maggi_design *course_design(const course *c, int n, double *const *x);

/* Dampers with knees: a number for the segments they are in, and how near they are to a knee [m/s]; those
 * within COURSE_KNEE stay there, because their ends do not move relative to each other. */
#define COURSE_KNEE 1e-12
long course_segments(const maggi_data *d, double *margin);

/* Check on every simulation; with options->verbose, which --seed sets, on the random ones alone. */
void course_each(const report_options *options, course_check *check);

#endif
