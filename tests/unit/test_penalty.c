/* core/implicit/penalty.c, tangent_matrix.c: tables 4.4 and 4.5 of [1], order 2 against the Maggi
 * formulation and against the reference T6, the ways to the Jacobian, what goes wrong. */
#include "machine.h"
#include "penalty.h"

static maggi_model *array(int ny, int nz)
{
  maggi_model *m = NULL;

  if (!CHECK(maggi_model_multiple_four_bar(ny, nz, &m) == MAGGI_OK)) exit(1);
  return m;
}

static maggi_penalty *create(maggi_data *d, const maggi_penalty_options *o)
{
  maggi_penalty *s = NULL;

  if (!CHECK(maggi_penalty_create(d, o, &s) == MAGGI_OK)) {
    fprintf(stderr, "%s\n", maggi_data_message(d));
    exit(1);
  }
  return s;
}

/* after a reset */
static maggi_penalty *start(maggi_data *d, const maggi_penalty_options *o)
{
  maggi_penalty *s = create(d, o);

  if (!CHECK(maggi_penalty_reset(s) == MAGGI_OK)) fprintf(stderr, "%s\n", maggi_data_message(d));
  return s;
}

static void step(maggi_penalty *s, double h, long n)
{
  while (n-- > 0) {
    if (CHECK(maggi_penalty_step(s, h) == MAGGI_OK)) continue;
    fprintf(stderr, "%s\n", maggi_data_message(s->d));
    return;
  }
}

static maggi_penalty_state state_of(const maggi_penalty *s)
{
  maggi_penalty_state state;

  maggi_penalty_get_state(s, &state);
  return state;
}

static maggi_penalty_options defaults(void)
{
  maggi_penalty_options o;

  maggi_penalty_options_init(&o);
  return o;
}

/* ------------------------------------------------------------------- tables 4.4 and 4.5 of [1] */

static void check_numbers(maggi_model *m, int n, int nonzeros, int colours)
{
  maggi_data *d = test_data(m);
  maggi_penalty_options o = defaults();
  maggi_penalty *s;
  int way, coloured;

  CHECK(test_coordinates(m) == n);
  for (way = 0; way < MAGGI_JACOBIAN_COUNT; ++way) {
    o.jacobian = (maggi_jacobian)way;
    s = create(d, &o);
    coloured = strstr(maggi_jacobian_name(o.jacobian), "coloured") != NULL;
    CHECK(state_of(s).nonzeros == nonzeros);
    CHECK(state_of(s).colours == (coloured ? colours : 2 * n));
    maggi_penalty_free(s);
  }
  test_free(d, m);
}

/* five seconds: extreme of (E - E_0) / |E_0| in per cent.  The potential datum of the array is at
 * the top joints, as in [1]. */
static double drift(maggi_penalty *s, double h)
{
  double e0 = test_energy(s->d), x, worst = 0.0;
  long k, steps = lround(5.0 / h);

  for (k = 0; k < steps; ++k) {
    step(s, h, 1);
    x = 100.0 * (test_energy(s->d) - e0) / fabs(e0);
    worst = fabs(x) > fabs(worst) ? x : worst;
  }
  return worst;
}

/* drift and number of Jacobians, between the bounds; those of [1] are 0.000, 0.015, 0.057 and 5000,
 * 500, 275 to 287 */
static void check_drift(int ny, double h, double low, double high, long fewest, long most)
{
  maggi_model *m = array(ny, 15);
  maggi_data *d = test_data(m);
  maggi_penalty_options o = defaults();
  maggi_penalty *s = start(d, &o);
  double x = drift(s, h);
  maggi_penalty_state state = state_of(s);

  if (!CHECK(x >= low && x <= high)) fprintf(stderr, "  %dx15, %g s: drift %.5f %%\n", ny, h, x);
  if (!CHECK(state.jacobians >= fewest && state.jacobians <= most))
    fprintf(stderr, "  %dx15, %g s: %ld Jacobians\n", ny, h, state.jacobians);
  CHECK(state.steps == lround(5.0 / h) && state.iterations >= state.jacobians);
  maggi_penalty_free(s);
  test_free(d, m);
}

