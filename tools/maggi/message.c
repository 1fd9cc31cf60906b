/* Messages of one line. */
#include "message.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define MESSAGE_SIZE 4096

/* One line, whatever the names and paths in it contain. */
static void print_line(const char *prefix, const char *format, va_list arguments)
{
  char text[MESSAGE_SIZE];
  char *c;
  int length;

  length = vsnprintf(text, sizeof text, format, arguments);
  if (length < 0) text[0] = '\0';
  if (length >= (int)sizeof text) memcpy(text + sizeof text - 4, "...", 4);
  for (c = text; *c; ++c)
    if ((unsigned char)*c < ' ' || *c == 0x7f) *c = '?';
  fprintf(stderr, "maggi: %s%s\n", prefix, text);
}

int message_fail(int status, const char *format, ...)
{
  va_list arguments;

  va_start(arguments, format);
  print_line("", format, arguments);
  va_end(arguments);
  return status;
}

void message_note(const char *format, ...)
{
  va_list arguments;

  va_start(arguments, format);
  print_line("note: ", format, arguments);
  va_end(arguments);
}

int message_finish_stdout(int status)
{
  int before, after;

  before = ferror(stdout);
  errno = 0;
  after = fflush(stdout);
  if (!before && !after) return status;
  if (status != STATUS_DONE) return status; /* the first failure has had its line */
  return message_fail(STATUS_FAILED, "standard output: %s",
                      after && errno ? strerror(errno) : "cannot be written");
}
