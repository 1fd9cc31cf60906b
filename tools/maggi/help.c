/* The manual of the command. */
#include <string.h>

#include "commands.h"

static const char help_general[] =
    "maggi - dynamics of multibody systems\n"
    "\n"
    "  maggi simulate MODEL [options]   simulate; write a CSV and a summary\n"
    "  maggi sensitivity MODEL [options]\n"
    "                                   gradients of objectives by parameters\n"
    "  maggi verify MODEL [options]     compare all methods for these gradients\n"
    "  maggi report RUN.csv ..          one page of tables and plots of one or more runs\n"
    "  maggi info MODEL [options]       bodies, loops, degrees of freedom, parameters\n"
    "  maggi equilibrium MODEL [options]\n"
    "                                   where a model stands still\n"
    "  maggi modes MODEL [options]      frequencies and damping of small motions there\n"
    "  maggi models [--json]            the models that ship\n"
    "  maggi tyre FILE.tir [options]    forces of a tyre at given slips\n"
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
    "  --objectives         values of the objectives that the model declares, by a second\n"
    "                       simulation\n"
    "  --report PAGE.html   the page of maggi report, with objectives; without --out the\n"
    "                       table, with energies, is kept no longer than that\n"
    "  --set PATH=VALUE ..  change parameters, listed by maggi info MODEL --parameters,\n"
    "                       and design parameters, by NAME=VALUE; PATH may be a glob\n"
    "  --formulation maggi  explicit, of order 4 (Runge-Kutta); loops closed to --tolerance\n"
    "  --formulation penalty\n"
    "                       implicit, of order 2 (trapezoidal rule); loops held by springs\n"
    "  --penalty ALPHA      their stiffness, N/m and N m; default 1e8\n"
    "  --jacobian WAY       derivatives of the forces for Newton's method: difference,\n"
    "                       difference-coloured, tangent, tangent-coloured (default) or\n"
    "                       adjoint\n"
    "  --tolerance TOL      on the loop equations, m and rad; default 1e-10.  With the\n"
    "                       penalty formulation Newton's method ends when no coordinate\n"
    "                       moves by more; default 1e-8\n"
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
    "  NAME.weighted                what each filter says\n"
    "  loops.pivot_ratio            near 0 at a singular position\n"
    "  loops.violation              largest error of a loop equation\n"
    "\n"
    "FILE appears, complete, when the simulation ends; if it fails there is none.\n"
    "After an interruption (Ctrl-C, SIGTERM) FILE has the rows so far.\n"
    "\n"
    "Beside it FILE.csv.json says what it is: format (maggi-run), version, maggi (its\n"
    "version), date, command, file and path of the model, set, every, run (the summary),\n"
    "columns (name and unit of each), model (all of maggi info, with the parameters of this\n"
    "run).  maggi report reads it; nothing else needs it.\n"
    "\n"
    "Summary: time is the time reached; evaluations are those of the steps, without the\n"
    "start; wall_s is the time spent stepping, without output; us_per_evaluation is their\n"
    "quotient.  min_pivot_ratio is the smallest pivot ratio, at the time min_pivot_time.\n"
    "energy_drift is the largest |T + V - W - (T0 + V0)|, T kinetic, V potential energy,\n"
    "W work, over |T0 + V0|, or over the largest T where |T0 + V0| is below 1e-6 of that.\n"
    "It is looked at after each step with --energy or --json, else at each row and at\n"
    "least every 64 steps.  formulation is maggi or penalty; with the latter follow penalty,\n"
    "newton_tolerance, newton_iterations, jacobian, jacobians (their number), nonzeros of one\n"
    "and colours of its columns (their number where the way has no colours); it makes no\n"
    "evaluations.\n";

#define HELP_STUDY                                                                                 \
  "  --objective NAME,..  what to differentiate: an objective that the model declares, or\n"       \
  "                       TYPE(SIGNAL), as in \"rms(tip.z)\", where SIGNAL is a column of\n"       \
  "                       maggi simulate --energy --reactions all (not energy.work and\n"          \
  "                       loops.*) and TYPE is integral, integral_square, mean,\n"                 \
  "                       mean_square, rms, rmq, vdv, norm, violation, maximum, minimum,\n"        \
  "                       peak or terminal.\n"

