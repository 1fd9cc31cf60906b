/* Units as text. */
#include "unit.h"

#include <stdio.h>
#include <string.h>

static int is_none(const char *unit)
{
  return unit[0] == '\0' || strcmp(unit, "-") == 0 || strcmp(unit, "1") == 0;
}

/* Whether one of the characters stands outside of parentheses. */
static int has(const char *unit, const char *characters)
{
  int depth = 0;

  for (; *unit; ++unit) {
    depth += (*unit == '(') - (*unit == ')');
    if (depth == 0 && strchr(characters, *unit)) return 1;
  }
  return 0;
}

const char *unit_quotient(const char *a, const char *b, char text[UNIT_MAX])
{
  const char *top = is_none(a) ? "1" : a;
  int top_alone = !has(top, "/"), bottom_alone = !has(b, " /*");

  if (is_none(b))
    snprintf(text, UNIT_MAX, "%s", is_none(a) ? "-" : a);
  else if (strcmp(top, b) == 0)
    strcpy(text, "-");
  else
    snprintf(text, UNIT_MAX, "%s%s%s/%s%s%s", top_alone ? "" : "(", top, top_alone ? "" : ")",
             bottom_alone ? "" : "(", b, bottom_alone ? "" : ")");
  return text;
}
