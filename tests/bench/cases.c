#define _POSIX_C_SOURCE 200809L

#include "cases.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "data.h"
#include "flops.h"
#include "timing.h"

static const double sample_seconds = 0.5e-3;
enum { STEPS_BEFORE = 10 };

/* tests/references/T6_multi_fourbar: absolute angles of the first and the last row at 5 s */
static const double reference_time = 5.0;
static const double reference_first = -1.101711811731;
static const double reference_last = -0.652517178718;
enum { REFERENCE_ROWS = 15 };

#ifdef MAGGI_BENCH_YAML
enum { can_load = 1 };
#else
enum { can_load = 0 };
#endif

static int complain(const char *what, const char *why)
{
  fprintf(stderr, "bench: %s: %s\n", what, why);
  return 0;
}

static int open_model(bench_case *c, const char *spec)
{
  maggi_status status;
  char message[512], path[1024];

  if (sscanf(spec, "multiple-four-bar:%dx%d", &c->ny, &c->nz) == 2) {
    status = maggi_model_multiple_four_bar(c->ny, c->nz, &c->m);
    return status == MAGGI_OK || complain(spec, maggi_status_text(status));
  }
#ifdef MAGGI_BENCH_YAML
  if (strstr(spec, ".yaml"))
    snprintf(path, sizeof path, "%s", spec);
  else
    snprintf(path, sizeof path, "%s/%s.yaml", MAGGI_MODELS_DIR, spec);
  status = maggi_model_load(path, &c->m, message, sizeof message);
  return status == MAGGI_OK || complain(spec, message);
#else
  (void)path;
  (void)message;
  return complain(spec, "this build reads no model files");
#endif
}

static double proposed_step(const bench_case *c)
{
  maggi_model_info info;

  maggi_model_get_info(c->m, &info);
  return info.simulation.step > 0.0 && info.simulation.step < 1e-3 ? info.simulation.step : 1e-3;
}

int case_open(bench_case *c, const char *spec)
{
  maggi_model_info info;
  maggi_loop_state state;
  maggi_status status;
  double step;
  int i;

  memset(c, 0, sizeof *c);
  snprintf(c->name, sizeof c->name, "%s", spec);
  if (!open_model(c, spec))
    return 0;
  status = maggi_data_create(c->m, &c->d);
  if (status != MAGGI_OK)
    return complain(spec, maggi_status_text(status));
  status = maggi_data_reset(c->d);
  step = proposed_step(c);
  for (i = 0; i < STEPS_BEFORE && status == MAGGI_OK; ++i)
    status = maggi_step(c->d, step);
  if (status != MAGGI_OK)
    return complain(spec, maggi_data_message(c->d));
  maggi_model_get_info(c->m, &info);
  maggi_get_loop_state(c->d, &state);
  c->time = maggi_get_time(c->d);
  c->coordinates = info.coordinates;
  c->dof = state.dof;
  return 1;
}

void case_close(bench_case *c)
{
  maggi_data_free(c->d);
  maggi_model_free(c->m);
  c->d = NULL;
  c->m = NULL;
}

static double batch_seconds(const bench_case *c, int n)
{
  double begin = cpu_seconds();
  int i;

  for (i = 0; i < n; ++i)
    maggi_evaluate(c->d, c->time);
  return cpu_seconds() - begin;
}

static int batch_size(const bench_case *c)
{
  int n = 1;

  batch_seconds(c, 2); /* caches */
  while (n < 1 << 20 && batch_seconds(c, n) < sample_seconds)
    n *= 2;
  return n;
}

void cases_measure(int n, bench_case cases[], int rounds, int samples)
{
  bench_case *c;
  int i, k, round;

  for (round = 0; round < rounds; ++round) {
    for (i = 0; i < n; ++i) {
      c = &cases[i];
      if (round == 0)
        c->batch = batch_size(c);
      batch_seconds(c, 1 + c->batch / 4);
      for (k = 0; k < samples && c->nsample < CASE_SAMPLES; ++k)
        c->sample[c->nsample++] = 1e6 * batch_seconds(c, c->batch) / c->batch;
    }
  }
  for (i = 0; i < n; ++i) {
    c = &cases[i];
    sort_samples(c->nsample, c->sample);
    c->us = quantile(c->nsample, c->sample, 0.5);
    c->low = quantile(c->nsample, c->sample, 0.25);
    c->high = quantile(c->nsample, c->sample, 0.75);
  }
}