static const char help_sensitivity[] =
    "maggi sensitivity MODEL [options]\n"
    "\n"
    "Gradients of objectives J, numbers that come out of a simulation, with respect to\n"
    "design parameters b, numbers that go into it.\n"
    "\n" HELP_STUDY "                       Default: all that the model declares\n"
    "  --parameters ITEM,.. design parameters; default: those that the model declares,\n"
    "                       else all.  An ITEM is\n"
    "                         all    every number of the model, by its path\n"
    "                         GLOB   the declared ones it matches, else numbers by path\n"
    "                         NAME=[FACTOR*]PATH{+[FACTOR*]PATH}[:NOMINAL[:LOWER:UPPER[:UNIT]]]\n"
    "                                one that moves several numbers together, as in\n"
    "                                width=rods.a.point_a.y+-1*rods.b.point_a.y:0.5\n"
    "  --method METHOD      adjoint (default)   backwards through the steps: any number of\n"
    "                                           parameters for the price of a few\n"
    "                       direct              carried along with the simulation: the same\n"
    "                                           numbers, and the relevance of parameters\n"
    "                       continuous-adjoint  differs by the error of the integration\n"
    "                       difference, forward-difference, backward-difference\n"
    "                                           of whole simulations\n"
    "  --perturbation X     of differences, relative to b, absolute where b is 0;\n"
    "                       default 1e-6\n"
    "  --time T, --step H, --set PATH=VALUE .., --tolerance TOL, --formulation F,\n"
    "  --penalty ALPHA, --jacobian WAY\n"
    "                       as in maggi simulate; Newton's tolerance is 1e-12 at most\n"
    "  --snapshots N        adjoint: keep N states, compute the others again\n"
    "  --memory BYTES       for states, as 64M; default 1G.  Fewer snapshots where all do\n"
    "                       not fit.  The numbers are the same in any case\n"
    "  --threads N          share the parameters of direct and of differences out among\n"
    "                       N threads, with the same numbers; default 1\n"
    "  --states FILE.csv    direct: derivatives over time of all coordinates and of the\n"
    "                       signals of the objectives, columns d(SIGNAL)/d(PARAMETER)\n"
    "  --every N            a row of it every N steps; default 1\n"
    "  --csv FILE.csv       the tables of the report, all rows, columns objective, rank,\n"
    "                       parameter, nominal, unit, gradient, gradient_unit, normalised\n"
    "                       and, with direct, relevance, relevance_unit, coordinate\n"
    "  --plot FILE.png      bars of the largest normalised sensitivities\n"
    "  --all-rows           the report has all parameters, not only the first 35\n"
    "  --json               the report as one JSON object\n"
    "\n"
    "Report: parameters in the order of |b dJ/db|, with b/J dJ/db, the change of J in\n"
    "percent when b grows by one percent (b dJ/db where J is 0).  Where b is 0 there is no\n"
    "such number; these parameters follow, by |dJ/db|.  With direct also their relevance,\n"
    "the largest |dq/db| over time and the coordinate q that has it.  Then what it cost,\n"
    "beside one simulation; the best of a few runs where they are short.\n"
    "\n"
    "JSON: objective, value, unit, gradient, units, normalised (null: see above), ranking;\n"
    "for several objectives these are in a list, objectives.  Then nominal, relevance,\n"
    "method, formulation (and penalty, jacobian), parameters (their number), time, step,\n"
    "steps, recomputed (steps that the adjoint has computed again), kept (its snapshots),\n"
    "threads, wall_s, simulation_wall_s, ratio.\n"
    "\n"
    "Files appear, complete, at the end; - as FILE.csv is standard output, and the report\n"
    "then goes to standard error.  --plot needs python3 with matplotlib, and the script\n"
    "plot-sensitivity, which is looked for in $MAGGI_SCRIPTS, in scripts/ of the source\n"
    "tree and in share/maggi/scripts of the installation.\n";

