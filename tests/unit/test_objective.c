/* core/study/objective.c: objectives by definition and by name, units, what is refused. */
#include "fixture.h"

static const char text[] = "bodies:\n"
                           "  - {name: b, mass: 1, joint: {type: revolute, point: [0, 0, 0], axis: "
                           "[1, 0, 0]}, cog: [0, 1, 0]}\n"
                           "sensors:\n"
                           "  - {name: tip, type: acceleration, body: b, point: [0, 1, 0]}\n"
                           "objectives:\n"
                           "  - {name: way, type: integral, signal: b.v}\n"
                           "  - {name: bend, type: mean, signal: b.q}\n"
                           "  - {name: turn, type: peak, signal: b.q}\n"
                           "  - {name: swing, type: sum, terms: [bend, turn]}\n"
                           "  - {name: both, type: sum, terms: [way, turn], weights: [1, 0.5]}\n";

static maggi_objective *named(const maggi_model *m, const char *name)
{
  maggi_objective *o = NULL;
  char message[200] = "";

  CHECK(maggi_objective_named(m, name, &o, message, sizeof message) == MAGGI_OK);
  CHECK_TEXT(message, "");
  if (o) CHECK_TEXT(maggi_objective_name(o), name);
  return o;
}

static void check_unit(const maggi_model *m, const char *name, const char *unit)
{
  maggi_objective *o = named(m, name);

  CHECK_TEXT(maggi_objective_unit(o), unit);
  maggi_objective_free(o);
}

static void test_units(void)
{
  maggi_model *m = test_model("%s", text);

  check_unit(m, "integral(b.q)", "rad s");
  check_unit(m, "integral(b.v)", "(rad/s) s");
  check_unit(m, "integral(b.mx)", "N m s");
  check_unit(m, "integral_square(b.q)", "rad^2 s");
  check_unit(m, "integral_square(tip.z)", "(m/s^2)^2 s");
  check_unit(m, "integral_square(b.mx)", "(N m)^2 s");
  check_unit(m, "mean(b.v)", "rad/s");
  check_unit(m, "mean_square(b.v)", "(rad/s)^2");
  check_unit(m, "rms(tip.z)", "m/s^2");
  check_unit(m, "rmq(tip.z)", "m/s^2");
  check_unit(m, "vdv(tip.z)", "(m/s^2) s^(1/4)");
  check_unit(m, "maximum(b.q)", "rad");
  check_unit(m, "terminal(energy.total)", "J");
  check_unit(m, "swing", "rad");
  check_unit(m, "both", "-");
  maggi_model_free(m);
}

static void test_signals(void)
{
  maggi_model *m = test_model("%s", text);
  maggi_objective *o = named(m, "both");
  const int *signal;

  CHECK(maggi_objective_signals(o, &signal) == 2);
  CHECK_TEXT(maggi_signal_name(m, signal[0]), "b.v");
  CHECK_TEXT(maggi_signal_name(m, signal[1]), "b.q");
  maggi_objective_free(o);
  o = named(m, "swing"); /* each once */
  CHECK(maggi_objective_signals(o, &signal) == 1);
  maggi_objective_free(o);
  CHECK_TEXT(maggi_model_objective(m, 0), "way");
  CHECK_TEXT(maggi_model_objective(m, 4), "both");
  CHECK(maggi_model_objective(m, 5) == NULL && maggi_model_objective(m, -1) == NULL);
  maggi_objective_free(NULL);
  maggi_model_free(m);
}

static void check_named(const maggi_model *m, const char *name, maggi_status status,
                        const char *message)
{
  maggi_objective *o = (maggi_objective *)m;
  char said[200] = "";

  CHECK(maggi_objective_named(m, name, &o, said, sizeof said) == status);
  CHECK(o == NULL);
  CHECK_TEXT(said, message);
}

