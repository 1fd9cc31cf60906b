/* A model file and the files that it builds on, read and put together.
 *
 * The base comes first: to its lists the file adds entries, or puts them in the place of entries of the
 * same name, after it has taken away those that `remove` names.  What a key holds is asked of the table of
 * keys, so that a new list of the model file needs nothing here: the first member of every entry is its
 * name.
 */
#include "load_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static maggi_status fail_memory(const load_error *e)
{
  maggi_load_fail(e, 0, "out of memory");
  return MAGGI_E_MEMORY;
}

/* ------------------------------------------------------------------------------------- the chain */

char *maggi_load_relative(const char *from, const char *file)
{
  const char *slash = *file == '/' ? NULL : strrchr(from, '/');
  size_t head = slash ? (size_t)(slash - from) + 1 : 0, n = strlen(file) + 1;
  char *path = malloc(head + n);

  if (!path) return NULL;
  memcpy(path, from, head);
  memcpy(path + head, file, n);
  return path;
}

/* Next part of a path that is not "." and that no ".." behind it takes back; its length, 0 at the end. */
static size_t next_part(const char **path)
{
  const char *p = *path, *rest;
  size_t n;

  for (;;) {
    p += strspn(p, "/");
    n = strcspn(p, "/");
    if (n == 1 && *p == '.') {
      ++p;
      continue;
    }
    rest = p + n;
    if (n > 0 && !(n == 2 && memcmp(p, "..", 2) == 0) && next_part(&rest) == 2 &&
        memcmp(rest, "..", 2) == 0) {
      p = rest + 2;
      continue;
    }
    *path = p;
    return n;
  }
}

/* whether two paths are the same but for "." and ".." */
static int is_same_path(const char *a, const char *b)
{
  size_t na, nb;

  if ((*a == '/') != (*b == '/')) return 0;
  do {
    na = next_part(&a);
    nb = next_part(&b);
    if (na != nb || memcmp(a, b, na) != 0) return 0;
    a += na;
    b += nb;
  } while (na > 0);
  return 1;
}

/* the line of a key of a source */
static size_t line_of(const load_source *s, const char *path)
{
  return maggi_load_line(s->bytes, s->n, path);
}

/* Reads the base of the last source. */
static maggi_status read_base(load_files *files)
{
  load_source *s = &files->source[files->number - 1], *base = s + 1;
  const char *name = s->file->base;
  char text[400] = "";
  load_error quiet = {NULL, text, sizeof text};
  maggi_status status;
  int i;

  if (files->number == MAGGI_LOAD_FILES)
    return maggi_load_fail(&s->error, line_of(s, "base"),
                           "base: more than %d files, one on another", MAGGI_LOAD_FILES);
  memset(base, 0, sizeof *base);
  base->path = maggi_load_relative(s->error.file, name);
  if (!base->path) return fail_memory(&s->error);
  quiet.file = base->path;
  status = maggi_load_read(&quiet, &base->owned, &base->n);
  if (status == MAGGI_OK) {
    base->error = s->error;
    base->error.file = base->path;
    base->bytes = base->owned;
    ++files->number;
    for (i = 0; &files->source[i] < base; ++i)
      if (is_same_path(files->source[i].error.file, base->path))
        return maggi_load_fail(&s->error, line_of(s, "base"), "base: \"%.200s\" builds on itself",
                               name);
    return MAGGI_OK;
  }
  free(base->path);
  if (status == MAGGI_E_MEMORY) return fail_memory(&s->error);
  maggi_load_fail(&s->error, line_of(s, "base"), "base: %s", text);
  return status;
}

/* ---------------------------------------------------------------------------------------- the sum */

static const cyaml_schema_field_t *find_key(const char *key, size_t n)
{
  const cyaml_schema_field_t *field = maggi_load_schema.mapping.fields;

  for (; field->key; ++field)
    if (strlen(field->key) == n && memcmp(field->key, key, n) == 0) return field;
  return NULL;
}

/* position in the table of keys */
static size_t number_of(const cyaml_schema_field_t *field)
{
  return (size_t)(field - maggi_load_schema.mapping.fields);
}

/* a list of entries, which have names */
static int is_entries(const cyaml_schema_field_t *field)
{
  return field->value.type == CYAML_SEQUENCE && field->value.sequence.entry->type == CYAML_MAPPING;
}

static void **pointer_of(const load_model *file, const cyaml_schema_field_t *field)
{
  return (void **)((char *)file + field->data_offset);
}

static unsigned *count_of(const load_model *file, const cyaml_schema_field_t *field)
{
  return (unsigned *)((char *)file + field->count_offset);
}

static char *entry_of(const load_model *file, const cyaml_schema_field_t *field, size_t i)
{
  return (char *)*pointer_of(file, field) + i * field->value.sequence.entry->data_size;
}

static const char *name_of(const load_model *file, const cyaml_schema_field_t *field, size_t i)
{
  return *(char **)entry_of(file, field, i);
}

/* Position of an entry of this name in the sum, or the number of them. */
static unsigned find_entry(const load_files *files, const cyaml_schema_field_t *field,
                           const char *name)
{
  unsigned i, count = *count_of(&files->all, field);

  for (i = 0; i < count && strcmp(name_of(&files->all, field, i), name) != 0; ++i)
    ;
  return i;
}

