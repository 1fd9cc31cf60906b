/* Scripts in the first directory that has them (places.h). */
#include "script.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "interrupt.h"
#include "message.h"
#include "places.h"

#define NOT_STARTED 127 /* as a shell has it: env does not find python3 */
#define NOTE        "note: "

extern char **environ;

const script script_plot = {"plot-sensitivity", "--plot: ", "matplotlib"};
const script script_report = {"report", "", "numpy"};

static int find(const script *s, char path[PLACES_PATH_MAX])
{
  char place[PLACES_PATH_MAX];
  const char *directory;
  int i, n;

  for (i = 0; i < PLACES; ++i) {
    directory = places_directory("scripts", i, place);
    n = snprintf(path, PLACES_PATH_MAX, "%s/%s", directory, s->name);
    if (directory[0] && n < PLACES_PATH_MAX && access(path, X_OK) == 0) return STATUS_DONE;
  }
  return message_fail(STATUS_FAILED,
                      "%sthe script %s is not there; MAGGI_SCRIPTS names its directory", s->where,
                      s->name);
}

/* Run argv with the given standard input and error, without output: exit status of the script, or -1. */
static int spawn(char *const argv[], FILE *input, FILE *error)
{
  posix_spawn_file_actions_t actions;
  pid_t pid;
  int failed, status = 0;

  if (posix_spawn_file_actions_init(&actions) != 0) return -1;
  failed = posix_spawn_file_actions_adddup2(&actions, fileno(error), STDERR_FILENO) ||
           posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  if (input)
    failed = failed || posix_spawn_file_actions_adddup2(&actions, fileno(input), STDIN_FILENO);
  failed = failed || posix_spawn(&pid, argv[0], &actions, NULL, argv, environ) != 0;
  posix_spawn_file_actions_destroy(&actions);
  if (failed) return -1;
  while (waitpid(pid, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* What a script that failed wrote last is why. */
static int fail(const script *s, FILE *error)
{
  char line[1000], last[1000] = "it failed";

  rewind(error);
  while (fgets(line, sizeof line, error)) {
    line[strcspn(line, "\n")] = '\0';
    if (line[0] != '\0') memcpy(last, line, sizeof last);
  }
  return message_fail(STATUS_FAILED, "%s%s", s->where, last);
}

static void pass_notes(FILE *error)
{
  char line[1000];

  rewind(error);
  while (fgets(line, sizeof line, error)) {
    line[strcspn(line, "\n")] = '\0';
    if (strncmp(line, NOTE, strlen(NOTE)) == 0) message_note("%s", line + strlen(NOTE));
  }
}

static int run(const script *s, char *const argv[], FILE *input)
{
  FILE *error = tmpfile();
  int status, result = STATUS_DONE;

  if (!error) return message_fail(STATUS_FAILED, "%s%s", s->where, strerror(errno));
  status = spawn(argv, input, error);
  if (status == 0)
    pass_notes(error);
  else if (interrupt_seen())
    result = STATUS_INTERRUPTED;
  else if (status == NOT_STARTED)
    result = message_fail(STATUS_FAILED, "%spython3 with %s is needed", s->where, s->needs);
  else
    result = fail(s, error);
  fclose(error);
  return result;
}

int script_check(const script *s, const char *out)
{
  char path[PLACES_PATH_MAX], check[] = "--check", option[] = "--out";
  char *argv[] = {path, check, option, (char *)out, NULL};
  int status = find(s, path);

  return status == STATUS_DONE ? run(s, argv, NULL) : status;
}

int script_run(const script *s, int n, const char *const *arguments)
{
  char path[PLACES_PATH_MAX];
  char **argv = calloc((size_t)n + 2, sizeof *argv);
  int i, status;

  if (!argv) return message_fail(STATUS_FAILED, "out of memory");
  status = find(s, path);
  argv[0] = path;
  for (i = 0; i < n; ++i) argv[i + 1] = (char *)arguments[i];
  if (status == STATUS_DONE) status = run(s, argv, NULL);
  free(argv);
  return status;
}

FILE *script_input(const script *s)
{
  FILE *input = tmpfile();

  if (!input) message_fail(STATUS_FAILED, "%s%s", s->where, strerror(errno));
  return input;
}

int script_draw(const script *s, FILE *input, const char *out)
{
  char path[PLACES_PATH_MAX], from[] = "-", option[] = "--out";
  char *argv[] = {path, from, option, (char *)out, NULL};
  int status = find(s, path);

  if (status == STATUS_DONE && (fflush(input) != 0 || ferror(input)))
    status = message_fail(STATUS_FAILED, "%s%s", s->where, strerror(errno));
  rewind(input);
  if (status == STATUS_DONE) status = run(s, argv, input);
  fclose(input);
  return status;
}
