/* From the loaded file to the builder: what load_build.c, load_body.c and load_element.c share. */
#ifndef MAGGI_MODEL_LOAD_BUILD_H
#define MAGGI_MODEL_LOAD_BUILD_H

#include "load_file.h"

/* The builder, and the entry at work: list "bodies", number 3, name "crank". */
typedef struct load_build {
  const load_files *files;
  const load_error *error; /* of the file that has the entry */
  const char *bytes;       /* of that file (n), for maggi_load_line */
  size_t n;
  maggi_builder *builder;
  const char *list;
  unsigned number;
  const char *name;
} load_build;

/* The words of an enumeration: maggi_joint_type_name and maggi_joint_type_find, .. */
typedef struct load_words {
  const char *(*word)(int i);
  int (*find)(const char *word);
} load_words;

/* Whether a key of an entry is given. */
typedef struct load_key {
  const char *key;
  int given;
} load_key;

/* `FILE:LINE: bodies.crank.joint: text`, rest ".joint"; the line is that of bodies[3].joint. */
maggi_status maggi_load_fail_at(const load_build *b, const char *rest, const char *format, ...);

/* Message and status of a call of the builder for the entry at work. */
maggi_status maggi_load_added(const load_build *b, const char *rest, maggi_status status);

/* Number of a word, which stands at `rest`; the message lists the words. */
maggi_status maggi_load_word(const load_build *b, const char *rest, const char *word,
                             const load_words *words, int *found);

/* Keys that a type takes: for each key up to one of NULL, in order, a letter of rule: r required,
 * o optional, - or none left: not allowed. */
maggi_status maggi_load_keys(const load_build *b, const char *rest, const char *type,
                             const char *rule, const load_key *keys);

/* Copy a vector; from may be NULL, then `to` stays. */
void maggi_load_copy3(double to[3], const double *from);

/* A path in the model file, which begins where the file is; NULL without memory, to free. */
char *maggi_load_path(const load_build *b, const char *file);

/* Add an entry of the file. */
maggi_status maggi_load_set(const load_build *b, const load_set *set);
maggi_status maggi_load_body(const load_build *b, const load_body *body);
maggi_status maggi_load_loop(const load_build *b, const load_loop *loop);
maggi_status maggi_load_rod(const load_build *b, const load_rod *rod);
maggi_status maggi_load_spring(const load_build *b, const load_spring *spring);
maggi_status maggi_load_joint_spring(const load_build *b, const load_joint_spring *spring);
maggi_status maggi_load_force(const load_build *b, const load_force *force);
maggi_status maggi_load_tyre(const load_build *b, const load_tyre *tyre);
maggi_status maggi_load_road(const load_build *b, const load_road *road);
maggi_status maggi_load_wheel(const load_build *b, const load_wheel *wheel);
maggi_status maggi_load_function(const load_build *b, const load_function *f);
maggi_status maggi_load_sensor(const load_build *b, const load_sensor *sensor);
maggi_status maggi_load_filter(const load_build *b, const load_filter *f);
maggi_status maggi_load_objective(const load_build *b, const load_objective *objective);
maggi_status maggi_load_design(const load_build *b, const load_design *design);

#endif