static void test_tables(void)
{
  check_numbers(test_file("spatial-four-bar.yaml"), 4, 20, 6);
  check_numbers(array(1, 15), 45, 1410, 60);
  check_numbers(array(4, 15), 135, 4290, 60);
  check_numbers(array(7, 15), 225, 7170, 60);
  check_drift(1, 0.001, 0.0001, 0.0005, 5000, 5000);
  check_drift(1, 0.01, 0.0145, 0.0155, 500, 500);
  check_drift(1, 0.02, 0.0570, 0.0580, 275, 290);
  check_drift(4, 0.02, 0.0570, 0.0585, 275, 290);
  check_drift(7, 0.02, 0.0570, 0.0586, 275, 290);
}

/* absolute angles of the verticals of 1x15 at 5 s against the reference T6, which is exact in all
 * digits */
static void read_reference(double *angle)
{
  char line[2048], *at = line;
  FILE *f = fopen(MAGGI_REFERENCES_DIR "/T6_multi_fourbar/reference.csv", "r");
  int i;

  if (!CHECK(f != NULL)) exit(1);
  while (fgets(line, sizeof line, f)) continue;
  CHECK(strtod(at, &at) == 5.0);
  for (i = 0; i < 15; ++i) angle[i] = strtod(at + 1, &at);
  fclose(f);
}

static double error_of_array(const double *angle, double h)
{
  maggi_model *m = array(1, 15);
  maggi_data *d = test_data(m);
  maggi_penalty_options o = defaults();
  maggi_penalty *s = start(d, &o);
  double worst = 0.0, sum = 0.0;
  char name[32];
  test_state x;
  int i;

  step(s, h, lround(5.0 / h));
  x = test_get(d);
  for (i = 0; i < 15; ++i) {
    snprintf(name, sizeof name, "v_%d_1", i + 1);
    sum += x.q[maggi_coordinate_find(m, name)];
    worst = fmax(worst, fabs(sum - angle[i]));
  }
  maggi_penalty_free(s);
  test_free(d, m);
  return worst;
}

static void test_reference(void)
{
  double angle[15], coarse, fine;

  read_reference(angle);
  coarse = error_of_array(angle, 0.005);
  fine = error_of_array(angle, 0.0025);
  CHECK_NEAR(coarse / fine, 4.0, 0.05, 0.0);
  CHECK(fine < 1e-3);
}

/* -------------------------------------------------------- order 2 against the Maggi formulation */

typedef struct motion {
  test_state x;
  double work, drive[TEST_COORDINATES_MAX];
  double violation, rate; /* of loops, the latter relative to the largest velocity */
} motion;

static motion look(maggi_data *d)
{
  motion y = {.x = test_get(d)};
  maggi_energy e;
  const maggi_topo *t = &d->t;
  double speed = 0.0;
  int i;

  maggi_get_energy(d, &e);
  maggi_get_drives(d, y.drive);
  y.work = e.work;
  y.violation = maggi_violation(d);
  maggi_loop_rates(t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->rv, (void *)d->Z, d->rate);
  for (i = 0; i < t->nrow; ++i) y.rate = fmax(y.rate, fabs(d->rate[i]));
  for (i = 0; i < t->nq; ++i) speed = fmax(speed, fabs(d->v[i]));
  y.rate /= speed;
  return y;
}

static motion by_maggi(maggi_model *m, double time, long steps)
{
  maggi_data *d = test_start(m);
  motion y;

  test_step(d, time / (double)steps, (int)steps);
  y = look(d);
  maggi_data_free(d);
  return y;
}

