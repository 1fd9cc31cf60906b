/* The loaded file, through the public builder, into a model.
 *
 * What the tables cannot say is checked on the way, in load_body.c and load_element.c: which keys
 * go together, and the words of `type`.  What a number may be (a zero axis, a negative mass, ..) is
 * the builder's business; here its text gets a line.
 */
#include "load_build.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_CHARS = 200, TEXT_CHARS = 400 };

/* ------------------------------------------------------------------------------------- failures */

static maggi_status fail_memory(const load_build *b)
{
  maggi_load_fail(b->error, 0, "out of memory");
  return MAGGI_E_MEMORY;
}

maggi_status maggi_load_fail_at(const load_build *b, const char *rest, const char *format, ...)
{
  char path[PATH_CHARS];
  char text[TEXT_CHARS];
  va_list args;

  va_start(args, format);
  vsnprintf(text, sizeof text, format, args);
  va_end(args);
  snprintf(path, sizeof path, "%s[%u]%s", b->list, b->number, rest);
  return maggi_load_fail(b->error, maggi_load_line(b->bytes, b->n, path), "%s.%s%s: %s", b->list,
                         b->name, rest, text);
}

/* Path of what a text of the builder is about, `bodies.crank: joint axis is zero`: its words up to
 * the first that is no key, which maggi_load_line finds by itself.  Appends to path. */
static void add_words(char path[PATH_CHARS], const char *text)
{
  size_t n = strlen(path);

  for (; *text && n < PATH_CHARS - 1; ++text)
    if (*text == ' ')
      path[n++] = '.';
    else if (*text != ':')
      path[n++] = *text;
  path[n] = '\0';
}

/* The text begins with the path of the entry, or else is about the part `rest` of it. */
maggi_status maggi_load_added(const load_build *b, const char *rest, maggi_status status)
{
  const char *text;
  char head[PATH_CHARS], path[PATH_CHARS];

  if (status == MAGGI_OK) return MAGGI_OK;
  if (status == MAGGI_E_MEMORY) return fail_memory(b);
  text = maggi_builder_message(b->builder);
  snprintf(head, sizeof head, "%s.%s", b->list, b->name);
  snprintf(path, sizeof path, "%s[%u]%s", b->list, b->number, rest);
  if (*rest || strncmp(text, b->list, strlen(b->list)) != 0)
    return maggi_load_fail(b->error, maggi_load_line(b->bytes, b->n, path), "%s%s%s", head,
                           *rest ? "." : ": ", text);
  if (strncmp(text, head, strlen(head)) == 0) add_words(path, text + strlen(head));
  return maggi_load_fail(b->error, maggi_load_line(b->bytes, b->n, path), "%s", text);
}

/* The same for a call about a key of the top level, or (NULL) about the whole model. */
static maggi_status done(const load_build *b, const char *key, maggi_status status)
{
  const load_source *source;
  const char *text;
  char path[PATH_CHARS] = "";

  if (status == MAGGI_OK) return MAGGI_OK;
  if (status == MAGGI_E_MEMORY) return fail_memory(b);
  text = b->builder ? maggi_builder_message(b->builder) : maggi_status_text(status);
  source = maggi_load_text_source(b->files, key ? key : text);
  if (key && strncmp(text, key, strlen(key)) != 0)
    return maggi_load_fail(&source->error, maggi_load_line(source->bytes, source->n, key), "%s: %s",
                           key, text);
  add_words(path, text);
  return maggi_load_fail(&source->error, maggi_load_line(source->bytes, source->n, path), "%s",
                         text);
}

/* ------------------------------------------------------------------------------- words and keys */

maggi_status maggi_load_word(const load_build *b, const char *rest, const char *word,
                             const load_words *words, int *found)
{
  char all[TEXT_CHARS / 2] = "";
  size_t n = 0;
  int i;

  *found = words->find(word);
  if (*found >= 0) return MAGGI_OK;
  for (i = 0; words->word(i) && n < sizeof all; ++i)
    n += (size_t)snprintf(all + n, sizeof all - n, "%s%s", i ? ", " : "", words->word(i));
  return maggi_load_fail_at(b, rest, "\"%.40s\" is none of %s", word, all);
}

