/* What the command says on stderr, and the exit status that goes with it. */
#ifndef TOOL_MESSAGE_H
#define TOOL_MESSAGE_H

/* Exit status of the command. */
enum {
  STATUS_DONE = 0,
  STATUS_FAILED = 1,       /* a file, a model or a simulation failed */
  STATUS_USAGE = 2,        /* the command line is wrong              */
  STATUS_INTERRUPTED = 130 /* SIGINT or SIGTERM, as a shell has it   */
};

#if defined(__GNUC__)
#define MESSAGE_FORMAT(text, first) __attribute__((format(printf, text, first)))
#else
#define MESSAGE_FORMAT(text, first)
#endif

/* Print `maggi: ...` as exactly one line (control characters become ?), return status. */
int message_fail(int status, const char *format, ...) MESSAGE_FORMAT(2, 3);

/* Print `maggi: note: ...`; nothing has failed. */
void message_note(const char *format, ...) MESSAGE_FORMAT(1, 2);

/* Flush stdout: status, or STATUS_FAILED with a message when something could not be written. */
int message_finish_stdout(int status);

#endif