static motion by_penalty(maggi_model *m, double time, long steps)
{
  maggi_data *d = test_data(m);
  maggi_penalty_options o = defaults();
  maggi_penalty *s;
  motion y;

  o.penalty = 1e11;
  o.tolerance = 1e-11;
  s = start(d, &o);
  step(s, time / (double)steps, steps);
  CHECK_NEAR(maggi_get_time(d), time, 1e-12, 0.0);
  y = look(d);
  maggi_penalty_free(s);
  maggi_data_free(d);
  return y;
}

enum { POSITIONS, VELOCITIES, ACCELERATIONS, WORK, DRIVES, KINDS };

/* distance by kinds, relative to the largest number of each */
static void distance(int n, const motion *a, const motion *b, double error[KINDS])
{
  double size[KINDS] = {0}, x[KINDS], y[KINDS];
  int i, k;

  memset(error, 0, KINDS * sizeof *error);
  for (i = 0; i < n; ++i) {
    x[0] = a->x.q[i], x[1] = a->x.v[i], x[2] = a->x.a[i], x[3] = a->work, x[4] = a->drive[i];
    y[0] = b->x.q[i], y[1] = b->x.v[i], y[2] = b->x.a[i], y[3] = b->work, y[4] = b->drive[i];
    for (k = 0; k < KINDS; ++k) {
      error[k] = fmax(error[k], fabs(x[k] - y[k]));
      size[k] = fmax(size[k], fabs(y[k]));
    }
  }
  for (k = 0; k < KINDS; ++k) error[k] /= size[k] > 0.0 ? size[k] : 1.0;
}

static void check_order(const char *name, maggi_model *m, double time, long steps)
{
  motion exact = by_maggi(m, time, 16 * steps), coarse = by_penalty(m, time, steps),
         fine = by_penalty(m, time, 2 * steps), finer = by_penalty(m, time, 4 * steps);
  double e0[KINDS], e1[KINDS], e2[KINDS];
  int n = test_coordinates(m), k;

  distance(n, &coarse, &exact, e0);
  distance(n, &fine, &exact, e1);
  distance(n, &finer, &exact, e2);
  for (k = 0; k < KINDS; ++k) {
    if (e0[k] == 0.0) continue;
    if (check_scale() == 0.0)
      printf("%s: kind %d: error %.3g, ratios %.3f %.3f\n", name, k, e0[k], e0[k] / e1[k],
             e1[k] / e2[k]);
    if (!CHECK(e1[k] / e2[k] > 3.5 && e1[k] / e2[k] < 4.5 && e2[k] < 5e-3))
      fprintf(stderr, "  %s: kind %d: %.3g %.3g %.3g\n", name, k, e0[k], e1[k], e2[k]);
  }
  if (!CHECK(fine.violation < 1e-8 && fine.rate < 1e-8))
    fprintf(stderr, "  %s: open by %.3g, at %.3g\n", name, fine.violation, fine.rate);
  maggi_model_free(m);
}

static void test_order(void)
{
  check_order("double-pendulum", test_file("double-pendulum.yaml"), 1.0, 200);
  check_order("slider-crank", test_file("slider-crank.yaml"), 0.5, 25);
  check_order("rssr", test_file("rssr.yaml"), 0.5, 100);
  check_order("triple-pendulum-closed", test_file("triple-pendulum-closed.yaml"), 0.5, 100);
  check_order("bricard", test_file("bricard.yaml"), 0.5, 100);
  check_order("spatial-four-bar-spring", test_file("spatial-four-bar-spring.yaml"), 0.5, 100);
  check_order("andrews", test_file("andrews.yaml"), 0.01, 60);
  check_order("flyball", test_file("flyball-governor.yaml"), 0.5, 500);
  check_order("machine", machine_model(), 1.0, 400);
}

/* Multipliers and reactions are found from dependent coordinates, which become bad on the way:
 * those of the Maggi formulation all along. */
