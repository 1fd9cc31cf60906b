/* Is this text a model file?  One pass over libyaml's events, along the tables of load_schema.c.
 *
 * Recursion follows the tables, so its depth is theirs and not the file's.  Aliases are refused:
 * they make a small file large, and a model reads better without them.
 */
#include "load_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

enum { PATH_MAX_CHARS = 200, KEYS_MAX_CHARS = 300, QUOTE_MAX_CHARS = 40 };

typedef struct check {
  yaml_parser_t parser;
  const load_error *error;
  const char *bytes;
  size_t n;
  char path[PATH_MAX_CHARS + 1]; /* "bodies.crank.joint"; an entry is "bodies[3]" before its name */
} check;

/* ------------------------------------------------------------------------------ path and errors */

/* Append to the path (cut off where the buffer ends); the length before restores it. */
static size_t push(check *c, const char *separator, const char *text)
{
  size_t before = strlen(c->path);

  snprintf(c->path + before, sizeof c->path - before, "%s%s", separator, text);
  return before;
}

static size_t push_number(check *c, unsigned number)
{
  char text[16];

  snprintf(text, sizeof text, "[%u]", number);
  return push(c, "", text);
}

/* "bodies[3]" becomes "bodies.crank" as soon as the name is known. */
static void push_name(check *c, const char *name)
{
  char *bracket = strrchr(c->path, '[');

  if (bracket && c->path[strlen(c->path) - 1] == ']' && *name) {
    *bracket = '\0';
    push(c, ".", name);
  }
}

/* `FILE:LINE: path: text` */
static maggi_status fail(const check *c, size_t line, const char *text)
{
  return maggi_load_fail(c->error, line + 1, "%s%s%s", c->path, *c->path ? ": " : "", text);
}

static maggi_status fail_quoting(const check *c, size_t line, const char *quoted, const char *text)
{
  return maggi_load_fail(c->error, line + 1, "%s%s\"%.*s\" %s", c->path, *c->path ? ": " : "",
                         QUOTE_MAX_CHARS, quoted, text);
}

static maggi_status fail_syntax(const check *c)
{
  const yaml_parser_t *p = &c->parser;
  size_t line = p->problem_mark.line;
  size_t i;

  if (p->error == YAML_MEMORY_ERROR) {
    maggi_load_fail(c->error, 0, "out of memory");
    return MAGGI_E_MEMORY;
  }
  if (p->error == YAML_READER_ERROR)
    for (i = line = 0; i < p->problem_offset && i < c->n; ++i) line += c->bytes[i] == '\n';
  return maggi_load_fail(c->error, line + 1, "not YAML: %s%s%s", p->problem ? p->problem : "error",
                         p->context ? " " : "", p->context ? p->context : "");
}

/* Next event; the caller deletes it.  An alias is an error wherever it stands. */
static maggi_status next(check *c, yaml_event_t *event)
{
  maggi_status status;

  if (!yaml_parser_parse(&c->parser, event)) return fail_syntax(c);
  if (event->type != YAML_ALIAS_EVENT) return MAGGI_OK;
  status = fail(c, event->start_mark.line, "aliases (*name) are not allowed in a model file");
  yaml_event_delete(event);
  return status;
}

/* -------------------------------------------------------------------------------------- scalars */

/* [sign] digits [. digits] [e [sign] digits], digits on one side of the point at least */
int maggi_load_is_decimal(const char *text)
{
  static const char digits[] = "0123456789";
  const char *s = text;
  size_t before, after = 0;

  s += *s == '+' || *s == '-';
  before = strspn(s, digits);
  s += before;
  if (*s == '.') {
    after = strspn(++s, digits);
    s += after;
  }
  if (before + after == 0) return 0;
  if (*s == 'e' || *s == 'E') {
    ++s;
    s += *s == '+' || *s == '-';
    before = strspn(s, digits);
    if (before == 0) return 0;
    s += before;
  }
  return *s == '\0';
}

static int is_null(const char *s)
{
  return *s == '\0' || strcmp(s, "~") == 0 || strcmp(s, "null") == 0 || strcmp(s, "Null") == 0 ||
         strcmp(s, "NULL") == 0;
}

