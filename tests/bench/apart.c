#include "apart.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

int run_apart(int (*run)(const void *options, const char *name), const void *options,
              const char *name)
{
  int status = 1;
  pid_t child;

  fflush(NULL);
  child = fork();
  if (child == 0) {
    status = run(options, name);
    exit(fflush(NULL) != 0 || status);
  }
  return child < 0 || waitpid(child, &status, 0) != child || status != 0;
}
