#include "sample.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "property/subject.h"

enum { STEPS = 12 };

/* a few steps from the start, then everything that can be asked */
static int move(maggi_data *d, double step)
{
  int i;

  for (i = 0; i < STEPS; ++i)
    if (maggi_step(d, step) != MAGGI_OK) return 0;
  maggi_evaluate(d, d->time);
  maggi_results(d);
  return 1;
}

static void check_random(uint64_t seed, int verbose, sample_check *check)
{
  subject *m = calloc(1, sizeof *m);
  char name[40];
  sample s = {name, seed, NULL, NULL};

  if (!m) abort();
  snprintf(name, sizeof name, "seed %llu", (unsigned long long)seed);
  if (verbose) printf("%s: %s\n", name, mech_kind_text((mech_kind)(seed % MECH_KINDS)));
  if (subject_create(seed, m) && report_true(seed, "a few steps succeed", move(m->data, 1e-3))) {
    s.model = m->model;
    s.data = m->data;
    check(&s);
  }
  subject_free(m);
  free(m);
}

#ifdef DERIVATIVE_YAML
/* of a model, from its name: another model in the folder does not move it (FNV-1a) */
static uint64_t seed_of(const char *name)
{
  uint32_t seed = 2166136261u;

  for (; *name; ++name) seed = (seed ^ (unsigned char)*name) * 16777619u;
  return seed;
}

static void check_model(const char *file, sample_check *check)
{
  char path[512], message[512];
  uint64_t seed = seed_of(file);
  sample s = {file, seed, NULL, NULL};
  maggi_model_info info;
  int ok;

  snprintf(path, sizeof path, "%s/%s", MAGGI_MODELS_DIR, file);
  ok = maggi_model_load(path, &s.model, message, sizeof message) == MAGGI_OK &&
       maggi_data_create(s.model, &s.data) == MAGGI_OK && maggi_data_reset(s.data) == MAGGI_OK;
  if (ok) {
    maggi_model_get_info(s.model, &info);
    ok = move(s.data, info.simulation.step > 0.0 ? info.simulation.step : 1e-3);
  }
  if (report_true(seed, "the model of a file moves", ok))
    check(&s);
  else
    fprintf(stderr, "%s: %s\n", file, s.data ? maggi_data_message(s.data) : message);
  maggi_data_free(s.data);
  maggi_model_free(s.model);
}

static int is_model(const struct dirent *entry)
{
  const char *end = strrchr(entry->d_name, '.');

  return end && strcmp(end, ".yaml") == 0;
}

static void check_models(sample_check *check)
{
  struct dirent **file = NULL;
  int i, n = scandir(MAGGI_MODELS_DIR, &file, is_model, alphasort);

  report_true(0, "there are models", n > 0);
  for (i = 0; i < n; ++i) {
    check_model(file[i]->d_name, check);
    free(file[i]);
  }
  free(file);
}
#endif

void sample_each(const report_options *options, sample_check *check)
{
  long i;

#ifdef DERIVATIVE_YAML
  if (!options->verbose) check_models(check);
#endif
  for (i = 0; i < options->count; ++i)
    check_random(options->from + (uint64_t)i, options->verbose, check);
}
