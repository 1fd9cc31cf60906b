#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700
#endif
#include "points.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "message.h"
#include "options.h"

enum { POINTS_MOST = 10000000 };

static const struct {
  const char *name, *unit;
} numbers[POINT_NUMBERS] = {
    {"kappa", "-"}, {"alpha", "rad"}, {"gamma", "rad"}, {"fz", "N"}, {"vx", "m/s"}};

const char *point_name(int k)
{
  return numbers[k].name;
}

const char *point_unit(int k)
{
  return numbers[k].unit;
}

int point_find(const char *name)
{
  int k;

  for (k = 0; k < POINT_NUMBERS; ++k)
    if (strcasecmp(name, numbers[k].name) == 0) return k;
  return -1;
}

void points_free(points *p)
{
  free(p->slip);
  p->slip = NULL;
  p->number = 0;
}

static int grow(points *p, int *room)
{
  double(*larger)[POINT_NUMBERS];

  if (p->number < *room) return 0;
  if (*room >= POINTS_MOST) return -1;
  *room = *room ? 2 * *room : 256;
  larger = realloc(p->slip, (size_t)*room * sizeof *larger);
  if (!larger) return -1;
  p->slip = larger;
  return 0;
}

/* ---------------------------------------------------------------------------------------- sweep */

/* NAME=FROM:TO:N */
static int parse_sweep(const char *text, int *k, double *from, double *to, long *n)
{
  char name[16], first[64], last[64], number[64];
  int end = 0;

  if (sscanf(text, "%15[^=]=%63[^:]:%63[^:]:%63[^:]%n", name, first, last, number, &end) != 4 ||
      text[end] != '\0')
    return message_fail(STATUS_USAGE, "--sweep: \"%s\" is not NAME=FROM:TO:N", text);
  *k = point_find(name);
  if (*k < 0)
    return message_fail(STATUS_USAGE, "--sweep: \"%s\" is none of kappa, alpha, gamma, fz, vx",
                        name);
  if (options_number("--sweep", first, from) || options_number("--sweep", last, to) ||
      options_count("--sweep", number, 2, n))
    return STATUS_USAGE;
  if (*n > POINTS_MOST) return message_fail(STATUS_USAGE, "--sweep: %s is too large", number);
  return STATUS_DONE;
}

int points_sweep(points *p, const double at[POINT_NUMBERS], const char *sweep)
{
  double from = 0.0, to = 0.0;
  long n = 1, i;
  int k = 0, status = STATUS_DONE;

  if (sweep) status = parse_sweep(sweep, &k, &from, &to, &n);
  if (status != STATUS_DONE) return status;
  p->slip = malloc((size_t)n * sizeof *p->slip);
  if (!p->slip) return message_fail(STATUS_FAILED, "out of memory");
  for (i = 0; i < n; ++i) {
    memcpy(p->slip[i], at, sizeof *p->slip);
    if (sweep) p->slip[i][k] = i == n - 1 ? to : from + (to - from) * (double)i / (double)(n - 1);
  }
  p->number = (int)n;
  return STATUS_DONE;
}

/* ----------------------------------------------------------------------------------------- file */

/* next cell of a line, without spaces around it; *line behind it, NULL after the last */
static char *next_cell(char **line)
{
  char *cell = *line, *comma = strchr(cell, ','), *end;

  end = comma ? comma : cell + strlen(cell);
  *line = comma ? comma + 1 : NULL;
  while (end > cell && isspace((unsigned char)end[-1])) --end;
  *end = '\0';
  while (isspace((unsigned char)*cell)) ++cell;
  return cell;
}

typedef struct reader {
  const char *name;
  FILE *file;
  char *line;
  size_t size;
  long row;
  int column[POINT_NUMBERS]; /* -1: none */
} reader;

static int read_header(reader *r)
{
  char *rest = r->line, *cell;
  int i, k, found = 0;

  for (k = 0; k < POINT_NUMBERS; ++k) r->column[k] = -1;
  for (i = 0; rest; ++i) {
    cell = next_cell(&rest);
    k = point_find(cell);
    if (k < 0) continue;
    if (r->column[k] >= 0)
      return message_fail(STATUS_FAILED, "%s:%ld: column \"%s\" is there twice", r->name, r->row,
                          cell);
    r->column[k] = i;
    found = 1;
  }
  if (found) return STATUS_DONE;
  return message_fail(STATUS_FAILED, "%s:%ld: no column is kappa, alpha, gamma, fz or vx", r->name,
                      r->row);
}

static int read_row(const reader *r, const int *given, double *slip)
{
  char *rest = r->line, *cell, *end;
  int i, k, found = 0, wanted = 0;

  for (k = 0; k < POINT_NUMBERS; ++k) wanted += r->column[k] >= 0;
  for (i = 0; rest; ++i) {
    cell = next_cell(&rest);
    for (k = 0; k < POINT_NUMBERS; ++k) {
      if (r->column[k] != i) continue;
      ++found;
      if (given[k]) continue;
      slip[k] = strtod(cell, &end);
      if (end == cell || *end || cell[strspn(cell, "0123456789+-.eE")])
        return message_fail(STATUS_FAILED, "%s:%ld: \"%s\" is not a number", r->name, r->row, cell);
    }
  }
  if (found == wanted) return STATUS_DONE;
  return message_fail(STATUS_FAILED, "%s:%ld: fewer cells than in the first line", r->name, r->row);
}

static int read_lines(points *p, reader *r, const double *at, const int *given)
{
  int room = 0, status = STATUS_DONE, is_header = 1;

  errno = 0;
  for (r->row = 1; status == STATUS_DONE && getline(&r->line, &r->size, r->file) >= 0; ++r->row) {
    if (r->line[strspn(r->line, " \t\r\n")] == '\0') continue;
    if (is_header) {
      status = read_header(r);
      is_header = 0;
      continue;
    }
    if (grow(p, &room)) return message_fail(STATUS_FAILED, "%s: too many points", r->name);
    memcpy(p->slip[p->number], at, sizeof *p->slip);
    status = read_row(r, given, p->slip[p->number]);
    ++p->number;
  }
  if (status != STATUS_DONE) return status;
  if (ferror(r->file))
    return message_fail(STATUS_FAILED, "%s: cannot be read: %s", r->name, strerror(errno));
  if (p->number == 0) return message_fail(STATUS_FAILED, "%s: no points", r->name);
  return STATUS_DONE;
}

int points_read(points *p, const char *name, const double at[POINT_NUMBERS],
                const int given[POINT_NUMBERS])
{
  reader r = {.name = name};
  int status;

  r.file = fopen(name, "r");
  if (!r.file)
    return message_fail(STATUS_FAILED, "%s: cannot be opened: %s", name, strerror(errno));
  status = read_lines(p, &r, at, given);
  free(r.line);
  fclose(r.file);
  return status;
}