static maggi_status remove_one(load_files *files, int s, unsigned number, const char *text)
{
  const load_source *source = &files->source[s];
  const char *dot = strchr(text, '.');
  const cyaml_schema_field_t *field = dot ? find_key(text, (size_t)(dot - text)) : NULL;
  load_origin *origin;
  unsigned i, count = 0;
  size_t size;
  char path[40];

  snprintf(path, sizeof path, "remove[%u]", number);
  if (!field || !is_entries(field))
    return maggi_load_fail(&source->error, line_of(source, path),
                           "remove: \"%.80s\" is not LIST.NAME, such as springs.left", text);
  count = *count_of(&files->all, field);
  i = find_entry(files, field, dot + 1);
  if (i == count)
    return maggi_load_fail(&source->error, line_of(source, path),
                           "remove: \"%.80s\" is not in the base", text);
  size = field->value.sequence.entry->data_size;
  origin = files->origin[number_of(field)];
  memmove(entry_of(&files->all, field, i), entry_of(&files->all, field, i + 1u),
          (count - i - 1) * size);
  memmove(&origin[i], &origin[i + 1], (count - i - 1) * sizeof *origin);
  --*count_of(&files->all, field);
  return MAGGI_OK;
}

/* Entries of a list of the source s, each in the place of that of its name in the files before; one
 * that is in its own file twice stays so, for the builder to say. */
static maggi_status join_list(load_files *files, int s, const cyaml_schema_field_t *field)
{
  const load_source *source = &files->source[s];
  load_origin **origin = &files->origin[number_of(field)], *origins;
  size_t size = field->value.sequence.entry->data_size;
  unsigned *count = count_of(&files->all, field), more = *count_of(source->file, field);
  unsigned i, at;
  const char *name;
  void *grown;

  if (more == 0) return MAGGI_OK;
  grown = realloc(*pointer_of(&files->all, field), ((size_t)*count + more) * size);
  if (grown) *pointer_of(&files->all, field) = grown;
  origins = realloc(*origin, ((size_t)*count + more) * sizeof *origins);
  if (origins) *origin = origins;
  if (!grown || !origins) return fail_memory(&source->error);
  for (i = 0; i < more; ++i) {
    name = name_of(source->file, field, i);
    at = find_entry(files, field, name);
    if (at < *count && origins[at].source == s) at = *count;
    if (at == *count) ++*count;
    memcpy(entry_of(&files->all, field, at), entry_of(source->file, field, i), size);
    origins[at].source = s;
    origins[at].number = i;
  }
  return MAGGI_OK;
}

static maggi_status join(load_files *files, int s)
{
  const load_source *source = &files->source[s];
  const load_model *file = source->file;
  const cyaml_schema_field_t *field;
  maggi_status status = MAGGI_OK;
  unsigned i;

  if (file->remove && !file->base)
    return maggi_load_fail(&source->error, line_of(source, "remove"),
                           "remove: there is no \"base\" to remove from");
  for (i = 0; i < file->remove_count && status == MAGGI_OK; ++i)
    status = remove_one(files, s, i, file->remove[i]);
  for (field = maggi_load_schema.mapping.fields; field->key && status == MAGGI_OK; ++field) {
    if (is_entries(field))
      status = join_list(files, s, field);
    else if (field->value.type != CYAML_SEQUENCE && field->value.flags & CYAML_FLAG_POINTER &&
             *pointer_of(file, field))
      *pointer_of(&files->all, field) = *pointer_of(file, field);
  }
  return status;
}

maggi_status maggi_load_files(load_files *files)
{
  maggi_status status;
  int s;

  do {
    s = files->number - 1;
    status = maggi_load_parse(&files->source[s]);
    if (status == MAGGI_OK && files->source[s].file->base) status = read_base(files);
  } while (status == MAGGI_OK && s < files->number - 1);
  for (s = files->number - 1; s >= 0 && status == MAGGI_OK; --s) status = join(files, s);
  if (status == MAGGI_OK) files->all.source = files->source[0].file->source;
  return status;
}

void maggi_load_files_free(load_files *files)
{
  const cyaml_schema_field_t *field;
  int s;

  for (field = maggi_load_schema.mapping.fields; field->key; ++field)
    if (is_entries(field)) {
      free(*pointer_of(&files->all, field));
      free(files->origin[number_of(field)]);
    }
  for (s = 0; s < files->number; ++s) {
    maggi_load_parse_free(&files->source[s]);
    free(files->source[s].owned);
    free(files->source[s].path);
  }
}

/* ------------------------------------------------------------------------------------- who said it */

const load_source *maggi_load_entry_source(const load_files *files, const char *list, unsigned i,
                                           unsigned *number)
{
  const load_origin *origin = &files->origin[number_of(find_key(list, strlen(list)))][i];

  *number = origin->number;
  return &files->source[origin->source];
}

/* Whether a text begins with a word. */
static int begins_with(const char *text, const char *word)
{
  size_t n = strlen(word);

  return strncmp(text, word, n) == 0 && strchr(".: ", text[n]); /* or its end */
}

const load_source *maggi_load_text_source(const load_files *files, const char *text)
{
  size_t n = strcspn(text, ".: ");
  const cyaml_schema_field_t *field = find_key(text, n);
  unsigned i;
  int s;

  if (!field) return &files->source[0];
  if (is_entries(field) && text[n] == '.')
    for (i = 0; i < *count_of(&files->all, field); ++i)
      if (begins_with(text + n + 1, name_of(&files->all, field, i)))
        return &files->source[files->origin[number_of(field)][i].source];
  for (s = 0; s < files->number - 1; ++s)
    if (field->value.flags & CYAML_FLAG_POINTER && *pointer_of(files->source[s].file, field)) break;
  return &files->source[s];
}
