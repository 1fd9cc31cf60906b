/* bench-derivatives [MODEL ..] [size] [factor] [--rounds N] [--time S] [--markdown] [--csv FILE] [--pattern FILE]
 *
 * The derivatives of forces that a simulation by the penalty formulation needs, in the ways of chapter 4 of the
 * thesis: J = [dQ/dz dQ/dz'] by differences, tangents, adjoints and ADOL-C, and whole simulations with them.  All
 * Jacobians are first compared; the program fails if they differ.  `size` is the cost of a step against the number
 * of bodies, `factor` that of dense factors against KLU.  Without names: all of it.
 *
 * Times are CPU time of this thread. */
#define _POSIX_C_SOURCE 200809L

#include <stdlib.h>
#include <string.h>

#include "apart.h"
#include "cases.h"
#include "penalty.h"
#include "suites.h"
#include "timing.h"

static const char *const names[] = {
#ifdef MAGGI_BENCH_YAML
    "spatial-four-bar",
#endif
    "multiple-four-bar:1x15",
    "multiple-four-bar:4x15",
    "multiple-four-bar:7x15",
    "multiple-four-bar:20x15",
    "multiple-four-bar:60x15",
    "size",
    "factor",
};
enum { NNAME = sizeof names / sizeof names[0] };
enum { ROUNDS = 7 };
static const double simulated = 5.0;

static void print_machine(const options *o)
{
  const char *bullet = o->markdown ? "- " : "";
  maggi_penalty_options p;
  char model[256];
  double mhz;
  int processors;

  maggi_penalty_options_init(&p);
  machine(sizeof model, model, &mhz, &processors);
  printf("%smachine   %s, %.0f MHz (measured: %.0f), %d processors\n", bullet, model, mhz,
         clock_mhz(), processors);
  printf("%scompiler  %s\n", bullet, MAGGI_BENCH_COMPILER);
  printf("%sflags     %s (kernel)\n", bullet, MAGGI_BENCH_FLAGS);
  printf("%sstrips    %d directions (MAGGI_DIRECTIONS)\n", bullet, MAGGI_NDIR);
  printf("%smaggi     %s\n", bullet, MAGGI_VERSION);
  printf("%spenalty   %g, tolerance %g, a Jacobian for every %d iterations; simulations of %g s\n",
         bullet, p.penalty, p.tolerance, p.reuse, o->time);
#ifdef BENCH_ADOLC
  printf("%sADOL-C    one tape, forward mode along all directions or our colours (its sparse_jac "
         "needs "
         "ColPack)\n",
         bullet);
#else
  printf("%sADOL-C is not here: apt-get install libadolc-dev, and configure again\n", bullet);
#endif
  printf("%sratios    to tangent-coloured, measured beside it; a simulation of fewer steps counts "
         "as one of "
         "all, by its Jacobians\n",
         bullet);
  printf("%sthesis    Table 4.5, gcc-2: Core i7 870 at 2.93 GHz.  difference: ND; tangent, "
         "tangent-coloured: "
         "ADIC2 forward, sparse; adjoint: ADOL-C reverse\n",
         bullet);
  printf("%sdrift     extreme of the change of energy over its size at the start, zero of heights "
         "at the "
         "ground; apart: largest distance of a coordinate from tangent-coloured at the end\n\n",
         bullet);
}

static int run(const void *of, const char *name)
{
  const options *o = of;
  if (strcmp(name, "size") == 0) return run_size(o);
  if (strcmp(name, "factor") == 0) return run_factor(o);
  return run_model(o, name);
}

static int usage(void)
{
  fprintf(stderr, "usage: bench-derivatives [MODEL ..] [size] [factor] [--rounds N] [--time S] "
                  "[--markdown] [--csv FILE] [--pattern FILE]\n");
  return 2;
}

static FILE *create(const char *name, const char *head)
{
  FILE *file = fopen(name, "w");

  if (file)
    fputs(head, file);
  else
    perror(name);
  return file;
}

int main(int argc, char **argv)
{
  options o = {0, ROUNDS, simulated, NULL, NULL};
  const char *chosen[NNAME];
  int i, n = 0, wrong = 0;

  for (i = 1; i < argc; ++i) {
    if (strcmp(argv[i], "--markdown") == 0) {
      o.markdown = 1;
    } else if (strcmp(argv[i], "--rounds") == 0 && i + 1 < argc) {
      o.rounds = atoi(argv[++i]);
      if (o.rounds < 1 || o.rounds > ROUNDS_MOST) return usage();
    } else if (strcmp(argv[i], "--time") == 0 && i + 1 < argc) {
      o.time = atof(argv[++i]);
      if (!(o.time >= 0.1 && o.time <= 1000.0)) return usage();
    } else if (strcmp(argv[i], "--csv") == 0 && i + 1 < argc && !o.csv) {
      if (!(o.csv = create(argv[++i], CSV_HEAD))) return 1;
    } else if (strcmp(argv[i], "--pattern") == 0 && i + 1 < argc && !o.pattern) {
      if (!(o.pattern = create(argv[++i], PATTERN_HEAD))) return 1;
    } else if (argv[i][0] != '-' && n < NNAME) {
      chosen[n++] = argv[i];
    } else {
      return usage();
    }
  }
  for (i = 0; n == 0 && i < NNAME; ++i) chosen[i] = names[i];
  if (n == 0) n = NNAME;
  print_machine(&o);
  for (i = 0; i < n; ++i) wrong = run_apart(run, &o, chosen[i]) || wrong;
  if (o.csv) wrong = fclose(o.csv) != 0 || wrong;
  if (o.pattern) wrong = fclose(o.pattern) != 0 || wrong;
  return wrong;
}