maggi_status maggi_load_keys(const load_build *b, const char *rest, const char *type,
                             const char *rule, const load_key *keys)
{
  char letter;

  for (; keys->key; ++keys) {
    letter = *rule ? *rule++ : '-';
    if (letter == 'r' && !keys->given)
      return maggi_load_fail_at(b, rest, "key \"%s\" is missing (type %s)", keys->key, type);
    if (letter == '-' && keys->given)
      return maggi_load_fail_at(b, rest, "type %s has no key \"%s\"", type, keys->key);
  }
  return MAGGI_OK;
}

void maggi_load_copy3(double to[3], const double *from)
{
  if (from) memcpy(to, from, 3 * sizeof *to);
}

char *maggi_load_path(const load_build *b, const char *file)
{
  return maggi_load_relative(b->error->file, file);
}

/* ------------------------------------------------------------------------------------ the model */

static void at_source(load_build *b, const load_source *source)
{
  b->error = &source->error;
  b->bytes = source->bytes;
  b->n = source->n;
}

/* add for every entry of a list */
#define ADD_ALL(entries, add)                                                                      \
  for (i = 0; status == MAGGI_OK && i < file->entries##_count; ++i) {                              \
    b->list = #entries;                                                                            \
    at_source(b, maggi_load_entry_source(b->files, #entries, i, &b->number));                      \
    b->name = file->entries[i].name;                                                               \
    status = add(b, &file->entries[i]);                                                            \
  }

static maggi_status add_entries(load_build *b, const load_model *file)
{
  maggi_status status = MAGGI_OK;
  unsigned i;

  ADD_ALL(functions, maggi_load_function)
  ADD_ALL(bodies, maggi_load_body)
  ADD_ALL(loops, maggi_load_loop)
  ADD_ALL(rods, maggi_load_rod)
  ADD_ALL(springs, maggi_load_spring)
  ADD_ALL(joint_springs, maggi_load_joint_spring)
  ADD_ALL(forces, maggi_load_force)
  ADD_ALL(tyres, maggi_load_tyre)
  ADD_ALL(roads, maggi_load_road)
  ADD_ALL(wheels, maggi_load_wheel)
  ADD_ALL(sensors, maggi_load_sensor)
  ADD_ALL(filters, maggi_load_filter)
  ADD_ALL(objectives, maggi_load_objective)
  ADD_ALL(design, maggi_load_design)
  ADD_ALL(set, maggi_load_set)
  return status;
}

static maggi_status add_head(const load_build *b, const load_model *file)
{
  maggi_simulation_def simulation;
  maggi_start_def start;
  maggi_status status = MAGGI_OK;

  if (file->source) status = done(b, "source", maggi_builder_source(b->builder, file->source));
  if (status == MAGGI_OK && file->gravity)
    status = done(b, "gravity", maggi_builder_gravity(b->builder, file->gravity));
  if (status == MAGGI_OK && file->simulation) {
    simulation.time = file->simulation->time;
    simulation.step = file->simulation->step;
    status = done(b, "simulation", maggi_builder_simulation(b->builder, &simulation));
  }
  if (status == MAGGI_OK && file->start) {
    start.equilibrium = file->start->equilibrium;
    start.rolling = file->start->rolling;
    start.nhold = (int)file->start->hold_count;
    start.hold = (const char *const *)file->start->hold;
    status = done(b, "start", maggi_builder_start(b->builder, &start));
  }
  return status;
}

maggi_status maggi_load_build(const load_files *files, maggi_model **model)
{
  const load_model *file = &files->all;
  load_build b = {.files = files};
  maggi_status status;

  at_source(&b, &files->source[0]);
  status = done(&b, "name", maggi_builder_create(file->name, &b.builder));
  if (status == MAGGI_OK) status = add_head(&b, file);
  if (status == MAGGI_OK) status = add_entries(&b, file);
  if (status == MAGGI_OK) status = done(&b, NULL, maggi_model_create(b.builder, model));
  maggi_builder_free(b.builder);
  return status;
}
