/* core/model/load*.c, from memory and from files.  (Each wrong key and value with its message:
 * tests/python/test_bad_models.py; any bytes at all: tests/fuzz.) */
#include <locale.h>
#include <unistd.h>

#include "fixture.h"
#include "functional.h"

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

/* ---------------------------------------------------------------------------------------- records */

static const char folder[] = "/tmp/maggi-test-load-XXXXXX";
static char path[sizeof folder], model_path[64], record_path[64];

static void write_file(const char *name, const char *text, size_t n)
{
  FILE *f = fopen(name, "wb");

  if (!f || fwrite(text, 1, n, f) != n || fclose(f) != 0) {
    fprintf(stderr, "%s cannot be written\n", name);
    exit(1);
  }
}

/* model with an objective that compares b.q with column `column` of the record */
static maggi_status load_record(const char *record, size_t n, const char *column, maggi_model **m,
                                char message[256])
{
  char text[600];

  write_file(record_path, record, n);
  n = (size_t)snprintf(text, sizeof text,
                       "%sobjectives:\n- {name: fit, type: least_squares, signal: b.q,\n"
                       "   file: record.csv%s}\n",
                       good, column);
  write_file(model_path, text, n);
  return maggi_model_load(model_path, m, message, 256);
}

/* the objective where b.q is 0: mean of the squares of the record */
static void check_record(const char *record, const char *column, double squares)
{
  maggi_grid grid;
  maggi_model *m;
  maggi_objective *o;
  char message[256];
  double value = NAN, zero = 0.0;
  long k;

  CHECK(load_record(record, strlen(record), column, &m, message) == MAGGI_OK);
  CHECK_TEXT(message, "");
  if (!m) return;
  CHECK(maggi_grid_init(&grid, 3.0, 0.5) == MAGGI_OK);
  CHECK(maggi_objective_named(m, "fit", &o, message, sizeof message) == MAGGI_OK);
  CHECK(maggi_objective_begin(o, &grid, message, sizeof message) == MAGGI_OK);
  for (k = 0; k <= grid.steps; ++k) maggi_objective_push(o, k, &zero);
  CHECK(maggi_objective_end(o, &value, message, sizeof message) == MAGGI_OK);
  CHECK_NEAR(value, squares, 1e-15, 0.0);
  maggi_objective_free(o);
  maggi_model_free(m);
}

static void refuse_record(const char *record, size_t n, const char *column, const char *said)
{
  maggi_model *m = (maggi_model *)good;
  char message[256], expected[256];

  CHECK(load_record(record, n, column, &m, message) == MAGGI_E_MODEL);
  CHECK(m == NULL);
  snprintf(expected, sizeof expected, "%s:%s", record_path, said);
  CHECK_TEXT(message, expected);
}

#define REFUSED(record, said) refuse_record(record, sizeof record - 1, "", said)

static void test_records(void)
{
  maggi_model *m;
  char message[256];

  memcpy(path, folder, sizeof folder);
  if (!CHECK(mkdtemp(path) != NULL)) return;
  snprintf(model_path, sizeof model_path, "%s/model.yaml", path);
  snprintf(record_path, sizeof record_path, "%s/record.csv", path);

  check_record("t,b.q\n0,1\n1,2\n3,-3\n", "", 14.0 / 3.0);
  check_record("t,b.q\r\n0,1\r\n1,2\r\n3,-3\r\n", "", 14.0 / 3.0);
  check_record("\xef\xbb\xbf\"b.q\", \"x\"\"y,\" ,t\n\n2, some text,1\n \n\n1.5e1,\"\",+2.5", "",
               (4.0 + 225.0) / 2.0);
  check_record("t,b.q,other\n0,1,4\n1,2,5\n", ", column: other", 41.0 / 2.0);
  check_record("t,b.q,\"a, \"\"b\"\"\"\n0,1,4\n", ", column: 'a, \"b\"'", 16.0);

  REFUSED("", "1: the record is empty");
  REFUSED("\n\n", "1: the record is empty");
  REFUSED("time,b.q\n", "1: no column \"t\"");
  REFUSED("\nt,b.v\n", "2: no column \"b.q\"");
  REFUSED("t,b.q\n", "2: no rows");
  REFUSED("t,b.q\n0,1\n1\n", "3: 1 fields instead of 2");
  REFUSED("t,b.q\n0,1,2\n", "2: 3 fields instead of 2");
  REFUSED("t,b.q\n0,1\n0.5,x\n", "3: \"x\" is not a number");
  REFUSED("t,b.q\n0,1\n0.5,\n", "3: \"\" is not a number");
  REFUSED("t,b.q\n0,1\n0.5,nan\n", "3: \"nan\" is not a number");
  REFUSED("t,b.q\n0,1\n0.5,0x1p3\n", "3: \"0x1p3\" is not a number");
  REFUSED("t,b.q\n0,1e999\n", "2: \"1e999\" is not a number");
  REFUSED("t,b.q\n0,1\n\n0,2\n", "4: t does not increase (0 after 0)");
  REFUSED("t,b.q\n-1,1\n", "2: t is before 0 (-1)");
  REFUSED("t,b.q\n0,\"1\n", "2: a quote is not closed");
  REFUSED("t,b.q\n0,\"1\"2\n", "2: a text after a quote");
  REFUSED("t,b.q\n0,1\0002\n", "2: a NUL character");
  REFUSED(
      "t,"
      "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"
      "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"
      "a"
      "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\n",
      "1: a field has more than 200 characters");
  refuse_record("t,b.q\n0,1\n", 10, ", column: none", "1: no column \"none\"");

  remove(record_path);
  CHECK(maggi_model_load(model_path, &m, message, sizeof message) == MAGGI_E_FILE);
  CHECK(m == NULL && strstr(message, "model.yaml:8: objectives.fit.file: ") != NULL);
  CHECK(strstr(message, "record.csv: cannot be opened") != NULL);
  remove(model_path);
  CHECK(rmdir(path) == 0);
}

int main(void)
{
  test_message();
  test_bytes();
  test_locale();
  test_files();
  test_same();
  test_records();
  return check_done();
}
