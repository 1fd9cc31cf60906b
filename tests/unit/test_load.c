/* core/model/load*.c, from memory and from files.  (Each wrong key and value with its message:
 * tests/python/test_bad_models.py; any bytes at all: tests/fuzz.) */
#include <locale.h>

#include "fixture.h"

static const char good[] = "format: maggi\nversion: 1\nname: n\nbodies:\n"
                           "- {name: b, mass: 1.5, joint: {type: prismatic, axis: [0, 0, 0.5]}}\n";

static maggi_status load(const char *text, maggi_model **m, char *message, size_t n)
{
  return maggi_model_load_memory("file", text, strlen(text), m, message, n);
}

static void test_message(void)
{
  static const char bad[] = "format: maggi\nversion: 1\nname: n\nbodies:\n- {name: b}\n";
  maggi_model *m = (maggi_model *)bad;
  char message[64] = "old", tiny[8];

  CHECK(load(bad, &m, message, sizeof message) == MAGGI_E_MODEL);
  CHECK(m == NULL);
  CHECK(strncmp(message, "file:5: ", 8) == 0);
  /* cut to the room there is, without room not written */
  memset(tiny, 'x', sizeof tiny);
  CHECK(load(bad, &m, tiny, 5) == MAGGI_E_MODEL);
  CHECK_TEXT(tiny, "file");
  CHECK(tiny[5] == 'x');
  memset(tiny, 'x', sizeof tiny);
  CHECK(load(bad, &m, tiny, 0) == MAGGI_E_MODEL);
  CHECK(tiny[0] == 'x');
  CHECK(load(bad, &m, NULL, 0) == MAGGI_E_MODEL);
  /* success leaves none */
  CHECK(load(good, &m, message, sizeof message) == MAGGI_OK);
  CHECK_TEXT(message, "");
  maggi_model_free(m);
  CHECK(load(good, &m, NULL, 0) == MAGGI_OK);
  maggi_model_free(m);
}

static void test_bytes(void)
{
  maggi_model *m;
  char message[256], *large;
  size_t n;

  CHECK(load("", &m, message, sizeof message) == MAGGI_E_MODEL && *message);
  CHECK(load("\n\n", &m, message, sizeof message) == MAGGI_E_MODEL && *message);
  CHECK(load("42", &m, message, sizeof message) == MAGGI_E_MODEL && *message);
  CHECK(maggi_model_load_memory("file", "a\0b", 3, &m, message, sizeof message) == MAGGI_E_MODEL);
  CHECK(maggi_model_load_memory("file", "\xff\xfe", 2, &m, message, sizeof message) ==
        MAGGI_E_MODEL);
  /* every beginning of a good file is a file that is cut off, and says so, or is good */
  for (n = 0; n < strlen(good); ++n) {
    if (maggi_model_load_memory("file", good, n, &m, message, sizeof message) == MAGGI_OK)
      CHECK(n + 1 == strlen(good)); /* only the last end of line may be missing */
    else
      CHECK(strncmp(message, "file:", 5) == 0);
    maggi_model_free(m);
  }
  /* too long */
  large = malloc(MAGGI_LOAD_MAX + 1);
  if (CHECK(large != NULL)) {
    memset(large, ' ', MAGGI_LOAD_MAX + 1);
    memcpy(large, good, strlen(good));
    CHECK(maggi_model_load_memory("file", large, MAGGI_LOAD_MAX + 1, &m, message, sizeof message) ==
          MAGGI_E_FILE);
    CHECK(m == NULL && strncmp(message, "file: ", 6) == 0);
    free(large);
  }
}

/* numbers have a point, whatever the program's locale, which stays as it is */
static void test_locale(void)
{
  static const char *const names[] = {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "es_ES.UTF-8"};
  maggi_model *m;
  char message[256];
  size_t i;

  for (i = 0; i < sizeof names / sizeof *names && !setlocale(LC_ALL, names[i]); ++i)
    ;
  CHECK(load(good, &m, message, sizeof message) == MAGGI_OK);
  CHECK(maggi_parameter_default(m, maggi_parameter_find(m, "bodies.b.mass")) == 1.5);
  if (i < sizeof names / sizeof *names) CHECK_TEXT(setlocale(LC_ALL, NULL), names[i]);
  setlocale(LC_ALL, "C");
  maggi_model_free(m);
}

/* one line, whatever is in the name of the file */
static void test_files(void)
{
  maggi_model *m = (maggi_model *)good;
  char message[512];

  CHECK(maggi_model_load("/no/such\nfile.yaml", &m, message, sizeof message) == MAGGI_E_FILE);
  CHECK(m == NULL);
  CHECK(strchr(message, '\n') == NULL && strncmp(message, "/no/such?file.yaml: ", 20) == 0);
  CHECK(maggi_model_load("/", &m, message, sizeof message) == MAGGI_E_FILE);
  CHECK(m == NULL && *message);
  CHECK(maggi_model_load(MAGGI_MODELS_DIR "/pendulum.yaml", &m, message, sizeof message) ==
        MAGGI_OK);
  maggi_model_free(m);
}

/* a file and the same model by the builder are the same parameters */
static void test_same(void)
{
  maggi_builder *b;
  maggi_body_def d;
  maggi_model *m, *n;
  maggi_model_info i, j;
  int k;

  CHECK(load(good, &m, NULL, 0) == MAGGI_OK);
  CHECK(maggi_builder_create("n", &b) == MAGGI_OK);
  maggi_body_def_init(&d);
  d.name = "b";
  d.joint = MAGGI_JOINT_PRISMATIC;
  d.axis[0] = 0.0;
  d.axis[2] = 0.5;
  d.mass = 1.5;
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  CHECK(maggi_model_create(b, &n) == MAGGI_OK);
  maggi_builder_free(b);
  maggi_model_get_info(m, &i);
  maggi_model_get_info(n, &j);
  CHECK_TEXT(i.name, j.name);
  CHECK(i.parameters == j.parameters);
  for (k = 0; k < i.parameters; ++k) {
    CHECK_TEXT(maggi_parameter_path(m, k), maggi_parameter_path(n, k));
    CHECK(maggi_parameter_default(m, k) == maggi_parameter_default(n, k));
  }
  maggi_model_free(m);
  maggi_model_free(n);
}

int main(void)
{
  test_message();
  test_bytes();
  test_locale();
  test_files();
  test_same();
  return check_done();
}