static maggi_status check_scalar(check *c, const yaml_event_t *event,
                                 const cyaml_schema_value_t *schema)
{
  const char *text = (const char *)event->data.scalar.value;
  size_t line = event->start_mark.line;
  int may_be_null = (schema->flags & CYAML_FLAG_POINTER_NULL_STR) == CYAML_FLAG_POINTER_NULL_STR;

  if (strlen(text) != event->data.scalar.length)
    return fail(c, line, "a text with a NUL character");
  if (schema->type == CYAML_FLOAT && !(may_be_null && is_null(text))) {
    if (*text == '\0') return fail(c, line, "a number is missing");
    if (!maggi_load_is_decimal(text)) return fail_quoting(c, line, text, "is not a number");
    if (!isfinite(strtod(text, NULL))) return fail_quoting(c, line, text, "is too large");
  }
  if (schema->type == CYAML_BOOL && strcmp(text, "true") != 0 && strcmp(text, "false") != 0)
    return fail_quoting(c, line, text, "is neither true nor false");
  if (strcmp(c->path, "format") == 0 && strcmp(text, MAGGI_LOAD_FORMAT) != 0)
    return fail_quoting(c, line, text, "is not \"" MAGGI_LOAD_FORMAT "\"");
  if (strcmp(c->path, "version") == 0 && strcmp(text, MAGGI_LOAD_VERSION) != 0)
    return fail_quoting(c, line, text,
                        "is unknown: this library reads version " MAGGI_LOAD_VERSION);
  return MAGGI_OK;
}

/* --------------------------------------------------------------------------- mappings and lists */

static maggi_status check_value(check *c, const yaml_event_t *event,
                                const cyaml_schema_value_t *schema);

static const cyaml_schema_field_t *find_key(const cyaml_schema_field_t *fields, const char *key)
{
  for (; fields->key; ++fields)
    if (strcmp(fields->key, key) == 0) return fields;
  return NULL;
}

static maggi_status fail_key(const check *c, size_t line, const cyaml_schema_field_t *fields,
                             const char *key)
{
  char keys[KEYS_MAX_CHARS] = "";
  size_t n = 0;

  for (; fields->key && n < sizeof keys; ++fields)
    n += (size_t)snprintf(keys + n, sizeof keys - n, "%s%s", n ? ", " : "", fields->key);
  return maggi_load_fail(c->error, line + 1, "%s%sunknown key \"%.*s\"; known are %s", c->path,
                         *c->path ? ": " : "", QUOTE_MAX_CHARS, key, keys);
}

/* A key and its value; `seen` has a bit for each key of the table, `order` is the number of keys
 * before. */
static maggi_status check_pair(check *c, const yaml_event_t *key,
                               const cyaml_schema_field_t *fields, unsigned long *seen,
                               unsigned order)
{
  const char *text = (const char *)key->data.scalar.value;
  const cyaml_schema_field_t *field;
  yaml_event_t value;
  unsigned long bit;
  size_t line = key->start_mark.line;
  size_t before;
  maggi_status status;

  if (key->type != YAML_SCALAR_EVENT) return fail(c, line, "a key must be a word");
  if (*c->path == '\0' && order < 2 && strcmp(text, fields[order].key) != 0)
    return maggi_load_fail(c->error, line + 1, "key number %u of a model file is \"%s: %s\"",
                           order + 1, fields[order].key,
                           order ? MAGGI_LOAD_VERSION : MAGGI_LOAD_FORMAT);
  field = find_key(fields, text);
  if (!field) return fail_key(c, line, fields, text);
  bit = 1ul << (field - fields);
  if (*seen & bit) return fail_quoting(c, line, text, "is here twice");
  *seen |= bit;

  status = next(c, &value);
  if (status) return status;
  before = push(c, *c->path ? "." : "", text);
  status = check_value(c, &value, &field->value);
  c->path[before] = '\0';
  if (status == MAGGI_OK && strcmp(text, "name") == 0)
    push_name(c, (const char *)value.data.scalar.value);
  yaml_event_delete(&value);
  return status;
}

static maggi_status check_mapping(check *c, size_t line, const cyaml_schema_field_t *fields)
{
  yaml_event_t event;
  unsigned long seen = 0;
  unsigned i;
  maggi_status status;

  for (i = 0;; ++i) {
    status = next(c, &event);
    if (status) return status;
    if (event.type == YAML_MAPPING_END_EVENT) break;
    status = check_pair(c, &event, fields, &seen, i);
    yaml_event_delete(&event);
    if (status) return status;
  }
  yaml_event_delete(&event);
  for (i = 0; fields[i].key; ++i)
    if (!(seen >> i & 1) && !(fields[i].value.flags & CYAML_FLAG_OPTIONAL))
      return maggi_load_fail(c->error, line + 1, "%s%skey \"%s\" is missing", c->path,
                             *c->path ? ": " : "", fields[i].key);
  return MAGGI_OK;
}

