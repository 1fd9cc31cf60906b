/* core/sensitivity/design.c: design parameters as maps onto p, selection, what is refused. */
#include "data.h"
#include "design.h"
#include "fixture.h"

static const char text[] =
    "bodies:\n"
    "  - {name: left, mass: 2, joint: {type: prismatic, axis: [0, 0, 1], velocity: 3}}\n"
    "  - {name: right, mass: 5, joint: {type: prismatic, axis: [0, 0, 1]}}\n"
    "joint_springs:\n"
    "  - {name: s1, coordinate: left, stiffness: 100}\n"
    "  - {name: s2, coordinate: right, stiffness: 300}\n"
    "design:\n"
    "  - {name: k, parameters: [joint_springs.s1.stiffness, joint_springs.s2.stiffness],\n"
    "     factors: [1, 3], nominal: 1, lower: 0, upper: 10, unit: N/mm}\n"
    "  - {name: m, parameters: [bodies.*.mass]}\n"
    "  - {name: k2, parameters: [joint_springs.s2.stiffness], factors: [-2]}\n";

typedef struct study {
  maggi_model *m;
  maggi_data *d;
  maggi_design *g;
  char message[300];
} study;

static study open_study(void)
{
  study s;

  s.m = test_model("%s", text);
  s.d = test_data(s.m);
  s.message[0] = '\0';
  CHECK(maggi_design_create(s.d, &s.g) == MAGGI_OK);
  return s;
}

static void close_study(study *s)
{
  maggi_design_free(s->g);
  test_free(s->d, s->m);
}

static int selected(study *s, const char *pattern)
{
  return maggi_design_select(s->g, pattern, s->message, sizeof s->message) == MAGGI_OK;
}

static double get(const study *s, const char *path)
{
  return maggi_data_get_parameter(s->d, maggi_parameter_find(s->m, path));
}

static void test_declared(void)
{
  study s = open_study();

  CHECK(selected(&s, "k*"));
  CHECK(selected(&s, "m"));
  CHECK(maggi_design_number(s.g) == 3);
  CHECK_TEXT(maggi_design_name(s.g, 0), "k");
  CHECK_TEXT(maggi_design_unit(s.g, 0), "N/mm");
  CHECK(maggi_design_value(s.g, 0) == 1.0 && maggi_design_lower(s.g, 0) == 0.0 &&
        maggi_design_upper(s.g, 0) == 10.0);
  /* the first entry over its factor, its unit */
  CHECK_TEXT(maggi_design_name(s.g, 1), "k2");
  CHECK_TEXT(maggi_design_unit(s.g, 1), "N/m");
  CHECK(maggi_design_value(s.g, 1) == -150.0);
  CHECK(maggi_design_lower(s.g, 1) == -INFINITY && maggi_design_upper(s.g, 1) == INFINITY);
  CHECK_TEXT(maggi_design_unit(s.g, 2), "kg");
  CHECK(maggi_design_value(s.g, 2) == 2.0);
  CHECK(maggi_design_name(s.g, 3) == NULL && maggi_design_unit(s.g, -1) == NULL);
  CHECK(isnan(maggi_design_value(s.g, 3)));
  CHECK_TEXT(maggi_model_design(s.m, 1), "m");
  CHECK(maggi_model_design(s.m, 3) == NULL);
  close_study(&s);
}

