/* Model files: read, check, load, build. */
#if !defined(_WIN32) && !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* newlocale, uselocale */
#endif

#include "load.h"

#include "load_file.h"

#include <errno.h>
#include <locale.h>
#ifdef __APPLE__
#include <xlocale.h>
#endif
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -------------------------------------------------------------------------------------- message */

maggi_status maggi_load_fail(const load_error *e, size_t line, const char *format, ...)
{
  char *c;
  size_t n;
  va_list args;

  if (!e->message || e->nmessage == 0) return MAGGI_E_MODEL;
  if (line)
    snprintf(e->message, e->nmessage, "%s:%zu: ", e->file, line);
  else
    snprintf(e->message, e->nmessage, "%s: ", e->file);
  n = strlen(e->message);
  va_start(args, format);
  vsnprintf(e->message + n, e->nmessage - n, format, args);
  va_end(args);
  for (c = e->message; *c; ++c) /* one line, whatever a file has in its names */
    if ((unsigned char)*c < ' ' || *c == 0x7f) *c = '?';
  return MAGGI_E_MODEL;
}

static maggi_status fail_memory(const load_error *e)
{
  maggi_load_fail(e, 0, "out of memory");
  return MAGGI_E_MEMORY;
}

/* -------------------------------------------------------------------------------------- loading */

/* First error that libcyaml reports, and its line. */
typedef struct cyaml_report {
  char text[160];
  size_t line;
} cyaml_report;

static void take_report(cyaml_log_t level, void *context, const char *format, va_list args)
{
  cyaml_report *report = context;
  char text[160];
  const char *line;

  if (level < CYAML_LOG_ERROR) return;
  vsnprintf(text, sizeof text, format, args);
  text[strcspn(text, "\n")] = '\0';
  line = strstr(text, "(line: "); /* of its back trace, innermost first */
  if (report->text[0] == '\0') strcpy(report->text, text);
  if (line && report->line == 0) report->line = (size_t)strtoul(line + 7, NULL, 10);
}

static cyaml_config_t config_of(cyaml_report *report)
{
  const cyaml_config_t config = {.log_fn = take_report,
                                 .log_ctx = report,
                                 .mem_fn = cyaml_mem,
                                 .log_level = CYAML_LOG_ERROR,
                                 .flags = CYAML_CFG_NO_ALIAS};

  return config;
}

maggi_status maggi_load_parse(load_source *source)
{
  const load_error *e = &source->error;
  cyaml_report report = {.text = ""};
  const cyaml_config_t config = config_of(&report);
  cyaml_data_t *file = NULL;
  cyaml_err_t error;
  maggi_status status = maggi_load_check(e, source->bytes, source->n);

  if (status) return status;
  error = cyaml_load_data((const uint8_t *)source->bytes, source->n, &config, &maggi_load_schema,
                          &file, NULL);
  if (error == CYAML_ERR_OOM || error == CYAML_ERR_LIBYAML_PARSER ||
      error == CYAML_ERR_LIBYAML_PARSER_INIT) /* load_check.c found no fault with the YAML */
    return fail_memory(e);
  if (error != CYAML_OK)
    return maggi_load_fail(e, report.line, "%s",
                           report.text[0] ? report.text : cyaml_strerror(error));
  source->file = file;
  return MAGGI_OK;
}

void maggi_load_parse_free(load_source *source)
{
  cyaml_report report = {.text = ""};
  const cyaml_config_t config = config_of(&report);

  if (source->file) cyaml_free(&config, &maggi_load_schema, source->file, 0);
  source->file = NULL;
}

static maggi_status read_model(const load_error *e, const char *bytes, size_t n, void *model)
{
  load_files files = {.number = 1};
  maggi_status status;

  files.source[0].error = *e;
  files.source[0].bytes = bytes;
  files.source[0].n = n;
  status = maggi_load_files(&files);
  if (status == MAGGI_OK) status = maggi_load_build(&files, model);
  maggi_load_files_free(&files);
  return status;
}

