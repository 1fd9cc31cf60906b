/* maggi equilibrium: where a model stands still. */
#include <stdio.h>
#include <stdlib.h>

#include <maggi/maggi.h>

#include "commands.h"
#include "json.h"
#include "message.h"
#include "standstill.h"

/* all numbers of the report */
typedef struct report {
  const standstill *s;
  int nspring, nwheel;
  double *q, *length, *force, *load;
} report;

static int name_width(const report *r)
{
  int i, n, width = 0;

  for (i = 0; i < r->s->info.coordinates; ++i) {
    n = snprintf(NULL, 0, "%s", maggi_coordinate_name(r->s->model, i));
    width = n > width ? n : width;
  }
  for (i = 0; i < r->nspring; ++i) {
    n = snprintf(NULL, 0, "%s", maggi_spring_name(r->s->model, i));
    width = n > width ? n : width;
  }
  for (i = 0; i < r->nwheel; ++i) {
    n = snprintf(NULL, 0, "%s", maggi_wheel_name(r->s->model, i));
    width = n > width ? n : width;
  }
  return width;
}

static void print_text(const report *r)
{
  const maggi_equilibrium_state *e = &r->s->state;
  const maggi_model *m = r->s->model;
  int i, width = name_width(r);

  printf("model         %s\n", r->s->info.name);
  printf("equilibrium   %d coordinates, %d iterations of Newton's method", e->coordinates,
         e->iterations);
  if (e->damped > 0) printf(", %d steps of a damped run", e->damped);
  printf("; accelerations below %.2g\n\ncoordinates\n", e->residual);
  for (i = 0; i < r->s->info.coordinates; ++i)
    printf("  %-*s  %17.12g %s\n", width, maggi_coordinate_name(m, i), r->q[i],
           maggi_coordinate_is_angle(m, i) ? "rad" : "m");
  if (r->nwheel > 0) puts("\nwheels");
  for (i = 0; i < r->nwheel; ++i)
    printf("  %-*s  load %12.10g N\n", width, maggi_wheel_name(m, i), r->load[i]);
  if (r->nspring > 0) puts("\nsprings");
  for (i = 0; i < r->nspring; ++i)
    printf("  %-*s  length %10.8g m  force %12.10g N\n", width, maggi_spring_name(m, i),
           r->length[i], r->force[i]);
}

static void print_json(const report *r)
{
  const maggi_equilibrium_state *e = &r->s->state;
  const maggi_model *m = r->s->model;
  json j;
  int i;

  json_init(&j, stdout);
  json_open_object(&j, NULL);
  json_string(&j, "model", r->s->info.name);
  json_integer(&j, "iterations", e->iterations);
  json_integer(&j, "damped", e->damped);
  json_number(&j, "residual", e->residual);
  json_open_array(&j, "coordinates");
  for (i = 0; i < r->s->info.coordinates; ++i) {
    json_open_object(&j, NULL);
    json_string(&j, "name", maggi_coordinate_name(m, i));
    json_number(&j, "value", r->q[i]);
    json_string(&j, "unit", maggi_coordinate_is_angle(m, i) ? "rad" : "m");
    json_close_object(&j);
  }
  json_close_array(&j);
  json_open_array(&j, "wheels");
  for (i = 0; i < r->nwheel; ++i) {
    json_open_object(&j, NULL);
    json_string(&j, "name", maggi_wheel_name(m, i));
    json_number(&j, "load", r->load[i]);
    json_close_object(&j);
  }
  json_close_array(&j);
  json_open_array(&j, "springs");
  for (i = 0; i < r->nspring; ++i) {
    json_open_object(&j, NULL);
    json_string(&j, "name", maggi_spring_name(m, i));
    json_number(&j, "length", r->length[i]);
    json_number(&j, "force", r->force[i]);
    json_close_object(&j);
  }
  json_close_array(&j);
  json_close_object(&j);
}

static int show(const standstill *s)
{
  report r = {.s = s};
  int status = STATUS_DONE;
  size_t n;

  while (maggi_spring_name(s->model, r.nspring)) ++r.nspring;
  while (maggi_wheel_name(s->model, r.nwheel)) ++r.nwheel;
  n = (size_t)s->info.coordinates + 2 * (size_t)r.nspring + (size_t)r.nwheel;
  r.q = calloc(n + 1, sizeof *r.q);
  if (!r.q) return message_fail(STATUS_FAILED, "%s: out of memory", s->spec);
  r.length = r.q + s->info.coordinates;
  r.force = r.length + r.nspring;
  r.load = r.force + r.nspring;
  maggi_get_coordinates(s->data, r.q, NULL, NULL);
  maggi_equilibrium_get_springs(s->data, r.length, r.force);
  maggi_equilibrium_get_wheels(s->data, r.load);
  (s->json ? print_json : print_text)(&r);
  free(r.q);
  return status;
}

int command_equilibrium(int argc, char **argv)
{
  return standstill_run(argc, argv, show);
}
