#include "table.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* characters, not bytes, of UTF-8 */
static int width(const char *text)
{
  int n = 0;

  for (; *text; ++text)
    n += ((unsigned char)*text & 0xC0) != 0x80;
  return n;
}

void table_begin(table *t, const char *head)
{
  const char *end;

  t->rows = 0;
  table_row(t);
  for (; *head; head = *end ? end + 1 : end) {
    end = strchr(head, '|');
    if (!end)
      end = head + strlen(head);
    table_cell(t, "%.*s", (int)(end - head), head);
  }
}

void table_row(table *t)
{
  assert(t->rows < TABLE_ROWS);
  memset(t->cell[t->rows], 0, sizeof t->cell[0]);
  ++t->rows;
  t->columns = 0;
}

void table_cell(table *t, const char *format, ...)
{
  va_list arguments;

  assert(t->columns < TABLE_COLUMNS);
  va_start(arguments, format);
  vsnprintf(t->cell[t->rows - 1][t->columns], TABLE_CELL, format, arguments);
  va_end(arguments);
  ++t->columns;
}

void table_print(const table *t, int markdown)
{
  int wide[TABLE_COLUMNS] = {0};
  int columns = 0, row, column, n, pad;

  for (column = 0; column < TABLE_COLUMNS; ++column) {
    if (t->cell[0][column][0])
      columns = column + 1;
    for (row = 0; row < t->rows; ++row) {
      n = width(t->cell[row][column]);
      if (n > wide[column])
        wide[column] = n;
    }
  }
  for (row = 0; row < t->rows; ++row) {
    for (column = 0; column < columns; ++column) {
      pad = wide[column] - width(t->cell[row][column]);
      printf("%s", markdown ? "| " : column > 0 ? "  " : "");
      if (column > 0)
        printf("%*s%s", pad, "", t->cell[row][column]);
      else
        printf("%s%*s", t->cell[row][column], pad, "");
      printf("%s", markdown ? " " : "");
    }
    printf("%s\n", markdown ? "|" : "");
    if (row > 0)
      continue;
    for (column = 0; column < columns; ++column) {
      printf("%s", markdown ? "|" : column > 0 ? "  " : "");
      for (n = 0; n < wide[column] + (markdown ? 1 : 0); ++n)
        putchar('-');
      printf("%s", markdown ? column > 0 ? ":" : "-" : "");
    }
    printf("%s\n", markdown ? "|" : "");
  }
  putchar('\n');
}
