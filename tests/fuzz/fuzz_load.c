/* Fuzzing of the reader of model files, and of a start on what loads: any bytes give a model or one
 * line that says what is wrong, and no model, however odd, makes the library fall.
 *
 * With libFuzzer by scripts/fuzz.  With FUZZ_REPLAY a program for ctest:
 *
 *   fuzz_replay COUNT PATH ..    each file, or each file in a folder, and COUNT damaged copies of
 * it
 *                                (by a seed of their own: the same copies in every run)
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "load.h"
#include "maggi/maggi.h"

/* larger files and models only take longer */
enum { BYTES_MAX = 1 << 14, COORDINATES_MAX = 60, ROWS_MAX = 150, PARAMETERS_MAX = 3000 };

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n);

#define REQUIRE(ok)                                                                                \
  do {                                                                                             \
    if (!(ok)) {                                                                                   \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #ok);                             \
      abort();                                                                                     \
    }                                                                                              \
  } while (0)

/* one line that begins with the name of the file */
static void require_message(const char *message)
{
  REQUIRE(strncmp(message, "fuzz:", 5) == 0);
  REQUIRE(message[5] != '\0' && message[strcspn(message, "\r\n")] == '\0');
}

static void read_results(const maggi_model *m, const maggi_model_info *info, maggi_data *d)
{
  size_t n = (size_t)(6 * info->bodies + 3 * info->coordinates + info->loop_equations +
                      info->sensor_columns + 1);
  double *x = calloc(n, sizeof *x);
  maggi_energy energy;
  maggi_loop_state state;

  REQUIRE(x);
  maggi_get_coordinates(d, x, x + info->coordinates, x + 2 * info->coordinates);
  maggi_get_sensors(d, x);
  maggi_get_reactions(d, x);
  maggi_get_multipliers(d, x);
  maggi_get_drives(d, x);
  maggi_get_energy(d, &energy);
  maggi_get_loop_state(d, &state);
  REQUIRE(state.rank >= 0 && state.dof >= 0);
  REQUIRE(state.rank <= info->loop_equations);
  REQUIRE(maggi_coordinate_name(m, info->coordinates) == NULL);
  free(x);
}

static void simulate(const maggi_model *m, const maggi_model_info *info)
{
  maggi_data *d;
  maggi_status status;
  maggi_loop_state state;
  int i;

  REQUIRE(maggi_data_create(m, &d) == MAGGI_OK);
  status = maggi_data_reset(d);
  if (status == MAGGI_OK) {
    maggi_get_loop_state(d, &state);
    REQUIRE(state.rank + state.dof + info->guided == info->coordinates);
    REQUIRE(state.violation <= 1e-10);
  } else {
    REQUIRE(*maggi_data_message(d));
  }
  read_results(m, info, d);
  for (i = 0; i < 3 && status == MAGGI_OK; ++i) {
    status = maggi_step(d, 1e-3);
    REQUIRE(status == MAGGI_OK || *maggi_data_message(d));
  }
  read_results(m, info, d);
  maggi_data_free(d);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n)
{
  maggi_model *m = NULL;
  maggi_model_info info;
  char message[200] = "";
  maggi_status status;
  int i;

  if (n > BYTES_MAX) return 0;
  status = maggi_model_load_memory("fuzz", (const char *)bytes, n, &m, message, sizeof message);
  REQUIRE((status == MAGGI_OK) == (m != NULL));
  if (status != MAGGI_OK) {
    REQUIRE(status == MAGGI_E_MODEL || status == MAGGI_E_FILE); /* a file that it names */
    require_message(message);
    return 0;
  }
  REQUIRE(!*message);
  maggi_model_get_info(m, &info);
  if (info.coordinates <= COORDINATES_MAX && info.loop_equations <= ROWS_MAX &&
      info.parameters <= PARAMETERS_MAX) {
    for (i = 0; i < info.parameters; ++i) {
      REQUIRE(maggi_parameter_find(m, maggi_parameter_path(m, i)) == i);
      REQUIRE(isfinite(maggi_parameter_default(m, i)));
    }
    simulate(m, &info);
  }
  maggi_model_free(m);
  return 0;
}

#ifdef FUZZ_REPLAY

#include <dirent.h>
#include <sys/stat.h>

static long inputs, loaded;

