/* Directories of the source tree and of an installation. */
#include "places.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef MAGGI_SOURCE_DIR
#define MAGGI_SOURCE_DIR ""
#endif
#ifndef MAGGI_INSTALL_DIR
#define MAGGI_INSTALL_DIR ""
#endif

/* Directory of this program, "" where the system does not say where that is. */
static void find_program(char path[PLACES_PATH_MAX])
{
  ssize_t n = readlink("/proc/self/exe", path, PLACES_PATH_MAX - 1);
  char *slash;

  path[n > 0 ? n : 0] = '\0';
  slash = strrchr(path, '/');
  if (slash) *slash = '\0';
}

static const char *join(char path[PLACES_PATH_MAX], const char *root, const char *middle,
                        const char *kind)
{
  int n = snprintf(path, PLACES_PATH_MAX, "%s%s/%s", root, middle, kind);

  if (root[0] == '\0' || n >= PLACES_PATH_MAX) path[0] = '\0';
  return path;
}

const char *places_directory(const char *kind, int i, char path[PLACES_PATH_MAX])
{
  char program[PLACES_PATH_MAX];
  const char *named;

  if (i == 0) {
    named = getenv(strcmp(kind, "models") == 0 ? "MAGGI_MODELS" : "MAGGI_SCRIPTS");
    return named ? named : "";
  }
  if (i == 1) return join(path, MAGGI_SOURCE_DIR, "", kind);
  if (i == 3) return join(path, MAGGI_INSTALL_DIR, "", kind);
  find_program(program);
  return join(path, program, "/../share/maggi", kind);
}
