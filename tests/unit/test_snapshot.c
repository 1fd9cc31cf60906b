/* core/dynamics/snapshot.c: from a snapshot a simulation goes on bit by bit as it did before, also with
 * another workspace in between, past changes of coordinates and next to singular positions. */
#include "data.h"
#include "fixture.h"

typedef struct trace {
  double *x; /* (steps x (3 coordinates + filters)) */
  long changes, between;
} trace;

/* takes steps from the present state; where `x` was, compares instead */
static void follow(maggi_data *d, double h, int steps, trace *t, int is_again)
{
  int n = d->m->ncoordinate, row = 3 * n + d->t.nfilter, k, same = 0;
  size_t bytes = (size_t)row * sizeof(double);
  double *x = malloc(bytes + 1);

  for (k = 0; k < steps; ++k) {
    CHECK(maggi_step(d, h) == MAGGI_OK);
    maggi_get_coordinates(d, x, x + n, x + 2 * n);
    maggi_get_filters(d, x + 3 * n);
    if (!is_again)
      memcpy(t->x + row * k, x, bytes);
    else
      same += memcmp(t->x + row * k, x, bytes) == 0;
    t->between += d->is_ahead;
  }
  if (is_again) CHECK(same == steps);
  t->changes = d->changes;
  free(x);
}

static trace check_model(maggi_model *m, double h, int before, int after)
{
  maggi_data *d = test_start(m);
  size_t size = maggi_snapshot_size(&d->t);
  char *memory = malloc(size);
  trace t = {0}, again = {0};

  CHECK(size % sizeof(double) == 0);
  t.x = calloc((size_t)(after * (3 * d->m->ncoordinate + d->t.nfilter)) + 1, sizeof(double));
  again.x = t.x;
  test_step(d, h, before);
  maggi_snapshot_save(d, memory);
  follow(d, h, after, &t, 0);
  CHECK(maggi_snapshot_load(d, memory) == MAGGI_OK);
  follow(d, h, after, &again, 1);
  /* from a state that has nothing to do with it */
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  test_step(d, 0.3 * h, 3);
  CHECK(maggi_snapshot_load(d, memory) == MAGGI_OK);
  follow(d, h, after, &again, 1);
  free(t.x);
  free(memory);
  maggi_data_free(d);
  maggi_model_free(m);
  return t;
}

/* a reset forgets what a simulation has left */
static void test_repeated_reset(void)
{
  maggi_model *m = test_file("triple-pendulum-closed.yaml");
  maggi_data *d = test_start(m);
  trace t = {0};

  t.x = calloc((size_t)(700 * 3 * d->m->ncoordinate), sizeof(double));
  follow(d, 0.004, 700, &t, 0);
  CHECK(t.changes > 0);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  follow(d, 0.004, 700, &t, 1);
  free(t.x);
  maggi_data_free(d);
  maggi_model_free(m);
}

int main(void)
{
  maggi_model *m;
  trace t;

  check_model(test_file("double-pendulum.yaml"), 0.01, 7, 20);
  check_model(test_file("seat-shaker.yaml"), 0.002, 50, 100);
  t = check_model(test_file("rssr.yaml"), 0.002, 100, 400);
  CHECK(t.changes > 0);
  t = check_model(test_file("triple-pendulum-closed.yaml"), 0.002, 3, 300);
  CHECK(t.changes > 0);
  /* rows that lie flat */
  CHECK(maggi_model_multiple_four_bar(1, 15, &m) == MAGGI_OK);
  t = check_model(m, 0.002, 720, 1000);
  CHECK(t.between > 0);
  test_repeated_reset();
  return check_done();
}
