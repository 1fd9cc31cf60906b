/* The manual of the command. */
#include <string.h>

#include "commands.h"

static const char help_general[] =
    "maggi - dynamics of multibody systems\n"
    "\n"
    "  maggi simulate MODEL [options]   simulate; write a CSV and a summary\n"
    "  maggi info MODEL [options]       bodies, loops, degrees of freedom, parameters\n"
    "  maggi models [--json]            the models that ship\n"
    "  maggi help [COMMAND]             this, or all about one command\n"
    "  maggi version                    version of maggi\n"
    "\n"
    "MODEL is a YAML file, the name of a model that ships (maggi models), or\n"
    "multiple-four-bar:NYxNZ, e.g. multiple-four-bar:7x15.  A word without / and\n"
    "without .yaml is looked for in $MAGGI_MODELS, then among the models that ship,\n"
    "then in the present directory.\n"
    "\n"
    "Units are SI and radians.  Errors are one line on standard error.\n"
    "Exit status: 0 done; 1 a file, a model or a simulation failed; 2 wrong command\n"
    "line (an option, a number, a name that the model does not have); 130 interrupted.\n";

static const char help_simulate[] =
    "maggi simulate MODEL [options]\n"
    "\n"
    "  --time T             simulate T seconds; default from the model, else 1\n"
    "  --step H             in steps of H seconds; default from the model, else 0.001.\n"
    "                       When T is no multiple of H the last step is shorter: T is\n"
    "                       reached exactly\n"
    "  --out FILE.csv       write a table; - is standard output, and the summary then\n"
    "                       goes to standard error.  No --out, no table\n"
    "  --every N            a row at t = 0, every N steps, and at the end; default 1\n"
    "  --energy             columns of energies\n"
    "  --reactions BODY,..  columns of joint reactions of these bodies, or of all\n"
    "  --set PATH=VALUE ..  change parameters, listed by maggi info MODEL --parameters\n"
    "  --tolerance TOL      on the loop equations, m and rad; default 1e-10\n"
    "  --json               summary as one JSON object\n"
    "\n"
    "Columns, in this order:\n"
    "  t                            time\n"
    "  NAME.q, NAME.v, NAME.a       position, velocity, acceleration of each coordinate;\n"
    "                               NAME is its body, NAME.1, NAME.2 .. in compound joints\n"
    "  energy.kinetic, .potential, .total, .work\n"
    "                               total is kinetic + potential; work is that of dampers,\n"
    "                               loads and drives since t = 0\n"
    "  NAME.fx .. .fz, .mx .. .mz   force and moment that the parent exerts on the body,\n"
    "                               at the joint point, global axes\n"
    "  sensors                      as the model names them\n"
    "  loops.pivot_ratio            near 0 at a singular position\n"
    "  loops.violation              largest error of a loop equation\n"
    "\n"
    "FILE appears, complete, when the simulation ends; if it fails there is none.\n"
    "After an interruption (Ctrl-C, SIGTERM) FILE has the rows so far.\n"
    "\n"
    "Summary: time is the time reached; evaluations are those of the steps, without the\n"
    "start; wall_s is the time spent stepping, without output; us_per_evaluation is their\n"
    "quotient.  min_pivot_ratio is the smallest pivot ratio, at the time min_pivot_time.\n"
    "energy_drift is the largest |T + V - W - (T0 + V0)|, T kinetic, V potential energy,\n"
    "W work, over |T0 + V0|, or over the largest T where |T0 + V0| is below 1e-6 of that.\n"
    "It is looked at after each step with --energy or --json, else at each row and at\n"
    "least every 64 steps.\n";

static const char help_info[] =
    "maggi info MODEL [options]\n"
    "\n"
    "  --set PATH=VALUE ..  change parameters first\n"
    "  --parameters [GLOB]  only the parameters, those whose path matches GLOB (* ? [a-z]),\n"
    "                       as in maggi info four-bar --parameters '*.mass'\n"
    "  --json               as one JSON object\n"
    "\n"
    "Prints the bodies with their joints as a tree, the loops with kind and number of\n"
    "equations, rank, degrees of freedom, independent coordinates, sensors, and the\n"
    "parameters with path, value and unit.\n";

static const char help_models[] =
    "maggi models [--json]\n"
    "\n"
    "Lists the models that ship, and those in the directory $MAGGI_MODELS, with the first\n"
    "sentence of their source.  A model NAME is the file NAME.yaml or NAME/NAME.yaml there.\n";

static const char help_help[] = "maggi help [COMMAND]\n"
                                "\n"
                                "Prints what maggi can do, or all about one command.\n";

static const char help_version[] = "maggi version\n"
                                   "\n"
                                   "Prints the version of maggi.\n";

const char *help_text(const char *command)
{
  static const struct {
    const char *command;
    const char *text;
  } page[] = {{"", help_general},      {"simulate", help_simulate}, {"info", help_info},
              {"models", help_models}, {"help", help_help},         {"version", help_version}};
  size_t i;

  for (i = 0; i < sizeof page / sizeof page[0]; ++i)
    if (strcmp(page[i].command, command) == 0) return page[i].text;
  return NULL;
}
