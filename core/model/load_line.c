/* Line of an entry of a model file.
 *
 * libcyaml keeps no line numbers, so an error that is found after loading reads the file again:
 * only then, and only to say where.
 */
#include "load_file.h"

#include <stdlib.h>
#include <string.h>
#include <yaml.h>

static int scalar_is(yaml_document_t *doc, int id, const char *text, size_t ntext)
{
  const yaml_node_t *node = yaml_document_get_node(doc, id);

  return node && node->type == YAML_SCALAR_NODE && node->data.scalar.length == ntext &&
         memcmp(node->data.scalar.value, text, ntext) == 0;
}

/* Whether a path begins with the text of a scalar and a part of it ends there; its length. */
static int begins_with(yaml_document_t *doc, int id, const char *path, size_t *n)
{
  const yaml_node_t *node = yaml_document_get_node(doc, id);
  size_t length;

  if (!node || node->type != YAML_SCALAR_NODE || node->data.scalar.length == 0) return 0;
  length = node->data.scalar.length;
  if (strncmp(path, (const char *)node->data.scalar.value, length) != 0) return 0;
  if (path[length] != '.' && path[length] != '[' && path[length] != '\0') return 0;
  *n = length;
  return 1;
}

/* Pair of a mapping with this key, or NULL. */
static const yaml_node_pair_t *find_pair(yaml_document_t *doc, const yaml_node_t *mapping,
                                         const char *key, size_t nkey)
{
  const yaml_node_pair_t *pair;

  if (!mapping || mapping->type != YAML_MAPPING_NODE) return NULL;
  for (pair = mapping->data.mapping.pairs.start; pair < mapping->data.mapping.pairs.top; ++pair)
    if (scalar_is(doc, pair->key, key, nkey)) return pair;
  return NULL;
}

/* Entry of a list by its number (a part "3" of the path, from [3]) or by its name, which may have points
 * and is then longer than the part. */
static const yaml_node_t *find_entry(yaml_document_t *doc, const yaml_node_t *list,
                                     const char *part, size_t *npart, int by_number)
{
  const yaml_node_item_t *item;
  const yaml_node_t *entry;
  const yaml_node_pair_t *name;
  long number = by_number ? strtol(part, NULL, 10) : -1;

  for (item = list->data.sequence.items.start; item < list->data.sequence.items.top; ++item) {
    entry = yaml_document_get_node(doc, *item);
    if (by_number) {
      if (number-- == 0) return entry;
    } else {
      name = find_pair(doc, entry, "name", 4);
      if (!name || !begins_with(doc, name->value, part, npart)) continue;
      return entry;
    }
  }
  return NULL;
}

static size_t find_line(yaml_document_t *doc, const char *path)
{
  const yaml_node_t *node = yaml_document_get_root_node(doc);
  const yaml_node_pair_t *pair;
  size_t line = node ? node->start_mark.line : 0;
  size_t npart;
  int by_number;

  while (node && *path) {
    by_number = *path == '[';
    if (*path == '[' || *path == '.') ++path;
    npart = strcspn(path, ".[]");
    if (node->type == YAML_MAPPING_NODE) {
      pair = find_pair(doc, node, path, npart);
      if (!pair) break;
      line = yaml_document_get_node(doc, pair->key)->start_mark.line;
      node = yaml_document_get_node(doc, pair->value);
    } else if (node->type == YAML_SEQUENCE_NODE) {
      node = find_entry(doc, node, path, &npart, by_number);
      if (!node) break;
      line = node->start_mark.line;
    } else {
      break;
    }
    path += npart;
    if (*path == ']') ++path;
  }
  return line + 1;
}

size_t maggi_load_line(const char *bytes, size_t n, const char *path)
{
  yaml_parser_t parser;
  yaml_document_t doc;
  size_t line = 1;

  if (!yaml_parser_initialize(&parser)) return line;
  yaml_parser_set_input_string(&parser, (const unsigned char *)bytes, n);
  if (yaml_parser_load(&parser, &doc)) {
    line = find_line(&doc, path);
    yaml_document_delete(&doc);
  }
  yaml_parser_delete(&parser);
  return line;
}
