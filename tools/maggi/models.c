/* Which models ship, where they are found, and the command that lists them.
 *
 * A model NAME is DIR/NAME.yaml or DIR/NAME/NAME.yaml, in the first DIR that has it (places.h); a model
 * FOLDER/NAME is DIR/FOLDER/NAME.yaml.
 */
#include "models.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "commands.h"
#include "json.h"
#include "message.h"
#include "names.h"
#include "nearest.h"
#include "options.h"
#include "places.h"

#define GENERATED   "multiple-four-bar"
#define MESSAGE_MAX 1024

static int is_file(const char *path)
{
  struct stat s;

  return stat(path, &s) == 0 && S_ISREG(s.st_mode);
}

static int ends_with(const char *text, const char *end)
{
  size_t n = strlen(text), nend = strlen(end);

  return n > nend && strcmp(text + n - nend, end) == 0;
}

/* File of the shipped model `name`: 1, or 0 if there is none. */
static int find_shipped(const char *name, char path[MODELS_PATH_MAX])
{
  char beside[PLACES_PATH_MAX];
  const char *dir;
  int i, n;

  for (i = 0; i < PLACES; ++i) {
    dir = places_directory("models", i, beside);
    if (dir[0] == '\0') continue;
    n = snprintf(path, MODELS_PATH_MAX, "%s/%s.yaml", dir, name);
    if (n < MODELS_PATH_MAX && is_file(path)) return 1;
    if (strchr(name, '/')) continue;
    n = snprintf(path, MODELS_PATH_MAX, "%s/%s/%s.yaml", dir, name, name);
    if (n < MODELS_PATH_MAX && is_file(path)) return 1;
  }
  path[0] = '\0';
  return 0;
}

/* ------------------------------------------------------------------------------ the list */

static int is_folder(const char *path)
{
  struct stat s;

  return stat(path, &s) == 0 && S_ISDIR(s.st_mode);
}

/* Add DIR/FOLDER/NAME.yaml as FOLDER/NAME or, when the names are the same, as NAME; folder NULL: DIR/NAME.yaml
 * as NAME; 0, or -1 without memory. */
static int add_model(names *list, const char *dir, const char *folder, const char *file)
{
  char path[MODELS_PATH_MAX], name[MODELS_PATH_MAX];
  size_t n = strlen(file) - strlen(".yaml");
  int length, is_short = !folder || (strlen(folder) == n && strncmp(folder, file, n) == 0);

  length =
      snprintf(path, sizeof path, "%s%s%s/%s", dir, folder ? "/" : "", folder ? folder : "", file);
  if (length >= (int)sizeof path || !is_file(path)) return 0;
  snprintf(name, sizeof name, "%s%s%.*s", is_short ? "" : folder, is_short ? "" : "/", (int)n,
           file);
  return names_has(list, name, strlen(name)) ? 0 : names_add(list, name, strlen(name));
}

/* Add the models of a directory and of the folders in it (folder NULL): 0, or -1 without memory. */
static int scan(names *list, const char *dir, const char *folder)
{
  char path[MODELS_PATH_MAX];
  const struct dirent *entry;
  DIR *d;
  int failed = 0;

  if (snprintf(path, sizeof path, "%s%s%s", dir, folder ? "/" : "", folder ? folder : "") >=
      (int)sizeof path)
    return 0;
  d = opendir(path);
  if (!d) return 0;
  while (!failed && (entry = readdir(d)) != NULL) {
    if (entry->d_name[0] == '.') continue;
    if (ends_with(entry->d_name, ".yaml"))
      failed = add_model(list, dir, folder, entry->d_name);
    else if (!folder &&
             snprintf(path, sizeof path, "%s/%s", dir, entry->d_name) < (int)sizeof path &&
             is_folder(path))
      failed = scan(list, dir, entry->d_name);
  }
  closedir(d);
  return failed;
}

static int compare_names(const void *a, const void *b)
{
  return strcmp(*(char *const *)a, *(char *const *)b);
}

