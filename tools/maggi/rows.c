/* Columns of a simulation, in this order: time, coordinates, energy, reactions, sensors, filters,
 * loops. */
#include "rows.h"

#include <stdlib.h>
#include <string.h>

#include "message.h"
#include "nearest.h"

static const char *const wrench_suffix[6] = {".fx", ".fy", ".fz", ".mx", ".my", ".mz"};

static int unknown_body(const rows *r, const char *name)
{
  nearest n;
  int i;

  if (strcmp(name, MAGGI_GROUND) == 0)
    return message_fail(STATUS_USAGE, "--reactions: the ground has no joint");
  nearest_init(&n, name);
  for (i = 0; i < r->info.bodies; ++i) nearest_offer(&n, maggi_body_name(r->model, i));
  return message_fail(STATUS_USAGE, "--reactions: no body \"%s\" in model %s%s", name, r->info.name,
                      nearest_hint(&n));
}

static int add_reaction(rows *r, const char *name)
{
  int body, i;

  if (name[0] == '\0')
    return message_fail(STATUS_USAGE, "--reactions: an empty name in the list of bodies");
  body = maggi_body_find(r->model, name);
  if (body < 0) return unknown_body(r, name);
  for (i = 0; i < r->nreaction; ++i)
    if (r->reaction[i] == body)
      return message_fail(STATUS_USAGE, "--reactions: %s is named twice", name);
  r->reaction[r->nreaction++] = body;
  return STATUS_DONE;
}

static int parse_reactions(rows *r, const char *reactions)
{
  char *list, *name, *comma;
  int i, status = STATUS_DONE;

  if (strcmp(reactions, "all") == 0) {
    for (i = 0; i < r->info.bodies; ++i) r->reaction[i] = i;
    r->nreaction = r->info.bodies;
    return STATUS_DONE;
  }
  list = strdup(reactions);
  if (!list) return message_fail(STATUS_FAILED, "out of memory");
  for (name = list; name && status == STATUS_DONE; name = comma) {
    comma = strchr(name, ',');
    if (comma) *comma++ = '\0';
    status = add_reaction(r, name);
  }
  free(list);
  return status;
}

int rows_init(rows *r, const maggi_model *m, int energy, const char *reactions)
{
  size_t n;

  memset(r, 0, sizeof *r);
  r->model = m;
  r->energy = energy;
  maggi_model_get_info(m, &r->info);
  n = (size_t)r->info.coordinates + 1; /* never an allocation of nothing */
  r->q = calloc(n, sizeof *r->q);
  r->v = calloc(n, sizeof *r->v);
  r->a = calloc(n, sizeof *r->a);
  r->sensor = calloc((size_t)r->info.sensor_columns + 1, sizeof *r->sensor);
  r->filter = calloc((size_t)r->info.filters + 1, sizeof *r->filter);
  r->wrench = calloc((size_t)r->info.bodies * 6 + 1, sizeof *r->wrench);
  r->reaction = calloc((size_t)r->info.bodies + 1, sizeof *r->reaction);
  if (!r->q || !r->v || !r->a || !r->sensor || !r->filter || !r->wrench || !r->reaction)
    return message_fail(STATUS_FAILED, "out of memory");
  return reactions ? parse_reactions(r, reactions) : STATUS_DONE;
}

void rows_free(rows *r)
{
  free(r->q);
  free(r->v);
  free(r->a);
  free(r->sensor);
  free(r->filter);
  free(r->wrench);
  free(r->reaction);
}

void rows_header(rows *r)
{
  table *t = &r->table;
  const char *name;
  int i, k;

  table_title(t, "t", NULL);
  for (i = 0; i < r->info.coordinates; ++i) {
    name = maggi_coordinate_name(r->model, i);
    table_title(t, name, ".q");
    table_title(t, name, ".v");
    table_title(t, name, ".a");
  }
  if (r->energy) {
    table_title(t, "energy.kinetic", NULL);
    table_title(t, "energy.potential", NULL);
    table_title(t, "energy.total", NULL);
    table_title(t, "energy.work", NULL);
  }
  for (i = 0; i < r->nreaction; ++i)
    for (k = 0; k < 6; ++k)
      table_title(t, maggi_body_name(r->model, r->reaction[i]), wrench_suffix[k]);
  for (i = 0; i < r->info.sensor_columns; ++i)
    table_title(t, maggi_sensor_column_name(r->model, i), NULL);
  for (i = 0; i < r->info.filters; ++i) table_title(t, maggi_filter_column_name(r->model, i), NULL);
  if (r->info.loops > 0) {
    table_title(t, "loops.pivot_ratio", NULL);
    table_title(t, "loops.violation", NULL);
  }
  table_end_header(t);
}

void rows_write(rows *r, maggi_data *d)
{
  table *t = &r->table;
  maggi_loop_state loops;
  maggi_energy e;
  int i, k;

  table_number(t, maggi_get_time(d));
  maggi_get_coordinates(d, r->q, r->v, r->a);
  for (i = 0; i < r->info.coordinates; ++i) {
    table_number(t, r->q[i]);
    table_number(t, r->v[i]);
    table_number(t, r->a[i]);
  }
  if (r->energy) {
    maggi_get_energy(d, &e);
    table_number(t, e.kinetic);
    table_number(t, e.potential);
    table_number(t, e.kinetic + e.potential);
    table_number(t, e.work);
  }
  if (r->nreaction > 0) maggi_get_reactions(d, r->wrench);
  for (i = 0; i < r->nreaction; ++i)
    for (k = 0; k < 6; ++k) table_number(t, r->wrench[6 * r->reaction[i] + k]);
  maggi_get_sensors(d, r->sensor);
  for (i = 0; i < r->info.sensor_columns; ++i) table_number(t, r->sensor[i]);
  maggi_get_filters(d, r->filter);
  for (i = 0; i < r->info.filters; ++i) table_number(t, r->filter[i]);
  if (r->info.loops > 0) {
    maggi_get_loop_state(d, &loops);
    table_number(t, loops.pivot_ratio);
    table_number(t, loops.violation);
  }
  table_end_row(t);
}
