/* Many threads simulate one model, each with its own data, some of them build and load models of
 * their own: what they get is bit by bit what one thread gets.  Also run under ThreadSanitizer. */
#include <pthread.h>

#include "fixture.h"

enum { THREADS = 12, STEPS = 300, ROUNDS = 2 };

typedef struct task {
  const maggi_model *m;
  double stiffness; /* of one spring: no two threads the same */
  int loads;        /* also loads a model */
  test_state state;
  double sensors[TEST_COLUMNS_MAX], reactions[TEST_COORDINATES_MAX * 6];
  maggi_energy energy;
  maggi_loop_state loops;
  maggi_status status;
} task;

static const char text[] =
    "gravity: [0.2, -0.5, -9.81]\n"
    "bodies:\n"
    "- {name: crank, mass: 1, cog: [0, 0.1, 0.2], inertia: {xx: 0.1, yy: 0.1, zz: 0.1},"
    " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0]}}\n"
    "- {name: coupler, parent: crank, mass: 0.8, cog: [0.5, 0.5, 0.5], inertia: {xx: 0.2, yy: 0.2,"
    " zz: 0.2}, joint: {type: universal, point: [0, 0, 0.4], axis: [1, 0, 0], axis2: [0, 1, 0]}}\n"
    "- {name: rocker, mass: 1.2, bar: {from: [1, 1, -0.5], to: [1, 1, 0.6]},"
    " joint: {type: revolute, point: [1, 1, -0.5], axis: [0, 1, 0.2]}}\n"
    "loops: [{name: l, type: spherical, body_a: coupler, body_b: rocker, point: [1, 1, 0.6]}]\n"
    "springs: [{name: s, body_a: crank, body_b: rocker, point_a: [0, 0, 0.4], point_b: [1, 1, 0],"
    " stiffness: 30, preload: 2, damping: 3}]\n"
    "functions: [{name: f, type: spline, times: [0, 0.1, 0.3, 0.5], values: [0, 3, -2, 1]}]\n"
    "forces: [{name: f, type: joint, coordinate: crank, effort: 2, function: f}]\n"
    "sensors: [{name: s, type: acceleration, body: coupler, point: [1, 1, 0.6]}]\n";

static void *run(void *argument)
{
  task *t = argument;
  maggi_model *own = NULL;
  maggi_data *d = NULL;
  char message[256];
  int i, index = maggi_parameter_find(t->m, "springs.s.stiffness");

  if (t->loads) {
    t->status = maggi_model_load_memory("x", text, 40, &own, message, sizeof message);
    if (t->status == MAGGI_OK || own || !*message) {
      t->status = MAGGI_E_MODEL;
      return NULL;
    }
    t->status = maggi_model_multiple_four_bar(2, 2, &own);
    maggi_model_free(own);
    if (t->status != MAGGI_OK) return NULL;
  }
  t->status = maggi_data_create(t->m, &d);
  if (t->status == MAGGI_OK && index >= 0)
    t->status = maggi_data_set_parameter(d, index, t->stiffness);
  if (t->status == MAGGI_OK) t->status = maggi_data_reset(d);
  for (i = 0; i < STEPS && t->status == MAGGI_OK; ++i) t->status = maggi_step(d, 2e-3);
  if (t->status == MAGGI_OK) {
    maggi_get_coordinates(d, t->state.q, t->state.v, t->state.a);
    maggi_get_sensors(d, t->sensors);
    maggi_get_reactions(d, t->reactions);
    maggi_get_energy(d, &t->energy);
    maggi_get_loop_state(d, &t->loops);
  }
  maggi_data_free(d);
  return NULL;
}

static int same(const task *a, const task *b)
{
  return a->status == MAGGI_OK && b->status == MAGGI_OK &&
         memcmp(&a->state, &b->state, sizeof a->state) == 0 &&
         memcmp(a->sensors, b->sensors, sizeof a->sensors) == 0 &&
         memcmp(a->reactions, b->reactions, sizeof a->reactions) == 0 &&
         memcmp(&a->energy, &b->energy, sizeof a->energy) == 0 &&
         a->loops.evaluations == b->loops.evaluations && a->loops.changes == b->loops.changes &&
         a->loops.projections == b->loops.projections && a->loops.violation == b->loops.violation;
}

static void test_model_in_threads(const maggi_model *m)
{
  static task serial[THREADS], parallel[THREADS];
  pthread_t thread[THREADS];
  int i, round;

  memset(serial, 0, sizeof serial);
  for (i = 0; i < THREADS; ++i) {
    serial[i].m = m;
    serial[i].stiffness = 10.0 + 5.0 * i;
    run(&serial[i]);
    CHECK(serial[i].status == MAGGI_OK);
  }
  for (round = 0; round < ROUNDS; ++round) {
    memset(parallel, 0, sizeof parallel);
    for (i = 0; i < THREADS; ++i) {
      parallel[i].m = m;
      parallel[i].stiffness = serial[i].stiffness;
      parallel[i].loads = i % 3 == 0;
      if (!CHECK(pthread_create(&thread[i], NULL, run, &parallel[i]) == 0)) exit(1);
    }
    for (i = 0; i < THREADS; ++i) CHECK(pthread_join(thread[i], NULL) == 0);
    for (i = 0; i < THREADS; ++i) CHECK(same(&serial[i], &parallel[i]));
  }
  /* and the stiffness matters, so that the results are not all one */
  if (maggi_parameter_find(m, "springs.s.stiffness") >= 0) CHECK(!same(&serial[0], &serial[1]));
}

int main(void)
{
  maggi_model *m = test_model("%s", text);

  test_model_in_threads(m);
  maggi_model_free(m);
  CHECK(maggi_model_multiple_four_bar(3, 2, &m) == MAGGI_OK);
  test_model_in_threads(m);
  maggi_model_free(m);
  return check_done();
}
