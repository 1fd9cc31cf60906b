/* Where the files are that come with the command: models and scripts. */
#ifndef TOOL_PLACES_H
#define TOOL_PLACES_H

#define PLACES          4 /* directories, in the order in which they are looked through */
#define PLACES_PATH_MAX 4096

/* Directory i for `kind`, "models" or "scripts"; "" if there is none:
 *
 *   0   $MAGGI_MODELS, $MAGGI_SCRIPTS
 *   1   of the source tree
 *   2   installed beside the command (an installation may be moved)
 *   3   installed where it was configured
 *
 * path is where it may be written. */
const char *places_directory(const char *kind, int i, char path[PLACES_PATH_MAX]);

#endif