static void test_reactions(void)
{
  maggi_model *m = machine_model();
  maggi_data *d = test_data(m), *other = test_start(m);
  maggi_penalty_options o = defaults();
  maggi_penalty *s = start(d, &o);
  double x[6 * 16], y[6 * 16], lowest = 1.0, size = 0.0;
  int i, k;

  for (k = 0; k < 200; ++k) {
    step(s, 0.005, 1);
    test_step(other, 0.005, 1);
    maggi_get_reactions(d, x);
    maggi_get_reactions(other, y);
    for (i = 0; i < 6; ++i) size = fmax(size, fabs(y[i]));
    for (i = 0; i < 6; ++i) CHECK_NEAR(x[i], y[i], 0.0, 5e-3 * size);
    lowest = fmin(lowest, test_loops(d).pivot_ratio);
  }
  CHECK(size > 10.0);
  CHECK(test_loops(d).changes > 0 && lowest > 0.5 * MAGGI_RENEW_BELOW);
  maggi_penalty_free(s);
  maggi_data_free(other);
  test_free(d, m);
}

/* ------------------------------------------------------------------------------------- options */

/* all ways to the Jacobian go through the same iterates, differences as far as they can */
static void check_ways(maggi_model *m, double h, long steps)
{
  maggi_data *d = test_data(m);
  maggi_penalty_options o = defaults();
  maggi_penalty_state first = {0}, now;
  test_state x = {0}, y;
  maggi_penalty *s;
  int way, i, n = test_coordinates(m);

  for (way = MAGGI_JACOBIAN_COUNT - 1; way >= 0; --way) { /* exact ones first */
    o.jacobian = (maggi_jacobian)way;
    s = start(d, &o);
    step(s, h, steps);
    now = state_of(s);
    y = test_get(d);
    if (way == MAGGI_JACOBIAN_COUNT - 1) {
      first = now;
      x = y;
    }
    CHECK(now.iterations == first.iterations && now.jacobians == first.jacobians);
    CHECK(now.iterations > now.jacobians && now.jacobians >= steps);
    for (i = 0; i < n; ++i)
      CHECK_NEAR(y.q[i], x.q[i], 0.0, way >= MAGGI_JACOBIAN_TANGENT ? 1e-12 : 1e-9);
    maggi_penalty_free(s);
  }
  test_free(d, m);
}

/* Newton's method: fewer iterations to a larger tolerance; Jacobians each time or seldom, to the
 * same end */
static void test_newton(void)
{
  maggi_model *m = machine_model();
  maggi_data *d = test_data(m);
  maggi_penalty_options o = defaults();
  maggi_penalty_state state;
  test_state x = {0}, y;
  maggi_penalty *s;
  long before = 0;
  int k;

  for (k = 0; k < 4; ++k) {
    o.tolerance = k == 0 ? 1e-6 : 1e-12;
    o.reuse = k == 3 ? 1 : k == 2 ? 30 : 3;
    s = start(d, &o);
    step(s, 0.01, 40);
    state = state_of(s);
    y = test_get(d);
    if (k == 1) {
      CHECK(state.iterations > before + 40);
      x = y;
    }
    if (k == 2) CHECK(state.jacobians == 40 && state.iterations >= before);
    if (k == 3) CHECK(state.jacobians == state.iterations);
    CHECK_NEAR(y.q[0], k == 0 ? y.q[0] : x.q[0], 0.0, 1e-10);
    before = state.iterations;
    maggi_penalty_free(s);
  }
  test_free(d, m);
}

/* loops are open by their multipliers over alpha */
static void test_alpha(void)
{
  static const double alpha[] = {1e6, 1e8, 1e10};
  maggi_model *m = test_file("four-bar.yaml");
  maggi_data *d = test_data(m);
  maggi_penalty_options o = defaults();
  double lambda[64], largest;
  maggi_penalty *s;
  int i, k;

  o.tolerance = 1e-13;
  for (k = 0; k < 3; ++k) {
    o.penalty = alpha[k];
    s = start(d, &o);
    step(s, 0.002, 100);
    maggi_get_multipliers(d, lambda);
    for (i = 0, largest = 0.0; i < d->t.nrow; ++i) largest = fmax(largest, fabs(lambda[i]));
    CHECK(largest > 1.0);
    for (i = 0; i < d->t.nrow; ++i) CHECK_NEAR(alpha[k] * d->res[i], lambda[i], 0.0, 0.1 * largest);
    maggi_penalty_free(s);
  }
  test_free(d, m);
}

