/* Which states of a simulation are kept so that its steps can be gone through backwards with few of
 * them: the binomial schedule, the fewest steps for l steps and c states kept at a time.
 *
 * t(l, c) of them reverse l steps from a state that is kept in one of c slots: m steps to a state that
 * takes the next slot, what lies behind it with the slots that are left, what lies before it with all
 *
 *   t(l, c) = min over m of m + t(l - m, c - 1) + t(m, c),   t(1, c) = 0,   t(l, 1) = l (l - 1)/2
 *           = r l - C(c + r, c + 1),                        C(c + r - 1, c) < l <= C(c + r, c)     [1]
 *
 * where no step is done more than r times; r = 1 when c >= l - 1: nothing is computed twice.  With
 * b(c, r) = C(c + r, c), m is best while
 *
 *   b(c, r - 2) <= m <= b(c, r - 1)   and   b(c - 1, r - 1) <= l - m <= b(c - 1, r)
 *
 * [1] A. Griewank, A. Walther, Evaluating Derivatives, SIAM 2008, chapter 12. */
#ifndef MAGGI_CHECKPOINT_H
#define MAGGI_CHECKPOINT_H

#include "maggi/maggi.h"

/*   STORE    the present state, of step `from`, into `slot`
 *   RESTORE  the state of step `from` from `slot`, which may be filled again after it
 *   ADVANCE  steps `from` .. `to` - 1
 *   REVERSE  step `from`, whose state is present: do it with its stages kept and go back through it.
 *            The first is that of the last step, which has not been done before
 *   DONE     all steps have been reversed */
typedef enum maggi_schedule_action {
  MAGGI_SCHEDULE_STORE,
  MAGGI_SCHEDULE_ADVANCE,
  MAGGI_SCHEDULE_RESTORE,
  MAGGI_SCHEDULE_REVERSE,
  MAGGI_SCHEDULE_DONE
} maggi_schedule_action;

typedef struct maggi_schedule {
  int slot;      /* of the last action */
  long from, to; /* of the last action, numbers of states */
  int slots;     /* snapshots, no more than there are uses for */
  int used;      /* slots 0 .. used - 1 hold the states .. */
  long *kept;    /* .. of these numbers, rising */
  long present;  /* state; -1: none, after a reversal */
  long end;      /* steps that have not been reversed */
} maggi_schedule;

/* 1 <= steps <= 1e9, snapshots >= 1; the state of step 0 is present.  MAGGI_OK, MAGGI_E_MEMORY */
maggi_status maggi_schedule_init(maggi_schedule *s, long steps, int snapshots);
maggi_schedule_action maggi_schedule_next(maggi_schedule *s);
void maggi_schedule_free(maggi_schedule *s);

/* steps of all ADVANCE of the schedule */
long long maggi_schedule_cost(long steps, int snapshots);

#endif
