/* CSV as in RFC 4180; names of maggi need no quotes. */
#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700 /* realpath */
#endif

#include "table.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "message.h"

static void forget(table *t)
{
  free(t->path);
  free(t->part);
  t->file = NULL;
  t->path = NULL;
  t->part = NULL;
}

static int fail_errno(const table *t, int error)
{
  return message_fail(STATUS_FAILED, "%s: %s", t->name, strerror(error));
}

/* part beside path; the rights of a file that is replaced stay. */
static int open_part(table *t, int exists, mode_t mode)
{
  size_t n = strlen(t->path) + 32;
  int fd, error;

  t->part = malloc(n);
  if (!t->part) return fail_errno(t, ENOMEM);
  snprintf(t->part, n, "%s.part.%ld", t->path, (long)getpid());
  unlink(t->part); /* left by a process that had our number long ago */
  fd = open(t->part, O_WRONLY | O_CREAT | O_EXCL, 0666);
  if (fd < 0) {
    error = errno;
    free(t->part);
    t->part = NULL;
    return fail_errno(t, error);
  }
  if (exists) (void)fchmod(fd, mode & 0777);
  t->file = fdopen(fd, "w");
  if (t->file) return STATUS_DONE;
  error = errno;
  close(fd);
  unlink(t->part);
  return fail_errno(t, error);
}

static int open_file(table *t)
{
  struct stat old;
  int exists;

  exists = stat(t->name, &old) == 0;
  if (exists && S_ISDIR(old.st_mode))
    return message_fail(STATUS_FAILED, "%s: is a directory", t->name);
  if (exists && access(t->name, W_OK) != 0) return fail_errno(t, errno);
  t->path = exists ? realpath(t->name, NULL) : strdup(t->name); /* a link stays a link */
  if (!t->path) return fail_errno(t, errno);
  if (!exists || S_ISREG(old.st_mode)) return open_part(t, exists, old.st_mode);
  t->file = fopen(t->path, "w");
  return t->file ? STATUS_DONE : fail_errno(t, errno);
}

int table_open(table *t, const char *name)
{
  int status;

  memset(t, 0, sizeof *t);
  t->name = strcmp(name, "-") == 0 ? "standard output" : name;
  if (strcmp(name, "-") == 0) {
    t->file = stdout;
    return STATUS_DONE;
  }
  status = open_file(t);
  if (status != STATUS_DONE) forget(t);
  return status;
}

int table_is_same_file(const char *a, const char *b)
{
  struct stat sa, sb;

  return stat(a, &sa) == 0 && stat(b, &sb) == 0 && sa.st_dev == sb.st_dev && sa.st_ino == sb.st_ino;
}

static void separate(table *t)
{
  if (t->column++ > 0) putc(',', t->file);
}

void table_title(table *t, const char *name, const char *suffix)
{
  separate(t);
  fputs(name, t->file);
  if (suffix) fputs(suffix, t->file);
}

void table_number(table *t, double x)
{
  separate(t);
  if (isnan(x))
    fputs("nan", t->file); /* without the sign that printf may add */
  else
    fprintf(t->file, "%.17g", x);
}

void table_text(table *t, const char *text)
{
  int quoted = strpbrk(text, ",\"\r\n") != NULL;

  separate(t);
  if (quoted) putc('"', t->file);
  for (; *text; ++text) {
    if (*text == '"') putc('"', t->file);
    putc(*text, t->file);
  }
  if (quoted) putc('"', t->file);
}

void table_end_header(table *t)
{
  putc('\n', t->file);
  t->column = 0;
  if (t->error == 0 && ferror(t->file)) t->error = errno ? errno : EIO;
}

void table_end_row(table *t)
{
  table_end_header(t);
  ++t->rows;
}

int table_has_failed(const table *t)
{
  return t->error != 0;
}

int table_close(table *t)
{
  int error = t->error;

  if (!t->file) return STATUS_DONE;
  if (fflush(t->file) != 0 && error == 0) error = errno;
  if (t->file != stdout && fclose(t->file) != 0 && error == 0) error = errno;
  if (error == 0 && t->part && rename(t->part, t->path) != 0) error = errno;
  if (error != 0 && t->part) unlink(t->part);
  forget(t);
  return error == 0 ? STATUS_DONE : fail_errno(t, error);
}

void table_discard(table *t)
{
  if (!t->file) return;
  if (t->file != stdout) fclose(t->file);
  if (t->part) unlink(t->part);
  forget(t);
}