/* p_j = p_j0 + sum of factors times (b - nominal), exactly p_0 at the nominal values */
static void test_values(void)
{
  study s = open_study();
  double b[3] = {1.0, -150.0, 2.0};
  int before, i;

  CHECK(selected(&s, "k*") && selected(&s, "m"));
  CHECK(maggi_design_set(s.g, s.d, b) == MAGGI_OK);
  CHECK(get(&s, "joint_springs.s1.stiffness") == 100.0);
  CHECK(get(&s, "joint_springs.s2.stiffness") == 300.0);
  b[0] = 3.0;
  b[1] = -140.0;
  b[2] = 2.5;
  for (i = 0; i < 2; ++i) { /* from p_0, not from what is there */
    CHECK(maggi_design_set(s.g, s.d, b) == MAGGI_OK);
    CHECK(get(&s, "joint_springs.s1.stiffness") == 102.0);
    CHECK(get(&s, "joint_springs.s2.stiffness") == 300.0 + 6.0 - 20.0);
    CHECK(get(&s, "bodies.left.mass") == 2.5 && get(&s, "bodies.right.mass") == 5.5);
  }
  b[2] = -1.0; /* a mass of -1 */
  CHECK(maggi_design_set(s.g, s.d, b) == MAGGI_E_VALUE);
  CHECK_TEXT(maggi_data_message(s.d), "bodies.left.mass must not be negative (-1)");
  CHECK(get(&s, "joint_springs.s1.stiffness") == 100.0 && get(&s, "bodies.right.mass") == 5.0);
  b[2] = NAN;
  CHECK(maggi_design_set(s.g, s.d, b) == MAGGI_E_VALUE);
  close_study(&s);

  /* an initial velocity that is not prescribed stays so */
  s = open_study();
  CHECK(selected(&s, "bodies.*.joint.velocity"));
  CHECK(maggi_design_number(s.g) == 2);
  b[0] = 4.0;
  b[1] = 1.0;
  before = s.m->velocity_given[s.m->coordinate[1].q];
  CHECK(maggi_design_set(s.g, s.d, b) == MAGGI_OK);
  CHECK(s.d->velocity_given[s.m->coordinate[1].q] == before);
  CHECK(get(&s, "bodies.right.joint.velocity") == 1.0);
  close_study(&s);
}

/* directions and their transpose, any part of them */
static void test_maps(void)
{
  study s = open_study();
  int np, i, j, first, n;
  double *out, *p_bar, gradient[3], x;
  unsigned long long seed = 7;

  CHECK(selected(&s, "k*") && selected(&s, "m"));
  for (np = 0; maggi_parameter_path(s.m, np); ++np)
    ;
  out = malloc((size_t)np * 3 * sizeof *out);
  p_bar = malloc((size_t)np * sizeof *p_bar);
  if (!out || !p_bar) exit(1);
  for (i = 0; i < np; ++i) p_bar[i] = random11(&seed);
  maggi_design_pull(s.g, p_bar, gradient);
  for (first = 0; first < 3; ++first) {
    for (n = 1; first + n <= 3; ++n) {
      for (i = 0; i < 3 * np; ++i) out[i] = 7.0;
      maggi_design_directions(s.g, first, n, n, out);
      for (j = 0; j < n; ++j) {
        for (i = 0, x = 0.0; i < np; ++i) x += p_bar[i] * out[i * n + j];
        CHECK_NEAR(x, gradient[first + j], 1e-14, 0.0);
      }
      for (i = n * np; i < 3 * np; ++i) CHECK(out[i] == 7.0);
    }
  }
  maggi_design_directions(s.g, 0, 3, 3, out);
  i = maggi_parameter_find(s.m, "joint_springs.s2.stiffness");
  CHECK(out[3 * i] == 3.0 && out[3 * i + 1] == -2.0 && out[3 * i + 2] == 0.0);
  free(out);
  free(p_bar);
  close_study(&s);
}

static void test_select(void)
{
  study s = open_study();
  int n;

  CHECK(selected(&s, "all"));
  for (n = 0; maggi_parameter_path(s.m, n); ++n) {
    CHECK_TEXT(maggi_design_name(s.g, n), maggi_parameter_path(s.m, n));
    CHECK(maggi_design_value(s.g, n) == maggi_parameter_default(s.m, n));
  }
  CHECK(maggi_design_number(s.g) == n);
  CHECK(!selected(&s, "bodies.left.mass"));
  CHECK_TEXT(s.message, "design parameter \"bodies.left.mass\" is there already");
  CHECK(maggi_design_number(s.g) == n);
  close_study(&s);

  s = open_study();
  CHECK(selected(&s, "bodies.*t.mass")); /* entries of p, since no declared one is meant */
  CHECK(maggi_design_number(s.g) == 2);
  CHECK_TEXT(maggi_design_name(s.g, 1), "bodies.right.mass");
  CHECK(!selected(&s, "bodies.[lm]eft.mass"));
  CHECK(!selected(&s, "nothing*"));
  CHECK_TEXT(s.message, "no parameter \"nothing*\"");
  CHECK(selected(&s, "m") && !selected(&s, "?"));
  CHECK_TEXT(s.message, "design parameter \"m\" is there already");
  CHECK(maggi_design_number(s.g) == 3); /* all or nothing: not k */
  CHECK(selected(&s, "k?"));
  CHECK_TEXT(maggi_design_name(s.g, 3), "k2");
  close_study(&s);
}

