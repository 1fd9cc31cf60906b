/* core/model/signal.c, maggi_get_signals: the list of signals, and their values beside those of the
 * functions that give them group by group. */
#include "fixture.h"

enum { COORDINATES = 4, BODIES = 3, SENSORS = 2, SIGNALS = 3 * COORDINATES + 3 + 6 * BODIES + 6 };

/* a body of one chain of joints between bodies of one coordinate, in another order than they hang */
static maggi_model *model(void)
{
  return test_model(
      "bodies:\n"
      "- {name: arm, parent: slide, mass: 1, bar: {from: [0, 0, 0], to: [0, 1, 0]}, joint:"
      " {type: universal, point: [0, 0, 0], axis: [1, 0, 0], axis2: [0, 0, 1],"
      " velocities: [0.5, -0.25]}}\n"
      "- {name: slide, mass: 2, joint: {type: prismatic, axis: [0, 1, 0], velocity: 1}}\n"
      "- {name: tip, parent: arm, mass: 0.5, cog: [0, 1.5, 0], inertia: {xx: 1, yy: 1, zz: 1},"
      " joint: {type: revolute, point: [0, 1, 0], axis: [0, 0, 1], velocity: 2}}\n"
      "springs: [{name: s, body_a: tip, body_b: ground, point_a: [0, 2, 0], point_b: [1, 2, 0],"
      " stiffness: 20, free_length: 0.5}]\n"
      "sensors:\n"
      "- {name: tip, type: acceleration, body: tip}\n"
      "- {name: pull, type: spring, element: s}\n");
}

static void test_list(void)
{
  static const struct {
    int signal;
    const char *name, *unit;
  } row[] = {{0, "arm.1.q", "rad"},         {1, "arm.1.v", "rad/s"},   {2, "arm.1.a", "rad/s^2"},
             {3, "arm.2.q", "rad"},         {6, "slide.q", "m"},       {7, "slide.v", "m/s"},
             {8, "slide.a", "m/s^2"},       {11, "tip.a", "rad/s^2"},  {12, "energy.kinetic", "J"},
             {13, "energy.potential", "J"}, {14, "energy.total", "J"}, {15, "arm.fx", "N"},
             {18, "arm.mx", "N m"},         {22, "slide.fy", "N"},     {32, "tip.mz", "N m"},
             {33, "tip.x", "m/s^2"},        {36, "pull.length", "m"},  {38, "pull.force", "N"}};
  maggi_model *m = model();
  int i;

  CHECK(maggi_signal_number(m) == SIGNALS);
  for (i = 0; i < (int)(sizeof row / sizeof *row); ++i) {
    CHECK_TEXT(maggi_signal_name(m, row[i].signal), row[i].name);
    CHECK_TEXT(maggi_signal_unit(m, row[i].signal), row[i].unit);
  }
  for (i = 0; i < SIGNALS; ++i) CHECK(maggi_signal_find(m, maggi_signal_name(m, i)) == i);
  CHECK(maggi_signal_find(m, "arm.q") == -1);
  CHECK(maggi_signal_find(m, "") == -1);
  CHECK(!maggi_signal_name(m, -1) && !maggi_signal_name(m, SIGNALS));
  CHECK(!maggi_signal_unit(m, -1) && !maggi_signal_unit(m, SIGNALS));
  maggi_model_free(m);
}

/* one name for several: the first */
static void test_same_name(void)
{
  maggi_model *m =
      test_model("bodies: [{name: energy, mass: 1, joint: {type: prismatic, axis: [0, 0, 1]}}]\n"
                 "sensors: [{name: energy, type: position, body: energy}, {name: a, type: angles, "
                 "body: energy},"
                 " {name: b, type: position, body: energy}]\n");
  int i;

  for (i = 0; i < maggi_signal_number(m); ++i)
    CHECK(maggi_signal_find(m, maggi_signal_name(m, i)) <= i);
  CHECK(maggi_signal_find(m, "energy.x") == 3 + 3 + 6);
  maggi_model_free(m);
}

static void expect(maggi_data *d, double values[SIGNALS])
{
  double q[COORDINATES], v[COORDINATES], a[COORDINATES];
  maggi_energy e;
  int i;

  maggi_get_coordinates(d, q, v, a);
  for (i = 0; i < COORDINATES; ++i) {
    *values++ = q[i];
    *values++ = v[i];
    *values++ = a[i];
  }
  maggi_get_energy(d, &e);
  *values++ = e.kinetic;
  *values++ = e.potential;
  *values++ = e.kinetic + e.potential;
  maggi_get_reactions(d, values);
  maggi_get_sensors(d, values + 6 * BODIES);
}

/* after a step nothing else asks for results before the signals: all together, backwards, and each
 * alone */
static void test_values(void)
{
  maggi_model *m = model();
  maggi_data *d = test_start(m), *d2 = test_start(m);
  int signal[SIGNALS], i, k;
  double expected[SIGNALS], values[SIGNALS];

  for (i = 0; i < SIGNALS; ++i) signal[i] = SIGNALS - 1 - i;
  for (k = 0; k < 3; ++k) {
    test_step(d, 0.01, 1);
    test_step(d2, 0.01, 1);
    expect(d2, expected);
    maggi_get_signals(d, SIGNALS, signal, values);
    for (i = 0; i < SIGNALS; ++i) CHECK(values[i] == expected[signal[i]]);
  }
  for (i = 0; i < SIGNALS; ++i) {
    test_step(d, 0.001, 1);
    test_step(d2, 0.001, 1);
    maggi_get_signals(d, 1, &i, values);
    expect(d2, expected);
    CHECK(values[0] == expected[i]);
  }
  values[0] = 5.0;
  maggi_get_signals(d, 0, NULL, values);
  CHECK(values[0] == 5.0);
  maggi_data_free(d2);
  test_free(d, m);
}

int main(void)
{
  test_list();
  test_same_name();
  test_values();
  return check_done();
}
