/* maggi: dynamics of multibody systems, on the command line. */
#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700
#endif
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <maggi/maggi.h>

#include "commands.h"
#include "message.h"
#include "nearest.h"

static int command_help(int argc, char **argv);
static int command_version(int argc, char **argv);

typedef struct command {
  const char *name;
  int (*run)(int argc, char **argv);
} command;

static const command commands[] = {{"simulate", command_simulate},
                                   {"sensitivity", command_sensitivity},
                                   {"verify", command_verify},
                                   {"report", command_report},
                                   {"info", command_info},
                                   {"models", command_models},
                                   {"tyre", command_tyre},
                                   {"help", command_help},
                                   {"version", command_version},
                                   {NULL, NULL}};

static int unknown_command(const char *word)
{
  nearest n;
  int i;

  nearest_init(&n, word);
  for (i = 0; commands[i].name; ++i) nearest_offer(&n, commands[i].name);
  if (n.best) return message_fail(STATUS_USAGE, "unknown command \"%s\"%s", word, nearest_hint(&n));
  return message_fail(STATUS_USAGE, "unknown command \"%s\"; \"maggi help\" lists the commands",
                      word);
}

static int command_help(int argc, char **argv)
{
  const char *text;

  if (argc > 2) return message_fail(STATUS_USAGE, "help: one COMMAND only");
  text = help_text(argc == 2 && argv[1][0] != '-' ? argv[1] : "");
  if (!text) return unknown_command(argv[1]);
  fputs(text, stdout);
  return STATUS_DONE;
}

static int command_version(int argc, char **argv)
{
  if (argc > 1) return message_fail(STATUS_USAGE, "version: unexpected argument \"%s\"", argv[1]);
  puts("maggi " MAGGI_VERSION);
  return STATUS_DONE;
}

static int dispatch(int argc, char **argv)
{
  const char *word;
  int i;

  if (argc < 2)
    return message_fail(STATUS_USAGE, "no command given; \"maggi help\" lists the commands");
  word = argv[1];
  if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) word = "help";
  if (strcmp(word, "--version") == 0) word = "version";
  for (i = 0; commands[i].name; ++i)
    if (strcmp(word, commands[i].name) == 0) return commands[i].run(argc - 1, argv + 1);
  return unknown_command(word);
}

/* A closed standard stream must not become the number of the next file that is opened. */
static void keep_standard_streams(void)
{
  int fd;

  do fd = open("/dev/null", O_RDONLY);
  while (fd >= 0 && fd <= STDERR_FILENO);
  if (fd > STDERR_FILENO) close(fd);
}

int main(int argc, char **argv)
{
  keep_standard_streams();
  signal(SIGPIPE, SIG_IGN); /* a write that fails returns an error, which has a message */
  signal(SIGXFSZ, SIG_IGN);
  return message_finish_stdout(dispatch(argc, argv));
}