/* p_0 are the parameters of the simulation */
static void test_p0(void)
{
  study s = open_study();
  double b[1] = {3.0};

  CHECK(test_set(s.m, s.d, "bodies.left.mass", 9.0));
  CHECK(selected(&s, "bodies.left.mass"));
  CHECK(maggi_design_value(s.g, 0) == 2.0); /* the design is older */
  maggi_design_free(s.g);
  CHECK(maggi_design_create(s.d, &s.g) == MAGGI_OK);
  CHECK(selected(&s, "m"));
  CHECK(maggi_design_value(s.g, 0) == 9.0);
  CHECK(maggi_design_set(s.g, s.d, b) == MAGGI_E_VALUE);
  b[0] = 5.0;
  CHECK(maggi_design_set(s.g, s.d, b) == MAGGI_OK);
  CHECK(get(&s, "bodies.left.mass") == 5.0 && get(&s, "bodies.right.mass") == 1.0);
  close_study(&s);
}

static const char *const paths[] = {"bodies.left.mass", "bodies.*.mass"}, *const unknown[] = {
                                                                              "bodies.left.mass",
                                                                              "bodies.middle.mass"};
static const double zero[] = {1.0, 0.0}, infinite[] = {1.0, INFINITY};

#define REFUSED(change, wanted, said)                                                              \
  do {                                                                                             \
    maggi_design_def d;                                                                            \
    maggi_design_def_init(&d);                                                                     \
    d.name = "b";                                                                                  \
    d.number = 1;                                                                                  \
    d.paths = paths;                                                                               \
    change;                                                                                        \
    CHECK(maggi_design_add(s.g, &d, s.message, sizeof s.message) == wanted);                       \
    CHECK_TEXT(s.message, said);                                                                   \
    CHECK(maggi_design_number(s.g) == 1);                                                          \
  } while (0)

static void test_refused(void)
{
  study s = open_study();

  CHECK(selected(&s, "k2"));
  REFUSED(d.name = "", MAGGI_E_VALUE, "a design parameter has no name");
  REFUSED(d.name = "k2", MAGGI_E_NAME, "design parameter \"k2\" is there already");
  REFUSED(d.number = 0, MAGGI_E_VALUE, "design parameter \"b\": parameters are missing");
  REFUSED(d.number = 2; d.paths = unknown, MAGGI_E_NAME,
                        "design parameter \"b\": no parameter \"bodies.middle.mass\"");
  REFUSED(d.number = 2, MAGGI_E_VALUE,
          "design parameter \"b\": \"bodies.left.mass\" is there twice");
  REFUSED(d.number = 2;
          d.factors = zero, MAGGI_E_VALUE, "design parameter \"b\": factors: number 2 is zero");
  REFUSED(d.number = 2;
          d.factors = infinite, MAGGI_E_VALUE, "design parameter \"b\": factors are not finite");
  REFUSED(d.nominal = INFINITY, MAGGI_E_VALUE, "design parameter \"b\": nominal is not finite");
  REFUSED(d.lower = NAN, MAGGI_E_VALUE, "design parameter \"b\": lower is not a number");
  REFUSED(d.upper = NAN, MAGGI_E_VALUE, "design parameter \"b\": upper is not a number");
  REFUSED(d.lower = 2.0;
          d.upper = 1.0, MAGGI_E_VALUE, "design parameter \"b\": lower is above upper (2, 1)");
  REFUSED(d.nominal = 3.0; d.upper = 1.0, MAGGI_E_VALUE,
                           "design parameter \"b\": nominal is not between lower and upper (3)");
  close_study(&s);
}

int main(void)
{
  test_declared();
  test_values();
  test_maps();
  test_select();
  test_p0();
  test_refused();
  return check_done();
}
