/* What a simulation came to. */
#ifndef TOOL_SUMMARY_H
#define TOOL_SUMMARY_H

#include <stdio.h>

#include "json.h"
#include "run.h"

/* Write the summary, as text or as one JSON object.  out_name: of the CSV, or NULL. */
void summary_text(const run *r, const char *out_name, FILE *out);
void summary_json(const run *r, const char *out_name, FILE *out);
void summary_members(const run *r, const char *out_name, json *j); /* of the open object */

#endif
