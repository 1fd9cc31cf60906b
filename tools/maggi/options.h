/* The command line: options by name, values strictly read. */
#ifndef TOOL_OPTIONS_H
#define TOOL_OPTIONS_H

#include <stddef.h>

typedef enum option_kind {
  OPTION_FLAG,     /* --json                                                               */
  OPTION_VALUE,    /* --time 1 or --time=1, once                                           */
  OPTION_OPTIONAL, /* --parameters=GLOB; or --parameters GLOB behind the first argument    */
  OPTION_LIST      /* --set A=1 B=2 .. : any following arguments with a = ; several times  */
} option_kind;

typedef struct option_def {
  const char *name; /* "--time"; NULL ends the table */
  option_kind kind;
  const char *what; /* name of the value in messages */
} option_def;

#define OPTIONS_MAX 32 /* entries of a table */

/* What options_next returns when it is not the index of an option. */
enum { OPTIONS_END = -1, OPTIONS_ARGUMENT = -2, OPTIONS_HELP = -3, OPTIONS_WRONG = -4 };

typedef struct options {
  const char *command;
  const option_def *defs;
  int argc;
  char **argv;
  int next;      /* index in argv                             */
  int list;      /* the OPTION_LIST that is being read, or -1 */
  int arguments; /* arguments seen                            */
  int plain;     /* "--" was seen                             */
  char given[OPTIONS_MAX];
  char *value; /* of the option or argument just returned, or NULL */
} options;

/* argv[0] is the name of the command. */
void options_init(options *o, const option_def *defs, int argc, char **argv);

/* Next option (index in defs) or argument; OPTIONS_WRONG after printing what is wrong. */
int options_next(options *o);

/* Take the value as the one argument of the command, called `what`: 0, or -1 after a message. */
int options_argument(options *o, const char *what, const char **argument);

/* The whole text as a finite decimal number, one above zero, or a whole number of at least `least`:
 * 0, or -1 after a message that begins with `option`. */
int options_number(const char *option, const char *text, double *number);
int options_positive(const char *option, const char *text, double *number);
int options_count(const char *option, const char *text, long least, long *number);

/* A number of bytes above zero, with K, M or G (1024, 1024^2, 1024^3) behind it or not; the same. */
int options_bytes(const char *option, const char *text, size_t *bytes);

/* Take the text as a file name, not an empty one: 0, or -1 after a message. */
int options_file(const char *option, const char *text, const char **name);

/* Digits only, in the range of int and at least 1: 0, else -1; no message. */
int options_size(const char *text, int *number);

#endif