static uint64_t random64(uint64_t *seed)
{
  uint64_t z = *seed += 0x9E3779B97F4A7C15u;

  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

static size_t below(uint64_t *seed, size_t n)
{
  return n ? (size_t)(random64(seed) % n) : 0;
}

/* in memory of exactly its size, so that a byte read too many is seen */
static void input(const uint8_t *bytes, size_t n)
{
  uint8_t *copy = malloc(n ? n : 1);
  maggi_model *m = NULL;

  REQUIRE(copy);
  memcpy(copy, bytes, n);
  LLVMFuzzerTestOneInput(copy, n);
  ++inputs;
  if (n <= BYTES_MAX &&
      maggi_model_load_memory("fuzz", (const char *)copy, n, &m, NULL, 0) == MAGGI_OK)
    ++loaded;
  maggi_model_free(m);
  free(copy);
}

/* replaces the bytes from..to by text */
static size_t splice(uint8_t *b, size_t n, size_t from, size_t to, const char *text, size_t ntext)
{
  if (n - (to - from) + ntext > 2 * BYTES_MAX) return n;
  memmove(b + from + ntext, b + to, n - to);
  memcpy(b + from, text, ntext);
  return n - (to - from) + ntext;
}

/* the number, or the word, around a place */
static void token(const uint8_t *b, size_t n, size_t at, size_t *from, size_t *to)
{
  static const char ends[] = " \n,:[]{}#\"";

  for (*from = at; *from > 0 && !strchr(ends, b[*from - 1]); --*from)
    ;
  for (*to = at; *to < n && b[*to] && !strchr(ends, b[*to]); ++*to)
    ;
}

static size_t damage(uint8_t *b, size_t n, uint64_t *seed)
{
  static const char *const words[] = {"0",        "-0.0",
                                      "1e308",    "-1e308",
                                      "5e-324",   "nan",
                                      "inf",      "-1",
                                      "1e",       "0x10",
                                      "1e999",    "\"",
                                      "[",        "]",
                                      "{",        "}",
                                      "null",     "~",
                                      "&a",       "*a",
                                      "!!str",    "---\n",
                                      "...\n",    "ground",
                                      "free",     "spherical",
                                      "fixed",    "planar",
                                      "joint:",   "a: a",
                                      "\t",       "\xff",
                                      "\xc3\xa9", "%TAG",
                                      "|\n",      "2147483648",
                                      "1e-300",   "0.1234567890123456789012345678901234567890"};
  size_t from, to, at = below(seed, n);
  char line[512];
  const char *word = words[below(seed, sizeof words / sizeof *words)];

  switch (below(seed, 8)) {
  case 0: /* cut off */
    return at;
  case 1: /* one bit */
    if (n) b[at] ^= (uint8_t)(1u << below(seed, 8));
    return n;
  case 2: /* a piece less */
    to = at + below(seed, 40);
    return splice(b, n, at, to < n ? to : n, "", 0);
  case 3: /* a word for another */
  case 4:
    token(b, n, at, &from, &to);
    return splice(b, n, from, to, word, strlen(word));
  case 5: /* a word more */
    return splice(b, n, at, at, word, strlen(word));
  case 6: /* a line twice, or elsewhere */
    for (from = at; from > 0 && b[from - 1] != '\n'; --from)
      ;
    for (to = at; to < n && b[to] != '\n'; ++to)
      ;
    to += to < n;
    if (to - from > sizeof line) return n;
    memcpy(line, b + from, to - from);
    if (below(seed, 2)) {
      to -= from;
      n = splice(b, n, from, from + to, "", 0);
      at = below(seed, n);
      while (at > 0 && b[at - 1] != '\n') --at;
      return splice(b, n, at, at, line, to);
    }
    return splice(b, n, from, from, line, to - from);
  default: /* the word of another place */
    token(b, n, at, &from, &to);
    if (to - from >= sizeof line) return n;
    memcpy(line, b + from, to - from);
    at = to - from;
    token(b, n, below(seed, n), &from, &to);
    return splice(b, n, from, to, line, at);
  }
}

static void replay(const char *path, int count)
{
  static uint8_t bytes[BYTES_MAX], copy[4 * BYTES_MAX];
  FILE *file = fopen(path, "rb");
  size_t n, k;
  uint64_t seed = 1;
  int i, j;

  if (!file) {
    perror(path);
    exit(1);
  }
  n = fread(bytes, 1, sizeof bytes, file);
  fclose(file);
  input(bytes, n);
  for (i = 0; i < count; ++i) {
    memcpy(copy, bytes, n);
    k = n;
    for (j = (int)below(&seed, 3); j >= 0; --j) k = damage(copy, k, &seed);
    input(copy, k);
  }
}

static int by_name(const void *a, const void *b)
{
  return strcmp(*(char *const *)a, *(char *const *)b);
}

static void replay_folder(const char *folder, int count)
{
  char *names[4096], path[4096];
  struct dirent *entry;
  DIR *dir = opendir(folder);
  int n = 0, i;

  if (!dir) {
    perror(folder);
    exit(1);
  }
  while ((entry = readdir(dir)) && n < 4096)
    if (entry->d_name[0] != '.' && !strstr(entry->d_name, ".py") && !strstr(entry->d_name, ".md"))
      REQUIRE(names[n++] = strdup(entry->d_name));
  closedir(dir);
  qsort(names, (size_t)n, sizeof *names, by_name);
  for (i = 0; i < n; ++i) {
    snprintf(path, sizeof path, "%s/%s", folder, names[i]);
    replay(path, count);
    free(names[i]);
  }
}

int main(int argc, char **argv)
{
  struct stat s;
  int i;

  for (i = 2; i < argc; ++i) {
    if (stat(argv[i], &s) == 0 && S_ISDIR(s.st_mode))
      replay_folder(argv[i], atoi(argv[1]));
    else
      replay(argv[i], atoi(argv[1]));
  }
  printf("%ld inputs, %ld of them models\n", inputs, loaded);
  return inputs == 0 || loaded == 0;
}

#endif
