/* JSON as in RFC 8259. */
#include "json.h"

#include <math.h>

void json_init(json *j, FILE *out)
{
  j->out = out;
  j->depth = 0;
  j->empty = 1;
}

/* Length of the UTF-8 sequence at s, 0 if it is not a valid one. */
static int utf8_length(const unsigned char *s)
{
  int n, i;

  if (s[0] < 0x80) return 1;
  n = s[0] >= 0xc2 && s[0] <= 0xdf ? 2 : (s[0] & 0xf0) == 0xe0 ? 3 : 0;
  if (s[0] >= 0xf0 && s[0] <= 0xf4) n = 4;
  for (i = 1; i < n; ++i)
    if ((s[i] & 0xc0) != 0x80) return 0;
  if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xf0 && s[1] < 0x90)) /* longer than needed */
    return 0;
  if ((s[0] == 0xed && s[1] > 0x9f) || (s[0] == 0xf4 && s[1] > 0x8f)) /* surrogate; too large */
    return 0;
  return n;
}

static void write_string(FILE *out, const char *text)
{
  const unsigned char *s = (const unsigned char *)text;
  int n;

  putc('"', out);
  while (*s) {
    n = utf8_length(s);
    if (n == 0)
      fputs("\\ufffd", out); /* replacement character */
    else if (*s == '"' || *s == '\\')
      fprintf(out, "\\%c", *s);
    else if (*s < ' ' || *s == 0x7f)
      fprintf(out, "\\u%04x", (unsigned)*s);
    else
      fwrite(s, 1, (size_t)n, out);
    s += n > 0 ? n : 1;
  }
  putc('"', out);
}

static void new_line(json *j)
{
  fprintf(j->out, "\n%*s", 2 * j->depth, "");
}

/* Comma, indentation and key in front of a value. */
static void begin_value(json *j, const char *key)
{
  if (!j->empty) putc(',', j->out);
  if (j->depth > 0) new_line(j);
  if (key) {
    write_string(j->out, key);
    fputs(": ", j->out);
  }
  j->empty = 0;
}

static void open_group(json *j, const char *key, char bracket)
{
  begin_value(j, key);
  putc(bracket, j->out);
  ++j->depth;
  j->empty = 1;
}

static void close_group(json *j, char bracket)
{
  --j->depth;
  if (!j->empty) new_line(j);
  putc(bracket, j->out);
  if (j->depth == 0) putc('\n', j->out);
  j->empty = 0;
}

void json_open_object(json *j, const char *key)
{
  open_group(j, key, '{');
}

void json_close_object(json *j)
{
  close_group(j, '}');
}

void json_open_array(json *j, const char *key)
{
  open_group(j, key, '[');
}

void json_close_array(json *j)
{
  close_group(j, ']');
}

void json_string(json *j, const char *key, const char *text)
{
  if (!text) {
    json_null(j, key);
    return;
  }
  begin_value(j, key);
  write_string(j->out, text);
}

void json_number(json *j, const char *key, double x)
{
  if (!isfinite(x)) {
    json_null(j, key);
    return;
  }
  begin_value(j, key);
  fprintf(j->out, "%.17g", x);
}

void json_integer(json *j, const char *key, long n)
{
  begin_value(j, key);
  fprintf(j->out, "%ld", n);
}

void json_boolean(json *j, const char *key, int yes)
{
  begin_value(j, key);
  fputs(yes ? "true" : "false", j->out);
}

void json_null(json *j, const char *key)
{
  begin_value(j, key);
  fputs("null", j->out);
}
