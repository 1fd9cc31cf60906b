/* maggi report: tables of runs as one page. */
#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700 /* realpath */
#endif
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "interrupt.h"
#include "message.h"
#include "options.h"
#include "page.h"
#include "script.h"

enum { OUT, TITLE, WIDTH };

static const option_def page_options[] = {[OUT] = {"--out", OPTION_VALUE, "a file name"},
                                          [TITLE] = {"--title", OPTION_VALUE, "a text"},
                                          [WIDTH] = {"--width", OPTION_VALUE, "a length in meters"},
                                          {NULL, OPTION_FLAG, NULL}};

int page_check(const char *out)
{
  return script_check(&script_report, out);
}

int page_draw(int n, const char *const *table, const char *out, const char *title,
              const char *width)
{
  const char **argument = calloc((size_t)n + 10, sizeof *argument);
  char *self = realpath("/proc/self/exe", NULL);
  int i, k = 0, status;

  if (!argument) {
    free(self);
    return message_fail(STATUS_FAILED, "out of memory");
  }
  if (out) argument[k++] = "--out";
  if (out) argument[k++] = out;
  if (title) argument[k++] = "--title";
  if (title) argument[k++] = title;
  if (width) argument[k++] = "--width";
  if (width) argument[k++] = width;
  if (self) argument[k++] = "--maggi";
  if (self) argument[k++] = self;
  argument[k++] = "--";
  for (i = 0; i < n; ++i) argument[k++] = table[i];
  status = script_run(&script_report, k, argument);
  free(argument);
  free(self);
  return status;
}

int command_report(int argc, char **argv)
{
  const char **table = calloc((size_t)argc + 1, sizeof *table);
  const char *out = NULL, *title = NULL, *width = NULL;
  double meters;
  options o;
  int id, n = 0, status = STATUS_DONE;

  if (!table) return message_fail(STATUS_FAILED, "out of memory");
  options_init(&o, page_options, argc, argv);
  while (status == STATUS_DONE && (id = options_next(&o)) != OPTIONS_END) {
    if (id == OPTIONS_HELP) {
      fputs(help_text("report"), stdout);
      free(table);
      return STATUS_DONE;
    }
    if (id == OUT)
      status = options_file("--out", o.value, &out) ? STATUS_USAGE : STATUS_DONE;
    else if (id == TITLE)
      title = o.value;
    else if (id == WIDTH) {
      width = o.value;
      status = options_positive("--width", width, &meters) ? STATUS_USAGE : STATUS_DONE;
    } else if (id == OPTIONS_ARGUMENT && o.value[0] != '\0')
      table[n++] = o.value;
    else if (id == OPTIONS_ARGUMENT)
      status = message_fail(STATUS_USAGE, "report: RUN.csv is empty");
    else
      status = STATUS_USAGE;
  }
  if (status == STATUS_DONE && n == 0)
    status = message_fail(STATUS_USAGE, "report: no RUN.csv given");
  interrupt_catch();
  if (status == STATUS_DONE) status = page_draw(n, table, out, title, width);
  free(table);
  return status;
}