/* the rule is symmetric: an open chain comes back to where it began */
static void test_back(void)
{
  maggi_model *m = test_file("triple-pendulum.yaml");
  maggi_data *d = test_data(m);
  maggi_penalty_options o = defaults();
  maggi_penalty *s;
  test_state x, y;
  int i, n = test_coordinates(m);

  o.tolerance = 1e-13;
  s = start(d, &o);
  x = test_get(d);
  step(s, 0.01, 50);
  y = test_get(d);
  CHECK(fabs(y.q[0] - x.q[0]) > 0.1);
  step(s, -0.01, 50);
  y = test_get(d);
  CHECK_NEAR(maggi_get_time(d), 0.0, 0.0, 1e-14);
  for (i = 0; i < n; ++i) {
    CHECK_NEAR(y.q[i], x.q[i], 0.0, 1e-10);
    CHECK_NEAR(y.v[i], x.v[i], 0.0, 1e-8);
  }
  maggi_penalty_free(s);
  test_free(d, m);
}

/* nothing is free: the functions of time alone; steps of both formulations in turn */
static void test_corners(void)
{
  maggi_model *m = test_model(
      "bodies: [{name: a, mass: 2, joint: {type: prismatic, axis: [1, 0, 0], motion: f}}]\n"
      "functions: [{name: f, type: polynomial, coefficients: [0, 1, 3]}]\n");
  maggi_data *d = test_data(m);
  maggi_penalty_options o = defaults();
  maggi_penalty *s = start(d, &o);
  test_state x, y;
  double drive[1], h;
  maggi_energy e;
  int i;

  step(s, 0.1, 5);
  x = test_get(d);
  CHECK_NEAR(x.q[0], 1.25, 1e-15, 0.0);
  CHECK_NEAR(x.v[0], 4.0, 1e-15, 0.0);
  CHECK_NEAR(x.a[0], 6.0, 1e-15, 0.0);
  maggi_get_drives(d, drive);
  CHECK_NEAR(drive[0], 12.0, 1e-14, 0.0);
  maggi_get_energy(d, &e);
  CHECK_NEAR(e.work, 15.0, 1e-14, 0.0); /* power grows evenly: the rule is exact */
  maggi_penalty_free(s);
  test_free(d, m);

  m = test_file("n-four-bar-2.yaml");
  d = test_data(m);
  s = start(d, &o);
  for (h = 0.018; h < 0.05 && !d->is_ahead; h += 0.001) { /* on the way over a singular position */
    CHECK(maggi_data_reset(d) == MAGGI_OK);
    for (i = 0; i < 1000 && !d->is_ahead; ++i) test_step(d, h, 1);
  }
  CHECK(d->is_ahead);
  h = maggi_get_time(d) + 0.02;
  step(s, 1e-3, 20);
  x = test_get(d);
  test_step(d, 1e-6, 1);
  y = test_get(d);
  CHECK_NEAR(maggi_get_time(d), h + 1e-6, 1e-12, 0.0);
  CHECK_NEAR(y.q[0], x.q[0] + 1e-6 * x.v[0], 0.0, 1e-9);
  maggi_penalty_free(s);
  test_free(d, m);
}

/* ----------------------------------------------------------------------------- what goes wrong */

static void refuse(maggi_data *d, const maggi_penalty_options *o, const char *text)
{
  maggi_penalty *s = NULL;

  CHECK(maggi_penalty_create(d, o, &s) == MAGGI_E_VALUE);
  CHECK(s == NULL);
  CHECK_TEXT(maggi_data_message(d), text);
}

