/* Progress on stderr: from the first half second on, five times a second at most. */
#include "progress.h"

#include <stdio.h>
#include <unistd.h>

#include "stopwatch.h"

#define PROGRESS_QUIET    0.5 /* [s] */
#define PROGRESS_INTERVAL 0.2 /* [s] */

void progress_begin(progress *p, int show)
{
  p->on = show && isatty(STDERR_FILENO);
  p->begin = stopwatch_now();
  p->next = p->begin + PROGRESS_QUIET;
  p->width = 0;
}

/* "12 s", "3 min 20 s", "2 h 05 min" */
static void format_duration(double seconds, char *text, size_t n)
{
  if (seconds < 100.0)
    snprintf(text, n, "%.0f s", seconds);
  else if (seconds < 6000.0)
    snprintf(text, n, "%d min %02d s", (int)seconds / 60, (int)seconds % 60);
  else if (seconds < 3.6e8)
    snprintf(text, n, "%d h %02d min", (int)(seconds / 3600.0), (int)(seconds / 60.0) % 60);
  else
    snprintf(text, n, "years");
}

/* The line, with the time that is left when `part` has been done. */
static void show(progress *p, double now, double part, const char *what)
{
  char line[200], rest[40];
  int length;

  p->next = now + PROGRESS_INTERVAL;
  if (part > 0.0)
    format_duration((now - p->begin) * (1.0 - part) / part, rest, sizeof rest);
  else
    snprintf(rest, sizeof rest, "?");
  length = snprintf(line, sizeof line, "%3d %%  %s%s left", (int)(100.0 * part), what, rest);
  fprintf(stderr, "\r%-*s", p->width, line); /* cover what was longer */
  fflush(stderr);
  if (length > p->width) p->width = length;
}

void progress_update(progress *p, double now, double t, double time)
{
  char what[100];

  if (!p->on || now < p->next) return;
  snprintf(what, sizeof what, "t = %.4g of %.4g s  ", t, time);
  show(p, now, t / time, what);
}

void progress_part(progress *p, double now, double part)
{
  if (p->on && now >= p->next) show(p, now, part, "");
}

void progress_end(progress *p)
{
  if (p->width > 0) fprintf(stderr, "\r%*s\r", p->width, "");
  p->width = 0;
}
