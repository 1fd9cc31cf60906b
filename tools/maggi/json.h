/* A small JSON writer: indented, names and commas looked after, always valid UTF-8. */
#ifndef TOOL_JSON_H
#define TOOL_JSON_H

#include <stdio.h>

typedef struct json {
  FILE *out;
  int depth;
  int empty; /* nothing yet in the innermost object or array */
} json;

void json_init(json *j, FILE *out);

/* key is NULL inside an array and at the outermost level, which ends with a new line. */
void json_open_object(json *j, const char *key);
void json_close_object(json *j);
void json_open_array(json *j, const char *key);
void json_close_array(json *j);

void json_string(json *j, const char *key, const char *text); /* NULL: null                     */
void json_number(json *j, const char *key, double x);         /* %.17g; null when not finite    */
void json_integer(json *j, const char *key, long n);
void json_boolean(json *j, const char *key, int yes);
void json_null(json *j, const char *key);

#endif