static void test_options(void)
{
  static const double bad[] = {0.0, -1.0, NAN, INFINITY};
  maggi_model *m = test_file("four-bar.yaml");
  maggi_data *d = test_data(m);
  maggi_penalty_options o;
  int i;

  o = defaults();
  CHECK(o.penalty == 1e8 && o.tolerance == 1e-8 && o.reuse == 3 && o.iterations == 30 &&
        o.jacobian == MAGGI_JACOBIAN_TANGENT_COLOURED);
  for (i = 0; i < 4; ++i) {
    o = defaults();
    o.penalty = bad[i];
    refuse(d, &o, "the penalty must be positive");
    o = defaults();
    o.tolerance = bad[i];
    refuse(d, &o, "the tolerance of Newton's method must be positive");
  }
  o = defaults();
  o.jacobian = MAGGI_JACOBIAN_COUNT;
  refuse(d, &o, "way 5 to the Jacobian does not exist");
  o = defaults();
  o.reuse = 0;
  refuse(d, &o, "iterations and reuse must be at least 1");
  o = defaults();
  o.iterations = 0;
  refuse(d, &o, "iterations and reuse must be at least 1");
  test_free(d, m);
}

static void test_failures(void)
{
  maggi_model *m = array(1, 15);
  maggi_data *d = test_data(m);
  maggi_penalty_options o = defaults();
  maggi_penalty *s = create(d, &o);

  CHECK(maggi_penalty_step(s, 0.01) == MAGGI_E_MODEL);
  CHECK_TEXT(maggi_data_message(d), "a step needs a successful reset before it");
  CHECK(maggi_penalty_reset(s) == MAGGI_OK);
  CHECK(maggi_penalty_step(s, 0.0) == MAGGI_E_VALUE);
  CHECK_TEXT(maggi_data_message(d), "the step must be finite and not zero");
  CHECK(maggi_penalty_step(s, NAN) == MAGGI_E_VALUE);
  step(s, 0.01, 3);
  CHECK(state_of(s).steps == 3);
  CHECK(maggi_penalty_step(s, 2.0) == MAGGI_E_NOT_FINITE);
  CHECK(strncmp(maggi_data_message(d), "t = 2.03 s: Newton's method does not converge (last move ",
                57) == 0);
  CHECK(strstr(maggi_data_message(d), " iterations); is the step too large?") != NULL);
  CHECK(maggi_penalty_step(s, 0.01) == MAGGI_E_MODEL);
  CHECK(maggi_penalty_reset(s) == MAGGI_OK);
  CHECK(state_of(s).steps == 0 && state_of(s).iterations == 0 && state_of(s).jacobians == 0);
  step(s, 0.01, 3);
  maggi_penalty_free(s);
  maggi_penalty_free(NULL);

  o.iterations = 1;
  o.tolerance = 1e-14;
  s = start(d, &o);
  CHECK(maggi_penalty_step(s, 0.01) == MAGGI_E_NOT_FINITE);
  CHECK(strstr(maggi_data_message(d), " after 1 iterations); is") != NULL);
  maggi_penalty_free(s);
  test_free(d, m);

  /* what the Maggi formulation refuses */
  m = test_model("bodies: [{name: a, joint: {type: prismatic, axis: [1, 0, 0]}}]\n");
  d = test_data(m);
  o = defaults();
  s = create(d, &o);
  CHECK(maggi_penalty_reset(s) == MAGGI_E_MASS);
  maggi_penalty_free(s);
  test_free(d, m);
}

int main(void)
{
  test_tables();
  test_reference();
  test_order();
  test_reactions();
  check_ways(array(1, 15), 0.01, 40);
  check_ways(test_file("triple-pendulum-closed.yaml"), 0.01, 40);
  check_ways(machine_model(), 0.01, 40);
  test_newton();
  test_alpha();
  test_back();
  test_corners();
  test_options();
  test_failures();
  return check_done();
}
