/* Recorded signals: columns of a CSV file (RFC 4180), which a header names.
 *
 * A field in quotes ends on its line.  Blanks around a field without quotes do not count, nor do empty
 * lines.
 */
#include "load_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "load.h"

enum { FIELD_MAX_CHARS = 200 };

typedef struct reader {
  const load_error *error;
  const char *p, *end; /* what is left of the file */
  size_t line;
  char field[FIELD_MAX_CHARS + 1];
  int is_last; /* of its row */
} reader;

static maggi_status add_char(reader *r, size_t *n, char c)
{
  if (*n == FIELD_MAX_CHARS)
    return maggi_load_fail(r->error, r->line, "a field has more than %d characters",
                           FIELD_MAX_CHARS);
  if (c == '\0') return maggi_load_fail(r->error, r->line, "a NUL character");
  r->field[(*n)++] = c;
  return MAGGI_OK;
}

static int is_blank(char c)
{
  return c == ' ' || c == '\t';
}

static int is_at(const reader *r, char c)
{
  return r->p < r->end && *r->p == c;
}

/* to the separator or the end of the line */
static maggi_status read_plain(reader *r, size_t *n)
{
  maggi_status status = MAGGI_OK;

  for (; r->p < r->end && !strchr(",\r\n", *r->p) && status == MAGGI_OK; ++r->p)
    status = add_char(r, n, *r->p);
  if (status == MAGGI_OK && is_at(r, '\0')) status = add_char(r, n, '\0');
  while (*n > 0 && is_blank(r->field[*n - 1])) --*n;
  return status;
}

/* to the closing quote; two of them stand for one */
static maggi_status read_quoted(reader *r, size_t *n)
{
  maggi_status status = MAGGI_OK;

  for (++r->p; status == MAGGI_OK; ++r->p) {
    if (r->p == r->end || *r->p == '\n')
      return maggi_load_fail(r->error, r->line, "a quote is not closed");
    if (*r->p == '"') {
      ++r->p;
      if (!is_at(r, '"')) return MAGGI_OK;
    }
    status = add_char(r, n, *r->p);
  }
  return status;
}

/* Next field of the row, and the separator after it. */
static maggi_status read_field(reader *r)
{
  maggi_status status;
  size_t n = 0;

  while (r->p < r->end && is_blank(*r->p)) ++r->p;
  status = is_at(r, '"') ? read_quoted(r, &n) : read_plain(r, &n);
  if (status) return status;
  r->field[n] = '\0';
  while (r->p < r->end && is_blank(*r->p)) ++r->p;
  r->is_last = !is_at(r, ',');
  if (!r->is_last) {
    ++r->p;
    return MAGGI_OK;
  }
  if (is_at(r, '\r')) ++r->p;
  if (r->p < r->end && *r->p++ != '\n')
    return maggi_load_fail(r->error, r->line, "a text after a quote");
  return MAGGI_OK;
}

/* Next row that is not empty: whether there is one. */
static int find_row(reader *r)
{
  const char *p;

  for (++r->line; r->p < r->end; ++r->line) {
    for (p = r->p; p < r->end && (is_blank(*p) || *p == '\r'); ++p)
      ;
    if (p < r->end && *p != '\n') return 1;
    r->p = p < r->end ? p + 1 : p;
  }
  return 0;
}

/* Positions of the columns `t` and `column`, and the number of all. */
static maggi_status read_header(reader *r, const char *column, int at[2], int *n)
{
  maggi_status status;

  at[0] = at[1] = -1;
  if (!find_row(r)) return maggi_load_fail(r->error, 1, "the record is empty");
  for (*n = 0, r->is_last = 0; !r->is_last; ++*n) {
    status = read_field(r);
    if (status) return status;
    if (at[0] < 0 && strcmp(r->field, "t") == 0) at[0] = *n;
    if (at[1] < 0 && strcmp(r->field, column) == 0) at[1] = *n;
  }
  if (at[0] < 0) return maggi_load_fail(r->error, r->line, "no column \"t\"");
  if (at[1] < 0) return maggi_load_fail(r->error, r->line, "no column \"%s\"", column);
  return MAGGI_OK;
}

static maggi_status read_row(reader *r, const int at[2], int n, double row[2])
{
  maggi_status status;
  int i, k;

  for (i = 0, r->is_last = 0; !r->is_last; ++i) {
    status = read_field(r);
    if (status) return status;
    for (k = 0; k < 2; ++k) {
      if (i != at[k]) continue;
      if (!maggi_load_is_decimal(r->field) || !isfinite(strtod(r->field, NULL)))
        return maggi_load_fail(r->error, r->line, "\"%.40s\" is not a number", r->field);
      row[k] = strtod(r->field, NULL);
    }
  }
  if (i != n) return maggi_load_fail(r->error, r->line, "%d fields instead of %d", i, n);
  return MAGGI_OK;
}

static maggi_status fail_memory(const load_error *e)
{
  maggi_load_fail(e, 0, "out of memory");
  return MAGGI_E_MEMORY;
}

static maggi_status add_row(const reader *r, load_record *record, const double row[2])
{
  double *grown[2], before = record->n > 0 ? record->times[record->n - 1] : -1.0;
  int cap;

  if (row[0] < 0.0) return maggi_load_fail(r->error, r->line, "t is before 0 (%g)", row[0]);
  if (row[0] <= before)
    return maggi_load_fail(r->error, r->line, "t does not increase (%g after %g)", row[0], before);
  if (record->n == record->cap) {
    cap = record->cap ? 2 * record->cap : 256;
    grown[0] = realloc(record->times, (size_t)cap * sizeof(double));
    if (grown[0]) record->times = grown[0];
    grown[1] = realloc(record->values, (size_t)cap * sizeof(double));
    if (grown[1]) record->values = grown[1];
    if (!grown[0] || !grown[1]) return fail_memory(r->error);
    record->cap = cap;
  }
  record->times[record->n] = row[0];
  record->values[record->n++] = row[1];
  return MAGGI_OK;
}

maggi_status maggi_load_record(const load_error *e, const char *column, load_record *record)
{
  reader r = {.error = e};
  double row[2] = {0.0, 0.0};
  int at[2], n = 0;
  size_t size;
  char *bytes;
  maggi_status status;

  memset(record, 0, sizeof *record);
  status = maggi_load_read(e, &bytes, &size);
  r.p = bytes;
  r.end = bytes ? bytes + size : NULL;
  if (size >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0) r.p += 3; /* mark of UTF-8 */
  if (status == MAGGI_OK) status = read_header(&r, column, at, &n);
  while (status == MAGGI_OK && find_row(&r)) {
    status = read_row(&r, at, n, row);
    if (status == MAGGI_OK) status = add_row(&r, record, row);
  }
  if (status == MAGGI_OK && record->n == 0) status = maggi_load_fail(e, r.line, "no rows");
  free(bytes);
  return status;
}

void maggi_load_record_free(load_record *record)
{
  free(record->times);
  free(record->values);
}
