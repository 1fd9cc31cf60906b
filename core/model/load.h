/* Reading a model from memory: what maggi_model_load does with the bytes of a file.
 *
 * in    name      of the file, for messages; paths in the file, of its `base` too, begin in its folder
 *       bytes     the YAML text, any bytes at all                       (n)
 * out   model     NULL on failure
 *       message   one line, `NAME:LINE: what is wrong`, "" on success     (nmessage chars, or NULL);
 *                 NAME is that of the base where the fault is there
 *
 * status          MAGGI_OK, MAGGI_E_MEMORY, MAGGI_E_FILE (over MAGGI_LOAD_MAX), MAGGI_E_MODEL
 * threads         safe; the numbers are read in the C locale whatever the program has set
 */
#ifndef MAGGI_MODEL_LOAD_H
#define MAGGI_MODEL_LOAD_H

#include "maggi/maggi.h"

#define MAGGI_LOAD_MAX ((size_t)16 << 20) /* bytes of the largest file */

maggi_status maggi_model_load_memory(const char *name, const char *bytes, size_t n,
                                     maggi_model **model, char *message, size_t nmessage);

#endif
