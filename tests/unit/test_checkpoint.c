/* core/sensitivity/checkpoint.c: the schedule carried out on numbers of states, and its cost. */
#include "checkpoint.h"

#include "check.h"

enum { STEPS = 60, SNAPSHOTS = 12 };

/* what the actions of a schedule have made of the slots and the present state */
typedef struct tape {
  long steps;
  int snapshots;
  long *slot; /* number of the state in it, -1: none */
  long present, reversed;
  long long advanced;
} tape;

static int is_slot(const tape *t, const maggi_schedule *s)
{
  return s->slot >= 0 && s->slot < t->snapshots;
}

/* false: something is wrong, and the schedule no further worth while */
static int carry_out(tape *t, maggi_schedule_action action, const maggi_schedule *s)
{
  switch (action) {
  case MAGGI_SCHEDULE_STORE:
    if (!CHECK(is_slot(t, s) && s->from == t->present)) return 0;
    t->slot[s->slot] = t->present;
    return 1;
  case MAGGI_SCHEDULE_RESTORE:
    if (!CHECK(is_slot(t, s) && s->from >= 0 && t->slot[s->slot] == s->from)) return 0;
    t->present = s->from;
    return 1;
  case MAGGI_SCHEDULE_ADVANCE:
    if (!CHECK(s->from == t->present && s->to > s->from && s->to < t->steps)) return 0;
    t->present = s->to;
    t->advanced += s->to - s->from;
    return 1;
  case MAGGI_SCHEDULE_REVERSE:
    ++t->reversed;
    if (!CHECK(s->from == t->present && s->from == t->steps - t->reversed)) return 0;
    t->present = -1;
    return 1;
  default:
    CHECK(t->reversed == t->steps);
    return 0;
  }
}

static long long run(long steps, int snapshots)
{
  tape t = {.steps = steps, .snapshots = snapshots};
  maggi_schedule s;
  int i;

  t.slot = malloc((size_t)snapshots * sizeof *t.slot);
  for (i = 0; i < snapshots && t.slot; ++i) t.slot[i] = -1;
  if (!CHECK(t.slot && maggi_schedule_init(&s, steps, snapshots) == MAGGI_OK)) exit(1);
  while (carry_out(&t, maggi_schedule_next(&s), &s)) continue;
  CHECK(maggi_schedule_next(&s) == MAGGI_SCHEDULE_DONE && t.reversed == steps);
  maggi_schedule_free(&s);
  free(t.slot);
  return t.advanced;
}

/* the fewest steps, by trying all ways to take the next snapshot */
static void test_optimal(void)
{
  static long long t[STEPS + 1][SNAPSHOTS + 1];
  long long best;
  int l, c, m;

  for (c = 1; c <= SNAPSHOTS; ++c) {
    for (l = 1; l <= STEPS; ++l) {
      best = l * (l - 1) / 2;
      for (m = 1; m < l && c > 1; ++m)
        if (m + t[l - m][c - 1] + t[m][c] < best) best = m + t[l - m][c - 1] + t[m][c];
      t[l][c] = best;
      CHECK(maggi_schedule_cost(l, c) == best);
      CHECK(run(l, c) == best);
    }
  }
}

static void test_long(void)
{
  static const struct {
    long steps;
    int snapshots;
    long long cost; /* r l - C(c + r, c + 1) */
  } cases[] = {
      {1000, 20, 2747},        /* 3 1000 - C(23, 21) */
      {1000, 1, 499500},       /* 999 1000 - C(1000, 2) */
      {1000, 999, 999},        /* 1 1000 - C(1000, 1000) */
      {1000, 1000, 999},       /* the same */
      {1000000, 100, 3817896}, /* 4 1000000 - C(104, 101) */
      {100000, 3, 6176445},    /* 83 100000 - C(86, 4) */
  };
  size_t i;

  for (i = 0; i < sizeof cases / sizeof *cases; ++i) {
    CHECK(maggi_schedule_cost(cases[i].steps, cases[i].snapshots) == cases[i].cost);
    CHECK(run(cases[i].steps, cases[i].snapshots) == cases[i].cost);
  }
}

/* the most steps, where products do not fit into 64 bits: cost, and the way to the first reversal */
static void test_overflow(void)
{
  static const long steps = 1000000000;
  static const struct {
    int snapshots;
    long long cost;
  } cases[] = {
      {1, 499999999500000000}, {2, 29813239704560}, {5, 134487980289},
      {1000, 3831828996},      {44721, 1999955277},
  };
  maggi_schedule s;
  maggi_schedule_action action;
  size_t i;
  long stored;

  for (i = 0; i < sizeof cases / sizeof *cases; ++i) {
    CHECK(maggi_schedule_cost(steps, cases[i].snapshots) == cases[i].cost);
    if (!CHECK(maggi_schedule_init(&s, steps, cases[i].snapshots) == MAGGI_OK)) exit(1);
    stored = 0;
    while ((action = maggi_schedule_next(&s)) != MAGGI_SCHEDULE_REVERSE) {
      stored += action == MAGGI_SCHEDULE_STORE;
      if (action == MAGGI_SCHEDULE_ADVANCE && !CHECK(s.from < s.to && s.to < steps)) exit(1);
    }
    CHECK(s.from == steps - 1 && stored == cases[i].snapshots);
    maggi_schedule_free(&s);
  }
  CHECK(maggi_schedule_cost(steps, 999999999) == steps - 1);
  CHECK(maggi_schedule_cost(steps, 2000000000) == steps - 1);
}

int main(void)
{
  test_optimal();
  test_long();
  test_overflow();
  return check_done();
}