static const char help_verify[] =
    "maggi verify MODEL [options]\n"
    "\n"
    "Computes gradients of a model by every method and compares each with each.\n"
    "Exit status 1 when one of them fails.\n"
    "\n" HELP_STUDY "                       Default: all that the model declares, else\n"
    "                       integral_square(Q.q), terminal(Q.v) and rms(energy.kinetic),\n"
    "                       where Q is the first coordinate that is not guided\n"
    "  --parameters ITEM,.. as in maggi sensitivity\n"
    "  --time T, --step H, --set PATH=VALUE .., --tolerance TOL\n"
    "                       as in maggi simulate\n"
    "  --limit X            on the error of direct; default 1e-10\n"
    "  --plot FILE.png      errors of differences over their perturbation\n"
    "  --json               the report as one JSON object\n"
    "\n"
    "An error is the largest difference of two gradients over the largest entry of the\n"
    "adjoint one, each entry times the size of its parameter: |b|, where b is 0 the largest\n"
    "|b| with its unit, else 1.  A gradient below 1e-6 |J| counts as 1e-6 |J|.  The report\n"
    "has the largest error of all objectives.\n"
    "\n"
    "  adjoint              what the others are compared with, by all parameters\n"
    "  adjoint, 10 snapshots\n"
    "                       the same to the last bit\n"
    "  direct               by the 24 most relevant parameters: within --limit\n"
    "  continuous-adjoint   differs by the truncation errors of both adjoints: no more than\n"
    "                       twice the way that both go when the step is halved, or --limit.\n"
    "                       That also shows at which order they approach each other\n"
    "  difference           by the 5 most relevant parameters, with perturbations 1e-2,\n"
    "                       1e-3 .. 1e-14: the best within 1e-6.  Large ones truncate,\n"
    "                       small ones drown in the round-off of whole simulations, so\n"
    "                       that differences cannot confirm more digits than that\n"
    "  forward-difference, backward-difference\n"
    "                       the same within 1e-4: they truncate more\n"
    "\n"
    "The column simulations is what each costs, for differences with one perturbation.  All\n"
    "together is some 400 simulations; a shorter --time proves as much.\n";

static const char help_report[] =
    "maggi report RUN.csv [RUN2.csv ..] [options]\n"
    "\n"
    "One page of HTML without anything outside of it: how the run was made, the model, the\n"
    "manoeuvre, key figures with their times, plots.  Several runs (laden and unladen, designs)\n"
    "are drawn over each other: the columns that all have.\n"
    "\n"
    "  --out PAGE.html      default RUN.html\n"
    "  --title TEXT         of the page; default: name of the model\n"
    "  --width B            of the vehicle, m, for the lanes of ISO 3888-1 that a double lane\n"
    "                       change is drawn in; default: over its tyres\n"
    "\n"
    "RUN.csv is written by maggi simulate --out.  What its columns are is read in RUN.csv.json\n"
    "beside it; without that the page has only what the names of the columns say.  Models with\n"
    "wheels are vehicles: their page has what their sensors (of any name) and their free joint\n"
    "give: path, speed, accelerations, roll, sideslip, slips and forces of tyres, load\n"
    "transfer, understeer, response to a step of the steering.  --energy, --reactions of\n"
    "maggi simulate add plots, its --objectives adds their values.\n"
    "\n"
    "PAGE.html appears, complete, or not at all.  Needs python3 with numpy, and the script\n"
    "report, which is looked for as that of maggi sensitivity --plot.\n";

static const char help_info[] =
    "maggi info MODEL [options]\n"
    "\n"
    "  --set PATH=VALUE ..  change parameters first\n"
    "  --parameters [GLOB]  only the parameters, those whose path matches GLOB (* ? [a-z]),\n"
    "                       as in maggi info four-bar --parameters '*.mass'\n"
    "  --json               as one JSON object\n"
    "\n"
    "Prints the bodies with their joints as a tree, the loops with kind and number of\n"
    "equations, rank, degrees of freedom, independent coordinates, sensors, filters and their\n"
    "states, objectives, design parameters, and the parameters with path, value and unit.  JSON "
    "also has what\n"
    "sensors look at, wheels, forces, roads, and the functions that guide coordinates.\n";

