/* A model in all ways, and what is printed of it. */
#ifndef BENCH_MODEL_H
#define BENCH_MODEL_H

#include "cases.h"
#include "simulation.h"
#include "suites.h"
#include "table.h"

enum { WAYS_MOST = 8 };

typedef struct cell {
  simulation x;
  int batch, states; /* Jacobians a sample, states that were compared */
  double differs;
  series jacobian; /* seconds */
  course course;
  double apart; /* from tangents by colours at the end */
  series run;   /* seconds */
} cell;

typedef struct bench {
  bench_case c;
  const thesis_case *thesis;
  int n, bodies; /* ways that can be had */
  chain_tape *recorded;
  double *states, *value;
  cell cell[WAYS_MOST];
} bench;

size_t model_entries(const bench *b); /* nonzeros of J */

void print_head(const bench *b, const options *o);
void print_jacobians(const bench *b, const options *o);
void print_jacobian_targets(const bench *b);
/* rows of the table of simulations */
void begin_simulations(table *t);
void print_simulations(const bench *b, table *t, double h);
void print_simulation_target(double h, double ratio);
void write_simulations(const bench *b, FILE *csv, double h);
void write_pattern(const bench *b, FILE *file); /* places of J with their colours */
int has_targets(const bench *b);

#endif
