/* One evaluation of the equations of motion, taken apart by kernel function.
 *
 * staged.c is core/dynamics/evaluate.c with a hook before each call of the kernel.  It is compiled
 * twice: `timed` over the kernel of the library, hooks reading the clock; and `counted` over a copy
 * of the kernel without optimisation or vector instructions, in whose assembly count.awk has put a
 * counter behind every addition, subtraction, multiplication, division and square root.  What is
 * counted is therefore what the source says and the processor executes: each of these operations as
 * 1, a sine or cosine as 1, comparisons, negations and copies as 0. */
#ifndef BENCH_STAGED_H
#define BENCH_STAGED_H

#include "maggi/maggi.h"

/* kernel function, stage; a function not listed counts with the one before it */
#define STAGED_LIST(X)                                                                             \
  X(outside, "outside")                                                                            \
  X(maggi_functions, "positions")                                                                  \
  X(maggi_positions, "positions")                                                                  \
  X(maggi_points, "positions")                                                                     \
  X(maggi_directions, "positions")                                                                 \
  X(maggi_loop_residual, "loops")                                                                  \
  X(maggi_loop_entries, "loops")                                                                   \
  X(maggi_island_factors, "loops")                                                                 \
  X(maggi_island_columns, "loops")                                                                 \
  X(maggi_loop_gamma, "loops")                                                                     \
  X(maggi_island_vector, "loops")                                                                  \
  X(maggi_velocities, "velocities")                                                                \
  X(maggi_point_velocities, "velocities")                                                          \
  X(maggi_point_accelerations, "velocities")                                                       \
  X(maggi_accelerations, "velocities")                                                             \
  X(maggi_wheel_forces, "wheels")                                                                  \
  X(maggi_element_forces, "inertias")                                                              \
  X(maggi_control_forces, "inertias")                                                              \
  X(maggi_body_inertias, "inertias")                                                               \
  X(maggi_inertia_forces, "inertias")                                                              \
  X(maggi_rod_forces, "inertias")                                                                  \
  X(maggi_accumulate, "inertias")                                                                  \
  X(maggi_composite_inertias, "inertias")                                                          \
  X(maggi_mass_matrix, "mass matrix")                                                              \
  X(maggi_reduced_mass, "mass matrix")                                                             \
  X(maggi_generalised_forces, "solve")                                                             \
  X(maggi_reduced_force, "solve")                                                                  \
  X(maggi_factor_mass, "solve")                                                                    \
  X(maggi_solve_mass, "solve")                                                                     \
  X(maggi_expand, "solve")                                                                         \
  X(maggi_drives, "solve")

enum {
#define X(function, stage) STAGED_##function,
  STAGED_LIST(X)
#undef X
      STAGED_COUNT
};

/* additions and subtractions, multiplications, divisions, square roots, sines and cosines */
enum { FLOP_ADD, FLOP_MUL, FLOP_DIV, FLOP_SQRT, FLOP_SINCOS, FLOP_COUNT };

typedef struct staged {
  long long ticks[STAGED_COUNT];
  long calls[STAGED_COUNT];
  long flops[STAGED_COUNT][FLOP_COUNT];
} staged;

/* maggi_evaluate, adding to *s; timed fills ticks and calls, counted fills flops and calls */
void staged_timed(maggi_data *d, double time, staged *s);
void staged_counted(maggi_data *d, double time, staged *s);

/* ticks that one hook takes, and ticks a second */
double staged_overhead(void);
double staged_rate(void);

#endif
