/* Arguments of heads by name: those of a real evaluation, or random numbers of a sensible size.
 *
 * A random argument is the same for all heads that ask for it.  What must be so for a formula to make
 * sense is so: knots of functions ascend, lengths are positive, and the arguments keep away from where
 * a formula has a kink, so that central differences see none.
 */
#ifndef MAGGI_TESTS_INPUTS_H
#define MAGGI_TESTS_INPUTS_H

#include "data.h"
#include "property/mechanism.h"

/* how far kinks are at least, in the units of what decides */
#define INPUTS_MARGIN 0.02

enum { INPUTS_MAX = 48 };

typedef struct inputs {
  const maggi_topo *t;
  const maggi_data *d; /* of a real evaluation; NULL: random */
  mech_random random;
  int number;
  struct {
    const char *name;
    int n;
    double *x;
  } input[INPUTS_MAX];
} inputs;

void inputs_real(inputs *in, const maggi_data *d);
void inputs_random(inputs *in, const maggi_topo *t, uint64_t seed);
void inputs_free(inputs *in);

/* argument of n numbers; NULL when a real evaluation has none of this name */
const double *inputs_get(inputs *in, const char *name, int n);

#endif
