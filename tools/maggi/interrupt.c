/* Signals that end the work in progress. */
#include "interrupt.h"

#include <signal.h>
#include <stdatomic.h>
#include <string.h>

static atomic_int seen; /* lock-free, and so also fit for a handler */

static void on_signal(int number)
{
  (void)number;
  atomic_store(&seen, 1);
}

void interrupt_catch(void)
{
  struct sigaction action;

  memset(&action, 0, sizeof action);
  action.sa_handler = on_signal; /* no SA_RESTART: a blocked write ends too */
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, NULL);
  sigaction(SIGTERM, &action, NULL);
}

int interrupt_seen(void)
{
  return atomic_load(&seen);
}
