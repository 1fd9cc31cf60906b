/* The mechanisms on which derivatives are tested: the models of models/, then random ones. */
#ifndef MAGGI_TESTS_SAMPLE_H
#define MAGGI_TESTS_SAMPLE_H

#include "data.h"
#include "property/report.h"

typedef struct sample {
  const char *name; /* for messages */
  uint64_t seed;    /* of random numbers that belong to it */
  maggi_model *model;
  maggi_data *data; /* in motion, a few steps after its start, with all results */
} sample;

typedef void sample_check(const sample *s);

/* Check on every mechanism; with options->verbose, which --seed sets, on the random ones alone. */
void sample_each(const report_options *options, sample_check *check);

#endif
