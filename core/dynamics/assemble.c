/* Closing the loops of an initial position.
 *
 * The dependent coordinates are chosen anew in each iteration, prescribed positions are never among
 * them, and steps are shortened until the loops close further. */
#include <math.h>
#include <string.h>

#include "closing.h"

enum { ASSEMBLY_STARTS = 30, ASSEMBLY_ITERATIONS = 200, HALVINGS = 12 };

/* largest move of a coordinate in one iteration [rad or m] */
static const double assembly_step = 0.5;

static maggi_status fail_assembly(maggi_data *d, double violation)
{
  int loop = maggi_worst_loop(d);

  return maggi_data_fail(d, MAGGI_E_ASSEMBLY,
                         "%s \"%s\" cannot be closed in the initial position: %.3g remain open",
                         maggi_loop_word(d, loop), d->m->loop[loop].name, violation);
}

/* Newton from the present position; the loops are open by *violation after it.  Equations that are
 * redundant where the loops are closed are not so while they are open: when `relaxed`, pivots of the
 * size of the opening count as redundant. */
static maggi_status newton(maggi_data *d, double time, int avoid, int relaxed, double *violation)
{
  double before, factor;
  maggi_status status;
  int i, k;

  maggi_evaluate_positions(d, time);
  *violation = maggi_violation(d);
  for (i = 0; i < ASSEMBLY_ITERATIONS && !(*violation <= maggi_roundoff(d)); ++i) {
    if (isnan(*violation))
      return maggi_data_fail(d, MAGGI_E_NOT_FINITE, "the initial position is not finite");
    if (relaxed) d->rank_tolerance = fmin(fmax(*violation, MAGGI_RANK_TOLERANCE), 0.05);
    status = maggi_plan(d, avoid, 0.5);
    d->rank_tolerance = MAGGI_RANK_TOLERANCE;
    if (status != MAGGI_OK) return status;
    maggi_close_step(d);
    maggi_close_begin(d);
    before = *violation;
    factor = maggi_close_size(d);
    factor = factor > assembly_step ? assembly_step / factor : 1.0;
    for (k = 0; k < HALVINGS; ++k) {
      maggi_close_move(d, factor);
      maggi_evaluate_positions(d, time);
      *violation = maggi_violation(d);
      if (*violation < before) break;
      factor *= 0.5;
    }
    if (k == HALVINGS) {
      maggi_close_move(d, 0.0);
      maggi_evaluate_positions(d, time);
      *violation = before;
      break;
    }
  }
  return MAGGI_OK;
}

/* a cylindrical or prismatic loop whose equations hold with one axis against the other, -1: none */
static int reversed_loop(const maggi_data *d)
{
  const maggi_topo *t = &d->t;
  double axis_b[3];
  int i;

  for (i = 0; i + 1 < t->nprim; ++i) {
    if (t->primkind[i] != MAGGI_PRIM_PLANE || t->primkind[i + 1] != MAGGI_PRIM_PLANE) continue;
    maggi_cross(d->dir[t->primdb[i]], d->dir[t->primdb[i + 1]], axis_b);
    if (maggi_dot(d->dir[t->primda[i]], axis_b) < 0.0) return t->primloop[i];
  }
  return -1;
}

/* between -1 and 1, the same in every run */
static double scattered(unsigned *seed)
{
  *seed = *seed * 1664525u + 1013904223u;
  return (double)(*seed >> 8) / (double)(1u << 23) - 1.0;
}

/* Newton from the position in q, then from points scattered wider and wider around it */
maggi_status maggi_assemble(maggi_data *d, double time, int avoid)
{
  size_t bytes = (size_t)d->t.nq * sizeof(double);
  double violation, least = INFINITY, spread;
  maggi_status status;
  unsigned seed = 1;
  int n, i, loop, reversed = -1;

  memcpy(d->dqs, d->q, bytes);
  for (n = 0; n < ASSEMBLY_STARTS; ++n) {
    spread = n < 2 ? 0.0 : 3.2 * n / ASSEMBLY_STARTS;
    for (i = 0; n > 0 && i < d->t.nq; ++i)
      if (!(avoid & MAGGI_KEEP_POSITION) || !d->position_given[i])
        d->q[i] = d->dqs[i] + spread * scattered(&seed);
    status = newton(d, time, avoid, n % 2, &violation);
    if (status != MAGGI_OK) return status;
    if (violation <= d->tolerance) {
      loop = reversed_loop(d);
      if (loop < 0) return MAGGI_OK;
      reversed = loop;
    } else if (violation < least) {
      least = violation;
      memcpy(d->dus, d->q, bytes);
    }
  }
  if (reversed >= 0)
    return maggi_data_fail(d, MAGGI_E_ASSEMBLY, "loop \"%s\" closes only with its axis reversed",
                           d->m->loop[reversed].name);
  memcpy(d->q, d->dus, bytes);
  maggi_evaluate_positions(d, time);
  return fail_assembly(d, least);
}

/* The independent coordinates go to where assembly started (dqs), the others close the loops around
 * them; false, and left as assembled, where that cannot be done. */
int maggi_settle(maggi_data *d, double time)
{
  const maggi_topo *t = &d->t;
  double violation = INFINITY;
  int i, n;

  memcpy(d->dus, d->q, (size_t)t->nq * sizeof(double));
  for (i = 0; i < t->nind; ++i) d->q[t->colq[i]] = d->dqs[t->colq[i]];
  maggi_evaluate_positions(d, time);
  for (n = 0; n < MAGGI_CLOSING_ITERATIONS; ++n) {
    violation = maggi_violation(d);
    if (!(violation > maggi_roundoff(d))) break;
    maggi_evaluate_factors(d);
    maggi_close_step(d);
    if (!(maggi_close_size(d) < assembly_step)) break;
    maggi_close_begin(d);
    maggi_close_move(d, 1.0);
    maggi_evaluate_positions(d, time);
  }
  if (violation <= d->tolerance) return 1;
  memcpy(d->q, d->dus, (size_t)t->nq * sizeof(double));
  maggi_evaluate_positions(d, time);
  return 0;
}
