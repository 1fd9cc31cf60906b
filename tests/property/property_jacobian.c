/* The ways to the Jacobian of the generalised forces of the open chain (core/implicit/jacobian.c)
 * on random mechanisms: tangents column by column, tangents by colours and adjoints agree to
 * round-off, differences as far as they can.
 *
 *   property_jacobian [--seed N] [--from N] [--count N] [--verbose]
 */
#include <stdio.h>

#include "jacobian_ways.h"
#include "report.h"
#include "subject.h"

static void check_seed(uint64_t seed, int verbose)
{
  static subject s;
  jacobian_findings f;

  if (!subject_create(seed, &s)) return;
  f = jacobian_ways_examine(s.data, 2, seed);
  report_count(mech_kind_text(s.m.kind));
  if (verbose)
    printf("seed %llu: %s: exact %.3g, difference %.3g\n", (unsigned long long)seed,
           mech_kind_text(s.m.kind), f.exact, f.difference);
  report_true(seed, "state and forces are as before", f.is_same);
  report_near(seed, "tangents by colours, adjoints", f.exact, 1e-13);
  report_near(seed, "differences", f.difference, 1e-6);
  subject_free(&s);
}

int main(int argc, char **argv)
{
  report_options options = {1, 700, 0};
  long i;

  if (!report_parse(argc, argv, &options)) return 2;
  for (i = 0; i < options.count; ++i) check_seed(options.from + (uint64_t)i, options.verbose);
  return report_done("property_jacobian");
}
