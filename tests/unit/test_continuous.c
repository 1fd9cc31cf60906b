/* core/sensitivity/continuous.c: the continuous adjoint approaches the discrete one, which is the exact
 * derivative of the simulation, at the order of the method. */
#include "data.h"
#include "fixture.h"

enum { HALVINGS = 4, OBJECTIVES = 3 };

static const double length = 1.0; /* of all simulations [s] */

typedef struct case_def {
  const char *model; /* a shipped one, or of a function below */
  maggi_model *(*open)(void);
  const char *objective[OBJECTIVES];
  double step; /* the longest */
  int changes; /* whether the independent coordinates change on the way */
} case_def;

/* a pendulum on a guided carriage, with a load that follows time */
static maggi_model *carriage(void)
{
  return test_model(
      "bodies:\n"
      "- {name: carriage, mass: 1, joint: {type: prismatic, axis: [0, 1, 0], motion: shake}}\n"
      "- {name: arm, parent: carriage, mass: 2, cog: [0.1, 0, -0.7],"
      " inertia: {xx: 0.3, yy: 0.2, zz: 0.1}, joint: {type: revolute, point: [0, 0, 0],"
      " axis: [1, 0.2, 0], position: 0.4, velocity: 0.5}}\n"
      "functions:\n"
      "- {name: shake, type: sine, amplitude: 0.2, omega: 4, phase: 0.3, offset: 0.1}\n"
      "- {name: push, type: sine, amplitude: 1, omega: 3}\n"
      "joint_springs: [{name: spring, coordinate: arm, stiffness: 3, damping: 0.5}]\n"
      "forces: [{name: load, type: force, body: arm, point: [0, 0, -1], value: [0.5, 2, 1],"
      " function: push}]\n"
      "sensors: [{name: tip, type: acceleration, body: arm, point: [0, 0, -1]}]\n"
      "filters: [{name: felt, signal: tip.z, f1: 0.4, f2: 4, f4: 3, q4: 0.7, f5: 1, q5: 0.9, f6: 2,"
      " q6: 0.9, gain: 1.2}]\n");
}

static const case_def cases[] = {
    {"double-pendulum",
     NULL,
     {"integral_square(bar1.q)", "terminal(bar2.v)", "rms(tip.z)"},
     0.02,
     0},
    {"four-bar-generic",
     NULL,
     {"integral_square(crank.q)", "terminal(follower.v)", "mean(follower.a)"},
     0.02,
     0},
    {"spatial-four-bar",
     NULL,
     {"integral_square(crank.q)", "terminal(follower.v)", "mean(crank_end.z)"},
     0.0025,
     1},
    {"slider-crank",
     NULL,
     {"integral_square(slider.q)", "terminal(crank.v)", "mean(rod.a)"},
     0.05,
     0},
    {"carriage",
     carriage,
     {"integral_square(arm.q)", "terminal(arm.v)", "integral(tip.x)"},
     0.03,
     0},
    {"carriage, weighted",
     carriage,
     {"integral_square(felt.weighted)", "terminal(felt.weighted)", "vdv(felt.weighted)"},
     0.01,
     0},
};

static maggi_model *open_model(const case_def *c)
{
  char path[1024], message[512];
  maggi_model *m;

  if (c->open) return c->open();
  snprintf(path, sizeof path, "%s/%s.yaml", MAGGI_MODELS_DIR, c->model);
  if (maggi_model_load(path, &m, message, sizeof message) == MAGGI_OK) return m;
  fprintf(stderr, "%s\n", message);
  exit(1);
}

/* the parameters of p that match, for all objectives of a case */
typedef struct problem {
  maggi_model *m;
  maggi_data *d;
  maggi_design *design;
  maggi_objective *objective[OBJECTIVES];
  int n; /* parameters */
  double *x, *y;
} problem;

static void open_problem(problem *p, maggi_model *m, const char *parameters,
                         const char *const objective[OBJECTIVES])
{
  char message[256];
  int i;

  p->m = m;
  p->d = test_data(m);
  CHECK(maggi_design_create(p->d, &p->design) == MAGGI_OK);
  CHECK(maggi_design_select(p->design, parameters, message, sizeof message) == MAGGI_OK);
  for (i = 0; i < OBJECTIVES; ++i) {
    if (CHECK(maggi_objective_named(m, objective[i], &p->objective[i], message, sizeof message) ==
              MAGGI_OK))
      continue;
    fprintf(stderr, "%s\n", message);
    exit(1);
  }
  p->n = maggi_design_number(p->design);
  p->x = malloc(2 * OBJECTIVES * (size_t)p->n * sizeof(double));
  if (!p->x) exit(1);
  p->y = p->x + OBJECTIVES * p->n;
}

