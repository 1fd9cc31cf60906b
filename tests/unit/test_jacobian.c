/* core/implicit/jacobian.c: the five ways to J agree, on the models of models/, the array of the
 * thesis and a machine with everything; J against differences of forces that the test assembles
 * itself; names. */
#include <dirent.h>

#include "jacobian_ways.h"
#include "machine.h"
#include "open_chain.h"

static void examine(const char *name, maggi_model *m)
{
  maggi_data *d = test_start(m);
  jacobian_findings f = jacobian_ways_examine(d, 3, 11);

  if (!CHECK(f.is_same && f.exact <= 1e-13 && f.difference <= 1e-7))
    fprintf(stderr, "  %s: same %d, exact %.3g, difference %.3g\n", name, f.is_same, f.exact,
            f.difference);
  if (check_scale() == 0.0)
    printf("%s: exact %.3g, difference %.3g\n", name, f.exact, f.difference);
  test_free(d, m);
}

static void test_models(void)
{
  DIR *folder = opendir(MAGGI_MODELS_DIR);
  struct dirent *entry;
  const char *end;
  maggi_model *m;
  int n = 0;

  while (folder && (entry = readdir(folder))) {
    end = strrchr(entry->d_name, '.');
    if (!end || strcmp(end, ".yaml") != 0) continue;
    ++n;
    examine(entry->d_name, test_file(entry->d_name));
  }
  CHECK(n > 15);
  if (folder) closedir(folder);
  examine("machine", machine_model());
  CHECK(maggi_model_multiple_four_bar(2, 6, &m) == MAGGI_OK);
  examine("array", m);
}

/* forces from calls of the kernel, every entry of the dense J */
static void test_against_kernel(void)
{
  maggi_model *m = machine_model();
  maggi_data *d = test_start(m);
  maggi_force_jacobian *j;
  unsigned long long seed = 3;
  double *dense, *error, size = 0.0, at;
  int i, c, k, n;

  if (!CHECK(maggi_force_jacobian_create(d, MAGGI_JACOBIAN_TANGENT_COLOURED, &j) == MAGGI_OK))
    exit(1);
  n = j->pattern->n;
  dense = calloc((size_t)(2 * n * n), sizeof *dense);
  error = calloc((size_t)n, sizeof *error);
  jacobian_ways_state(d, &seed);
  maggi_force_jacobian_compute(j, 0.4);
  open_chain_jacobian(d, j->pattern, dense, error);
  for (i = 0; i < 2 * n * n; ++i) size = fmax(size, fabs(dense[i]));
  for (c = 0; c < 2 * n; ++c) {
    for (k = j->pattern->J.coladr[c]; k < j->pattern->J.coladr[c + 1]; ++k) {
      at = dense[j->pattern->J.row[k] * 2 * n + c];
      CHECK_NEAR(j->value[k], at, 0.0, 1e-9 * size);
      dense[j->pattern->J.row[k] * 2 * n + c] = 0.0;
    }
  }
  for (i = 0; i < 2 * n * n; ++i) CHECK_NEAR(dense[i], 0.0, 0.0, 1e-9 * size);
  free(dense);
  free(error);
  maggi_force_jacobian_free(j);
  maggi_force_jacobian_free(NULL);
  test_free(d, m);
}

static void test_names(void)
{
  int way;

  CHECK_TEXT(maggi_jacobian_name(MAGGI_JACOBIAN_TANGENT_COLOURED), "tangent-coloured");
  CHECK_TEXT(maggi_jacobian_name(MAGGI_JACOBIAN_DIFFERENCE), "difference");
  for (way = 0; way < MAGGI_JACOBIAN_COUNT; ++way)
    CHECK(maggi_jacobian_find(maggi_jacobian_name((maggi_jacobian)way)) == way);
  CHECK(maggi_jacobian_find("tangents") == -1);
  CHECK(maggi_jacobian_name(MAGGI_JACOBIAN_COUNT) == NULL);
  CHECK(maggi_jacobian_name((maggi_jacobian)-1) == NULL);
}

int main(void)
{
  test_models();
  test_against_kernel();
  test_names();
  return check_done();
}
