/* --set PATH=VALUE: parameters that differ from the model file: PATH is that of a number of the model, a
 * glob for several, or the name of a design parameter, which is set after all paths. */
#ifndef TOOL_SETTINGS_H
#define TOOL_SETTINGS_H

#include <maggi/maggi.h>

typedef struct setting {
  const char *path; /* or name; of argv */
  const char *text; /* of argv */
  double value;
} setting;

typedef struct settings {
  setting *entry;
  int number;
} settings;

/* Room for as many settings as there are arguments: 0, or -1 after a message. */
int settings_init(settings *s, int argc);
void settings_free(settings *s);

/* Add `PATH=VALUE`, whose = becomes the end of PATH: 0, or -1 after a message. */
int settings_add(settings *s, char *text);

/* Set the parameters of d; exit status, after a message when it is not STATUS_DONE. */
int settings_apply(const settings *s, const maggi_model *m, maggi_data *d);

#endif
