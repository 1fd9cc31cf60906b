/* Many threads differentiate simulations of one model, each with its own data: what they get is bit by
 * bit what one thread gets.  Also run under ThreadSanitizer. */
#include <pthread.h>

#include "fixture.h"

enum { THREADS = 8, STEPS = 40, N = 11, COORDINATES_MAX = 32, PARAMETERS_MAX = 512 };

typedef struct result {
  double v[COORDINATES_MAX * N], a[COORDINATES_MAX * N];                                 /* jac */
  double q_bar[COORDINATES_MAX], v_bar[COORDINATES_MAX], p_bar[PARAMETERS_MAX];          /* vjp */
  double q_second[COORDINATES_MAX], v_second[COORDINATES_MAX], p_second[PARAMETERS_MAX]; /* hvp */
} result;

typedef struct task {
  const maggi_model *m;
  double gravity; /* no two threads the same */
  maggi_status status;
  result result;
  double q[COORDINATES_MAX * N], p[PARAMETERS_MAX * N]; /* directions */
} task;

/* all kinds of derivatives, each with what the one before gave */
static void differentiate(task *t, maggi_derivative *D)
{
  result *r = &t->result;

  t->status = maggi_linearise(D);
  if (t->status != MAGGI_OK) return;
  maggi_motion_jac(D, N, t->q, t->q, t->p, r->v, r->a);
  maggi_motion_vjp(D, r->v, r->a, r->q_bar, r->v_bar, r->p_bar);
  maggi_motion_hvp(D, r->v, r->a, r->q_bar, r->v_bar, r->p_bar, r->q_second, r->v_second,
                   r->p_second);
}

static void *run(void *argument)
{
  task *t = argument;
  maggi_data *d = NULL;
  maggi_derivative *D = NULL;
  unsigned long long seed = 17;
  int i;

  for (i = 0; i < COORDINATES_MAX * N; ++i) t->q[i] = random11(&seed);
  for (i = 0; i < PARAMETERS_MAX * N; ++i) t->p[i] = random11(&seed);
  t->status = maggi_data_create(t->m, &d);
  if (t->status == MAGGI_OK)
    t->status = maggi_data_set_parameter(d, maggi_parameter_find(t->m, "gravity.z"), t->gravity);
  if (t->status == MAGGI_OK) t->status = maggi_data_reset(d);
  if (t->status == MAGGI_OK) t->status = maggi_derivative_create(d, N, &D);
  for (i = 0; i < STEPS && t->status == MAGGI_OK; ++i) {
    t->status = maggi_step(d, 2e-3);
    if (t->status == MAGGI_OK) differentiate(t, D);
  }
  maggi_derivative_free(D);
  maggi_data_free(d);
  return NULL;
}

static int same(const task *a, const task *b)
{
  return a->status == MAGGI_OK && b->status == MAGGI_OK &&
         memcmp(&a->result, &b->result, sizeof a->result) == 0;
}

int main(void)
{
  static task serial[THREADS], parallel[THREADS];
  pthread_t thread[THREADS];
  maggi_model *m;
  int i;

  CHECK(maggi_model_multiple_four_bar(2, 3, &m) == MAGGI_OK);
  CHECK(test_coordinates(m) <= COORDINATES_MAX);
  CHECK(maggi_parameter_path(m, PARAMETERS_MAX) == NULL);
  for (i = 0; i < THREADS; ++i) {
    serial[i].m = parallel[i].m = m;
    serial[i].gravity = parallel[i].gravity = -5.0 - i;
    run(&serial[i]);
    CHECK(serial[i].status == MAGGI_OK);
  }
  for (i = 0; i < THREADS; ++i)
    if (!CHECK(pthread_create(&thread[i], NULL, run, &parallel[i]) == 0)) exit(1);
  for (i = 0; i < THREADS; ++i) CHECK(pthread_join(thread[i], NULL) == 0);
  for (i = 0; i < THREADS; ++i) CHECK(same(&serial[i], &parallel[i]));
  CHECK(!same(&serial[0], &serial[1]));
  maggi_model_free(m);
  return check_done();
}
