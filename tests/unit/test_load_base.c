/* core/model/load_base.c: what a file that builds on another becomes.  (Messages:
 * tests/python/test_bad_models.py.) */
#include "fixture.h"
#include "load.h"

#define HEAD "format: maggi\nversion: 1\nname: variant\n"

static double default_of(const maggi_model *m, const char *path)
{
  int i = maggi_parameter_find(m, path);

  return i < 0 ? NAN : maggi_parameter_default(m, i);
}

static maggi_model *load(const char *text)
{
  maggi_model *m;
  char message[400];

  if (!CHECK(maggi_model_load_memory(MAGGI_MODELS_DIR "/variant.yaml", text, strlen(text), &m,
                                     message, sizeof message) == MAGGI_OK))
    fprintf(stderr, "%s\n", message);
  return m;
}

/* nothing of its own: the base, but for its name and source */
static void test_same(void)
{
  maggi_model *base, *m = load(HEAD "base: four-bar.yaml\n");
  maggi_model_info i, j;
  int k;

  CHECK(maggi_model_load(MAGGI_MODELS_DIR "/four-bar.yaml", &base, NULL, 0) == MAGGI_OK);
  maggi_model_get_info(base, &i);
  maggi_model_get_info(m, &j);
  CHECK_TEXT(j.name, "variant");
  CHECK_TEXT(j.source, "");
  CHECK(*i.source != '\0');
  if (CHECK(i.parameters == j.parameters && i.coordinates == j.coordinates)) {
    for (k = 0; k < i.parameters; ++k) {
      CHECK_TEXT(maggi_parameter_path(m, k), maggi_parameter_path(base, k));
      CHECK(maggi_parameter_default(m, k) == maggi_parameter_default(base, k));
    }
    for (k = 0; k < i.coordinates; ++k)
      CHECK_TEXT(maggi_coordinate_name(m, k), maggi_coordinate_name(base, k));
  }
  maggi_model_free(base);
  maggi_model_free(m);
}

/* an entry in the place of that of its name, the order kept; another behind; keys that are no lists */
static void test_replaced(void)
{
  maggi_model *m = load(
      HEAD
      "base: triple-pendulum.yaml\n"
      "gravity: [0, 0, -1]\n"
      "bodies:\n"
      "- {name: tail, parent: bar3, joint: {type: revolute, point: [1, 0, 0], axis: [0, 1, 0]},\n"
      "   mass: 2, bar: {from: [1, 0, 0], to: [2, 0, 0]}}\n"
      "- {name: bar2, parent: bar1, joint: {type: revolute, point: [0, -1, 0], axis: [1, 0, 0]},\n"
      "   mass: 7, bar: {from: [0, -1, 0], to: [0, -1, -1]}}\n");

  CHECK_TEXT(maggi_coordinate_name(m, 0), "bar1");
  CHECK_TEXT(maggi_coordinate_name(m, 1), "bar2");
  CHECK_TEXT(maggi_coordinate_name(m, 2), "bar3");
  CHECK_TEXT(maggi_coordinate_name(m, 3), "tail");
  CHECK(default_of(m, "bodies.bar2.mass") == 7.0);
  CHECK(default_of(m, "gravity.z") == -1.0);
  maggi_model_free(m);
}

/* removed, and put behind the others under the same name */
static void test_removed(void)
{
  maggi_model *m = load(
      HEAD "base: pendulum.yaml\n"
           "remove: [bodies.bar, sensors.mass, sensors.mass_velocity, objectives.swing,\n"
           " objectives.height, objectives.load, objectives.place, design.mass, design.length]\n"
           "bodies:\n"
           "- {name: other, joint: {type: prismatic, axis: [1, 0, 0]}, mass: 3}\n"
           "- {name: bar, joint: {type: prismatic, axis: [1, 0, 0]}, mass: 4}\n");
  maggi_model_info info;

  maggi_model_get_info(m, &info);
  CHECK(info.coordinates == 2);
  CHECK_TEXT(maggi_coordinate_name(m, 0), "other");
  CHECK(default_of(m, "bodies.bar.mass") == 4.0);
  maggi_model_free(m);
}