static void test_names(void)
{
  maggi_model *m = test_model("%s", text);

  check_named(m, "J9", MAGGI_E_NAME, "no objective \"J9\"");
  check_named(m, "", MAGGI_E_NAME, "no objective \"\"");
  check_named(m, "(", MAGGI_E_NAME, "no objective \"(\"");
  check_named(m, "rms()", MAGGI_E_NAME, "objective \"rms()\": no signal \"\"");
  check_named(m, "()", MAGGI_E_NAME, "objective \"()\": no type \"\"");
  check_named(m, "rms(tip.q)", MAGGI_E_NAME, "objective \"rms(tip.q)\": no signal \"tip.q\"");
  check_named(m, "rns(b.q)", MAGGI_E_NAME, "objective \"rns(b.q)\": no type \"rns\"");
  check_named(m, "value(b.q)", MAGGI_E_VALUE,
              "objective \"value(b.q)\": a value needs times, declare it in the model");
  check_named(
      m, "smooth_maximum(b.q)", MAGGI_E_VALUE,
      "objective \"smooth_maximum(b.q)\": a smooth_maximum needs a sharpness, declare it in "
      "the model");
  check_named(m, "least_squares(b.q)", MAGGI_E_VALUE,
              "objective \"least_squares(b.q)\": a least_squares needs a record, declare it in the "
              "model");
  check_named(m, "slope(b.q)", MAGGI_E_VALUE,
              "objective \"slope(b.q)\": a slope needs another signal, declare it in the model");
  check_named(m, "sum(b.q)", MAGGI_E_VALUE,
              "objective \"sum(b.q)\": a sum needs terms, declare it in the model");
  maggi_model_free(m);
}

static double function(void *context, double t, int n, const double *s, double *gradient)
{
  (void)context;
  (void)t;
  (void)n;
  gradient[0] = 1.0;
  return s[0];
}

static const char *const names[] = {"b.q", "no"}, *const terms[] = {"way", "swing"},
                         *const unknown[] = {"nothing"};
static const double falling[] = {1.0, 0.5}, early[] = {-1.0, 0.0}, rising[] = {0.0, 1.0},
                    infinite[] = {1.0, INFINITY};

#define REFUSED(change, wanted, said)                                                              \
  do {                                                                                             \
    maggi_objective_def d;                                                                         \
    maggi_objective *o;                                                                            \
    char message[200] = "";                                                                        \
    maggi_objective_def_init(&d);                                                                  \
    d.name = "o";                                                                                  \
    d.signal = "b.q";                                                                              \
    change;                                                                                        \
    CHECK(maggi_objective_create(m, &d, &o, message, sizeof message) == wanted);                   \
    CHECK(o == NULL);                                                                              \
    CHECK_TEXT(message, said);                                                                     \
  } while (0)

