/* What stands in the rows of a simulation's CSV. */
#ifndef TOOL_ROWS_H
#define TOOL_ROWS_H

#include <maggi/maggi.h>

#include "table.h"

typedef struct rows {
  table table;
  const maggi_model *model;
  maggi_model_info info;
  int energy;              /* energy columns wanted                                  */
  int nreaction;           /* bodies whose reactions are wanted                      */
  int *reaction;           /* their indices                             (nreaction)  */
  double *q;               /* workspace                                 (coordinates) */
  double *v;               /*                                           (coordinates) */
  double *a;               /*                                           (coordinates) */
  double *sensor, *filter; /*                                           (sensor_columns) */
  double *wrench;          /*                                           (bodies x 6) */
} rows;

/* Allocate, and understand `reactions`: "all", names between commas, or NULL for none.  Exit
 * status, after a message when it is not STATUS_DONE; rows_free in either case. */
int rows_init(rows *r, const maggi_model *m, int energy, const char *reactions);
void rows_free(rows *r);

/* Write the header, or the row of the present state.  For table errors see table_has_failed. */
void rows_header(rows *r);
void rows_write(rows *r, maggi_data *d);

#endif
