/* Which entries the Jacobian of the generalised forces of the open chain has, by
 * core/implicit/pattern.c, on random mechanisms: those of the definition, element by element; none
 * outside is found by differences; and in space all of two joints that turn are found.
 *
 *   property_pattern [--seed N] [--from N] [--count N] [--verbose]
 */
#include <stdio.h>
#include <stdlib.h>

#include "open_chain.h"
#include "report.h"
#include "subject.h"

static int is_plane(mech_kind kind)
{
  return kind == MECH_PLANE || kind == MECH_PLANE_GUIDED || kind == MECH_PARALLELOGRAMS ||
         kind == MECH_PLATFORM;
}

static void check_seed(uint64_t seed, int verbose)
{
  static subject s;
  open_chain_findings f;

  if (!subject_create(seed, &s)) return;
  f = open_chain_examine(s.data, 2, seed);
  report_count(mech_kind_text(s.m.kind));
  if (verbose)
    printf("seed %llu: %s: %d coordinates, %d entries, %d vanish\n", (unsigned long long)seed,
           mech_kind_text(s.m.kind), f.n, f.entries, f.vanished);
  report_true(seed, "entries are those of the definition", f.wrong == 0);
  report_near(seed, "J outside the pattern", f.outside, 1e-11);
  if (!is_plane(s.m.kind))
    report_true(seed, "in space no entry of two joints that turn vanishes", f.vanished_turns == 0);
  if (f.vanished == 0) report_count("patterns without an entry that vanishes");
  subject_free(&s);
}

int main(int argc, char **argv)
{
  report_options options = {1, 1400, 0};
  long i;

  if (!report_parse(argc, argv, &options)) return 2;
  for (i = 0; i < options.count; ++i) check_seed(options.from + (uint64_t)i, options.verbose);
  return report_done("property_pattern");
}
