/* Ctrl-C and SIGTERM: long work looks whether it should end. */
#ifndef TOOL_INTERRUPT_H
#define TOOL_INTERRUPT_H

/* Catch SIGINT and SIGTERM from now on; before there is a file to leave behind. */
void interrupt_catch(void);

/* Whether one has come; from any thread. */
int interrupt_seen(void);

#endif