static maggi_status check_list(check *c, size_t line, const cyaml_schema_value_t *schema)
{
  yaml_event_t event;
  unsigned count = 0;
  size_t before = strlen(c->path);
  maggi_status status = MAGGI_OK;

  for (;;) {
    status = next(c, &event);
    if (status) return status;
    if (event.type == YAML_SEQUENCE_END_EVENT) break;
    push_number(c, count);
    status = check_value(c, &event, schema->sequence.entry);
    c->path[before] = '\0';
    yaml_event_delete(&event);
    if (status) return status;
    ++count;
  }
  yaml_event_delete(&event);
  if (count >= schema->sequence.min && count <= schema->sequence.max) return MAGGI_OK;
  if (schema->sequence.min == schema->sequence.max)
    return maggi_load_fail(c->error, line + 1, "%s: %u entries instead of %u", c->path, count,
                           (unsigned)schema->sequence.max);
  if (count == 0) return fail(c, line, "the list is empty");
  return maggi_load_fail(c->error, line + 1, "%s: %u entries, %u are the most", c->path, count,
                         (unsigned)schema->sequence.max);
}

static const char *kind_of(const cyaml_schema_value_t *schema)
{
  switch (schema->type) {
  case CYAML_FLOAT:
    return "a number";
  case CYAML_BOOL:
    return "true or false";
  case CYAML_MAPPING:
    return "a mapping (key: value)";
  case CYAML_SEQUENCE:
    return "a list";
  case CYAML_SEQUENCE_FIXED:
    return "a list of 3 numbers"; /* the tables have no others */
  default:
    return "a text";
  }
}

static maggi_status check_value(check *c, const yaml_event_t *event,
                                const cyaml_schema_value_t *schema)
{
  int is_mapping = schema->type == CYAML_MAPPING;
  int is_list = schema->type == CYAML_SEQUENCE || schema->type == CYAML_SEQUENCE_FIXED;
  size_t line = event->start_mark.line;

  if (is_mapping && event->type == YAML_MAPPING_START_EVENT)
    return check_mapping(c, line, schema->mapping.fields);
  if (is_list && event->type == YAML_SEQUENCE_START_EVENT) return check_list(c, line, schema);
  if (!is_mapping && !is_list && event->type == YAML_SCALAR_EVENT)
    return check_scalar(c, event, schema);
  return maggi_load_fail(c->error, line + 1, "%s must be %s", *c->path ? c->path : "a model file",
                         kind_of(schema));
}

/* ------------------------------------------------------------------------------------- document */

/* Read an event of this type and forget it. */
static maggi_status expect(check *c, yaml_event_type_t type, const char *otherwise)
{
  yaml_event_t event;
  maggi_status status = next(c, &event);

  if (status) return status;
  if (event.type != type) status = fail(c, event.start_mark.line, otherwise);
  yaml_event_delete(&event);
  return status;
}

static maggi_status check_stream(check *c)
{
  yaml_event_t root;
  maggi_status status;

  status = expect(c, YAML_STREAM_START_EVENT, "not YAML");
  if (status == MAGGI_OK) status = expect(c, YAML_DOCUMENT_START_EVENT, "the file is empty");
  if (status == MAGGI_OK) status = next(c, &root);
  if (status) return status;
  status = check_value(c, &root, &maggi_load_schema);
  yaml_event_delete(&root);
  if (status == MAGGI_OK) status = expect(c, YAML_DOCUMENT_END_EVENT, "not YAML");
  if (status == MAGGI_OK)
    status = expect(c, YAML_STREAM_END_EVENT, "a second document; a model file has one");
  return status;
}

maggi_status maggi_load_check(const load_error *e, const char *bytes, size_t n)
{
  check c = {.error = e, .bytes = bytes, .n = n};
  maggi_status status;

  if (!yaml_parser_initialize(&c.parser)) {
    maggi_load_fail(e, 0, "out of memory");
    return MAGGI_E_MEMORY;
  }
  yaml_parser_set_input_string(&c.parser, (const unsigned char *)bytes, n);
  status = check_stream(&c);
  yaml_parser_delete(&c.parser);
  return status;
}
