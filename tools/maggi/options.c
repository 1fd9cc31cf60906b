/* Reading the command line. */
#include "options.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"
#include "nearest.h"

void options_init(options *o, const option_def *defs, int argc, char **argv)
{
  memset(o, 0, sizeof *o);
  o->command = argv[0];
  o->defs = defs;
  o->argc = argc;
  o->argv = argv;
  o->next = 1;
  o->list = -1;
}

static int unknown_option(const options *o, const char *word)
{
  nearest n;
  int i;

  nearest_init(&n, word);
  for (i = 0; o->defs[i].name; ++i) nearest_offer(&n, o->defs[i].name);
  nearest_offer(&n, "--help");
  message_fail(STATUS_USAGE, "%s: unknown option %s%s", o->command, word, nearest_hint(&n));
  return OPTIONS_WRONG;
}

/* The option `word`, whose text behind = (or NULL) is `value`. */
static int read_option(options *o, const char *word, char *value)
{
  const option_def *def;
  int i, left, looks_like_value;

  for (i = 0; o->defs[i].name && strcmp(o->defs[i].name, word) != 0; ++i)
    ;
  def = &o->defs[i];
  if (!def->name) return unknown_option(o, word);

  if (def->kind == OPTION_FLAG && value) {
    message_fail(STATUS_USAGE, "%s: %s takes no value", o->command, word);
    return OPTIONS_WRONG;
  }
  if (def->kind != OPTION_FLAG && def->kind != OPTION_LIST && o->given[i]) {
    message_fail(STATUS_USAGE, "%s: %s is given twice", o->command, word);
    return OPTIONS_WRONG;
  }
  o->given[i] = 1;

  left = o->next < o->argc;
  looks_like_value = left && strncmp(o->argv[o->next], "--", 2) != 0;
  if (!value && (def->kind == OPTION_VALUE || def->kind == OPTION_LIST)) {
    if (!looks_like_value) {
      message_fail(STATUS_USAGE, "%s: %s needs %s", o->command, word, def->what);
      return OPTIONS_WRONG;
    }
    value = o->argv[o->next++];
  }
  if (!value && def->kind == OPTION_OPTIONAL && looks_like_value && o->arguments > 0)
    value = o->argv[o->next++];
  if (def->kind == OPTION_LIST) o->list = i;
  o->value = value;
  return i;
}

int options_next(options *o)
{
  char *word, *equals;

  o->value = NULL;
  if (o->next >= o->argc) return OPTIONS_END;
  word = o->argv[o->next++];

  if (!o->plain && strcmp(word, "--") == 0) {
    o->plain = 1;
    o->list = -1;
    return options_next(o);
  }
  if (!o->plain && word[0] == '-' && word[1] != '\0') {
    o->list = -1;
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) return OPTIONS_HELP;
    equals = strchr(word, '=');
    if (equals) *equals++ = '\0';
    return read_option(o, word, equals);
  }
  o->value = word;
  if (o->list >= 0 && strchr(word, '=')) return o->list;
  o->list = -1;
  ++o->arguments;
  return OPTIONS_ARGUMENT;
}

int options_argument(options *o, const char *what, const char **argument)
{
  if (o->value[0] == '\0') {
    message_fail(STATUS_USAGE, "%s: %s is empty", o->command, what);
    return -1;
  }
  if (*argument) {
    message_fail(STATUS_USAGE, "%s: one %s only, but \"%s\" follows \"%s\"", o->command, what,
                 o->value, *argument);
    return -1;
  }
  *argument = o->value;
  return 0;
}

/* Decimal only: what strtod takes besides (spaces, hexadecimal, inf, nan) is a typing error. */
static int parse_number(const char *text, double *number)
{
  char *end;

  if (text[0] == '\0' || text[strspn(text, "0123456789+-.eE")] != '\0') return -1;
  *number = strtod(text, &end);
  return *end == '\0' && end != text ? 0 : -1;
}

int options_number(const char *option, const char *text, double *number)
{
  if (parse_number(text, number)) {
    message_fail(STATUS_USAGE, "%s: \"%s\" is not a number", option, text);
    return -1;
  }
  if (!isfinite(*number)) {
    message_fail(STATUS_USAGE, "%s: %s is too large for a number", option, text);
    return -1;
  }
  return 0;
}

int options_positive(const char *option, const char *text, double *number)
{
  if (options_number(option, text, number)) return -1;
  if (!(*number > 0.0)) {
    message_fail(STATUS_USAGE, "%s: %s is not above zero", option, text);
    return -1;
  }
  return 0;
}

int options_count(const char *option, const char *text, long least, long *number)
{
  const char *digits = text[0] == '-' || text[0] == '+' ? text + 1 : text;

  errno = 0;
  *number = strtol(text, NULL, 10);
  if (digits[0] == '\0' || digits[strspn(digits, "0123456789")] != '\0') {
    message_fail(STATUS_USAGE, "%s: \"%s\" is not a whole number", option, text);
    return -1;
  }
  if (errno == ERANGE || *number < least) {
    message_fail(STATUS_USAGE, "%s: %s is %s", option, text,
                 text[0] == '-' || errno != ERANGE ? "too small" : "too large");
    return -1;
  }
  return 0;
}

int options_bytes(const char *option, const char *text, size_t *bytes)
{
  static const char units[] = "KMG";
  const char *unit = text[0] ? strchr(units, text[strlen(text) - 1]) : NULL;
  char digits[32];
  size_t n = strlen(text) - (unit != NULL);
  int shift = unit ? 10 * (int)(unit - units + 1) : 0;
  unsigned long long number;

  if (n == 0 || n >= sizeof digits || strspn(text, "0123456789") < n) {
    message_fail(STATUS_USAGE, "%s: \"%s\" is not a number of bytes, as 65536, 64K, 2M or 1G",
                 option, text);
    return -1;
  }
  memcpy(digits, text, n);
  digits[n] = '\0';
  errno = 0;
  number = strtoull(digits, NULL, 10);
  if (errno == ERANGE || number > (SIZE_MAX >> shift) || number == 0) {
    message_fail(STATUS_USAGE, "%s: %s is too %s", option, text, number == 0 ? "small" : "large");
    return -1;
  }
  *bytes = (size_t)number << shift;
  return 0;
}

int options_file(const char *option, const char *text, const char **name)
{
  *name = text;
  if (text[0] != '\0') return 0;
  message_fail(STATUS_USAGE, "%s: the file name is empty", option);
  return -1;
}

int options_size(const char *text, int *number)
{
  long value;

  errno = 0;
  value = strtol(text, NULL, 10);
  if (text[0] == '\0' || text[strspn(text, "0123456789")] != '\0' || errno == ERANGE || value < 1 ||
      value > INT_MAX)
    return -1;
  *number = (int)value;
  return 0;
}
