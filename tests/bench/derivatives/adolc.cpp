/* The forces of the open chain on a tape of ADOL-C. */
#include <string.h>

#include <algorithm>
#include <vector>

#include <adolc/adolc.h>

#include "chain_tape.h"
#include "problem.h"

struct chain_tape {
  short tag;
  int n, directions; /* directions a sweep */
  long operations;
  std::vector<double> y;
  std::vector<double *> seed, product;
};

namespace
{
typedef adouble real;
#define MAGGI_RE(x) (x).value() /* a comparison need not go on the chain_tape */
#include "evaluation.inc"

/* memcpy would copy the addresses of numbers */
template <typename row> void copy_rows(row *to, const row *from, size_t n)
{
  std::copy_n((const real *)from, n * sizeof(row) / sizeof(real), (real *)to);
}

#include "chain.inc"

/* entries of the buffers, so many that no tape goes to a file */
const unsigned buffer = 1u << 24;

/* Directions a sweep: as many as have the tangents of all locations in the caches, and at least so many.  The
 * drivers of ADOL-C take all at once, which is slower by 1.3 for 60 of them and by 2.5 for 450. */
const size_t fits = (size_t)1 << 19, least = 16;

/* what forces need: all numbers alive go on a chain_tape */
const char *const arrays[] = {
    "offset0", "axis0", "body0", "point0", "dir0", "spline0", "fun", "turn", "A",   "x",
    "b",       "r",     "dir",   "Z",      "Z0",   "rv",      "I",   "Q",    "Za",  "ra",
    "Fr",      "FSr",   "p",     "prim0",  "res",  "spring0", "q",   "v",    "tau", "w"};

bool is_needed(const char *name)
{
  return std::any_of(std::begin(arrays), std::end(arrays),
                     [name](const char *array) { return strcmp(array, name) == 0; });
}

maggi_data *create_chain(const problem *of)
{
  maggi_data *d = new maggi_data;
  const maggi_topo *t = &d->t;

  d->m = of;
  d->t = *of->t;
#define X(name, rows, cols, text)                                                                  \
  d->name = is_needed(#name) ? rows_of_zeros<real[cols]>(size_of(#rows, t), cols) : NULL;
  MAGGI_DATA_LIST(X)
#undef X
#define X(name, size, text)                                                                        \
  d->name = is_needed(#name) ? rows_of_zeros<real>(size_of(#size, t), 1) : NULL;
  MAGGI_DATA_VECTORS(X)
#undef X
#define X(name, size, text) d->name = NULL;
  MAGGI_PLAN_VECTORS(X)
#undef X
  return d;
}
/* where it stands; constants are numbers of the tape, not operations */
void record(chain_tape *self, const chain_state *at)
{
  const problem of = {NULL, at->t, at->originadr, NULL, 0.0, 0, 0, NULL};
  maggi_data *d = create_chain(&of);
  int i, n = at->n, nq = at->t->nq;

  for (i = 0; i < at->t->np; ++i) d->p[i] = at->p[i];
  for (i = 0; i < nq; ++i) d->q[i] = at->q[i];
  for (i = 0; i < nq; ++i) d->v[i] = at->v[i];
  maggi_constants(d);
  trace_on(self->tag, 0, buffer, buffer, buffer, buffer);
  for (i = 0; i < n; ++i) d->q[at->free[i]] <<= at->q[at->free[i]];
  for (i = 0; i < n; ++i) d->v[at->free[i]] <<= at->v[at->free[i]];
  maggi_chain_forces(d, 0.0);
  for (i = 0; i < n; ++i) d->w[at->free[i]] >>= self->y[i];
  trace_off();
  destroy(d);
}
} // namespace

extern "C" chain_tape *tape_record(const chain_state *at)
{
  chain_tape *self = new chain_tape;
  size_t counts[STAT_SIZE];

  self->tag = 1;
  self->n = at->n;
  self->y.resize(at->n);
  self->seed.resize(2 * at->n);
  self->product.resize(at->n);
  record(self, at);
  tapestats(self->tag, counts);
  self->operations = (long)counts[NUM_OPERATIONS];
  self->directions = (int)std::max(fits / counts[NUM_MAX_LIVES], least);
  return self;
}

extern "C" void tape_free(chain_tape *of)
{
  delete of;
}

extern "C" long tape_operations(const chain_tape *of)
{
  return of->operations;
}

extern "C" void tape_product(chain_tape *of, const double *x, int directions, const double *seed,
                             double *product)
{
  int first, i, n;

  for (first = 0; first < directions; first += n) {
    n = std::min(of->directions, directions - first);
    for (i = 0; i < 2 * of->n; ++i) of->seed[i] = (double *)seed + (size_t)i * directions + first;
    for (i = 0; i < of->n; ++i) of->product[i] = product + (size_t)i * directions + first;
    fov_forward(of->tag, of->n, 2 * of->n, n, x, of->seed.data(), of->y.data(), of->product.data());
  }
}
