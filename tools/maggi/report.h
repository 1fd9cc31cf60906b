/* What a sensitivity analysis came to. */
#ifndef TOOL_REPORT_H
#define TOOL_REPORT_H

#include <stdio.h>

#include "gradients.h"
#include "json.h"
#include "study.h"
#include "table.h"

typedef struct report {
  const study *study;
  const gradients *gradients;
  double simulation_wall; /* of one simulation [s]                                             */
  int all_rows;           /* text: not only the first                                          */
  int *order;             /* most relevant parameters first           (objectives x parameters) */
  int *relevant;          /* by the state sensitivities                            (parameters) */
} report;

/* Sort, when the gradients are there: 0, or -1 without memory; report_free in either case. */
int report_init(report *r);
void report_free(report *r);

/* (b/J) dJ/db; NAN when J or b is 0, or when it is not finite. */
double report_normalised(const report *r, int objective, int parameter);

/* Unit of dJ/db, and of the state sensitivity that is the relevance.  Return text. */
const char *report_unit(const report *r, int objective, int parameter, char *text);
const char *report_relevance_unit(const report *r, int parameter, char *text);

void report_text(const report *r, FILE *out);
void report_json(const report *r, FILE *out);
void report_csv(const report *r, table *t);

#endif
