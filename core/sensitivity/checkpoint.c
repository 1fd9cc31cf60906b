/* The schedule as a stack of kept states, the last of them where the next steps are to be reversed. */
#include "checkpoint.h"

#include <assert.h>
#include <stdlib.h>

/* b(c, r + 1) of b(c, r), or `most` if it is more */
static long long next_binomial(long long b, long long c, long long r, long long most)
{
  long long n = c + r + 1, k = r + 1;

  if (b / k > most / n) return most;
  b = b / k * n + b % k * n / k;
  return b < most ? b : most;
}

/* r with b(c, r - 1) < l <= b(c, r), for l >= 2, and last = b(c, r - 1) */
static long long repetitions(long long l, long long c, long long *last)
{
  long long r = 0, b = 1;

  do {
    *last = b;
    b = next_binomial(b, c, r++, l);
  } while (b < l);
  return r;
}

/* the largest of the best m */
static long split(long l, int c)
{
  long long last, r = repetitions(l, c, &last);
  long long behind = last * c / (c + r - 1); /* b(c - 1, r - 1) */

  return (long)(last < l - behind ? last : l - behind);
}

static int useful(long steps, int snapshots)
{
  return snapshots < steps ? snapshots : (int)steps;
}

maggi_status maggi_schedule_init(maggi_schedule *s, long steps, int snapshots)
{
  assert(steps >= 1 && steps <= 1000000000 && snapshots >= 1);
  *s = (maggi_schedule){.slots = useful(steps, snapshots), .end = steps};
  s->kept = malloc((size_t)s->slots * sizeof *s->kept);
  return s->kept ? MAGGI_OK : MAGGI_E_MEMORY;
}

void maggi_schedule_free(maggi_schedule *s)
{
  free(s->kept);
}

static maggi_schedule_action store(maggi_schedule *s)
{
  s->slot = s->used++;
  s->from = s->kept[s->slot] = s->present;
  return MAGGI_SCHEDULE_STORE;
}

/* the last one, which is not needed any more when its own step comes next */
static maggi_schedule_action restore(maggi_schedule *s)
{
  s->slot = s->used - 1;
  s->from = s->present = s->kept[s->slot];
  s->used -= s->present == s->end - 1;
  return MAGGI_SCHEDULE_RESTORE;
}

static maggi_schedule_action advance(maggi_schedule *s)
{
  long l = s->end - s->present;
  int c = s->slots - s->used + 1;

  s->from = s->present;
  s->to = s->present += c > 1 ? split(l, c) : l - 1;
  return MAGGI_SCHEDULE_ADVANCE;
}

static maggi_schedule_action reverse(maggi_schedule *s)
{
  s->from = --s->end;
  s->to = s->end + 1;
  s->present = -1;
  return MAGGI_SCHEDULE_REVERSE;
}

maggi_schedule_action maggi_schedule_next(maggi_schedule *s)
{
  if (s->end == 0) return MAGGI_SCHEDULE_DONE;
  if (s->present < 0) return restore(s);
  if (s->present == s->end - 1) return reverse(s);
  if (s->used == 0 || s->kept[s->used - 1] < s->present) return store(s);
  return advance(s);
}

long long maggi_schedule_cost(long steps, int snapshots)
{
  long long l = steps, c = useful(steps, snapshots), last, r;

  if (l < 2) return 0;
  if (c == 1) return l * (l - 1) / 2;
  r = repetitions(l, c, &last);
  return r * l - last * (c + r) / (c + 1); /* b(c + 1, r - 1) */
}