/* Names of all shipped models in alphabetical order: exit status. */
static int list_shipped(names *list)
{
  char beside[PLACES_PATH_MAX];
  const char *own = places_directory("models", 0, beside), *dir;
  struct stat s;
  int i;

  memset(list, 0, sizeof *list);
  if (own[0] && stat(own, &s) != 0)
    return message_fail(STATUS_FAILED, "MAGGI_MODELS: %s: %s", own, strerror(errno));
  if (own[0] && !S_ISDIR(s.st_mode))
    return message_fail(STATUS_FAILED, "MAGGI_MODELS: %s: %s", own, strerror(ENOTDIR));
  for (i = 0; i < PLACES; ++i) {
    dir = places_directory("models", i, beside);
    if (dir[0] && scan(list, dir, NULL)) return message_fail(STATUS_FAILED, "out of memory");
  }
  if (list->number > 0) qsort(list->name, (size_t)list->number, sizeof *list->name, compare_names);
  return STATUS_DONE;
}

/* ------------------------------------------------------------------------------ opening */

static int unknown_model(const char *spec)
{
  names list;
  nearest n;
  int i, status;

  if (strcmp(spec, GENERATED) == 0)
    return message_fail(STATUS_FAILED, "%s: give its size, as in " GENERATED ":7x15", spec);
  status = list_shipped(&list);
  if (status == STATUS_DONE) {
    nearest_init(&n, spec);
    for (i = 0; i < list.number; ++i) nearest_offer(&n, list.name[i]);
    status = message_fail(STATUS_FAILED, "no model \"%s\", neither a file nor a shipped one%s",
                          spec, nearest_hint(&n));
  }
  names_free(&list);
  return status;
}

/* multiple-four-bar:NYxNZ, size being "NYxNZ" */
static int open_generated(const char *spec, const char *size, maggi_model **model)
{
  char number[32];
  const char *x = strchr(size, 'x');
  maggi_status status;
  int ny, nz;

  if (!x || (size_t)(x - size) >= sizeof number)
    return message_fail(STATUS_USAGE, "%s: the size is not NYxNZ, as in 7x15", spec);
  snprintf(number, sizeof number, "%.*s", (int)(x - size), size);
  if (options_size(number, &ny) || options_size(x + 1, &nz))
    return message_fail(STATUS_USAGE, "%s: the size is not NYxNZ, two numbers from 1 on", spec);
  status = maggi_model_multiple_four_bar(ny, nz, model);
  if (status == MAGGI_OK) return STATUS_DONE;
  return message_fail(status == MAGGI_E_VALUE ? STATUS_USAGE : STATUS_FAILED, "%s: %s", spec,
                      maggi_status_text(status));
}

/* Load with one line of text on failure. */
static maggi_status load(const char *path, maggi_model **model, char text[MESSAGE_MAX])
{
  maggi_status status;

  text[0] = '\0';
  status = maggi_model_load(path, model, text, MESSAGE_MAX);
  if (status != MAGGI_OK && text[0] == '\0')
    snprintf(text, MESSAGE_MAX, "%.900s: %s", path, maggi_status_text(status));
  return status;
}

static int open_file(const char *path, maggi_model **model)
{
  char text[MESSAGE_MAX];

  if (load(path, model, text) == MAGGI_OK) return STATUS_DONE;
  return message_fail(STATUS_FAILED, "%s", text);
}

/* ./x, ../x, /x, x/y/z, x.yaml; but x/y may be a model in a folder unless there is such a file */
static int is_path(const char *spec)
{
  const char *slash = strchr(spec, '/');

  if (ends_with(spec, ".yaml") || ends_with(spec, ".yml")) return 1;
  return slash && (*spec == '.' || slash == spec || strchr(slash + 1, '/') || is_file(spec));
}

int models_open(const char *spec, maggi_model **model, char path[MODELS_PATH_MAX])
{
  static const char prefix[] = GENERATED ":";

  *model = NULL;
  path[0] = '\0';
  if (strncmp(spec, prefix, sizeof prefix - 1) == 0)
    return open_generated(spec, spec + sizeof prefix - 1, model);
  if (strlen(spec) >= MODELS_PATH_MAX)
    return message_fail(STATUS_FAILED, "%s: %s", spec, strerror(ENAMETOOLONG));
  if (!is_path(spec) && !find_shipped(spec, path) && !is_file(spec)) return unknown_model(spec);
  if (path[0] == '\0') strcpy(path, spec);
  return open_file(path, model);
}

