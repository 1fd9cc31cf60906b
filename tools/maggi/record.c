/* The record of a run. */
#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700 /* gmtime_r, realpath */
#endif
#include "record.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <maggi/maggi.h>

#include "message.h"
#include "sheet.h"
#include "summary.h"

#define RECORD_VERSION 1
#define PLAIN                                                                                      \
  "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=+,%@" /* no quotes */

/* a word as a shell reads it, behind `to`: where it ends */
static char *quote(char *to, const char *word)
{
  if (word[0] != '\0' && word[strspn(word, PLAIN)] == '\0') {
    strcpy(to, word);
    return to + strlen(word);
  }
  *to++ = '\'';
  for (; *word; ++word) {
    if (*word == '\'') {
      strcpy(to, "'\\'");
      to += 3;
    }
    *to++ = *word;
  }
  *to++ = '\'';
  *to = '\0';
  return to;
}

int record_init(record *r, int argc, char **argv)
{
  size_t size = sizeof "maggi";
  char *to;
  int i;

  memset(r, 0, sizeof *r);
  for (i = 0; i < argc; ++i) size += 4 * strlen(argv[i]) + 4;
  r->command = to = malloc(size);
  if (!to) {
    message_fail(STATUS_FAILED, "out of memory");
    return -1;
  }
  strcpy(to, "maggi");
  to += strlen(to);
  for (i = 0; i < argc; ++i) {
    *to++ = ' ';
    to = quote(to, argv[i]);
  }
  return 0;
}

void record_free(record *r)
{
  table_discard(&r->table);
  free(r->name);
  free(r->command);
  r->name = r->command = NULL;
}

char *record_name(const char *csv)
{
  static const char ending[] = ".json";
  char *name = malloc(strlen(csv) + sizeof ending);

  if (!name)
    message_fail(STATUS_FAILED, "out of memory");
  else
    strcat(strcpy(name, csv), ending);
  return name;
}

static void write_column(json *j, const char *name, const char *suffix, const char *unit)
{
  char text[400];

  snprintf(text, sizeof text, "%s%s", name, suffix);
  json_open_object(j, NULL);
  json_string(j, "name", text);
  json_string(j, "unit", unit);
  json_close_object(j);
}

/* in the order of rows_header */
static void write_columns(json *j, const rows *r)
{
  static const char *const wrench[6] = {".fx", ".fy", ".fz", ".mx", ".my", ".mz"};
  static const char *const energy[4] = {".kinetic", ".potential", ".total", ".work"};
  const char *name;
  int i, k, is_angle;

  json_open_array(j, "columns");
  write_column(j, "t", "", "s");
  for (i = 0; i < r->info.coordinates; ++i) {
    name = maggi_coordinate_name(r->model, i);
    is_angle = maggi_coordinate_is_angle(r->model, i);
    write_column(j, name, ".q", is_angle ? "rad" : "m");
    write_column(j, name, ".v", is_angle ? "rad/s" : "m/s");
    write_column(j, name, ".a", is_angle ? "rad/s^2" : "m/s^2");
  }
  for (k = 0; r->energy && k < 4; ++k) write_column(j, "energy", energy[k], "J");
  for (i = 0; i < r->nreaction; ++i)
    for (k = 0; k < 6; ++k)
      write_column(j, maggi_body_name(r->model, r->reaction[i]), wrench[k], k < 3 ? "N" : "N m");
  for (i = 0; i < r->info.sensor_columns; ++i)
    write_column(j, maggi_sensor_column_name(r->model, i), "",
                 maggi_sensor_column_unit(r->model, i));
  for (i = 0; i < r->info.filters; ++i)
    write_column(j, maggi_filter_column_name(r->model, i), "",
                 maggi_filter_column_unit(r->model, i));
  if (r->info.loops > 0) {
    write_column(j, "loops.pivot_ratio", "", "-");
    write_column(j, "loops.violation", "", "m, rad");
  }
  json_close_array(j);
}

static void write_settings(json *j, const settings *set)
{
  int i;

  json_open_object(j, "set");
  for (i = 0; i < set->number; ++i) json_number(j, set->entry[i].path, set->entry[i].value);
  json_close_object(j);
}

static void write_model(json *j, const run *what)
{
  subject s;

  s.model = what->rows->model;
  s.data = what->data;
  s.info = what->rows->info;
  s.is_reset = 1;
  s.loops = what->loops;
  json_open_object(j, "model");
  json_string(j, "model", s.info.name);
  sheet_json(j, &s);
  json_close_object(j);
}

/* of the model file, from the root on; null for a generated model */
static void write_path(json *j, const char *path)
{
  char *whole = path[0] ? realpath(path, NULL) : NULL;

  json_string(j, "path", whole ? whole : path[0] ? path : NULL);
  free(whole);
}

static void write_all(const record *r, const run *what, json *j)
{
  char date[32];
  time_t now = time(NULL);
  struct tm utc;

  json_open_object(j, NULL);
  json_string(j, "format", "maggi-run");
  json_integer(j, "version", RECORD_VERSION);
  json_string(j, "maggi", MAGGI_VERSION);
  if (gmtime_r(&now, &utc) && strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &utc) > 0)
    json_string(j, "date", date);
  json_string(j, "command", r->command);
  json_string(j, "file", r->model);
  write_path(j, r->path);
  write_settings(j, r->set);
  json_integer(j, "every", what->every);
  if (r->tolerance > 0.0) json_number(j, "tolerance", r->tolerance);
  json_open_object(j, "run");
  summary_members(what, r->out, j);
  json_close_object(j);
  write_columns(j, what->rows);
  write_model(j, what);
  json_close_object(j);
}

int record_write(record *r, const run *what)
{
  json j;
  int status;

  if (!what->rows->table.part) return STATUS_DONE; /* no regular file */
  r->name = record_name(what->rows->table.name);
  if (!r->name) return STATUS_FAILED;
  status = table_open(&r->table, r->name);
  if (status != STATUS_DONE) return status;
  json_init(&j, r->table.file);
  write_all(r, what, &j);
  return STATUS_DONE;
}

int record_close(record *r)
{
  if (r->table.file) table_end_header(&r->table); /* notes an error of writing */
  return table_close(&r->table);
}
