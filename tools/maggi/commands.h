/* The commands of maggi: argv[0] is the name of the command; each returns the exit status. */
#ifndef TOOL_COMMANDS_H
#define TOOL_COMMANDS_H

int command_simulate(int argc, char **argv);
int command_sensitivity(int argc, char **argv);
int command_verify(int argc, char **argv);
int command_info(int argc, char **argv);
int command_report(int argc, char **argv);
int command_models(int argc, char **argv);
int command_tyre(int argc, char **argv);

/* Help of a command; "" is the general one; NULL if there is no such command. */
const char *help_text(const char *command);

#endif