static maggi_status read_tyre(const load_error *e, const char *bytes, size_t n, void *def)
{
  return maggi_load_tir(e, bytes, n, def);
}

/* numbers have a point here, also in a program that has set a locale with a comma */
static maggi_status in_c_locale(const load_error *e,
                                maggi_status (*read)(const load_error *e, const char *bytes,
                                                     size_t n, void *out),
                                const char *bytes, size_t n, void *out)
{
#ifdef _WIN32
  return read(e, bytes, n, out);
#else
  locale_t c_locale = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0), old;
  maggi_status status;

  if (!c_locale) return fail_memory(e);
  old = uselocale(c_locale);
  status = read(e, bytes, n, out);
  uselocale(old);
  freelocale(c_locale);
  return status;
#endif
}

maggi_status maggi_model_load_memory(const char *name, const char *bytes, size_t n,
                                     maggi_model **model, char *message, size_t nmessage)
{
  const load_error e = {name, message, nmessage};

  *model = NULL;
  if (message && nmessage) *message = '\0';
  if (n > MAGGI_LOAD_MAX) {
    maggi_load_fail(&e, 0, "larger than %zu MB", MAGGI_LOAD_MAX >> 20);
    return MAGGI_E_FILE;
  }
  return in_c_locale(&e, read_model, bytes, n, model);
}

/* ----------------------------------------------------------------------------------------- file */

/* Read the whole file, up to one byte more than is allowed; *bytes is the caller's to free. */
static maggi_status read_all(const load_error *e, FILE *stream, char **bytes, size_t *n)
{
  size_t size = 4096;
  char *larger;

  *n = 0;
  *bytes = NULL;
  do {
    size *= 4;
    larger = realloc(*bytes, size);
    if (!larger) return fail_memory(e);
    *bytes = larger;
    *n += fread(*bytes + *n, 1, size - *n, stream);
  } while (*n == size && *n <= MAGGI_LOAD_MAX);
  if (!ferror(stream)) return MAGGI_OK;
  maggi_load_fail(e, 0, "cannot be read: %s", strerror(errno));
  return MAGGI_E_FILE;
}

maggi_status maggi_load_read(const load_error *e, char **bytes, size_t *n)
{
  FILE *stream = fopen(e->file, "rb");
  maggi_status status;

  *bytes = NULL;
  *n = 0;
  if (!stream) {
    maggi_load_fail(e, 0, "cannot be opened: %s", strerror(errno));
    return MAGGI_E_FILE;
  }
  status = read_all(e, stream, bytes, n);
  fclose(stream);
  if (status == MAGGI_OK && *n > MAGGI_LOAD_MAX) {
    maggi_load_fail(e, 0, "larger than %zu MB", MAGGI_LOAD_MAX >> 20);
    status = MAGGI_E_FILE;
  }
  if (status == MAGGI_OK) return status;
  free(*bytes);
  *bytes = NULL;
  *n = 0;
  return status;
}

maggi_status maggi_model_load(const char *path, maggi_model **model, char *message, size_t nmessage)
{
  const load_error e = {path, message, nmessage};
  char *bytes;
  size_t n;
  maggi_status status;

  *model = NULL;
  status = maggi_load_read(&e, &bytes, &n);
  if (status == MAGGI_OK)
    status = maggi_model_load_memory(path, bytes, n, model, message, nmessage);
  free(bytes);
  return status;
}

maggi_status maggi_tyre_load(const char *path, maggi_tyre_def *def, char *message, size_t nmessage)
{
  const load_error e = {path, message, nmessage};
  char *bytes;
  size_t n;
  maggi_status status;

  maggi_tyre_def_init(def);
  if (message && nmessage) *message = '\0';
  status = maggi_load_read(&e, &bytes, &n);
  if (status == MAGGI_OK) status = in_c_locale(&e, read_tyre, bytes, n, def);
  free(bytes);
  return status;
}