/* numbers by path, glob and design parameter; those of the base can be replaced and removed */
static void test_setting(void)
{
  maggi_model *m = load(HEAD "base: pendulum.yaml\n"
                             "set:\n"
                             "- {name: length, value: 2}\n"
                             "- {name: bodies.bar.mass, value: 3}\n"
                             "- {name: bodies.bar.joint.velocity, value: -1}\n"
                             "- {name: 'gravity.[xz]', value: 0.5}\n");
  maggi_data *d;
  double v;

  CHECK(default_of(m, "bodies.bar.cog.x") == -2.0);
  CHECK(default_of(m, "sensors.mass_velocity.point.x") == -2.0);
  CHECK(default_of(m, "bodies.bar.mass") == 3.0);
  CHECK(default_of(m, "gravity.x") == 0.5 && default_of(m, "gravity.z") == 0.5);
  CHECK(maggi_data_create(m, &d) == MAGGI_OK && maggi_data_reset(d) == MAGGI_OK);
  maggi_get_coordinates(d, NULL, &v, NULL);
  CHECK(v == -1.0);
  maggi_data_free(d);
  maggi_model_free(m);
}

/* the length after the path that it contains */
static void test_setting_order(void)
{
  maggi_model *m = load(HEAD "base: pendulum.yaml\n"
                             "set:\n"
                             "- {name: length, value: 3}\n"
                             "- {name: bodies.bar.cog.x, value: -1.5}\n");

  CHECK(default_of(m, "bodies.bar.cog.x") == -3.0);
  CHECK(default_of(m, "sensors.mass.point.x") == -2.5);
  maggi_model_free(m);
}

/* a property file begins in the folder of the file that names it */
static void test_paths(void)
{
  static const char text[] = HEAD "base: ../models/wheeled-frame.yaml\n";
  maggi_model *m;
  char message[400];

  CHECK(maggi_model_load_memory(MAGGI_REFERENCES_DIR "/../../tests/x.yaml", text, strlen(text), &m,
                                message, sizeof message) == MAGGI_OK);
  CHECK(default_of(m, "tyres.truck.fnomin") == 35000.0);
  maggi_model_free(m);
}

/* text of any kind where files and names are expected */
static void test_odd(void)
{
  static const char *const odd[] = {"base: ''\n",
                                    "base: /\n",
                                    "base: nowhere/pendulum.yaml\n",
                                    "base: variant.yaml/..//./pendulum.yaml\n",
                                    "base: pendulum.yaml\nremove: ['']\n",
                                    "base: pendulum.yaml\nremove: [bodies.]\n",
                                    "base: pendulum.yaml\nremove: [.bar]\n",
                                    "base: pendulum.yaml\nremove: [remove.bodies]\n",
                                    "base: pendulum.yaml\nremove: [base.x]\n",
                                    "base: pendulum.yaml\nremove: [bodies.bar.mass]\n"};
  char text[400], message[400];
  maggi_model *m;
  size_t i;

  for (i = 0; i < sizeof odd / sizeof *odd; ++i) {
    snprintf(text, sizeof text, HEAD "%s", odd[i]);
    CHECK(maggi_model_load_memory(MAGGI_MODELS_DIR "/variant.yaml", text, strlen(text), &m, message,
                                  sizeof message) != MAGGI_OK);
    CHECK(m == NULL);
    CHECK(strncmp(message, MAGGI_MODELS_DIR "/variant.yaml:", strlen(MAGGI_MODELS_DIR) + 14) == 0);
  }
}

int main(void)
{
  test_same();
  test_replaced();
  test_removed();
  test_setting();
  test_setting_order();
  test_paths();
  test_odd();
  return check_done();
}
