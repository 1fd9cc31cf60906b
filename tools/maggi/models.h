/* Where models come from: a file, the models that ship, or the generator. */
#ifndef TOOL_MODELS_H
#define TOOL_MODELS_H

#include <maggi/maggi.h>

/* Open MODEL of the command line.
 *
 * out   model   free with maggi_model_free
 *       path    the file it was read from, "" if it was generated; MODELS_PATH_MAX chars
 * returns the exit status, after a message when it is not STATUS_DONE
 */
#define MODELS_PATH_MAX 4096
int models_open(const char *spec, maggi_model **model, char path[MODELS_PATH_MAX]);

#endif
