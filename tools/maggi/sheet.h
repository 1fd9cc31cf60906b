/* What a model is made of, as JSON: for maggi info and beside the table of a run. */
#ifndef TOOL_SHEET_H
#define TOOL_SHEET_H

#include <maggi/maggi.h>

#include "json.h"

typedef struct subject {
  const maggi_model *model;
  maggi_data *data;
  maggi_model_info info;
  int is_reset;           /* the loops are closed: rank and degrees of freedom are known */
  maggi_loop_state loops; /* if so */
} subject;

/* Whether the path of a parameter matches glob (NULL: all do). */
int sheet_wants(const char *path, const char *glob);

/* Members of the open object: parameters that match glob; all, parameters included. */
void sheet_parameters(json *j, const subject *s, const char *glob);
void sheet_json(json *j, const subject *s);

#endif