void case_count(bench_case *c, bench_flops *f)
{
  int i;

  memset(f, 0, sizeof *f);
  flops_derive(&c->d->t, c->d->chol, 1, f->needed);
  flops_derive(&c->d->t, c->d->chol, MAGGI_WIDTH, f->blocks);
#ifdef BENCH_STAGED
  staged s;
  int k;

  memset(&s, 0, sizeof s);
  staged_counted(c->d, c->time, &s);
  for (i = 0; i < STAGED_COUNT; ++i)
    for (k = 0; k < FLOP_COUNT; ++k)
      f->executed[i] += s.flops[i][k];
#endif
  c->flops = 0;
  c->blocks = 0;
  c->executed = 0;
  for (i = 0; i < STAGED_COUNT; ++i) {
    c->flops += f->needed[i];
    c->blocks += f->blocks[i];
    c->executed += f->executed[i];
  }
}

static int by_name(const void *a, const void *b)
{
  return strcmp(a, b);
}

int shipped_models(int max, char names[][CASE_NAME])
{
  DIR *folder = can_load ? opendir(MAGGI_MODELS_DIR) : NULL;
  struct dirent *entry;
  const char *end;
  int n = 0;

  if (!folder)
    return 0;
  while (n < max && (entry = readdir(folder))) {
    end = strstr(entry->d_name, ".yaml");
    if (end && end[5] == '\0' && end - entry->d_name < CASE_NAME) {
      snprintf(names[n], CASE_NAME, "%.*s", (int)(end - entry->d_name), entry->d_name);
      ++n;
    }
  }
  closedir(folder);
  qsort(names, (size_t)n, CASE_NAME, by_name);
  return n;
}

/* absolute angles of the first and the last row against the reference */
static double end_error(const maggi_data *d)
{
  char name[CASE_NAME];
  double q[3 * REFERENCE_ROWS];
  double angle = 0.0, first = 0.0;
  int row;

  maggi_get_coordinates(d, q, NULL, NULL);
  for (row = 1; row <= REFERENCE_ROWS; ++row) {
    snprintf(name, sizeof name, "v_%d_1", row);
    angle += q[maggi_coordinate_find(d->m, name)];
    if (row == 1)
      first = angle;
  }
  return fmax(fabs(first - reference_first), fabs(angle - reference_last));
}

maggi_status run_array(maggi_data *d, double step, bench_run *r)
{
  maggi_loop_state before, after;
  maggi_status status;
  double begin;
  int i, n = (int)(reference_time / step + 0.5);

  r->step = step;
  r->cpu = NAN;
  r->error = NAN;
  status = maggi_data_reset(d);
  if (status != MAGGI_OK)
    return status;
  maggi_get_loop_state(d, &before);
  begin = cpu_seconds();
  for (i = 0; i < n; ++i) {
    status = maggi_step(d, reference_time / n);
    if (status != MAGGI_OK)
      return status;
  }
  r->cpu = cpu_seconds() - begin;
  r->error = end_error(d);
  maggi_get_loop_state(d, &after);
  r->evaluations = after.evaluations - before.evaluations;
  r->projections = after.projections - before.projections;
  return MAGGI_OK;
}

static double total_energy(maggi_data *d)
{
  maggi_energy e;

  maggi_get_energy(d, &e);
  return e.kinetic + e.potential;
}

maggi_status run_energy(maggi_data *d, double step, bench_run *r)
{
  maggi_status status;
  double at_start, change;
  int i, n = (int)(reference_time / step + 0.5);

  r->drift = NAN;
  status = maggi_data_reset(d);
  if (status != MAGGI_OK)
    return status;
  at_start = total_energy(d);
  r->drift = 0.0;
  for (i = 0; i < n; ++i) {
    status = maggi_step(d, reference_time / n);
    if (status != MAGGI_OK) {
      r->drift = NAN;
      return status;
    }
    change = (total_energy(d) - at_start) / fabs(at_start);
    if (fabs(change) > fabs(r->drift))
      r->drift = change;
  }
  return MAGGI_OK;
}
