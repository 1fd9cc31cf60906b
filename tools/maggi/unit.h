/* Units of quotients. */
#ifndef TOOL_UNIT_H
#define TOOL_UNIT_H

#define UNIT_MAX 160

/* a/b in text, as in "rad/kg", "m/(kg m^2)", "1/s"; "-" is no unit.  Returns text. */
const char *unit_quotient(const char *a, const char *b, char text[UNIT_MAX]);

#endif