static const char help_equilibrium[] =
    "maggi equilibrium MODEL [options]\n"
    "\n"
    "  --set PATH=VALUE ..  change parameters, listed by maggi info MODEL --parameters\n"
    "  --json               as one JSON object\n"
    "\n"
    "Prints where a model stands still that says start: {equilibrium: true}: positions of\n"
    "coordinates, loads of wheels, lengths and forces of springs (tension positive), and\n"
    "how it was found: iterations of Newton's method, and steps of a damped run where the\n"
    "search began too far away.  Coordinates named in start: hold stay.\n";

static const char help_modes[] =
    "maggi modes MODEL [options]\n"
    "\n"
    "  --set PATH=VALUE ..  change parameters, listed by maggi info MODEL --parameters\n"
    "  --json               as one JSON object\n"
    "\n"
    "Prints the modes of small motions about the equilibrium of maggi equilibrium, slowest\n"
    "first: size of the eigenvalue and frequency of the damped motion, damping ratio, and the\n"
    "coordinate with the largest share of the kinetic energy; then the frequencies without\n"
    "dampers.  A ratio of 1 or -1 is a mode that does not oscillate.  Coordinates named in\n"
    "start: hold stay, wheels are vertical springs, and a damper with other slopes in\n"
    "rebound than in compression counts with their mean at rest.  Needs a build with GSL\n"
    "(MAGGI_WITH_GSL).\n";

static const char help_models[] =
    "maggi models [--json]\n"
    "\n"
    "Lists the models that ship, and those in the directory $MAGGI_MODELS, with the first\n"
    "sentence of their source.  A model NAME is the file NAME.yaml or NAME/NAME.yaml there.\n";

static const char help_tyre[] =
    "maggi tyre FILE.tir [options]\n"
    "\n"
    "Forces and moments of a tyre, PAC2002, steady state, as wheels of models have them.\n"
    "\n"
    "  --kappa K            longitudinal slip; default 0\n"
    "  --alpha A            slip angle, rad, positive: slides to the left; default 0\n"
    "  --gamma G            camber, rad, positive: leans to the right; default 0\n"
    "  --fz N               load; default LFZO FNOMIN\n"
    "  --vx V               speed, m/s; default LONGVL\n"
    "  --sweep NAME=FROM:TO:N\n"
    "                       N points with one of these moved, as --sweep alpha=-0.2:0.2:81\n"
    "  --file FILE.csv      points from a table with columns of these names, in any case of\n"
    "                       letters; other columns are passed over, options come first\n"
    "  --side SIDE          left or right; default TYRESIDE, mirrored on the other one\n"
    "  --out FILE.csv       write a table; - is standard output, where it goes without --out\n"
    "                       when there is --sweep or --file\n"
    "  --json               as one JSON object\n"
    "\n"
    "fx fy mx my mz are on the wheel, ISO-W: x forward, y left, z up, at the contact point.\n"
    "dfy_dalpha, dfx_dkappa: slopes at this point; utilisation: sqrt((fx / Dx)^2 + (fy / Dy)^2),\n"
    "D the peaks of pure slip at this load and camber.  Without load all are 0.\n";

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
  } page[] = {{"", help_general},
              {"simulate", help_simulate},
              {"sensitivity", help_sensitivity},
              {"verify", help_verify},
              {"report", help_report},
              {"info", help_info},
              {"models", help_models},
              {"tyre", help_tyre},
              {"help", help_help},
              {"version", help_version},
              {"equilibrium", help_equilibrium},
              {"modes", help_modes}};
  size_t i;

  for (i = 0; i < sizeof page / sizeof page[0]; ++i)
    if (strcmp(page[i].command, command) == 0) return page[i].text;
  return NULL;
}