static void close_problem(problem *p)
{
  int i;

  for (i = 0; i < OBJECTIVES; ++i) maggi_objective_free(p->objective[i]);
  maggi_design_free(p->design);
  free(p->x);
  test_free(p->d, p->m);
}

static void compute(const problem *p, maggi_method method, int snapshots, double h,
                    double *gradient)
{
  maggi_gradient_options options;
  double value[OBJECTIVES];

  maggi_gradient_options_init(&options);
  options.time = length;
  options.step = h;
  options.method = method;
  options.snapshots = snapshots;
  if (CHECK(maggi_gradient(p->d, p->design, OBJECTIVES, p->objective, &options, value, gradient) ==
            MAGGI_OK))
    return;
  fprintf(stderr, "%s\n", maggi_data_message(p->d));
  exit(1);
}

/* largest difference relative to the largest entry, by objective */
static void compare(const problem *p, double h, double e[OBJECTIVES])
{
  double largest, most;
  int i, k;

  compute(p, MAGGI_METHOD_CONTINUOUS_ADJOINT, 0, h, p->x);
  compute(p, MAGGI_METHOD_ADJOINT, 0, h, p->y);
  for (k = 0; k < OBJECTIVES; ++k) {
    largest = most = 0.0;
    for (i = k * p->n; i < (k + 1) * p->n; ++i) {
      largest = fmax(largest, fabs(p->y[i]));
      most = fmax(most, fabs(p->x[i] - p->y[i]));
    }
    CHECK(largest > 0.0);
    e[k] = most / largest;
  }
}

/* The difference falls by 16 when the step is halved for the last time: before, terms of higher order
 * count, and the longest steps have projections. */
static void test_order(const case_def *c)
{
  problem p;
  double e[HALVINGS][OBJECTIVES], h = c->step;
  int i, k;

  open_problem(&p, open_model(c), "all", c->objective);
  for (k = 0; k < HALVINGS; ++k, h *= 0.5) compare(&p, h, e[k]);
  for (i = 0; i < OBJECTIVES; ++i) {
    printf("%s %s: ", c->model, c->objective[i]);
    for (k = 0; k < HALVINGS; ++k) printf("%.2e%s", e[k][i], k < HALVINGS - 1 ? ", " : "\n");
    CHECK_NEAR(log2(e[HALVINGS - 2][i] / e[HALVINGS - 1][i]), 4.0, 0.0, 0.2);
    CHECK(e[HALVINGS - 1][i] < 1e-8);
  }
  CHECK((test_loops(p.d).changes > 0) == c->changes);
  close_problem(&p);
}

/* from snapshots the same numbers */
static void test_snapshots(void)
{
  problem p;

  open_problem(&p, open_model(&cases[2]), "all", cases[2].objective);
  compute(&p, MAGGI_METHOD_CONTINUOUS_ADJOINT, 0, 0.02, p.x);
  compute(&p, MAGGI_METHOD_CONTINUOUS_ADJOINT, 3, 0.02, p.y);
  CHECK(memcmp(p.x, p.y, OBJECTIVES * (size_t)p.n * sizeof(double)) == 0);
  close_problem(&p);
}

/* A parallelogram that turns through its flat positions, where steps go beyond them and samples lie
 * between nodes.  No derivative there by what makes it another quadrilateral. */
static void test_flat(void)
{
  static const char *const objective[] = {"integral_square(v_1_1.q)", "terminal(v_1_1.v)",
                                          "mean(h_1_1.a)"};
  problem p;
  maggi_model *m;
  double e[OBJECTIVES];
  int i;

  if (!CHECK(maggi_model_multiple_four_bar(1, 1, &m) == MAGGI_OK)) return;
  open_problem(&p, m, "bodies.*.mass", objective);
  CHECK(test_set(m, p.d, "bodies.v_1_1.joint.velocity", 8.0));
  compare(&p, 0.002, e);
  for (i = 0; i < OBJECTIVES; ++i) CHECK_NEAR(e[i], 0.0, 0.0, 1e-7);
  close_problem(&p);
}

int main(void)
{
  size_t i;

  for (i = 0; i < sizeof cases / sizeof *cases; ++i) test_order(&cases[i]);
  test_snapshots();
  test_flat();
  return check_done();
}