static void test_refused(void)
{
  maggi_model *m = test_model("%s", text);

  REFUSED(d.name = NULL, MAGGI_E_VALUE, "an objective has no name");
  REFUSED(d.type = (maggi_objective_type)99, MAGGI_E_VALUE,
          "objective \"o\": objective type 99 does not exist");
  REFUSED(d.signal = NULL, MAGGI_E_VALUE, "objective \"o\": signal is missing");
  REFUSED(d.signal = "b.z", MAGGI_E_NAME, "objective \"o\": no signal \"b.z\"");
  REFUSED(d.function = function, MAGGI_E_VALUE,
          "objective \"o\": signal and function exclude each other");
  REFUSED(d.function = function;
          d.signal = NULL, MAGGI_E_VALUE, "objective \"o\": signals of the function are missing");
  REFUSED(d.function = function; d.signal = NULL; d.nsignal = 2;
          d.signals = names, MAGGI_E_NAME, "objective \"o\": no signal \"no\"");
  REFUSED(d.target = NAN, MAGGI_E_VALUE, "objective \"o\": target is not finite");
  REFUSED(d.type = MAGGI_OBJECTIVE_SMOOTH_MAXIMUM, MAGGI_E_VALUE,
          "objective \"o\": sharpness is not positive (0)");
  REFUSED(d.type = MAGGI_OBJECTIVE_VALUE, MAGGI_E_VALUE, "objective \"o\": times are missing");
  REFUSED(d.type = MAGGI_OBJECTIVE_VALUE; d.number = 2;
          d.times = falling, MAGGI_E_VALUE, "objective \"o\": times do not increase (0.5 after 1)");
  REFUSED(d.type = MAGGI_OBJECTIVE_VALUE; d.number = 2;
          d.times = early, MAGGI_E_VALUE, "objective \"o\": times begin before 0 (-1)");
  REFUSED(d.type = MAGGI_OBJECTIVE_VALUE; d.number = 2;
          d.times = infinite, MAGGI_E_VALUE, "objective \"o\": times are not finite");
  REFUSED(d.type = MAGGI_OBJECTIVE_LEAST_SQUARES; d.number = 2;
          d.times = rising, MAGGI_E_VALUE, "objective \"o\": values are not finite");
  REFUSED(d.from = 2.0;
          d.to = 1.0, MAGGI_E_VALUE, "objective \"o\": the window is empty (from 2 to 1)");
  REFUSED(d.to = 0.0, MAGGI_E_VALUE, "objective \"o\": the window is empty (from 0 to 0)");
  REFUSED(d.from = -1.0, MAGGI_E_VALUE, "objective \"o\": the window begins before 0 (-1)");
  REFUSED(d.to = INFINITY, MAGGI_E_VALUE, "objective \"o\": the window is not finite");
  REFUSED(d.type = MAGGI_OBJECTIVE_VALUE; d.number = 2; d.times = rising;
          d.to = 1.0, MAGGI_E_VALUE, "objective \"o\": a value has no window");
  REFUSED(d.type = MAGGI_OBJECTIVE_TERMINAL;
          d.from = 1.0, MAGGI_E_VALUE,
          "objective \"o\": a terminal is at the end of its window, so without from");
  REFUSED(d.type = MAGGI_OBJECTIVE_PEAK; d.reference = MAGGI_REFERENCE_FINAL, MAGGI_E_VALUE,
                                         "objective \"o\": a peak has no reference");
  REFUSED(d.reference = (maggi_reference_type)7, MAGGI_E_VALUE,
          "objective \"o\": reference 7 does not exist");
  REFUSED(d.type = MAGGI_OBJECTIVE_SLOPE, MAGGI_E_VALUE, "objective \"o\": against is missing");
  REFUSED(d.type = MAGGI_OBJECTIVE_SLOPE;
          d.against = "no", MAGGI_E_NAME, "objective \"o\": no signal \"no\"");
  REFUSED(d.type = MAGGI_OBJECTIVE_SUM, MAGGI_E_VALUE, "objective \"o\": terms are missing");
  REFUSED(d.type = MAGGI_OBJECTIVE_SUM; d.nterm = 1;
          d.terms = unknown, MAGGI_E_NAME, "objective \"o\": no objective \"nothing\"");
  REFUSED(d.type = MAGGI_OBJECTIVE_SUM; d.nterm = 2;
          d.terms = terms, MAGGI_E_VALUE, "objective \"o\": \"swing\" is a sum itself");
  REFUSED(d.type = MAGGI_OBJECTIVE_SUM; d.nterm = 2; d.terms = terms;
          d.weights = infinite, MAGGI_E_VALUE, "objective \"o\": weights are not finite");
  maggi_model_free(m);
}

/* an objective keeps copies */
static void test_copies(void)
{
  maggi_model *m = test_model("%s", text);
  char name[] = "mine", signal[] = "b.q";
  maggi_objective_def d;
  maggi_objective *o;
  char message[200];
  int i;

  maggi_objective_def_init(&d);
  d.name = name;
  d.signal = signal;
  CHECK(maggi_objective_create(m, &d, &o, message, sizeof message) == MAGGI_OK);
  memset(name, 'x', sizeof name - 1);
  memset(signal, 'x', sizeof signal - 1);
  CHECK_TEXT(maggi_objective_name(o), "mine");
  maggi_objective_free(o);
  for (i = 0; i < MAGGI_OBJECTIVE_TYPE_COUNT; ++i)
    CHECK(maggi_objective_type_find(maggi_objective_type_name((maggi_objective_type)i)) == i);
  CHECK(maggi_objective_type_name(MAGGI_OBJECTIVE_TYPE_COUNT) == NULL);
  CHECK(maggi_objective_type_find("mead") == -1);
  maggi_model_free(m);
}

int main(void)
{
  test_units();
  test_signals();
  test_names();
  test_refused();
  test_copies();
  return check_done();
}
