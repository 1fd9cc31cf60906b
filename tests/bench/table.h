/* Tables of text cells, printed aligned or as Markdown. */
#ifndef BENCH_TABLE_H
#define BENCH_TABLE_H

enum { TABLE_COLUMNS = 16, TABLE_ROWS = 64, TABLE_CELL = 48 };

typedef struct table {
  int rows, columns;
  char cell[TABLE_ROWS][TABLE_COLUMNS][TABLE_CELL]; /* row 0 is the head */
} table;

/* head: texts of the columns, separated by '|'; the first column is aligned to the left */
void table_begin(table *t, const char *head);
void table_row(table *t);                             /* a new empty row */
void table_cell(table *t, const char *format, ...);   /* the next cell of the last row */
void table_print(const table *t, int markdown);

#endif
