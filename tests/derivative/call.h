/* One call of a head: its arguments before and after, and what its derivatives make of them.
 *
 * All active arguments are one list: a head maps their values before the call to those after it, x to
 * y, where inputs stay as they are.  What a head does not write it passes on, and so do its tangent,
 * x' to y', and its adjoint, y_ to x_; where it writes, the adjoint is zero afterwards.
 */
#ifndef MAGGI_TESTS_CALL_H
#define MAGGI_TESTS_CALL_H

#include "heads.h"
#include "inputs.h"

enum { CALL_ARGUMENTS = 20 };

/* numbers for each argument of a head */
typedef struct arguments {
  double *of[CALL_ARGUMENTS];
} arguments;

typedef struct call {
  const maggi_head *head;
  const maggi_topo *t;
  int index; /* of the head, by which reference.h knows it */
  mech_random random;
  arguments x, y;                /* before the call and after it */
  char *written[CALL_ARGUMENTS]; /* what the call writes and does not add to */
} call;

/* 0 when there are no numbers for an argument of this name */
int call_create(call *c, const maggi_head *head, int index, inputs *in, uint64_t seed);
/* the same call with relative changes of up to CALL_TREMOR in its arguments: what cancels in it */
#define CALL_TREMOR 1e-6
call call_shaken(call *c);
void call_free(call *c);

int call_size(const call *c, int i);
int call_is_active(const call *c, int i);
int call_is_output(const call *c, int i); /* written, not added to */

/* `width` numbers for each number of each argument, zeroed, on cache lines */
arguments arguments_create(const call *c, int width);
void arguments_free(const call *c, arguments *a);
void arguments_copy(const call *c, const arguments *from, arguments *to);
void arguments_random(call *c, double scale, arguments *a); /* the active ones */
void arguments_shake(call *c, const arguments *from, arguments *to);
/* sum of products of the active ones; adds their sizes to *terms */
double arguments_dot(const call *c, const arguments *a, const arguments *b, double *terms);
/* Largest difference of the active ones, the second ones right, relative to the largest number of an
 * array, or a thousandth of the largest one of all.  shaken: the second ones again, of the shaken
 * call: a tenth of the change by a relative one of the arguments is added to the size; or NULL. */
double arguments_distance(const call *c, const arguments *a, const arguments *b,
                          const arguments *shaken);

/* y at x + h x' */
void call_evaluate(const call *c, double h, const arguments *xd, arguments *y);
/* y'; of several directions when they have MAGGI_NDIR numbers for each one */
void call_tangent(const call *c, const arguments *xd, arguments *yd);
void call_tangents(const call *c, const arguments *xdv, arguments *ydv);
/* x_ */
void call_adjoint(const call *c, const arguments *yb, arguments *xb);
/* x_ and its tangent along x', y' as call_tangent gives it, and along the one of y_ */
void call_second(const call *c, const arguments *yd, const arguments *yb, const arguments *ybd,
                 arguments *xb, arguments *xbd);

/* the same by complex step, with values */
void call_complex_tangent(const call *c, const arguments *xd, arguments *y, arguments *yd);
void call_complex_second(const call *c, const arguments *xd, const arguments *yb,
                         const arguments *ybd, arguments *xb, arguments *xbd);

#endif