/* ------------------------------------------------------------------------------ maggi models */

/* Length of the first sentence: up to a full stop that a capital or the end follows, not that of
 * an initial ("A. Callejo"). */
static size_t first_sentence(const char *text)
{
  size_t i, next;

  for (i = 0; text[i]; ++i) {
    if (text[i] != '.' || (text[i + 1] && !isspace((unsigned char)text[i + 1]))) continue;
    next = i + 1 + strspn(text + i + 1, " \t\r\n");
    if (text[next] && !isupper((unsigned char)text[next])) continue;
    if (i == 0 ||
        (isupper((unsigned char)text[i - 1]) && (i == 1 || !isalnum((unsigned char)text[i - 2]))))
      continue;
    return i + 1;
  }
  return i;
}

/* First sentence of the source on one line; "" if there is none. */
static void describe(const maggi_model *m, char *text, size_t n)
{
  maggi_model_info info;
  size_t i, length, kept = 0;
  char c;

  maggi_model_get_info(m, &info);
  length = first_sentence(info.source);
  for (i = strspn(info.source, " \t\r\n"); i < length && kept + 1 < n; ++i) {
    c = isspace((unsigned char)info.source[i]) ? ' ' : info.source[i];
    if (c != ' ' || (kept > 0 && text[kept - 1] != ' ')) text[kept++] = c;
  }
  while (kept > 0 && text[kept - 1] == ' ') --kept;
  text[kept] = '\0';
}

static void print_model(json *j, const char *name, const char *path, const char *description)
{
  if (!j) {
    printf("%-26s  %s\n", name, description);
    return;
  }
  json_open_object(j, NULL);
  json_string(j, "name", name);
  json_string(j, "description", description);
  json_string(j, "path", path);
  json_close_object(j);
}

/* All models are listed; the first that cannot be read is the failure. */
static int print_models(json *j)
{
  char path[MODELS_PATH_MAX], text[MESSAGE_MAX], failure[MESSAGE_MAX];
  maggi_model *m;
  names list;
  int i, status;

  failure[0] = '\0';
  status = list_shipped(&list);
  for (i = 0; status == STATUS_DONE && i < list.number; ++i) {
    if (!find_shipped(list.name[i], path)) continue;
    if (load(path, &m, text) == MAGGI_OK) {
      describe(m, text, sizeof text);
      maggi_model_free(m);
      print_model(j, list.name[i], path, text);
    } else {
      print_model(j, list.name[i], path, "(cannot be read)");
      if (failure[0] == '\0') memcpy(failure, text, sizeof failure);
    }
  }
  names_free(&list);
  if (status != STATUS_DONE) return status;
  print_model(j, GENERATED ":NYxNZ", NULL,
              "NY four-bar linkages side by side in each of NZ rows, e.g. " GENERATED ":7x15.");
  return failure[0] ? message_fail(STATUS_FAILED, "%s", failure) : STATUS_DONE;
}

int command_models(int argc, char **argv)
{
  static const option_def defs[] = {{"--json", OPTION_FLAG, NULL}, {NULL, OPTION_FLAG, NULL}};
  options o;
  json j;
  int id, as_json = 0, status;

  options_init(&o, defs, argc, argv);
  while ((id = options_next(&o)) != OPTIONS_END) {
    if (id == OPTIONS_HELP) {
      fputs(help_text("models"), stdout);
      return STATUS_DONE;
    }
    if (id == OPTIONS_WRONG) return STATUS_USAGE;
    if (id == OPTIONS_ARGUMENT)
      return message_fail(STATUS_USAGE, "models: unexpected argument \"%s\"", o.value);
    as_json = 1;
  }
  if (!as_json) return print_models(NULL);
  json_init(&j, stdout);
  json_open_object(&j, NULL);
  json_open_array(&j, "models");
  status = print_models(&j);
  json_close_array(&j);
  json_close_object(&j);
  return status;
}
